; sources 5a0826a5b8c08433328c6939a4879bf5161045b5cabf16235e5e8b0509834956
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
  br label %2683

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

283:                                              ; preds = %2365, %193
  %284 = phi i64 [ 0, %193 ], [ %2373, %2365 ]
  %285 = phi i64 [ %282, %193 ], [ %2374, %2365 ]
  %286 = phi double [ %281, %193 ], [ %2372, %2365 ]
  %287 = icmp sgt i64 %285, 0
  br i1 %287, label %2365, label %288

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
  switch i32 %318, label %2377 [
    i32 -2, label %2375
    i32 0, label %2375
  ], !prof !32

319:                                              ; preds = %2375
  %320 = getelementptr i8, ptr %110, i64 72
  store i64 3, ptr %320, align 8, !noalias !12
  %321 = icmp slt i32 %317, 0
  %322 = select i1 %321, i64 -4, i64 2
  br label %2683

323:                                              ; preds = %2375
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
  switch i32 %328, label %2381 [
    i32 -2, label %2378
    i32 0, label %2378
  ], !prof !32

329:                                              ; preds = %2378
  br label %2683

330:                                              ; preds = %2378
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
  switch i32 %335, label %2382 [
    i32 -2, label %337
    i32 0, label %337
  ], !prof !32

