; sources 3d957ccaa6225305d7e25a591b75ffd92f9fbbef951e3bf22a835e4be6740144
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
  switch i32 %155, label %432 [
    i32 -2, label %426
    i32 0, label %426
  ], !prof !17

156:                                              ; preds = %160, %426
  %157 = phi i64 [ 0, %426 ], [ %435, %160 ]
  %158 = phi i64 [ %431, %426 ], [ %434, %160 ]
  %159 = icmp sgt i64 %158, 0
  br i1 %159, label %433, label %164

160:                                              ; preds = %433, %436
  %161 = phi i64 [ 0, %433 ], [ %438, %436 ]
  %162 = phi i64 [ %431, %433 ], [ %437, %436 ]
  %163 = icmp sgt i64 %162, 0
  br i1 %163, label %436, label %156

164:                                              ; preds = %156, %295
  %165 = phi i64 [ %452, %295 ], [ 0, %156 ]
  %166 = phi i64 [ %451, %295 ], [ 10, %156 ]
  %167 = phi double [ %175, %295 ], [ 0x7FF0000000000000, %156 ]
  %168 = icmp sgt i64 %166, 0
  br i1 %168, label %450, label %296

169:                                              ; preds = %450
  br label %771

170:                                              ; preds = %450
  %171 = call i64 @llvm.smax.i64(i64 %127, i64 0)
  br label %172

172:                                              ; preds = %189, %170
  %173 = phi i64 [ 0, %170 ], [ %461, %189 ]
  %174 = phi i64 [ %171, %170 ], [ %460, %189 ]
  %175 = phi double [ 0.000000e+00, %170 ], [ %190, %189 ]
  %176 = icmp sgt i64 %174, 0
  br i1 %176, label %459, label %194

177:                                              ; preds = %459
  %178 = call double @llvm.fabs.f64(double %466)
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

189:                                              ; preds = %177, %459
  %190 = phi double [ %175, %459 ], [ %188, %177 ]
  %191 = fsub double %466, %466
  %192 = fcmp ord double %191, 0.000000e+00
  br i1 %192, label %172, label %193

193:                                              ; preds = %189
  br label %771

194:                                              ; preds = %172
  %195 = fcmp ugt double %175, 1.000000e+00
  br i1 %195, label %196, label %296

196:                                              ; preds = %194
  %197 = fmul double %167, 5.000000e-01
  %198 = fcmp oge double %175, %197
  %199 = fcmp ole double %175, 8.000000e+00
  %200 = and i1 %198, %199
  br i1 %200, label %296, label %201

201:                                              ; preds = %196
  br i1 %453, label %202, label %203

202:                                              ; preds = %201
  br label %771

203:                                              ; preds = %201
  %204 = load i64, ptr %141, align 8, !noalias !9
  %205 = icmp eq i64 %204, 1
  br i1 %205, label %206, label %240

206:                                              ; preds = %203
  %207 = call i64 @llvm.smax.i64(i64 %64, i64 0)
  br label %208

208:                                              ; preds = %212, %206
  %209 = phi i64 [ 0, %206 ], [ %218, %212 ]
  %210 = phi i64 [ %207, %206 ], [ %217, %212 ]
  %211 = icmp sgt i64 %210, 0
  br i1 %211, label %216, label %468

212:                                              ; preds = %220, %216
  %213 = phi i64 [ 0, %216 ], [ %222, %220 ]
  %214 = phi i64 [ %219, %216 ], [ %221, %220 ]
  %215 = icmp sgt i64 %214, 0
  br i1 %215, label %220, label %208

216:                                              ; preds = %208
  %217 = add nsw i64 %210, -1
  %218 = add i64 %209, 1
  %219 = call i64 @llvm.smax.i64(i64 %66, i64 0)
  br label %212

220:                                              ; preds = %212
  %221 = add nsw i64 %214, -1
  %222 = add i64 %213, 1
  %223 = mul nsw i64 %209, %66
  %224 = add nsw i64 %140, %223
  %225 = add nsw i64 %224, %213
  %226 = icmp slt i64 %225, 0
  %227 = select i1 %226, i64 %52, i64 0
  %228 = getelementptr double, ptr %53, i64 %225
  %229 = getelementptr double, ptr %228, i64 %227
  %230 = load double, ptr %229, align 8, !noalias !18
  %231 = icmp slt i64 %209, 0
  %232 = select i1 %231, i64 %64, i64 0
  %233 = add i64 %209, %232
  %234 = icmp slt i64 %213, 0
  %235 = select i1 %234, i64 %66, i64 0
  %236 = mul i64 %233, %66
  %237 = getelementptr double, ptr %67, i64 %236
  %238 = getelementptr double, ptr %237, i64 %213
  %239 = getelementptr double, ptr %238, i64 %235
  store double %230, ptr %239, align 8, !noalias !18
  br label %212

240:                                              ; preds = %468, %468, %203
  %241 = call i64 @llvm.smax.i64(i64 %71, i64 0)
  br label %242

