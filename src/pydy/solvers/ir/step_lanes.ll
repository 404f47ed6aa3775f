; sources ae34f60b13b99f2bf500459390aefbcdc0b1472e80c632083df9e950e73a7c57
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #0

define internal fastcc i32 @_set_inputs(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, ptr %5, i64 %6, i64 %7, ptr %8, i64 %9, i64 %10, ptr %11, i64 %12, ptr %13, i64 %14, i64 %15) unnamed_addr #1 {
  %17 = call i64 @llvm.smax.i64(i64 %6, i64 0)
  br label %18

18:                                               ; preds = %22, %16
  %19 = phi i64 [ 0, %16 ], [ %29, %22 ]
  %20 = phi i64 [ %17, %16 ], [ %28, %22 ]
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %27, label %26

22:                                               ; preds = %115, %27
  %23 = phi i64 [ 0, %27 ], [ %142, %115 ]
  %24 = phi i64 [ 8, %27 ], [ %143, %115 ]
  %25 = icmp sgt i64 %24, 0
  br i1 %25, label %30, label %18

26:                                               ; preds = %18
  store ptr null, ptr %0, align 8
  ret i32 0

27:                                               ; preds = %18
  %28 = add nsw i64 %20, -1
  %29 = add i64 %19, 1
  br label %22

30:                                               ; preds = %22
  %31 = icmp slt i64 %23, 0
  %32 = select i1 %31, i64 %2, i64 0
  %33 = getelementptr double, ptr %1, i64 %23
  %34 = getelementptr double, ptr %33, i64 %32
  %35 = load double, ptr %34, align 8
  %36 = icmp slt i64 %19, 0
  %37 = select i1 %36, i64 %9, i64 0
  %38 = add i64 %19, %37
  %39 = select i1 %31, i64 %10, i64 0
  %40 = mul i64 %38, %10
  %41 = getelementptr i64, ptr %8, i64 %40
  %42 = getelementptr i64, ptr %41, i64 %23
  %43 = getelementptr i64, ptr %42, i64 %39
  %44 = load i64, ptr %43, align 8
  %45 = select i1 %36, i64 %6, i64 0
  %46 = add i64 %19, %45
  %47 = mul i64 %46, %7
  %48 = getelementptr i64, ptr %5, i64 %47
  %49 = getelementptr i8, ptr %48, i64 8
  %50 = load i64, ptr %49, align 8, !noalias !0
  %51 = getelementptr i8, ptr %48, i64 16
  %52 = load i64, ptr %51, align 8, !noalias !0
  %53 = add nsw i64 %50, %52
  %54 = icmp slt i64 %50, 0
  %55 = select i1 %54, i64 %12, i64 0
  %56 = add i64 %50, %55
  %57 = icmp slt i64 %56, 0
  br i1 %57, label %72, label %73, !prof !4

58:                                               ; preds = %87, %84
  %59 = phi i64 [ %12, %87 ], [ %85, %84 ]
  %60 = sub i64 %59, %78
  %61 = call i64 @llvm.smax.i64(i64 %60, i64 0)
  %62 = getelementptr double, ptr %11, i64 %78
  %63 = load double, ptr %62, align 8, !noalias !0
  %64 = fcmp ogt double %63, %35
  %65 = select i1 %64, double %63, double %35
  %66 = icmp slt i64 %44, 0
  %67 = select i1 %66, i64 %61, i64 0
  %68 = getelementptr double, ptr %62, i64 %44
  %69 = getelementptr double, ptr %68, i64 %67
  %70 = load double, ptr %69, align 8, !noalias !5
  %71 = fcmp ugt double %70, %65
  br i1 %71, label %98, label %88

72:                                               ; preds = %30
  br label %73

73:                                               ; preds = %72, %30
  %74 = phi i64 [ 0, %72 ], [ %56, %30 ]
  %75 = icmp slt i64 %56, %12
  br i1 %75, label %77, label %76, !prof !8

76:                                               ; preds = %73
  br label %77

77:                                               ; preds = %76, %73
  %78 = phi i64 [ %12, %76 ], [ %74, %73 ]
  %79 = icmp slt i64 %53, 0
  %80 = select i1 %79, i64 %12, i64 0
  %81 = add i64 %53, %80
  %82 = icmp slt i64 %81, 0
  br i1 %82, label %83, label %84, !prof !4

83:                                               ; preds = %77
  br label %84

84:                                               ; preds = %83, %77
  %85 = phi i64 [ 0, %83 ], [ %81, %77 ]
  %86 = icmp slt i64 %81, %12
  br i1 %86, label %58, label %87, !prof !8

87:                                               ; preds = %84
  br label %58

88:                                               ; preds = %58
  %89 = add nsw i64 %61, -1
  %90 = icmp eq i64 %44, %89
  br i1 %90, label %115, label %91

91:                                               ; preds = %88
  %92 = icmp slt i64 %44, -1
  %93 = select i1 %92, i64 %61, i64 0
  %94 = getelementptr i8, ptr %68, i64 8
  %95 = getelementptr double, ptr %94, i64 %93
  %96 = load double, ptr %95, align 8, !noalias !5
  %97 = fcmp olt double %65, %96
  br i1 %97, label %115, label %98

98:                                               ; preds = %91, %58
  %99 = icmp sgt i64 %60, 1
  br i1 %99, label %100, label %115

100:                                              ; preds = %100, %98
  %101 = phi i64 [ %111, %100 ], [ %61, %98 ]
  %102 = phi i64 [ %112, %100 ], [ 0, %98 ]
  %103 = add nsw i64 %102, %101
  %104 = ashr i64 %103, 1
  %105 = icmp slt i64 %104, 0
  %106 = select i1 %105, i64 %61, i64 0
  %107 = getelementptr double, ptr %62, i64 %104
  %108 = getelementptr double, ptr %107, i64 %106
  %109 = load double, ptr %108, align 8, !noalias !5
  %110 = fcmp ole double %109, %65
  %111 = select i1 %110, i64 %101, i64 %104
  %112 = select i1 %110, i64 %104, i64 %102
  %113 = sub nsw i64 %111, %112
  %114 = icmp sgt i64 %113, 1
  br i1 %114, label %100, label %115

115:                                              ; preds = %100, %98, %91, %88
  %116 = phi i64 [ %44, %88 ], [ %44, %91 ], [ %112, %100 ], [ 0, %98 ]
  %117 = icmp slt i64 %116, 0
  %118 = select i1 %117, i64 %61, i64 0
  %119 = getelementptr double, ptr %62, i64 %116
  %120 = getelementptr double, ptr %119, i64 %118
  %121 = load double, ptr %120, align 8, !noalias !0
  %122 = fsub double %65, %121
  %123 = add nsw i64 %50, %116
  %124 = icmp slt i64 %123, 0
  %125 = select i1 %124, i64 %14, i64 0
  %126 = add i64 %123, %125
  %127 = mul i64 %126, %15
  %128 = getelementptr double, ptr %13, i64 %127
  %129 = load double, ptr %128, align 8, !noalias !0
  %130 = getelementptr i8, ptr %128, i64 8
  %131 = load double, ptr %130, align 8, !noalias !0
  %132 = getelementptr i8, ptr %128, i64 16
  %133 = load double, ptr %132, align 8, !noalias !0
  %134 = getelementptr i8, ptr %128, i64 24
  %135 = load double, ptr %134, align 8, !noalias !0
  %136 = fmul double %122, %135
  %137 = fadd double %133, %136
  %138 = fmul double %122, %137
  %139 = fadd double %131, %138
  %140 = fmul double %122, %139
  %141 = fadd double %129, %140
  %142 = add i64 %23, 1
  %143 = add nsw i64 %24, -1
  store i64 %116, ptr %43, align 8
  %144 = load i64, ptr %48, align 8
  %145 = shl nsw i64 %144, 3
  %146 = add nsw i64 %145, %23
  %147 = icmp slt i64 %146, 0
  %148 = select i1 %147, i64 %4, i64 0
  %149 = getelementptr double, ptr %3, i64 %146
  %150 = getelementptr double, ptr %149, i64 %148
  store double %141, ptr %150, align 8
  br label %22
}

define internal fastcc i32 @norm(ptr noalias %0, ptr %1, ptr %2, ptr %3, ptr %4, i64 %5, ptr %6, i64 %7, i64 %8) unnamed_addr #1 {
  %10 = call i64 @llvm.smax.i64(i64 %8, i64 0)
  br label %11

11:                                               ; preds = %22, %9
  %12 = phi i64 [ 0, %9 ], [ %24, %22 ]
  %13 = phi i64 [ %10, %9 ], [ %23, %22 ]
  %14 = phi <8 x double> [ zeroinitializer, %9 ], [ %53, %22 ]
  %15 = icmp sgt i64 %13, 0
  br i1 %15, label %22, label %16

16:                                               ; preds = %11
  %17 = sitofp i64 %8 to double
  %18 = insertelement <8 x double> poison, double %17, i64 0
  %19 = shufflevector <8 x double> %18, <8 x double> poison, <8 x i32> zeroinitializer
  %20 = fdiv <8 x double> %14, %19
  %21 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %20)
  store <8 x double> %21, ptr %0, align 64
  ret i32 0

22:                                               ; preds = %11
  %23 = add nsw i64 %13, -1
  %24 = add i64 %12, 1
  %25 = shl i64 %12, 6
  %26 = getelementptr i8, ptr %1, i64 %25
  %27 = load <8 x double>, ptr %26, align 8
  %28 = getelementptr i8, ptr %3, i64 %25
  %29 = load <8 x double>, ptr %28, align 8
  %30 = getelementptr i8, ptr %2, i64 %25
  %31 = load <8 x double>, ptr %30, align 8
  %32 = icmp slt i64 %12, 0
  %33 = select i1 %32, i64 %7, i64 0
  %34 = getelementptr double, ptr %6, i64 %12
  %35 = getelementptr double, ptr %34, i64 %33
  %36 = load double, ptr %35, align 8, !noalias !9
  %37 = select i1 %32, i64 %5, i64 0
  %38 = getelementptr double, ptr %4, i64 %12
  %39 = getelementptr double, ptr %38, i64 %37
  %40 = load double, ptr %39, align 8, !noalias !9
  %41 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %29)
  %42 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %31)
  %43 = fcmp ogt <8 x double> %41, %42
  %44 = select <8 x i1> %43, <8 x double> %41, <8 x double> %42
  %45 = insertelement <8 x double> poison, double %40, i64 0
  %46 = shufflevector <8 x double> %45, <8 x double> poison, <8 x i32> zeroinitializer
  %47 = fmul <8 x double> %46, %44
  %48 = insertelement <8 x double> poison, double %36, i64 0
  %49 = shufflevector <8 x double> %48, <8 x double> poison, <8 x i32> zeroinitializer
  %50 = fadd <8 x double> %49, %47
  %51 = fdiv <8 x double> %27, %50
  %52 = fmul <8 x double> %51, %51
  %53 = fadd <8 x double> %14, %52
  br label %11
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #0

declare <8 x double> @llvm.rint.v8f64(<8 x double>) #0

declare i64 @llvm.cttz.i64(i64, i1 immarg) #2

declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #0

declare <8 x double> @llvm.ceil.v8f64(<8 x double>) #0

define internal fastcc void @pydy_combine(i64 %0, i64 %1, i64 %2, i64 %3, i64 %4, i64 %5, i64 %6, i64 %7, i64 %8) unnamed_addr #1 {
  %10 = inttoptr i64 %2 to ptr
  %11 = load <8 x double>, ptr %10, align 8
  %12 = inttoptr i64 %4 to ptr
  %13 = inttoptr i64 %5 to ptr
  %14 = lshr i64 %8, 2
  %15 = and i64 %8, 2305843009213693948
  %16 = shl i64 %6, 3
  %17 = getelementptr i8, ptr %12, i64 %16
  %18 = getelementptr i8, ptr %13, i64 %16
  br label %19

19:                                               ; preds = %104, %9
  %20 = phi i64 [ 0, %9 ], [ %110, %104 ]
  %21 = icmp samesign ult i64 %20, %14
  br i1 %21, label %22, label %27

22:                                               ; preds = %19
  %23 = shl i64 %20, 5
  %24 = or disjoint i64 %23, 8
  %25 = or disjoint i64 %23, 16
  %26 = or disjoint i64 %23, 24
  br label %29

27:                                               ; preds = %19
  %28 = and i64 %8, 3
  br label %111

29:                                               ; preds = %36, %22
  %30 = phi <8 x double> [ zeroinitializer, %22 ], [ %48, %36 ]
  %31 = phi <8 x double> [ zeroinitializer, %22 ], [ %51, %36 ]
  %32 = phi <8 x double> [ zeroinitializer, %22 ], [ %54, %36 ]
  %33 = phi <8 x double> [ zeroinitializer, %22 ], [ %57, %36 ]
  %34 = phi i64 [ 0, %22 ], [ %58, %36 ]
  %35 = icmp slt i64 %34, %6
  br i1 %35, label %36, label %59

36:                                               ; preds = %29
  %37 = inttoptr i64 %3 to ptr
  %38 = shl i64 %34, 3
  %39 = getelementptr i8, ptr %13, i64 %38
  %40 = load double, ptr %39, align 8
  %41 = insertelement <8 x double> poison, double %40, i64 0
  %42 = shufflevector <8 x double> %41, <8 x double> poison, <8 x i32> zeroinitializer
  %43 = getelementptr i8, ptr %12, i64 %38
  %44 = load i64, ptr %43, align 8
  %45 = getelementptr double, ptr %37, i64 %44
  %46 = getelementptr double, ptr %45, i64 %23
  %47 = load <8 x double>, ptr %46, align 8
  %48 = call <8 x double> @llvm.fma.v8f64(<8 x double> %42, <8 x double> %47, <8 x double> %30)
  %49 = getelementptr i8, ptr %46, i64 64
  %50 = load <8 x double>, ptr %49, align 8
  %51 = call <8 x double> @llvm.fma.v8f64(<8 x double> %42, <8 x double> %50, <8 x double> %31)
  %52 = getelementptr i8, ptr %46, i64 128
  %53 = load <8 x double>, ptr %52, align 8
  %54 = call <8 x double> @llvm.fma.v8f64(<8 x double> %42, <8 x double> %53, <8 x double> %32)
  %55 = getelementptr i8, ptr %46, i64 192
  %56 = load <8 x double>, ptr %55, align 8
  %57 = call <8 x double> @llvm.fma.v8f64(<8 x double> %42, <8 x double> %56, <8 x double> %33)
  %58 = add nuw nsw i64 %34, 1
  br label %29

59:                                               ; preds = %29
  %60 = inttoptr i64 %1 to ptr
  %61 = getelementptr double, ptr %60, i64 %23
  %62 = load <8 x double>, ptr %61, align 8
  %63 = call <8 x double> @llvm.fma.v8f64(<8 x double> %11, <8 x double> %30, <8 x double> %62)
  %64 = getelementptr double, ptr %60, i64 %24
  %65 = load <8 x double>, ptr %64, align 8
  %66 = call <8 x double> @llvm.fma.v8f64(<8 x double> %11, <8 x double> %31, <8 x double> %65)
  %67 = getelementptr double, ptr %60, i64 %25
  %68 = load <8 x double>, ptr %67, align 8
  %69 = call <8 x double> @llvm.fma.v8f64(<8 x double> %11, <8 x double> %32, <8 x double> %68)
  %70 = getelementptr double, ptr %60, i64 %26
  %71 = load <8 x double>, ptr %70, align 8
  %72 = call <8 x double> @llvm.fma.v8f64(<8 x double> %11, <8 x double> %33, <8 x double> %71)
  br label %73

73:                                               ; preds = %80, %59
  %74 = phi <8 x double> [ %63, %59 ], [ %93, %80 ]
  %75 = phi <8 x double> [ %66, %59 ], [ %96, %80 ]
  %76 = phi <8 x double> [ %69, %59 ], [ %99, %80 ]
  %77 = phi <8 x double> [ %72, %59 ], [ %102, %80 ]
  %78 = phi i64 [ 0, %59 ], [ %103, %80 ]
  %79 = icmp slt i64 %78, %7
  br i1 %79, label %80, label %104

80:                                               ; preds = %73
  %81 = inttoptr i64 %3 to ptr
  %82 = shl i64 %78, 3
  %83 = getelementptr i8, ptr %18, i64 %82
  %84 = load double, ptr %83, align 8
  %85 = insertelement <8 x double> poison, double %84, i64 0
  %86 = shufflevector <8 x double> %85, <8 x double> poison, <8 x i32> zeroinitializer
  %87 = fmul <8 x double> %11, %86
  %88 = getelementptr i8, ptr %17, i64 %82
  %89 = load i64, ptr %88, align 8
  %90 = getelementptr double, ptr %81, i64 %89
  %91 = getelementptr double, ptr %90, i64 %23
  %92 = load <8 x double>, ptr %91, align 8
  %93 = call <8 x double> @llvm.fma.v8f64(<8 x double> %87, <8 x double> %92, <8 x double> %74)
  %94 = getelementptr i8, ptr %91, i64 64
  %95 = load <8 x double>, ptr %94, align 8
  %96 = call <8 x double> @llvm.fma.v8f64(<8 x double> %87, <8 x double> %95, <8 x double> %75)
  %97 = getelementptr i8, ptr %91, i64 128
  %98 = load <8 x double>, ptr %97, align 8
  %99 = call <8 x double> @llvm.fma.v8f64(<8 x double> %87, <8 x double> %98, <8 x double> %76)
  %100 = getelementptr i8, ptr %91, i64 192
  %101 = load <8 x double>, ptr %100, align 8
  %102 = call <8 x double> @llvm.fma.v8f64(<8 x double> %87, <8 x double> %101, <8 x double> %77)
  %103 = add nuw nsw i64 %78, 1
  br label %73

104:                                              ; preds = %73
  %105 = inttoptr i64 %0 to ptr
  %106 = getelementptr double, ptr %105, i64 %23
  store <8 x double> %74, ptr %106, align 8
  %107 = getelementptr double, ptr %105, i64 %24
  store <8 x double> %75, ptr %107, align 8
  %108 = getelementptr double, ptr %105, i64 %25
  store <8 x double> %76, ptr %108, align 8
  %109 = getelementptr double, ptr %105, i64 %26
  store <8 x double> %77, ptr %109, align 8
  %110 = add nuw nsw i64 %20, 1
  br label %19

111:                                              ; preds = %160, %27
  %112 = phi i64 [ 0, %27 ], [ %163, %160 ]
  %113 = icmp samesign ult i64 %112, %28
  br i1 %113, label %114, label %117

114:                                              ; preds = %111
  %115 = add nuw i64 %15, %112
  %116 = shl i64 %115, 3
  br label %118

117:                                              ; preds = %111
  ret void

118:                                              ; preds = %122, %114
  %119 = phi <8 x double> [ zeroinitializer, %114 ], [ %134, %122 ]
  %120 = phi i64 [ 0, %114 ], [ %135, %122 ]
  %121 = icmp slt i64 %120, %6
  br i1 %121, label %122, label %136

122:                                              ; preds = %118
  %123 = inttoptr i64 %3 to ptr
  %124 = shl i64 %120, 3
  %125 = getelementptr i8, ptr %13, i64 %124
  %126 = load double, ptr %125, align 8
  %127 = insertelement <8 x double> poison, double %126, i64 0
  %128 = shufflevector <8 x double> %127, <8 x double> poison, <8 x i32> zeroinitializer
  %129 = getelementptr i8, ptr %12, i64 %124
  %130 = load i64, ptr %129, align 8
  %131 = getelementptr double, ptr %123, i64 %130
  %132 = getelementptr double, ptr %131, i64 %116
  %133 = load <8 x double>, ptr %132, align 8
  %134 = call <8 x double> @llvm.fma.v8f64(<8 x double> %128, <8 x double> %133, <8 x double> %119)
  %135 = add nuw nsw i64 %120, 1
  br label %118

136:                                              ; preds = %118
  %137 = inttoptr i64 %1 to ptr
  %138 = getelementptr double, ptr %137, i64 %116
  %139 = load <8 x double>, ptr %138, align 8
  %140 = call <8 x double> @llvm.fma.v8f64(<8 x double> %11, <8 x double> %119, <8 x double> %139)
  br label %141

141:                                              ; preds = %145, %136
  %142 = phi <8 x double> [ %140, %136 ], [ %158, %145 ]
  %143 = phi i64 [ 0, %136 ], [ %159, %145 ]
  %144 = icmp slt i64 %143, %7
  br i1 %144, label %145, label %160

145:                                              ; preds = %141
  %146 = inttoptr i64 %3 to ptr
  %147 = shl i64 %143, 3
  %148 = getelementptr i8, ptr %18, i64 %147
  %149 = load double, ptr %148, align 8
  %150 = insertelement <8 x double> poison, double %149, i64 0
  %151 = shufflevector <8 x double> %150, <8 x double> poison, <8 x i32> zeroinitializer
  %152 = fmul <8 x double> %11, %151
  %153 = getelementptr i8, ptr %17, i64 %147
  %154 = load i64, ptr %153, align 8
  %155 = getelementptr double, ptr %146, i64 %154
  %156 = getelementptr double, ptr %155, i64 %116
  %157 = load <8 x double>, ptr %156, align 8
  %158 = call <8 x double> @llvm.fma.v8f64(<8 x double> %152, <8 x double> %157, <8 x double> %142)
  %159 = add nuw nsw i64 %143, 1
  br label %141

160:                                              ; preds = %141
  %161 = inttoptr i64 %0 to ptr
  %162 = getelementptr double, ptr %161, i64 %116
  store <8 x double> %142, ptr %162, align 8
  %163 = add nuw nsw i64 %112, 1
  br label %111
}

define internal fastcc void @pydy_nested(i64 %0, i64 %1, i64 %2, i64 %3, i64 %4, i64 %5, i64 %6) unnamed_addr #1 {
  %8 = inttoptr i64 %5 to ptr
  %9 = load <8 x double>, ptr %8, align 8
  %10 = fsub <8 x double> splat (double 1.000000e+00), %9
  %11 = inttoptr i64 %2 to ptr
  %12 = lshr i64 %6, 2
  %13 = and i64 %6, 2305843009213693948
  %14 = add i64 %4, -2
  %15 = mul i64 %3, %14
  %16 = shl i64 %15, 3
  %17 = getelementptr i8, ptr %11, i64 %16
  %18 = getelementptr i8, ptr %17, i64 192
  %19 = mul i64 %3, -8
  br label %20

20:                                               ; preds = %67, %7
  %21 = phi ptr [ %90, %67 ], [ %18, %7 ]
  %22 = phi i64 [ %89, %67 ], [ 0, %7 ]
  %23 = icmp samesign ult i64 %22, %12
  br i1 %23, label %24, label %37

24:                                               ; preds = %20
  %25 = shl i64 %22, 5
  %26 = add i64 %4, -1
  %27 = mul i64 %26, %3
  %28 = getelementptr double, ptr %11, i64 %27
  %29 = getelementptr double, ptr %28, i64 %25
  %30 = load <8 x double>, ptr %29, align 8
  %31 = getelementptr i8, ptr %29, i64 64
  %32 = load <8 x double>, ptr %31, align 8
  %33 = getelementptr i8, ptr %29, i64 128
  %34 = load <8 x double>, ptr %33, align 8
  %35 = getelementptr i8, ptr %29, i64 192
  %36 = load <8 x double>, ptr %35, align 8
  br label %41

37:                                               ; preds = %20
  %38 = and i64 %6, 3
  %39 = shl i64 %12, 8
  %40 = getelementptr i8, ptr %17, i64 %39
  br label %91

