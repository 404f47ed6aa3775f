; sources 69ecda69120619d844e86530fe62eab32d0c28b28a2303cba97596d2565455d6
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
  %21 = fdiv reassoc nsz contract double %17, %20
  %22 = call reassoc nsz contract double @sqrt(double %21)
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
  %41 = call reassoc nsz contract double @llvm.fabs.f64(double %40)
  %42 = select i1 %24, i64 %7, i64 0
  %43 = getelementptr double, ptr %6, i64 %15
  %44 = getelementptr double, ptr %43, i64 %42
  %45 = load double, ptr %44, align 8
  %46 = call reassoc nsz contract double @llvm.fabs.f64(double %45)
  %47 = fcmp reassoc nsz contract ogt double %46, %41
  %48 = select i1 %47, double %46, double %41
  %49 = add i64 %15, 1
  %50 = add nsw i64 %16, -1
  %51 = fmul reassoc nsz contract double %36, %48
  %52 = fadd reassoc nsz contract double %32, %51
  %53 = fdiv reassoc nsz contract double %28, %52
  %54 = fmul reassoc nsz contract double %53, %53
  %55 = fadd reassoc nsz contract double %17, %54
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
  br label %2151

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

285:                                              ; preds = %1792, %195
  %286 = phi i64 [ 0, %195 ], [ %1800, %1792 ]
  %287 = phi i64 [ %284, %195 ], [ %1801, %1792 ]
  %288 = phi double [ %283, %195 ], [ %1799, %1792 ]
  %289 = icmp sgt i64 %287, 0
  br i1 %289, label %1792, label %290

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
  switch i32 %320, label %1804 [
    i32 -2, label %1802
    i32 0, label %1802
  ], !prof !25

321:                                              ; preds = %1802
  %322 = getelementptr i8, ptr %112, i64 72
  store i64 3, ptr %322, align 8, !noalias !5
  %323 = icmp slt i32 %319, 0
  %324 = select i1 %323, i64 -4, i64 2
  br label %2151

325:                                              ; preds = %1802
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
  br label %2151

378:                                              ; preds = %374
  %379 = fcmp oeq double %301, 0.000000e+00
  br i1 %379, label %380, label %385

380:                                              ; preds = %378
  %381 = load i64, ptr %118, align 8, !noalias !5
  %382 = icmp slt i64 %66, 1
  br i1 %382, label %1812, label %1813, !prof !0

383:                                              ; preds = %1844
  %384 = getelementptr i8, ptr %112, i64 72
  store i64 4, ptr %384, align 8, !noalias !5
  br label %385

385:                                              ; preds = %1844, %290, %383, %378
  %386 = phi double [ %1859, %1844 ], [ %1859, %383 ], [ %301, %378 ], [ %301, %290 ]
  br label %387

387:                                              ; preds = %1788, %385
  %388 = phi double [ %386, %385 ], [ %1789, %1788 ]
  %389 = phi double [ %299, %385 ], [ %392, %1788 ]
  br label %390

390:                                              ; preds = %1741, %387
  %391 = phi double [ %388, %387 ], [ %1742, %1741 ]
  %392 = phi double [ %389, %387 ], [ %418, %1741 ]
  %393 = load i64, ptr %163, align 8, !noalias !5
  %394 = icmp eq i64 %393, 0
  br i1 %394, label %395, label %396

395:                                              ; preds = %390
  store double %391, ptr %300, align 8, !noalias !5
  br label %2151

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
  br label %2151

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
  br i1 %423, label %424, label %1790

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
  switch i32 %441, label %1867 [
    i32 -2, label %1862
    i32 0, label %1862
  ], !prof !25

442:                                              ; preds = %428
  %443 = call i64 @llvm.smax.i64(i64 %429, i64 0)
  br label %444

444:                                              ; preds = %442, %1868
  %445 = phi i64 [ 0, %442 ], [ %1870, %1868 ]
  %446 = phi i64 [ %443, %442 ], [ %1869, %1868 ]
  %447 = icmp sgt i64 %446, 0
  br i1 %447, label %1868, label %448

448:                                              ; preds = %444, %458
  %449 = phi i64 [ %1881, %458 ], [ 0, %444 ]
  %450 = phi i64 [ %1880, %458 ], [ %443, %444 ]
  %451 = icmp sgt i64 %450, 0
  br i1 %451, label %1879, label %460

452:                                              ; preds = %1912
  %453 = sext i32 %1910 to i64
  br label %460

454:                                              ; preds = %1912, %1915
  %455 = phi i64 [ %1917, %1915 ], [ 0, %1912 ]
  %456 = phi i64 [ %1916, %1915 ], [ %443, %1912 ]
  %457 = icmp sgt i64 %456, 0
  br i1 %457, label %1915, label %458

458:                                              ; preds = %454
  %459 = load double, ptr %1885, align 8, !noalias !5
  store double %459, ptr %1895, align 8, !noalias !5
  br label %448

460:                                              ; preds = %448, %1862, %452
  %461 = phi i64 [ %1866, %1862 ], [ %453, %452 ], [ 0, %448 ]
  %462 = icmp slt i64 %461, 0
  br i1 %462, label %463, label %464

463:                                              ; preds = %460
  br label %2151

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
  br i1 %473, label %474, label %788

474:                                              ; preds = %471, %467
  %475 = getelementptr i8, ptr %112, i64 40
  %476 = load i64, ptr %475, align 8, !noalias !5
  %477 = add nsw i64 %476, 1
  store i64 %477, ptr %475, align 8, !noalias !5
  br label %478

478:                                              ; preds = %486, %474
  %479 = phi i64 [ 0, %474 ], [ %1937, %486 ]
  %480 = phi i64 [ %284, %474 ], [ %1936, %486 ]
  %481 = icmp sgt i64 %480, 0
  br i1 %481, label %1935, label %512

482:                                              ; preds = %1935, %1938
  %483 = phi i64 [ 0, %1935 ], [ %1940, %1938 ]
  %484 = phi i64 [ %284, %1935 ], [ %1939, %1938 ]
  %485 = icmp sgt i64 %484, 0
  br i1 %485, label %1938, label %486

486:                                              ; preds = %482
  %487 = icmp slt i64 %479, 0
  %488 = select i1 %487, i64 %213, i64 0
  %489 = add i64 %479, %488
  %490 = select i1 %487, i64 %215, i64 0
  %491 = mul i64 %489, %215
  %492 = getelementptr double, ptr %216, i64 %491
  %493 = getelementptr double, ptr %492, i64 %479
  %494 = getelementptr double, ptr %493, i64 %490
  %495 = load double, ptr %494, align 8, !noalias !5
  %496 = fdiv double 0x400D1A48D83E731D, %417
  %497 = fadd double %495, %496
  store double %497, ptr %494, align 8, !noalias !5
  %498 = select i1 %487, i64 %220, i64 0
  %499 = add i64 %479, %498
  %500 = select i1 %487, i64 %222, i64 0
  %501 = mul i64 %499, %222
  %502 = getelementptr { double, double }, ptr %223, i64 %501
  %503 = getelementptr { double, double }, ptr %502, i64 %479
  %504 = getelementptr { double, double }, ptr %503, i64 %500
  %505 = load double, ptr %504, align 8, !noalias !5
  %506 = getelementptr inbounds nuw i8, ptr %504, i64 8
  %507 = load double, ptr %506, align 8, !noalias !5
  %508 = fdiv double 0x400572DB93E0C672, %417
  %509 = fdiv double 0xC0086747F2C3FCB6, %417
  %510 = fadd double %505, %508
  %511 = fadd double %507, %509
  store double %510, ptr %504, align 8, !noalias !5
  store double %511, ptr %506, align 8, !noalias !5
  br label %478

512:                                              ; preds = %478
  %513 = call i64 @llvm.smax.i64(i64 %213, i64 0)
  br label %514

514:                                              ; preds = %538, %512
  %515 = phi i64 [ 0, %512 ], [ %551, %538 ]
  %516 = phi i64 [ %513, %512 ], [ %550, %538 ]
  %517 = icmp sgt i64 %516, 0
  br i1 %517, label %549, label %620

518:                                              ; preds = %564, %549
  %519 = phi i64 [ %551, %549 ], [ %566, %564 ]
  %520 = phi i64 [ %563, %549 ], [ %565, %564 ]
  %521 = phi double [ %561, %549 ], [ %577, %564 ]
  %522 = phi i64 [ %515, %549 ], [ %578, %564 ]
  %523 = icmp sgt i64 %520, 0
  br i1 %523, label %564, label %524

524:                                              ; preds = %518
  %525 = select i1 %552, i64 %227, i64 0
  %526 = getelementptr i64, ptr %228, i64 %515
  %527 = getelementptr i64, ptr %526, i64 %525
  store i64 %522, ptr %527, align 8, !noalias !34
  %528 = fcmp ueq double %521, 0.000000e+00
  br i1 %528, label %780, label %529

529:                                              ; preds = %524
  %530 = icmp eq i64 %522, %515
  br i1 %530, label %535, label %531

531:                                              ; preds = %529, %579
  %532 = phi i64 [ %581, %579 ], [ 0, %529 ]
  %533 = phi i64 [ %580, %579 ], [ %513, %529 ]
  %534 = icmp sgt i64 %533, 0
  br i1 %534, label %579, label %535

535:                                              ; preds = %531, %529
  %536 = load double, ptr %559, align 8, !noalias !34
  %537 = fdiv double 1.000000e+00, %536
  br label %538

538:                                              ; preds = %548, %535
  %539 = phi i64 [ %551, %535 ], [ %597, %548 ]
  %540 = phi i64 [ %563, %535 ], [ %596, %548 ]
  %541 = icmp sgt i64 %540, 0
  br i1 %541, label %595, label %514

542:                                              ; preds = %595
  %543 = fmul double %605, %537
  store double %543, ptr %604, align 8, !noalias !34
  br label %544

544:                                              ; preds = %607, %542
  %545 = phi i64 [ %551, %542 ], [ %609, %607 ]
  %546 = phi i64 [ %563, %542 ], [ %608, %607 ]
  %547 = icmp sgt i64 %546, 0
  br i1 %547, label %607, label %548

548:                                              ; preds = %595, %544
  br label %538

549:                                              ; preds = %514
  %550 = add nsw i64 %516, -1
  %551 = add i64 %515, 1
  %552 = icmp slt i64 %515, 0
  %553 = select i1 %552, i64 %213, i64 0
  %554 = add i64 %515, %553
  %555 = select i1 %552, i64 %215, i64 0
  %556 = mul i64 %554, %215
  %557 = getelementptr double, ptr %216, i64 %556
  %558 = getelementptr double, ptr %557, i64 %515
  %559 = getelementptr double, ptr %558, i64 %555
  %560 = load double, ptr %559, align 8, !noalias !34
  %561 = call double @llvm.fabs.f64(double %560)
  %562 = sub i64 %213, %551
  %563 = call i64 @llvm.smax.i64(i64 %562, i64 0)
  br label %518

564:                                              ; preds = %518
  %565 = add nsw i64 %520, -1
  %566 = add i64 %519, 1
  %567 = icmp slt i64 %519, 0
  %568 = select i1 %567, i64 %213, i64 0
  %569 = add i64 %519, %568
  %570 = mul i64 %569, %215
  %571 = getelementptr double, ptr %216, i64 %570
  %572 = getelementptr double, ptr %571, i64 %515
  %573 = getelementptr double, ptr %572, i64 %555
  %574 = load double, ptr %573, align 8, !noalias !34
  %575 = call double @llvm.fabs.f64(double %574)
  %576 = fcmp ogt double %575, %521
  %577 = select i1 %576, double %575, double %521
  %578 = select i1 %576, i64 %519, i64 %522
  br label %518

579:                                              ; preds = %531
  %580 = add nsw i64 %533, -1
  %581 = add i64 %532, 1
  %582 = icmp slt i64 %522, 0
  %583 = select i1 %582, i64 %213, i64 0
  %584 = add i64 %522, %583
  %585 = icmp slt i64 %532, 0
  %586 = select i1 %585, i64 %215, i64 0
  %587 = mul i64 %584, %215
  %588 = getelementptr double, ptr %216, i64 %587
  %589 = getelementptr double, ptr %588, i64 %532
  %590 = getelementptr double, ptr %589, i64 %586
  %591 = load double, ptr %590, align 8, !noalias !34
  %592 = getelementptr double, ptr %557, i64 %532
  %593 = getelementptr double, ptr %592, i64 %586
  %594 = load double, ptr %593, align 8, !noalias !34
  store double %591, ptr %593, align 8, !noalias !34
  store double %594, ptr %590, align 8, !noalias !34
  br label %531

595:                                              ; preds = %538
  %596 = add nsw i64 %540, -1
  %597 = add i64 %539, 1
  %598 = icmp slt i64 %539, 0
  %599 = select i1 %598, i64 %213, i64 0
  %600 = add i64 %539, %599
  %601 = mul i64 %600, %215
  %602 = getelementptr double, ptr %216, i64 %601
  %603 = getelementptr double, ptr %602, i64 %515
  %604 = getelementptr double, ptr %603, i64 %555
  %605 = load double, ptr %604, align 8, !noalias !34
  %606 = fcmp une double %605, 0.000000e+00
  br i1 %606, label %542, label %548

607:                                              ; preds = %544
  %608 = add nsw i64 %546, -1
  %609 = add i64 %545, 1
  %610 = icmp slt i64 %545, 0
  %611 = select i1 %610, i64 %215, i64 0
  %612 = getelementptr double, ptr %602, i64 %545
  %613 = getelementptr double, ptr %612, i64 %611
  %614 = load double, ptr %613, align 8, !noalias !34
  %615 = getelementptr double, ptr %557, i64 %545
  %616 = getelementptr double, ptr %615, i64 %611
  %617 = load double, ptr %616, align 8, !noalias !34
  %618 = fmul double %543, %617
  %619 = fsub double %614, %618
  store double %619, ptr %613, align 8, !noalias !34
  br label %544

620:                                              ; preds = %514
  %621 = call i64 @llvm.smax.i64(i64 %220, i64 0)
  br label %622

622:                                              ; preds = %670, %620
  %623 = phi i64 [ 0, %620 ], [ %688, %670 ]
  %624 = phi i64 [ %621, %620 ], [ %687, %670 ]
  %625 = icmp sgt i64 %624, 0
  br i1 %625, label %686, label %779

626:                                              ; preds = %703, %686
  %627 = phi i64 [ %688, %686 ], [ %715, %703 ]
  %628 = phi i64 [ %702, %686 ], [ %716, %703 ]
  %629 = phi double [ %700, %686 ], [ %718, %703 ]
  %630 = phi i64 [ %623, %686 ], [ %719, %703 ]
  %631 = icmp sgt i64 %628, 0
  br i1 %631, label %703, label %632

632:                                              ; preds = %626
  %633 = select i1 %689, i64 %232, i64 0
  %634 = getelementptr i64, ptr %233, i64 %623
  %635 = getelementptr i64, ptr %634, i64 %633
  store i64 %630, ptr %635, align 8, !noalias !37
  %636 = fcmp ueq double %629, 0.000000e+00
  br i1 %636, label %780, label %637

637:                                              ; preds = %632
  %638 = icmp eq i64 %630, %623
  br i1 %638, label %643, label %639

639:                                              ; preds = %637, %720
  %640 = phi i64 [ %722, %720 ], [ 0, %637 ]
  %641 = phi i64 [ %721, %720 ], [ %621, %637 ]
  %642 = icmp sgt i64 %641, 0
  br i1 %642, label %720, label %643

