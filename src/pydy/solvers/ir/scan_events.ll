; sources b89ee867539b9f8c9aebab528a8e6c769e10a2fcca72f2ac055a5441cf4b57a7
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

@scan_points = internal unnamed_addr constant [5 x double] [double 0.000000e+00, double 0x3FCE3779B97F4A7C, double 0x3FDCC470A0490974, double 0x3FE76CF5D0B09954, double 1.000000e+00], align 16

define i64 @scan_events(ptr noundef %0, double noundef %1, double noundef %2) #0 {
  %4 = alloca %struct.Stepper, align 8
  store ptr %0, ptr %4, align 8
  %5 = getelementptr inbounds i8, ptr %4, i64 8
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %6, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %4, i64 16
  %8 = getelementptr inbounds i8, ptr %0, i64 360
  store ptr %8, ptr %7, align 8
  %9 = getelementptr inbounds i8, ptr %0, i64 768
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 816
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 936
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %0, i64 960
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 624
  %20 = getelementptr inbounds i8, ptr %0, i64 648
  %21 = load ptr, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %21, i64 80
  %23 = load i64, ptr %22, align 8
  %24 = load ptr, ptr %19, align 8
  %25 = getelementptr inbounds i8, ptr %0, i64 984
  %26 = load ptr, ptr %25, align 8
  %27 = shl nsw i64 %12, 4
  %28 = getelementptr inbounds i8, ptr %26, i64 %27
  %29 = mul i64 %12, 88
  %30 = getelementptr inbounds i8, ptr %26, i64 %29
  %31 = getelementptr inbounds double, ptr %26, i64 %12
  %32 = load double, ptr %30, align 8
  %33 = fcmp oeq double %32, %1
  %34 = getelementptr inbounds i8, ptr %0, i64 1032
  %35 = getelementptr inbounds i8, ptr %0, i64 456
  %36 = getelementptr inbounds i8, ptr %0, i64 552
  %37 = getelementptr inbounds i8, ptr %0, i64 368
  %38 = getelementptr inbounds i8, ptr %0, i64 168
  %39 = getelementptr inbounds i8, ptr %0, i64 248
  %40 = getelementptr inbounds i8, ptr %0, i64 168
  %41 = getelementptr inbounds i8, ptr %0, i64 192
  %42 = getelementptr inbounds i8, ptr %0, i64 792
  %43 = zext i1 %33 to i64
  br label %51

44:                                               ; preds = %82
  %45 = add nuw nsw i64 %52, 1
  %46 = icmp eq i64 %45, 5
  br i1 %46, label %47, label %51, !llvm.loop !3

47:                                               ; preds = %44
  %48 = icmp sgt i64 %12, 0
  br i1 %48, label %49, label %106

49:                                               ; preds = %47
  %50 = getelementptr inbounds i8, ptr %0, i64 864
  br label %102

51:                                               ; preds = %3, %44
  %52 = phi i64 [ %43, %3 ], [ %45, %44 ]
  %53 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %52
  %54 = load double, ptr %53, align 8
  %55 = add nuw nsw i64 %52, 2
  %56 = load ptr, ptr %34, align 8
  %57 = load ptr, ptr %35, align 8
  %58 = insertelement <8 x double> poison, double %54, i64 0
  %59 = shufflevector <8 x double> %58, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %59, ptr %57, align 8
  %60 = load ptr, ptr %8, align 8
  %61 = load ptr, ptr %36, align 8
  %62 = load i64, ptr %37, align 8
  %63 = load ptr, ptr %0, align 8
  %64 = getelementptr inbounds i8, ptr %63, i64 24
  %65 = load i64, ptr %64, align 8
  %66 = load ptr, ptr %35, align 8
  %67 = load ptr, ptr %6, align 8
  %68 = getelementptr inbounds i8, ptr %67, i64 16
  %69 = load i64, ptr %68, align 8
  tail call fastcc void @nested(ptr noundef %56, ptr noundef %60, ptr noundef %61, i64 noundef %62, i64 noundef %65, ptr noundef %66, i64 noundef %69) #8
  %70 = fmul double %54, %2
  %71 = fadd double %70, %1
  %72 = load ptr, ptr %38, align 8
  store double %71, ptr %72, align 8
  %73 = load ptr, ptr %6, align 8
  %74 = getelementptr inbounds i8, ptr %73, i64 40
  %75 = load i64, ptr %74, align 8
  %76 = icmp eq i64 %75, 0
  br i1 %76, label %78, label %77

77:                                               ; preds = %51
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %78

78:                                               ; preds = %77, %51
  %79 = load i64, ptr %39, align 8
  %80 = icmp sgt i64 %79, 0
  br i1 %80, label %81, label %82

81:                                               ; preds = %78
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %82

82:                                               ; preds = %78, %81
  %83 = load ptr, ptr %9, align 8
  %84 = load i64, ptr %83, align 8
  %85 = load ptr, ptr %40, align 8
  %86 = load ptr, ptr %34, align 8
  %87 = load ptr, ptr %41, align 8
  %88 = load ptr, ptr %42, align 8
  %89 = load ptr, ptr %25, align 8
  %90 = getelementptr inbounds i8, ptr %83, i64 8
  %91 = load i64, ptr %90, align 8
  %92 = mul nsw i64 %91, %55
  %93 = getelementptr inbounds double, ptr %89, i64 %92
  %94 = inttoptr i64 %84 to ptr
  %95 = load ptr, ptr %94, align 8
  %96 = tail call i32 %95(ptr noundef %85, ptr noundef %86, ptr noundef %87, ptr noundef %88, ptr noundef %93) #9
  %97 = icmp slt i32 %96, 0
  br i1 %97, label %98, label %44

98:                                               ; preds = %82
  %99 = load ptr, ptr %20, align 8
  %100 = getelementptr inbounds i8, ptr %99, i64 80
  store i64 %23, ptr %100, align 8
  %101 = load ptr, ptr %19, align 8
  br label %1127

102:                                              ; preds = %49, %122
  %103 = phi i64 [ 0, %49 ], [ %123, %122 ]
  %104 = load double, ptr %30, align 8
  %105 = fcmp une double %104, %1
  br i1 %105, label %108, label %106

106:                                              ; preds = %102, %122, %47
  %107 = call fastcc i64 @resolve(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2) #8
  switch i64 %107, label %1131 [
    i64 0, label %129
    i64 -4, label %125
  ]

108:                                              ; preds = %102
  %109 = load ptr, ptr %50, align 8
  %110 = getelementptr inbounds i64, ptr %109, i64 %103
  %111 = load i64, ptr %110, align 8
  %112 = and i64 %111, 2
  %113 = icmp eq i64 %112, 0
  br i1 %113, label %122, label %114

114:                                              ; preds = %108
  %115 = getelementptr inbounds double, ptr %28, i64 %103
  %116 = load double, ptr %115, align 8
  %117 = fcmp une double %116, 0.000000e+00
  br i1 %117, label %118, label %122

118:                                              ; preds = %114
  %119 = fcmp ogt double %116, 0.000000e+00
  %120 = select i1 %119, i64 1, i64 -1
  %121 = getelementptr inbounds i64, ptr %16, i64 %103
  store i64 %120, ptr %121, align 8
  br label %122

122:                                              ; preds = %108, %114, %118
  %123 = add nuw nsw i64 %103, 1
  %124 = icmp eq i64 %123, %12
  br i1 %124, label %106, label %102, !llvm.loop !6

125:                                              ; preds = %106
  %126 = load ptr, ptr %20, align 8
  %127 = getelementptr inbounds i8, ptr %126, i64 80
  store i64 %23, ptr %127, align 8
  %128 = load ptr, ptr %19, align 8
  br label %1127

129:                                              ; preds = %106
  store double 0x7FF8000000000000, ptr %30, align 8
  %130 = getelementptr inbounds i8, ptr %0, i64 320
  %131 = load i64, ptr %130, align 8
  %132 = icmp sgt i64 %131, 0
  %133 = select i1 %132, i32 5, i32 4
  %134 = getelementptr inbounds i8, ptr %0, i64 320
  %135 = getelementptr inbounds i8, ptr %0, i64 336
  %136 = getelementptr inbounds i8, ptr %0, i64 1032
  %137 = fadd double %1, %2
  %138 = getelementptr inbounds i8, ptr %0, i64 168
  %139 = getelementptr inbounds i8, ptr %0, i64 248
  %140 = getelementptr inbounds i8, ptr %0, i64 168
  %141 = getelementptr inbounds i8, ptr %0, i64 192
  %142 = getelementptr inbounds i8, ptr %0, i64 792
  %143 = tail call double @llvm.fabs.f64(double %137)
  %144 = tail call double @llvm.fabs.f64(double %1)
  %145 = fcmp ogt double %143, %144
  %146 = select i1 %145, double %143, double %144
  %147 = fmul double %146, 0x3CB0000000000000
  %148 = fdiv double %147, %2
  %149 = fmul double %148, 6.400000e+01
  %150 = fsub double 1.000000e+00, %149
  %151 = fcmp olt double %150, 0.000000e+00
  %152 = select i1 %151, double 0.000000e+00, double %150
  %153 = getelementptr inbounds i8, ptr %0, i64 1032
  %154 = getelementptr inbounds i8, ptr %0, i64 168
  %155 = getelementptr inbounds i8, ptr %0, i64 248
  %156 = getelementptr inbounds i8, ptr %0, i64 168
  %157 = getelementptr inbounds i8, ptr %0, i64 192
  %158 = getelementptr inbounds i8, ptr %0, i64 792
  %159 = icmp sgt i64 %12, 0
  %160 = getelementptr inbounds i8, ptr %0, i64 1032
  %161 = getelementptr inbounds i8, ptr %0, i64 168
  %162 = getelementptr inbounds i8, ptr %0, i64 248
  %163 = getelementptr inbounds i8, ptr %0, i64 168
  %164 = getelementptr inbounds i8, ptr %0, i64 192
  %165 = getelementptr inbounds i8, ptr %0, i64 792
  %166 = icmp sgt i64 %12, 0
  %167 = icmp sgt i64 %12, 0
  %168 = getelementptr inbounds i8, ptr %0, i64 840
  %169 = getelementptr inbounds i8, ptr %24, i64 48
  %170 = getelementptr inbounds i8, ptr %0, i64 672
  %171 = getelementptr inbounds i8, ptr %0, i64 680
  %172 = fadd double %1, %2
  %173 = tail call double @llvm.fabs.f64(double %172)
  %174 = getelementptr inbounds i8, ptr %0, i64 1016
  %175 = getelementptr inbounds i8, ptr %0, i64 1008
  %176 = icmp sgt i64 %12, 0
  %177 = getelementptr inbounds i8, ptr %0, i64 1064
  %178 = getelementptr inbounds i8, ptr %0, i64 1056
  %179 = getelementptr inbounds i8, ptr %0, i64 1080
  %180 = getelementptr inbounds i8, ptr %0, i64 1128
  %181 = getelementptr inbounds i8, ptr %0, i64 1104
  %182 = getelementptr inbounds i8, ptr %0, i64 672
  %183 = getelementptr inbounds i8, ptr %0, i64 680
  %184 = fadd double %1, %2
  %185 = tail call double @llvm.fabs.f64(double %184)
  %186 = getelementptr inbounds i8, ptr %0, i64 1016
  %187 = getelementptr inbounds i8, ptr %0, i64 1008
  %188 = getelementptr inbounds i8, ptr %0, i64 1064
  %189 = getelementptr inbounds i8, ptr %24, i64 48
  %190 = icmp sgt i64 %12, 0
  %191 = getelementptr inbounds i8, ptr %24, i64 48
  %192 = icmp sgt i64 %12, 0
  %193 = getelementptr inbounds i8, ptr %0, i64 1016
  %194 = getelementptr inbounds i8, ptr %0, i64 1008
  br label %195

195:                                              ; preds = %129, %1106
  %196 = phi i1 [ false, %129 ], [ %1110, %1106 ]
  %197 = phi i64 [ -4, %129 ], [ %1104, %1106 ]
  %198 = phi double [ 0.000000e+00, %129 ], [ %1103, %1106 ]
  %199 = phi i32 [ 1, %129 ], [ %1109, %1106 ]
  %200 = tail call i32 @llvm.umin.i32(i32 %199, i32 4)
  %201 = zext nneg i32 %200 to i64
  %202 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %201
  %203 = load double, ptr %202, align 8
  %204 = mul nsw i64 %12, %201
  %205 = getelementptr inbounds double, ptr %28, i64 %204
  %206 = icmp ugt i32 %199, 4
  br i1 %206, label %207, label %257

207:                                              ; preds = %195
  %208 = load i64, ptr %134, align 8
  %209 = icmp sgt i64 %208, 0
  br i1 %209, label %210, label %212

210:                                              ; preds = %207
  %211 = load ptr, ptr %135, align 8
  store double 0x7FF0000000000000, ptr %211, align 8
  br label %212

212:                                              ; preds = %207, %210
  %213 = load ptr, ptr %136, align 8
  %214 = load ptr, ptr %7, align 8
  %215 = getelementptr inbounds i8, ptr %214, i64 96
  %216 = load ptr, ptr %215, align 8
  store <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, ptr %216, align 8
  %217 = load ptr, ptr %214, align 8
  %218 = getelementptr inbounds i8, ptr %214, i64 192
  %219 = load ptr, ptr %218, align 8
  %220 = getelementptr inbounds i8, ptr %214, i64 8
  %221 = load i64, ptr %220, align 8
  %222 = load ptr, ptr %4, align 8
  %223 = load ptr, ptr %222, align 8
  %224 = getelementptr inbounds i8, ptr %223, i64 24
  %225 = load i64, ptr %224, align 8
  %226 = load ptr, ptr %215, align 8
  %227 = load ptr, ptr %5, align 8
  %228 = load ptr, ptr %227, align 8
  %229 = getelementptr inbounds i8, ptr %228, i64 16
  %230 = load i64, ptr %229, align 8
  tail call fastcc void @nested(ptr noundef %213, ptr noundef %217, ptr noundef %219, i64 noundef %221, i64 noundef %225, ptr noundef %226, i64 noundef %230) #8
  %231 = load ptr, ptr %138, align 8
  store double %137, ptr %231, align 8
  %232 = load ptr, ptr %6, align 8
  %233 = getelementptr inbounds i8, ptr %232, i64 40
  %234 = load i64, ptr %233, align 8
  %235 = icmp eq i64 %234, 0
  br i1 %235, label %237, label %236

236:                                              ; preds = %212
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %237

237:                                              ; preds = %236, %212
  %238 = load i64, ptr %139, align 8
  %239 = icmp sgt i64 %238, 0
  br i1 %239, label %240, label %241

240:                                              ; preds = %237
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %241

241:                                              ; preds = %237, %240
  %242 = load ptr, ptr %9, align 8
  %243 = load i64, ptr %242, align 8
  %244 = load ptr, ptr %140, align 8
  %245 = load ptr, ptr %136, align 8
  %246 = load ptr, ptr %141, align 8
  %247 = load ptr, ptr %142, align 8
  %248 = load ptr, ptr %25, align 8
  %249 = getelementptr inbounds i8, ptr %242, i64 8
  %250 = load i64, ptr %249, align 8
  %251 = mul i64 %250, 48
  %252 = getelementptr inbounds i8, ptr %248, i64 %251
  %253 = inttoptr i64 %243 to ptr
  %254 = load ptr, ptr %253, align 8
  %255 = tail call i32 %254(ptr noundef %244, ptr noundef %245, ptr noundef %246, ptr noundef %247, ptr noundef %252) #9
  %256 = icmp slt i32 %255, 0
  br i1 %256, label %1095, label %257

257:                                              ; preds = %241, %195
  %258 = phi double [ %198, %195 ], [ %152, %241 ]
  br i1 %206, label %305, label %259

259:                                              ; preds = %257
  %260 = load ptr, ptr %9, align 8
  %261 = getelementptr inbounds i8, ptr %260, i64 8
  %262 = load i64, ptr %261, align 8
  %263 = icmp sgt i64 %262, 0
  br i1 %263, label %264, label %305

264:                                              ; preds = %259
  %265 = add nsw i32 %199, -1
  %266 = icmp ugt i32 %199, 1
  %267 = select i1 %266, i32 %265, i32 1
  %268 = tail call i32 @llvm.smin.i32(i32 %199, i32 3)
  %269 = icmp sgt i32 %267, %268
  %270 = zext nneg i32 %199 to i64
  %271 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %270
  br label %275

272:                                              ; preds = %302
  %273 = add nuw nsw i64 %277, 1
  %274 = icmp eq i64 %273, %262
  br i1 %274, label %305, label %275, !llvm.loop !7

275:                                              ; preds = %264, %272
  %276 = phi double [ 2.000000e+00, %264 ], [ %304, %272 ]
  %277 = phi i64 [ 0, %264 ], [ %273, %272 ]
  %278 = load ptr, ptr %15, align 8
  %279 = getelementptr inbounds i64, ptr %278, i64 %277
  %280 = load i64, ptr %279, align 8
  %281 = sitofp i64 %280 to double
  br i1 %269, label %302, label %286

282:                                              ; preds = %300
  %283 = add i32 %288, 1
  %284 = icmp sge i32 %288, %268
  %285 = icmp eq i32 %288, %268
  br i1 %285, label %302, label %286, !llvm.loop !8

286:                                              ; preds = %275, %282
  %287 = phi i1 [ %284, %282 ], [ %269, %275 ]
  %288 = phi i32 [ %283, %282 ], [ %267, %275 ]
  %289 = phi double [ %301, %282 ], [ %276, %275 ]
  %290 = call fastcc double @least_place(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, i64 noundef %277, double noundef %281, i32 noundef %288, i32 noundef %199) #8
  %291 = fcmp une double %290, -4.000000e+00
  %292 = fcmp ogt double %290, %258
  %293 = and i1 %291, %292
  br i1 %293, label %294, label %300

294:                                              ; preds = %286
  %295 = load double, ptr %271, align 8
  %296 = fcmp olt double %289, %295
  %297 = select i1 %296, double %289, double %295
  %298 = fcmp olt double %290, %297
  br i1 %298, label %299, label %300

299:                                              ; preds = %294
  br label %300

300:                                              ; preds = %299, %294, %286
  %301 = phi double [ %289, %286 ], [ %290, %299 ], [ %289, %294 ]
  br i1 %291, label %282, label %302

302:                                              ; preds = %282, %300, %275
  %303 = phi i1 [ %269, %275 ], [ %284, %282 ], [ %287, %300 ]
  %304 = phi double [ %276, %275 ], [ %301, %300 ], [ %301, %282 ]
  br i1 %303, label %272, label %305

305:                                              ; preds = %272, %302, %259, %257
  %306 = phi double [ 2.000000e+00, %257 ], [ 2.000000e+00, %259 ], [ -4.000000e+00, %302 ], [ %304, %272 ]
  %307 = fcmp olt double %306, 0.000000e+00
  br i1 %307, label %1095, label %308

