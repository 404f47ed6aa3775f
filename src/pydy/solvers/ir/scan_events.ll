; sources 9f0daafbc4cd6d1332535161f7d0d5fbca9242b5d2e29df9e89effcad7ff5fae
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
  %123 = getelementptr i8, ptr %118, i64 80
  %124 = load i64, ptr %123, align 8, !noalias !18
  br label %125

125:                                              ; preds = %340, %3
  %126 = phi i64 [ 1, %3 ], [ %133, %340 ]
  %127 = phi i64 [ 4, %3 ], [ %135, %340 ]
  %128 = phi double [ 0.000000e+00, %3 ], [ %136, %340 ]
  %129 = icmp sgt i64 %127, 0
  %130 = sitofp i64 %126 to double
  %131 = fmul double %130, 2.500000e-01
  %132 = zext i1 %129 to i64
  %133 = add i64 %126, %132
  %134 = sext i1 %129 to i64
  %135 = add nsw i64 %127, %134
  %136 = select i1 %129, double %131, double 0.000000e+00
  br i1 %129, label %137, label %355

137:                                              ; preds = %125
  %138 = call i64 @llvm.smax.i64(i64 %55, i64 0)
  br label %139

139:                                              ; preds = %156, %137
  %140 = phi i64 [ 0, %137 ], [ %158, %156 ]
  %141 = phi i64 [ %138, %137 ], [ %157, %156 ]
  %142 = icmp sgt i64 %141, 0
  br i1 %142, label %156, label %143

143:                                              ; preds = %139
  %144 = getelementptr i8, ptr %16, i64 24
  %145 = load i64, ptr %144, align 8, !noalias !22
  %146 = getelementptr i8, ptr %19, i64 16
  %147 = load i64, ptr %146, align 8, !noalias !22
  call fastcc void @pydy_nested(i64 %92, i64 %48, i64 %58, i64 %50, i64 %145, i64 %53, i64 %147) #2, !noalias !22
  %148 = fmul double %136, %2
  %149 = fadd double %1, %148
  store ptr null, ptr %10, align 8, !noalias !29
  store ptr null, ptr %11, align 8, !noalias !29
  store double %149, ptr %22, align 8, !noalias !29
  %150 = icmp sgt i64 %31, 0
  br i1 %150, label %151, label %154

151:                                              ; preds = %143
  store ptr null, ptr %10, align 8, !noalias !29
  %152 = call fastcc i32 @_sample(ptr nonnull %10, ptr %27, i64 %26, ptr %34, i64 %31, i64 %33, ptr %39, i64 %38, ptr %46, i64 %43, i64 %45, double %149) #2
  switch i32 %152, label %153 [
    i32 -2, label %154
    i32 0, label %154
  ], !prof !17

153:                                              ; preds = %151
  br label %154

154:                                              ; preds = %151, %151, %143, %153
  %155 = phi i32 [ %152, %153 ], [ 0, %143 ], [ 0, %151 ], [ 0, %151 ]
  switch i32 %155, label %168 [
    i32 -2, label %163
    i32 0, label %163
  ], !prof !17

156:                                              ; preds = %139
  %157 = add nsw i64 %141, -1
  %158 = add i64 %140, 1
  %159 = icmp slt i64 %140, 0
  %160 = select i1 %159, i64 %55, i64 0
  %161 = getelementptr double, ptr %56, i64 %140
  %162 = getelementptr double, ptr %161, i64 %160
  store double %136, ptr %162, align 8, !noalias !22
  br label %139

163:                                              ; preds = %154, %154
  %164 = load i64, ptr %62, align 8, !noalias !33
  %165 = inttoptr i64 %164 to ptr
  %166 = call i32 %165(ptr nonnull %22, ptr %95, ptr %27, ptr %65, ptr %90) #2, !noalias !33
  %167 = icmp slt i32 %166, 0
  br label %168

168:                                              ; preds = %154, %163
  %169 = phi i1 [ %167, %163 ], [ false, %154 ]
  %170 = phi i32 [ 0, %163 ], [ %155, %154 ]
  switch i32 %170, label %358 [
    i32 -2, label %357
    i32 0, label %357
  ], !prof !17

171:                                              ; preds = %357
  store i64 %124, ptr %123, align 8, !noalias !18
  %172 = getelementptr i8, ptr %115, i64 48
  store double 1.000000e+00, ptr %172, align 8, !noalias !18
  br label %461

