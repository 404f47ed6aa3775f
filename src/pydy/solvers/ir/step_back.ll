; sources b6fc935157c3709cdda1813477e29244c5e95acdaef548025ae60d2fedf16319
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

define internal fastcc void @pydy_combine(i64 %0, i64 %1, i64 %2, i64 %3, i64 %4, i64 %5, i64 %6, i64 %7) unnamed_addr #0 {
  %9 = inttoptr i64 %2 to ptr
  %10 = load <8 x double>, ptr %9, align 8
  %11 = lshr i64 %7, 2
  %12 = and i64 %7, 2305843009213693948
  br label %13

13:                                               ; preds = %55, %8
  %14 = phi i64 [ 0, %8 ], [ %74, %55 ]
  %15 = icmp samesign ult i64 %14, %11
  br i1 %15, label %16, label %21

16:                                               ; preds = %13
  %17 = shl i64 %14, 5
  %18 = or disjoint i64 %17, 8
  %19 = or disjoint i64 %17, 16
  %20 = or disjoint i64 %17, 24
  br label %23

21:                                               ; preds = %13
  %22 = and i64 %7, 3
  br label %75

23:                                               ; preds = %30, %16
  %24 = phi <8 x double> [ zeroinitializer, %16 ], [ %44, %30 ]
  %25 = phi <8 x double> [ zeroinitializer, %16 ], [ %47, %30 ]
  %26 = phi <8 x double> [ zeroinitializer, %16 ], [ %50, %30 ]
  %27 = phi <8 x double> [ zeroinitializer, %16 ], [ %53, %30 ]
  %28 = phi i64 [ 0, %16 ], [ %54, %30 ]
  %29 = icmp slt i64 %28, %6
  br i1 %29, label %30, label %55

30:                                               ; preds = %23
  %31 = inttoptr i64 %3 to ptr
  %32 = inttoptr i64 %5 to ptr
  %33 = inttoptr i64 %4 to ptr
  %34 = shl i64 %28, 3
  %35 = getelementptr i8, ptr %32, i64 %34
  %36 = load double, ptr %35, align 8
  %37 = insertelement <8 x double> poison, double %36, i64 0
  %38 = shufflevector <8 x double> %37, <8 x double> poison, <8 x i32> zeroinitializer
  %39 = getelementptr i8, ptr %33, i64 %34
  %40 = load i64, ptr %39, align 8
  %41 = getelementptr double, ptr %31, i64 %40
  %42 = getelementptr double, ptr %41, i64 %17
  %43 = load <8 x double>, ptr %42, align 8
  %44 = call <8 x double> @llvm.fma.v8f64(<8 x double> %38, <8 x double> %43, <8 x double> %24)
  %45 = getelementptr i8, ptr %42, i64 64
  %46 = load <8 x double>, ptr %45, align 8
  %47 = call <8 x double> @llvm.fma.v8f64(<8 x double> %38, <8 x double> %46, <8 x double> %25)
  %48 = getelementptr i8, ptr %42, i64 128
  %49 = load <8 x double>, ptr %48, align 8
  %50 = call <8 x double> @llvm.fma.v8f64(<8 x double> %38, <8 x double> %49, <8 x double> %26)
  %51 = getelementptr i8, ptr %42, i64 192
  %52 = load <8 x double>, ptr %51, align 8
  %53 = call <8 x double> @llvm.fma.v8f64(<8 x double> %38, <8 x double> %52, <8 x double> %27)
  %54 = add nuw nsw i64 %28, 1
  br label %23

55:                                               ; preds = %23
  %56 = inttoptr i64 %1 to ptr
  %57 = getelementptr double, ptr %56, i64 %17
  %58 = load <8 x double>, ptr %57, align 8
  %59 = call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %24, <8 x double> %58)
  %60 = inttoptr i64 %0 to ptr
  %61 = getelementptr double, ptr %60, i64 %17
  store <8 x double> %59, ptr %61, align 8
  %62 = getelementptr double, ptr %56, i64 %18
  %63 = load <8 x double>, ptr %62, align 8
  %64 = call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %25, <8 x double> %63)
  %65 = getelementptr double, ptr %60, i64 %18
  store <8 x double> %64, ptr %65, align 8
  %66 = getelementptr double, ptr %56, i64 %19
  %67 = load <8 x double>, ptr %66, align 8
  %68 = call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %26, <8 x double> %67)
  %69 = getelementptr double, ptr %60, i64 %19
  store <8 x double> %68, ptr %69, align 8
  %70 = getelementptr double, ptr %56, i64 %20
  %71 = load <8 x double>, ptr %70, align 8
  %72 = call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %27, <8 x double> %71)
  %73 = getelementptr double, ptr %60, i64 %20
  store <8 x double> %72, ptr %73, align 8
  %74 = add nuw nsw i64 %14, 1
  br label %13

