; sources bc095f0dae153b65d72a0a1b23f9ba988efda6331652bb62975f0e5d481ba0f2
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

declare <8 x double> @llvm.ceil.v8f64(<8 x double>) #0

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #0

declare <8 x double> @llvm.rint.v8f64(<8 x double>) #0

declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #0

define internal fastcc i32 @_set_inputs(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, ptr %5, i64 %6, i64 %7, ptr %8, i64 %9, i64 %10, ptr %11, i64 %12, ptr %13, i64 %14, i64 %15) unnamed_addr #1 {
  %17 = call i64 @llvm.smax.i64(i64 %6, i64 0)
  br label %18

18:                                               ; preds = %22, %16
  %19 = phi i64 [ 0, %16 ], [ %29, %22 ]
  %20 = phi i64 [ %17, %16 ], [ %28, %22 ]
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %27, label %26

22:                                               ; preds = %118, %45
  %23 = phi i64 [ 0, %45 ], [ %68, %118 ]
  %24 = phi i64 [ 8, %45 ], [ %67, %118 ]
  %25 = icmp sgt i64 %24, 0
  br i1 %25, label %66, label %18

26:                                               ; preds = %18
  store ptr null, ptr %0, align 8
  ret i32 0

27:                                               ; preds = %18
  %28 = add nsw i64 %20, -1
  %29 = add i64 %19, 1
  %30 = icmp slt i64 %19, 0
  %31 = select i1 %30, i64 %6, i64 0
  %32 = add i64 %19, %31
  %33 = mul i64 %32, %7
  %34 = getelementptr i64, ptr %5, i64 %33
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr i8, ptr %34, i64 8
  %37 = load i64, ptr %36, align 8
  %38 = getelementptr i8, ptr %34, i64 16
  %39 = load i64, ptr %38, align 8
  %40 = add nsw i64 %37, %39
  %41 = icmp slt i64 %37, 0
  %42 = select i1 %41, i64 %12, i64 0
  %43 = add i64 %37, %42
  %44 = icmp slt i64 %43, 0
  br i1 %44, label %50, label %51, !prof !0

45:                                               ; preds = %65, %62
  %46 = phi i64 [ %12, %65 ], [ %63, %62 ]
  %47 = sub i64 %46, %56
  %48 = call i64 @llvm.smax.i64(i64 %47, i64 0)
  %49 = getelementptr double, ptr %11, i64 %56
  br label %22

50:                                               ; preds = %27
  br label %51

51:                                               ; preds = %50, %27
  %52 = phi i64 [ 0, %50 ], [ %43, %27 ]
  %53 = icmp slt i64 %43, %12
  br i1 %53, label %55, label %54, !prof !1

54:                                               ; preds = %51
  br label %55

55:                                               ; preds = %54, %51
  %56 = phi i64 [ %12, %54 ], [ %52, %51 ]
  %57 = icmp slt i64 %40, 0
  %58 = select i1 %57, i64 %12, i64 0
  %59 = add i64 %40, %58
  %60 = icmp slt i64 %59, 0
  br i1 %60, label %61, label %62, !prof !0

61:                                               ; preds = %55
  br label %62

62:                                               ; preds = %61, %55
  %63 = phi i64 [ 0, %61 ], [ %59, %55 ]
  %64 = icmp slt i64 %59, %12
  br i1 %64, label %45, label %65, !prof !1

65:                                               ; preds = %62
  br label %45

66:                                               ; preds = %22
  %67 = add nsw i64 %24, -1
  %68 = add i64 %23, 1
  %69 = icmp slt i64 %23, 0
  %70 = select i1 %69, i64 %2, i64 0
  %71 = getelementptr double, ptr %1, i64 %23
  %72 = getelementptr double, ptr %71, i64 %70
  %73 = load double, ptr %72, align 8
  %74 = load double, ptr %49, align 8
  %75 = fcmp ogt double %74, %73
  %76 = select i1 %75, double %74, double %73
  %77 = select i1 %30, i64 %9, i64 0
  %78 = add i64 %19, %77
  %79 = select i1 %69, i64 %10, i64 0
  %80 = mul i64 %78, %10
  %81 = getelementptr i64, ptr %8, i64 %80
  %82 = getelementptr i64, ptr %81, i64 %23
  %83 = getelementptr i64, ptr %82, i64 %79
  %84 = load i64, ptr %83, align 8
  %85 = icmp slt i64 %84, 0
  %86 = select i1 %85, i64 %48, i64 0
  %87 = getelementptr double, ptr %49, i64 %84
  %88 = getelementptr double, ptr %87, i64 %86
  %89 = load double, ptr %88, align 8, !noalias !2
  %90 = fcmp ugt double %89, %76
  br i1 %90, label %101, label %91

91:                                               ; preds = %66
  %92 = add nsw i64 %48, -1
  %93 = icmp eq i64 %84, %92
  br i1 %93, label %118, label %94

94:                                               ; preds = %91
  %95 = icmp slt i64 %84, -1
  %96 = select i1 %95, i64 %48, i64 0
  %97 = getelementptr i8, ptr %87, i64 8
  %98 = getelementptr double, ptr %97, i64 %96
  %99 = load double, ptr %98, align 8, !noalias !2
  %100 = fcmp olt double %76, %99
  br i1 %100, label %118, label %101

101:                                              ; preds = %94, %66
  %102 = icmp sgt i64 %47, 1
  br i1 %102, label %103, label %118

103:                                              ; preds = %103, %101
  %104 = phi i64 [ %114, %103 ], [ %48, %101 ]
  %105 = phi i64 [ %115, %103 ], [ 0, %101 ]
  %106 = add nsw i64 %105, %104
  %107 = ashr i64 %106, 1
  %108 = icmp slt i64 %107, 0
  %109 = select i1 %108, i64 %48, i64 0
  %110 = getelementptr double, ptr %49, i64 %107
  %111 = getelementptr double, ptr %110, i64 %109
  %112 = load double, ptr %111, align 8, !noalias !2
  %113 = fcmp ole double %112, %76
  %114 = select i1 %113, i64 %104, i64 %107
  %115 = select i1 %113, i64 %107, i64 %105
  %116 = sub nsw i64 %114, %115
  %117 = icmp sgt i64 %116, 1
  br i1 %117, label %103, label %118

118:                                              ; preds = %103, %101, %94, %91
  %119 = phi i64 [ %84, %91 ], [ %84, %94 ], [ %115, %103 ], [ 0, %101 ]
  store i64 %119, ptr %83, align 8
  %120 = icmp slt i64 %119, 0
  %121 = select i1 %120, i64 %48, i64 0
  %122 = getelementptr double, ptr %49, i64 %119
  %123 = getelementptr double, ptr %122, i64 %121
  %124 = load double, ptr %123, align 8
  %125 = fsub double %76, %124
  %126 = add nsw i64 %37, %119
  %127 = icmp slt i64 %126, 0
  %128 = select i1 %127, i64 %14, i64 0
  %129 = add i64 %126, %128
  %130 = mul i64 %129, %15
  %131 = getelementptr double, ptr %13, i64 %130
  %132 = load double, ptr %131, align 8
  %133 = getelementptr i8, ptr %131, i64 8
  %134 = load double, ptr %133, align 8
  %135 = getelementptr i8, ptr %131, i64 16
  %136 = load double, ptr %135, align 8
  %137 = getelementptr i8, ptr %131, i64 24
  %138 = load double, ptr %137, align 8
  %139 = fmul double %125, %138
  %140 = fadd double %136, %139
  %141 = fmul double %125, %140
  %142 = fadd double %134, %141
  %143 = fmul double %125, %142
  %144 = fadd double %132, %143
  %145 = shl nsw i64 %35, 3
  %146 = add nsw i64 %145, %23
  %147 = icmp slt i64 %146, 0
  %148 = select i1 %147, i64 %4, i64 0
  %149 = getelementptr double, ptr %3, i64 %146
  %150 = getelementptr double, ptr %149, i64 %148
  store double %144, ptr %150, align 8
  br label %22
}

declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #0

declare i64 @llvm.cttz.i64(i64, i1 immarg) #2

define internal fastcc void @pydy_combine(i64 %0, i64 %1, i64 %2, i64 %3, i64 %4, i64 %5, i64 %6, i64 %7) unnamed_addr #1 {
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

define internal fastcc void @pydy_nested(i64 %0, i64 %1, i64 %2, i64 %3, i64 %4, i64 %5, i64 %6) unnamed_addr #1 {
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

define i64 @step_lanes(i64 %0) local_unnamed_addr #3 {
  %2 = alloca ptr, align 8
  %3 = alloca ptr, align 8
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
  %14 = inttoptr i64 %0 to ptr
  %15 = load i64, ptr %14, align 8, !noalias !5
  %16 = inttoptr i64 %15 to ptr
  %17 = getelementptr i8, ptr %14, i64 24
  %18 = load i64, ptr %17, align 8, !noalias !5
  %19 = getelementptr i8, ptr %14, i64 32
  %20 = load i64, ptr %19, align 8, !noalias !5
  %21 = inttoptr i64 %18 to ptr
  %22 = getelementptr i8, ptr %14, i64 48
  %23 = load i64, ptr %22, align 8, !noalias !5
  %24 = getelementptr i8, ptr %14, i64 72
  %25 = load i64, ptr %24, align 8, !noalias !5
  %26 = getelementptr i8, ptr %14, i64 96
  %27 = load i64, ptr %26, align 8, !noalias !5
  %28 = getelementptr i8, ptr %14, i64 104
  %29 = load i64, ptr %28, align 8, !noalias !5
  %30 = inttoptr i64 %27 to ptr
  %31 = getelementptr i8, ptr %14, i64 120
  %32 = load i64, ptr %31, align 8, !noalias !5
  %33 = inttoptr i64 %32 to ptr
  %34 = getelementptr i8, ptr %14, i64 144
  %35 = load i64, ptr %34, align 8, !noalias !5
  %36 = inttoptr i64 %35 to ptr
  %37 = getelementptr i8, ptr %14, i64 168
  %38 = load i64, ptr %37, align 8, !noalias !5
  %39 = getelementptr i8, ptr %14, i64 176
  %40 = load i64, ptr %39, align 8, !noalias !5
  %41 = inttoptr i64 %38 to ptr
  %42 = getelementptr i8, ptr %14, i64 192
  %43 = load i64, ptr %42, align 8, !noalias !5
  %44 = getelementptr i8, ptr %14, i64 200
  %45 = load i64, ptr %44, align 8, !noalias !5
  %46 = inttoptr i64 %43 to ptr
  %47 = getelementptr i8, ptr %14, i64 216
  %48 = load i64, ptr %47, align 8, !noalias !5
  %49 = getelementptr i8, ptr %14, i64 224
  %50 = load i64, ptr %49, align 8, !noalias !5
  %51 = inttoptr i64 %48 to ptr
  %52 = getelementptr i8, ptr %14, i64 240
  %53 = load i64, ptr %52, align 8, !noalias !5
  %54 = inttoptr i64 %53 to ptr
  %55 = getelementptr i8, ptr %14, i64 264
  %56 = load i64, ptr %55, align 8, !noalias !5
  %57 = getelementptr i8, ptr %14, i64 272
  %58 = load i64, ptr %57, align 8, !noalias !5
  %59 = getelementptr i8, ptr %14, i64 280
  %60 = load i64, ptr %59, align 8, !noalias !5
  %61 = inttoptr i64 %56 to ptr
  %62 = getelementptr i8, ptr %14, i64 288
  %63 = load i64, ptr %62, align 8, !noalias !5
  %64 = getelementptr i8, ptr %14, i64 296
  %65 = load i64, ptr %64, align 8, !noalias !5
  %66 = getelementptr i8, ptr %14, i64 304
  %67 = load i64, ptr %66, align 8, !noalias !5
  %68 = inttoptr i64 %63 to ptr
  %69 = getelementptr i8, ptr %14, i64 312
  %70 = load i64, ptr %69, align 8, !noalias !5
  %71 = getelementptr i8, ptr %14, i64 320
  %72 = load i64, ptr %71, align 8, !noalias !5
  %73 = inttoptr i64 %70 to ptr
  %74 = getelementptr i8, ptr %14, i64 336
  %75 = load i64, ptr %74, align 8, !noalias !5
  %76 = getelementptr i8, ptr %14, i64 344
  %77 = load i64, ptr %76, align 8, !noalias !5
  %78 = getelementptr i8, ptr %14, i64 352
  %79 = load i64, ptr %78, align 8, !noalias !5
  %80 = inttoptr i64 %75 to ptr
  %81 = getelementptr i8, ptr %14, i64 360
  %82 = load i64, ptr %81, align 8, !noalias !5
  %83 = getelementptr i8, ptr %14, i64 368
  %84 = load i64, ptr %83, align 8, !noalias !5
  %85 = inttoptr i64 %82 to ptr
  %86 = getelementptr i8, ptr %14, i64 384
  %87 = load i64, ptr %86, align 8, !noalias !5
  %88 = getelementptr i8, ptr %14, i64 392
  %89 = load i64, ptr %88, align 8, !noalias !5
  %90 = inttoptr i64 %87 to ptr
  %91 = getelementptr i8, ptr %14, i64 408
  %92 = load i64, ptr %91, align 8, !noalias !5
  %93 = getelementptr i8, ptr %14, i64 416
  %94 = load i64, ptr %93, align 8, !noalias !5
  %95 = inttoptr i64 %92 to ptr
  %96 = getelementptr i8, ptr %14, i64 432
  %97 = load i64, ptr %96, align 8, !noalias !5
  %98 = inttoptr i64 %97 to ptr
  %99 = getelementptr i8, ptr %14, i64 456
  %100 = load i64, ptr %99, align 8, !noalias !5
  %101 = inttoptr i64 %100 to ptr
  %102 = getelementptr i8, ptr %14, i64 480
  %103 = load i64, ptr %102, align 8, !noalias !5
  %104 = inttoptr i64 %103 to ptr
  %105 = getelementptr i8, ptr %14, i64 504
  %106 = load i64, ptr %105, align 8, !noalias !5
  %107 = inttoptr i64 %106 to ptr
  %108 = getelementptr i8, ptr %14, i64 528
  %109 = load i64, ptr %108, align 8, !noalias !5
  %110 = getelementptr i8, ptr %14, i64 536
  %111 = load i64, ptr %110, align 8, !noalias !5
  %112 = inttoptr i64 %109 to ptr
  %113 = getelementptr i8, ptr %14, i64 552
  %114 = load i64, ptr %113, align 8, !noalias !5
  %115 = inttoptr i64 %114 to ptr
  %116 = getelementptr i8, ptr %14, i64 576
  %117 = load i64, ptr %116, align 8, !noalias !5
  %118 = getelementptr i8, ptr %14, i64 584
  %119 = load i64, ptr %118, align 8, !noalias !5
  %120 = inttoptr i64 %117 to ptr
  %121 = getelementptr i8, ptr %14, i64 600
  %122 = load i64, ptr %121, align 8, !noalias !5
  %123 = getelementptr i8, ptr %14, i64 608
  %124 = load i64, ptr %123, align 8, !noalias !5
  %125 = inttoptr i64 %122 to ptr
  %126 = getelementptr i8, ptr %14, i64 624
  %127 = load i64, ptr %126, align 8, !noalias !5
  %128 = getelementptr i8, ptr %14, i64 632
  %129 = load i64, ptr %128, align 8, !noalias !5
  %130 = inttoptr i64 %127 to ptr
  %131 = getelementptr i8, ptr %14, i64 648
  %132 = load i64, ptr %131, align 8, !noalias !5
  %133 = getelementptr i8, ptr %14, i64 656
  %134 = load i64, ptr %133, align 8, !noalias !5
  %135 = inttoptr i64 %132 to ptr
  %136 = getelementptr i8, ptr %14, i64 672
  %137 = load i64, ptr %136, align 8, !noalias !5
  %138 = inttoptr i64 %137 to ptr
  %139 = getelementptr i8, ptr %14, i64 696
  %140 = load i64, ptr %139, align 8, !noalias !5
  %141 = inttoptr i64 %140 to ptr
  %142 = getelementptr i8, ptr %14, i64 720
  %143 = load i64, ptr %142, align 8, !noalias !5
  %144 = getelementptr i8, ptr %14, i64 728
  %145 = load i64, ptr %144, align 8, !noalias !5
  %146 = inttoptr i64 %143 to ptr
  %147 = getelementptr i8, ptr %14, i64 744
  %148 = load i64, ptr %147, align 8, !noalias !5
  %149 = getelementptr i8, ptr %14, i64 752
  %150 = load i64, ptr %149, align 8, !noalias !5
  %151 = inttoptr i64 %148 to ptr
  %152 = getelementptr i8, ptr %14, i64 768
  %153 = load i64, ptr %152, align 8, !noalias !5
  %154 = getelementptr i8, ptr %14, i64 776
  %155 = load i64, ptr %154, align 8, !noalias !5
  %156 = inttoptr i64 %153 to ptr
  %157 = getelementptr i8, ptr %14, i64 792
  %158 = load i64, ptr %157, align 8, !noalias !5
  %159 = getelementptr i8, ptr %14, i64 800
  %160 = load i64, ptr %159, align 8, !noalias !5
  %161 = inttoptr i64 %158 to ptr
  %162 = getelementptr i8, ptr %14, i64 816
  %163 = load i64, ptr %162, align 8, !noalias !5
  %164 = getelementptr i8, ptr %14, i64 824
  %165 = load i64, ptr %164, align 8, !noalias !5
  %166 = inttoptr i64 %163 to ptr
  %167 = getelementptr i8, ptr %14, i64 840
  %168 = load i64, ptr %167, align 8, !noalias !5
  %169 = getelementptr i8, ptr %14, i64 848
  %170 = load i64, ptr %169, align 8, !noalias !5
  %171 = inttoptr i64 %168 to ptr
  %172 = getelementptr i8, ptr %14, i64 864
  %173 = load i64, ptr %172, align 8, !noalias !5
  %174 = getelementptr i8, ptr %14, i64 872
  %175 = load i64, ptr %174, align 8, !noalias !5
  %176 = inttoptr i64 %173 to ptr
  %177 = getelementptr i8, ptr %14, i64 888
  %178 = load i64, ptr %177, align 8, !noalias !5
  %179 = getelementptr i8, ptr %14, i64 896
  %180 = load i64, ptr %179, align 8, !noalias !5
  %181 = inttoptr i64 %178 to ptr
  %182 = getelementptr i8, ptr %14, i64 912
  %183 = load i64, ptr %182, align 8, !noalias !5
  %184 = inttoptr i64 %183 to ptr
  %185 = getelementptr i8, ptr %14, i64 936
  %186 = load i64, ptr %185, align 8, !noalias !5
  %187 = inttoptr i64 %186 to ptr
  %188 = getelementptr i8, ptr %14, i64 960
  %189 = load i64, ptr %188, align 8, !noalias !5
  %190 = getelementptr i8, ptr %14, i64 968
  %191 = load i64, ptr %190, align 8, !noalias !5
  %192 = inttoptr i64 %189 to ptr
  %193 = getelementptr i8, ptr %14, i64 984
  %194 = load i64, ptr %193, align 8, !noalias !5
  %195 = getelementptr i8, ptr %14, i64 992
  %196 = load i64, ptr %195, align 8, !noalias !5
  %197 = getelementptr i8, ptr %14, i64 1000
  %198 = load i64, ptr %197, align 8, !noalias !5
  %199 = inttoptr i64 %194 to ptr
  %200 = getelementptr i8, ptr %14, i64 1008
  %201 = load i64, ptr %200, align 8, !noalias !5
  %202 = getelementptr i8, ptr %14, i64 1016
  %203 = load i64, ptr %202, align 8, !noalias !5
  %204 = getelementptr i8, ptr %14, i64 1024
  %205 = load i64, ptr %204, align 8, !noalias !5
  %206 = inttoptr i64 %201 to ptr
  %207 = getelementptr i8, ptr %14, i64 1032
  %208 = load i64, ptr %207, align 8, !noalias !5
  %209 = getelementptr i8, ptr %14, i64 1040
  %210 = load i64, ptr %209, align 8, !noalias !5
  %211 = getelementptr i8, ptr %14, i64 1048
  %212 = load i64, ptr %211, align 8, !noalias !5
  %213 = inttoptr i64 %208 to ptr
  %214 = getelementptr i8, ptr %14, i64 1056
  %215 = load i64, ptr %214, align 8, !noalias !5
  %216 = getelementptr i8, ptr %14, i64 1064
  %217 = load i64, ptr %216, align 8, !noalias !5
  %218 = getelementptr i8, ptr %14, i64 1072
  %219 = load i64, ptr %218, align 8, !noalias !5
  %220 = inttoptr i64 %215 to ptr
  %221 = getelementptr i8, ptr %14, i64 1080
  %222 = load i64, ptr %221, align 8, !noalias !5
  %223 = getelementptr i8, ptr %14, i64 1088
  %224 = load i64, ptr %223, align 8, !noalias !5
  %225 = inttoptr i64 %222 to ptr
  %226 = getelementptr i8, ptr %36, i64 16
  %227 = load i64, ptr %226, align 8, !noalias !5
  %228 = icmp slt i64 %191, 2
  %229 = select i1 %228, i64 %191, i64 0
  %230 = getelementptr double, ptr %192, i64 %191
  %231 = getelementptr i8, ptr %230, i64 -16
  %232 = getelementptr double, ptr %231, i64 %229
  %233 = load double, ptr %232, align 8, !noalias !5
  %234 = load double, ptr %187, align 8, !noalias !5
  %235 = load i64, ptr %16, align 8, !noalias !5
  %236 = mul nsw i64 %235, %84
  %237 = shl i64 %236, 3
  %238 = add i64 %109, %237
  %239 = mul nsw i64 %235, %227
  %240 = getelementptr i8, ptr %16, i64 8
  %241 = load i64, ptr %240, align 8, !noalias !5
  %242 = icmp sgt i64 %241, 0
  %243 = getelementptr i8, ptr %16, i64 32
  %244 = load i64, ptr %243, align 8, !noalias !5
  %245 = icmp ne i64 %244, 1
  %246 = add nsw i64 %235, -1
  %247 = add nsw i64 %246, %244
  %248 = sitofp i64 %247 to double
  %249 = sub nsw i64 1, %244
  %250 = sitofp i64 %249 to double
  %251 = getelementptr i8, ptr %184, i64 16
  %252 = load i64, ptr %251, align 8, !noalias !5
  %253 = sitofp i64 %252 to double
  br label %254