173:                                              ; preds = %309, %357
  %174 = phi double [ %128, %357 ], [ %179, %309 ]
  %175 = call i64 @llvm.smax.i64(i64 %120, i64 0)
  br label %176

176:                                              ; preds = %173, %254
  %177 = phi i64 [ 0, %173 ], [ %361, %254 ]
  %178 = phi i64 [ %175, %173 ], [ %360, %254 ]
  %179 = phi double [ 2.000000e+00, %173 ], [ %255, %254 ]
  %180 = icmp sgt i64 %178, 0
  br i1 %180, label %359, label %256

181:                                              ; preds = %359, %383
  store i32 0, ptr %4, align 4, !noalias !34
  store ptr null, ptr %5, align 8, !noalias !34
  store i32 0, ptr %6, align 4, !noalias !34
  store ptr null, ptr %7, align 8, !noalias !34
  store i32 0, ptr %8, align 4, !noalias !34
  store ptr null, ptr %9, align 8, !noalias !34
  %182 = load i64, ptr %119, align 8, !noalias !34
  %183 = call double @llvm.fabs.f64(double %1)
  %184 = fadd double %1, %2
  %185 = call double @llvm.fabs.f64(double %184)
  %186 = fcmp ogt double %185, %183
  %187 = select i1 %186, double %185, double %183
  %188 = fmul double %187, 0x3CB0000000000000
  %189 = fdiv double %188, %2
  store i32 0, ptr %4, align 4, !noalias !34
  %190 = call fastcc i32 @_evaluate(ptr nonnull %4, ptr nonnull %5, ptr %16, ptr %19, ptr nonnull %22, ptr %27, i64 %26, ptr %34, i64 %31, i64 %33, ptr %39, i64 %38, ptr %46, i64 %43, i64 %45, i64 %50, ptr %51, i64 %55, ptr %56, i64 %55, ptr %59, ptr %62, ptr %65, ptr %90, ptr %95, double %1, double %2, double %174) #2, !noalias !34
  switch i32 %190, label %251 [
    i32 -2, label %229
    i32 0, label %229
  ], !prof !17

191:                                              ; preds = %239, %229
  %192 = phi double [ %136, %229 ], [ %195, %239 ]
  %193 = fsub double %192, %174
  %194 = fmul double %193, 5.000000e-01
  %195 = fadd double %174, %194
  %196 = fsub double %195, %174
  %197 = fcmp olt double %196, %189
  br i1 %197, label %251, label %198

198:                                              ; preds = %191
  store i32 0, ptr %6, align 4, !noalias !34
  %199 = call fastcc i32 @_evaluate(ptr nonnull %6, ptr nonnull %7, ptr %16, ptr %19, ptr nonnull %22, ptr %27, i64 %26, ptr %34, i64 %31, i64 %33, ptr %39, i64 %38, ptr %46, i64 %43, i64 %45, i64 %50, ptr %51, i64 %55, ptr %56, i64 %55, ptr %59, ptr %62, ptr %65, ptr %90, ptr %95, double %1, double %2, double %195) #2, !noalias !34
  switch i32 %199, label %251 [
    i32 -2, label %239
    i32 0, label %239
  ], !prof !17

200:                                              ; preds = %239, %229
  %201 = phi double [ %174, %229 ], [ %195, %239 ]
  %202 = phi double [ %136, %229 ], [ %192, %239 ]
  %203 = fsub double %202, %201
  %204 = fcmp ogt double %203, %189
  br i1 %204, label %205, label %251

205:                                              ; preds = %243, %200
  %206 = phi double [ %247, %243 ], [ %202, %200 ]
  %207 = phi double [ %248, %243 ], [ %201, %200 ]
  %208 = fsub double %206, %207
  %209 = fmul double %208, 5.000000e-01
  %210 = fadd double %207, %209
  br label %211

211:                                              ; preds = %215, %205
  %212 = phi i64 [ 0, %205 ], [ %217, %215 ]
  %213 = icmp slt i64 %212, 2
  br i1 %213, label %214, label %220

214:                                              ; preds = %211
  switch i64 %212, label %220 [
    i64 0, label %215
    i64 -2, label %215
    i64 1, label %219
    i64 -1, label %219
  ]

215:                                              ; preds = %219, %214, %214
  %216 = phi double [ %206, %219 ], [ %207, %214 ], [ %207, %214 ]
  %217 = add i64 %212, 1
  %218 = fcmp oeq double %216, %210
  br i1 %218, label %220, label %211

