; sources a92f97a6bbf25888040c0c6994b770a25ca7fb192ffe2c866bc67be38010b58a
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

declare double @llvm.fabs.f64(double) #0

define internal fastcc i32 @_sample(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, i64 %5, ptr %6, i64 %7, ptr %8, i64 %9, i64 %10, double %11) unnamed_addr #1 {
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
  store ptr null, ptr %6, align 8, !noalias !5
  store ptr null, ptr %7, align 8, !noalias !5
  store ptr null, ptr %8, align 8, !noalias !5
  store ptr null, ptr %9, align 8, !noalias !5
  store ptr null, ptr %10, align 8, !noalias !5
  store ptr null, ptr %11, align 8, !noalias !5
  store ptr null, ptr %12, align 8, !noalias !5
  store ptr null, ptr %13, align 8, !noalias !5
  store ptr null, ptr %14, align 8, !noalias !5
  %15 = inttoptr i64 %0 to ptr
  %16 = getelementptr i8, ptr %15, i64 144
  %17 = load i64, ptr %16, align 8, !noalias !5
  %18 = inttoptr i64 %17 to ptr
  %19 = getelementptr i8, ptr %15, i64 168
  %20 = load i64, ptr %19, align 8, !noalias !5
  %21 = inttoptr i64 %20 to ptr
  %22 = getelementptr i8, ptr %15, i64 192
  %23 = load i64, ptr %22, align 8, !noalias !5
  %24 = getelementptr i8, ptr %15, i64 200
  %25 = load i64, ptr %24, align 8, !noalias !5
  %26 = inttoptr i64 %23 to ptr
  %27 = getelementptr i8, ptr %15, i64 240
  %28 = load i64, ptr %27, align 8, !noalias !5
  %29 = getelementptr i8, ptr %15, i64 248
  %30 = load i64, ptr %29, align 8, !noalias !5
  %31 = getelementptr i8, ptr %15, i64 256
  %32 = load i64, ptr %31, align 8, !noalias !5
  %33 = getelementptr i8, ptr %15, i64 264
  %34 = load i64, ptr %33, align 8, !noalias !5
  %35 = getelementptr i8, ptr %15, i64 272
  %36 = load i64, ptr %35, align 8, !noalias !5
  %37 = getelementptr i8, ptr %15, i64 288
  %38 = load i64, ptr %37, align 8, !noalias !5
  %39 = getelementptr i8, ptr %15, i64 296
  %40 = load i64, ptr %39, align 8, !noalias !5
  %41 = getelementptr i8, ptr %15, i64 304
  %42 = load i64, ptr %41, align 8, !noalias !5
  %43 = getelementptr i8, ptr %15, i64 648
  %44 = load i64, ptr %43, align 8, !noalias !5
  %45 = inttoptr i64 %44 to ptr
  %46 = getelementptr i8, ptr %15, i64 672
  %47 = load i64, ptr %46, align 8, !noalias !5
  %48 = inttoptr i64 %47 to ptr
  %49 = getelementptr i8, ptr %15, i64 696
  %50 = load i64, ptr %49, align 8, !noalias !5
  %51 = getelementptr i8, ptr %15, i64 704
  %52 = load i64, ptr %51, align 8, !noalias !5
  %53 = inttoptr i64 %50 to ptr
  %54 = getelementptr i8, ptr %15, i64 600
  %55 = load i64, ptr %54, align 8, !noalias !5
  %56 = getelementptr i8, ptr %18, i64 8
  %57 = load i64, ptr %56, align 8, !noalias !5
  %58 = inttoptr i64 %2 to ptr
  %59 = getelementptr i8, ptr %45, i64 64
  %60 = load i64, ptr %59, align 8, !noalias !5
  %61 = inttoptr i64 %60 to ptr
  %62 = load i64, ptr %61, align 8, !noalias !5
  %63 = getelementptr i8, ptr %61, i64 8
  %64 = load i64, ptr %63, align 8, !noalias !5
  %65 = getelementptr i8, ptr %61, i64 16
  %66 = load i64, ptr %65, align 8, !noalias !5
  %67 = inttoptr i64 %62 to ptr
  %68 = getelementptr i8, ptr %61, i64 24
  %69 = load i64, ptr %68, align 8, !noalias !5
  %70 = getelementptr i8, ptr %61, i64 32
  %71 = load i64, ptr %70, align 8, !noalias !5
  %72 = getelementptr i8, ptr %61, i64 40
  %73 = load i64, ptr %72, align 8, !noalias !5
  %74 = inttoptr i64 %69 to ptr
  %75 = getelementptr i8, ptr %61, i64 48
  %76 = load i64, ptr %75, align 8, !noalias !5
  %77 = getelementptr i8, ptr %61, i64 56
  %78 = load i64, ptr %77, align 8, !noalias !5
  %79 = getelementptr i8, ptr %61, i64 64
  %80 = load i64, ptr %79, align 8, !noalias !5
  %81 = inttoptr i64 %76 to ptr
  %82 = getelementptr i8, ptr %61, i64 72
  %83 = load i64, ptr %82, align 8, !noalias !5
  %84 = getelementptr i8, ptr %61, i64 80
  %85 = load i64, ptr %84, align 8, !noalias !5
  %86 = getelementptr i8, ptr %61, i64 88
  %87 = load i64, ptr %86, align 8, !noalias !5
  %88 = inttoptr i64 %83 to ptr
  %89 = getelementptr i8, ptr %61, i64 96
  %90 = load i64, ptr %89, align 8, !noalias !5
  %91 = getelementptr i8, ptr %61, i64 104
  %92 = load i64, ptr %91, align 8, !noalias !5
  %93 = getelementptr i8, ptr %61, i64 112
  %94 = load i64, ptr %93, align 8, !noalias !5
  %95 = inttoptr i64 %90 to ptr
  %96 = getelementptr i8, ptr %61, i64 120
  %97 = load i64, ptr %96, align 8, !noalias !5
  %98 = getelementptr i8, ptr %61, i64 128
  %99 = load i64, ptr %98, align 8, !noalias !5
  %100 = inttoptr i64 %97 to ptr
  %101 = getelementptr i8, ptr %61, i64 144
  %102 = load i64, ptr %101, align 8, !noalias !5
  %103 = getelementptr i8, ptr %61, i64 152
  %104 = load i64, ptr %103, align 8, !noalias !5
  %105 = inttoptr i64 %102 to ptr
  %106 = getelementptr i8, ptr %61, i64 168
  %107 = load i64, ptr %106, align 8, !noalias !5
  %108 = getelementptr i8, ptr %61, i64 176
  %109 = load i64, ptr %108, align 8, !noalias !5
  %110 = inttoptr i64 %107 to ptr
  %111 = getelementptr i8, ptr %61, i64 192
  %112 = load i64, ptr %111, align 8, !noalias !5
  %113 = getelementptr i8, ptr %61, i64 200
  %114 = load i64, ptr %113, align 8, !noalias !5
  %115 = inttoptr i64 %112 to ptr
  %116 = getelementptr i8, ptr %61, i64 216
  %117 = load i64, ptr %116, align 8, !noalias !5
  %118 = getelementptr i8, ptr %61, i64 224
  %119 = load i64, ptr %118, align 8, !noalias !5
  %120 = inttoptr i64 %117 to ptr
  %121 = getelementptr i8, ptr %61, i64 240
  %122 = load i64, ptr %121, align 8, !noalias !5
  %123 = getelementptr i8, ptr %61, i64 248
  %124 = load i64, ptr %123, align 8, !noalias !5
  %125 = inttoptr i64 %122 to ptr
  %126 = getelementptr i8, ptr %45, i64 16
  %127 = load i64, ptr %126, align 8, !noalias !5
  %128 = getelementptr i8, ptr %45, i64 24
  %129 = load i64, ptr %128, align 8, !noalias !5
  %130 = getelementptr i8, ptr %45, i64 32
  %131 = load i64, ptr %130, align 8, !noalias !5
  %132 = getelementptr i8, ptr %45, i64 40
  %133 = load i64, ptr %132, align 8, !noalias !5
  %134 = add nsw i64 %127, %129
  %135 = mul nsw i64 %127, %131
  %136 = add nsw i64 %134, %135
  %137 = mul nsw i64 %131, %133
  %138 = add nsw i64 %136, %137
  %139 = mul nsw i64 %129, %133
  %140 = add nsw i64 %138, %139
  %141 = getelementptr i8, ptr %45, i64 48
  %142 = load i64, ptr %141, align 8, !noalias !5
  %143 = mul nsw i64 %142, %133
  %144 = mul nsw i64 %143, %133
  %145 = add nsw i64 %140, %144
  %146 = add nsw i64 %145, %127
  store ptr null, ptr %4, align 8, !noalias !9
  store ptr null, ptr %5, align 8, !noalias !9
  store double %1, ptr %21, align 8, !noalias !9
  %147 = icmp sgt i64 %30, 0
  br i1 %147, label %148, label %154

