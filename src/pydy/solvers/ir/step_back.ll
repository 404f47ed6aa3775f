; sources 761a89190f7436ca4aa3c4bfe0f3c0a461342ea56eb0f274c85fd4f1e4097793
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

define internal fastcc void @pydy_combine(i64 %0, i64 %1, i64 %2, i64 %3, i64 %4, i64 %5, i64 %6, i64 %7, i64 %8) unnamed_addr #0 {
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

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #1

define internal fastcc i32 @_sample(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, i64 %5, ptr %6, i64 %7, ptr %8, i64 %9, i64 %10, double %11) unnamed_addr #0 {
  %13 = call i64 @llvm.smax.i64(i64 %4, i64 0)
  br label %14

14:                                               ; preds = %93, %12
  %15 = phi i64 [ 0, %12 ], [ %120, %93 ]
  %16 = phi i64 [ %13, %12 ], [ %121, %93 ]
  %17 = icmp sgt i64 %16, 0
  br i1 %17, label %19, label %18

18:                                               ; preds = %14
  store ptr null, ptr %0, align 8
  ret i32 0

19:                                               ; preds = %14
  %20 = icmp slt i64 %15, 0
  %21 = select i1 %20, i64 %4, i64 0
  %22 = add i64 %15, %21
  %23 = mul i64 %22, %5
  %24 = getelementptr i64, ptr %3, i64 %23
  %25 = getelementptr i8, ptr %24, i64 24
  %26 = load i64, ptr %25, align 8
  %27 = getelementptr i8, ptr %24, i64 8
  %28 = load i64, ptr %27, align 8, !noalias !0
  %29 = getelementptr i8, ptr %24, i64 16
  %30 = load i64, ptr %29, align 8, !noalias !0
  %31 = add nsw i64 %28, %30
  %32 = icmp slt i64 %28, 0
  %33 = select i1 %32, i64 %7, i64 0
  %34 = add i64 %28, %33
  %35 = icmp slt i64 %34, 0
  br i1 %35, label %50, label %51, !prof !4

36:                                               ; preds = %65, %62
  %37 = phi i64 [ %7, %65 ], [ %63, %62 ]
  %38 = sub i64 %37, %56
  %39 = call i64 @llvm.smax.i64(i64 %38, i64 0)
  %40 = getelementptr double, ptr %6, i64 %56
  %41 = load double, ptr %40, align 8, !noalias !0
  %42 = fcmp ogt double %41, %11
  %43 = select i1 %42, double %41, double %11
  %44 = icmp slt i64 %26, 0
  %45 = select i1 %44, i64 %39, i64 0
  %46 = getelementptr double, ptr %40, i64 %26
  %47 = getelementptr double, ptr %46, i64 %45
  %48 = load double, ptr %47, align 8, !noalias !5
  %49 = fcmp ugt double %48, %43
  br i1 %49, label %76, label %66

50:                                               ; preds = %19
  br label %51

51:                                               ; preds = %50, %19
  %52 = phi i64 [ 0, %50 ], [ %34, %19 ]
  %53 = icmp slt i64 %34, %7
  br i1 %53, label %55, label %54, !prof !8

54:                                               ; preds = %51
  br label %55

55:                                               ; preds = %54, %51
  %56 = phi i64 [ %7, %54 ], [ %52, %51 ]
  %57 = icmp slt i64 %31, 0
  %58 = select i1 %57, i64 %7, i64 0
  %59 = add i64 %31, %58
  %60 = icmp slt i64 %59, 0
  br i1 %60, label %61, label %62, !prof !4

61:                                               ; preds = %55
  br label %62

62:                                               ; preds = %61, %55
  %63 = phi i64 [ 0, %61 ], [ %59, %55 ]
  %64 = icmp slt i64 %59, %7
  br i1 %64, label %36, label %65, !prof !8

65:                                               ; preds = %62
  br label %36

66:                                               ; preds = %36
  %67 = add nsw i64 %39, -1
  %68 = icmp eq i64 %26, %67
  br i1 %68, label %93, label %69

69:                                               ; preds = %66
  %70 = icmp slt i64 %26, -1
  %71 = select i1 %70, i64 %39, i64 0
  %72 = getelementptr i8, ptr %46, i64 8
  %73 = getelementptr double, ptr %72, i64 %71
  %74 = load double, ptr %73, align 8, !noalias !5
  %75 = fcmp olt double %43, %74
  br i1 %75, label %93, label %76

