; sources 048d52c4a2f07408ae71a5f6dcfef66f975e0e81f36a6e64af3f9089cff195be
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

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

define internal fastcc i32 @write_reached(ptr noalias %0, ptr %1, ptr %2, i64 %3, ptr %4, ptr %5, i64 %6, ptr %7, i64 %8, ptr %9, i64 %10) unnamed_addr {
  %12 = getelementptr i8, ptr %1, i64 8
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr i8, ptr %5, i64 48
  %15 = load i64, ptr %14, align 8
  %16 = icmp slt i64 %15, %6
  br i1 %16, label %17, label %43

17:                                               ; preds = %11
  %18 = icmp slt i64 %15, 0
  %19 = select i1 %18, i64 %8, i64 0
  %20 = getelementptr double, ptr %7, i64 %15
  %21 = getelementptr double, ptr %20, i64 %19
  %22 = load double, ptr %21, align 8
  %23 = load double, ptr %4, align 8
  %24 = fcmp ugt double %22, %23
  br i1 %24, label %43, label %25

25:                                               ; preds = %17, %35
  %26 = phi i64 [ %33, %35 ], [ %15, %17 ]
  %27 = call i64 @llvm.smax.i64(i64 %13, i64 0)
  br label %28

28:                                               ; preds = %25, %47
  %29 = phi i64 [ 0, %25 ], [ %49, %47 ]
  %30 = phi i64 [ %27, %25 ], [ %48, %47 ]
  %31 = icmp sgt i64 %30, 0
  br i1 %31, label %47, label %32

32:                                               ; preds = %28
  %33 = add nsw i64 %26, 1
  %34 = icmp slt i64 %33, %6
  br i1 %34, label %35, label %43

35:                                               ; preds = %32
  %36 = icmp slt i64 %26, -1
  %37 = select i1 %36, i64 %8, i64 0
  %38 = getelementptr double, ptr %7, i64 %33
  %39 = getelementptr double, ptr %38, i64 %37
  %40 = load double, ptr %39, align 8
  %41 = load double, ptr %4, align 8
  %42 = fcmp ugt double %40, %41
  br i1 %42, label %43, label %25

43:                                               ; preds = %35, %32, %17, %11
  %44 = phi i64 [ %33, %35 ], [ %33, %32 ], [ %15, %17 ], [ %15, %11 ]
  store i64 %44, ptr %14, align 8
  %45 = icmp eq i64 %44, %6
  %46 = zext i1 %45 to i8
  store i8 %46, ptr %0, align 1
  ret i32 0

47:                                               ; preds = %28
  %48 = add nsw i64 %30, -1
  %49 = add i64 %29, 1
  %50 = icmp slt i64 %29, 0
  %51 = select i1 %50, i64 %3, i64 0
  %52 = getelementptr double, ptr %2, i64 %29
  %53 = getelementptr double, ptr %52, i64 %51
  %54 = load double, ptr %53, align 8
  %55 = mul nsw i64 %26, %13
  %56 = add nsw i64 %55, %29
  %57 = icmp slt i64 %56, 0
  %58 = select i1 %57, i64 %10, i64 0
  %59 = getelementptr double, ptr %9, i64 %56
  %60 = getelementptr double, ptr %59, i64 %58
  store double %54, ptr %60, align 8
  br label %28
}

define internal fastcc i32 @norm(ptr noalias %0, ptr %1, ptr %2, ptr %3, ptr %4, i64 %5, ptr %6, i64 %7, i64 %8) unnamed_addr #0 {
  %10 = call i64 @llvm.smax.i64(i64 %8, i64 0)
  br label %11

11:                                               ; preds = %20, %9
  %12 = phi i64 [ 0, %9 ], [ %22, %20 ]
  %13 = phi i64 [ %10, %9 ], [ %21, %20 ]
  %14 = phi double [ 0.000000e+00, %9 ], [ %46, %20 ]
  %15 = icmp sgt i64 %13, 0
  br i1 %15, label %20, label %16

16:                                               ; preds = %11
  %17 = sitofp i64 %8 to double
  %18 = fdiv double %14, %17
  %19 = call double @llvm.sqrt.f64(double %18)
  store double %19, ptr %0, align 8
  ret i32 0

20:                                               ; preds = %11
  %21 = add nsw i64 %13, -1
  %22 = add i64 %12, 1
  %23 = getelementptr double, ptr %1, i64 %12
  %24 = load double, ptr %23, align 8
  %25 = getelementptr double, ptr %3, i64 %12
  %26 = load double, ptr %25, align 8
  %27 = getelementptr double, ptr %2, i64 %12
  %28 = load double, ptr %27, align 8
  %29 = icmp slt i64 %12, 0
  %30 = select i1 %29, i64 %7, i64 0
  %31 = getelementptr double, ptr %6, i64 %12
  %32 = getelementptr double, ptr %31, i64 %30
  %33 = load double, ptr %32, align 8, !noalias !9
  %34 = select i1 %29, i64 %5, i64 0
  %35 = getelementptr double, ptr %4, i64 %12
  %36 = getelementptr double, ptr %35, i64 %34
  %37 = load double, ptr %36, align 8, !noalias !9
  %38 = call double @llvm.fabs.f64(double %26)
  %39 = call double @llvm.fabs.f64(double %28)
  %40 = fcmp ogt double %38, %39
  %41 = select i1 %40, double %38, double %39
  %42 = fmul double %37, %41
  %43 = fadd double %33, %42
  %44 = fdiv double %24, %43
  %45 = fmul double %44, %44
  %46 = fadd double %14, %45
  br label %11
}

declare double @llvm.fabs.f64(double) #1

declare double @llvm.sqrt.f64(double) #1

declare double @llvm.fma.f64(double, double, double) #1

declare double @llvm.rint.f64(double) #1

declare double @llvm.ceil.f64(double) #1

define internal fastcc i32 @_combine_latest(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, ptr %5, i64 %6, ptr %7, ptr %8, ptr %9, ptr %10, i64 %11, i64 %12, i64 %13, double %14) unnamed_addr {
  %16 = getelementptr i8, ptr %7, i64 16
  %17 = load i64, ptr %16, align 8
  %18 = icmp ne i64 %17, 1
  %19 = ptrtoint ptr %8 to i64
  %20 = zext i1 %18 to i64
  %21 = icmp slt i64 %12, 0
  %22 = select i1 %21, i64 %2, i64 0
  %23 = getelementptr i64, ptr %1, i64 %12
  %24 = getelementptr i64, ptr %23, i64 %22
  %25 = load i64, ptr %24, align 8, !noalias !12
  %26 = ptrtoint ptr %9 to i64
  %27 = ptrtoint ptr %10 to i64
  %28 = ptrtoint ptr %3 to i64
  %29 = shl i64 %25, 3
  %30 = add i64 %29, %28
  %31 = ptrtoint ptr %5 to i64
  %32 = add i64 %29, %31
  %33 = icmp slt i64 %12, -1
  %34 = select i1 %33, i64 %2, i64 0
  %35 = getelementptr i8, ptr %23, i64 8
  %36 = getelementptr i64, ptr %35, i64 %34
  %37 = load i64, ptr %36, align 8, !noalias !12
  %38 = xor i64 %25, -1
  %39 = add i64 %37, %38
  call fastcc void @pydy_combine(i64 %13, i64 %19, i64 %26, i64 %27, i64 %30, i64 %32, i64 %39, i64 %20, i64 %17), !noalias !12
  br i1 %18, label %60, label %40

40:                                               ; preds = %15
  %41 = load i64, ptr %36, align 8
  %42 = add nsw i64 %41, -1
  %43 = icmp sgt i64 %41, 0
  %44 = select i1 %43, i64 0, i64 %6
  %45 = getelementptr double, ptr %5, i64 %42
  %46 = getelementptr double, ptr %45, i64 %44
  %47 = load double, ptr %46, align 8
  %48 = fmul double %14, %47
  %49 = select i1 %43, i64 0, i64 %4
  %50 = getelementptr i64, ptr %3, i64 %42
  %51 = getelementptr i64, ptr %50, i64 %49
  %52 = load i64, ptr %51, align 8
  %53 = getelementptr i8, ptr %7, i64 8
  %54 = load i64, ptr %53, align 8
  %55 = call i64 @llvm.smax.i64(i64 %54, i64 0)
  br label %56

56:                                               ; preds = %40, %61
  %57 = phi i64 [ 0, %40 ], [ %63, %61 ]
  %58 = phi i64 [ %55, %40 ], [ %62, %61 ]
  %59 = icmp sgt i64 %58, 0
  br i1 %59, label %61, label %60

60:                                               ; preds = %56, %15
  store ptr null, ptr %0, align 8
  ret i32 0

61:                                               ; preds = %56
  %62 = add nsw i64 %58, -1
  %63 = add i64 %57, 1
  %64 = shl nsw i64 %57, 3
  %65 = add nsw i64 %13, %64
  %66 = add nsw i64 %52, %57
  %67 = icmp slt i64 %66, 0
  %68 = select i1 %67, i64 %11, i64 0
  %69 = getelementptr double, ptr %10, i64 %66
  %70 = getelementptr double, ptr %69, i64 %68
  %71 = load double, ptr %70, align 8
  %72 = inttoptr i64 %65 to ptr
  %73 = load double, ptr %72, align 8
  %74 = call double @llvm.fma.f64(double %48, double %71, double %73)
  store atomic double %74, ptr %72 unordered, align 8
  br label %56
}

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