308:                                              ; preds = %305
  %309 = fcmp olt double %306, %203
  br i1 %309, label %310, label %356

310:                                              ; preds = %308
  %311 = load ptr, ptr %25, align 8
  %312 = load ptr, ptr %153, align 8
  %313 = load ptr, ptr %7, align 8
  %314 = getelementptr inbounds i8, ptr %313, i64 96
  %315 = load ptr, ptr %314, align 8
  %316 = insertelement <8 x double> poison, double %306, i64 0
  %317 = shufflevector <8 x double> %316, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %317, ptr %315, align 8
  %318 = load ptr, ptr %313, align 8
  %319 = getelementptr inbounds i8, ptr %313, i64 192
  %320 = load ptr, ptr %319, align 8
  %321 = getelementptr inbounds i8, ptr %313, i64 8
  %322 = load i64, ptr %321, align 8
  %323 = load ptr, ptr %4, align 8
  %324 = load ptr, ptr %323, align 8
  %325 = getelementptr inbounds i8, ptr %324, i64 24
  %326 = load i64, ptr %325, align 8
  %327 = load ptr, ptr %314, align 8
  %328 = load ptr, ptr %5, align 8
  %329 = load ptr, ptr %328, align 8
  %330 = getelementptr inbounds i8, ptr %329, i64 16
  %331 = load i64, ptr %330, align 8
  tail call fastcc void @nested(ptr noundef %312, ptr noundef %318, ptr noundef %320, i64 noundef %322, i64 noundef %326, ptr noundef %327, i64 noundef %331) #8
  %332 = fmul double %306, %2
  %333 = fadd double %332, %1
  %334 = load ptr, ptr %154, align 8
  store double %333, ptr %334, align 8
  %335 = load ptr, ptr %6, align 8
  %336 = getelementptr inbounds i8, ptr %335, i64 40
  %337 = load i64, ptr %336, align 8
  %338 = icmp eq i64 %337, 0
  br i1 %338, label %340, label %339

339:                                              ; preds = %310
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %340

340:                                              ; preds = %339, %310
  %341 = load i64, ptr %155, align 8
  %342 = icmp sgt i64 %341, 0
  br i1 %342, label %343, label %344

343:                                              ; preds = %340
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %344

344:                                              ; preds = %340, %343
  %345 = load ptr, ptr %9, align 8
  %346 = load i64, ptr %345, align 8
  %347 = load ptr, ptr %156, align 8
  %348 = load ptr, ptr %153, align 8
  %349 = load ptr, ptr %157, align 8
  %350 = load ptr, ptr %158, align 8
  %351 = load ptr, ptr %25, align 8
  %352 = inttoptr i64 %346 to ptr
  %353 = load ptr, ptr %352, align 8
  %354 = tail call i32 %353(ptr noundef %347, ptr noundef %348, ptr noundef %349, ptr noundef %350, ptr noundef %351) #9
  %355 = icmp slt i32 %354, 0
  br i1 %355, label %1095, label %356

356:                                              ; preds = %344, %308
  %357 = phi double [ %306, %344 ], [ %203, %308 ]
  %358 = phi ptr [ %311, %344 ], [ %205, %308 ]
  %359 = load ptr, ptr %7, align 8
  %360 = getelementptr inbounds i8, ptr %359, i64 96
  %361 = getelementptr inbounds i8, ptr %359, i64 192
  %362 = getelementptr inbounds i8, ptr %359, i64 8
  %363 = load ptr, ptr %4, align 8
  %364 = load ptr, ptr %5, align 8
  br label %365

365:                                              ; preds = %1016, %356
  %366 = phi double [ %258, %356 ], [ %1018, %1016 ]
  %367 = phi i64 [ %197, %356 ], [ %1019, %1016 ]
  br i1 %159, label %372, label %368

368:                                              ; preds = %411, %365
  %369 = phi double [ 2.000000e+00, %365 ], [ %412, %411 ]
  %370 = phi i64 [ -1, %365 ], [ %413, %411 ]
  %371 = fcmp ogt double %369, 1.000000e+00
  br i1 %371, label %1016, label %416

372:                                              ; preds = %365, %411
  %373 = phi i64 [ %414, %411 ], [ 0, %365 ]
  %374 = phi i64 [ %413, %411 ], [ -1, %365 ]
  %375 = phi double [ %412, %411 ], [ 2.000000e+00, %365 ]
  %376 = getelementptr inbounds i64, ptr %18, i64 %373
  store i64 0, ptr %376, align 8
  %377 = getelementptr inbounds i64, ptr %16, i64 %373
  %378 = load i64, ptr %377, align 8
  %379 = getelementptr inbounds double, ptr %358, i64 %373
  %380 = load double, ptr %379, align 8
  %381 = getelementptr inbounds i64, ptr %14, i64 %373
  %382 = load i64, ptr %381, align 8
  %383 = icmp slt i64 %378, 0
  %384 = fcmp ogt double %380, 0.000000e+00
  %385 = and i1 %383, %384
  %386 = icmp sgt i64 %382, -1
  %387 = and i1 %385, %386
  br i1 %387, label %395, label %388

388:                                              ; preds = %372
  %389 = icmp sgt i64 %378, 0
  %390 = fcmp olt double %380, 0.000000e+00
  %391 = and i1 %389, %390
  br i1 %391, label %392, label %395

392:                                              ; preds = %388
  %393 = icmp slt i64 %382, 1
  %394 = zext i1 %393 to i32
  br label %395

395:                                              ; preds = %372, %388, %392
  %396 = phi i32 [ 1, %372 ], [ 0, %388 ], [ %394, %392 ]
  %397 = icmp eq i32 %396, 0
  br i1 %397, label %398, label %402

398:                                              ; preds = %395
  %399 = icmp eq i64 %378, 0
  %400 = fcmp ord double %380, 0.000000e+00
  %401 = or i1 %399, %400
  br i1 %401, label %411, label %402

402:                                              ; preds = %398, %395
  %403 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %366, double noundef %357, i64 noundef %373) #8
  %404 = fcmp oeq double %403, 2.000000e+00
  %405 = fcmp ole double %403, %366
  %406 = zext i1 %405 to i64
  %407 = select i1 %404, i64 -1, i64 %406
  store i64 %407, ptr %376, align 8
  %408 = fcmp olt double %403, %375
  %409 = select i1 %408, double %403, double %375
  %410 = select i1 %408, i64 %373, i64 %374
  br label %411

411:                                              ; preds = %398, %402
  %412 = phi double [ %409, %402 ], [ %375, %398 ]
  %413 = phi i64 [ %410, %402 ], [ %374, %398 ]
  %414 = add nuw nsw i64 %373, 1
  %415 = icmp eq i64 %414, %12
  br i1 %415, label %368, label %372, !llvm.loop !9

416:                                              ; preds = %368
  %417 = load ptr, ptr %160, align 8
  %418 = load ptr, ptr %360, align 8
  %419 = insertelement <8 x double> poison, double %369, i64 0
  %420 = shufflevector <8 x double> %419, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %420, ptr %418, align 8
  %421 = load ptr, ptr %359, align 8
  %422 = load ptr, ptr %361, align 8
  %423 = load i64, ptr %362, align 8
  %424 = load ptr, ptr %363, align 8
  %425 = getelementptr inbounds i8, ptr %424, i64 24
  %426 = load i64, ptr %425, align 8
  %427 = load ptr, ptr %360, align 8
  %428 = load ptr, ptr %364, align 8
  %429 = getelementptr inbounds i8, ptr %428, i64 16
  %430 = load i64, ptr %429, align 8
  tail call fastcc void @nested(ptr noundef %417, ptr noundef %421, ptr noundef %422, i64 noundef %423, i64 noundef %426, ptr noundef %427, i64 noundef %430) #8
  %431 = fmul double %369, %2
  %432 = fadd double %431, %1
  %433 = load ptr, ptr %161, align 8
  store double %432, ptr %433, align 8
  %434 = load ptr, ptr %6, align 8
  %435 = getelementptr inbounds i8, ptr %434, i64 40
  %436 = load i64, ptr %435, align 8
  %437 = icmp eq i64 %436, 0
  br i1 %437, label %439, label %438

438:                                              ; preds = %416
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %439

439:                                              ; preds = %438, %416
  %440 = load i64, ptr %162, align 8
  %441 = icmp sgt i64 %440, 0
  br i1 %441, label %442, label %443

442:                                              ; preds = %439
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %443

443:                                              ; preds = %439, %442
  %444 = load ptr, ptr %9, align 8
  %445 = load i64, ptr %444, align 8
  %446 = load ptr, ptr %163, align 8
  %447 = load ptr, ptr %160, align 8
  %448 = load ptr, ptr %164, align 8
  %449 = load ptr, ptr %165, align 8
  %450 = load ptr, ptr %25, align 8
  %451 = getelementptr inbounds i8, ptr %444, i64 8
  %452 = load i64, ptr %451, align 8
  %453 = getelementptr inbounds double, ptr %450, i64 %452
  %454 = inttoptr i64 %445 to ptr
  %455 = load ptr, ptr %454, align 8
  %456 = tail call i32 %455(ptr noundef %446, ptr noundef %447, ptr noundef %448, ptr noundef %449, ptr noundef %453) #9
  %457 = icmp slt i32 %456, 0
  br i1 %457, label %459, label %458

458:                                              ; preds = %443
  br i1 %166, label %464, label %579

459:                                              ; preds = %443
  %460 = load ptr, ptr %20, align 8
  %461 = getelementptr inbounds i8, ptr %460, i64 80
  store i64 %23, ptr %461, align 8
  %462 = load ptr, ptr %19, align 8
  %463 = getelementptr inbounds i8, ptr %462, i64 48
  store double 1.000000e+00, ptr %463, align 8
  br label %1016

464:                                              ; preds = %458, %574
  %465 = phi i1 [ %577, %574 ], [ %166, %458 ]
  %466 = phi i64 [ %576, %574 ], [ 0, %458 ]
  %467 = phi double [ %575, %574 ], [ %369, %458 ]
  %468 = icmp eq i64 %466, %370
  br i1 %468, label %574, label %469

469:                                              ; preds = %464
  %470 = getelementptr inbounds i64, ptr %18, i64 %466
  %471 = load i64, ptr %470, align 8
  %472 = icmp eq i64 %471, 0
  br i1 %472, label %473, label %574

473:                                              ; preds = %469
  %474 = getelementptr inbounds i64, ptr %16, i64 %466
  %475 = load i64, ptr %474, align 8
  %476 = sitofp i64 %475 to double
  %477 = getelementptr inbounds double, ptr %31, i64 %466
  %478 = load double, ptr %477, align 8
  %479 = fmul double %478, %476
  %480 = fcmp olt double %479, 0.000000e+00
  br i1 %480, label %481, label %574

481:                                              ; preds = %473
  %482 = call fastcc i32 @departs(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %366, double noundef %467, double noundef %478, i64 noundef %466) #8
  %483 = icmp eq i32 %482, 0
  br i1 %483, label %484, label %523

484:                                              ; preds = %481
  %485 = load i64, ptr %474, align 8
  %486 = load double, ptr %477, align 8
  %487 = getelementptr inbounds i64, ptr %14, i64 %466
  %488 = load i64, ptr %487, align 8
  %489 = icmp slt i64 %485, 0
  %490 = fcmp ogt double %486, 0.000000e+00
  %491 = and i1 %489, %490
  %492 = icmp sgt i64 %488, -1
  %493 = and i1 %491, %492
  br i1 %493, label %501, label %494

494:                                              ; preds = %484
  %495 = icmp sgt i64 %485, 0
  %496 = fcmp olt double %486, 0.000000e+00
  %497 = and i1 %495, %496
  br i1 %497, label %498, label %501

498:                                              ; preds = %494
  %499 = icmp slt i64 %488, 1
  %500 = zext i1 %499 to i32
  br label %501

501:                                              ; preds = %484, %494, %498
  %502 = phi i32 [ 1, %484 ], [ 0, %494 ], [ %500, %498 ]
  %503 = icmp eq i32 %502, 0
  br i1 %503, label %526, label %504

504:                                              ; preds = %501
  %505 = getelementptr inbounds double, ptr %358, i64 %466
  %506 = load double, ptr %505, align 8
  %507 = fcmp ogt double %506, 0.000000e+00
  %508 = and i1 %489, %507
  %509 = and i1 %492, %508
  br i1 %509, label %517, label %510

510:                                              ; preds = %504
  %511 = icmp sgt i64 %485, 0
  %512 = fcmp olt double %506, 0.000000e+00
  %513 = and i1 %511, %512
  br i1 %513, label %514, label %517

514:                                              ; preds = %510
  %515 = icmp slt i64 %488, 1
  %516 = zext i1 %515 to i32
  br label %517

517:                                              ; preds = %504, %510, %514
  %518 = phi i32 [ 1, %504 ], [ 0, %510 ], [ %516, %514 ]
  %519 = icmp eq i32 %518, 0
  br i1 %519, label %520, label %526

520:                                              ; preds = %517
  %521 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %366, double noundef %467, i64 noundef %466) #8
  %522 = fcmp ogt double %521, %366
  br i1 %522, label %523, label %526

523:                                              ; preds = %520, %481
  %524 = phi i64 [ -1, %481 ], [ 2, %520 ]
  %525 = phi double [ %467, %481 ], [ %521, %520 ]
  store i64 %524, ptr %470, align 8
  br label %526

526:                                              ; preds = %523, %520, %501, %517
  %527 = phi double [ %467, %517 ], [ %467, %501 ], [ %467, %520 ], [ %525, %523 ]
  %528 = load ptr, ptr %160, align 8
  %529 = load ptr, ptr %360, align 8
  %530 = insertelement <8 x double> poison, double %527, i64 0
  %531 = shufflevector <8 x double> %530, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %531, ptr %529, align 8
  %532 = load ptr, ptr %359, align 8
  %533 = load ptr, ptr %361, align 8
  %534 = load i64, ptr %362, align 8
  %535 = load ptr, ptr %363, align 8
  %536 = getelementptr inbounds i8, ptr %535, i64 24
  %537 = load i64, ptr %536, align 8
  %538 = load ptr, ptr %360, align 8
  %539 = load ptr, ptr %364, align 8
  %540 = getelementptr inbounds i8, ptr %539, i64 16
  %541 = load i64, ptr %540, align 8
  tail call fastcc void @nested(ptr noundef %528, ptr noundef %532, ptr noundef %533, i64 noundef %534, i64 noundef %537, ptr noundef %538, i64 noundef %541) #8
  %542 = fmul double %527, %2
  %543 = fadd double %542, %1
  %544 = load ptr, ptr %161, align 8
  store double %543, ptr %544, align 8
  %545 = load ptr, ptr %6, align 8
  %546 = getelementptr inbounds i8, ptr %545, i64 40
  %547 = load i64, ptr %546, align 8
  %548 = icmp eq i64 %547, 0
  br i1 %548, label %550, label %549

549:                                              ; preds = %526
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %550

550:                                              ; preds = %549, %526
  %551 = load i64, ptr %162, align 8
  %552 = icmp sgt i64 %551, 0
  br i1 %552, label %553, label %554

553:                                              ; preds = %550
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %554

554:                                              ; preds = %550, %553
  %555 = load ptr, ptr %9, align 8
  %556 = load i64, ptr %555, align 8
  %557 = load ptr, ptr %163, align 8
  %558 = load ptr, ptr %160, align 8
  %559 = load ptr, ptr %164, align 8
  %560 = load ptr, ptr %165, align 8
  %561 = load ptr, ptr %25, align 8
  %562 = getelementptr inbounds i8, ptr %555, i64 8
  %563 = load i64, ptr %562, align 8
  %564 = getelementptr inbounds double, ptr %561, i64 %563
  %565 = inttoptr i64 %556 to ptr
  %566 = load ptr, ptr %565, align 8
  %567 = tail call i32 %566(ptr noundef %557, ptr noundef %558, ptr noundef %559, ptr noundef %560, ptr noundef %564) #9
  %568 = icmp slt i32 %567, 0
  br i1 %568, label %569, label %574

569:                                              ; preds = %554
  %570 = load ptr, ptr %20, align 8
  %571 = getelementptr inbounds i8, ptr %570, i64 80
  store i64 %23, ptr %571, align 8
  %572 = load ptr, ptr %19, align 8
  %573 = getelementptr inbounds i8, ptr %572, i64 48
  store double 1.000000e+00, ptr %573, align 8
  br label %579

574:                                              ; preds = %554, %464, %469, %473
  %575 = phi double [ %467, %464 ], [ %467, %469 ], [ %527, %554 ], [ %467, %473 ]
  %576 = add nuw nsw i64 %466, 1
  %577 = icmp slt i64 %576, %12
  %578 = icmp eq i64 %576, %12
  br i1 %578, label %579, label %464, !llvm.loop !10

579:                                              ; preds = %574, %458, %569
  %580 = phi i1 [ %465, %569 ], [ %166, %458 ], [ %577, %574 ]
  %581 = phi i32 [ 1, %569 ], [ 16, %458 ], [ 16, %574 ]
  %582 = phi double [ %527, %569 ], [ %369, %458 ], [ %575, %574 ]
  %583 = phi i64 [ -4, %569 ], [ %367, %458 ], [ %367, %574 ]
  br i1 %580, label %1016, label %584

584:                                              ; preds = %579
  br i1 %167, label %593, label %585

585:                                              ; preds = %681, %584
  %586 = phi i64 [ -1, %584 ], [ %682, %681 ]
  %587 = phi i32 [ 0, %584 ], [ %683, %681 ]
  %588 = icmp eq i32 %587, 0
  br i1 %588, label %589, label %686

589:                                              ; preds = %585
  br i1 %176, label %590, label %819

590:                                              ; preds = %589
  %591 = fmul double %582, %2
  %592 = fadd double %591, %1
  br label %947

593:                                              ; preds = %584, %681
  %594 = phi i64 [ %684, %681 ], [ 0, %584 ]
  %595 = phi i32 [ %683, %681 ], [ 0, %584 ]
  %596 = phi i64 [ %682, %681 ], [ -1, %584 ]
  %597 = getelementptr inbounds double, ptr %31, i64 %594
  %598 = load double, ptr %597, align 8
  %599 = getelementptr inbounds i64, ptr %18, i64 %594
  %600 = load i64, ptr %599, align 8
  %601 = icmp eq i64 %600, -1
  br i1 %601, label %681, label %602

602:                                              ; preds = %593
  %603 = getelementptr inbounds i64, ptr %16, i64 %594
  %604 = load i64, ptr %603, align 8
  %605 = getelementptr inbounds i64, ptr %14, i64 %594
  %606 = load i64, ptr %605, align 8
  %607 = icmp slt i64 %604, 0
  %608 = fcmp ogt double %598, 0.000000e+00
  %609 = and i1 %608, %607
  %610 = icmp sgt i64 %606, -1
  %611 = and i1 %609, %610
  br i1 %611, label %619, label %612