76:                                               ; preds = %69, %36
  %77 = icmp sgt i64 %38, 1
  br i1 %77, label %78, label %93

78:                                               ; preds = %78, %76
  %79 = phi i64 [ %89, %78 ], [ %39, %76 ]
  %80 = phi i64 [ %90, %78 ], [ 0, %76 ]
  %81 = add nsw i64 %80, %79
  %82 = ashr i64 %81, 1
  %83 = icmp slt i64 %82, 0
  %84 = select i1 %83, i64 %39, i64 0
  %85 = getelementptr double, ptr %40, i64 %82
  %86 = getelementptr double, ptr %85, i64 %84
  %87 = load double, ptr %86, align 8, !noalias !5
  %88 = fcmp ole double %87, %43
  %89 = select i1 %88, i64 %79, i64 %82
  %90 = select i1 %88, i64 %82, i64 %80
  %91 = sub nsw i64 %89, %90
  %92 = icmp sgt i64 %91, 1
  br i1 %92, label %78, label %93

93:                                               ; preds = %78, %76, %69, %66
  %94 = phi i64 [ %26, %66 ], [ %26, %69 ], [ %90, %78 ], [ 0, %76 ]
  %95 = icmp slt i64 %94, 0
  %96 = select i1 %95, i64 %39, i64 0
  %97 = getelementptr double, ptr %40, i64 %94
  %98 = getelementptr double, ptr %97, i64 %96
  %99 = load double, ptr %98, align 8, !noalias !0
  %100 = fsub double %43, %99
  %101 = add nsw i64 %28, %94
  %102 = icmp slt i64 %101, 0
  %103 = select i1 %102, i64 %9, i64 0
  %104 = add i64 %101, %103
  %105 = mul i64 %104, %10
  %106 = getelementptr double, ptr %8, i64 %105
  %107 = load double, ptr %106, align 8, !noalias !0
  %108 = getelementptr i8, ptr %106, i64 8
  %109 = load double, ptr %108, align 8, !noalias !0
  %110 = getelementptr i8, ptr %106, i64 16
  %111 = load double, ptr %110, align 8, !noalias !0
  %112 = getelementptr i8, ptr %106, i64 24
  %113 = load double, ptr %112, align 8, !noalias !0
  %114 = fmul double %100, %113
  %115 = fadd double %111, %114
  %116 = fmul double %100, %115
  %117 = fadd double %109, %116
  %118 = fmul double %100, %117
  %119 = fadd double %107, %118
  %120 = add i64 %15, 1
  %121 = add nsw i64 %16, -1
  %122 = load i64, ptr %24, align 8
  %123 = icmp slt i64 %122, 0
  %124 = select i1 %123, i64 %2, i64 0
  %125 = getelementptr double, ptr %1, i64 %122
  %126 = getelementptr double, ptr %125, i64 %124
  store double %119, ptr %126, align 8
  store i64 %94, ptr %25, align 8
  br label %14
}

