; sources 66d7db848c459d4f1d75a99529407a9a51756eefbd8dba31c2d8989f7f6f1096
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
  %162 = load i64, ptr %161, align 8, !noalias !22
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
  %188 = load i64, ptr %187, align 8, !noalias !23
  %189 = select i1 %184, i64 %109, i64 0
  %190 = getelementptr i64, ptr %110, i64 %178
  %191 = getelementptr i64, ptr %190, i64 %189
  store i64 %188, ptr %191, align 8, !noalias !23
  br label %177

192:                                              ; preds = %154
  br label %2773

193:                                              ; preds = %154
  %194 = getelementptr i8, ptr %25, i64 1080
  %195 = load i64, ptr %194, align 8, !noalias !22
  %196 = inttoptr i64 %195 to ptr
  %197 = getelementptr i8, ptr %25, i64 1104
  %198 = load i64, ptr %197, align 8, !noalias !22
  %199 = inttoptr i64 %198 to ptr
  %200 = getelementptr i8, ptr %25, i64 1128
  %201 = load i64, ptr %200, align 8, !noalias !22
  %202 = inttoptr i64 %201 to ptr
  %203 = getelementptr i8, ptr %25, i64 1152
  %204 = load i64, ptr %203, align 8, !noalias !22
  %205 = getelementptr i8, ptr %25, i64 1160
  %206 = load i64, ptr %205, align 8, !noalias !22
  %207 = inttoptr i64 %204 to ptr
  %208 = getelementptr i8, ptr %25, i64 1176
  %209 = load i64, ptr %208, align 8, !noalias !22
  %210 = getelementptr i8, ptr %25, i64 1184
  %211 = load i64, ptr %210, align 8, !noalias !22
  %212 = getelementptr i8, ptr %25, i64 1192
  %213 = load i64, ptr %212, align 8, !noalias !22
  %214 = inttoptr i64 %209 to ptr
  %215 = getelementptr i8, ptr %25, i64 1200
  %216 = load i64, ptr %215, align 8, !noalias !22
  %217 = getelementptr i8, ptr %25, i64 1208
  %218 = load i64, ptr %217, align 8, !noalias !22
  %219 = getelementptr i8, ptr %25, i64 1216
  %220 = load i64, ptr %219, align 8, !noalias !22
  %221 = inttoptr i64 %216 to ptr
  %222 = getelementptr i8, ptr %25, i64 1224
  %223 = load i64, ptr %222, align 8, !noalias !22
  %224 = getelementptr i8, ptr %25, i64 1232
  %225 = load i64, ptr %224, align 8, !noalias !22
  %226 = inttoptr i64 %223 to ptr
  %227 = getelementptr i8, ptr %25, i64 1248
  %228 = load i64, ptr %227, align 8, !noalias !22
  %229 = getelementptr i8, ptr %25, i64 1256
  %230 = load i64, ptr %229, align 8, !noalias !22
  %231 = inttoptr i64 %228 to ptr
  %232 = getelementptr i8, ptr %25, i64 1272
  %233 = load i64, ptr %232, align 8, !noalias !22
  %234 = getelementptr i8, ptr %25, i64 1280
  %235 = load i64, ptr %234, align 8, !noalias !22
  %236 = getelementptr i8, ptr %25, i64 1288
  %237 = load i64, ptr %236, align 8, !noalias !22
  %238 = inttoptr i64 %233 to ptr
  %239 = getelementptr i8, ptr %25, i64 1296
  %240 = load i64, ptr %239, align 8, !noalias !22
  %241 = getelementptr i8, ptr %25, i64 1304
  %242 = load i64, ptr %241, align 8, !noalias !22
  %243 = getelementptr i8, ptr %25, i64 1312
  %244 = load i64, ptr %243, align 8, !noalias !22
  %245 = inttoptr i64 %240 to ptr
  %246 = getelementptr i8, ptr %25, i64 1320
  %247 = load i64, ptr %246, align 8, !noalias !22
  %248 = getelementptr i8, ptr %25, i64 1336
  %249 = load i64, ptr %248, align 8, !noalias !22
  %250 = inttoptr i64 %247 to ptr
  %251 = getelementptr i8, ptr %25, i64 1344
  %252 = load i64, ptr %251, align 8, !noalias !22
  %253 = getelementptr i8, ptr %25, i64 1352
  %254 = load i64, ptr %253, align 8, !noalias !22
  %255 = getelementptr i8, ptr %25, i64 1360
  %256 = load i64, ptr %255, align 8, !noalias !22
  %257 = inttoptr i64 %252 to ptr
  %258 = getelementptr i8, ptr %25, i64 1368
  %259 = load i64, ptr %258, align 8, !noalias !22
  %260 = getelementptr i8, ptr %25, i64 1376
  %261 = load i64, ptr %260, align 8, !noalias !22
  %262 = inttoptr i64 %259 to ptr
  %263 = getelementptr i8, ptr %25, i64 1392
  %264 = load i64, ptr %263, align 8, !noalias !22
  %265 = getelementptr i8, ptr %25, i64 1400
  %266 = load i64, ptr %265, align 8, !noalias !22
  %267 = inttoptr i64 %264 to ptr
  %268 = getelementptr i8, ptr %25, i64 1416
  %269 = load i64, ptr %268, align 8, !noalias !22
  %270 = getelementptr i8, ptr %25, i64 1424
  %271 = load i64, ptr %270, align 8, !noalias !22
  %272 = inttoptr i64 %269 to ptr
  %273 = getelementptr i8, ptr %25, i64 1032
  %274 = load i64, ptr %273, align 8, !noalias !22
  %275 = inttoptr i64 %274 to ptr
  %276 = getelementptr i8, ptr %25, i64 1056
  %277 = load i64, ptr %276, align 8, !noalias !22
  %278 = getelementptr i8, ptr %25, i64 1064
  %279 = load i64, ptr %278, align 8, !noalias !22
  %280 = getelementptr i8, ptr %25, i64 1072
  %281 = load i64, ptr %280, align 8, !noalias !22
  %282 = inttoptr i64 %277 to ptr
  %283 = load i64, ptr %116, align 8, !noalias !22
  %284 = load i64, ptr %157, align 8, !noalias !22
  %285 = icmp eq i64 %284, 1
  %286 = call i64 @llvm.smin.i64(i64 %114, i64 0)
  %287 = getelementptr double, ptr %115, i64 %114
  %288 = getelementptr i8, ptr %287, i64 -8
  %289 = getelementptr double, ptr %288, i64 %286
  %290 = load double, ptr %289, align 8, !noalias !22
  %291 = load double, ptr %95, align 8, !noalias !22
  %292 = call i64 @llvm.smax.i64(i64 %283, i64 0)
  br label %293

293:                                              ; preds = %2452, %193
  %294 = phi i64 [ 0, %193 ], [ %2460, %2452 ]
  %295 = phi i64 [ %292, %193 ], [ %2461, %2452 ]
  %296 = phi double [ %291, %193 ], [ %2459, %2452 ]
  %297 = icmp sgt i64 %295, 0
  br i1 %297, label %2452, label %298

298:                                              ; preds = %293
  %299 = fcmp olt double %296, 0x3CB0000000000000
  %300 = select i1 %299, double 0x3CB0000000000000, double %296
  %301 = call double @sqrt(double %296), !noalias !22
  %302 = fcmp olt double %301, 3.000000e-02
  %303 = select i1 %302, double %301, double 3.000000e-02
  %304 = fdiv double 0x3CE4000000000000, %300
  %305 = fcmp ogt double %303, %304
  %306 = select i1 %305, double %303, double %304
  %307 = load double, ptr %105, align 8, !noalias !22
  %308 = getelementptr i8, ptr %105, i64 8
  %309 = load double, ptr %308, align 8, !noalias !22
  %310 = load i64, ptr %110, align 8, !noalias !22
  %311 = icmp eq i64 %310, 0
  br i1 %311, label %312, label %369

312:                                              ; preds = %298
  %313 = getelementptr i8, ptr %110, i64 24
  %314 = load i64, ptr %313, align 8, !noalias !22
  %315 = add nsw i64 %314, 1
  store i64 %315, ptr %313, align 8, !noalias !22
  store ptr null, ptr %19, align 8, !noalias !26
  store ptr null, ptr %20, align 8, !noalias !26
  store double %307, ptr %33, align 8, !noalias !26
  %316 = icmp sgt i64 %45, 0
  br i1 %316, label %317, label %320

317:                                              ; preds = %312
  store ptr null, ptr %19, align 8, !noalias !26
  %318 = call fastcc i32 @_sample(ptr nonnull %19, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %307) #3
  switch i32 %318, label %319 [
    i32 -2, label %320
    i32 0, label %320
  ], !prof !33

319:                                              ; preds = %317
  br label %320

320:                                              ; preds = %317, %317, %312, %319
  %321 = phi i32 [ %318, %319 ], [ 0, %312 ], [ 0, %317 ], [ 0, %317 ]
  switch i32 %321, label %326 [
    i32 -2, label %322
    i32 0, label %322
  ], !prof !33

322:                                              ; preds = %320, %320
  %323 = load i64, ptr %30, align 8, !noalias !34
  %324 = inttoptr i64 %323 to ptr
  %325 = call i32 %324(ptr nonnull %33, ptr %65, ptr %38, ptr %41, ptr %85) #3, !noalias !34
  br label %326

326:                                              ; preds = %320, %322
  %327 = phi i32 [ %325, %322 ], [ 0, %320 ]
  %328 = phi i32 [ 0, %322 ], [ %321, %320 ]
  switch i32 %328, label %2464 [
    i32 -2, label %2462
    i32 0, label %2462
  ], !prof !33

329:                                              ; preds = %2462
  %330 = getelementptr i8, ptr %110, i64 72
  store i64 3, ptr %330, align 8, !noalias !22
  %331 = icmp slt i32 %327, 0
  %332 = select i1 %331, i64 -4, i64 2
  br label %2773

333:                                              ; preds = %2462
  store i64 1, ptr %110, align 8, !noalias !22
  %334 = getelementptr i8, ptr %105, i64 24
  store double 0.000000e+00, ptr %334, align 8, !noalias !22
  %335 = getelementptr i8, ptr %196, i64 8
  store i64 1, ptr %335, align 8, !noalias !22
  %336 = getelementptr i8, ptr %196, i64 32
  store i64 1, ptr %336, align 8, !noalias !22
  %337 = getelementptr i8, ptr %199, i64 8
  store double 0.000000e+00, ptr %337, align 8, !noalias !22
  store i8 0, ptr %23, align 1, !noalias !12
  %338 = call fastcc i32 @write_reached(ptr nonnull %23, ptr %30, ptr %65, i64 %64, ptr nonnull %105, ptr nonnull %110, i64 %114, ptr %115, i64 %114, ptr %119, i64 %118) #3
  switch i32 %338, label %2468 [
    i32 -2, label %2465
    i32 0, label %2465
  ], !prof !33

339:                                              ; preds = %2465
  br label %2773

340:                                              ; preds = %2465
  %341 = fcmp oeq double %309, 0.000000e+00
  br i1 %341, label %342, label %369

342:                                              ; preds = %340
  %343 = getelementptr i8, ptr %105, i64 16
  %344 = load double, ptr %343, align 8, !noalias !22
  store double 0.000000e+00, ptr %21, align 8, !noalias !35
  store double 0.000000e+00, ptr %22, align 8, !noalias !35
  store double 0.000000e+00, ptr %21, align 8, !noalias !35
  %345 = call fastcc i32 @norm(ptr nonnull %21, ptr %65, ptr %65, ptr %65, ptr nonnull %95, i64 %94, ptr %100, i64 %99, i64 %283) #3
  %346 = load double, ptr %21, align 8, !noalias !35
  switch i32 %345, label %2469 [
    i32 -2, label %347
    i32 0, label %347
  ], !prof !33

347:                                              ; preds = %342, %342
  store double 0.000000e+00, ptr %22, align 8, !noalias !35
  %348 = call fastcc i32 @norm(ptr nonnull %22, ptr %85, ptr %65, ptr %65, ptr nonnull %95, i64 %94, ptr %100, i64 %99, i64 %283) #3
  switch i32 %348, label %2469 [
    i32 -2, label %349
    i32 0, label %349
  ], !prof !33

349:                                              ; preds = %347, %347
  %350 = load double, ptr %22, align 8, !noalias !35
  %351 = fcmp olt double %346, 1.000000e-05
  %352 = fcmp olt double %350, 1.000000e-05
  %353 = or i1 %351, %352
  %354 = fmul double %346, 1.000000e-02
  %355 = fdiv double %354, %350
  %356 = select i1 %353, double 0x3EB0C6F7A0B5ED8D, double %355
  %357 = fcmp olt double %344, %356
  %358 = select i1 %357, double %344, double %356
  %359 = load double, ptr %343, align 8, !noalias !22
  %360 = call double @llvm.fabs.f64(double %307)
  %361 = fmul double %360, 0x3D30000000000000
  %362 = fcmp ogt double %361, %358
  %363 = select i1 %362, double %361, double %358
  %364 = fcmp olt double %359, %363
  %365 = select i1 %364, double %359, double %363
  %366 = call i1 @llvm.is.fpclass.f64(double %365, i32 384)
  br i1 %366, label %369, label %367

367:                                              ; preds = %349
  %368 = getelementptr i8, ptr %110, i64 72
  store i64 4, ptr %368, align 8, !noalias !22
  br label %369

369:                                              ; preds = %349, %298, %367, %340
  %370 = phi double [ %365, %349 ], [ %365, %367 ], [ %309, %340 ], [ %309, %298 ]
  br label %371

371:                                              ; preds = %2448, %369
  %372 = phi double [ %370, %369 ], [ %2449, %2448 ]
  %373 = phi double [ %307, %369 ], [ %376, %2448 ]
  br label %374

374:                                              ; preds = %2369, %371
  %375 = phi double [ %372, %371 ], [ %2370, %2369 ]
  %376 = phi double [ %373, %371 ], [ %411, %2369 ]
  %377 = load i64, ptr %161, align 8, !noalias !22
  %378 = icmp eq i64 %377, 0
  br i1 %378, label %379, label %380

379:                                              ; preds = %374
  store double %375, ptr %308, align 8, !noalias !22
  br label %2773

380:                                              ; preds = %374
  %381 = getelementptr i8, ptr %275, i64 8
  %382 = load i64, ptr %381, align 8, !noalias !39
  %383 = icmp sgt i64 %382, 0
  br i1 %383, label %384, label %389

384:                                              ; preds = %380
  %385 = load i64, ptr %275, align 8, !noalias !39
  %386 = add nsw i64 %385, 3
  %387 = icmp slt i64 %382, %386
  br i1 %387, label %388, label %389

388:                                              ; preds = %384
  store double %375, ptr %308, align 8, !noalias !22
  br label %2773

389:                                              ; preds = %380, %384
  %390 = add nsw i64 %377, -1
  store i64 %390, ptr %161, align 8, !noalias !22
  %391 = getelementptr i8, ptr %110, i64 8
  %392 = load i64, ptr %391, align 8, !noalias !22
  %393 = getelementptr i8, ptr %110, i64 16
  %394 = load i64, ptr %393, align 8, !noalias !22
  %395 = add nsw i64 %392, %394
  %396 = getelementptr i8, ptr %110, i64 64
  %397 = load i64, ptr %396, align 8, !noalias !22
  %398 = icmp slt i64 %395, %397
  br i1 %398, label %400, label %399

399:                                              ; preds = %389
  store double %375, ptr %308, align 8, !noalias !22
  br label %2773

400:                                              ; preds = %389
  %401 = getelementptr i8, ptr %105, i64 16
  %402 = load double, ptr %401, align 8, !noalias !22
  %403 = fcmp olt double %375, %402
  %404 = select i1 %403, double %375, double %402
  %405 = fadd double %376, %404
  %406 = fmul double %404, 1.000000e-03
  %407 = fsub double %290, %406
  %408 = fcmp ogt double %405, %407
  %409 = fsub double %290, %376
  %410 = select i1 %408, double %409, double %404
  %411 = select i1 %408, double %290, double %405
  %412 = fmul double %410, 6.250000e-02
  %413 = fadd double %376, %412
  %414 = fcmp ogt double %413, %376
  %415 = fcmp oeq double %411, %290
  %416 = or i1 %414, %415
  br i1 %416, label %417, label %2450

417:                                              ; preds = %400
  %418 = getelementptr i8, ptr %196, i64 8
  %419 = load i64, ptr %418, align 8, !noalias !22
  %420 = icmp eq i64 %419, 1
  br i1 %420, label %421, label %468

421:                                              ; preds = %417
  %422 = getelementptr i8, ptr %110, i64 32
  %423 = load i64, ptr %422, align 8, !noalias !22
  %424 = add nsw i64 %423, 1
  store i64 %424, ptr %422, align 8, !noalias !22
  %425 = load i64, ptr %116, align 8, !noalias !22
  %426 = load i64, ptr %196, align 8, !noalias !22
  %427 = icmp eq i64 %426, 0
  br i1 %427, label %435, label %428

428:                                              ; preds = %421
  store ptr null, ptr %13, align 8, !noalias !42
  store ptr null, ptr %14, align 8, !noalias !42
  store double %376, ptr %33, align 8, !noalias !42
  %429 = icmp sgt i64 %45, 0
  br i1 %429, label %430, label %433

430:                                              ; preds = %428
  store ptr null, ptr %13, align 8, !noalias !42
  %431 = call fastcc i32 @_sample(ptr nonnull %13, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %376) #3
  switch i32 %431, label %432 [
    i32 -2, label %433
    i32 0, label %433
  ], !prof !33

432:                                              ; preds = %430
  br label %433

433:                                              ; preds = %430, %430, %428, %432
  %434 = phi i32 [ %431, %432 ], [ 0, %428 ], [ 0, %430 ], [ 0, %430 ]
  switch i32 %434, label %2475 [
    i32 -2, label %2470
    i32 0, label %2470
  ], !prof !33

435:                                              ; preds = %421
  %436 = call i64 @llvm.smax.i64(i64 %425, i64 0)
  br label %437

437:                                              ; preds = %435, %2476
  %438 = phi i64 [ 0, %435 ], [ %2478, %2476 ]
  %439 = phi i64 [ %436, %435 ], [ %2477, %2476 ]
  %440 = icmp sgt i64 %439, 0
  br i1 %440, label %2476, label %441

441:                                              ; preds = %437, %451
  %442 = phi i64 [ %2489, %451 ], [ 0, %437 ]
  %443 = phi i64 [ %2488, %451 ], [ %436, %437 ]
  %444 = icmp sgt i64 %443, 0
  br i1 %444, label %2487, label %453

445:                                              ; preds = %2520
  %446 = sext i32 %2518 to i64
  br label %453

447:                                              ; preds = %2520, %2523
  %448 = phi i64 [ %2525, %2523 ], [ 0, %2520 ]
  %449 = phi i64 [ %2524, %2523 ], [ %436, %2520 ]
  %450 = icmp sgt i64 %449, 0
  br i1 %450, label %2523, label %451

451:                                              ; preds = %447
  %452 = load double, ptr %2493, align 8, !noalias !22
  store double %452, ptr %2503, align 8, !noalias !22
  br label %441

453:                                              ; preds = %441, %2470, %445
  %454 = phi i64 [ %2474, %2470 ], [ %446, %445 ], [ 0, %441 ]
  %455 = call i64 @llvm.smax.i64(i64 %206, i64 0)
  br label %456

456:                                              ; preds = %453, %461
  %457 = phi i64 [ 0, %453 ], [ %2545, %461 ]
  %458 = phi i64 [ %455, %453 ], [ %2544, %461 ]
  %459 = icmp sgt i64 %458, 0
  br i1 %459, label %2543, label %462

460:                                              ; preds = %2543
  store double 0.000000e+00, ptr %2549, align 8, !noalias !22
  br label %461

461:                                              ; preds = %460, %2543
  br label %456

462:                                              ; preds = %456
  %463 = icmp slt i64 %454, 0
  br i1 %463, label %464, label %465

464:                                              ; preds = %462
  br label %2773

465:                                              ; preds = %462
  store i64 0, ptr %418, align 8, !noalias !22
  %466 = getelementptr i8, ptr %196, i64 16
  store i64 1, ptr %466, align 8, !noalias !22
  %467 = getelementptr i8, ptr %196, i64 24
  store i64 0, ptr %467, align 8, !noalias !22
  br label %468

468:                                              ; preds = %465, %417
  %469 = getelementptr i8, ptr %196, i64 24
  %470 = load i64, ptr %469, align 8, !noalias !22
  %471 = icmp eq i64 %470, 0
  br i1 %471, label %475, label %472

472:                                              ; preds = %468
  %473 = load double, ptr %199, align 8, !noalias !22
  %474 = fcmp une double %410, %473
  br i1 %474, label %475, label %790

475:                                              ; preds = %472, %468
  %476 = getelementptr i8, ptr %110, i64 40
  %477 = load i64, ptr %476, align 8, !noalias !22
  %478 = add nsw i64 %477, 1
  store i64 %478, ptr %476, align 8, !noalias !22
  %479 = call i64 @llvm.smax.i64(i64 %225, i64 0)
  br label %480

480:                                              ; preds = %488, %475
  %481 = phi i64 [ 0, %475 ], [ %2555, %488 ]
  %482 = phi i64 [ %479, %475 ], [ %2554, %488 ]
  %483 = icmp sgt i64 %482, 0
  br i1 %483, label %2553, label %514

484:                                              ; preds = %2553, %2556
  %485 = phi i64 [ 0, %2553 ], [ %2558, %2556 ]
  %486 = phi i64 [ %479, %2553 ], [ %2557, %2556 ]
  %487 = icmp sgt i64 %486, 0
  br i1 %487, label %2556, label %488

488:                                              ; preds = %484
  %489 = icmp slt i64 %481, 0
  %490 = select i1 %489, i64 %211, i64 0
  %491 = add i64 %481, %490
  %492 = select i1 %489, i64 %213, i64 0
  %493 = mul i64 %491, %213
  %494 = getelementptr double, ptr %214, i64 %493
  %495 = getelementptr double, ptr %494, i64 %481
  %496 = getelementptr double, ptr %495, i64 %492
  %497 = load double, ptr %496, align 8, !noalias !22
  %498 = fdiv double 0x400D1A48D83E731D, %410
  %499 = fadd double %497, %498
  store double %499, ptr %496, align 8, !noalias !22
  %500 = select i1 %489, i64 %218, i64 0
  %501 = add i64 %481, %500
  %502 = select i1 %489, i64 %220, i64 0
  %503 = mul i64 %501, %220
  %504 = getelementptr { double, double }, ptr %221, i64 %503
  %505 = getelementptr { double, double }, ptr %504, i64 %481
  %506 = getelementptr { double, double }, ptr %505, i64 %502
  %507 = load double, ptr %506, align 8, !noalias !22
  %508 = getelementptr inbounds nuw i8, ptr %506, i64 8
  %509 = load double, ptr %508, align 8, !noalias !22
  %510 = fdiv double 0x400572DB93E0C672, %410
  %511 = fdiv double 0xC0086747F2C3FCB6, %410
  %512 = fadd double %507, %510
  %513 = fadd double %509, %511
  store double %512, ptr %506, align 8, !noalias !22
  store double %513, ptr %508, align 8, !noalias !22
  br label %480

