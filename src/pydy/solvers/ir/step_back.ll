; sources aabdbe656e4dfe693b3bc6ae6b212fbe25fc1e2cb0d1b57c8f565133c76ec52a
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define i64 @step_back(ptr noundef readonly %0, ptr noundef readonly %1) #0 {
  %3 = getelementptr inbounds i8, ptr %1, i64 168
  %4 = getelementptr inbounds i8, ptr %0, i64 312
  %5 = getelementptr inbounds i8, ptr %0, i64 144
  %6 = load ptr, ptr %1, align 8
  %7 = getelementptr inbounds i8, ptr %6, i64 8
  %8 = load i64, ptr %7, align 8
  %9 = getelementptr inbounds i8, ptr %6, i64 16
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %0, i64 320
  %12 = load i64, ptr %11, align 8
  %13 = load ptr, ptr %0, align 8
  %14 = load i64, ptr %13, align 8
  %15 = load ptr, ptr %3, align 8
  %16 = getelementptr inbounds i8, ptr %15, i64 8
  %17 = load i64, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %15, i64 16
  %19 = load i64, ptr %18, align 8
  %20 = getelementptr inbounds i8, ptr %1, i64 192
  %21 = load ptr, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %1, i64 216
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %0, i64 96
  %25 = load ptr, ptr %24, align 8
  %26 = getelementptr inbounds i8, ptr %1, i64 240
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds i8, ptr %1, i64 360
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds i8, ptr %1, i64 336
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds i8, ptr %1, i64 48
  %33 = load ptr, ptr %32, align 8
  %34 = load i64, ptr %15, align 8
  %35 = getelementptr inbounds double, ptr %33, i64 %34
  %36 = getelementptr inbounds i8, ptr %1, i64 264
  %37 = getelementptr inbounds i8, ptr %1, i64 272
  %38 = load i64, ptr %37, align 8
  %39 = getelementptr inbounds i8, ptr %1, i64 288
  %40 = icmp sgt i64 %8, 0
  %41 = getelementptr inbounds i8, ptr %1, i64 312
  %42 = getelementptr inbounds i8, ptr %0, i64 480
  %43 = getelementptr inbounds i8, ptr %0, i64 168
  %44 = getelementptr inbounds i8, ptr %0, i64 248
  %45 = getelementptr inbounds i8, ptr %0, i64 192
  %46 = getelementptr inbounds i8, ptr %0, i64 216
  %47 = getelementptr inbounds i8, ptr %0, i64 600
  %48 = getelementptr inbounds i8, ptr %0, i64 384
  %49 = getelementptr inbounds i8, ptr %0, i64 360
  %50 = getelementptr inbounds i8, ptr %0, i64 24
  %51 = getelementptr inbounds i8, ptr %0, i64 480
  %52 = getelementptr inbounds i8, ptr %0, i64 48
  %53 = getelementptr inbounds i8, ptr %0, i64 72
  %54 = getelementptr inbounds i8, ptr %0, i64 320
  %55 = getelementptr inbounds i8, ptr %0, i64 336
  %56 = getelementptr inbounds i8, ptr %0, i64 24
  %57 = getelementptr inbounds i8, ptr %0, i64 480
  %58 = getelementptr inbounds i8, ptr %0, i64 48
  %59 = getelementptr inbounds i8, ptr %0, i64 72
  %60 = icmp sgt i64 %14, 0
  %61 = getelementptr inbounds i8, ptr %0, i64 360
  %62 = getelementptr inbounds i8, ptr %0, i64 24
  %63 = getelementptr inbounds i8, ptr %0, i64 384
  %64 = getelementptr inbounds i8, ptr %0, i64 480
  %65 = getelementptr inbounds i8, ptr %0, i64 48
  %66 = getelementptr inbounds i8, ptr %0, i64 72
  %67 = getelementptr inbounds i8, ptr %0, i64 336
  %68 = getelementptr inbounds i8, ptr %0, i64 432
  %69 = getelementptr inbounds i8, ptr %0, i64 384
  %70 = icmp sgt i64 %8, 0
  %71 = getelementptr inbounds i8, ptr %1, i64 24
  %72 = getelementptr inbounds i8, ptr %1, i64 104
  %73 = getelementptr inbounds i8, ptr %1, i64 72
  %74 = icmp sgt i64 %8, 0
  %75 = icmp sgt i64 %17, 0
  %76 = getelementptr double, ptr %29, i64 %8
  %77 = getelementptr inbounds i8, ptr %1, i64 384
  %78 = icmp sgt i64 %19, 0
  %79 = add nsw i64 %17, %8
  %80 = sub i64 %79, %19
  %81 = getelementptr double, ptr %29, i64 %80
  %82 = getelementptr inbounds i8, ptr %1, i64 408
  %83 = icmp sgt i64 %14, 0
  %84 = icmp sgt i64 %8, 0
  %85 = mul nsw i64 %14, %12
  %86 = getelementptr double, ptr %31, i64 %85
  br label %87

87:                                               ; preds = %410, %2
  %88 = phi i64 [ %38, %2 ], [ %90, %410 ]
  %89 = phi i64 [ undef, %2 ], [ %411, %410 ]
  %90 = add nsw i64 %88, -1
  %91 = icmp slt i64 %88, 1
  br i1 %91, label %412, label %92