define i64 @step_back(i64 %0) local_unnamed_addr #2 {
  %2 = alloca ptr, align 8
  %3 = alloca ptr, align 8
  %4 = inttoptr i64 %0 to ptr
  %5 = load i64, ptr %4, align 8, !noalias !9
  %6 = inttoptr i64 %5 to ptr
  %7 = getelementptr i8, ptr %4, i64 24
  %8 = load i64, ptr %7, align 8, !noalias !9
  %9 = inttoptr i64 %8 to ptr
  %10 = getelementptr i8, ptr %4, i64 48
  %11 = load i64, ptr %10, align 8, !noalias !9
  %12 = getelementptr i8, ptr %4, i64 56
  %13 = load i64, ptr %12, align 8, !noalias !9
  %14 = inttoptr i64 %11 to ptr
  %15 = getelementptr i8, ptr %4, i64 72
  %16 = load i64, ptr %15, align 8, !noalias !9
  %17 = inttoptr i64 %16 to ptr
  %18 = getelementptr i8, ptr %4, i64 96
  %19 = load i64, ptr %18, align 8, !noalias !9
  %20 = getelementptr i8, ptr %4, i64 104
  %21 = load i64, ptr %20, align 8, !noalias !9
  %22 = getelementptr i8, ptr %4, i64 112
  %23 = load i64, ptr %22, align 8, !noalias !9
  %24 = inttoptr i64 %19 to ptr
  %25 = getelementptr i8, ptr %4, i64 120
  %26 = load i64, ptr %25, align 8, !noalias !9
  %27 = getelementptr i8, ptr %4, i64 128
  %28 = load i64, ptr %27, align 8, !noalias !9
  %29 = inttoptr i64 %26 to ptr
  %30 = getelementptr i8, ptr %4, i64 144
  %31 = load i64, ptr %30, align 8, !noalias !9
  %32 = getelementptr i8, ptr %4, i64 152
  %33 = load i64, ptr %32, align 8, !noalias !9
  %34 = getelementptr i8, ptr %4, i64 160
  %35 = load i64, ptr %34, align 8, !noalias !9
  %36 = inttoptr i64 %31 to ptr
  %37 = getelementptr i8, ptr %4, i64 168
  %38 = load i64, ptr %37, align 8, !noalias !9
  %39 = inttoptr i64 %38 to ptr
  %40 = getelementptr i8, ptr %4, i64 192
  %41 = load i64, ptr %40, align 8, !noalias !9
  %42 = getelementptr i8, ptr %4, i64 200
  %43 = load i64, ptr %42, align 8, !noalias !9
  %44 = inttoptr i64 %41 to ptr
  %45 = getelementptr i8, ptr %4, i64 216
  %46 = load i64, ptr %45, align 8, !noalias !9
  %47 = getelementptr i8, ptr %4, i64 240
  %48 = load i64, ptr %47, align 8, !noalias !9
  %49 = getelementptr i8, ptr %4, i64 264
  %50 = load i64, ptr %49, align 8, !noalias !9
  %51 = getelementptr i8, ptr %4, i64 272
  %52 = load i64, ptr %51, align 8, !noalias !9
  %53 = inttoptr i64 %50 to ptr
  %54 = getelementptr i8, ptr %4, i64 288
  %55 = load i64, ptr %54, align 8, !noalias !9
  %56 = getelementptr i8, ptr %4, i64 296
  %57 = load i64, ptr %56, align 8, !noalias !9
  %58 = inttoptr i64 %55 to ptr
  %59 = getelementptr i8, ptr %4, i64 312
  %60 = load i64, ptr %59, align 8, !noalias !9
  %61 = getelementptr i8, ptr %4, i64 320
  %62 = load i64, ptr %61, align 8, !noalias !9
  %63 = inttoptr i64 %60 to ptr
  %64 = getelementptr i8, ptr %4, i64 336
  %65 = load i64, ptr %64, align 8, !noalias !9
  %66 = getelementptr i8, ptr %4, i64 360
  %67 = load i64, ptr %66, align 8, !noalias !9
  %68 = getelementptr i8, ptr %4, i64 384
  %69 = load i64, ptr %68, align 8, !noalias !9
  %70 = getelementptr i8, ptr %4, i64 392
  %71 = load i64, ptr %70, align 8, !noalias !9
  %72 = inttoptr i64 %69 to ptr
  %73 = getelementptr i8, ptr %4, i64 408
  %74 = load i64, ptr %73, align 8, !noalias !9
  %75 = getelementptr i8, ptr %4, i64 416
  %76 = load i64, ptr %75, align 8, !noalias !9
  %77 = inttoptr i64 %74 to ptr
  %78 = getelementptr i8, ptr %4, i64 432
  %79 = load i64, ptr %78, align 8, !noalias !9
  %80 = getelementptr i8, ptr %4, i64 456
  %81 = load i64, ptr %80, align 8, !noalias !9
  %82 = getelementptr i8, ptr %4, i64 464
  %83 = load i64, ptr %82, align 8, !noalias !9
  %84 = getelementptr i8, ptr %4, i64 480
  %85 = load i64, ptr %84, align 8, !noalias !9
  %86 = getelementptr i8, ptr %4, i64 488
  %87 = load i64, ptr %86, align 8, !noalias !9
  %88 = inttoptr i64 %85 to ptr
  %89 = getelementptr i8, ptr %4, i64 504
  %90 = load i64, ptr %89, align 8, !noalias !9
  %91 = getelementptr i8, ptr %4, i64 512
  %92 = load i64, ptr %91, align 8, !noalias !9
  %93 = inttoptr i64 %90 to ptr
  %94 = getelementptr i8, ptr %4, i64 528
  %95 = load i64, ptr %94, align 8, !noalias !9
  %96 = getelementptr i8, ptr %4, i64 536
  %97 = load i64, ptr %96, align 8, !noalias !9
  %98 = inttoptr i64 %95 to ptr
  %99 = getelementptr i8, ptr %4, i64 552
  %100 = load i64, ptr %99, align 8, !noalias !9
  %101 = getelementptr i8, ptr %4, i64 560
  %102 = load i64, ptr %101, align 8, !noalias !9
  %103 = getelementptr i8, ptr %4, i64 568
  %104 = load i64, ptr %103, align 8, !noalias !9
  %105 = inttoptr i64 %100 to ptr
  %106 = getelementptr i8, ptr %6, i64 8
  %107 = load i64, ptr %106, align 8, !noalias !9
  %108 = getelementptr i8, ptr %6, i64 16
  %109 = load i64, ptr %108, align 8, !noalias !9
  %110 = load i64, ptr %39, align 8, !noalias !9
  %111 = getelementptr i8, ptr %39, i64 8
  %112 = load i64, ptr %111, align 8, !noalias !9
  %113 = getelementptr i8, ptr %39, i64 16
  %114 = load i64, ptr %113, align 8, !noalias !9
  %115 = getelementptr i8, ptr %39, i64 24
  %116 = load i64, ptr %115, align 8, !noalias !9
  %117 = icmp ugt i64 %57, -9223372036854775808
  %118 = select i1 %117, i64 0, i64 %57
  br label %119

