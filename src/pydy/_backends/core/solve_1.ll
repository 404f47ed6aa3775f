; sources 19e079ce2b38e9ab4bedee3a1bf6b1ec7c1bc10c6f40164e9aea0b240c1d5f1c
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define range(i32 0, 2) i32 @pydy_lu_1(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, i64 noundef %4, i32 noundef %5) #0 {
  %7 = getelementptr i8, ptr %0, i64 -8
  %8 = and i32 %5, 1
  %9 = icmp eq i32 %8, 0
  %10 = icmp sgt i64 %4, 0
  %11 = add nuw i64 %4, 1
  %12 = sitofp i64 %4 to double
  %13 = fmul double %12, 0x3CB0000000000000
  %14 = icmp sgt i64 %4, 0
  %15 = getelementptr double, ptr %2, i64 %4
  %16 = mul nsw i64 %4, %4
  %17 = getelementptr double, ptr %7, i64 %16
  br i1 %9, label %215, label %18

18:                                               ; preds = %6
  %19 = icmp eq ptr %3, null
  br i1 %19, label %83, label %20

20:                                               ; preds = %18
  br i1 %10, label %22, label %215

21:                                               ; preds = %22
  br i1 %10, label %32, label %215

22:                                               ; preds = %20, %22
  %23 = phi i64 [ %30, %22 ], [ 0, %20 ]
  %24 = getelementptr inbounds i64, ptr %1, i64 %23
  %25 = load i64, ptr %24, align 8
  %26 = getelementptr inbounds double, ptr %3, i64 %23
  %27 = load double, ptr %26, align 8
  %28 = getelementptr inbounds double, ptr %3, i64 %25
  %29 = load double, ptr %28, align 8
  store double %29, ptr %26, align 8
  store double %27, ptr %28, align 8
  %30 = add nuw nsw i64 %23, 1
  %31 = icmp eq i64 %30, %4
  br i1 %31, label %21, label %22, !llvm.loop !3

32:                                               ; preds = %21, %41
  %33 = phi i64 [ %42, %41 ], [ 0, %21 ]
  %34 = icmp eq i64 %33, 0
  br i1 %34, label %41, label %35

35:                                               ; preds = %32
  %36 = mul nuw nsw i64 %33, %4
  %37 = getelementptr double, ptr %0, i64 %36
  %38 = getelementptr inbounds double, ptr %3, i64 %33
  %39 = load double, ptr %38, align 8
  br label %44

40:                                               ; preds = %41
  br i1 %10, label %55, label %215

41:                                               ; preds = %44, %32
  %42 = add nuw nsw i64 %33, 1
  %43 = icmp eq i64 %42, %4
  br i1 %43, label %40, label %32, !llvm.loop !6

44:                                               ; preds = %44, %35
  %45 = phi double [ %39, %35 ], [ %52, %44 ]
  %46 = phi i64 [ 0, %35 ], [ %53, %44 ]
  %47 = getelementptr double, ptr %37, i64 %46
  %48 = load double, ptr %47, align 8
  %49 = fneg double %48
  %50 = getelementptr inbounds double, ptr %3, i64 %46
  %51 = load double, ptr %50, align 8
  %52 = tail call double @llvm.fma.f64(double %49, double %51, double %45)
  store double %52, ptr %38, align 8
  %53 = add nuw nsw i64 %46, 1
  %54 = icmp eq i64 %53, %33
  br i1 %54, label %41, label %44, !llvm.loop !7

55:                                               ; preds = %40, %64
  %56 = phi i64 [ %57, %64 ], [ %4, %40 ]
  %57 = add nsw i64 %56, -1
  %58 = icmp slt i64 %56, %4
  br i1 %58, label %59, label %64

59:                                               ; preds = %55
  %60 = mul nsw i64 %57, %4
  %61 = getelementptr double, ptr %0, i64 %60
  %62 = getelementptr inbounds double, ptr %3, i64 %57
  %63 = load double, ptr %62, align 8
  br label %72

64:                                               ; preds = %72, %55
  %65 = mul i64 %57, %11
  %66 = getelementptr inbounds double, ptr %0, i64 %65
  %67 = load double, ptr %66, align 8
  %68 = getelementptr inbounds double, ptr %3, i64 %57
  %69 = load double, ptr %68, align 8
  %70 = fdiv double %69, %67
  store double %70, ptr %68, align 8
  %71 = icmp sgt i64 %56, 1
  br i1 %71, label %55, label %215, !llvm.loop !8

72:                                               ; preds = %72, %59
  %73 = phi double [ %63, %59 ], [ %80, %72 ]
  %74 = phi i64 [ %56, %59 ], [ %81, %72 ]
  %75 = getelementptr double, ptr %61, i64 %74
  %76 = load double, ptr %75, align 8
  %77 = fneg double %76
  %78 = getelementptr inbounds double, ptr %3, i64 %74
  %79 = load double, ptr %78, align 8
  %80 = tail call double @llvm.fma.f64(double %77, double %79, double %73)
  store double %80, ptr %62, align 8
  %81 = add nuw nsw i64 %74, 1
  %82 = icmp eq i64 %81, %4
  br i1 %82, label %64, label %72, !llvm.loop !9

83:                                               ; preds = %18
  br i1 %14, label %84, label %133

84:                                               ; preds = %83, %89
  %85 = phi i64 [ %94, %89 ], [ 0, %83 ]
  %86 = mul nuw nsw i64 %85, %4
  %87 = getelementptr double, ptr %0, i64 %86
  br label %96

88:                                               ; preds = %89
  br i1 %14, label %106, label %133

89:                                               ; preds = %96
  %90 = fcmp ogt double %103, 0.000000e+00
  %91 = fdiv double 1.000000e+00, %103
  %92 = select i1 %90, double %91, double 1.000000e+00
  %93 = getelementptr inbounds double, ptr %2, i64 %85
  store double %92, ptr %93, align 8
  %94 = add nuw nsw i64 %85, 1
  %95 = icmp eq i64 %94, %4
  br i1 %95, label %88, label %84, !llvm.loop !10