92:                                               ; preds = %87
  %93 = load ptr, ptr %36, align 8
  %94 = getelementptr inbounds double, ptr %93, i64 %90
  %95 = load double, ptr %94, align 8
  %96 = load ptr, ptr %39, align 8
  %97 = getelementptr inbounds double, ptr %96, i64 %90
  %98 = load double, ptr %97, align 8
  br i1 %40, label %99, label %101

99:                                               ; preds = %92
  %100 = mul nsw i64 %90, %8
  br label %119

101:                                              ; preds = %119, %92
  %102 = load ptr, ptr %4, align 8
  %103 = load ptr, ptr %42, align 8
  %104 = load ptr, ptr %43, align 8
  store double %95, ptr %104, align 8
  %105 = load i64, ptr %44, align 8
  %106 = icmp sgt i64 %105, 0
  br i1 %106, label %107, label %108

107:                                              ; preds = %101
  tail call fastcc void @sample(ptr noundef nonnull %5) #4
  br label %108

108:                                              ; preds = %101, %107
  %109 = load ptr, ptr %5, align 8
  %110 = load i64, ptr %109, align 8
  %111 = load ptr, ptr %43, align 8
  %112 = load ptr, ptr %45, align 8
  %113 = load ptr, ptr %46, align 8
  %114 = inttoptr i64 %110 to ptr
  %115 = load ptr, ptr %114, align 8
  %116 = tail call i32 %115(ptr noundef %111, ptr noundef %102, ptr noundef %112, ptr noundef %113, ptr noundef %103) #5
  %117 = sext i32 %116 to i64
  %118 = icmp eq i32 %116, 0
  br i1 %118, label %129, label %284

119:                                              ; preds = %99, %119
  %120 = phi i64 [ 0, %99 ], [ %127, %119 ]
  %121 = load ptr, ptr %41, align 8
  %122 = getelementptr double, ptr %121, i64 %100
  %123 = getelementptr double, ptr %122, i64 %120
  %124 = load double, ptr %123, align 8
  %125 = load ptr, ptr %4, align 8
  %126 = getelementptr inbounds double, ptr %125, i64 %120
  store double %124, ptr %126, align 8
  %127 = add nuw nsw i64 %120, 1
  %128 = icmp eq i64 %127, %8
  br i1 %128, label %101, label %119, !llvm.loop !3

129:                                              ; preds = %108
  %130 = load ptr, ptr %47, align 8
  %131 = getelementptr inbounds i8, ptr %130, i64 24
  %132 = load ptr, ptr %0, align 8
  %133 = load i64, ptr %132, align 8
  %134 = load ptr, ptr %48, align 8
  %135 = insertelement <8 x double> poison, double %98, i64 0
  %136 = shufflevector <8 x double> %135, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %136, ptr %134, align 8
  %137 = icmp sgt i64 %133, 1
  br i1 %137, label %142, label %227

138:                                              ; preds = %215
  %139 = add nuw nsw i64 %145, 1
  %140 = icmp slt i64 %139, %133
  %141 = icmp eq i64 %139, %133
  br i1 %141, label %227, label %142, !llvm.loop !6

142:                                              ; preds = %129, %138
  %143 = phi i1 [ %140, %138 ], [ %137, %129 ]
  %144 = phi i64 [ %226, %138 ], [ undef, %129 ]
  %145 = phi i64 [ %139, %138 ], [ 1, %129 ]
  %146 = load ptr, ptr %49, align 8
  %147 = load ptr, ptr %4, align 8
  %148 = load ptr, ptr %5, align 8
  %149 = getelementptr inbounds i8, ptr %148, i64 16
  %150 = load i64, ptr %149, align 8
  %151 = icmp sgt i64 %150, 1
  %152 = zext i1 %151 to i64
  %153 = load ptr, ptr %50, align 8
  %154 = getelementptr inbounds i64, ptr %153, i64 %145
  %155 = load i64, ptr %154, align 8
  %156 = getelementptr i8, ptr %154, i64 8
  %157 = load i64, ptr %156, align 8
  %158 = xor i64 %155, -1
  %159 = add i64 %157, %158
  %160 = load ptr, ptr %48, align 8
  %161 = load ptr, ptr %51, align 8
  %162 = load ptr, ptr %52, align 8
  %163 = getelementptr inbounds i64, ptr %162, i64 %155
  %164 = load ptr, ptr %53, align 8
  %165 = getelementptr inbounds double, ptr %164, i64 %155
  tail call fastcc void @combine(ptr noundef %146, ptr noundef %147, ptr noundef %160, ptr noundef %161, ptr noundef %163, ptr noundef %165, i64 noundef %159, i64 noundef %152, i64 noundef %150) #4
  %166 = icmp eq i64 %150, 1
  br i1 %166, label %167, label %198