75:                                               ; preds = %102, %21
  %76 = phi i64 [ 0, %21 ], [ %109, %102 ]
  %77 = icmp samesign ult i64 %76, %22
  br i1 %77, label %78, label %81

78:                                               ; preds = %75
  %79 = add nuw i64 %12, %76
  %80 = shl i64 %79, 3
  br label %82

81:                                               ; preds = %75
  ret void

82:                                               ; preds = %86, %78
  %83 = phi <8 x double> [ zeroinitializer, %78 ], [ %100, %86 ]
  %84 = phi i64 [ 0, %78 ], [ %101, %86 ]
  %85 = icmp slt i64 %84, %6
  br i1 %85, label %86, label %102

86:                                               ; preds = %82
  %87 = inttoptr i64 %3 to ptr
  %88 = inttoptr i64 %5 to ptr
  %89 = inttoptr i64 %4 to ptr
  %90 = shl i64 %84, 3
  %91 = getelementptr i8, ptr %88, i64 %90
  %92 = load double, ptr %91, align 8
  %93 = insertelement <8 x double> poison, double %92, i64 0
  %94 = shufflevector <8 x double> %93, <8 x double> poison, <8 x i32> zeroinitializer
  %95 = getelementptr i8, ptr %89, i64 %90
  %96 = load i64, ptr %95, align 8
  %97 = getelementptr double, ptr %87, i64 %96
  %98 = getelementptr double, ptr %97, i64 %80
  %99 = load <8 x double>, ptr %98, align 8
  %100 = call <8 x double> @llvm.fma.v8f64(<8 x double> %94, <8 x double> %99, <8 x double> %83)
  %101 = add nuw nsw i64 %84, 1
  br label %82

102:                                              ; preds = %82
  %103 = inttoptr i64 %1 to ptr
  %104 = getelementptr double, ptr %103, i64 %80
  %105 = load <8 x double>, ptr %104, align 8
  %106 = call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %83, <8 x double> %105)
  %107 = inttoptr i64 %0 to ptr
  %108 = getelementptr double, ptr %107, i64 %80
  store <8 x double> %106, ptr %108, align 8
  %109 = add nuw nsw i64 %76, 1
  br label %75
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #1

define internal fastcc i32 @_sample(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, i64 %5, ptr %6, i64 %7, ptr %8, i64 %9, i64 %10, double %11) unnamed_addr #0 {
  %13 = call i64 @llvm.smax.i64(i64 %4, i64 0)
  br label %14

14:                                               ; preds = %95, %12
  %15 = phi i64 [ 0, %12 ], [ %21, %95 ]
  %16 = phi i64 [ %13, %12 ], [ %20, %95 ]
  %17 = icmp sgt i64 %16, 0
  br i1 %17, label %19, label %18

18:                                               ; preds = %14
  store ptr null, ptr %0, align 8
  ret i32 0

19:                                               ; preds = %14
  %20 = add nsw i64 %16, -1
  %21 = add i64 %15, 1
  %22 = icmp slt i64 %15, 0
  %23 = select i1 %22, i64 %4, i64 0
  %24 = add i64 %15, %23
  %25 = mul i64 %24, %5
  %26 = getelementptr i64, ptr %3, i64 %25
  %27 = getelementptr i8, ptr %26, i64 8
  %28 = load i64, ptr %27, align 8
  %29 = getelementptr i8, ptr %26, i64 16
  %30 = load i64, ptr %29, align 8
  %31 = add nsw i64 %28, %30
  %32 = icmp slt i64 %28, 0
  %33 = select i1 %32, i64 %7, i64 0
  %34 = add i64 %28, %33
  %35 = icmp slt i64 %34, 0
  br i1 %35, label %52, label %53, !prof !0