337:                                              ; preds = %332, %332
  store double 0.000000e+00, ptr %22, align 8, !noalias !34
  %338 = call fastcc i32 @norm(ptr nonnull %22, ptr %85, ptr %65, ptr %65, ptr nonnull %95, i64 %94, ptr %100, i64 %99, i64 %273) #3
  switch i32 %338, label %2382 [
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

361:                                              ; preds = %2361, %359
  %362 = phi double [ %360, %359 ], [ %2362, %2361 ]
  %363 = phi double [ %297, %359 ], [ %366, %2361 ]
  br label %364

364:                                              ; preds = %2282, %361
  %365 = phi double [ %362, %361 ], [ %2283, %2282 ]
  %366 = phi double [ %363, %361 ], [ %392, %2282 ]
  %367 = load i64, ptr %161, align 8, !noalias !12
  %368 = icmp eq i64 %367, 0
  br i1 %368, label %369, label %370

369:                                              ; preds = %364
  store double %365, ptr %298, align 8, !noalias !12
  br label %2683

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
  br label %2683

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
  br i1 %397, label %398, label %2363

398:                                              ; preds = %381
  %399 = getelementptr i8, ptr %196, i64 8
  %400 = load i64, ptr %399, align 8, !noalias !12
  %401 = icmp eq i64 %400, 1
  br i1 %401, label %402, label %449

402:                                              ; preds = %398
  %403 = getelementptr i8, ptr %110, i64 32
  %404 = load i64, ptr %403, align 8, !noalias !12
  %405 = add nsw i64 %404, 1
  store i64 %405, ptr %403, align 8, !noalias !12
  %406 = load i64, ptr %116, align 8, !noalias !12
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
  switch i32 %415, label %2388 [
    i32 -2, label %2383
    i32 0, label %2383
  ], !prof !32

416:                                              ; preds = %402
  %417 = call i64 @llvm.smax.i64(i64 %406, i64 0)
  br label %418

418:                                              ; preds = %416, %2389
  %419 = phi i64 [ 0, %416 ], [ %2391, %2389 ]
  %420 = phi i64 [ %417, %416 ], [ %2390, %2389 ]
  %421 = icmp sgt i64 %420, 0
  br i1 %421, label %2389, label %422

422:                                              ; preds = %418, %432
  %423 = phi i64 [ %2402, %432 ], [ 0, %418 ]
  %424 = phi i64 [ %2401, %432 ], [ %417, %418 ]
  %425 = icmp sgt i64 %424, 0
  br i1 %425, label %2400, label %434

426:                                              ; preds = %2433
  %427 = sext i32 %2431 to i64
  br label %434

428:                                              ; preds = %2433, %2436
  %429 = phi i64 [ %2438, %2436 ], [ 0, %2433 ]
  %430 = phi i64 [ %2437, %2436 ], [ %417, %2433 ]
  %431 = icmp sgt i64 %430, 0
  br i1 %431, label %2436, label %432

432:                                              ; preds = %428
  %433 = load double, ptr %2406, align 8, !noalias !12
  store double %433, ptr %2416, align 8, !noalias !12
  br label %422

434:                                              ; preds = %422, %2383, %426
  %435 = phi i64 [ %2387, %2383 ], [ %427, %426 ], [ 0, %422 ]
  %436 = call i64 @llvm.smax.i64(i64 %206, i64 0)
  br label %437

437:                                              ; preds = %434, %442
  %438 = phi i64 [ 0, %434 ], [ %2458, %442 ]
  %439 = phi i64 [ %436, %434 ], [ %2457, %442 ]
  %440 = icmp sgt i64 %439, 0
  br i1 %440, label %2456, label %443

441:                                              ; preds = %2456
  store double 0.000000e+00, ptr %2462, align 8, !noalias !12
  br label %442

442:                                              ; preds = %441, %2456
  br label %437

443:                                              ; preds = %437
  %444 = icmp slt i64 %435, 0
  br i1 %444, label %445, label %446

445:                                              ; preds = %443
  br label %2683

446:                                              ; preds = %443
  store i64 0, ptr %399, align 8, !noalias !12
  %447 = getelementptr i8, ptr %196, i64 16
  store i64 1, ptr %447, align 8, !noalias !12
  %448 = getelementptr i8, ptr %196, i64 24
  store i64 0, ptr %448, align 8, !noalias !12
  br label %449

449:                                              ; preds = %446, %398
  %450 = getelementptr i8, ptr %196, i64 24
  %451 = load i64, ptr %450, align 8, !noalias !12
  %452 = icmp eq i64 %451, 0
  br i1 %452, label %456, label %453

453:                                              ; preds = %449
  %454 = load double, ptr %199, align 8, !noalias !12
  %455 = fcmp une double %391, %454
  br i1 %455, label %456, label %771

456:                                              ; preds = %453, %449
  %457 = getelementptr i8, ptr %110, i64 40
  %458 = load i64, ptr %457, align 8, !noalias !12
  %459 = add nsw i64 %458, 1
  store i64 %459, ptr %457, align 8, !noalias !12
  %460 = call i64 @llvm.smax.i64(i64 %225, i64 0)
  br label %461

461:                                              ; preds = %469, %456
  %462 = phi i64 [ 0, %456 ], [ %2468, %469 ]
  %463 = phi i64 [ %460, %456 ], [ %2467, %469 ]
  %464 = icmp sgt i64 %463, 0
  br i1 %464, label %2466, label %495

465:                                              ; preds = %2466, %2469
  %466 = phi i64 [ 0, %2466 ], [ %2471, %2469 ]
  %467 = phi i64 [ %460, %2466 ], [ %2470, %2469 ]
  %468 = icmp sgt i64 %467, 0
  br i1 %468, label %2469, label %469

469:                                              ; preds = %465
  %470 = icmp slt i64 %462, 0
  %471 = select i1 %470, i64 %211, i64 0
  %472 = add i64 %462, %471
  %473 = select i1 %470, i64 %213, i64 0
  %474 = mul i64 %472, %213
  %475 = getelementptr double, ptr %214, i64 %474
  %476 = getelementptr double, ptr %475, i64 %462
  %477 = getelementptr double, ptr %476, i64 %473
  %478 = load double, ptr %477, align 8, !noalias !12
  %479 = fdiv double 0x400D1A48D83E731D, %391
  %480 = fadd double %478, %479
  store double %480, ptr %477, align 8, !noalias !12
  %481 = select i1 %470, i64 %218, i64 0
  %482 = add i64 %462, %481
  %483 = select i1 %470, i64 %220, i64 0
  %484 = mul i64 %482, %220
  %485 = getelementptr { double, double }, ptr %221, i64 %484
  %486 = getelementptr { double, double }, ptr %485, i64 %462
  %487 = getelementptr { double, double }, ptr %486, i64 %483
  %488 = load double, ptr %487, align 8, !noalias !12
  %489 = getelementptr inbounds nuw i8, ptr %487, i64 8
  %490 = load double, ptr %489, align 8, !noalias !12
  %491 = fdiv double 0x400572DB93E0C672, %391
  %492 = fdiv double 0xC0086747F2C3FCB6, %391
  %493 = fadd double %488, %491
  %494 = fadd double %490, %492
  store double %493, ptr %487, align 8, !noalias !12
  store double %494, ptr %489, align 8, !noalias !12
  br label %461

495:                                              ; preds = %461
  %496 = call i64 @llvm.smax.i64(i64 %211, i64 0)
  br label %497

497:                                              ; preds = %521, %495
  %498 = phi i64 [ 0, %495 ], [ %534, %521 ]
  %499 = phi i64 [ %496, %495 ], [ %533, %521 ]
  %500 = icmp sgt i64 %499, 0
  br i1 %500, label %532, label %603

501:                                              ; preds = %547, %532
  %502 = phi i64 [ %534, %532 ], [ %549, %547 ]
  %503 = phi i64 [ %546, %532 ], [ %548, %547 ]
  %504 = phi double [ %544, %532 ], [ %560, %547 ]
  %505 = phi i64 [ %498, %532 ], [ %561, %547 ]
  %506 = icmp sgt i64 %503, 0
  br i1 %506, label %547, label %507

507:                                              ; preds = %501
  %508 = select i1 %535, i64 %225, i64 0
  %509 = getelementptr i64, ptr %226, i64 %498
  %510 = getelementptr i64, ptr %509, i64 %508
  store i64 %505, ptr %510, align 8, !noalias !42
  %511 = fcmp ueq double %504, 0.000000e+00
  br i1 %511, label %763, label %512

512:                                              ; preds = %507
  %513 = icmp eq i64 %505, %498
  br i1 %513, label %518, label %514

514:                                              ; preds = %512, %562
  %515 = phi i64 [ %564, %562 ], [ 0, %512 ]
  %516 = phi i64 [ %563, %562 ], [ %496, %512 ]
  %517 = icmp sgt i64 %516, 0
  br i1 %517, label %562, label %518

518:                                              ; preds = %514, %512
  %519 = load double, ptr %542, align 8, !noalias !42
  %520 = fdiv double 1.000000e+00, %519
  br label %521

521:                                              ; preds = %531, %518
  %522 = phi i64 [ %534, %518 ], [ %580, %531 ]
  %523 = phi i64 [ %546, %518 ], [ %579, %531 ]
  %524 = icmp sgt i64 %523, 0
  br i1 %524, label %578, label %497

525:                                              ; preds = %578
  %526 = fmul double %588, %520
  store double %526, ptr %587, align 8, !noalias !42
  br label %527

527:                                              ; preds = %590, %525
  %528 = phi i64 [ %534, %525 ], [ %592, %590 ]
  %529 = phi i64 [ %546, %525 ], [ %591, %590 ]
  %530 = icmp sgt i64 %529, 0
  br i1 %530, label %590, label %531

531:                                              ; preds = %578, %527
  br label %521

532:                                              ; preds = %497
  %533 = add nsw i64 %499, -1
  %534 = add i64 %498, 1
  %535 = icmp slt i64 %498, 0
  %536 = select i1 %535, i64 %211, i64 0
  %537 = add i64 %498, %536
  %538 = select i1 %535, i64 %213, i64 0
  %539 = mul i64 %537, %213
  %540 = getelementptr double, ptr %214, i64 %539
  %541 = getelementptr double, ptr %540, i64 %498
  %542 = getelementptr double, ptr %541, i64 %538
  %543 = load double, ptr %542, align 8, !noalias !42
  %544 = call double @llvm.fabs.f64(double %543)
  %545 = sub i64 %211, %534
  %546 = call i64 @llvm.smax.i64(i64 %545, i64 0)
  br label %501

547:                                              ; preds = %501
  %548 = add nsw i64 %503, -1
  %549 = add i64 %502, 1
  %550 = icmp slt i64 %502, 0
  %551 = select i1 %550, i64 %211, i64 0
  %552 = add i64 %502, %551
  %553 = mul i64 %552, %213
  %554 = getelementptr double, ptr %214, i64 %553
  %555 = getelementptr double, ptr %554, i64 %498
  %556 = getelementptr double, ptr %555, i64 %538
  %557 = load double, ptr %556, align 8, !noalias !42
  %558 = call double @llvm.fabs.f64(double %557)
  %559 = fcmp ogt double %558, %504
  %560 = select i1 %559, double %558, double %504
  %561 = select i1 %559, i64 %502, i64 %505
  br label %501

562:                                              ; preds = %514
  %563 = add nsw i64 %516, -1
  %564 = add i64 %515, 1
  %565 = icmp slt i64 %505, 0
  %566 = select i1 %565, i64 %211, i64 0
  %567 = add i64 %505, %566
  %568 = icmp slt i64 %515, 0
  %569 = select i1 %568, i64 %213, i64 0
  %570 = mul i64 %567, %213
  %571 = getelementptr double, ptr %214, i64 %570
  %572 = getelementptr double, ptr %571, i64 %515
  %573 = getelementptr double, ptr %572, i64 %569
  %574 = load double, ptr %573, align 8, !noalias !42
  %575 = getelementptr double, ptr %540, i64 %515
  %576 = getelementptr double, ptr %575, i64 %569
  %577 = load double, ptr %576, align 8, !noalias !42
  store double %574, ptr %576, align 8, !noalias !42
  store double %577, ptr %573, align 8, !noalias !42
  br label %514

578:                                              ; preds = %521
  %579 = add nsw i64 %523, -1
  %580 = add i64 %522, 1
  %581 = icmp slt i64 %522, 0
  %582 = select i1 %581, i64 %211, i64 0
  %583 = add i64 %522, %582
  %584 = mul i64 %583, %213
  %585 = getelementptr double, ptr %214, i64 %584
  %586 = getelementptr double, ptr %585, i64 %498
  %587 = getelementptr double, ptr %586, i64 %538
  %588 = load double, ptr %587, align 8, !noalias !42
  %589 = fcmp une double %588, 0.000000e+00
  br i1 %589, label %525, label %531

590:                                              ; preds = %527
  %591 = add nsw i64 %529, -1
  %592 = add i64 %528, 1
  %593 = icmp slt i64 %528, 0
  %594 = select i1 %593, i64 %213, i64 0
  %595 = getelementptr double, ptr %585, i64 %528
  %596 = getelementptr double, ptr %595, i64 %594
  %597 = load double, ptr %596, align 8, !noalias !42
  %598 = getelementptr double, ptr %540, i64 %528
  %599 = getelementptr double, ptr %598, i64 %594
  %600 = load double, ptr %599, align 8, !noalias !42
  %601 = fmul double %526, %600
  %602 = fsub double %597, %601
  store double %602, ptr %596, align 8, !noalias !42
  br label %527

603:                                              ; preds = %497
  %604 = call i64 @llvm.smax.i64(i64 %218, i64 0)
  br label %605

605:                                              ; preds = %653, %603
  %606 = phi i64 [ 0, %603 ], [ %671, %653 ]
  %607 = phi i64 [ %604, %603 ], [ %670, %653 ]
  %608 = icmp sgt i64 %607, 0
  br i1 %608, label %669, label %762

609:                                              ; preds = %686, %669
  %610 = phi i64 [ %671, %669 ], [ %698, %686 ]
  %611 = phi i64 [ %685, %669 ], [ %699, %686 ]
  %612 = phi double [ %683, %669 ], [ %701, %686 ]
  %613 = phi i64 [ %606, %669 ], [ %702, %686 ]
  %614 = icmp sgt i64 %611, 0
  br i1 %614, label %686, label %615

615:                                              ; preds = %609
  %616 = select i1 %672, i64 %230, i64 0
  %617 = getelementptr i64, ptr %231, i64 %606
  %618 = getelementptr i64, ptr %617, i64 %616
  store i64 %613, ptr %618, align 8, !noalias !45
  %619 = fcmp ueq double %612, 0.000000e+00
  br i1 %619, label %763, label %620

620:                                              ; preds = %615
  %621 = icmp eq i64 %613, %606
  br i1 %621, label %626, label %622

622:                                              ; preds = %620, %703
  %623 = phi i64 [ %705, %703 ], [ 0, %620 ]
  %624 = phi i64 [ %704, %703 ], [ %604, %620 ]
  %625 = icmp sgt i64 %624, 0
  br i1 %625, label %703, label %626

626:                                              ; preds = %622, %620
  %627 = load double, ptr %679, align 8, !noalias !45
  %628 = load double, ptr %681, align 8, !noalias !45
  %629 = call double @llvm.fabs.f64(double %627)
  %630 = call double @llvm.fabs.f64(double %628)
  %631 = fcmp ult double %629, %630
  br i1 %631, label %641, label %632

632:                                              ; preds = %626
  %633 = fdiv double %628, %627
  %634 = fmul double %628, %633
  %635 = fadd double %627, %634
  %636 = fmul double %633, 0.000000e+00
  %637 = fadd double %636, 1.000000e+00
  %638 = fdiv double %637, %635
  %639 = fsub double 0.000000e+00, %633
  %640 = fdiv double %639, %635
  br label %650

641:                                              ; preds = %626
  %642 = fdiv double %627, %628
  %643 = fmul double %627, %642
  %644 = fadd double %643, %628
  %645 = fadd double %642, 0.000000e+00
  %646 = fdiv double %645, %644
  %647 = fmul double %642, 0.000000e+00
  %648 = fadd double %647, -1.000000e+00
  %649 = fdiv double %648, %644
  br label %650

650:                                              ; preds = %641, %632
  %651 = phi double [ %640, %632 ], [ %649, %641 ]
  %652 = phi double [ %638, %632 ], [ %646, %641 ]
  br label %653

653:                                              ; preds = %668, %650
  %654 = phi i64 [ %671, %650 ], [ %725, %668 ]
  %655 = phi i64 [ %685, %650 ], [ %724, %668 ]
  %656 = icmp sgt i64 %655, 0
  br i1 %656, label %723, label %605

657:                                              ; preds = %723
  %658 = fmul double %733, %651
  %659 = fmul double %735, %652
  %660 = fadd double %658, %659
  %661 = fmul double %733, %652
  %662 = fmul double %735, %651
  %663 = fsub double %661, %662
  store double %663, ptr %732, align 8, !noalias !45
  store double %660, ptr %734, align 8, !noalias !45
  br label %664

664:                                              ; preds = %739, %657
  %665 = phi i64 [ %671, %657 ], [ %758, %739 ]
  %666 = phi i64 [ %685, %657 ], [ %759, %739 ]
  %667 = icmp sgt i64 %666, 0
  br i1 %667, label %739, label %668

668:                                              ; preds = %723, %664
  br label %653

669:                                              ; preds = %605
  %670 = add nsw i64 %607, -1
  %671 = add i64 %606, 1
  %672 = icmp slt i64 %606, 0
  %673 = select i1 %672, i64 %218, i64 0
  %674 = add i64 %606, %673
  %675 = select i1 %672, i64 %220, i64 0
  %676 = mul i64 %674, %220
  %677 = getelementptr { double, double }, ptr %221, i64 %676
  %678 = getelementptr { double, double }, ptr %677, i64 %606
  %679 = getelementptr { double, double }, ptr %678, i64 %675
  %680 = load double, ptr %679, align 8, !noalias !45
  %681 = getelementptr inbounds nuw i8, ptr %679, i64 8
  %682 = load double, ptr %681, align 8, !noalias !45
  %683 = call double @hypot(double %680, double %682) #3, !noalias !49
  %684 = sub i64 %218, %671
  %685 = call i64 @llvm.smax.i64(i64 %684, i64 0)
  br label %609

686:                                              ; preds = %609
  %687 = icmp slt i64 %610, 0
  %688 = select i1 %687, i64 %218, i64 0
  %689 = add i64 %610, %688
  %690 = mul i64 %689, %220
  %691 = getelementptr { double, double }, ptr %221, i64 %690
  %692 = getelementptr { double, double }, ptr %691, i64 %606
  %693 = getelementptr { double, double }, ptr %692, i64 %675
  %694 = load double, ptr %693, align 8, !noalias !45
  %695 = getelementptr inbounds nuw i8, ptr %693, i64 8
  %696 = load double, ptr %695, align 8, !noalias !45
  %697 = call double @hypot(double %694, double %696) #3, !noalias !55
  %698 = add i64 %610, 1
  %699 = add nsw i64 %611, -1
  %700 = fcmp ogt double %697, %612
  %701 = select i1 %700, double %697, double %612
  %702 = select i1 %700, i64 %610, i64 %613
  br label %609

703:                                              ; preds = %622
  %704 = add nsw i64 %624, -1
  %705 = add i64 %623, 1
  %706 = icmp slt i64 %613, 0
  %707 = select i1 %706, i64 %218, i64 0
  %708 = add i64 %613, %707
  %709 = icmp slt i64 %623, 0
  %710 = select i1 %709, i64 %220, i64 0
  %711 = mul i64 %708, %220
  %712 = getelementptr { double, double }, ptr %221, i64 %711
  %713 = getelementptr { double, double }, ptr %712, i64 %623
  %714 = getelementptr { double, double }, ptr %713, i64 %710
  %715 = load double, ptr %714, align 8, !noalias !45
  %716 = getelementptr inbounds nuw i8, ptr %714, i64 8
  %717 = load double, ptr %716, align 8, !noalias !45
  %718 = getelementptr { double, double }, ptr %677, i64 %623
  %719 = getelementptr { double, double }, ptr %718, i64 %710
  %720 = load double, ptr %719, align 8, !noalias !45
  %721 = getelementptr inbounds nuw i8, ptr %719, i64 8
  %722 = load double, ptr %721, align 8, !noalias !45
  store double %715, ptr %719, align 8, !noalias !45
  store double %717, ptr %721, align 8, !noalias !45
  store double %720, ptr %714, align 8, !noalias !45
  store double %722, ptr %716, align 8, !noalias !45
  br label %622

723:                                              ; preds = %653
  %724 = add nsw i64 %655, -1
  %725 = add i64 %654, 1
  %726 = icmp slt i64 %654, 0
  %727 = select i1 %726, i64 %218, i64 0
  %728 = add i64 %654, %727
  %729 = mul i64 %728, %220
  %730 = getelementptr { double, double }, ptr %221, i64 %729
  %731 = getelementptr { double, double }, ptr %730, i64 %606
  %732 = getelementptr { double, double }, ptr %731, i64 %675
  %733 = load double, ptr %732, align 8, !noalias !45
  %734 = getelementptr inbounds nuw i8, ptr %732, i64 8
  %735 = load double, ptr %734, align 8, !noalias !45
  %736 = fcmp une double %733, 0.000000e+00
  %737 = fcmp une double %735, 0.000000e+00
  %738 = or i1 %736, %737
  br i1 %738, label %657, label %668

739:                                              ; preds = %664
  %740 = icmp slt i64 %665, 0
  %741 = select i1 %740, i64 %220, i64 0
  %742 = getelementptr { double, double }, ptr %730, i64 %665
  %743 = getelementptr { double, double }, ptr %742, i64 %741
  %744 = load double, ptr %743, align 8, !noalias !45
  %745 = getelementptr inbounds nuw i8, ptr %743, i64 8
  %746 = load double, ptr %745, align 8, !noalias !45
  %747 = getelementptr { double, double }, ptr %677, i64 %665
  %748 = getelementptr { double, double }, ptr %747, i64 %741
  %749 = load double, ptr %748, align 8, !noalias !45
  %750 = getelementptr inbounds nuw i8, ptr %748, i64 8
  %751 = load double, ptr %750, align 8, !noalias !45
  %752 = fmul double %663, %751
  %753 = fmul double %660, %749
  %754 = fadd double %752, %753
  %755 = fmul double %663, %749
  %756 = fmul double %660, %751
  %757 = fsub double %755, %756
  %758 = add i64 %665, 1
  %759 = add nsw i64 %666, -1
  %760 = fsub double %744, %757
  %761 = fsub double %746, %754
  store double %760, ptr %743, align 8, !noalias !45
  store double %761, ptr %745, align 8, !noalias !45
  br label %664

762:                                              ; preds = %605
  store i64 1, ptr %450, align 8, !noalias !12
  store double %391, ptr %199, align 8, !noalias !12
  br label %771

763:                                              ; preds = %507, %615
  %764 = load i64, ptr %374, align 8, !noalias !12
  %765 = add nsw i64 %764, 1
  %766 = fmul double %391, 5.000000e-01
  %767 = getelementptr i8, ptr %110, i64 72
  store i64 4, ptr %767, align 8, !noalias !12
  store i64 %765, ptr %374, align 8, !noalias !12
  %768 = getelementptr i8, ptr %196, i64 16
  %769 = load i64, ptr %768, align 8, !noalias !12
  %770 = sub nsw i64 1, %769
  store i64 %770, ptr %399, align 8, !noalias !12
  store i64 0, ptr %450, align 8, !noalias !12
  br label %2361

771:                                              ; preds = %762, %453
  %772 = getelementptr i8, ptr %199, i64 8
  %773 = load double, ptr %772, align 8, !noalias !12
  br label %774

774:                                              ; preds = %789, %771
  %775 = phi i64 [ 0, %771 ], [ %2501, %789 ]
  %776 = phi i64 [ 3, %771 ], [ %2500, %789 ]
  %777 = icmp sgt i64 %776, 0
  br i1 %777, label %2499, label %843

778:                                              ; preds = %2499
  %779 = icmp slt i64 %775, 0
  %780 = add i64 %775, 3
  %781 = select i1 %779, i64 %780, i64 %775
  %782 = getelementptr double, ptr @0, i64 %781
  %783 = load double, ptr %782, align 8, !noalias !12
  %784 = fmul double %783, %391
  %785 = fdiv double %784, %773
  %786 = fadd double %785, 1.000000e+00
  br label %787

787:                                              ; preds = %2499, %778
  %788 = phi double [ %786, %778 ], [ 0.000000e+00, %2499 ]
  br label %789

789:                                              ; preds = %787, %833, %793
  %790 = phi i64 [ 0, %787 ], [ %2505, %793 ], [ %2505, %833 ]
  %791 = phi i64 [ %282, %787 ], [ %2504, %793 ], [ %2504, %833 ]
  %792 = icmp sgt i64 %791, 0
  br i1 %792, label %2503, label %774

793:                                              ; preds = %2503
  %794 = fsub double 1.000000e+00, %788
  %795 = icmp slt i64 %790, 0
  %796 = select i1 %795, i64 %256, i64 0
  %797 = shl i64 %256, 4
  %798 = getelementptr i8, ptr %257, i64 %797
  %799 = getelementptr double, ptr %798, i64 %790
  %800 = getelementptr double, ptr %799, i64 %796
  %801 = load double, ptr %800, align 8, !noalias !12
  %802 = mul i64 %256, 24
  %803 = getelementptr i8, ptr %257, i64 %802
  %804 = getelementptr double, ptr %803, i64 %790
  %805 = getelementptr double, ptr %804, i64 %796
  %806 = load double, ptr %805, align 8, !noalias !12
  %807 = fmul double %788, %806
  %808 = fadd double %801, %807
  %809 = fmul double %794, %808
  %810 = getelementptr double, ptr %257, i64 %790
  %811 = getelementptr double, ptr %810, i64 %796
  %812 = load double, ptr %811, align 8, !noalias !12
  %813 = getelementptr double, ptr %257, i64 %256
  %814 = getelementptr double, ptr %813, i64 %790
  %815 = getelementptr double, ptr %814, i64 %796
  %816 = load double, ptr %815, align 8, !noalias !12
  %817 = fadd double %816, %809
  %818 = fmul double %788, %817
  %819 = fadd double %812, %818
  %820 = select i1 %795, i64 %64, i64 0
  %821 = getelementptr double, ptr %65, i64 %790
  %822 = getelementptr double, ptr %821, i64 %820
  %823 = load double, ptr %822, align 8, !noalias !12
  %824 = fsub double %819, %823
  %825 = icmp slt i64 %775, 0
  %826 = select i1 %825, i64 %235, i64 0
  %827 = add i64 %775, %826
  %828 = select i1 %795, i64 %237, i64 0
  %829 = mul i64 %827, %237
  %830 = getelementptr double, ptr %238, i64 %829
  %831 = getelementptr double, ptr %830, i64 %790
  %832 = getelementptr double, ptr %831, i64 %828
  store double %824, ptr %832, align 8, !noalias !12
  br label %789

833:                                              ; preds = %2503
  %834 = icmp slt i64 %775, 0
  %835 = select i1 %834, i64 %235, i64 0
  %836 = add i64 %775, %835
  %837 = icmp slt i64 %790, 0
  %838 = select i1 %837, i64 %237, i64 0
  %839 = mul i64 %836, %237
  %840 = getelementptr double, ptr %238, i64 %839
  %841 = getelementptr double, ptr %840, i64 %790
  %842 = getelementptr double, ptr %841, i64 %838
  store double 0.000000e+00, ptr %842, align 8, !noalias !12
  br label %789

843:                                              ; preds = %774, %847
  %844 = phi i64 [ %2508, %847 ], [ 0, %774 ]
  %845 = phi i64 [ %2507, %847 ], [ 3, %774 ]
  %846 = icmp sgt i64 %845, 0
  br i1 %846, label %2506, label %851

847:                                              ; preds = %2506, %2509
  %848 = phi i64 [ 0, %2506 ], [ %2511, %2509 ]
  %849 = phi i64 [ %282, %2506 ], [ %2510, %2509 ]
  %850 = icmp sgt i64 %849, 0
  br i1 %850, label %2509, label %843

851:                                              ; preds = %843
  %852 = fmul double %296, %286
  store ptr null, ptr %12, align 8, !noalias !61
  %853 = load i64, ptr %116, align 8, !noalias !61
  %854 = getelementptr i8, ptr %196, i64 40
  %855 = load i64, ptr %854, align 8, !noalias !61
  %856 = icmp sgt i64 %855, 0
  %857 = select i1 %856, i64 10, i64 6
  br label %858

858:                                              ; preds = %1319, %851
  %859 = phi i64 [ 0, %851 ], [ %1329, %1319 ]
  %860 = phi i64 [ %857, %851 ], [ %1330, %1319 ]
  %861 = phi double [ -1.000000e+00, %851 ], [ %1174, %1319 ]
  %862 = phi double [ 0.000000e+00, %851 ], [ %1219, %1319 ]
  %863 = phi i64 [ 0, %851 ], [ %1238, %1319 ]
  %864 = icmp sgt i64 %860, 0
  br i1 %864, label %1325, label %1328

865:                                              ; preds = %1328
  %866 = icmp sgt i64 %1332, 5
  %867 = icmp eq i64 %863, 0
  %868 = and i1 %866, %867
  br i1 %868, label %1320, label %869

869:                                              ; preds = %1358, %865
  %870 = phi i64 [ %1335, %1358 ], [ 0, %865 ]
  %871 = phi i64 [ %1334, %1358 ], [ 3, %865 ]
  %872 = icmp sgt i64 %871, 0
  br i1 %872, label %1333, label %907

873:                                              ; preds = %1337, %1333
  %874 = phi i64 [ 0, %1333 ], [ %1339, %1337 ]
  %875 = phi i64 [ %1336, %1333 ], [ %1338, %1337 ]
  %876 = icmp sgt i64 %875, 0
  br i1 %876, label %1337, label %877

877:                                              ; preds = %873
  %878 = getelementptr i8, ptr %110, i64 24
  %879 = load i64, ptr %878, align 8, !noalias !61
  %880 = add nsw i64 %879, 1
  store i64 %880, ptr %878, align 8, !noalias !61
  %881 = icmp slt i64 %870, 0
  %882 = add i64 %870, 3
  %883 = select i1 %881, i64 %882, i64 %870
  %884 = getelementptr double, ptr @4, i64 %883
  %885 = load double, ptr %884, align 8, !noalias !61
  %886 = fmul double %391, %885
  %887 = fadd double %366, %886
  %888 = mul nsw i64 %870, %853
  %889 = shl i64 %888, 3
  %890 = add i64 %889, %247
  store ptr null, ptr %10, align 8, !noalias !65
  store ptr null, ptr %11, align 8, !noalias !65
  store double %887, ptr %33, align 8, !noalias !65
  %891 = icmp sgt i64 %45, 0
  br i1 %891, label %892, label %895

892:                                              ; preds = %877
  store ptr null, ptr %10, align 8, !noalias !65
  %893 = call fastcc i32 @_sample(ptr nonnull %10, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %887) #3
  switch i32 %893, label %894 [
    i32 -2, label %895
    i32 0, label %895
  ], !prof !32

894:                                              ; preds = %892
  br label %895

895:                                              ; preds = %892, %892, %877, %894
  %896 = phi i32 [ %893, %894 ], [ 0, %877 ], [ 0, %892 ], [ 0, %892 ]
  switch i32 %896, label %902 [
    i32 -2, label %897
    i32 0, label %897
  ], !prof !32

897:                                              ; preds = %895, %895
  %898 = load i64, ptr %30, align 8, !noalias !72
  %899 = inttoptr i64 %898 to ptr
  %900 = inttoptr i64 %890 to ptr
  %901 = call i32 %899(ptr nonnull %33, ptr %75, ptr %38, ptr %41, ptr %900) #3, !noalias !72
  br label %902

902:                                              ; preds = %895, %897
  %903 = phi i32 [ %901, %897 ], [ 0, %895 ]
  %904 = phi i32 [ 0, %897 ], [ %896, %895 ]
  switch i32 %904, label %1877 [
    i32 -2, label %1358
    i32 0, label %1358
  ], !prof !32

905:                                              ; preds = %1358
  %906 = sext i32 %903 to i64
  br label %1877

907:                                              ; preds = %869
  %908 = call i64 @llvm.smax.i64(i64 %853, i64 0)
  br label %909

909:                                              ; preds = %914, %907
  %910 = phi i64 [ 0, %907 ], [ %915, %914 ]
  %911 = phi i64 [ %908, %907 ], [ %916, %914 ]
  %912 = phi double [ 0.000000e+00, %907 ], [ %992, %914 ]
  %913 = icmp sgt i64 %911, 0
  br i1 %913, label %1360, label %993

914:                                              ; preds = %1360
  %915 = add i64 %910, 1
  %916 = add nsw i64 %911, -1
  %917 = fmul double %1365, 0x4010B70201A79C46
  %918 = fmul double %1369, 0x3FD4F8C15DA84E86
  %919 = fadd double %917, %918
  %920 = fmul double %1375, 0x3FE0BF7FF59D56EF
  %921 = fadd double %919, %920
  %922 = fdiv double 0x400D1A48D83E731D, %391
  %923 = select i1 %1361, i64 %244, i64 0
  %924 = getelementptr double, ptr %245, i64 %910
  %925 = getelementptr double, ptr %924, i64 %923
  %926 = load double, ptr %925, align 8, !noalias !61
  %927 = fmul double %922, %926
  %928 = fsub double %921, %927
  %929 = select i1 %1361, i64 %261, i64 0
  %930 = getelementptr double, ptr %262, i64 %910
  %931 = getelementptr double, ptr %930, i64 %929
  store double %928, ptr %931, align 8, !noalias !61
  %932 = load double, ptr %1364, align 8, !noalias !61
  %933 = fmul double %932, 0xC010B70201A79C46
  %934 = load double, ptr %1368, align 8, !noalias !61
  %935 = fmul double %934, 0xBFD4F8C15DA84E86
  %936 = fadd double %933, %935
  %937 = load double, ptr %1374, align 8, !noalias !61
  %938 = fmul double %937, 0x3FDE810014C55221
  %939 = fadd double %936, %938
  %940 = fmul double %932, 0x3FE017885A24A7F2
  %941 = fmul double %934, 0xC004934E6FCAA598
  %942 = fadd double %940, %941
  %943 = fmul double %937, 0x3FE312C0CF7BDFD1
  %944 = fadd double %942, %943
  %945 = fdiv double 0x400572DB93E0C672, %391
  %946 = fdiv double 0xC0086747F2C3FCB6, %391
  %947 = getelementptr double, ptr %245, i64 %244
  %948 = getelementptr double, ptr %947, i64 %910
  %949 = getelementptr double, ptr %948, i64 %923
  %950 = load double, ptr %949, align 8, !noalias !61
  %951 = shl i64 %244, 4
  %952 = getelementptr i8, ptr %245, i64 %951
  %953 = getelementptr double, ptr %952, i64 %910
  %954 = getelementptr double, ptr %953, i64 %923
  %955 = load double, ptr %954, align 8, !noalias !61
  %956 = fmul double %945, %955
  %957 = fmul double %946, %950
  %958 = fadd double %956, %957
  %959 = fmul double %945, %950
  %960 = fmul double %946, %955
  %961 = fsub double %959, %960
  %962 = fsub double %939, %961
  %963 = fsub double %944, %958
  %964 = select i1 %1361, i64 %266, i64 0
  %965 = getelementptr { double, double }, ptr %267, i64 %910
  %966 = getelementptr { double, double }, ptr %965, i64 %964
  store double %962, ptr %966, align 8, !noalias !61
  %967 = getelementptr inbounds nuw i8, ptr %966, i64 8
  store double %963, ptr %967, align 8, !noalias !61
  %968 = load double, ptr %931, align 8, !noalias !61
  %969 = call double @llvm.fabs.f64(double %968)
  %970 = call double @llvm.fabs.f64(double %962)
  %971 = fadd double %969, %970
  %972 = call double @llvm.fabs.f64(double %963)
  %973 = fadd double %971, %972
  %974 = fmul double %391, %973
  %975 = select i1 %1361, i64 %64, i64 0
  %976 = getelementptr double, ptr %65, i64 %910
  %977 = getelementptr double, ptr %976, i64 %975
  %978 = load double, ptr %977, align 8, !noalias !61
  %979 = select i1 %1361, i64 %99, i64 0
  %980 = getelementptr double, ptr %100, i64 %910
  %981 = getelementptr double, ptr %980, i64 %979
  %982 = load double, ptr %981, align 8, !noalias !73
  %983 = select i1 %1361, i64 %94, i64 0
  %984 = getelementptr double, ptr %95, i64 %910
  %985 = getelementptr double, ptr %984, i64 %983
  %986 = load double, ptr %985, align 8, !noalias !73
  %987 = call double @llvm.fabs.f64(double %978)
  %988 = fmul double %986, %987
  %989 = fadd double %982, %988
  %990 = fdiv double %974, %989
  %991 = fmul double %990, %990
  %992 = fadd double %912, %991
  br label %909

993:                                              ; preds = %909
  store ptr null, ptr %12, align 8, !noalias !61
  %994 = call fastcc i32 @solve(ptr nonnull %12, ptr %214, i64 %211, i64 %213, ptr %226, i64 %225, ptr %262, i64 %261) #3, !noalias !61
  switch i32 %994, label %1877 [
    i32 -2, label %1379
    i32 0, label %1379
  ], !prof !32

995:                                              ; preds = %1549
  %996 = call i64 @llvm.smax.i64(i64 %211, i64 0)
  br label %997

997:                                              ; preds = %1010, %995
  %998 = phi i64 [ 0, %995 ], [ %1056, %1010 ]
  %999 = phi i64 [ %996, %995 ], [ %1055, %1010 ]
  %1000 = icmp sgt i64 %999, 0
  br i1 %1000, label %1054, label %1011

1001:                                             ; preds = %1054
  %1002 = mul nsw i64 %998, %855
  %1003 = add nsw i64 %211, %1002
  %1004 = mul nsw i64 %1061, %855
  %1005 = add nsw i64 %211, %1004
  br label %1006

1006:                                             ; preds = %1063, %1001
  %1007 = phi i64 [ 0, %1001 ], [ %1065, %1063 ]
  %1008 = phi i64 [ %855, %1001 ], [ %1064, %1063 ]
  %1009 = icmp sgt i64 %1008, 0
  br i1 %1009, label %1063, label %1010

1010:                                             ; preds = %1054, %1006
  br label %997

1011:                                             ; preds = %997, %1015
  %1012 = phi i64 [ %1080, %1015 ], [ 0, %997 ]
  %1013 = phi i64 [ %1079, %1015 ], [ %996, %997 ]
  %1014 = icmp sgt i64 %1013, 0
  br i1 %1014, label %1078, label %1023

1015:                                             ; preds = %1078, %1019
  %1016 = phi i64 [ 0, %1078 ], [ %1084, %1019 ]
  %1017 = phi i64 [ %1081, %1078 ], [ %1083, %1019 ]
  %1018 = icmp sgt i64 %1017, 0
  br i1 %1018, label %1082, label %1011

1019:                                             ; preds = %1099, %1082
  %1020 = phi i64 [ 0, %1082 ], [ %1101, %1099 ]
  %1021 = phi i64 [ %855, %1082 ], [ %1100, %1099 ]
  %1022 = icmp sgt i64 %1021, 0
  br i1 %1022, label %1099, label %1015

1023:                                             ; preds = %1011
  %1024 = icmp ugt i64 %211, -9223372036854775808
  %1025 = select i1 %1024, i64 0, i64 %211
  br label %1026

1026:                                             ; preds = %1050, %1023
  %1027 = phi i64 [ %211, %1023 ], [ %1029, %1050 ]
  %1028 = phi i64 [ %1025, %1023 ], [ %1117, %1050 ]
  %1029 = add i64 %1027, -1
  %1030 = icmp sgt i64 %1028, 0
  br i1 %1030, label %1116, label %1550

1031:                                             ; preds = %1116, %1035
  %1032 = phi i64 [ %1027, %1116 ], [ %1124, %1035 ]
  %1033 = phi i64 [ %1121, %1116 ], [ %1123, %1035 ]
  %1034 = icmp sgt i64 %1033, 0
  br i1 %1034, label %1122, label %1039

1035:                                             ; preds = %1137, %1122
  %1036 = phi i64 [ 0, %1122 ], [ %1139, %1137 ]
  %1037 = phi i64 [ %855, %1122 ], [ %1138, %1137 ]
  %1038 = icmp sgt i64 %1037, 0
  br i1 %1038, label %1137, label %1031

1039:                                             ; preds = %1031
  %1040 = icmp slt i64 %1029, 0
  %1041 = select i1 %1040, i64 %211, i64 0
  %1042 = add i64 %1029, %1041
  %1043 = select i1 %1040, i64 %213, i64 0
  %1044 = mul i64 %1042, %213
  %1045 = getelementptr double, ptr %214, i64 %1044
  %1046 = getelementptr double, ptr %1045, i64 %1029
  %1047 = getelementptr double, ptr %1046, i64 %1043
  %1048 = load double, ptr %1047, align 8, !noalias !76
  %1049 = fdiv double 1.000000e+00, %1048
  br label %1050

1050:                                             ; preds = %1154, %1039
  %1051 = phi i64 [ 0, %1039 ], [ %1156, %1154 ]
  %1052 = phi i64 [ %855, %1039 ], [ %1155, %1154 ]
  %1053 = icmp sgt i64 %1052, 0
  br i1 %1053, label %1154, label %1026

1054:                                             ; preds = %997
  %1055 = add nsw i64 %999, -1
  %1056 = add i64 %998, 1
  %1057 = icmp slt i64 %998, 0
  %1058 = select i1 %1057, i64 %225, i64 0
  %1059 = getelementptr i64, ptr %226, i64 %998
  %1060 = getelementptr i64, ptr %1059, i64 %1058
  %1061 = load i64, ptr %1060, align 8, !noalias !76
  %1062 = icmp eq i64 %1061, %998
  br i1 %1062, label %1010, label %1001

1063:                                             ; preds = %1006
  %1064 = add nsw i64 %1008, -1
  %1065 = add i64 %1007, 1
  %1066 = add nsw i64 %1005, %1007
  %1067 = icmp slt i64 %1066, 0
  %1068 = select i1 %1067, i64 %261, i64 0
  %1069 = getelementptr double, ptr %262, i64 %1066
  %1070 = getelementptr double, ptr %1069, i64 %1068
  %1071 = load double, ptr %1070, align 8, !noalias !76
  %1072 = add nsw i64 %1003, %1007
  %1073 = icmp slt i64 %1072, 0
  %1074 = select i1 %1073, i64 %261, i64 0
  %1075 = getelementptr double, ptr %262, i64 %1072
  %1076 = getelementptr double, ptr %1075, i64 %1074
  %1077 = load double, ptr %1076, align 8, !noalias !76
  store double %1071, ptr %1076, align 8, !noalias !76
  store double %1077, ptr %1070, align 8, !noalias !76
  br label %1006

1078:                                             ; preds = %1011
  %1079 = add nsw i64 %1013, -1
  %1080 = add i64 %1012, 1
  %1081 = call i64 @llvm.smax.i64(i64 %1012, i64 0)
  br label %1015

1082:                                             ; preds = %1015
  %1083 = add nsw i64 %1017, -1
  %1084 = add i64 %1016, 1
  %1085 = icmp slt i64 %1012, 0
  %1086 = select i1 %1085, i64 %211, i64 0
  %1087 = add i64 %1012, %1086
  %1088 = icmp slt i64 %1016, 0
  %1089 = select i1 %1088, i64 %213, i64 0
  %1090 = mul i64 %1087, %213
  %1091 = getelementptr double, ptr %214, i64 %1090
  %1092 = getelementptr double, ptr %1091, i64 %1016
  %1093 = getelementptr double, ptr %1092, i64 %1089
  %1094 = load double, ptr %1093, align 8, !noalias !76
  %1095 = mul nsw i64 %1012, %855
  %1096 = add nsw i64 %211, %1095
  %1097 = mul nsw i64 %1016, %855
  %1098 = add nsw i64 %211, %1097
  br label %1019

1099:                                             ; preds = %1019
  %1100 = add nsw i64 %1021, -1
  %1101 = add i64 %1020, 1
  %1102 = add nsw i64 %1096, %1020
  %1103 = icmp slt i64 %1102, 0
  %1104 = select i1 %1103, i64 %261, i64 0
  %1105 = getelementptr double, ptr %262, i64 %1102
  %1106 = getelementptr double, ptr %1105, i64 %1104
  %1107 = load double, ptr %1106, align 8, !noalias !76
  %1108 = add nsw i64 %1098, %1020
  %1109 = icmp slt i64 %1108, 0
  %1110 = select i1 %1109, i64 %261, i64 0
  %1111 = getelementptr double, ptr %262, i64 %1108
  %1112 = getelementptr double, ptr %1111, i64 %1110
  %1113 = load double, ptr %1112, align 8, !noalias !76
  %1114 = fmul double %1094, %1113
  %1115 = fsub double %1107, %1114
  store double %1115, ptr %1106, align 8, !noalias !76
  br label %1019

1116:                                             ; preds = %1026
  %1117 = add nsw i64 %1028, -1
  %1118 = mul nsw i64 %1029, %855
  %1119 = add nsw i64 %211, %1118
  %1120 = sub i64 %211, %1027
  %1121 = call i64 @llvm.smax.i64(i64 %1120, i64 0)
  br label %1031

1122:                                             ; preds = %1031
  %1123 = add nsw i64 %1033, -1
  %1124 = add i64 %1032, 1
  %1125 = icmp slt i64 %1029, 0
  %1126 = select i1 %1125, i64 %211, i64 0
  %1127 = add i64 %1029, %1126
  %1128 = icmp slt i64 %1032, 0
  %1129 = select i1 %1128, i64 %213, i64 0
  %1130 = mul i64 %1127, %213
  %1131 = getelementptr double, ptr %214, i64 %1130
  %1132 = getelementptr double, ptr %1131, i64 %1032
  %1133 = getelementptr double, ptr %1132, i64 %1129
  %1134 = load double, ptr %1133, align 8, !noalias !76
  %1135 = mul nsw i64 %1032, %855
  %1136 = add nsw i64 %211, %1135
  br label %1035

1137:                                             ; preds = %1035
  %1138 = add nsw i64 %1037, -1
  %1139 = add i64 %1036, 1
  %1140 = add nsw i64 %1119, %1036
  %1141 = icmp slt i64 %1140, 0
  %1142 = select i1 %1141, i64 %261, i64 0
  %1143 = getelementptr double, ptr %262, i64 %1140
  %1144 = getelementptr double, ptr %1143, i64 %1142
  %1145 = load double, ptr %1144, align 8, !noalias !76
  %1146 = add nsw i64 %1136, %1036
  %1147 = icmp slt i64 %1146, 0
  %1148 = select i1 %1147, i64 %261, i64 0
  %1149 = getelementptr double, ptr %262, i64 %1146
  %1150 = getelementptr double, ptr %1149, i64 %1148
  %1151 = load double, ptr %1150, align 8, !noalias !76
  %1152 = fmul double %1134, %1151
  %1153 = fsub double %1145, %1152
  store double %1153, ptr %1144, align 8, !noalias !76
  br label %1035

1154:                                             ; preds = %1050
  %1155 = add nsw i64 %1052, -1
  %1156 = add i64 %1051, 1
  %1157 = add nsw i64 %1119, %1051
  %1158 = icmp slt i64 %1157, 0
  %1159 = select i1 %1158, i64 %261, i64 0
  %1160 = getelementptr double, ptr %262, i64 %1157
  %1161 = getelementptr double, ptr %1160, i64 %1159
  %1162 = load double, ptr %1161, align 8, !noalias !76
  %1163 = fmul double %1162, %1049
  store double %1163, ptr %1161, align 8, !noalias !76
  br label %1050

1164:                                             ; preds = %1576, %1549
  br label %1165

1165:                                             ; preds = %1774, %1164
  %1166 = phi i64 [ 0, %1164 ], [ %1776, %1774 ]
  %1167 = phi i64 [ %908, %1164 ], [ %1775, %1774 ]
  %1168 = phi double [ 0.000000e+00, %1164 ], [ %1811, %1774 ]
  %1169 = icmp sgt i64 %1167, 0
  br i1 %1169, label %1774, label %1170

1170:                                             ; preds = %1165
  %1171 = mul nsw i64 %853, 3
  %1172 = sitofp i64 %1171 to double
  %1173 = fdiv double %1168, %1172
  %1174 = call double @sqrt(double %1173), !noalias !61
  %1175 = fcmp oeq double %1174, 0.000000e+00
  %1176 = fcmp ogt double %912, 0.000000e+00
  %1177 = select i1 %1175, i1 %1176, i1 false
  br i1 %1177, label %1877, label %1178

1178:                                             ; preds = %1170
  %1179 = fcmp ogt double %861, 0.000000e+00
  %1180 = and i1 %1179, %867
  br i1 %1180, label %1181, label %1218

1181:                                             ; preds = %1178
  %1182 = fdiv double %1174, %861
  %1183 = sub nsw i64 5, %1332
  %1184 = add nsw i64 %1332, -5
  %1185 = select i1 %866, i64 %1184, i64 %1183
  %1186 = icmp samesign ugt i64 %1185, 65536
  br i1 %1186, label %1187, label %1190

1187:                                             ; preds = %1181
  %1188 = sitofp i64 %1183 to double
  %1189 = call double @llvm.pow.f64(double %1182, double %1188)
  br label %1209

1190:                                             ; preds = %1181
  %1191 = icmp eq i64 %1185, 0
  br i1 %1191, label %1203, label %1192

1192:                                             ; preds = %1192, %1190
  %1193 = phi double [ %1199, %1192 ], [ 1.000000e+00, %1190 ]
  %1194 = phi double [ %1201, %1192 ], [ %1182, %1190 ]
  %1195 = phi i64 [ %1200, %1192 ], [ %1185, %1190 ]
  %1196 = and i64 %1195, 1
  %1197 = icmp eq i64 %1196, 0
  %1198 = fmul double %1193, %1194
  %1199 = select i1 %1197, double %1193, double %1198
  %1200 = lshr i64 %1195, 1
  %1201 = fmul double %1194, %1194
  %1202 = icmp eq i64 %1200, 0
  br i1 %1202, label %1203, label %1192

1203:                                             ; preds = %1192, %1190
  %1204 = phi double [ %1199, %1192 ], [ 1.000000e+00, %1190 ]
  br i1 %866, label %1205, label %1209

1205:                                             ; preds = %1203
  %1206 = fcmp oeq double %1204, 0.000000e+00
  br i1 %1206, label %1209, label %1207, !prof !4

1207:                                             ; preds = %1205
  %1208 = fdiv double 1.000000e+00, %1204
  br label %1209

1209:                                             ; preds = %1205, %1203, %1187, %1207
  %1210 = phi double [ 0.000000e+00, %1205 ], [ %1189, %1187 ], [ %1204, %1203 ], [ %1208, %1207 ]
  %1211 = phi i1 [ false, %1205 ], [ true, %1187 ], [ true, %1203 ], [ true, %1207 ]
  %1212 = phi i32 [ 1, %1205 ], [ 0, %1187 ], [ 0, %1203 ], [ 0, %1207 ]
  br i1 %1211, label %1812, label %1877, !prof !79

1213:                                             ; preds = %1812
  %1214 = fsub double 1.000000e+00, %1182
  %1215 = fdiv double %1210, %1214
  %1216 = fmul double %1215, %1174
  %1217 = fcmp ogt double %1216, %296
  br i1 %1217, label %1877, label %1218

1218:                                             ; preds = %1213, %1178
  %1219 = phi double [ %1182, %1213 ], [ %862, %1178 ]
  br label %1220

1220:                                             ; preds = %1224, %1218
  %1221 = phi i64 [ 0, %1218 ], [ %1816, %1224 ]
  %1222 = phi i64 [ %908, %1218 ], [ %1815, %1224 ]
  %1223 = icmp sgt i64 %1222, 0
  br i1 %1223, label %1814, label %1228

1224:                                             ; preds = %1844, %1814
  %1225 = phi i64 [ 0, %1814 ], [ %1846, %1844 ]
  %1226 = phi i64 [ 3, %1814 ], [ %1845, %1844 ]
  %1227 = icmp sgt i64 %1226, 0
  br i1 %1227, label %1844, label %1220

1228:                                             ; preds = %1220
  br i1 %867, label %1229, label %1237

1229:                                             ; preds = %1228
  br i1 %1175, label %1236, label %1230

1230:                                             ; preds = %1229
  br i1 %1179, label %1231, label %1237

1231:                                             ; preds = %1230
  %1232 = fsub double 1.000000e+00, %1219
  %1233 = fdiv double %1219, %1232
  %1234 = fmul double %1233, %1174
  %1235 = fcmp olt double %1234, %296
  br i1 %1235, label %1236, label %1237

1236:                                             ; preds = %1231, %1229
  br label %1237

1237:                                             ; preds = %1236, %1231, %1230, %1228
  %1238 = phi i64 [ %1331, %1236 ], [ 0, %1231 ], [ 0, %1230 ], [ %863, %1228 ]
  %1239 = icmp sgt i64 %1238, 0
  br i1 %1239, label %1240, label %1319

1240:                                             ; preds = %1237
  %1241 = icmp eq i64 %855, 0
  br i1 %1241, label %1320, label %1242

1242:                                             ; preds = %1240
  %1243 = load i64, ptr %854, align 8, !noalias !80
  %1244 = call i64 @llvm.smax.i64(i64 %1243, i64 0)
  br label %1245

1245:                                             ; preds = %1263, %1242
  %1246 = phi i64 [ 0, %1242 ], [ %1267, %1263 ]
  %1247 = phi i64 [ %1244, %1242 ], [ %1266, %1263 ]
  %1248 = phi double [ 0.000000e+00, %1242 ], [ %1264, %1263 ]
  %1249 = icmp sgt i64 %1247, 0
  br i1 %1249, label %1265, label %1874

1250:                                             ; preds = %1269, %1265
  %1251 = phi i64 [ 0, %1265 ], [ %1271, %1269 ]
  %1252 = phi i64 [ %1268, %1265 ], [ %1270, %1269 ]
  %1253 = phi double [ 0.000000e+00, %1265 ], [ %1293, %1269 ]
  %1254 = phi double [ 0.000000e+00, %1265 ], [ %1318, %1269 ]
  %1255 = icmp sgt i64 %1252, 0
  br i1 %1255, label %1269, label %1256

1256:                                             ; preds = %1250
  %1257 = fmul double %1248, %1254
  %1258 = fcmp ogt double %1253, %1257
  br i1 %1258, label %1259, label %1263

1259:                                             ; preds = %1256
  %1260 = fcmp ogt double %1254, 0.000000e+00
  %1261 = fdiv double %1253, %1254
  %1262 = select i1 %1260, double %1261, double 1.000000e+00
  br label %1263

1263:                                             ; preds = %1259, %1256
  %1264 = phi double [ %1262, %1259 ], [ %1248, %1256 ]
  br label %1245

1265:                                             ; preds = %1245
  %1266 = add nsw i64 %1247, -1
  %1267 = add i64 %1246, 1
  %1268 = call i64 @llvm.smax.i64(i64 %225, i64 0)
  br label %1250

1269:                                             ; preds = %1250
  %1270 = add nsw i64 %1252, -1
  %1271 = add i64 %1251, 1
  %1272 = mul nsw i64 %1251, %1243
  %1273 = add nsw i64 %225, %1272
  %1274 = add nsw i64 %1273, %1246
  %1275 = icmp slt i64 %1274, 0
  %1276 = select i1 %1275, i64 %261, i64 0
  %1277 = getelementptr double, ptr %262, i64 %1274
  %1278 = getelementptr double, ptr %1277, i64 %1276
  %1279 = load double, ptr %1278, align 8, !noalias !80
  %1280 = fmul double %1279, %1279
  %1281 = select i1 %1275, i64 %266, i64 0
  %1282 = getelementptr { double, double }, ptr %267, i64 %1274
  %1283 = getelementptr { double, double }, ptr %1282, i64 %1281
  %1284 = load double, ptr %1283, align 8, !noalias !80
  %1285 = getelementptr inbounds nuw i8, ptr %1283, i64 8
  %1286 = load double, ptr %1285, align 8, !noalias !80
  %1287 = call double @hypot(double %1284, double %1286) #3, !noalias !84
  %1288 = load double, ptr %1283, align 8, !noalias !80
  %1289 = load double, ptr %1285, align 8, !noalias !80
  %1290 = call double @hypot(double %1288, double %1289) #3, !noalias !90
  %1291 = fmul double %1287, %1290
  %1292 = fadd double %1280, %1291
  %1293 = fadd double %1253, %1292
  %1294 = select i1 %1275, i64 %64, i64 0
  %1295 = getelementptr double, ptr %65, i64 %1274
  %1296 = getelementptr double, ptr %1295, i64 %1294
  %1297 = load double, ptr %1296, align 8, !noalias !80
  %1298 = fmul double %1297, %1297
  %1299 = fadd double %1254, %1298
  %1300 = select i1 %1275, i64 %244, i64 0
  %1301 = getelementptr double, ptr %245, i64 %1274
  %1302 = getelementptr double, ptr %1301, i64 %1300
  %1303 = load double, ptr %1302, align 8, !noalias !80
  %1304 = fmul double %1303, %1303
  %1305 = getelementptr double, ptr %245, i64 %244
  %1306 = getelementptr double, ptr %1305, i64 %1274
  %1307 = getelementptr double, ptr %1306, i64 %1300
  %1308 = load double, ptr %1307, align 8, !noalias !80
  %1309 = fmul double %1308, %1308
  %1310 = fadd double %1304, %1309
  %1311 = shl i64 %244, 4
  %1312 = getelementptr i8, ptr %245, i64 %1311
  %1313 = getelementptr double, ptr %1312, i64 %1274
  %1314 = getelementptr double, ptr %1313, i64 %1300
  %1315 = load double, ptr %1314, align 8, !noalias !80
  %1316 = fmul double %1315, %1315
  %1317 = fadd double %1310, %1316
  %1318 = fadd double %1299, %1317
  br label %1250

1319:                                             ; preds = %1874, %1237
  br label %858

1320:                                             ; preds = %1874, %1328, %1240, %865
  %1321 = phi double [ %862, %1328 ], [ %862, %865 ], [ %1219, %1874 ], [ %1219, %1240 ]
  %1322 = phi i64 [ %863, %1328 ], [ 0, %865 ], [ %1238, %1874 ], [ %1238, %1240 ]
  %1323 = icmp slt i64 %1322, 1
  %1324 = select i1 %1323, i64 6, i64 %1322
  br label %1877

1325:                                             ; preds = %858
  %1326 = add nsw i64 %860, -1
  %1327 = add i64 %859, 1
  br label %1328

1328:                                             ; preds = %1325, %858
  %1329 = phi i64 [ %1327, %1325 ], [ %859, %858 ]
  %1330 = phi i64 [ %1326, %1325 ], [ %860, %858 ]
  %1331 = phi i64 [ %1327, %1325 ], [ 1, %858 ]
  %1332 = phi i64 [ %859, %1325 ], [ 0, %858 ]
  br i1 %864, label %865, label %1320

1333:                                             ; preds = %869
  %1334 = add nsw i64 %871, -1
  %1335 = add i64 %870, 1
  %1336 = call i64 @llvm.smax.i64(i64 %853, i64 0)
  br label %873

1337:                                             ; preds = %873
  %1338 = add nsw i64 %875, -1
  %1339 = add i64 %874, 1
  %1340 = icmp slt i64 %874, 0
  %1341 = select i1 %1340, i64 %64, i64 0
  %1342 = getelementptr double, ptr %65, i64 %874
  %1343 = getelementptr double, ptr %1342, i64 %1341
  %1344 = load double, ptr %1343, align 8, !noalias !61
  %1345 = icmp slt i64 %870, 0
  %1346 = select i1 %1345, i64 %235, i64 0
  %1347 = add i64 %870, %1346
  %1348 = select i1 %1340, i64 %237, i64 0
  %1349 = mul i64 %1347, %237
  %1350 = getelementptr double, ptr %238, i64 %1349
  %1351 = getelementptr double, ptr %1350, i64 %874
  %1352 = getelementptr double, ptr %1351, i64 %1348
  %1353 = load double, ptr %1352, align 8, !noalias !61
  %1354 = fadd double %1344, %1353
  %1355 = select i1 %1340, i64 %74, i64 0
  %1356 = getelementptr double, ptr %75, i64 %874
  %1357 = getelementptr double, ptr %1356, i64 %1355
  store double %1354, ptr %1357, align 8, !noalias !61
  br label %873

1358:                                             ; preds = %902, %902
  %1359 = icmp eq i32 %903, 0
  br i1 %1359, label %869, label %905

1360:                                             ; preds = %909
  %1361 = icmp slt i64 %910, 0
  %1362 = select i1 %1361, i64 %249, i64 0
  %1363 = getelementptr double, ptr %250, i64 %910
  %1364 = getelementptr double, ptr %1363, i64 %1362
  %1365 = load double, ptr %1364, align 8, !noalias !61
  %1366 = getelementptr double, ptr %250, i64 %249
  %1367 = getelementptr double, ptr %1366, i64 %910
  %1368 = getelementptr double, ptr %1367, i64 %1362
  %1369 = load double, ptr %1368, align 8, !noalias !61
  %1370 = fadd double %1365, %1369
  %1371 = shl i64 %249, 4
  %1372 = getelementptr i8, ptr %250, i64 %1371
  %1373 = getelementptr double, ptr %1372, i64 %910
  %1374 = getelementptr double, ptr %1373, i64 %1362
  %1375 = load double, ptr %1374, align 8, !noalias !61
  %1376 = fadd double %1370, %1375
  %1377 = fsub double %1376, %1376
  %1378 = fcmp ord double %1377, 0.000000e+00
  br i1 %1378, label %914, label %1877

1379:                                             ; preds = %993, %993
  %1380 = call i64 @llvm.smax.i64(i64 %218, i64 0)
  br label %1381

1381:                                             ; preds = %1399, %1379
  %1382 = phi i64 [ 0, %1379 ], [ %1464, %1399 ]
  %1383 = phi i64 [ %1380, %1379 ], [ %1463, %1399 ]
  %1384 = icmp sgt i64 %1383, 0
  br i1 %1384, label %1462, label %1400

1385:                                             ; preds = %1462
  %1386 = icmp slt i64 %1469, 0
  %1387 = select i1 %1386, i64 %266, i64 0
  %1388 = getelementptr { double, double }, ptr %267, i64 %1469
  %1389 = getelementptr { double, double }, ptr %1388, i64 %1387
  %1390 = load double, ptr %1389, align 8, !noalias !96
  %1391 = getelementptr inbounds nuw i8, ptr %1389, i64 8
  %1392 = load double, ptr %1391, align 8, !noalias !96
  %1393 = select i1 %1465, i64 %266, i64 0
  %1394 = getelementptr { double, double }, ptr %267, i64 %1382
  %1395 = getelementptr { double, double }, ptr %1394, i64 %1393
  %1396 = load double, ptr %1395, align 8, !noalias !96
  %1397 = getelementptr inbounds nuw i8, ptr %1395, i64 8
  %1398 = load double, ptr %1397, align 8, !noalias !96
  store double %1390, ptr %1395, align 8, !noalias !96
  store double %1392, ptr %1397, align 8, !noalias !96
  store double %1396, ptr %1389, align 8, !noalias !96
  store double %1398, ptr %1391, align 8, !noalias !96
  br label %1399

1399:                                             ; preds = %1462, %1385
  br label %1381

1400:                                             ; preds = %1381, %1410
  %1401 = phi i64 [ %1473, %1410 ], [ 0, %1381 ]
  %1402 = phi i64 [ %1472, %1410 ], [ %1380, %1381 ]
  %1403 = icmp sgt i64 %1402, 0
  br i1 %1403, label %1471, label %1411

1404:                                             ; preds = %1482, %1471
  %1405 = phi i64 [ 0, %1471 ], [ %1506, %1482 ]
  %1406 = phi i64 [ %1481, %1471 ], [ %1507, %1482 ]
  %1407 = phi double [ %1480, %1471 ], [ %1509, %1482 ]
  %1408 = phi double [ %1478, %1471 ], [ %1508, %1482 ]
  %1409 = icmp sgt i64 %1406, 0
  br i1 %1409, label %1482, label %1410

1410:                                             ; preds = %1404
  store double %1408, ptr %1477, align 8, !noalias !96
  store double %1407, ptr %1479, align 8, !noalias !96
  br label %1400

1411:                                             ; preds = %1400
  %1412 = icmp ugt i64 %218, -9223372036854775808
  %1413 = select i1 %1412, i64 0, i64 %218
  br label %1414

1414:                                             ; preds = %1459, %1411
  %1415 = phi i64 [ %218, %1411 ], [ %1417, %1459 ]
  %1416 = phi i64 [ %1413, %1411 ], [ %1511, %1459 ]
  %1417 = add i64 %1415, -1
  %1418 = icmp sgt i64 %1416, 0
  br i1 %1418, label %1510, label %1549

1419:                                             ; preds = %1521, %1510
  %1420 = phi i64 [ %1415, %1510 ], [ %1545, %1521 ]
  %1421 = phi i64 [ %1520, %1510 ], [ %1546, %1521 ]
  %1422 = phi double [ %1518, %1510 ], [ %1548, %1521 ]
  %1423 = phi double [ %1516, %1510 ], [ %1547, %1521 ]
  %1424 = icmp sgt i64 %1421, 0
  br i1 %1424, label %1521, label %1425

1425:                                             ; preds = %1419
  %1426 = select i1 %1512, i64 %218, i64 0
  %1427 = add i64 %1417, %1426
  %1428 = select i1 %1512, i64 %220, i64 0
  %1429 = mul i64 %1427, %220
  %1430 = getelementptr { double, double }, ptr %221, i64 %1429
  %1431 = getelementptr { double, double }, ptr %1430, i64 %1417
  %1432 = getelementptr { double, double }, ptr %1431, i64 %1428
  %1433 = load double, ptr %1432, align 8, !noalias !96
  %1434 = getelementptr inbounds nuw i8, ptr %1432, i64 8
  %1435 = load double, ptr %1434, align 8, !noalias !96
  %1436 = call double @llvm.fabs.f64(double %1433)
  %1437 = call double @llvm.fabs.f64(double %1435)
  %1438 = fcmp ult double %1436, %1437
  br i1 %1438, label %1449, label %1439

1439:                                             ; preds = %1425
  %1440 = fdiv double %1435, %1433
  %1441 = fmul double %1435, %1440
  %1442 = fadd double %1433, %1441
  %1443 = fmul double %1422, %1440
  %1444 = fadd double %1423, %1443
  %1445 = fdiv double %1444, %1442
  %1446 = fmul double %1423, %1440
  %1447 = fsub double %1422, %1446
  %1448 = fdiv double %1447, %1442
  br label %1459

1449:                                             ; preds = %1425
  %1450 = fdiv double %1433, %1435
  %1451 = fmul double %1433, %1450
  %1452 = fadd double %1451, %1435
  %1453 = fmul double %1423, %1450
  %1454 = fadd double %1453, %1422
  %1455 = fdiv double %1454, %1452
  %1456 = fmul double %1422, %1450
  %1457 = fsub double %1456, %1423
  %1458 = fdiv double %1457, %1452
  br label %1459

1459:                                             ; preds = %1449, %1439
  %1460 = phi double [ %1448, %1439 ], [ %1458, %1449 ]
  %1461 = phi double [ %1445, %1439 ], [ %1455, %1449 ]
  store double %1461, ptr %1515, align 8, !noalias !96
  store double %1460, ptr %1517, align 8, !noalias !96
  br label %1414

1462:                                             ; preds = %1381
  %1463 = add nsw i64 %1383, -1
  %1464 = add i64 %1382, 1
  %1465 = icmp slt i64 %1382, 0
  %1466 = select i1 %1465, i64 %230, i64 0
  %1467 = getelementptr i64, ptr %231, i64 %1382
  %1468 = getelementptr i64, ptr %1467, i64 %1466
  %1469 = load i64, ptr %1468, align 8, !noalias !96
  %1470 = icmp eq i64 %1469, %1382
  br i1 %1470, label %1399, label %1385

1471:                                             ; preds = %1400
  %1472 = add nsw i64 %1402, -1
  %1473 = add i64 %1401, 1
  %1474 = icmp slt i64 %1401, 0
  %1475 = select i1 %1474, i64 %266, i64 0
  %1476 = getelementptr { double, double }, ptr %267, i64 %1401
  %1477 = getelementptr { double, double }, ptr %1476, i64 %1475
  %1478 = load double, ptr %1477, align 8, !noalias !96
  %1479 = getelementptr inbounds nuw i8, ptr %1477, i64 8
  %1480 = load double, ptr %1479, align 8, !noalias !96
  %1481 = call i64 @llvm.smax.i64(i64 %1401, i64 0)
  br label %1404

1482:                                             ; preds = %1404
  %1483 = select i1 %1474, i64 %218, i64 0
  %1484 = add i64 %1401, %1483
  %1485 = icmp slt i64 %1405, 0
  %1486 = select i1 %1485, i64 %220, i64 0
  %1487 = mul i64 %1484, %220
  %1488 = getelementptr { double, double }, ptr %221, i64 %1487
  %1489 = getelementptr { double, double }, ptr %1488, i64 %1405
  %1490 = getelementptr { double, double }, ptr %1489, i64 %1486
  %1491 = load double, ptr %1490, align 8, !noalias !96
  %1492 = getelementptr inbounds nuw i8, ptr %1490, i64 8
  %1493 = load double, ptr %1492, align 8, !noalias !96
  %1494 = select i1 %1485, i64 %266, i64 0
  %1495 = getelementptr { double, double }, ptr %267, i64 %1405
  %1496 = getelementptr { double, double }, ptr %1495, i64 %1494
  %1497 = load double, ptr %1496, align 8, !noalias !96
  %1498 = getelementptr inbounds nuw i8, ptr %1496, i64 8
  %1499 = load double, ptr %1498, align 8, !noalias !96
  %1500 = fmul double %1491, %1499
  %1501 = fmul double %1493, %1497
  %1502 = fadd double %1500, %1501
  %1503 = fmul double %1491, %1497
  %1504 = fmul double %1493, %1499
  %1505 = fsub double %1503, %1504
  %1506 = add i64 %1405, 1
  %1507 = add nsw i64 %1406, -1
  %1508 = fsub double %1408, %1505
  %1509 = fsub double %1407, %1502
  br label %1404

1510:                                             ; preds = %1414
  %1511 = add nsw i64 %1416, -1
  %1512 = icmp slt i64 %1417, 0
  %1513 = select i1 %1512, i64 %266, i64 0
  %1514 = getelementptr { double, double }, ptr %267, i64 %1417
  %1515 = getelementptr { double, double }, ptr %1514, i64 %1513
  %1516 = load double, ptr %1515, align 8, !noalias !96
  %1517 = getelementptr inbounds nuw i8, ptr %1515, i64 8
  %1518 = load double, ptr %1517, align 8, !noalias !96
  %1519 = sub i64 %218, %1415
  %1520 = call i64 @llvm.smax.i64(i64 %1519, i64 0)
  br label %1419

1521:                                             ; preds = %1419
  %1522 = select i1 %1512, i64 %218, i64 0
  %1523 = add i64 %1417, %1522
  %1524 = icmp slt i64 %1420, 0
  %1525 = select i1 %1524, i64 %220, i64 0
  %1526 = mul i64 %1523, %220
  %1527 = getelementptr { double, double }, ptr %221, i64 %1526
  %1528 = getelementptr { double, double }, ptr %1527, i64 %1420
  %1529 = getelementptr { double, double }, ptr %1528, i64 %1525
  %1530 = load double, ptr %1529, align 8, !noalias !96
  %1531 = getelementptr inbounds nuw i8, ptr %1529, i64 8
  %1532 = load double, ptr %1531, align 8, !noalias !96
  %1533 = select i1 %1524, i64 %266, i64 0
  %1534 = getelementptr { double, double }, ptr %267, i64 %1420
  %1535 = getelementptr { double, double }, ptr %1534, i64 %1533
  %1536 = load double, ptr %1535, align 8, !noalias !96
  %1537 = getelementptr inbounds nuw i8, ptr %1535, i64 8
  %1538 = load double, ptr %1537, align 8, !noalias !96
  %1539 = fmul double %1530, %1538
  %1540 = fmul double %1532, %1536
  %1541 = fadd double %1539, %1540
  %1542 = fmul double %1530, %1536
  %1543 = fmul double %1532, %1538
  %1544 = fsub double %1542, %1543
  %1545 = add i64 %1420, 1
  %1546 = add nsw i64 %1421, -1
  %1547 = fsub double %1423, %1544
  %1548 = fsub double %1422, %1541
  br label %1419

1549:                                             ; preds = %1414
  br i1 %856, label %995, label %1164

1550:                                             ; preds = %1026, %1563
  %1551 = phi i64 [ %1631, %1563 ], [ 0, %1026 ]
  %1552 = phi i64 [ %1630, %1563 ], [ %1380, %1026 ]
  %1553 = icmp sgt i64 %1552, 0
  br i1 %1553, label %1629, label %1564

1554:                                             ; preds = %1629
  %1555 = mul nsw i64 %1551, %855
  %1556 = add nsw i64 %218, %1555
  %1557 = mul nsw i64 %1636, %855
  %1558 = add nsw i64 %218, %1557
  br label %1559

1559:                                             ; preds = %1638, %1554
  %1560 = phi i64 [ 0, %1554 ], [ %1640, %1638 ]
  %1561 = phi i64 [ %855, %1554 ], [ %1639, %1638 ]
  %1562 = icmp sgt i64 %1561, 0
  br i1 %1562, label %1638, label %1563

1563:                                             ; preds = %1629, %1559
  br label %1550

1564:                                             ; preds = %1550, %1568
  %1565 = phi i64 [ %1659, %1568 ], [ 0, %1550 ]
  %1566 = phi i64 [ %1658, %1568 ], [ %1380, %1550 ]
  %1567 = icmp sgt i64 %1566, 0
  br i1 %1567, label %1657, label %1576

1568:                                             ; preds = %1657, %1572
  %1569 = phi i64 [ 0, %1657 ], [ %1663, %1572 ]
  %1570 = phi i64 [ %1660, %1657 ], [ %1662, %1572 ]
  %1571 = icmp sgt i64 %1570, 0
  br i1 %1571, label %1661, label %1564

1572:                                             ; preds = %1680, %1661
  %1573 = phi i64 [ 0, %1661 ], [ %1703, %1680 ]
  %1574 = phi i64 [ %855, %1661 ], [ %1704, %1680 ]
  %1575 = icmp sgt i64 %1574, 0
  br i1 %1575, label %1680, label %1568

1576:                                             ; preds = %1564, %1625
  %1577 = phi i64 [ %1579, %1625 ], [ %218, %1564 ]
  %1578 = phi i64 [ %1708, %1625 ], [ %1413, %1564 ]
  %1579 = add i64 %1577, -1
  %1580 = icmp sgt i64 %1578, 0
  br i1 %1580, label %1707, label %1164

1581:                                             ; preds = %1707, %1585
  %1582 = phi i64 [ %1577, %1707 ], [ %1715, %1585 ]
  %1583 = phi i64 [ %1712, %1707 ], [ %1714, %1585 ]
  %1584 = icmp sgt i64 %1583, 0
  br i1 %1584, label %1713, label %1589

1585:                                             ; preds = %1730, %1713
  %1586 = phi i64 [ 0, %1713 ], [ %1753, %1730 ]
  %1587 = phi i64 [ %855, %1713 ], [ %1754, %1730 ]
  %1588 = icmp sgt i64 %1587, 0
  br i1 %1588, label %1730, label %1581

1589:                                             ; preds = %1581
  %1590 = icmp slt i64 %1579, 0
  %1591 = select i1 %1590, i64 %218, i64 0
  %1592 = add i64 %1579, %1591
  %1593 = select i1 %1590, i64 %220, i64 0
  %1594 = mul i64 %1592, %220
  %1595 = getelementptr { double, double }, ptr %221, i64 %1594
  %1596 = getelementptr { double, double }, ptr %1595, i64 %1579
  %1597 = getelementptr { double, double }, ptr %1596, i64 %1593
  %1598 = load double, ptr %1597, align 8, !noalias !100
  %1599 = getelementptr inbounds nuw i8, ptr %1597, i64 8
  %1600 = load double, ptr %1599, align 8, !noalias !100
  %1601 = call double @llvm.fabs.f64(double %1598)
  %1602 = call double @llvm.fabs.f64(double %1600)
  %1603 = fcmp ult double %1601, %1602
  br i1 %1603, label %1613, label %1604

1604:                                             ; preds = %1589
  %1605 = fdiv double %1600, %1598
  %1606 = fmul double %1600, %1605
  %1607 = fadd double %1598, %1606
  %1608 = fmul double %1605, 0.000000e+00
  %1609 = fadd double %1608, 1.000000e+00
  %1610 = fdiv double %1609, %1607
  %1611 = fsub double 0.000000e+00, %1605
  %1612 = fdiv double %1611, %1607
  br label %1622

1613:                                             ; preds = %1589
  %1614 = fdiv double %1598, %1600
  %1615 = fmul double %1598, %1614
  %1616 = fadd double %1615, %1600
  %1617 = fadd double %1614, 0.000000e+00
  %1618 = fdiv double %1617, %1616
  %1619 = fmul double %1614, 0.000000e+00
  %1620 = fadd double %1619, -1.000000e+00
  %1621 = fdiv double %1620, %1616
  br label %1622

1622:                                             ; preds = %1613, %1604
  %1623 = phi double [ %1612, %1604 ], [ %1621, %1613 ]
  %1624 = phi double [ %1610, %1604 ], [ %1618, %1613 ]
  br label %1625

1625:                                             ; preds = %1757, %1622
  %1626 = phi i64 [ 0, %1622 ], [ %1772, %1757 ]
  %1627 = phi i64 [ %855, %1622 ], [ %1773, %1757 ]
  %1628 = icmp sgt i64 %1627, 0
  br i1 %1628, label %1757, label %1576

1629:                                             ; preds = %1550
  %1630 = add nsw i64 %1552, -1
  %1631 = add i64 %1551, 1
  %1632 = icmp slt i64 %1551, 0
  %1633 = select i1 %1632, i64 %230, i64 0
  %1634 = getelementptr i64, ptr %231, i64 %1551
  %1635 = getelementptr i64, ptr %1634, i64 %1633
  %1636 = load i64, ptr %1635, align 8, !noalias !100
  %1637 = icmp eq i64 %1636, %1551
  br i1 %1637, label %1563, label %1554

1638:                                             ; preds = %1559
  %1639 = add nsw i64 %1561, -1
  %1640 = add i64 %1560, 1
  %1641 = add nsw i64 %1558, %1560
  %1642 = icmp slt i64 %1641, 0
  %1643 = select i1 %1642, i64 %266, i64 0
  %1644 = getelementptr { double, double }, ptr %267, i64 %1641
  %1645 = getelementptr { double, double }, ptr %1644, i64 %1643
  %1646 = load double, ptr %1645, align 8, !noalias !100
  %1647 = getelementptr inbounds nuw i8, ptr %1645, i64 8
  %1648 = load double, ptr %1647, align 8, !noalias !100
  %1649 = add nsw i64 %1556, %1560
  %1650 = icmp slt i64 %1649, 0
  %1651 = select i1 %1650, i64 %266, i64 0
  %1652 = getelementptr { double, double }, ptr %267, i64 %1649
  %1653 = getelementptr { double, double }, ptr %1652, i64 %1651
  %1654 = load double, ptr %1653, align 8, !noalias !100
  %1655 = getelementptr inbounds nuw i8, ptr %1653, i64 8
  %1656 = load double, ptr %1655, align 8, !noalias !100
  store double %1646, ptr %1653, align 8, !noalias !100
  store double %1648, ptr %1655, align 8, !noalias !100
  store double %1654, ptr %1645, align 8, !noalias !100
  store double %1656, ptr %1647, align 8, !noalias !100
  br label %1559

1657:                                             ; preds = %1564
  %1658 = add nsw i64 %1566, -1
  %1659 = add i64 %1565, 1
  %1660 = call i64 @llvm.smax.i64(i64 %1565, i64 0)
  br label %1568

1661:                                             ; preds = %1568
  %1662 = add nsw i64 %1570, -1
  %1663 = add i64 %1569, 1
  %1664 = icmp slt i64 %1565, 0
  %1665 = select i1 %1664, i64 %218, i64 0
  %1666 = add i64 %1565, %1665
  %1667 = icmp slt i64 %1569, 0
  %1668 = select i1 %1667, i64 %220, i64 0
  %1669 = mul i64 %1666, %220
  %1670 = getelementptr { double, double }, ptr %221, i64 %1669
  %1671 = getelementptr { double, double }, ptr %1670, i64 %1569
  %1672 = getelementptr { double, double }, ptr %1671, i64 %1668
  %1673 = load double, ptr %1672, align 8, !noalias !100
  %1674 = getelementptr inbounds nuw i8, ptr %1672, i64 8
  %1675 = load double, ptr %1674, align 8, !noalias !100
  %1676 = mul nsw i64 %1565, %855
  %1677 = add nsw i64 %218, %1676
  %1678 = mul nsw i64 %1569, %855
  %1679 = add nsw i64 %218, %1678
  br label %1572

1680:                                             ; preds = %1572
  %1681 = add nsw i64 %1677, %1573
  %1682 = icmp slt i64 %1681, 0
  %1683 = select i1 %1682, i64 %266, i64 0
  %1684 = getelementptr { double, double }, ptr %267, i64 %1681
  %1685 = getelementptr { double, double }, ptr %1684, i64 %1683
  %1686 = load double, ptr %1685, align 8, !noalias !100
  %1687 = getelementptr inbounds nuw i8, ptr %1685, i64 8
  %1688 = load double, ptr %1687, align 8, !noalias !100
  %1689 = add nsw i64 %1679, %1573
  %1690 = icmp slt i64 %1689, 0
  %1691 = select i1 %1690, i64 %266, i64 0
  %1692 = getelementptr { double, double }, ptr %267, i64 %1689
  %1693 = getelementptr { double, double }, ptr %1692, i64 %1691
  %1694 = load double, ptr %1693, align 8, !noalias !100
  %1695 = getelementptr inbounds nuw i8, ptr %1693, i64 8
  %1696 = load double, ptr %1695, align 8, !noalias !100
  %1697 = fmul double %1673, %1696
  %1698 = fmul double %1675, %1694
  %1699 = fadd double %1697, %1698
  %1700 = fmul double %1673, %1694
  %1701 = fmul double %1675, %1696
  %1702 = fsub double %1700, %1701
  %1703 = add i64 %1573, 1
  %1704 = add nsw i64 %1574, -1
  %1705 = fsub double %1686, %1702
  %1706 = fsub double %1688, %1699
  store double %1705, ptr %1685, align 8, !noalias !100
  store double %1706, ptr %1687, align 8, !noalias !100
  br label %1572

1707:                                             ; preds = %1576
  %1708 = add nsw i64 %1578, -1
  %1709 = mul nsw i64 %1579, %855
  %1710 = add nsw i64 %218, %1709
  %1711 = sub i64 %218, %1577
  %1712 = call i64 @llvm.smax.i64(i64 %1711, i64 0)
  br label %1581

1713:                                             ; preds = %1581
  %1714 = add nsw i64 %1583, -1
  %1715 = add i64 %1582, 1
  %1716 = icmp slt i64 %1579, 0
  %1717 = select i1 %1716, i64 %218, i64 0
  %1718 = add i64 %1579, %1717
  %1719 = icmp slt i64 %1582, 0
  %1720 = select i1 %1719, i64 %220, i64 0
  %1721 = mul i64 %1718, %220
  %1722 = getelementptr { double, double }, ptr %221, i64 %1721
  %1723 = getelementptr { double, double }, ptr %1722, i64 %1582
  %1724 = getelementptr { double, double }, ptr %1723, i64 %1720
  %1725 = load double, ptr %1724, align 8, !noalias !100
  %1726 = getelementptr inbounds nuw i8, ptr %1724, i64 8
  %1727 = load double, ptr %1726, align 8, !noalias !100
  %1728 = mul nsw i64 %1582, %855
  %1729 = add nsw i64 %218, %1728
  br label %1585

1730:                                             ; preds = %1585
  %1731 = add nsw i64 %1710, %1586
  %1732 = icmp slt i64 %1731, 0
  %1733 = select i1 %1732, i64 %266, i64 0
  %1734 = getelementptr { double, double }, ptr %267, i64 %1731
  %1735 = getelementptr { double, double }, ptr %1734, i64 %1733
  %1736 = load double, ptr %1735, align 8, !noalias !100
  %1737 = getelementptr inbounds nuw i8, ptr %1735, i64 8
  %1738 = load double, ptr %1737, align 8, !noalias !100
  %1739 = add nsw i64 %1729, %1586
  %1740 = icmp slt i64 %1739, 0
  %1741 = select i1 %1740, i64 %266, i64 0
  %1742 = getelementptr { double, double }, ptr %267, i64 %1739
  %1743 = getelementptr { double, double }, ptr %1742, i64 %1741
  %1744 = load double, ptr %1743, align 8, !noalias !100
  %1745 = getelementptr inbounds nuw i8, ptr %1743, i64 8
  %1746 = load double, ptr %1745, align 8, !noalias !100
  %1747 = fmul double %1725, %1746
  %1748 = fmul double %1727, %1744
  %1749 = fadd double %1747, %1748
  %1750 = fmul double %1725, %1744
  %1751 = fmul double %1727, %1746
  %1752 = fsub double %1750, %1751
  %1753 = add i64 %1586, 1
  %1754 = add nsw i64 %1587, -1
  %1755 = fsub double %1736, %1752
  %1756 = fsub double %1738, %1749
  store double %1755, ptr %1735, align 8, !noalias !100
  store double %1756, ptr %1737, align 8, !noalias !100
  br label %1585

1757:                                             ; preds = %1625
  %1758 = add nsw i64 %1710, %1626
  %1759 = icmp slt i64 %1758, 0
  %1760 = select i1 %1759, i64 %266, i64 0
  %1761 = getelementptr { double, double }, ptr %267, i64 %1758
  %1762 = getelementptr { double, double }, ptr %1761, i64 %1760
  %1763 = load double, ptr %1762, align 8, !noalias !100
  %1764 = getelementptr inbounds nuw i8, ptr %1762, i64 8
  %1765 = load double, ptr %1764, align 8, !noalias !100
  %1766 = fmul double %1763, %1623
  %1767 = fmul double %1765, %1624
  %1768 = fadd double %1766, %1767
  %1769 = fmul double %1763, %1624
  %1770 = fmul double %1765, %1623
  %1771 = fsub double %1769, %1770
  %1772 = add i64 %1626, 1
  %1773 = add nsw i64 %1627, -1
  store double %1771, ptr %1762, align 8, !noalias !100
  store double %1768, ptr %1764, align 8, !noalias !100
  br label %1625

1774:                                             ; preds = %1165
  %1775 = add nsw i64 %1167, -1
  %1776 = add i64 %1166, 1
  %1777 = icmp slt i64 %1166, 0
  %1778 = select i1 %1777, i64 %64, i64 0
  %1779 = getelementptr double, ptr %65, i64 %1166
  %1780 = getelementptr double, ptr %1779, i64 %1778
  %1781 = load double, ptr %1780, align 8, !noalias !61
  %1782 = select i1 %1777, i64 %99, i64 0
  %1783 = getelementptr double, ptr %100, i64 %1166
  %1784 = getelementptr double, ptr %1783, i64 %1782
  %1785 = load double, ptr %1784, align 8, !noalias !104
  %1786 = select i1 %1777, i64 %94, i64 0
  %1787 = getelementptr double, ptr %95, i64 %1166
  %1788 = getelementptr double, ptr %1787, i64 %1786
  %1789 = load double, ptr %1788, align 8, !noalias !104
  %1790 = call double @llvm.fabs.f64(double %1781)
  %1791 = fmul double %1789, %1790
  %1792 = fadd double %1785, %1791
  %1793 = select i1 %1777, i64 %261, i64 0
  %1794 = getelementptr double, ptr %262, i64 %1166
  %1795 = getelementptr double, ptr %1794, i64 %1793
  %1796 = load double, ptr %1795, align 8, !noalias !61
  %1797 = fdiv double %1796, %1792
  %1798 = select i1 %1777, i64 %266, i64 0
  %1799 = getelementptr { double, double }, ptr %267, i64 %1166
  %1800 = getelementptr { double, double }, ptr %1799, i64 %1798
  %1801 = load double, ptr %1800, align 8, !noalias !61
  %1802 = fdiv double %1801, %1792
  %1803 = getelementptr inbounds nuw i8, ptr %1800, i64 8
  %1804 = load double, ptr %1803, align 8, !noalias !61
  %1805 = fdiv double %1804, %1792
  %1806 = fmul double %1797, %1797
  %1807 = fmul double %1802, %1802
  %1808 = fadd double %1806, %1807
  %1809 = fmul double %1805, %1805
  %1810 = fadd double %1808, %1809
  %1811 = fadd double %1168, %1810
  br label %1165

1812:                                             ; preds = %1209
  %1813 = fcmp ult double %1182, 1.000000e+00
  br i1 %1813, label %1213, label %1877

1814:                                             ; preds = %1220
  %1815 = add nsw i64 %1222, -1
  %1816 = add i64 %1221, 1
  %1817 = icmp slt i64 %1221, 0
  %1818 = select i1 %1817, i64 %244, i64 0
  %1819 = getelementptr double, ptr %245, i64 %1221
  %1820 = getelementptr double, ptr %1819, i64 %1818
  %1821 = load double, ptr %1820, align 8, !noalias !61
  %1822 = select i1 %1817, i64 %261, i64 0
  %1823 = getelementptr double, ptr %262, i64 %1221
  %1824 = getelementptr double, ptr %1823, i64 %1822
  %1825 = load double, ptr %1824, align 8, !noalias !61
  %1826 = fadd double %1821, %1825
  store double %1826, ptr %1820, align 8, !noalias !61
  %1827 = getelementptr double, ptr %245, i64 %244
  %1828 = getelementptr double, ptr %1827, i64 %1221
  %1829 = getelementptr double, ptr %1828, i64 %1818
  %1830 = load double, ptr %1829, align 8, !noalias !61
  %1831 = select i1 %1817, i64 %266, i64 0
  %1832 = getelementptr { double, double }, ptr %267, i64 %1221
  %1833 = getelementptr { double, double }, ptr %1832, i64 %1831
  %1834 = load double, ptr %1833, align 8, !noalias !61
  %1835 = fadd double %1830, %1834
  store double %1835, ptr %1829, align 8, !noalias !61
  %1836 = shl i64 %244, 4
  %1837 = getelementptr i8, ptr %245, i64 %1836
  %1838 = getelementptr double, ptr %1837, i64 %1221
  %1839 = getelementptr double, ptr %1838, i64 %1818
  %1840 = load double, ptr %1839, align 8, !noalias !61
  %1841 = getelementptr inbounds nuw i8, ptr %1833, i64 8
  %1842 = load double, ptr %1841, align 8, !noalias !61
  %1843 = fadd double %1840, %1842
  store double %1843, ptr %1839, align 8, !noalias !61
  br label %1224

1844:                                             ; preds = %1224
  %1845 = add nsw i64 %1226, -1
  %1846 = add i64 %1225, 1
  %1847 = icmp slt i64 %1225, 0
  %1848 = add i64 %1225, 3
  %1849 = select i1 %1847, i64 %1848, i64 %1225
  %1850 = mul i64 %1849, 24
  %1851 = getelementptr i8, ptr @5, i64 %1850
  %1852 = load double, ptr %1851, align 8, !noalias !61
  %1853 = load double, ptr %1820, align 8, !noalias !61
  %1854 = fmul double %1852, %1853
  %1855 = getelementptr i8, ptr @6, i64 %1850
  %1856 = getelementptr i8, ptr %1855, i64 8
  %1857 = load double, ptr %1856, align 8, !noalias !61
  %1858 = load double, ptr %1829, align 8, !noalias !61
  %1859 = fmul double %1857, %1858
  %1860 = fadd double %1854, %1859
  %1861 = getelementptr i8, ptr @7, i64 %1850
  %1862 = getelementptr i8, ptr %1861, i64 16
  %1863 = load double, ptr %1862, align 8, !noalias !61
  %1864 = load double, ptr %1839, align 8, !noalias !61
  %1865 = fmul double %1863, %1864
  %1866 = fadd double %1860, %1865
  %1867 = select i1 %1847, i64 %235, i64 0
  %1868 = add i64 %1225, %1867
  %1869 = select i1 %1817, i64 %237, i64 0
  %1870 = mul i64 %1868, %237
  %1871 = getelementptr double, ptr %238, i64 %1870
  %1872 = getelementptr double, ptr %1871, i64 %1221
  %1873 = getelementptr double, ptr %1872, i64 %1869
  store double %1866, ptr %1873, align 8, !noalias !61
  br label %1224

1874:                                             ; preds = %1245
  %1875 = fmul double %852, %852
  %1876 = fcmp ugt double %1248, %1875
  br i1 %1876, label %1319, label %1320

1877:                                             ; preds = %1209, %993, %902, %1213, %1812, %1170, %1360, %905, %1320
  %1878 = phi double [ %1321, %1320 ], [ %1182, %1213 ], [ 0.000000e+00, %905 ], [ 0.000000e+00, %993 ], [ 0.000000e+00, %902 ], [ 0x7FF0000000000000, %1360 ], [ %862, %1170 ], [ %1182, %1812 ], [ 0.000000e+00, %1209 ]
  %1879 = phi i64 [ %1324, %1320 ], [ %1331, %1213 ], [ %1332, %905 ], [ 0, %993 ], [ 0, %902 ], [ %1332, %1360 ], [ %1331, %1170 ], [ %1331, %1812 ], [ 0, %1209 ]
  %1880 = phi i1 [ %1323, %1320 ], [ true, %1213 ], [ true, %905 ], [ true, %993 ], [ true, %902 ], [ true, %1360 ], [ true, %1170 ], [ true, %1812 ], [ true, %1209 ]
  %1881 = phi i64 [ 0, %1320 ], [ 0, %1213 ], [ %906, %905 ], [ 0, %993 ], [ 0, %902 ], [ 0, %1360 ], [ 0, %1170 ], [ 0, %1812 ], [ 0, %1209 ]
  %1882 = phi i32 [ 0, %1320 ], [ 0, %1213 ], [ 0, %905 ], [ %994, %993 ], [ %904, %902 ], [ 0, %1360 ], [ 0, %1170 ], [ 0, %1812 ], [ %1212, %1209 ]
  switch i32 %1882, label %2552 [
    i32 -2, label %2550
    i32 0, label %2550
  ], !prof !32

1883:                                             ; preds = %2550
  br label %2683

1884:                                             ; preds = %2550
  br i1 %1880, label %2304, label %1885

1885:                                             ; preds = %1884, %2553
  %1886 = phi i64 [ %2555, %2553 ], [ 0, %1884 ]
  %1887 = phi i64 [ %2554, %2553 ], [ %282, %1884 ]
  %1888 = icmp sgt i64 %1887, 0
  br i1 %1888, label %2553, label %1889

1889:                                             ; preds = %1885
  %1890 = getelementptr i8, ptr %196, i64 32
  %1891 = load i64, ptr %1890, align 8, !noalias !12
  %1892 = icmp ne i64 %1891, 1
  store ptr null, ptr %6, align 8, !noalias !107
  store double 0.000000e+00, ptr %7, align 8, !noalias !107
  store ptr null, ptr %8, align 8, !noalias !107
  store double 0.000000e+00, ptr %9, align 8, !noalias !107
  %1893 = load i64, ptr %116, align 8, !noalias !107
  %1894 = call i64 @llvm.smax.i64(i64 %1893, i64 0)
  br label %1895

1895:                                             ; preds = %1930, %1889
  %1896 = phi i64 [ 0, %1889 ], [ %1932, %1930 ]
  %1897 = phi i64 [ %1894, %1889 ], [ %1931, %1930 ]
  %1898 = icmp sgt i64 %1897, 0
  br i1 %1898, label %1930, label %1899

1899:                                             ; preds = %1895
  store ptr null, ptr %6, align 8, !noalias !107
  %1900 = call fastcc i32 @solve(ptr nonnull %6, ptr %214, i64 %211, i64 %213, ptr %226, i64 %225, ptr %262, i64 %261) #3, !noalias !107
  switch i32 %1900, label %2008 [
    i32 -2, label %1964
    i32 0, label %1964
  ], !prof !32

1901:                                             ; preds = %1967, %1970
  %1902 = phi i64 [ %1972, %1970 ], [ 0, %1967 ]
  %1903 = phi i64 [ %1971, %1970 ], [ %1894, %1967 ]
  %1904 = icmp sgt i64 %1903, 0
  br i1 %1904, label %1970, label %1905

1905:                                             ; preds = %1901
  %1906 = getelementptr i8, ptr %110, i64 24
  %1907 = load i64, ptr %1906, align 8, !noalias !107
  %1908 = add nsw i64 %1907, 1
  store i64 %1908, ptr %1906, align 8, !noalias !107
  store ptr null, ptr %4, align 8, !noalias !111
  store ptr null, ptr %5, align 8, !noalias !111
  store double %366, ptr %33, align 8, !noalias !111
  %1909 = icmp sgt i64 %45, 0
  br i1 %1909, label %1910, label %1913

1910:                                             ; preds = %1905
  store ptr null, ptr %4, align 8, !noalias !111
  %1911 = call fastcc i32 @_sample(ptr nonnull %4, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %366) #3
  switch i32 %1911, label %1912 [
    i32 -2, label %1913
    i32 0, label %1913
  ], !prof !32

1912:                                             ; preds = %1910
  br label %1913

1913:                                             ; preds = %1910, %1910, %1905, %1912
  %1914 = phi i32 [ %1911, %1912 ], [ 0, %1905 ], [ 0, %1910 ], [ 0, %1910 ]
  switch i32 %1914, label %1919 [
    i32 -2, label %1915
    i32 0, label %1915
  ], !prof !32

1915:                                             ; preds = %1913, %1913
  %1916 = load i64, ptr %30, align 8, !noalias !118
  %1917 = inttoptr i64 %1916 to ptr
  %1918 = call i32 %1917(ptr nonnull %33, ptr %75, ptr %38, ptr %41, ptr %250) #3, !noalias !118
  br label %1919

1919:                                             ; preds = %1913, %1915
  %1920 = phi i32 [ %1918, %1915 ], [ 0, %1913 ]
  %1921 = phi i32 [ 0, %1915 ], [ %1914, %1913 ]
  switch i32 %1921, label %2008 [
    i32 -2, label %1986
    i32 0, label %1986
  ], !prof !32

1922:                                             ; preds = %1986
  %1923 = sext i32 %1920 to i64
  br label %2008

1924:                                             ; preds = %1986, %1988
  %1925 = phi i64 [ %1990, %1988 ], [ 0, %1986 ]
  %1926 = phi i64 [ %1989, %1988 ], [ %1894, %1986 ]
  %1927 = icmp sgt i64 %1926, 0
  br i1 %1927, label %1988, label %1928

1928:                                             ; preds = %1924
  store ptr null, ptr %8, align 8, !noalias !107
  %1929 = call fastcc i32 @solve(ptr nonnull %8, ptr %214, i64 %211, i64 %213, ptr %226, i64 %225, ptr %262, i64 %261) #3, !noalias !107
  switch i32 %1929, label %2008 [
    i32 -2, label %2004
    i32 0, label %2004
  ], !prof !32

1930:                                             ; preds = %1895
  %1931 = add nsw i64 %1897, -1
  %1932 = add i64 %1896, 1
  %1933 = icmp slt i64 %1896, 0
  %1934 = select i1 %1933, i64 %237, i64 0
  %1935 = getelementptr double, ptr %238, i64 %1896
  %1936 = getelementptr double, ptr %1935, i64 %1934
  %1937 = load double, ptr %1936, align 8, !noalias !107
  %1938 = fmul double %1937, 0xC02418FD8BAFFE05
  %1939 = getelementptr double, ptr %238, i64 %237
  %1940 = getelementptr double, ptr %1939, i64 %1896
  %1941 = getelementptr double, ptr %1940, i64 %1934
  %1942 = load double, ptr %1941, align 8, !noalias !107
  %1943 = fmul double %1942, 0x3FF61D41B2D54580
  %1944 = fadd double %1938, %1943
  %1945 = shl i64 %237, 4
  %1946 = getelementptr i8, ptr %238, i64 %1945
  %1947 = getelementptr double, ptr %1946, i64 %1896
  %1948 = getelementptr double, ptr %1947, i64 %1934
  %1949 = load double, ptr %1948, align 8, !noalias !107
  %1950 = fmul double %1949, 0xBFD5555555555555
  %1951 = fadd double %1944, %1950
  %1952 = fdiv double %1951, %391
  %1953 = select i1 %1933, i64 %271, i64 0
  %1954 = getelementptr double, ptr %272, i64 %1896
  %1955 = getelementptr double, ptr %1954, i64 %1953
  store double %1952, ptr %1955, align 8, !noalias !107
  %1956 = select i1 %1933, i64 %84, i64 0
  %1957 = getelementptr double, ptr %85, i64 %1896
  %1958 = getelementptr double, ptr %1957, i64 %1956
  %1959 = load double, ptr %1958, align 8, !noalias !107
  %1960 = fadd double %1959, %1952
  %1961 = select i1 %1933, i64 %261, i64 0
  %1962 = getelementptr double, ptr %262, i64 %1896
  %1963 = getelementptr double, ptr %1962, i64 %1961
  store double %1960, ptr %1963, align 8, !noalias !107
  br label %1895

1964:                                             ; preds = %1899, %1899
  store double 0.000000e+00, ptr %7, align 8, !noalias !107
  %1965 = call fastcc i32 @norm(ptr nonnull %7, ptr %262, ptr %70, ptr %65, ptr nonnull %95, i64 %94, ptr %100, i64 %99, i64 %1893) #3, !noalias !107
  %1966 = load double, ptr %7, align 8, !noalias !107
  switch i32 %1965, label %2008 [
    i32 -2, label %1967
    i32 0, label %1967
  ], !prof !32

1967:                                             ; preds = %1964, %1964
  %1968 = fcmp olt double %1966, 1.000000e+00
  %1969 = select i1 %1968, i1 true, i1 %1892
  br i1 %1969, label %2008, label %1901

1970:                                             ; preds = %1901
  %1971 = add nsw i64 %1903, -1
  %1972 = add i64 %1902, 1
  %1973 = icmp slt i64 %1902, 0
  %1974 = select i1 %1973, i64 %64, i64 0
  %1975 = getelementptr double, ptr %65, i64 %1902
  %1976 = getelementptr double, ptr %1975, i64 %1974
  %1977 = load double, ptr %1976, align 8, !noalias !107
  %1978 = select i1 %1973, i64 %261, i64 0
  %1979 = getelementptr double, ptr %262, i64 %1902
  %1980 = getelementptr double, ptr %1979, i64 %1978
  %1981 = load double, ptr %1980, align 8, !noalias !107
  %1982 = fadd double %1977, %1981
  %1983 = select i1 %1973, i64 %74, i64 0
  %1984 = getelementptr double, ptr %75, i64 %1902
  %1985 = getelementptr double, ptr %1984, i64 %1983
  store double %1982, ptr %1985, align 8, !noalias !107
  br label %1901

1986:                                             ; preds = %1919, %1919
  %1987 = icmp eq i32 %1920, 0
  br i1 %1987, label %1924, label %1922

1988:                                             ; preds = %1924
  %1989 = add nsw i64 %1926, -1
  %1990 = add i64 %1925, 1
  %1991 = icmp slt i64 %1925, 0
  %1992 = select i1 %1991, i64 %249, i64 0
  %1993 = getelementptr double, ptr %250, i64 %1925
  %1994 = getelementptr double, ptr %1993, i64 %1992
  %1995 = load double, ptr %1994, align 8, !noalias !107
  %1996 = select i1 %1991, i64 %271, i64 0
  %1997 = getelementptr double, ptr %272, i64 %1925
  %1998 = getelementptr double, ptr %1997, i64 %1996
  %1999 = load double, ptr %1998, align 8, !noalias !107
  %2000 = fadd double %1995, %1999
  %2001 = select i1 %1991, i64 %261, i64 0
  %2002 = getelementptr double, ptr %262, i64 %1925
  %2003 = getelementptr double, ptr %2002, i64 %2001
  store double %2000, ptr %2003, align 8, !noalias !107
  br label %1924

2004:                                             ; preds = %1928, %1928
  store double 0.000000e+00, ptr %9, align 8, !noalias !107
  %2005 = call fastcc i32 @norm(ptr nonnull %9, ptr %262, ptr %70, ptr %65, ptr nonnull %95, i64 %94, ptr %100, i64 %99, i64 %1893) #3, !noalias !107
  switch i32 %2005, label %2008 [
    i32 -2, label %2006
    i32 0, label %2006
  ], !prof !32

2006:                                             ; preds = %2004, %2004
  %2007 = load double, ptr %9, align 8, !noalias !107
  br label %2008

2008:                                             ; preds = %2004, %1928, %1919, %1964, %1899, %1967, %1922, %2006
  %2009 = phi double [ %1966, %1967 ], [ 0.000000e+00, %1899 ], [ %1966, %1922 ], [ 0.000000e+00, %1964 ], [ 0.000000e+00, %1919 ], [ 0.000000e+00, %1928 ], [ %2007, %2006 ], [ 0.000000e+00, %2004 ]
  %2010 = phi i64 [ 0, %1967 ], [ 0, %1899 ], [ %1923, %1922 ], [ 0, %1964 ], [ 0, %1919 ], [ 0, %1928 ], [ 0, %2006 ], [ 0, %2004 ]
  %2011 = phi i32 [ 0, %1967 ], [ %1900, %1899 ], [ 0, %1922 ], [ %1965, %1964 ], [ %1921, %1919 ], [ %1929, %1928 ], [ 0, %2006 ], [ %2005, %2004 ]
  switch i32 %2011, label %2573 [
    i32 -2, label %2571
    i32 0, label %2571
  ], !prof !32

2012:                                             ; preds = %2571
  br label %2683

2013:                                             ; preds = %2571
  %2014 = add nsw i64 %1879, 12
  %2015 = sitofp i64 %2014 to double
  %2016 = fdiv double 0x4027666666666667, %2015
  %2017 = fcmp olt double %2009, 1.000000e-10
  %2018 = select i1 %2017, double 1.000000e-10, double %2009
  %2019 = call double @llvm.pow.f64(double %2018, double -2.500000e-01)
  %2020 = icmp eq i64 %2010, 0
  %2021 = fcmp olt double %2009, 1.000000e+00
  %2022 = select i1 %2020, i1 %2021, i1 false
  br i1 %2022, label %2023, label %2287

2023:                                             ; preds = %2013
  br i1 %275, label %2024, label %2038

2024:                                             ; preds = %2023
  %2025 = getelementptr i8, ptr %157, i64 56
  %2026 = load i64, ptr %2025, align 8, !noalias !12
  %2027 = inttoptr i64 %2026 to ptr
  %2028 = call i64 %2027(i64 %0, double %392, i64 %67) #3, !noalias !12
  %2029 = icmp eq i64 %2028, 0
  br i1 %2029, label %2038, label %2030

2030:                                             ; preds = %2024
  %2031 = load i64, ptr %374, align 8, !noalias !12
  %2032 = add nsw i64 %2031, 1
  store i64 %2032, ptr %374, align 8, !noalias !12
  %2033 = fmul double %391, 2.500000e-01
  %2034 = getelementptr i8, ptr %110, i64 72
  store i64 6, ptr %2034, align 8, !noalias !12
  %2035 = getelementptr i8, ptr %196, i64 16
  %2036 = load i64, ptr %2035, align 8, !noalias !12
  %2037 = sub nsw i64 1, %2036
  store i64 1, ptr %1890, align 8, !noalias !12
  store i64 %2037, ptr %399, align 8, !noalias !12
  br label %2361

2038:                                             ; preds = %2024, %2023
  %2039 = load i64, ptr %372, align 8, !noalias !12
  %2040 = add nsw i64 %2039, 1
  store i64 %2040, ptr %372, align 8, !noalias !12
  %2041 = getelementptr i8, ptr %105, i64 24
  %2042 = load double, ptr %2041, align 8, !noalias !12
  %2043 = fcmp ogt double %2042, 0.000000e+00
  br i1 %2043, label %2044, label %2054

2044:                                             ; preds = %2038
  %2045 = getelementptr i8, ptr %105, i64 32
  %2046 = load double, ptr %2045, align 8, !noalias !12
  %2047 = fdiv double %391, %2046
  %2048 = fdiv double %2042, %2018
  %2049 = call double @llvm.pow.f64(double %2048, double 2.500000e-01)
  %2050 = fmul double %2047, %2049
  %2051 = fcmp olt double %2050, 1.000000e+00
  %2052 = select i1 %2051, double %2050, double 1.000000e+00
  %2053 = fmul double %2019, %2052
  br label %2054

2054:                                             ; preds = %2044, %2038
  %2055 = phi double [ %2053, %2044 ], [ %2019, %2038 ]
  %2056 = fmul double %2016, %2055
  %2057 = fcmp olt double %2056, 1.000000e+01
  %2058 = select i1 %2057, double %2056, double 1.000000e+01
  store double %392, ptr %105, align 8, !noalias !12
  %2059 = getelementptr i8, ptr %105, i64 32
  store double %391, ptr %2059, align 8, !noalias !12
  store double %2018, ptr %2041, align 8, !noalias !12
  br label %2060

2060:                                             ; preds = %2064, %2054
  %2061 = phi i64 [ 0, %2054 ], [ %2576, %2064 ]
  %2062 = phi i64 [ %282, %2054 ], [ %2575, %2064 ]
  %2063 = icmp sgt i64 %2062, 0
  br i1 %2063, label %2574, label %2068

2064:                                             ; preds = %2574, %2631
  %2065 = phi i64 [ 0, %2574 ], [ %2633, %2631 ]
  %2066 = phi i64 [ 3, %2574 ], [ %2632, %2631 ]
  %2067 = icmp sgt i64 %2066, 0
  br i1 %2067, label %2631, label %2060

2068:                                             ; preds = %2060
  store double %391, ptr %772, align 8, !noalias !12
  %2069 = getelementptr i8, ptr %160, i64 8
  %2070 = load i64, ptr %2069, align 8, !noalias !12
  %2071 = icmp sgt i64 %2070, 0
  br i1 %2071, label %2081, label %2072

2072:                                             ; preds = %2068
  %2073 = getelementptr i8, ptr %110, i64 48
  %2074 = load i64, ptr %2073, align 8, !noalias !12
  %2075 = icmp slt i64 %2074, 0
  %2076 = select i1 %2075, i64 %114, i64 0
  %2077 = getelementptr double, ptr %115, i64 %2074
  %2078 = getelementptr double, ptr %2077, i64 %2076
  %2079 = load double, ptr %2078, align 8, !noalias !12
  %2080 = fcmp ugt double %2079, %392
  br i1 %2080, label %2242, label %2088

2081:                                             ; preds = %2068
  %2082 = getelementptr i8, ptr %160, i64 16
  %2083 = load i64, ptr %2082, align 8, !noalias !12
  %2084 = inttoptr i64 %2083 to ptr
  %2085 = call i64 %2084(i64 %0, double %366, double %391) #3, !noalias !12
  %2086 = getelementptr i8, ptr %105, i64 48
  %2087 = load double, ptr %2086, align 8, !noalias !12
  br label %2088

2088:                                             ; preds = %2072, %2081
  %2089 = phi double [ %2087, %2081 ], [ 1.000000e+00, %2072 ]
  %2090 = phi i64 [ %2085, %2081 ], [ 0, %2072 ]
  %2091 = fcmp oeq double %2089, 1.000000e+00
  br i1 %2091, label %2092, label %2094

2092:                                             ; preds = %2088
  %2093 = load double, ptr %105, align 8, !noalias !12
  br label %2097

2094:                                             ; preds = %2088
  %2095 = fmul double %2089, %391
  %2096 = fadd double %366, %2095
  br label %2097

2097:                                             ; preds = %2094, %2092
  %2098 = phi double [ %2093, %2092 ], [ %2096, %2094 ]
  %2099 = icmp eq i64 %2090, -4
  %2100 = select i1 %2099, i64 -4, i64 0
  br i1 %2099, label %2154, label %2101

2101:                                             ; preds = %2097
  %2102 = fcmp uge double %2089, 1.000000e+00
  %2103 = load i64, ptr %116, align 8, !noalias !12
  %2104 = load i64, ptr %157, align 8, !noalias !12
  %2105 = icmp eq i64 %2104, 1
  %2106 = getelementptr i8, ptr %110, i64 48
  %2107 = load i64, ptr %2106, align 8, !noalias !12
  %2108 = icmp slt i64 %2107, %114
  br i1 %2108, label %2109, label %2152

2109:                                             ; preds = %2101
  %2110 = icmp slt i64 %2107, 0
  %2111 = select i1 %2110, i64 %114, i64 0
  %2112 = getelementptr double, ptr %115, i64 %2107
  %2113 = getelementptr double, ptr %2112, i64 %2111
  %2114 = load double, ptr %2113, align 8, !noalias !12
  %2115 = fcmp uge double %2114, %2098
  %2116 = fcmp une double %2114, %2098
  %2117 = or i1 %2116, %2102
  %2118 = and i1 %2115, %2117
  br i1 %2118, label %2152, label %2119

2119:                                             ; preds = %2142, %2109
  %2120 = phi i64 [ %2107, %2109 ], [ %2140, %2142 ]
  %2121 = icmp slt i64 %2120, 0
  %2122 = select i1 %2121, i64 %114, i64 0
  %2123 = getelementptr double, ptr %115, i64 %2120
  %2124 = getelementptr double, ptr %2123, i64 %2122
  %2125 = load double, ptr %2124, align 8, !noalias !12
  %2126 = fsub double %2125, %366
  %2127 = fdiv double %2126, %391
  %2128 = mul nsw i64 %2120, %2103
  %2129 = shl i64 %2128, 3
  %2130 = add i64 %2129, %1
  %2131 = call i64 @llvm.smax.i64(i64 %79, i64 0)
  br label %2648

2132:                                             ; preds = %2652
  %2133 = getelementptr i8, ptr %157, i64 56
  %2134 = load i64, ptr %2133, align 8, !noalias !12
  %2135 = load double, ptr %2124, align 8, !noalias !12
  %2136 = inttoptr i64 %2134 to ptr
  %2137 = call i64 %2136(i64 %0, double %2135, i64 %2130) #3, !noalias !12
  %2138 = icmp eq i64 %2137, 0
  br i1 %2138, label %2139, label %2154

2139:                                             ; preds = %2652, %2132
  %2140 = add nsw i64 %2120, 1
  %2141 = icmp slt i64 %2140, %114
  br i1 %2141, label %2142, label %2152

2142:                                             ; preds = %2139
  %2143 = icmp slt i64 %2120, -1
  %2144 = select i1 %2143, i64 %114, i64 0
  %2145 = getelementptr double, ptr %115, i64 %2140
  %2146 = getelementptr double, ptr %2145, i64 %2144
  %2147 = load double, ptr %2146, align 8, !noalias !12
  %2148 = fcmp uge double %2147, %2098
  %2149 = fcmp une double %2147, %2098
  %2150 = or i1 %2149, %2102
  %2151 = and i1 %2148, %2150
  br i1 %2151, label %2152, label %2119

2152:                                             ; preds = %2142, %2109, %2139, %2101
  %2153 = phi i64 [ %2107, %2109 ], [ %2140, %2142 ], [ %2140, %2139 ], [ %2107, %2101 ]
  store i64 %2153, ptr %2106, align 8, !noalias !12
  br label %2154

2154:                                             ; preds = %2132, %2152, %2097
  %2155 = phi i64 [ %2100, %2097 ], [ 0, %2152 ], [ %2137, %2132 ]
  %2156 = icmp eq i64 %2155, 0
  %2157 = icmp ne i64 %2090, 0
  %2158 = select i1 %2156, i1 %2157, i1 false
  %2159 = fcmp olt double %2089, 1.000000e+00
  %2160 = and i1 %2158, %2159
  br i1 %2160, label %2161, label %2200

2161:                                             ; preds = %2154
  %2162 = call i64 @llvm.smax.i64(i64 %79, i64 0)
  br label %2163

2163:                                             ; preds = %2161, %2188
  %2164 = phi i64 [ 0, %2161 ], [ %2190, %2188 ]
  %2165 = phi i64 [ %2162, %2161 ], [ %2189, %2188 ]
  %2166 = icmp sgt i64 %2165, 0
  br i1 %2166, label %2188, label %2167

2167:                                             ; preds = %2163
  %2168 = getelementptr i8, ptr %27, i64 24
  %2169 = load i64, ptr %2168, align 8, !noalias !119
  %2170 = getelementptr i8, ptr %30, i64 16
  %2171 = load i64, ptr %2170, align 8, !noalias !119
  call fastcc void @pydy_nested(i64 %72, i64 %62, i64 %87, i64 %64, i64 %2169, i64 %77, i64 %2171) #3, !noalias !119
  %2172 = call i64 @llvm.smax.i64(i64 %69, i64 0)
  br label %2173

2173:                                             ; preds = %2177, %2167
  %2174 = phi i64 [ 0, %2167 ], [ %2179, %2177 ]
  %2175 = phi i64 [ %2172, %2167 ], [ %2178, %2177 ]
  %2176 = icmp sgt i64 %2175, 0
  br i1 %2176, label %2177, label %2664

2177:                                             ; preds = %2173
  %2178 = add nsw i64 %2175, -1
  %2179 = add i64 %2174, 1
  %2180 = icmp slt i64 %2174, 0
  %2181 = select i1 %2180, i64 %74, i64 0
  %2182 = getelementptr double, ptr %75, i64 %2174
  %2183 = getelementptr double, ptr %2182, i64 %2181
  %2184 = load double, ptr %2183, align 8, !noalias !123
  %2185 = select i1 %2180, i64 %69, i64 0
  %2186 = getelementptr double, ptr %70, i64 %2174
  %2187 = getelementptr double, ptr %2186, i64 %2185
  store double %2184, ptr %2187, align 8, !noalias !123
  br label %2173

2188:                                             ; preds = %2163
  %2189 = add nsw i64 %2165, -1
  %2190 = add i64 %2164, 1
  %2191 = icmp slt i64 %2164, 0
  %2192 = select i1 %2191, i64 %79, i64 0
  %2193 = getelementptr double, ptr %80, i64 %2164
  %2194 = getelementptr double, ptr %2193, i64 %2192
  store double %2089, ptr %2194, align 8, !noalias !119
  br label %2163

2195:                                             ; preds = %2664
  %2196 = getelementptr i8, ptr %157, i64 56
  %2197 = load i64, ptr %2196, align 8, !noalias !12
  %2198 = inttoptr i64 %2197 to ptr
  %2199 = call i64 %2198(i64 %0, double %2098, i64 %67) #3, !noalias !12
  br label %2200

2200:                                             ; preds = %2664, %2195, %2154
  %2201 = phi i64 [ %2199, %2195 ], [ 0, %2664 ], [ %2155, %2154 ]
  %2202 = icmp eq i64 %2201, 0
  br i1 %2202, label %2204, label %2203

2203:                                             ; preds = %2200
  store double %366, ptr %105, align 8, !noalias !12
  store double %391, ptr %298, align 8, !noalias !12
  br label %2226

2204:                                             ; preds = %2200
  br i1 %2091, label %2205, label %2207

2205:                                             ; preds = %2204
  store i8 0, ptr %24, align 1, !noalias !12
  %2206 = call fastcc i32 @write_reached(ptr nonnull %24, ptr %30, ptr %70, i64 %69, ptr nonnull %105, ptr nonnull %110, i64 %114, ptr %115, i64 %114, ptr %119, i64 %118) #3
  switch i32 %2206, label %2667 [
    i32 -2, label %2207
    i32 0, label %2207
  ], !prof !32

2207:                                             ; preds = %2205, %2205, %2204
  %2208 = icmp eq i64 %2090, 0
  br i1 %2208, label %2226, label %2209

2209:                                             ; preds = %2207
  %2210 = call i64 @llvm.smax.i64(i64 %64, i64 0)
  br label %2211

2211:                                             ; preds = %2215, %2209
  %2212 = phi i64 [ 0, %2209 ], [ %2217, %2215 ]
  %2213 = phi i64 [ %2210, %2209 ], [ %2216, %2215 ]
  %2214 = icmp sgt i64 %2213, 0
  br i1 %2214, label %2215, label %2668

2215:                                             ; preds = %2211
  %2216 = add nsw i64 %2213, -1
  %2217 = add i64 %2212, 1
  %2218 = icmp slt i64 %2212, 0
  %2219 = select i1 %2218, i64 %69, i64 0
  %2220 = getelementptr double, ptr %70, i64 %2212
  %2221 = getelementptr double, ptr %2220, i64 %2219
  %2222 = load double, ptr %2221, align 8, !noalias !126
  %2223 = select i1 %2218, i64 %64, i64 0
  %2224 = getelementptr double, ptr %65, i64 %2212
  %2225 = getelementptr double, ptr %2224, i64 %2223
  store double %2222, ptr %2225, align 8, !noalias !126
  br label %2211

2226:                                             ; preds = %2207, %2668, %2203
  %2227 = phi i64 [ %2201, %2203 ], [ %2090, %2668 ], [ 0, %2207 ]
  switch i64 %2227, label %2241 [
    i64 6, label %2228
    i64 0, label %2242
  ]

2228:                                             ; preds = %2226
  %2229 = load i64, ptr %2069, align 8, !noalias !12
  %2230 = icmp eq i64 %2229, 0
  br i1 %2230, label %2231, label %2241

2231:                                             ; preds = %2228
  %2232 = load i64, ptr %372, align 8, !noalias !12
  %2233 = add nsw i64 %2232, -1
  store i64 %2233, ptr %372, align 8, !noalias !12
  %2234 = load i64, ptr %374, align 8, !noalias !12
  %2235 = add nsw i64 %2234, 1
  store i64 %2235, ptr %374, align 8, !noalias !12
  %2236 = fmul double %391, 2.500000e-01
  %2237 = getelementptr i8, ptr %110, i64 72
  store i64 6, ptr %2237, align 8, !noalias !12
  %2238 = getelementptr i8, ptr %196, i64 16
  %2239 = load i64, ptr %2238, align 8, !noalias !12
  %2240 = sub nsw i64 1, %2239
  store i64 1, ptr %1890, align 8, !noalias !12
  store i64 %2240, ptr %399, align 8, !noalias !12
  store double 0.000000e+00, ptr %772, align 8, !noalias !12
  br label %2361

2241:                                             ; preds = %2228, %2226
  br label %2683

2242:                                             ; preds = %2226, %2072
  br label %2243

2243:                                             ; preds = %2242, %2669
  %2244 = phi i64 [ 0, %2242 ], [ %2671, %2669 ]
  %2245 = phi i64 [ %282, %2242 ], [ %2670, %2669 ]
  %2246 = icmp sgt i64 %2245, 0
  br i1 %2246, label %2669, label %2247

2247:                                             ; preds = %2243
  %2248 = getelementptr i8, ptr %110, i64 24
  %2249 = load i64, ptr %2248, align 8, !noalias !12
  %2250 = add nsw i64 %2249, 1
  store i64 %2250, ptr %2248, align 8, !noalias !12
  store ptr null, ptr %15, align 8, !noalias !129
  store ptr null, ptr %16, align 8, !noalias !129
  store double %392, ptr %33, align 8, !noalias !129
  %2251 = icmp sgt i64 %45, 0
  br i1 %2251, label %2252, label %2255

2252:                                             ; preds = %2247
  store ptr null, ptr %15, align 8, !noalias !129
  %2253 = call fastcc i32 @_sample(ptr nonnull %15, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %392) #3
  switch i32 %2253, label %2254 [
    i32 -2, label %2255
    i32 0, label %2255
  ], !prof !32

2254:                                             ; preds = %2252
  br label %2255

2255:                                             ; preds = %2252, %2252, %2247, %2254
  %2256 = phi i32 [ %2253, %2254 ], [ 0, %2247 ], [ 0, %2252 ], [ 0, %2252 ]
  switch i32 %2256, label %2261 [
    i32 -2, label %2257
    i32 0, label %2257
  ], !prof !32

2257:                                             ; preds = %2255, %2255
  %2258 = load i64, ptr %30, align 8, !noalias !136
  %2259 = inttoptr i64 %2258 to ptr
  %2260 = call i32 %2259(ptr nonnull %33, ptr %65, ptr %38, ptr %41, ptr %85) #3, !noalias !136
  br label %2261

2261:                                             ; preds = %2255, %2257
  %2262 = phi i32 [ %2260, %2257 ], [ 0, %2255 ]
  %2263 = phi i32 [ 0, %2257 ], [ %2256, %2255 ]
  switch i32 %2263, label %2682 [
    i32 -2, label %2680
    i32 0, label %2680
  ], !prof !32

2264:                                             ; preds = %2680
  %2265 = getelementptr i8, ptr %110, i64 72
  store i64 3, ptr %2265, align 8, !noalias !12
  store double %391, ptr %298, align 8, !noalias !12
  %2266 = icmp slt i32 %2262, 0
  %2267 = select i1 %2266, i64 -4, i64 2
  br label %2683

2268:                                             ; preds = %2680
  %2269 = icmp sgt i64 %1879, 2
  %2270 = fcmp ogt double %1878, 1.000000e-03
  %2271 = select i1 %2269, i1 %2270, i1 false
  %2272 = zext i1 %2271 to i64
  store i64 %2272, ptr %399, align 8, !noalias !12
  %2273 = getelementptr i8, ptr %196, i64 16
  store i64 0, ptr %2273, align 8, !noalias !12
  store i64 0, ptr %1890, align 8, !noalias !12
  %2274 = fcmp ule double %2058, 1.000000e+00
  %2275 = fcmp uge double %2058, 1.200000e+00
  %2276 = or i1 %2274, %2275
  %2277 = select i1 %2276, i1 true, i1 %2271
  br i1 %2277, label %2278, label %2282

2278:                                             ; preds = %2268
  %2279 = fcmp ogt double %2058, 2.000000e-01
  %2280 = select i1 %2279, double %2058, double 2.000000e-01
  %2281 = fmul double %391, %2280
  br label %2282

2282:                                             ; preds = %2268, %2278
  %2283 = phi double [ %2281, %2278 ], [ %391, %2268 ]
  %2284 = getelementptr i8, ptr %110, i64 48
  %2285 = load i64, ptr %2284, align 8, !noalias !12
  %2286 = icmp eq i64 %2285, %114
  br i1 %2286, label %2364, label %364

2287:                                             ; preds = %2013
  %2288 = load i64, ptr %374, align 8, !noalias !12
  %2289 = add nsw i64 %2288, 1
  store i64 %2289, ptr %374, align 8, !noalias !12
  %2290 = select i1 %2020, i64 2, i64 3
  %2291 = getelementptr i8, ptr %110, i64 72
  store i64 %2290, ptr %2291, align 8, !noalias !12
  %2292 = fsub double %2009, %2009
  %2293 = fcmp ord double %2292, 0.000000e+00
  br i1 %2293, label %2294, label %2298

2294:                                             ; preds = %2287
  %2295 = fmul double %2016, %2019
  %2296 = fcmp ogt double %2295, 2.000000e-01
  %2297 = select i1 %2296, double %2295, double 2.000000e-01
  br label %2298

2298:                                             ; preds = %2294, %2287
  %2299 = phi double [ 2.500000e-01, %2287 ], [ %2297, %2294 ]
  %2300 = fmul double %391, %2299
  %2301 = getelementptr i8, ptr %196, i64 16
  %2302 = load i64, ptr %2301, align 8, !noalias !12
  %2303 = sub nsw i64 1, %2302
  store i64 1, ptr %1890, align 8, !noalias !12
  store i64 %2303, ptr %399, align 8, !noalias !12
  br label %2361

2304:                                             ; preds = %1884
  %2305 = load i64, ptr %374, align 8, !noalias !12
  %2306 = add nsw i64 %2305, 1
  store i64 %2306, ptr %374, align 8, !noalias !12
  %2307 = icmp eq i64 %1881, 0
  br i1 %2307, label %2310, label %2308

2308:                                             ; preds = %2304
  %2309 = getelementptr i8, ptr %110, i64 72
  store i64 3, ptr %2309, align 8, !noalias !12
  br label %2317

2310:                                             ; preds = %2304
  %2311 = fsub double %1878, %1878
  %2312 = fcmp ord double %2311, 0.000000e+00
  br i1 %2312, label %2313, label %2315

2313:                                             ; preds = %2310
  %2314 = getelementptr i8, ptr %110, i64 72
  store i64 7, ptr %2314, align 8, !noalias !12
  br label %2317

2315:                                             ; preds = %2310
  %2316 = getelementptr i8, ptr %110, i64 72
  store i64 4, ptr %2316, align 8, !noalias !12
  br label %2317

2317:                                             ; preds = %2315, %2313, %2308
  %2318 = getelementptr i8, ptr %196, i64 16
  %2319 = load i64, ptr %2318, align 8, !noalias !12
  %2320 = icmp eq i64 %2319, 1
  %2321 = and i1 %2320, %2307
  br i1 %2321, label %2322, label %2349

2322:                                             ; preds = %2317
  %2323 = call i64 @llvm.smax.i64(i64 %206, i64 0)
  br label %2324

2324:                                             ; preds = %2336, %2322
  %2325 = phi i64 [ 0, %2322 ], [ %2344, %2336 ]
  %2326 = phi i64 [ %2323, %2322 ], [ %2343, %2336 ]
  %2327 = phi i1 [ false, %2322 ], [ %2337, %2336 ]
  %2328 = icmp sgt i64 %2326, 0
  br i1 %2328, label %2342, label %2345

2329:                                             ; preds = %2342
  %2330 = icmp slt i64 %2325, 0
  %2331 = select i1 %2330, i64 %206, i64 0
  %2332 = getelementptr double, ptr %207, i64 %2325
  %2333 = getelementptr double, ptr %2332, i64 %2331
  %2334 = load double, ptr %2333, align 8, !noalias !137
  %2335 = fcmp une double %2334, 0.000000e+00
  br label %2336

2336:                                             ; preds = %2342, %2329
  %2337 = phi i1 [ true, %2342 ], [ %2335, %2329 ]
  %2338 = icmp slt i64 %2325, 0
  %2339 = select i1 %2338, i64 %206, i64 0
  %2340 = getelementptr double, ptr %207, i64 %2325
  %2341 = getelementptr double, ptr %2340, i64 %2339
  store double 0.000000e+00, ptr %2341, align 8, !noalias !137
  br label %2324

2342:                                             ; preds = %2324
  %2343 = add nsw i64 %2326, -1
  %2344 = add i64 %2325, 1
  br i1 %2327, label %2336, label %2329

2345:                                             ; preds = %2324
  br i1 %2327, label %2346, label %2347

2346:                                             ; preds = %2345
  store i64 0, ptr %450, align 8, !noalias !12
  br label %2361

2347:                                             ; preds = %2345
  store i64 0, ptr %2318, align 8, !noalias !12
  %2348 = fmul double %391, 5.000000e-01
  br label %2349

2349:                                             ; preds = %2347, %2317
  %2350 = phi double [ %2348, %2347 ], [ %365, %2317 ]
  %2351 = load i64, ptr %2318, align 8, !noalias !12
  %2352 = icmp ne i64 %2351, 1
  %2353 = and i1 %2352, %2307
  br i1 %2353, label %2357, label %2354

2354:                                             ; preds = %2349
  %2355 = select i1 %2307, double 5.000000e-01, double 2.500000e-01
  %2356 = fmul double %391, %2355
  store double 0.000000e+00, ptr %772, align 8, !noalias !12
  br label %2357

2357:                                             ; preds = %2349, %2354
  %2358 = phi double [ %2356, %2354 ], [ %2350, %2349 ]
  %2359 = load i64, ptr %2318, align 8, !noalias !12
  %2360 = sub nsw i64 1, %2359
  store i64 %2360, ptr %399, align 8, !noalias !12
  br label %2361

2361:                                             ; preds = %2357, %2346, %2298, %2231, %2030, %763
  %2362 = phi double [ %2300, %2298 ], [ %2033, %2030 ], [ %2236, %2231 ], [ %365, %2346 ], [ %2358, %2357 ], [ %766, %763 ]
  br label %361

2363:                                             ; preds = %381
  store double %391, ptr %298, align 8, !noalias !12
  br label %2683

2364:                                             ; preds = %2282
  store double %2283, ptr %298, align 8, !noalias !12
  br label %2683

2365:                                             ; preds = %283
  %2366 = icmp slt i64 %284, 0
  %2367 = select i1 %2366, i64 %94, i64 0
  %2368 = getelementptr double, ptr %95, i64 %284
  %2369 = getelementptr double, ptr %2368, i64 %2367
  %2370 = load double, ptr %2369, align 8, !noalias !12
  %2371 = fcmp olt double %2370, %286
  %2372 = select i1 %2371, double %2370, double %286
  %2373 = add i64 %284, 1
  %2374 = add nsw i64 %285, -1
  br label %283

2375:                                             ; preds = %316, %316
  %2376 = icmp eq i32 %317, 0
  br i1 %2376, label %323, label %319

2377:                                             ; preds = %316
  br label %2683

2378:                                             ; preds = %323, %323
  %2379 = load i8, ptr %23, align 1, !noalias !12
  %2380 = icmp eq i8 %2379, 0
  br i1 %2380, label %330, label %329

2381:                                             ; preds = %323
  br label %2683

2382:                                             ; preds = %337, %332
  br label %2683

2383:                                             ; preds = %414, %414
  %2384 = load i64, ptr %196, align 8, !noalias !12
  %2385 = inttoptr i64 %2384 to ptr
  %2386 = call i32 %2385(ptr nonnull %33, ptr %65, ptr %38, ptr %202, ptr %207) #3, !noalias !12
  %2387 = sext i32 %2386 to i64
  br label %434

2388:                                             ; preds = %414
  br label %2683

2389:                                             ; preds = %418
  %2390 = add nsw i64 %420, -1
  %2391 = add i64 %419, 1
  %2392 = icmp slt i64 %419, 0
  %2393 = select i1 %2392, i64 %64, i64 0
  %2394 = getelementptr double, ptr %65, i64 %419
  %2395 = getelementptr double, ptr %2394, i64 %2393
  %2396 = load double, ptr %2395, align 8, !noalias !12
  %2397 = select i1 %2392, i64 %74, i64 0
  %2398 = getelementptr double, ptr %75, i64 %419
  %2399 = getelementptr double, ptr %2398, i64 %2397
  store double %2396, ptr %2399, align 8, !noalias !12
  br label %418

2400:                                             ; preds = %422
  %2401 = add nsw i64 %424, -1
  %2402 = add i64 %423, 1
  %2403 = icmp slt i64 %423, 0
  %2404 = select i1 %2403, i64 %64, i64 0
  %2405 = getelementptr double, ptr %65, i64 %423
  %2406 = getelementptr double, ptr %2405, i64 %2404
  %2407 = load double, ptr %2406, align 8, !noalias !12
  %2408 = call double @llvm.fabs.f64(double %2407)
  %2409 = fcmp olt double %2408, 1.000000e-05
  %2410 = select i1 %2409, double 1.000000e-05, double %2408
  %2411 = fmul double %2410, 1.500000e-08
  %2412 = fadd double %2407, %2411
  %2413 = fsub double %2412, %2407
  %2414 = select i1 %2403, i64 %74, i64 0
  %2415 = getelementptr double, ptr %75, i64 %423
  %2416 = getelementptr double, ptr %2415, i64 %2414
  store double %2412, ptr %2416, align 8, !noalias !12
  %2417 = getelementptr i8, ptr %110, i64 24
  %2418 = load i64, ptr %2417, align 8, !noalias !12
  %2419 = add nsw i64 %2418, 1
  store i64 %2419, ptr %2417, align 8, !noalias !12
  store ptr null, ptr %17, align 8, !noalias !140
  store ptr null, ptr %18, align 8, !noalias !140
  store double %366, ptr %33, align 8, !noalias !140
  %2420 = icmp sgt i64 %45, 0
  br i1 %2420, label %2421, label %2424

2421:                                             ; preds = %2400
  store ptr null, ptr %17, align 8, !noalias !140
  %2422 = call fastcc i32 @_sample(ptr nonnull %17, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %366) #3
  switch i32 %2422, label %2423 [
    i32 -2, label %2424
    i32 0, label %2424
  ], !prof !32

2423:                                             ; preds = %2421
  br label %2424

2424:                                             ; preds = %2421, %2421, %2400, %2423
  %2425 = phi i32 [ %2422, %2423 ], [ 0, %2400 ], [ 0, %2421 ], [ 0, %2421 ]
  switch i32 %2425, label %2430 [
    i32 -2, label %2426
    i32 0, label %2426
  ], !prof !32

2426:                                             ; preds = %2424, %2424
  %2427 = load i64, ptr %30, align 8, !noalias !147
  %2428 = inttoptr i64 %2427 to ptr
  %2429 = call i32 %2428(ptr nonnull %33, ptr %75, ptr %38, ptr %41, ptr %70) #3, !noalias !147
  br label %2430

2430:                                             ; preds = %2424, %2426
  %2431 = phi i32 [ %2429, %2426 ], [ 0, %2424 ]
  %2432 = phi i32 [ 0, %2426 ], [ %2425, %2424 ]
  switch i32 %2432, label %2435 [
    i32 -2, label %2433
    i32 0, label %2433
  ], !prof !32

2433:                                             ; preds = %2430, %2430
  %2434 = icmp eq i32 %2431, 0
  br i1 %2434, label %428, label %426

2435:                                             ; preds = %2430
  br label %2683

2436:                                             ; preds = %428
  %2437 = add nsw i64 %430, -1
  %2438 = add i64 %429, 1
  %2439 = icmp slt i64 %429, 0
  %2440 = select i1 %2439, i64 %69, i64 0
  %2441 = getelementptr double, ptr %70, i64 %429
  %2442 = getelementptr double, ptr %2441, i64 %2440
  %2443 = load double, ptr %2442, align 8, !noalias !12
  %2444 = select i1 %2439, i64 %84, i64 0
  %2445 = getelementptr double, ptr %85, i64 %429
  %2446 = getelementptr double, ptr %2445, i64 %2444
  %2447 = load double, ptr %2446, align 8, !noalias !12
  %2448 = fsub double %2443, %2447
  %2449 = fdiv double %2448, %2413
  %2450 = mul nsw i64 %429, %406
  %2451 = add nsw i64 %2450, %423
  %2452 = icmp slt i64 %2451, 0
  %2453 = select i1 %2452, i64 %206, i64 0
  %2454 = getelementptr double, ptr %207, i64 %2451
  %2455 = getelementptr double, ptr %2454, i64 %2453
  store double %2449, ptr %2455, align 8, !noalias !12
  br label %428

2456:                                             ; preds = %437
  %2457 = add nsw i64 %439, -1
  %2458 = add i64 %438, 1
  %2459 = icmp slt i64 %438, 0
  %2460 = select i1 %2459, i64 %206, i64 0
  %2461 = getelementptr double, ptr %207, i64 %438
  %2462 = getelementptr double, ptr %2461, i64 %2460
  %2463 = load double, ptr %2462, align 8, !noalias !12
  %2464 = fsub double %2463, %2463
  %2465 = fcmp ord double %2464, 0.000000e+00
  br i1 %2465, label %442, label %441

2466:                                             ; preds = %461
  %2467 = add nsw i64 %463, -1
  %2468 = add i64 %462, 1
  br label %465

2469:                                             ; preds = %465
  %2470 = add nsw i64 %467, -1
  %2471 = add i64 %466, 1
  %2472 = mul nsw i64 %462, %225
  %2473 = add nsw i64 %2472, %466
  %2474 = icmp slt i64 %2473, 0
  %2475 = select i1 %2474, i64 %206, i64 0
  %2476 = getelementptr double, ptr %207, i64 %2473
  %2477 = getelementptr double, ptr %2476, i64 %2475
  %2478 = load double, ptr %2477, align 8, !noalias !12
  %2479 = fneg double %2478
  %2480 = icmp slt i64 %462, 0
  %2481 = select i1 %2480, i64 %211, i64 0
  %2482 = add i64 %462, %2481
  %2483 = icmp slt i64 %466, 0
  %2484 = select i1 %2483, i64 %213, i64 0
  %2485 = mul i64 %2482, %213
  %2486 = getelementptr double, ptr %214, i64 %2485
  %2487 = getelementptr double, ptr %2486, i64 %466
  %2488 = getelementptr double, ptr %2487, i64 %2484
  store double %2479, ptr %2488, align 8, !noalias !12
  %2489 = load double, ptr %2477, align 8, !noalias !12
  %2490 = fneg double %2489
  %2491 = select i1 %2480, i64 %218, i64 0
  %2492 = add i64 %462, %2491
  %2493 = select i1 %2483, i64 %220, i64 0
  %2494 = mul i64 %2492, %220
  %2495 = getelementptr { double, double }, ptr %221, i64 %2494
  %2496 = getelementptr { double, double }, ptr %2495, i64 %466
  %2497 = getelementptr { double, double }, ptr %2496, i64 %2493
  store double %2490, ptr %2497, align 8, !noalias !12
  %2498 = getelementptr inbounds nuw i8, ptr %2497, i64 8
  store double 0.000000e+00, ptr %2498, align 8, !noalias !12
  br label %465

2499:                                             ; preds = %774
  %2500 = add nsw i64 %776, -1
  %2501 = add i64 %775, 1
  %2502 = fcmp ogt double %773, 0.000000e+00
  br i1 %2502, label %778, label %787

2503:                                             ; preds = %789
  %2504 = add nsw i64 %791, -1
  %2505 = add i64 %790, 1
  br i1 %2502, label %793, label %833

2506:                                             ; preds = %843
  %2507 = add nsw i64 %845, -1
  %2508 = add i64 %844, 1
  br label %847

2509:                                             ; preds = %847
  %2510 = add nsw i64 %849, -1
  %2511 = add i64 %848, 1
  %2512 = icmp slt i64 %844, 0
  %2513 = add i64 %844, 3
  %2514 = select i1 %2512, i64 %2513, i64 %844
  %2515 = mul i64 %2514, 24
  %2516 = getelementptr i8, ptr @1, i64 %2515
  %2517 = load double, ptr %2516, align 8, !noalias !12
  %2518 = icmp slt i64 %848, 0
  %2519 = select i1 %2518, i64 %237, i64 0
  %2520 = getelementptr double, ptr %238, i64 %848
  %2521 = getelementptr double, ptr %2520, i64 %2519
  %2522 = load double, ptr %2521, align 8, !noalias !12
  %2523 = fmul double %2517, %2522
  %2524 = getelementptr i8, ptr @2, i64 %2515
  %2525 = getelementptr i8, ptr %2524, i64 8
  %2526 = load double, ptr %2525, align 8, !noalias !12
  %2527 = getelementptr double, ptr %238, i64 %237
  %2528 = getelementptr double, ptr %2527, i64 %848
  %2529 = getelementptr double, ptr %2528, i64 %2519
  %2530 = load double, ptr %2529, align 8, !noalias !12
  %2531 = fmul double %2526, %2530
  %2532 = fadd double %2523, %2531
  %2533 = getelementptr i8, ptr @3, i64 %2515
  %2534 = getelementptr i8, ptr %2533, i64 16
  %2535 = load double, ptr %2534, align 8, !noalias !12
  %2536 = shl i64 %237, 4
  %2537 = getelementptr i8, ptr %238, i64 %2536
  %2538 = getelementptr double, ptr %2537, i64 %848
  %2539 = getelementptr double, ptr %2538, i64 %2519
  %2540 = load double, ptr %2539, align 8, !noalias !12
  %2541 = fmul double %2535, %2540
  %2542 = fadd double %2532, %2541
  %2543 = select i1 %2512, i64 %242, i64 0
  %2544 = add i64 %844, %2543
  %2545 = select i1 %2518, i64 %244, i64 0
  %2546 = mul i64 %2544, %244
  %2547 = getelementptr double, ptr %245, i64 %2546
  %2548 = getelementptr double, ptr %2547, i64 %848
  %2549 = getelementptr double, ptr %2548, i64 %2545
  store double %2542, ptr %2549, align 8, !noalias !12
  br label %847

2550:                                             ; preds = %1877, %1877
  %2551 = icmp slt i64 %1881, 0
  br i1 %2551, label %1883, label %1884

2552:                                             ; preds = %1877
  br label %2683

2553:                                             ; preds = %1885
  %2554 = add nsw i64 %1887, -1
  %2555 = add i64 %1886, 1
  %2556 = icmp slt i64 %1886, 0
  %2557 = select i1 %2556, i64 %64, i64 0
  %2558 = getelementptr double, ptr %65, i64 %1886
  %2559 = getelementptr double, ptr %2558, i64 %2557
  %2560 = load double, ptr %2559, align 8, !noalias !12
  %2561 = select i1 %2556, i64 %237, i64 0
  %2562 = shl i64 %237, 4
  %2563 = getelementptr i8, ptr %238, i64 %2562
  %2564 = getelementptr double, ptr %2563, i64 %1886
  %2565 = getelementptr double, ptr %2564, i64 %2561
  %2566 = load double, ptr %2565, align 8, !noalias !12
  %2567 = fadd double %2560, %2566
  %2568 = select i1 %2556, i64 %69, i64 0
  %2569 = getelementptr double, ptr %70, i64 %1886
  %2570 = getelementptr double, ptr %2569, i64 %2568
  store double %2567, ptr %2570, align 8, !noalias !12
  br label %1885

2571:                                             ; preds = %2008, %2008
  %2572 = icmp slt i64 %2010, 0
  br i1 %2572, label %2012, label %2013

2573:                                             ; preds = %2008
  br label %2683

2574:                                             ; preds = %2060
  %2575 = add nsw i64 %2062, -1
  %2576 = add i64 %2061, 1
  %2577 = icmp slt i64 %2061, 0
  %2578 = select i1 %2577, i64 %237, i64 0
  %2579 = getelementptr double, ptr %238, i64 %2061
  %2580 = getelementptr double, ptr %2579, i64 %2578
  %2581 = load double, ptr %2580, align 8, !noalias !12
  %2582 = fmul double %2581, 0xC039A12CE7B30915
  %2583 = getelementptr double, ptr %238, i64 %237
  %2584 = getelementptr double, ptr %2583, i64 %2061
  %2585 = getelementptr double, ptr %2584, i64 %2578
  %2586 = load double, ptr %2585, align 8, !noalias !12
  %2587 = fmul double %2586, 0x402497AF24BB677E
  %2588 = fadd double %2582, %2587
  %2589 = shl i64 %237, 4
  %2590 = getelementptr i8, ptr %238, i64 %2589
  %2591 = getelementptr double, ptr %2590, i64 %2061
  %2592 = getelementptr double, ptr %2591, i64 %2578
  %2593 = load double, ptr %2592, align 8, !noalias !12
  %2594 = fmul double %2593, 0xC005555555555555
  %2595 = fadd double %2588, %2594
  %2596 = fmul double %2581, 0x402F295C43B61425
  %2597 = fmul double %2586, 0xC021D406EE60BECF
  %2598 = fadd double %2596, %2597
  %2599 = fmul double %2593, 0x400AAAAAAAAAAAAB
  %2600 = fadd double %2598, %2599
  %2601 = select i1 %2577, i64 %69, i64 0
  %2602 = getelementptr double, ptr %70, i64 %2061
  %2603 = getelementptr double, ptr %2602, i64 %2601
  %2604 = load double, ptr %2603, align 8, !noalias !12
  %2605 = select i1 %2577, i64 %64, i64 0
  %2606 = getelementptr double, ptr %65, i64 %2061
  %2607 = getelementptr double, ptr %2606, i64 %2605
  %2608 = load double, ptr %2607, align 8, !noalias !12
  %2609 = fsub double %2604, %2608
  %2610 = select i1 %2577, i64 %89, i64 0
  %2611 = getelementptr double, ptr %90, i64 %2061
  %2612 = getelementptr double, ptr %2611, i64 %2610
  store double %2609, ptr %2612, align 8, !noalias !12
  %2613 = fneg double %2595
  %2614 = fsub double %2613, %2600
  %2615 = add nsw i64 %64, %2061
  %2616 = icmp slt i64 %2615, 0
  %2617 = select i1 %2616, i64 %89, i64 0
  %2618 = getelementptr double, ptr %90, i64 %2615
  %2619 = getelementptr double, ptr %2618, i64 %2617
  store double %2614, ptr %2619, align 8, !noalias !12
  %2620 = fneg double %2600
  %2621 = shl nsw i64 %64, 1
  %2622 = add nsw i64 %2621, %2061
  %2623 = icmp slt i64 %2622, 0
  %2624 = select i1 %2623, i64 %89, i64 0
  %2625 = getelementptr double, ptr %90, i64 %2622
  %2626 = getelementptr double, ptr %2625, i64 %2624
  store double %2620, ptr %2626, align 8, !noalias !12
  %2627 = load double, ptr %2607, align 8, !noalias !12
  %2628 = select i1 %2577, i64 %256, i64 0
  %2629 = getelementptr double, ptr %257, i64 %2061
  %2630 = getelementptr double, ptr %2629, i64 %2628
  store double %2627, ptr %2630, align 8, !noalias !12
  br label %2064

2631:                                             ; preds = %2064
  %2632 = add nsw i64 %2066, -1
  %2633 = add i64 %2065, 1
  %2634 = mul nsw i64 %2065, %64
  %2635 = add nsw i64 %2634, %2061
  %2636 = icmp slt i64 %2635, 0
  %2637 = select i1 %2636, i64 %89, i64 0
  %2638 = getelementptr double, ptr %90, i64 %2635
  %2639 = getelementptr double, ptr %2638, i64 %2637
  %2640 = load double, ptr %2639, align 8, !noalias !12
  %2641 = icmp slt i64 %2065, -1
  %2642 = select i1 %2641, i64 %254, i64 0
  %2643 = add i64 %2633, %2642
  %2644 = mul i64 %2643, %256
  %2645 = getelementptr double, ptr %257, i64 %2644
  %2646 = getelementptr double, ptr %2645, i64 %2061
  %2647 = getelementptr double, ptr %2646, i64 %2628
  store double %2640, ptr %2647, align 8, !noalias !12
  br label %2064

2648:                                             ; preds = %2119, %2657
  %2649 = phi i64 [ 0, %2119 ], [ %2659, %2657 ]
  %2650 = phi i64 [ %2131, %2119 ], [ %2658, %2657 ]
  %2651 = icmp sgt i64 %2650, 0
  br i1 %2651, label %2657, label %2652

2652:                                             ; preds = %2648
  %2653 = getelementptr i8, ptr %27, i64 24
  %2654 = load i64, ptr %2653, align 8, !noalias !148
  %2655 = getelementptr i8, ptr %30, i64 16
  %2656 = load i64, ptr %2655, align 8, !noalias !148
  call fastcc void @pydy_nested(i64 %2130, i64 %62, i64 %87, i64 %64, i64 %2654, i64 %77, i64 %2656) #3, !noalias !148
  br i1 %2105, label %2132, label %2139

2657:                                             ; preds = %2648
  %2658 = add nsw i64 %2650, -1
  %2659 = add i64 %2649, 1
  %2660 = icmp slt i64 %2649, 0
  %2661 = select i1 %2660, i64 %79, i64 0
  %2662 = getelementptr double, ptr %80, i64 %2649
  %2663 = getelementptr double, ptr %2662, i64 %2661
  store double %2127, ptr %2663, align 8, !noalias !148
  br label %2648

2664:                                             ; preds = %2173
  %2665 = load i64, ptr %157, align 8, !noalias !12
  %2666 = icmp eq i64 %2665, 1
  br i1 %2666, label %2195, label %2200

2667:                                             ; preds = %2205
  br label %2683

2668:                                             ; preds = %2211
  store double %2098, ptr %105, align 8, !noalias !12
  store double 0.000000e+00, ptr %298, align 8, !noalias !12
  store i64 0, ptr %110, align 8, !noalias !12
  br label %2226

2669:                                             ; preds = %2243
  %2670 = add nsw i64 %2245, -1
  %2671 = add i64 %2244, 1
  %2672 = icmp slt i64 %2244, 0
  %2673 = select i1 %2672, i64 %69, i64 0
  %2674 = getelementptr double, ptr %70, i64 %2244
  %2675 = getelementptr double, ptr %2674, i64 %2673
  %2676 = load double, ptr %2675, align 8, !noalias !12
  %2677 = select i1 %2672, i64 %64, i64 0
  %2678 = getelementptr double, ptr %65, i64 %2244
  %2679 = getelementptr double, ptr %2678, i64 %2677
  store double %2676, ptr %2679, align 8, !noalias !12
  br label %2243

2680:                                             ; preds = %2261, %2261
  %2681 = icmp eq i32 %2262, 0
  br i1 %2681, label %2268, label %2264

2682:                                             ; preds = %2261
  br label %2683

2683:                                             ; preds = %2682, %2667, %2573, %2552, %2435, %2388, %2382, %2381, %2377, %2364, %2363, %2264, %2241, %2012, %1883, %445, %380, %369, %329, %319, %192
  %2684 = phi i64 [ 0, %2552 ], [ -1, %192 ], [ 2, %2363 ], [ %2227, %2241 ], [ -4, %1883 ], [ 0, %2682 ], [ %2267, %2264 ], [ 0, %2377 ], [ %322, %319 ], [ 0, %2381 ], [ 0, %329 ], [ 0, %2382 ], [ -1, %369 ], [ 1, %380 ], [ 0, %2388 ], [ 0, %2435 ], [ -4, %445 ], [ 0, %2573 ], [ 0, %2667 ], [ -4, %2012 ], [ 0, %2364 ]
  ret i64 %2684
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
!76 = !{!77, !62, !64}
!77 = distinct !{!77, !78}
!78 = distinct !{!78}
!79 = !{!"branch_weights", i32 49, i32 1}
!80 = !{!81, !83, !62, !64}
!81 = distinct !{!81, !82}
!82 = distinct !{!82}
!83 = distinct !{!83, !82}
!84 = !{!85, !87, !89, !81, !83, !62, !64}
!85 = distinct !{!85, !86}
!86 = distinct !{!86}
!87 = distinct !{!87, !88}
!88 = distinct !{!88}
!89 = distinct !{!89, !88}
!90 = !{!91, !93, !95, !81, !83, !62, !64}
!91 = distinct !{!91, !92}
!92 = distinct !{!92}
!93 = distinct !{!93, !94}
!94 = distinct !{!94}
!95 = distinct !{!95, !94}
!96 = !{!97, !99, !62, !64}
!97 = distinct !{!97, !98}
!98 = distinct !{!98}
!99 = distinct !{!99, !98}
!100 = !{!101, !103, !62, !64}
!101 = distinct !{!101, !102}
!102 = distinct !{!102}
!103 = distinct !{!103, !102}
!104 = !{!105, !62, !64}
!105 = distinct !{!105, !106}
!106 = distinct !{!106}
!107 = !{!108, !110}
!108 = distinct !{!108, !109}
!109 = distinct !{!109}
!110 = distinct !{!110, !109}
!111 = !{!112, !114, !115, !117, !108, !110}
!112 = distinct !{!112, !113}
!113 = distinct !{!113}
!114 = distinct !{!114, !113}
!115 = distinct !{!115, !116}
!116 = distinct !{!116}
!117 = distinct !{!117, !116}
!118 = !{!115, !117, !108, !110}
!119 = !{!120, !122, !13, !15}
!120 = distinct !{!120, !121}
!121 = distinct !{!121}
!122 = distinct !{!122, !121}
!123 = !{!124}
!124 = distinct !{!124, !125}
!125 = distinct !{!125}
!126 = !{!127}
!127 = distinct !{!127, !128}
!128 = distinct !{!128}
!129 = !{!130, !132, !133, !135}
!130 = distinct !{!130, !131}
!131 = distinct !{!131}
!132 = distinct !{!132, !131}
!133 = distinct !{!133, !134}
!134 = distinct !{!134}
!135 = distinct !{!135, !134}
!136 = !{!133, !135}
!137 = !{!138}
!138 = distinct !{!138, !139}
!139 = distinct !{!139}
!140 = !{!141, !143, !144, !146}
!141 = distinct !{!141, !142}
!142 = distinct !{!142}
!143 = distinct !{!143, !142}
!144 = distinct !{!144, !145}
!145 = distinct !{!145}
!146 = distinct !{!146, !145}
!147 = !{!144, !146}
!148 = !{!149, !151, !13, !15}
!149 = distinct !{!149, !150}
!150 = distinct !{!150}
!151 = distinct !{!151, !150}
