; sources 61c52e6150ae591bbfd0c60ba47dd81ad50858d95a1ef7c36c08e1706437d0fd
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

260:                                              ; preds = %1, %2189
  %261 = phi i64 [ 0, %1 ], [ %2191, %2189 ]
  %262 = phi i64 [ 8, %1 ], [ %2190, %2189 ]
  %263 = phi i64 [ 0, %1 ], [ %2200, %2189 ]
  %264 = icmp sgt i64 %262, 0
  br i1 %264, label %2189, label %265

265:                                              ; preds = %1066, %260
  %266 = phi i64 [ %263, %260 ], [ %1010, %1066 ]
  br label %267

267:                                              ; preds = %2187, %265
  %268 = phi i64 [ %266, %265 ], [ %1802, %2187 ]
  %269 = phi i1 [ true, %265 ], [ %2188, %2187 ]
  br i1 %269, label %270, label %1009

270:                                              ; preds = %267, %1008
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
  br i1 %315, label %316, label %2201

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
  %344 = getelementptr i8, ptr %39, i64 40
  %345 = load i64, ptr %344, align 8, !noalias !16
  %346 = inttoptr i64 %345 to ptr
  call void %346(ptr %54, ptr %57) #3, !noalias !16
  br label %2201

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
  %440 = getelementptr i8, ptr %39, i64 48
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
  %462 = getelementptr i8, ptr %39, i64 56
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

495:                                              ; preds = %2201
  br label %2256

496:                                              ; preds = %2201
  %497 = icmp eq i64 %274, 0
  br i1 %497, label %1009, label %498

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
  br i1 %514, label %971, label %2203, !prof !8

515:                                              ; preds = %971, %973
  %516 = phi i64 [ 0, %971 ], [ %975, %973 ]
  %517 = phi i64 [ %972, %971 ], [ %974, %973 ]
  %518 = icmp sgt i64 %517, 0
  br i1 %518, label %973, label %519

519:                                              ; preds = %515
  %520 = getelementptr i8, ptr %193, i64 8
  %521 = load double, ptr %520, align 8, !noalias !48
  %522 = insertelement <8 x double> poison, double %521, i64 0
  %523 = shufflevector <8 x double> %522, <8 x double> poison, <8 x i32> zeroinitializer
  %524 = fcmp oeq double %521, 0.000000e+00
  br i1 %524, label %525, label %670

525:                                              ; preds = %519
  %526 = load double, ptr %193, align 8, !noalias !48
  %527 = load i64, ptr %232, align 8, !noalias !57
  %528 = getelementptr i8, ptr %39, i64 24
  %529 = load i64, ptr %528, align 8, !noalias !57
  store <8 x double> zeroinitializer, ptr %13, align 64, !noalias !61
  store <8 x double> zeroinitializer, ptr %14, align 64, !noalias !61
  store <8 x double> zeroinitializer, ptr %13, align 64, !noalias !61
  %530 = call fastcc i32 @norm(ptr nonnull %13, ptr %88, ptr %88, ptr %88, ptr %126, i64 %125, ptr %131, i64 %130, i64 %529) #3
  %531 = load <8 x double>, ptr %13, align 64, !noalias !61
  switch i32 %530, label %667 [
    i32 -2, label %532
    i32 0, label %532
  ], !prof !56

532:                                              ; preds = %525, %525
  store <8 x double> zeroinitializer, ptr %14, align 64, !noalias !61
  %533 = call fastcc i32 @norm(ptr nonnull %14, ptr %116, ptr %88, ptr %88, ptr %126, i64 %125, ptr %131, i64 %130, i64 %529) #3
  %534 = load <8 x double>, ptr %14, align 64, !noalias !61
  switch i32 %533, label %667 [
    i32 -2, label %535
    i32 0, label %535
  ], !prof !56

535:                                              ; preds = %532, %532
  %536 = fcmp olt <8 x double> %531, splat (double 1.000000e-05)
  %537 = fcmp olt <8 x double> %534, splat (double 1.000000e-05)
  %538 = or <8 x i1> %536, %537
  %539 = fmul <8 x double> %531, splat (double 1.000000e-02)
  %540 = fdiv <8 x double> %539, %534
  %541 = select <8 x i1> %538, <8 x double> splat (double 0x3EB0C6F7A0B5ED8D), <8 x double> %540
  %542 = insertelement <8 x double> poison, double %526, i64 0
  %543 = shufflevector <8 x double> %542, <8 x double> poison, <8 x i32> zeroinitializer
  %544 = fcmp olt <8 x double> %543, %541
  %545 = select <8 x i1> %544, <8 x double> %543, <8 x double> %541
  %546 = call i64 @llvm.smax.i64(i64 %527, i64 0)
  br label %547

547:                                              ; preds = %535, %568
  %548 = phi i64 [ 0, %535 ], [ %570, %568 ]
  %549 = phi i64 [ %546, %535 ], [ %569, %568 ]
  %550 = icmp sgt i64 %549, 0
  br i1 %550, label %568, label %551

551:                                              ; preds = %547
  %552 = shl i64 %87, 3
  %553 = add i64 %113, %552
  %554 = fadd <8 x double> %502, %545
  store ptr null, ptr %11, align 8, !noalias !65
  store ptr null, ptr %12, align 8, !noalias !65
  store <8 x double> %554, ptr %44, align 8, !noalias !65
  br i1 %503, label %555, label %557

555:                                              ; preds = %551
  store ptr null, ptr %11, align 8, !noalias !65
  %556 = call fastcc i32 @_set_inputs(ptr nonnull %11, ptr nonnull %44, i64 %43, ptr %49, i64 %48, ptr %64, i64 %61, i64 %63, ptr %71, i64 %68, i64 %70, ptr %76, i64 %75, ptr %83, i64 %80, i64 %82) #3
  switch i32 %556, label %667 [
    i32 -2, label %557
    i32 0, label %557
  ], !prof !56

557:                                              ; preds = %555, %555, %551
  %558 = load i64, ptr %39, align 8, !noalias !65
  %559 = inttoptr i64 %558 to ptr
  %560 = inttoptr i64 %553 to ptr
  %561 = call i32 %559(ptr nonnull %44, ptr %98, ptr %49, ptr %57, ptr %560) #3, !noalias !65
  %562 = trunc i32 %561 to i8
  %563 = bitcast i8 %562 to <8 x i1>
  store <8 x double> zeroinitializer, ptr %10, align 64, !noalias !69
  %564 = icmp slt i64 %87, 0
  %565 = select i1 %564, i64 %115, i64 0
  %566 = add i64 %87, %565
  %567 = icmp slt i64 %566, 0
  br i1 %567, label %585, label %586, !prof !4

568:                                              ; preds = %547
  %569 = add nsw i64 %549, -1
  %570 = add i64 %548, 1
  %571 = shl i64 %548, 6
  %572 = getelementptr i8, ptr %88, i64 %571
  %573 = load <8 x double>, ptr %572, align 8, !noalias !57
  %574 = getelementptr i8, ptr %116, i64 %571
  %575 = load <8 x double>, ptr %574, align 8, !noalias !57
  %576 = fmul <8 x double> %545, %575
  %577 = fadd <8 x double> %573, %576
  %578 = getelementptr i8, ptr %98, i64 %571
  store <8 x double> %577, ptr %578, align 8, !noalias !57
  br label %547

579:                                              ; preds = %590, %594
  %580 = phi i64 [ 0, %590 ], [ %596, %594 ]
  %581 = phi i64 [ %593, %590 ], [ %595, %594 ]
  %582 = icmp sgt i64 %581, 0
  br i1 %582, label %594, label %583

583:                                              ; preds = %579
  store <8 x double> zeroinitializer, ptr %10, align 64, !noalias !69
  %584 = call fastcc i32 @norm(ptr nonnull %10, ptr %592, ptr %88, ptr %88, ptr %126, i64 %125, ptr %131, i64 %130, i64 %529) #3
  switch i32 %584, label %667 [
    i32 -2, label %603
    i32 0, label %603
  ], !prof !56

585:                                              ; preds = %557
  br label %586

586:                                              ; preds = %585, %557
  %587 = phi i64 [ 0, %585 ], [ %566, %557 ]
  %588 = icmp slt i64 %566, %115
  br i1 %588, label %590, label %589, !prof !8

589:                                              ; preds = %586
  br label %590

590:                                              ; preds = %589, %586
  %591 = phi i64 [ %115, %589 ], [ %587, %586 ]
  %592 = getelementptr double, ptr %116, i64 %591
  %593 = call i64 @llvm.smax.i64(i64 %529, i64 0)
  br label %579

594:                                              ; preds = %579
  %595 = add nsw i64 %581, -1
  %596 = add i64 %580, 1
  %597 = shl i64 %580, 6
  %598 = getelementptr i8, ptr %592, i64 %597
  %599 = load <8 x double>, ptr %598, align 8, !noalias !69
  %600 = getelementptr i8, ptr %116, i64 %597
  %601 = load <8 x double>, ptr %600, align 8, !noalias !69
  %602 = fsub <8 x double> %599, %601
  store <8 x double> %602, ptr %598, align 8, !noalias !69
  br label %579

603:                                              ; preds = %583, %583
  %604 = load <8 x double>, ptr %10, align 64, !noalias !69
  %605 = fdiv <8 x double> %604, %545
  %606 = fcmp ogt <8 x double> %534, %605
  %607 = select <8 x i1> %606, <8 x double> %534, <8 x double> %605
  %608 = fcmp ogt <8 x double> %607, splat (double 1.000000e-15)
  %609 = fdiv <8 x double> splat (double 1.000000e-02), %607
  %610 = select <8 x i1> %608, <8 x double> %609, <8 x double> splat (double 1.000000e+13)
  %611 = load double, ptr %36, align 8, !noalias !69
  %612 = insertelement <8 x double> poison, double %611, i64 0
  %613 = shufflevector <8 x double> %612, <8 x double> poison, <8 x i32> zeroinitializer
  %614 = bitcast <8 x double> %610 to <8 x i64>
  %615 = add nsw <8 x i64> %614, splat (i64 -4604544271217802189)
  %616 = ashr <8 x i64> %615, splat (i64 52)
  %617 = and <8 x i64> %615, splat (i64 -4503599627370496)
  %618 = sub <8 x i64> %614, %617
  %619 = bitcast <8 x i64> %618 to <8 x double>
  %620 = fadd <8 x double> %619, splat (double -1.000000e+00)
  %621 = fadd <8 x double> %619, splat (double 1.000000e+00)
  %622 = fdiv <8 x double> %620, %621
  %623 = fmul <8 x double> %622, %622
  %624 = call <8 x double> @llvm.fma.v8f64(<8 x double> %623, <8 x double> splat (double 0x3FD484B13D7C02A9), <8 x double> splat (double 0x3FDA61762A7ADED9))
  %625 = call <8 x double> @llvm.fma.v8f64(<8 x double> %624, <8 x double> %623, <8 x double> splat (double 0x3FE2776C50EF9BFE))
  %626 = call <8 x double> @llvm.fma.v8f64(<8 x double> %625, <8 x double> %623, <8 x double> splat (double 0x3FEEC709DC3A03FD))
  %627 = call <8 x double> @llvm.fma.v8f64(<8 x double> %626, <8 x double> %623, <8 x double> splat (double 0x40071547652B82FE))
  %628 = fmul <8 x double> %627, %622
  %629 = trunc nsw <8 x i64> %616 to <8 x i32>
  %630 = sitofp <8 x i32> %629 to <8 x double>
  %631 = fadd <8 x double> %628, %630
  %632 = fmul <8 x double> %631, %613
  %633 = fcmp ogt <8 x double> %632, splat (double -1.000000e+03)
  %634 = select <8 x i1> %633, <8 x double> %632, <8 x double> splat (double -1.000000e+03)
  %635 = fcmp olt <8 x double> %634, splat (double 1.000000e+03)
  %636 = select <8 x i1> %635, <8 x double> %634, <8 x double> splat (double 1.000000e+03)
  %637 = call <8 x double> @llvm.rint.v8f64(<8 x double> %636)
  %638 = fsub <8 x double> %636, %637
  %639 = call <8 x double> @llvm.fma.v8f64(<8 x double> %638, <8 x double> splat (double 0x3EEFFCBFC588B0C5), <8 x double> splat (double 0x3F2430912F86C786))
  %640 = call <8 x double> @llvm.fma.v8f64(<8 x double> %639, <8 x double> %638, <8 x double> splat (double 0x3F55D87FE78A6730))
  %641 = call <8 x double> @llvm.fma.v8f64(<8 x double> %640, <8 x double> %638, <8 x double> splat (double 0x3F83B2AB6FBA4E77))
  %642 = call <8 x double> @llvm.fma.v8f64(<8 x double> %641, <8 x double> %638, <8 x double> splat (double 0x3FAC6B08D704A0BF))
  %643 = call <8 x double> @llvm.fma.v8f64(<8 x double> %642, <8 x double> %638, <8 x double> splat (double 0x3FCEBFBDFF82C58E))
  %644 = call <8 x double> @llvm.fma.v8f64(<8 x double> %643, <8 x double> %638, <8 x double> splat (double 0x3FE62E42FEFA39EF))
  %645 = call <8 x double> @llvm.fma.v8f64(<8 x double> %644, <8 x double> %638, <8 x double> splat (double 1.000000e+00))
  %646 = fptosi <8 x double> %637 to <8 x i32>
  %647 = zext <8 x i32> %646 to <8 x i64>
  %648 = shl <8 x i64> %647, splat (i64 52)
  %649 = bitcast <8 x double> %645 to <8 x i64>
  %650 = add <8 x i64> %648, %649
  %651 = bitcast <8 x i64> %650 to <8 x double>
  %652 = fmul <8 x double> %545, splat (double 1.000000e-03)
  %653 = fcmp olt <8 x double> %652, splat (double 0x3EB0C6F7A0B5ED8D)
  %654 = select <8 x i1> %653, <8 x double> splat (double 0x3EB0C6F7A0B5ED8D), <8 x double> %652
  %655 = fmul <8 x double> %545, splat (double 1.000000e+02)
  %656 = select <8 x i1> %608, <8 x double> %651, <8 x double> %654
  %657 = fcmp olt <8 x double> %655, %656
  %658 = select <8 x i1> %657, <8 x double> %655, <8 x double> %656
  %659 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %502)
  %660 = fmul <8 x double> %659, splat (double 0x3D30000000000000)
  %661 = fcmp ogt <8 x double> %660, %658
  %662 = select <8 x i1> %661, <8 x double> %660, <8 x double> %658
  %663 = shufflevector <8 x double> %542, <8 x double> poison, <8 x i32> zeroinitializer
  %664 = fcmp olt <8 x double> %663, %662
  %665 = select <8 x i1> %664, <8 x double> %663, <8 x double> %662
  %666 = select <8 x i1> %563, <8 x double> %652, <8 x double> %665
  br label %667

667:                                              ; preds = %555, %525, %532, %583, %603
  %668 = phi <8 x double> [ zeroinitializer, %525 ], [ %666, %603 ], [ zeroinitializer, %583 ], [ zeroinitializer, %532 ], [ zeroinitializer, %555 ]
  %669 = phi i1 [ false, %525 ], [ true, %603 ], [ false, %583 ], [ false, %532 ], [ false, %555 ]
  br i1 %669, label %670, label %2203, !prof !8

