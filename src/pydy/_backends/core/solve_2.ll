; sources 8c1d90f4ab6774336b2c17782ff83d790e344dd66c0858f09a93dcc9af6ab15c
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define range(i32 0, 4) i32 @pydy_lu_2(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, i64 noundef %4, i32 noundef %5) #0 {
  %7 = mul i64 %4, %4
  %8 = icmp eq ptr %3, null
  %9 = icmp sgt i64 %4, 0
  %10 = shl i64 %4, 4
  %11 = add i64 %10, 16
  %12 = sitofp i64 %4 to double
  %13 = fmul double %12, 0x3CB0000000000000
  %14 = icmp sgt i64 %4, 0
  %15 = getelementptr double, ptr %2, i64 %4
  %16 = shl i64 %7, 4
  br label %18

17:                                               ; preds = %252
  ret i32 %253

18:                                               ; preds = %6, %252
  %19 = phi i64 [ 0, %6 ], [ %254, %252 ]
  %20 = phi i32 [ 0, %6 ], [ %253, %252 ]
  %21 = trunc nuw nsw i64 %19 to i32
  %22 = shl nuw nsw i32 1, %21
  %23 = and i32 %22, %5
  %24 = icmp eq i32 %23, 0
  br i1 %24, label %252, label %25

25:                                               ; preds = %18
  %26 = getelementptr inbounds double, ptr %0, i64 %19
  %27 = getelementptr inbounds i64, ptr %1, i64 %19
  br i1 %8, label %101, label %28

28:                                               ; preds = %25
  %29 = getelementptr inbounds double, ptr %3, i64 %19
  br i1 %9, label %31, label %252

30:                                               ; preds = %31
  br i1 %9, label %43, label %252

31:                                               ; preds = %28, %31
  %32 = phi i64 [ %41, %31 ], [ 0, %28 ]
  %33 = shl nuw nsw i64 %32, 1
  %34 = getelementptr inbounds i64, ptr %27, i64 %33
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds double, ptr %29, i64 %33
  %37 = load double, ptr %36, align 8
  %38 = shl nsw i64 %35, 4
  %39 = getelementptr inbounds i8, ptr %29, i64 %38
  %40 = load double, ptr %39, align 8
  store double %40, ptr %36, align 8
  store double %37, ptr %39, align 8
  %41 = add nuw nsw i64 %32, 1
  %42 = icmp eq i64 %41, %4
  br i1 %42, label %30, label %31, !llvm.loop !3

43:                                               ; preds = %30, %52
  %44 = phi i64 [ %53, %52 ], [ 0, %30 ]
  %45 = icmp eq i64 %44, 0
  br i1 %45, label %52, label %46

46:                                               ; preds = %43
  %47 = mul nuw nsw i64 %44, %4
  %48 = shl nsw i64 %44, 4
  %49 = getelementptr inbounds i8, ptr %29, i64 %48
  %50 = load double, ptr %49, align 8
  br label %55

51:                                               ; preds = %52
  br i1 %9, label %69, label %252

52:                                               ; preds = %55, %43
  %53 = add nuw nsw i64 %44, 1
  %54 = icmp eq i64 %53, %4
  br i1 %54, label %51, label %43, !llvm.loop !6

55:                                               ; preds = %55, %46
  %56 = phi double [ %50, %46 ], [ %66, %55 ]
  %57 = phi i64 [ 0, %46 ], [ %67, %55 ]
  %58 = add nuw nsw i64 %57, %47
  %59 = shl nsw i64 %58, 4
  %60 = getelementptr inbounds i8, ptr %26, i64 %59
  %61 = load double, ptr %60, align 8
  %62 = fneg double %61
  %63 = shl nsw i64 %57, 4
  %64 = getelementptr inbounds i8, ptr %29, i64 %63
  %65 = load double, ptr %64, align 8
  %66 = tail call double @llvm.fma.f64(double %62, double %65, double %56)
  store double %66, ptr %49, align 8
  %67 = add nuw nsw i64 %57, 1
  %68 = icmp eq i64 %67, %44
  br i1 %68, label %52, label %55, !llvm.loop !7

69:                                               ; preds = %51, %78
  %70 = phi i64 [ %71, %78 ], [ %4, %51 ]
  %71 = add nsw i64 %70, -1
  %72 = icmp slt i64 %70, %4
  br i1 %72, label %73, label %78

73:                                               ; preds = %69
  %74 = mul nsw i64 %71, %4
  %75 = shl nsw i64 %71, 4
  %76 = getelementptr inbounds i8, ptr %29, i64 %75
  %77 = load double, ptr %76, align 8
  br label %87

78:                                               ; preds = %87, %69
  %79 = mul i64 %71, %11
  %80 = getelementptr inbounds i8, ptr %26, i64 %79
  %81 = load double, ptr %80, align 8
  %82 = shl nsw i64 %71, 4
  %83 = getelementptr inbounds i8, ptr %29, i64 %82
  %84 = load double, ptr %83, align 8
  %85 = fdiv double %84, %81
  store double %85, ptr %83, align 8
  %86 = icmp sgt i64 %70, 1
  br i1 %86, label %69, label %252, !llvm.loop !8

87:                                               ; preds = %87, %73
  %88 = phi double [ %77, %73 ], [ %98, %87 ]
  %89 = phi i64 [ %70, %73 ], [ %99, %87 ]
  %90 = add nsw i64 %89, %74
  %91 = shl nsw i64 %90, 4
  %92 = getelementptr inbounds i8, ptr %26, i64 %91
  %93 = load double, ptr %92, align 8
  %94 = fneg double %93
  %95 = shl nsw i64 %89, 4
  %96 = getelementptr inbounds i8, ptr %29, i64 %95
  %97 = load double, ptr %96, align 8
  %98 = tail call double @llvm.fma.f64(double %94, double %97, double %88)
  store double %98, ptr %76, align 8
  %99 = add nuw nsw i64 %89, 1
  %100 = icmp eq i64 %99, %4
  br i1 %100, label %78, label %87, !llvm.loop !9

101:                                              ; preds = %25
  br i1 %14, label %102, label %153

102:                                              ; preds = %101, %106
  %103 = phi i64 [ %111, %106 ], [ 0, %101 ]
  %104 = mul nuw nsw i64 %103, %4
  br label %113