36:                                               ; preds = %67, %64
  %37 = phi i64 [ %7, %67 ], [ %65, %64 ]
  %38 = sub i64 %37, %58
  %39 = call i64 @llvm.smax.i64(i64 %38, i64 0)
  %40 = getelementptr double, ptr %6, i64 %58
  %41 = load double, ptr %40, align 8
  %42 = fcmp ogt double %41, %11
  %43 = select i1 %42, double %41, double %11
  %44 = getelementptr i8, ptr %26, i64 24
  %45 = load i64, ptr %44, align 8
  %46 = icmp slt i64 %45, 0
  %47 = select i1 %46, i64 %39, i64 0
  %48 = getelementptr double, ptr %40, i64 %45
  %49 = getelementptr double, ptr %48, i64 %47
  %50 = load double, ptr %49, align 8, !noalias !1
  %51 = fcmp ugt double %50, %43
  br i1 %51, label %78, label %68

52:                                               ; preds = %19
  br label %53

53:                                               ; preds = %52, %19
  %54 = phi i64 [ 0, %52 ], [ %34, %19 ]
  %55 = icmp slt i64 %34, %7
  br i1 %55, label %57, label %56, !prof !4

56:                                               ; preds = %53
  br label %57

57:                                               ; preds = %56, %53
  %58 = phi i64 [ %7, %56 ], [ %54, %53 ]
  %59 = icmp slt i64 %31, 0
  %60 = select i1 %59, i64 %7, i64 0
  %61 = add i64 %31, %60
  %62 = icmp slt i64 %61, 0
  br i1 %62, label %63, label %64, !prof !0

63:                                               ; preds = %57
  br label %64

64:                                               ; preds = %63, %57
  %65 = phi i64 [ 0, %63 ], [ %61, %57 ]
  %66 = icmp slt i64 %61, %7
  br i1 %66, label %36, label %67, !prof !4

67:                                               ; preds = %64
  br label %36

68:                                               ; preds = %36
  %69 = add nsw i64 %39, -1
  %70 = icmp eq i64 %45, %69
  br i1 %70, label %95, label %71

71:                                               ; preds = %68
  %72 = icmp slt i64 %45, -1
  %73 = select i1 %72, i64 %39, i64 0
  %74 = getelementptr i8, ptr %48, i64 8
  %75 = getelementptr double, ptr %74, i64 %73
  %76 = load double, ptr %75, align 8, !noalias !1
  %77 = fcmp olt double %43, %76
  br i1 %77, label %95, label %78

78:                                               ; preds = %71, %36
  %79 = icmp sgt i64 %38, 1
  br i1 %79, label %80, label %95

80:                                               ; preds = %80, %78
  %81 = phi i64 [ %91, %80 ], [ %39, %78 ]
  %82 = phi i64 [ %92, %80 ], [ 0, %78 ]
  %83 = add nsw i64 %82, %81
  %84 = ashr i64 %83, 1
  %85 = icmp slt i64 %84, 0
  %86 = select i1 %85, i64 %39, i64 0
  %87 = getelementptr double, ptr %40, i64 %84
  %88 = getelementptr double, ptr %87, i64 %86
  %89 = load double, ptr %88, align 8, !noalias !1
  %90 = fcmp ole double %89, %43
  %91 = select i1 %90, i64 %81, i64 %84
  %92 = select i1 %90, i64 %84, i64 %82
  %93 = sub nsw i64 %91, %92
  %94 = icmp sgt i64 %93, 1
  br i1 %94, label %80, label %95

95:                                               ; preds = %80, %78, %71, %68
  %96 = phi i64 [ %45, %68 ], [ %45, %71 ], [ %92, %80 ], [ 0, %78 ]
  store i64 %96, ptr %44, align 8
  %97 = icmp slt i64 %96, 0
  %98 = select i1 %97, i64 %39, i64 0
  %99 = getelementptr double, ptr %40, i64 %96
  %100 = getelementptr double, ptr %99, i64 %98
  %101 = load double, ptr %100, align 8
  %102 = fsub double %43, %101
  %103 = add nsw i64 %28, %96
  %104 = icmp slt i64 %103, 0
  %105 = select i1 %104, i64 %9, i64 0
  %106 = add i64 %103, %105
  %107 = mul i64 %106, %10
  %108 = getelementptr double, ptr %8, i64 %107
  %109 = load double, ptr %108, align 8
  %110 = getelementptr i8, ptr %108, i64 8
  %111 = load double, ptr %110, align 8
  %112 = getelementptr i8, ptr %108, i64 16
  %113 = load double, ptr %112, align 8
  %114 = getelementptr i8, ptr %108, i64 24
  %115 = load double, ptr %114, align 8
  %116 = fmul double %102, %115
  %117 = fadd double %113, %116
  %118 = fmul double %102, %117
  %119 = fadd double %111, %118
  %120 = fmul double %102, %119
  %121 = fadd double %109, %120
  %122 = load i64, ptr %26, align 8
  %123 = icmp slt i64 %122, 0
  %124 = select i1 %123, i64 %2, i64 0
  %125 = getelementptr double, ptr %1, i64 %122
  %126 = getelementptr double, ptr %125, i64 %124
  store double %121, ptr %126, align 8
  br label %14
}

