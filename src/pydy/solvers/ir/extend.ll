; sources 57b84d8454e6457ee8ac1ef98218056f7a4fdbcb2eb04688b8f763e89bc6992d
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

define internal fastcc i32 @_sample(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, i64 %5, ptr %6, i64 %7, ptr %8, i64 %9, i64 %10, double %11) unnamed_addr #0 {
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

define internal fastcc i32 @_combine_latest(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, ptr %5, i64 %6, ptr %7, ptr %8, ptr %9, ptr %10, i64 %11, i64 %12, i64 %13, double %14) unnamed_addr {
  %16 = getelementptr i8, ptr %7, i64 16
  %17 = load i64, ptr %16, align 8
  %18 = icmp ne i64 %17, 1
  %19 = ptrtoint ptr %8 to i64
  %20 = zext i1 %18 to i64
  %21 = icmp slt i64 %12, 0
  %22 = select i1 %21, i64 %2, i64 0
  %23 = getelementptr i64, ptr %1, i64 %12
  %24 = getelementptr i64, ptr %23, i64 %22
  %25 = load i64, ptr %24, align 8, !noalias !9
  %26 = ptrtoint ptr %9 to i64
  %27 = ptrtoint ptr %10 to i64
  %28 = ptrtoint ptr %3 to i64
  %29 = shl i64 %25, 3
  %30 = add i64 %29, %28
  %31 = ptrtoint ptr %5 to i64
  %32 = add i64 %29, %31
  %33 = icmp slt i64 %12, -1
  %34 = select i1 %33, i64 %2, i64 0
  %35 = getelementptr i8, ptr %23, i64 8
  %36 = getelementptr i64, ptr %35, i64 %34
  %37 = load i64, ptr %36, align 8, !noalias !9
  %38 = xor i64 %25, -1
  %39 = add i64 %37, %38
  call fastcc void @pydy_combine(i64 %13, i64 %19, i64 %26, i64 %27, i64 %30, i64 %32, i64 %39, i64 %20, i64 %17), !noalias !9
  br i1 %18, label %60, label %40

40:                                               ; preds = %15
  %41 = load i64, ptr %36, align 8
  %42 = add nsw i64 %41, -1
  %43 = icmp sgt i64 %41, 0
  %44 = select i1 %43, i64 0, i64 %6
  %45 = getelementptr double, ptr %5, i64 %42
  %46 = getelementptr double, ptr %45, i64 %44
  %47 = load double, ptr %46, align 8
  %48 = fmul double %14, %47
  %49 = select i1 %43, i64 0, i64 %4
  %50 = getelementptr i64, ptr %3, i64 %42
  %51 = getelementptr i64, ptr %50, i64 %49
  %52 = load i64, ptr %51, align 8
  %53 = getelementptr i8, ptr %7, i64 8
  %54 = load i64, ptr %53, align 8
  %55 = call i64 @llvm.smax.i64(i64 %54, i64 0)
  br label %56

56:                                               ; preds = %40, %61
  %57 = phi i64 [ 0, %40 ], [ %63, %61 ]
  %58 = phi i64 [ %55, %40 ], [ %62, %61 ]
  %59 = icmp sgt i64 %58, 0
  br i1 %59, label %61, label %60

60:                                               ; preds = %56, %15
  store ptr null, ptr %0, align 8
  ret i32 0

61:                                               ; preds = %56
  %62 = add nsw i64 %58, -1
  %63 = add i64 %57, 1
  %64 = shl nsw i64 %57, 3
  %65 = add nsw i64 %13, %64
  %66 = add nsw i64 %52, %57
  %67 = icmp slt i64 %66, 0
  %68 = select i1 %67, i64 %11, i64 0
  %69 = getelementptr double, ptr %10, i64 %66
  %70 = getelementptr double, ptr %69, i64 %68
  %71 = load double, ptr %70, align 8
  %72 = inttoptr i64 %65 to ptr
  %73 = load double, ptr %72, align 8
  %74 = call double @llvm.fma.f64(double %48, double %71, double %73)
  store atomic double %74, ptr %72 unordered, align 8
  br label %56
}

define internal fastcc void @pydy_combine(i64 %0, i64 %1, i64 %2, i64 %3, i64 %4, i64 %5, i64 %6, i64 %7, i64 %8) unnamed_addr #0 {
  %10 = inttoptr i64 %2 to ptr
  %11 = load <8 x double>, ptr %10, align 8
  %12 = inttoptr i64 %4 to ptr
  %13 = inttoptr i64 %5 to ptr
  %14 = lshr i64 %8, 2
  %15 = and i64 %8, 2305843009213693948
  %16 = shl i64 %6, 3
  %17 = getelementptr i8, ptr %12, i64 %16
  %18 = getelementptr i8, ptr %13, i64 %16
  br label %19

19:                                               ; preds = %104, %9
  %20 = phi i64 [ 0, %9 ], [ %110, %104 ]
  %21 = icmp samesign ult i64 %20, %14
  br i1 %21, label %22, label %27

22:                                               ; preds = %19
  %23 = shl i64 %20, 5
  %24 = or disjoint i64 %23, 8
  %25 = or disjoint i64 %23, 16
  %26 = or disjoint i64 %23, 24
  br label %29

27:                                               ; preds = %19
  %28 = and i64 %8, 3
  br label %111

29:                                               ; preds = %36, %22
  %30 = phi <8 x double> [ zeroinitializer, %22 ], [ %48, %36 ]
  %31 = phi <8 x double> [ zeroinitializer, %22 ], [ %51, %36 ]
  %32 = phi <8 x double> [ zeroinitializer, %22 ], [ %54, %36 ]
  %33 = phi <8 x double> [ zeroinitializer, %22 ], [ %57, %36 ]
  %34 = phi i64 [ 0, %22 ], [ %58, %36 ]
  %35 = icmp slt i64 %34, %6
  br i1 %35, label %36, label %59

36:                                               ; preds = %29
  %37 = inttoptr i64 %3 to ptr
  %38 = shl i64 %34, 3
  %39 = getelementptr i8, ptr %13, i64 %38
  %40 = load double, ptr %39, align 8
  %41 = insertelement <8 x double> poison, double %40, i64 0
  %42 = shufflevector <8 x double> %41, <8 x double> poison, <8 x i32> zeroinitializer
  %43 = getelementptr i8, ptr %12, i64 %38
  %44 = load i64, ptr %43, align 8
  %45 = getelementptr double, ptr %37, i64 %44
  %46 = getelementptr double, ptr %45, i64 %23
  %47 = load <8 x double>, ptr %46, align 8
  %48 = call <8 x double> @llvm.fma.v8f64(<8 x double> %42, <8 x double> %47, <8 x double> %30)
  %49 = getelementptr i8, ptr %46, i64 64
  %50 = load <8 x double>, ptr %49, align 8
  %51 = call <8 x double> @llvm.fma.v8f64(<8 x double> %42, <8 x double> %50, <8 x double> %31)
  %52 = getelementptr i8, ptr %46, i64 128
  %53 = load <8 x double>, ptr %52, align 8
  %54 = call <8 x double> @llvm.fma.v8f64(<8 x double> %42, <8 x double> %53, <8 x double> %32)
  %55 = getelementptr i8, ptr %46, i64 192
  %56 = load <8 x double>, ptr %55, align 8
  %57 = call <8 x double> @llvm.fma.v8f64(<8 x double> %42, <8 x double> %56, <8 x double> %33)
  %58 = add nuw nsw i64 %34, 1
  br label %29

