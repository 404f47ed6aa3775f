; sources ffa08bbc5d46c93cc14a24ecb9fddd6a34fa7630f9d674afa3d1c05f0890426c
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

declare double @llvm.fabs.f64(double) #0

declare double @sqrt(double) local_unnamed_addr #1

declare double @llvm.pow.f64(double, double) #0

define internal fastcc i32 @_sample(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, i64 %5, ptr %6, i64 %7, ptr %8, i64 %9, i64 %10, double %11) unnamed_addr #2 {
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

define internal fastcc i32 @_norm(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, ptr %5, i64 %6, ptr %7, i64 %8, ptr %9, i64 %10, i64 %11) unnamed_addr #2 {
  %13 = call i64 @llvm.smax.i64(i64 %11, i64 0)
  br label %14

14:                                               ; preds = %12, %23
  %15 = phi i64 [ 0, %12 ], [ %25, %23 ]
  %16 = phi i64 [ %13, %12 ], [ %24, %23 ]
  %17 = phi double [ 0.000000e+00, %12 ], [ %53, %23 ]
  %18 = icmp sgt i64 %16, 0
  br i1 %18, label %23, label %19

19:                                               ; preds = %14
  %20 = sitofp i64 %11 to double
  %21 = fdiv double %17, %20
  %22 = call double @sqrt(double %21)
  store double %22, ptr %0, align 8
  ret i32 0

23:                                               ; preds = %14
  %24 = add nsw i64 %16, -1
  %25 = add i64 %15, 1
  %26 = icmp slt i64 %15, 0
  %27 = select i1 %26, i64 %2, i64 0
  %28 = getelementptr double, ptr %1, i64 %15
  %29 = getelementptr double, ptr %28, i64 %27
  %30 = load double, ptr %29, align 8
  %31 = select i1 %26, i64 %4, i64 0
  %32 = getelementptr double, ptr %3, i64 %15
  %33 = getelementptr double, ptr %32, i64 %31
  %34 = load double, ptr %33, align 8
  %35 = fsub double %30, %34
  %36 = select i1 %26, i64 %10, i64 0
  %37 = getelementptr double, ptr %9, i64 %15
  %38 = getelementptr double, ptr %37, i64 %36
  %39 = load double, ptr %38, align 8
  %40 = select i1 %26, i64 %8, i64 0
  %41 = getelementptr double, ptr %7, i64 %15
  %42 = getelementptr double, ptr %41, i64 %40
  %43 = load double, ptr %42, align 8
  %44 = select i1 %26, i64 %6, i64 0
  %45 = getelementptr double, ptr %5, i64 %15
  %46 = getelementptr double, ptr %45, i64 %44
  %47 = load double, ptr %46, align 8
  %48 = call double @llvm.fabs.f64(double %47)
  %49 = fmul double %43, %48
  %50 = fadd double %39, %49
  %51 = fdiv double %35, %50
  %52 = fmul double %51, %51
  %53 = fadd double %17, %52
  br label %14
}

define internal fastcc i32 @_combine_latest(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, ptr %5, i64 %6, ptr %7, ptr %8, ptr %9, ptr %10, i64 %11, i64 %12, i64 %13, double %14) unnamed_addr {
  %16 = icmp slt i64 %12, 0
  %17 = select i1 %16, i64 %2, i64 0
  %18 = getelementptr i64, ptr %1, i64 %12
  %19 = getelementptr i64, ptr %18, i64 %17
  %20 = load i64, ptr %19, align 8
  %21 = icmp slt i64 %12, -1
  %22 = select i1 %21, i64 %2, i64 0
  %23 = getelementptr i8, ptr %18, i64 8
  %24 = getelementptr i64, ptr %23, i64 %22
  %25 = load i64, ptr %24, align 8
  %26 = add nsw i64 %25, -1
  %27 = sub nsw i64 %26, %20
  %28 = getelementptr i8, ptr %7, i64 16
  %29 = load i64, ptr %28, align 8
  %30 = icmp ne i64 %29, 1
  %31 = ptrtoint ptr %8 to i64
  %32 = ptrtoint ptr %9 to i64
  %33 = ptrtoint ptr %10 to i64
  %34 = ptrtoint ptr %3 to i64
  %35 = shl i64 %20, 3
  %36 = add i64 %35, %34
  %37 = ptrtoint ptr %5 to i64
  %38 = add i64 %35, %37
  %39 = zext i1 %30 to i64
  %40 = add nsw i64 %27, %39
  call fastcc void @pydy_combine(i64 %13, i64 %31, i64 %32, i64 %33, i64 %36, i64 %38, i64 %40, i64 %29)
  br i1 %30, label %59, label %41

41:                                               ; preds = %15
  %42 = icmp sgt i64 %25, 0
  %43 = select i1 %42, i64 0, i64 %6
  %44 = getelementptr double, ptr %5, i64 %26
  %45 = getelementptr double, ptr %44, i64 %43
  %46 = load double, ptr %45, align 8
  %47 = fmul contract double %14, %46
  %48 = select i1 %42, i64 0, i64 %4
  %49 = getelementptr i64, ptr %3, i64 %26
  %50 = getelementptr i64, ptr %49, i64 %48
  %51 = load i64, ptr %50, align 8
  %52 = getelementptr i8, ptr %7, i64 8
  %53 = load i64, ptr %52, align 8
  %54 = call i64 @llvm.smax.i64(i64 %53, i64 0)
  br label %55

55:                                               ; preds = %41, %60
  %56 = phi i64 [ 0, %41 ], [ %62, %60 ]
  %57 = phi i64 [ %54, %41 ], [ %61, %60 ]
  %58 = icmp sgt i64 %57, 0
  br i1 %58, label %60, label %59

59:                                               ; preds = %55, %15
  store ptr null, ptr %0, align 8
  ret i32 0

60:                                               ; preds = %55
  %61 = add nsw i64 %57, -1
  %62 = add i64 %56, 1
  %63 = shl nsw i64 %56, 3
  %64 = add nsw i64 %13, %63
  %65 = inttoptr i64 %64 to ptr
  %66 = load double, ptr %65, align 8
  %67 = add nsw i64 %51, %56
  %68 = icmp slt i64 %67, 0
  %69 = select i1 %68, i64 %11, i64 0
  %70 = getelementptr double, ptr %10, i64 %67
  %71 = getelementptr double, ptr %70, i64 %69
  %72 = load double, ptr %71, align 8
  %73 = fmul contract double %47, %72
  %74 = fadd contract double %66, %73
  store atomic double %74, ptr %65 unordered, align 8
  br label %55
}

define internal fastcc void @pydy_combine(i64 %0, i64 %1, i64 %2, i64 %3, i64 %4, i64 %5, i64 %6, i64 %7) unnamed_addr #2 {
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

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #0

define internal fastcc void @pydy_nested(i64 %0, i64 %1, i64 %2, i64 %3, i64 %4, i64 %5, i64 %6) unnamed_addr #2 {
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