167:                                              ; preds = %142
  %168 = load ptr, ptr %50, align 8
  %169 = getelementptr i64, ptr %168, i64 %145
  %170 = getelementptr i8, ptr %169, i64 8
  %171 = load i64, ptr %170, align 8
  %172 = add nsw i64 %171, -1
  %173 = load ptr, ptr %53, align 8
  %174 = getelementptr inbounds double, ptr %173, i64 %172
  %175 = load double, ptr %174, align 8
  %176 = fmul double %98, %175
  %177 = load ptr, ptr %51, align 8
  %178 = load ptr, ptr %52, align 8
  %179 = getelementptr inbounds i64, ptr %178, i64 %172
  %180 = load i64, ptr %179, align 8
  %181 = getelementptr inbounds double, ptr %177, i64 %180
  %182 = load ptr, ptr %5, align 8
  %183 = getelementptr inbounds i8, ptr %182, i64 8
  %184 = load i64, ptr %183, align 8
  %185 = icmp sgt i64 %184, 0
  br i1 %185, label %186, label %198

186:                                              ; preds = %167, %186
  %187 = phi i64 [ %193, %186 ], [ 0, %167 ]
  %188 = getelementptr inbounds double, ptr %181, i64 %187
  %189 = load double, ptr %188, align 8
  %190 = getelementptr inbounds double, ptr %146, i64 %187
  %191 = load double, ptr %190, align 8
  %192 = tail call double @llvm.fma.f64(double %176, double %189, double %191)
  store double %192, ptr %190, align 8
  %193 = add nuw nsw i64 %187, 1
  %194 = load ptr, ptr %5, align 8
  %195 = getelementptr inbounds i8, ptr %194, i64 8
  %196 = load i64, ptr %195, align 8
  %197 = icmp slt i64 %193, %196
  br i1 %197, label %186, label %198, !llvm.loop !7

198:                                              ; preds = %186, %167, %142
  %199 = load ptr, ptr %51, align 8
  %200 = load i64, ptr %54, align 8
  %201 = mul nsw i64 %200, %145
  %202 = getelementptr inbounds double, ptr %199, i64 %201
  %203 = load i64, ptr %131, align 8
  %204 = add nsw i64 %203, 1
  store i64 %204, ptr %131, align 8
  %205 = load ptr, ptr %24, align 8
  %206 = getelementptr inbounds double, ptr %205, i64 %145
  %207 = load double, ptr %206, align 8
  %208 = fmul double %98, %207
  %209 = fadd double %95, %208
  %210 = load ptr, ptr %49, align 8
  %211 = load ptr, ptr %43, align 8
  store double %209, ptr %211, align 8
  %212 = load i64, ptr %44, align 8
  %213 = icmp sgt i64 %212, 0
  br i1 %213, label %214, label %215

214:                                              ; preds = %198
  tail call fastcc void @sample(ptr noundef nonnull %5) #4
  br label %215

215:                                              ; preds = %198, %214
  %216 = load ptr, ptr %5, align 8
  %217 = load i64, ptr %216, align 8
  %218 = load ptr, ptr %43, align 8
  %219 = load ptr, ptr %45, align 8
  %220 = load ptr, ptr %46, align 8
  %221 = inttoptr i64 %217 to ptr
  %222 = load ptr, ptr %221, align 8
  %223 = tail call i32 %222(ptr noundef %218, ptr noundef %210, ptr noundef %219, ptr noundef %220, ptr noundef %202) #5
  %224 = sext i32 %223 to i64
  %225 = icmp eq i32 %223, 0
  %226 = select i1 %225, i64 %144, i64 %224
  br i1 %225, label %138, label %227

227:                                              ; preds = %138, %215, %129
  %228 = phi i1 [ %137, %129 ], [ %140, %138 ], [ %143, %215 ]
  %229 = phi i64 [ 0, %129 ], [ %224, %215 ], [ %224, %138 ]
  %230 = phi i64 [ undef, %129 ], [ %226, %215 ], [ %226, %138 ]
  br i1 %228, label %284, label %231

231:                                              ; preds = %227
  %232 = load ptr, ptr %55, align 8
  %233 = load ptr, ptr %4, align 8
  %234 = load ptr, ptr %5, align 8
  %235 = getelementptr inbounds i8, ptr %234, i64 16
  %236 = load i64, ptr %235, align 8
  %237 = icmp sgt i64 %236, 1
  %238 = zext i1 %237 to i64
  %239 = load ptr, ptr %56, align 8
  %240 = getelementptr inbounds i64, ptr %239, i64 %133
  %241 = load i64, ptr %240, align 8
  %242 = getelementptr i8, ptr %240, i64 8
  %243 = load i64, ptr %242, align 8
  %244 = xor i64 %241, -1
  %245 = add i64 %243, %244
  %246 = load ptr, ptr %48, align 8
  %247 = load ptr, ptr %57, align 8
  %248 = load ptr, ptr %58, align 8
  %249 = getelementptr inbounds i64, ptr %248, i64 %241
  %250 = load ptr, ptr %59, align 8
  %251 = getelementptr inbounds double, ptr %250, i64 %241
  tail call fastcc void @combine(ptr noundef %232, ptr noundef %233, ptr noundef %246, ptr noundef %247, ptr noundef %249, ptr noundef %251, i64 noundef %245, i64 noundef %238, i64 noundef %236) #4
  %252 = icmp eq i64 %236, 1
  br i1 %252, label %253, label %284

