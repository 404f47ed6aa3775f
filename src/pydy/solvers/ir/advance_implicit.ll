; sources e1a63d9ec692563f214eb01d118d8a8e642ed8a008a9c5b81038f2f662212ca6
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

@0 = internal unnamed_addr constant [24 x i8] c"\EA\CAWF\B6\D8\C3?\DF\A6\03\08l\A3\E4?\00\00\00\00\00\00\F0?", align 8
@1 = internal unnamed_addr constant [72 x i8] c"F\9C\A7\01\02\B7\10@\86N\A8]\C1\F8\D4?\EFV\9D\F5\7F\BF\E0?F\9C\A7\01\02\B7\10\C0\86N\A8]\C1\F8\D4\BF!R\C5\14\00\81\DE?\F2\A7$Z\88\17\E0?\98\A5\CAoN\93\04\C0\D1\DF{\CF\C0\12\E3?", align 8
@2 = internal unnamed_addr constant [72 x i8] c"F\9C\A7\01\02\B7\10@\86N\A8]\C1\F8\D4?\EFV\9D\F5\7F\BF\E0?F\9C\A7\01\02\B7\10\C0\86N\A8]\C1\F8\D4\BF!R\C5\14\00\81\DE?\F2\A7$Z\88\17\E0?\98\A5\CAoN\93\04\C0\D1\DF{\CF\C0\12\E3?", align 8
@3 = internal unnamed_addr constant [72 x i8] c"F\9C\A7\01\02\B7\10@\86N\A8]\C1\F8\D4?\EFV\9D\F5\7F\BF\E0?F\9C\A7\01\02\B7\10\C0\86N\A8]\C1\F8\D4\BF!R\C5\14\00\81\DE?\F2\A7$Z\88\17\E0?\98\A5\CAoN\93\04\C0\D1\DF{\CF\C0\12\E3?", align 8
@4 = internal unnamed_addr constant [24 x i8] c"\EA\CAWF\B6\D8\C3?\DF\A6\03\08l\A3\E4?\00\00\00\00\00\00\F0?", align 8
@5 = internal unnamed_addr constant [72 x i8] c"{g]\84#-\B8?\F7;@L\A7\14\C2\BF\8Ehm\1A\F9\BF\9E?\ED\A1\0A\E7}\03\D0?Q\B5 \1E\E9 \CA?\EDm\A3\A2\1F\82\D8\BF\00\00\00\00\00\00\F0?\00\00\00\00\00\00\F0?\00\00\00\00\00\00\00\00", align 8
@6 = internal unnamed_addr constant [72 x i8] c"{g]\84#-\B8?\F7;@L\A7\14\C2\BF\8Ehm\1A\F9\BF\9E?\ED\A1\0A\E7}\03\D0?Q\B5 \1E\E9 \CA?\EDm\A3\A2\1F\82\D8\BF\00\00\00\00\00\00\F0?\00\00\00\00\00\00\F0?\00\00\00\00\00\00\00\00", align 8
@7 = internal unnamed_addr constant [72 x i8] c"{g]\84#-\B8?\F7;@L\A7\14\C2\BF\8Ehm\1A\F9\BF\9E?\ED\A1\0A\E7}\03\D0?Q\B5 \1E\E9 \CA?\EDm\A3\A2\1F\82\D8\BF\00\00\00\00\00\00\F0?\00\00\00\00\00\00\F0?\00\00\00\00\00\00\00\00", align 8

declare double @llvm.fabs.f64(double) #0

declare double @sqrt(double) local_unnamed_addr #1

declare double @llvm.pow.f64(double, double) #0

define internal fastcc i32 @_sample(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, i64 %5, ptr %6, i64 %7, ptr %8, i64 %9, i64 %10, double %11) unnamed_addr #2 {
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
  br i1 %35, label %77, label %78, !prof !4

36:                                               ; preds = %92, %89
  %37 = phi i64 [ %7, %92 ], [ %90, %89 ]
  %38 = sub i64 %37, %83
  %39 = call i64 @llvm.smax.i64(i64 %38, i64 0)
  %40 = getelementptr double, ptr %6, i64 %83
  %41 = load double, ptr %40, align 8, !noalias !0
  %42 = fcmp ogt double %41, %11
  %43 = select i1 %42, double %41, double %11
  %44 = icmp slt i64 %26, 0
  %45 = select i1 %44, i64 %39, i64 0
  %46 = getelementptr double, ptr %40, i64 %26
  %47 = getelementptr double, ptr %46, i64 %45
  %48 = load double, ptr %47, align 8, !noalias !5
  %49 = fcmp ugt double %48, %43
  br i1 %49, label %60, label %50

50:                                               ; preds = %36
  %51 = add nsw i64 %39, -1
  %52 = icmp eq i64 %26, %51
  br i1 %52, label %93, label %53

53:                                               ; preds = %50
  %54 = icmp slt i64 %26, -1
  %55 = select i1 %54, i64 %39, i64 0
  %56 = getelementptr i8, ptr %46, i64 8
  %57 = getelementptr double, ptr %56, i64 %55
  %58 = load double, ptr %57, align 8, !noalias !5
  %59 = fcmp olt double %43, %58
  br i1 %59, label %93, label %60

60:                                               ; preds = %53, %36
  %61 = icmp sgt i64 %38, 1
  br i1 %61, label %62, label %93

62:                                               ; preds = %62, %60
  %63 = phi i64 [ %73, %62 ], [ %39, %60 ]
  %64 = phi i64 [ %74, %62 ], [ 0, %60 ]
  %65 = add nsw i64 %64, %63
  %66 = ashr i64 %65, 1
  %67 = icmp slt i64 %66, 0
  %68 = select i1 %67, i64 %39, i64 0
  %69 = getelementptr double, ptr %40, i64 %66
  %70 = getelementptr double, ptr %69, i64 %68
  %71 = load double, ptr %70, align 8, !noalias !5
  %72 = fcmp ole double %71, %43
  %73 = select i1 %72, i64 %63, i64 %66
  %74 = select i1 %72, i64 %66, i64 %64
  %75 = sub nsw i64 %73, %74
  %76 = icmp sgt i64 %75, 1
  br i1 %76, label %62, label %93

77:                                               ; preds = %19
  br label %78

78:                                               ; preds = %77, %19
  %79 = phi i64 [ 0, %77 ], [ %34, %19 ]
  %80 = icmp slt i64 %34, %7
  br i1 %80, label %82, label %81, !prof !8

81:                                               ; preds = %78
  br label %82

82:                                               ; preds = %81, %78
  %83 = phi i64 [ %7, %81 ], [ %79, %78 ]
  %84 = icmp slt i64 %31, 0
  %85 = select i1 %84, i64 %7, i64 0
  %86 = add i64 %31, %85
  %87 = icmp slt i64 %86, 0
  br i1 %87, label %88, label %89, !prof !4

88:                                               ; preds = %82
  br label %89

89:                                               ; preds = %88, %82
  %90 = phi i64 [ 0, %88 ], [ %86, %82 ]
  %91 = icmp slt i64 %86, %7
  br i1 %91, label %36, label %92, !prof !8

92:                                               ; preds = %89
  br label %36

93:                                               ; preds = %62, %60, %53, %50
  %94 = phi i64 [ %26, %50 ], [ %26, %53 ], [ %74, %62 ], [ 0, %60 ]
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

define internal fastcc i32 @norm(ptr noalias %0, ptr %1, ptr %2, ptr %3, ptr %4, i64 %5, ptr %6, i64 %7, i64 %8) unnamed_addr #2 {
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

declare double @llvm.sqrt.f64(double) #0

declare double @hypot(double, double) local_unnamed_addr

define internal fastcc i32 @solve(ptr noalias %0, ptr %1, i64 %2, i64 %3, ptr %4, i64 %5, ptr %6, i64 %7) unnamed_addr {
  %9 = call i64 @llvm.smax.i64(i64 %2, i64 0)
  br label %10

10:                                               ; preds = %8, %24
  %11 = phi i64 [ 0, %8 ], [ %61, %24 ]
  %12 = phi i64 [ %9, %8 ], [ %60, %24 ]
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %59, label %25

14:                                               ; preds = %59
  %15 = icmp slt i64 %66, 0
  %16 = select i1 %15, i64 %7, i64 0
  %17 = getelementptr double, ptr %6, i64 %66
  %18 = getelementptr double, ptr %17, i64 %16
  %19 = load double, ptr %18, align 8
  %20 = select i1 %62, i64 %7, i64 0
  %21 = getelementptr double, ptr %6, i64 %11
  %22 = getelementptr double, ptr %21, i64 %20
  %23 = load double, ptr %22, align 8
  store double %19, ptr %22, align 8
  store double %23, ptr %18, align 8
  br label %24

24:                                               ; preds = %14, %59
  br label %10

25:                                               ; preds = %10, %34
  %26 = phi i64 [ %70, %34 ], [ 0, %10 ]
  %27 = phi i64 [ %69, %34 ], [ %9, %10 ]
  %28 = icmp sgt i64 %27, 0
  br i1 %28, label %68, label %35

29:                                               ; preds = %68, %77
  %30 = phi i64 [ 0, %68 ], [ %79, %77 ]
  %31 = phi i64 [ %76, %68 ], [ %78, %77 ]
  %32 = phi double [ %75, %68 ], [ %94, %77 ]
  %33 = icmp sgt i64 %31, 0
  br i1 %33, label %77, label %34

34:                                               ; preds = %29
  store double %32, ptr %74, align 8
  br label %25

35:                                               ; preds = %25
  %36 = icmp ugt i64 %2, -9223372036854775808
  %37 = select i1 %36, i64 0, i64 %2
  br label %38

38:                                               ; preds = %35, %48
  %39 = phi i64 [ %2, %35 ], [ %41, %48 ]
  %40 = phi i64 [ %37, %35 ], [ %96, %48 ]
  %41 = add i64 %39, -1
  %42 = icmp sgt i64 %40, 0
  br i1 %42, label %95, label %58

43:                                               ; preds = %95, %104
  %44 = phi i64 [ %39, %95 ], [ %106, %104 ]
  %45 = phi i64 [ %103, %95 ], [ %105, %104 ]
  %46 = phi double [ %101, %95 ], [ %121, %104 ]
  %47 = icmp sgt i64 %45, 0
  br i1 %47, label %104, label %48

48:                                               ; preds = %43
  %49 = select i1 %97, i64 %2, i64 0
  %50 = add i64 %41, %49
  %51 = select i1 %97, i64 %3, i64 0
  %52 = mul i64 %50, %3
  %53 = getelementptr double, ptr %1, i64 %52
  %54 = getelementptr double, ptr %53, i64 %41
  %55 = getelementptr double, ptr %54, i64 %51
  %56 = load double, ptr %55, align 8
  %57 = fdiv double %46, %56
  store double %57, ptr %100, align 8
  br label %38

58:                                               ; preds = %38
  store ptr null, ptr %0, align 8
  ret i32 0

59:                                               ; preds = %10
  %60 = add nsw i64 %12, -1
  %61 = add i64 %11, 1
  %62 = icmp slt i64 %11, 0
  %63 = select i1 %62, i64 %5, i64 0
  %64 = getelementptr i64, ptr %4, i64 %11
  %65 = getelementptr i64, ptr %64, i64 %63
  %66 = load i64, ptr %65, align 8
  %67 = icmp eq i64 %66, %11
  br i1 %67, label %24, label %14

68:                                               ; preds = %25
  %69 = add nsw i64 %27, -1
  %70 = add i64 %26, 1
  %71 = icmp slt i64 %26, 0
  %72 = select i1 %71, i64 %7, i64 0
  %73 = getelementptr double, ptr %6, i64 %26
  %74 = getelementptr double, ptr %73, i64 %72
  %75 = load double, ptr %74, align 8
  %76 = call i64 @llvm.smax.i64(i64 %26, i64 0)
  br label %29

77:                                               ; preds = %29
  %78 = add nsw i64 %31, -1
  %79 = add i64 %30, 1
  %80 = select i1 %71, i64 %2, i64 0
  %81 = add i64 %26, %80
  %82 = icmp slt i64 %30, 0
  %83 = select i1 %82, i64 %3, i64 0
  %84 = mul i64 %81, %3
  %85 = getelementptr double, ptr %1, i64 %84
  %86 = getelementptr double, ptr %85, i64 %30
  %87 = getelementptr double, ptr %86, i64 %83
  %88 = load double, ptr %87, align 8
  %89 = select i1 %82, i64 %7, i64 0
  %90 = getelementptr double, ptr %6, i64 %30
  %91 = getelementptr double, ptr %90, i64 %89
  %92 = load double, ptr %91, align 8
  %93 = fmul double %88, %92
  %94 = fsub double %32, %93
  br label %29

95:                                               ; preds = %38
  %96 = add nsw i64 %40, -1
  %97 = icmp slt i64 %41, 0
  %98 = select i1 %97, i64 %7, i64 0
  %99 = getelementptr double, ptr %6, i64 %41
  %100 = getelementptr double, ptr %99, i64 %98
  %101 = load double, ptr %100, align 8
  %102 = sub i64 %2, %39
  %103 = call i64 @llvm.smax.i64(i64 %102, i64 0)
  br label %43

104:                                              ; preds = %43
  %105 = add nsw i64 %45, -1
  %106 = add i64 %44, 1
  %107 = select i1 %97, i64 %2, i64 0
  %108 = add i64 %41, %107
  %109 = icmp slt i64 %44, 0
  %110 = select i1 %109, i64 %3, i64 0
  %111 = mul i64 %108, %3
  %112 = getelementptr double, ptr %1, i64 %111
  %113 = getelementptr double, ptr %112, i64 %44
  %114 = getelementptr double, ptr %113, i64 %110
  %115 = load double, ptr %114, align 8
  %116 = select i1 %109, i64 %7, i64 0
  %117 = getelementptr double, ptr %6, i64 %44
  %118 = getelementptr double, ptr %117, i64 %116
  %119 = load double, ptr %118, align 8
  %120 = fmul double %115, %119
  %121 = fsub double %46, %120
  br label %43
}

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

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #0

define i64 @advance_implicit(i64 %0, i64 %1, i64 %2) local_unnamed_addr #3 {
  %4 = alloca ptr, align 8
  %5 = alloca ptr, align 8
  %6 = alloca ptr, align 8
  %7 = alloca double, align 8
  %8 = alloca ptr, align 8
  %9 = alloca double, align 8
  %10 = alloca ptr, align 8
  %11 = alloca ptr, align 8
  %12 = alloca ptr, align 8
  %13 = alloca ptr, align 8
  %14 = alloca ptr, align 8
  %15 = alloca ptr, align 8
  %16 = alloca ptr, align 8
  %17 = alloca ptr, align 8
  %18 = alloca ptr, align 8
  %19 = alloca ptr, align 8
  %20 = alloca ptr, align 8
  %21 = alloca double, align 8
  %22 = alloca double, align 8
  %23 = alloca i8, align 1
  %24 = alloca i8, align 1
  store i8 0, ptr %23, align 1, !noalias !12
  store i8 0, ptr %24, align 1, !noalias !12
  %25 = inttoptr i64 %0 to ptr
  %26 = load i64, ptr %25, align 8, !noalias !16
  %27 = inttoptr i64 %26 to ptr
  %28 = getelementptr i8, ptr %25, i64 144
  %29 = load i64, ptr %28, align 8, !noalias !16
  %30 = inttoptr i64 %29 to ptr
  %31 = getelementptr i8, ptr %25, i64 168
  %32 = load i64, ptr %31, align 8, !noalias !16
  %33 = inttoptr i64 %32 to ptr
  %34 = getelementptr i8, ptr %25, i64 192
  %35 = load i64, ptr %34, align 8, !noalias !16
  %36 = getelementptr i8, ptr %25, i64 200
  %37 = load i64, ptr %36, align 8, !noalias !16
  %38 = inttoptr i64 %35 to ptr
  %39 = getelementptr i8, ptr %25, i64 216
  %40 = load i64, ptr %39, align 8, !noalias !16
  %41 = inttoptr i64 %40 to ptr
  %42 = getelementptr i8, ptr %25, i64 240
  %43 = load i64, ptr %42, align 8, !noalias !16
  %44 = getelementptr i8, ptr %25, i64 248
  %45 = load i64, ptr %44, align 8, !noalias !16
  %46 = getelementptr i8, ptr %25, i64 256
  %47 = load i64, ptr %46, align 8, !noalias !16
  %48 = inttoptr i64 %43 to ptr
  %49 = getelementptr i8, ptr %25, i64 264
  %50 = load i64, ptr %49, align 8, !noalias !16
  %51 = getelementptr i8, ptr %25, i64 272
  %52 = load i64, ptr %51, align 8, !noalias !16
  %53 = inttoptr i64 %50 to ptr
  %54 = getelementptr i8, ptr %25, i64 288
  %55 = load i64, ptr %54, align 8, !noalias !16
  %56 = getelementptr i8, ptr %25, i64 296
  %57 = load i64, ptr %56, align 8, !noalias !16
  %58 = getelementptr i8, ptr %25, i64 304
  %59 = load i64, ptr %58, align 8, !noalias !16
  %60 = inttoptr i64 %55 to ptr
  %61 = getelementptr i8, ptr %25, i64 312
  %62 = load i64, ptr %61, align 8, !noalias !16
  %63 = getelementptr i8, ptr %25, i64 320
  %64 = load i64, ptr %63, align 8, !noalias !16
  %65 = inttoptr i64 %62 to ptr
  %66 = getelementptr i8, ptr %25, i64 336
  %67 = load i64, ptr %66, align 8, !noalias !16
  %68 = getelementptr i8, ptr %25, i64 344
  %69 = load i64, ptr %68, align 8, !noalias !16
  %70 = inttoptr i64 %67 to ptr
  %71 = getelementptr i8, ptr %25, i64 360
  %72 = load i64, ptr %71, align 8, !noalias !16
  %73 = getelementptr i8, ptr %25, i64 368
  %74 = load i64, ptr %73, align 8, !noalias !16
  %75 = inttoptr i64 %72 to ptr
  %76 = getelementptr i8, ptr %25, i64 408
  %77 = load i64, ptr %76, align 8, !noalias !16
  %78 = getelementptr i8, ptr %25, i64 416
  %79 = load i64, ptr %78, align 8, !noalias !16
  %80 = inttoptr i64 %77 to ptr
  %81 = getelementptr i8, ptr %25, i64 480
  %82 = load i64, ptr %81, align 8, !noalias !16
  %83 = getelementptr i8, ptr %25, i64 488
  %84 = load i64, ptr %83, align 8, !noalias !16
  %85 = inttoptr i64 %82 to ptr
  %86 = getelementptr i8, ptr %25, i64 504
  %87 = load i64, ptr %86, align 8, !noalias !16
  %88 = getelementptr i8, ptr %25, i64 512
  %89 = load i64, ptr %88, align 8, !noalias !16
  %90 = inttoptr i64 %87 to ptr
  %91 = getelementptr i8, ptr %25, i64 528
  %92 = load i64, ptr %91, align 8, !noalias !16
  %93 = getelementptr i8, ptr %25, i64 536
  %94 = load i64, ptr %93, align 8, !noalias !16
  %95 = inttoptr i64 %92 to ptr
  %96 = getelementptr i8, ptr %25, i64 552
  %97 = load i64, ptr %96, align 8, !noalias !16
  %98 = getelementptr i8, ptr %25, i64 560
  %99 = load i64, ptr %98, align 8, !noalias !16
  %100 = inttoptr i64 %97 to ptr
  %101 = getelementptr i8, ptr %25, i64 576
  %102 = load i64, ptr %101, align 8, !noalias !16
  %103 = getelementptr i8, ptr %25, i64 584
  %104 = load i64, ptr %103, align 8, !noalias !16
  %105 = inttoptr i64 %102 to ptr
  %106 = getelementptr i8, ptr %25, i64 600
  %107 = load i64, ptr %106, align 8, !noalias !16
  %108 = getelementptr i8, ptr %25, i64 608
  %109 = load i64, ptr %108, align 8, !noalias !16
  %110 = inttoptr i64 %107 to ptr
  %111 = getelementptr i8, ptr %25, i64 624
  %112 = load i64, ptr %111, align 8, !noalias !16
  %113 = getelementptr i8, ptr %25, i64 632
  %114 = load i64, ptr %113, align 8, !noalias !16
  %115 = inttoptr i64 %112 to ptr
  %116 = getelementptr i8, ptr %30, i64 8
  %117 = load i64, ptr %116, align 8, !noalias !16
  %118 = mul nsw i64 %114, %117
  %119 = inttoptr i64 %1 to ptr
  %120 = icmp eq i64 %2, 1
  br i1 %120, label %121, label %154

121:                                              ; preds = %3
  %122 = getelementptr i8, ptr %25, i64 984
  %123 = load i64, ptr %122, align 8, !noalias !16
  %124 = getelementptr i8, ptr %25, i64 992
  %125 = load i64, ptr %124, align 8, !noalias !16
  %126 = inttoptr i64 %123 to ptr
  %127 = getelementptr i8, ptr %25, i64 1008
  %128 = load i64, ptr %127, align 8, !noalias !16
  %129 = getelementptr i8, ptr %25, i64 1016
  %130 = load i64, ptr %129, align 8, !noalias !16
  %131 = inttoptr i64 %128 to ptr
  %132 = call i64 @llvm.smax.i64(i64 %117, i64 0)
  br label %133

133:                                              ; preds = %164, %121
  %134 = phi i64 [ 0, %121 ], [ %166, %164 ]
  %135 = phi i64 [ %132, %121 ], [ %165, %164 ]
  %136 = icmp sgt i64 %135, 0
  br i1 %136, label %164, label %137

137:                                              ; preds = %133
  %138 = call i64 @llvm.smax.i64(i64 %104, i64 0)
  br label %139

139:                                              ; preds = %143, %137
  %140 = phi i64 [ 0, %137 ], [ %145, %143 ]
  %141 = phi i64 [ %138, %137 ], [ %144, %143 ]
  %142 = icmp sgt i64 %141, 0
  br i1 %142, label %143, label %175

143:                                              ; preds = %139
  %144 = add nsw i64 %141, -1
  %145 = add i64 %140, 1
  %146 = icmp slt i64 %140, 0
  %147 = select i1 %146, i64 %125, i64 0
  %148 = getelementptr double, ptr %126, i64 %140
  %149 = getelementptr double, ptr %148, i64 %147
  %150 = load double, ptr %149, align 8, !noalias !19
  %151 = select i1 %146, i64 %104, i64 0
  %152 = getelementptr double, ptr %105, i64 %140
  %153 = getelementptr double, ptr %152, i64 %151
  store double %150, ptr %153, align 8, !noalias !19
  br label %139

154:                                              ; preds = %177, %3
  %155 = getelementptr i8, ptr %25, i64 648
  %156 = load i64, ptr %155, align 8, !noalias !16
  %157 = inttoptr i64 %156 to ptr
  %158 = getelementptr i8, ptr %25, i64 720
  %159 = load i64, ptr %158, align 8, !noalias !16
  %160 = inttoptr i64 %159 to ptr
  %161 = getelementptr i8, ptr %110, i64 56
  %162 = load i64, ptr %161, align 8, !noalias !12
  %163 = icmp eq i64 %162, 0
  br i1 %163, label %192, label %193

164:                                              ; preds = %133
  %165 = add nsw i64 %135, -1
  %166 = add i64 %134, 1
  %167 = icmp slt i64 %134, 0
  %168 = select i1 %167, i64 %118, i64 0
  %169 = getelementptr double, ptr %119, i64 %134
  %170 = getelementptr double, ptr %169, i64 %168
  %171 = load double, ptr %170, align 8, !noalias !16
  %172 = select i1 %167, i64 %64, i64 0
  %173 = getelementptr double, ptr %65, i64 %134
  %174 = getelementptr double, ptr %173, i64 %172
  store double %171, ptr %174, align 8, !noalias !16
  br label %133

175:                                              ; preds = %139
  %176 = call i64 @llvm.smax.i64(i64 %109, i64 0)
  br label %177

177:                                              ; preds = %181, %175
  %178 = phi i64 [ 0, %175 ], [ %183, %181 ]
  %179 = phi i64 [ %176, %175 ], [ %182, %181 ]
  %180 = icmp sgt i64 %179, 0
  br i1 %180, label %181, label %154

181:                                              ; preds = %177
  %182 = add nsw i64 %179, -1
  %183 = add i64 %178, 1
  %184 = icmp slt i64 %178, 0
  %185 = select i1 %184, i64 %130, i64 0
  %186 = getelementptr i64, ptr %131, i64 %178
  %187 = getelementptr i64, ptr %186, i64 %185
  %188 = load i64, ptr %187, align 8, !noalias !22
  %189 = select i1 %184, i64 %109, i64 0
  %190 = getelementptr i64, ptr %110, i64 %178
  %191 = getelementptr i64, ptr %190, i64 %189
  store i64 %188, ptr %191, align 8, !noalias !22
  br label %177

