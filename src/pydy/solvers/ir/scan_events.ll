; sources 566bde085b203d05c8a9cbd8bd71debf7c154d43e267ddfe2cb91c953b16b9d7
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

define internal fastcc void @pydy_nested(i64 %0, i64 %1, i64 %2, i64 %3, i64 %4, i64 %5, i64 %6) unnamed_addr #0 {
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

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #1

declare double @llvm.fabs.f64(double) #1

define internal fastcc i32 @_evaluate(ptr noalias %0, ptr noalias %1, ptr %2, ptr %3, ptr %4, ptr %5, i64 %6, ptr %7, i64 %8, i64 %9, ptr %10, i64 %11, ptr %12, i64 %13, i64 %14, i64 %15, ptr %16, i64 %17, ptr %18, i64 %19, ptr %20, ptr %21, ptr %22, ptr %23, ptr %24, double %25, double %26, double %27) unnamed_addr {
  %29 = alloca ptr, align 8
  %30 = alloca ptr, align 8
  %31 = ptrtoint ptr %24 to i64
  %32 = call i64 @llvm.smax.i64(i64 %17, i64 0)
  br label %33

33:                                               ; preds = %28, %57
  %34 = phi i64 [ 0, %28 ], [ %59, %57 ]
  %35 = phi i64 [ %32, %28 ], [ %58, %57 ]
  %36 = icmp sgt i64 %35, 0
  br i1 %36, label %57, label %37

37:                                               ; preds = %33
  %38 = ptrtoint ptr %16 to i64
  %39 = ptrtoint ptr %20 to i64
  %40 = getelementptr i8, ptr %2, i64 24
  %41 = load i64, ptr %40, align 8, !noalias !9
  %42 = ptrtoint ptr %18 to i64
  %43 = getelementptr i8, ptr %3, i64 16
  %44 = load i64, ptr %43, align 8, !noalias !9
  call fastcc void @pydy_nested(i64 %31, i64 %38, i64 %39, i64 %15, i64 %41, i64 %42, i64 %44), !noalias !9
  %45 = fmul double %27, %26
  %46 = fadd double %25, %45
  store ptr null, ptr %29, align 8, !noalias !13
  store ptr null, ptr %30, align 8, !noalias !13
  store double %46, ptr %4, align 8, !noalias !13
  %47 = icmp sgt i64 %8, 0
  br i1 %47, label %48, label %54

48:                                               ; preds = %37
  store ptr null, ptr %29, align 8, !noalias !13
  %49 = call fastcc i32 @_sample(ptr nonnull %29, ptr %5, i64 %6, ptr %7, i64 %8, i64 %9, ptr %10, i64 %11, ptr %12, i64 %13, i64 %14, double %46)
  switch i32 %49, label %50 [
    i32 -2, label %54
    i32 0, label %54
  ], !prof !17

50:                                               ; preds = %48
  %51 = icmp sgt i32 %49, 0
  %52 = load ptr, ptr %30, align 8, !noalias !13
  %53 = select i1 %51, ptr %52, ptr undef
  br label %54

54:                                               ; preds = %48, %48, %37, %50
  %55 = phi ptr [ undef, %37 ], [ undef, %48 ], [ undef, %48 ], [ %53, %50 ]
  %56 = phi i32 [ 0, %37 ], [ 0, %48 ], [ 0, %48 ], [ %49, %50 ]
  switch i32 %56, label %66 [
    i32 -2, label %67
    i32 0, label %67
  ], !prof !17

57:                                               ; preds = %33
  %58 = add nsw i64 %35, -1
  %59 = add i64 %34, 1
  %60 = icmp slt i64 %34, 0
  %61 = select i1 %60, i64 %19, i64 0
  %62 = getelementptr double, ptr %18, i64 %34
  %63 = getelementptr double, ptr %62, i64 %61
  store double %27, ptr %63, align 8, !noalias !9
  br label %33

64:                                               ; preds = %66, %67
  %65 = phi i32 [ %56, %66 ], [ 0, %67 ]
  ret i32 %65

66:                                               ; preds = %54
  store ptr %55, ptr %1, align 8
  br label %64

67:                                               ; preds = %54, %54
  %68 = load i64, ptr %21, align 8
  %69 = getelementptr i8, ptr %21, i64 8
  %70 = load i64, ptr %69, align 8
  %71 = ptrtoint ptr %23 to i64
  %72 = shl i64 %70, 3
  %73 = add i64 %72, %71
  %74 = inttoptr i64 %68 to ptr
  %75 = inttoptr i64 %73 to ptr
  %76 = call i32 %74(ptr nonnull %4, ptr %24, ptr %5, ptr %22, ptr %75)
  store i32 %76, ptr %0, align 4
  br label %64
}