59:                                               ; preds = %29
  %60 = inttoptr i64 %1 to ptr
  %61 = getelementptr double, ptr %60, i64 %23
  %62 = load <8 x double>, ptr %61, align 8
  %63 = call <8 x double> @llvm.fma.v8f64(<8 x double> %11, <8 x double> %30, <8 x double> %62)
  %64 = getelementptr double, ptr %60, i64 %24
  %65 = load <8 x double>, ptr %64, align 8
  %66 = call <8 x double> @llvm.fma.v8f64(<8 x double> %11, <8 x double> %31, <8 x double> %65)
  %67 = getelementptr double, ptr %60, i64 %25
  %68 = load <8 x double>, ptr %67, align 8
  %69 = call <8 x double> @llvm.fma.v8f64(<8 x double> %11, <8 x double> %32, <8 x double> %68)
  %70 = getelementptr double, ptr %60, i64 %26
  %71 = load <8 x double>, ptr %70, align 8
  %72 = call <8 x double> @llvm.fma.v8f64(<8 x double> %11, <8 x double> %33, <8 x double> %71)
  br label %73

73:                                               ; preds = %80, %59
  %74 = phi <8 x double> [ %63, %59 ], [ %93, %80 ]
  %75 = phi <8 x double> [ %66, %59 ], [ %96, %80 ]
  %76 = phi <8 x double> [ %69, %59 ], [ %99, %80 ]
  %77 = phi <8 x double> [ %72, %59 ], [ %102, %80 ]
  %78 = phi i64 [ 0, %59 ], [ %103, %80 ]
  %79 = icmp slt i64 %78, %7
  br i1 %79, label %80, label %104

80:                                               ; preds = %73
  %81 = inttoptr i64 %3 to ptr
  %82 = shl i64 %78, 3
  %83 = getelementptr i8, ptr %18, i64 %82
  %84 = load double, ptr %83, align 8
  %85 = insertelement <8 x double> poison, double %84, i64 0
  %86 = shufflevector <8 x double> %85, <8 x double> poison, <8 x i32> zeroinitializer
  %87 = fmul <8 x double> %11, %86
  %88 = getelementptr i8, ptr %17, i64 %82
  %89 = load i64, ptr %88, align 8
  %90 = getelementptr double, ptr %81, i64 %89
  %91 = getelementptr double, ptr %90, i64 %23
  %92 = load <8 x double>, ptr %91, align 8
  %93 = call <8 x double> @llvm.fma.v8f64(<8 x double> %87, <8 x double> %92, <8 x double> %74)
  %94 = getelementptr i8, ptr %91, i64 64
  %95 = load <8 x double>, ptr %94, align 8
  %96 = call <8 x double> @llvm.fma.v8f64(<8 x double> %87, <8 x double> %95, <8 x double> %75)
  %97 = getelementptr i8, ptr %91, i64 128
  %98 = load <8 x double>, ptr %97, align 8
  %99 = call <8 x double> @llvm.fma.v8f64(<8 x double> %87, <8 x double> %98, <8 x double> %76)
  %100 = getelementptr i8, ptr %91, i64 192
  %101 = load <8 x double>, ptr %100, align 8
  %102 = call <8 x double> @llvm.fma.v8f64(<8 x double> %87, <8 x double> %101, <8 x double> %77)
  %103 = add nuw nsw i64 %78, 1
  br label %73

104:                                              ; preds = %73
  %105 = inttoptr i64 %0 to ptr
  %106 = getelementptr double, ptr %105, i64 %23
  store <8 x double> %74, ptr %106, align 8
  %107 = getelementptr double, ptr %105, i64 %24
  store <8 x double> %75, ptr %107, align 8
  %108 = getelementptr double, ptr %105, i64 %25
  store <8 x double> %76, ptr %108, align 8
  %109 = getelementptr double, ptr %105, i64 %26
  store <8 x double> %77, ptr %109, align 8
  %110 = add nuw nsw i64 %20, 1
  br label %19

111:                                              ; preds = %160, %27
  %112 = phi i64 [ 0, %27 ], [ %163, %160 ]
  %113 = icmp samesign ult i64 %112, %28
  br i1 %113, label %114, label %117

114:                                              ; preds = %111
  %115 = add nuw i64 %15, %112
  %116 = shl i64 %115, 3
  br label %118

117:                                              ; preds = %111
  ret void

118:                                              ; preds = %122, %114
  %119 = phi <8 x double> [ zeroinitializer, %114 ], [ %134, %122 ]
  %120 = phi i64 [ 0, %114 ], [ %135, %122 ]
  %121 = icmp slt i64 %120, %6
  br i1 %121, label %122, label %136

122:                                              ; preds = %118
  %123 = inttoptr i64 %3 to ptr
  %124 = shl i64 %120, 3
  %125 = getelementptr i8, ptr %13, i64 %124
  %126 = load double, ptr %125, align 8
  %127 = insertelement <8 x double> poison, double %126, i64 0
  %128 = shufflevector <8 x double> %127, <8 x double> poison, <8 x i32> zeroinitializer
  %129 = getelementptr i8, ptr %12, i64 %124
  %130 = load i64, ptr %129, align 8
  %131 = getelementptr double, ptr %123, i64 %130
  %132 = getelementptr double, ptr %131, i64 %116
  %133 = load <8 x double>, ptr %132, align 8
  %134 = call <8 x double> @llvm.fma.v8f64(<8 x double> %128, <8 x double> %133, <8 x double> %119)
  %135 = add nuw nsw i64 %120, 1
  br label %118

136:                                              ; preds = %118
  %137 = inttoptr i64 %1 to ptr
  %138 = getelementptr double, ptr %137, i64 %116
  %139 = load <8 x double>, ptr %138, align 8
  %140 = call <8 x double> @llvm.fma.v8f64(<8 x double> %11, <8 x double> %119, <8 x double> %139)
  br label %141

141:                                              ; preds = %145, %136
  %142 = phi <8 x double> [ %140, %136 ], [ %158, %145 ]
  %143 = phi i64 [ 0, %136 ], [ %159, %145 ]
  %144 = icmp slt i64 %143, %7
  br i1 %144, label %145, label %160

145:                                              ; preds = %141
  %146 = inttoptr i64 %3 to ptr
  %147 = shl i64 %143, 3
  %148 = getelementptr i8, ptr %18, i64 %147
  %149 = load double, ptr %148, align 8
  %150 = insertelement <8 x double> poison, double %149, i64 0
  %151 = shufflevector <8 x double> %150, <8 x double> poison, <8 x i32> zeroinitializer
  %152 = fmul <8 x double> %11, %151
  %153 = getelementptr i8, ptr %17, i64 %147
  %154 = load i64, ptr %153, align 8
  %155 = getelementptr double, ptr %146, i64 %154
  %156 = getelementptr double, ptr %155, i64 %116
  %157 = load <8 x double>, ptr %156, align 8
  %158 = call <8 x double> @llvm.fma.v8f64(<8 x double> %152, <8 x double> %157, <8 x double> %142)
  %159 = add nuw nsw i64 %143, 1
  br label %141

