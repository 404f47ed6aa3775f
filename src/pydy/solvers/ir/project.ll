; sources f64025d5ed9d601f5933be052cc0668f9a00b065a6362beb89e5f83a8b39083f
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

declare double @llvm.fabs.f64(double) #0

define internal fastcc i32 @_sample(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, i64 %5, ptr %6, i64 %7, ptr %8, i64 %9, i64 %10, double %11) unnamed_addr #1 {
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

define internal fastcc i32 @_factor(ptr noalias %0, ptr %1, i64 %2, i64 %3) unnamed_addr {
  %5 = call i64 @llvm.smax.i64(i64 %2, i64 0)
  br label %6

6:                                                ; preds = %34, %4
  %7 = phi i64 [ 0, %4 ], [ %48, %34 ]
  %8 = phi i64 [ %5, %4 ], [ %47, %34 ]
  %9 = icmp sgt i64 %8, 0
  br i1 %9, label %46, label %29

10:                                               ; preds = %46, %59
  %11 = phi i64 [ 0, %46 ], [ %61, %59 ]
  %12 = phi i64 [ %58, %46 ], [ %60, %59 ]
  %13 = phi double [ %57, %46 ], [ %68, %59 ]
  %14 = icmp sgt i64 %12, 0
  br i1 %14, label %59, label %15

15:                                               ; preds = %10
  %16 = sitofp i64 %2 to double
  %17 = fmul double %16, 4.000000e+00
  %18 = fmul double %17, 0x3CB0000000000000
  %19 = fmul double %18, %57
  %20 = fcmp ogt double %13, %19
  br i1 %20, label %30, label %21

21:                                               ; preds = %15, %25
  %22 = phi i64 [ %71, %25 ], [ 0, %15 ]
  %23 = phi i64 [ %70, %25 ], [ %5, %15 ]
  %24 = icmp sgt i64 %23, 0
  br i1 %24, label %69, label %29

25:                                               ; preds = %69, %72
  %26 = phi i64 [ 0, %69 ], [ %74, %72 ]
  %27 = phi i64 [ %5, %69 ], [ %73, %72 ]
  %28 = icmp sgt i64 %27, 0
  br i1 %28, label %72, label %21

29:                                               ; preds = %6, %21
  store ptr null, ptr %0, align 8
  ret i32 0

30:                                               ; preds = %15
  %31 = call double @sqrt(double %13)
  store double %31, ptr %56, align 8
  %32 = sub i64 %2, %48
  %33 = call i64 @llvm.smax.i64(i64 %32, i64 0)
  br label %34

34:                                               ; preds = %30, %43
  %35 = phi i64 [ %48, %30 ], [ %88, %43 ]
  %36 = phi i64 [ %33, %30 ], [ %87, %43 ]
  %37 = icmp sgt i64 %36, 0
  br i1 %37, label %86, label %6

38:                                               ; preds = %86, %97
  %39 = phi i64 [ 0, %86 ], [ %99, %97 ]
  %40 = phi i64 [ %58, %86 ], [ %98, %97 ]
  %41 = phi double [ %96, %86 ], [ %109, %97 ]
  %42 = icmp sgt i64 %40, 0
  br i1 %42, label %97, label %43

43:                                               ; preds = %38
  %44 = load double, ptr %56, align 8
  %45 = fdiv double %41, %44
  store double %45, ptr %95, align 8
  br label %34

46:                                               ; preds = %6
  %47 = add nsw i64 %8, -1
  %48 = add i64 %7, 1
  %49 = icmp slt i64 %7, 0
  %50 = select i1 %49, i64 %2, i64 0
  %51 = add i64 %7, %50
  %52 = select i1 %49, i64 %3, i64 0
  %53 = mul i64 %51, %3
  %54 = getelementptr double, ptr %1, i64 %53
  %55 = getelementptr double, ptr %54, i64 %7
  %56 = getelementptr double, ptr %55, i64 %52
  %57 = load double, ptr %56, align 8
  %58 = call i64 @llvm.smax.i64(i64 %7, i64 0)
  br label %10

59:                                               ; preds = %10
  %60 = add nsw i64 %12, -1
  %61 = add i64 %11, 1
  %62 = icmp slt i64 %11, 0
  %63 = select i1 %62, i64 %3, i64 0
  %64 = getelementptr double, ptr %54, i64 %11
  %65 = getelementptr double, ptr %64, i64 %63
  %66 = load double, ptr %65, align 8
  %67 = fmul double %66, %66
  %68 = fsub double %13, %67
  br label %10

69:                                               ; preds = %21
  %70 = add nsw i64 %23, -1
  %71 = add i64 %22, 1
  br label %25

72:                                               ; preds = %25
  %73 = add nsw i64 %27, -1
  %74 = add i64 %26, 1
  %75 = icmp eq i64 %22, %26
  %76 = select i1 %75, double 1.000000e+00, double 0.000000e+00
  %77 = icmp slt i64 %22, 0
  %78 = select i1 %77, i64 %2, i64 0
  %79 = add i64 %22, %78
  %80 = icmp slt i64 %26, 0
  %81 = select i1 %80, i64 %3, i64 0
  %82 = mul i64 %79, %3
  %83 = getelementptr double, ptr %1, i64 %82
  %84 = getelementptr double, ptr %83, i64 %26
  %85 = getelementptr double, ptr %84, i64 %81
  store double %76, ptr %85, align 8
  br label %25

86:                                               ; preds = %34
  %87 = add nsw i64 %36, -1
  %88 = add i64 %35, 1
  %89 = icmp slt i64 %35, 0
  %90 = select i1 %89, i64 %2, i64 0
  %91 = add i64 %35, %90
  %92 = mul i64 %91, %3
  %93 = getelementptr double, ptr %1, i64 %92
  %94 = getelementptr double, ptr %93, i64 %7
  %95 = getelementptr double, ptr %94, i64 %52
  %96 = load double, ptr %95, align 8
  br label %38

97:                                               ; preds = %38
  %98 = add nsw i64 %40, -1
  %99 = add i64 %39, 1
  %100 = icmp slt i64 %39, 0
  %101 = select i1 %100, i64 %3, i64 0
  %102 = getelementptr double, ptr %93, i64 %39
  %103 = getelementptr double, ptr %102, i64 %101
  %104 = load double, ptr %103, align 8
  %105 = getelementptr double, ptr %54, i64 %39
  %106 = getelementptr double, ptr %105, i64 %101
  %107 = load double, ptr %106, align 8
  %108 = fmul double %104, %107
  %109 = fsub double %41, %108
  br label %38
}

declare double @sqrt(double) local_unnamed_addr #2

define internal fastcc i32 @_divide_rows(ptr noalias %0, ptr %1, i64 %2, i64 %3, ptr %4, i64 %5, i64 %6) unnamed_addr {
  %8 = call i64 @llvm.smax.i64(i64 %2, i64 0)
  br label %9

9:                                                ; preds = %13, %7
  %10 = phi i64 [ 0, %7 ], [ %35, %13 ]
  %11 = phi i64 [ %8, %7 ], [ %34, %13 ]
  %12 = icmp sgt i64 %11, 0
  br i1 %12, label %33, label %32

13:                                               ; preds = %33, %22
  %14 = phi i64 [ 0, %33 ], [ %39, %22 ]
  %15 = phi i64 [ %36, %33 ], [ %38, %22 ]
  %16 = icmp sgt i64 %15, 0
  br i1 %16, label %37, label %9

17:                                               ; preds = %37, %51
  %18 = phi i64 [ 0, %37 ], [ %53, %51 ]
  %19 = phi i64 [ %50, %37 ], [ %52, %51 ]
  %20 = phi double [ %49, %37 ], [ %68, %51 ]
  %21 = icmp sgt i64 %19, 0
  br i1 %21, label %51, label %22

22:                                               ; preds = %17
  %23 = select i1 %43, i64 %5, i64 0
  %24 = add i64 %14, %23
  %25 = select i1 %43, i64 %6, i64 0
  %26 = mul i64 %24, %6
  %27 = getelementptr double, ptr %4, i64 %26
  %28 = getelementptr double, ptr %27, i64 %14
  %29 = getelementptr double, ptr %28, i64 %25
  %30 = load double, ptr %29, align 8
  %31 = fdiv double %20, %30
  store double %31, ptr %48, align 8
  br label %13

32:                                               ; preds = %9
  store ptr null, ptr %0, align 8
  ret i32 0

33:                                               ; preds = %9
  %34 = add nsw i64 %11, -1
  %35 = add i64 %10, 1
  %36 = call i64 @llvm.smax.i64(i64 %5, i64 0)
  br label %13

37:                                               ; preds = %13
  %38 = add nsw i64 %15, -1
  %39 = add i64 %14, 1
  %40 = icmp slt i64 %10, 0
  %41 = select i1 %40, i64 %2, i64 0
  %42 = add i64 %10, %41
  %43 = icmp slt i64 %14, 0
  %44 = select i1 %43, i64 %3, i64 0
  %45 = mul i64 %42, %3
  %46 = getelementptr double, ptr %1, i64 %45
  %47 = getelementptr double, ptr %46, i64 %14
  %48 = getelementptr double, ptr %47, i64 %44
  %49 = load double, ptr %48, align 8
  %50 = call i64 @llvm.smax.i64(i64 %14, i64 0)
  br label %17

51:                                               ; preds = %17
  %52 = add nsw i64 %19, -1
  %53 = add i64 %18, 1
  %54 = select i1 %43, i64 %5, i64 0
  %55 = add i64 %14, %54
  %56 = icmp slt i64 %18, 0
  %57 = select i1 %56, i64 %6, i64 0
  %58 = mul i64 %55, %6
  %59 = getelementptr double, ptr %4, i64 %58
  %60 = getelementptr double, ptr %59, i64 %18
  %61 = getelementptr double, ptr %60, i64 %57
  %62 = load double, ptr %61, align 8
  %63 = select i1 %56, i64 %3, i64 0
  %64 = getelementptr double, ptr %46, i64 %18
  %65 = getelementptr double, ptr %64, i64 %63
  %66 = load double, ptr %65, align 8
  %67 = fmul double %62, %66
  %68 = fsub double %20, %67
  br label %17
}

