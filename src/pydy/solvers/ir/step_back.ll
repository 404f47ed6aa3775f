; sources fffecca217773dad959341bcfbfc4f287e24b358f347116bbb0902e15c5389d6
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

87:                                               ; preds = %407, %2
  %88 = phi i64 [ %38, %2 ], [ %90, %407 ]
  %89 = phi i64 [ undef, %2 ], [ %408, %407 ]
  %90 = add nsw i64 %88, -1
  %91 = icmp slt i64 %88, 1
  br i1 %91, label %409, label %92

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
  br label %118

101:                                              ; preds = %118, %92
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
  %115 = tail call i32 %114(ptr noundef %111, ptr noundef %102, ptr noundef %112, ptr noundef %113, ptr noundef %103) #5
  %116 = sext i32 %115 to i64
  %117 = icmp eq i32 %115, 0
  br i1 %117, label %128, label %282

118:                                              ; preds = %99, %118
  %119 = phi i64 [ 0, %99 ], [ %126, %118 ]
  %120 = load ptr, ptr %41, align 8
  %121 = getelementptr double, ptr %120, i64 %100
  %122 = getelementptr double, ptr %121, i64 %119
  %123 = load double, ptr %122, align 8
  %124 = load ptr, ptr %4, align 8
  %125 = getelementptr inbounds double, ptr %124, i64 %119
  store double %123, ptr %125, align 8
  %126 = add nuw nsw i64 %119, 1
  %127 = icmp eq i64 %126, %8
  br i1 %127, label %101, label %118, !llvm.loop !3

128:                                              ; preds = %108
  %129 = load ptr, ptr %47, align 8
  %130 = getelementptr inbounds i8, ptr %129, i64 24
  %131 = load ptr, ptr %0, align 8
  %132 = load i64, ptr %131, align 8
  %133 = load ptr, ptr %48, align 8
  %134 = insertelement <8 x double> poison, double %98, i64 0
  %135 = shufflevector <8 x double> %134, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %135, ptr %133, align 8
  %136 = icmp sgt i64 %132, 1
  br i1 %136, label %141, label %225

137:                                              ; preds = %214
  %138 = add nuw nsw i64 %144, 1
  %139 = icmp slt i64 %138, %132
  %140 = icmp eq i64 %138, %132
  br i1 %140, label %225, label %141, !llvm.loop !6

141:                                              ; preds = %128, %137
  %142 = phi i1 [ %139, %137 ], [ %136, %128 ]
  %143 = phi i64 [ %224, %137 ], [ undef, %128 ]
  %144 = phi i64 [ %138, %137 ], [ 1, %128 ]
  %145 = load ptr, ptr %49, align 8
  %146 = load ptr, ptr %4, align 8
  %147 = load ptr, ptr %5, align 8
  %148 = getelementptr inbounds i8, ptr %147, i64 16
  %149 = load i64, ptr %148, align 8
  %150 = icmp sgt i64 %149, 1
  %151 = zext i1 %150 to i64
  %152 = load ptr, ptr %50, align 8
  %153 = getelementptr inbounds i64, ptr %152, i64 %144
  %154 = load i64, ptr %153, align 8
  %155 = getelementptr i8, ptr %153, i64 8
  %156 = load i64, ptr %155, align 8
  %157 = xor i64 %154, -1
  %158 = add i64 %156, %157
  %159 = load ptr, ptr %48, align 8
  %160 = load ptr, ptr %51, align 8
  %161 = load ptr, ptr %52, align 8
  %162 = getelementptr inbounds i64, ptr %161, i64 %154
  %163 = load ptr, ptr %53, align 8
  %164 = getelementptr inbounds double, ptr %163, i64 %154
  tail call fastcc void @combine(ptr noundef %145, ptr noundef %146, ptr noundef %159, ptr noundef %160, ptr noundef %162, ptr noundef %164, i64 noundef %158, i64 noundef %151, i64 noundef %149) #4
  %165 = icmp eq i64 %149, 1
  br i1 %165, label %166, label %197