105:                                              ; preds = %106
  br i1 %14, label %125, label %153

106:                                              ; preds = %113
  %107 = fcmp ogt double %122, 0.000000e+00
  %108 = fdiv double 1.000000e+00, %122
  %109 = select i1 %107, double %108, double 1.000000e+00
  %110 = getelementptr inbounds double, ptr %2, i64 %103
  store double %109, ptr %110, align 8
  %111 = add nuw nsw i64 %103, 1
  %112 = icmp eq i64 %111, %4
  br i1 %112, label %105, label %102, !llvm.loop !10

113:                                              ; preds = %113, %102
  %114 = phi double [ 0.000000e+00, %102 ], [ %122, %113 ]
  %115 = phi i64 [ 0, %102 ], [ %123, %113 ]
  %116 = add nuw nsw i64 %115, %104
  %117 = shl nsw i64 %116, 4
  %118 = getelementptr inbounds i8, ptr %26, i64 %117
  %119 = load double, ptr %118, align 8
  %120 = tail call double @llvm.fabs.f64(double %119)
  %121 = fcmp ogt double %120, %114
  %122 = select i1 %121, double %120, double %114
  %123 = add nuw nsw i64 %115, 1
  %124 = icmp eq i64 %123, %4
  br i1 %124, label %106, label %113, !llvm.loop !11

125:                                              ; preds = %105, %128
  %126 = phi i64 [ %133, %128 ], [ 0, %105 ]
  br label %135

127:                                              ; preds = %128
  br i1 %14, label %156, label %153

128:                                              ; preds = %135
  %129 = fcmp ogt double %148, 0.000000e+00
  %130 = fdiv double 1.000000e+00, %148
  %131 = select i1 %129, double %130, double 1.000000e+00
  %132 = getelementptr double, ptr %15, i64 %126
  store double %131, ptr %132, align 8
  %133 = add nuw nsw i64 %126, 1
  %134 = icmp eq i64 %133, %4
  br i1 %134, label %127, label %125, !llvm.loop !12

135:                                              ; preds = %135, %125
  %136 = phi i64 [ %149, %135 ], [ 0, %125 ]
  %137 = phi double [ %148, %135 ], [ 0.000000e+00, %125 ]
  %138 = mul nuw nsw i64 %136, %4
  %139 = add nuw nsw i64 %138, %126
  %140 = shl nsw i64 %139, 4
  %141 = getelementptr inbounds i8, ptr %26, i64 %140
  %142 = load double, ptr %141, align 8
  %143 = tail call double @llvm.fabs.f64(double %142)
  %144 = getelementptr inbounds double, ptr %2, i64 %136
  %145 = load double, ptr %144, align 8
  %146 = fmul double %143, %145
  %147 = fcmp ogt double %146, %137
  %148 = select i1 %147, double %146, double %137
  %149 = add nuw nsw i64 %136, 1
  %150 = icmp eq i64 %149, %4
  br i1 %150, label %128, label %135, !llvm.loop !13

151:                                              ; preds = %229, %217
  %152 = icmp eq i64 %168, %4
  br i1 %152, label %153, label %156, !llvm.loop !14

153:                                              ; preds = %151, %101, %105, %127
  %154 = phi i32 [ 0, %127 ], [ 0, %105 ], [ 0, %101 ], [ %177, %151 ]
  %155 = icmp eq i32 %154, 0
  br i1 %155, label %248, label %245

156:                                              ; preds = %127, %151
  %157 = phi i32 [ %177, %151 ], [ 0, %127 ]
  %158 = phi i64 [ %168, %151 ], [ 0, %127 ]
  %159 = mul nuw nsw i64 %158, %4
  %160 = add nuw nsw i64 %159, %158
  %161 = shl nsw i64 %160, 4
  %162 = getelementptr inbounds i8, ptr %26, i64 %161
  %163 = load double, ptr %162, align 8
  %164 = tail call double @llvm.fabs.f64(double %163)
  %165 = getelementptr inbounds double, ptr %2, i64 %158
  %166 = load double, ptr %165, align 8
  %167 = fmul double %164, %166
  %168 = add nuw nsw i64 %158, 1
  %169 = icmp slt i64 %168, %4
  br i1 %169, label %183, label %170

170:                                              ; preds = %183, %156
  %171 = phi i64 [ %158, %156 ], [ %197, %183 ]
  %172 = phi double [ %167, %156 ], [ %198, %183 ]
  %173 = getelementptr double, ptr %165, i64 %4
  %174 = load double, ptr %173, align 8
  %175 = fmul double %172, %174
  %176 = fcmp ugt double %175, %13
  %177 = select i1 %176, i32 %157, i32 1
  %178 = shl nsw i64 %158, 4
  %179 = getelementptr inbounds i8, ptr %27, i64 %178
  store i64 %171, ptr %179, align 8
  %180 = icmp eq i64 %171, %158
  br i1 %180, label %217, label %181

181:                                              ; preds = %170
  %182 = mul nsw i64 %171, %4
  br label %205

183:                                              ; preds = %156, %183
  %184 = phi i64 [ %199, %183 ], [ %168, %156 ]
  %185 = phi double [ %198, %183 ], [ %167, %156 ]
  %186 = phi i64 [ %197, %183 ], [ %158, %156 ]
  %187 = mul nuw nsw i64 %184, %4
  %188 = add nuw nsw i64 %187, %158
  %189 = shl nsw i64 %188, 4
  %190 = getelementptr inbounds i8, ptr %26, i64 %189
  %191 = load double, ptr %190, align 8
  %192 = tail call double @llvm.fabs.f64(double %191)
  %193 = getelementptr inbounds double, ptr %2, i64 %184
  %194 = load double, ptr %193, align 8
  %195 = fmul double %192, %194
  %196 = fcmp ogt double %195, %185
  %197 = select i1 %196, i64 %184, i64 %186
  %198 = select i1 %196, double %195, double %185
  %199 = add nuw nsw i64 %184, 1
  %200 = icmp slt i64 %199, %4
  br i1 %200, label %183, label %170, !llvm.loop !15