514:                                              ; preds = %480
  %515 = call i64 @llvm.smax.i64(i64 %211, i64 0)
  br label %516

516:                                              ; preds = %540, %514
  %517 = phi i64 [ 0, %514 ], [ %553, %540 ]
  %518 = phi i64 [ %515, %514 ], [ %552, %540 ]
  %519 = icmp sgt i64 %518, 0
  br i1 %519, label %551, label %622

520:                                              ; preds = %566, %551
  %521 = phi i64 [ %553, %551 ], [ %568, %566 ]
  %522 = phi i64 [ %565, %551 ], [ %567, %566 ]
  %523 = phi double [ %563, %551 ], [ %579, %566 ]
  %524 = phi i64 [ %517, %551 ], [ %580, %566 ]
  %525 = icmp sgt i64 %522, 0
  br i1 %525, label %566, label %526

526:                                              ; preds = %520
  %527 = select i1 %554, i64 %225, i64 0
  %528 = getelementptr i64, ptr %226, i64 %517
  %529 = getelementptr i64, ptr %528, i64 %527
  store i64 %524, ptr %529, align 8, !noalias !46
  %530 = fcmp ueq double %523, 0.000000e+00
  br i1 %530, label %782, label %531

531:                                              ; preds = %526
  %532 = icmp eq i64 %524, %517
  br i1 %532, label %537, label %533

533:                                              ; preds = %531, %581
  %534 = phi i64 [ %583, %581 ], [ 0, %531 ]
  %535 = phi i64 [ %582, %581 ], [ %515, %531 ]
  %536 = icmp sgt i64 %535, 0
  br i1 %536, label %581, label %537

537:                                              ; preds = %533, %531
  %538 = load double, ptr %561, align 8, !noalias !46
  %539 = fdiv double 1.000000e+00, %538
  br label %540

540:                                              ; preds = %550, %537
  %541 = phi i64 [ %553, %537 ], [ %599, %550 ]
  %542 = phi i64 [ %565, %537 ], [ %598, %550 ]
  %543 = icmp sgt i64 %542, 0
  br i1 %543, label %597, label %516

544:                                              ; preds = %597
  %545 = fmul double %607, %539
  store double %545, ptr %606, align 8, !noalias !46
  br label %546

546:                                              ; preds = %609, %544
  %547 = phi i64 [ %553, %544 ], [ %611, %609 ]
  %548 = phi i64 [ %565, %544 ], [ %610, %609 ]
  %549 = icmp sgt i64 %548, 0
  br i1 %549, label %609, label %550

550:                                              ; preds = %597, %546
  br label %540

551:                                              ; preds = %516
  %552 = add nsw i64 %518, -1
  %553 = add i64 %517, 1
  %554 = icmp slt i64 %517, 0
  %555 = select i1 %554, i64 %211, i64 0
  %556 = add i64 %517, %555
  %557 = select i1 %554, i64 %213, i64 0
  %558 = mul i64 %556, %213
  %559 = getelementptr double, ptr %214, i64 %558
  %560 = getelementptr double, ptr %559, i64 %517
  %561 = getelementptr double, ptr %560, i64 %557
  %562 = load double, ptr %561, align 8, !noalias !46
  %563 = call double @llvm.fabs.f64(double %562)
  %564 = sub i64 %211, %553
  %565 = call i64 @llvm.smax.i64(i64 %564, i64 0)
  br label %520

566:                                              ; preds = %520
  %567 = add nsw i64 %522, -1
  %568 = add i64 %521, 1
  %569 = icmp slt i64 %521, 0
  %570 = select i1 %569, i64 %211, i64 0
  %571 = add i64 %521, %570
  %572 = mul i64 %571, %213
  %573 = getelementptr double, ptr %214, i64 %572
  %574 = getelementptr double, ptr %573, i64 %517
  %575 = getelementptr double, ptr %574, i64 %557
  %576 = load double, ptr %575, align 8, !noalias !46
  %577 = call double @llvm.fabs.f64(double %576)
  %578 = fcmp ogt double %577, %523
  %579 = select i1 %578, double %577, double %523
  %580 = select i1 %578, i64 %521, i64 %524
  br label %520

581:                                              ; preds = %533
  %582 = add nsw i64 %535, -1
  %583 = add i64 %534, 1
  %584 = icmp slt i64 %524, 0
  %585 = select i1 %584, i64 %211, i64 0
  %586 = add i64 %524, %585
  %587 = icmp slt i64 %534, 0
  %588 = select i1 %587, i64 %213, i64 0
  %589 = mul i64 %586, %213
  %590 = getelementptr double, ptr %214, i64 %589
  %591 = getelementptr double, ptr %590, i64 %534
  %592 = getelementptr double, ptr %591, i64 %588
  %593 = load double, ptr %592, align 8, !noalias !46
  %594 = getelementptr double, ptr %559, i64 %534
  %595 = getelementptr double, ptr %594, i64 %588
  %596 = load double, ptr %595, align 8, !noalias !46
  store double %593, ptr %595, align 8, !noalias !46
  store double %596, ptr %592, align 8, !noalias !46
  br label %533

597:                                              ; preds = %540
  %598 = add nsw i64 %542, -1
  %599 = add i64 %541, 1
  %600 = icmp slt i64 %541, 0
  %601 = select i1 %600, i64 %211, i64 0
  %602 = add i64 %541, %601
  %603 = mul i64 %602, %213
  %604 = getelementptr double, ptr %214, i64 %603
  %605 = getelementptr double, ptr %604, i64 %517
  %606 = getelementptr double, ptr %605, i64 %557
  %607 = load double, ptr %606, align 8, !noalias !46
  %608 = fcmp une double %607, 0.000000e+00
  br i1 %608, label %544, label %550

609:                                              ; preds = %546
  %610 = add nsw i64 %548, -1
  %611 = add i64 %547, 1
  %612 = icmp slt i64 %547, 0
  %613 = select i1 %612, i64 %213, i64 0
  %614 = getelementptr double, ptr %604, i64 %547
  %615 = getelementptr double, ptr %614, i64 %613
  %616 = load double, ptr %615, align 8, !noalias !46
  %617 = getelementptr double, ptr %559, i64 %547
  %618 = getelementptr double, ptr %617, i64 %613
  %619 = load double, ptr %618, align 8, !noalias !46
  %620 = fmul double %545, %619
  %621 = fsub double %616, %620
  store double %621, ptr %615, align 8, !noalias !46
  br label %546

622:                                              ; preds = %516
  %623 = call i64 @llvm.smax.i64(i64 %218, i64 0)
  br label %624

624:                                              ; preds = %672, %622
  %625 = phi i64 [ 0, %622 ], [ %690, %672 ]
  %626 = phi i64 [ %623, %622 ], [ %689, %672 ]
  %627 = icmp sgt i64 %626, 0
  br i1 %627, label %688, label %781

628:                                              ; preds = %705, %688
  %629 = phi i64 [ %690, %688 ], [ %717, %705 ]
  %630 = phi i64 [ %704, %688 ], [ %718, %705 ]
  %631 = phi double [ %702, %688 ], [ %720, %705 ]
  %632 = phi i64 [ %625, %688 ], [ %721, %705 ]
  %633 = icmp sgt i64 %630, 0
  br i1 %633, label %705, label %634

634:                                              ; preds = %628
  %635 = select i1 %691, i64 %230, i64 0
  %636 = getelementptr i64, ptr %231, i64 %625
  %637 = getelementptr i64, ptr %636, i64 %635
  store i64 %632, ptr %637, align 8, !noalias !49
  %638 = fcmp ueq double %631, 0.000000e+00
  br i1 %638, label %782, label %639

639:                                              ; preds = %634
  %640 = icmp eq i64 %632, %625
  br i1 %640, label %645, label %641

641:                                              ; preds = %639, %722
  %642 = phi i64 [ %724, %722 ], [ 0, %639 ]
  %643 = phi i64 [ %723, %722 ], [ %623, %639 ]
  %644 = icmp sgt i64 %643, 0
  br i1 %644, label %722, label %645

645:                                              ; preds = %641, %639
  %646 = load double, ptr %698, align 8, !noalias !49
  %647 = load double, ptr %700, align 8, !noalias !49
  %648 = call double @llvm.fabs.f64(double %646)
  %649 = call double @llvm.fabs.f64(double %647)
  %650 = fcmp ult double %648, %649
  br i1 %650, label %660, label %651

651:                                              ; preds = %645
  %652 = fdiv double %647, %646
  %653 = fmul double %647, %652
  %654 = fadd double %646, %653
  %655 = fmul double %652, 0.000000e+00
  %656 = fadd double %655, 1.000000e+00
  %657 = fdiv double %656, %654
  %658 = fsub double 0.000000e+00, %652
  %659 = fdiv double %658, %654
  br label %669

660:                                              ; preds = %645
  %661 = fdiv double %646, %647
  %662 = fmul double %646, %661
  %663 = fadd double %662, %647
  %664 = fadd double %661, 0.000000e+00
  %665 = fdiv double %664, %663
  %666 = fmul double %661, 0.000000e+00
  %667 = fadd double %666, -1.000000e+00
  %668 = fdiv double %667, %663
  br label %669

669:                                              ; preds = %660, %651
  %670 = phi double [ %659, %651 ], [ %668, %660 ]
  %671 = phi double [ %657, %651 ], [ %665, %660 ]
  br label %672

672:                                              ; preds = %687, %669
  %673 = phi i64 [ %690, %669 ], [ %744, %687 ]
  %674 = phi i64 [ %704, %669 ], [ %743, %687 ]
  %675 = icmp sgt i64 %674, 0
  br i1 %675, label %742, label %624

676:                                              ; preds = %742
  %677 = fmul double %752, %670
  %678 = fmul double %754, %671
  %679 = fadd double %677, %678
  %680 = fmul double %752, %671
  %681 = fmul double %754, %670
  %682 = fsub double %680, %681
  store double %682, ptr %751, align 8, !noalias !49
  store double %679, ptr %753, align 8, !noalias !49
  br label %683

683:                                              ; preds = %758, %676
  %684 = phi i64 [ %690, %676 ], [ %777, %758 ]
  %685 = phi i64 [ %704, %676 ], [ %778, %758 ]
  %686 = icmp sgt i64 %685, 0
  br i1 %686, label %758, label %687

687:                                              ; preds = %742, %683
  br label %672

688:                                              ; preds = %624
  %689 = add nsw i64 %626, -1
  %690 = add i64 %625, 1
  %691 = icmp slt i64 %625, 0
  %692 = select i1 %691, i64 %218, i64 0
  %693 = add i64 %625, %692
  %694 = select i1 %691, i64 %220, i64 0
  %695 = mul i64 %693, %220
  %696 = getelementptr { double, double }, ptr %221, i64 %695
  %697 = getelementptr { double, double }, ptr %696, i64 %625
  %698 = getelementptr { double, double }, ptr %697, i64 %694
  %699 = load double, ptr %698, align 8, !noalias !49
  %700 = getelementptr inbounds nuw i8, ptr %698, i64 8
  %701 = load double, ptr %700, align 8, !noalias !49
  %702 = call double @hypot(double %699, double %701) #3, !noalias !53
  %703 = sub i64 %218, %690
  %704 = call i64 @llvm.smax.i64(i64 %703, i64 0)
  br label %628

705:                                              ; preds = %628
  %706 = icmp slt i64 %629, 0
  %707 = select i1 %706, i64 %218, i64 0
  %708 = add i64 %629, %707
  %709 = mul i64 %708, %220
  %710 = getelementptr { double, double }, ptr %221, i64 %709
  %711 = getelementptr { double, double }, ptr %710, i64 %625
  %712 = getelementptr { double, double }, ptr %711, i64 %694
  %713 = load double, ptr %712, align 8, !noalias !49
  %714 = getelementptr inbounds nuw i8, ptr %712, i64 8
  %715 = load double, ptr %714, align 8, !noalias !49
  %716 = call double @hypot(double %713, double %715) #3, !noalias !59
  %717 = add i64 %629, 1
  %718 = add nsw i64 %630, -1
  %719 = fcmp ogt double %716, %631
  %720 = select i1 %719, double %716, double %631
  %721 = select i1 %719, i64 %629, i64 %632
  br label %628

722:                                              ; preds = %641
  %723 = add nsw i64 %643, -1
  %724 = add i64 %642, 1
  %725 = icmp slt i64 %632, 0
  %726 = select i1 %725, i64 %218, i64 0
  %727 = add i64 %632, %726
  %728 = icmp slt i64 %642, 0
  %729 = select i1 %728, i64 %220, i64 0
  %730 = mul i64 %727, %220
  %731 = getelementptr { double, double }, ptr %221, i64 %730
  %732 = getelementptr { double, double }, ptr %731, i64 %642
  %733 = getelementptr { double, double }, ptr %732, i64 %729
  %734 = load double, ptr %733, align 8, !noalias !49
  %735 = getelementptr inbounds nuw i8, ptr %733, i64 8
  %736 = load double, ptr %735, align 8, !noalias !49
  %737 = getelementptr { double, double }, ptr %696, i64 %642
  %738 = getelementptr { double, double }, ptr %737, i64 %729
  %739 = load double, ptr %738, align 8, !noalias !49
  %740 = getelementptr inbounds nuw i8, ptr %738, i64 8
  %741 = load double, ptr %740, align 8, !noalias !49
  store double %734, ptr %738, align 8, !noalias !49
  store double %736, ptr %740, align 8, !noalias !49
  store double %739, ptr %733, align 8, !noalias !49
  store double %741, ptr %735, align 8, !noalias !49
  br label %641

742:                                              ; preds = %672
  %743 = add nsw i64 %674, -1
  %744 = add i64 %673, 1
  %745 = icmp slt i64 %673, 0
  %746 = select i1 %745, i64 %218, i64 0
  %747 = add i64 %673, %746
  %748 = mul i64 %747, %220
  %749 = getelementptr { double, double }, ptr %221, i64 %748
  %750 = getelementptr { double, double }, ptr %749, i64 %625
  %751 = getelementptr { double, double }, ptr %750, i64 %694
  %752 = load double, ptr %751, align 8, !noalias !49
  %753 = getelementptr inbounds nuw i8, ptr %751, i64 8
  %754 = load double, ptr %753, align 8, !noalias !49
  %755 = fcmp une double %752, 0.000000e+00
  %756 = fcmp une double %754, 0.000000e+00
  %757 = or i1 %755, %756
  br i1 %757, label %676, label %687

758:                                              ; preds = %683
  %759 = icmp slt i64 %684, 0
  %760 = select i1 %759, i64 %220, i64 0
  %761 = getelementptr { double, double }, ptr %749, i64 %684
  %762 = getelementptr { double, double }, ptr %761, i64 %760
  %763 = load double, ptr %762, align 8, !noalias !49
  %764 = getelementptr inbounds nuw i8, ptr %762, i64 8
  %765 = load double, ptr %764, align 8, !noalias !49
  %766 = getelementptr { double, double }, ptr %696, i64 %684
  %767 = getelementptr { double, double }, ptr %766, i64 %760
  %768 = load double, ptr %767, align 8, !noalias !49
  %769 = getelementptr inbounds nuw i8, ptr %767, i64 8
  %770 = load double, ptr %769, align 8, !noalias !49
  %771 = fmul double %682, %770
  %772 = fmul double %679, %768
  %773 = fadd double %771, %772
  %774 = fmul double %682, %768
  %775 = fmul double %679, %770
  %776 = fsub double %774, %775
  %777 = add i64 %684, 1
  %778 = add nsw i64 %685, -1
  %779 = fsub double %763, %776
  %780 = fsub double %765, %773
  store double %779, ptr %762, align 8, !noalias !49
  store double %780, ptr %764, align 8, !noalias !49
  br label %683

781:                                              ; preds = %624
  store i64 1, ptr %469, align 8, !noalias !22
  store double %410, ptr %199, align 8, !noalias !22
  br label %790

782:                                              ; preds = %526, %634
  %783 = load i64, ptr %393, align 8, !noalias !22
  %784 = add nsw i64 %783, 1
  %785 = fmul double %410, 5.000000e-01
  %786 = getelementptr i8, ptr %110, i64 72
  store i64 4, ptr %786, align 8, !noalias !22
  store i64 %784, ptr %393, align 8, !noalias !22
  %787 = getelementptr i8, ptr %196, i64 16
  %788 = load i64, ptr %787, align 8, !noalias !22
  %789 = sub nsw i64 1, %788
  store i64 %789, ptr %418, align 8, !noalias !22
  store i64 0, ptr %469, align 8, !noalias !22
  br label %2448

790:                                              ; preds = %781, %472
  %791 = getelementptr i8, ptr %199, i64 8
  %792 = load double, ptr %791, align 8, !noalias !22
  br label %793

793:                                              ; preds = %808, %790
  %794 = phi i64 [ 0, %790 ], [ %2588, %808 ]
  %795 = phi i64 [ 3, %790 ], [ %2587, %808 ]
  %796 = icmp sgt i64 %795, 0
  br i1 %796, label %2586, label %862

797:                                              ; preds = %2586
  %798 = icmp slt i64 %794, 0
  %799 = add i64 %794, 3
  %800 = select i1 %798, i64 %799, i64 %794
  %801 = getelementptr double, ptr @0, i64 %800
  %802 = load double, ptr %801, align 8, !noalias !22
  %803 = fmul double %802, %410
  %804 = fdiv double %803, %792
  %805 = fadd double %804, 1.000000e+00
  br label %806

806:                                              ; preds = %2586, %797
  %807 = phi double [ %805, %797 ], [ 0.000000e+00, %2586 ]
  br label %808

808:                                              ; preds = %806, %852, %812
  %809 = phi i64 [ 0, %806 ], [ %2592, %812 ], [ %2592, %852 ]
  %810 = phi i64 [ %292, %806 ], [ %2591, %812 ], [ %2591, %852 ]
  %811 = icmp sgt i64 %810, 0
  br i1 %811, label %2590, label %793

812:                                              ; preds = %2590
  %813 = fsub double 1.000000e+00, %807
  %814 = icmp slt i64 %809, 0
  %815 = select i1 %814, i64 %256, i64 0
  %816 = shl i64 %256, 4
  %817 = getelementptr i8, ptr %257, i64 %816
  %818 = getelementptr double, ptr %817, i64 %809
  %819 = getelementptr double, ptr %818, i64 %815
  %820 = load double, ptr %819, align 8, !noalias !22
  %821 = mul i64 %256, 24
  %822 = getelementptr i8, ptr %257, i64 %821
  %823 = getelementptr double, ptr %822, i64 %809
  %824 = getelementptr double, ptr %823, i64 %815
  %825 = load double, ptr %824, align 8, !noalias !22
  %826 = fmul double %807, %825
  %827 = fadd double %820, %826
  %828 = fmul double %813, %827
  %829 = getelementptr double, ptr %257, i64 %809
  %830 = getelementptr double, ptr %829, i64 %815
  %831 = load double, ptr %830, align 8, !noalias !22
  %832 = getelementptr double, ptr %257, i64 %256
  %833 = getelementptr double, ptr %832, i64 %809
  %834 = getelementptr double, ptr %833, i64 %815
  %835 = load double, ptr %834, align 8, !noalias !22
  %836 = fadd double %835, %828
  %837 = fmul double %807, %836
  %838 = fadd double %831, %837
  %839 = select i1 %814, i64 %64, i64 0
  %840 = getelementptr double, ptr %65, i64 %809
  %841 = getelementptr double, ptr %840, i64 %839
  %842 = load double, ptr %841, align 8, !noalias !22
  %843 = fsub double %838, %842
  %844 = icmp slt i64 %794, 0
  %845 = select i1 %844, i64 %235, i64 0
  %846 = add i64 %794, %845
  %847 = select i1 %814, i64 %237, i64 0
  %848 = mul i64 %846, %237
  %849 = getelementptr double, ptr %238, i64 %848
  %850 = getelementptr double, ptr %849, i64 %809
  %851 = getelementptr double, ptr %850, i64 %847
  store double %843, ptr %851, align 8, !noalias !22
  br label %808

852:                                              ; preds = %2590
  %853 = icmp slt i64 %794, 0
  %854 = select i1 %853, i64 %235, i64 0
  %855 = add i64 %794, %854
  %856 = icmp slt i64 %809, 0
  %857 = select i1 %856, i64 %237, i64 0
  %858 = mul i64 %855, %237
  %859 = getelementptr double, ptr %238, i64 %858
  %860 = getelementptr double, ptr %859, i64 %809
  %861 = getelementptr double, ptr %860, i64 %857
  store double 0.000000e+00, ptr %861, align 8, !noalias !22
  br label %808

862:                                              ; preds = %793, %866
  %863 = phi i64 [ %2595, %866 ], [ 0, %793 ]
  %864 = phi i64 [ %2594, %866 ], [ 3, %793 ]
  %865 = icmp sgt i64 %864, 0
  br i1 %865, label %2593, label %870

866:                                              ; preds = %2593, %2596
  %867 = phi i64 [ 0, %2593 ], [ %2598, %2596 ]
  %868 = phi i64 [ %292, %2593 ], [ %2597, %2596 ]
  %869 = icmp sgt i64 %868, 0
  br i1 %869, label %2596, label %862

870:                                              ; preds = %862
  %871 = fmul double %306, %296
  store ptr null, ptr %12, align 8, !noalias !65
  %872 = load i64, ptr %116, align 8, !noalias !65
  %873 = getelementptr i8, ptr %196, i64 40
  %874 = load i64, ptr %873, align 8, !noalias !65
  %875 = icmp sgt i64 %874, 0
  %876 = select i1 %875, i64 10, i64 6
  br label %877

877:                                              ; preds = %1338, %870
  %878 = phi i64 [ 0, %870 ], [ %1348, %1338 ]
  %879 = phi i64 [ %876, %870 ], [ %1349, %1338 ]
  %880 = phi double [ -1.000000e+00, %870 ], [ %1193, %1338 ]
  %881 = phi double [ 0.000000e+00, %870 ], [ %1238, %1338 ]
  %882 = phi i64 [ 0, %870 ], [ %1257, %1338 ]
  %883 = icmp sgt i64 %879, 0
  br i1 %883, label %1344, label %1347

884:                                              ; preds = %1347
  %885 = icmp sgt i64 %1351, 5
  %886 = icmp eq i64 %882, 0
  %887 = and i1 %885, %886
  br i1 %887, label %1339, label %888