96:                                               ; preds = %96, %84
  %97 = phi double [ 0.000000e+00, %84 ], [ %103, %96 ]
  %98 = phi i64 [ 0, %84 ], [ %104, %96 ]
  %99 = getelementptr double, ptr %87, i64 %98
  %100 = load double, ptr %99, align 8
  %101 = tail call double @llvm.fabs.f64(double %100)
  %102 = fcmp ogt double %101, %97
  %103 = select i1 %102, double %101, double %97
  %104 = add nuw nsw i64 %98, 1
  %105 = icmp eq i64 %104, %4
  br i1 %105, label %89, label %96, !llvm.loop !11

106:                                              ; preds = %88, %110
  %107 = phi i64 [ %115, %110 ], [ 0, %88 ]
  %108 = getelementptr double, ptr %0, i64 %107
  br label %117

109:                                              ; preds = %110
  br i1 %14, label %136, label %133

110:                                              ; preds = %117
  %111 = fcmp ogt double %128, 0.000000e+00
  %112 = fdiv double 1.000000e+00, %128
  %113 = select i1 %111, double %112, double 1.000000e+00
  %114 = getelementptr double, ptr %15, i64 %107
  store double %113, ptr %114, align 8
  %115 = add nuw nsw i64 %107, 1
  %116 = icmp eq i64 %115, %4
  br i1 %116, label %109, label %106, !llvm.loop !12

117:                                              ; preds = %117, %106
  %118 = phi i64 [ %129, %117 ], [ 0, %106 ]
  %119 = phi double [ %128, %117 ], [ 0.000000e+00, %106 ]
  %120 = mul nuw nsw i64 %118, %4
  %121 = getelementptr double, ptr %108, i64 %120
  %122 = load double, ptr %121, align 8
  %123 = tail call double @llvm.fabs.f64(double %122)
  %124 = getelementptr inbounds double, ptr %2, i64 %118
  %125 = load double, ptr %124, align 8
  %126 = fmul double %123, %125
  %127 = fcmp ogt double %126, %119
  %128 = select i1 %127, double %126, double %119
  %129 = add nuw nsw i64 %118, 1
  %130 = icmp eq i64 %129, %4
  br i1 %130, label %110, label %117, !llvm.loop !13

131:                                              ; preds = %202, %191
  %132 = icmp eq i64 %147, %4
  br i1 %132, label %133, label %136, !llvm.loop !14

133:                                              ; preds = %131, %83, %88, %109
  %134 = phi i32 [ 0, %109 ], [ 0, %88 ], [ 0, %83 ], [ %157, %131 ]
  %135 = icmp eq i32 %134, 0
  br i1 %135, label %215, label %214

136:                                              ; preds = %109, %131
  %137 = phi i32 [ %157, %131 ], [ 0, %109 ]
  %138 = phi i64 [ %147, %131 ], [ 0, %109 ]
  %139 = mul nuw nsw i64 %138, %4
  %140 = getelementptr double, ptr %0, i64 %139
  %141 = getelementptr double, ptr %140, i64 %138
  %142 = load double, ptr %141, align 8
  %143 = tail call double @llvm.fabs.f64(double %142)
  %144 = getelementptr inbounds double, ptr %2, i64 %138
  %145 = load double, ptr %144, align 8
  %146 = fmul double %143, %145
  %147 = add nuw nsw i64 %138, 1
  %148 = getelementptr double, ptr %0, i64 %138
  %149 = icmp slt i64 %147, %4
  br i1 %149, label %163, label %150

150:                                              ; preds = %163, %136
  %151 = phi i64 [ %138, %136 ], [ %175, %163 ]
  %152 = phi double [ %146, %136 ], [ %176, %163 ]
  %153 = getelementptr double, ptr %144, i64 %4
  %154 = load double, ptr %153, align 8
  %155 = fmul double %152, %154
  %156 = fcmp ugt double %155, %13
  %157 = select i1 %156, i32 %137, i32 1
  %158 = getelementptr inbounds i64, ptr %1, i64 %138
  store i64 %151, ptr %158, align 8
  %159 = icmp eq i64 %151, %138
  br i1 %159, label %191, label %160

160:                                              ; preds = %150
  %161 = mul nsw i64 %151, %4
  %162 = getelementptr double, ptr %0, i64 %161
  br label %183

163:                                              ; preds = %136, %163
  %164 = phi i64 [ %177, %163 ], [ %147, %136 ]
  %165 = phi double [ %176, %163 ], [ %146, %136 ]
  %166 = phi i64 [ %175, %163 ], [ %138, %136 ]
  %167 = mul nuw nsw i64 %164, %4
  %168 = getelementptr double, ptr %148, i64 %167
  %169 = load double, ptr %168, align 8
  %170 = tail call double @llvm.fabs.f64(double %169)
  %171 = getelementptr inbounds double, ptr %2, i64 %164
  %172 = load double, ptr %171, align 8
  %173 = fmul double %170, %172
  %174 = fcmp ogt double %173, %165
  %175 = select i1 %174, i64 %164, i64 %166
  %176 = select i1 %174, double %173, double %165
  %177 = add nuw nsw i64 %164, 1
  %178 = icmp slt i64 %177, %4
  br i1 %178, label %163, label %150, !llvm.loop !15

179:                                              ; preds = %183
  %180 = load double, ptr %144, align 8
  %181 = getelementptr inbounds double, ptr %2, i64 %151
  %182 = load double, ptr %181, align 8
  store double %182, ptr %144, align 8
  store double %180, ptr %181, align 8
  br label %191

183:                                              ; preds = %183, %160
  %184 = phi i64 [ 0, %160 ], [ %189, %183 ]
  %185 = getelementptr double, ptr %140, i64 %184
  %186 = load double, ptr %185, align 8
  %187 = getelementptr double, ptr %162, i64 %184
  %188 = load double, ptr %187, align 8
  store double %188, ptr %185, align 8
  store double %186, ptr %187, align 8
  %189 = add nuw nsw i64 %184, 1
  %190 = icmp eq i64 %189, %4
  br i1 %190, label %179, label %183, !llvm.loop !16