670:                                              ; preds = %667, %519
  %671 = phi double [ 1.000000e+00, %519 ], [ 2.000000e+00, %667 ]
  %672 = phi <8 x double> [ %523, %519 ], [ %668, %667 ]
  %673 = load <8 x double>, ptr %141, align 8, !noalias !48
  %674 = select <8 x i1> %501, <8 x double> %672, <8 x double> %673
  store <8 x double> %674, ptr %141, align 8, !noalias !48
  %675 = load <8 x double>, ptr %144, align 8, !noalias !48
  %676 = select <8 x i1> %501, <8 x double> splat (double 1.000000e-04), <8 x double> %675
  store <8 x double> %676, ptr %144, align 8, !noalias !48
  %677 = getelementptr i8, ptr %36, i64 40
  %678 = load double, ptr %677, align 8, !noalias !48
  %679 = load <8 x double>, ptr %147, align 8, !noalias !48
  %680 = insertelement <8 x double> poison, double %678, i64 0
  %681 = shufflevector <8 x double> %680, <8 x double> poison, <8 x i32> zeroinitializer
  %682 = select <8 x i1> %501, <8 x double> %681, <8 x double> %679
  store <8 x double> %682, ptr %147, align 8, !noalias !48
  %683 = load <8 x double>, ptr %162, align 8, !noalias !48
  %684 = select <8 x i1> %501, <8 x double> zeroinitializer, <8 x double> %683
  store <8 x double> %684, ptr %162, align 8, !noalias !48
  %685 = load <8 x double>, ptr %167, align 8, !noalias !48
  %686 = select <8 x i1> %501, <8 x double> zeroinitializer, <8 x double> %685
  store <8 x double> %686, ptr %167, align 8, !noalias !48
  %687 = load <8 x double>, ptr %172, align 8, !noalias !48
  %688 = insertelement <8 x double> poison, double %671, i64 0
  %689 = shufflevector <8 x double> %688, <8 x double> poison, <8 x i32> zeroinitializer
  %690 = select <8 x i1> %501, <8 x double> %689, <8 x double> %687
  store <8 x double> %690, ptr %172, align 8, !noalias !48
  %691 = call <8 x i1> @llvm.is.fpclass.v8f64(<8 x double> %672, i32 384)
  %692 = select <8 x i1> %691, <8 x double> splat (double 2.000000e+00), <8 x double> splat (double 4.000000e+00)
  %693 = load <8 x double>, ptr %177, align 8, !noalias !48
  %694 = select <8 x i1> %501, <8 x double> %692, <8 x double> %693
  store <8 x double> %694, ptr %177, align 8, !noalias !48
  br label %695

695:                                              ; preds = %670, %721
  %696 = phi i64 [ 0, %670 ], [ %984, %721 ]
  %697 = phi i64 [ 8, %670 ], [ %983, %721 ]
  %698 = icmp sgt i64 %697, 0
  br i1 %698, label %982, label %722

699:                                              ; preds = %982
  %700 = load double, ptr %198, align 8, !noalias !48
  %701 = icmp slt i64 %696, 0
  %702 = select i1 %701, i64 %151, i64 0
  %703 = getelementptr double, ptr %152, i64 %696
  %704 = getelementptr double, ptr %703, i64 %702
  store double 0.000000e+00, ptr %704, align 8, !noalias !48
  %705 = select i1 %701, i64 %156, i64 0
  %706 = getelementptr double, ptr %157, i64 %696
  %707 = getelementptr double, ptr %706, i64 %705
  store double %700, ptr %707, align 8, !noalias !48
  %708 = select i1 %701, i64 %181, i64 0
  %709 = getelementptr i64, ptr %182, i64 %696
  %710 = getelementptr i64, ptr %709, i64 %708
  %711 = load i64, ptr %710, align 8, !noalias !48
  %712 = add nsw i64 %197, -1
  %713 = mul nsw i64 %711, %712
  %714 = getelementptr i8, ptr %190, i64 24
  %715 = load i64, ptr %714, align 8, !noalias !48
  %716 = shl nsw i64 %713, 3
  %717 = add nsw i64 %715, %716
  %718 = select i1 %701, i64 %186, i64 0
  %719 = getelementptr i64, ptr %187, i64 %696
  %720 = getelementptr i64, ptr %719, i64 %718
  store i64 %717, ptr %720, align 8, !noalias !48
  br label %721

721:                                              ; preds = %699, %982
  br label %695

722:                                              ; preds = %695
  %723 = xor i64 %513, -1
  %724 = and i64 %274, %723
  %725 = icmp eq i64 %724, 0
  br i1 %725, label %814, label %726

726:                                              ; preds = %722, %748
  %727 = phi i64 [ %800, %748 ], [ %724, %722 ]
  %728 = getelementptr i8, ptr %190, i64 32
  %729 = load i64, ptr %728, align 8, !noalias !73
  %730 = shl nsw i64 %729, 3
  %731 = load i64, ptr %232, align 8, !noalias !73
  br label %732

732:                                              ; preds = %726, %746
  %733 = phi i64 [ %736, %746 ], [ %727, %726 ]
  %734 = call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %733, i1 true)
  %735 = add nsw i64 %733, -1
  %736 = and i64 %733, %735
  %737 = getelementptr i64, ptr %187, i64 %734
  %738 = load i64, ptr %737, align 8, !noalias !73
  %739 = add nsw i64 %738, 8
  store i64 %739, ptr %737, align 8, !noalias !73
  %740 = call i64 @llvm.smax.i64(i64 %731, i64 0)
  br label %741

741:                                              ; preds = %732, %802
  %742 = phi i64 [ 0, %732 ], [ %804, %802 ]
  %743 = phi i64 [ %740, %732 ], [ %803, %802 ]
  %744 = phi i64 [ %738, %732 ], [ %813, %802 ]
  %745 = icmp sgt i64 %743, 0
  br i1 %745, label %802, label %746

746:                                              ; preds = %741
  %747 = icmp eq i64 %736, 0
  br i1 %747, label %748, label %732

748:                                              ; preds = %746
  %749 = load <8 x double>, ptr %152, align 8, !noalias !73
  %750 = trunc i64 %727 to i8
  %751 = bitcast i8 %750 to <8 x i1>
  %752 = select <8 x i1> %751, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %753 = fadd <8 x double> %749, %752
  store <8 x double> %753, ptr %152, align 8, !noalias !73
  %754 = extractelement <8 x double> %753, i64 0
  %755 = fptosi double %754 to i64
  %756 = getelementptr double, ptr %198, i64 %755
  %757 = load double, ptr %756, align 8, !noalias !73
  %758 = insertelement <8 x double> poison, double %757, i64 0
  %759 = extractelement <8 x double> %753, i64 1
  %760 = fptosi double %759 to i64
  %761 = getelementptr double, ptr %198, i64 %760
  %762 = load double, ptr %761, align 8, !noalias !73
  %763 = insertelement <8 x double> %758, double %762, i64 1
  %764 = extractelement <8 x double> %753, i64 2
  %765 = fptosi double %764 to i64
  %766 = getelementptr double, ptr %198, i64 %765
  %767 = load double, ptr %766, align 8, !noalias !73
  %768 = insertelement <8 x double> %763, double %767, i64 2
  %769 = extractelement <8 x double> %753, i64 3
  %770 = fptosi double %769 to i64
  %771 = getelementptr double, ptr %198, i64 %770
  %772 = load double, ptr %771, align 8, !noalias !73
  %773 = insertelement <8 x double> %768, double %772, i64 3
  %774 = extractelement <8 x double> %753, i64 4
  %775 = fptosi double %774 to i64
  %776 = getelementptr double, ptr %198, i64 %775
  %777 = load double, ptr %776, align 8, !noalias !73
  %778 = insertelement <8 x double> %773, double %777, i64 4
  %779 = extractelement <8 x double> %753, i64 5
  %780 = fptosi double %779 to i64
  %781 = getelementptr double, ptr %198, i64 %780
  %782 = load double, ptr %781, align 8, !noalias !73
  %783 = insertelement <8 x double> %778, double %782, i64 5
  %784 = extractelement <8 x double> %753, i64 6
  %785 = fptosi double %784 to i64
  %786 = getelementptr double, ptr %198, i64 %785
  %787 = load double, ptr %786, align 8, !noalias !73
  %788 = insertelement <8 x double> %783, double %787, i64 6
  %789 = extractelement <8 x double> %753, i64 7
  %790 = fptosi double %789 to i64
  %791 = getelementptr double, ptr %198, i64 %790
  %792 = load double, ptr %791, align 8, !noalias !73
  %793 = insertelement <8 x double> %788, double %792, i64 7
  store <8 x double> %793, ptr %157, align 8, !noalias !73
  %794 = load double, ptr %198, align 8, !noalias !48
  %795 = insertelement <8 x double> poison, double %794, i64 0
  %796 = shufflevector <8 x double> %795, <8 x double> poison, <8 x i32> zeroinitializer
  %797 = fcmp oeq <8 x double> %793, %796
  %798 = bitcast <8 x i1> %797 to i8
  %799 = zext i8 %798 to i64
  %800 = and i64 %727, %799
  %801 = icmp eq i64 %800, 0
  br i1 %801, label %814, label %726

802:                                              ; preds = %741
  %803 = add nsw i64 %743, -1
  %804 = add i64 %742, 1
  %805 = shl nsw i64 %742, 3
  %806 = add nsw i64 %805, %734
  %807 = icmp slt i64 %806, 0
  %808 = select i1 %807, i64 %87, i64 0
  %809 = getelementptr double, ptr %88, i64 %806
  %810 = getelementptr double, ptr %809, i64 %808
  %811 = load i64, ptr %810, align 8, !noalias !73
  %812 = inttoptr i64 %744 to ptr
  store atomic i64 %811, ptr %812 unordered, align 8, !noalias !73
  %813 = add nsw i64 %744, %730
  br label %741

814:                                              ; preds = %748, %722
  br label %815

815:                                              ; preds = %844, %814, %970
  %816 = phi i64 [ 0, %814 ], [ %990, %970 ], [ %990, %844 ]
  %817 = phi i64 [ 8, %814 ], [ %989, %970 ], [ %989, %844 ]
  %818 = icmp sgt i64 %817, 0
  br i1 %818, label %988, label %994

819:                                              ; preds = %988
  %820 = icmp slt i64 %816, 0
  %821 = select i1 %820, i64 %181, i64 0
  %822 = getelementptr i64, ptr %182, i64 %816
  %823 = getelementptr i64, ptr %822, i64 %821
  %824 = load i64, ptr %823, align 8, !noalias !77
  %825 = getelementptr i8, ptr %190, i64 32
  %826 = load i64, ptr %825, align 8, !noalias !77
  %827 = shl nsw i64 %826, 3
  %828 = select i1 %820, i64 %151, i64 0
  %829 = getelementptr double, ptr %152, i64 %816
  %830 = getelementptr double, ptr %829, i64 %828
  %831 = load double, ptr %830, align 8, !noalias !77
  %832 = fptosi double %831 to i64
  %833 = xor i64 %832, -1
  %834 = add i64 %197, %833
  %835 = call i64 @llvm.smax.i64(i64 %834, i64 0)
  br label %836

836:                                              ; preds = %840, %819
  %837 = phi i64 [ 0, %819 ], [ %877, %840 ]
  %838 = phi i64 [ %835, %819 ], [ %876, %840 ]
  %839 = icmp sgt i64 %838, 0
  br i1 %839, label %875, label %844

840:                                              ; preds = %875, %886
  %841 = phi i64 [ %885, %875 ], [ %887, %886 ]
  %842 = phi i64 [ %883, %875 ], [ %889, %886 ]
  %843 = icmp sgt i64 %841, 0
  br i1 %843, label %886, label %836

844:                                              ; preds = %836
  %845 = icmp slt i64 %824, 0
  %846 = select i1 %845, i64 %223, i64 0
  %847 = add i64 %824, %846
  %848 = mul i64 %847, %225
  %849 = getelementptr i64, ptr %226, i64 %848
  %850 = select i1 %820, i64 %161, i64 0
  %851 = getelementptr double, ptr %162, i64 %816
  %852 = getelementptr double, ptr %851, i64 %850
  %853 = load double, ptr %852, align 8, !noalias !77
  %854 = select i1 %820, i64 %166, i64 0
  %855 = getelementptr double, ptr %167, i64 %816
  %856 = getelementptr double, ptr %855, i64 %854
  %857 = load double, ptr %856, align 8, !noalias !77
  %858 = fptosi double %853 to i64
  store i64 %858, ptr %849, align 8, !noalias !77
  %859 = getelementptr i8, ptr %849, i64 8
  %860 = fptosi double %857 to i64
  store i64 %860, ptr %859, align 8, !noalias !77
  %861 = select i1 %820, i64 %171, i64 0
  %862 = getelementptr double, ptr %172, i64 %816
  %863 = getelementptr double, ptr %862, i64 %861
  %864 = load double, ptr %863, align 8, !noalias !77
  %865 = getelementptr i8, ptr %849, i64 16
  %866 = fptosi double %864 to i64
  store i64 %866, ptr %865, align 8, !noalias !77
  %867 = getelementptr i8, ptr %849, i64 24
  store i64 3, ptr %867, align 8, !noalias !77
  %868 = select i1 %820, i64 %135, i64 0
  %869 = getelementptr double, ptr %136, i64 %816
  %870 = getelementptr double, ptr %869, i64 %868
  %871 = load double, ptr %870, align 8, !noalias !77
  %872 = select i1 %845, i64 %230, i64 0
  %873 = getelementptr double, ptr %231, i64 %824
  %874 = getelementptr double, ptr %873, i64 %872
  store double %871, ptr %874, align 8, !noalias !77
  store i64 -1, ptr %823, align 8, !noalias !77
  br label %815

875:                                              ; preds = %836
  %876 = add nsw i64 %838, -1
  %877 = add i64 %837, 1
  %878 = shl nsw i64 %837, 3
  %879 = select i1 %820, i64 %186, i64 0
  %880 = getelementptr i64, ptr %187, i64 %816
  %881 = getelementptr i64, ptr %880, i64 %879
  %882 = load i64, ptr %881, align 8, !noalias !77
  %883 = add nsw i64 %882, %878
  %884 = load i64, ptr %232, align 8, !noalias !77
  %885 = call i64 @llvm.smax.i64(i64 %884, i64 0)
  br label %840

886:                                              ; preds = %840
  %887 = add nsw i64 %841, -1
  %888 = inttoptr i64 %842 to ptr
  store atomic i64 9221120237041090560, ptr %888 unordered, align 8, !noalias !77
  %889 = add nsw i64 %842, %827
  br label %840

890:                                              ; preds = %988
  %891 = and i64 %274, %991
  %892 = icmp eq i64 %891, 0
  br i1 %892, label %970, label %893

893:                                              ; preds = %890
  %894 = icmp slt i64 %816, 0
  %895 = select i1 %894, i64 %156, i64 0
  %896 = getelementptr double, ptr %157, i64 %816
  %897 = getelementptr double, ptr %896, i64 %895
  %898 = load double, ptr %897, align 8, !noalias !48
  %899 = fcmp oeq double %898, 0x7FF0000000000000
  br i1 %899, label %900, label %970

900:                                              ; preds = %893
  %901 = select i1 %894, i64 %181, i64 0
  %902 = getelementptr i64, ptr %182, i64 %816
  %903 = getelementptr i64, ptr %902, i64 %901
  %904 = load i64, ptr %903, align 8, !noalias !81
  %905 = getelementptr i8, ptr %190, i64 32
  %906 = load i64, ptr %905, align 8, !noalias !81
  %907 = shl nsw i64 %906, 3
  %908 = select i1 %894, i64 %151, i64 0
  %909 = getelementptr double, ptr %152, i64 %816
  %910 = getelementptr double, ptr %909, i64 %908
  %911 = load double, ptr %910, align 8, !noalias !81
  %912 = fptosi double %911 to i64
  %913 = xor i64 %912, -1
  %914 = add i64 %197, %913
  %915 = call i64 @llvm.smax.i64(i64 %914, i64 0)
  br label %916

916:                                              ; preds = %920, %900
  %917 = phi i64 [ 0, %900 ], [ %957, %920 ]
  %918 = phi i64 [ %915, %900 ], [ %956, %920 ]
  %919 = icmp sgt i64 %918, 0
  br i1 %919, label %955, label %924

920:                                              ; preds = %955, %966
  %921 = phi i64 [ %965, %955 ], [ %967, %966 ]
  %922 = phi i64 [ %963, %955 ], [ %969, %966 ]
  %923 = icmp sgt i64 %921, 0
  br i1 %923, label %966, label %916

924:                                              ; preds = %916
  %925 = icmp slt i64 %904, 0
  %926 = select i1 %925, i64 %223, i64 0
  %927 = add i64 %904, %926
  %928 = mul i64 %927, %225
  %929 = getelementptr i64, ptr %226, i64 %928
  %930 = select i1 %894, i64 %161, i64 0
  %931 = getelementptr double, ptr %162, i64 %816
  %932 = getelementptr double, ptr %931, i64 %930
  %933 = load double, ptr %932, align 8, !noalias !81
  %934 = select i1 %894, i64 %166, i64 0
  %935 = getelementptr double, ptr %167, i64 %816
  %936 = getelementptr double, ptr %935, i64 %934
  %937 = load double, ptr %936, align 8, !noalias !81
  %938 = fptosi double %933 to i64
  store i64 %938, ptr %929, align 8, !noalias !81
  %939 = getelementptr i8, ptr %929, i64 8
  %940 = fptosi double %937 to i64
  store i64 %940, ptr %939, align 8, !noalias !81
  %941 = select i1 %894, i64 %171, i64 0
  %942 = getelementptr double, ptr %172, i64 %816
  %943 = getelementptr double, ptr %942, i64 %941
  %944 = load double, ptr %943, align 8, !noalias !81
  %945 = getelementptr i8, ptr %929, i64 16
  %946 = fptosi double %944 to i64
  store i64 %946, ptr %945, align 8, !noalias !81
  %947 = getelementptr i8, ptr %929, i64 24
  store i64 0, ptr %947, align 8, !noalias !81
  %948 = select i1 %894, i64 %135, i64 0
  %949 = getelementptr double, ptr %136, i64 %816
  %950 = getelementptr double, ptr %949, i64 %948
  %951 = load double, ptr %950, align 8, !noalias !81
  %952 = select i1 %925, i64 %230, i64 0
  %953 = getelementptr double, ptr %231, i64 %904
  %954 = getelementptr double, ptr %953, i64 %952
  store double %951, ptr %954, align 8, !noalias !81
  store i64 -1, ptr %903, align 8, !noalias !81
  br label %970