166:                                              ; preds = %141
  %167 = load ptr, ptr %50, align 8
  %168 = getelementptr i64, ptr %167, i64 %144
  %169 = getelementptr i8, ptr %168, i64 8
  %170 = load i64, ptr %169, align 8
  %171 = add nsw i64 %170, -1
  %172 = load ptr, ptr %53, align 8
  %173 = getelementptr inbounds double, ptr %172, i64 %171
  %174 = load double, ptr %173, align 8
  %175 = fmul double %98, %174
  %176 = load ptr, ptr %51, align 8
  %177 = load ptr, ptr %52, align 8
  %178 = getelementptr inbounds i64, ptr %177, i64 %171
  %179 = load i64, ptr %178, align 8
  %180 = getelementptr inbounds double, ptr %176, i64 %179
  %181 = load ptr, ptr %5, align 8
  %182 = getelementptr inbounds i8, ptr %181, i64 8
  %183 = load i64, ptr %182, align 8
  %184 = icmp sgt i64 %183, 0
  br i1 %184, label %185, label %197

185:                                              ; preds = %166, %185
  %186 = phi i64 [ %192, %185 ], [ 0, %166 ]
  %187 = getelementptr inbounds double, ptr %180, i64 %186
  %188 = load double, ptr %187, align 8
  %189 = getelementptr inbounds double, ptr %145, i64 %186
  %190 = load double, ptr %189, align 8
  %191 = tail call double @llvm.fma.f64(double %175, double %188, double %190)
  store double %191, ptr %189, align 8
  %192 = add nuw nsw i64 %186, 1
  %193 = load ptr, ptr %5, align 8
  %194 = getelementptr inbounds i8, ptr %193, i64 8
  %195 = load i64, ptr %194, align 8
  %196 = icmp slt i64 %192, %195
  br i1 %196, label %185, label %197, !llvm.loop !7

197:                                              ; preds = %185, %166, %141
  %198 = load ptr, ptr %51, align 8
  %199 = load i64, ptr %54, align 8
  %200 = mul nsw i64 %199, %144
  %201 = getelementptr inbounds double, ptr %198, i64 %200
  %202 = load i64, ptr %130, align 8
  %203 = add nsw i64 %202, 1
  store i64 %203, ptr %130, align 8
  %204 = load ptr, ptr %24, align 8
  %205 = getelementptr inbounds double, ptr %204, i64 %144
  %206 = load double, ptr %205, align 8
  %207 = fmul double %98, %206
  %208 = fadd double %95, %207
  %209 = load ptr, ptr %49, align 8
  %210 = load ptr, ptr %43, align 8
  store double %208, ptr %210, align 8
  %211 = load i64, ptr %44, align 8
  %212 = icmp sgt i64 %211, 0
  br i1 %212, label %213, label %214

213:                                              ; preds = %197
  tail call fastcc void @sample(ptr noundef nonnull %5) #4
  br label %214

214:                                              ; preds = %197, %213
  %215 = load ptr, ptr %5, align 8
  %216 = load i64, ptr %215, align 8
  %217 = load ptr, ptr %43, align 8
  %218 = load ptr, ptr %45, align 8
  %219 = load ptr, ptr %46, align 8
  %220 = inttoptr i64 %216 to ptr
  %221 = tail call i32 %220(ptr noundef %217, ptr noundef %209, ptr noundef %218, ptr noundef %219, ptr noundef %201) #5
  %222 = sext i32 %221 to i64
  %223 = icmp eq i32 %221, 0
  %224 = select i1 %223, i64 %143, i64 %222
  br i1 %223, label %137, label %225

225:                                              ; preds = %137, %214, %128
  %226 = phi i1 [ %136, %128 ], [ %139, %137 ], [ %142, %214 ]
  %227 = phi i64 [ 0, %128 ], [ %222, %214 ], [ %222, %137 ]
  %228 = phi i64 [ undef, %128 ], [ %224, %214 ], [ %224, %137 ]
  br i1 %226, label %282, label %229