define i64 @scan_events(i64 %0, double %1, double %2) local_unnamed_addr #2 {
  %4 = alloca i32, align 4
  %5 = alloca ptr, align 8
  %6 = alloca i32, align 4
  %7 = alloca ptr, align 8
  %8 = alloca i32, align 4
  %9 = alloca ptr, align 8
  %10 = alloca ptr, align 8
  %11 = alloca ptr, align 8
  %12 = alloca i32, align 4
  %13 = alloca ptr, align 8
  store i32 0, ptr %12, align 4, !noalias !18
  store ptr null, ptr %13, align 8, !noalias !18
  %14 = inttoptr i64 %0 to ptr
  %15 = load i64, ptr %14, align 8, !noalias !18
  %16 = inttoptr i64 %15 to ptr
  %17 = getelementptr i8, ptr %14, i64 144
  %18 = load i64, ptr %17, align 8, !noalias !18
  %19 = inttoptr i64 %18 to ptr
  %20 = getelementptr i8, ptr %14, i64 168
  %21 = load i64, ptr %20, align 8, !noalias !18
  %22 = inttoptr i64 %21 to ptr
  %23 = getelementptr i8, ptr %14, i64 192
  %24 = load i64, ptr %23, align 8, !noalias !18
  %25 = getelementptr i8, ptr %14, i64 200
  %26 = load i64, ptr %25, align 8, !noalias !18
  %27 = inttoptr i64 %24 to ptr
  %28 = getelementptr i8, ptr %14, i64 240
  %29 = load i64, ptr %28, align 8, !noalias !18
  %30 = getelementptr i8, ptr %14, i64 248
  %31 = load i64, ptr %30, align 8, !noalias !18
  %32 = getelementptr i8, ptr %14, i64 256
  %33 = load i64, ptr %32, align 8, !noalias !18
  %34 = inttoptr i64 %29 to ptr
  %35 = getelementptr i8, ptr %14, i64 264
  %36 = load i64, ptr %35, align 8, !noalias !18
  %37 = getelementptr i8, ptr %14, i64 272
  %38 = load i64, ptr %37, align 8, !noalias !18
  %39 = inttoptr i64 %36 to ptr
  %40 = getelementptr i8, ptr %14, i64 288
  %41 = load i64, ptr %40, align 8, !noalias !18
  %42 = getelementptr i8, ptr %14, i64 296
  %43 = load i64, ptr %42, align 8, !noalias !18
  %44 = getelementptr i8, ptr %14, i64 304
  %45 = load i64, ptr %44, align 8, !noalias !18
  %46 = inttoptr i64 %41 to ptr
  %47 = getelementptr i8, ptr %14, i64 312
  %48 = load i64, ptr %47, align 8, !noalias !18
  %49 = getelementptr i8, ptr %14, i64 320
  %50 = load i64, ptr %49, align 8, !noalias !18
  %51 = inttoptr i64 %48 to ptr
  %52 = getelementptr i8, ptr %14, i64 408
  %53 = load i64, ptr %52, align 8, !noalias !18
  %54 = getelementptr i8, ptr %14, i64 416
  %55 = load i64, ptr %54, align 8, !noalias !18
  %56 = inttoptr i64 %53 to ptr
  %57 = getelementptr i8, ptr %14, i64 504
  %58 = load i64, ptr %57, align 8, !noalias !18
  %59 = inttoptr i64 %58 to ptr
  %60 = getelementptr i8, ptr %14, i64 720
  %61 = load i64, ptr %60, align 8, !noalias !18
  %62 = inttoptr i64 %61 to ptr
  %63 = getelementptr i8, ptr %14, i64 744
  %64 = load i64, ptr %63, align 8, !noalias !18
  %65 = inttoptr i64 %64 to ptr
  %66 = getelementptr i8, ptr %14, i64 768
  %67 = load i64, ptr %66, align 8, !noalias !18
  %68 = getelementptr i8, ptr %14, i64 776
  %69 = load i64, ptr %68, align 8, !noalias !18
  %70 = inttoptr i64 %67 to ptr
  %71 = getelementptr i8, ptr %14, i64 792
  %72 = load i64, ptr %71, align 8, !noalias !18
  %73 = getelementptr i8, ptr %14, i64 800
  %74 = load i64, ptr %73, align 8, !noalias !18
  %75 = inttoptr i64 %72 to ptr
  %76 = getelementptr i8, ptr %14, i64 816
  %77 = load i64, ptr %76, align 8, !noalias !18
  %78 = getelementptr i8, ptr %14, i64 824
  %79 = load i64, ptr %78, align 8, !noalias !18
  %80 = inttoptr i64 %77 to ptr
  %81 = getelementptr i8, ptr %14, i64 840
  %82 = load i64, ptr %81, align 8, !noalias !18
  %83 = getelementptr i8, ptr %14, i64 848
  %84 = load i64, ptr %83, align 8, !noalias !18
  %85 = inttoptr i64 %82 to ptr
  %86 = getelementptr i8, ptr %14, i64 864
  %87 = load i64, ptr %86, align 8, !noalias !18
  %88 = getelementptr i8, ptr %14, i64 872
  %89 = load i64, ptr %88, align 8, !noalias !18
  %90 = inttoptr i64 %87 to ptr
  %91 = getelementptr i8, ptr %14, i64 888
  %92 = load i64, ptr %91, align 8, !noalias !18
  %93 = getelementptr i8, ptr %14, i64 896
  %94 = load i64, ptr %93, align 8, !noalias !18
  %95 = inttoptr i64 %92 to ptr
  %96 = getelementptr i8, ptr %14, i64 912
  %97 = load i64, ptr %96, align 8, !noalias !18
  %98 = getelementptr i8, ptr %14, i64 920
  %99 = load i64, ptr %98, align 8, !noalias !18
  %100 = inttoptr i64 %97 to ptr
  %101 = getelementptr i8, ptr %14, i64 936
  %102 = load i64, ptr %101, align 8, !noalias !18
  %103 = getelementptr i8, ptr %14, i64 944
  %104 = load i64, ptr %103, align 8, !noalias !18
  %105 = inttoptr i64 %102 to ptr
  %106 = getelementptr i8, ptr %14, i64 960
  %107 = load i64, ptr %106, align 8, !noalias !18
  %108 = getelementptr i8, ptr %14, i64 968
  %109 = load i64, ptr %108, align 8, !noalias !18
  %110 = getelementptr i8, ptr %14, i64 976
  %111 = load i64, ptr %110, align 8, !noalias !18
  %112 = inttoptr i64 %107 to ptr
  %113 = getelementptr i8, ptr %14, i64 576
  %114 = load i64, ptr %113, align 8, !noalias !18
  %115 = inttoptr i64 %114 to ptr
  %116 = getelementptr i8, ptr %14, i64 600
  %117 = load i64, ptr %116, align 8, !noalias !18
  %118 = inttoptr i64 %117 to ptr
  %119 = getelementptr i8, ptr %62, i64 8
  %120 = load i64, ptr %119, align 8, !noalias !18
  %121 = getelementptr i8, ptr %19, i64 8
  %122 = load i64, ptr %121, align 8, !noalias !18
  br label %123