148:                                              ; preds = %3
  %149 = inttoptr i64 %38 to ptr
  %150 = inttoptr i64 %34 to ptr
  %151 = inttoptr i64 %28 to ptr
  store ptr null, ptr %4, align 8, !noalias !9
  %152 = call fastcc i32 @_sample(ptr nonnull %4, ptr %26, i64 %25, ptr %151, i64 %30, i64 %32, ptr %150, i64 %36, ptr %149, i64 %40, i64 %42, double %1) #3
  switch i32 %152, label %153 [
    i32 -2, label %154
    i32 0, label %154
  ], !prof !13

153:                                              ; preds = %148
  br label %154

154:                                              ; preds = %148, %148, %3, %153
  %155 = phi i32 [ %152, %153 ], [ 0, %3 ], [ 0, %148 ], [ 0, %148 ]
  switch i32 %155, label %441 [
    i32 -2, label %435
    i32 0, label %435
  ], !prof !13

156:                                              ; preds = %160, %435
  %157 = phi i64 [ 0, %435 ], [ %444, %160 ]
  %158 = phi i64 [ %440, %435 ], [ %443, %160 ]
  %159 = icmp sgt i64 %158, 0
  br i1 %159, label %442, label %164

160:                                              ; preds = %442, %445
  %161 = phi i64 [ 0, %442 ], [ %447, %445 ]
  %162 = phi i64 [ %440, %442 ], [ %446, %445 ]
  %163 = icmp sgt i64 %162, 0
  br i1 %163, label %445, label %156

164:                                              ; preds = %156, %319
  %165 = phi i64 [ %461, %319 ], [ 0, %156 ]
  %166 = phi i64 [ %460, %319 ], [ 10, %156 ]
  %167 = phi double [ %175, %319 ], [ 0x7FF0000000000000, %156 ]
  %168 = icmp sgt i64 %166, 0
  br i1 %168, label %459, label %320

169:                                              ; preds = %459
  br label %731

170:                                              ; preds = %459
  %171 = call i64 @llvm.smax.i64(i64 %127, i64 0)
  br label %172

172:                                              ; preds = %189, %170
  %173 = phi i64 [ 0, %170 ], [ %470, %189 ]
  %174 = phi i64 [ %171, %170 ], [ %469, %189 ]
  %175 = phi double [ 0.000000e+00, %170 ], [ %190, %189 ]
  %176 = icmp sgt i64 %174, 0
  br i1 %176, label %468, label %193