160:                                              ; preds = %141
  %161 = inttoptr i64 %0 to ptr
  %162 = getelementptr double, ptr %161, i64 %116
  store <8 x double> %142, ptr %162, align 8
  %163 = add nuw nsw i64 %112, 1
  br label %111
}

declare double @llvm.fma.f64(double, double, double) #1

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #1

define internal fastcc void @pydy_nested(i64 %0, i64 %1, i64 %2, i64 %3, i64 %4, i64 %5, i64 %6) unnamed_addr #0 {
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

define i64 @extend(i64 %0, i64 %1) local_unnamed_addr #2 {
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
  store ptr null, ptr %11, align 8, !noalias !12
  store ptr null, ptr %12, align 8, !noalias !12
  %13 = inttoptr i64 %0 to ptr
  %14 = load i64, ptr %13, align 8, !noalias !12
  %15 = inttoptr i64 %14 to ptr
  %16 = getelementptr i8, ptr %13, i64 24
  %17 = load i64, ptr %16, align 8, !noalias !12
  %18 = getelementptr i8, ptr %13, i64 32
  %19 = load i64, ptr %18, align 8, !noalias !12
  %20 = inttoptr i64 %17 to ptr
  %21 = getelementptr i8, ptr %13, i64 48
  %22 = load i64, ptr %21, align 8, !noalias !12
  %23 = getelementptr i8, ptr %13, i64 56
  %24 = load i64, ptr %23, align 8, !noalias !12
  %25 = inttoptr i64 %22 to ptr
  %26 = getelementptr i8, ptr %13, i64 72
  %27 = load i64, ptr %26, align 8, !noalias !12
  %28 = getelementptr i8, ptr %13, i64 80
  %29 = load i64, ptr %28, align 8, !noalias !12
  %30 = inttoptr i64 %27 to ptr
  %31 = getelementptr i8, ptr %13, i64 96
  %32 = load i64, ptr %31, align 8, !noalias !12
  %33 = getelementptr i8, ptr %13, i64 104
  %34 = load i64, ptr %33, align 8, !noalias !12
  %35 = inttoptr i64 %32 to ptr
  %36 = getelementptr i8, ptr %13, i64 144
  %37 = load i64, ptr %36, align 8, !noalias !12
  %38 = inttoptr i64 %37 to ptr
  %39 = getelementptr i8, ptr %13, i64 168
  %40 = load i64, ptr %39, align 8, !noalias !12
  %41 = inttoptr i64 %40 to ptr
  %42 = getelementptr i8, ptr %13, i64 192
  %43 = load i64, ptr %42, align 8, !noalias !12
  %44 = getelementptr i8, ptr %13, i64 200
  %45 = load i64, ptr %44, align 8, !noalias !12
  %46 = inttoptr i64 %43 to ptr
  %47 = getelementptr i8, ptr %13, i64 216
  %48 = load i64, ptr %47, align 8, !noalias !12
  %49 = inttoptr i64 %48 to ptr
  %50 = getelementptr i8, ptr %13, i64 240
  %51 = load i64, ptr %50, align 8, !noalias !12
  %52 = getelementptr i8, ptr %13, i64 248
  %53 = load i64, ptr %52, align 8, !noalias !12
  %54 = getelementptr i8, ptr %13, i64 256
  %55 = load i64, ptr %54, align 8, !noalias !12
  %56 = inttoptr i64 %51 to ptr
  %57 = getelementptr i8, ptr %13, i64 264
  %58 = load i64, ptr %57, align 8, !noalias !12
  %59 = getelementptr i8, ptr %13, i64 272
  %60 = load i64, ptr %59, align 8, !noalias !12
  %61 = inttoptr i64 %58 to ptr
  %62 = getelementptr i8, ptr %13, i64 288
  %63 = load i64, ptr %62, align 8, !noalias !12
  %64 = getelementptr i8, ptr %13, i64 296
  %65 = load i64, ptr %64, align 8, !noalias !12
  %66 = getelementptr i8, ptr %13, i64 304
  %67 = load i64, ptr %66, align 8, !noalias !12
  %68 = inttoptr i64 %63 to ptr
  %69 = getelementptr i8, ptr %13, i64 312
  %70 = load i64, ptr %69, align 8, !noalias !12
  %71 = getelementptr i8, ptr %13, i64 320
  %72 = load i64, ptr %71, align 8, !noalias !12
  %73 = inttoptr i64 %70 to ptr
  %74 = getelementptr i8, ptr %13, i64 336
  %75 = load i64, ptr %74, align 8, !noalias !12
  %76 = getelementptr i8, ptr %13, i64 344
  %77 = load i64, ptr %76, align 8, !noalias !12
  %78 = inttoptr i64 %75 to ptr
  %79 = getelementptr i8, ptr %13, i64 360
  %80 = load i64, ptr %79, align 8, !noalias !12
  %81 = getelementptr i8, ptr %13, i64 384
  %82 = load i64, ptr %81, align 8, !noalias !12
  %83 = getelementptr i8, ptr %13, i64 392
  %84 = load i64, ptr %83, align 8, !noalias !12
  %85 = inttoptr i64 %82 to ptr
  %86 = getelementptr i8, ptr %13, i64 408
  %87 = load i64, ptr %86, align 8, !noalias !12
  %88 = getelementptr i8, ptr %13, i64 416
  %89 = load i64, ptr %88, align 8, !noalias !12
  %90 = inttoptr i64 %87 to ptr
  %91 = getelementptr i8, ptr %13, i64 432
  %92 = load i64, ptr %91, align 8, !noalias !12
  %93 = getelementptr i8, ptr %13, i64 480
  %94 = load i64, ptr %93, align 8, !noalias !12
  %95 = getelementptr i8, ptr %13, i64 488
  %96 = load i64, ptr %95, align 8, !noalias !12
  %97 = inttoptr i64 %94 to ptr
  %98 = getelementptr i8, ptr %13, i64 504
  %99 = load i64, ptr %98, align 8, !noalias !12
  %100 = getelementptr i8, ptr %13, i64 512
  %101 = load i64, ptr %100, align 8, !noalias !12
  %102 = inttoptr i64 %99 to ptr
  %103 = getelementptr i8, ptr %13, i64 600
  %104 = load i64, ptr %103, align 8, !noalias !12
  %105 = inttoptr i64 %104 to ptr
  %106 = getelementptr i8, ptr %13, i64 648
  %107 = load i64, ptr %106, align 8, !noalias !12
  %108 = inttoptr i64 %107 to ptr
  %109 = inttoptr i64 %1 to ptr
  %110 = load i64, ptr %109, align 8, !noalias !12
  %111 = getelementptr i8, ptr %109, i64 8
  %112 = load i64, ptr %111, align 8, !noalias !12
  %113 = getelementptr i8, ptr %109, i64 16
  %114 = load i64, ptr %113, align 8, !noalias !12
  %115 = inttoptr i64 %110 to ptr
  %116 = getelementptr i8, ptr %109, i64 24
  %117 = load i64, ptr %116, align 8, !noalias !12
  %118 = getelementptr i8, ptr %109, i64 32
  %119 = load i64, ptr %118, align 8, !noalias !12
  %120 = inttoptr i64 %117 to ptr
  %121 = getelementptr i8, ptr %109, i64 48
  %122 = load i64, ptr %121, align 8, !noalias !12
  %123 = getelementptr i8, ptr %109, i64 56
  %124 = load i64, ptr %123, align 8, !noalias !12
  %125 = inttoptr i64 %122 to ptr
  %126 = getelementptr i8, ptr %109, i64 72
  %127 = load i64, ptr %126, align 8, !noalias !12
  %128 = getelementptr i8, ptr %109, i64 80
  %129 = load i64, ptr %128, align 8, !noalias !12
  %130 = inttoptr i64 %127 to ptr
  %131 = getelementptr i8, ptr %38, i64 8
  %132 = load i64, ptr %131, align 8, !noalias !12
  %133 = call i64 @llvm.smax.i64(i64 %119, i64 0)
  br label %134