119:                                              ; preds = %189, %1
  %120 = phi i64 [ %57, %1 ], [ %122, %189 ]
  %121 = phi i64 [ %118, %1 ], [ %198, %189 ]
  %122 = add i64 %120, -1
  %123 = icmp sgt i64 %121, 0
  br i1 %123, label %197, label %338

124:                                              ; preds = %197, %209
  %125 = phi i64 [ 0, %197 ], [ %211, %209 ]
  %126 = phi i64 [ %208, %197 ], [ %210, %209 ]
  %127 = icmp sgt i64 %126, 0
  br i1 %127, label %209, label %128

128:                                              ; preds = %124
  %129 = mul nsw i64 %122, %83
  %130 = shl i64 %129, 3
  %131 = add i64 %65, %130
  %132 = mul nsw i64 %122, %110
  %133 = mul nsw i64 %132, %83
  %134 = shl i64 %133, 3
  %135 = add i64 %67, %134
  %136 = icmp ugt i64 %110, -9223372036854775808
  %137 = select i1 %136, i64 0, i64 %110
  br label %138

138:                                              ; preds = %183, %128
  %139 = phi i64 [ %110, %128 ], [ %141, %183 ]
  %140 = phi i64 [ %137, %128 ], [ %217, %183 ]
  %141 = add i64 %139, -1
  %142 = icmp sgt i64 %140, 0
  br i1 %142, label %216, label %187

143:                                              ; preds = %216, %251
  %144 = phi i64 [ 0, %216 ], [ %253, %251 ]
  %145 = phi i64 [ %250, %216 ], [ %252, %251 ]
  %146 = icmp sgt i64 %145, 0
  br i1 %146, label %251, label %147

147:                                              ; preds = %143
  %148 = select i1 %218, i64 %52, i64 0
  %149 = getelementptr double, ptr %53, i64 %141
  %150 = getelementptr double, ptr %149, i64 %148
  %151 = load double, ptr %150, align 8, !noalias !9
  %152 = fmul double %151, %207
  %153 = fadd double %203, %152
  store ptr null, ptr %2, align 8, !noalias !13
  store ptr null, ptr %3, align 8, !noalias !13
  store double %153, ptr %9, align 8, !noalias !13
  %154 = icmp sgt i64 %21, 0
  br i1 %154, label %155, label %158

155:                                              ; preds = %147
  store ptr null, ptr %2, align 8, !noalias !13
  %156 = call fastcc i32 @_sample(ptr nonnull %2, ptr %14, i64 %13, ptr %24, i64 %21, i64 %23, ptr %29, i64 %28, ptr %36, i64 %33, i64 %35, double %153) #2
  switch i32 %156, label %157 [
    i32 -2, label %158
    i32 0, label %158
  ], !prof !20