123:                                              ; preds = %333, %3
  %124 = phi i64 [ 1, %3 ], [ %131, %333 ]
  %125 = phi i64 [ 4, %3 ], [ %133, %333 ]
  %126 = phi double [ 0.000000e+00, %3 ], [ %134, %333 ]
  %127 = icmp sgt i64 %125, 0
  %128 = sitofp i64 %124 to double
  %129 = fmul double %128, 2.500000e-01
  %130 = zext i1 %127 to i64
  %131 = add i64 %124, %130
  %132 = sext i1 %127 to i64
  %133 = add nsw i64 %125, %132
  %134 = select i1 %127, double %129, double 0.000000e+00
  br i1 %127, label %135, label %348

135:                                              ; preds = %123
  %136 = call i64 @llvm.smax.i64(i64 %55, i64 0)
  br label %137

137:                                              ; preds = %154, %135
  %138 = phi i64 [ 0, %135 ], [ %156, %154 ]
  %139 = phi i64 [ %136, %135 ], [ %155, %154 ]
  %140 = icmp sgt i64 %139, 0
  br i1 %140, label %154, label %141

141:                                              ; preds = %137
  %142 = getelementptr i8, ptr %16, i64 24
  %143 = load i64, ptr %142, align 8, !noalias !22
  %144 = getelementptr i8, ptr %19, i64 16
  %145 = load i64, ptr %144, align 8, !noalias !22
  call fastcc void @pydy_nested(i64 %92, i64 %48, i64 %58, i64 %50, i64 %143, i64 %53, i64 %145) #2, !noalias !22
  %146 = fmul double %134, %2
  %147 = fadd double %1, %146
  store ptr null, ptr %10, align 8, !noalias !29
  store ptr null, ptr %11, align 8, !noalias !29
  store double %147, ptr %22, align 8, !noalias !29
  %148 = icmp sgt i64 %31, 0
  br i1 %148, label %149, label %152

149:                                              ; preds = %141
  store ptr null, ptr %10, align 8, !noalias !29
  %150 = call fastcc i32 @_sample(ptr nonnull %10, ptr %27, i64 %26, ptr %34, i64 %31, i64 %33, ptr %39, i64 %38, ptr %46, i64 %43, i64 %45, double %147) #2
  switch i32 %150, label %151 [
    i32 -2, label %152
    i32 0, label %152
  ], !prof !17

151:                                              ; preds = %149
  br label %152