242:                                              ; preds = %246, %240
  %243 = phi i64 [ 0, %240 ], [ %252, %246 ]
  %244 = phi i64 [ %241, %240 ], [ %251, %246 ]
  %245 = icmp sgt i64 %244, 0
  br i1 %245, label %250, label %471

246:                                              ; preds = %254, %250
  %247 = phi i64 [ 0, %250 ], [ %256, %254 ]
  %248 = phi i64 [ %253, %250 ], [ %255, %254 ]
  %249 = icmp sgt i64 %248, 0
  br i1 %249, label %254, label %242

250:                                              ; preds = %242
  %251 = add nsw i64 %244, -1
  %252 = add i64 %243, 1
  %253 = call i64 @llvm.smax.i64(i64 %73, i64 0)
  br label %246

254:                                              ; preds = %246
  %255 = add nsw i64 %248, -1
  %256 = add i64 %247, 1
  %257 = mul nsw i64 %243, %73
  %258 = add nsw i64 %136, %257
  %259 = add nsw i64 %258, %247
  %260 = icmp slt i64 %259, 0
  %261 = select i1 %260, i64 %52, i64 0
  %262 = getelementptr double, ptr %53, i64 %259
  %263 = getelementptr double, ptr %262, i64 %261
  %264 = load double, ptr %263, align 8, !noalias !21
  %265 = icmp slt i64 %243, 0
  %266 = select i1 %265, i64 %71, i64 0
  %267 = add i64 %243, %266
  %268 = icmp slt i64 %247, 0
  %269 = select i1 %268, i64 %73, i64 0
  %270 = mul i64 %267, %73
  %271 = getelementptr double, ptr %74, i64 %270
  %272 = getelementptr double, ptr %271, i64 %247
  %273 = getelementptr double, ptr %272, i64 %269
  store double %264, ptr %273, align 8, !noalias !21
  br label %246

274:                                              ; preds = %278, %597
  %275 = phi i64 [ 0, %597 ], [ %602, %278 ]
  %276 = phi i64 [ %598, %597 ], [ %601, %278 ]
  %277 = icmp sgt i64 %276, 0
  br i1 %277, label %600, label %282

278:                                              ; preds = %600, %603
  %279 = phi i64 [ 0, %600 ], [ %605, %603 ]
  %280 = phi i64 [ %431, %600 ], [ %604, %603 ]
  %281 = icmp sgt i64 %280, 0
  br i1 %281, label %603, label %274

282:                                              ; preds = %274, %626
  %283 = phi i64 [ %635, %626 ], [ 0, %274 ]
  %284 = phi i64 [ %636, %626 ], [ %171, %274 ]
  %285 = phi double [ %634, %626 ], [ 0.000000e+00, %274 ]
  %286 = icmp sgt i64 %284, 0
  br i1 %286, label %626, label %287

287:                                              ; preds = %282
  %288 = fcmp ogt double %285, 0.000000e+00
  br i1 %288, label %289, label %295

289:                                              ; preds = %287
  store ptr null, ptr %10, align 8, !noalias !9
  %290 = call fastcc i32 @_minimum_norm(ptr nonnull %10, ptr %81, i64 %78, i64 %80, ptr %100, i64 %99, ptr %105, i64 %104, ptr %110, i64 %109, ptr %115, i64 %114, ptr %120, i64 %119, ptr %125, i64 %124) #3
  switch i32 %290, label %638 [
    i32 -2, label %637
    i32 0, label %637
  ], !prof !17

291:                                              ; preds = %637, %639
  %292 = phi i64 [ 0, %637 ], [ %641, %639 ]
  %293 = phi i64 [ %598, %637 ], [ %640, %639 ]
  %294 = icmp sgt i64 %293, 0
  br i1 %294, label %639, label %295

295:                                              ; preds = %291, %287
  br label %164

296:                                              ; preds = %164, %194, %196
  %297 = icmp sgt i64 %129, 0
  br i1 %297, label %298, label %425

298:                                              ; preds = %296, %652
  %299 = phi i64 [ %654, %652 ], [ 0, %296 ]
  %300 = phi i64 [ %653, %652 ], [ %129, %296 ]
  %301 = phi double [ %662, %652 ], [ 0.000000e+00, %296 ]
  %302 = icmp sgt i64 %300, 0
  br i1 %302, label %652, label %303

303:                                              ; preds = %298
  %304 = call i64 @llvm.smax.i64(i64 %139, i64 0)
  br label %305

305:                                              ; preds = %303, %663
  %306 = phi i64 [ 0, %303 ], [ %665, %663 ]
  %307 = phi i64 [ %304, %303 ], [ %664, %663 ]
  %308 = phi double [ %301, %303 ], [ %673, %663 ]
  %309 = icmp sgt i64 %307, 0
  br i1 %309, label %663, label %310

310:                                              ; preds = %305
  %311 = fcmp une double %308, 0.000000e+00
  br i1 %311, label %312, label %313

312:                                              ; preds = %310
  br label %771

