; sources c32cc0cf9834991fc056df8c5e10ba02812dd185052e4b1032f66b5f1fb37ab4
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
  br label %1466

227:                                              ; preds = %188
  %228 = getelementptr i8, ptr %24, i64 1032
  %229 = load i64, ptr %228, align 8, !noalias !15
  %230 = inttoptr i64 %229 to ptr
  %231 = getelementptr i8, ptr %24, i64 1056
  %232 = load i64, ptr %231, align 8, !noalias !15
  %233 = getelementptr i8, ptr %24, i64 1064
  %234 = load i64, ptr %233, align 8, !noalias !15
  %235 = getelementptr i8, ptr %24, i64 1072
  %236 = load i64, ptr %235, align 8, !noalias !15
  %237 = inttoptr i64 %232 to ptr
  %238 = load i64, ptr %26, align 8, !noalias !15
  %239 = load i64, ptr %191, align 8, !noalias !15
  %240 = icmp eq i64 %239, 1
  %241 = getelementptr i8, ptr %26, i64 8
  %242 = load i64, ptr %241, align 8, !noalias !15
  %243 = icmp slt i64 %242, 1
  %244 = mul nsw i64 %238, %86
  %245 = shl i64 %244, 3
  %246 = add i64 %245, %116
  %247 = call i64 @llvm.smin.i64(i64 %148, i64 0)
  %248 = getelementptr double, ptr %149, i64 %148
  %249 = getelementptr i8, ptr %248, i64 -8
  %250 = getelementptr double, ptr %249, i64 %247
  %251 = load double, ptr %250, align 8, !noalias !15
  %252 = load double, ptr %139, align 8, !noalias !15
  %253 = getelementptr i8, ptr %139, i64 8
  %254 = load double, ptr %253, align 8, !noalias !15
  %255 = load i64, ptr %144, align 8, !noalias !15
  %256 = icmp eq i64 %255, 0
  br i1 %256, label %257, label %427

257:                                              ; preds = %227
  %258 = getelementptr i8, ptr %144, i64 24
  %259 = load i64, ptr %258, align 8, !noalias !15
  %260 = add nsw i64 %259, 1
  store i64 %260, ptr %258, align 8, !noalias !15
  store ptr null, ptr %12, align 8, !noalias !28
  store ptr null, ptr %13, align 8, !noalias !28
  store double %252, ptr %55, align 8, !noalias !28
  %261 = icmp sgt i64 %67, 0
  br i1 %261, label %262, label %265

262:                                              ; preds = %257
  store ptr null, ptr %12, align 8, !noalias !28
  %263 = call fastcc i32 @_sample(ptr nonnull %12, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %252) #2
  switch i32 %263, label %264 [
    i32 -2, label %265
    i32 0, label %265
  ], !prof !35

264:                                              ; preds = %262
  br label %265

265:                                              ; preds = %262, %262, %257, %264
  %266 = phi i32 [ %263, %264 ], [ 0, %257 ], [ 0, %262 ], [ 0, %262 ]
  switch i32 %266, label %271 [
    i32 -2, label %267
    i32 0, label %267
  ], !prof !35

267:                                              ; preds = %265, %265
  %268 = load i64, ptr %52, align 8, !noalias !36
  %269 = inttoptr i64 %268 to ptr
  %270 = call i32 %269(ptr nonnull %55, ptr %87, ptr %60, ptr %63, ptr %119) #2, !noalias !36
  br label %271

271:                                              ; preds = %265, %267
  %272 = phi i32 [ %270, %267 ], [ 0, %265 ]
  %273 = phi i32 [ 0, %267 ], [ %266, %265 ]
  switch i32 %273, label %1282 [
    i32 -2, label %1280
    i32 0, label %1280
  ], !prof !35

274:                                              ; preds = %1280
  %275 = getelementptr i8, ptr %144, i64 72
  store i64 3, ptr %275, align 8, !noalias !15
  %276 = icmp slt i32 %272, 0
  %277 = select i1 %276, i64 -4, i64 2
  br label %1466

278:                                              ; preds = %1280
  store i64 1, ptr %144, align 8, !noalias !15
  %279 = getelementptr i8, ptr %49, i64 40
  %280 = load double, ptr %279, align 8, !noalias !15
  %281 = getelementptr i8, ptr %139, i64 24
  store double 1.000000e-04, ptr %281, align 8, !noalias !15
  %282 = getelementptr i8, ptr %139, i64 40
  store double %280, ptr %282, align 8, !noalias !15
  store i8 0, ptr %19, align 1, !noalias !15
  %283 = call fastcc i32 @write_reached(ptr nonnull %19, ptr %52, ptr %87, i64 %86, ptr nonnull %139, ptr nonnull %144, i64 %148, ptr %149, i64 %148, ptr %153, i64 %152) #2
  switch i32 %283, label %1286 [
    i32 -2, label %1283
    i32 0, label %1283
  ], !prof !35

284:                                              ; preds = %1283
  br label %1466

285:                                              ; preds = %1283
  %286 = fcmp oeq double %254, 0.000000e+00
  br i1 %286, label %287, label %427

287:                                              ; preds = %285
  %288 = load i64, ptr %150, align 8, !noalias !15
  %289 = getelementptr i8, ptr %139, i64 16
  %290 = load double, ptr %289, align 8, !noalias !15
  %291 = getelementptr i8, ptr %52, i64 24
  %292 = load i64, ptr %291, align 8, !noalias !15
  store double 0.000000e+00, ptr %17, align 8, !noalias !37
  store double 0.000000e+00, ptr %18, align 8, !noalias !37
  store double 0.000000e+00, ptr %17, align 8, !noalias !37
  %293 = call fastcc i32 @norm(ptr nonnull %17, ptr %87, ptr %87, ptr %87, ptr %129, i64 %128, ptr %134, i64 %133, i64 %292) #2
  %294 = load double, ptr %17, align 8, !noalias !37
  switch i32 %293, label %1287 [
    i32 -2, label %295
    i32 0, label %295
  ], !prof !35

295:                                              ; preds = %287, %287
  store double 0.000000e+00, ptr %18, align 8, !noalias !37
  %296 = call fastcc i32 @norm(ptr nonnull %18, ptr %119, ptr %87, ptr %87, ptr %129, i64 %128, ptr %134, i64 %133, i64 %292) #2
  %297 = load double, ptr %18, align 8, !noalias !37
  switch i32 %296, label %1287 [
    i32 -2, label %298
    i32 0, label %298
  ], !prof !35

298:                                              ; preds = %295, %295
  %299 = fcmp olt double %294, 1.000000e-05
  %300 = fcmp olt double %297, 1.000000e-05
  %301 = or i1 %299, %300
  %302 = fmul double %294, 1.000000e-02
  %303 = fdiv double %302, %297
  %304 = select i1 %301, double 0x3EB0C6F7A0B5ED8D, double %303
  %305 = fcmp olt double %290, %304
  %306 = select i1 %305, double %290, double %304
  %307 = call i64 @llvm.smax.i64(i64 %288, i64 0)
  br label %308

308:                                              ; preds = %298, %1288
  %309 = phi i64 [ 0, %298 ], [ %1290, %1288 ]
  %310 = phi i64 [ %307, %298 ], [ %1289, %1288 ]
  %311 = icmp sgt i64 %310, 0
  br i1 %311, label %1288, label %312

312:                                              ; preds = %308
  %313 = load i64, ptr %258, align 8, !noalias !15
  %314 = add nsw i64 %313, 1
  store i64 %314, ptr %258, align 8, !noalias !15
  %315 = shl i64 %86, 3
  %316 = add i64 %315, %116
  %317 = fadd double %252, %306
  store ptr null, ptr %14, align 8, !noalias !41
  store ptr null, ptr %15, align 8, !noalias !41
  store double %317, ptr %55, align 8, !noalias !41
  br i1 %261, label %318, label %321

318:                                              ; preds = %312
  store ptr null, ptr %14, align 8, !noalias !41
  %319 = call fastcc i32 @_sample(ptr nonnull %14, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %317) #2
  switch i32 %319, label %320 [
    i32 -2, label %321
    i32 0, label %321
  ], !prof !35

320:                                              ; preds = %318
  br label %321

321:                                              ; preds = %318, %318, %312, %320
  %322 = phi i32 [ %319, %320 ], [ 0, %312 ], [ 0, %318 ], [ 0, %318 ]
  switch i32 %322, label %329 [
    i32 -2, label %323
    i32 0, label %323
  ], !prof !35

323:                                              ; preds = %321, %321
  %324 = load i64, ptr %52, align 8, !noalias !48
  %325 = inttoptr i64 %324 to ptr
  %326 = inttoptr i64 %316 to ptr
  %327 = call i32 %325(ptr nonnull %55, ptr %97, ptr %60, ptr %63, ptr %326) #2, !noalias !48
  %328 = icmp eq i32 %327, 0
  br label %329

329:                                              ; preds = %321, %323
  %330 = phi i1 [ %328, %323 ], [ true, %321 ]
  %331 = phi i32 [ 0, %323 ], [ %322, %321 ]
  switch i32 %331, label %1306 [
    i32 -2, label %1305
    i32 0, label %1305
  ], !prof !35

332:                                              ; preds = %1305
  %333 = fmul double %306, 1.000000e-03
  br label %422

334:                                              ; preds = %1305
  store double 0.000000e+00, ptr %16, align 8, !noalias !49
  %335 = icmp slt i64 %86, 0
  %336 = select i1 %335, i64 %118, i64 0
  %337 = add i64 %86, %336
  %338 = icmp slt i64 %337, 0
  br i1 %338, label %345, label %346, !prof !4

339:                                              ; preds = %350, %354
  %340 = phi i64 [ 0, %350 ], [ %356, %354 ]
  %341 = phi i64 [ %353, %350 ], [ %355, %354 ]
  %342 = icmp sgt i64 %341, 0
  br i1 %342, label %354, label %343

343:                                              ; preds = %339
  store double 0.000000e+00, ptr %16, align 8, !noalias !49
  %344 = call fastcc i32 @norm(ptr nonnull %16, ptr %352, ptr %87, ptr %87, ptr %129, i64 %128, ptr %134, i64 %133, i64 %292) #2
  switch i32 %344, label %1307 [
    i32 -2, label %362
    i32 0, label %362
  ], !prof !35

345:                                              ; preds = %334
  br label %346

346:                                              ; preds = %345, %334
  %347 = phi i64 [ 0, %345 ], [ %337, %334 ]
  %348 = icmp slt i64 %337, %118
  br i1 %348, label %350, label %349, !prof !8

349:                                              ; preds = %346
  br label %350

350:                                              ; preds = %349, %346
  %351 = phi i64 [ %118, %349 ], [ %347, %346 ]
  %352 = getelementptr double, ptr %119, i64 %351
  %353 = call i64 @llvm.smax.i64(i64 %292, i64 0)
  br label %339

354:                                              ; preds = %339
  %355 = add nsw i64 %341, -1
  %356 = add i64 %340, 1
  %357 = getelementptr double, ptr %352, i64 %340
  %358 = load double, ptr %357, align 8, !noalias !49
  %359 = getelementptr double, ptr %119, i64 %340
  %360 = load double, ptr %359, align 8, !noalias !49
  %361 = fsub double %358, %360
  store double %361, ptr %357, align 8, !noalias !49
  br label %339