41:                                               ; preds = %50, %24
  %42 = phi <8 x double> [ %30, %24 ], [ %55, %50 ]
  %43 = phi <8 x double> [ %32, %24 ], [ %58, %50 ]
  %44 = phi <8 x double> [ %34, %24 ], [ %61, %50 ]
  %45 = phi <8 x double> [ %36, %24 ], [ %63, %50 ]
  %46 = phi i64 [ %14, %24 ], [ %66, %50 ]
  %47 = phi ptr [ %21, %24 ], [ %65, %50 ]
  %48 = phi i64 [ 0, %24 ], [ %64, %50 ]
  %49 = icmp slt i64 %48, %26
  br i1 %49, label %50, label %67

50:                                               ; preds = %41
  %51 = trunc i64 %46 to i1
  %52 = select i1 %51, <8 x double> %9, <8 x double> %10
  %53 = getelementptr i8, ptr %47, i64 -192
  %54 = load <8 x double>, ptr %53, align 8
  %55 = call <8 x double> @llvm.fma.v8f64(<8 x double> %52, <8 x double> %42, <8 x double> %54)
  %56 = getelementptr i8, ptr %47, i64 -128
  %57 = load <8 x double>, ptr %56, align 8
  %58 = call <8 x double> @llvm.fma.v8f64(<8 x double> %52, <8 x double> %43, <8 x double> %57)
  %59 = getelementptr i8, ptr %47, i64 -64
  %60 = load <8 x double>, ptr %59, align 8
  %61 = call <8 x double> @llvm.fma.v8f64(<8 x double> %52, <8 x double> %44, <8 x double> %60)
  %62 = load <8 x double>, ptr %47, align 8
  %63 = call <8 x double> @llvm.fma.v8f64(<8 x double> %52, <8 x double> %45, <8 x double> %62)
  %64 = add nuw nsw i64 %48, 1
  %65 = getelementptr i8, ptr %47, i64 %19
  %66 = add i64 %46, -1
  br label %41

67:                                               ; preds = %41
  %68 = inttoptr i64 %1 to ptr
  %69 = getelementptr double, ptr %68, i64 %25
  %70 = load <8 x double>, ptr %69, align 8
  %71 = call <8 x double> @llvm.fma.v8f64(<8 x double> %9, <8 x double> %42, <8 x double> %70)
  %72 = inttoptr i64 %0 to ptr
  %73 = getelementptr double, ptr %72, i64 %25
  store <8 x double> %71, ptr %73, align 8
  %74 = or disjoint i64 %25, 8
  %75 = getelementptr double, ptr %68, i64 %74
  %76 = load <8 x double>, ptr %75, align 8
  %77 = call <8 x double> @llvm.fma.v8f64(<8 x double> %9, <8 x double> %43, <8 x double> %76)
  %78 = getelementptr double, ptr %72, i64 %74
  store <8 x double> %77, ptr %78, align 8
  %79 = or disjoint i64 %25, 16
  %80 = getelementptr double, ptr %68, i64 %79
  %81 = load <8 x double>, ptr %80, align 8
  %82 = call <8 x double> @llvm.fma.v8f64(<8 x double> %9, <8 x double> %44, <8 x double> %81)
  %83 = getelementptr double, ptr %72, i64 %79
  store <8 x double> %82, ptr %83, align 8
  %84 = or disjoint i64 %25, 24
  %85 = getelementptr double, ptr %68, i64 %84
  %86 = load <8 x double>, ptr %85, align 8
  %87 = call <8 x double> @llvm.fma.v8f64(<8 x double> %9, <8 x double> %45, <8 x double> %86)
  %88 = getelementptr double, ptr %72, i64 %84
  store <8 x double> %87, ptr %88, align 8
  %89 = add nuw nsw i64 %22, 1
  %90 = getelementptr i8, ptr %21, i64 256
  br label %20

91:                                               ; preds = %118, %37
  %92 = phi ptr [ %126, %118 ], [ %40, %37 ]
  %93 = phi i64 [ %125, %118 ], [ 0, %37 ]
  %94 = icmp samesign ult i64 %93, %38
  br i1 %94, label %95, label %103

95:                                               ; preds = %91
  %96 = add nuw i64 %13, %93
  %97 = shl i64 %96, 3
  %98 = add i64 %4, -1
  %99 = mul i64 %98, %3
  %100 = getelementptr double, ptr %11, i64 %99
  %101 = getelementptr double, ptr %100, i64 %97
  %102 = load <8 x double>, ptr %101, align 8
  br label %104

103:                                              ; preds = %91
  ret void

104:                                              ; preds = %110, %95
  %105 = phi <8 x double> [ %102, %95 ], [ %114, %110 ]
  %106 = phi i64 [ %14, %95 ], [ %117, %110 ]
  %107 = phi ptr [ %92, %95 ], [ %116, %110 ]
  %108 = phi i64 [ 0, %95 ], [ %115, %110 ]
  %109 = icmp slt i64 %108, %98
  br i1 %109, label %110, label %118

110:                                              ; preds = %104
  %111 = trunc i64 %106 to i1
  %112 = select i1 %111, <8 x double> %9, <8 x double> %10
  %113 = load <8 x double>, ptr %107, align 8
  %114 = call <8 x double> @llvm.fma.v8f64(<8 x double> %112, <8 x double> %105, <8 x double> %113)
  %115 = add nuw nsw i64 %108, 1
  %116 = getelementptr i8, ptr %107, i64 %19
  %117 = add i64 %106, -1
  br label %104

118:                                              ; preds = %104
  %119 = inttoptr i64 %1 to ptr
  %120 = getelementptr double, ptr %119, i64 %97
  %121 = load <8 x double>, ptr %120, align 8
  %122 = call <8 x double> @llvm.fma.v8f64(<8 x double> %9, <8 x double> %105, <8 x double> %121)
  %123 = inttoptr i64 %0 to ptr
  %124 = getelementptr double, ptr %123, i64 %97
  store <8 x double> %122, ptr %124, align 8
  %125 = add nuw nsw i64 %93, 1
  %126 = getelementptr i8, ptr %92, i64 64
  br label %91
}

define i64 @step_lanes(i64 %0) local_unnamed_addr #3 {
  %2 = alloca ptr, align 8
  %3 = alloca ptr, align 8
  %4 = alloca ptr, align 8
  %5 = alloca ptr, align 8
  %6 = alloca ptr, align 8
  %7 = alloca ptr, align 8
  %8 = alloca ptr, align 8
  %9 = alloca ptr, align 8
  %10 = alloca <8 x double>, align 64
  %11 = alloca ptr, align 8
  %12 = alloca ptr, align 8
  %13 = alloca <8 x double>, align 64
  %14 = alloca <8 x double>, align 64
  %15 = alloca ptr, align 8
  %16 = alloca ptr, align 8
  %17 = inttoptr i64 %0 to ptr
  %18 = load i64, ptr %17, align 8, !noalias !12
  %19 = inttoptr i64 %18 to ptr
  %20 = getelementptr i8, ptr %17, i64 24
  %21 = load i64, ptr %20, align 8, !noalias !12
  %22 = getelementptr i8, ptr %17, i64 32
  %23 = load i64, ptr %22, align 8, !noalias !12
  %24 = inttoptr i64 %21 to ptr
  %25 = getelementptr i8, ptr %17, i64 48
  %26 = load i64, ptr %25, align 8, !noalias !12
  %27 = getelementptr i8, ptr %17, i64 72
  %28 = load i64, ptr %27, align 8, !noalias !12
  %29 = getelementptr i8, ptr %17, i64 96
  %30 = load i64, ptr %29, align 8, !noalias !12
  %31 = getelementptr i8, ptr %17, i64 104
  %32 = load i64, ptr %31, align 8, !noalias !12
  %33 = inttoptr i64 %30 to ptr
  %34 = getelementptr i8, ptr %17, i64 120
  %35 = load i64, ptr %34, align 8, !noalias !12
  %36 = inttoptr i64 %35 to ptr
  %37 = getelementptr i8, ptr %17, i64 144
  %38 = load i64, ptr %37, align 8, !noalias !12
  %39 = inttoptr i64 %38 to ptr
  %40 = getelementptr i8, ptr %17, i64 168
  %41 = load i64, ptr %40, align 8, !noalias !12
  %42 = getelementptr i8, ptr %17, i64 176
  %43 = load i64, ptr %42, align 8, !noalias !12
  %44 = inttoptr i64 %41 to ptr
  %45 = getelementptr i8, ptr %17, i64 192
  %46 = load i64, ptr %45, align 8, !noalias !12
  %47 = getelementptr i8, ptr %17, i64 200
  %48 = load i64, ptr %47, align 8, !noalias !12
  %49 = inttoptr i64 %46 to ptr
  %50 = getelementptr i8, ptr %17, i64 216
  %51 = load i64, ptr %50, align 8, !noalias !12
  %52 = getelementptr i8, ptr %17, i64 224
  %53 = load i64, ptr %52, align 8, !noalias !12
  %54 = inttoptr i64 %51 to ptr
  %55 = getelementptr i8, ptr %17, i64 240
  %56 = load i64, ptr %55, align 8, !noalias !12
  %57 = inttoptr i64 %56 to ptr
  %58 = getelementptr i8, ptr %17, i64 264
  %59 = load i64, ptr %58, align 8, !noalias !12
  %60 = getelementptr i8, ptr %17, i64 272
  %61 = load i64, ptr %60, align 8, !noalias !12
  %62 = getelementptr i8, ptr %17, i64 280
  %63 = load i64, ptr %62, align 8, !noalias !12
  %64 = inttoptr i64 %59 to ptr
  %65 = getelementptr i8, ptr %17, i64 288
  %66 = load i64, ptr %65, align 8, !noalias !12
  %67 = getelementptr i8, ptr %17, i64 296
  %68 = load i64, ptr %67, align 8, !noalias !12
  %69 = getelementptr i8, ptr %17, i64 304
  %70 = load i64, ptr %69, align 8, !noalias !12
  %71 = inttoptr i64 %66 to ptr
  %72 = getelementptr i8, ptr %17, i64 312
  %73 = load i64, ptr %72, align 8, !noalias !12
  %74 = getelementptr i8, ptr %17, i64 320
  %75 = load i64, ptr %74, align 8, !noalias !12
  %76 = inttoptr i64 %73 to ptr
  %77 = getelementptr i8, ptr %17, i64 336
  %78 = load i64, ptr %77, align 8, !noalias !12
  %79 = getelementptr i8, ptr %17, i64 344
  %80 = load i64, ptr %79, align 8, !noalias !12
  %81 = getelementptr i8, ptr %17, i64 352
  %82 = load i64, ptr %81, align 8, !noalias !12
  %83 = inttoptr i64 %78 to ptr
  %84 = getelementptr i8, ptr %17, i64 360
  %85 = load i64, ptr %84, align 8, !noalias !12
  %86 = getelementptr i8, ptr %17, i64 368
  %87 = load i64, ptr %86, align 8, !noalias !12
  %88 = inttoptr i64 %85 to ptr
  %89 = getelementptr i8, ptr %17, i64 384
  %90 = load i64, ptr %89, align 8, !noalias !12
  %91 = getelementptr i8, ptr %17, i64 392
  %92 = load i64, ptr %91, align 8, !noalias !12
  %93 = inttoptr i64 %90 to ptr
  %94 = getelementptr i8, ptr %17, i64 408
  %95 = load i64, ptr %94, align 8, !noalias !12
  %96 = getelementptr i8, ptr %17, i64 416
  %97 = load i64, ptr %96, align 8, !noalias !12
  %98 = inttoptr i64 %95 to ptr
  %99 = getelementptr i8, ptr %17, i64 432
  %100 = load i64, ptr %99, align 8, !noalias !12
  %101 = inttoptr i64 %100 to ptr
  %102 = getelementptr i8, ptr %17, i64 456
  %103 = load i64, ptr %102, align 8, !noalias !12
  %104 = inttoptr i64 %103 to ptr
  %105 = getelementptr i8, ptr %17, i64 480
  %106 = load i64, ptr %105, align 8, !noalias !12
  %107 = getelementptr i8, ptr %17, i64 504
  %108 = load i64, ptr %107, align 8, !noalias !12
  %109 = getelementptr i8, ptr %17, i64 512
  %110 = load i64, ptr %109, align 8, !noalias !12
  %111 = inttoptr i64 %108 to ptr
  %112 = getelementptr i8, ptr %17, i64 528
  %113 = load i64, ptr %112, align 8, !noalias !12
  %114 = getelementptr i8, ptr %17, i64 536
  %115 = load i64, ptr %114, align 8, !noalias !12
  %116 = inttoptr i64 %113 to ptr
  %117 = getelementptr i8, ptr %17, i64 552
  %118 = load i64, ptr %117, align 8, !noalias !12
  %119 = getelementptr i8, ptr %17, i64 560
  %120 = load i64, ptr %119, align 8, !noalias !12
  %121 = inttoptr i64 %118 to ptr
  %122 = getelementptr i8, ptr %17, i64 576
  %123 = load i64, ptr %122, align 8, !noalias !12
  %124 = getelementptr i8, ptr %17, i64 584
  %125 = load i64, ptr %124, align 8, !noalias !12
  %126 = inttoptr i64 %123 to ptr
  %127 = getelementptr i8, ptr %17, i64 600
  %128 = load i64, ptr %127, align 8, !noalias !12
  %129 = getelementptr i8, ptr %17, i64 608
  %130 = load i64, ptr %129, align 8, !noalias !12
  %131 = inttoptr i64 %128 to ptr
  %132 = getelementptr i8, ptr %17, i64 624
  %133 = load i64, ptr %132, align 8, !noalias !12
  %134 = getelementptr i8, ptr %17, i64 632
  %135 = load i64, ptr %134, align 8, !noalias !12
  %136 = inttoptr i64 %133 to ptr
  %137 = getelementptr i8, ptr %17, i64 648
  %138 = load i64, ptr %137, align 8, !noalias !12
  %139 = getelementptr i8, ptr %17, i64 656
  %140 = load i64, ptr %139, align 8, !noalias !12
  %141 = inttoptr i64 %138 to ptr
  %142 = getelementptr i8, ptr %17, i64 672
  %143 = load i64, ptr %142, align 8, !noalias !12
  %144 = inttoptr i64 %143 to ptr
  %145 = getelementptr i8, ptr %17, i64 696
  %146 = load i64, ptr %145, align 8, !noalias !12
  %147 = inttoptr i64 %146 to ptr
  %148 = getelementptr i8, ptr %17, i64 720
  %149 = load i64, ptr %148, align 8, !noalias !12
  %150 = getelementptr i8, ptr %17, i64 728
  %151 = load i64, ptr %150, align 8, !noalias !12
  %152 = inttoptr i64 %149 to ptr
  %153 = getelementptr i8, ptr %17, i64 744
  %154 = load i64, ptr %153, align 8, !noalias !12
  %155 = getelementptr i8, ptr %17, i64 752
  %156 = load i64, ptr %155, align 8, !noalias !12
  %157 = inttoptr i64 %154 to ptr
  %158 = getelementptr i8, ptr %17, i64 768
  %159 = load i64, ptr %158, align 8, !noalias !12
  %160 = getelementptr i8, ptr %17, i64 776
  %161 = load i64, ptr %160, align 8, !noalias !12
  %162 = inttoptr i64 %159 to ptr
  %163 = getelementptr i8, ptr %17, i64 792
  %164 = load i64, ptr %163, align 8, !noalias !12
  %165 = getelementptr i8, ptr %17, i64 800
  %166 = load i64, ptr %165, align 8, !noalias !12
  %167 = inttoptr i64 %164 to ptr
  %168 = getelementptr i8, ptr %17, i64 816
  %169 = load i64, ptr %168, align 8, !noalias !12
  %170 = getelementptr i8, ptr %17, i64 824
  %171 = load i64, ptr %170, align 8, !noalias !12
  %172 = inttoptr i64 %169 to ptr
  %173 = getelementptr i8, ptr %17, i64 840
  %174 = load i64, ptr %173, align 8, !noalias !12
  %175 = getelementptr i8, ptr %17, i64 848
  %176 = load i64, ptr %175, align 8, !noalias !12
  %177 = inttoptr i64 %174 to ptr
  %178 = getelementptr i8, ptr %17, i64 864
  %179 = load i64, ptr %178, align 8, !noalias !12
  %180 = getelementptr i8, ptr %17, i64 872
  %181 = load i64, ptr %180, align 8, !noalias !12
  %182 = inttoptr i64 %179 to ptr
  %183 = getelementptr i8, ptr %17, i64 888
  %184 = load i64, ptr %183, align 8, !noalias !12
  %185 = getelementptr i8, ptr %17, i64 896
  %186 = load i64, ptr %185, align 8, !noalias !12
  %187 = inttoptr i64 %184 to ptr
  %188 = getelementptr i8, ptr %17, i64 912
  %189 = load i64, ptr %188, align 8, !noalias !12
  %190 = inttoptr i64 %189 to ptr
  %191 = getelementptr i8, ptr %17, i64 936
  %192 = load i64, ptr %191, align 8, !noalias !12
  %193 = inttoptr i64 %192 to ptr
  %194 = getelementptr i8, ptr %17, i64 960
  %195 = load i64, ptr %194, align 8, !noalias !12
  %196 = getelementptr i8, ptr %17, i64 968
  %197 = load i64, ptr %196, align 8, !noalias !12
  %198 = inttoptr i64 %195 to ptr
  %199 = getelementptr i8, ptr %17, i64 984
  %200 = load i64, ptr %199, align 8, !noalias !12
  %201 = getelementptr i8, ptr %17, i64 992
  %202 = load i64, ptr %201, align 8, !noalias !12
  %203 = getelementptr i8, ptr %17, i64 1000
  %204 = load i64, ptr %203, align 8, !noalias !12
  %205 = inttoptr i64 %200 to ptr
  %206 = getelementptr i8, ptr %17, i64 1008
  %207 = load i64, ptr %206, align 8, !noalias !12
  %208 = getelementptr i8, ptr %17, i64 1016
  %209 = load i64, ptr %208, align 8, !noalias !12
  %210 = getelementptr i8, ptr %17, i64 1024
  %211 = load i64, ptr %210, align 8, !noalias !12
  %212 = inttoptr i64 %207 to ptr
  %213 = getelementptr i8, ptr %17, i64 1032
  %214 = load i64, ptr %213, align 8, !noalias !12
  %215 = getelementptr i8, ptr %17, i64 1040
  %216 = load i64, ptr %215, align 8, !noalias !12
  %217 = getelementptr i8, ptr %17, i64 1048
  %218 = load i64, ptr %217, align 8, !noalias !12
  %219 = inttoptr i64 %214 to ptr
  %220 = getelementptr i8, ptr %17, i64 1056
  %221 = load i64, ptr %220, align 8, !noalias !12
  %222 = getelementptr i8, ptr %17, i64 1064
  %223 = load i64, ptr %222, align 8, !noalias !12
  %224 = getelementptr i8, ptr %17, i64 1072
  %225 = load i64, ptr %224, align 8, !noalias !12
  %226 = inttoptr i64 %221 to ptr
  %227 = getelementptr i8, ptr %17, i64 1080
  %228 = load i64, ptr %227, align 8, !noalias !12
  %229 = getelementptr i8, ptr %17, i64 1088
  %230 = load i64, ptr %229, align 8, !noalias !12
  %231 = inttoptr i64 %228 to ptr
  %232 = getelementptr i8, ptr %39, i64 8
  %233 = load i64, ptr %232, align 8, !noalias !12
  %234 = icmp slt i64 %197, 2
  %235 = select i1 %234, i64 %197, i64 0
  %236 = getelementptr double, ptr %198, i64 %197
  %237 = getelementptr i8, ptr %236, i64 -16
  %238 = getelementptr double, ptr %237, i64 %235
  %239 = load double, ptr %238, align 8, !noalias !12
  %240 = load double, ptr %193, align 8, !noalias !12
  %241 = load i64, ptr %19, align 8, !noalias !12
  %242 = mul nsw i64 %241, %87
  %243 = shl i64 %242, 3
  %244 = add i64 %113, %243
  %245 = mul nsw i64 %241, %233
  %246 = getelementptr i8, ptr %19, i64 8
  %247 = load i64, ptr %246, align 8, !noalias !12
  %248 = icmp sgt i64 %247, 0
  %249 = getelementptr i8, ptr %19, i64 32
  %250 = load i64, ptr %249, align 8, !noalias !12
  %251 = icmp ne i64 %250, 1
  %252 = add nsw i64 %241, -1
  %253 = add nsw i64 %252, %250
  %254 = sitofp i64 %253 to double
  %255 = sub nsw i64 1, %250
  %256 = sitofp i64 %255 to double
  %257 = getelementptr i8, ptr %190, i64 16
  %258 = load i64, ptr %257, align 8, !noalias !12
  %259 = sitofp i64 %258 to double
  br label %260

260:                                              ; preds = %1, %2127
  %261 = phi i64 [ 0, %1 ], [ %2129, %2127 ]
  %262 = phi i64 [ 8, %1 ], [ %2128, %2127 ]
  %263 = phi i64 [ 0, %1 ], [ %2138, %2127 ]
  %264 = icmp sgt i64 %262, 0
  br i1 %264, label %2127, label %265

265:                                              ; preds = %1063, %260
  %266 = phi i64 [ %263, %260 ], [ %1007, %1063 ]
  br label %267

267:                                              ; preds = %2125, %265
  %268 = phi i64 [ %266, %265 ], [ %1740, %2125 ]
  %269 = phi i1 [ true, %265 ], [ %2126, %2125 ]
  br i1 %269, label %270, label %1006

270:                                              ; preds = %267, %1005
  br label %271

271:                                              ; preds = %270, %306
  %272 = phi i64 [ 0, %270 ], [ %349, %306 ]
  %273 = phi i64 [ 8, %270 ], [ %348, %306 ]
  %274 = phi i64 [ 0, %270 ], [ %307, %306 ]
  %275 = phi i64 [ 0, %270 ], [ %312, %306 ]
  %276 = phi i64 [ -1, %270 ], [ %313, %306 ]
  %277 = icmp sgt i64 %273, 0
  br i1 %277, label %347, label %314

278:                                              ; preds = %347
  %279 = load i64, ptr %190, align 8, !noalias !16
  %280 = icmp slt i64 %279, %202
  br i1 %280, label %281, label %306

281:                                              ; preds = %278
  %282 = add nsw i64 %279, 1
  store i64 %282, ptr %190, align 8, !noalias !16
  store i64 %279, ptr %353, align 8, !noalias !16
  %283 = shl i64 %272, 3
  %284 = add i64 %85, %283
  %285 = call i64 @llvm.smax.i64(i64 %204, i64 0)
  br label %286

286:                                              ; preds = %281, %290
  %287 = phi i64 [ 0, %281 ], [ %292, %290 ]
  %288 = phi i64 [ %285, %281 ], [ %291, %290 ]
  %289 = icmp sgt i64 %288, 0
  br i1 %289, label %290, label %356

290:                                              ; preds = %286
  %291 = add nsw i64 %288, -1
  %292 = add i64 %287, 1
  %293 = shl nsw i64 %287, 6
  %294 = add nsw i64 %284, %293
  %295 = icmp slt i64 %279, 0
  %296 = select i1 %295, i64 %202, i64 0
  %297 = add i64 %279, %296
  %298 = icmp slt i64 %287, 0
  %299 = select i1 %298, i64 %204, i64 0
  %300 = mul i64 %297, %204
  %301 = getelementptr double, ptr %205, i64 %300
  %302 = getelementptr double, ptr %301, i64 %287
  %303 = getelementptr double, ptr %302, i64 %299
  %304 = load i64, ptr %303, align 8, !noalias !20
  %305 = inttoptr i64 %294 to ptr
  store atomic i64 %304, ptr %305 unordered, align 8, !noalias !20
  br label %286