313:                                              ; preds = %310
  %314 = load i64, ptr %141, align 8, !noalias !9
  %315 = icmp eq i64 %314, 1
  br i1 %315, label %316, label %350

316:                                              ; preds = %313
  %317 = call i64 @llvm.smax.i64(i64 %64, i64 0)
  br label %318

318:                                              ; preds = %322, %316
  %319 = phi i64 [ 0, %316 ], [ %328, %322 ]
  %320 = phi i64 [ %317, %316 ], [ %327, %322 ]
  %321 = icmp sgt i64 %320, 0
  br i1 %321, label %326, label %674

322:                                              ; preds = %330, %326
  %323 = phi i64 [ 0, %326 ], [ %332, %330 ]
  %324 = phi i64 [ %329, %326 ], [ %331, %330 ]
  %325 = icmp sgt i64 %324, 0
  br i1 %325, label %330, label %318

326:                                              ; preds = %318
  %327 = add nsw i64 %320, -1
  %328 = add i64 %319, 1
  %329 = call i64 @llvm.smax.i64(i64 %66, i64 0)
  br label %322

330:                                              ; preds = %322
  %331 = add nsw i64 %324, -1
  %332 = add i64 %323, 1
  %333 = mul nsw i64 %319, %66
  %334 = add nsw i64 %140, %333
  %335 = add nsw i64 %334, %323
  %336 = icmp slt i64 %335, 0
  %337 = select i1 %336, i64 %52, i64 0
  %338 = getelementptr double, ptr %53, i64 %335
  %339 = getelementptr double, ptr %338, i64 %337
  %340 = load double, ptr %339, align 8, !noalias !24
  %341 = icmp slt i64 %319, 0
  %342 = select i1 %341, i64 %64, i64 0
  %343 = add i64 %319, %342
  %344 = icmp slt i64 %323, 0
  %345 = select i1 %344, i64 %66, i64 0
  %346 = mul i64 %343, %66
  %347 = getelementptr double, ptr %67, i64 %346
  %348 = getelementptr double, ptr %347, i64 %323
  %349 = getelementptr double, ptr %348, i64 %345
  store double %340, ptr %349, align 8, !noalias !24
  br label %322

350:                                              ; preds = %674, %674, %313
  %351 = call i64 @llvm.smax.i64(i64 %92, i64 0)
  br label %352

352:                                              ; preds = %356, %350
  %353 = phi i64 [ 0, %350 ], [ %362, %356 ]
  %354 = phi i64 [ %351, %350 ], [ %361, %356 ]
  %355 = icmp sgt i64 %354, 0
  br i1 %355, label %360, label %677

356:                                              ; preds = %364, %360
  %357 = phi i64 [ 0, %360 ], [ %366, %364 ]
  %358 = phi i64 [ %363, %360 ], [ %365, %364 ]
  %359 = icmp sgt i64 %358, 0
  br i1 %359, label %364, label %352

360:                                              ; preds = %352
  %361 = add nsw i64 %354, -1
  %362 = add i64 %353, 1
  %363 = call i64 @llvm.smax.i64(i64 %94, i64 0)
  br label %356

364:                                              ; preds = %356
  %365 = add nsw i64 %358, -1
  %366 = add i64 %357, 1
  %367 = mul nsw i64 %353, %94
  %368 = add nsw i64 %138, %367
  %369 = add nsw i64 %368, %357
  %370 = icmp slt i64 %369, 0
  %371 = select i1 %370, i64 %52, i64 0
  %372 = getelementptr double, ptr %53, i64 %369
  %373 = getelementptr double, ptr %372, i64 %371
  %374 = load double, ptr %373, align 8, !noalias !27
  %375 = icmp slt i64 %353, 0
  %376 = select i1 %375, i64 %92, i64 0
  %377 = add i64 %353, %376
  %378 = icmp slt i64 %357, 0
  %379 = select i1 %378, i64 %94, i64 0
  %380 = mul i64 %377, %94
  %381 = getelementptr double, ptr %95, i64 %380
  %382 = getelementptr double, ptr %381, i64 %357
  %383 = getelementptr double, ptr %382, i64 %379
  store double %374, ptr %383, align 8, !noalias !27
  br label %356

384:                                              ; preds = %704, %706
  %385 = phi i64 [ 0, %704 ], [ %708, %706 ]
  %386 = phi i64 [ %431, %704 ], [ %707, %706 ]
  %387 = icmp sgt i64 %386, 0
  br i1 %387, label %706, label %721

388:                                              ; preds = %731, %399
  %389 = phi i64 [ 0, %731 ], [ %739, %399 ]
  %390 = phi i64 [ %129, %731 ], [ %738, %399 ]
  %391 = phi i64 [ 0, %731 ], [ %400, %399 ]
  %392 = phi double [ 1.000000e+00, %731 ], [ %401, %399 ]
  %393 = icmp sgt i64 %390, 0
  br i1 %393, label %737, label %402