192:                                              ; preds = %154
  br label %2632

193:                                              ; preds = %154
  %194 = getelementptr i8, ptr %25, i64 1032
  %195 = load i64, ptr %194, align 8, !noalias !12
  %196 = inttoptr i64 %195 to ptr
  %197 = getelementptr i8, ptr %25, i64 1056
  %198 = load i64, ptr %197, align 8, !noalias !12
  %199 = inttoptr i64 %198 to ptr
  %200 = getelementptr i8, ptr %25, i64 1080
  %201 = load i64, ptr %200, align 8, !noalias !12
  %202 = inttoptr i64 %201 to ptr
  %203 = getelementptr i8, ptr %25, i64 1104
  %204 = load i64, ptr %203, align 8, !noalias !12
  %205 = getelementptr i8, ptr %25, i64 1112
  %206 = load i64, ptr %205, align 8, !noalias !12
  %207 = inttoptr i64 %204 to ptr
  %208 = getelementptr i8, ptr %25, i64 1128
  %209 = load i64, ptr %208, align 8, !noalias !12
  %210 = getelementptr i8, ptr %25, i64 1136
  %211 = load i64, ptr %210, align 8, !noalias !12
  %212 = getelementptr i8, ptr %25, i64 1144
  %213 = load i64, ptr %212, align 8, !noalias !12
  %214 = inttoptr i64 %209 to ptr
  %215 = getelementptr i8, ptr %25, i64 1152
  %216 = load i64, ptr %215, align 8, !noalias !12
  %217 = getelementptr i8, ptr %25, i64 1160
  %218 = load i64, ptr %217, align 8, !noalias !12
  %219 = getelementptr i8, ptr %25, i64 1168
  %220 = load i64, ptr %219, align 8, !noalias !12
  %221 = inttoptr i64 %216 to ptr
  %222 = getelementptr i8, ptr %25, i64 1176
  %223 = load i64, ptr %222, align 8, !noalias !12
  %224 = getelementptr i8, ptr %25, i64 1184
  %225 = load i64, ptr %224, align 8, !noalias !12
  %226 = inttoptr i64 %223 to ptr
  %227 = getelementptr i8, ptr %25, i64 1200
  %228 = load i64, ptr %227, align 8, !noalias !12
  %229 = getelementptr i8, ptr %25, i64 1208
  %230 = load i64, ptr %229, align 8, !noalias !12
  %231 = inttoptr i64 %228 to ptr
  %232 = getelementptr i8, ptr %25, i64 1224
  %233 = load i64, ptr %232, align 8, !noalias !12
  %234 = getelementptr i8, ptr %25, i64 1232
  %235 = load i64, ptr %234, align 8, !noalias !12
  %236 = getelementptr i8, ptr %25, i64 1240
  %237 = load i64, ptr %236, align 8, !noalias !12
  %238 = inttoptr i64 %233 to ptr
  %239 = getelementptr i8, ptr %25, i64 1248
  %240 = load i64, ptr %239, align 8, !noalias !12
  %241 = getelementptr i8, ptr %25, i64 1256
  %242 = load i64, ptr %241, align 8, !noalias !12
  %243 = getelementptr i8, ptr %25, i64 1264
  %244 = load i64, ptr %243, align 8, !noalias !12
  %245 = inttoptr i64 %240 to ptr
  %246 = getelementptr i8, ptr %25, i64 1272
  %247 = load i64, ptr %246, align 8, !noalias !12
  %248 = getelementptr i8, ptr %25, i64 1288
  %249 = load i64, ptr %248, align 8, !noalias !12
  %250 = inttoptr i64 %247 to ptr
  %251 = getelementptr i8, ptr %25, i64 1296
  %252 = load i64, ptr %251, align 8, !noalias !12
  %253 = getelementptr i8, ptr %25, i64 1304
  %254 = load i64, ptr %253, align 8, !noalias !12
  %255 = getelementptr i8, ptr %25, i64 1312
  %256 = load i64, ptr %255, align 8, !noalias !12
  %257 = inttoptr i64 %252 to ptr
  %258 = getelementptr i8, ptr %25, i64 1320
  %259 = load i64, ptr %258, align 8, !noalias !12
  %260 = getelementptr i8, ptr %25, i64 1328
  %261 = load i64, ptr %260, align 8, !noalias !12
  %262 = inttoptr i64 %259 to ptr
  %263 = getelementptr i8, ptr %25, i64 1344
  %264 = load i64, ptr %263, align 8, !noalias !12
  %265 = getelementptr i8, ptr %25, i64 1352
  %266 = load i64, ptr %265, align 8, !noalias !12
  %267 = inttoptr i64 %264 to ptr
  %268 = getelementptr i8, ptr %25, i64 1368
  %269 = load i64, ptr %268, align 8, !noalias !12
  %270 = getelementptr i8, ptr %25, i64 1376
  %271 = load i64, ptr %270, align 8, !noalias !12
  %272 = inttoptr i64 %269 to ptr
  %273 = load i64, ptr %116, align 8, !noalias !12
  %274 = load i64, ptr %157, align 8, !noalias !12
  %275 = icmp eq i64 %274, 1
  %276 = call i64 @llvm.smin.i64(i64 %114, i64 0)
  %277 = getelementptr double, ptr %115, i64 %114
  %278 = getelementptr i8, ptr %277, i64 -8
  %279 = getelementptr double, ptr %278, i64 %276
  %280 = load double, ptr %279, align 8, !noalias !12
  %281 = load double, ptr %95, align 8, !noalias !12
  %282 = call i64 @llvm.smax.i64(i64 %273, i64 0)
  br label %283

283:                                              ; preds = %2324, %193
  %284 = phi i64 [ 0, %193 ], [ %2332, %2324 ]
  %285 = phi i64 [ %282, %193 ], [ %2333, %2324 ]
  %286 = phi double [ %281, %193 ], [ %2331, %2324 ]
  %287 = icmp sgt i64 %285, 0
  br i1 %287, label %2324, label %288

288:                                              ; preds = %283
  %289 = fcmp olt double %286, 0x3CB0000000000000
  %290 = select i1 %289, double 0x3CB0000000000000, double %286
  %291 = call double @sqrt(double %286), !noalias !12
  %292 = fcmp olt double %291, 3.000000e-02
  %293 = select i1 %292, double %291, double 3.000000e-02
  %294 = fdiv double 0x3CE4000000000000, %290
  %295 = fcmp ogt double %293, %294
  %296 = select i1 %295, double %293, double %294
  %297 = load double, ptr %105, align 8, !noalias !12
  %298 = getelementptr i8, ptr %105, i64 8
  %299 = load double, ptr %298, align 8, !noalias !12
  %300 = load i64, ptr %110, align 8, !noalias !12
  %301 = icmp eq i64 %300, 0
  br i1 %301, label %302, label %359

302:                                              ; preds = %288
  %303 = getelementptr i8, ptr %110, i64 24
  %304 = load i64, ptr %303, align 8, !noalias !12
  %305 = add nsw i64 %304, 1
  store i64 %305, ptr %303, align 8, !noalias !12
  store ptr null, ptr %19, align 8, !noalias !25
  store ptr null, ptr %20, align 8, !noalias !25
  store double %297, ptr %33, align 8, !noalias !25
  %306 = icmp sgt i64 %45, 0
  br i1 %306, label %307, label %310

307:                                              ; preds = %302
  store ptr null, ptr %19, align 8, !noalias !25
  %308 = call fastcc i32 @_sample(ptr nonnull %19, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %297) #3
  switch i32 %308, label %309 [
    i32 -2, label %310
    i32 0, label %310
  ], !prof !32

309:                                              ; preds = %307
  br label %310

310:                                              ; preds = %307, %307, %302, %309
  %311 = phi i32 [ %308, %309 ], [ 0, %302 ], [ 0, %307 ], [ 0, %307 ]
  switch i32 %311, label %316 [
    i32 -2, label %312
    i32 0, label %312
  ], !prof !32

312:                                              ; preds = %310, %310
  %313 = load i64, ptr %30, align 8, !noalias !33
  %314 = inttoptr i64 %313 to ptr
  %315 = call i32 %314(ptr nonnull %33, ptr %65, ptr %38, ptr %41, ptr %85) #3, !noalias !33
  br label %316

316:                                              ; preds = %310, %312
  %317 = phi i32 [ %315, %312 ], [ 0, %310 ]
  %318 = phi i32 [ 0, %312 ], [ %311, %310 ]
  switch i32 %318, label %2336 [
    i32 -2, label %2334
    i32 0, label %2334
  ], !prof !32

319:                                              ; preds = %2334
  %320 = getelementptr i8, ptr %110, i64 72
  store i64 3, ptr %320, align 8, !noalias !12
  %321 = icmp slt i32 %317, 0
  %322 = select i1 %321, i64 -4, i64 2
  br label %2632

323:                                              ; preds = %2334
  store i64 1, ptr %110, align 8, !noalias !12
  %324 = getelementptr i8, ptr %105, i64 24
  store double 0.000000e+00, ptr %324, align 8, !noalias !12
  %325 = getelementptr i8, ptr %196, i64 8
  store i64 1, ptr %325, align 8, !noalias !12
  %326 = getelementptr i8, ptr %196, i64 32
  store i64 1, ptr %326, align 8, !noalias !12
  %327 = getelementptr i8, ptr %199, i64 8
  store double 0.000000e+00, ptr %327, align 8, !noalias !12
  store i8 0, ptr %23, align 1, !noalias !12
  %328 = call fastcc i32 @write_reached(ptr nonnull %23, ptr %30, ptr %65, i64 %64, ptr nonnull %105, ptr nonnull %110, i64 %114, ptr %115, i64 %114, ptr %119, i64 %118) #3
  switch i32 %328, label %2340 [
    i32 -2, label %2337
    i32 0, label %2337
  ], !prof !32

329:                                              ; preds = %2337
  br label %2632

330:                                              ; preds = %2337
  %331 = fcmp oeq double %299, 0.000000e+00
  br i1 %331, label %332, label %359

332:                                              ; preds = %330
  %333 = getelementptr i8, ptr %105, i64 16
  %334 = load double, ptr %333, align 8, !noalias !12
  store double 0.000000e+00, ptr %21, align 8, !noalias !34
  store double 0.000000e+00, ptr %22, align 8, !noalias !34
  store double 0.000000e+00, ptr %21, align 8, !noalias !34
  %335 = call fastcc i32 @norm(ptr nonnull %21, ptr %65, ptr %65, ptr %65, ptr nonnull %95, i64 %94, ptr %100, i64 %99, i64 %273) #3
  %336 = load double, ptr %21, align 8, !noalias !34
  switch i32 %335, label %2341 [
    i32 -2, label %337
    i32 0, label %337
  ], !prof !32

337:                                              ; preds = %332, %332
  store double 0.000000e+00, ptr %22, align 8, !noalias !34
  %338 = call fastcc i32 @norm(ptr nonnull %22, ptr %85, ptr %65, ptr %65, ptr nonnull %95, i64 %94, ptr %100, i64 %99, i64 %273) #3
  switch i32 %338, label %2341 [
    i32 -2, label %339
    i32 0, label %339
  ], !prof !32

339:                                              ; preds = %337, %337
  %340 = load double, ptr %22, align 8, !noalias !34
  %341 = fcmp olt double %336, 1.000000e-05
  %342 = fcmp olt double %340, 1.000000e-05
  %343 = or i1 %341, %342
  %344 = fmul double %336, 1.000000e-02
  %345 = fdiv double %344, %340
  %346 = select i1 %343, double 0x3EB0C6F7A0B5ED8D, double %345
  %347 = fcmp olt double %334, %346
  %348 = select i1 %347, double %334, double %346
  %349 = load double, ptr %333, align 8, !noalias !12
  %350 = call double @llvm.fabs.f64(double %297)
  %351 = fmul double %350, 0x3D30000000000000
  %352 = fcmp ogt double %351, %348
  %353 = select i1 %352, double %351, double %348
  %354 = fcmp olt double %349, %353
  %355 = select i1 %354, double %349, double %353
  %356 = call i1 @llvm.is.fpclass.f64(double %355, i32 384)
  br i1 %356, label %359, label %357

357:                                              ; preds = %339
  %358 = getelementptr i8, ptr %110, i64 72
  store i64 4, ptr %358, align 8, !noalias !12
  br label %359

359:                                              ; preds = %339, %288, %357, %330
  %360 = phi double [ %355, %339 ], [ %355, %357 ], [ %299, %330 ], [ %299, %288 ]
  br label %361

361:                                              ; preds = %2320, %359
  %362 = phi double [ %360, %359 ], [ %2321, %2320 ]
  %363 = phi double [ %297, %359 ], [ %366, %2320 ]
  br label %364

364:                                              ; preds = %2241, %361
  %365 = phi double [ %362, %361 ], [ %2242, %2241 ]
  %366 = phi double [ %363, %361 ], [ %392, %2241 ]
  %367 = load i64, ptr %161, align 8, !noalias !12
  %368 = icmp eq i64 %367, 0
  br i1 %368, label %369, label %370

369:                                              ; preds = %364
  store double %365, ptr %298, align 8, !noalias !12
  br label %2632

370:                                              ; preds = %364
  %371 = add nsw i64 %367, -1
  store i64 %371, ptr %161, align 8, !noalias !12
  %372 = getelementptr i8, ptr %110, i64 8
  %373 = load i64, ptr %372, align 8, !noalias !12
  %374 = getelementptr i8, ptr %110, i64 16
  %375 = load i64, ptr %374, align 8, !noalias !12
  %376 = add nsw i64 %373, %375
  %377 = getelementptr i8, ptr %110, i64 64
  %378 = load i64, ptr %377, align 8, !noalias !12
  %379 = icmp slt i64 %376, %378
  br i1 %379, label %381, label %380

380:                                              ; preds = %370
  store double %365, ptr %298, align 8, !noalias !12
  br label %2632

381:                                              ; preds = %370
  %382 = getelementptr i8, ptr %105, i64 16
  %383 = load double, ptr %382, align 8, !noalias !12
  %384 = fcmp olt double %365, %383
  %385 = select i1 %384, double %365, double %383
  %386 = fadd double %366, %385
  %387 = fmul double %385, 1.000000e-03
  %388 = fsub double %280, %387
  %389 = fcmp ogt double %386, %388
  %390 = fsub double %280, %366
  %391 = select i1 %389, double %390, double %385
  %392 = select i1 %389, double %280, double %386
  %393 = fmul double %391, 6.250000e-02
  %394 = fadd double %366, %393
  %395 = fcmp ogt double %394, %366
  %396 = fcmp oeq double %392, %280
  %397 = or i1 %395, %396
  br i1 %397, label %398, label %2322

398:                                              ; preds = %381
  %399 = getelementptr i8, ptr %196, i64 8
  %400 = load i64, ptr %399, align 8, !noalias !12
  %401 = icmp eq i64 %400, 1
  br i1 %401, label %402, label %441

402:                                              ; preds = %398
  %403 = load i64, ptr %116, align 8, !noalias !12
  %404 = getelementptr i8, ptr %110, i64 32
  %405 = load i64, ptr %404, align 8, !noalias !12
  %406 = add nsw i64 %405, 1
  store i64 %406, ptr %404, align 8, !noalias !12
  %407 = load i64, ptr %196, align 8, !noalias !12
  %408 = icmp eq i64 %407, 0
  br i1 %408, label %416, label %409

409:                                              ; preds = %402
  store ptr null, ptr %13, align 8, !noalias !38
  store ptr null, ptr %14, align 8, !noalias !38
  store double %366, ptr %33, align 8, !noalias !38
  %410 = icmp sgt i64 %45, 0
  br i1 %410, label %411, label %414

411:                                              ; preds = %409
  store ptr null, ptr %13, align 8, !noalias !38
  %412 = call fastcc i32 @_sample(ptr nonnull %13, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %366) #3
  switch i32 %412, label %413 [
    i32 -2, label %414
    i32 0, label %414
  ], !prof !32

413:                                              ; preds = %411
  br label %414

414:                                              ; preds = %411, %411, %409, %413
  %415 = phi i32 [ %412, %413 ], [ 0, %409 ], [ 0, %411 ], [ 0, %411 ]
  switch i32 %415, label %2347 [
    i32 -2, label %2342
    i32 0, label %2342
  ], !prof !32

416:                                              ; preds = %402
  %417 = call i64 @llvm.smax.i64(i64 %403, i64 0)
  br label %418

418:                                              ; preds = %416, %2348
  %419 = phi i64 [ 0, %416 ], [ %2350, %2348 ]
  %420 = phi i64 [ %417, %416 ], [ %2349, %2348 ]
  %421 = icmp sgt i64 %420, 0
  br i1 %421, label %2348, label %422

422:                                              ; preds = %418, %432
  %423 = phi i64 [ %2361, %432 ], [ 0, %418 ]
  %424 = phi i64 [ %2360, %432 ], [ %417, %418 ]
  %425 = icmp sgt i64 %424, 0
  br i1 %425, label %2359, label %434

426:                                              ; preds = %2392
  %427 = sext i32 %2390 to i64
  br label %434

428:                                              ; preds = %2392, %2395
  %429 = phi i64 [ %2397, %2395 ], [ 0, %2392 ]
  %430 = phi i64 [ %2396, %2395 ], [ %417, %2392 ]
  %431 = icmp sgt i64 %430, 0
  br i1 %431, label %2395, label %432

432:                                              ; preds = %428
  %433 = load double, ptr %2365, align 8, !noalias !12
  store double %433, ptr %2375, align 8, !noalias !12
  br label %422

434:                                              ; preds = %422, %2342, %426
  %435 = phi i64 [ %2346, %2342 ], [ %427, %426 ], [ 0, %422 ]
  %436 = icmp slt i64 %435, 0
  br i1 %436, label %437, label %438

437:                                              ; preds = %434
  br label %2632

438:                                              ; preds = %434
  store i64 0, ptr %399, align 8, !noalias !12
  %439 = getelementptr i8, ptr %196, i64 16
  store i64 1, ptr %439, align 8, !noalias !12
  %440 = getelementptr i8, ptr %196, i64 24
  store i64 0, ptr %440, align 8, !noalias !12
  br label %441

441:                                              ; preds = %438, %398
  %442 = getelementptr i8, ptr %196, i64 24
  %443 = load i64, ptr %442, align 8, !noalias !12
  %444 = icmp eq i64 %443, 0
  br i1 %444, label %448, label %445

445:                                              ; preds = %441
  %446 = load double, ptr %199, align 8, !noalias !12
  %447 = fcmp une double %391, %446
  br i1 %447, label %448, label %763

448:                                              ; preds = %445, %441
  %449 = getelementptr i8, ptr %110, i64 40
  %450 = load i64, ptr %449, align 8, !noalias !12
  %451 = add nsw i64 %450, 1
  store i64 %451, ptr %449, align 8, !noalias !12
  %452 = call i64 @llvm.smax.i64(i64 %225, i64 0)
  br label %453

453:                                              ; preds = %461, %448
  %454 = phi i64 [ 0, %448 ], [ %2417, %461 ]
  %455 = phi i64 [ %452, %448 ], [ %2416, %461 ]
  %456 = icmp sgt i64 %455, 0
  br i1 %456, label %2415, label %487

457:                                              ; preds = %2415, %2418
  %458 = phi i64 [ 0, %2415 ], [ %2420, %2418 ]
  %459 = phi i64 [ %452, %2415 ], [ %2419, %2418 ]
  %460 = icmp sgt i64 %459, 0
  br i1 %460, label %2418, label %461

461:                                              ; preds = %457
  %462 = icmp slt i64 %454, 0
  %463 = select i1 %462, i64 %211, i64 0
  %464 = add i64 %454, %463
  %465 = select i1 %462, i64 %213, i64 0
  %466 = mul i64 %464, %213
  %467 = getelementptr double, ptr %214, i64 %466
  %468 = getelementptr double, ptr %467, i64 %454
  %469 = getelementptr double, ptr %468, i64 %465
  %470 = load double, ptr %469, align 8, !noalias !12
  %471 = fdiv double 0x400D1A48D83E731D, %391
  %472 = fadd double %470, %471
  store double %472, ptr %469, align 8, !noalias !12
  %473 = select i1 %462, i64 %218, i64 0
  %474 = add i64 %454, %473
  %475 = select i1 %462, i64 %220, i64 0
  %476 = mul i64 %474, %220
  %477 = getelementptr { double, double }, ptr %221, i64 %476
  %478 = getelementptr { double, double }, ptr %477, i64 %454
  %479 = getelementptr { double, double }, ptr %478, i64 %475
  %480 = load double, ptr %479, align 8, !noalias !12
  %481 = getelementptr inbounds nuw i8, ptr %479, i64 8
  %482 = load double, ptr %481, align 8, !noalias !12
  %483 = fdiv double 0x400572DB93E0C672, %391
  %484 = fdiv double 0xC0086747F2C3FCB6, %391
  %485 = fadd double %480, %483
  %486 = fadd double %482, %484
  store double %485, ptr %479, align 8, !noalias !12
  store double %486, ptr %481, align 8, !noalias !12
  br label %453

487:                                              ; preds = %453
  %488 = call i64 @llvm.smax.i64(i64 %211, i64 0)
  br label %489

489:                                              ; preds = %513, %487
  %490 = phi i64 [ 0, %487 ], [ %526, %513 ]
  %491 = phi i64 [ %488, %487 ], [ %525, %513 ]
  %492 = icmp sgt i64 %491, 0
  br i1 %492, label %524, label %595

493:                                              ; preds = %539, %524
  %494 = phi i64 [ %526, %524 ], [ %541, %539 ]
  %495 = phi i64 [ %538, %524 ], [ %540, %539 ]
  %496 = phi double [ %536, %524 ], [ %552, %539 ]
  %497 = phi i64 [ %490, %524 ], [ %553, %539 ]
  %498 = icmp sgt i64 %495, 0
  br i1 %498, label %539, label %499

499:                                              ; preds = %493
  %500 = select i1 %527, i64 %225, i64 0
  %501 = getelementptr i64, ptr %226, i64 %490
  %502 = getelementptr i64, ptr %501, i64 %500
  store i64 %497, ptr %502, align 8, !noalias !42
  %503 = fcmp ueq double %496, 0.000000e+00
  br i1 %503, label %755, label %504

504:                                              ; preds = %499
  %505 = icmp eq i64 %497, %490
  br i1 %505, label %510, label %506

506:                                              ; preds = %504, %554
  %507 = phi i64 [ %556, %554 ], [ 0, %504 ]
  %508 = phi i64 [ %555, %554 ], [ %488, %504 ]
  %509 = icmp sgt i64 %508, 0
  br i1 %509, label %554, label %510

510:                                              ; preds = %506, %504
  %511 = load double, ptr %534, align 8, !noalias !42
  %512 = fdiv double 1.000000e+00, %511
  br label %513

513:                                              ; preds = %523, %510
  %514 = phi i64 [ %526, %510 ], [ %572, %523 ]
  %515 = phi i64 [ %538, %510 ], [ %571, %523 ]
  %516 = icmp sgt i64 %515, 0
  br i1 %516, label %570, label %489

517:                                              ; preds = %570
  %518 = fmul double %580, %512
  store double %518, ptr %579, align 8, !noalias !42
  br label %519

519:                                              ; preds = %582, %517
  %520 = phi i64 [ %526, %517 ], [ %584, %582 ]
  %521 = phi i64 [ %538, %517 ], [ %583, %582 ]
  %522 = icmp sgt i64 %521, 0
  br i1 %522, label %582, label %523

523:                                              ; preds = %570, %519
  br label %513

524:                                              ; preds = %489
  %525 = add nsw i64 %491, -1
  %526 = add i64 %490, 1
  %527 = icmp slt i64 %490, 0
  %528 = select i1 %527, i64 %211, i64 0
  %529 = add i64 %490, %528
  %530 = select i1 %527, i64 %213, i64 0
  %531 = mul i64 %529, %213
  %532 = getelementptr double, ptr %214, i64 %531
  %533 = getelementptr double, ptr %532, i64 %490
  %534 = getelementptr double, ptr %533, i64 %530
  %535 = load double, ptr %534, align 8, !noalias !42
  %536 = call double @llvm.fabs.f64(double %535)
  %537 = sub i64 %211, %526
  %538 = call i64 @llvm.smax.i64(i64 %537, i64 0)
  br label %493