612:                                              ; preds = %602
  %613 = icmp sgt i64 %604, 0
  %614 = fcmp olt double %598, 0.000000e+00
  %615 = and i1 %614, %613
  br i1 %615, label %616, label %619

616:                                              ; preds = %612
  %617 = icmp slt i64 %606, 1
  %618 = zext i1 %617 to i32
  br label %619

619:                                              ; preds = %602, %612, %616
  %620 = phi i32 [ 1, %602 ], [ 0, %612 ], [ %618, %616 ]
  %621 = icmp eq i32 %620, 0
  br i1 %621, label %622, label %643

622:                                              ; preds = %619
  %623 = getelementptr inbounds double, ptr %358, i64 %594
  %624 = load double, ptr %623, align 8
  %625 = fcmp ogt double %624, 0.000000e+00
  %626 = and i1 %607, %625
  %627 = and i1 %610, %626
  br i1 %627, label %635, label %628

628:                                              ; preds = %622
  %629 = icmp sgt i64 %604, 0
  %630 = fcmp olt double %624, 0.000000e+00
  %631 = and i1 %629, %630
  br i1 %631, label %632, label %635

632:                                              ; preds = %628
  %633 = icmp slt i64 %606, 1
  %634 = zext i1 %633 to i32
  br label %635

635:                                              ; preds = %622, %628, %632
  %636 = phi i32 [ 1, %622 ], [ 0, %628 ], [ %634, %632 ]
  %637 = icmp eq i32 %636, 0
  br i1 %637, label %643, label %638

638:                                              ; preds = %635
  %639 = fcmp oeq double %598, 0.000000e+00
  %640 = icmp eq i64 %600, 1
  %641 = or i1 %639, %640
  %642 = zext i1 %641 to i32
  br label %643

643:                                              ; preds = %638, %635, %619
  %644 = phi i32 [ 1, %619 ], [ %642, %638 ], [ 0, %635 ]
  %645 = icmp eq i32 %644, 0
  br i1 %645, label %646, label %650

646:                                              ; preds = %643
  %647 = icmp eq i64 %600, 2
  %648 = fcmp oeq double %598, 0.000000e+00
  %649 = select i1 %647, i1 %648, i1 false
  br label %650

650:                                              ; preds = %646, %643
  %651 = phi i1 [ true, %643 ], [ %649, %646 ]
  br i1 %651, label %667, label %652

652:                                              ; preds = %650
  %653 = getelementptr inbounds double, ptr %358, i64 %594
  %654 = load double, ptr %653, align 8
  %655 = icmp eq i64 %604, 0
  %656 = fcmp ord double %654, 0.000000e+00
  %657 = or i1 %655, %656
  br i1 %657, label %667, label %658

658:                                              ; preds = %652
  %659 = sitofp i64 %604 to double
  %660 = fmul double %598, %659
  %661 = fcmp olt double %660, 0.000000e+00
  br i1 %661, label %662, label %664

662:                                              ; preds = %658
  %663 = sub nsw i64 0, %604
  store i64 %663, ptr %603, align 8
  br label %667

664:                                              ; preds = %658
  %665 = fcmp ueq double %598, 0.000000e+00
  %666 = select i1 %665, i64 %594, i64 %596
  br label %667

667:                                              ; preds = %664, %662, %652, %650
  %668 = phi i64 [ %596, %650 ], [ %596, %662 ], [ %596, %652 ], [ %666, %664 ]
  %669 = zext i1 %651 to i64
  store i64 %669, ptr %599, align 8
  %670 = icmp ne i32 %595, 0
  %671 = xor i1 %651, true
  %672 = or i1 %670, %671
  br i1 %672, label %678, label %673

673:                                              ; preds = %667
  %674 = load ptr, ptr %168, align 8
  %675 = getelementptr inbounds i64, ptr %674, i64 %594
  %676 = load i64, ptr %675, align 8
  %677 = icmp eq i64 %676, 1
  br label %678

678:                                              ; preds = %667, %673
  %679 = phi i1 [ %670, %667 ], [ %677, %673 ]
  %680 = zext i1 %679 to i32
  br label %681

681:                                              ; preds = %593, %678
  %682 = phi i64 [ %668, %678 ], [ %596, %593 ]
  %683 = phi i32 [ %680, %678 ], [ %595, %593 ]
  %684 = add nuw nsw i64 %594, 1
  %685 = icmp eq i64 %684, %12
  br i1 %685, label %585, label %593, !llvm.loop !11

686:                                              ; preds = %585
  store double %582, ptr %169, align 8
  %687 = load ptr, ptr %9, align 8
  %688 = getelementptr inbounds i8, ptr %687, i64 8
  %689 = load i64, ptr %688, align 8
  %690 = load ptr, ptr %25, align 8
  %691 = getelementptr inbounds double, ptr %690, i64 %689
  %692 = mul i64 %689, 56
  %693 = getelementptr inbounds i8, ptr %690, i64 %692
  %694 = load ptr, ptr %170, align 8
  %695 = load i64, ptr %171, align 8
  %696 = getelementptr double, ptr %694, i64 %695
  %697 = getelementptr i8, ptr %696, i64 -8
  %698 = load double, ptr %697, align 8
  %699 = load double, ptr %694, align 8
  %700 = fsub double %698, %699
  %701 = icmp sgt i64 %689, 0
  br i1 %701, label %705, label %702

702:                                              ; preds = %718, %686
  %703 = phi i32 [ 0, %686 ], [ %720, %718 ]
  %704 = icmp eq i32 %703, 0
  br i1 %704, label %1016, label %723

705:                                              ; preds = %686, %718
  %706 = phi i64 [ %721, %718 ], [ 0, %686 ]
  %707 = phi i32 [ %720, %718 ], [ 0, %686 ]
  %708 = icmp eq i32 %707, 0
  br i1 %708, label %709, label %718

709:                                              ; preds = %705
  %710 = load ptr, ptr %17, align 8
  %711 = getelementptr inbounds i64, ptr %710, i64 %706
  %712 = load i64, ptr %711, align 8
  %713 = icmp sgt i64 %712, 0
  br i1 %713, label %714, label %718

714:                                              ; preds = %709
  %715 = getelementptr inbounds double, ptr %691, i64 %706
  %716 = load double, ptr %715, align 8
  %717 = fcmp oeq double %716, 0.000000e+00
  br label %718

718:                                              ; preds = %714, %709, %705
  %719 = phi i1 [ true, %705 ], [ false, %709 ], [ %717, %714 ]
  %720 = zext i1 %719 to i32
  %721 = add nuw nsw i64 %706, 1
  %722 = icmp eq i64 %721, %689
  br i1 %722, label %702, label %705, !llvm.loop !12

723:                                              ; preds = %702
  %724 = fsub double %357, %582
  %725 = fmul double %724, %2
  %726 = fcmp ogt double %173, %700
  %727 = select i1 %726, double %173, double %700
  %728 = fmul double %727, 0x3F50000000000000
  %729 = fcmp ugt double %725, %728
  br i1 %729, label %730, label %1016

730:                                              ; preds = %723
  %731 = fmul double %724, 0x3F50000000000000
  %732 = fadd double %582, %731
  %733 = load ptr, ptr %160, align 8
  %734 = load ptr, ptr %360, align 8
  %735 = insertelement <8 x double> poison, double %732, i64 0
  %736 = shufflevector <8 x double> %735, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %736, ptr %734, align 8
  %737 = load ptr, ptr %359, align 8
  %738 = load ptr, ptr %361, align 8
  %739 = load i64, ptr %362, align 8
  %740 = load ptr, ptr %363, align 8
  %741 = getelementptr inbounds i8, ptr %740, i64 24
  %742 = load i64, ptr %741, align 8
  %743 = load ptr, ptr %360, align 8
  %744 = load ptr, ptr %364, align 8
  %745 = getelementptr inbounds i8, ptr %744, i64 16
  %746 = load i64, ptr %745, align 8
  tail call fastcc void @nested(ptr noundef %733, ptr noundef %737, ptr noundef %738, i64 noundef %739, i64 noundef %742, ptr noundef %743, i64 noundef %746) #8
  %747 = fmul double %732, %2
  %748 = fadd double %747, %1
  %749 = load ptr, ptr %161, align 8
  store double %748, ptr %749, align 8
  %750 = load ptr, ptr %6, align 8
  %751 = getelementptr inbounds i8, ptr %750, i64 40
  %752 = load i64, ptr %751, align 8
  %753 = icmp eq i64 %752, 0
  br i1 %753, label %755, label %754

754:                                              ; preds = %730
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %755

755:                                              ; preds = %754, %730
  %756 = load i64, ptr %162, align 8
  %757 = icmp sgt i64 %756, 0
  br i1 %757, label %758, label %759

758:                                              ; preds = %755
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %759

759:                                              ; preds = %755, %758
  %760 = load ptr, ptr %9, align 8
  %761 = load i64, ptr %760, align 8
  %762 = load ptr, ptr %163, align 8
  %763 = load ptr, ptr %160, align 8
  %764 = load ptr, ptr %164, align 8
  %765 = load ptr, ptr %165, align 8
  %766 = load ptr, ptr %25, align 8
  %767 = getelementptr inbounds i8, ptr %760, i64 8
  %768 = load i64, ptr %767, align 8
  %769 = mul i64 %768, 56
  %770 = getelementptr inbounds i8, ptr %766, i64 %769
  %771 = inttoptr i64 %761 to ptr
  %772 = load ptr, ptr %771, align 8
  %773 = tail call i32 %772(ptr noundef %762, ptr noundef %763, ptr noundef %764, ptr noundef %765, ptr noundef %770) #9
  %774 = icmp slt i32 %773, 0
  br i1 %774, label %814, label %775

775:                                              ; preds = %759
  %776 = icmp sgt i64 %689, 0
  br i1 %776, label %777, label %1016

777:                                              ; preds = %775
  %778 = fmul double %582, %2
  %779 = fadd double %778, %1
  %780 = fsub double %779, %779
  br label %781

781:                                              ; preds = %777, %811
  %782 = phi i64 [ 0, %777 ], [ %812, %811 ]
  %783 = load ptr, ptr %17, align 8
  %784 = getelementptr inbounds i64, ptr %783, i64 %782
  %785 = load i64, ptr %784, align 8
  %786 = icmp sgt i64 %785, 0
  br i1 %786, label %787, label %811

787:                                              ; preds = %781
  %788 = getelementptr inbounds double, ptr %691, i64 %782
  %789 = load double, ptr %788, align 8
  %790 = fcmp oeq double %789, 0.000000e+00
  br i1 %790, label %791, label %811

791:                                              ; preds = %787
  %792 = getelementptr inbounds double, ptr %693, i64 %782
  %793 = load double, ptr %792, align 8
  %794 = fcmp oeq double %793, 0.000000e+00
  br i1 %794, label %795, label %811

795:                                              ; preds = %791
  %796 = load i64, ptr %174, align 8
  %797 = icmp eq i64 %796, 0
  br i1 %797, label %811, label %798

798:                                              ; preds = %795
  %799 = load ptr, ptr %175, align 8
  %800 = shl nsw i64 %782, 4
  %801 = getelementptr inbounds i8, ptr %799, i64 %800
  %802 = getelementptr inbounds i8, ptr %801, i64 8
  %803 = load double, ptr %802, align 8
  %804 = fcmp oeq double %803, %779
  br i1 %804, label %810, label %805

805:                                              ; preds = %798
  %806 = load double, ptr %801, align 8
  %807 = fsub double %803, %806
  %808 = fcmp ult double %807, %780
  br i1 %808, label %809, label %811

809:                                              ; preds = %805
  store double %779, ptr %801, align 8
  br label %810

810:                                              ; preds = %798, %809
  store double %779, ptr %802, align 8
  br label %811

811:                                              ; preds = %810, %805, %795, %791, %787, %781
  %812 = add nuw nsw i64 %782, 1
  %813 = icmp eq i64 %812, %689
  br i1 %813, label %1016, label %781, !llvm.loop !13

814:                                              ; preds = %759
  %815 = load ptr, ptr %20, align 8
  %816 = getelementptr inbounds i8, ptr %815, i64 80
  store i64 %23, ptr %816, align 8
  %817 = load ptr, ptr %19, align 8
  %818 = getelementptr inbounds i8, ptr %817, i64 48
  store double 1.000000e+00, ptr %818, align 8
  br label %1016

819:                                              ; preds = %989, %589
  %820 = load ptr, ptr %9, align 8
  %821 = getelementptr inbounds i8, ptr %820, i64 8
  %822 = load i64, ptr %821, align 8
  %823 = load ptr, ptr %25, align 8
  %824 = getelementptr inbounds double, ptr %823, i64 %822
  %825 = mul i64 %822, 56
  %826 = getelementptr inbounds i8, ptr %823, i64 %825
  %827 = load ptr, ptr %182, align 8
  %828 = load i64, ptr %183, align 8
  %829 = getelementptr double, ptr %827, i64 %828
  %830 = getelementptr i8, ptr %829, i64 -8
  %831 = load double, ptr %830, align 8
  %832 = load double, ptr %827, align 8
  %833 = fsub double %831, %832
  %834 = icmp sgt i64 %822, 0
  br i1 %834, label %838, label %835

835:                                              ; preds = %851, %819
  %836 = phi i32 [ 0, %819 ], [ %853, %851 ]
  %837 = icmp eq i32 %836, 0
  br i1 %837, label %997, label %856

838:                                              ; preds = %819, %851
  %839 = phi i64 [ %854, %851 ], [ 0, %819 ]
  %840 = phi i32 [ %853, %851 ], [ 0, %819 ]
  %841 = icmp eq i32 %840, 0
  br i1 %841, label %842, label %851

842:                                              ; preds = %838
  %843 = load ptr, ptr %17, align 8
  %844 = getelementptr inbounds i64, ptr %843, i64 %839
  %845 = load i64, ptr %844, align 8
  %846 = icmp sgt i64 %845, 0
  br i1 %846, label %847, label %851

847:                                              ; preds = %842
  %848 = getelementptr inbounds double, ptr %824, i64 %839
  %849 = load double, ptr %848, align 8
  %850 = fcmp oeq double %849, 0.000000e+00
  br label %851

851:                                              ; preds = %847, %842, %838
  %852 = phi i1 [ true, %838 ], [ false, %842 ], [ %850, %847 ]
  %853 = zext i1 %852 to i32
  %854 = add nuw nsw i64 %839, 1
  %855 = icmp eq i64 %854, %822
  br i1 %855, label %835, label %838, !llvm.loop !12

856:                                              ; preds = %835
  %857 = fsub double %357, %582
  %858 = fmul double %857, %2
  %859 = fcmp ogt double %185, %833
  %860 = select i1 %859, double %185, double %833
  %861 = fmul double %860, 0x3F50000000000000
  %862 = fcmp ugt double %858, %861
  br i1 %862, label %863, label %997

863:                                              ; preds = %856
  %864 = fmul double %857, 0x3F50000000000000
  %865 = fadd double %582, %864
  %866 = load ptr, ptr %160, align 8
  %867 = load ptr, ptr %360, align 8
  %868 = insertelement <8 x double> poison, double %865, i64 0
  %869 = shufflevector <8 x double> %868, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %869, ptr %867, align 8
  %870 = load ptr, ptr %359, align 8
  %871 = load ptr, ptr %361, align 8
  %872 = load i64, ptr %362, align 8
  %873 = load ptr, ptr %363, align 8
  %874 = getelementptr inbounds i8, ptr %873, i64 24
  %875 = load i64, ptr %874, align 8
  %876 = load ptr, ptr %360, align 8
  %877 = load ptr, ptr %364, align 8
  %878 = getelementptr inbounds i8, ptr %877, i64 16
  %879 = load i64, ptr %878, align 8
  tail call fastcc void @nested(ptr noundef %866, ptr noundef %870, ptr noundef %871, i64 noundef %872, i64 noundef %875, ptr noundef %876, i64 noundef %879) #8
  %880 = fmul double %865, %2
  %881 = fadd double %880, %1
  %882 = load ptr, ptr %161, align 8
  store double %881, ptr %882, align 8
  %883 = load ptr, ptr %6, align 8
  %884 = getelementptr inbounds i8, ptr %883, i64 40
  %885 = load i64, ptr %884, align 8
  %886 = icmp eq i64 %885, 0
  br i1 %886, label %888, label %887

887:                                              ; preds = %863
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %888

888:                                              ; preds = %887, %863
  %889 = load i64, ptr %162, align 8
  %890 = icmp sgt i64 %889, 0
  br i1 %890, label %891, label %892

891:                                              ; preds = %888
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %892

892:                                              ; preds = %888, %891
  %893 = load ptr, ptr %9, align 8
  %894 = load i64, ptr %893, align 8
  %895 = load ptr, ptr %163, align 8
  %896 = load ptr, ptr %160, align 8
  %897 = load ptr, ptr %164, align 8
  %898 = load ptr, ptr %165, align 8
  %899 = load ptr, ptr %25, align 8
  %900 = getelementptr inbounds i8, ptr %893, i64 8
  %901 = load i64, ptr %900, align 8
  %902 = mul i64 %901, 56
  %903 = getelementptr inbounds i8, ptr %899, i64 %902
  %904 = inttoptr i64 %894 to ptr
  %905 = load ptr, ptr %904, align 8
  %906 = tail call i32 %905(ptr noundef %895, ptr noundef %896, ptr noundef %897, ptr noundef %898, ptr noundef %903) #9
  %907 = icmp slt i32 %906, 0
  br i1 %907, label %992, label %908

908:                                              ; preds = %892
  %909 = icmp sgt i64 %822, 0
  br i1 %909, label %910, label %997

910:                                              ; preds = %908
  %911 = fmul double %582, %2
  %912 = fadd double %911, %1
  %913 = fsub double %912, %912
  br label %914

914:                                              ; preds = %910, %944
  %915 = phi i64 [ 0, %910 ], [ %945, %944 ]
  %916 = load ptr, ptr %17, align 8
  %917 = getelementptr inbounds i64, ptr %916, i64 %915
  %918 = load i64, ptr %917, align 8
  %919 = icmp sgt i64 %918, 0
  br i1 %919, label %920, label %944

920:                                              ; preds = %914
  %921 = getelementptr inbounds double, ptr %824, i64 %915
  %922 = load double, ptr %921, align 8
  %923 = fcmp oeq double %922, 0.000000e+00
  br i1 %923, label %924, label %944

924:                                              ; preds = %920
  %925 = getelementptr inbounds double, ptr %826, i64 %915
  %926 = load double, ptr %925, align 8
  %927 = fcmp oeq double %926, 0.000000e+00
  br i1 %927, label %928, label %944

928:                                              ; preds = %924
  %929 = load i64, ptr %186, align 8
  %930 = icmp eq i64 %929, 0
  br i1 %930, label %944, label %931