306:                                              ; preds = %402, %278, %347
  %307 = phi i64 [ %408, %402 ], [ %274, %278 ], [ %274, %347 ]
  %308 = load i64, ptr %353, align 8, !noalias !16
  %309 = icmp sgt i64 %308, -1
  %310 = shl nuw i64 1, %272
  %311 = select i1 %309, i64 %310, i64 0
  %312 = or i64 %275, %311
  %313 = select i1 %309, i64 %272, i64 %276
  br label %271

314:                                              ; preds = %271
  %315 = icmp sgt i64 %276, -1
  br i1 %315, label %316, label %2139

316:                                              ; preds = %314, %342
  %317 = phi i64 [ %411, %342 ], [ 0, %314 ]
  %318 = phi i64 [ %410, %342 ], [ 8, %314 ]
  %319 = icmp sgt i64 %318, 0
  br i1 %319, label %409, label %343

320:                                              ; preds = %409
  %321 = load i64, ptr %232, align 8, !noalias !16
  %322 = shl i64 %317, 3
  %323 = add i64 %85, %322
  %324 = call i64 @llvm.smax.i64(i64 %321, i64 0)
  br label %325

325:                                              ; preds = %320, %329
  %326 = phi i64 [ 0, %320 ], [ %331, %329 ]
  %327 = phi i64 [ %324, %320 ], [ %330, %329 ]
  %328 = icmp sgt i64 %327, 0
  br i1 %328, label %329, label %418

329:                                              ; preds = %325
  %330 = add nsw i64 %327, -1
  %331 = add i64 %326, 1
  %332 = shl nsw i64 %326, 6
  %333 = add nsw i64 %323, %332
  %334 = shl nsw i64 %326, 3
  %335 = add nsw i64 %334, %276
  %336 = icmp slt i64 %335, 0
  %337 = select i1 %336, i64 %87, i64 0
  %338 = getelementptr double, ptr %88, i64 %335
  %339 = getelementptr double, ptr %338, i64 %337
  %340 = load i64, ptr %339, align 8, !noalias !24
  %341 = inttoptr i64 %333 to ptr
  store atomic i64 %340, ptr %341 unordered, align 8, !noalias !24
  br label %325

342:                                              ; preds = %483, %409
  br label %316

343:                                              ; preds = %316
  %344 = getelementptr i8, ptr %39, i64 24
  %345 = load i64, ptr %344, align 8, !noalias !16
  %346 = inttoptr i64 %345 to ptr
  call void %346(ptr %54, ptr %57) #3, !noalias !16
  br label %2139

347:                                              ; preds = %271
  %348 = add nsw i64 %273, -1
  %349 = add i64 %272, 1
  %350 = icmp slt i64 %272, 0
  %351 = select i1 %350, i64 %181, i64 0
  %352 = getelementptr i64, ptr %182, i64 %272
  %353 = getelementptr i64, ptr %352, i64 %351
  %354 = load i64, ptr %353, align 8, !noalias !16
  %355 = icmp eq i64 %354, -1
  br i1 %355, label %278, label %306

356:                                              ; preds = %286
  %357 = add i64 %46, %283
  %358 = call i64 @llvm.smax.i64(i64 %211, i64 0)
  br label %359

359:                                              ; preds = %356, %363
  %360 = phi i64 [ 0, %356 ], [ %365, %363 ]
  %361 = phi i64 [ %358, %356 ], [ %364, %363 ]
  %362 = icmp sgt i64 %361, 0
  br i1 %362, label %363, label %379

363:                                              ; preds = %359
  %364 = add nsw i64 %361, -1
  %365 = add i64 %360, 1
  %366 = shl nsw i64 %360, 6
  %367 = add nsw i64 %357, %366
  %368 = icmp slt i64 %279, 0
  %369 = select i1 %368, i64 %209, i64 0
  %370 = add i64 %279, %369
  %371 = icmp slt i64 %360, 0
  %372 = select i1 %371, i64 %211, i64 0
  %373 = mul i64 %370, %211
  %374 = getelementptr double, ptr %212, i64 %373
  %375 = getelementptr double, ptr %374, i64 %360
  %376 = getelementptr double, ptr %375, i64 %372
  %377 = load i64, ptr %376, align 8, !noalias !28
  %378 = inttoptr i64 %367 to ptr
  store atomic i64 %377, ptr %378 unordered, align 8, !noalias !28
  br label %359

379:                                              ; preds = %359
  %380 = add i64 %51, %283
  %381 = call i64 @llvm.smax.i64(i64 %218, i64 0)
  br label %382

382:                                              ; preds = %379, %386
  %383 = phi i64 [ 0, %379 ], [ %388, %386 ]
  %384 = phi i64 [ %381, %379 ], [ %387, %386 ]
  %385 = icmp sgt i64 %384, 0
  br i1 %385, label %386, label %402

386:                                              ; preds = %382
  %387 = add nsw i64 %384, -1
  %388 = add i64 %383, 1
  %389 = shl nsw i64 %383, 6
  %390 = add nsw i64 %380, %389
  %391 = icmp slt i64 %279, 0
  %392 = select i1 %391, i64 %216, i64 0
  %393 = add i64 %279, %392
  %394 = icmp slt i64 %383, 0
  %395 = select i1 %394, i64 %218, i64 0
  %396 = mul i64 %393, %218
  %397 = getelementptr double, ptr %219, i64 %396
  %398 = getelementptr double, ptr %397, i64 %383
  %399 = getelementptr double, ptr %398, i64 %395
  %400 = load i64, ptr %399, align 8, !noalias !32
  %401 = inttoptr i64 %390 to ptr
  store atomic i64 %400, ptr %401 unordered, align 8, !noalias !32
  br label %382

402:                                              ; preds = %382
  %403 = load double, ptr %198, align 8, !noalias !16
  %404 = select i1 %350, i64 %135, i64 0
  %405 = getelementptr double, ptr %136, i64 %272
  %406 = getelementptr double, ptr %405, i64 %404
  store double %403, ptr %406, align 8, !noalias !16
  %407 = shl nuw i64 1, %272
  %408 = or i64 %274, %407
  br label %306

409:                                              ; preds = %316
  %410 = add nsw i64 %318, -1
  %411 = add i64 %317, 1
  %412 = icmp slt i64 %317, 0
  %413 = select i1 %412, i64 %181, i64 0
  %414 = getelementptr i64, ptr %182, i64 %317
  %415 = getelementptr i64, ptr %414, i64 %413
  %416 = load i64, ptr %415, align 8, !noalias !16
  %417 = icmp eq i64 %416, -1
  br i1 %417, label %320, label %342

418:                                              ; preds = %325
  %419 = load i64, ptr %232, align 8, !noalias !16
  %420 = add i64 %113, %322
  %421 = call i64 @llvm.smax.i64(i64 %419, i64 0)
  br label %422

422:                                              ; preds = %418, %426
  %423 = phi i64 [ 0, %418 ], [ %428, %426 ]
  %424 = phi i64 [ %421, %418 ], [ %427, %426 ]
  %425 = icmp sgt i64 %424, 0
  br i1 %425, label %426, label %439

426:                                              ; preds = %422
  %427 = add nsw i64 %424, -1
  %428 = add i64 %423, 1
  %429 = shl nsw i64 %423, 6
  %430 = add nsw i64 %420, %429
  %431 = shl nsw i64 %423, 3
  %432 = add nsw i64 %431, %276
  %433 = icmp slt i64 %432, 0
  %434 = select i1 %433, i64 %115, i64 0
  %435 = getelementptr double, ptr %116, i64 %432
  %436 = getelementptr double, ptr %435, i64 %434
  %437 = load i64, ptr %436, align 8, !noalias !36
  %438 = inttoptr i64 %430 to ptr
  store atomic i64 %437, ptr %438 unordered, align 8, !noalias !36
  br label %422

439:                                              ; preds = %422
  %440 = getelementptr i8, ptr %39, i64 32
  %441 = load i64, ptr %440, align 8, !noalias !16
  %442 = add i64 %46, %322
  %443 = call i64 @llvm.smax.i64(i64 %441, i64 0)
  br label %444

444:                                              ; preds = %439, %448
  %445 = phi i64 [ 0, %439 ], [ %450, %448 ]
  %446 = phi i64 [ %443, %439 ], [ %449, %448 ]
  %447 = icmp sgt i64 %446, 0
  br i1 %447, label %448, label %461

448:                                              ; preds = %444
  %449 = add nsw i64 %446, -1
  %450 = add i64 %445, 1
  %451 = shl nsw i64 %445, 6
  %452 = add nsw i64 %442, %451
  %453 = shl nsw i64 %445, 3
  %454 = add nsw i64 %453, %276
  %455 = icmp slt i64 %454, 0
  %456 = select i1 %455, i64 %48, i64 0
  %457 = getelementptr double, ptr %49, i64 %454
  %458 = getelementptr double, ptr %457, i64 %456
  %459 = load i64, ptr %458, align 8, !noalias !40
  %460 = inttoptr i64 %452 to ptr
  store atomic i64 %459, ptr %460 unordered, align 8, !noalias !40
  br label %444

461:                                              ; preds = %444
  %462 = getelementptr i8, ptr %39, i64 40
  %463 = load i64, ptr %462, align 8, !noalias !16
  %464 = add i64 %51, %322
  %465 = call i64 @llvm.smax.i64(i64 %463, i64 0)
  br label %466

466:                                              ; preds = %461, %470
  %467 = phi i64 [ 0, %461 ], [ %472, %470 ]
  %468 = phi i64 [ %465, %461 ], [ %471, %470 ]
  %469 = icmp sgt i64 %468, 0
  br i1 %469, label %470, label %483

470:                                              ; preds = %466
  %471 = add nsw i64 %468, -1
  %472 = add i64 %467, 1
  %473 = shl nsw i64 %467, 6
  %474 = add nsw i64 %464, %473
  %475 = shl nsw i64 %467, 3
  %476 = add nsw i64 %475, %276
  %477 = icmp slt i64 %476, 0
  %478 = select i1 %477, i64 %53, i64 0
  %479 = getelementptr double, ptr %54, i64 %476
  %480 = getelementptr double, ptr %479, i64 %478
  %481 = load i64, ptr %480, align 8, !noalias !44
  %482 = inttoptr i64 %474 to ptr
  store atomic i64 %481, ptr %482 unordered, align 8, !noalias !44
  br label %466

483:                                              ; preds = %466
  %484 = getelementptr double, ptr %136, i64 %276
  %485 = load double, ptr %484, align 8, !noalias !16
  %486 = select i1 %412, i64 %135, i64 0
  %487 = getelementptr double, ptr %136, i64 %317
  %488 = getelementptr double, ptr %487, i64 %486
  store double %485, ptr %488, align 8, !noalias !16
  %489 = select i1 %412, i64 %140, i64 0
  %490 = getelementptr double, ptr %141, i64 %317
  %491 = getelementptr double, ptr %490, i64 %489
  store double 0.000000e+00, ptr %491, align 8, !noalias !16
  %492 = select i1 %412, i64 %156, i64 0
  %493 = getelementptr double, ptr %157, i64 %317
  %494 = getelementptr double, ptr %493, i64 %492
  store double 0x7FF0000000000000, ptr %494, align 8, !noalias !16
  store i64 -2, ptr %415, align 8, !noalias !16
  br label %342

495:                                              ; preds = %2139
  br label %2194

496:                                              ; preds = %2139
  %497 = icmp eq i64 %274, 0
  br i1 %497, label %1006, label %498

498:                                              ; preds = %496
  %499 = load i64, ptr %232, align 8, !noalias !48
  %500 = trunc i64 %274 to i8
  %501 = bitcast i8 %500 to <8 x i1>
  %502 = load <8 x double>, ptr %136, align 8, !noalias !48
  store ptr null, ptr %15, align 8, !noalias !52
  store ptr null, ptr %16, align 8, !noalias !52
  store <8 x double> %502, ptr %44, align 8, !noalias !52
  %503 = icmp sgt i64 %61, 0
  br i1 %503, label %504, label %506

504:                                              ; preds = %498
  store ptr null, ptr %15, align 8, !noalias !52
  %505 = call fastcc i32 @_set_inputs(ptr nonnull %15, ptr nonnull %44, i64 %43, ptr %49, i64 %48, ptr %64, i64 %61, i64 %63, ptr %71, i64 %68, i64 %70, ptr %76, i64 %75, ptr %83, i64 %80, i64 %82) #3
  switch i32 %505, label %512 [
    i32 -2, label %506
    i32 0, label %506
  ], !prof !56

506:                                              ; preds = %504, %504, %498
  %507 = load i64, ptr %39, align 8, !noalias !52
  %508 = inttoptr i64 %507 to ptr
  %509 = call i32 %508(ptr nonnull %44, ptr %88, ptr %49, ptr %57, ptr %98) #3, !noalias !52
  %510 = sext i32 %509 to i64
  %511 = and i64 %274, %510
  br label %512

512:                                              ; preds = %504, %506
  %513 = phi i64 [ %511, %506 ], [ 0, %504 ]
  %514 = phi i1 [ true, %506 ], [ false, %504 ]
  br i1 %514, label %968, label %2141, !prof !8

515:                                              ; preds = %968, %970
  %516 = phi i64 [ 0, %968 ], [ %972, %970 ]
  %517 = phi i64 [ %969, %968 ], [ %971, %970 ]
  %518 = icmp sgt i64 %517, 0
  br i1 %518, label %970, label %519

519:                                              ; preds = %515
  %520 = getelementptr i8, ptr %193, i64 8
  %521 = load double, ptr %520, align 8, !noalias !48
  %522 = insertelement <8 x double> poison, double %521, i64 0
  %523 = shufflevector <8 x double> %522, <8 x double> poison, <8 x i32> zeroinitializer
  %524 = fcmp oeq double %521, 0.000000e+00
  br i1 %524, label %525, label %667

525:                                              ; preds = %519
  %526 = load double, ptr %193, align 8, !noalias !48
  %527 = load i64, ptr %232, align 8, !noalias !57
  store <8 x double> zeroinitializer, ptr %13, align 64, !noalias !61
  store <8 x double> zeroinitializer, ptr %14, align 64, !noalias !61
  store <8 x double> zeroinitializer, ptr %13, align 64, !noalias !61
  %528 = call fastcc i32 @norm(ptr nonnull %13, ptr %88, ptr %88, ptr %88, ptr %126, i64 %125, ptr %131, i64 %130, i64 %527) #3
  %529 = load <8 x double>, ptr %13, align 64, !noalias !61
  switch i32 %528, label %664 [
    i32 -2, label %530
    i32 0, label %530
  ], !prof !56

530:                                              ; preds = %525, %525
  store <8 x double> zeroinitializer, ptr %14, align 64, !noalias !61
  %531 = call fastcc i32 @norm(ptr nonnull %14, ptr %116, ptr %88, ptr %88, ptr %126, i64 %125, ptr %131, i64 %130, i64 %527) #3
  %532 = load <8 x double>, ptr %14, align 64, !noalias !61
  switch i32 %531, label %664 [
    i32 -2, label %533
    i32 0, label %533
  ], !prof !56

533:                                              ; preds = %530, %530
  %534 = fcmp olt <8 x double> %529, splat (double 1.000000e-05)
  %535 = fcmp olt <8 x double> %532, splat (double 1.000000e-05)
  %536 = or <8 x i1> %534, %535
  %537 = fmul <8 x double> %529, splat (double 1.000000e-02)
  %538 = fdiv <8 x double> %537, %532
  %539 = select <8 x i1> %536, <8 x double> splat (double 0x3EB0C6F7A0B5ED8D), <8 x double> %538
  %540 = insertelement <8 x double> poison, double %526, i64 0
  %541 = shufflevector <8 x double> %540, <8 x double> poison, <8 x i32> zeroinitializer
  %542 = fcmp olt <8 x double> %541, %539
  %543 = select <8 x i1> %542, <8 x double> %541, <8 x double> %539
  %544 = call i64 @llvm.smax.i64(i64 %527, i64 0)
  br label %545

545:                                              ; preds = %533, %566
  %546 = phi i64 [ 0, %533 ], [ %568, %566 ]
  %547 = phi i64 [ %544, %533 ], [ %567, %566 ]
  %548 = icmp sgt i64 %547, 0
  br i1 %548, label %566, label %549

549:                                              ; preds = %545
  %550 = shl i64 %87, 3
  %551 = add i64 %113, %550
  %552 = fadd <8 x double> %502, %543
  store ptr null, ptr %11, align 8, !noalias !65
  store ptr null, ptr %12, align 8, !noalias !65
  store <8 x double> %552, ptr %44, align 8, !noalias !65
  br i1 %503, label %553, label %555

553:                                              ; preds = %549
  store ptr null, ptr %11, align 8, !noalias !65
  %554 = call fastcc i32 @_set_inputs(ptr nonnull %11, ptr nonnull %44, i64 %43, ptr %49, i64 %48, ptr %64, i64 %61, i64 %63, ptr %71, i64 %68, i64 %70, ptr %76, i64 %75, ptr %83, i64 %80, i64 %82) #3
  switch i32 %554, label %664 [
    i32 -2, label %555
    i32 0, label %555
  ], !prof !56

555:                                              ; preds = %553, %553, %549
  %556 = load i64, ptr %39, align 8, !noalias !65
  %557 = inttoptr i64 %556 to ptr
  %558 = inttoptr i64 %551 to ptr
  %559 = call i32 %557(ptr nonnull %44, ptr %98, ptr %49, ptr %57, ptr %558) #3, !noalias !65
  %560 = trunc i32 %559 to i8
  %561 = bitcast i8 %560 to <8 x i1>
  store <8 x double> zeroinitializer, ptr %10, align 64, !noalias !69
  %562 = icmp slt i64 %87, 0
  %563 = select i1 %562, i64 %115, i64 0
  %564 = add i64 %87, %563
  %565 = icmp slt i64 %564, 0
  br i1 %565, label %583, label %584, !prof !4

566:                                              ; preds = %545
  %567 = add nsw i64 %547, -1
  %568 = add i64 %546, 1
  %569 = shl i64 %546, 6
  %570 = getelementptr i8, ptr %88, i64 %569
  %571 = load <8 x double>, ptr %570, align 8, !noalias !57
  %572 = getelementptr i8, ptr %116, i64 %569
  %573 = load <8 x double>, ptr %572, align 8, !noalias !57
  %574 = fmul <8 x double> %543, %573
  %575 = fadd <8 x double> %571, %574
  %576 = getelementptr i8, ptr %98, i64 %569
  store <8 x double> %575, ptr %576, align 8, !noalias !57
  br label %545

577:                                              ; preds = %588, %591
  %578 = phi i64 [ 0, %588 ], [ %593, %591 ]
  %579 = phi i64 [ %544, %588 ], [ %592, %591 ]
  %580 = icmp sgt i64 %579, 0
  br i1 %580, label %591, label %581

581:                                              ; preds = %577
  store <8 x double> zeroinitializer, ptr %10, align 64, !noalias !69
  %582 = call fastcc i32 @norm(ptr nonnull %10, ptr %590, ptr %88, ptr %88, ptr %126, i64 %125, ptr %131, i64 %130, i64 %527) #3
  switch i32 %582, label %664 [
    i32 -2, label %600
    i32 0, label %600
  ], !prof !56

583:                                              ; preds = %555
  br label %584

584:                                              ; preds = %583, %555
  %585 = phi i64 [ 0, %583 ], [ %564, %555 ]
  %586 = icmp slt i64 %564, %115
  br i1 %586, label %588, label %587, !prof !8

587:                                              ; preds = %584
  br label %588

588:                                              ; preds = %587, %584
  %589 = phi i64 [ %115, %587 ], [ %585, %584 ]
  %590 = getelementptr double, ptr %116, i64 %589
  br label %577

591:                                              ; preds = %577
  %592 = add nsw i64 %579, -1
  %593 = add i64 %578, 1
  %594 = shl i64 %578, 6
  %595 = getelementptr i8, ptr %590, i64 %594
  %596 = load <8 x double>, ptr %595, align 8, !noalias !69
  %597 = getelementptr i8, ptr %116, i64 %594
  %598 = load <8 x double>, ptr %597, align 8, !noalias !69
  %599 = fsub <8 x double> %596, %598
  store <8 x double> %599, ptr %595, align 8, !noalias !69
  br label %577

600:                                              ; preds = %581, %581
  %601 = load <8 x double>, ptr %10, align 64, !noalias !69
  %602 = fdiv <8 x double> %601, %543
  %603 = fcmp ogt <8 x double> %532, %602
  %604 = select <8 x i1> %603, <8 x double> %532, <8 x double> %602
  %605 = fcmp ogt <8 x double> %604, splat (double 1.000000e-15)
  %606 = fdiv <8 x double> splat (double 1.000000e-02), %604
  %607 = select <8 x i1> %605, <8 x double> %606, <8 x double> splat (double 1.000000e+13)
  %608 = load double, ptr %36, align 8, !noalias !69
  %609 = insertelement <8 x double> poison, double %608, i64 0
  %610 = shufflevector <8 x double> %609, <8 x double> poison, <8 x i32> zeroinitializer
  %611 = bitcast <8 x double> %607 to <8 x i64>
  %612 = add nsw <8 x i64> %611, splat (i64 -4604544271217802189)
  %613 = ashr <8 x i64> %612, splat (i64 52)
  %614 = and <8 x i64> %612, splat (i64 -4503599627370496)
  %615 = sub <8 x i64> %611, %614
  %616 = bitcast <8 x i64> %615 to <8 x double>
  %617 = fadd <8 x double> %616, splat (double -1.000000e+00)
  %618 = fadd <8 x double> %616, splat (double 1.000000e+00)
  %619 = fdiv <8 x double> %617, %618
  %620 = fmul <8 x double> %619, %619
  %621 = call <8 x double> @llvm.fma.v8f64(<8 x double> %620, <8 x double> splat (double 0x3FD484B13D7C02A9), <8 x double> splat (double 0x3FDA61762A7ADED9))
  %622 = call <8 x double> @llvm.fma.v8f64(<8 x double> %621, <8 x double> %620, <8 x double> splat (double 0x3FE2776C50EF9BFE))
  %623 = call <8 x double> @llvm.fma.v8f64(<8 x double> %622, <8 x double> %620, <8 x double> splat (double 0x3FEEC709DC3A03FD))
  %624 = call <8 x double> @llvm.fma.v8f64(<8 x double> %623, <8 x double> %620, <8 x double> splat (double 0x40071547652B82FE))
  %625 = fmul <8 x double> %624, %619
  %626 = trunc nsw <8 x i64> %613 to <8 x i32>
  %627 = sitofp <8 x i32> %626 to <8 x double>
  %628 = fadd <8 x double> %625, %627
  %629 = fmul <8 x double> %628, %610
  %630 = fcmp ogt <8 x double> %629, splat (double -1.000000e+03)
  %631 = select <8 x i1> %630, <8 x double> %629, <8 x double> splat (double -1.000000e+03)
  %632 = fcmp olt <8 x double> %631, splat (double 1.000000e+03)
  %633 = select <8 x i1> %632, <8 x double> %631, <8 x double> splat (double 1.000000e+03)
  %634 = call <8 x double> @llvm.rint.v8f64(<8 x double> %633)
  %635 = fsub <8 x double> %633, %634
  %636 = call <8 x double> @llvm.fma.v8f64(<8 x double> %635, <8 x double> splat (double 0x3EEFFCBFC588B0C5), <8 x double> splat (double 0x3F2430912F86C786))
  %637 = call <8 x double> @llvm.fma.v8f64(<8 x double> %636, <8 x double> %635, <8 x double> splat (double 0x3F55D87FE78A6730))
  %638 = call <8 x double> @llvm.fma.v8f64(<8 x double> %637, <8 x double> %635, <8 x double> splat (double 0x3F83B2AB6FBA4E77))
  %639 = call <8 x double> @llvm.fma.v8f64(<8 x double> %638, <8 x double> %635, <8 x double> splat (double 0x3FAC6B08D704A0BF))
  %640 = call <8 x double> @llvm.fma.v8f64(<8 x double> %639, <8 x double> %635, <8 x double> splat (double 0x3FCEBFBDFF82C58E))
  %641 = call <8 x double> @llvm.fma.v8f64(<8 x double> %640, <8 x double> %635, <8 x double> splat (double 0x3FE62E42FEFA39EF))
  %642 = call <8 x double> @llvm.fma.v8f64(<8 x double> %641, <8 x double> %635, <8 x double> splat (double 1.000000e+00))
  %643 = fptosi <8 x double> %634 to <8 x i32>
  %644 = zext <8 x i32> %643 to <8 x i64>
  %645 = shl <8 x i64> %644, splat (i64 52)
  %646 = bitcast <8 x double> %642 to <8 x i64>
  %647 = add <8 x i64> %645, %646
  %648 = bitcast <8 x i64> %647 to <8 x double>
  %649 = fmul <8 x double> %543, splat (double 1.000000e-03)
  %650 = fcmp olt <8 x double> %649, splat (double 0x3EB0C6F7A0B5ED8D)
  %651 = select <8 x i1> %650, <8 x double> splat (double 0x3EB0C6F7A0B5ED8D), <8 x double> %649
  %652 = fmul <8 x double> %543, splat (double 1.000000e+02)
  %653 = select <8 x i1> %605, <8 x double> %648, <8 x double> %651
  %654 = fcmp olt <8 x double> %652, %653
  %655 = select <8 x i1> %654, <8 x double> %652, <8 x double> %653
  %656 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %502)
  %657 = fmul <8 x double> %656, splat (double 0x3D30000000000000)
  %658 = fcmp ogt <8 x double> %657, %655
  %659 = select <8 x i1> %658, <8 x double> %657, <8 x double> %655
  %660 = shufflevector <8 x double> %540, <8 x double> poison, <8 x i32> zeroinitializer
  %661 = fcmp olt <8 x double> %660, %659
  %662 = select <8 x i1> %661, <8 x double> %660, <8 x double> %659
  %663 = select <8 x i1> %561, <8 x double> %649, <8 x double> %662
  br label %664