229:                                              ; preds = %225
  %230 = load ptr, ptr %55, align 8
  %231 = load ptr, ptr %4, align 8
  %232 = load ptr, ptr %5, align 8
  %233 = getelementptr inbounds i8, ptr %232, i64 16
  %234 = load i64, ptr %233, align 8
  %235 = icmp sgt i64 %234, 1
  %236 = zext i1 %235 to i64
  %237 = load ptr, ptr %56, align 8
  %238 = getelementptr inbounds i64, ptr %237, i64 %132
  %239 = load i64, ptr %238, align 8
  %240 = getelementptr i8, ptr %238, i64 8
  %241 = load i64, ptr %240, align 8
  %242 = xor i64 %239, -1
  %243 = add i64 %241, %242
  %244 = load ptr, ptr %48, align 8
  %245 = load ptr, ptr %57, align 8
  %246 = load ptr, ptr %58, align 8
  %247 = getelementptr inbounds i64, ptr %246, i64 %239
  %248 = load ptr, ptr %59, align 8
  %249 = getelementptr inbounds double, ptr %248, i64 %239
  tail call fastcc void @combine(ptr noundef %230, ptr noundef %231, ptr noundef %244, ptr noundef %245, ptr noundef %247, ptr noundef %249, i64 noundef %243, i64 noundef %236, i64 noundef %234) #4
  %250 = icmp eq i64 %234, 1
  br i1 %250, label %251, label %282

251:                                              ; preds = %229
  %252 = load ptr, ptr %56, align 8
  %253 = getelementptr i64, ptr %252, i64 %132
  %254 = getelementptr i8, ptr %253, i64 8
  %255 = load i64, ptr %254, align 8
  %256 = add nsw i64 %255, -1
  %257 = load ptr, ptr %59, align 8
  %258 = getelementptr inbounds double, ptr %257, i64 %256
  %259 = load double, ptr %258, align 8
  %260 = fmul double %98, %259
  %261 = load ptr, ptr %57, align 8
  %262 = load ptr, ptr %58, align 8
  %263 = getelementptr inbounds i64, ptr %262, i64 %256
  %264 = load i64, ptr %263, align 8
  %265 = getelementptr inbounds double, ptr %261, i64 %264
  %266 = load ptr, ptr %5, align 8
  %267 = getelementptr inbounds i8, ptr %266, i64 8
  %268 = load i64, ptr %267, align 8
  %269 = icmp sgt i64 %268, 0
  br i1 %269, label %270, label %282

270:                                              ; preds = %251, %270
  %271 = phi i64 [ %277, %270 ], [ 0, %251 ]
  %272 = getelementptr inbounds double, ptr %265, i64 %271
  %273 = load double, ptr %272, align 8
  %274 = getelementptr inbounds double, ptr %230, i64 %271
  %275 = load double, ptr %274, align 8
  %276 = tail call double @llvm.fma.f64(double %260, double %273, double %275)
  store double %276, ptr %274, align 8
  %277 = add nuw nsw i64 %271, 1
  %278 = load ptr, ptr %5, align 8
  %279 = getelementptr inbounds i8, ptr %278, i64 8
  %280 = load i64, ptr %279, align 8
  %281 = icmp slt i64 %277, %280
  br i1 %281, label %270, label %282, !llvm.loop !7

282:                                              ; preds = %270, %251, %225, %229, %108
  %283 = phi i64 [ %116, %108 ], [ %228, %225 ], [ %227, %229 ], [ %227, %251 ], [ %227, %270 ]
  %284 = icmp eq i64 %283, 0
  %285 = select i1 %60, i1 %284, i1 false
  br i1 %285, label %286, label %294

286:                                              ; preds = %282
  %287 = mul nsw i64 %90, %14
  br label %298

288:                                              ; preds = %378, %364
  %289 = icmp sgt i64 %299, 1
  %290 = icmp eq i32 %344, 0
  %291 = select i1 %289, i1 %290, i1 false
  br i1 %291, label %298, label %292, !llvm.loop !8

292:                                              ; preds = %288
  %293 = sext i32 %344 to i64
  br label %294