191:                                              ; preds = %179, %150
  %192 = load double, ptr %141, align 8
  %193 = fdiv double 1.000000e+00, %192
  br i1 %149, label %194, label %131

194:                                              ; preds = %191, %202
  %195 = phi i64 [ %203, %202 ], [ %147, %191 ]
  %196 = mul nuw nsw i64 %195, %4
  %197 = getelementptr double, ptr %0, i64 %196
  %198 = getelementptr double, ptr %197, i64 %138
  %199 = load double, ptr %198, align 8
  %200 = fmul double %193, %199
  store double %200, ptr %198, align 8
  %201 = fneg double %200
  br label %205

202:                                              ; preds = %205
  %203 = add nuw nsw i64 %195, 1
  %204 = icmp slt i64 %203, %4
  br i1 %204, label %194, label %131, !llvm.loop !17

205:                                              ; preds = %205, %194
  %206 = phi i64 [ %147, %194 ], [ %212, %205 ]
  %207 = getelementptr double, ptr %140, i64 %206
  %208 = load double, ptr %207, align 8
  %209 = getelementptr double, ptr %197, i64 %206
  %210 = load double, ptr %209, align 8
  %211 = tail call double @llvm.fma.f64(double %201, double %208, double %210)
  store double %211, ptr %209, align 8
  %212 = add nuw nsw i64 %206, 1
  %213 = icmp slt i64 %212, %4
  br i1 %213, label %205, label %202, !llvm.loop !18

214:                                              ; preds = %133
  store double 0x7FF8000000000000, ptr %17, align 8
  br label %215

215:                                              ; preds = %64, %214, %133, %40, %21, %20, %6
  %216 = phi i32 [ 0, %6 ], [ 0, %20 ], [ 0, %21 ], [ 0, %40 ], [ %134, %133 ], [ %134, %214 ], [ 0, %64 ]
  ret i32 %216
}

define range(i32 0, 2) i32 @pydy_constrained_1(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, i64 noundef %4, i64 noundef %5, i32 noundef %6) #0 {
  %8 = and i32 %6, 1
  %9 = icmp eq i32 %8, 0
  %10 = icmp sgt i64 %4, 0
  %11 = icmp sgt i64 %5, 0
  %12 = add i64 %5, 1
  %13 = sitofp i64 %5 to double
  %14 = fmul double %13, 0x3CB0000000000000
  %15 = add i64 %5, 1
  %16 = getelementptr double, ptr %2, i64 %5
  br i1 %9, label %346, label %17

17:                                               ; preds = %7
  br i1 %10, label %20, label %18

18:                                               ; preds = %20, %17
  %19 = phi double [ 0.000000e+00, %17 ], [ %26, %20 ]
  br i1 %11, label %31, label %29

20:                                               ; preds = %17, %20
  %21 = phi double [ %26, %20 ], [ 0.000000e+00, %17 ]
  %22 = phi i64 [ %27, %20 ], [ 0, %17 ]
  %23 = getelementptr inbounds double, ptr %3, i64 %22
  %24 = load double, ptr %23, align 8
  %25 = fmul double %24, 0.000000e+00
  %26 = fadd double %21, %25
  %27 = add nuw nsw i64 %22, 1
  %28 = icmp eq i64 %27, %4
  br i1 %28, label %18, label %20, !llvm.loop !19

29:                                               ; preds = %37, %18
  %30 = phi double [ 0.000000e+00, %18 ], [ %46, %37 ]
  br label %49

31:                                               ; preds = %18, %37
  %32 = phi double [ %46, %37 ], [ 0.000000e+00, %18 ]
  %33 = phi i64 [ %38, %37 ], [ 0, %18 ]
  %34 = getelementptr inbounds i64, ptr %1, i64 %33
  store i64 -1, ptr %34, align 8
  %35 = mul nuw nsw i64 %33, %5
  %36 = getelementptr double, ptr %0, i64 %35
  br label %40

37:                                               ; preds = %40
  %38 = add nuw nsw i64 %33, 1
  %39 = icmp eq i64 %38, %5
  br i1 %39, label %29, label %31, !llvm.loop !20

40:                                               ; preds = %40, %31
  %41 = phi double [ %32, %31 ], [ %46, %40 ]
  %42 = phi i64 [ 0, %31 ], [ %47, %40 ]
  %43 = getelementptr double, ptr %36, i64 %42
  %44 = load double, ptr %43, align 8
  %45 = fmul double %44, 0.000000e+00
  %46 = fadd double %41, %45
  %47 = add nuw nsw i64 %42, 1
  %48 = icmp eq i64 %47, %5
  br i1 %48, label %37, label %40, !llvm.loop !21

49:                                               ; preds = %66, %29
  %50 = phi i64 [ %67, %66 ], [ 0, %29 ]
  %51 = phi i64 [ %54, %66 ], [ %5, %29 ]
  %52 = icmp eq i64 %51, 0
  br i1 %52, label %68, label %53

53:                                               ; preds = %49
  %54 = add i64 %51, -1
  %55 = mul i64 %54, %5
  %56 = getelementptr double, ptr %0, i64 %55
  %57 = getelementptr double, ptr %56, i64 %51
  %58 = getelementptr i8, ptr %57, i64 -8
  %59 = load double, ptr %58, align 8
  %60 = fcmp oeq double %59, 0xC770000000000000
  %61 = fcmp oeq double %59, 0xC780000000000000
  %62 = or i1 %60, %61
  br i1 %62, label %63, label %66

63:                                               ; preds = %53
  %64 = zext i1 %60 to i64
  %65 = add nsw i64 %50, %64
  store double 0.000000e+00, ptr %58, align 8
  br label %66

66:                                               ; preds = %63, %53
  %67 = phi i64 [ %65, %63 ], [ %50, %53 ]
  br i1 %62, label %49, label %68, !llvm.loop !22