955:                                              ; preds = %916
  %956 = add nsw i64 %918, -1
  %957 = add i64 %917, 1
  %958 = shl nsw i64 %917, 3
  %959 = select i1 %894, i64 %186, i64 0
  %960 = getelementptr i64, ptr %187, i64 %816
  %961 = getelementptr i64, ptr %960, i64 %959
  %962 = load i64, ptr %961, align 8, !noalias !81
  %963 = add nsw i64 %962, %958
  %964 = load i64, ptr %232, align 8, !noalias !81
  %965 = call i64 @llvm.smax.i64(i64 %964, i64 0)
  br label %920

966:                                              ; preds = %920
  %967 = add nsw i64 %921, -1
  %968 = inttoptr i64 %922 to ptr
  store atomic i64 9221120237041090560, ptr %968 unordered, align 8, !noalias !81
  %969 = add nsw i64 %922, %907
  br label %920

970:                                              ; preds = %924, %893, %890
  br label %815

971:                                              ; preds = %512
  %972 = call i64 @llvm.smax.i64(i64 %499, i64 0)
  br label %515

973:                                              ; preds = %515
  %974 = add nsw i64 %517, -1
  %975 = add i64 %516, 1
  %976 = shl i64 %516, 6
  %977 = getelementptr i8, ptr %98, i64 %976
  %978 = load <8 x double>, ptr %977, align 8, !noalias !48
  %979 = getelementptr i8, ptr %116, i64 %976
  %980 = load <8 x double>, ptr %979, align 8, !noalias !48
  %981 = select <8 x i1> %501, <8 x double> %978, <8 x double> %980
  store <8 x double> %981, ptr %979, align 8, !noalias !48
  br label %515

982:                                              ; preds = %695
  %983 = add nsw i64 %697, -1
  %984 = add i64 %696, 1
  %985 = shl nuw i64 1, %696
  %986 = and i64 %274, %985
  %987 = icmp eq i64 %986, 0
  br i1 %987, label %721, label %699

988:                                              ; preds = %815
  %989 = add nsw i64 %817, -1
  %990 = add i64 %816, 1
  %991 = shl nuw i64 1, %816
  %992 = and i64 %513, %991
  %993 = icmp eq i64 %992, 0
  br i1 %993, label %890, label %819

994:                                              ; preds = %815, %1006
  %995 = phi i64 [ %2206, %1006 ], [ 0, %815 ]
  %996 = phi i64 [ %2205, %1006 ], [ 8, %815 ]
  %997 = phi i1 [ %1007, %1006 ], [ false, %815 ]
  %998 = icmp sgt i64 %996, 0
  br i1 %998, label %2204, label %1008

999:                                              ; preds = %2204
  %1000 = icmp slt i64 %995, 0
  %1001 = select i1 %1000, i64 %181, i64 0
  %1002 = getelementptr i64, ptr %182, i64 %995
  %1003 = getelementptr i64, ptr %1002, i64 %1001
  %1004 = load i64, ptr %1003, align 8, !noalias !12
  %1005 = icmp eq i64 %1004, -1
  br label %1006

1006:                                             ; preds = %999, %2204
  %1007 = phi i1 [ true, %2204 ], [ %1005, %999 ]
  br label %994

1008:                                             ; preds = %994
  br i1 %997, label %270, label %1009

1009:                                             ; preds = %496, %1008, %267
  %1010 = phi i64 [ %268, %267 ], [ %275, %1008 ], [ %275, %496 ]
  %1011 = phi i1 [ false, %267 ], [ false, %1008 ], [ true, %496 ]
  %1012 = getelementptr i8, ptr %190, i64 8
  %1013 = load i64, ptr %1012, align 8, !noalias !12
  %1014 = icmp slt i64 %1013, 1
  br i1 %1014, label %1015, label %1016

1015:                                             ; preds = %1009
  br label %2256

1016:                                             ; preds = %1009
  %1017 = add nsw i64 %1013, -1
  store i64 %1017, ptr %1012, align 8, !noalias !12
  %1018 = load <8 x double>, ptr %136, align 8, !noalias !12
  %1019 = load <8 x double>, ptr %141, align 8, !noalias !12
  %1020 = trunc i64 %1010 to i8
  %1021 = bitcast i8 %1020 to <8 x i1>
  br i1 %248, label %1022, label %1029

1022:                                             ; preds = %1016
  %1023 = insertelement <8 x double> poison, double %239, i64 0
  %1024 = shufflevector <8 x double> %1023, <8 x double> poison, <8 x i32> zeroinitializer
  %1025 = insertelement <8 x double> poison, double %240, i64 0
  %1026 = shufflevector <8 x double> %1025, <8 x double> poison, <8 x i32> zeroinitializer
  %1027 = fcmp olt <8 x double> %1019, %1026
  %1028 = select <8 x i1> %1027, <8 x double> %1019, <8 x double> %1026
  br label %1036

1029:                                             ; preds = %1016
  %1030 = load <8 x double>, ptr %157, align 8, !noalias !12
  %1031 = fsub <8 x double> %1030, %1018
  %1032 = fdiv <8 x double> %1031, %1019
  %1033 = fmul <8 x double> %1032, splat (double 0x3FEFFFFFFFFFDCD1)
  %1034 = call <8 x double> @llvm.ceil.v8f64(<8 x double> %1033)
  %1035 = fdiv <8 x double> %1031, %1034
  br label %1036

1036:                                             ; preds = %1029, %1022
  %1037 = phi <8 x double> [ %1024, %1022 ], [ %1030, %1029 ]
  %1038 = phi <8 x double> [ %1028, %1022 ], [ %1035, %1029 ]
  %1039 = fadd <8 x double> %1018, %1038
  %1040 = fmul <8 x double> %1038, splat (double 1.000000e-03)
  %1041 = fsub <8 x double> %1037, %1040
  %1042 = fcmp ogt <8 x double> %1039, %1041
  %1043 = fsub <8 x double> %1037, %1018
  %1044 = select <8 x i1> %1042, <8 x double> %1043, <8 x double> %1038
  %1045 = select <8 x i1> %1042, <8 x double> %1037, <8 x double> %1039
  %1046 = select <8 x i1> %1021, <8 x double> %1044, <8 x double> zeroinitializer
  %1047 = fmul <8 x double> %1046, splat (double 6.250000e-02)
  %1048 = fadd <8 x double> %1018, %1047
  %1049 = fcmp ule <8 x double> %1048, %1018
  %1050 = fcmp une <8 x double> %1045, %1037
  %1051 = and <8 x i1> %1049, %1050
  %1052 = load <8 x double>, ptr %162, align 8, !noalias !12
  %1053 = load <8 x double>, ptr %167, align 8, !noalias !12
  %1054 = fadd <8 x double> %1052, %1053
  %1055 = insertelement <8 x double> poison, double %259, i64 0
  %1056 = shufflevector <8 x double> %1055, <8 x double> poison, <8 x i32> zeroinitializer
  %1057 = fcmp oge <8 x double> %1054, %1056
  %1058 = or <8 x i1> %1057, %1051
  %1059 = and <8 x i1> %1058, %1021
  %1060 = bitcast <8 x i1> %1059 to i8
  %1061 = zext i8 %1060 to i64
  %1062 = icmp eq i8 %1060, 0
  br i1 %1062, label %1159, label %1063

1063:                                             ; preds = %1036
  %1064 = bitcast <8 x i1> %1057 to i8
  %1065 = zext i8 %1064 to i64
  br label %1066

1066:                                             ; preds = %1063, %1152
  %1067 = phi i64 [ 0, %1063 ], [ %1155, %1152 ]
  %1068 = phi i64 [ 8, %1063 ], [ %1154, %1152 ]
  %1069 = icmp sgt i64 %1068, 0
  br i1 %1069, label %1153, label %265

1070:                                             ; preds = %1153
  %1071 = and i64 %1156, %1065
  %1072 = icmp eq i64 %1071, 0
  br i1 %1072, label %1073, label %1080

1073:                                             ; preds = %1070
  %1074 = icmp slt i64 %1067, 0
  %1075 = select i1 %1074, i64 %176, i64 0
  %1076 = getelementptr double, ptr %177, i64 %1067
  %1077 = getelementptr double, ptr %1076, i64 %1075
  %1078 = load double, ptr %1077, align 8, !noalias !85
  %1079 = fptosi double %1078 to i64
  br label %1080

1080:                                             ; preds = %1070, %1073
  %1081 = phi i64 [ %1079, %1073 ], [ 1, %1070 ]
  %1082 = icmp slt i64 %1067, 0
  %1083 = select i1 %1082, i64 %181, i64 0
  %1084 = getelementptr i64, ptr %182, i64 %1067
  %1085 = getelementptr i64, ptr %1084, i64 %1083
  %1086 = load i64, ptr %1085, align 8, !noalias !89
  %1087 = getelementptr i8, ptr %190, i64 32
  %1088 = load i64, ptr %1087, align 8, !noalias !89
  %1089 = shl nsw i64 %1088, 3
  %1090 = select i1 %1082, i64 %151, i64 0
  %1091 = getelementptr double, ptr %152, i64 %1067
  %1092 = getelementptr double, ptr %1091, i64 %1090
  %1093 = load double, ptr %1092, align 8, !noalias !89
  %1094 = fptosi double %1093 to i64
  %1095 = xor i64 %1094, -1
  %1096 = add i64 %197, %1095
  %1097 = call i64 @llvm.smax.i64(i64 %1096, i64 0)
  br label %1098

1098:                                             ; preds = %1102, %1080
  %1099 = phi i64 [ 0, %1080 ], [ %1139, %1102 ]
  %1100 = phi i64 [ %1097, %1080 ], [ %1138, %1102 ]
  %1101 = icmp sgt i64 %1100, 0
  br i1 %1101, label %1137, label %1106

1102:                                             ; preds = %1137, %1148
  %1103 = phi i64 [ %1147, %1137 ], [ %1149, %1148 ]
  %1104 = phi i64 [ %1145, %1137 ], [ %1151, %1148 ]
  %1105 = icmp sgt i64 %1103, 0
  br i1 %1105, label %1148, label %1098

1106:                                             ; preds = %1098
  %1107 = icmp slt i64 %1086, 0
  %1108 = select i1 %1107, i64 %223, i64 0
  %1109 = add i64 %1086, %1108
  %1110 = mul i64 %1109, %225
  %1111 = getelementptr i64, ptr %226, i64 %1110
  %1112 = select i1 %1082, i64 %161, i64 0
  %1113 = getelementptr double, ptr %162, i64 %1067
  %1114 = getelementptr double, ptr %1113, i64 %1112
  %1115 = load double, ptr %1114, align 8, !noalias !89
  %1116 = select i1 %1082, i64 %166, i64 0
  %1117 = getelementptr double, ptr %167, i64 %1067
  %1118 = getelementptr double, ptr %1117, i64 %1116
  %1119 = load double, ptr %1118, align 8, !noalias !89
  %1120 = fptosi double %1115 to i64
  store i64 %1120, ptr %1111, align 8, !noalias !89
  %1121 = getelementptr i8, ptr %1111, i64 8
  %1122 = fptosi double %1119 to i64
  store i64 %1122, ptr %1121, align 8, !noalias !89
  %1123 = select i1 %1082, i64 %171, i64 0
  %1124 = getelementptr double, ptr %172, i64 %1067
  %1125 = getelementptr double, ptr %1124, i64 %1123
  %1126 = load double, ptr %1125, align 8, !noalias !89
  %1127 = getelementptr i8, ptr %1111, i64 16
  %1128 = fptosi double %1126 to i64
  store i64 %1128, ptr %1127, align 8, !noalias !89
  %1129 = getelementptr i8, ptr %1111, i64 24
  store i64 %1081, ptr %1129, align 8, !noalias !89
  %1130 = select i1 %1082, i64 %135, i64 0
  %1131 = getelementptr double, ptr %136, i64 %1067
  %1132 = getelementptr double, ptr %1131, i64 %1130
  %1133 = load double, ptr %1132, align 8, !noalias !89
  %1134 = select i1 %1107, i64 %230, i64 0
  %1135 = getelementptr double, ptr %231, i64 %1086
  %1136 = getelementptr double, ptr %1135, i64 %1134
  store double %1133, ptr %1136, align 8, !noalias !89
  store i64 -1, ptr %1085, align 8, !noalias !89
  br label %1152

1137:                                             ; preds = %1098
  %1138 = add nsw i64 %1100, -1
  %1139 = add i64 %1099, 1
  %1140 = shl nsw i64 %1099, 3
  %1141 = select i1 %1082, i64 %186, i64 0
  %1142 = getelementptr i64, ptr %187, i64 %1067
  %1143 = getelementptr i64, ptr %1142, i64 %1141
  %1144 = load i64, ptr %1143, align 8, !noalias !89
  %1145 = add nsw i64 %1144, %1140
  %1146 = load i64, ptr %232, align 8, !noalias !89
  %1147 = call i64 @llvm.smax.i64(i64 %1146, i64 0)
  br label %1102

1148:                                             ; preds = %1102
  %1149 = add nsw i64 %1103, -1
  %1150 = inttoptr i64 %1104 to ptr
  store atomic i64 9221120237041090560, ptr %1150 unordered, align 8, !noalias !89
  %1151 = add nsw i64 %1104, %1089
  br label %1102

1152:                                             ; preds = %1106, %1153
  br label %1066

1153:                                             ; preds = %1066
  %1154 = add nsw i64 %1068, -1
  %1155 = add i64 %1067, 1
  %1156 = shl nuw i64 1, %1067
  %1157 = and i64 %1156, %1061
  %1158 = icmp eq i64 %1157, 0
  br i1 %1158, label %1152, label %1070

1159:                                             ; preds = %1036
  store <8 x double> %1046, ptr %101, align 8, !noalias !93
  %1160 = load i64, ptr %19, align 8, !noalias !93
  %1161 = add i64 %1160, -1
  %1162 = call i64 @llvm.smax.i64(i64 %1161, i64 0)
  br label %1163

1163:                                             ; preds = %1221, %1159
  %1164 = phi i64 [ 1, %1159 ], [ %1189, %1221 ]
  %1165 = phi i64 [ %1162, %1159 ], [ %1188, %1221 ]
  %1166 = phi i64 [ 0, %1159 ], [ %1227, %1221 ]
  %1167 = icmp sgt i64 %1165, 0
  br i1 %1167, label %1187, label %1168

1168:                                             ; preds = %1163
  %1169 = load i64, ptr %19, align 8, !noalias !93
  %1170 = getelementptr i8, ptr %39, i64 16
  %1171 = load i64, ptr %1170, align 8, !noalias !97
  %1172 = icmp slt i64 %1169, 0
  %1173 = select i1 %1172, i64 %23, i64 0
  %1174 = getelementptr i64, ptr %24, i64 %1169
  %1175 = getelementptr i64, ptr %1174, i64 %1173
  %1176 = load i64, ptr %1175, align 8, !noalias !101
  %1177 = shl i64 %1176, 3
  %1178 = add i64 %26, %1177
  %1179 = add i64 %28, %1177
  %1180 = icmp slt i64 %1169, -1
  %1181 = select i1 %1180, i64 %23, i64 0
  %1182 = getelementptr i8, ptr %1174, i64 8
  %1183 = getelementptr i64, ptr %1182, i64 %1181
  %1184 = load i64, ptr %1183, align 8, !noalias !101
  %1185 = xor i64 %1176, -1
  %1186 = add i64 %1184, %1185
  call fastcc void @pydy_combine(i64 %90, i64 %85, i64 %100, i64 %113, i64 %1178, i64 %1179, i64 %1186, i64 1, i64 %1171) #3, !noalias !101
  br i1 %251, label %1240, label %1229

