; sources 3492b45709d31986a91fba017fa448e03a3cd65d297173797556e6f6afff1ec1
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

define internal fastcc i32 @norm(ptr noalias %0, i64 %1, ptr %2, i64 %3, ptr %4, i64 %5, ptr %6, i64 %7, ptr %8, i64 %9, ptr %10, i64 %11) unnamed_addr {
  %13 = call i64 @llvm.smax.i64(i64 %1, i64 0)
  br label %14

14:                                               ; preds = %23, %12
  %15 = phi i64 [ 0, %12 ], [ %49, %23 ]
  %16 = phi i64 [ %13, %12 ], [ %50, %23 ]
  %17 = phi double [ 0.000000e+00, %12 ], [ %55, %23 ]
  %18 = icmp sgt i64 %16, 0
  br i1 %18, label %23, label %19

19:                                               ; preds = %14
  %20 = sitofp i64 %1 to double
  %21 = fdiv double %17, %20
  %22 = call double @sqrt(double %21)
  store double %22, ptr %0, align 8
  ret i32 0

23:                                               ; preds = %14
  %24 = icmp slt i64 %15, 0
  %25 = select i1 %24, i64 %3, i64 0
  %26 = getelementptr double, ptr %2, i64 %15
  %27 = getelementptr double, ptr %26, i64 %25
  %28 = load double, ptr %27, align 8
  %29 = select i1 %24, i64 %11, i64 0
  %30 = getelementptr double, ptr %10, i64 %15
  %31 = getelementptr double, ptr %30, i64 %29
  %32 = load double, ptr %31, align 8
  %33 = select i1 %24, i64 %9, i64 0
  %34 = getelementptr double, ptr %8, i64 %15
  %35 = getelementptr double, ptr %34, i64 %33
  %36 = load double, ptr %35, align 8
  %37 = select i1 %24, i64 %5, i64 0
  %38 = getelementptr double, ptr %4, i64 %15
  %39 = getelementptr double, ptr %38, i64 %37
  %40 = load double, ptr %39, align 8
  %41 = call double @llvm.fabs.f64(double %40)
  %42 = select i1 %24, i64 %7, i64 0
  %43 = getelementptr double, ptr %6, i64 %15
  %44 = getelementptr double, ptr %43, i64 %42
  %45 = load double, ptr %44, align 8
  %46 = call double @llvm.fabs.f64(double %45)
  %47 = fcmp ogt double %46, %41
  %48 = select i1 %47, double %46, double %41
  %49 = add i64 %15, 1
  %50 = add nsw i64 %16, -1
  %51 = fmul double %36, %48
  %52 = fadd double %32, %51
  %53 = fdiv double %28, %52
  %54 = fmul double %53, %53
  %55 = fadd double %17, %54
  br label %14
}

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
  %9 = alloca ptr, align 8
  %10 = alloca double, align 8
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
  %21 = alloca ptr, align 8
  %22 = alloca ptr, align 8
  %23 = alloca double, align 8
  %24 = alloca ptr, align 8
  %25 = alloca double, align 8
  %26 = alloca ptr, align 8
  store double 0.000000e+00, ptr %23, align 8, !noalias !5
  store ptr null, ptr %24, align 8, !noalias !5
  store double 0.000000e+00, ptr %25, align 8, !noalias !5
  store ptr null, ptr %26, align 8, !noalias !5
  %27 = inttoptr i64 %0 to ptr
  %28 = load i64, ptr %27, align 8, !noalias !9
  %29 = inttoptr i64 %28 to ptr
  %30 = getelementptr i8, ptr %27, i64 144
  %31 = load i64, ptr %30, align 8, !noalias !9
  %32 = inttoptr i64 %31 to ptr
  %33 = getelementptr i8, ptr %27, i64 168
  %34 = load i64, ptr %33, align 8, !noalias !9
  %35 = inttoptr i64 %34 to ptr
  %36 = getelementptr i8, ptr %27, i64 192
  %37 = load i64, ptr %36, align 8, !noalias !9
  %38 = getelementptr i8, ptr %27, i64 200
  %39 = load i64, ptr %38, align 8, !noalias !9
  %40 = inttoptr i64 %37 to ptr
  %41 = getelementptr i8, ptr %27, i64 216
  %42 = load i64, ptr %41, align 8, !noalias !9
  %43 = inttoptr i64 %42 to ptr
  %44 = getelementptr i8, ptr %27, i64 240
  %45 = load i64, ptr %44, align 8, !noalias !9
  %46 = getelementptr i8, ptr %27, i64 248
  %47 = load i64, ptr %46, align 8, !noalias !9
  %48 = getelementptr i8, ptr %27, i64 256
  %49 = load i64, ptr %48, align 8, !noalias !9
  %50 = inttoptr i64 %45 to ptr
  %51 = getelementptr i8, ptr %27, i64 264
  %52 = load i64, ptr %51, align 8, !noalias !9
  %53 = getelementptr i8, ptr %27, i64 272
  %54 = load i64, ptr %53, align 8, !noalias !9
  %55 = inttoptr i64 %52 to ptr
  %56 = getelementptr i8, ptr %27, i64 288
  %57 = load i64, ptr %56, align 8, !noalias !9
  %58 = getelementptr i8, ptr %27, i64 296
  %59 = load i64, ptr %58, align 8, !noalias !9
  %60 = getelementptr i8, ptr %27, i64 304
  %61 = load i64, ptr %60, align 8, !noalias !9
  %62 = inttoptr i64 %57 to ptr
  %63 = getelementptr i8, ptr %27, i64 312
  %64 = load i64, ptr %63, align 8, !noalias !9
  %65 = getelementptr i8, ptr %27, i64 320
  %66 = load i64, ptr %65, align 8, !noalias !9
  %67 = inttoptr i64 %64 to ptr
  %68 = getelementptr i8, ptr %27, i64 336
  %69 = load i64, ptr %68, align 8, !noalias !9
  %70 = getelementptr i8, ptr %27, i64 344
  %71 = load i64, ptr %70, align 8, !noalias !9
  %72 = inttoptr i64 %69 to ptr
  %73 = getelementptr i8, ptr %27, i64 360
  %74 = load i64, ptr %73, align 8, !noalias !9
  %75 = getelementptr i8, ptr %27, i64 368
  %76 = load i64, ptr %75, align 8, !noalias !9
  %77 = inttoptr i64 %74 to ptr
  %78 = getelementptr i8, ptr %27, i64 408
  %79 = load i64, ptr %78, align 8, !noalias !9
  %80 = getelementptr i8, ptr %27, i64 416
  %81 = load i64, ptr %80, align 8, !noalias !9
  %82 = inttoptr i64 %79 to ptr
  %83 = getelementptr i8, ptr %27, i64 480
  %84 = load i64, ptr %83, align 8, !noalias !9
  %85 = getelementptr i8, ptr %27, i64 488
  %86 = load i64, ptr %85, align 8, !noalias !9
  %87 = inttoptr i64 %84 to ptr
  %88 = getelementptr i8, ptr %27, i64 504
  %89 = load i64, ptr %88, align 8, !noalias !9
  %90 = getelementptr i8, ptr %27, i64 512
  %91 = load i64, ptr %90, align 8, !noalias !9
  %92 = inttoptr i64 %89 to ptr
  %93 = getelementptr i8, ptr %27, i64 528
  %94 = load i64, ptr %93, align 8, !noalias !9
  %95 = getelementptr i8, ptr %27, i64 536
  %96 = load i64, ptr %95, align 8, !noalias !9
  %97 = inttoptr i64 %94 to ptr
  %98 = getelementptr i8, ptr %27, i64 552
  %99 = load i64, ptr %98, align 8, !noalias !9
  %100 = getelementptr i8, ptr %27, i64 560
  %101 = load i64, ptr %100, align 8, !noalias !9
  %102 = inttoptr i64 %99 to ptr
  %103 = getelementptr i8, ptr %27, i64 576
  %104 = load i64, ptr %103, align 8, !noalias !9
  %105 = getelementptr i8, ptr %27, i64 584
  %106 = load i64, ptr %105, align 8, !noalias !9
  %107 = inttoptr i64 %104 to ptr
  %108 = getelementptr i8, ptr %27, i64 600
  %109 = load i64, ptr %108, align 8, !noalias !9
  %110 = getelementptr i8, ptr %27, i64 608
  %111 = load i64, ptr %110, align 8, !noalias !9
  %112 = inttoptr i64 %109 to ptr
  %113 = getelementptr i8, ptr %27, i64 624
  %114 = load i64, ptr %113, align 8, !noalias !9
  %115 = getelementptr i8, ptr %27, i64 632
  %116 = load i64, ptr %115, align 8, !noalias !9
  %117 = inttoptr i64 %114 to ptr
  %118 = getelementptr i8, ptr %32, i64 8
  %119 = load i64, ptr %118, align 8, !noalias !9
  %120 = mul nsw i64 %116, %119
  %121 = inttoptr i64 %1 to ptr
  %122 = icmp eq i64 %2, 1
  br i1 %122, label %123, label %156

123:                                              ; preds = %3
  %124 = getelementptr i8, ptr %27, i64 984
  %125 = load i64, ptr %124, align 8, !noalias !9
  %126 = getelementptr i8, ptr %27, i64 992
  %127 = load i64, ptr %126, align 8, !noalias !9
  %128 = inttoptr i64 %125 to ptr
  %129 = getelementptr i8, ptr %27, i64 1008
  %130 = load i64, ptr %129, align 8, !noalias !9
  %131 = getelementptr i8, ptr %27, i64 1016
  %132 = load i64, ptr %131, align 8, !noalias !9
  %133 = inttoptr i64 %130 to ptr
  %134 = call i64 @llvm.smax.i64(i64 %119, i64 0)
  br label %135

135:                                              ; preds = %166, %123
  %136 = phi i64 [ 0, %123 ], [ %168, %166 ]
  %137 = phi i64 [ %134, %123 ], [ %167, %166 ]
  %138 = icmp sgt i64 %137, 0
  br i1 %138, label %166, label %139

139:                                              ; preds = %135
  %140 = call i64 @llvm.smax.i64(i64 %106, i64 0)
  br label %141

141:                                              ; preds = %145, %139
  %142 = phi i64 [ 0, %139 ], [ %147, %145 ]
  %143 = phi i64 [ %140, %139 ], [ %146, %145 ]
  %144 = icmp sgt i64 %143, 0
  br i1 %144, label %145, label %177

145:                                              ; preds = %141
  %146 = add nsw i64 %143, -1
  %147 = add i64 %142, 1
  %148 = icmp slt i64 %142, 0
  %149 = select i1 %148, i64 %127, i64 0
  %150 = getelementptr double, ptr %128, i64 %142
  %151 = getelementptr double, ptr %150, i64 %149
  %152 = load double, ptr %151, align 8, !noalias !12
  %153 = select i1 %148, i64 %106, i64 0
  %154 = getelementptr double, ptr %107, i64 %142
  %155 = getelementptr double, ptr %154, i64 %153
  store double %152, ptr %155, align 8, !noalias !12
  br label %141

156:                                              ; preds = %179, %3
  %157 = getelementptr i8, ptr %27, i64 648
  %158 = load i64, ptr %157, align 8, !noalias !9
  %159 = inttoptr i64 %158 to ptr
  %160 = getelementptr i8, ptr %27, i64 720
  %161 = load i64, ptr %160, align 8, !noalias !9
  %162 = inttoptr i64 %161 to ptr
  %163 = getelementptr i8, ptr %112, i64 56
  %164 = load i64, ptr %163, align 8, !noalias !5
  %165 = icmp eq i64 %164, 0
  br i1 %165, label %194, label %195

166:                                              ; preds = %135
  %167 = add nsw i64 %137, -1
  %168 = add i64 %136, 1
  %169 = icmp slt i64 %136, 0
  %170 = select i1 %169, i64 %120, i64 0
  %171 = getelementptr double, ptr %121, i64 %136
  %172 = getelementptr double, ptr %171, i64 %170
  %173 = load double, ptr %172, align 8, !noalias !9
  %174 = select i1 %169, i64 %66, i64 0
  %175 = getelementptr double, ptr %67, i64 %136
  %176 = getelementptr double, ptr %175, i64 %174
  store double %173, ptr %176, align 8, !noalias !9
  br label %135

177:                                              ; preds = %141
  %178 = call i64 @llvm.smax.i64(i64 %111, i64 0)
  br label %179

179:                                              ; preds = %183, %177
  %180 = phi i64 [ 0, %177 ], [ %185, %183 ]
  %181 = phi i64 [ %178, %177 ], [ %184, %183 ]
  %182 = icmp sgt i64 %181, 0
  br i1 %182, label %183, label %156

183:                                              ; preds = %179
  %184 = add nsw i64 %181, -1
  %185 = add i64 %180, 1
  %186 = icmp slt i64 %180, 0
  %187 = select i1 %186, i64 %132, i64 0
  %188 = getelementptr i64, ptr %133, i64 %180
  %189 = getelementptr i64, ptr %188, i64 %187
  %190 = load i64, ptr %189, align 8, !noalias !15
  %191 = select i1 %186, i64 %111, i64 0
  %192 = getelementptr i64, ptr %112, i64 %180
  %193 = getelementptr i64, ptr %192, i64 %191
  store i64 %190, ptr %193, align 8, !noalias !15
  br label %179

194:                                              ; preds = %156
  br label %2649

195:                                              ; preds = %156
  %196 = getelementptr i8, ptr %27, i64 1032
  %197 = load i64, ptr %196, align 8, !noalias !5
  %198 = inttoptr i64 %197 to ptr
  %199 = getelementptr i8, ptr %27, i64 1056
  %200 = load i64, ptr %199, align 8, !noalias !5
  %201 = inttoptr i64 %200 to ptr
  %202 = getelementptr i8, ptr %27, i64 1080
  %203 = load i64, ptr %202, align 8, !noalias !5
  %204 = inttoptr i64 %203 to ptr
  %205 = getelementptr i8, ptr %27, i64 1104
  %206 = load i64, ptr %205, align 8, !noalias !5
  %207 = getelementptr i8, ptr %27, i64 1112
  %208 = load i64, ptr %207, align 8, !noalias !5
  %209 = inttoptr i64 %206 to ptr
  %210 = getelementptr i8, ptr %27, i64 1128
  %211 = load i64, ptr %210, align 8, !noalias !5
  %212 = getelementptr i8, ptr %27, i64 1136
  %213 = load i64, ptr %212, align 8, !noalias !5
  %214 = getelementptr i8, ptr %27, i64 1144
  %215 = load i64, ptr %214, align 8, !noalias !5
  %216 = inttoptr i64 %211 to ptr
  %217 = getelementptr i8, ptr %27, i64 1152
  %218 = load i64, ptr %217, align 8, !noalias !5
  %219 = getelementptr i8, ptr %27, i64 1160
  %220 = load i64, ptr %219, align 8, !noalias !5
  %221 = getelementptr i8, ptr %27, i64 1168
  %222 = load i64, ptr %221, align 8, !noalias !5
  %223 = inttoptr i64 %218 to ptr
  %224 = getelementptr i8, ptr %27, i64 1176
  %225 = load i64, ptr %224, align 8, !noalias !5
  %226 = getelementptr i8, ptr %27, i64 1184
  %227 = load i64, ptr %226, align 8, !noalias !5
  %228 = inttoptr i64 %225 to ptr
  %229 = getelementptr i8, ptr %27, i64 1200
  %230 = load i64, ptr %229, align 8, !noalias !5
  %231 = getelementptr i8, ptr %27, i64 1208
  %232 = load i64, ptr %231, align 8, !noalias !5
  %233 = inttoptr i64 %230 to ptr
  %234 = getelementptr i8, ptr %27, i64 1224
  %235 = load i64, ptr %234, align 8, !noalias !5
  %236 = getelementptr i8, ptr %27, i64 1232
  %237 = load i64, ptr %236, align 8, !noalias !5
  %238 = getelementptr i8, ptr %27, i64 1240
  %239 = load i64, ptr %238, align 8, !noalias !5
  %240 = inttoptr i64 %235 to ptr
  %241 = getelementptr i8, ptr %27, i64 1248
  %242 = load i64, ptr %241, align 8, !noalias !5
  %243 = getelementptr i8, ptr %27, i64 1256
  %244 = load i64, ptr %243, align 8, !noalias !5
  %245 = getelementptr i8, ptr %27, i64 1264
  %246 = load i64, ptr %245, align 8, !noalias !5
  %247 = inttoptr i64 %242 to ptr
  %248 = getelementptr i8, ptr %27, i64 1272
  %249 = load i64, ptr %248, align 8, !noalias !5
  %250 = getelementptr i8, ptr %27, i64 1288
  %251 = load i64, ptr %250, align 8, !noalias !5
  %252 = inttoptr i64 %249 to ptr
  %253 = getelementptr i8, ptr %27, i64 1296
  %254 = load i64, ptr %253, align 8, !noalias !5
  %255 = getelementptr i8, ptr %27, i64 1304
  %256 = load i64, ptr %255, align 8, !noalias !5
  %257 = getelementptr i8, ptr %27, i64 1312
  %258 = load i64, ptr %257, align 8, !noalias !5
  %259 = inttoptr i64 %254 to ptr
  %260 = getelementptr i8, ptr %27, i64 1320
  %261 = load i64, ptr %260, align 8, !noalias !5
  %262 = getelementptr i8, ptr %27, i64 1328
  %263 = load i64, ptr %262, align 8, !noalias !5
  %264 = inttoptr i64 %261 to ptr
  %265 = getelementptr i8, ptr %27, i64 1344
  %266 = load i64, ptr %265, align 8, !noalias !5
  %267 = getelementptr i8, ptr %27, i64 1352
  %268 = load i64, ptr %267, align 8, !noalias !5
  %269 = inttoptr i64 %266 to ptr
  %270 = getelementptr i8, ptr %27, i64 1368
  %271 = load i64, ptr %270, align 8, !noalias !5
  %272 = getelementptr i8, ptr %27, i64 1376
  %273 = load i64, ptr %272, align 8, !noalias !5
  %274 = inttoptr i64 %271 to ptr
  %275 = load i64, ptr %118, align 8, !noalias !5
  %276 = load i64, ptr %159, align 8, !noalias !5
  %277 = icmp eq i64 %276, 1
  %278 = call i64 @llvm.smin.i64(i64 %116, i64 0)
  %279 = getelementptr double, ptr %117, i64 %116
  %280 = getelementptr i8, ptr %279, i64 -8
  %281 = getelementptr double, ptr %280, i64 %278
  %282 = load double, ptr %281, align 8, !noalias !5
  %283 = load double, ptr %97, align 8, !noalias !5
  %284 = call i64 @llvm.smax.i64(i64 %275, i64 0)
  br label %285

285:                                              ; preds = %2290, %195
  %286 = phi i64 [ 0, %195 ], [ %2298, %2290 ]
  %287 = phi i64 [ %284, %195 ], [ %2299, %2290 ]
  %288 = phi double [ %283, %195 ], [ %2297, %2290 ]
  %289 = icmp sgt i64 %287, 0
  br i1 %289, label %2290, label %290

290:                                              ; preds = %285
  %291 = fcmp olt double %288, 0x3CB0000000000000
  %292 = select i1 %291, double 0x3CB0000000000000, double %288
  %293 = call double @sqrt(double %288), !noalias !5
  %294 = fcmp olt double %293, 3.000000e-02
  %295 = select i1 %294, double %293, double 3.000000e-02
  %296 = fdiv double 0x3CE4000000000000, %292
  %297 = fcmp ogt double %295, %296
  %298 = select i1 %297, double %295, double %296
  %299 = load double, ptr %107, align 8, !noalias !5
  %300 = getelementptr i8, ptr %107, i64 8
  %301 = load double, ptr %300, align 8, !noalias !5
  %302 = load i64, ptr %112, align 8, !noalias !5
  %303 = icmp eq i64 %302, 0
  br i1 %303, label %304, label %385

304:                                              ; preds = %290
  %305 = getelementptr i8, ptr %112, i64 24
  %306 = load i64, ptr %305, align 8, !noalias !5
  %307 = add nsw i64 %306, 1
  store i64 %307, ptr %305, align 8, !noalias !5
  store ptr null, ptr %21, align 8, !noalias !18
  store ptr null, ptr %22, align 8, !noalias !18
  store double %299, ptr %35, align 8, !noalias !18
  %308 = icmp sgt i64 %47, 0
  br i1 %308, label %309, label %312

309:                                              ; preds = %304
  store ptr null, ptr %21, align 8, !noalias !18
  %310 = call fastcc i32 @_sample(ptr nonnull %21, ptr %40, i64 %39, ptr %50, i64 %47, i64 %49, ptr %55, i64 %54, ptr %62, i64 %59, i64 %61, double %299) #3
  switch i32 %310, label %311 [
    i32 -2, label %312
    i32 0, label %312
  ], !prof !25

311:                                              ; preds = %309
  br label %312

312:                                              ; preds = %309, %309, %304, %311
  %313 = phi i32 [ %310, %311 ], [ 0, %304 ], [ 0, %309 ], [ 0, %309 ]
  switch i32 %313, label %318 [
    i32 -2, label %314
    i32 0, label %314
  ], !prof !25

314:                                              ; preds = %312, %312
  %315 = load i64, ptr %32, align 8, !noalias !26
  %316 = inttoptr i64 %315 to ptr
  %317 = call i32 %316(ptr nonnull %35, ptr %67, ptr %40, ptr %43, ptr %87) #3, !noalias !26
  br label %318

318:                                              ; preds = %312, %314
  %319 = phi i32 [ %317, %314 ], [ 0, %312 ]
  %320 = phi i32 [ 0, %314 ], [ %313, %312 ]
  switch i32 %320, label %2302 [
    i32 -2, label %2300
    i32 0, label %2300
  ], !prof !25

321:                                              ; preds = %2300
  %322 = getelementptr i8, ptr %112, i64 72
  store i64 3, ptr %322, align 8, !noalias !5
  %323 = icmp slt i32 %319, 0
  %324 = select i1 %323, i64 -4, i64 2
  br label %2649

325:                                              ; preds = %2300
  store i64 1, ptr %112, align 8, !noalias !5
  %326 = getelementptr i8, ptr %107, i64 24
  store double 0.000000e+00, ptr %326, align 8, !noalias !5
  %327 = getelementptr i8, ptr %198, i64 8
  store i64 1, ptr %327, align 8, !noalias !5
  %328 = getelementptr i8, ptr %198, i64 32
  store i64 1, ptr %328, align 8, !noalias !5
  %329 = getelementptr i8, ptr %201, i64 8
  store double 0.000000e+00, ptr %329, align 8, !noalias !5
  %330 = load i64, ptr %118, align 8, !noalias !27
  %331 = getelementptr i8, ptr %112, i64 48
  %332 = load i64, ptr %331, align 8, !noalias !27
  %333 = icmp slt i64 %332, %116
  br i1 %333, label %334, label %374

334:                                              ; preds = %325
  %335 = icmp slt i64 %332, 0
  %336 = select i1 %335, i64 %116, i64 0
  %337 = getelementptr double, ptr %117, i64 %332
  %338 = getelementptr double, ptr %337, i64 %336
  %339 = load double, ptr %338, align 8, !noalias !27
  %340 = load double, ptr %107, align 8, !noalias !27
  %341 = fcmp ugt double %339, %340
  br i1 %341, label %374, label %342