643:                                              ; preds = %639, %637
  %644 = load double, ptr %696, align 8, !noalias !37
  %645 = load double, ptr %698, align 8, !noalias !37
  %646 = call double @llvm.fabs.f64(double %644)
  %647 = call double @llvm.fabs.f64(double %645)
  %648 = fcmp ult double %646, %647
  br i1 %648, label %658, label %649

649:                                              ; preds = %643
  %650 = fdiv double %645, %644
  %651 = fmul double %645, %650
  %652 = fadd double %644, %651
  %653 = fmul double %650, 0.000000e+00
  %654 = fadd double %653, 1.000000e+00
  %655 = fdiv double %654, %652
  %656 = fsub double 0.000000e+00, %650
  %657 = fdiv double %656, %652
  br label %667

658:                                              ; preds = %643
  %659 = fdiv double %644, %645
  %660 = fmul double %644, %659
  %661 = fadd double %660, %645
  %662 = fadd double %659, 0.000000e+00
  %663 = fdiv double %662, %661
  %664 = fmul double %659, 0.000000e+00
  %665 = fadd double %664, -1.000000e+00
  %666 = fdiv double %665, %661
  br label %667

667:                                              ; preds = %658, %649
  %668 = phi double [ %657, %649 ], [ %666, %658 ]
  %669 = phi double [ %655, %649 ], [ %663, %658 ]
  br label %670

670:                                              ; preds = %685, %667
  %671 = phi i64 [ %688, %667 ], [ %742, %685 ]
  %672 = phi i64 [ %702, %667 ], [ %741, %685 ]
  %673 = icmp sgt i64 %672, 0
  br i1 %673, label %740, label %622

674:                                              ; preds = %740
  %675 = fmul double %750, %668
  %676 = fmul double %752, %669
  %677 = fadd double %675, %676
  %678 = fmul double %750, %669
  %679 = fmul double %752, %668
  %680 = fsub double %678, %679
  store double %680, ptr %749, align 8, !noalias !37
  store double %677, ptr %751, align 8, !noalias !37
  br label %681

681:                                              ; preds = %756, %674
  %682 = phi i64 [ %688, %674 ], [ %775, %756 ]
  %683 = phi i64 [ %702, %674 ], [ %776, %756 ]
  %684 = icmp sgt i64 %683, 0
  br i1 %684, label %756, label %685

685:                                              ; preds = %740, %681
  br label %670

686:                                              ; preds = %622
  %687 = add nsw i64 %624, -1
  %688 = add i64 %623, 1
  %689 = icmp slt i64 %623, 0
  %690 = select i1 %689, i64 %220, i64 0
  %691 = add i64 %623, %690
  %692 = select i1 %689, i64 %222, i64 0
  %693 = mul i64 %691, %222
  %694 = getelementptr { double, double }, ptr %223, i64 %693
  %695 = getelementptr { double, double }, ptr %694, i64 %623
  %696 = getelementptr { double, double }, ptr %695, i64 %692
  %697 = load double, ptr %696, align 8, !noalias !37
  %698 = getelementptr inbounds nuw i8, ptr %696, i64 8
  %699 = load double, ptr %698, align 8, !noalias !37
  %700 = call double @hypot(double %697, double %699) #3, !noalias !41
  %701 = sub i64 %220, %688
  %702 = call i64 @llvm.smax.i64(i64 %701, i64 0)
  br label %626

703:                                              ; preds = %626
  %704 = icmp slt i64 %627, 0
  %705 = select i1 %704, i64 %220, i64 0
  %706 = add i64 %627, %705
  %707 = mul i64 %706, %222
  %708 = getelementptr { double, double }, ptr %223, i64 %707
  %709 = getelementptr { double, double }, ptr %708, i64 %623
  %710 = getelementptr { double, double }, ptr %709, i64 %692
  %711 = load double, ptr %710, align 8, !noalias !37
  %712 = getelementptr inbounds nuw i8, ptr %710, i64 8
  %713 = load double, ptr %712, align 8, !noalias !37
  %714 = call double @hypot(double %711, double %713) #3, !noalias !47
  %715 = add i64 %627, 1
  %716 = add nsw i64 %628, -1
  %717 = fcmp ogt double %714, %629
  %718 = select i1 %717, double %714, double %629
  %719 = select i1 %717, i64 %627, i64 %630
  br label %626

720:                                              ; preds = %639
  %721 = add nsw i64 %641, -1
  %722 = add i64 %640, 1
  %723 = icmp slt i64 %630, 0
  %724 = select i1 %723, i64 %220, i64 0
  %725 = add i64 %630, %724
  %726 = icmp slt i64 %640, 0
  %727 = select i1 %726, i64 %222, i64 0
  %728 = mul i64 %725, %222
  %729 = getelementptr { double, double }, ptr %223, i64 %728
  %730 = getelementptr { double, double }, ptr %729, i64 %640
  %731 = getelementptr { double, double }, ptr %730, i64 %727
  %732 = load double, ptr %731, align 8, !noalias !37
  %733 = getelementptr inbounds nuw i8, ptr %731, i64 8
  %734 = load double, ptr %733, align 8, !noalias !37
  %735 = getelementptr { double, double }, ptr %694, i64 %640
  %736 = getelementptr { double, double }, ptr %735, i64 %727
  %737 = load double, ptr %736, align 8, !noalias !37
  %738 = getelementptr inbounds nuw i8, ptr %736, i64 8
  %739 = load double, ptr %738, align 8, !noalias !37
  store double %732, ptr %736, align 8, !noalias !37
  store double %734, ptr %738, align 8, !noalias !37
  store double %737, ptr %731, align 8, !noalias !37
  store double %739, ptr %733, align 8, !noalias !37
  br label %639

740:                                              ; preds = %670
  %741 = add nsw i64 %672, -1
  %742 = add i64 %671, 1
  %743 = icmp slt i64 %671, 0
  %744 = select i1 %743, i64 %220, i64 0
  %745 = add i64 %671, %744
  %746 = mul i64 %745, %222
  %747 = getelementptr { double, double }, ptr %223, i64 %746
  %748 = getelementptr { double, double }, ptr %747, i64 %623
  %749 = getelementptr { double, double }, ptr %748, i64 %692
  %750 = load double, ptr %749, align 8, !noalias !37
  %751 = getelementptr inbounds nuw i8, ptr %749, i64 8
  %752 = load double, ptr %751, align 8, !noalias !37
  %753 = fcmp une double %750, 0.000000e+00
  %754 = fcmp une double %752, 0.000000e+00
  %755 = or i1 %753, %754
  br i1 %755, label %674, label %685

756:                                              ; preds = %681
  %757 = icmp slt i64 %682, 0
  %758 = select i1 %757, i64 %222, i64 0
  %759 = getelementptr { double, double }, ptr %747, i64 %682
  %760 = getelementptr { double, double }, ptr %759, i64 %758
  %761 = load double, ptr %760, align 8, !noalias !37
  %762 = getelementptr inbounds nuw i8, ptr %760, i64 8
  %763 = load double, ptr %762, align 8, !noalias !37
  %764 = getelementptr { double, double }, ptr %694, i64 %682
  %765 = getelementptr { double, double }, ptr %764, i64 %758
  %766 = load double, ptr %765, align 8, !noalias !37
  %767 = getelementptr inbounds nuw i8, ptr %765, i64 8
  %768 = load double, ptr %767, align 8, !noalias !37
  %769 = fmul double %680, %768
  %770 = fmul double %677, %766
  %771 = fadd double %769, %770
  %772 = fmul double %680, %766
  %773 = fmul double %677, %768
  %774 = fsub double %772, %773
  %775 = add i64 %682, 1
  %776 = add nsw i64 %683, -1
  %777 = fsub double %761, %774
  %778 = fsub double %763, %771
  store double %777, ptr %760, align 8, !noalias !37
  store double %778, ptr %762, align 8, !noalias !37
  br label %681

779:                                              ; preds = %622
  store i64 1, ptr %468, align 8, !noalias !5
  store double %417, ptr %201, align 8, !noalias !5
  br label %788

780:                                              ; preds = %524, %632
  %781 = load i64, ptr %400, align 8, !noalias !5
  %782 = add nsw i64 %781, 1
  %783 = fmul double %417, 5.000000e-01
  %784 = getelementptr i8, ptr %112, i64 72
  store i64 4, ptr %784, align 8, !noalias !5
  store i64 %782, ptr %400, align 8, !noalias !5
  %785 = getelementptr i8, ptr %198, i64 16
  %786 = load i64, ptr %785, align 8, !noalias !5
  %787 = sub nsw i64 1, %786
  store i64 %787, ptr %425, align 8, !noalias !5
  store i64 0, ptr %468, align 8, !noalias !5
  br label %1788

788:                                              ; preds = %779, %471
  %789 = getelementptr i8, ptr %201, i64 8
  %790 = load double, ptr %789, align 8, !noalias !5
  br label %791

791:                                              ; preds = %806, %788
  %792 = phi i64 [ 0, %788 ], [ %1970, %806 ]
  %793 = phi i64 [ 3, %788 ], [ %1969, %806 ]
  %794 = icmp sgt i64 %793, 0
  br i1 %794, label %1968, label %860

795:                                              ; preds = %1968
  %796 = icmp slt i64 %792, 0
  %797 = add i64 %792, 3
  %798 = select i1 %796, i64 %797, i64 %792
  %799 = getelementptr double, ptr @0, i64 %798
  %800 = load double, ptr %799, align 8, !noalias !5
  %801 = fmul double %800, %417
  %802 = fdiv double %801, %790
  %803 = fadd double %802, 1.000000e+00
  br label %804

804:                                              ; preds = %1968, %795
  %805 = phi double [ %803, %795 ], [ 0.000000e+00, %1968 ]
  br label %806

806:                                              ; preds = %804, %850, %810
  %807 = phi i64 [ 0, %804 ], [ %1974, %810 ], [ %1974, %850 ]
  %808 = phi i64 [ %284, %804 ], [ %1973, %810 ], [ %1973, %850 ]
  %809 = icmp sgt i64 %808, 0
  br i1 %809, label %1972, label %791

810:                                              ; preds = %1972
  %811 = fsub double 1.000000e+00, %805
  %812 = icmp slt i64 %807, 0
  %813 = select i1 %812, i64 %258, i64 0
  %814 = shl i64 %258, 4
  %815 = getelementptr i8, ptr %259, i64 %814
  %816 = getelementptr double, ptr %815, i64 %807
  %817 = getelementptr double, ptr %816, i64 %813
  %818 = load double, ptr %817, align 8, !noalias !5
  %819 = mul i64 %258, 24
  %820 = getelementptr i8, ptr %259, i64 %819
  %821 = getelementptr double, ptr %820, i64 %807
  %822 = getelementptr double, ptr %821, i64 %813
  %823 = load double, ptr %822, align 8, !noalias !5
  %824 = fmul double %805, %823
  %825 = fadd double %818, %824
  %826 = fmul double %811, %825
  %827 = getelementptr double, ptr %259, i64 %807
  %828 = getelementptr double, ptr %827, i64 %813
  %829 = load double, ptr %828, align 8, !noalias !5
  %830 = getelementptr double, ptr %259, i64 %258
  %831 = getelementptr double, ptr %830, i64 %807
  %832 = getelementptr double, ptr %831, i64 %813
  %833 = load double, ptr %832, align 8, !noalias !5
  %834 = fadd double %833, %826
  %835 = fmul double %805, %834
  %836 = fadd double %829, %835
  %837 = select i1 %812, i64 %66, i64 0
  %838 = getelementptr double, ptr %67, i64 %807
  %839 = getelementptr double, ptr %838, i64 %837
  %840 = load double, ptr %839, align 8, !noalias !5
  %841 = fsub double %836, %840
  %842 = icmp slt i64 %792, 0
  %843 = select i1 %842, i64 %237, i64 0
  %844 = add i64 %792, %843
  %845 = select i1 %812, i64 %239, i64 0
  %846 = mul i64 %844, %239
  %847 = getelementptr double, ptr %240, i64 %846
  %848 = getelementptr double, ptr %847, i64 %807
  %849 = getelementptr double, ptr %848, i64 %845
  store double %841, ptr %849, align 8, !noalias !5
  br label %806

850:                                              ; preds = %1972
  %851 = icmp slt i64 %792, 0
  %852 = select i1 %851, i64 %237, i64 0
  %853 = add i64 %792, %852
  %854 = icmp slt i64 %807, 0
  %855 = select i1 %854, i64 %239, i64 0
  %856 = mul i64 %853, %239
  %857 = getelementptr double, ptr %240, i64 %856
  %858 = getelementptr double, ptr %857, i64 %807
  %859 = getelementptr double, ptr %858, i64 %855
  store double 0.000000e+00, ptr %859, align 8, !noalias !5
  br label %806

860:                                              ; preds = %791, %864
  %861 = phi i64 [ %1977, %864 ], [ 0, %791 ]
  %862 = phi i64 [ %1976, %864 ], [ 3, %791 ]
  %863 = icmp sgt i64 %862, 0
  br i1 %863, label %1975, label %868

864:                                              ; preds = %1975, %1978
  %865 = phi i64 [ 0, %1975 ], [ %1980, %1978 ]
  %866 = phi i64 [ %284, %1975 ], [ %1979, %1978 ]
  %867 = icmp sgt i64 %866, 0
  br i1 %867, label %1978, label %860

868:                                              ; preds = %860
  store ptr null, ptr %14, align 8, !noalias !53
  %869 = load i64, ptr %118, align 8, !noalias !53
  br label %870

870:                                              ; preds = %1043, %868
  %871 = phi i64 [ 0, %868 ], [ %1048, %1043 ]
  %872 = phi i64 [ 6, %868 ], [ %1049, %1043 ]
  %873 = phi double [ -1.000000e+00, %868 ], [ %985, %1043 ]
  %874 = phi double [ 0.000000e+00, %868 ], [ %1026, %1043 ]
  %875 = icmp sgt i64 %872, 0
  br i1 %875, label %1044, label %1047

876:                                              ; preds = %1077, %1047
  %877 = phi i64 [ %1054, %1077 ], [ 0, %1047 ]
  %878 = phi i64 [ %1053, %1077 ], [ 3, %1047 ]
  %879 = icmp sgt i64 %878, 0
  br i1 %879, label %1052, label %914

880:                                              ; preds = %1056, %1052
  %881 = phi i64 [ 0, %1052 ], [ %1058, %1056 ]
  %882 = phi i64 [ %1055, %1052 ], [ %1057, %1056 ]
  %883 = icmp sgt i64 %882, 0
  br i1 %883, label %1056, label %884

884:                                              ; preds = %880
  %885 = getelementptr i8, ptr %112, i64 24
  %886 = load i64, ptr %885, align 8, !noalias !53
  %887 = add nsw i64 %886, 1
  store i64 %887, ptr %885, align 8, !noalias !53
  %888 = icmp slt i64 %877, 0
  %889 = add i64 %877, 3
  %890 = select i1 %888, i64 %889, i64 %877
  %891 = getelementptr double, ptr @4, i64 %890
  %892 = load double, ptr %891, align 8, !noalias !53
  %893 = fmul double %417, %892
  %894 = fadd double %392, %893
  %895 = mul nsw i64 %877, %869
  %896 = shl i64 %895, 3
  %897 = add i64 %896, %249
  store ptr null, ptr %12, align 8, !noalias !57
  store ptr null, ptr %13, align 8, !noalias !57
  store double %894, ptr %35, align 8, !noalias !57
  %898 = icmp sgt i64 %47, 0
  br i1 %898, label %899, label %902