201:                                              ; preds = %205
  %202 = load double, ptr %165, align 8
  %203 = getelementptr inbounds double, ptr %2, i64 %171
  %204 = load double, ptr %203, align 8
  store double %204, ptr %165, align 8
  store double %202, ptr %203, align 8
  br label %217

205:                                              ; preds = %205, %181
  %206 = phi i64 [ 0, %181 ], [ %215, %205 ]
  %207 = add nuw nsw i64 %206, %159
  %208 = shl nsw i64 %207, 4
  %209 = getelementptr inbounds i8, ptr %26, i64 %208
  %210 = load double, ptr %209, align 8
  %211 = add nsw i64 %206, %182
  %212 = shl nsw i64 %211, 4
  %213 = getelementptr inbounds i8, ptr %26, i64 %212
  %214 = load double, ptr %213, align 8
  store double %214, ptr %209, align 8
  store double %210, ptr %213, align 8
  %215 = add nuw nsw i64 %206, 1
  %216 = icmp eq i64 %215, %4
  br i1 %216, label %201, label %205, !llvm.loop !16

217:                                              ; preds = %201, %170
  %218 = load double, ptr %162, align 8
  %219 = fdiv double 1.000000e+00, %218
  br i1 %169, label %220, label %151

220:                                              ; preds = %217, %229
  %221 = phi i64 [ %230, %229 ], [ %168, %217 ]
  %222 = mul nuw nsw i64 %221, %4
  %223 = add nuw nsw i64 %222, %158
  %224 = shl nsw i64 %223, 4
  %225 = getelementptr inbounds i8, ptr %26, i64 %224
  %226 = load double, ptr %225, align 8
  %227 = fmul double %219, %226
  store double %227, ptr %225, align 8
  %228 = fneg double %227
  br label %232

229:                                              ; preds = %232
  %230 = add nuw nsw i64 %221, 1
  %231 = icmp slt i64 %230, %4
  br i1 %231, label %220, label %151, !llvm.loop !17

232:                                              ; preds = %232, %220
  %233 = phi i64 [ %168, %220 ], [ %243, %232 ]
  %234 = add nuw nsw i64 %233, %159
  %235 = shl nsw i64 %234, 4
  %236 = getelementptr inbounds i8, ptr %26, i64 %235
  %237 = load double, ptr %236, align 8
  %238 = add nuw nsw i64 %233, %222
  %239 = shl nsw i64 %238, 4
  %240 = getelementptr inbounds i8, ptr %26, i64 %239
  %241 = load double, ptr %240, align 8
  %242 = tail call double @llvm.fma.f64(double %228, double %237, double %241)
  store double %242, ptr %240, align 8
  %243 = add nuw nsw i64 %233, 1
  %244 = icmp slt i64 %243, %4
  br i1 %244, label %232, label %229, !llvm.loop !18

245:                                              ; preds = %153
  %246 = getelementptr i8, ptr %26, i64 %16
  %247 = getelementptr i8, ptr %246, i64 -16
  store double 0x7FF8000000000000, ptr %247, align 8
  br label %248

248:                                              ; preds = %153, %245
  %249 = trunc nuw nsw i64 %19 to i32
  %250 = shl nuw nsw i32 %154, %249
  %251 = or i32 %250, %20
  br label %252

252:                                              ; preds = %78, %51, %30, %28, %18, %248
  %253 = phi i32 [ %251, %248 ], [ %20, %18 ], [ %20, %28 ], [ %20, %30 ], [ %20, %51 ], [ %20, %78 ]
  %254 = add nuw nsw i64 %19, 1
  %255 = icmp eq i64 %19, 0
  br i1 %255, label %18, label %17, !llvm.loop !19
}

define range(i32 0, 4) i32 @pydy_constrained_2(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, i64 noundef %4, i64 noundef %5, i32 noundef %6) #0 {
  %8 = icmp sgt i64 %4, 0
  %9 = icmp sgt i64 %5, 0
  %10 = icmp eq i64 %5, 0
  %11 = shl i64 %5, 4
  %12 = add i64 %11, 16
  %13 = sitofp i64 %5 to double
  %14 = fmul double %13, 0x3CB0000000000000
  %15 = shl i64 %5, 4
  %16 = add i64 %15, 16
  %17 = getelementptr double, ptr %2, i64 %5
  br label %19

18:                                               ; preds = %340
  ret i32 %341

19:                                               ; preds = %7, %340
  %20 = phi i64 [ 0, %7 ], [ %342, %340 ]
  %21 = phi i32 [ 0, %7 ], [ %341, %340 ]
  %22 = trunc nuw nsw i64 %20 to i32
  %23 = shl nuw nsw i32 1, %22
  %24 = and i32 %23, %6
  %25 = icmp eq i32 %24, 0
  br i1 %25, label %340, label %26

26:                                               ; preds = %19
  %27 = getelementptr inbounds double, ptr %0, i64 %20
  %28 = getelementptr inbounds i64, ptr %1, i64 %20
  %29 = getelementptr inbounds double, ptr %3, i64 %20
  br i1 %8, label %32, label %30

30:                                               ; preds = %32, %26
  %31 = phi double [ 0.000000e+00, %26 ], [ %39, %32 ]
  br i1 %9, label %45, label %42

32:                                               ; preds = %26, %32
  %33 = phi double [ %39, %32 ], [ 0.000000e+00, %26 ]
  %34 = phi i64 [ %40, %32 ], [ 0, %26 ]
  %35 = shl nsw i64 %34, 4
  %36 = getelementptr inbounds i8, ptr %29, i64 %35
  %37 = load double, ptr %36, align 8
  %38 = fmul double %37, 0.000000e+00
  %39 = fadd double %33, %38
  %40 = add nuw nsw i64 %34, 1
  %41 = icmp eq i64 %40, %4
  br i1 %41, label %30, label %32, !llvm.loop !20

42:                                               ; preds = %51, %30
  %43 = phi double [ 0.000000e+00, %30 ], [ %62, %51 ]
  %44 = getelementptr i8, ptr %27, i64 -16
  br i1 %10, label %85, label %65

45:                                               ; preds = %30, %51
  %46 = phi double [ %62, %51 ], [ 0.000000e+00, %30 ]
  %47 = phi i64 [ %52, %51 ], [ 0, %30 ]
  %48 = shl nsw i64 %47, 4
  %49 = getelementptr inbounds i8, ptr %28, i64 %48
  store i64 -1, ptr %49, align 8
  %50 = mul nuw nsw i64 %47, %5
  br label %54