define internal fastcc i32 @_minimum_norm(ptr noalias %0, ptr %1, i64 %2, i64 %3, ptr %4, i64 %5, ptr %6, i64 %7, ptr %8, i64 %9, ptr %10, i64 %11, ptr %12, i64 %13, ptr %14, i64 %15) unnamed_addr {
  %17 = call i64 @llvm.smax.i64(i64 %3, i64 0)
  br label %18

18:                                               ; preds = %16, %111
  %19 = phi i64 [ 0, %16 ], [ %113, %111 ]
  %20 = phi i64 [ %17, %16 ], [ %112, %111 ]
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %111, label %22

22:                                               ; preds = %18
  %23 = call i64 @llvm.smax.i64(i64 %2, i64 0)
  br label %24

24:                                               ; preds = %22, %47
  %25 = phi i64 [ 0, %22 ], [ %120, %47 ]
  %26 = phi i64 [ %23, %22 ], [ %119, %47 ]
  %27 = icmp sgt i64 %26, 0
  br i1 %27, label %118, label %48

28:                                               ; preds = %118, %134
  %29 = phi i64 [ 0, %118 ], [ %136, %134 ]
  %30 = phi i64 [ %17, %118 ], [ %135, %134 ]
  %31 = phi double [ 0.000000e+00, %118 ], [ %147, %134 ]
  %32 = icmp sgt i64 %30, 0
  br i1 %32, label %134, label %33

33:                                               ; preds = %28
  %34 = fcmp ogt double %31, 0.000000e+00
  br i1 %34, label %35, label %47

35:                                               ; preds = %33
  %36 = call double @sqrt(double %31)
  store double %36, ptr %130, align 8
  %37 = fdiv double 1.000000e+00, %36
  store double %37, ptr %124, align 8
  %38 = select i1 %121, i64 %7, i64 0
  %39 = getelementptr double, ptr %6, i64 %25
  %40 = getelementptr double, ptr %39, i64 %38
  %41 = load double, ptr %40, align 8
  %42 = fmul double %41, %37
  store double %42, ptr %40, align 8
  br label %43

43:                                               ; preds = %35, %148
  %44 = phi i64 [ 0, %35 ], [ %150, %148 ]
  %45 = phi i64 [ %17, %35 ], [ %149, %148 ]
  %46 = icmp sgt i64 %45, 0
  br i1 %46, label %148, label %47

47:                                               ; preds = %43, %33
  br label %24

48:                                               ; preds = %24, %84
  %49 = phi i64 [ %163, %84 ], [ %23, %24 ]
  %50 = icmp sgt i64 %49, 0
  br i1 %50, label %162, label %105

51:                                               ; preds = %162, %65
  %52 = phi i64 [ 0, %162 ], [ %166, %65 ]
  %53 = phi i64 [ %23, %162 ], [ %165, %65 ]
  %54 = phi double [ 0x3BC79CA10C924224, %162 ], [ %66, %65 ]
  %55 = phi i64 [ -1, %162 ], [ %67, %65 ]
  %56 = icmp sgt i64 %53, 0
  br i1 %56, label %164, label %68

57:                                               ; preds = %164, %173
  %58 = phi i64 [ %175, %173 ], [ 0, %164 ]
  %59 = phi i64 [ %174, %173 ], [ %17, %164 ]
  %60 = phi double [ %186, %173 ], [ 0.000000e+00, %164 ]
  %61 = icmp sgt i64 %59, 0
  br i1 %61, label %173, label %62

62:                                               ; preds = %57
  %63 = fcmp ogt double %60, %54
  br i1 %63, label %64, label %65

64:                                               ; preds = %62
  br label %65

65:                                               ; preds = %64, %62, %164
  %66 = phi double [ %60, %64 ], [ %54, %62 ], [ %54, %164 ]
  %67 = phi i64 [ %52, %64 ], [ %55, %62 ], [ %55, %164 ]
  br label %51

68:                                               ; preds = %51
  %69 = icmp slt i64 %55, 0
  br i1 %69, label %105, label %70

70:                                               ; preds = %68
  %71 = getelementptr i64, ptr %10, i64 %55
  store i64 0, ptr %71, align 8
  %72 = call double @sqrt(double %54)
  %73 = getelementptr double, ptr %12, i64 %55
  %74 = load double, ptr %73, align 8
  %75 = fmul double %72, %74
  %76 = getelementptr double, ptr %14, i64 %55
  store double %75, ptr %76, align 8
  %77 = getelementptr double, ptr %6, i64 %55
  %78 = load double, ptr %77, align 8
  %79 = fdiv double %78, %72
  store double 0.000000e+00, ptr %77, align 8
  br label %80

80:                                               ; preds = %70, %187
  %81 = phi i64 [ 0, %70 ], [ %189, %187 ]
  %82 = phi i64 [ %17, %70 ], [ %188, %187 ]
  %83 = icmp sgt i64 %82, 0
  br i1 %83, label %187, label %84

84:                                               ; preds = %80, %104
  %85 = phi i64 [ %206, %104 ], [ 0, %80 ]
  %86 = phi i64 [ %205, %104 ], [ %23, %80 ]
  %87 = icmp sgt i64 %86, 0
  br i1 %87, label %204, label %48

88:                                               ; preds = %204, %213
  %89 = phi i64 [ %215, %213 ], [ 0, %204 ]
  %90 = phi i64 [ %214, %213 ], [ %17, %204 ]
  %91 = phi double [ %231, %213 ], [ 0.000000e+00, %204 ]
  %92 = icmp sgt i64 %90, 0
  br i1 %92, label %213, label %93

93:                                               ; preds = %88
  %94 = select i1 %207, i64 %7, i64 0
  %95 = getelementptr double, ptr %6, i64 %85
  %96 = getelementptr double, ptr %95, i64 %94
  %97 = load double, ptr %96, align 8
  %98 = fmul double %91, %79
  %99 = fsub double %97, %98
  store double %99, ptr %96, align 8
  br label %100

100:                                              ; preds = %93, %232
  %101 = phi i64 [ 0, %93 ], [ %234, %232 ]
  %102 = phi i64 [ %17, %93 ], [ %233, %232 ]
  %103 = icmp sgt i64 %102, 0
  br i1 %103, label %232, label %104

104:                                              ; preds = %100, %204
  br label %84

105:                                              ; preds = %48, %68
  br label %106

106:                                              ; preds = %105, %251
  %107 = phi i64 [ 0, %105 ], [ %253, %251 ]
  %108 = phi i64 [ %23, %105 ], [ %252, %251 ]
  %109 = icmp sgt i64 %108, 0
  br i1 %109, label %251, label %110

110:                                              ; preds = %106
  store ptr null, ptr %0, align 8
  ret i32 0

111:                                              ; preds = %18
  %112 = add nsw i64 %20, -1
  %113 = add i64 %19, 1
  %114 = icmp slt i64 %19, 0
  %115 = select i1 %114, i64 %5, i64 0
  %116 = getelementptr double, ptr %4, i64 %19
  %117 = getelementptr double, ptr %116, i64 %115
  store double 0.000000e+00, ptr %117, align 8
  br label %18

118:                                              ; preds = %24
  %119 = add nsw i64 %26, -1
  %120 = add i64 %25, 1
  %121 = icmp slt i64 %25, 0
  %122 = select i1 %121, i64 %9, i64 0
  %123 = getelementptr double, ptr %8, i64 %25
  %124 = getelementptr double, ptr %123, i64 %122
  store double 1.000000e+00, ptr %124, align 8
  %125 = select i1 %121, i64 %11, i64 0
  %126 = getelementptr i64, ptr %10, i64 %25
  %127 = getelementptr i64, ptr %126, i64 %125
  store i64 1, ptr %127, align 8
  %128 = select i1 %121, i64 %13, i64 0
  %129 = getelementptr double, ptr %12, i64 %25
  %130 = getelementptr double, ptr %129, i64 %128
  store double 0.000000e+00, ptr %130, align 8
  %131 = select i1 %121, i64 %15, i64 0
  %132 = getelementptr double, ptr %14, i64 %25
  %133 = getelementptr double, ptr %132, i64 %131
  store double 0.000000e+00, ptr %133, align 8
  br label %28

134:                                              ; preds = %28
  %135 = add nsw i64 %30, -1
  %136 = add i64 %29, 1
  %137 = select i1 %121, i64 %2, i64 0
  %138 = add i64 %25, %137
  %139 = icmp slt i64 %29, 0
  %140 = select i1 %139, i64 %3, i64 0
  %141 = mul i64 %138, %3
  %142 = getelementptr double, ptr %1, i64 %141
  %143 = getelementptr double, ptr %142, i64 %29
  %144 = getelementptr double, ptr %143, i64 %140
  %145 = load double, ptr %144, align 8
  %146 = fmul double %145, %145
  %147 = fadd double %31, %146
  br label %28

148:                                              ; preds = %43
  %149 = add nsw i64 %45, -1
  %150 = add i64 %44, 1
  %151 = select i1 %121, i64 %2, i64 0
  %152 = add i64 %25, %151
  %153 = icmp slt i64 %44, 0
  %154 = select i1 %153, i64 %3, i64 0
  %155 = mul i64 %152, %3
  %156 = getelementptr double, ptr %1, i64 %155
  %157 = getelementptr double, ptr %156, i64 %44
  %158 = getelementptr double, ptr %157, i64 %154
  %159 = load double, ptr %158, align 8
  %160 = load double, ptr %124, align 8
  %161 = fmul double %159, %160
  store double %161, ptr %158, align 8
  br label %43

162:                                              ; preds = %48
  %163 = add nsw i64 %49, -1
  br label %51

164:                                              ; preds = %51
  %165 = add nsw i64 %53, -1
  %166 = add i64 %52, 1
  %167 = icmp slt i64 %52, 0
  %168 = select i1 %167, i64 %11, i64 0
  %169 = getelementptr i64, ptr %10, i64 %52
  %170 = getelementptr i64, ptr %169, i64 %168
  %171 = load i64, ptr %170, align 8
  %172 = icmp eq i64 %171, 1
  br i1 %172, label %57, label %65

173:                                              ; preds = %57
  %174 = add nsw i64 %59, -1
  %175 = add i64 %58, 1
  %176 = select i1 %167, i64 %2, i64 0
  %177 = add i64 %52, %176
  %178 = icmp slt i64 %58, 0
  %179 = select i1 %178, i64 %3, i64 0
  %180 = mul i64 %177, %3
  %181 = getelementptr double, ptr %1, i64 %180
  %182 = getelementptr double, ptr %181, i64 %58
  %183 = getelementptr double, ptr %182, i64 %179
  %184 = load double, ptr %183, align 8
  %185 = fmul double %184, %184
  %186 = fadd double %60, %185
  br label %57

187:                                              ; preds = %80
  %188 = add nsw i64 %82, -1
  %189 = add i64 %81, 1
  %190 = icmp slt i64 %81, 0
  %191 = select i1 %190, i64 %3, i64 0
  %192 = mul i64 %55, %3
  %193 = getelementptr double, ptr %1, i64 %192
  %194 = getelementptr double, ptr %193, i64 %81
  %195 = getelementptr double, ptr %194, i64 %191
  %196 = load double, ptr %195, align 8
  %197 = fdiv double %196, %72
  store double %197, ptr %195, align 8
  %198 = select i1 %190, i64 %5, i64 0
  %199 = getelementptr double, ptr %4, i64 %81
  %200 = getelementptr double, ptr %199, i64 %198
  %201 = load double, ptr %200, align 8
  %202 = fmul double %79, %197
  %203 = fadd double %201, %202
  store double %203, ptr %200, align 8
  br label %80

204:                                              ; preds = %84
  %205 = add nsw i64 %86, -1
  %206 = add i64 %85, 1
  %207 = icmp slt i64 %85, 0
  %208 = select i1 %207, i64 %11, i64 0
  %209 = getelementptr i64, ptr %10, i64 %85
  %210 = getelementptr i64, ptr %209, i64 %208
  %211 = load i64, ptr %210, align 8
  %212 = icmp eq i64 %211, 1
  br i1 %212, label %88, label %104

213:                                              ; preds = %88
  %214 = add nsw i64 %90, -1
  %215 = add i64 %89, 1
  %216 = select i1 %207, i64 %2, i64 0
  %217 = add i64 %85, %216
  %218 = icmp slt i64 %89, 0
  %219 = select i1 %218, i64 %3, i64 0
  %220 = mul i64 %217, %3
  %221 = getelementptr double, ptr %1, i64 %220
  %222 = getelementptr double, ptr %221, i64 %89
  %223 = getelementptr double, ptr %222, i64 %219
  %224 = load double, ptr %223, align 8
  %225 = mul i64 %55, %3
  %226 = getelementptr double, ptr %1, i64 %225
  %227 = getelementptr double, ptr %226, i64 %89
  %228 = getelementptr double, ptr %227, i64 %219
  %229 = load double, ptr %228, align 8
  %230 = fmul double %224, %229
  %231 = fadd double %91, %230
  br label %88

232:                                              ; preds = %100
  %233 = add nsw i64 %102, -1
  %234 = add i64 %101, 1
  %235 = select i1 %207, i64 %2, i64 0
  %236 = add i64 %85, %235
  %237 = icmp slt i64 %101, 0
  %238 = select i1 %237, i64 %3, i64 0
  %239 = mul i64 %236, %3
  %240 = getelementptr double, ptr %1, i64 %239
  %241 = getelementptr double, ptr %240, i64 %101
  %242 = getelementptr double, ptr %241, i64 %238
  %243 = load double, ptr %242, align 8
  %244 = mul i64 %55, %3
  %245 = getelementptr double, ptr %1, i64 %244
  %246 = getelementptr double, ptr %245, i64 %101
  %247 = getelementptr double, ptr %246, i64 %238
  %248 = load double, ptr %247, align 8
  %249 = fmul double %91, %248
  %250 = fsub double %243, %249
  store double %250, ptr %242, align 8
  br label %100

251:                                              ; preds = %106
  %252 = add nsw i64 %108, -1
  %253 = add i64 %107, 1
  %254 = icmp slt i64 %107, 0
  %255 = select i1 %254, i64 %7, i64 0
  %256 = getelementptr double, ptr %6, i64 %107
  %257 = getelementptr double, ptr %256, i64 %255
  %258 = load double, ptr %257, align 8
  %259 = select i1 %254, i64 %9, i64 0
  %260 = getelementptr double, ptr %8, i64 %107
  %261 = getelementptr double, ptr %260, i64 %259
  %262 = load double, ptr %261, align 8
  %263 = fdiv double %258, %262
  store double %263, ptr %257, align 8
  br label %106
}