68:                                               ; preds = %66, %49
  %69 = phi i64 [ %51, %66 ], [ 0, %49 ]
  %70 = phi i64 [ %67, %66 ], [ %50, %49 ]
  %71 = icmp sgt i64 %69, 0
  br i1 %71, label %72, label %294

72:                                               ; preds = %68
  %73 = icmp slt i64 %69, %5
  br label %77

74:                                               ; preds = %105
  br i1 %71, label %75, label %294

75:                                               ; preds = %74
  %76 = icmp slt i64 %69, %5
  br label %110

77:                                               ; preds = %105, %72
  %78 = phi i64 [ 0, %72 ], [ %108, %105 ]
  %79 = mul i64 %78, %12
  %80 = getelementptr inbounds double, ptr %0, i64 %79
  %81 = load double, ptr %80, align 8
  %82 = getelementptr double, ptr %0, i64 %78
  br i1 %73, label %86, label %83

83:                                               ; preds = %86, %77
  %84 = phi double [ 0.000000e+00, %77 ], [ %94, %86 ]
  %85 = fcmp ogt double %81, 0.000000e+00
  br i1 %85, label %97, label %100

86:                                               ; preds = %77, %86
  %87 = phi i64 [ %95, %86 ], [ %69, %77 ]
  %88 = phi double [ %94, %86 ], [ 0.000000e+00, %77 ]
  %89 = mul nsw i64 %87, %5
  %90 = getelementptr double, ptr %82, i64 %89
  %91 = load double, ptr %90, align 8
  %92 = tail call double @llvm.fabs.f64(double %91)
  %93 = fcmp ogt double %92, %88
  %94 = select i1 %93, double %92, double %88
  %95 = add nuw nsw i64 %87, 1
  %96 = icmp eq i64 %95, %5
  br i1 %96, label %83, label %86, !llvm.loop !23

97:                                               ; preds = %83
  %98 = tail call double @llvm.sqrt.f64(double %81)
  %99 = fdiv double 1.000000e+00, %98
  br label %105

100:                                              ; preds = %83
  %101 = fcmp ogt double %84, 0.000000e+00
  %102 = fmul double %84, 0x3CB0000000000000
  %103 = fdiv double 1.000000e+00, %102
  %104 = select i1 %101, double %103, double 0x4330000000000000
  br label %105

105:                                              ; preds = %100, %97
  %106 = phi double [ %99, %97 ], [ %104, %100 ]
  %107 = getelementptr inbounds double, ptr %2, i64 %78
  store double %106, ptr %107, align 8
  %108 = add nuw nsw i64 %78, 1
  %109 = icmp slt i64 %108, %69
  br i1 %109, label %77, label %74, !llvm.loop !24

110:                                              ; preds = %288, %75
  %111 = phi i64 [ %70, %75 ], [ %195, %288 ]
  %112 = phi i32 [ 0, %75 ], [ %290, %288 ]
  %113 = phi i64 [ 0, %75 ], [ %291, %288 ]
  %114 = phi double [ %30, %75 ], [ %289, %288 ]
  %115 = icmp ne i64 %111, 0
  %116 = and i1 %76, %115
  br i1 %116, label %117, label %127

117:                                              ; preds = %110, %139
  %118 = phi i64 [ %143, %139 ], [ %69, %110 ]
  %119 = phi i64 [ %142, %139 ], [ -1, %110 ]
  %120 = phi i64 [ %141, %139 ], [ -1, %110 ]
  %121 = phi double [ %140, %139 ], [ %13, %110 ]
  %122 = getelementptr inbounds i64, ptr %1, i64 %118
  %123 = load i64, ptr %122, align 8
  %124 = icmp slt i64 %123, 0
  %125 = mul nsw i64 %118, %5
  %126 = getelementptr double, ptr %0, i64 %125
  br i1 %124, label %131, label %139

127:                                              ; preds = %139, %110
  %128 = phi i64 [ -1, %110 ], [ %141, %139 ]
  %129 = phi i64 [ -1, %110 ], [ %142, %139 ]
  %130 = icmp slt i64 %128, 0
  br i1 %130, label %163, label %190

131:                                              ; preds = %117, %157
  %132 = phi i64 [ %161, %157 ], [ 0, %117 ]
  %133 = phi i64 [ %160, %157 ], [ %119, %117 ]
  %134 = phi i64 [ %159, %157 ], [ %120, %117 ]
  %135 = phi double [ %158, %157 ], [ %121, %117 ]
  %136 = getelementptr inbounds i64, ptr %1, i64 %132
  %137 = load i64, ptr %136, align 8
  %138 = icmp sgt i64 %137, -1
  br i1 %138, label %157, label %146

139:                                              ; preds = %157, %117
  %140 = phi double [ %121, %117 ], [ %158, %157 ]
  %141 = phi i64 [ %120, %117 ], [ %159, %157 ]
  %142 = phi i64 [ %119, %117 ], [ %160, %157 ]
  %143 = add nuw nsw i64 %118, 1
  %144 = icmp slt i64 %143, %5
  %145 = select i1 %115, i1 %144, i1 false
  br i1 %145, label %117, label %127, !llvm.loop !25

146:                                              ; preds = %131
  %147 = getelementptr double, ptr %126, i64 %132
  %148 = load double, ptr %147, align 8
  %149 = tail call double @llvm.fabs.f64(double %148)
  %150 = getelementptr inbounds double, ptr %2, i64 %132
  %151 = load double, ptr %150, align 8
  %152 = fmul double %149, %151
  %153 = fcmp ogt double %152, %135
  %154 = select i1 %153, double %152, double %135
  %155 = select i1 %153, i64 %118, i64 %134
  %156 = select i1 %153, i64 %132, i64 %133
  br label %157

157:                                              ; preds = %146, %131
  %158 = phi double [ %135, %131 ], [ %154, %146 ]
  %159 = phi i64 [ %134, %131 ], [ %155, %146 ]
  %160 = phi i64 [ %133, %131 ], [ %156, %146 ]
  %161 = add nuw nsw i64 %132, 1
  %162 = icmp slt i64 %161, %69
  br i1 %162, label %131, label %139, !llvm.loop !26