253:                                              ; preds = %231
  %254 = load ptr, ptr %56, align 8
  %255 = getelementptr i64, ptr %254, i64 %133
  %256 = getelementptr i8, ptr %255, i64 8
  %257 = load i64, ptr %256, align 8
  %258 = add nsw i64 %257, -1
  %259 = load ptr, ptr %59, align 8
  %260 = getelementptr inbounds double, ptr %259, i64 %258
  %261 = load double, ptr %260, align 8
  %262 = fmul double %98, %261
  %263 = load ptr, ptr %57, align 8
  %264 = load ptr, ptr %58, align 8
  %265 = getelementptr inbounds i64, ptr %264, i64 %258
  %266 = load i64, ptr %265, align 8
  %267 = getelementptr inbounds double, ptr %263, i64 %266
  %268 = load ptr, ptr %5, align 8
  %269 = getelementptr inbounds i8, ptr %268, i64 8
  %270 = load i64, ptr %269, align 8
  %271 = icmp sgt i64 %270, 0
  br i1 %271, label %272, label %284

272:                                              ; preds = %253, %272
  %273 = phi i64 [ %279, %272 ], [ 0, %253 ]
  %274 = getelementptr inbounds double, ptr %267, i64 %273
  %275 = load double, ptr %274, align 8
  %276 = getelementptr inbounds double, ptr %232, i64 %273
  %277 = load double, ptr %276, align 8
  %278 = tail call double @llvm.fma.f64(double %262, double %275, double %277)
  store double %278, ptr %276, align 8
  %279 = add nuw nsw i64 %273, 1
  %280 = load ptr, ptr %5, align 8
  %281 = getelementptr inbounds i8, ptr %280, i64 8
  %282 = load i64, ptr %281, align 8
  %283 = icmp slt i64 %279, %282
  br i1 %283, label %272, label %284, !llvm.loop !7

284:                                              ; preds = %272, %253, %227, %231, %108
  %285 = phi i64 [ %117, %108 ], [ %230, %227 ], [ %229, %231 ], [ %229, %253 ], [ %229, %272 ]
  %286 = icmp eq i64 %285, 0
  %287 = select i1 %60, i1 %286, i1 false
  br i1 %287, label %288, label %296

288:                                              ; preds = %284
  %289 = mul nsw i64 %90, %14
  br label %300

290:                                              ; preds = %381, %367
  %291 = icmp sgt i64 %301, 1
  %292 = icmp eq i32 %347, 0
  %293 = select i1 %291, i1 %292, i1 false
  br i1 %293, label %300, label %294, !llvm.loop !8

294:                                              ; preds = %290
  %295 = sext i32 %347 to i64
  br label %296

296:                                              ; preds = %294, %284
  %297 = phi i64 [ %285, %284 ], [ %295, %294 ]
  %298 = phi i1 [ %286, %284 ], [ %292, %294 ]
  br i1 %298, label %299, label %390

299:                                              ; preds = %296
  br i1 %83, label %393, label %410

300:                                              ; preds = %288, %290
  %301 = phi i64 [ %14, %288 ], [ %302, %290 ]
  %302 = add nsw i64 %301, -1
  %303 = load ptr, ptr %61, align 8
  %304 = load ptr, ptr %4, align 8
  %305 = load ptr, ptr %62, align 8
  %306 = getelementptr inbounds i64, ptr %305, i64 %302
  %307 = load i64, ptr %306, align 8
  %308 = getelementptr i8, ptr %306, i64 8
  %309 = load i64, ptr %308, align 8
  %310 = xor i64 %307, -1
  %311 = add i64 %309, %310
  %312 = load ptr, ptr %63, align 8
  %313 = load ptr, ptr %64, align 8
  %314 = load ptr, ptr %65, align 8
  %315 = getelementptr inbounds i64, ptr %314, i64 %307
  %316 = load ptr, ptr %66, align 8
  %317 = getelementptr inbounds double, ptr %316, i64 %307
  tail call fastcc void @combine(ptr noundef %303, ptr noundef %304, ptr noundef %312, ptr noundef %313, ptr noundef %315, ptr noundef %317, i64 noundef %311, i64 noundef 1, i64 noundef %10) #4
  %318 = getelementptr inbounds i64, ptr %21, i64 %302
  %319 = load i64, ptr %318, align 8
  %320 = getelementptr inbounds i64, ptr %21, i64 %301
  %321 = load i64, ptr %320, align 8
  %322 = sub nsw i64 %321, %319
  %323 = load ptr, ptr %67, align 8
  %324 = load ptr, ptr %68, align 8
  %325 = load ptr, ptr %69, align 8
  %326 = getelementptr inbounds i64, ptr %23, i64 %319
  %327 = getelementptr inbounds double, ptr %27, i64 %319
  tail call fastcc void @combine(ptr noundef %323, ptr noundef %324, ptr noundef %325, ptr noundef %31, ptr noundef %326, ptr noundef %327, i64 noundef %322, i64 noundef 0, i64 noundef %10) #4
  br i1 %70, label %351, label %328