1187:                                             ; preds = %1163
  %1188 = add nsw i64 %1165, -1
  %1189 = add i64 %1164, 1
  %1190 = getelementptr i8, ptr %39, i64 16
  %1191 = load i64, ptr %1190, align 8, !noalias !104
  %1192 = icmp slt i64 %1164, 0
  %1193 = select i1 %1192, i64 %23, i64 0
  %1194 = getelementptr i64, ptr %24, i64 %1164
  %1195 = getelementptr i64, ptr %1194, i64 %1193
  %1196 = load i64, ptr %1195, align 8, !noalias !108
  %1197 = shl i64 %1196, 3
  %1198 = add i64 %26, %1197
  %1199 = add i64 %28, %1197
  %1200 = icmp slt i64 %1164, -1
  %1201 = select i1 %1200, i64 %23, i64 0
  %1202 = getelementptr i8, ptr %1194, i64 8
  %1203 = getelementptr i64, ptr %1202, i64 %1201
  %1204 = load i64, ptr %1203, align 8, !noalias !108
  %1205 = xor i64 %1196, -1
  %1206 = add i64 %1204, %1205
  call fastcc void @pydy_combine(i64 %95, i64 %85, i64 %100, i64 %113, i64 %1198, i64 %1199, i64 %1206, i64 1, i64 %1191) #3, !noalias !108
  %1207 = mul nsw i64 %1164, %87
  %1208 = shl i64 %1207, 3
  %1209 = add i64 %113, %1208
  %1210 = select i1 %1192, i64 %32, i64 0
  %1211 = getelementptr double, ptr %33, i64 %1164
  %1212 = getelementptr double, ptr %1211, i64 %1210
  %1213 = load double, ptr %1212, align 8, !noalias !93
  %1214 = insertelement <8 x double> poison, double %1213, i64 0
  %1215 = shufflevector <8 x double> %1214, <8 x double> poison, <8 x i32> zeroinitializer
  %1216 = fmul <8 x double> %1215, %1046
  %1217 = fadd <8 x double> %1018, %1216
  store ptr null, ptr %8, align 8, !noalias !111
  store ptr null, ptr %9, align 8, !noalias !111
  store <8 x double> %1217, ptr %44, align 8, !noalias !111
  %1218 = icmp sgt i64 %61, 0
  br i1 %1218, label %1219, label %1221

1219:                                             ; preds = %1187
  store ptr null, ptr %8, align 8, !noalias !111
  %1220 = call fastcc i32 @_set_inputs(ptr nonnull %8, ptr nonnull %44, i64 %43, ptr %49, i64 %48, ptr %64, i64 %61, i64 %63, ptr %71, i64 %68, i64 %70, ptr %76, i64 %75, ptr %83, i64 %80, i64 %82) #3
  switch i32 %1220, label %1228 [
    i32 -2, label %1221
    i32 0, label %1221
  ], !prof !56

1221:                                             ; preds = %1219, %1219, %1187
  %1222 = load i64, ptr %39, align 8, !noalias !111
  %1223 = inttoptr i64 %1222 to ptr
  %1224 = inttoptr i64 %1209 to ptr
  %1225 = call i32 %1223(ptr nonnull %44, ptr %98, ptr %49, ptr %57, ptr %1224) #3, !noalias !111
  %1226 = sext i32 %1225 to i64
  %1227 = or i64 %1166, %1226
  br label %1163

1228:                                             ; preds = %1219
  br label %2256

1229:                                             ; preds = %1168
  store ptr null, ptr %6, align 8, !noalias !115
  store ptr null, ptr %7, align 8, !noalias !115
  store <8 x double> %1045, ptr %44, align 8, !noalias !115
  %1230 = icmp sgt i64 %61, 0
  br i1 %1230, label %1231, label %1233

1231:                                             ; preds = %1229
  store ptr null, ptr %6, align 8, !noalias !115
  %1232 = call fastcc i32 @_set_inputs(ptr nonnull %6, ptr nonnull %44, i64 %43, ptr %49, i64 %48, ptr %64, i64 %61, i64 %63, ptr %71, i64 %68, i64 %70, ptr %76, i64 %75, ptr %83, i64 %80, i64 %82) #3
  switch i32 %1232, label %2207 [
    i32 -2, label %1233
    i32 0, label %1233
  ], !prof !56

1233:                                             ; preds = %1231, %1231, %1229
  %1234 = load i64, ptr %39, align 8, !noalias !115
  %1235 = inttoptr i64 %1234 to ptr
  %1236 = inttoptr i64 %244 to ptr
  %1237 = call i32 %1235(ptr nonnull %44, ptr %93, ptr %49, ptr %57, ptr %1236) #3, !noalias !115
  %1238 = sext i32 %1237 to i64
  %1239 = or i64 %1166, %1238
  br label %1240

1240:                                             ; preds = %1233, %1168
  %1241 = phi i64 [ %1239, %1233 ], [ %1166, %1168 ]
  br i1 %248, label %1242, label %1411

1242:                                             ; preds = %1240
  %1243 = getelementptr i8, ptr %39, i64 24
  %1244 = load i64, ptr %1243, align 8, !noalias !119
  %1245 = getelementptr i8, ptr %39, i64 32
  %1246 = load i64, ptr %1245, align 8, !noalias !119
  %1247 = load i64, ptr %246, align 8, !noalias !119
  %1248 = load i64, ptr %19, align 8, !noalias !119
  %1249 = add nsw i64 %1248, 1
  %1250 = call i64 @llvm.smax.i64(i64 %1247, i64 0)
  br label %1251

1251:                                             ; preds = %1242, %1337
  %1252 = phi i64 [ 0, %1242 ], [ %1339, %1337 ]
  %1253 = phi i64 [ %1250, %1242 ], [ %1338, %1337 ]
  %1254 = icmp sgt i64 %1253, 0
  br i1 %1254, label %1337, label %1359

1255:                                             ; preds = %1369, %1373
  %1256 = phi i64 [ 0, %1369 ], [ %1375, %1373 ]
  %1257 = phi i64 [ %1372, %1369 ], [ %1374, %1373 ]
  %1258 = phi <8 x double> [ zeroinitializer, %1369 ], [ %1410, %1373 ]
  %1259 = phi <8 x double> [ zeroinitializer, %1369 ], [ %1408, %1373 ]
  %1260 = icmp sgt i64 %1257, 0
  br i1 %1260, label %1373, label %1261

1261:                                             ; preds = %1255
  %1262 = load i64, ptr %232, align 8, !noalias !119
  %1263 = add nsw i64 %1262, -3
  %1264 = sub i64 %1263, %1244
  %1265 = add nuw i64 %1264, 3
  %1266 = lshr i64 %1265, 2
  %1267 = icmp sgt i64 %1264, 0
  %1268 = select i1 %1267, i64 %1266, i64 0
  br label %1269

1269:                                             ; preds = %1261, %1292
  %1270 = phi i64 [ %1244, %1261 ], [ %1294, %1292 ]
  %1271 = phi i64 [ %1268, %1261 ], [ %1293, %1292 ]
  %1272 = phi <8 x double> [ zeroinitializer, %1261 ], [ %1299, %1292 ]
  %1273 = phi <8 x double> [ zeroinitializer, %1261 ], [ %1303, %1292 ]
  %1274 = phi <8 x double> [ zeroinitializer, %1261 ], [ %1307, %1292 ]
  %1275 = phi <8 x double> [ zeroinitializer, %1261 ], [ %1311, %1292 ]
  %1276 = icmp sgt i64 %1271, 0
  br i1 %1276, label %1292, label %1277

1277:                                             ; preds = %1269
  %1278 = sub nsw i64 %1262, %1244
  %1279 = and i64 %1278, 3
  %1280 = sub nsw i64 %1262, %1279
  br label %1281

1281:                                             ; preds = %1277, %1312
  %1282 = phi i64 [ %1280, %1277 ], [ %1314, %1312 ]
  %1283 = phi i64 [ %1279, %1277 ], [ %1313, %1312 ]
  %1284 = phi <8 x double> [ %1272, %1277 ], [ %1319, %1312 ]
  %1285 = icmp sgt i64 %1283, 0
  br i1 %1285, label %1312, label %1286

1286:                                             ; preds = %1281
  %1287 = fadd <8 x double> %1284, %1273
  %1288 = fadd <8 x double> %1274, %1275
  %1289 = fadd <8 x double> %1287, %1288
  %1290 = fadd <8 x double> %1259, %1289
  %1291 = icmp eq i64 %1247, 2
  br i1 %1291, label %1320, label %1331

1292:                                             ; preds = %1269
  %1293 = add nsw i64 %1271, -1
  %1294 = add i64 %1270, 4
  %1295 = shl i64 %1270, 6
  %1296 = getelementptr i8, ptr %93, i64 %1295
  %1297 = load <8 x double>, ptr %1296, align 8, !noalias !123
  %1298 = fmul <8 x double> %1297, zeroinitializer
  %1299 = fadd <8 x double> %1272, %1298
  %1300 = getelementptr i8, ptr %1296, i64 64
  %1301 = load <8 x double>, ptr %1300, align 8, !noalias !123
  %1302 = fmul <8 x double> %1301, zeroinitializer
  %1303 = fadd <8 x double> %1273, %1302
  %1304 = getelementptr i8, ptr %1296, i64 128
  %1305 = load <8 x double>, ptr %1304, align 8, !noalias !123
  %1306 = fmul <8 x double> %1305, zeroinitializer
  %1307 = fadd <8 x double> %1274, %1306
  %1308 = getelementptr i8, ptr %1296, i64 192
  %1309 = load <8 x double>, ptr %1308, align 8, !noalias !123
  %1310 = fmul <8 x double> %1309, zeroinitializer
  %1311 = fadd <8 x double> %1275, %1310
  br label %1269

1312:                                             ; preds = %1281
  %1313 = add nsw i64 %1283, -1
  %1314 = add i64 %1282, 1
  %1315 = shl i64 %1282, 6
  %1316 = getelementptr i8, ptr %93, i64 %1315
  %1317 = load <8 x double>, ptr %1316, align 8, !noalias !123
  %1318 = fmul <8 x double> %1317, zeroinitializer
  %1319 = fadd <8 x double> %1284, %1318
  br label %1281

1320:                                             ; preds = %1286
  %1321 = fcmp oeq <8 x double> %1290, zeroinitializer
  %1322 = fmul <8 x double> %1258, splat (double 1.000000e-02)
  %1323 = fadd <8 x double> %1290, %1322
  %1324 = sitofp i64 %1244 to double
  %1325 = insertelement <8 x double> poison, double %1324, i64 0
  %1326 = shufflevector <8 x double> %1325, <8 x double> poison, <8 x i32> zeroinitializer
  %1327 = fmul <8 x double> %1323, %1326
  %1328 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1327)
  %1329 = fdiv <8 x double> %1290, %1328
  %1330 = select <8 x i1> %1321, <8 x double> zeroinitializer, <8 x double> %1329
  br label %1418

1331:                                             ; preds = %1286
  %1332 = sitofp i64 %1244 to double
  %1333 = insertelement <8 x double> poison, double %1332, i64 0
  %1334 = shufflevector <8 x double> %1333, <8 x double> poison, <8 x i32> zeroinitializer
  %1335 = fdiv <8 x double> %1290, %1334
  %1336 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1335)
  br label %1418

1337:                                             ; preds = %1251
  %1338 = add nsw i64 %1253, -1
  %1339 = add i64 %1252, 1
  %1340 = mul nsw i64 %1252, %87
  %1341 = shl i64 %1340, 3
  %1342 = add i64 %108, %1341
  %1343 = add nsw i64 %1249, %1252
  %1344 = icmp slt i64 %1343, 0
  %1345 = select i1 %1344, i64 %23, i64 0
  %1346 = getelementptr i64, ptr %24, i64 %1343
  %1347 = getelementptr i64, ptr %1346, i64 %1345
  %1348 = load i64, ptr %1347, align 8, !noalias !127
  %1349 = shl i64 %1348, 3
  %1350 = add i64 %26, %1349
  %1351 = add i64 %28, %1349
  %1352 = icmp slt i64 %1343, -1
  %1353 = select i1 %1352, i64 %23, i64 0
  %1354 = getelementptr i8, ptr %1346, i64 8
  %1355 = getelementptr i64, ptr %1354, i64 %1353
  %1356 = load i64, ptr %1355, align 8, !noalias !127
  %1357 = xor i64 %1348, -1
  %1358 = add i64 %1356, %1357
  call fastcc void @pydy_combine(i64 %1342, i64 %106, i64 %100, i64 %113, i64 %1350, i64 %1351, i64 %1358, i64 1, i64 %1246) #3, !noalias !127
  br label %1251

1359:                                             ; preds = %1251
  %1360 = icmp slt i64 %87, 0
  %1361 = select i1 %1360, i64 %110, i64 0
  %1362 = add i64 %87, %1361
  %1363 = icmp slt i64 %1362, 0
  br i1 %1363, label %1364, label %1365, !prof !4

1364:                                             ; preds = %1359
  br label %1365

1365:                                             ; preds = %1364, %1359
  %1366 = phi i64 [ 0, %1364 ], [ %1362, %1359 ]
  %1367 = icmp slt i64 %1362, %110
  br i1 %1367, label %1369, label %1368, !prof !8

1368:                                             ; preds = %1365
  br label %1369

1369:                                             ; preds = %1368, %1365
  %1370 = phi i64 [ %110, %1368 ], [ %1366, %1365 ]
  %1371 = getelementptr double, ptr %111, i64 %1370
  %1372 = call i64 @llvm.smax.i64(i64 %1244, i64 0)
  br label %1255

1373:                                             ; preds = %1255
  %1374 = add nsw i64 %1257, -1
  %1375 = add i64 %1256, 1
  %1376 = shl i64 %1256, 6
  %1377 = getelementptr i8, ptr %88, i64 %1376
  %1378 = load <8 x double>, ptr %1377, align 8, !noalias !119
  %1379 = getelementptr i8, ptr %93, i64 %1376
  %1380 = load <8 x double>, ptr %1379, align 8, !noalias !119
  %1381 = icmp slt i64 %1256, 0
  %1382 = select i1 %1381, i64 %130, i64 0
  %1383 = getelementptr double, ptr %131, i64 %1256
  %1384 = getelementptr double, ptr %1383, i64 %1382
  %1385 = load double, ptr %1384, align 8, !noalias !130
  %1386 = select i1 %1381, i64 %125, i64 0
  %1387 = getelementptr double, ptr %126, i64 %1256
  %1388 = getelementptr double, ptr %1387, i64 %1386
  %1389 = load double, ptr %1388, align 8, !noalias !130
  %1390 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1378)
  %1391 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1380)
  %1392 = fcmp ogt <8 x double> %1390, %1391
  %1393 = select <8 x i1> %1392, <8 x double> %1390, <8 x double> %1391
  %1394 = insertelement <8 x double> poison, double %1389, i64 0
  %1395 = shufflevector <8 x double> %1394, <8 x double> poison, <8 x i32> zeroinitializer
  %1396 = fmul <8 x double> %1395, %1393
  %1397 = insertelement <8 x double> poison, double %1385, i64 0
  %1398 = shufflevector <8 x double> %1397, <8 x double> poison, <8 x i32> zeroinitializer
  %1399 = fadd <8 x double> %1398, %1396
  %1400 = fdiv <8 x double> splat (double 1.000000e+00), %1399
  %1401 = getelementptr i8, ptr %111, i64 %1376
  %1402 = load <8 x double>, ptr %1401, align 8, !noalias !119
  %1403 = fmul <8 x double> %1402, %1400
  %1404 = getelementptr i8, ptr %1371, i64 %1376
  %1405 = load <8 x double>, ptr %1404, align 8, !noalias !119
  %1406 = fmul <8 x double> %1405, %1400
  %1407 = fmul <8 x double> %1403, %1403
  %1408 = fadd <8 x double> %1259, %1407
  %1409 = fmul <8 x double> %1406, %1406
  %1410 = fadd <8 x double> %1258, %1409
  br label %1255

1411:                                             ; preds = %1240
  %1412 = call i64 @llvm.smax.i64(i64 %233, i64 0)
  br label %1413