342:                                              ; preds = %352, %334
  %343 = phi i64 [ %350, %352 ], [ %332, %334 ]
  %344 = call i64 @llvm.smax.i64(i64 %330, i64 0)
  br label %345

345:                                              ; preds = %360, %342
  %346 = phi i64 [ 0, %342 ], [ %362, %360 ]
  %347 = phi i64 [ %344, %342 ], [ %361, %360 ]
  %348 = icmp sgt i64 %347, 0
  br i1 %348, label %360, label %349

349:                                              ; preds = %345
  %350 = add nsw i64 %343, 1
  %351 = icmp slt i64 %350, %116
  br i1 %351, label %352, label %374

352:                                              ; preds = %349
  %353 = icmp slt i64 %343, -1
  %354 = select i1 %353, i64 %116, i64 0
  %355 = getelementptr double, ptr %117, i64 %350
  %356 = getelementptr double, ptr %355, i64 %354
  %357 = load double, ptr %356, align 8, !noalias !27
  %358 = load double, ptr %107, align 8, !noalias !27
  %359 = fcmp ugt double %357, %358
  br i1 %359, label %374, label %342

360:                                              ; preds = %345
  %361 = add nsw i64 %347, -1
  %362 = add i64 %346, 1
  %363 = icmp slt i64 %346, 0
  %364 = select i1 %363, i64 %66, i64 0
  %365 = getelementptr double, ptr %67, i64 %346
  %366 = getelementptr double, ptr %365, i64 %364
  %367 = load double, ptr %366, align 8, !noalias !27
  %368 = mul nsw i64 %343, %330
  %369 = add nsw i64 %368, %346
  %370 = icmp slt i64 %369, 0
  %371 = select i1 %370, i64 %120, i64 0
  %372 = getelementptr double, ptr %121, i64 %369
  %373 = getelementptr double, ptr %372, i64 %371
  store double %367, ptr %373, align 8, !noalias !27
  br label %345

374:                                              ; preds = %325, %334, %349, %352
  %375 = phi i64 [ %350, %352 ], [ %350, %349 ], [ %332, %334 ], [ %332, %325 ]
  store i64 %375, ptr %331, align 8, !noalias !27
  %376 = icmp eq i64 %375, %116
  br i1 %376, label %377, label %378

377:                                              ; preds = %374
  br label %2649

378:                                              ; preds = %374
  %379 = fcmp oeq double %301, 0.000000e+00
  br i1 %379, label %380, label %385

380:                                              ; preds = %378
  %381 = load i64, ptr %118, align 8, !noalias !5
  %382 = icmp slt i64 %66, 1
  br i1 %382, label %2310, label %2311, !prof !0

383:                                              ; preds = %2342
  %384 = getelementptr i8, ptr %112, i64 72
  store i64 4, ptr %384, align 8, !noalias !5
  br label %385

385:                                              ; preds = %2342, %290, %383, %378
  %386 = phi double [ %2357, %2342 ], [ %2357, %383 ], [ %301, %378 ], [ %301, %290 ]
  br label %387

387:                                              ; preds = %2286, %385
  %388 = phi double [ %386, %385 ], [ %2287, %2286 ]
  %389 = phi double [ %299, %385 ], [ %392, %2286 ]
  br label %390

390:                                              ; preds = %2239, %387
  %391 = phi double [ %388, %387 ], [ %2240, %2239 ]
  %392 = phi double [ %389, %387 ], [ %418, %2239 ]
  %393 = load i64, ptr %163, align 8, !noalias !5
  %394 = icmp eq i64 %393, 0
  br i1 %394, label %395, label %396

395:                                              ; preds = %390
  store double %391, ptr %300, align 8, !noalias !5
  br label %2649

396:                                              ; preds = %390
  %397 = add nsw i64 %393, -1
  store i64 %397, ptr %163, align 8, !noalias !5
  %398 = getelementptr i8, ptr %112, i64 8
  %399 = load i64, ptr %398, align 8, !noalias !5
  %400 = getelementptr i8, ptr %112, i64 16
  %401 = load i64, ptr %400, align 8, !noalias !5
  %402 = add nsw i64 %399, %401
  %403 = getelementptr i8, ptr %112, i64 64
  %404 = load i64, ptr %403, align 8, !noalias !5
  %405 = icmp slt i64 %402, %404
  br i1 %405, label %407, label %406

406:                                              ; preds = %396
  store double %391, ptr %300, align 8, !noalias !5
  br label %2649

407:                                              ; preds = %396
  %408 = getelementptr i8, ptr %107, i64 16
  %409 = load double, ptr %408, align 8, !noalias !5
  %410 = fcmp olt double %409, %391
  %411 = select i1 %410, double %409, double %391
  %412 = fadd double %392, %411
  %413 = fmul double %411, 1.000000e-03
  %414 = fsub double %282, %413
  %415 = fcmp ogt double %412, %414
  %416 = fsub double %282, %392
  %417 = select i1 %415, double %416, double %411
  %418 = select i1 %415, double %282, double %412
  %419 = fmul double %417, 6.250000e-02
  %420 = fadd double %392, %419
  %421 = fcmp ogt double %420, %392
  %422 = fcmp oeq double %418, %282
  %423 = select i1 %421, i1 true, i1 %422
  br i1 %423, label %424, label %2288

424:                                              ; preds = %407
  %425 = getelementptr i8, ptr %198, i64 8
  %426 = load i64, ptr %425, align 8, !noalias !5
  %427 = icmp eq i64 %426, 1
  br i1 %427, label %428, label %467

428:                                              ; preds = %424
  %429 = load i64, ptr %118, align 8, !noalias !5
  %430 = getelementptr i8, ptr %112, i64 32
  %431 = load i64, ptr %430, align 8, !noalias !5
  %432 = add nsw i64 %431, 1
  store i64 %432, ptr %430, align 8, !noalias !5
  %433 = load i64, ptr %198, align 8, !noalias !5
  %434 = icmp eq i64 %433, 0
  br i1 %434, label %442, label %435

435:                                              ; preds = %428
  store ptr null, ptr %15, align 8, !noalias !30
  store ptr null, ptr %16, align 8, !noalias !30
  store double %392, ptr %35, align 8, !noalias !30
  %436 = icmp sgt i64 %47, 0
  br i1 %436, label %437, label %440

437:                                              ; preds = %435
  store ptr null, ptr %15, align 8, !noalias !30
  %438 = call fastcc i32 @_sample(ptr nonnull %15, ptr %40, i64 %39, ptr %50, i64 %47, i64 %49, ptr %55, i64 %54, ptr %62, i64 %59, i64 %61, double %392) #3
  switch i32 %438, label %439 [
    i32 -2, label %440
    i32 0, label %440
  ], !prof !25

439:                                              ; preds = %437
  br label %440

440:                                              ; preds = %437, %437, %435, %439
  %441 = phi i32 [ %438, %439 ], [ 0, %435 ], [ 0, %437 ], [ 0, %437 ]
  switch i32 %441, label %2365 [
    i32 -2, label %2360
    i32 0, label %2360
  ], !prof !25

442:                                              ; preds = %428
  %443 = call i64 @llvm.smax.i64(i64 %429, i64 0)
  br label %444

444:                                              ; preds = %442, %2366
  %445 = phi i64 [ 0, %442 ], [ %2368, %2366 ]
  %446 = phi i64 [ %443, %442 ], [ %2367, %2366 ]
  %447 = icmp sgt i64 %446, 0
  br i1 %447, label %2366, label %448

448:                                              ; preds = %444, %458
  %449 = phi i64 [ %2379, %458 ], [ 0, %444 ]
  %450 = phi i64 [ %2378, %458 ], [ %443, %444 ]
  %451 = icmp sgt i64 %450, 0
  br i1 %451, label %2377, label %460

452:                                              ; preds = %2410
  %453 = sext i32 %2408 to i64
  br label %460

454:                                              ; preds = %2410, %2413
  %455 = phi i64 [ %2415, %2413 ], [ 0, %2410 ]
  %456 = phi i64 [ %2414, %2413 ], [ %443, %2410 ]
  %457 = icmp sgt i64 %456, 0
  br i1 %457, label %2413, label %458

458:                                              ; preds = %454
  %459 = load double, ptr %2383, align 8, !noalias !5
  store double %459, ptr %2393, align 8, !noalias !5
  br label %448

460:                                              ; preds = %448, %2360, %452
  %461 = phi i64 [ %2364, %2360 ], [ %453, %452 ], [ 0, %448 ]
  %462 = icmp slt i64 %461, 0
  br i1 %462, label %463, label %464

463:                                              ; preds = %460
  br label %2649

464:                                              ; preds = %460
  store i64 0, ptr %425, align 8, !noalias !5
  %465 = getelementptr i8, ptr %198, i64 16
  store i64 1, ptr %465, align 8, !noalias !5
  %466 = getelementptr i8, ptr %198, i64 24
  store i64 0, ptr %466, align 8, !noalias !5
  br label %467

467:                                              ; preds = %464, %424
  %468 = getelementptr i8, ptr %198, i64 24
  %469 = load i64, ptr %468, align 8, !noalias !5
  %470 = icmp eq i64 %469, 0
  br i1 %470, label %474, label %471

471:                                              ; preds = %467
  %472 = load double, ptr %201, align 8, !noalias !5
  %473 = fcmp une double %417, %472
  br i1 %473, label %474, label %789

474:                                              ; preds = %471, %467
  %475 = getelementptr i8, ptr %112, i64 40
  %476 = load i64, ptr %475, align 8, !noalias !5
  %477 = add nsw i64 %476, 1
  store i64 %477, ptr %475, align 8, !noalias !5
  %478 = call i64 @llvm.smax.i64(i64 %227, i64 0)
  br label %479

479:                                              ; preds = %487, %474
  %480 = phi i64 [ 0, %474 ], [ %2435, %487 ]
  %481 = phi i64 [ %478, %474 ], [ %2434, %487 ]
  %482 = icmp sgt i64 %481, 0
  br i1 %482, label %2433, label %513

483:                                              ; preds = %2433, %2436
  %484 = phi i64 [ 0, %2433 ], [ %2438, %2436 ]
  %485 = phi i64 [ %478, %2433 ], [ %2437, %2436 ]
  %486 = icmp sgt i64 %485, 0
  br i1 %486, label %2436, label %487

487:                                              ; preds = %483
  %488 = icmp slt i64 %480, 0
  %489 = select i1 %488, i64 %213, i64 0
  %490 = add i64 %480, %489
  %491 = select i1 %488, i64 %215, i64 0
  %492 = mul i64 %490, %215
  %493 = getelementptr double, ptr %216, i64 %492
  %494 = getelementptr double, ptr %493, i64 %480
  %495 = getelementptr double, ptr %494, i64 %491
  %496 = load double, ptr %495, align 8, !noalias !5
  %497 = fdiv double 0x400D1A48D83E731D, %417
  %498 = fadd double %496, %497
  store double %498, ptr %495, align 8, !noalias !5
  %499 = select i1 %488, i64 %220, i64 0
  %500 = add i64 %480, %499
  %501 = select i1 %488, i64 %222, i64 0
  %502 = mul i64 %500, %222
  %503 = getelementptr { double, double }, ptr %223, i64 %502
  %504 = getelementptr { double, double }, ptr %503, i64 %480
  %505 = getelementptr { double, double }, ptr %504, i64 %501
  %506 = load double, ptr %505, align 8, !noalias !5
  %507 = getelementptr inbounds nuw i8, ptr %505, i64 8
  %508 = load double, ptr %507, align 8, !noalias !5
  %509 = fdiv double 0x400572DB93E0C672, %417
  %510 = fdiv double 0xC0086747F2C3FCB6, %417
  %511 = fadd double %506, %509
  %512 = fadd double %508, %510
  store double %511, ptr %505, align 8, !noalias !5
  store double %512, ptr %507, align 8, !noalias !5
  br label %479

513:                                              ; preds = %479
  %514 = call i64 @llvm.smax.i64(i64 %213, i64 0)
  br label %515

515:                                              ; preds = %539, %513
  %516 = phi i64 [ 0, %513 ], [ %552, %539 ]
  %517 = phi i64 [ %514, %513 ], [ %551, %539 ]
  %518 = icmp sgt i64 %517, 0
  br i1 %518, label %550, label %621

519:                                              ; preds = %565, %550
  %520 = phi i64 [ %552, %550 ], [ %567, %565 ]
  %521 = phi i64 [ %564, %550 ], [ %566, %565 ]
  %522 = phi double [ %562, %550 ], [ %578, %565 ]
  %523 = phi i64 [ %516, %550 ], [ %579, %565 ]
  %524 = icmp sgt i64 %521, 0
  br i1 %524, label %565, label %525

525:                                              ; preds = %519
  %526 = select i1 %553, i64 %227, i64 0
  %527 = getelementptr i64, ptr %228, i64 %516
  %528 = getelementptr i64, ptr %527, i64 %526
  store i64 %523, ptr %528, align 8, !noalias !34
  %529 = fcmp ueq double %522, 0.000000e+00
  br i1 %529, label %781, label %530

530:                                              ; preds = %525
  %531 = icmp eq i64 %523, %516
  br i1 %531, label %536, label %532

532:                                              ; preds = %530, %580
  %533 = phi i64 [ %582, %580 ], [ 0, %530 ]
  %534 = phi i64 [ %581, %580 ], [ %514, %530 ]
  %535 = icmp sgt i64 %534, 0
  br i1 %535, label %580, label %536

536:                                              ; preds = %532, %530
  %537 = load double, ptr %560, align 8, !noalias !34
  %538 = fdiv double 1.000000e+00, %537
  br label %539

539:                                              ; preds = %549, %536
  %540 = phi i64 [ %552, %536 ], [ %598, %549 ]
  %541 = phi i64 [ %564, %536 ], [ %597, %549 ]
  %542 = icmp sgt i64 %541, 0
  br i1 %542, label %596, label %515

543:                                              ; preds = %596
  %544 = fmul double %606, %538
  store double %544, ptr %605, align 8, !noalias !34
  br label %545

545:                                              ; preds = %608, %543
  %546 = phi i64 [ %552, %543 ], [ %610, %608 ]
  %547 = phi i64 [ %564, %543 ], [ %609, %608 ]
  %548 = icmp sgt i64 %547, 0
  br i1 %548, label %608, label %549

549:                                              ; preds = %596, %545
  br label %539

550:                                              ; preds = %515
  %551 = add nsw i64 %517, -1
  %552 = add i64 %516, 1
  %553 = icmp slt i64 %516, 0
  %554 = select i1 %553, i64 %213, i64 0
  %555 = add i64 %516, %554
  %556 = select i1 %553, i64 %215, i64 0
  %557 = mul i64 %555, %215
  %558 = getelementptr double, ptr %216, i64 %557
  %559 = getelementptr double, ptr %558, i64 %516
  %560 = getelementptr double, ptr %559, i64 %556
  %561 = load double, ptr %560, align 8, !noalias !34
  %562 = call double @llvm.fabs.f64(double %561)
  %563 = sub i64 %213, %552
  %564 = call i64 @llvm.smax.i64(i64 %563, i64 0)
  br label %519

565:                                              ; preds = %519
  %566 = add nsw i64 %521, -1
  %567 = add i64 %520, 1
  %568 = icmp slt i64 %520, 0
  %569 = select i1 %568, i64 %213, i64 0
  %570 = add i64 %520, %569
  %571 = mul i64 %570, %215
  %572 = getelementptr double, ptr %216, i64 %571
  %573 = getelementptr double, ptr %572, i64 %516
  %574 = getelementptr double, ptr %573, i64 %556
  %575 = load double, ptr %574, align 8, !noalias !34
  %576 = call double @llvm.fabs.f64(double %575)
  %577 = fcmp ogt double %576, %522
  %578 = select i1 %577, double %576, double %522
  %579 = select i1 %577, i64 %520, i64 %523
  br label %519

580:                                              ; preds = %532
  %581 = add nsw i64 %534, -1
  %582 = add i64 %533, 1
  %583 = icmp slt i64 %523, 0
  %584 = select i1 %583, i64 %213, i64 0
  %585 = add i64 %523, %584
  %586 = icmp slt i64 %533, 0
  %587 = select i1 %586, i64 %215, i64 0
  %588 = mul i64 %585, %215
  %589 = getelementptr double, ptr %216, i64 %588
  %590 = getelementptr double, ptr %589, i64 %533
  %591 = getelementptr double, ptr %590, i64 %587
  %592 = load double, ptr %591, align 8, !noalias !34
  %593 = getelementptr double, ptr %558, i64 %533
  %594 = getelementptr double, ptr %593, i64 %587
  %595 = load double, ptr %594, align 8, !noalias !34
  store double %592, ptr %594, align 8, !noalias !34
  store double %595, ptr %591, align 8, !noalias !34
  br label %532

596:                                              ; preds = %539
  %597 = add nsw i64 %541, -1
  %598 = add i64 %540, 1
  %599 = icmp slt i64 %540, 0
  %600 = select i1 %599, i64 %213, i64 0
  %601 = add i64 %540, %600
  %602 = mul i64 %601, %215
  %603 = getelementptr double, ptr %216, i64 %602
  %604 = getelementptr double, ptr %603, i64 %516
  %605 = getelementptr double, ptr %604, i64 %556
  %606 = load double, ptr %605, align 8, !noalias !34
  %607 = fcmp une double %606, 0.000000e+00
  br i1 %607, label %543, label %549

608:                                              ; preds = %545
  %609 = add nsw i64 %547, -1
  %610 = add i64 %546, 1
  %611 = icmp slt i64 %546, 0
  %612 = select i1 %611, i64 %215, i64 0
  %613 = getelementptr double, ptr %603, i64 %546
  %614 = getelementptr double, ptr %613, i64 %612
  %615 = load double, ptr %614, align 8, !noalias !34
  %616 = getelementptr double, ptr %558, i64 %546
  %617 = getelementptr double, ptr %616, i64 %612
  %618 = load double, ptr %617, align 8, !noalias !34
  %619 = fmul double %544, %618
  %620 = fsub double %615, %619
  store double %620, ptr %614, align 8, !noalias !34
  br label %545

621:                                              ; preds = %515
  %622 = call i64 @llvm.smax.i64(i64 %220, i64 0)
  br label %623

623:                                              ; preds = %671, %621
  %624 = phi i64 [ 0, %621 ], [ %689, %671 ]
  %625 = phi i64 [ %622, %621 ], [ %688, %671 ]
  %626 = icmp sgt i64 %625, 0
  br i1 %626, label %687, label %780

627:                                              ; preds = %704, %687
  %628 = phi i64 [ %689, %687 ], [ %716, %704 ]
  %629 = phi i64 [ %703, %687 ], [ %717, %704 ]
  %630 = phi double [ %701, %687 ], [ %719, %704 ]
  %631 = phi i64 [ %624, %687 ], [ %720, %704 ]
  %632 = icmp sgt i64 %629, 0
  br i1 %632, label %704, label %633

633:                                              ; preds = %627
  %634 = select i1 %690, i64 %232, i64 0
  %635 = getelementptr i64, ptr %233, i64 %624
  %636 = getelementptr i64, ptr %635, i64 %634
  store i64 %631, ptr %636, align 8, !noalias !37
  %637 = fcmp ueq double %630, 0.000000e+00
  br i1 %637, label %781, label %638

638:                                              ; preds = %633
  %639 = icmp eq i64 %631, %624
  br i1 %639, label %644, label %640

640:                                              ; preds = %638, %721
  %641 = phi i64 [ %723, %721 ], [ 0, %638 ]
  %642 = phi i64 [ %722, %721 ], [ %622, %638 ]
  %643 = icmp sgt i64 %642, 0
  br i1 %643, label %721, label %644

644:                                              ; preds = %640, %638
  %645 = load double, ptr %697, align 8, !noalias !37
  %646 = load double, ptr %699, align 8, !noalias !37
  %647 = call double @llvm.fabs.f64(double %645)
  %648 = call double @llvm.fabs.f64(double %646)
  %649 = fcmp ult double %647, %648
  br i1 %649, label %659, label %650

650:                                              ; preds = %644
  %651 = fdiv double %646, %645
  %652 = fmul double %646, %651
  %653 = fadd double %645, %652
  %654 = fmul double %651, 0.000000e+00
  %655 = fadd double %654, 1.000000e+00
  %656 = fdiv double %655, %653
  %657 = fsub double 0.000000e+00, %651
  %658 = fdiv double %657, %653
  br label %668

659:                                              ; preds = %644
  %660 = fdiv double %645, %646
  %661 = fmul double %645, %660
  %662 = fadd double %661, %646
  %663 = fadd double %660, 0.000000e+00
  %664 = fdiv double %663, %662
  %665 = fmul double %660, 0.000000e+00
  %666 = fadd double %665, -1.000000e+00
  %667 = fdiv double %666, %662
  br label %668

668:                                              ; preds = %659, %650
  %669 = phi double [ %658, %650 ], [ %667, %659 ]
  %670 = phi double [ %656, %650 ], [ %664, %659 ]
  br label %671

671:                                              ; preds = %686, %668
  %672 = phi i64 [ %689, %668 ], [ %743, %686 ]
  %673 = phi i64 [ %703, %668 ], [ %742, %686 ]
  %674 = icmp sgt i64 %673, 0
  br i1 %674, label %741, label %623

675:                                              ; preds = %741
  %676 = fmul double %751, %669
  %677 = fmul double %753, %670
  %678 = fadd double %676, %677
  %679 = fmul double %751, %670
  %680 = fmul double %753, %669
  %681 = fsub double %679, %680
  store double %681, ptr %750, align 8, !noalias !37
  store double %678, ptr %752, align 8, !noalias !37
  br label %682

682:                                              ; preds = %757, %675
  %683 = phi i64 [ %689, %675 ], [ %776, %757 ]
  %684 = phi i64 [ %703, %675 ], [ %777, %757 ]
  %685 = icmp sgt i64 %684, 0
  br i1 %685, label %757, label %686

686:                                              ; preds = %741, %682
  br label %671

687:                                              ; preds = %623
  %688 = add nsw i64 %625, -1
  %689 = add i64 %624, 1
  %690 = icmp slt i64 %624, 0
  %691 = select i1 %690, i64 %220, i64 0
  %692 = add i64 %624, %691
  %693 = select i1 %690, i64 %222, i64 0
  %694 = mul i64 %692, %222
  %695 = getelementptr { double, double }, ptr %223, i64 %694
  %696 = getelementptr { double, double }, ptr %695, i64 %624
  %697 = getelementptr { double, double }, ptr %696, i64 %693
  %698 = load double, ptr %697, align 8, !noalias !37
  %699 = getelementptr inbounds nuw i8, ptr %697, i64 8
  %700 = load double, ptr %699, align 8, !noalias !37
  %701 = call double @hypot(double %698, double %700) #3, !noalias !41
  %702 = sub i64 %220, %689
  %703 = call i64 @llvm.smax.i64(i64 %702, i64 0)
  br label %627