888:                                              ; preds = %1377, %884
  %889 = phi i64 [ %1354, %1377 ], [ 0, %884 ]
  %890 = phi i64 [ %1353, %1377 ], [ 3, %884 ]
  %891 = icmp sgt i64 %890, 0
  br i1 %891, label %1352, label %926

892:                                              ; preds = %1356, %1352
  %893 = phi i64 [ 0, %1352 ], [ %1358, %1356 ]
  %894 = phi i64 [ %1355, %1352 ], [ %1357, %1356 ]
  %895 = icmp sgt i64 %894, 0
  br i1 %895, label %1356, label %896

896:                                              ; preds = %892
  %897 = getelementptr i8, ptr %110, i64 24
  %898 = load i64, ptr %897, align 8, !noalias !65
  %899 = add nsw i64 %898, 1
  store i64 %899, ptr %897, align 8, !noalias !65
  %900 = icmp slt i64 %889, 0
  %901 = add i64 %889, 3
  %902 = select i1 %900, i64 %901, i64 %889
  %903 = getelementptr double, ptr @4, i64 %902
  %904 = load double, ptr %903, align 8, !noalias !65
  %905 = fmul double %410, %904
  %906 = fadd double %376, %905
  %907 = mul nsw i64 %889, %872
  %908 = shl i64 %907, 3
  %909 = add i64 %908, %247
  store ptr null, ptr %10, align 8, !noalias !69
  store ptr null, ptr %11, align 8, !noalias !69
  store double %906, ptr %33, align 8, !noalias !69
  %910 = icmp sgt i64 %45, 0
  br i1 %910, label %911, label %914

911:                                              ; preds = %896
  store ptr null, ptr %10, align 8, !noalias !69
  %912 = call fastcc i32 @_sample(ptr nonnull %10, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %906) #3
  switch i32 %912, label %913 [
    i32 -2, label %914
    i32 0, label %914
  ], !prof !33

913:                                              ; preds = %911
  br label %914

914:                                              ; preds = %911, %911, %896, %913
  %915 = phi i32 [ %912, %913 ], [ 0, %896 ], [ 0, %911 ], [ 0, %911 ]
  switch i32 %915, label %921 [
    i32 -2, label %916
    i32 0, label %916
  ], !prof !33

916:                                              ; preds = %914, %914
  %917 = load i64, ptr %30, align 8, !noalias !76
  %918 = inttoptr i64 %917 to ptr
  %919 = inttoptr i64 %909 to ptr
  %920 = call i32 %918(ptr nonnull %33, ptr %75, ptr %38, ptr %41, ptr %919) #3, !noalias !76
  br label %921

921:                                              ; preds = %914, %916
  %922 = phi i32 [ %920, %916 ], [ 0, %914 ]
  %923 = phi i32 [ 0, %916 ], [ %915, %914 ]
  switch i32 %923, label %1896 [
    i32 -2, label %1377
    i32 0, label %1377
  ], !prof !33

924:                                              ; preds = %1377
  %925 = sext i32 %922 to i64
  br label %1896

926:                                              ; preds = %888
  %927 = call i64 @llvm.smax.i64(i64 %872, i64 0)
  br label %928

928:                                              ; preds = %933, %926
  %929 = phi i64 [ 0, %926 ], [ %934, %933 ]
  %930 = phi i64 [ %927, %926 ], [ %935, %933 ]
  %931 = phi double [ 0.000000e+00, %926 ], [ %1011, %933 ]
  %932 = icmp sgt i64 %930, 0
  br i1 %932, label %1379, label %1012

933:                                              ; preds = %1379
  %934 = add i64 %929, 1
  %935 = add nsw i64 %930, -1
  %936 = fmul double %1384, 0x4010B70201A79C46
  %937 = fmul double %1388, 0x3FD4F8C15DA84E86
  %938 = fadd double %936, %937
  %939 = fmul double %1394, 0x3FE0BF7FF59D56EF
  %940 = fadd double %938, %939
  %941 = fdiv double 0x400D1A48D83E731D, %410
  %942 = select i1 %1380, i64 %244, i64 0
  %943 = getelementptr double, ptr %245, i64 %929
  %944 = getelementptr double, ptr %943, i64 %942
  %945 = load double, ptr %944, align 8, !noalias !65
  %946 = fmul double %941, %945
  %947 = fsub double %940, %946
  %948 = select i1 %1380, i64 %261, i64 0
  %949 = getelementptr double, ptr %262, i64 %929
  %950 = getelementptr double, ptr %949, i64 %948
  store double %947, ptr %950, align 8, !noalias !65
  %951 = load double, ptr %1383, align 8, !noalias !65
  %952 = fmul double %951, 0xC010B70201A79C46
  %953 = load double, ptr %1387, align 8, !noalias !65
  %954 = fmul double %953, 0xBFD4F8C15DA84E86
  %955 = fadd double %952, %954
  %956 = load double, ptr %1393, align 8, !noalias !65
  %957 = fmul double %956, 0x3FDE810014C55221
  %958 = fadd double %955, %957
  %959 = fmul double %951, 0x3FE017885A24A7F2
  %960 = fmul double %953, 0xC004934E6FCAA598
  %961 = fadd double %959, %960
  %962 = fmul double %956, 0x3FE312C0CF7BDFD1
  %963 = fadd double %961, %962
  %964 = fdiv double 0x400572DB93E0C672, %410
  %965 = fdiv double 0xC0086747F2C3FCB6, %410
  %966 = getelementptr double, ptr %245, i64 %244
  %967 = getelementptr double, ptr %966, i64 %929
  %968 = getelementptr double, ptr %967, i64 %942
  %969 = load double, ptr %968, align 8, !noalias !65
  %970 = shl i64 %244, 4
  %971 = getelementptr i8, ptr %245, i64 %970
  %972 = getelementptr double, ptr %971, i64 %929
  %973 = getelementptr double, ptr %972, i64 %942
  %974 = load double, ptr %973, align 8, !noalias !65
  %975 = fmul double %964, %974
  %976 = fmul double %965, %969
  %977 = fadd double %975, %976
  %978 = fmul double %964, %969
  %979 = fmul double %965, %974
  %980 = fsub double %978, %979
  %981 = fsub double %958, %980
  %982 = fsub double %963, %977
  %983 = select i1 %1380, i64 %266, i64 0
  %984 = getelementptr { double, double }, ptr %267, i64 %929
  %985 = getelementptr { double, double }, ptr %984, i64 %983
  store double %981, ptr %985, align 8, !noalias !65
  %986 = getelementptr inbounds nuw i8, ptr %985, i64 8
  store double %982, ptr %986, align 8, !noalias !65
  %987 = load double, ptr %950, align 8, !noalias !65
  %988 = call double @llvm.fabs.f64(double %987)
  %989 = call double @llvm.fabs.f64(double %981)
  %990 = fadd double %988, %989
  %991 = call double @llvm.fabs.f64(double %982)
  %992 = fadd double %990, %991
  %993 = fmul double %410, %992
  %994 = select i1 %1380, i64 %64, i64 0
  %995 = getelementptr double, ptr %65, i64 %929
  %996 = getelementptr double, ptr %995, i64 %994
  %997 = load double, ptr %996, align 8, !noalias !65
  %998 = select i1 %1380, i64 %99, i64 0
  %999 = getelementptr double, ptr %100, i64 %929
  %1000 = getelementptr double, ptr %999, i64 %998
  %1001 = load double, ptr %1000, align 8, !noalias !77
  %1002 = select i1 %1380, i64 %94, i64 0
  %1003 = getelementptr double, ptr %95, i64 %929
  %1004 = getelementptr double, ptr %1003, i64 %1002
  %1005 = load double, ptr %1004, align 8, !noalias !77
  %1006 = call double @llvm.fabs.f64(double %997)
  %1007 = fmul double %1005, %1006
  %1008 = fadd double %1001, %1007
  %1009 = fdiv double %993, %1008
  %1010 = fmul double %1009, %1009
  %1011 = fadd double %931, %1010
  br label %928

1012:                                             ; preds = %928
  store ptr null, ptr %12, align 8, !noalias !65
  %1013 = call fastcc i32 @solve(ptr nonnull %12, ptr %214, i64 %211, i64 %213, ptr %226, i64 %225, ptr %262, i64 %261) #3, !noalias !65
  switch i32 %1013, label %1896 [
    i32 -2, label %1398
    i32 0, label %1398
  ], !prof !33

1014:                                             ; preds = %1568
  %1015 = call i64 @llvm.smax.i64(i64 %211, i64 0)
  br label %1016

1016:                                             ; preds = %1029, %1014
  %1017 = phi i64 [ 0, %1014 ], [ %1075, %1029 ]
  %1018 = phi i64 [ %1015, %1014 ], [ %1074, %1029 ]
  %1019 = icmp sgt i64 %1018, 0
  br i1 %1019, label %1073, label %1030

1020:                                             ; preds = %1073
  %1021 = mul nsw i64 %1017, %874
  %1022 = add nsw i64 %211, %1021
  %1023 = mul nsw i64 %1080, %874
  %1024 = add nsw i64 %211, %1023
  br label %1025

1025:                                             ; preds = %1082, %1020
  %1026 = phi i64 [ 0, %1020 ], [ %1084, %1082 ]
  %1027 = phi i64 [ %874, %1020 ], [ %1083, %1082 ]
  %1028 = icmp sgt i64 %1027, 0
  br i1 %1028, label %1082, label %1029

1029:                                             ; preds = %1073, %1025
  br label %1016

1030:                                             ; preds = %1016, %1034
  %1031 = phi i64 [ %1099, %1034 ], [ 0, %1016 ]
  %1032 = phi i64 [ %1098, %1034 ], [ %1015, %1016 ]
  %1033 = icmp sgt i64 %1032, 0
  br i1 %1033, label %1097, label %1042

1034:                                             ; preds = %1097, %1038
  %1035 = phi i64 [ 0, %1097 ], [ %1103, %1038 ]
  %1036 = phi i64 [ %1100, %1097 ], [ %1102, %1038 ]
  %1037 = icmp sgt i64 %1036, 0
  br i1 %1037, label %1101, label %1030

1038:                                             ; preds = %1118, %1101
  %1039 = phi i64 [ 0, %1101 ], [ %1120, %1118 ]
  %1040 = phi i64 [ %874, %1101 ], [ %1119, %1118 ]
  %1041 = icmp sgt i64 %1040, 0
  br i1 %1041, label %1118, label %1034

1042:                                             ; preds = %1030
  %1043 = icmp ugt i64 %211, -9223372036854775808
  %1044 = select i1 %1043, i64 0, i64 %211
  br label %1045

1045:                                             ; preds = %1069, %1042
  %1046 = phi i64 [ %211, %1042 ], [ %1048, %1069 ]
  %1047 = phi i64 [ %1044, %1042 ], [ %1136, %1069 ]
  %1048 = add i64 %1046, -1
  %1049 = icmp sgt i64 %1047, 0
  br i1 %1049, label %1135, label %1569

1050:                                             ; preds = %1135, %1054
  %1051 = phi i64 [ %1046, %1135 ], [ %1143, %1054 ]
  %1052 = phi i64 [ %1140, %1135 ], [ %1142, %1054 ]
  %1053 = icmp sgt i64 %1052, 0
  br i1 %1053, label %1141, label %1058

1054:                                             ; preds = %1156, %1141
  %1055 = phi i64 [ 0, %1141 ], [ %1158, %1156 ]
  %1056 = phi i64 [ %874, %1141 ], [ %1157, %1156 ]
  %1057 = icmp sgt i64 %1056, 0
  br i1 %1057, label %1156, label %1050

1058:                                             ; preds = %1050
  %1059 = icmp slt i64 %1048, 0
  %1060 = select i1 %1059, i64 %211, i64 0
  %1061 = add i64 %1048, %1060
  %1062 = select i1 %1059, i64 %213, i64 0
  %1063 = mul i64 %1061, %213
  %1064 = getelementptr double, ptr %214, i64 %1063
  %1065 = getelementptr double, ptr %1064, i64 %1048
  %1066 = getelementptr double, ptr %1065, i64 %1062
  %1067 = load double, ptr %1066, align 8, !noalias !80
  %1068 = fdiv double 1.000000e+00, %1067
  br label %1069

1069:                                             ; preds = %1173, %1058
  %1070 = phi i64 [ 0, %1058 ], [ %1175, %1173 ]
  %1071 = phi i64 [ %874, %1058 ], [ %1174, %1173 ]
  %1072 = icmp sgt i64 %1071, 0
  br i1 %1072, label %1173, label %1045

1073:                                             ; preds = %1016
  %1074 = add nsw i64 %1018, -1
  %1075 = add i64 %1017, 1
  %1076 = icmp slt i64 %1017, 0
  %1077 = select i1 %1076, i64 %225, i64 0
  %1078 = getelementptr i64, ptr %226, i64 %1017
  %1079 = getelementptr i64, ptr %1078, i64 %1077
  %1080 = load i64, ptr %1079, align 8, !noalias !80
  %1081 = icmp eq i64 %1080, %1017
  br i1 %1081, label %1029, label %1020

1082:                                             ; preds = %1025
  %1083 = add nsw i64 %1027, -1
  %1084 = add i64 %1026, 1
  %1085 = add nsw i64 %1024, %1026
  %1086 = icmp slt i64 %1085, 0
  %1087 = select i1 %1086, i64 %261, i64 0
  %1088 = getelementptr double, ptr %262, i64 %1085
  %1089 = getelementptr double, ptr %1088, i64 %1087
  %1090 = load double, ptr %1089, align 8, !noalias !80
  %1091 = add nsw i64 %1022, %1026
  %1092 = icmp slt i64 %1091, 0
  %1093 = select i1 %1092, i64 %261, i64 0
  %1094 = getelementptr double, ptr %262, i64 %1091
  %1095 = getelementptr double, ptr %1094, i64 %1093
  %1096 = load double, ptr %1095, align 8, !noalias !80
  store double %1090, ptr %1095, align 8, !noalias !80
  store double %1096, ptr %1089, align 8, !noalias !80
  br label %1025

1097:                                             ; preds = %1030
  %1098 = add nsw i64 %1032, -1
  %1099 = add i64 %1031, 1
  %1100 = call i64 @llvm.smax.i64(i64 %1031, i64 0)
  br label %1034

1101:                                             ; preds = %1034
  %1102 = add nsw i64 %1036, -1
  %1103 = add i64 %1035, 1
  %1104 = icmp slt i64 %1031, 0
  %1105 = select i1 %1104, i64 %211, i64 0
  %1106 = add i64 %1031, %1105
  %1107 = icmp slt i64 %1035, 0
  %1108 = select i1 %1107, i64 %213, i64 0
  %1109 = mul i64 %1106, %213
  %1110 = getelementptr double, ptr %214, i64 %1109
  %1111 = getelementptr double, ptr %1110, i64 %1035
  %1112 = getelementptr double, ptr %1111, i64 %1108
  %1113 = load double, ptr %1112, align 8, !noalias !80
  %1114 = mul nsw i64 %1031, %874
  %1115 = add nsw i64 %211, %1114
  %1116 = mul nsw i64 %1035, %874
  %1117 = add nsw i64 %211, %1116
  br label %1038

1118:                                             ; preds = %1038
  %1119 = add nsw i64 %1040, -1
  %1120 = add i64 %1039, 1
  %1121 = add nsw i64 %1115, %1039
  %1122 = icmp slt i64 %1121, 0
  %1123 = select i1 %1122, i64 %261, i64 0
  %1124 = getelementptr double, ptr %262, i64 %1121
  %1125 = getelementptr double, ptr %1124, i64 %1123
  %1126 = load double, ptr %1125, align 8, !noalias !80
  %1127 = add nsw i64 %1117, %1039
  %1128 = icmp slt i64 %1127, 0
  %1129 = select i1 %1128, i64 %261, i64 0
  %1130 = getelementptr double, ptr %262, i64 %1127
  %1131 = getelementptr double, ptr %1130, i64 %1129
  %1132 = load double, ptr %1131, align 8, !noalias !80
  %1133 = fmul double %1113, %1132
  %1134 = fsub double %1126, %1133
  store double %1134, ptr %1125, align 8, !noalias !80
  br label %1038

1135:                                             ; preds = %1045
  %1136 = add nsw i64 %1047, -1
  %1137 = mul nsw i64 %1048, %874
  %1138 = add nsw i64 %211, %1137
  %1139 = sub i64 %211, %1046
  %1140 = call i64 @llvm.smax.i64(i64 %1139, i64 0)
  br label %1050

1141:                                             ; preds = %1050
  %1142 = add nsw i64 %1052, -1
  %1143 = add i64 %1051, 1
  %1144 = icmp slt i64 %1048, 0
  %1145 = select i1 %1144, i64 %211, i64 0
  %1146 = add i64 %1048, %1145
  %1147 = icmp slt i64 %1051, 0
  %1148 = select i1 %1147, i64 %213, i64 0
  %1149 = mul i64 %1146, %213
  %1150 = getelementptr double, ptr %214, i64 %1149
  %1151 = getelementptr double, ptr %1150, i64 %1051
  %1152 = getelementptr double, ptr %1151, i64 %1148
  %1153 = load double, ptr %1152, align 8, !noalias !80
  %1154 = mul nsw i64 %1051, %874
  %1155 = add nsw i64 %211, %1154
  br label %1054

1156:                                             ; preds = %1054
  %1157 = add nsw i64 %1056, -1
  %1158 = add i64 %1055, 1
  %1159 = add nsw i64 %1138, %1055
  %1160 = icmp slt i64 %1159, 0
  %1161 = select i1 %1160, i64 %261, i64 0
  %1162 = getelementptr double, ptr %262, i64 %1159
  %1163 = getelementptr double, ptr %1162, i64 %1161
  %1164 = load double, ptr %1163, align 8, !noalias !80
  %1165 = add nsw i64 %1155, %1055
  %1166 = icmp slt i64 %1165, 0
  %1167 = select i1 %1166, i64 %261, i64 0
  %1168 = getelementptr double, ptr %262, i64 %1165
  %1169 = getelementptr double, ptr %1168, i64 %1167
  %1170 = load double, ptr %1169, align 8, !noalias !80
  %1171 = fmul double %1153, %1170
  %1172 = fsub double %1164, %1171
  store double %1172, ptr %1163, align 8, !noalias !80
  br label %1054

1173:                                             ; preds = %1069
  %1174 = add nsw i64 %1071, -1
  %1175 = add i64 %1070, 1
  %1176 = add nsw i64 %1138, %1070
  %1177 = icmp slt i64 %1176, 0
  %1178 = select i1 %1177, i64 %261, i64 0
  %1179 = getelementptr double, ptr %262, i64 %1176
  %1180 = getelementptr double, ptr %1179, i64 %1178
  %1181 = load double, ptr %1180, align 8, !noalias !80
  %1182 = fmul double %1181, %1068
  store double %1182, ptr %1180, align 8, !noalias !80
  br label %1069

1183:                                             ; preds = %1595, %1568
  br label %1184

1184:                                             ; preds = %1793, %1183
  %1185 = phi i64 [ 0, %1183 ], [ %1795, %1793 ]
  %1186 = phi i64 [ %927, %1183 ], [ %1794, %1793 ]
  %1187 = phi double [ 0.000000e+00, %1183 ], [ %1830, %1793 ]
  %1188 = icmp sgt i64 %1186, 0
  br i1 %1188, label %1793, label %1189

1189:                                             ; preds = %1184
  %1190 = mul nsw i64 %872, 3
  %1191 = sitofp i64 %1190 to double
  %1192 = fdiv double %1187, %1191
  %1193 = call double @sqrt(double %1192), !noalias !65
  %1194 = fcmp oeq double %1193, 0.000000e+00
  %1195 = fcmp ogt double %931, 0.000000e+00
  %1196 = select i1 %1194, i1 %1195, i1 false
  br i1 %1196, label %1896, label %1197

1197:                                             ; preds = %1189
  %1198 = fcmp ogt double %880, 0.000000e+00
  %1199 = and i1 %1198, %886
  br i1 %1199, label %1200, label %1237

1200:                                             ; preds = %1197
  %1201 = fdiv double %1193, %880
  %1202 = sub nsw i64 5, %1351
  %1203 = add nsw i64 %1351, -5
  %1204 = select i1 %885, i64 %1203, i64 %1202
  %1205 = icmp samesign ugt i64 %1204, 65536
  br i1 %1205, label %1206, label %1209

1206:                                             ; preds = %1200
  %1207 = sitofp i64 %1202 to double
  %1208 = call double @llvm.pow.f64(double %1201, double %1207)
  br label %1228

1209:                                             ; preds = %1200
  %1210 = icmp eq i64 %1204, 0
  br i1 %1210, label %1222, label %1211

1211:                                             ; preds = %1211, %1209
  %1212 = phi double [ %1218, %1211 ], [ 1.000000e+00, %1209 ]
  %1213 = phi double [ %1220, %1211 ], [ %1201, %1209 ]
  %1214 = phi i64 [ %1219, %1211 ], [ %1204, %1209 ]
  %1215 = and i64 %1214, 1
  %1216 = icmp eq i64 %1215, 0
  %1217 = fmul double %1212, %1213
  %1218 = select i1 %1216, double %1212, double %1217
  %1219 = lshr i64 %1214, 1
  %1220 = fmul double %1213, %1213
  %1221 = icmp eq i64 %1219, 0
  br i1 %1221, label %1222, label %1211

1222:                                             ; preds = %1211, %1209
  %1223 = phi double [ %1218, %1211 ], [ 1.000000e+00, %1209 ]
  br i1 %885, label %1224, label %1228

1224:                                             ; preds = %1222
  %1225 = fcmp oeq double %1223, 0.000000e+00
  br i1 %1225, label %1228, label %1226, !prof !4

1226:                                             ; preds = %1224
  %1227 = fdiv double 1.000000e+00, %1223
  br label %1228

1228:                                             ; preds = %1224, %1222, %1206, %1226
  %1229 = phi double [ 0.000000e+00, %1224 ], [ %1208, %1206 ], [ %1223, %1222 ], [ %1227, %1226 ]
  %1230 = phi i1 [ false, %1224 ], [ true, %1206 ], [ true, %1222 ], [ true, %1226 ]
  %1231 = phi i32 [ 1, %1224 ], [ 0, %1206 ], [ 0, %1222 ], [ 0, %1226 ]
  br i1 %1230, label %1831, label %1896, !prof !83

1232:                                             ; preds = %1831
  %1233 = fsub double 1.000000e+00, %1201
  %1234 = fdiv double %1229, %1233
  %1235 = fmul double %1234, %1193
  %1236 = fcmp ogt double %1235, %306
  br i1 %1236, label %1896, label %1237

1237:                                             ; preds = %1232, %1197
  %1238 = phi double [ %1201, %1232 ], [ %881, %1197 ]
  br label %1239