1413:                                             ; preds = %1411, %2208
  %1414 = phi i64 [ 0, %1411 ], [ %2210, %2208 ]
  %1415 = phi i64 [ %1412, %1411 ], [ %2209, %2208 ]
  %1416 = phi <8 x double> [ zeroinitializer, %1411 ], [ %2215, %2208 ]
  %1417 = icmp sgt i64 %1415, 0
  br i1 %1417, label %2208, label %1418

1418:                                             ; preds = %1413, %1320, %1331
  %1419 = phi <8 x double> [ %1416, %1413 ], [ %1336, %1331 ], [ %1330, %1320 ]
  %1420 = fcmp olt <8 x double> %1419, splat (double 1.000000e+00)
  %1421 = trunc i64 %1241 to i8
  %1422 = bitcast i8 %1421 to <8 x i1>
  %1423 = xor <8 x i1> %1422, splat (i1 true)
  %1424 = and <8 x i1> %1420, %1423
  %1425 = and <8 x i1> %1424, %1021
  %1426 = bitcast <8 x i1> %1425 to i8
  %1427 = icmp ne i8 %1426, 0
  %1428 = select i1 %251, i1 %1427, i1 false
  br i1 %1428, label %1429, label %1444

1429:                                             ; preds = %1418
  store ptr null, ptr %4, align 8, !noalias !133
  store ptr null, ptr %5, align 8, !noalias !133
  store <8 x double> %1045, ptr %44, align 8, !noalias !133
  %1430 = icmp sgt i64 %61, 0
  br i1 %1430, label %1431, label %1433

1431:                                             ; preds = %1429
  store ptr null, ptr %4, align 8, !noalias !133
  %1432 = call fastcc i32 @_set_inputs(ptr nonnull %4, ptr nonnull %44, i64 %43, ptr %49, i64 %48, ptr %64, i64 %61, i64 %63, ptr %71, i64 %68, i64 %70, ptr %76, i64 %75, ptr %83, i64 %80, i64 %82) #3
  switch i32 %1432, label %2216 [
    i32 -2, label %1433
    i32 0, label %1433
  ], !prof !56

1433:                                             ; preds = %1431, %1431, %1429
  %1434 = load i64, ptr %39, align 8, !noalias !133
  %1435 = inttoptr i64 %1434 to ptr
  %1436 = inttoptr i64 %244 to ptr
  %1437 = call i32 %1435(ptr nonnull %44, ptr %93, ptr %49, ptr %57, ptr %1436) #3, !noalias !133
  %1438 = sext i32 %1437 to i64
  %1439 = or i64 %1241, %1438
  %1440 = trunc i64 %1439 to i8
  %1441 = bitcast i8 %1440 to <8 x i1>
  %1442 = xor <8 x i1> %1441, splat (i1 true)
  %1443 = and <8 x i1> %1425, %1442
  br label %1444

1444:                                             ; preds = %1433, %1418
  %1445 = phi i64 [ %1241, %1418 ], [ %1439, %1433 ]
  %1446 = phi <8 x i1> [ %1425, %1418 ], [ %1443, %1433 ]
  %1447 = load <8 x double>, ptr %172, align 8, !noalias !12
  %1448 = insertelement <8 x double> poison, double %254, i64 0
  %1449 = shufflevector <8 x double> %1448, <8 x double> poison, <8 x i32> zeroinitializer
  %1450 = fadd <8 x double> %1447, %1449
  %1451 = insertelement <8 x double> poison, double %256, i64 0
  %1452 = shufflevector <8 x double> %1451, <8 x double> poison, <8 x i32> zeroinitializer
  %1453 = select <8 x i1> %1425, <8 x double> %1452, <8 x double> zeroinitializer
  %1454 = fadd <8 x double> %1450, %1453
  store <8 x double> %1454, ptr %172, align 8, !noalias !12
  %1455 = load <8 x double>, ptr %157, align 8, !noalias !12
  %1456 = fcmp olt <8 x double> %1455, %1045
  %1457 = and <8 x i1> %1446, %1456
  %1458 = bitcast <8 x i1> %1457 to i8
  %1459 = icmp eq i8 %1458, 0
  br i1 %1459, label %1801, label %1460

1460:                                             ; preds = %1444
  %1461 = load i64, ptr %19, align 8, !noalias !137
  %1462 = getelementptr i8, ptr %19, i64 16
  %1463 = load i64, ptr %1462, align 8, !noalias !137
  %1464 = call i64 @llvm.smax.i64(i64 %1463, i64 0)
  br label %1465

1465:                                             ; preds = %1609, %1460
  %1466 = phi i64 [ %1461, %1460 ], [ %1469, %1609 ]
  %1467 = phi i64 [ %1464, %1460 ], [ %1575, %1609 ]
  %1468 = phi i64 [ 0, %1460 ], [ %1615, %1609 ]
  %1469 = add i64 %1466, 1
  %1470 = icmp sgt i64 %1467, 0
  br i1 %1470, label %1574, label %1471

1471:                                             ; preds = %1465
  %1472 = load i64, ptr %232, align 8, !noalias !141
  %1473 = load i64, ptr %19, align 8, !noalias !141
  %1474 = mul nsw i64 %1473, %87
  %1475 = icmp slt i64 %1474, 0
  %1476 = select i1 %1475, i64 %115, i64 0
  %1477 = add i64 %1474, %1476
  %1478 = icmp slt i64 %1477, 0
  br i1 %1478, label %1497, label %1498, !prof !4

1479:                                             ; preds = %1525, %1529
  %1480 = phi i64 [ 0, %1525 ], [ %1531, %1529 ]
  %1481 = phi i64 [ %1528, %1525 ], [ %1530, %1529 ]
  %1482 = icmp sgt i64 %1481, 0
  br i1 %1482, label %1529, label %1483

1483:                                             ; preds = %1479
  %1484 = add nsw i64 %1473, 1
  %1485 = load i64, ptr %246, align 8, !noalias !141
  %1486 = add nsw i64 %1484, %1485
  %1487 = load i64, ptr %1462, align 8, !noalias !141
  %1488 = add nsw i64 %1486, %1487
  %1489 = getelementptr i8, ptr %19, i64 24
  %1490 = load i64, ptr %1489, align 8, !noalias !141
  %1491 = add i64 %1490, -3
  %1492 = call i64 @llvm.smax.i64(i64 %1491, i64 0)
  br label %1493

1493:                                             ; preds = %1483, %1550
  %1494 = phi i64 [ 3, %1483 ], [ %1552, %1550 ]
  %1495 = phi i64 [ %1492, %1483 ], [ %1551, %1550 ]
  %1496 = icmp sgt i64 %1495, 0
  br i1 %1496, label %1550, label %2217

1497:                                             ; preds = %1471
  br label %1498

1498:                                             ; preds = %1497, %1471
  %1499 = phi i64 [ 0, %1497 ], [ %1477, %1471 ]
  %1500 = icmp slt i64 %1477, %115
  br i1 %1500, label %1502, label %1501, !prof !8

1501:                                             ; preds = %1498
  br label %1502

1502:                                             ; preds = %1501, %1498
  %1503 = phi i64 [ %115, %1501 ], [ %1499, %1498 ]
  %1504 = getelementptr double, ptr %116, i64 %1503
  %1505 = icmp slt i64 %87, 0
  %1506 = select i1 %1505, i64 %120, i64 0
  %1507 = add i64 %87, %1506
  %1508 = icmp slt i64 %1507, 0
  br i1 %1508, label %1509, label %1510, !prof !4

1509:                                             ; preds = %1502
  br label %1510

1510:                                             ; preds = %1509, %1502
  %1511 = phi i64 [ 0, %1509 ], [ %1507, %1502 ]
  %1512 = icmp slt i64 %1507, %120
  br i1 %1512, label %1514, label %1513, !prof !8

1513:                                             ; preds = %1510
  br label %1514

1514:                                             ; preds = %1513, %1510
  %1515 = phi i64 [ %120, %1513 ], [ %1511, %1510 ]
  %1516 = getelementptr double, ptr %121, i64 %1515
  %1517 = shl nsw i64 %87, 1
  %1518 = add i64 %1517, %1506
  %1519 = icmp slt i64 %1518, 0
  br i1 %1519, label %1520, label %1521, !prof !4

1520:                                             ; preds = %1514
  br label %1521

1521:                                             ; preds = %1520, %1514
  %1522 = phi i64 [ 0, %1520 ], [ %1518, %1514 ]
  %1523 = icmp slt i64 %1518, %120
  br i1 %1523, label %1525, label %1524, !prof !8

1524:                                             ; preds = %1521
  br label %1525

1525:                                             ; preds = %1524, %1521
  %1526 = phi i64 [ %120, %1524 ], [ %1522, %1521 ]
  %1527 = getelementptr double, ptr %121, i64 %1526
  %1528 = call i64 @llvm.smax.i64(i64 %1472, i64 0)
  br label %1479

1529:                                             ; preds = %1479
  %1530 = add nsw i64 %1481, -1
  %1531 = add i64 %1480, 1
  %1532 = shl i64 %1480, 6
  %1533 = getelementptr i8, ptr %93, i64 %1532
  %1534 = load <8 x double>, ptr %1533, align 8, !noalias !141
  %1535 = getelementptr i8, ptr %88, i64 %1532
  %1536 = load <8 x double>, ptr %1535, align 8, !noalias !141
  %1537 = fsub <8 x double> %1534, %1536
  %1538 = getelementptr i8, ptr %116, i64 %1532
  %1539 = load <8 x double>, ptr %1538, align 8, !noalias !141
  %1540 = fmul <8 x double> %1046, %1539
  %1541 = fsub <8 x double> %1540, %1537
  %1542 = getelementptr i8, ptr %121, i64 %1532
  store <8 x double> %1537, ptr %1542, align 8, !noalias !141
  %1543 = getelementptr i8, ptr %1516, i64 %1532
  store <8 x double> %1541, ptr %1543, align 8, !noalias !141
  %1544 = fsub <8 x double> %1537, %1541
  %1545 = getelementptr i8, ptr %1504, i64 %1532
  %1546 = load <8 x double>, ptr %1545, align 8, !noalias !141
  %1547 = fmul <8 x double> %1046, %1546
  %1548 = fsub <8 x double> %1544, %1547
  %1549 = getelementptr i8, ptr %1527, i64 %1532
  store <8 x double> %1548, ptr %1549, align 8, !noalias !141
  br label %1479

1550:                                             ; preds = %1493
  %1551 = add nsw i64 %1495, -1
  %1552 = add i64 %1494, 1
  %1553 = mul nsw i64 %1494, %87
  %1554 = shl i64 %1553, 3
  %1555 = add i64 %118, %1554
  %1556 = add nsw i64 %1488, %1494
  %1557 = load i64, ptr %1170, align 8, !noalias !145
  %1558 = icmp slt i64 %1556, 3
  %1559 = select i1 %1558, i64 %23, i64 0
  %1560 = getelementptr i64, ptr %24, i64 %1556
  %1561 = getelementptr i8, ptr %1560, i64 -24
  %1562 = getelementptr i64, ptr %1561, i64 %1559
  %1563 = load i64, ptr %1562, align 8, !noalias !149
  %1564 = shl i64 %1563, 3
  %1565 = add i64 %26, %1564
  %1566 = add i64 %28, %1564
  %1567 = icmp slt i64 %1556, 2
  %1568 = select i1 %1567, i64 %23, i64 0
  %1569 = getelementptr i8, ptr %1560, i64 -16
  %1570 = getelementptr i64, ptr %1569, i64 %1568
  %1571 = load i64, ptr %1570, align 8, !noalias !149
  %1572 = xor i64 %1563, -1
  %1573 = add i64 %1571, %1572
  call fastcc void @pydy_combine(i64 %1555, i64 %106, i64 %100, i64 %113, i64 %1565, i64 %1566, i64 %1573, i64 1, i64 %1557) #3, !noalias !149
  br label %1493

1574:                                             ; preds = %1465
  %1575 = add nsw i64 %1467, -1
  %1576 = load i64, ptr %246, align 8, !noalias !137
  %1577 = add nsw i64 %1469, %1576
  %1578 = load i64, ptr %1170, align 8, !noalias !152
  %1579 = icmp slt i64 %1577, 0
  %1580 = select i1 %1579, i64 %23, i64 0
  %1581 = getelementptr i64, ptr %24, i64 %1577
  %1582 = getelementptr i64, ptr %1581, i64 %1580
  %1583 = load i64, ptr %1582, align 8, !noalias !156
  %1584 = shl i64 %1583, 3
  %1585 = add i64 %26, %1584
  %1586 = add i64 %28, %1584
  %1587 = icmp slt i64 %1577, -1
  %1588 = select i1 %1587, i64 %23, i64 0
  %1589 = getelementptr i8, ptr %1581, i64 8
  %1590 = getelementptr i64, ptr %1589, i64 %1588
  %1591 = load i64, ptr %1590, align 8, !noalias !156
  %1592 = xor i64 %1583, -1
  %1593 = add i64 %1591, %1592
  call fastcc void @pydy_combine(i64 %95, i64 %85, i64 %100, i64 %113, i64 %1585, i64 %1586, i64 %1593, i64 1, i64 %1578) #3, !noalias !156
  %1594 = mul nsw i64 %1469, %87
  %1595 = shl i64 %1594, 3
  %1596 = add i64 %113, %1595
  %1597 = icmp slt i64 %1469, 0
  %1598 = select i1 %1597, i64 %32, i64 0
  %1599 = getelementptr double, ptr %33, i64 %1469
  %1600 = getelementptr double, ptr %1599, i64 %1598
  %1601 = load double, ptr %1600, align 8, !noalias !137
  %1602 = insertelement <8 x double> poison, double %1601, i64 0
  %1603 = shufflevector <8 x double> %1602, <8 x double> poison, <8 x i32> zeroinitializer
  %1604 = fmul <8 x double> %1603, %1046
  %1605 = fadd <8 x double> %1018, %1604
  store ptr null, ptr %2, align 8, !noalias !159
  store ptr null, ptr %3, align 8, !noalias !159
  store <8 x double> %1605, ptr %44, align 8, !noalias !159
  %1606 = icmp sgt i64 %61, 0
  br i1 %1606, label %1607, label %1609

1607:                                             ; preds = %1574
  store ptr null, ptr %2, align 8, !noalias !159
  %1608 = call fastcc i32 @_set_inputs(ptr nonnull %2, ptr nonnull %44, i64 %43, ptr %49, i64 %48, ptr %64, i64 %61, i64 %63, ptr %71, i64 %68, i64 %70, ptr %76, i64 %75, ptr %83, i64 %80, i64 %82) #3
  switch i32 %1608, label %1616 [
    i32 -2, label %1609
    i32 0, label %1609
  ], !prof !56

1609:                                             ; preds = %1607, %1607, %1574
  %1610 = load i64, ptr %39, align 8, !noalias !159
  %1611 = inttoptr i64 %1610 to ptr
  %1612 = inttoptr i64 %1596 to ptr
  %1613 = call i32 %1611(ptr nonnull %44, ptr %98, ptr %49, ptr %57, ptr %1612) #3, !noalias !159
  %1614 = sext i32 %1613 to i64
  %1615 = or i64 %1468, %1614
  br label %1465

1616:                                             ; preds = %1607
  br label %2256

1617:                                             ; preds = %2217, %1692
  %1618 = phi i64 [ %2230, %1692 ], [ 0, %2217 ]
  %1619 = phi i64 [ %2229, %1692 ], [ 8, %2217 ]
  %1620 = icmp sgt i64 %1619, 0
  br i1 %1620, label %2228, label %1693

1621:                                             ; preds = %2228
  %1622 = icmp slt i64 %1618, 0
  %1623 = select i1 %1622, i64 %181, i64 0
  %1624 = getelementptr i64, ptr %182, i64 %1618
  %1625 = getelementptr i64, ptr %1624, i64 %1623
  %1626 = load i64, ptr %1625, align 8, !noalias !163
  %1627 = getelementptr i8, ptr %190, i64 32
  %1628 = load i64, ptr %1627, align 8, !noalias !163
  %1629 = shl nsw i64 %1628, 3
  %1630 = select i1 %1622, i64 %151, i64 0
  %1631 = getelementptr double, ptr %152, i64 %1618
  %1632 = getelementptr double, ptr %1631, i64 %1630
  %1633 = load double, ptr %1632, align 8, !noalias !163
  %1634 = fptosi double %1633 to i64
  %1635 = xor i64 %1634, -1
  %1636 = add i64 %197, %1635
  %1637 = call i64 @llvm.smax.i64(i64 %1636, i64 0)
  br label %1638