704:                                              ; preds = %627
  %705 = icmp slt i64 %628, 0
  %706 = select i1 %705, i64 %220, i64 0
  %707 = add i64 %628, %706
  %708 = mul i64 %707, %222
  %709 = getelementptr { double, double }, ptr %223, i64 %708
  %710 = getelementptr { double, double }, ptr %709, i64 %624
  %711 = getelementptr { double, double }, ptr %710, i64 %693
  %712 = load double, ptr %711, align 8, !noalias !37
  %713 = getelementptr inbounds nuw i8, ptr %711, i64 8
  %714 = load double, ptr %713, align 8, !noalias !37
  %715 = call double @hypot(double %712, double %714) #3, !noalias !47
  %716 = add i64 %628, 1
  %717 = add nsw i64 %629, -1
  %718 = fcmp ogt double %715, %630
  %719 = select i1 %718, double %715, double %630
  %720 = select i1 %718, i64 %628, i64 %631
  br label %627

721:                                              ; preds = %640
  %722 = add nsw i64 %642, -1
  %723 = add i64 %641, 1
  %724 = icmp slt i64 %631, 0
  %725 = select i1 %724, i64 %220, i64 0
  %726 = add i64 %631, %725
  %727 = icmp slt i64 %641, 0
  %728 = select i1 %727, i64 %222, i64 0
  %729 = mul i64 %726, %222
  %730 = getelementptr { double, double }, ptr %223, i64 %729
  %731 = getelementptr { double, double }, ptr %730, i64 %641
  %732 = getelementptr { double, double }, ptr %731, i64 %728
  %733 = load double, ptr %732, align 8, !noalias !37
  %734 = getelementptr inbounds nuw i8, ptr %732, i64 8
  %735 = load double, ptr %734, align 8, !noalias !37
  %736 = getelementptr { double, double }, ptr %695, i64 %641
  %737 = getelementptr { double, double }, ptr %736, i64 %728
  %738 = load double, ptr %737, align 8, !noalias !37
  %739 = getelementptr inbounds nuw i8, ptr %737, i64 8
  %740 = load double, ptr %739, align 8, !noalias !37
  store double %733, ptr %737, align 8, !noalias !37
  store double %735, ptr %739, align 8, !noalias !37
  store double %738, ptr %732, align 8, !noalias !37
  store double %740, ptr %734, align 8, !noalias !37
  br label %640

741:                                              ; preds = %671
  %742 = add nsw i64 %673, -1
  %743 = add i64 %672, 1
  %744 = icmp slt i64 %672, 0
  %745 = select i1 %744, i64 %220, i64 0
  %746 = add i64 %672, %745
  %747 = mul i64 %746, %222
  %748 = getelementptr { double, double }, ptr %223, i64 %747
  %749 = getelementptr { double, double }, ptr %748, i64 %624
  %750 = getelementptr { double, double }, ptr %749, i64 %693
  %751 = load double, ptr %750, align 8, !noalias !37
  %752 = getelementptr inbounds nuw i8, ptr %750, i64 8
  %753 = load double, ptr %752, align 8, !noalias !37
  %754 = fcmp une double %751, 0.000000e+00
  %755 = fcmp une double %753, 0.000000e+00
  %756 = or i1 %754, %755
  br i1 %756, label %675, label %686

757:                                              ; preds = %682
  %758 = icmp slt i64 %683, 0
  %759 = select i1 %758, i64 %222, i64 0
  %760 = getelementptr { double, double }, ptr %748, i64 %683
  %761 = getelementptr { double, double }, ptr %760, i64 %759
  %762 = load double, ptr %761, align 8, !noalias !37
  %763 = getelementptr inbounds nuw i8, ptr %761, i64 8
  %764 = load double, ptr %763, align 8, !noalias !37
  %765 = getelementptr { double, double }, ptr %695, i64 %683
  %766 = getelementptr { double, double }, ptr %765, i64 %759
  %767 = load double, ptr %766, align 8, !noalias !37
  %768 = getelementptr inbounds nuw i8, ptr %766, i64 8
  %769 = load double, ptr %768, align 8, !noalias !37
  %770 = fmul double %681, %769
  %771 = fmul double %678, %767
  %772 = fadd double %770, %771
  %773 = fmul double %681, %767
  %774 = fmul double %678, %769
  %775 = fsub double %773, %774
  %776 = add i64 %683, 1
  %777 = add nsw i64 %684, -1
  %778 = fsub double %762, %775
  %779 = fsub double %764, %772
  store double %778, ptr %761, align 8, !noalias !37
  store double %779, ptr %763, align 8, !noalias !37
  br label %682

780:                                              ; preds = %623
  store i64 1, ptr %468, align 8, !noalias !5
  store double %417, ptr %201, align 8, !noalias !5
  br label %789

781:                                              ; preds = %525, %633
  %782 = load i64, ptr %400, align 8, !noalias !5
  %783 = add nsw i64 %782, 1
  %784 = fmul double %417, 5.000000e-01
  %785 = getelementptr i8, ptr %112, i64 72
  store i64 4, ptr %785, align 8, !noalias !5
  store i64 %783, ptr %400, align 8, !noalias !5
  %786 = getelementptr i8, ptr %198, i64 16
  %787 = load i64, ptr %786, align 8, !noalias !5
  %788 = sub nsw i64 1, %787
  store i64 %788, ptr %425, align 8, !noalias !5
  store i64 0, ptr %468, align 8, !noalias !5
  br label %2286

789:                                              ; preds = %780, %471
  %790 = getelementptr i8, ptr %201, i64 8
  %791 = load double, ptr %790, align 8, !noalias !5
  br label %792

792:                                              ; preds = %807, %789
  %793 = phi i64 [ 0, %789 ], [ %2468, %807 ]
  %794 = phi i64 [ 3, %789 ], [ %2467, %807 ]
  %795 = icmp sgt i64 %794, 0
  br i1 %795, label %2466, label %861

796:                                              ; preds = %2466
  %797 = icmp slt i64 %793, 0
  %798 = add i64 %793, 3
  %799 = select i1 %797, i64 %798, i64 %793
  %800 = getelementptr double, ptr @0, i64 %799
  %801 = load double, ptr %800, align 8, !noalias !5
  %802 = fmul double %801, %417
  %803 = fdiv double %802, %791
  %804 = fadd double %803, 1.000000e+00
  br label %805

805:                                              ; preds = %2466, %796
  %806 = phi double [ %804, %796 ], [ 0.000000e+00, %2466 ]
  br label %807

807:                                              ; preds = %805, %851, %811
  %808 = phi i64 [ 0, %805 ], [ %2472, %811 ], [ %2472, %851 ]
  %809 = phi i64 [ %284, %805 ], [ %2471, %811 ], [ %2471, %851 ]
  %810 = icmp sgt i64 %809, 0
  br i1 %810, label %2470, label %792

811:                                              ; preds = %2470
  %812 = fsub double 1.000000e+00, %806
  %813 = icmp slt i64 %808, 0
  %814 = select i1 %813, i64 %258, i64 0
  %815 = shl i64 %258, 4
  %816 = getelementptr i8, ptr %259, i64 %815
  %817 = getelementptr double, ptr %816, i64 %808
  %818 = getelementptr double, ptr %817, i64 %814
  %819 = load double, ptr %818, align 8, !noalias !5
  %820 = mul i64 %258, 24
  %821 = getelementptr i8, ptr %259, i64 %820
  %822 = getelementptr double, ptr %821, i64 %808
  %823 = getelementptr double, ptr %822, i64 %814
  %824 = load double, ptr %823, align 8, !noalias !5
  %825 = fmul double %806, %824
  %826 = fadd double %819, %825
  %827 = fmul double %812, %826
  %828 = getelementptr double, ptr %259, i64 %808
  %829 = getelementptr double, ptr %828, i64 %814
  %830 = load double, ptr %829, align 8, !noalias !5
  %831 = getelementptr double, ptr %259, i64 %258
  %832 = getelementptr double, ptr %831, i64 %808
  %833 = getelementptr double, ptr %832, i64 %814
  %834 = load double, ptr %833, align 8, !noalias !5
  %835 = fadd double %834, %827
  %836 = fmul double %806, %835
  %837 = fadd double %830, %836
  %838 = select i1 %813, i64 %66, i64 0
  %839 = getelementptr double, ptr %67, i64 %808
  %840 = getelementptr double, ptr %839, i64 %838
  %841 = load double, ptr %840, align 8, !noalias !5
  %842 = fsub double %837, %841
  %843 = icmp slt i64 %793, 0
  %844 = select i1 %843, i64 %237, i64 0
  %845 = add i64 %793, %844
  %846 = select i1 %813, i64 %239, i64 0
  %847 = mul i64 %845, %239
  %848 = getelementptr double, ptr %240, i64 %847
  %849 = getelementptr double, ptr %848, i64 %808
  %850 = getelementptr double, ptr %849, i64 %846
  store double %842, ptr %850, align 8, !noalias !5
  br label %807

851:                                              ; preds = %2470
  %852 = icmp slt i64 %793, 0
  %853 = select i1 %852, i64 %237, i64 0
  %854 = add i64 %793, %853
  %855 = icmp slt i64 %808, 0
  %856 = select i1 %855, i64 %239, i64 0
  %857 = mul i64 %854, %239
  %858 = getelementptr double, ptr %240, i64 %857
  %859 = getelementptr double, ptr %858, i64 %808
  %860 = getelementptr double, ptr %859, i64 %856
  store double 0.000000e+00, ptr %860, align 8, !noalias !5
  br label %807

861:                                              ; preds = %792, %865
  %862 = phi i64 [ %2475, %865 ], [ 0, %792 ]
  %863 = phi i64 [ %2474, %865 ], [ 3, %792 ]
  %864 = icmp sgt i64 %863, 0
  br i1 %864, label %2473, label %869

865:                                              ; preds = %2473, %2476
  %866 = phi i64 [ 0, %2473 ], [ %2478, %2476 ]
  %867 = phi i64 [ %284, %2473 ], [ %2477, %2476 ]
  %868 = icmp sgt i64 %867, 0
  br i1 %868, label %2476, label %861

869:                                              ; preds = %861
  %870 = fmul double %298, %288
  store ptr null, ptr %14, align 8, !noalias !53
  %871 = load i64, ptr %118, align 8, !noalias !53
  %872 = getelementptr i8, ptr %198, i64 40
  %873 = load i64, ptr %872, align 8, !noalias !53
  %874 = icmp sgt i64 %873, 0
  %875 = select i1 %874, i64 10, i64 6
  br label %876

876:                                              ; preds = %1308, %869
  %877 = phi i64 [ 0, %869 ], [ %1318, %1308 ]
  %878 = phi i64 [ %875, %869 ], [ %1319, %1308 ]
  %879 = phi double [ -1.000000e+00, %869 ], [ %1166, %1308 ]
  %880 = phi double [ 0.000000e+00, %869 ], [ %1207, %1308 ]
  %881 = phi i64 [ 0, %869 ], [ %1227, %1308 ]
  %882 = icmp sgt i64 %878, 0
  br i1 %882, label %1314, label %1317

883:                                              ; preds = %1317
  %884 = icmp sgt i64 %1321, 5
  %885 = icmp eq i64 %881, 0
  %886 = and i1 %884, %885
  br i1 %886, label %1309, label %887

887:                                              ; preds = %1347, %883
  %888 = phi i64 [ %1324, %1347 ], [ 0, %883 ]
  %889 = phi i64 [ %1323, %1347 ], [ 3, %883 ]
  %890 = icmp sgt i64 %889, 0
  br i1 %890, label %1322, label %925

891:                                              ; preds = %1326, %1322
  %892 = phi i64 [ 0, %1322 ], [ %1328, %1326 ]
  %893 = phi i64 [ %1325, %1322 ], [ %1327, %1326 ]
  %894 = icmp sgt i64 %893, 0
  br i1 %894, label %1326, label %895

895:                                              ; preds = %891
  %896 = getelementptr i8, ptr %112, i64 24
  %897 = load i64, ptr %896, align 8, !noalias !53
  %898 = add nsw i64 %897, 1
  store i64 %898, ptr %896, align 8, !noalias !53
  %899 = icmp slt i64 %888, 0
  %900 = add i64 %888, 3
  %901 = select i1 %899, i64 %900, i64 %888
  %902 = getelementptr double, ptr @4, i64 %901
  %903 = load double, ptr %902, align 8, !noalias !53
  %904 = fmul double %417, %903
  %905 = fadd double %392, %904
  %906 = mul nsw i64 %888, %871
  %907 = shl i64 %906, 3
  %908 = add i64 %907, %249
  store ptr null, ptr %12, align 8, !noalias !57
  store ptr null, ptr %13, align 8, !noalias !57
  store double %905, ptr %35, align 8, !noalias !57
  %909 = icmp sgt i64 %47, 0
  br i1 %909, label %910, label %913

910:                                              ; preds = %895
  store ptr null, ptr %12, align 8, !noalias !57
  %911 = call fastcc i32 @_sample(ptr nonnull %12, ptr %40, i64 %39, ptr %50, i64 %47, i64 %49, ptr %55, i64 %54, ptr %62, i64 %59, i64 %61, double %905) #3
  switch i32 %911, label %912 [
    i32 -2, label %913
    i32 0, label %913
  ], !prof !25

912:                                              ; preds = %910
  br label %913

913:                                              ; preds = %910, %910, %895, %912
  %914 = phi i32 [ %911, %912 ], [ 0, %895 ], [ 0, %910 ], [ 0, %910 ]
  switch i32 %914, label %920 [
    i32 -2, label %915
    i32 0, label %915
  ], !prof !25

915:                                              ; preds = %913, %913
  %916 = load i64, ptr %32, align 8, !noalias !64
  %917 = inttoptr i64 %916 to ptr
  %918 = inttoptr i64 %908 to ptr
  %919 = call i32 %917(ptr nonnull %35, ptr %77, ptr %40, ptr %43, ptr %918) #3, !noalias !64
  br label %920

920:                                              ; preds = %913, %915
  %921 = phi i32 [ %919, %915 ], [ 0, %913 ]
  %922 = phi i32 [ 0, %915 ], [ %914, %913 ]
  switch i32 %922, label %1866 [
    i32 -2, label %1347
    i32 0, label %1347
  ], !prof !25

923:                                              ; preds = %1347
  %924 = sext i32 %921 to i64
  br label %1866

925:                                              ; preds = %887
  %926 = call i64 @llvm.smax.i64(i64 %871, i64 0)
  br label %927

927:                                              ; preds = %931, %925
  %928 = phi i64 [ 0, %925 ], [ %932, %931 ]
  %929 = phi i64 [ %926, %925 ], [ %933, %931 ]
  %930 = icmp sgt i64 %929, 0
  br i1 %930, label %1349, label %985

931:                                              ; preds = %1349
  %932 = add i64 %928, 1
  %933 = add nsw i64 %929, -1
  %934 = fmul double %1354, 0x4010B70201A79C46
  %935 = fmul double %1358, 0x3FD4F8C15DA84E86
  %936 = fadd double %934, %935
  %937 = fmul double %1364, 0x3FE0BF7FF59D56EF
  %938 = fadd double %936, %937
  %939 = fdiv double 0x400D1A48D83E731D, %417
  %940 = select i1 %1350, i64 %246, i64 0
  %941 = getelementptr double, ptr %247, i64 %928
  %942 = getelementptr double, ptr %941, i64 %940
  %943 = load double, ptr %942, align 8, !noalias !53
  %944 = fmul double %939, %943
  %945 = fsub double %938, %944
  %946 = select i1 %1350, i64 %263, i64 0
  %947 = getelementptr double, ptr %264, i64 %928
  %948 = getelementptr double, ptr %947, i64 %946
  store double %945, ptr %948, align 8, !noalias !53
  %949 = load double, ptr %1353, align 8, !noalias !53
  %950 = fmul double %949, 0xC010B70201A79C46
  %951 = load double, ptr %1357, align 8, !noalias !53
  %952 = fmul double %951, 0xBFD4F8C15DA84E86
  %953 = fadd double %950, %952
  %954 = load double, ptr %1363, align 8, !noalias !53
  %955 = fmul double %954, 0x3FDE810014C55221
  %956 = fadd double %953, %955
  %957 = fmul double %949, 0x3FE017885A24A7F2
  %958 = fmul double %951, 0xC004934E6FCAA598
  %959 = fadd double %957, %958
  %960 = fmul double %954, 0x3FE312C0CF7BDFD1
  %961 = fadd double %959, %960
  %962 = fdiv double 0x400572DB93E0C672, %417
  %963 = fdiv double 0xC0086747F2C3FCB6, %417
  %964 = getelementptr double, ptr %247, i64 %246
  %965 = getelementptr double, ptr %964, i64 %928
  %966 = getelementptr double, ptr %965, i64 %940
  %967 = load double, ptr %966, align 8, !noalias !53
  %968 = shl i64 %246, 4
  %969 = getelementptr i8, ptr %247, i64 %968
  %970 = getelementptr double, ptr %969, i64 %928
  %971 = getelementptr double, ptr %970, i64 %940
  %972 = load double, ptr %971, align 8, !noalias !53
  %973 = fmul double %962, %972
  %974 = fmul double %963, %967
  %975 = fadd double %973, %974
  %976 = fmul double %962, %967
  %977 = fmul double %963, %972
  %978 = fsub double %976, %977
  %979 = fsub double %956, %978
  %980 = fsub double %961, %975
  %981 = select i1 %1350, i64 %268, i64 0
  %982 = getelementptr { double, double }, ptr %269, i64 %928
  %983 = getelementptr { double, double }, ptr %982, i64 %981
  store double %979, ptr %983, align 8, !noalias !53
  %984 = getelementptr inbounds nuw i8, ptr %983, i64 8
  store double %980, ptr %984, align 8, !noalias !53
  br label %927

985:                                              ; preds = %927
  store ptr null, ptr %14, align 8, !noalias !53
  %986 = call fastcc i32 @solve(ptr nonnull %14, ptr %216, i64 %213, i64 %215, ptr %228, i64 %227, ptr %264, i64 %263) #3, !noalias !53
  switch i32 %986, label %1866 [
    i32 -2, label %1368
    i32 0, label %1368
  ], !prof !25

987:                                              ; preds = %1538
  %988 = call i64 @llvm.smax.i64(i64 %213, i64 0)
  br label %989

989:                                              ; preds = %1002, %987
  %990 = phi i64 [ 0, %987 ], [ %1048, %1002 ]
  %991 = phi i64 [ %988, %987 ], [ %1047, %1002 ]
  %992 = icmp sgt i64 %991, 0
  br i1 %992, label %1046, label %1003

993:                                              ; preds = %1046
  %994 = mul nsw i64 %990, %873
  %995 = add nsw i64 %213, %994
  %996 = mul nsw i64 %1053, %873
  %997 = add nsw i64 %213, %996
  br label %998

998:                                              ; preds = %1055, %993
  %999 = phi i64 [ 0, %993 ], [ %1057, %1055 ]
  %1000 = phi i64 [ %873, %993 ], [ %1056, %1055 ]
  %1001 = icmp sgt i64 %1000, 0
  br i1 %1001, label %1055, label %1002

1002:                                             ; preds = %1046, %998
  br label %989

1003:                                             ; preds = %989, %1007
  %1004 = phi i64 [ %1072, %1007 ], [ 0, %989 ]
  %1005 = phi i64 [ %1071, %1007 ], [ %988, %989 ]
  %1006 = icmp sgt i64 %1005, 0
  br i1 %1006, label %1070, label %1015

1007:                                             ; preds = %1070, %1011
  %1008 = phi i64 [ 0, %1070 ], [ %1076, %1011 ]
  %1009 = phi i64 [ %1073, %1070 ], [ %1075, %1011 ]
  %1010 = icmp sgt i64 %1009, 0
  br i1 %1010, label %1074, label %1003

1011:                                             ; preds = %1091, %1074
  %1012 = phi i64 [ 0, %1074 ], [ %1093, %1091 ]
  %1013 = phi i64 [ %873, %1074 ], [ %1092, %1091 ]
  %1014 = icmp sgt i64 %1013, 0
  br i1 %1014, label %1091, label %1007

1015:                                             ; preds = %1003
  %1016 = icmp ugt i64 %213, -9223372036854775808
  %1017 = select i1 %1016, i64 0, i64 %213
  br label %1018

1018:                                             ; preds = %1042, %1015
  %1019 = phi i64 [ %213, %1015 ], [ %1021, %1042 ]
  %1020 = phi i64 [ %1017, %1015 ], [ %1109, %1042 ]
  %1021 = add i64 %1019, -1
  %1022 = icmp sgt i64 %1020, 0
  br i1 %1022, label %1108, label %1539

1023:                                             ; preds = %1108, %1027
  %1024 = phi i64 [ %1019, %1108 ], [ %1116, %1027 ]
  %1025 = phi i64 [ %1113, %1108 ], [ %1115, %1027 ]
  %1026 = icmp sgt i64 %1025, 0
  br i1 %1026, label %1114, label %1031

1027:                                             ; preds = %1129, %1114
  %1028 = phi i64 [ 0, %1114 ], [ %1131, %1129 ]
  %1029 = phi i64 [ %873, %1114 ], [ %1130, %1129 ]
  %1030 = icmp sgt i64 %1029, 0
  br i1 %1030, label %1129, label %1023

1031:                                             ; preds = %1023
  %1032 = icmp slt i64 %1021, 0
  %1033 = select i1 %1032, i64 %213, i64 0
  %1034 = add i64 %1021, %1033
  %1035 = select i1 %1032, i64 %215, i64 0
  %1036 = mul i64 %1034, %215
  %1037 = getelementptr double, ptr %216, i64 %1036
  %1038 = getelementptr double, ptr %1037, i64 %1021
  %1039 = getelementptr double, ptr %1038, i64 %1035
  %1040 = load double, ptr %1039, align 8, !noalias !65
  %1041 = fdiv double 1.000000e+00, %1040
  br label %1042

1042:                                             ; preds = %1146, %1031
  %1043 = phi i64 [ 0, %1031 ], [ %1148, %1146 ]
  %1044 = phi i64 [ %873, %1031 ], [ %1147, %1146 ]
  %1045 = icmp sgt i64 %1044, 0
  br i1 %1045, label %1146, label %1018

1046:                                             ; preds = %989
  %1047 = add nsw i64 %991, -1
  %1048 = add i64 %990, 1
  %1049 = icmp slt i64 %990, 0
  %1050 = select i1 %1049, i64 %227, i64 0
  %1051 = getelementptr i64, ptr %228, i64 %990
  %1052 = getelementptr i64, ptr %1051, i64 %1050
  %1053 = load i64, ptr %1052, align 8, !noalias !65
  %1054 = icmp eq i64 %1053, %990
  br i1 %1054, label %1002, label %993