254:                                              ; preds = %1, %2158
  %255 = phi i64 [ 0, %1 ], [ %2160, %2158 ]
  %256 = phi i64 [ 8, %1 ], [ %2159, %2158 ]
  %257 = phi i64 [ 0, %1 ], [ %2169, %2158 ]
  %258 = icmp sgt i64 %256, 0
  br i1 %258, label %2158, label %259

259:                                              ; preds = %1141, %254
  %260 = phi i64 [ %257, %254 ], [ %1087, %1141 ]
  br label %261

261:                                              ; preds = %2156, %259
  %262 = phi i64 [ %260, %259 ], [ %1771, %2156 ]
  %263 = phi i1 [ true, %259 ], [ %2157, %2156 ]
  br i1 %263, label %264, label %1086

264:                                              ; preds = %261, %1085
  br label %265

265:                                              ; preds = %264, %300
  %266 = phi i64 [ 0, %264 ], [ %343, %300 ]
  %267 = phi i64 [ 8, %264 ], [ %342, %300 ]
  %268 = phi i64 [ 0, %264 ], [ %301, %300 ]
  %269 = phi i64 [ 0, %264 ], [ %306, %300 ]
  %270 = phi i64 [ -1, %264 ], [ %307, %300 ]
  %271 = icmp sgt i64 %267, 0
  br i1 %271, label %341, label %308

272:                                              ; preds = %341
  %273 = load i64, ptr %184, align 8, !noalias !9
  %274 = icmp slt i64 %273, %196
  br i1 %274, label %275, label %300

275:                                              ; preds = %272
  %276 = add nsw i64 %273, 1
  store i64 %276, ptr %184, align 8, !noalias !9
  store i64 %273, ptr %347, align 8, !noalias !9
  %277 = shl i64 %266, 3
  %278 = add i64 %82, %277
  %279 = call i64 @llvm.smax.i64(i64 %198, i64 0)
  br label %280

280:                                              ; preds = %275, %284
  %281 = phi i64 [ 0, %275 ], [ %286, %284 ]
  %282 = phi i64 [ %279, %275 ], [ %285, %284 ]
  %283 = icmp sgt i64 %282, 0
  br i1 %283, label %284, label %350

284:                                              ; preds = %280
  %285 = add nsw i64 %282, -1
  %286 = add i64 %281, 1
  %287 = shl nsw i64 %281, 6
  %288 = add nsw i64 %278, %287
  %289 = icmp slt i64 %273, 0
  %290 = select i1 %289, i64 %196, i64 0
  %291 = add i64 %273, %290
  %292 = icmp slt i64 %281, 0
  %293 = select i1 %292, i64 %198, i64 0
  %294 = mul i64 %291, %198
  %295 = getelementptr double, ptr %199, i64 %294
  %296 = getelementptr double, ptr %295, i64 %281
  %297 = getelementptr double, ptr %296, i64 %293
  %298 = load i64, ptr %297, align 8, !noalias !13
  %299 = inttoptr i64 %288 to ptr
  store atomic i64 %298, ptr %299 unordered, align 8, !noalias !13
  br label %280

300:                                              ; preds = %396, %272, %341
  %301 = phi i64 [ %402, %396 ], [ %268, %272 ], [ %268, %341 ]
  %302 = load i64, ptr %347, align 8, !noalias !9
  %303 = icmp sgt i64 %302, -1
  %304 = shl nuw i64 1, %266
  %305 = select i1 %303, i64 %304, i64 0
  %306 = or i64 %269, %305
  %307 = select i1 %303, i64 %266, i64 %270
  br label %265

308:                                              ; preds = %265
  %309 = icmp sgt i64 %270, -1
  br i1 %309, label %310, label %2170

310:                                              ; preds = %308, %336
  %311 = phi i64 [ %405, %336 ], [ 0, %308 ]
  %312 = phi i64 [ %404, %336 ], [ 8, %308 ]
  %313 = icmp sgt i64 %312, 0
  br i1 %313, label %403, label %337

314:                                              ; preds = %403
  %315 = load i64, ptr %226, align 8, !noalias !9
  %316 = shl i64 %311, 3
  %317 = add i64 %82, %316
  %318 = call i64 @llvm.smax.i64(i64 %315, i64 0)
  br label %319

319:                                              ; preds = %314, %323
  %320 = phi i64 [ 0, %314 ], [ %325, %323 ]
  %321 = phi i64 [ %318, %314 ], [ %324, %323 ]
  %322 = icmp sgt i64 %321, 0
  br i1 %322, label %323, label %412

323:                                              ; preds = %319
  %324 = add nsw i64 %321, -1
  %325 = add i64 %320, 1
  %326 = shl nsw i64 %320, 6
  %327 = add nsw i64 %317, %326
  %328 = shl nsw i64 %320, 3
  %329 = add nsw i64 %328, %270
  %330 = icmp slt i64 %329, 0
  %331 = select i1 %330, i64 %84, i64 0
  %332 = getelementptr double, ptr %85, i64 %329
  %333 = getelementptr double, ptr %332, i64 %331
  %334 = load i64, ptr %333, align 8, !noalias !17
  %335 = inttoptr i64 %327 to ptr
  store atomic i64 %334, ptr %335 unordered, align 8, !noalias !17
  br label %319

336:                                              ; preds = %477, %403
  br label %310

337:                                              ; preds = %310
  %338 = getelementptr i8, ptr %36, i64 8
  %339 = load i64, ptr %338, align 8, !noalias !9
  %340 = inttoptr i64 %339 to ptr
  call void %340(ptr %51, ptr %54) #3, !noalias !9
  br label %2170

341:                                              ; preds = %265
  %342 = add nsw i64 %267, -1
  %343 = add i64 %266, 1
  %344 = icmp slt i64 %266, 0
  %345 = select i1 %344, i64 %175, i64 0
  %346 = getelementptr i64, ptr %176, i64 %266
  %347 = getelementptr i64, ptr %346, i64 %345
  %348 = load i64, ptr %347, align 8, !noalias !9
  %349 = icmp eq i64 %348, -1
  br i1 %349, label %272, label %300

350:                                              ; preds = %280
  %351 = add i64 %43, %277
  %352 = call i64 @llvm.smax.i64(i64 %205, i64 0)
  br label %353

353:                                              ; preds = %350, %357
  %354 = phi i64 [ 0, %350 ], [ %359, %357 ]
  %355 = phi i64 [ %352, %350 ], [ %358, %357 ]
  %356 = icmp sgt i64 %355, 0
  br i1 %356, label %357, label %373

357:                                              ; preds = %353
  %358 = add nsw i64 %355, -1
  %359 = add i64 %354, 1
  %360 = shl nsw i64 %354, 6
  %361 = add nsw i64 %351, %360
  %362 = icmp slt i64 %273, 0
  %363 = select i1 %362, i64 %203, i64 0
  %364 = add i64 %273, %363
  %365 = icmp slt i64 %354, 0
  %366 = select i1 %365, i64 %205, i64 0
  %367 = mul i64 %364, %205
  %368 = getelementptr double, ptr %206, i64 %367
  %369 = getelementptr double, ptr %368, i64 %354
  %370 = getelementptr double, ptr %369, i64 %366
  %371 = load i64, ptr %370, align 8, !noalias !21
  %372 = inttoptr i64 %361 to ptr
  store atomic i64 %371, ptr %372 unordered, align 8, !noalias !21
  br label %353

373:                                              ; preds = %353
  %374 = add i64 %48, %277
  %375 = call i64 @llvm.smax.i64(i64 %212, i64 0)
  br label %376

376:                                              ; preds = %373, %380
  %377 = phi i64 [ 0, %373 ], [ %382, %380 ]
  %378 = phi i64 [ %375, %373 ], [ %381, %380 ]
  %379 = icmp sgt i64 %378, 0
  br i1 %379, label %380, label %396

380:                                              ; preds = %376
  %381 = add nsw i64 %378, -1
  %382 = add i64 %377, 1
  %383 = shl nsw i64 %377, 6
  %384 = add nsw i64 %374, %383
  %385 = icmp slt i64 %273, 0
  %386 = select i1 %385, i64 %210, i64 0
  %387 = add i64 %273, %386
  %388 = icmp slt i64 %377, 0
  %389 = select i1 %388, i64 %212, i64 0
  %390 = mul i64 %387, %212
  %391 = getelementptr double, ptr %213, i64 %390
  %392 = getelementptr double, ptr %391, i64 %377
  %393 = getelementptr double, ptr %392, i64 %389
  %394 = load i64, ptr %393, align 8, !noalias !25
  %395 = inttoptr i64 %384 to ptr
  store atomic i64 %394, ptr %395 unordered, align 8, !noalias !25
  br label %376

396:                                              ; preds = %376
  %397 = load double, ptr %192, align 8, !noalias !9
  %398 = select i1 %344, i64 %129, i64 0
  %399 = getelementptr double, ptr %130, i64 %266
  %400 = getelementptr double, ptr %399, i64 %398
  store double %397, ptr %400, align 8, !noalias !9
  %401 = shl nuw i64 1, %266
  %402 = or i64 %268, %401
  br label %300

403:                                              ; preds = %310
  %404 = add nsw i64 %312, -1
  %405 = add i64 %311, 1
  %406 = icmp slt i64 %311, 0
  %407 = select i1 %406, i64 %175, i64 0
  %408 = getelementptr i64, ptr %176, i64 %311
  %409 = getelementptr i64, ptr %408, i64 %407
  %410 = load i64, ptr %409, align 8, !noalias !9
  %411 = icmp eq i64 %410, -1
  br i1 %411, label %314, label %336

412:                                              ; preds = %319
  %413 = load i64, ptr %226, align 8, !noalias !9
  %414 = add i64 %109, %316
  %415 = call i64 @llvm.smax.i64(i64 %413, i64 0)
  br label %416

416:                                              ; preds = %412, %420
  %417 = phi i64 [ 0, %412 ], [ %422, %420 ]
  %418 = phi i64 [ %415, %412 ], [ %421, %420 ]
  %419 = icmp sgt i64 %418, 0
  br i1 %419, label %420, label %433

420:                                              ; preds = %416
  %421 = add nsw i64 %418, -1
  %422 = add i64 %417, 1
  %423 = shl nsw i64 %417, 6
  %424 = add nsw i64 %414, %423
  %425 = shl nsw i64 %417, 3
  %426 = add nsw i64 %425, %270
  %427 = icmp slt i64 %426, 0
  %428 = select i1 %427, i64 %111, i64 0
  %429 = getelementptr double, ptr %112, i64 %426
  %430 = getelementptr double, ptr %429, i64 %428
  %431 = load i64, ptr %430, align 8, !noalias !29
  %432 = inttoptr i64 %424 to ptr
  store atomic i64 %431, ptr %432 unordered, align 8, !noalias !29
  br label %416

433:                                              ; preds = %416
  %434 = getelementptr i8, ptr %36, i64 24
  %435 = load i64, ptr %434, align 8, !noalias !9
  %436 = add i64 %43, %316
  %437 = call i64 @llvm.smax.i64(i64 %435, i64 0)
  br label %438

438:                                              ; preds = %433, %442
  %439 = phi i64 [ 0, %433 ], [ %444, %442 ]
  %440 = phi i64 [ %437, %433 ], [ %443, %442 ]
  %441 = icmp sgt i64 %440, 0
  br i1 %441, label %442, label %455

442:                                              ; preds = %438
  %443 = add nsw i64 %440, -1
  %444 = add i64 %439, 1
  %445 = shl nsw i64 %439, 6
  %446 = add nsw i64 %436, %445
  %447 = shl nsw i64 %439, 3
  %448 = add nsw i64 %447, %270
  %449 = icmp slt i64 %448, 0
  %450 = select i1 %449, i64 %45, i64 0
  %451 = getelementptr double, ptr %46, i64 %448
  %452 = getelementptr double, ptr %451, i64 %450
  %453 = load i64, ptr %452, align 8, !noalias !33
  %454 = inttoptr i64 %446 to ptr
  store atomic i64 %453, ptr %454 unordered, align 8, !noalias !33
  br label %438

455:                                              ; preds = %438
  %456 = getelementptr i8, ptr %36, i64 32
  %457 = load i64, ptr %456, align 8, !noalias !9
  %458 = add i64 %48, %316
  %459 = call i64 @llvm.smax.i64(i64 %457, i64 0)
  br label %460

460:                                              ; preds = %455, %464
  %461 = phi i64 [ 0, %455 ], [ %466, %464 ]
  %462 = phi i64 [ %459, %455 ], [ %465, %464 ]
  %463 = icmp sgt i64 %462, 0
  br i1 %463, label %464, label %477

464:                                              ; preds = %460
  %465 = add nsw i64 %462, -1
  %466 = add i64 %461, 1
  %467 = shl nsw i64 %461, 6
  %468 = add nsw i64 %458, %467
  %469 = shl nsw i64 %461, 3
  %470 = add nsw i64 %469, %270
  %471 = icmp slt i64 %470, 0
  %472 = select i1 %471, i64 %50, i64 0
  %473 = getelementptr double, ptr %51, i64 %470
  %474 = getelementptr double, ptr %473, i64 %472
  %475 = load i64, ptr %474, align 8, !noalias !37
  %476 = inttoptr i64 %468 to ptr
  store atomic i64 %475, ptr %476 unordered, align 8, !noalias !37
  br label %460

477:                                              ; preds = %460
  %478 = getelementptr double, ptr %130, i64 %270
  %479 = load double, ptr %478, align 8, !noalias !9
  %480 = select i1 %406, i64 %129, i64 0
  %481 = getelementptr double, ptr %130, i64 %311
  %482 = getelementptr double, ptr %481, i64 %480
  store double %479, ptr %482, align 8, !noalias !9
  %483 = select i1 %406, i64 %134, i64 0
  %484 = getelementptr double, ptr %135, i64 %311
  %485 = getelementptr double, ptr %484, i64 %483
  store double 0.000000e+00, ptr %485, align 8, !noalias !9
  %486 = select i1 %406, i64 %150, i64 0
  %487 = getelementptr double, ptr %151, i64 %311
  %488 = getelementptr double, ptr %487, i64 %486
  store double 0x7FF0000000000000, ptr %488, align 8, !noalias !9
  store i64 -2, ptr %409, align 8, !noalias !9
  br label %336

489:                                              ; preds = %2170
  br label %2225

490:                                              ; preds = %2170
  %491 = icmp eq i64 %268, 0
  br i1 %491, label %1086, label %492

492:                                              ; preds = %490
  %493 = load i64, ptr %226, align 8, !noalias !41
  %494 = trunc i64 %268 to i8
  %495 = bitcast i8 %494 to <8 x i1>
  %496 = load <8 x double>, ptr %130, align 8, !noalias !41
  store ptr null, ptr %12, align 8, !noalias !45
  store ptr null, ptr %13, align 8, !noalias !45
  store <8 x double> %496, ptr %41, align 8, !noalias !45
  %497 = icmp sgt i64 %58, 0
  br i1 %497, label %498, label %500

498:                                              ; preds = %492
  store ptr null, ptr %12, align 8, !noalias !45
  %499 = call fastcc i32 @_set_inputs(ptr nonnull %12, ptr nonnull %41, i64 %40, ptr %46, i64 %45, ptr %61, i64 %58, i64 %60, ptr %68, i64 %65, i64 %67, ptr %73, i64 %72, ptr %80, i64 %77, i64 %79) #3
  switch i32 %499, label %506 [
    i32 -2, label %500
    i32 0, label %500
  ], !prof !49

500:                                              ; preds = %498, %498, %492
  %501 = load i64, ptr %36, align 8, !noalias !45
  %502 = inttoptr i64 %501 to ptr
  %503 = call i32 %502(ptr nonnull %41, ptr %85, ptr %46, ptr %54, ptr %95) #3, !noalias !45
  %504 = sext i32 %503 to i64
  %505 = and i64 %268, %504
  br label %506

506:                                              ; preds = %498, %500
  %507 = phi i64 [ %505, %500 ], [ 0, %498 ]
  %508 = phi i1 [ true, %500 ], [ false, %498 ]
  br i1 %508, label %1048, label %2172, !prof !1

509:                                              ; preds = %1048, %1050
  %510 = phi i64 [ 0, %1048 ], [ %1052, %1050 ]
  %511 = phi i64 [ %1049, %1048 ], [ %1051, %1050 ]
  %512 = icmp sgt i64 %511, 0
  br i1 %512, label %1050, label %513

513:                                              ; preds = %509
  %514 = getelementptr i8, ptr %187, i64 8
  %515 = load double, ptr %514, align 8, !noalias !41
  %516 = insertelement <8 x double> poison, double %515, i64 0
  %517 = shufflevector <8 x double> %516, <8 x double> poison, <8 x i32> zeroinitializer
  %518 = fcmp oeq double %515, 0.000000e+00
  br i1 %518, label %519, label %749

519:                                              ; preds = %513
  %520 = load double, ptr %187, align 8, !noalias !41
  %521 = load i64, ptr %226, align 8, !noalias !50
  %522 = icmp slt i64 %84, 0
  %523 = select i1 %522, i64 %111, i64 0
  %524 = add i64 %84, %523
  %525 = icmp slt i64 %524, 0
  br i1 %525, label %579, label %580, !prof !0

526:                                              ; preds = %593, %638
  %527 = phi i64 [ 0, %593 ], [ %640, %638 ]
  %528 = phi i64 [ %607, %593 ], [ %639, %638 ]
  %529 = icmp sgt i64 %528, 0
  br i1 %529, label %638, label %530

530:                                              ; preds = %526
  %531 = fadd <8 x double> %496, %606
  store ptr null, ptr %10, align 8, !noalias !54
  store ptr null, ptr %11, align 8, !noalias !54
  store <8 x double> %531, ptr %41, align 8, !noalias !54
  br i1 %497, label %532, label %534

532:                                              ; preds = %530
  store ptr null, ptr %10, align 8, !noalias !54
  %533 = call fastcc i32 @_set_inputs(ptr nonnull %10, ptr nonnull %41, i64 %40, ptr %46, i64 %45, ptr %61, i64 %58, i64 %60, ptr %68, i64 %65, i64 %67, ptr %73, i64 %72, ptr %80, i64 %77, i64 %79) #3
  switch i32 %533, label %746 [
    i32 -2, label %534
    i32 0, label %534
  ], !prof !49

534:                                              ; preds = %532, %532, %530
  %535 = load i64, ptr %36, align 8, !noalias !54
  %536 = inttoptr i64 %535 to ptr
  %537 = call i32 %536(ptr nonnull %41, ptr %95, ptr %46, ptr %54, ptr %586) #3, !noalias !54
  %538 = trunc i32 %537 to i8
  %539 = bitcast i8 %538 to <8 x i1>
  br label %649

540:                                              ; preds = %584, %551
  %541 = phi i64 [ 0, %584 ], [ %553, %551 ]
  %542 = phi i64 [ %587, %584 ], [ %552, %551 ]
  %543 = phi <8 x double> [ zeroinitializer, %584 ], [ %578, %551 ]
  %544 = icmp sgt i64 %542, 0
  br i1 %544, label %551, label %545

545:                                              ; preds = %540
  %546 = sitofp i64 %521 to double
  %547 = insertelement <8 x double> poison, double %546, i64 0
  %548 = shufflevector <8 x double> %547, <8 x double> poison, <8 x i32> zeroinitializer
  %549 = fdiv <8 x double> %543, %548
  %550 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %549)
  br label %588