163:                                              ; preds = %127, %184
  %164 = phi i64 [ %188, %184 ], [ 0, %127 ]
  %165 = phi i64 [ %187, %184 ], [ %129, %127 ]
  %166 = phi i64 [ %186, %184 ], [ %128, %127 ]
  %167 = phi double [ %185, %184 ], [ %14, %127 ]
  %168 = getelementptr inbounds i64, ptr %1, i64 %164
  %169 = load i64, ptr %168, align 8
  %170 = icmp sgt i64 %169, -1
  br i1 %170, label %184, label %171

171:                                              ; preds = %163
  %172 = mul i64 %164, %15
  %173 = getelementptr inbounds double, ptr %0, i64 %172
  %174 = load double, ptr %173, align 8
  %175 = tail call double @llvm.fabs.f64(double %174)
  %176 = getelementptr inbounds double, ptr %2, i64 %164
  %177 = load double, ptr %176, align 8
  %178 = fmul double %175, %177
  %179 = fmul double %177, %178
  %180 = fcmp ogt double %179, %167
  %181 = select i1 %180, double %179, double %167
  %182 = select i1 %180, i64 %164, i64 %166
  %183 = select i1 %180, i64 %164, i64 %165
  br label %184

184:                                              ; preds = %171, %163
  %185 = phi double [ %167, %163 ], [ %181, %171 ]
  %186 = phi i64 [ %166, %163 ], [ %182, %171 ]
  %187 = phi i64 [ %165, %163 ], [ %183, %171 ]
  %188 = add nuw nsw i64 %164, 1
  %189 = icmp slt i64 %188, %69
  br i1 %189, label %163, label %192, !llvm.loop !27

190:                                              ; preds = %127
  %191 = add nsw i64 %111, -1
  br label %192

192:                                              ; preds = %184, %190
  %193 = phi i64 [ %128, %190 ], [ %186, %184 ]
  %194 = phi i64 [ %129, %190 ], [ %187, %184 ]
  %195 = phi i64 [ %191, %190 ], [ 0, %184 ]
  %196 = icmp sgt i64 %193, -1
  br i1 %196, label %201, label %197

197:                                              ; preds = %192
  %198 = fadd double %19, %114
  %199 = fcmp oeq double %198, 0.000000e+00
  %200 = zext i1 %199 to i32
  br label %288

201:                                              ; preds = %192
  %202 = mul nsw i64 %193, %5
  %203 = getelementptr double, ptr %0, i64 %202
  %204 = getelementptr double, ptr %203, i64 %194
  %205 = load double, ptr %204, align 8
  %206 = fdiv double 1.000000e+00, %205
  br i1 %11, label %207, label %242

207:                                              ; preds = %201, %239
  %208 = phi i64 [ %240, %239 ], [ 0, %201 ]
  %209 = mul nuw nsw i64 %208, %5
  %210 = getelementptr double, ptr %0, i64 %209
  %211 = getelementptr double, ptr %210, i64 %194
  %212 = load double, ptr %211, align 8
  %213 = fmul double %206, %212
  %214 = icmp eq i64 %208, %193
  %215 = fcmp oeq double %213, 0.000000e+00
  %216 = select i1 %214, i1 true, i1 %215
  br i1 %216, label %239, label %217

217:                                              ; preds = %207
  %218 = fneg double %213
  br label %220

219:                                              ; preds = %220
  br i1 %10, label %229, label %239

220:                                              ; preds = %220, %217
  %221 = phi i64 [ 0, %217 ], [ %227, %220 ]
  %222 = getelementptr double, ptr %203, i64 %221
  %223 = load double, ptr %222, align 8
  %224 = getelementptr double, ptr %210, i64 %221
  %225 = load double, ptr %224, align 8
  %226 = tail call double @llvm.fma.f64(double %218, double %223, double %225)
  store double %226, ptr %224, align 8
  %227 = add nuw nsw i64 %221, 1
  %228 = icmp eq i64 %227, %5
  br i1 %228, label %219, label %220, !llvm.loop !28

229:                                              ; preds = %219, %229
  %230 = phi i64 [ %237, %229 ], [ 0, %219 ]
  %231 = getelementptr double, ptr %3, i64 %230
  %232 = getelementptr double, ptr %231, i64 %193
  %233 = load double, ptr %232, align 8
  %234 = getelementptr double, ptr %231, i64 %208
  %235 = load double, ptr %234, align 8
  %236 = tail call double @llvm.fma.f64(double %218, double %233, double %235)
  store double %236, ptr %234, align 8
  %237 = add nuw nsw i64 %230, %5
  %238 = icmp slt i64 %237, %4
  br i1 %238, label %229, label %239, !llvm.loop !29

239:                                              ; preds = %229, %219, %207
  %240 = add nuw nsw i64 %208, 1
  %241 = icmp eq i64 %240, %5
  br i1 %241, label %242, label %207, !llvm.loop !30

242:                                              ; preds = %239, %201
  %243 = getelementptr inbounds i64, ptr %1, i64 %193
  store i64 %194, ptr %243, align 8
  %244 = icmp eq i64 %193, %194
  br i1 %244, label %288, label %245

245:                                              ; preds = %242
  %246 = mul nsw i64 %194, %5
  %247 = getelementptr double, ptr %0, i64 %246
  %248 = getelementptr double, ptr %247, i64 %193
  %249 = load double, ptr %248, align 8
  %250 = fdiv double 1.000000e+00, %249
  br i1 %11, label %251, label %286

251:                                              ; preds = %245, %283
  %252 = phi i64 [ %284, %283 ], [ 0, %245 ]
  %253 = mul nuw nsw i64 %252, %5
  %254 = getelementptr double, ptr %0, i64 %253
  %255 = getelementptr double, ptr %254, i64 %193
  %256 = load double, ptr %255, align 8
  %257 = fmul double %250, %256
  %258 = icmp eq i64 %252, %194
  %259 = fcmp oeq double %257, 0.000000e+00
  %260 = select i1 %258, i1 true, i1 %259
  br i1 %260, label %283, label %261