1239:                                             ; preds = %1243, %1237
  %1240 = phi i64 [ 0, %1237 ], [ %1835, %1243 ]
  %1241 = phi i64 [ %927, %1237 ], [ %1834, %1243 ]
  %1242 = icmp sgt i64 %1241, 0
  br i1 %1242, label %1833, label %1247

1243:                                             ; preds = %1863, %1833
  %1244 = phi i64 [ 0, %1833 ], [ %1865, %1863 ]
  %1245 = phi i64 [ 3, %1833 ], [ %1864, %1863 ]
  %1246 = icmp sgt i64 %1245, 0
  br i1 %1246, label %1863, label %1239

1247:                                             ; preds = %1239
  br i1 %886, label %1248, label %1256

1248:                                             ; preds = %1247
  br i1 %1194, label %1255, label %1249

1249:                                             ; preds = %1248
  br i1 %1198, label %1250, label %1256

1250:                                             ; preds = %1249
  %1251 = fsub double 1.000000e+00, %1238
  %1252 = fdiv double %1238, %1251
  %1253 = fmul double %1252, %1193
  %1254 = fcmp olt double %1253, %306
  br i1 %1254, label %1255, label %1256

1255:                                             ; preds = %1250, %1248
  br label %1256

1256:                                             ; preds = %1255, %1250, %1249, %1247
  %1257 = phi i64 [ %1350, %1255 ], [ 0, %1250 ], [ 0, %1249 ], [ %882, %1247 ]
  %1258 = icmp sgt i64 %1257, 0
  br i1 %1258, label %1259, label %1338

1259:                                             ; preds = %1256
  %1260 = icmp eq i64 %874, 0
  br i1 %1260, label %1339, label %1261

1261:                                             ; preds = %1259
  %1262 = load i64, ptr %873, align 8, !noalias !84
  %1263 = call i64 @llvm.smax.i64(i64 %1262, i64 0)
  br label %1264

1264:                                             ; preds = %1282, %1261
  %1265 = phi i64 [ 0, %1261 ], [ %1286, %1282 ]
  %1266 = phi i64 [ %1263, %1261 ], [ %1285, %1282 ]
  %1267 = phi double [ 0.000000e+00, %1261 ], [ %1283, %1282 ]
  %1268 = icmp sgt i64 %1266, 0
  br i1 %1268, label %1284, label %1893

1269:                                             ; preds = %1288, %1284
  %1270 = phi i64 [ 0, %1284 ], [ %1290, %1288 ]
  %1271 = phi i64 [ %1287, %1284 ], [ %1289, %1288 ]
  %1272 = phi double [ 0.000000e+00, %1284 ], [ %1312, %1288 ]
  %1273 = phi double [ 0.000000e+00, %1284 ], [ %1337, %1288 ]
  %1274 = icmp sgt i64 %1271, 0
  br i1 %1274, label %1288, label %1275

1275:                                             ; preds = %1269
  %1276 = fmul double %1267, %1273
  %1277 = fcmp ogt double %1272, %1276
  br i1 %1277, label %1278, label %1282

1278:                                             ; preds = %1275
  %1279 = fcmp ogt double %1273, 0.000000e+00
  %1280 = fdiv double %1272, %1273
  %1281 = select i1 %1279, double %1280, double 1.000000e+00
  br label %1282

1282:                                             ; preds = %1278, %1275
  %1283 = phi double [ %1281, %1278 ], [ %1267, %1275 ]
  br label %1264

1284:                                             ; preds = %1264
  %1285 = add nsw i64 %1266, -1
  %1286 = add i64 %1265, 1
  %1287 = call i64 @llvm.smax.i64(i64 %225, i64 0)
  br label %1269

1288:                                             ; preds = %1269
  %1289 = add nsw i64 %1271, -1
  %1290 = add i64 %1270, 1
  %1291 = mul nsw i64 %1270, %1262
  %1292 = add nsw i64 %225, %1291
  %1293 = add nsw i64 %1292, %1265
  %1294 = icmp slt i64 %1293, 0
  %1295 = select i1 %1294, i64 %261, i64 0
  %1296 = getelementptr double, ptr %262, i64 %1293
  %1297 = getelementptr double, ptr %1296, i64 %1295
  %1298 = load double, ptr %1297, align 8, !noalias !84
  %1299 = fmul double %1298, %1298
  %1300 = select i1 %1294, i64 %266, i64 0
  %1301 = getelementptr { double, double }, ptr %267, i64 %1293
  %1302 = getelementptr { double, double }, ptr %1301, i64 %1300
  %1303 = load double, ptr %1302, align 8, !noalias !84
  %1304 = getelementptr inbounds nuw i8, ptr %1302, i64 8
  %1305 = load double, ptr %1304, align 8, !noalias !84
  %1306 = call double @hypot(double %1303, double %1305) #3, !noalias !88
  %1307 = load double, ptr %1302, align 8, !noalias !84
  %1308 = load double, ptr %1304, align 8, !noalias !84
  %1309 = call double @hypot(double %1307, double %1308) #3, !noalias !94
  %1310 = fmul double %1306, %1309
  %1311 = fadd double %1299, %1310
  %1312 = fadd double %1272, %1311
  %1313 = select i1 %1294, i64 %64, i64 0
  %1314 = getelementptr double, ptr %65, i64 %1293
  %1315 = getelementptr double, ptr %1314, i64 %1313
  %1316 = load double, ptr %1315, align 8, !noalias !84
  %1317 = fmul double %1316, %1316
  %1318 = fadd double %1273, %1317
  %1319 = select i1 %1294, i64 %244, i64 0
  %1320 = getelementptr double, ptr %245, i64 %1293
  %1321 = getelementptr double, ptr %1320, i64 %1319
  %1322 = load double, ptr %1321, align 8, !noalias !84
  %1323 = fmul double %1322, %1322
  %1324 = getelementptr double, ptr %245, i64 %244
  %1325 = getelementptr double, ptr %1324, i64 %1293
  %1326 = getelementptr double, ptr %1325, i64 %1319
  %1327 = load double, ptr %1326, align 8, !noalias !84
  %1328 = fmul double %1327, %1327
  %1329 = fadd double %1323, %1328
  %1330 = shl i64 %244, 4
  %1331 = getelementptr i8, ptr %245, i64 %1330
  %1332 = getelementptr double, ptr %1331, i64 %1293
  %1333 = getelementptr double, ptr %1332, i64 %1319
  %1334 = load double, ptr %1333, align 8, !noalias !84
  %1335 = fmul double %1334, %1334
  %1336 = fadd double %1329, %1335
  %1337 = fadd double %1318, %1336
  br label %1269

1338:                                             ; preds = %1893, %1256
  br label %877

1339:                                             ; preds = %1893, %1347, %1259, %884
  %1340 = phi double [ %881, %1347 ], [ %881, %884 ], [ %1238, %1893 ], [ %1238, %1259 ]
  %1341 = phi i64 [ %882, %1347 ], [ 0, %884 ], [ %1257, %1893 ], [ %1257, %1259 ]
  %1342 = icmp slt i64 %1341, 1
  %1343 = select i1 %1342, i64 6, i64 %1341
  br label %1896

1344:                                             ; preds = %877
  %1345 = add nsw i64 %879, -1
  %1346 = add i64 %878, 1
  br label %1347

1347:                                             ; preds = %1344, %877
  %1348 = phi i64 [ %1346, %1344 ], [ %878, %877 ]
  %1349 = phi i64 [ %1345, %1344 ], [ %879, %877 ]
  %1350 = phi i64 [ %1346, %1344 ], [ 1, %877 ]
  %1351 = phi i64 [ %878, %1344 ], [ 0, %877 ]
  br i1 %883, label %884, label %1339

1352:                                             ; preds = %888
  %1353 = add nsw i64 %890, -1
  %1354 = add i64 %889, 1
  %1355 = call i64 @llvm.smax.i64(i64 %872, i64 0)
  br label %892

1356:                                             ; preds = %892
  %1357 = add nsw i64 %894, -1
  %1358 = add i64 %893, 1
  %1359 = icmp slt i64 %893, 0
  %1360 = select i1 %1359, i64 %64, i64 0
  %1361 = getelementptr double, ptr %65, i64 %893
  %1362 = getelementptr double, ptr %1361, i64 %1360
  %1363 = load double, ptr %1362, align 8, !noalias !65
  %1364 = icmp slt i64 %889, 0
  %1365 = select i1 %1364, i64 %235, i64 0
  %1366 = add i64 %889, %1365
  %1367 = select i1 %1359, i64 %237, i64 0
  %1368 = mul i64 %1366, %237
  %1369 = getelementptr double, ptr %238, i64 %1368
  %1370 = getelementptr double, ptr %1369, i64 %893
  %1371 = getelementptr double, ptr %1370, i64 %1367
  %1372 = load double, ptr %1371, align 8, !noalias !65
  %1373 = fadd double %1363, %1372
  %1374 = select i1 %1359, i64 %74, i64 0
  %1375 = getelementptr double, ptr %75, i64 %893
  %1376 = getelementptr double, ptr %1375, i64 %1374
  store double %1373, ptr %1376, align 8, !noalias !65
  br label %892

1377:                                             ; preds = %921, %921
  %1378 = icmp eq i32 %922, 0
  br i1 %1378, label %888, label %924

1379:                                             ; preds = %928
  %1380 = icmp slt i64 %929, 0
  %1381 = select i1 %1380, i64 %249, i64 0
  %1382 = getelementptr double, ptr %250, i64 %929
  %1383 = getelementptr double, ptr %1382, i64 %1381
  %1384 = load double, ptr %1383, align 8, !noalias !65
  %1385 = getelementptr double, ptr %250, i64 %249
  %1386 = getelementptr double, ptr %1385, i64 %929
  %1387 = getelementptr double, ptr %1386, i64 %1381
  %1388 = load double, ptr %1387, align 8, !noalias !65
  %1389 = fadd double %1384, %1388
  %1390 = shl i64 %249, 4
  %1391 = getelementptr i8, ptr %250, i64 %1390
  %1392 = getelementptr double, ptr %1391, i64 %929
  %1393 = getelementptr double, ptr %1392, i64 %1381
  %1394 = load double, ptr %1393, align 8, !noalias !65
  %1395 = fadd double %1389, %1394
  %1396 = fsub double %1395, %1395
  %1397 = fcmp ord double %1396, 0.000000e+00
  br i1 %1397, label %933, label %1896

1398:                                             ; preds = %1012, %1012
  %1399 = call i64 @llvm.smax.i64(i64 %218, i64 0)
  br label %1400

1400:                                             ; preds = %1418, %1398
  %1401 = phi i64 [ 0, %1398 ], [ %1483, %1418 ]
  %1402 = phi i64 [ %1399, %1398 ], [ %1482, %1418 ]
  %1403 = icmp sgt i64 %1402, 0
  br i1 %1403, label %1481, label %1419

1404:                                             ; preds = %1481
  %1405 = icmp slt i64 %1488, 0
  %1406 = select i1 %1405, i64 %266, i64 0
  %1407 = getelementptr { double, double }, ptr %267, i64 %1488
  %1408 = getelementptr { double, double }, ptr %1407, i64 %1406
  %1409 = load double, ptr %1408, align 8, !noalias !100
  %1410 = getelementptr inbounds nuw i8, ptr %1408, i64 8
  %1411 = load double, ptr %1410, align 8, !noalias !100
  %1412 = select i1 %1484, i64 %266, i64 0
  %1413 = getelementptr { double, double }, ptr %267, i64 %1401
  %1414 = getelementptr { double, double }, ptr %1413, i64 %1412
  %1415 = load double, ptr %1414, align 8, !noalias !100
  %1416 = getelementptr inbounds nuw i8, ptr %1414, i64 8
  %1417 = load double, ptr %1416, align 8, !noalias !100
  store double %1409, ptr %1414, align 8, !noalias !100
  store double %1411, ptr %1416, align 8, !noalias !100
  store double %1415, ptr %1408, align 8, !noalias !100
  store double %1417, ptr %1410, align 8, !noalias !100
  br label %1418

1418:                                             ; preds = %1481, %1404
  br label %1400

1419:                                             ; preds = %1400, %1429
  %1420 = phi i64 [ %1492, %1429 ], [ 0, %1400 ]
  %1421 = phi i64 [ %1491, %1429 ], [ %1399, %1400 ]
  %1422 = icmp sgt i64 %1421, 0
  br i1 %1422, label %1490, label %1430

1423:                                             ; preds = %1501, %1490
  %1424 = phi i64 [ 0, %1490 ], [ %1525, %1501 ]
  %1425 = phi i64 [ %1500, %1490 ], [ %1526, %1501 ]
  %1426 = phi double [ %1499, %1490 ], [ %1528, %1501 ]
  %1427 = phi double [ %1497, %1490 ], [ %1527, %1501 ]
  %1428 = icmp sgt i64 %1425, 0
  br i1 %1428, label %1501, label %1429

1429:                                             ; preds = %1423
  store double %1427, ptr %1496, align 8, !noalias !100
  store double %1426, ptr %1498, align 8, !noalias !100
  br label %1419

1430:                                             ; preds = %1419
  %1431 = icmp ugt i64 %218, -9223372036854775808
  %1432 = select i1 %1431, i64 0, i64 %218
  br label %1433

1433:                                             ; preds = %1478, %1430
  %1434 = phi i64 [ %218, %1430 ], [ %1436, %1478 ]
  %1435 = phi i64 [ %1432, %1430 ], [ %1530, %1478 ]
  %1436 = add i64 %1434, -1
  %1437 = icmp sgt i64 %1435, 0
  br i1 %1437, label %1529, label %1568

1438:                                             ; preds = %1540, %1529
  %1439 = phi i64 [ %1434, %1529 ], [ %1564, %1540 ]
  %1440 = phi i64 [ %1539, %1529 ], [ %1565, %1540 ]
  %1441 = phi double [ %1537, %1529 ], [ %1567, %1540 ]
  %1442 = phi double [ %1535, %1529 ], [ %1566, %1540 ]
  %1443 = icmp sgt i64 %1440, 0
  br i1 %1443, label %1540, label %1444

1444:                                             ; preds = %1438
  %1445 = select i1 %1531, i64 %218, i64 0
  %1446 = add i64 %1436, %1445
  %1447 = select i1 %1531, i64 %220, i64 0
  %1448 = mul i64 %1446, %220
  %1449 = getelementptr { double, double }, ptr %221, i64 %1448
  %1450 = getelementptr { double, double }, ptr %1449, i64 %1436
  %1451 = getelementptr { double, double }, ptr %1450, i64 %1447
  %1452 = load double, ptr %1451, align 8, !noalias !100
  %1453 = getelementptr inbounds nuw i8, ptr %1451, i64 8
  %1454 = load double, ptr %1453, align 8, !noalias !100
  %1455 = call double @llvm.fabs.f64(double %1452)
  %1456 = call double @llvm.fabs.f64(double %1454)
  %1457 = fcmp ult double %1455, %1456
  br i1 %1457, label %1468, label %1458

1458:                                             ; preds = %1444
  %1459 = fdiv double %1454, %1452
  %1460 = fmul double %1454, %1459
  %1461 = fadd double %1452, %1460
  %1462 = fmul double %1441, %1459
  %1463 = fadd double %1442, %1462
  %1464 = fdiv double %1463, %1461
  %1465 = fmul double %1442, %1459
  %1466 = fsub double %1441, %1465
  %1467 = fdiv double %1466, %1461
  br label %1478

1468:                                             ; preds = %1444
  %1469 = fdiv double %1452, %1454
  %1470 = fmul double %1452, %1469
  %1471 = fadd double %1470, %1454
  %1472 = fmul double %1442, %1469
  %1473 = fadd double %1472, %1441
  %1474 = fdiv double %1473, %1471
  %1475 = fmul double %1441, %1469
  %1476 = fsub double %1475, %1442
  %1477 = fdiv double %1476, %1471
  br label %1478

1478:                                             ; preds = %1468, %1458
  %1479 = phi double [ %1467, %1458 ], [ %1477, %1468 ]
  %1480 = phi double [ %1464, %1458 ], [ %1474, %1468 ]
  store double %1480, ptr %1534, align 8, !noalias !100
  store double %1479, ptr %1536, align 8, !noalias !100
  br label %1433

1481:                                             ; preds = %1400
  %1482 = add nsw i64 %1402, -1
  %1483 = add i64 %1401, 1
  %1484 = icmp slt i64 %1401, 0
  %1485 = select i1 %1484, i64 %230, i64 0
  %1486 = getelementptr i64, ptr %231, i64 %1401
  %1487 = getelementptr i64, ptr %1486, i64 %1485
  %1488 = load i64, ptr %1487, align 8, !noalias !100
  %1489 = icmp eq i64 %1488, %1401
  br i1 %1489, label %1418, label %1404

1490:                                             ; preds = %1419
  %1491 = add nsw i64 %1421, -1
  %1492 = add i64 %1420, 1
  %1493 = icmp slt i64 %1420, 0
  %1494 = select i1 %1493, i64 %266, i64 0
  %1495 = getelementptr { double, double }, ptr %267, i64 %1420
  %1496 = getelementptr { double, double }, ptr %1495, i64 %1494
  %1497 = load double, ptr %1496, align 8, !noalias !100
  %1498 = getelementptr inbounds nuw i8, ptr %1496, i64 8
  %1499 = load double, ptr %1498, align 8, !noalias !100
  %1500 = call i64 @llvm.smax.i64(i64 %1420, i64 0)
  br label %1423

1501:                                             ; preds = %1423
  %1502 = select i1 %1493, i64 %218, i64 0
  %1503 = add i64 %1420, %1502
  %1504 = icmp slt i64 %1424, 0
  %1505 = select i1 %1504, i64 %220, i64 0
  %1506 = mul i64 %1503, %220
  %1507 = getelementptr { double, double }, ptr %221, i64 %1506
  %1508 = getelementptr { double, double }, ptr %1507, i64 %1424
  %1509 = getelementptr { double, double }, ptr %1508, i64 %1505
  %1510 = load double, ptr %1509, align 8, !noalias !100
  %1511 = getelementptr inbounds nuw i8, ptr %1509, i64 8
  %1512 = load double, ptr %1511, align 8, !noalias !100
  %1513 = select i1 %1504, i64 %266, i64 0
  %1514 = getelementptr { double, double }, ptr %267, i64 %1424
  %1515 = getelementptr { double, double }, ptr %1514, i64 %1513
  %1516 = load double, ptr %1515, align 8, !noalias !100
  %1517 = getelementptr inbounds nuw i8, ptr %1515, i64 8
  %1518 = load double, ptr %1517, align 8, !noalias !100
  %1519 = fmul double %1510, %1518
  %1520 = fmul double %1512, %1516
  %1521 = fadd double %1519, %1520
  %1522 = fmul double %1510, %1516
  %1523 = fmul double %1512, %1518
  %1524 = fsub double %1522, %1523
  %1525 = add i64 %1424, 1
  %1526 = add nsw i64 %1425, -1
  %1527 = fsub double %1427, %1524
  %1528 = fsub double %1426, %1521
  br label %1423

1529:                                             ; preds = %1433
  %1530 = add nsw i64 %1435, -1
  %1531 = icmp slt i64 %1436, 0
  %1532 = select i1 %1531, i64 %266, i64 0
  %1533 = getelementptr { double, double }, ptr %267, i64 %1436
  %1534 = getelementptr { double, double }, ptr %1533, i64 %1532
  %1535 = load double, ptr %1534, align 8, !noalias !100
  %1536 = getelementptr inbounds nuw i8, ptr %1534, i64 8
  %1537 = load double, ptr %1536, align 8, !noalias !100
  %1538 = sub i64 %218, %1434
  %1539 = call i64 @llvm.smax.i64(i64 %1538, i64 0)
  br label %1438

1540:                                             ; preds = %1438
  %1541 = select i1 %1531, i64 %218, i64 0
  %1542 = add i64 %1436, %1541
  %1543 = icmp slt i64 %1439, 0
  %1544 = select i1 %1543, i64 %220, i64 0
  %1545 = mul i64 %1542, %220
  %1546 = getelementptr { double, double }, ptr %221, i64 %1545
  %1547 = getelementptr { double, double }, ptr %1546, i64 %1439
  %1548 = getelementptr { double, double }, ptr %1547, i64 %1544
  %1549 = load double, ptr %1548, align 8, !noalias !100
  %1550 = getelementptr inbounds nuw i8, ptr %1548, i64 8
  %1551 = load double, ptr %1550, align 8, !noalias !100
  %1552 = select i1 %1543, i64 %266, i64 0
  %1553 = getelementptr { double, double }, ptr %267, i64 %1439
  %1554 = getelementptr { double, double }, ptr %1553, i64 %1552
  %1555 = load double, ptr %1554, align 8, !noalias !100
  %1556 = getelementptr inbounds nuw i8, ptr %1554, i64 8
  %1557 = load double, ptr %1556, align 8, !noalias !100
  %1558 = fmul double %1549, %1557
  %1559 = fmul double %1551, %1555
  %1560 = fadd double %1558, %1559
  %1561 = fmul double %1549, %1555
  %1562 = fmul double %1551, %1557
  %1563 = fsub double %1561, %1562
  %1564 = add i64 %1439, 1
  %1565 = add nsw i64 %1440, -1
  %1566 = fsub double %1442, %1563
  %1567 = fsub double %1441, %1560
  br label %1438

1568:                                             ; preds = %1433
  br i1 %875, label %1014, label %1183

1569:                                             ; preds = %1045, %1582
  %1570 = phi i64 [ %1650, %1582 ], [ 0, %1045 ]
  %1571 = phi i64 [ %1649, %1582 ], [ %1399, %1045 ]
  %1572 = icmp sgt i64 %1571, 0
  br i1 %1572, label %1648, label %1583

1573:                                             ; preds = %1648
  %1574 = mul nsw i64 %1570, %874
  %1575 = add nsw i64 %218, %1574
  %1576 = mul nsw i64 %1655, %874
  %1577 = add nsw i64 %218, %1576
  br label %1578

1578:                                             ; preds = %1657, %1573
  %1579 = phi i64 [ 0, %1573 ], [ %1659, %1657 ]
  %1580 = phi i64 [ %874, %1573 ], [ %1658, %1657 ]
  %1581 = icmp sgt i64 %1580, 0
  br i1 %1581, label %1657, label %1582

1582:                                             ; preds = %1648, %1578
  br label %1569

1583:                                             ; preds = %1569, %1587
  %1584 = phi i64 [ %1678, %1587 ], [ 0, %1569 ]
  %1585 = phi i64 [ %1677, %1587 ], [ %1399, %1569 ]
  %1586 = icmp sgt i64 %1585, 0
  br i1 %1586, label %1676, label %1595