152:                                              ; preds = %149, %149, %141, %151
  %153 = phi i32 [ %150, %151 ], [ 0, %141 ], [ 0, %149 ], [ 0, %149 ]
  switch i32 %153, label %165 [
    i32 -2, label %161
    i32 0, label %161
  ], !prof !17

154:                                              ; preds = %137
  %155 = add nsw i64 %139, -1
  %156 = add i64 %138, 1
  %157 = icmp slt i64 %138, 0
  %158 = select i1 %157, i64 %55, i64 0
  %159 = getelementptr double, ptr %56, i64 %138
  %160 = getelementptr double, ptr %159, i64 %158
  store double %134, ptr %160, align 8, !noalias !22
  br label %137

161:                                              ; preds = %152, %152
  %162 = load i64, ptr %62, align 8, !noalias !33
  %163 = inttoptr i64 %162 to ptr
  %164 = call i32 %163(ptr nonnull %22, ptr %95, ptr %27, ptr %65, ptr %90) #2, !noalias !33
  br label %165

165:                                              ; preds = %152, %161
  %166 = phi i32 [ 0, %161 ], [ %153, %152 ]
  switch i32 %166, label %351 [
    i32 -2, label %350
    i32 0, label %350
  ], !prof !17

167:                                              ; preds = %301, %350
  %168 = phi double [ %126, %350 ], [ %173, %301 ]
  %169 = call i64 @llvm.smax.i64(i64 %120, i64 0)
  br label %170

170:                                              ; preds = %167, %248
  %171 = phi i64 [ 0, %167 ], [ %354, %248 ]
  %172 = phi i64 [ %169, %167 ], [ %353, %248 ]
  %173 = phi double [ 2.000000e+00, %167 ], [ %249, %248 ]
  %174 = icmp sgt i64 %172, 0
  br i1 %174, label %352, label %250

175:                                              ; preds = %352, %376
  store i32 0, ptr %4, align 4, !noalias !34
  store ptr null, ptr %5, align 8, !noalias !34
  store i32 0, ptr %6, align 4, !noalias !34
  store ptr null, ptr %7, align 8, !noalias !34
  store i32 0, ptr %8, align 4, !noalias !34
  store ptr null, ptr %9, align 8, !noalias !34
  %176 = load i64, ptr %119, align 8, !noalias !34
  %177 = call double @llvm.fabs.f64(double %1)
  %178 = fadd double %1, %2
  %179 = call double @llvm.fabs.f64(double %178)
  %180 = fcmp ogt double %179, %177
  %181 = select i1 %180, double %179, double %177
  %182 = fmul double %181, 0x3CB0000000000000
  %183 = fdiv double %182, %2
  store i32 0, ptr %4, align 4, !noalias !34
  %184 = call fastcc i32 @_evaluate(ptr nonnull %4, ptr nonnull %5, ptr %16, ptr %19, ptr nonnull %22, ptr %27, i64 %26, ptr %34, i64 %31, i64 %33, ptr %39, i64 %38, ptr %46, i64 %43, i64 %45, i64 %50, ptr %51, i64 %55, ptr %56, i64 %55, ptr %59, ptr %62, ptr %65, ptr %90, ptr %95, double %1, double %2, double %168) #2, !noalias !34
  switch i32 %184, label %245 [
    i32 -2, label %223
    i32 0, label %223
  ], !prof !17

185:                                              ; preds = %233, %223
  %186 = phi double [ %134, %223 ], [ %189, %233 ]
  %187 = fsub double %186, %168
  %188 = fmul double %187, 5.000000e-01
  %189 = fadd double %168, %188
  %190 = fsub double %189, %168
  %191 = fcmp olt double %190, %183
  br i1 %191, label %245, label %192

192:                                              ; preds = %185
  store i32 0, ptr %6, align 4, !noalias !34
  %193 = call fastcc i32 @_evaluate(ptr nonnull %6, ptr nonnull %7, ptr %16, ptr %19, ptr nonnull %22, ptr %27, i64 %26, ptr %34, i64 %31, i64 %33, ptr %39, i64 %38, ptr %46, i64 %43, i64 %45, i64 %50, ptr %51, i64 %55, ptr %56, i64 %55, ptr %59, ptr %62, ptr %65, ptr %90, ptr %95, double %1, double %2, double %189) #2, !noalias !34
  switch i32 %193, label %245 [
    i32 -2, label %233
    i32 0, label %233
  ], !prof !17

194:                                              ; preds = %233, %223
  %195 = phi double [ %168, %223 ], [ %189, %233 ]
  %196 = phi double [ %134, %223 ], [ %186, %233 ]
  %197 = fsub double %196, %195
  %198 = fcmp ogt double %197, %183
  br i1 %198, label %199, label %245