539:                                              ; preds = %493
  %540 = add nsw i64 %495, -1
  %541 = add i64 %494, 1
  %542 = icmp slt i64 %494, 0
  %543 = select i1 %542, i64 %211, i64 0
  %544 = add i64 %494, %543
  %545 = mul i64 %544, %213
  %546 = getelementptr double, ptr %214, i64 %545
  %547 = getelementptr double, ptr %546, i64 %490
  %548 = getelementptr double, ptr %547, i64 %530
  %549 = load double, ptr %548, align 8, !noalias !42
  %550 = call double @llvm.fabs.f64(double %549)
  %551 = fcmp ogt double %550, %496
  %552 = select i1 %551, double %550, double %496
  %553 = select i1 %551, i64 %494, i64 %497
  br label %493

554:                                              ; preds = %506
  %555 = add nsw i64 %508, -1
  %556 = add i64 %507, 1
  %557 = icmp slt i64 %497, 0
  %558 = select i1 %557, i64 %211, i64 0
  %559 = add i64 %497, %558
  %560 = icmp slt i64 %507, 0
  %561 = select i1 %560, i64 %213, i64 0
  %562 = mul i64 %559, %213
  %563 = getelementptr double, ptr %214, i64 %562
  %564 = getelementptr double, ptr %563, i64 %507
  %565 = getelementptr double, ptr %564, i64 %561
  %566 = load double, ptr %565, align 8, !noalias !42
  %567 = getelementptr double, ptr %532, i64 %507
  %568 = getelementptr double, ptr %567, i64 %561
  %569 = load double, ptr %568, align 8, !noalias !42
  store double %566, ptr %568, align 8, !noalias !42
  store double %569, ptr %565, align 8, !noalias !42
  br label %506

570:                                              ; preds = %513
  %571 = add nsw i64 %515, -1
  %572 = add i64 %514, 1
  %573 = icmp slt i64 %514, 0
  %574 = select i1 %573, i64 %211, i64 0
  %575 = add i64 %514, %574
  %576 = mul i64 %575, %213
  %577 = getelementptr double, ptr %214, i64 %576
  %578 = getelementptr double, ptr %577, i64 %490
  %579 = getelementptr double, ptr %578, i64 %530
  %580 = load double, ptr %579, align 8, !noalias !42
  %581 = fcmp une double %580, 0.000000e+00
  br i1 %581, label %517, label %523

582:                                              ; preds = %519
  %583 = add nsw i64 %521, -1
  %584 = add i64 %520, 1
  %585 = icmp slt i64 %520, 0
  %586 = select i1 %585, i64 %213, i64 0
  %587 = getelementptr double, ptr %577, i64 %520
  %588 = getelementptr double, ptr %587, i64 %586
  %589 = load double, ptr %588, align 8, !noalias !42
  %590 = getelementptr double, ptr %532, i64 %520
  %591 = getelementptr double, ptr %590, i64 %586
  %592 = load double, ptr %591, align 8, !noalias !42
  %593 = fmul double %518, %592
  %594 = fsub double %589, %593
  store double %594, ptr %588, align 8, !noalias !42
  br label %519

595:                                              ; preds = %489
  %596 = call i64 @llvm.smax.i64(i64 %218, i64 0)
  br label %597

597:                                              ; preds = %645, %595
  %598 = phi i64 [ 0, %595 ], [ %663, %645 ]
  %599 = phi i64 [ %596, %595 ], [ %662, %645 ]
  %600 = icmp sgt i64 %599, 0
  br i1 %600, label %661, label %754

601:                                              ; preds = %678, %661
  %602 = phi i64 [ %663, %661 ], [ %690, %678 ]
  %603 = phi i64 [ %677, %661 ], [ %691, %678 ]
  %604 = phi double [ %675, %661 ], [ %693, %678 ]
  %605 = phi i64 [ %598, %661 ], [ %694, %678 ]
  %606 = icmp sgt i64 %603, 0
  br i1 %606, label %678, label %607

607:                                              ; preds = %601
  %608 = select i1 %664, i64 %230, i64 0
  %609 = getelementptr i64, ptr %231, i64 %598
  %610 = getelementptr i64, ptr %609, i64 %608
  store i64 %605, ptr %610, align 8, !noalias !45
  %611 = fcmp ueq double %604, 0.000000e+00
  br i1 %611, label %755, label %612

612:                                              ; preds = %607
  %613 = icmp eq i64 %605, %598
  br i1 %613, label %618, label %614

614:                                              ; preds = %612, %695
  %615 = phi i64 [ %697, %695 ], [ 0, %612 ]
  %616 = phi i64 [ %696, %695 ], [ %596, %612 ]
  %617 = icmp sgt i64 %616, 0
  br i1 %617, label %695, label %618

618:                                              ; preds = %614, %612
  %619 = load double, ptr %671, align 8, !noalias !45
  %620 = load double, ptr %673, align 8, !noalias !45
  %621 = call double @llvm.fabs.f64(double %619)
  %622 = call double @llvm.fabs.f64(double %620)
  %623 = fcmp ult double %621, %622
  br i1 %623, label %633, label %624

624:                                              ; preds = %618
  %625 = fdiv double %620, %619
  %626 = fmul double %620, %625
  %627 = fadd double %619, %626
  %628 = fmul double %625, 0.000000e+00
  %629 = fadd double %628, 1.000000e+00
  %630 = fdiv double %629, %627
  %631 = fsub double 0.000000e+00, %625
  %632 = fdiv double %631, %627
  br label %642

633:                                              ; preds = %618
  %634 = fdiv double %619, %620
  %635 = fmul double %619, %634
  %636 = fadd double %635, %620
  %637 = fadd double %634, 0.000000e+00
  %638 = fdiv double %637, %636
  %639 = fmul double %634, 0.000000e+00
  %640 = fadd double %639, -1.000000e+00
  %641 = fdiv double %640, %636
  br label %642

642:                                              ; preds = %633, %624
  %643 = phi double [ %632, %624 ], [ %641, %633 ]
  %644 = phi double [ %630, %624 ], [ %638, %633 ]
  br label %645

645:                                              ; preds = %660, %642
  %646 = phi i64 [ %663, %642 ], [ %717, %660 ]
  %647 = phi i64 [ %677, %642 ], [ %716, %660 ]
  %648 = icmp sgt i64 %647, 0
  br i1 %648, label %715, label %597

649:                                              ; preds = %715
  %650 = fmul double %725, %643
  %651 = fmul double %727, %644
  %652 = fadd double %650, %651
  %653 = fmul double %725, %644
  %654 = fmul double %727, %643
  %655 = fsub double %653, %654
  store double %655, ptr %724, align 8, !noalias !45
  store double %652, ptr %726, align 8, !noalias !45
  br label %656

656:                                              ; preds = %731, %649
  %657 = phi i64 [ %663, %649 ], [ %750, %731 ]
  %658 = phi i64 [ %677, %649 ], [ %751, %731 ]
  %659 = icmp sgt i64 %658, 0
  br i1 %659, label %731, label %660

660:                                              ; preds = %715, %656
  br label %645

661:                                              ; preds = %597
  %662 = add nsw i64 %599, -1
  %663 = add i64 %598, 1
  %664 = icmp slt i64 %598, 0
  %665 = select i1 %664, i64 %218, i64 0
  %666 = add i64 %598, %665
  %667 = select i1 %664, i64 %220, i64 0
  %668 = mul i64 %666, %220
  %669 = getelementptr { double, double }, ptr %221, i64 %668
  %670 = getelementptr { double, double }, ptr %669, i64 %598
  %671 = getelementptr { double, double }, ptr %670, i64 %667
  %672 = load double, ptr %671, align 8, !noalias !45
  %673 = getelementptr inbounds nuw i8, ptr %671, i64 8
  %674 = load double, ptr %673, align 8, !noalias !45
  %675 = call double @hypot(double %672, double %674) #3, !noalias !49
  %676 = sub i64 %218, %663
  %677 = call i64 @llvm.smax.i64(i64 %676, i64 0)
  br label %601

678:                                              ; preds = %601
  %679 = icmp slt i64 %602, 0
  %680 = select i1 %679, i64 %218, i64 0
  %681 = add i64 %602, %680
  %682 = mul i64 %681, %220
  %683 = getelementptr { double, double }, ptr %221, i64 %682
  %684 = getelementptr { double, double }, ptr %683, i64 %598
  %685 = getelementptr { double, double }, ptr %684, i64 %667
  %686 = load double, ptr %685, align 8, !noalias !45
  %687 = getelementptr inbounds nuw i8, ptr %685, i64 8
  %688 = load double, ptr %687, align 8, !noalias !45
  %689 = call double @hypot(double %686, double %688) #3, !noalias !55
  %690 = add i64 %602, 1
  %691 = add nsw i64 %603, -1
  %692 = fcmp ogt double %689, %604
  %693 = select i1 %692, double %689, double %604
  %694 = select i1 %692, i64 %602, i64 %605
  br label %601

695:                                              ; preds = %614
  %696 = add nsw i64 %616, -1
  %697 = add i64 %615, 1
  %698 = icmp slt i64 %605, 0
  %699 = select i1 %698, i64 %218, i64 0
  %700 = add i64 %605, %699
  %701 = icmp slt i64 %615, 0
  %702 = select i1 %701, i64 %220, i64 0
  %703 = mul i64 %700, %220
  %704 = getelementptr { double, double }, ptr %221, i64 %703
  %705 = getelementptr { double, double }, ptr %704, i64 %615
  %706 = getelementptr { double, double }, ptr %705, i64 %702
  %707 = load double, ptr %706, align 8, !noalias !45
  %708 = getelementptr inbounds nuw i8, ptr %706, i64 8
  %709 = load double, ptr %708, align 8, !noalias !45
  %710 = getelementptr { double, double }, ptr %669, i64 %615
  %711 = getelementptr { double, double }, ptr %710, i64 %702
  %712 = load double, ptr %711, align 8, !noalias !45
  %713 = getelementptr inbounds nuw i8, ptr %711, i64 8
  %714 = load double, ptr %713, align 8, !noalias !45
  store double %707, ptr %711, align 8, !noalias !45
  store double %709, ptr %713, align 8, !noalias !45
  store double %712, ptr %706, align 8, !noalias !45
  store double %714, ptr %708, align 8, !noalias !45
  br label %614

715:                                              ; preds = %645
  %716 = add nsw i64 %647, -1
  %717 = add i64 %646, 1
  %718 = icmp slt i64 %646, 0
  %719 = select i1 %718, i64 %218, i64 0
  %720 = add i64 %646, %719
  %721 = mul i64 %720, %220
  %722 = getelementptr { double, double }, ptr %221, i64 %721
  %723 = getelementptr { double, double }, ptr %722, i64 %598
  %724 = getelementptr { double, double }, ptr %723, i64 %667
  %725 = load double, ptr %724, align 8, !noalias !45
  %726 = getelementptr inbounds nuw i8, ptr %724, i64 8
  %727 = load double, ptr %726, align 8, !noalias !45
  %728 = fcmp une double %725, 0.000000e+00
  %729 = fcmp une double %727, 0.000000e+00
  %730 = or i1 %728, %729
  br i1 %730, label %649, label %660

731:                                              ; preds = %656
  %732 = icmp slt i64 %657, 0
  %733 = select i1 %732, i64 %220, i64 0
  %734 = getelementptr { double, double }, ptr %722, i64 %657
  %735 = getelementptr { double, double }, ptr %734, i64 %733
  %736 = load double, ptr %735, align 8, !noalias !45
  %737 = getelementptr inbounds nuw i8, ptr %735, i64 8
  %738 = load double, ptr %737, align 8, !noalias !45
  %739 = getelementptr { double, double }, ptr %669, i64 %657
  %740 = getelementptr { double, double }, ptr %739, i64 %733
  %741 = load double, ptr %740, align 8, !noalias !45
  %742 = getelementptr inbounds nuw i8, ptr %740, i64 8
  %743 = load double, ptr %742, align 8, !noalias !45
  %744 = fmul double %655, %743
  %745 = fmul double %652, %741
  %746 = fadd double %744, %745
  %747 = fmul double %655, %741
  %748 = fmul double %652, %743
  %749 = fsub double %747, %748
  %750 = add i64 %657, 1
  %751 = add nsw i64 %658, -1
  %752 = fsub double %736, %749
  %753 = fsub double %738, %746
  store double %752, ptr %735, align 8, !noalias !45
  store double %753, ptr %737, align 8, !noalias !45
  br label %656

754:                                              ; preds = %597
  store i64 1, ptr %442, align 8, !noalias !12
  store double %391, ptr %199, align 8, !noalias !12
  br label %763

755:                                              ; preds = %499, %607
  %756 = load i64, ptr %374, align 8, !noalias !12
  %757 = add nsw i64 %756, 1
  %758 = fmul double %391, 5.000000e-01
  %759 = getelementptr i8, ptr %110, i64 72
  store i64 4, ptr %759, align 8, !noalias !12
  store i64 %757, ptr %374, align 8, !noalias !12
  %760 = getelementptr i8, ptr %196, i64 16
  %761 = load i64, ptr %760, align 8, !noalias !12
  %762 = sub nsw i64 1, %761
  store i64 %762, ptr %399, align 8, !noalias !12
  store i64 0, ptr %442, align 8, !noalias !12
  br label %2320

763:                                              ; preds = %754, %445
  %764 = getelementptr i8, ptr %199, i64 8
  %765 = load double, ptr %764, align 8, !noalias !12
  br label %766

766:                                              ; preds = %781, %763
  %767 = phi i64 [ 0, %763 ], [ %2450, %781 ]
  %768 = phi i64 [ 3, %763 ], [ %2449, %781 ]
  %769 = icmp sgt i64 %768, 0
  br i1 %769, label %2448, label %835

770:                                              ; preds = %2448
  %771 = icmp slt i64 %767, 0
  %772 = add i64 %767, 3
  %773 = select i1 %771, i64 %772, i64 %767
  %774 = getelementptr double, ptr @0, i64 %773
  %775 = load double, ptr %774, align 8, !noalias !12
  %776 = fmul double %775, %391
  %777 = fdiv double %776, %765
  %778 = fadd double %777, 1.000000e+00
  br label %779

779:                                              ; preds = %2448, %770
  %780 = phi double [ %778, %770 ], [ 0.000000e+00, %2448 ]
  br label %781

781:                                              ; preds = %779, %825, %785
  %782 = phi i64 [ 0, %779 ], [ %2454, %785 ], [ %2454, %825 ]
  %783 = phi i64 [ %282, %779 ], [ %2453, %785 ], [ %2453, %825 ]
  %784 = icmp sgt i64 %783, 0
  br i1 %784, label %2452, label %766

785:                                              ; preds = %2452
  %786 = fsub double 1.000000e+00, %780
  %787 = icmp slt i64 %782, 0
  %788 = select i1 %787, i64 %256, i64 0
  %789 = shl i64 %256, 4
  %790 = getelementptr i8, ptr %257, i64 %789
  %791 = getelementptr double, ptr %790, i64 %782
  %792 = getelementptr double, ptr %791, i64 %788
  %793 = load double, ptr %792, align 8, !noalias !12
  %794 = mul i64 %256, 24
  %795 = getelementptr i8, ptr %257, i64 %794
  %796 = getelementptr double, ptr %795, i64 %782
  %797 = getelementptr double, ptr %796, i64 %788
  %798 = load double, ptr %797, align 8, !noalias !12
  %799 = fmul double %780, %798
  %800 = fadd double %793, %799
  %801 = fmul double %786, %800
  %802 = getelementptr double, ptr %257, i64 %782
  %803 = getelementptr double, ptr %802, i64 %788
  %804 = load double, ptr %803, align 8, !noalias !12
  %805 = getelementptr double, ptr %257, i64 %256
  %806 = getelementptr double, ptr %805, i64 %782
  %807 = getelementptr double, ptr %806, i64 %788
  %808 = load double, ptr %807, align 8, !noalias !12
  %809 = fadd double %808, %801
  %810 = fmul double %780, %809
  %811 = fadd double %804, %810
  %812 = select i1 %787, i64 %64, i64 0
  %813 = getelementptr double, ptr %65, i64 %782
  %814 = getelementptr double, ptr %813, i64 %812
  %815 = load double, ptr %814, align 8, !noalias !12
  %816 = fsub double %811, %815
  %817 = icmp slt i64 %767, 0
  %818 = select i1 %817, i64 %235, i64 0
  %819 = add i64 %767, %818
  %820 = select i1 %787, i64 %237, i64 0
  %821 = mul i64 %819, %237
  %822 = getelementptr double, ptr %238, i64 %821
  %823 = getelementptr double, ptr %822, i64 %782
  %824 = getelementptr double, ptr %823, i64 %820
  store double %816, ptr %824, align 8, !noalias !12
  br label %781

825:                                              ; preds = %2452
  %826 = icmp slt i64 %767, 0
  %827 = select i1 %826, i64 %235, i64 0
  %828 = add i64 %767, %827
  %829 = icmp slt i64 %782, 0
  %830 = select i1 %829, i64 %237, i64 0
  %831 = mul i64 %828, %237
  %832 = getelementptr double, ptr %238, i64 %831
  %833 = getelementptr double, ptr %832, i64 %782
  %834 = getelementptr double, ptr %833, i64 %830
  store double 0.000000e+00, ptr %834, align 8, !noalias !12
  br label %781

835:                                              ; preds = %766, %839
  %836 = phi i64 [ %2457, %839 ], [ 0, %766 ]
  %837 = phi i64 [ %2456, %839 ], [ 3, %766 ]
  %838 = icmp sgt i64 %837, 0
  br i1 %838, label %2455, label %843

839:                                              ; preds = %2455, %2458
  %840 = phi i64 [ 0, %2455 ], [ %2460, %2458 ]
  %841 = phi i64 [ %282, %2455 ], [ %2459, %2458 ]
  %842 = icmp sgt i64 %841, 0
  br i1 %842, label %2458, label %835

843:                                              ; preds = %835
  %844 = fmul double %296, %286
  store ptr null, ptr %12, align 8, !noalias !61
  %845 = load i64, ptr %116, align 8, !noalias !61
  %846 = getelementptr i8, ptr %196, i64 40
  %847 = load i64, ptr %846, align 8, !noalias !61
  %848 = icmp sgt i64 %847, 0
  %849 = select i1 %848, i64 10, i64 6
  br label %850

850:                                              ; preds = %1282, %843
  %851 = phi i64 [ 0, %843 ], [ %1292, %1282 ]
  %852 = phi i64 [ %849, %843 ], [ %1293, %1282 ]
  %853 = phi double [ -1.000000e+00, %843 ], [ %1140, %1282 ]
  %854 = phi double [ 0.000000e+00, %843 ], [ %1181, %1282 ]
  %855 = phi i64 [ 0, %843 ], [ %1201, %1282 ]
  %856 = icmp sgt i64 %852, 0
  br i1 %856, label %1288, label %1291

857:                                              ; preds = %1291
  %858 = icmp sgt i64 %1295, 5
  %859 = icmp eq i64 %855, 0
  %860 = and i1 %858, %859
  br i1 %860, label %1283, label %861

861:                                              ; preds = %1321, %857
  %862 = phi i64 [ %1298, %1321 ], [ 0, %857 ]
  %863 = phi i64 [ %1297, %1321 ], [ 3, %857 ]
  %864 = icmp sgt i64 %863, 0
  br i1 %864, label %1296, label %899

865:                                              ; preds = %1300, %1296
  %866 = phi i64 [ 0, %1296 ], [ %1302, %1300 ]
  %867 = phi i64 [ %1299, %1296 ], [ %1301, %1300 ]
  %868 = icmp sgt i64 %867, 0
  br i1 %868, label %1300, label %869

869:                                              ; preds = %865
  %870 = getelementptr i8, ptr %110, i64 24
  %871 = load i64, ptr %870, align 8, !noalias !61
  %872 = add nsw i64 %871, 1
  store i64 %872, ptr %870, align 8, !noalias !61
  %873 = icmp slt i64 %862, 0
  %874 = add i64 %862, 3
  %875 = select i1 %873, i64 %874, i64 %862
  %876 = getelementptr double, ptr @4, i64 %875
  %877 = load double, ptr %876, align 8, !noalias !61
  %878 = fmul double %391, %877
  %879 = fadd double %366, %878
  %880 = mul nsw i64 %862, %845
  %881 = shl i64 %880, 3
  %882 = add i64 %881, %247
  store ptr null, ptr %10, align 8, !noalias !65
  store ptr null, ptr %11, align 8, !noalias !65
  store double %879, ptr %33, align 8, !noalias !65
  %883 = icmp sgt i64 %45, 0
  br i1 %883, label %884, label %887

884:                                              ; preds = %869
  store ptr null, ptr %10, align 8, !noalias !65
  %885 = call fastcc i32 @_sample(ptr nonnull %10, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %879) #3
  switch i32 %885, label %886 [
    i32 -2, label %887
    i32 0, label %887
  ], !prof !32

886:                                              ; preds = %884
  br label %887

887:                                              ; preds = %884, %884, %869, %886
  %888 = phi i32 [ %885, %886 ], [ 0, %869 ], [ 0, %884 ], [ 0, %884 ]
  switch i32 %888, label %894 [
    i32 -2, label %889
    i32 0, label %889
  ], !prof !32

889:                                              ; preds = %887, %887
  %890 = load i64, ptr %30, align 8, !noalias !72
  %891 = inttoptr i64 %890 to ptr
  %892 = inttoptr i64 %882 to ptr
  %893 = call i32 %891(ptr nonnull %33, ptr %75, ptr %38, ptr %41, ptr %892) #3, !noalias !72
  br label %894

894:                                              ; preds = %887, %889
  %895 = phi i32 [ %893, %889 ], [ 0, %887 ]
  %896 = phi i32 [ 0, %889 ], [ %888, %887 ]
  switch i32 %896, label %1840 [
    i32 -2, label %1321
    i32 0, label %1321
  ], !prof !32

897:                                              ; preds = %1321
  %898 = sext i32 %895 to i64
  br label %1840

899:                                              ; preds = %861
  %900 = call i64 @llvm.smax.i64(i64 %845, i64 0)
  br label %901

901:                                              ; preds = %905, %899
  %902 = phi i64 [ 0, %899 ], [ %906, %905 ]
  %903 = phi i64 [ %900, %899 ], [ %907, %905 ]
  %904 = icmp sgt i64 %903, 0
  br i1 %904, label %1323, label %959

905:                                              ; preds = %1323
  %906 = add i64 %902, 1
  %907 = add nsw i64 %903, -1
  %908 = fmul double %1328, 0x4010B70201A79C46
  %909 = fmul double %1332, 0x3FD4F8C15DA84E86
  %910 = fadd double %908, %909
  %911 = fmul double %1338, 0x3FE0BF7FF59D56EF
  %912 = fadd double %910, %911
  %913 = fdiv double 0x400D1A48D83E731D, %391
  %914 = select i1 %1324, i64 %244, i64 0
  %915 = getelementptr double, ptr %245, i64 %902
  %916 = getelementptr double, ptr %915, i64 %914
  %917 = load double, ptr %916, align 8, !noalias !61
  %918 = fmul double %913, %917
  %919 = fsub double %912, %918
  %920 = select i1 %1324, i64 %261, i64 0
  %921 = getelementptr double, ptr %262, i64 %902
  %922 = getelementptr double, ptr %921, i64 %920
  store double %919, ptr %922, align 8, !noalias !61
  %923 = load double, ptr %1327, align 8, !noalias !61
  %924 = fmul double %923, 0xC010B70201A79C46
  %925 = load double, ptr %1331, align 8, !noalias !61
  %926 = fmul double %925, 0xBFD4F8C15DA84E86
  %927 = fadd double %924, %926
  %928 = load double, ptr %1337, align 8, !noalias !61
  %929 = fmul double %928, 0x3FDE810014C55221
  %930 = fadd double %927, %929
  %931 = fmul double %923, 0x3FE017885A24A7F2
  %932 = fmul double %925, 0xC004934E6FCAA598
  %933 = fadd double %931, %932
  %934 = fmul double %928, 0x3FE312C0CF7BDFD1
  %935 = fadd double %933, %934
  %936 = fdiv double 0x400572DB93E0C672, %391
  %937 = fdiv double 0xC0086747F2C3FCB6, %391
  %938 = getelementptr double, ptr %245, i64 %244
  %939 = getelementptr double, ptr %938, i64 %902
  %940 = getelementptr double, ptr %939, i64 %914
  %941 = load double, ptr %940, align 8, !noalias !61
  %942 = shl i64 %244, 4
  %943 = getelementptr i8, ptr %245, i64 %942
  %944 = getelementptr double, ptr %943, i64 %902
  %945 = getelementptr double, ptr %944, i64 %914
  %946 = load double, ptr %945, align 8, !noalias !61
  %947 = fmul double %936, %946
  %948 = fmul double %937, %941
  %949 = fadd double %947, %948
  %950 = fmul double %936, %941
  %951 = fmul double %937, %946
  %952 = fsub double %950, %951
  %953 = fsub double %930, %952
  %954 = fsub double %935, %949
  %955 = select i1 %1324, i64 %266, i64 0
  %956 = getelementptr { double, double }, ptr %267, i64 %902
  %957 = getelementptr { double, double }, ptr %956, i64 %955
  store double %953, ptr %957, align 8, !noalias !61
  %958 = getelementptr inbounds nuw i8, ptr %957, i64 8
  store double %954, ptr %958, align 8, !noalias !61
  br label %901