394:                                              ; preds = %737
  %395 = add nsw i64 %391, 1
  %396 = fdiv double %756, %752
  %397 = fcmp olt double %396, %392
  %398 = select i1 %397, double %396, double %392
  br label %399

399:                                              ; preds = %394, %737
  %400 = phi i64 [ %391, %737 ], [ %395, %394 ]
  %401 = phi double [ %392, %737 ], [ %398, %394 ]
  br label %388

402:                                              ; preds = %388
  %403 = load double, ptr %735, align 8, !noalias !9
  %404 = sitofp i64 %391 to double
  %405 = fcmp olt double %403, %404
  br i1 %405, label %406, label %408

406:                                              ; preds = %402
  store double %404, ptr %735, align 8, !noalias !9
  %407 = getelementptr i8, ptr %735, i64 8
  store double 1.000000e+00, ptr %407, align 8, !noalias !9
  br label %411

408:                                              ; preds = %402
  %409 = fcmp ogt double %403, %404
  br i1 %409, label %410, label %411

410:                                              ; preds = %408
  br label %411

411:                                              ; preds = %410, %408, %406
  %412 = phi double [ %392, %406 ], [ 0.000000e+00, %410 ], [ %392, %408 ]
  %413 = getelementptr i8, ptr %735, i64 8
  %414 = load double, ptr %413, align 8, !noalias !9
  %415 = fcmp olt double %412, %414
  %416 = fcmp ogt double %414, 1.000000e-05
  %417 = and i1 %415, %416
  br i1 %417, label %418, label %425

418:                                              ; preds = %411
  store double %412, ptr %413, align 8, !noalias !9
  %419 = getelementptr i8, ptr %735, i64 16
  store double %1, ptr %419, align 8, !noalias !9
  %420 = call i64 @llvm.smax.i64(i64 %57, i64 0)
  br label %421

421:                                              ; preds = %418, %758
  %422 = phi i64 [ 0, %418 ], [ %760, %758 ]
  %423 = phi i64 [ %420, %418 ], [ %759, %758 ]
  %424 = icmp sgt i64 %423, 0
  br i1 %424, label %758, label %425

425:                                              ; preds = %421, %411, %296
  br label %771

426:                                              ; preds = %154, %154
  %427 = inttoptr i64 %55 to ptr
  %428 = getelementptr i8, ptr %427, i64 88
  %429 = load i64, ptr %428, align 8, !noalias !9
  %430 = add nsw i64 %429, 1
  store i64 %430, ptr %428, align 8, !noalias !9
  %431 = call i64 @llvm.smax.i64(i64 %133, i64 0)
  br label %156

432:                                              ; preds = %154
  br label %771

433:                                              ; preds = %156
  %434 = add nsw i64 %158, -1
  %435 = add i64 %157, 1
  br label %160

436:                                              ; preds = %160
  %437 = add nsw i64 %162, -1
  %438 = add i64 %161, 1
  %439 = icmp eq i64 %157, %161
  %440 = select i1 %439, double 1.000000e+00, double 0.000000e+00
  %441 = icmp slt i64 %157, 0
  %442 = select i1 %441, i64 %64, i64 0
  %443 = add i64 %157, %442
  %444 = icmp slt i64 %161, 0
  %445 = select i1 %444, i64 %66, i64 0
  %446 = mul i64 %443, %66
  %447 = getelementptr double, ptr %67, i64 %446
  %448 = getelementptr double, ptr %447, i64 %161
  %449 = getelementptr double, ptr %448, i64 %445
  store double %440, ptr %449, align 8, !noalias !9
  br label %160

450:                                              ; preds = %164
  %451 = add nsw i64 %166, -1
  %452 = add i64 %165, 1
  %453 = icmp eq i64 %165, 9
  %454 = getelementptr i8, ptr %45, i64 8
  %455 = load i64, ptr %454, align 8, !noalias !9
  %456 = inttoptr i64 %455 to ptr
  %457 = call i32 %456(ptr nonnull %21, ptr %58, ptr %26, ptr %48, ptr %53) #3, !noalias !9
  %458 = icmp slt i32 %457, 0
  br i1 %458, label %169, label %170

459:                                              ; preds = %172
  %460 = add nsw i64 %174, -1
  %461 = add i64 %173, 1
  %462 = icmp slt i64 %173, 0
  %463 = select i1 %462, i64 %52, i64 0
  %464 = getelementptr double, ptr %53, i64 %173
  %465 = getelementptr double, ptr %464, i64 %463
  %466 = load double, ptr %465, align 8, !noalias !9
  %467 = fcmp une double %466, 0.000000e+00
  br i1 %467, label %177, label %189

468:                                              ; preds = %208
  store ptr null, ptr %6, align 8, !noalias !9
  %469 = call fastcc i32 @_factor(ptr nonnull %6, ptr %67, i64 %64, i64 %66) #3
  switch i32 %469, label %470 [
    i32 -2, label %240
    i32 0, label %240
  ], !prof !17