134:                                              ; preds = %2, %394
  %135 = phi i64 [ 0, %2 ], [ %140, %394 ]
  %136 = phi i64 [ %133, %2 ], [ %142, %394 ]
  %137 = phi i64 [ -1, %2 ], [ %395, %394 ]
  %138 = icmp sgt i64 %136, 0
  %139 = zext i1 %138 to i64
  %140 = add i64 %135, %139
  %141 = sext i1 %138 to i64
  %142 = add nsw i64 %136, %141
  %143 = select i1 %138, i64 %135, i64 0
  br i1 %138, label %144, label %396

144:                                              ; preds = %134
  %145 = icmp slt i64 %143, 0
  %146 = select i1 %145, i64 %124, i64 0
  %147 = getelementptr i64, ptr %125, i64 %143
  %148 = getelementptr i64, ptr %147, i64 %146
  %149 = load i64, ptr %148, align 8, !noalias !12
  %150 = mul nsw i64 %143, %132
  %151 = shl i64 %150, 3
  %152 = add i64 %127, %151
  %153 = icmp slt i64 %149, 0
  %154 = select i1 %153, i64 %112, i64 0
  %155 = add i64 %149, %154
  %156 = mul i64 %155, %114
  %157 = getelementptr double, ptr %115, i64 %156
  %158 = getelementptr i8, ptr %157, i64 8
  %159 = load double, ptr %158, align 8, !noalias !12
  %160 = fcmp oeq double %159, 0.000000e+00
  br i1 %160, label %161, label %167

161:                                              ; preds = %144
  %162 = call i64 @llvm.smax.i64(i64 %132, i64 0)
  br label %163

163:                                              ; preds = %161, %397
  %164 = phi i64 [ 0, %161 ], [ %399, %397 ]
  %165 = phi i64 [ %162, %161 ], [ %398, %397 ]
  %166 = icmp sgt i64 %165, 0
  br i1 %166, label %397, label %394

167:                                              ; preds = %144
  %168 = icmp eq i64 %149, %137
  br i1 %168, label %377, label %169

169:                                              ; preds = %167
  %170 = load i64, ptr %131, align 8, !noalias !12
  %171 = load i64, ptr %15, align 8, !noalias !12
  %172 = load double, ptr %157, align 8, !noalias !12
  %173 = call i64 @llvm.smax.i64(i64 %170, i64 0)
  br label %174

174:                                              ; preds = %169, %411
  %175 = phi i64 [ 0, %169 ], [ %413, %411 ]
  %176 = phi i64 [ %173, %169 ], [ %412, %411 ]
  %177 = icmp sgt i64 %176, 0
  br i1 %177, label %411, label %178

178:                                              ; preds = %174
  %179 = icmp eq i64 %171, 0
  br i1 %179, label %180, label %192

180:                                              ; preds = %178
  %181 = getelementptr i8, ptr %15, i64 24
  %182 = load i64, ptr %181, align 8, !noalias !12
  %183 = call i64 @llvm.smax.i64(i64 %182, i64 0)
  br label %184

184:                                              ; preds = %188, %180
  %185 = phi i64 [ 0, %180 ], [ %426, %188 ]
  %186 = phi i64 [ %183, %180 ], [ %425, %188 ]
  %187 = icmp sgt i64 %186, 0
  br i1 %187, label %424, label %373

188:                                              ; preds = %424, %427
  %189 = phi i64 [ 0, %424 ], [ %429, %427 ]
  %190 = phi i64 [ %173, %424 ], [ %428, %427 ]
  %191 = icmp sgt i64 %190, 0
  br i1 %191, label %427, label %184

192:                                              ; preds = %178
  store ptr null, ptr %3, align 8, !noalias !16
  store ptr null, ptr %4, align 8, !noalias !16
  store double %172, ptr %41, align 8, !noalias !16
  %193 = icmp sgt i64 %53, 0
  br i1 %193, label %194, label %197

194:                                              ; preds = %192
  store ptr null, ptr %3, align 8, !noalias !16
  %195 = call fastcc i32 @_sample(ptr nonnull %3, ptr %46, i64 %45, ptr %56, i64 %53, i64 %55, ptr %61, i64 %60, ptr %68, i64 %65, i64 %67, double %172) #2
  switch i32 %195, label %196 [
    i32 -2, label %197
    i32 0, label %197
  ], !prof !23

196:                                              ; preds = %194
  br label %197

197:                                              ; preds = %194, %194, %192, %196
  %198 = phi i32 [ %195, %196 ], [ 0, %192 ], [ 0, %194 ], [ 0, %194 ]
  switch i32 %198, label %203 [
    i32 -2, label %199
    i32 0, label %199
  ], !prof !23

199:                                              ; preds = %197, %197
  %200 = load i64, ptr %38, align 8, !noalias !24
  %201 = inttoptr i64 %200 to ptr
  %202 = call i32 %201(ptr nonnull %41, ptr %73, ptr %46, ptr %49, ptr %97) #2, !noalias !24
  br label %203

203:                                              ; preds = %197, %199
  %204 = phi i32 [ %202, %199 ], [ 0, %197 ]
  %205 = phi i32 [ 0, %199 ], [ %198, %197 ]
  switch i32 %205, label %447 [
    i32 -2, label %444
    i32 0, label %444
  ], !prof !23

206:                                              ; preds = %444
  %207 = call i64 @llvm.smax.i64(i64 %84, i64 0)
  br label %208

208:                                              ; preds = %206, %448
  %209 = phi i64 [ 0, %206 ], [ %450, %448 ]
  %210 = phi i64 [ %207, %206 ], [ %449, %448 ]
  %211 = icmp sgt i64 %210, 0
  br i1 %211, label %448, label %212