551:                                              ; preds = %540
  %552 = add nsw i64 %542, -1
  %553 = add i64 %541, 1
  %554 = icmp slt i64 %541, 0
  %555 = select i1 %554, i64 %124, i64 0
  %556 = getelementptr double, ptr %125, i64 %541
  %557 = getelementptr double, ptr %556, i64 %555
  %558 = load double, ptr %557, align 8, !noalias !58
  %559 = select i1 %554, i64 %119, i64 0
  %560 = getelementptr double, ptr %120, i64 %541
  %561 = getelementptr double, ptr %560, i64 %559
  %562 = load double, ptr %561, align 8, !noalias !58
  %563 = shl i64 %541, 6
  %564 = getelementptr i8, ptr %85, i64 %563
  %565 = load <8 x double>, ptr %564, align 8, !noalias !58
  %566 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %565)
  %567 = insertelement <8 x double> poison, double %562, i64 0
  %568 = shufflevector <8 x double> %567, <8 x double> poison, <8 x i32> zeroinitializer
  %569 = fmul <8 x double> %568, %566
  %570 = insertelement <8 x double> poison, double %558, i64 0
  %571 = shufflevector <8 x double> %570, <8 x double> poison, <8 x i32> zeroinitializer
  %572 = fadd <8 x double> %571, %569
  %573 = getelementptr i8, ptr %104, i64 %563
  %574 = load <8 x double>, ptr %573, align 8, !noalias !58
  %575 = fsub <8 x double> %565, %574
  %576 = fdiv <8 x double> %575, %572
  %577 = fmul <8 x double> %576, %576
  %578 = fadd <8 x double> %543, %577
  br label %540

579:                                              ; preds = %519
  br label %580

580:                                              ; preds = %579, %519
  %581 = phi i64 [ 0, %579 ], [ %524, %519 ]
  %582 = icmp slt i64 %524, %111
  br i1 %582, label %584, label %583, !prof !1

583:                                              ; preds = %580
  br label %584

584:                                              ; preds = %583, %580
  %585 = phi i64 [ %111, %583 ], [ %581, %580 ]
  %586 = getelementptr double, ptr %112, i64 %585
  %587 = call i64 @llvm.smax.i64(i64 %521, i64 0)
  br label %540

588:                                              ; preds = %545, %608
  %589 = phi i64 [ 0, %545 ], [ %610, %608 ]
  %590 = phi i64 [ %587, %545 ], [ %609, %608 ]
  %591 = phi <8 x double> [ zeroinitializer, %545 ], [ %637, %608 ]
  %592 = icmp sgt i64 %590, 0
  br i1 %592, label %608, label %593

593:                                              ; preds = %588
  %594 = shufflevector <8 x double> %547, <8 x double> poison, <8 x i32> zeroinitializer
  %595 = fdiv <8 x double> %591, %594
  %596 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %595)
  %597 = fcmp olt <8 x double> %550, splat (double 1.000000e-05)
  %598 = fcmp olt <8 x double> %596, splat (double 1.000000e-05)
  %599 = or <8 x i1> %597, %598
  %600 = fmul <8 x double> %550, splat (double 1.000000e-02)
  %601 = fdiv <8 x double> %600, %596
  %602 = select <8 x i1> %599, <8 x double> splat (double 0x3EB0C6F7A0B5ED8D), <8 x double> %601
  %603 = insertelement <8 x double> poison, double %520, i64 0
  %604 = shufflevector <8 x double> %603, <8 x double> poison, <8 x i32> zeroinitializer
  %605 = fcmp olt <8 x double> %602, %604
  %606 = select <8 x i1> %605, <8 x double> %602, <8 x double> %604
  %607 = call i64 @llvm.smax.i64(i64 %521, i64 0)
  br label %526

608:                                              ; preds = %588
  %609 = add nsw i64 %590, -1
  %610 = add i64 %589, 1
  %611 = icmp slt i64 %589, 0
  %612 = select i1 %611, i64 %124, i64 0
  %613 = getelementptr double, ptr %125, i64 %589
  %614 = getelementptr double, ptr %613, i64 %612
  %615 = load double, ptr %614, align 8, !noalias !62
  %616 = select i1 %611, i64 %119, i64 0
  %617 = getelementptr double, ptr %120, i64 %589
  %618 = getelementptr double, ptr %617, i64 %616
  %619 = load double, ptr %618, align 8, !noalias !62
  %620 = shl i64 %589, 6
  %621 = getelementptr i8, ptr %85, i64 %620
  %622 = load <8 x double>, ptr %621, align 8, !noalias !62
  %623 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %622)
  %624 = insertelement <8 x double> poison, double %619, i64 0
  %625 = shufflevector <8 x double> %624, <8 x double> poison, <8 x i32> zeroinitializer
  %626 = fmul <8 x double> %625, %623
  %627 = insertelement <8 x double> poison, double %615, i64 0
  %628 = shufflevector <8 x double> %627, <8 x double> poison, <8 x i32> zeroinitializer
  %629 = fadd <8 x double> %628, %626
  %630 = getelementptr i8, ptr %112, i64 %620
  %631 = load <8 x double>, ptr %630, align 8, !noalias !62
  %632 = getelementptr i8, ptr %104, i64 %620
  %633 = load <8 x double>, ptr %632, align 8, !noalias !62
  %634 = fsub <8 x double> %631, %633
  %635 = fdiv <8 x double> %634, %629
  %636 = fmul <8 x double> %635, %635
  %637 = fadd <8 x double> %591, %636
  br label %588

638:                                              ; preds = %526
  %639 = add nsw i64 %528, -1
  %640 = add i64 %527, 1
  %641 = shl i64 %527, 6
  %642 = getelementptr i8, ptr %85, i64 %641
  %643 = load <8 x double>, ptr %642, align 8, !noalias !50
  %644 = getelementptr i8, ptr %112, i64 %641
  %645 = load <8 x double>, ptr %644, align 8, !noalias !50
  %646 = fmul <8 x double> %606, %645
  %647 = fadd <8 x double> %643, %646
  %648 = getelementptr i8, ptr %95, i64 %641
  store <8 x double> %647, ptr %648, align 8, !noalias !50
  br label %526

649:                                              ; preds = %534, %716
  %650 = phi i64 [ 0, %534 ], [ %718, %716 ]
  %651 = phi i64 [ %607, %534 ], [ %717, %716 ]
  %652 = phi <8 x double> [ zeroinitializer, %534 ], [ %745, %716 ]
  %653 = icmp sgt i64 %651, 0
  br i1 %653, label %716, label %654

654:                                              ; preds = %649
  %655 = shufflevector <8 x double> %547, <8 x double> poison, <8 x i32> zeroinitializer
  %656 = fdiv <8 x double> %652, %655
  %657 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %656)
  %658 = fdiv <8 x double> %657, %606
  %659 = fcmp ogt <8 x double> %596, %658
  %660 = select <8 x i1> %659, <8 x double> %596, <8 x double> %658
  %661 = fcmp ogt <8 x double> %660, splat (double 1.000000e-15)
  %662 = fdiv <8 x double> splat (double 1.000000e-02), %660
  %663 = select <8 x i1> %661, <8 x double> %662, <8 x double> splat (double 1.000000e+13)
  %664 = load double, ptr %33, align 8, !noalias !50
  %665 = bitcast <8 x double> %663 to <8 x i64>
  %666 = add nsw <8 x i64> %665, splat (i64 -4604544271217802189)
  %667 = ashr <8 x i64> %666, splat (i64 52)
  %668 = and <8 x i64> %666, splat (i64 -4503599627370496)
  %669 = sub <8 x i64> %665, %668
  %670 = bitcast <8 x i64> %669 to <8 x double>
  %671 = fadd <8 x double> %670, splat (double -1.000000e+00)
  %672 = fadd <8 x double> %670, splat (double 1.000000e+00)
  %673 = fdiv <8 x double> %671, %672
  %674 = fmul <8 x double> %673, %673
  %675 = call <8 x double> @llvm.fma.v8f64(<8 x double> %674, <8 x double> splat (double 0x3FD484B13D7C02A9), <8 x double> splat (double 0x3FDA61762A7ADED9))
  %676 = call <8 x double> @llvm.fma.v8f64(<8 x double> %675, <8 x double> %674, <8 x double> splat (double 0x3FE2776C50EF9BFE))
  %677 = call <8 x double> @llvm.fma.v8f64(<8 x double> %676, <8 x double> %674, <8 x double> splat (double 0x3FEEC709DC3A03FD))
  %678 = call <8 x double> @llvm.fma.v8f64(<8 x double> %677, <8 x double> %674, <8 x double> splat (double 0x40071547652B82FE))
  %679 = fmul <8 x double> %678, %673
  %680 = trunc nsw <8 x i64> %667 to <8 x i32>
  %681 = sitofp <8 x i32> %680 to <8 x double>
  %682 = fadd <8 x double> %679, %681
  %683 = insertelement <8 x double> poison, double %664, i64 0
  %684 = shufflevector <8 x double> %683, <8 x double> poison, <8 x i32> zeroinitializer
  %685 = fmul <8 x double> %682, %684
  %686 = fcmp ogt <8 x double> %685, splat (double -1.000000e+03)
  %687 = select <8 x i1> %686, <8 x double> %685, <8 x double> splat (double -1.000000e+03)
  %688 = fcmp olt <8 x double> %687, splat (double 1.000000e+03)
  %689 = select <8 x i1> %688, <8 x double> %687, <8 x double> splat (double 1.000000e+03)
  %690 = call <8 x double> @llvm.rint.v8f64(<8 x double> %689)
  %691 = fsub <8 x double> %689, %690
  %692 = call <8 x double> @llvm.fma.v8f64(<8 x double> %691, <8 x double> splat (double 0x3EEFFCBFC588B0C5), <8 x double> splat (double 0x3F2430912F86C786))
  %693 = call <8 x double> @llvm.fma.v8f64(<8 x double> %692, <8 x double> %691, <8 x double> splat (double 0x3F55D87FE78A6730))
  %694 = call <8 x double> @llvm.fma.v8f64(<8 x double> %693, <8 x double> %691, <8 x double> splat (double 0x3F83B2AB6FBA4E77))
  %695 = call <8 x double> @llvm.fma.v8f64(<8 x double> %694, <8 x double> %691, <8 x double> splat (double 0x3FAC6B08D704A0BF))
  %696 = call <8 x double> @llvm.fma.v8f64(<8 x double> %695, <8 x double> %691, <8 x double> splat (double 0x3FCEBFBDFF82C58E))
  %697 = call <8 x double> @llvm.fma.v8f64(<8 x double> %696, <8 x double> %691, <8 x double> splat (double 0x3FE62E42FEFA39EF))
  %698 = call <8 x double> @llvm.fma.v8f64(<8 x double> %697, <8 x double> %691, <8 x double> splat (double 1.000000e+00))
  %699 = fptosi <8 x double> %690 to <8 x i32>
  %700 = zext <8 x i32> %699 to <8 x i64>
  %701 = shl <8 x i64> %700, splat (i64 52)
  %702 = bitcast <8 x double> %698 to <8 x i64>
  %703 = add <8 x i64> %701, %702
  %704 = bitcast <8 x i64> %703 to <8 x double>
  %705 = fmul <8 x double> %606, splat (double 1.000000e-03)
  %706 = fcmp ogt <8 x double> %705, splat (double 0x3EB0C6F7A0B5ED8D)
  %707 = select <8 x i1> %706, <8 x double> %705, <8 x double> splat (double 0x3EB0C6F7A0B5ED8D)
  %708 = select <8 x i1> %661, <8 x double> %704, <8 x double> %707
  %709 = fmul <8 x double> %606, splat (double 1.000000e+02)
  %710 = fcmp olt <8 x double> %709, %708
  %711 = select <8 x i1> %710, <8 x double> %709, <8 x double> %708
  %712 = shufflevector <8 x double> %603, <8 x double> poison, <8 x i32> zeroinitializer
  %713 = fcmp olt <8 x double> %711, %712
  %714 = select <8 x i1> %713, <8 x double> %711, <8 x double> %712
  %715 = select <8 x i1> %539, <8 x double> %705, <8 x double> %714
  br label %746

716:                                              ; preds = %649
  %717 = add nsw i64 %651, -1
  %718 = add i64 %650, 1
  %719 = icmp slt i64 %650, 0
  %720 = select i1 %719, i64 %124, i64 0
  %721 = getelementptr double, ptr %125, i64 %650
  %722 = getelementptr double, ptr %721, i64 %720
  %723 = load double, ptr %722, align 8, !noalias !66
  %724 = select i1 %719, i64 %119, i64 0
  %725 = getelementptr double, ptr %120, i64 %650
  %726 = getelementptr double, ptr %725, i64 %724
  %727 = load double, ptr %726, align 8, !noalias !66
  %728 = shl i64 %650, 6
  %729 = getelementptr i8, ptr %85, i64 %728
  %730 = load <8 x double>, ptr %729, align 8, !noalias !66
  %731 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %730)
  %732 = insertelement <8 x double> poison, double %727, i64 0
  %733 = shufflevector <8 x double> %732, <8 x double> poison, <8 x i32> zeroinitializer
  %734 = fmul <8 x double> %733, %731
  %735 = insertelement <8 x double> poison, double %723, i64 0
  %736 = shufflevector <8 x double> %735, <8 x double> poison, <8 x i32> zeroinitializer
  %737 = fadd <8 x double> %736, %734
  %738 = getelementptr i8, ptr %586, i64 %728
  %739 = load <8 x double>, ptr %738, align 8, !noalias !66
  %740 = getelementptr i8, ptr %112, i64 %728
  %741 = load <8 x double>, ptr %740, align 8, !noalias !66
  %742 = fsub <8 x double> %739, %741
  %743 = fdiv <8 x double> %742, %737
  %744 = fmul <8 x double> %743, %743
  %745 = fadd <8 x double> %652, %744
  br label %649

746:                                              ; preds = %532, %654
  %747 = phi <8 x double> [ %715, %654 ], [ zeroinitializer, %532 ]
  %748 = phi i1 [ true, %654 ], [ false, %532 ]
  br i1 %748, label %749, label %2172, !prof !1

749:                                              ; preds = %746, %513
  %750 = phi double [ 1.000000e+00, %513 ], [ 2.000000e+00, %746 ]
  %751 = phi <8 x double> [ %517, %513 ], [ %747, %746 ]
  %752 = load <8 x double>, ptr %135, align 8, !noalias !41
  %753 = select <8 x i1> %495, <8 x double> %751, <8 x double> %752
  store <8 x double> %753, ptr %135, align 8, !noalias !41
  %754 = load <8 x double>, ptr %138, align 8, !noalias !41
  %755 = select <8 x i1> %495, <8 x double> splat (double 1.000000e-04), <8 x double> %754
  store <8 x double> %755, ptr %138, align 8, !noalias !41
  %756 = getelementptr i8, ptr %33, i64 40
  %757 = load double, ptr %756, align 8, !noalias !41
  %758 = load <8 x double>, ptr %141, align 8, !noalias !41
  %759 = insertelement <8 x double> poison, double %757, i64 0
  %760 = shufflevector <8 x double> %759, <8 x double> poison, <8 x i32> zeroinitializer
  %761 = select <8 x i1> %495, <8 x double> %760, <8 x double> %758
  store <8 x double> %761, ptr %141, align 8, !noalias !41
  %762 = load <8 x double>, ptr %156, align 8, !noalias !41
  %763 = select <8 x i1> %495, <8 x double> zeroinitializer, <8 x double> %762
  store <8 x double> %763, ptr %156, align 8, !noalias !41
  %764 = load <8 x double>, ptr %161, align 8, !noalias !41
  %765 = select <8 x i1> %495, <8 x double> zeroinitializer, <8 x double> %764
  store <8 x double> %765, ptr %161, align 8, !noalias !41
  %766 = load <8 x double>, ptr %166, align 8, !noalias !41
  %767 = insertelement <8 x double> poison, double %750, i64 0
  %768 = shufflevector <8 x double> %767, <8 x double> poison, <8 x i32> zeroinitializer
  %769 = select <8 x i1> %495, <8 x double> %768, <8 x double> %766
  store <8 x double> %769, ptr %166, align 8, !noalias !41
  %770 = load <8 x double>, ptr %171, align 8, !noalias !41
  %771 = select <8 x i1> %495, <8 x double> splat (double 2.000000e+00), <8 x double> %770
  store <8 x double> %771, ptr %171, align 8, !noalias !41
  br label %772

772:                                              ; preds = %749, %798
  %773 = phi i64 [ 0, %749 ], [ %1061, %798 ]
  %774 = phi i64 [ 8, %749 ], [ %1060, %798 ]
  %775 = icmp sgt i64 %774, 0
  br i1 %775, label %1059, label %799

776:                                              ; preds = %1059
  %777 = load double, ptr %192, align 8, !noalias !41
  %778 = icmp slt i64 %773, 0
  %779 = select i1 %778, i64 %145, i64 0
  %780 = getelementptr double, ptr %146, i64 %773
  %781 = getelementptr double, ptr %780, i64 %779
  store double 0.000000e+00, ptr %781, align 8, !noalias !41
  %782 = select i1 %778, i64 %150, i64 0
  %783 = getelementptr double, ptr %151, i64 %773
  %784 = getelementptr double, ptr %783, i64 %782
  store double %777, ptr %784, align 8, !noalias !41
  %785 = select i1 %778, i64 %175, i64 0
  %786 = getelementptr i64, ptr %176, i64 %773
  %787 = getelementptr i64, ptr %786, i64 %785
  %788 = load i64, ptr %787, align 8, !noalias !41
  %789 = add nsw i64 %191, -1
  %790 = mul nsw i64 %788, %789
  %791 = getelementptr i8, ptr %184, i64 24
  %792 = load i64, ptr %791, align 8, !noalias !41
  %793 = shl nsw i64 %790, 3
  %794 = add nsw i64 %792, %793
  %795 = select i1 %778, i64 %180, i64 0
  %796 = getelementptr i64, ptr %181, i64 %773
  %797 = getelementptr i64, ptr %796, i64 %795
  store i64 %794, ptr %797, align 8, !noalias !41
  br label %798

798:                                              ; preds = %776, %1059
  br label %772

799:                                              ; preds = %772
  %800 = xor i64 %507, -1
  %801 = and i64 %268, %800
  %802 = icmp eq i64 %801, 0
  br i1 %802, label %891, label %803

803:                                              ; preds = %799, %825
  %804 = phi i64 [ %877, %825 ], [ %801, %799 ]
  %805 = getelementptr i8, ptr %184, i64 32
  %806 = load i64, ptr %805, align 8, !noalias !70
  %807 = shl nsw i64 %806, 3
  %808 = load i64, ptr %226, align 8, !noalias !70
  br label %809

809:                                              ; preds = %803, %823
  %810 = phi i64 [ %813, %823 ], [ %804, %803 ]
  %811 = call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %810, i1 true)
  %812 = add nsw i64 %810, -1
  %813 = and i64 %810, %812
  %814 = getelementptr i64, ptr %181, i64 %811
  %815 = load i64, ptr %814, align 8, !noalias !70
  %816 = add nsw i64 %815, 8
  store i64 %816, ptr %814, align 8, !noalias !70
  %817 = call i64 @llvm.smax.i64(i64 %808, i64 0)
  br label %818

818:                                              ; preds = %809, %879
  %819 = phi i64 [ 0, %809 ], [ %881, %879 ]
  %820 = phi i64 [ %817, %809 ], [ %880, %879 ]
  %821 = phi i64 [ %815, %809 ], [ %890, %879 ]
  %822 = icmp sgt i64 %820, 0
  br i1 %822, label %879, label %823

823:                                              ; preds = %818
  %824 = icmp eq i64 %813, 0
  br i1 %824, label %825, label %809