959:                                              ; preds = %901
  store ptr null, ptr %12, align 8, !noalias !61
  %960 = call fastcc i32 @solve(ptr nonnull %12, ptr %214, i64 %211, i64 %213, ptr %226, i64 %225, ptr %262, i64 %261) #3, !noalias !61
  switch i32 %960, label %1840 [
    i32 -2, label %1342
    i32 0, label %1342
  ], !prof !32

961:                                              ; preds = %1512
  %962 = call i64 @llvm.smax.i64(i64 %211, i64 0)
  br label %963

963:                                              ; preds = %976, %961
  %964 = phi i64 [ 0, %961 ], [ %1022, %976 ]
  %965 = phi i64 [ %962, %961 ], [ %1021, %976 ]
  %966 = icmp sgt i64 %965, 0
  br i1 %966, label %1020, label %977

967:                                              ; preds = %1020
  %968 = mul nsw i64 %964, %847
  %969 = add nsw i64 %211, %968
  %970 = mul nsw i64 %1027, %847
  %971 = add nsw i64 %211, %970
  br label %972

972:                                              ; preds = %1029, %967
  %973 = phi i64 [ 0, %967 ], [ %1031, %1029 ]
  %974 = phi i64 [ %847, %967 ], [ %1030, %1029 ]
  %975 = icmp sgt i64 %974, 0
  br i1 %975, label %1029, label %976

976:                                              ; preds = %1020, %972
  br label %963

977:                                              ; preds = %963, %981
  %978 = phi i64 [ %1046, %981 ], [ 0, %963 ]
  %979 = phi i64 [ %1045, %981 ], [ %962, %963 ]
  %980 = icmp sgt i64 %979, 0
  br i1 %980, label %1044, label %989

981:                                              ; preds = %1044, %985
  %982 = phi i64 [ 0, %1044 ], [ %1050, %985 ]
  %983 = phi i64 [ %1047, %1044 ], [ %1049, %985 ]
  %984 = icmp sgt i64 %983, 0
  br i1 %984, label %1048, label %977

985:                                              ; preds = %1065, %1048
  %986 = phi i64 [ 0, %1048 ], [ %1067, %1065 ]
  %987 = phi i64 [ %847, %1048 ], [ %1066, %1065 ]
  %988 = icmp sgt i64 %987, 0
  br i1 %988, label %1065, label %981

989:                                              ; preds = %977
  %990 = icmp ugt i64 %211, -9223372036854775808
  %991 = select i1 %990, i64 0, i64 %211
  br label %992

992:                                              ; preds = %1016, %989
  %993 = phi i64 [ %211, %989 ], [ %995, %1016 ]
  %994 = phi i64 [ %991, %989 ], [ %1083, %1016 ]
  %995 = add i64 %993, -1
  %996 = icmp sgt i64 %994, 0
  br i1 %996, label %1082, label %1513

997:                                              ; preds = %1082, %1001
  %998 = phi i64 [ %993, %1082 ], [ %1090, %1001 ]
  %999 = phi i64 [ %1087, %1082 ], [ %1089, %1001 ]
  %1000 = icmp sgt i64 %999, 0
  br i1 %1000, label %1088, label %1005

1001:                                             ; preds = %1103, %1088
  %1002 = phi i64 [ 0, %1088 ], [ %1105, %1103 ]
  %1003 = phi i64 [ %847, %1088 ], [ %1104, %1103 ]
  %1004 = icmp sgt i64 %1003, 0
  br i1 %1004, label %1103, label %997

1005:                                             ; preds = %997
  %1006 = icmp slt i64 %995, 0
  %1007 = select i1 %1006, i64 %211, i64 0
  %1008 = add i64 %995, %1007
  %1009 = select i1 %1006, i64 %213, i64 0
  %1010 = mul i64 %1008, %213
  %1011 = getelementptr double, ptr %214, i64 %1010
  %1012 = getelementptr double, ptr %1011, i64 %995
  %1013 = getelementptr double, ptr %1012, i64 %1009
  %1014 = load double, ptr %1013, align 8, !noalias !73
  %1015 = fdiv double 1.000000e+00, %1014
  br label %1016

1016:                                             ; preds = %1120, %1005
  %1017 = phi i64 [ 0, %1005 ], [ %1122, %1120 ]
  %1018 = phi i64 [ %847, %1005 ], [ %1121, %1120 ]
  %1019 = icmp sgt i64 %1018, 0
  br i1 %1019, label %1120, label %992

1020:                                             ; preds = %963
  %1021 = add nsw i64 %965, -1
  %1022 = add i64 %964, 1
  %1023 = icmp slt i64 %964, 0
  %1024 = select i1 %1023, i64 %225, i64 0
  %1025 = getelementptr i64, ptr %226, i64 %964
  %1026 = getelementptr i64, ptr %1025, i64 %1024
  %1027 = load i64, ptr %1026, align 8, !noalias !73
  %1028 = icmp eq i64 %1027, %964
  br i1 %1028, label %976, label %967

1029:                                             ; preds = %972
  %1030 = add nsw i64 %974, -1
  %1031 = add i64 %973, 1
  %1032 = add nsw i64 %971, %973
  %1033 = icmp slt i64 %1032, 0
  %1034 = select i1 %1033, i64 %261, i64 0
  %1035 = getelementptr double, ptr %262, i64 %1032
  %1036 = getelementptr double, ptr %1035, i64 %1034
  %1037 = load double, ptr %1036, align 8, !noalias !73
  %1038 = add nsw i64 %969, %973
  %1039 = icmp slt i64 %1038, 0
  %1040 = select i1 %1039, i64 %261, i64 0
  %1041 = getelementptr double, ptr %262, i64 %1038
  %1042 = getelementptr double, ptr %1041, i64 %1040
  %1043 = load double, ptr %1042, align 8, !noalias !73
  store double %1037, ptr %1042, align 8, !noalias !73
  store double %1043, ptr %1036, align 8, !noalias !73
  br label %972

1044:                                             ; preds = %977
  %1045 = add nsw i64 %979, -1
  %1046 = add i64 %978, 1
  %1047 = call i64 @llvm.smax.i64(i64 %978, i64 0)
  br label %981

1048:                                             ; preds = %981
  %1049 = add nsw i64 %983, -1
  %1050 = add i64 %982, 1
  %1051 = icmp slt i64 %978, 0
  %1052 = select i1 %1051, i64 %211, i64 0
  %1053 = add i64 %978, %1052
  %1054 = icmp slt i64 %982, 0
  %1055 = select i1 %1054, i64 %213, i64 0
  %1056 = mul i64 %1053, %213
  %1057 = getelementptr double, ptr %214, i64 %1056
  %1058 = getelementptr double, ptr %1057, i64 %982
  %1059 = getelementptr double, ptr %1058, i64 %1055
  %1060 = load double, ptr %1059, align 8, !noalias !73
  %1061 = mul nsw i64 %978, %847
  %1062 = add nsw i64 %211, %1061
  %1063 = mul nsw i64 %982, %847
  %1064 = add nsw i64 %211, %1063
  br label %985

1065:                                             ; preds = %985
  %1066 = add nsw i64 %987, -1
  %1067 = add i64 %986, 1
  %1068 = add nsw i64 %1062, %986
  %1069 = icmp slt i64 %1068, 0
  %1070 = select i1 %1069, i64 %261, i64 0
  %1071 = getelementptr double, ptr %262, i64 %1068
  %1072 = getelementptr double, ptr %1071, i64 %1070
  %1073 = load double, ptr %1072, align 8, !noalias !73
  %1074 = add nsw i64 %1064, %986
  %1075 = icmp slt i64 %1074, 0
  %1076 = select i1 %1075, i64 %261, i64 0
  %1077 = getelementptr double, ptr %262, i64 %1074
  %1078 = getelementptr double, ptr %1077, i64 %1076
  %1079 = load double, ptr %1078, align 8, !noalias !73
  %1080 = fmul double %1060, %1079
  %1081 = fsub double %1073, %1080
  store double %1081, ptr %1072, align 8, !noalias !73
  br label %985

1082:                                             ; preds = %992
  %1083 = add nsw i64 %994, -1
  %1084 = mul nsw i64 %995, %847
  %1085 = add nsw i64 %211, %1084
  %1086 = sub i64 %211, %993
  %1087 = call i64 @llvm.smax.i64(i64 %1086, i64 0)
  br label %997

1088:                                             ; preds = %997
  %1089 = add nsw i64 %999, -1
  %1090 = add i64 %998, 1
  %1091 = icmp slt i64 %995, 0
  %1092 = select i1 %1091, i64 %211, i64 0
  %1093 = add i64 %995, %1092
  %1094 = icmp slt i64 %998, 0
  %1095 = select i1 %1094, i64 %213, i64 0
  %1096 = mul i64 %1093, %213
  %1097 = getelementptr double, ptr %214, i64 %1096
  %1098 = getelementptr double, ptr %1097, i64 %998
  %1099 = getelementptr double, ptr %1098, i64 %1095
  %1100 = load double, ptr %1099, align 8, !noalias !73
  %1101 = mul nsw i64 %998, %847
  %1102 = add nsw i64 %211, %1101
  br label %1001

1103:                                             ; preds = %1001
  %1104 = add nsw i64 %1003, -1
  %1105 = add i64 %1002, 1
  %1106 = add nsw i64 %1085, %1002
  %1107 = icmp slt i64 %1106, 0
  %1108 = select i1 %1107, i64 %261, i64 0
  %1109 = getelementptr double, ptr %262, i64 %1106
  %1110 = getelementptr double, ptr %1109, i64 %1108
  %1111 = load double, ptr %1110, align 8, !noalias !73
  %1112 = add nsw i64 %1102, %1002
  %1113 = icmp slt i64 %1112, 0
  %1114 = select i1 %1113, i64 %261, i64 0
  %1115 = getelementptr double, ptr %262, i64 %1112
  %1116 = getelementptr double, ptr %1115, i64 %1114
  %1117 = load double, ptr %1116, align 8, !noalias !73
  %1118 = fmul double %1100, %1117
  %1119 = fsub double %1111, %1118
  store double %1119, ptr %1110, align 8, !noalias !73
  br label %1001

1120:                                             ; preds = %1016
  %1121 = add nsw i64 %1018, -1
  %1122 = add i64 %1017, 1
  %1123 = add nsw i64 %1085, %1017
  %1124 = icmp slt i64 %1123, 0
  %1125 = select i1 %1124, i64 %261, i64 0
  %1126 = getelementptr double, ptr %262, i64 %1123
  %1127 = getelementptr double, ptr %1126, i64 %1125
  %1128 = load double, ptr %1127, align 8, !noalias !73
  %1129 = fmul double %1128, %1015
  store double %1129, ptr %1127, align 8, !noalias !73
  br label %1016

1130:                                             ; preds = %1539, %1512
  br label %1131

1131:                                             ; preds = %1737, %1130
  %1132 = phi i64 [ 0, %1130 ], [ %1739, %1737 ]
  %1133 = phi i64 [ %900, %1130 ], [ %1738, %1737 ]
  %1134 = phi double [ 0.000000e+00, %1130 ], [ %1774, %1737 ]
  %1135 = icmp sgt i64 %1133, 0
  br i1 %1135, label %1737, label %1136

1136:                                             ; preds = %1131
  %1137 = mul nsw i64 %845, 3
  %1138 = sitofp i64 %1137 to double
  %1139 = fdiv double %1134, %1138
  %1140 = call double @sqrt(double %1139), !noalias !61
  %1141 = fcmp ogt double %853, 0.000000e+00
  %1142 = and i1 %1141, %859
  br i1 %1142, label %1143, label %1180

1143:                                             ; preds = %1136
  %1144 = fdiv double %1140, %853
  %1145 = sub nsw i64 5, %1295
  %1146 = add nsw i64 %1295, -5
  %1147 = select i1 %858, i64 %1146, i64 %1145
  %1148 = icmp samesign ugt i64 %1147, 65536
  br i1 %1148, label %1149, label %1152

1149:                                             ; preds = %1143
  %1150 = sitofp i64 %1145 to double
  %1151 = call double @llvm.pow.f64(double %1144, double %1150)
  br label %1171

1152:                                             ; preds = %1143
  %1153 = icmp eq i64 %1147, 0
  br i1 %1153, label %1165, label %1154

1154:                                             ; preds = %1154, %1152
  %1155 = phi double [ %1161, %1154 ], [ 1.000000e+00, %1152 ]
  %1156 = phi double [ %1163, %1154 ], [ %1144, %1152 ]
  %1157 = phi i64 [ %1162, %1154 ], [ %1147, %1152 ]
  %1158 = and i64 %1157, 1
  %1159 = icmp eq i64 %1158, 0
  %1160 = fmul double %1155, %1156
  %1161 = select i1 %1159, double %1155, double %1160
  %1162 = lshr i64 %1157, 1
  %1163 = fmul double %1156, %1156
  %1164 = icmp eq i64 %1162, 0
  br i1 %1164, label %1165, label %1154

1165:                                             ; preds = %1154, %1152
  %1166 = phi double [ %1161, %1154 ], [ 1.000000e+00, %1152 ]
  br i1 %858, label %1167, label %1171

1167:                                             ; preds = %1165
  %1168 = fcmp oeq double %1166, 0.000000e+00
  br i1 %1168, label %1171, label %1169, !prof !4

1169:                                             ; preds = %1167
  %1170 = fdiv double 1.000000e+00, %1166
  br label %1171

1171:                                             ; preds = %1167, %1165, %1149, %1169
  %1172 = phi double [ 0.000000e+00, %1167 ], [ %1151, %1149 ], [ %1166, %1165 ], [ %1170, %1169 ]
  %1173 = phi i1 [ false, %1167 ], [ true, %1149 ], [ true, %1165 ], [ true, %1169 ]
  %1174 = phi i32 [ 1, %1167 ], [ 0, %1149 ], [ 0, %1165 ], [ 0, %1169 ]
  br i1 %1173, label %1775, label %1840, !prof !76

1175:                                             ; preds = %1775
  %1176 = fsub double 1.000000e+00, %1144
  %1177 = fdiv double %1172, %1176
  %1178 = fmul double %1177, %1140
  %1179 = fcmp ogt double %1178, %296
  br i1 %1179, label %1840, label %1180

1180:                                             ; preds = %1175, %1136
  %1181 = phi double [ %1144, %1175 ], [ %854, %1136 ]
  br label %1182

1182:                                             ; preds = %1186, %1180
  %1183 = phi i64 [ 0, %1180 ], [ %1779, %1186 ]
  %1184 = phi i64 [ %900, %1180 ], [ %1778, %1186 ]
  %1185 = icmp sgt i64 %1184, 0
  br i1 %1185, label %1777, label %1190

1186:                                             ; preds = %1807, %1777
  %1187 = phi i64 [ 0, %1777 ], [ %1809, %1807 ]
  %1188 = phi i64 [ 3, %1777 ], [ %1808, %1807 ]
  %1189 = icmp sgt i64 %1188, 0
  br i1 %1189, label %1807, label %1182

1190:                                             ; preds = %1182
  br i1 %859, label %1191, label %1200

1191:                                             ; preds = %1190
  %1192 = fcmp oeq double %1140, 0.000000e+00
  br i1 %1192, label %1199, label %1193

1193:                                             ; preds = %1191
  br i1 %1141, label %1194, label %1200

1194:                                             ; preds = %1193
  %1195 = fsub double 1.000000e+00, %1181
  %1196 = fdiv double %1181, %1195
  %1197 = fmul double %1196, %1140
  %1198 = fcmp olt double %1197, %296
  br i1 %1198, label %1199, label %1200

1199:                                             ; preds = %1194, %1191
  br label %1200

1200:                                             ; preds = %1199, %1194, %1193, %1190
  %1201 = phi i64 [ %1294, %1199 ], [ 0, %1194 ], [ 0, %1193 ], [ %855, %1190 ]
  %1202 = icmp sgt i64 %1201, 0
  br i1 %1202, label %1203, label %1282

1203:                                             ; preds = %1200
  %1204 = icmp eq i64 %847, 0
  br i1 %1204, label %1283, label %1205

1205:                                             ; preds = %1203
  %1206 = load i64, ptr %846, align 8, !noalias !77
  %1207 = call i64 @llvm.smax.i64(i64 %1206, i64 0)
  br label %1208

1208:                                             ; preds = %1226, %1205
  %1209 = phi i64 [ 0, %1205 ], [ %1230, %1226 ]
  %1210 = phi i64 [ %1207, %1205 ], [ %1229, %1226 ]
  %1211 = phi double [ 0.000000e+00, %1205 ], [ %1227, %1226 ]
  %1212 = icmp sgt i64 %1210, 0
  br i1 %1212, label %1228, label %1837

1213:                                             ; preds = %1232, %1228
  %1214 = phi i64 [ 0, %1228 ], [ %1234, %1232 ]
  %1215 = phi i64 [ %1231, %1228 ], [ %1233, %1232 ]
  %1216 = phi double [ 0.000000e+00, %1228 ], [ %1256, %1232 ]
  %1217 = phi double [ 0.000000e+00, %1228 ], [ %1281, %1232 ]
  %1218 = icmp sgt i64 %1215, 0
  br i1 %1218, label %1232, label %1219

1219:                                             ; preds = %1213
  %1220 = fmul double %1211, %1217
  %1221 = fcmp ogt double %1216, %1220
  br i1 %1221, label %1222, label %1226

1222:                                             ; preds = %1219
  %1223 = fcmp ogt double %1217, 0.000000e+00
  %1224 = fdiv double %1216, %1217
  %1225 = select i1 %1223, double %1224, double 1.000000e+00
  br label %1226

1226:                                             ; preds = %1222, %1219
  %1227 = phi double [ %1225, %1222 ], [ %1211, %1219 ]
  br label %1208

1228:                                             ; preds = %1208
  %1229 = add nsw i64 %1210, -1
  %1230 = add i64 %1209, 1
  %1231 = call i64 @llvm.smax.i64(i64 %225, i64 0)
  br label %1213

1232:                                             ; preds = %1213
  %1233 = add nsw i64 %1215, -1
  %1234 = add i64 %1214, 1
  %1235 = mul nsw i64 %1214, %1206
  %1236 = add nsw i64 %225, %1235
  %1237 = add nsw i64 %1236, %1209
  %1238 = icmp slt i64 %1237, 0
  %1239 = select i1 %1238, i64 %261, i64 0
  %1240 = getelementptr double, ptr %262, i64 %1237
  %1241 = getelementptr double, ptr %1240, i64 %1239
  %1242 = load double, ptr %1241, align 8, !noalias !77
  %1243 = fmul double %1242, %1242
  %1244 = select i1 %1238, i64 %266, i64 0
  %1245 = getelementptr { double, double }, ptr %267, i64 %1237
  %1246 = getelementptr { double, double }, ptr %1245, i64 %1244
  %1247 = load double, ptr %1246, align 8, !noalias !77
  %1248 = getelementptr inbounds nuw i8, ptr %1246, i64 8
  %1249 = load double, ptr %1248, align 8, !noalias !77
  %1250 = call double @hypot(double %1247, double %1249) #3, !noalias !81
  %1251 = load double, ptr %1246, align 8, !noalias !77
  %1252 = load double, ptr %1248, align 8, !noalias !77
  %1253 = call double @hypot(double %1251, double %1252) #3, !noalias !87
  %1254 = fmul double %1250, %1253
  %1255 = fadd double %1243, %1254
  %1256 = fadd double %1216, %1255
  %1257 = select i1 %1238, i64 %64, i64 0
  %1258 = getelementptr double, ptr %65, i64 %1237
  %1259 = getelementptr double, ptr %1258, i64 %1257
  %1260 = load double, ptr %1259, align 8, !noalias !77
  %1261 = fmul double %1260, %1260
  %1262 = fadd double %1217, %1261
  %1263 = select i1 %1238, i64 %244, i64 0
  %1264 = getelementptr double, ptr %245, i64 %1237
  %1265 = getelementptr double, ptr %1264, i64 %1263
  %1266 = load double, ptr %1265, align 8, !noalias !77
  %1267 = fmul double %1266, %1266
  %1268 = getelementptr double, ptr %245, i64 %244
  %1269 = getelementptr double, ptr %1268, i64 %1237
  %1270 = getelementptr double, ptr %1269, i64 %1263
  %1271 = load double, ptr %1270, align 8, !noalias !77
  %1272 = fmul double %1271, %1271
  %1273 = fadd double %1267, %1272
  %1274 = shl i64 %244, 4
  %1275 = getelementptr i8, ptr %245, i64 %1274
  %1276 = getelementptr double, ptr %1275, i64 %1237
  %1277 = getelementptr double, ptr %1276, i64 %1263
  %1278 = load double, ptr %1277, align 8, !noalias !77
  %1279 = fmul double %1278, %1278
  %1280 = fadd double %1273, %1279
  %1281 = fadd double %1262, %1280
  br label %1213

1282:                                             ; preds = %1837, %1200
  br label %850

1283:                                             ; preds = %1837, %1291, %1203, %857
  %1284 = phi double [ %854, %1291 ], [ %854, %857 ], [ %1181, %1837 ], [ %1181, %1203 ]
  %1285 = phi i64 [ %855, %1291 ], [ 0, %857 ], [ %1201, %1837 ], [ %1201, %1203 ]
  %1286 = icmp slt i64 %1285, 1
  %1287 = select i1 %1286, i64 6, i64 %1285
  br label %1840

1288:                                             ; preds = %850
  %1289 = add nsw i64 %852, -1
  %1290 = add i64 %851, 1
  br label %1291

1291:                                             ; preds = %1288, %850
  %1292 = phi i64 [ %1290, %1288 ], [ %851, %850 ]
  %1293 = phi i64 [ %1289, %1288 ], [ %852, %850 ]
  %1294 = phi i64 [ %1290, %1288 ], [ 1, %850 ]
  %1295 = phi i64 [ %851, %1288 ], [ 0, %850 ]
  br i1 %856, label %857, label %1283

1296:                                             ; preds = %861
  %1297 = add nsw i64 %863, -1
  %1298 = add i64 %862, 1
  %1299 = call i64 @llvm.smax.i64(i64 %845, i64 0)
  br label %865

1300:                                             ; preds = %865
  %1301 = add nsw i64 %867, -1
  %1302 = add i64 %866, 1
  %1303 = icmp slt i64 %866, 0
  %1304 = select i1 %1303, i64 %64, i64 0
  %1305 = getelementptr double, ptr %65, i64 %866
  %1306 = getelementptr double, ptr %1305, i64 %1304
  %1307 = load double, ptr %1306, align 8, !noalias !61
  %1308 = icmp slt i64 %862, 0
  %1309 = select i1 %1308, i64 %235, i64 0
  %1310 = add i64 %862, %1309
  %1311 = select i1 %1303, i64 %237, i64 0
  %1312 = mul i64 %1310, %237
  %1313 = getelementptr double, ptr %238, i64 %1312
  %1314 = getelementptr double, ptr %1313, i64 %866
  %1315 = getelementptr double, ptr %1314, i64 %1311
  %1316 = load double, ptr %1315, align 8, !noalias !61
  %1317 = fadd double %1307, %1316
  %1318 = select i1 %1303, i64 %74, i64 0
  %1319 = getelementptr double, ptr %75, i64 %866
  %1320 = getelementptr double, ptr %1319, i64 %1318
  store double %1317, ptr %1320, align 8, !noalias !61
  br label %865

1321:                                             ; preds = %894, %894
  %1322 = icmp eq i32 %895, 0
  br i1 %1322, label %861, label %897