328:                                              ; preds = %351, %300
  %329 = getelementptr inbounds double, ptr %25, i64 %302
  %330 = load double, ptr %329, align 8
  %331 = fmul double %98, %330
  %332 = fadd double %95, %331
  %333 = load ptr, ptr %61, align 8
  %334 = load ptr, ptr %28, align 8
  %335 = load ptr, ptr %71, align 8
  store double %332, ptr %335, align 8
  %336 = load i64, ptr %72, align 8
  %337 = icmp sgt i64 %336, 0
  br i1 %337, label %338, label %339

338:                                              ; preds = %328
  tail call fastcc void @sample(ptr noundef nonnull %1) #4
  br label %339

339:                                              ; preds = %328, %338
  %340 = load ptr, ptr %1, align 8
  %341 = load i64, ptr %340, align 8
  %342 = load ptr, ptr %71, align 8
  %343 = load ptr, ptr %32, align 8
  %344 = load ptr, ptr %73, align 8
  %345 = inttoptr i64 %341 to ptr
  %346 = load ptr, ptr %345, align 8
  %347 = tail call i32 %346(ptr noundef %342, ptr noundef %333, ptr noundef %343, ptr noundef %344, ptr noundef %334) #5
  br i1 %74, label %348, label %359

348:                                              ; preds = %339
  %349 = mul nsw i64 %302, %12
  %350 = getelementptr double, ptr %31, i64 %349
  br label %360

351:                                              ; preds = %300, %351
  %352 = phi i64 [ %357, %351 ], [ 0, %300 ]
  %353 = load ptr, ptr %67, align 8
  %354 = getelementptr inbounds double, ptr %353, i64 %352
  %355 = load double, ptr %354, align 8
  %356 = getelementptr inbounds double, ptr %35, i64 %352
  store double %355, ptr %356, align 8
  %357 = add nuw nsw i64 %352, 1
  %358 = icmp eq i64 %357, %8
  br i1 %358, label %328, label %351, !llvm.loop !9

359:                                              ; preds = %360, %339
  br i1 %75, label %371, label %367

360:                                              ; preds = %348, %360
  %361 = phi i64 [ 0, %348 ], [ %365, %360 ]
  %362 = getelementptr inbounds double, ptr %29, i64 %361
  %363 = load double, ptr %362, align 8
  %364 = getelementptr double, ptr %350, i64 %361
  store double %363, ptr %364, align 8
  %365 = add nuw nsw i64 %361, 1
  %366 = icmp eq i64 %365, %8
  br i1 %366, label %359, label %360, !llvm.loop !10

367:                                              ; preds = %371, %359
  br i1 %78, label %368, label %290

368:                                              ; preds = %367
  %369 = add nsw i64 %302, %289
  %370 = mul nsw i64 %369, %19
  br label %381

371:                                              ; preds = %359, %371
  %372 = phi i64 [ %379, %371 ], [ 0, %359 ]
  %373 = getelementptr double, ptr %76, i64 %372
  %374 = load double, ptr %373, align 8
  %375 = load ptr, ptr %77, align 8
  %376 = getelementptr inbounds double, ptr %375, i64 %372
  %377 = load double, ptr %376, align 8
  %378 = fadd double %374, %377
  store double %378, ptr %376, align 8
  %379 = add nuw nsw i64 %372, 1
  %380 = icmp eq i64 %379, %17
  br i1 %380, label %367, label %371, !llvm.loop !11

381:                                              ; preds = %368, %381
  %382 = phi i64 [ 0, %368 ], [ %388, %381 ]
  %383 = getelementptr double, ptr %81, i64 %382
  %384 = load double, ptr %383, align 8
  %385 = load ptr, ptr %82, align 8
  %386 = getelementptr double, ptr %385, i64 %370
  %387 = getelementptr double, ptr %386, i64 %382
  store double %384, ptr %387, align 8
  %388 = add nuw nsw i64 %382, 1
  %389 = icmp eq i64 %388, %19
  br i1 %389, label %290, label %381, !llvm.loop !12

390:                                              ; preds = %296
  %391 = load ptr, ptr %3, align 8
  %392 = getelementptr inbounds i8, ptr %391, i64 24
  store i64 %90, ptr %392, align 8
  br label %410

393:                                              ; preds = %299, %398
  %394 = phi i64 [ %399, %398 ], [ 0, %299 ]
  br i1 %84, label %395, label %398

395:                                              ; preds = %393
  %396 = mul nsw i64 %394, %12
  %397 = getelementptr double, ptr %31, i64 %396
  br label %401

398:                                              ; preds = %401, %393
  %399 = add nuw nsw i64 %394, 1
  %400 = icmp eq i64 %399, %14
  br i1 %400, label %410, label %393, !llvm.loop !13

401:                                              ; preds = %395, %401
  %402 = phi i64 [ 0, %395 ], [ %408, %401 ]
  %403 = getelementptr double, ptr %397, i64 %402
  %404 = load double, ptr %403, align 8
  %405 = getelementptr double, ptr %86, i64 %402
  %406 = load double, ptr %405, align 8
  %407 = fadd double %404, %406
  store double %407, ptr %405, align 8
  %408 = add nuw nsw i64 %402, 1
  %409 = icmp eq i64 %408, %8
  br i1 %409, label %398, label %401, !llvm.loop !14