define i64 @advance(i64 %0, i64 %1, i64 %2) local_unnamed_addr #2 {
  %4 = alloca ptr, align 8
  %5 = alloca ptr, align 8
  %6 = alloca ptr, align 8
  %7 = alloca ptr, align 8
  %8 = alloca ptr, align 8
  %9 = alloca ptr, align 8
  %10 = alloca ptr, align 8
  %11 = alloca ptr, align 8
  %12 = alloca ptr, align 8
  %13 = alloca ptr, align 8
  %14 = alloca ptr, align 8
  %15 = alloca ptr, align 8
  %16 = alloca double, align 8
  %17 = alloca double, align 8
  %18 = alloca double, align 8
  %19 = alloca i8, align 1
  %20 = alloca ptr, align 8
  %21 = alloca ptr, align 8
  %22 = alloca i8, align 1
  %23 = alloca i8, align 1
  store i8 0, ptr %19, align 1, !noalias !15
  store ptr null, ptr %20, align 8, !noalias !15
  store ptr null, ptr %21, align 8, !noalias !15
  store i8 0, ptr %22, align 1, !noalias !15
  store i8 0, ptr %23, align 1, !noalias !15
  %24 = inttoptr i64 %0 to ptr
  %25 = load i64, ptr %24, align 8, !noalias !19
  %26 = inttoptr i64 %25 to ptr
  %27 = getelementptr i8, ptr %24, i64 24
  %28 = load i64, ptr %27, align 8, !noalias !19
  %29 = getelementptr i8, ptr %24, i64 32
  %30 = load i64, ptr %29, align 8, !noalias !19
  %31 = inttoptr i64 %28 to ptr
  %32 = getelementptr i8, ptr %24, i64 48
  %33 = load i64, ptr %32, align 8, !noalias !19
  %34 = getelementptr i8, ptr %24, i64 56
  %35 = load i64, ptr %34, align 8, !noalias !19
  %36 = inttoptr i64 %33 to ptr
  %37 = getelementptr i8, ptr %24, i64 72
  %38 = load i64, ptr %37, align 8, !noalias !19
  %39 = getelementptr i8, ptr %24, i64 80
  %40 = load i64, ptr %39, align 8, !noalias !19
  %41 = inttoptr i64 %38 to ptr
  %42 = getelementptr i8, ptr %24, i64 96
  %43 = load i64, ptr %42, align 8, !noalias !19
  %44 = getelementptr i8, ptr %24, i64 104
  %45 = load i64, ptr %44, align 8, !noalias !19
  %46 = inttoptr i64 %43 to ptr
  %47 = getelementptr i8, ptr %24, i64 120
  %48 = load i64, ptr %47, align 8, !noalias !19
  %49 = inttoptr i64 %48 to ptr
  %50 = getelementptr i8, ptr %24, i64 144
  %51 = load i64, ptr %50, align 8, !noalias !19
  %52 = inttoptr i64 %51 to ptr
  %53 = getelementptr i8, ptr %24, i64 168
  %54 = load i64, ptr %53, align 8, !noalias !19
  %55 = inttoptr i64 %54 to ptr
  %56 = getelementptr i8, ptr %24, i64 192
  %57 = load i64, ptr %56, align 8, !noalias !19
  %58 = getelementptr i8, ptr %24, i64 200
  %59 = load i64, ptr %58, align 8, !noalias !19
  %60 = inttoptr i64 %57 to ptr
  %61 = getelementptr i8, ptr %24, i64 216
  %62 = load i64, ptr %61, align 8, !noalias !19
  %63 = inttoptr i64 %62 to ptr
  %64 = getelementptr i8, ptr %24, i64 240
  %65 = load i64, ptr %64, align 8, !noalias !19
  %66 = getelementptr i8, ptr %24, i64 248
  %67 = load i64, ptr %66, align 8, !noalias !19
  %68 = getelementptr i8, ptr %24, i64 256
  %69 = load i64, ptr %68, align 8, !noalias !19
  %70 = inttoptr i64 %65 to ptr
  %71 = getelementptr i8, ptr %24, i64 264
  %72 = load i64, ptr %71, align 8, !noalias !19
  %73 = getelementptr i8, ptr %24, i64 272
  %74 = load i64, ptr %73, align 8, !noalias !19
  %75 = inttoptr i64 %72 to ptr
  %76 = getelementptr i8, ptr %24, i64 288
  %77 = load i64, ptr %76, align 8, !noalias !19
  %78 = getelementptr i8, ptr %24, i64 296
  %79 = load i64, ptr %78, align 8, !noalias !19
  %80 = getelementptr i8, ptr %24, i64 304
  %81 = load i64, ptr %80, align 8, !noalias !19
  %82 = inttoptr i64 %77 to ptr
  %83 = getelementptr i8, ptr %24, i64 312
  %84 = load i64, ptr %83, align 8, !noalias !19
  %85 = getelementptr i8, ptr %24, i64 320
  %86 = load i64, ptr %85, align 8, !noalias !19
  %87 = inttoptr i64 %84 to ptr
  %88 = getelementptr i8, ptr %24, i64 336
  %89 = load i64, ptr %88, align 8, !noalias !19
  %90 = getelementptr i8, ptr %24, i64 344
  %91 = load i64, ptr %90, align 8, !noalias !19
  %92 = inttoptr i64 %89 to ptr
  %93 = getelementptr i8, ptr %24, i64 360
  %94 = load i64, ptr %93, align 8, !noalias !19
  %95 = getelementptr i8, ptr %24, i64 368
  %96 = load i64, ptr %95, align 8, !noalias !19
  %97 = inttoptr i64 %94 to ptr
  %98 = getelementptr i8, ptr %24, i64 384
  %99 = load i64, ptr %98, align 8, !noalias !19
  %100 = getelementptr i8, ptr %24, i64 392
  %101 = load i64, ptr %100, align 8, !noalias !19
  %102 = inttoptr i64 %99 to ptr
  %103 = getelementptr i8, ptr %24, i64 408
  %104 = load i64, ptr %103, align 8, !noalias !19
  %105 = getelementptr i8, ptr %24, i64 416
  %106 = load i64, ptr %105, align 8, !noalias !19
  %107 = inttoptr i64 %104 to ptr
  %108 = getelementptr i8, ptr %24, i64 432
  %109 = load i64, ptr %108, align 8, !noalias !19
  %110 = getelementptr i8, ptr %24, i64 456
  %111 = load i64, ptr %110, align 8, !noalias !19
  %112 = getelementptr i8, ptr %24, i64 464
  %113 = load i64, ptr %112, align 8, !noalias !19
  %114 = inttoptr i64 %111 to ptr
  %115 = getelementptr i8, ptr %24, i64 480
  %116 = load i64, ptr %115, align 8, !noalias !19
  %117 = getelementptr i8, ptr %24, i64 488
  %118 = load i64, ptr %117, align 8, !noalias !19
  %119 = inttoptr i64 %116 to ptr
  %120 = getelementptr i8, ptr %24, i64 504
  %121 = load i64, ptr %120, align 8, !noalias !19
  %122 = getelementptr i8, ptr %24, i64 512
  %123 = load i64, ptr %122, align 8, !noalias !19
  %124 = inttoptr i64 %121 to ptr
  %125 = getelementptr i8, ptr %24, i64 528
  %126 = load i64, ptr %125, align 8, !noalias !19
  %127 = getelementptr i8, ptr %24, i64 536
  %128 = load i64, ptr %127, align 8, !noalias !19
  %129 = inttoptr i64 %126 to ptr
  %130 = getelementptr i8, ptr %24, i64 552
  %131 = load i64, ptr %130, align 8, !noalias !19
  %132 = getelementptr i8, ptr %24, i64 560
  %133 = load i64, ptr %132, align 8, !noalias !19
  %134 = inttoptr i64 %131 to ptr
  %135 = getelementptr i8, ptr %24, i64 576
  %136 = load i64, ptr %135, align 8, !noalias !19
  %137 = getelementptr i8, ptr %24, i64 584
  %138 = load i64, ptr %137, align 8, !noalias !19
  %139 = inttoptr i64 %136 to ptr
  %140 = getelementptr i8, ptr %24, i64 600
  %141 = load i64, ptr %140, align 8, !noalias !19
  %142 = getelementptr i8, ptr %24, i64 608
  %143 = load i64, ptr %142, align 8, !noalias !19
  %144 = inttoptr i64 %141 to ptr
  %145 = getelementptr i8, ptr %24, i64 624
  %146 = load i64, ptr %145, align 8, !noalias !19
  %147 = getelementptr i8, ptr %24, i64 632
  %148 = load i64, ptr %147, align 8, !noalias !19
  %149 = inttoptr i64 %146 to ptr
  %150 = getelementptr i8, ptr %52, i64 8
  %151 = load i64, ptr %150, align 8, !noalias !19
  %152 = mul nsw i64 %148, %151
  %153 = inttoptr i64 %1 to ptr
  %154 = icmp eq i64 %2, 1
  br i1 %154, label %155, label %188

155:                                              ; preds = %3
  %156 = getelementptr i8, ptr %24, i64 984
  %157 = load i64, ptr %156, align 8, !noalias !19
  %158 = getelementptr i8, ptr %24, i64 992
  %159 = load i64, ptr %158, align 8, !noalias !19
  %160 = inttoptr i64 %157 to ptr
  %161 = getelementptr i8, ptr %24, i64 1008
  %162 = load i64, ptr %161, align 8, !noalias !19
  %163 = getelementptr i8, ptr %24, i64 1016
  %164 = load i64, ptr %163, align 8, !noalias !19
  %165 = inttoptr i64 %162 to ptr
  %166 = call i64 @llvm.smax.i64(i64 %151, i64 0)
  br label %167

167:                                              ; preds = %198, %155
  %168 = phi i64 [ 0, %155 ], [ %200, %198 ]
  %169 = phi i64 [ %166, %155 ], [ %199, %198 ]
  %170 = icmp sgt i64 %169, 0
  br i1 %170, label %198, label %171

171:                                              ; preds = %167
  %172 = call i64 @llvm.smax.i64(i64 %138, i64 0)
  br label %173

173:                                              ; preds = %177, %171
  %174 = phi i64 [ 0, %171 ], [ %179, %177 ]
  %175 = phi i64 [ %172, %171 ], [ %178, %177 ]
  %176 = icmp sgt i64 %175, 0
  br i1 %176, label %177, label %209

177:                                              ; preds = %173
  %178 = add nsw i64 %175, -1
  %179 = add i64 %174, 1
  %180 = icmp slt i64 %174, 0
  %181 = select i1 %180, i64 %159, i64 0
  %182 = getelementptr double, ptr %160, i64 %174
  %183 = getelementptr double, ptr %182, i64 %181
  %184 = load double, ptr %183, align 8, !noalias !22
  %185 = select i1 %180, i64 %138, i64 0
  %186 = getelementptr double, ptr %139, i64 %174
  %187 = getelementptr double, ptr %186, i64 %185
  store double %184, ptr %187, align 8, !noalias !22
  br label %173

188:                                              ; preds = %211, %3
  %189 = getelementptr i8, ptr %24, i64 648
  %190 = load i64, ptr %189, align 8, !noalias !19
  %191 = inttoptr i64 %190 to ptr
  %192 = getelementptr i8, ptr %24, i64 720
  %193 = load i64, ptr %192, align 8, !noalias !19
  %194 = inttoptr i64 %193 to ptr
  %195 = getelementptr i8, ptr %144, i64 56
  %196 = load i64, ptr %195, align 8, !noalias !15
  %197 = icmp eq i64 %196, 0
  br i1 %197, label %226, label %227

198:                                              ; preds = %167
  %199 = add nsw i64 %169, -1
  %200 = add i64 %168, 1
  %201 = icmp slt i64 %168, 0
  %202 = select i1 %201, i64 %152, i64 0
  %203 = getelementptr double, ptr %153, i64 %168
  %204 = getelementptr double, ptr %203, i64 %202
  %205 = load double, ptr %204, align 8, !noalias !19
  %206 = select i1 %201, i64 %86, i64 0
  %207 = getelementptr double, ptr %87, i64 %168
  %208 = getelementptr double, ptr %207, i64 %206
  store double %205, ptr %208, align 8, !noalias !19
  br label %167

209:                                              ; preds = %173
  %210 = call i64 @llvm.smax.i64(i64 %143, i64 0)
  br label %211

211:                                              ; preds = %215, %209
  %212 = phi i64 [ 0, %209 ], [ %217, %215 ]
  %213 = phi i64 [ %210, %209 ], [ %216, %215 ]
  %214 = icmp sgt i64 %213, 0
  br i1 %214, label %215, label %188

215:                                              ; preds = %211
  %216 = add nsw i64 %213, -1
  %217 = add i64 %212, 1
  %218 = icmp slt i64 %212, 0
  %219 = select i1 %218, i64 %164, i64 0
  %220 = getelementptr i64, ptr %165, i64 %212
  %221 = getelementptr i64, ptr %220, i64 %219
  %222 = load i64, ptr %221, align 8, !noalias !25
  %223 = select i1 %218, i64 %143, i64 0
  %224 = getelementptr i64, ptr %144, i64 %212
  %225 = getelementptr i64, ptr %224, i64 %223
  store i64 %222, ptr %225, align 8, !noalias !25
  br label %211

226:                                              ; preds = %188
  br label %1398

227:                                              ; preds = %188
  %228 = load i64, ptr %26, align 8, !noalias !15
  %229 = load i64, ptr %191, align 8, !noalias !15
  %230 = icmp eq i64 %229, 1
  %231 = getelementptr i8, ptr %26, i64 8
  %232 = load i64, ptr %231, align 8, !noalias !15
  %233 = icmp slt i64 %232, 1
  %234 = mul nsw i64 %228, %86
  %235 = shl i64 %234, 3
  %236 = add i64 %235, %116
  %237 = call i64 @llvm.smin.i64(i64 %148, i64 0)
  %238 = getelementptr double, ptr %149, i64 %148
  %239 = getelementptr i8, ptr %238, i64 -8
  %240 = getelementptr double, ptr %239, i64 %237
  %241 = load double, ptr %240, align 8, !noalias !15
  %242 = load double, ptr %139, align 8, !noalias !15
  %243 = getelementptr i8, ptr %139, i64 8
  %244 = load double, ptr %243, align 8, !noalias !15
  %245 = load i64, ptr %144, align 8, !noalias !15
  %246 = icmp eq i64 %245, 0
  br i1 %246, label %247, label %417

247:                                              ; preds = %227
  %248 = getelementptr i8, ptr %144, i64 24
  %249 = load i64, ptr %248, align 8, !noalias !15
  %250 = add nsw i64 %249, 1
  store i64 %250, ptr %248, align 8, !noalias !15
  store ptr null, ptr %12, align 8, !noalias !28
  store ptr null, ptr %13, align 8, !noalias !28
  store double %242, ptr %55, align 8, !noalias !28
  %251 = icmp sgt i64 %67, 0
  br i1 %251, label %252, label %255

252:                                              ; preds = %247
  store ptr null, ptr %12, align 8, !noalias !28
  %253 = call fastcc i32 @_sample(ptr nonnull %12, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %242) #2
  switch i32 %253, label %254 [
    i32 -2, label %255
    i32 0, label %255
  ], !prof !35

254:                                              ; preds = %252
  br label %255

255:                                              ; preds = %252, %252, %247, %254
  %256 = phi i32 [ %253, %254 ], [ 0, %247 ], [ 0, %252 ], [ 0, %252 ]
  switch i32 %256, label %261 [
    i32 -2, label %257
    i32 0, label %257
  ], !prof !35

257:                                              ; preds = %255, %255
  %258 = load i64, ptr %52, align 8, !noalias !36
  %259 = inttoptr i64 %258 to ptr
  %260 = call i32 %259(ptr nonnull %55, ptr %87, ptr %60, ptr %63, ptr %119) #2, !noalias !36
  br label %261

261:                                              ; preds = %255, %257
  %262 = phi i32 [ %260, %257 ], [ 0, %255 ]
  %263 = phi i32 [ 0, %257 ], [ %256, %255 ]
  switch i32 %263, label %1218 [
    i32 -2, label %1216
    i32 0, label %1216
  ], !prof !35

264:                                              ; preds = %1216
  %265 = getelementptr i8, ptr %144, i64 72
  store i64 3, ptr %265, align 8, !noalias !15
  %266 = icmp slt i32 %262, 0
  %267 = select i1 %266, i64 -4, i64 2
  br label %1398

268:                                              ; preds = %1216
  store i64 1, ptr %144, align 8, !noalias !15
  %269 = getelementptr i8, ptr %49, i64 40
  %270 = load double, ptr %269, align 8, !noalias !15
  %271 = getelementptr i8, ptr %139, i64 24
  store double 1.000000e-04, ptr %271, align 8, !noalias !15
  %272 = getelementptr i8, ptr %139, i64 40
  store double %270, ptr %272, align 8, !noalias !15
  store i8 0, ptr %19, align 1, !noalias !15
  %273 = call fastcc i32 @write_reached(ptr nonnull %19, ptr %52, ptr %87, i64 %86, ptr nonnull %139, ptr nonnull %144, i64 %148, ptr %149, i64 %148, ptr %153, i64 %152) #2
  switch i32 %273, label %1222 [
    i32 -2, label %1219
    i32 0, label %1219
  ], !prof !35

274:                                              ; preds = %1219
  br label %1398

275:                                              ; preds = %1219
  %276 = fcmp oeq double %244, 0.000000e+00
  br i1 %276, label %277, label %417

277:                                              ; preds = %275
  %278 = load i64, ptr %150, align 8, !noalias !15
  %279 = getelementptr i8, ptr %139, i64 16
  %280 = load double, ptr %279, align 8, !noalias !15
  %281 = getelementptr i8, ptr %52, i64 24
  %282 = load i64, ptr %281, align 8, !noalias !15
  store double 0.000000e+00, ptr %17, align 8, !noalias !37
  store double 0.000000e+00, ptr %18, align 8, !noalias !37
  store double 0.000000e+00, ptr %17, align 8, !noalias !37
  %283 = call fastcc i32 @norm(ptr nonnull %17, ptr %87, ptr %87, ptr %87, ptr %129, i64 %128, ptr %134, i64 %133, i64 %282) #2
  %284 = load double, ptr %17, align 8, !noalias !37
  switch i32 %283, label %1223 [
    i32 -2, label %285
    i32 0, label %285
  ], !prof !35