1638:                                             ; preds = %1642, %1621
  %1639 = phi i64 [ 0, %1621 ], [ %1679, %1642 ]
  %1640 = phi i64 [ %1637, %1621 ], [ %1678, %1642 ]
  %1641 = icmp sgt i64 %1640, 0
  br i1 %1641, label %1677, label %1646

1642:                                             ; preds = %1677, %1688
  %1643 = phi i64 [ %1687, %1677 ], [ %1689, %1688 ]
  %1644 = phi i64 [ %1685, %1677 ], [ %1691, %1688 ]
  %1645 = icmp sgt i64 %1643, 0
  br i1 %1645, label %1688, label %1638

1646:                                             ; preds = %1638
  %1647 = icmp slt i64 %1626, 0
  %1648 = select i1 %1647, i64 %223, i64 0
  %1649 = add i64 %1626, %1648
  %1650 = mul i64 %1649, %225
  %1651 = getelementptr i64, ptr %226, i64 %1650
  %1652 = select i1 %1622, i64 %161, i64 0
  %1653 = getelementptr double, ptr %162, i64 %1618
  %1654 = getelementptr double, ptr %1653, i64 %1652
  %1655 = load double, ptr %1654, align 8, !noalias !163
  %1656 = select i1 %1622, i64 %166, i64 0
  %1657 = getelementptr double, ptr %167, i64 %1618
  %1658 = getelementptr double, ptr %1657, i64 %1656
  %1659 = load double, ptr %1658, align 8, !noalias !163
  %1660 = fptosi double %1655 to i64
  store i64 %1660, ptr %1651, align 8, !noalias !163
  %1661 = getelementptr i8, ptr %1651, i64 8
  %1662 = fptosi double %1659 to i64
  store i64 %1662, ptr %1661, align 8, !noalias !163
  %1663 = select i1 %1622, i64 %171, i64 0
  %1664 = getelementptr double, ptr %172, i64 %1618
  %1665 = getelementptr double, ptr %1664, i64 %1663
  %1666 = load double, ptr %1665, align 8, !noalias !163
  %1667 = getelementptr i8, ptr %1651, i64 16
  %1668 = fptosi double %1666 to i64
  store i64 %1668, ptr %1667, align 8, !noalias !163
  %1669 = getelementptr i8, ptr %1651, i64 24
  store i64 3, ptr %1669, align 8, !noalias !163
  %1670 = select i1 %1622, i64 %135, i64 0
  %1671 = getelementptr double, ptr %136, i64 %1618
  %1672 = getelementptr double, ptr %1671, i64 %1670
  %1673 = load double, ptr %1672, align 8, !noalias !163
  %1674 = select i1 %1647, i64 %230, i64 0
  %1675 = getelementptr double, ptr %231, i64 %1626
  %1676 = getelementptr double, ptr %1675, i64 %1674
  store double %1673, ptr %1676, align 8, !noalias !163
  store i64 -1, ptr %1625, align 8, !noalias !163
  br label %1692

1677:                                             ; preds = %1638
  %1678 = add nsw i64 %1640, -1
  %1679 = add i64 %1639, 1
  %1680 = shl nsw i64 %1639, 3
  %1681 = select i1 %1622, i64 %186, i64 0
  %1682 = getelementptr i64, ptr %187, i64 %1618
  %1683 = getelementptr i64, ptr %1682, i64 %1681
  %1684 = load i64, ptr %1683, align 8, !noalias !163
  %1685 = add nsw i64 %1684, %1680
  %1686 = load i64, ptr %232, align 8, !noalias !163
  %1687 = call i64 @llvm.smax.i64(i64 %1686, i64 0)
  br label %1642

1688:                                             ; preds = %1642
  %1689 = add nsw i64 %1643, -1
  %1690 = inttoptr i64 %1644 to ptr
  store atomic i64 9221120237041090560, ptr %1690 unordered, align 8, !noalias !163
  %1691 = add nsw i64 %1644, %1629
  br label %1642

1692:                                             ; preds = %1646, %2228
  br label %1617

1693:                                             ; preds = %1617
  %1694 = xor i64 %2219, -1
  %1695 = and i64 %1010, %1694
  %1696 = trunc i64 %1695 to i8
  %1697 = bitcast i8 %1696 to <8 x i1>
  %1698 = and <8 x i1> %1446, %1697
  %1699 = and <8 x i1> %1457, %1697
  br label %1700

1700:                                             ; preds = %2217, %1693
  %1701 = phi i64 [ %1695, %1693 ], [ %1010, %2217 ]
  %1702 = phi i1 [ true, %1693 ], [ %1011, %2217 ]
  %1703 = phi <8 x i1> [ %1698, %1693 ], [ %1446, %2217 ]
  %1704 = phi <8 x i1> [ %1699, %1693 ], [ %1457, %2217 ]
  %1705 = bitcast <8 x i1> %1704 to i8
  %1706 = zext i8 %1705 to i64
  %1707 = load <8 x double>, ptr %136, align 8, !noalias !167
  %1708 = load <8 x double>, ptr %101, align 8, !noalias !167
  %1709 = icmp eq i8 %1705, 0
  br i1 %1709, label %1801, label %1710

1710:                                             ; preds = %1700, %1738
  %1711 = phi i64 [ %1787, %1738 ], [ %1706, %1700 ]
  %1712 = load <8 x double>, ptr %157, align 8, !noalias !167
  %1713 = fsub <8 x double> %1712, %1707
  %1714 = fdiv <8 x double> %1713, %1708
  store <8 x double> %1714, ptr %104, align 8, !noalias !167
  %1715 = load i64, ptr %1489, align 8, !noalias !167
  %1716 = load i64, ptr %232, align 8, !noalias !167
  call fastcc void @pydy_nested(i64 %95, i64 %85, i64 %118, i64 %87, i64 %1715, i64 %103, i64 %1716) #3, !noalias !167
  %1717 = getelementptr i8, ptr %190, i64 32
  %1718 = load i64, ptr %1717, align 8, !noalias !171
  %1719 = shl nsw i64 %1718, 3
  %1720 = load i64, ptr %232, align 8, !noalias !171
  %1721 = icmp eq i64 %1711, 0
  br i1 %1721, label %1738, label %1722

1722:                                             ; preds = %1710, %1736
  %1723 = phi i64 [ %1726, %1736 ], [ %1711, %1710 ]
  %1724 = call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %1723, i1 true)
  %1725 = add nsw i64 %1723, -1
  %1726 = and i64 %1723, %1725
  %1727 = getelementptr i64, ptr %187, i64 %1724
  %1728 = load i64, ptr %1727, align 8, !noalias !171
  %1729 = add nsw i64 %1728, 8
  store i64 %1729, ptr %1727, align 8, !noalias !171
  %1730 = call i64 @llvm.smax.i64(i64 %1720, i64 0)
  br label %1731

1731:                                             ; preds = %1722, %1789
  %1732 = phi i64 [ 0, %1722 ], [ %1791, %1789 ]
  %1733 = phi i64 [ %1730, %1722 ], [ %1790, %1789 ]
  %1734 = phi i64 [ %1728, %1722 ], [ %1800, %1789 ]
  %1735 = icmp sgt i64 %1733, 0
  br i1 %1735, label %1789, label %1736

1736:                                             ; preds = %1731
  %1737 = icmp eq i64 %1726, 0
  br i1 %1737, label %1738, label %1722

1738:                                             ; preds = %1736, %1710
  %1739 = load <8 x double>, ptr %152, align 8, !noalias !171
  %1740 = trunc i64 %1711 to i8
  %1741 = bitcast i8 %1740 to <8 x i1>
  %1742 = select <8 x i1> %1741, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %1743 = fadd <8 x double> %1739, %1742
  store <8 x double> %1743, ptr %152, align 8, !noalias !171
  %1744 = extractelement <8 x double> %1743, i64 0
  %1745 = fptosi double %1744 to i64
  %1746 = getelementptr double, ptr %198, i64 %1745
  %1747 = load double, ptr %1746, align 8, !noalias !171
  %1748 = insertelement <8 x double> poison, double %1747, i64 0
  %1749 = extractelement <8 x double> %1743, i64 1
  %1750 = fptosi double %1749 to i64
  %1751 = getelementptr double, ptr %198, i64 %1750
  %1752 = load double, ptr %1751, align 8, !noalias !171
  %1753 = insertelement <8 x double> %1748, double %1752, i64 1
  %1754 = extractelement <8 x double> %1743, i64 2
  %1755 = fptosi double %1754 to i64
  %1756 = getelementptr double, ptr %198, i64 %1755
  %1757 = load double, ptr %1756, align 8, !noalias !171
  %1758 = insertelement <8 x double> %1753, double %1757, i64 2
  %1759 = extractelement <8 x double> %1743, i64 3
  %1760 = fptosi double %1759 to i64
  %1761 = getelementptr double, ptr %198, i64 %1760
  %1762 = load double, ptr %1761, align 8, !noalias !171
  %1763 = insertelement <8 x double> %1758, double %1762, i64 3
  %1764 = extractelement <8 x double> %1743, i64 4
  %1765 = fptosi double %1764 to i64
  %1766 = getelementptr double, ptr %198, i64 %1765
  %1767 = load double, ptr %1766, align 8, !noalias !171
  %1768 = insertelement <8 x double> %1763, double %1767, i64 4
  %1769 = extractelement <8 x double> %1743, i64 5
  %1770 = fptosi double %1769 to i64
  %1771 = getelementptr double, ptr %198, i64 %1770
  %1772 = load double, ptr %1771, align 8, !noalias !171
  %1773 = insertelement <8 x double> %1768, double %1772, i64 5
  %1774 = extractelement <8 x double> %1743, i64 6
  %1775 = fptosi double %1774 to i64
  %1776 = getelementptr double, ptr %198, i64 %1775
  %1777 = load double, ptr %1776, align 8, !noalias !171
  %1778 = insertelement <8 x double> %1773, double %1777, i64 6
  %1779 = extractelement <8 x double> %1743, i64 7
  %1780 = fptosi double %1779 to i64
  %1781 = getelementptr double, ptr %198, i64 %1780
  %1782 = load double, ptr %1781, align 8, !noalias !171
  %1783 = insertelement <8 x double> %1778, double %1782, i64 7
  store <8 x double> %1783, ptr %157, align 8, !noalias !171
  %1784 = fcmp olt <8 x double> %1783, %1045
  %1785 = bitcast <8 x i1> %1784 to i8
  %1786 = zext i8 %1785 to i64
  %1787 = and i64 %1711, %1786
  %1788 = icmp eq i64 %1787, 0
  br i1 %1788, label %1801, label %1710

1789:                                             ; preds = %1731
  %1790 = add nsw i64 %1733, -1
  %1791 = add i64 %1732, 1
  %1792 = shl nsw i64 %1732, 3
  %1793 = add nsw i64 %1792, %1724
  %1794 = icmp slt i64 %1793, 0
  %1795 = select i1 %1794, i64 %97, i64 0
  %1796 = getelementptr double, ptr %98, i64 %1793
  %1797 = getelementptr double, ptr %1796, i64 %1795
  %1798 = load i64, ptr %1797, align 8, !noalias !171
  %1799 = inttoptr i64 %1734 to ptr
  store atomic i64 %1798, ptr %1799 unordered, align 8, !noalias !171
  %1800 = add nsw i64 %1734, %1719
  br label %1731

1801:                                             ; preds = %1738, %1700, %1444
  %1802 = phi i64 [ %1010, %1444 ], [ %1701, %1700 ], [ %1701, %1738 ]
  %1803 = phi i1 [ %1011, %1444 ], [ %1702, %1700 ], [ %1702, %1738 ]
  %1804 = phi <8 x i1> [ %1446, %1444 ], [ %1703, %1700 ], [ %1703, %1738 ]
  %1805 = load <8 x double>, ptr %157, align 8, !noalias !12
  %1806 = fcmp oeq <8 x double> %1805, %1045
  %1807 = and <8 x i1> %1804, %1806
  %1808 = bitcast <8 x i1> %1807 to i8
  %1809 = zext i8 %1808 to i64
  %1810 = icmp eq i8 %1808, 0
  br i1 %1810, label %1897, label %1811

1811:                                             ; preds = %1801, %1834
  %1812 = phi i64 [ %1883, %1834 ], [ %1809, %1801 ]
  %1813 = getelementptr i8, ptr %190, i64 32
  %1814 = load i64, ptr %1813, align 8, !noalias !175
  %1815 = shl nsw i64 %1814, 3
  %1816 = load i64, ptr %232, align 8, !noalias !175
  %1817 = icmp eq i64 %1812, 0
  br i1 %1817, label %1834, label %1818

1818:                                             ; preds = %1811, %1832
  %1819 = phi i64 [ %1822, %1832 ], [ %1812, %1811 ]
  %1820 = call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %1819, i1 true)
  %1821 = add nsw i64 %1819, -1
  %1822 = and i64 %1819, %1821
  %1823 = getelementptr i64, ptr %187, i64 %1820
  %1824 = load i64, ptr %1823, align 8, !noalias !175
  %1825 = add nsw i64 %1824, 8
  store i64 %1825, ptr %1823, align 8, !noalias !175
  %1826 = call i64 @llvm.smax.i64(i64 %1816, i64 0)
  br label %1827

1827:                                             ; preds = %1818, %1885
  %1828 = phi i64 [ 0, %1818 ], [ %1887, %1885 ]
  %1829 = phi i64 [ %1826, %1818 ], [ %1886, %1885 ]
  %1830 = phi i64 [ %1824, %1818 ], [ %1896, %1885 ]
  %1831 = icmp sgt i64 %1829, 0
  br i1 %1831, label %1885, label %1832

1832:                                             ; preds = %1827
  %1833 = icmp eq i64 %1822, 0
  br i1 %1833, label %1834, label %1818

1834:                                             ; preds = %1832, %1811
  %1835 = load <8 x double>, ptr %152, align 8, !noalias !175
  %1836 = trunc i64 %1812 to i8
  %1837 = bitcast i8 %1836 to <8 x i1>
  %1838 = select <8 x i1> %1837, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %1839 = fadd <8 x double> %1835, %1838
  store <8 x double> %1839, ptr %152, align 8, !noalias !175
  %1840 = extractelement <8 x double> %1839, i64 0
  %1841 = fptosi double %1840 to i64
  %1842 = getelementptr double, ptr %198, i64 %1841
  %1843 = load double, ptr %1842, align 8, !noalias !175
  %1844 = insertelement <8 x double> poison, double %1843, i64 0
  %1845 = extractelement <8 x double> %1839, i64 1
  %1846 = fptosi double %1845 to i64
  %1847 = getelementptr double, ptr %198, i64 %1846
  %1848 = load double, ptr %1847, align 8, !noalias !175
  %1849 = insertelement <8 x double> %1844, double %1848, i64 1
  %1850 = extractelement <8 x double> %1839, i64 2
  %1851 = fptosi double %1850 to i64
  %1852 = getelementptr double, ptr %198, i64 %1851
  %1853 = load double, ptr %1852, align 8, !noalias !175
  %1854 = insertelement <8 x double> %1849, double %1853, i64 2
  %1855 = extractelement <8 x double> %1839, i64 3
  %1856 = fptosi double %1855 to i64
  %1857 = getelementptr double, ptr %198, i64 %1856
  %1858 = load double, ptr %1857, align 8, !noalias !175
  %1859 = insertelement <8 x double> %1854, double %1858, i64 3
  %1860 = extractelement <8 x double> %1839, i64 4
  %1861 = fptosi double %1860 to i64
  %1862 = getelementptr double, ptr %198, i64 %1861
  %1863 = load double, ptr %1862, align 8, !noalias !175
  %1864 = insertelement <8 x double> %1859, double %1863, i64 4
  %1865 = extractelement <8 x double> %1839, i64 5
  %1866 = fptosi double %1865 to i64
  %1867 = getelementptr double, ptr %198, i64 %1866
  %1868 = load double, ptr %1867, align 8, !noalias !175
  %1869 = insertelement <8 x double> %1864, double %1868, i64 5
  %1870 = extractelement <8 x double> %1839, i64 6
  %1871 = fptosi double %1870 to i64
  %1872 = getelementptr double, ptr %198, i64 %1871
  %1873 = load double, ptr %1872, align 8, !noalias !175
  %1874 = insertelement <8 x double> %1869, double %1873, i64 6
  %1875 = extractelement <8 x double> %1839, i64 7
  %1876 = fptosi double %1875 to i64
  %1877 = getelementptr double, ptr %198, i64 %1876
  %1878 = load double, ptr %1877, align 8, !noalias !175
  %1879 = insertelement <8 x double> %1874, double %1878, i64 7
  store <8 x double> %1879, ptr %157, align 8, !noalias !175
  %1880 = fcmp oeq <8 x double> %1879, %1045
  %1881 = bitcast <8 x i1> %1880 to i8
  %1882 = zext i8 %1881 to i64
  %1883 = and i64 %1812, %1882
  %1884 = icmp eq i64 %1883, 0
  br i1 %1884, label %1897, label %1811