410:                                              ; preds = %398, %299, %390
  %411 = phi i64 [ %297, %390 ], [ %89, %299 ], [ %89, %398 ]
  br i1 %298, label %87, label %412, !llvm.loop !15

412:                                              ; preds = %87, %410
  %413 = phi i64 [ %411, %410 ], [ 0, %87 ]
  ret i64 %413
}

define internal fastcc void @combine(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, ptr noundef readonly %4, ptr noundef readonly %5, i64 noundef %6, i64 noundef %7, i64 noundef %8) unnamed_addr #1 {
  %10 = load <8 x double>, ptr %2, align 8
  %11 = shl nsw i64 %8, 3
  %12 = icmp slt i64 %8, 4
  br i1 %12, label %16, label %13

13:                                               ; preds = %9
  %14 = icmp sgt i64 %6, 0
  %15 = add nsw i64 %7, %6
  br label %22

16:                                               ; preds = %99, %9
  %17 = phi i64 [ 0, %9 ], [ %23, %99 ]
  %18 = icmp slt i64 %17, %11
  br i1 %18, label %19, label %153

19:                                               ; preds = %16
  %20 = icmp sgt i64 %6, 0
  %21 = add nsw i64 %7, %6
  br label %109

22:                                               ; preds = %13, %99
  %23 = phi i64 [ 32, %13 ], [ %107, %99 ]
  %24 = phi i64 [ 0, %13 ], [ %23, %99 ]
  %25 = getelementptr inbounds double, ptr %1, i64 %24
  %26 = getelementptr inbounds double, ptr %0, i64 %24
  %27 = getelementptr inbounds double, ptr %3, i64 %24
  br i1 %14, label %28, label %54

28:                                               ; preds = %22, %28
  %29 = phi <8 x double> [ %48, %28 ], [ zeroinitializer, %22 ]
  %30 = phi <8 x double> [ %45, %28 ], [ zeroinitializer, %22 ]
  %31 = phi <8 x double> [ %42, %28 ], [ zeroinitializer, %22 ]
  %32 = phi <8 x double> [ %51, %28 ], [ zeroinitializer, %22 ]
  %33 = phi i64 [ %52, %28 ], [ 0, %22 ]
  %34 = getelementptr inbounds i64, ptr %4, i64 %33
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds double, ptr %27, i64 %35
  %37 = getelementptr inbounds double, ptr %5, i64 %33
  %38 = load double, ptr %37, align 8
  %39 = insertelement <8 x double> poison, double %38, i64 0
  %40 = shufflevector <8 x double> %39, <8 x double> poison, <8 x i32> zeroinitializer
  %41 = load <8 x double>, ptr %36, align 8
  %42 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %40, <8 x double> %41, <8 x double> %31)
  %43 = getelementptr inbounds i8, ptr %36, i64 64
  %44 = load <8 x double>, ptr %43, align 8
  %45 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %40, <8 x double> %44, <8 x double> %30)
  %46 = getelementptr inbounds i8, ptr %36, i64 128
  %47 = load <8 x double>, ptr %46, align 8
  %48 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %40, <8 x double> %47, <8 x double> %29)
  %49 = getelementptr inbounds i8, ptr %36, i64 192
  %50 = load <8 x double>, ptr %49, align 8
  %51 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %40, <8 x double> %50, <8 x double> %32)
  %52 = add nuw nsw i64 %33, 1
  %53 = icmp eq i64 %52, %6
  br i1 %53, label %54, label %28, !llvm.loop !16

54:                                               ; preds = %28, %22
  %55 = phi <8 x double> [ zeroinitializer, %22 ], [ %48, %28 ]
  %56 = phi <8 x double> [ zeroinitializer, %22 ], [ %45, %28 ]
  %57 = phi <8 x double> [ zeroinitializer, %22 ], [ %42, %28 ]
  %58 = phi <8 x double> [ zeroinitializer, %22 ], [ %51, %28 ]
  %59 = phi i64 [ 0, %22 ], [ %6, %28 ]
  %60 = load <8 x double>, ptr %25, align 8
  %61 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %57, <8 x double> %60)
  %62 = getelementptr inbounds i8, ptr %25, i64 64
  %63 = load <8 x double>, ptr %62, align 8
  %64 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %56, <8 x double> %63)
  %65 = getelementptr inbounds i8, ptr %25, i64 128
  %66 = load <8 x double>, ptr %65, align 8
  %67 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %55, <8 x double> %66)
  %68 = getelementptr inbounds i8, ptr %25, i64 192
  %69 = load <8 x double>, ptr %68, align 8
  %70 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %58, <8 x double> %69)
  %71 = icmp slt i64 %59, %15
  br i1 %71, label %72, label %99