219:                                              ; preds = %214, %214
  br label %215

220:                                              ; preds = %214, %211, %215
  %221 = phi i1 [ false, %211 ], [ true, %215 ], [ false, %214 ]
  %222 = phi i1 [ false, %211 ], [ false, %215 ], [ true, %214 ]
  %223 = phi i32 [ 0, %211 ], [ 0, %215 ], [ 1, %214 ]
  %224 = or i1 %222, %221
  %225 = select i1 %222, double 0.000000e+00, double %206, !prof !38
  %226 = select i1 %222, i32 %223, i32 0, !prof !38
  br i1 %224, label %251, label %227, !prof !39

227:                                              ; preds = %220
  store i32 0, ptr %8, align 4, !noalias !34
  %228 = call fastcc i32 @_evaluate(ptr nonnull %8, ptr nonnull %9, ptr %16, ptr %19, ptr nonnull %22, ptr %27, i64 %26, ptr %34, i64 %31, i64 %33, ptr %39, i64 %38, ptr %46, i64 %43, i64 %45, i64 %50, ptr %51, i64 %55, ptr %56, i64 %55, ptr %59, ptr %62, ptr %65, ptr %90, ptr %95, double %1, double %2, double %210) #2, !noalias !34
  switch i32 %228, label %251 [
    i32 -2, label %243
    i32 0, label %243
  ], !prof !17

229:                                              ; preds = %181, %181
  %230 = add nsw i64 %182, %177
  %231 = icmp slt i64 %230, 0
  %232 = select i1 %231, i64 %89, i64 0
  %233 = getelementptr double, ptr %90, i64 %230
  %234 = getelementptr double, ptr %233, i64 %232
  %235 = load double, ptr %234, align 8, !noalias !34
  %236 = sitofp i64 %369 to double
  %237 = fmul double %235, %236
  %238 = fcmp ugt double %237, 0.000000e+00
  br i1 %238, label %200, label %191

239:                                              ; preds = %198, %198
  %240 = load double, ptr %234, align 8, !noalias !34
  %241 = fmul double %240, %236
  %242 = fcmp ogt double %241, 0.000000e+00
  br i1 %242, label %200, label %191

243:                                              ; preds = %227, %227
  %244 = load double, ptr %234, align 8, !noalias !34
  %245 = fmul double %244, %236
  %246 = fcmp ogt double %245, 0.000000e+00
  %247 = select i1 %246, double %206, double %210
  %248 = select i1 %246, double %210, double %207
  %249 = fsub double %247, %248
  %250 = fcmp ogt double %249, %189
  br i1 %250, label %205, label %251

251:                                              ; preds = %227, %220, %198, %181, %200, %243, %191
  %252 = phi double [ %225, %220 ], [ 0.000000e+00, %198 ], [ %247, %243 ], [ %174, %191 ], [ 0.000000e+00, %181 ], [ %202, %200 ], [ 0.000000e+00, %227 ]
  %253 = phi i32 [ %226, %220 ], [ %199, %198 ], [ 0, %243 ], [ 0, %191 ], [ %190, %181 ], [ 0, %200 ], [ %228, %227 ]
  switch i32 %253, label %394 [
    i32 -2, label %389
    i32 0, label %389
  ], !prof !17

254:                                              ; preds = %389, %383
  %255 = phi double [ %179, %383 ], [ %393, %389 ]
  br label %176

256:                                              ; preds = %176
  %257 = fcmp ogt double %179, 1.000000e+00
  br i1 %257, label %340, label %258

258:                                              ; preds = %256
  store i32 0, ptr %12, align 4, !noalias !18
  %259 = call fastcc i32 @_evaluate(ptr nonnull %12, ptr nonnull %13, ptr %16, ptr %19, ptr nonnull %22, ptr %27, i64 %26, ptr %34, i64 %31, i64 %33, ptr %39, i64 %38, ptr %46, i64 %43, i64 %45, i64 %50, ptr %51, i64 %55, ptr %56, i64 %55, ptr %59, ptr %62, ptr %65, ptr %90, ptr %95, double %1, double %2, double %179) #2
  switch i32 %259, label %398 [
    i32 -2, label %395
    i32 0, label %395
  ], !prof !17