51:                                               ; preds = %54
  %52 = add nuw nsw i64 %47, 1
  %53 = icmp eq i64 %52, %5
  br i1 %53, label %42, label %45, !llvm.loop !21

54:                                               ; preds = %54, %45
  %55 = phi double [ %46, %45 ], [ %62, %54 ]
  %56 = phi i64 [ 0, %45 ], [ %63, %54 ]
  %57 = add nuw nsw i64 %56, %50
  %58 = shl nsw i64 %57, 4
  %59 = getelementptr inbounds i8, ptr %27, i64 %58
  %60 = load double, ptr %59, align 8
  %61 = fmul double %60, 0.000000e+00
  %62 = fadd double %55, %61
  %63 = add nuw nsw i64 %56, 1
  %64 = icmp eq i64 %63, %5
  br i1 %64, label %51, label %54, !llvm.loop !22

65:                                               ; preds = %42, %82
  %66 = phi i64 [ %83, %82 ], [ %5, %42 ]
  %67 = phi i64 [ %81, %82 ], [ 0, %42 ]
  %68 = add i64 %66, 1152921504606846975
  %69 = mul i64 %68, %5
  %70 = add i64 %69, %66
  %71 = shl i64 %70, 4
  %72 = getelementptr i8, ptr %44, i64 %71
  %73 = load double, ptr %72, align 8
  %74 = fcmp oeq double %73, 0xC770000000000000
  %75 = fcmp oeq double %73, 0xC780000000000000
  %76 = or i1 %74, %75
  br i1 %76, label %77, label %80

77:                                               ; preds = %65
  %78 = zext i1 %74 to i64
  %79 = add nsw i64 %67, %78
  store double 0.000000e+00, ptr %72, align 8
  br label %80

80:                                               ; preds = %77, %65
  %81 = phi i64 [ %79, %77 ], [ %67, %65 ]
  br i1 %76, label %82, label %85

82:                                               ; preds = %80
  %83 = add nsw i64 %66, -1
  %84 = icmp eq i64 %83, 0
  br i1 %84, label %85, label %65, !llvm.loop !23

85:                                               ; preds = %82, %80, %42
  %86 = phi i64 [ %5, %42 ], [ 0, %82 ], [ %66, %80 ]
  %87 = phi i64 [ 0, %42 ], [ %81, %80 ], [ %81, %82 ]
  %88 = icmp sgt i64 %86, 0
  br i1 %88, label %89, label %282

89:                                               ; preds = %85
  %90 = icmp slt i64 %86, %5
  br label %94

91:                                               ; preds = %123
  br i1 %88, label %92, label %282

92:                                               ; preds = %91
  %93 = icmp slt i64 %86, %5
  br label %128

94:                                               ; preds = %123, %89
  %95 = phi i64 [ 0, %89 ], [ %126, %123 ]
  %96 = mul i64 %95, %12
  %97 = getelementptr inbounds i8, ptr %27, i64 %96
  %98 = load double, ptr %97, align 8
  br i1 %90, label %102, label %99

99:                                               ; preds = %102, %94
  %100 = phi double [ 0.000000e+00, %94 ], [ %112, %102 ]
  %101 = fcmp ogt double %98, 0.000000e+00
  br i1 %101, label %115, label %118

102:                                              ; preds = %94, %102
  %103 = phi i64 [ %113, %102 ], [ %86, %94 ]
  %104 = phi double [ %112, %102 ], [ 0.000000e+00, %94 ]
  %105 = mul nsw i64 %103, %5
  %106 = add nsw i64 %105, %95
  %107 = shl nsw i64 %106, 4
  %108 = getelementptr inbounds i8, ptr %27, i64 %107
  %109 = load double, ptr %108, align 8
  %110 = tail call double @llvm.fabs.f64(double %109)
  %111 = fcmp ogt double %110, %104
  %112 = select i1 %111, double %110, double %104
  %113 = add nuw nsw i64 %103, 1
  %114 = icmp eq i64 %113, %5
  br i1 %114, label %99, label %102, !llvm.loop !24

115:                                              ; preds = %99
  %116 = tail call double @llvm.sqrt.f64(double %98)
  %117 = fdiv double 1.000000e+00, %116
  br label %123

118:                                              ; preds = %99
  %119 = fcmp ogt double %100, 0.000000e+00
  %120 = fmul double %100, 0x3CB0000000000000
  %121 = fdiv double 1.000000e+00, %120
  %122 = select i1 %119, double %121, double 0x4330000000000000
  br label %123

123:                                              ; preds = %118, %115
  %124 = phi double [ %117, %115 ], [ %122, %118 ]
  %125 = getelementptr inbounds double, ptr %2, i64 %95
  store double %124, ptr %125, align 8
  %126 = add nuw nsw i64 %95, 1
  %127 = icmp eq i64 %126, %86
  br i1 %127, label %91, label %94, !llvm.loop !25

128:                                              ; preds = %276, %92
  %129 = phi i64 [ %87, %92 ], [ %209, %276 ]
  %130 = phi i32 [ 0, %92 ], [ %278, %276 ]
  %131 = phi double [ %43, %92 ], [ %277, %276 ]
  %132 = phi i64 [ 0, %92 ], [ %279, %276 ]
  %133 = icmp ne i64 %129, 0
  %134 = and i1 %93, %133
  br i1 %134, label %135, label %145

135:                                              ; preds = %128, %173
  %136 = phi i64 [ %177, %173 ], [ %86, %128 ]
  %137 = phi i64 [ %176, %173 ], [ -1, %128 ]
  %138 = phi i64 [ %175, %173 ], [ -1, %128 ]
  %139 = phi double [ %174, %173 ], [ %13, %128 ]
  %140 = shl nsw i64 %136, 4
  %141 = getelementptr inbounds i8, ptr %28, i64 %140
  %142 = load i64, ptr %141, align 8
  %143 = icmp slt i64 %142, 0
  %144 = mul nsw i64 %136, %5
  br i1 %143, label %149, label %173