define i64 @advance(i64 %0, i64 %1, i64 %2) local_unnamed_addr #3 {
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
  %16 = alloca i8, align 1
  %17 = alloca double, align 8
  %18 = alloca double, align 8
  %19 = alloca double, align 8
  %20 = alloca ptr, align 8
  %21 = alloca ptr, align 8
  %22 = alloca i8, align 1
  store i8 0, ptr %16, align 1, !noalias !5
  store double 0.000000e+00, ptr %17, align 8, !noalias !5
  store double 0.000000e+00, ptr %18, align 8, !noalias !5
  store double 0.000000e+00, ptr %19, align 8, !noalias !5
  store ptr null, ptr %20, align 8, !noalias !5
  store ptr null, ptr %21, align 8, !noalias !5
  store i8 0, ptr %22, align 1, !noalias !5
  %23 = inttoptr i64 %0 to ptr
  %24 = load i64, ptr %23, align 8, !noalias !9
  %25 = inttoptr i64 %24 to ptr
  %26 = getelementptr i8, ptr %23, i64 24
  %27 = load i64, ptr %26, align 8, !noalias !9
  %28 = getelementptr i8, ptr %23, i64 32
  %29 = load i64, ptr %28, align 8, !noalias !9
  %30 = inttoptr i64 %27 to ptr
  %31 = getelementptr i8, ptr %23, i64 48
  %32 = load i64, ptr %31, align 8, !noalias !9
  %33 = getelementptr i8, ptr %23, i64 56
  %34 = load i64, ptr %33, align 8, !noalias !9
  %35 = inttoptr i64 %32 to ptr
  %36 = getelementptr i8, ptr %23, i64 72
  %37 = load i64, ptr %36, align 8, !noalias !9
  %38 = getelementptr i8, ptr %23, i64 80
  %39 = load i64, ptr %38, align 8, !noalias !9
  %40 = inttoptr i64 %37 to ptr
  %41 = getelementptr i8, ptr %23, i64 96
  %42 = load i64, ptr %41, align 8, !noalias !9
  %43 = getelementptr i8, ptr %23, i64 104
  %44 = load i64, ptr %43, align 8, !noalias !9
  %45 = inttoptr i64 %42 to ptr
  %46 = getelementptr i8, ptr %23, i64 120
  %47 = load i64, ptr %46, align 8, !noalias !9
  %48 = inttoptr i64 %47 to ptr
  %49 = getelementptr i8, ptr %23, i64 144
  %50 = load i64, ptr %49, align 8, !noalias !9
  %51 = inttoptr i64 %50 to ptr
  %52 = getelementptr i8, ptr %23, i64 168
  %53 = load i64, ptr %52, align 8, !noalias !9
  %54 = inttoptr i64 %53 to ptr
  %55 = getelementptr i8, ptr %23, i64 192
  %56 = load i64, ptr %55, align 8, !noalias !9
  %57 = getelementptr i8, ptr %23, i64 200
  %58 = load i64, ptr %57, align 8, !noalias !9
  %59 = inttoptr i64 %56 to ptr
  %60 = getelementptr i8, ptr %23, i64 216
  %61 = load i64, ptr %60, align 8, !noalias !9
  %62 = inttoptr i64 %61 to ptr
  %63 = getelementptr i8, ptr %23, i64 240
  %64 = load i64, ptr %63, align 8, !noalias !9
  %65 = getelementptr i8, ptr %23, i64 248
  %66 = load i64, ptr %65, align 8, !noalias !9
  %67 = getelementptr i8, ptr %23, i64 256
  %68 = load i64, ptr %67, align 8, !noalias !9
  %69 = inttoptr i64 %64 to ptr
  %70 = getelementptr i8, ptr %23, i64 264
  %71 = load i64, ptr %70, align 8, !noalias !9
  %72 = getelementptr i8, ptr %23, i64 272
  %73 = load i64, ptr %72, align 8, !noalias !9
  %74 = inttoptr i64 %71 to ptr
  %75 = getelementptr i8, ptr %23, i64 288
  %76 = load i64, ptr %75, align 8, !noalias !9
  %77 = getelementptr i8, ptr %23, i64 296
  %78 = load i64, ptr %77, align 8, !noalias !9
  %79 = getelementptr i8, ptr %23, i64 304
  %80 = load i64, ptr %79, align 8, !noalias !9
  %81 = inttoptr i64 %76 to ptr
  %82 = getelementptr i8, ptr %23, i64 312
  %83 = load i64, ptr %82, align 8, !noalias !9
  %84 = getelementptr i8, ptr %23, i64 320
  %85 = load i64, ptr %84, align 8, !noalias !9
  %86 = inttoptr i64 %83 to ptr
  %87 = getelementptr i8, ptr %23, i64 336
  %88 = load i64, ptr %87, align 8, !noalias !9
  %89 = getelementptr i8, ptr %23, i64 344
  %90 = load i64, ptr %89, align 8, !noalias !9
  %91 = inttoptr i64 %88 to ptr
  %92 = getelementptr i8, ptr %23, i64 360
  %93 = load i64, ptr %92, align 8, !noalias !9
  %94 = getelementptr i8, ptr %23, i64 368
  %95 = load i64, ptr %94, align 8, !noalias !9
  %96 = inttoptr i64 %93 to ptr
  %97 = getelementptr i8, ptr %23, i64 384
  %98 = load i64, ptr %97, align 8, !noalias !9
  %99 = getelementptr i8, ptr %23, i64 392
  %100 = load i64, ptr %99, align 8, !noalias !9
  %101 = inttoptr i64 %98 to ptr
  %102 = getelementptr i8, ptr %23, i64 408
  %103 = load i64, ptr %102, align 8, !noalias !9
  %104 = getelementptr i8, ptr %23, i64 416
  %105 = load i64, ptr %104, align 8, !noalias !9
  %106 = inttoptr i64 %103 to ptr
  %107 = getelementptr i8, ptr %23, i64 432
  %108 = load i64, ptr %107, align 8, !noalias !9
  %109 = getelementptr i8, ptr %23, i64 440
  %110 = load i64, ptr %109, align 8, !noalias !9
  %111 = inttoptr i64 %108 to ptr
  %112 = getelementptr i8, ptr %23, i64 456
  %113 = load i64, ptr %112, align 8, !noalias !9
  %114 = getelementptr i8, ptr %23, i64 464
  %115 = load i64, ptr %114, align 8, !noalias !9
  %116 = inttoptr i64 %113 to ptr
  %117 = getelementptr i8, ptr %23, i64 480
  %118 = load i64, ptr %117, align 8, !noalias !9
  %119 = getelementptr i8, ptr %23, i64 488
  %120 = load i64, ptr %119, align 8, !noalias !9
  %121 = inttoptr i64 %118 to ptr
  %122 = getelementptr i8, ptr %23, i64 504
  %123 = load i64, ptr %122, align 8, !noalias !9
  %124 = getelementptr i8, ptr %23, i64 512
  %125 = load i64, ptr %124, align 8, !noalias !9
  %126 = inttoptr i64 %123 to ptr
  %127 = getelementptr i8, ptr %23, i64 528
  %128 = load i64, ptr %127, align 8, !noalias !9
  %129 = getelementptr i8, ptr %23, i64 536
  %130 = load i64, ptr %129, align 8, !noalias !9
  %131 = inttoptr i64 %128 to ptr
  %132 = getelementptr i8, ptr %23, i64 552
  %133 = load i64, ptr %132, align 8, !noalias !9
  %134 = getelementptr i8, ptr %23, i64 560
  %135 = load i64, ptr %134, align 8, !noalias !9
  %136 = inttoptr i64 %133 to ptr
  %137 = getelementptr i8, ptr %23, i64 576
  %138 = load i64, ptr %137, align 8, !noalias !9
  %139 = getelementptr i8, ptr %23, i64 584
  %140 = load i64, ptr %139, align 8, !noalias !9
  %141 = inttoptr i64 %138 to ptr
  %142 = getelementptr i8, ptr %23, i64 600
  %143 = load i64, ptr %142, align 8, !noalias !9
  %144 = getelementptr i8, ptr %23, i64 608
  %145 = load i64, ptr %144, align 8, !noalias !9
  %146 = inttoptr i64 %143 to ptr
  %147 = getelementptr i8, ptr %23, i64 624
  %148 = load i64, ptr %147, align 8, !noalias !9
  %149 = getelementptr i8, ptr %23, i64 632
  %150 = load i64, ptr %149, align 8, !noalias !9
  %151 = inttoptr i64 %148 to ptr
  %152 = getelementptr i8, ptr %51, i64 8
  %153 = load i64, ptr %152, align 8, !noalias !9
  %154 = mul nsw i64 %150, %153
  %155 = inttoptr i64 %1 to ptr
  %156 = icmp eq i64 %2, 1
  br i1 %156, label %157, label %190

157:                                              ; preds = %3
  %158 = getelementptr i8, ptr %23, i64 984
  %159 = load i64, ptr %158, align 8, !noalias !9
  %160 = getelementptr i8, ptr %23, i64 992
  %161 = load i64, ptr %160, align 8, !noalias !9
  %162 = inttoptr i64 %159 to ptr
  %163 = getelementptr i8, ptr %23, i64 1008
  %164 = load i64, ptr %163, align 8, !noalias !9
  %165 = getelementptr i8, ptr %23, i64 1016
  %166 = load i64, ptr %165, align 8, !noalias !9
  %167 = inttoptr i64 %164 to ptr
  %168 = call i64 @llvm.smax.i64(i64 %153, i64 0)
  br label %169

169:                                              ; preds = %200, %157
  %170 = phi i64 [ 0, %157 ], [ %202, %200 ]
  %171 = phi i64 [ %168, %157 ], [ %201, %200 ]
  %172 = icmp sgt i64 %171, 0
  br i1 %172, label %200, label %173

173:                                              ; preds = %169
  %174 = call i64 @llvm.smax.i64(i64 %140, i64 0)
  br label %175

175:                                              ; preds = %179, %173
  %176 = phi i64 [ 0, %173 ], [ %181, %179 ]
  %177 = phi i64 [ %174, %173 ], [ %180, %179 ]
  %178 = icmp sgt i64 %177, 0
  br i1 %178, label %179, label %211

179:                                              ; preds = %175
  %180 = add nsw i64 %177, -1
  %181 = add i64 %176, 1
  %182 = icmp slt i64 %176, 0
  %183 = select i1 %182, i64 %161, i64 0
  %184 = getelementptr double, ptr %162, i64 %176
  %185 = getelementptr double, ptr %184, i64 %183
  %186 = load double, ptr %185, align 8, !noalias !12
  %187 = select i1 %182, i64 %140, i64 0
  %188 = getelementptr double, ptr %141, i64 %176
  %189 = getelementptr double, ptr %188, i64 %187
  store double %186, ptr %189, align 8, !noalias !12
  br label %175

190:                                              ; preds = %213, %3
  %191 = getelementptr i8, ptr %23, i64 648
  %192 = load i64, ptr %191, align 8, !noalias !9
  %193 = inttoptr i64 %192 to ptr
  %194 = getelementptr i8, ptr %23, i64 720
  %195 = load i64, ptr %194, align 8, !noalias !9
  %196 = inttoptr i64 %195 to ptr
  %197 = getelementptr i8, ptr %146, i64 56
  %198 = load i64, ptr %197, align 8, !noalias !5
  %199 = icmp eq i64 %198, 0
  br i1 %199, label %228, label %229

200:                                              ; preds = %169
  %201 = add nsw i64 %171, -1
  %202 = add i64 %170, 1
  %203 = icmp slt i64 %170, 0
  %204 = select i1 %203, i64 %154, i64 0
  %205 = getelementptr double, ptr %155, i64 %170
  %206 = getelementptr double, ptr %205, i64 %204
  %207 = load double, ptr %206, align 8, !noalias !9
  %208 = select i1 %203, i64 %85, i64 0
  %209 = getelementptr double, ptr %86, i64 %170
  %210 = getelementptr double, ptr %209, i64 %208
  store double %207, ptr %210, align 8, !noalias !9
  br label %169

211:                                              ; preds = %175
  %212 = call i64 @llvm.smax.i64(i64 %145, i64 0)
  br label %213

213:                                              ; preds = %217, %211
  %214 = phi i64 [ 0, %211 ], [ %219, %217 ]
  %215 = phi i64 [ %212, %211 ], [ %218, %217 ]
  %216 = icmp sgt i64 %215, 0
  br i1 %216, label %217, label %190

217:                                              ; preds = %213
  %218 = add nsw i64 %215, -1
  %219 = add i64 %214, 1
  %220 = icmp slt i64 %214, 0
  %221 = select i1 %220, i64 %166, i64 0
  %222 = getelementptr i64, ptr %167, i64 %214
  %223 = getelementptr i64, ptr %222, i64 %221
  %224 = load i64, ptr %223, align 8, !noalias !15
  %225 = select i1 %220, i64 %145, i64 0
  %226 = getelementptr i64, ptr %146, i64 %214
  %227 = getelementptr i64, ptr %226, i64 %225
  store i64 %224, ptr %227, align 8, !noalias !15
  br label %213

228:                                              ; preds = %190
  br label %1138

229:                                              ; preds = %190
  %230 = load i64, ptr %25, align 8, !noalias !5
  %231 = load i64, ptr %193, align 8, !noalias !5
  %232 = icmp eq i64 %231, 1
  %233 = getelementptr i8, ptr %25, i64 8
  %234 = load i64, ptr %233, align 8, !noalias !5
  %235 = icmp sgt i64 %234, 0
  %236 = mul nsw i64 %230, %85
  %237 = shl i64 %236, 3
  %238 = add i64 %237, %118
  %239 = call i64 @llvm.smin.i64(i64 %150, i64 0)
  %240 = getelementptr double, ptr %151, i64 %150
  %241 = getelementptr i8, ptr %240, i64 -8
  %242 = getelementptr double, ptr %241, i64 %239
  %243 = load double, ptr %242, align 8, !noalias !5
  %244 = load double, ptr %141, align 8, !noalias !5
  %245 = getelementptr i8, ptr %141, i64 8
  %246 = load double, ptr %245, align 8, !noalias !5
  %247 = load i64, ptr %146, align 8, !noalias !5
  %248 = icmp eq i64 %247, 0
  br i1 %248, label %249, label %319

249:                                              ; preds = %229
  %250 = getelementptr i8, ptr %146, i64 24
  %251 = load i64, ptr %250, align 8, !noalias !5
  %252 = add nsw i64 %251, 1
  store i64 %252, ptr %250, align 8, !noalias !5
  store ptr null, ptr %12, align 8, !noalias !18
  store ptr null, ptr %13, align 8, !noalias !18
  store double %244, ptr %54, align 8, !noalias !18
  %253 = icmp sgt i64 %66, 0
  br i1 %253, label %254, label %257

254:                                              ; preds = %249
  store ptr null, ptr %12, align 8, !noalias !18
  %255 = call fastcc i32 @_sample(ptr nonnull %12, ptr %59, i64 %58, ptr %69, i64 %66, i64 %68, ptr %74, i64 %73, ptr %81, i64 %78, i64 %80, double %244) #3
  switch i32 %255, label %256 [
    i32 -2, label %257
    i32 0, label %257
  ], !prof !25

256:                                              ; preds = %254
  br label %257