664:                                              ; preds = %553, %525, %530, %581, %600
  %665 = phi <8 x double> [ zeroinitializer, %525 ], [ %663, %600 ], [ zeroinitializer, %581 ], [ zeroinitializer, %530 ], [ zeroinitializer, %553 ]
  %666 = phi i1 [ false, %525 ], [ true, %600 ], [ false, %581 ], [ false, %530 ], [ false, %553 ]
  br i1 %666, label %667, label %2141, !prof !8

667:                                              ; preds = %664, %519
  %668 = phi double [ 1.000000e+00, %519 ], [ 2.000000e+00, %664 ]
  %669 = phi <8 x double> [ %523, %519 ], [ %665, %664 ]
  %670 = load <8 x double>, ptr %141, align 8, !noalias !48
  %671 = select <8 x i1> %501, <8 x double> %669, <8 x double> %670
  store <8 x double> %671, ptr %141, align 8, !noalias !48
  %672 = load <8 x double>, ptr %144, align 8, !noalias !48
  %673 = select <8 x i1> %501, <8 x double> splat (double 1.000000e-04), <8 x double> %672
  store <8 x double> %673, ptr %144, align 8, !noalias !48
  %674 = getelementptr i8, ptr %36, i64 40
  %675 = load double, ptr %674, align 8, !noalias !48
  %676 = load <8 x double>, ptr %147, align 8, !noalias !48
  %677 = insertelement <8 x double> poison, double %675, i64 0
  %678 = shufflevector <8 x double> %677, <8 x double> poison, <8 x i32> zeroinitializer
  %679 = select <8 x i1> %501, <8 x double> %678, <8 x double> %676
  store <8 x double> %679, ptr %147, align 8, !noalias !48
  %680 = load <8 x double>, ptr %162, align 8, !noalias !48
  %681 = select <8 x i1> %501, <8 x double> zeroinitializer, <8 x double> %680
  store <8 x double> %681, ptr %162, align 8, !noalias !48
  %682 = load <8 x double>, ptr %167, align 8, !noalias !48
  %683 = select <8 x i1> %501, <8 x double> zeroinitializer, <8 x double> %682
  store <8 x double> %683, ptr %167, align 8, !noalias !48
  %684 = load <8 x double>, ptr %172, align 8, !noalias !48
  %685 = insertelement <8 x double> poison, double %668, i64 0
  %686 = shufflevector <8 x double> %685, <8 x double> poison, <8 x i32> zeroinitializer
  %687 = select <8 x i1> %501, <8 x double> %686, <8 x double> %684
  store <8 x double> %687, ptr %172, align 8, !noalias !48
  %688 = call <8 x i1> @llvm.is.fpclass.v8f64(<8 x double> %669, i32 384)
  %689 = select <8 x i1> %688, <8 x double> splat (double 2.000000e+00), <8 x double> splat (double 4.000000e+00)
  %690 = load <8 x double>, ptr %177, align 8, !noalias !48
  %691 = select <8 x i1> %501, <8 x double> %689, <8 x double> %690
  store <8 x double> %691, ptr %177, align 8, !noalias !48
  br label %692

692:                                              ; preds = %667, %718
  %693 = phi i64 [ 0, %667 ], [ %981, %718 ]
  %694 = phi i64 [ 8, %667 ], [ %980, %718 ]
  %695 = icmp sgt i64 %694, 0
  br i1 %695, label %979, label %719

696:                                              ; preds = %979
  %697 = load double, ptr %198, align 8, !noalias !48
  %698 = icmp slt i64 %693, 0
  %699 = select i1 %698, i64 %151, i64 0
  %700 = getelementptr double, ptr %152, i64 %693
  %701 = getelementptr double, ptr %700, i64 %699
  store double 0.000000e+00, ptr %701, align 8, !noalias !48
  %702 = select i1 %698, i64 %156, i64 0
  %703 = getelementptr double, ptr %157, i64 %693
  %704 = getelementptr double, ptr %703, i64 %702
  store double %697, ptr %704, align 8, !noalias !48
  %705 = select i1 %698, i64 %181, i64 0
  %706 = getelementptr i64, ptr %182, i64 %693
  %707 = getelementptr i64, ptr %706, i64 %705
  %708 = load i64, ptr %707, align 8, !noalias !48
  %709 = add nsw i64 %197, -1
  %710 = mul nsw i64 %708, %709
  %711 = getelementptr i8, ptr %190, i64 24
  %712 = load i64, ptr %711, align 8, !noalias !48
  %713 = shl nsw i64 %710, 3
  %714 = add nsw i64 %712, %713
  %715 = select i1 %698, i64 %186, i64 0
  %716 = getelementptr i64, ptr %187, i64 %693
  %717 = getelementptr i64, ptr %716, i64 %715
  store i64 %714, ptr %717, align 8, !noalias !48
  br label %718

718:                                              ; preds = %696, %979
  br label %692

719:                                              ; preds = %692
  %720 = xor i64 %513, -1
  %721 = and i64 %274, %720
  %722 = icmp eq i64 %721, 0
  br i1 %722, label %811, label %723

723:                                              ; preds = %719, %745
  %724 = phi i64 [ %797, %745 ], [ %721, %719 ]
  %725 = getelementptr i8, ptr %190, i64 32
  %726 = load i64, ptr %725, align 8, !noalias !73
  %727 = shl nsw i64 %726, 3
  %728 = load i64, ptr %232, align 8, !noalias !73
  br label %729

729:                                              ; preds = %723, %743
  %730 = phi i64 [ %733, %743 ], [ %724, %723 ]
  %731 = call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %730, i1 true)
  %732 = add nsw i64 %730, -1
  %733 = and i64 %730, %732
  %734 = getelementptr i64, ptr %187, i64 %731
  %735 = load i64, ptr %734, align 8, !noalias !73
  %736 = add nsw i64 %735, 8
  store i64 %736, ptr %734, align 8, !noalias !73
  %737 = call i64 @llvm.smax.i64(i64 %728, i64 0)
  br label %738

738:                                              ; preds = %729, %799
  %739 = phi i64 [ 0, %729 ], [ %801, %799 ]
  %740 = phi i64 [ %737, %729 ], [ %800, %799 ]
  %741 = phi i64 [ %735, %729 ], [ %810, %799 ]
  %742 = icmp sgt i64 %740, 0
  br i1 %742, label %799, label %743

743:                                              ; preds = %738
  %744 = icmp eq i64 %733, 0
  br i1 %744, label %745, label %729

745:                                              ; preds = %743
  %746 = load <8 x double>, ptr %152, align 8, !noalias !73
  %747 = trunc i64 %724 to i8
  %748 = bitcast i8 %747 to <8 x i1>
  %749 = select <8 x i1> %748, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %750 = fadd <8 x double> %746, %749
  store <8 x double> %750, ptr %152, align 8, !noalias !73
  %751 = extractelement <8 x double> %750, i64 0
  %752 = fptosi double %751 to i64
  %753 = getelementptr double, ptr %198, i64 %752
  %754 = load double, ptr %753, align 8, !noalias !73
  %755 = insertelement <8 x double> poison, double %754, i64 0
  %756 = extractelement <8 x double> %750, i64 1
  %757 = fptosi double %756 to i64
  %758 = getelementptr double, ptr %198, i64 %757
  %759 = load double, ptr %758, align 8, !noalias !73
  %760 = insertelement <8 x double> %755, double %759, i64 1
  %761 = extractelement <8 x double> %750, i64 2
  %762 = fptosi double %761 to i64
  %763 = getelementptr double, ptr %198, i64 %762
  %764 = load double, ptr %763, align 8, !noalias !73
  %765 = insertelement <8 x double> %760, double %764, i64 2
  %766 = extractelement <8 x double> %750, i64 3
  %767 = fptosi double %766 to i64
  %768 = getelementptr double, ptr %198, i64 %767
  %769 = load double, ptr %768, align 8, !noalias !73
  %770 = insertelement <8 x double> %765, double %769, i64 3
  %771 = extractelement <8 x double> %750, i64 4
  %772 = fptosi double %771 to i64
  %773 = getelementptr double, ptr %198, i64 %772
  %774 = load double, ptr %773, align 8, !noalias !73
  %775 = insertelement <8 x double> %770, double %774, i64 4
  %776 = extractelement <8 x double> %750, i64 5
  %777 = fptosi double %776 to i64
  %778 = getelementptr double, ptr %198, i64 %777
  %779 = load double, ptr %778, align 8, !noalias !73
  %780 = insertelement <8 x double> %775, double %779, i64 5
  %781 = extractelement <8 x double> %750, i64 6
  %782 = fptosi double %781 to i64
  %783 = getelementptr double, ptr %198, i64 %782
  %784 = load double, ptr %783, align 8, !noalias !73
  %785 = insertelement <8 x double> %780, double %784, i64 6
  %786 = extractelement <8 x double> %750, i64 7
  %787 = fptosi double %786 to i64
  %788 = getelementptr double, ptr %198, i64 %787
  %789 = load double, ptr %788, align 8, !noalias !73
  %790 = insertelement <8 x double> %785, double %789, i64 7
  store <8 x double> %790, ptr %157, align 8, !noalias !73
  %791 = load double, ptr %198, align 8, !noalias !48
  %792 = insertelement <8 x double> poison, double %791, i64 0
  %793 = shufflevector <8 x double> %792, <8 x double> poison, <8 x i32> zeroinitializer
  %794 = fcmp oeq <8 x double> %790, %793
  %795 = bitcast <8 x i1> %794 to i8
  %796 = zext i8 %795 to i64
  %797 = and i64 %724, %796
  %798 = icmp eq i64 %797, 0
  br i1 %798, label %811, label %723

799:                                              ; preds = %738
  %800 = add nsw i64 %740, -1
  %801 = add i64 %739, 1
  %802 = shl nsw i64 %739, 3
  %803 = add nsw i64 %802, %731
  %804 = icmp slt i64 %803, 0
  %805 = select i1 %804, i64 %87, i64 0
  %806 = getelementptr double, ptr %88, i64 %803
  %807 = getelementptr double, ptr %806, i64 %805
  %808 = load i64, ptr %807, align 8, !noalias !73
  %809 = inttoptr i64 %741 to ptr
  store atomic i64 %808, ptr %809 unordered, align 8, !noalias !73
  %810 = add nsw i64 %741, %727
  br label %738

811:                                              ; preds = %745, %719
  br label %812

812:                                              ; preds = %841, %811, %967
  %813 = phi i64 [ 0, %811 ], [ %987, %967 ], [ %987, %841 ]
  %814 = phi i64 [ 8, %811 ], [ %986, %967 ], [ %986, %841 ]
  %815 = icmp sgt i64 %814, 0
  br i1 %815, label %985, label %991

816:                                              ; preds = %985
  %817 = icmp slt i64 %813, 0
  %818 = select i1 %817, i64 %181, i64 0
  %819 = getelementptr i64, ptr %182, i64 %813
  %820 = getelementptr i64, ptr %819, i64 %818
  %821 = load i64, ptr %820, align 8, !noalias !77
  %822 = getelementptr i8, ptr %190, i64 32
  %823 = load i64, ptr %822, align 8, !noalias !77
  %824 = shl nsw i64 %823, 3
  %825 = select i1 %817, i64 %151, i64 0
  %826 = getelementptr double, ptr %152, i64 %813
  %827 = getelementptr double, ptr %826, i64 %825
  %828 = load double, ptr %827, align 8, !noalias !77
  %829 = fptosi double %828 to i64
  %830 = xor i64 %829, -1
  %831 = add i64 %197, %830
  %832 = call i64 @llvm.smax.i64(i64 %831, i64 0)
  br label %833

833:                                              ; preds = %837, %816
  %834 = phi i64 [ 0, %816 ], [ %874, %837 ]
  %835 = phi i64 [ %832, %816 ], [ %873, %837 ]
  %836 = icmp sgt i64 %835, 0
  br i1 %836, label %872, label %841

837:                                              ; preds = %872, %883
  %838 = phi i64 [ %882, %872 ], [ %884, %883 ]
  %839 = phi i64 [ %880, %872 ], [ %886, %883 ]
  %840 = icmp sgt i64 %838, 0
  br i1 %840, label %883, label %833

841:                                              ; preds = %833
  %842 = icmp slt i64 %821, 0
  %843 = select i1 %842, i64 %223, i64 0
  %844 = add i64 %821, %843
  %845 = mul i64 %844, %225
  %846 = getelementptr i64, ptr %226, i64 %845
  %847 = select i1 %817, i64 %161, i64 0
  %848 = getelementptr double, ptr %162, i64 %813
  %849 = getelementptr double, ptr %848, i64 %847
  %850 = load double, ptr %849, align 8, !noalias !77
  %851 = select i1 %817, i64 %166, i64 0
  %852 = getelementptr double, ptr %167, i64 %813
  %853 = getelementptr double, ptr %852, i64 %851
  %854 = load double, ptr %853, align 8, !noalias !77
  %855 = fptosi double %850 to i64
  store i64 %855, ptr %846, align 8, !noalias !77
  %856 = getelementptr i8, ptr %846, i64 8
  %857 = fptosi double %854 to i64
  store i64 %857, ptr %856, align 8, !noalias !77
  %858 = select i1 %817, i64 %171, i64 0
  %859 = getelementptr double, ptr %172, i64 %813
  %860 = getelementptr double, ptr %859, i64 %858
  %861 = load double, ptr %860, align 8, !noalias !77
  %862 = getelementptr i8, ptr %846, i64 16
  %863 = fptosi double %861 to i64
  store i64 %863, ptr %862, align 8, !noalias !77
  %864 = getelementptr i8, ptr %846, i64 24
  store i64 3, ptr %864, align 8, !noalias !77
  %865 = select i1 %817, i64 %135, i64 0
  %866 = getelementptr double, ptr %136, i64 %813
  %867 = getelementptr double, ptr %866, i64 %865
  %868 = load double, ptr %867, align 8, !noalias !77
  %869 = select i1 %842, i64 %230, i64 0
  %870 = getelementptr double, ptr %231, i64 %821
  %871 = getelementptr double, ptr %870, i64 %869
  store double %868, ptr %871, align 8, !noalias !77
  store i64 -1, ptr %820, align 8, !noalias !77
  br label %812

872:                                              ; preds = %833
  %873 = add nsw i64 %835, -1
  %874 = add i64 %834, 1
  %875 = shl nsw i64 %834, 3
  %876 = select i1 %817, i64 %186, i64 0
  %877 = getelementptr i64, ptr %187, i64 %813
  %878 = getelementptr i64, ptr %877, i64 %876
  %879 = load i64, ptr %878, align 8, !noalias !77
  %880 = add nsw i64 %879, %875
  %881 = load i64, ptr %232, align 8, !noalias !77
  %882 = call i64 @llvm.smax.i64(i64 %881, i64 0)
  br label %837

883:                                              ; preds = %837
  %884 = add nsw i64 %838, -1
  %885 = inttoptr i64 %839 to ptr
  store atomic i64 9221120237041090560, ptr %885 unordered, align 8, !noalias !77
  %886 = add nsw i64 %839, %824
  br label %837

887:                                              ; preds = %985
  %888 = and i64 %274, %988
  %889 = icmp eq i64 %888, 0
  br i1 %889, label %967, label %890

890:                                              ; preds = %887
  %891 = icmp slt i64 %813, 0
  %892 = select i1 %891, i64 %156, i64 0
  %893 = getelementptr double, ptr %157, i64 %813
  %894 = getelementptr double, ptr %893, i64 %892
  %895 = load double, ptr %894, align 8, !noalias !48
  %896 = fcmp oeq double %895, 0x7FF0000000000000
  br i1 %896, label %897, label %967

897:                                              ; preds = %890
  %898 = select i1 %891, i64 %181, i64 0
  %899 = getelementptr i64, ptr %182, i64 %813
  %900 = getelementptr i64, ptr %899, i64 %898
  %901 = load i64, ptr %900, align 8, !noalias !81
  %902 = getelementptr i8, ptr %190, i64 32
  %903 = load i64, ptr %902, align 8, !noalias !81
  %904 = shl nsw i64 %903, 3
  %905 = select i1 %891, i64 %151, i64 0
  %906 = getelementptr double, ptr %152, i64 %813
  %907 = getelementptr double, ptr %906, i64 %905
  %908 = load double, ptr %907, align 8, !noalias !81
  %909 = fptosi double %908 to i64
  %910 = xor i64 %909, -1
  %911 = add i64 %197, %910
  %912 = call i64 @llvm.smax.i64(i64 %911, i64 0)
  br label %913

913:                                              ; preds = %917, %897
  %914 = phi i64 [ 0, %897 ], [ %954, %917 ]
  %915 = phi i64 [ %912, %897 ], [ %953, %917 ]
  %916 = icmp sgt i64 %915, 0
  br i1 %916, label %952, label %921

917:                                              ; preds = %952, %963
  %918 = phi i64 [ %962, %952 ], [ %964, %963 ]
  %919 = phi i64 [ %960, %952 ], [ %966, %963 ]
  %920 = icmp sgt i64 %918, 0
  br i1 %920, label %963, label %913

921:                                              ; preds = %913
  %922 = icmp slt i64 %901, 0
  %923 = select i1 %922, i64 %223, i64 0
  %924 = add i64 %901, %923
  %925 = mul i64 %924, %225
  %926 = getelementptr i64, ptr %226, i64 %925
  %927 = select i1 %891, i64 %161, i64 0
  %928 = getelementptr double, ptr %162, i64 %813
  %929 = getelementptr double, ptr %928, i64 %927
  %930 = load double, ptr %929, align 8, !noalias !81
  %931 = select i1 %891, i64 %166, i64 0
  %932 = getelementptr double, ptr %167, i64 %813
  %933 = getelementptr double, ptr %932, i64 %931
  %934 = load double, ptr %933, align 8, !noalias !81
  %935 = fptosi double %930 to i64
  store i64 %935, ptr %926, align 8, !noalias !81
  %936 = getelementptr i8, ptr %926, i64 8
  %937 = fptosi double %934 to i64
  store i64 %937, ptr %936, align 8, !noalias !81
  %938 = select i1 %891, i64 %171, i64 0
  %939 = getelementptr double, ptr %172, i64 %813
  %940 = getelementptr double, ptr %939, i64 %938
  %941 = load double, ptr %940, align 8, !noalias !81
  %942 = getelementptr i8, ptr %926, i64 16
  %943 = fptosi double %941 to i64
  store i64 %943, ptr %942, align 8, !noalias !81
  %944 = getelementptr i8, ptr %926, i64 24
  store i64 0, ptr %944, align 8, !noalias !81
  %945 = select i1 %891, i64 %135, i64 0
  %946 = getelementptr double, ptr %136, i64 %813
  %947 = getelementptr double, ptr %946, i64 %945
  %948 = load double, ptr %947, align 8, !noalias !81
  %949 = select i1 %922, i64 %230, i64 0
  %950 = getelementptr double, ptr %231, i64 %901
  %951 = getelementptr double, ptr %950, i64 %949
  store double %948, ptr %951, align 8, !noalias !81
  store i64 -1, ptr %900, align 8, !noalias !81
  br label %967

952:                                              ; preds = %913
  %953 = add nsw i64 %915, -1
  %954 = add i64 %914, 1
  %955 = shl nsw i64 %914, 3
  %956 = select i1 %891, i64 %186, i64 0
  %957 = getelementptr i64, ptr %187, i64 %813
  %958 = getelementptr i64, ptr %957, i64 %956
  %959 = load i64, ptr %958, align 8, !noalias !81
  %960 = add nsw i64 %959, %955
  %961 = load i64, ptr %232, align 8, !noalias !81
  %962 = call i64 @llvm.smax.i64(i64 %961, i64 0)
  br label %917

963:                                              ; preds = %917
  %964 = add nsw i64 %918, -1
  %965 = inttoptr i64 %919 to ptr
  store atomic i64 9221120237041090560, ptr %965 unordered, align 8, !noalias !81
  %966 = add nsw i64 %919, %904
  br label %917

967:                                              ; preds = %921, %890, %887
  br label %812

968:                                              ; preds = %512
  %969 = call i64 @llvm.smax.i64(i64 %499, i64 0)
  br label %515

970:                                              ; preds = %515
  %971 = add nsw i64 %517, -1
  %972 = add i64 %516, 1
  %973 = shl i64 %516, 6
  %974 = getelementptr i8, ptr %98, i64 %973
  %975 = load <8 x double>, ptr %974, align 8, !noalias !48
  %976 = getelementptr i8, ptr %116, i64 %973
  %977 = load <8 x double>, ptr %976, align 8, !noalias !48
  %978 = select <8 x i1> %501, <8 x double> %975, <8 x double> %977
  store <8 x double> %978, ptr %976, align 8, !noalias !48
  br label %515

979:                                              ; preds = %692
  %980 = add nsw i64 %694, -1
  %981 = add i64 %693, 1
  %982 = shl nuw i64 1, %693
  %983 = and i64 %274, %982
  %984 = icmp eq i64 %983, 0
  br i1 %984, label %718, label %696

985:                                              ; preds = %812
  %986 = add nsw i64 %814, -1
  %987 = add i64 %813, 1
  %988 = shl nuw i64 1, %813
  %989 = and i64 %513, %988
  %990 = icmp eq i64 %989, 0
  br i1 %990, label %887, label %816

991:                                              ; preds = %812, %1003
  %992 = phi i64 [ %2144, %1003 ], [ 0, %812 ]
  %993 = phi i64 [ %2143, %1003 ], [ 8, %812 ]
  %994 = phi i1 [ %1004, %1003 ], [ false, %812 ]
  %995 = icmp sgt i64 %993, 0
  br i1 %995, label %2142, label %1005