470:                                              ; preds = %468
  br label %771

471:                                              ; preds = %242
  %472 = call i64 @llvm.smax.i64(i64 %78, i64 0)
  br label %473

473:                                              ; preds = %477, %471
  %474 = phi i64 [ 0, %471 ], [ %483, %477 ]
  %475 = phi i64 [ %472, %471 ], [ %482, %477 ]
  %476 = icmp sgt i64 %475, 0
  br i1 %476, label %481, label %505

477:                                              ; preds = %485, %481
  %478 = phi i64 [ 0, %481 ], [ %487, %485 ]
  %479 = phi i64 [ %484, %481 ], [ %486, %485 ]
  %480 = icmp sgt i64 %479, 0
  br i1 %480, label %485, label %473

481:                                              ; preds = %473
  %482 = add nsw i64 %475, -1
  %483 = add i64 %474, 1
  %484 = call i64 @llvm.smax.i64(i64 %80, i64 0)
  br label %477

485:                                              ; preds = %477
  %486 = add nsw i64 %479, -1
  %487 = add i64 %478, 1
  %488 = mul nsw i64 %474, %80
  %489 = add nsw i64 %134, %488
  %490 = add nsw i64 %489, %478
  %491 = icmp slt i64 %490, 0
  %492 = select i1 %491, i64 %52, i64 0
  %493 = getelementptr double, ptr %53, i64 %490
  %494 = getelementptr double, ptr %493, i64 %492
  %495 = load double, ptr %494, align 8, !noalias !30
  %496 = icmp slt i64 %474, 0
  %497 = select i1 %496, i64 %78, i64 0
  %498 = add i64 %474, %497
  %499 = icmp slt i64 %478, 0
  %500 = select i1 %499, i64 %80, i64 0
  %501 = mul i64 %498, %80
  %502 = getelementptr double, ptr %81, i64 %501
  %503 = getelementptr double, ptr %502, i64 %478
  %504 = getelementptr double, ptr %503, i64 %500
  store double %495, ptr %504, align 8, !noalias !30
  br label %477

505:                                              ; preds = %473
  %506 = call i64 @llvm.smax.i64(i64 %85, i64 0)
  br label %507

507:                                              ; preds = %511, %505
  %508 = phi i64 [ 0, %505 ], [ %532, %511 ]
  %509 = phi i64 [ %506, %505 ], [ %531, %511 ]
  %510 = icmp sgt i64 %509, 0
  br i1 %510, label %530, label %571

511:                                              ; preds = %530, %529
  %512 = phi i64 [ 0, %530 ], [ %536, %529 ]
  %513 = phi i64 [ %533, %530 ], [ %535, %529 ]
  %514 = icmp sgt i64 %513, 0
  br i1 %514, label %534, label %507

515:                                              ; preds = %546, %534
  %516 = phi i64 [ 0, %534 ], [ %548, %546 ]
  %517 = phi i64 [ %241, %534 ], [ %547, %546 ]
  %518 = phi double [ 0.000000e+00, %534 ], [ %570, %546 ]
  %519 = icmp sgt i64 %517, 0
  br i1 %519, label %546, label %520

520:                                              ; preds = %515
  %521 = load double, ptr %545, align 8, !noalias !33
  %522 = call double @llvm.fabs.f64(double %521)
  %523 = sitofp i64 %71 to double
  %524 = fmul double %523, 4.000000e+00
  %525 = fmul double %524, 0x3CB0000000000000
  %526 = fmul double %525, %518
  %527 = fcmp ugt double %522, %526
  br i1 %527, label %529, label %528

528:                                              ; preds = %520
  store double 0.000000e+00, ptr %545, align 8, !noalias !33
  br label %529

529:                                              ; preds = %528, %520
  br label %511

530:                                              ; preds = %507
  %531 = add nsw i64 %509, -1
  %532 = add i64 %508, 1
  %533 = call i64 @llvm.smax.i64(i64 %73, i64 0)
  br label %511

534:                                              ; preds = %511
  %535 = add nsw i64 %513, -1
  %536 = add i64 %512, 1
  %537 = icmp slt i64 %508, 0
  %538 = select i1 %537, i64 %85, i64 0
  %539 = add i64 %508, %538
  %540 = icmp slt i64 %512, 0
  %541 = select i1 %540, i64 %87, i64 0
  %542 = mul i64 %539, %87
  %543 = getelementptr double, ptr %88, i64 %542
  %544 = getelementptr double, ptr %543, i64 %512
  %545 = getelementptr double, ptr %544, i64 %541
  store double 0.000000e+00, ptr %545, align 8, !noalias !33
  br label %515