177:                                              ; preds = %468
  %178 = call double @llvm.fabs.f64(double %475)
  %179 = add nsw i64 %145, %173
  %180 = icmp slt i64 %179, 0
  %181 = select i1 %180, i64 %52, i64 0
  %182 = getelementptr double, ptr %53, i64 %179
  %183 = getelementptr double, ptr %182, i64 %181
  %184 = load double, ptr %183, align 8, !noalias !5
  %185 = fmul double %184, 0x3CB0000000000000
  %186 = fdiv double %178, %185
  %187 = fcmp ogt double %186, %175
  %188 = select i1 %187, double %186, double %175
  br label %189

189:                                              ; preds = %177, %468
  %190 = phi double [ %175, %468 ], [ %188, %177 ]
  %191 = fcmp uno double %475, 0.000000e+00
  br i1 %191, label %192, label %172

192:                                              ; preds = %189
  br label %731

193:                                              ; preds = %172
  %194 = fcmp ugt double %175, 1.000000e+00
  br i1 %194, label %195, label %320

195:                                              ; preds = %193
  %196 = fmul double %167, 5.000000e-01
  %197 = fcmp oge double %175, %196
  %198 = fcmp ole double %175, 8.000000e+00
  %199 = and i1 %197, %198
  br i1 %199, label %320, label %200

200:                                              ; preds = %195
  br i1 %462, label %201, label %202

201:                                              ; preds = %200
  br label %731

202:                                              ; preds = %200
  %203 = load i64, ptr %141, align 8, !noalias !5
  %204 = icmp eq i64 %203, 1
  br i1 %204, label %205, label %239

205:                                              ; preds = %202
  %206 = call i64 @llvm.smax.i64(i64 %64, i64 0)
  br label %207

207:                                              ; preds = %211, %205
  %208 = phi i64 [ 0, %205 ], [ %217, %211 ]
  %209 = phi i64 [ %206, %205 ], [ %216, %211 ]
  %210 = icmp sgt i64 %209, 0
  br i1 %210, label %215, label %477

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
  %229 = load double, ptr %228, align 8, !noalias !14
  %230 = icmp slt i64 %208, 0
  %231 = select i1 %230, i64 %64, i64 0
  %232 = add i64 %208, %231
  %233 = icmp slt i64 %212, 0
  %234 = select i1 %233, i64 %66, i64 0
  %235 = mul i64 %232, %66
  %236 = getelementptr double, ptr %67, i64 %235
  %237 = getelementptr double, ptr %236, i64 %212
  %238 = getelementptr double, ptr %237, i64 %234
  store double %229, ptr %238, align 8, !noalias !14
  br label %211

239:                                              ; preds = %477, %477, %202
  %240 = call i64 @llvm.smax.i64(i64 %71, i64 0)
  br label %241

241:                                              ; preds = %245, %239
  %242 = phi i64 [ 0, %239 ], [ %251, %245 ]
  %243 = phi i64 [ %240, %239 ], [ %250, %245 ]
  %244 = icmp sgt i64 %243, 0
  br i1 %244, label %249, label %480

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
  %263 = load double, ptr %262, align 8, !noalias !17
  %264 = icmp slt i64 %242, 0
  %265 = select i1 %264, i64 %71, i64 0
  %266 = add i64 %242, %265
  %267 = icmp slt i64 %246, 0
  %268 = select i1 %267, i64 %73, i64 0
  %269 = mul i64 %266, %73
  %270 = getelementptr double, ptr %74, i64 %269
  %271 = getelementptr double, ptr %270, i64 %246
  %272 = getelementptr double, ptr %271, i64 %268
  store double %263, ptr %272, align 8, !noalias !17
  br label %245

273:                                              ; preds = %482, %277
  %274 = phi i64 [ %516, %277 ], [ 0, %482 ]
  %275 = phi i64 [ %515, %277 ], [ %171, %482 ]
  %276 = icmp sgt i64 %275, 0
  br i1 %276, label %514, label %296

277:                                              ; preds = %514, %295
  %278 = phi i64 [ 0, %514 ], [ %519, %295 ]
  %279 = phi i64 [ %440, %514 ], [ %518, %295 ]
  %280 = icmp sgt i64 %279, 0
  br i1 %280, label %517, label %273

281:                                              ; preds = %517, %530
  %282 = phi i64 [ 0, %517 ], [ %532, %530 ]
  %283 = phi i64 [ %529, %517 ], [ %531, %530 ]
  %284 = phi double [ 0.000000e+00, %517 ], [ %554, %530 ]
  %285 = icmp sgt i64 %283, 0
  br i1 %285, label %530, label %286

286:                                              ; preds = %281
  %287 = load double, ptr %528, align 8, !noalias !5
  %288 = call double @llvm.fabs.f64(double %287)
  %289 = sitofp i64 %131 to double
  %290 = fmul double %289, 4.000000e+00
  %291 = fmul double %290, 0x3CB0000000000000
  %292 = fmul double %291, %284
  %293 = fcmp ugt double %288, %292
  br i1 %293, label %295, label %294

294:                                              ; preds = %286
  store double 0.000000e+00, ptr %528, align 8, !noalias !5
  br label %295

295:                                              ; preds = %294, %286
  br label %277

296:                                              ; preds = %273
  store ptr null, ptr %7, align 8, !noalias !5
  %297 = call fastcc i32 @_divide_rows(ptr nonnull %7, ptr %88, i64 %85, i64 %87, ptr %67, i64 %64, i64 %66) #3
  switch i32 %297, label %573 [
    i32 -2, label %555
    i32 0, label %555
  ], !prof !13

298:                                              ; preds = %302, %579
  %299 = phi i64 [ 0, %579 ], [ %584, %302 ]
  %300 = phi i64 [ %580, %579 ], [ %583, %302 ]
  %301 = icmp sgt i64 %300, 0
  br i1 %301, label %582, label %306

302:                                              ; preds = %582, %585
  %303 = phi i64 [ 0, %582 ], [ %587, %585 ]
  %304 = phi i64 [ %440, %582 ], [ %586, %585 ]
  %305 = icmp sgt i64 %304, 0
  br i1 %305, label %585, label %298