1055:                                             ; preds = %998
  %1056 = add nsw i64 %1000, -1
  %1057 = add i64 %999, 1
  %1058 = add nsw i64 %997, %999
  %1059 = icmp slt i64 %1058, 0
  %1060 = select i1 %1059, i64 %263, i64 0
  %1061 = getelementptr double, ptr %264, i64 %1058
  %1062 = getelementptr double, ptr %1061, i64 %1060
  %1063 = load double, ptr %1062, align 8, !noalias !65
  %1064 = add nsw i64 %995, %999
  %1065 = icmp slt i64 %1064, 0
  %1066 = select i1 %1065, i64 %263, i64 0
  %1067 = getelementptr double, ptr %264, i64 %1064
  %1068 = getelementptr double, ptr %1067, i64 %1066
  %1069 = load double, ptr %1068, align 8, !noalias !65
  store double %1063, ptr %1068, align 8, !noalias !65
  store double %1069, ptr %1062, align 8, !noalias !65
  br label %998

1070:                                             ; preds = %1003
  %1071 = add nsw i64 %1005, -1
  %1072 = add i64 %1004, 1
  %1073 = call i64 @llvm.smax.i64(i64 %1004, i64 0)
  br label %1007

1074:                                             ; preds = %1007
  %1075 = add nsw i64 %1009, -1
  %1076 = add i64 %1008, 1
  %1077 = icmp slt i64 %1004, 0
  %1078 = select i1 %1077, i64 %213, i64 0
  %1079 = add i64 %1004, %1078
  %1080 = icmp slt i64 %1008, 0
  %1081 = select i1 %1080, i64 %215, i64 0
  %1082 = mul i64 %1079, %215
  %1083 = getelementptr double, ptr %216, i64 %1082
  %1084 = getelementptr double, ptr %1083, i64 %1008
  %1085 = getelementptr double, ptr %1084, i64 %1081
  %1086 = load double, ptr %1085, align 8, !noalias !65
  %1087 = mul nsw i64 %1004, %873
  %1088 = add nsw i64 %213, %1087
  %1089 = mul nsw i64 %1008, %873
  %1090 = add nsw i64 %213, %1089
  br label %1011

1091:                                             ; preds = %1011
  %1092 = add nsw i64 %1013, -1
  %1093 = add i64 %1012, 1
  %1094 = add nsw i64 %1088, %1012
  %1095 = icmp slt i64 %1094, 0
  %1096 = select i1 %1095, i64 %263, i64 0
  %1097 = getelementptr double, ptr %264, i64 %1094
  %1098 = getelementptr double, ptr %1097, i64 %1096
  %1099 = load double, ptr %1098, align 8, !noalias !65
  %1100 = add nsw i64 %1090, %1012
  %1101 = icmp slt i64 %1100, 0
  %1102 = select i1 %1101, i64 %263, i64 0
  %1103 = getelementptr double, ptr %264, i64 %1100
  %1104 = getelementptr double, ptr %1103, i64 %1102
  %1105 = load double, ptr %1104, align 8, !noalias !65
  %1106 = fmul double %1086, %1105
  %1107 = fsub double %1099, %1106
  store double %1107, ptr %1098, align 8, !noalias !65
  br label %1011

1108:                                             ; preds = %1018
  %1109 = add nsw i64 %1020, -1
  %1110 = mul nsw i64 %1021, %873
  %1111 = add nsw i64 %213, %1110
  %1112 = sub i64 %213, %1019
  %1113 = call i64 @llvm.smax.i64(i64 %1112, i64 0)
  br label %1023

1114:                                             ; preds = %1023
  %1115 = add nsw i64 %1025, -1
  %1116 = add i64 %1024, 1
  %1117 = icmp slt i64 %1021, 0
  %1118 = select i1 %1117, i64 %213, i64 0
  %1119 = add i64 %1021, %1118
  %1120 = icmp slt i64 %1024, 0
  %1121 = select i1 %1120, i64 %215, i64 0
  %1122 = mul i64 %1119, %215
  %1123 = getelementptr double, ptr %216, i64 %1122
  %1124 = getelementptr double, ptr %1123, i64 %1024
  %1125 = getelementptr double, ptr %1124, i64 %1121
  %1126 = load double, ptr %1125, align 8, !noalias !65
  %1127 = mul nsw i64 %1024, %873
  %1128 = add nsw i64 %213, %1127
  br label %1027

1129:                                             ; preds = %1027
  %1130 = add nsw i64 %1029, -1
  %1131 = add i64 %1028, 1
  %1132 = add nsw i64 %1111, %1028
  %1133 = icmp slt i64 %1132, 0
  %1134 = select i1 %1133, i64 %263, i64 0
  %1135 = getelementptr double, ptr %264, i64 %1132
  %1136 = getelementptr double, ptr %1135, i64 %1134
  %1137 = load double, ptr %1136, align 8, !noalias !65
  %1138 = add nsw i64 %1128, %1028
  %1139 = icmp slt i64 %1138, 0
  %1140 = select i1 %1139, i64 %263, i64 0
  %1141 = getelementptr double, ptr %264, i64 %1138
  %1142 = getelementptr double, ptr %1141, i64 %1140
  %1143 = load double, ptr %1142, align 8, !noalias !65
  %1144 = fmul double %1126, %1143
  %1145 = fsub double %1137, %1144
  store double %1145, ptr %1136, align 8, !noalias !65
  br label %1027

1146:                                             ; preds = %1042
  %1147 = add nsw i64 %1044, -1
  %1148 = add i64 %1043, 1
  %1149 = add nsw i64 %1111, %1043
  %1150 = icmp slt i64 %1149, 0
  %1151 = select i1 %1150, i64 %263, i64 0
  %1152 = getelementptr double, ptr %264, i64 %1149
  %1153 = getelementptr double, ptr %1152, i64 %1151
  %1154 = load double, ptr %1153, align 8, !noalias !65
  %1155 = fmul double %1154, %1041
  store double %1155, ptr %1153, align 8, !noalias !65
  br label %1042

1156:                                             ; preds = %1565, %1538
  br label %1157

1157:                                             ; preds = %1763, %1156
  %1158 = phi i64 [ 0, %1156 ], [ %1765, %1763 ]
  %1159 = phi i64 [ %926, %1156 ], [ %1764, %1763 ]
  %1160 = phi double [ 0.000000e+00, %1156 ], [ %1800, %1763 ]
  %1161 = icmp sgt i64 %1159, 0
  br i1 %1161, label %1763, label %1162

1162:                                             ; preds = %1157
  %1163 = mul nsw i64 %871, 3
  %1164 = sitofp i64 %1163 to double
  %1165 = fdiv double %1160, %1164
  %1166 = call double @sqrt(double %1165), !noalias !53
  %1167 = fcmp ogt double %879, 0.000000e+00
  %1168 = and i1 %1167, %885
  br i1 %1168, label %1169, label %1206

1169:                                             ; preds = %1162
  %1170 = fdiv double %1166, %879
  %1171 = sub nsw i64 5, %1321
  %1172 = add nsw i64 %1321, -5
  %1173 = select i1 %884, i64 %1172, i64 %1171
  %1174 = icmp samesign ugt i64 %1173, 65536
  br i1 %1174, label %1175, label %1178

1175:                                             ; preds = %1169
  %1176 = sitofp i64 %1171 to double
  %1177 = call double @llvm.pow.f64(double %1170, double %1176)
  br label %1197

1178:                                             ; preds = %1169
  %1179 = icmp eq i64 %1173, 0
  br i1 %1179, label %1191, label %1180

1180:                                             ; preds = %1180, %1178
  %1181 = phi double [ %1187, %1180 ], [ 1.000000e+00, %1178 ]
  %1182 = phi double [ %1189, %1180 ], [ %1170, %1178 ]
  %1183 = phi i64 [ %1188, %1180 ], [ %1173, %1178 ]
  %1184 = and i64 %1183, 1
  %1185 = icmp eq i64 %1184, 0
  %1186 = fmul double %1181, %1182
  %1187 = select i1 %1185, double %1181, double %1186
  %1188 = lshr i64 %1183, 1
  %1189 = fmul double %1182, %1182
  %1190 = icmp eq i64 %1188, 0
  br i1 %1190, label %1191, label %1180

1191:                                             ; preds = %1180, %1178
  %1192 = phi double [ %1187, %1180 ], [ 1.000000e+00, %1178 ]
  br i1 %884, label %1193, label %1197

1193:                                             ; preds = %1191
  %1194 = fcmp oeq double %1192, 0.000000e+00
  br i1 %1194, label %1197, label %1195, !prof !0

1195:                                             ; preds = %1193
  %1196 = fdiv double 1.000000e+00, %1192
  br label %1197

1197:                                             ; preds = %1193, %1191, %1175, %1195
  %1198 = phi double [ 0.000000e+00, %1193 ], [ %1177, %1175 ], [ %1192, %1191 ], [ %1196, %1195 ]
  %1199 = phi i1 [ false, %1193 ], [ true, %1175 ], [ true, %1191 ], [ true, %1195 ]
  %1200 = phi i32 [ 1, %1193 ], [ 0, %1175 ], [ 0, %1191 ], [ 0, %1195 ]
  br i1 %1199, label %1801, label %1866, !prof !68

1201:                                             ; preds = %1801
  %1202 = fsub double 1.000000e+00, %1170
  %1203 = fdiv double %1198, %1202
  %1204 = fmul double %1203, %1166
  %1205 = fcmp ogt double %1204, %298
  br i1 %1205, label %1866, label %1206

1206:                                             ; preds = %1201, %1162
  %1207 = phi double [ %1170, %1201 ], [ %880, %1162 ]
  br label %1208

1208:                                             ; preds = %1212, %1206
  %1209 = phi i64 [ 0, %1206 ], [ %1805, %1212 ]
  %1210 = phi i64 [ %926, %1206 ], [ %1804, %1212 ]
  %1211 = icmp sgt i64 %1210, 0
  br i1 %1211, label %1803, label %1216

1212:                                             ; preds = %1833, %1803
  %1213 = phi i64 [ 0, %1803 ], [ %1835, %1833 ]
  %1214 = phi i64 [ 3, %1803 ], [ %1834, %1833 ]
  %1215 = icmp sgt i64 %1214, 0
  br i1 %1215, label %1833, label %1208

1216:                                             ; preds = %1208
  br i1 %885, label %1217, label %1226

1217:                                             ; preds = %1216
  %1218 = fcmp oeq double %1166, 0.000000e+00
  br i1 %1218, label %1225, label %1219

1219:                                             ; preds = %1217
  br i1 %1167, label %1220, label %1226

1220:                                             ; preds = %1219
  %1221 = fsub double 1.000000e+00, %1207
  %1222 = fdiv double %1207, %1221
  %1223 = fmul double %1222, %1166
  %1224 = fcmp olt double %1223, %298
  br i1 %1224, label %1225, label %1226

1225:                                             ; preds = %1220, %1217
  br label %1226

1226:                                             ; preds = %1225, %1220, %1219, %1216
  %1227 = phi i64 [ %1320, %1225 ], [ 0, %1220 ], [ 0, %1219 ], [ %881, %1216 ]
  %1228 = icmp sgt i64 %1227, 0
  br i1 %1228, label %1229, label %1308

1229:                                             ; preds = %1226
  %1230 = icmp eq i64 %873, 0
  br i1 %1230, label %1309, label %1231

1231:                                             ; preds = %1229
  %1232 = load i64, ptr %872, align 8, !noalias !69
  %1233 = call i64 @llvm.smax.i64(i64 %1232, i64 0)
  br label %1234

1234:                                             ; preds = %1252, %1231
  %1235 = phi i64 [ 0, %1231 ], [ %1256, %1252 ]
  %1236 = phi i64 [ %1233, %1231 ], [ %1255, %1252 ]
  %1237 = phi double [ 0.000000e+00, %1231 ], [ %1253, %1252 ]
  %1238 = icmp sgt i64 %1236, 0
  br i1 %1238, label %1254, label %1863

1239:                                             ; preds = %1258, %1254
  %1240 = phi i64 [ 0, %1254 ], [ %1260, %1258 ]
  %1241 = phi i64 [ %1257, %1254 ], [ %1259, %1258 ]
  %1242 = phi double [ 0.000000e+00, %1254 ], [ %1282, %1258 ]
  %1243 = phi double [ 0.000000e+00, %1254 ], [ %1307, %1258 ]
  %1244 = icmp sgt i64 %1241, 0
  br i1 %1244, label %1258, label %1245

1245:                                             ; preds = %1239
  %1246 = fmul double %1237, %1243
  %1247 = fcmp ogt double %1242, %1246
  br i1 %1247, label %1248, label %1252

1248:                                             ; preds = %1245
  %1249 = fcmp ogt double %1243, 0.000000e+00
  %1250 = fdiv double %1242, %1243
  %1251 = select i1 %1249, double %1250, double 1.000000e+00
  br label %1252

1252:                                             ; preds = %1248, %1245
  %1253 = phi double [ %1251, %1248 ], [ %1237, %1245 ]
  br label %1234

1254:                                             ; preds = %1234
  %1255 = add nsw i64 %1236, -1
  %1256 = add i64 %1235, 1
  %1257 = call i64 @llvm.smax.i64(i64 %227, i64 0)
  br label %1239

1258:                                             ; preds = %1239
  %1259 = add nsw i64 %1241, -1
  %1260 = add i64 %1240, 1
  %1261 = mul nsw i64 %1240, %1232
  %1262 = add nsw i64 %227, %1261
  %1263 = add nsw i64 %1262, %1235
  %1264 = icmp slt i64 %1263, 0
  %1265 = select i1 %1264, i64 %263, i64 0
  %1266 = getelementptr double, ptr %264, i64 %1263
  %1267 = getelementptr double, ptr %1266, i64 %1265
  %1268 = load double, ptr %1267, align 8, !noalias !69
  %1269 = fmul double %1268, %1268
  %1270 = select i1 %1264, i64 %268, i64 0
  %1271 = getelementptr { double, double }, ptr %269, i64 %1263
  %1272 = getelementptr { double, double }, ptr %1271, i64 %1270
  %1273 = load double, ptr %1272, align 8, !noalias !69
  %1274 = getelementptr inbounds nuw i8, ptr %1272, i64 8
  %1275 = load double, ptr %1274, align 8, !noalias !69
  %1276 = call double @hypot(double %1273, double %1275) #3, !noalias !73
  %1277 = load double, ptr %1272, align 8, !noalias !69
  %1278 = load double, ptr %1274, align 8, !noalias !69
  %1279 = call double @hypot(double %1277, double %1278) #3, !noalias !79
  %1280 = fmul double %1276, %1279
  %1281 = fadd double %1269, %1280
  %1282 = fadd double %1242, %1281
  %1283 = select i1 %1264, i64 %66, i64 0
  %1284 = getelementptr double, ptr %67, i64 %1263
  %1285 = getelementptr double, ptr %1284, i64 %1283
  %1286 = load double, ptr %1285, align 8, !noalias !69
  %1287 = fmul double %1286, %1286
  %1288 = fadd double %1243, %1287
  %1289 = select i1 %1264, i64 %246, i64 0
  %1290 = getelementptr double, ptr %247, i64 %1263
  %1291 = getelementptr double, ptr %1290, i64 %1289
  %1292 = load double, ptr %1291, align 8, !noalias !69
  %1293 = fmul double %1292, %1292
  %1294 = getelementptr double, ptr %247, i64 %246
  %1295 = getelementptr double, ptr %1294, i64 %1263
  %1296 = getelementptr double, ptr %1295, i64 %1289
  %1297 = load double, ptr %1296, align 8, !noalias !69
  %1298 = fmul double %1297, %1297
  %1299 = fadd double %1293, %1298
  %1300 = shl i64 %246, 4
  %1301 = getelementptr i8, ptr %247, i64 %1300
  %1302 = getelementptr double, ptr %1301, i64 %1263
  %1303 = getelementptr double, ptr %1302, i64 %1289
  %1304 = load double, ptr %1303, align 8, !noalias !69
  %1305 = fmul double %1304, %1304
  %1306 = fadd double %1299, %1305
  %1307 = fadd double %1288, %1306
  br label %1239

1308:                                             ; preds = %1863, %1226
  br label %876

1309:                                             ; preds = %1863, %1317, %1229, %883
  %1310 = phi double [ %880, %1317 ], [ %880, %883 ], [ %1207, %1863 ], [ %1207, %1229 ]
  %1311 = phi i64 [ %881, %1317 ], [ 0, %883 ], [ %1227, %1863 ], [ %1227, %1229 ]
  %1312 = icmp slt i64 %1311, 1
  %1313 = select i1 %1312, i64 6, i64 %1311
  br label %1866

1314:                                             ; preds = %876
  %1315 = add nsw i64 %878, -1
  %1316 = add i64 %877, 1
  br label %1317

1317:                                             ; preds = %1314, %876
  %1318 = phi i64 [ %1316, %1314 ], [ %877, %876 ]
  %1319 = phi i64 [ %1315, %1314 ], [ %878, %876 ]
  %1320 = phi i64 [ %1316, %1314 ], [ 1, %876 ]
  %1321 = phi i64 [ %877, %1314 ], [ 0, %876 ]
  br i1 %882, label %883, label %1309

1322:                                             ; preds = %887
  %1323 = add nsw i64 %889, -1
  %1324 = add i64 %888, 1
  %1325 = call i64 @llvm.smax.i64(i64 %871, i64 0)
  br label %891

1326:                                             ; preds = %891
  %1327 = add nsw i64 %893, -1
  %1328 = add i64 %892, 1
  %1329 = icmp slt i64 %892, 0
  %1330 = select i1 %1329, i64 %66, i64 0
  %1331 = getelementptr double, ptr %67, i64 %892
  %1332 = getelementptr double, ptr %1331, i64 %1330
  %1333 = load double, ptr %1332, align 8, !noalias !53
  %1334 = icmp slt i64 %888, 0
  %1335 = select i1 %1334, i64 %237, i64 0
  %1336 = add i64 %888, %1335
  %1337 = select i1 %1329, i64 %239, i64 0
  %1338 = mul i64 %1336, %239
  %1339 = getelementptr double, ptr %240, i64 %1338
  %1340 = getelementptr double, ptr %1339, i64 %892
  %1341 = getelementptr double, ptr %1340, i64 %1337
  %1342 = load double, ptr %1341, align 8, !noalias !53
  %1343 = fadd double %1333, %1342
  %1344 = select i1 %1329, i64 %76, i64 0
  %1345 = getelementptr double, ptr %77, i64 %892
  %1346 = getelementptr double, ptr %1345, i64 %1344
  store double %1343, ptr %1346, align 8, !noalias !53
  br label %891

1347:                                             ; preds = %920, %920
  %1348 = icmp eq i32 %921, 0
  br i1 %1348, label %887, label %923

1349:                                             ; preds = %927
  %1350 = icmp slt i64 %928, 0
  %1351 = select i1 %1350, i64 %251, i64 0
  %1352 = getelementptr double, ptr %252, i64 %928
  %1353 = getelementptr double, ptr %1352, i64 %1351
  %1354 = load double, ptr %1353, align 8, !noalias !53
  %1355 = getelementptr double, ptr %252, i64 %251
  %1356 = getelementptr double, ptr %1355, i64 %928
  %1357 = getelementptr double, ptr %1356, i64 %1351
  %1358 = load double, ptr %1357, align 8, !noalias !53
  %1359 = fadd double %1354, %1358
  %1360 = shl i64 %251, 4
  %1361 = getelementptr i8, ptr %252, i64 %1360
  %1362 = getelementptr double, ptr %1361, i64 %928
  %1363 = getelementptr double, ptr %1362, i64 %1351
  %1364 = load double, ptr %1363, align 8, !noalias !53
  %1365 = fadd double %1359, %1364
  %1366 = fsub double %1365, %1365
  %1367 = fcmp ord double %1366, 0.000000e+00
  br i1 %1367, label %931, label %1866

1368:                                             ; preds = %985, %985
  %1369 = call i64 @llvm.smax.i64(i64 %220, i64 0)
  br label %1370

1370:                                             ; preds = %1388, %1368
  %1371 = phi i64 [ 0, %1368 ], [ %1453, %1388 ]
  %1372 = phi i64 [ %1369, %1368 ], [ %1452, %1388 ]
  %1373 = icmp sgt i64 %1372, 0
  br i1 %1373, label %1451, label %1389

1374:                                             ; preds = %1451
  %1375 = icmp slt i64 %1458, 0
  %1376 = select i1 %1375, i64 %268, i64 0
  %1377 = getelementptr { double, double }, ptr %269, i64 %1458
  %1378 = getelementptr { double, double }, ptr %1377, i64 %1376
  %1379 = load double, ptr %1378, align 8, !noalias !85
  %1380 = getelementptr inbounds nuw i8, ptr %1378, i64 8
  %1381 = load double, ptr %1380, align 8, !noalias !85
  %1382 = select i1 %1454, i64 %268, i64 0
  %1383 = getelementptr { double, double }, ptr %269, i64 %1371
  %1384 = getelementptr { double, double }, ptr %1383, i64 %1382
  %1385 = load double, ptr %1384, align 8, !noalias !85
  %1386 = getelementptr inbounds nuw i8, ptr %1384, i64 8
  %1387 = load double, ptr %1386, align 8, !noalias !85
  store double %1379, ptr %1384, align 8, !noalias !85
  store double %1381, ptr %1386, align 8, !noalias !85
  store double %1385, ptr %1378, align 8, !noalias !85
  store double %1387, ptr %1380, align 8, !noalias !85
  br label %1388

1388:                                             ; preds = %1451, %1374
  br label %1370

1389:                                             ; preds = %1370, %1399
  %1390 = phi i64 [ %1462, %1399 ], [ 0, %1370 ]
  %1391 = phi i64 [ %1461, %1399 ], [ %1369, %1370 ]
  %1392 = icmp sgt i64 %1391, 0
  br i1 %1392, label %1460, label %1400

1393:                                             ; preds = %1471, %1460
  %1394 = phi i64 [ 0, %1460 ], [ %1495, %1471 ]
  %1395 = phi i64 [ %1470, %1460 ], [ %1496, %1471 ]
  %1396 = phi double [ %1469, %1460 ], [ %1498, %1471 ]
  %1397 = phi double [ %1467, %1460 ], [ %1497, %1471 ]
  %1398 = icmp sgt i64 %1395, 0
  br i1 %1398, label %1471, label %1399

1399:                                             ; preds = %1393
  store double %1397, ptr %1466, align 8, !noalias !85
  store double %1396, ptr %1468, align 8, !noalias !85
  br label %1389

1400:                                             ; preds = %1389
  %1401 = icmp ugt i64 %220, -9223372036854775808
  %1402 = select i1 %1401, i64 0, i64 %220
  br label %1403

1403:                                             ; preds = %1448, %1400
  %1404 = phi i64 [ %220, %1400 ], [ %1406, %1448 ]
  %1405 = phi i64 [ %1402, %1400 ], [ %1500, %1448 ]
  %1406 = add i64 %1404, -1
  %1407 = icmp sgt i64 %1405, 0
  br i1 %1407, label %1499, label %1538

1408:                                             ; preds = %1510, %1499
  %1409 = phi i64 [ %1404, %1499 ], [ %1534, %1510 ]
  %1410 = phi i64 [ %1509, %1499 ], [ %1535, %1510 ]
  %1411 = phi double [ %1507, %1499 ], [ %1537, %1510 ]
  %1412 = phi double [ %1505, %1499 ], [ %1536, %1510 ]
  %1413 = icmp sgt i64 %1410, 0
  br i1 %1413, label %1510, label %1414