define i64 @step_back(i64 %0) local_unnamed_addr #2 {
  %2 = alloca ptr, align 8
  %3 = alloca ptr, align 8
  %4 = inttoptr i64 %0 to ptr
  %5 = load i64, ptr %4, align 8, !noalias !5
  %6 = inttoptr i64 %5 to ptr
  %7 = getelementptr i8, ptr %4, i64 24
  %8 = load i64, ptr %7, align 8, !noalias !5
  %9 = inttoptr i64 %8 to ptr
  %10 = getelementptr i8, ptr %4, i64 48
  %11 = load i64, ptr %10, align 8, !noalias !5
  %12 = getelementptr i8, ptr %4, i64 56
  %13 = load i64, ptr %12, align 8, !noalias !5
  %14 = inttoptr i64 %11 to ptr
  %15 = getelementptr i8, ptr %4, i64 72
  %16 = load i64, ptr %15, align 8, !noalias !5
  %17 = inttoptr i64 %16 to ptr
  %18 = getelementptr i8, ptr %4, i64 96
  %19 = load i64, ptr %18, align 8, !noalias !5
  %20 = getelementptr i8, ptr %4, i64 104
  %21 = load i64, ptr %20, align 8, !noalias !5
  %22 = getelementptr i8, ptr %4, i64 112
  %23 = load i64, ptr %22, align 8, !noalias !5
  %24 = inttoptr i64 %19 to ptr
  %25 = getelementptr i8, ptr %4, i64 120
  %26 = load i64, ptr %25, align 8, !noalias !5
  %27 = getelementptr i8, ptr %4, i64 128
  %28 = load i64, ptr %27, align 8, !noalias !5
  %29 = inttoptr i64 %26 to ptr
  %30 = getelementptr i8, ptr %4, i64 144
  %31 = load i64, ptr %30, align 8, !noalias !5
  %32 = getelementptr i8, ptr %4, i64 152
  %33 = load i64, ptr %32, align 8, !noalias !5
  %34 = getelementptr i8, ptr %4, i64 160
  %35 = load i64, ptr %34, align 8, !noalias !5
  %36 = inttoptr i64 %31 to ptr
  %37 = getelementptr i8, ptr %4, i64 168
  %38 = load i64, ptr %37, align 8, !noalias !5
  %39 = inttoptr i64 %38 to ptr
  %40 = getelementptr i8, ptr %4, i64 192
  %41 = load i64, ptr %40, align 8, !noalias !5
  %42 = getelementptr i8, ptr %4, i64 200
  %43 = load i64, ptr %42, align 8, !noalias !5
  %44 = inttoptr i64 %41 to ptr
  %45 = getelementptr i8, ptr %4, i64 216
  %46 = load i64, ptr %45, align 8, !noalias !5
  %47 = getelementptr i8, ptr %4, i64 240
  %48 = load i64, ptr %47, align 8, !noalias !5
  %49 = getelementptr i8, ptr %4, i64 264
  %50 = load i64, ptr %49, align 8, !noalias !5
  %51 = getelementptr i8, ptr %4, i64 272
  %52 = load i64, ptr %51, align 8, !noalias !5
  %53 = inttoptr i64 %50 to ptr
  %54 = getelementptr i8, ptr %4, i64 288
  %55 = load i64, ptr %54, align 8, !noalias !5
  %56 = getelementptr i8, ptr %4, i64 296
  %57 = load i64, ptr %56, align 8, !noalias !5
  %58 = inttoptr i64 %55 to ptr
  %59 = getelementptr i8, ptr %4, i64 312
  %60 = load i64, ptr %59, align 8, !noalias !5
  %61 = getelementptr i8, ptr %4, i64 320
  %62 = load i64, ptr %61, align 8, !noalias !5
  %63 = inttoptr i64 %60 to ptr
  %64 = getelementptr i8, ptr %4, i64 336
  %65 = load i64, ptr %64, align 8, !noalias !5
  %66 = getelementptr i8, ptr %4, i64 360
  %67 = load i64, ptr %66, align 8, !noalias !5
  %68 = getelementptr i8, ptr %4, i64 384
  %69 = load i64, ptr %68, align 8, !noalias !5
  %70 = getelementptr i8, ptr %4, i64 392
  %71 = load i64, ptr %70, align 8, !noalias !5
  %72 = inttoptr i64 %69 to ptr
  %73 = getelementptr i8, ptr %4, i64 408
  %74 = load i64, ptr %73, align 8, !noalias !5
  %75 = getelementptr i8, ptr %4, i64 416
  %76 = load i64, ptr %75, align 8, !noalias !5
  %77 = inttoptr i64 %74 to ptr
  %78 = getelementptr i8, ptr %4, i64 432
  %79 = load i64, ptr %78, align 8, !noalias !5
  %80 = getelementptr i8, ptr %4, i64 456
  %81 = load i64, ptr %80, align 8, !noalias !5
  %82 = getelementptr i8, ptr %4, i64 464
  %83 = load i64, ptr %82, align 8, !noalias !5
  %84 = getelementptr i8, ptr %4, i64 480
  %85 = load i64, ptr %84, align 8, !noalias !5
  %86 = getelementptr i8, ptr %4, i64 488
  %87 = load i64, ptr %86, align 8, !noalias !5
  %88 = inttoptr i64 %85 to ptr
  %89 = getelementptr i8, ptr %4, i64 504
  %90 = load i64, ptr %89, align 8, !noalias !5
  %91 = getelementptr i8, ptr %4, i64 512
  %92 = load i64, ptr %91, align 8, !noalias !5
  %93 = inttoptr i64 %90 to ptr
  %94 = getelementptr i8, ptr %4, i64 528
  %95 = load i64, ptr %94, align 8, !noalias !5
  %96 = getelementptr i8, ptr %4, i64 536
  %97 = load i64, ptr %96, align 8, !noalias !5
  %98 = inttoptr i64 %95 to ptr
  %99 = getelementptr i8, ptr %4, i64 552
  %100 = load i64, ptr %99, align 8, !noalias !5
  %101 = getelementptr i8, ptr %4, i64 560
  %102 = load i64, ptr %101, align 8, !noalias !5
  %103 = getelementptr i8, ptr %4, i64 568
  %104 = load i64, ptr %103, align 8, !noalias !5
  %105 = inttoptr i64 %100 to ptr
  %106 = getelementptr i8, ptr %6, i64 8
  %107 = load i64, ptr %106, align 8, !noalias !5
  %108 = getelementptr i8, ptr %6, i64 16
  %109 = load i64, ptr %108, align 8, !noalias !5
  %110 = load i64, ptr %39, align 8, !noalias !5
  %111 = getelementptr i8, ptr %39, i64 8
  %112 = load i64, ptr %111, align 8, !noalias !5
  %113 = getelementptr i8, ptr %39, i64 16
  %114 = load i64, ptr %113, align 8, !noalias !5
  %115 = getelementptr i8, ptr %39, i64 24
  %116 = load i64, ptr %115, align 8, !noalias !5
  %117 = icmp ugt i64 %57, -9223372036854775808
  %118 = select i1 %117, i64 0, i64 %57
  br label %119