306:                                              ; preds = %298, %608
  %307 = phi i64 [ %617, %608 ], [ 0, %298 ]
  %308 = phi i64 [ %618, %608 ], [ %171, %298 ]
  %309 = phi double [ %616, %608 ], [ 0.000000e+00, %298 ]
  %310 = icmp sgt i64 %308, 0
  br i1 %310, label %608, label %311

311:                                              ; preds = %306
  %312 = fcmp ogt double %309, 0.000000e+00
  br i1 %312, label %313, label %319

313:                                              ; preds = %311
  store ptr null, ptr %10, align 8, !noalias !5
  %314 = call fastcc i32 @_minimum_norm(ptr nonnull %10, ptr %81, i64 %78, i64 %80, ptr %100, i64 %99, ptr %105, i64 %104, ptr %110, i64 %109, ptr %115, i64 %114, ptr %120, i64 %119, ptr %125, i64 %124) #3
  switch i32 %314, label %620 [
    i32 -2, label %619
    i32 0, label %619
  ], !prof !13

315:                                              ; preds = %619, %621
  %316 = phi i64 [ 0, %619 ], [ %623, %621 ]
  %317 = phi i64 [ %580, %619 ], [ %622, %621 ]
  %318 = icmp sgt i64 %317, 0
  br i1 %318, label %621, label %319

319:                                              ; preds = %315, %311
  br label %164

320:                                              ; preds = %164, %193, %195
  %321 = icmp sgt i64 %129, 0
  br i1 %321, label %322, label %434

322:                                              ; preds = %320
  %323 = load i64, ptr %141, align 8, !noalias !5
  %324 = icmp eq i64 %323, 1
  br i1 %324, label %325, label %359

325:                                              ; preds = %322
  %326 = call i64 @llvm.smax.i64(i64 %64, i64 0)
  br label %327

327:                                              ; preds = %331, %325
  %328 = phi i64 [ 0, %325 ], [ %337, %331 ]
  %329 = phi i64 [ %326, %325 ], [ %336, %331 ]
  %330 = icmp sgt i64 %329, 0
  br i1 %330, label %335, label %634

331:                                              ; preds = %339, %335
  %332 = phi i64 [ 0, %335 ], [ %341, %339 ]
  %333 = phi i64 [ %338, %335 ], [ %340, %339 ]
  %334 = icmp sgt i64 %333, 0
  br i1 %334, label %339, label %327

335:                                              ; preds = %327
  %336 = add nsw i64 %329, -1
  %337 = add i64 %328, 1
  %338 = call i64 @llvm.smax.i64(i64 %66, i64 0)
  br label %331

339:                                              ; preds = %331
  %340 = add nsw i64 %333, -1
  %341 = add i64 %332, 1
  %342 = mul nsw i64 %328, %66
  %343 = add nsw i64 %140, %342
  %344 = add nsw i64 %343, %332
  %345 = icmp slt i64 %344, 0
  %346 = select i1 %345, i64 %52, i64 0
  %347 = getelementptr double, ptr %53, i64 %344
  %348 = getelementptr double, ptr %347, i64 %346
  %349 = load double, ptr %348, align 8, !noalias !20
  %350 = icmp slt i64 %328, 0
  %351 = select i1 %350, i64 %64, i64 0
  %352 = add i64 %328, %351
  %353 = icmp slt i64 %332, 0
  %354 = select i1 %353, i64 %66, i64 0
  %355 = mul i64 %352, %66
  %356 = getelementptr double, ptr %67, i64 %355
  %357 = getelementptr double, ptr %356, i64 %332
  %358 = getelementptr double, ptr %357, i64 %354
  store double %349, ptr %358, align 8, !noalias !20
  br label %331

359:                                              ; preds = %634, %634, %322
  %360 = call i64 @llvm.smax.i64(i64 %92, i64 0)
  br label %361

361:                                              ; preds = %365, %359
  %362 = phi i64 [ 0, %359 ], [ %371, %365 ]
  %363 = phi i64 [ %360, %359 ], [ %370, %365 ]
  %364 = icmp sgt i64 %363, 0
  br i1 %364, label %369, label %637

365:                                              ; preds = %373, %369
  %366 = phi i64 [ 0, %369 ], [ %375, %373 ]
  %367 = phi i64 [ %372, %369 ], [ %374, %373 ]
  %368 = icmp sgt i64 %367, 0
  br i1 %368, label %373, label %361

369:                                              ; preds = %361
  %370 = add nsw i64 %363, -1
  %371 = add i64 %362, 1
  %372 = call i64 @llvm.smax.i64(i64 %94, i64 0)
  br label %365

373:                                              ; preds = %365
  %374 = add nsw i64 %367, -1
  %375 = add i64 %366, 1
  %376 = mul nsw i64 %362, %94
  %377 = add nsw i64 %138, %376
  %378 = add nsw i64 %377, %366
  %379 = icmp slt i64 %378, 0
  %380 = select i1 %379, i64 %52, i64 0
  %381 = getelementptr double, ptr %53, i64 %378
  %382 = getelementptr double, ptr %381, i64 %380
  %383 = load double, ptr %382, align 8, !noalias !23
  %384 = icmp slt i64 %362, 0
  %385 = select i1 %384, i64 %92, i64 0
  %386 = add i64 %362, %385
  %387 = icmp slt i64 %366, 0
  %388 = select i1 %387, i64 %94, i64 0
  %389 = mul i64 %386, %94
  %390 = getelementptr double, ptr %95, i64 %389
  %391 = getelementptr double, ptr %390, i64 %366
  %392 = getelementptr double, ptr %391, i64 %388
  store double %383, ptr %392, align 8, !noalias !23
  br label %365