825:                                              ; preds = %823
  %826 = load <8 x double>, ptr %146, align 8, !noalias !70
  %827 = trunc i64 %804 to i8
  %828 = bitcast i8 %827 to <8 x i1>
  %829 = select <8 x i1> %828, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %830 = fadd <8 x double> %826, %829
  store <8 x double> %830, ptr %146, align 8, !noalias !70
  %831 = extractelement <8 x double> %830, i64 0
  %832 = fptosi double %831 to i64
  %833 = getelementptr double, ptr %192, i64 %832
  %834 = load double, ptr %833, align 8, !noalias !70
  %835 = insertelement <8 x double> poison, double %834, i64 0
  %836 = extractelement <8 x double> %830, i64 1
  %837 = fptosi double %836 to i64
  %838 = getelementptr double, ptr %192, i64 %837
  %839 = load double, ptr %838, align 8, !noalias !70
  %840 = insertelement <8 x double> %835, double %839, i64 1
  %841 = extractelement <8 x double> %830, i64 2
  %842 = fptosi double %841 to i64
  %843 = getelementptr double, ptr %192, i64 %842
  %844 = load double, ptr %843, align 8, !noalias !70
  %845 = insertelement <8 x double> %840, double %844, i64 2
  %846 = extractelement <8 x double> %830, i64 3
  %847 = fptosi double %846 to i64
  %848 = getelementptr double, ptr %192, i64 %847
  %849 = load double, ptr %848, align 8, !noalias !70
  %850 = insertelement <8 x double> %845, double %849, i64 3
  %851 = extractelement <8 x double> %830, i64 4
  %852 = fptosi double %851 to i64
  %853 = getelementptr double, ptr %192, i64 %852
  %854 = load double, ptr %853, align 8, !noalias !70
  %855 = insertelement <8 x double> %850, double %854, i64 4
  %856 = extractelement <8 x double> %830, i64 5
  %857 = fptosi double %856 to i64
  %858 = getelementptr double, ptr %192, i64 %857
  %859 = load double, ptr %858, align 8, !noalias !70
  %860 = insertelement <8 x double> %855, double %859, i64 5
  %861 = extractelement <8 x double> %830, i64 6
  %862 = fptosi double %861 to i64
  %863 = getelementptr double, ptr %192, i64 %862
  %864 = load double, ptr %863, align 8, !noalias !70
  %865 = insertelement <8 x double> %860, double %864, i64 6
  %866 = extractelement <8 x double> %830, i64 7
  %867 = fptosi double %866 to i64
  %868 = getelementptr double, ptr %192, i64 %867
  %869 = load double, ptr %868, align 8, !noalias !70
  %870 = insertelement <8 x double> %865, double %869, i64 7
  store <8 x double> %870, ptr %151, align 8, !noalias !70
  %871 = load double, ptr %192, align 8, !noalias !41
  %872 = insertelement <8 x double> poison, double %871, i64 0
  %873 = shufflevector <8 x double> %872, <8 x double> poison, <8 x i32> zeroinitializer
  %874 = fcmp oeq <8 x double> %870, %873
  %875 = bitcast <8 x i1> %874 to i8
  %876 = zext i8 %875 to i64
  %877 = and i64 %804, %876
  %878 = icmp eq i64 %877, 0
  br i1 %878, label %891, label %803

879:                                              ; preds = %818
  %880 = add nsw i64 %820, -1
  %881 = add i64 %819, 1
  %882 = shl nsw i64 %819, 3
  %883 = add nsw i64 %882, %811
  %884 = icmp slt i64 %883, 0
  %885 = select i1 %884, i64 %84, i64 0
  %886 = getelementptr double, ptr %85, i64 %883
  %887 = getelementptr double, ptr %886, i64 %885
  %888 = load i64, ptr %887, align 8, !noalias !70
  %889 = inttoptr i64 %821 to ptr
  store atomic i64 %888, ptr %889 unordered, align 8, !noalias !70
  %890 = add nsw i64 %821, %807
  br label %818

891:                                              ; preds = %825, %799
  br label %892

892:                                              ; preds = %921, %891, %1047
  %893 = phi i64 [ 0, %891 ], [ %1067, %1047 ], [ %1067, %921 ]
  %894 = phi i64 [ 8, %891 ], [ %1066, %1047 ], [ %1066, %921 ]
  %895 = icmp sgt i64 %894, 0
  br i1 %895, label %1065, label %1071

896:                                              ; preds = %1065
  %897 = icmp slt i64 %893, 0
  %898 = select i1 %897, i64 %175, i64 0
  %899 = getelementptr i64, ptr %176, i64 %893
  %900 = getelementptr i64, ptr %899, i64 %898
  %901 = load i64, ptr %900, align 8, !noalias !74
  %902 = getelementptr i8, ptr %184, i64 32
  %903 = load i64, ptr %902, align 8, !noalias !74
  %904 = shl nsw i64 %903, 3
  %905 = select i1 %897, i64 %145, i64 0
  %906 = getelementptr double, ptr %146, i64 %893
  %907 = getelementptr double, ptr %906, i64 %905
  %908 = load double, ptr %907, align 8, !noalias !74
  %909 = fptosi double %908 to i64
  %910 = xor i64 %909, -1
  %911 = add i64 %191, %910
  %912 = call i64 @llvm.smax.i64(i64 %911, i64 0)
  br label %913

913:                                              ; preds = %917, %896
  %914 = phi i64 [ 0, %896 ], [ %954, %917 ]
  %915 = phi i64 [ %912, %896 ], [ %953, %917 ]
  %916 = icmp sgt i64 %915, 0
  br i1 %916, label %952, label %921

917:                                              ; preds = %952, %963
  %918 = phi i64 [ %962, %952 ], [ %964, %963 ]
  %919 = phi i64 [ %960, %952 ], [ %966, %963 ]
  %920 = icmp sgt i64 %918, 0
  br i1 %920, label %963, label %913

921:                                              ; preds = %913
  %922 = icmp slt i64 %901, 0
  %923 = select i1 %922, i64 %217, i64 0
  %924 = add i64 %901, %923
  %925 = mul i64 %924, %219
  %926 = getelementptr i64, ptr %220, i64 %925
  %927 = select i1 %897, i64 %155, i64 0
  %928 = getelementptr double, ptr %156, i64 %893
  %929 = getelementptr double, ptr %928, i64 %927
  %930 = load double, ptr %929, align 8, !noalias !74
  %931 = select i1 %897, i64 %160, i64 0
  %932 = getelementptr double, ptr %161, i64 %893
  %933 = getelementptr double, ptr %932, i64 %931
  %934 = load double, ptr %933, align 8, !noalias !74
  %935 = fptosi double %930 to i64
  store i64 %935, ptr %926, align 8, !noalias !74
  %936 = getelementptr i8, ptr %926, i64 8
  %937 = fptosi double %934 to i64
  store i64 %937, ptr %936, align 8, !noalias !74
  %938 = select i1 %897, i64 %165, i64 0
  %939 = getelementptr double, ptr %166, i64 %893
  %940 = getelementptr double, ptr %939, i64 %938
  %941 = load double, ptr %940, align 8, !noalias !74
  %942 = getelementptr i8, ptr %926, i64 16
  %943 = fptosi double %941 to i64
  store i64 %943, ptr %942, align 8, !noalias !74
  %944 = getelementptr i8, ptr %926, i64 24
  store i64 3, ptr %944, align 8, !noalias !74
  %945 = select i1 %897, i64 %129, i64 0
  %946 = getelementptr double, ptr %130, i64 %893
  %947 = getelementptr double, ptr %946, i64 %945
  %948 = load double, ptr %947, align 8, !noalias !74
  %949 = select i1 %922, i64 %224, i64 0
  %950 = getelementptr double, ptr %225, i64 %901
  %951 = getelementptr double, ptr %950, i64 %949
  store double %948, ptr %951, align 8, !noalias !74
  store i64 -1, ptr %900, align 8, !noalias !74
  br label %892

952:                                              ; preds = %913
  %953 = add nsw i64 %915, -1
  %954 = add i64 %914, 1
  %955 = shl nsw i64 %914, 3
  %956 = select i1 %897, i64 %180, i64 0
  %957 = getelementptr i64, ptr %181, i64 %893
  %958 = getelementptr i64, ptr %957, i64 %956
  %959 = load i64, ptr %958, align 8, !noalias !74
  %960 = add nsw i64 %959, %955
  %961 = load i64, ptr %226, align 8, !noalias !74
  %962 = call i64 @llvm.smax.i64(i64 %961, i64 0)
  br label %917

963:                                              ; preds = %917
  %964 = add nsw i64 %918, -1
  %965 = inttoptr i64 %919 to ptr
  store atomic i64 9221120237041090560, ptr %965 unordered, align 8, !noalias !74
  %966 = add nsw i64 %919, %904
  br label %917

967:                                              ; preds = %1065
  %968 = and i64 %268, %1068
  %969 = icmp eq i64 %968, 0
  br i1 %969, label %1047, label %970

970:                                              ; preds = %967
  %971 = icmp slt i64 %893, 0
  %972 = select i1 %971, i64 %150, i64 0
  %973 = getelementptr double, ptr %151, i64 %893
  %974 = getelementptr double, ptr %973, i64 %972
  %975 = load double, ptr %974, align 8, !noalias !41
  %976 = fcmp oeq double %975, 0x7FF0000000000000
  br i1 %976, label %977, label %1047

977:                                              ; preds = %970
  %978 = select i1 %971, i64 %175, i64 0
  %979 = getelementptr i64, ptr %176, i64 %893
  %980 = getelementptr i64, ptr %979, i64 %978
  %981 = load i64, ptr %980, align 8, !noalias !78
  %982 = getelementptr i8, ptr %184, i64 32
  %983 = load i64, ptr %982, align 8, !noalias !78
  %984 = shl nsw i64 %983, 3
  %985 = select i1 %971, i64 %145, i64 0
  %986 = getelementptr double, ptr %146, i64 %893
  %987 = getelementptr double, ptr %986, i64 %985
  %988 = load double, ptr %987, align 8, !noalias !78
  %989 = fptosi double %988 to i64
  %990 = xor i64 %989, -1
  %991 = add i64 %191, %990
  %992 = call i64 @llvm.smax.i64(i64 %991, i64 0)
  br label %993

993:                                              ; preds = %997, %977
  %994 = phi i64 [ 0, %977 ], [ %1034, %997 ]
  %995 = phi i64 [ %992, %977 ], [ %1033, %997 ]
  %996 = icmp sgt i64 %995, 0
  br i1 %996, label %1032, label %1001

997:                                              ; preds = %1032, %1043
  %998 = phi i64 [ %1042, %1032 ], [ %1044, %1043 ]
  %999 = phi i64 [ %1040, %1032 ], [ %1046, %1043 ]
  %1000 = icmp sgt i64 %998, 0
  br i1 %1000, label %1043, label %993

1001:                                             ; preds = %993
  %1002 = icmp slt i64 %981, 0
  %1003 = select i1 %1002, i64 %217, i64 0
  %1004 = add i64 %981, %1003
  %1005 = mul i64 %1004, %219
  %1006 = getelementptr i64, ptr %220, i64 %1005
  %1007 = select i1 %971, i64 %155, i64 0
  %1008 = getelementptr double, ptr %156, i64 %893
  %1009 = getelementptr double, ptr %1008, i64 %1007
  %1010 = load double, ptr %1009, align 8, !noalias !78
  %1011 = select i1 %971, i64 %160, i64 0
  %1012 = getelementptr double, ptr %161, i64 %893
  %1013 = getelementptr double, ptr %1012, i64 %1011
  %1014 = load double, ptr %1013, align 8, !noalias !78
  %1015 = fptosi double %1010 to i64
  store i64 %1015, ptr %1006, align 8, !noalias !78
  %1016 = getelementptr i8, ptr %1006, i64 8
  %1017 = fptosi double %1014 to i64
  store i64 %1017, ptr %1016, align 8, !noalias !78
  %1018 = select i1 %971, i64 %165, i64 0
  %1019 = getelementptr double, ptr %166, i64 %893
  %1020 = getelementptr double, ptr %1019, i64 %1018
  %1021 = load double, ptr %1020, align 8, !noalias !78
  %1022 = getelementptr i8, ptr %1006, i64 16
  %1023 = fptosi double %1021 to i64
  store i64 %1023, ptr %1022, align 8, !noalias !78
  %1024 = getelementptr i8, ptr %1006, i64 24
  store i64 0, ptr %1024, align 8, !noalias !78
  %1025 = select i1 %971, i64 %129, i64 0
  %1026 = getelementptr double, ptr %130, i64 %893
  %1027 = getelementptr double, ptr %1026, i64 %1025
  %1028 = load double, ptr %1027, align 8, !noalias !78
  %1029 = select i1 %1002, i64 %224, i64 0
  %1030 = getelementptr double, ptr %225, i64 %981
  %1031 = getelementptr double, ptr %1030, i64 %1029
  store double %1028, ptr %1031, align 8, !noalias !78
  store i64 -1, ptr %980, align 8, !noalias !78
  br label %1047

1032:                                             ; preds = %993
  %1033 = add nsw i64 %995, -1
  %1034 = add i64 %994, 1
  %1035 = shl nsw i64 %994, 3
  %1036 = select i1 %971, i64 %180, i64 0
  %1037 = getelementptr i64, ptr %181, i64 %893
  %1038 = getelementptr i64, ptr %1037, i64 %1036
  %1039 = load i64, ptr %1038, align 8, !noalias !78
  %1040 = add nsw i64 %1039, %1035
  %1041 = load i64, ptr %226, align 8, !noalias !78
  %1042 = call i64 @llvm.smax.i64(i64 %1041, i64 0)
  br label %997

1043:                                             ; preds = %997
  %1044 = add nsw i64 %998, -1
  %1045 = inttoptr i64 %999 to ptr
  store atomic i64 9221120237041090560, ptr %1045 unordered, align 8, !noalias !78
  %1046 = add nsw i64 %999, %984
  br label %997

1047:                                             ; preds = %1001, %970, %967
  br label %892

1048:                                             ; preds = %506
  %1049 = call i64 @llvm.smax.i64(i64 %493, i64 0)
  br label %509

1050:                                             ; preds = %509
  %1051 = add nsw i64 %511, -1
  %1052 = add i64 %510, 1
  %1053 = shl i64 %510, 6
  %1054 = getelementptr i8, ptr %95, i64 %1053
  %1055 = load <8 x double>, ptr %1054, align 8, !noalias !41
  %1056 = getelementptr i8, ptr %112, i64 %1053
  %1057 = load <8 x double>, ptr %1056, align 8, !noalias !41
  %1058 = select <8 x i1> %495, <8 x double> %1055, <8 x double> %1057
  store <8 x double> %1058, ptr %1056, align 8, !noalias !41
  br label %509

1059:                                             ; preds = %772
  %1060 = add nsw i64 %774, -1
  %1061 = add i64 %773, 1
  %1062 = shl nuw i64 1, %773
  %1063 = and i64 %268, %1062
  %1064 = icmp eq i64 %1063, 0
  br i1 %1064, label %798, label %776

1065:                                             ; preds = %892
  %1066 = add nsw i64 %894, -1
  %1067 = add i64 %893, 1
  %1068 = shl nuw i64 1, %893
  %1069 = and i64 %507, %1068
  %1070 = icmp eq i64 %1069, 0
  br i1 %1070, label %967, label %896

1071:                                             ; preds = %892, %1083
  %1072 = phi i64 [ %2175, %1083 ], [ 0, %892 ]
  %1073 = phi i64 [ %2174, %1083 ], [ 8, %892 ]
  %1074 = phi i1 [ %1084, %1083 ], [ false, %892 ]
  %1075 = icmp sgt i64 %1073, 0
  br i1 %1075, label %2173, label %1085

1076:                                             ; preds = %2173
  %1077 = icmp slt i64 %1072, 0
  %1078 = select i1 %1077, i64 %175, i64 0
  %1079 = getelementptr i64, ptr %176, i64 %1072
  %1080 = getelementptr i64, ptr %1079, i64 %1078
  %1081 = load i64, ptr %1080, align 8, !noalias !5
  %1082 = icmp eq i64 %1081, -1
  br label %1083

1083:                                             ; preds = %1076, %2173
  %1084 = phi i1 [ true, %2173 ], [ %1082, %1076 ]
  br label %1071

1085:                                             ; preds = %1071
  br i1 %1074, label %264, label %1086

1086:                                             ; preds = %490, %1085, %261
  %1087 = phi i64 [ %262, %261 ], [ %269, %1085 ], [ %269, %490 ]
  %1088 = phi i1 [ false, %261 ], [ false, %1085 ], [ true, %490 ]
  %1089 = getelementptr i8, ptr %184, i64 8
  %1090 = load i64, ptr %1089, align 8, !noalias !5
  %1091 = icmp slt i64 %1090, 1
  br i1 %1091, label %1092, label %1093

1092:                                             ; preds = %1086
  br label %2225

1093:                                             ; preds = %1086
  %1094 = add nsw i64 %1090, -1
  store i64 %1094, ptr %1089, align 8, !noalias !5
  %1095 = load <8 x double>, ptr %130, align 8, !noalias !5
  %1096 = load <8 x double>, ptr %135, align 8, !noalias !5
  %1097 = trunc i64 %1087 to i8
  %1098 = bitcast i8 %1097 to <8 x i1>
  br i1 %242, label %1099, label %1106

1099:                                             ; preds = %1093
  %1100 = insertelement <8 x double> poison, double %233, i64 0
  %1101 = shufflevector <8 x double> %1100, <8 x double> poison, <8 x i32> zeroinitializer
  %1102 = insertelement <8 x double> poison, double %234, i64 0
  %1103 = shufflevector <8 x double> %1102, <8 x double> poison, <8 x i32> zeroinitializer
  %1104 = fcmp olt <8 x double> %1096, %1103
  %1105 = select <8 x i1> %1104, <8 x double> %1096, <8 x double> %1103
  br label %1113

1106:                                             ; preds = %1093
  %1107 = load <8 x double>, ptr %151, align 8, !noalias !5
  %1108 = fsub <8 x double> %1107, %1095
  %1109 = fdiv <8 x double> %1108, %1096
  %1110 = fmul <8 x double> %1109, splat (double 0x3FEFFFFFFFFFDCD1)
  %1111 = call <8 x double> @llvm.ceil.v8f64(<8 x double> %1110)
  %1112 = fdiv <8 x double> %1108, %1111
  br label %1113

1113:                                             ; preds = %1106, %1099
  %1114 = phi <8 x double> [ %1101, %1099 ], [ %1107, %1106 ]
  %1115 = phi <8 x double> [ %1105, %1099 ], [ %1112, %1106 ]
  %1116 = fadd <8 x double> %1095, %1115
  %1117 = fmul <8 x double> %1115, splat (double 1.000000e-03)
  %1118 = fsub <8 x double> %1114, %1117
  %1119 = fcmp ogt <8 x double> %1116, %1118
  %1120 = fsub <8 x double> %1114, %1095
  %1121 = select <8 x i1> %1119, <8 x double> %1120, <8 x double> %1115
  %1122 = select <8 x i1> %1119, <8 x double> %1114, <8 x double> %1116
  %1123 = select <8 x i1> %1098, <8 x double> %1121, <8 x double> zeroinitializer
  %1124 = fmul <8 x double> %1123, splat (double 6.250000e-02)
  %1125 = fadd <8 x double> %1095, %1124
  %1126 = fcmp ule <8 x double> %1125, %1095
  %1127 = load <8 x double>, ptr %156, align 8, !noalias !5
  %1128 = load <8 x double>, ptr %161, align 8, !noalias !5
  %1129 = fadd <8 x double> %1127, %1128
  %1130 = insertelement <8 x double> poison, double %253, i64 0
  %1131 = shufflevector <8 x double> %1130, <8 x double> poison, <8 x i32> zeroinitializer
  %1132 = fcmp oge <8 x double> %1129, %1131
  %1133 = or <8 x i1> %1132, %1126
  %1134 = and <8 x i1> %1133, %1098
  %1135 = bitcast <8 x i1> %1134 to i8
  %1136 = zext i8 %1135 to i64
  %1137 = icmp eq i8 %1135, 0
  br i1 %1137, label %1234, label %1138

1138:                                             ; preds = %1113
  %1139 = bitcast <8 x i1> %1132 to i8
  %1140 = zext i8 %1139 to i64
  br label %1141

1141:                                             ; preds = %1138, %1227
  %1142 = phi i64 [ 0, %1138 ], [ %1230, %1227 ]
  %1143 = phi i64 [ 8, %1138 ], [ %1229, %1227 ]
  %1144 = icmp sgt i64 %1143, 0
  br i1 %1144, label %1228, label %259

1145:                                             ; preds = %1228
  %1146 = and i64 %1231, %1140
  %1147 = icmp eq i64 %1146, 0
  br i1 %1147, label %1148, label %1155

1148:                                             ; preds = %1145
  %1149 = icmp slt i64 %1142, 0
  %1150 = select i1 %1149, i64 %170, i64 0
  %1151 = getelementptr double, ptr %171, i64 %1142
  %1152 = getelementptr double, ptr %1151, i64 %1150
  %1153 = load double, ptr %1152, align 8, !noalias !82
  %1154 = fptosi double %1153 to i64
  br label %1155

1155:                                             ; preds = %1145, %1148
  %1156 = phi i64 [ %1154, %1148 ], [ 1, %1145 ]
  %1157 = icmp slt i64 %1142, 0
  %1158 = select i1 %1157, i64 %175, i64 0
  %1159 = getelementptr i64, ptr %176, i64 %1142
  %1160 = getelementptr i64, ptr %1159, i64 %1158
  %1161 = load i64, ptr %1160, align 8, !noalias !86
  %1162 = getelementptr i8, ptr %184, i64 32
  %1163 = load i64, ptr %1162, align 8, !noalias !86
  %1164 = shl nsw i64 %1163, 3
  %1165 = select i1 %1157, i64 %145, i64 0
  %1166 = getelementptr double, ptr %146, i64 %1142
  %1167 = getelementptr double, ptr %1166, i64 %1165
  %1168 = load double, ptr %1167, align 8, !noalias !86
  %1169 = fptosi double %1168 to i64
  %1170 = xor i64 %1169, -1
  %1171 = add i64 %191, %1170
  %1172 = call i64 @llvm.smax.i64(i64 %1171, i64 0)
  br label %1173