996:                                              ; preds = %2142
  %997 = icmp slt i64 %992, 0
  %998 = select i1 %997, i64 %181, i64 0
  %999 = getelementptr i64, ptr %182, i64 %992
  %1000 = getelementptr i64, ptr %999, i64 %998
  %1001 = load i64, ptr %1000, align 8, !noalias !12
  %1002 = icmp eq i64 %1001, -1
  br label %1003

1003:                                             ; preds = %996, %2142
  %1004 = phi i1 [ true, %2142 ], [ %1002, %996 ]
  br label %991

1005:                                             ; preds = %991
  br i1 %994, label %270, label %1006

1006:                                             ; preds = %496, %1005, %267
  %1007 = phi i64 [ %268, %267 ], [ %275, %1005 ], [ %275, %496 ]
  %1008 = phi i1 [ false, %267 ], [ false, %1005 ], [ true, %496 ]
  %1009 = getelementptr i8, ptr %190, i64 8
  %1010 = load i64, ptr %1009, align 8, !noalias !12
  %1011 = icmp slt i64 %1010, 1
  br i1 %1011, label %1012, label %1013

1012:                                             ; preds = %1006
  br label %2194

1013:                                             ; preds = %1006
  %1014 = add nsw i64 %1010, -1
  store i64 %1014, ptr %1009, align 8, !noalias !12
  %1015 = load <8 x double>, ptr %136, align 8, !noalias !12
  %1016 = load <8 x double>, ptr %141, align 8, !noalias !12
  %1017 = trunc i64 %1007 to i8
  %1018 = bitcast i8 %1017 to <8 x i1>
  br i1 %248, label %1019, label %1026

1019:                                             ; preds = %1013
  %1020 = insertelement <8 x double> poison, double %239, i64 0
  %1021 = shufflevector <8 x double> %1020, <8 x double> poison, <8 x i32> zeroinitializer
  %1022 = insertelement <8 x double> poison, double %240, i64 0
  %1023 = shufflevector <8 x double> %1022, <8 x double> poison, <8 x i32> zeroinitializer
  %1024 = fcmp olt <8 x double> %1016, %1023
  %1025 = select <8 x i1> %1024, <8 x double> %1016, <8 x double> %1023
  br label %1033

1026:                                             ; preds = %1013
  %1027 = load <8 x double>, ptr %157, align 8, !noalias !12
  %1028 = fsub <8 x double> %1027, %1015
  %1029 = fdiv <8 x double> %1028, %1016
  %1030 = fmul <8 x double> %1029, splat (double 0x3FEFFFFFFFFFDCD1)
  %1031 = call <8 x double> @llvm.ceil.v8f64(<8 x double> %1030)
  %1032 = fdiv <8 x double> %1028, %1031
  br label %1033

1033:                                             ; preds = %1026, %1019
  %1034 = phi <8 x double> [ %1021, %1019 ], [ %1027, %1026 ]
  %1035 = phi <8 x double> [ %1025, %1019 ], [ %1032, %1026 ]
  %1036 = fadd <8 x double> %1015, %1035
  %1037 = fmul <8 x double> %1035, splat (double 1.000000e-03)
  %1038 = fsub <8 x double> %1034, %1037
  %1039 = fcmp ogt <8 x double> %1036, %1038
  %1040 = fsub <8 x double> %1034, %1015
  %1041 = select <8 x i1> %1039, <8 x double> %1040, <8 x double> %1035
  %1042 = select <8 x i1> %1039, <8 x double> %1034, <8 x double> %1036
  %1043 = select <8 x i1> %1018, <8 x double> %1041, <8 x double> zeroinitializer
  %1044 = fmul <8 x double> %1043, splat (double 6.250000e-02)
  %1045 = fadd <8 x double> %1015, %1044
  %1046 = fcmp ule <8 x double> %1045, %1015
  %1047 = fcmp une <8 x double> %1042, %1034
  %1048 = and <8 x i1> %1046, %1047
  %1049 = load <8 x double>, ptr %162, align 8, !noalias !12
  %1050 = load <8 x double>, ptr %167, align 8, !noalias !12
  %1051 = fadd <8 x double> %1049, %1050
  %1052 = insertelement <8 x double> poison, double %259, i64 0
  %1053 = shufflevector <8 x double> %1052, <8 x double> poison, <8 x i32> zeroinitializer
  %1054 = fcmp oge <8 x double> %1051, %1053
  %1055 = or <8 x i1> %1054, %1048
  %1056 = and <8 x i1> %1055, %1018
  %1057 = bitcast <8 x i1> %1056 to i8
  %1058 = zext i8 %1057 to i64
  %1059 = icmp eq i8 %1057, 0
  br i1 %1059, label %1156, label %1060

1060:                                             ; preds = %1033
  %1061 = bitcast <8 x i1> %1054 to i8
  %1062 = zext i8 %1061 to i64
  br label %1063

1063:                                             ; preds = %1060, %1149
  %1064 = phi i64 [ 0, %1060 ], [ %1152, %1149 ]
  %1065 = phi i64 [ 8, %1060 ], [ %1151, %1149 ]
  %1066 = icmp sgt i64 %1065, 0
  br i1 %1066, label %1150, label %265

1067:                                             ; preds = %1150
  %1068 = and i64 %1153, %1062
  %1069 = icmp eq i64 %1068, 0
  br i1 %1069, label %1070, label %1077

1070:                                             ; preds = %1067
  %1071 = icmp slt i64 %1064, 0
  %1072 = select i1 %1071, i64 %176, i64 0
  %1073 = getelementptr double, ptr %177, i64 %1064
  %1074 = getelementptr double, ptr %1073, i64 %1072
  %1075 = load double, ptr %1074, align 8, !noalias !85
  %1076 = fptosi double %1075 to i64
  br label %1077

1077:                                             ; preds = %1067, %1070
  %1078 = phi i64 [ %1076, %1070 ], [ 1, %1067 ]
  %1079 = icmp slt i64 %1064, 0
  %1080 = select i1 %1079, i64 %181, i64 0
  %1081 = getelementptr i64, ptr %182, i64 %1064
  %1082 = getelementptr i64, ptr %1081, i64 %1080
  %1083 = load i64, ptr %1082, align 8, !noalias !89
  %1084 = getelementptr i8, ptr %190, i64 32
  %1085 = load i64, ptr %1084, align 8, !noalias !89
  %1086 = shl nsw i64 %1085, 3
  %1087 = select i1 %1079, i64 %151, i64 0
  %1088 = getelementptr double, ptr %152, i64 %1064
  %1089 = getelementptr double, ptr %1088, i64 %1087
  %1090 = load double, ptr %1089, align 8, !noalias !89
  %1091 = fptosi double %1090 to i64
  %1092 = xor i64 %1091, -1
  %1093 = add i64 %197, %1092
  %1094 = call i64 @llvm.smax.i64(i64 %1093, i64 0)
  br label %1095

1095:                                             ; preds = %1099, %1077
  %1096 = phi i64 [ 0, %1077 ], [ %1136, %1099 ]
  %1097 = phi i64 [ %1094, %1077 ], [ %1135, %1099 ]
  %1098 = icmp sgt i64 %1097, 0
  br i1 %1098, label %1134, label %1103

1099:                                             ; preds = %1134, %1145
  %1100 = phi i64 [ %1144, %1134 ], [ %1146, %1145 ]
  %1101 = phi i64 [ %1142, %1134 ], [ %1148, %1145 ]
  %1102 = icmp sgt i64 %1100, 0
  br i1 %1102, label %1145, label %1095

1103:                                             ; preds = %1095
  %1104 = icmp slt i64 %1083, 0
  %1105 = select i1 %1104, i64 %223, i64 0
  %1106 = add i64 %1083, %1105
  %1107 = mul i64 %1106, %225
  %1108 = getelementptr i64, ptr %226, i64 %1107
  %1109 = select i1 %1079, i64 %161, i64 0
  %1110 = getelementptr double, ptr %162, i64 %1064
  %1111 = getelementptr double, ptr %1110, i64 %1109
  %1112 = load double, ptr %1111, align 8, !noalias !89
  %1113 = select i1 %1079, i64 %166, i64 0
  %1114 = getelementptr double, ptr %167, i64 %1064
  %1115 = getelementptr double, ptr %1114, i64 %1113
  %1116 = load double, ptr %1115, align 8, !noalias !89
  %1117 = fptosi double %1112 to i64
  store i64 %1117, ptr %1108, align 8, !noalias !89
  %1118 = getelementptr i8, ptr %1108, i64 8
  %1119 = fptosi double %1116 to i64
  store i64 %1119, ptr %1118, align 8, !noalias !89
  %1120 = select i1 %1079, i64 %171, i64 0
  %1121 = getelementptr double, ptr %172, i64 %1064
  %1122 = getelementptr double, ptr %1121, i64 %1120
  %1123 = load double, ptr %1122, align 8, !noalias !89
  %1124 = getelementptr i8, ptr %1108, i64 16
  %1125 = fptosi double %1123 to i64
  store i64 %1125, ptr %1124, align 8, !noalias !89
  %1126 = getelementptr i8, ptr %1108, i64 24
  store i64 %1078, ptr %1126, align 8, !noalias !89
  %1127 = select i1 %1079, i64 %135, i64 0
  %1128 = getelementptr double, ptr %136, i64 %1064
  %1129 = getelementptr double, ptr %1128, i64 %1127
  %1130 = load double, ptr %1129, align 8, !noalias !89
  %1131 = select i1 %1104, i64 %230, i64 0
  %1132 = getelementptr double, ptr %231, i64 %1083
  %1133 = getelementptr double, ptr %1132, i64 %1131
  store double %1130, ptr %1133, align 8, !noalias !89
  store i64 -1, ptr %1082, align 8, !noalias !89
  br label %1149

1134:                                             ; preds = %1095
  %1135 = add nsw i64 %1097, -1
  %1136 = add i64 %1096, 1
  %1137 = shl nsw i64 %1096, 3
  %1138 = select i1 %1079, i64 %186, i64 0
  %1139 = getelementptr i64, ptr %187, i64 %1064
  %1140 = getelementptr i64, ptr %1139, i64 %1138
  %1141 = load i64, ptr %1140, align 8, !noalias !89
  %1142 = add nsw i64 %1141, %1137
  %1143 = load i64, ptr %232, align 8, !noalias !89
  %1144 = call i64 @llvm.smax.i64(i64 %1143, i64 0)
  br label %1099

1145:                                             ; preds = %1099
  %1146 = add nsw i64 %1100, -1
  %1147 = inttoptr i64 %1101 to ptr
  store atomic i64 9221120237041090560, ptr %1147 unordered, align 8, !noalias !89
  %1148 = add nsw i64 %1101, %1086
  br label %1099

1149:                                             ; preds = %1103, %1150
  br label %1063

1150:                                             ; preds = %1063
  %1151 = add nsw i64 %1065, -1
  %1152 = add i64 %1064, 1
  %1153 = shl nuw i64 1, %1064
  %1154 = and i64 %1153, %1058
  %1155 = icmp eq i64 %1154, 0
  br i1 %1155, label %1149, label %1067

1156:                                             ; preds = %1033
  store <8 x double> %1043, ptr %101, align 8, !noalias !93
  %1157 = load i64, ptr %19, align 8, !noalias !93
  %1158 = add i64 %1157, -1
  %1159 = call i64 @llvm.smax.i64(i64 %1158, i64 0)
  br label %1160

1160:                                             ; preds = %1218, %1156
  %1161 = phi i64 [ 1, %1156 ], [ %1186, %1218 ]
  %1162 = phi i64 [ %1159, %1156 ], [ %1185, %1218 ]
  %1163 = phi i64 [ 0, %1156 ], [ %1224, %1218 ]
  %1164 = icmp sgt i64 %1162, 0
  br i1 %1164, label %1184, label %1165

1165:                                             ; preds = %1160
  %1166 = load i64, ptr %19, align 8, !noalias !93
  %1167 = icmp slt i64 %1166, 0
  %1168 = select i1 %1167, i64 %23, i64 0
  %1169 = getelementptr i64, ptr %24, i64 %1166
  %1170 = getelementptr i64, ptr %1169, i64 %1168
  %1171 = load i64, ptr %1170, align 8, !noalias !97
  %1172 = shl i64 %1171, 3
  %1173 = add i64 %26, %1172
  %1174 = add i64 %28, %1172
  %1175 = icmp slt i64 %1166, -1
  %1176 = select i1 %1175, i64 %23, i64 0
  %1177 = getelementptr i8, ptr %1169, i64 8
  %1178 = getelementptr i64, ptr %1177, i64 %1176
  %1179 = load i64, ptr %1178, align 8, !noalias !97
  %1180 = xor i64 %1171, -1
  %1181 = add i64 %1179, %1180
  %1182 = getelementptr i8, ptr %39, i64 16
  %1183 = load i64, ptr %1182, align 8, !noalias !97
  call fastcc void @pydy_combine(i64 %90, i64 %85, i64 %100, i64 %113, i64 %1173, i64 %1174, i64 %1181, i64 1, i64 %1183) #3, !noalias !97
  br i1 %251, label %1237, label %1226

1184:                                             ; preds = %1160
  %1185 = add nsw i64 %1162, -1
  %1186 = add i64 %1161, 1
  %1187 = icmp slt i64 %1161, 0
  %1188 = select i1 %1187, i64 %23, i64 0
  %1189 = getelementptr i64, ptr %24, i64 %1161
  %1190 = getelementptr i64, ptr %1189, i64 %1188
  %1191 = load i64, ptr %1190, align 8, !noalias !103
  %1192 = shl i64 %1191, 3
  %1193 = add i64 %26, %1192
  %1194 = add i64 %28, %1192
  %1195 = icmp slt i64 %1161, -1
  %1196 = select i1 %1195, i64 %23, i64 0
  %1197 = getelementptr i8, ptr %1189, i64 8
  %1198 = getelementptr i64, ptr %1197, i64 %1196
  %1199 = load i64, ptr %1198, align 8, !noalias !103
  %1200 = xor i64 %1191, -1
  %1201 = add i64 %1199, %1200
  %1202 = getelementptr i8, ptr %39, i64 16
  %1203 = load i64, ptr %1202, align 8, !noalias !103
  call fastcc void @pydy_combine(i64 %95, i64 %85, i64 %100, i64 %113, i64 %1193, i64 %1194, i64 %1201, i64 1, i64 %1203) #3, !noalias !103
  %1204 = mul nsw i64 %1161, %87
  %1205 = shl i64 %1204, 3
  %1206 = add i64 %113, %1205
  %1207 = select i1 %1187, i64 %32, i64 0
  %1208 = getelementptr double, ptr %33, i64 %1161
  %1209 = getelementptr double, ptr %1208, i64 %1207
  %1210 = load double, ptr %1209, align 8, !noalias !93
  %1211 = insertelement <8 x double> poison, double %1210, i64 0
  %1212 = shufflevector <8 x double> %1211, <8 x double> poison, <8 x i32> zeroinitializer
  %1213 = fmul <8 x double> %1212, %1043
  %1214 = fadd <8 x double> %1015, %1213
  store ptr null, ptr %8, align 8, !noalias !109
  store ptr null, ptr %9, align 8, !noalias !109
  store <8 x double> %1214, ptr %44, align 8, !noalias !109
  %1215 = icmp sgt i64 %61, 0
  br i1 %1215, label %1216, label %1218

1216:                                             ; preds = %1184
  store ptr null, ptr %8, align 8, !noalias !109
  %1217 = call fastcc i32 @_set_inputs(ptr nonnull %8, ptr nonnull %44, i64 %43, ptr %49, i64 %48, ptr %64, i64 %61, i64 %63, ptr %71, i64 %68, i64 %70, ptr %76, i64 %75, ptr %83, i64 %80, i64 %82) #3
  switch i32 %1217, label %1225 [
    i32 -2, label %1218
    i32 0, label %1218
  ], !prof !56

1218:                                             ; preds = %1216, %1216, %1184
  %1219 = load i64, ptr %39, align 8, !noalias !109
  %1220 = inttoptr i64 %1219 to ptr
  %1221 = inttoptr i64 %1206 to ptr
  %1222 = call i32 %1220(ptr nonnull %44, ptr %98, ptr %49, ptr %57, ptr %1221) #3, !noalias !109
  %1223 = sext i32 %1222 to i64
  %1224 = or i64 %1163, %1223
  br label %1160

1225:                                             ; preds = %1216
  br label %2194

1226:                                             ; preds = %1165
  store ptr null, ptr %6, align 8, !noalias !113
  store ptr null, ptr %7, align 8, !noalias !113
  store <8 x double> %1042, ptr %44, align 8, !noalias !113
  %1227 = icmp sgt i64 %61, 0
  br i1 %1227, label %1228, label %1230

1228:                                             ; preds = %1226
  store ptr null, ptr %6, align 8, !noalias !113
  %1229 = call fastcc i32 @_set_inputs(ptr nonnull %6, ptr nonnull %44, i64 %43, ptr %49, i64 %48, ptr %64, i64 %61, i64 %63, ptr %71, i64 %68, i64 %70, ptr %76, i64 %75, ptr %83, i64 %80, i64 %82) #3
  switch i32 %1229, label %2145 [
    i32 -2, label %1230
    i32 0, label %1230
  ], !prof !56

1230:                                             ; preds = %1228, %1228, %1226
  %1231 = load i64, ptr %39, align 8, !noalias !113
  %1232 = inttoptr i64 %1231 to ptr
  %1233 = inttoptr i64 %244 to ptr
  %1234 = call i32 %1232(ptr nonnull %44, ptr %93, ptr %49, ptr %57, ptr %1233) #3, !noalias !113
  %1235 = sext i32 %1234 to i64
  %1236 = or i64 %1163, %1235
  br label %1237

1237:                                             ; preds = %1230, %1165
  %1238 = phi i64 [ %1236, %1230 ], [ %1163, %1165 ]
  br i1 %248, label %1239, label %1349

1239:                                             ; preds = %1237
  %1240 = load i64, ptr %232, align 8, !noalias !117
  %1241 = load i64, ptr %246, align 8, !noalias !117
  %1242 = load i64, ptr %19, align 8, !noalias !117
  %1243 = add nsw i64 %1242, 1
  %1244 = call i64 @llvm.smax.i64(i64 %1241, i64 0)
  br label %1245

1245:                                             ; preds = %1239, %1274
  %1246 = phi i64 [ 0, %1239 ], [ %1276, %1274 ]
  %1247 = phi i64 [ %1244, %1239 ], [ %1275, %1274 ]
  %1248 = icmp sgt i64 %1247, 0
  br i1 %1248, label %1274, label %1297

1249:                                             ; preds = %1307, %1311
  %1250 = phi i64 [ 0, %1307 ], [ %1313, %1311 ]
  %1251 = phi i64 [ %1310, %1307 ], [ %1312, %1311 ]
  %1252 = phi <8 x double> [ zeroinitializer, %1307 ], [ %1348, %1311 ]
  %1253 = phi <8 x double> [ zeroinitializer, %1307 ], [ %1346, %1311 ]
  %1254 = icmp sgt i64 %1251, 0
  br i1 %1254, label %1311, label %1255

1255:                                             ; preds = %1249
  %1256 = icmp eq i64 %1241, 2
  br i1 %1256, label %1257, label %1268

1257:                                             ; preds = %1255
  %1258 = fcmp oeq <8 x double> %1253, zeroinitializer
  %1259 = fmul <8 x double> %1252, splat (double 1.000000e-02)
  %1260 = fadd <8 x double> %1253, %1259
  %1261 = sitofp i64 %1240 to double
  %1262 = insertelement <8 x double> poison, double %1261, i64 0
  %1263 = shufflevector <8 x double> %1262, <8 x double> poison, <8 x i32> zeroinitializer
  %1264 = fmul <8 x double> %1260, %1263
  %1265 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1264)
  %1266 = fdiv <8 x double> %1253, %1265
  %1267 = select <8 x i1> %1258, <8 x double> zeroinitializer, <8 x double> %1266
  br label %1356

1268:                                             ; preds = %1255
  %1269 = sitofp i64 %1240 to double
  %1270 = insertelement <8 x double> poison, double %1269, i64 0
  %1271 = shufflevector <8 x double> %1270, <8 x double> poison, <8 x i32> zeroinitializer
  %1272 = fdiv <8 x double> %1253, %1271
  %1273 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1272)
  br label %1356

1274:                                             ; preds = %1245
  %1275 = add nsw i64 %1247, -1
  %1276 = add i64 %1246, 1
  %1277 = add nsw i64 %1243, %1246
  %1278 = mul nsw i64 %1246, %87
  %1279 = shl i64 %1278, 3
  %1280 = add i64 %108, %1279
  %1281 = icmp slt i64 %1277, 0
  %1282 = select i1 %1281, i64 %23, i64 0
  %1283 = getelementptr i64, ptr %24, i64 %1277
  %1284 = getelementptr i64, ptr %1283, i64 %1282
  %1285 = load i64, ptr %1284, align 8, !noalias !121
  %1286 = shl i64 %1285, 3
  %1287 = add i64 %26, %1286
  %1288 = add i64 %28, %1286
  %1289 = icmp slt i64 %1277, -1
  %1290 = select i1 %1289, i64 %23, i64 0
  %1291 = getelementptr i8, ptr %1283, i64 8
  %1292 = getelementptr i64, ptr %1291, i64 %1290
  %1293 = load i64, ptr %1292, align 8, !noalias !121
  %1294 = xor i64 %1285, -1
  %1295 = add i64 %1293, %1294
  %1296 = load i64, ptr %1182, align 8, !noalias !121
  call fastcc void @pydy_combine(i64 %1280, i64 %106, i64 %100, i64 %113, i64 %1287, i64 %1288, i64 %1295, i64 1, i64 %1296) #3, !noalias !121
  br label %1245

1297:                                             ; preds = %1245
  %1298 = icmp slt i64 %87, 0
  %1299 = select i1 %1298, i64 %110, i64 0
  %1300 = add i64 %87, %1299
  %1301 = icmp slt i64 %1300, 0
  br i1 %1301, label %1302, label %1303, !prof !4

1302:                                             ; preds = %1297
  br label %1303

1303:                                             ; preds = %1302, %1297
  %1304 = phi i64 [ 0, %1302 ], [ %1300, %1297 ]
  %1305 = icmp slt i64 %1300, %110
  br i1 %1305, label %1307, label %1306, !prof !8

1306:                                             ; preds = %1303
  br label %1307

1307:                                             ; preds = %1306, %1303
  %1308 = phi i64 [ %110, %1306 ], [ %1304, %1303 ]
  %1309 = getelementptr double, ptr %111, i64 %1308
  %1310 = call i64 @llvm.smax.i64(i64 %1240, i64 0)
  br label %1249