define internal fastcc i32 @_divide_transposed(ptr noalias %0, ptr %1, i64 %2, i64 %3, ptr %4, i64 %5) unnamed_addr {
  %7 = icmp ugt i64 %2, -9223372036854775808
  %8 = select i1 %7, i64 0, i64 %2
  br label %9

9:                                                ; preds = %6, %19
  %10 = phi i64 [ %2, %6 ], [ %12, %19 ]
  %11 = phi i64 [ %8, %6 ], [ %31, %19 ]
  %12 = add i64 %10, -1
  %13 = icmp sgt i64 %11, 0
  br i1 %13, label %30, label %29

14:                                               ; preds = %30, %39
  %15 = phi i64 [ %10, %30 ], [ %41, %39 ]
  %16 = phi i64 [ %38, %30 ], [ %40, %39 ]
  %17 = phi double [ %36, %30 ], [ %56, %39 ]
  %18 = icmp sgt i64 %16, 0
  br i1 %18, label %39, label %19

19:                                               ; preds = %14
  %20 = select i1 %32, i64 %2, i64 0
  %21 = add i64 %12, %20
  %22 = select i1 %32, i64 %3, i64 0
  %23 = mul i64 %21, %3
  %24 = getelementptr double, ptr %1, i64 %23
  %25 = getelementptr double, ptr %24, i64 %12
  %26 = getelementptr double, ptr %25, i64 %22
  %27 = load double, ptr %26, align 8
  %28 = fdiv double %17, %27
  store double %28, ptr %35, align 8
  br label %9

29:                                               ; preds = %9
  store ptr null, ptr %0, align 8
  ret i32 0

30:                                               ; preds = %9
  %31 = add nsw i64 %11, -1
  %32 = icmp slt i64 %12, 0
  %33 = select i1 %32, i64 %5, i64 0
  %34 = getelementptr double, ptr %4, i64 %12
  %35 = getelementptr double, ptr %34, i64 %33
  %36 = load double, ptr %35, align 8
  %37 = sub i64 %2, %10
  %38 = call i64 @llvm.smax.i64(i64 %37, i64 0)
  br label %14

39:                                               ; preds = %14
  %40 = add nsw i64 %16, -1
  %41 = add i64 %15, 1
  %42 = icmp slt i64 %15, 0
  %43 = select i1 %42, i64 %2, i64 0
  %44 = add i64 %15, %43
  %45 = select i1 %32, i64 %3, i64 0
  %46 = mul i64 %44, %3
  %47 = getelementptr double, ptr %1, i64 %46
  %48 = getelementptr double, ptr %47, i64 %12
  %49 = getelementptr double, ptr %48, i64 %45
  %50 = load double, ptr %49, align 8
  %51 = select i1 %42, i64 %5, i64 0
  %52 = getelementptr double, ptr %4, i64 %15
  %53 = getelementptr double, ptr %52, i64 %51
  %54 = load double, ptr %53, align 8
  %55 = fmul double %50, %54
  %56 = fsub double %17, %55
  br label %14
}