257:                                              ; preds = %254, %254, %249, %256
  %258 = phi i32 [ %255, %256 ], [ 0, %249 ], [ 0, %254 ], [ 0, %254 ]
  switch i32 %258, label %263 [
    i32 -2, label %259
    i32 0, label %259
  ], !prof !25

259:                                              ; preds = %257, %257
  %260 = load i64, ptr %51, align 8, !noalias !26
  %261 = inttoptr i64 %260 to ptr
  %262 = call i32 %261(ptr nonnull %54, ptr %86, ptr %59, ptr %62, ptr %121) #3, !noalias !26
  br label %263

263:                                              ; preds = %257, %259
  %264 = phi i32 [ %262, %259 ], [ 0, %257 ]
  %265 = phi i32 [ 0, %259 ], [ %258, %257 ]
  switch i32 %265, label %823 [
    i32 -2, label %821
    i32 0, label %821
  ], !prof !25

266:                                              ; preds = %821
  %267 = getelementptr i8, ptr %146, i64 72
  store i64 3, ptr %267, align 8, !noalias !5
  %268 = icmp slt i32 %264, 0
  %269 = select i1 %268, i64 -4, i64 2
  br label %1138

270:                                              ; preds = %821
  store i64 1, ptr %146, align 8, !noalias !5
  %271 = getelementptr i8, ptr %48, i64 40
  %272 = load double, ptr %271, align 8, !noalias !5
  %273 = getelementptr i8, ptr %141, i64 24
  store double 1.000000e-04, ptr %273, align 8, !noalias !5
  %274 = getelementptr i8, ptr %141, i64 40
  store double %272, ptr %274, align 8, !noalias !5
  store i8 0, ptr %16, align 1, !noalias !5
  %275 = call fastcc i32 @write_reached(ptr nonnull %16, ptr %51, ptr %86, i64 %85, ptr nonnull %141, ptr nonnull %146, i64 %150, ptr %151, i64 %150, ptr %155, i64 %154) #3
  switch i32 %275, label %827 [
    i32 -2, label %824
    i32 0, label %824
  ], !prof !25

276:                                              ; preds = %824
  br label %1138

277:                                              ; preds = %824
  %278 = fcmp oeq double %246, 0.000000e+00
  br i1 %278, label %279, label %319

279:                                              ; preds = %277
  %280 = load i64, ptr %152, align 8, !noalias !5
  store double 0.000000e+00, ptr %17, align 8, !noalias !5
  %281 = call fastcc i32 @_norm(ptr nonnull %17, ptr %86, i64 %85, ptr %111, i64 %110, ptr %86, i64 %85, ptr %131, i64 %130, ptr %136, i64 %135, i64 %280) #3
  %282 = load double, ptr %17, align 8, !noalias !5
  switch i32 %281, label %831 [
    i32 -2, label %828
    i32 0, label %828
  ], !prof !25

283:                                              ; preds = %832, %845
  %284 = phi i64 [ 0, %832 ], [ %847, %845 ]
  %285 = phi i64 [ %843, %832 ], [ %846, %845 ]
  %286 = icmp sgt i64 %285, 0
  br i1 %286, label %845, label %287

287:                                              ; preds = %283
  %288 = load i64, ptr %250, align 8, !noalias !5
  %289 = add nsw i64 %288, 1
  store i64 %289, ptr %250, align 8, !noalias !5
  %290 = icmp slt i64 %85, 0
  %291 = select i1 %290, i64 %120, i64 0
  %292 = add i64 %85, %291
  %293 = icmp slt i64 %292, 0
  br i1 %293, label %862, label %863, !prof !0

294:                                              ; preds = %886
  %295 = fmul double %842, 1.000000e-03
  br label %314

296:                                              ; preds = %886
  store double 0.000000e+00, ptr %19, align 8, !noalias !5
  %297 = call fastcc i32 @_norm(ptr nonnull %19, ptr %871, i64 %870, ptr %121, i64 %120, ptr %86, i64 %85, ptr %131, i64 %130, ptr %136, i64 %135, i64 %280) #3
  switch i32 %297, label %897 [
    i32 -2, label %888
    i32 0, label %888
  ], !prof !25

298:                                              ; preds = %888
  %299 = fdiv double 1.000000e-02, %892
  %300 = load double, ptr %48, align 8, !noalias !5
  %301 = call double @llvm.pow.f64(double %299, double %300)
  br label %302

302:                                              ; preds = %888, %298
  %303 = phi double [ %301, %298 ], [ %895, %888 ]
  %304 = fmul double %842, 1.000000e+02
  %305 = fcmp olt double %303, %304
  %306 = select i1 %305, double %303, double %304
  %307 = call double @llvm.fabs.f64(double %244)
  %308 = fmul double %307, 0x3D30000000000000
  %309 = fcmp olt double %306, %308
  %310 = select i1 %309, double %308, double %306
  %311 = load double, ptr %839, align 8, !noalias !5
  %312 = fcmp olt double %311, %310
  %313 = select i1 %312, double %311, double %310
  br label %314

314:                                              ; preds = %302, %294
  %315 = phi double [ %295, %294 ], [ %313, %302 ]
  %316 = call i1 @llvm.is.fpclass.f64(double %315, i32 384)
  br i1 %316, label %319, label %317

317:                                              ; preds = %314
  %318 = getelementptr i8, ptr %146, i64 72
  store i64 4, ptr %318, align 8, !noalias !5
  br label %319

319:                                              ; preds = %314, %317, %277, %229
  %320 = phi double [ %315, %314 ], [ %315, %317 ], [ %246, %277 ], [ %246, %229 ]
  br label %321

321:                                              ; preds = %816, %319
  %322 = phi double [ %320, %319 ], [ %815, %816 ]
  %323 = phi double [ %244, %319 ], [ %326, %816 ]
  br label %324

324:                                              ; preds = %786, %321
  %325 = phi double [ %322, %321 ], [ %780, %786 ]
  %326 = phi double [ %323, %321 ], [ %371, %786 ]
  %327 = load i64, ptr %197, align 8, !noalias !5
  %328 = icmp eq i64 %327, 0
  br i1 %328, label %329, label %330

329:                                              ; preds = %324
  store double %325, ptr %245, align 8, !noalias !5
  br label %1138

330:                                              ; preds = %324
  %331 = add nsw i64 %327, -1
  store i64 %331, ptr %197, align 8, !noalias !5
  %332 = getelementptr i8, ptr %146, i64 8
  %333 = load i64, ptr %332, align 8, !noalias !5
  %334 = getelementptr i8, ptr %146, i64 16
  %335 = load i64, ptr %334, align 8, !noalias !5
  %336 = add nsw i64 %333, %335
  %337 = getelementptr i8, ptr %146, i64 64
  %338 = load i64, ptr %337, align 8, !noalias !5
  %339 = icmp slt i64 %336, %338
  br i1 %339, label %341, label %340

340:                                              ; preds = %330
  store double %325, ptr %245, align 8, !noalias !5
  br label %1138

341:                                              ; preds = %330
  br i1 %235, label %342, label %347

342:                                              ; preds = %341
  %343 = getelementptr i8, ptr %141, i64 16
  %344 = load double, ptr %343, align 8, !noalias !5
  %345 = fcmp olt double %344, %325
  %346 = select i1 %345, double %344, double %325
  br label %362

347:                                              ; preds = %341
  %348 = getelementptr i8, ptr %146, i64 48
  %349 = load i64, ptr %348, align 8, !noalias !5
  %350 = icmp slt i64 %349, 0
  %351 = select i1 %350, i64 %150, i64 0
  %352 = getelementptr double, ptr %151, i64 %349
  %353 = getelementptr double, ptr %352, i64 %351
  %354 = load double, ptr %353, align 8, !noalias !5
  %355 = fsub double %354, %326
  %356 = fdiv double %355, %325
  %357 = fmul double %356, 0x3FEFFFFFFFFFDCD1
  %358 = call double @llvm.ceil.f64(double %357)
  %359 = fptosi double %358 to i64
  %360 = sitofp i64 %359 to double
  %361 = fdiv double %355, %360
  br label %362

362:                                              ; preds = %342, %347
  %363 = phi double [ %361, %347 ], [ %346, %342 ]
  %364 = phi double [ %354, %347 ], [ %243, %342 ]
  %365 = fadd double %326, %363
  %366 = fmul double %363, 1.000000e-03
  %367 = fsub double %364, %366
  %368 = fcmp ogt double %365, %367
  %369 = fsub double %364, %326
  %370 = select i1 %368, double %369, double %363
  %371 = select i1 %368, double %364, double %365
  %372 = fmul double %370, 6.250000e-02
  %373 = fadd double %326, %372
  %374 = fcmp ogt double %373, %326
  %375 = fcmp oeq double %371, %364
  %376 = or i1 %374, %375
  br i1 %376, label %377, label %819

377:                                              ; preds = %362
  %378 = call i64 @llvm.smax.i64(i64 %100, i64 0)
  br label %379

379:                                              ; preds = %377, %898
  %380 = phi i64 [ 0, %377 ], [ %900, %898 ]
  %381 = phi i64 [ %378, %377 ], [ %899, %898 ]
  %382 = icmp sgt i64 %381, 0
  br i1 %382, label %898, label %383

383:                                              ; preds = %379
  %384 = load i64, ptr %25, align 8, !noalias !5
  %385 = add i64 %384, -1
  %386 = call i64 @llvm.smax.i64(i64 %385, i64 0)
  br label %387

387:                                              ; preds = %938, %383
  %388 = phi i64 [ 1, %383 ], [ %907, %938 ]
  %389 = phi i64 [ %386, %383 ], [ %906, %938 ]
  %390 = icmp slt i64 %389, 1
  br i1 %390, label %393, label %905

391:                                              ; preds = %938
  %392 = sext i32 %935 to i64
  br label %395

393:                                              ; preds = %387
  store ptr null, ptr %21, align 8, !noalias !5
  %394 = call fastcc i32 @_combine_latest(ptr nonnull %21, ptr %30, i64 %29, ptr %35, i64 %34, ptr %40, i64 %39, ptr %51, ptr %86, ptr %101, ptr %121, i64 %120, i64 %384, i64 %88, double %370) #3
  switch i32 %394, label %941 [
    i32 -2, label %395
    i32 0, label %395
  ], !prof !25

395:                                              ; preds = %393, %393, %391
  %396 = phi i64 [ %392, %391 ], [ 0, %393 ], [ 0, %393 ]
  br i1 %390, label %397, label %420

397:                                              ; preds = %395
  %398 = getelementptr i8, ptr %25, i64 32
  %399 = load i64, ptr %398, align 8, !noalias !5
  %400 = icmp eq i64 %399, 1
  br i1 %400, label %401, label %420

401:                                              ; preds = %397
  %402 = getelementptr i8, ptr %146, i64 24
  %403 = load i64, ptr %402, align 8, !noalias !5
  %404 = add nsw i64 %403, 1
  store i64 %404, ptr %402, align 8, !noalias !5
  store ptr null, ptr %8, align 8, !noalias !27
  store ptr null, ptr %9, align 8, !noalias !27
  store double %371, ptr %54, align 8, !noalias !27
  %405 = icmp sgt i64 %66, 0
  br i1 %405, label %406, label %409