119:                                              ; preds = %189, %1
  %120 = phi i64 [ %57, %1 ], [ %122, %189 ]
  %121 = phi i64 [ %118, %1 ], [ %198, %189 ]
  %122 = add i64 %120, -1
  %123 = icmp sgt i64 %121, 0
  br i1 %123, label %197, label %335

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

143:                                              ; preds = %216, %248
  %144 = phi i64 [ 0, %216 ], [ %250, %248 ]
  %145 = phi i64 [ %247, %216 ], [ %249, %248 ]
  %146 = icmp sgt i64 %145, 0
  br i1 %146, label %248, label %147

147:                                              ; preds = %143
  %148 = select i1 %218, i64 %52, i64 0
  %149 = getelementptr double, ptr %53, i64 %141
  %150 = getelementptr double, ptr %149, i64 %148
  %151 = load double, ptr %150, align 8, !noalias !5
  %152 = fmul double %151, %207
  %153 = fadd double %203, %152
  store ptr null, ptr %2, align 8, !noalias !9
  store ptr null, ptr %3, align 8, !noalias !9
  store double %153, ptr %9, align 8, !noalias !9
  %154 = icmp sgt i64 %21, 0
  br i1 %154, label %155, label %158

155:                                              ; preds = %147
  store ptr null, ptr %2, align 8, !noalias !9
  %156 = call fastcc i32 @_sample(ptr nonnull %2, ptr %14, i64 %13, ptr %24, i64 %21, i64 %23, ptr %29, i64 %28, ptr %36, i64 %33, i64 %35, double %153) #2
  switch i32 %156, label %157 [
    i32 -2, label %158
    i32 0, label %158
  ], !prof !16