1885:                                             ; preds = %1827
  %1886 = add nsw i64 %1829, -1
  %1887 = add i64 %1828, 1
  %1888 = shl nsw i64 %1828, 3
  %1889 = add nsw i64 %1888, %1820
  %1890 = icmp slt i64 %1889, 0
  %1891 = select i1 %1890, i64 %92, i64 0
  %1892 = getelementptr double, ptr %93, i64 %1889
  %1893 = getelementptr double, ptr %1892, i64 %1891
  %1894 = load i64, ptr %1893, align 8, !noalias !175
  %1895 = inttoptr i64 %1830 to ptr
  store atomic i64 %1894, ptr %1895 unordered, align 8, !noalias !175
  %1896 = add nsw i64 %1830, %1815
  br label %1827

1897:                                             ; preds = %1834, %1801
  %1898 = xor <8 x i1> %1804, splat (i1 true)
  %1899 = and <8 x i1> %1021, %1898
  %1900 = load <8 x double>, ptr %162, align 8, !noalias !12
  %1901 = select <8 x i1> %1804, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %1902 = fadd <8 x double> %1900, %1901
  store <8 x double> %1902, ptr %162, align 8, !noalias !12
  br i1 %248, label %1903, label %2020

1903:                                             ; preds = %1897
  %1904 = load <8 x double>, ptr %144, align 8, !noalias !12
  %1905 = load <8 x double>, ptr %147, align 8, !noalias !12
  %1906 = getelementptr i8, ptr %36, i64 24
  %1907 = load double, ptr %1906, align 8, !noalias !179
  %1908 = fcmp ogt <8 x double> %1419, splat (double 1.000000e-10)
  %1909 = select <8 x i1> %1908, <8 x double> %1419, <8 x double> splat (double 1.000000e-10)
  %1910 = getelementptr i8, ptr %36, i64 8
  %1911 = load double, ptr %1910, align 8, !noalias !179
  %1912 = fneg double %1911
  %1913 = insertelement <8 x double> poison, double %1912, i64 0
  %1914 = shufflevector <8 x double> %1913, <8 x double> poison, <8 x i32> zeroinitializer
  %1915 = bitcast <8 x double> %1909 to <8 x i64>
  %1916 = add nsw <8 x i64> %1915, splat (i64 -4604544271217802189)
  %1917 = ashr <8 x i64> %1916, splat (i64 52)
  %1918 = and <8 x i64> %1916, splat (i64 -4503599627370496)
  %1919 = sub <8 x i64> %1915, %1918
  %1920 = bitcast <8 x i64> %1919 to <8 x double>
  %1921 = fadd <8 x double> %1920, splat (double -1.000000e+00)
  %1922 = fadd <8 x double> %1920, splat (double 1.000000e+00)
  %1923 = fdiv <8 x double> %1921, %1922
  %1924 = fmul <8 x double> %1923, %1923
  %1925 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1924, <8 x double> splat (double 0x3FD484B13D7C02A9), <8 x double> splat (double 0x3FDA61762A7ADED9))
  %1926 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1925, <8 x double> %1924, <8 x double> splat (double 0x3FE2776C50EF9BFE))
  %1927 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1926, <8 x double> %1924, <8 x double> splat (double 0x3FEEC709DC3A03FD))
  %1928 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1927, <8 x double> %1924, <8 x double> splat (double 0x40071547652B82FE))
  %1929 = fmul <8 x double> %1928, %1923
  %1930 = trunc nsw <8 x i64> %1917 to <8 x i32>
  %1931 = sitofp <8 x i32> %1930 to <8 x double>
  %1932 = fadd <8 x double> %1929, %1931
  %1933 = fmul <8 x double> %1932, %1914
  %1934 = fcmp ogt <8 x double> %1933, splat (double -1.000000e+03)
  %1935 = select <8 x i1> %1934, <8 x double> %1933, <8 x double> splat (double -1.000000e+03)
  %1936 = fcmp olt <8 x double> %1935, splat (double 1.000000e+03)
  %1937 = select <8 x i1> %1936, <8 x double> %1935, <8 x double> splat (double 1.000000e+03)
  %1938 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1937)
  %1939 = fsub <8 x double> %1937, %1938
  %1940 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1939, <8 x double> splat (double 0x3EEFFCBFC588B0C5), <8 x double> splat (double 0x3F2430912F86C786))
  %1941 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1940, <8 x double> %1939, <8 x double> splat (double 0x3F55D87FE78A6730))
  %1942 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1941, <8 x double> %1939, <8 x double> splat (double 0x3F83B2AB6FBA4E77))
  %1943 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1942, <8 x double> %1939, <8 x double> splat (double 0x3FAC6B08D704A0BF))
  %1944 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1943, <8 x double> %1939, <8 x double> splat (double 0x3FCEBFBDFF82C58E))
  %1945 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1944, <8 x double> %1939, <8 x double> splat (double 0x3FE62E42FEFA39EF))
  %1946 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1945, <8 x double> %1939, <8 x double> splat (double 1.000000e+00))
  %1947 = fptosi <8 x double> %1938 to <8 x i32>
  %1948 = zext <8 x i32> %1947 to <8 x i64>
  %1949 = shl <8 x i64> %1948, splat (i64 52)
  %1950 = bitcast <8 x double> %1946 to <8 x i64>
  %1951 = add <8 x i64> %1949, %1950
  %1952 = bitcast <8 x i64> %1951 to <8 x double>
  %1953 = insertelement <8 x double> poison, double %1907, i64 0
  %1954 = shufflevector <8 x double> %1953, <8 x double> poison, <8 x i32> zeroinitializer
  %1955 = fmul <8 x double> %1954, %1952
  %1956 = getelementptr i8, ptr %36, i64 16
  %1957 = load double, ptr %1956, align 8, !noalias !179
  %1958 = fcmp une double %1957, 0.000000e+00
  br i1 %1958, label %1959, label %2001

1959:                                             ; preds = %1903
  %1960 = insertelement <8 x double> poison, double %1957, i64 0
  %1961 = shufflevector <8 x double> %1960, <8 x double> poison, <8 x i32> zeroinitializer
  %1962 = bitcast <8 x double> %1904 to <8 x i64>
  %1963 = add <8 x i64> %1962, splat (i64 -4604544271217802189)
  %1964 = ashr <8 x i64> %1963, splat (i64 52)
  %1965 = and <8 x i64> %1963, splat (i64 -4503599627370496)
  %1966 = sub <8 x i64> %1962, %1965
  %1967 = bitcast <8 x i64> %1966 to <8 x double>
  %1968 = fadd <8 x double> %1967, splat (double -1.000000e+00)
  %1969 = fadd <8 x double> %1967, splat (double 1.000000e+00)
  %1970 = fdiv <8 x double> %1968, %1969
  %1971 = fmul <8 x double> %1970, %1970
  %1972 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1971, <8 x double> splat (double 0x3FD484B13D7C02A9), <8 x double> splat (double 0x3FDA61762A7ADED9))
  %1973 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1972, <8 x double> %1971, <8 x double> splat (double 0x3FE2776C50EF9BFE))
  %1974 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1973, <8 x double> %1971, <8 x double> splat (double 0x3FEEC709DC3A03FD))
  %1975 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1974, <8 x double> %1971, <8 x double> splat (double 0x40071547652B82FE))
  %1976 = fmul <8 x double> %1975, %1970
  %1977 = trunc nsw <8 x i64> %1964 to <8 x i32>
  %1978 = sitofp <8 x i32> %1977 to <8 x double>
  %1979 = fadd <8 x double> %1976, %1978
  %1980 = fmul <8 x double> %1979, %1961
  %1981 = fcmp ogt <8 x double> %1980, splat (double -1.000000e+03)
  %1982 = select <8 x i1> %1981, <8 x double> %1980, <8 x double> splat (double -1.000000e+03)
  %1983 = fcmp olt <8 x double> %1982, splat (double 1.000000e+03)
  %1984 = select <8 x i1> %1983, <8 x double> %1982, <8 x double> splat (double 1.000000e+03)
  %1985 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1984)
  %1986 = fsub <8 x double> %1984, %1985
  %1987 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1986, <8 x double> splat (double 0x3EEFFCBFC588B0C5), <8 x double> splat (double 0x3F2430912F86C786))
  %1988 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1987, <8 x double> %1986, <8 x double> splat (double 0x3F55D87FE78A6730))
  %1989 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1988, <8 x double> %1986, <8 x double> splat (double 0x3F83B2AB6FBA4E77))
  %1990 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1989, <8 x double> %1986, <8 x double> splat (double 0x3FAC6B08D704A0BF))
  %1991 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1990, <8 x double> %1986, <8 x double> splat (double 0x3FCEBFBDFF82C58E))
  %1992 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1991, <8 x double> %1986, <8 x double> splat (double 0x3FE62E42FEFA39EF))
  %1993 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1992, <8 x double> %1986, <8 x double> splat (double 1.000000e+00))
  %1994 = fptosi <8 x double> %1985 to <8 x i32>
  %1995 = zext <8 x i32> %1994 to <8 x i64>
  %1996 = shl <8 x i64> %1995, splat (i64 52)
  %1997 = bitcast <8 x double> %1993 to <8 x i64>
  %1998 = add <8 x i64> %1996, %1997
  %1999 = bitcast <8 x i64> %1998 to <8 x double>
  %2000 = fmul <8 x double> %1955, %1999
  br label %2001

2001:                                             ; preds = %1959, %1903
  %2002 = phi <8 x double> [ %2000, %1959 ], [ %1955, %1903 ]
  %2003 = getelementptr i8, ptr %36, i64 32
  %2004 = load double, ptr %2003, align 8, !noalias !179
  %2005 = insertelement <8 x double> poison, double %2004, i64 0
  %2006 = shufflevector <8 x double> %2005, <8 x double> poison, <8 x i32> zeroinitializer
  %2007 = fcmp ogt <8 x double> %2002, %2006
  %2008 = select <8 x i1> %2007, <8 x double> %2002, <8 x double> %2006
  %2009 = fcmp olt <8 x double> %1905, %2008
  %2010 = select <8 x i1> %2009, <8 x double> %1905, <8 x double> %2008
  %2011 = fmul <8 x double> %1046, %2010
  %2012 = fcmp ogt <8 x double> %1419, splat (double 1.000000e-04)
  %2013 = select <8 x i1> %2012, <8 x double> %1419, <8 x double> splat (double 1.000000e-04)
  %2014 = select <8 x i1> %1804, <8 x double> %2013, <8 x double> %1904
  store <8 x double> %2014, ptr %144, align 8, !noalias !12
  %2015 = getelementptr i8, ptr %36, i64 40
  %2016 = load double, ptr %2015, align 8, !noalias !12
  %2017 = insertelement <8 x double> poison, double %2016, i64 0
  %2018 = shufflevector <8 x double> %2017, <8 x double> poison, <8 x i32> zeroinitializer
  %2019 = select <8 x i1> %1899, <8 x double> splat (double 1.000000e+00), <8 x double> %2018
  store <8 x double> %2019, ptr %147, align 8, !noalias !12
  br label %2020

2020:                                             ; preds = %2001, %1897
  %2021 = phi <8 x double> [ %2011, %2001 ], [ %1019, %1897 ]
  %2022 = bitcast <8 x i1> %1899 to i8
  %2023 = icmp eq i8 %2022, 0
  br i1 %2023, label %2096, label %2024

2024:                                             ; preds = %2020
  %2025 = trunc i64 %1445 to i8
  %2026 = bitcast i8 %2025 to <8 x i1>
  %2027 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1419)
  %2028 = fcmp ueq <8 x double> %2027, splat (double 0x7FF0000000000000)
  %2029 = or <8 x i1> %2028, %2026
  %2030 = getelementptr i8, ptr %36, i64 24
  %2031 = load double, ptr %2030, align 8, !noalias !182
  %2032 = fcmp ogt <8 x double> %1419, splat (double 1.000000e-10)
  %2033 = select <8 x i1> %2032, <8 x double> %1419, <8 x double> splat (double 1.000000e-10)
  %2034 = load double, ptr %36, align 8, !noalias !182
  %2035 = fneg double %2034
  %2036 = insertelement <8 x double> poison, double %2035, i64 0
  %2037 = shufflevector <8 x double> %2036, <8 x double> poison, <8 x i32> zeroinitializer
  %2038 = bitcast <8 x double> %2033 to <8 x i64>
  %2039 = add nsw <8 x i64> %2038, splat (i64 -4604544271217802189)
  %2040 = ashr <8 x i64> %2039, splat (i64 52)
  %2041 = and <8 x i64> %2039, splat (i64 -4503599627370496)
  %2042 = sub <8 x i64> %2038, %2041
  %2043 = bitcast <8 x i64> %2042 to <8 x double>
  %2044 = fadd <8 x double> %2043, splat (double -1.000000e+00)
  %2045 = fadd <8 x double> %2043, splat (double 1.000000e+00)
  %2046 = fdiv <8 x double> %2044, %2045
  %2047 = fmul <8 x double> %2046, %2046
  %2048 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2047, <8 x double> splat (double 0x3FD484B13D7C02A9), <8 x double> splat (double 0x3FDA61762A7ADED9))
  %2049 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2048, <8 x double> %2047, <8 x double> splat (double 0x3FE2776C50EF9BFE))
  %2050 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2049, <8 x double> %2047, <8 x double> splat (double 0x3FEEC709DC3A03FD))
  %2051 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2050, <8 x double> %2047, <8 x double> splat (double 0x40071547652B82FE))
  %2052 = fmul <8 x double> %2051, %2046
  %2053 = trunc nsw <8 x i64> %2040 to <8 x i32>
  %2054 = sitofp <8 x i32> %2053 to <8 x double>
  %2055 = fadd <8 x double> %2052, %2054
  %2056 = fmul <8 x double> %2055, %2037
  %2057 = fcmp ogt <8 x double> %2056, splat (double -1.000000e+03)
  %2058 = select <8 x i1> %2057, <8 x double> %2056, <8 x double> splat (double -1.000000e+03)
  %2059 = fcmp olt <8 x double> %2058, splat (double 1.000000e+03)
  %2060 = select <8 x i1> %2059, <8 x double> %2058, <8 x double> splat (double 1.000000e+03)
  %2061 = call <8 x double> @llvm.rint.v8f64(<8 x double> %2060)
  %2062 = fsub <8 x double> %2060, %2061
  %2063 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2062, <8 x double> splat (double 0x3EEFFCBFC588B0C5), <8 x double> splat (double 0x3F2430912F86C786))
  %2064 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2063, <8 x double> %2062, <8 x double> splat (double 0x3F55D87FE78A6730))
  %2065 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2064, <8 x double> %2062, <8 x double> splat (double 0x3F83B2AB6FBA4E77))
  %2066 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2065, <8 x double> %2062, <8 x double> splat (double 0x3FAC6B08D704A0BF))
  %2067 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2066, <8 x double> %2062, <8 x double> splat (double 0x3FCEBFBDFF82C58E))
  %2068 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2067, <8 x double> %2062, <8 x double> splat (double 0x3FE62E42FEFA39EF))
  %2069 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2068, <8 x double> %2062, <8 x double> splat (double 1.000000e+00))
  %2070 = fptosi <8 x double> %2061 to <8 x i32>
  %2071 = zext <8 x i32> %2070 to <8 x i64>
  %2072 = shl <8 x i64> %2071, splat (i64 52)
  %2073 = bitcast <8 x double> %2069 to <8 x i64>
  %2074 = add <8 x i64> %2072, %2073
  %2075 = bitcast <8 x i64> %2074 to <8 x double>
  %2076 = insertelement <8 x double> poison, double %2031, i64 0
  %2077 = shufflevector <8 x double> %2076, <8 x double> poison, <8 x i32> zeroinitializer
  %2078 = fmul <8 x double> %2077, %2075
  %2079 = getelementptr i8, ptr %36, i64 32
  %2080 = load double, ptr %2079, align 8, !noalias !182
  %2081 = insertelement <8 x double> poison, double %2080, i64 0
  %2082 = shufflevector <8 x double> %2081, <8 x double> poison, <8 x i32> zeroinitializer
  %2083 = fcmp ogt <8 x double> %2078, %2082
  %2084 = select <8 x i1> %2083, <8 x double> %2078, <8 x double> %2082
  %2085 = select <8 x i1> %2029, <8 x double> splat (double 2.500000e-01), <8 x double> %2084
  %2086 = fmul <8 x double> %1046, %2085
  %2087 = select i1 %248, <8 x double> %2086, <8 x double> zeroinitializer
  %2088 = select <8 x i1> %1899, <8 x double> %2087, <8 x double> %2021
  %2089 = select <8 x i1> %2029, <8 x double> splat (double 4.000000e+00), <8 x double> splat (double 2.000000e+00)
  %2090 = select <8 x i1> %2026, <8 x double> splat (double 3.000000e+00), <8 x double> %2089
  %2091 = load <8 x double>, ptr %177, align 8, !noalias !12
  %2092 = select <8 x i1> %1899, <8 x double> %2090, <8 x double> %2091
  store <8 x double> %2092, ptr %177, align 8, !noalias !12
  %2093 = load <8 x double>, ptr %167, align 8, !noalias !12
  %2094 = select <8 x i1> %1899, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %2095 = fadd <8 x double> %2093, %2094
  store <8 x double> %2095, ptr %167, align 8, !noalias !12
  br label %2096