1323:                                             ; preds = %901
  %1324 = icmp slt i64 %902, 0
  %1325 = select i1 %1324, i64 %249, i64 0
  %1326 = getelementptr double, ptr %250, i64 %902
  %1327 = getelementptr double, ptr %1326, i64 %1325
  %1328 = load double, ptr %1327, align 8, !noalias !61
  %1329 = getelementptr double, ptr %250, i64 %249
  %1330 = getelementptr double, ptr %1329, i64 %902
  %1331 = getelementptr double, ptr %1330, i64 %1325
  %1332 = load double, ptr %1331, align 8, !noalias !61
  %1333 = fadd double %1328, %1332
  %1334 = shl i64 %249, 4
  %1335 = getelementptr i8, ptr %250, i64 %1334
  %1336 = getelementptr double, ptr %1335, i64 %902
  %1337 = getelementptr double, ptr %1336, i64 %1325
  %1338 = load double, ptr %1337, align 8, !noalias !61
  %1339 = fadd double %1333, %1338
  %1340 = fsub double %1339, %1339
  %1341 = fcmp ord double %1340, 0.000000e+00
  br i1 %1341, label %905, label %1840

1342:                                             ; preds = %959, %959
  %1343 = call i64 @llvm.smax.i64(i64 %218, i64 0)
  br label %1344

1344:                                             ; preds = %1362, %1342
  %1345 = phi i64 [ 0, %1342 ], [ %1427, %1362 ]
  %1346 = phi i64 [ %1343, %1342 ], [ %1426, %1362 ]
  %1347 = icmp sgt i64 %1346, 0
  br i1 %1347, label %1425, label %1363

1348:                                             ; preds = %1425
  %1349 = icmp slt i64 %1432, 0
  %1350 = select i1 %1349, i64 %266, i64 0
  %1351 = getelementptr { double, double }, ptr %267, i64 %1432
  %1352 = getelementptr { double, double }, ptr %1351, i64 %1350
  %1353 = load double, ptr %1352, align 8, !noalias !93
  %1354 = getelementptr inbounds nuw i8, ptr %1352, i64 8
  %1355 = load double, ptr %1354, align 8, !noalias !93
  %1356 = select i1 %1428, i64 %266, i64 0
  %1357 = getelementptr { double, double }, ptr %267, i64 %1345
  %1358 = getelementptr { double, double }, ptr %1357, i64 %1356
  %1359 = load double, ptr %1358, align 8, !noalias !93
  %1360 = getelementptr inbounds nuw i8, ptr %1358, i64 8
  %1361 = load double, ptr %1360, align 8, !noalias !93
  store double %1353, ptr %1358, align 8, !noalias !93
  store double %1355, ptr %1360, align 8, !noalias !93
  store double %1359, ptr %1352, align 8, !noalias !93
  store double %1361, ptr %1354, align 8, !noalias !93
  br label %1362

1362:                                             ; preds = %1425, %1348
  br label %1344

1363:                                             ; preds = %1344, %1373
  %1364 = phi i64 [ %1436, %1373 ], [ 0, %1344 ]
  %1365 = phi i64 [ %1435, %1373 ], [ %1343, %1344 ]
  %1366 = icmp sgt i64 %1365, 0
  br i1 %1366, label %1434, label %1374

1367:                                             ; preds = %1445, %1434
  %1368 = phi i64 [ 0, %1434 ], [ %1469, %1445 ]
  %1369 = phi i64 [ %1444, %1434 ], [ %1470, %1445 ]
  %1370 = phi double [ %1443, %1434 ], [ %1472, %1445 ]
  %1371 = phi double [ %1441, %1434 ], [ %1471, %1445 ]
  %1372 = icmp sgt i64 %1369, 0
  br i1 %1372, label %1445, label %1373

1373:                                             ; preds = %1367
  store double %1371, ptr %1440, align 8, !noalias !93
  store double %1370, ptr %1442, align 8, !noalias !93
  br label %1363

1374:                                             ; preds = %1363
  %1375 = icmp ugt i64 %218, -9223372036854775808
  %1376 = select i1 %1375, i64 0, i64 %218
  br label %1377

1377:                                             ; preds = %1422, %1374
  %1378 = phi i64 [ %218, %1374 ], [ %1380, %1422 ]
  %1379 = phi i64 [ %1376, %1374 ], [ %1474, %1422 ]
  %1380 = add i64 %1378, -1
  %1381 = icmp sgt i64 %1379, 0
  br i1 %1381, label %1473, label %1512

1382:                                             ; preds = %1484, %1473
  %1383 = phi i64 [ %1378, %1473 ], [ %1508, %1484 ]
  %1384 = phi i64 [ %1483, %1473 ], [ %1509, %1484 ]
  %1385 = phi double [ %1481, %1473 ], [ %1511, %1484 ]
  %1386 = phi double [ %1479, %1473 ], [ %1510, %1484 ]
  %1387 = icmp sgt i64 %1384, 0
  br i1 %1387, label %1484, label %1388

1388:                                             ; preds = %1382
  %1389 = select i1 %1475, i64 %218, i64 0
  %1390 = add i64 %1380, %1389
  %1391 = select i1 %1475, i64 %220, i64 0
  %1392 = mul i64 %1390, %220
  %1393 = getelementptr { double, double }, ptr %221, i64 %1392
  %1394 = getelementptr { double, double }, ptr %1393, i64 %1380
  %1395 = getelementptr { double, double }, ptr %1394, i64 %1391
  %1396 = load double, ptr %1395, align 8, !noalias !93
  %1397 = getelementptr inbounds nuw i8, ptr %1395, i64 8
  %1398 = load double, ptr %1397, align 8, !noalias !93
  %1399 = call double @llvm.fabs.f64(double %1396)
  %1400 = call double @llvm.fabs.f64(double %1398)
  %1401 = fcmp ult double %1399, %1400
  br i1 %1401, label %1412, label %1402

1402:                                             ; preds = %1388
  %1403 = fdiv double %1398, %1396
  %1404 = fmul double %1398, %1403
  %1405 = fadd double %1396, %1404
  %1406 = fmul double %1385, %1403
  %1407 = fadd double %1386, %1406
  %1408 = fdiv double %1407, %1405
  %1409 = fmul double %1386, %1403
  %1410 = fsub double %1385, %1409
  %1411 = fdiv double %1410, %1405
  br label %1422

1412:                                             ; preds = %1388
  %1413 = fdiv double %1396, %1398
  %1414 = fmul double %1396, %1413
  %1415 = fadd double %1414, %1398
  %1416 = fmul double %1386, %1413
  %1417 = fadd double %1416, %1385
  %1418 = fdiv double %1417, %1415
  %1419 = fmul double %1385, %1413
  %1420 = fsub double %1419, %1386
  %1421 = fdiv double %1420, %1415
  br label %1422

1422:                                             ; preds = %1412, %1402
  %1423 = phi double [ %1411, %1402 ], [ %1421, %1412 ]
  %1424 = phi double [ %1408, %1402 ], [ %1418, %1412 ]
  store double %1424, ptr %1478, align 8, !noalias !93
  store double %1423, ptr %1480, align 8, !noalias !93
  br label %1377

1425:                                             ; preds = %1344
  %1426 = add nsw i64 %1346, -1
  %1427 = add i64 %1345, 1
  %1428 = icmp slt i64 %1345, 0
  %1429 = select i1 %1428, i64 %230, i64 0
  %1430 = getelementptr i64, ptr %231, i64 %1345
  %1431 = getelementptr i64, ptr %1430, i64 %1429
  %1432 = load i64, ptr %1431, align 8, !noalias !93
  %1433 = icmp eq i64 %1432, %1345
  br i1 %1433, label %1362, label %1348

1434:                                             ; preds = %1363
  %1435 = add nsw i64 %1365, -1
  %1436 = add i64 %1364, 1
  %1437 = icmp slt i64 %1364, 0
  %1438 = select i1 %1437, i64 %266, i64 0
  %1439 = getelementptr { double, double }, ptr %267, i64 %1364
  %1440 = getelementptr { double, double }, ptr %1439, i64 %1438
  %1441 = load double, ptr %1440, align 8, !noalias !93
  %1442 = getelementptr inbounds nuw i8, ptr %1440, i64 8
  %1443 = load double, ptr %1442, align 8, !noalias !93
  %1444 = call i64 @llvm.smax.i64(i64 %1364, i64 0)
  br label %1367

1445:                                             ; preds = %1367
  %1446 = select i1 %1437, i64 %218, i64 0
  %1447 = add i64 %1364, %1446
  %1448 = icmp slt i64 %1368, 0
  %1449 = select i1 %1448, i64 %220, i64 0
  %1450 = mul i64 %1447, %220
  %1451 = getelementptr { double, double }, ptr %221, i64 %1450
  %1452 = getelementptr { double, double }, ptr %1451, i64 %1368
  %1453 = getelementptr { double, double }, ptr %1452, i64 %1449
  %1454 = load double, ptr %1453, align 8, !noalias !93
  %1455 = getelementptr inbounds nuw i8, ptr %1453, i64 8
  %1456 = load double, ptr %1455, align 8, !noalias !93
  %1457 = select i1 %1448, i64 %266, i64 0
  %1458 = getelementptr { double, double }, ptr %267, i64 %1368
  %1459 = getelementptr { double, double }, ptr %1458, i64 %1457
  %1460 = load double, ptr %1459, align 8, !noalias !93
  %1461 = getelementptr inbounds nuw i8, ptr %1459, i64 8
  %1462 = load double, ptr %1461, align 8, !noalias !93
  %1463 = fmul double %1454, %1462
  %1464 = fmul double %1456, %1460
  %1465 = fadd double %1463, %1464
  %1466 = fmul double %1454, %1460
  %1467 = fmul double %1456, %1462
  %1468 = fsub double %1466, %1467
  %1469 = add i64 %1368, 1
  %1470 = add nsw i64 %1369, -1
  %1471 = fsub double %1371, %1468
  %1472 = fsub double %1370, %1465
  br label %1367

1473:                                             ; preds = %1377
  %1474 = add nsw i64 %1379, -1
  %1475 = icmp slt i64 %1380, 0
  %1476 = select i1 %1475, i64 %266, i64 0
  %1477 = getelementptr { double, double }, ptr %267, i64 %1380
  %1478 = getelementptr { double, double }, ptr %1477, i64 %1476
  %1479 = load double, ptr %1478, align 8, !noalias !93
  %1480 = getelementptr inbounds nuw i8, ptr %1478, i64 8
  %1481 = load double, ptr %1480, align 8, !noalias !93
  %1482 = sub i64 %218, %1378
  %1483 = call i64 @llvm.smax.i64(i64 %1482, i64 0)
  br label %1382

1484:                                             ; preds = %1382
  %1485 = select i1 %1475, i64 %218, i64 0
  %1486 = add i64 %1380, %1485
  %1487 = icmp slt i64 %1383, 0
  %1488 = select i1 %1487, i64 %220, i64 0
  %1489 = mul i64 %1486, %220
  %1490 = getelementptr { double, double }, ptr %221, i64 %1489
  %1491 = getelementptr { double, double }, ptr %1490, i64 %1383
  %1492 = getelementptr { double, double }, ptr %1491, i64 %1488
  %1493 = load double, ptr %1492, align 8, !noalias !93
  %1494 = getelementptr inbounds nuw i8, ptr %1492, i64 8
  %1495 = load double, ptr %1494, align 8, !noalias !93
  %1496 = select i1 %1487, i64 %266, i64 0
  %1497 = getelementptr { double, double }, ptr %267, i64 %1383
  %1498 = getelementptr { double, double }, ptr %1497, i64 %1496
  %1499 = load double, ptr %1498, align 8, !noalias !93
  %1500 = getelementptr inbounds nuw i8, ptr %1498, i64 8
  %1501 = load double, ptr %1500, align 8, !noalias !93
  %1502 = fmul double %1493, %1501
  %1503 = fmul double %1495, %1499
  %1504 = fadd double %1502, %1503
  %1505 = fmul double %1493, %1499
  %1506 = fmul double %1495, %1501
  %1507 = fsub double %1505, %1506
  %1508 = add i64 %1383, 1
  %1509 = add nsw i64 %1384, -1
  %1510 = fsub double %1386, %1507
  %1511 = fsub double %1385, %1504
  br label %1382

1512:                                             ; preds = %1377
  br i1 %848, label %961, label %1130

1513:                                             ; preds = %992, %1526
  %1514 = phi i64 [ %1594, %1526 ], [ 0, %992 ]
  %1515 = phi i64 [ %1593, %1526 ], [ %1343, %992 ]
  %1516 = icmp sgt i64 %1515, 0
  br i1 %1516, label %1592, label %1527

1517:                                             ; preds = %1592
  %1518 = mul nsw i64 %1514, %847
  %1519 = add nsw i64 %218, %1518
  %1520 = mul nsw i64 %1599, %847
  %1521 = add nsw i64 %218, %1520
  br label %1522

1522:                                             ; preds = %1601, %1517
  %1523 = phi i64 [ 0, %1517 ], [ %1603, %1601 ]
  %1524 = phi i64 [ %847, %1517 ], [ %1602, %1601 ]
  %1525 = icmp sgt i64 %1524, 0
  br i1 %1525, label %1601, label %1526

1526:                                             ; preds = %1592, %1522
  br label %1513

1527:                                             ; preds = %1513, %1531
  %1528 = phi i64 [ %1622, %1531 ], [ 0, %1513 ]
  %1529 = phi i64 [ %1621, %1531 ], [ %1343, %1513 ]
  %1530 = icmp sgt i64 %1529, 0
  br i1 %1530, label %1620, label %1539

1531:                                             ; preds = %1620, %1535
  %1532 = phi i64 [ 0, %1620 ], [ %1626, %1535 ]
  %1533 = phi i64 [ %1623, %1620 ], [ %1625, %1535 ]
  %1534 = icmp sgt i64 %1533, 0
  br i1 %1534, label %1624, label %1527

1535:                                             ; preds = %1643, %1624
  %1536 = phi i64 [ 0, %1624 ], [ %1666, %1643 ]
  %1537 = phi i64 [ %847, %1624 ], [ %1667, %1643 ]
  %1538 = icmp sgt i64 %1537, 0
  br i1 %1538, label %1643, label %1531

1539:                                             ; preds = %1527, %1588
  %1540 = phi i64 [ %1542, %1588 ], [ %218, %1527 ]
  %1541 = phi i64 [ %1671, %1588 ], [ %1376, %1527 ]
  %1542 = add i64 %1540, -1
  %1543 = icmp sgt i64 %1541, 0
  br i1 %1543, label %1670, label %1130

1544:                                             ; preds = %1670, %1548
  %1545 = phi i64 [ %1540, %1670 ], [ %1678, %1548 ]
  %1546 = phi i64 [ %1675, %1670 ], [ %1677, %1548 ]
  %1547 = icmp sgt i64 %1546, 0
  br i1 %1547, label %1676, label %1552

1548:                                             ; preds = %1693, %1676
  %1549 = phi i64 [ 0, %1676 ], [ %1716, %1693 ]
  %1550 = phi i64 [ %847, %1676 ], [ %1717, %1693 ]
  %1551 = icmp sgt i64 %1550, 0
  br i1 %1551, label %1693, label %1544

1552:                                             ; preds = %1544
  %1553 = icmp slt i64 %1542, 0
  %1554 = select i1 %1553, i64 %218, i64 0
  %1555 = add i64 %1542, %1554
  %1556 = select i1 %1553, i64 %220, i64 0
  %1557 = mul i64 %1555, %220
  %1558 = getelementptr { double, double }, ptr %221, i64 %1557
  %1559 = getelementptr { double, double }, ptr %1558, i64 %1542
  %1560 = getelementptr { double, double }, ptr %1559, i64 %1556
  %1561 = load double, ptr %1560, align 8, !noalias !97
  %1562 = getelementptr inbounds nuw i8, ptr %1560, i64 8
  %1563 = load double, ptr %1562, align 8, !noalias !97
  %1564 = call double @llvm.fabs.f64(double %1561)
  %1565 = call double @llvm.fabs.f64(double %1563)
  %1566 = fcmp ult double %1564, %1565
  br i1 %1566, label %1576, label %1567

1567:                                             ; preds = %1552
  %1568 = fdiv double %1563, %1561
  %1569 = fmul double %1563, %1568
  %1570 = fadd double %1561, %1569
  %1571 = fmul double %1568, 0.000000e+00
  %1572 = fadd double %1571, 1.000000e+00
  %1573 = fdiv double %1572, %1570
  %1574 = fsub double 0.000000e+00, %1568
  %1575 = fdiv double %1574, %1570
  br label %1585

1576:                                             ; preds = %1552
  %1577 = fdiv double %1561, %1563
  %1578 = fmul double %1561, %1577
  %1579 = fadd double %1578, %1563
  %1580 = fadd double %1577, 0.000000e+00
  %1581 = fdiv double %1580, %1579
  %1582 = fmul double %1577, 0.000000e+00
  %1583 = fadd double %1582, -1.000000e+00
  %1584 = fdiv double %1583, %1579
  br label %1585

1585:                                             ; preds = %1576, %1567
  %1586 = phi double [ %1575, %1567 ], [ %1584, %1576 ]
  %1587 = phi double [ %1573, %1567 ], [ %1581, %1576 ]
  br label %1588

1588:                                             ; preds = %1720, %1585
  %1589 = phi i64 [ 0, %1585 ], [ %1735, %1720 ]
  %1590 = phi i64 [ %847, %1585 ], [ %1736, %1720 ]
  %1591 = icmp sgt i64 %1590, 0
  br i1 %1591, label %1720, label %1539

1592:                                             ; preds = %1513
  %1593 = add nsw i64 %1515, -1
  %1594 = add i64 %1514, 1
  %1595 = icmp slt i64 %1514, 0
  %1596 = select i1 %1595, i64 %230, i64 0
  %1597 = getelementptr i64, ptr %231, i64 %1514
  %1598 = getelementptr i64, ptr %1597, i64 %1596
  %1599 = load i64, ptr %1598, align 8, !noalias !97
  %1600 = icmp eq i64 %1599, %1514
  br i1 %1600, label %1526, label %1517

1601:                                             ; preds = %1522
  %1602 = add nsw i64 %1524, -1
  %1603 = add i64 %1523, 1
  %1604 = add nsw i64 %1521, %1523
  %1605 = icmp slt i64 %1604, 0
  %1606 = select i1 %1605, i64 %266, i64 0
  %1607 = getelementptr { double, double }, ptr %267, i64 %1604
  %1608 = getelementptr { double, double }, ptr %1607, i64 %1606
  %1609 = load double, ptr %1608, align 8, !noalias !97
  %1610 = getelementptr inbounds nuw i8, ptr %1608, i64 8
  %1611 = load double, ptr %1610, align 8, !noalias !97
  %1612 = add nsw i64 %1519, %1523
  %1613 = icmp slt i64 %1612, 0
  %1614 = select i1 %1613, i64 %266, i64 0
  %1615 = getelementptr { double, double }, ptr %267, i64 %1612
  %1616 = getelementptr { double, double }, ptr %1615, i64 %1614
  %1617 = load double, ptr %1616, align 8, !noalias !97
  %1618 = getelementptr inbounds nuw i8, ptr %1616, i64 8
  %1619 = load double, ptr %1618, align 8, !noalias !97
  store double %1609, ptr %1616, align 8, !noalias !97
  store double %1611, ptr %1618, align 8, !noalias !97
  store double %1617, ptr %1608, align 8, !noalias !97
  store double %1619, ptr %1610, align 8, !noalias !97
  br label %1522

1620:                                             ; preds = %1527
  %1621 = add nsw i64 %1529, -1
  %1622 = add i64 %1528, 1
  %1623 = call i64 @llvm.smax.i64(i64 %1528, i64 0)
  br label %1531

1624:                                             ; preds = %1531
  %1625 = add nsw i64 %1533, -1
  %1626 = add i64 %1532, 1
  %1627 = icmp slt i64 %1528, 0
  %1628 = select i1 %1627, i64 %218, i64 0
  %1629 = add i64 %1528, %1628
  %1630 = icmp slt i64 %1532, 0
  %1631 = select i1 %1630, i64 %220, i64 0
  %1632 = mul i64 %1629, %220
  %1633 = getelementptr { double, double }, ptr %221, i64 %1632
  %1634 = getelementptr { double, double }, ptr %1633, i64 %1532
  %1635 = getelementptr { double, double }, ptr %1634, i64 %1631
  %1636 = load double, ptr %1635, align 8, !noalias !97
  %1637 = getelementptr inbounds nuw i8, ptr %1635, i64 8
  %1638 = load double, ptr %1637, align 8, !noalias !97
  %1639 = mul nsw i64 %1528, %847
  %1640 = add nsw i64 %218, %1639
  %1641 = mul nsw i64 %1532, %847
  %1642 = add nsw i64 %218, %1641
  br label %1535

1643:                                             ; preds = %1535
  %1644 = add nsw i64 %1640, %1536
  %1645 = icmp slt i64 %1644, 0
  %1646 = select i1 %1645, i64 %266, i64 0
  %1647 = getelementptr { double, double }, ptr %267, i64 %1644
  %1648 = getelementptr { double, double }, ptr %1647, i64 %1646
  %1649 = load double, ptr %1648, align 8, !noalias !97
  %1650 = getelementptr inbounds nuw i8, ptr %1648, i64 8
  %1651 = load double, ptr %1650, align 8, !noalias !97
  %1652 = add nsw i64 %1642, %1536
  %1653 = icmp slt i64 %1652, 0
  %1654 = select i1 %1653, i64 %266, i64 0
  %1655 = getelementptr { double, double }, ptr %267, i64 %1652
  %1656 = getelementptr { double, double }, ptr %1655, i64 %1654
  %1657 = load double, ptr %1656, align 8, !noalias !97
  %1658 = getelementptr inbounds nuw i8, ptr %1656, i64 8
  %1659 = load double, ptr %1658, align 8, !noalias !97
  %1660 = fmul double %1636, %1659
  %1661 = fmul double %1638, %1657
  %1662 = fadd double %1660, %1661
  %1663 = fmul double %1636, %1657
  %1664 = fmul double %1638, %1659
  %1665 = fsub double %1663, %1664
  %1666 = add i64 %1536, 1
  %1667 = add nsw i64 %1537, -1
  %1668 = fsub double %1649, %1665
  %1669 = fsub double %1651, %1662
  store double %1668, ptr %1648, align 8, !noalias !97
  store double %1669, ptr %1650, align 8, !noalias !97
  br label %1535

1670:                                             ; preds = %1539
  %1671 = add nsw i64 %1541, -1
  %1672 = mul nsw i64 %1542, %847
  %1673 = add nsw i64 %218, %1672
  %1674 = sub i64 %218, %1540
  %1675 = call i64 @llvm.smax.i64(i64 %1674, i64 0)
  br label %1544

1676:                                             ; preds = %1544
  %1677 = add nsw i64 %1546, -1
  %1678 = add i64 %1545, 1
  %1679 = icmp slt i64 %1542, 0
  %1680 = select i1 %1679, i64 %218, i64 0
  %1681 = add i64 %1542, %1680
  %1682 = icmp slt i64 %1545, 0
  %1683 = select i1 %1682, i64 %220, i64 0
  %1684 = mul i64 %1681, %220
  %1685 = getelementptr { double, double }, ptr %221, i64 %1684
  %1686 = getelementptr { double, double }, ptr %1685, i64 %1545
  %1687 = getelementptr { double, double }, ptr %1686, i64 %1683
  %1688 = load double, ptr %1687, align 8, !noalias !97
  %1689 = getelementptr inbounds nuw i8, ptr %1687, i64 8
  %1690 = load double, ptr %1689, align 8, !noalias !97
  %1691 = mul nsw i64 %1545, %847
  %1692 = add nsw i64 %218, %1691
  br label %1548

1693:                                             ; preds = %1548
  %1694 = add nsw i64 %1673, %1549
  %1695 = icmp slt i64 %1694, 0
  %1696 = select i1 %1695, i64 %266, i64 0
  %1697 = getelementptr { double, double }, ptr %267, i64 %1694
  %1698 = getelementptr { double, double }, ptr %1697, i64 %1696
  %1699 = load double, ptr %1698, align 8, !noalias !97
  %1700 = getelementptr inbounds nuw i8, ptr %1698, i64 8
  %1701 = load double, ptr %1700, align 8, !noalias !97
  %1702 = add nsw i64 %1692, %1549
  %1703 = icmp slt i64 %1702, 0
  %1704 = select i1 %1703, i64 %266, i64 0
  %1705 = getelementptr { double, double }, ptr %267, i64 %1702
  %1706 = getelementptr { double, double }, ptr %1705, i64 %1704
  %1707 = load double, ptr %1706, align 8, !noalias !97
  %1708 = getelementptr inbounds nuw i8, ptr %1706, i64 8
  %1709 = load double, ptr %1708, align 8, !noalias !97
  %1710 = fmul double %1688, %1709
  %1711 = fmul double %1690, %1707
  %1712 = fadd double %1710, %1711
  %1713 = fmul double %1688, %1707
  %1714 = fmul double %1690, %1709
  %1715 = fsub double %1713, %1714
  %1716 = add i64 %1549, 1
  %1717 = add nsw i64 %1550, -1
  %1718 = fsub double %1699, %1715
  %1719 = fsub double %1701, %1712
  store double %1718, ptr %1698, align 8, !noalias !97
  store double %1719, ptr %1700, align 8, !noalias !97
  br label %1548