define i64 @project(i64 %0, double %1, i64 %2) local_unnamed_addr #3 {
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
  store ptr null, ptr %6, align 8, !noalias !9
  store ptr null, ptr %7, align 8, !noalias !9
  store ptr null, ptr %8, align 8, !noalias !9
  store ptr null, ptr %9, align 8, !noalias !9
  store ptr null, ptr %10, align 8, !noalias !9
  store ptr null, ptr %11, align 8, !noalias !9
  store ptr null, ptr %12, align 8, !noalias !9
  store ptr null, ptr %13, align 8, !noalias !9
  store ptr null, ptr %14, align 8, !noalias !9
  %15 = inttoptr i64 %0 to ptr
  %16 = getelementptr i8, ptr %15, i64 144
  %17 = load i64, ptr %16, align 8, !noalias !9
  %18 = inttoptr i64 %17 to ptr
  %19 = getelementptr i8, ptr %15, i64 168
  %20 = load i64, ptr %19, align 8, !noalias !9
  %21 = inttoptr i64 %20 to ptr
  %22 = getelementptr i8, ptr %15, i64 192
  %23 = load i64, ptr %22, align 8, !noalias !9
  %24 = getelementptr i8, ptr %15, i64 200
  %25 = load i64, ptr %24, align 8, !noalias !9
  %26 = inttoptr i64 %23 to ptr
  %27 = getelementptr i8, ptr %15, i64 240
  %28 = load i64, ptr %27, align 8, !noalias !9
  %29 = getelementptr i8, ptr %15, i64 248
  %30 = load i64, ptr %29, align 8, !noalias !9
  %31 = getelementptr i8, ptr %15, i64 256
  %32 = load i64, ptr %31, align 8, !noalias !9
  %33 = getelementptr i8, ptr %15, i64 264
  %34 = load i64, ptr %33, align 8, !noalias !9
  %35 = getelementptr i8, ptr %15, i64 272
  %36 = load i64, ptr %35, align 8, !noalias !9
  %37 = getelementptr i8, ptr %15, i64 288
  %38 = load i64, ptr %37, align 8, !noalias !9
  %39 = getelementptr i8, ptr %15, i64 296
  %40 = load i64, ptr %39, align 8, !noalias !9
  %41 = getelementptr i8, ptr %15, i64 304
  %42 = load i64, ptr %41, align 8, !noalias !9
  %43 = getelementptr i8, ptr %15, i64 648
  %44 = load i64, ptr %43, align 8, !noalias !9
  %45 = inttoptr i64 %44 to ptr
  %46 = getelementptr i8, ptr %15, i64 672
  %47 = load i64, ptr %46, align 8, !noalias !9
  %48 = inttoptr i64 %47 to ptr
  %49 = getelementptr i8, ptr %15, i64 696
  %50 = load i64, ptr %49, align 8, !noalias !9
  %51 = getelementptr i8, ptr %15, i64 704
  %52 = load i64, ptr %51, align 8, !noalias !9
  %53 = inttoptr i64 %50 to ptr
  %54 = getelementptr i8, ptr %15, i64 600
  %55 = load i64, ptr %54, align 8, !noalias !9
  %56 = getelementptr i8, ptr %18, i64 8
  %57 = load i64, ptr %56, align 8, !noalias !9
  %58 = inttoptr i64 %2 to ptr
  %59 = getelementptr i8, ptr %45, i64 64
  %60 = load i64, ptr %59, align 8, !noalias !9
  %61 = inttoptr i64 %60 to ptr
  %62 = load i64, ptr %61, align 8, !noalias !9
  %63 = getelementptr i8, ptr %61, i64 8
  %64 = load i64, ptr %63, align 8, !noalias !9
  %65 = getelementptr i8, ptr %61, i64 16
  %66 = load i64, ptr %65, align 8, !noalias !9
  %67 = inttoptr i64 %62 to ptr
  %68 = getelementptr i8, ptr %61, i64 24
  %69 = load i64, ptr %68, align 8, !noalias !9
  %70 = getelementptr i8, ptr %61, i64 32
  %71 = load i64, ptr %70, align 8, !noalias !9
  %72 = getelementptr i8, ptr %61, i64 40
  %73 = load i64, ptr %72, align 8, !noalias !9
  %74 = inttoptr i64 %69 to ptr
  %75 = getelementptr i8, ptr %61, i64 48
  %76 = load i64, ptr %75, align 8, !noalias !9
  %77 = getelementptr i8, ptr %61, i64 56
  %78 = load i64, ptr %77, align 8, !noalias !9
  %79 = getelementptr i8, ptr %61, i64 64
  %80 = load i64, ptr %79, align 8, !noalias !9
  %81 = inttoptr i64 %76 to ptr
  %82 = getelementptr i8, ptr %61, i64 72
  %83 = load i64, ptr %82, align 8, !noalias !9
  %84 = getelementptr i8, ptr %61, i64 80
  %85 = load i64, ptr %84, align 8, !noalias !9
  %86 = getelementptr i8, ptr %61, i64 88
  %87 = load i64, ptr %86, align 8, !noalias !9
  %88 = inttoptr i64 %83 to ptr
  %89 = getelementptr i8, ptr %61, i64 96
  %90 = load i64, ptr %89, align 8, !noalias !9
  %91 = getelementptr i8, ptr %61, i64 104
  %92 = load i64, ptr %91, align 8, !noalias !9
  %93 = getelementptr i8, ptr %61, i64 112
  %94 = load i64, ptr %93, align 8, !noalias !9
  %95 = inttoptr i64 %90 to ptr
  %96 = getelementptr i8, ptr %61, i64 120
  %97 = load i64, ptr %96, align 8, !noalias !9
  %98 = getelementptr i8, ptr %61, i64 128
  %99 = load i64, ptr %98, align 8, !noalias !9
  %100 = inttoptr i64 %97 to ptr
  %101 = getelementptr i8, ptr %61, i64 144
  %102 = load i64, ptr %101, align 8, !noalias !9
  %103 = getelementptr i8, ptr %61, i64 152
  %104 = load i64, ptr %103, align 8, !noalias !9
  %105 = inttoptr i64 %102 to ptr
  %106 = getelementptr i8, ptr %61, i64 168
  %107 = load i64, ptr %106, align 8, !noalias !9
  %108 = getelementptr i8, ptr %61, i64 176
  %109 = load i64, ptr %108, align 8, !noalias !9
  %110 = inttoptr i64 %107 to ptr
  %111 = getelementptr i8, ptr %61, i64 192
  %112 = load i64, ptr %111, align 8, !noalias !9
  %113 = getelementptr i8, ptr %61, i64 200
  %114 = load i64, ptr %113, align 8, !noalias !9
  %115 = inttoptr i64 %112 to ptr
  %116 = getelementptr i8, ptr %61, i64 216
  %117 = load i64, ptr %116, align 8, !noalias !9
  %118 = getelementptr i8, ptr %61, i64 224
  %119 = load i64, ptr %118, align 8, !noalias !9
  %120 = inttoptr i64 %117 to ptr
  %121 = getelementptr i8, ptr %61, i64 240
  %122 = load i64, ptr %121, align 8, !noalias !9
  %123 = getelementptr i8, ptr %61, i64 248
  %124 = load i64, ptr %123, align 8, !noalias !9
  %125 = inttoptr i64 %122 to ptr
  %126 = getelementptr i8, ptr %45, i64 16
  %127 = load i64, ptr %126, align 8, !noalias !9
  %128 = getelementptr i8, ptr %45, i64 24
  %129 = load i64, ptr %128, align 8, !noalias !9
  %130 = getelementptr i8, ptr %45, i64 32
  %131 = load i64, ptr %130, align 8, !noalias !9
  %132 = getelementptr i8, ptr %45, i64 40
  %133 = load i64, ptr %132, align 8, !noalias !9
  %134 = add nsw i64 %127, %129
  %135 = mul nsw i64 %127, %131
  %136 = add nsw i64 %134, %135
  %137 = mul nsw i64 %131, %133
  %138 = add nsw i64 %136, %137
  %139 = mul nsw i64 %129, %133
  %140 = add nsw i64 %138, %139
  %141 = getelementptr i8, ptr %45, i64 48
  %142 = load i64, ptr %141, align 8, !noalias !9
  %143 = mul nsw i64 %142, %133
  %144 = mul nsw i64 %143, %133
  %145 = add nsw i64 %140, %144
  %146 = add nsw i64 %145, %127
  store ptr null, ptr %4, align 8, !noalias !13
  store ptr null, ptr %5, align 8, !noalias !13
  store double %1, ptr %21, align 8, !noalias !13
  %147 = icmp sgt i64 %30, 0
  br i1 %147, label %148, label %154

148:                                              ; preds = %3
  %149 = inttoptr i64 %38 to ptr
  %150 = inttoptr i64 %34 to ptr
  %151 = inttoptr i64 %28 to ptr
  store ptr null, ptr %4, align 8, !noalias !13
  %152 = call fastcc i32 @_sample(ptr nonnull %4, ptr %26, i64 %25, ptr %151, i64 %30, i64 %32, ptr %150, i64 %36, ptr %149, i64 %40, i64 %42, double %1) #3
  switch i32 %152, label %153 [
    i32 -2, label %154
    i32 0, label %154
  ], !prof !17

153:                                              ; preds = %148
  br label %154

154:                                              ; preds = %148, %148, %3, %153
  %155 = phi i32 [ %152, %153 ], [ 0, %3 ], [ 0, %148 ], [ 0, %148 ]
  switch i32 %155, label %416 [
    i32 -2, label %410
    i32 0, label %410
  ], !prof !17

156:                                              ; preds = %160, %410
  %157 = phi i64 [ 0, %410 ], [ %419, %160 ]
  %158 = phi i64 [ %415, %410 ], [ %418, %160 ]
  %159 = icmp sgt i64 %158, 0
  br i1 %159, label %417, label %164

160:                                              ; preds = %417, %420
  %161 = phi i64 [ 0, %417 ], [ %422, %420 ]
  %162 = phi i64 [ %415, %417 ], [ %421, %420 ]
  %163 = icmp sgt i64 %162, 0
  br i1 %163, label %420, label %156