899:                                              ; preds = %884
  store ptr null, ptr %12, align 8, !noalias !57
  %900 = call fastcc i32 @_sample(ptr nonnull %12, ptr %40, i64 %39, ptr %50, i64 %47, i64 %49, ptr %55, i64 %54, ptr %62, i64 %59, i64 %61, double %894) #3
  switch i32 %900, label %901 [
    i32 -2, label %902
    i32 0, label %902
  ], !prof !25

901:                                              ; preds = %899
  br label %902

902:                                              ; preds = %899, %899, %884, %901
  %903 = phi i32 [ %900, %901 ], [ 0, %884 ], [ 0, %899 ], [ 0, %899 ]
  switch i32 %903, label %909 [
    i32 -2, label %904
    i32 0, label %904
  ], !prof !25

904:                                              ; preds = %902, %902
  %905 = load i64, ptr %32, align 8, !noalias !64
  %906 = inttoptr i64 %905 to ptr
  %907 = inttoptr i64 %897 to ptr
  %908 = call i32 %906(ptr nonnull %35, ptr %77, ptr %40, ptr %43, ptr %907) #3, !noalias !64
  br label %909

909:                                              ; preds = %902, %904
  %910 = phi i32 [ %908, %904 ], [ 0, %902 ]
  %911 = phi i32 [ 0, %904 ], [ %903, %902 ]
  switch i32 %911, label %1368 [
    i32 -2, label %1077
    i32 0, label %1077
  ], !prof !25

912:                                              ; preds = %1077
  %913 = sext i32 %910 to i64
  br label %1368

914:                                              ; preds = %876
  %915 = call i64 @llvm.smax.i64(i64 %869, i64 0)
  br label %916

916:                                              ; preds = %920, %914
  %917 = phi i64 [ 0, %914 ], [ %921, %920 ]
  %918 = phi i64 [ %915, %914 ], [ %922, %920 ]
  %919 = icmp sgt i64 %918, 0
  br i1 %919, label %1079, label %974

920:                                              ; preds = %1079
  %921 = add i64 %917, 1
  %922 = add nsw i64 %918, -1
  %923 = fmul double %1084, 0x4010B70201A79C46
  %924 = fmul double %1088, 0x3FD4F8C15DA84E86
  %925 = fadd double %923, %924
  %926 = fmul double %1094, 0x3FE0BF7FF59D56EF
  %927 = fadd double %925, %926
  %928 = fdiv double 0x400D1A48D83E731D, %417
  %929 = select i1 %1080, i64 %246, i64 0
  %930 = getelementptr double, ptr %247, i64 %917
  %931 = getelementptr double, ptr %930, i64 %929
  %932 = load double, ptr %931, align 8, !noalias !53
  %933 = fmul double %928, %932
  %934 = fsub double %927, %933
  %935 = select i1 %1080, i64 %263, i64 0
  %936 = getelementptr double, ptr %264, i64 %917
  %937 = getelementptr double, ptr %936, i64 %935
  store double %934, ptr %937, align 8, !noalias !53
  %938 = load double, ptr %1083, align 8, !noalias !53
  %939 = fmul double %938, 0xC010B70201A79C46
  %940 = load double, ptr %1087, align 8, !noalias !53
  %941 = fmul double %940, 0xBFD4F8C15DA84E86
  %942 = fadd double %939, %941
  %943 = load double, ptr %1093, align 8, !noalias !53
  %944 = fmul double %943, 0x3FDE810014C55221
  %945 = fadd double %942, %944
  %946 = fmul double %938, 0x3FE017885A24A7F2
  %947 = fmul double %940, 0xC004934E6FCAA598
  %948 = fadd double %946, %947
  %949 = fmul double %943, 0x3FE312C0CF7BDFD1
  %950 = fadd double %948, %949
  %951 = fdiv double 0x400572DB93E0C672, %417
  %952 = fdiv double 0xC0086747F2C3FCB6, %417
  %953 = getelementptr double, ptr %247, i64 %246
  %954 = getelementptr double, ptr %953, i64 %917
  %955 = getelementptr double, ptr %954, i64 %929
  %956 = load double, ptr %955, align 8, !noalias !53
  %957 = shl i64 %246, 4
  %958 = getelementptr i8, ptr %247, i64 %957
  %959 = getelementptr double, ptr %958, i64 %917
  %960 = getelementptr double, ptr %959, i64 %929
  %961 = load double, ptr %960, align 8, !noalias !53
  %962 = fmul double %951, %961
  %963 = fmul double %952, %956
  %964 = fadd double %962, %963
  %965 = fmul double %951, %956
  %966 = fmul double %952, %961
  %967 = fsub double %965, %966
  %968 = fsub double %945, %967
  %969 = fsub double %950, %964
  %970 = select i1 %1080, i64 %268, i64 0
  %971 = getelementptr { double, double }, ptr %269, i64 %917
  %972 = getelementptr { double, double }, ptr %971, i64 %970
  store double %968, ptr %972, align 8, !noalias !53
  %973 = getelementptr inbounds nuw i8, ptr %972, i64 8
  store double %969, ptr %973, align 8, !noalias !53
  br label %916

974:                                              ; preds = %916
  store ptr null, ptr %14, align 8, !noalias !53
  %975 = call fastcc i32 @solve(ptr nonnull %14, ptr %216, i64 %213, i64 %215, ptr %228, i64 %227, ptr %264, i64 %263) #3, !noalias !53
  switch i32 %975, label %1368 [
    i32 -2, label %1098
    i32 0, label %1098
  ], !prof !25

976:                                              ; preds = %1133, %1268
  %977 = phi i64 [ %1270, %1268 ], [ 0, %1133 ]
  %978 = phi i64 [ %1269, %1268 ], [ %915, %1133 ]
  %979 = phi double [ %1305, %1268 ], [ 0.000000e+00, %1133 ]
  %980 = icmp sgt i64 %978, 0
  br i1 %980, label %1268, label %981

981:                                              ; preds = %976
  %982 = mul nsw i64 %869, 3
  %983 = sitofp i64 %982 to double
  %984 = fdiv double %979, %983
  %985 = call double @sqrt(double %984), !noalias !53
  %986 = fcmp ogt double %873, 0.000000e+00
  br i1 %986, label %987, label %1025

987:                                              ; preds = %981
  %988 = fdiv double %985, %873
  %989 = sub nsw i64 5, %1051
  %990 = icmp sgt i64 %1051, 5
  %991 = add nsw i64 %1051, -5
  %992 = select i1 %990, i64 %991, i64 %989
  %993 = icmp samesign ugt i64 %992, 65536
  br i1 %993, label %994, label %997

994:                                              ; preds = %987
  %995 = sitofp i64 %989 to double
  %996 = call double @llvm.pow.f64(double %988, double %995)
  br label %1016

997:                                              ; preds = %987
  %998 = icmp eq i64 %992, 0
  br i1 %998, label %1010, label %999

999:                                              ; preds = %999, %997
  %1000 = phi double [ %1006, %999 ], [ 1.000000e+00, %997 ]
  %1001 = phi double [ %1008, %999 ], [ %988, %997 ]
  %1002 = phi i64 [ %1007, %999 ], [ %992, %997 ]
  %1003 = and i64 %1002, 1
  %1004 = icmp eq i64 %1003, 0
  %1005 = fmul double %1000, %1001
  %1006 = select i1 %1004, double %1000, double %1005
  %1007 = lshr i64 %1002, 1
  %1008 = fmul double %1001, %1001
  %1009 = icmp eq i64 %1007, 0
  br i1 %1009, label %1010, label %999

1010:                                             ; preds = %999, %997
  %1011 = phi double [ %1006, %999 ], [ 1.000000e+00, %997 ]
  br i1 %990, label %1012, label %1016

1012:                                             ; preds = %1010
  %1013 = fcmp oeq double %1011, 0.000000e+00
  br i1 %1013, label %1016, label %1014, !prof !0

1014:                                             ; preds = %1012
  %1015 = fdiv double 1.000000e+00, %1011
  br label %1016

1016:                                             ; preds = %1012, %1010, %994, %1014
  %1017 = phi double [ 0.000000e+00, %1012 ], [ %996, %994 ], [ %1011, %1010 ], [ %1015, %1014 ]
  %1018 = phi i1 [ false, %1012 ], [ true, %994 ], [ true, %1010 ], [ true, %1014 ]
  %1019 = phi i32 [ 1, %1012 ], [ 0, %994 ], [ 0, %1010 ], [ 0, %1014 ]
  br i1 %1018, label %1306, label %1368, !prof !65

1020:                                             ; preds = %1306
  %1021 = fsub double 1.000000e+00, %988
  %1022 = fdiv double %1017, %1021
  %1023 = fmul double %1022, %985
  %1024 = fcmp ogt double %1023, %298
  br i1 %1024, label %1368, label %1025

1025:                                             ; preds = %1020, %981
  %1026 = phi double [ %988, %1020 ], [ %874, %981 ]
  br label %1027

1027:                                             ; preds = %1031, %1025
  %1028 = phi i64 [ 0, %1025 ], [ %1310, %1031 ]
  %1029 = phi i64 [ %915, %1025 ], [ %1309, %1031 ]
  %1030 = icmp sgt i64 %1029, 0
  br i1 %1030, label %1308, label %1035

1031:                                             ; preds = %1338, %1308
  %1032 = phi i64 [ 0, %1308 ], [ %1340, %1338 ]
  %1033 = phi i64 [ 3, %1308 ], [ %1339, %1338 ]
  %1034 = icmp sgt i64 %1033, 0
  br i1 %1034, label %1338, label %1027

1035:                                             ; preds = %1027
  %1036 = fcmp oeq double %985, 0.000000e+00
  br i1 %1036, label %1368, label %1037

1037:                                             ; preds = %1035
  br i1 %986, label %1038, label %1043

1038:                                             ; preds = %1037
  %1039 = fsub double 1.000000e+00, %1026
  %1040 = fdiv double %1026, %1039
  %1041 = fmul double %1040, %985
  %1042 = fcmp olt double %1041, %298
  br i1 %1042, label %1368, label %1043

1043:                                             ; preds = %1038, %1037
  br label %870

1044:                                             ; preds = %870
  %1045 = add nsw i64 %872, -1
  %1046 = add i64 %871, 1
  br label %1047

1047:                                             ; preds = %1044, %870
  %1048 = phi i64 [ %1046, %1044 ], [ %871, %870 ]
  %1049 = phi i64 [ %1045, %1044 ], [ %872, %870 ]
  %1050 = phi i64 [ %1046, %1044 ], [ 1, %870 ]
  %1051 = phi i64 [ %871, %1044 ], [ 0, %870 ]
  br i1 %875, label %876, label %1368

1052:                                             ; preds = %876
  %1053 = add nsw i64 %878, -1
  %1054 = add i64 %877, 1
  %1055 = call i64 @llvm.smax.i64(i64 %869, i64 0)
  br label %880

1056:                                             ; preds = %880
  %1057 = add nsw i64 %882, -1
  %1058 = add i64 %881, 1
  %1059 = icmp slt i64 %881, 0
  %1060 = select i1 %1059, i64 %66, i64 0
  %1061 = getelementptr double, ptr %67, i64 %881
  %1062 = getelementptr double, ptr %1061, i64 %1060
  %1063 = load double, ptr %1062, align 8, !noalias !53
  %1064 = icmp slt i64 %877, 0
  %1065 = select i1 %1064, i64 %237, i64 0
  %1066 = add i64 %877, %1065
  %1067 = select i1 %1059, i64 %239, i64 0
  %1068 = mul i64 %1066, %239
  %1069 = getelementptr double, ptr %240, i64 %1068
  %1070 = getelementptr double, ptr %1069, i64 %881
  %1071 = getelementptr double, ptr %1070, i64 %1067
  %1072 = load double, ptr %1071, align 8, !noalias !53
  %1073 = fadd double %1063, %1072
  %1074 = select i1 %1059, i64 %76, i64 0
  %1075 = getelementptr double, ptr %77, i64 %881
  %1076 = getelementptr double, ptr %1075, i64 %1074
  store double %1073, ptr %1076, align 8, !noalias !53
  br label %880

1077:                                             ; preds = %909, %909
  %1078 = icmp eq i32 %910, 0
  br i1 %1078, label %876, label %912

1079:                                             ; preds = %916
  %1080 = icmp slt i64 %917, 0
  %1081 = select i1 %1080, i64 %251, i64 0
  %1082 = getelementptr double, ptr %252, i64 %917
  %1083 = getelementptr double, ptr %1082, i64 %1081
  %1084 = load double, ptr %1083, align 8, !noalias !53
  %1085 = getelementptr double, ptr %252, i64 %251
  %1086 = getelementptr double, ptr %1085, i64 %917
  %1087 = getelementptr double, ptr %1086, i64 %1081
  %1088 = load double, ptr %1087, align 8, !noalias !53
  %1089 = fadd double %1084, %1088
  %1090 = shl i64 %251, 4
  %1091 = getelementptr i8, ptr %252, i64 %1090
  %1092 = getelementptr double, ptr %1091, i64 %917
  %1093 = getelementptr double, ptr %1092, i64 %1081
  %1094 = load double, ptr %1093, align 8, !noalias !53
  %1095 = fadd double %1089, %1094
  %1096 = fsub double %1095, %1095
  %1097 = fcmp ord double %1096, 0.000000e+00
  br i1 %1097, label %920, label %1368

1098:                                             ; preds = %974, %974
  %1099 = call i64 @llvm.smax.i64(i64 %220, i64 0)
  br label %1100

1100:                                             ; preds = %1118, %1098
  %1101 = phi i64 [ 0, %1098 ], [ %1183, %1118 ]
  %1102 = phi i64 [ %1099, %1098 ], [ %1182, %1118 ]
  %1103 = icmp sgt i64 %1102, 0
  br i1 %1103, label %1181, label %1119

1104:                                             ; preds = %1181
  %1105 = icmp slt i64 %1188, 0
  %1106 = select i1 %1105, i64 %268, i64 0
  %1107 = getelementptr { double, double }, ptr %269, i64 %1188
  %1108 = getelementptr { double, double }, ptr %1107, i64 %1106
  %1109 = load double, ptr %1108, align 8, !noalias !66
  %1110 = getelementptr inbounds nuw i8, ptr %1108, i64 8
  %1111 = load double, ptr %1110, align 8, !noalias !66
  %1112 = select i1 %1184, i64 %268, i64 0
  %1113 = getelementptr { double, double }, ptr %269, i64 %1101
  %1114 = getelementptr { double, double }, ptr %1113, i64 %1112
  %1115 = load double, ptr %1114, align 8, !noalias !66
  %1116 = getelementptr inbounds nuw i8, ptr %1114, i64 8
  %1117 = load double, ptr %1116, align 8, !noalias !66
  store double %1109, ptr %1114, align 8, !noalias !66
  store double %1111, ptr %1116, align 8, !noalias !66
  store double %1115, ptr %1108, align 8, !noalias !66
  store double %1117, ptr %1110, align 8, !noalias !66
  br label %1118

1118:                                             ; preds = %1181, %1104
  br label %1100

1119:                                             ; preds = %1100, %1129
  %1120 = phi i64 [ %1192, %1129 ], [ 0, %1100 ]
  %1121 = phi i64 [ %1191, %1129 ], [ %1099, %1100 ]
  %1122 = icmp sgt i64 %1121, 0
  br i1 %1122, label %1190, label %1130