212:                                              ; preds = %208
  %213 = load i64, ptr %15, align 8, !noalias !12
  %214 = add i64 %213, -1
  %215 = call i64 @llvm.smax.i64(i64 %214, i64 0)
  br label %216

216:                                              ; preds = %488, %212
  %217 = phi i64 [ 1, %212 ], [ %457, %488 ]
  %218 = phi i64 [ %215, %212 ], [ %456, %488 ]
  %219 = icmp sgt i64 %218, 0
  br i1 %219, label %455, label %222

220:                                              ; preds = %488
  %221 = sext i32 %485 to i64
  br label %224

222:                                              ; preds = %216
  store ptr null, ptr %12, align 8, !noalias !12
  %223 = call fastcc i32 @_combine_latest(ptr nonnull %12, ptr %20, i64 %19, ptr %25, i64 %24, ptr %30, i64 %29, ptr %38, ptr %73, ptr %85, ptr %97, i64 %96, i64 %213, i64 %75, double %159) #2
  switch i32 %223, label %491 [
    i32 -2, label %224
    i32 0, label %224
  ], !prof !23

224:                                              ; preds = %222, %222, %220, %444
  %225 = phi i64 [ %445, %444 ], [ %221, %220 ], [ 0, %222 ], [ 0, %222 ]
  %226 = icmp eq i64 %225, 0
  br i1 %226, label %227, label %373

227:                                              ; preds = %224, %492
  %228 = phi i64 [ %494, %492 ], [ 0, %224 ]
  %229 = phi i64 [ %493, %492 ], [ %173, %224 ]
  %230 = icmp sgt i64 %229, 0
  br i1 %230, label %492, label %231

231:                                              ; preds = %227
  %232 = mul nsw i64 %171, %72
  %233 = shl i64 %232, 3
  %234 = add i64 %94, %233
  %235 = add nsw i64 %149, 1
  %236 = icmp slt i64 %149, -1
  %237 = select i1 %236, i64 %112, i64 0
  %238 = add i64 %235, %237
  %239 = mul i64 %238, %114
  %240 = getelementptr double, ptr %115, i64 %239
  %241 = load double, ptr %240, align 8, !noalias !12
  store ptr null, ptr %5, align 8, !noalias !25
  store ptr null, ptr %6, align 8, !noalias !25
  store double %241, ptr %41, align 8, !noalias !25
  br i1 %193, label %242, label %245

242:                                              ; preds = %231
  store ptr null, ptr %5, align 8, !noalias !25
  %243 = call fastcc i32 @_sample(ptr nonnull %5, ptr %46, i64 %45, ptr %56, i64 %53, i64 %55, ptr %61, i64 %60, ptr %68, i64 %65, i64 %67, double %241) #2
  switch i32 %243, label %244 [
    i32 -2, label %245
    i32 0, label %245
  ], !prof !23

244:                                              ; preds = %242
  br label %245

245:                                              ; preds = %242, %242, %231, %244
  %246 = phi i32 [ %243, %244 ], [ 0, %231 ], [ 0, %242 ], [ 0, %242 ]
  switch i32 %246, label %252 [
    i32 -2, label %247
    i32 0, label %247
  ], !prof !23

247:                                              ; preds = %245, %245
  %248 = load i64, ptr %38, align 8, !noalias !32
  %249 = inttoptr i64 %248 to ptr
  %250 = inttoptr i64 %234 to ptr
  %251 = call i32 %249(ptr nonnull %41, ptr %78, ptr %46, ptr %49, ptr %250) #2, !noalias !32
  br label %252

252:                                              ; preds = %245, %247
  %253 = phi i32 [ %251, %247 ], [ 0, %245 ]
  %254 = phi i32 [ 0, %247 ], [ %246, %245 ]
  switch i32 %254, label %513 [
    i32 -2, label %511
    i32 0, label %511
  ], !prof !23

255:                                              ; preds = %511
  %256 = sext i32 %253 to i64
  br label %373

257:                                              ; preds = %511
  %258 = load i64, ptr %15, align 8, !noalias !12
  %259 = getelementptr i8, ptr %15, i64 16
  %260 = load i64, ptr %259, align 8, !noalias !12
  %261 = call i64 @llvm.smax.i64(i64 %260, i64 0)
  br label %262

262:                                              ; preds = %562, %257
  %263 = phi i64 [ %258, %257 ], [ %265, %562 ]
  %264 = phi i64 [ %261, %257 ], [ %563, %562 ]
  %265 = add i64 %263, 1
  %266 = icmp sgt i64 %264, 0
  br i1 %266, label %514, label %269

267:                                              ; preds = %562
  %268 = sext i32 %560 to i64
  br label %373

269:                                              ; preds = %262
  %270 = load i64, ptr %131, align 8, !noalias !33
  %271 = load i64, ptr %15, align 8, !noalias !33
  %272 = mul nsw i64 %271, %72
  %273 = icmp slt i64 %272, 0
  %274 = select i1 %273, i64 %96, i64 0
  %275 = add i64 %272, %274
  %276 = icmp slt i64 %275, 0
  br i1 %276, label %296, label %297, !prof !4

277:                                              ; preds = %324, %328
  %278 = phi i64 [ 0, %324 ], [ %330, %328 ]
  %279 = phi i64 [ %327, %324 ], [ %329, %328 ]
  %280 = icmp sgt i64 %279, 0
  br i1 %280, label %328, label %281

281:                                              ; preds = %277
  %282 = add nsw i64 %271, 1
  %283 = getelementptr i8, ptr %15, i64 8
  %284 = load i64, ptr %283, align 8, !noalias !33
  %285 = add nsw i64 %282, %284
  %286 = load i64, ptr %259, align 8, !noalias !33
  %287 = add nsw i64 %285, %286
  %288 = getelementptr i8, ptr %15, i64 24
  %289 = load i64, ptr %288, align 8, !noalias !33
  %290 = add i64 %289, -3
  %291 = call i64 @llvm.smax.i64(i64 %290, i64 0)
  br label %292

292:                                              ; preds = %281, %348
  %293 = phi i64 [ 3, %281 ], [ %350, %348 ]
  %294 = phi i64 [ %291, %281 ], [ %349, %348 ]
  %295 = icmp sgt i64 %294, 0
  br i1 %295, label %348, label %373

296:                                              ; preds = %269
  br label %297

297:                                              ; preds = %296, %269
  %298 = phi i64 [ 0, %296 ], [ %275, %269 ]
  %299 = icmp slt i64 %275, %96
  br i1 %299, label %301, label %300, !prof !8

300:                                              ; preds = %297
  br label %301

301:                                              ; preds = %300, %297
  %302 = phi i64 [ %96, %300 ], [ %298, %297 ]
  %303 = getelementptr double, ptr %97, i64 %302
  %304 = icmp slt i64 %72, 0
  %305 = select i1 %304, i64 %101, i64 0
  %306 = add i64 %72, %305
  %307 = icmp slt i64 %306, 0
  br i1 %307, label %308, label %309, !prof !4

308:                                              ; preds = %301
  br label %309

309:                                              ; preds = %308, %301
  %310 = phi i64 [ 0, %308 ], [ %306, %301 ]
  %311 = icmp slt i64 %306, %101
  br i1 %311, label %313, label %312, !prof !8