1587:                                             ; preds = %1676, %1591
  %1588 = phi i64 [ 0, %1676 ], [ %1682, %1591 ]
  %1589 = phi i64 [ %1679, %1676 ], [ %1681, %1591 ]
  %1590 = icmp sgt i64 %1589, 0
  br i1 %1590, label %1680, label %1583

1591:                                             ; preds = %1699, %1680
  %1592 = phi i64 [ 0, %1680 ], [ %1722, %1699 ]
  %1593 = phi i64 [ %874, %1680 ], [ %1723, %1699 ]
  %1594 = icmp sgt i64 %1593, 0
  br i1 %1594, label %1699, label %1587

1595:                                             ; preds = %1583, %1644
  %1596 = phi i64 [ %1598, %1644 ], [ %218, %1583 ]
  %1597 = phi i64 [ %1727, %1644 ], [ %1432, %1583 ]
  %1598 = add i64 %1596, -1
  %1599 = icmp sgt i64 %1597, 0
  br i1 %1599, label %1726, label %1183

1600:                                             ; preds = %1726, %1604
  %1601 = phi i64 [ %1596, %1726 ], [ %1734, %1604 ]
  %1602 = phi i64 [ %1731, %1726 ], [ %1733, %1604 ]
  %1603 = icmp sgt i64 %1602, 0
  br i1 %1603, label %1732, label %1608

1604:                                             ; preds = %1749, %1732
  %1605 = phi i64 [ 0, %1732 ], [ %1772, %1749 ]
  %1606 = phi i64 [ %874, %1732 ], [ %1773, %1749 ]
  %1607 = icmp sgt i64 %1606, 0
  br i1 %1607, label %1749, label %1600

1608:                                             ; preds = %1600
  %1609 = icmp slt i64 %1598, 0
  %1610 = select i1 %1609, i64 %218, i64 0
  %1611 = add i64 %1598, %1610
  %1612 = select i1 %1609, i64 %220, i64 0
  %1613 = mul i64 %1611, %220
  %1614 = getelementptr { double, double }, ptr %221, i64 %1613
  %1615 = getelementptr { double, double }, ptr %1614, i64 %1598
  %1616 = getelementptr { double, double }, ptr %1615, i64 %1612
  %1617 = load double, ptr %1616, align 8, !noalias !104
  %1618 = getelementptr inbounds nuw i8, ptr %1616, i64 8
  %1619 = load double, ptr %1618, align 8, !noalias !104
  %1620 = call double @llvm.fabs.f64(double %1617)
  %1621 = call double @llvm.fabs.f64(double %1619)
  %1622 = fcmp ult double %1620, %1621
  br i1 %1622, label %1632, label %1623

1623:                                             ; preds = %1608
  %1624 = fdiv double %1619, %1617
  %1625 = fmul double %1619, %1624
  %1626 = fadd double %1617, %1625
  %1627 = fmul double %1624, 0.000000e+00
  %1628 = fadd double %1627, 1.000000e+00
  %1629 = fdiv double %1628, %1626
  %1630 = fsub double 0.000000e+00, %1624
  %1631 = fdiv double %1630, %1626
  br label %1641

1632:                                             ; preds = %1608
  %1633 = fdiv double %1617, %1619
  %1634 = fmul double %1617, %1633
  %1635 = fadd double %1634, %1619
  %1636 = fadd double %1633, 0.000000e+00
  %1637 = fdiv double %1636, %1635
  %1638 = fmul double %1633, 0.000000e+00
  %1639 = fadd double %1638, -1.000000e+00
  %1640 = fdiv double %1639, %1635
  br label %1641

1641:                                             ; preds = %1632, %1623
  %1642 = phi double [ %1631, %1623 ], [ %1640, %1632 ]
  %1643 = phi double [ %1629, %1623 ], [ %1637, %1632 ]
  br label %1644

1644:                                             ; preds = %1776, %1641
  %1645 = phi i64 [ 0, %1641 ], [ %1791, %1776 ]
  %1646 = phi i64 [ %874, %1641 ], [ %1792, %1776 ]
  %1647 = icmp sgt i64 %1646, 0
  br i1 %1647, label %1776, label %1595

1648:                                             ; preds = %1569
  %1649 = add nsw i64 %1571, -1
  %1650 = add i64 %1570, 1
  %1651 = icmp slt i64 %1570, 0
  %1652 = select i1 %1651, i64 %230, i64 0
  %1653 = getelementptr i64, ptr %231, i64 %1570
  %1654 = getelementptr i64, ptr %1653, i64 %1652
  %1655 = load i64, ptr %1654, align 8, !noalias !104
  %1656 = icmp eq i64 %1655, %1570
  br i1 %1656, label %1582, label %1573

1657:                                             ; preds = %1578
  %1658 = add nsw i64 %1580, -1
  %1659 = add i64 %1579, 1
  %1660 = add nsw i64 %1577, %1579
  %1661 = icmp slt i64 %1660, 0
  %1662 = select i1 %1661, i64 %266, i64 0
  %1663 = getelementptr { double, double }, ptr %267, i64 %1660
  %1664 = getelementptr { double, double }, ptr %1663, i64 %1662
  %1665 = load double, ptr %1664, align 8, !noalias !104
  %1666 = getelementptr inbounds nuw i8, ptr %1664, i64 8
  %1667 = load double, ptr %1666, align 8, !noalias !104
  %1668 = add nsw i64 %1575, %1579
  %1669 = icmp slt i64 %1668, 0
  %1670 = select i1 %1669, i64 %266, i64 0
  %1671 = getelementptr { double, double }, ptr %267, i64 %1668
  %1672 = getelementptr { double, double }, ptr %1671, i64 %1670
  %1673 = load double, ptr %1672, align 8, !noalias !104
  %1674 = getelementptr inbounds nuw i8, ptr %1672, i64 8
  %1675 = load double, ptr %1674, align 8, !noalias !104
  store double %1665, ptr %1672, align 8, !noalias !104
  store double %1667, ptr %1674, align 8, !noalias !104
  store double %1673, ptr %1664, align 8, !noalias !104
  store double %1675, ptr %1666, align 8, !noalias !104
  br label %1578

1676:                                             ; preds = %1583
  %1677 = add nsw i64 %1585, -1
  %1678 = add i64 %1584, 1
  %1679 = call i64 @llvm.smax.i64(i64 %1584, i64 0)
  br label %1587

1680:                                             ; preds = %1587
  %1681 = add nsw i64 %1589, -1
  %1682 = add i64 %1588, 1
  %1683 = icmp slt i64 %1584, 0
  %1684 = select i1 %1683, i64 %218, i64 0
  %1685 = add i64 %1584, %1684
  %1686 = icmp slt i64 %1588, 0
  %1687 = select i1 %1686, i64 %220, i64 0
  %1688 = mul i64 %1685, %220
  %1689 = getelementptr { double, double }, ptr %221, i64 %1688
  %1690 = getelementptr { double, double }, ptr %1689, i64 %1588
  %1691 = getelementptr { double, double }, ptr %1690, i64 %1687
  %1692 = load double, ptr %1691, align 8, !noalias !104
  %1693 = getelementptr inbounds nuw i8, ptr %1691, i64 8
  %1694 = load double, ptr %1693, align 8, !noalias !104
  %1695 = mul nsw i64 %1584, %874
  %1696 = add nsw i64 %218, %1695
  %1697 = mul nsw i64 %1588, %874
  %1698 = add nsw i64 %218, %1697
  br label %1591

1699:                                             ; preds = %1591
  %1700 = add nsw i64 %1696, %1592
  %1701 = icmp slt i64 %1700, 0
  %1702 = select i1 %1701, i64 %266, i64 0
  %1703 = getelementptr { double, double }, ptr %267, i64 %1700
  %1704 = getelementptr { double, double }, ptr %1703, i64 %1702
  %1705 = load double, ptr %1704, align 8, !noalias !104
  %1706 = getelementptr inbounds nuw i8, ptr %1704, i64 8
  %1707 = load double, ptr %1706, align 8, !noalias !104
  %1708 = add nsw i64 %1698, %1592
  %1709 = icmp slt i64 %1708, 0
  %1710 = select i1 %1709, i64 %266, i64 0
  %1711 = getelementptr { double, double }, ptr %267, i64 %1708
  %1712 = getelementptr { double, double }, ptr %1711, i64 %1710
  %1713 = load double, ptr %1712, align 8, !noalias !104
  %1714 = getelementptr inbounds nuw i8, ptr %1712, i64 8
  %1715 = load double, ptr %1714, align 8, !noalias !104
  %1716 = fmul double %1692, %1715
  %1717 = fmul double %1694, %1713
  %1718 = fadd double %1716, %1717
  %1719 = fmul double %1692, %1713
  %1720 = fmul double %1694, %1715
  %1721 = fsub double %1719, %1720
  %1722 = add i64 %1592, 1
  %1723 = add nsw i64 %1593, -1
  %1724 = fsub double %1705, %1721
  %1725 = fsub double %1707, %1718
  store double %1724, ptr %1704, align 8, !noalias !104
  store double %1725, ptr %1706, align 8, !noalias !104
  br label %1591

1726:                                             ; preds = %1595
  %1727 = add nsw i64 %1597, -1
  %1728 = mul nsw i64 %1598, %874
  %1729 = add nsw i64 %218, %1728
  %1730 = sub i64 %218, %1596
  %1731 = call i64 @llvm.smax.i64(i64 %1730, i64 0)
  br label %1600

1732:                                             ; preds = %1600
  %1733 = add nsw i64 %1602, -1
  %1734 = add i64 %1601, 1
  %1735 = icmp slt i64 %1598, 0
  %1736 = select i1 %1735, i64 %218, i64 0
  %1737 = add i64 %1598, %1736
  %1738 = icmp slt i64 %1601, 0
  %1739 = select i1 %1738, i64 %220, i64 0
  %1740 = mul i64 %1737, %220
  %1741 = getelementptr { double, double }, ptr %221, i64 %1740
  %1742 = getelementptr { double, double }, ptr %1741, i64 %1601
  %1743 = getelementptr { double, double }, ptr %1742, i64 %1739
  %1744 = load double, ptr %1743, align 8, !noalias !104
  %1745 = getelementptr inbounds nuw i8, ptr %1743, i64 8
  %1746 = load double, ptr %1745, align 8, !noalias !104
  %1747 = mul nsw i64 %1601, %874
  %1748 = add nsw i64 %218, %1747
  br label %1604

1749:                                             ; preds = %1604
  %1750 = add nsw i64 %1729, %1605
  %1751 = icmp slt i64 %1750, 0
  %1752 = select i1 %1751, i64 %266, i64 0
  %1753 = getelementptr { double, double }, ptr %267, i64 %1750
  %1754 = getelementptr { double, double }, ptr %1753, i64 %1752
  %1755 = load double, ptr %1754, align 8, !noalias !104
  %1756 = getelementptr inbounds nuw i8, ptr %1754, i64 8
  %1757 = load double, ptr %1756, align 8, !noalias !104
  %1758 = add nsw i64 %1748, %1605
  %1759 = icmp slt i64 %1758, 0
  %1760 = select i1 %1759, i64 %266, i64 0
  %1761 = getelementptr { double, double }, ptr %267, i64 %1758
  %1762 = getelementptr { double, double }, ptr %1761, i64 %1760
  %1763 = load double, ptr %1762, align 8, !noalias !104
  %1764 = getelementptr inbounds nuw i8, ptr %1762, i64 8
  %1765 = load double, ptr %1764, align 8, !noalias !104
  %1766 = fmul double %1744, %1765
  %1767 = fmul double %1746, %1763
  %1768 = fadd double %1766, %1767
  %1769 = fmul double %1744, %1763
  %1770 = fmul double %1746, %1765
  %1771 = fsub double %1769, %1770
  %1772 = add i64 %1605, 1
  %1773 = add nsw i64 %1606, -1
  %1774 = fsub double %1755, %1771
  %1775 = fsub double %1757, %1768
  store double %1774, ptr %1754, align 8, !noalias !104
  store double %1775, ptr %1756, align 8, !noalias !104
  br label %1604

1776:                                             ; preds = %1644
  %1777 = add nsw i64 %1729, %1645
  %1778 = icmp slt i64 %1777, 0
  %1779 = select i1 %1778, i64 %266, i64 0
  %1780 = getelementptr { double, double }, ptr %267, i64 %1777
  %1781 = getelementptr { double, double }, ptr %1780, i64 %1779
  %1782 = load double, ptr %1781, align 8, !noalias !104
  %1783 = getelementptr inbounds nuw i8, ptr %1781, i64 8
  %1784 = load double, ptr %1783, align 8, !noalias !104
  %1785 = fmul double %1782, %1642
  %1786 = fmul double %1784, %1643
  %1787 = fadd double %1785, %1786
  %1788 = fmul double %1782, %1643
  %1789 = fmul double %1784, %1642
  %1790 = fsub double %1788, %1789
  %1791 = add i64 %1645, 1
  %1792 = add nsw i64 %1646, -1
  store double %1790, ptr %1781, align 8, !noalias !104
  store double %1787, ptr %1783, align 8, !noalias !104
  br label %1644

1793:                                             ; preds = %1184
  %1794 = add nsw i64 %1186, -1
  %1795 = add i64 %1185, 1
  %1796 = icmp slt i64 %1185, 0
  %1797 = select i1 %1796, i64 %64, i64 0
  %1798 = getelementptr double, ptr %65, i64 %1185
  %1799 = getelementptr double, ptr %1798, i64 %1797
  %1800 = load double, ptr %1799, align 8, !noalias !65
  %1801 = select i1 %1796, i64 %99, i64 0
  %1802 = getelementptr double, ptr %100, i64 %1185
  %1803 = getelementptr double, ptr %1802, i64 %1801
  %1804 = load double, ptr %1803, align 8, !noalias !108
  %1805 = select i1 %1796, i64 %94, i64 0
  %1806 = getelementptr double, ptr %95, i64 %1185
  %1807 = getelementptr double, ptr %1806, i64 %1805
  %1808 = load double, ptr %1807, align 8, !noalias !108
  %1809 = call double @llvm.fabs.f64(double %1800)
  %1810 = fmul double %1808, %1809
  %1811 = fadd double %1804, %1810
  %1812 = select i1 %1796, i64 %261, i64 0
  %1813 = getelementptr double, ptr %262, i64 %1185
  %1814 = getelementptr double, ptr %1813, i64 %1812
  %1815 = load double, ptr %1814, align 8, !noalias !65
  %1816 = fdiv double %1815, %1811
  %1817 = select i1 %1796, i64 %266, i64 0
  %1818 = getelementptr { double, double }, ptr %267, i64 %1185
  %1819 = getelementptr { double, double }, ptr %1818, i64 %1817
  %1820 = load double, ptr %1819, align 8, !noalias !65
  %1821 = fdiv double %1820, %1811
  %1822 = getelementptr inbounds nuw i8, ptr %1819, i64 8
  %1823 = load double, ptr %1822, align 8, !noalias !65
  %1824 = fdiv double %1823, %1811
  %1825 = fmul double %1816, %1816
  %1826 = fmul double %1821, %1821
  %1827 = fadd double %1825, %1826
  %1828 = fmul double %1824, %1824
  %1829 = fadd double %1827, %1828
  %1830 = fadd double %1187, %1829
  br label %1184

1831:                                             ; preds = %1228
  %1832 = fcmp ult double %1201, 1.000000e+00
  br i1 %1832, label %1232, label %1896

1833:                                             ; preds = %1239
  %1834 = add nsw i64 %1241, -1
  %1835 = add i64 %1240, 1
  %1836 = icmp slt i64 %1240, 0
  %1837 = select i1 %1836, i64 %244, i64 0
  %1838 = getelementptr double, ptr %245, i64 %1240
  %1839 = getelementptr double, ptr %1838, i64 %1837
  %1840 = load double, ptr %1839, align 8, !noalias !65
  %1841 = select i1 %1836, i64 %261, i64 0
  %1842 = getelementptr double, ptr %262, i64 %1240
  %1843 = getelementptr double, ptr %1842, i64 %1841
  %1844 = load double, ptr %1843, align 8, !noalias !65
  %1845 = fadd double %1840, %1844
  store double %1845, ptr %1839, align 8, !noalias !65
  %1846 = getelementptr double, ptr %245, i64 %244
  %1847 = getelementptr double, ptr %1846, i64 %1240
  %1848 = getelementptr double, ptr %1847, i64 %1837
  %1849 = load double, ptr %1848, align 8, !noalias !65
  %1850 = select i1 %1836, i64 %266, i64 0
  %1851 = getelementptr { double, double }, ptr %267, i64 %1240
  %1852 = getelementptr { double, double }, ptr %1851, i64 %1850
  %1853 = load double, ptr %1852, align 8, !noalias !65
  %1854 = fadd double %1849, %1853
  store double %1854, ptr %1848, align 8, !noalias !65
  %1855 = shl i64 %244, 4
  %1856 = getelementptr i8, ptr %245, i64 %1855
  %1857 = getelementptr double, ptr %1856, i64 %1240
  %1858 = getelementptr double, ptr %1857, i64 %1837
  %1859 = load double, ptr %1858, align 8, !noalias !65
  %1860 = getelementptr inbounds nuw i8, ptr %1852, i64 8
  %1861 = load double, ptr %1860, align 8, !noalias !65
  %1862 = fadd double %1859, %1861
  store double %1862, ptr %1858, align 8, !noalias !65
  br label %1243

1863:                                             ; preds = %1243
  %1864 = add nsw i64 %1245, -1
  %1865 = add i64 %1244, 1
  %1866 = icmp slt i64 %1244, 0
  %1867 = add i64 %1244, 3
  %1868 = select i1 %1866, i64 %1867, i64 %1244
  %1869 = mul i64 %1868, 24
  %1870 = getelementptr i8, ptr @5, i64 %1869
  %1871 = load double, ptr %1870, align 8, !noalias !65
  %1872 = load double, ptr %1839, align 8, !noalias !65
  %1873 = fmul double %1871, %1872
  %1874 = getelementptr i8, ptr @6, i64 %1869
  %1875 = getelementptr i8, ptr %1874, i64 8
  %1876 = load double, ptr %1875, align 8, !noalias !65
  %1877 = load double, ptr %1848, align 8, !noalias !65
  %1878 = fmul double %1876, %1877
  %1879 = fadd double %1873, %1878
  %1880 = getelementptr i8, ptr @7, i64 %1869
  %1881 = getelementptr i8, ptr %1880, i64 16
  %1882 = load double, ptr %1881, align 8, !noalias !65
  %1883 = load double, ptr %1858, align 8, !noalias !65
  %1884 = fmul double %1882, %1883
  %1885 = fadd double %1879, %1884
  %1886 = select i1 %1866, i64 %235, i64 0
  %1887 = add i64 %1244, %1886
  %1888 = select i1 %1836, i64 %237, i64 0
  %1889 = mul i64 %1887, %237
  %1890 = getelementptr double, ptr %238, i64 %1889
  %1891 = getelementptr double, ptr %1890, i64 %1240
  %1892 = getelementptr double, ptr %1891, i64 %1888
  store double %1885, ptr %1892, align 8, !noalias !65
  br label %1243

1893:                                             ; preds = %1264
  %1894 = fmul double %871, %871
  %1895 = fcmp ugt double %1267, %1894
  br i1 %1895, label %1338, label %1339

1896:                                             ; preds = %1228, %1012, %921, %1232, %1831, %1189, %1379, %924, %1339
  %1897 = phi double [ %1340, %1339 ], [ %1201, %1232 ], [ 0.000000e+00, %924 ], [ 0.000000e+00, %1012 ], [ 0.000000e+00, %921 ], [ 0x7FF0000000000000, %1379 ], [ %881, %1189 ], [ %1201, %1831 ], [ 0.000000e+00, %1228 ]
  %1898 = phi i64 [ %1343, %1339 ], [ %1350, %1232 ], [ %1351, %924 ], [ 0, %1012 ], [ 0, %921 ], [ %1351, %1379 ], [ %1350, %1189 ], [ %1350, %1831 ], [ 0, %1228 ]
  %1899 = phi i1 [ %1342, %1339 ], [ true, %1232 ], [ true, %924 ], [ true, %1012 ], [ true, %921 ], [ true, %1379 ], [ true, %1189 ], [ true, %1831 ], [ true, %1228 ]
  %1900 = phi i64 [ 0, %1339 ], [ 0, %1232 ], [ %925, %924 ], [ 0, %1012 ], [ 0, %921 ], [ 0, %1379 ], [ 0, %1189 ], [ 0, %1831 ], [ 0, %1228 ]
  %1901 = phi i32 [ 0, %1339 ], [ 0, %1232 ], [ 0, %924 ], [ %1013, %1012 ], [ %923, %921 ], [ 0, %1379 ], [ 0, %1189 ], [ 0, %1831 ], [ %1231, %1228 ]
  switch i32 %1901, label %2639 [
    i32 -2, label %2637
    i32 0, label %2637
  ], !prof !33

1902:                                             ; preds = %2637
  br label %2773

1903:                                             ; preds = %2637
  br i1 %1899, label %2391, label %1904

1904:                                             ; preds = %1903, %2640
  %1905 = phi i64 [ %2642, %2640 ], [ 0, %1903 ]
  %1906 = phi i64 [ %2641, %2640 ], [ %292, %1903 ]
  %1907 = icmp sgt i64 %1906, 0
  br i1 %1907, label %2640, label %1908

1908:                                             ; preds = %1904
  %1909 = getelementptr i8, ptr %196, i64 32
  %1910 = load i64, ptr %1909, align 8, !noalias !22
  %1911 = icmp ne i64 %1910, 1
  store ptr null, ptr %6, align 8, !noalias !111
  store double 0.000000e+00, ptr %7, align 8, !noalias !111
  store ptr null, ptr %8, align 8, !noalias !111
  store double 0.000000e+00, ptr %9, align 8, !noalias !111
  %1912 = load i64, ptr %116, align 8, !noalias !111
  %1913 = call i64 @llvm.smax.i64(i64 %1912, i64 0)
  br label %1914

1914:                                             ; preds = %1949, %1908
  %1915 = phi i64 [ 0, %1908 ], [ %1951, %1949 ]
  %1916 = phi i64 [ %1913, %1908 ], [ %1950, %1949 ]
  %1917 = icmp sgt i64 %1916, 0
  br i1 %1917, label %1949, label %1918

1918:                                             ; preds = %1914
  store ptr null, ptr %6, align 8, !noalias !111
  %1919 = call fastcc i32 @solve(ptr nonnull %6, ptr %214, i64 %211, i64 %213, ptr %226, i64 %225, ptr %262, i64 %261) #3, !noalias !111
  switch i32 %1919, label %2027 [
    i32 -2, label %1983
    i32 0, label %1983
  ], !prof !33