393:                                              ; preds = %664, %666
  %394 = phi i64 [ 0, %664 ], [ %668, %666 ]
  %395 = phi i64 [ %440, %664 ], [ %667, %666 ]
  %396 = icmp sgt i64 %395, 0
  br i1 %396, label %666, label %681

397:                                              ; preds = %691, %408
  %398 = phi i64 [ 0, %691 ], [ %699, %408 ]
  %399 = phi i64 [ %129, %691 ], [ %698, %408 ]
  %400 = phi i64 [ 0, %691 ], [ %409, %408 ]
  %401 = phi double [ 1.000000e+00, %691 ], [ %410, %408 ]
  %402 = icmp sgt i64 %399, 0
  br i1 %402, label %697, label %411

403:                                              ; preds = %697
  %404 = add nsw i64 %400, 1
  %405 = fdiv double %716, %712
  %406 = fcmp olt double %405, %401
  %407 = select i1 %406, double %405, double %401
  br label %408

408:                                              ; preds = %403, %697
  %409 = phi i64 [ %400, %697 ], [ %404, %403 ]
  %410 = phi double [ %401, %697 ], [ %407, %403 ]
  br label %397

411:                                              ; preds = %397
  %412 = load double, ptr %695, align 8, !noalias !5
  %413 = sitofp i64 %400 to double
  %414 = fcmp olt double %412, %413
  br i1 %414, label %415, label %417

415:                                              ; preds = %411
  store double %413, ptr %695, align 8, !noalias !5
  %416 = getelementptr i8, ptr %695, i64 8
  store double 1.000000e+00, ptr %416, align 8, !noalias !5
  br label %420

417:                                              ; preds = %411
  %418 = fcmp ogt double %412, %413
  br i1 %418, label %419, label %420

419:                                              ; preds = %417
  br label %420

420:                                              ; preds = %419, %417, %415
  %421 = phi double [ %401, %415 ], [ 0.000000e+00, %419 ], [ %401, %417 ]
  %422 = getelementptr i8, ptr %695, i64 8
  %423 = load double, ptr %422, align 8, !noalias !5
  %424 = fcmp olt double %421, %423
  %425 = fcmp ogt double %423, 1.000000e-05
  %426 = and i1 %424, %425
  br i1 %426, label %427, label %434

427:                                              ; preds = %420
  store double %421, ptr %422, align 8, !noalias !5
  %428 = getelementptr i8, ptr %695, i64 16
  store double %1, ptr %428, align 8, !noalias !5
  %429 = call i64 @llvm.smax.i64(i64 %57, i64 0)
  br label %430

430:                                              ; preds = %427, %718
  %431 = phi i64 [ 0, %427 ], [ %720, %718 ]
  %432 = phi i64 [ %429, %427 ], [ %719, %718 ]
  %433 = icmp sgt i64 %432, 0
  br i1 %433, label %718, label %434

434:                                              ; preds = %430, %420, %320
  br label %731

435:                                              ; preds = %154, %154
  %436 = inttoptr i64 %55 to ptr
  %437 = getelementptr i8, ptr %436, i64 88
  %438 = load i64, ptr %437, align 8, !noalias !5
  %439 = add nsw i64 %438, 1
  store i64 %439, ptr %437, align 8, !noalias !5
  %440 = call i64 @llvm.smax.i64(i64 %133, i64 0)
  br label %156

441:                                              ; preds = %154
  br label %731

442:                                              ; preds = %156
  %443 = add nsw i64 %158, -1
  %444 = add i64 %157, 1
  br label %160

445:                                              ; preds = %160
  %446 = add nsw i64 %162, -1
  %447 = add i64 %161, 1
  %448 = icmp eq i64 %157, %161
  %449 = select i1 %448, double 1.000000e+00, double 0.000000e+00
  %450 = icmp slt i64 %157, 0
  %451 = select i1 %450, i64 %64, i64 0
  %452 = add i64 %157, %451
  %453 = icmp slt i64 %161, 0
  %454 = select i1 %453, i64 %66, i64 0
  %455 = mul i64 %452, %66
  %456 = getelementptr double, ptr %67, i64 %455
  %457 = getelementptr double, ptr %456, i64 %161
  %458 = getelementptr double, ptr %457, i64 %454
  store double %449, ptr %458, align 8, !noalias !5
  br label %160

459:                                              ; preds = %164
  %460 = add nsw i64 %166, -1
  %461 = add i64 %165, 1
  %462 = icmp eq i64 %165, 9
  %463 = getelementptr i8, ptr %45, i64 8
  %464 = load i64, ptr %463, align 8, !noalias !5
  %465 = inttoptr i64 %464 to ptr
  %466 = call i32 %465(ptr nonnull %21, ptr %58, ptr %26, ptr %48, ptr %53) #3, !noalias !5
  %467 = icmp slt i32 %466, 0
  br i1 %467, label %169, label %170

468:                                              ; preds = %172
  %469 = add nsw i64 %174, -1
  %470 = add i64 %173, 1
  %471 = icmp slt i64 %173, 0
  %472 = select i1 %471, i64 %52, i64 0
  %473 = getelementptr double, ptr %53, i64 %173
  %474 = getelementptr double, ptr %473, i64 %472
  %475 = load double, ptr %474, align 8, !noalias !5
  %476 = fcmp une double %475, 0.000000e+00
  br i1 %476, label %177, label %189

477:                                              ; preds = %207
  store ptr null, ptr %6, align 8, !noalias !5
  %478 = call fastcc i32 @_factor(ptr nonnull %6, ptr %67, i64 %64, i64 %66) #3
  switch i32 %478, label %479 [
    i32 -2, label %239
    i32 0, label %239
  ], !prof !13

479:                                              ; preds = %477
  br label %731

480:                                              ; preds = %241
  %481 = call i64 @llvm.smax.i64(i64 %78, i64 0)
  br label %482