2096:                                             ; preds = %2024, %2020
  %2097 = phi <8 x double> [ %2088, %2024 ], [ %2021, %2020 ]
  store <8 x double> %2097, ptr %141, align 8, !noalias !12
  %2098 = select <8 x i1> %1804, <8 x double> %1045, <8 x double> %1018
  store <8 x double> %2098, ptr %136, align 8, !noalias !12
  %2099 = call i64 @llvm.smax.i64(i64 %233, i64 0)
  br label %2100

2100:                                             ; preds = %2096, %2234
  %2101 = phi i64 [ 0, %2096 ], [ %2236, %2234 ]
  %2102 = phi i64 [ %2099, %2096 ], [ %2235, %2234 ]
  %2103 = icmp sgt i64 %2102, 0
  br i1 %2103, label %2234, label %2104

2104:                                             ; preds = %2100
  %2105 = load <8 x double>, ptr %157, align 8, !noalias !12
  %2106 = fcmp oeq <8 x double> %2105, splat (double 0x7FF0000000000000)
  %2107 = and <8 x i1> %1804, %2106
  %2108 = bitcast <8 x i1> %2107 to i8
  %2109 = zext i8 %2108 to i64
  %2110 = icmp eq i8 %2108, 0
  br i1 %2110, label %2187, label %2111

2111:                                             ; preds = %2104, %2186
  %2112 = phi i64 [ %2252, %2186 ], [ 0, %2104 ]
  %2113 = phi i64 [ %2251, %2186 ], [ 8, %2104 ]
  %2114 = icmp sgt i64 %2113, 0
  br i1 %2114, label %2250, label %2187

2115:                                             ; preds = %2250
  %2116 = icmp slt i64 %2112, 0
  %2117 = select i1 %2116, i64 %181, i64 0
  %2118 = getelementptr i64, ptr %182, i64 %2112
  %2119 = getelementptr i64, ptr %2118, i64 %2117
  %2120 = load i64, ptr %2119, align 8, !noalias !185
  %2121 = getelementptr i8, ptr %190, i64 32
  %2122 = load i64, ptr %2121, align 8, !noalias !185
  %2123 = shl nsw i64 %2122, 3
  %2124 = select i1 %2116, i64 %151, i64 0
  %2125 = getelementptr double, ptr %152, i64 %2112
  %2126 = getelementptr double, ptr %2125, i64 %2124
  %2127 = load double, ptr %2126, align 8, !noalias !185
  %2128 = fptosi double %2127 to i64
  %2129 = xor i64 %2128, -1
  %2130 = add i64 %197, %2129
  %2131 = call i64 @llvm.smax.i64(i64 %2130, i64 0)
  br label %2132

2132:                                             ; preds = %2136, %2115
  %2133 = phi i64 [ 0, %2115 ], [ %2173, %2136 ]
  %2134 = phi i64 [ %2131, %2115 ], [ %2172, %2136 ]
  %2135 = icmp sgt i64 %2134, 0
  br i1 %2135, label %2171, label %2140

2136:                                             ; preds = %2171, %2182
  %2137 = phi i64 [ %2181, %2171 ], [ %2183, %2182 ]
  %2138 = phi i64 [ %2179, %2171 ], [ %2185, %2182 ]
  %2139 = icmp sgt i64 %2137, 0
  br i1 %2139, label %2182, label %2132

2140:                                             ; preds = %2132
  %2141 = icmp slt i64 %2120, 0
  %2142 = select i1 %2141, i64 %223, i64 0
  %2143 = add i64 %2120, %2142
  %2144 = mul i64 %2143, %225
  %2145 = getelementptr i64, ptr %226, i64 %2144
  %2146 = select i1 %2116, i64 %161, i64 0
  %2147 = getelementptr double, ptr %162, i64 %2112
  %2148 = getelementptr double, ptr %2147, i64 %2146
  %2149 = load double, ptr %2148, align 8, !noalias !185
  %2150 = select i1 %2116, i64 %166, i64 0
  %2151 = getelementptr double, ptr %167, i64 %2112
  %2152 = getelementptr double, ptr %2151, i64 %2150
  %2153 = load double, ptr %2152, align 8, !noalias !185
  %2154 = fptosi double %2149 to i64
  store i64 %2154, ptr %2145, align 8, !noalias !185
  %2155 = getelementptr i8, ptr %2145, i64 8
  %2156 = fptosi double %2153 to i64
  store i64 %2156, ptr %2155, align 8, !noalias !185
  %2157 = select i1 %2116, i64 %171, i64 0
  %2158 = getelementptr double, ptr %172, i64 %2112
  %2159 = getelementptr double, ptr %2158, i64 %2157
  %2160 = load double, ptr %2159, align 8, !noalias !185
  %2161 = getelementptr i8, ptr %2145, i64 16
  %2162 = fptosi double %2160 to i64
  store i64 %2162, ptr %2161, align 8, !noalias !185
  %2163 = getelementptr i8, ptr %2145, i64 24
  store i64 0, ptr %2163, align 8, !noalias !185
  %2164 = select i1 %2116, i64 %135, i64 0
  %2165 = getelementptr double, ptr %136, i64 %2112
  %2166 = getelementptr double, ptr %2165, i64 %2164
  %2167 = load double, ptr %2166, align 8, !noalias !185
  %2168 = select i1 %2141, i64 %230, i64 0
  %2169 = getelementptr double, ptr %231, i64 %2120
  %2170 = getelementptr double, ptr %2169, i64 %2168
  store double %2167, ptr %2170, align 8, !noalias !185
  store i64 -1, ptr %2119, align 8, !noalias !185
  br label %2186

2171:                                             ; preds = %2132
  %2172 = add nsw i64 %2134, -1
  %2173 = add i64 %2133, 1
  %2174 = shl nsw i64 %2133, 3
  %2175 = select i1 %2116, i64 %186, i64 0
  %2176 = getelementptr i64, ptr %187, i64 %2112
  %2177 = getelementptr i64, ptr %2176, i64 %2175
  %2178 = load i64, ptr %2177, align 8, !noalias !185
  %2179 = add nsw i64 %2178, %2174
  %2180 = load i64, ptr %232, align 8, !noalias !185
  %2181 = call i64 @llvm.smax.i64(i64 %2180, i64 0)
  br label %2136

2182:                                             ; preds = %2136
  %2183 = add nsw i64 %2137, -1
  %2184 = inttoptr i64 %2138 to ptr
  store atomic i64 9221120237041090560, ptr %2184 unordered, align 8, !noalias !185
  %2185 = add nsw i64 %2138, %2123
  br label %2136

2186:                                             ; preds = %2140, %2250
  br label %2111

2187:                                             ; preds = %2111, %2104
  %2188 = phi i1 [ %1803, %2104 ], [ true, %2111 ]
  br label %267

2189:                                             ; preds = %260
  %2190 = add nsw i64 %262, -1
  %2191 = add i64 %261, 1
  %2192 = icmp slt i64 %261, 0
  %2193 = select i1 %2192, i64 %181, i64 0
  %2194 = getelementptr i64, ptr %182, i64 %261
  %2195 = getelementptr i64, ptr %2194, i64 %2193
  %2196 = load i64, ptr %2195, align 8, !noalias !12
  %2197 = shl nuw i64 1, %261
  %2198 = icmp slt i64 %2196, 0
  %2199 = select i1 %2198, i64 0, i64 %2197
  %2200 = or i64 %263, %2199
  br label %260

2201:                                             ; preds = %343, %314
  %2202 = icmp eq i64 %275, 0
  br i1 %2202, label %495, label %496

2203:                                             ; preds = %667, %512
  br label %2256

2204:                                             ; preds = %994
  %2205 = add nsw i64 %996, -1
  %2206 = add i64 %995, 1
  br i1 %997, label %1006, label %999

2207:                                             ; preds = %1231
  br label %2256

2208:                                             ; preds = %1413
  %2209 = add nsw i64 %1415, -1
  %2210 = add i64 %1414, 1
  %2211 = shl i64 %1414, 6
  %2212 = getelementptr i8, ptr %93, i64 %2211
  %2213 = load <8 x double>, ptr %2212, align 8, !noalias !12
  %2214 = fmul <8 x double> %2213, zeroinitializer
  %2215 = fadd <8 x double> %1416, %2214
  br label %1413

2216:                                             ; preds = %1431
  br label %2256

2217:                                             ; preds = %1493
  %2218 = zext i8 %1458 to i64
  %2219 = and i64 %1468, %2218
  %2220 = load i64, ptr %1462, align 8, !noalias !12
  %2221 = sitofp i64 %2220 to double
  %2222 = insertelement <8 x double> poison, double %2221, i64 0
  %2223 = shufflevector <8 x double> %2222, <8 x double> poison, <8 x i32> zeroinitializer
  %2224 = select <8 x i1> %1457, <8 x double> %2223, <8 x double> zeroinitializer
  %2225 = load <8 x double>, ptr %172, align 8, !noalias !12
  %2226 = fadd <8 x double> %2225, %2224
  store <8 x double> %2226, ptr %172, align 8, !noalias !12
  %2227 = icmp eq i64 %2219, 0
  br i1 %2227, label %1700, label %1617

2228:                                             ; preds = %1617
  %2229 = add nsw i64 %1619, -1
  %2230 = add i64 %1618, 1
  %2231 = shl nuw i64 1, %1618
  %2232 = and i64 %2219, %2231
  %2233 = icmp eq i64 %2232, 0
  br i1 %2233, label %1692, label %1621

2234:                                             ; preds = %2100
  %2235 = add nsw i64 %2102, -1
  %2236 = add i64 %2101, 1
  %2237 = shl i64 %2101, 6
  %2238 = getelementptr i8, ptr %93, i64 %2237
  %2239 = load <8 x double>, ptr %2238, align 8, !noalias !12
  %2240 = getelementptr i8, ptr %88, i64 %2237
  %2241 = load <8 x double>, ptr %2240, align 8, !noalias !12
  %2242 = select <8 x i1> %1804, <8 x double> %2239, <8 x double> %2241
  store <8 x double> %2242, ptr %2240, align 8, !noalias !12
  %2243 = add nsw i64 %245, %2101
  %2244 = shl i64 %2243, 6
  %2245 = getelementptr i8, ptr %116, i64 %2244
  %2246 = load <8 x double>, ptr %2245, align 8, !noalias !12
  %2247 = getelementptr i8, ptr %116, i64 %2237
  %2248 = load <8 x double>, ptr %2247, align 8, !noalias !12
  %2249 = select <8 x i1> %1804, <8 x double> %2246, <8 x double> %2248
  store <8 x double> %2249, ptr %2247, align 8, !noalias !12
  br label %2100

2250:                                             ; preds = %2111
  %2251 = add nsw i64 %2113, -1
  %2252 = add i64 %2112, 1
  %2253 = shl nuw i64 1, %2112
  %2254 = and i64 %2253, %2109
  %2255 = icmp eq i64 %2254, 0
  br i1 %2255, label %2186, label %2115

2256:                                             ; preds = %1616, %2216, %2207, %1228, %2203, %1015, %495
  %2257 = phi i64 [ 0, %1616 ], [ 0, %2203 ], [ 1, %495 ], [ 0, %1015 ], [ 0, %2216 ], [ 0, %1228 ], [ 0, %2207 ]
  ret i64 %2257
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
!97 = !{!98, !100, !94, !96, !13, !15}
!98 = distinct !{!98, !99}
!99 = distinct !{!99}
!100 = distinct !{!100, !99}
!101 = !{!102, !98, !100, !94, !96, !13, !15}
!102 = distinct !{!102, !103}
!103 = distinct !{!103}
!104 = !{!105, !107, !94, !96, !13, !15}
!105 = distinct !{!105, !106}
!106 = distinct !{!106}
!107 = distinct !{!107, !106}
!108 = !{!109, !105, !107, !94, !96, !13, !15}
!109 = distinct !{!109, !110}
!110 = distinct !{!110}
!111 = !{!112, !114, !94, !96, !13, !15}
!112 = distinct !{!112, !113}
!113 = distinct !{!113}
!114 = distinct !{!114, !113}
!115 = !{!116, !118, !13, !15}
!116 = distinct !{!116, !117}
!117 = distinct !{!117}
!118 = distinct !{!118, !117}
!119 = !{!120, !122, !13, !15}
!120 = distinct !{!120, !121}
!121 = distinct !{!121}
!122 = distinct !{!122, !121}
!123 = !{!124, !126, !120, !122, !13, !15}
!124 = distinct !{!124, !125}
!125 = distinct !{!125}
!126 = distinct !{!126, !125}
!127 = !{!128, !120, !122, !13, !15}
!128 = distinct !{!128, !129}
!129 = distinct !{!129}
!130 = !{!131, !120, !122, !13, !15}
!131 = distinct !{!131, !132}
!132 = distinct !{!132}
!133 = !{!134, !136, !13, !15}
!134 = distinct !{!134, !135}
!135 = distinct !{!135}
!136 = distinct !{!136, !135}
!137 = !{!138, !140, !13, !15}
!138 = distinct !{!138, !139}
!139 = distinct !{!139}
!140 = distinct !{!140, !139}
!141 = !{!142, !144, !138, !140, !13, !15}
!142 = distinct !{!142, !143}
!143 = distinct !{!143}
!144 = distinct !{!144, !143}
!145 = !{!146, !148, !142, !144, !138, !140, !13, !15}
!146 = distinct !{!146, !147}
!147 = distinct !{!147}
!148 = distinct !{!148, !147}
!149 = !{!150, !146, !148, !142, !144, !138, !140, !13, !15}
!150 = distinct !{!150, !151}
!151 = distinct !{!151}
!152 = !{!153, !155, !138, !140, !13, !15}
!153 = distinct !{!153, !154}
!154 = distinct !{!154}
!155 = distinct !{!155, !154}
!156 = !{!157, !153, !155, !138, !140, !13, !15}
!157 = distinct !{!157, !158}
!158 = distinct !{!158}
!159 = !{!160, !162, !138, !140, !13, !15}
!160 = distinct !{!160, !161}
!161 = distinct !{!161}
!162 = distinct !{!162, !161}
!163 = !{!164, !166, !13, !15}
!164 = distinct !{!164, !165}
!165 = distinct !{!165}
!166 = distinct !{!166, !165}
!167 = !{!168, !170, !13, !15}
!168 = distinct !{!168, !169}
!169 = distinct !{!169}
!170 = distinct !{!170, !169}
!171 = !{!172, !174, !168, !170, !13, !15}
!172 = distinct !{!172, !173}
!173 = distinct !{!173}
!174 = distinct !{!174, !173}
!175 = !{!176, !178, !13, !15}
!176 = distinct !{!176, !177}
!177 = distinct !{!177}
!178 = distinct !{!178, !177}
!179 = !{!180, !13, !15}
!180 = distinct !{!180, !181}
!181 = distinct !{!181}
!182 = !{!183, !13, !15}
!183 = distinct !{!183, !184}
!184 = distinct !{!184}
!185 = !{!186, !188, !13, !15}
!186 = distinct !{!186, !187}
!187 = distinct !{!187}
!188 = distinct !{!188, !187}