931:                                              ; preds = %928
  %932 = load ptr, ptr %187, align 8
  %933 = shl nsw i64 %915, 4
  %934 = getelementptr inbounds i8, ptr %932, i64 %933
  %935 = getelementptr inbounds i8, ptr %934, i64 8
  %936 = load double, ptr %935, align 8
  %937 = fcmp oeq double %936, %912
  br i1 %937, label %943, label %938

938:                                              ; preds = %931
  %939 = load double, ptr %934, align 8
  %940 = fsub double %936, %939
  %941 = fcmp ult double %940, %913
  br i1 %941, label %942, label %944

942:                                              ; preds = %938
  store double %912, ptr %934, align 8
  br label %943

943:                                              ; preds = %931, %942
  store double %912, ptr %935, align 8
  br label %944

944:                                              ; preds = %943, %938, %928, %924, %920, %914
  %945 = add nuw nsw i64 %915, 1
  %946 = icmp eq i64 %945, %822
  br i1 %946, label %997, label %914, !llvm.loop !13

947:                                              ; preds = %590, %989
  %948 = phi i64 [ 0, %590 ], [ %990, %989 ]
  %949 = getelementptr inbounds i64, ptr %18, i64 %948
  %950 = load i64, ptr %949, align 8
  %951 = icmp slt i64 %950, 1
  br i1 %951, label %989, label %952

952:                                              ; preds = %947
  %953 = load ptr, ptr %20, align 8
  %954 = getelementptr inbounds i8, ptr %953, i64 80
  %955 = load i64, ptr %954, align 8
  %956 = load ptr, ptr %6, align 8
  %957 = getelementptr inbounds i8, ptr %956, i64 8
  %958 = load i64, ptr %957, align 8
  %959 = load i64, ptr %177, align 8
  %960 = icmp eq i64 %959, 0
  br i1 %960, label %985, label %961

961:                                              ; preds = %952
  %962 = load ptr, ptr %178, align 8
  %963 = getelementptr inbounds double, ptr %962, i64 %955
  store double %592, ptr %963, align 8
  %964 = load ptr, ptr %179, align 8
  %965 = getelementptr inbounds i64, ptr %964, i64 %955
  store i64 %948, ptr %965, align 8
  %966 = icmp sgt i64 %958, 0
  br i1 %966, label %967, label %969

967:                                              ; preds = %961
  %968 = mul nsw i64 %958, %955
  br label %973

969:                                              ; preds = %973, %961
  %970 = add nsw i64 %955, 1
  %971 = load ptr, ptr %20, align 8
  %972 = getelementptr inbounds i8, ptr %971, i64 80
  store i64 %970, ptr %972, align 8
  br label %985

973:                                              ; preds = %967, %973
  %974 = phi i64 [ 0, %967 ], [ %983, %973 ]
  %975 = load ptr, ptr %160, align 8
  %976 = getelementptr inbounds double, ptr %975, i64 %974
  %977 = load double, ptr %976, align 8
  %978 = load ptr, ptr %180, align 8
  %979 = add nsw i64 %974, %968
  %980 = getelementptr inbounds double, ptr %978, i64 %979
  store double %977, ptr %980, align 8
  %981 = load ptr, ptr %181, align 8
  %982 = getelementptr inbounds double, ptr %981, i64 %979
  store double %977, ptr %982, align 8
  %983 = add nuw nsw i64 %974, 1
  %984 = icmp eq i64 %983, %958
  br i1 %984, label %969, label %973, !llvm.loop !14

985:                                              ; preds = %952, %969
  %986 = getelementptr inbounds i64, ptr %16, i64 %948
  %987 = load i64, ptr %986, align 8
  %988 = sub nsw i64 0, %987
  store i64 %988, ptr %986, align 8
  br label %989

989:                                              ; preds = %947, %985
  %990 = add nuw nsw i64 %948, 1
  %991 = icmp eq i64 %990, %12
  br i1 %991, label %819, label %947, !llvm.loop !15

992:                                              ; preds = %892
  %993 = load ptr, ptr %20, align 8
  %994 = getelementptr inbounds i8, ptr %993, i64 80
  store i64 %23, ptr %994, align 8
  %995 = load ptr, ptr %19, align 8
  %996 = getelementptr inbounds i8, ptr %995, i64 48
  store double 1.000000e+00, ptr %996, align 8
  br label %1016

997:                                              ; preds = %944, %908, %856, %835
  %998 = icmp sgt i64 %586, -1
  br i1 %998, label %999, label %1008

999:                                              ; preds = %997
  br i1 %190, label %1001, label %1000

1000:                                             ; preds = %1001, %999
  store double %582, ptr %191, align 8
  br label %1016

1001:                                             ; preds = %999, %1001
  %1002 = phi i64 [ %1006, %1001 ], [ 0, %999 ]
  %1003 = icmp eq i64 %1002, %586
  %1004 = zext i1 %1003 to i64
  %1005 = getelementptr inbounds i64, ptr %18, i64 %1002
  store i64 %1004, ptr %1005, align 8
  %1006 = add nuw nsw i64 %1002, 1
  %1007 = icmp eq i64 %1006, %12
  br i1 %1007, label %1000, label %1001, !llvm.loop !16

1008:                                             ; preds = %997
  %1009 = load i64, ptr %188, align 8
  %1010 = icmp sgt i64 %1009, 0
  br i1 %1010, label %1011, label %1016

1011:                                             ; preds = %1008
  %1012 = load i64, ptr %22, align 8
  %1013 = add nsw i64 %1012, %12
  %1014 = icmp sgt i64 %1013, %1009
  br i1 %1014, label %1015, label %1016

1015:                                             ; preds = %1011
  store double %582, ptr %189, align 8
  br label %1016

1016:                                             ; preds = %811, %775, %723, %702, %992, %1000, %1015, %814, %1011, %1008, %368, %579, %459
  %1017 = phi i32 [ 1, %459 ], [ %581, %579 ], [ 11, %368 ], [ 1, %992 ], [ 1, %1000 ], [ 1, %1015 ], [ 1, %814 ], [ 0, %1011 ], [ 0, %1008 ], [ 1, %702 ], [ 1, %723 ], [ 1, %775 ], [ 1, %811 ]
  %1018 = phi double [ %366, %459 ], [ %366, %579 ], [ %366, %368 ], [ %366, %992 ], [ %366, %1000 ], [ %366, %1015 ], [ %366, %814 ], [ %582, %1011 ], [ %582, %1008 ], [ %366, %702 ], [ %366, %723 ], [ %366, %775 ], [ %366, %811 ]
  %1019 = phi i64 [ -4, %459 ], [ %583, %579 ], [ %367, %368 ], [ -4, %992 ], [ 21, %1000 ], [ -3, %1015 ], [ -4, %814 ], [ %583, %1011 ], [ %583, %1008 ], [ -2, %702 ], [ -2, %723 ], [ -2, %775 ], [ -2, %811 ]
  switch i32 %1017, label %1101 [
    i32 0, label %365
    i32 11, label %1020
  ], !llvm.loop !17

1020:                                             ; preds = %1016
  br i1 %192, label %1021, label %1101

1021:                                             ; preds = %1020
  %1022 = icmp ult i32 %199, 5
  %1023 = zext nneg i32 %199 to i64
  %1024 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %1023
  %1025 = add nsw i32 %199, -1
  %1026 = sext i32 %1025 to i64
  %1027 = mul nsw i64 %12, %1026
  %1028 = getelementptr double, ptr %28, i64 %1027
  %1029 = mul nuw nsw i64 %12, %1023
  %1030 = getelementptr double, ptr %28, i64 %1029
  %1031 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %1026
  %1032 = fmul double %357, %2
  %1033 = fadd double %1032, %1
  br label %1034

1034:                                             ; preds = %1021, %1092
  %1035 = phi i64 [ 0, %1021 ], [ %1093, %1092 ]
  %1036 = getelementptr inbounds double, ptr %358, i64 %1035
  %1037 = load double, ptr %1036, align 8
  %1038 = getelementptr inbounds i64, ptr %16, i64 %1035
  %1039 = load i64, ptr %1038, align 8
  %1040 = sitofp i64 %1039 to double
  %1041 = fmul double %1037, %1040
  %1042 = fcmp olt double %1041, 0.000000e+00
  br i1 %1042, label %1043, label %1049

1043:                                             ; preds = %1034
  %1044 = call fastcc i32 @departs(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %1018, double noundef %357, double noundef %1037, i64 noundef %1035) #8
  %1045 = icmp eq i32 %1044, 0
  br i1 %1045, label %1046, label %1049

1046:                                             ; preds = %1043
  %1047 = load i64, ptr %1038, align 8
  %1048 = sub nsw i64 0, %1047
  br label %1058

1049:                                             ; preds = %1043, %1034
  %1050 = load i64, ptr %1038, align 8
  %1051 = icmp eq i64 %1050, 0
  br i1 %1051, label %1052, label %1060

1052:                                             ; preds = %1049
  %1053 = load double, ptr %1036, align 8
  %1054 = fcmp ogt double %1053, 0.000000e+00
  %1055 = fcmp olt double %1053, 0.000000e+00
  %1056 = sext i1 %1055 to i64
  %1057 = select i1 %1054, i64 1, i64 %1056
  br label %1058

1058:                                             ; preds = %1046, %1052
  %1059 = phi i64 [ %1057, %1052 ], [ %1048, %1046 ]
  store i64 %1059, ptr %1038, align 8
  br label %1060

1060:                                             ; preds = %1058, %1049
  br i1 %1022, label %1061, label %1092

1061:                                             ; preds = %1060
  %1062 = load double, ptr %1024, align 8
  %1063 = fcmp oeq double %357, %1062
  br i1 %1063, label %1064, label %1092

1064:                                             ; preds = %1061
  %1065 = getelementptr double, ptr %1028, i64 %1035
  %1066 = load double, ptr %1065, align 8
  %1067 = fcmp oeq double %1066, 0.000000e+00
  br i1 %1067, label %1068, label %1092

1068:                                             ; preds = %1064
  %1069 = getelementptr double, ptr %1030, i64 %1035
  %1070 = load double, ptr %1069, align 8
  %1071 = fcmp oeq double %1070, 0.000000e+00
  br i1 %1071, label %1072, label %1092

1072:                                             ; preds = %1068
  %1073 = load double, ptr %1031, align 8
  %1074 = fmul double %1073, %2
  %1075 = fadd double %1074, %1
  %1076 = load i64, ptr %193, align 8
  %1077 = icmp eq i64 %1076, 0
  br i1 %1077, label %1092, label %1078

1078:                                             ; preds = %1072
  %1079 = load ptr, ptr %194, align 8
  %1080 = shl nsw i64 %1035, 4
  %1081 = getelementptr inbounds i8, ptr %1079, i64 %1080
  %1082 = getelementptr inbounds i8, ptr %1081, i64 8
  %1083 = load double, ptr %1082, align 8
  %1084 = fcmp oeq double %1083, %1075
  br i1 %1084, label %1091, label %1085

1085:                                             ; preds = %1078
  %1086 = load double, ptr %1081, align 8
  %1087 = fsub double %1083, %1086
  %1088 = fsub double %1033, %1075
  %1089 = fcmp ult double %1087, %1088
  br i1 %1089, label %1090, label %1092

1090:                                             ; preds = %1085
  store double %1075, ptr %1081, align 8
  br label %1091

1091:                                             ; preds = %1078, %1090
  store double %1033, ptr %1082, align 8
  br label %1092

1092:                                             ; preds = %1091, %1085, %1072, %1060, %1061, %1064, %1068
  %1093 = add nuw nsw i64 %1035, 1
  %1094 = icmp eq i64 %1093, %12
  br i1 %1094, label %1101, label %1034, !llvm.loop !18

1095:                                             ; preds = %344, %305, %241
  %1096 = phi double [ %198, %241 ], [ %258, %305 ], [ %258, %344 ]
  %1097 = load ptr, ptr %20, align 8
  %1098 = getelementptr inbounds i8, ptr %1097, i64 80
  store i64 %23, ptr %1098, align 8
  %1099 = load ptr, ptr %19, align 8
  %1100 = getelementptr inbounds i8, ptr %1099, i64 48
  store double 1.000000e+00, ptr %1100, align 8
  br label %1101

1101:                                             ; preds = %1016, %1092, %1095, %1020
  %1102 = phi i32 [ 0, %1020 ], [ 1, %1095 ], [ 0, %1092 ], [ %1017, %1016 ]
  %1103 = phi double [ %357, %1020 ], [ %1096, %1095 ], [ %357, %1092 ], [ %1018, %1016 ]
  %1104 = phi i64 [ %1019, %1020 ], [ -4, %1095 ], [ %1019, %1092 ], [ %1019, %1016 ]
  %1105 = icmp eq i32 %1102, 0
  br i1 %1105, label %1106, label %1111

1106:                                             ; preds = %1101
  %1107 = fcmp oeq double %1103, %203
  %1108 = zext i1 %1107 to i32
  %1109 = add nuw nsw i32 %199, %1108
  %1110 = icmp ugt i32 %1109, %133
  br i1 %1110, label %1111, label %195, !llvm.loop !19

1111:                                             ; preds = %1106, %1101
  %1112 = phi i1 [ %1110, %1106 ], [ %196, %1101 ]
  br i1 %1112, label %1113, label %1131

1113:                                             ; preds = %1111
  %1114 = icmp sgt i64 %12, 0
  br i1 %1114, label %1115, label %1118

1115:                                             ; preds = %1113
  %1116 = shl i64 %12, 5
  %1117 = getelementptr i8, ptr %28, i64 %1116
  br label %1120

1118:                                             ; preds = %1120, %1113
  %1119 = load double, ptr %24, align 8
  store double %1119, ptr %30, align 8
  br label %1127

1120:                                             ; preds = %1115, %1120
  %1121 = phi i64 [ 0, %1115 ], [ %1125, %1120 ]
  %1122 = getelementptr double, ptr %1117, i64 %1121
  %1123 = load double, ptr %1122, align 8
  %1124 = getelementptr inbounds double, ptr %28, i64 %1121
  store double %1123, ptr %1124, align 8
  %1125 = add nuw nsw i64 %1121, 1
  %1126 = icmp eq i64 %1125, %12
  br i1 %1126, label %1118, label %1120, !llvm.loop !20

1127:                                             ; preds = %1118, %125, %98
  %1128 = phi ptr [ %101, %98 ], [ %128, %125 ], [ %24, %1118 ]
  %1129 = phi i64 [ -4, %98 ], [ -4, %125 ], [ 0, %1118 ]
  %1130 = getelementptr inbounds i8, ptr %1128, i64 48
  store double 1.000000e+00, ptr %1130, align 8
  br label %1131

1131:                                             ; preds = %1127, %106, %1111
  %1132 = phi i64 [ %107, %106 ], [ %1104, %1111 ], [ %1129, %1127 ]
  ret i64 %1132
}



define internal fastcc i64 @resolve(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3) unnamed_addr #2 {
  %5 = alloca [9 x double], align 16
  %6 = getelementptr inbounds i8, ptr %0, i64 768
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 672
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 680
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr double, ptr %11, i64 %13
  %15 = getelementptr i8, ptr %14, i64 -8
  %16 = load double, ptr %15, align 8
  %17 = load double, ptr %11, align 8
  %18 = fsub double %16, %17
  %19 = fadd double %2, %3
  %20 = tail call double @llvm.fabs.f64(double %19)
  %21 = fcmp ogt double %20, %18
  %22 = select i1 %21, double %20, double %18
  %23 = fmul double %22, 0x3D10000000000000
  %24 = fcmp ult double %23, %3
  %25 = icmp sgt i64 %9, 0
  %26 = select i1 %24, i1 %25, i1 false
  br i1 %26, label %27, label %365

27:                                               ; preds = %4
  %28 = getelementptr inbounds i8, ptr %0, i64 984
  %29 = shl nsw i64 %9, 4
  %30 = mul i64 %9, 40
  %31 = getelementptr inbounds i8, ptr %0, i64 864
  %32 = getelementptr inbounds i8, ptr %0, i64 144
  %33 = getelementptr inbounds i8, ptr %0, i64 1032
  %34 = getelementptr inbounds i8, ptr %1, i64 16
  %35 = getelementptr inbounds i8, ptr %1, i64 8
  %36 = getelementptr inbounds i8, ptr %0, i64 168
  %37 = getelementptr inbounds i8, ptr %0, i64 248
  %38 = getelementptr inbounds i8, ptr %0, i64 168
  %39 = getelementptr inbounds i8, ptr %0, i64 192
  %40 = getelementptr inbounds i8, ptr %0, i64 792
  %41 = getelementptr inbounds i8, ptr %0, i64 144
  %42 = getelementptr inbounds i8, ptr %0, i64 1032
  %43 = getelementptr inbounds i8, ptr %1, i64 16
  %44 = getelementptr inbounds i8, ptr %1, i64 8
  %45 = getelementptr inbounds i8, ptr %0, i64 600
  %46 = getelementptr inbounds i8, ptr %0, i64 576
  %47 = getelementptr inbounds i8, ptr %0, i64 168
  %48 = getelementptr inbounds i8, ptr %0, i64 248
  %49 = getelementptr inbounds i8, ptr %0, i64 168
  %50 = getelementptr inbounds i8, ptr %0, i64 192
  %51 = getelementptr inbounds i8, ptr %0, i64 792
  %52 = shl nsw i64 %9, 5
  br label %53

53:                                               ; preds = %27, %362
  %54 = phi i64 [ undef, %27 ], [ %361, %362 ]
  %55 = phi i32 [ 0, %27 ], [ %360, %362 ]
  %56 = phi i32 [ 0, %27 ], [ %359, %362 ]
  %57 = phi i64 [ 0, %27 ], [ %363, %362 ]
  %58 = load ptr, ptr %28, align 8
  %59 = getelementptr inbounds i8, ptr %58, i64 %29
  %60 = getelementptr inbounds double, ptr %59, i64 %57
  %61 = getelementptr inbounds i8, ptr %60, i64 %30
  %62 = load ptr, ptr %31, align 8
  %63 = getelementptr inbounds i64, ptr %62, i64 %57
  %64 = load i64, ptr %63, align 8
  %65 = and i64 %64, 1
  %66 = icmp eq i64 %65, 0
  br i1 %66, label %67, label %357

67:                                               ; preds = %53
  %68 = load double, ptr %60, align 8
  br label %72

69:                                               ; preds = %72
  %70 = fmul double %80, %82
  %71 = fcmp ugt double %70, 0.000000e+00
  br i1 %71, label %85, label %94