164:                                              ; preds = %156, %294
  %165 = phi i64 [ %436, %294 ], [ 0, %156 ]
  %166 = phi i64 [ %435, %294 ], [ 10, %156 ]
  %167 = phi double [ %175, %294 ], [ 0x7FF0000000000000, %156 ]
  %168 = icmp sgt i64 %166, 0
  br i1 %168, label %434, label %295

169:                                              ; preds = %434
  br label %733

170:                                              ; preds = %434
  %171 = call i64 @llvm.smax.i64(i64 %127, i64 0)
  br label %172

172:                                              ; preds = %189, %170
  %173 = phi i64 [ 0, %170 ], [ %445, %189 ]
  %174 = phi i64 [ %171, %170 ], [ %444, %189 ]
  %175 = phi double [ 0.000000e+00, %170 ], [ %190, %189 ]
  %176 = icmp sgt i64 %174, 0
  br i1 %176, label %443, label %193

177:                                              ; preds = %443
  %178 = call double @llvm.fabs.f64(double %450)
  %179 = add nsw i64 %145, %173
  %180 = icmp slt i64 %179, 0
  %181 = select i1 %180, i64 %52, i64 0
  %182 = getelementptr double, ptr %53, i64 %179
  %183 = getelementptr double, ptr %182, i64 %181
  %184 = load double, ptr %183, align 8, !noalias !9
  %185 = fmul double %184, 0x3CB0000000000000
  %186 = fdiv double %178, %185
  %187 = fcmp ogt double %186, %175
  %188 = select i1 %187, double %186, double %175
  br label %189

189:                                              ; preds = %177, %443
  %190 = phi double [ %175, %443 ], [ %188, %177 ]
  %191 = fcmp uno double %450, 0.000000e+00
  br i1 %191, label %192, label %172

192:                                              ; preds = %189
  br label %733

193:                                              ; preds = %172
  %194 = fcmp ugt double %175, 1.000000e+00
  br i1 %194, label %195, label %295

195:                                              ; preds = %193
  %196 = fmul double %167, 5.000000e-01
  %197 = fcmp oge double %175, %196
  %198 = fcmp ole double %175, 8.000000e+00
  %199 = and i1 %197, %198
  br i1 %199, label %295, label %200

200:                                              ; preds = %195
  br i1 %437, label %201, label %202

201:                                              ; preds = %200
  br label %733

202:                                              ; preds = %200
  %203 = load i64, ptr %141, align 8, !noalias !9
  %204 = icmp eq i64 %203, 1
  br i1 %204, label %205, label %239

205:                                              ; preds = %202
  %206 = call i64 @llvm.smax.i64(i64 %64, i64 0)
  br label %207

207:                                              ; preds = %211, %205
  %208 = phi i64 [ 0, %205 ], [ %217, %211 ]
  %209 = phi i64 [ %206, %205 ], [ %216, %211 ]
  %210 = icmp sgt i64 %209, 0
  br i1 %210, label %215, label %452

211:                                              ; preds = %219, %215
  %212 = phi i64 [ 0, %215 ], [ %221, %219 ]
  %213 = phi i64 [ %218, %215 ], [ %220, %219 ]
  %214 = icmp sgt i64 %213, 0
  br i1 %214, label %219, label %207

215:                                              ; preds = %207
  %216 = add nsw i64 %209, -1
  %217 = add i64 %208, 1
  %218 = call i64 @llvm.smax.i64(i64 %66, i64 0)
  br label %211

219:                                              ; preds = %211
  %220 = add nsw i64 %213, -1
  %221 = add i64 %212, 1
  %222 = mul nsw i64 %208, %66
  %223 = add nsw i64 %140, %222
  %224 = add nsw i64 %223, %212
  %225 = icmp slt i64 %224, 0
  %226 = select i1 %225, i64 %52, i64 0
  %227 = getelementptr double, ptr %53, i64 %224
  %228 = getelementptr double, ptr %227, i64 %226
  %229 = load double, ptr %228, align 8, !noalias !18
  %230 = icmp slt i64 %208, 0
  %231 = select i1 %230, i64 %64, i64 0
  %232 = add i64 %208, %231
  %233 = icmp slt i64 %212, 0
  %234 = select i1 %233, i64 %66, i64 0
  %235 = mul i64 %232, %66
  %236 = getelementptr double, ptr %67, i64 %235
  %237 = getelementptr double, ptr %236, i64 %212
  %238 = getelementptr double, ptr %237, i64 %234
  store double %229, ptr %238, align 8, !noalias !18
  br label %211

239:                                              ; preds = %452, %452, %202
  %240 = call i64 @llvm.smax.i64(i64 %71, i64 0)
  br label %241

241:                                              ; preds = %245, %239
  %242 = phi i64 [ 0, %239 ], [ %251, %245 ]
  %243 = phi i64 [ %240, %239 ], [ %250, %245 ]
  %244 = icmp sgt i64 %243, 0
  br i1 %244, label %249, label %455

245:                                              ; preds = %253, %249
  %246 = phi i64 [ 0, %249 ], [ %255, %253 ]
  %247 = phi i64 [ %252, %249 ], [ %254, %253 ]
  %248 = icmp sgt i64 %247, 0
  br i1 %248, label %253, label %241

249:                                              ; preds = %241
  %250 = add nsw i64 %243, -1
  %251 = add i64 %242, 1
  %252 = call i64 @llvm.smax.i64(i64 %73, i64 0)
  br label %245

253:                                              ; preds = %245
  %254 = add nsw i64 %247, -1
  %255 = add i64 %246, 1
  %256 = mul nsw i64 %242, %73
  %257 = add nsw i64 %136, %256
  %258 = add nsw i64 %257, %246
  %259 = icmp slt i64 %258, 0
  %260 = select i1 %259, i64 %52, i64 0
  %261 = getelementptr double, ptr %53, i64 %258
  %262 = getelementptr double, ptr %261, i64 %260
  %263 = load double, ptr %262, align 8, !noalias !21
  %264 = icmp slt i64 %242, 0
  %265 = select i1 %264, i64 %71, i64 0
  %266 = add i64 %242, %265
  %267 = icmp slt i64 %246, 0
  %268 = select i1 %267, i64 %73, i64 0
  %269 = mul i64 %266, %73
  %270 = getelementptr double, ptr %74, i64 %269
  %271 = getelementptr double, ptr %270, i64 %246
  %272 = getelementptr double, ptr %271, i64 %268
  store double %263, ptr %272, align 8, !noalias !21
  br label %245

273:                                              ; preds = %277, %581
  %274 = phi i64 [ 0, %581 ], [ %586, %277 ]
  %275 = phi i64 [ %582, %581 ], [ %585, %277 ]
  %276 = icmp sgt i64 %275, 0
  br i1 %276, label %584, label %281

277:                                              ; preds = %584, %587
  %278 = phi i64 [ 0, %584 ], [ %589, %587 ]
  %279 = phi i64 [ %415, %584 ], [ %588, %587 ]
  %280 = icmp sgt i64 %279, 0
  br i1 %280, label %587, label %273

281:                                              ; preds = %273, %610
  %282 = phi i64 [ %619, %610 ], [ 0, %273 ]
  %283 = phi i64 [ %620, %610 ], [ %171, %273 ]
  %284 = phi double [ %618, %610 ], [ 0.000000e+00, %273 ]
  %285 = icmp sgt i64 %283, 0
  br i1 %285, label %610, label %286

286:                                              ; preds = %281
  %287 = fcmp ogt double %284, 0.000000e+00
  br i1 %287, label %288, label %294

288:                                              ; preds = %286
  store ptr null, ptr %10, align 8, !noalias !9
  %289 = call fastcc i32 @_minimum_norm(ptr nonnull %10, ptr %81, i64 %78, i64 %80, ptr %100, i64 %99, ptr %105, i64 %104, ptr %110, i64 %109, ptr %115, i64 %114, ptr %120, i64 %119, ptr %125, i64 %124) #3
  switch i32 %289, label %622 [
    i32 -2, label %621
    i32 0, label %621
  ], !prof !17

290:                                              ; preds = %621, %623
  %291 = phi i64 [ 0, %621 ], [ %625, %623 ]
  %292 = phi i64 [ %582, %621 ], [ %624, %623 ]
  %293 = icmp sgt i64 %292, 0
  br i1 %293, label %623, label %294

294:                                              ; preds = %290, %286
  br label %164

295:                                              ; preds = %164, %193, %195
  %296 = icmp sgt i64 %129, 0
  br i1 %296, label %297, label %409

297:                                              ; preds = %295
  %298 = load i64, ptr %141, align 8, !noalias !9
  %299 = icmp eq i64 %298, 1
  br i1 %299, label %300, label %334

300:                                              ; preds = %297
  %301 = call i64 @llvm.smax.i64(i64 %64, i64 0)
  br label %302

302:                                              ; preds = %306, %300
  %303 = phi i64 [ 0, %300 ], [ %312, %306 ]
  %304 = phi i64 [ %301, %300 ], [ %311, %306 ]
  %305 = icmp sgt i64 %304, 0
  br i1 %305, label %310, label %636

306:                                              ; preds = %314, %310
  %307 = phi i64 [ 0, %310 ], [ %316, %314 ]
  %308 = phi i64 [ %313, %310 ], [ %315, %314 ]
  %309 = icmp sgt i64 %308, 0
  br i1 %309, label %314, label %302

310:                                              ; preds = %302
  %311 = add nsw i64 %304, -1
  %312 = add i64 %303, 1
  %313 = call i64 @llvm.smax.i64(i64 %66, i64 0)
  br label %306