145:                                              ; preds = %173, %128
  %146 = phi i64 [ -1, %128 ], [ %175, %173 ]
  %147 = phi i64 [ -1, %128 ], [ %176, %173 ]
  %148 = icmp slt i64 %146, 0
  br i1 %148, label %180, label %204

149:                                              ; preds = %135, %149
  %150 = phi i64 [ %171, %149 ], [ 0, %135 ]
  %151 = phi i64 [ %170, %149 ], [ %137, %135 ]
  %152 = phi i64 [ %169, %149 ], [ %138, %135 ]
  %153 = phi double [ %168, %149 ], [ %139, %135 ]
  %154 = add nsw i64 %150, %144
  %155 = shl nsw i64 %154, 4
  %156 = getelementptr inbounds i8, ptr %27, i64 %155
  %157 = load double, ptr %156, align 8
  %158 = tail call double @llvm.fabs.f64(double %157)
  %159 = getelementptr inbounds double, ptr %2, i64 %150
  %160 = load double, ptr %159, align 8
  %161 = fmul double %158, %160
  %162 = shl nsw i64 %150, 4
  %163 = getelementptr inbounds i8, ptr %28, i64 %162
  %164 = load i64, ptr %163, align 8
  %165 = icmp slt i64 %164, 0
  %166 = fcmp ogt double %161, %153
  %167 = select i1 %165, i1 %166, i1 false
  %168 = select i1 %167, double %161, double %153
  %169 = select i1 %167, i64 %136, i64 %152
  %170 = select i1 %167, i64 %150, i64 %151
  %171 = add nuw nsw i64 %150, 1
  %172 = icmp eq i64 %171, %86
  br i1 %172, label %173, label %149, !llvm.loop !26

173:                                              ; preds = %149, %135
  %174 = phi double [ %139, %135 ], [ %168, %149 ]
  %175 = phi i64 [ %138, %135 ], [ %169, %149 ]
  %176 = phi i64 [ %137, %135 ], [ %170, %149 ]
  %177 = add nuw nsw i64 %136, 1
  %178 = icmp slt i64 %177, %5
  %179 = select i1 %133, i1 %178, i1 false
  br i1 %179, label %135, label %145, !llvm.loop !27

180:                                              ; preds = %145, %180
  %181 = phi i64 [ %202, %180 ], [ 0, %145 ]
  %182 = phi i64 [ %201, %180 ], [ %147, %145 ]
  %183 = phi i64 [ %200, %180 ], [ %146, %145 ]
  %184 = phi double [ %199, %180 ], [ %14, %145 ]
  %185 = mul i64 %181, %16
  %186 = getelementptr inbounds i8, ptr %27, i64 %185
  %187 = load double, ptr %186, align 8
  %188 = tail call double @llvm.fabs.f64(double %187)
  %189 = getelementptr inbounds double, ptr %2, i64 %181
  %190 = load double, ptr %189, align 8
  %191 = fmul double %188, %190
  %192 = fmul double %190, %191
  %193 = shl nsw i64 %181, 4
  %194 = getelementptr inbounds i8, ptr %28, i64 %193
  %195 = load i64, ptr %194, align 8
  %196 = icmp slt i64 %195, 0
  %197 = fcmp ogt double %192, %184
  %198 = select i1 %196, i1 %197, i1 false
  %199 = select i1 %198, double %192, double %184
  %200 = select i1 %198, i64 %181, i64 %183
  %201 = select i1 %198, i64 %181, i64 %182
  %202 = add nuw nsw i64 %181, 1
  %203 = icmp eq i64 %202, %86
  br i1 %203, label %206, label %180, !llvm.loop !28

204:                                              ; preds = %145
  %205 = add nsw i64 %129, -1
  br label %206

206:                                              ; preds = %180, %204
  %207 = phi i64 [ %146, %204 ], [ %200, %180 ]
  %208 = phi i64 [ %147, %204 ], [ %201, %180 ]
  %209 = phi i64 [ %205, %204 ], [ 0, %180 ]
  %210 = icmp slt i64 %207, 0
  br i1 %210, label %213, label %211

211:                                              ; preds = %206
  %212 = icmp ne i64 %207, %208
  br label %217

213:                                              ; preds = %206
  %214 = fadd double %31, %131
  %215 = fcmp oeq double %214, 0.000000e+00
  %216 = zext i1 %215 to i32
  br label %276

217:                                              ; preds = %228, %211
  %218 = phi i32 [ 0, %211 ], [ %231, %228 ]
  %219 = icmp eq i32 %218, 0
  %220 = select i1 %219, i64 %207, i64 %208
  %221 = select i1 %219, i64 %208, i64 %207
  %222 = mul nsw i64 %220, %5
  %223 = add nsw i64 %222, %221
  %224 = shl nsw i64 %223, 4
  %225 = getelementptr inbounds i8, ptr %27, i64 %224
  %226 = load double, ptr %225, align 8
  %227 = fdiv double 1.000000e+00, %226
  br i1 %9, label %233, label %228

228:                                              ; preds = %273, %217
  %229 = shl nsw i64 %220, 4
  %230 = getelementptr inbounds i8, ptr %28, i64 %229
  store i64 %221, ptr %230, align 8
  %231 = add nuw nsw i32 %218, 1
  %232 = and i1 %212, %219
  br i1 %232, label %217, label %276, !llvm.loop !29

233:                                              ; preds = %217, %273
  %234 = phi i64 [ %274, %273 ], [ 0, %217 ]
  %235 = mul nuw nsw i64 %234, %5
  %236 = add nsw i64 %235, %221
  %237 = shl nsw i64 %236, 4
  %238 = getelementptr inbounds i8, ptr %27, i64 %237
  %239 = load double, ptr %238, align 8
  %240 = fmul double %227, %239
  %241 = icmp eq i64 %234, %220
  %242 = fcmp oeq double %240, 0.000000e+00
  %243 = select i1 %241, i1 true, i1 %242
  br i1 %243, label %273, label %244

244:                                              ; preds = %233
  %245 = fneg double %240
  br label %247

246:                                              ; preds = %247
  br i1 %8, label %260, label %273