72:                                               ; preds = %67, %72
  %73 = phi i64 [ 1, %67 ], [ %83, %72 ]
  %74 = phi double [ %68, %67 ], [ %82, %72 ]
  %75 = phi double [ %68, %67 ], [ %80, %72 ]
  %76 = mul nuw nsw i64 %9, %73
  %77 = getelementptr inbounds double, ptr %60, i64 %76
  %78 = load double, ptr %77, align 8
  %79 = fcmp olt double %75, %78
  %80 = select i1 %79, double %75, double %78
  %81 = fcmp ogt double %74, %78
  %82 = select i1 %81, double %74, double %78
  %83 = add nuw nsw i64 %73, 1
  %84 = icmp eq i64 %83, 5
  br i1 %84, label %69, label %72, !llvm.loop !21

85:                                               ; preds = %69
  %86 = tail call double @llvm.fabs.f64(double %80)
  %87 = tail call double @llvm.fabs.f64(double %82)
  %88 = fcmp olt double %86, %87
  %89 = select i1 %88, double %86, double %87
  %90 = fsub double %82, %80
  %91 = fmul double %90, 4.000000e+00
  %92 = fcmp ole double %89, %91
  %93 = zext i1 %92 to i32
  br label %94

94:                                               ; preds = %69, %85
  %95 = phi i32 [ 1, %69 ], [ %93, %85 ]
  %96 = icmp eq i32 %95, 0
  br i1 %96, label %357, label %97

97:                                               ; preds = %94
  %98 = sext i32 %55 to i64
  br label %99

99:                                               ; preds = %97, %143
  %100 = phi i64 [ %98, %97 ], [ %105, %143 ]
  %101 = icmp slt i64 %100, 4
  br i1 %101, label %102, label %159

102:                                              ; preds = %99
  %103 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %100
  %104 = load double, ptr %103, align 8
  %105 = add nsw i64 %100, 1
  %106 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %105
  %107 = load double, ptr %106, align 8
  %108 = fadd double %104, %107
  %109 = fmul double %108, 5.000000e-01
  %110 = add nsw i64 %100, 7
  %111 = load ptr, ptr %33, align 8
  %112 = load ptr, ptr %34, align 8
  %113 = getelementptr inbounds i8, ptr %112, i64 96
  %114 = load ptr, ptr %113, align 8
  %115 = insertelement <8 x double> poison, double %109, i64 0
  %116 = shufflevector <8 x double> %115, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %116, ptr %114, align 8
  %117 = load ptr, ptr %112, align 8
  %118 = getelementptr inbounds i8, ptr %112, i64 192
  %119 = load ptr, ptr %118, align 8
  %120 = getelementptr inbounds i8, ptr %112, i64 8
  %121 = load i64, ptr %120, align 8
  %122 = load ptr, ptr %1, align 8
  %123 = load ptr, ptr %122, align 8
  %124 = getelementptr inbounds i8, ptr %123, i64 24
  %125 = load i64, ptr %124, align 8
  %126 = load ptr, ptr %113, align 8
  %127 = load ptr, ptr %35, align 8
  %128 = load ptr, ptr %127, align 8
  %129 = getelementptr inbounds i8, ptr %128, i64 16
  %130 = load i64, ptr %129, align 8
  tail call fastcc void @nested(ptr noundef %111, ptr noundef %117, ptr noundef %119, i64 noundef %121, i64 noundef %125, ptr noundef %126, i64 noundef %130) #8
  %131 = fmul double %109, %3
  %132 = fadd double %131, %2
  %133 = load ptr, ptr %36, align 8
  store double %132, ptr %133, align 8
  %134 = load ptr, ptr %32, align 8
  %135 = getelementptr inbounds i8, ptr %134, i64 40
  %136 = load i64, ptr %135, align 8
  %137 = icmp eq i64 %136, 0
  br i1 %137, label %139, label %138

138:                                              ; preds = %102
  tail call fastcc void @settle(ptr noundef nonnull %32) #8
  br label %139

139:                                              ; preds = %138, %102
  %140 = load i64, ptr %37, align 8
  %141 = icmp sgt i64 %140, 0
  br i1 %141, label %142, label %143

142:                                              ; preds = %139
  tail call fastcc void @sample(ptr noundef nonnull %32) #8
  br label %143

143:                                              ; preds = %139, %142
  %144 = load ptr, ptr %6, align 8
  %145 = load i64, ptr %144, align 8
  %146 = load ptr, ptr %38, align 8
  %147 = load ptr, ptr %33, align 8
  %148 = load ptr, ptr %39, align 8
  %149 = load ptr, ptr %40, align 8
  %150 = load ptr, ptr %28, align 8
  %151 = getelementptr inbounds i8, ptr %144, i64 8
  %152 = load i64, ptr %151, align 8
  %153 = mul nsw i64 %152, %110
  %154 = getelementptr inbounds double, ptr %150, i64 %153
  %155 = inttoptr i64 %145 to ptr
  %156 = load ptr, ptr %155, align 8
  %157 = tail call i32 %156(ptr noundef %146, ptr noundef %147, ptr noundef %148, ptr noundef %149, ptr noundef %154) #9
  %158 = icmp slt i32 %157, 0
  br i1 %158, label %355, label %99, !llvm.loop !22

159:                                              ; preds = %99
  %160 = load double, ptr %60, align 8
  %161 = tail call double @llvm.fabs.f64(double %160)
  store double %160, ptr %5, align 16
  br label %169

162:                                              ; preds = %219
  %163 = trunc nsw i64 %100 to i32
  %164 = fmul double %230, 0x3E50000000000000
  %165 = fcmp ogt double %224, %164
  br i1 %165, label %166, label %351

166:                                              ; preds = %162
  %167 = fmul double %224, 2.000000e+00
  %168 = fmul double %224, 8.000000e+00
  br label %232

169:                                              ; preds = %159, %219
  %170 = phi i64 [ 0, %159 ], [ %179, %219 ]
  %171 = phi double [ 0.000000e+00, %159 ], [ %224, %219 ]
  %172 = phi double [ %161, %159 ], [ %230, %219 ]
  %173 = mul nuw nsw i64 %9, %170
  %174 = getelementptr inbounds double, ptr %61, i64 %173
  %175 = load double, ptr %174, align 8
  %176 = shl nuw nsw i64 %170, 1
  %177 = or disjoint i64 %176, 1
  %178 = getelementptr inbounds [9 x double], ptr %5, i64 0, i64 %177
  store double %175, ptr %178, align 8
  %179 = add nuw nsw i64 %170, 1
  %180 = mul nuw nsw i64 %9, %179
  %181 = getelementptr inbounds double, ptr %60, i64 %180
  %182 = load double, ptr %181, align 8
  %183 = add nuw nsw i64 %176, 2
  %184 = getelementptr inbounds [9 x double], ptr %5, i64 0, i64 %183
  store double %182, ptr %184, align 16
  %185 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %170
  %186 = load double, ptr %185, align 8
  %187 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %179
  %188 = load double, ptr %187, align 8
  %189 = fadd double %186, %188
  %190 = fmul double %189, 5.000000e-01
  br label %191

191:                                              ; preds = %169, %195
  %192 = phi i64 [ 0, %169 ], [ %201, %195 ]
  %193 = phi double [ 0.000000e+00, %169 ], [ %200, %195 ]
  %194 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %192
  br label %203

195:                                              ; preds = %214
  %196 = mul nuw nsw i64 %9, %192
  %197 = getelementptr inbounds double, ptr %60, i64 %196
  %198 = load double, ptr %197, align 8
  %199 = fmul double %216, %198
  %200 = fadd double %193, %199
  %201 = add nuw nsw i64 %192, 1
  %202 = icmp eq i64 %201, 5
  br i1 %202, label %219, label %191, !llvm.loop !23

203:                                              ; preds = %191, %214
  %204 = phi i64 [ 0, %191 ], [ %217, %214 ]
  %205 = phi double [ 1.000000e+00, %191 ], [ %216, %214 ]
  %206 = icmp eq i64 %204, %192
  br i1 %206, label %214, label %207

207:                                              ; preds = %203
  %208 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %204
  %209 = load double, ptr %208, align 8
  %210 = fsub double %190, %209
  %211 = load double, ptr %194, align 8
  %212 = fsub double %211, %209
  %213 = fdiv double %210, %212
  br label %214

214:                                              ; preds = %207, %203
  %215 = phi double [ %213, %207 ], [ 1.000000e+00, %203 ]
  %216 = fmul double %205, %215
  %217 = add nuw nsw i64 %204, 1
  %218 = icmp eq i64 %217, 5
  br i1 %218, label %195, label %203, !llvm.loop !24

219:                                              ; preds = %195
  %220 = fsub double %175, %200
  %221 = tail call double @llvm.fabs.f64(double %220)
  %222 = fmul double %221, 2.000000e+00
  %223 = fcmp ogt double %171, %222
  %224 = select i1 %223, double %171, double %222
  %225 = tail call double @llvm.fabs.f64(double %175)
  %226 = tail call double @llvm.fabs.f64(double %182)
  %227 = fcmp ogt double %225, %226
  %228 = select i1 %227, double %225, double %226
  %229 = fcmp ogt double %172, %228
  %230 = select i1 %229, double %172, double %228
  %231 = icmp eq i64 %179, 4
  br i1 %231, label %162, label %169, !llvm.loop !25

232:                                              ; preds = %166, %253
  %233 = phi i64 [ 1, %166 ], [ %254, %253 ]
  %234 = phi i1 [ false, %166 ], [ %255, %253 ]
  %235 = getelementptr double, ptr %5, i64 %233
  %236 = getelementptr i8, ptr %235, i64 -8
  %237 = load double, ptr %236, align 8
  %238 = load double, ptr %235, align 8
  %239 = fsub double %237, %238
  %240 = tail call double @llvm.fabs.f64(double %239)
  %241 = fmul double %237, %238
  %242 = fcmp olt double %241, 0.000000e+00
  br i1 %242, label %243, label %245

243:                                              ; preds = %232
  %244 = fcmp olt double %240, %168
  br i1 %244, label %257, label %253

245:                                              ; preds = %232
  %246 = tail call double @llvm.fabs.f64(double %238)
  %247 = tail call double @llvm.fabs.f64(double %237)
  %248 = fcmp olt double %247, %246
  %249 = select i1 %248, double %247, double %246
  %250 = fcmp ugt double %249, %224
  %251 = fcmp ugt double %240, %167
  %252 = or i1 %251, %250
  br i1 %252, label %253, label %257

253:                                              ; preds = %245, %243
  %254 = add nuw nsw i64 %233, 1
  %255 = icmp ugt i64 %233, 7
  %256 = icmp eq i64 %254, 9
  br i1 %256, label %351, label %232, !llvm.loop !26

257:                                              ; preds = %243, %245
  br i1 %234, label %351, label %258

258:                                              ; preds = %257, %324
  %259 = phi i32 [ 1, %324 ], [ %56, %257 ]
  %260 = icmp eq i32 %259, 0
  br i1 %260, label %261, label %339

261:                                              ; preds = %258
  %262 = load ptr, ptr %42, align 8
  %263 = load ptr, ptr %43, align 8
  %264 = getelementptr inbounds i8, ptr %263, i64 96
  %265 = load ptr, ptr %264, align 8
  store <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, ptr %265, align 8
  %266 = load ptr, ptr %263, align 8
  %267 = getelementptr inbounds i8, ptr %263, i64 192
  %268 = load ptr, ptr %267, align 8
  %269 = getelementptr inbounds i8, ptr %263, i64 8
  %270 = load i64, ptr %269, align 8
  %271 = load ptr, ptr %1, align 8
  %272 = load ptr, ptr %271, align 8
  %273 = getelementptr inbounds i8, ptr %272, i64 24
  %274 = load i64, ptr %273, align 8
  %275 = load ptr, ptr %264, align 8
  %276 = load ptr, ptr %44, align 8
  %277 = load ptr, ptr %276, align 8
  %278 = getelementptr inbounds i8, ptr %277, i64 16
  %279 = load i64, ptr %278, align 8
  tail call fastcc void @nested(ptr noundef %262, ptr noundef %266, ptr noundef %268, i64 noundef %270, i64 noundef %274, ptr noundef %275, i64 noundef %279) #8
  %280 = load ptr, ptr %41, align 8
  %281 = getelementptr inbounds i8, ptr %280, i64 8
  %282 = load i64, ptr %281, align 8
  %283 = icmp sgt i64 %282, 0
  br i1 %283, label %295, label %284

284:                                              ; preds = %295, %261
  %285 = load ptr, ptr %47, align 8
  store double %19, ptr %285, align 8
  %286 = load ptr, ptr %41, align 8
  %287 = getelementptr inbounds i8, ptr %286, i64 40
  %288 = load i64, ptr %287, align 8
  %289 = icmp eq i64 %288, 0
  br i1 %289, label %291, label %290

290:                                              ; preds = %284
  tail call fastcc void @settle(ptr noundef nonnull %41) #8
  br label %291

291:                                              ; preds = %290, %284
  %292 = load i64, ptr %48, align 8
  %293 = icmp sgt i64 %292, 0
  br i1 %293, label %294, label %324

294:                                              ; preds = %291
  tail call fastcc void @sample(ptr noundef nonnull %41) #8
  br label %324

295:                                              ; preds = %261, %295
  %296 = phi i64 [ %319, %295 ], [ 0, %261 ]
  %297 = load ptr, ptr %45, align 8
  %298 = getelementptr inbounds double, ptr %297, i64 %296
  %299 = load double, ptr %298, align 8
  %300 = load ptr, ptr %46, align 8
  %301 = getelementptr inbounds double, ptr %300, i64 %296
  %302 = load double, ptr %301, align 8
  %303 = load ptr, ptr %42, align 8
  %304 = getelementptr inbounds double, ptr %303, i64 %296
  %305 = load double, ptr %304, align 8
  %306 = tail call double @llvm.fabs.f64(double %305)
  %307 = fmul double %302, %306
  %308 = fadd double %299, %307
  %309 = and i64 %296, 1
  %310 = icmp eq i64 %309, 0
  %311 = urem i64 %296, 3
  %312 = uitofp nneg i64 %311 to double
  %313 = fmul double %312, 0x3FE3C6EF372FE950
  %314 = fadd double %313, 1.000000e+00
  %315 = fneg double %314
  %316 = select i1 %310, double %314, double %315
  %317 = fmul double %316, %308
  %318 = fadd double %305, %317
  store double %318, ptr %304, align 8
  %319 = add nuw nsw i64 %296, 1
  %320 = load ptr, ptr %41, align 8
  %321 = getelementptr inbounds i8, ptr %320, i64 8
  %322 = load i64, ptr %321, align 8
  %323 = icmp slt i64 %319, %322
  br i1 %323, label %295, label %284, !llvm.loop !27

324:                                              ; preds = %291, %294
  %325 = load ptr, ptr %6, align 8
  %326 = load i64, ptr %325, align 8
  %327 = load ptr, ptr %49, align 8
  %328 = load ptr, ptr %42, align 8
  %329 = load ptr, ptr %50, align 8
  %330 = load ptr, ptr %51, align 8
  %331 = load ptr, ptr %28, align 8
  %332 = getelementptr inbounds i8, ptr %325, i64 8
  %333 = load i64, ptr %332, align 8
  %334 = getelementptr inbounds double, ptr %331, i64 %333
  %335 = inttoptr i64 %326 to ptr
  %336 = load ptr, ptr %335, align 8
  %337 = tail call i32 %336(ptr noundef %327, ptr noundef %328, ptr noundef %329, ptr noundef %330, ptr noundef %334) #9
  %338 = icmp slt i32 %337, 0
  br i1 %338, label %351, label %258, !llvm.loop !28

339:                                              ; preds = %258
  %340 = load ptr, ptr %28, align 8
  %341 = getelementptr double, ptr %340, i64 %9
  %342 = getelementptr double, ptr %341, i64 %57
  %343 = load double, ptr %342, align 8
  %344 = getelementptr inbounds i8, ptr %60, i64 %52
  %345 = load double, ptr %344, align 8
  %346 = fsub double %343, %345
  %347 = tail call double @llvm.fabs.f64(double %346)
  %348 = fcmp ogt double %224, %347
  %349 = zext i1 %348 to i32
  %350 = select i1 %348, i64 -6, i64 %54
  br label %351

351:                                              ; preds = %253, %324, %339, %162, %257
  %352 = phi i32 [ 4, %257 ], [ 4, %162 ], [ %349, %339 ], [ 1, %324 ], [ 4, %253 ]
  %353 = phi i32 [ %56, %257 ], [ %56, %162 ], [ %259, %339 ], [ %259, %324 ], [ %56, %253 ]
  %354 = phi i64 [ %54, %257 ], [ %54, %162 ], [ %350, %339 ], [ -4, %324 ], [ %54, %253 ]
  br label %357

355:                                              ; preds = %143
  %356 = trunc nsw i64 %100 to i32
  br label %357

357:                                              ; preds = %355, %53, %94, %351
  %358 = phi i32 [ %352, %351 ], [ 4, %94 ], [ 4, %53 ], [ 1, %355 ]
  %359 = phi i32 [ %353, %351 ], [ %56, %94 ], [ %56, %53 ], [ %56, %355 ]
  %360 = phi i32 [ %163, %351 ], [ %55, %94 ], [ %55, %53 ], [ %356, %355 ]
  %361 = phi i64 [ %354, %351 ], [ %54, %94 ], [ %54, %53 ], [ -4, %355 ]
  switch i32 %358, label %365 [
    i32 0, label %362
    i32 4, label %362
  ]

362:                                              ; preds = %357, %357
  %363 = add nuw nsw i64 %57, 1
  %364 = icmp eq i64 %363, %9
  br i1 %364, label %365, label %53, !llvm.loop !29

365:                                              ; preds = %362, %357, %4
  %366 = phi i64 [ 0, %4 ], [ %361, %357 ], [ 0, %362 ]
  ret i64 %366
}

define internal fastcc double @locate(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, double noundef %4, double noundef %5, i64 noundef %6) unnamed_addr #2 {
  %8 = alloca double, align 8
  %9 = alloca double, align 8
  store double %4, ptr %8, align 8
  store double %5, ptr %9, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 768
  %11 = getelementptr inbounds i8, ptr %0, i64 936
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr inbounds i64, ptr %12, i64 %6
  %14 = load i64, ptr %13, align 8
  %15 = sitofp i64 %14 to double
  %16 = fadd double %2, %3
  %17 = tail call double @llvm.fabs.f64(double %16)
  %18 = tail call double @llvm.fabs.f64(double %2)
  %19 = fcmp ogt double %17, %18
  %20 = select i1 %19, double %17, double %18
  %21 = fmul double %20, 0x3CB0000000000000
  %22 = fdiv double %21, %3
  %23 = getelementptr inbounds i8, ptr %0, i64 984
  %24 = load ptr, ptr %23, align 8
  %25 = load ptr, ptr %10, align 8
  %26 = getelementptr inbounds i8, ptr %25, i64 8
  %27 = load i64, ptr %26, align 8
  %28 = getelementptr inbounds double, ptr %24, i64 %27
  %29 = getelementptr inbounds double, ptr %28, i64 %6
  %30 = call fastcc i32 @comes_to_side(ptr noundef %0, ptr noundef %1, double noundef %2, double noundef %3, ptr noundef nonnull %8, ptr noundef nonnull %9, double noundef %22, i64 noundef %6) #8
  %31 = icmp eq i32 %30, 0
  br i1 %31, label %44, label %32