314:                                              ; preds = %306
  %315 = add nsw i64 %308, -1
  %316 = add i64 %307, 1
  %317 = mul nsw i64 %303, %66
  %318 = add nsw i64 %140, %317
  %319 = add nsw i64 %318, %307
  %320 = icmp slt i64 %319, 0
  %321 = select i1 %320, i64 %52, i64 0
  %322 = getelementptr double, ptr %53, i64 %319
  %323 = getelementptr double, ptr %322, i64 %321
  %324 = load double, ptr %323, align 8, !noalias !24
  %325 = icmp slt i64 %303, 0
  %326 = select i1 %325, i64 %64, i64 0
  %327 = add i64 %303, %326
  %328 = icmp slt i64 %307, 0
  %329 = select i1 %328, i64 %66, i64 0
  %330 = mul i64 %327, %66
  %331 = getelementptr double, ptr %67, i64 %330
  %332 = getelementptr double, ptr %331, i64 %307
  %333 = getelementptr double, ptr %332, i64 %329
  store double %324, ptr %333, align 8, !noalias !24
  br label %306

334:                                              ; preds = %636, %636, %297
  %335 = call i64 @llvm.smax.i64(i64 %92, i64 0)
  br label %336

336:                                              ; preds = %340, %334
  %337 = phi i64 [ 0, %334 ], [ %346, %340 ]
  %338 = phi i64 [ %335, %334 ], [ %345, %340 ]
  %339 = icmp sgt i64 %338, 0
  br i1 %339, label %344, label %639

340:                                              ; preds = %348, %344
  %341 = phi i64 [ 0, %344 ], [ %350, %348 ]
  %342 = phi i64 [ %347, %344 ], [ %349, %348 ]
  %343 = icmp sgt i64 %342, 0
  br i1 %343, label %348, label %336

344:                                              ; preds = %336
  %345 = add nsw i64 %338, -1
  %346 = add i64 %337, 1
  %347 = call i64 @llvm.smax.i64(i64 %94, i64 0)
  br label %340

348:                                              ; preds = %340
  %349 = add nsw i64 %342, -1
  %350 = add i64 %341, 1
  %351 = mul nsw i64 %337, %94
  %352 = add nsw i64 %138, %351
  %353 = add nsw i64 %352, %341
  %354 = icmp slt i64 %353, 0
  %355 = select i1 %354, i64 %52, i64 0
  %356 = getelementptr double, ptr %53, i64 %353
  %357 = getelementptr double, ptr %356, i64 %355
  %358 = load double, ptr %357, align 8, !noalias !27
  %359 = icmp slt i64 %337, 0
  %360 = select i1 %359, i64 %92, i64 0
  %361 = add i64 %337, %360
  %362 = icmp slt i64 %341, 0
  %363 = select i1 %362, i64 %94, i64 0
  %364 = mul i64 %361, %94
  %365 = getelementptr double, ptr %95, i64 %364
  %366 = getelementptr double, ptr %365, i64 %341
  %367 = getelementptr double, ptr %366, i64 %363
  store double %358, ptr %367, align 8, !noalias !27
  br label %340

368:                                              ; preds = %666, %668
  %369 = phi i64 [ 0, %666 ], [ %670, %668 ]
  %370 = phi i64 [ %415, %666 ], [ %669, %668 ]
  %371 = icmp sgt i64 %370, 0
  br i1 %371, label %668, label %683

372:                                              ; preds = %693, %383
  %373 = phi i64 [ 0, %693 ], [ %701, %383 ]
  %374 = phi i64 [ %129, %693 ], [ %700, %383 ]
  %375 = phi i64 [ 0, %693 ], [ %384, %383 ]
  %376 = phi double [ 1.000000e+00, %693 ], [ %385, %383 ]
  %377 = icmp sgt i64 %374, 0
  br i1 %377, label %699, label %386

378:                                              ; preds = %699
  %379 = add nsw i64 %375, 1
  %380 = fdiv double %718, %714
  %381 = fcmp olt double %380, %376
  %382 = select i1 %381, double %380, double %376
  br label %383

383:                                              ; preds = %378, %699
  %384 = phi i64 [ %375, %699 ], [ %379, %378 ]
  %385 = phi double [ %376, %699 ], [ %382, %378 ]
  br label %372

386:                                              ; preds = %372
  %387 = load double, ptr %697, align 8, !noalias !9
  %388 = sitofp i64 %375 to double
  %389 = fcmp olt double %387, %388
  br i1 %389, label %390, label %392

390:                                              ; preds = %386
  store double %388, ptr %697, align 8, !noalias !9
  %391 = getelementptr i8, ptr %697, i64 8
  store double 1.000000e+00, ptr %391, align 8, !noalias !9
  br label %395

392:                                              ; preds = %386
  %393 = fcmp ogt double %387, %388
  br i1 %393, label %394, label %395

394:                                              ; preds = %392
  br label %395

395:                                              ; preds = %394, %392, %390
  %396 = phi double [ %376, %390 ], [ 0.000000e+00, %394 ], [ %376, %392 ]
  %397 = getelementptr i8, ptr %697, i64 8
  %398 = load double, ptr %397, align 8, !noalias !9
  %399 = fcmp olt double %396, %398
  %400 = fcmp ogt double %398, 1.000000e-05
  %401 = and i1 %399, %400
  br i1 %401, label %402, label %409

402:                                              ; preds = %395
  store double %396, ptr %397, align 8, !noalias !9
  %403 = getelementptr i8, ptr %697, i64 16
  store double %1, ptr %403, align 8, !noalias !9
  %404 = call i64 @llvm.smax.i64(i64 %57, i64 0)
  br label %405

405:                                              ; preds = %402, %720
  %406 = phi i64 [ 0, %402 ], [ %722, %720 ]
  %407 = phi i64 [ %404, %402 ], [ %721, %720 ]
  %408 = icmp sgt i64 %407, 0
  br i1 %408, label %720, label %409

409:                                              ; preds = %405, %395, %295
  br label %733

410:                                              ; preds = %154, %154
  %411 = inttoptr i64 %55 to ptr
  %412 = getelementptr i8, ptr %411, i64 88
  %413 = load i64, ptr %412, align 8, !noalias !9
  %414 = add nsw i64 %413, 1
  store i64 %414, ptr %412, align 8, !noalias !9
  %415 = call i64 @llvm.smax.i64(i64 %133, i64 0)
  br label %156

416:                                              ; preds = %154
  br label %733

417:                                              ; preds = %156
  %418 = add nsw i64 %158, -1
  %419 = add i64 %157, 1
  br label %160

420:                                              ; preds = %160
  %421 = add nsw i64 %162, -1
  %422 = add i64 %161, 1
  %423 = icmp eq i64 %157, %161
  %424 = select i1 %423, double 1.000000e+00, double 0.000000e+00
  %425 = icmp slt i64 %157, 0
  %426 = select i1 %425, i64 %64, i64 0
  %427 = add i64 %157, %426
  %428 = icmp slt i64 %161, 0
  %429 = select i1 %428, i64 %66, i64 0
  %430 = mul i64 %427, %66
  %431 = getelementptr double, ptr %67, i64 %430
  %432 = getelementptr double, ptr %431, i64 %161
  %433 = getelementptr double, ptr %432, i64 %429
  store double %424, ptr %433, align 8, !noalias !9
  br label %160

434:                                              ; preds = %164
  %435 = add nsw i64 %166, -1
  %436 = add i64 %165, 1
  %437 = icmp eq i64 %165, 9
  %438 = getelementptr i8, ptr %45, i64 8
  %439 = load i64, ptr %438, align 8, !noalias !9
  %440 = inttoptr i64 %439 to ptr
  %441 = call i32 %440(ptr nonnull %21, ptr %58, ptr %26, ptr %48, ptr %53) #3, !noalias !9
  %442 = icmp slt i32 %441, 0
  br i1 %442, label %169, label %170

443:                                              ; preds = %172
  %444 = add nsw i64 %174, -1
  %445 = add i64 %173, 1
  %446 = icmp slt i64 %173, 0
  %447 = select i1 %446, i64 %52, i64 0
  %448 = getelementptr double, ptr %53, i64 %173
  %449 = getelementptr double, ptr %448, i64 %447
  %450 = load double, ptr %449, align 8, !noalias !9
  %451 = fcmp une double %450, 0.000000e+00
  br i1 %451, label %177, label %189

452:                                              ; preds = %207
  store ptr null, ptr %6, align 8, !noalias !9
  %453 = call fastcc i32 @_factor(ptr nonnull %6, ptr %67, i64 %64, i64 %66) #3
  switch i32 %453, label %454 [
    i32 -2, label %239
    i32 0, label %239
  ], !prof !17

454:                                              ; preds = %452
  br label %733

455:                                              ; preds = %241
  %456 = call i64 @llvm.smax.i64(i64 %78, i64 0)
  br label %457

457:                                              ; preds = %461, %455
  %458 = phi i64 [ 0, %455 ], [ %467, %461 ]
  %459 = phi i64 [ %456, %455 ], [ %466, %461 ]
  %460 = icmp sgt i64 %459, 0
  br i1 %460, label %465, label %489

461:                                              ; preds = %469, %465
  %462 = phi i64 [ 0, %465 ], [ %471, %469 ]
  %463 = phi i64 [ %468, %465 ], [ %470, %469 ]
  %464 = icmp sgt i64 %463, 0
  br i1 %464, label %469, label %457