247:                                              ; preds = %247, %244
  %248 = phi i64 [ 0, %244 ], [ %258, %247 ]
  %249 = add nsw i64 %248, %222
  %250 = shl nsw i64 %249, 4
  %251 = getelementptr inbounds i8, ptr %27, i64 %250
  %252 = load double, ptr %251, align 8
  %253 = add nuw nsw i64 %248, %235
  %254 = shl nsw i64 %253, 4
  %255 = getelementptr inbounds i8, ptr %27, i64 %254
  %256 = load double, ptr %255, align 8
  %257 = tail call double @llvm.fma.f64(double %245, double %252, double %256)
  store double %257, ptr %255, align 8
  %258 = add nuw nsw i64 %248, 1
  %259 = icmp eq i64 %258, %5
  br i1 %259, label %246, label %247, !llvm.loop !30

260:                                              ; preds = %246, %260
  %261 = phi i64 [ %271, %260 ], [ 0, %246 ]
  %262 = add nsw i64 %261, %220
  %263 = shl nsw i64 %262, 4
  %264 = getelementptr inbounds i8, ptr %29, i64 %263
  %265 = load double, ptr %264, align 8
  %266 = add nuw nsw i64 %261, %234
  %267 = shl nsw i64 %266, 4
  %268 = getelementptr inbounds i8, ptr %29, i64 %267
  %269 = load double, ptr %268, align 8
  %270 = tail call double @llvm.fma.f64(double %245, double %265, double %269)
  store double %270, ptr %268, align 8
  %271 = add nuw nsw i64 %261, %5
  %272 = icmp slt i64 %271, %4
  br i1 %272, label %260, label %273, !llvm.loop !31

273:                                              ; preds = %260, %246, %233
  %274 = add nuw nsw i64 %234, 1
  %275 = icmp eq i64 %274, %5
  br i1 %275, label %228, label %233, !llvm.loop !32

276:                                              ; preds = %228, %213
  %277 = phi double [ 0x7FF8000000000000, %213 ], [ %131, %228 ]
  %278 = phi i32 [ %216, %213 ], [ %130, %228 ]
  %279 = add nuw nsw i64 %132, 1
  %280 = icmp eq i64 %279, %86
  %281 = select i1 %210, i1 true, i1 %280
  br i1 %281, label %282, label %128, !llvm.loop !33

282:                                              ; preds = %276, %85, %91
  %283 = phi double [ %43, %91 ], [ %43, %85 ], [ %277, %276 ]
  %284 = phi i32 [ 0, %91 ], [ 0, %85 ], [ %278, %276 ]
  br i1 %8, label %285, label %336

285:                                              ; preds = %282, %323
  %286 = phi i64 [ %324, %323 ], [ 0, %282 ]
  br i1 %9, label %289, label %287

287:                                              ; preds = %289, %285
  %288 = phi double [ %283, %285 ], [ %297, %289 ]
  br i1 %9, label %302, label %323

289:                                              ; preds = %285, %289
  %290 = phi i64 [ %299, %289 ], [ 0, %285 ]
  %291 = phi double [ %297, %289 ], [ %283, %285 ]
  %292 = add nsw i64 %290, %286
  %293 = shl nsw i64 %292, 4
  %294 = getelementptr inbounds i8, ptr %29, i64 %293
  %295 = load double, ptr %294, align 8
  %296 = fmul double %295, 0.000000e+00
  %297 = fadd double %291, %296
  %298 = getelementptr double, ptr %17, i64 %290
  store double 0.000000e+00, ptr %298, align 8
  %299 = add nuw nsw i64 %290, 1
  %300 = icmp eq i64 %299, %5
  br i1 %300, label %287, label %289, !llvm.loop !34

301:                                              ; preds = %320
  br i1 %9, label %326, label %323

302:                                              ; preds = %287, %320
  %303 = phi i64 [ %321, %320 ], [ 0, %287 ]
  %304 = shl nsw i64 %303, 4
  %305 = getelementptr inbounds i8, ptr %28, i64 %304
  %306 = load i64, ptr %305, align 8
  %307 = icmp sgt i64 %306, -1
  br i1 %307, label %308, label %320

308:                                              ; preds = %302
  %309 = add nsw i64 %303, %286
  %310 = shl nsw i64 %309, 4
  %311 = getelementptr inbounds i8, ptr %29, i64 %310
  %312 = load double, ptr %311, align 8
  %313 = mul nuw nsw i64 %303, %5
  %314 = add nuw nsw i64 %306, %313
  %315 = shl nsw i64 %314, 4
  %316 = getelementptr inbounds i8, ptr %27, i64 %315
  %317 = load double, ptr %316, align 8
  %318 = fdiv double %312, %317
  %319 = getelementptr double, ptr %17, i64 %306
  store double %318, ptr %319, align 8
  br label %320

320:                                              ; preds = %308, %302
  %321 = add nuw nsw i64 %303, 1
  %322 = icmp eq i64 %321, %5
  br i1 %322, label %301, label %302, !llvm.loop !35

323:                                              ; preds = %326, %287, %301
  %324 = add nsw i64 %286, %5
  %325 = icmp slt i64 %324, %4
  br i1 %325, label %285, label %336, !llvm.loop !36

326:                                              ; preds = %301, %326
  %327 = phi i64 [ %334, %326 ], [ 0, %301 ]
  %328 = getelementptr double, ptr %17, i64 %327
  %329 = load double, ptr %328, align 8
  %330 = fadd double %288, %329
  %331 = add nsw i64 %327, %286
  %332 = shl nsw i64 %331, 4
  %333 = getelementptr inbounds i8, ptr %29, i64 %332
  store double %330, ptr %333, align 8
  %334 = add nuw nsw i64 %327, 1
  %335 = icmp eq i64 %334, %5
  br i1 %335, label %323, label %326, !llvm.loop !37

336:                                              ; preds = %323, %282
  %337 = trunc nuw nsw i64 %20 to i32
  %338 = shl nuw nsw i32 %284, %337
  %339 = or i32 %338, %21
  br label %340

340:                                              ; preds = %19, %336
  %341 = phi i32 [ %339, %336 ], [ %21, %19 ]
  %342 = add nuw nsw i64 %20, 1
  %343 = icmp eq i64 %20, 0
  br i1 %343, label %19, label %18, !llvm.loop !38
}