32:                                               ; preds = %7
  %33 = load double, ptr %9, align 8
  %34 = load double, ptr %8, align 8
  %35 = getelementptr inbounds i8, ptr %0, i64 144
  %36 = getelementptr inbounds i8, ptr %0, i64 1032
  %37 = getelementptr inbounds i8, ptr %1, i64 16
  %38 = getelementptr inbounds i8, ptr %1, i64 8
  %39 = getelementptr inbounds i8, ptr %0, i64 168
  %40 = getelementptr inbounds i8, ptr %0, i64 248
  %41 = getelementptr inbounds i8, ptr %0, i64 168
  %42 = getelementptr inbounds i8, ptr %0, i64 192
  %43 = getelementptr inbounds i8, ptr %0, i64 792
  br label %47

44:                                               ; preds = %7
  %45 = load double, ptr %8, align 8
  %46 = tail call fastcc double @turning_place(ptr noundef %0, ptr noundef %1, double noundef %2, double noundef %3, double noundef %45, double noundef %5, double noundef %22, i64 noundef %6) #8
  br label %244

47:                                               ; preds = %32, %91
  %48 = phi double [ %34, %32 ], [ %108, %91 ]
  %49 = phi double [ %33, %32 ], [ %109, %91 ]
  %50 = fsub double %49, %48
  %51 = fcmp ogt double %50, %22
  br i1 %51, label %52, label %110

52:                                               ; preds = %47
  %53 = fmul double %50, 5.000000e-01
  %54 = fadd double %48, %53
  %55 = fcmp une double %54, %48
  %56 = fcmp une double %54, %49
  %57 = and i1 %55, %56
  br i1 %57, label %58, label %110

58:                                               ; preds = %52
  %59 = load ptr, ptr %36, align 8
  %60 = load ptr, ptr %37, align 8
  %61 = getelementptr inbounds i8, ptr %60, i64 96
  %62 = load ptr, ptr %61, align 8
  %63 = insertelement <8 x double> poison, double %54, i64 0
  %64 = shufflevector <8 x double> %63, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %64, ptr %62, align 8
  %65 = load ptr, ptr %60, align 8
  %66 = getelementptr inbounds i8, ptr %60, i64 192
  %67 = load ptr, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %60, i64 8
  %69 = load i64, ptr %68, align 8
  %70 = load ptr, ptr %1, align 8
  %71 = load ptr, ptr %70, align 8
  %72 = getelementptr inbounds i8, ptr %71, i64 24
  %73 = load i64, ptr %72, align 8
  %74 = load ptr, ptr %61, align 8
  %75 = load ptr, ptr %38, align 8
  %76 = load ptr, ptr %75, align 8
  %77 = getelementptr inbounds i8, ptr %76, i64 16
  %78 = load i64, ptr %77, align 8
  tail call fastcc void @nested(ptr noundef %59, ptr noundef %65, ptr noundef %67, i64 noundef %69, i64 noundef %73, ptr noundef %74, i64 noundef %78) #8
  %79 = fmul double %54, %3
  %80 = fadd double %79, %2
  %81 = load ptr, ptr %39, align 8
  store double %80, ptr %81, align 8
  %82 = load ptr, ptr %35, align 8
  %83 = getelementptr inbounds i8, ptr %82, i64 40
  %84 = load i64, ptr %83, align 8
  %85 = icmp eq i64 %84, 0
  br i1 %85, label %87, label %86

86:                                               ; preds = %58
  tail call fastcc void @settle(ptr noundef nonnull %35) #8
  br label %87

87:                                               ; preds = %86, %58
  %88 = load i64, ptr %40, align 8
  %89 = icmp sgt i64 %88, 0
  br i1 %89, label %90, label %91

90:                                               ; preds = %87
  tail call fastcc void @sample(ptr noundef nonnull %35) #8
  br label %91

91:                                               ; preds = %87, %90
  %92 = load ptr, ptr %10, align 8
  %93 = load i64, ptr %92, align 8
  %94 = load ptr, ptr %41, align 8
  %95 = load ptr, ptr %36, align 8
  %96 = load ptr, ptr %42, align 8
  %97 = load ptr, ptr %43, align 8
  %98 = load ptr, ptr %23, align 8
  %99 = getelementptr inbounds i8, ptr %92, i64 8
  %100 = load i64, ptr %99, align 8
  %101 = getelementptr inbounds double, ptr %98, i64 %100
  %102 = inttoptr i64 %93 to ptr
  %103 = load ptr, ptr %102, align 8
  %104 = tail call i32 %103(ptr noundef %94, ptr noundef %95, ptr noundef %96, ptr noundef %97, ptr noundef %101) #9
  %105 = load double, ptr %29, align 8
  %106 = fmul double %105, %15
  %107 = fcmp ogt double %106, 0.000000e+00
  %108 = select i1 %107, double %54, double %48
  %109 = select i1 %107, double %49, double %54
  br i1 %57, label %47, label %110

110:                                              ; preds = %52, %91, %47
  %111 = phi double [ %48, %52 ], [ %108, %91 ], [ %48, %47 ]
  %112 = phi double [ %49, %52 ], [ %109, %91 ], [ %49, %47 ]
  store double %112, ptr %9, align 8
  store double %111, ptr %8, align 8
  %113 = getelementptr inbounds i8, ptr %0, i64 144
  %114 = getelementptr inbounds i8, ptr %0, i64 1032
  %115 = load ptr, ptr %114, align 8
  %116 = getelementptr inbounds i8, ptr %1, i64 16
  %117 = load ptr, ptr %116, align 8
  %118 = getelementptr inbounds i8, ptr %117, i64 96
  %119 = load ptr, ptr %118, align 8
  %120 = insertelement <8 x double> poison, double %112, i64 0
  %121 = shufflevector <8 x double> %120, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %121, ptr %119, align 8
  %122 = load ptr, ptr %117, align 8
  %123 = getelementptr inbounds i8, ptr %117, i64 192
  %124 = load ptr, ptr %123, align 8
  %125 = getelementptr inbounds i8, ptr %117, i64 8
  %126 = load i64, ptr %125, align 8
  %127 = load ptr, ptr %1, align 8
  %128 = load ptr, ptr %127, align 8
  %129 = getelementptr inbounds i8, ptr %128, i64 24
  %130 = load i64, ptr %129, align 8
  %131 = load ptr, ptr %118, align 8
  %132 = getelementptr inbounds i8, ptr %1, i64 8
  %133 = load ptr, ptr %132, align 8
  %134 = load ptr, ptr %133, align 8
  %135 = getelementptr inbounds i8, ptr %134, i64 16
  %136 = load i64, ptr %135, align 8
  tail call fastcc void @nested(ptr noundef %115, ptr noundef %122, ptr noundef %124, i64 noundef %126, i64 noundef %130, ptr noundef %131, i64 noundef %136) #8
  %137 = fmul double %112, %3
  %138 = fadd double %137, %2
  %139 = getelementptr inbounds i8, ptr %0, i64 168
  %140 = load ptr, ptr %139, align 8
  store double %138, ptr %140, align 8
  %141 = load ptr, ptr %113, align 8
  %142 = getelementptr inbounds i8, ptr %141, i64 40
  %143 = load i64, ptr %142, align 8
  %144 = icmp eq i64 %143, 0
  br i1 %144, label %146, label %145

145:                                              ; preds = %110
  tail call fastcc void @settle(ptr noundef nonnull %113) #8
  br label %146

146:                                              ; preds = %145, %110
  %147 = getelementptr inbounds i8, ptr %0, i64 248
  %148 = load i64, ptr %147, align 8
  %149 = icmp sgt i64 %148, 0
  br i1 %149, label %150, label %151

150:                                              ; preds = %146
  tail call fastcc void @sample(ptr noundef nonnull %113) #8
  br label %151

151:                                              ; preds = %146, %150
  %152 = load ptr, ptr %10, align 8
  %153 = load i64, ptr %152, align 8
  %154 = getelementptr inbounds i8, ptr %0, i64 168
  %155 = load ptr, ptr %154, align 8
  %156 = load ptr, ptr %114, align 8
  %157 = getelementptr inbounds i8, ptr %0, i64 192
  %158 = load ptr, ptr %157, align 8
  %159 = getelementptr inbounds i8, ptr %0, i64 792
  %160 = load ptr, ptr %159, align 8
  %161 = load ptr, ptr %23, align 8
  %162 = getelementptr inbounds i8, ptr %152, i64 8
  %163 = load i64, ptr %162, align 8
  %164 = getelementptr inbounds double, ptr %161, i64 %163
  %165 = inttoptr i64 %153 to ptr
  %166 = load ptr, ptr %165, align 8
  %167 = tail call i32 %166(ptr noundef %155, ptr noundef %156, ptr noundef %158, ptr noundef %160, ptr noundef %164) #9
  %168 = load double, ptr %29, align 8
  %169 = getelementptr inbounds i8, ptr %0, i64 864
  %170 = load ptr, ptr %169, align 8
  %171 = getelementptr inbounds i64, ptr %170, i64 %6
  %172 = load i64, ptr %171, align 8
  %173 = and i64 %172, 32
  %174 = icmp eq i64 %173, 0
  br i1 %174, label %175, label %244

175:                                              ; preds = %151
  %176 = load ptr, ptr %114, align 8
  %177 = load ptr, ptr %116, align 8
  %178 = getelementptr inbounds i8, ptr %177, i64 96
  %179 = load ptr, ptr %178, align 8
  store <8 x double> %121, ptr %179, align 8
  %180 = load ptr, ptr %177, align 8
  %181 = getelementptr inbounds i8, ptr %177, i64 192
  %182 = load ptr, ptr %181, align 8
  %183 = getelementptr inbounds i8, ptr %177, i64 8
  %184 = load i64, ptr %183, align 8
  %185 = load ptr, ptr %1, align 8
  %186 = load ptr, ptr %185, align 8
  %187 = getelementptr inbounds i8, ptr %186, i64 24
  %188 = load i64, ptr %187, align 8
  %189 = load ptr, ptr %178, align 8
  %190 = load ptr, ptr %132, align 8
  %191 = load ptr, ptr %190, align 8
  %192 = getelementptr inbounds i8, ptr %191, i64 16
  %193 = load i64, ptr %192, align 8
  tail call fastcc void @nested(ptr noundef %176, ptr noundef %180, ptr noundef %182, i64 noundef %184, i64 noundef %188, ptr noundef %189, i64 noundef %193) #8
  %194 = load ptr, ptr %139, align 8
  store double %138, ptr %194, align 8
  %195 = load ptr, ptr %113, align 8
  %196 = getelementptr inbounds i8, ptr %195, i64 40
  %197 = load i64, ptr %196, align 8
  %198 = icmp eq i64 %197, 0
  br i1 %198, label %200, label %199

199:                                              ; preds = %175
  tail call fastcc void @settle(ptr noundef nonnull %113) #8
  br label %200

200:                                              ; preds = %199, %175
  %201 = load i64, ptr %147, align 8
  %202 = icmp sgt i64 %201, 0
  br i1 %202, label %203, label %204

203:                                              ; preds = %200
  tail call fastcc void @sample(ptr noundef nonnull %113) #8
  br label %204

204:                                              ; preds = %203, %200
  %205 = load ptr, ptr %10, align 8
  %206 = getelementptr inbounds i8, ptr %205, i64 56
  %207 = load i64, ptr %206, align 8
  %208 = load ptr, ptr %154, align 8
  %209 = load ptr, ptr %114, align 8
  %210 = load ptr, ptr %157, align 8
  %211 = getelementptr inbounds i8, ptr %0, i64 1152
  %212 = load ptr, ptr %211, align 8
  %213 = getelementptr inbounds i8, ptr %0, i64 1200
  %214 = load ptr, ptr %213, align 8
  %215 = inttoptr i64 %207 to ptr
  %216 = load ptr, ptr %215, align 8
  %217 = tail call i32 %216(ptr noundef %208, ptr noundef %209, ptr noundef %210, ptr noundef %212, ptr noundef %214) #9
  %218 = icmp eq i32 %217, 0
  br i1 %218, label %219, label %244

219:                                              ; preds = %204
  %220 = load ptr, ptr %213, align 8
  %221 = getelementptr inbounds double, ptr %220, i64 %6
  %222 = load double, ptr %221, align 8
  %223 = load ptr, ptr %11, align 8
  %224 = getelementptr inbounds i64, ptr %223, i64 %6
  %225 = load i64, ptr %224, align 8
  %226 = sitofp i64 %225 to double
  %227 = fmul double %222, %226
  %228 = fcmp ule double %227, 0.000000e+00
  br i1 %228, label %244, label %229

229:                                              ; preds = %219
  %230 = fcmp oeq double %168, 0.000000e+00
  br i1 %230, label %242, label %231

231:                                              ; preds = %229
  %232 = load ptr, ptr %213, align 8
  %233 = load ptr, ptr %10, align 8
  %234 = getelementptr inbounds i8, ptr %233, i64 8
  %235 = load i64, ptr %234, align 8
  %236 = getelementptr double, ptr %232, i64 %235
  %237 = getelementptr double, ptr %236, i64 %6
  %238 = load double, ptr %237, align 8
  %239 = tail call double @llvm.fabs.f64(double %168)
  %240 = fmul double %238, 0x3CE0000000000000
  %241 = fcmp ugt double %239, %240
  br i1 %241, label %244, label %242

242:                                              ; preds = %229, %231
  %243 = tail call fastcc double @turning_place(ptr noundef %0, ptr noundef nonnull %1, double noundef %2, double noundef %3, double noundef %112, double noundef %5, double noundef %22, i64 noundef %6) #8
  br label %244

244:                                              ; preds = %219, %151, %204, %231, %242, %44
  %245 = phi double [ %243, %242 ], [ %46, %44 ], [ %112, %231 ], [ %112, %204 ], [ %112, %151 ], [ %112, %219 ]
  ret double %245
}

define internal fastcc range(i32 0, 2) i32 @departs(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, double noundef %4, double noundef %5, double noundef %6, i64 noundef %7) unnamed_addr #2 {
  %9 = getelementptr inbounds i8, ptr %0, i64 936
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i64, ptr %10, i64 %7
  %12 = load i64, ptr %11, align 8
  %13 = sitofp i64 %12 to double
  %14 = fmul double %13, %6
  %15 = fcmp olt double %14, 0.000000e+00
  br i1 %15, label %16, label %20

16:                                               ; preds = %8
  %17 = tail call fastcc double @locate(ptr noundef %0, ptr noundef %1, double noundef %2, double noundef %3, double noundef %4, double noundef %5, i64 noundef %7) #8
  %18 = fcmp oeq double %17, 2.000000e+00
  %19 = zext i1 %18 to i32
  br label %20

20:                                               ; preds = %16, %8
  %21 = phi i32 [ 0, %8 ], [ %19, %16 ]
  ret i32 %21
}

define internal fastcc void @nested(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, i64 noundef %3, i64 noundef %4, ptr noundef readonly %5, i64 noundef %6) unnamed_addr #3 {
  %8 = load <8 x double>, ptr %5, align 8
  %9 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %8
  %10 = shl nsw i64 %6, 3
  %11 = icmp sgt i64 %6, 0
  br i1 %11, label %12, label %19

12:                                               ; preds = %7
  %13 = add nsw i64 %4, -1
  %14 = mul nsw i64 %13, %3
  %15 = getelementptr double, ptr %2, i64 %14
  %16 = add nsw i64 %4, -2
  %17 = icmp sgt i64 %4, 1
  %18 = sub i64 0, %3
  br label %20

19:                                               ; preds = %24, %7
  ret void

20:                                               ; preds = %12, %24
  %21 = phi i64 [ 0, %12 ], [ %30, %24 ]
  %22 = getelementptr double, ptr %15, i64 %21
  %23 = load <8 x double>, ptr %22, align 8
  br i1 %17, label %32, label %24

24:                                               ; preds = %32, %20
  %25 = phi <8 x double> [ %23, %20 ], [ %41, %32 ]
  %26 = getelementptr inbounds double, ptr %0, i64 %21
  %27 = getelementptr inbounds double, ptr %1, i64 %21
  %28 = load <8 x double>, ptr %27, align 8
  %29 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %8, <8 x double> %25, <8 x double> %28)
  store <8 x double> %29, ptr %26, align 8
  %30 = add nuw nsw i64 %21, 8
  %31 = icmp slt i64 %30, %10
  br i1 %31, label %20, label %19, !llvm.loop !30

32:                                               ; preds = %20, %32
  %33 = phi i64 [ %42, %32 ], [ %16, %20 ]
  %34 = phi <8 x double> [ %41, %32 ], [ %23, %20 ]
  %35 = phi ptr [ %36, %32 ], [ %22, %20 ]
  %36 = getelementptr inbounds double, ptr %35, i64 %18
  %37 = and i64 %33, 1
  %38 = icmp eq i64 %37, 0
  %39 = select i1 %38, <8 x double> %9, <8 x double> %8
  %40 = load <8 x double>, ptr %36, align 8
  %41 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %39, <8 x double> %34, <8 x double> %40)
  %42 = add nsw i64 %33, -1
  %43 = icmp sgt i64 %33, 0
  br i1 %43, label %32, label %24, !llvm.loop !31
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #4

define internal fastcc void @settle(ptr noundef readonly %0) unnamed_addr #5 {
  %2 = getelementptr inbounds i8, ptr %0, i64 192
  %3 = load ptr, ptr %2, align 8
  %4 = load double, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 24
  %6 = load ptr, ptr %5, align 8
  %7 = load double, ptr %6, align 8
  %8 = fcmp olt double %7, %4
  %9 = select i1 %8, double %7, double %4
  %10 = getelementptr inbounds i8, ptr %0, i64 168
  %11 = getelementptr inbounds i8, ptr %0, i64 176
  %12 = load i64, ptr %11, align 8
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %14, label %29

14:                                               ; preds = %1
  %15 = load ptr, ptr %10, align 8
  br label %16

16:                                               ; preds = %14, %16
  %17 = phi i64 [ 0, %14 ], [ %27, %16 ]
  %18 = phi i64 [ %12, %14 ], [ %26, %16 ]
  %19 = add nuw nsw i64 %17, %18
  %20 = lshr i64 %19, 1
  %21 = mul i64 %20, 24
  %22 = getelementptr inbounds i8, ptr %15, i64 %21
  %23 = load double, ptr %22, align 8
  %24 = fcmp ogt double %23, %9
  %25 = add nuw nsw i64 %20, 1
  %26 = select i1 %24, i64 %20, i64 %18
  %27 = select i1 %24, i64 %17, i64 %25
  %28 = icmp slt i64 %27, %26
  br i1 %28, label %16, label %29, !llvm.loop !32