260:                                              ; preds = %395
  store i64 %124, ptr %123, align 8, !noalias !18
  %261 = getelementptr i8, ptr %115, i64 48
  store double 1.000000e+00, ptr %261, align 8, !noalias !18
  br label %461

262:                                              ; preds = %395, %304
  %263 = phi i64 [ %401, %304 ], [ 0, %395 ]
  %264 = phi i64 [ %400, %304 ], [ %175, %395 ]
  %265 = phi i1 [ %305, %304 ], [ false, %395 ]
  %266 = icmp sgt i64 %264, 0
  br i1 %266, label %399, label %306

267:                                              ; preds = %422
  %268 = select i1 %408, i64 %89, i64 0
  %269 = getelementptr double, ptr %90, i64 %263
  %270 = getelementptr double, ptr %269, i64 %268
  %271 = load double, ptr %270, align 8, !noalias !18
  %272 = fcmp ogt double %271, 0.000000e+00
  %273 = select i1 %417, i1 %272, i1 false
  %274 = select i1 %273, i1 %420, i1 false
  br i1 %274, label %281, label %275

275:                                              ; preds = %267
  %276 = icmp slt i64 %412, 1
  %277 = fcmp uge double %271, 0.000000e+00
  %278 = select i1 %276, i1 true, i1 %277
  %279 = icmp sgt i64 %416, 0
  %280 = select i1 %278, i1 true, i1 %279
  br i1 %280, label %289, label %281

281:                                              ; preds = %267, %275
  %282 = fcmp oeq double %407, 0.000000e+00
  br i1 %282, label %289, label %283

283:                                              ; preds = %281
  %284 = select i1 %408, i64 %84, i64 0
  %285 = getelementptr i64, ptr %85, i64 %263
  %286 = getelementptr i64, ptr %285, i64 %284
  %287 = load i64, ptr %286, align 8, !noalias !18
  %288 = icmp eq i64 %287, 1
  br label %289

289:                                              ; preds = %399, %281, %283, %275, %422
  %290 = phi i1 [ true, %422 ], [ false, %275 ], [ true, %281 ], [ %288, %283 ], [ true, %399 ]
  %291 = zext i1 %290 to i64
  %292 = select i1 %408, i64 %84, i64 0
  %293 = getelementptr i64, ptr %85, i64 %263
  %294 = getelementptr i64, ptr %293, i64 %292
  store i64 %291, ptr %294, align 8, !noalias !18
  %295 = xor i1 %290, true
  %296 = select i1 %265, i1 true, i1 %295
  %297 = select i1 %265, i1 true, i1 %290
  br i1 %296, label %304, label %298

298:                                              ; preds = %289
  %299 = select i1 %408, i64 %74, i64 0
  %300 = getelementptr i64, ptr %75, i64 %263
  %301 = getelementptr i64, ptr %300, i64 %299
  %302 = load i64, ptr %301, align 8, !noalias !18
  %303 = icmp eq i64 %302, 1
  br label %304

304:                                              ; preds = %289, %298
  %305 = phi i1 [ %297, %289 ], [ %303, %298 ]
  br label %262

306:                                              ; preds = %262
  br i1 %265, label %307, label %309

307:                                              ; preds = %306
  %308 = getelementptr i8, ptr %115, i64 48
  store double %179, ptr %308, align 8, !noalias !18
  br label %461

309:                                              ; preds = %306, %428, %333
  %310 = phi i64 [ %430, %333 ], [ %430, %428 ], [ 0, %306 ]
  %311 = phi i64 [ %429, %333 ], [ %429, %428 ], [ %175, %306 ]
  %312 = icmp sgt i64 %311, 0
  br i1 %312, label %428, label %173

313:                                              ; preds = %428
  %314 = load i64, ptr %123, align 8, !noalias !18
  %315 = icmp eq i64 %314, %99
  br i1 %315, label %316, label %318

316:                                              ; preds = %313
  %317 = getelementptr i8, ptr %115, i64 48
  store double %179, ptr %317, align 8, !noalias !18
  br label %461

318:                                              ; preds = %313
  %319 = fmul double %179, %2
  %320 = fadd double %1, %319
  %321 = icmp slt i64 %314, 0
  %322 = select i1 %321, i64 %99, i64 0
  %323 = getelementptr double, ptr %100, i64 %314
  %324 = getelementptr double, ptr %323, i64 %322
  store double %320, ptr %324, align 8, !noalias !18
  %325 = select i1 %321, i64 %104, i64 0
  %326 = getelementptr i64, ptr %105, i64 %314
  %327 = getelementptr i64, ptr %326, i64 %325
  store i64 %310, ptr %327, align 8, !noalias !18
  %328 = call i64 @llvm.smax.i64(i64 %122, i64 0)
  br label %329