1920:                                             ; preds = %1986, %1989
  %1921 = phi i64 [ %1991, %1989 ], [ 0, %1986 ]
  %1922 = phi i64 [ %1990, %1989 ], [ %1913, %1986 ]
  %1923 = icmp sgt i64 %1922, 0
  br i1 %1923, label %1989, label %1924

1924:                                             ; preds = %1920
  %1925 = getelementptr i8, ptr %110, i64 24
  %1926 = load i64, ptr %1925, align 8, !noalias !111
  %1927 = add nsw i64 %1926, 1
  store i64 %1927, ptr %1925, align 8, !noalias !111
  store ptr null, ptr %4, align 8, !noalias !115
  store ptr null, ptr %5, align 8, !noalias !115
  store double %376, ptr %33, align 8, !noalias !115
  %1928 = icmp sgt i64 %45, 0
  br i1 %1928, label %1929, label %1932

1929:                                             ; preds = %1924
  store ptr null, ptr %4, align 8, !noalias !115
  %1930 = call fastcc i32 @_sample(ptr nonnull %4, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %376) #3
  switch i32 %1930, label %1931 [
    i32 -2, label %1932
    i32 0, label %1932
  ], !prof !33

1931:                                             ; preds = %1929
  br label %1932

1932:                                             ; preds = %1929, %1929, %1924, %1931
  %1933 = phi i32 [ %1930, %1931 ], [ 0, %1924 ], [ 0, %1929 ], [ 0, %1929 ]
  switch i32 %1933, label %1938 [
    i32 -2, label %1934
    i32 0, label %1934
  ], !prof !33

1934:                                             ; preds = %1932, %1932
  %1935 = load i64, ptr %30, align 8, !noalias !122
  %1936 = inttoptr i64 %1935 to ptr
  %1937 = call i32 %1936(ptr nonnull %33, ptr %75, ptr %38, ptr %41, ptr %250) #3, !noalias !122
  br label %1938

1938:                                             ; preds = %1932, %1934
  %1939 = phi i32 [ %1937, %1934 ], [ 0, %1932 ]
  %1940 = phi i32 [ 0, %1934 ], [ %1933, %1932 ]
  switch i32 %1940, label %2027 [
    i32 -2, label %2005
    i32 0, label %2005
  ], !prof !33

1941:                                             ; preds = %2005
  %1942 = sext i32 %1939 to i64
  br label %2027

1943:                                             ; preds = %2005, %2007
  %1944 = phi i64 [ %2009, %2007 ], [ 0, %2005 ]
  %1945 = phi i64 [ %2008, %2007 ], [ %1913, %2005 ]
  %1946 = icmp sgt i64 %1945, 0
  br i1 %1946, label %2007, label %1947

1947:                                             ; preds = %1943
  store ptr null, ptr %8, align 8, !noalias !111
  %1948 = call fastcc i32 @solve(ptr nonnull %8, ptr %214, i64 %211, i64 %213, ptr %226, i64 %225, ptr %262, i64 %261) #3, !noalias !111
  switch i32 %1948, label %2027 [
    i32 -2, label %2023
    i32 0, label %2023
  ], !prof !33

1949:                                             ; preds = %1914
  %1950 = add nsw i64 %1916, -1
  %1951 = add i64 %1915, 1
  %1952 = icmp slt i64 %1915, 0
  %1953 = select i1 %1952, i64 %237, i64 0
  %1954 = getelementptr double, ptr %238, i64 %1915
  %1955 = getelementptr double, ptr %1954, i64 %1953
  %1956 = load double, ptr %1955, align 8, !noalias !111
  %1957 = fmul double %1956, 0xC02418FD8BAFFE05
  %1958 = getelementptr double, ptr %238, i64 %237
  %1959 = getelementptr double, ptr %1958, i64 %1915
  %1960 = getelementptr double, ptr %1959, i64 %1953
  %1961 = load double, ptr %1960, align 8, !noalias !111
  %1962 = fmul double %1961, 0x3FF61D41B2D54580
  %1963 = fadd double %1957, %1962
  %1964 = shl i64 %237, 4
  %1965 = getelementptr i8, ptr %238, i64 %1964
  %1966 = getelementptr double, ptr %1965, i64 %1915
  %1967 = getelementptr double, ptr %1966, i64 %1953
  %1968 = load double, ptr %1967, align 8, !noalias !111
  %1969 = fmul double %1968, 0xBFD5555555555555
  %1970 = fadd double %1963, %1969
  %1971 = fdiv double %1970, %410
  %1972 = select i1 %1952, i64 %271, i64 0
  %1973 = getelementptr double, ptr %272, i64 %1915
  %1974 = getelementptr double, ptr %1973, i64 %1972
  store double %1971, ptr %1974, align 8, !noalias !111
  %1975 = select i1 %1952, i64 %84, i64 0
  %1976 = getelementptr double, ptr %85, i64 %1915
  %1977 = getelementptr double, ptr %1976, i64 %1975
  %1978 = load double, ptr %1977, align 8, !noalias !111
  %1979 = fadd double %1978, %1971
  %1980 = select i1 %1952, i64 %261, i64 0
  %1981 = getelementptr double, ptr %262, i64 %1915
  %1982 = getelementptr double, ptr %1981, i64 %1980
  store double %1979, ptr %1982, align 8, !noalias !111
  br label %1914

1983:                                             ; preds = %1918, %1918
  store double 0.000000e+00, ptr %7, align 8, !noalias !111
  %1984 = call fastcc i32 @norm(ptr nonnull %7, ptr %262, ptr %70, ptr %65, ptr nonnull %95, i64 %94, ptr %100, i64 %99, i64 %1912) #3, !noalias !111
  %1985 = load double, ptr %7, align 8, !noalias !111
  switch i32 %1984, label %2027 [
    i32 -2, label %1986
    i32 0, label %1986
  ], !prof !33

1986:                                             ; preds = %1983, %1983
  %1987 = fcmp olt double %1985, 1.000000e+00
  %1988 = select i1 %1987, i1 true, i1 %1911
  br i1 %1988, label %2027, label %1920

1989:                                             ; preds = %1920
  %1990 = add nsw i64 %1922, -1
  %1991 = add i64 %1921, 1
  %1992 = icmp slt i64 %1921, 0
  %1993 = select i1 %1992, i64 %64, i64 0
  %1994 = getelementptr double, ptr %65, i64 %1921
  %1995 = getelementptr double, ptr %1994, i64 %1993
  %1996 = load double, ptr %1995, align 8, !noalias !111
  %1997 = select i1 %1992, i64 %261, i64 0
  %1998 = getelementptr double, ptr %262, i64 %1921
  %1999 = getelementptr double, ptr %1998, i64 %1997
  %2000 = load double, ptr %1999, align 8, !noalias !111
  %2001 = fadd double %1996, %2000
  %2002 = select i1 %1992, i64 %74, i64 0
  %2003 = getelementptr double, ptr %75, i64 %1921
  %2004 = getelementptr double, ptr %2003, i64 %2002
  store double %2001, ptr %2004, align 8, !noalias !111
  br label %1920

2005:                                             ; preds = %1938, %1938
  %2006 = icmp eq i32 %1939, 0
  br i1 %2006, label %1943, label %1941

2007:                                             ; preds = %1943
  %2008 = add nsw i64 %1945, -1
  %2009 = add i64 %1944, 1
  %2010 = icmp slt i64 %1944, 0
  %2011 = select i1 %2010, i64 %249, i64 0
  %2012 = getelementptr double, ptr %250, i64 %1944
  %2013 = getelementptr double, ptr %2012, i64 %2011
  %2014 = load double, ptr %2013, align 8, !noalias !111
  %2015 = select i1 %2010, i64 %271, i64 0
  %2016 = getelementptr double, ptr %272, i64 %1944
  %2017 = getelementptr double, ptr %2016, i64 %2015
  %2018 = load double, ptr %2017, align 8, !noalias !111
  %2019 = fadd double %2014, %2018
  %2020 = select i1 %2010, i64 %261, i64 0
  %2021 = getelementptr double, ptr %262, i64 %1944
  %2022 = getelementptr double, ptr %2021, i64 %2020
  store double %2019, ptr %2022, align 8, !noalias !111
  br label %1943

2023:                                             ; preds = %1947, %1947
  store double 0.000000e+00, ptr %9, align 8, !noalias !111
  %2024 = call fastcc i32 @norm(ptr nonnull %9, ptr %262, ptr %70, ptr %65, ptr nonnull %95, i64 %94, ptr %100, i64 %99, i64 %1912) #3, !noalias !111
  switch i32 %2024, label %2027 [
    i32 -2, label %2025
    i32 0, label %2025
  ], !prof !33

2025:                                             ; preds = %2023, %2023
  %2026 = load double, ptr %9, align 8, !noalias !111
  br label %2027

2027:                                             ; preds = %2023, %1947, %1938, %1983, %1918, %1986, %1941, %2025
  %2028 = phi double [ %1985, %1986 ], [ 0.000000e+00, %1918 ], [ %1985, %1941 ], [ 0.000000e+00, %1983 ], [ 0.000000e+00, %1938 ], [ 0.000000e+00, %1947 ], [ %2026, %2025 ], [ 0.000000e+00, %2023 ]
  %2029 = phi i64 [ 0, %1986 ], [ 0, %1918 ], [ %1942, %1941 ], [ 0, %1983 ], [ 0, %1938 ], [ 0, %1947 ], [ 0, %2025 ], [ 0, %2023 ]
  %2030 = phi i32 [ 0, %1986 ], [ %1919, %1918 ], [ 0, %1941 ], [ %1984, %1983 ], [ %1940, %1938 ], [ %1948, %1947 ], [ 0, %2025 ], [ %2024, %2023 ]
  switch i32 %2030, label %2660 [
    i32 -2, label %2658
    i32 0, label %2658
  ], !prof !33

2031:                                             ; preds = %2658
  br label %2773

2032:                                             ; preds = %2658
  %2033 = add nsw i64 %1898, 12
  %2034 = sitofp i64 %2033 to double
  %2035 = fdiv double 0x4027666666666667, %2034
  %2036 = fcmp olt double %2028, 1.000000e-10
  %2037 = select i1 %2036, double 1.000000e-10, double %2028
  %2038 = call double @llvm.pow.f64(double %2037, double -2.500000e-01)
  %2039 = icmp eq i64 %2029, 0
  %2040 = fcmp olt double %2028, 1.000000e+00
  %2041 = select i1 %2039, i1 %2040, i1 false
  br i1 %2041, label %2042, label %2374

2042:                                             ; preds = %2032
  br i1 %285, label %2043, label %2057

2043:                                             ; preds = %2042
  %2044 = getelementptr i8, ptr %157, i64 56
  %2045 = load i64, ptr %2044, align 8, !noalias !22
  %2046 = inttoptr i64 %2045 to ptr
  %2047 = call i64 %2046(i64 %0, double %411, i64 %67) #3, !noalias !22
  %2048 = icmp eq i64 %2047, 0
  br i1 %2048, label %2057, label %2049

2049:                                             ; preds = %2043
  %2050 = load i64, ptr %393, align 8, !noalias !22
  %2051 = add nsw i64 %2050, 1
  store i64 %2051, ptr %393, align 8, !noalias !22
  %2052 = fmul double %410, 2.500000e-01
  %2053 = getelementptr i8, ptr %110, i64 72
  store i64 6, ptr %2053, align 8, !noalias !22
  %2054 = getelementptr i8, ptr %196, i64 16
  %2055 = load i64, ptr %2054, align 8, !noalias !22
  %2056 = sub nsw i64 1, %2055
  store i64 1, ptr %1909, align 8, !noalias !22
  store i64 %2056, ptr %418, align 8, !noalias !22
  br label %2448

2057:                                             ; preds = %2043, %2042
  %2058 = load i64, ptr %391, align 8, !noalias !22
  %2059 = add nsw i64 %2058, 1
  store i64 %2059, ptr %391, align 8, !noalias !22
  %2060 = getelementptr i8, ptr %105, i64 24
  %2061 = load double, ptr %2060, align 8, !noalias !22
  %2062 = fcmp ogt double %2061, 0.000000e+00
  br i1 %2062, label %2063, label %2073

2063:                                             ; preds = %2057
  %2064 = getelementptr i8, ptr %105, i64 32
  %2065 = load double, ptr %2064, align 8, !noalias !22
  %2066 = fdiv double %410, %2065
  %2067 = fdiv double %2061, %2037
  %2068 = call double @llvm.pow.f64(double %2067, double 2.500000e-01)
  %2069 = fmul double %2066, %2068
  %2070 = fcmp olt double %2069, 1.000000e+00
  %2071 = select i1 %2070, double %2069, double 1.000000e+00
  %2072 = fmul double %2038, %2071
  br label %2073

2073:                                             ; preds = %2063, %2057
  %2074 = phi double [ %2072, %2063 ], [ %2038, %2057 ]
  %2075 = fmul double %2035, %2074
  %2076 = fcmp olt double %2075, 1.000000e+01
  %2077 = select i1 %2076, double %2075, double 1.000000e+01
  store double %411, ptr %105, align 8, !noalias !22
  %2078 = getelementptr i8, ptr %105, i64 32
  store double %410, ptr %2078, align 8, !noalias !22
  store double %2037, ptr %2060, align 8, !noalias !22
  br label %2079

2079:                                             ; preds = %2083, %2073
  %2080 = phi i64 [ 0, %2073 ], [ %2663, %2083 ]
  %2081 = phi i64 [ %292, %2073 ], [ %2662, %2083 ]
  %2082 = icmp sgt i64 %2081, 0
  br i1 %2082, label %2661, label %2087

2083:                                             ; preds = %2661, %2718
  %2084 = phi i64 [ 0, %2661 ], [ %2720, %2718 ]
  %2085 = phi i64 [ 3, %2661 ], [ %2719, %2718 ]
  %2086 = icmp sgt i64 %2085, 0
  br i1 %2086, label %2718, label %2079

2087:                                             ; preds = %2079
  store double %410, ptr %791, align 8, !noalias !22
  %2088 = getelementptr i8, ptr %27, i64 24
  %2089 = load i64, ptr %2088, align 8, !noalias !22
  %2090 = load i64, ptr %381, align 8, !noalias !123
  %2091 = icmp eq i64 %2090, 0
  br i1 %2091, label %2735, label %2092

2092:                                             ; preds = %2087
  %2093 = load i64, ptr %275, align 8, !noalias !123
  %2094 = load i64, ptr %116, align 8, !noalias !123
  %2095 = icmp slt i64 %2093, 0
  %2096 = select i1 %2095, i64 %279, i64 0
  %2097 = add i64 %2093, %2096
  %2098 = mul i64 %2097, %281
  %2099 = getelementptr double, ptr %282, i64 %2098
  store double %376, ptr %2099, align 8, !noalias !123
  %2100 = getelementptr i8, ptr %2099, i64 8
  store double %410, ptr %2100, align 8, !noalias !123
  %2101 = add nsw i64 %2093, 1
  %2102 = icmp slt i64 %2093, -1
  %2103 = select i1 %2102, i64 %279, i64 0
  %2104 = add i64 %2101, %2103
  %2105 = mul i64 %2104, %281
  %2106 = getelementptr double, ptr %282, i64 %2105
  store double %411, ptr %2106, align 8, !noalias !123
  %2107 = getelementptr i8, ptr %2106, i64 8
  store double 0.000000e+00, ptr %2107, align 8, !noalias !123
  %2108 = call i64 @llvm.smax.i64(i64 %2094, i64 0)
  br label %2109

2109:                                             ; preds = %2113, %2092
  %2110 = phi i64 [ 0, %2092 ], [ %2120, %2113 ]
  %2111 = phi i64 [ %2108, %2092 ], [ %2119, %2113 ]
  %2112 = icmp sgt i64 %2111, 0
  br i1 %2112, label %2118, label %2117

2113:                                             ; preds = %2139, %2118
  %2114 = phi i64 [ 0, %2118 ], [ %2141, %2139 ]
  %2115 = phi i64 [ %2138, %2118 ], [ %2140, %2139 ]
  %2116 = icmp sgt i64 %2115, 0
  br i1 %2116, label %2139, label %2109

2117:                                             ; preds = %2109
  store i64 %2101, ptr %275, align 8, !noalias !123
  br label %2735

2118:                                             ; preds = %2109
  %2119 = add nsw i64 %2111, -1
  %2120 = add i64 %2110, 1
  %2121 = icmp slt i64 %2110, 0
  %2122 = select i1 %2121, i64 %64, i64 0
  %2123 = getelementptr double, ptr %65, i64 %2110
  %2124 = getelementptr double, ptr %2123, i64 %2122
  %2125 = load double, ptr %2124, align 8, !noalias !123
  %2126 = select i1 %2121, i64 %69, i64 0
  %2127 = getelementptr double, ptr %70, i64 %2110
  %2128 = getelementptr double, ptr %2127, i64 %2126
  %2129 = load double, ptr %2128, align 8, !noalias !123
  %2130 = icmp slt i64 %2110, -2
  %2131 = select i1 %2130, i64 %281, i64 0
  %2132 = getelementptr double, ptr %2099, i64 %2110
  %2133 = getelementptr i8, ptr %2132, i64 16
  %2134 = getelementptr double, ptr %2133, i64 %2131
  store double %2125, ptr %2134, align 8, !noalias !123
  %2135 = getelementptr double, ptr %2106, i64 %2110
  %2136 = getelementptr i8, ptr %2135, i64 16
  %2137 = getelementptr double, ptr %2136, i64 %2131
  store double %2129, ptr %2137, align 8, !noalias !123
  %2138 = call i64 @llvm.smax.i64(i64 %2089, i64 0)
  br label %2113

2139:                                             ; preds = %2113
  %2140 = add nsw i64 %2115, -1
  %2141 = add i64 %2114, 1
  %2142 = mul nsw i64 %2114, %64
  %2143 = add nsw i64 %2142, %2110
  %2144 = icmp slt i64 %2143, 0
  %2145 = select i1 %2144, i64 %89, i64 0
  %2146 = getelementptr double, ptr %90, i64 %2143
  %2147 = getelementptr double, ptr %2146, i64 %2145
  %2148 = load double, ptr %2147, align 8, !noalias !123
  %2149 = mul nsw i64 %2141, %2094
  %2150 = add nsw i64 %2149, 2
  %2151 = add nsw i64 %2150, %2110
  %2152 = icmp slt i64 %2151, 0
  %2153 = select i1 %2152, i64 %281, i64 0
  %2154 = getelementptr double, ptr %2099, i64 %2151
  %2155 = getelementptr double, ptr %2154, i64 %2153
  store double %2148, ptr %2155, align 8, !noalias !123
  br label %2113

2156:                                             ; preds = %2735
  %2157 = getelementptr i8, ptr %110, i64 48
  %2158 = load i64, ptr %2157, align 8, !noalias !22
  %2159 = icmp slt i64 %2158, 0
  %2160 = select i1 %2159, i64 %114, i64 0
  %2161 = getelementptr double, ptr %115, i64 %2158
  %2162 = getelementptr double, ptr %2161, i64 %2160
  %2163 = load double, ptr %2162, align 8, !noalias !22
  %2164 = fcmp ugt double %2163, %411
  br i1 %2164, label %2329, label %2172

2165:                                             ; preds = %2735
  %2166 = getelementptr i8, ptr %160, i64 16
  %2167 = load i64, ptr %2166, align 8, !noalias !22
  %2168 = inttoptr i64 %2167 to ptr
  %2169 = call i64 %2168(i64 %0, double %376, double %410) #3, !noalias !22
  %2170 = getelementptr i8, ptr %105, i64 48
  %2171 = load double, ptr %2170, align 8, !noalias !22
  br label %2172

2172:                                             ; preds = %2156, %2165
  %2173 = phi double [ %2171, %2165 ], [ 1.000000e+00, %2156 ]
  %2174 = phi i64 [ %2169, %2165 ], [ 0, %2156 ]
  %2175 = fcmp oeq double %2173, 1.000000e+00
  br i1 %2175, label %2176, label %2178

2176:                                             ; preds = %2172
  %2177 = load double, ptr %105, align 8, !noalias !22
  br label %2181

2178:                                             ; preds = %2172
  %2179 = fmul double %2173, %410
  %2180 = fadd double %376, %2179
  br label %2181

2181:                                             ; preds = %2178, %2176
  %2182 = phi double [ %2177, %2176 ], [ %2180, %2178 ]
  %2183 = icmp eq i64 %2174, -4
  %2184 = select i1 %2183, i64 -4, i64 0
  br i1 %2183, label %2238, label %2185

2185:                                             ; preds = %2181
  %2186 = fcmp uge double %2173, 1.000000e+00
  %2187 = load i64, ptr %116, align 8, !noalias !22
  %2188 = load i64, ptr %157, align 8, !noalias !22
  %2189 = icmp eq i64 %2188, 1
  %2190 = getelementptr i8, ptr %110, i64 48
  %2191 = load i64, ptr %2190, align 8, !noalias !22
  %2192 = icmp slt i64 %2191, %114
  br i1 %2192, label %2193, label %2236

2193:                                             ; preds = %2185
  %2194 = icmp slt i64 %2191, 0
  %2195 = select i1 %2194, i64 %114, i64 0
  %2196 = getelementptr double, ptr %115, i64 %2191
  %2197 = getelementptr double, ptr %2196, i64 %2195
  %2198 = load double, ptr %2197, align 8, !noalias !22
  %2199 = fcmp uge double %2198, %2182
  %2200 = fcmp une double %2198, %2182
  %2201 = or i1 %2200, %2186
  %2202 = and i1 %2199, %2201
  br i1 %2202, label %2236, label %2203

2203:                                             ; preds = %2226, %2193
  %2204 = phi i64 [ %2191, %2193 ], [ %2224, %2226 ]
  %2205 = icmp slt i64 %2204, 0
  %2206 = select i1 %2205, i64 %114, i64 0
  %2207 = getelementptr double, ptr %115, i64 %2204
  %2208 = getelementptr double, ptr %2207, i64 %2206
  %2209 = load double, ptr %2208, align 8, !noalias !22
  %2210 = fsub double %2209, %376
  %2211 = fdiv double %2210, %410
  %2212 = mul nsw i64 %2204, %2187
  %2213 = shl i64 %2212, 3
  %2214 = add i64 %2213, %1
  %2215 = call i64 @llvm.smax.i64(i64 %79, i64 0)
  br label %2739

2216:                                             ; preds = %2743
  %2217 = getelementptr i8, ptr %157, i64 56
  %2218 = load i64, ptr %2217, align 8, !noalias !22
  %2219 = load double, ptr %2208, align 8, !noalias !22
  %2220 = inttoptr i64 %2218 to ptr
  %2221 = call i64 %2220(i64 %0, double %2219, i64 %2214) #3, !noalias !22
  %2222 = icmp eq i64 %2221, 0
  br i1 %2222, label %2223, label %2238