157:                                              ; preds = %155
  br label %158

158:                                              ; preds = %155, %155, %147, %157
  %159 = phi i32 [ %156, %157 ], [ 0, %147 ], [ 0, %155 ], [ 0, %155 ]
  switch i32 %159, label %165 [
    i32 -2, label %160
    i32 0, label %160
  ], !prof !20

160:                                              ; preds = %158, %158
  %161 = load i64, ptr %6, align 8, !noalias !21
  %162 = inttoptr i64 %161 to ptr
  %163 = inttoptr i64 %81 to ptr
  %164 = call i32 %162(ptr nonnull %9, ptr %163, ptr %14, ptr %17, ptr %93) #2, !noalias !21
  br label %165

165:                                              ; preds = %158, %160
  %166 = phi i32 [ %164, %160 ], [ 0, %158 ]
  %167 = phi i32 [ 0, %160 ], [ %159, %158 ]
  switch i32 %167, label %338 [
    i32 -2, label %264
    i32 0, label %264
  ], !prof !20

168:                                              ; preds = %264
  %169 = getelementptr i8, ptr %39, i64 32
  store i64 %122, ptr %169, align 8, !noalias !9
  %170 = sext i32 %166 to i64
  br label %338

171:                                              ; preds = %264, %266
  %172 = phi i64 [ %268, %266 ], [ 0, %264 ]
  %173 = phi i64 [ %267, %266 ], [ %250, %264 ]
  %174 = icmp sgt i64 %173, 0
  br i1 %174, label %266, label %175

175:                                              ; preds = %171
  %176 = call i64 @llvm.smax.i64(i64 %114, i64 0)
  br label %177

177:                                              ; preds = %175, %280
  %178 = phi i64 [ 0, %175 ], [ %282, %280 ]
  %179 = phi i64 [ %176, %175 ], [ %281, %280 ]
  %180 = icmp sgt i64 %179, 0
  br i1 %180, label %280, label %181

181:                                              ; preds = %177
  %182 = call i64 @llvm.smax.i64(i64 %116, i64 0)
  br label %183

183:                                              ; preds = %181, %295
  %184 = phi i64 [ 0, %181 ], [ %297, %295 ]
  %185 = phi i64 [ %182, %181 ], [ %296, %295 ]
  %186 = icmp sgt i64 %185, 0
  br i1 %186, label %295, label %138

187:                                              ; preds = %138
  %188 = call i64 @llvm.smax.i64(i64 %110, i64 0)
  br label %189

189:                                              ; preds = %193, %187
  %190 = phi i64 [ 0, %187 ], [ %318, %193 ]
  %191 = phi i64 [ %188, %187 ], [ %317, %193 ]
  %192 = icmp sgt i64 %191, 0
  br i1 %192, label %316, label %119

193:                                              ; preds = %316, %321
  %194 = phi i64 [ 0, %316 ], [ %323, %321 ]
  %195 = phi i64 [ %320, %316 ], [ %322, %321 ]
  %196 = icmp sgt i64 %195, 0
  br i1 %196, label %321, label %189

197:                                              ; preds = %119
  %198 = add nsw i64 %121, -1
  %199 = icmp slt i64 %122, 0
  %200 = select i1 %199, i64 %57, i64 0
  %201 = getelementptr double, ptr %58, i64 %122
  %202 = getelementptr double, ptr %201, i64 %200
  %203 = load double, ptr %202, align 8, !noalias !9
  %204 = select i1 %199, i64 %62, i64 0
  %205 = getelementptr double, ptr %63, i64 %122
  %206 = getelementptr double, ptr %205, i64 %204
  %207 = load double, ptr %206, align 8, !noalias !9
  %208 = call i64 @llvm.smax.i64(i64 %76, i64 0)
  br label %124

209:                                              ; preds = %124
  %210 = add nsw i64 %126, -1
  %211 = add i64 %125, 1
  %212 = icmp slt i64 %125, 0
  %213 = select i1 %212, i64 %76, i64 0
  %214 = getelementptr double, ptr %77, i64 %125
  %215 = getelementptr double, ptr %214, i64 %213
  store double %207, ptr %215, align 8, !noalias !9
  br label %124