294:                                              ; preds = %292, %282
  %295 = phi i64 [ %283, %282 ], [ %293, %292 ]
  %296 = phi i1 [ %284, %282 ], [ %290, %292 ]
  br i1 %296, label %297, label %387

297:                                              ; preds = %294
  br i1 %83, label %390, label %407

298:                                              ; preds = %286, %288
  %299 = phi i64 [ %14, %286 ], [ %300, %288 ]
  %300 = add nsw i64 %299, -1
  %301 = load ptr, ptr %61, align 8
  %302 = load ptr, ptr %4, align 8
  %303 = load ptr, ptr %62, align 8
  %304 = getelementptr inbounds i64, ptr %303, i64 %300
  %305 = load i64, ptr %304, align 8
  %306 = getelementptr i8, ptr %304, i64 8
  %307 = load i64, ptr %306, align 8
  %308 = xor i64 %305, -1
  %309 = add i64 %307, %308
  %310 = load ptr, ptr %63, align 8
  %311 = load ptr, ptr %64, align 8
  %312 = load ptr, ptr %65, align 8
  %313 = getelementptr inbounds i64, ptr %312, i64 %305
  %314 = load ptr, ptr %66, align 8
  %315 = getelementptr inbounds double, ptr %314, i64 %305
  tail call fastcc void @combine(ptr noundef %301, ptr noundef %302, ptr noundef %310, ptr noundef %311, ptr noundef %313, ptr noundef %315, i64 noundef %309, i64 noundef 1, i64 noundef %10) #4
  %316 = getelementptr inbounds i64, ptr %21, i64 %300
  %317 = load i64, ptr %316, align 8
  %318 = getelementptr inbounds i64, ptr %21, i64 %299
  %319 = load i64, ptr %318, align 8
  %320 = sub nsw i64 %319, %317
  %321 = load ptr, ptr %67, align 8
  %322 = load ptr, ptr %68, align 8
  %323 = load ptr, ptr %69, align 8
  %324 = getelementptr inbounds i64, ptr %23, i64 %317
  %325 = getelementptr inbounds double, ptr %27, i64 %317
  tail call fastcc void @combine(ptr noundef %321, ptr noundef %322, ptr noundef %323, ptr noundef %31, ptr noundef %324, ptr noundef %325, i64 noundef %320, i64 noundef 0, i64 noundef %10) #4
  br i1 %70, label %348, label %326

326:                                              ; preds = %348, %298
  %327 = getelementptr inbounds double, ptr %25, i64 %300
  %328 = load double, ptr %327, align 8
  %329 = fmul double %98, %328
  %330 = fadd double %95, %329
  %331 = load ptr, ptr %61, align 8
  %332 = load ptr, ptr %28, align 8
  %333 = load ptr, ptr %71, align 8
  store double %330, ptr %333, align 8
  %334 = load i64, ptr %72, align 8
  %335 = icmp sgt i64 %334, 0
  br i1 %335, label %336, label %337

336:                                              ; preds = %326
  tail call fastcc void @sample(ptr noundef nonnull %1) #4
  br label %337

337:                                              ; preds = %326, %336
  %338 = load ptr, ptr %1, align 8
  %339 = load i64, ptr %338, align 8
  %340 = load ptr, ptr %71, align 8
  %341 = load ptr, ptr %32, align 8
  %342 = load ptr, ptr %73, align 8
  %343 = inttoptr i64 %339 to ptr
  %344 = tail call i32 %343(ptr noundef %340, ptr noundef %331, ptr noundef %341, ptr noundef %342, ptr noundef %332) #5
  br i1 %74, label %345, label %356

345:                                              ; preds = %337
  %346 = mul nsw i64 %300, %12
  %347 = getelementptr double, ptr %31, i64 %346
  br label %357