329:                                              ; preds = %318, %437
  %330 = phi i64 [ 0, %318 ], [ %439, %437 ]
  %331 = phi i64 [ %328, %318 ], [ %438, %437 ]
  %332 = icmp sgt i64 %331, 0
  br i1 %332, label %437, label %333

333:                                              ; preds = %329
  %334 = add nsw i64 %314, 1
  store i64 %334, ptr %123, align 8, !noalias !18
  %335 = select i1 %431, i64 %79, i64 0
  %336 = getelementptr i64, ptr %80, i64 %310
  %337 = getelementptr i64, ptr %336, i64 %335
  %338 = load i64, ptr %337, align 8, !noalias !18
  %339 = sub i64 0, %338
  store i64 %339, ptr %337, align 8, !noalias !18
  br label %309

340:                                              ; preds = %256, %354, %344
  %341 = phi i64 [ %454, %354 ], [ %454, %344 ], [ 0, %256 ]
  %342 = phi i64 [ %453, %354 ], [ %453, %344 ], [ %175, %256 ]
  %343 = icmp sgt i64 %342, 0
  br i1 %343, label %452, label %125

344:                                              ; preds = %452
  %345 = select i1 %455, i64 %79, i64 0
  %346 = getelementptr i64, ptr %80, i64 %341
  %347 = getelementptr i64, ptr %346, i64 %345
  store i64 1, ptr %347, align 8, !noalias !18
  br label %340

348:                                              ; preds = %452
  %349 = fcmp olt double %459, 0.000000e+00
  br i1 %349, label %350, label %354

350:                                              ; preds = %348
  %351 = select i1 %455, i64 %79, i64 0
  %352 = getelementptr i64, ptr %80, i64 %341
  %353 = getelementptr i64, ptr %352, i64 %351
  store i64 -1, ptr %353, align 8, !noalias !18
  br label %354

354:                                              ; preds = %350, %348
  br label %340

355:                                              ; preds = %125
  %356 = getelementptr i8, ptr %115, i64 48
  store double 1.000000e+00, ptr %356, align 8, !noalias !18
  br label %461

357:                                              ; preds = %168, %168
  br i1 %169, label %171, label %173

358:                                              ; preds = %168
  br label %461

359:                                              ; preds = %176
  %360 = add nsw i64 %178, -1
  %361 = add i64 %177, 1
  %362 = icmp slt i64 %177, 0
  %363 = select i1 %362, i64 %84, i64 0
  %364 = getelementptr i64, ptr %85, i64 %177
  %365 = getelementptr i64, ptr %364, i64 %363
  store i64 0, ptr %365, align 8, !noalias !18
  %366 = select i1 %362, i64 %79, i64 0
  %367 = getelementptr i64, ptr %80, i64 %177
  %368 = getelementptr i64, ptr %367, i64 %366
  %369 = load i64, ptr %368, align 8, !noalias !18
  %370 = select i1 %362, i64 %89, i64 0
  %371 = getelementptr double, ptr %90, i64 %177
  %372 = getelementptr double, ptr %371, i64 %370
  %373 = load double, ptr %372, align 8, !noalias !18
  %374 = select i1 %362, i64 %69, i64 0
  %375 = getelementptr i64, ptr %70, i64 %177
  %376 = getelementptr i64, ptr %375, i64 %374
  %377 = load i64, ptr %376, align 8, !noalias !18
  %378 = icmp slt i64 %369, 0
  %379 = fcmp ogt double %373, 0.000000e+00
  %380 = select i1 %378, i1 %379, i1 false
  %381 = icmp sgt i64 %377, -1
  %382 = select i1 %380, i1 %381, i1 false
  br i1 %382, label %181, label %383

383:                                              ; preds = %359
  %384 = icmp slt i64 %369, 1
  %385 = fcmp uge double %373, 0.000000e+00
  %386 = select i1 %384, i1 true, i1 %385
  %387 = icmp sgt i64 %377, 0
  %388 = select i1 %386, i1 true, i1 %387
  br i1 %388, label %254, label %181