1720:                                             ; preds = %1588
  %1721 = add nsw i64 %1673, %1589
  %1722 = icmp slt i64 %1721, 0
  %1723 = select i1 %1722, i64 %266, i64 0
  %1724 = getelementptr { double, double }, ptr %267, i64 %1721
  %1725 = getelementptr { double, double }, ptr %1724, i64 %1723
  %1726 = load double, ptr %1725, align 8, !noalias !97
  %1727 = getelementptr inbounds nuw i8, ptr %1725, i64 8
  %1728 = load double, ptr %1727, align 8, !noalias !97
  %1729 = fmul double %1726, %1586
  %1730 = fmul double %1728, %1587
  %1731 = fadd double %1729, %1730
  %1732 = fmul double %1726, %1587
  %1733 = fmul double %1728, %1586
  %1734 = fsub double %1732, %1733
  %1735 = add i64 %1589, 1
  %1736 = add nsw i64 %1590, -1
  store double %1734, ptr %1725, align 8, !noalias !97
  store double %1731, ptr %1727, align 8, !noalias !97
  br label %1588

1737:                                             ; preds = %1131
  %1738 = add nsw i64 %1133, -1
  %1739 = add i64 %1132, 1
  %1740 = icmp slt i64 %1132, 0
  %1741 = select i1 %1740, i64 %64, i64 0
  %1742 = getelementptr double, ptr %65, i64 %1132
  %1743 = getelementptr double, ptr %1742, i64 %1741
  %1744 = load double, ptr %1743, align 8, !noalias !61
  %1745 = select i1 %1740, i64 %99, i64 0
  %1746 = getelementptr double, ptr %100, i64 %1132
  %1747 = getelementptr double, ptr %1746, i64 %1745
  %1748 = load double, ptr %1747, align 8, !noalias !101
  %1749 = select i1 %1740, i64 %94, i64 0
  %1750 = getelementptr double, ptr %95, i64 %1132
  %1751 = getelementptr double, ptr %1750, i64 %1749
  %1752 = load double, ptr %1751, align 8, !noalias !101
  %1753 = call double @llvm.fabs.f64(double %1744)
  %1754 = fmul double %1752, %1753
  %1755 = fadd double %1748, %1754
  %1756 = select i1 %1740, i64 %261, i64 0
  %1757 = getelementptr double, ptr %262, i64 %1132
  %1758 = getelementptr double, ptr %1757, i64 %1756
  %1759 = load double, ptr %1758, align 8, !noalias !61
  %1760 = fdiv double %1759, %1755
  %1761 = select i1 %1740, i64 %266, i64 0
  %1762 = getelementptr { double, double }, ptr %267, i64 %1132
  %1763 = getelementptr { double, double }, ptr %1762, i64 %1761
  %1764 = load double, ptr %1763, align 8, !noalias !61
  %1765 = fdiv double %1764, %1755
  %1766 = getelementptr inbounds nuw i8, ptr %1763, i64 8
  %1767 = load double, ptr %1766, align 8, !noalias !61
  %1768 = fdiv double %1767, %1755
  %1769 = fmul double %1760, %1760
  %1770 = fmul double %1765, %1765
  %1771 = fadd double %1769, %1770
  %1772 = fmul double %1768, %1768
  %1773 = fadd double %1771, %1772
  %1774 = fadd double %1134, %1773
  br label %1131

1775:                                             ; preds = %1171
  %1776 = fcmp ult double %1144, 1.000000e+00
  br i1 %1776, label %1175, label %1840

1777:                                             ; preds = %1182
  %1778 = add nsw i64 %1184, -1
  %1779 = add i64 %1183, 1
  %1780 = icmp slt i64 %1183, 0
  %1781 = select i1 %1780, i64 %244, i64 0
  %1782 = getelementptr double, ptr %245, i64 %1183
  %1783 = getelementptr double, ptr %1782, i64 %1781
  %1784 = load double, ptr %1783, align 8, !noalias !61
  %1785 = select i1 %1780, i64 %261, i64 0
  %1786 = getelementptr double, ptr %262, i64 %1183
  %1787 = getelementptr double, ptr %1786, i64 %1785
  %1788 = load double, ptr %1787, align 8, !noalias !61
  %1789 = fadd double %1784, %1788
  store double %1789, ptr %1783, align 8, !noalias !61
  %1790 = getelementptr double, ptr %245, i64 %244
  %1791 = getelementptr double, ptr %1790, i64 %1183
  %1792 = getelementptr double, ptr %1791, i64 %1781
  %1793 = load double, ptr %1792, align 8, !noalias !61
  %1794 = select i1 %1780, i64 %266, i64 0
  %1795 = getelementptr { double, double }, ptr %267, i64 %1183
  %1796 = getelementptr { double, double }, ptr %1795, i64 %1794
  %1797 = load double, ptr %1796, align 8, !noalias !61
  %1798 = fadd double %1793, %1797
  store double %1798, ptr %1792, align 8, !noalias !61
  %1799 = shl i64 %244, 4
  %1800 = getelementptr i8, ptr %245, i64 %1799
  %1801 = getelementptr double, ptr %1800, i64 %1183
  %1802 = getelementptr double, ptr %1801, i64 %1781
  %1803 = load double, ptr %1802, align 8, !noalias !61
  %1804 = getelementptr inbounds nuw i8, ptr %1796, i64 8
  %1805 = load double, ptr %1804, align 8, !noalias !61
  %1806 = fadd double %1803, %1805
  store double %1806, ptr %1802, align 8, !noalias !61
  br label %1186

1807:                                             ; preds = %1186
  %1808 = add nsw i64 %1188, -1
  %1809 = add i64 %1187, 1
  %1810 = icmp slt i64 %1187, 0
  %1811 = add i64 %1187, 3
  %1812 = select i1 %1810, i64 %1811, i64 %1187
  %1813 = mul i64 %1812, 24
  %1814 = getelementptr i8, ptr @5, i64 %1813
  %1815 = load double, ptr %1814, align 8, !noalias !61
  %1816 = load double, ptr %1783, align 8, !noalias !61
  %1817 = fmul double %1815, %1816
  %1818 = getelementptr i8, ptr @6, i64 %1813
  %1819 = getelementptr i8, ptr %1818, i64 8
  %1820 = load double, ptr %1819, align 8, !noalias !61
  %1821 = load double, ptr %1792, align 8, !noalias !61
  %1822 = fmul double %1820, %1821
  %1823 = fadd double %1817, %1822
  %1824 = getelementptr i8, ptr @7, i64 %1813
  %1825 = getelementptr i8, ptr %1824, i64 16
  %1826 = load double, ptr %1825, align 8, !noalias !61
  %1827 = load double, ptr %1802, align 8, !noalias !61
  %1828 = fmul double %1826, %1827
  %1829 = fadd double %1823, %1828
  %1830 = select i1 %1810, i64 %235, i64 0
  %1831 = add i64 %1187, %1830
  %1832 = select i1 %1780, i64 %237, i64 0
  %1833 = mul i64 %1831, %237
  %1834 = getelementptr double, ptr %238, i64 %1833
  %1835 = getelementptr double, ptr %1834, i64 %1183
  %1836 = getelementptr double, ptr %1835, i64 %1832
  store double %1829, ptr %1836, align 8, !noalias !61
  br label %1186

1837:                                             ; preds = %1208
  %1838 = fmul double %844, %844
  %1839 = fcmp ugt double %1211, %1838
  br i1 %1839, label %1282, label %1283

1840:                                             ; preds = %1171, %959, %894, %1175, %1775, %1323, %897, %1283
  %1841 = phi double [ %1284, %1283 ], [ %1144, %1175 ], [ 0.000000e+00, %897 ], [ 0x7FF0000000000000, %1323 ], [ 0.000000e+00, %894 ], [ 0.000000e+00, %959 ], [ %1144, %1775 ], [ 0.000000e+00, %1171 ]
  %1842 = phi i64 [ %1287, %1283 ], [ %1294, %1175 ], [ %1295, %897 ], [ %1295, %1323 ], [ 0, %894 ], [ 0, %959 ], [ %1294, %1775 ], [ 0, %1171 ]
  %1843 = phi i1 [ %1286, %1283 ], [ true, %1175 ], [ true, %897 ], [ true, %1323 ], [ true, %894 ], [ true, %959 ], [ true, %1775 ], [ true, %1171 ]
  %1844 = phi i64 [ 0, %1283 ], [ 0, %1175 ], [ %898, %897 ], [ 0, %1323 ], [ 0, %894 ], [ 0, %959 ], [ 0, %1775 ], [ 0, %1171 ]
  %1845 = phi i32 [ 0, %1283 ], [ 0, %1175 ], [ 0, %897 ], [ 0, %1323 ], [ %896, %894 ], [ %960, %959 ], [ 0, %1775 ], [ %1174, %1171 ]
  switch i32 %1845, label %2501 [
    i32 -2, label %2499
    i32 0, label %2499
  ], !prof !32

1846:                                             ; preds = %2499
  br label %2632

1847:                                             ; preds = %2499
  br i1 %1843, label %2263, label %1848

1848:                                             ; preds = %1847, %2502
  %1849 = phi i64 [ %2504, %2502 ], [ 0, %1847 ]
  %1850 = phi i64 [ %2503, %2502 ], [ %282, %1847 ]
  %1851 = icmp sgt i64 %1850, 0
  br i1 %1851, label %2502, label %1852

1852:                                             ; preds = %1848
  %1853 = getelementptr i8, ptr %196, i64 32
  %1854 = load i64, ptr %1853, align 8, !noalias !12
  %1855 = icmp ne i64 %1854, 1
  store ptr null, ptr %6, align 8, !noalias !104
  store double 0.000000e+00, ptr %7, align 8, !noalias !104
  store ptr null, ptr %8, align 8, !noalias !104
  store double 0.000000e+00, ptr %9, align 8, !noalias !104
  %1856 = load i64, ptr %116, align 8, !noalias !104
  %1857 = call i64 @llvm.smax.i64(i64 %1856, i64 0)
  br label %1858

1858:                                             ; preds = %1893, %1852
  %1859 = phi i64 [ 0, %1852 ], [ %1895, %1893 ]
  %1860 = phi i64 [ %1857, %1852 ], [ %1894, %1893 ]
  %1861 = icmp sgt i64 %1860, 0
  br i1 %1861, label %1893, label %1862

1862:                                             ; preds = %1858
  store ptr null, ptr %6, align 8, !noalias !104
  %1863 = call fastcc i32 @solve(ptr nonnull %6, ptr %214, i64 %211, i64 %213, ptr %226, i64 %225, ptr %262, i64 %261) #3, !noalias !104
  switch i32 %1863, label %1971 [
    i32 -2, label %1927
    i32 0, label %1927
  ], !prof !32

1864:                                             ; preds = %1930, %1933
  %1865 = phi i64 [ %1935, %1933 ], [ 0, %1930 ]
  %1866 = phi i64 [ %1934, %1933 ], [ %1857, %1930 ]
  %1867 = icmp sgt i64 %1866, 0
  br i1 %1867, label %1933, label %1868

1868:                                             ; preds = %1864
  %1869 = getelementptr i8, ptr %110, i64 24
  %1870 = load i64, ptr %1869, align 8, !noalias !104
  %1871 = add nsw i64 %1870, 1
  store i64 %1871, ptr %1869, align 8, !noalias !104
  store ptr null, ptr %4, align 8, !noalias !108
  store ptr null, ptr %5, align 8, !noalias !108
  store double %366, ptr %33, align 8, !noalias !108
  %1872 = icmp sgt i64 %45, 0
  br i1 %1872, label %1873, label %1876

1873:                                             ; preds = %1868
  store ptr null, ptr %4, align 8, !noalias !108
  %1874 = call fastcc i32 @_sample(ptr nonnull %4, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %366) #3
  switch i32 %1874, label %1875 [
    i32 -2, label %1876
    i32 0, label %1876
  ], !prof !32

1875:                                             ; preds = %1873
  br label %1876

1876:                                             ; preds = %1873, %1873, %1868, %1875
  %1877 = phi i32 [ %1874, %1875 ], [ 0, %1868 ], [ 0, %1873 ], [ 0, %1873 ]
  switch i32 %1877, label %1882 [
    i32 -2, label %1878
    i32 0, label %1878
  ], !prof !32

1878:                                             ; preds = %1876, %1876
  %1879 = load i64, ptr %30, align 8, !noalias !115
  %1880 = inttoptr i64 %1879 to ptr
  %1881 = call i32 %1880(ptr nonnull %33, ptr %75, ptr %38, ptr %41, ptr %250) #3, !noalias !115
  br label %1882

1882:                                             ; preds = %1876, %1878
  %1883 = phi i32 [ %1881, %1878 ], [ 0, %1876 ]
  %1884 = phi i32 [ 0, %1878 ], [ %1877, %1876 ]
  switch i32 %1884, label %1971 [
    i32 -2, label %1949
    i32 0, label %1949
  ], !prof !32

1885:                                             ; preds = %1949
  %1886 = sext i32 %1883 to i64
  br label %1971

1887:                                             ; preds = %1949, %1951
  %1888 = phi i64 [ %1953, %1951 ], [ 0, %1949 ]
  %1889 = phi i64 [ %1952, %1951 ], [ %1857, %1949 ]
  %1890 = icmp sgt i64 %1889, 0
  br i1 %1890, label %1951, label %1891

1891:                                             ; preds = %1887
  store ptr null, ptr %8, align 8, !noalias !104
  %1892 = call fastcc i32 @solve(ptr nonnull %8, ptr %214, i64 %211, i64 %213, ptr %226, i64 %225, ptr %262, i64 %261) #3, !noalias !104
  switch i32 %1892, label %1971 [
    i32 -2, label %1967
    i32 0, label %1967
  ], !prof !32

1893:                                             ; preds = %1858
  %1894 = add nsw i64 %1860, -1
  %1895 = add i64 %1859, 1
  %1896 = icmp slt i64 %1859, 0
  %1897 = select i1 %1896, i64 %237, i64 0
  %1898 = getelementptr double, ptr %238, i64 %1859
  %1899 = getelementptr double, ptr %1898, i64 %1897
  %1900 = load double, ptr %1899, align 8, !noalias !104
  %1901 = fmul double %1900, 0xC02418FD8BAFFE05
  %1902 = getelementptr double, ptr %238, i64 %237
  %1903 = getelementptr double, ptr %1902, i64 %1859
  %1904 = getelementptr double, ptr %1903, i64 %1897
  %1905 = load double, ptr %1904, align 8, !noalias !104
  %1906 = fmul double %1905, 0x3FF61D41B2D54580
  %1907 = fadd double %1901, %1906
  %1908 = shl i64 %237, 4
  %1909 = getelementptr i8, ptr %238, i64 %1908
  %1910 = getelementptr double, ptr %1909, i64 %1859
  %1911 = getelementptr double, ptr %1910, i64 %1897
  %1912 = load double, ptr %1911, align 8, !noalias !104
  %1913 = fmul double %1912, 0xBFD5555555555555
  %1914 = fadd double %1907, %1913
  %1915 = fdiv double %1914, %391
  %1916 = select i1 %1896, i64 %271, i64 0
  %1917 = getelementptr double, ptr %272, i64 %1859
  %1918 = getelementptr double, ptr %1917, i64 %1916
  store double %1915, ptr %1918, align 8, !noalias !104
  %1919 = select i1 %1896, i64 %84, i64 0
  %1920 = getelementptr double, ptr %85, i64 %1859
  %1921 = getelementptr double, ptr %1920, i64 %1919
  %1922 = load double, ptr %1921, align 8, !noalias !104
  %1923 = fadd double %1922, %1915
  %1924 = select i1 %1896, i64 %261, i64 0
  %1925 = getelementptr double, ptr %262, i64 %1859
  %1926 = getelementptr double, ptr %1925, i64 %1924
  store double %1923, ptr %1926, align 8, !noalias !104
  br label %1858

1927:                                             ; preds = %1862, %1862
  store double 0.000000e+00, ptr %7, align 8, !noalias !104
  %1928 = call fastcc i32 @norm(ptr nonnull %7, ptr %262, ptr %70, ptr %65, ptr nonnull %95, i64 %94, ptr %100, i64 %99, i64 %1856) #3, !noalias !104
  %1929 = load double, ptr %7, align 8, !noalias !104
  switch i32 %1928, label %1971 [
    i32 -2, label %1930
    i32 0, label %1930
  ], !prof !32

1930:                                             ; preds = %1927, %1927
  %1931 = fcmp olt double %1929, 1.000000e+00
  %1932 = select i1 %1931, i1 true, i1 %1855
  br i1 %1932, label %1971, label %1864

1933:                                             ; preds = %1864
  %1934 = add nsw i64 %1866, -1
  %1935 = add i64 %1865, 1
  %1936 = icmp slt i64 %1865, 0
  %1937 = select i1 %1936, i64 %64, i64 0
  %1938 = getelementptr double, ptr %65, i64 %1865
  %1939 = getelementptr double, ptr %1938, i64 %1937
  %1940 = load double, ptr %1939, align 8, !noalias !104
  %1941 = select i1 %1936, i64 %261, i64 0
  %1942 = getelementptr double, ptr %262, i64 %1865
  %1943 = getelementptr double, ptr %1942, i64 %1941
  %1944 = load double, ptr %1943, align 8, !noalias !104
  %1945 = fadd double %1940, %1944
  %1946 = select i1 %1936, i64 %74, i64 0
  %1947 = getelementptr double, ptr %75, i64 %1865
  %1948 = getelementptr double, ptr %1947, i64 %1946
  store double %1945, ptr %1948, align 8, !noalias !104
  br label %1864

1949:                                             ; preds = %1882, %1882
  %1950 = icmp eq i32 %1883, 0
  br i1 %1950, label %1887, label %1885

1951:                                             ; preds = %1887
  %1952 = add nsw i64 %1889, -1
  %1953 = add i64 %1888, 1
  %1954 = icmp slt i64 %1888, 0
  %1955 = select i1 %1954, i64 %249, i64 0
  %1956 = getelementptr double, ptr %250, i64 %1888
  %1957 = getelementptr double, ptr %1956, i64 %1955
  %1958 = load double, ptr %1957, align 8, !noalias !104
  %1959 = select i1 %1954, i64 %271, i64 0
  %1960 = getelementptr double, ptr %272, i64 %1888
  %1961 = getelementptr double, ptr %1960, i64 %1959
  %1962 = load double, ptr %1961, align 8, !noalias !104
  %1963 = fadd double %1958, %1962
  %1964 = select i1 %1954, i64 %261, i64 0
  %1965 = getelementptr double, ptr %262, i64 %1888
  %1966 = getelementptr double, ptr %1965, i64 %1964
  store double %1963, ptr %1966, align 8, !noalias !104
  br label %1887

1967:                                             ; preds = %1891, %1891
  store double 0.000000e+00, ptr %9, align 8, !noalias !104
  %1968 = call fastcc i32 @norm(ptr nonnull %9, ptr %262, ptr %70, ptr %65, ptr nonnull %95, i64 %94, ptr %100, i64 %99, i64 %1856) #3, !noalias !104
  switch i32 %1968, label %1971 [
    i32 -2, label %1969
    i32 0, label %1969
  ], !prof !32

1969:                                             ; preds = %1967, %1967
  %1970 = load double, ptr %9, align 8, !noalias !104
  br label %1971

1971:                                             ; preds = %1967, %1891, %1882, %1927, %1862, %1930, %1885, %1969
  %1972 = phi double [ %1929, %1930 ], [ 0.000000e+00, %1862 ], [ %1929, %1885 ], [ 0.000000e+00, %1927 ], [ 0.000000e+00, %1882 ], [ 0.000000e+00, %1891 ], [ %1970, %1969 ], [ 0.000000e+00, %1967 ]
  %1973 = phi i64 [ 0, %1930 ], [ 0, %1862 ], [ %1886, %1885 ], [ 0, %1927 ], [ 0, %1882 ], [ 0, %1891 ], [ 0, %1969 ], [ 0, %1967 ]
  %1974 = phi i32 [ 0, %1930 ], [ %1863, %1862 ], [ 0, %1885 ], [ %1928, %1927 ], [ %1884, %1882 ], [ %1892, %1891 ], [ 0, %1969 ], [ %1968, %1967 ]
  switch i32 %1974, label %2522 [
    i32 -2, label %2520
    i32 0, label %2520
  ], !prof !32

1975:                                             ; preds = %2520
  br label %2632

1976:                                             ; preds = %2520
  %1977 = add nsw i64 %1842, 12
  %1978 = sitofp i64 %1977 to double
  %1979 = fdiv double 0x4027666666666667, %1978
  %1980 = fcmp olt double %1972, 1.000000e-10
  %1981 = select i1 %1980, double 1.000000e-10, double %1972
  %1982 = call double @llvm.pow.f64(double %1981, double -2.500000e-01)
  %1983 = icmp eq i64 %1973, 0
  %1984 = fcmp olt double %1972, 1.000000e+00
  %1985 = select i1 %1983, i1 %1984, i1 false
  br i1 %1985, label %1986, label %2246

1986:                                             ; preds = %1976
  br i1 %275, label %1987, label %2001

1987:                                             ; preds = %1986
  %1988 = getelementptr i8, ptr %157, i64 56
  %1989 = load i64, ptr %1988, align 8, !noalias !12
  %1990 = inttoptr i64 %1989 to ptr
  %1991 = call i64 %1990(i64 %0, double %392, i64 %67) #3, !noalias !12
  %1992 = icmp eq i64 %1991, 0
  br i1 %1992, label %2001, label %1993

1993:                                             ; preds = %1987
  %1994 = load i64, ptr %374, align 8, !noalias !12
  %1995 = add nsw i64 %1994, 1
  store i64 %1995, ptr %374, align 8, !noalias !12
  %1996 = fmul double %391, 2.500000e-01
  %1997 = getelementptr i8, ptr %110, i64 72
  store i64 6, ptr %1997, align 8, !noalias !12
  %1998 = getelementptr i8, ptr %196, i64 16
  %1999 = load i64, ptr %1998, align 8, !noalias !12
  %2000 = sub nsw i64 1, %1999
  store i64 1, ptr %1853, align 8, !noalias !12
  store i64 %2000, ptr %399, align 8, !noalias !12
  br label %2320

2001:                                             ; preds = %1987, %1986
  %2002 = load i64, ptr %372, align 8, !noalias !12
  %2003 = add nsw i64 %2002, 1
  store i64 %2003, ptr %372, align 8, !noalias !12
  %2004 = getelementptr i8, ptr %105, i64 24
  %2005 = load double, ptr %2004, align 8, !noalias !12
  %2006 = fcmp ogt double %2005, 0.000000e+00
  br i1 %2006, label %2007, label %2017

2007:                                             ; preds = %2001
  %2008 = getelementptr i8, ptr %105, i64 32
  %2009 = load double, ptr %2008, align 8, !noalias !12
  %2010 = fdiv double %391, %2009
  %2011 = fdiv double %2005, %1981
  %2012 = call double @llvm.pow.f64(double %2011, double 2.500000e-01)
  %2013 = fmul double %2010, %2012
  %2014 = fcmp olt double %2013, 1.000000e+00
  %2015 = select i1 %2014, double %2013, double 1.000000e+00
  %2016 = fmul double %1982, %2015
  br label %2017

2017:                                             ; preds = %2007, %2001
  %2018 = phi double [ %2016, %2007 ], [ %1982, %2001 ]
  %2019 = fmul double %1979, %2018
  %2020 = fcmp olt double %2019, 1.000000e+01
  %2021 = select i1 %2020, double %2019, double 1.000000e+01
  store double %392, ptr %105, align 8, !noalias !12
  %2022 = getelementptr i8, ptr %105, i64 32
  store double %391, ptr %2022, align 8, !noalias !12
  store double %1981, ptr %2004, align 8, !noalias !12
  br label %2023

2023:                                             ; preds = %2027, %2017
  %2024 = phi i64 [ 0, %2017 ], [ %2525, %2027 ]
  %2025 = phi i64 [ %282, %2017 ], [ %2524, %2027 ]
  %2026 = icmp sgt i64 %2025, 0
  br i1 %2026, label %2523, label %2031