199:                                              ; preds = %237, %194
  %200 = phi double [ %241, %237 ], [ %196, %194 ]
  %201 = phi double [ %242, %237 ], [ %195, %194 ]
  %202 = fsub double %200, %201
  %203 = fmul double %202, 5.000000e-01
  %204 = fadd double %201, %203
  br label %205

205:                                              ; preds = %209, %199
  %206 = phi i64 [ 0, %199 ], [ %211, %209 ]
  %207 = icmp slt i64 %206, 2
  br i1 %207, label %208, label %214

208:                                              ; preds = %205
  switch i64 %206, label %214 [
    i64 0, label %209
    i64 -2, label %209
    i64 1, label %213
    i64 -1, label %213
  ]

209:                                              ; preds = %213, %208, %208
  %210 = phi double [ %200, %213 ], [ %201, %208 ], [ %201, %208 ]
  %211 = add i64 %206, 1
  %212 = fcmp oeq double %210, %204
  br i1 %212, label %214, label %205

213:                                              ; preds = %208, %208
  br label %209

214:                                              ; preds = %208, %205, %209
  %215 = phi i1 [ false, %205 ], [ true, %209 ], [ false, %208 ]
  %216 = phi i1 [ false, %205 ], [ false, %209 ], [ true, %208 ]
  %217 = phi i32 [ 0, %205 ], [ 0, %209 ], [ 1, %208 ]
  %218 = or i1 %216, %215
  %219 = select i1 %216, double 0.000000e+00, double %200, !prof !38
  %220 = select i1 %216, i32 %217, i32 0, !prof !38
  br i1 %218, label %245, label %221, !prof !39

221:                                              ; preds = %214
  store i32 0, ptr %8, align 4, !noalias !34
  %222 = call fastcc i32 @_evaluate(ptr nonnull %8, ptr nonnull %9, ptr %16, ptr %19, ptr nonnull %22, ptr %27, i64 %26, ptr %34, i64 %31, i64 %33, ptr %39, i64 %38, ptr %46, i64 %43, i64 %45, i64 %50, ptr %51, i64 %55, ptr %56, i64 %55, ptr %59, ptr %62, ptr %65, ptr %90, ptr %95, double %1, double %2, double %204) #2, !noalias !34
  switch i32 %222, label %245 [
    i32 -2, label %237
    i32 0, label %237
  ], !prof !17

223:                                              ; preds = %175, %175
  %224 = add nsw i64 %176, %171
  %225 = icmp slt i64 %224, 0
  %226 = select i1 %225, i64 %89, i64 0
  %227 = getelementptr double, ptr %90, i64 %224
  %228 = getelementptr double, ptr %227, i64 %226
  %229 = load double, ptr %228, align 8, !noalias !34
  %230 = sitofp i64 %362 to double
  %231 = fmul double %229, %230
  %232 = fcmp ugt double %231, 0.000000e+00
  br i1 %232, label %194, label %185

233:                                              ; preds = %192, %192
  %234 = load double, ptr %228, align 8, !noalias !34
  %235 = fmul double %234, %230
  %236 = fcmp ogt double %235, 0.000000e+00
  br i1 %236, label %194, label %185

237:                                              ; preds = %221, %221
  %238 = load double, ptr %228, align 8, !noalias !34
  %239 = fmul double %238, %230
  %240 = fcmp ogt double %239, 0.000000e+00
  %241 = select i1 %240, double %200, double %204
  %242 = select i1 %240, double %204, double %201
  %243 = fsub double %241, %242
  %244 = fcmp ogt double %243, %183
  br i1 %244, label %199, label %245

245:                                              ; preds = %221, %214, %192, %175, %194, %237, %185
  %246 = phi double [ %219, %214 ], [ 0.000000e+00, %192 ], [ %241, %237 ], [ %168, %185 ], [ 0.000000e+00, %175 ], [ %196, %194 ], [ 0.000000e+00, %221 ]
  %247 = phi i32 [ %220, %214 ], [ %193, %192 ], [ 0, %237 ], [ 0, %185 ], [ %184, %175 ], [ 0, %194 ], [ %222, %221 ]
  switch i32 %247, label %387 [
    i32 -2, label %382
    i32 0, label %382
  ], !prof !17

248:                                              ; preds = %382, %376
  %249 = phi double [ %173, %376 ], [ %386, %382 ]
  br label %170

250:                                              ; preds = %170
  %251 = fcmp ogt double %173, 1.000000e+00
  br i1 %251, label %333, label %252