1414:                                             ; preds = %1408
  %1415 = select i1 %1501, i64 %220, i64 0
  %1416 = add i64 %1406, %1415
  %1417 = select i1 %1501, i64 %222, i64 0
  %1418 = mul i64 %1416, %222
  %1419 = getelementptr { double, double }, ptr %223, i64 %1418
  %1420 = getelementptr { double, double }, ptr %1419, i64 %1406
  %1421 = getelementptr { double, double }, ptr %1420, i64 %1417
  %1422 = load double, ptr %1421, align 8, !noalias !85
  %1423 = getelementptr inbounds nuw i8, ptr %1421, i64 8
  %1424 = load double, ptr %1423, align 8, !noalias !85
  %1425 = call double @llvm.fabs.f64(double %1422)
  %1426 = call double @llvm.fabs.f64(double %1424)
  %1427 = fcmp ult double %1425, %1426
  br i1 %1427, label %1438, label %1428

1428:                                             ; preds = %1414
  %1429 = fdiv double %1424, %1422
  %1430 = fmul double %1424, %1429
  %1431 = fadd double %1422, %1430
  %1432 = fmul double %1411, %1429
  %1433 = fadd double %1412, %1432
  %1434 = fdiv double %1433, %1431
  %1435 = fmul double %1412, %1429
  %1436 = fsub double %1411, %1435
  %1437 = fdiv double %1436, %1431
  br label %1448

1438:                                             ; preds = %1414
  %1439 = fdiv double %1422, %1424
  %1440 = fmul double %1422, %1439
  %1441 = fadd double %1440, %1424
  %1442 = fmul double %1412, %1439
  %1443 = fadd double %1442, %1411
  %1444 = fdiv double %1443, %1441
  %1445 = fmul double %1411, %1439
  %1446 = fsub double %1445, %1412
  %1447 = fdiv double %1446, %1441
  br label %1448

1448:                                             ; preds = %1438, %1428
  %1449 = phi double [ %1437, %1428 ], [ %1447, %1438 ]
  %1450 = phi double [ %1434, %1428 ], [ %1444, %1438 ]
  store double %1450, ptr %1504, align 8, !noalias !85
  store double %1449, ptr %1506, align 8, !noalias !85
  br label %1403

1451:                                             ; preds = %1370
  %1452 = add nsw i64 %1372, -1
  %1453 = add i64 %1371, 1
  %1454 = icmp slt i64 %1371, 0
  %1455 = select i1 %1454, i64 %232, i64 0
  %1456 = getelementptr i64, ptr %233, i64 %1371
  %1457 = getelementptr i64, ptr %1456, i64 %1455
  %1458 = load i64, ptr %1457, align 8, !noalias !85
  %1459 = icmp eq i64 %1458, %1371
  br i1 %1459, label %1388, label %1374

1460:                                             ; preds = %1389
  %1461 = add nsw i64 %1391, -1
  %1462 = add i64 %1390, 1
  %1463 = icmp slt i64 %1390, 0
  %1464 = select i1 %1463, i64 %268, i64 0
  %1465 = getelementptr { double, double }, ptr %269, i64 %1390
  %1466 = getelementptr { double, double }, ptr %1465, i64 %1464
  %1467 = load double, ptr %1466, align 8, !noalias !85
  %1468 = getelementptr inbounds nuw i8, ptr %1466, i64 8
  %1469 = load double, ptr %1468, align 8, !noalias !85
  %1470 = call i64 @llvm.smax.i64(i64 %1390, i64 0)
  br label %1393

1471:                                             ; preds = %1393
  %1472 = select i1 %1463, i64 %220, i64 0
  %1473 = add i64 %1390, %1472
  %1474 = icmp slt i64 %1394, 0
  %1475 = select i1 %1474, i64 %222, i64 0
  %1476 = mul i64 %1473, %222
  %1477 = getelementptr { double, double }, ptr %223, i64 %1476
  %1478 = getelementptr { double, double }, ptr %1477, i64 %1394
  %1479 = getelementptr { double, double }, ptr %1478, i64 %1475
  %1480 = load double, ptr %1479, align 8, !noalias !85
  %1481 = getelementptr inbounds nuw i8, ptr %1479, i64 8
  %1482 = load double, ptr %1481, align 8, !noalias !85
  %1483 = select i1 %1474, i64 %268, i64 0
  %1484 = getelementptr { double, double }, ptr %269, i64 %1394
  %1485 = getelementptr { double, double }, ptr %1484, i64 %1483
  %1486 = load double, ptr %1485, align 8, !noalias !85
  %1487 = getelementptr inbounds nuw i8, ptr %1485, i64 8
  %1488 = load double, ptr %1487, align 8, !noalias !85
  %1489 = fmul double %1480, %1488
  %1490 = fmul double %1482, %1486
  %1491 = fadd double %1489, %1490
  %1492 = fmul double %1480, %1486
  %1493 = fmul double %1482, %1488
  %1494 = fsub double %1492, %1493
  %1495 = add i64 %1394, 1
  %1496 = add nsw i64 %1395, -1
  %1497 = fsub double %1397, %1494
  %1498 = fsub double %1396, %1491
  br label %1393

1499:                                             ; preds = %1403
  %1500 = add nsw i64 %1405, -1
  %1501 = icmp slt i64 %1406, 0
  %1502 = select i1 %1501, i64 %268, i64 0
  %1503 = getelementptr { double, double }, ptr %269, i64 %1406
  %1504 = getelementptr { double, double }, ptr %1503, i64 %1502
  %1505 = load double, ptr %1504, align 8, !noalias !85
  %1506 = getelementptr inbounds nuw i8, ptr %1504, i64 8
  %1507 = load double, ptr %1506, align 8, !noalias !85
  %1508 = sub i64 %220, %1404
  %1509 = call i64 @llvm.smax.i64(i64 %1508, i64 0)
  br label %1408

1510:                                             ; preds = %1408
  %1511 = select i1 %1501, i64 %220, i64 0
  %1512 = add i64 %1406, %1511
  %1513 = icmp slt i64 %1409, 0
  %1514 = select i1 %1513, i64 %222, i64 0
  %1515 = mul i64 %1512, %222
  %1516 = getelementptr { double, double }, ptr %223, i64 %1515
  %1517 = getelementptr { double, double }, ptr %1516, i64 %1409
  %1518 = getelementptr { double, double }, ptr %1517, i64 %1514
  %1519 = load double, ptr %1518, align 8, !noalias !85
  %1520 = getelementptr inbounds nuw i8, ptr %1518, i64 8
  %1521 = load double, ptr %1520, align 8, !noalias !85
  %1522 = select i1 %1513, i64 %268, i64 0
  %1523 = getelementptr { double, double }, ptr %269, i64 %1409
  %1524 = getelementptr { double, double }, ptr %1523, i64 %1522
  %1525 = load double, ptr %1524, align 8, !noalias !85
  %1526 = getelementptr inbounds nuw i8, ptr %1524, i64 8
  %1527 = load double, ptr %1526, align 8, !noalias !85
  %1528 = fmul double %1519, %1527
  %1529 = fmul double %1521, %1525
  %1530 = fadd double %1528, %1529
  %1531 = fmul double %1519, %1525
  %1532 = fmul double %1521, %1527
  %1533 = fsub double %1531, %1532
  %1534 = add i64 %1409, 1
  %1535 = add nsw i64 %1410, -1
  %1536 = fsub double %1412, %1533
  %1537 = fsub double %1411, %1530
  br label %1408

1538:                                             ; preds = %1403
  br i1 %874, label %987, label %1156

1539:                                             ; preds = %1018, %1552
  %1540 = phi i64 [ %1620, %1552 ], [ 0, %1018 ]
  %1541 = phi i64 [ %1619, %1552 ], [ %1369, %1018 ]
  %1542 = icmp sgt i64 %1541, 0
  br i1 %1542, label %1618, label %1553

1543:                                             ; preds = %1618
  %1544 = mul nsw i64 %1540, %873
  %1545 = add nsw i64 %220, %1544
  %1546 = mul nsw i64 %1625, %873
  %1547 = add nsw i64 %220, %1546
  br label %1548

1548:                                             ; preds = %1627, %1543
  %1549 = phi i64 [ 0, %1543 ], [ %1629, %1627 ]
  %1550 = phi i64 [ %873, %1543 ], [ %1628, %1627 ]
  %1551 = icmp sgt i64 %1550, 0
  br i1 %1551, label %1627, label %1552

1552:                                             ; preds = %1618, %1548
  br label %1539

1553:                                             ; preds = %1539, %1557
  %1554 = phi i64 [ %1648, %1557 ], [ 0, %1539 ]
  %1555 = phi i64 [ %1647, %1557 ], [ %1369, %1539 ]
  %1556 = icmp sgt i64 %1555, 0
  br i1 %1556, label %1646, label %1565

1557:                                             ; preds = %1646, %1561
  %1558 = phi i64 [ 0, %1646 ], [ %1652, %1561 ]
  %1559 = phi i64 [ %1649, %1646 ], [ %1651, %1561 ]
  %1560 = icmp sgt i64 %1559, 0
  br i1 %1560, label %1650, label %1553

1561:                                             ; preds = %1669, %1650
  %1562 = phi i64 [ 0, %1650 ], [ %1692, %1669 ]
  %1563 = phi i64 [ %873, %1650 ], [ %1693, %1669 ]
  %1564 = icmp sgt i64 %1563, 0
  br i1 %1564, label %1669, label %1557

1565:                                             ; preds = %1553, %1614
  %1566 = phi i64 [ %1568, %1614 ], [ %220, %1553 ]
  %1567 = phi i64 [ %1697, %1614 ], [ %1402, %1553 ]
  %1568 = add i64 %1566, -1
  %1569 = icmp sgt i64 %1567, 0
  br i1 %1569, label %1696, label %1156

1570:                                             ; preds = %1696, %1574
  %1571 = phi i64 [ %1566, %1696 ], [ %1704, %1574 ]
  %1572 = phi i64 [ %1701, %1696 ], [ %1703, %1574 ]
  %1573 = icmp sgt i64 %1572, 0
  br i1 %1573, label %1702, label %1578

1574:                                             ; preds = %1719, %1702
  %1575 = phi i64 [ 0, %1702 ], [ %1742, %1719 ]
  %1576 = phi i64 [ %873, %1702 ], [ %1743, %1719 ]
  %1577 = icmp sgt i64 %1576, 0
  br i1 %1577, label %1719, label %1570

1578:                                             ; preds = %1570
  %1579 = icmp slt i64 %1568, 0
  %1580 = select i1 %1579, i64 %220, i64 0
  %1581 = add i64 %1568, %1580
  %1582 = select i1 %1579, i64 %222, i64 0
  %1583 = mul i64 %1581, %222
  %1584 = getelementptr { double, double }, ptr %223, i64 %1583
  %1585 = getelementptr { double, double }, ptr %1584, i64 %1568
  %1586 = getelementptr { double, double }, ptr %1585, i64 %1582
  %1587 = load double, ptr %1586, align 8, !noalias !89
  %1588 = getelementptr inbounds nuw i8, ptr %1586, i64 8
  %1589 = load double, ptr %1588, align 8, !noalias !89
  %1590 = call double @llvm.fabs.f64(double %1587)
  %1591 = call double @llvm.fabs.f64(double %1589)
  %1592 = fcmp ult double %1590, %1591
  br i1 %1592, label %1602, label %1593

1593:                                             ; preds = %1578
  %1594 = fdiv double %1589, %1587
  %1595 = fmul double %1589, %1594
  %1596 = fadd double %1587, %1595
  %1597 = fmul double %1594, 0.000000e+00
  %1598 = fadd double %1597, 1.000000e+00
  %1599 = fdiv double %1598, %1596
  %1600 = fsub double 0.000000e+00, %1594
  %1601 = fdiv double %1600, %1596
  br label %1611

1602:                                             ; preds = %1578
  %1603 = fdiv double %1587, %1589
  %1604 = fmul double %1587, %1603
  %1605 = fadd double %1604, %1589
  %1606 = fadd double %1603, 0.000000e+00
  %1607 = fdiv double %1606, %1605
  %1608 = fmul double %1603, 0.000000e+00
  %1609 = fadd double %1608, -1.000000e+00
  %1610 = fdiv double %1609, %1605
  br label %1611

1611:                                             ; preds = %1602, %1593
  %1612 = phi double [ %1601, %1593 ], [ %1610, %1602 ]
  %1613 = phi double [ %1599, %1593 ], [ %1607, %1602 ]
  br label %1614

1614:                                             ; preds = %1746, %1611
  %1615 = phi i64 [ 0, %1611 ], [ %1761, %1746 ]
  %1616 = phi i64 [ %873, %1611 ], [ %1762, %1746 ]
  %1617 = icmp sgt i64 %1616, 0
  br i1 %1617, label %1746, label %1565

1618:                                             ; preds = %1539
  %1619 = add nsw i64 %1541, -1
  %1620 = add i64 %1540, 1
  %1621 = icmp slt i64 %1540, 0
  %1622 = select i1 %1621, i64 %232, i64 0
  %1623 = getelementptr i64, ptr %233, i64 %1540
  %1624 = getelementptr i64, ptr %1623, i64 %1622
  %1625 = load i64, ptr %1624, align 8, !noalias !89
  %1626 = icmp eq i64 %1625, %1540
  br i1 %1626, label %1552, label %1543

1627:                                             ; preds = %1548
  %1628 = add nsw i64 %1550, -1
  %1629 = add i64 %1549, 1
  %1630 = add nsw i64 %1547, %1549
  %1631 = icmp slt i64 %1630, 0
  %1632 = select i1 %1631, i64 %268, i64 0
  %1633 = getelementptr { double, double }, ptr %269, i64 %1630
  %1634 = getelementptr { double, double }, ptr %1633, i64 %1632
  %1635 = load double, ptr %1634, align 8, !noalias !89
  %1636 = getelementptr inbounds nuw i8, ptr %1634, i64 8
  %1637 = load double, ptr %1636, align 8, !noalias !89
  %1638 = add nsw i64 %1545, %1549
  %1639 = icmp slt i64 %1638, 0
  %1640 = select i1 %1639, i64 %268, i64 0
  %1641 = getelementptr { double, double }, ptr %269, i64 %1638
  %1642 = getelementptr { double, double }, ptr %1641, i64 %1640
  %1643 = load double, ptr %1642, align 8, !noalias !89
  %1644 = getelementptr inbounds nuw i8, ptr %1642, i64 8
  %1645 = load double, ptr %1644, align 8, !noalias !89
  store double %1635, ptr %1642, align 8, !noalias !89
  store double %1637, ptr %1644, align 8, !noalias !89
  store double %1643, ptr %1634, align 8, !noalias !89
  store double %1645, ptr %1636, align 8, !noalias !89
  br label %1548

1646:                                             ; preds = %1553
  %1647 = add nsw i64 %1555, -1
  %1648 = add i64 %1554, 1
  %1649 = call i64 @llvm.smax.i64(i64 %1554, i64 0)
  br label %1557

1650:                                             ; preds = %1557
  %1651 = add nsw i64 %1559, -1
  %1652 = add i64 %1558, 1
  %1653 = icmp slt i64 %1554, 0
  %1654 = select i1 %1653, i64 %220, i64 0
  %1655 = add i64 %1554, %1654
  %1656 = icmp slt i64 %1558, 0
  %1657 = select i1 %1656, i64 %222, i64 0
  %1658 = mul i64 %1655, %222
  %1659 = getelementptr { double, double }, ptr %223, i64 %1658
  %1660 = getelementptr { double, double }, ptr %1659, i64 %1558
  %1661 = getelementptr { double, double }, ptr %1660, i64 %1657
  %1662 = load double, ptr %1661, align 8, !noalias !89
  %1663 = getelementptr inbounds nuw i8, ptr %1661, i64 8
  %1664 = load double, ptr %1663, align 8, !noalias !89
  %1665 = mul nsw i64 %1554, %873
  %1666 = add nsw i64 %220, %1665
  %1667 = mul nsw i64 %1558, %873
  %1668 = add nsw i64 %220, %1667
  br label %1561

1669:                                             ; preds = %1561
  %1670 = add nsw i64 %1666, %1562
  %1671 = icmp slt i64 %1670, 0
  %1672 = select i1 %1671, i64 %268, i64 0
  %1673 = getelementptr { double, double }, ptr %269, i64 %1670
  %1674 = getelementptr { double, double }, ptr %1673, i64 %1672
  %1675 = load double, ptr %1674, align 8, !noalias !89
  %1676 = getelementptr inbounds nuw i8, ptr %1674, i64 8
  %1677 = load double, ptr %1676, align 8, !noalias !89
  %1678 = add nsw i64 %1668, %1562
  %1679 = icmp slt i64 %1678, 0
  %1680 = select i1 %1679, i64 %268, i64 0
  %1681 = getelementptr { double, double }, ptr %269, i64 %1678
  %1682 = getelementptr { double, double }, ptr %1681, i64 %1680
  %1683 = load double, ptr %1682, align 8, !noalias !89
  %1684 = getelementptr inbounds nuw i8, ptr %1682, i64 8
  %1685 = load double, ptr %1684, align 8, !noalias !89
  %1686 = fmul double %1662, %1685
  %1687 = fmul double %1664, %1683
  %1688 = fadd double %1686, %1687
  %1689 = fmul double %1662, %1683
  %1690 = fmul double %1664, %1685
  %1691 = fsub double %1689, %1690
  %1692 = add i64 %1562, 1
  %1693 = add nsw i64 %1563, -1
  %1694 = fsub double %1675, %1691
  %1695 = fsub double %1677, %1688
  store double %1694, ptr %1674, align 8, !noalias !89
  store double %1695, ptr %1676, align 8, !noalias !89
  br label %1561

1696:                                             ; preds = %1565
  %1697 = add nsw i64 %1567, -1
  %1698 = mul nsw i64 %1568, %873
  %1699 = add nsw i64 %220, %1698
  %1700 = sub i64 %220, %1566
  %1701 = call i64 @llvm.smax.i64(i64 %1700, i64 0)
  br label %1570

1702:                                             ; preds = %1570
  %1703 = add nsw i64 %1572, -1
  %1704 = add i64 %1571, 1
  %1705 = icmp slt i64 %1568, 0
  %1706 = select i1 %1705, i64 %220, i64 0
  %1707 = add i64 %1568, %1706
  %1708 = icmp slt i64 %1571, 0
  %1709 = select i1 %1708, i64 %222, i64 0
  %1710 = mul i64 %1707, %222
  %1711 = getelementptr { double, double }, ptr %223, i64 %1710
  %1712 = getelementptr { double, double }, ptr %1711, i64 %1571
  %1713 = getelementptr { double, double }, ptr %1712, i64 %1709
  %1714 = load double, ptr %1713, align 8, !noalias !89
  %1715 = getelementptr inbounds nuw i8, ptr %1713, i64 8
  %1716 = load double, ptr %1715, align 8, !noalias !89
  %1717 = mul nsw i64 %1571, %873
  %1718 = add nsw i64 %220, %1717
  br label %1574

1719:                                             ; preds = %1574
  %1720 = add nsw i64 %1699, %1575
  %1721 = icmp slt i64 %1720, 0
  %1722 = select i1 %1721, i64 %268, i64 0
  %1723 = getelementptr { double, double }, ptr %269, i64 %1720
  %1724 = getelementptr { double, double }, ptr %1723, i64 %1722
  %1725 = load double, ptr %1724, align 8, !noalias !89
  %1726 = getelementptr inbounds nuw i8, ptr %1724, i64 8
  %1727 = load double, ptr %1726, align 8, !noalias !89
  %1728 = add nsw i64 %1718, %1575
  %1729 = icmp slt i64 %1728, 0
  %1730 = select i1 %1729, i64 %268, i64 0
  %1731 = getelementptr { double, double }, ptr %269, i64 %1728
  %1732 = getelementptr { double, double }, ptr %1731, i64 %1730
  %1733 = load double, ptr %1732, align 8, !noalias !89
  %1734 = getelementptr inbounds nuw i8, ptr %1732, i64 8
  %1735 = load double, ptr %1734, align 8, !noalias !89
  %1736 = fmul double %1714, %1735
  %1737 = fmul double %1716, %1733
  %1738 = fadd double %1736, %1737
  %1739 = fmul double %1714, %1733
  %1740 = fmul double %1716, %1735
  %1741 = fsub double %1739, %1740
  %1742 = add i64 %1575, 1
  %1743 = add nsw i64 %1576, -1
  %1744 = fsub double %1725, %1741
  %1745 = fsub double %1727, %1738
  store double %1744, ptr %1724, align 8, !noalias !89
  store double %1745, ptr %1726, align 8, !noalias !89
  br label %1574

1746:                                             ; preds = %1614
  %1747 = add nsw i64 %1699, %1615
  %1748 = icmp slt i64 %1747, 0
  %1749 = select i1 %1748, i64 %268, i64 0
  %1750 = getelementptr { double, double }, ptr %269, i64 %1747
  %1751 = getelementptr { double, double }, ptr %1750, i64 %1749
  %1752 = load double, ptr %1751, align 8, !noalias !89
  %1753 = getelementptr inbounds nuw i8, ptr %1751, i64 8
  %1754 = load double, ptr %1753, align 8, !noalias !89
  %1755 = fmul double %1752, %1612
  %1756 = fmul double %1754, %1613
  %1757 = fadd double %1755, %1756
  %1758 = fmul double %1752, %1613
  %1759 = fmul double %1754, %1612
  %1760 = fsub double %1758, %1759
  %1761 = add i64 %1615, 1
  %1762 = add nsw i64 %1616, -1
  store double %1760, ptr %1751, align 8, !noalias !89
  store double %1757, ptr %1753, align 8, !noalias !89
  br label %1614

1763:                                             ; preds = %1157
  %1764 = add nsw i64 %1159, -1
  %1765 = add i64 %1158, 1
  %1766 = icmp slt i64 %1158, 0
  %1767 = select i1 %1766, i64 %101, i64 0
  %1768 = getelementptr double, ptr %102, i64 %1158
  %1769 = getelementptr double, ptr %1768, i64 %1767
  %1770 = load double, ptr %1769, align 8, !noalias !53
  %1771 = select i1 %1766, i64 %96, i64 0
  %1772 = getelementptr double, ptr %97, i64 %1158
  %1773 = getelementptr double, ptr %1772, i64 %1771
  %1774 = load double, ptr %1773, align 8, !noalias !53
  %1775 = select i1 %1766, i64 %66, i64 0
  %1776 = getelementptr double, ptr %67, i64 %1158
  %1777 = getelementptr double, ptr %1776, i64 %1775
  %1778 = load double, ptr %1777, align 8, !noalias !53
  %1779 = call double @llvm.fabs.f64(double %1778)
  %1780 = fmul double %1774, %1779
  %1781 = fadd double %1770, %1780
  %1782 = select i1 %1766, i64 %263, i64 0
  %1783 = getelementptr double, ptr %264, i64 %1158
  %1784 = getelementptr double, ptr %1783, i64 %1782
  %1785 = load double, ptr %1784, align 8, !noalias !53
  %1786 = fdiv double %1785, %1781
  %1787 = select i1 %1766, i64 %268, i64 0
  %1788 = getelementptr { double, double }, ptr %269, i64 %1158
  %1789 = getelementptr { double, double }, ptr %1788, i64 %1787
  %1790 = load double, ptr %1789, align 8, !noalias !53
  %1791 = fdiv double %1790, %1781
  %1792 = getelementptr inbounds nuw i8, ptr %1789, i64 8
  %1793 = load double, ptr %1792, align 8, !noalias !53
  %1794 = fdiv double %1793, %1781
  %1795 = fmul double %1786, %1786
  %1796 = fmul double %1791, %1791
  %1797 = fadd double %1795, %1796
  %1798 = fmul double %1794, %1794
  %1799 = fadd double %1797, %1798
  %1800 = fadd double %1160, %1799
  br label %1157