1311:                                             ; preds = %1249
  %1312 = add nsw i64 %1251, -1
  %1313 = add i64 %1250, 1
  %1314 = shl i64 %1250, 6
  %1315 = getelementptr i8, ptr %88, i64 %1314
  %1316 = load <8 x double>, ptr %1315, align 8, !noalias !117
  %1317 = getelementptr i8, ptr %93, i64 %1314
  %1318 = load <8 x double>, ptr %1317, align 8, !noalias !117
  %1319 = icmp slt i64 %1250, 0
  %1320 = select i1 %1319, i64 %130, i64 0
  %1321 = getelementptr double, ptr %131, i64 %1250
  %1322 = getelementptr double, ptr %1321, i64 %1320
  %1323 = load double, ptr %1322, align 8, !noalias !127
  %1324 = select i1 %1319, i64 %125, i64 0
  %1325 = getelementptr double, ptr %126, i64 %1250
  %1326 = getelementptr double, ptr %1325, i64 %1324
  %1327 = load double, ptr %1326, align 8, !noalias !127
  %1328 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1316)
  %1329 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1318)
  %1330 = fcmp ogt <8 x double> %1328, %1329
  %1331 = select <8 x i1> %1330, <8 x double> %1328, <8 x double> %1329
  %1332 = insertelement <8 x double> poison, double %1327, i64 0
  %1333 = shufflevector <8 x double> %1332, <8 x double> poison, <8 x i32> zeroinitializer
  %1334 = fmul <8 x double> %1333, %1331
  %1335 = insertelement <8 x double> poison, double %1323, i64 0
  %1336 = shufflevector <8 x double> %1335, <8 x double> poison, <8 x i32> zeroinitializer
  %1337 = fadd <8 x double> %1336, %1334
  %1338 = fdiv <8 x double> splat (double 1.000000e+00), %1337
  %1339 = getelementptr i8, ptr %111, i64 %1314
  %1340 = load <8 x double>, ptr %1339, align 8, !noalias !117
  %1341 = fmul <8 x double> %1340, %1338
  %1342 = getelementptr i8, ptr %1309, i64 %1314
  %1343 = load <8 x double>, ptr %1342, align 8, !noalias !117
  %1344 = fmul <8 x double> %1343, %1338
  %1345 = fmul <8 x double> %1341, %1341
  %1346 = fadd <8 x double> %1253, %1345
  %1347 = fmul <8 x double> %1344, %1344
  %1348 = fadd <8 x double> %1252, %1347
  br label %1249

1349:                                             ; preds = %1237
  %1350 = call i64 @llvm.smax.i64(i64 %233, i64 0)
  br label %1351

1351:                                             ; preds = %1349, %2146
  %1352 = phi i64 [ 0, %1349 ], [ %2148, %2146 ]
  %1353 = phi i64 [ %1350, %1349 ], [ %2147, %2146 ]
  %1354 = phi <8 x double> [ zeroinitializer, %1349 ], [ %2153, %2146 ]
  %1355 = icmp sgt i64 %1353, 0
  br i1 %1355, label %2146, label %1356

1356:                                             ; preds = %1351, %1257, %1268
  %1357 = phi <8 x double> [ %1354, %1351 ], [ %1273, %1268 ], [ %1267, %1257 ]
  %1358 = fcmp olt <8 x double> %1357, splat (double 1.000000e+00)
  %1359 = trunc i64 %1238 to i8
  %1360 = bitcast i8 %1359 to <8 x i1>
  %1361 = xor <8 x i1> %1360, splat (i1 true)
  %1362 = and <8 x i1> %1358, %1361
  %1363 = and <8 x i1> %1362, %1018
  %1364 = bitcast <8 x i1> %1363 to i8
  %1365 = icmp ne i8 %1364, 0
  %1366 = select i1 %251, i1 %1365, i1 false
  br i1 %1366, label %1367, label %1382

1367:                                             ; preds = %1356
  store ptr null, ptr %4, align 8, !noalias !130
  store ptr null, ptr %5, align 8, !noalias !130
  store <8 x double> %1042, ptr %44, align 8, !noalias !130
  %1368 = icmp sgt i64 %61, 0
  br i1 %1368, label %1369, label %1371

1369:                                             ; preds = %1367
  store ptr null, ptr %4, align 8, !noalias !130
  %1370 = call fastcc i32 @_set_inputs(ptr nonnull %4, ptr nonnull %44, i64 %43, ptr %49, i64 %48, ptr %64, i64 %61, i64 %63, ptr %71, i64 %68, i64 %70, ptr %76, i64 %75, ptr %83, i64 %80, i64 %82) #3
  switch i32 %1370, label %2154 [
    i32 -2, label %1371
    i32 0, label %1371
  ], !prof !56

1371:                                             ; preds = %1369, %1369, %1367
  %1372 = load i64, ptr %39, align 8, !noalias !130
  %1373 = inttoptr i64 %1372 to ptr
  %1374 = inttoptr i64 %244 to ptr
  %1375 = call i32 %1373(ptr nonnull %44, ptr %93, ptr %49, ptr %57, ptr %1374) #3, !noalias !130
  %1376 = sext i32 %1375 to i64
  %1377 = or i64 %1238, %1376
  %1378 = trunc i64 %1377 to i8
  %1379 = bitcast i8 %1378 to <8 x i1>
  %1380 = xor <8 x i1> %1379, splat (i1 true)
  %1381 = and <8 x i1> %1363, %1380
  br label %1382

1382:                                             ; preds = %1371, %1356
  %1383 = phi i64 [ %1238, %1356 ], [ %1377, %1371 ]
  %1384 = phi <8 x i1> [ %1363, %1356 ], [ %1381, %1371 ]
  %1385 = load <8 x double>, ptr %172, align 8, !noalias !12
  %1386 = insertelement <8 x double> poison, double %254, i64 0
  %1387 = shufflevector <8 x double> %1386, <8 x double> poison, <8 x i32> zeroinitializer
  %1388 = fadd <8 x double> %1385, %1387
  %1389 = insertelement <8 x double> poison, double %256, i64 0
  %1390 = shufflevector <8 x double> %1389, <8 x double> poison, <8 x i32> zeroinitializer
  %1391 = select <8 x i1> %1363, <8 x double> %1390, <8 x double> zeroinitializer
  %1392 = fadd <8 x double> %1388, %1391
  store <8 x double> %1392, ptr %172, align 8, !noalias !12
  %1393 = load <8 x double>, ptr %157, align 8, !noalias !12
  %1394 = fcmp olt <8 x double> %1393, %1042
  %1395 = and <8 x i1> %1384, %1394
  %1396 = bitcast <8 x i1> %1395 to i8
  %1397 = icmp eq i8 %1396, 0
  br i1 %1397, label %1739, label %1398

1398:                                             ; preds = %1382
  %1399 = load i64, ptr %19, align 8, !noalias !134
  %1400 = getelementptr i8, ptr %19, i64 16
  %1401 = load i64, ptr %1400, align 8, !noalias !134
  %1402 = call i64 @llvm.smax.i64(i64 %1401, i64 0)
  br label %1403

1403:                                             ; preds = %1547, %1398
  %1404 = phi i64 [ %1399, %1398 ], [ %1407, %1547 ]
  %1405 = phi i64 [ %1402, %1398 ], [ %1513, %1547 ]
  %1406 = phi i64 [ 0, %1398 ], [ %1553, %1547 ]
  %1407 = add i64 %1404, 1
  %1408 = icmp sgt i64 %1405, 0
  br i1 %1408, label %1512, label %1409

1409:                                             ; preds = %1403
  %1410 = load i64, ptr %232, align 8, !noalias !138
  %1411 = load i64, ptr %19, align 8, !noalias !138
  %1412 = mul nsw i64 %1411, %87
  %1413 = icmp slt i64 %1412, 0
  %1414 = select i1 %1413, i64 %115, i64 0
  %1415 = add i64 %1412, %1414
  %1416 = icmp slt i64 %1415, 0
  br i1 %1416, label %1435, label %1436, !prof !4

1417:                                             ; preds = %1463, %1467
  %1418 = phi i64 [ 0, %1463 ], [ %1469, %1467 ]
  %1419 = phi i64 [ %1466, %1463 ], [ %1468, %1467 ]
  %1420 = icmp sgt i64 %1419, 0
  br i1 %1420, label %1467, label %1421

1421:                                             ; preds = %1417
  %1422 = add nsw i64 %1411, 1
  %1423 = load i64, ptr %246, align 8, !noalias !138
  %1424 = add nsw i64 %1422, %1423
  %1425 = load i64, ptr %1400, align 8, !noalias !138
  %1426 = add nsw i64 %1424, %1425
  %1427 = getelementptr i8, ptr %19, i64 24
  %1428 = load i64, ptr %1427, align 8, !noalias !138
  %1429 = add i64 %1428, -3
  %1430 = call i64 @llvm.smax.i64(i64 %1429, i64 0)
  br label %1431

1431:                                             ; preds = %1421, %1488
  %1432 = phi i64 [ 3, %1421 ], [ %1490, %1488 ]
  %1433 = phi i64 [ %1430, %1421 ], [ %1489, %1488 ]
  %1434 = icmp sgt i64 %1433, 0
  br i1 %1434, label %1488, label %2155

1435:                                             ; preds = %1409
  br label %1436

1436:                                             ; preds = %1435, %1409
  %1437 = phi i64 [ 0, %1435 ], [ %1415, %1409 ]
  %1438 = icmp slt i64 %1415, %115
  br i1 %1438, label %1440, label %1439, !prof !8

1439:                                             ; preds = %1436
  br label %1440

1440:                                             ; preds = %1439, %1436
  %1441 = phi i64 [ %115, %1439 ], [ %1437, %1436 ]
  %1442 = getelementptr double, ptr %116, i64 %1441
  %1443 = icmp slt i64 %87, 0
  %1444 = select i1 %1443, i64 %120, i64 0
  %1445 = add i64 %87, %1444
  %1446 = icmp slt i64 %1445, 0
  br i1 %1446, label %1447, label %1448, !prof !4

1447:                                             ; preds = %1440
  br label %1448

1448:                                             ; preds = %1447, %1440
  %1449 = phi i64 [ 0, %1447 ], [ %1445, %1440 ]
  %1450 = icmp slt i64 %1445, %120
  br i1 %1450, label %1452, label %1451, !prof !8

1451:                                             ; preds = %1448
  br label %1452

1452:                                             ; preds = %1451, %1448
  %1453 = phi i64 [ %120, %1451 ], [ %1449, %1448 ]
  %1454 = getelementptr double, ptr %121, i64 %1453
  %1455 = shl nsw i64 %87, 1
  %1456 = add i64 %1455, %1444
  %1457 = icmp slt i64 %1456, 0
  br i1 %1457, label %1458, label %1459, !prof !4

1458:                                             ; preds = %1452
  br label %1459

1459:                                             ; preds = %1458, %1452
  %1460 = phi i64 [ 0, %1458 ], [ %1456, %1452 ]
  %1461 = icmp slt i64 %1456, %120
  br i1 %1461, label %1463, label %1462, !prof !8

1462:                                             ; preds = %1459
  br label %1463

1463:                                             ; preds = %1462, %1459
  %1464 = phi i64 [ %120, %1462 ], [ %1460, %1459 ]
  %1465 = getelementptr double, ptr %121, i64 %1464
  %1466 = call i64 @llvm.smax.i64(i64 %1410, i64 0)
  br label %1417

1467:                                             ; preds = %1417
  %1468 = add nsw i64 %1419, -1
  %1469 = add i64 %1418, 1
  %1470 = shl i64 %1418, 6
  %1471 = getelementptr i8, ptr %93, i64 %1470
  %1472 = load <8 x double>, ptr %1471, align 8, !noalias !138
  %1473 = getelementptr i8, ptr %88, i64 %1470
  %1474 = load <8 x double>, ptr %1473, align 8, !noalias !138
  %1475 = fsub <8 x double> %1472, %1474
  %1476 = getelementptr i8, ptr %116, i64 %1470
  %1477 = load <8 x double>, ptr %1476, align 8, !noalias !138
  %1478 = fmul <8 x double> %1043, %1477
  %1479 = fsub <8 x double> %1478, %1475
  %1480 = getelementptr i8, ptr %121, i64 %1470
  store <8 x double> %1475, ptr %1480, align 8, !noalias !138
  %1481 = getelementptr i8, ptr %1454, i64 %1470
  store <8 x double> %1479, ptr %1481, align 8, !noalias !138
  %1482 = fsub <8 x double> %1475, %1479
  %1483 = getelementptr i8, ptr %1442, i64 %1470
  %1484 = load <8 x double>, ptr %1483, align 8, !noalias !138
  %1485 = fmul <8 x double> %1043, %1484
  %1486 = fsub <8 x double> %1482, %1485
  %1487 = getelementptr i8, ptr %1465, i64 %1470
  store <8 x double> %1486, ptr %1487, align 8, !noalias !138
  br label %1417

1488:                                             ; preds = %1431
  %1489 = add nsw i64 %1433, -1
  %1490 = add i64 %1432, 1
  %1491 = mul nsw i64 %1432, %87
  %1492 = shl i64 %1491, 3
  %1493 = add i64 %118, %1492
  %1494 = add nsw i64 %1426, %1432
  %1495 = icmp slt i64 %1494, 3
  %1496 = select i1 %1495, i64 %23, i64 0
  %1497 = getelementptr i64, ptr %24, i64 %1494
  %1498 = getelementptr i8, ptr %1497, i64 -24
  %1499 = getelementptr i64, ptr %1498, i64 %1496
  %1500 = load i64, ptr %1499, align 8, !noalias !142
  %1501 = shl i64 %1500, 3
  %1502 = add i64 %26, %1501
  %1503 = add i64 %28, %1501
  %1504 = icmp slt i64 %1494, 2
  %1505 = select i1 %1504, i64 %23, i64 0
  %1506 = getelementptr i8, ptr %1497, i64 -16
  %1507 = getelementptr i64, ptr %1506, i64 %1505
  %1508 = load i64, ptr %1507, align 8, !noalias !142
  %1509 = xor i64 %1500, -1
  %1510 = add i64 %1508, %1509
  %1511 = load i64, ptr %1182, align 8, !noalias !142
  call fastcc void @pydy_combine(i64 %1493, i64 %106, i64 %100, i64 %113, i64 %1502, i64 %1503, i64 %1510, i64 1, i64 %1511) #3, !noalias !142
  br label %1431

1512:                                             ; preds = %1403
  %1513 = add nsw i64 %1405, -1
  %1514 = load i64, ptr %246, align 8, !noalias !134
  %1515 = add nsw i64 %1407, %1514
  %1516 = icmp slt i64 %1515, 0
  %1517 = select i1 %1516, i64 %23, i64 0
  %1518 = getelementptr i64, ptr %24, i64 %1515
  %1519 = getelementptr i64, ptr %1518, i64 %1517
  %1520 = load i64, ptr %1519, align 8, !noalias !148
  %1521 = shl i64 %1520, 3
  %1522 = add i64 %26, %1521
  %1523 = add i64 %28, %1521
  %1524 = icmp slt i64 %1515, -1
  %1525 = select i1 %1524, i64 %23, i64 0
  %1526 = getelementptr i8, ptr %1518, i64 8
  %1527 = getelementptr i64, ptr %1526, i64 %1525
  %1528 = load i64, ptr %1527, align 8, !noalias !148
  %1529 = xor i64 %1520, -1
  %1530 = add i64 %1528, %1529
  %1531 = load i64, ptr %1182, align 8, !noalias !148
  call fastcc void @pydy_combine(i64 %95, i64 %85, i64 %100, i64 %113, i64 %1522, i64 %1523, i64 %1530, i64 1, i64 %1531) #3, !noalias !148
  %1532 = mul nsw i64 %1407, %87
  %1533 = shl i64 %1532, 3
  %1534 = add i64 %113, %1533
  %1535 = icmp slt i64 %1407, 0
  %1536 = select i1 %1535, i64 %32, i64 0
  %1537 = getelementptr double, ptr %33, i64 %1407
  %1538 = getelementptr double, ptr %1537, i64 %1536
  %1539 = load double, ptr %1538, align 8, !noalias !134
  %1540 = insertelement <8 x double> poison, double %1539, i64 0
  %1541 = shufflevector <8 x double> %1540, <8 x double> poison, <8 x i32> zeroinitializer
  %1542 = fmul <8 x double> %1541, %1043
  %1543 = fadd <8 x double> %1015, %1542
  store ptr null, ptr %2, align 8, !noalias !154
  store ptr null, ptr %3, align 8, !noalias !154
  store <8 x double> %1543, ptr %44, align 8, !noalias !154
  %1544 = icmp sgt i64 %61, 0
  br i1 %1544, label %1545, label %1547

1545:                                             ; preds = %1512
  store ptr null, ptr %2, align 8, !noalias !154
  %1546 = call fastcc i32 @_set_inputs(ptr nonnull %2, ptr nonnull %44, i64 %43, ptr %49, i64 %48, ptr %64, i64 %61, i64 %63, ptr %71, i64 %68, i64 %70, ptr %76, i64 %75, ptr %83, i64 %80, i64 %82) #3
  switch i32 %1546, label %1554 [
    i32 -2, label %1547
    i32 0, label %1547
  ], !prof !56

1547:                                             ; preds = %1545, %1545, %1512
  %1548 = load i64, ptr %39, align 8, !noalias !154
  %1549 = inttoptr i64 %1548 to ptr
  %1550 = inttoptr i64 %1534 to ptr
  %1551 = call i32 %1549(ptr nonnull %44, ptr %98, ptr %49, ptr %57, ptr %1550) #3, !noalias !154
  %1552 = sext i32 %1551 to i64
  %1553 = or i64 %1406, %1552
  br label %1403

1554:                                             ; preds = %1545
  br label %2194

1555:                                             ; preds = %2155, %1630
  %1556 = phi i64 [ %2168, %1630 ], [ 0, %2155 ]
  %1557 = phi i64 [ %2167, %1630 ], [ 8, %2155 ]
  %1558 = icmp sgt i64 %1557, 0
  br i1 %1558, label %2166, label %1631

1559:                                             ; preds = %2166
  %1560 = icmp slt i64 %1556, 0
  %1561 = select i1 %1560, i64 %181, i64 0
  %1562 = getelementptr i64, ptr %182, i64 %1556
  %1563 = getelementptr i64, ptr %1562, i64 %1561
  %1564 = load i64, ptr %1563, align 8, !noalias !158
  %1565 = getelementptr i8, ptr %190, i64 32
  %1566 = load i64, ptr %1565, align 8, !noalias !158
  %1567 = shl nsw i64 %1566, 3
  %1568 = select i1 %1560, i64 %151, i64 0
  %1569 = getelementptr double, ptr %152, i64 %1556
  %1570 = getelementptr double, ptr %1569, i64 %1568
  %1571 = load double, ptr %1570, align 8, !noalias !158
  %1572 = fptosi double %1571 to i64
  %1573 = xor i64 %1572, -1
  %1574 = add i64 %197, %1573
  %1575 = call i64 @llvm.smax.i64(i64 %1574, i64 0)
  br label %1576

1576:                                             ; preds = %1580, %1559
  %1577 = phi i64 [ 0, %1559 ], [ %1617, %1580 ]
  %1578 = phi i64 [ %1575, %1559 ], [ %1616, %1580 ]
  %1579 = icmp sgt i64 %1578, 0
  br i1 %1579, label %1615, label %1584

1580:                                             ; preds = %1615, %1626
  %1581 = phi i64 [ %1625, %1615 ], [ %1627, %1626 ]
  %1582 = phi i64 [ %1623, %1615 ], [ %1629, %1626 ]
  %1583 = icmp sgt i64 %1581, 0
  br i1 %1583, label %1626, label %1576

1584:                                             ; preds = %1576
  %1585 = icmp slt i64 %1564, 0
  %1586 = select i1 %1585, i64 %223, i64 0
  %1587 = add i64 %1564, %1586
  %1588 = mul i64 %1587, %225
  %1589 = getelementptr i64, ptr %226, i64 %1588
  %1590 = select i1 %1560, i64 %161, i64 0
  %1591 = getelementptr double, ptr %162, i64 %1556
  %1592 = getelementptr double, ptr %1591, i64 %1590
  %1593 = load double, ptr %1592, align 8, !noalias !158
  %1594 = select i1 %1560, i64 %166, i64 0
  %1595 = getelementptr double, ptr %167, i64 %1556
  %1596 = getelementptr double, ptr %1595, i64 %1594
  %1597 = load double, ptr %1596, align 8, !noalias !158
  %1598 = fptosi double %1593 to i64
  store i64 %1598, ptr %1589, align 8, !noalias !158
  %1599 = getelementptr i8, ptr %1589, i64 8
  %1600 = fptosi double %1597 to i64
  store i64 %1600, ptr %1599, align 8, !noalias !158
  %1601 = select i1 %1560, i64 %171, i64 0
  %1602 = getelementptr double, ptr %172, i64 %1556
  %1603 = getelementptr double, ptr %1602, i64 %1601
  %1604 = load double, ptr %1603, align 8, !noalias !158
  %1605 = getelementptr i8, ptr %1589, i64 16
  %1606 = fptosi double %1604 to i64
  store i64 %1606, ptr %1605, align 8, !noalias !158
  %1607 = getelementptr i8, ptr %1589, i64 24
  store i64 3, ptr %1607, align 8, !noalias !158
  %1608 = select i1 %1560, i64 %135, i64 0
  %1609 = getelementptr double, ptr %136, i64 %1556
  %1610 = getelementptr double, ptr %1609, i64 %1608
  %1611 = load double, ptr %1610, align 8, !noalias !158
  %1612 = select i1 %1585, i64 %230, i64 0
  %1613 = getelementptr double, ptr %231, i64 %1564
  %1614 = getelementptr double, ptr %1613, i64 %1612
  store double %1611, ptr %1614, align 8, !noalias !158
  store i64 -1, ptr %1563, align 8, !noalias !158
  br label %1630

1615:                                             ; preds = %1576
  %1616 = add nsw i64 %1578, -1
  %1617 = add i64 %1577, 1
  %1618 = shl nsw i64 %1577, 3
  %1619 = select i1 %1560, i64 %186, i64 0
  %1620 = getelementptr i64, ptr %187, i64 %1556
  %1621 = getelementptr i64, ptr %1620, i64 %1619
  %1622 = load i64, ptr %1621, align 8, !noalias !158
  %1623 = add nsw i64 %1622, %1618
  %1624 = load i64, ptr %232, align 8, !noalias !158
  %1625 = call i64 @llvm.smax.i64(i64 %1624, i64 0)
  br label %1580

1626:                                             ; preds = %1580
  %1627 = add nsw i64 %1581, -1
  %1628 = inttoptr i64 %1582 to ptr
  store atomic i64 9221120237041090560, ptr %1628 unordered, align 8, !noalias !158
  %1629 = add nsw i64 %1582, %1567
  br label %1580

1630:                                             ; preds = %1584, %2166
  br label %1555

1631:                                             ; preds = %1555
  %1632 = xor i64 %2157, -1
  %1633 = and i64 %1007, %1632
  %1634 = trunc i64 %1633 to i8
  %1635 = bitcast i8 %1634 to <8 x i1>
  %1636 = and <8 x i1> %1384, %1635
  %1637 = and <8 x i1> %1395, %1635
  br label %1638

1638:                                             ; preds = %2155, %1631
  %1639 = phi i64 [ %1633, %1631 ], [ %1007, %2155 ]
  %1640 = phi i1 [ true, %1631 ], [ %1008, %2155 ]
  %1641 = phi <8 x i1> [ %1636, %1631 ], [ %1384, %2155 ]
  %1642 = phi <8 x i1> [ %1637, %1631 ], [ %1395, %2155 ]
  %1643 = bitcast <8 x i1> %1642 to i8
  %1644 = zext i8 %1643 to i64
  %1645 = load <8 x double>, ptr %136, align 8, !noalias !162
  %1646 = load <8 x double>, ptr %101, align 8, !noalias !162
  %1647 = icmp eq i8 %1643, 0
  br i1 %1647, label %1739, label %1648

1648:                                             ; preds = %1638, %1676
  %1649 = phi i64 [ %1725, %1676 ], [ %1644, %1638 ]
  %1650 = load <8 x double>, ptr %157, align 8, !noalias !162
  %1651 = fsub <8 x double> %1650, %1645
  %1652 = fdiv <8 x double> %1651, %1646
  store <8 x double> %1652, ptr %104, align 8, !noalias !162
  %1653 = load i64, ptr %1427, align 8, !noalias !162
  %1654 = load i64, ptr %232, align 8, !noalias !162
  call fastcc void @pydy_nested(i64 %95, i64 %85, i64 %118, i64 %87, i64 %1653, i64 %103, i64 %1654) #3, !noalias !162
  %1655 = getelementptr i8, ptr %190, i64 32
  %1656 = load i64, ptr %1655, align 8, !noalias !166
  %1657 = shl nsw i64 %1656, 3
  %1658 = load i64, ptr %232, align 8, !noalias !166
  %1659 = icmp eq i64 %1649, 0
  br i1 %1659, label %1676, label %1660