285:                                              ; preds = %277, %277
  store double 0.000000e+00, ptr %18, align 8, !noalias !37
  %286 = call fastcc i32 @norm(ptr nonnull %18, ptr %119, ptr %87, ptr %87, ptr %129, i64 %128, ptr %134, i64 %133, i64 %282) #2
  %287 = load double, ptr %18, align 8, !noalias !37
  switch i32 %286, label %1223 [
    i32 -2, label %288
    i32 0, label %288
  ], !prof !35

288:                                              ; preds = %285, %285
  %289 = fcmp olt double %284, 1.000000e-05
  %290 = fcmp olt double %287, 1.000000e-05
  %291 = or i1 %289, %290
  %292 = fmul double %284, 1.000000e-02
  %293 = fdiv double %292, %287
  %294 = select i1 %291, double 0x3EB0C6F7A0B5ED8D, double %293
  %295 = fcmp olt double %280, %294
  %296 = select i1 %295, double %280, double %294
  %297 = call i64 @llvm.smax.i64(i64 %278, i64 0)
  br label %298

298:                                              ; preds = %288, %1224
  %299 = phi i64 [ 0, %288 ], [ %1226, %1224 ]
  %300 = phi i64 [ %297, %288 ], [ %1225, %1224 ]
  %301 = icmp sgt i64 %300, 0
  br i1 %301, label %1224, label %302

302:                                              ; preds = %298
  %303 = load i64, ptr %248, align 8, !noalias !15
  %304 = add nsw i64 %303, 1
  store i64 %304, ptr %248, align 8, !noalias !15
  %305 = shl i64 %86, 3
  %306 = add i64 %305, %116
  %307 = fadd double %242, %296
  store ptr null, ptr %14, align 8, !noalias !41
  store ptr null, ptr %15, align 8, !noalias !41
  store double %307, ptr %55, align 8, !noalias !41
  br i1 %251, label %308, label %311

308:                                              ; preds = %302
  store ptr null, ptr %14, align 8, !noalias !41
  %309 = call fastcc i32 @_sample(ptr nonnull %14, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %307) #2
  switch i32 %309, label %310 [
    i32 -2, label %311
    i32 0, label %311
  ], !prof !35

310:                                              ; preds = %308
  br label %311

311:                                              ; preds = %308, %308, %302, %310
  %312 = phi i32 [ %309, %310 ], [ 0, %302 ], [ 0, %308 ], [ 0, %308 ]
  switch i32 %312, label %319 [
    i32 -2, label %313
    i32 0, label %313
  ], !prof !35

313:                                              ; preds = %311, %311
  %314 = load i64, ptr %52, align 8, !noalias !48
  %315 = inttoptr i64 %314 to ptr
  %316 = inttoptr i64 %306 to ptr
  %317 = call i32 %315(ptr nonnull %55, ptr %97, ptr %60, ptr %63, ptr %316) #2, !noalias !48
  %318 = icmp eq i32 %317, 0
  br label %319

319:                                              ; preds = %311, %313
  %320 = phi i1 [ %318, %313 ], [ true, %311 ]
  %321 = phi i32 [ 0, %313 ], [ %312, %311 ]
  switch i32 %321, label %1242 [
    i32 -2, label %1241
    i32 0, label %1241
  ], !prof !35

322:                                              ; preds = %1241
  %323 = fmul double %296, 1.000000e-03
  br label %412

324:                                              ; preds = %1241
  store double 0.000000e+00, ptr %16, align 8, !noalias !49
  %325 = icmp slt i64 %86, 0
  %326 = select i1 %325, i64 %118, i64 0
  %327 = add i64 %86, %326
  %328 = icmp slt i64 %327, 0
  br i1 %328, label %335, label %336, !prof !4

329:                                              ; preds = %340, %344
  %330 = phi i64 [ 0, %340 ], [ %346, %344 ]
  %331 = phi i64 [ %343, %340 ], [ %345, %344 ]
  %332 = icmp sgt i64 %331, 0
  br i1 %332, label %344, label %333

333:                                              ; preds = %329
  store double 0.000000e+00, ptr %16, align 8, !noalias !49
  %334 = call fastcc i32 @norm(ptr nonnull %16, ptr %342, ptr %87, ptr %87, ptr %129, i64 %128, ptr %134, i64 %133, i64 %282) #2
  switch i32 %334, label %1243 [
    i32 -2, label %352
    i32 0, label %352
  ], !prof !35

335:                                              ; preds = %324
  br label %336

336:                                              ; preds = %335, %324
  %337 = phi i64 [ 0, %335 ], [ %327, %324 ]
  %338 = icmp slt i64 %327, %118
  br i1 %338, label %340, label %339, !prof !8

339:                                              ; preds = %336
  br label %340

340:                                              ; preds = %339, %336
  %341 = phi i64 [ %118, %339 ], [ %337, %336 ]
  %342 = getelementptr double, ptr %119, i64 %341
  %343 = call i64 @llvm.smax.i64(i64 %282, i64 0)
  br label %329

344:                                              ; preds = %329
  %345 = add nsw i64 %331, -1
  %346 = add i64 %330, 1
  %347 = getelementptr double, ptr %342, i64 %330
  %348 = load double, ptr %347, align 8, !noalias !49
  %349 = getelementptr double, ptr %119, i64 %330
  %350 = load double, ptr %349, align 8, !noalias !49
  %351 = fsub double %348, %350
  store double %351, ptr %347, align 8, !noalias !49
  br label %329

