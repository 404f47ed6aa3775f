; sources 703265638d58f827e38788ce8d1e3d96d289acf43ad808cc41b07a226c4fba56
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
  br label %1315

227:                                              ; preds = %188
  %228 = load i64, ptr %26, align 8, !noalias !15
  %229 = load i64, ptr %191, align 8, !noalias !15
  %230 = icmp eq i64 %229, 1
  %231 = getelementptr i8, ptr %26, i64 8
  %232 = load i64, ptr %231, align 8, !noalias !15
  %233 = icmp sgt i64 %232, 0
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
  br i1 %246, label %247, label %414

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
  switch i32 %263, label %1135 [
    i32 -2, label %1133
    i32 0, label %1133
  ], !prof !35

264:                                              ; preds = %1133
  %265 = getelementptr i8, ptr %144, i64 72
  store i64 3, ptr %265, align 8, !noalias !15
  %266 = icmp slt i32 %262, 0
  %267 = select i1 %266, i64 -4, i64 2
  br label %1315

268:                                              ; preds = %1133
  store i64 1, ptr %144, align 8, !noalias !15
  %269 = getelementptr i8, ptr %49, i64 40
  %270 = load double, ptr %269, align 8, !noalias !15
  %271 = getelementptr i8, ptr %139, i64 24
  store double 1.000000e-04, ptr %271, align 8, !noalias !15
  %272 = getelementptr i8, ptr %139, i64 40
  store double %270, ptr %272, align 8, !noalias !15
  store i8 0, ptr %19, align 1, !noalias !15
  %273 = call fastcc i32 @write_reached(ptr nonnull %19, ptr %52, ptr %87, i64 %86, ptr nonnull %139, ptr nonnull %144, i64 %148, ptr %149, i64 %148, ptr %153, i64 %152) #2
  switch i32 %273, label %1139 [
    i32 -2, label %1136
    i32 0, label %1136
  ], !prof !35

274:                                              ; preds = %1136
  br label %1315

275:                                              ; preds = %1136
  %276 = fcmp oeq double %244, 0.000000e+00
  br i1 %276, label %277, label %414

277:                                              ; preds = %275
  %278 = load i64, ptr %150, align 8, !noalias !15
  %279 = getelementptr i8, ptr %139, i64 16
  %280 = load double, ptr %279, align 8, !noalias !15
  store double 0.000000e+00, ptr %17, align 8, !noalias !37
  store double 0.000000e+00, ptr %18, align 8, !noalias !37
  store double 0.000000e+00, ptr %17, align 8, !noalias !37
  %281 = call fastcc i32 @norm(ptr nonnull %17, ptr %87, ptr %87, ptr %87, ptr %129, i64 %128, ptr %134, i64 %133, i64 %278) #2
  %282 = load double, ptr %17, align 8, !noalias !37
  switch i32 %281, label %1140 [
    i32 -2, label %283
    i32 0, label %283
  ], !prof !35

283:                                              ; preds = %277, %277
  store double 0.000000e+00, ptr %18, align 8, !noalias !37
  %284 = call fastcc i32 @norm(ptr nonnull %18, ptr %119, ptr %87, ptr %87, ptr %129, i64 %128, ptr %134, i64 %133, i64 %278) #2
  %285 = load double, ptr %18, align 8, !noalias !37
  switch i32 %284, label %1140 [
    i32 -2, label %286
    i32 0, label %286
  ], !prof !35

286:                                              ; preds = %283, %283
  %287 = fcmp olt double %282, 1.000000e-05
  %288 = fcmp olt double %285, 1.000000e-05
  %289 = or i1 %287, %288
  %290 = fmul double %282, 1.000000e-02
  %291 = fdiv double %290, %285
  %292 = select i1 %289, double 0x3EB0C6F7A0B5ED8D, double %291
  %293 = fcmp olt double %280, %292
  %294 = select i1 %293, double %280, double %292
  %295 = call i64 @llvm.smax.i64(i64 %278, i64 0)
  br label %296

296:                                              ; preds = %286, %1141
  %297 = phi i64 [ 0, %286 ], [ %1143, %1141 ]
  %298 = phi i64 [ %295, %286 ], [ %1142, %1141 ]
  %299 = icmp sgt i64 %298, 0
  br i1 %299, label %1141, label %300

300:                                              ; preds = %296
  %301 = load i64, ptr %248, align 8, !noalias !15
  %302 = add nsw i64 %301, 1
  store i64 %302, ptr %248, align 8, !noalias !15
  %303 = shl i64 %86, 3
  %304 = add i64 %303, %116
  %305 = fadd double %242, %294
  store ptr null, ptr %14, align 8, !noalias !41
  store ptr null, ptr %15, align 8, !noalias !41
  store double %305, ptr %55, align 8, !noalias !41
  br i1 %251, label %306, label %309

306:                                              ; preds = %300
  store ptr null, ptr %14, align 8, !noalias !41
  %307 = call fastcc i32 @_sample(ptr nonnull %14, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %305) #2
  switch i32 %307, label %308 [
    i32 -2, label %309
    i32 0, label %309
  ], !prof !35

308:                                              ; preds = %306
  br label %309

309:                                              ; preds = %306, %306, %300, %308
  %310 = phi i32 [ %307, %308 ], [ 0, %300 ], [ 0, %306 ], [ 0, %306 ]
  switch i32 %310, label %317 [
    i32 -2, label %311
    i32 0, label %311
  ], !prof !35

311:                                              ; preds = %309, %309
  %312 = load i64, ptr %52, align 8, !noalias !48
  %313 = inttoptr i64 %312 to ptr
  %314 = inttoptr i64 %304 to ptr
  %315 = call i32 %313(ptr nonnull %55, ptr %97, ptr %60, ptr %63, ptr %314) #2, !noalias !48
  %316 = icmp eq i32 %315, 0
  br label %317

317:                                              ; preds = %309, %311
  %318 = phi i1 [ %316, %311 ], [ true, %309 ]
  %319 = phi i32 [ 0, %311 ], [ %310, %309 ]
  switch i32 %319, label %1159 [
    i32 -2, label %1158
    i32 0, label %1158
  ], !prof !35

320:                                              ; preds = %1158
  %321 = fmul double %294, 1.000000e-03
  br label %409

322:                                              ; preds = %1158
  store double 0.000000e+00, ptr %16, align 8, !noalias !49
  %323 = icmp slt i64 %86, 0
  %324 = select i1 %323, i64 %118, i64 0
  %325 = add i64 %86, %324
  %326 = icmp slt i64 %325, 0
  br i1 %326, label %333, label %334, !prof !4

327:                                              ; preds = %338, %341
  %328 = phi i64 [ 0, %338 ], [ %343, %341 ]
  %329 = phi i64 [ %295, %338 ], [ %342, %341 ]
  %330 = icmp sgt i64 %329, 0
  br i1 %330, label %341, label %331

331:                                              ; preds = %327
  store double 0.000000e+00, ptr %16, align 8, !noalias !49
  %332 = call fastcc i32 @norm(ptr nonnull %16, ptr %340, ptr %87, ptr %87, ptr %129, i64 %128, ptr %134, i64 %133, i64 %278) #2
  switch i32 %332, label %1160 [
    i32 -2, label %349
    i32 0, label %349
  ], !prof !35

333:                                              ; preds = %322
  br label %334

334:                                              ; preds = %333, %322
  %335 = phi i64 [ 0, %333 ], [ %325, %322 ]
  %336 = icmp slt i64 %325, %118
  br i1 %336, label %338, label %337, !prof !8

337:                                              ; preds = %334
  br label %338

338:                                              ; preds = %337, %334
  %339 = phi i64 [ %118, %337 ], [ %335, %334 ]
  %340 = getelementptr double, ptr %119, i64 %339
  br label %327

341:                                              ; preds = %327
  %342 = add nsw i64 %329, -1
  %343 = add i64 %328, 1
  %344 = getelementptr double, ptr %340, i64 %328
  %345 = load double, ptr %344, align 8, !noalias !49
  %346 = getelementptr double, ptr %119, i64 %328
  %347 = load double, ptr %346, align 8, !noalias !49
  %348 = fsub double %345, %347
  store double %348, ptr %344, align 8, !noalias !49
  br label %327