252:                                              ; preds = %250
  store i32 0, ptr %12, align 4, !noalias !18
  %253 = call fastcc i32 @_evaluate(ptr nonnull %12, ptr nonnull %13, ptr %16, ptr %19, ptr nonnull %22, ptr %27, i64 %26, ptr %34, i64 %31, i64 %33, ptr %39, i64 %38, ptr %46, i64 %43, i64 %45, i64 %50, ptr %51, i64 %55, ptr %56, i64 %55, ptr %59, ptr %62, ptr %65, ptr %90, ptr %95, double %1, double %2, double %173) #2
  switch i32 %253, label %389 [
    i32 -2, label %388
    i32 0, label %388
  ], !prof !17

254:                                              ; preds = %388, %296
  %255 = phi i64 [ 0, %388 ], [ %392, %296 ]
  %256 = phi i64 [ %169, %388 ], [ %391, %296 ]
  %257 = phi i1 [ false, %388 ], [ %297, %296 ]
  %258 = icmp sgt i64 %256, 0
  br i1 %258, label %390, label %298

259:                                              ; preds = %413
  %260 = select i1 %399, i64 %89, i64 0
  %261 = getelementptr double, ptr %90, i64 %255
  %262 = getelementptr double, ptr %261, i64 %260
  %263 = load double, ptr %262, align 8, !noalias !18
  %264 = fcmp ogt double %263, 0.000000e+00
  %265 = select i1 %408, i1 %264, i1 false
  %266 = select i1 %265, i1 %411, i1 false
  br i1 %266, label %273, label %267

267:                                              ; preds = %259
  %268 = icmp slt i64 %403, 1
  %269 = fcmp uge double %263, 0.000000e+00
  %270 = select i1 %268, i1 true, i1 %269
  %271 = icmp sgt i64 %407, 0
  %272 = select i1 %270, i1 true, i1 %271
  br i1 %272, label %281, label %273

273:                                              ; preds = %259, %267
  %274 = fcmp oeq double %398, 0.000000e+00
  br i1 %274, label %281, label %275

275:                                              ; preds = %273
  %276 = select i1 %399, i64 %84, i64 0
  %277 = getelementptr i64, ptr %85, i64 %255
  %278 = getelementptr i64, ptr %277, i64 %276
  %279 = load i64, ptr %278, align 8, !noalias !18
  %280 = icmp eq i64 %279, 1
  br label %281

281:                                              ; preds = %390, %273, %275, %267, %413
  %282 = phi i1 [ true, %413 ], [ false, %267 ], [ true, %273 ], [ %280, %275 ], [ true, %390 ]
  %283 = zext i1 %282 to i64
  %284 = select i1 %399, i64 %84, i64 0
  %285 = getelementptr i64, ptr %85, i64 %255
  %286 = getelementptr i64, ptr %285, i64 %284
  store i64 %283, ptr %286, align 8, !noalias !18
  %287 = xor i1 %282, true
  %288 = select i1 %257, i1 true, i1 %287
  %289 = select i1 %257, i1 true, i1 %282
  br i1 %288, label %296, label %290

290:                                              ; preds = %281
  %291 = select i1 %399, i64 %74, i64 0
  %292 = getelementptr i64, ptr %75, i64 %255
  %293 = getelementptr i64, ptr %292, i64 %291
  %294 = load i64, ptr %293, align 8, !noalias !18
  %295 = icmp eq i64 %294, 1
  br label %296

296:                                              ; preds = %281, %290
  %297 = phi i1 [ %289, %281 ], [ %295, %290 ]
  br label %254

298:                                              ; preds = %254
  br i1 %257, label %299, label %301

299:                                              ; preds = %298
  %300 = getelementptr i8, ptr %115, i64 48
  store double %173, ptr %300, align 8, !noalias !18
  br label %452

301:                                              ; preds = %298, %419, %326
  %302 = phi i64 [ %421, %326 ], [ %421, %419 ], [ 0, %298 ]
  %303 = phi i64 [ %420, %326 ], [ %420, %419 ], [ %169, %298 ]
  %304 = icmp sgt i64 %303, 0
  br i1 %304, label %419, label %167

305:                                              ; preds = %419
  %306 = getelementptr i8, ptr %118, i64 80
  %307 = load i64, ptr %306, align 8, !noalias !18
  %308 = icmp eq i64 %307, %99
  br i1 %308, label %309, label %311

309:                                              ; preds = %305
  %310 = getelementptr i8, ptr %115, i64 48
  store double %173, ptr %310, align 8, !noalias !18
  br label %452

311:                                              ; preds = %305
  %312 = fmul double %173, %2
  %313 = fadd double %1, %312
  %314 = icmp slt i64 %307, 0
  %315 = select i1 %314, i64 %99, i64 0
  %316 = getelementptr double, ptr %100, i64 %307
  %317 = getelementptr double, ptr %316, i64 %315
  store double %313, ptr %317, align 8, !noalias !18
  %318 = select i1 %314, i64 %104, i64 0
  %319 = getelementptr i64, ptr %105, i64 %307
  %320 = getelementptr i64, ptr %319, i64 %318
  store i64 %302, ptr %320, align 8, !noalias !18
  %321 = call i64 @llvm.smax.i64(i64 %122, i64 0)
  br label %322