1123:                                             ; preds = %1201, %1190
  %1124 = phi i64 [ 0, %1190 ], [ %1225, %1201 ]
  %1125 = phi i64 [ %1200, %1190 ], [ %1226, %1201 ]
  %1126 = phi double [ %1199, %1190 ], [ %1228, %1201 ]
  %1127 = phi double [ %1197, %1190 ], [ %1227, %1201 ]
  %1128 = icmp sgt i64 %1125, 0
  br i1 %1128, label %1201, label %1129

1129:                                             ; preds = %1123
  store double %1127, ptr %1196, align 8, !noalias !66
  store double %1126, ptr %1198, align 8, !noalias !66
  br label %1119

1130:                                             ; preds = %1119
  %1131 = icmp ugt i64 %220, -9223372036854775808
  %1132 = select i1 %1131, i64 0, i64 %220
  br label %1133

1133:                                             ; preds = %1178, %1130
  %1134 = phi i64 [ %220, %1130 ], [ %1136, %1178 ]
  %1135 = phi i64 [ %1132, %1130 ], [ %1230, %1178 ]
  %1136 = add i64 %1134, -1
  %1137 = icmp sgt i64 %1135, 0
  br i1 %1137, label %1229, label %976

1138:                                             ; preds = %1240, %1229
  %1139 = phi i64 [ %1134, %1229 ], [ %1264, %1240 ]
  %1140 = phi i64 [ %1239, %1229 ], [ %1265, %1240 ]
  %1141 = phi double [ %1237, %1229 ], [ %1267, %1240 ]
  %1142 = phi double [ %1235, %1229 ], [ %1266, %1240 ]
  %1143 = icmp sgt i64 %1140, 0
  br i1 %1143, label %1240, label %1144

1144:                                             ; preds = %1138
  %1145 = select i1 %1231, i64 %220, i64 0
  %1146 = add i64 %1136, %1145
  %1147 = select i1 %1231, i64 %222, i64 0
  %1148 = mul i64 %1146, %222
  %1149 = getelementptr { double, double }, ptr %223, i64 %1148
  %1150 = getelementptr { double, double }, ptr %1149, i64 %1136
  %1151 = getelementptr { double, double }, ptr %1150, i64 %1147
  %1152 = load double, ptr %1151, align 8, !noalias !66
  %1153 = getelementptr inbounds nuw i8, ptr %1151, i64 8
  %1154 = load double, ptr %1153, align 8, !noalias !66
  %1155 = call double @llvm.fabs.f64(double %1152)
  %1156 = call double @llvm.fabs.f64(double %1154)
  %1157 = fcmp ult double %1155, %1156
  br i1 %1157, label %1168, label %1158

1158:                                             ; preds = %1144
  %1159 = fdiv double %1154, %1152
  %1160 = fmul double %1154, %1159
  %1161 = fadd double %1152, %1160
  %1162 = fmul double %1141, %1159
  %1163 = fadd double %1142, %1162
  %1164 = fdiv double %1163, %1161
  %1165 = fmul double %1142, %1159
  %1166 = fsub double %1141, %1165
  %1167 = fdiv double %1166, %1161
  br label %1178

1168:                                             ; preds = %1144
  %1169 = fdiv double %1152, %1154
  %1170 = fmul double %1152, %1169
  %1171 = fadd double %1170, %1154
  %1172 = fmul double %1142, %1169
  %1173 = fadd double %1172, %1141
  %1174 = fdiv double %1173, %1171
  %1175 = fmul double %1141, %1169
  %1176 = fsub double %1175, %1142
  %1177 = fdiv double %1176, %1171
  br label %1178

1178:                                             ; preds = %1168, %1158
  %1179 = phi double [ %1167, %1158 ], [ %1177, %1168 ]
  %1180 = phi double [ %1164, %1158 ], [ %1174, %1168 ]
  store double %1180, ptr %1234, align 8, !noalias !66
  store double %1179, ptr %1236, align 8, !noalias !66
  br label %1133

1181:                                             ; preds = %1100
  %1182 = add nsw i64 %1102, -1
  %1183 = add i64 %1101, 1
  %1184 = icmp slt i64 %1101, 0
  %1185 = select i1 %1184, i64 %232, i64 0
  %1186 = getelementptr i64, ptr %233, i64 %1101
  %1187 = getelementptr i64, ptr %1186, i64 %1185
  %1188 = load i64, ptr %1187, align 8, !noalias !66
  %1189 = icmp eq i64 %1188, %1101
  br i1 %1189, label %1118, label %1104

1190:                                             ; preds = %1119
  %1191 = add nsw i64 %1121, -1
  %1192 = add i64 %1120, 1
  %1193 = icmp slt i64 %1120, 0
  %1194 = select i1 %1193, i64 %268, i64 0
  %1195 = getelementptr { double, double }, ptr %269, i64 %1120
  %1196 = getelementptr { double, double }, ptr %1195, i64 %1194
  %1197 = load double, ptr %1196, align 8, !noalias !66
  %1198 = getelementptr inbounds nuw i8, ptr %1196, i64 8
  %1199 = load double, ptr %1198, align 8, !noalias !66
  %1200 = call i64 @llvm.smax.i64(i64 %1120, i64 0)
  br label %1123

1201:                                             ; preds = %1123
  %1202 = select i1 %1193, i64 %220, i64 0
  %1203 = add i64 %1120, %1202
  %1204 = icmp slt i64 %1124, 0
  %1205 = select i1 %1204, i64 %222, i64 0
  %1206 = mul i64 %1203, %222
  %1207 = getelementptr { double, double }, ptr %223, i64 %1206
  %1208 = getelementptr { double, double }, ptr %1207, i64 %1124
  %1209 = getelementptr { double, double }, ptr %1208, i64 %1205
  %1210 = load double, ptr %1209, align 8, !noalias !66
  %1211 = getelementptr inbounds nuw i8, ptr %1209, i64 8
  %1212 = load double, ptr %1211, align 8, !noalias !66
  %1213 = select i1 %1204, i64 %268, i64 0
  %1214 = getelementptr { double, double }, ptr %269, i64 %1124
  %1215 = getelementptr { double, double }, ptr %1214, i64 %1213
  %1216 = load double, ptr %1215, align 8, !noalias !66
  %1217 = getelementptr inbounds nuw i8, ptr %1215, i64 8
  %1218 = load double, ptr %1217, align 8, !noalias !66
  %1219 = fmul double %1210, %1218
  %1220 = fmul double %1212, %1216
  %1221 = fadd double %1219, %1220
  %1222 = fmul double %1210, %1216
  %1223 = fmul double %1212, %1218
  %1224 = fsub double %1222, %1223
  %1225 = add i64 %1124, 1
  %1226 = add nsw i64 %1125, -1
  %1227 = fsub double %1127, %1224
  %1228 = fsub double %1126, %1221
  br label %1123

1229:                                             ; preds = %1133
  %1230 = add nsw i64 %1135, -1
  %1231 = icmp slt i64 %1136, 0
  %1232 = select i1 %1231, i64 %268, i64 0
  %1233 = getelementptr { double, double }, ptr %269, i64 %1136
  %1234 = getelementptr { double, double }, ptr %1233, i64 %1232
  %1235 = load double, ptr %1234, align 8, !noalias !66
  %1236 = getelementptr inbounds nuw i8, ptr %1234, i64 8
  %1237 = load double, ptr %1236, align 8, !noalias !66
  %1238 = sub i64 %220, %1134
  %1239 = call i64 @llvm.smax.i64(i64 %1238, i64 0)
  br label %1138

1240:                                             ; preds = %1138
  %1241 = select i1 %1231, i64 %220, i64 0
  %1242 = add i64 %1136, %1241
  %1243 = icmp slt i64 %1139, 0
  %1244 = select i1 %1243, i64 %222, i64 0
  %1245 = mul i64 %1242, %222
  %1246 = getelementptr { double, double }, ptr %223, i64 %1245
  %1247 = getelementptr { double, double }, ptr %1246, i64 %1139
  %1248 = getelementptr { double, double }, ptr %1247, i64 %1244
  %1249 = load double, ptr %1248, align 8, !noalias !66
  %1250 = getelementptr inbounds nuw i8, ptr %1248, i64 8
  %1251 = load double, ptr %1250, align 8, !noalias !66
  %1252 = select i1 %1243, i64 %268, i64 0
  %1253 = getelementptr { double, double }, ptr %269, i64 %1139
  %1254 = getelementptr { double, double }, ptr %1253, i64 %1252
  %1255 = load double, ptr %1254, align 8, !noalias !66
  %1256 = getelementptr inbounds nuw i8, ptr %1254, i64 8
  %1257 = load double, ptr %1256, align 8, !noalias !66
  %1258 = fmul double %1249, %1257
  %1259 = fmul double %1251, %1255
  %1260 = fadd double %1258, %1259
  %1261 = fmul double %1249, %1255
  %1262 = fmul double %1251, %1257
  %1263 = fsub double %1261, %1262
  %1264 = add i64 %1139, 1
  %1265 = add nsw i64 %1140, -1
  %1266 = fsub double %1142, %1263
  %1267 = fsub double %1141, %1260
  br label %1138

1268:                                             ; preds = %976
  %1269 = add nsw i64 %978, -1
  %1270 = add i64 %977, 1
  %1271 = icmp slt i64 %977, 0
  %1272 = select i1 %1271, i64 %101, i64 0
  %1273 = getelementptr double, ptr %102, i64 %977
  %1274 = getelementptr double, ptr %1273, i64 %1272
  %1275 = load double, ptr %1274, align 8, !noalias !53
  %1276 = select i1 %1271, i64 %96, i64 0
  %1277 = getelementptr double, ptr %97, i64 %977
  %1278 = getelementptr double, ptr %1277, i64 %1276
  %1279 = load double, ptr %1278, align 8, !noalias !53
  %1280 = select i1 %1271, i64 %66, i64 0
  %1281 = getelementptr double, ptr %67, i64 %977
  %1282 = getelementptr double, ptr %1281, i64 %1280
  %1283 = load double, ptr %1282, align 8, !noalias !53
  %1284 = call double @llvm.fabs.f64(double %1283)
  %1285 = fmul double %1279, %1284
  %1286 = fadd double %1275, %1285
  %1287 = select i1 %1271, i64 %263, i64 0
  %1288 = getelementptr double, ptr %264, i64 %977
  %1289 = getelementptr double, ptr %1288, i64 %1287
  %1290 = load double, ptr %1289, align 8, !noalias !53
  %1291 = fdiv double %1290, %1286
  %1292 = select i1 %1271, i64 %268, i64 0
  %1293 = getelementptr { double, double }, ptr %269, i64 %977
  %1294 = getelementptr { double, double }, ptr %1293, i64 %1292
  %1295 = load double, ptr %1294, align 8, !noalias !53
  %1296 = fdiv double %1295, %1286
  %1297 = getelementptr inbounds nuw i8, ptr %1294, i64 8
  %1298 = load double, ptr %1297, align 8, !noalias !53
  %1299 = fdiv double %1298, %1286
  %1300 = fmul double %1291, %1291
  %1301 = fmul double %1296, %1296
  %1302 = fadd double %1300, %1301
  %1303 = fmul double %1299, %1299
  %1304 = fadd double %1302, %1303
  %1305 = fadd double %979, %1304
  br label %976

1306:                                             ; preds = %1016
  %1307 = fcmp ult double %988, 1.000000e+00
  br i1 %1307, label %1020, label %1368

1308:                                             ; preds = %1027
  %1309 = add nsw i64 %1029, -1
  %1310 = add i64 %1028, 1
  %1311 = icmp slt i64 %1028, 0
  %1312 = select i1 %1311, i64 %246, i64 0
  %1313 = getelementptr double, ptr %247, i64 %1028
  %1314 = getelementptr double, ptr %1313, i64 %1312
  %1315 = load double, ptr %1314, align 8, !noalias !53
  %1316 = select i1 %1311, i64 %263, i64 0
  %1317 = getelementptr double, ptr %264, i64 %1028
  %1318 = getelementptr double, ptr %1317, i64 %1316
  %1319 = load double, ptr %1318, align 8, !noalias !53
  %1320 = fadd double %1315, %1319
  store double %1320, ptr %1314, align 8, !noalias !53
  %1321 = getelementptr double, ptr %247, i64 %246
  %1322 = getelementptr double, ptr %1321, i64 %1028
  %1323 = getelementptr double, ptr %1322, i64 %1312
  %1324 = load double, ptr %1323, align 8, !noalias !53
  %1325 = select i1 %1311, i64 %268, i64 0
  %1326 = getelementptr { double, double }, ptr %269, i64 %1028
  %1327 = getelementptr { double, double }, ptr %1326, i64 %1325
  %1328 = load double, ptr %1327, align 8, !noalias !53
  %1329 = fadd double %1324, %1328
  store double %1329, ptr %1323, align 8, !noalias !53
  %1330 = shl i64 %246, 4
  %1331 = getelementptr i8, ptr %247, i64 %1330
  %1332 = getelementptr double, ptr %1331, i64 %1028
  %1333 = getelementptr double, ptr %1332, i64 %1312
  %1334 = load double, ptr %1333, align 8, !noalias !53
  %1335 = getelementptr inbounds nuw i8, ptr %1327, i64 8
  %1336 = load double, ptr %1335, align 8, !noalias !53
  %1337 = fadd double %1334, %1336
  store double %1337, ptr %1333, align 8, !noalias !53
  br label %1031

1338:                                             ; preds = %1031
  %1339 = add nsw i64 %1033, -1
  %1340 = add i64 %1032, 1
  %1341 = icmp slt i64 %1032, 0
  %1342 = add i64 %1032, 3
  %1343 = select i1 %1341, i64 %1342, i64 %1032
  %1344 = mul i64 %1343, 24
  %1345 = getelementptr i8, ptr @5, i64 %1344
  %1346 = load double, ptr %1345, align 8, !noalias !53
  %1347 = load double, ptr %1314, align 8, !noalias !53
  %1348 = fmul double %1346, %1347
  %1349 = getelementptr i8, ptr @6, i64 %1344
  %1350 = getelementptr i8, ptr %1349, i64 8
  %1351 = load double, ptr %1350, align 8, !noalias !53
  %1352 = load double, ptr %1323, align 8, !noalias !53
  %1353 = fmul double %1351, %1352
  %1354 = fadd double %1348, %1353
  %1355 = getelementptr i8, ptr @7, i64 %1344
  %1356 = getelementptr i8, ptr %1355, i64 16
  %1357 = load double, ptr %1356, align 8, !noalias !53
  %1358 = load double, ptr %1333, align 8, !noalias !53
  %1359 = fmul double %1357, %1358
  %1360 = fadd double %1354, %1359
  %1361 = select i1 %1341, i64 %237, i64 0
  %1362 = add i64 %1032, %1361
  %1363 = select i1 %1311, i64 %239, i64 0
  %1364 = mul i64 %1362, %239
  %1365 = getelementptr double, ptr %240, i64 %1364
  %1366 = getelementptr double, ptr %1365, i64 %1028
  %1367 = getelementptr double, ptr %1366, i64 %1363
  store double %1360, ptr %1367, align 8, !noalias !53
  br label %1031