1801:                                             ; preds = %1197
  %1802 = fcmp ult double %1170, 1.000000e+00
  br i1 %1802, label %1201, label %1866

1803:                                             ; preds = %1208
  %1804 = add nsw i64 %1210, -1
  %1805 = add i64 %1209, 1
  %1806 = icmp slt i64 %1209, 0
  %1807 = select i1 %1806, i64 %246, i64 0
  %1808 = getelementptr double, ptr %247, i64 %1209
  %1809 = getelementptr double, ptr %1808, i64 %1807
  %1810 = load double, ptr %1809, align 8, !noalias !53
  %1811 = select i1 %1806, i64 %263, i64 0
  %1812 = getelementptr double, ptr %264, i64 %1209
  %1813 = getelementptr double, ptr %1812, i64 %1811
  %1814 = load double, ptr %1813, align 8, !noalias !53
  %1815 = fadd double %1810, %1814
  store double %1815, ptr %1809, align 8, !noalias !53
  %1816 = getelementptr double, ptr %247, i64 %246
  %1817 = getelementptr double, ptr %1816, i64 %1209
  %1818 = getelementptr double, ptr %1817, i64 %1807
  %1819 = load double, ptr %1818, align 8, !noalias !53
  %1820 = select i1 %1806, i64 %268, i64 0
  %1821 = getelementptr { double, double }, ptr %269, i64 %1209
  %1822 = getelementptr { double, double }, ptr %1821, i64 %1820
  %1823 = load double, ptr %1822, align 8, !noalias !53
  %1824 = fadd double %1819, %1823
  store double %1824, ptr %1818, align 8, !noalias !53
  %1825 = shl i64 %246, 4
  %1826 = getelementptr i8, ptr %247, i64 %1825
  %1827 = getelementptr double, ptr %1826, i64 %1209
  %1828 = getelementptr double, ptr %1827, i64 %1807
  %1829 = load double, ptr %1828, align 8, !noalias !53
  %1830 = getelementptr inbounds nuw i8, ptr %1822, i64 8
  %1831 = load double, ptr %1830, align 8, !noalias !53
  %1832 = fadd double %1829, %1831
  store double %1832, ptr %1828, align 8, !noalias !53
  br label %1212

1833:                                             ; preds = %1212
  %1834 = add nsw i64 %1214, -1
  %1835 = add i64 %1213, 1
  %1836 = icmp slt i64 %1213, 0
  %1837 = add i64 %1213, 3
  %1838 = select i1 %1836, i64 %1837, i64 %1213
  %1839 = mul i64 %1838, 24
  %1840 = getelementptr i8, ptr @5, i64 %1839
  %1841 = load double, ptr %1840, align 8, !noalias !53
  %1842 = load double, ptr %1809, align 8, !noalias !53
  %1843 = fmul double %1841, %1842
  %1844 = getelementptr i8, ptr @6, i64 %1839
  %1845 = getelementptr i8, ptr %1844, i64 8
  %1846 = load double, ptr %1845, align 8, !noalias !53
  %1847 = load double, ptr %1818, align 8, !noalias !53
  %1848 = fmul double %1846, %1847
  %1849 = fadd double %1843, %1848
  %1850 = getelementptr i8, ptr @7, i64 %1839
  %1851 = getelementptr i8, ptr %1850, i64 16
  %1852 = load double, ptr %1851, align 8, !noalias !53
  %1853 = load double, ptr %1828, align 8, !noalias !53
  %1854 = fmul double %1852, %1853
  %1855 = fadd double %1849, %1854
  %1856 = select i1 %1836, i64 %237, i64 0
  %1857 = add i64 %1213, %1856
  %1858 = select i1 %1806, i64 %239, i64 0
  %1859 = mul i64 %1857, %239
  %1860 = getelementptr double, ptr %240, i64 %1859
  %1861 = getelementptr double, ptr %1860, i64 %1209
  %1862 = getelementptr double, ptr %1861, i64 %1858
  store double %1855, ptr %1862, align 8, !noalias !53
  br label %1212

1863:                                             ; preds = %1234
  %1864 = fmul double %870, %870
  %1865 = fcmp ugt double %1237, %1864
  br i1 %1865, label %1308, label %1309

1866:                                             ; preds = %1197, %985, %920, %1201, %1801, %1349, %923, %1309
  %1867 = phi double [ %1310, %1309 ], [ %1170, %1201 ], [ 0.000000e+00, %923 ], [ 0x7FF0000000000000, %1349 ], [ 0.000000e+00, %920 ], [ 0.000000e+00, %985 ], [ %1170, %1801 ], [ 0.000000e+00, %1197 ]
  %1868 = phi i64 [ %1313, %1309 ], [ %1320, %1201 ], [ %1321, %923 ], [ %1321, %1349 ], [ 0, %920 ], [ 0, %985 ], [ %1320, %1801 ], [ 0, %1197 ]
  %1869 = phi i1 [ %1312, %1309 ], [ true, %1201 ], [ true, %923 ], [ true, %1349 ], [ true, %920 ], [ true, %985 ], [ true, %1801 ], [ true, %1197 ]
  %1870 = phi i64 [ 0, %1309 ], [ 0, %1201 ], [ %924, %923 ], [ 0, %1349 ], [ 0, %920 ], [ 0, %985 ], [ 0, %1801 ], [ 0, %1197 ]
  %1871 = phi i32 [ 0, %1309 ], [ 0, %1201 ], [ 0, %923 ], [ 0, %1349 ], [ %922, %920 ], [ %986, %985 ], [ 0, %1801 ], [ %1200, %1197 ]
  switch i32 %1871, label %2519 [
    i32 -2, label %2517
    i32 0, label %2517
  ], !prof !25

1872:                                             ; preds = %2517
  br label %2649

1873:                                             ; preds = %2517
  br i1 %1869, label %2261, label %1874

1874:                                             ; preds = %1873, %2520
  %1875 = phi i64 [ %2522, %2520 ], [ 0, %1873 ]
  %1876 = phi i64 [ %2521, %2520 ], [ %284, %1873 ]
  %1877 = icmp sgt i64 %1876, 0
  br i1 %1877, label %2520, label %1878

1878:                                             ; preds = %1874
  %1879 = getelementptr i8, ptr %198, i64 32
  %1880 = load i64, ptr %1879, align 8, !noalias !5
  %1881 = icmp ne i64 %1880, 1
  store ptr null, ptr %6, align 8, !noalias !93
  store double 0.000000e+00, ptr %7, align 8, !noalias !93
  store ptr null, ptr %8, align 8, !noalias !93
  store ptr null, ptr %9, align 8, !noalias !93
  store double 0.000000e+00, ptr %10, align 8, !noalias !93
  store ptr null, ptr %11, align 8, !noalias !93
  %1882 = load i64, ptr %118, align 8, !noalias !93
  %1883 = call i64 @llvm.smax.i64(i64 %1882, i64 0)
  br label %1884

1884:                                             ; preds = %1919, %1878
  %1885 = phi i64 [ 0, %1878 ], [ %1921, %1919 ]
  %1886 = phi i64 [ %1883, %1878 ], [ %1920, %1919 ]
  %1887 = icmp sgt i64 %1886, 0
  br i1 %1887, label %1919, label %1888

1888:                                             ; preds = %1884
  store ptr null, ptr %6, align 8, !noalias !93
  %1889 = call fastcc i32 @solve(ptr nonnull %6, ptr %216, i64 %213, i64 %215, ptr %228, i64 %227, ptr %264, i64 %263) #3, !noalias !93
  switch i32 %1889, label %1997 [
    i32 -2, label %1953
    i32 0, label %1953
  ], !prof !25

1890:                                             ; preds = %1956, %1959
  %1891 = phi i64 [ %1961, %1959 ], [ 0, %1956 ]
  %1892 = phi i64 [ %1960, %1959 ], [ %1883, %1956 ]
  %1893 = icmp sgt i64 %1892, 0
  br i1 %1893, label %1959, label %1894

1894:                                             ; preds = %1890
  %1895 = getelementptr i8, ptr %112, i64 24
  %1896 = load i64, ptr %1895, align 8, !noalias !93
  %1897 = add nsw i64 %1896, 1
  store i64 %1897, ptr %1895, align 8, !noalias !93
  store ptr null, ptr %4, align 8, !noalias !97
  store ptr null, ptr %5, align 8, !noalias !97
  store double %392, ptr %35, align 8, !noalias !97
  %1898 = icmp sgt i64 %47, 0
  br i1 %1898, label %1899, label %1902

1899:                                             ; preds = %1894
  store ptr null, ptr %4, align 8, !noalias !97
  %1900 = call fastcc i32 @_sample(ptr nonnull %4, ptr %40, i64 %39, ptr %50, i64 %47, i64 %49, ptr %55, i64 %54, ptr %62, i64 %59, i64 %61, double %392) #3
  switch i32 %1900, label %1901 [
    i32 -2, label %1902
    i32 0, label %1902
  ], !prof !25

1901:                                             ; preds = %1899
  br label %1902

1902:                                             ; preds = %1899, %1899, %1894, %1901
  %1903 = phi i32 [ %1900, %1901 ], [ 0, %1894 ], [ 0, %1899 ], [ 0, %1899 ]
  switch i32 %1903, label %1908 [
    i32 -2, label %1904
    i32 0, label %1904
  ], !prof !25

1904:                                             ; preds = %1902, %1902
  %1905 = load i64, ptr %32, align 8, !noalias !104
  %1906 = inttoptr i64 %1905 to ptr
  %1907 = call i32 %1906(ptr nonnull %35, ptr %77, ptr %40, ptr %43, ptr %252) #3, !noalias !104
  br label %1908

1908:                                             ; preds = %1902, %1904
  %1909 = phi i32 [ %1907, %1904 ], [ 0, %1902 ]
  %1910 = phi i32 [ 0, %1904 ], [ %1903, %1902 ]
  switch i32 %1910, label %1997 [
    i32 -2, label %1975
    i32 0, label %1975
  ], !prof !25

1911:                                             ; preds = %1975
  %1912 = sext i32 %1909 to i64
  br label %1997

1913:                                             ; preds = %1975, %1977
  %1914 = phi i64 [ %1979, %1977 ], [ 0, %1975 ]
  %1915 = phi i64 [ %1978, %1977 ], [ %1883, %1975 ]
  %1916 = icmp sgt i64 %1915, 0
  br i1 %1916, label %1977, label %1917

1917:                                             ; preds = %1913
  store ptr null, ptr %9, align 8, !noalias !93
  %1918 = call fastcc i32 @solve(ptr nonnull %9, ptr %216, i64 %213, i64 %215, ptr %228, i64 %227, ptr %264, i64 %263) #3, !noalias !93
  switch i32 %1918, label %1997 [
    i32 -2, label %1993
    i32 0, label %1993
  ], !prof !25

1919:                                             ; preds = %1884
  %1920 = add nsw i64 %1886, -1
  %1921 = add i64 %1885, 1
  %1922 = icmp slt i64 %1885, 0
  %1923 = select i1 %1922, i64 %239, i64 0
  %1924 = getelementptr double, ptr %240, i64 %1885
  %1925 = getelementptr double, ptr %1924, i64 %1923
  %1926 = load double, ptr %1925, align 8, !noalias !93
  %1927 = fmul double %1926, 0xC02418FD8BAFFE05
  %1928 = getelementptr double, ptr %240, i64 %239
  %1929 = getelementptr double, ptr %1928, i64 %1885
  %1930 = getelementptr double, ptr %1929, i64 %1923
  %1931 = load double, ptr %1930, align 8, !noalias !93
  %1932 = fmul double %1931, 0x3FF61D41B2D54580
  %1933 = fadd double %1927, %1932
  %1934 = shl i64 %239, 4
  %1935 = getelementptr i8, ptr %240, i64 %1934
  %1936 = getelementptr double, ptr %1935, i64 %1885
  %1937 = getelementptr double, ptr %1936, i64 %1923
  %1938 = load double, ptr %1937, align 8, !noalias !93
  %1939 = fmul double %1938, 0xBFD5555555555555
  %1940 = fadd double %1933, %1939
  %1941 = fdiv double %1940, %417
  %1942 = select i1 %1922, i64 %273, i64 0
  %1943 = getelementptr double, ptr %274, i64 %1885
  %1944 = getelementptr double, ptr %1943, i64 %1942
  store double %1941, ptr %1944, align 8, !noalias !93
  %1945 = select i1 %1922, i64 %86, i64 0
  %1946 = getelementptr double, ptr %87, i64 %1885
  %1947 = getelementptr double, ptr %1946, i64 %1945
  %1948 = load double, ptr %1947, align 8, !noalias !93
  %1949 = fadd double %1948, %1941
  %1950 = select i1 %1922, i64 %263, i64 0
  %1951 = getelementptr double, ptr %264, i64 %1885
  %1952 = getelementptr double, ptr %1951, i64 %1950
  store double %1949, ptr %1952, align 8, !noalias !93
  br label %1884

1953:                                             ; preds = %1888, %1888
  store double 0.000000e+00, ptr %7, align 8, !noalias !93
  %1954 = call fastcc i32 @norm(ptr nonnull %7, i64 %263, ptr %264, i64 %263, ptr %67, i64 %66, ptr %72, i64 %71, ptr nonnull %97, i64 %96, ptr %102, i64 %101) #3
  %1955 = load double, ptr %7, align 8, !noalias !93
  switch i32 %1954, label %1997 [
    i32 -2, label %1956
    i32 0, label %1956
  ], !prof !25

1956:                                             ; preds = %1953, %1953
  %1957 = fcmp olt double %1955, 1.000000e+00
  %1958 = select i1 %1957, i1 true, i1 %1881
  br i1 %1958, label %1997, label %1890

1959:                                             ; preds = %1890
  %1960 = add nsw i64 %1892, -1
  %1961 = add i64 %1891, 1
  %1962 = icmp slt i64 %1891, 0
  %1963 = select i1 %1962, i64 %66, i64 0
  %1964 = getelementptr double, ptr %67, i64 %1891
  %1965 = getelementptr double, ptr %1964, i64 %1963
  %1966 = load double, ptr %1965, align 8, !noalias !93
  %1967 = select i1 %1962, i64 %263, i64 0
  %1968 = getelementptr double, ptr %264, i64 %1891
  %1969 = getelementptr double, ptr %1968, i64 %1967
  %1970 = load double, ptr %1969, align 8, !noalias !93
  %1971 = fadd double %1966, %1970
  %1972 = select i1 %1962, i64 %76, i64 0
  %1973 = getelementptr double, ptr %77, i64 %1891
  %1974 = getelementptr double, ptr %1973, i64 %1972
  store double %1971, ptr %1974, align 8, !noalias !93
  br label %1890

1975:                                             ; preds = %1908, %1908
  %1976 = icmp eq i32 %1909, 0
  br i1 %1976, label %1913, label %1911

1977:                                             ; preds = %1913
  %1978 = add nsw i64 %1915, -1
  %1979 = add i64 %1914, 1
  %1980 = icmp slt i64 %1914, 0
  %1981 = select i1 %1980, i64 %251, i64 0
  %1982 = getelementptr double, ptr %252, i64 %1914
  %1983 = getelementptr double, ptr %1982, i64 %1981
  %1984 = load double, ptr %1983, align 8, !noalias !93
  %1985 = select i1 %1980, i64 %273, i64 0
  %1986 = getelementptr double, ptr %274, i64 %1914
  %1987 = getelementptr double, ptr %1986, i64 %1985
  %1988 = load double, ptr %1987, align 8, !noalias !93
  %1989 = fadd double %1984, %1988
  %1990 = select i1 %1980, i64 %263, i64 0
  %1991 = getelementptr double, ptr %264, i64 %1914
  %1992 = getelementptr double, ptr %1991, i64 %1990
  store double %1989, ptr %1992, align 8, !noalias !93
  br label %1913

1993:                                             ; preds = %1917, %1917
  store double 0.000000e+00, ptr %10, align 8, !noalias !93
  %1994 = call fastcc i32 @norm(ptr nonnull %10, i64 %263, ptr %264, i64 %263, ptr %67, i64 %66, ptr %72, i64 %71, ptr nonnull %97, i64 %96, ptr %102, i64 %101) #3
  switch i32 %1994, label %1997 [
    i32 -2, label %1995
    i32 0, label %1995
  ], !prof !25

1995:                                             ; preds = %1993, %1993
  %1996 = load double, ptr %10, align 8, !noalias !93
  br label %1997

1997:                                             ; preds = %1993, %1917, %1908, %1953, %1888, %1956, %1911, %1995
  %1998 = phi double [ %1955, %1956 ], [ 0.000000e+00, %1888 ], [ %1955, %1911 ], [ 0.000000e+00, %1953 ], [ 0.000000e+00, %1908 ], [ 0.000000e+00, %1917 ], [ %1996, %1995 ], [ 0.000000e+00, %1993 ]
  %1999 = phi i64 [ 0, %1956 ], [ 0, %1888 ], [ %1912, %1911 ], [ 0, %1953 ], [ 0, %1908 ], [ 0, %1917 ], [ 0, %1995 ], [ 0, %1993 ]
  %2000 = phi i32 [ 0, %1956 ], [ %1889, %1888 ], [ 0, %1911 ], [ %1954, %1953 ], [ %1910, %1908 ], [ %1918, %1917 ], [ 0, %1995 ], [ %1994, %1993 ]
  switch i32 %2000, label %2540 [
    i32 -2, label %2538
    i32 0, label %2538
  ], !prof !25

2001:                                             ; preds = %2538
  br label %2649

2002:                                             ; preds = %2538
  %2003 = add nsw i64 %1868, 12
  %2004 = sitofp i64 %2003 to double
  %2005 = fdiv double 0x4027666666666667, %2004
  %2006 = fcmp olt double %1998, 1.000000e-10
  %2007 = select i1 %2006, double 1.000000e-10, double %1998
  %2008 = call double @llvm.pow.f64(double %2007, double -2.500000e-01)
  %2009 = icmp eq i64 %1999, 0
  %2010 = fcmp olt double %1998, 1.000000e+00
  %2011 = select i1 %2009, i1 %2010, i1 false
  br i1 %2011, label %2012, label %2244

2012:                                             ; preds = %2002
  br i1 %277, label %2013, label %2020

2013:                                             ; preds = %2012
  %2014 = getelementptr i8, ptr %159, i64 56
  %2015 = load i64, ptr %2014, align 8, !noalias !5
  %2016 = inttoptr i64 %2015 to ptr
  %2017 = call i64 %2016(i64 %0, double %418, i64 %69) #3, !noalias !5
  %2018 = icmp eq i64 %2017, 0
  br i1 %2018, label %2020, label %2019

2019:                                             ; preds = %2013
  store double %417, ptr %300, align 8, !noalias !5
  br label %2649

2020:                                             ; preds = %2013, %2012
  %2021 = load i64, ptr %398, align 8, !noalias !5
  %2022 = add nsw i64 %2021, 1
  store i64 %2022, ptr %398, align 8, !noalias !5
  %2023 = getelementptr i8, ptr %107, i64 24
  %2024 = load double, ptr %2023, align 8, !noalias !5
  %2025 = fcmp ogt double %2024, 0.000000e+00
  br i1 %2025, label %2026, label %2036

2026:                                             ; preds = %2020
  %2027 = getelementptr i8, ptr %107, i64 32
  %2028 = load double, ptr %2027, align 8, !noalias !5
  %2029 = fdiv double %417, %2028
  %2030 = fdiv double %2024, %2007
  %2031 = call double @llvm.pow.f64(double %2030, double 2.500000e-01)
  %2032 = fmul double %2029, %2031
  %2033 = fcmp olt double %2032, 1.000000e+00
  %2034 = select i1 %2033, double %2032, double 1.000000e+00
  %2035 = fmul double %2008, %2034
  br label %2036

2036:                                             ; preds = %2026, %2020
  %2037 = phi double [ %2035, %2026 ], [ %2008, %2020 ]
  %2038 = fmul double %2005, %2037
  %2039 = fcmp olt double %2038, 1.000000e+01
  %2040 = select i1 %2039, double %2038, double 1.000000e+01
  store double %418, ptr %107, align 8, !noalias !5
  %2041 = getelementptr i8, ptr %107, i64 32
  store double %417, ptr %2041, align 8, !noalias !5
  store double %2007, ptr %2023, align 8, !noalias !5
  br label %2042

2042:                                             ; preds = %2046, %2036
  %2043 = phi i64 [ 0, %2036 ], [ %2543, %2046 ]
  %2044 = phi i64 [ %284, %2036 ], [ %2542, %2046 ]
  %2045 = icmp sgt i64 %2044, 0
  br i1 %2045, label %2541, label %2050

2046:                                             ; preds = %2541, %2598
  %2047 = phi i64 [ 0, %2541 ], [ %2600, %2598 ]
  %2048 = phi i64 [ 3, %2541 ], [ %2599, %2598 ]
  %2049 = icmp sgt i64 %2048, 0
  br i1 %2049, label %2598, label %2042

2050:                                             ; preds = %2042
  store double %417, ptr %790, align 8, !noalias !5
  %2051 = getelementptr i8, ptr %162, i64 8
  %2052 = load i64, ptr %2051, align 8, !noalias !5
  %2053 = icmp sgt i64 %2052, 0
  br i1 %2053, label %2063, label %2054

2054:                                             ; preds = %2050
  %2055 = getelementptr i8, ptr %112, i64 48
  %2056 = load i64, ptr %2055, align 8, !noalias !5
  %2057 = icmp slt i64 %2056, 0
  %2058 = select i1 %2057, i64 %116, i64 0
  %2059 = getelementptr double, ptr %117, i64 %2056
  %2060 = getelementptr double, ptr %2059, i64 %2058
  %2061 = load double, ptr %2060, align 8, !noalias !5
  %2062 = fcmp ugt double %2061, %418
  br i1 %2062, label %2199, label %2070

2063:                                             ; preds = %2050
  %2064 = getelementptr i8, ptr %162, i64 16
  %2065 = load i64, ptr %2064, align 8, !noalias !5
  %2066 = inttoptr i64 %2065 to ptr
  %2067 = call i64 %2066(i64 %0, double %392, double %417) #3, !noalias !5
  %2068 = getelementptr i8, ptr %107, i64 48
  %2069 = load double, ptr %2068, align 8, !noalias !5
  br label %2070