389:                                              ; preds = %251, %251
  %390 = fcmp ole double %252, %174
  %391 = zext i1 %390 to i64
  store i64 %391, ptr %365, align 8, !noalias !18
  %392 = fcmp olt double %252, %179
  %393 = select i1 %392, double %252, double %179
  br label %254

394:                                              ; preds = %251
  br label %461

395:                                              ; preds = %258, %258
  %396 = load i32, ptr %12, align 4, !noalias !18
  %397 = icmp slt i32 %396, 0
  br i1 %397, label %260, label %262

398:                                              ; preds = %258
  br label %461

399:                                              ; preds = %262
  %400 = add nsw i64 %264, -1
  %401 = add i64 %263, 1
  %402 = add nsw i64 %120, %263
  %403 = icmp slt i64 %402, 0
  %404 = select i1 %403, i64 %89, i64 0
  %405 = getelementptr double, ptr %90, i64 %402
  %406 = getelementptr double, ptr %405, i64 %404
  %407 = load double, ptr %406, align 8, !noalias !18
  %408 = icmp slt i64 %263, 0
  %409 = select i1 %408, i64 %79, i64 0
  %410 = getelementptr i64, ptr %80, i64 %263
  %411 = getelementptr i64, ptr %410, i64 %409
  %412 = load i64, ptr %411, align 8, !noalias !18
  %413 = select i1 %408, i64 %69, i64 0
  %414 = getelementptr i64, ptr %70, i64 %263
  %415 = getelementptr i64, ptr %414, i64 %413
  %416 = load i64, ptr %415, align 8, !noalias !18
  %417 = icmp slt i64 %412, 0
  %418 = fcmp ogt double %407, 0.000000e+00
  %419 = select i1 %417, i1 %418, i1 false
  %420 = icmp sgt i64 %416, -1
  %421 = select i1 %419, i1 %420, i1 false
  br i1 %421, label %289, label %422

422:                                              ; preds = %399
  %423 = icmp slt i64 %412, 1
  %424 = fcmp uge double %407, 0.000000e+00
  %425 = select i1 %423, i1 true, i1 %424
  %426 = icmp sgt i64 %416, 0
  %427 = select i1 %425, i1 true, i1 %426
  br i1 %427, label %267, label %289

428:                                              ; preds = %309
  %429 = add nsw i64 %311, -1
  %430 = add i64 %310, 1
  %431 = icmp slt i64 %310, 0
  %432 = select i1 %431, i64 %84, i64 0
  %433 = getelementptr i64, ptr %85, i64 %310
  %434 = getelementptr i64, ptr %433, i64 %432
  %435 = load i64, ptr %434, align 8, !noalias !18
  %436 = icmp eq i64 %435, 0
  br i1 %436, label %309, label %313

437:                                              ; preds = %329
  %438 = add nsw i64 %331, -1
  %439 = add i64 %330, 1
  %440 = icmp slt i64 %330, 0
  %441 = select i1 %440, i64 %94, i64 0
  %442 = getelementptr double, ptr %95, i64 %330
  %443 = getelementptr double, ptr %442, i64 %441
  %444 = load double, ptr %443, align 8, !noalias !18
  %445 = select i1 %321, i64 %109, i64 0
  %446 = add i64 %314, %445
  %447 = select i1 %440, i64 %111, i64 0
  %448 = mul i64 %446, %111
  %449 = getelementptr double, ptr %112, i64 %448
  %450 = getelementptr double, ptr %449, i64 %330
  %451 = getelementptr double, ptr %450, i64 %447
  store double %444, ptr %451, align 8, !noalias !18
  br label %329

452:                                              ; preds = %340
  %453 = add nsw i64 %342, -1
  %454 = add i64 %341, 1
  %455 = icmp slt i64 %341, 0
  %456 = select i1 %455, i64 %89, i64 0
  %457 = getelementptr double, ptr %90, i64 %341
  %458 = getelementptr double, ptr %457, i64 %456
  %459 = load double, ptr %458, align 8, !noalias !18
  %460 = fcmp ogt double %459, 0.000000e+00
  br i1 %460, label %344, label %348

461:                                              ; preds = %398, %394, %358, %355, %316, %307, %260, %171
  %462 = phi i64 [ 0, %355 ], [ 0, %358 ], [ -4, %171 ], [ -2, %307 ], [ -4, %260 ], [ 0, %394 ], [ -3, %316 ], [ 0, %398 ]
  ret i64 %462
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