312:                                              ; preds = %309
  br label %313

313:                                              ; preds = %312, %309
  %314 = phi i64 [ %101, %312 ], [ %310, %309 ]
  %315 = getelementptr double, ptr %102, i64 %314
  %316 = shl nsw i64 %72, 1
  %317 = add i64 %316, %305
  %318 = icmp slt i64 %317, 0
  br i1 %318, label %319, label %320, !prof !4

319:                                              ; preds = %313
  br label %320

320:                                              ; preds = %319, %313
  %321 = phi i64 [ 0, %319 ], [ %317, %313 ]
  %322 = icmp slt i64 %317, %101
  br i1 %322, label %324, label %323, !prof !8

323:                                              ; preds = %320
  br label %324

324:                                              ; preds = %323, %320
  %325 = phi i64 [ %101, %323 ], [ %321, %320 ]
  %326 = getelementptr double, ptr %102, i64 %325
  %327 = call i64 @llvm.smax.i64(i64 %270, i64 0)
  br label %277

328:                                              ; preds = %277
  %329 = add nsw i64 %279, -1
  %330 = add i64 %278, 1
  %331 = getelementptr double, ptr %78, i64 %278
  %332 = load double, ptr %331, align 8, !noalias !33
  %333 = getelementptr double, ptr %73, i64 %278
  %334 = load double, ptr %333, align 8, !noalias !33
  %335 = fsub double %332, %334
  %336 = getelementptr double, ptr %97, i64 %278
  %337 = load double, ptr %336, align 8, !noalias !33
  %338 = fmul double %159, %337
  %339 = fsub double %338, %335
  %340 = getelementptr double, ptr %102, i64 %278
  store double %335, ptr %340, align 8, !noalias !33
  %341 = getelementptr double, ptr %315, i64 %278
  store double %339, ptr %341, align 8, !noalias !33
  %342 = fsub double %335, %339
  %343 = getelementptr double, ptr %303, i64 %278
  %344 = load double, ptr %343, align 8, !noalias !33
  %345 = fmul double %159, %344
  %346 = fsub double %342, %345
  %347 = getelementptr double, ptr %326, i64 %278
  store double %346, ptr %347, align 8, !noalias !33
  br label %277

348:                                              ; preds = %292
  %349 = add nsw i64 %294, -1
  %350 = add i64 %293, 1
  %351 = mul nsw i64 %293, %72
  %352 = shl i64 %351, 3
  %353 = add i64 %99, %352
  %354 = add nsw i64 %287, %293
  %355 = getelementptr i8, ptr %38, i64 16
  %356 = load i64, ptr %355, align 8, !noalias !37
  %357 = icmp slt i64 %354, 3
  %358 = select i1 %357, i64 %19, i64 0
  %359 = getelementptr i64, ptr %20, i64 %354
  %360 = getelementptr i8, ptr %359, i64 -24
  %361 = getelementptr i64, ptr %360, i64 %358
  %362 = load i64, ptr %361, align 8, !noalias !41
  %363 = shl i64 %362, 3
  %364 = add i64 %22, %363
  %365 = add i64 %27, %363
  %366 = icmp slt i64 %354, 2
  %367 = select i1 %366, i64 %19, i64 0
  %368 = getelementptr i8, ptr %359, i64 -16
  %369 = getelementptr i64, ptr %368, i64 %367
  %370 = load i64, ptr %369, align 8, !noalias !41
  %371 = xor i64 %362, -1
  %372 = add i64 %370, %371
  call fastcc void @pydy_combine(i64 %353, i64 %92, i64 %82, i64 %94, i64 %364, i64 %365, i64 %372, i64 1, i64 %356) #2, !noalias !41
  br label %292

373:                                              ; preds = %184, %292, %224, %267, %255
  %374 = phi i1 [ true, %184 ], [ false, %255 ], [ true, %292 ], [ false, %267 ], [ false, %224 ]
  %375 = phi i64 [ 0, %184 ], [ %256, %255 ], [ 0, %292 ], [ %268, %267 ], [ %225, %224 ]
  br i1 %374, label %377, label %376

376:                                              ; preds = %373
  br label %586

377:                                              ; preds = %373, %167
  %378 = phi i64 [ %149, %373 ], [ %137, %167 ]
  %379 = select i1 %145, i64 %119, i64 0
  %380 = getelementptr double, ptr %120, i64 %143
  %381 = getelementptr double, ptr %380, i64 %379
  %382 = load double, ptr %381, align 8, !noalias !12
  %383 = load double, ptr %157, align 8, !noalias !12
  %384 = fsub double %382, %383
  %385 = load double, ptr %158, align 8, !noalias !12
  %386 = fdiv double %384, %385
  %387 = call i64 @llvm.smax.i64(i64 %89, i64 0)
  br label %566

388:                                              ; preds = %570
  %389 = getelementptr i8, ptr %108, i64 56
  %390 = load i64, ptr %389, align 8, !noalias !12
  %391 = load double, ptr %381, align 8, !noalias !12
  %392 = inttoptr i64 %390 to ptr
  %393 = call i64 %392(i64 %0, double %391, i64 %152) #2, !noalias !12
  br label %394

394:                                              ; preds = %163, %388, %570
  %395 = phi i64 [ %137, %163 ], [ %378, %570 ], [ %378, %388 ]
  br label %134

396:                                              ; preds = %134
  br label %586

397:                                              ; preds = %163
  %398 = add nsw i64 %165, -1
  %399 = add i64 %164, 1
  %400 = icmp slt i64 %164, -2
  %401 = select i1 %400, i64 %114, i64 0
  %402 = getelementptr double, ptr %157, i64 %164
  %403 = getelementptr i8, ptr %402, i64 16
  %404 = getelementptr double, ptr %403, i64 %401
  %405 = load double, ptr %404, align 8, !noalias !12
  %406 = add nsw i64 %150, %164
  %407 = icmp slt i64 %406, 0
  %408 = select i1 %407, i64 %129, i64 0
  %409 = getelementptr double, ptr %130, i64 %406
  %410 = getelementptr double, ptr %409, i64 %408
  store double %405, ptr %410, align 8, !noalias !12
  br label %163

411:                                              ; preds = %174
  %412 = add nsw i64 %176, -1
  %413 = add i64 %175, 1
  %414 = icmp slt i64 %175, -2
  %415 = select i1 %414, i64 %114, i64 0
  %416 = getelementptr double, ptr %157, i64 %175
  %417 = getelementptr i8, ptr %416, i64 16
  %418 = getelementptr double, ptr %417, i64 %415
  %419 = load double, ptr %418, align 8, !noalias !12
  %420 = icmp slt i64 %175, 0
  %421 = select i1 %420, i64 %72, i64 0
  %422 = getelementptr double, ptr %73, i64 %175
  %423 = getelementptr double, ptr %422, i64 %421
  store double %419, ptr %423, align 8, !noalias !12
  br label %174

424:                                              ; preds = %184
  %425 = add nsw i64 %186, -1
  %426 = add i64 %185, 1
  br label %188