482:                                              ; preds = %486, %480
  %483 = phi i64 [ 0, %480 ], [ %492, %486 ]
  %484 = phi i64 [ %481, %480 ], [ %491, %486 ]
  %485 = icmp sgt i64 %484, 0
  br i1 %485, label %490, label %273

486:                                              ; preds = %494, %490
  %487 = phi i64 [ 0, %490 ], [ %496, %494 ]
  %488 = phi i64 [ %493, %490 ], [ %495, %494 ]
  %489 = icmp sgt i64 %488, 0
  br i1 %489, label %494, label %482

490:                                              ; preds = %482
  %491 = add nsw i64 %484, -1
  %492 = add i64 %483, 1
  %493 = call i64 @llvm.smax.i64(i64 %80, i64 0)
  br label %486

494:                                              ; preds = %486
  %495 = add nsw i64 %488, -1
  %496 = add i64 %487, 1
  %497 = mul nsw i64 %483, %80
  %498 = add nsw i64 %134, %497
  %499 = add nsw i64 %498, %487
  %500 = icmp slt i64 %499, 0
  %501 = select i1 %500, i64 %52, i64 0
  %502 = getelementptr double, ptr %53, i64 %499
  %503 = getelementptr double, ptr %502, i64 %501
  %504 = load double, ptr %503, align 8, !noalias !26
  %505 = icmp slt i64 %483, 0
  %506 = select i1 %505, i64 %78, i64 0
  %507 = add i64 %483, %506
  %508 = icmp slt i64 %487, 0
  %509 = select i1 %508, i64 %80, i64 0
  %510 = mul i64 %507, %80
  %511 = getelementptr double, ptr %81, i64 %510
  %512 = getelementptr double, ptr %511, i64 %487
  %513 = getelementptr double, ptr %512, i64 %509
  store double %504, ptr %513, align 8, !noalias !26
  br label %486

514:                                              ; preds = %273
  %515 = add nsw i64 %275, -1
  %516 = add i64 %274, 1
  br label %277

517:                                              ; preds = %277
  %518 = add nsw i64 %279, -1
  %519 = add i64 %278, 1
  %520 = icmp slt i64 %274, 0
  %521 = select i1 %520, i64 %85, i64 0
  %522 = add i64 %274, %521
  %523 = icmp slt i64 %278, 0
  %524 = select i1 %523, i64 %87, i64 0
  %525 = mul i64 %522, %87
  %526 = getelementptr double, ptr %88, i64 %525
  %527 = getelementptr double, ptr %526, i64 %278
  %528 = getelementptr double, ptr %527, i64 %524
  store double 0.000000e+00, ptr %528, align 8, !noalias !5
  %529 = call i64 @llvm.smax.i64(i64 %131, i64 0)
  br label %281

530:                                              ; preds = %281
  %531 = add nsw i64 %283, -1
  %532 = add i64 %282, 1
  %533 = select i1 %520, i64 %78, i64 0
  %534 = add i64 %274, %533
  %535 = icmp slt i64 %282, 0
  %536 = select i1 %535, i64 %80, i64 0
  %537 = mul i64 %534, %80
  %538 = getelementptr double, ptr %81, i64 %537
  %539 = getelementptr double, ptr %538, i64 %282
  %540 = getelementptr double, ptr %539, i64 %536
  %541 = load double, ptr %540, align 8, !noalias !5
  %542 = select i1 %535, i64 %71, i64 0
  %543 = add i64 %282, %542
  %544 = select i1 %523, i64 %73, i64 0
  %545 = mul i64 %543, %73
  %546 = getelementptr double, ptr %74, i64 %545
  %547 = getelementptr double, ptr %546, i64 %278
  %548 = getelementptr double, ptr %547, i64 %544
  %549 = load double, ptr %548, align 8, !noalias !5
  %550 = fmul double %541, %549
  %551 = load double, ptr %528, align 8, !noalias !5
  %552 = fadd double %551, %550
  store double %552, ptr %528, align 8, !noalias !5
  %553 = call double @llvm.fabs.f64(double %550)
  %554 = fadd double %284, %553
  br label %281

555:                                              ; preds = %296, %296
  %556 = call i64 @llvm.smax.i64(i64 %127, i64 0)
  br label %557

557:                                              ; preds = %561, %555
  %558 = phi i64 [ 0, %555 ], [ %563, %561 ]
  %559 = phi i64 [ %556, %555 ], [ %562, %561 ]
  %560 = icmp sgt i64 %559, 0
  br i1 %560, label %561, label %574

561:                                              ; preds = %557
  %562 = add nsw i64 %559, -1
  %563 = add i64 %558, 1
  %564 = icmp slt i64 %558, 0
  %565 = select i1 %564, i64 %52, i64 0
  %566 = getelementptr double, ptr %53, i64 %558
  %567 = getelementptr double, ptr %566, i64 %565
  %568 = load double, ptr %567, align 8, !noalias !29
  %569 = fneg double %568
  %570 = select i1 %564, i64 %104, i64 0
  %571 = getelementptr double, ptr %105, i64 %558
  %572 = getelementptr double, ptr %571, i64 %570
  store double %569, ptr %572, align 8, !noalias !29
  br label %557

573:                                              ; preds = %296
  br label %731

574:                                              ; preds = %557
  store ptr null, ptr %8, align 8, !noalias !5
  %575 = call fastcc i32 @_minimum_norm(ptr nonnull %8, ptr %88, i64 %85, i64 %87, ptr %100, i64 %99, ptr %105, i64 %104, ptr %110, i64 %109, ptr %115, i64 %114, ptr %120, i64 %119, ptr %125, i64 %124) #3
  switch i32 %575, label %578 [
    i32 -2, label %576
    i32 0, label %576
  ], !prof !13