29:                                               ; preds = %16, %1
  %30 = phi i64 [ 0, %1 ], [ %27, %16 ]
  %31 = load ptr, ptr %10, align 8
  %32 = mul i64 %30, 24
  %33 = getelementptr inbounds i8, ptr %31, i64 %32
  %34 = icmp eq i64 %30, 0
  br i1 %34, label %39, label %35

35:                                               ; preds = %29
  %36 = getelementptr inbounds i8, ptr %33, i64 -8
  %37 = load double, ptr %36, align 8
  %38 = fcmp olt double %9, %37
  br i1 %38, label %46, label %39

39:                                               ; preds = %35, %29
  %40 = icmp slt i64 %30, %12
  br i1 %40, label %41, label %45

41:                                               ; preds = %39
  %42 = getelementptr inbounds i8, ptr %33, i64 8
  %43 = load double, ptr %42, align 8
  %44 = fcmp ogt double %9, %43
  br i1 %44, label %46, label %45

45:                                               ; preds = %41, %39
  br label %46

46:                                               ; preds = %45, %41, %35
  %47 = phi double [ %37, %35 ], [ %9, %45 ], [ %43, %41 ]
  store double %47, ptr %6, align 8
  ret void
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #5 {
  %2 = getelementptr inbounds i8, ptr %0, i64 104
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %13

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 96
  %7 = getelementptr inbounds i8, ptr %0, i64 112
  %8 = getelementptr inbounds i8, ptr %0, i64 24
  %9 = getelementptr inbounds i8, ptr %0, i64 192
  %10 = getelementptr inbounds i8, ptr %0, i64 120
  %11 = getelementptr inbounds i8, ptr %0, i64 144
  %12 = getelementptr inbounds i8, ptr %0, i64 48
  br label %14

13:                                               ; preds = %61, %1
  ret void

14:                                               ; preds = %5, %61
  %15 = phi i64 [ 0, %5 ], [ %86, %61 ]
  %16 = load ptr, ptr %6, align 8
  %17 = load i64, ptr %7, align 8
  %18 = mul nsw i64 %17, %15
  %19 = getelementptr inbounds i64, ptr %16, i64 %18
  %20 = getelementptr inbounds i8, ptr %19, i64 24
  %21 = load ptr, ptr %8, align 8
  %22 = load double, ptr %21, align 8
  %23 = load ptr, ptr %9, align 8
  %24 = load double, ptr %23, align 8
  %25 = fcmp olt double %22, %24
  %26 = select i1 %25, double %22, double %24
  %27 = getelementptr inbounds i8, ptr %19, i64 8
  %28 = load i64, ptr %27, align 8
  %29 = load ptr, ptr %10, align 8
  %30 = getelementptr inbounds double, ptr %29, i64 %28
  %31 = load double, ptr %30, align 8
  %32 = fcmp ogt double %31, %26
  %33 = select i1 %32, double %31, double %26
  %34 = getelementptr inbounds i8, ptr %19, i64 16
  %35 = load i64, ptr %34, align 8
  %36 = load i64, ptr %20, align 8
  %37 = getelementptr inbounds double, ptr %30, i64 %36
  %38 = load double, ptr %37, align 8
  %39 = fcmp ugt double %38, %33
  br i1 %39, label %47, label %40

40:                                               ; preds = %14
  %41 = add nsw i64 %35, -1
  %42 = icmp eq i64 %41, %36
  br i1 %42, label %61, label %43

43:                                               ; preds = %40
  %44 = getelementptr i8, ptr %37, i64 8
  %45 = load double, ptr %44, align 8
  %46 = fcmp ogt double %45, %33
  br i1 %46, label %61, label %47

47:                                               ; preds = %43, %14
  %48 = icmp sgt i64 %35, 1
  br i1 %48, label %49, label %61

49:                                               ; preds = %47, %49
  %50 = phi i64 [ %58, %49 ], [ %35, %47 ]
  %51 = phi i64 [ %57, %49 ], [ 0, %47 ]
  %52 = add nsw i64 %50, %51
  %53 = sdiv i64 %52, 2
  %54 = getelementptr inbounds double, ptr %30, i64 %53
  %55 = load double, ptr %54, align 8
  %56 = fcmp ugt double %55, %33
  %57 = select i1 %56, i64 %51, i64 %53
  %58 = select i1 %56, i64 %53, i64 %50
  %59 = sub nsw i64 %58, %57
  %60 = icmp sgt i64 %59, 1
  br i1 %60, label %49, label %61, !llvm.loop !33

61:                                               ; preds = %49, %47, %40, %43
  %62 = phi i64 [ %36, %43 ], [ %36, %40 ], [ 0, %47 ], [ %57, %49 ]
  store i64 %62, ptr %20, align 8
  %63 = getelementptr inbounds double, ptr %30, i64 %62
  %64 = load double, ptr %63, align 8
  %65 = fsub double %33, %64
  %66 = load ptr, ptr %11, align 8
  %67 = add nsw i64 %62, %28
  %68 = shl nsw i64 %67, 5
  %69 = getelementptr inbounds i8, ptr %66, i64 %68
  %70 = load double, ptr %69, align 8
  %71 = getelementptr inbounds i8, ptr %69, i64 8
  %72 = load double, ptr %71, align 8
  %73 = getelementptr inbounds i8, ptr %69, i64 16
  %74 = load double, ptr %73, align 8
  %75 = getelementptr inbounds i8, ptr %69, i64 24
  %76 = load double, ptr %75, align 8
  %77 = fmul double %65, %76
  %78 = fadd double %74, %77
  %79 = fmul double %65, %78
  %80 = fadd double %72, %79
  %81 = fmul double %65, %80
  %82 = fadd double %70, %81
  %83 = load ptr, ptr %12, align 8
  %84 = load i64, ptr %19, align 8
  %85 = getelementptr inbounds double, ptr %83, i64 %84
  store double %82, ptr %85, align 8
  %86 = add nuw nsw i64 %15, 1
  %87 = load i64, ptr %2, align 8
  %88 = icmp slt i64 %86, %87
  br i1 %88, label %14, label %13, !llvm.loop !34
}

declare double @llvm.fabs.f64(double) #4

define internal fastcc double @least_place(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, i64 noundef %4, double noundef %5, i32 noundef %6, i32 noundef %7) unnamed_addr #2 {
  %9 = getelementptr inbounds i8, ptr %0, i64 768
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 984
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds double, ptr %14, i64 %4
  %16 = add nsw i32 %6, 2
  %17 = sext i32 %16 to i64
  %18 = mul nsw i64 %12, %17
  %19 = getelementptr inbounds double, ptr %14, i64 %18
  %20 = getelementptr inbounds double, ptr %19, i64 %4
  %21 = sub nsw i64 0, %12
  %22 = getelementptr inbounds double, ptr %20, i64 %21
  %23 = load double, ptr %22, align 8
  %24 = fmul double %23, %5
  %25 = load double, ptr %20, align 8
  %26 = fmul double %25, %5
  %27 = getelementptr inbounds double, ptr %20, i64 %12
  %28 = load double, ptr %27, align 8
  %29 = fmul double %28, %5
  %30 = fcmp ogt double %24, 0.000000e+00
  %31 = fcmp ogt double %26, 0.000000e+00
  %32 = and i1 %30, %31
  %33 = fcmp ogt double %29, 0.000000e+00
  %34 = and i1 %32, %33
  br i1 %34, label %35, label %217

35:                                               ; preds = %8
  %36 = fcmp ogt double %26, %29
  %37 = select i1 %36, double %26, double %29
  %38 = fcmp ogt double %24, %37
  %39 = select i1 %38, double %24, double %37
  %40 = add nsw i32 %6, 1
  %41 = sext i32 %40 to i64
  %42 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %41
  %43 = load double, ptr %42, align 8
  %44 = sext i32 %6 to i64
  %45 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = add nsw i32 %6, -1
  %48 = sext i32 %47 to i64
  %49 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = icmp sgt i32 %7, 1
  %52 = add nsw i32 %7, -1
  %53 = zext nneg i32 %52 to i64
  %54 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %53
  %55 = icmp slt i32 %7, 4
  %56 = sext i32 %7 to i64
  %57 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %56
  %58 = getelementptr inbounds i8, ptr %0, i64 144
  %59 = getelementptr inbounds i8, ptr %0, i64 1032
  %60 = getelementptr inbounds i8, ptr %1, i64 16
  %61 = getelementptr inbounds i8, ptr %1, i64 8
  %62 = getelementptr inbounds i8, ptr %0, i64 168
  %63 = getelementptr inbounds i8, ptr %0, i64 248
  %64 = getelementptr inbounds i8, ptr %0, i64 168
  %65 = getelementptr inbounds i8, ptr %0, i64 192
  %66 = getelementptr inbounds i8, ptr %0, i64 792
  %67 = fmul double %39, 0xBCE0000000000000
  br label %72

68:                                               ; preds = %204
  %69 = add nuw nsw i32 %82, 1
  %70 = icmp ugt i32 %82, 18
  %71 = icmp eq i32 %69, 20
  br i1 %71, label %214, label %72, !llvm.loop !35

72:                                               ; preds = %35, %68
  %73 = phi i1 [ false, %35 ], [ %70, %68 ]
  %74 = phi double [ undef, %35 ], [ %213, %68 ]
  %75 = phi double [ %50, %35 ], [ %212, %68 ]
  %76 = phi double [ %46, %35 ], [ %211, %68 ]
  %77 = phi double [ %43, %35 ], [ %210, %68 ]
  %78 = phi double [ 0x7FF0000000000000, %35 ], [ %209, %68 ]
  %79 = phi double [ %24, %35 ], [ %208, %68 ]
  %80 = phi double [ %26, %35 ], [ %207, %68 ]
  %81 = phi double [ %29, %35 ], [ %206, %68 ]
  %82 = phi i32 [ 0, %35 ], [ %69, %68 ]
  %83 = fsub double %80, %79
  %84 = fsub double %76, %75
  %85 = fdiv double %83, %84
  %86 = fsub double %81, %80
  %87 = fsub double %77, %76
  %88 = fdiv double %86, %87
  %89 = fsub double %88, %85
  %90 = fsub double %77, %75
  %91 = fdiv double %89, %90
  %92 = fmul double %84, %91
  %93 = fadd double %85, %92
  %94 = fmul double %93, 5.000000e-01
  %95 = fdiv double %94, %91
  %96 = fsub double %76, %95
  %97 = fcmp ogt double %91, 0.000000e+00
  br i1 %97, label %98, label %204

98:                                               ; preds = %72
  %99 = fsub double %96, %76
  %100 = fmul double %94, %99
  %101 = fadd double %80, %100
  %102 = fmul double %78, 2.000000e+00
  %103 = fcmp ugt double %101, %102
  br i1 %103, label %204, label %104

104:                                              ; preds = %98
  br i1 %51, label %105, label %107

105:                                              ; preds = %104
  %106 = load double, ptr %54, align 8
  br label %107

107:                                              ; preds = %104, %105
  %108 = phi double [ %106, %105 ], [ 0xBFCE3779B97F4A7C, %104 ]
  br i1 %55, label %109, label %111

109:                                              ; preds = %107
  %110 = load double, ptr %57, align 8
  br label %111

111:                                              ; preds = %107, %109
  %112 = phi double [ %110, %109 ], [ 0x3FF4498517A7B356, %107 ]
  %113 = icmp eq i32 %82, 0
  br i1 %113, label %114, label %118

114:                                              ; preds = %111
  %115 = fcmp ult double %96, %108
  %116 = fcmp ugt double %96, %112
  %117 = select i1 %115, i1 true, i1 %116
  br i1 %117, label %204, label %118

118:                                              ; preds = %114, %111
  %119 = fcmp ugt double %96, %75
  br i1 %119, label %120, label %122

120:                                              ; preds = %118
  %121 = fcmp ult double %96, %77
  br i1 %121, label %126, label %122

122:                                              ; preds = %120, %118
  %123 = phi double [ %77, %120 ], [ %75, %118 ]
  %124 = fadd double %76, %123
  %125 = fmul double %124, 5.000000e-01
  br label %126

126:                                              ; preds = %122, %120
  %127 = phi double [ %125, %122 ], [ %96, %120 ]
  %128 = fsub double %127, %76
  %129 = fmul double %91, %128
  %130 = fadd double %93, %129
  %131 = fmul double %128, %130
  %132 = fadd double %80, %131
  %133 = fcmp ule double %127, %75
  %134 = fcmp uge double %127, %77
  %135 = or i1 %133, %134
  %136 = fcmp oeq double %127, %76
  %137 = or i1 %135, %136
  br i1 %137, label %204, label %138

138:                                              ; preds = %126
  %139 = load ptr, ptr %59, align 8
  %140 = load ptr, ptr %60, align 8
  %141 = getelementptr inbounds i8, ptr %140, i64 96
  %142 = load ptr, ptr %141, align 8
  %143 = insertelement <8 x double> poison, double %127, i64 0
  %144 = shufflevector <8 x double> %143, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %144, ptr %142, align 8
  %145 = load ptr, ptr %140, align 8
  %146 = getelementptr inbounds i8, ptr %140, i64 192
  %147 = load ptr, ptr %146, align 8
  %148 = getelementptr inbounds i8, ptr %140, i64 8
  %149 = load i64, ptr %148, align 8
  %150 = load ptr, ptr %1, align 8
  %151 = load ptr, ptr %150, align 8
  %152 = getelementptr inbounds i8, ptr %151, i64 24
  %153 = load i64, ptr %152, align 8
  %154 = load ptr, ptr %141, align 8
  %155 = load ptr, ptr %61, align 8
  %156 = load ptr, ptr %155, align 8
  %157 = getelementptr inbounds i8, ptr %156, i64 16
  %158 = load i64, ptr %157, align 8
  tail call fastcc void @nested(ptr noundef %139, ptr noundef %145, ptr noundef %147, i64 noundef %149, i64 noundef %153, ptr noundef %154, i64 noundef %158) #8
  %159 = fmul double %127, %3
  %160 = fadd double %159, %2
  %161 = load ptr, ptr %62, align 8
  store double %160, ptr %161, align 8
  %162 = load ptr, ptr %58, align 8
  %163 = getelementptr inbounds i8, ptr %162, i64 40
  %164 = load i64, ptr %163, align 8
  %165 = icmp eq i64 %164, 0
  br i1 %165, label %167, label %166

166:                                              ; preds = %138
  tail call fastcc void @settle(ptr noundef nonnull %58) #8
  br label %167

167:                                              ; preds = %166, %138
  %168 = load i64, ptr %63, align 8
  %169 = icmp sgt i64 %168, 0
  br i1 %169, label %170, label %171

170:                                              ; preds = %167
  tail call fastcc void @sample(ptr noundef nonnull %58) #8
  br label %171

171:                                              ; preds = %167, %170
  %172 = load ptr, ptr %9, align 8
  %173 = load i64, ptr %172, align 8
  %174 = load ptr, ptr %64, align 8
  %175 = load ptr, ptr %59, align 8
  %176 = load ptr, ptr %65, align 8
  %177 = load ptr, ptr %66, align 8
  %178 = load ptr, ptr %13, align 8
  %179 = inttoptr i64 %173 to ptr
  %180 = load ptr, ptr %179, align 8
  %181 = tail call i32 %180(ptr noundef %174, ptr noundef %175, ptr noundef %176, ptr noundef %177, ptr noundef %178) #9
  %182 = icmp slt i32 %181, 0
  br i1 %182, label %204, label %183

183:                                              ; preds = %171
  %184 = load double, ptr %15, align 8
  %185 = fmul double %184, %5
  %186 = fcmp olt double %185, 0.000000e+00
  br i1 %186, label %187, label %190

187:                                              ; preds = %183
  %188 = fcmp olt double %185, %67
  %189 = select i1 %188, double %127, double 2.000000e+00
  br label %204

190:                                              ; preds = %183
  %191 = fsub double %185, %132
  %192 = tail call double @llvm.fabs.f64(double %191)
  %193 = fcmp uge double %127, %76
  %194 = fcmp ugt double %185, %80
  %195 = or i1 %193, %194
  br i1 %195, label %196, label %204

196:                                              ; preds = %190
  br i1 %193, label %197, label %204

197:                                              ; preds = %196
  %198 = select i1 %194, double %185, double %81
  %199 = select i1 %194, double %80, double %185
  %200 = select i1 %194, double %79, double %80
  %201 = select i1 %194, double %127, double %77
  %202 = select i1 %194, double %76, double %127
  %203 = select i1 %194, double %75, double %76
  br label %204

204:                                              ; preds = %114, %187, %197, %196, %190, %171, %126, %72, %98
  %205 = phi i1 [ false, %98 ], [ false, %72 ], [ false, %114 ], [ false, %126 ], [ false, %171 ], [ false, %187 ], [ true, %197 ], [ true, %196 ], [ true, %190 ]
  %206 = phi double [ %81, %98 ], [ %81, %72 ], [ %81, %114 ], [ %81, %126 ], [ %81, %171 ], [ %81, %187 ], [ %198, %197 ], [ %81, %196 ], [ %80, %190 ]
  %207 = phi double [ %80, %98 ], [ %80, %72 ], [ %80, %114 ], [ %80, %126 ], [ %80, %171 ], [ %80, %187 ], [ %199, %197 ], [ %80, %196 ], [ %185, %190 ]
  %208 = phi double [ %79, %98 ], [ %79, %72 ], [ %79, %114 ], [ %79, %126 ], [ %79, %171 ], [ %79, %187 ], [ %200, %197 ], [ %185, %196 ], [ %79, %190 ]
  %209 = phi double [ %78, %98 ], [ %78, %72 ], [ %78, %114 ], [ %78, %126 ], [ %78, %171 ], [ %78, %187 ], [ %192, %197 ], [ %192, %196 ], [ %192, %190 ]
  %210 = phi double [ %77, %98 ], [ %77, %72 ], [ %77, %114 ], [ %77, %126 ], [ %77, %171 ], [ %77, %187 ], [ %201, %197 ], [ %77, %196 ], [ %76, %190 ]
  %211 = phi double [ %76, %98 ], [ %76, %72 ], [ %76, %114 ], [ %76, %126 ], [ %76, %171 ], [ %76, %187 ], [ %202, %197 ], [ %76, %196 ], [ %127, %190 ]
  %212 = phi double [ %75, %98 ], [ %75, %72 ], [ %75, %114 ], [ %75, %126 ], [ %75, %171 ], [ %75, %187 ], [ %203, %197 ], [ %127, %196 ], [ %75, %190 ]
  %213 = phi double [ 2.000000e+00, %98 ], [ 2.000000e+00, %72 ], [ 2.000000e+00, %114 ], [ 2.000000e+00, %126 ], [ -4.000000e+00, %171 ], [ %189, %187 ], [ %74, %197 ], [ %74, %196 ], [ %74, %190 ]
  br i1 %205, label %68, label %214