2070:                                             ; preds = %2054, %2063
  %2071 = phi double [ %2069, %2063 ], [ 1.000000e+00, %2054 ]
  %2072 = phi i64 [ %2067, %2063 ], [ 0, %2054 ]
  %2073 = fcmp oeq double %2071, 1.000000e+00
  br i1 %2073, label %2074, label %2076

2074:                                             ; preds = %2070
  %2075 = load double, ptr %107, align 8, !noalias !5
  br label %2079

2076:                                             ; preds = %2070
  %2077 = fmul double %2071, %417
  %2078 = fadd double %392, %2077
  br label %2079

2079:                                             ; preds = %2076, %2074
  %2080 = phi double [ %2075, %2074 ], [ %2078, %2076 ]
  %2081 = load i64, ptr %118, align 8, !noalias !5
  %2082 = load i64, ptr %159, align 8, !noalias !5
  %2083 = icmp eq i64 %2082, 1
  %2084 = getelementptr i8, ptr %112, i64 48
  %2085 = load i64, ptr %2084, align 8, !noalias !5
  %2086 = icmp slt i64 %2085, %116
  br i1 %2086, label %2087, label %2124

2087:                                             ; preds = %2079
  %2088 = icmp slt i64 %2085, 0
  %2089 = select i1 %2088, i64 %116, i64 0
  %2090 = getelementptr double, ptr %117, i64 %2085
  %2091 = getelementptr double, ptr %2090, i64 %2089
  %2092 = load double, ptr %2091, align 8, !noalias !5
  %2093 = fcmp ugt double %2092, %2080
  br i1 %2093, label %2124, label %2094

2094:                                             ; preds = %2087, %2117
  %2095 = phi i64 [ %2115, %2117 ], [ %2085, %2087 ]
  %2096 = icmp slt i64 %2095, 0
  %2097 = select i1 %2096, i64 %116, i64 0
  %2098 = getelementptr double, ptr %117, i64 %2095
  %2099 = getelementptr double, ptr %2098, i64 %2097
  %2100 = load double, ptr %2099, align 8, !noalias !5
  %2101 = fsub double %2100, %392
  %2102 = fdiv double %2101, %417
  %2103 = mul nsw i64 %2095, %2081
  %2104 = shl i64 %2103, 3
  %2105 = add i64 %2104, %1
  %2106 = call i64 @llvm.smax.i64(i64 %81, i64 0)
  br label %2615

2107:                                             ; preds = %2619
  %2108 = getelementptr i8, ptr %159, i64 56
  %2109 = load i64, ptr %2108, align 8, !noalias !5
  %2110 = load double, ptr %2099, align 8, !noalias !5
  %2111 = inttoptr i64 %2109 to ptr
  %2112 = call i64 %2111(i64 %0, double %2110, i64 %2105) #3, !noalias !5
  %2113 = icmp eq i64 %2112, 0
  br i1 %2113, label %2114, label %2126

2114:                                             ; preds = %2619, %2107
  %2115 = add nsw i64 %2095, 1
  %2116 = icmp slt i64 %2115, %116
  br i1 %2116, label %2117, label %2124

2117:                                             ; preds = %2114
  %2118 = icmp slt i64 %2095, -1
  %2119 = select i1 %2118, i64 %116, i64 0
  %2120 = getelementptr double, ptr %117, i64 %2115
  %2121 = getelementptr double, ptr %2120, i64 %2119
  %2122 = load double, ptr %2121, align 8, !noalias !5
  %2123 = fcmp ugt double %2122, %2080
  br i1 %2123, label %2124, label %2094

2124:                                             ; preds = %2117, %2114, %2087, %2079
  %2125 = phi i64 [ %2115, %2117 ], [ %2115, %2114 ], [ %2085, %2087 ], [ %2085, %2079 ]
  store i64 %2125, ptr %2084, align 8, !noalias !5
  br label %2126

2126:                                             ; preds = %2107, %2124
  %2127 = phi i1 [ true, %2124 ], [ false, %2107 ]
  %2128 = phi i64 [ 0, %2124 ], [ %2112, %2107 ]
  %2129 = icmp ne i64 %2072, 0
  %2130 = select i1 %2127, i1 %2129, i1 false
  %2131 = fcmp olt double %2071, 1.000000e+00
  %2132 = and i1 %2130, %2131
  br i1 %2132, label %2133, label %2172

2133:                                             ; preds = %2126
  %2134 = call i64 @llvm.smax.i64(i64 %81, i64 0)
  br label %2135

2135:                                             ; preds = %2133, %2160
  %2136 = phi i64 [ 0, %2133 ], [ %2162, %2160 ]
  %2137 = phi i64 [ %2134, %2133 ], [ %2161, %2160 ]
  %2138 = icmp sgt i64 %2137, 0
  br i1 %2138, label %2160, label %2139

2139:                                             ; preds = %2135
  %2140 = getelementptr i8, ptr %29, i64 24
  %2141 = load i64, ptr %2140, align 8, !noalias !105
  %2142 = getelementptr i8, ptr %32, i64 16
  %2143 = load i64, ptr %2142, align 8, !noalias !105
  call fastcc void @pydy_nested(i64 %74, i64 %64, i64 %89, i64 %66, i64 %2141, i64 %79, i64 %2143) #3, !noalias !105
  %2144 = call i64 @llvm.smax.i64(i64 %71, i64 0)
  br label %2145

2145:                                             ; preds = %2149, %2139
  %2146 = phi i64 [ 0, %2139 ], [ %2151, %2149 ]
  %2147 = phi i64 [ %2144, %2139 ], [ %2150, %2149 ]
  %2148 = icmp sgt i64 %2147, 0
  br i1 %2148, label %2149, label %2631

2149:                                             ; preds = %2145
  %2150 = add nsw i64 %2147, -1
  %2151 = add i64 %2146, 1
  %2152 = icmp slt i64 %2146, 0
  %2153 = select i1 %2152, i64 %76, i64 0
  %2154 = getelementptr double, ptr %77, i64 %2146
  %2155 = getelementptr double, ptr %2154, i64 %2153
  %2156 = load double, ptr %2155, align 8, !noalias !109
  %2157 = select i1 %2152, i64 %71, i64 0
  %2158 = getelementptr double, ptr %72, i64 %2146
  %2159 = getelementptr double, ptr %2158, i64 %2157
  store double %2156, ptr %2159, align 8, !noalias !109
  br label %2145

2160:                                             ; preds = %2135
  %2161 = add nsw i64 %2137, -1
  %2162 = add i64 %2136, 1
  %2163 = icmp slt i64 %2136, 0
  %2164 = select i1 %2163, i64 %81, i64 0
  %2165 = getelementptr double, ptr %82, i64 %2136
  %2166 = getelementptr double, ptr %2165, i64 %2164
  store double %2071, ptr %2166, align 8, !noalias !105
  br label %2135

2167:                                             ; preds = %2631
  %2168 = getelementptr i8, ptr %159, i64 56
  %2169 = load i64, ptr %2168, align 8, !noalias !5
  %2170 = inttoptr i64 %2169 to ptr
  %2171 = call i64 %2170(i64 %0, double %2080, i64 %69) #3, !noalias !5
  br label %2172

2172:                                             ; preds = %2631, %2167, %2126
  %2173 = phi i64 [ %2171, %2167 ], [ 0, %2631 ], [ %2128, %2126 ]
  %2174 = icmp eq i64 %2173, 0
  br i1 %2174, label %2176, label %2175

2175:                                             ; preds = %2172
  store double %392, ptr %107, align 8, !noalias !5
  store double %417, ptr %300, align 8, !noalias !5
  br label %2195

2176:                                             ; preds = %2172
  %2177 = icmp eq i64 %2072, 0
  br i1 %2177, label %2195, label %2178

2178:                                             ; preds = %2176
  %2179 = call i64 @llvm.smax.i64(i64 %66, i64 0)
  br label %2180

2180:                                             ; preds = %2184, %2178
  %2181 = phi i64 [ 0, %2178 ], [ %2186, %2184 ]
  %2182 = phi i64 [ %2179, %2178 ], [ %2185, %2184 ]
  %2183 = icmp sgt i64 %2182, 0
  br i1 %2183, label %2184, label %2634

2184:                                             ; preds = %2180
  %2185 = add nsw i64 %2182, -1
  %2186 = add i64 %2181, 1
  %2187 = icmp slt i64 %2181, 0
  %2188 = select i1 %2187, i64 %71, i64 0
  %2189 = getelementptr double, ptr %72, i64 %2181
  %2190 = getelementptr double, ptr %2189, i64 %2188
  %2191 = load double, ptr %2190, align 8, !noalias !112
  %2192 = select i1 %2187, i64 %66, i64 0
  %2193 = getelementptr double, ptr %67, i64 %2181
  %2194 = getelementptr double, ptr %2193, i64 %2192
  store double %2191, ptr %2194, align 8, !noalias !112
  br label %2180

2195:                                             ; preds = %2176, %2634, %2175
  %2196 = phi i1 [ false, %2175 ], [ false, %2634 ], [ true, %2176 ]
  %2197 = phi i64 [ %2173, %2175 ], [ %2072, %2634 ], [ 0, %2176 ]
  br i1 %2196, label %2199, label %2198

2198:                                             ; preds = %2195
  br label %2649

2199:                                             ; preds = %2195, %2054
  br label %2200

2200:                                             ; preds = %2199, %2635
  %2201 = phi i64 [ 0, %2199 ], [ %2637, %2635 ]
  %2202 = phi i64 [ %284, %2199 ], [ %2636, %2635 ]
  %2203 = icmp sgt i64 %2202, 0
  br i1 %2203, label %2635, label %2204

2204:                                             ; preds = %2200
  %2205 = getelementptr i8, ptr %112, i64 24
  %2206 = load i64, ptr %2205, align 8, !noalias !5
  %2207 = add nsw i64 %2206, 1
  store i64 %2207, ptr %2205, align 8, !noalias !5
  store ptr null, ptr %17, align 8, !noalias !115
  store ptr null, ptr %18, align 8, !noalias !115
  store double %418, ptr %35, align 8, !noalias !115
  %2208 = icmp sgt i64 %47, 0
  br i1 %2208, label %2209, label %2212

2209:                                             ; preds = %2204
  store ptr null, ptr %17, align 8, !noalias !115
  %2210 = call fastcc i32 @_sample(ptr nonnull %17, ptr %40, i64 %39, ptr %50, i64 %47, i64 %49, ptr %55, i64 %54, ptr %62, i64 %59, i64 %61, double %418) #3
  switch i32 %2210, label %2211 [
    i32 -2, label %2212
    i32 0, label %2212
  ], !prof !25

2211:                                             ; preds = %2209
  br label %2212

2212:                                             ; preds = %2209, %2209, %2204, %2211
  %2213 = phi i32 [ %2210, %2211 ], [ 0, %2204 ], [ 0, %2209 ], [ 0, %2209 ]
  switch i32 %2213, label %2218 [
    i32 -2, label %2214
    i32 0, label %2214
  ], !prof !25

2214:                                             ; preds = %2212, %2212
  %2215 = load i64, ptr %32, align 8, !noalias !122
  %2216 = inttoptr i64 %2215 to ptr
  %2217 = call i32 %2216(ptr nonnull %35, ptr %67, ptr %40, ptr %43, ptr %87) #3, !noalias !122
  br label %2218

2218:                                             ; preds = %2212, %2214
  %2219 = phi i32 [ %2217, %2214 ], [ 0, %2212 ]
  %2220 = phi i32 [ 0, %2214 ], [ %2213, %2212 ]
  switch i32 %2220, label %2648 [
    i32 -2, label %2646
    i32 0, label %2646
  ], !prof !25

2221:                                             ; preds = %2646
  %2222 = getelementptr i8, ptr %112, i64 72
  store i64 3, ptr %2222, align 8, !noalias !5
  store double %417, ptr %300, align 8, !noalias !5
  %2223 = icmp slt i32 %2219, 0
  %2224 = select i1 %2223, i64 -4, i64 2
  br label %2649

2225:                                             ; preds = %2646
  %2226 = icmp sgt i64 %1868, 2
  %2227 = fcmp ogt double %1867, 1.000000e-03
  %2228 = select i1 %2226, i1 %2227, i1 false
  %2229 = zext i1 %2228 to i64
  store i64 %2229, ptr %425, align 8, !noalias !5
  %2230 = getelementptr i8, ptr %198, i64 16
  store i64 0, ptr %2230, align 8, !noalias !5
  store i64 0, ptr %1879, align 8, !noalias !5
  %2231 = fcmp ule double %2040, 1.000000e+00
  %2232 = fcmp uge double %2040, 1.200000e+00
  %2233 = or i1 %2231, %2232
  %2234 = select i1 %2233, i1 true, i1 %2228
  br i1 %2234, label %2235, label %2239

2235:                                             ; preds = %2225
  %2236 = fcmp ogt double %2040, 2.000000e-01
  %2237 = select i1 %2236, double %2040, double 2.000000e-01
  %2238 = fmul double %417, %2237
  br label %2239

2239:                                             ; preds = %2225, %2235
  %2240 = phi double [ %2238, %2235 ], [ %417, %2225 ]
  %2241 = getelementptr i8, ptr %112, i64 48
  %2242 = load i64, ptr %2241, align 8, !noalias !5
  %2243 = icmp eq i64 %2242, %116
  br i1 %2243, label %2289, label %390

2244:                                             ; preds = %2002
  %2245 = load i64, ptr %400, align 8, !noalias !5
  %2246 = add nsw i64 %2245, 1
  store i64 %2246, ptr %400, align 8, !noalias !5
  %2247 = select i1 %2009, i64 2, i64 3
  %2248 = getelementptr i8, ptr %112, i64 72
  store i64 %2247, ptr %2248, align 8, !noalias !5
  %2249 = fsub double %1998, %1998
  %2250 = fcmp ord double %2249, 0.000000e+00
  br i1 %2250, label %2251, label %2255

2251:                                             ; preds = %2244
  %2252 = fmul double %2005, %2008
  %2253 = fcmp ogt double %2252, 2.000000e-01
  %2254 = select i1 %2253, double %2252, double 2.000000e-01
  br label %2255

2255:                                             ; preds = %2251, %2244
  %2256 = phi double [ 2.500000e-01, %2244 ], [ %2254, %2251 ]
  %2257 = fmul double %417, %2256
  %2258 = getelementptr i8, ptr %198, i64 16
  %2259 = load i64, ptr %2258, align 8, !noalias !5
  %2260 = sub nsw i64 1, %2259
  store i64 1, ptr %1879, align 8, !noalias !5
  store i64 %2260, ptr %425, align 8, !noalias !5
  br label %2286

2261:                                             ; preds = %1873
  %2262 = load i64, ptr %400, align 8, !noalias !5
  %2263 = add nsw i64 %2262, 1
  store i64 %2263, ptr %400, align 8, !noalias !5
  %2264 = icmp ne i64 %1870, 0
  br i1 %2264, label %2265, label %2267

2265:                                             ; preds = %2261
  %2266 = getelementptr i8, ptr %112, i64 72
  store i64 3, ptr %2266, align 8, !noalias !5
  br label %2274

2267:                                             ; preds = %2261
  %2268 = fsub double %1867, %1867
  %2269 = fcmp ord double %2268, 0.000000e+00
  br i1 %2269, label %2270, label %2272

2270:                                             ; preds = %2267
  %2271 = getelementptr i8, ptr %112, i64 72
  store i64 7, ptr %2271, align 8, !noalias !5
  br label %2274

2272:                                             ; preds = %2267
  %2273 = getelementptr i8, ptr %112, i64 72
  store i64 4, ptr %2273, align 8, !noalias !5
  br label %2274

2274:                                             ; preds = %2272, %2270, %2265
  %2275 = getelementptr i8, ptr %198, i64 16
  %2276 = load i64, ptr %2275, align 8, !noalias !5
  %2277 = icmp eq i64 %2276, 1
  %2278 = or i1 %2277, %2264
  br i1 %2278, label %2279, label %2282

2279:                                             ; preds = %2274
  %2280 = select i1 %2264, double 2.500000e-01, double 5.000000e-01
  %2281 = fmul double %417, %2280
  store double 0.000000e+00, ptr %790, align 8, !noalias !5
  br label %2282

2282:                                             ; preds = %2274, %2279
  %2283 = phi double [ %2281, %2279 ], [ %391, %2274 ]
  %2284 = load i64, ptr %2275, align 8, !noalias !5
  %2285 = sub nsw i64 1, %2284
  store i64 %2285, ptr %425, align 8, !noalias !5
  br label %2286

2286:                                             ; preds = %2282, %2255, %781
  %2287 = phi double [ %2257, %2255 ], [ %2283, %2282 ], [ %784, %781 ]
  br label %387

2288:                                             ; preds = %407
  store double %417, ptr %300, align 8, !noalias !5
  br label %2649

2289:                                             ; preds = %2239
  store double %2240, ptr %300, align 8, !noalias !5
  br label %2649

2290:                                             ; preds = %285
  %2291 = icmp slt i64 %286, 0
  %2292 = select i1 %2291, i64 %96, i64 0
  %2293 = getelementptr double, ptr %97, i64 %286
  %2294 = getelementptr double, ptr %2293, i64 %2292
  %2295 = load double, ptr %2294, align 8, !noalias !5
  %2296 = fcmp olt double %2295, %288
  %2297 = select i1 %2296, double %2295, double %288
  %2298 = add i64 %286, 1
  %2299 = add nsw i64 %287, -1
  br label %285

2300:                                             ; preds = %318, %318
  %2301 = icmp eq i32 %319, 0
  br i1 %2301, label %325, label %321

2302:                                             ; preds = %318
  br label %2649

2303:                                             ; preds = %2321, %2318
  %2304 = phi i64 [ %66, %2321 ], [ %2319, %2318 ]
  %2305 = sub i64 %2304, %2312
  %2306 = call i64 @llvm.smax.i64(i64 %2305, i64 0)
  %2307 = getelementptr double, ptr %67, i64 %2312
  store double 0.000000e+00, ptr %23, align 8, !noalias !5
  %2308 = call fastcc i32 @norm(ptr nonnull %23, i64 %2306, ptr %2307, i64 %2306, ptr %67, i64 %66, ptr %67, i64 %66, ptr nonnull %97, i64 %96, ptr %102, i64 %101) #3
  %2309 = load double, ptr %23, align 8, !noalias !5
  switch i32 %2308, label %2322 [
    i32 -2, label %2329
    i32 0, label %2329
  ], !prof !25

2310:                                             ; preds = %380
  br label %2311

2311:                                             ; preds = %2310, %380
  %2312 = phi i64 [ %66, %2310 ], [ 0, %380 ]
  %2313 = icmp slt i64 %381, 0
  %2314 = select i1 %2313, i64 %66, i64 0
  %2315 = add i64 %381, %2314
  %2316 = icmp slt i64 %2315, 0
  br i1 %2316, label %2317, label %2318, !prof !0

2317:                                             ; preds = %2311
  br label %2318

2318:                                             ; preds = %2317, %2311
  %2319 = phi i64 [ 0, %2317 ], [ %2315, %2311 ]
  %2320 = icmp slt i64 %2315, %66
  br i1 %2320, label %2303, label %2321, !prof !4

2321:                                             ; preds = %2318
  br label %2303

2322:                                             ; preds = %2303
  br label %2649

2323:                                             ; preds = %2341, %2338
  %2324 = phi i64 [ %86, %2341 ], [ %2339, %2338 ]
  %2325 = sub i64 %2324, %2333
  %2326 = call i64 @llvm.smax.i64(i64 %2325, i64 0)
  %2327 = getelementptr double, ptr %87, i64 %2333
  store double 0.000000e+00, ptr %25, align 8, !noalias !5
  %2328 = call fastcc i32 @norm(ptr nonnull %25, i64 %2326, ptr %2327, i64 %2326, ptr %67, i64 %66, ptr %67, i64 %66, ptr nonnull %97, i64 %96, ptr %102, i64 %101) #3
  switch i32 %2328, label %2359 [
    i32 -2, label %2342
    i32 0, label %2342
  ], !prof !25

2329:                                             ; preds = %2303, %2303
  %2330 = icmp slt i64 %86, 1
  br i1 %2330, label %2331, label %2332, !prof !0

2331:                                             ; preds = %2329
  br label %2332

2332:                                             ; preds = %2331, %2329
  %2333 = phi i64 [ %86, %2331 ], [ 0, %2329 ]
  %2334 = select i1 %2313, i64 %86, i64 0
  %2335 = add i64 %381, %2334
  %2336 = icmp slt i64 %2335, 0
  br i1 %2336, label %2337, label %2338, !prof !0

2337:                                             ; preds = %2332
  br label %2338

2338:                                             ; preds = %2337, %2332
  %2339 = phi i64 [ 0, %2337 ], [ %2335, %2332 ]
  %2340 = icmp slt i64 %2335, %86
  br i1 %2340, label %2323, label %2341, !prof !4

2341:                                             ; preds = %2338
  br label %2323

2342:                                             ; preds = %2323, %2323
  %2343 = load double, ptr %25, align 8, !noalias !5
  %2344 = fcmp olt double %2309, 1.000000e-05
  %2345 = fcmp olt double %2343, 1.000000e-05
  %2346 = select i1 %2344, i1 true, i1 %2345
  %2347 = fmul double %2309, 1.000000e-02
  %2348 = fdiv double %2347, %2343
  %2349 = select i1 %2346, double 0x3EB0C6F7A0B5ED8D, double %2348
  %2350 = call double @llvm.fabs.f64(double %299)
  %2351 = fmul double %2350, 0x3D30000000000000
  %2352 = fcmp olt double %2349, %2351
  %2353 = select i1 %2352, double %2351, double %2349
  %2354 = getelementptr i8, ptr %107, i64 16
  %2355 = load double, ptr %2354, align 8, !noalias !5
  %2356 = fcmp olt double %2355, %2353
  %2357 = select i1 %2356, double %2355, double %2353
  %2358 = call i1 @llvm.is.fpclass.f64(double %2357, i32 384)
  br i1 %2358, label %385, label %383

2359:                                             ; preds = %2323
  br label %2649

2360:                                             ; preds = %440, %440
  %2361 = load i64, ptr %198, align 8, !noalias !5
  %2362 = inttoptr i64 %2361 to ptr
  %2363 = call i32 %2362(ptr nonnull %35, ptr %67, ptr %40, ptr %204, ptr %209) #3, !noalias !5
  %2364 = sext i32 %2363 to i64
  br label %460

2365:                                             ; preds = %440
  br label %2649

2366:                                             ; preds = %444
  %2367 = add nsw i64 %446, -1
  %2368 = add i64 %445, 1
  %2369 = icmp slt i64 %445, 0
  %2370 = select i1 %2369, i64 %66, i64 0
  %2371 = getelementptr double, ptr %67, i64 %445
  %2372 = getelementptr double, ptr %2371, i64 %2370
  %2373 = load double, ptr %2372, align 8, !noalias !5
  %2374 = select i1 %2369, i64 %76, i64 0
  %2375 = getelementptr double, ptr %77, i64 %445
  %2376 = getelementptr double, ptr %2375, i64 %2374
  store double %2373, ptr %2376, align 8, !noalias !5
  br label %444