1368:                                             ; preds = %1016, %974, %909, %1047, %1035, %1038, %1020, %1306, %1079, %912
  %1369 = phi double [ %874, %1047 ], [ 0.000000e+00, %912 ], [ %988, %1020 ], [ 0.000000e+00, %909 ], [ %1026, %1035 ], [ 0.000000e+00, %974 ], [ 0x7FF0000000000000, %1079 ], [ %988, %1306 ], [ %1026, %1038 ], [ 0.000000e+00, %1016 ]
  %1370 = phi i64 [ 6, %1047 ], [ %1051, %912 ], [ %1050, %1020 ], [ 0, %909 ], [ %1050, %1035 ], [ 0, %974 ], [ %1051, %1079 ], [ %1050, %1306 ], [ %1050, %1038 ], [ 0, %1016 ]
  %1371 = phi i1 [ true, %1047 ], [ true, %912 ], [ true, %1020 ], [ true, %909 ], [ false, %1035 ], [ true, %974 ], [ true, %1079 ], [ true, %1306 ], [ false, %1038 ], [ true, %1016 ]
  %1372 = phi i64 [ 0, %1047 ], [ %913, %912 ], [ 0, %1020 ], [ 0, %909 ], [ 0, %1035 ], [ 0, %974 ], [ 0, %1079 ], [ 0, %1306 ], [ 0, %1038 ], [ 0, %1016 ]
  %1373 = phi i32 [ 0, %1047 ], [ 0, %912 ], [ 0, %1020 ], [ %911, %909 ], [ 0, %1035 ], [ %975, %974 ], [ 0, %1079 ], [ 0, %1306 ], [ 0, %1038 ], [ %1019, %1016 ]
  switch i32 %1373, label %2021 [
    i32 -2, label %2019
    i32 0, label %2019
  ], !prof !25

1374:                                             ; preds = %2019
  br label %2151

1375:                                             ; preds = %2019
  br i1 %1371, label %1763, label %1376

1376:                                             ; preds = %1375, %2022
  %1377 = phi i64 [ %2024, %2022 ], [ 0, %1375 ]
  %1378 = phi i64 [ %2023, %2022 ], [ %284, %1375 ]
  %1379 = icmp sgt i64 %1378, 0
  br i1 %1379, label %2022, label %1380

1380:                                             ; preds = %1376
  %1381 = getelementptr i8, ptr %198, i64 32
  %1382 = load i64, ptr %1381, align 8, !noalias !5
  %1383 = icmp ne i64 %1382, 1
  store ptr null, ptr %6, align 8, !noalias !70
  store double 0.000000e+00, ptr %7, align 8, !noalias !70
  store ptr null, ptr %8, align 8, !noalias !70
  store ptr null, ptr %9, align 8, !noalias !70
  store double 0.000000e+00, ptr %10, align 8, !noalias !70
  store ptr null, ptr %11, align 8, !noalias !70
  %1384 = load i64, ptr %118, align 8, !noalias !70
  %1385 = call i64 @llvm.smax.i64(i64 %1384, i64 0)
  br label %1386

1386:                                             ; preds = %1421, %1380
  %1387 = phi i64 [ 0, %1380 ], [ %1423, %1421 ]
  %1388 = phi i64 [ %1385, %1380 ], [ %1422, %1421 ]
  %1389 = icmp sgt i64 %1388, 0
  br i1 %1389, label %1421, label %1390

1390:                                             ; preds = %1386
  store ptr null, ptr %6, align 8, !noalias !70
  %1391 = call fastcc i32 @solve(ptr nonnull %6, ptr %216, i64 %213, i64 %215, ptr %228, i64 %227, ptr %264, i64 %263) #3, !noalias !70
  switch i32 %1391, label %1499 [
    i32 -2, label %1455
    i32 0, label %1455
  ], !prof !25

1392:                                             ; preds = %1458, %1461
  %1393 = phi i64 [ %1463, %1461 ], [ 0, %1458 ]
  %1394 = phi i64 [ %1462, %1461 ], [ %1385, %1458 ]
  %1395 = icmp sgt i64 %1394, 0
  br i1 %1395, label %1461, label %1396

1396:                                             ; preds = %1392
  %1397 = getelementptr i8, ptr %112, i64 24
  %1398 = load i64, ptr %1397, align 8, !noalias !70
  %1399 = add nsw i64 %1398, 1
  store i64 %1399, ptr %1397, align 8, !noalias !70
  store ptr null, ptr %4, align 8, !noalias !74
  store ptr null, ptr %5, align 8, !noalias !74
  store double %392, ptr %35, align 8, !noalias !74
  %1400 = icmp sgt i64 %47, 0
  br i1 %1400, label %1401, label %1404

1401:                                             ; preds = %1396
  store ptr null, ptr %4, align 8, !noalias !74
  %1402 = call fastcc i32 @_sample(ptr nonnull %4, ptr %40, i64 %39, ptr %50, i64 %47, i64 %49, ptr %55, i64 %54, ptr %62, i64 %59, i64 %61, double %392) #3
  switch i32 %1402, label %1403 [
    i32 -2, label %1404
    i32 0, label %1404
  ], !prof !25

1403:                                             ; preds = %1401
  br label %1404

1404:                                             ; preds = %1401, %1401, %1396, %1403
  %1405 = phi i32 [ %1402, %1403 ], [ 0, %1396 ], [ 0, %1401 ], [ 0, %1401 ]
  switch i32 %1405, label %1410 [
    i32 -2, label %1406
    i32 0, label %1406
  ], !prof !25

1406:                                             ; preds = %1404, %1404
  %1407 = load i64, ptr %32, align 8, !noalias !81
  %1408 = inttoptr i64 %1407 to ptr
  %1409 = call i32 %1408(ptr nonnull %35, ptr %77, ptr %40, ptr %43, ptr %252) #3, !noalias !81
  br label %1410

1410:                                             ; preds = %1404, %1406
  %1411 = phi i32 [ %1409, %1406 ], [ 0, %1404 ]
  %1412 = phi i32 [ 0, %1406 ], [ %1405, %1404 ]
  switch i32 %1412, label %1499 [
    i32 -2, label %1477
    i32 0, label %1477
  ], !prof !25

1413:                                             ; preds = %1477
  %1414 = sext i32 %1411 to i64
  br label %1499

1415:                                             ; preds = %1477, %1479
  %1416 = phi i64 [ %1481, %1479 ], [ 0, %1477 ]
  %1417 = phi i64 [ %1480, %1479 ], [ %1385, %1477 ]
  %1418 = icmp sgt i64 %1417, 0
  br i1 %1418, label %1479, label %1419

1419:                                             ; preds = %1415
  store ptr null, ptr %9, align 8, !noalias !70
  %1420 = call fastcc i32 @solve(ptr nonnull %9, ptr %216, i64 %213, i64 %215, ptr %228, i64 %227, ptr %264, i64 %263) #3, !noalias !70
  switch i32 %1420, label %1499 [
    i32 -2, label %1495
    i32 0, label %1495
  ], !prof !25

1421:                                             ; preds = %1386
  %1422 = add nsw i64 %1388, -1
  %1423 = add i64 %1387, 1
  %1424 = icmp slt i64 %1387, 0
  %1425 = select i1 %1424, i64 %239, i64 0
  %1426 = getelementptr double, ptr %240, i64 %1387
  %1427 = getelementptr double, ptr %1426, i64 %1425
  %1428 = load double, ptr %1427, align 8, !noalias !70
  %1429 = fmul double %1428, 0xC02418FD8BAFFE05
  %1430 = getelementptr double, ptr %240, i64 %239
  %1431 = getelementptr double, ptr %1430, i64 %1387
  %1432 = getelementptr double, ptr %1431, i64 %1425
  %1433 = load double, ptr %1432, align 8, !noalias !70
  %1434 = fmul double %1433, 0x3FF61D41B2D54580
  %1435 = fadd double %1429, %1434
  %1436 = shl i64 %239, 4
  %1437 = getelementptr i8, ptr %240, i64 %1436
  %1438 = getelementptr double, ptr %1437, i64 %1387
  %1439 = getelementptr double, ptr %1438, i64 %1425
  %1440 = load double, ptr %1439, align 8, !noalias !70
  %1441 = fmul double %1440, 0xBFD5555555555555
  %1442 = fadd double %1435, %1441
  %1443 = fdiv double %1442, %417
  %1444 = select i1 %1424, i64 %273, i64 0
  %1445 = getelementptr double, ptr %274, i64 %1387
  %1446 = getelementptr double, ptr %1445, i64 %1444
  store double %1443, ptr %1446, align 8, !noalias !70
  %1447 = select i1 %1424, i64 %86, i64 0
  %1448 = getelementptr double, ptr %87, i64 %1387
  %1449 = getelementptr double, ptr %1448, i64 %1447
  %1450 = load double, ptr %1449, align 8, !noalias !70
  %1451 = fadd double %1450, %1443
  %1452 = select i1 %1424, i64 %263, i64 0
  %1453 = getelementptr double, ptr %264, i64 %1387
  %1454 = getelementptr double, ptr %1453, i64 %1452
  store double %1451, ptr %1454, align 8, !noalias !70
  br label %1386

1455:                                             ; preds = %1390, %1390
  store double 0.000000e+00, ptr %7, align 8, !noalias !70
  %1456 = call fastcc i32 @norm(ptr nonnull %7, i64 %263, ptr %264, i64 %263, ptr %67, i64 %66, ptr %72, i64 %71, ptr nonnull %97, i64 %96, ptr %102, i64 %101) #3
  %1457 = load double, ptr %7, align 8, !noalias !70
  switch i32 %1456, label %1499 [
    i32 -2, label %1458
    i32 0, label %1458
  ], !prof !25

1458:                                             ; preds = %1455, %1455
  %1459 = fcmp olt double %1457, 1.000000e+00
  %1460 = select i1 %1459, i1 true, i1 %1383
  br i1 %1460, label %1499, label %1392

1461:                                             ; preds = %1392
  %1462 = add nsw i64 %1394, -1
  %1463 = add i64 %1393, 1
  %1464 = icmp slt i64 %1393, 0
  %1465 = select i1 %1464, i64 %66, i64 0
  %1466 = getelementptr double, ptr %67, i64 %1393
  %1467 = getelementptr double, ptr %1466, i64 %1465
  %1468 = load double, ptr %1467, align 8, !noalias !70
  %1469 = select i1 %1464, i64 %263, i64 0
  %1470 = getelementptr double, ptr %264, i64 %1393
  %1471 = getelementptr double, ptr %1470, i64 %1469
  %1472 = load double, ptr %1471, align 8, !noalias !70
  %1473 = fadd double %1468, %1472
  %1474 = select i1 %1464, i64 %76, i64 0
  %1475 = getelementptr double, ptr %77, i64 %1393
  %1476 = getelementptr double, ptr %1475, i64 %1474
  store double %1473, ptr %1476, align 8, !noalias !70
  br label %1392

1477:                                             ; preds = %1410, %1410
  %1478 = icmp eq i32 %1411, 0
  br i1 %1478, label %1415, label %1413

1479:                                             ; preds = %1415
  %1480 = add nsw i64 %1417, -1
  %1481 = add i64 %1416, 1
  %1482 = icmp slt i64 %1416, 0
  %1483 = select i1 %1482, i64 %251, i64 0
  %1484 = getelementptr double, ptr %252, i64 %1416
  %1485 = getelementptr double, ptr %1484, i64 %1483
  %1486 = load double, ptr %1485, align 8, !noalias !70
  %1487 = select i1 %1482, i64 %273, i64 0
  %1488 = getelementptr double, ptr %274, i64 %1416
  %1489 = getelementptr double, ptr %1488, i64 %1487
  %1490 = load double, ptr %1489, align 8, !noalias !70
  %1491 = fadd double %1486, %1490
  %1492 = select i1 %1482, i64 %263, i64 0
  %1493 = getelementptr double, ptr %264, i64 %1416
  %1494 = getelementptr double, ptr %1493, i64 %1492
  store double %1491, ptr %1494, align 8, !noalias !70
  br label %1415

1495:                                             ; preds = %1419, %1419
  store double 0.000000e+00, ptr %10, align 8, !noalias !70
  %1496 = call fastcc i32 @norm(ptr nonnull %10, i64 %263, ptr %264, i64 %263, ptr %67, i64 %66, ptr %72, i64 %71, ptr nonnull %97, i64 %96, ptr %102, i64 %101) #3
  switch i32 %1496, label %1499 [
    i32 -2, label %1497
    i32 0, label %1497
  ], !prof !25

1497:                                             ; preds = %1495, %1495
  %1498 = load double, ptr %10, align 8, !noalias !70
  br label %1499

1499:                                             ; preds = %1495, %1419, %1410, %1455, %1390, %1458, %1413, %1497
  %1500 = phi double [ %1457, %1458 ], [ 0.000000e+00, %1390 ], [ %1457, %1413 ], [ 0.000000e+00, %1455 ], [ 0.000000e+00, %1410 ], [ 0.000000e+00, %1419 ], [ %1498, %1497 ], [ 0.000000e+00, %1495 ]
  %1501 = phi i64 [ 0, %1458 ], [ 0, %1390 ], [ %1414, %1413 ], [ 0, %1455 ], [ 0, %1410 ], [ 0, %1419 ], [ 0, %1497 ], [ 0, %1495 ]
  %1502 = phi i32 [ 0, %1458 ], [ %1391, %1390 ], [ 0, %1413 ], [ %1456, %1455 ], [ %1412, %1410 ], [ %1420, %1419 ], [ 0, %1497 ], [ %1496, %1495 ]
  switch i32 %1502, label %2042 [
    i32 -2, label %2040
    i32 0, label %2040
  ], !prof !25

1503:                                             ; preds = %2040
  br label %2151

1504:                                             ; preds = %2040
  %1505 = add nsw i64 %1370, 12
  %1506 = sitofp i64 %1505 to double
  %1507 = fdiv double 0x4027666666666667, %1506
  %1508 = fcmp olt double %1500, 1.000000e-10
  %1509 = select i1 %1508, double 1.000000e-10, double %1500
  %1510 = call double @llvm.pow.f64(double %1509, double -2.500000e-01)
  %1511 = icmp eq i64 %1501, 0
  %1512 = fcmp olt double %1500, 1.000000e+00
  %1513 = select i1 %1511, i1 %1512, i1 false
  br i1 %1513, label %1514, label %1746

1514:                                             ; preds = %1504
  br i1 %277, label %1515, label %1522

1515:                                             ; preds = %1514
  %1516 = getelementptr i8, ptr %159, i64 56
  %1517 = load i64, ptr %1516, align 8, !noalias !5
  %1518 = inttoptr i64 %1517 to ptr
  %1519 = call i64 %1518(i64 %0, double %418, i64 %69) #3, !noalias !5
  %1520 = icmp eq i64 %1519, 0
  br i1 %1520, label %1522, label %1521

1521:                                             ; preds = %1515
  store double %417, ptr %300, align 8, !noalias !5
  br label %2151

1522:                                             ; preds = %1515, %1514
  %1523 = load i64, ptr %398, align 8, !noalias !5
  %1524 = add nsw i64 %1523, 1
  store i64 %1524, ptr %398, align 8, !noalias !5
  %1525 = getelementptr i8, ptr %107, i64 24
  %1526 = load double, ptr %1525, align 8, !noalias !5
  %1527 = fcmp ogt double %1526, 0.000000e+00
  br i1 %1527, label %1528, label %1538

1528:                                             ; preds = %1522
  %1529 = getelementptr i8, ptr %107, i64 32
  %1530 = load double, ptr %1529, align 8, !noalias !5
  %1531 = fdiv double %417, %1530
  %1532 = fdiv double %1526, %1509
  %1533 = call double @llvm.pow.f64(double %1532, double 2.500000e-01)
  %1534 = fmul double %1531, %1533
  %1535 = fcmp olt double %1534, 1.000000e+00
  %1536 = select i1 %1535, double %1534, double 1.000000e+00
  %1537 = fmul double %1510, %1536
  br label %1538