72:                                               ; preds = %54, %72
  %73 = phi <8 x double> [ %93, %72 ], [ %67, %54 ]
  %74 = phi <8 x double> [ %90, %72 ], [ %64, %54 ]
  %75 = phi <8 x double> [ %87, %72 ], [ %61, %54 ]
  %76 = phi <8 x double> [ %96, %72 ], [ %70, %54 ]
  %77 = phi i64 [ %97, %72 ], [ %59, %54 ]
  %78 = getelementptr inbounds i64, ptr %4, i64 %77
  %79 = load i64, ptr %78, align 8
  %80 = getelementptr inbounds double, ptr %27, i64 %79
  %81 = getelementptr inbounds double, ptr %5, i64 %77
  %82 = load double, ptr %81, align 8
  %83 = insertelement <8 x double> poison, double %82, i64 0
  %84 = shufflevector <8 x double> %83, <8 x double> poison, <8 x i32> zeroinitializer
  %85 = fmul <8 x double> %10, %84
  %86 = load <8 x double>, ptr %80, align 8
  %87 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %85, <8 x double> %86, <8 x double> %75)
  %88 = getelementptr inbounds i8, ptr %80, i64 64
  %89 = load <8 x double>, ptr %88, align 8
  %90 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %85, <8 x double> %89, <8 x double> %74)
  %91 = getelementptr inbounds i8, ptr %80, i64 128
  %92 = load <8 x double>, ptr %91, align 8
  %93 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %85, <8 x double> %92, <8 x double> %73)
  %94 = getelementptr inbounds i8, ptr %80, i64 192
  %95 = load <8 x double>, ptr %94, align 8
  %96 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %85, <8 x double> %95, <8 x double> %76)
  %97 = add nuw nsw i64 %77, 1
  %98 = icmp slt i64 %97, %15
  br i1 %98, label %72, label %99, !llvm.loop !17

99:                                               ; preds = %72, %54
  %100 = phi <8 x double> [ %67, %54 ], [ %93, %72 ]
  %101 = phi <8 x double> [ %64, %54 ], [ %90, %72 ]
  %102 = phi <8 x double> [ %61, %54 ], [ %87, %72 ]
  %103 = phi <8 x double> [ %70, %54 ], [ %96, %72 ]
  store <8 x double> %102, ptr %26, align 8
  %104 = getelementptr inbounds i8, ptr %26, i64 64
  store <8 x double> %101, ptr %104, align 8
  %105 = getelementptr inbounds i8, ptr %26, i64 128
  store <8 x double> %100, ptr %105, align 8
  %106 = getelementptr inbounds i8, ptr %26, i64 192
  store <8 x double> %103, ptr %106, align 8
  %107 = add nuw nsw i64 %23, 32
  %108 = icmp sgt i64 %107, %11
  br i1 %108, label %16, label %22, !llvm.loop !18

109:                                              ; preds = %19, %149
  %110 = phi i64 [ %17, %19 ], [ %151, %149 ]
  %111 = getelementptr inbounds double, ptr %0, i64 %110
  %112 = getelementptr inbounds double, ptr %1, i64 %110
  %113 = getelementptr inbounds double, ptr %3, i64 %110
  br i1 %20, label %120, label %114

114:                                              ; preds = %120, %109
  %115 = phi <8 x double> [ zeroinitializer, %109 ], [ %131, %120 ]
  %116 = phi i64 [ 0, %109 ], [ %6, %120 ]
  %117 = load <8 x double>, ptr %112, align 8
  %118 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %115, <8 x double> %117)
  %119 = icmp slt i64 %116, %21
  br i1 %119, label %134, label %149

120:                                              ; preds = %109, %120
  %121 = phi <8 x double> [ %131, %120 ], [ zeroinitializer, %109 ]
  %122 = phi i64 [ %132, %120 ], [ 0, %109 ]
  %123 = getelementptr inbounds double, ptr %5, i64 %122
  %124 = load double, ptr %123, align 8
  %125 = insertelement <8 x double> poison, double %124, i64 0
  %126 = shufflevector <8 x double> %125, <8 x double> poison, <8 x i32> zeroinitializer
  %127 = getelementptr inbounds i64, ptr %4, i64 %122
  %128 = load i64, ptr %127, align 8
  %129 = getelementptr inbounds double, ptr %113, i64 %128
  %130 = load <8 x double>, ptr %129, align 8
  %131 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %126, <8 x double> %130, <8 x double> %121)
  %132 = add nuw nsw i64 %122, 1
  %133 = icmp eq i64 %132, %6
  br i1 %133, label %114, label %120, !llvm.loop !16

134:                                              ; preds = %114, %134
  %135 = phi <8 x double> [ %146, %134 ], [ %118, %114 ]
  %136 = phi i64 [ %147, %134 ], [ %116, %114 ]
  %137 = getelementptr inbounds double, ptr %5, i64 %136
  %138 = load double, ptr %137, align 8
  %139 = insertelement <8 x double> poison, double %138, i64 0
  %140 = shufflevector <8 x double> %139, <8 x double> poison, <8 x i32> zeroinitializer
  %141 = fmul <8 x double> %10, %140
  %142 = getelementptr inbounds i64, ptr %4, i64 %136
  %143 = load i64, ptr %142, align 8
  %144 = getelementptr inbounds double, ptr %113, i64 %143
  %145 = load <8 x double>, ptr %144, align 8
  %146 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %141, <8 x double> %145, <8 x double> %135)
  %147 = add nuw nsw i64 %136, 1
  %148 = icmp slt i64 %147, %21
  br i1 %148, label %134, label %149, !llvm.loop !17