261:                                              ; preds = %251
  %262 = fneg double %257
  br label %264

263:                                              ; preds = %264
  br i1 %10, label %273, label %283

264:                                              ; preds = %264, %261
  %265 = phi i64 [ 0, %261 ], [ %271, %264 ]
  %266 = getelementptr double, ptr %247, i64 %265
  %267 = load double, ptr %266, align 8
  %268 = getelementptr double, ptr %254, i64 %265
  %269 = load double, ptr %268, align 8
  %270 = tail call double @llvm.fma.f64(double %262, double %267, double %269)
  store double %270, ptr %268, align 8
  %271 = add nuw nsw i64 %265, 1
  %272 = icmp eq i64 %271, %5
  br i1 %272, label %263, label %264, !llvm.loop !28

273:                                              ; preds = %263, %273
  %274 = phi i64 [ %281, %273 ], [ 0, %263 ]
  %275 = getelementptr double, ptr %3, i64 %274
  %276 = getelementptr double, ptr %275, i64 %194
  %277 = load double, ptr %276, align 8
  %278 = getelementptr double, ptr %275, i64 %252
  %279 = load double, ptr %278, align 8
  %280 = tail call double @llvm.fma.f64(double %262, double %277, double %279)
  store double %280, ptr %278, align 8
  %281 = add nuw nsw i64 %274, %5
  %282 = icmp slt i64 %281, %4
  br i1 %282, label %273, label %283, !llvm.loop !29

283:                                              ; preds = %273, %263, %251
  %284 = add nuw nsw i64 %252, 1
  %285 = icmp eq i64 %284, %5
  br i1 %285, label %286, label %251, !llvm.loop !30

286:                                              ; preds = %283, %245
  %287 = getelementptr inbounds i64, ptr %1, i64 %194
  store i64 %193, ptr %287, align 8
  br label %288

288:                                              ; preds = %286, %242, %197
  %289 = phi double [ 0x7FF8000000000000, %197 ], [ %114, %286 ], [ %114, %242 ]
  %290 = phi i32 [ %200, %197 ], [ %112, %286 ], [ %112, %242 ]
  %291 = add nuw nsw i64 %113, 1
  %292 = icmp slt i64 %291, %69
  %293 = select i1 %196, i1 %292, i1 false
  br i1 %293, label %110, label %294, !llvm.loop !31

294:                                              ; preds = %288, %68, %74
  %295 = phi double [ %30, %74 ], [ %30, %68 ], [ %289, %288 ]
  %296 = phi i32 [ 0, %74 ], [ 0, %68 ], [ %290, %288 ]
  br i1 %10, label %297, label %346

297:                                              ; preds = %294, %335
  %298 = phi i64 [ %336, %335 ], [ 0, %294 ]
  br i1 %11, label %299, label %301

299:                                              ; preds = %297
  %300 = getelementptr double, ptr %3, i64 %298
  br label %305

301:                                              ; preds = %305, %297
  %302 = phi double [ %295, %297 ], [ %311, %305 ]
  br i1 %11, label %303, label %335

303:                                              ; preds = %301
  %304 = getelementptr double, ptr %3, i64 %298
  br label %318

305:                                              ; preds = %305, %299
  %306 = phi i64 [ 0, %299 ], [ %313, %305 ]
  %307 = phi double [ %295, %299 ], [ %311, %305 ]
  %308 = getelementptr double, ptr %300, i64 %306
  %309 = load double, ptr %308, align 8
  %310 = fmul double %309, 0.000000e+00
  %311 = fadd double %307, %310
  %312 = getelementptr double, ptr %16, i64 %306
  store double 0.000000e+00, ptr %312, align 8
  %313 = add nuw nsw i64 %306, 1
  %314 = icmp eq i64 %313, %5
  br i1 %314, label %301, label %305, !llvm.loop !32

315:                                              ; preds = %332
  br i1 %11, label %316, label %335

316:                                              ; preds = %315
  %317 = getelementptr double, ptr %3, i64 %298
  br label %338

318:                                              ; preds = %332, %303
  %319 = phi i64 [ 0, %303 ], [ %333, %332 ]
  %320 = getelementptr inbounds i64, ptr %1, i64 %319
  %321 = load i64, ptr %320, align 8
  %322 = icmp sgt i64 %321, -1
  br i1 %322, label %323, label %332

323:                                              ; preds = %318
  %324 = getelementptr double, ptr %304, i64 %319
  %325 = load double, ptr %324, align 8
  %326 = mul nuw nsw i64 %319, %5
  %327 = getelementptr double, ptr %0, i64 %326
  %328 = getelementptr double, ptr %327, i64 %321
  %329 = load double, ptr %328, align 8
  %330 = fdiv double %325, %329
  %331 = getelementptr double, ptr %16, i64 %321
  store double %330, ptr %331, align 8
  br label %332

332:                                              ; preds = %323, %318
  %333 = add nuw nsw i64 %319, 1
  %334 = icmp eq i64 %333, %5
  br i1 %334, label %315, label %318, !llvm.loop !33

335:                                              ; preds = %338, %301, %315
  %336 = add nsw i64 %298, %5
  %337 = icmp slt i64 %336, %4
  br i1 %337, label %297, label %346, !llvm.loop !34

338:                                              ; preds = %338, %316
  %339 = phi i64 [ 0, %316 ], [ %344, %338 ]
  %340 = getelementptr double, ptr %16, i64 %339
  %341 = load double, ptr %340, align 8
  %342 = fadd double %302, %341
  %343 = getelementptr double, ptr %317, i64 %339
  store double %342, ptr %343, align 8
  %344 = add nuw nsw i64 %339, 1
  %345 = icmp eq i64 %344, %5
  br i1 %345, label %335, label %338, !llvm.loop !35