2027:                                             ; preds = %2523, %2580
  %2028 = phi i64 [ 0, %2523 ], [ %2582, %2580 ]
  %2029 = phi i64 [ 3, %2523 ], [ %2581, %2580 ]
  %2030 = icmp sgt i64 %2029, 0
  br i1 %2030, label %2580, label %2023

2031:                                             ; preds = %2023
  store double %391, ptr %764, align 8, !noalias !12
  %2032 = getelementptr i8, ptr %160, i64 8
  %2033 = load i64, ptr %2032, align 8, !noalias !12
  %2034 = icmp sgt i64 %2033, 0
  br i1 %2034, label %2044, label %2035

2035:                                             ; preds = %2031
  %2036 = getelementptr i8, ptr %110, i64 48
  %2037 = load i64, ptr %2036, align 8, !noalias !12
  %2038 = icmp slt i64 %2037, 0
  %2039 = select i1 %2038, i64 %114, i64 0
  %2040 = getelementptr double, ptr %115, i64 %2037
  %2041 = getelementptr double, ptr %2040, i64 %2039
  %2042 = load double, ptr %2041, align 8, !noalias !12
  %2043 = fcmp ugt double %2042, %392
  br i1 %2043, label %2201, label %2051

2044:                                             ; preds = %2031
  %2045 = getelementptr i8, ptr %160, i64 16
  %2046 = load i64, ptr %2045, align 8, !noalias !12
  %2047 = inttoptr i64 %2046 to ptr
  %2048 = call i64 %2047(i64 %0, double %366, double %391) #3, !noalias !12
  %2049 = getelementptr i8, ptr %105, i64 48
  %2050 = load double, ptr %2049, align 8, !noalias !12
  br label %2051

2051:                                             ; preds = %2035, %2044
  %2052 = phi double [ %2050, %2044 ], [ 1.000000e+00, %2035 ]
  %2053 = phi i64 [ %2048, %2044 ], [ 0, %2035 ]
  %2054 = fcmp oeq double %2052, 1.000000e+00
  br i1 %2054, label %2055, label %2057

2055:                                             ; preds = %2051
  %2056 = load double, ptr %105, align 8, !noalias !12
  br label %2060

2057:                                             ; preds = %2051
  %2058 = fmul double %2052, %391
  %2059 = fadd double %366, %2058
  br label %2060

2060:                                             ; preds = %2057, %2055
  %2061 = phi double [ %2056, %2055 ], [ %2059, %2057 ]
  %2062 = fcmp olt double %2052, 1.000000e+00
  %2063 = load i64, ptr %116, align 8, !noalias !12
  %2064 = load i64, ptr %157, align 8, !noalias !12
  %2065 = icmp eq i64 %2064, 1
  %2066 = getelementptr i8, ptr %110, i64 48
  %2067 = load i64, ptr %2066, align 8, !noalias !12
  %2068 = icmp slt i64 %2067, %114
  br i1 %2068, label %2069, label %2112

2069:                                             ; preds = %2060
  %2070 = icmp slt i64 %2067, 0
  %2071 = select i1 %2070, i64 %114, i64 0
  %2072 = getelementptr double, ptr %115, i64 %2067
  %2073 = getelementptr double, ptr %2072, i64 %2071
  %2074 = load double, ptr %2073, align 8, !noalias !12
  %2075 = fcmp olt double %2074, %2061
  %2076 = fcmp oeq double %2074, %2061
  %2077 = and i1 %2076, %2062
  %2078 = or i1 %2075, %2077
  br i1 %2078, label %2079, label %2112

2079:                                             ; preds = %2102, %2069
  %2080 = phi i64 [ %2067, %2069 ], [ %2100, %2102 ]
  %2081 = icmp slt i64 %2080, 0
  %2082 = select i1 %2081, i64 %114, i64 0
  %2083 = getelementptr double, ptr %115, i64 %2080
  %2084 = getelementptr double, ptr %2083, i64 %2082
  %2085 = load double, ptr %2084, align 8, !noalias !12
  %2086 = fsub double %2085, %366
  %2087 = fdiv double %2086, %391
  %2088 = mul nsw i64 %2080, %2063
  %2089 = shl i64 %2088, 3
  %2090 = add i64 %2089, %1
  %2091 = call i64 @llvm.smax.i64(i64 %79, i64 0)
  br label %2597

2092:                                             ; preds = %2601
  %2093 = getelementptr i8, ptr %157, i64 56
  %2094 = load i64, ptr %2093, align 8, !noalias !12
  %2095 = load double, ptr %2084, align 8, !noalias !12
  %2096 = inttoptr i64 %2094 to ptr
  %2097 = call i64 %2096(i64 %0, double %2095, i64 %2090) #3, !noalias !12
  %2098 = icmp eq i64 %2097, 0
  br i1 %2098, label %2099, label %2114

2099:                                             ; preds = %2601, %2092
  %2100 = add nsw i64 %2080, 1
  %2101 = icmp slt i64 %2100, %114
  br i1 %2101, label %2102, label %2112

2102:                                             ; preds = %2099
  %2103 = icmp slt i64 %2080, -1
  %2104 = select i1 %2103, i64 %114, i64 0
  %2105 = getelementptr double, ptr %115, i64 %2100
  %2106 = getelementptr double, ptr %2105, i64 %2104
  %2107 = load double, ptr %2106, align 8, !noalias !12
  %2108 = fcmp olt double %2107, %2061
  %2109 = fcmp oeq double %2107, %2061
  %2110 = and i1 %2109, %2062
  %2111 = or i1 %2108, %2110
  br i1 %2111, label %2079, label %2112

2112:                                             ; preds = %2102, %2069, %2099, %2060
  %2113 = phi i64 [ %2067, %2069 ], [ %2100, %2102 ], [ %2100, %2099 ], [ %2067, %2060 ]
  store i64 %2113, ptr %2066, align 8, !noalias !12
  br label %2114

2114:                                             ; preds = %2092, %2112
  %2115 = phi i1 [ true, %2112 ], [ false, %2092 ]
  %2116 = phi i64 [ 0, %2112 ], [ %2097, %2092 ]
  %2117 = icmp ne i64 %2053, 0
  %2118 = select i1 %2115, i1 %2117, i1 false
  %2119 = and i1 %2118, %2062
  br i1 %2119, label %2120, label %2159

2120:                                             ; preds = %2114
  %2121 = call i64 @llvm.smax.i64(i64 %79, i64 0)
  br label %2122

2122:                                             ; preds = %2120, %2147
  %2123 = phi i64 [ 0, %2120 ], [ %2149, %2147 ]
  %2124 = phi i64 [ %2121, %2120 ], [ %2148, %2147 ]
  %2125 = icmp sgt i64 %2124, 0
  br i1 %2125, label %2147, label %2126

2126:                                             ; preds = %2122
  %2127 = getelementptr i8, ptr %27, i64 24
  %2128 = load i64, ptr %2127, align 8, !noalias !116
  %2129 = getelementptr i8, ptr %30, i64 16
  %2130 = load i64, ptr %2129, align 8, !noalias !116
  call fastcc void @pydy_nested(i64 %72, i64 %62, i64 %87, i64 %64, i64 %2128, i64 %77, i64 %2130) #3, !noalias !116
  %2131 = call i64 @llvm.smax.i64(i64 %69, i64 0)
  br label %2132

2132:                                             ; preds = %2136, %2126
  %2133 = phi i64 [ 0, %2126 ], [ %2138, %2136 ]
  %2134 = phi i64 [ %2131, %2126 ], [ %2137, %2136 ]
  %2135 = icmp sgt i64 %2134, 0
  br i1 %2135, label %2136, label %2613

2136:                                             ; preds = %2132
  %2137 = add nsw i64 %2134, -1
  %2138 = add i64 %2133, 1
  %2139 = icmp slt i64 %2133, 0
  %2140 = select i1 %2139, i64 %74, i64 0
  %2141 = getelementptr double, ptr %75, i64 %2133
  %2142 = getelementptr double, ptr %2141, i64 %2140
  %2143 = load double, ptr %2142, align 8, !noalias !120
  %2144 = select i1 %2139, i64 %69, i64 0
  %2145 = getelementptr double, ptr %70, i64 %2133
  %2146 = getelementptr double, ptr %2145, i64 %2144
  store double %2143, ptr %2146, align 8, !noalias !120
  br label %2132

2147:                                             ; preds = %2122
  %2148 = add nsw i64 %2124, -1
  %2149 = add i64 %2123, 1
  %2150 = icmp slt i64 %2123, 0
  %2151 = select i1 %2150, i64 %79, i64 0
  %2152 = getelementptr double, ptr %80, i64 %2123
  %2153 = getelementptr double, ptr %2152, i64 %2151
  store double %2052, ptr %2153, align 8, !noalias !116
  br label %2122

2154:                                             ; preds = %2613
  %2155 = getelementptr i8, ptr %157, i64 56
  %2156 = load i64, ptr %2155, align 8, !noalias !12
  %2157 = inttoptr i64 %2156 to ptr
  %2158 = call i64 %2157(i64 %0, double %2061, i64 %67) #3, !noalias !12
  br label %2159

2159:                                             ; preds = %2613, %2154, %2114
  %2160 = phi i64 [ %2158, %2154 ], [ 0, %2613 ], [ %2116, %2114 ]
  %2161 = icmp eq i64 %2160, 0
  br i1 %2161, label %2163, label %2162

2162:                                             ; preds = %2159
  store double %366, ptr %105, align 8, !noalias !12
  store double %391, ptr %298, align 8, !noalias !12
  br label %2185

2163:                                             ; preds = %2159
  br i1 %2054, label %2164, label %2166

2164:                                             ; preds = %2163
  store i8 0, ptr %24, align 1, !noalias !12
  %2165 = call fastcc i32 @write_reached(ptr nonnull %24, ptr %30, ptr %70, i64 %69, ptr nonnull %105, ptr nonnull %110, i64 %114, ptr %115, i64 %114, ptr %119, i64 %118) #3
  switch i32 %2165, label %2616 [
    i32 -2, label %2166
    i32 0, label %2166
  ], !prof !32

2166:                                             ; preds = %2164, %2164, %2163
  %2167 = icmp eq i64 %2053, 0
  br i1 %2167, label %2185, label %2168

2168:                                             ; preds = %2166
  %2169 = call i64 @llvm.smax.i64(i64 %64, i64 0)
  br label %2170

2170:                                             ; preds = %2174, %2168
  %2171 = phi i64 [ 0, %2168 ], [ %2176, %2174 ]
  %2172 = phi i64 [ %2169, %2168 ], [ %2175, %2174 ]
  %2173 = icmp sgt i64 %2172, 0
  br i1 %2173, label %2174, label %2617

2174:                                             ; preds = %2170
  %2175 = add nsw i64 %2172, -1
  %2176 = add i64 %2171, 1
  %2177 = icmp slt i64 %2171, 0
  %2178 = select i1 %2177, i64 %69, i64 0
  %2179 = getelementptr double, ptr %70, i64 %2171
  %2180 = getelementptr double, ptr %2179, i64 %2178
  %2181 = load double, ptr %2180, align 8, !noalias !123
  %2182 = select i1 %2177, i64 %64, i64 0
  %2183 = getelementptr double, ptr %65, i64 %2171
  %2184 = getelementptr double, ptr %2183, i64 %2182
  store double %2181, ptr %2184, align 8, !noalias !123
  br label %2170

2185:                                             ; preds = %2166, %2617, %2162
  %2186 = phi i64 [ %2160, %2162 ], [ %2053, %2617 ], [ 0, %2166 ]
  switch i64 %2186, label %2200 [
    i64 6, label %2187
    i64 0, label %2201
  ]

2187:                                             ; preds = %2185
  %2188 = load i64, ptr %2032, align 8, !noalias !12
  %2189 = icmp eq i64 %2188, 0
  br i1 %2189, label %2190, label %2200

2190:                                             ; preds = %2187
  %2191 = load i64, ptr %372, align 8, !noalias !12
  %2192 = add nsw i64 %2191, -1
  store i64 %2192, ptr %372, align 8, !noalias !12
  %2193 = load i64, ptr %374, align 8, !noalias !12
  %2194 = add nsw i64 %2193, 1
  store i64 %2194, ptr %374, align 8, !noalias !12
  %2195 = fmul double %391, 2.500000e-01
  %2196 = getelementptr i8, ptr %110, i64 72
  store i64 6, ptr %2196, align 8, !noalias !12
  %2197 = getelementptr i8, ptr %196, i64 16
  %2198 = load i64, ptr %2197, align 8, !noalias !12
  %2199 = sub nsw i64 1, %2198
  store i64 1, ptr %1853, align 8, !noalias !12
  store i64 %2199, ptr %399, align 8, !noalias !12
  store double 0.000000e+00, ptr %764, align 8, !noalias !12
  br label %2320

2200:                                             ; preds = %2187, %2185
  br label %2632

2201:                                             ; preds = %2185, %2035
  br label %2202

2202:                                             ; preds = %2201, %2618
  %2203 = phi i64 [ 0, %2201 ], [ %2620, %2618 ]
  %2204 = phi i64 [ %282, %2201 ], [ %2619, %2618 ]
  %2205 = icmp sgt i64 %2204, 0
  br i1 %2205, label %2618, label %2206

2206:                                             ; preds = %2202
  %2207 = getelementptr i8, ptr %110, i64 24
  %2208 = load i64, ptr %2207, align 8, !noalias !12
  %2209 = add nsw i64 %2208, 1
  store i64 %2209, ptr %2207, align 8, !noalias !12
  store ptr null, ptr %15, align 8, !noalias !126
  store ptr null, ptr %16, align 8, !noalias !126
  store double %392, ptr %33, align 8, !noalias !126
  %2210 = icmp sgt i64 %45, 0
  br i1 %2210, label %2211, label %2214

2211:                                             ; preds = %2206
  store ptr null, ptr %15, align 8, !noalias !126
  %2212 = call fastcc i32 @_sample(ptr nonnull %15, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %392) #3
  switch i32 %2212, label %2213 [
    i32 -2, label %2214
    i32 0, label %2214
  ], !prof !32

2213:                                             ; preds = %2211
  br label %2214

2214:                                             ; preds = %2211, %2211, %2206, %2213
  %2215 = phi i32 [ %2212, %2213 ], [ 0, %2206 ], [ 0, %2211 ], [ 0, %2211 ]
  switch i32 %2215, label %2220 [
    i32 -2, label %2216
    i32 0, label %2216
  ], !prof !32

2216:                                             ; preds = %2214, %2214
  %2217 = load i64, ptr %30, align 8, !noalias !133
  %2218 = inttoptr i64 %2217 to ptr
  %2219 = call i32 %2218(ptr nonnull %33, ptr %65, ptr %38, ptr %41, ptr %85) #3, !noalias !133
  br label %2220

2220:                                             ; preds = %2214, %2216
  %2221 = phi i32 [ %2219, %2216 ], [ 0, %2214 ]
  %2222 = phi i32 [ 0, %2216 ], [ %2215, %2214 ]
  switch i32 %2222, label %2631 [
    i32 -2, label %2629
    i32 0, label %2629
  ], !prof !32

2223:                                             ; preds = %2629
  %2224 = getelementptr i8, ptr %110, i64 72
  store i64 3, ptr %2224, align 8, !noalias !12
  store double %391, ptr %298, align 8, !noalias !12
  %2225 = icmp slt i32 %2221, 0
  %2226 = select i1 %2225, i64 -4, i64 2
  br label %2632

2227:                                             ; preds = %2629
  %2228 = icmp sgt i64 %1842, 2
  %2229 = fcmp ogt double %1841, 1.000000e-03
  %2230 = select i1 %2228, i1 %2229, i1 false
  %2231 = zext i1 %2230 to i64
  store i64 %2231, ptr %399, align 8, !noalias !12
  %2232 = getelementptr i8, ptr %196, i64 16
  store i64 0, ptr %2232, align 8, !noalias !12
  store i64 0, ptr %1853, align 8, !noalias !12
  %2233 = fcmp ule double %2021, 1.000000e+00
  %2234 = fcmp uge double %2021, 1.200000e+00
  %2235 = or i1 %2233, %2234
  %2236 = select i1 %2235, i1 true, i1 %2230
  br i1 %2236, label %2237, label %2241

2237:                                             ; preds = %2227
  %2238 = fcmp ogt double %2021, 2.000000e-01
  %2239 = select i1 %2238, double %2021, double 2.000000e-01
  %2240 = fmul double %391, %2239
  br label %2241

2241:                                             ; preds = %2227, %2237
  %2242 = phi double [ %2240, %2237 ], [ %391, %2227 ]
  %2243 = getelementptr i8, ptr %110, i64 48
  %2244 = load i64, ptr %2243, align 8, !noalias !12
  %2245 = icmp eq i64 %2244, %114
  br i1 %2245, label %2323, label %364

2246:                                             ; preds = %1976
  %2247 = load i64, ptr %374, align 8, !noalias !12
  %2248 = add nsw i64 %2247, 1
  store i64 %2248, ptr %374, align 8, !noalias !12
  %2249 = select i1 %1983, i64 2, i64 3
  %2250 = getelementptr i8, ptr %110, i64 72
  store i64 %2249, ptr %2250, align 8, !noalias !12
  %2251 = fsub double %1972, %1972
  %2252 = fcmp ord double %2251, 0.000000e+00
  br i1 %2252, label %2253, label %2257

2253:                                             ; preds = %2246
  %2254 = fmul double %1979, %1982
  %2255 = fcmp ogt double %2254, 2.000000e-01
  %2256 = select i1 %2255, double %2254, double 2.000000e-01
  br label %2257

2257:                                             ; preds = %2253, %2246
  %2258 = phi double [ 2.500000e-01, %2246 ], [ %2256, %2253 ]
  %2259 = fmul double %391, %2258
  %2260 = getelementptr i8, ptr %196, i64 16
  %2261 = load i64, ptr %2260, align 8, !noalias !12
  %2262 = sub nsw i64 1, %2261
  store i64 1, ptr %1853, align 8, !noalias !12
  store i64 %2262, ptr %399, align 8, !noalias !12
  br label %2320

2263:                                             ; preds = %1847
  %2264 = load i64, ptr %374, align 8, !noalias !12
  %2265 = add nsw i64 %2264, 1
  store i64 %2265, ptr %374, align 8, !noalias !12
  %2266 = icmp eq i64 %1844, 0
  br i1 %2266, label %2269, label %2267

2267:                                             ; preds = %2263
  %2268 = getelementptr i8, ptr %110, i64 72
  store i64 3, ptr %2268, align 8, !noalias !12
  br label %2276

2269:                                             ; preds = %2263
  %2270 = fsub double %1841, %1841
  %2271 = fcmp ord double %2270, 0.000000e+00
  br i1 %2271, label %2272, label %2274

2272:                                             ; preds = %2269
  %2273 = getelementptr i8, ptr %110, i64 72
  store i64 7, ptr %2273, align 8, !noalias !12
  br label %2276

2274:                                             ; preds = %2269
  %2275 = getelementptr i8, ptr %110, i64 72
  store i64 4, ptr %2275, align 8, !noalias !12
  br label %2276

2276:                                             ; preds = %2274, %2272, %2267
  %2277 = getelementptr i8, ptr %196, i64 16
  %2278 = load i64, ptr %2277, align 8, !noalias !12
  %2279 = icmp eq i64 %2278, 1
  %2280 = and i1 %2279, %2266
  br i1 %2280, label %2281, label %2308

2281:                                             ; preds = %2276
  %2282 = call i64 @llvm.smax.i64(i64 %206, i64 0)
  br label %2283

2283:                                             ; preds = %2295, %2281
  %2284 = phi i64 [ 0, %2281 ], [ %2303, %2295 ]
  %2285 = phi i64 [ %2282, %2281 ], [ %2302, %2295 ]
  %2286 = phi i1 [ false, %2281 ], [ %2296, %2295 ]
  %2287 = icmp sgt i64 %2285, 0
  br i1 %2287, label %2301, label %2304

2288:                                             ; preds = %2301
  %2289 = icmp slt i64 %2284, 0
  %2290 = select i1 %2289, i64 %206, i64 0
  %2291 = getelementptr double, ptr %207, i64 %2284
  %2292 = getelementptr double, ptr %2291, i64 %2290
  %2293 = load double, ptr %2292, align 8, !noalias !134
  %2294 = fcmp une double %2293, 0.000000e+00
  br label %2295

2295:                                             ; preds = %2301, %2288
  %2296 = phi i1 [ true, %2301 ], [ %2294, %2288 ]
  %2297 = icmp slt i64 %2284, 0
  %2298 = select i1 %2297, i64 %206, i64 0
  %2299 = getelementptr double, ptr %207, i64 %2284
  %2300 = getelementptr double, ptr %2299, i64 %2298
  store double 0.000000e+00, ptr %2300, align 8, !noalias !134
  br label %2283

2301:                                             ; preds = %2283
  %2302 = add nsw i64 %2285, -1
  %2303 = add i64 %2284, 1
  br i1 %2286, label %2295, label %2288

2304:                                             ; preds = %2283
  br i1 %2286, label %2305, label %2306

2305:                                             ; preds = %2304
  store i64 0, ptr %442, align 8, !noalias !12
  br label %2320

2306:                                             ; preds = %2304
  store i64 0, ptr %2277, align 8, !noalias !12
  %2307 = fmul double %391, 5.000000e-01
  br label %2308

2308:                                             ; preds = %2306, %2276
  %2309 = phi double [ %2307, %2306 ], [ %365, %2276 ]
  %2310 = load i64, ptr %2277, align 8, !noalias !12
  %2311 = icmp ne i64 %2310, 1
  %2312 = and i1 %2311, %2266
  br i1 %2312, label %2316, label %2313

2313:                                             ; preds = %2308
  %2314 = select i1 %2266, double 5.000000e-01, double 2.500000e-01
  %2315 = fmul double %391, %2314
  store double 0.000000e+00, ptr %764, align 8, !noalias !12
  br label %2316

2316:                                             ; preds = %2308, %2313
  %2317 = phi double [ %2315, %2313 ], [ %2309, %2308 ]
  %2318 = load i64, ptr %2277, align 8, !noalias !12
  %2319 = sub nsw i64 1, %2318
  store i64 %2319, ptr %399, align 8, !noalias !12
  br label %2320

2320:                                             ; preds = %2316, %2305, %2257, %2190, %1993, %755
  %2321 = phi double [ %2259, %2257 ], [ %1996, %1993 ], [ %2195, %2190 ], [ %365, %2305 ], [ %2317, %2316 ], [ %758, %755 ]
  br label %361

2322:                                             ; preds = %381
  store double %391, ptr %298, align 8, !noalias !12
  br label %2632

2323:                                             ; preds = %2241
  store double %2242, ptr %298, align 8, !noalias !12
  br label %2632

2324:                                             ; preds = %283
  %2325 = icmp slt i64 %284, 0
  %2326 = select i1 %2325, i64 %94, i64 0
  %2327 = getelementptr double, ptr %95, i64 %284
  %2328 = getelementptr double, ptr %2327, i64 %2326
  %2329 = load double, ptr %2328, align 8, !noalias !12
  %2330 = fcmp olt double %2329, %286
  %2331 = select i1 %2330, double %2329, double %286
  %2332 = add i64 %284, 1
  %2333 = add nsw i64 %285, -1
  br label %283

2334:                                             ; preds = %316, %316
  %2335 = icmp eq i32 %317, 0
  br i1 %2335, label %323, label %319

2336:                                             ; preds = %316
  br label %2632

2337:                                             ; preds = %323, %323
  %2338 = load i8, ptr %23, align 1, !noalias !12
  %2339 = icmp eq i8 %2338, 0
  br i1 %2339, label %330, label %329

2340:                                             ; preds = %323
  br label %2632

2341:                                             ; preds = %337, %332
  br label %2632

2342:                                             ; preds = %414, %414
  %2343 = load i64, ptr %196, align 8, !noalias !12
  %2344 = inttoptr i64 %2343 to ptr
  %2345 = call i32 %2344(ptr nonnull %33, ptr %65, ptr %38, ptr %202, ptr %207) #3, !noalias !12
  %2346 = sext i32 %2345 to i64
  br label %434

2347:                                             ; preds = %414
  br label %2632

2348:                                             ; preds = %418
  %2349 = add nsw i64 %420, -1
  %2350 = add i64 %419, 1
  %2351 = icmp slt i64 %419, 0
  %2352 = select i1 %2351, i64 %64, i64 0
  %2353 = getelementptr double, ptr %65, i64 %419
  %2354 = getelementptr double, ptr %2353, i64 %2352
  %2355 = load double, ptr %2354, align 8, !noalias !12
  %2356 = select i1 %2351, i64 %74, i64 0
  %2357 = getelementptr double, ptr %75, i64 %419
  %2358 = getelementptr double, ptr %2357, i64 %2356
  store double %2355, ptr %2358, align 8, !noalias !12
  br label %418