157:                                              ; preds = %155
  br label %158

158:                                              ; preds = %155, %155, %147, %157
  %159 = phi i32 [ %156, %157 ], [ 0, %147 ], [ 0, %155 ], [ 0, %155 ]
  switch i32 %159, label %165 [
    i32 -2, label %160
    i32 0, label %160
  ], !prof !16

160:                                              ; preds = %158, %158
  %161 = load i64, ptr %6, align 8, !noalias !17
  %162 = inttoptr i64 %161 to ptr
  %163 = inttoptr i64 %81 to ptr
  %164 = call i32 %162(ptr nonnull %9, ptr %163, ptr %14, ptr %17, ptr %93) #2, !noalias !17
  br label %165

165:                                              ; preds = %158, %160
  %166 = phi i32 [ %164, %160 ], [ 0, %158 ]
  %167 = phi i32 [ 0, %160 ], [ %159, %158 ]
  switch i32 %167, label %335 [
    i32 -2, label %261
    i32 0, label %261
  ], !prof !16

168:                                              ; preds = %261
  %169 = getelementptr i8, ptr %39, i64 32
  store i64 %122, ptr %169, align 8, !noalias !5
  %170 = sext i32 %166 to i64
  br label %335

171:                                              ; preds = %261, %263
  %172 = phi i64 [ %265, %263 ], [ 0, %261 ]
  %173 = phi i64 [ %264, %263 ], [ %247, %261 ]
  %174 = icmp sgt i64 %173, 0
  br i1 %174, label %263, label %175

175:                                              ; preds = %171
  %176 = call i64 @llvm.smax.i64(i64 %114, i64 0)
  br label %177

177:                                              ; preds = %175, %277
  %178 = phi i64 [ 0, %175 ], [ %279, %277 ]
  %179 = phi i64 [ %176, %175 ], [ %278, %277 ]
  %180 = icmp sgt i64 %179, 0
  br i1 %180, label %277, label %181

181:                                              ; preds = %177
  %182 = call i64 @llvm.smax.i64(i64 %116, i64 0)
  br label %183

183:                                              ; preds = %181, %292
  %184 = phi i64 [ 0, %181 ], [ %294, %292 ]
  %185 = phi i64 [ %182, %181 ], [ %293, %292 ]
  %186 = icmp sgt i64 %185, 0
  br i1 %186, label %292, label %138

187:                                              ; preds = %138
  %188 = call i64 @llvm.smax.i64(i64 %110, i64 0)
  br label %189

189:                                              ; preds = %193, %187
  %190 = phi i64 [ 0, %187 ], [ %315, %193 ]
  %191 = phi i64 [ %188, %187 ], [ %314, %193 ]
  %192 = icmp sgt i64 %191, 0
  br i1 %192, label %313, label %119

193:                                              ; preds = %313, %318
  %194 = phi i64 [ 0, %313 ], [ %320, %318 ]
  %195 = phi i64 [ %317, %313 ], [ %319, %318 ]
  %196 = icmp sgt i64 %195, 0
  br i1 %196, label %318, label %189

197:                                              ; preds = %119
  %198 = add nsw i64 %121, -1
  %199 = icmp slt i64 %122, 0
  %200 = select i1 %199, i64 %57, i64 0
  %201 = getelementptr double, ptr %58, i64 %122
  %202 = getelementptr double, ptr %201, i64 %200
  %203 = load double, ptr %202, align 8, !noalias !5
  %204 = select i1 %199, i64 %62, i64 0
  %205 = getelementptr double, ptr %63, i64 %122
  %206 = getelementptr double, ptr %205, i64 %204
  %207 = load double, ptr %206, align 8, !noalias !5
  %208 = call i64 @llvm.smax.i64(i64 %76, i64 0)
  br label %124