576:                                              ; preds = %574, %574
  store ptr null, ptr %9, align 8, !noalias !5
  %577 = call fastcc i32 @_divide_transposed(ptr nonnull %9, ptr %67, i64 %64, i64 %66, ptr %100, i64 %99) #3
  switch i32 %577, label %581 [
    i32 -2, label %579
    i32 0, label %579
  ], !prof !13

578:                                              ; preds = %574
  br label %731

579:                                              ; preds = %576, %576
  %580 = call i64 @llvm.smax.i64(i64 %131, i64 0)
  br label %298

581:                                              ; preds = %576
  br label %731

582:                                              ; preds = %298
  %583 = add nsw i64 %300, -1
  %584 = add i64 %299, 1
  br label %302

585:                                              ; preds = %302
  %586 = add nsw i64 %304, -1
  %587 = add i64 %303, 1
  %588 = icmp slt i64 %299, 0
  %589 = select i1 %588, i64 %57, i64 0
  %590 = getelementptr double, ptr %58, i64 %299
  %591 = getelementptr double, ptr %590, i64 %589
  %592 = load double, ptr %591, align 8, !noalias !5
  %593 = select i1 %588, i64 %71, i64 0
  %594 = add i64 %299, %593
  %595 = icmp slt i64 %303, 0
  %596 = select i1 %595, i64 %73, i64 0
  %597 = mul i64 %594, %73
  %598 = getelementptr double, ptr %74, i64 %597
  %599 = getelementptr double, ptr %598, i64 %303
  %600 = getelementptr double, ptr %599, i64 %596
  %601 = load double, ptr %600, align 8, !noalias !5
  %602 = select i1 %595, i64 %99, i64 0
  %603 = getelementptr double, ptr %100, i64 %303
  %604 = getelementptr double, ptr %603, i64 %602
  %605 = load double, ptr %604, align 8, !noalias !5
  %606 = fmul double %601, %605
  %607 = fadd double %592, %606
  store double %607, ptr %591, align 8, !noalias !5
  br label %302

608:                                              ; preds = %306
  %609 = icmp slt i64 %307, 0
  %610 = select i1 %609, i64 %104, i64 0
  %611 = getelementptr double, ptr %105, i64 %307
  %612 = getelementptr double, ptr %611, i64 %610
  %613 = load double, ptr %612, align 8, !noalias !5
  %614 = call double @llvm.fabs.f64(double %613)
  %615 = fcmp ogt double %614, %309
  %616 = select i1 %615, double %614, double %309
  %617 = add i64 %307, 1
  %618 = add nsw i64 %308, -1
  br label %306

619:                                              ; preds = %313, %313
  br label %315

620:                                              ; preds = %313
  br label %731

621:                                              ; preds = %315
  %622 = add nsw i64 %317, -1
  %623 = add i64 %316, 1
  %624 = icmp slt i64 %316, 0
  %625 = select i1 %624, i64 %57, i64 0
  %626 = getelementptr double, ptr %58, i64 %316
  %627 = getelementptr double, ptr %626, i64 %625
  %628 = load double, ptr %627, align 8, !noalias !5
  %629 = select i1 %624, i64 %99, i64 0
  %630 = getelementptr double, ptr %100, i64 %316
  %631 = getelementptr double, ptr %630, i64 %629
  %632 = load double, ptr %631, align 8, !noalias !5
  %633 = fadd double %628, %632
  store double %633, ptr %627, align 8, !noalias !5
  br label %315

634:                                              ; preds = %327
  store ptr null, ptr %11, align 8, !noalias !5
  %635 = call fastcc i32 @_factor(ptr nonnull %11, ptr %67, i64 %64, i64 %66) #3
  switch i32 %635, label %636 [
    i32 -2, label %359
    i32 0, label %359
  ], !prof !13

636:                                              ; preds = %634
  br label %731

637:                                              ; preds = %361
  store ptr null, ptr %12, align 8, !noalias !5
  %638 = call fastcc i32 @_divide_rows(ptr nonnull %12, ptr %95, i64 %92, i64 %94, ptr %67, i64 %64, i64 %66) #3
  switch i32 %638, label %658 [
    i32 -2, label %639
    i32 0, label %639
  ], !prof !13

639:                                              ; preds = %637, %637
  br label %640

640:                                              ; preds = %644, %639
  %641 = phi i64 [ 0, %639 ], [ %646, %644 ]
  %642 = phi i64 [ %129, %639 ], [ %645, %644 ]
  %643 = icmp sgt i64 %642, 0
  br i1 %643, label %644, label %659

644:                                              ; preds = %640
  %645 = add nsw i64 %642, -1
  %646 = add i64 %641, 1
  %647 = add nsw i64 %127, %641
  %648 = icmp slt i64 %647, 0
  %649 = select i1 %648, i64 %52, i64 0
  %650 = getelementptr double, ptr %53, i64 %647
  %651 = getelementptr double, ptr %650, i64 %649
  %652 = load double, ptr %651, align 8, !noalias !32
  %653 = fneg double %652
  %654 = icmp slt i64 %641, 0
  %655 = select i1 %654, i64 %104, i64 0
  %656 = getelementptr double, ptr %105, i64 %641
  %657 = getelementptr double, ptr %656, i64 %655
  store double %653, ptr %657, align 8, !noalias !32
  br label %640

658:                                              ; preds = %637
  br label %731

659:                                              ; preds = %640
  store ptr null, ptr %13, align 8, !noalias !5
  %660 = call fastcc i32 @_minimum_norm(ptr nonnull %13, ptr %95, i64 %92, i64 %94, ptr %100, i64 %99, ptr %105, i64 %104, ptr %110, i64 %109, ptr %115, i64 %114, ptr %120, i64 %119, ptr %125, i64 %124) #3
  switch i32 %660, label %663 [
    i32 -2, label %661
    i32 0, label %661
  ], !prof !13