216:                                              ; preds = %138
  %217 = add nsw i64 %140, -1
  %218 = icmp slt i64 %141, 0
  %219 = select i1 %218, i64 %43, i64 0
  %220 = getelementptr i64, ptr %44, i64 %141
  %221 = getelementptr i64, ptr %220, i64 %219
  %222 = load i64, ptr %221, align 8, !noalias !9
  %223 = icmp ugt i64 %139, -9223372036854775808
  %224 = select i1 %223, i64 %43, i64 0
  %225 = getelementptr i8, ptr %220, i64 8
  %226 = getelementptr i64, ptr %225, i64 %224
  %227 = load i64, ptr %226, align 8, !noalias !9
  %228 = sub nsw i64 %227, %222
  %229 = shl i64 %222, 3
  %230 = add i64 %46, %229
  %231 = add i64 %48, %229
  %232 = call i64 @llvm.smax.i64(i64 %228, i64 1)
  %233 = add nsw i64 %232, -1
  %234 = call i64 @llvm.smin.i64(i64 %228, i64 1)
  call fastcc void @pydy_combine(i64 %81, i64 %131, i64 %74, i64 %135, i64 %230, i64 %231, i64 %233, i64 %234, i64 %109) #2, !noalias !9
  %235 = add nsw i64 %110, %141
  %236 = icmp slt i64 %235, 0
  %237 = select i1 %236, i64 %43, i64 0
  %238 = getelementptr i64, ptr %44, i64 %235
  %239 = getelementptr i64, ptr %238, i64 %237
  %240 = load i64, ptr %239, align 8, !noalias !9
  %241 = shl i64 %240, 3
  %242 = add i64 %46, %241
  %243 = add i64 %48, %241
  %244 = icmp slt i64 %235, -1
  %245 = select i1 %244, i64 %43, i64 0
  %246 = getelementptr i8, ptr %238, i64 8
  %247 = getelementptr i64, ptr %246, i64 %245
  %248 = load i64, ptr %247, align 8, !noalias !9
  %249 = sub nsw i64 %248, %240
  call fastcc void @pydy_combine(i64 %85, i64 %79, i64 %74, i64 %69, i64 %242, i64 %243, i64 %249, i64 0, i64 %109) #2, !noalias !9
  %250 = call i64 @llvm.smax.i64(i64 %107, i64 0)
  br label %143

251:                                              ; preds = %143
  %252 = add nsw i64 %145, -1
  %253 = add i64 %144, 1
  %254 = icmp slt i64 %144, 0
  %255 = select i1 %254, i64 %87, i64 0
  %256 = getelementptr double, ptr %88, i64 %144
  %257 = getelementptr double, ptr %256, i64 %255
  %258 = load double, ptr %257, align 8, !noalias !9
  %259 = add nsw i64 %112, %144
  %260 = icmp slt i64 %259, 0
  %261 = select i1 %260, i64 %13, i64 0
  %262 = getelementptr double, ptr %14, i64 %259
  %263 = getelementptr double, ptr %262, i64 %261
  store double %258, ptr %263, align 8, !noalias !9
  br label %143

264:                                              ; preds = %165, %165
  %265 = icmp eq i32 %166, 0
  br i1 %265, label %171, label %168

266:                                              ; preds = %171
  %267 = add nsw i64 %173, -1
  %268 = add i64 %172, 1
  %269 = icmp slt i64 %172, 0
  %270 = select i1 %269, i64 %92, i64 0
  %271 = getelementptr double, ptr %93, i64 %172
  %272 = getelementptr double, ptr %271, i64 %270
  %273 = load double, ptr %272, align 8, !noalias !9
  %274 = mul nsw i64 %141, %83
  %275 = add nsw i64 %274, %172
  %276 = icmp slt i64 %275, 0
  %277 = select i1 %276, i64 %71, i64 0
  %278 = getelementptr double, ptr %72, i64 %275
  %279 = getelementptr double, ptr %278, i64 %277
  store double %273, ptr %279, align 8, !noalias !9
  br label %171