406:                                              ; preds = %401
  store ptr null, ptr %8, align 8, !noalias !27
  %407 = call fastcc i32 @_sample(ptr nonnull %8, ptr %59, i64 %58, ptr %69, i64 %66, i64 %68, ptr %74, i64 %73, ptr %81, i64 %78, i64 %80, double %371) #3
  switch i32 %407, label %408 [
    i32 -2, label %409
    i32 0, label %409
  ], !prof !25

408:                                              ; preds = %406
  br label %409

409:                                              ; preds = %406, %406, %401, %408
  %410 = phi i32 [ %407, %408 ], [ 0, %401 ], [ 0, %406 ], [ 0, %406 ]
  switch i32 %410, label %417 [
    i32 -2, label %411
    i32 0, label %411
  ], !prof !25

411:                                              ; preds = %409, %409
  %412 = load i64, ptr %51, align 8, !noalias !34
  %413 = inttoptr i64 %412 to ptr
  %414 = inttoptr i64 %238 to ptr
  %415 = call i32 %413(ptr nonnull %54, ptr %91, ptr %59, ptr %62, ptr %414) #3, !noalias !34
  %416 = sext i32 %415 to i64
  br label %417

417:                                              ; preds = %409, %411
  %418 = phi i64 [ %416, %411 ], [ 0, %409 ]
  %419 = phi i32 [ 0, %411 ], [ %410, %409 ]
  switch i32 %419, label %942 [
    i32 -2, label %420
    i32 0, label %420
  ], !prof !25

420:                                              ; preds = %417, %417, %397, %395
  %421 = phi i64 [ %396, %395 ], [ 0, %397 ], [ %418, %417 ], [ %418, %417 ]
  %422 = icmp slt i64 %421, 0
  br i1 %422, label %423, label %424

423:                                              ; preds = %420
  br label %1138

424:                                              ; preds = %420
  %425 = icmp eq i64 %421, 0
  br i1 %425, label %426, label %542

426:                                              ; preds = %424
  br i1 %235, label %427, label %501

427:                                              ; preds = %426
  %428 = load i64, ptr %152, align 8, !noalias !5
  %429 = load i64, ptr %25, align 8, !noalias !5
  %430 = add nsw i64 %429, 1
  %431 = load i64, ptr %233, align 8, !noalias !5
  %432 = call i64 @llvm.smax.i64(i64 %431, i64 0)
  br label %433

433:                                              ; preds = %427, %943
  %434 = phi i64 [ 0, %427 ], [ %945, %943 ]
  %435 = phi i64 [ %432, %427 ], [ %944, %943 ]
  %436 = icmp sgt i64 %435, 0
  br i1 %436, label %943, label %437

437:                                              ; preds = %433
  %438 = call i64 @llvm.smax.i64(i64 %428, i64 0)
  br label %439

439:                                              ; preds = %445, %437
  %440 = phi i64 [ 0, %437 ], [ %467, %445 ]
  %441 = phi i64 [ %438, %437 ], [ %468, %445 ]
  %442 = phi double [ 0.000000e+00, %437 ], [ %485, %445 ]
  %443 = phi double [ 0.000000e+00, %437 ], [ %487, %445 ]
  %444 = icmp sgt i64 %441, 0
  br i1 %444, label %445, label %966

445:                                              ; preds = %439
  %446 = icmp slt i64 %440, 0
  %447 = select i1 %446, i64 %135, i64 0
  %448 = getelementptr double, ptr %136, i64 %440
  %449 = getelementptr double, ptr %448, i64 %447
  %450 = load double, ptr %449, align 8, !noalias !35
  %451 = select i1 %446, i64 %130, i64 0
  %452 = getelementptr double, ptr %131, i64 %440
  %453 = getelementptr double, ptr %452, i64 %451
  %454 = load double, ptr %453, align 8, !noalias !35
  %455 = select i1 %446, i64 %85, i64 0
  %456 = getelementptr double, ptr %86, i64 %440
  %457 = getelementptr double, ptr %456, i64 %455
  %458 = load double, ptr %457, align 8, !noalias !35
  %459 = call double @llvm.fabs.f64(double %458)
  %460 = select i1 %446, i64 %90, i64 0
  %461 = getelementptr double, ptr %91, i64 %440
  %462 = getelementptr double, ptr %461, i64 %460
  %463 = load double, ptr %462, align 8, !noalias !35
  %464 = call double @llvm.fabs.f64(double %463)
  %465 = fcmp ogt double %464, %459
  %466 = select i1 %465, double %464, double %459
  %467 = add i64 %440, 1
  %468 = add nsw i64 %441, -1
  %469 = fmul double %454, %466
  %470 = fadd double %450, %469
  %471 = fdiv double 1.000000e+00, %470
  %472 = select i1 %446, i64 %115, i64 0
  %473 = getelementptr double, ptr %116, i64 %440
  %474 = getelementptr double, ptr %473, i64 %472
  %475 = load double, ptr %474, align 8, !noalias !35
  %476 = fmul double %475, %471
  %477 = add nsw i64 %85, %440
  %478 = icmp slt i64 %477, 0
  %479 = select i1 %478, i64 %115, i64 0
  %480 = getelementptr double, ptr %116, i64 %477
  %481 = getelementptr double, ptr %480, i64 %479
  %482 = load double, ptr %481, align 8, !noalias !35
  %483 = fmul double %482, %471
  %484 = fmul double %476, %476
  %485 = fadd double %442, %484
  %486 = fmul double %483, %483
  %487 = fadd double %443, %486
  br label %439

488:                                              ; preds = %966
  %489 = fcmp oeq double %442, 0.000000e+00
  br i1 %489, label %508, label %490

490:                                              ; preds = %488
  %491 = fmul double %443, 1.000000e-02
  %492 = fadd double %442, %491
  %493 = sitofp i64 %428 to double
  %494 = fmul double %492, %493
  %495 = call double @sqrt(double %494), !noalias !5
  %496 = fdiv double %442, %495
  br label %508

497:                                              ; preds = %966
  %498 = sitofp i64 %428 to double
  %499 = fdiv double %442, %498
  %500 = call double @sqrt(double %499), !noalias !5
  br label %508

501:                                              ; preds = %426
  %502 = call i64 @llvm.smax.i64(i64 %85, i64 0)
  br label %503

503:                                              ; preds = %501, %969
  %504 = phi i64 [ 0, %501 ], [ %971, %969 ]
  %505 = phi i64 [ %502, %501 ], [ %970, %969 ]
  %506 = phi double [ 0.000000e+00, %501 ], [ %978, %969 ]
  %507 = icmp sgt i64 %505, 0
  br i1 %507, label %969, label %508

508:                                              ; preds = %503, %490, %497, %488
  %509 = phi double [ %506, %503 ], [ %500, %497 ], [ %496, %490 ], [ 0.000000e+00, %488 ]
  %510 = fcmp olt double %509, 1.000000e+00
  br i1 %510, label %511, label %542

511:                                              ; preds = %508
  br i1 %232, label %516, label %512

512:                                              ; preds = %511
  %513 = getelementptr i8, ptr %25, i64 32
  %514 = load i64, ptr %513, align 8, !noalias !5
  %515 = icmp eq i64 %514, 0
  br i1 %515, label %523, label %542

516:                                              ; preds = %511
  %517 = getelementptr i8, ptr %193, i64 56
  %518 = load i64, ptr %517, align 8, !noalias !5
  %519 = inttoptr i64 %518 to ptr
  %520 = call i64 %519(i64 %0, double %371, i64 %88) #3, !noalias !5
  %521 = icmp eq i64 %520, 0
  br i1 %521, label %523, label %522

522:                                              ; preds = %516
  store double %370, ptr %245, align 8, !noalias !5
  br label %1138

523:                                              ; preds = %512, %516
  %524 = getelementptr i8, ptr %146, i64 24
  %525 = load i64, ptr %524, align 8, !noalias !5
  %526 = add nsw i64 %525, 1
  store i64 %526, ptr %524, align 8, !noalias !5
  store ptr null, ptr %6, align 8, !noalias !39
  store ptr null, ptr %7, align 8, !noalias !39
  store double %371, ptr %54, align 8, !noalias !39
  %527 = icmp sgt i64 %66, 0
  br i1 %527, label %528, label %531

528:                                              ; preds = %523
  store ptr null, ptr %6, align 8, !noalias !39
  %529 = call fastcc i32 @_sample(ptr nonnull %6, ptr %59, i64 %58, ptr %69, i64 %66, i64 %68, ptr %74, i64 %73, ptr %81, i64 %78, i64 %80, double %371) #3
  switch i32 %529, label %530 [
    i32 -2, label %531
    i32 0, label %531
  ], !prof !25

530:                                              ; preds = %528
  br label %531

531:                                              ; preds = %528, %528, %523, %530
  %532 = phi i32 [ %529, %530 ], [ 0, %523 ], [ 0, %528 ], [ 0, %528 ]
  switch i32 %532, label %538 [
    i32 -2, label %533
    i32 0, label %533
  ], !prof !25

533:                                              ; preds = %531, %531
  %534 = load i64, ptr %51, align 8, !noalias !46
  %535 = inttoptr i64 %534 to ptr
  %536 = inttoptr i64 %238 to ptr
  %537 = call i32 %535(ptr nonnull %54, ptr %91, ptr %59, ptr %62, ptr %536) #3, !noalias !46
  br label %538

538:                                              ; preds = %531, %533
  %539 = phi i32 [ %537, %533 ], [ 0, %531 ]
  %540 = phi i32 [ 0, %533 ], [ %532, %531 ]
  switch i32 %540, label %982 [
    i32 -2, label %979
    i32 0, label %979
  ], !prof !25

541:                                              ; preds = %979
  br label %1138

542:                                              ; preds = %979, %512, %508, %424
  %543 = phi i1 [ true, %424 ], [ false, %508 ], [ true, %512 ], [ true, %979 ]
  %544 = phi i64 [ %421, %424 ], [ 0, %508 ], [ 0, %512 ], [ %980, %979 ]
  %545 = phi double [ 0.000000e+00, %424 ], [ %509, %508 ], [ %509, %512 ], [ %509, %979 ]
  %546 = icmp eq i64 %544, 0
  %547 = and i1 %546, %543
  br i1 %547, label %548, label %789

548:                                              ; preds = %542
  %549 = load i64, ptr %332, align 8, !noalias !5
  %550 = add nsw i64 %549, 1
  store i64 %550, ptr %332, align 8, !noalias !5
  store double %371, ptr %141, align 8, !noalias !5
  %551 = getelementptr i8, ptr %141, i64 32
  store double %370, ptr %551, align 8, !noalias !5
  %552 = getelementptr i8, ptr %146, i64 48
  %553 = load i64, ptr %552, align 8, !noalias !5
  %554 = icmp slt i64 %553, 0
  %555 = select i1 %554, i64 %150, i64 0
  %556 = getelementptr double, ptr %151, i64 %553
  %557 = getelementptr double, ptr %556, i64 %555
  %558 = load double, ptr %557, align 8, !noalias !5
  %559 = fcmp oeq double %558, %371
  br i1 %559, label %560, label %567