322:                                              ; preds = %311, %428
  %323 = phi i64 [ 0, %311 ], [ %430, %428 ]
  %324 = phi i64 [ %321, %311 ], [ %429, %428 ]
  %325 = icmp sgt i64 %324, 0
  br i1 %325, label %428, label %326

326:                                              ; preds = %322
  %327 = add nsw i64 %307, 1
  store i64 %327, ptr %306, align 8, !noalias !18
  %328 = select i1 %422, i64 %79, i64 0
  %329 = getelementptr i64, ptr %80, i64 %302
  %330 = getelementptr i64, ptr %329, i64 %328
  %331 = load i64, ptr %330, align 8, !noalias !18
  %332 = sub i64 0, %331
  store i64 %332, ptr %330, align 8, !noalias !18
  br label %301

333:                                              ; preds = %250, %347, %337
  %334 = phi i64 [ %445, %347 ], [ %445, %337 ], [ 0, %250 ]
  %335 = phi i64 [ %444, %347 ], [ %444, %337 ], [ %169, %250 ]
  %336 = icmp sgt i64 %335, 0
  br i1 %336, label %443, label %123

337:                                              ; preds = %443
  %338 = select i1 %446, i64 %79, i64 0
  %339 = getelementptr i64, ptr %80, i64 %334
  %340 = getelementptr i64, ptr %339, i64 %338
  store i64 1, ptr %340, align 8, !noalias !18
  br label %333

341:                                              ; preds = %443
  %342 = fcmp olt double %450, 0.000000e+00
  br i1 %342, label %343, label %347

343:                                              ; preds = %341
  %344 = select i1 %446, i64 %79, i64 0
  %345 = getelementptr i64, ptr %80, i64 %334
  %346 = getelementptr i64, ptr %345, i64 %344
  store i64 -1, ptr %346, align 8, !noalias !18
  br label %347

347:                                              ; preds = %343, %341
  br label %333

348:                                              ; preds = %123
  %349 = getelementptr i8, ptr %115, i64 48
  store double 1.000000e+00, ptr %349, align 8, !noalias !18
  br label %452

350:                                              ; preds = %165, %165
  br label %167

351:                                              ; preds = %165
  br label %452

352:                                              ; preds = %170
  %353 = add nsw i64 %172, -1
  %354 = add i64 %171, 1
  %355 = icmp slt i64 %171, 0
  %356 = select i1 %355, i64 %84, i64 0
  %357 = getelementptr i64, ptr %85, i64 %171
  %358 = getelementptr i64, ptr %357, i64 %356
  store i64 0, ptr %358, align 8, !noalias !18
  %359 = select i1 %355, i64 %79, i64 0
  %360 = getelementptr i64, ptr %80, i64 %171
  %361 = getelementptr i64, ptr %360, i64 %359
  %362 = load i64, ptr %361, align 8, !noalias !18
  %363 = select i1 %355, i64 %89, i64 0
  %364 = getelementptr double, ptr %90, i64 %171
  %365 = getelementptr double, ptr %364, i64 %363
  %366 = load double, ptr %365, align 8, !noalias !18
  %367 = select i1 %355, i64 %69, i64 0
  %368 = getelementptr i64, ptr %70, i64 %171
  %369 = getelementptr i64, ptr %368, i64 %367
  %370 = load i64, ptr %369, align 8, !noalias !18
  %371 = icmp slt i64 %362, 0
  %372 = fcmp ogt double %366, 0.000000e+00
  %373 = select i1 %371, i1 %372, i1 false
  %374 = icmp sgt i64 %370, -1
  %375 = select i1 %373, i1 %374, i1 false
  br i1 %375, label %175, label %376

376:                                              ; preds = %352
  %377 = icmp slt i64 %362, 1
  %378 = fcmp uge double %366, 0.000000e+00
  %379 = select i1 %377, i1 true, i1 %378
  %380 = icmp sgt i64 %370, 0
  %381 = select i1 %379, i1 true, i1 %380
  br i1 %381, label %248, label %175

382:                                              ; preds = %245, %245
  %383 = fcmp ole double %246, %168
  %384 = zext i1 %383 to i64
  store i64 %384, ptr %358, align 8, !noalias !18
  %385 = fcmp olt double %246, %173
  %386 = select i1 %385, double %246, double %173
  br label %248

387:                                              ; preds = %245
  br label %452

388:                                              ; preds = %252, %252
  br label %254

389:                                              ; preds = %252
  br label %452