1173:                                             ; preds = %1177, %1155
  %1174 = phi i64 [ 0, %1155 ], [ %1214, %1177 ]
  %1175 = phi i64 [ %1172, %1155 ], [ %1213, %1177 ]
  %1176 = icmp sgt i64 %1175, 0
  br i1 %1176, label %1212, label %1181

1177:                                             ; preds = %1212, %1223
  %1178 = phi i64 [ %1222, %1212 ], [ %1224, %1223 ]
  %1179 = phi i64 [ %1220, %1212 ], [ %1226, %1223 ]
  %1180 = icmp sgt i64 %1178, 0
  br i1 %1180, label %1223, label %1173

1181:                                             ; preds = %1173
  %1182 = icmp slt i64 %1161, 0
  %1183 = select i1 %1182, i64 %217, i64 0
  %1184 = add i64 %1161, %1183
  %1185 = mul i64 %1184, %219
  %1186 = getelementptr i64, ptr %220, i64 %1185
  %1187 = select i1 %1157, i64 %155, i64 0
  %1188 = getelementptr double, ptr %156, i64 %1142
  %1189 = getelementptr double, ptr %1188, i64 %1187
  %1190 = load double, ptr %1189, align 8, !noalias !86
  %1191 = select i1 %1157, i64 %160, i64 0
  %1192 = getelementptr double, ptr %161, i64 %1142
  %1193 = getelementptr double, ptr %1192, i64 %1191
  %1194 = load double, ptr %1193, align 8, !noalias !86
  %1195 = fptosi double %1190 to i64
  store i64 %1195, ptr %1186, align 8, !noalias !86
  %1196 = getelementptr i8, ptr %1186, i64 8
  %1197 = fptosi double %1194 to i64
  store i64 %1197, ptr %1196, align 8, !noalias !86
  %1198 = select i1 %1157, i64 %165, i64 0
  %1199 = getelementptr double, ptr %166, i64 %1142
  %1200 = getelementptr double, ptr %1199, i64 %1198
  %1201 = load double, ptr %1200, align 8, !noalias !86
  %1202 = getelementptr i8, ptr %1186, i64 16
  %1203 = fptosi double %1201 to i64
  store i64 %1203, ptr %1202, align 8, !noalias !86
  %1204 = getelementptr i8, ptr %1186, i64 24
  store i64 %1156, ptr %1204, align 8, !noalias !86
  %1205 = select i1 %1157, i64 %129, i64 0
  %1206 = getelementptr double, ptr %130, i64 %1142
  %1207 = getelementptr double, ptr %1206, i64 %1205
  %1208 = load double, ptr %1207, align 8, !noalias !86
  %1209 = select i1 %1182, i64 %224, i64 0
  %1210 = getelementptr double, ptr %225, i64 %1161
  %1211 = getelementptr double, ptr %1210, i64 %1209
  store double %1208, ptr %1211, align 8, !noalias !86
  store i64 -1, ptr %1160, align 8, !noalias !86
  br label %1227

1212:                                             ; preds = %1173
  %1213 = add nsw i64 %1175, -1
  %1214 = add i64 %1174, 1
  %1215 = shl nsw i64 %1174, 3
  %1216 = select i1 %1157, i64 %180, i64 0
  %1217 = getelementptr i64, ptr %181, i64 %1142
  %1218 = getelementptr i64, ptr %1217, i64 %1216
  %1219 = load i64, ptr %1218, align 8, !noalias !86
  %1220 = add nsw i64 %1219, %1215
  %1221 = load i64, ptr %226, align 8, !noalias !86
  %1222 = call i64 @llvm.smax.i64(i64 %1221, i64 0)
  br label %1177

1223:                                             ; preds = %1177
  %1224 = add nsw i64 %1178, -1
  %1225 = inttoptr i64 %1179 to ptr
  store atomic i64 9221120237041090560, ptr %1225 unordered, align 8, !noalias !86
  %1226 = add nsw i64 %1179, %1164
  br label %1177

1227:                                             ; preds = %1181, %1228
  br label %1141

1228:                                             ; preds = %1141
  %1229 = add nsw i64 %1143, -1
  %1230 = add i64 %1142, 1
  %1231 = shl nuw i64 1, %1142
  %1232 = and i64 %1231, %1136
  %1233 = icmp eq i64 %1232, 0
  br i1 %1233, label %1227, label %1145

1234:                                             ; preds = %1113
  store <8 x double> %1123, ptr %98, align 8, !noalias !90
  %1235 = load i64, ptr %16, align 8, !noalias !90
  %1236 = add i64 %1235, -1
  %1237 = call i64 @llvm.smax.i64(i64 %1236, i64 0)
  br label %1238

1238:                                             ; preds = %1292, %1234
  %1239 = phi i64 [ 1, %1234 ], [ %1262, %1292 ]
  %1240 = phi i64 [ %1237, %1234 ], [ %1261, %1292 ]
  %1241 = phi i64 [ 0, %1234 ], [ %1298, %1292 ]
  %1242 = icmp sgt i64 %1240, 0
  br i1 %1242, label %1260, label %1243

1243:                                             ; preds = %1238
  %1244 = load i64, ptr %16, align 8, !noalias !90
  %1245 = icmp slt i64 %1244, 0
  %1246 = select i1 %1245, i64 %20, i64 0
  %1247 = getelementptr i64, ptr %21, i64 %1244
  %1248 = getelementptr i64, ptr %1247, i64 %1246
  %1249 = load i64, ptr %1248, align 8, !noalias !94
  %1250 = shl i64 %1249, 3
  %1251 = add i64 %23, %1250
  %1252 = add i64 %25, %1250
  %1253 = icmp slt i64 %1244, -1
  %1254 = select i1 %1253, i64 %20, i64 0
  %1255 = getelementptr i8, ptr %1247, i64 8
  %1256 = getelementptr i64, ptr %1255, i64 %1254
  %1257 = load i64, ptr %1256, align 8, !noalias !94
  %1258 = sub nsw i64 %1257, %1249
  %1259 = load i64, ptr %226, align 8, !noalias !94
  call fastcc void @pydy_combine(i64 %87, i64 %82, i64 %97, i64 %109, i64 %1251, i64 %1252, i64 %1258, i64 %1259) #3, !noalias !94
  br i1 %245, label %1311, label %1300

1260:                                             ; preds = %1238
  %1261 = add nsw i64 %1240, -1
  %1262 = add i64 %1239, 1
  %1263 = icmp slt i64 %1239, 0
  %1264 = select i1 %1263, i64 %20, i64 0
  %1265 = getelementptr i64, ptr %21, i64 %1239
  %1266 = getelementptr i64, ptr %1265, i64 %1264
  %1267 = load i64, ptr %1266, align 8, !noalias !97
  %1268 = shl i64 %1267, 3
  %1269 = add i64 %23, %1268
  %1270 = add i64 %25, %1268
  %1271 = icmp slt i64 %1239, -1
  %1272 = select i1 %1271, i64 %20, i64 0
  %1273 = getelementptr i8, ptr %1265, i64 8
  %1274 = getelementptr i64, ptr %1273, i64 %1272
  %1275 = load i64, ptr %1274, align 8, !noalias !97
  %1276 = sub nsw i64 %1275, %1267
  %1277 = load i64, ptr %226, align 8, !noalias !97
  call fastcc void @pydy_combine(i64 %92, i64 %82, i64 %97, i64 %109, i64 %1269, i64 %1270, i64 %1276, i64 %1277) #3, !noalias !97
  %1278 = mul nsw i64 %1239, %84
  %1279 = shl i64 %1278, 3
  %1280 = add i64 %109, %1279
  %1281 = select i1 %1263, i64 %29, i64 0
  %1282 = getelementptr double, ptr %30, i64 %1239
  %1283 = getelementptr double, ptr %1282, i64 %1281
  %1284 = load double, ptr %1283, align 8, !noalias !90
  %1285 = insertelement <8 x double> poison, double %1284, i64 0
  %1286 = shufflevector <8 x double> %1285, <8 x double> poison, <8 x i32> zeroinitializer
  %1287 = fmul <8 x double> %1286, %1123
  %1288 = fadd <8 x double> %1095, %1287
  store ptr null, ptr %8, align 8, !noalias !100
  store ptr null, ptr %9, align 8, !noalias !100
  store <8 x double> %1288, ptr %41, align 8, !noalias !100
  %1289 = icmp sgt i64 %58, 0
  br i1 %1289, label %1290, label %1292

1290:                                             ; preds = %1260
  store ptr null, ptr %8, align 8, !noalias !100
  %1291 = call fastcc i32 @_set_inputs(ptr nonnull %8, ptr nonnull %41, i64 %40, ptr %46, i64 %45, ptr %61, i64 %58, i64 %60, ptr %68, i64 %65, i64 %67, ptr %73, i64 %72, ptr %80, i64 %77, i64 %79) #3
  switch i32 %1291, label %1299 [
    i32 -2, label %1292
    i32 0, label %1292
  ], !prof !49

1292:                                             ; preds = %1290, %1290, %1260
  %1293 = load i64, ptr %36, align 8, !noalias !100
  %1294 = inttoptr i64 %1293 to ptr
  %1295 = inttoptr i64 %1280 to ptr
  %1296 = call i32 %1294(ptr nonnull %41, ptr %95, ptr %46, ptr %54, ptr %1295) #3, !noalias !100
  %1297 = sext i32 %1296 to i64
  %1298 = or i64 %1241, %1297
  br label %1238

1299:                                             ; preds = %1290
  br label %2225

1300:                                             ; preds = %1243
  store ptr null, ptr %6, align 8, !noalias !104
  store ptr null, ptr %7, align 8, !noalias !104
  store <8 x double> %1122, ptr %41, align 8, !noalias !104
  %1301 = icmp sgt i64 %58, 0
  br i1 %1301, label %1302, label %1304

1302:                                             ; preds = %1300
  store ptr null, ptr %6, align 8, !noalias !104
  %1303 = call fastcc i32 @_set_inputs(ptr nonnull %6, ptr nonnull %41, i64 %40, ptr %46, i64 %45, ptr %61, i64 %58, i64 %60, ptr %68, i64 %65, i64 %67, ptr %73, i64 %72, ptr %80, i64 %77, i64 %79) #3
  switch i32 %1303, label %2176 [
    i32 -2, label %1304
    i32 0, label %1304
  ], !prof !49

1304:                                             ; preds = %1302, %1302, %1300
  %1305 = load i64, ptr %36, align 8, !noalias !104
  %1306 = inttoptr i64 %1305 to ptr
  %1307 = inttoptr i64 %238 to ptr
  %1308 = call i32 %1306(ptr nonnull %41, ptr %90, ptr %46, ptr %54, ptr %1307) #3, !noalias !104
  %1309 = sext i32 %1308 to i64
  %1310 = or i64 %1241, %1309
  br label %1311

1311:                                             ; preds = %1304, %1243
  %1312 = phi i64 [ %1310, %1304 ], [ %1241, %1243 ]
  br i1 %242, label %1313, label %1412

1313:                                             ; preds = %1311
  %1314 = load i64, ptr %226, align 8, !noalias !108
  %1315 = load i64, ptr %240, align 8, !noalias !108
  %1316 = load i64, ptr %16, align 8, !noalias !108
  %1317 = add nsw i64 %1316, 1
  %1318 = call i64 @llvm.smax.i64(i64 %1315, i64 0)
  br label %1319

1319:                                             ; preds = %1313, %1350
  %1320 = phi i64 [ 0, %1313 ], [ %1352, %1350 ]
  %1321 = phi i64 [ %1318, %1313 ], [ %1351, %1350 ]
  %1322 = icmp sgt i64 %1321, 0
  br i1 %1322, label %1350, label %1323

1323:                                             ; preds = %1319
  %1324 = call i64 @llvm.smax.i64(i64 %1314, i64 0)
  br label %1325

1325:                                             ; preds = %1323, %1372
  %1326 = phi i64 [ 0, %1323 ], [ %1374, %1372 ]
  %1327 = phi i64 [ %1324, %1323 ], [ %1373, %1372 ]
  %1328 = phi <8 x double> [ zeroinitializer, %1323 ], [ %1409, %1372 ]
  %1329 = phi <8 x double> [ zeroinitializer, %1323 ], [ %1411, %1372 ]
  %1330 = icmp sgt i64 %1327, 0
  br i1 %1330, label %1372, label %1331

1331:                                             ; preds = %1325
  %1332 = icmp eq i64 %1315, 2
  br i1 %1332, label %1333, label %1344

1333:                                             ; preds = %1331
  %1334 = fmul <8 x double> %1329, splat (double 1.000000e-02)
  %1335 = fadd <8 x double> %1328, %1334
  %1336 = sitofp i64 %1314 to double
  %1337 = insertelement <8 x double> poison, double %1336, i64 0
  %1338 = shufflevector <8 x double> %1337, <8 x double> poison, <8 x i32> zeroinitializer
  %1339 = fmul <8 x double> %1335, %1338
  %1340 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1339)
  %1341 = fdiv <8 x double> %1328, %1340
  %1342 = fcmp oeq <8 x double> %1328, zeroinitializer
  %1343 = select <8 x i1> %1342, <8 x double> zeroinitializer, <8 x double> %1341
  br label %1419

1344:                                             ; preds = %1331
  %1345 = sitofp i64 %1314 to double
  %1346 = insertelement <8 x double> poison, double %1345, i64 0
  %1347 = shufflevector <8 x double> %1346, <8 x double> poison, <8 x i32> zeroinitializer
  %1348 = fdiv <8 x double> %1328, %1347
  %1349 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %1348)
  br label %1419

1350:                                             ; preds = %1319
  %1351 = add nsw i64 %1321, -1
  %1352 = add i64 %1320, 1
  %1353 = add nsw i64 %1317, %1320
  %1354 = mul nsw i64 %1320, %84
  %1355 = shl i64 %1354, 3
  %1356 = add i64 %106, %1355
  %1357 = icmp slt i64 %1353, 0
  %1358 = select i1 %1357, i64 %20, i64 0
  %1359 = getelementptr i64, ptr %21, i64 %1353
  %1360 = getelementptr i64, ptr %1359, i64 %1358
  %1361 = load i64, ptr %1360, align 8, !noalias !112
  %1362 = shl i64 %1361, 3
  %1363 = add i64 %23, %1362
  %1364 = add i64 %25, %1362
  %1365 = icmp slt i64 %1353, -1
  %1366 = select i1 %1365, i64 %20, i64 0
  %1367 = getelementptr i8, ptr %1359, i64 8
  %1368 = getelementptr i64, ptr %1367, i64 %1366
  %1369 = load i64, ptr %1368, align 8, !noalias !112
  %1370 = sub nsw i64 %1369, %1361
  %1371 = load i64, ptr %226, align 8, !noalias !112
  call fastcc void @pydy_combine(i64 %1356, i64 %103, i64 %97, i64 %109, i64 %1363, i64 %1364, i64 %1370, i64 %1371) #3, !noalias !112
  br label %1319

1372:                                             ; preds = %1325
  %1373 = add nsw i64 %1327, -1
  %1374 = add i64 %1326, 1
  %1375 = shl i64 %1326, 6
  %1376 = getelementptr i8, ptr %85, i64 %1375
  %1377 = load <8 x double>, ptr %1376, align 8, !noalias !108
  %1378 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1377)
  %1379 = getelementptr i8, ptr %90, i64 %1375
  %1380 = load <8 x double>, ptr %1379, align 8, !noalias !108
  %1381 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1380)
  %1382 = fcmp ogt <8 x double> %1378, %1381
  %1383 = select <8 x i1> %1382, <8 x double> %1378, <8 x double> %1381
  %1384 = icmp slt i64 %1326, 0
  %1385 = select i1 %1384, i64 %124, i64 0
  %1386 = getelementptr double, ptr %125, i64 %1326
  %1387 = getelementptr double, ptr %1386, i64 %1385
  %1388 = load double, ptr %1387, align 8, !noalias !108
  %1389 = select i1 %1384, i64 %119, i64 0
  %1390 = getelementptr double, ptr %120, i64 %1326
  %1391 = getelementptr double, ptr %1390, i64 %1389
  %1392 = load double, ptr %1391, align 8, !noalias !108
  %1393 = insertelement <8 x double> poison, double %1392, i64 0
  %1394 = shufflevector <8 x double> %1393, <8 x double> poison, <8 x i32> zeroinitializer
  %1395 = fmul <8 x double> %1394, %1383
  %1396 = insertelement <8 x double> poison, double %1388, i64 0
  %1397 = shufflevector <8 x double> %1396, <8 x double> poison, <8 x i32> zeroinitializer
  %1398 = fadd <8 x double> %1397, %1395
  %1399 = fdiv <8 x double> splat (double 1.000000e+00), %1398
  %1400 = getelementptr i8, ptr %107, i64 %1375
  %1401 = load <8 x double>, ptr %1400, align 8, !noalias !108
  %1402 = fmul <8 x double> %1401, %1399
  %1403 = add nsw i64 %1314, %1326
  %1404 = shl i64 %1403, 6
  %1405 = getelementptr i8, ptr %107, i64 %1404
  %1406 = load <8 x double>, ptr %1405, align 8, !noalias !108
  %1407 = fmul <8 x double> %1406, %1399
  %1408 = fmul <8 x double> %1402, %1402
  %1409 = fadd <8 x double> %1328, %1408
  %1410 = fmul <8 x double> %1407, %1407
  %1411 = fadd <8 x double> %1329, %1410
  br label %1325

1412:                                             ; preds = %1311
  %1413 = call i64 @llvm.smax.i64(i64 %227, i64 0)
  br label %1414

1414:                                             ; preds = %1412, %2177
  %1415 = phi i64 [ 0, %1412 ], [ %2179, %2177 ]
  %1416 = phi i64 [ %1413, %1412 ], [ %2178, %2177 ]
  %1417 = phi <8 x double> [ zeroinitializer, %1412 ], [ %2184, %2177 ]
  %1418 = icmp sgt i64 %1416, 0
  br i1 %1418, label %2177, label %1419

1419:                                             ; preds = %1414, %1333, %1344
  %1420 = phi <8 x double> [ %1417, %1414 ], [ %1349, %1344 ], [ %1343, %1333 ]
  %1421 = fcmp olt <8 x double> %1420, splat (double 1.000000e+00)
  %1422 = trunc i64 %1312 to i8
  %1423 = bitcast i8 %1422 to <8 x i1>
  %1424 = xor <8 x i1> %1423, splat (i1 true)
  %1425 = and <8 x i1> %1421, %1424
  %1426 = and <8 x i1> %1425, %1098
  %1427 = bitcast <8 x i1> %1426 to i8
  %1428 = icmp ne i8 %1427, 0
  %1429 = select i1 %245, i1 %1428, i1 false
  br i1 %1429, label %1430, label %1445

1430:                                             ; preds = %1419
  store ptr null, ptr %4, align 8, !noalias !115
  store ptr null, ptr %5, align 8, !noalias !115
  store <8 x double> %1122, ptr %41, align 8, !noalias !115
  %1431 = icmp sgt i64 %58, 0
  br i1 %1431, label %1432, label %1434

1432:                                             ; preds = %1430
  store ptr null, ptr %4, align 8, !noalias !115
  %1433 = call fastcc i32 @_set_inputs(ptr nonnull %4, ptr nonnull %41, i64 %40, ptr %46, i64 %45, ptr %61, i64 %58, i64 %60, ptr %68, i64 %65, i64 %67, ptr %73, i64 %72, ptr %80, i64 %77, i64 %79) #3
  switch i32 %1433, label %2185 [
    i32 -2, label %1434
    i32 0, label %1434
  ], !prof !49

1434:                                             ; preds = %1432, %1432, %1430
  %1435 = load i64, ptr %36, align 8, !noalias !115
  %1436 = inttoptr i64 %1435 to ptr
  %1437 = inttoptr i64 %238 to ptr
  %1438 = call i32 %1436(ptr nonnull %41, ptr %90, ptr %46, ptr %54, ptr %1437) #3, !noalias !115
  %1439 = sext i32 %1438 to i64
  %1440 = or i64 %1312, %1439
  %1441 = trunc i64 %1440 to i8
  %1442 = bitcast i8 %1441 to <8 x i1>
  %1443 = xor <8 x i1> %1442, splat (i1 true)
  %1444 = and <8 x i1> %1426, %1443
  br label %1445

1445:                                             ; preds = %1434, %1419
  %1446 = phi i64 [ %1312, %1419 ], [ %1440, %1434 ]
  %1447 = phi <8 x i1> [ %1426, %1419 ], [ %1444, %1434 ]
  %1448 = load <8 x double>, ptr %166, align 8, !noalias !5
  %1449 = insertelement <8 x double> poison, double %248, i64 0
  %1450 = shufflevector <8 x double> %1449, <8 x double> poison, <8 x i32> zeroinitializer
  %1451 = fadd <8 x double> %1448, %1450
  %1452 = insertelement <8 x double> poison, double %250, i64 0
  %1453 = shufflevector <8 x double> %1452, <8 x double> poison, <8 x i32> zeroinitializer
  %1454 = select <8 x i1> %1426, <8 x double> %1453, <8 x double> zeroinitializer
  %1455 = fadd <8 x double> %1451, %1454
  store <8 x double> %1455, ptr %166, align 8, !noalias !5
  %1456 = load <8 x double>, ptr %151, align 8, !noalias !5
  %1457 = fcmp olt <8 x double> %1456, %1122
  %1458 = and <8 x i1> %1447, %1457
  %1459 = bitcast <8 x i1> %1458 to i8
  %1460 = icmp eq i8 %1459, 0
  br i1 %1460, label %1770, label %1461