560:                                              ; preds = %548
  %561 = getelementptr i8, ptr %196, i64 8
  %562 = load i64, ptr %561, align 8, !noalias !5
  %563 = icmp ne i64 %562, 0
  %564 = select i1 %563, i1 true, i1 %232
  br i1 %564, label %567, label %565

565:                                              ; preds = %560
  store i8 0, ptr %22, align 1, !noalias !5
  %566 = call fastcc i32 @write_reached(ptr nonnull %22, ptr %51, ptr %91, i64 %90, ptr nonnull %141, ptr nonnull %146, i64 %150, ptr %151, i64 %150, ptr %155, i64 %154) #3
  switch i32 %566, label %983 [
    i32 -2, label %744
    i32 0, label %744
  ], !prof !25

567:                                              ; preds = %560, %548
  %568 = getelementptr i8, ptr %196, i64 8
  %569 = load i64, ptr %568, align 8, !noalias !5
  %570 = icmp slt i64 %569, 1
  %571 = fcmp ugt double %558, %371
  %572 = and i1 %570, %571
  br i1 %572, label %744, label %573

573:                                              ; preds = %567
  %574 = load i64, ptr %25, align 8, !noalias !5
  %575 = add nsw i64 %574, 1
  %576 = load i64, ptr %233, align 8, !noalias !5
  %577 = add nsw i64 %575, %576
  %578 = getelementptr i8, ptr %25, i64 16
  %579 = load i64, ptr %578, align 8, !noalias !5
  %580 = call i64 @llvm.smax.i64(i64 %579, i64 0)
  br label %581

581:                                              ; preds = %573, %590
  %582 = phi i64 [ 0, %573 ], [ %986, %590 ]
  %583 = phi i64 [ %580, %573 ], [ %985, %590 ]
  %584 = phi i64 [ %577, %573 ], [ %591, %590 ]
  %585 = icmp sgt i64 %583, 0
  br i1 %585, label %984, label %592

586:                                              ; preds = %1031
  %587 = getelementptr i8, ptr %146, i64 72
  store i64 3, ptr %587, align 8, !noalias !5
  %588 = icmp slt i32 %1029, 0
  %589 = select i1 %588, i64 -4, i64 2
  br label %1138

590:                                              ; preds = %1031
  %591 = add nsw i64 %584, 1
  br label %581

592:                                              ; preds = %581
  %593 = mul nsw i64 %574, %85
  %594 = call i64 @llvm.smax.i64(i64 %85, i64 0)
  br label %595

595:                                              ; preds = %592, %1034
  %596 = phi i64 [ 0, %592 ], [ %1036, %1034 ]
  %597 = phi i64 [ %594, %592 ], [ %1035, %1034 ]
  %598 = icmp sgt i64 %597, 0
  br i1 %598, label %1034, label %599

599:                                              ; preds = %595
  %600 = getelementptr i8, ptr %25, i64 24
  %601 = load i64, ptr %600, align 8, !noalias !5
  %602 = add i64 %601, -3
  %603 = call i64 @llvm.smax.i64(i64 %602, i64 0)
  br label %604

604:                                              ; preds = %1076, %599
  %605 = phi i64 [ 3, %599 ], [ %1078, %1076 ]
  %606 = phi i64 [ %603, %599 ], [ %1077, %1076 ]
  %607 = phi i64 [ %584, %599 ], [ %1098, %1076 ]
  %608 = icmp sgt i64 %606, 0
  br i1 %608, label %1076, label %609

609:                                              ; preds = %604
  %610 = load i64, ptr %568, align 8, !noalias !5
  %611 = icmp sgt i64 %610, 0
  br i1 %611, label %612, label %619

612:                                              ; preds = %609
  %613 = getelementptr i8, ptr %196, i64 16
  %614 = load i64, ptr %613, align 8, !noalias !5
  %615 = inttoptr i64 %614 to ptr
  %616 = call i64 %615(i64 %0, double %326, double %370) #3, !noalias !5
  %617 = getelementptr i8, ptr %141, i64 48
  %618 = load double, ptr %617, align 8, !noalias !5
  br label %619

619:                                              ; preds = %612, %609
  %620 = phi double [ %618, %612 ], [ 1.000000e+00, %609 ]
  %621 = phi i64 [ %616, %612 ], [ 0, %609 ]
  %622 = fcmp oeq double %620, 1.000000e+00
  br i1 %622, label %623, label %625

623:                                              ; preds = %619
  %624 = load double, ptr %141, align 8, !noalias !5
  br label %628

625:                                              ; preds = %619
  %626 = fmul double %620, %370
  %627 = fadd double %326, %626
  br label %628

628:                                              ; preds = %625, %623
  %629 = phi double [ %624, %623 ], [ %627, %625 ]
  %630 = load i64, ptr %152, align 8, !noalias !5
  %631 = load i64, ptr %193, align 8, !noalias !5
  %632 = icmp eq i64 %631, 1
  %633 = load i64, ptr %552, align 8, !noalias !5
  %634 = icmp slt i64 %633, %150
  br i1 %634, label %635, label %672

635:                                              ; preds = %628
  %636 = icmp slt i64 %633, 0
  %637 = select i1 %636, i64 %150, i64 0
  %638 = getelementptr double, ptr %151, i64 %633
  %639 = getelementptr double, ptr %638, i64 %637
  %640 = load double, ptr %639, align 8, !noalias !5
  %641 = fcmp ugt double %640, %629
  br i1 %641, label %672, label %642

642:                                              ; preds = %635, %665
  %643 = phi i64 [ %663, %665 ], [ %633, %635 ]
  %644 = icmp slt i64 %643, 0
  %645 = select i1 %644, i64 %150, i64 0
  %646 = getelementptr double, ptr %151, i64 %643
  %647 = getelementptr double, ptr %646, i64 %645
  %648 = load double, ptr %647, align 8, !noalias !5
  %649 = fsub double %648, %326
  %650 = fdiv double %649, %370
  %651 = mul nsw i64 %643, %630
  %652 = shl i64 %651, 3
  %653 = add i64 %652, %1
  %654 = call i64 @llvm.smax.i64(i64 %105, i64 0)
  br label %1099

655:                                              ; preds = %1103
  %656 = getelementptr i8, ptr %193, i64 56
  %657 = load i64, ptr %656, align 8, !noalias !5
  %658 = load double, ptr %647, align 8, !noalias !5
  %659 = inttoptr i64 %657 to ptr
  %660 = call i64 %659(i64 %0, double %658, i64 %653) #3, !noalias !5
  %661 = icmp eq i64 %660, 0
  br i1 %661, label %662, label %674

662:                                              ; preds = %1103, %655
  %663 = add nsw i64 %643, 1
  %664 = icmp slt i64 %663, %150
  br i1 %664, label %665, label %672

665:                                              ; preds = %662
  %666 = icmp slt i64 %643, -1
  %667 = select i1 %666, i64 %150, i64 0
  %668 = getelementptr double, ptr %151, i64 %663
  %669 = getelementptr double, ptr %668, i64 %667
  %670 = load double, ptr %669, align 8, !noalias !5
  %671 = fcmp ugt double %670, %629
  br i1 %671, label %672, label %642

672:                                              ; preds = %665, %662, %635, %628
  %673 = phi i64 [ %663, %665 ], [ %663, %662 ], [ %633, %635 ], [ %633, %628 ]
  store i64 %673, ptr %552, align 8, !noalias !5
  br label %674

674:                                              ; preds = %655, %672
  %675 = phi i1 [ true, %672 ], [ false, %655 ]
  %676 = phi i64 [ 0, %672 ], [ %660, %655 ]
  %677 = icmp ne i64 %621, 0
  %678 = select i1 %675, i1 %677, i1 false
  %679 = fcmp olt double %620, 1.000000e+00
  %680 = and i1 %678, %679
  br i1 %680, label %681, label %719

681:                                              ; preds = %674
  %682 = call i64 @llvm.smax.i64(i64 %105, i64 0)
  br label %683

683:                                              ; preds = %681, %707
  %684 = phi i64 [ 0, %681 ], [ %709, %707 ]
  %685 = phi i64 [ %682, %681 ], [ %708, %707 ]
  %686 = icmp sgt i64 %685, 0
  br i1 %686, label %707, label %687

687:                                              ; preds = %683
  %688 = load i64, ptr %600, align 8, !noalias !47
  %689 = getelementptr i8, ptr %51, i64 16
  %690 = load i64, ptr %689, align 8, !noalias !47
  call fastcc void @pydy_nested(i64 %93, i64 %83, i64 %123, i64 %85, i64 %688, i64 %103, i64 %690) #3, !noalias !47
  %691 = call i64 @llvm.smax.i64(i64 %90, i64 0)
  br label %692

692:                                              ; preds = %696, %687
  %693 = phi i64 [ 0, %687 ], [ %698, %696 ]
  %694 = phi i64 [ %691, %687 ], [ %697, %696 ]
  %695 = icmp sgt i64 %694, 0
  br i1 %695, label %696, label %1114

696:                                              ; preds = %692
  %697 = add nsw i64 %694, -1
  %698 = add i64 %693, 1
  %699 = icmp slt i64 %693, 0
  %700 = select i1 %699, i64 %95, i64 0
  %701 = getelementptr double, ptr %96, i64 %693
  %702 = getelementptr double, ptr %701, i64 %700
  %703 = load double, ptr %702, align 8, !noalias !51
  %704 = select i1 %699, i64 %90, i64 0
  %705 = getelementptr double, ptr %91, i64 %693
  %706 = getelementptr double, ptr %705, i64 %704
  store double %703, ptr %706, align 8, !noalias !51
  br label %692

707:                                              ; preds = %683
  %708 = add nsw i64 %685, -1
  %709 = add i64 %684, 1
  %710 = icmp slt i64 %684, 0
  %711 = select i1 %710, i64 %105, i64 0
  %712 = getelementptr double, ptr %106, i64 %684
  %713 = getelementptr double, ptr %712, i64 %711
  store double %620, ptr %713, align 8, !noalias !47
  br label %683

714:                                              ; preds = %1114
  %715 = getelementptr i8, ptr %193, i64 56
  %716 = load i64, ptr %715, align 8, !noalias !5
  %717 = inttoptr i64 %716 to ptr
  %718 = call i64 %717(i64 %0, double %629, i64 %88) #3, !noalias !5
  br label %719

719:                                              ; preds = %1114, %714, %674
  %720 = phi i64 [ %718, %714 ], [ 0, %1114 ], [ %676, %674 ]
  %721 = icmp eq i64 %720, 0
  br i1 %721, label %723, label %722

722:                                              ; preds = %719
  store double %326, ptr %141, align 8, !noalias !5
  store double %370, ptr %245, align 8, !noalias !5
  br label %740

723:                                              ; preds = %719
  %724 = icmp eq i64 %621, 0
  br i1 %724, label %740, label %725

725:                                              ; preds = %723, %729
  %726 = phi i64 [ %731, %729 ], [ 0, %723 ]
  %727 = phi i64 [ %730, %729 ], [ %594, %723 ]
  %728 = icmp sgt i64 %727, 0
  br i1 %728, label %729, label %1117