346:                                              ; preds = %335, %294, %7
  %347 = phi i32 [ 0, %7 ], [ %296, %294 ], [ %296, %335 ]
  ret i32 %347
}

define range(i32 0, 2) i32 @pydy_ldl_factor_1(ptr noundef %0, ptr noundef %1, i64 noundef %2) #0 {
  %4 = sitofp i64 %2 to double
  %5 = fmul double %4, 0x3CB0000000000000
  %6 = icmp sgt i64 %2, 0
  br i1 %6, label %7, label %9

7:                                                ; preds = %3
  %8 = add nuw i64 %2, 1
  br label %11

9:                                                ; preds = %11, %3
  %10 = icmp sgt i64 %2, 0
  br i1 %10, label %24, label %22

11:                                               ; preds = %7, %11
  %12 = phi i64 [ 0, %7 ], [ %18, %11 ]
  %13 = mul i64 %12, %8
  %14 = getelementptr inbounds double, ptr %0, i64 %13
  %15 = load double, ptr %14, align 8
  %16 = fmul double %5, %15
  %17 = getelementptr inbounds double, ptr %1, i64 %12
  store double %16, ptr %17, align 8
  %18 = add nuw nsw i64 %12, 1
  %19 = icmp eq i64 %18, %2
  br i1 %19, label %9, label %11, !llvm.loop !36

20:                                               ; preds = %48, %24
  %21 = icmp eq i64 %37, %2
  br i1 %21, label %22, label %24, !llvm.loop !37

22:                                               ; preds = %20, %9
  %23 = phi i32 [ 0, %9 ], [ %35, %20 ]
  ret i32 %23

24:                                               ; preds = %9, %20
  %25 = phi i32 [ %35, %20 ], [ 0, %9 ]
  %26 = phi i64 [ %37, %20 ], [ 0, %9 ]
  %27 = mul nuw nsw i64 %26, %2
  %28 = getelementptr double, ptr %0, i64 %27
  %29 = getelementptr double, ptr %28, i64 %26
  %30 = load double, ptr %29, align 8
  %31 = getelementptr inbounds double, ptr %1, i64 %26
  %32 = load double, ptr %31, align 8
  %33 = fcmp ule double %30, %32
  %34 = zext i1 %33 to i32
  %35 = or i32 %25, %34
  %36 = fdiv double 1.000000e+00, %30
  store double %36, ptr %31, align 8
  %37 = add nuw nsw i64 %26, 1
  %38 = icmp slt i64 %37, %2
  br i1 %38, label %39, label %20

39:                                               ; preds = %24, %48
  %40 = phi i64 [ %49, %48 ], [ %37, %24 ]
  %41 = getelementptr inbounds double, ptr %28, i64 %40
  %42 = load double, ptr %41, align 8
  %43 = load double, ptr %31, align 8
  %44 = fneg double %42
  %45 = fmul double %43, %44
  %46 = mul nuw nsw i64 %40, %2
  %47 = getelementptr double, ptr %0, i64 %46
  br label %51

48:                                               ; preds = %51
  %49 = add nuw nsw i64 %40, 1
  %50 = icmp slt i64 %49, %2
  br i1 %50, label %39, label %20, !llvm.loop !38

51:                                               ; preds = %39, %51
  %52 = phi i64 [ %40, %39 ], [ %58, %51 ]
  %53 = getelementptr inbounds double, ptr %28, i64 %52
  %54 = load double, ptr %53, align 8
  %55 = getelementptr double, ptr %47, i64 %52
  %56 = load double, ptr %55, align 8
  %57 = tail call double @llvm.fma.f64(double %45, double %54, double %56)
  store double %57, ptr %55, align 8
  %58 = add nuw nsw i64 %52, 1
  %59 = icmp slt i64 %58, %2
  br i1 %59, label %51, label %48, !llvm.loop !39
}

declare double @llvm.fma.f64(double, double, double) #1

define void @pydy_ldl_solve_1(ptr noundef readonly %0, ptr noundef readonly %1, ptr noundef %2, i64 noundef %3) #0 {
  %5 = icmp sgt i64 %3, 0
  br i1 %5, label %8, label %6

6:                                                ; preds = %20, %4
  %7 = icmp sgt i64 %3, 0
  br i1 %7, label %32, label %39

8:                                                ; preds = %4, %20
  %9 = phi i64 [ %15, %20 ], [ 0, %4 ]
  %10 = getelementptr inbounds double, ptr %2, i64 %9
  %11 = load double, ptr %10, align 8
  %12 = getelementptr inbounds double, ptr %1, i64 %9
  %13 = load double, ptr %12, align 8
  %14 = fmul double %11, %13
  %15 = add nuw nsw i64 %9, 1
  %16 = icmp slt i64 %15, %3
  br i1 %16, label %17, label %20

17:                                               ; preds = %8
  %18 = mul nuw nsw i64 %9, %3
  %19 = getelementptr double, ptr %0, i64 %18
  br label %22

20:                                               ; preds = %22, %8
  store double %14, ptr %10, align 8
  %21 = icmp eq i64 %15, %3
  br i1 %21, label %6, label %8, !llvm.loop !40

22:                                               ; preds = %17, %22
  %23 = phi i64 [ %15, %17 ], [ %30, %22 ]
  %24 = getelementptr double, ptr %19, i64 %23
  %25 = load double, ptr %24, align 8
  %26 = fneg double %25
  %27 = getelementptr inbounds double, ptr %2, i64 %23
  %28 = load double, ptr %27, align 8
  %29 = tail call double @llvm.fma.f64(double %26, double %14, double %28)
  store double %29, ptr %27, align 8
  %30 = add nuw nsw i64 %23, 1
  %31 = icmp slt i64 %30, %3
  br i1 %31, label %22, label %20, !llvm.loop !41

32:                                               ; preds = %6, %40
  %33 = phi i64 [ %34, %40 ], [ %3, %6 ]
  %34 = add nsw i64 %33, -1
  %35 = icmp slt i64 %33, %3
  br i1 %35, label %36, label %40