280:                                              ; preds = %177
  %281 = add nsw i64 %179, -1
  %282 = add i64 %178, 1
  %283 = icmp slt i64 %178, 0
  %284 = select i1 %283, i64 %97, i64 0
  %285 = getelementptr double, ptr %98, i64 %178
  %286 = getelementptr double, ptr %285, i64 %284
  %287 = load double, ptr %286, align 8, !noalias !9
  %288 = add nsw i64 %107, %178
  %289 = icmp slt i64 %288, 0
  %290 = select i1 %289, i64 %92, i64 0
  %291 = getelementptr double, ptr %93, i64 %288
  %292 = getelementptr double, ptr %291, i64 %290
  %293 = load double, ptr %292, align 8, !noalias !9
  %294 = fadd double %287, %293
  store double %294, ptr %286, align 8, !noalias !9
  br label %177

295:                                              ; preds = %183
  %296 = add nsw i64 %185, -1
  %297 = add i64 %184, 1
  %298 = add nsw i64 %107, %114
  %299 = sub nsw i64 %298, %116
  %300 = add nsw i64 %299, %184
  %301 = icmp slt i64 %300, 0
  %302 = select i1 %301, i64 %92, i64 0
  %303 = getelementptr double, ptr %93, i64 %300
  %304 = getelementptr double, ptr %303, i64 %302
  %305 = load double, ptr %304, align 8, !noalias !9
  %306 = add nsw i64 %132, %141
  %307 = icmp slt i64 %306, 0
  %308 = select i1 %307, i64 %102, i64 0
  %309 = add i64 %306, %308
  %310 = icmp slt i64 %184, 0
  %311 = select i1 %310, i64 %104, i64 0
  %312 = mul i64 %309, %104
  %313 = getelementptr double, ptr %105, i64 %312
  %314 = getelementptr double, ptr %313, i64 %184
  %315 = getelementptr double, ptr %314, i64 %311
  store double %305, ptr %315, align 8, !noalias !9
  br label %183

316:                                              ; preds = %189
  %317 = add nsw i64 %191, -1
  %318 = add i64 %190, 1
  %319 = mul nsw i64 %190, %83
  %320 = call i64 @llvm.smax.i64(i64 %107, i64 0)
  br label %193

321:                                              ; preds = %193
  %322 = add nsw i64 %195, -1
  %323 = add i64 %194, 1
  %324 = mul nsw i64 %110, %83
  %325 = add nsw i64 %324, %194
  %326 = icmp slt i64 %325, 0
  %327 = select i1 %326, i64 %71, i64 0
  %328 = getelementptr double, ptr %72, i64 %325
  %329 = getelementptr double, ptr %328, i64 %327
  %330 = load double, ptr %329, align 8, !noalias !9
  %331 = add nsw i64 %319, %194
  %332 = icmp slt i64 %331, 0
  %333 = select i1 %332, i64 %71, i64 0
  %334 = getelementptr double, ptr %72, i64 %331
  %335 = getelementptr double, ptr %334, i64 %333
  %336 = load double, ptr %335, align 8, !noalias !9
  %337 = fadd double %330, %336
  store double %337, ptr %329, align 8, !noalias !9
  br label %193

338:                                              ; preds = %165, %119, %168
  %339 = phi i64 [ 0, %119 ], [ %170, %168 ], [ 0, %165 ]
  ret i64 %339
}



declare i64 @llvm.smax.i64(i64, i64) #1

declare i64 @llvm.smin.i64(i64, i64) #1

attributes #0 = { noinline }
attributes #1 = { nounwind willreturn memory(none) }
attributes #2 = { nounwind }
attributes #3 = { nounwind willreturn }

!0 = !{!1, !3}
!1 = distinct !{!1, !2}
!2 = distinct !{!2}
!3 = distinct !{!3, !2}
!4 = !{!"branch_weights", i32 1, i32 99}
!5 = !{!6, !1, !3}
!6 = distinct !{!6, !7}
!7 = distinct !{!7}
!8 = !{!"branch_weights", i32 99, i32 1}
!9 = !{!10, !12}
!10 = distinct !{!10, !11}
!11 = distinct !{!11}
!12 = distinct !{!12, !11}
!13 = !{!14, !16, !17, !19}
!14 = distinct !{!14, !15}
!15 = distinct !{!15}
!16 = distinct !{!16, !15}
!17 = distinct !{!17, !18}
!18 = distinct !{!18}
!19 = distinct !{!19, !18}
!20 = !{!"branch_weights", i32 1, i32 49, i32 49}
!21 = !{!17, !19}