define range(i32 0, 4) i32 @pydy_ldl_factor_2(ptr noundef %0, ptr noundef %1, i64 noundef %2) #1 {
  %4 = sitofp i64 %2 to double
  %5 = fmul double %4, 0x3CB0000000000000
  %6 = insertelement <2 x double> poison, double %5, i64 0
  %7 = shufflevector <2 x double> %6, <2 x double> poison, <2 x i32> zeroinitializer
  %8 = icmp sgt i64 %2, 0
  br i1 %8, label %9, label %11

9:                                                ; preds = %3
  %10 = add nuw i64 %2, 1
  br label %13

11:                                               ; preds = %13, %3
  %12 = icmp sgt i64 %2, 0
  br i1 %12, label %32, label %26

13:                                               ; preds = %9, %13
  %14 = phi i64 [ 0, %9 ], [ %20, %13 ]
  %15 = mul i64 %14, %10
  %16 = getelementptr inbounds <2 x double>, ptr %0, i64 %15
  %17 = load <2 x double>, ptr %16, align 8
  %18 = fmul <2 x double> %7, %17
  %19 = getelementptr inbounds <2 x double>, ptr %1, i64 %14
  store <2 x double> %18, ptr %19, align 8
  %20 = add nuw nsw i64 %14, 1
  %21 = icmp eq i64 %20, %2
  br i1 %21, label %11, label %13, !llvm.loop !39

22:                                               ; preds = %55, %32
  %23 = icmp eq i64 %44, %2
  br i1 %23, label %24, label %32, !llvm.loop !40

24:                                               ; preds = %22
  %25 = icmp ne <2 x i64> %42, zeroinitializer
  br label %26

26:                                               ; preds = %24, %11
  %27 = phi <2 x i1> [ zeroinitializer, %11 ], [ %25, %24 ]
  %28 = shufflevector <2 x i1> %27, <2 x i1> poison, <8 x i32> <i32 0, i32 1, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison, i32 poison>
  %29 = bitcast <8 x i1> %28 to i8
  %30 = and i8 %29, 3
  %31 = zext nneg i8 %30 to i32
  ret i32 %31

32:                                               ; preds = %11, %22
  %33 = phi <2 x i64> [ %42, %22 ], [ zeroinitializer, %11 ]
  %34 = phi i64 [ %44, %22 ], [ 0, %11 ]
  %35 = mul nuw nsw i64 %34, %2
  %36 = getelementptr <2 x double>, ptr %0, i64 %35
  %37 = getelementptr <2 x double>, ptr %36, i64 %34
  %38 = load <2 x double>, ptr %37, align 8
  %39 = getelementptr inbounds <2 x double>, ptr %1, i64 %34
  %40 = load <2 x double>, ptr %39, align 8
  %41 = fcmp ule <2 x double> %38, %40
  %42 = select <2 x i1> %41, <2 x i64> <i64 -1, i64 -1>, <2 x i64> %33
  %43 = fdiv <2 x double> <double 1.000000e+00, double 1.000000e+00>, %38
  store <2 x double> %43, ptr %39, align 8
  %44 = add nuw nsw i64 %34, 1
  %45 = icmp slt i64 %44, %2
  br i1 %45, label %46, label %22

46:                                               ; preds = %32, %55
  %47 = phi i64 [ %56, %55 ], [ %44, %32 ]
  %48 = getelementptr inbounds <2 x double>, ptr %36, i64 %47
  %49 = load <2 x double>, ptr %48, align 8
  %50 = load <2 x double>, ptr %39, align 8
  %51 = fneg <2 x double> %49
  %52 = fmul <2 x double> %50, %51
  %53 = mul nuw nsw i64 %47, %2
  %54 = getelementptr <2 x double>, ptr %0, i64 %53
  br label %58

55:                                               ; preds = %58
  %56 = add nuw nsw i64 %47, 1
  %57 = icmp slt i64 %56, %2
  br i1 %57, label %46, label %22, !llvm.loop !41

58:                                               ; preds = %46, %58
  %59 = phi i64 [ %47, %46 ], [ %65, %58 ]
  %60 = getelementptr inbounds <2 x double>, ptr %36, i64 %59
  %61 = load <2 x double>, ptr %60, align 8
  %62 = getelementptr <2 x double>, ptr %54, i64 %59
  %63 = load <2 x double>, ptr %62, align 8
  %64 = tail call <2 x double> @llvm.fma.v2f64(<2 x double> %52, <2 x double> %61, <2 x double> %63)
  store <2 x double> %64, ptr %62, align 8
  %65 = add nuw nsw i64 %59, 1
  %66 = icmp slt i64 %65, %2
  br i1 %66, label %58, label %55, !llvm.loop !42
}

declare <2 x double> @llvm.fma.v2f64(<2 x double>, <2 x double>, <2 x double>) #2

define void @pydy_ldl_solve_2(ptr noundef readonly %0, ptr noundef readonly %1, ptr noundef %2, i64 noundef %3) #0 {
  %5 = icmp sgt i64 %3, 0
  br i1 %5, label %8, label %6

6:                                                ; preds = %20, %4
  %7 = icmp sgt i64 %3, 0
  br i1 %7, label %32, label %39

8:                                                ; preds = %4, %20
  %9 = phi i64 [ %15, %20 ], [ 0, %4 ]
  %10 = getelementptr inbounds <2 x double>, ptr %2, i64 %9
  %11 = load <2 x double>, ptr %10, align 8
  %12 = getelementptr inbounds <2 x double>, ptr %1, i64 %9
  %13 = load <2 x double>, ptr %12, align 8
  %14 = fmul <2 x double> %11, %13
  %15 = add nuw nsw i64 %9, 1
  %16 = icmp slt i64 %15, %3
  br i1 %16, label %17, label %20

17:                                               ; preds = %8
  %18 = mul nuw nsw i64 %9, %3
  %19 = getelementptr <2 x double>, ptr %0, i64 %18
  br label %22

20:                                               ; preds = %22, %8
  store <2 x double> %14, ptr %10, align 8
  %21 = icmp eq i64 %15, %3
  br i1 %21, label %6, label %8, !llvm.loop !43