1660:                                             ; preds = %1648, %1674
  %1661 = phi i64 [ %1664, %1674 ], [ %1649, %1648 ]
  %1662 = call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %1661, i1 true)
  %1663 = add nsw i64 %1661, -1
  %1664 = and i64 %1661, %1663
  %1665 = getelementptr i64, ptr %187, i64 %1662
  %1666 = load i64, ptr %1665, align 8, !noalias !166
  %1667 = add nsw i64 %1666, 8
  store i64 %1667, ptr %1665, align 8, !noalias !166
  %1668 = call i64 @llvm.smax.i64(i64 %1658, i64 0)
  br label %1669

1669:                                             ; preds = %1660, %1727
  %1670 = phi i64 [ 0, %1660 ], [ %1729, %1727 ]
  %1671 = phi i64 [ %1668, %1660 ], [ %1728, %1727 ]
  %1672 = phi i64 [ %1666, %1660 ], [ %1738, %1727 ]
  %1673 = icmp sgt i64 %1671, 0
  br i1 %1673, label %1727, label %1674

1674:                                             ; preds = %1669
  %1675 = icmp eq i64 %1664, 0
  br i1 %1675, label %1676, label %1660

1676:                                             ; preds = %1674, %1648
  %1677 = load <8 x double>, ptr %152, align 8, !noalias !166
  %1678 = trunc i64 %1649 to i8
  %1679 = bitcast i8 %1678 to <8 x i1>
  %1680 = select <8 x i1> %1679, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %1681 = fadd <8 x double> %1677, %1680
  store <8 x double> %1681, ptr %152, align 8, !noalias !166
  %1682 = extractelement <8 x double> %1681, i64 0
  %1683 = fptosi double %1682 to i64
  %1684 = getelementptr double, ptr %198, i64 %1683
  %1685 = load double, ptr %1684, align 8, !noalias !166
  %1686 = insertelement <8 x double> poison, double %1685, i64 0
  %1687 = extractelement <8 x double> %1681, i64 1
  %1688 = fptosi double %1687 to i64
  %1689 = getelementptr double, ptr %198, i64 %1688
  %1690 = load double, ptr %1689, align 8, !noalias !166
  %1691 = insertelement <8 x double> %1686, double %1690, i64 1
  %1692 = extractelement <8 x double> %1681, i64 2
  %1693 = fptosi double %1692 to i64
  %1694 = getelementptr double, ptr %198, i64 %1693
  %1695 = load double, ptr %1694, align 8, !noalias !166
  %1696 = insertelement <8 x double> %1691, double %1695, i64 2
  %1697 = extractelement <8 x double> %1681, i64 3
  %1698 = fptosi double %1697 to i64
  %1699 = getelementptr double, ptr %198, i64 %1698
  %1700 = load double, ptr %1699, align 8, !noalias !166
  %1701 = insertelement <8 x double> %1696, double %1700, i64 3
  %1702 = extractelement <8 x double> %1681, i64 4
  %1703 = fptosi double %1702 to i64
  %1704 = getelementptr double, ptr %198, i64 %1703
  %1705 = load double, ptr %1704, align 8, !noalias !166
  %1706 = insertelement <8 x double> %1701, double %1705, i64 4
  %1707 = extractelement <8 x double> %1681, i64 5
  %1708 = fptosi double %1707 to i64
  %1709 = getelementptr double, ptr %198, i64 %1708
  %1710 = load double, ptr %1709, align 8, !noalias !166
  %1711 = insertelement <8 x double> %1706, double %1710, i64 5
  %1712 = extractelement <8 x double> %1681, i64 6
  %1713 = fptosi double %1712 to i64
  %1714 = getelementptr double, ptr %198, i64 %1713
  %1715 = load double, ptr %1714, align 8, !noalias !166
  %1716 = insertelement <8 x double> %1711, double %1715, i64 6
  %1717 = extractelement <8 x double> %1681, i64 7
  %1718 = fptosi double %1717 to i64
  %1719 = getelementptr double, ptr %198, i64 %1718
  %1720 = load double, ptr %1719, align 8, !noalias !166
  %1721 = insertelement <8 x double> %1716, double %1720, i64 7
  store <8 x double> %1721, ptr %157, align 8, !noalias !166
  %1722 = fcmp olt <8 x double> %1721, %1042
  %1723 = bitcast <8 x i1> %1722 to i8
  %1724 = zext i8 %1723 to i64
  %1725 = and i64 %1649, %1724
  %1726 = icmp eq i64 %1725, 0
  br i1 %1726, label %1739, label %1648

1727:                                             ; preds = %1669
  %1728 = add nsw i64 %1671, -1
  %1729 = add i64 %1670, 1
  %1730 = shl nsw i64 %1670, 3
  %1731 = add nsw i64 %1730, %1662
  %1732 = icmp slt i64 %1731, 0
  %1733 = select i1 %1732, i64 %97, i64 0
  %1734 = getelementptr double, ptr %98, i64 %1731
  %1735 = getelementptr double, ptr %1734, i64 %1733
  %1736 = load i64, ptr %1735, align 8, !noalias !166
  %1737 = inttoptr i64 %1672 to ptr
  store atomic i64 %1736, ptr %1737 unordered, align 8, !noalias !166
  %1738 = add nsw i64 %1672, %1657
  br label %1669

1739:                                             ; preds = %1676, %1638, %1382
  %1740 = phi i64 [ %1007, %1382 ], [ %1639, %1638 ], [ %1639, %1676 ]
  %1741 = phi i1 [ %1008, %1382 ], [ %1640, %1638 ], [ %1640, %1676 ]
  %1742 = phi <8 x i1> [ %1384, %1382 ], [ %1641, %1638 ], [ %1641, %1676 ]
  %1743 = load <8 x double>, ptr %157, align 8, !noalias !12
  %1744 = fcmp oeq <8 x double> %1743, %1042
  %1745 = and <8 x i1> %1742, %1744
  %1746 = bitcast <8 x i1> %1745 to i8
  %1747 = zext i8 %1746 to i64
  %1748 = icmp eq i8 %1746, 0
  br i1 %1748, label %1835, label %1749

1749:                                             ; preds = %1739, %1772
  %1750 = phi i64 [ %1821, %1772 ], [ %1747, %1739 ]
  %1751 = getelementptr i8, ptr %190, i64 32
  %1752 = load i64, ptr %1751, align 8, !noalias !170
  %1753 = shl nsw i64 %1752, 3
  %1754 = load i64, ptr %232, align 8, !noalias !170
  %1755 = icmp eq i64 %1750, 0
  br i1 %1755, label %1772, label %1756

1756:                                             ; preds = %1749, %1770
  %1757 = phi i64 [ %1760, %1770 ], [ %1750, %1749 ]
  %1758 = call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %1757, i1 true)
  %1759 = add nsw i64 %1757, -1
  %1760 = and i64 %1757, %1759
  %1761 = getelementptr i64, ptr %187, i64 %1758
  %1762 = load i64, ptr %1761, align 8, !noalias !170
  %1763 = add nsw i64 %1762, 8
  store i64 %1763, ptr %1761, align 8, !noalias !170
  %1764 = call i64 @llvm.smax.i64(i64 %1754, i64 0)
  br label %1765

1765:                                             ; preds = %1756, %1823
  %1766 = phi i64 [ 0, %1756 ], [ %1825, %1823 ]
  %1767 = phi i64 [ %1764, %1756 ], [ %1824, %1823 ]
  %1768 = phi i64 [ %1762, %1756 ], [ %1834, %1823 ]
  %1769 = icmp sgt i64 %1767, 0
  br i1 %1769, label %1823, label %1770

1770:                                             ; preds = %1765
  %1771 = icmp eq i64 %1760, 0
  br i1 %1771, label %1772, label %1756

1772:                                             ; preds = %1770, %1749
  %1773 = load <8 x double>, ptr %152, align 8, !noalias !170
  %1774 = trunc i64 %1750 to i8
  %1775 = bitcast i8 %1774 to <8 x i1>
  %1776 = select <8 x i1> %1775, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %1777 = fadd <8 x double> %1773, %1776
  store <8 x double> %1777, ptr %152, align 8, !noalias !170
  %1778 = extractelement <8 x double> %1777, i64 0
  %1779 = fptosi double %1778 to i64
  %1780 = getelementptr double, ptr %198, i64 %1779
  %1781 = load double, ptr %1780, align 8, !noalias !170
  %1782 = insertelement <8 x double> poison, double %1781, i64 0
  %1783 = extractelement <8 x double> %1777, i64 1
  %1784 = fptosi double %1783 to i64
  %1785 = getelementptr double, ptr %198, i64 %1784
  %1786 = load double, ptr %1785, align 8, !noalias !170
  %1787 = insertelement <8 x double> %1782, double %1786, i64 1
  %1788 = extractelement <8 x double> %1777, i64 2
  %1789 = fptosi double %1788 to i64
  %1790 = getelementptr double, ptr %198, i64 %1789
  %1791 = load double, ptr %1790, align 8, !noalias !170
  %1792 = insertelement <8 x double> %1787, double %1791, i64 2
  %1793 = extractelement <8 x double> %1777, i64 3
  %1794 = fptosi double %1793 to i64
  %1795 = getelementptr double, ptr %198, i64 %1794
  %1796 = load double, ptr %1795, align 8, !noalias !170
  %1797 = insertelement <8 x double> %1792, double %1796, i64 3
  %1798 = extractelement <8 x double> %1777, i64 4
  %1799 = fptosi double %1798 to i64
  %1800 = getelementptr double, ptr %198, i64 %1799
  %1801 = load double, ptr %1800, align 8, !noalias !170
  %1802 = insertelement <8 x double> %1797, double %1801, i64 4
  %1803 = extractelement <8 x double> %1777, i64 5
  %1804 = fptosi double %1803 to i64
  %1805 = getelementptr double, ptr %198, i64 %1804
  %1806 = load double, ptr %1805, align 8, !noalias !170
  %1807 = insertelement <8 x double> %1802, double %1806, i64 5
  %1808 = extractelement <8 x double> %1777, i64 6
  %1809 = fptosi double %1808 to i64
  %1810 = getelementptr double, ptr %198, i64 %1809
  %1811 = load double, ptr %1810, align 8, !noalias !170
  %1812 = insertelement <8 x double> %1807, double %1811, i64 6
  %1813 = extractelement <8 x double> %1777, i64 7
  %1814 = fptosi double %1813 to i64
  %1815 = getelementptr double, ptr %198, i64 %1814
  %1816 = load double, ptr %1815, align 8, !noalias !170
  %1817 = insertelement <8 x double> %1812, double %1816, i64 7
  store <8 x double> %1817, ptr %157, align 8, !noalias !170
  %1818 = fcmp oeq <8 x double> %1817, %1042
  %1819 = bitcast <8 x i1> %1818 to i8
  %1820 = zext i8 %1819 to i64
  %1821 = and i64 %1750, %1820
  %1822 = icmp eq i64 %1821, 0
  br i1 %1822, label %1835, label %1749

1823:                                             ; preds = %1765
  %1824 = add nsw i64 %1767, -1
  %1825 = add i64 %1766, 1
  %1826 = shl nsw i64 %1766, 3
  %1827 = add nsw i64 %1826, %1758
  %1828 = icmp slt i64 %1827, 0
  %1829 = select i1 %1828, i64 %92, i64 0
  %1830 = getelementptr double, ptr %93, i64 %1827
  %1831 = getelementptr double, ptr %1830, i64 %1829
  %1832 = load i64, ptr %1831, align 8, !noalias !170
  %1833 = inttoptr i64 %1768 to ptr
  store atomic i64 %1832, ptr %1833 unordered, align 8, !noalias !170
  %1834 = add nsw i64 %1768, %1753
  br label %1765

1835:                                             ; preds = %1772, %1739
  %1836 = xor <8 x i1> %1742, splat (i1 true)
  %1837 = and <8 x i1> %1018, %1836
  %1838 = load <8 x double>, ptr %162, align 8, !noalias !12
  %1839 = select <8 x i1> %1742, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %1840 = fadd <8 x double> %1838, %1839
  store <8 x double> %1840, ptr %162, align 8, !noalias !12
  br i1 %248, label %1841, label %1958

1841:                                             ; preds = %1835
  %1842 = load <8 x double>, ptr %144, align 8, !noalias !12
  %1843 = load <8 x double>, ptr %147, align 8, !noalias !12
  %1844 = getelementptr i8, ptr %36, i64 24
  %1845 = load double, ptr %1844, align 8, !noalias !174
  %1846 = fcmp ogt <8 x double> %1357, splat (double 1.000000e-10)
  %1847 = select <8 x i1> %1846, <8 x double> %1357, <8 x double> splat (double 1.000000e-10)
  %1848 = getelementptr i8, ptr %36, i64 8
  %1849 = load double, ptr %1848, align 8, !noalias !174
  %1850 = fneg double %1849
  %1851 = insertelement <8 x double> poison, double %1850, i64 0
  %1852 = shufflevector <8 x double> %1851, <8 x double> poison, <8 x i32> zeroinitializer
  %1853 = bitcast <8 x double> %1847 to <8 x i64>
  %1854 = add nsw <8 x i64> %1853, splat (i64 -4604544271217802189)
  %1855 = ashr <8 x i64> %1854, splat (i64 52)
  %1856 = and <8 x i64> %1854, splat (i64 -4503599627370496)
  %1857 = sub <8 x i64> %1853, %1856
  %1858 = bitcast <8 x i64> %1857 to <8 x double>
  %1859 = fadd <8 x double> %1858, splat (double -1.000000e+00)
  %1860 = fadd <8 x double> %1858, splat (double 1.000000e+00)
  %1861 = fdiv <8 x double> %1859, %1860
  %1862 = fmul <8 x double> %1861, %1861
  %1863 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1862, <8 x double> splat (double 0x3FD484B13D7C02A9), <8 x double> splat (double 0x3FDA61762A7ADED9))
  %1864 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1863, <8 x double> %1862, <8 x double> splat (double 0x3FE2776C50EF9BFE))
  %1865 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1864, <8 x double> %1862, <8 x double> splat (double 0x3FEEC709DC3A03FD))
  %1866 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1865, <8 x double> %1862, <8 x double> splat (double 0x40071547652B82FE))
  %1867 = fmul <8 x double> %1866, %1861
  %1868 = trunc nsw <8 x i64> %1855 to <8 x i32>
  %1869 = sitofp <8 x i32> %1868 to <8 x double>
  %1870 = fadd <8 x double> %1867, %1869
  %1871 = fmul <8 x double> %1870, %1852
  %1872 = fcmp ogt <8 x double> %1871, splat (double -1.000000e+03)
  %1873 = select <8 x i1> %1872, <8 x double> %1871, <8 x double> splat (double -1.000000e+03)
  %1874 = fcmp olt <8 x double> %1873, splat (double 1.000000e+03)
  %1875 = select <8 x i1> %1874, <8 x double> %1873, <8 x double> splat (double 1.000000e+03)
  %1876 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1875)
  %1877 = fsub <8 x double> %1875, %1876
  %1878 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1877, <8 x double> splat (double 0x3EEFFCBFC588B0C5), <8 x double> splat (double 0x3F2430912F86C786))
  %1879 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1878, <8 x double> %1877, <8 x double> splat (double 0x3F55D87FE78A6730))
  %1880 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1879, <8 x double> %1877, <8 x double> splat (double 0x3F83B2AB6FBA4E77))
  %1881 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1880, <8 x double> %1877, <8 x double> splat (double 0x3FAC6B08D704A0BF))
  %1882 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1881, <8 x double> %1877, <8 x double> splat (double 0x3FCEBFBDFF82C58E))
  %1883 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1882, <8 x double> %1877, <8 x double> splat (double 0x3FE62E42FEFA39EF))
  %1884 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1883, <8 x double> %1877, <8 x double> splat (double 1.000000e+00))
  %1885 = fptosi <8 x double> %1876 to <8 x i32>
  %1886 = zext <8 x i32> %1885 to <8 x i64>
  %1887 = shl <8 x i64> %1886, splat (i64 52)
  %1888 = bitcast <8 x double> %1884 to <8 x i64>
  %1889 = add <8 x i64> %1887, %1888
  %1890 = bitcast <8 x i64> %1889 to <8 x double>
  %1891 = insertelement <8 x double> poison, double %1845, i64 0
  %1892 = shufflevector <8 x double> %1891, <8 x double> poison, <8 x i32> zeroinitializer
  %1893 = fmul <8 x double> %1892, %1890
  %1894 = getelementptr i8, ptr %36, i64 16
  %1895 = load double, ptr %1894, align 8, !noalias !174
  %1896 = fcmp une double %1895, 0.000000e+00
  br i1 %1896, label %1897, label %1939

1897:                                             ; preds = %1841
  %1898 = insertelement <8 x double> poison, double %1895, i64 0
  %1899 = shufflevector <8 x double> %1898, <8 x double> poison, <8 x i32> zeroinitializer
  %1900 = bitcast <8 x double> %1842 to <8 x i64>
  %1901 = add <8 x i64> %1900, splat (i64 -4604544271217802189)
  %1902 = ashr <8 x i64> %1901, splat (i64 52)
  %1903 = and <8 x i64> %1901, splat (i64 -4503599627370496)
  %1904 = sub <8 x i64> %1900, %1903
  %1905 = bitcast <8 x i64> %1904 to <8 x double>
  %1906 = fadd <8 x double> %1905, splat (double -1.000000e+00)
  %1907 = fadd <8 x double> %1905, splat (double 1.000000e+00)
  %1908 = fdiv <8 x double> %1906, %1907
  %1909 = fmul <8 x double> %1908, %1908
  %1910 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1909, <8 x double> splat (double 0x3FD484B13D7C02A9), <8 x double> splat (double 0x3FDA61762A7ADED9))
  %1911 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1910, <8 x double> %1909, <8 x double> splat (double 0x3FE2776C50EF9BFE))
  %1912 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1911, <8 x double> %1909, <8 x double> splat (double 0x3FEEC709DC3A03FD))
  %1913 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1912, <8 x double> %1909, <8 x double> splat (double 0x40071547652B82FE))
  %1914 = fmul <8 x double> %1913, %1908
  %1915 = trunc nsw <8 x i64> %1902 to <8 x i32>
  %1916 = sitofp <8 x i32> %1915 to <8 x double>
  %1917 = fadd <8 x double> %1914, %1916
  %1918 = fmul <8 x double> %1917, %1899
  %1919 = fcmp ogt <8 x double> %1918, splat (double -1.000000e+03)
  %1920 = select <8 x i1> %1919, <8 x double> %1918, <8 x double> splat (double -1.000000e+03)
  %1921 = fcmp olt <8 x double> %1920, splat (double 1.000000e+03)
  %1922 = select <8 x i1> %1921, <8 x double> %1920, <8 x double> splat (double 1.000000e+03)
  %1923 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1922)
  %1924 = fsub <8 x double> %1922, %1923
  %1925 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1924, <8 x double> splat (double 0x3EEFFCBFC588B0C5), <8 x double> splat (double 0x3F2430912F86C786))
  %1926 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1925, <8 x double> %1924, <8 x double> splat (double 0x3F55D87FE78A6730))
  %1927 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1926, <8 x double> %1924, <8 x double> splat (double 0x3F83B2AB6FBA4E77))
  %1928 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1927, <8 x double> %1924, <8 x double> splat (double 0x3FAC6B08D704A0BF))
  %1929 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1928, <8 x double> %1924, <8 x double> splat (double 0x3FCEBFBDFF82C58E))
  %1930 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1929, <8 x double> %1924, <8 x double> splat (double 0x3FE62E42FEFA39EF))
  %1931 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1930, <8 x double> %1924, <8 x double> splat (double 1.000000e+00))
  %1932 = fptosi <8 x double> %1923 to <8 x i32>
  %1933 = zext <8 x i32> %1932 to <8 x i64>
  %1934 = shl <8 x i64> %1933, splat (i64 52)
  %1935 = bitcast <8 x double> %1931 to <8 x i64>
  %1936 = add <8 x i64> %1934, %1935
  %1937 = bitcast <8 x i64> %1936 to <8 x double>
  %1938 = fmul <8 x double> %1893, %1937
  br label %1939

1939:                                             ; preds = %1897, %1841
  %1940 = phi <8 x double> [ %1938, %1897 ], [ %1893, %1841 ]
  %1941 = getelementptr i8, ptr %36, i64 32
  %1942 = load double, ptr %1941, align 8, !noalias !174
  %1943 = insertelement <8 x double> poison, double %1942, i64 0
  %1944 = shufflevector <8 x double> %1943, <8 x double> poison, <8 x i32> zeroinitializer
  %1945 = fcmp ogt <8 x double> %1940, %1944
  %1946 = select <8 x i1> %1945, <8 x double> %1940, <8 x double> %1944
  %1947 = fcmp olt <8 x double> %1843, %1946
  %1948 = select <8 x i1> %1947, <8 x double> %1843, <8 x double> %1946
  %1949 = fmul <8 x double> %1043, %1948
  %1950 = fcmp ogt <8 x double> %1357, splat (double 1.000000e-04)
  %1951 = select <8 x i1> %1950, <8 x double> %1357, <8 x double> splat (double 1.000000e-04)
  %1952 = select <8 x i1> %1742, <8 x double> %1951, <8 x double> %1842
  store <8 x double> %1952, ptr %144, align 8, !noalias !12
  %1953 = getelementptr i8, ptr %36, i64 40
  %1954 = load double, ptr %1953, align 8, !noalias !12
  %1955 = insertelement <8 x double> poison, double %1954, i64 0
  %1956 = shufflevector <8 x double> %1955, <8 x double> poison, <8 x i32> zeroinitializer
  %1957 = select <8 x i1> %1837, <8 x double> splat (double 1.000000e+00), <8 x double> %1956
  store <8 x double> %1957, ptr %147, align 8, !noalias !12
  br label %1958

1958:                                             ; preds = %1939, %1835
  %1959 = phi <8 x double> [ %1949, %1939 ], [ %1016, %1835 ]
  %1960 = bitcast <8 x i1> %1837 to i8
  %1961 = icmp eq i8 %1960, 0
  br i1 %1961, label %2034, label %1962