546:                                              ; preds = %515
  %547 = add nsw i64 %517, -1
  %548 = add i64 %516, 1
  %549 = select i1 %537, i64 %78, i64 0
  %550 = add i64 %508, %549
  %551 = icmp slt i64 %516, 0
  %552 = select i1 %551, i64 %80, i64 0
  %553 = mul i64 %550, %80
  %554 = getelementptr double, ptr %81, i64 %553
  %555 = getelementptr double, ptr %554, i64 %516
  %556 = getelementptr double, ptr %555, i64 %552
  %557 = load double, ptr %556, align 8, !noalias !33
  %558 = select i1 %551, i64 %71, i64 0
  %559 = add i64 %516, %558
  %560 = select i1 %540, i64 %73, i64 0
  %561 = mul i64 %559, %73
  %562 = getelementptr double, ptr %74, i64 %561
  %563 = getelementptr double, ptr %562, i64 %512
  %564 = getelementptr double, ptr %563, i64 %560
  %565 = load double, ptr %564, align 8, !noalias !33
  %566 = fmul double %557, %565
  %567 = load double, ptr %545, align 8, !noalias !33
  %568 = fadd double %567, %566
  store double %568, ptr %545, align 8, !noalias !33
  %569 = call double @llvm.fabs.f64(double %566)
  %570 = fadd double %518, %569
  br label %515

571:                                              ; preds = %507
  store ptr null, ptr %7, align 8, !noalias !9
  %572 = call fastcc i32 @_divide_rows(ptr nonnull %7, ptr %88, i64 %85, i64 %87, ptr %67, i64 %64, i64 %66) #3
  switch i32 %572, label %591 [
    i32 -2, label %573
    i32 0, label %573
  ], !prof !17

573:                                              ; preds = %571, %571
  %574 = call i64 @llvm.smax.i64(i64 %127, i64 0)
  br label %575

575:                                              ; preds = %579, %573
  %576 = phi i64 [ 0, %573 ], [ %581, %579 ]
  %577 = phi i64 [ %574, %573 ], [ %580, %579 ]
  %578 = icmp sgt i64 %577, 0
  br i1 %578, label %579, label %592

579:                                              ; preds = %575
  %580 = add nsw i64 %577, -1
  %581 = add i64 %576, 1
  %582 = icmp slt i64 %576, 0
  %583 = select i1 %582, i64 %52, i64 0
  %584 = getelementptr double, ptr %53, i64 %576
  %585 = getelementptr double, ptr %584, i64 %583
  %586 = load double, ptr %585, align 8, !noalias !36
  %587 = fneg double %586
  %588 = select i1 %582, i64 %104, i64 0
  %589 = getelementptr double, ptr %105, i64 %576
  %590 = getelementptr double, ptr %589, i64 %588
  store double %587, ptr %590, align 8, !noalias !36
  br label %575

591:                                              ; preds = %571
  br label %771

592:                                              ; preds = %575
  store ptr null, ptr %8, align 8, !noalias !9
  %593 = call fastcc i32 @_minimum_norm(ptr nonnull %8, ptr %88, i64 %85, i64 %87, ptr %100, i64 %99, ptr %105, i64 %104, ptr %110, i64 %109, ptr %115, i64 %114, ptr %120, i64 %119, ptr %125, i64 %124) #3
  switch i32 %593, label %596 [
    i32 -2, label %594
    i32 0, label %594
  ], !prof !17

594:                                              ; preds = %592, %592
  store ptr null, ptr %9, align 8, !noalias !9
  %595 = call fastcc i32 @_divide_transposed(ptr nonnull %9, ptr %67, i64 %64, i64 %66, ptr %100, i64 %99) #3
  switch i32 %595, label %599 [
    i32 -2, label %597
    i32 0, label %597
  ], !prof !17

596:                                              ; preds = %592
  br label %771

597:                                              ; preds = %594, %594
  %598 = call i64 @llvm.smax.i64(i64 %131, i64 0)
  br label %274

599:                                              ; preds = %594
  br label %771

600:                                              ; preds = %274
  %601 = add nsw i64 %276, -1
  %602 = add i64 %275, 1
  br label %278

603:                                              ; preds = %278
  %604 = add nsw i64 %280, -1
  %605 = add i64 %279, 1
  %606 = icmp slt i64 %275, 0
  %607 = select i1 %606, i64 %57, i64 0
  %608 = getelementptr double, ptr %58, i64 %275
  %609 = getelementptr double, ptr %608, i64 %607
  %610 = load double, ptr %609, align 8, !noalias !9
  %611 = select i1 %606, i64 %71, i64 0
  %612 = add i64 %275, %611
  %613 = icmp slt i64 %279, 0
  %614 = select i1 %613, i64 %73, i64 0
  %615 = mul i64 %612, %73
  %616 = getelementptr double, ptr %74, i64 %615
  %617 = getelementptr double, ptr %616, i64 %279
  %618 = getelementptr double, ptr %617, i64 %614
  %619 = load double, ptr %618, align 8, !noalias !9
  %620 = select i1 %613, i64 %99, i64 0
  %621 = getelementptr double, ptr %100, i64 %279
  %622 = getelementptr double, ptr %621, i64 %620
  %623 = load double, ptr %622, align 8, !noalias !9
  %624 = fmul double %619, %623
  %625 = fadd double %610, %624
  store double %625, ptr %609, align 8, !noalias !9
  br label %278