149:                                              ; preds = %134, %114
  %150 = phi <8 x double> [ %118, %114 ], [ %146, %134 ]
  store <8 x double> %150, ptr %111, align 8
  %151 = add nuw nsw i64 %110, 8
  %152 = icmp slt i64 %151, %11
  br i1 %152, label %109, label %153, !llvm.loop !19

153:                                              ; preds = %149, %16
  ret void
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #2 {
  %2 = getelementptr inbounds i8, ptr %0, i64 104
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %12

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 96
  %7 = getelementptr inbounds i8, ptr %0, i64 112
  %8 = getelementptr inbounds i8, ptr %0, i64 24
  %9 = getelementptr inbounds i8, ptr %0, i64 120
  %10 = getelementptr inbounds i8, ptr %0, i64 144
  %11 = getelementptr inbounds i8, ptr %0, i64 48
  br label %13

12:                                               ; preds = %56, %1
  ret void

13:                                               ; preds = %5, %56
  %14 = phi i64 [ 0, %5 ], [ %81, %56 ]
  %15 = load ptr, ptr %6, align 8
  %16 = load i64, ptr %7, align 8
  %17 = mul nsw i64 %16, %14
  %18 = getelementptr inbounds i64, ptr %15, i64 %17
  %19 = getelementptr inbounds i8, ptr %18, i64 24
  %20 = load ptr, ptr %8, align 8
  %21 = load double, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %18, i64 8
  %23 = load i64, ptr %22, align 8
  %24 = load ptr, ptr %9, align 8
  %25 = getelementptr inbounds double, ptr %24, i64 %23
  %26 = load double, ptr %25, align 8
  %27 = fcmp ogt double %26, %21
  %28 = select i1 %27, double %26, double %21
  %29 = getelementptr inbounds i8, ptr %18, i64 16
  %30 = load i64, ptr %29, align 8
  %31 = load i64, ptr %19, align 8
  %32 = getelementptr inbounds double, ptr %25, i64 %31
  %33 = load double, ptr %32, align 8
  %34 = fcmp ugt double %33, %28
  br i1 %34, label %42, label %35

35:                                               ; preds = %13
  %36 = add nsw i64 %30, -1
  %37 = icmp eq i64 %36, %31
  br i1 %37, label %56, label %38

38:                                               ; preds = %35
  %39 = getelementptr i8, ptr %32, i64 8
  %40 = load double, ptr %39, align 8
  %41 = fcmp ogt double %40, %28
  br i1 %41, label %56, label %42

42:                                               ; preds = %38, %13
  %43 = icmp sgt i64 %30, 1
  br i1 %43, label %44, label %56

44:                                               ; preds = %42, %44
  %45 = phi i64 [ %53, %44 ], [ %30, %42 ]
  %46 = phi i64 [ %52, %44 ], [ 0, %42 ]
  %47 = add nsw i64 %45, %46
  %48 = sdiv i64 %47, 2
  %49 = getelementptr inbounds double, ptr %25, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = fcmp ugt double %50, %28
  %52 = select i1 %51, i64 %46, i64 %48
  %53 = select i1 %51, i64 %48, i64 %45
  %54 = sub nsw i64 %53, %52
  %55 = icmp sgt i64 %54, 1
  br i1 %55, label %44, label %56, !llvm.loop !20

56:                                               ; preds = %44, %42, %35, %38
  %57 = phi i64 [ %31, %38 ], [ %31, %35 ], [ 0, %42 ], [ %52, %44 ]
  store i64 %57, ptr %19, align 8
  %58 = getelementptr inbounds double, ptr %25, i64 %57
  %59 = load double, ptr %58, align 8
  %60 = fsub double %28, %59
  %61 = load ptr, ptr %10, align 8
  %62 = add nsw i64 %57, %23
  %63 = shl nsw i64 %62, 5
  %64 = getelementptr inbounds i8, ptr %61, i64 %63
  %65 = load double, ptr %64, align 8
  %66 = getelementptr inbounds i8, ptr %64, i64 8
  %67 = load double, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %64, i64 16
  %69 = load double, ptr %68, align 8
  %70 = getelementptr inbounds i8, ptr %64, i64 24
  %71 = load double, ptr %70, align 8
  %72 = fmul double %60, %71
  %73 = fadd double %69, %72
  %74 = fmul double %60, %73
  %75 = fadd double %67, %74
  %76 = fmul double %60, %75
  %77 = fadd double %65, %76
  %78 = load ptr, ptr %11, align 8
  %79 = load i64, ptr %18, align 8
  %80 = getelementptr inbounds double, ptr %78, i64 %79
  store double %77, ptr %80, align 8
  %81 = add nuw nsw i64 %14, 1
  %82 = load i64, ptr %2, align 8
  %83 = icmp slt i64 %81, %82
  br i1 %83, label %13, label %12, !llvm.loop !21
}

declare double @llvm.fma.f64(double, double, double) #3

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #3

attributes #0 = { nounwind }
attributes #1 = { noinline nounwind }
attributes #2 = { noinline nounwind }
attributes #3 = { nounwind willreturn memory(none) }
attributes #4 = { nounwind }
attributes #5 = { nounwind }


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