1538:                                             ; preds = %1528, %1522
  %1539 = phi double [ %1537, %1528 ], [ %1510, %1522 ]
  %1540 = fmul double %1507, %1539
  %1541 = fcmp olt double %1540, 1.000000e+01
  %1542 = select i1 %1541, double %1540, double 1.000000e+01
  store double %418, ptr %107, align 8, !noalias !5
  %1543 = getelementptr i8, ptr %107, i64 32
  store double %417, ptr %1543, align 8, !noalias !5
  store double %1509, ptr %1525, align 8, !noalias !5
  br label %1544

1544:                                             ; preds = %1548, %1538
  %1545 = phi i64 [ 0, %1538 ], [ %2045, %1548 ]
  %1546 = phi i64 [ %284, %1538 ], [ %2044, %1548 ]
  %1547 = icmp sgt i64 %1546, 0
  br i1 %1547, label %2043, label %1552

1548:                                             ; preds = %2043, %2100
  %1549 = phi i64 [ 0, %2043 ], [ %2102, %2100 ]
  %1550 = phi i64 [ 3, %2043 ], [ %2101, %2100 ]
  %1551 = icmp sgt i64 %1550, 0
  br i1 %1551, label %2100, label %1544

1552:                                             ; preds = %1544
  store double %417, ptr %789, align 8, !noalias !5
  %1553 = getelementptr i8, ptr %162, i64 8
  %1554 = load i64, ptr %1553, align 8, !noalias !5
  %1555 = icmp sgt i64 %1554, 0
  br i1 %1555, label %1565, label %1556

1556:                                             ; preds = %1552
  %1557 = getelementptr i8, ptr %112, i64 48
  %1558 = load i64, ptr %1557, align 8, !noalias !5
  %1559 = icmp slt i64 %1558, 0
  %1560 = select i1 %1559, i64 %116, i64 0
  %1561 = getelementptr double, ptr %117, i64 %1558
  %1562 = getelementptr double, ptr %1561, i64 %1560
  %1563 = load double, ptr %1562, align 8, !noalias !5
  %1564 = fcmp ugt double %1563, %418
  br i1 %1564, label %1701, label %1572

1565:                                             ; preds = %1552
  %1566 = getelementptr i8, ptr %162, i64 16
  %1567 = load i64, ptr %1566, align 8, !noalias !5
  %1568 = inttoptr i64 %1567 to ptr
  %1569 = call i64 %1568(i64 %0, double %392, double %417) #3, !noalias !5
  %1570 = getelementptr i8, ptr %107, i64 48
  %1571 = load double, ptr %1570, align 8, !noalias !5
  br label %1572

1572:                                             ; preds = %1556, %1565
  %1573 = phi double [ %1571, %1565 ], [ 1.000000e+00, %1556 ]
  %1574 = phi i64 [ %1569, %1565 ], [ 0, %1556 ]
  %1575 = fcmp oeq double %1573, 1.000000e+00
  br i1 %1575, label %1576, label %1578

1576:                                             ; preds = %1572
  %1577 = load double, ptr %107, align 8, !noalias !5
  br label %1581

1578:                                             ; preds = %1572
  %1579 = fmul double %1573, %417
  %1580 = fadd double %392, %1579
  br label %1581

1581:                                             ; preds = %1578, %1576
  %1582 = phi double [ %1577, %1576 ], [ %1580, %1578 ]
  %1583 = load i64, ptr %118, align 8, !noalias !5
  %1584 = load i64, ptr %159, align 8, !noalias !5
  %1585 = icmp eq i64 %1584, 1
  %1586 = getelementptr i8, ptr %112, i64 48
  %1587 = load i64, ptr %1586, align 8, !noalias !5
  %1588 = icmp slt i64 %1587, %116
  br i1 %1588, label %1589, label %1626

1589:                                             ; preds = %1581
  %1590 = icmp slt i64 %1587, 0
  %1591 = select i1 %1590, i64 %116, i64 0
  %1592 = getelementptr double, ptr %117, i64 %1587
  %1593 = getelementptr double, ptr %1592, i64 %1591
  %1594 = load double, ptr %1593, align 8, !noalias !5
  %1595 = fcmp ugt double %1594, %1582
  br i1 %1595, label %1626, label %1596

1596:                                             ; preds = %1589, %1619
  %1597 = phi i64 [ %1617, %1619 ], [ %1587, %1589 ]
  %1598 = icmp slt i64 %1597, 0
  %1599 = select i1 %1598, i64 %116, i64 0
  %1600 = getelementptr double, ptr %117, i64 %1597
  %1601 = getelementptr double, ptr %1600, i64 %1599
  %1602 = load double, ptr %1601, align 8, !noalias !5
  %1603 = fsub double %1602, %392
  %1604 = fdiv double %1603, %417
  %1605 = mul nsw i64 %1597, %1583
  %1606 = shl i64 %1605, 3
  %1607 = add i64 %1606, %1
  %1608 = call i64 @llvm.smax.i64(i64 %81, i64 0)
  br label %2117

1609:                                             ; preds = %2121
  %1610 = getelementptr i8, ptr %159, i64 56
  %1611 = load i64, ptr %1610, align 8, !noalias !5
  %1612 = load double, ptr %1601, align 8, !noalias !5
  %1613 = inttoptr i64 %1611 to ptr
  %1614 = call i64 %1613(i64 %0, double %1612, i64 %1607) #3, !noalias !5
  %1615 = icmp eq i64 %1614, 0
  br i1 %1615, label %1616, label %1628

1616:                                             ; preds = %2121, %1609
  %1617 = add nsw i64 %1597, 1
  %1618 = icmp slt i64 %1617, %116
  br i1 %1618, label %1619, label %1626

1619:                                             ; preds = %1616
  %1620 = icmp slt i64 %1597, -1
  %1621 = select i1 %1620, i64 %116, i64 0
  %1622 = getelementptr double, ptr %117, i64 %1617
  %1623 = getelementptr double, ptr %1622, i64 %1621
  %1624 = load double, ptr %1623, align 8, !noalias !5
  %1625 = fcmp ugt double %1624, %1582
  br i1 %1625, label %1626, label %1596

1626:                                             ; preds = %1619, %1616, %1589, %1581
  %1627 = phi i64 [ %1617, %1619 ], [ %1617, %1616 ], [ %1587, %1589 ], [ %1587, %1581 ]
  store i64 %1627, ptr %1586, align 8, !noalias !5
  br label %1628

1628:                                             ; preds = %1609, %1626
  %1629 = phi i1 [ true, %1626 ], [ false, %1609 ]
  %1630 = phi i64 [ 0, %1626 ], [ %1614, %1609 ]
  %1631 = icmp ne i64 %1574, 0
  %1632 = select i1 %1629, i1 %1631, i1 false
  %1633 = fcmp olt double %1573, 1.000000e+00
  %1634 = and i1 %1632, %1633
  br i1 %1634, label %1635, label %1674

1635:                                             ; preds = %1628
  %1636 = call i64 @llvm.smax.i64(i64 %81, i64 0)
  br label %1637

1637:                                             ; preds = %1635, %1662
  %1638 = phi i64 [ 0, %1635 ], [ %1664, %1662 ]
  %1639 = phi i64 [ %1636, %1635 ], [ %1663, %1662 ]
  %1640 = icmp sgt i64 %1639, 0
  br i1 %1640, label %1662, label %1641

1641:                                             ; preds = %1637
  %1642 = getelementptr i8, ptr %29, i64 24
  %1643 = load i64, ptr %1642, align 8, !noalias !82
  %1644 = getelementptr i8, ptr %32, i64 16
  %1645 = load i64, ptr %1644, align 8, !noalias !82
  call fastcc void @pydy_nested(i64 %74, i64 %64, i64 %89, i64 %66, i64 %1643, i64 %79, i64 %1645) #3, !noalias !82
  %1646 = call i64 @llvm.smax.i64(i64 %71, i64 0)
  br label %1647

1647:                                             ; preds = %1651, %1641
  %1648 = phi i64 [ 0, %1641 ], [ %1653, %1651 ]
  %1649 = phi i64 [ %1646, %1641 ], [ %1652, %1651 ]
  %1650 = icmp sgt i64 %1649, 0
  br i1 %1650, label %1651, label %2133

1651:                                             ; preds = %1647
  %1652 = add nsw i64 %1649, -1
  %1653 = add i64 %1648, 1
  %1654 = icmp slt i64 %1648, 0
  %1655 = select i1 %1654, i64 %76, i64 0
  %1656 = getelementptr double, ptr %77, i64 %1648
  %1657 = getelementptr double, ptr %1656, i64 %1655
  %1658 = load double, ptr %1657, align 8, !noalias !86
  %1659 = select i1 %1654, i64 %71, i64 0
  %1660 = getelementptr double, ptr %72, i64 %1648
  %1661 = getelementptr double, ptr %1660, i64 %1659
  store double %1658, ptr %1661, align 8, !noalias !86
  br label %1647

1662:                                             ; preds = %1637
  %1663 = add nsw i64 %1639, -1
  %1664 = add i64 %1638, 1
  %1665 = icmp slt i64 %1638, 0
  %1666 = select i1 %1665, i64 %81, i64 0
  %1667 = getelementptr double, ptr %82, i64 %1638
  %1668 = getelementptr double, ptr %1667, i64 %1666
  store double %1573, ptr %1668, align 8, !noalias !82
  br label %1637

1669:                                             ; preds = %2133
  %1670 = getelementptr i8, ptr %159, i64 56
  %1671 = load i64, ptr %1670, align 8, !noalias !5
  %1672 = inttoptr i64 %1671 to ptr
  %1673 = call i64 %1672(i64 %0, double %1582, i64 %69) #3, !noalias !5
  br label %1674

1674:                                             ; preds = %2133, %1669, %1628
  %1675 = phi i64 [ %1673, %1669 ], [ 0, %2133 ], [ %1630, %1628 ]
  %1676 = icmp eq i64 %1675, 0
  br i1 %1676, label %1678, label %1677

1677:                                             ; preds = %1674
  store double %392, ptr %107, align 8, !noalias !5
  store double %417, ptr %300, align 8, !noalias !5
  br label %1697

1678:                                             ; preds = %1674
  %1679 = icmp eq i64 %1574, 0
  br i1 %1679, label %1697, label %1680

1680:                                             ; preds = %1678
  %1681 = call i64 @llvm.smax.i64(i64 %66, i64 0)
  br label %1682

1682:                                             ; preds = %1686, %1680
  %1683 = phi i64 [ 0, %1680 ], [ %1688, %1686 ]
  %1684 = phi i64 [ %1681, %1680 ], [ %1687, %1686 ]
  %1685 = icmp sgt i64 %1684, 0
  br i1 %1685, label %1686, label %2136

1686:                                             ; preds = %1682
  %1687 = add nsw i64 %1684, -1
  %1688 = add i64 %1683, 1
  %1689 = icmp slt i64 %1683, 0
  %1690 = select i1 %1689, i64 %71, i64 0
  %1691 = getelementptr double, ptr %72, i64 %1683
  %1692 = getelementptr double, ptr %1691, i64 %1690
  %1693 = load double, ptr %1692, align 8, !noalias !89
  %1694 = select i1 %1689, i64 %66, i64 0
  %1695 = getelementptr double, ptr %67, i64 %1683
  %1696 = getelementptr double, ptr %1695, i64 %1694
  store double %1693, ptr %1696, align 8, !noalias !89
  br label %1682

1697:                                             ; preds = %1678, %2136, %1677
  %1698 = phi i1 [ false, %1677 ], [ false, %2136 ], [ true, %1678 ]
  %1699 = phi i64 [ %1675, %1677 ], [ %1574, %2136 ], [ 0, %1678 ]
  br i1 %1698, label %1701, label %1700

1700:                                             ; preds = %1697
  br label %2151

1701:                                             ; preds = %1697, %1556
  br label %1702

1702:                                             ; preds = %1701, %2137
  %1703 = phi i64 [ 0, %1701 ], [ %2139, %2137 ]
  %1704 = phi i64 [ %284, %1701 ], [ %2138, %2137 ]
  %1705 = icmp sgt i64 %1704, 0
  br i1 %1705, label %2137, label %1706

1706:                                             ; preds = %1702
  %1707 = getelementptr i8, ptr %112, i64 24
  %1708 = load i64, ptr %1707, align 8, !noalias !5
  %1709 = add nsw i64 %1708, 1
  store i64 %1709, ptr %1707, align 8, !noalias !5
  store ptr null, ptr %17, align 8, !noalias !92
  store ptr null, ptr %18, align 8, !noalias !92
  store double %418, ptr %35, align 8, !noalias !92
  %1710 = icmp sgt i64 %47, 0
  br i1 %1710, label %1711, label %1714

1711:                                             ; preds = %1706
  store ptr null, ptr %17, align 8, !noalias !92
  %1712 = call fastcc i32 @_sample(ptr nonnull %17, ptr %40, i64 %39, ptr %50, i64 %47, i64 %49, ptr %55, i64 %54, ptr %62, i64 %59, i64 %61, double %418) #3
  switch i32 %1712, label %1713 [
    i32 -2, label %1714
    i32 0, label %1714
  ], !prof !25

1713:                                             ; preds = %1711
  br label %1714

1714:                                             ; preds = %1711, %1711, %1706, %1713
  %1715 = phi i32 [ %1712, %1713 ], [ 0, %1706 ], [ 0, %1711 ], [ 0, %1711 ]
  switch i32 %1715, label %1720 [
    i32 -2, label %1716
    i32 0, label %1716
  ], !prof !25

1716:                                             ; preds = %1714, %1714
  %1717 = load i64, ptr %32, align 8, !noalias !99
  %1718 = inttoptr i64 %1717 to ptr
  %1719 = call i32 %1718(ptr nonnull %35, ptr %67, ptr %40, ptr %43, ptr %87) #3, !noalias !99
  br label %1720

1720:                                             ; preds = %1714, %1716
  %1721 = phi i32 [ %1719, %1716 ], [ 0, %1714 ]
  %1722 = phi i32 [ 0, %1716 ], [ %1715, %1714 ]
  switch i32 %1722, label %2150 [
    i32 -2, label %2148
    i32 0, label %2148
  ], !prof !25

1723:                                             ; preds = %2148
  %1724 = getelementptr i8, ptr %112, i64 72
  store i64 3, ptr %1724, align 8, !noalias !5
  store double %417, ptr %300, align 8, !noalias !5
  %1725 = icmp slt i32 %1721, 0
  %1726 = select i1 %1725, i64 -4, i64 2
  br label %2151

1727:                                             ; preds = %2148
  %1728 = icmp sgt i64 %1370, 2
  %1729 = fcmp ogt double %1369, 1.000000e-03
  %1730 = select i1 %1728, i1 %1729, i1 false
  %1731 = zext i1 %1730 to i64
  store i64 %1731, ptr %425, align 8, !noalias !5
  %1732 = getelementptr i8, ptr %198, i64 16
  store i64 0, ptr %1732, align 8, !noalias !5
  store i64 0, ptr %1381, align 8, !noalias !5
  %1733 = fcmp ule double %1542, 1.000000e+00
  %1734 = fcmp uge double %1542, 1.200000e+00
  %1735 = or i1 %1733, %1734
  %1736 = select i1 %1735, i1 true, i1 %1730
  br i1 %1736, label %1737, label %1741

1737:                                             ; preds = %1727
  %1738 = fcmp ogt double %1542, 2.000000e-01
  %1739 = select i1 %1738, double %1542, double 2.000000e-01
  %1740 = fmul double %417, %1739
  br label %1741