1461:                                             ; preds = %1445
  %1462 = load i64, ptr %226, align 8, !noalias !119
  %1463 = load i64, ptr %16, align 8, !noalias !119
  %1464 = add nsw i64 %1463, 1
  %1465 = load i64, ptr %240, align 8, !noalias !119
  %1466 = add nsw i64 %1464, %1465
  %1467 = getelementptr i8, ptr %16, i64 16
  %1468 = load i64, ptr %1467, align 8, !noalias !119
  %1469 = call i64 @llvm.smax.i64(i64 %1468, i64 0)
  br label %1470

1470:                                             ; preds = %1526, %1461
  %1471 = phi i64 [ 0, %1461 ], [ %1494, %1526 ]
  %1472 = phi i64 [ %1469, %1461 ], [ %1493, %1526 ]
  %1473 = phi i64 [ %1466, %1461 ], [ %1533, %1526 ]
  %1474 = phi i64 [ 0, %1461 ], [ %1532, %1526 ]
  %1475 = icmp sgt i64 %1472, 0
  br i1 %1475, label %1492, label %1476

1476:                                             ; preds = %1470
  %1477 = call i64 @llvm.smax.i64(i64 %1462, i64 0)
  br label %1478

1478:                                             ; preds = %1476, %1535
  %1479 = phi i64 [ 0, %1476 ], [ %1537, %1535 ]
  %1480 = phi i64 [ %1477, %1476 ], [ %1536, %1535 ]
  %1481 = icmp sgt i64 %1480, 0
  br i1 %1481, label %1535, label %1482

1482:                                             ; preds = %1478
  %1483 = getelementptr i8, ptr %16, i64 24
  %1484 = load i64, ptr %1483, align 8, !noalias !119
  %1485 = add i64 %1484, -3
  %1486 = call i64 @llvm.smax.i64(i64 %1485, i64 0)
  br label %1487

1487:                                             ; preds = %1482, %1563
  %1488 = phi i64 [ 3, %1482 ], [ %1565, %1563 ]
  %1489 = phi i64 [ %1486, %1482 ], [ %1564, %1563 ]
  %1490 = phi i64 [ %1473, %1482 ], [ %1584, %1563 ]
  %1491 = icmp sgt i64 %1489, 0
  br i1 %1491, label %1563, label %2186

1492:                                             ; preds = %1470
  %1493 = add nsw i64 %1472, -1
  %1494 = add i64 %1471, 1
  %1495 = icmp slt i64 %1473, 0
  %1496 = select i1 %1495, i64 %20, i64 0
  %1497 = getelementptr i64, ptr %21, i64 %1473
  %1498 = getelementptr i64, ptr %1497, i64 %1496
  %1499 = load i64, ptr %1498, align 8, !noalias !123
  %1500 = shl i64 %1499, 3
  %1501 = add i64 %23, %1500
  %1502 = add i64 %25, %1500
  %1503 = icmp slt i64 %1473, -1
  %1504 = select i1 %1503, i64 %20, i64 0
  %1505 = getelementptr i8, ptr %1497, i64 8
  %1506 = getelementptr i64, ptr %1505, i64 %1504
  %1507 = load i64, ptr %1506, align 8, !noalias !123
  %1508 = sub nsw i64 %1507, %1499
  %1509 = load i64, ptr %226, align 8, !noalias !123
  call fastcc void @pydy_combine(i64 %92, i64 %82, i64 %97, i64 %109, i64 %1501, i64 %1502, i64 %1508, i64 %1509) #3, !noalias !123
  %1510 = add nsw i64 %1464, %1471
  %1511 = mul nsw i64 %1510, %84
  %1512 = shl i64 %1511, 3
  %1513 = add i64 %109, %1512
  %1514 = icmp slt i64 %1510, 0
  %1515 = select i1 %1514, i64 %29, i64 0
  %1516 = getelementptr double, ptr %30, i64 %1510
  %1517 = getelementptr double, ptr %1516, i64 %1515
  %1518 = load double, ptr %1517, align 8, !noalias !119
  %1519 = insertelement <8 x double> poison, double %1518, i64 0
  %1520 = shufflevector <8 x double> %1519, <8 x double> poison, <8 x i32> zeroinitializer
  %1521 = fmul <8 x double> %1520, %1123
  %1522 = fadd <8 x double> %1095, %1521
  store ptr null, ptr %2, align 8, !noalias !126
  store ptr null, ptr %3, align 8, !noalias !126
  store <8 x double> %1522, ptr %41, align 8, !noalias !126
  %1523 = icmp sgt i64 %58, 0
  br i1 %1523, label %1524, label %1526

1524:                                             ; preds = %1492
  store ptr null, ptr %2, align 8, !noalias !126
  %1525 = call fastcc i32 @_set_inputs(ptr nonnull %2, ptr nonnull %41, i64 %40, ptr %46, i64 %45, ptr %61, i64 %58, i64 %60, ptr %68, i64 %65, i64 %67, ptr %73, i64 %72, ptr %80, i64 %77, i64 %79) #3
  switch i32 %1525, label %1534 [
    i32 -2, label %1526
    i32 0, label %1526
  ], !prof !49

1526:                                             ; preds = %1524, %1524, %1492
  %1527 = load i64, ptr %36, align 8, !noalias !126
  %1528 = inttoptr i64 %1527 to ptr
  %1529 = inttoptr i64 %1513 to ptr
  %1530 = call i32 %1528(ptr nonnull %41, ptr %95, ptr %46, ptr %54, ptr %1529) #3, !noalias !126
  %1531 = sext i32 %1530 to i64
  %1532 = or i64 %1474, %1531
  %1533 = add nsw i64 %1473, 1
  br label %1470

1534:                                             ; preds = %1524
  br label %2225

1535:                                             ; preds = %1478
  %1536 = add nsw i64 %1480, -1
  %1537 = add i64 %1479, 1
  %1538 = shl i64 %1479, 6
  %1539 = getelementptr i8, ptr %90, i64 %1538
  %1540 = load <8 x double>, ptr %1539, align 8, !noalias !119
  %1541 = getelementptr i8, ptr %85, i64 %1538
  %1542 = load <8 x double>, ptr %1541, align 8, !noalias !119
  %1543 = fsub <8 x double> %1540, %1542
  %1544 = getelementptr i8, ptr %112, i64 %1538
  %1545 = load <8 x double>, ptr %1544, align 8, !noalias !119
  %1546 = fmul <8 x double> %1123, %1545
  %1547 = fsub <8 x double> %1546, %1543
  %1548 = getelementptr i8, ptr %115, i64 %1538
  store <8 x double> %1543, ptr %1548, align 8, !noalias !119
  %1549 = add nsw i64 %1462, %1479
  %1550 = shl i64 %1549, 6
  %1551 = getelementptr i8, ptr %115, i64 %1550
  store <8 x double> %1547, ptr %1551, align 8, !noalias !119
  %1552 = fsub <8 x double> %1543, %1547
  %1553 = mul nsw i64 %1463, %1462
  %1554 = add nsw i64 %1553, %1479
  %1555 = shl i64 %1554, 6
  %1556 = getelementptr i8, ptr %112, i64 %1555
  %1557 = load <8 x double>, ptr %1556, align 8, !noalias !119
  %1558 = fmul <8 x double> %1123, %1557
  %1559 = fsub <8 x double> %1552, %1558
  %1560 = shl i64 %1462, 7
  %1561 = getelementptr i8, ptr %115, i64 %1560
  %1562 = getelementptr i8, ptr %1561, i64 %1538
  store <8 x double> %1559, ptr %1562, align 8, !noalias !119
  br label %1478

1563:                                             ; preds = %1487
  %1564 = add nsw i64 %1489, -1
  %1565 = add i64 %1488, 1
  %1566 = mul nsw i64 %1488, %84
  %1567 = shl i64 %1566, 3
  %1568 = add i64 %114, %1567
  %1569 = icmp slt i64 %1490, 0
  %1570 = select i1 %1569, i64 %20, i64 0
  %1571 = getelementptr i64, ptr %21, i64 %1490
  %1572 = getelementptr i64, ptr %1571, i64 %1570
  %1573 = load i64, ptr %1572, align 8, !noalias !130
  %1574 = shl i64 %1573, 3
  %1575 = add i64 %23, %1574
  %1576 = add i64 %25, %1574
  %1577 = icmp slt i64 %1490, -1
  %1578 = select i1 %1577, i64 %20, i64 0
  %1579 = getelementptr i8, ptr %1571, i64 8
  %1580 = getelementptr i64, ptr %1579, i64 %1578
  %1581 = load i64, ptr %1580, align 8, !noalias !130
  %1582 = sub nsw i64 %1581, %1573
  %1583 = load i64, ptr %226, align 8, !noalias !130
  call fastcc void @pydy_combine(i64 %1568, i64 %103, i64 %97, i64 %109, i64 %1575, i64 %1576, i64 %1582, i64 %1583) #3, !noalias !130
  %1584 = add nsw i64 %1490, 1
  br label %1487

1585:                                             ; preds = %2186, %1660
  %1586 = phi i64 [ %2199, %1660 ], [ 0, %2186 ]
  %1587 = phi i64 [ %2198, %1660 ], [ 8, %2186 ]
  %1588 = icmp sgt i64 %1587, 0
  br i1 %1588, label %2197, label %1661

1589:                                             ; preds = %2197
  %1590 = icmp slt i64 %1586, 0
  %1591 = select i1 %1590, i64 %175, i64 0
  %1592 = getelementptr i64, ptr %176, i64 %1586
  %1593 = getelementptr i64, ptr %1592, i64 %1591
  %1594 = load i64, ptr %1593, align 8, !noalias !133
  %1595 = getelementptr i8, ptr %184, i64 32
  %1596 = load i64, ptr %1595, align 8, !noalias !133
  %1597 = shl nsw i64 %1596, 3
  %1598 = select i1 %1590, i64 %145, i64 0
  %1599 = getelementptr double, ptr %146, i64 %1586
  %1600 = getelementptr double, ptr %1599, i64 %1598
  %1601 = load double, ptr %1600, align 8, !noalias !133
  %1602 = fptosi double %1601 to i64
  %1603 = xor i64 %1602, -1
  %1604 = add i64 %191, %1603
  %1605 = call i64 @llvm.smax.i64(i64 %1604, i64 0)
  br label %1606

1606:                                             ; preds = %1610, %1589
  %1607 = phi i64 [ 0, %1589 ], [ %1647, %1610 ]
  %1608 = phi i64 [ %1605, %1589 ], [ %1646, %1610 ]
  %1609 = icmp sgt i64 %1608, 0
  br i1 %1609, label %1645, label %1614

1610:                                             ; preds = %1645, %1656
  %1611 = phi i64 [ %1655, %1645 ], [ %1657, %1656 ]
  %1612 = phi i64 [ %1653, %1645 ], [ %1659, %1656 ]
  %1613 = icmp sgt i64 %1611, 0
  br i1 %1613, label %1656, label %1606

1614:                                             ; preds = %1606
  %1615 = icmp slt i64 %1594, 0
  %1616 = select i1 %1615, i64 %217, i64 0
  %1617 = add i64 %1594, %1616
  %1618 = mul i64 %1617, %219
  %1619 = getelementptr i64, ptr %220, i64 %1618
  %1620 = select i1 %1590, i64 %155, i64 0
  %1621 = getelementptr double, ptr %156, i64 %1586
  %1622 = getelementptr double, ptr %1621, i64 %1620
  %1623 = load double, ptr %1622, align 8, !noalias !133
  %1624 = select i1 %1590, i64 %160, i64 0
  %1625 = getelementptr double, ptr %161, i64 %1586
  %1626 = getelementptr double, ptr %1625, i64 %1624
  %1627 = load double, ptr %1626, align 8, !noalias !133
  %1628 = fptosi double %1623 to i64
  store i64 %1628, ptr %1619, align 8, !noalias !133
  %1629 = getelementptr i8, ptr %1619, i64 8
  %1630 = fptosi double %1627 to i64
  store i64 %1630, ptr %1629, align 8, !noalias !133
  %1631 = select i1 %1590, i64 %165, i64 0
  %1632 = getelementptr double, ptr %166, i64 %1586
  %1633 = getelementptr double, ptr %1632, i64 %1631
  %1634 = load double, ptr %1633, align 8, !noalias !133
  %1635 = getelementptr i8, ptr %1619, i64 16
  %1636 = fptosi double %1634 to i64
  store i64 %1636, ptr %1635, align 8, !noalias !133
  %1637 = getelementptr i8, ptr %1619, i64 24
  store i64 3, ptr %1637, align 8, !noalias !133
  %1638 = select i1 %1590, i64 %129, i64 0
  %1639 = getelementptr double, ptr %130, i64 %1586
  %1640 = getelementptr double, ptr %1639, i64 %1638
  %1641 = load double, ptr %1640, align 8, !noalias !133
  %1642 = select i1 %1615, i64 %224, i64 0
  %1643 = getelementptr double, ptr %225, i64 %1594
  %1644 = getelementptr double, ptr %1643, i64 %1642
  store double %1641, ptr %1644, align 8, !noalias !133
  store i64 -1, ptr %1593, align 8, !noalias !133
  br label %1660

1645:                                             ; preds = %1606
  %1646 = add nsw i64 %1608, -1
  %1647 = add i64 %1607, 1
  %1648 = shl nsw i64 %1607, 3
  %1649 = select i1 %1590, i64 %180, i64 0
  %1650 = getelementptr i64, ptr %181, i64 %1586
  %1651 = getelementptr i64, ptr %1650, i64 %1649
  %1652 = load i64, ptr %1651, align 8, !noalias !133
  %1653 = add nsw i64 %1652, %1648
  %1654 = load i64, ptr %226, align 8, !noalias !133
  %1655 = call i64 @llvm.smax.i64(i64 %1654, i64 0)
  br label %1610

1656:                                             ; preds = %1610
  %1657 = add nsw i64 %1611, -1
  %1658 = inttoptr i64 %1612 to ptr
  store atomic i64 9221120237041090560, ptr %1658 unordered, align 8, !noalias !133
  %1659 = add nsw i64 %1612, %1597
  br label %1610

1660:                                             ; preds = %1614, %2197
  br label %1585

1661:                                             ; preds = %1585
  %1662 = xor i64 %2188, -1
  %1663 = and i64 %1087, %1662
  %1664 = trunc i64 %1663 to i8
  %1665 = bitcast i8 %1664 to <8 x i1>
  %1666 = and <8 x i1> %1447, %1665
  %1667 = and <8 x i1> %1458, %1665
  br label %1668

1668:                                             ; preds = %2186, %1661
  %1669 = phi i64 [ %1663, %1661 ], [ %1087, %2186 ]
  %1670 = phi i1 [ true, %1661 ], [ %1088, %2186 ]
  %1671 = phi <8 x i1> [ %1666, %1661 ], [ %1447, %2186 ]
  %1672 = phi <8 x i1> [ %1667, %1661 ], [ %1458, %2186 ]
  %1673 = bitcast <8 x i1> %1672 to i8
  %1674 = zext i8 %1673 to i64
  %1675 = load <8 x double>, ptr %130, align 8, !noalias !137
  %1676 = load <8 x double>, ptr %98, align 8, !noalias !137
  %1677 = fdiv <8 x double> splat (double 1.000000e+00), %1676
  %1678 = icmp eq i8 %1673, 0
  br i1 %1678, label %1770, label %1679

1679:                                             ; preds = %1668, %1707
  %1680 = phi i64 [ %1756, %1707 ], [ %1674, %1668 ]
  %1681 = load <8 x double>, ptr %151, align 8, !noalias !137
  %1682 = fsub <8 x double> %1681, %1675
  %1683 = fmul <8 x double> %1682, %1677
  store <8 x double> %1683, ptr %101, align 8, !noalias !137
  %1684 = load i64, ptr %1483, align 8, !noalias !137
  %1685 = load i64, ptr %226, align 8, !noalias !137
  call fastcc void @pydy_nested(i64 %92, i64 %82, i64 %114, i64 %84, i64 %1684, i64 %100, i64 %1685) #3, !noalias !137
  %1686 = getelementptr i8, ptr %184, i64 32
  %1687 = load i64, ptr %1686, align 8, !noalias !141
  %1688 = shl nsw i64 %1687, 3
  %1689 = load i64, ptr %226, align 8, !noalias !141
  %1690 = icmp eq i64 %1680, 0
  br i1 %1690, label %1707, label %1691

1691:                                             ; preds = %1679, %1705
  %1692 = phi i64 [ %1695, %1705 ], [ %1680, %1679 ]
  %1693 = call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %1692, i1 true)
  %1694 = add nsw i64 %1692, -1
  %1695 = and i64 %1692, %1694
  %1696 = getelementptr i64, ptr %181, i64 %1693
  %1697 = load i64, ptr %1696, align 8, !noalias !141
  %1698 = add nsw i64 %1697, 8
  store i64 %1698, ptr %1696, align 8, !noalias !141
  %1699 = call i64 @llvm.smax.i64(i64 %1689, i64 0)
  br label %1700

1700:                                             ; preds = %1691, %1758
  %1701 = phi i64 [ 0, %1691 ], [ %1760, %1758 ]
  %1702 = phi i64 [ %1699, %1691 ], [ %1759, %1758 ]
  %1703 = phi i64 [ %1697, %1691 ], [ %1769, %1758 ]
  %1704 = icmp sgt i64 %1702, 0
  br i1 %1704, label %1758, label %1705

1705:                                             ; preds = %1700
  %1706 = icmp eq i64 %1695, 0
  br i1 %1706, label %1707, label %1691

1707:                                             ; preds = %1705, %1679
  %1708 = load <8 x double>, ptr %146, align 8, !noalias !141
  %1709 = trunc i64 %1680 to i8
  %1710 = bitcast i8 %1709 to <8 x i1>
  %1711 = select <8 x i1> %1710, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %1712 = fadd <8 x double> %1708, %1711
  store <8 x double> %1712, ptr %146, align 8, !noalias !141
  %1713 = extractelement <8 x double> %1712, i64 0
  %1714 = fptosi double %1713 to i64
  %1715 = getelementptr double, ptr %192, i64 %1714
  %1716 = load double, ptr %1715, align 8, !noalias !141
  %1717 = insertelement <8 x double> poison, double %1716, i64 0
  %1718 = extractelement <8 x double> %1712, i64 1
  %1719 = fptosi double %1718 to i64
  %1720 = getelementptr double, ptr %192, i64 %1719
  %1721 = load double, ptr %1720, align 8, !noalias !141
  %1722 = insertelement <8 x double> %1717, double %1721, i64 1
  %1723 = extractelement <8 x double> %1712, i64 2
  %1724 = fptosi double %1723 to i64
  %1725 = getelementptr double, ptr %192, i64 %1724
  %1726 = load double, ptr %1725, align 8, !noalias !141
  %1727 = insertelement <8 x double> %1722, double %1726, i64 2
  %1728 = extractelement <8 x double> %1712, i64 3
  %1729 = fptosi double %1728 to i64
  %1730 = getelementptr double, ptr %192, i64 %1729
  %1731 = load double, ptr %1730, align 8, !noalias !141
  %1732 = insertelement <8 x double> %1727, double %1731, i64 3
  %1733 = extractelement <8 x double> %1712, i64 4
  %1734 = fptosi double %1733 to i64
  %1735 = getelementptr double, ptr %192, i64 %1734
  %1736 = load double, ptr %1735, align 8, !noalias !141
  %1737 = insertelement <8 x double> %1732, double %1736, i64 4
  %1738 = extractelement <8 x double> %1712, i64 5
  %1739 = fptosi double %1738 to i64
  %1740 = getelementptr double, ptr %192, i64 %1739
  %1741 = load double, ptr %1740, align 8, !noalias !141
  %1742 = insertelement <8 x double> %1737, double %1741, i64 5
  %1743 = extractelement <8 x double> %1712, i64 6
  %1744 = fptosi double %1743 to i64
  %1745 = getelementptr double, ptr %192, i64 %1744
  %1746 = load double, ptr %1745, align 8, !noalias !141
  %1747 = insertelement <8 x double> %1742, double %1746, i64 6
  %1748 = extractelement <8 x double> %1712, i64 7
  %1749 = fptosi double %1748 to i64
  %1750 = getelementptr double, ptr %192, i64 %1749
  %1751 = load double, ptr %1750, align 8, !noalias !141
  %1752 = insertelement <8 x double> %1747, double %1751, i64 7
  store <8 x double> %1752, ptr %151, align 8, !noalias !141
  %1753 = fcmp olt <8 x double> %1752, %1122
  %1754 = bitcast <8 x i1> %1753 to i8
  %1755 = zext i8 %1754 to i64
  %1756 = and i64 %1680, %1755
  %1757 = icmp eq i64 %1756, 0
  br i1 %1757, label %1770, label %1679