2223:                                             ; preds = %2743, %2216
  %2224 = add nsw i64 %2204, 1
  %2225 = icmp slt i64 %2224, %114
  br i1 %2225, label %2226, label %2236

2226:                                             ; preds = %2223
  %2227 = icmp slt i64 %2204, -1
  %2228 = select i1 %2227, i64 %114, i64 0
  %2229 = getelementptr double, ptr %115, i64 %2224
  %2230 = getelementptr double, ptr %2229, i64 %2228
  %2231 = load double, ptr %2230, align 8, !noalias !22
  %2232 = fcmp uge double %2231, %2182
  %2233 = fcmp une double %2231, %2182
  %2234 = or i1 %2233, %2186
  %2235 = and i1 %2232, %2234
  br i1 %2235, label %2236, label %2203

2236:                                             ; preds = %2226, %2193, %2223, %2185
  %2237 = phi i64 [ %2191, %2193 ], [ %2224, %2226 ], [ %2224, %2223 ], [ %2191, %2185 ]
  store i64 %2237, ptr %2190, align 8, !noalias !22
  br label %2238

2238:                                             ; preds = %2216, %2236, %2181
  %2239 = phi i64 [ %2184, %2181 ], [ 0, %2236 ], [ %2221, %2216 ]
  %2240 = icmp eq i64 %2239, 0
  %2241 = icmp ne i64 %2174, 0
  %2242 = select i1 %2240, i1 %2241, i1 false
  %2243 = fcmp olt double %2173, 1.000000e+00
  %2244 = and i1 %2242, %2243
  br i1 %2244, label %2245, label %2283

2245:                                             ; preds = %2238
  %2246 = call i64 @llvm.smax.i64(i64 %79, i64 0)
  br label %2247

2247:                                             ; preds = %2245, %2271
  %2248 = phi i64 [ 0, %2245 ], [ %2273, %2271 ]
  %2249 = phi i64 [ %2246, %2245 ], [ %2272, %2271 ]
  %2250 = icmp sgt i64 %2249, 0
  br i1 %2250, label %2271, label %2251

2251:                                             ; preds = %2247
  %2252 = load i64, ptr %2088, align 8, !noalias !126
  %2253 = getelementptr i8, ptr %30, i64 16
  %2254 = load i64, ptr %2253, align 8, !noalias !126
  call fastcc void @pydy_nested(i64 %72, i64 %62, i64 %87, i64 %64, i64 %2252, i64 %77, i64 %2254) #3, !noalias !126
  %2255 = call i64 @llvm.smax.i64(i64 %69, i64 0)
  br label %2256

2256:                                             ; preds = %2260, %2251
  %2257 = phi i64 [ 0, %2251 ], [ %2262, %2260 ]
  %2258 = phi i64 [ %2255, %2251 ], [ %2261, %2260 ]
  %2259 = icmp sgt i64 %2258, 0
  br i1 %2259, label %2260, label %2754

2260:                                             ; preds = %2256
  %2261 = add nsw i64 %2258, -1
  %2262 = add i64 %2257, 1
  %2263 = icmp slt i64 %2257, 0
  %2264 = select i1 %2263, i64 %74, i64 0
  %2265 = getelementptr double, ptr %75, i64 %2257
  %2266 = getelementptr double, ptr %2265, i64 %2264
  %2267 = load double, ptr %2266, align 8, !noalias !130
  %2268 = select i1 %2263, i64 %69, i64 0
  %2269 = getelementptr double, ptr %70, i64 %2257
  %2270 = getelementptr double, ptr %2269, i64 %2268
  store double %2267, ptr %2270, align 8, !noalias !130
  br label %2256

2271:                                             ; preds = %2247
  %2272 = add nsw i64 %2249, -1
  %2273 = add i64 %2248, 1
  %2274 = icmp slt i64 %2248, 0
  %2275 = select i1 %2274, i64 %79, i64 0
  %2276 = getelementptr double, ptr %80, i64 %2248
  %2277 = getelementptr double, ptr %2276, i64 %2275
  store double %2173, ptr %2277, align 8, !noalias !126
  br label %2247

2278:                                             ; preds = %2754
  %2279 = getelementptr i8, ptr %157, i64 56
  %2280 = load i64, ptr %2279, align 8, !noalias !22
  %2281 = inttoptr i64 %2280 to ptr
  %2282 = call i64 %2281(i64 %0, double %2182, i64 %67) #3, !noalias !22
  br label %2283

2283:                                             ; preds = %2754, %2278, %2238
  %2284 = phi i64 [ %2282, %2278 ], [ 0, %2754 ], [ %2239, %2238 ]
  %2285 = icmp eq i64 %2284, 0
  br i1 %2285, label %2287, label %2286

2286:                                             ; preds = %2283
  store double %376, ptr %105, align 8, !noalias !22
  store double %410, ptr %308, align 8, !noalias !22
  br label %2309

2287:                                             ; preds = %2283
  br i1 %2175, label %2288, label %2290

2288:                                             ; preds = %2287
  store i8 0, ptr %24, align 1, !noalias !12
  %2289 = call fastcc i32 @write_reached(ptr nonnull %24, ptr %30, ptr %70, i64 %69, ptr nonnull %105, ptr nonnull %110, i64 %114, ptr %115, i64 %114, ptr %119, i64 %118) #3
  switch i32 %2289, label %2757 [
    i32 -2, label %2290
    i32 0, label %2290
  ], !prof !33

2290:                                             ; preds = %2288, %2288, %2287
  %2291 = icmp eq i64 %2174, 0
  br i1 %2291, label %2309, label %2292

2292:                                             ; preds = %2290
  %2293 = call i64 @llvm.smax.i64(i64 %64, i64 0)
  br label %2294

2294:                                             ; preds = %2298, %2292
  %2295 = phi i64 [ 0, %2292 ], [ %2300, %2298 ]
  %2296 = phi i64 [ %2293, %2292 ], [ %2299, %2298 ]
  %2297 = icmp sgt i64 %2296, 0
  br i1 %2297, label %2298, label %2758

2298:                                             ; preds = %2294
  %2299 = add nsw i64 %2296, -1
  %2300 = add i64 %2295, 1
  %2301 = icmp slt i64 %2295, 0
  %2302 = select i1 %2301, i64 %69, i64 0
  %2303 = getelementptr double, ptr %70, i64 %2295
  %2304 = getelementptr double, ptr %2303, i64 %2302
  %2305 = load double, ptr %2304, align 8, !noalias !133
  %2306 = select i1 %2301, i64 %64, i64 0
  %2307 = getelementptr double, ptr %65, i64 %2295
  %2308 = getelementptr double, ptr %2307, i64 %2306
  store double %2305, ptr %2308, align 8, !noalias !133
  br label %2294

2309:                                             ; preds = %2290, %2758, %2286
  %2310 = phi i64 [ %2284, %2286 ], [ %2174, %2758 ], [ 0, %2290 ]
  switch i64 %2310, label %2326 [
    i64 6, label %2311
    i64 0, label %2329
  ]

2311:                                             ; preds = %2309
  %2312 = load i64, ptr %2736, align 8, !noalias !22
  %2313 = icmp eq i64 %2312, 0
  br i1 %2313, label %2314, label %2326

2314:                                             ; preds = %2311
  %2315 = load i64, ptr %391, align 8, !noalias !22
  %2316 = add nsw i64 %2315, -1
  store i64 %2316, ptr %391, align 8, !noalias !22
  %2317 = load i64, ptr %275, align 8, !noalias !22
  %2318 = add nsw i64 %2317, -1
  store i64 %2318, ptr %275, align 8, !noalias !22
  %2319 = load i64, ptr %393, align 8, !noalias !22
  %2320 = add nsw i64 %2319, 1
  store i64 %2320, ptr %393, align 8, !noalias !22
  %2321 = fmul double %410, 2.500000e-01
  %2322 = getelementptr i8, ptr %110, i64 72
  store i64 6, ptr %2322, align 8, !noalias !22
  %2323 = getelementptr i8, ptr %196, i64 16
  %2324 = load i64, ptr %2323, align 8, !noalias !22
  %2325 = sub nsw i64 1, %2324
  store i64 1, ptr %1909, align 8, !noalias !22
  store i64 %2325, ptr %418, align 8, !noalias !22
  store double 0.000000e+00, ptr %791, align 8, !noalias !22
  br label %2448

2326:                                             ; preds = %2311, %2309
  %2327 = load i64, ptr %275, align 8, !noalias !22
  %2328 = add nsw i64 %2327, 1
  store i64 %2328, ptr %275, align 8, !noalias !22
  br label %2773

2329:                                             ; preds = %2309, %2156
  br label %2330

2330:                                             ; preds = %2329, %2759
  %2331 = phi i64 [ 0, %2329 ], [ %2761, %2759 ]
  %2332 = phi i64 [ %292, %2329 ], [ %2760, %2759 ]
  %2333 = icmp sgt i64 %2332, 0
  br i1 %2333, label %2759, label %2334

2334:                                             ; preds = %2330
  %2335 = getelementptr i8, ptr %110, i64 24
  %2336 = load i64, ptr %2335, align 8, !noalias !22
  %2337 = add nsw i64 %2336, 1
  store i64 %2337, ptr %2335, align 8, !noalias !22
  store ptr null, ptr %15, align 8, !noalias !136
  store ptr null, ptr %16, align 8, !noalias !136
  store double %411, ptr %33, align 8, !noalias !136
  %2338 = icmp sgt i64 %45, 0
  br i1 %2338, label %2339, label %2342

2339:                                             ; preds = %2334
  store ptr null, ptr %15, align 8, !noalias !136
  %2340 = call fastcc i32 @_sample(ptr nonnull %15, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %411) #3
  switch i32 %2340, label %2341 [
    i32 -2, label %2342
    i32 0, label %2342
  ], !prof !33

2341:                                             ; preds = %2339
  br label %2342

2342:                                             ; preds = %2339, %2339, %2334, %2341
  %2343 = phi i32 [ %2340, %2341 ], [ 0, %2334 ], [ 0, %2339 ], [ 0, %2339 ]
  switch i32 %2343, label %2348 [
    i32 -2, label %2344
    i32 0, label %2344
  ], !prof !33

2344:                                             ; preds = %2342, %2342
  %2345 = load i64, ptr %30, align 8, !noalias !143
  %2346 = inttoptr i64 %2345 to ptr
  %2347 = call i32 %2346(ptr nonnull %33, ptr %65, ptr %38, ptr %41, ptr %85) #3, !noalias !143
  br label %2348

2348:                                             ; preds = %2342, %2344
  %2349 = phi i32 [ %2347, %2344 ], [ 0, %2342 ]
  %2350 = phi i32 [ 0, %2344 ], [ %2343, %2342 ]
  switch i32 %2350, label %2772 [
    i32 -2, label %2770
    i32 0, label %2770
  ], !prof !33

2351:                                             ; preds = %2770
  %2352 = getelementptr i8, ptr %110, i64 72
  store i64 3, ptr %2352, align 8, !noalias !22
  store double %410, ptr %308, align 8, !noalias !22
  %2353 = icmp slt i32 %2349, 0
  %2354 = select i1 %2353, i64 -4, i64 2
  br label %2773

2355:                                             ; preds = %2770
  %2356 = icmp sgt i64 %1898, 2
  %2357 = fcmp ogt double %1897, 1.000000e-03
  %2358 = select i1 %2356, i1 %2357, i1 false
  %2359 = zext i1 %2358 to i64
  store i64 %2359, ptr %418, align 8, !noalias !22
  %2360 = getelementptr i8, ptr %196, i64 16
  store i64 0, ptr %2360, align 8, !noalias !22
  store i64 0, ptr %1909, align 8, !noalias !22
  %2361 = fcmp ule double %2077, 1.000000e+00
  %2362 = fcmp uge double %2077, 1.200000e+00
  %2363 = or i1 %2361, %2362
  %2364 = select i1 %2363, i1 true, i1 %2358
  br i1 %2364, label %2365, label %2369

2365:                                             ; preds = %2355
  %2366 = fcmp ogt double %2077, 2.000000e-01
  %2367 = select i1 %2366, double %2077, double 2.000000e-01
  %2368 = fmul double %410, %2367
  br label %2369

2369:                                             ; preds = %2355, %2365
  %2370 = phi double [ %2368, %2365 ], [ %410, %2355 ]
  %2371 = getelementptr i8, ptr %110, i64 48
  %2372 = load i64, ptr %2371, align 8, !noalias !22
  %2373 = icmp eq i64 %2372, %114
  br i1 %2373, label %2451, label %374

2374:                                             ; preds = %2032
  %2375 = load i64, ptr %393, align 8, !noalias !22
  %2376 = add nsw i64 %2375, 1
  store i64 %2376, ptr %393, align 8, !noalias !22
  %2377 = select i1 %2039, i64 2, i64 3
  %2378 = getelementptr i8, ptr %110, i64 72
  store i64 %2377, ptr %2378, align 8, !noalias !22
  %2379 = fsub double %2028, %2028
  %2380 = fcmp ord double %2379, 0.000000e+00
  br i1 %2380, label %2381, label %2385

2381:                                             ; preds = %2374
  %2382 = fmul double %2035, %2038
  %2383 = fcmp ogt double %2382, 2.000000e-01
  %2384 = select i1 %2383, double %2382, double 2.000000e-01
  br label %2385

2385:                                             ; preds = %2381, %2374
  %2386 = phi double [ 2.500000e-01, %2374 ], [ %2384, %2381 ]
  %2387 = fmul double %410, %2386
  %2388 = getelementptr i8, ptr %196, i64 16
  %2389 = load i64, ptr %2388, align 8, !noalias !22
  %2390 = sub nsw i64 1, %2389
  store i64 1, ptr %1909, align 8, !noalias !22
  store i64 %2390, ptr %418, align 8, !noalias !22
  br label %2448

2391:                                             ; preds = %1903
  %2392 = load i64, ptr %393, align 8, !noalias !22
  %2393 = add nsw i64 %2392, 1
  store i64 %2393, ptr %393, align 8, !noalias !22
  %2394 = icmp eq i64 %1900, 0
  br i1 %2394, label %2397, label %2395

2395:                                             ; preds = %2391
  %2396 = getelementptr i8, ptr %110, i64 72
  store i64 3, ptr %2396, align 8, !noalias !22
  br label %2404

2397:                                             ; preds = %2391
  %2398 = fsub double %1897, %1897
  %2399 = fcmp ord double %2398, 0.000000e+00
  br i1 %2399, label %2400, label %2402

2400:                                             ; preds = %2397
  %2401 = getelementptr i8, ptr %110, i64 72
  store i64 7, ptr %2401, align 8, !noalias !22
  br label %2404

2402:                                             ; preds = %2397
  %2403 = getelementptr i8, ptr %110, i64 72
  store i64 4, ptr %2403, align 8, !noalias !22
  br label %2404

2404:                                             ; preds = %2402, %2400, %2395
  %2405 = getelementptr i8, ptr %196, i64 16
  %2406 = load i64, ptr %2405, align 8, !noalias !22
  %2407 = icmp eq i64 %2406, 1
  %2408 = and i1 %2407, %2394
  br i1 %2408, label %2409, label %2436

2409:                                             ; preds = %2404
  %2410 = call i64 @llvm.smax.i64(i64 %206, i64 0)
  br label %2411

2411:                                             ; preds = %2423, %2409
  %2412 = phi i64 [ 0, %2409 ], [ %2431, %2423 ]
  %2413 = phi i64 [ %2410, %2409 ], [ %2430, %2423 ]
  %2414 = phi i1 [ false, %2409 ], [ %2424, %2423 ]
  %2415 = icmp sgt i64 %2413, 0
  br i1 %2415, label %2429, label %2432

2416:                                             ; preds = %2429
  %2417 = icmp slt i64 %2412, 0
  %2418 = select i1 %2417, i64 %206, i64 0
  %2419 = getelementptr double, ptr %207, i64 %2412
  %2420 = getelementptr double, ptr %2419, i64 %2418
  %2421 = load double, ptr %2420, align 8, !noalias !144
  %2422 = fcmp une double %2421, 0.000000e+00
  br label %2423

2423:                                             ; preds = %2429, %2416
  %2424 = phi i1 [ true, %2429 ], [ %2422, %2416 ]
  %2425 = icmp slt i64 %2412, 0
  %2426 = select i1 %2425, i64 %206, i64 0
  %2427 = getelementptr double, ptr %207, i64 %2412
  %2428 = getelementptr double, ptr %2427, i64 %2426
  store double 0.000000e+00, ptr %2428, align 8, !noalias !144
  br label %2411

2429:                                             ; preds = %2411
  %2430 = add nsw i64 %2413, -1
  %2431 = add i64 %2412, 1
  br i1 %2414, label %2423, label %2416

2432:                                             ; preds = %2411
  br i1 %2414, label %2433, label %2434

2433:                                             ; preds = %2432
  store i64 0, ptr %469, align 8, !noalias !22
  br label %2448

2434:                                             ; preds = %2432
  store i64 0, ptr %2405, align 8, !noalias !22
  %2435 = fmul double %410, 5.000000e-01
  br label %2436

2436:                                             ; preds = %2434, %2404
  %2437 = phi double [ %2435, %2434 ], [ %375, %2404 ]
  %2438 = load i64, ptr %2405, align 8, !noalias !22
  %2439 = icmp ne i64 %2438, 1
  %2440 = and i1 %2439, %2394
  br i1 %2440, label %2444, label %2441

2441:                                             ; preds = %2436
  %2442 = select i1 %2394, double 5.000000e-01, double 2.500000e-01
  %2443 = fmul double %410, %2442
  store double 0.000000e+00, ptr %791, align 8, !noalias !22
  br label %2444

2444:                                             ; preds = %2436, %2441
  %2445 = phi double [ %2443, %2441 ], [ %2437, %2436 ]
  %2446 = load i64, ptr %2405, align 8, !noalias !22
  %2447 = sub nsw i64 1, %2446
  store i64 %2447, ptr %418, align 8, !noalias !22
  br label %2448

2448:                                             ; preds = %2444, %2433, %2385, %2314, %2049, %782
  %2449 = phi double [ %2387, %2385 ], [ %2052, %2049 ], [ %2321, %2314 ], [ %375, %2433 ], [ %2445, %2444 ], [ %785, %782 ]
  br label %371

2450:                                             ; preds = %400
  store double %410, ptr %308, align 8, !noalias !22
  br label %2773

2451:                                             ; preds = %2369
  store double %2370, ptr %308, align 8, !noalias !22
  br label %2773

2452:                                             ; preds = %293
  %2453 = icmp slt i64 %294, 0
  %2454 = select i1 %2453, i64 %94, i64 0
  %2455 = getelementptr double, ptr %95, i64 %294
  %2456 = getelementptr double, ptr %2455, i64 %2454
  %2457 = load double, ptr %2456, align 8, !noalias !22
  %2458 = fcmp olt double %2457, %296
  %2459 = select i1 %2458, double %2457, double %296
  %2460 = add i64 %294, 1
  %2461 = add nsw i64 %295, -1
  br label %293

2462:                                             ; preds = %326, %326
  %2463 = icmp eq i32 %327, 0
  br i1 %2463, label %333, label %329

2464:                                             ; preds = %326
  br label %2773

2465:                                             ; preds = %333, %333
  %2466 = load i8, ptr %23, align 1, !noalias !12
  %2467 = icmp eq i8 %2466, 0
  br i1 %2467, label %340, label %339

2468:                                             ; preds = %333
  br label %2773

2469:                                             ; preds = %347, %342
  br label %2773

2470:                                             ; preds = %433, %433
  %2471 = load i64, ptr %196, align 8, !noalias !22
  %2472 = inttoptr i64 %2471 to ptr
  %2473 = call i32 %2472(ptr nonnull %33, ptr %65, ptr %38, ptr %202, ptr %207) #3, !noalias !22
  %2474 = sext i32 %2473 to i64
  br label %453

2475:                                             ; preds = %433
  br label %2773

2476:                                             ; preds = %437
  %2477 = add nsw i64 %439, -1
  %2478 = add i64 %438, 1
  %2479 = icmp slt i64 %438, 0
  %2480 = select i1 %2479, i64 %64, i64 0
  %2481 = getelementptr double, ptr %65, i64 %438
  %2482 = getelementptr double, ptr %2481, i64 %2480
  %2483 = load double, ptr %2482, align 8, !noalias !22
  %2484 = select i1 %2479, i64 %74, i64 0
  %2485 = getelementptr double, ptr %75, i64 %438
  %2486 = getelementptr double, ptr %2485, i64 %2484
  store double %2483, ptr %2486, align 8, !noalias !22
  br label %437

2487:                                             ; preds = %441
  %2488 = add nsw i64 %443, -1
  %2489 = add i64 %442, 1
  %2490 = icmp slt i64 %442, 0
  %2491 = select i1 %2490, i64 %64, i64 0
  %2492 = getelementptr double, ptr %65, i64 %442
  %2493 = getelementptr double, ptr %2492, i64 %2491
  %2494 = load double, ptr %2493, align 8, !noalias !22
  %2495 = call double @llvm.fabs.f64(double %2494)
  %2496 = fcmp olt double %2495, 1.000000e-05
  %2497 = select i1 %2496, double 1.000000e-05, double %2495
  %2498 = fmul double %2497, 1.500000e-08
  %2499 = fadd double %2494, %2498
  %2500 = fsub double %2499, %2494
  %2501 = select i1 %2490, i64 %74, i64 0
  %2502 = getelementptr double, ptr %75, i64 %442
  %2503 = getelementptr double, ptr %2502, i64 %2501
  store double %2499, ptr %2503, align 8, !noalias !22
  %2504 = getelementptr i8, ptr %110, i64 24
  %2505 = load i64, ptr %2504, align 8, !noalias !22
  %2506 = add nsw i64 %2505, 1
  store i64 %2506, ptr %2504, align 8, !noalias !22
  store ptr null, ptr %17, align 8, !noalias !147
  store ptr null, ptr %18, align 8, !noalias !147
  store double %376, ptr %33, align 8, !noalias !147
  %2507 = icmp sgt i64 %45, 0
  br i1 %2507, label %2508, label %2511

2508:                                             ; preds = %2487
  store ptr null, ptr %17, align 8, !noalias !147
  %2509 = call fastcc i32 @_sample(ptr nonnull %17, ptr %38, i64 %37, ptr %48, i64 %45, i64 %47, ptr %53, i64 %52, ptr %60, i64 %57, i64 %59, double %376) #3
  switch i32 %2509, label %2510 [
    i32 -2, label %2511
    i32 0, label %2511
  ], !prof !33

2510:                                             ; preds = %2508
  br label %2511

2511:                                             ; preds = %2508, %2508, %2487, %2510
  %2512 = phi i32 [ %2509, %2510 ], [ 0, %2487 ], [ 0, %2508 ], [ 0, %2508 ]
  switch i32 %2512, label %2517 [
    i32 -2, label %2513
    i32 0, label %2513
  ], !prof !33