1741:                                             ; preds = %1727, %1737
  %1742 = phi double [ %1740, %1737 ], [ %417, %1727 ]
  %1743 = getelementptr i8, ptr %112, i64 48
  %1744 = load i64, ptr %1743, align 8, !noalias !5
  %1745 = icmp eq i64 %1744, %116
  br i1 %1745, label %1791, label %390

1746:                                             ; preds = %1504
  %1747 = load i64, ptr %400, align 8, !noalias !5
  %1748 = add nsw i64 %1747, 1
  store i64 %1748, ptr %400, align 8, !noalias !5
  %1749 = select i1 %1511, i64 2, i64 3
  %1750 = getelementptr i8, ptr %112, i64 72
  store i64 %1749, ptr %1750, align 8, !noalias !5
  %1751 = fsub double %1500, %1500
  %1752 = fcmp ord double %1751, 0.000000e+00
  br i1 %1752, label %1753, label %1757

1753:                                             ; preds = %1746
  %1754 = fmul double %1507, %1510
  %1755 = fcmp ogt double %1754, 2.000000e-01
  %1756 = select i1 %1755, double %1754, double 2.000000e-01
  br label %1757

1757:                                             ; preds = %1753, %1746
  %1758 = phi double [ 2.500000e-01, %1746 ], [ %1756, %1753 ]
  %1759 = fmul double %417, %1758
  %1760 = getelementptr i8, ptr %198, i64 16
  %1761 = load i64, ptr %1760, align 8, !noalias !5
  %1762 = sub nsw i64 1, %1761
  store i64 1, ptr %1381, align 8, !noalias !5
  store i64 %1762, ptr %425, align 8, !noalias !5
  br label %1788

1763:                                             ; preds = %1375
  %1764 = load i64, ptr %400, align 8, !noalias !5
  %1765 = add nsw i64 %1764, 1
  store i64 %1765, ptr %400, align 8, !noalias !5
  %1766 = icmp ne i64 %1372, 0
  br i1 %1766, label %1767, label %1769

1767:                                             ; preds = %1763
  %1768 = getelementptr i8, ptr %112, i64 72
  store i64 3, ptr %1768, align 8, !noalias !5
  br label %1776

1769:                                             ; preds = %1763
  %1770 = fsub double %1369, %1369
  %1771 = fcmp ord double %1770, 0.000000e+00
  br i1 %1771, label %1772, label %1774

1772:                                             ; preds = %1769
  %1773 = getelementptr i8, ptr %112, i64 72
  store i64 7, ptr %1773, align 8, !noalias !5
  br label %1776

1774:                                             ; preds = %1769
  %1775 = getelementptr i8, ptr %112, i64 72
  store i64 4, ptr %1775, align 8, !noalias !5
  br label %1776

1776:                                             ; preds = %1774, %1772, %1767
  %1777 = getelementptr i8, ptr %198, i64 16
  %1778 = load i64, ptr %1777, align 8, !noalias !5
  %1779 = icmp eq i64 %1778, 1
  %1780 = or i1 %1779, %1766
  br i1 %1780, label %1781, label %1784

1781:                                             ; preds = %1776
  %1782 = select i1 %1766, double 2.500000e-01, double 5.000000e-01
  %1783 = fmul double %417, %1782
  store double 0.000000e+00, ptr %789, align 8, !noalias !5
  br label %1784

1784:                                             ; preds = %1776, %1781
  %1785 = phi double [ %1783, %1781 ], [ %391, %1776 ]
  %1786 = load i64, ptr %1777, align 8, !noalias !5
  %1787 = sub nsw i64 1, %1786
  store i64 %1787, ptr %425, align 8, !noalias !5
  br label %1788

1788:                                             ; preds = %1784, %1757, %780
  %1789 = phi double [ %1759, %1757 ], [ %1785, %1784 ], [ %783, %780 ]
  br label %387

1790:                                             ; preds = %407
  store double %417, ptr %300, align 8, !noalias !5
  br label %2151

1791:                                             ; preds = %1741
  store double %1742, ptr %300, align 8, !noalias !5
  br label %2151

1792:                                             ; preds = %285
  %1793 = icmp slt i64 %286, 0
  %1794 = select i1 %1793, i64 %96, i64 0
  %1795 = getelementptr double, ptr %97, i64 %286
  %1796 = getelementptr double, ptr %1795, i64 %1794
  %1797 = load double, ptr %1796, align 8, !noalias !5
  %1798 = fcmp olt double %1797, %288
  %1799 = select i1 %1798, double %1797, double %288
  %1800 = add i64 %286, 1
  %1801 = add nsw i64 %287, -1
  br label %285

1802:                                             ; preds = %318, %318
  %1803 = icmp eq i32 %319, 0
  br i1 %1803, label %325, label %321

1804:                                             ; preds = %318
  br label %2151

1805:                                             ; preds = %1823, %1820
  %1806 = phi i64 [ %66, %1823 ], [ %1821, %1820 ]
  %1807 = sub i64 %1806, %1814
  %1808 = call i64 @llvm.smax.i64(i64 %1807, i64 0)
  %1809 = getelementptr double, ptr %67, i64 %1814
  store double 0.000000e+00, ptr %23, align 8, !noalias !5
  %1810 = call fastcc i32 @norm(ptr nonnull %23, i64 %1808, ptr %1809, i64 %1808, ptr %67, i64 %66, ptr %67, i64 %66, ptr nonnull %97, i64 %96, ptr %102, i64 %101) #3
  %1811 = load double, ptr %23, align 8, !noalias !5
  switch i32 %1810, label %1824 [
    i32 -2, label %1831
    i32 0, label %1831
  ], !prof !25

1812:                                             ; preds = %380
  br label %1813

1813:                                             ; preds = %1812, %380
  %1814 = phi i64 [ %66, %1812 ], [ 0, %380 ]
  %1815 = icmp slt i64 %381, 0
  %1816 = select i1 %1815, i64 %66, i64 0
  %1817 = add i64 %381, %1816
  %1818 = icmp slt i64 %1817, 0
  br i1 %1818, label %1819, label %1820, !prof !0

1819:                                             ; preds = %1813
  br label %1820

1820:                                             ; preds = %1819, %1813
  %1821 = phi i64 [ 0, %1819 ], [ %1817, %1813 ]
  %1822 = icmp slt i64 %1817, %66
  br i1 %1822, label %1805, label %1823, !prof !4

1823:                                             ; preds = %1820
  br label %1805

1824:                                             ; preds = %1805
  br label %2151

1825:                                             ; preds = %1843, %1840
  %1826 = phi i64 [ %86, %1843 ], [ %1841, %1840 ]
  %1827 = sub i64 %1826, %1835
  %1828 = call i64 @llvm.smax.i64(i64 %1827, i64 0)
  %1829 = getelementptr double, ptr %87, i64 %1835
  store double 0.000000e+00, ptr %25, align 8, !noalias !5
  %1830 = call fastcc i32 @norm(ptr nonnull %25, i64 %1828, ptr %1829, i64 %1828, ptr %67, i64 %66, ptr %67, i64 %66, ptr nonnull %97, i64 %96, ptr %102, i64 %101) #3
  switch i32 %1830, label %1861 [
    i32 -2, label %1844
    i32 0, label %1844
  ], !prof !25

1831:                                             ; preds = %1805, %1805
  %1832 = icmp slt i64 %86, 1
  br i1 %1832, label %1833, label %1834, !prof !0

1833:                                             ; preds = %1831
  br label %1834

1834:                                             ; preds = %1833, %1831
  %1835 = phi i64 [ %86, %1833 ], [ 0, %1831 ]
  %1836 = select i1 %1815, i64 %86, i64 0
  %1837 = add i64 %381, %1836
  %1838 = icmp slt i64 %1837, 0
  br i1 %1838, label %1839, label %1840, !prof !0

1839:                                             ; preds = %1834
  br label %1840

1840:                                             ; preds = %1839, %1834
  %1841 = phi i64 [ 0, %1839 ], [ %1837, %1834 ]
  %1842 = icmp slt i64 %1837, %86
  br i1 %1842, label %1825, label %1843, !prof !4

1843:                                             ; preds = %1840
  br label %1825

1844:                                             ; preds = %1825, %1825
  %1845 = load double, ptr %25, align 8, !noalias !5
  %1846 = fcmp olt double %1811, 1.000000e-05
  %1847 = fcmp olt double %1845, 1.000000e-05
  %1848 = select i1 %1846, i1 true, i1 %1847
  %1849 = fmul double %1811, 1.000000e-02
  %1850 = fdiv double %1849, %1845
  %1851 = select i1 %1848, double 0x3EB0C6F7A0B5ED8D, double %1850
  %1852 = call double @llvm.fabs.f64(double %299)
  %1853 = fmul double %1852, 0x3D30000000000000
  %1854 = fcmp olt double %1851, %1853
  %1855 = select i1 %1854, double %1853, double %1851
  %1856 = getelementptr i8, ptr %107, i64 16
  %1857 = load double, ptr %1856, align 8, !noalias !5
  %1858 = fcmp olt double %1857, %1855
  %1859 = select i1 %1858, double %1857, double %1855
  %1860 = call i1 @llvm.is.fpclass.f64(double %1859, i32 384)
  br i1 %1860, label %385, label %383

1861:                                             ; preds = %1825
  br label %2151

1862:                                             ; preds = %440, %440
  %1863 = load i64, ptr %198, align 8, !noalias !5
  %1864 = inttoptr i64 %1863 to ptr
  %1865 = call i32 %1864(ptr nonnull %35, ptr %67, ptr %40, ptr %204, ptr %209) #3, !noalias !5
  %1866 = sext i32 %1865 to i64
  br label %460

1867:                                             ; preds = %440
  br label %2151

1868:                                             ; preds = %444
  %1869 = add nsw i64 %446, -1
  %1870 = add i64 %445, 1
  %1871 = icmp slt i64 %445, 0
  %1872 = select i1 %1871, i64 %66, i64 0
  %1873 = getelementptr double, ptr %67, i64 %445
  %1874 = getelementptr double, ptr %1873, i64 %1872
  %1875 = load double, ptr %1874, align 8, !noalias !5
  %1876 = select i1 %1871, i64 %76, i64 0
  %1877 = getelementptr double, ptr %77, i64 %445
  %1878 = getelementptr double, ptr %1877, i64 %1876
  store double %1875, ptr %1878, align 8, !noalias !5
  br label %444

1879:                                             ; preds = %448
  %1880 = add nsw i64 %450, -1
  %1881 = add i64 %449, 1
  %1882 = icmp slt i64 %449, 0
  %1883 = select i1 %1882, i64 %66, i64 0
  %1884 = getelementptr double, ptr %67, i64 %449
  %1885 = getelementptr double, ptr %1884, i64 %1883
  %1886 = load double, ptr %1885, align 8, !noalias !5
  %1887 = call double @llvm.fabs.f64(double %1886)
  %1888 = fcmp olt double %1887, 1.000000e-05
  %1889 = select i1 %1888, double 1.000000e-05, double %1887
  %1890 = fmul double %1889, 1.500000e-08
  %1891 = fadd double %1886, %1890
  %1892 = fsub double %1891, %1886
  %1893 = select i1 %1882, i64 %76, i64 0
  %1894 = getelementptr double, ptr %77, i64 %449
  %1895 = getelementptr double, ptr %1894, i64 %1893
  store double %1891, ptr %1895, align 8, !noalias !5
  %1896 = getelementptr i8, ptr %112, i64 24
  %1897 = load i64, ptr %1896, align 8, !noalias !5
  %1898 = add nsw i64 %1897, 1
  store i64 %1898, ptr %1896, align 8, !noalias !5
  store ptr null, ptr %19, align 8, !noalias !100
  store ptr null, ptr %20, align 8, !noalias !100
  store double %392, ptr %35, align 8, !noalias !100
  %1899 = icmp sgt i64 %47, 0
  br i1 %1899, label %1900, label %1903

1900:                                             ; preds = %1879
  store ptr null, ptr %19, align 8, !noalias !100
  %1901 = call fastcc i32 @_sample(ptr nonnull %19, ptr %40, i64 %39, ptr %50, i64 %47, i64 %49, ptr %55, i64 %54, ptr %62, i64 %59, i64 %61, double %392) #3
  switch i32 %1901, label %1902 [
    i32 -2, label %1903
    i32 0, label %1903
  ], !prof !25

1902:                                             ; preds = %1900
  br label %1903

1903:                                             ; preds = %1900, %1900, %1879, %1902
  %1904 = phi i32 [ %1901, %1902 ], [ 0, %1879 ], [ 0, %1900 ], [ 0, %1900 ]
  switch i32 %1904, label %1909 [
    i32 -2, label %1905
    i32 0, label %1905
  ], !prof !25

1905:                                             ; preds = %1903, %1903
  %1906 = load i64, ptr %32, align 8, !noalias !107
  %1907 = inttoptr i64 %1906 to ptr
  %1908 = call i32 %1907(ptr nonnull %35, ptr %77, ptr %40, ptr %43, ptr %72) #3, !noalias !107
  br label %1909

1909:                                             ; preds = %1903, %1905
  %1910 = phi i32 [ %1908, %1905 ], [ 0, %1903 ]
  %1911 = phi i32 [ 0, %1905 ], [ %1904, %1903 ]
  switch i32 %1911, label %1914 [
    i32 -2, label %1912
    i32 0, label %1912
  ], !prof !25

1912:                                             ; preds = %1909, %1909
  %1913 = icmp eq i32 %1910, 0
  br i1 %1913, label %454, label %452

1914:                                             ; preds = %1909
  br label %2151

1915:                                             ; preds = %454
  %1916 = add nsw i64 %456, -1
  %1917 = add i64 %455, 1
  %1918 = icmp slt i64 %455, 0
  %1919 = select i1 %1918, i64 %71, i64 0
  %1920 = getelementptr double, ptr %72, i64 %455
  %1921 = getelementptr double, ptr %1920, i64 %1919
  %1922 = load double, ptr %1921, align 8, !noalias !5
  %1923 = select i1 %1918, i64 %86, i64 0
  %1924 = getelementptr double, ptr %87, i64 %455
  %1925 = getelementptr double, ptr %1924, i64 %1923
  %1926 = load double, ptr %1925, align 8, !noalias !5
  %1927 = fsub double %1922, %1926
  %1928 = fdiv double %1927, %1892
  %1929 = mul nsw i64 %455, %429
  %1930 = add nsw i64 %1929, %449
  %1931 = icmp slt i64 %1930, 0
  %1932 = select i1 %1931, i64 %208, i64 0
  %1933 = getelementptr double, ptr %209, i64 %1930
  %1934 = getelementptr double, ptr %1933, i64 %1932
  store double %1928, ptr %1934, align 8, !noalias !5
  br label %454

1935:                                             ; preds = %478
  %1936 = add nsw i64 %480, -1
  %1937 = add i64 %479, 1
  br label %482