1758:                                             ; preds = %1700
  %1759 = add nsw i64 %1702, -1
  %1760 = add i64 %1701, 1
  %1761 = shl nsw i64 %1701, 3
  %1762 = add nsw i64 %1761, %1693
  %1763 = icmp slt i64 %1762, 0
  %1764 = select i1 %1763, i64 %94, i64 0
  %1765 = getelementptr double, ptr %95, i64 %1762
  %1766 = getelementptr double, ptr %1765, i64 %1764
  %1767 = load i64, ptr %1766, align 8, !noalias !141
  %1768 = inttoptr i64 %1703 to ptr
  store atomic i64 %1767, ptr %1768 unordered, align 8, !noalias !141
  %1769 = add nsw i64 %1703, %1688
  br label %1700

1770:                                             ; preds = %1707, %1668, %1445
  %1771 = phi i64 [ %1087, %1445 ], [ %1669, %1668 ], [ %1669, %1707 ]
  %1772 = phi i1 [ %1088, %1445 ], [ %1670, %1668 ], [ %1670, %1707 ]
  %1773 = phi <8 x i1> [ %1447, %1445 ], [ %1671, %1668 ], [ %1671, %1707 ]
  %1774 = load <8 x double>, ptr %151, align 8, !noalias !5
  %1775 = fcmp oeq <8 x double> %1774, %1122
  %1776 = and <8 x i1> %1773, %1775
  %1777 = bitcast <8 x i1> %1776 to i8
  %1778 = zext i8 %1777 to i64
  %1779 = icmp eq i8 %1777, 0
  br i1 %1779, label %1866, label %1780

1780:                                             ; preds = %1770, %1803
  %1781 = phi i64 [ %1852, %1803 ], [ %1778, %1770 ]
  %1782 = getelementptr i8, ptr %184, i64 32
  %1783 = load i64, ptr %1782, align 8, !noalias !145
  %1784 = shl nsw i64 %1783, 3
  %1785 = load i64, ptr %226, align 8, !noalias !145
  %1786 = icmp eq i64 %1781, 0
  br i1 %1786, label %1803, label %1787

1787:                                             ; preds = %1780, %1801
  %1788 = phi i64 [ %1791, %1801 ], [ %1781, %1780 ]
  %1789 = call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %1788, i1 true)
  %1790 = add nsw i64 %1788, -1
  %1791 = and i64 %1788, %1790
  %1792 = getelementptr i64, ptr %181, i64 %1789
  %1793 = load i64, ptr %1792, align 8, !noalias !145
  %1794 = add nsw i64 %1793, 8
  store i64 %1794, ptr %1792, align 8, !noalias !145
  %1795 = call i64 @llvm.smax.i64(i64 %1785, i64 0)
  br label %1796

1796:                                             ; preds = %1787, %1854
  %1797 = phi i64 [ 0, %1787 ], [ %1856, %1854 ]
  %1798 = phi i64 [ %1795, %1787 ], [ %1855, %1854 ]
  %1799 = phi i64 [ %1793, %1787 ], [ %1865, %1854 ]
  %1800 = icmp sgt i64 %1798, 0
  br i1 %1800, label %1854, label %1801

1801:                                             ; preds = %1796
  %1802 = icmp eq i64 %1791, 0
  br i1 %1802, label %1803, label %1787

1803:                                             ; preds = %1801, %1780
  %1804 = load <8 x double>, ptr %146, align 8, !noalias !145
  %1805 = trunc i64 %1781 to i8
  %1806 = bitcast i8 %1805 to <8 x i1>
  %1807 = select <8 x i1> %1806, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %1808 = fadd <8 x double> %1804, %1807
  store <8 x double> %1808, ptr %146, align 8, !noalias !145
  %1809 = extractelement <8 x double> %1808, i64 0
  %1810 = fptosi double %1809 to i64
  %1811 = getelementptr double, ptr %192, i64 %1810
  %1812 = load double, ptr %1811, align 8, !noalias !145
  %1813 = insertelement <8 x double> poison, double %1812, i64 0
  %1814 = extractelement <8 x double> %1808, i64 1
  %1815 = fptosi double %1814 to i64
  %1816 = getelementptr double, ptr %192, i64 %1815
  %1817 = load double, ptr %1816, align 8, !noalias !145
  %1818 = insertelement <8 x double> %1813, double %1817, i64 1
  %1819 = extractelement <8 x double> %1808, i64 2
  %1820 = fptosi double %1819 to i64
  %1821 = getelementptr double, ptr %192, i64 %1820
  %1822 = load double, ptr %1821, align 8, !noalias !145
  %1823 = insertelement <8 x double> %1818, double %1822, i64 2
  %1824 = extractelement <8 x double> %1808, i64 3
  %1825 = fptosi double %1824 to i64
  %1826 = getelementptr double, ptr %192, i64 %1825
  %1827 = load double, ptr %1826, align 8, !noalias !145
  %1828 = insertelement <8 x double> %1823, double %1827, i64 3
  %1829 = extractelement <8 x double> %1808, i64 4
  %1830 = fptosi double %1829 to i64
  %1831 = getelementptr double, ptr %192, i64 %1830
  %1832 = load double, ptr %1831, align 8, !noalias !145
  %1833 = insertelement <8 x double> %1828, double %1832, i64 4
  %1834 = extractelement <8 x double> %1808, i64 5
  %1835 = fptosi double %1834 to i64
  %1836 = getelementptr double, ptr %192, i64 %1835
  %1837 = load double, ptr %1836, align 8, !noalias !145
  %1838 = insertelement <8 x double> %1833, double %1837, i64 5
  %1839 = extractelement <8 x double> %1808, i64 6
  %1840 = fptosi double %1839 to i64
  %1841 = getelementptr double, ptr %192, i64 %1840
  %1842 = load double, ptr %1841, align 8, !noalias !145
  %1843 = insertelement <8 x double> %1838, double %1842, i64 6
  %1844 = extractelement <8 x double> %1808, i64 7
  %1845 = fptosi double %1844 to i64
  %1846 = getelementptr double, ptr %192, i64 %1845
  %1847 = load double, ptr %1846, align 8, !noalias !145
  %1848 = insertelement <8 x double> %1843, double %1847, i64 7
  store <8 x double> %1848, ptr %151, align 8, !noalias !145
  %1849 = fcmp oeq <8 x double> %1848, %1122
  %1850 = bitcast <8 x i1> %1849 to i8
  %1851 = zext i8 %1850 to i64
  %1852 = and i64 %1781, %1851
  %1853 = icmp eq i64 %1852, 0
  br i1 %1853, label %1866, label %1780

1854:                                             ; preds = %1796
  %1855 = add nsw i64 %1798, -1
  %1856 = add i64 %1797, 1
  %1857 = shl nsw i64 %1797, 3
  %1858 = add nsw i64 %1857, %1789
  %1859 = icmp slt i64 %1858, 0
  %1860 = select i1 %1859, i64 %89, i64 0
  %1861 = getelementptr double, ptr %90, i64 %1858
  %1862 = getelementptr double, ptr %1861, i64 %1860
  %1863 = load i64, ptr %1862, align 8, !noalias !145
  %1864 = inttoptr i64 %1799 to ptr
  store atomic i64 %1863, ptr %1864 unordered, align 8, !noalias !145
  %1865 = add nsw i64 %1799, %1784
  br label %1796

1866:                                             ; preds = %1803, %1770
  %1867 = xor <8 x i1> %1773, splat (i1 true)
  %1868 = and <8 x i1> %1098, %1867
  %1869 = load <8 x double>, ptr %156, align 8, !noalias !5
  %1870 = select <8 x i1> %1773, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %1871 = fadd <8 x double> %1869, %1870
  store <8 x double> %1871, ptr %156, align 8, !noalias !5
  br i1 %242, label %1872, label %1989

1872:                                             ; preds = %1866
  %1873 = fcmp ogt <8 x double> %1420, splat (double 1.000000e-10)
  %1874 = select <8 x i1> %1873, <8 x double> %1420, <8 x double> splat (double 1.000000e-10)
  %1875 = getelementptr i8, ptr %33, i64 8
  %1876 = load double, ptr %1875, align 8, !noalias !5
  %1877 = fneg double %1876
  %1878 = bitcast <8 x double> %1874 to <8 x i64>
  %1879 = add nsw <8 x i64> %1878, splat (i64 -4604544271217802189)
  %1880 = ashr <8 x i64> %1879, splat (i64 52)
  %1881 = and <8 x i64> %1879, splat (i64 -4503599627370496)
  %1882 = sub <8 x i64> %1878, %1881
  %1883 = bitcast <8 x i64> %1882 to <8 x double>
  %1884 = fadd <8 x double> %1883, splat (double -1.000000e+00)
  %1885 = fadd <8 x double> %1883, splat (double 1.000000e+00)
  %1886 = fdiv <8 x double> %1884, %1885
  %1887 = fmul <8 x double> %1886, %1886
  %1888 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1887, <8 x double> splat (double 0x3FD484B13D7C02A9), <8 x double> splat (double 0x3FDA61762A7ADED9))
  %1889 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1888, <8 x double> %1887, <8 x double> splat (double 0x3FE2776C50EF9BFE))
  %1890 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1889, <8 x double> %1887, <8 x double> splat (double 0x3FEEC709DC3A03FD))
  %1891 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1890, <8 x double> %1887, <8 x double> splat (double 0x40071547652B82FE))
  %1892 = fmul <8 x double> %1891, %1886
  %1893 = trunc nsw <8 x i64> %1880 to <8 x i32>
  %1894 = sitofp <8 x i32> %1893 to <8 x double>
  %1895 = fadd <8 x double> %1892, %1894
  %1896 = insertelement <8 x double> poison, double %1877, i64 0
  %1897 = shufflevector <8 x double> %1896, <8 x double> poison, <8 x i32> zeroinitializer
  %1898 = fmul <8 x double> %1895, %1897
  %1899 = fcmp ogt <8 x double> %1898, splat (double -1.000000e+03)
  %1900 = select <8 x i1> %1899, <8 x double> %1898, <8 x double> splat (double -1.000000e+03)
  %1901 = fcmp olt <8 x double> %1900, splat (double 1.000000e+03)
  %1902 = select <8 x i1> %1901, <8 x double> %1900, <8 x double> splat (double 1.000000e+03)
  %1903 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1902)
  %1904 = fsub <8 x double> %1902, %1903
  %1905 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1904, <8 x double> splat (double 0x3EEFFCBFC588B0C5), <8 x double> splat (double 0x3F2430912F86C786))
  %1906 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1905, <8 x double> %1904, <8 x double> splat (double 0x3F55D87FE78A6730))
  %1907 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1906, <8 x double> %1904, <8 x double> splat (double 0x3F83B2AB6FBA4E77))
  %1908 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1907, <8 x double> %1904, <8 x double> splat (double 0x3FAC6B08D704A0BF))
  %1909 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1908, <8 x double> %1904, <8 x double> splat (double 0x3FCEBFBDFF82C58E))
  %1910 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1909, <8 x double> %1904, <8 x double> splat (double 0x3FE62E42FEFA39EF))
  %1911 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1910, <8 x double> %1904, <8 x double> splat (double 1.000000e+00))
  %1912 = fptosi <8 x double> %1903 to <8 x i32>
  %1913 = zext <8 x i32> %1912 to <8 x i64>
  %1914 = shl <8 x i64> %1913, splat (i64 52)
  %1915 = bitcast <8 x double> %1911 to <8 x i64>
  %1916 = add <8 x i64> %1914, %1915
  %1917 = bitcast <8 x i64> %1916 to <8 x double>
  %1918 = getelementptr i8, ptr %33, i64 16
  %1919 = load double, ptr %1918, align 8, !noalias !5
  %1920 = fcmp une double %1919, 0.000000e+00
  br i1 %1920, label %1921, label %1963

1921:                                             ; preds = %1872
  %1922 = load <8 x i64>, ptr %138, align 8, !noalias !5
  %1923 = add <8 x i64> %1922, splat (i64 -4604544271217802189)
  %1924 = ashr <8 x i64> %1923, splat (i64 52)
  %1925 = and <8 x i64> %1923, splat (i64 -4503599627370496)
  %1926 = sub <8 x i64> %1922, %1925
  %1927 = bitcast <8 x i64> %1926 to <8 x double>
  %1928 = fadd <8 x double> %1927, splat (double -1.000000e+00)
  %1929 = fadd <8 x double> %1927, splat (double 1.000000e+00)
  %1930 = fdiv <8 x double> %1928, %1929
  %1931 = fmul <8 x double> %1930, %1930
  %1932 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1931, <8 x double> splat (double 0x3FD484B13D7C02A9), <8 x double> splat (double 0x3FDA61762A7ADED9))
  %1933 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1932, <8 x double> %1931, <8 x double> splat (double 0x3FE2776C50EF9BFE))
  %1934 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1933, <8 x double> %1931, <8 x double> splat (double 0x3FEEC709DC3A03FD))
  %1935 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1934, <8 x double> %1931, <8 x double> splat (double 0x40071547652B82FE))
  %1936 = fmul <8 x double> %1935, %1930
  %1937 = trunc nsw <8 x i64> %1924 to <8 x i32>
  %1938 = sitofp <8 x i32> %1937 to <8 x double>
  %1939 = fadd <8 x double> %1936, %1938
  %1940 = insertelement <8 x double> poison, double %1919, i64 0
  %1941 = shufflevector <8 x double> %1940, <8 x double> poison, <8 x i32> zeroinitializer
  %1942 = fmul <8 x double> %1939, %1941
  %1943 = fcmp ogt <8 x double> %1942, splat (double -1.000000e+03)
  %1944 = select <8 x i1> %1943, <8 x double> %1942, <8 x double> splat (double -1.000000e+03)
  %1945 = fcmp olt <8 x double> %1944, splat (double 1.000000e+03)
  %1946 = select <8 x i1> %1945, <8 x double> %1944, <8 x double> splat (double 1.000000e+03)
  %1947 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1946)
  %1948 = fsub <8 x double> %1946, %1947
  %1949 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1948, <8 x double> splat (double 0x3EEFFCBFC588B0C5), <8 x double> splat (double 0x3F2430912F86C786))
  %1950 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1949, <8 x double> %1948, <8 x double> splat (double 0x3F55D87FE78A6730))
  %1951 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1950, <8 x double> %1948, <8 x double> splat (double 0x3F83B2AB6FBA4E77))
  %1952 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1951, <8 x double> %1948, <8 x double> splat (double 0x3FAC6B08D704A0BF))
  %1953 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1952, <8 x double> %1948, <8 x double> splat (double 0x3FCEBFBDFF82C58E))
  %1954 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1953, <8 x double> %1948, <8 x double> splat (double 0x3FE62E42FEFA39EF))
  %1955 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1954, <8 x double> %1948, <8 x double> splat (double 1.000000e+00))
  %1956 = fptosi <8 x double> %1947 to <8 x i32>
  %1957 = zext <8 x i32> %1956 to <8 x i64>
  %1958 = shl <8 x i64> %1957, splat (i64 52)
  %1959 = bitcast <8 x double> %1955 to <8 x i64>
  %1960 = add <8 x i64> %1958, %1959
  %1961 = bitcast <8 x i64> %1960 to <8 x double>
  %1962 = fmul <8 x double> %1917, %1961
  br label %1963

1963:                                             ; preds = %1921, %1872
  %1964 = phi <8 x double> [ %1962, %1921 ], [ %1917, %1872 ]
  %1965 = load <8 x double>, ptr %141, align 8, !noalias !5
  %1966 = getelementptr i8, ptr %33, i64 24
  %1967 = load double, ptr %1966, align 8, !noalias !5
  %1968 = insertelement <8 x double> poison, double %1967, i64 0
  %1969 = shufflevector <8 x double> %1968, <8 x double> poison, <8 x i32> zeroinitializer
  %1970 = fmul <8 x double> %1969, %1964
  %1971 = getelementptr i8, ptr %33, i64 32
  %1972 = load double, ptr %1971, align 8, !noalias !5
  %1973 = insertelement <8 x double> poison, double %1972, i64 0
  %1974 = shufflevector <8 x double> %1973, <8 x double> poison, <8 x i32> zeroinitializer
  %1975 = fcmp ogt <8 x double> %1970, %1974
  %1976 = select <8 x i1> %1975, <8 x double> %1970, <8 x double> %1974
  %1977 = fcmp olt <8 x double> %1965, %1976
  %1978 = select <8 x i1> %1977, <8 x double> %1965, <8 x double> %1976
  %1979 = fmul <8 x double> %1123, %1978
  %1980 = fcmp ogt <8 x double> %1420, splat (double 1.000000e-04)
  %1981 = select <8 x i1> %1980, <8 x double> %1420, <8 x double> splat (double 1.000000e-04)
  %1982 = load <8 x double>, ptr %138, align 8, !noalias !5
  %1983 = select <8 x i1> %1773, <8 x double> %1981, <8 x double> %1982
  store <8 x double> %1983, ptr %138, align 8, !noalias !5
  %1984 = getelementptr i8, ptr %33, i64 40
  %1985 = load double, ptr %1984, align 8, !noalias !5
  %1986 = insertelement <8 x double> poison, double %1985, i64 0
  %1987 = shufflevector <8 x double> %1986, <8 x double> poison, <8 x i32> zeroinitializer
  %1988 = select <8 x i1> %1868, <8 x double> splat (double 1.000000e+00), <8 x double> %1987
  store <8 x double> %1988, ptr %141, align 8, !noalias !5
  br label %1989

1989:                                             ; preds = %1963, %1866
  %1990 = phi <8 x double> [ %1979, %1963 ], [ %1096, %1866 ]
  %1991 = bitcast <8 x i1> %1868 to i8
  %1992 = icmp eq i8 %1991, 0
  br i1 %1992, label %2065, label %1993