362:                                              ; preds = %343, %343
  %363 = load double, ptr %16, align 8, !noalias !49
  %364 = fdiv double %363, %306
  %365 = fcmp ogt double %297, %364
  %366 = select i1 %365, double %297, double %364
  %367 = fcmp ogt double %366, 1.000000e-15
  %368 = fdiv double 1.000000e-02, %366
  %369 = select i1 %367, double %368, double 1.000000e+13
  %370 = load double, ptr %49, align 8, !noalias !49
  %371 = bitcast double %369 to i64
  %372 = add nsw i64 %371, -4604544271217802189
  %373 = ashr i64 %372, 52
  %374 = and i64 %372, -4503599627370496
  %375 = sub i64 %371, %374
  %376 = bitcast i64 %375 to double
  %377 = fadd double %376, -1.000000e+00
  %378 = fadd double %376, 1.000000e+00
  %379 = fdiv double %377, %378
  %380 = fmul double %379, %379
  %381 = call double @llvm.fma.f64(double %380, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %382 = call double @llvm.fma.f64(double %381, double %380, double 0x3FE2776C50EF9BFE)
  %383 = call double @llvm.fma.f64(double %382, double %380, double 0x3FEEC709DC3A03FD)
  %384 = call double @llvm.fma.f64(double %383, double %380, double 0x40071547652B82FE)
  %385 = fmul double %384, %379
  %386 = trunc nsw i64 %373 to i32
  %387 = sitofp i32 %386 to double
  %388 = fadd double %385, %387
  %389 = fmul double %388, %370
  %390 = fcmp ogt double %389, -1.000000e+03
  %391 = select i1 %390, double %389, double -1.000000e+03
  %392 = fcmp olt double %391, 1.000000e+03
  %393 = select i1 %392, double %391, double 1.000000e+03
  %394 = call double @llvm.rint.f64(double %393)
  %395 = fsub double %393, %394
  %396 = call double @llvm.fma.f64(double %395, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %397 = call double @llvm.fma.f64(double %396, double %395, double 0x3F55D87FE78A6730)
  %398 = call double @llvm.fma.f64(double %397, double %395, double 0x3F83B2AB6FBA4E77)
  %399 = call double @llvm.fma.f64(double %398, double %395, double 0x3FAC6B08D704A0BF)
  %400 = call double @llvm.fma.f64(double %399, double %395, double 0x3FCEBFBDFF82C58E)
  %401 = call double @llvm.fma.f64(double %400, double %395, double 0x3FE62E42FEFA39EF)
  %402 = call double @llvm.fma.f64(double %401, double %395, double 1.000000e+00)
  %403 = fptosi double %394 to i32
  %404 = zext i32 %403 to i64
  %405 = shl i64 %404, 52
  %406 = bitcast double %402 to i64
  %407 = add i64 %405, %406
  %408 = bitcast i64 %407 to double
  %409 = fmul double %306, 1.000000e-03
  %410 = fcmp olt double %409, 0x3EB0C6F7A0B5ED8D
  %411 = select i1 %410, double 0x3EB0C6F7A0B5ED8D, double %409
  %412 = fmul double %306, 1.000000e+02
  %413 = select i1 %367, double %408, double %411
  %414 = fcmp olt double %412, %413
  %415 = select i1 %414, double %412, double %413
  %416 = call double @llvm.fabs.f64(double %252)
  %417 = fmul double %416, 0x3D30000000000000
  %418 = fcmp ogt double %417, %415
  %419 = select i1 %418, double %417, double %415
  %420 = fcmp olt double %290, %419
  %421 = select i1 %420, double %290, double %419
  br label %422

422:                                              ; preds = %362, %332
  %423 = phi double [ %333, %332 ], [ %421, %362 ]
  %424 = call i1 @llvm.is.fpclass.f64(double %423, i32 384)
  br i1 %424, label %427, label %425

425:                                              ; preds = %422
  %426 = getelementptr i8, ptr %144, i64 72
  store i64 4, ptr %426, align 8, !noalias !15
  br label %427

427:                                              ; preds = %422, %425, %285, %227
  %428 = phi double [ %423, %422 ], [ %423, %425 ], [ %254, %285 ], [ %254, %227 ]
  br label %429

429:                                              ; preds = %1274, %427
  %430 = phi double [ %428, %427 ], [ %1276, %1274 ]
  %431 = phi double [ %252, %427 ], [ %434, %1274 ]
  br label %432

432:                                              ; preds = %1205, %429
  %433 = phi double [ %430, %429 ], [ %1199, %1205 ]
  %434 = phi double [ %431, %429 ], [ %486, %1205 ]
  %435 = load i64, ptr %195, align 8, !noalias !15
  %436 = icmp eq i64 %435, 0
  br i1 %436, label %437, label %438

437:                                              ; preds = %432
  store double %433, ptr %253, align 8, !noalias !15
  br label %1466

438:                                              ; preds = %432
  %439 = getelementptr i8, ptr %230, i64 8
  %440 = load i64, ptr %439, align 8, !noalias !53
  %441 = icmp sgt i64 %440, 0
  br i1 %441, label %442, label %447

442:                                              ; preds = %438
  %443 = load i64, ptr %230, align 8, !noalias !53
  %444 = add nsw i64 %443, 3
  %445 = icmp slt i64 %440, %444
  br i1 %445, label %446, label %447

446:                                              ; preds = %442
  store double %433, ptr %253, align 8, !noalias !15
  br label %1466

447:                                              ; preds = %438, %442
  %448 = add nsw i64 %435, -1
  store i64 %448, ptr %195, align 8, !noalias !15
  %449 = getelementptr i8, ptr %144, i64 8
  %450 = load i64, ptr %449, align 8, !noalias !15
  %451 = getelementptr i8, ptr %144, i64 16
  %452 = load i64, ptr %451, align 8, !noalias !15
  %453 = add nsw i64 %450, %452
  %454 = getelementptr i8, ptr %144, i64 64
  %455 = load i64, ptr %454, align 8, !noalias !15
  %456 = icmp slt i64 %453, %455
  br i1 %456, label %458, label %457

457:                                              ; preds = %447
  store double %433, ptr %253, align 8, !noalias !15
  br label %1466

458:                                              ; preds = %447
  br i1 %243, label %464, label %459

459:                                              ; preds = %458
  %460 = getelementptr i8, ptr %139, i64 16
  %461 = load double, ptr %460, align 8, !noalias !15
  %462 = fcmp olt double %433, %461
  %463 = select i1 %462, double %433, double %461
  br label %477

464:                                              ; preds = %458
  %465 = getelementptr i8, ptr %144, i64 48
  %466 = load i64, ptr %465, align 8, !noalias !15
  %467 = icmp slt i64 %466, 0
  %468 = select i1 %467, i64 %148, i64 0
  %469 = getelementptr double, ptr %149, i64 %466
  %470 = getelementptr double, ptr %469, i64 %468
  %471 = load double, ptr %470, align 8, !noalias !15
  %472 = fsub double %471, %434
  %473 = fdiv double %472, %433
  %474 = fmul double %473, 0x3FEFFFFFFFFFDCD1
  %475 = call double @llvm.ceil.f64(double %474)
  %476 = fdiv double %472, %475
  br label %477

477:                                              ; preds = %464, %459
  %478 = phi double [ %251, %459 ], [ %471, %464 ]
  %479 = phi double [ %463, %459 ], [ %476, %464 ]
  %480 = fadd double %434, %479
  %481 = fmul double %479, 1.000000e-03
  %482 = fsub double %478, %481
  %483 = fcmp ogt double %480, %482
  %484 = fsub double %478, %434
  %485 = select i1 %483, double %484, double %479
  %486 = select i1 %483, double %478, double %480
  %487 = fmul double %485, 6.250000e-02
  %488 = fadd double %434, %487
  %489 = fcmp ogt double %488, %434
  %490 = fcmp oeq double %486, %478
  %491 = or i1 %489, %490
  br i1 %491, label %492, label %1278

492:                                              ; preds = %477
  %493 = call i64 @llvm.smax.i64(i64 %101, i64 0)
  br label %494

494:                                              ; preds = %492, %1308
  %495 = phi i64 [ 0, %492 ], [ %1310, %1308 ]
  %496 = phi i64 [ %493, %492 ], [ %1309, %1308 ]
  %497 = icmp sgt i64 %496, 0
  br i1 %497, label %1308, label %498

498:                                              ; preds = %494
  %499 = load i64, ptr %26, align 8, !noalias !15
  %500 = add i64 %499, -1
  %501 = call i64 @llvm.smax.i64(i64 %500, i64 0)
  br label %502

502:                                              ; preds = %1348, %498
  %503 = phi i64 [ 1, %498 ], [ %1317, %1348 ]
  %504 = phi i64 [ %501, %498 ], [ %1316, %1348 ]
  %505 = icmp slt i64 %504, 1
  br i1 %505, label %508, label %1315

506:                                              ; preds = %1348
  %507 = sext i32 %1345 to i64
  br label %510

508:                                              ; preds = %502
  store ptr null, ptr %21, align 8, !noalias !15
  %509 = call fastcc i32 @_combine_latest(ptr nonnull %21, ptr %31, i64 %30, ptr %36, i64 %35, ptr %41, i64 %40, ptr %52, ptr %87, ptr %102, ptr %119, i64 %118, i64 %499, i64 %89, double %485) #2
  switch i32 %509, label %1351 [
    i32 -2, label %510
    i32 0, label %510
  ], !prof !35

510:                                              ; preds = %508, %508, %506
  %511 = phi i64 [ %507, %506 ], [ 0, %508 ], [ 0, %508 ]
  br i1 %505, label %512, label %535

512:                                              ; preds = %510
  %513 = getelementptr i8, ptr %26, i64 32
  %514 = load i64, ptr %513, align 8, !noalias !15
  %515 = icmp eq i64 %514, 1
  br i1 %515, label %516, label %535

516:                                              ; preds = %512
  %517 = getelementptr i8, ptr %144, i64 24
  %518 = load i64, ptr %517, align 8, !noalias !15
  %519 = add nsw i64 %518, 1
  store i64 %519, ptr %517, align 8, !noalias !15
  store ptr null, ptr %8, align 8, !noalias !56
  store ptr null, ptr %9, align 8, !noalias !56
  store double %486, ptr %55, align 8, !noalias !56
  %520 = icmp sgt i64 %67, 0
  br i1 %520, label %521, label %524

521:                                              ; preds = %516
  store ptr null, ptr %8, align 8, !noalias !56
  %522 = call fastcc i32 @_sample(ptr nonnull %8, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %486) #2
  switch i32 %522, label %523 [
    i32 -2, label %524
    i32 0, label %524
  ], !prof !35

523:                                              ; preds = %521
  br label %524

524:                                              ; preds = %521, %521, %516, %523
  %525 = phi i32 [ %522, %523 ], [ 0, %516 ], [ 0, %521 ], [ 0, %521 ]
  switch i32 %525, label %532 [
    i32 -2, label %526
    i32 0, label %526
  ], !prof !35

526:                                              ; preds = %524, %524
  %527 = load i64, ptr %52, align 8, !noalias !63
  %528 = inttoptr i64 %527 to ptr
  %529 = inttoptr i64 %246 to ptr
  %530 = call i32 %528(ptr nonnull %55, ptr %92, ptr %60, ptr %63, ptr %529) #2, !noalias !63
  %531 = sext i32 %530 to i64
  br label %532

532:                                              ; preds = %524, %526
  %533 = phi i64 [ %531, %526 ], [ 0, %524 ]
  %534 = phi i32 [ 0, %526 ], [ %525, %524 ]
  switch i32 %534, label %1352 [
    i32 -2, label %535
    i32 0, label %535
  ], !prof !35

535:                                              ; preds = %532, %532, %512, %510
  %536 = phi i64 [ %511, %510 ], [ 0, %512 ], [ %533, %532 ], [ %533, %532 ]
  %537 = icmp slt i64 %536, 0
  br i1 %537, label %538, label %539

538:                                              ; preds = %535
  br label %1466

539:                                              ; preds = %535
  %540 = icmp eq i64 %536, 0
  br i1 %540, label %541, label %741

541:                                              ; preds = %539
  br i1 %243, label %701, label %542

542:                                              ; preds = %541
  %543 = getelementptr i8, ptr %52, i64 24
  %544 = load i64, ptr %543, align 8, !noalias !64
  %545 = getelementptr i8, ptr %52, i64 32
  %546 = load i64, ptr %545, align 8, !noalias !64
  %547 = load i64, ptr %241, align 8, !noalias !64
  %548 = load i64, ptr %26, align 8, !noalias !64
  %549 = add nsw i64 %548, 1
  %550 = call i64 @llvm.smax.i64(i64 %547, i64 0)
  br label %551

551:                                              ; preds = %542, %632
  %552 = phi i64 [ 0, %542 ], [ %634, %632 ]
  %553 = phi i64 [ %550, %542 ], [ %633, %632 ]
  %554 = icmp sgt i64 %553, 0
  br i1 %554, label %632, label %654

555:                                              ; preds = %664, %668
  %556 = phi i64 [ 0, %664 ], [ %670, %668 ]
  %557 = phi i64 [ %667, %664 ], [ %669, %668 ]
  %558 = phi double [ 0.000000e+00, %664 ], [ %700, %668 ]
  %559 = phi double [ 0.000000e+00, %664 ], [ %698, %668 ]
  %560 = icmp sgt i64 %557, 0
  br i1 %560, label %668, label %561

561:                                              ; preds = %555
  %562 = load i64, ptr %150, align 8, !noalias !64
  %563 = add nsw i64 %562, -3
  %564 = sub i64 %563, %544
  %565 = add nuw i64 %564, 3
  %566 = lshr i64 %565, 2
  %567 = icmp sgt i64 %564, 0
  %568 = select i1 %567, i64 %566, i64 0
  br label %569

569:                                              ; preds = %561, %593
  %570 = phi i64 [ %544, %561 ], [ %595, %593 ]
  %571 = phi i64 [ %568, %561 ], [ %594, %593 ]
  %572 = phi double [ 0.000000e+00, %561 ], [ %599, %593 ]
  %573 = phi double [ 0.000000e+00, %561 ], [ %603, %593 ]
  %574 = phi double [ 0.000000e+00, %561 ], [ %607, %593 ]
  %575 = phi double [ 0.000000e+00, %561 ], [ %611, %593 ]
  %576 = icmp sgt i64 %571, 0
  br i1 %576, label %593, label %577

577:                                              ; preds = %569
  %578 = sub nsw i64 %562, %544
  %579 = and i64 %578, 3
  %580 = sub nsw i64 %562, %579
  br label %581

581:                                              ; preds = %577, %612
  %582 = phi i64 [ %580, %577 ], [ %614, %612 ]
  %583 = phi i64 [ %579, %577 ], [ %613, %612 ]
  %584 = phi double [ %572, %577 ], [ %618, %612 ]
  %585 = icmp sgt i64 %583, 0
  br i1 %585, label %612, label %586

586:                                              ; preds = %581
  %587 = fadd double %584, %573
  %588 = fadd double %574, %575
  %589 = fadd double %587, %588
  %590 = fadd double %559, %589
  %591 = freeze double %590
  %592 = icmp eq i64 %547, 2
  br i1 %592, label %619, label %628

593:                                              ; preds = %569
  %594 = add nsw i64 %571, -1
  %595 = add i64 %570, 4
  %596 = getelementptr double, ptr %92, i64 %570
  %597 = load double, ptr %596, align 8, !noalias !68
  %598 = fmul double %597, 0.000000e+00
  %599 = fadd double %572, %598
  %600 = getelementptr i8, ptr %596, i64 8
  %601 = load double, ptr %600, align 8, !noalias !68
  %602 = fmul double %601, 0.000000e+00
  %603 = fadd double %573, %602
  %604 = getelementptr i8, ptr %596, i64 16
  %605 = load double, ptr %604, align 8, !noalias !68
  %606 = fmul double %605, 0.000000e+00
  %607 = fadd double %574, %606
  %608 = getelementptr i8, ptr %596, i64 24
  %609 = load double, ptr %608, align 8, !noalias !68
  %610 = fmul double %609, 0.000000e+00
  %611 = fadd double %575, %610
  br label %569

612:                                              ; preds = %581
  %613 = add nsw i64 %583, -1
  %614 = add i64 %582, 1
  %615 = getelementptr double, ptr %92, i64 %582
  %616 = load double, ptr %615, align 8, !noalias !68
  %617 = fmul double %616, 0.000000e+00
  %618 = fadd double %584, %617
  br label %581

619:                                              ; preds = %586
  %620 = fmul double %558, 1.000000e-02
  %621 = fadd double %591, %620
  %622 = sitofp i64 %544 to double
  %623 = fmul double %621, %622
  %624 = call double @llvm.sqrt.f64(double %623)
  %625 = fcmp oeq double %591, 0.000000e+00
  %626 = fdiv double %591, %624
  %627 = select i1 %625, double 0.000000e+00, double %626
  br label %708

628:                                              ; preds = %586
  %629 = sitofp i64 %544 to double
  %630 = fdiv double %591, %629
  %631 = call double @llvm.sqrt.f64(double %630)
  br label %708

632:                                              ; preds = %551
  %633 = add nsw i64 %553, -1
  %634 = add i64 %552, 1
  %635 = mul nsw i64 %552, %86
  %636 = shl i64 %635, 3
  %637 = add i64 %636, %111
  %638 = add nsw i64 %549, %552
  %639 = icmp slt i64 %638, 0
  %640 = select i1 %639, i64 %30, i64 0
  %641 = getelementptr i64, ptr %31, i64 %638
  %642 = getelementptr i64, ptr %641, i64 %640
  %643 = load i64, ptr %642, align 8, !noalias !72
  %644 = shl i64 %643, 3
  %645 = add i64 %644, %33
  %646 = add i64 %644, %38
  %647 = icmp slt i64 %638, -1
  %648 = select i1 %647, i64 %30, i64 0
  %649 = getelementptr i8, ptr %641, i64 8
  %650 = getelementptr i64, ptr %649, i64 %648
  %651 = load i64, ptr %650, align 8, !noalias !72
  %652 = xor i64 %643, -1
  %653 = add i64 %651, %652
  call fastcc void @pydy_combine(i64 %637, i64 %109, i64 %99, i64 %116, i64 %645, i64 %646, i64 %653, i64 1, i64 %546) #2, !noalias !72
  br label %551

654:                                              ; preds = %551
  %655 = icmp slt i64 %86, 0
  %656 = select i1 %655, i64 %113, i64 0
  %657 = add i64 %86, %656
  %658 = icmp slt i64 %657, 0
  br i1 %658, label %659, label %660, !prof !4

659:                                              ; preds = %654
  br label %660

660:                                              ; preds = %659, %654
  %661 = phi i64 [ 0, %659 ], [ %657, %654 ]
  %662 = icmp slt i64 %657, %113
  br i1 %662, label %664, label %663, !prof !8

663:                                              ; preds = %660
  br label %664

664:                                              ; preds = %663, %660
  %665 = phi i64 [ %113, %663 ], [ %661, %660 ]
  %666 = getelementptr double, ptr %114, i64 %665
  %667 = call i64 @llvm.smax.i64(i64 %544, i64 0)
  br label %555

668:                                              ; preds = %555
  %669 = add nsw i64 %557, -1
  %670 = add i64 %556, 1
  %671 = getelementptr double, ptr %87, i64 %556
  %672 = load double, ptr %671, align 8, !noalias !64
  %673 = getelementptr double, ptr %92, i64 %556
  %674 = load double, ptr %673, align 8, !noalias !64
  %675 = icmp slt i64 %556, 0
  %676 = select i1 %675, i64 %133, i64 0
  %677 = getelementptr double, ptr %134, i64 %556
  %678 = getelementptr double, ptr %677, i64 %676
  %679 = load double, ptr %678, align 8, !noalias !75
  %680 = select i1 %675, i64 %128, i64 0
  %681 = getelementptr double, ptr %129, i64 %556
  %682 = getelementptr double, ptr %681, i64 %680
  %683 = load double, ptr %682, align 8, !noalias !75
  %684 = call double @llvm.fabs.f64(double %672)
  %685 = call double @llvm.fabs.f64(double %674)
  %686 = fcmp ogt double %684, %685
  %687 = select i1 %686, double %684, double %685
  %688 = fmul double %683, %687
  %689 = fadd double %679, %688
  %690 = fdiv double 1.000000e+00, %689
  %691 = getelementptr double, ptr %114, i64 %556
  %692 = load double, ptr %691, align 8, !noalias !64
  %693 = fmul double %692, %690
  %694 = getelementptr double, ptr %666, i64 %556
  %695 = load double, ptr %694, align 8, !noalias !64
  %696 = fmul double %695, %690
  %697 = fmul double %693, %693
  %698 = fadd double %559, %697
  %699 = fmul double %696, %696
  %700 = fadd double %558, %699
  br label %555

701:                                              ; preds = %541
  %702 = call i64 @llvm.smax.i64(i64 %86, i64 0)
  br label %703

703:                                              ; preds = %701, %1353
  %704 = phi i64 [ 0, %701 ], [ %1355, %1353 ]
  %705 = phi i64 [ %702, %701 ], [ %1354, %1353 ]
  %706 = phi double [ 0.000000e+00, %701 ], [ %1362, %1353 ]
  %707 = icmp sgt i64 %705, 0
  br i1 %707, label %1353, label %708

708:                                              ; preds = %703, %628, %619
  %709 = phi double [ %706, %703 ], [ %631, %628 ], [ %627, %619 ]
  %710 = fcmp olt double %709, 1.000000e+00
  br i1 %710, label %711, label %741

711:                                              ; preds = %708
  br i1 %240, label %716, label %712

712:                                              ; preds = %711
  %713 = getelementptr i8, ptr %26, i64 32
  %714 = load i64, ptr %713, align 8, !noalias !15
  %715 = icmp eq i64 %714, 0
  br i1 %715, label %722, label %741

716:                                              ; preds = %711
  %717 = getelementptr i8, ptr %191, i64 56
  %718 = load i64, ptr %717, align 8, !noalias !15
  %719 = inttoptr i64 %718 to ptr
  %720 = call i64 %719(i64 %0, double %486, i64 %89) #2, !noalias !15
  %721 = icmp eq i64 %720, 0
  br i1 %721, label %722, label %741

722:                                              ; preds = %712, %716
  %723 = getelementptr i8, ptr %144, i64 24
  %724 = load i64, ptr %723, align 8, !noalias !15
  %725 = add nsw i64 %724, 1
  store i64 %725, ptr %723, align 8, !noalias !15
  store ptr null, ptr %6, align 8, !noalias !78
  store ptr null, ptr %7, align 8, !noalias !78
  store double %486, ptr %55, align 8, !noalias !78
  %726 = icmp sgt i64 %67, 0
  br i1 %726, label %727, label %730

727:                                              ; preds = %722
  store ptr null, ptr %6, align 8, !noalias !78
  %728 = call fastcc i32 @_sample(ptr nonnull %6, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %486) #2
  switch i32 %728, label %729 [
    i32 -2, label %730
    i32 0, label %730
  ], !prof !35

729:                                              ; preds = %727
  br label %730

730:                                              ; preds = %727, %727, %722, %729
  %731 = phi i32 [ %728, %729 ], [ 0, %722 ], [ 0, %727 ], [ 0, %727 ]
  switch i32 %731, label %737 [
    i32 -2, label %732
    i32 0, label %732
  ], !prof !35

732:                                              ; preds = %730, %730
  %733 = load i64, ptr %52, align 8, !noalias !85
  %734 = inttoptr i64 %733 to ptr
  %735 = inttoptr i64 %246 to ptr
  %736 = call i32 %734(ptr nonnull %55, ptr %92, ptr %60, ptr %63, ptr %735) #2, !noalias !85
  br label %737

737:                                              ; preds = %730, %732
  %738 = phi i32 [ %736, %732 ], [ 0, %730 ]
  %739 = phi i32 [ 0, %732 ], [ %731, %730 ]
  switch i32 %739, label %1366 [
    i32 -2, label %1363
    i32 0, label %1363
  ], !prof !35

740:                                              ; preds = %1363
  br label %1466

741:                                              ; preds = %1363, %716, %712, %708, %539
  %742 = phi i1 [ true, %539 ], [ false, %708 ], [ true, %712 ], [ true, %716 ], [ true, %1363 ]
  %743 = phi i64 [ %536, %539 ], [ 0, %708 ], [ 0, %712 ], [ 0, %716 ], [ %1364, %1363 ]
  %744 = phi double [ 0.000000e+00, %539 ], [ %709, %708 ], [ %709, %712 ], [ %709, %716 ], [ %709, %1363 ]
  %745 = phi i1 [ true, %539 ], [ true, %708 ], [ true, %712 ], [ false, %716 ], [ true, %1363 ]
  %746 = icmp eq i64 %743, 0
  %747 = and i1 %746, %742
  %748 = and i1 %747, %745
  br i1 %748, label %749, label %1209

749:                                              ; preds = %741
  %750 = load i64, ptr %449, align 8, !noalias !15
  %751 = add nsw i64 %750, 1
  store i64 %751, ptr %449, align 8, !noalias !15
  store double %486, ptr %139, align 8, !noalias !15
  %752 = getelementptr i8, ptr %139, i64 32
  store double %485, ptr %752, align 8, !noalias !15
  %753 = load i64, ptr %439, align 8, !noalias !86
  %754 = icmp eq i64 %753, 0
  br i1 %754, label %1367, label %755

755:                                              ; preds = %749
  %756 = load i64, ptr %230, align 8, !noalias !86
  %757 = load i64, ptr %150, align 8, !noalias !86
  %758 = icmp slt i64 %756, 0
  %759 = select i1 %758, i64 %234, i64 0
  %760 = add i64 %756, %759
  %761 = mul i64 %760, %236
  %762 = getelementptr double, ptr %237, i64 %761
  store double %434, ptr %762, align 8, !noalias !86
  %763 = getelementptr i8, ptr %762, i64 8
  store double %485, ptr %763, align 8, !noalias !86
  %764 = add nsw i64 %756, 1
  %765 = icmp slt i64 %756, -1
  %766 = select i1 %765, i64 %234, i64 0
  %767 = add i64 %764, %766
  %768 = mul i64 %767, %236
  %769 = getelementptr double, ptr %237, i64 %768
  store double %486, ptr %769, align 8, !noalias !86
  %770 = getelementptr i8, ptr %769, i64 8
  store double 0.000000e+00, ptr %770, align 8, !noalias !86
  %771 = call i64 @llvm.smax.i64(i64 %757, i64 0)
  br label %772

772:                                              ; preds = %777, %755
  %773 = phi i64 [ 0, %755 ], [ %779, %777 ]
  %774 = phi i64 [ %771, %755 ], [ %778, %777 ]
  %775 = icmp sgt i64 %774, 0
  br i1 %775, label %777, label %776

776:                                              ; preds = %772
  store i64 %764, ptr %230, align 8, !noalias !86
  br label %1367

777:                                              ; preds = %772
  %778 = add nsw i64 %774, -1
  %779 = add i64 %773, 1
  %780 = icmp slt i64 %773, 0
  %781 = select i1 %780, i64 %86, i64 0
  %782 = getelementptr double, ptr %87, i64 %773
  %783 = getelementptr double, ptr %782, i64 %781
  %784 = load double, ptr %783, align 8, !noalias !86
  %785 = select i1 %780, i64 %91, i64 0
  %786 = getelementptr double, ptr %92, i64 %773
  %787 = getelementptr double, ptr %786, i64 %785
  %788 = load double, ptr %787, align 8, !noalias !86
  %789 = icmp slt i64 %773, -2
  %790 = select i1 %789, i64 %236, i64 0
  %791 = getelementptr double, ptr %762, i64 %773
  %792 = getelementptr i8, ptr %791, i64 16
  %793 = getelementptr double, ptr %792, i64 %790
  store double %784, ptr %793, align 8, !noalias !86
  %794 = getelementptr double, ptr %769, i64 %773
  %795 = getelementptr i8, ptr %794, i64 16
  %796 = getelementptr double, ptr %795, i64 %790
  store double %788, ptr %796, align 8, !noalias !86
  br label %772

797:                                              ; preds = %1367
  %798 = getelementptr i8, ptr %144, i64 48
  %799 = load i64, ptr %798, align 8, !noalias !15
  %800 = icmp slt i64 %799, 0
  %801 = select i1 %800, i64 %148, i64 0
  %802 = getelementptr double, ptr %149, i64 %799
  %803 = getelementptr double, ptr %802, i64 %801
  %804 = load double, ptr %803, align 8, !noalias !15
  %805 = fcmp ult double %804, %486
  br i1 %805, label %808, label %806

806:                                              ; preds = %797
  store i8 0, ptr %22, align 1, !noalias !15
  %807 = call fastcc i32 @write_reached(ptr nonnull %22, ptr %52, ptr %92, i64 %91, ptr nonnull %139, ptr nonnull %144, i64 %148, ptr %149, i64 %148, ptr %153, i64 %152) #2
  switch i32 %807, label %1371 [
    i32 -2, label %1090
    i32 0, label %1090
  ], !prof !35

808:                                              ; preds = %1367, %797
  %809 = load i64, ptr %26, align 8, !noalias !15
  %810 = getelementptr i8, ptr %26, i64 16
  %811 = load i64, ptr %810, align 8, !noalias !15
  %812 = call i64 @llvm.smax.i64(i64 %811, i64 0)
  br label %813

813:                                              ; preds = %1419, %808
  %814 = phi i64 [ %809, %808 ], [ %816, %1419 ]
  %815 = phi i64 [ %812, %808 ], [ %1420, %1419 ]
  %816 = add i64 %814, 1
  %817 = icmp sgt i64 %815, 0
  br i1 %817, label %1372, label %822

818:                                              ; preds = %1419
  %819 = getelementptr i8, ptr %144, i64 72
  store i64 3, ptr %819, align 8, !noalias !15
  store double %434, ptr %139, align 8, !noalias !15
  %820 = icmp slt i32 %1417, 0
  %821 = select i1 %820, i64 -4, i64 2
  br label %1466

822:                                              ; preds = %813
  %823 = load i64, ptr %150, align 8, !noalias !89
  %824 = load i64, ptr %26, align 8, !noalias !89
  %825 = mul nsw i64 %824, %86
  %826 = icmp slt i64 %825, 0
  %827 = select i1 %826, i64 %118, i64 0
  %828 = add i64 %825, %827
  %829 = icmp slt i64 %828, 0
  br i1 %829, label %848, label %849, !prof !4

830:                                              ; preds = %876, %880
  %831 = phi i64 [ 0, %876 ], [ %882, %880 ]
  %832 = phi i64 [ %879, %876 ], [ %881, %880 ]
  %833 = icmp sgt i64 %832, 0
  br i1 %833, label %880, label %834

834:                                              ; preds = %830
  %835 = add nsw i64 %824, 1
  %836 = load i64, ptr %241, align 8, !noalias !89
  %837 = add nsw i64 %835, %836
  %838 = load i64, ptr %810, align 8, !noalias !89
  %839 = add nsw i64 %837, %838
  %840 = getelementptr i8, ptr %26, i64 24
  %841 = load i64, ptr %840, align 8, !noalias !89
  %842 = add i64 %841, -3
  %843 = call i64 @llvm.smax.i64(i64 %842, i64 0)
  br label %844

844:                                              ; preds = %834, %900
  %845 = phi i64 [ 3, %834 ], [ %902, %900 ]
  %846 = phi i64 [ %843, %834 ], [ %901, %900 ]
  %847 = icmp sgt i64 %846, 0
  br i1 %847, label %900, label %1423

848:                                              ; preds = %822
  br label %849

849:                                              ; preds = %848, %822
  %850 = phi i64 [ 0, %848 ], [ %828, %822 ]
  %851 = icmp slt i64 %828, %118
  br i1 %851, label %853, label %852, !prof !8

852:                                              ; preds = %849
  br label %853

853:                                              ; preds = %852, %849
  %854 = phi i64 [ %118, %852 ], [ %850, %849 ]
  %855 = getelementptr double, ptr %119, i64 %854
  %856 = icmp slt i64 %86, 0
  %857 = select i1 %856, i64 %123, i64 0
  %858 = add i64 %86, %857
  %859 = icmp slt i64 %858, 0
  br i1 %859, label %860, label %861, !prof !4

860:                                              ; preds = %853
  br label %861

861:                                              ; preds = %860, %853
  %862 = phi i64 [ 0, %860 ], [ %858, %853 ]
  %863 = icmp slt i64 %858, %123
  br i1 %863, label %865, label %864, !prof !8

864:                                              ; preds = %861
  br label %865

865:                                              ; preds = %864, %861
  %866 = phi i64 [ %123, %864 ], [ %862, %861 ]
  %867 = getelementptr double, ptr %124, i64 %866
  %868 = shl nsw i64 %86, 1
  %869 = add i64 %868, %857
  %870 = icmp slt i64 %869, 0
  br i1 %870, label %871, label %872, !prof !4

871:                                              ; preds = %865
  br label %872

872:                                              ; preds = %871, %865
  %873 = phi i64 [ 0, %871 ], [ %869, %865 ]
  %874 = icmp slt i64 %869, %123
  br i1 %874, label %876, label %875, !prof !8

875:                                              ; preds = %872
  br label %876

876:                                              ; preds = %875, %872
  %877 = phi i64 [ %123, %875 ], [ %873, %872 ]
  %878 = getelementptr double, ptr %124, i64 %877
  %879 = call i64 @llvm.smax.i64(i64 %823, i64 0)
  br label %830

880:                                              ; preds = %830
  %881 = add nsw i64 %832, -1
  %882 = add i64 %831, 1
  %883 = getelementptr double, ptr %92, i64 %831
  %884 = load double, ptr %883, align 8, !noalias !89
  %885 = getelementptr double, ptr %87, i64 %831
  %886 = load double, ptr %885, align 8, !noalias !89
  %887 = fsub double %884, %886
  %888 = getelementptr double, ptr %119, i64 %831
  %889 = load double, ptr %888, align 8, !noalias !89
  %890 = fmul double %485, %889
  %891 = fsub double %890, %887
  %892 = getelementptr double, ptr %124, i64 %831
  store double %887, ptr %892, align 8, !noalias !89
  %893 = getelementptr double, ptr %867, i64 %831
  store double %891, ptr %893, align 8, !noalias !89
  %894 = fsub double %887, %891
  %895 = getelementptr double, ptr %855, i64 %831
  %896 = load double, ptr %895, align 8, !noalias !89
  %897 = fmul double %485, %896
  %898 = fsub double %894, %897
  %899 = getelementptr double, ptr %878, i64 %831
  store double %898, ptr %899, align 8, !noalias !89
  br label %830

900:                                              ; preds = %844
  %901 = add nsw i64 %846, -1
  %902 = add i64 %845, 1
  %903 = mul nsw i64 %845, %86
  %904 = shl i64 %903, 3
  %905 = add i64 %904, %121
  %906 = add nsw i64 %839, %845
  %907 = getelementptr i8, ptr %52, i64 16
  %908 = load i64, ptr %907, align 8, !noalias !93
  %909 = icmp slt i64 %906, 3
  %910 = select i1 %909, i64 %30, i64 0
  %911 = getelementptr i64, ptr %31, i64 %906
  %912 = getelementptr i8, ptr %911, i64 -24
  %913 = getelementptr i64, ptr %912, i64 %910
  %914 = load i64, ptr %913, align 8, !noalias !97
  %915 = shl i64 %914, 3
  %916 = add i64 %915, %33
  %917 = add i64 %915, %38
  %918 = icmp slt i64 %906, 2
  %919 = select i1 %918, i64 %30, i64 0
  %920 = getelementptr i8, ptr %911, i64 -16
  %921 = getelementptr i64, ptr %920, i64 %919
  %922 = load i64, ptr %921, align 8, !noalias !97
  %923 = xor i64 %914, -1
  %924 = add i64 %922, %923
  call fastcc void @pydy_combine(i64 %905, i64 %109, i64 %99, i64 %116, i64 %916, i64 %917, i64 %924, i64 1, i64 %908) #2, !noalias !97
  br label %844

925:                                              ; preds = %1423
  %926 = getelementptr i8, ptr %194, i64 16
  %927 = load i64, ptr %926, align 8, !noalias !15
  %928 = inttoptr i64 %927 to ptr
  %929 = call i64 %928(i64 %0, double %434, double %485) #2, !noalias !15
  %930 = getelementptr i8, ptr %139, i64 48
  %931 = load double, ptr %930, align 8, !noalias !15
  br label %932

932:                                              ; preds = %925, %1423
  %933 = phi double [ %931, %925 ], [ 1.000000e+00, %1423 ]
  %934 = phi i64 [ %929, %925 ], [ 0, %1423 ]
  %935 = fcmp oeq double %933, 1.000000e+00
  br i1 %935, label %936, label %938

936:                                              ; preds = %932
  %937 = load double, ptr %139, align 8, !noalias !15
  br label %941

938:                                              ; preds = %932
  %939 = fmul double %933, %485
  %940 = fadd double %434, %939
  br label %941

941:                                              ; preds = %938, %936
  %942 = phi double [ %937, %936 ], [ %940, %938 ]
  %943 = icmp eq i64 %934, -4
  %944 = select i1 %943, i64 -4, i64 0
  br i1 %943, label %998, label %945

945:                                              ; preds = %941
  %946 = fcmp uge double %933, 1.000000e+00
  %947 = load i64, ptr %150, align 8, !noalias !15
  %948 = load i64, ptr %191, align 8, !noalias !15
  %949 = icmp eq i64 %948, 1
  %950 = getelementptr i8, ptr %144, i64 48
  %951 = load i64, ptr %950, align 8, !noalias !15
  %952 = icmp slt i64 %951, %148
  br i1 %952, label %953, label %996

953:                                              ; preds = %945
  %954 = icmp slt i64 %951, 0
  %955 = select i1 %954, i64 %148, i64 0
  %956 = getelementptr double, ptr %149, i64 %951
  %957 = getelementptr double, ptr %956, i64 %955
  %958 = load double, ptr %957, align 8, !noalias !15
  %959 = fcmp uge double %958, %942
  %960 = fcmp une double %958, %942
  %961 = or i1 %960, %946
  %962 = and i1 %959, %961
  br i1 %962, label %996, label %963

963:                                              ; preds = %986, %953
  %964 = phi i64 [ %951, %953 ], [ %984, %986 ]
  %965 = icmp slt i64 %964, 0
  %966 = select i1 %965, i64 %148, i64 0
  %967 = getelementptr double, ptr %149, i64 %964
  %968 = getelementptr double, ptr %967, i64 %966
  %969 = load double, ptr %968, align 8, !noalias !15
  %970 = fsub double %969, %434
  %971 = fdiv double %970, %485
  %972 = mul nsw i64 %964, %947
  %973 = shl i64 %972, 3
  %974 = add i64 %973, %1
  %975 = call i64 @llvm.smax.i64(i64 %106, i64 0)
  br label %1426

976:                                              ; preds = %1430
  %977 = getelementptr i8, ptr %191, i64 56
  %978 = load i64, ptr %977, align 8, !noalias !15
  %979 = load double, ptr %968, align 8, !noalias !15
  %980 = inttoptr i64 %978 to ptr
  %981 = call i64 %980(i64 %0, double %979, i64 %974) #2, !noalias !15
  %982 = icmp eq i64 %981, 0
  br i1 %982, label %983, label %998

983:                                              ; preds = %1430, %976
  %984 = add nsw i64 %964, 1
  %985 = icmp slt i64 %984, %148
  br i1 %985, label %986, label %996

986:                                              ; preds = %983
  %987 = icmp slt i64 %964, -1
  %988 = select i1 %987, i64 %148, i64 0
  %989 = getelementptr double, ptr %149, i64 %984
  %990 = getelementptr double, ptr %989, i64 %988
  %991 = load double, ptr %990, align 8, !noalias !15
  %992 = fcmp uge double %991, %942
  %993 = fcmp une double %991, %942
  %994 = or i1 %993, %946
  %995 = and i1 %992, %994
  br i1 %995, label %996, label %963

996:                                              ; preds = %986, %953, %983, %945
  %997 = phi i64 [ %951, %953 ], [ %984, %986 ], [ %984, %983 ], [ %951, %945 ]
  store i64 %997, ptr %950, align 8, !noalias !15
  br label %998

998:                                              ; preds = %976, %996, %941
  %999 = phi i64 [ %944, %941 ], [ 0, %996 ], [ %981, %976 ]
  %1000 = icmp eq i64 %999, 0
  %1001 = icmp ne i64 %934, 0
  %1002 = select i1 %1000, i1 %1001, i1 false
  %1003 = fcmp olt double %933, 1.000000e+00
  %1004 = and i1 %1002, %1003
  br i1 %1004, label %1005, label %1043

1005:                                             ; preds = %998
  %1006 = call i64 @llvm.smax.i64(i64 %106, i64 0)
  br label %1007

1007:                                             ; preds = %1005, %1031
  %1008 = phi i64 [ 0, %1005 ], [ %1033, %1031 ]
  %1009 = phi i64 [ %1006, %1005 ], [ %1032, %1031 ]
  %1010 = icmp sgt i64 %1009, 0
  br i1 %1010, label %1031, label %1011

1011:                                             ; preds = %1007
  %1012 = load i64, ptr %840, align 8, !noalias !100
  %1013 = getelementptr i8, ptr %52, i64 16
  %1014 = load i64, ptr %1013, align 8, !noalias !100
  call fastcc void @pydy_nested(i64 %94, i64 %84, i64 %121, i64 %86, i64 %1012, i64 %104, i64 %1014) #2, !noalias !100
  %1015 = call i64 @llvm.smax.i64(i64 %91, i64 0)
  br label %1016

1016:                                             ; preds = %1020, %1011
  %1017 = phi i64 [ 0, %1011 ], [ %1022, %1020 ]
  %1018 = phi i64 [ %1015, %1011 ], [ %1021, %1020 ]
  %1019 = icmp sgt i64 %1018, 0
  br i1 %1019, label %1020, label %1441

1020:                                             ; preds = %1016
  %1021 = add nsw i64 %1018, -1
  %1022 = add i64 %1017, 1
  %1023 = icmp slt i64 %1017, 0
  %1024 = select i1 %1023, i64 %96, i64 0
  %1025 = getelementptr double, ptr %97, i64 %1017
  %1026 = getelementptr double, ptr %1025, i64 %1024
  %1027 = load double, ptr %1026, align 8, !noalias !104
  %1028 = select i1 %1023, i64 %91, i64 0
  %1029 = getelementptr double, ptr %92, i64 %1017
  %1030 = getelementptr double, ptr %1029, i64 %1028
  store double %1027, ptr %1030, align 8, !noalias !104
  br label %1016

1031:                                             ; preds = %1007
  %1032 = add nsw i64 %1009, -1
  %1033 = add i64 %1008, 1
  %1034 = icmp slt i64 %1008, 0
  %1035 = select i1 %1034, i64 %106, i64 0
  %1036 = getelementptr double, ptr %107, i64 %1008
  %1037 = getelementptr double, ptr %1036, i64 %1035
  store double %933, ptr %1037, align 8, !noalias !100
  br label %1007

1038:                                             ; preds = %1441
  %1039 = getelementptr i8, ptr %191, i64 56
  %1040 = load i64, ptr %1039, align 8, !noalias !15
  %1041 = inttoptr i64 %1040 to ptr
  %1042 = call i64 %1041(i64 %0, double %942, i64 %89) #2, !noalias !15
  br label %1043

1043:                                             ; preds = %1441, %1038, %998
  %1044 = phi i64 [ %1042, %1038 ], [ 0, %1441 ], [ %999, %998 ]
  %1045 = icmp eq i64 %1044, 0
  br i1 %1045, label %1047, label %1046

1046:                                             ; preds = %1043
  store double %434, ptr %139, align 8, !noalias !15
  store double %485, ptr %253, align 8, !noalias !15
  br label %1069

1047:                                             ; preds = %1043
  br i1 %935, label %1048, label %1050

1048:                                             ; preds = %1047
  store i8 0, ptr %23, align 1, !noalias !15
  %1049 = call fastcc i32 @write_reached(ptr nonnull %23, ptr %52, ptr %92, i64 %91, ptr nonnull %139, ptr nonnull %144, i64 %148, ptr %149, i64 %148, ptr %153, i64 %152) #2
  switch i32 %1049, label %1444 [
    i32 -2, label %1050
    i32 0, label %1050
  ], !prof !35

1050:                                             ; preds = %1048, %1048, %1047
  %1051 = icmp eq i64 %934, 0
  br i1 %1051, label %1069, label %1052

1052:                                             ; preds = %1050
  %1053 = call i64 @llvm.smax.i64(i64 %86, i64 0)
  br label %1054

1054:                                             ; preds = %1058, %1052
  %1055 = phi i64 [ 0, %1052 ], [ %1060, %1058 ]
  %1056 = phi i64 [ %1053, %1052 ], [ %1059, %1058 ]
  %1057 = icmp sgt i64 %1056, 0
  br i1 %1057, label %1058, label %1445

1058:                                             ; preds = %1054
  %1059 = add nsw i64 %1056, -1
  %1060 = add i64 %1055, 1
  %1061 = icmp slt i64 %1055, 0
  %1062 = select i1 %1061, i64 %91, i64 0
  %1063 = getelementptr double, ptr %92, i64 %1055
  %1064 = getelementptr double, ptr %1063, i64 %1062
  %1065 = load double, ptr %1064, align 8, !noalias !107
  %1066 = select i1 %1061, i64 %86, i64 0
  %1067 = getelementptr double, ptr %87, i64 %1055
  %1068 = getelementptr double, ptr %1067, i64 %1066
  store double %1065, ptr %1068, align 8, !noalias !107
  br label %1054

1069:                                             ; preds = %1050, %1445, %1046
  %1070 = phi i1 [ false, %1046 ], [ false, %1445 ], [ true, %1050 ]
  %1071 = phi i64 [ %1044, %1046 ], [ %934, %1445 ], [ 0, %1050 ]
  %1072 = icmp ne i64 %1071, 6
  %1073 = select i1 %1072, i1 true, i1 %243
  br i1 %1073, label %1086, label %1074

1074:                                             ; preds = %1069
  %1075 = load i64, ptr %1368, align 8, !noalias !15
  %1076 = icmp eq i64 %1075, 0
  br i1 %1076, label %1077, label %1086

1077:                                             ; preds = %1074
  %1078 = load i64, ptr %449, align 8, !noalias !15
  %1079 = add nsw i64 %1078, -1
  store i64 %1079, ptr %449, align 8, !noalias !15
  %1080 = load i64, ptr %230, align 8, !noalias !15
  %1081 = add nsw i64 %1080, -1
  store i64 %1081, ptr %230, align 8, !noalias !15
  %1082 = load i64, ptr %451, align 8, !noalias !15
  %1083 = add nsw i64 %1082, 1
  store i64 %1083, ptr %451, align 8, !noalias !15
  %1084 = getelementptr i8, ptr %144, i64 72
  store i64 6, ptr %1084, align 8, !noalias !15
  %1085 = getelementptr i8, ptr %139, i64 40
  store double 1.000000e+00, ptr %1085, align 8, !noalias !15
  br label %1274

1086:                                             ; preds = %1069, %1074
  br i1 %1070, label %1090, label %1087

1087:                                             ; preds = %1086
  %1088 = load i64, ptr %230, align 8, !noalias !15
  %1089 = add nsw i64 %1088, 1
  store i64 %1089, ptr %230, align 8, !noalias !15
  br label %1466

1090:                                             ; preds = %806, %806, %1086
  br i1 %243, label %1198, label %1091

1091:                                             ; preds = %1090
  %1092 = getelementptr i8, ptr %139, i64 40
  %1093 = load double, ptr %1092, align 8, !noalias !15
  %1094 = getelementptr i8, ptr %49, i64 24
  %1095 = load double, ptr %1094, align 8, !noalias !110
  %1096 = fcmp ogt double %744, 1.000000e-10
  %1097 = select i1 %1096, double %744, double 1.000000e-10
  %1098 = getelementptr i8, ptr %49, i64 8
  %1099 = load double, ptr %1098, align 8, !noalias !110
  %1100 = fneg double %1099
  %1101 = bitcast double %1097 to i64
  %1102 = add nsw i64 %1101, -4604544271217802189
  %1103 = ashr i64 %1102, 52
  %1104 = and i64 %1102, -4503599627370496
  %1105 = sub i64 %1101, %1104
  %1106 = bitcast i64 %1105 to double
  %1107 = fadd double %1106, -1.000000e+00
  %1108 = fadd double %1106, 1.000000e+00
  %1109 = fdiv double %1107, %1108
  %1110 = fmul double %1109, %1109
  %1111 = call double @llvm.fma.f64(double %1110, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1112 = call double @llvm.fma.f64(double %1111, double %1110, double 0x3FE2776C50EF9BFE)
  %1113 = call double @llvm.fma.f64(double %1112, double %1110, double 0x3FEEC709DC3A03FD)
  %1114 = call double @llvm.fma.f64(double %1113, double %1110, double 0x40071547652B82FE)
  %1115 = fmul double %1114, %1109
  %1116 = trunc nsw i64 %1103 to i32
  %1117 = sitofp i32 %1116 to double
  %1118 = fadd double %1115, %1117
  %1119 = fmul double %1118, %1100
  %1120 = fcmp ogt double %1119, -1.000000e+03
  %1121 = select i1 %1120, double %1119, double -1.000000e+03
  %1122 = fcmp olt double %1121, 1.000000e+03
  %1123 = select i1 %1122, double %1121, double 1.000000e+03
  %1124 = call double @llvm.rint.f64(double %1123)
  %1125 = fsub double %1123, %1124
  %1126 = call double @llvm.fma.f64(double %1125, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1127 = call double @llvm.fma.f64(double %1126, double %1125, double 0x3F55D87FE78A6730)
  %1128 = call double @llvm.fma.f64(double %1127, double %1125, double 0x3F83B2AB6FBA4E77)
  %1129 = call double @llvm.fma.f64(double %1128, double %1125, double 0x3FAC6B08D704A0BF)
  %1130 = call double @llvm.fma.f64(double %1129, double %1125, double 0x3FCEBFBDFF82C58E)
  %1131 = call double @llvm.fma.f64(double %1130, double %1125, double 0x3FE62E42FEFA39EF)
  %1132 = call double @llvm.fma.f64(double %1131, double %1125, double 1.000000e+00)
  %1133 = fptosi double %1124 to i32
  %1134 = zext i32 %1133 to i64
  %1135 = shl i64 %1134, 52
  %1136 = bitcast double %1132 to i64
  %1137 = add i64 %1135, %1136
  %1138 = bitcast i64 %1137 to double
  %1139 = fmul double %1095, %1138
  %1140 = getelementptr i8, ptr %49, i64 16
  %1141 = load double, ptr %1140, align 8, !noalias !110
  %1142 = fcmp une double %1141, 0.000000e+00
  br i1 %1142, label %1143, label %1184

1143:                                             ; preds = %1091
  %1144 = getelementptr i8, ptr %139, i64 24
  %1145 = load i64, ptr %1144, align 8, !noalias !15
  %1146 = add i64 %1145, -4604544271217802189
  %1147 = ashr i64 %1146, 52
  %1148 = and i64 %1146, -4503599627370496
  %1149 = sub i64 %1145, %1148
  %1150 = bitcast i64 %1149 to double
  %1151 = fadd double %1150, -1.000000e+00
  %1152 = fadd double %1150, 1.000000e+00
  %1153 = fdiv double %1151, %1152
  %1154 = fmul double %1153, %1153
  %1155 = call double @llvm.fma.f64(double %1154, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1156 = call double @llvm.fma.f64(double %1155, double %1154, double 0x3FE2776C50EF9BFE)
  %1157 = call double @llvm.fma.f64(double %1156, double %1154, double 0x3FEEC709DC3A03FD)
  %1158 = call double @llvm.fma.f64(double %1157, double %1154, double 0x40071547652B82FE)
  %1159 = fmul double %1158, %1153
  %1160 = trunc nsw i64 %1147 to i32
  %1161 = sitofp i32 %1160 to double
  %1162 = fadd double %1159, %1161
  %1163 = fmul double %1162, %1141
  %1164 = fcmp ogt double %1163, -1.000000e+03
  %1165 = select i1 %1164, double %1163, double -1.000000e+03
  %1166 = fcmp olt double %1165, 1.000000e+03
  %1167 = select i1 %1166, double %1165, double 1.000000e+03
  %1168 = call double @llvm.rint.f64(double %1167)
  %1169 = fsub double %1167, %1168
  %1170 = call double @llvm.fma.f64(double %1169, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1171 = call double @llvm.fma.f64(double %1170, double %1169, double 0x3F55D87FE78A6730)
  %1172 = call double @llvm.fma.f64(double %1171, double %1169, double 0x3F83B2AB6FBA4E77)
  %1173 = call double @llvm.fma.f64(double %1172, double %1169, double 0x3FAC6B08D704A0BF)
  %1174 = call double @llvm.fma.f64(double %1173, double %1169, double 0x3FCEBFBDFF82C58E)
  %1175 = call double @llvm.fma.f64(double %1174, double %1169, double 0x3FE62E42FEFA39EF)
  %1176 = call double @llvm.fma.f64(double %1175, double %1169, double 1.000000e+00)
  %1177 = fptosi double %1168 to i32
  %1178 = zext i32 %1177 to i64
  %1179 = shl i64 %1178, 52
  %1180 = bitcast double %1176 to i64
  %1181 = add i64 %1179, %1180
  %1182 = bitcast i64 %1181 to double
  %1183 = fmul double %1139, %1182
  br label %1184

1184:                                             ; preds = %1143, %1091
  %1185 = phi double [ %1183, %1143 ], [ %1139, %1091 ]
  %1186 = getelementptr i8, ptr %49, i64 32
  %1187 = load double, ptr %1186, align 8, !noalias !110
  %1188 = fcmp ogt double %1185, %1187
  %1189 = select i1 %1188, double %1185, double %1187
  %1190 = fcmp olt double %1093, %1189
  %1191 = select i1 %1190, double %1093, double %1189
  %1192 = fmul double %485, %1191
  %1193 = fcmp ogt double %744, 1.000000e-04
  %1194 = select i1 %1193, double %744, double 1.000000e-04
  %1195 = getelementptr i8, ptr %139, i64 24
  store double %1194, ptr %1195, align 8, !noalias !15
  %1196 = getelementptr i8, ptr %49, i64 40
  %1197 = load double, ptr %1196, align 8, !noalias !15
  store double %1197, ptr %1092, align 8, !noalias !15
  br label %1198

1198:                                             ; preds = %1184, %1090
  %1199 = phi double [ %1192, %1184 ], [ %433, %1090 ]
  %1200 = call i64 @llvm.smax.i64(i64 %86, i64 0)
  br label %1201

1201:                                             ; preds = %1198, %1446
  %1202 = phi i64 [ 0, %1198 ], [ %1448, %1446 ]
  %1203 = phi i64 [ %1200, %1198 ], [ %1447, %1446 ]
  %1204 = icmp sgt i64 %1203, 0
  br i1 %1204, label %1446, label %1205

1205:                                             ; preds = %1201
  %1206 = getelementptr i8, ptr %144, i64 48
  %1207 = load i64, ptr %1206, align 8, !noalias !15
  %1208 = icmp eq i64 %1207, %148
  br i1 %1208, label %1279, label %432

1209:                                             ; preds = %741
  %1210 = load i64, ptr %451, align 8, !noalias !15
  %1211 = add nsw i64 %1210, 1
  store i64 %1211, ptr %451, align 8, !noalias !15
  %1212 = and i1 %745, %746
  br i1 %1212, label %1213, label %1216

1213:                                             ; preds = %1209
  %1214 = fsub double %744, %744
  %1215 = fcmp ord double %1214, 0.000000e+00
  br label %1216

1216:                                             ; preds = %1209, %1213
  %1217 = phi i1 [ %1215, %1213 ], [ false, %1209 ]
  %1218 = select i1 %1217, i64 2, i64 4
  %1219 = select i1 %745, i64 %1218, i64 6
  %1220 = select i1 %746, i64 %1219, i64 3
  %1221 = getelementptr i8, ptr %144, i64 72
  store i64 %1220, ptr %1221, align 8, !noalias !15
  br i1 %243, label %1277, label %1222

1222:                                             ; preds = %1216
  %1223 = getelementptr i8, ptr %49, i64 24
  %1224 = load double, ptr %1223, align 8, !noalias !113
  %1225 = fcmp ogt double %744, 1.000000e-10
  %1226 = select i1 %1225, double %744, double 1.000000e-10
  %1227 = bitcast double %1226 to i64
  %1228 = add nsw i64 %1227, -4604544271217802189
  %1229 = and i64 %1228, -4503599627370496
  %1230 = sub i64 %1227, %1229
  %1231 = bitcast i64 %1230 to double
  %1232 = fadd double %1231, -1.000000e+00
  %1233 = fadd double %1231, 1.000000e+00
  %1234 = fdiv double %1232, %1233
  %1235 = fmul double %1234, %1234
  %1236 = call double @llvm.fma.f64(double %1235, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1237 = call double @llvm.fma.f64(double %1236, double %1235, double 0x3FE2776C50EF9BFE)
  %1238 = call double @llvm.fma.f64(double %1237, double %1235, double 0x3FEEC709DC3A03FD)
  %1239 = call double @llvm.fma.f64(double %1238, double %1235, double 0x40071547652B82FE)
  %1240 = fmul double %1239, %1234
  %1241 = ashr i64 %1228, 52
  %1242 = trunc nsw i64 %1241 to i32
  %1243 = sitofp i32 %1242 to double
  %1244 = fadd double %1240, %1243
  %1245 = load double, ptr %49, align 8, !noalias !113
  %1246 = fneg double %1245
  %1247 = fmul double %1244, %1246
  %1248 = fcmp ogt double %1247, -1.000000e+03
  %1249 = select i1 %1248, double %1247, double -1.000000e+03
  %1250 = fcmp olt double %1249, 1.000000e+03
  %1251 = select i1 %1250, double %1249, double 1.000000e+03
  %1252 = call double @llvm.rint.f64(double %1251)
  %1253 = fptosi double %1252 to i32
  %1254 = zext i32 %1253 to i64
  %1255 = shl i64 %1254, 52
  %1256 = fsub double %1251, %1252
  %1257 = call double @llvm.fma.f64(double %1256, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1258 = call double @llvm.fma.f64(double %1257, double %1256, double 0x3F55D87FE78A6730)
  %1259 = call double @llvm.fma.f64(double %1258, double %1256, double 0x3F83B2AB6FBA4E77)
  %1260 = call double @llvm.fma.f64(double %1259, double %1256, double 0x3FAC6B08D704A0BF)
  %1261 = call double @llvm.fma.f64(double %1260, double %1256, double 0x3FCEBFBDFF82C58E)
  %1262 = call double @llvm.fma.f64(double %1261, double %1256, double 0x3FE62E42FEFA39EF)
  %1263 = call double @llvm.fma.f64(double %1262, double %1256, double 1.000000e+00)
  %1264 = bitcast double %1263 to i64
  %1265 = add i64 %1255, %1264
  %1266 = bitcast i64 %1265 to double
  %1267 = fmul double %1224, %1266
  %1268 = getelementptr i8, ptr %49, i64 32
  %1269 = load double, ptr %1268, align 8, !noalias !113
  %1270 = fcmp ogt double %1267, %1269
  %1271 = select i1 %1270, double %1267, double %1269
  %1272 = select i1 %1217, double %1271, double 2.500000e-01
  %1273 = getelementptr i8, ptr %139, i64 40
  store double 1.000000e+00, ptr %1273, align 8, !noalias !15
  br label %1274

1274:                                             ; preds = %1077, %1222
  %1275 = phi double [ %1272, %1222 ], [ 2.500000e-01, %1077 ]
  %1276 = fmul double %485, %1275
  br label %429

1277:                                             ; preds = %1216
  store double %485, ptr %253, align 8, !noalias !15
  br label %1466

1278:                                             ; preds = %477
  store double %485, ptr %253, align 8, !noalias !15
  br label %1466

1279:                                             ; preds = %1205
  store double %1199, ptr %253, align 8, !noalias !15
  br label %1466

1280:                                             ; preds = %271, %271
  %1281 = icmp eq i32 %272, 0
  br i1 %1281, label %278, label %274

1282:                                             ; preds = %271
  br label %1466

1283:                                             ; preds = %278, %278
  %1284 = load i8, ptr %19, align 1, !noalias !15
  %1285 = icmp eq i8 %1284, 0
  br i1 %1285, label %285, label %284

1286:                                             ; preds = %278
  br label %1466

1287:                                             ; preds = %287, %295
  br label %1466

1288:                                             ; preds = %308
  %1289 = add nsw i64 %310, -1
  %1290 = add i64 %309, 1
  %1291 = icmp slt i64 %309, 0
  %1292 = select i1 %1291, i64 %86, i64 0
  %1293 = getelementptr double, ptr %87, i64 %309
  %1294 = getelementptr double, ptr %1293, i64 %1292
  %1295 = load double, ptr %1294, align 8, !noalias !15
  %1296 = select i1 %1291, i64 %118, i64 0
  %1297 = getelementptr double, ptr %119, i64 %309
  %1298 = getelementptr double, ptr %1297, i64 %1296
  %1299 = load double, ptr %1298, align 8, !noalias !15
  %1300 = fmul double %306, %1299
  %1301 = fadd double %1295, %1300
  %1302 = select i1 %1291, i64 %96, i64 0
  %1303 = getelementptr double, ptr %97, i64 %309
  %1304 = getelementptr double, ptr %1303, i64 %1302
  store double %1301, ptr %1304, align 8, !noalias !15
  br label %308

1305:                                             ; preds = %329, %329
  br i1 %330, label %334, label %332

1306:                                             ; preds = %329
  br label %1466

1307:                                             ; preds = %343
  br label %1466

1308:                                             ; preds = %494
  %1309 = add nsw i64 %496, -1
  %1310 = add i64 %495, 1
  %1311 = icmp slt i64 %495, 0
  %1312 = select i1 %1311, i64 %101, i64 0
  %1313 = getelementptr double, ptr %102, i64 %495
  %1314 = getelementptr double, ptr %1313, i64 %1312
  store double %485, ptr %1314, align 8, !noalias !15
  br label %494

1315:                                             ; preds = %502
  %1316 = add nsw i64 %504, -1
  %1317 = add i64 %503, 1
  store ptr null, ptr %20, align 8, !noalias !15
  %1318 = call fastcc i32 @_combine_latest(ptr nonnull %20, ptr %31, i64 %30, ptr %36, i64 %35, ptr %41, i64 %40, ptr %52, ptr %87, ptr %102, ptr %119, i64 %118, i64 %503, i64 %94, double %485) #2
  switch i32 %1318, label %1347 [
    i32 -2, label %1319
    i32 0, label %1319
  ], !prof !35

1319:                                             ; preds = %1315, %1315
  %1320 = mul nsw i64 %503, %86
  %1321 = shl i64 %1320, 3
  %1322 = add i64 %1321, %116
  %1323 = getelementptr i8, ptr %144, i64 24
  %1324 = load i64, ptr %1323, align 8, !noalias !15
  %1325 = add nsw i64 %1324, 1
  store i64 %1325, ptr %1323, align 8, !noalias !15
  %1326 = icmp slt i64 %503, 0
  %1327 = select i1 %1326, i64 %45, i64 0
  %1328 = getelementptr double, ptr %46, i64 %503
  %1329 = getelementptr double, ptr %1328, i64 %1327
  %1330 = load double, ptr %1329, align 8, !noalias !15
  %1331 = fmul double %1330, %485
  %1332 = fadd double %434, %1331
  store ptr null, ptr %10, align 8, !noalias !116
  store ptr null, ptr %11, align 8, !noalias !116
  store double %1332, ptr %55, align 8, !noalias !116
  %1333 = icmp sgt i64 %67, 0
  br i1 %1333, label %1334, label %1337

1334:                                             ; preds = %1319
  store ptr null, ptr %10, align 8, !noalias !116
  %1335 = call fastcc i32 @_sample(ptr nonnull %10, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %1332) #2
  switch i32 %1335, label %1336 [
    i32 -2, label %1337
    i32 0, label %1337
  ], !prof !35

1336:                                             ; preds = %1334
  br label %1337

1337:                                             ; preds = %1334, %1334, %1319, %1336
  %1338 = phi i32 [ %1335, %1336 ], [ 0, %1319 ], [ 0, %1334 ], [ 0, %1334 ]
  switch i32 %1338, label %1344 [
    i32 -2, label %1339
    i32 0, label %1339
  ], !prof !35

1339:                                             ; preds = %1337, %1337
  %1340 = load i64, ptr %52, align 8, !noalias !123
  %1341 = inttoptr i64 %1340 to ptr
  %1342 = inttoptr i64 %1322 to ptr
  %1343 = call i32 %1341(ptr nonnull %55, ptr %97, ptr %60, ptr %63, ptr %1342) #2, !noalias !123
  br label %1344

1344:                                             ; preds = %1337, %1339
  %1345 = phi i32 [ %1343, %1339 ], [ 0, %1337 ]
  %1346 = phi i32 [ 0, %1339 ], [ %1338, %1337 ]
  switch i32 %1346, label %1350 [
    i32 -2, label %1348
    i32 0, label %1348
  ], !prof !35

1347:                                             ; preds = %1315
  br label %1466

1348:                                             ; preds = %1344, %1344
  %1349 = icmp eq i32 %1345, 0
  br i1 %1349, label %502, label %506

1350:                                             ; preds = %1344
  br label %1466

1351:                                             ; preds = %508
  br label %1466

1352:                                             ; preds = %532
  br label %1466

1353:                                             ; preds = %703
  %1354 = add nsw i64 %705, -1
  %1355 = add i64 %704, 1
  %1356 = icmp slt i64 %704, 0
  %1357 = select i1 %1356, i64 %91, i64 0
  %1358 = getelementptr double, ptr %92, i64 %704
  %1359 = getelementptr double, ptr %1358, i64 %1357
  %1360 = load double, ptr %1359, align 8, !noalias !15
  %1361 = fmul double %1360, 0.000000e+00
  %1362 = fadd double %706, %1361
  br label %703

1363:                                             ; preds = %737, %737
  %1364 = sext i32 %738 to i64
  %1365 = icmp slt i32 %738, 0
  br i1 %1365, label %740, label %741

1366:                                             ; preds = %737
  br label %1466

1367:                                             ; preds = %776, %749
  %1368 = getelementptr i8, ptr %194, i64 8
  %1369 = load i64, ptr %1368, align 8, !noalias !15
  %1370 = icmp eq i64 %1369, 0
  br i1 %1370, label %797, label %808

1371:                                             ; preds = %806
  br label %1466

1372:                                             ; preds = %813
  %1373 = load i64, ptr %241, align 8, !noalias !15
  %1374 = add nsw i64 %816, %1373
  %1375 = getelementptr i8, ptr %52, i64 16
  %1376 = load i64, ptr %1375, align 8, !noalias !124
  %1377 = icmp slt i64 %1374, 0
  %1378 = select i1 %1377, i64 %30, i64 0
  %1379 = getelementptr i64, ptr %31, i64 %1374
  %1380 = getelementptr i64, ptr %1379, i64 %1378
  %1381 = load i64, ptr %1380, align 8, !noalias !128
  %1382 = shl i64 %1381, 3
  %1383 = add i64 %1382, %33
  %1384 = add i64 %1382, %38
  %1385 = icmp slt i64 %1374, -1
  %1386 = select i1 %1385, i64 %30, i64 0
  %1387 = getelementptr i8, ptr %1379, i64 8
  %1388 = getelementptr i64, ptr %1387, i64 %1386
  %1389 = load i64, ptr %1388, align 8, !noalias !128
  %1390 = xor i64 %1381, -1
  %1391 = add i64 %1389, %1390
  call fastcc void @pydy_combine(i64 %94, i64 %84, i64 %99, i64 %116, i64 %1383, i64 %1384, i64 %1391, i64 1, i64 %1376) #2, !noalias !128
  %1392 = mul nsw i64 %816, %86
  %1393 = shl i64 %1392, 3
  %1394 = add i64 %1393, %116
  %1395 = getelementptr i8, ptr %144, i64 24
  %1396 = load i64, ptr %1395, align 8, !noalias !15
  %1397 = add nsw i64 %1396, 1
  store i64 %1397, ptr %1395, align 8, !noalias !15
  %1398 = icmp slt i64 %816, 0
  %1399 = select i1 %1398, i64 %45, i64 0
  %1400 = getelementptr double, ptr %46, i64 %816
  %1401 = getelementptr double, ptr %1400, i64 %1399
  %1402 = load double, ptr %1401, align 8, !noalias !15
  %1403 = fmul double %1402, %485
  %1404 = fadd double %434, %1403
  store ptr null, ptr %4, align 8, !noalias !131
  store ptr null, ptr %5, align 8, !noalias !131
  store double %1404, ptr %55, align 8, !noalias !131
  %1405 = icmp sgt i64 %67, 0
  br i1 %1405, label %1406, label %1409

1406:                                             ; preds = %1372
  store ptr null, ptr %4, align 8, !noalias !131
  %1407 = call fastcc i32 @_sample(ptr nonnull %4, ptr %60, i64 %59, ptr %70, i64 %67, i64 %69, ptr %75, i64 %74, ptr %82, i64 %79, i64 %81, double %1404) #2
  switch i32 %1407, label %1408 [
    i32 -2, label %1409
    i32 0, label %1409
  ], !prof !35

1408:                                             ; preds = %1406
  br label %1409

1409:                                             ; preds = %1406, %1406, %1372, %1408
  %1410 = phi i32 [ %1407, %1408 ], [ 0, %1372 ], [ 0, %1406 ], [ 0, %1406 ]
  switch i32 %1410, label %1416 [
    i32 -2, label %1411
    i32 0, label %1411
  ], !prof !35

1411:                                             ; preds = %1409, %1409
  %1412 = load i64, ptr %52, align 8, !noalias !138
  %1413 = inttoptr i64 %1412 to ptr
  %1414 = inttoptr i64 %1394 to ptr
  %1415 = call i32 %1413(ptr nonnull %55, ptr %97, ptr %60, ptr %63, ptr %1414) #2, !noalias !138
  br label %1416

1416:                                             ; preds = %1409, %1411
  %1417 = phi i32 [ %1415, %1411 ], [ 0, %1409 ]
  %1418 = phi i32 [ 0, %1411 ], [ %1410, %1409 ]
  switch i32 %1418, label %1422 [
    i32 -2, label %1419
    i32 0, label %1419
  ], !prof !35

1419:                                             ; preds = %1416, %1416
  %1420 = add nsw i64 %815, -1
  %1421 = icmp eq i32 %1417, 0
  br i1 %1421, label %813, label %818

1422:                                             ; preds = %1416
  br label %1466

1423:                                             ; preds = %844
  %1424 = load i64, ptr %1368, align 8, !noalias !15
  %1425 = icmp sgt i64 %1424, 0
  br i1 %1425, label %925, label %932

1426:                                             ; preds = %963, %1434
  %1427 = phi i64 [ 0, %963 ], [ %1436, %1434 ]
  %1428 = phi i64 [ %975, %963 ], [ %1435, %1434 ]
  %1429 = icmp sgt i64 %1428, 0
  br i1 %1429, label %1434, label %1430

1430:                                             ; preds = %1426
  %1431 = load i64, ptr %840, align 8, !noalias !139
  %1432 = getelementptr i8, ptr %52, i64 16
  %1433 = load i64, ptr %1432, align 8, !noalias !139
  call fastcc void @pydy_nested(i64 %974, i64 %84, i64 %121, i64 %86, i64 %1431, i64 %104, i64 %1433) #2, !noalias !139
  br i1 %949, label %976, label %983

1434:                                             ; preds = %1426
  %1435 = add nsw i64 %1428, -1
  %1436 = add i64 %1427, 1
  %1437 = icmp slt i64 %1427, 0
  %1438 = select i1 %1437, i64 %106, i64 0
  %1439 = getelementptr double, ptr %107, i64 %1427
  %1440 = getelementptr double, ptr %1439, i64 %1438
  store double %971, ptr %1440, align 8, !noalias !139
  br label %1426

1441:                                             ; preds = %1016
  %1442 = load i64, ptr %191, align 8, !noalias !15
  %1443 = icmp eq i64 %1442, 1
  br i1 %1443, label %1038, label %1043

1444:                                             ; preds = %1048
  br label %1466

1445:                                             ; preds = %1054
  store double %942, ptr %139, align 8, !noalias !15
  store double 0.000000e+00, ptr %253, align 8, !noalias !15
  store i64 0, ptr %144, align 8, !noalias !15
  br label %1069

1446:                                             ; preds = %1201
  %1447 = add nsw i64 %1203, -1
  %1448 = add i64 %1202, 1
  %1449 = icmp slt i64 %1202, 0
  %1450 = select i1 %1449, i64 %91, i64 0
  %1451 = getelementptr double, ptr %92, i64 %1202
  %1452 = getelementptr double, ptr %1451, i64 %1450
  %1453 = load double, ptr %1452, align 8, !noalias !15
  %1454 = select i1 %1449, i64 %86, i64 0
  %1455 = getelementptr double, ptr %87, i64 %1202
  %1456 = getelementptr double, ptr %1455, i64 %1454
  store double %1453, ptr %1456, align 8, !noalias !15
  %1457 = add nsw i64 %244, %1202
  %1458 = icmp slt i64 %1457, 0
  %1459 = select i1 %1458, i64 %118, i64 0
  %1460 = getelementptr double, ptr %119, i64 %1457
  %1461 = getelementptr double, ptr %1460, i64 %1459
  %1462 = load double, ptr %1461, align 8, !noalias !15
  %1463 = select i1 %1449, i64 %118, i64 0
  %1464 = getelementptr double, ptr %119, i64 %1202
  %1465 = getelementptr double, ptr %1464, i64 %1463
  store double %1462, ptr %1465, align 8, !noalias !15
  br label %1201

1466:                                             ; preds = %1444, %1422, %1371, %1366, %1352, %1351, %1350, %1347, %1307, %1306, %1287, %1286, %1282, %1279, %1278, %1277, %1087, %818, %740, %538, %457, %446, %437, %284, %274, %226
  %1467 = phi i64 [ 0, %1422 ], [ -1, %226 ], [ 0, %1282 ], [ %277, %274 ], [ 0, %1286 ], [ 0, %284 ], [ 0, %1287 ], [ 0, %1307 ], [ 0, %1306 ], [ -1, %437 ], [ %821, %818 ], [ -5, %446 ], [ 1, %457 ], [ 2, %1278 ], [ 0, %1351 ], [ 0, %1347 ], [ 0, %1350 ], [ 0, %1352 ], [ -4, %538 ], [ -4, %740 ], [ 2, %1277 ], [ 0, %1444 ], [ 0, %1371 ], [ %1071, %1087 ], [ 0, %1279 ], [ 0, %1366 ]
  ret i64 %1467
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
!53 = !{!54}
!54 = distinct !{!54, !55}
!55 = distinct !{!55}
!56 = !{!57, !59, !60, !62}
!57 = distinct !{!57, !58}
!58 = distinct !{!58}
!59 = distinct !{!59, !58}
!60 = distinct !{!60, !61}
!61 = distinct !{!61}
!62 = distinct !{!62, !61}
!63 = !{!60, !62}
!64 = !{!65, !67, !16, !18}
!65 = distinct !{!65, !66}
!66 = distinct !{!66}
!67 = distinct !{!67, !66}
!68 = !{!69, !71, !65, !67, !16, !18}
!69 = distinct !{!69, !70}
!70 = distinct !{!70}
!71 = distinct !{!71, !70}
!72 = !{!73, !65, !67, !16, !18}
!73 = distinct !{!73, !74}
!74 = distinct !{!74}
!75 = !{!76, !65, !67, !16, !18}
!76 = distinct !{!76, !77}
!77 = distinct !{!77}
!78 = !{!79, !81, !82, !84}
!79 = distinct !{!79, !80}
!80 = distinct !{!80}
!81 = distinct !{!81, !80}
!82 = distinct !{!82, !83}
!83 = distinct !{!83}
!84 = distinct !{!84, !83}
!85 = !{!82, !84}
!86 = !{!87}
!87 = distinct !{!87, !88}
!88 = distinct !{!88}
!89 = !{!90, !92, !16, !18}
!90 = distinct !{!90, !91}
!91 = distinct !{!91}
!92 = distinct !{!92, !91}
!93 = !{!94, !96, !90, !92, !16, !18}
!94 = distinct !{!94, !95}
!95 = distinct !{!95}
!96 = distinct !{!96, !95}
!97 = !{!98, !94, !96, !90, !92, !16, !18}
!98 = distinct !{!98, !99}
!99 = distinct !{!99}
!100 = !{!101, !103, !16, !18}
!101 = distinct !{!101, !102}
!102 = distinct !{!102}
!103 = distinct !{!103, !102}
!104 = !{!105}
!105 = distinct !{!105, !106}
!106 = distinct !{!106}
!107 = !{!108}
!108 = distinct !{!108, !109}
!109 = distinct !{!109}
!110 = !{!111, !16, !18}
!111 = distinct !{!111, !112}
!112 = distinct !{!112}
!113 = !{!114, !16, !18}
!114 = distinct !{!114, !115}
!115 = distinct !{!115}
!116 = !{!117, !119, !120, !122}
!117 = distinct !{!117, !118}
!118 = distinct !{!118}
!119 = distinct !{!119, !118}
!120 = distinct !{!120, !121}
!121 = distinct !{!121}
!122 = distinct !{!122, !121}
!123 = !{!120, !122}
!124 = !{!125, !127, !16, !18}
!125 = distinct !{!125, !126}
!126 = distinct !{!126}
!127 = distinct !{!127, !126}
!128 = !{!129, !125, !127, !16, !18}
!129 = distinct !{!129, !130}
!130 = distinct !{!130}
!131 = !{!132, !134, !135, !137}
!132 = distinct !{!132, !133}
!133 = distinct !{!133}
!134 = distinct !{!134, !133}
!135 = distinct !{!135, !136}
!136 = distinct !{!136}
!137 = distinct !{!137, !136}
!138 = !{!135, !137}
!139 = !{!140, !142, !16, !18}
!140 = distinct !{!140, !141}
!141 = distinct !{!141}
!142 = distinct !{!142, !141}