209:                                              ; preds = %124
  %210 = add nsw i64 %126, -1
  %211 = add i64 %125, 1
  %212 = icmp slt i64 %125, 0
  %213 = select i1 %212, i64 %76, i64 0
  %214 = getelementptr double, ptr %77, i64 %125
  %215 = getelementptr double, ptr %214, i64 %213
  store double %207, ptr %215, align 8, !noalias !5
  br label %124

216:                                              ; preds = %138
  %217 = add nsw i64 %140, -1
  %218 = icmp slt i64 %141, 0
  %219 = select i1 %218, i64 %43, i64 0
  %220 = getelementptr i64, ptr %44, i64 %141
  %221 = getelementptr i64, ptr %220, i64 %219
  %222 = load i64, ptr %221, align 8, !noalias !5
  %223 = shl i64 %222, 3
  %224 = add i64 %46, %223
  %225 = add i64 %48, %223
  %226 = icmp ugt i64 %139, -9223372036854775808
  %227 = select i1 %226, i64 %43, i64 0
  %228 = getelementptr i8, ptr %220, i64 8
  %229 = getelementptr i64, ptr %228, i64 %227
  %230 = load i64, ptr %229, align 8, !noalias !5
  %231 = sub nsw i64 %230, %222
  call fastcc void @pydy_combine(i64 %81, i64 %131, i64 %74, i64 %135, i64 %224, i64 %225, i64 %231, i64 %109) #2, !noalias !5
  %232 = add nsw i64 %110, %141
  %233 = icmp slt i64 %232, 0
  %234 = select i1 %233, i64 %43, i64 0
  %235 = getelementptr i64, ptr %44, i64 %232
  %236 = getelementptr i64, ptr %235, i64 %234
  %237 = load i64, ptr %236, align 8, !noalias !5
  %238 = shl i64 %237, 3
  %239 = add i64 %46, %238
  %240 = add i64 %48, %238
  %241 = icmp slt i64 %232, -1
  %242 = select i1 %241, i64 %43, i64 0
  %243 = getelementptr i8, ptr %235, i64 8
  %244 = getelementptr i64, ptr %243, i64 %242
  %245 = load i64, ptr %244, align 8, !noalias !5
  %246 = sub nsw i64 %245, %237
  call fastcc void @pydy_combine(i64 %85, i64 %79, i64 %74, i64 %69, i64 %239, i64 %240, i64 %246, i64 %109) #2, !noalias !5
  %247 = call i64 @llvm.smax.i64(i64 %107, i64 0)
  br label %143

248:                                              ; preds = %143
  %249 = add nsw i64 %145, -1
  %250 = add i64 %144, 1
  %251 = icmp slt i64 %144, 0
  %252 = select i1 %251, i64 %87, i64 0
  %253 = getelementptr double, ptr %88, i64 %144
  %254 = getelementptr double, ptr %253, i64 %252
  %255 = load double, ptr %254, align 8, !noalias !5
  %256 = add nsw i64 %112, %144
  %257 = icmp slt i64 %256, 0
  %258 = select i1 %257, i64 %13, i64 0
  %259 = getelementptr double, ptr %14, i64 %256
  %260 = getelementptr double, ptr %259, i64 %258
  store double %255, ptr %260, align 8, !noalias !5
  br label %143

261:                                              ; preds = %165, %165
  %262 = icmp eq i32 %166, 0
  br i1 %262, label %171, label %168

263:                                              ; preds = %171
  %264 = add nsw i64 %173, -1
  %265 = add i64 %172, 1
  %266 = icmp slt i64 %172, 0
  %267 = select i1 %266, i64 %92, i64 0
  %268 = getelementptr double, ptr %93, i64 %172
  %269 = getelementptr double, ptr %268, i64 %267
  %270 = load double, ptr %269, align 8, !noalias !5
  %271 = mul nsw i64 %141, %83
  %272 = add nsw i64 %271, %172
  %273 = icmp slt i64 %272, 0
  %274 = select i1 %273, i64 %71, i64 0
  %275 = getelementptr double, ptr %72, i64 %272
  %276 = getelementptr double, ptr %275, i64 %274
  store double %270, ptr %276, align 8, !noalias !5
  br label %171