348:                                              ; preds = %298, %348
  %349 = phi i64 [ %354, %348 ], [ 0, %298 ]
  %350 = load ptr, ptr %67, align 8
  %351 = getelementptr inbounds double, ptr %350, i64 %349
  %352 = load double, ptr %351, align 8
  %353 = getelementptr inbounds double, ptr %35, i64 %349
  store double %352, ptr %353, align 8
  %354 = add nuw nsw i64 %349, 1
  %355 = icmp eq i64 %354, %8
  br i1 %355, label %326, label %348, !llvm.loop !9

356:                                              ; preds = %357, %337
  br i1 %75, label %368, label %364

357:                                              ; preds = %345, %357
  %358 = phi i64 [ 0, %345 ], [ %362, %357 ]
  %359 = getelementptr inbounds double, ptr %29, i64 %358
  %360 = load double, ptr %359, align 8
  %361 = getelementptr double, ptr %347, i64 %358
  store double %360, ptr %361, align 8
  %362 = add nuw nsw i64 %358, 1
  %363 = icmp eq i64 %362, %8
  br i1 %363, label %356, label %357, !llvm.loop !10

364:                                              ; preds = %368, %356
  br i1 %78, label %365, label %288

365:                                              ; preds = %364
  %366 = add nsw i64 %300, %287
  %367 = mul nsw i64 %366, %19
  br label %378

368:                                              ; preds = %356, %368
  %369 = phi i64 [ %376, %368 ], [ 0, %356 ]
  %370 = getelementptr double, ptr %76, i64 %369
  %371 = load double, ptr %370, align 8
  %372 = load ptr, ptr %77, align 8
  %373 = getelementptr inbounds double, ptr %372, i64 %369
  %374 = load double, ptr %373, align 8
  %375 = fadd double %371, %374
  store double %375, ptr %373, align 8
  %376 = add nuw nsw i64 %369, 1
  %377 = icmp eq i64 %376, %17
  br i1 %377, label %364, label %368, !llvm.loop !11

378:                                              ; preds = %365, %378
  %379 = phi i64 [ 0, %365 ], [ %385, %378 ]
  %380 = getelementptr double, ptr %81, i64 %379
  %381 = load double, ptr %380, align 8
  %382 = load ptr, ptr %82, align 8
  %383 = getelementptr double, ptr %382, i64 %367
  %384 = getelementptr double, ptr %383, i64 %379
  store double %381, ptr %384, align 8
  %385 = add nuw nsw i64 %379, 1
  %386 = icmp eq i64 %385, %19
  br i1 %386, label %288, label %378, !llvm.loop !12

387:                                              ; preds = %294
  %388 = load ptr, ptr %3, align 8
  %389 = getelementptr inbounds i8, ptr %388, i64 24
  store i64 %90, ptr %389, align 8
  br label %407

390:                                              ; preds = %297, %395
  %391 = phi i64 [ %396, %395 ], [ 0, %297 ]
  br i1 %84, label %392, label %395

392:                                              ; preds = %390
  %393 = mul nsw i64 %391, %12
  %394 = getelementptr double, ptr %31, i64 %393
  br label %398

395:                                              ; preds = %398, %390
  %396 = add nuw nsw i64 %391, 1
  %397 = icmp eq i64 %396, %14
  br i1 %397, label %407, label %390, !llvm.loop !13

398:                                              ; preds = %392, %398
  %399 = phi i64 [ 0, %392 ], [ %405, %398 ]
  %400 = getelementptr double, ptr %394, i64 %399
  %401 = load double, ptr %400, align 8
  %402 = getelementptr double, ptr %86, i64 %399
  %403 = load double, ptr %402, align 8
  %404 = fadd double %401, %403
  store double %404, ptr %402, align 8
  %405 = add nuw nsw i64 %399, 1
  %406 = icmp eq i64 %405, %8
  br i1 %406, label %395, label %398, !llvm.loop !14

407:                                              ; preds = %395, %297, %387
  %408 = phi i64 [ %295, %387 ], [ %89, %297 ], [ %89, %395 ]
  br i1 %296, label %87, label %409, !llvm.loop !15

409:                                              ; preds = %87, %407
  %410 = phi i64 [ %408, %407 ], [ 0, %87 ]
  ret i64 %410
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