352:                                              ; preds = %333, %333
  %353 = load double, ptr %16, align 8, !noalias !49
  %354 = fdiv double %353, %296
  %355 = fcmp ogt double %287, %354
  %356 = select i1 %355, double %287, double %354
  %357 = fcmp ogt double %356, 1.000000e-15
  %358 = fdiv double 1.000000e-02, %356
  %359 = select i1 %357, double %358, double 1.000000e+13
  %360 = load double, ptr %49, align 8, !noalias !49
  %361 = bitcast double %359 to i64
  %362 = add nsw i64 %361, -4604544271217802189
  %363 = ashr i64 %362, 52
  %364 = and i64 %362, -4503599627370496
  %365 = sub i64 %361, %364
  %366 = bitcast i64 %365 to double
  %367 = fadd double %366, -1.000000e+00
  %368 = fadd double %366, 1.000000e+00
  %369 = fdiv double %367, %368
  %370 = fmul double %369, %369
  %371 = call double @llvm.fma.f64(double %370, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %372 = call double @llvm.fma.f64(double %371, double %370, double 0x3FE2776C50EF9BFE)
  %373 = call double @llvm.fma.f64(double %372, double %370, double 0x3FEEC709DC3A03FD)
  %374 = call double @llvm.fma.f64(double %373, double %370, double 0x40071547652B82FE)
  %375 = fmul double %374, %369
  %376 = trunc nsw i64 %363 to i32
  %377 = sitofp i32 %376 to double
  %378 = fadd double %375, %377
  %379 = fmul double %378, %360
  %380 = fcmp ogt double %379, -1.000000e+03
  %381 = select i1 %380, double %379, double -1.000000e+03
  %382 = fcmp olt double %381, 1.000000e+03
  %383 = select i1 %382, double %381, double 1.000000e+03
  %384 = call double @llvm.rint.f64(double %383)
  %385 = fsub double %383, %384
  %386 = call double @llvm.fma.f64(double %385, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %387 = call double @llvm.fma.f64(double %386, double %385, double 0x3F55D87FE78A6730)
  %388 = call double @llvm.fma.f64(double %387, double %385, double 0x3F83B2AB6FBA4E77)
  %389 = call double @llvm.fma.f64(double %388, double %385, double 0x3FAC6B08D704A0BF)
  %390 = call double @llvm.fma.f64(double %389, double %385, double 0x3FCEBFBDFF82C58E)
  %391 = call double @llvm.fma.f64(double %390, double %385, double 0x3FE62E42FEFA39EF)
  %392 = call double @llvm.fma.f64(double %391, double %385, double 1.000000e+00)
  %393 = fptosi double %384 to i32
  %394 = zext i32 %393 to i64
  %395 = shl i64 %394, 52
  %396 = bitcast double %392 to i64
  %397 = add i64 %395, %396
  %398 = bitcast i64 %397 to double
  %399 = fmul double %296, 1.000000e-03
  %400 = fcmp olt double %399, 0x3EB0C6F7A0B5ED8D
  %401 = select i1 %400, double 0x3EB0C6F7A0B5ED8D, double %399
  %402 = fmul double %296, 1.000000e+02
  %403 = select i1 %357, double %398, double %401
  %404 = fcmp olt double %402, %403
  %405 = select i1 %404, double %402, double %403
  %406 = call double @llvm.fabs.f64(double %242)
  %407 = fmul double %406, 0x3D30000000000000
  %408 = fcmp ogt double %407, %405
  %409 = select i1 %408, double %407, double %405
  %410 = fcmp olt double %280, %409
  %411 = select i1 %410, double %280, double %409
  br label %412

412:                                              ; preds = %352, %322
  %413 = phi double [ %323, %322 ], [ %411, %352 ]
  %414 = call i1 @llvm.is.fpclass.f64(double %413, i32 384)
  br i1 %414, label %417, label %415

415:                                              ; preds = %412
  %416 = getelementptr i8, ptr %144, i64 72
  store i64 4, ptr %416, align 8, !noalias !15
  br label %417

417:                                              ; preds = %412, %415, %275, %227
  %418 = phi double [ %413, %412 ], [ %413, %415 ], [ %244, %275 ], [ %244, %227 ]
  br label %419

419:                                              ; preds = %1210, %417
  %420 = phi double [ %418, %417 ], [ %1212, %1210 ]
  %421 = phi double [ %242, %417 ], [ %424, %1210 ]
  br label %422

422:                                              ; preds = %1141, %419
  %423 = phi double [ %420, %419 ], [ %1135, %1141 ]
  %424 = phi double [ %421, %419 ], [ %467, %1141 ]
  %425 = load i64, ptr %195, align 8, !noalias !15
  %426 = icmp eq i64 %425, 0
  br i1 %426, label %427, label %428

427:                                              ; preds = %422
  store double %423, ptr %243, align 8, !noalias !15
  br label %1398

428:                                              ; preds = %422
  %429 = add nsw i64 %425, -1
  store i64 %429, ptr %195, align 8, !noalias !15
  %430 = getelementptr i8, ptr %144, i64 8
  %431 = load i64, ptr %430, align 8, !noalias !15
  %432 = getelementptr i8, ptr %144, i64 16
  %433 = load i64, ptr %432, align 8, !noalias !15
  %434 = add nsw i64 %431, %433
  %435 = getelementptr i8, ptr %144, i64 64
  %436 = load i64, ptr %435, align 8, !noalias !15
  %437 = icmp slt i64 %434, %436
  br i1 %437, label %439, label %438

438:                                              ; preds = %428
  store double %423, ptr %243, align 8, !noalias !15
  br label %1398

439:                                              ; preds = %428
  br i1 %233, label %445, label %440

440:                                              ; preds = %439
  %441 = getelementptr i8, ptr %139, i64 16
  %442 = load double, ptr %441, align 8, !noalias !15
  %443 = fcmp olt double %423, %442
  %444 = select i1 %443, double %423, double %442
  br label %458

445:                                              ; preds = %439
  %446 = getelementptr i8, ptr %144, i64 48
  %447 = load i64, ptr %446, align 8, !noalias !15
  %448 = icmp slt i64 %447, 0
  %449 = select i1 %448, i64 %148, i64 0
  %450 = getelementptr double, ptr %149, i64 %447
  %451 = getelementptr double, ptr %450, i64 %449
  %452 = load double, ptr %451, align 8, !noalias !15
  %453 = fsub double %452, %424
  %454 = fdiv double %453, %423
  %455 = fmul double %454, 0x3FEFFFFFFFFFDCD1
  %456 = call double @llvm.ceil.f64(double %455)
  %457 = fdiv double %453, %456
  br label %458

458:                                              ; preds = %445, %440
  %459 = phi double [ %241, %440 ], [ %452, %445 ]
  %460 = phi double [ %444, %440 ], [ %457, %445 ]
  %461 = fadd double %424, %460
  %462 = fmul double %460, 1.000000e-03
  %463 = fsub double %459, %462
  %464 = fcmp ogt double %461, %463
  %465 = fsub double %459, %424
  %466 = select i1 %464, double %465, double %460
  %467 = select i1 %464, double %459, double %461
  %468 = fmul double %466, 6.250000e-02
  %469 = fadd double %424, %468
  %470 = fcmp ogt double %469, %424
  %471 = fcmp oeq double %467, %459
  %472 = or i1 %470, %471
  br i1 %472, label %473, label %1214

473:                                              ; preds = %458
  %474 = call i64 @llvm.smax.i64(i64 %101, i64 0)
  br label %475

475:                                              ; preds = %473, %1244
  %476 = phi i64 [ 0, %473 ], [ %1246, %1244 ]
  %477 = phi i64 [ %474, %473 ], [ %1245, %1244 ]
  %478 = icmp sgt i64 %477, 0
  br i1 %478, label %1244, label %479

479:                                              ; preds = %475
  %480 = load i64, ptr %26, align 8, !noalias !15
  %481 = add i64 %480, -1
  %482 = call i64 @llvm.smax.i64(i64 %481, i64 0)
  br label %483

483:                                              ; preds = %1284, %479
  %484 = phi i64 [ 1, %479 ], [ %1253, %1284 ]
  %485 = phi i64 [ %482, %479 ], [ %1252, %1284 ]
  %486 = icmp slt i64 %485, 1
  br i1 %486, label %489, label %1251

487:                                              ; preds = %1284
  %488 = sext i32 %1281 to i64
  br label %491

489:                                              ; preds = %483
  store ptr null, ptr %21, align 8, !noalias !15
  %490 = call fastcc i32 @_combine_latest(ptr nonnull %21, ptr %31, i64 %30, ptr %36, i64 %35, ptr %41, i64 %40, ptr %52, ptr %87, ptr %102, ptr %119, i64 %118, i64 %480, i64 %89, double %466) #2
  switch i32 %490, label %1287 [
    i32 -2, label %491
    i32 0, label %491
  ], !prof !35

491:                                              ; preds = %489, %489, %487
  %492 = phi i64 [ %488, %487 ], [ 0, %489 ], [ 0, %489 ]
  br i1 %486, label %493, label %516

493:                                              ; preds = %491
  %494 = getelementptr i8, ptr %26, i64 32
  %495 = load i64, ptr %494, align 8, !noalias !15
  %496 = icmp eq i64 %495, 1
  br i1 %496, label %497, label %516

497:                                              ; preds = %493
  %498 = getelementptr i8, ptr %144, i64 24
  %499 = load i64, ptr %498, align 8, !noalias !15
  %500 = add nsw i64 %499, 1
  store i64 %500, ptr %498, align 8, !noalias !15
  store ptr null, ptr %8, align 8, !noalias !53
  store ptr null, ptr %9, align 8, !noalias !53
  store double %467, ptr %55, align 8, !noalias !53
  %501 = icmp sgt i64 %67, 0
  br i1 %501, label %502, label %505

502:                                              ; preds = %497
  store ptr null, ptr %8, align 8, !noalias !53
  %503 = call fastcc i32 @_sample(ptr nonnull %8, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %467) #2
  switch i32 %503, label %504 [
    i32 -2, label %505
    i32 0, label %505
  ], !prof !35

504:                                              ; preds = %502
  br label %505

505:                                              ; preds = %502, %502, %497, %504
  %506 = phi i32 [ %503, %504 ], [ 0, %497 ], [ 0, %502 ], [ 0, %502 ]
  switch i32 %506, label %513 [
    i32 -2, label %507
    i32 0, label %507
  ], !prof !35

507:                                              ; preds = %505, %505
  %508 = load i64, ptr %52, align 8, !noalias !60
  %509 = inttoptr i64 %508 to ptr
  %510 = inttoptr i64 %236 to ptr
  %511 = call i32 %509(ptr nonnull %55, ptr %92, ptr %60, ptr %63, ptr %510) #2, !noalias !60
  %512 = sext i32 %511 to i64
  br label %513

513:                                              ; preds = %505, %507
  %514 = phi i64 [ %512, %507 ], [ 0, %505 ]
  %515 = phi i32 [ 0, %507 ], [ %506, %505 ]
  switch i32 %515, label %1288 [
    i32 -2, label %516
    i32 0, label %516
  ], !prof !35

516:                                              ; preds = %513, %513, %493, %491
  %517 = phi i64 [ %492, %491 ], [ 0, %493 ], [ %514, %513 ], [ %514, %513 ]
  %518 = icmp slt i64 %517, 0
  br i1 %518, label %519, label %520

519:                                              ; preds = %516
  br label %1398

520:                                              ; preds = %516
  %521 = icmp eq i64 %517, 0
  br i1 %521, label %522, label %722

522:                                              ; preds = %520
  br i1 %233, label %682, label %523

523:                                              ; preds = %522
  %524 = getelementptr i8, ptr %52, i64 24
  %525 = load i64, ptr %524, align 8, !noalias !61
  %526 = getelementptr i8, ptr %52, i64 32
  %527 = load i64, ptr %526, align 8, !noalias !61
  %528 = load i64, ptr %231, align 8, !noalias !61
  %529 = load i64, ptr %26, align 8, !noalias !61
  %530 = add nsw i64 %529, 1
  %531 = call i64 @llvm.smax.i64(i64 %528, i64 0)
  br label %532

532:                                              ; preds = %523, %613
  %533 = phi i64 [ 0, %523 ], [ %615, %613 ]
  %534 = phi i64 [ %531, %523 ], [ %614, %613 ]
  %535 = icmp sgt i64 %534, 0
  br i1 %535, label %613, label %635

536:                                              ; preds = %645, %649
  %537 = phi i64 [ 0, %645 ], [ %651, %649 ]
  %538 = phi i64 [ %648, %645 ], [ %650, %649 ]
  %539 = phi double [ 0.000000e+00, %645 ], [ %681, %649 ]
  %540 = phi double [ 0.000000e+00, %645 ], [ %679, %649 ]
  %541 = icmp sgt i64 %538, 0
  br i1 %541, label %649, label %542

542:                                              ; preds = %536
  %543 = load i64, ptr %150, align 8, !noalias !61
  %544 = add nsw i64 %543, -3
  %545 = sub i64 %544, %525
  %546 = add nuw i64 %545, 3
  %547 = lshr i64 %546, 2
  %548 = icmp sgt i64 %545, 0
  %549 = select i1 %548, i64 %547, i64 0
  br label %550

550:                                              ; preds = %542, %574
  %551 = phi i64 [ %525, %542 ], [ %576, %574 ]
  %552 = phi i64 [ %549, %542 ], [ %575, %574 ]
  %553 = phi double [ 0.000000e+00, %542 ], [ %580, %574 ]
  %554 = phi double [ 0.000000e+00, %542 ], [ %584, %574 ]
  %555 = phi double [ 0.000000e+00, %542 ], [ %588, %574 ]
  %556 = phi double [ 0.000000e+00, %542 ], [ %592, %574 ]
  %557 = icmp sgt i64 %552, 0
  br i1 %557, label %574, label %558

558:                                              ; preds = %550
  %559 = sub nsw i64 %543, %525
  %560 = and i64 %559, 3
  %561 = sub nsw i64 %543, %560
  br label %562

562:                                              ; preds = %558, %593
  %563 = phi i64 [ %561, %558 ], [ %595, %593 ]
  %564 = phi i64 [ %560, %558 ], [ %594, %593 ]
  %565 = phi double [ %553, %558 ], [ %599, %593 ]
  %566 = icmp sgt i64 %564, 0
  br i1 %566, label %593, label %567

567:                                              ; preds = %562
  %568 = fadd double %565, %554
  %569 = fadd double %555, %556
  %570 = fadd double %568, %569
  %571 = fadd double %540, %570
  %572 = freeze double %571
  %573 = icmp eq i64 %528, 2
  br i1 %573, label %600, label %609

574:                                              ; preds = %550
  %575 = add nsw i64 %552, -1
  %576 = add i64 %551, 4
  %577 = getelementptr double, ptr %92, i64 %551
  %578 = load double, ptr %577, align 8, !noalias !65
  %579 = fmul double %578, 0.000000e+00
  %580 = fadd double %553, %579
  %581 = getelementptr i8, ptr %577, i64 8
  %582 = load double, ptr %581, align 8, !noalias !65
  %583 = fmul double %582, 0.000000e+00
  %584 = fadd double %554, %583
  %585 = getelementptr i8, ptr %577, i64 16
  %586 = load double, ptr %585, align 8, !noalias !65
  %587 = fmul double %586, 0.000000e+00
  %588 = fadd double %555, %587
  %589 = getelementptr i8, ptr %577, i64 24
  %590 = load double, ptr %589, align 8, !noalias !65
  %591 = fmul double %590, 0.000000e+00
  %592 = fadd double %556, %591
  br label %550

593:                                              ; preds = %562
  %594 = add nsw i64 %564, -1
  %595 = add i64 %563, 1
  %596 = getelementptr double, ptr %92, i64 %563
  %597 = load double, ptr %596, align 8, !noalias !65
  %598 = fmul double %597, 0.000000e+00
  %599 = fadd double %565, %598
  br label %562

600:                                              ; preds = %567
  %601 = fmul double %539, 1.000000e-02
  %602 = fadd double %572, %601
  %603 = sitofp i64 %525 to double
  %604 = fmul double %602, %603
  %605 = call double @llvm.sqrt.f64(double %604)
  %606 = fcmp oeq double %572, 0.000000e+00
  %607 = fdiv double %572, %605
  %608 = select i1 %606, double 0.000000e+00, double %607
  br label %689

609:                                              ; preds = %567
  %610 = sitofp i64 %525 to double
  %611 = fdiv double %572, %610
  %612 = call double @llvm.sqrt.f64(double %611)
  br label %689

613:                                              ; preds = %532
  %614 = add nsw i64 %534, -1
  %615 = add i64 %533, 1
  %616 = mul nsw i64 %533, %86
  %617 = shl i64 %616, 3
  %618 = add i64 %617, %111
  %619 = add nsw i64 %530, %533
  %620 = icmp slt i64 %619, 0
  %621 = select i1 %620, i64 %30, i64 0
  %622 = getelementptr i64, ptr %31, i64 %619
  %623 = getelementptr i64, ptr %622, i64 %621
  %624 = load i64, ptr %623, align 8, !noalias !69
  %625 = shl i64 %624, 3
  %626 = add i64 %625, %33
  %627 = add i64 %625, %38
  %628 = icmp slt i64 %619, -1
  %629 = select i1 %628, i64 %30, i64 0
  %630 = getelementptr i8, ptr %622, i64 8
  %631 = getelementptr i64, ptr %630, i64 %629
  %632 = load i64, ptr %631, align 8, !noalias !69
  %633 = xor i64 %624, -1
  %634 = add i64 %632, %633
  call fastcc void @pydy_combine(i64 %618, i64 %109, i64 %99, i64 %116, i64 %626, i64 %627, i64 %634, i64 1, i64 %527) #2, !noalias !69
  br label %532

635:                                              ; preds = %532
  %636 = icmp slt i64 %86, 0
  %637 = select i1 %636, i64 %113, i64 0
  %638 = add i64 %86, %637
  %639 = icmp slt i64 %638, 0
  br i1 %639, label %640, label %641, !prof !4

640:                                              ; preds = %635
  br label %641

641:                                              ; preds = %640, %635
  %642 = phi i64 [ 0, %640 ], [ %638, %635 ]
  %643 = icmp slt i64 %638, %113
  br i1 %643, label %645, label %644, !prof !8

644:                                              ; preds = %641
  br label %645

645:                                              ; preds = %644, %641
  %646 = phi i64 [ %113, %644 ], [ %642, %641 ]
  %647 = getelementptr double, ptr %114, i64 %646
  %648 = call i64 @llvm.smax.i64(i64 %525, i64 0)
  br label %536

649:                                              ; preds = %536
  %650 = add nsw i64 %538, -1
  %651 = add i64 %537, 1
  %652 = getelementptr double, ptr %87, i64 %537
  %653 = load double, ptr %652, align 8, !noalias !61
  %654 = getelementptr double, ptr %92, i64 %537
  %655 = load double, ptr %654, align 8, !noalias !61
  %656 = icmp slt i64 %537, 0
  %657 = select i1 %656, i64 %133, i64 0
  %658 = getelementptr double, ptr %134, i64 %537
  %659 = getelementptr double, ptr %658, i64 %657
  %660 = load double, ptr %659, align 8, !noalias !72
  %661 = select i1 %656, i64 %128, i64 0
  %662 = getelementptr double, ptr %129, i64 %537
  %663 = getelementptr double, ptr %662, i64 %661
  %664 = load double, ptr %663, align 8, !noalias !72
  %665 = call double @llvm.fabs.f64(double %653)
  %666 = call double @llvm.fabs.f64(double %655)
  %667 = fcmp ogt double %665, %666
  %668 = select i1 %667, double %665, double %666
  %669 = fmul double %664, %668
  %670 = fadd double %660, %669
  %671 = fdiv double 1.000000e+00, %670
  %672 = getelementptr double, ptr %114, i64 %537
  %673 = load double, ptr %672, align 8, !noalias !61
  %674 = fmul double %673, %671
  %675 = getelementptr double, ptr %647, i64 %537
  %676 = load double, ptr %675, align 8, !noalias !61
  %677 = fmul double %676, %671
  %678 = fmul double %674, %674
  %679 = fadd double %540, %678
  %680 = fmul double %677, %677
  %681 = fadd double %539, %680
  br label %536

682:                                              ; preds = %522
  %683 = call i64 @llvm.smax.i64(i64 %86, i64 0)
  br label %684

684:                                              ; preds = %682, %1289
  %685 = phi i64 [ 0, %682 ], [ %1291, %1289 ]
  %686 = phi i64 [ %683, %682 ], [ %1290, %1289 ]
  %687 = phi double [ 0.000000e+00, %682 ], [ %1298, %1289 ]
  %688 = icmp sgt i64 %686, 0
  br i1 %688, label %1289, label %689

689:                                              ; preds = %684, %609, %600
  %690 = phi double [ %687, %684 ], [ %612, %609 ], [ %608, %600 ]
  %691 = fcmp olt double %690, 1.000000e+00
  br i1 %691, label %692, label %722

692:                                              ; preds = %689
  br i1 %230, label %697, label %693

693:                                              ; preds = %692
  %694 = getelementptr i8, ptr %26, i64 32
  %695 = load i64, ptr %694, align 8, !noalias !15
  %696 = icmp eq i64 %695, 0
  br i1 %696, label %703, label %722

697:                                              ; preds = %692
  %698 = getelementptr i8, ptr %191, i64 56
  %699 = load i64, ptr %698, align 8, !noalias !15
  %700 = inttoptr i64 %699 to ptr
  %701 = call i64 %700(i64 %0, double %467, i64 %89) #2, !noalias !15
  %702 = icmp eq i64 %701, 0
  br i1 %702, label %703, label %722

703:                                              ; preds = %693, %697
  %704 = getelementptr i8, ptr %144, i64 24
  %705 = load i64, ptr %704, align 8, !noalias !15
  %706 = add nsw i64 %705, 1
  store i64 %706, ptr %704, align 8, !noalias !15
  store ptr null, ptr %6, align 8, !noalias !75
  store ptr null, ptr %7, align 8, !noalias !75
  store double %467, ptr %55, align 8, !noalias !75
  %707 = icmp sgt i64 %67, 0
  br i1 %707, label %708, label %711

708:                                              ; preds = %703
  store ptr null, ptr %6, align 8, !noalias !75
  %709 = call fastcc i32 @_sample(ptr nonnull %6, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %467) #2
  switch i32 %709, label %710 [
    i32 -2, label %711
    i32 0, label %711
  ], !prof !35

710:                                              ; preds = %708
  br label %711

711:                                              ; preds = %708, %708, %703, %710
  %712 = phi i32 [ %709, %710 ], [ 0, %703 ], [ 0, %708 ], [ 0, %708 ]
  switch i32 %712, label %718 [
    i32 -2, label %713
    i32 0, label %713
  ], !prof !35

713:                                              ; preds = %711, %711
  %714 = load i64, ptr %52, align 8, !noalias !82
  %715 = inttoptr i64 %714 to ptr
  %716 = inttoptr i64 %236 to ptr
  %717 = call i32 %715(ptr nonnull %55, ptr %92, ptr %60, ptr %63, ptr %716) #2, !noalias !82
  br label %718

718:                                              ; preds = %711, %713
  %719 = phi i32 [ %717, %713 ], [ 0, %711 ]
  %720 = phi i32 [ 0, %713 ], [ %712, %711 ]
  switch i32 %720, label %1302 [
    i32 -2, label %1299
    i32 0, label %1299
  ], !prof !35

721:                                              ; preds = %1299
  br label %1398

722:                                              ; preds = %1299, %697, %693, %689, %520
  %723 = phi i1 [ true, %520 ], [ false, %689 ], [ true, %693 ], [ true, %697 ], [ true, %1299 ]
  %724 = phi i64 [ %517, %520 ], [ 0, %689 ], [ 0, %693 ], [ 0, %697 ], [ %1300, %1299 ]
  %725 = phi double [ 0.000000e+00, %520 ], [ %690, %689 ], [ %690, %693 ], [ %690, %697 ], [ %690, %1299 ]
  %726 = phi i1 [ true, %520 ], [ true, %689 ], [ true, %693 ], [ false, %697 ], [ true, %1299 ]
  %727 = icmp eq i64 %724, 0
  %728 = and i1 %727, %723
  %729 = and i1 %728, %726
  br i1 %729, label %730, label %1145

730:                                              ; preds = %722
  %731 = load i64, ptr %430, align 8, !noalias !15
  %732 = add nsw i64 %731, 1
  store i64 %732, ptr %430, align 8, !noalias !15
  store double %467, ptr %139, align 8, !noalias !15
  %733 = getelementptr i8, ptr %139, i64 32
  store double %466, ptr %733, align 8, !noalias !15
  %734 = getelementptr i8, ptr %194, i64 8
  %735 = load i64, ptr %734, align 8, !noalias !15
  %736 = icmp eq i64 %735, 0
  br i1 %736, label %737, label %748

737:                                              ; preds = %730
  %738 = getelementptr i8, ptr %144, i64 48
  %739 = load i64, ptr %738, align 8, !noalias !15
  %740 = icmp slt i64 %739, 0
  %741 = select i1 %740, i64 %148, i64 0
  %742 = getelementptr double, ptr %149, i64 %739
  %743 = getelementptr double, ptr %742, i64 %741
  %744 = load double, ptr %743, align 8, !noalias !15
  %745 = fcmp ult double %744, %467
  br i1 %745, label %748, label %746

746:                                              ; preds = %737
  store i8 0, ptr %22, align 1, !noalias !15
  %747 = call fastcc i32 @write_reached(ptr nonnull %22, ptr %52, ptr %92, i64 %91, ptr nonnull %139, ptr nonnull %144, i64 %148, ptr %149, i64 %148, ptr %153, i64 %152) #2
  switch i32 %747, label %1303 [
    i32 -2, label %1026
    i32 0, label %1026
  ], !prof !35

748:                                              ; preds = %737, %730
  %749 = load i64, ptr %26, align 8, !noalias !15
  %750 = getelementptr i8, ptr %26, i64 16
  %751 = load i64, ptr %750, align 8, !noalias !15
  %752 = call i64 @llvm.smax.i64(i64 %751, i64 0)
  br label %753

753:                                              ; preds = %1351, %748
  %754 = phi i64 [ %749, %748 ], [ %756, %1351 ]
  %755 = phi i64 [ %752, %748 ], [ %1352, %1351 ]
  %756 = add i64 %754, 1
  %757 = icmp sgt i64 %755, 0
  br i1 %757, label %1304, label %762

758:                                              ; preds = %1351
  %759 = getelementptr i8, ptr %144, i64 72
  store i64 3, ptr %759, align 8, !noalias !15
  store double %424, ptr %139, align 8, !noalias !15
  %760 = icmp slt i32 %1349, 0
  %761 = select i1 %760, i64 -4, i64 2
  br label %1398

762:                                              ; preds = %753
  %763 = load i64, ptr %150, align 8, !noalias !83
  %764 = load i64, ptr %26, align 8, !noalias !83
  %765 = mul nsw i64 %764, %86
  %766 = icmp slt i64 %765, 0
  %767 = select i1 %766, i64 %118, i64 0
  %768 = add i64 %765, %767
  %769 = icmp slt i64 %768, 0
  br i1 %769, label %788, label %789, !prof !4

770:                                              ; preds = %816, %820
  %771 = phi i64 [ 0, %816 ], [ %822, %820 ]
  %772 = phi i64 [ %819, %816 ], [ %821, %820 ]
  %773 = icmp sgt i64 %772, 0
  br i1 %773, label %820, label %774

774:                                              ; preds = %770
  %775 = add nsw i64 %764, 1
  %776 = load i64, ptr %231, align 8, !noalias !83
  %777 = add nsw i64 %775, %776
  %778 = load i64, ptr %750, align 8, !noalias !83
  %779 = add nsw i64 %777, %778
  %780 = getelementptr i8, ptr %26, i64 24
  %781 = load i64, ptr %780, align 8, !noalias !83
  %782 = add i64 %781, -3
  %783 = call i64 @llvm.smax.i64(i64 %782, i64 0)
  br label %784

784:                                              ; preds = %774, %840
  %785 = phi i64 [ 3, %774 ], [ %842, %840 ]
  %786 = phi i64 [ %783, %774 ], [ %841, %840 ]
  %787 = icmp sgt i64 %786, 0
  br i1 %787, label %840, label %1355

788:                                              ; preds = %762
  br label %789

789:                                              ; preds = %788, %762
  %790 = phi i64 [ 0, %788 ], [ %768, %762 ]
  %791 = icmp slt i64 %768, %118
  br i1 %791, label %793, label %792, !prof !8

792:                                              ; preds = %789
  br label %793

793:                                              ; preds = %792, %789
  %794 = phi i64 [ %118, %792 ], [ %790, %789 ]
  %795 = getelementptr double, ptr %119, i64 %794
  %796 = icmp slt i64 %86, 0
  %797 = select i1 %796, i64 %123, i64 0
  %798 = add i64 %86, %797
  %799 = icmp slt i64 %798, 0
  br i1 %799, label %800, label %801, !prof !4

800:                                              ; preds = %793
  br label %801

801:                                              ; preds = %800, %793
  %802 = phi i64 [ 0, %800 ], [ %798, %793 ]
  %803 = icmp slt i64 %798, %123
  br i1 %803, label %805, label %804, !prof !8

804:                                              ; preds = %801
  br label %805

805:                                              ; preds = %804, %801
  %806 = phi i64 [ %123, %804 ], [ %802, %801 ]
  %807 = getelementptr double, ptr %124, i64 %806
  %808 = shl nsw i64 %86, 1
  %809 = add i64 %808, %797
  %810 = icmp slt i64 %809, 0
  br i1 %810, label %811, label %812, !prof !4

811:                                              ; preds = %805
  br label %812

812:                                              ; preds = %811, %805
  %813 = phi i64 [ 0, %811 ], [ %809, %805 ]
  %814 = icmp slt i64 %809, %123
  br i1 %814, label %816, label %815, !prof !8

815:                                              ; preds = %812
  br label %816

816:                                              ; preds = %815, %812
  %817 = phi i64 [ %123, %815 ], [ %813, %812 ]
  %818 = getelementptr double, ptr %124, i64 %817
  %819 = call i64 @llvm.smax.i64(i64 %763, i64 0)
  br label %770

820:                                              ; preds = %770
  %821 = add nsw i64 %772, -1
  %822 = add i64 %771, 1
  %823 = getelementptr double, ptr %92, i64 %771
  %824 = load double, ptr %823, align 8, !noalias !83
  %825 = getelementptr double, ptr %87, i64 %771
  %826 = load double, ptr %825, align 8, !noalias !83
  %827 = fsub double %824, %826
  %828 = getelementptr double, ptr %119, i64 %771
  %829 = load double, ptr %828, align 8, !noalias !83
  %830 = fmul double %466, %829
  %831 = fsub double %830, %827
  %832 = getelementptr double, ptr %124, i64 %771
  store double %827, ptr %832, align 8, !noalias !83
  %833 = getelementptr double, ptr %807, i64 %771
  store double %831, ptr %833, align 8, !noalias !83
  %834 = fsub double %827, %831
  %835 = getelementptr double, ptr %795, i64 %771
  %836 = load double, ptr %835, align 8, !noalias !83
  %837 = fmul double %466, %836
  %838 = fsub double %834, %837
  %839 = getelementptr double, ptr %818, i64 %771
  store double %838, ptr %839, align 8, !noalias !83
  br label %770

840:                                              ; preds = %784
  %841 = add nsw i64 %786, -1
  %842 = add i64 %785, 1
  %843 = mul nsw i64 %785, %86
  %844 = shl i64 %843, 3
  %845 = add i64 %844, %121
  %846 = add nsw i64 %779, %785
  %847 = getelementptr i8, ptr %52, i64 16
  %848 = load i64, ptr %847, align 8, !noalias !87
  %849 = icmp slt i64 %846, 3
  %850 = select i1 %849, i64 %30, i64 0
  %851 = getelementptr i64, ptr %31, i64 %846
  %852 = getelementptr i8, ptr %851, i64 -24
  %853 = getelementptr i64, ptr %852, i64 %850
  %854 = load i64, ptr %853, align 8, !noalias !91
  %855 = shl i64 %854, 3
  %856 = add i64 %855, %33
  %857 = add i64 %855, %38
  %858 = icmp slt i64 %846, 2
  %859 = select i1 %858, i64 %30, i64 0
  %860 = getelementptr i8, ptr %851, i64 -16
  %861 = getelementptr i64, ptr %860, i64 %859
  %862 = load i64, ptr %861, align 8, !noalias !91
  %863 = xor i64 %854, -1
  %864 = add i64 %862, %863
  call fastcc void @pydy_combine(i64 %845, i64 %109, i64 %99, i64 %116, i64 %856, i64 %857, i64 %864, i64 1, i64 %848) #2, !noalias !91
  br label %784

865:                                              ; preds = %1355
  %866 = getelementptr i8, ptr %194, i64 16
  %867 = load i64, ptr %866, align 8, !noalias !15
  %868 = inttoptr i64 %867 to ptr
  %869 = call i64 %868(i64 %0, double %424, double %466) #2, !noalias !15
  %870 = getelementptr i8, ptr %139, i64 48
  %871 = load double, ptr %870, align 8, !noalias !15
  br label %872

872:                                              ; preds = %865, %1355
  %873 = phi double [ %871, %865 ], [ 1.000000e+00, %1355 ]
  %874 = phi i64 [ %869, %865 ], [ 0, %1355 ]
  %875 = fcmp oeq double %873, 1.000000e+00
  br i1 %875, label %876, label %878

876:                                              ; preds = %872
  %877 = load double, ptr %139, align 8, !noalias !15
  br label %881

878:                                              ; preds = %872
  %879 = fmul double %873, %466
  %880 = fadd double %424, %879
  br label %881

881:                                              ; preds = %878, %876
  %882 = phi double [ %877, %876 ], [ %880, %878 ]
  %883 = icmp eq i64 %874, -4
  %884 = select i1 %883, i64 -4, i64 0
  br i1 %883, label %938, label %885

885:                                              ; preds = %881
  %886 = fcmp uge double %873, 1.000000e+00
  %887 = load i64, ptr %150, align 8, !noalias !15
  %888 = load i64, ptr %191, align 8, !noalias !15
  %889 = icmp eq i64 %888, 1
  %890 = getelementptr i8, ptr %144, i64 48
  %891 = load i64, ptr %890, align 8, !noalias !15
  %892 = icmp slt i64 %891, %148
  br i1 %892, label %893, label %936

893:                                              ; preds = %885
  %894 = icmp slt i64 %891, 0
  %895 = select i1 %894, i64 %148, i64 0
  %896 = getelementptr double, ptr %149, i64 %891
  %897 = getelementptr double, ptr %896, i64 %895
  %898 = load double, ptr %897, align 8, !noalias !15
  %899 = fcmp uge double %898, %882
  %900 = fcmp une double %898, %882
  %901 = or i1 %900, %886
  %902 = and i1 %899, %901
  br i1 %902, label %936, label %903

903:                                              ; preds = %926, %893
  %904 = phi i64 [ %891, %893 ], [ %924, %926 ]
  %905 = icmp slt i64 %904, 0
  %906 = select i1 %905, i64 %148, i64 0
  %907 = getelementptr double, ptr %149, i64 %904
  %908 = getelementptr double, ptr %907, i64 %906
  %909 = load double, ptr %908, align 8, !noalias !15
  %910 = fsub double %909, %424
  %911 = fdiv double %910, %466
  %912 = mul nsw i64 %904, %887
  %913 = shl i64 %912, 3
  %914 = add i64 %913, %1
  %915 = call i64 @llvm.smax.i64(i64 %106, i64 0)
  br label %1358

916:                                              ; preds = %1362
  %917 = getelementptr i8, ptr %191, i64 56
  %918 = load i64, ptr %917, align 8, !noalias !15
  %919 = load double, ptr %908, align 8, !noalias !15
  %920 = inttoptr i64 %918 to ptr
  %921 = call i64 %920(i64 %0, double %919, i64 %914) #2, !noalias !15
  %922 = icmp eq i64 %921, 0
  br i1 %922, label %923, label %938

923:                                              ; preds = %1362, %916
  %924 = add nsw i64 %904, 1
  %925 = icmp slt i64 %924, %148
  br i1 %925, label %926, label %936

926:                                              ; preds = %923
  %927 = icmp slt i64 %904, -1
  %928 = select i1 %927, i64 %148, i64 0
  %929 = getelementptr double, ptr %149, i64 %924
  %930 = getelementptr double, ptr %929, i64 %928
  %931 = load double, ptr %930, align 8, !noalias !15
  %932 = fcmp uge double %931, %882
  %933 = fcmp une double %931, %882
  %934 = or i1 %933, %886
  %935 = and i1 %932, %934
  br i1 %935, label %936, label %903

936:                                              ; preds = %926, %893, %923, %885
  %937 = phi i64 [ %891, %893 ], [ %924, %926 ], [ %924, %923 ], [ %891, %885 ]
  store i64 %937, ptr %890, align 8, !noalias !15
  br label %938

938:                                              ; preds = %916, %936, %881
  %939 = phi i64 [ %884, %881 ], [ 0, %936 ], [ %921, %916 ]
  %940 = icmp eq i64 %939, 0
  %941 = icmp ne i64 %874, 0
  %942 = select i1 %940, i1 %941, i1 false
  %943 = fcmp olt double %873, 1.000000e+00
  %944 = and i1 %942, %943
  br i1 %944, label %945, label %983

945:                                              ; preds = %938
  %946 = call i64 @llvm.smax.i64(i64 %106, i64 0)
  br label %947

947:                                              ; preds = %945, %971
  %948 = phi i64 [ 0, %945 ], [ %973, %971 ]
  %949 = phi i64 [ %946, %945 ], [ %972, %971 ]
  %950 = icmp sgt i64 %949, 0
  br i1 %950, label %971, label %951

951:                                              ; preds = %947
  %952 = load i64, ptr %780, align 8, !noalias !94
  %953 = getelementptr i8, ptr %52, i64 16
  %954 = load i64, ptr %953, align 8, !noalias !94
  call fastcc void @pydy_nested(i64 %94, i64 %84, i64 %121, i64 %86, i64 %952, i64 %104, i64 %954) #2, !noalias !94
  %955 = call i64 @llvm.smax.i64(i64 %91, i64 0)
  br label %956

956:                                              ; preds = %960, %951
  %957 = phi i64 [ 0, %951 ], [ %962, %960 ]
  %958 = phi i64 [ %955, %951 ], [ %961, %960 ]
  %959 = icmp sgt i64 %958, 0
  br i1 %959, label %960, label %1373

960:                                              ; preds = %956
  %961 = add nsw i64 %958, -1
  %962 = add i64 %957, 1
  %963 = icmp slt i64 %957, 0
  %964 = select i1 %963, i64 %96, i64 0
  %965 = getelementptr double, ptr %97, i64 %957
  %966 = getelementptr double, ptr %965, i64 %964
  %967 = load double, ptr %966, align 8, !noalias !98
  %968 = select i1 %963, i64 %91, i64 0
  %969 = getelementptr double, ptr %92, i64 %957
  %970 = getelementptr double, ptr %969, i64 %968
  store double %967, ptr %970, align 8, !noalias !98
  br label %956

971:                                              ; preds = %947
  %972 = add nsw i64 %949, -1
  %973 = add i64 %948, 1
  %974 = icmp slt i64 %948, 0
  %975 = select i1 %974, i64 %106, i64 0
  %976 = getelementptr double, ptr %107, i64 %948
  %977 = getelementptr double, ptr %976, i64 %975
  store double %873, ptr %977, align 8, !noalias !94
  br label %947

978:                                              ; preds = %1373
  %979 = getelementptr i8, ptr %191, i64 56
  %980 = load i64, ptr %979, align 8, !noalias !15
  %981 = inttoptr i64 %980 to ptr
  %982 = call i64 %981(i64 %0, double %882, i64 %89) #2, !noalias !15
  br label %983

983:                                              ; preds = %1373, %978, %938
  %984 = phi i64 [ %982, %978 ], [ 0, %1373 ], [ %939, %938 ]
  %985 = icmp eq i64 %984, 0
  br i1 %985, label %987, label %986

986:                                              ; preds = %983
  store double %424, ptr %139, align 8, !noalias !15
  store double %466, ptr %243, align 8, !noalias !15
  br label %1009

987:                                              ; preds = %983
  br i1 %875, label %988, label %990

988:                                              ; preds = %987
  store i8 0, ptr %23, align 1, !noalias !15
  %989 = call fastcc i32 @write_reached(ptr nonnull %23, ptr %52, ptr %92, i64 %91, ptr nonnull %139, ptr nonnull %144, i64 %148, ptr %149, i64 %148, ptr %153, i64 %152) #2
  switch i32 %989, label %1376 [
    i32 -2, label %990
    i32 0, label %990
  ], !prof !35

990:                                              ; preds = %988, %988, %987
  %991 = icmp eq i64 %874, 0
  br i1 %991, label %1009, label %992

992:                                              ; preds = %990
  %993 = call i64 @llvm.smax.i64(i64 %86, i64 0)
  br label %994

994:                                              ; preds = %998, %992
  %995 = phi i64 [ 0, %992 ], [ %1000, %998 ]
  %996 = phi i64 [ %993, %992 ], [ %999, %998 ]
  %997 = icmp sgt i64 %996, 0
  br i1 %997, label %998, label %1377

998:                                              ; preds = %994
  %999 = add nsw i64 %996, -1
  %1000 = add i64 %995, 1
  %1001 = icmp slt i64 %995, 0
  %1002 = select i1 %1001, i64 %91, i64 0
  %1003 = getelementptr double, ptr %92, i64 %995
  %1004 = getelementptr double, ptr %1003, i64 %1002
  %1005 = load double, ptr %1004, align 8, !noalias !101
  %1006 = select i1 %1001, i64 %86, i64 0
  %1007 = getelementptr double, ptr %87, i64 %995
  %1008 = getelementptr double, ptr %1007, i64 %1006
  store double %1005, ptr %1008, align 8, !noalias !101
  br label %994

1009:                                             ; preds = %990, %1377, %986
  %1010 = phi i1 [ false, %986 ], [ false, %1377 ], [ true, %990 ]
  %1011 = phi i64 [ %984, %986 ], [ %874, %1377 ], [ 0, %990 ]
  %1012 = icmp ne i64 %1011, 6
  %1013 = select i1 %1012, i1 true, i1 %233
  br i1 %1013, label %1024, label %1014

1014:                                             ; preds = %1009
  %1015 = load i64, ptr %734, align 8, !noalias !15
  %1016 = icmp eq i64 %1015, 0
  br i1 %1016, label %1017, label %1024

1017:                                             ; preds = %1014
  %1018 = load i64, ptr %430, align 8, !noalias !15
  %1019 = add nsw i64 %1018, -1
  store i64 %1019, ptr %430, align 8, !noalias !15
  %1020 = load i64, ptr %432, align 8, !noalias !15
  %1021 = add nsw i64 %1020, 1
  store i64 %1021, ptr %432, align 8, !noalias !15
  %1022 = getelementptr i8, ptr %144, i64 72
  store i64 6, ptr %1022, align 8, !noalias !15
  %1023 = getelementptr i8, ptr %139, i64 40
  store double 1.000000e+00, ptr %1023, align 8, !noalias !15
  br label %1210

1024:                                             ; preds = %1009, %1014
  br i1 %1010, label %1026, label %1025

1025:                                             ; preds = %1024
  br label %1398

1026:                                             ; preds = %746, %746, %1024
  br i1 %233, label %1134, label %1027

1027:                                             ; preds = %1026
  %1028 = getelementptr i8, ptr %139, i64 40
  %1029 = load double, ptr %1028, align 8, !noalias !15
  %1030 = getelementptr i8, ptr %49, i64 24
  %1031 = load double, ptr %1030, align 8, !noalias !104
  %1032 = fcmp ogt double %725, 1.000000e-10
  %1033 = select i1 %1032, double %725, double 1.000000e-10
  %1034 = getelementptr i8, ptr %49, i64 8
  %1035 = load double, ptr %1034, align 8, !noalias !104
  %1036 = fneg double %1035
  %1037 = bitcast double %1033 to i64
  %1038 = add nsw i64 %1037, -4604544271217802189
  %1039 = ashr i64 %1038, 52
  %1040 = and i64 %1038, -4503599627370496
  %1041 = sub i64 %1037, %1040
  %1042 = bitcast i64 %1041 to double
  %1043 = fadd double %1042, -1.000000e+00
  %1044 = fadd double %1042, 1.000000e+00
  %1045 = fdiv double %1043, %1044
  %1046 = fmul double %1045, %1045
  %1047 = call double @llvm.fma.f64(double %1046, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1048 = call double @llvm.fma.f64(double %1047, double %1046, double 0x3FE2776C50EF9BFE)
  %1049 = call double @llvm.fma.f64(double %1048, double %1046, double 0x3FEEC709DC3A03FD)
  %1050 = call double @llvm.fma.f64(double %1049, double %1046, double 0x40071547652B82FE)
  %1051 = fmul double %1050, %1045
  %1052 = trunc nsw i64 %1039 to i32
  %1053 = sitofp i32 %1052 to double
  %1054 = fadd double %1051, %1053
  %1055 = fmul double %1054, %1036
  %1056 = fcmp ogt double %1055, -1.000000e+03
  %1057 = select i1 %1056, double %1055, double -1.000000e+03
  %1058 = fcmp olt double %1057, 1.000000e+03
  %1059 = select i1 %1058, double %1057, double 1.000000e+03
  %1060 = call double @llvm.rint.f64(double %1059)
  %1061 = fsub double %1059, %1060
  %1062 = call double @llvm.fma.f64(double %1061, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1063 = call double @llvm.fma.f64(double %1062, double %1061, double 0x3F55D87FE78A6730)
  %1064 = call double @llvm.fma.f64(double %1063, double %1061, double 0x3F83B2AB6FBA4E77)
  %1065 = call double @llvm.fma.f64(double %1064, double %1061, double 0x3FAC6B08D704A0BF)
  %1066 = call double @llvm.fma.f64(double %1065, double %1061, double 0x3FCEBFBDFF82C58E)
  %1067 = call double @llvm.fma.f64(double %1066, double %1061, double 0x3FE62E42FEFA39EF)
  %1068 = call double @llvm.fma.f64(double %1067, double %1061, double 1.000000e+00)
  %1069 = fptosi double %1060 to i32
  %1070 = zext i32 %1069 to i64
  %1071 = shl i64 %1070, 52
  %1072 = bitcast double %1068 to i64
  %1073 = add i64 %1071, %1072
  %1074 = bitcast i64 %1073 to double
  %1075 = fmul double %1031, %1074
  %1076 = getelementptr i8, ptr %49, i64 16
  %1077 = load double, ptr %1076, align 8, !noalias !104
  %1078 = fcmp une double %1077, 0.000000e+00
  br i1 %1078, label %1079, label %1120

1079:                                             ; preds = %1027
  %1080 = getelementptr i8, ptr %139, i64 24
  %1081 = load i64, ptr %1080, align 8, !noalias !15
  %1082 = add i64 %1081, -4604544271217802189
  %1083 = ashr i64 %1082, 52
  %1084 = and i64 %1082, -4503599627370496
  %1085 = sub i64 %1081, %1084
  %1086 = bitcast i64 %1085 to double
  %1087 = fadd double %1086, -1.000000e+00
  %1088 = fadd double %1086, 1.000000e+00
  %1089 = fdiv double %1087, %1088
  %1090 = fmul double %1089, %1089
  %1091 = call double @llvm.fma.f64(double %1090, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1092 = call double @llvm.fma.f64(double %1091, double %1090, double 0x3FE2776C50EF9BFE)
  %1093 = call double @llvm.fma.f64(double %1092, double %1090, double 0x3FEEC709DC3A03FD)
  %1094 = call double @llvm.fma.f64(double %1093, double %1090, double 0x40071547652B82FE)
  %1095 = fmul double %1094, %1089
  %1096 = trunc nsw i64 %1083 to i32
  %1097 = sitofp i32 %1096 to double
  %1098 = fadd double %1095, %1097
  %1099 = fmul double %1098, %1077
  %1100 = fcmp ogt double %1099, -1.000000e+03
  %1101 = select i1 %1100, double %1099, double -1.000000e+03
  %1102 = fcmp olt double %1101, 1.000000e+03
  %1103 = select i1 %1102, double %1101, double 1.000000e+03
  %1104 = call double @llvm.rint.f64(double %1103)
  %1105 = fsub double %1103, %1104
  %1106 = call double @llvm.fma.f64(double %1105, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1107 = call double @llvm.fma.f64(double %1106, double %1105, double 0x3F55D87FE78A6730)
  %1108 = call double @llvm.fma.f64(double %1107, double %1105, double 0x3F83B2AB6FBA4E77)
  %1109 = call double @llvm.fma.f64(double %1108, double %1105, double 0x3FAC6B08D704A0BF)
  %1110 = call double @llvm.fma.f64(double %1109, double %1105, double 0x3FCEBFBDFF82C58E)
  %1111 = call double @llvm.fma.f64(double %1110, double %1105, double 0x3FE62E42FEFA39EF)
  %1112 = call double @llvm.fma.f64(double %1111, double %1105, double 1.000000e+00)
  %1113 = fptosi double %1104 to i32
  %1114 = zext i32 %1113 to i64
  %1115 = shl i64 %1114, 52
  %1116 = bitcast double %1112 to i64
  %1117 = add i64 %1115, %1116
  %1118 = bitcast i64 %1117 to double
  %1119 = fmul double %1075, %1118
  br label %1120

1120:                                             ; preds = %1079, %1027
  %1121 = phi double [ %1119, %1079 ], [ %1075, %1027 ]
  %1122 = getelementptr i8, ptr %49, i64 32
  %1123 = load double, ptr %1122, align 8, !noalias !104
  %1124 = fcmp ogt double %1121, %1123
  %1125 = select i1 %1124, double %1121, double %1123
  %1126 = fcmp olt double %1029, %1125
  %1127 = select i1 %1126, double %1029, double %1125
  %1128 = fmul double %466, %1127
  %1129 = fcmp ogt double %725, 1.000000e-04
  %1130 = select i1 %1129, double %725, double 1.000000e-04
  %1131 = getelementptr i8, ptr %139, i64 24
  store double %1130, ptr %1131, align 8, !noalias !15
  %1132 = getelementptr i8, ptr %49, i64 40
  %1133 = load double, ptr %1132, align 8, !noalias !15
  store double %1133, ptr %1028, align 8, !noalias !15
  br label %1134

1134:                                             ; preds = %1120, %1026
  %1135 = phi double [ %1128, %1120 ], [ %423, %1026 ]
  %1136 = call i64 @llvm.smax.i64(i64 %86, i64 0)
  br label %1137

1137:                                             ; preds = %1134, %1378
  %1138 = phi i64 [ 0, %1134 ], [ %1380, %1378 ]
  %1139 = phi i64 [ %1136, %1134 ], [ %1379, %1378 ]
  %1140 = icmp sgt i64 %1139, 0
  br i1 %1140, label %1378, label %1141

1141:                                             ; preds = %1137
  %1142 = getelementptr i8, ptr %144, i64 48
  %1143 = load i64, ptr %1142, align 8, !noalias !15
  %1144 = icmp eq i64 %1143, %148
  br i1 %1144, label %1215, label %422

1145:                                             ; preds = %722
  %1146 = load i64, ptr %432, align 8, !noalias !15
  %1147 = add nsw i64 %1146, 1
  store i64 %1147, ptr %432, align 8, !noalias !15
  %1148 = and i1 %726, %727
  br i1 %1148, label %1149, label %1152

1149:                                             ; preds = %1145
  %1150 = fsub double %725, %725
  %1151 = fcmp ord double %1150, 0.000000e+00
  br label %1152

1152:                                             ; preds = %1145, %1149
  %1153 = phi i1 [ %1151, %1149 ], [ false, %1145 ]
  %1154 = select i1 %1153, i64 2, i64 4
  %1155 = select i1 %726, i64 %1154, i64 6
  %1156 = select i1 %727, i64 %1155, i64 3
  %1157 = getelementptr i8, ptr %144, i64 72
  store i64 %1156, ptr %1157, align 8, !noalias !15
  br i1 %233, label %1213, label %1158

1158:                                             ; preds = %1152
  %1159 = getelementptr i8, ptr %49, i64 24
  %1160 = load double, ptr %1159, align 8, !noalias !107
  %1161 = fcmp ogt double %725, 1.000000e-10
  %1162 = select i1 %1161, double %725, double 1.000000e-10
  %1163 = bitcast double %1162 to i64
  %1164 = add nsw i64 %1163, -4604544271217802189
  %1165 = and i64 %1164, -4503599627370496
  %1166 = sub i64 %1163, %1165
  %1167 = bitcast i64 %1166 to double
  %1168 = fadd double %1167, -1.000000e+00
  %1169 = fadd double %1167, 1.000000e+00
  %1170 = fdiv double %1168, %1169
  %1171 = fmul double %1170, %1170
  %1172 = call double @llvm.fma.f64(double %1171, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1173 = call double @llvm.fma.f64(double %1172, double %1171, double 0x3FE2776C50EF9BFE)
  %1174 = call double @llvm.fma.f64(double %1173, double %1171, double 0x3FEEC709DC3A03FD)
  %1175 = call double @llvm.fma.f64(double %1174, double %1171, double 0x40071547652B82FE)
  %1176 = fmul double %1175, %1170
  %1177 = ashr i64 %1164, 52
  %1178 = trunc nsw i64 %1177 to i32
  %1179 = sitofp i32 %1178 to double
  %1180 = fadd double %1176, %1179
  %1181 = load double, ptr %49, align 8, !noalias !107
  %1182 = fneg double %1181
  %1183 = fmul double %1180, %1182
  %1184 = fcmp ogt double %1183, -1.000000e+03
  %1185 = select i1 %1184, double %1183, double -1.000000e+03
  %1186 = fcmp olt double %1185, 1.000000e+03
  %1187 = select i1 %1186, double %1185, double 1.000000e+03
  %1188 = call double @llvm.rint.f64(double %1187)
  %1189 = fptosi double %1188 to i32
  %1190 = zext i32 %1189 to i64
  %1191 = shl i64 %1190, 52
  %1192 = fsub double %1187, %1188
  %1193 = call double @llvm.fma.f64(double %1192, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1194 = call double @llvm.fma.f64(double %1193, double %1192, double 0x3F55D87FE78A6730)
  %1195 = call double @llvm.fma.f64(double %1194, double %1192, double 0x3F83B2AB6FBA4E77)
  %1196 = call double @llvm.fma.f64(double %1195, double %1192, double 0x3FAC6B08D704A0BF)
  %1197 = call double @llvm.fma.f64(double %1196, double %1192, double 0x3FCEBFBDFF82C58E)
  %1198 = call double @llvm.fma.f64(double %1197, double %1192, double 0x3FE62E42FEFA39EF)
  %1199 = call double @llvm.fma.f64(double %1198, double %1192, double 1.000000e+00)
  %1200 = bitcast double %1199 to i64
  %1201 = add i64 %1191, %1200
  %1202 = bitcast i64 %1201 to double
  %1203 = fmul double %1160, %1202
  %1204 = getelementptr i8, ptr %49, i64 32
  %1205 = load double, ptr %1204, align 8, !noalias !107
  %1206 = fcmp ogt double %1203, %1205
  %1207 = select i1 %1206, double %1203, double %1205
  %1208 = select i1 %1153, double %1207, double 2.500000e-01
  %1209 = getelementptr i8, ptr %139, i64 40
  store double 1.000000e+00, ptr %1209, align 8, !noalias !15
  br label %1210

1210:                                             ; preds = %1017, %1158
  %1211 = phi double [ %1208, %1158 ], [ 2.500000e-01, %1017 ]
  %1212 = fmul double %466, %1211
  br label %419

1213:                                             ; preds = %1152
  store double %466, ptr %243, align 8, !noalias !15
  br label %1398

1214:                                             ; preds = %458
  store double %466, ptr %243, align 8, !noalias !15
  br label %1398

1215:                                             ; preds = %1141
  store double %1135, ptr %243, align 8, !noalias !15
  br label %1398

1216:                                             ; preds = %261, %261
  %1217 = icmp eq i32 %262, 0
  br i1 %1217, label %268, label %264

1218:                                             ; preds = %261
  br label %1398

1219:                                             ; preds = %268, %268
  %1220 = load i8, ptr %19, align 1, !noalias !15
  %1221 = icmp eq i8 %1220, 0
  br i1 %1221, label %275, label %274

1222:                                             ; preds = %268
  br label %1398

1223:                                             ; preds = %277, %285
  br label %1398

1224:                                             ; preds = %298
  %1225 = add nsw i64 %300, -1
  %1226 = add i64 %299, 1
  %1227 = icmp slt i64 %299, 0
  %1228 = select i1 %1227, i64 %86, i64 0
  %1229 = getelementptr double, ptr %87, i64 %299
  %1230 = getelementptr double, ptr %1229, i64 %1228
  %1231 = load double, ptr %1230, align 8, !noalias !15
  %1232 = select i1 %1227, i64 %118, i64 0
  %1233 = getelementptr double, ptr %119, i64 %299
  %1234 = getelementptr double, ptr %1233, i64 %1232
  %1235 = load double, ptr %1234, align 8, !noalias !15
  %1236 = fmul double %296, %1235
  %1237 = fadd double %1231, %1236
  %1238 = select i1 %1227, i64 %96, i64 0
  %1239 = getelementptr double, ptr %97, i64 %299
  %1240 = getelementptr double, ptr %1239, i64 %1238
  store double %1237, ptr %1240, align 8, !noalias !15
  br label %298

1241:                                             ; preds = %319, %319
  br i1 %320, label %324, label %322

1242:                                             ; preds = %319
  br label %1398

1243:                                             ; preds = %333
  br label %1398

1244:                                             ; preds = %475
  %1245 = add nsw i64 %477, -1
  %1246 = add i64 %476, 1
  %1247 = icmp slt i64 %476, 0
  %1248 = select i1 %1247, i64 %101, i64 0
  %1249 = getelementptr double, ptr %102, i64 %476
  %1250 = getelementptr double, ptr %1249, i64 %1248
  store double %466, ptr %1250, align 8, !noalias !15
  br label %475

1251:                                             ; preds = %483
  %1252 = add nsw i64 %485, -1
  %1253 = add i64 %484, 1
  store ptr null, ptr %20, align 8, !noalias !15
  %1254 = call fastcc i32 @_combine_latest(ptr nonnull %20, ptr %31, i64 %30, ptr %36, i64 %35, ptr %41, i64 %40, ptr %52, ptr %87, ptr %102, ptr %119, i64 %118, i64 %484, i64 %94, double %466) #2
  switch i32 %1254, label %1283 [
    i32 -2, label %1255
    i32 0, label %1255
  ], !prof !35

1255:                                             ; preds = %1251, %1251
  %1256 = mul nsw i64 %484, %86
  %1257 = shl i64 %1256, 3
  %1258 = add i64 %1257, %116
  %1259 = getelementptr i8, ptr %144, i64 24
  %1260 = load i64, ptr %1259, align 8, !noalias !15
  %1261 = add nsw i64 %1260, 1
  store i64 %1261, ptr %1259, align 8, !noalias !15
  %1262 = icmp slt i64 %484, 0
  %1263 = select i1 %1262, i64 %45, i64 0
  %1264 = getelementptr double, ptr %46, i64 %484
  %1265 = getelementptr double, ptr %1264, i64 %1263
  %1266 = load double, ptr %1265, align 8, !noalias !15
  %1267 = fmul double %1266, %466
  %1268 = fadd double %424, %1267
  store ptr null, ptr %10, align 8, !noalias !110
  store ptr null, ptr %11, align 8, !noalias !110
  store double %1268, ptr %55, align 8, !noalias !110
  %1269 = icmp sgt i64 %67, 0
  br i1 %1269, label %1270, label %1273

1270:                                             ; preds = %1255
  store ptr null, ptr %10, align 8, !noalias !110
  %1271 = call fastcc i32 @_sample(ptr nonnull %10, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %1268) #2
  switch i32 %1271, label %1272 [
    i32 -2, label %1273
    i32 0, label %1273
  ], !prof !35

1272:                                             ; preds = %1270
  br label %1273

1273:                                             ; preds = %1270, %1270, %1255, %1272
  %1274 = phi i32 [ %1271, %1272 ], [ 0, %1255 ], [ 0, %1270 ], [ 0, %1270 ]
  switch i32 %1274, label %1280 [
    i32 -2, label %1275
    i32 0, label %1275
  ], !prof !35

1275:                                             ; preds = %1273, %1273
  %1276 = load i64, ptr %52, align 8, !noalias !117
  %1277 = inttoptr i64 %1276 to ptr
  %1278 = inttoptr i64 %1258 to ptr
  %1279 = call i32 %1277(ptr nonnull %55, ptr %97, ptr %60, ptr %63, ptr %1278) #2, !noalias !117
  br label %1280

1280:                                             ; preds = %1273, %1275
  %1281 = phi i32 [ %1279, %1275 ], [ 0, %1273 ]
  %1282 = phi i32 [ 0, %1275 ], [ %1274, %1273 ]
  switch i32 %1282, label %1286 [
    i32 -2, label %1284
    i32 0, label %1284
  ], !prof !35

1283:                                             ; preds = %1251
  br label %1398

1284:                                             ; preds = %1280, %1280
  %1285 = icmp eq i32 %1281, 0
  br i1 %1285, label %483, label %487

1286:                                             ; preds = %1280
  br label %1398

1287:                                             ; preds = %489
  br label %1398

1288:                                             ; preds = %513
  br label %1398

1289:                                             ; preds = %684
  %1290 = add nsw i64 %686, -1
  %1291 = add i64 %685, 1
  %1292 = icmp slt i64 %685, 0
  %1293 = select i1 %1292, i64 %91, i64 0
  %1294 = getelementptr double, ptr %92, i64 %685
  %1295 = getelementptr double, ptr %1294, i64 %1293
  %1296 = load double, ptr %1295, align 8, !noalias !15
  %1297 = fmul double %1296, 0.000000e+00
  %1298 = fadd double %687, %1297
  br label %684

1299:                                             ; preds = %718, %718
  %1300 = sext i32 %719 to i64
  %1301 = icmp slt i32 %719, 0
  br i1 %1301, label %721, label %722

1302:                                             ; preds = %718
  br label %1398

1303:                                             ; preds = %746
  br label %1398

1304:                                             ; preds = %753
  %1305 = load i64, ptr %231, align 8, !noalias !15
  %1306 = add nsw i64 %756, %1305
  %1307 = getelementptr i8, ptr %52, i64 16
  %1308 = load i64, ptr %1307, align 8, !noalias !118
  %1309 = icmp slt i64 %1306, 0
  %1310 = select i1 %1309, i64 %30, i64 0
  %1311 = getelementptr i64, ptr %31, i64 %1306
  %1312 = getelementptr i64, ptr %1311, i64 %1310
  %1313 = load i64, ptr %1312, align 8, !noalias !122
  %1314 = shl i64 %1313, 3
  %1315 = add i64 %1314, %33
  %1316 = add i64 %1314, %38
  %1317 = icmp slt i64 %1306, -1
  %1318 = select i1 %1317, i64 %30, i64 0
  %1319 = getelementptr i8, ptr %1311, i64 8
  %1320 = getelementptr i64, ptr %1319, i64 %1318
  %1321 = load i64, ptr %1320, align 8, !noalias !122
  %1322 = xor i64 %1313, -1
  %1323 = add i64 %1321, %1322
  call fastcc void @pydy_combine(i64 %94, i64 %84, i64 %99, i64 %116, i64 %1315, i64 %1316, i64 %1323, i64 1, i64 %1308) #2, !noalias !122
  %1324 = mul nsw i64 %756, %86
  %1325 = shl i64 %1324, 3
  %1326 = add i64 %1325, %116
  %1327 = getelementptr i8, ptr %144, i64 24
  %1328 = load i64, ptr %1327, align 8, !noalias !15
  %1329 = add nsw i64 %1328, 1
  store i64 %1329, ptr %1327, align 8, !noalias !15
  %1330 = icmp slt i64 %756, 0
  %1331 = select i1 %1330, i64 %45, i64 0
  %1332 = getelementptr double, ptr %46, i64 %756
  %1333 = getelementptr double, ptr %1332, i64 %1331
  %1334 = load double, ptr %1333, align 8, !noalias !15
  %1335 = fmul double %1334, %466
  %1336 = fadd double %424, %1335
  store ptr null, ptr %4, align 8, !noalias !125
  store ptr null, ptr %5, align 8, !noalias !125
  store double %1336, ptr %55, align 8, !noalias !125
  %1337 = icmp sgt i64 %67, 0
  br i1 %1337, label %1338, label %1341

1338:                                             ; preds = %1304
  store ptr null, ptr %4, align 8, !noalias !125
  %1339 = call fastcc i32 @_sample(ptr nonnull %4, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %1336) #2
  switch i32 %1339, label %1340 [
    i32 -2, label %1341
    i32 0, label %1341
  ], !prof !35

1340:                                             ; preds = %1338
  br label %1341

1341:                                             ; preds = %1338, %1338, %1304, %1340
  %1342 = phi i32 [ %1339, %1340 ], [ 0, %1304 ], [ 0, %1338 ], [ 0, %1338 ]
  switch i32 %1342, label %1348 [
    i32 -2, label %1343
    i32 0, label %1343
  ], !prof !35

1343:                                             ; preds = %1341, %1341
  %1344 = load i64, ptr %52, align 8, !noalias !132
  %1345 = inttoptr i64 %1344 to ptr
  %1346 = inttoptr i64 %1326 to ptr
  %1347 = call i32 %1345(ptr nonnull %55, ptr %97, ptr %60, ptr %63, ptr %1346) #2, !noalias !132
  br label %1348

1348:                                             ; preds = %1341, %1343
  %1349 = phi i32 [ %1347, %1343 ], [ 0, %1341 ]
  %1350 = phi i32 [ 0, %1343 ], [ %1342, %1341 ]
  switch i32 %1350, label %1354 [
    i32 -2, label %1351
    i32 0, label %1351
  ], !prof !35

1351:                                             ; preds = %1348, %1348
  %1352 = add nsw i64 %755, -1
  %1353 = icmp eq i32 %1349, 0
  br i1 %1353, label %753, label %758

1354:                                             ; preds = %1348
  br label %1398

1355:                                             ; preds = %784
  %1356 = load i64, ptr %734, align 8, !noalias !15
  %1357 = icmp sgt i64 %1356, 0
  br i1 %1357, label %865, label %872

1358:                                             ; preds = %903, %1366
  %1359 = phi i64 [ 0, %903 ], [ %1368, %1366 ]
  %1360 = phi i64 [ %915, %903 ], [ %1367, %1366 ]
  %1361 = icmp sgt i64 %1360, 0
  br i1 %1361, label %1366, label %1362

1362:                                             ; preds = %1358
  %1363 = load i64, ptr %780, align 8, !noalias !133
  %1364 = getelementptr i8, ptr %52, i64 16
  %1365 = load i64, ptr %1364, align 8, !noalias !133
  call fastcc void @pydy_nested(i64 %914, i64 %84, i64 %121, i64 %86, i64 %1363, i64 %104, i64 %1365) #2, !noalias !133
  br i1 %889, label %916, label %923

1366:                                             ; preds = %1358
  %1367 = add nsw i64 %1360, -1
  %1368 = add i64 %1359, 1
  %1369 = icmp slt i64 %1359, 0
  %1370 = select i1 %1369, i64 %106, i64 0
  %1371 = getelementptr double, ptr %107, i64 %1359
  %1372 = getelementptr double, ptr %1371, i64 %1370
  store double %911, ptr %1372, align 8, !noalias !133
  br label %1358

1373:                                             ; preds = %956
  %1374 = load i64, ptr %191, align 8, !noalias !15
  %1375 = icmp eq i64 %1374, 1
  br i1 %1375, label %978, label %983

1376:                                             ; preds = %988
  br label %1398

1377:                                             ; preds = %994
  store double %882, ptr %139, align 8, !noalias !15
  store double 0.000000e+00, ptr %243, align 8, !noalias !15
  store i64 0, ptr %144, align 8, !noalias !15
  br label %1009

1378:                                             ; preds = %1137
  %1379 = add nsw i64 %1139, -1
  %1380 = add i64 %1138, 1
  %1381 = icmp slt i64 %1138, 0
  %1382 = select i1 %1381, i64 %91, i64 0
  %1383 = getelementptr double, ptr %92, i64 %1138
  %1384 = getelementptr double, ptr %1383, i64 %1382
  %1385 = load double, ptr %1384, align 8, !noalias !15
  %1386 = select i1 %1381, i64 %86, i64 0
  %1387 = getelementptr double, ptr %87, i64 %1138
  %1388 = getelementptr double, ptr %1387, i64 %1386
  store double %1385, ptr %1388, align 8, !noalias !15
  %1389 = add nsw i64 %234, %1138
  %1390 = icmp slt i64 %1389, 0
  %1391 = select i1 %1390, i64 %118, i64 0
  %1392 = getelementptr double, ptr %119, i64 %1389
  %1393 = getelementptr double, ptr %1392, i64 %1391
  %1394 = load double, ptr %1393, align 8, !noalias !15
  %1395 = select i1 %1381, i64 %118, i64 0
  %1396 = getelementptr double, ptr %119, i64 %1138
  %1397 = getelementptr double, ptr %1396, i64 %1395
  store double %1394, ptr %1397, align 8, !noalias !15
  br label %1137

1398:                                             ; preds = %1376, %1354, %1303, %1302, %1288, %1287, %1286, %1283, %1243, %1242, %1223, %1222, %1218, %1215, %1214, %1213, %1025, %758, %721, %519, %438, %427, %274, %264, %226
  %1399 = phi i64 [ 0, %1376 ], [ -1, %226 ], [ 0, %1218 ], [ %267, %264 ], [ 0, %1222 ], [ 0, %274 ], [ 0, %1223 ], [ 0, %1243 ], [ 0, %1242 ], [ -1, %427 ], [ 1, %438 ], [ 2, %1214 ], [ 0, %1287 ], [ 0, %1283 ], [ 0, %1286 ], [ 0, %1288 ], [ -4, %519 ], [ -4, %721 ], [ 2, %1213 ], [ 0, %1303 ], [ %1011, %1025 ], [ 0, %1215 ], [ 0, %1302 ], [ 0, %1354 ], [ %761, %758 ]
  ret i64 %1399
}



declare i64 @llvm.smax.i64(i64, i64) #1

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #1

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
!9 = !{!10}
!10 = distinct !{!10, !11}
!11 = distinct !{!11}
!12 = !{!13}
!13 = distinct !{!13, !14}
!14 = distinct !{!14}
!15 = !{!16, !18}
!16 = distinct !{!16, !17}
!17 = distinct !{!17}
!18 = distinct !{!18, !17}
!19 = !{!20, !16, !18}
!20 = distinct !{!20, !21}
!21 = distinct !{!21}
!22 = !{!23, !20, !16, !18}
!23 = distinct !{!23, !24}
!24 = distinct !{!24}
!25 = !{!26, !20, !16, !18}
!26 = distinct !{!26, !27}
!27 = distinct !{!27}
!28 = !{!29, !31, !32, !34}
!29 = distinct !{!29, !30}
!30 = distinct !{!30}
!31 = distinct !{!31, !30}
!32 = distinct !{!32, !33}
!33 = distinct !{!33}
!34 = distinct !{!34, !33}
!35 = !{!"branch_weights", i32 1, i32 49, i32 49}
!36 = !{!32, !34}
!37 = !{!38, !40, !16, !18}
!38 = distinct !{!38, !39}
!39 = distinct !{!39}
!40 = distinct !{!40, !39}
!41 = !{!42, !44, !45, !47}
!42 = distinct !{!42, !43}
!43 = distinct !{!43}
!44 = distinct !{!44, !43}
!45 = distinct !{!45, !46}
!46 = distinct !{!46}
!47 = distinct !{!47, !46}
!48 = !{!45, !47}
!49 = !{!50, !52, !16, !18}
!50 = distinct !{!50, !51}
!51 = distinct !{!51}
!52 = distinct !{!52, !51}
!53 = !{!54, !56, !57, !59}
!54 = distinct !{!54, !55}
!55 = distinct !{!55}
!56 = distinct !{!56, !55}
!57 = distinct !{!57, !58}
!58 = distinct !{!58}
!59 = distinct !{!59, !58}
!60 = !{!57, !59}
!61 = !{!62, !64, !16, !18}
!62 = distinct !{!62, !63}
!63 = distinct !{!63}
!64 = distinct !{!64, !63}
!65 = !{!66, !68, !62, !64, !16, !18}
!66 = distinct !{!66, !67}
!67 = distinct !{!67}
!68 = distinct !{!68, !67}
!69 = !{!70, !62, !64, !16, !18}
!70 = distinct !{!70, !71}
!71 = distinct !{!71}
!72 = !{!73, !62, !64, !16, !18}
!73 = distinct !{!73, !74}
!74 = distinct !{!74}
!75 = !{!76, !78, !79, !81}
!76 = distinct !{!76, !77}
!77 = distinct !{!77}
!78 = distinct !{!78, !77}
!79 = distinct !{!79, !80}
!80 = distinct !{!80}
!81 = distinct !{!81, !80}
!82 = !{!79, !81}
!83 = !{!84, !86, !16, !18}
!84 = distinct !{!84, !85}
!85 = distinct !{!85}
!86 = distinct !{!86, !85}
!87 = !{!88, !90, !84, !86, !16, !18}
!88 = distinct !{!88, !89}
!89 = distinct !{!89}
!90 = distinct !{!90, !89}
!91 = !{!92, !88, !90, !84, !86, !16, !18}
!92 = distinct !{!92, !93}
!93 = distinct !{!93}
!94 = !{!95, !97, !16, !18}
!95 = distinct !{!95, !96}
!96 = distinct !{!96}
!97 = distinct !{!97, !96}
!98 = !{!99}
!99 = distinct !{!99, !100}
!100 = distinct !{!100}
!101 = !{!102}
!102 = distinct !{!102, !103}
!103 = distinct !{!103}
!104 = !{!105, !16, !18}
!105 = distinct !{!105, !106}
!106 = distinct !{!106}
!107 = !{!108, !16, !18}
!108 = distinct !{!108, !109}
!109 = distinct !{!109}
!110 = !{!111, !113, !114, !116}
!111 = distinct !{!111, !112}
!112 = distinct !{!112}
!113 = distinct !{!113, !112}
!114 = distinct !{!114, !115}
!115 = distinct !{!115}
!116 = distinct !{!116, !115}
!117 = !{!114, !116}
!118 = !{!119, !121, !16, !18}
!119 = distinct !{!119, !120}
!120 = distinct !{!120}
!121 = distinct !{!121, !120}
!122 = !{!123, !119, !121, !16, !18}
!123 = distinct !{!123, !124}
!124 = distinct !{!124}
!125 = !{!126, !128, !129, !131}
!126 = distinct !{!126, !127}
!127 = distinct !{!127}
!128 = distinct !{!128, !127}
!129 = distinct !{!129, !130}
!130 = distinct !{!130}
!131 = distinct !{!131, !130}
!132 = !{!129, !131}
!133 = !{!134, !136, !16, !18}
!134 = distinct !{!134, !135}
!135 = distinct !{!135}
!136 = distinct !{!136, !135}