626:                                              ; preds = %282
  %627 = icmp slt i64 %283, 0
  %628 = select i1 %627, i64 %104, i64 0
  %629 = getelementptr double, ptr %105, i64 %283
  %630 = getelementptr double, ptr %629, i64 %628
  %631 = load double, ptr %630, align 8, !noalias !9
  %632 = call double @llvm.fabs.f64(double %631)
  %633 = fcmp ogt double %632, %285
  %634 = select i1 %633, double %632, double %285
  %635 = add i64 %283, 1
  %636 = add nsw i64 %284, -1
  br label %282

637:                                              ; preds = %289, %289
  br label %291

638:                                              ; preds = %289
  br label %771

639:                                              ; preds = %291
  %640 = add nsw i64 %293, -1
  %641 = add i64 %292, 1
  %642 = icmp slt i64 %292, 0
  %643 = select i1 %642, i64 %57, i64 0
  %644 = getelementptr double, ptr %58, i64 %292
  %645 = getelementptr double, ptr %644, i64 %643
  %646 = load double, ptr %645, align 8, !noalias !9
  %647 = select i1 %642, i64 %99, i64 0
  %648 = getelementptr double, ptr %100, i64 %292
  %649 = getelementptr double, ptr %648, i64 %647
  %650 = load double, ptr %649, align 8, !noalias !9
  %651 = fadd double %646, %650
  store double %651, ptr %645, align 8, !noalias !9
  br label %291

652:                                              ; preds = %298
  %653 = add nsw i64 %300, -1
  %654 = add i64 %299, 1
  %655 = add nsw i64 %127, %299
  %656 = icmp slt i64 %655, 0
  %657 = select i1 %656, i64 %52, i64 0
  %658 = getelementptr double, ptr %53, i64 %655
  %659 = getelementptr double, ptr %658, i64 %657
  %660 = load double, ptr %659, align 8, !noalias !9
  %661 = fmul double %660, 0.000000e+00
  %662 = fadd double %301, %661
  br label %298

663:                                              ; preds = %305
  %664 = add nsw i64 %307, -1
  %665 = add i64 %306, 1
  %666 = add nsw i64 %138, %306
  %667 = icmp slt i64 %666, 0
  %668 = select i1 %667, i64 %52, i64 0
  %669 = getelementptr double, ptr %53, i64 %666
  %670 = getelementptr double, ptr %669, i64 %668
  %671 = load double, ptr %670, align 8, !noalias !9
  %672 = fmul double %671, 0.000000e+00
  %673 = fadd double %308, %672
  br label %305

674:                                              ; preds = %318
  store ptr null, ptr %11, align 8, !noalias !9
  %675 = call fastcc i32 @_factor(ptr nonnull %11, ptr %67, i64 %64, i64 %66) #3
  switch i32 %675, label %676 [
    i32 -2, label %350
    i32 0, label %350
  ], !prof !17

676:                                              ; preds = %674
  br label %771

677:                                              ; preds = %352
  store ptr null, ptr %12, align 8, !noalias !9
  %678 = call fastcc i32 @_divide_rows(ptr nonnull %12, ptr %95, i64 %92, i64 %94, ptr %67, i64 %64, i64 %66) #3
  switch i32 %678, label %698 [
    i32 -2, label %679
    i32 0, label %679
  ], !prof !17

679:                                              ; preds = %677, %677
  br label %680

680:                                              ; preds = %684, %679
  %681 = phi i64 [ 0, %679 ], [ %686, %684 ]
  %682 = phi i64 [ %129, %679 ], [ %685, %684 ]
  %683 = icmp sgt i64 %682, 0
  br i1 %683, label %684, label %699

684:                                              ; preds = %680
  %685 = add nsw i64 %682, -1
  %686 = add i64 %681, 1
  %687 = add nsw i64 %127, %681
  %688 = icmp slt i64 %687, 0
  %689 = select i1 %688, i64 %52, i64 0
  %690 = getelementptr double, ptr %53, i64 %687
  %691 = getelementptr double, ptr %690, i64 %689
  %692 = load double, ptr %691, align 8, !noalias !39
  %693 = fneg double %692
  %694 = icmp slt i64 %681, 0
  %695 = select i1 %694, i64 %104, i64 0
  %696 = getelementptr double, ptr %105, i64 %681
  %697 = getelementptr double, ptr %696, i64 %695
  store double %693, ptr %697, align 8, !noalias !39
  br label %680

698:                                              ; preds = %677
  br label %771

699:                                              ; preds = %680
  store ptr null, ptr %13, align 8, !noalias !9
  %700 = call fastcc i32 @_minimum_norm(ptr nonnull %13, ptr %95, i64 %92, i64 %94, ptr %100, i64 %99, ptr %105, i64 %104, ptr %110, i64 %109, ptr %115, i64 %114, ptr %120, i64 %119, ptr %125, i64 %124) #3
  switch i32 %700, label %703 [
    i32 -2, label %701
    i32 0, label %701
  ], !prof !17