1962:                                             ; preds = %1958
  %1963 = trunc i64 %1383 to i8
  %1964 = bitcast i8 %1963 to <8 x i1>
  %1965 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1357)
  %1966 = fcmp ueq <8 x double> %1965, splat (double 0x7FF0000000000000)
  %1967 = or <8 x i1> %1966, %1964
  %1968 = getelementptr i8, ptr %36, i64 24
  %1969 = load double, ptr %1968, align 8, !noalias !177
  %1970 = fcmp ogt <8 x double> %1357, splat (double 1.000000e-10)
  %1971 = select <8 x i1> %1970, <8 x double> %1357, <8 x double> splat (double 1.000000e-10)
  %1972 = load double, ptr %36, align 8, !noalias !177
  %1973 = fneg double %1972
  %1974 = insertelement <8 x double> poison, double %1973, i64 0
  %1975 = shufflevector <8 x double> %1974, <8 x double> poison, <8 x i32> zeroinitializer
  %1976 = bitcast <8 x double> %1971 to <8 x i64>
  %1977 = add nsw <8 x i64> %1976, splat (i64 -4604544271217802189)
  %1978 = ashr <8 x i64> %1977, splat (i64 52)
  %1979 = and <8 x i64> %1977, splat (i64 -4503599627370496)
  %1980 = sub <8 x i64> %1976, %1979
  %1981 = bitcast <8 x i64> %1980 to <8 x double>
  %1982 = fadd <8 x double> %1981, splat (double -1.000000e+00)
  %1983 = fadd <8 x double> %1981, splat (double 1.000000e+00)
  %1984 = fdiv <8 x double> %1982, %1983
  %1985 = fmul <8 x double> %1984, %1984
  %1986 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1985, <8 x double> splat (double 0x3FD484B13D7C02A9), <8 x double> splat (double 0x3FDA61762A7ADED9))
  %1987 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1986, <8 x double> %1985, <8 x double> splat (double 0x3FE2776C50EF9BFE))
  %1988 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1987, <8 x double> %1985, <8 x double> splat (double 0x3FEEC709DC3A03FD))
  %1989 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1988, <8 x double> %1985, <8 x double> splat (double 0x40071547652B82FE))
  %1990 = fmul <8 x double> %1989, %1984
  %1991 = trunc nsw <8 x i64> %1978 to <8 x i32>
  %1992 = sitofp <8 x i32> %1991 to <8 x double>
  %1993 = fadd <8 x double> %1990, %1992
  %1994 = fmul <8 x double> %1993, %1975
  %1995 = fcmp ogt <8 x double> %1994, splat (double -1.000000e+03)
  %1996 = select <8 x i1> %1995, <8 x double> %1994, <8 x double> splat (double -1.000000e+03)
  %1997 = fcmp olt <8 x double> %1996, splat (double 1.000000e+03)
  %1998 = select <8 x i1> %1997, <8 x double> %1996, <8 x double> splat (double 1.000000e+03)
  %1999 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1998)
  %2000 = fsub <8 x double> %1998, %1999
  %2001 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2000, <8 x double> splat (double 0x3EEFFCBFC588B0C5), <8 x double> splat (double 0x3F2430912F86C786))
  %2002 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2001, <8 x double> %2000, <8 x double> splat (double 0x3F55D87FE78A6730))
  %2003 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2002, <8 x double> %2000, <8 x double> splat (double 0x3F83B2AB6FBA4E77))
  %2004 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2003, <8 x double> %2000, <8 x double> splat (double 0x3FAC6B08D704A0BF))
  %2005 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2004, <8 x double> %2000, <8 x double> splat (double 0x3FCEBFBDFF82C58E))
  %2006 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2005, <8 x double> %2000, <8 x double> splat (double 0x3FE62E42FEFA39EF))
  %2007 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2006, <8 x double> %2000, <8 x double> splat (double 1.000000e+00))
  %2008 = fptosi <8 x double> %1999 to <8 x i32>
  %2009 = zext <8 x i32> %2008 to <8 x i64>
  %2010 = shl <8 x i64> %2009, splat (i64 52)
  %2011 = bitcast <8 x double> %2007 to <8 x i64>
  %2012 = add <8 x i64> %2010, %2011
  %2013 = bitcast <8 x i64> %2012 to <8 x double>
  %2014 = insertelement <8 x double> poison, double %1969, i64 0
  %2015 = shufflevector <8 x double> %2014, <8 x double> poison, <8 x i32> zeroinitializer
  %2016 = fmul <8 x double> %2015, %2013
  %2017 = getelementptr i8, ptr %36, i64 32
  %2018 = load double, ptr %2017, align 8, !noalias !177
  %2019 = insertelement <8 x double> poison, double %2018, i64 0
  %2020 = shufflevector <8 x double> %2019, <8 x double> poison, <8 x i32> zeroinitializer
  %2021 = fcmp ogt <8 x double> %2016, %2020
  %2022 = select <8 x i1> %2021, <8 x double> %2016, <8 x double> %2020
  %2023 = select <8 x i1> %1967, <8 x double> splat (double 2.500000e-01), <8 x double> %2022
  %2024 = fmul <8 x double> %1043, %2023
  %2025 = select i1 %248, <8 x double> %2024, <8 x double> zeroinitializer
  %2026 = select <8 x i1> %1837, <8 x double> %2025, <8 x double> %1959
  %2027 = select <8 x i1> %1967, <8 x double> splat (double 4.000000e+00), <8 x double> splat (double 2.000000e+00)
  %2028 = select <8 x i1> %1964, <8 x double> splat (double 3.000000e+00), <8 x double> %2027
  %2029 = load <8 x double>, ptr %177, align 8, !noalias !12
  %2030 = select <8 x i1> %1837, <8 x double> %2028, <8 x double> %2029
  store <8 x double> %2030, ptr %177, align 8, !noalias !12
  %2031 = load <8 x double>, ptr %167, align 8, !noalias !12
  %2032 = select <8 x i1> %1837, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %2033 = fadd <8 x double> %2031, %2032
  store <8 x double> %2033, ptr %167, align 8, !noalias !12
  br label %2034

2034:                                             ; preds = %1962, %1958
  %2035 = phi <8 x double> [ %2026, %1962 ], [ %1959, %1958 ]
  store <8 x double> %2035, ptr %141, align 8, !noalias !12
  %2036 = select <8 x i1> %1742, <8 x double> %1042, <8 x double> %1015
  store <8 x double> %2036, ptr %136, align 8, !noalias !12
  %2037 = call i64 @llvm.smax.i64(i64 %233, i64 0)
  br label %2038

2038:                                             ; preds = %2034, %2172
  %2039 = phi i64 [ 0, %2034 ], [ %2174, %2172 ]
  %2040 = phi i64 [ %2037, %2034 ], [ %2173, %2172 ]
  %2041 = icmp sgt i64 %2040, 0
  br i1 %2041, label %2172, label %2042

2042:                                             ; preds = %2038
  %2043 = load <8 x double>, ptr %157, align 8, !noalias !12
  %2044 = fcmp oeq <8 x double> %2043, splat (double 0x7FF0000000000000)
  %2045 = and <8 x i1> %1742, %2044
  %2046 = bitcast <8 x i1> %2045 to i8
  %2047 = zext i8 %2046 to i64
  %2048 = icmp eq i8 %2046, 0
  br i1 %2048, label %2125, label %2049

2049:                                             ; preds = %2042, %2124
  %2050 = phi i64 [ %2190, %2124 ], [ 0, %2042 ]
  %2051 = phi i64 [ %2189, %2124 ], [ 8, %2042 ]
  %2052 = icmp sgt i64 %2051, 0
  br i1 %2052, label %2188, label %2125

2053:                                             ; preds = %2188
  %2054 = icmp slt i64 %2050, 0
  %2055 = select i1 %2054, i64 %181, i64 0
  %2056 = getelementptr i64, ptr %182, i64 %2050
  %2057 = getelementptr i64, ptr %2056, i64 %2055
  %2058 = load i64, ptr %2057, align 8, !noalias !180
  %2059 = getelementptr i8, ptr %190, i64 32
  %2060 = load i64, ptr %2059, align 8, !noalias !180
  %2061 = shl nsw i64 %2060, 3
  %2062 = select i1 %2054, i64 %151, i64 0
  %2063 = getelementptr double, ptr %152, i64 %2050
  %2064 = getelementptr double, ptr %2063, i64 %2062
  %2065 = load double, ptr %2064, align 8, !noalias !180
  %2066 = fptosi double %2065 to i64
  %2067 = xor i64 %2066, -1
  %2068 = add i64 %197, %2067
  %2069 = call i64 @llvm.smax.i64(i64 %2068, i64 0)
  br label %2070

2070:                                             ; preds = %2074, %2053
  %2071 = phi i64 [ 0, %2053 ], [ %2111, %2074 ]
  %2072 = phi i64 [ %2069, %2053 ], [ %2110, %2074 ]
  %2073 = icmp sgt i64 %2072, 0
  br i1 %2073, label %2109, label %2078

2074:                                             ; preds = %2109, %2120
  %2075 = phi i64 [ %2119, %2109 ], [ %2121, %2120 ]
  %2076 = phi i64 [ %2117, %2109 ], [ %2123, %2120 ]
  %2077 = icmp sgt i64 %2075, 0
  br i1 %2077, label %2120, label %2070

2078:                                             ; preds = %2070
  %2079 = icmp slt i64 %2058, 0
  %2080 = select i1 %2079, i64 %223, i64 0
  %2081 = add i64 %2058, %2080
  %2082 = mul i64 %2081, %225
  %2083 = getelementptr i64, ptr %226, i64 %2082
  %2084 = select i1 %2054, i64 %161, i64 0
  %2085 = getelementptr double, ptr %162, i64 %2050
  %2086 = getelementptr double, ptr %2085, i64 %2084
  %2087 = load double, ptr %2086, align 8, !noalias !180
  %2088 = select i1 %2054, i64 %166, i64 0
  %2089 = getelementptr double, ptr %167, i64 %2050
  %2090 = getelementptr double, ptr %2089, i64 %2088
  %2091 = load double, ptr %2090, align 8, !noalias !180
  %2092 = fptosi double %2087 to i64
  store i64 %2092, ptr %2083, align 8, !noalias !180
  %2093 = getelementptr i8, ptr %2083, i64 8
  %2094 = fptosi double %2091 to i64
  store i64 %2094, ptr %2093, align 8, !noalias !180
  %2095 = select i1 %2054, i64 %171, i64 0
  %2096 = getelementptr double, ptr %172, i64 %2050
  %2097 = getelementptr double, ptr %2096, i64 %2095
  %2098 = load double, ptr %2097, align 8, !noalias !180
  %2099 = getelementptr i8, ptr %2083, i64 16
  %2100 = fptosi double %2098 to i64
  store i64 %2100, ptr %2099, align 8, !noalias !180
  %2101 = getelementptr i8, ptr %2083, i64 24
  store i64 0, ptr %2101, align 8, !noalias !180
  %2102 = select i1 %2054, i64 %135, i64 0
  %2103 = getelementptr double, ptr %136, i64 %2050
  %2104 = getelementptr double, ptr %2103, i64 %2102
  %2105 = load double, ptr %2104, align 8, !noalias !180
  %2106 = select i1 %2079, i64 %230, i64 0
  %2107 = getelementptr double, ptr %231, i64 %2058
  %2108 = getelementptr double, ptr %2107, i64 %2106
  store double %2105, ptr %2108, align 8, !noalias !180
  store i64 -1, ptr %2057, align 8, !noalias !180
  br label %2124

2109:                                             ; preds = %2070
  %2110 = add nsw i64 %2072, -1
  %2111 = add i64 %2071, 1
  %2112 = shl nsw i64 %2071, 3
  %2113 = select i1 %2054, i64 %186, i64 0
  %2114 = getelementptr i64, ptr %187, i64 %2050
  %2115 = getelementptr i64, ptr %2114, i64 %2113
  %2116 = load i64, ptr %2115, align 8, !noalias !180
  %2117 = add nsw i64 %2116, %2112
  %2118 = load i64, ptr %232, align 8, !noalias !180
  %2119 = call i64 @llvm.smax.i64(i64 %2118, i64 0)
  br label %2074

2120:                                             ; preds = %2074
  %2121 = add nsw i64 %2075, -1
  %2122 = inttoptr i64 %2076 to ptr
  store atomic i64 9221120237041090560, ptr %2122 unordered, align 8, !noalias !180
  %2123 = add nsw i64 %2076, %2061
  br label %2074

2124:                                             ; preds = %2078, %2188
  br label %2049

2125:                                             ; preds = %2049, %2042
  %2126 = phi i1 [ %1741, %2042 ], [ true, %2049 ]
  br label %267

2127:                                             ; preds = %260
  %2128 = add nsw i64 %262, -1
  %2129 = add i64 %261, 1
  %2130 = icmp slt i64 %261, 0
  %2131 = select i1 %2130, i64 %181, i64 0
  %2132 = getelementptr i64, ptr %182, i64 %261
  %2133 = getelementptr i64, ptr %2132, i64 %2131
  %2134 = load i64, ptr %2133, align 8, !noalias !12
  %2135 = shl nuw i64 1, %261
  %2136 = icmp slt i64 %2134, 0
  %2137 = select i1 %2136, i64 0, i64 %2135
  %2138 = or i64 %263, %2137
  br label %260

2139:                                             ; preds = %343, %314
  %2140 = icmp eq i64 %275, 0
  br i1 %2140, label %495, label %496

2141:                                             ; preds = %664, %512
  br label %2194

2142:                                             ; preds = %991
  %2143 = add nsw i64 %993, -1
  %2144 = add i64 %992, 1
  br i1 %994, label %1003, label %996

2145:                                             ; preds = %1228
  br label %2194

2146:                                             ; preds = %1351
  %2147 = add nsw i64 %1353, -1
  %2148 = add i64 %1352, 1
  %2149 = shl i64 %1352, 6
  %2150 = getelementptr i8, ptr %93, i64 %2149
  %2151 = load <8 x double>, ptr %2150, align 8, !noalias !12
  %2152 = fmul <8 x double> %2151, zeroinitializer
  %2153 = fadd <8 x double> %1354, %2152
  br label %1351

2154:                                             ; preds = %1369
  br label %2194

2155:                                             ; preds = %1431
  %2156 = zext i8 %1396 to i64
  %2157 = and i64 %1406, %2156
  %2158 = load i64, ptr %1400, align 8, !noalias !12
  %2159 = sitofp i64 %2158 to double
  %2160 = insertelement <8 x double> poison, double %2159, i64 0
  %2161 = shufflevector <8 x double> %2160, <8 x double> poison, <8 x i32> zeroinitializer
  %2162 = select <8 x i1> %1395, <8 x double> %2161, <8 x double> zeroinitializer
  %2163 = load <8 x double>, ptr %172, align 8, !noalias !12
  %2164 = fadd <8 x double> %2163, %2162
  store <8 x double> %2164, ptr %172, align 8, !noalias !12
  %2165 = icmp eq i64 %2157, 0
  br i1 %2165, label %1638, label %1555

2166:                                             ; preds = %1555
  %2167 = add nsw i64 %1557, -1
  %2168 = add i64 %1556, 1
  %2169 = shl nuw i64 1, %1556
  %2170 = and i64 %2157, %2169
  %2171 = icmp eq i64 %2170, 0
  br i1 %2171, label %1630, label %1559

2172:                                             ; preds = %2038
  %2173 = add nsw i64 %2040, -1
  %2174 = add i64 %2039, 1
  %2175 = shl i64 %2039, 6
  %2176 = getelementptr i8, ptr %93, i64 %2175
  %2177 = load <8 x double>, ptr %2176, align 8, !noalias !12
  %2178 = getelementptr i8, ptr %88, i64 %2175
  %2179 = load <8 x double>, ptr %2178, align 8, !noalias !12
  %2180 = select <8 x i1> %1742, <8 x double> %2177, <8 x double> %2179
  store <8 x double> %2180, ptr %2178, align 8, !noalias !12
  %2181 = add nsw i64 %245, %2039
  %2182 = shl i64 %2181, 6
  %2183 = getelementptr i8, ptr %116, i64 %2182
  %2184 = load <8 x double>, ptr %2183, align 8, !noalias !12
  %2185 = getelementptr i8, ptr %116, i64 %2175
  %2186 = load <8 x double>, ptr %2185, align 8, !noalias !12
  %2187 = select <8 x i1> %1742, <8 x double> %2184, <8 x double> %2186
  store <8 x double> %2187, ptr %2185, align 8, !noalias !12
  br label %2038

2188:                                             ; preds = %2049
  %2189 = add nsw i64 %2051, -1
  %2190 = add i64 %2050, 1
  %2191 = shl nuw i64 1, %2050
  %2192 = and i64 %2191, %2047
  %2193 = icmp eq i64 %2192, 0
  br i1 %2193, label %2124, label %2053

2194:                                             ; preds = %1554, %2154, %2145, %1225, %2141, %1012, %495
  %2195 = phi i64 [ 0, %1554 ], [ 0, %2141 ], [ 1, %495 ], [ 0, %1012 ], [ 0, %2154 ], [ 0, %1225 ], [ 0, %2145 ]
  ret i64 %2195
}



declare i64 @llvm.smax.i64(i64, i64) #0

declare <8 x i1> @llvm.is.fpclass.v8f64(<8 x double>, i32 immarg) #0

attributes #0 = { nounwind willreturn memory(none) }
attributes #1 = { noinline }
attributes #2 = { nounwind willreturn memory(none) }
attributes #3 = { nounwind }
attributes #4 = { nounwind willreturn }

!0 = !{!1, !3}
!1 = distinct !{!1, !2}
!2 = distinct !{!2}
!3 = distinct !{!3, !2}
!4 = !{!"branch_weights", i32 1, i32 99}
!5 = !{!6, !1, !3}
!6 = distinct !{!6, !7}
!7 = distinct !{!7}
!8 = !{!"branch_weights", i32 99, i32 1}
!9 = !{!10}
!10 = distinct !{!10, !11}
!11 = distinct !{!11}
!12 = !{!13, !15}
!13 = distinct !{!13, !14}
!14 = distinct !{!14}
!15 = distinct !{!15, !14}
!16 = !{!17, !19, !13, !15}
!17 = distinct !{!17, !18}
!18 = distinct !{!18}
!19 = distinct !{!19, !18}
!20 = !{!21, !23, !17, !19, !13, !15}
!21 = distinct !{!21, !22}
!22 = distinct !{!22}
!23 = distinct !{!23, !22}
!24 = !{!25, !27, !17, !19, !13, !15}
!25 = distinct !{!25, !26}
!26 = distinct !{!26}
!27 = distinct !{!27, !26}
!28 = !{!29, !31, !17, !19, !13, !15}
!29 = distinct !{!29, !30}
!30 = distinct !{!30}
!31 = distinct !{!31, !30}
!32 = !{!33, !35, !17, !19, !13, !15}
!33 = distinct !{!33, !34}
!34 = distinct !{!34}
!35 = distinct !{!35, !34}
!36 = !{!37, !39, !17, !19, !13, !15}
!37 = distinct !{!37, !38}
!38 = distinct !{!38}
!39 = distinct !{!39, !38}
!40 = !{!41, !43, !17, !19, !13, !15}
!41 = distinct !{!41, !42}
!42 = distinct !{!42}
!43 = distinct !{!43, !42}
!44 = !{!45, !47, !17, !19, !13, !15}
!45 = distinct !{!45, !46}
!46 = distinct !{!46}
!47 = distinct !{!47, !46}
!48 = !{!49, !51, !13, !15}
!49 = distinct !{!49, !50}
!50 = distinct !{!50}
!51 = distinct !{!51, !50}
!52 = !{!53, !55, !49, !51, !13, !15}
!53 = distinct !{!53, !54}
!54 = distinct !{!54}
!55 = distinct !{!55, !54}
!56 = !{!"branch_weights", i32 1, i32 49, i32 49}
!57 = !{!58, !60, !49, !51, !13, !15}
!58 = distinct !{!58, !59}
!59 = distinct !{!59}
!60 = distinct !{!60, !59}
!61 = !{!62, !64, !58, !60, !49, !51, !13, !15}
!62 = distinct !{!62, !63}
!63 = distinct !{!63}
!64 = distinct !{!64, !63}
!65 = !{!66, !68, !58, !60, !49, !51, !13, !15}
!66 = distinct !{!66, !67}
!67 = distinct !{!67}
!68 = distinct !{!68, !67}
!69 = !{!70, !72, !58, !60, !49, !51, !13, !15}
!70 = distinct !{!70, !71}
!71 = distinct !{!71}
!72 = distinct !{!72, !71}
!73 = !{!74, !76, !49, !51, !13, !15}
!74 = distinct !{!74, !75}
!75 = distinct !{!75}
!76 = distinct !{!76, !75}
!77 = !{!78, !80, !49, !51, !13, !15}
!78 = distinct !{!78, !79}
!79 = distinct !{!79}
!80 = distinct !{!80, !79}
!81 = !{!82, !84, !49, !51, !13, !15}
!82 = distinct !{!82, !83}
!83 = distinct !{!83}
!84 = distinct !{!84, !83}
!85 = !{!86, !88, !13, !15}
!86 = distinct !{!86, !87}
!87 = distinct !{!87}
!88 = distinct !{!88, !87}
!89 = !{!90, !92, !86, !88, !13, !15}
!90 = distinct !{!90, !91}
!91 = distinct !{!91}
!92 = distinct !{!92, !91}
!93 = !{!94, !96, !13, !15}
!94 = distinct !{!94, !95}
!95 = distinct !{!95}
!96 = distinct !{!96, !95}
!97 = !{!98, !100, !102, !94, !96, !13, !15}
!98 = distinct !{!98, !99}
!99 = distinct !{!99}
!100 = distinct !{!100, !101}
!101 = distinct !{!101}
!102 = distinct !{!102, !101}
!103 = !{!104, !106, !108, !94, !96, !13, !15}
!104 = distinct !{!104, !105}
!105 = distinct !{!105}
!106 = distinct !{!106, !107}
!107 = distinct !{!107}
!108 = distinct !{!108, !107}
!109 = !{!110, !112, !94, !96, !13, !15}
!110 = distinct !{!110, !111}
!111 = distinct !{!111}
!112 = distinct !{!112, !111}
!113 = !{!114, !116, !13, !15}
!114 = distinct !{!114, !115}
!115 = distinct !{!115}
!116 = distinct !{!116, !115}
!117 = !{!118, !120, !13, !15}
!118 = distinct !{!118, !119}
!119 = distinct !{!119}
!120 = distinct !{!120, !119}
!121 = !{!122, !124, !126, !118, !120, !13, !15}
!122 = distinct !{!122, !123}
!123 = distinct !{!123}
!124 = distinct !{!124, !125}
!125 = distinct !{!125}
!126 = distinct !{!126, !125}
!127 = !{!128, !118, !120, !13, !15}
!128 = distinct !{!128, !129}
!129 = distinct !{!129}
!130 = !{!131, !133, !13, !15}
!131 = distinct !{!131, !132}
!132 = distinct !{!132}
!133 = distinct !{!133, !132}
!134 = !{!135, !137, !13, !15}
!135 = distinct !{!135, !136}
!136 = distinct !{!136}
!137 = distinct !{!137, !136}
!138 = !{!139, !141, !135, !137, !13, !15}
!139 = distinct !{!139, !140}
!140 = distinct !{!140}
!141 = distinct !{!141, !140}
!142 = !{!143, !145, !147, !139, !141, !135, !137, !13, !15}
!143 = distinct !{!143, !144}
!144 = distinct !{!144}
!145 = distinct !{!145, !146}
!146 = distinct !{!146}
!147 = distinct !{!147, !146}
!148 = !{!149, !151, !153, !135, !137, !13, !15}
!149 = distinct !{!149, !150}
!150 = distinct !{!150}
!151 = distinct !{!151, !152}
!152 = distinct !{!152}
!153 = distinct !{!153, !152}
!154 = !{!155, !157, !135, !137, !13, !15}
!155 = distinct !{!155, !156}
!156 = distinct !{!156}
!157 = distinct !{!157, !156}
!158 = !{!159, !161, !13, !15}
!159 = distinct !{!159, !160}
!160 = distinct !{!160}
!161 = distinct !{!161, !160}
!162 = !{!163, !165, !13, !15}
!163 = distinct !{!163, !164}
!164 = distinct !{!164}
!165 = distinct !{!165, !164}
!166 = !{!167, !169, !163, !165, !13, !15}
!167 = distinct !{!167, !168}
!168 = distinct !{!168}
!169 = distinct !{!169, !168}
!170 = !{!171, !173, !13, !15}
!171 = distinct !{!171, !172}
!172 = distinct !{!172}
!173 = distinct !{!173, !172}
!174 = !{!175, !13, !15}
!175 = distinct !{!175, !176}
!176 = distinct !{!176}
!177 = !{!178, !13, !15}
!178 = distinct !{!178, !179}
!179 = distinct !{!179}
!180 = !{!181, !183, !13, !15}
!181 = distinct !{!181, !182}
!182 = distinct !{!182}
!183 = distinct !{!183, !182}