214:                                              ; preds = %68, %204
  %215 = phi i1 [ %70, %68 ], [ %73, %204 ]
  br i1 %215, label %216, label %217

216:                                              ; preds = %214
  br label %217

217:                                              ; preds = %8, %214, %216
  %218 = phi double [ 2.000000e+00, %216 ], [ %213, %214 ], [ 2.000000e+00, %8 ]
  ret double %218
}

define internal fastcc range(i32 0, 2) i32 @comes_to_side(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, ptr noundef %4, ptr noundef %5, double noundef %6, i64 noundef %7) unnamed_addr #2 {
  %9 = getelementptr inbounds i8, ptr %0, i64 768
  %10 = getelementptr inbounds i8, ptr %0, i64 936
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i64, ptr %11, i64 %7
  %13 = load i64, ptr %12, align 8
  %14 = sitofp i64 %13 to double
  %15 = load double, ptr %4, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 984
  %17 = load ptr, ptr %16, align 8
  %18 = load ptr, ptr %9, align 8
  %19 = getelementptr inbounds i8, ptr %18, i64 8
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr inbounds double, ptr %17, i64 %20
  %22 = getelementptr inbounds double, ptr %21, i64 %7
  %23 = getelementptr inbounds i8, ptr %0, i64 144
  %24 = getelementptr inbounds i8, ptr %0, i64 1032
  %25 = load ptr, ptr %24, align 8
  %26 = getelementptr inbounds i8, ptr %1, i64 16
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds i8, ptr %27, i64 96
  %29 = load ptr, ptr %28, align 8
  %30 = insertelement <8 x double> poison, double %15, i64 0
  %31 = shufflevector <8 x double> %30, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %31, ptr %29, align 8
  %32 = load ptr, ptr %27, align 8
  %33 = getelementptr inbounds i8, ptr %27, i64 192
  %34 = load ptr, ptr %33, align 8
  %35 = getelementptr inbounds i8, ptr %27, i64 8
  %36 = load i64, ptr %35, align 8
  %37 = load ptr, ptr %1, align 8
  %38 = load ptr, ptr %37, align 8
  %39 = getelementptr inbounds i8, ptr %38, i64 24
  %40 = load i64, ptr %39, align 8
  %41 = load ptr, ptr %28, align 8
  %42 = getelementptr inbounds i8, ptr %1, i64 8
  %43 = load ptr, ptr %42, align 8
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr inbounds i8, ptr %44, i64 16
  %46 = load i64, ptr %45, align 8
  tail call fastcc void @nested(ptr noundef %25, ptr noundef %32, ptr noundef %34, i64 noundef %36, i64 noundef %40, ptr noundef %41, i64 noundef %46) #8
  %47 = fmul double %15, %3
  %48 = fadd double %47, %2
  %49 = getelementptr inbounds i8, ptr %0, i64 168
  %50 = load ptr, ptr %49, align 8
  store double %48, ptr %50, align 8
  %51 = load ptr, ptr %23, align 8
  %52 = getelementptr inbounds i8, ptr %51, i64 40
  %53 = load i64, ptr %52, align 8
  %54 = icmp eq i64 %53, 0
  br i1 %54, label %56, label %55

55:                                               ; preds = %8
  tail call fastcc void @settle(ptr noundef nonnull %23) #8
  br label %56

56:                                               ; preds = %55, %8
  %57 = getelementptr inbounds i8, ptr %0, i64 248
  %58 = load i64, ptr %57, align 8
  %59 = icmp sgt i64 %58, 0
  br i1 %59, label %60, label %61

60:                                               ; preds = %56
  tail call fastcc void @sample(ptr noundef nonnull %23) #8
  br label %61

61:                                               ; preds = %56, %60
  %62 = load ptr, ptr %9, align 8
  %63 = load i64, ptr %62, align 8
  %64 = getelementptr inbounds i8, ptr %0, i64 168
  %65 = load ptr, ptr %64, align 8
  %66 = load ptr, ptr %24, align 8
  %67 = getelementptr inbounds i8, ptr %0, i64 192
  %68 = load ptr, ptr %67, align 8
  %69 = getelementptr inbounds i8, ptr %0, i64 792
  %70 = load ptr, ptr %69, align 8
  %71 = load ptr, ptr %16, align 8
  %72 = getelementptr inbounds i8, ptr %62, i64 8
  %73 = load i64, ptr %72, align 8
  %74 = getelementptr inbounds double, ptr %71, i64 %73
  %75 = inttoptr i64 %63 to ptr
  %76 = load ptr, ptr %75, align 8
  %77 = tail call i32 %76(ptr noundef %65, ptr noundef %66, ptr noundef %68, ptr noundef %70, ptr noundef %74) #9
  %78 = load double, ptr %22, align 8
  %79 = fmul double %78, %14
  %80 = fcmp ugt double %79, 0.000000e+00
  br i1 %80, label %146, label %81

81:                                               ; preds = %61
  %82 = load double, ptr %5, align 8
  %83 = fsub double %82, %15
  %84 = fmul double %83, 5.000000e-01
  %85 = fadd double %15, %84
  %86 = fsub double %85, %15
  %87 = fcmp olt double %86, %6
  br i1 %87, label %146, label %88

88:                                               ; preds = %81, %140
  %89 = phi double [ %143, %140 ], [ %85, %81 ]
  %90 = load ptr, ptr %24, align 8
  %91 = load ptr, ptr %26, align 8
  %92 = getelementptr inbounds i8, ptr %91, i64 96
  %93 = load ptr, ptr %92, align 8
  %94 = insertelement <8 x double> poison, double %89, i64 0
  %95 = shufflevector <8 x double> %94, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %95, ptr %93, align 8
  %96 = load ptr, ptr %91, align 8
  %97 = getelementptr inbounds i8, ptr %91, i64 192
  %98 = load ptr, ptr %97, align 8
  %99 = getelementptr inbounds i8, ptr %91, i64 8
  %100 = load i64, ptr %99, align 8
  %101 = load ptr, ptr %1, align 8
  %102 = load ptr, ptr %101, align 8
  %103 = getelementptr inbounds i8, ptr %102, i64 24
  %104 = load i64, ptr %103, align 8
  %105 = load ptr, ptr %92, align 8
  %106 = load ptr, ptr %42, align 8
  %107 = load ptr, ptr %106, align 8
  %108 = getelementptr inbounds i8, ptr %107, i64 16
  %109 = load i64, ptr %108, align 8
  tail call fastcc void @nested(ptr noundef %90, ptr noundef %96, ptr noundef %98, i64 noundef %100, i64 noundef %104, ptr noundef %105, i64 noundef %109) #8
  %110 = fmul double %89, %3
  %111 = fadd double %110, %2
  %112 = load ptr, ptr %49, align 8
  store double %111, ptr %112, align 8
  %113 = load ptr, ptr %23, align 8
  %114 = getelementptr inbounds i8, ptr %113, i64 40
  %115 = load i64, ptr %114, align 8
  %116 = icmp eq i64 %115, 0
  br i1 %116, label %118, label %117

117:                                              ; preds = %88
  tail call fastcc void @settle(ptr noundef nonnull %23) #8
  br label %118

118:                                              ; preds = %117, %88
  %119 = load i64, ptr %57, align 8
  %120 = icmp sgt i64 %119, 0
  br i1 %120, label %121, label %122

121:                                              ; preds = %118
  tail call fastcc void @sample(ptr noundef nonnull %23) #8
  br label %122

122:                                              ; preds = %118, %121
  %123 = load ptr, ptr %9, align 8
  %124 = load i64, ptr %123, align 8
  %125 = load ptr, ptr %64, align 8
  %126 = load ptr, ptr %24, align 8
  %127 = load ptr, ptr %67, align 8
  %128 = load ptr, ptr %69, align 8
  %129 = load ptr, ptr %16, align 8
  %130 = getelementptr inbounds i8, ptr %123, i64 8
  %131 = load i64, ptr %130, align 8
  %132 = getelementptr inbounds double, ptr %129, i64 %131
  %133 = inttoptr i64 %124 to ptr
  %134 = load ptr, ptr %133, align 8
  %135 = tail call i32 %134(ptr noundef %125, ptr noundef %126, ptr noundef %127, ptr noundef %128, ptr noundef %132) #9
  %136 = load double, ptr %22, align 8
  %137 = fmul double %136, %14
  %138 = fcmp ogt double %137, 0.000000e+00
  br i1 %138, label %139, label %140

139:                                              ; preds = %122
  store double %89, ptr %4, align 8
  br label %146

140:                                              ; preds = %122
  store double %89, ptr %5, align 8
  %141 = fsub double %89, %15
  %142 = fmul double %141, 5.000000e-01
  %143 = fadd double %15, %142
  %144 = fsub double %143, %15
  %145 = fcmp olt double %144, %6
  br i1 %145, label %146, label %88, !llvm.loop !36

146:                                              ; preds = %140, %81, %139, %61
  %147 = phi i32 [ 1, %61 ], [ 1, %139 ], [ 0, %81 ], [ 0, %140 ]
  ret i32 %147
}

define internal fastcc double @turning_place(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, double noundef %4, double noundef %5, double noundef %6, i64 noundef %7) unnamed_addr #2 {
  %9 = getelementptr inbounds i8, ptr %0, i64 768
  %10 = getelementptr inbounds i8, ptr %0, i64 144
  %11 = getelementptr inbounds i8, ptr %0, i64 1032
  %12 = getelementptr inbounds i8, ptr %1, i64 16
  %13 = getelementptr inbounds i8, ptr %1, i64 8
  %14 = getelementptr inbounds i8, ptr %0, i64 168
  %15 = getelementptr inbounds i8, ptr %0, i64 248
  %16 = getelementptr inbounds i8, ptr %0, i64 168
  %17 = getelementptr inbounds i8, ptr %0, i64 192
  %18 = getelementptr inbounds i8, ptr %0, i64 1152
  %19 = getelementptr inbounds i8, ptr %0, i64 1200
  %20 = getelementptr inbounds i8, ptr %0, i64 936
  %21 = insertelement <8 x double> poison, double %4, i64 0
  %22 = shufflevector <8 x double> %21, <8 x double> poison, <8 x i32> zeroinitializer
  %23 = fmul double %3, %4
  %24 = fadd double %23, %2
  %25 = getelementptr inbounds i8, ptr %0, i64 936
  br label %26

26:                                               ; preds = %152, %8
  %27 = phi double [ 2.000000e+00, %8 ], [ %87, %152 ]
  %28 = phi double [ %5, %8 ], [ %153, %152 ]
  %29 = phi double [ undef, %8 ], [ %151, %152 ]
  %30 = load ptr, ptr %11, align 8
  %31 = load ptr, ptr %12, align 8
  %32 = getelementptr inbounds i8, ptr %31, i64 96
  %33 = load ptr, ptr %32, align 8
  %34 = insertelement <8 x double> poison, double %28, i64 0
  %35 = shufflevector <8 x double> %34, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %35, ptr %33, align 8
  %36 = load ptr, ptr %31, align 8
  %37 = getelementptr inbounds i8, ptr %31, i64 192
  %38 = load ptr, ptr %37, align 8
  %39 = getelementptr inbounds i8, ptr %31, i64 8
  %40 = load i64, ptr %39, align 8
  %41 = load ptr, ptr %1, align 8
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds i8, ptr %42, i64 24
  %44 = load i64, ptr %43, align 8
  %45 = load ptr, ptr %32, align 8
  %46 = load ptr, ptr %13, align 8
  %47 = load ptr, ptr %46, align 8
  %48 = getelementptr inbounds i8, ptr %47, i64 16
  %49 = load i64, ptr %48, align 8
  tail call fastcc void @nested(ptr noundef %30, ptr noundef %36, ptr noundef %38, i64 noundef %40, i64 noundef %44, ptr noundef %45, i64 noundef %49) #8
  %50 = fmul double %28, %3
  %51 = fadd double %50, %2
  %52 = load ptr, ptr %14, align 8
  store double %51, ptr %52, align 8
  %53 = load ptr, ptr %10, align 8
  %54 = getelementptr inbounds i8, ptr %53, i64 40
  %55 = load i64, ptr %54, align 8
  %56 = icmp eq i64 %55, 0
  br i1 %56, label %58, label %57

57:                                               ; preds = %26
  tail call fastcc void @settle(ptr noundef nonnull %10) #8
  br label %58

58:                                               ; preds = %57, %26
  %59 = load i64, ptr %15, align 8
  %60 = icmp sgt i64 %59, 0
  br i1 %60, label %61, label %62

61:                                               ; preds = %58
  tail call fastcc void @sample(ptr noundef nonnull %10) #8
  br label %62

62:                                               ; preds = %61, %58
  %63 = load ptr, ptr %9, align 8
  %64 = getelementptr inbounds i8, ptr %63, i64 56
  %65 = load i64, ptr %64, align 8
  %66 = load ptr, ptr %16, align 8
  %67 = load ptr, ptr %11, align 8
  %68 = load ptr, ptr %17, align 8
  %69 = load ptr, ptr %18, align 8
  %70 = load ptr, ptr %19, align 8
  %71 = inttoptr i64 %65 to ptr
  %72 = load ptr, ptr %71, align 8
  %73 = tail call i32 %72(ptr noundef %66, ptr noundef %67, ptr noundef %68, ptr noundef %69, ptr noundef %70) #9
  %74 = icmp eq i32 %73, 0
  br i1 %74, label %75, label %85

75:                                               ; preds = %62
  %76 = load ptr, ptr %19, align 8
  %77 = getelementptr inbounds double, ptr %76, i64 %7
  %78 = load double, ptr %77, align 8
  %79 = load ptr, ptr %20, align 8
  %80 = getelementptr inbounds i64, ptr %79, i64 %7
  %81 = load i64, ptr %80, align 8
  %82 = sitofp i64 %81 to double
  %83 = fmul double %78, %82
  %84 = fcmp ogt double %83, 0.000000e+00
  br label %85

85:                                               ; preds = %62, %75
  %86 = phi i1 [ false, %62 ], [ %84, %75 ]
  %87 = select i1 %86, double %27, double %28
  %88 = fsub double %28, %4
  %89 = fmul double %88, 5.000000e-01
  %90 = fcmp uge double %89, %6
  %91 = select i1 %90, i1 true, i1 %86
  %92 = select i1 %90, double %29, double %87
  br i1 %91, label %150, label %93

93:                                               ; preds = %85
  %94 = load ptr, ptr %11, align 8
  %95 = load ptr, ptr %12, align 8
  %96 = getelementptr inbounds i8, ptr %95, i64 96
  %97 = load ptr, ptr %96, align 8
  store <8 x double> %22, ptr %97, align 8
  %98 = load ptr, ptr %95, align 8
  %99 = getelementptr inbounds i8, ptr %95, i64 192
  %100 = load ptr, ptr %99, align 8
  %101 = getelementptr inbounds i8, ptr %95, i64 8
  %102 = load i64, ptr %101, align 8
  %103 = load ptr, ptr %1, align 8
  %104 = load ptr, ptr %103, align 8
  %105 = getelementptr inbounds i8, ptr %104, i64 24
  %106 = load i64, ptr %105, align 8
  %107 = load ptr, ptr %96, align 8
  %108 = load ptr, ptr %13, align 8
  %109 = load ptr, ptr %108, align 8
  %110 = getelementptr inbounds i8, ptr %109, i64 16
  %111 = load i64, ptr %110, align 8
  tail call fastcc void @nested(ptr noundef %94, ptr noundef %98, ptr noundef %100, i64 noundef %102, i64 noundef %106, ptr noundef %107, i64 noundef %111) #8
  %112 = load ptr, ptr %14, align 8
  store double %24, ptr %112, align 8
  %113 = load ptr, ptr %10, align 8
  %114 = getelementptr inbounds i8, ptr %113, i64 40
  %115 = load i64, ptr %114, align 8
  %116 = icmp eq i64 %115, 0
  br i1 %116, label %118, label %117

117:                                              ; preds = %93
  tail call fastcc void @settle(ptr noundef nonnull %10) #8
  br label %118

118:                                              ; preds = %117, %93
  %119 = load i64, ptr %15, align 8
  %120 = icmp sgt i64 %119, 0
  br i1 %120, label %121, label %122

121:                                              ; preds = %118
  tail call fastcc void @sample(ptr noundef nonnull %10) #8
  br label %122

122:                                              ; preds = %121, %118
  %123 = load ptr, ptr %9, align 8
  %124 = getelementptr inbounds i8, ptr %123, i64 56
  %125 = load i64, ptr %124, align 8
  %126 = load ptr, ptr %16, align 8
  %127 = load ptr, ptr %11, align 8
  %128 = load ptr, ptr %17, align 8
  %129 = load ptr, ptr %18, align 8
  %130 = load ptr, ptr %19, align 8
  %131 = inttoptr i64 %125 to ptr
  %132 = load ptr, ptr %131, align 8
  %133 = tail call i32 %132(ptr noundef %126, ptr noundef %127, ptr noundef %128, ptr noundef %129, ptr noundef %130) #9
  %134 = icmp eq i32 %133, 0
  br i1 %134, label %135, label %146

135:                                              ; preds = %122
  %136 = load ptr, ptr %19, align 8
  %137 = getelementptr inbounds double, ptr %136, i64 %7
  %138 = load double, ptr %137, align 8
  %139 = load ptr, ptr %25, align 8
  %140 = getelementptr inbounds i64, ptr %139, i64 %7
  %141 = load i64, ptr %140, align 8
  %142 = sitofp i64 %141 to double
  %143 = fmul double %138, %142
  %144 = fcmp ogt double %143, 0.000000e+00
  %145 = zext i1 %144 to i32
  br label %146

146:                                              ; preds = %122, %135
  %147 = phi i32 [ 0, %122 ], [ %145, %135 ]
  %148 = icmp eq i32 %147, 0
  br i1 %148, label %149, label %150

149:                                              ; preds = %146
  br label %150

150:                                              ; preds = %85, %149, %146
  %151 = phi double [ %4, %149 ], [ %87, %146 ], [ %92, %85 ]
  br i1 %90, label %152, label %154

152:                                              ; preds = %150
  %153 = fadd double %89, %4
  br label %26, !llvm.loop !37

154:                                              ; preds = %150
  ret double %151
}

declare i32 @llvm.umin.i32(i32, i32) #6

declare i32 @llvm.smin.i32(i32, i32) #6

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind willreturn memory(none) }
attributes #5 = { noinline nounwind }
attributes #6 = { nounwind willreturn memory(none) }
attributes #7 = { nounwind }
attributes #8 = { nounwind }
attributes #9 = { nounwind }


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
!17 = distinct !{!17, !5}
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
!36 = distinct !{!36, !5}
!37 = distinct !{!37, !5}