701:                                              ; preds = %699, %699
  store ptr null, ptr %14, align 8, !noalias !9
  %702 = call fastcc i32 @_divide_transposed(ptr nonnull %14, ptr %67, i64 %64, i64 %66, ptr %100, i64 %99) #3
  switch i32 %702, label %705 [
    i32 -2, label %704
    i32 0, label %704
  ], !prof !17

703:                                              ; preds = %699
  br label %771

704:                                              ; preds = %701, %701
  br label %384

705:                                              ; preds = %701
  br label %771

706:                                              ; preds = %384
  %707 = add nsw i64 %386, -1
  %708 = add i64 %385, 1
  %709 = add nsw i64 %131, %385
  %710 = icmp slt i64 %709, 0
  %711 = select i1 %710, i64 %57, i64 0
  %712 = getelementptr double, ptr %58, i64 %709
  %713 = getelementptr double, ptr %712, i64 %711
  %714 = load double, ptr %713, align 8, !noalias !9
  %715 = icmp slt i64 %385, 0
  %716 = select i1 %715, i64 %99, i64 0
  %717 = getelementptr double, ptr %100, i64 %385
  %718 = getelementptr double, ptr %717, i64 %716
  %719 = load double, ptr %718, align 8, !noalias !9
  %720 = fadd double %714, %719
  store double %720, ptr %713, align 8, !noalias !9
  br label %384

721:                                              ; preds = %384
  %722 = icmp slt i64 %146, 0
  %723 = select i1 %722, i64 %52, i64 0
  %724 = add i64 %146, %723
  %725 = icmp slt i64 %724, 0
  br i1 %725, label %726, label %727, !prof !4

726:                                              ; preds = %721
  br label %727

727:                                              ; preds = %726, %721
  %728 = phi i64 [ 0, %726 ], [ %724, %721 ]
  %729 = icmp slt i64 %724, %52
  br i1 %729, label %731, label %730, !prof !8

730:                                              ; preds = %727
  br label %731

731:                                              ; preds = %730, %727
  %732 = phi i64 [ %52, %730 ], [ %728, %727 ]
  %733 = sub i64 %52, %732
  %734 = call i64 @llvm.smax.i64(i64 %733, i64 0)
  %735 = getelementptr double, ptr %53, i64 %732
  %736 = add nsw i64 %57, 3
  br label %388

737:                                              ; preds = %388
  %738 = add nsw i64 %390, -1
  %739 = add i64 %389, 1
  %740 = add nsw i64 %736, %389
  %741 = icmp slt i64 %740, 0
  %742 = select i1 %741, i64 %734, i64 0
  %743 = getelementptr double, ptr %735, i64 %740
  %744 = getelementptr double, ptr %743, i64 %742
  %745 = load double, ptr %744, align 8, !noalias !9
  %746 = icmp slt i64 %389, 0
  %747 = select i1 %746, i64 %119, i64 0
  %748 = getelementptr double, ptr %120, i64 %389
  %749 = getelementptr double, ptr %748, i64 %747
  %750 = load double, ptr %749, align 8, !noalias !9
  %751 = fcmp ogt double %750, %745
  %752 = select i1 %751, double %750, double %745
  store double %752, ptr %744, align 8, !noalias !9
  %753 = select i1 %746, i64 %124, i64 0
  %754 = getelementptr double, ptr %125, i64 %389
  %755 = getelementptr double, ptr %754, i64 %753
  %756 = load double, ptr %755, align 8, !noalias !9
  %757 = fcmp ogt double %756, 0.000000e+00
  br i1 %757, label %394, label %399

758:                                              ; preds = %421
  %759 = add nsw i64 %423, -1
  %760 = add i64 %422, 1
  %761 = icmp slt i64 %422, 0
  %762 = select i1 %761, i64 %57, i64 0
  %763 = getelementptr double, ptr %58, i64 %422
  %764 = getelementptr double, ptr %763, i64 %762
  %765 = load double, ptr %764, align 8, !noalias !9
  %766 = icmp slt i64 %422, -3
  %767 = select i1 %766, i64 %734, i64 0
  %768 = getelementptr double, ptr %735, i64 %422
  %769 = getelementptr i8, ptr %768, i64 24
  %770 = getelementptr double, ptr %769, i64 %767
  store double %765, ptr %770, align 8, !noalias !9
  br label %421

771:                                              ; preds = %705, %703, %698, %676, %638, %599, %596, %591, %470, %432, %425, %312, %202, %193, %169
  %772 = phi i64 [ 0, %432 ], [ 0, %596 ], [ 0, %638 ], [ 0, %703 ], [ 6, %169 ], [ 0, %599 ], [ 0, %470 ], [ 6, %193 ], [ 0, %705 ], [ 0, %591 ], [ 6, %312 ], [ 0, %425 ], [ 0, %676 ], [ 6, %202 ], [ 0, %698 ]
  ret i64 %772
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