729:                                              ; preds = %725
  %730 = add nsw i64 %727, -1
  %731 = add i64 %726, 1
  %732 = icmp slt i64 %726, 0
  %733 = select i1 %732, i64 %90, i64 0
  %734 = getelementptr double, ptr %91, i64 %726
  %735 = getelementptr double, ptr %734, i64 %733
  %736 = load double, ptr %735, align 8, !noalias !54
  %737 = select i1 %732, i64 %85, i64 0
  %738 = getelementptr double, ptr %86, i64 %726
  %739 = getelementptr double, ptr %738, i64 %737
  store double %736, ptr %739, align 8, !noalias !54
  br label %725

740:                                              ; preds = %723, %1117, %722
  %741 = phi i1 [ false, %722 ], [ false, %1117 ], [ true, %723 ]
  %742 = phi i64 [ %720, %722 ], [ %621, %1117 ], [ 0, %723 ]
  br i1 %741, label %744, label %743

743:                                              ; preds = %740
  br label %1138

744:                                              ; preds = %567, %565, %565, %740
  br i1 %235, label %745, label %779

745:                                              ; preds = %744
  %746 = fcmp olt double %545, 1.000000e-10
  %747 = select i1 %746, double 1.000000e-10, double %545
  %748 = getelementptr i8, ptr %48, i64 24
  %749 = load double, ptr %748, align 8, !noalias !5
  %750 = getelementptr i8, ptr %48, i64 8
  %751 = load double, ptr %750, align 8, !noalias !5
  %752 = fneg double %751
  %753 = call double @llvm.pow.f64(double %747, double %752)
  %754 = fmul double %749, %753
  %755 = getelementptr i8, ptr %48, i64 16
  %756 = load double, ptr %755, align 8, !noalias !5
  %757 = fcmp une double %756, 0.000000e+00
  br i1 %757, label %758, label %763

758:                                              ; preds = %745
  %759 = getelementptr i8, ptr %141, i64 24
  %760 = load double, ptr %759, align 8, !noalias !5
  %761 = call double @llvm.pow.f64(double %760, double %756)
  %762 = fmul double %754, %761
  br label %763

763:                                              ; preds = %745, %758
  %764 = phi double [ %762, %758 ], [ %754, %745 ]
  %765 = getelementptr i8, ptr %141, i64 40
  %766 = load double, ptr %765, align 8, !noalias !5
  %767 = getelementptr i8, ptr %48, i64 32
  %768 = load double, ptr %767, align 8, !noalias !5
  %769 = fcmp ogt double %764, %768
  %770 = select i1 %769, double %764, double %768
  %771 = fcmp olt double %770, %766
  %772 = select i1 %771, double %770, double %766
  %773 = fcmp olt double %747, 1.000000e-04
  %774 = select i1 %773, double 1.000000e-04, double %747
  %775 = fmul double %370, %772
  %776 = getelementptr i8, ptr %141, i64 24
  store double %774, ptr %776, align 8, !noalias !5
  %777 = getelementptr i8, ptr %48, i64 40
  %778 = load double, ptr %777, align 8, !noalias !5
  store double %778, ptr %765, align 8, !noalias !5
  br label %779

779:                                              ; preds = %763, %744
  %780 = phi double [ %775, %763 ], [ %325, %744 ]
  %781 = call i64 @llvm.smax.i64(i64 %85, i64 0)
  br label %782

782:                                              ; preds = %779, %1118
  %783 = phi i64 [ 0, %779 ], [ %1120, %1118 ]
  %784 = phi i64 [ %781, %779 ], [ %1119, %1118 ]
  %785 = icmp sgt i64 %784, 0
  br i1 %785, label %1118, label %786

786:                                              ; preds = %782
  %787 = load i64, ptr %552, align 8, !noalias !5
  %788 = icmp eq i64 %787, %150
  br i1 %788, label %820, label %324

789:                                              ; preds = %542
  %790 = load i64, ptr %334, align 8, !noalias !5
  %791 = add nsw i64 %790, 1
  store i64 %791, ptr %334, align 8, !noalias !5
  br i1 %546, label %795, label %792

792:                                              ; preds = %789
  %793 = fmul double %370, 2.500000e-01
  %794 = getelementptr i8, ptr %146, i64 72
  store i64 3, ptr %794, align 8, !noalias !5
  br label %814

795:                                              ; preds = %789
  %796 = fsub double %545, %545
  %797 = fcmp ord double %796, 0.000000e+00
  br i1 %797, label %798, label %811

798:                                              ; preds = %795
  %799 = getelementptr i8, ptr %146, i64 72
  store i64 2, ptr %799, align 8, !noalias !5
  %800 = getelementptr i8, ptr %48, i64 32
  %801 = load double, ptr %800, align 8, !noalias !5
  %802 = getelementptr i8, ptr %48, i64 24
  %803 = load double, ptr %802, align 8, !noalias !5
  %804 = load double, ptr %48, align 8, !noalias !5
  %805 = fneg double %804
  %806 = call double @llvm.pow.f64(double %545, double %805)
  %807 = fmul double %803, %806
  %808 = fcmp ogt double %807, %801
  %809 = select i1 %808, double %807, double %801
  %810 = fmul double %370, %809
  br label %814

811:                                              ; preds = %795
  %812 = fmul double %370, 2.500000e-01
  %813 = getelementptr i8, ptr %146, i64 72
  store i64 4, ptr %813, align 8, !noalias !5
  br label %814

814:                                              ; preds = %798, %811, %792
  %815 = phi double [ %793, %792 ], [ %810, %798 ], [ %812, %811 ]
  br i1 %235, label %816, label %818

816:                                              ; preds = %814
  %817 = getelementptr i8, ptr %141, i64 40
  store double 1.000000e+00, ptr %817, align 8, !noalias !5
  br label %321

818:                                              ; preds = %814
  store double %370, ptr %245, align 8, !noalias !5
  br label %1138

819:                                              ; preds = %362
  store double %370, ptr %245, align 8, !noalias !5
  br label %1138

820:                                              ; preds = %786
  store double %780, ptr %245, align 8, !noalias !5
  br label %1138

821:                                              ; preds = %263, %263
  %822 = icmp eq i32 %264, 0
  br i1 %822, label %270, label %266

823:                                              ; preds = %263
  br label %1138

824:                                              ; preds = %270, %270
  %825 = load i8, ptr %16, align 1, !noalias !5
  %826 = icmp eq i8 %825, 0
  br i1 %826, label %277, label %276

827:                                              ; preds = %270
  br label %1138

828:                                              ; preds = %279, %279
  store double 0.000000e+00, ptr %18, align 8, !noalias !5
  %829 = call fastcc i32 @_norm(ptr nonnull %18, ptr %121, i64 %120, ptr %111, i64 %110, ptr %86, i64 %85, ptr %131, i64 %130, ptr %136, i64 %135, i64 %280) #3
  %830 = load double, ptr %18, align 8, !noalias !5
  switch i32 %829, label %844 [
    i32 -2, label %832
    i32 0, label %832
  ], !prof !25

831:                                              ; preds = %279
  br label %1138

832:                                              ; preds = %828, %828
  %833 = fcmp olt double %282, 1.000000e-05
  %834 = fcmp olt double %830, 1.000000e-05
  %835 = select i1 %833, i1 true, i1 %834
  %836 = fmul double %282, 1.000000e-02
  %837 = fdiv double %836, %830
  %838 = select i1 %835, double 0x3EB0C6F7A0B5ED8D, double %837
  %839 = getelementptr i8, ptr %141, i64 16
  %840 = load double, ptr %839, align 8, !noalias !5
  %841 = fcmp olt double %840, %838
  %842 = select i1 %841, double %840, double %838
  %843 = call i64 @llvm.smax.i64(i64 %280, i64 0)
  br label %283

844:                                              ; preds = %828
  br label %1138

845:                                              ; preds = %283
  %846 = add nsw i64 %285, -1
  %847 = add i64 %284, 1
  %848 = icmp slt i64 %284, 0
  %849 = select i1 %848, i64 %85, i64 0
  %850 = getelementptr double, ptr %86, i64 %284
  %851 = getelementptr double, ptr %850, i64 %849
  %852 = load double, ptr %851, align 8, !noalias !5
  %853 = select i1 %848, i64 %120, i64 0
  %854 = getelementptr double, ptr %121, i64 %284
  %855 = getelementptr double, ptr %854, i64 %853
  %856 = load double, ptr %855, align 8, !noalias !5
  %857 = fmul double %842, %856
  %858 = fadd double %852, %857
  %859 = select i1 %848, i64 %95, i64 0
  %860 = getelementptr double, ptr %96, i64 %284
  %861 = getelementptr double, ptr %860, i64 %859
  store double %858, ptr %861, align 8, !noalias !5
  br label %283

862:                                              ; preds = %287
  br label %863

863:                                              ; preds = %862, %287
  %864 = phi i64 [ 0, %862 ], [ %292, %287 ]
  %865 = icmp slt i64 %292, %120
  br i1 %865, label %867, label %866, !prof !4

866:                                              ; preds = %863
  br label %867

867:                                              ; preds = %866, %863
  %868 = phi i64 [ %120, %866 ], [ %864, %863 ]
  %869 = sub i64 %120, %868
  %870 = call i64 @llvm.smax.i64(i64 %869, i64 0)
  %871 = getelementptr double, ptr %121, i64 %868
  %872 = fadd double %244, %842
  store ptr null, ptr %14, align 8, !noalias !57
  store ptr null, ptr %15, align 8, !noalias !57
  store double %872, ptr %54, align 8, !noalias !57
  br i1 %253, label %873, label %876

873:                                              ; preds = %867
  store ptr null, ptr %14, align 8, !noalias !57
  %874 = call fastcc i32 @_sample(ptr nonnull %14, ptr %59, i64 %58, ptr %69, i64 %66, i64 %68, ptr %74, i64 %73, ptr %81, i64 %78, i64 %80, double %872) #3
  switch i32 %874, label %875 [
    i32 -2, label %876
    i32 0, label %876
  ], !prof !25

875:                                              ; preds = %873
  br label %876

876:                                              ; preds = %873, %873, %867, %875
  %877 = phi i32 [ %874, %875 ], [ 0, %867 ], [ 0, %873 ], [ 0, %873 ]
  switch i32 %877, label %883 [
    i32 -2, label %878
    i32 0, label %878
  ], !prof !25

878:                                              ; preds = %876, %876
  %879 = load i64, ptr %51, align 8, !noalias !64
  %880 = inttoptr i64 %879 to ptr
  %881 = call i32 %880(ptr nonnull %54, ptr %96, ptr %59, ptr %62, ptr %871) #3, !noalias !64
  %882 = icmp eq i32 %881, 0
  br label %883

883:                                              ; preds = %876, %878
  %884 = phi i1 [ %882, %878 ], [ true, %876 ]
  %885 = phi i32 [ 0, %878 ], [ %877, %876 ]
  switch i32 %885, label %887 [
    i32 -2, label %886
    i32 0, label %886
  ], !prof !25

886:                                              ; preds = %883, %883
  br i1 %884, label %296, label %294

887:                                              ; preds = %883
  br label %1138