349:                                              ; preds = %331, %331
  %350 = load double, ptr %16, align 8, !noalias !49
  %351 = fdiv double %350, %294
  %352 = fcmp ogt double %285, %351
  %353 = select i1 %352, double %285, double %351
  %354 = fcmp ogt double %353, 1.000000e-15
  %355 = fdiv double 1.000000e-02, %353
  %356 = select i1 %354, double %355, double 1.000000e+13
  %357 = load double, ptr %49, align 8, !noalias !49
  %358 = bitcast double %356 to i64
  %359 = add nsw i64 %358, -4604544271217802189
  %360 = ashr i64 %359, 52
  %361 = and i64 %359, -4503599627370496
  %362 = sub i64 %358, %361
  %363 = bitcast i64 %362 to double
  %364 = fadd double %363, -1.000000e+00
  %365 = fadd double %363, 1.000000e+00
  %366 = fdiv double %364, %365
  %367 = fmul double %366, %366
  %368 = call double @llvm.fma.f64(double %367, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %369 = call double @llvm.fma.f64(double %368, double %367, double 0x3FE2776C50EF9BFE)
  %370 = call double @llvm.fma.f64(double %369, double %367, double 0x3FEEC709DC3A03FD)
  %371 = call double @llvm.fma.f64(double %370, double %367, double 0x40071547652B82FE)
  %372 = fmul double %371, %366
  %373 = trunc nsw i64 %360 to i32
  %374 = sitofp i32 %373 to double
  %375 = fadd double %372, %374
  %376 = fmul double %375, %357
  %377 = fcmp ogt double %376, -1.000000e+03
  %378 = select i1 %377, double %376, double -1.000000e+03
  %379 = fcmp olt double %378, 1.000000e+03
  %380 = select i1 %379, double %378, double 1.000000e+03
  %381 = call double @llvm.rint.f64(double %380)
  %382 = fsub double %380, %381
  %383 = call double @llvm.fma.f64(double %382, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %384 = call double @llvm.fma.f64(double %383, double %382, double 0x3F55D87FE78A6730)
  %385 = call double @llvm.fma.f64(double %384, double %382, double 0x3F83B2AB6FBA4E77)
  %386 = call double @llvm.fma.f64(double %385, double %382, double 0x3FAC6B08D704A0BF)
  %387 = call double @llvm.fma.f64(double %386, double %382, double 0x3FCEBFBDFF82C58E)
  %388 = call double @llvm.fma.f64(double %387, double %382, double 0x3FE62E42FEFA39EF)
  %389 = call double @llvm.fma.f64(double %388, double %382, double 1.000000e+00)
  %390 = fptosi double %381 to i32
  %391 = zext i32 %390 to i64
  %392 = shl i64 %391, 52
  %393 = bitcast double %389 to i64
  %394 = add i64 %392, %393
  %395 = bitcast i64 %394 to double
  %396 = fmul double %294, 1.000000e-03
  %397 = fcmp olt double %396, 0x3EB0C6F7A0B5ED8D
  %398 = select i1 %397, double 0x3EB0C6F7A0B5ED8D, double %396
  %399 = fmul double %294, 1.000000e+02
  %400 = select i1 %354, double %395, double %398
  %401 = fcmp olt double %399, %400
  %402 = select i1 %401, double %399, double %400
  %403 = call double @llvm.fabs.f64(double %242)
  %404 = fmul double %403, 0x3D30000000000000
  %405 = fcmp ogt double %404, %402
  %406 = select i1 %405, double %404, double %402
  %407 = fcmp olt double %280, %406
  %408 = select i1 %407, double %280, double %406
  br label %409

409:                                              ; preds = %349, %320
  %410 = phi double [ %321, %320 ], [ %408, %349 ]
  %411 = call i1 @llvm.is.fpclass.f64(double %410, i32 384)
  br i1 %411, label %414, label %412

412:                                              ; preds = %409
  %413 = getelementptr i8, ptr %144, i64 72
  store i64 4, ptr %413, align 8, !noalias !15
  br label %414

414:                                              ; preds = %409, %412, %275, %227
  %415 = phi double [ %410, %409 ], [ %410, %412 ], [ %244, %275 ], [ %244, %227 ]
  br label %416

416:                                              ; preds = %1077, %414
  %417 = phi double [ %415, %414 ], [ %1128, %1077 ]
  %418 = phi double [ %242, %414 ], [ %421, %1077 ]
  br label %419

419:                                              ; preds = %1064, %416
  %420 = phi double [ %417, %416 ], [ %1058, %1064 ]
  %421 = phi double [ %418, %416 ], [ %464, %1064 ]
  %422 = load i64, ptr %195, align 8, !noalias !15
  %423 = icmp eq i64 %422, 0
  br i1 %423, label %424, label %425

424:                                              ; preds = %419
  store double %420, ptr %243, align 8, !noalias !15
  br label %1315

425:                                              ; preds = %419
  %426 = add nsw i64 %422, -1
  store i64 %426, ptr %195, align 8, !noalias !15
  %427 = getelementptr i8, ptr %144, i64 8
  %428 = load i64, ptr %427, align 8, !noalias !15
  %429 = getelementptr i8, ptr %144, i64 16
  %430 = load i64, ptr %429, align 8, !noalias !15
  %431 = add nsw i64 %428, %430
  %432 = getelementptr i8, ptr %144, i64 64
  %433 = load i64, ptr %432, align 8, !noalias !15
  %434 = icmp slt i64 %431, %433
  br i1 %434, label %436, label %435

435:                                              ; preds = %425
  store double %420, ptr %243, align 8, !noalias !15
  br label %1315

436:                                              ; preds = %425
  br i1 %233, label %437, label %442

437:                                              ; preds = %436
  %438 = getelementptr i8, ptr %139, i64 16
  %439 = load double, ptr %438, align 8, !noalias !15
  %440 = fcmp olt double %420, %439
  %441 = select i1 %440, double %420, double %439
  br label %455

442:                                              ; preds = %436
  %443 = getelementptr i8, ptr %144, i64 48
  %444 = load i64, ptr %443, align 8, !noalias !15
  %445 = icmp slt i64 %444, 0
  %446 = select i1 %445, i64 %148, i64 0
  %447 = getelementptr double, ptr %149, i64 %444
  %448 = getelementptr double, ptr %447, i64 %446
  %449 = load double, ptr %448, align 8, !noalias !15
  %450 = fsub double %449, %421
  %451 = fdiv double %450, %420
  %452 = fmul double %451, 0x3FEFFFFFFFFFDCD1
  %453 = call double @llvm.ceil.f64(double %452)
  %454 = fdiv double %450, %453
  br label %455

455:                                              ; preds = %442, %437
  %456 = phi double [ %241, %437 ], [ %449, %442 ]
  %457 = phi double [ %441, %437 ], [ %454, %442 ]
  %458 = fadd double %421, %457
  %459 = fmul double %457, 1.000000e-03
  %460 = fsub double %456, %459
  %461 = fcmp ogt double %458, %460
  %462 = fsub double %456, %421
  %463 = select i1 %461, double %462, double %457
  %464 = select i1 %461, double %456, double %458
  %465 = fmul double %463, 6.250000e-02
  %466 = fadd double %421, %465
  %467 = fcmp ogt double %466, %421
  %468 = fcmp oeq double %464, %456
  %469 = or i1 %467, %468
  br i1 %469, label %470, label %1131

470:                                              ; preds = %455
  %471 = call i64 @llvm.smax.i64(i64 %101, i64 0)
  br label %472

472:                                              ; preds = %470, %1161
  %473 = phi i64 [ 0, %470 ], [ %1163, %1161 ]
  %474 = phi i64 [ %471, %470 ], [ %1162, %1161 ]
  %475 = icmp sgt i64 %474, 0
  br i1 %475, label %1161, label %476

476:                                              ; preds = %472
  %477 = load i64, ptr %26, align 8, !noalias !15
  %478 = add i64 %477, -1
  %479 = call i64 @llvm.smax.i64(i64 %478, i64 0)
  br label %480

480:                                              ; preds = %1201, %476
  %481 = phi i64 [ 1, %476 ], [ %1170, %1201 ]
  %482 = phi i64 [ %479, %476 ], [ %1169, %1201 ]
  %483 = icmp slt i64 %482, 1
  br i1 %483, label %486, label %1168

484:                                              ; preds = %1201
  %485 = sext i32 %1198 to i64
  br label %488

486:                                              ; preds = %480
  store ptr null, ptr %21, align 8, !noalias !15
  %487 = call fastcc i32 @_combine_latest(ptr nonnull %21, ptr %31, i64 %30, ptr %36, i64 %35, ptr %41, i64 %40, ptr %52, ptr %87, ptr %102, ptr %119, i64 %118, i64 %477, i64 %89, double %463) #2
  switch i32 %487, label %1204 [
    i32 -2, label %488
    i32 0, label %488
  ], !prof !35

488:                                              ; preds = %486, %486, %484
  %489 = phi i64 [ %485, %484 ], [ 0, %486 ], [ 0, %486 ]
  br i1 %483, label %490, label %513

490:                                              ; preds = %488
  %491 = getelementptr i8, ptr %26, i64 32
  %492 = load i64, ptr %491, align 8, !noalias !15
  %493 = icmp eq i64 %492, 1
  br i1 %493, label %494, label %513

494:                                              ; preds = %490
  %495 = getelementptr i8, ptr %144, i64 24
  %496 = load i64, ptr %495, align 8, !noalias !15
  %497 = add nsw i64 %496, 1
  store i64 %497, ptr %495, align 8, !noalias !15
  store ptr null, ptr %8, align 8, !noalias !53
  store ptr null, ptr %9, align 8, !noalias !53
  store double %464, ptr %55, align 8, !noalias !53
  %498 = icmp sgt i64 %67, 0
  br i1 %498, label %499, label %502

499:                                              ; preds = %494
  store ptr null, ptr %8, align 8, !noalias !53
  %500 = call fastcc i32 @_sample(ptr nonnull %8, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %464) #2
  switch i32 %500, label %501 [
    i32 -2, label %502
    i32 0, label %502
  ], !prof !35

501:                                              ; preds = %499
  br label %502

502:                                              ; preds = %499, %499, %494, %501
  %503 = phi i32 [ %500, %501 ], [ 0, %494 ], [ 0, %499 ], [ 0, %499 ]
  switch i32 %503, label %510 [
    i32 -2, label %504
    i32 0, label %504
  ], !prof !35

504:                                              ; preds = %502, %502
  %505 = load i64, ptr %52, align 8, !noalias !60
  %506 = inttoptr i64 %505 to ptr
  %507 = inttoptr i64 %236 to ptr
  %508 = call i32 %506(ptr nonnull %55, ptr %92, ptr %60, ptr %63, ptr %507) #2, !noalias !60
  %509 = sext i32 %508 to i64
  br label %510

510:                                              ; preds = %502, %504
  %511 = phi i64 [ %509, %504 ], [ 0, %502 ]
  %512 = phi i32 [ 0, %504 ], [ %503, %502 ]
  switch i32 %512, label %1205 [
    i32 -2, label %513
    i32 0, label %513
  ], !prof !35

513:                                              ; preds = %510, %510, %490, %488
  %514 = phi i64 [ %489, %488 ], [ 0, %490 ], [ %511, %510 ], [ %511, %510 ]
  %515 = icmp slt i64 %514, 0
  br i1 %515, label %516, label %517

516:                                              ; preds = %513
  br label %1315

517:                                              ; preds = %513
  %518 = icmp eq i64 %514, 0
  br i1 %518, label %519, label %664

519:                                              ; preds = %517
  br i1 %233, label %520, label %623

520:                                              ; preds = %519
  %521 = load i64, ptr %150, align 8, !noalias !61
  %522 = load i64, ptr %231, align 8, !noalias !61
  %523 = load i64, ptr %26, align 8, !noalias !61
  %524 = add nsw i64 %523, 1
  %525 = call i64 @llvm.smax.i64(i64 %522, i64 0)
  br label %526

526:                                              ; preds = %520, %552
  %527 = phi i64 [ 0, %520 ], [ %554, %552 ]
  %528 = phi i64 [ %525, %520 ], [ %553, %552 ]
  %529 = icmp sgt i64 %528, 0
  br i1 %529, label %552, label %576

530:                                              ; preds = %586, %590
  %531 = phi i64 [ 0, %586 ], [ %592, %590 ]
  %532 = phi i64 [ %589, %586 ], [ %591, %590 ]
  %533 = phi double [ 0.000000e+00, %586 ], [ %622, %590 ]
  %534 = phi double [ 0.000000e+00, %586 ], [ %620, %590 ]
  %535 = freeze double %534
  %536 = icmp sgt i64 %532, 0
  br i1 %536, label %590, label %537

537:                                              ; preds = %530
  %538 = icmp eq i64 %522, 2
  br i1 %538, label %539, label %548

539:                                              ; preds = %537
  %540 = fmul double %533, 1.000000e-02
  %541 = fadd double %535, %540
  %542 = sitofp i64 %521 to double
  %543 = fmul double %541, %542
  %544 = call double @llvm.sqrt.f64(double %543)
  %545 = fcmp oeq double %535, 0.000000e+00
  %546 = fdiv double %535, %544
  %547 = select i1 %545, double 0.000000e+00, double %546
  br label %630

548:                                              ; preds = %537
  %549 = sitofp i64 %521 to double
  %550 = fdiv double %535, %549
  %551 = call double @llvm.sqrt.f64(double %550)
  br label %630

552:                                              ; preds = %526
  %553 = add nsw i64 %528, -1
  %554 = add i64 %527, 1
  %555 = add nsw i64 %524, %527
  %556 = mul nsw i64 %527, %86
  %557 = shl i64 %556, 3
  %558 = add i64 %557, %111
  %559 = icmp slt i64 %555, 0
  %560 = select i1 %559, i64 %30, i64 0
  %561 = getelementptr i64, ptr %31, i64 %555
  %562 = getelementptr i64, ptr %561, i64 %560
  %563 = load i64, ptr %562, align 8, !noalias !65
  %564 = shl i64 %563, 3
  %565 = add i64 %564, %33
  %566 = add i64 %564, %38
  %567 = icmp slt i64 %555, -1
  %568 = select i1 %567, i64 %30, i64 0
  %569 = getelementptr i8, ptr %561, i64 8
  %570 = getelementptr i64, ptr %569, i64 %568
  %571 = load i64, ptr %570, align 8, !noalias !65
  %572 = xor i64 %563, -1
  %573 = add i64 %571, %572
  %574 = getelementptr i8, ptr %52, i64 16
  %575 = load i64, ptr %574, align 8, !noalias !65
  call fastcc void @pydy_combine(i64 %558, i64 %109, i64 %99, i64 %116, i64 %565, i64 %566, i64 %573, i64 1, i64 %575) #2, !noalias !65
  br label %526

576:                                              ; preds = %526
  %577 = icmp slt i64 %86, 0
  %578 = select i1 %577, i64 %113, i64 0
  %579 = add i64 %86, %578
  %580 = icmp slt i64 %579, 0
  br i1 %580, label %581, label %582, !prof !4

581:                                              ; preds = %576
  br label %582

582:                                              ; preds = %581, %576
  %583 = phi i64 [ 0, %581 ], [ %579, %576 ]
  %584 = icmp slt i64 %579, %113
  br i1 %584, label %586, label %585, !prof !8

585:                                              ; preds = %582
  br label %586

586:                                              ; preds = %585, %582
  %587 = phi i64 [ %113, %585 ], [ %583, %582 ]
  %588 = getelementptr double, ptr %114, i64 %587
  %589 = call i64 @llvm.smax.i64(i64 %521, i64 0)
  br label %530

590:                                              ; preds = %530
  %591 = add nsw i64 %532, -1
  %592 = add i64 %531, 1
  %593 = getelementptr double, ptr %87, i64 %531
  %594 = load double, ptr %593, align 8, !noalias !61
  %595 = getelementptr double, ptr %92, i64 %531
  %596 = load double, ptr %595, align 8, !noalias !61
  %597 = icmp slt i64 %531, 0
  %598 = select i1 %597, i64 %133, i64 0
  %599 = getelementptr double, ptr %134, i64 %531
  %600 = getelementptr double, ptr %599, i64 %598
  %601 = load double, ptr %600, align 8, !noalias !71
  %602 = select i1 %597, i64 %128, i64 0
  %603 = getelementptr double, ptr %129, i64 %531
  %604 = getelementptr double, ptr %603, i64 %602
  %605 = load double, ptr %604, align 8, !noalias !71
  %606 = call double @llvm.fabs.f64(double %594)
  %607 = call double @llvm.fabs.f64(double %596)
  %608 = fcmp ogt double %606, %607
  %609 = select i1 %608, double %606, double %607
  %610 = fmul double %605, %609
  %611 = fadd double %601, %610
  %612 = fdiv double 1.000000e+00, %611
  %613 = getelementptr double, ptr %114, i64 %531
  %614 = load double, ptr %613, align 8, !noalias !61
  %615 = fmul double %614, %612
  %616 = getelementptr double, ptr %588, i64 %531
  %617 = load double, ptr %616, align 8, !noalias !61
  %618 = fmul double %617, %612
  %619 = fmul double %615, %615
  %620 = fadd double %535, %619
  %621 = fmul double %618, %618
  %622 = fadd double %533, %621
  br label %530

623:                                              ; preds = %519
  %624 = call i64 @llvm.smax.i64(i64 %86, i64 0)
  br label %625

625:                                              ; preds = %623, %1206
  %626 = phi i64 [ 0, %623 ], [ %1208, %1206 ]
  %627 = phi i64 [ %624, %623 ], [ %1207, %1206 ]
  %628 = phi double [ 0.000000e+00, %623 ], [ %1215, %1206 ]
  %629 = icmp sgt i64 %627, 0
  br i1 %629, label %1206, label %630

630:                                              ; preds = %625, %548, %539
  %631 = phi double [ %628, %625 ], [ %551, %548 ], [ %547, %539 ]
  %632 = fcmp olt double %631, 1.000000e+00
  br i1 %632, label %633, label %664

633:                                              ; preds = %630
  br i1 %230, label %638, label %634

634:                                              ; preds = %633
  %635 = getelementptr i8, ptr %26, i64 32
  %636 = load i64, ptr %635, align 8, !noalias !15
  %637 = icmp eq i64 %636, 0
  br i1 %637, label %645, label %664

638:                                              ; preds = %633
  %639 = getelementptr i8, ptr %191, i64 56
  %640 = load i64, ptr %639, align 8, !noalias !15
  %641 = inttoptr i64 %640 to ptr
  %642 = call i64 %641(i64 %0, double %464, i64 %89) #2, !noalias !15
  %643 = icmp eq i64 %642, 0
  br i1 %643, label %645, label %644

644:                                              ; preds = %638
  store double %463, ptr %243, align 8, !noalias !15
  br label %1315

645:                                              ; preds = %634, %638
  %646 = getelementptr i8, ptr %144, i64 24
  %647 = load i64, ptr %646, align 8, !noalias !15
  %648 = add nsw i64 %647, 1
  store i64 %648, ptr %646, align 8, !noalias !15
  store ptr null, ptr %6, align 8, !noalias !74
  store ptr null, ptr %7, align 8, !noalias !74
  store double %464, ptr %55, align 8, !noalias !74
  %649 = icmp sgt i64 %67, 0
  br i1 %649, label %650, label %653

650:                                              ; preds = %645
  store ptr null, ptr %6, align 8, !noalias !74
  %651 = call fastcc i32 @_sample(ptr nonnull %6, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %464) #2
  switch i32 %651, label %652 [
    i32 -2, label %653
    i32 0, label %653
  ], !prof !35

652:                                              ; preds = %650
  br label %653

653:                                              ; preds = %650, %650, %645, %652
  %654 = phi i32 [ %651, %652 ], [ 0, %645 ], [ 0, %650 ], [ 0, %650 ]
  switch i32 %654, label %660 [
    i32 -2, label %655
    i32 0, label %655
  ], !prof !35

655:                                              ; preds = %653, %653
  %656 = load i64, ptr %52, align 8, !noalias !81
  %657 = inttoptr i64 %656 to ptr
  %658 = inttoptr i64 %236 to ptr
  %659 = call i32 %657(ptr nonnull %55, ptr %92, ptr %60, ptr %63, ptr %658) #2, !noalias !81
  br label %660

660:                                              ; preds = %653, %655
  %661 = phi i32 [ %659, %655 ], [ 0, %653 ]
  %662 = phi i32 [ 0, %655 ], [ %654, %653 ]
  switch i32 %662, label %1219 [
    i32 -2, label %1216
    i32 0, label %1216
  ], !prof !35

663:                                              ; preds = %1216
  br label %1315

664:                                              ; preds = %1216, %634, %630, %517
  %665 = phi i1 [ true, %517 ], [ false, %630 ], [ true, %634 ], [ true, %1216 ]
  %666 = phi i64 [ %514, %517 ], [ 0, %630 ], [ 0, %634 ], [ %1217, %1216 ]
  %667 = phi double [ 0.000000e+00, %517 ], [ %631, %630 ], [ %631, %634 ], [ %631, %1216 ]
  %668 = icmp eq i64 %666, 0
  %669 = and i1 %668, %665
  br i1 %669, label %670, label %1068

670:                                              ; preds = %664
  %671 = load i64, ptr %427, align 8, !noalias !15
  %672 = add nsw i64 %671, 1
  store i64 %672, ptr %427, align 8, !noalias !15
  store double %464, ptr %139, align 8, !noalias !15
  %673 = getelementptr i8, ptr %139, i64 32
  store double %463, ptr %673, align 8, !noalias !15
  %674 = getelementptr i8, ptr %194, i64 8
  %675 = load i64, ptr %674, align 8, !noalias !15
  %676 = icmp eq i64 %675, 0
  br i1 %676, label %677, label %688

677:                                              ; preds = %670
  %678 = getelementptr i8, ptr %144, i64 48
  %679 = load i64, ptr %678, align 8, !noalias !15
  %680 = icmp slt i64 %679, 0
  %681 = select i1 %680, i64 %148, i64 0
  %682 = getelementptr double, ptr %149, i64 %679
  %683 = getelementptr double, ptr %682, i64 %681
  %684 = load double, ptr %683, align 8, !noalias !15
  %685 = fcmp ult double %684, %464
  br i1 %685, label %688, label %686

686:                                              ; preds = %677
  store i8 0, ptr %22, align 1, !noalias !15
  %687 = call fastcc i32 @write_reached(ptr nonnull %22, ptr %52, ptr %92, i64 %91, ptr nonnull %139, ptr nonnull %144, i64 %148, ptr %149, i64 %148, ptr %153, i64 %152) #2
  switch i32 %687, label %1220 [
    i32 -2, label %949
    i32 0, label %949
  ], !prof !35

688:                                              ; preds = %677, %670
  %689 = load i64, ptr %26, align 8, !noalias !15
  %690 = getelementptr i8, ptr %26, i64 16
  %691 = load i64, ptr %690, align 8, !noalias !15
  %692 = call i64 @llvm.smax.i64(i64 %691, i64 0)
  br label %693

693:                                              ; preds = %1268, %688
  %694 = phi i64 [ %689, %688 ], [ %696, %1268 ]
  %695 = phi i64 [ %692, %688 ], [ %1269, %1268 ]
  %696 = add i64 %694, 1
  %697 = icmp sgt i64 %695, 0
  br i1 %697, label %1221, label %702

698:                                              ; preds = %1268
  %699 = getelementptr i8, ptr %144, i64 72
  store i64 3, ptr %699, align 8, !noalias !15
  %700 = icmp slt i32 %1266, 0
  %701 = select i1 %700, i64 -4, i64 2
  br label %1315

702:                                              ; preds = %693
  %703 = load i64, ptr %150, align 8, !noalias !82
  %704 = load i64, ptr %26, align 8, !noalias !82
  %705 = mul nsw i64 %704, %86
  %706 = icmp slt i64 %705, 0
  %707 = select i1 %706, i64 %118, i64 0
  %708 = add i64 %705, %707
  %709 = icmp slt i64 %708, 0
  br i1 %709, label %728, label %729, !prof !4

710:                                              ; preds = %756, %760
  %711 = phi i64 [ 0, %756 ], [ %762, %760 ]
  %712 = phi i64 [ %759, %756 ], [ %761, %760 ]
  %713 = icmp sgt i64 %712, 0
  br i1 %713, label %760, label %714

714:                                              ; preds = %710
  %715 = add nsw i64 %704, 1
  %716 = load i64, ptr %231, align 8, !noalias !82
  %717 = add nsw i64 %715, %716
  %718 = load i64, ptr %690, align 8, !noalias !82
  %719 = add nsw i64 %717, %718
  %720 = getelementptr i8, ptr %26, i64 24
  %721 = load i64, ptr %720, align 8, !noalias !82
  %722 = add i64 %721, -3
  %723 = call i64 @llvm.smax.i64(i64 %722, i64 0)
  br label %724

724:                                              ; preds = %714, %780
  %725 = phi i64 [ 3, %714 ], [ %782, %780 ]
  %726 = phi i64 [ %723, %714 ], [ %781, %780 ]
  %727 = icmp sgt i64 %726, 0
  br i1 %727, label %780, label %1272

728:                                              ; preds = %702
  br label %729

729:                                              ; preds = %728, %702
  %730 = phi i64 [ 0, %728 ], [ %708, %702 ]
  %731 = icmp slt i64 %708, %118
  br i1 %731, label %733, label %732, !prof !8

732:                                              ; preds = %729
  br label %733

733:                                              ; preds = %732, %729
  %734 = phi i64 [ %118, %732 ], [ %730, %729 ]
  %735 = getelementptr double, ptr %119, i64 %734
  %736 = icmp slt i64 %86, 0
  %737 = select i1 %736, i64 %123, i64 0
  %738 = add i64 %86, %737
  %739 = icmp slt i64 %738, 0
  br i1 %739, label %740, label %741, !prof !4

740:                                              ; preds = %733
  br label %741

741:                                              ; preds = %740, %733
  %742 = phi i64 [ 0, %740 ], [ %738, %733 ]
  %743 = icmp slt i64 %738, %123
  br i1 %743, label %745, label %744, !prof !8

744:                                              ; preds = %741
  br label %745

745:                                              ; preds = %744, %741
  %746 = phi i64 [ %123, %744 ], [ %742, %741 ]
  %747 = getelementptr double, ptr %124, i64 %746
  %748 = shl nsw i64 %86, 1
  %749 = add i64 %748, %737
  %750 = icmp slt i64 %749, 0
  br i1 %750, label %751, label %752, !prof !4

751:                                              ; preds = %745
  br label %752

752:                                              ; preds = %751, %745
  %753 = phi i64 [ 0, %751 ], [ %749, %745 ]
  %754 = icmp slt i64 %749, %123
  br i1 %754, label %756, label %755, !prof !8

755:                                              ; preds = %752
  br label %756

756:                                              ; preds = %755, %752
  %757 = phi i64 [ %123, %755 ], [ %753, %752 ]
  %758 = getelementptr double, ptr %124, i64 %757
  %759 = call i64 @llvm.smax.i64(i64 %703, i64 0)
  br label %710

760:                                              ; preds = %710
  %761 = add nsw i64 %712, -1
  %762 = add i64 %711, 1
  %763 = getelementptr double, ptr %92, i64 %711
  %764 = load double, ptr %763, align 8, !noalias !82
  %765 = getelementptr double, ptr %87, i64 %711
  %766 = load double, ptr %765, align 8, !noalias !82
  %767 = fsub double %764, %766
  %768 = getelementptr double, ptr %119, i64 %711
  %769 = load double, ptr %768, align 8, !noalias !82
  %770 = fmul double %463, %769
  %771 = fsub double %770, %767
  %772 = getelementptr double, ptr %124, i64 %711
  store double %767, ptr %772, align 8, !noalias !82
  %773 = getelementptr double, ptr %747, i64 %711
  store double %771, ptr %773, align 8, !noalias !82
  %774 = fsub double %767, %771
  %775 = getelementptr double, ptr %735, i64 %711
  %776 = load double, ptr %775, align 8, !noalias !82
  %777 = fmul double %463, %776
  %778 = fsub double %774, %777
  %779 = getelementptr double, ptr %758, i64 %711
  store double %778, ptr %779, align 8, !noalias !82
  br label %710

780:                                              ; preds = %724
  %781 = add nsw i64 %726, -1
  %782 = add i64 %725, 1
  %783 = mul nsw i64 %725, %86
  %784 = shl i64 %783, 3
  %785 = add i64 %784, %121
  %786 = add nsw i64 %719, %725
  %787 = icmp slt i64 %786, 3
  %788 = select i1 %787, i64 %30, i64 0
  %789 = getelementptr i64, ptr %31, i64 %786
  %790 = getelementptr i8, ptr %789, i64 -24
  %791 = getelementptr i64, ptr %790, i64 %788
  %792 = load i64, ptr %791, align 8, !noalias !86
  %793 = shl i64 %792, 3
  %794 = add i64 %793, %33
  %795 = add i64 %793, %38
  %796 = icmp slt i64 %786, 2
  %797 = select i1 %796, i64 %30, i64 0
  %798 = getelementptr i8, ptr %789, i64 -16
  %799 = getelementptr i64, ptr %798, i64 %797
  %800 = load i64, ptr %799, align 8, !noalias !86
  %801 = xor i64 %792, -1
  %802 = add i64 %800, %801
  %803 = getelementptr i8, ptr %52, i64 16
  %804 = load i64, ptr %803, align 8, !noalias !86
  call fastcc void @pydy_combine(i64 %785, i64 %109, i64 %99, i64 %116, i64 %794, i64 %795, i64 %802, i64 1, i64 %804) #2, !noalias !86
  br label %724

805:                                              ; preds = %1272
  %806 = getelementptr i8, ptr %194, i64 16
  %807 = load i64, ptr %806, align 8, !noalias !15
  %808 = inttoptr i64 %807 to ptr
  %809 = call i64 %808(i64 %0, double %421, double %463) #2, !noalias !15
  %810 = getelementptr i8, ptr %139, i64 48
  %811 = load double, ptr %810, align 8, !noalias !15
  br label %812

812:                                              ; preds = %805, %1272
  %813 = phi double [ %811, %805 ], [ 1.000000e+00, %1272 ]
  %814 = phi i64 [ %809, %805 ], [ 0, %1272 ]
  %815 = fcmp oeq double %813, 1.000000e+00
  br i1 %815, label %816, label %818

816:                                              ; preds = %812
  %817 = load double, ptr %139, align 8, !noalias !15
  br label %821

818:                                              ; preds = %812
  %819 = fmul double %813, %463
  %820 = fadd double %421, %819
  br label %821

821:                                              ; preds = %818, %816
  %822 = phi double [ %817, %816 ], [ %820, %818 ]
  %823 = fcmp olt double %813, 1.000000e+00
  %824 = load i64, ptr %150, align 8, !noalias !15
  %825 = load i64, ptr %191, align 8, !noalias !15
  %826 = icmp eq i64 %825, 1
  %827 = getelementptr i8, ptr %144, i64 48
  %828 = load i64, ptr %827, align 8, !noalias !15
  %829 = icmp slt i64 %828, %148
  br i1 %829, label %830, label %873

830:                                              ; preds = %821
  %831 = icmp slt i64 %828, 0
  %832 = select i1 %831, i64 %148, i64 0
  %833 = getelementptr double, ptr %149, i64 %828
  %834 = getelementptr double, ptr %833, i64 %832
  %835 = load double, ptr %834, align 8, !noalias !15
  %836 = fcmp olt double %835, %822
  %837 = fcmp oeq double %835, %822
  %838 = and i1 %837, %823
  %839 = or i1 %836, %838
  br i1 %839, label %840, label %873

840:                                              ; preds = %863, %830
  %841 = phi i64 [ %828, %830 ], [ %861, %863 ]
  %842 = icmp slt i64 %841, 0
  %843 = select i1 %842, i64 %148, i64 0
  %844 = getelementptr double, ptr %149, i64 %841
  %845 = getelementptr double, ptr %844, i64 %843
  %846 = load double, ptr %845, align 8, !noalias !15
  %847 = fsub double %846, %421
  %848 = fdiv double %847, %463
  %849 = mul nsw i64 %841, %824
  %850 = shl i64 %849, 3
  %851 = add i64 %850, %1
  %852 = call i64 @llvm.smax.i64(i64 %106, i64 0)
  br label %1275

853:                                              ; preds = %1279
  %854 = getelementptr i8, ptr %191, i64 56
  %855 = load i64, ptr %854, align 8, !noalias !15
  %856 = load double, ptr %845, align 8, !noalias !15
  %857 = inttoptr i64 %855 to ptr
  %858 = call i64 %857(i64 %0, double %856, i64 %851) #2, !noalias !15
  %859 = icmp eq i64 %858, 0
  br i1 %859, label %860, label %875

860:                                              ; preds = %1279, %853
  %861 = add nsw i64 %841, 1
  %862 = icmp slt i64 %861, %148
  br i1 %862, label %863, label %873

863:                                              ; preds = %860
  %864 = icmp slt i64 %841, -1
  %865 = select i1 %864, i64 %148, i64 0
  %866 = getelementptr double, ptr %149, i64 %861
  %867 = getelementptr double, ptr %866, i64 %865
  %868 = load double, ptr %867, align 8, !noalias !15
  %869 = fcmp olt double %868, %822
  %870 = fcmp oeq double %868, %822
  %871 = and i1 %870, %823
  %872 = or i1 %869, %871
  br i1 %872, label %840, label %873

873:                                              ; preds = %863, %830, %860, %821
  %874 = phi i64 [ %828, %830 ], [ %861, %863 ], [ %861, %860 ], [ %828, %821 ]
  store i64 %874, ptr %827, align 8, !noalias !15
  br label %875

875:                                              ; preds = %853, %873
  %876 = phi i1 [ true, %873 ], [ false, %853 ]
  %877 = phi i64 [ 0, %873 ], [ %858, %853 ]
  %878 = icmp ne i64 %814, 0
  %879 = select i1 %876, i1 %878, i1 false
  %880 = and i1 %879, %823
  br i1 %880, label %881, label %919

881:                                              ; preds = %875
  %882 = call i64 @llvm.smax.i64(i64 %106, i64 0)
  br label %883

883:                                              ; preds = %881, %907
  %884 = phi i64 [ 0, %881 ], [ %909, %907 ]
  %885 = phi i64 [ %882, %881 ], [ %908, %907 ]
  %886 = icmp sgt i64 %885, 0
  br i1 %886, label %907, label %887

887:                                              ; preds = %883
  %888 = load i64, ptr %720, align 8, !noalias !92
  %889 = getelementptr i8, ptr %52, i64 16
  %890 = load i64, ptr %889, align 8, !noalias !92
  call fastcc void @pydy_nested(i64 %94, i64 %84, i64 %121, i64 %86, i64 %888, i64 %104, i64 %890) #2, !noalias !92
  %891 = call i64 @llvm.smax.i64(i64 %91, i64 0)
  br label %892

892:                                              ; preds = %896, %887
  %893 = phi i64 [ 0, %887 ], [ %898, %896 ]
  %894 = phi i64 [ %891, %887 ], [ %897, %896 ]
  %895 = icmp sgt i64 %894, 0
  br i1 %895, label %896, label %1290

896:                                              ; preds = %892
  %897 = add nsw i64 %894, -1
  %898 = add i64 %893, 1
  %899 = icmp slt i64 %893, 0
  %900 = select i1 %899, i64 %96, i64 0
  %901 = getelementptr double, ptr %97, i64 %893
  %902 = getelementptr double, ptr %901, i64 %900
  %903 = load double, ptr %902, align 8, !noalias !96
  %904 = select i1 %899, i64 %91, i64 0
  %905 = getelementptr double, ptr %92, i64 %893
  %906 = getelementptr double, ptr %905, i64 %904
  store double %903, ptr %906, align 8, !noalias !96
  br label %892

907:                                              ; preds = %883
  %908 = add nsw i64 %885, -1
  %909 = add i64 %884, 1
  %910 = icmp slt i64 %884, 0
  %911 = select i1 %910, i64 %106, i64 0
  %912 = getelementptr double, ptr %107, i64 %884
  %913 = getelementptr double, ptr %912, i64 %911
  store double %813, ptr %913, align 8, !noalias !92
  br label %883

914:                                              ; preds = %1290
  %915 = getelementptr i8, ptr %191, i64 56
  %916 = load i64, ptr %915, align 8, !noalias !15
  %917 = inttoptr i64 %916 to ptr
  %918 = call i64 %917(i64 %0, double %822, i64 %89) #2, !noalias !15
  br label %919

919:                                              ; preds = %1290, %914, %875
  %920 = phi i64 [ %918, %914 ], [ 0, %1290 ], [ %877, %875 ]
  %921 = icmp eq i64 %920, 0
  br i1 %921, label %923, label %922

922:                                              ; preds = %919
  store double %421, ptr %139, align 8, !noalias !15
  store double %463, ptr %243, align 8, !noalias !15
  br label %945

923:                                              ; preds = %919
  br i1 %815, label %924, label %926

924:                                              ; preds = %923
  store i8 0, ptr %23, align 1, !noalias !15
  %925 = call fastcc i32 @write_reached(ptr nonnull %23, ptr %52, ptr %92, i64 %91, ptr nonnull %139, ptr nonnull %144, i64 %148, ptr %149, i64 %148, ptr %153, i64 %152) #2
  switch i32 %925, label %1293 [
    i32 -2, label %926
    i32 0, label %926
  ], !prof !35

926:                                              ; preds = %924, %924, %923
  %927 = icmp eq i64 %814, 0
  br i1 %927, label %945, label %928

928:                                              ; preds = %926
  %929 = call i64 @llvm.smax.i64(i64 %86, i64 0)
  br label %930

930:                                              ; preds = %934, %928
  %931 = phi i64 [ 0, %928 ], [ %936, %934 ]
  %932 = phi i64 [ %929, %928 ], [ %935, %934 ]
  %933 = icmp sgt i64 %932, 0
  br i1 %933, label %934, label %1294

934:                                              ; preds = %930
  %935 = add nsw i64 %932, -1
  %936 = add i64 %931, 1
  %937 = icmp slt i64 %931, 0
  %938 = select i1 %937, i64 %91, i64 0
  %939 = getelementptr double, ptr %92, i64 %931
  %940 = getelementptr double, ptr %939, i64 %938
  %941 = load double, ptr %940, align 8, !noalias !99
  %942 = select i1 %937, i64 %86, i64 0
  %943 = getelementptr double, ptr %87, i64 %931
  %944 = getelementptr double, ptr %943, i64 %942
  store double %941, ptr %944, align 8, !noalias !99
  br label %930

945:                                              ; preds = %926, %1294, %922
  %946 = phi i1 [ false, %922 ], [ false, %1294 ], [ true, %926 ]
  %947 = phi i64 [ %920, %922 ], [ %814, %1294 ], [ 0, %926 ]
  br i1 %946, label %949, label %948

948:                                              ; preds = %945
  br label %1315

949:                                              ; preds = %686, %686, %945
  br i1 %233, label %950, label %1057

950:                                              ; preds = %949
  %951 = getelementptr i8, ptr %139, i64 40
  %952 = load double, ptr %951, align 8, !noalias !15
  %953 = getelementptr i8, ptr %49, i64 24
  %954 = load double, ptr %953, align 8, !noalias !102
  %955 = fcmp ogt double %667, 1.000000e-10
  %956 = select i1 %955, double %667, double 1.000000e-10
  %957 = getelementptr i8, ptr %49, i64 8
  %958 = load double, ptr %957, align 8, !noalias !102
  %959 = fneg double %958
  %960 = bitcast double %956 to i64
  %961 = add nsw i64 %960, -4604544271217802189
  %962 = ashr i64 %961, 52
  %963 = and i64 %961, -4503599627370496
  %964 = sub i64 %960, %963
  %965 = bitcast i64 %964 to double
  %966 = fadd double %965, -1.000000e+00
  %967 = fadd double %965, 1.000000e+00
  %968 = fdiv double %966, %967
  %969 = fmul double %968, %968
  %970 = call double @llvm.fma.f64(double %969, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %971 = call double @llvm.fma.f64(double %970, double %969, double 0x3FE2776C50EF9BFE)
  %972 = call double @llvm.fma.f64(double %971, double %969, double 0x3FEEC709DC3A03FD)
  %973 = call double @llvm.fma.f64(double %972, double %969, double 0x40071547652B82FE)
  %974 = fmul double %973, %968
  %975 = trunc nsw i64 %962 to i32
  %976 = sitofp i32 %975 to double
  %977 = fadd double %974, %976
  %978 = fmul double %977, %959
  %979 = fcmp ogt double %978, -1.000000e+03
  %980 = select i1 %979, double %978, double -1.000000e+03
  %981 = fcmp olt double %980, 1.000000e+03
  %982 = select i1 %981, double %980, double 1.000000e+03
  %983 = call double @llvm.rint.f64(double %982)
  %984 = fsub double %982, %983
  %985 = call double @llvm.fma.f64(double %984, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %986 = call double @llvm.fma.f64(double %985, double %984, double 0x3F55D87FE78A6730)
  %987 = call double @llvm.fma.f64(double %986, double %984, double 0x3F83B2AB6FBA4E77)
  %988 = call double @llvm.fma.f64(double %987, double %984, double 0x3FAC6B08D704A0BF)
  %989 = call double @llvm.fma.f64(double %988, double %984, double 0x3FCEBFBDFF82C58E)
  %990 = call double @llvm.fma.f64(double %989, double %984, double 0x3FE62E42FEFA39EF)
  %991 = call double @llvm.fma.f64(double %990, double %984, double 1.000000e+00)
  %992 = fptosi double %983 to i32
  %993 = zext i32 %992 to i64
  %994 = shl i64 %993, 52
  %995 = bitcast double %991 to i64
  %996 = add i64 %994, %995
  %997 = bitcast i64 %996 to double
  %998 = fmul double %954, %997
  %999 = getelementptr i8, ptr %49, i64 16
  %1000 = load double, ptr %999, align 8, !noalias !102
  %1001 = fcmp une double %1000, 0.000000e+00
  br i1 %1001, label %1002, label %1043

1002:                                             ; preds = %950
  %1003 = getelementptr i8, ptr %139, i64 24
  %1004 = load i64, ptr %1003, align 8, !noalias !15
  %1005 = add i64 %1004, -4604544271217802189
  %1006 = ashr i64 %1005, 52
  %1007 = and i64 %1005, -4503599627370496
  %1008 = sub i64 %1004, %1007
  %1009 = bitcast i64 %1008 to double
  %1010 = fadd double %1009, -1.000000e+00
  %1011 = fadd double %1009, 1.000000e+00
  %1012 = fdiv double %1010, %1011
  %1013 = fmul double %1012, %1012
  %1014 = call double @llvm.fma.f64(double %1013, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1015 = call double @llvm.fma.f64(double %1014, double %1013, double 0x3FE2776C50EF9BFE)
  %1016 = call double @llvm.fma.f64(double %1015, double %1013, double 0x3FEEC709DC3A03FD)
  %1017 = call double @llvm.fma.f64(double %1016, double %1013, double 0x40071547652B82FE)
  %1018 = fmul double %1017, %1012
  %1019 = trunc nsw i64 %1006 to i32
  %1020 = sitofp i32 %1019 to double
  %1021 = fadd double %1018, %1020
  %1022 = fmul double %1021, %1000
  %1023 = fcmp ogt double %1022, -1.000000e+03
  %1024 = select i1 %1023, double %1022, double -1.000000e+03
  %1025 = fcmp olt double %1024, 1.000000e+03
  %1026 = select i1 %1025, double %1024, double 1.000000e+03
  %1027 = call double @llvm.rint.f64(double %1026)
  %1028 = fsub double %1026, %1027
  %1029 = call double @llvm.fma.f64(double %1028, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1030 = call double @llvm.fma.f64(double %1029, double %1028, double 0x3F55D87FE78A6730)
  %1031 = call double @llvm.fma.f64(double %1030, double %1028, double 0x3F83B2AB6FBA4E77)
  %1032 = call double @llvm.fma.f64(double %1031, double %1028, double 0x3FAC6B08D704A0BF)
  %1033 = call double @llvm.fma.f64(double %1032, double %1028, double 0x3FCEBFBDFF82C58E)
  %1034 = call double @llvm.fma.f64(double %1033, double %1028, double 0x3FE62E42FEFA39EF)
  %1035 = call double @llvm.fma.f64(double %1034, double %1028, double 1.000000e+00)
  %1036 = fptosi double %1027 to i32
  %1037 = zext i32 %1036 to i64
  %1038 = shl i64 %1037, 52
  %1039 = bitcast double %1035 to i64
  %1040 = add i64 %1038, %1039
  %1041 = bitcast i64 %1040 to double
  %1042 = fmul double %998, %1041
  br label %1043

1043:                                             ; preds = %1002, %950
  %1044 = phi double [ %1042, %1002 ], [ %998, %950 ]
  %1045 = getelementptr i8, ptr %49, i64 32
  %1046 = load double, ptr %1045, align 8, !noalias !102
  %1047 = fcmp ogt double %1044, %1046
  %1048 = select i1 %1047, double %1044, double %1046
  %1049 = fcmp olt double %952, %1048
  %1050 = select i1 %1049, double %952, double %1048
  %1051 = fmul double %463, %1050
  %1052 = fcmp ogt double %667, 1.000000e-04
  %1053 = select i1 %1052, double %667, double 1.000000e-04
  %1054 = getelementptr i8, ptr %139, i64 24
  store double %1053, ptr %1054, align 8, !noalias !15
  %1055 = getelementptr i8, ptr %49, i64 40
  %1056 = load double, ptr %1055, align 8, !noalias !15
  store double %1056, ptr %951, align 8, !noalias !15
  br label %1057

1057:                                             ; preds = %1043, %949
  %1058 = phi double [ %1051, %1043 ], [ %420, %949 ]
  %1059 = call i64 @llvm.smax.i64(i64 %86, i64 0)
  br label %1060

1060:                                             ; preds = %1057, %1295
  %1061 = phi i64 [ 0, %1057 ], [ %1297, %1295 ]
  %1062 = phi i64 [ %1059, %1057 ], [ %1296, %1295 ]
  %1063 = icmp sgt i64 %1062, 0
  br i1 %1063, label %1295, label %1064

1064:                                             ; preds = %1060
  %1065 = getelementptr i8, ptr %144, i64 48
  %1066 = load i64, ptr %1065, align 8, !noalias !15
  %1067 = icmp eq i64 %1066, %148
  br i1 %1067, label %1132, label %419

1068:                                             ; preds = %664
  %1069 = load i64, ptr %429, align 8, !noalias !15
  %1070 = add nsw i64 %1069, 1
  store i64 %1070, ptr %429, align 8, !noalias !15
  %1071 = fsub double %667, %667
  %1072 = fcmp ord double %1071, 0.000000e+00
  %1073 = and i1 %668, %1072
  %1074 = select i1 %1073, i64 2, i64 4
  %1075 = select i1 %668, i64 %1074, i64 3
  %1076 = getelementptr i8, ptr %144, i64 72
  store i64 %1075, ptr %1076, align 8, !noalias !15
  br i1 %233, label %1077, label %1130

1077:                                             ; preds = %1068
  %1078 = getelementptr i8, ptr %49, i64 24
  %1079 = load double, ptr %1078, align 8, !noalias !105
  %1080 = fcmp ogt double %667, 1.000000e-10
  %1081 = select i1 %1080, double %667, double 1.000000e-10
  %1082 = bitcast double %1081 to i64
  %1083 = add nsw i64 %1082, -4604544271217802189
  %1084 = and i64 %1083, -4503599627370496
  %1085 = sub i64 %1082, %1084
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
  %1096 = ashr i64 %1083, 52
  %1097 = trunc nsw i64 %1096 to i32
  %1098 = sitofp i32 %1097 to double
  %1099 = fadd double %1095, %1098
  %1100 = load double, ptr %49, align 8, !noalias !105
  %1101 = fneg double %1100
  %1102 = fmul double %1099, %1101
  %1103 = fcmp ogt double %1102, -1.000000e+03
  %1104 = select i1 %1103, double %1102, double -1.000000e+03
  %1105 = fcmp olt double %1104, 1.000000e+03
  %1106 = select i1 %1105, double %1104, double 1.000000e+03
  %1107 = call double @llvm.rint.f64(double %1106)
  %1108 = fptosi double %1107 to i32
  %1109 = zext i32 %1108 to i64
  %1110 = shl i64 %1109, 52
  %1111 = fsub double %1106, %1107
  %1112 = call double @llvm.fma.f64(double %1111, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1113 = call double @llvm.fma.f64(double %1112, double %1111, double 0x3F55D87FE78A6730)
  %1114 = call double @llvm.fma.f64(double %1113, double %1111, double 0x3F83B2AB6FBA4E77)
  %1115 = call double @llvm.fma.f64(double %1114, double %1111, double 0x3FAC6B08D704A0BF)
  %1116 = call double @llvm.fma.f64(double %1115, double %1111, double 0x3FCEBFBDFF82C58E)
  %1117 = call double @llvm.fma.f64(double %1116, double %1111, double 0x3FE62E42FEFA39EF)
  %1118 = call double @llvm.fma.f64(double %1117, double %1111, double 1.000000e+00)
  %1119 = bitcast double %1118 to i64
  %1120 = add i64 %1110, %1119
  %1121 = bitcast i64 %1120 to double
  %1122 = fmul double %1079, %1121
  %1123 = getelementptr i8, ptr %49, i64 32
  %1124 = load double, ptr %1123, align 8, !noalias !105
  %1125 = fcmp ogt double %1122, %1124
  %1126 = select i1 %1125, double %1122, double %1124
  %1127 = select i1 %1073, double %1126, double 2.500000e-01
  %1128 = fmul double %463, %1127
  %1129 = getelementptr i8, ptr %139, i64 40
  store double 1.000000e+00, ptr %1129, align 8, !noalias !15
  br label %416

1130:                                             ; preds = %1068
  store double %463, ptr %243, align 8, !noalias !15
  br label %1315

1131:                                             ; preds = %455
  store double %463, ptr %243, align 8, !noalias !15
  br label %1315

1132:                                             ; preds = %1064
  store double %1058, ptr %243, align 8, !noalias !15
  br label %1315

1133:                                             ; preds = %261, %261
  %1134 = icmp eq i32 %262, 0
  br i1 %1134, label %268, label %264

1135:                                             ; preds = %261
  br label %1315

1136:                                             ; preds = %268, %268
  %1137 = load i8, ptr %19, align 1, !noalias !15
  %1138 = icmp eq i8 %1137, 0
  br i1 %1138, label %275, label %274

1139:                                             ; preds = %268
  br label %1315

1140:                                             ; preds = %277, %283
  br label %1315

1141:                                             ; preds = %296
  %1142 = add nsw i64 %298, -1
  %1143 = add i64 %297, 1
  %1144 = icmp slt i64 %297, 0
  %1145 = select i1 %1144, i64 %86, i64 0
  %1146 = getelementptr double, ptr %87, i64 %297
  %1147 = getelementptr double, ptr %1146, i64 %1145
  %1148 = load double, ptr %1147, align 8, !noalias !15
  %1149 = select i1 %1144, i64 %118, i64 0
  %1150 = getelementptr double, ptr %119, i64 %297
  %1151 = getelementptr double, ptr %1150, i64 %1149
  %1152 = load double, ptr %1151, align 8, !noalias !15
  %1153 = fmul double %294, %1152
  %1154 = fadd double %1148, %1153
  %1155 = select i1 %1144, i64 %96, i64 0
  %1156 = getelementptr double, ptr %97, i64 %297
  %1157 = getelementptr double, ptr %1156, i64 %1155
  store double %1154, ptr %1157, align 8, !noalias !15
  br label %296

1158:                                             ; preds = %317, %317
  br i1 %318, label %322, label %320

1159:                                             ; preds = %317
  br label %1315

1160:                                             ; preds = %331
  br label %1315

1161:                                             ; preds = %472
  %1162 = add nsw i64 %474, -1
  %1163 = add i64 %473, 1
  %1164 = icmp slt i64 %473, 0
  %1165 = select i1 %1164, i64 %101, i64 0
  %1166 = getelementptr double, ptr %102, i64 %473
  %1167 = getelementptr double, ptr %1166, i64 %1165
  store double %463, ptr %1167, align 8, !noalias !15
  br label %472

1168:                                             ; preds = %480
  %1169 = add nsw i64 %482, -1
  %1170 = add i64 %481, 1
  store ptr null, ptr %20, align 8, !noalias !15
  %1171 = call fastcc i32 @_combine_latest(ptr nonnull %20, ptr %31, i64 %30, ptr %36, i64 %35, ptr %41, i64 %40, ptr %52, ptr %87, ptr %102, ptr %119, i64 %118, i64 %481, i64 %94, double %463) #2
  switch i32 %1171, label %1200 [
    i32 -2, label %1172
    i32 0, label %1172
  ], !prof !35

1172:                                             ; preds = %1168, %1168
  %1173 = mul nsw i64 %481, %86
  %1174 = shl i64 %1173, 3
  %1175 = add i64 %1174, %116
  %1176 = getelementptr i8, ptr %144, i64 24
  %1177 = load i64, ptr %1176, align 8, !noalias !15
  %1178 = add nsw i64 %1177, 1
  store i64 %1178, ptr %1176, align 8, !noalias !15
  %1179 = icmp slt i64 %481, 0
  %1180 = select i1 %1179, i64 %45, i64 0
  %1181 = getelementptr double, ptr %46, i64 %481
  %1182 = getelementptr double, ptr %1181, i64 %1180
  %1183 = load double, ptr %1182, align 8, !noalias !15
  %1184 = fmul double %1183, %463
  %1185 = fadd double %421, %1184
  store ptr null, ptr %10, align 8, !noalias !108
  store ptr null, ptr %11, align 8, !noalias !108
  store double %1185, ptr %55, align 8, !noalias !108
  %1186 = icmp sgt i64 %67, 0
  br i1 %1186, label %1187, label %1190

1187:                                             ; preds = %1172
  store ptr null, ptr %10, align 8, !noalias !108
  %1188 = call fastcc i32 @_sample(ptr nonnull %10, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %1185) #2
  switch i32 %1188, label %1189 [
    i32 -2, label %1190
    i32 0, label %1190
  ], !prof !35

1189:                                             ; preds = %1187
  br label %1190

1190:                                             ; preds = %1187, %1187, %1172, %1189
  %1191 = phi i32 [ %1188, %1189 ], [ 0, %1172 ], [ 0, %1187 ], [ 0, %1187 ]
  switch i32 %1191, label %1197 [
    i32 -2, label %1192
    i32 0, label %1192
  ], !prof !35

1192:                                             ; preds = %1190, %1190
  %1193 = load i64, ptr %52, align 8, !noalias !115
  %1194 = inttoptr i64 %1193 to ptr
  %1195 = inttoptr i64 %1175 to ptr
  %1196 = call i32 %1194(ptr nonnull %55, ptr %97, ptr %60, ptr %63, ptr %1195) #2, !noalias !115
  br label %1197

1197:                                             ; preds = %1190, %1192
  %1198 = phi i32 [ %1196, %1192 ], [ 0, %1190 ]
  %1199 = phi i32 [ 0, %1192 ], [ %1191, %1190 ]
  switch i32 %1199, label %1203 [
    i32 -2, label %1201
    i32 0, label %1201
  ], !prof !35

1200:                                             ; preds = %1168
  br label %1315

1201:                                             ; preds = %1197, %1197
  %1202 = icmp eq i32 %1198, 0
  br i1 %1202, label %480, label %484

1203:                                             ; preds = %1197
  br label %1315

1204:                                             ; preds = %486
  br label %1315

1205:                                             ; preds = %510
  br label %1315

1206:                                             ; preds = %625
  %1207 = add nsw i64 %627, -1
  %1208 = add i64 %626, 1
  %1209 = icmp slt i64 %626, 0
  %1210 = select i1 %1209, i64 %91, i64 0
  %1211 = getelementptr double, ptr %92, i64 %626
  %1212 = getelementptr double, ptr %1211, i64 %1210
  %1213 = load double, ptr %1212, align 8, !noalias !15
  %1214 = fmul double %1213, 0.000000e+00
  %1215 = fadd double %628, %1214
  br label %625

1216:                                             ; preds = %660, %660
  %1217 = sext i32 %661 to i64
  %1218 = icmp slt i32 %661, 0
  br i1 %1218, label %663, label %664

1219:                                             ; preds = %660
  br label %1315

1220:                                             ; preds = %686
  br label %1315

1221:                                             ; preds = %693
  %1222 = load i64, ptr %231, align 8, !noalias !15
  %1223 = add nsw i64 %696, %1222
  %1224 = icmp slt i64 %1223, 0
  %1225 = select i1 %1224, i64 %30, i64 0
  %1226 = getelementptr i64, ptr %31, i64 %1223
  %1227 = getelementptr i64, ptr %1226, i64 %1225
  %1228 = load i64, ptr %1227, align 8, !noalias !116
  %1229 = shl i64 %1228, 3
  %1230 = add i64 %1229, %33
  %1231 = add i64 %1229, %38
  %1232 = icmp slt i64 %1223, -1
  %1233 = select i1 %1232, i64 %30, i64 0
  %1234 = getelementptr i8, ptr %1226, i64 8
  %1235 = getelementptr i64, ptr %1234, i64 %1233
  %1236 = load i64, ptr %1235, align 8, !noalias !116
  %1237 = xor i64 %1228, -1
  %1238 = add i64 %1236, %1237
  %1239 = getelementptr i8, ptr %52, i64 16
  %1240 = load i64, ptr %1239, align 8, !noalias !116
  call fastcc void @pydy_combine(i64 %94, i64 %84, i64 %99, i64 %116, i64 %1230, i64 %1231, i64 %1238, i64 1, i64 %1240) #2, !noalias !116
  %1241 = mul nsw i64 %696, %86
  %1242 = shl i64 %1241, 3
  %1243 = add i64 %1242, %116
  %1244 = getelementptr i8, ptr %144, i64 24
  %1245 = load i64, ptr %1244, align 8, !noalias !15
  %1246 = add nsw i64 %1245, 1
  store i64 %1246, ptr %1244, align 8, !noalias !15
  %1247 = icmp slt i64 %696, 0
  %1248 = select i1 %1247, i64 %45, i64 0
  %1249 = getelementptr double, ptr %46, i64 %696
  %1250 = getelementptr double, ptr %1249, i64 %1248
  %1251 = load double, ptr %1250, align 8, !noalias !15
  %1252 = fmul double %1251, %463
  %1253 = fadd double %421, %1252
  store ptr null, ptr %4, align 8, !noalias !122
  store ptr null, ptr %5, align 8, !noalias !122
  store double %1253, ptr %55, align 8, !noalias !122
  %1254 = icmp sgt i64 %67, 0
  br i1 %1254, label %1255, label %1258

1255:                                             ; preds = %1221
  store ptr null, ptr %4, align 8, !noalias !122
  %1256 = call fastcc i32 @_sample(ptr nonnull %4, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %1253) #2
  switch i32 %1256, label %1257 [
    i32 -2, label %1258
    i32 0, label %1258
  ], !prof !35

1257:                                             ; preds = %1255
  br label %1258

1258:                                             ; preds = %1255, %1255, %1221, %1257
  %1259 = phi i32 [ %1256, %1257 ], [ 0, %1221 ], [ 0, %1255 ], [ 0, %1255 ]
  switch i32 %1259, label %1265 [
    i32 -2, label %1260
    i32 0, label %1260
  ], !prof !35

1260:                                             ; preds = %1258, %1258
  %1261 = load i64, ptr %52, align 8, !noalias !129
  %1262 = inttoptr i64 %1261 to ptr
  %1263 = inttoptr i64 %1243 to ptr
  %1264 = call i32 %1262(ptr nonnull %55, ptr %97, ptr %60, ptr %63, ptr %1263) #2, !noalias !129
  br label %1265

1265:                                             ; preds = %1258, %1260
  %1266 = phi i32 [ %1264, %1260 ], [ 0, %1258 ]
  %1267 = phi i32 [ 0, %1260 ], [ %1259, %1258 ]
  switch i32 %1267, label %1271 [
    i32 -2, label %1268
    i32 0, label %1268
  ], !prof !35

1268:                                             ; preds = %1265, %1265
  %1269 = add nsw i64 %695, -1
  %1270 = icmp eq i32 %1266, 0
  br i1 %1270, label %693, label %698

1271:                                             ; preds = %1265
  br label %1315

1272:                                             ; preds = %724
  %1273 = load i64, ptr %674, align 8, !noalias !15
  %1274 = icmp sgt i64 %1273, 0
  br i1 %1274, label %805, label %812

1275:                                             ; preds = %840, %1283
  %1276 = phi i64 [ 0, %840 ], [ %1285, %1283 ]
  %1277 = phi i64 [ %852, %840 ], [ %1284, %1283 ]
  %1278 = icmp sgt i64 %1277, 0
  br i1 %1278, label %1283, label %1279

1279:                                             ; preds = %1275
  %1280 = load i64, ptr %720, align 8, !noalias !130
  %1281 = getelementptr i8, ptr %52, i64 16
  %1282 = load i64, ptr %1281, align 8, !noalias !130
  call fastcc void @pydy_nested(i64 %851, i64 %84, i64 %121, i64 %86, i64 %1280, i64 %104, i64 %1282) #2, !noalias !130
  br i1 %826, label %853, label %860

1283:                                             ; preds = %1275
  %1284 = add nsw i64 %1277, -1
  %1285 = add i64 %1276, 1
  %1286 = icmp slt i64 %1276, 0
  %1287 = select i1 %1286, i64 %106, i64 0
  %1288 = getelementptr double, ptr %107, i64 %1276
  %1289 = getelementptr double, ptr %1288, i64 %1287
  store double %848, ptr %1289, align 8, !noalias !130
  br label %1275

1290:                                             ; preds = %892
  %1291 = load i64, ptr %191, align 8, !noalias !15
  %1292 = icmp eq i64 %1291, 1
  br i1 %1292, label %914, label %919

1293:                                             ; preds = %924
  br label %1315

1294:                                             ; preds = %930
  store double %822, ptr %139, align 8, !noalias !15
  store double 0.000000e+00, ptr %243, align 8, !noalias !15
  store i64 0, ptr %144, align 8, !noalias !15
  br label %945

1295:                                             ; preds = %1060
  %1296 = add nsw i64 %1062, -1
  %1297 = add i64 %1061, 1
  %1298 = icmp slt i64 %1061, 0
  %1299 = select i1 %1298, i64 %91, i64 0
  %1300 = getelementptr double, ptr %92, i64 %1061
  %1301 = getelementptr double, ptr %1300, i64 %1299
  %1302 = load double, ptr %1301, align 8, !noalias !15
  %1303 = select i1 %1298, i64 %86, i64 0
  %1304 = getelementptr double, ptr %87, i64 %1061
  %1305 = getelementptr double, ptr %1304, i64 %1303
  store double %1302, ptr %1305, align 8, !noalias !15
  %1306 = add nsw i64 %234, %1061
  %1307 = icmp slt i64 %1306, 0
  %1308 = select i1 %1307, i64 %118, i64 0
  %1309 = getelementptr double, ptr %119, i64 %1306
  %1310 = getelementptr double, ptr %1309, i64 %1308
  %1311 = load double, ptr %1310, align 8, !noalias !15
  %1312 = select i1 %1298, i64 %118, i64 0
  %1313 = getelementptr double, ptr %119, i64 %1061
  %1314 = getelementptr double, ptr %1313, i64 %1312
  store double %1311, ptr %1314, align 8, !noalias !15
  br label %1060

1315:                                             ; preds = %1293, %1271, %1220, %1219, %1205, %1204, %1203, %1200, %1160, %1159, %1140, %1139, %1135, %1132, %1131, %1130, %948, %698, %663, %644, %516, %435, %424, %274, %264, %226
  %1316 = phi i64 [ 0, %1271 ], [ -1, %226 ], [ 0, %1135 ], [ %267, %264 ], [ 0, %1139 ], [ 0, %274 ], [ 0, %1140 ], [ 0, %1160 ], [ 0, %1159 ], [ -1, %424 ], [ 1, %435 ], [ 2, %1131 ], [ 0, %1204 ], [ 0, %1200 ], [ 0, %1203 ], [ 0, %1205 ], [ -4, %516 ], [ 0, %1293 ], [ 6, %644 ], [ 0, %1219 ], [ -4, %663 ], [ 2, %1130 ], [ 0, %1220 ], [ %947, %948 ], [ 0, %1132 ], [ %701, %698 ]
  ret i64 %1316
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
!65 = !{!66, !68, !70, !62, !64, !16, !18}
!66 = distinct !{!66, !67}
!67 = distinct !{!67}
!68 = distinct !{!68, !69}
!69 = distinct !{!69}
!70 = distinct !{!70, !69}
!71 = !{!72, !62, !64, !16, !18}
!72 = distinct !{!72, !73}
!73 = distinct !{!73}
!74 = !{!75, !77, !78, !80}
!75 = distinct !{!75, !76}
!76 = distinct !{!76}
!77 = distinct !{!77, !76}
!78 = distinct !{!78, !79}
!79 = distinct !{!79}
!80 = distinct !{!80, !79}
!81 = !{!78, !80}
!82 = !{!83, !85, !16, !18}
!83 = distinct !{!83, !84}
!84 = distinct !{!84}
!85 = distinct !{!85, !84}
!86 = !{!87, !89, !91, !83, !85, !16, !18}
!87 = distinct !{!87, !88}
!88 = distinct !{!88}
!89 = distinct !{!89, !90}
!90 = distinct !{!90}
!91 = distinct !{!91, !90}
!92 = !{!93, !95, !16, !18}
!93 = distinct !{!93, !94}
!94 = distinct !{!94}
!95 = distinct !{!95, !94}
!96 = !{!97}
!97 = distinct !{!97, !98}
!98 = distinct !{!98}
!99 = !{!100}
!100 = distinct !{!100, !101}
!101 = distinct !{!101}
!102 = !{!103, !16, !18}
!103 = distinct !{!103, !104}
!104 = distinct !{!104}
!105 = !{!106, !16, !18}
!106 = distinct !{!106, !107}
!107 = distinct !{!107}
!108 = !{!109, !111, !112, !114}
!109 = distinct !{!109, !110}
!110 = distinct !{!110}
!111 = distinct !{!111, !110}
!112 = distinct !{!112, !113}
!113 = distinct !{!113}
!114 = distinct !{!114, !113}
!115 = !{!112, !114}
!116 = !{!117, !119, !121, !16, !18}
!117 = distinct !{!117, !118}
!118 = distinct !{!118}
!119 = distinct !{!119, !120}
!120 = distinct !{!120}
!121 = distinct !{!121, !120}
!122 = !{!123, !125, !126, !128}
!123 = distinct !{!123, !124}
!124 = distinct !{!124}
!125 = distinct !{!125, !124}
!126 = distinct !{!126, !127}
!127 = distinct !{!127}
!128 = distinct !{!128, !127}
!129 = !{!126, !128}
!130 = !{!131, !133, !16, !18}
!131 = distinct !{!131, !132}
!132 = distinct !{!132}
!133 = distinct !{!133, !132}