427:                                              ; preds = %188
  %428 = add nsw i64 %190, -1
  %429 = add i64 %189, 1
  %430 = mul nsw i64 %426, %170
  %431 = add nsw i64 %430, 2
  %432 = add nsw i64 %431, %189
  %433 = icmp slt i64 %432, 0
  %434 = select i1 %433, i64 %114, i64 0
  %435 = getelementptr double, ptr %157, i64 %432
  %436 = getelementptr double, ptr %435, i64 %434
  %437 = load double, ptr %436, align 8, !noalias !12
  %438 = mul nsw i64 %185, %72
  %439 = add nsw i64 %438, %189
  %440 = icmp slt i64 %439, 0
  %441 = select i1 %440, i64 %101, i64 0
  %442 = getelementptr double, ptr %102, i64 %439
  %443 = getelementptr double, ptr %442, i64 %441
  store double %437, ptr %443, align 8, !noalias !12
  br label %188

444:                                              ; preds = %203, %203
  %445 = sext i32 %204 to i64
  %446 = icmp eq i32 %204, 0
  br i1 %446, label %206, label %224

447:                                              ; preds = %203
  br label %586

448:                                              ; preds = %208
  %449 = add nsw i64 %210, -1
  %450 = add i64 %209, 1
  %451 = icmp slt i64 %209, 0
  %452 = select i1 %451, i64 %84, i64 0
  %453 = getelementptr double, ptr %85, i64 %209
  %454 = getelementptr double, ptr %453, i64 %452
  store double %159, ptr %454, align 8, !noalias !12
  br label %208

455:                                              ; preds = %216
  %456 = add nsw i64 %218, -1
  %457 = add i64 %217, 1
  store ptr null, ptr %11, align 8, !noalias !12
  %458 = call fastcc i32 @_combine_latest(ptr nonnull %11, ptr %20, i64 %19, ptr %25, i64 %24, ptr %30, i64 %29, ptr %38, ptr %73, ptr %85, ptr %97, i64 %96, i64 %217, i64 %80, double %159) #2
  switch i32 %458, label %487 [
    i32 -2, label %459
    i32 0, label %459
  ], !prof !23

459:                                              ; preds = %455, %455
  %460 = mul nsw i64 %217, %72
  %461 = shl i64 %460, 3
  %462 = add i64 %94, %461
  %463 = getelementptr i8, ptr %105, i64 24
  %464 = load i64, ptr %463, align 8, !noalias !12
  %465 = add nsw i64 %464, 1
  store i64 %465, ptr %463, align 8, !noalias !12
  %466 = icmp slt i64 %217, 0
  %467 = select i1 %466, i64 %34, i64 0
  %468 = getelementptr double, ptr %35, i64 %217
  %469 = getelementptr double, ptr %468, i64 %467
  %470 = load double, ptr %469, align 8, !noalias !12
  %471 = fmul double %470, %159
  %472 = fadd double %172, %471
  store ptr null, ptr %9, align 8, !noalias !44
  store ptr null, ptr %10, align 8, !noalias !44
  store double %472, ptr %41, align 8, !noalias !44
  br i1 %193, label %473, label %476

473:                                              ; preds = %459
  store ptr null, ptr %9, align 8, !noalias !44
  %474 = call fastcc i32 @_sample(ptr nonnull %9, ptr %46, i64 %45, ptr %56, i64 %53, i64 %55, ptr %61, i64 %60, ptr %68, i64 %65, i64 %67, double %472) #2
  switch i32 %474, label %475 [
    i32 -2, label %476
    i32 0, label %476
  ], !prof !23

475:                                              ; preds = %473
  br label %476

476:                                              ; preds = %473, %473, %459, %475
  %477 = phi i32 [ %474, %475 ], [ 0, %459 ], [ 0, %473 ], [ 0, %473 ]
  switch i32 %477, label %484 [
    i32 -2, label %478
    i32 0, label %478
  ], !prof !23

478:                                              ; preds = %476, %476
  %479 = load i64, ptr %38, align 8, !noalias !51
  %480 = inttoptr i64 %479 to ptr
  %481 = inttoptr i64 %80 to ptr
  %482 = inttoptr i64 %462 to ptr
  %483 = call i32 %480(ptr nonnull %41, ptr %481, ptr %46, ptr %49, ptr %482) #2, !noalias !51
  br label %484

484:                                              ; preds = %476, %478
  %485 = phi i32 [ %483, %478 ], [ 0, %476 ]
  %486 = phi i32 [ 0, %478 ], [ %477, %476 ]
  switch i32 %486, label %490 [
    i32 -2, label %488
    i32 0, label %488
  ], !prof !23

487:                                              ; preds = %455
  br label %586

488:                                              ; preds = %484, %484
  %489 = icmp eq i32 %485, 0
  br i1 %489, label %216, label %220

490:                                              ; preds = %484
  br label %586

491:                                              ; preds = %222
  br label %586

492:                                              ; preds = %227
  %493 = add nsw i64 %229, -1
  %494 = add i64 %228, 1
  %495 = add nsw i64 %149, 1
  %496 = icmp slt i64 %149, -1
  %497 = select i1 %496, i64 %112, i64 0
  %498 = add i64 %495, %497
  %499 = icmp slt i64 %228, -2
  %500 = select i1 %499, i64 %114, i64 0
  %501 = mul i64 %498, %114
  %502 = getelementptr double, ptr %115, i64 %501
  %503 = getelementptr double, ptr %502, i64 %228
  %504 = getelementptr i8, ptr %503, i64 16
  %505 = getelementptr double, ptr %504, i64 %500
  %506 = load double, ptr %505, align 8, !noalias !12
  %507 = icmp slt i64 %228, 0
  %508 = select i1 %507, i64 %77, i64 0
  %509 = getelementptr double, ptr %78, i64 %228
  %510 = getelementptr double, ptr %509, i64 %508
  store double %506, ptr %510, align 8, !noalias !12
  br label %227

511:                                              ; preds = %252, %252
  %512 = icmp eq i32 %253, 0
  br i1 %512, label %257, label %255

513:                                              ; preds = %252
  br label %586