390:                                              ; preds = %254
  %391 = add nsw i64 %256, -1
  %392 = add i64 %255, 1
  %393 = add nsw i64 %120, %255
  %394 = icmp slt i64 %393, 0
  %395 = select i1 %394, i64 %89, i64 0
  %396 = getelementptr double, ptr %90, i64 %393
  %397 = getelementptr double, ptr %396, i64 %395
  %398 = load double, ptr %397, align 8, !noalias !18
  %399 = icmp slt i64 %255, 0
  %400 = select i1 %399, i64 %79, i64 0
  %401 = getelementptr i64, ptr %80, i64 %255
  %402 = getelementptr i64, ptr %401, i64 %400
  %403 = load i64, ptr %402, align 8, !noalias !18
  %404 = select i1 %399, i64 %69, i64 0
  %405 = getelementptr i64, ptr %70, i64 %255
  %406 = getelementptr i64, ptr %405, i64 %404
  %407 = load i64, ptr %406, align 8, !noalias !18
  %408 = icmp slt i64 %403, 0
  %409 = fcmp ogt double %398, 0.000000e+00
  %410 = select i1 %408, i1 %409, i1 false
  %411 = icmp sgt i64 %407, -1
  %412 = select i1 %410, i1 %411, i1 false
  br i1 %412, label %281, label %413

413:                                              ; preds = %390
  %414 = icmp slt i64 %403, 1
  %415 = fcmp uge double %398, 0.000000e+00
  %416 = select i1 %414, i1 true, i1 %415
  %417 = icmp sgt i64 %407, 0
  %418 = select i1 %416, i1 true, i1 %417
  br i1 %418, label %259, label %281

419:                                              ; preds = %301
  %420 = add nsw i64 %303, -1
  %421 = add i64 %302, 1
  %422 = icmp slt i64 %302, 0
  %423 = select i1 %422, i64 %84, i64 0
  %424 = getelementptr i64, ptr %85, i64 %302
  %425 = getelementptr i64, ptr %424, i64 %423
  %426 = load i64, ptr %425, align 8, !noalias !18
  %427 = icmp eq i64 %426, 0
  br i1 %427, label %301, label %305

428:                                              ; preds = %322
  %429 = add nsw i64 %324, -1
  %430 = add i64 %323, 1
  %431 = icmp slt i64 %323, 0
  %432 = select i1 %431, i64 %94, i64 0
  %433 = getelementptr double, ptr %95, i64 %323
  %434 = getelementptr double, ptr %433, i64 %432
  %435 = load double, ptr %434, align 8, !noalias !18
  %436 = select i1 %314, i64 %109, i64 0
  %437 = add i64 %307, %436
  %438 = select i1 %431, i64 %111, i64 0
  %439 = mul i64 %437, %111
  %440 = getelementptr double, ptr %112, i64 %439
  %441 = getelementptr double, ptr %440, i64 %323
  %442 = getelementptr double, ptr %441, i64 %438
  store double %435, ptr %442, align 8, !noalias !18
  br label %322

443:                                              ; preds = %333
  %444 = add nsw i64 %335, -1
  %445 = add i64 %334, 1
  %446 = icmp slt i64 %334, 0
  %447 = select i1 %446, i64 %89, i64 0
  %448 = getelementptr double, ptr %90, i64 %334
  %449 = getelementptr double, ptr %448, i64 %447
  %450 = load double, ptr %449, align 8, !noalias !18
  %451 = fcmp ogt double %450, 0.000000e+00
  br i1 %451, label %337, label %341

452:                                              ; preds = %389, %387, %351, %348, %309, %299
  %453 = phi i64 [ 0, %348 ], [ 0, %351 ], [ -2, %299 ], [ 0, %389 ], [ 0, %387 ], [ -3, %309 ]
  ret i64 %453
}



declare i64 @llvm.smax.i64(i64, i64) #1

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
!13 = !{!14, !16}
!14 = distinct !{!14, !15}
!15 = distinct !{!15}
!16 = distinct !{!16, !15}
!17 = !{!"branch_weights", i32 1, i32 49, i32 49}
!18 = !{!19, !21}
!19 = distinct !{!19, !20}
!20 = distinct !{!20}
!21 = distinct !{!21, !20}
!22 = !{!23, !25, !26, !28}
!23 = distinct !{!23, !24}
!24 = distinct !{!24}
!25 = distinct !{!25, !24}
!26 = distinct !{!26, !27}
!27 = distinct !{!27}
!28 = distinct !{!28, !27}
!29 = !{!30, !32, !26, !28}
!30 = distinct !{!30, !31}
!31 = distinct !{!31}
!32 = distinct !{!32, !31}
!33 = !{!26, !28}
!34 = !{!35, !37}
!35 = distinct !{!35, !36}
!36 = distinct !{!36}
!37 = distinct !{!37, !36}
!38 = !{!"branch_weights", i32 1, i32 49}
!39 = !{!"branch_weights", i32 51, i32 49}