661:                                              ; preds = %659, %659
  store ptr null, ptr %14, align 8, !noalias !5
  %662 = call fastcc i32 @_divide_transposed(ptr nonnull %14, ptr %67, i64 %64, i64 %66, ptr %100, i64 %99) #3
  switch i32 %662, label %665 [
    i32 -2, label %664
    i32 0, label %664
  ], !prof !13

663:                                              ; preds = %659
  br label %731

664:                                              ; preds = %661, %661
  br label %393

665:                                              ; preds = %661
  br label %731

666:                                              ; preds = %393
  %667 = add nsw i64 %395, -1
  %668 = add i64 %394, 1
  %669 = add nsw i64 %131, %394
  %670 = icmp slt i64 %669, 0
  %671 = select i1 %670, i64 %57, i64 0
  %672 = getelementptr double, ptr %58, i64 %669
  %673 = getelementptr double, ptr %672, i64 %671
  %674 = load double, ptr %673, align 8, !noalias !5
  %675 = icmp slt i64 %394, 0
  %676 = select i1 %675, i64 %99, i64 0
  %677 = getelementptr double, ptr %100, i64 %394
  %678 = getelementptr double, ptr %677, i64 %676
  %679 = load double, ptr %678, align 8, !noalias !5
  %680 = fadd double %674, %679
  store double %680, ptr %673, align 8, !noalias !5
  br label %393

681:                                              ; preds = %393
  %682 = icmp slt i64 %146, 0
  %683 = select i1 %682, i64 %52, i64 0
  %684 = add i64 %146, %683
  %685 = icmp slt i64 %684, 0
  br i1 %685, label %686, label %687, !prof !0

686:                                              ; preds = %681
  br label %687

687:                                              ; preds = %686, %681
  %688 = phi i64 [ 0, %686 ], [ %684, %681 ]
  %689 = icmp slt i64 %684, %52
  br i1 %689, label %691, label %690, !prof !4

690:                                              ; preds = %687
  br label %691

691:                                              ; preds = %690, %687
  %692 = phi i64 [ %52, %690 ], [ %688, %687 ]
  %693 = sub i64 %52, %692
  %694 = call i64 @llvm.smax.i64(i64 %693, i64 0)
  %695 = getelementptr double, ptr %53, i64 %692
  %696 = add nsw i64 %57, 3
  br label %397

697:                                              ; preds = %397
  %698 = add nsw i64 %399, -1
  %699 = add i64 %398, 1
  %700 = add nsw i64 %696, %398
  %701 = icmp slt i64 %700, 0
  %702 = select i1 %701, i64 %694, i64 0
  %703 = getelementptr double, ptr %695, i64 %700
  %704 = getelementptr double, ptr %703, i64 %702
  %705 = load double, ptr %704, align 8, !noalias !5
  %706 = icmp slt i64 %398, 0
  %707 = select i1 %706, i64 %119, i64 0
  %708 = getelementptr double, ptr %120, i64 %398
  %709 = getelementptr double, ptr %708, i64 %707
  %710 = load double, ptr %709, align 8, !noalias !5
  %711 = fcmp ogt double %710, %705
  %712 = select i1 %711, double %710, double %705
  store double %712, ptr %704, align 8, !noalias !5
  %713 = select i1 %706, i64 %124, i64 0
  %714 = getelementptr double, ptr %125, i64 %398
  %715 = getelementptr double, ptr %714, i64 %713
  %716 = load double, ptr %715, align 8, !noalias !5
  %717 = fcmp ogt double %716, 0.000000e+00
  br i1 %717, label %403, label %408

718:                                              ; preds = %430
  %719 = add nsw i64 %432, -1
  %720 = add i64 %431, 1
  %721 = icmp slt i64 %431, 0
  %722 = select i1 %721, i64 %57, i64 0
  %723 = getelementptr double, ptr %58, i64 %431
  %724 = getelementptr double, ptr %723, i64 %722
  %725 = load double, ptr %724, align 8, !noalias !5
  %726 = icmp slt i64 %431, -3
  %727 = select i1 %726, i64 %694, i64 0
  %728 = getelementptr double, ptr %695, i64 %431
  %729 = getelementptr i8, ptr %728, i64 24
  %730 = getelementptr double, ptr %729, i64 %727
  store double %725, ptr %730, align 8, !noalias !5
  br label %430

731:                                              ; preds = %665, %663, %658, %636, %620, %581, %578, %573, %479, %441, %434, %201, %192, %169
  %732 = phi i64 [ 0, %441 ], [ 0, %581 ], [ 0, %620 ], [ 6, %201 ], [ 6, %169 ], [ 0, %573 ], [ 0, %479 ], [ 6, %192 ], [ 0, %665 ], [ 0, %636 ], [ 0, %578 ], [ 0, %658 ], [ 0, %434 ], [ 0, %663 ]
  ret i64 %732
}



declare i64 @llvm.smax.i64(i64, i64) #0

attributes #0 = { nounwind willreturn memory(none) }
attributes #1 = { noinline }
attributes #2 = { nounwind memory(read) }
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
!9 = !{!10, !12}
!10 = distinct !{!10, !11}
!11 = distinct !{!11}
!12 = distinct !{!12, !11}
!13 = !{!"branch_weights", i32 1, i32 49, i32 49}
!14 = !{!15}
!15 = distinct !{!15, !16}
!16 = distinct !{!16}
!17 = !{!18}
!18 = distinct !{!18, !19}
!19 = distinct !{!19}
!20 = !{!21}
!21 = distinct !{!21, !22}
!22 = distinct !{!22}
!23 = !{!24}
!24 = distinct !{!24, !25}
!25 = distinct !{!25}
!26 = !{!27}
!27 = distinct !{!27, !28}
!28 = distinct !{!28}
!29 = !{!30}
!30 = distinct !{!30, !31}
!31 = distinct !{!31}
!32 = !{!33}
!33 = distinct !{!33, !34}
!34 = distinct !{!34}