465:                                              ; preds = %457
  %466 = add nsw i64 %459, -1
  %467 = add i64 %458, 1
  %468 = call i64 @llvm.smax.i64(i64 %80, i64 0)
  br label %461

469:                                              ; preds = %461
  %470 = add nsw i64 %463, -1
  %471 = add i64 %462, 1
  %472 = mul nsw i64 %458, %80
  %473 = add nsw i64 %134, %472
  %474 = add nsw i64 %473, %462
  %475 = icmp slt i64 %474, 0
  %476 = select i1 %475, i64 %52, i64 0
  %477 = getelementptr double, ptr %53, i64 %474
  %478 = getelementptr double, ptr %477, i64 %476
  %479 = load double, ptr %478, align 8, !noalias !30
  %480 = icmp slt i64 %458, 0
  %481 = select i1 %480, i64 %78, i64 0
  %482 = add i64 %458, %481
  %483 = icmp slt i64 %462, 0
  %484 = select i1 %483, i64 %80, i64 0
  %485 = mul i64 %482, %80
  %486 = getelementptr double, ptr %81, i64 %485
  %487 = getelementptr double, ptr %486, i64 %462
  %488 = getelementptr double, ptr %487, i64 %484
  store double %479, ptr %488, align 8, !noalias !30
  br label %461

489:                                              ; preds = %457
  %490 = call i64 @llvm.smax.i64(i64 %85, i64 0)
  br label %491

491:                                              ; preds = %495, %489
  %492 = phi i64 [ 0, %489 ], [ %516, %495 ]
  %493 = phi i64 [ %490, %489 ], [ %515, %495 ]
  %494 = icmp sgt i64 %493, 0
  br i1 %494, label %514, label %555

495:                                              ; preds = %514, %513
  %496 = phi i64 [ 0, %514 ], [ %520, %513 ]
  %497 = phi i64 [ %517, %514 ], [ %519, %513 ]
  %498 = icmp sgt i64 %497, 0
  br i1 %498, label %518, label %491

499:                                              ; preds = %530, %518
  %500 = phi i64 [ 0, %518 ], [ %532, %530 ]
  %501 = phi i64 [ %240, %518 ], [ %531, %530 ]
  %502 = phi double [ 0.000000e+00, %518 ], [ %554, %530 ]
  %503 = icmp sgt i64 %501, 0
  br i1 %503, label %530, label %504

504:                                              ; preds = %499
  %505 = load double, ptr %529, align 8, !noalias !33
  %506 = call double @llvm.fabs.f64(double %505)
  %507 = sitofp i64 %71 to double
  %508 = fmul double %507, 4.000000e+00
  %509 = fmul double %508, 0x3CB0000000000000
  %510 = fmul double %509, %502
  %511 = fcmp ugt double %506, %510
  br i1 %511, label %513, label %512

512:                                              ; preds = %504
  store double 0.000000e+00, ptr %529, align 8, !noalias !33
  br label %513

513:                                              ; preds = %512, %504
  br label %495

514:                                              ; preds = %491
  %515 = add nsw i64 %493, -1
  %516 = add i64 %492, 1
  %517 = call i64 @llvm.smax.i64(i64 %73, i64 0)
  br label %495

518:                                              ; preds = %495
  %519 = add nsw i64 %497, -1
  %520 = add i64 %496, 1
  %521 = icmp slt i64 %492, 0
  %522 = select i1 %521, i64 %85, i64 0
  %523 = add i64 %492, %522
  %524 = icmp slt i64 %496, 0
  %525 = select i1 %524, i64 %87, i64 0
  %526 = mul i64 %523, %87
  %527 = getelementptr double, ptr %88, i64 %526
  %528 = getelementptr double, ptr %527, i64 %496
  %529 = getelementptr double, ptr %528, i64 %525
  store double 0.000000e+00, ptr %529, align 8, !noalias !33
  br label %499

530:                                              ; preds = %499
  %531 = add nsw i64 %501, -1
  %532 = add i64 %500, 1
  %533 = select i1 %521, i64 %78, i64 0
  %534 = add i64 %492, %533
  %535 = icmp slt i64 %500, 0
  %536 = select i1 %535, i64 %80, i64 0
  %537 = mul i64 %534, %80
  %538 = getelementptr double, ptr %81, i64 %537
  %539 = getelementptr double, ptr %538, i64 %500
  %540 = getelementptr double, ptr %539, i64 %536
  %541 = load double, ptr %540, align 8, !noalias !33
  %542 = select i1 %535, i64 %71, i64 0
  %543 = add i64 %500, %542
  %544 = select i1 %524, i64 %73, i64 0
  %545 = mul i64 %543, %73
  %546 = getelementptr double, ptr %74, i64 %545
  %547 = getelementptr double, ptr %546, i64 %496
  %548 = getelementptr double, ptr %547, i64 %544
  %549 = load double, ptr %548, align 8, !noalias !33
  %550 = fmul double %541, %549
  %551 = load double, ptr %529, align 8, !noalias !33
  %552 = fadd double %551, %550
  store double %552, ptr %529, align 8, !noalias !33
  %553 = call double @llvm.fabs.f64(double %550)
  %554 = fadd double %502, %553
  br label %499

555:                                              ; preds = %491
  store ptr null, ptr %7, align 8, !noalias !9
  %556 = call fastcc i32 @_divide_rows(ptr nonnull %7, ptr %88, i64 %85, i64 %87, ptr %67, i64 %64, i64 %66) #3
  switch i32 %556, label %575 [
    i32 -2, label %557
    i32 0, label %557
  ], !prof !17

557:                                              ; preds = %555, %555
  %558 = call i64 @llvm.smax.i64(i64 %127, i64 0)
  br label %559

559:                                              ; preds = %563, %557
  %560 = phi i64 [ 0, %557 ], [ %565, %563 ]
  %561 = phi i64 [ %558, %557 ], [ %564, %563 ]
  %562 = icmp sgt i64 %561, 0
  br i1 %562, label %563, label %576

563:                                              ; preds = %559
  %564 = add nsw i64 %561, -1
  %565 = add i64 %560, 1
  %566 = icmp slt i64 %560, 0
  %567 = select i1 %566, i64 %52, i64 0
  %568 = getelementptr double, ptr %53, i64 %560
  %569 = getelementptr double, ptr %568, i64 %567
  %570 = load double, ptr %569, align 8, !noalias !36
  %571 = fneg double %570
  %572 = select i1 %566, i64 %104, i64 0
  %573 = getelementptr double, ptr %105, i64 %560
  %574 = getelementptr double, ptr %573, i64 %572
  store double %571, ptr %574, align 8, !noalias !36
  br label %559

575:                                              ; preds = %555
  br label %733

576:                                              ; preds = %559
  store ptr null, ptr %8, align 8, !noalias !9
  %577 = call fastcc i32 @_minimum_norm(ptr nonnull %8, ptr %88, i64 %85, i64 %87, ptr %100, i64 %99, ptr %105, i64 %104, ptr %110, i64 %109, ptr %115, i64 %114, ptr %120, i64 %119, ptr %125, i64 %124) #3
  switch i32 %577, label %580 [
    i32 -2, label %578
    i32 0, label %578
  ], !prof !17

578:                                              ; preds = %576, %576
  store ptr null, ptr %9, align 8, !noalias !9
  %579 = call fastcc i32 @_divide_transposed(ptr nonnull %9, ptr %67, i64 %64, i64 %66, ptr %100, i64 %99) #3
  switch i32 %579, label %583 [
    i32 -2, label %581
    i32 0, label %581
  ], !prof !17

580:                                              ; preds = %576
  br label %733

581:                                              ; preds = %578, %578
  %582 = call i64 @llvm.smax.i64(i64 %131, i64 0)
  br label %273

583:                                              ; preds = %578
  br label %733

584:                                              ; preds = %273
  %585 = add nsw i64 %275, -1
  %586 = add i64 %274, 1
  br label %277

587:                                              ; preds = %277
  %588 = add nsw i64 %279, -1
  %589 = add i64 %278, 1
  %590 = icmp slt i64 %274, 0
  %591 = select i1 %590, i64 %57, i64 0
  %592 = getelementptr double, ptr %58, i64 %274
  %593 = getelementptr double, ptr %592, i64 %591
  %594 = load double, ptr %593, align 8, !noalias !9
  %595 = select i1 %590, i64 %71, i64 0
  %596 = add i64 %274, %595
  %597 = icmp slt i64 %278, 0
  %598 = select i1 %597, i64 %73, i64 0
  %599 = mul i64 %596, %73
  %600 = getelementptr double, ptr %74, i64 %599
  %601 = getelementptr double, ptr %600, i64 %278
  %602 = getelementptr double, ptr %601, i64 %598
  %603 = load double, ptr %602, align 8, !noalias !9
  %604 = select i1 %597, i64 %99, i64 0
  %605 = getelementptr double, ptr %100, i64 %278
  %606 = getelementptr double, ptr %605, i64 %604
  %607 = load double, ptr %606, align 8, !noalias !9
  %608 = fmul double %603, %607
  %609 = fadd double %594, %608
  store double %609, ptr %593, align 8, !noalias !9
  br label %277

610:                                              ; preds = %281
  %611 = icmp slt i64 %282, 0
  %612 = select i1 %611, i64 %104, i64 0
  %613 = getelementptr double, ptr %105, i64 %282
  %614 = getelementptr double, ptr %613, i64 %612
  %615 = load double, ptr %614, align 8, !noalias !9
  %616 = call double @llvm.fabs.f64(double %615)
  %617 = fcmp ogt double %616, %284
  %618 = select i1 %617, double %616, double %284
  %619 = add i64 %282, 1
  %620 = add nsw i64 %283, -1
  br label %281