1938:                                             ; preds = %482
  %1939 = add nsw i64 %484, -1
  %1940 = add i64 %483, 1
  %1941 = mul nsw i64 %479, %275
  %1942 = add nsw i64 %1941, %483
  %1943 = icmp slt i64 %1942, 0
  %1944 = select i1 %1943, i64 %208, i64 0
  %1945 = getelementptr double, ptr %209, i64 %1942
  %1946 = getelementptr double, ptr %1945, i64 %1944
  %1947 = load double, ptr %1946, align 8, !noalias !5
  %1948 = fneg double %1947
  %1949 = icmp slt i64 %479, 0
  %1950 = select i1 %1949, i64 %213, i64 0
  %1951 = add i64 %479, %1950
  %1952 = icmp slt i64 %483, 0
  %1953 = select i1 %1952, i64 %215, i64 0
  %1954 = mul i64 %1951, %215
  %1955 = getelementptr double, ptr %216, i64 %1954
  %1956 = getelementptr double, ptr %1955, i64 %483
  %1957 = getelementptr double, ptr %1956, i64 %1953
  store double %1948, ptr %1957, align 8, !noalias !5
  %1958 = load double, ptr %1946, align 8, !noalias !5
  %1959 = fneg double %1958
  %1960 = select i1 %1949, i64 %220, i64 0
  %1961 = add i64 %479, %1960
  %1962 = select i1 %1952, i64 %222, i64 0
  %1963 = mul i64 %1961, %222
  %1964 = getelementptr { double, double }, ptr %223, i64 %1963
  %1965 = getelementptr { double, double }, ptr %1964, i64 %483
  %1966 = getelementptr { double, double }, ptr %1965, i64 %1962
  store double %1959, ptr %1966, align 8, !noalias !5
  %1967 = getelementptr inbounds nuw i8, ptr %1966, i64 8
  store double 0.000000e+00, ptr %1967, align 8, !noalias !5
  br label %482

1968:                                             ; preds = %791
  %1969 = add nsw i64 %793, -1
  %1970 = add i64 %792, 1
  %1971 = fcmp ogt double %790, 0.000000e+00
  br i1 %1971, label %795, label %804

1972:                                             ; preds = %806
  %1973 = add nsw i64 %808, -1
  %1974 = add i64 %807, 1
  br i1 %1971, label %810, label %850

1975:                                             ; preds = %860
  %1976 = add nsw i64 %862, -1
  %1977 = add i64 %861, 1
  br label %864

1978:                                             ; preds = %864
  %1979 = add nsw i64 %866, -1
  %1980 = add i64 %865, 1
  %1981 = icmp slt i64 %861, 0
  %1982 = add i64 %861, 3
  %1983 = select i1 %1981, i64 %1982, i64 %861
  %1984 = mul i64 %1983, 24
  %1985 = getelementptr i8, ptr @1, i64 %1984
  %1986 = load double, ptr %1985, align 8, !noalias !5
  %1987 = icmp slt i64 %865, 0
  %1988 = select i1 %1987, i64 %239, i64 0
  %1989 = getelementptr double, ptr %240, i64 %865
  %1990 = getelementptr double, ptr %1989, i64 %1988
  %1991 = load double, ptr %1990, align 8, !noalias !5
  %1992 = fmul double %1986, %1991
  %1993 = getelementptr i8, ptr @2, i64 %1984
  %1994 = getelementptr i8, ptr %1993, i64 8
  %1995 = load double, ptr %1994, align 8, !noalias !5
  %1996 = getelementptr double, ptr %240, i64 %239
  %1997 = getelementptr double, ptr %1996, i64 %865
  %1998 = getelementptr double, ptr %1997, i64 %1988
  %1999 = load double, ptr %1998, align 8, !noalias !5
  %2000 = fmul double %1995, %1999
  %2001 = fadd double %1992, %2000
  %2002 = getelementptr i8, ptr @3, i64 %1984
  %2003 = getelementptr i8, ptr %2002, i64 16
  %2004 = load double, ptr %2003, align 8, !noalias !5
  %2005 = shl i64 %239, 4
  %2006 = getelementptr i8, ptr %240, i64 %2005
  %2007 = getelementptr double, ptr %2006, i64 %865
  %2008 = getelementptr double, ptr %2007, i64 %1988
  %2009 = load double, ptr %2008, align 8, !noalias !5
  %2010 = fmul double %2004, %2009
  %2011 = fadd double %2001, %2010
  %2012 = select i1 %1981, i64 %244, i64 0
  %2013 = add i64 %861, %2012
  %2014 = select i1 %1987, i64 %246, i64 0
  %2015 = mul i64 %2013, %246
  %2016 = getelementptr double, ptr %247, i64 %2015
  %2017 = getelementptr double, ptr %2016, i64 %865
  %2018 = getelementptr double, ptr %2017, i64 %2014
  store double %2011, ptr %2018, align 8, !noalias !5
  br label %864

2019:                                             ; preds = %1368, %1368
  %2020 = icmp slt i64 %1372, 0
  br i1 %2020, label %1374, label %1375

2021:                                             ; preds = %1368
  br label %2151

2022:                                             ; preds = %1376
  %2023 = add nsw i64 %1378, -1
  %2024 = add i64 %1377, 1
  %2025 = icmp slt i64 %1377, 0
  %2026 = select i1 %2025, i64 %66, i64 0
  %2027 = getelementptr double, ptr %67, i64 %1377
  %2028 = getelementptr double, ptr %2027, i64 %2026
  %2029 = load double, ptr %2028, align 8, !noalias !5
  %2030 = select i1 %2025, i64 %239, i64 0
  %2031 = shl i64 %239, 4
  %2032 = getelementptr i8, ptr %240, i64 %2031
  %2033 = getelementptr double, ptr %2032, i64 %1377
  %2034 = getelementptr double, ptr %2033, i64 %2030
  %2035 = load double, ptr %2034, align 8, !noalias !5
  %2036 = fadd double %2029, %2035
  %2037 = select i1 %2025, i64 %71, i64 0
  %2038 = getelementptr double, ptr %72, i64 %1377
  %2039 = getelementptr double, ptr %2038, i64 %2037
  store double %2036, ptr %2039, align 8, !noalias !5
  br label %1376

2040:                                             ; preds = %1499, %1499
  %2041 = icmp slt i64 %1501, 0
  br i1 %2041, label %1503, label %1504

2042:                                             ; preds = %1499
  br label %2151

2043:                                             ; preds = %1544
  %2044 = add nsw i64 %1546, -1
  %2045 = add i64 %1545, 1
  %2046 = icmp slt i64 %1545, 0
  %2047 = select i1 %2046, i64 %239, i64 0
  %2048 = getelementptr double, ptr %240, i64 %1545
  %2049 = getelementptr double, ptr %2048, i64 %2047
  %2050 = load double, ptr %2049, align 8, !noalias !5
  %2051 = fmul double %2050, 0xC039A12CE7B30915
  %2052 = getelementptr double, ptr %240, i64 %239
  %2053 = getelementptr double, ptr %2052, i64 %1545
  %2054 = getelementptr double, ptr %2053, i64 %2047
  %2055 = load double, ptr %2054, align 8, !noalias !5
  %2056 = fmul double %2055, 0x402497AF24BB677E
  %2057 = fadd double %2051, %2056
  %2058 = shl i64 %239, 4
  %2059 = getelementptr i8, ptr %240, i64 %2058
  %2060 = getelementptr double, ptr %2059, i64 %1545
  %2061 = getelementptr double, ptr %2060, i64 %2047
  %2062 = load double, ptr %2061, align 8, !noalias !5
  %2063 = fmul double %2062, 0xC005555555555555
  %2064 = fadd double %2057, %2063
  %2065 = fmul double %2050, 0x402F295C43B61425
  %2066 = fmul double %2055, 0xC021D406EE60BECF
  %2067 = fadd double %2065, %2066
  %2068 = fmul double %2062, 0x400AAAAAAAAAAAAB
  %2069 = fadd double %2067, %2068
  %2070 = select i1 %2046, i64 %71, i64 0
  %2071 = getelementptr double, ptr %72, i64 %1545
  %2072 = getelementptr double, ptr %2071, i64 %2070
  %2073 = load double, ptr %2072, align 8, !noalias !5
  %2074 = select i1 %2046, i64 %66, i64 0
  %2075 = getelementptr double, ptr %67, i64 %1545
  %2076 = getelementptr double, ptr %2075, i64 %2074
  %2077 = load double, ptr %2076, align 8, !noalias !5
  %2078 = fsub double %2073, %2077
  %2079 = select i1 %2046, i64 %91, i64 0
  %2080 = getelementptr double, ptr %92, i64 %1545
  %2081 = getelementptr double, ptr %2080, i64 %2079
  store double %2078, ptr %2081, align 8, !noalias !5
  %2082 = fneg double %2064
  %2083 = fsub double %2082, %2069
  %2084 = add nsw i64 %66, %1545
  %2085 = icmp slt i64 %2084, 0
  %2086 = select i1 %2085, i64 %91, i64 0
  %2087 = getelementptr double, ptr %92, i64 %2084
  %2088 = getelementptr double, ptr %2087, i64 %2086
  store double %2083, ptr %2088, align 8, !noalias !5
  %2089 = fneg double %2069
  %2090 = shl nsw i64 %66, 1
  %2091 = add nsw i64 %2090, %1545
  %2092 = icmp slt i64 %2091, 0
  %2093 = select i1 %2092, i64 %91, i64 0
  %2094 = getelementptr double, ptr %92, i64 %2091
  %2095 = getelementptr double, ptr %2094, i64 %2093
  store double %2089, ptr %2095, align 8, !noalias !5
  %2096 = load double, ptr %2076, align 8, !noalias !5
  %2097 = select i1 %2046, i64 %258, i64 0
  %2098 = getelementptr double, ptr %259, i64 %1545
  %2099 = getelementptr double, ptr %2098, i64 %2097
  store double %2096, ptr %2099, align 8, !noalias !5
  br label %1548

2100:                                             ; preds = %1548
  %2101 = add nsw i64 %1550, -1
  %2102 = add i64 %1549, 1
  %2103 = mul nsw i64 %1549, %66
  %2104 = add nsw i64 %2103, %1545
  %2105 = icmp slt i64 %2104, 0
  %2106 = select i1 %2105, i64 %91, i64 0
  %2107 = getelementptr double, ptr %92, i64 %2104
  %2108 = getelementptr double, ptr %2107, i64 %2106
  %2109 = load double, ptr %2108, align 8, !noalias !5
  %2110 = icmp slt i64 %1549, -1
  %2111 = select i1 %2110, i64 %256, i64 0
  %2112 = add i64 %2102, %2111
  %2113 = mul i64 %2112, %258
  %2114 = getelementptr double, ptr %259, i64 %2113
  %2115 = getelementptr double, ptr %2114, i64 %1545
  %2116 = getelementptr double, ptr %2115, i64 %2097
  store double %2109, ptr %2116, align 8, !noalias !5
  br label %1548

2117:                                             ; preds = %1596, %2126
  %2118 = phi i64 [ 0, %1596 ], [ %2128, %2126 ]
  %2119 = phi i64 [ %1608, %1596 ], [ %2127, %2126 ]
  %2120 = icmp sgt i64 %2119, 0
  br i1 %2120, label %2126, label %2121

2121:                                             ; preds = %2117
  %2122 = getelementptr i8, ptr %29, i64 24
  %2123 = load i64, ptr %2122, align 8, !noalias !108
  %2124 = getelementptr i8, ptr %32, i64 16
  %2125 = load i64, ptr %2124, align 8, !noalias !108
  call fastcc void @pydy_nested(i64 %1607, i64 %64, i64 %89, i64 %66, i64 %2123, i64 %79, i64 %2125) #3, !noalias !108
  br i1 %1585, label %1609, label %1616

2126:                                             ; preds = %2117
  %2127 = add nsw i64 %2119, -1
  %2128 = add i64 %2118, 1
  %2129 = icmp slt i64 %2118, 0
  %2130 = select i1 %2129, i64 %81, i64 0
  %2131 = getelementptr double, ptr %82, i64 %2118
  %2132 = getelementptr double, ptr %2131, i64 %2130
  store double %1604, ptr %2132, align 8, !noalias !108
  br label %2117

2133:                                             ; preds = %1647
  %2134 = load i64, ptr %159, align 8, !noalias !5
  %2135 = icmp eq i64 %2134, 1
  br i1 %2135, label %1669, label %1674

2136:                                             ; preds = %1682
  store double %1582, ptr %107, align 8, !noalias !5
  store double 0.000000e+00, ptr %300, align 8, !noalias !5
  store i64 0, ptr %112, align 8, !noalias !5
  br label %1697

2137:                                             ; preds = %1702
  %2138 = add nsw i64 %1704, -1
  %2139 = add i64 %1703, 1
  %2140 = icmp slt i64 %1703, 0
  %2141 = select i1 %2140, i64 %71, i64 0
  %2142 = getelementptr double, ptr %72, i64 %1703
  %2143 = getelementptr double, ptr %2142, i64 %2141
  %2144 = load double, ptr %2143, align 8, !noalias !5
  %2145 = select i1 %2140, i64 %66, i64 0
  %2146 = getelementptr double, ptr %67, i64 %1703
  %2147 = getelementptr double, ptr %2146, i64 %2145
  store double %2144, ptr %2147, align 8, !noalias !5
  br label %1702

2148:                                             ; preds = %1720, %1720
  %2149 = icmp eq i32 %1721, 0
  br i1 %2149, label %1727, label %1723

2150:                                             ; preds = %1720
  br label %2151

2151:                                             ; preds = %2150, %2042, %2021, %1914, %1867, %1861, %1824, %1804, %1791, %1790, %1723, %1700, %1521, %1503, %1374, %463, %406, %395, %377, %321, %194
  %2152 = phi i64 [ -4, %1503 ], [ -1, %194 ], [ 2, %1790 ], [ %1699, %1700 ], [ 0, %1791 ], [ %1726, %1723 ], [ 0, %2021 ], [ 0, %1804 ], [ %324, %321 ], [ -4, %1374 ], [ 0, %377 ], [ 0, %1824 ], [ 0, %1861 ], [ 0, %2150 ], [ -1, %395 ], [ 1, %406 ], [ 6, %1521 ], [ 0, %1867 ], [ -4, %463 ], [ 0, %1914 ], [ 0, %2042 ]
  ret i64 %2152
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
!65 = !{!"branch_weights", i32 49, i32 1}
!66 = !{!67, !69, !54, !56}
!67 = distinct !{!67, !68}
!68 = distinct !{!68}
!69 = distinct !{!69, !68}
!70 = !{!71, !73}
!71 = distinct !{!71, !72}
!72 = distinct !{!72}
!73 = distinct !{!73, !72}
!74 = !{!75, !77, !78, !80, !71, !73}
!75 = distinct !{!75, !76}
!76 = distinct !{!76}
!77 = distinct !{!77, !76}
!78 = distinct !{!78, !79}
!79 = distinct !{!79}
!80 = distinct !{!80, !79}
!81 = !{!78, !80, !71, !73}
!82 = !{!83, !85, !6, !8}
!83 = distinct !{!83, !84}
!84 = distinct !{!84}
!85 = distinct !{!85, !84}
!86 = !{!87}
!87 = distinct !{!87, !88}
!88 = distinct !{!88}
!89 = !{!90}
!90 = distinct !{!90, !91}
!91 = distinct !{!91}
!92 = !{!93, !95, !96, !98}
!93 = distinct !{!93, !94}
!94 = distinct !{!94}
!95 = distinct !{!95, !94}
!96 = distinct !{!96, !97}
!97 = distinct !{!97}
!98 = distinct !{!98, !97}
!99 = !{!96, !98}
!100 = !{!101, !103, !104, !106}
!101 = distinct !{!101, !102}
!102 = distinct !{!102}
!103 = distinct !{!103, !102}
!104 = distinct !{!104, !105}
!105 = distinct !{!105}
!106 = distinct !{!106, !105}
!107 = !{!104, !106}
!108 = !{!109, !111, !6, !8}
!109 = distinct !{!109, !110}
!110 = distinct !{!110}
!111 = distinct !{!111, !110}