22:                                               ; preds = %17, %22
  %23 = phi i64 [ %15, %17 ], [ %30, %22 ]
  %24 = getelementptr <2 x double>, ptr %19, i64 %23
  %25 = load <2 x double>, ptr %24, align 8
  %26 = fneg <2 x double> %25
  %27 = getelementptr inbounds <2 x double>, ptr %2, i64 %23
  %28 = load <2 x double>, ptr %27, align 8
  %29 = tail call <2 x double> @llvm.fma.v2f64(<2 x double> %26, <2 x double> %14, <2 x double> %28)
  store <2 x double> %29, ptr %27, align 8
  %30 = add nuw nsw i64 %23, 1
  %31 = icmp slt i64 %30, %3
  br i1 %31, label %22, label %20, !llvm.loop !44

32:                                               ; preds = %6, %40
  %33 = phi i64 [ %34, %40 ], [ %3, %6 ]
  %34 = add nsw i64 %33, -1
  %35 = icmp slt i64 %33, %3
  br i1 %35, label %36, label %40

36:                                               ; preds = %32
  %37 = mul nsw i64 %34, %3
  %38 = getelementptr <2 x double>, ptr %0, i64 %37
  br label %49

39:                                               ; preds = %40, %6
  ret void

40:                                               ; preds = %49, %32
  %41 = phi <2 x double> [ zeroinitializer, %32 ], [ %57, %49 ]
  %42 = getelementptr inbounds <2 x double>, ptr %1, i64 %34
  %43 = load <2 x double>, ptr %42, align 8
  %44 = fmul <2 x double> %41, %43
  %45 = getelementptr inbounds <2 x double>, ptr %2, i64 %34
  %46 = load <2 x double>, ptr %45, align 8
  %47 = fadd <2 x double> %46, %44
  store <2 x double> %47, ptr %45, align 8
  %48 = icmp sgt i64 %33, 1
  br i1 %48, label %32, label %39, !llvm.loop !45

49:                                               ; preds = %36, %49
  %50 = phi i64 [ %33, %36 ], [ %58, %49 ]
  %51 = phi <2 x double> [ zeroinitializer, %36 ], [ %57, %49 ]
  %52 = getelementptr <2 x double>, ptr %38, i64 %50
  %53 = load <2 x double>, ptr %52, align 8
  %54 = fneg <2 x double> %53
  %55 = getelementptr inbounds <2 x double>, ptr %2, i64 %50
  %56 = load <2 x double>, ptr %55, align 8
  %57 = tail call <2 x double> @llvm.fma.v2f64(<2 x double> %54, <2 x double> %56, <2 x double> %51)
  %58 = add nuw nsw i64 %50, 1
  %59 = icmp eq i64 %58, %3
  br i1 %59, label %40, label %49, !llvm.loop !46
}

define range(i32 0, 4) i32 @pydy_guard_2(ptr noundef readonly %0, ptr noundef %1, i64 noundef %2, ptr noundef %3, i64 noundef %4, i32 noundef %5) #3 {
  %7 = icmp sgt i64 %4, 0
  br i1 %7, label %8, label %15

8:                                                ; preds = %6, %23
  %9 = phi i64 [ %25, %23 ], [ 1, %6 ]
  %10 = phi ptr [ %30, %23 ], [ %0, %6 ]
  %11 = phi i64 [ %24, %23 ], [ 0, %6 ]
  %12 = getelementptr <2 x double>, ptr %3, i64 %11
  %13 = mul nuw nsw i64 %11, %4
  %14 = getelementptr <2 x double>, ptr %3, i64 %13
  br label %27

15:                                               ; preds = %23, %6
  %16 = mul nsw i64 %4, %4
  %17 = getelementptr inbounds <2 x double>, ptr %3, i64 %16
  %18 = getelementptr inbounds <2 x double>, ptr %17, i64 %4
  %19 = tail call i32 @pydy_lu_2(ptr noundef %3, ptr noundef %17, ptr noundef %18, ptr noundef null, i64 noundef %4, i32 noundef %5) #4
  %20 = icmp sgt i64 %2, 0
  br i1 %20, label %21, label %37

21:                                               ; preds = %15
  %22 = shl i64 %4, 4
  br label %38

23:                                               ; preds = %27
  %24 = add nuw nsw i64 %11, 1
  %25 = add nuw i64 %9, 1
  %26 = icmp eq i64 %24, %4
  br i1 %26, label %15, label %8, !llvm.loop !47

27:                                               ; preds = %8, %27
  %28 = phi ptr [ %10, %8 ], [ %30, %27 ]
  %29 = phi i64 [ 0, %8 ], [ %35, %27 ]
  %30 = getelementptr inbounds i8, ptr %28, i64 16
  %31 = load <2 x double>, ptr %28, align 8
  %32 = mul nuw nsw i64 %29, %4
  %33 = getelementptr <2 x double>, ptr %12, i64 %32
  store <2 x double> %31, ptr %33, align 8
  %34 = getelementptr <2 x double>, ptr %14, i64 %29
  store <2 x double> %31, ptr %34, align 8
  %35 = add nuw nsw i64 %29, 1
  %36 = icmp eq i64 %35, %9
  br i1 %36, label %23, label %27, !llvm.loop !48

37:                                               ; preds = %38, %15
  ret i32 %19

38:                                               ; preds = %21, %38
  %39 = phi i64 [ 0, %21 ], [ %43, %38 ]
  %40 = mul i64 %22, %39
  %41 = getelementptr inbounds i8, ptr %1, i64 %40
  %42 = tail call i32 @pydy_lu_2(ptr noundef %3, ptr noundef %17, ptr noundef %18, ptr noundef %41, i64 noundef %4, i32 noundef %5) #4
  %43 = add nuw nsw i64 %39, 1
  %44 = icmp eq i64 %43, %2
  br i1 %44, label %37, label %38, !llvm.loop !49
}

declare double @llvm.fma.f64(double, double, double) #2

declare double @llvm.fabs.f64(double) #2

declare double @llvm.sqrt.f64(double) #2

attributes #0 = { nounwind }
attributes #1 = { nounwind }
attributes #2 = { nounwind willreturn memory(none) }
attributes #3 = { nounwind }
attributes #4 = { nounwind }


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
!47 = distinct !{!47, !4, !5}
!48 = distinct !{!48, !4, !5}
!49 = distinct !{!49, !4, !5}