514:                                              ; preds = %262
  %515 = getelementptr i8, ptr %15, i64 8
  %516 = load i64, ptr %515, align 8, !noalias !12
  %517 = add nsw i64 %265, %516
  %518 = getelementptr i8, ptr %38, i64 16
  %519 = load i64, ptr %518, align 8, !noalias !52
  %520 = icmp slt i64 %517, 0
  %521 = select i1 %520, i64 %19, i64 0
  %522 = getelementptr i64, ptr %20, i64 %517
  %523 = getelementptr i64, ptr %522, i64 %521
  %524 = load i64, ptr %523, align 8, !noalias !56
  %525 = shl i64 %524, 3
  %526 = add i64 %22, %525
  %527 = add i64 %27, %525
  %528 = icmp slt i64 %517, -1
  %529 = select i1 %528, i64 %19, i64 0
  %530 = getelementptr i8, ptr %522, i64 8
  %531 = getelementptr i64, ptr %530, i64 %529
  %532 = load i64, ptr %531, align 8, !noalias !56
  %533 = xor i64 %524, -1
  %534 = add i64 %532, %533
  call fastcc void @pydy_combine(i64 %80, i64 %70, i64 %82, i64 %94, i64 %526, i64 %527, i64 %534, i64 1, i64 %519) #2, !noalias !56
  %535 = mul nsw i64 %265, %72
  %536 = shl i64 %535, 3
  %537 = add i64 %94, %536
  %538 = getelementptr i8, ptr %105, i64 24
  %539 = load i64, ptr %538, align 8, !noalias !12
  %540 = add nsw i64 %539, 1
  store i64 %540, ptr %538, align 8, !noalias !12
  %541 = icmp slt i64 %265, 0
  %542 = select i1 %541, i64 %34, i64 0
  %543 = getelementptr double, ptr %35, i64 %265
  %544 = getelementptr double, ptr %543, i64 %542
  %545 = load double, ptr %544, align 8, !noalias !12
  %546 = fmul double %545, %159
  %547 = fadd double %172, %546
  store ptr null, ptr %7, align 8, !noalias !59
  store ptr null, ptr %8, align 8, !noalias !59
  store double %547, ptr %41, align 8, !noalias !59
  br i1 %193, label %548, label %551

548:                                              ; preds = %514
  store ptr null, ptr %7, align 8, !noalias !59
  %549 = call fastcc i32 @_sample(ptr nonnull %7, ptr %46, i64 %45, ptr %56, i64 %53, i64 %55, ptr %61, i64 %60, ptr %68, i64 %65, i64 %67, double %547) #2
  switch i32 %549, label %550 [
    i32 -2, label %551
    i32 0, label %551
  ], !prof !23

550:                                              ; preds = %548
  br label %551

551:                                              ; preds = %548, %548, %514, %550
  %552 = phi i32 [ %549, %550 ], [ 0, %514 ], [ 0, %548 ], [ 0, %548 ]
  switch i32 %552, label %559 [
    i32 -2, label %553
    i32 0, label %553
  ], !prof !23

553:                                              ; preds = %551, %551
  %554 = load i64, ptr %38, align 8, !noalias !66
  %555 = inttoptr i64 %554 to ptr
  %556 = inttoptr i64 %80 to ptr
  %557 = inttoptr i64 %537 to ptr
  %558 = call i32 %555(ptr nonnull %41, ptr %556, ptr %46, ptr %49, ptr %557) #2, !noalias !66
  br label %559

559:                                              ; preds = %551, %553
  %560 = phi i32 [ %558, %553 ], [ 0, %551 ]
  %561 = phi i32 [ 0, %553 ], [ %552, %551 ]
  switch i32 %561, label %565 [
    i32 -2, label %562
    i32 0, label %562
  ], !prof !23

562:                                              ; preds = %559, %559
  %563 = add nsw i64 %264, -1
  %564 = icmp eq i32 %560, 0
  br i1 %564, label %262, label %267

565:                                              ; preds = %559
  br label %586

566:                                              ; preds = %377, %579
  %567 = phi i64 [ 0, %377 ], [ %581, %579 ]
  %568 = phi i64 [ %387, %377 ], [ %580, %579 ]
  %569 = icmp sgt i64 %568, 0
  br i1 %569, label %579, label %570

570:                                              ; preds = %566
  %571 = getelementptr i8, ptr %15, i64 24
  %572 = load i64, ptr %571, align 8, !noalias !67
  %573 = getelementptr i8, ptr %38, i64 16
  %574 = load i64, ptr %573, align 8, !noalias !67
  call fastcc void @pydy_nested(i64 %152, i64 %70, i64 %99, i64 %72, i64 %572, i64 %87, i64 %574) #2, !noalias !67
  %575 = load i64, ptr %108, align 8, !noalias !12
  %576 = icmp eq i64 %575, 1
  %577 = fcmp ogt double %386, 0.000000e+00
  %578 = select i1 %576, i1 %577, i1 false
  br i1 %578, label %388, label %394

579:                                              ; preds = %566
  %580 = add nsw i64 %568, -1
  %581 = add i64 %567, 1
  %582 = icmp slt i64 %567, 0
  %583 = select i1 %582, i64 %89, i64 0
  %584 = getelementptr double, ptr %90, i64 %567
  %585 = getelementptr double, ptr %584, i64 %583
  store double %386, ptr %585, align 8, !noalias !67
  br label %566

586:                                              ; preds = %565, %513, %491, %490, %487, %447, %396, %376
  %587 = phi i64 [ 0, %396 ], [ 0, %491 ], [ 0, %490 ], [ 0, %565 ], [ 0, %487 ], [ %375, %376 ], [ 0, %513 ], [ 0, %447 ]
  ret i64 %587
}



declare i64 @llvm.smax.i64(i64, i64) #1

attributes #0 = { noinline }
attributes #1 = { nounwind willreturn memory(none) }
attributes #2 = { nounwind }
attributes #3 = { nounwind willreturn }

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
!16 = !{!17, !19, !20, !22}
!17 = distinct !{!17, !18}
!18 = distinct !{!18}
!19 = distinct !{!19, !18}
!20 = distinct !{!20, !21}
!21 = distinct !{!21}
!22 = distinct !{!22, !21}
!23 = !{!"branch_weights", i32 1, i32 49, i32 49}
!24 = !{!20, !22}
!25 = !{!26, !28, !29, !31}
!26 = distinct !{!26, !27}
!27 = distinct !{!27}
!28 = distinct !{!28, !27}
!29 = distinct !{!29, !30}
!30 = distinct !{!30}
!31 = distinct !{!31, !30}
!32 = !{!29, !31}
!33 = !{!34, !36, !13, !15}
!34 = distinct !{!34, !35}
!35 = distinct !{!35}
!36 = distinct !{!36, !35}
!37 = !{!38, !40, !34, !36, !13, !15}
!38 = distinct !{!38, !39}
!39 = distinct !{!39}
!40 = distinct !{!40, !39}
!41 = !{!42, !38, !40, !34, !36, !13, !15}
!42 = distinct !{!42, !43}
!43 = distinct !{!43}
!44 = !{!45, !47, !48, !50}
!45 = distinct !{!45, !46}
!46 = distinct !{!46}
!47 = distinct !{!47, !46}
!48 = distinct !{!48, !49}
!49 = distinct !{!49}
!50 = distinct !{!50, !49}
!51 = !{!48, !50}
!52 = !{!53, !55, !13, !15}
!53 = distinct !{!53, !54}
!54 = distinct !{!54}
!55 = distinct !{!55, !54}
!56 = !{!57, !53, !55, !13, !15}
!57 = distinct !{!57, !58}
!58 = distinct !{!58}
!59 = !{!60, !62, !63, !65}
!60 = distinct !{!60, !61}
!61 = distinct !{!61}
!62 = distinct !{!62, !61}
!63 = distinct !{!63, !64}
!64 = distinct !{!64}
!65 = distinct !{!65, !64}
!66 = !{!63, !65}
!67 = !{!68, !70, !13, !15}
!68 = distinct !{!68, !69}
!69 = distinct !{!69}
!70 = distinct !{!70, !69}