2359:                                             ; preds = %422
  %2360 = add nsw i64 %424, -1
  %2361 = add i64 %423, 1
  %2362 = icmp slt i64 %423, 0
  %2363 = select i1 %2362, i64 %64, i64 0
  %2364 = getelementptr double, ptr %65, i64 %423
  %2365 = getelementptr double, ptr %2364, i64 %2363
  %2366 = load double, ptr %2365, align 8, !noalias !12
  %2367 = call double @llvm.fabs.f64(double %2366)
  %2368 = fcmp olt double %2367, 1.000000e-05
  %2369 = select i1 %2368, double 1.000000e-05, double %2367
  %2370 = fmul double %2369, 1.500000e-08
  %2371 = fadd double %2366, %2370
  %2372 = fsub double %2371, %2366
  %2373 = select i1 %2362, i64 %74, i64 0
  %2374 = getelementptr double, ptr %75, i64 %423
  %2375 = getelementptr double, ptr %2374, i64 %2373
  store double %2371, ptr %2375, align 8, !noalias !12
  %2376 = getelementptr i8, ptr %110, i64 24
  %2377 = load i64, ptr %2376, align 8, !noalias !12
  %2378 = add nsw i64 %2377, 1
  store i64 %2378, ptr %2376, align 8, !noalias !12
  store ptr null, ptr %17, align 8, !noalias !137
  store ptr null, ptr %18, align 8, !noalias !137
  store double %366, ptr %33, align 8, !noalias !137
  %2379 = icmp sgt i64 %45, 0
  br i1 %2379, label %2380, label %2383

2380:                                             ; preds = %2359
  store ptr null, ptr %17, align 8, !noalias !137
  %2381 = call fastcc i32 @_sample(ptr nonnull %17, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %366) #3
  switch i32 %2381, label %2382 [
    i32 -2, label %2383
    i32 0, label %2383
  ], !prof !32

2382:                                             ; preds = %2380
  br label %2383

2383:                                             ; preds = %2380, %2380, %2359, %2382
  %2384 = phi i32 [ %2381, %2382 ], [ 0, %2359 ], [ 0, %2380 ], [ 0, %2380 ]
  switch i32 %2384, label %2389 [
    i32 -2, label %2385
    i32 0, label %2385
  ], !prof !32

2385:                                             ; preds = %2383, %2383
  %2386 = load i64, ptr %30, align 8, !noalias !144
  %2387 = inttoptr i64 %2386 to ptr
  %2388 = call i32 %2387(ptr nonnull %33, ptr %75, ptr %38, ptr %41, ptr %70) #3, !noalias !144
  br label %2389

2389:                                             ; preds = %2383, %2385
  %2390 = phi i32 [ %2388, %2385 ], [ 0, %2383 ]
  %2391 = phi i32 [ 0, %2385 ], [ %2384, %2383 ]
  switch i32 %2391, label %2394 [
    i32 -2, label %2392
    i32 0, label %2392
  ], !prof !32

2392:                                             ; preds = %2389, %2389
  %2393 = icmp eq i32 %2390, 0
  br i1 %2393, label %428, label %426

2394:                                             ; preds = %2389
  br label %2632

2395:                                             ; preds = %428
  %2396 = add nsw i64 %430, -1
  %2397 = add i64 %429, 1
  %2398 = icmp slt i64 %429, 0
  %2399 = select i1 %2398, i64 %69, i64 0
  %2400 = getelementptr double, ptr %70, i64 %429
  %2401 = getelementptr double, ptr %2400, i64 %2399
  %2402 = load double, ptr %2401, align 8, !noalias !12
  %2403 = select i1 %2398, i64 %84, i64 0
  %2404 = getelementptr double, ptr %85, i64 %429
  %2405 = getelementptr double, ptr %2404, i64 %2403
  %2406 = load double, ptr %2405, align 8, !noalias !12
  %2407 = fsub double %2402, %2406
  %2408 = fdiv double %2407, %2372
  %2409 = mul nsw i64 %429, %403
  %2410 = add nsw i64 %2409, %423
  %2411 = icmp slt i64 %2410, 0
  %2412 = select i1 %2411, i64 %206, i64 0
  %2413 = getelementptr double, ptr %207, i64 %2410
  %2414 = getelementptr double, ptr %2413, i64 %2412
  store double %2408, ptr %2414, align 8, !noalias !12
  br label %428

2415:                                             ; preds = %453
  %2416 = add nsw i64 %455, -1
  %2417 = add i64 %454, 1
  br label %457

2418:                                             ; preds = %457
  %2419 = add nsw i64 %459, -1
  %2420 = add i64 %458, 1
  %2421 = mul nsw i64 %454, %225
  %2422 = add nsw i64 %2421, %458
  %2423 = icmp slt i64 %2422, 0
  %2424 = select i1 %2423, i64 %206, i64 0
  %2425 = getelementptr double, ptr %207, i64 %2422
  %2426 = getelementptr double, ptr %2425, i64 %2424
  %2427 = load double, ptr %2426, align 8, !noalias !12
  %2428 = fneg double %2427
  %2429 = icmp slt i64 %454, 0
  %2430 = select i1 %2429, i64 %211, i64 0
  %2431 = add i64 %454, %2430
  %2432 = icmp slt i64 %458, 0
  %2433 = select i1 %2432, i64 %213, i64 0
  %2434 = mul i64 %2431, %213
  %2435 = getelementptr double, ptr %214, i64 %2434
  %2436 = getelementptr double, ptr %2435, i64 %458
  %2437 = getelementptr double, ptr %2436, i64 %2433
  store double %2428, ptr %2437, align 8, !noalias !12
  %2438 = load double, ptr %2426, align 8, !noalias !12
  %2439 = fneg double %2438
  %2440 = select i1 %2429, i64 %218, i64 0
  %2441 = add i64 %454, %2440
  %2442 = select i1 %2432, i64 %220, i64 0
  %2443 = mul i64 %2441, %220
  %2444 = getelementptr { double, double }, ptr %221, i64 %2443
  %2445 = getelementptr { double, double }, ptr %2444, i64 %458
  %2446 = getelementptr { double, double }, ptr %2445, i64 %2442
  store double %2439, ptr %2446, align 8, !noalias !12
  %2447 = getelementptr inbounds nuw i8, ptr %2446, i64 8
  store double 0.000000e+00, ptr %2447, align 8, !noalias !12
  br label %457

2448:                                             ; preds = %766
  %2449 = add nsw i64 %768, -1
  %2450 = add i64 %767, 1
  %2451 = fcmp ogt double %765, 0.000000e+00
  br i1 %2451, label %770, label %779

2452:                                             ; preds = %781
  %2453 = add nsw i64 %783, -1
  %2454 = add i64 %782, 1
  br i1 %2451, label %785, label %825

2455:                                             ; preds = %835
  %2456 = add nsw i64 %837, -1
  %2457 = add i64 %836, 1
  br label %839

2458:                                             ; preds = %839
  %2459 = add nsw i64 %841, -1
  %2460 = add i64 %840, 1
  %2461 = icmp slt i64 %836, 0
  %2462 = add i64 %836, 3
  %2463 = select i1 %2461, i64 %2462, i64 %836
  %2464 = mul i64 %2463, 24
  %2465 = getelementptr i8, ptr @1, i64 %2464
  %2466 = load double, ptr %2465, align 8, !noalias !12
  %2467 = icmp slt i64 %840, 0
  %2468 = select i1 %2467, i64 %237, i64 0
  %2469 = getelementptr double, ptr %238, i64 %840
  %2470 = getelementptr double, ptr %2469, i64 %2468
  %2471 = load double, ptr %2470, align 8, !noalias !12
  %2472 = fmul double %2466, %2471
  %2473 = getelementptr i8, ptr @2, i64 %2464
  %2474 = getelementptr i8, ptr %2473, i64 8
  %2475 = load double, ptr %2474, align 8, !noalias !12
  %2476 = getelementptr double, ptr %238, i64 %237
  %2477 = getelementptr double, ptr %2476, i64 %840
  %2478 = getelementptr double, ptr %2477, i64 %2468
  %2479 = load double, ptr %2478, align 8, !noalias !12
  %2480 = fmul double %2475, %2479
  %2481 = fadd double %2472, %2480
  %2482 = getelementptr i8, ptr @3, i64 %2464
  %2483 = getelementptr i8, ptr %2482, i64 16
  %2484 = load double, ptr %2483, align 8, !noalias !12
  %2485 = shl i64 %237, 4
  %2486 = getelementptr i8, ptr %238, i64 %2485
  %2487 = getelementptr double, ptr %2486, i64 %840
  %2488 = getelementptr double, ptr %2487, i64 %2468
  %2489 = load double, ptr %2488, align 8, !noalias !12
  %2490 = fmul double %2484, %2489
  %2491 = fadd double %2481, %2490
  %2492 = select i1 %2461, i64 %242, i64 0
  %2493 = add i64 %836, %2492
  %2494 = select i1 %2467, i64 %244, i64 0
  %2495 = mul i64 %2493, %244
  %2496 = getelementptr double, ptr %245, i64 %2495
  %2497 = getelementptr double, ptr %2496, i64 %840
  %2498 = getelementptr double, ptr %2497, i64 %2494
  store double %2491, ptr %2498, align 8, !noalias !12
  br label %839

2499:                                             ; preds = %1840, %1840
  %2500 = icmp slt i64 %1844, 0
  br i1 %2500, label %1846, label %1847

2501:                                             ; preds = %1840
  br label %2632

2502:                                             ; preds = %1848
  %2503 = add nsw i64 %1850, -1
  %2504 = add i64 %1849, 1
  %2505 = icmp slt i64 %1849, 0
  %2506 = select i1 %2505, i64 %64, i64 0
  %2507 = getelementptr double, ptr %65, i64 %1849
  %2508 = getelementptr double, ptr %2507, i64 %2506
  %2509 = load double, ptr %2508, align 8, !noalias !12
  %2510 = select i1 %2505, i64 %237, i64 0
  %2511 = shl i64 %237, 4
  %2512 = getelementptr i8, ptr %238, i64 %2511
  %2513 = getelementptr double, ptr %2512, i64 %1849
  %2514 = getelementptr double, ptr %2513, i64 %2510
  %2515 = load double, ptr %2514, align 8, !noalias !12
  %2516 = fadd double %2509, %2515
  %2517 = select i1 %2505, i64 %69, i64 0
  %2518 = getelementptr double, ptr %70, i64 %1849
  %2519 = getelementptr double, ptr %2518, i64 %2517
  store double %2516, ptr %2519, align 8, !noalias !12
  br label %1848

2520:                                             ; preds = %1971, %1971
  %2521 = icmp slt i64 %1973, 0
  br i1 %2521, label %1975, label %1976

2522:                                             ; preds = %1971
  br label %2632

2523:                                             ; preds = %2023
  %2524 = add nsw i64 %2025, -1
  %2525 = add i64 %2024, 1
  %2526 = icmp slt i64 %2024, 0
  %2527 = select i1 %2526, i64 %237, i64 0
  %2528 = getelementptr double, ptr %238, i64 %2024
  %2529 = getelementptr double, ptr %2528, i64 %2527
  %2530 = load double, ptr %2529, align 8, !noalias !12
  %2531 = fmul double %2530, 0xC039A12CE7B30915
  %2532 = getelementptr double, ptr %238, i64 %237
  %2533 = getelementptr double, ptr %2532, i64 %2024
  %2534 = getelementptr double, ptr %2533, i64 %2527
  %2535 = load double, ptr %2534, align 8, !noalias !12
  %2536 = fmul double %2535, 0x402497AF24BB677E
  %2537 = fadd double %2531, %2536
  %2538 = shl i64 %237, 4
  %2539 = getelementptr i8, ptr %238, i64 %2538
  %2540 = getelementptr double, ptr %2539, i64 %2024
  %2541 = getelementptr double, ptr %2540, i64 %2527
  %2542 = load double, ptr %2541, align 8, !noalias !12
  %2543 = fmul double %2542, 0xC005555555555555
  %2544 = fadd double %2537, %2543
  %2545 = fmul double %2530, 0x402F295C43B61425
  %2546 = fmul double %2535, 0xC021D406EE60BECF
  %2547 = fadd double %2545, %2546
  %2548 = fmul double %2542, 0x400AAAAAAAAAAAAB
  %2549 = fadd double %2547, %2548
  %2550 = select i1 %2526, i64 %69, i64 0
  %2551 = getelementptr double, ptr %70, i64 %2024
  %2552 = getelementptr double, ptr %2551, i64 %2550
  %2553 = load double, ptr %2552, align 8, !noalias !12
  %2554 = select i1 %2526, i64 %64, i64 0
  %2555 = getelementptr double, ptr %65, i64 %2024
  %2556 = getelementptr double, ptr %2555, i64 %2554
  %2557 = load double, ptr %2556, align 8, !noalias !12
  %2558 = fsub double %2553, %2557
  %2559 = select i1 %2526, i64 %89, i64 0
  %2560 = getelementptr double, ptr %90, i64 %2024
  %2561 = getelementptr double, ptr %2560, i64 %2559
  store double %2558, ptr %2561, align 8, !noalias !12
  %2562 = fneg double %2544
  %2563 = fsub double %2562, %2549
  %2564 = add nsw i64 %64, %2024
  %2565 = icmp slt i64 %2564, 0
  %2566 = select i1 %2565, i64 %89, i64 0
  %2567 = getelementptr double, ptr %90, i64 %2564
  %2568 = getelementptr double, ptr %2567, i64 %2566
  store double %2563, ptr %2568, align 8, !noalias !12
  %2569 = fneg double %2549
  %2570 = shl nsw i64 %64, 1
  %2571 = add nsw i64 %2570, %2024
  %2572 = icmp slt i64 %2571, 0
  %2573 = select i1 %2572, i64 %89, i64 0
  %2574 = getelementptr double, ptr %90, i64 %2571
  %2575 = getelementptr double, ptr %2574, i64 %2573
  store double %2569, ptr %2575, align 8, !noalias !12
  %2576 = load double, ptr %2556, align 8, !noalias !12
  %2577 = select i1 %2526, i64 %256, i64 0
  %2578 = getelementptr double, ptr %257, i64 %2024
  %2579 = getelementptr double, ptr %2578, i64 %2577
  store double %2576, ptr %2579, align 8, !noalias !12
  br label %2027

2580:                                             ; preds = %2027
  %2581 = add nsw i64 %2029, -1
  %2582 = add i64 %2028, 1
  %2583 = mul nsw i64 %2028, %64
  %2584 = add nsw i64 %2583, %2024
  %2585 = icmp slt i64 %2584, 0
  %2586 = select i1 %2585, i64 %89, i64 0
  %2587 = getelementptr double, ptr %90, i64 %2584
  %2588 = getelementptr double, ptr %2587, i64 %2586
  %2589 = load double, ptr %2588, align 8, !noalias !12
  %2590 = icmp slt i64 %2028, -1
  %2591 = select i1 %2590, i64 %254, i64 0
  %2592 = add i64 %2582, %2591
  %2593 = mul i64 %2592, %256
  %2594 = getelementptr double, ptr %257, i64 %2593
  %2595 = getelementptr double, ptr %2594, i64 %2024
  %2596 = getelementptr double, ptr %2595, i64 %2577
  store double %2589, ptr %2596, align 8, !noalias !12
  br label %2027

2597:                                             ; preds = %2079, %2606
  %2598 = phi i64 [ 0, %2079 ], [ %2608, %2606 ]
  %2599 = phi i64 [ %2091, %2079 ], [ %2607, %2606 ]
  %2600 = icmp sgt i64 %2599, 0
  br i1 %2600, label %2606, label %2601

2601:                                             ; preds = %2597
  %2602 = getelementptr i8, ptr %27, i64 24
  %2603 = load i64, ptr %2602, align 8, !noalias !145
  %2604 = getelementptr i8, ptr %30, i64 16
  %2605 = load i64, ptr %2604, align 8, !noalias !145
  call fastcc void @pydy_nested(i64 %2090, i64 %62, i64 %87, i64 %64, i64 %2603, i64 %77, i64 %2605) #3, !noalias !145
  br i1 %2065, label %2092, label %2099

2606:                                             ; preds = %2597
  %2607 = add nsw i64 %2599, -1
  %2608 = add i64 %2598, 1
  %2609 = icmp slt i64 %2598, 0
  %2610 = select i1 %2609, i64 %79, i64 0
  %2611 = getelementptr double, ptr %80, i64 %2598
  %2612 = getelementptr double, ptr %2611, i64 %2610
  store double %2087, ptr %2612, align 8, !noalias !145
  br label %2597

2613:                                             ; preds = %2132
  %2614 = load i64, ptr %157, align 8, !noalias !12
  %2615 = icmp eq i64 %2614, 1
  br i1 %2615, label %2154, label %2159

2616:                                             ; preds = %2164
  br label %2632

2617:                                             ; preds = %2170
  store double %2061, ptr %105, align 8, !noalias !12
  store double 0.000000e+00, ptr %298, align 8, !noalias !12
  store i64 0, ptr %110, align 8, !noalias !12
  br label %2185

2618:                                             ; preds = %2202
  %2619 = add nsw i64 %2204, -1
  %2620 = add i64 %2203, 1
  %2621 = icmp slt i64 %2203, 0
  %2622 = select i1 %2621, i64 %69, i64 0
  %2623 = getelementptr double, ptr %70, i64 %2203
  %2624 = getelementptr double, ptr %2623, i64 %2622
  %2625 = load double, ptr %2624, align 8, !noalias !12
  %2626 = select i1 %2621, i64 %64, i64 0
  %2627 = getelementptr double, ptr %65, i64 %2203
  %2628 = getelementptr double, ptr %2627, i64 %2626
  store double %2625, ptr %2628, align 8, !noalias !12
  br label %2202

2629:                                             ; preds = %2220, %2220
  %2630 = icmp eq i32 %2221, 0
  br i1 %2630, label %2227, label %2223

2631:                                             ; preds = %2220
  br label %2632

2632:                                             ; preds = %2631, %2616, %2522, %2501, %2394, %2347, %2341, %2340, %2336, %2323, %2322, %2223, %2200, %1975, %1846, %437, %380, %369, %329, %319, %192
  %2633 = phi i64 [ -4, %1846 ], [ -1, %192 ], [ 2, %2322 ], [ %2186, %2200 ], [ 0, %2501 ], [ 0, %2631 ], [ %2226, %2223 ], [ 0, %2336 ], [ %322, %319 ], [ 0, %2340 ], [ 0, %329 ], [ 0, %2341 ], [ -1, %369 ], [ 1, %380 ], [ 0, %2347 ], [ -4, %437 ], [ 0, %2394 ], [ 0, %2522 ], [ -4, %1975 ], [ 0, %2323 ], [ 0, %2616 ]
  ret i64 %2633
}



declare i64 @llvm.smax.i64(i64, i64) #0

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #0

declare i64 @llvm.smin.i64(i64, i64) #0

attributes #0 = { nounwind willreturn memory(none) }
attributes #1 = { nounwind memory(read) }
attributes #2 = { noinline }
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
!9 = !{!10}
!10 = distinct !{!10, !11}
!11 = distinct !{!11}
!12 = !{!13, !15}
!13 = distinct !{!13, !14}
!14 = distinct !{!14}
!15 = distinct !{!15, !14}
!16 = !{!17, !13, !15}
!17 = distinct !{!17, !18}
!18 = distinct !{!18}
!19 = !{!20, !17, !13, !15}
!20 = distinct !{!20, !21}
!21 = distinct !{!21}
!22 = !{!23, !17, !13, !15}
!23 = distinct !{!23, !24}
!24 = distinct !{!24}
!25 = !{!26, !28, !29, !31}
!26 = distinct !{!26, !27}
!27 = distinct !{!27}
!28 = distinct !{!28, !27}
!29 = distinct !{!29, !30}
!30 = distinct !{!30}
!31 = distinct !{!31, !30}
!32 = !{!"branch_weights", i32 1, i32 49, i32 49}
!33 = !{!29, !31}
!34 = !{!35, !37, !13, !15}
!35 = distinct !{!35, !36}
!36 = distinct !{!36}
!37 = distinct !{!37, !36}
!38 = !{!39, !41}
!39 = distinct !{!39, !40}
!40 = distinct !{!40}
!41 = distinct !{!41, !40}
!42 = !{!43}
!43 = distinct !{!43, !44}
!44 = distinct !{!44}
!45 = !{!46, !48}
!46 = distinct !{!46, !47}
!47 = distinct !{!47}
!48 = distinct !{!48, !47}
!49 = !{!50, !52, !54, !46, !48}
!50 = distinct !{!50, !51}
!51 = distinct !{!51}
!52 = distinct !{!52, !53}
!53 = distinct !{!53}
!54 = distinct !{!54, !53}
!55 = !{!56, !58, !60, !46, !48}
!56 = distinct !{!56, !57}
!57 = distinct !{!57}
!58 = distinct !{!58, !59}
!59 = distinct !{!59}
!60 = distinct !{!60, !59}
!61 = !{!62, !64}
!62 = distinct !{!62, !63}
!63 = distinct !{!63}
!64 = distinct !{!64, !63}
!65 = !{!66, !68, !69, !71, !62, !64}
!66 = distinct !{!66, !67}
!67 = distinct !{!67}
!68 = distinct !{!68, !67}
!69 = distinct !{!69, !70}
!70 = distinct !{!70}
!71 = distinct !{!71, !70}
!72 = !{!69, !71, !62, !64}
!73 = !{!74, !62, !64}
!74 = distinct !{!74, !75}
!75 = distinct !{!75}
!76 = !{!"branch_weights", i32 49, i32 1}
!77 = !{!78, !80, !62, !64}
!78 = distinct !{!78, !79}
!79 = distinct !{!79}
!80 = distinct !{!80, !79}
!81 = !{!82, !84, !86, !78, !80, !62, !64}
!82 = distinct !{!82, !83}
!83 = distinct !{!83}
!84 = distinct !{!84, !85}
!85 = distinct !{!85}
!86 = distinct !{!86, !85}
!87 = !{!88, !90, !92, !78, !80, !62, !64}
!88 = distinct !{!88, !89}
!89 = distinct !{!89}
!90 = distinct !{!90, !91}
!91 = distinct !{!91}
!92 = distinct !{!92, !91}
!93 = !{!94, !96, !62, !64}
!94 = distinct !{!94, !95}
!95 = distinct !{!95}
!96 = distinct !{!96, !95}
!97 = !{!98, !100, !62, !64}
!98 = distinct !{!98, !99}
!99 = distinct !{!99}
!100 = distinct !{!100, !99}
!101 = !{!102, !62, !64}
!102 = distinct !{!102, !103}
!103 = distinct !{!103}
!104 = !{!105, !107}
!105 = distinct !{!105, !106}
!106 = distinct !{!106}
!107 = distinct !{!107, !106}
!108 = !{!109, !111, !112, !114, !105, !107}
!109 = distinct !{!109, !110}
!110 = distinct !{!110}
!111 = distinct !{!111, !110}
!112 = distinct !{!112, !113}
!113 = distinct !{!113}
!114 = distinct !{!114, !113}
!115 = !{!112, !114, !105, !107}
!116 = !{!117, !119, !13, !15}
!117 = distinct !{!117, !118}
!118 = distinct !{!118}
!119 = distinct !{!119, !118}
!120 = !{!121}
!121 = distinct !{!121, !122}
!122 = distinct !{!122}
!123 = !{!124}
!124 = distinct !{!124, !125}
!125 = distinct !{!125}
!126 = !{!127, !129, !130, !132}
!127 = distinct !{!127, !128}
!128 = distinct !{!128}
!129 = distinct !{!129, !128}
!130 = distinct !{!130, !131}
!131 = distinct !{!131}
!132 = distinct !{!132, !131}
!133 = !{!130, !132}
!134 = !{!135}
!135 = distinct !{!135, !136}
!136 = distinct !{!136}
!137 = !{!138, !140, !141, !143}
!138 = distinct !{!138, !139}
!139 = distinct !{!139}
!140 = distinct !{!140, !139}
!141 = distinct !{!141, !142}
!142 = distinct !{!142}
!143 = distinct !{!143, !142}
!144 = !{!141, !143}
!145 = !{!146, !148, !13, !15}
!146 = distinct !{!146, !147}
!147 = distinct !{!147}
!148 = distinct !{!148, !147}