1993:                                             ; preds = %1989
  %1994 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %1420)
  %1995 = fcmp ueq <8 x double> %1994, splat (double 0x7FF0000000000000)
  %1996 = trunc i64 %1446 to i8
  %1997 = bitcast i8 %1996 to <8 x i1>
  %1998 = getelementptr i8, ptr %33, i64 24
  %1999 = load double, ptr %1998, align 8, !noalias !5
  %2000 = fcmp ogt <8 x double> %1420, splat (double 1.000000e-10)
  %2001 = select <8 x i1> %2000, <8 x double> %1420, <8 x double> splat (double 1.000000e-10)
  %2002 = load double, ptr %33, align 8, !noalias !5
  %2003 = fneg double %2002
  %2004 = bitcast <8 x double> %2001 to <8 x i64>
  %2005 = add nsw <8 x i64> %2004, splat (i64 -4604544271217802189)
  %2006 = ashr <8 x i64> %2005, splat (i64 52)
  %2007 = and <8 x i64> %2005, splat (i64 -4503599627370496)
  %2008 = sub <8 x i64> %2004, %2007
  %2009 = bitcast <8 x i64> %2008 to <8 x double>
  %2010 = fadd <8 x double> %2009, splat (double -1.000000e+00)
  %2011 = fadd <8 x double> %2009, splat (double 1.000000e+00)
  %2012 = fdiv <8 x double> %2010, %2011
  %2013 = fmul <8 x double> %2012, %2012
  %2014 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2013, <8 x double> splat (double 0x3FD484B13D7C02A9), <8 x double> splat (double 0x3FDA61762A7ADED9))
  %2015 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2014, <8 x double> %2013, <8 x double> splat (double 0x3FE2776C50EF9BFE))
  %2016 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2015, <8 x double> %2013, <8 x double> splat (double 0x3FEEC709DC3A03FD))
  %2017 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2016, <8 x double> %2013, <8 x double> splat (double 0x40071547652B82FE))
  %2018 = fmul <8 x double> %2017, %2012
  %2019 = trunc nsw <8 x i64> %2006 to <8 x i32>
  %2020 = sitofp <8 x i32> %2019 to <8 x double>
  %2021 = fadd <8 x double> %2018, %2020
  %2022 = insertelement <8 x double> poison, double %2003, i64 0
  %2023 = shufflevector <8 x double> %2022, <8 x double> poison, <8 x i32> zeroinitializer
  %2024 = fmul <8 x double> %2021, %2023
  %2025 = fcmp ogt <8 x double> %2024, splat (double -1.000000e+03)
  %2026 = select <8 x i1> %2025, <8 x double> %2024, <8 x double> splat (double -1.000000e+03)
  %2027 = fcmp olt <8 x double> %2026, splat (double 1.000000e+03)
  %2028 = select <8 x i1> %2027, <8 x double> %2026, <8 x double> splat (double 1.000000e+03)
  %2029 = call <8 x double> @llvm.rint.v8f64(<8 x double> %2028)
  %2030 = fsub <8 x double> %2028, %2029
  %2031 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2030, <8 x double> splat (double 0x3EEFFCBFC588B0C5), <8 x double> splat (double 0x3F2430912F86C786))
  %2032 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2031, <8 x double> %2030, <8 x double> splat (double 0x3F55D87FE78A6730))
  %2033 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2032, <8 x double> %2030, <8 x double> splat (double 0x3F83B2AB6FBA4E77))
  %2034 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2033, <8 x double> %2030, <8 x double> splat (double 0x3FAC6B08D704A0BF))
  %2035 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2034, <8 x double> %2030, <8 x double> splat (double 0x3FCEBFBDFF82C58E))
  %2036 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2035, <8 x double> %2030, <8 x double> splat (double 0x3FE62E42FEFA39EF))
  %2037 = call <8 x double> @llvm.fma.v8f64(<8 x double> %2036, <8 x double> %2030, <8 x double> splat (double 1.000000e+00))
  %2038 = fptosi <8 x double> %2029 to <8 x i32>
  %2039 = zext <8 x i32> %2038 to <8 x i64>
  %2040 = shl <8 x i64> %2039, splat (i64 52)
  %2041 = bitcast <8 x double> %2037 to <8 x i64>
  %2042 = add <8 x i64> %2040, %2041
  %2043 = bitcast <8 x i64> %2042 to <8 x double>
  %2044 = insertelement <8 x double> poison, double %1999, i64 0
  %2045 = shufflevector <8 x double> %2044, <8 x double> poison, <8 x i32> zeroinitializer
  %2046 = fmul <8 x double> %2045, %2043
  %2047 = or <8 x i1> %1995, %1997
  %2048 = getelementptr i8, ptr %33, i64 32
  %2049 = load double, ptr %2048, align 8, !noalias !5
  %2050 = insertelement <8 x double> poison, double %2049, i64 0
  %2051 = shufflevector <8 x double> %2050, <8 x double> poison, <8 x i32> zeroinitializer
  %2052 = fcmp ogt <8 x double> %2046, %2051
  %2053 = select <8 x i1> %2052, <8 x double> %2046, <8 x double> %2051
  %2054 = select <8 x i1> %2047, <8 x double> splat (double 2.500000e-01), <8 x double> %2053
  %2055 = fmul <8 x double> %1123, %2054
  %2056 = select i1 %242, <8 x double> %2055, <8 x double> zeroinitializer
  %2057 = select <8 x i1> %1868, <8 x double> %2056, <8 x double> %1990
  %2058 = select <8 x i1> %1995, <8 x double> splat (double 4.000000e+00), <8 x double> splat (double 2.000000e+00)
  %2059 = select <8 x i1> %1997, <8 x double> splat (double 3.000000e+00), <8 x double> %2058
  %2060 = load <8 x double>, ptr %171, align 8, !noalias !5
  %2061 = select <8 x i1> %1868, <8 x double> %2059, <8 x double> %2060
  store <8 x double> %2061, ptr %171, align 8, !noalias !5
  %2062 = load <8 x double>, ptr %161, align 8, !noalias !5
  %2063 = select <8 x i1> %1868, <8 x double> splat (double 1.000000e+00), <8 x double> zeroinitializer
  %2064 = fadd <8 x double> %2062, %2063
  store <8 x double> %2064, ptr %161, align 8, !noalias !5
  br label %2065

2065:                                             ; preds = %1993, %1989
  %2066 = phi <8 x double> [ %2057, %1993 ], [ %1990, %1989 ]
  store <8 x double> %2066, ptr %135, align 8, !noalias !5
  %2067 = select <8 x i1> %1773, <8 x double> %1122, <8 x double> %1095
  store <8 x double> %2067, ptr %130, align 8, !noalias !5
  %2068 = call i64 @llvm.smax.i64(i64 %227, i64 0)
  br label %2069

2069:                                             ; preds = %2065, %2203
  %2070 = phi i64 [ 0, %2065 ], [ %2205, %2203 ]
  %2071 = phi i64 [ %2068, %2065 ], [ %2204, %2203 ]
  %2072 = icmp sgt i64 %2071, 0
  br i1 %2072, label %2203, label %2073

2073:                                             ; preds = %2069
  %2074 = load <8 x double>, ptr %151, align 8, !noalias !5
  %2075 = fcmp oeq <8 x double> %2074, splat (double 0x7FF0000000000000)
  %2076 = and <8 x i1> %1773, %2075
  %2077 = bitcast <8 x i1> %2076 to i8
  %2078 = zext i8 %2077 to i64
  %2079 = icmp eq i8 %2077, 0
  br i1 %2079, label %2156, label %2080

2080:                                             ; preds = %2073, %2155
  %2081 = phi i64 [ %2221, %2155 ], [ 0, %2073 ]
  %2082 = phi i64 [ %2220, %2155 ], [ 8, %2073 ]
  %2083 = icmp sgt i64 %2082, 0
  br i1 %2083, label %2219, label %2156

2084:                                             ; preds = %2219
  %2085 = icmp slt i64 %2081, 0
  %2086 = select i1 %2085, i64 %175, i64 0
  %2087 = getelementptr i64, ptr %176, i64 %2081
  %2088 = getelementptr i64, ptr %2087, i64 %2086
  %2089 = load i64, ptr %2088, align 8, !noalias !149
  %2090 = getelementptr i8, ptr %184, i64 32
  %2091 = load i64, ptr %2090, align 8, !noalias !149
  %2092 = shl nsw i64 %2091, 3
  %2093 = select i1 %2085, i64 %145, i64 0
  %2094 = getelementptr double, ptr %146, i64 %2081
  %2095 = getelementptr double, ptr %2094, i64 %2093
  %2096 = load double, ptr %2095, align 8, !noalias !149
  %2097 = fptosi double %2096 to i64
  %2098 = xor i64 %2097, -1
  %2099 = add i64 %191, %2098
  %2100 = call i64 @llvm.smax.i64(i64 %2099, i64 0)
  br label %2101

2101:                                             ; preds = %2105, %2084
  %2102 = phi i64 [ 0, %2084 ], [ %2142, %2105 ]
  %2103 = phi i64 [ %2100, %2084 ], [ %2141, %2105 ]
  %2104 = icmp sgt i64 %2103, 0
  br i1 %2104, label %2140, label %2109

2105:                                             ; preds = %2140, %2151
  %2106 = phi i64 [ %2150, %2140 ], [ %2152, %2151 ]
  %2107 = phi i64 [ %2148, %2140 ], [ %2154, %2151 ]
  %2108 = icmp sgt i64 %2106, 0
  br i1 %2108, label %2151, label %2101

2109:                                             ; preds = %2101
  %2110 = icmp slt i64 %2089, 0
  %2111 = select i1 %2110, i64 %217, i64 0
  %2112 = add i64 %2089, %2111
  %2113 = mul i64 %2112, %219
  %2114 = getelementptr i64, ptr %220, i64 %2113
  %2115 = select i1 %2085, i64 %155, i64 0
  %2116 = getelementptr double, ptr %156, i64 %2081
  %2117 = getelementptr double, ptr %2116, i64 %2115
  %2118 = load double, ptr %2117, align 8, !noalias !149
  %2119 = select i1 %2085, i64 %160, i64 0
  %2120 = getelementptr double, ptr %161, i64 %2081
  %2121 = getelementptr double, ptr %2120, i64 %2119
  %2122 = load double, ptr %2121, align 8, !noalias !149
  %2123 = fptosi double %2118 to i64
  store i64 %2123, ptr %2114, align 8, !noalias !149
  %2124 = getelementptr i8, ptr %2114, i64 8
  %2125 = fptosi double %2122 to i64
  store i64 %2125, ptr %2124, align 8, !noalias !149
  %2126 = select i1 %2085, i64 %165, i64 0
  %2127 = getelementptr double, ptr %166, i64 %2081
  %2128 = getelementptr double, ptr %2127, i64 %2126
  %2129 = load double, ptr %2128, align 8, !noalias !149
  %2130 = getelementptr i8, ptr %2114, i64 16
  %2131 = fptosi double %2129 to i64
  store i64 %2131, ptr %2130, align 8, !noalias !149
  %2132 = getelementptr i8, ptr %2114, i64 24
  store i64 0, ptr %2132, align 8, !noalias !149
  %2133 = select i1 %2085, i64 %129, i64 0
  %2134 = getelementptr double, ptr %130, i64 %2081
  %2135 = getelementptr double, ptr %2134, i64 %2133
  %2136 = load double, ptr %2135, align 8, !noalias !149
  %2137 = select i1 %2110, i64 %224, i64 0
  %2138 = getelementptr double, ptr %225, i64 %2089
  %2139 = getelementptr double, ptr %2138, i64 %2137
  store double %2136, ptr %2139, align 8, !noalias !149
  store i64 -1, ptr %2088, align 8, !noalias !149
  br label %2155

2140:                                             ; preds = %2101
  %2141 = add nsw i64 %2103, -1
  %2142 = add i64 %2102, 1
  %2143 = shl nsw i64 %2102, 3
  %2144 = select i1 %2085, i64 %180, i64 0
  %2145 = getelementptr i64, ptr %181, i64 %2081
  %2146 = getelementptr i64, ptr %2145, i64 %2144
  %2147 = load i64, ptr %2146, align 8, !noalias !149
  %2148 = add nsw i64 %2147, %2143
  %2149 = load i64, ptr %226, align 8, !noalias !149
  %2150 = call i64 @llvm.smax.i64(i64 %2149, i64 0)
  br label %2105

2151:                                             ; preds = %2105
  %2152 = add nsw i64 %2106, -1
  %2153 = inttoptr i64 %2107 to ptr
  store atomic i64 9221120237041090560, ptr %2153 unordered, align 8, !noalias !149
  %2154 = add nsw i64 %2107, %2092
  br label %2105

2155:                                             ; preds = %2109, %2219
  br label %2080

2156:                                             ; preds = %2080, %2073
  %2157 = phi i1 [ %1772, %2073 ], [ true, %2080 ]
  br label %261

2158:                                             ; preds = %254
  %2159 = add nsw i64 %256, -1
  %2160 = add i64 %255, 1
  %2161 = icmp slt i64 %255, 0
  %2162 = select i1 %2161, i64 %175, i64 0
  %2163 = getelementptr i64, ptr %176, i64 %255
  %2164 = getelementptr i64, ptr %2163, i64 %2162
  %2165 = load i64, ptr %2164, align 8, !noalias !5
  %2166 = shl nuw i64 1, %255
  %2167 = icmp slt i64 %2165, 0
  %2168 = select i1 %2167, i64 0, i64 %2166
  %2169 = or i64 %257, %2168
  br label %254

2170:                                             ; preds = %337, %308
  %2171 = icmp eq i64 %269, 0
  br i1 %2171, label %489, label %490

2172:                                             ; preds = %746, %506
  br label %2225

2173:                                             ; preds = %1071
  %2174 = add nsw i64 %1073, -1
  %2175 = add i64 %1072, 1
  br i1 %1074, label %1083, label %1076

2176:                                             ; preds = %1302
  br label %2225

2177:                                             ; preds = %1414
  %2178 = add nsw i64 %1416, -1
  %2179 = add i64 %1415, 1
  %2180 = shl i64 %1415, 6
  %2181 = getelementptr i8, ptr %90, i64 %2180
  %2182 = load <8 x double>, ptr %2181, align 8, !noalias !5
  %2183 = fmul <8 x double> %2182, zeroinitializer
  %2184 = fadd <8 x double> %1417, %2183
  br label %1414

2185:                                             ; preds = %1432
  br label %2225

2186:                                             ; preds = %1487
  %2187 = zext i8 %1459 to i64
  %2188 = and i64 %1474, %2187
  %2189 = load i64, ptr %1467, align 8, !noalias !5
  %2190 = sitofp i64 %2189 to double
  %2191 = insertelement <8 x double> poison, double %2190, i64 0
  %2192 = shufflevector <8 x double> %2191, <8 x double> poison, <8 x i32> zeroinitializer
  %2193 = select <8 x i1> %1458, <8 x double> %2192, <8 x double> zeroinitializer
  %2194 = load <8 x double>, ptr %166, align 8, !noalias !5
  %2195 = fadd <8 x double> %2194, %2193
  store <8 x double> %2195, ptr %166, align 8, !noalias !5
  %2196 = icmp eq i64 %2188, 0
  br i1 %2196, label %1668, label %1585

2197:                                             ; preds = %1585
  %2198 = add nsw i64 %1587, -1
  %2199 = add i64 %1586, 1
  %2200 = shl nuw i64 1, %1586
  %2201 = and i64 %2188, %2200
  %2202 = icmp eq i64 %2201, 0
  br i1 %2202, label %1660, label %1589

2203:                                             ; preds = %2069
  %2204 = add nsw i64 %2071, -1
  %2205 = add i64 %2070, 1
  %2206 = shl i64 %2070, 6
  %2207 = getelementptr i8, ptr %90, i64 %2206
  %2208 = load <8 x double>, ptr %2207, align 8, !noalias !5
  %2209 = getelementptr i8, ptr %85, i64 %2206
  %2210 = load <8 x double>, ptr %2209, align 8, !noalias !5
  %2211 = select <8 x i1> %1773, <8 x double> %2208, <8 x double> %2210
  store <8 x double> %2211, ptr %2209, align 8, !noalias !5
  %2212 = add nsw i64 %239, %2070
  %2213 = shl i64 %2212, 6
  %2214 = getelementptr i8, ptr %112, i64 %2213
  %2215 = load <8 x double>, ptr %2214, align 8, !noalias !5
  %2216 = getelementptr i8, ptr %112, i64 %2206
  %2217 = load <8 x double>, ptr %2216, align 8, !noalias !5
  %2218 = select <8 x i1> %1773, <8 x double> %2215, <8 x double> %2217
  store <8 x double> %2218, ptr %2216, align 8, !noalias !5
  br label %2069

2219:                                             ; preds = %2080
  %2220 = add nsw i64 %2082, -1
  %2221 = add i64 %2081, 1
  %2222 = shl nuw i64 1, %2081
  %2223 = and i64 %2222, %2078
  %2224 = icmp eq i64 %2223, 0
  br i1 %2224, label %2155, label %2084

2225:                                             ; preds = %1534, %2185, %2176, %1299, %2172, %1092, %489
  %2226 = phi i64 [ 0, %1534 ], [ 0, %2172 ], [ 1, %489 ], [ 0, %1092 ], [ 0, %2185 ], [ 0, %1299 ], [ 0, %2176 ]
  ret i64 %2226
}



declare i64 @llvm.smax.i64(i64, i64) #0

attributes #0 = { nounwind willreturn memory(none) }
attributes #1 = { noinline }
attributes #2 = { nounwind willreturn memory(none) }
attributes #3 = { nounwind }
attributes #4 = { nounwind willreturn }

!0 = !{!"branch_weights", i32 1, i32 99}
!1 = !{!"branch_weights", i32 99, i32 1}
!2 = !{!3}
!3 = distinct !{!3, !4}
!4 = distinct !{!4}
!5 = !{!6, !8}
!6 = distinct !{!6, !7}
!7 = distinct !{!7}
!8 = distinct !{!8, !7}
!9 = !{!10, !12, !6, !8}
!10 = distinct !{!10, !11}
!11 = distinct !{!11}
!12 = distinct !{!12, !11}
!13 = !{!14, !16, !10, !12, !6, !8}
!14 = distinct !{!14, !15}
!15 = distinct !{!15}
!16 = distinct !{!16, !15}
!17 = !{!18, !20, !10, !12, !6, !8}
!18 = distinct !{!18, !19}
!19 = distinct !{!19}
!20 = distinct !{!20, !19}
!21 = !{!22, !24, !10, !12, !6, !8}
!22 = distinct !{!22, !23}
!23 = distinct !{!23}
!24 = distinct !{!24, !23}
!25 = !{!26, !28, !10, !12, !6, !8}
!26 = distinct !{!26, !27}
!27 = distinct !{!27}
!28 = distinct !{!28, !27}
!29 = !{!30, !32, !10, !12, !6, !8}
!30 = distinct !{!30, !31}
!31 = distinct !{!31}
!32 = distinct !{!32, !31}
!33 = !{!34, !36, !10, !12, !6, !8}
!34 = distinct !{!34, !35}
!35 = distinct !{!35}
!36 = distinct !{!36, !35}
!37 = !{!38, !40, !10, !12, !6, !8}
!38 = distinct !{!38, !39}
!39 = distinct !{!39}
!40 = distinct !{!40, !39}
!41 = !{!42, !44, !6, !8}
!42 = distinct !{!42, !43}
!43 = distinct !{!43}
!44 = distinct !{!44, !43}
!45 = !{!46, !48, !42, !44, !6, !8}
!46 = distinct !{!46, !47}
!47 = distinct !{!47}
!48 = distinct !{!48, !47}
!49 = !{!"branch_weights", i32 1, i32 49, i32 49}
!50 = !{!51, !53, !42, !44, !6, !8}
!51 = distinct !{!51, !52}
!52 = distinct !{!52}
!53 = distinct !{!53, !52}
!54 = !{!55, !57, !51, !53, !42, !44, !6, !8}
!55 = distinct !{!55, !56}
!56 = distinct !{!56}
!57 = distinct !{!57, !56}
!58 = !{!59, !61, !51, !53, !42, !44, !6, !8}
!59 = distinct !{!59, !60}
!60 = distinct !{!60}
!61 = distinct !{!61, !60}
!62 = !{!63, !65, !51, !53, !42, !44, !6, !8}
!63 = distinct !{!63, !64}
!64 = distinct !{!64}
!65 = distinct !{!65, !64}
!66 = !{!67, !69, !51, !53, !42, !44, !6, !8}
!67 = distinct !{!67, !68}
!68 = distinct !{!68}
!69 = distinct !{!69, !68}
!70 = !{!71, !73, !42, !44, !6, !8}
!71 = distinct !{!71, !72}
!72 = distinct !{!72}
!73 = distinct !{!73, !72}
!74 = !{!75, !77, !42, !44, !6, !8}
!75 = distinct !{!75, !76}
!76 = distinct !{!76}
!77 = distinct !{!77, !76}
!78 = !{!79, !81, !42, !44, !6, !8}
!79 = distinct !{!79, !80}
!80 = distinct !{!80}
!81 = distinct !{!81, !80}
!82 = !{!83, !85, !6, !8}
!83 = distinct !{!83, !84}
!84 = distinct !{!84}
!85 = distinct !{!85, !84}
!86 = !{!87, !89, !83, !85, !6, !8}
!87 = distinct !{!87, !88}
!88 = distinct !{!88}
!89 = distinct !{!89, !88}
!90 = !{!91, !93, !6, !8}
!91 = distinct !{!91, !92}
!92 = distinct !{!92}
!93 = distinct !{!93, !92}
!94 = !{!95, !91, !93, !6, !8}
!95 = distinct !{!95, !96}
!96 = distinct !{!96}
!97 = !{!98, !91, !93, !6, !8}
!98 = distinct !{!98, !99}
!99 = distinct !{!99}
!100 = !{!101, !103, !91, !93, !6, !8}
!101 = distinct !{!101, !102}
!102 = distinct !{!102}
!103 = distinct !{!103, !102}
!104 = !{!105, !107, !6, !8}
!105 = distinct !{!105, !106}
!106 = distinct !{!106}
!107 = distinct !{!107, !106}
!108 = !{!109, !111, !6, !8}
!109 = distinct !{!109, !110}
!110 = distinct !{!110}
!111 = distinct !{!111, !110}
!112 = !{!113, !109, !111, !6, !8}
!113 = distinct !{!113, !114}
!114 = distinct !{!114}
!115 = !{!116, !118, !6, !8}
!116 = distinct !{!116, !117}
!117 = distinct !{!117}
!118 = distinct !{!118, !117}
!119 = !{!120, !122, !6, !8}
!120 = distinct !{!120, !121}
!121 = distinct !{!121}
!122 = distinct !{!122, !121}
!123 = !{!124, !120, !122, !6, !8}
!124 = distinct !{!124, !125}
!125 = distinct !{!125}
!126 = !{!127, !129, !120, !122, !6, !8}
!127 = distinct !{!127, !128}
!128 = distinct !{!128}
!129 = distinct !{!129, !128}
!130 = !{!131, !120, !122, !6, !8}
!131 = distinct !{!131, !132}
!132 = distinct !{!132}
!133 = !{!134, !136, !6, !8}
!134 = distinct !{!134, !135}
!135 = distinct !{!135}
!136 = distinct !{!136, !135}
!137 = !{!138, !140, !6, !8}
!138 = distinct !{!138, !139}
!139 = distinct !{!139}
!140 = distinct !{!140, !139}
!141 = !{!142, !144, !138, !140, !6, !8}
!142 = distinct !{!142, !143}
!143 = distinct !{!143}
!144 = distinct !{!144, !143}
!145 = !{!146, !148, !6, !8}
!146 = distinct !{!146, !147}
!147 = distinct !{!147}
!148 = distinct !{!148, !147}
!149 = !{!150, !152, !6, !8}
!150 = distinct !{!150, !151}
!151 = distinct !{!151}
!152 = distinct !{!152, !151}