888:                                              ; preds = %296, %296
  %889 = load double, ptr %19, align 8, !noalias !5
  %890 = fdiv double %889, %842
  %891 = fcmp ogt double %890, %830
  %892 = select i1 %891, double %890, double %830
  %893 = fmul double %842, 1.000000e-03
  %894 = fcmp ogt double %893, 0x3EB0C6F7A0B5ED8D
  %895 = select i1 %894, double %893, double 0x3EB0C6F7A0B5ED8D
  %896 = fcmp ogt double %892, 1.000000e-15
  br i1 %896, label %298, label %302

897:                                              ; preds = %296
  br label %1138

898:                                              ; preds = %379
  %899 = add nsw i64 %381, -1
  %900 = add i64 %380, 1
  %901 = icmp slt i64 %380, 0
  %902 = select i1 %901, i64 %100, i64 0
  %903 = getelementptr double, ptr %101, i64 %380
  %904 = getelementptr double, ptr %903, i64 %902
  store double %370, ptr %904, align 8, !noalias !5
  br label %379

905:                                              ; preds = %387
  %906 = add nsw i64 %389, -1
  %907 = add i64 %388, 1
  store ptr null, ptr %20, align 8, !noalias !5
  %908 = call fastcc i32 @_combine_latest(ptr nonnull %20, ptr %30, i64 %29, ptr %35, i64 %34, ptr %40, i64 %39, ptr %51, ptr %86, ptr %101, ptr %121, i64 %120, i64 %388, i64 %93, double %370) #3
  switch i32 %908, label %937 [
    i32 -2, label %909
    i32 0, label %909
  ], !prof !25

909:                                              ; preds = %905, %905
  %910 = mul nsw i64 %388, %85
  %911 = shl i64 %910, 3
  %912 = add i64 %911, %118
  %913 = getelementptr i8, ptr %146, i64 24
  %914 = load i64, ptr %913, align 8, !noalias !5
  %915 = add nsw i64 %914, 1
  store i64 %915, ptr %913, align 8, !noalias !5
  %916 = icmp slt i64 %388, 0
  %917 = select i1 %916, i64 %44, i64 0
  %918 = getelementptr double, ptr %45, i64 %388
  %919 = getelementptr double, ptr %918, i64 %917
  %920 = load double, ptr %919, align 8, !noalias !5
  %921 = fmul double %920, %370
  %922 = fadd double %326, %921
  store ptr null, ptr %10, align 8, !noalias !65
  store ptr null, ptr %11, align 8, !noalias !65
  store double %922, ptr %54, align 8, !noalias !65
  %923 = icmp sgt i64 %66, 0
  br i1 %923, label %924, label %927

924:                                              ; preds = %909
  store ptr null, ptr %10, align 8, !noalias !65
  %925 = call fastcc i32 @_sample(ptr nonnull %10, ptr %59, i64 %58, ptr %69, i64 %66, i64 %68, ptr %74, i64 %73, ptr %81, i64 %78, i64 %80, double %922) #3
  switch i32 %925, label %926 [
    i32 -2, label %927
    i32 0, label %927
  ], !prof !25

926:                                              ; preds = %924
  br label %927

927:                                              ; preds = %924, %924, %909, %926
  %928 = phi i32 [ %925, %926 ], [ 0, %909 ], [ 0, %924 ], [ 0, %924 ]
  switch i32 %928, label %934 [
    i32 -2, label %929
    i32 0, label %929
  ], !prof !25

929:                                              ; preds = %927, %927
  %930 = load i64, ptr %51, align 8, !noalias !72
  %931 = inttoptr i64 %930 to ptr
  %932 = inttoptr i64 %912 to ptr
  %933 = call i32 %931(ptr nonnull %54, ptr %96, ptr %59, ptr %62, ptr %932) #3, !noalias !72
  br label %934

934:                                              ; preds = %927, %929
  %935 = phi i32 [ %933, %929 ], [ 0, %927 ]
  %936 = phi i32 [ 0, %929 ], [ %928, %927 ]
  switch i32 %936, label %940 [
    i32 -2, label %938
    i32 0, label %938
  ], !prof !25

937:                                              ; preds = %905
  br label %1138

938:                                              ; preds = %934, %934
  %939 = icmp eq i32 %935, 0
  br i1 %939, label %387, label %391

940:                                              ; preds = %934
  br label %1138

941:                                              ; preds = %393
  br label %1138

942:                                              ; preds = %417
  br label %1138

943:                                              ; preds = %433
  %944 = add nsw i64 %435, -1
  %945 = add i64 %434, 1
  %946 = add nsw i64 %430, %434
  %947 = mul nsw i64 %434, %85
  %948 = shl i64 %947, 3
  %949 = add i64 %948, %113
  %950 = icmp slt i64 %946, 0
  %951 = select i1 %950, i64 %29, i64 0
  %952 = getelementptr i64, ptr %30, i64 %946
  %953 = getelementptr i64, ptr %952, i64 %951
  %954 = load i64, ptr %953, align 8, !noalias !73
  %955 = shl i64 %954, 3
  %956 = add i64 %955, %32
  %957 = add i64 %955, %37
  %958 = icmp slt i64 %946, -1
  %959 = select i1 %958, i64 %29, i64 0
  %960 = getelementptr i8, ptr %952, i64 8
  %961 = getelementptr i64, ptr %960, i64 %959
  %962 = load i64, ptr %961, align 8, !noalias !73
  %963 = sub nsw i64 %962, %954
  %964 = getelementptr i8, ptr %51, i64 16
  %965 = load i64, ptr %964, align 8, !noalias !73
  call fastcc void @pydy_combine(i64 %949, i64 %108, i64 %98, i64 %118, i64 %956, i64 %957, i64 %963, i64 %965) #3, !noalias !73
  br label %433

966:                                              ; preds = %439
  %967 = load i64, ptr %233, align 8, !noalias !5
  %968 = icmp eq i64 %967, 2
  br i1 %968, label %488, label %497

969:                                              ; preds = %503
  %970 = add nsw i64 %505, -1
  %971 = add i64 %504, 1
  %972 = icmp slt i64 %504, 0
  %973 = select i1 %972, i64 %90, i64 0
  %974 = getelementptr double, ptr %91, i64 %504
  %975 = getelementptr double, ptr %974, i64 %973
  %976 = load double, ptr %975, align 8, !noalias !5
  %977 = fmul double %976, 0.000000e+00
  %978 = fadd double %506, %977
  br label %503

979:                                              ; preds = %538, %538
  %980 = sext i32 %539 to i64
  %981 = icmp slt i32 %539, 0
  br i1 %981, label %541, label %542

982:                                              ; preds = %538
  br label %1138

983:                                              ; preds = %565
  br label %1138

984:                                              ; preds = %581
  %985 = add nsw i64 %583, -1
  %986 = add i64 %582, 1
  %987 = icmp slt i64 %584, 0
  %988 = select i1 %987, i64 %29, i64 0
  %989 = getelementptr i64, ptr %30, i64 %584
  %990 = getelementptr i64, ptr %989, i64 %988
  %991 = load i64, ptr %990, align 8, !noalias !76
  %992 = shl i64 %991, 3
  %993 = add i64 %992, %32
  %994 = add i64 %992, %37
  %995 = icmp slt i64 %584, -1
  %996 = select i1 %995, i64 %29, i64 0
  %997 = getelementptr i8, ptr %989, i64 8
  %998 = getelementptr i64, ptr %997, i64 %996
  %999 = load i64, ptr %998, align 8, !noalias !76
  %1000 = sub nsw i64 %999, %991
  %1001 = getelementptr i8, ptr %51, i64 16
  %1002 = load i64, ptr %1001, align 8, !noalias !76
  call fastcc void @pydy_combine(i64 %93, i64 %83, i64 %98, i64 %118, i64 %993, i64 %994, i64 %1000, i64 %1002) #3, !noalias !76
  %1003 = add nsw i64 %575, %582
  %1004 = mul nsw i64 %1003, %85
  %1005 = shl i64 %1004, 3
  %1006 = add i64 %1005, %118
  %1007 = getelementptr i8, ptr %146, i64 24
  %1008 = load i64, ptr %1007, align 8, !noalias !5
  %1009 = add nsw i64 %1008, 1
  store i64 %1009, ptr %1007, align 8, !noalias !5
  %1010 = icmp slt i64 %1003, 0
  %1011 = select i1 %1010, i64 %44, i64 0
  %1012 = getelementptr double, ptr %45, i64 %1003
  %1013 = getelementptr double, ptr %1012, i64 %1011
  %1014 = load double, ptr %1013, align 8, !noalias !5
  %1015 = fmul double %1014, %370
  %1016 = fadd double %326, %1015
  store ptr null, ptr %4, align 8, !noalias !79
  store ptr null, ptr %5, align 8, !noalias !79
  store double %1016, ptr %54, align 8, !noalias !79
  %1017 = icmp sgt i64 %66, 0
  br i1 %1017, label %1018, label %1021

1018:                                             ; preds = %984
  store ptr null, ptr %4, align 8, !noalias !79
  %1019 = call fastcc i32 @_sample(ptr nonnull %4, ptr %59, i64 %58, ptr %69, i64 %66, i64 %68, ptr %74, i64 %73, ptr %81, i64 %78, i64 %80, double %1016) #3
  switch i32 %1019, label %1020 [
    i32 -2, label %1021
    i32 0, label %1021
  ], !prof !25

1020:                                             ; preds = %1018
  br label %1021

1021:                                             ; preds = %1018, %1018, %984, %1020
  %1022 = phi i32 [ %1019, %1020 ], [ 0, %984 ], [ 0, %1018 ], [ 0, %1018 ]
  switch i32 %1022, label %1028 [
    i32 -2, label %1023
    i32 0, label %1023
  ], !prof !25

1023:                                             ; preds = %1021, %1021
  %1024 = load i64, ptr %51, align 8, !noalias !86
  %1025 = inttoptr i64 %1024 to ptr
  %1026 = inttoptr i64 %1006 to ptr
  %1027 = call i32 %1025(ptr nonnull %54, ptr %96, ptr %59, ptr %62, ptr %1026) #3, !noalias !86
  br label %1028

1028:                                             ; preds = %1021, %1023
  %1029 = phi i32 [ %1027, %1023 ], [ 0, %1021 ]
  %1030 = phi i32 [ 0, %1023 ], [ %1022, %1021 ]
  switch i32 %1030, label %1033 [
    i32 -2, label %1031
    i32 0, label %1031
  ], !prof !25

1031:                                             ; preds = %1028, %1028
  %1032 = icmp eq i32 %1029, 0
  br i1 %1032, label %590, label %586

1033:                                             ; preds = %1028
  br label %1138