2377:                                             ; preds = %448
  %2378 = add nsw i64 %450, -1
  %2379 = add i64 %449, 1
  %2380 = icmp slt i64 %449, 0
  %2381 = select i1 %2380, i64 %66, i64 0
  %2382 = getelementptr double, ptr %67, i64 %449
  %2383 = getelementptr double, ptr %2382, i64 %2381
  %2384 = load double, ptr %2383, align 8, !noalias !5
  %2385 = call double @llvm.fabs.f64(double %2384)
  %2386 = fcmp olt double %2385, 1.000000e-05
  %2387 = select i1 %2386, double 1.000000e-05, double %2385
  %2388 = fmul double %2387, 1.500000e-08
  %2389 = fadd double %2384, %2388
  %2390 = fsub double %2389, %2384
  %2391 = select i1 %2380, i64 %76, i64 0
  %2392 = getelementptr double, ptr %77, i64 %449
  %2393 = getelementptr double, ptr %2392, i64 %2391
  store double %2389, ptr %2393, align 8, !noalias !5
  %2394 = getelementptr i8, ptr %112, i64 24
  %2395 = load i64, ptr %2394, align 8, !noalias !5
  %2396 = add nsw i64 %2395, 1
  store i64 %2396, ptr %2394, align 8, !noalias !5
  store ptr null, ptr %19, align 8, !noalias !123
  store ptr null, ptr %20, align 8, !noalias !123
  store double %392, ptr %35, align 8, !noalias !123
  %2397 = icmp sgt i64 %47, 0
  br i1 %2397, label %2398, label %2401

2398:                                             ; preds = %2377
  store ptr null, ptr %19, align 8, !noalias !123
  %2399 = call fastcc i32 @_sample(ptr nonnull %19, ptr %40, i64 %39, ptr %50, i64 %47, i64 %49, ptr %55, i64 %54, ptr %62, i64 %59, i64 %61, double %392) #3
  switch i32 %2399, label %2400 [
    i32 -2, label %2401
    i32 0, label %2401
  ], !prof !25

2400:                                             ; preds = %2398
  br label %2401

2401:                                             ; preds = %2398, %2398, %2377, %2400
  %2402 = phi i32 [ %2399, %2400 ], [ 0, %2377 ], [ 0, %2398 ], [ 0, %2398 ]
  switch i32 %2402, label %2407 [
    i32 -2, label %2403
    i32 0, label %2403
  ], !prof !25

2403:                                             ; preds = %2401, %2401
  %2404 = load i64, ptr %32, align 8, !noalias !130
  %2405 = inttoptr i64 %2404 to ptr
  %2406 = call i32 %2405(ptr nonnull %35, ptr %77, ptr %40, ptr %43, ptr %72) #3, !noalias !130
  br label %2407

2407:                                             ; preds = %2401, %2403
  %2408 = phi i32 [ %2406, %2403 ], [ 0, %2401 ]
  %2409 = phi i32 [ 0, %2403 ], [ %2402, %2401 ]
  switch i32 %2409, label %2412 [
    i32 -2, label %2410
    i32 0, label %2410
  ], !prof !25

2410:                                             ; preds = %2407, %2407
  %2411 = icmp eq i32 %2408, 0
  br i1 %2411, label %454, label %452

2412:                                             ; preds = %2407
  br label %2649

2413:                                             ; preds = %454
  %2414 = add nsw i64 %456, -1
  %2415 = add i64 %455, 1
  %2416 = icmp slt i64 %455, 0
  %2417 = select i1 %2416, i64 %71, i64 0
  %2418 = getelementptr double, ptr %72, i64 %455
  %2419 = getelementptr double, ptr %2418, i64 %2417
  %2420 = load double, ptr %2419, align 8, !noalias !5
  %2421 = select i1 %2416, i64 %86, i64 0
  %2422 = getelementptr double, ptr %87, i64 %455
  %2423 = getelementptr double, ptr %2422, i64 %2421
  %2424 = load double, ptr %2423, align 8, !noalias !5
  %2425 = fsub double %2420, %2424
  %2426 = fdiv double %2425, %2390
  %2427 = mul nsw i64 %455, %429
  %2428 = add nsw i64 %2427, %449
  %2429 = icmp slt i64 %2428, 0
  %2430 = select i1 %2429, i64 %208, i64 0
  %2431 = getelementptr double, ptr %209, i64 %2428
  %2432 = getelementptr double, ptr %2431, i64 %2430
  store double %2426, ptr %2432, align 8, !noalias !5
  br label %454

2433:                                             ; preds = %479
  %2434 = add nsw i64 %481, -1
  %2435 = add i64 %480, 1
  br label %483

2436:                                             ; preds = %483
  %2437 = add nsw i64 %485, -1
  %2438 = add i64 %484, 1
  %2439 = mul nsw i64 %480, %227
  %2440 = add nsw i64 %2439, %484
  %2441 = icmp slt i64 %2440, 0
  %2442 = select i1 %2441, i64 %208, i64 0
  %2443 = getelementptr double, ptr %209, i64 %2440
  %2444 = getelementptr double, ptr %2443, i64 %2442
  %2445 = load double, ptr %2444, align 8, !noalias !5
  %2446 = fneg double %2445
  %2447 = icmp slt i64 %480, 0
  %2448 = select i1 %2447, i64 %213, i64 0
  %2449 = add i64 %480, %2448
  %2450 = icmp slt i64 %484, 0
  %2451 = select i1 %2450, i64 %215, i64 0
  %2452 = mul i64 %2449, %215
  %2453 = getelementptr double, ptr %216, i64 %2452
  %2454 = getelementptr double, ptr %2453, i64 %484
  %2455 = getelementptr double, ptr %2454, i64 %2451
  store double %2446, ptr %2455, align 8, !noalias !5
  %2456 = load double, ptr %2444, align 8, !noalias !5
  %2457 = fneg double %2456
  %2458 = select i1 %2447, i64 %220, i64 0
  %2459 = add i64 %480, %2458
  %2460 = select i1 %2450, i64 %222, i64 0
  %2461 = mul i64 %2459, %222
  %2462 = getelementptr { double, double }, ptr %223, i64 %2461
  %2463 = getelementptr { double, double }, ptr %2462, i64 %484
  %2464 = getelementptr { double, double }, ptr %2463, i64 %2460
  store double %2457, ptr %2464, align 8, !noalias !5
  %2465 = getelementptr inbounds nuw i8, ptr %2464, i64 8
  store double 0.000000e+00, ptr %2465, align 8, !noalias !5
  br label %483

2466:                                             ; preds = %792
  %2467 = add nsw i64 %794, -1
  %2468 = add i64 %793, 1
  %2469 = fcmp ogt double %791, 0.000000e+00
  br i1 %2469, label %796, label %805

2470:                                             ; preds = %807
  %2471 = add nsw i64 %809, -1
  %2472 = add i64 %808, 1
  br i1 %2469, label %811, label %851

2473:                                             ; preds = %861
  %2474 = add nsw i64 %863, -1
  %2475 = add i64 %862, 1
  br label %865

2476:                                             ; preds = %865
  %2477 = add nsw i64 %867, -1
  %2478 = add i64 %866, 1
  %2479 = icmp slt i64 %862, 0
  %2480 = add i64 %862, 3
  %2481 = select i1 %2479, i64 %2480, i64 %862
  %2482 = mul i64 %2481, 24
  %2483 = getelementptr i8, ptr @1, i64 %2482
  %2484 = load double, ptr %2483, align 8, !noalias !5
  %2485 = icmp slt i64 %866, 0
  %2486 = select i1 %2485, i64 %239, i64 0
  %2487 = getelementptr double, ptr %240, i64 %866
  %2488 = getelementptr double, ptr %2487, i64 %2486
  %2489 = load double, ptr %2488, align 8, !noalias !5
  %2490 = fmul double %2484, %2489
  %2491 = getelementptr i8, ptr @2, i64 %2482
  %2492 = getelementptr i8, ptr %2491, i64 8
  %2493 = load double, ptr %2492, align 8, !noalias !5
  %2494 = getelementptr double, ptr %240, i64 %239
  %2495 = getelementptr double, ptr %2494, i64 %866
  %2496 = getelementptr double, ptr %2495, i64 %2486
  %2497 = load double, ptr %2496, align 8, !noalias !5
  %2498 = fmul double %2493, %2497
  %2499 = fadd double %2490, %2498
  %2500 = getelementptr i8, ptr @3, i64 %2482
  %2501 = getelementptr i8, ptr %2500, i64 16
  %2502 = load double, ptr %2501, align 8, !noalias !5
  %2503 = shl i64 %239, 4
  %2504 = getelementptr i8, ptr %240, i64 %2503
  %2505 = getelementptr double, ptr %2504, i64 %866
  %2506 = getelementptr double, ptr %2505, i64 %2486
  %2507 = load double, ptr %2506, align 8, !noalias !5
  %2508 = fmul double %2502, %2507
  %2509 = fadd double %2499, %2508
  %2510 = select i1 %2479, i64 %244, i64 0
  %2511 = add i64 %862, %2510
  %2512 = select i1 %2485, i64 %246, i64 0
  %2513 = mul i64 %2511, %246
  %2514 = getelementptr double, ptr %247, i64 %2513
  %2515 = getelementptr double, ptr %2514, i64 %866
  %2516 = getelementptr double, ptr %2515, i64 %2512
  store double %2509, ptr %2516, align 8, !noalias !5
  br label %865

2517:                                             ; preds = %1866, %1866
  %2518 = icmp slt i64 %1870, 0
  br i1 %2518, label %1872, label %1873

2519:                                             ; preds = %1866
  br label %2649

2520:                                             ; preds = %1874
  %2521 = add nsw i64 %1876, -1
  %2522 = add i64 %1875, 1
  %2523 = icmp slt i64 %1875, 0
  %2524 = select i1 %2523, i64 %66, i64 0
  %2525 = getelementptr double, ptr %67, i64 %1875
  %2526 = getelementptr double, ptr %2525, i64 %2524
  %2527 = load double, ptr %2526, align 8, !noalias !5
  %2528 = select i1 %2523, i64 %239, i64 0
  %2529 = shl i64 %239, 4
  %2530 = getelementptr i8, ptr %240, i64 %2529
  %2531 = getelementptr double, ptr %2530, i64 %1875
  %2532 = getelementptr double, ptr %2531, i64 %2528
  %2533 = load double, ptr %2532, align 8, !noalias !5
  %2534 = fadd double %2527, %2533
  %2535 = select i1 %2523, i64 %71, i64 0
  %2536 = getelementptr double, ptr %72, i64 %1875
  %2537 = getelementptr double, ptr %2536, i64 %2535
  store double %2534, ptr %2537, align 8, !noalias !5
  br label %1874

2538:                                             ; preds = %1997, %1997
  %2539 = icmp slt i64 %1999, 0
  br i1 %2539, label %2001, label %2002

2540:                                             ; preds = %1997
  br label %2649

2541:                                             ; preds = %2042
  %2542 = add nsw i64 %2044, -1
  %2543 = add i64 %2043, 1
  %2544 = icmp slt i64 %2043, 0
  %2545 = select i1 %2544, i64 %239, i64 0
  %2546 = getelementptr double, ptr %240, i64 %2043
  %2547 = getelementptr double, ptr %2546, i64 %2545
  %2548 = load double, ptr %2547, align 8, !noalias !5
  %2549 = fmul double %2548, 0xC039A12CE7B30915
  %2550 = getelementptr double, ptr %240, i64 %239
  %2551 = getelementptr double, ptr %2550, i64 %2043
  %2552 = getelementptr double, ptr %2551, i64 %2545
  %2553 = load double, ptr %2552, align 8, !noalias !5
  %2554 = fmul double %2553, 0x402497AF24BB677E
  %2555 = fadd double %2549, %2554
  %2556 = shl i64 %239, 4
  %2557 = getelementptr i8, ptr %240, i64 %2556
  %2558 = getelementptr double, ptr %2557, i64 %2043
  %2559 = getelementptr double, ptr %2558, i64 %2545
  %2560 = load double, ptr %2559, align 8, !noalias !5
  %2561 = fmul double %2560, 0xC005555555555555
  %2562 = fadd double %2555, %2561
  %2563 = fmul double %2548, 0x402F295C43B61425
  %2564 = fmul double %2553, 0xC021D406EE60BECF
  %2565 = fadd double %2563, %2564
  %2566 = fmul double %2560, 0x400AAAAAAAAAAAAB
  %2567 = fadd double %2565, %2566
  %2568 = select i1 %2544, i64 %71, i64 0
  %2569 = getelementptr double, ptr %72, i64 %2043
  %2570 = getelementptr double, ptr %2569, i64 %2568
  %2571 = load double, ptr %2570, align 8, !noalias !5
  %2572 = select i1 %2544, i64 %66, i64 0
  %2573 = getelementptr double, ptr %67, i64 %2043
  %2574 = getelementptr double, ptr %2573, i64 %2572
  %2575 = load double, ptr %2574, align 8, !noalias !5
  %2576 = fsub double %2571, %2575
  %2577 = select i1 %2544, i64 %91, i64 0
  %2578 = getelementptr double, ptr %92, i64 %2043
  %2579 = getelementptr double, ptr %2578, i64 %2577
  store double %2576, ptr %2579, align 8, !noalias !5
  %2580 = fneg double %2562
  %2581 = fsub double %2580, %2567
  %2582 = add nsw i64 %66, %2043
  %2583 = icmp slt i64 %2582, 0
  %2584 = select i1 %2583, i64 %91, i64 0
  %2585 = getelementptr double, ptr %92, i64 %2582
  %2586 = getelementptr double, ptr %2585, i64 %2584
  store double %2581, ptr %2586, align 8, !noalias !5
  %2587 = fneg double %2567
  %2588 = shl nsw i64 %66, 1
  %2589 = add nsw i64 %2588, %2043
  %2590 = icmp slt i64 %2589, 0
  %2591 = select i1 %2590, i64 %91, i64 0
  %2592 = getelementptr double, ptr %92, i64 %2589
  %2593 = getelementptr double, ptr %2592, i64 %2591
  store double %2587, ptr %2593, align 8, !noalias !5
  %2594 = load double, ptr %2574, align 8, !noalias !5
  %2595 = select i1 %2544, i64 %258, i64 0
  %2596 = getelementptr double, ptr %259, i64 %2043
  %2597 = getelementptr double, ptr %2596, i64 %2595
  store double %2594, ptr %2597, align 8, !noalias !5
  br label %2046

2598:                                             ; preds = %2046
  %2599 = add nsw i64 %2048, -1
  %2600 = add i64 %2047, 1
  %2601 = mul nsw i64 %2047, %66
  %2602 = add nsw i64 %2601, %2043
  %2603 = icmp slt i64 %2602, 0
  %2604 = select i1 %2603, i64 %91, i64 0
  %2605 = getelementptr double, ptr %92, i64 %2602
  %2606 = getelementptr double, ptr %2605, i64 %2604
  %2607 = load double, ptr %2606, align 8, !noalias !5
  %2608 = icmp slt i64 %2047, -1
  %2609 = select i1 %2608, i64 %256, i64 0
  %2610 = add i64 %2600, %2609
  %2611 = mul i64 %2610, %258
  %2612 = getelementptr double, ptr %259, i64 %2611
  %2613 = getelementptr double, ptr %2612, i64 %2043
  %2614 = getelementptr double, ptr %2613, i64 %2595
  store double %2607, ptr %2614, align 8, !noalias !5
  br label %2046

2615:                                             ; preds = %2094, %2624
  %2616 = phi i64 [ 0, %2094 ], [ %2626, %2624 ]
  %2617 = phi i64 [ %2106, %2094 ], [ %2625, %2624 ]
  %2618 = icmp sgt i64 %2617, 0
  br i1 %2618, label %2624, label %2619

2619:                                             ; preds = %2615
  %2620 = getelementptr i8, ptr %29, i64 24
  %2621 = load i64, ptr %2620, align 8, !noalias !131
  %2622 = getelementptr i8, ptr %32, i64 16
  %2623 = load i64, ptr %2622, align 8, !noalias !131
  call fastcc void @pydy_nested(i64 %2105, i64 %64, i64 %89, i64 %66, i64 %2621, i64 %79, i64 %2623) #3, !noalias !131
  br i1 %2083, label %2107, label %2114

2624:                                             ; preds = %2615
  %2625 = add nsw i64 %2617, -1
  %2626 = add i64 %2616, 1
  %2627 = icmp slt i64 %2616, 0
  %2628 = select i1 %2627, i64 %81, i64 0
  %2629 = getelementptr double, ptr %82, i64 %2616
  %2630 = getelementptr double, ptr %2629, i64 %2628
  store double %2102, ptr %2630, align 8, !noalias !131
  br label %2615

2631:                                             ; preds = %2145
  %2632 = load i64, ptr %159, align 8, !noalias !5
  %2633 = icmp eq i64 %2632, 1
  br i1 %2633, label %2167, label %2172

2634:                                             ; preds = %2180
  store double %2080, ptr %107, align 8, !noalias !5
  store double 0.000000e+00, ptr %300, align 8, !noalias !5
  store i64 0, ptr %112, align 8, !noalias !5
  br label %2195

2635:                                             ; preds = %2200
  %2636 = add nsw i64 %2202, -1
  %2637 = add i64 %2201, 1
  %2638 = icmp slt i64 %2201, 0
  %2639 = select i1 %2638, i64 %71, i64 0
  %2640 = getelementptr double, ptr %72, i64 %2201
  %2641 = getelementptr double, ptr %2640, i64 %2639
  %2642 = load double, ptr %2641, align 8, !noalias !5
  %2643 = select i1 %2638, i64 %66, i64 0
  %2644 = getelementptr double, ptr %67, i64 %2201
  %2645 = getelementptr double, ptr %2644, i64 %2643
  store double %2642, ptr %2645, align 8, !noalias !5
  br label %2200

2646:                                             ; preds = %2218, %2218
  %2647 = icmp eq i32 %2219, 0
  br i1 %2647, label %2225, label %2221

2648:                                             ; preds = %2218
  br label %2649

2649:                                             ; preds = %2648, %2540, %2519, %2412, %2365, %2359, %2322, %2302, %2289, %2288, %2221, %2198, %2019, %2001, %1872, %463, %406, %395, %377, %321, %194
  %2650 = phi i64 [ -4, %2001 ], [ -1, %194 ], [ 2, %2288 ], [ %2197, %2198 ], [ 0, %2289 ], [ %2224, %2221 ], [ 0, %2519 ], [ 0, %2302 ], [ %324, %321 ], [ -4, %1872 ], [ 0, %377 ], [ 0, %2322 ], [ 0, %2359 ], [ 0, %2648 ], [ -1, %395 ], [ 1, %406 ], [ 6, %2019 ], [ 0, %2365 ], [ -4, %463 ], [ 0, %2412 ], [ 0, %2540 ]
  ret i64 %2650
}



declare i64 @llvm.smax.i64(i64, i64) #0

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #0

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
!27 = !{!28}
!28 = distinct !{!28, !29}
!29 = distinct !{!29}
!30 = !{!31, !33}
!31 = distinct !{!31, !32}
!32 = distinct !{!32}
!33 = distinct !{!33, !32}
!34 = !{!35}
!35 = distinct !{!35, !36}
!36 = distinct !{!36}
!37 = !{!38, !40}
!38 = distinct !{!38, !39}
!39 = distinct !{!39}
!40 = distinct !{!40, !39}
!41 = !{!42, !44, !46, !38, !40}
!42 = distinct !{!42, !43}
!43 = distinct !{!43}
!44 = distinct !{!44, !45}
!45 = distinct !{!45}
!46 = distinct !{!46, !45}
!47 = !{!48, !50, !52, !38, !40}
!48 = distinct !{!48, !49}
!49 = distinct !{!49}
!50 = distinct !{!50, !51}
!51 = distinct !{!51}
!52 = distinct !{!52, !51}
!53 = !{!54, !56}
!54 = distinct !{!54, !55}
!55 = distinct !{!55}
!56 = distinct !{!56, !55}
!57 = !{!58, !60, !61, !63, !54, !56}
!58 = distinct !{!58, !59}
!59 = distinct !{!59}
!60 = distinct !{!60, !59}
!61 = distinct !{!61, !62}
!62 = distinct !{!62}
!63 = distinct !{!63, !62}
!64 = !{!61, !63, !54, !56}
!65 = !{!66, !54, !56}
!66 = distinct !{!66, !67}
!67 = distinct !{!67}
!68 = !{!"branch_weights", i32 49, i32 1}
!69 = !{!70, !72, !54, !56}
!70 = distinct !{!70, !71}
!71 = distinct !{!71}
!72 = distinct !{!72, !71}
!73 = !{!74, !76, !78, !70, !72, !54, !56}
!74 = distinct !{!74, !75}
!75 = distinct !{!75}
!76 = distinct !{!76, !77}
!77 = distinct !{!77}
!78 = distinct !{!78, !77}
!79 = !{!80, !82, !84, !70, !72, !54, !56}
!80 = distinct !{!80, !81}
!81 = distinct !{!81}
!82 = distinct !{!82, !83}
!83 = distinct !{!83}
!84 = distinct !{!84, !83}
!85 = !{!86, !88, !54, !56}
!86 = distinct !{!86, !87}
!87 = distinct !{!87}
!88 = distinct !{!88, !87}
!89 = !{!90, !92, !54, !56}
!90 = distinct !{!90, !91}
!91 = distinct !{!91}
!92 = distinct !{!92, !91}
!93 = !{!94, !96}
!94 = distinct !{!94, !95}
!95 = distinct !{!95}
!96 = distinct !{!96, !95}
!97 = !{!98, !100, !101, !103, !94, !96}
!98 = distinct !{!98, !99}
!99 = distinct !{!99}
!100 = distinct !{!100, !99}
!101 = distinct !{!101, !102}
!102 = distinct !{!102}
!103 = distinct !{!103, !102}
!104 = !{!101, !103, !94, !96}
!105 = !{!106, !108, !6, !8}
!106 = distinct !{!106, !107}
!107 = distinct !{!107}
!108 = distinct !{!108, !107}
!109 = !{!110}
!110 = distinct !{!110, !111}
!111 = distinct !{!111}
!112 = !{!113}
!113 = distinct !{!113, !114}
!114 = distinct !{!114}
!115 = !{!116, !118, !119, !121}
!116 = distinct !{!116, !117}
!117 = distinct !{!117}
!118 = distinct !{!118, !117}
!119 = distinct !{!119, !120}
!120 = distinct !{!120}
!121 = distinct !{!121, !120}
!122 = !{!119, !121}
!123 = !{!124, !126, !127, !129}
!124 = distinct !{!124, !125}
!125 = distinct !{!125}
!126 = distinct !{!126, !125}
!127 = distinct !{!127, !128}
!128 = distinct !{!128}
!129 = distinct !{!129, !128}
!130 = !{!127, !129}
!131 = !{!132, !134, !6, !8}
!132 = distinct !{!132, !133}
!133 = distinct !{!133}
!134 = distinct !{!134, !133}