621:                                              ; preds = %288, %288
  br label %290

622:                                              ; preds = %288
  br label %733

623:                                              ; preds = %290
  %624 = add nsw i64 %292, -1
  %625 = add i64 %291, 1
  %626 = icmp slt i64 %291, 0
  %627 = select i1 %626, i64 %57, i64 0
  %628 = getelementptr double, ptr %58, i64 %291
  %629 = getelementptr double, ptr %628, i64 %627
  %630 = load double, ptr %629, align 8, !noalias !9
  %631 = select i1 %626, i64 %99, i64 0
  %632 = getelementptr double, ptr %100, i64 %291
  %633 = getelementptr double, ptr %632, i64 %631
  %634 = load double, ptr %633, align 8, !noalias !9
  %635 = fadd double %630, %634
  store double %635, ptr %629, align 8, !noalias !9
  br label %290

636:                                              ; preds = %302
  store ptr null, ptr %11, align 8, !noalias !9
  %637 = call fastcc i32 @_factor(ptr nonnull %11, ptr %67, i64 %64, i64 %66) #3
  switch i32 %637, label %638 [
    i32 -2, label %334
    i32 0, label %334
  ], !prof !17

638:                                              ; preds = %636
  br label %733

639:                                              ; preds = %336
  store ptr null, ptr %12, align 8, !noalias !9
  %640 = call fastcc i32 @_divide_rows(ptr nonnull %12, ptr %95, i64 %92, i64 %94, ptr %67, i64 %64, i64 %66) #3
  switch i32 %640, label %660 [
    i32 -2, label %641
    i32 0, label %641
  ], !prof !17

641:                                              ; preds = %639, %639
  br label %642

642:                                              ; preds = %646, %641
  %643 = phi i64 [ 0, %641 ], [ %648, %646 ]
  %644 = phi i64 [ %129, %641 ], [ %647, %646 ]
  %645 = icmp sgt i64 %644, 0
  br i1 %645, label %646, label %661

646:                                              ; preds = %642
  %647 = add nsw i64 %644, -1
  %648 = add i64 %643, 1
  %649 = add nsw i64 %127, %643
  %650 = icmp slt i64 %649, 0
  %651 = select i1 %650, i64 %52, i64 0
  %652 = getelementptr double, ptr %53, i64 %649
  %653 = getelementptr double, ptr %652, i64 %651
  %654 = load double, ptr %653, align 8, !noalias !39
  %655 = fneg double %654
  %656 = icmp slt i64 %643, 0
  %657 = select i1 %656, i64 %104, i64 0
  %658 = getelementptr double, ptr %105, i64 %643
  %659 = getelementptr double, ptr %658, i64 %657
  store double %655, ptr %659, align 8, !noalias !39
  br label %642

660:                                              ; preds = %639
  br label %733

661:                                              ; preds = %642
  store ptr null, ptr %13, align 8, !noalias !9
  %662 = call fastcc i32 @_minimum_norm(ptr nonnull %13, ptr %95, i64 %92, i64 %94, ptr %100, i64 %99, ptr %105, i64 %104, ptr %110, i64 %109, ptr %115, i64 %114, ptr %120, i64 %119, ptr %125, i64 %124) #3
  switch i32 %662, label %665 [
    i32 -2, label %663
    i32 0, label %663
  ], !prof !17

663:                                              ; preds = %661, %661
  store ptr null, ptr %14, align 8, !noalias !9
  %664 = call fastcc i32 @_divide_transposed(ptr nonnull %14, ptr %67, i64 %64, i64 %66, ptr %100, i64 %99) #3
  switch i32 %664, label %667 [
    i32 -2, label %666
    i32 0, label %666
  ], !prof !17

665:                                              ; preds = %661
  br label %733

666:                                              ; preds = %663, %663
  br label %368

667:                                              ; preds = %663
  br label %733

668:                                              ; preds = %368
  %669 = add nsw i64 %370, -1
  %670 = add i64 %369, 1
  %671 = add nsw i64 %131, %369
  %672 = icmp slt i64 %671, 0
  %673 = select i1 %672, i64 %57, i64 0
  %674 = getelementptr double, ptr %58, i64 %671
  %675 = getelementptr double, ptr %674, i64 %673
  %676 = load double, ptr %675, align 8, !noalias !9
  %677 = icmp slt i64 %369, 0
  %678 = select i1 %677, i64 %99, i64 0
  %679 = getelementptr double, ptr %100, i64 %369
  %680 = getelementptr double, ptr %679, i64 %678
  %681 = load double, ptr %680, align 8, !noalias !9
  %682 = fadd double %676, %681
  store double %682, ptr %675, align 8, !noalias !9
  br label %368

683:                                              ; preds = %368
  %684 = icmp slt i64 %146, 0
  %685 = select i1 %684, i64 %52, i64 0
  %686 = add i64 %146, %685
  %687 = icmp slt i64 %686, 0
  br i1 %687, label %688, label %689, !prof !4

688:                                              ; preds = %683
  br label %689

689:                                              ; preds = %688, %683
  %690 = phi i64 [ 0, %688 ], [ %686, %683 ]
  %691 = icmp slt i64 %686, %52
  br i1 %691, label %693, label %692, !prof !8

692:                                              ; preds = %689
  br label %693

693:                                              ; preds = %692, %689
  %694 = phi i64 [ %52, %692 ], [ %690, %689 ]
  %695 = sub i64 %52, %694
  %696 = call i64 @llvm.smax.i64(i64 %695, i64 0)
  %697 = getelementptr double, ptr %53, i64 %694
  %698 = add nsw i64 %57, 3
  br label %372

699:                                              ; preds = %372
  %700 = add nsw i64 %374, -1
  %701 = add i64 %373, 1
  %702 = add nsw i64 %698, %373
  %703 = icmp slt i64 %702, 0
  %704 = select i1 %703, i64 %696, i64 0
  %705 = getelementptr double, ptr %697, i64 %702
  %706 = getelementptr double, ptr %705, i64 %704
  %707 = load double, ptr %706, align 8, !noalias !9
  %708 = icmp slt i64 %373, 0
  %709 = select i1 %708, i64 %119, i64 0
  %710 = getelementptr double, ptr %120, i64 %373
  %711 = getelementptr double, ptr %710, i64 %709
  %712 = load double, ptr %711, align 8, !noalias !9
  %713 = fcmp ogt double %712, %707
  %714 = select i1 %713, double %712, double %707
  store double %714, ptr %706, align 8, !noalias !9
  %715 = select i1 %708, i64 %124, i64 0
  %716 = getelementptr double, ptr %125, i64 %373
  %717 = getelementptr double, ptr %716, i64 %715
  %718 = load double, ptr %717, align 8, !noalias !9
  %719 = fcmp ogt double %718, 0.000000e+00
  br i1 %719, label %378, label %383

720:                                              ; preds = %405
  %721 = add nsw i64 %407, -1
  %722 = add i64 %406, 1
  %723 = icmp slt i64 %406, 0
  %724 = select i1 %723, i64 %57, i64 0
  %725 = getelementptr double, ptr %58, i64 %406
  %726 = getelementptr double, ptr %725, i64 %724
  %727 = load double, ptr %726, align 8, !noalias !9
  %728 = icmp slt i64 %406, -3
  %729 = select i1 %728, i64 %696, i64 0
  %730 = getelementptr double, ptr %697, i64 %406
  %731 = getelementptr i8, ptr %730, i64 24
  %732 = getelementptr double, ptr %731, i64 %729
  store double %727, ptr %732, align 8, !noalias !9
  br label %405

733:                                              ; preds = %667, %665, %660, %638, %622, %583, %580, %575, %454, %416, %409, %201, %192, %169
  %734 = phi i64 [ 0, %416 ], [ 0, %580 ], [ 0, %622 ], [ 6, %201 ], [ 6, %169 ], [ 0, %583 ], [ 0, %454 ], [ 6, %192 ], [ 0, %667 ], [ 0, %638 ], [ 0, %409 ], [ 0, %660 ], [ 0, %575 ], [ 0, %665 ]
  ret i64 %734
}



declare i64 @llvm.smax.i64(i64, i64) #0

attributes #0 = { nounwind willreturn memory(none) }
attributes #1 = { noinline }
attributes #2 = { nounwind memory(read) }
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
!9 = !{!10, !12}
!10 = distinct !{!10, !11}
!11 = distinct !{!11}
!12 = distinct !{!12, !11}
!13 = !{!14, !16}
!14 = distinct !{!14, !15}
!15 = distinct !{!15}
!16 = distinct !{!16, !15}
!17 = !{!"branch_weights", i32 1, i32 49, i32 49}
!18 = !{!19}
!19 = distinct !{!19, !20}
!20 = distinct !{!20}
!21 = !{!22}
!22 = distinct !{!22, !23}
!23 = distinct !{!23}
!24 = !{!25}
!25 = distinct !{!25, !26}
!26 = distinct !{!26}
!27 = !{!28}
!28 = distinct !{!28, !29}
!29 = distinct !{!29}
!30 = !{!31}
!31 = distinct !{!31, !32}
!32 = distinct !{!32}
!33 = !{!34}
!34 = distinct !{!34, !35}
!35 = distinct !{!35}
!36 = !{!37}
!37 = distinct !{!37, !38}
!38 = distinct !{!38}
!39 = !{!40}
!40 = distinct !{!40, !41}
!41 = distinct !{!41}