2513:                                             ; preds = %2511, %2511
  %2514 = load i64, ptr %30, align 8, !noalias !154
  %2515 = inttoptr i64 %2514 to ptr
  %2516 = call i32 %2515(ptr nonnull %33, ptr %75, ptr %38, ptr %41, ptr %70) #3, !noalias !154
  br label %2517

2517:                                             ; preds = %2511, %2513
  %2518 = phi i32 [ %2516, %2513 ], [ 0, %2511 ]
  %2519 = phi i32 [ 0, %2513 ], [ %2512, %2511 ]
  switch i32 %2519, label %2522 [
    i32 -2, label %2520
    i32 0, label %2520
  ], !prof !33

2520:                                             ; preds = %2517, %2517
  %2521 = icmp eq i32 %2518, 0
  br i1 %2521, label %447, label %445

2522:                                             ; preds = %2517
  br label %2773

2523:                                             ; preds = %447
  %2524 = add nsw i64 %449, -1
  %2525 = add i64 %448, 1
  %2526 = icmp slt i64 %448, 0
  %2527 = select i1 %2526, i64 %69, i64 0
  %2528 = getelementptr double, ptr %70, i64 %448
  %2529 = getelementptr double, ptr %2528, i64 %2527
  %2530 = load double, ptr %2529, align 8, !noalias !22
  %2531 = select i1 %2526, i64 %84, i64 0
  %2532 = getelementptr double, ptr %85, i64 %448
  %2533 = getelementptr double, ptr %2532, i64 %2531
  %2534 = load double, ptr %2533, align 8, !noalias !22
  %2535 = fsub double %2530, %2534
  %2536 = fdiv double %2535, %2500
  %2537 = mul nsw i64 %448, %425
  %2538 = add nsw i64 %2537, %442
  %2539 = icmp slt i64 %2538, 0
  %2540 = select i1 %2539, i64 %206, i64 0
  %2541 = getelementptr double, ptr %207, i64 %2538
  %2542 = getelementptr double, ptr %2541, i64 %2540
  store double %2536, ptr %2542, align 8, !noalias !22
  br label %447

2543:                                             ; preds = %456
  %2544 = add nsw i64 %458, -1
  %2545 = add i64 %457, 1
  %2546 = icmp slt i64 %457, 0
  %2547 = select i1 %2546, i64 %206, i64 0
  %2548 = getelementptr double, ptr %207, i64 %457
  %2549 = getelementptr double, ptr %2548, i64 %2547
  %2550 = load double, ptr %2549, align 8, !noalias !22
  %2551 = fsub double %2550, %2550
  %2552 = fcmp ord double %2551, 0.000000e+00
  br i1 %2552, label %461, label %460

2553:                                             ; preds = %480
  %2554 = add nsw i64 %482, -1
  %2555 = add i64 %481, 1
  br label %484

2556:                                             ; preds = %484
  %2557 = add nsw i64 %486, -1
  %2558 = add i64 %485, 1
  %2559 = mul nsw i64 %481, %225
  %2560 = add nsw i64 %2559, %485
  %2561 = icmp slt i64 %2560, 0
  %2562 = select i1 %2561, i64 %206, i64 0
  %2563 = getelementptr double, ptr %207, i64 %2560
  %2564 = getelementptr double, ptr %2563, i64 %2562
  %2565 = load double, ptr %2564, align 8, !noalias !22
  %2566 = fneg double %2565
  %2567 = icmp slt i64 %481, 0
  %2568 = select i1 %2567, i64 %211, i64 0
  %2569 = add i64 %481, %2568
  %2570 = icmp slt i64 %485, 0
  %2571 = select i1 %2570, i64 %213, i64 0
  %2572 = mul i64 %2569, %213
  %2573 = getelementptr double, ptr %214, i64 %2572
  %2574 = getelementptr double, ptr %2573, i64 %485
  %2575 = getelementptr double, ptr %2574, i64 %2571
  store double %2566, ptr %2575, align 8, !noalias !22
  %2576 = load double, ptr %2564, align 8, !noalias !22
  %2577 = fneg double %2576
  %2578 = select i1 %2567, i64 %218, i64 0
  %2579 = add i64 %481, %2578
  %2580 = select i1 %2570, i64 %220, i64 0
  %2581 = mul i64 %2579, %220
  %2582 = getelementptr { double, double }, ptr %221, i64 %2581
  %2583 = getelementptr { double, double }, ptr %2582, i64 %485
  %2584 = getelementptr { double, double }, ptr %2583, i64 %2580
  store double %2577, ptr %2584, align 8, !noalias !22
  %2585 = getelementptr inbounds nuw i8, ptr %2584, i64 8
  store double 0.000000e+00, ptr %2585, align 8, !noalias !22
  br label %484

2586:                                             ; preds = %793
  %2587 = add nsw i64 %795, -1
  %2588 = add i64 %794, 1
  %2589 = fcmp ogt double %792, 0.000000e+00
  br i1 %2589, label %797, label %806

2590:                                             ; preds = %808
  %2591 = add nsw i64 %810, -1
  %2592 = add i64 %809, 1
  br i1 %2589, label %812, label %852

2593:                                             ; preds = %862
  %2594 = add nsw i64 %864, -1
  %2595 = add i64 %863, 1
  br label %866

2596:                                             ; preds = %866
  %2597 = add nsw i64 %868, -1
  %2598 = add i64 %867, 1
  %2599 = icmp slt i64 %863, 0
  %2600 = add i64 %863, 3
  %2601 = select i1 %2599, i64 %2600, i64 %863
  %2602 = mul i64 %2601, 24
  %2603 = getelementptr i8, ptr @1, i64 %2602
  %2604 = load double, ptr %2603, align 8, !noalias !22
  %2605 = icmp slt i64 %867, 0
  %2606 = select i1 %2605, i64 %237, i64 0
  %2607 = getelementptr double, ptr %238, i64 %867
  %2608 = getelementptr double, ptr %2607, i64 %2606
  %2609 = load double, ptr %2608, align 8, !noalias !22
  %2610 = fmul double %2604, %2609
  %2611 = getelementptr i8, ptr @2, i64 %2602
  %2612 = getelementptr i8, ptr %2611, i64 8
  %2613 = load double, ptr %2612, align 8, !noalias !22
  %2614 = getelementptr double, ptr %238, i64 %237
  %2615 = getelementptr double, ptr %2614, i64 %867
  %2616 = getelementptr double, ptr %2615, i64 %2606
  %2617 = load double, ptr %2616, align 8, !noalias !22
  %2618 = fmul double %2613, %2617
  %2619 = fadd double %2610, %2618
  %2620 = getelementptr i8, ptr @3, i64 %2602
  %2621 = getelementptr i8, ptr %2620, i64 16
  %2622 = load double, ptr %2621, align 8, !noalias !22
  %2623 = shl i64 %237, 4
  %2624 = getelementptr i8, ptr %238, i64 %2623
  %2625 = getelementptr double, ptr %2624, i64 %867
  %2626 = getelementptr double, ptr %2625, i64 %2606
  %2627 = load double, ptr %2626, align 8, !noalias !22
  %2628 = fmul double %2622, %2627
  %2629 = fadd double %2619, %2628
  %2630 = select i1 %2599, i64 %242, i64 0
  %2631 = add i64 %863, %2630
  %2632 = select i1 %2605, i64 %244, i64 0
  %2633 = mul i64 %2631, %244
  %2634 = getelementptr double, ptr %245, i64 %2633
  %2635 = getelementptr double, ptr %2634, i64 %867
  %2636 = getelementptr double, ptr %2635, i64 %2632
  store double %2629, ptr %2636, align 8, !noalias !22
  br label %866

2637:                                             ; preds = %1896, %1896
  %2638 = icmp slt i64 %1900, 0
  br i1 %2638, label %1902, label %1903

2639:                                             ; preds = %1896
  br label %2773

2640:                                             ; preds = %1904
  %2641 = add nsw i64 %1906, -1
  %2642 = add i64 %1905, 1
  %2643 = icmp slt i64 %1905, 0
  %2644 = select i1 %2643, i64 %64, i64 0
  %2645 = getelementptr double, ptr %65, i64 %1905
  %2646 = getelementptr double, ptr %2645, i64 %2644
  %2647 = load double, ptr %2646, align 8, !noalias !22
  %2648 = select i1 %2643, i64 %237, i64 0
  %2649 = shl i64 %237, 4
  %2650 = getelementptr i8, ptr %238, i64 %2649
  %2651 = getelementptr double, ptr %2650, i64 %1905
  %2652 = getelementptr double, ptr %2651, i64 %2648
  %2653 = load double, ptr %2652, align 8, !noalias !22
  %2654 = fadd double %2647, %2653
  %2655 = select i1 %2643, i64 %69, i64 0
  %2656 = getelementptr double, ptr %70, i64 %1905
  %2657 = getelementptr double, ptr %2656, i64 %2655
  store double %2654, ptr %2657, align 8, !noalias !22
  br label %1904

2658:                                             ; preds = %2027, %2027
  %2659 = icmp slt i64 %2029, 0
  br i1 %2659, label %2031, label %2032

2660:                                             ; preds = %2027
  br label %2773

2661:                                             ; preds = %2079
  %2662 = add nsw i64 %2081, -1
  %2663 = add i64 %2080, 1
  %2664 = icmp slt i64 %2080, 0
  %2665 = select i1 %2664, i64 %237, i64 0
  %2666 = getelementptr double, ptr %238, i64 %2080
  %2667 = getelementptr double, ptr %2666, i64 %2665
  %2668 = load double, ptr %2667, align 8, !noalias !22
  %2669 = fmul double %2668, 0xC039A12CE7B30915
  %2670 = getelementptr double, ptr %238, i64 %237
  %2671 = getelementptr double, ptr %2670, i64 %2080
  %2672 = getelementptr double, ptr %2671, i64 %2665
  %2673 = load double, ptr %2672, align 8, !noalias !22
  %2674 = fmul double %2673, 0x402497AF24BB677E
  %2675 = fadd double %2669, %2674
  %2676 = shl i64 %237, 4
  %2677 = getelementptr i8, ptr %238, i64 %2676
  %2678 = getelementptr double, ptr %2677, i64 %2080
  %2679 = getelementptr double, ptr %2678, i64 %2665
  %2680 = load double, ptr %2679, align 8, !noalias !22
  %2681 = fmul double %2680, 0xC005555555555555
  %2682 = fadd double %2675, %2681
  %2683 = fmul double %2668, 0x402F295C43B61425
  %2684 = fmul double %2673, 0xC021D406EE60BECF
  %2685 = fadd double %2683, %2684
  %2686 = fmul double %2680, 0x400AAAAAAAAAAAAB
  %2687 = fadd double %2685, %2686
  %2688 = select i1 %2664, i64 %69, i64 0
  %2689 = getelementptr double, ptr %70, i64 %2080
  %2690 = getelementptr double, ptr %2689, i64 %2688
  %2691 = load double, ptr %2690, align 8, !noalias !22
  %2692 = select i1 %2664, i64 %64, i64 0
  %2693 = getelementptr double, ptr %65, i64 %2080
  %2694 = getelementptr double, ptr %2693, i64 %2692
  %2695 = load double, ptr %2694, align 8, !noalias !22
  %2696 = fsub double %2691, %2695
  %2697 = select i1 %2664, i64 %89, i64 0
  %2698 = getelementptr double, ptr %90, i64 %2080
  %2699 = getelementptr double, ptr %2698, i64 %2697
  store double %2696, ptr %2699, align 8, !noalias !22
  %2700 = fneg double %2682
  %2701 = fsub double %2700, %2687
  %2702 = add nsw i64 %64, %2080
  %2703 = icmp slt i64 %2702, 0
  %2704 = select i1 %2703, i64 %89, i64 0
  %2705 = getelementptr double, ptr %90, i64 %2702
  %2706 = getelementptr double, ptr %2705, i64 %2704
  store double %2701, ptr %2706, align 8, !noalias !22
  %2707 = fneg double %2687
  %2708 = shl nsw i64 %64, 1
  %2709 = add nsw i64 %2708, %2080
  %2710 = icmp slt i64 %2709, 0
  %2711 = select i1 %2710, i64 %89, i64 0
  %2712 = getelementptr double, ptr %90, i64 %2709
  %2713 = getelementptr double, ptr %2712, i64 %2711
  store double %2707, ptr %2713, align 8, !noalias !22
  %2714 = load double, ptr %2694, align 8, !noalias !22
  %2715 = select i1 %2664, i64 %256, i64 0
  %2716 = getelementptr double, ptr %257, i64 %2080
  %2717 = getelementptr double, ptr %2716, i64 %2715
  store double %2714, ptr %2717, align 8, !noalias !22
  br label %2083

2718:                                             ; preds = %2083
  %2719 = add nsw i64 %2085, -1
  %2720 = add i64 %2084, 1
  %2721 = mul nsw i64 %2084, %64
  %2722 = add nsw i64 %2721, %2080
  %2723 = icmp slt i64 %2722, 0
  %2724 = select i1 %2723, i64 %89, i64 0
  %2725 = getelementptr double, ptr %90, i64 %2722
  %2726 = getelementptr double, ptr %2725, i64 %2724
  %2727 = load double, ptr %2726, align 8, !noalias !22
  %2728 = icmp slt i64 %2084, -1
  %2729 = select i1 %2728, i64 %254, i64 0
  %2730 = add i64 %2720, %2729
  %2731 = mul i64 %2730, %256
  %2732 = getelementptr double, ptr %257, i64 %2731
  %2733 = getelementptr double, ptr %2732, i64 %2080
  %2734 = getelementptr double, ptr %2733, i64 %2715
  store double %2727, ptr %2734, align 8, !noalias !22
  br label %2083

2735:                                             ; preds = %2117, %2087
  %2736 = getelementptr i8, ptr %160, i64 8
  %2737 = load i64, ptr %2736, align 8, !noalias !22
  %2738 = icmp sgt i64 %2737, 0
  br i1 %2738, label %2165, label %2156

2739:                                             ; preds = %2203, %2747
  %2740 = phi i64 [ 0, %2203 ], [ %2749, %2747 ]
  %2741 = phi i64 [ %2215, %2203 ], [ %2748, %2747 ]
  %2742 = icmp sgt i64 %2741, 0
  br i1 %2742, label %2747, label %2743

2743:                                             ; preds = %2739
  %2744 = load i64, ptr %2088, align 8, !noalias !155
  %2745 = getelementptr i8, ptr %30, i64 16
  %2746 = load i64, ptr %2745, align 8, !noalias !155
  call fastcc void @pydy_nested(i64 %2214, i64 %62, i64 %87, i64 %64, i64 %2744, i64 %77, i64 %2746) #3, !noalias !155
  br i1 %2189, label %2216, label %2223

2747:                                             ; preds = %2739
  %2748 = add nsw i64 %2741, -1
  %2749 = add i64 %2740, 1
  %2750 = icmp slt i64 %2740, 0
  %2751 = select i1 %2750, i64 %79, i64 0
  %2752 = getelementptr double, ptr %80, i64 %2740
  %2753 = getelementptr double, ptr %2752, i64 %2751
  store double %2211, ptr %2753, align 8, !noalias !155
  br label %2739

2754:                                             ; preds = %2256
  %2755 = load i64, ptr %157, align 8, !noalias !22
  %2756 = icmp eq i64 %2755, 1
  br i1 %2756, label %2278, label %2283

2757:                                             ; preds = %2288
  br label %2773

2758:                                             ; preds = %2294
  store double %2182, ptr %105, align 8, !noalias !22
  store double 0.000000e+00, ptr %308, align 8, !noalias !22
  store i64 0, ptr %110, align 8, !noalias !22
  br label %2309

2759:                                             ; preds = %2330
  %2760 = add nsw i64 %2332, -1
  %2761 = add i64 %2331, 1
  %2762 = icmp slt i64 %2331, 0
  %2763 = select i1 %2762, i64 %69, i64 0
  %2764 = getelementptr double, ptr %70, i64 %2331
  %2765 = getelementptr double, ptr %2764, i64 %2763
  %2766 = load double, ptr %2765, align 8, !noalias !22
  %2767 = select i1 %2762, i64 %64, i64 0
  %2768 = getelementptr double, ptr %65, i64 %2331
  %2769 = getelementptr double, ptr %2768, i64 %2767
  store double %2766, ptr %2769, align 8, !noalias !22
  br label %2330

2770:                                             ; preds = %2348, %2348
  %2771 = icmp eq i32 %2349, 0
  br i1 %2771, label %2355, label %2351

2772:                                             ; preds = %2348
  br label %2773

2773:                                             ; preds = %2772, %2757, %2660, %2639, %2522, %2475, %2469, %2468, %2464, %2451, %2450, %2351, %2326, %2031, %1902, %464, %399, %388, %379, %339, %329, %192
  %2774 = phi i64 [ 0, %2757 ], [ -1, %192 ], [ 2, %2450 ], [ %2310, %2326 ], [ -4, %1902 ], [ 0, %2639 ], [ 0, %2772 ], [ 0, %2464 ], [ %332, %329 ], [ 0, %2468 ], [ 0, %339 ], [ 0, %2469 ], [ -1, %379 ], [ %2354, %2351 ], [ -5, %388 ], [ 1, %399 ], [ 0, %2475 ], [ 0, %2522 ], [ -4, %464 ], [ 0, %2660 ], [ 0, %2451 ], [ -4, %2031 ]
  ret i64 %2774
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
!16 = !{!17, !13}
!17 = distinct !{!17, !18}
!18 = distinct !{!18}
!19 = !{!20, !17, !13}
!20 = distinct !{!20, !21}
!21 = distinct !{!21}
!22 = !{!13}
!23 = !{!24, !17, !13}
!24 = distinct !{!24, !25}
!25 = distinct !{!25}
!26 = !{!27, !29, !30, !32}
!27 = distinct !{!27, !28}
!28 = distinct !{!28}
!29 = distinct !{!29, !28}
!30 = distinct !{!30, !31}
!31 = distinct !{!31}
!32 = distinct !{!32, !31}
!33 = !{!"branch_weights", i32 1, i32 49, i32 49}
!34 = !{!30, !32}
!35 = !{!36, !38, !13, !15}
!36 = distinct !{!36, !37}
!37 = distinct !{!37}
!38 = distinct !{!38, !37}
!39 = !{!40}
!40 = distinct !{!40, !41}
!41 = distinct !{!41}
!42 = !{!43, !45}
!43 = distinct !{!43, !44}
!44 = distinct !{!44}
!45 = distinct !{!45, !44}
!46 = !{!47}
!47 = distinct !{!47, !48}
!48 = distinct !{!48}
!49 = !{!50, !52}
!50 = distinct !{!50, !51}
!51 = distinct !{!51}
!52 = distinct !{!52, !51}
!53 = !{!54, !56, !58, !50, !52}
!54 = distinct !{!54, !55}
!55 = distinct !{!55}
!56 = distinct !{!56, !57}
!57 = distinct !{!57}
!58 = distinct !{!58, !57}
!59 = !{!60, !62, !64, !50, !52}
!60 = distinct !{!60, !61}
!61 = distinct !{!61}
!62 = distinct !{!62, !63}
!63 = distinct !{!63}
!64 = distinct !{!64, !63}
!65 = !{!66, !68}
!66 = distinct !{!66, !67}
!67 = distinct !{!67}
!68 = distinct !{!68, !67}
!69 = !{!70, !72, !73, !75, !66, !68}
!70 = distinct !{!70, !71}
!71 = distinct !{!71}
!72 = distinct !{!72, !71}
!73 = distinct !{!73, !74}
!74 = distinct !{!74}
!75 = distinct !{!75, !74}
!76 = !{!73, !75, !66, !68}
!77 = !{!78, !66, !68}
!78 = distinct !{!78, !79}
!79 = distinct !{!79}
!80 = !{!81, !66, !68}
!81 = distinct !{!81, !82}
!82 = distinct !{!82}
!83 = !{!"branch_weights", i32 49, i32 1}
!84 = !{!85, !87, !66, !68}
!85 = distinct !{!85, !86}
!86 = distinct !{!86}
!87 = distinct !{!87, !86}
!88 = !{!89, !91, !93, !85, !87, !66, !68}
!89 = distinct !{!89, !90}
!90 = distinct !{!90}
!91 = distinct !{!91, !92}
!92 = distinct !{!92}
!93 = distinct !{!93, !92}
!94 = !{!95, !97, !99, !85, !87, !66, !68}
!95 = distinct !{!95, !96}
!96 = distinct !{!96}
!97 = distinct !{!97, !98}
!98 = distinct !{!98}
!99 = distinct !{!99, !98}
!100 = !{!101, !103, !66, !68}
!101 = distinct !{!101, !102}
!102 = distinct !{!102}
!103 = distinct !{!103, !102}
!104 = !{!105, !107, !66, !68}
!105 = distinct !{!105, !106}
!106 = distinct !{!106}
!107 = distinct !{!107, !106}
!108 = !{!109, !66, !68}
!109 = distinct !{!109, !110}
!110 = distinct !{!110}
!111 = !{!112, !114}
!112 = distinct !{!112, !113}
!113 = distinct !{!113}
!114 = distinct !{!114, !113}
!115 = !{!116, !118, !119, !121, !112, !114}
!116 = distinct !{!116, !117}
!117 = distinct !{!117}
!118 = distinct !{!118, !117}
!119 = distinct !{!119, !120}
!120 = distinct !{!120}
!121 = distinct !{!121, !120}
!122 = !{!119, !121, !112, !114}
!123 = !{!124}
!124 = distinct !{!124, !125}
!125 = distinct !{!125}
!126 = !{!127, !129, !13}
!127 = distinct !{!127, !128}
!128 = distinct !{!128}
!129 = distinct !{!129, !128}
!130 = !{!131}
!131 = distinct !{!131, !132}
!132 = distinct !{!132}
!133 = !{!134}
!134 = distinct !{!134, !135}
!135 = distinct !{!135}
!136 = !{!137, !139, !140, !142}
!137 = distinct !{!137, !138}
!138 = distinct !{!138}
!139 = distinct !{!139, !138}
!140 = distinct !{!140, !141}
!141 = distinct !{!141}
!142 = distinct !{!142, !141}
!143 = !{!140, !142}
!144 = !{!145}
!145 = distinct !{!145, !146}
!146 = distinct !{!146}
!147 = !{!148, !150, !151, !153}
!148 = distinct !{!148, !149}
!149 = distinct !{!149}
!150 = distinct !{!150, !149}
!151 = distinct !{!151, !152}
!152 = distinct !{!152}
!153 = distinct !{!153, !152}
!154 = !{!151, !153}
!155 = !{!156, !158, !13}
!156 = distinct !{!156, !157}
!157 = distinct !{!157}
!158 = distinct !{!158, !157}