36:                                               ; preds = %32
  %37 = mul nsw i64 %34, %3
  %38 = getelementptr double, ptr %0, i64 %37
  br label %49

39:                                               ; preds = %40, %6
  ret void

40:                                               ; preds = %49, %32
  %41 = phi double [ 0.000000e+00, %32 ], [ %57, %49 ]
  %42 = getelementptr inbounds double, ptr %1, i64 %34
  %43 = load double, ptr %42, align 8
  %44 = fmul double %41, %43
  %45 = getelementptr inbounds double, ptr %2, i64 %34
  %46 = load double, ptr %45, align 8
  %47 = fadd double %46, %44
  store double %47, ptr %45, align 8
  %48 = icmp sgt i64 %33, 1
  br i1 %48, label %32, label %39, !llvm.loop !42

49:                                               ; preds = %36, %49
  %50 = phi i64 [ %33, %36 ], [ %58, %49 ]
  %51 = phi double [ 0.000000e+00, %36 ], [ %57, %49 ]
  %52 = getelementptr double, ptr %38, i64 %50
  %53 = load double, ptr %52, align 8
  %54 = fneg double %53
  %55 = getelementptr inbounds double, ptr %2, i64 %50
  %56 = load double, ptr %55, align 8
  %57 = tail call double @llvm.fma.f64(double %54, double %56, double %51)
  %58 = add nuw nsw i64 %50, 1
  %59 = icmp eq i64 %58, %3
  br i1 %59, label %40, label %49, !llvm.loop !43
}

define range(i32 0, 2) i32 @pydy_guard_1(ptr noundef readonly %0, ptr noundef %1, i64 noundef %2, ptr noundef %3, i64 noundef %4, i32 noundef %5) #2 {
  %7 = icmp sgt i64 %4, 0
  br i1 %7, label %8, label %15

8:                                                ; preds = %6, %21
  %9 = phi i64 [ %23, %21 ], [ 1, %6 ]
  %10 = phi ptr [ %28, %21 ], [ %0, %6 ]
  %11 = phi i64 [ %22, %21 ], [ 0, %6 ]
  %12 = getelementptr double, ptr %3, i64 %11
  %13 = mul nuw nsw i64 %11, %4
  %14 = getelementptr double, ptr %3, i64 %13
  br label %25

15:                                               ; preds = %21, %6
  %16 = mul nsw i64 %4, %4
  %17 = getelementptr inbounds double, ptr %3, i64 %16
  %18 = getelementptr inbounds double, ptr %17, i64 %4
  %19 = tail call i32 @pydy_lu_1(ptr noundef %3, ptr noundef %17, ptr noundef %18, ptr noundef null, i64 noundef %4, i32 noundef %5) #3
  %20 = icmp sgt i64 %2, 0
  br i1 %20, label %36, label %35

21:                                               ; preds = %25
  %22 = add nuw nsw i64 %11, 1
  %23 = add nuw i64 %9, 1
  %24 = icmp eq i64 %22, %4
  br i1 %24, label %15, label %8, !llvm.loop !44

25:                                               ; preds = %8, %25
  %26 = phi ptr [ %10, %8 ], [ %28, %25 ]
  %27 = phi i64 [ 0, %8 ], [ %33, %25 ]
  %28 = getelementptr inbounds i8, ptr %26, i64 8
  %29 = load double, ptr %26, align 8
  %30 = mul nuw nsw i64 %27, %4
  %31 = getelementptr double, ptr %12, i64 %30
  store double %29, ptr %31, align 8
  %32 = getelementptr double, ptr %14, i64 %27
  store double %29, ptr %32, align 8
  %33 = add nuw nsw i64 %27, 1
  %34 = icmp eq i64 %33, %9
  br i1 %34, label %21, label %25, !llvm.loop !45

35:                                               ; preds = %36, %15
  ret i32 %19

36:                                               ; preds = %15, %36
  %37 = phi i64 [ %41, %36 ], [ 0, %15 ]
  %38 = mul nsw i64 %37, %4
  %39 = getelementptr inbounds double, ptr %1, i64 %38
  %40 = tail call i32 @pydy_lu_1(ptr noundef %3, ptr noundef %17, ptr noundef %18, ptr noundef %39, i64 noundef %4, i32 noundef %5) #3
  %41 = add nuw nsw i64 %37, 1
  %42 = icmp eq i64 %41, %2
  br i1 %42, label %35, label %36, !llvm.loop !46
}

declare double @llvm.fabs.f64(double) #1

declare double @llvm.sqrt.f64(double) #1

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn memory(none) }
attributes #2 = { nounwind }
attributes #3 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = distinct !{!3, !4, !5}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
!6 = distinct !{!6, !4, !5}
!7 = distinct !{!7, !4, !5}
!8 = distinct !{!8, !4, !5}
!9 = distinct !{!9, !4, !5}
!10 = distinct !{!10, !4, !5}
!11 = distinct !{!11, !4, !5}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5}
!14 = distinct !{!14, !4, !5}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5}
!17 = distinct !{!17, !4, !5}
!18 = distinct !{!18, !4, !5}
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !4, !5}
!21 = distinct !{!21, !4, !5}
!22 = distinct !{!22, !4, !5}
!23 = distinct !{!23, !4, !5}
!24 = distinct !{!24, !4, !5}
!25 = distinct !{!25, !4, !5}
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5}
!29 = distinct !{!29, !4, !5}
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5}
!35 = distinct !{!35, !4, !5}
!36 = distinct !{!36, !4, !5}
!37 = distinct !{!37, !4, !5}
!38 = distinct !{!38, !4, !5}
!39 = distinct !{!39, !4, !5}
!40 = distinct !{!40, !4, !5}
!41 = distinct !{!41, !4, !5}
!42 = distinct !{!42, !4, !5}
!43 = distinct !{!43, !4, !5}
!44 = distinct !{!44, !4, !5}
!45 = distinct !{!45, !4, !5}
!46 = distinct !{!46, !4, !5}