1034:                                             ; preds = %595
  %1035 = add nsw i64 %597, -1
  %1036 = add i64 %596, 1
  %1037 = icmp slt i64 %596, 0
  %1038 = select i1 %1037, i64 %90, i64 0
  %1039 = getelementptr double, ptr %91, i64 %596
  %1040 = getelementptr double, ptr %1039, i64 %1038
  %1041 = load double, ptr %1040, align 8, !noalias !5
  %1042 = select i1 %1037, i64 %85, i64 0
  %1043 = getelementptr double, ptr %86, i64 %596
  %1044 = getelementptr double, ptr %1043, i64 %1042
  %1045 = load double, ptr %1044, align 8, !noalias !5
  %1046 = fsub double %1041, %1045
  %1047 = select i1 %1037, i64 %120, i64 0
  %1048 = getelementptr double, ptr %121, i64 %596
  %1049 = getelementptr double, ptr %1048, i64 %1047
  %1050 = load double, ptr %1049, align 8, !noalias !5
  %1051 = fmul double %370, %1050
  %1052 = fsub double %1051, %1046
  %1053 = select i1 %1037, i64 %125, i64 0
  %1054 = getelementptr double, ptr %126, i64 %596
  %1055 = getelementptr double, ptr %1054, i64 %1053
  store double %1046, ptr %1055, align 8, !noalias !5
  %1056 = add nsw i64 %85, %596
  %1057 = icmp slt i64 %1056, 0
  %1058 = select i1 %1057, i64 %125, i64 0
  %1059 = getelementptr double, ptr %126, i64 %1056
  %1060 = getelementptr double, ptr %1059, i64 %1058
  store double %1052, ptr %1060, align 8, !noalias !5
  %1061 = fsub double %1046, %1052
  %1062 = add nsw i64 %593, %596
  %1063 = icmp slt i64 %1062, 0
  %1064 = select i1 %1063, i64 %120, i64 0
  %1065 = getelementptr double, ptr %121, i64 %1062
  %1066 = getelementptr double, ptr %1065, i64 %1064
  %1067 = load double, ptr %1066, align 8, !noalias !5
  %1068 = fmul double %370, %1067
  %1069 = fsub double %1061, %1068
  %1070 = shl nsw i64 %85, 1
  %1071 = add nsw i64 %1070, %596
  %1072 = icmp slt i64 %1071, 0
  %1073 = select i1 %1072, i64 %125, i64 0
  %1074 = getelementptr double, ptr %126, i64 %1071
  %1075 = getelementptr double, ptr %1074, i64 %1073
  store double %1069, ptr %1075, align 8, !noalias !5
  br label %595

1076:                                             ; preds = %604
  %1077 = add nsw i64 %606, -1
  %1078 = add i64 %605, 1
  %1079 = mul nsw i64 %605, %85
  %1080 = shl i64 %1079, 3
  %1081 = add i64 %1080, %123
  %1082 = icmp slt i64 %607, 0
  %1083 = select i1 %1082, i64 %29, i64 0
  %1084 = getelementptr i64, ptr %30, i64 %607
  %1085 = getelementptr i64, ptr %1084, i64 %1083
  %1086 = load i64, ptr %1085, align 8, !noalias !87
  %1087 = shl i64 %1086, 3
  %1088 = add i64 %1087, %32
  %1089 = add i64 %1087, %37
  %1090 = icmp slt i64 %607, -1
  %1091 = select i1 %1090, i64 %29, i64 0
  %1092 = getelementptr i8, ptr %1084, i64 8
  %1093 = getelementptr i64, ptr %1092, i64 %1091
  %1094 = load i64, ptr %1093, align 8, !noalias !87
  %1095 = sub nsw i64 %1094, %1086
  %1096 = getelementptr i8, ptr %51, i64 16
  %1097 = load i64, ptr %1096, align 8, !noalias !87
  call fastcc void @pydy_combine(i64 %1081, i64 %108, i64 %98, i64 %118, i64 %1088, i64 %1089, i64 %1095, i64 %1097) #3, !noalias !87
  %1098 = add nsw i64 %607, 1
  br label %604

1099:                                             ; preds = %642, %1107
  %1100 = phi i64 [ 0, %642 ], [ %1109, %1107 ]
  %1101 = phi i64 [ %654, %642 ], [ %1108, %1107 ]
  %1102 = icmp sgt i64 %1101, 0
  br i1 %1102, label %1107, label %1103

1103:                                             ; preds = %1099
  %1104 = load i64, ptr %600, align 8, !noalias !90
  %1105 = getelementptr i8, ptr %51, i64 16
  %1106 = load i64, ptr %1105, align 8, !noalias !90
  call fastcc void @pydy_nested(i64 %653, i64 %83, i64 %123, i64 %85, i64 %1104, i64 %103, i64 %1106) #3, !noalias !90
  br i1 %632, label %655, label %662

1107:                                             ; preds = %1099
  %1108 = add nsw i64 %1101, -1
  %1109 = add i64 %1100, 1
  %1110 = icmp slt i64 %1100, 0
  %1111 = select i1 %1110, i64 %105, i64 0
  %1112 = getelementptr double, ptr %106, i64 %1100
  %1113 = getelementptr double, ptr %1112, i64 %1111
  store double %650, ptr %1113, align 8, !noalias !90
  br label %1099

1114:                                             ; preds = %692
  %1115 = load i64, ptr %193, align 8, !noalias !5
  %1116 = icmp eq i64 %1115, 1
  br i1 %1116, label %714, label %719

1117:                                             ; preds = %725
  store double %629, ptr %141, align 8, !noalias !5
  store double 0.000000e+00, ptr %245, align 8, !noalias !5
  store i64 0, ptr %146, align 8, !noalias !5
  br label %740

1118:                                             ; preds = %782
  %1119 = add nsw i64 %784, -1
  %1120 = add i64 %783, 1
  %1121 = icmp slt i64 %783, 0
  %1122 = select i1 %1121, i64 %90, i64 0
  %1123 = getelementptr double, ptr %91, i64 %783
  %1124 = getelementptr double, ptr %1123, i64 %1122
  %1125 = load double, ptr %1124, align 8, !noalias !5
  %1126 = select i1 %1121, i64 %85, i64 0
  %1127 = getelementptr double, ptr %86, i64 %783
  %1128 = getelementptr double, ptr %1127, i64 %1126
  store double %1125, ptr %1128, align 8, !noalias !5
  %1129 = add nsw i64 %236, %783
  %1130 = icmp slt i64 %1129, 0
  %1131 = select i1 %1130, i64 %120, i64 0
  %1132 = getelementptr double, ptr %121, i64 %1129
  %1133 = getelementptr double, ptr %1132, i64 %1131
  %1134 = load double, ptr %1133, align 8, !noalias !5
  %1135 = select i1 %1121, i64 %120, i64 0
  %1136 = getelementptr double, ptr %121, i64 %783
  %1137 = getelementptr double, ptr %1136, i64 %1135
  store double %1134, ptr %1137, align 8, !noalias !5
  br label %782

1138:                                             ; preds = %1033, %983, %982, %942, %941, %940, %937, %897, %887, %844, %831, %827, %823, %820, %819, %818, %743, %586, %541, %522, %423, %340, %329, %276, %266, %228
  %1139 = phi i64 [ 2, %819 ], [ -1, %228 ], [ 0, %823 ], [ %269, %266 ], [ 0, %827 ], [ 0, %276 ], [ 0, %831 ], [ 0, %844 ], [ %742, %743 ], [ %589, %586 ], [ 0, %887 ], [ -1, %329 ], [ 1, %340 ], [ 0, %983 ], [ 0, %1033 ], [ 0, %941 ], [ 0, %937 ], [ 0, %940 ], [ 0, %942 ], [ -4, %423 ], [ 0, %820 ], [ 0, %897 ], [ 6, %522 ], [ 0, %982 ], [ -4, %541 ], [ 2, %818 ]
  ret i64 %1139
}



declare i64 @llvm.smax.i64(i64, i64) #0

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #0

declare double @llvm.ceil.f64(double) #0

declare i64 @llvm.smin.i64(i64, i64) #0

attributes #0 = { nounwind willreturn memory(none) }
attributes #1 = { nounwind memory(read) }
attributes #2 = { noinline }
attributes #3 = { nounwind }
attributes #4 = { nounwind willreturn }

!0 = !{!"branch_weights", i32 1, i32 99}
!1 = !{!2}
!2 = distinct !{!2, !3}
!3 = distinct !{!3}
!4 = !{!"branch_weights", i32 99, i32 1}
!5 = !{!6, !8}
!6 = distinct !{!6, !7}
!7 = distinct !{!7}
!8 = distinct !{!8, !7}
!9 = !{!10, !6, !8}
!10 = distinct !{!10, !11}
!11 = distinct !{!11}
!12 = !{!13, !10, !6, !8}
!13 = distinct !{!13, !14}
!14 = distinct !{!14}
!15 = !{!16, !10, !6, !8}
!16 = distinct !{!16, !17}
!17 = distinct !{!17}
!18 = !{!19, !21, !22, !24}
!19 = distinct !{!19, !20}
!20 = distinct !{!20}
!21 = distinct !{!21, !20}
!22 = distinct !{!22, !23}
!23 = distinct !{!23}
!24 = distinct !{!24, !23}
!25 = !{!"branch_weights", i32 1, i32 49, i32 49}
!26 = !{!22, !24}
!27 = !{!28, !30, !31, !33}
!28 = distinct !{!28, !29}
!29 = distinct !{!29}
!30 = distinct !{!30, !29}
!31 = distinct !{!31, !32}
!32 = distinct !{!32}
!33 = distinct !{!33, !32}
!34 = !{!31, !33}
!35 = !{!36, !38}
!36 = distinct !{!36, !37}
!37 = distinct !{!37}
!38 = distinct !{!38, !37}
!39 = !{!40, !42, !43, !45}
!40 = distinct !{!40, !41}
!41 = distinct !{!41}
!42 = distinct !{!42, !41}
!43 = distinct !{!43, !44}
!44 = distinct !{!44}
!45 = distinct !{!45, !44}
!46 = !{!43, !45}
!47 = !{!48, !50, !6, !8}
!48 = distinct !{!48, !49}
!49 = distinct !{!49}
!50 = distinct !{!50, !49}
!51 = !{!52}
!52 = distinct !{!52, !53}
!53 = distinct !{!53}
!54 = !{!55}
!55 = distinct !{!55, !56}
!56 = distinct !{!56}
!57 = !{!58, !60, !61, !63}
!58 = distinct !{!58, !59}
!59 = distinct !{!59}
!60 = distinct !{!60, !59}
!61 = distinct !{!61, !62}
!62 = distinct !{!62}
!63 = distinct !{!63, !62}
!64 = !{!61, !63}
!65 = !{!66, !68, !69, !71}
!66 = distinct !{!66, !67}
!67 = distinct !{!67}
!68 = distinct !{!68, !67}
!69 = distinct !{!69, !70}
!70 = distinct !{!70}
!71 = distinct !{!71, !70}
!72 = !{!69, !71}
!73 = !{!74, !6, !8}
!74 = distinct !{!74, !75}
!75 = distinct !{!75}
!76 = !{!77, !6, !8}
!77 = distinct !{!77, !78}
!78 = distinct !{!78}
!79 = !{!80, !82, !83, !85}
!80 = distinct !{!80, !81}
!81 = distinct !{!81}
!82 = distinct !{!82, !81}
!83 = distinct !{!83, !84}
!84 = distinct !{!84}
!85 = distinct !{!85, !84}
!86 = !{!83, !85}
!87 = !{!88, !6, !8}
!88 = distinct !{!88, !89}
!89 = distinct !{!89}
!90 = !{!91, !93, !6, !8}
!91 = distinct !{!91, !92}
!92 = distinct !{!92}
!93 = distinct !{!93, !92}