277:                                              ; preds = %177
  %278 = add nsw i64 %179, -1
  %279 = add i64 %178, 1
  %280 = icmp slt i64 %178, 0
  %281 = select i1 %280, i64 %97, i64 0
  %282 = getelementptr double, ptr %98, i64 %178
  %283 = getelementptr double, ptr %282, i64 %281
  %284 = load double, ptr %283, align 8, !noalias !5
  %285 = add nsw i64 %107, %178
  %286 = icmp slt i64 %285, 0
  %287 = select i1 %286, i64 %92, i64 0
  %288 = getelementptr double, ptr %93, i64 %285
  %289 = getelementptr double, ptr %288, i64 %287
  %290 = load double, ptr %289, align 8, !noalias !5
  %291 = fadd double %284, %290
  store double %291, ptr %283, align 8, !noalias !5
  br label %177

292:                                              ; preds = %183
  %293 = add nsw i64 %185, -1
  %294 = add i64 %184, 1
  %295 = add nsw i64 %107, %114
  %296 = sub nsw i64 %295, %116
  %297 = add nsw i64 %296, %184
  %298 = icmp slt i64 %297, 0
  %299 = select i1 %298, i64 %92, i64 0
  %300 = getelementptr double, ptr %93, i64 %297
  %301 = getelementptr double, ptr %300, i64 %299
  %302 = load double, ptr %301, align 8, !noalias !5
  %303 = add nsw i64 %132, %141
  %304 = icmp slt i64 %303, 0
  %305 = select i1 %304, i64 %102, i64 0
  %306 = add i64 %303, %305
  %307 = icmp slt i64 %184, 0
  %308 = select i1 %307, i64 %104, i64 0
  %309 = mul i64 %306, %104
  %310 = getelementptr double, ptr %105, i64 %309
  %311 = getelementptr double, ptr %310, i64 %184
  %312 = getelementptr double, ptr %311, i64 %308
  store double %302, ptr %312, align 8, !noalias !5
  br label %183

313:                                              ; preds = %189
  %314 = add nsw i64 %191, -1
  %315 = add i64 %190, 1
  %316 = mul nsw i64 %190, %83
  %317 = call i64 @llvm.smax.i64(i64 %107, i64 0)
  br label %193

318:                                              ; preds = %193
  %319 = add nsw i64 %195, -1
  %320 = add i64 %194, 1
  %321 = mul nsw i64 %110, %83
  %322 = add nsw i64 %321, %194
  %323 = icmp slt i64 %322, 0
  %324 = select i1 %323, i64 %71, i64 0
  %325 = getelementptr double, ptr %72, i64 %322
  %326 = getelementptr double, ptr %325, i64 %324
  %327 = load double, ptr %326, align 8, !noalias !5
  %328 = add nsw i64 %316, %194
  %329 = icmp slt i64 %328, 0
  %330 = select i1 %329, i64 %71, i64 0
  %331 = getelementptr double, ptr %72, i64 %328
  %332 = getelementptr double, ptr %331, i64 %330
  %333 = load double, ptr %332, align 8, !noalias !5
  %334 = fadd double %327, %333
  store double %334, ptr %326, align 8, !noalias !5
  br label %193

335:                                              ; preds = %165, %119, %168
  %336 = phi i64 [ 0, %119 ], [ %170, %168 ], [ 0, %165 ]
  ret i64 %336
}



declare i64 @llvm.smax.i64(i64, i64) #1

attributes #0 = { noinline }
attributes #1 = { nounwind willreturn memory(none) }
attributes #2 = { nounwind }
attributes #3 = { nounwind willreturn }

!0 = !{!"branch_weights", i32 1, i32 99}
!1 = !{!2}
!2 = distinct !{!2, !3}
!3 = distinct !{!3}
!4 = !{!"branch_weights", i32 99, i32 1}
!5 = !{!6, !8}
!6 = distinct !{!6, !7}
!7 = distinct !{!7}
!8 = distinct !{!8, !7}
!9 = !{!10, !12, !13, !15}
!10 = distinct !{!10, !11}
!11 = distinct !{!11}
!12 = distinct !{!12, !11}
!13 = distinct !{!13, !14}
!14 = distinct !{!14}
!15 = distinct !{!15, !14}
!16 = !{!"branch_weights", i32 1, i32 49, i32 49}
!17 = !{!13, !15}
