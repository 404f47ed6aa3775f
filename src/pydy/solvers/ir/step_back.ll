; sources be9c341e3431d8515dc9da03167b66113a00d6df6da93ad6f823dc986473a2dc
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define i64 @step_back(ptr noundef readonly %0, ptr noundef readonly %1) #0 {
  %3 = getelementptr inbounds i8, ptr %1, i64 216
  %4 = getelementptr inbounds i8, ptr %0, i64 360
  %5 = getelementptr inbounds i8, ptr %0, i64 144
  %6 = load ptr, ptr %1, align 8
  %7 = getelementptr inbounds i8, ptr %6, i64 8
  %8 = load i64, ptr %7, align 8
  %9 = getelementptr inbounds i8, ptr %6, i64 16
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %0, i64 368
  %12 = load i64, ptr %11, align 8
  %13 = load ptr, ptr %0, align 8
  %14 = load i64, ptr %13, align 8
  %15 = load ptr, ptr %3, align 8
  %16 = getelementptr inbounds i8, ptr %15, i64 8
  %17 = load i64, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %15, i64 16
  %19 = load i64, ptr %18, align 8
  %20 = getelementptr inbounds i8, ptr %1, i64 240
  %21 = load ptr, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %1, i64 264
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %0, i64 96
  %25 = load ptr, ptr %24, align 8
  %26 = getelementptr inbounds i8, ptr %1, i64 288
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds i8, ptr %1, i64 408
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds i8, ptr %1, i64 384
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds i8, ptr %1, i64 48
  %33 = load ptr, ptr %32, align 8
  %34 = load i64, ptr %15, align 8
  %35 = getelementptr inbounds double, ptr %33, i64 %34
  %36 = getelementptr inbounds i8, ptr %1, i64 312
  %37 = getelementptr inbounds i8, ptr %1, i64 320
  %38 = load i64, ptr %37, align 8
  %39 = getelementptr inbounds i8, ptr %1, i64 336
  %40 = icmp sgt i64 %8, 0
  %41 = getelementptr inbounds i8, ptr %1, i64 360
  %42 = getelementptr inbounds i8, ptr %0, i64 312
  %43 = getelementptr inbounds i8, ptr %0, i64 320
  %44 = getelementptr inbounds i8, ptr %0, i64 336
  %45 = getelementptr inbounds i8, ptr %1, i64 168
  %46 = getelementptr inbounds i8, ptr %1, i64 176
  %47 = getelementptr inbounds i8, ptr %1, i64 192
  %48 = getelementptr inbounds i8, ptr %0, i64 528
  %49 = getelementptr inbounds i8, ptr %0, i64 168
  %50 = getelementptr inbounds i8, ptr %0, i64 248
  %51 = getelementptr inbounds i8, ptr %0, i64 192
  %52 = getelementptr inbounds i8, ptr %0, i64 216
  %53 = getelementptr inbounds i8, ptr %0, i64 648
  %54 = getelementptr inbounds i8, ptr %0, i64 432
  %55 = getelementptr inbounds i8, ptr %0, i64 408
  %56 = getelementptr inbounds i8, ptr %0, i64 24
  %57 = getelementptr inbounds i8, ptr %0, i64 528
  %58 = getelementptr inbounds i8, ptr %0, i64 48
  %59 = getelementptr inbounds i8, ptr %0, i64 72
  %60 = getelementptr inbounds i8, ptr %0, i64 368
  %61 = getelementptr inbounds i8, ptr %0, i64 384
  %62 = getelementptr inbounds i8, ptr %0, i64 24
  %63 = getelementptr inbounds i8, ptr %0, i64 528
  %64 = getelementptr inbounds i8, ptr %0, i64 48
  %65 = getelementptr inbounds i8, ptr %0, i64 72
  %66 = icmp sgt i64 %14, 0
  %67 = getelementptr inbounds i8, ptr %0, i64 408
  %68 = getelementptr inbounds i8, ptr %0, i64 24
  %69 = getelementptr inbounds i8, ptr %0, i64 432
  %70 = getelementptr inbounds i8, ptr %0, i64 528
  %71 = getelementptr inbounds i8, ptr %0, i64 48
  %72 = getelementptr inbounds i8, ptr %0, i64 72
  %73 = getelementptr inbounds i8, ptr %0, i64 384
  %74 = getelementptr inbounds i8, ptr %0, i64 480
  %75 = getelementptr inbounds i8, ptr %0, i64 432
  %76 = icmp sgt i64 %8, 0
  %77 = getelementptr inbounds i8, ptr %1, i64 24
  %78 = getelementptr inbounds i8, ptr %1, i64 104
  %79 = getelementptr inbounds i8, ptr %1, i64 72
  %80 = icmp sgt i64 %8, 0
  %81 = icmp sgt i64 %17, 0
  %82 = getelementptr double, ptr %29, i64 %8
  %83 = getelementptr inbounds i8, ptr %1, i64 432
  %84 = icmp sgt i64 %19, 0
  %85 = add nsw i64 %17, %8
  %86 = sub i64 %85, %19
  %87 = getelementptr double, ptr %29, i64 %86
  %88 = getelementptr inbounds i8, ptr %1, i64 456
  %89 = icmp sgt i64 %14, 0
  %90 = icmp sgt i64 %8, 0
  %91 = mul nsw i64 %14, %12
  %92 = getelementptr double, ptr %31, i64 %91
  br label %93

93:                                               ; preds = %476, %2
  %94 = phi i64 [ %38, %2 ], [ %96, %476 ]
  %95 = phi i64 [ undef, %2 ], [ %477, %476 ]
  %96 = add nsw i64 %94, -1
  %97 = icmp slt i64 %94, 1
  br i1 %97, label %478, label %98

98:                                               ; preds = %93
  %99 = load ptr, ptr %36, align 8
  %100 = getelementptr inbounds double, ptr %99, i64 %96
  %101 = load double, ptr %100, align 8
  %102 = load ptr, ptr %39, align 8
  %103 = getelementptr inbounds double, ptr %102, i64 %96
  %104 = load double, ptr %103, align 8
  br i1 %40, label %105, label %107

105:                                              ; preds = %98
  %106 = mul nsw i64 %96, %8
  br label %185

107:                                              ; preds = %185, %98
  %108 = load ptr, ptr %42, align 8
  %109 = load i64, ptr %43, align 8
  %110 = icmp eq i64 %109, 0
  br i1 %110, label %137, label %111

111:                                              ; preds = %107
  %112 = icmp sgt i64 %109, 0
  br i1 %112, label %113, label %126

113:                                              ; preds = %111, %113
  %114 = phi i64 [ %124, %113 ], [ %109, %111 ]
  %115 = phi i64 [ %123, %113 ], [ 0, %111 ]
  %116 = add nuw nsw i64 %114, %115
  %117 = lshr i64 %116, 1
  %118 = and i64 %116, -2
  %119 = getelementptr inbounds double, ptr %108, i64 %118
  %120 = load double, ptr %119, align 8
  %121 = fcmp ogt double %120, %101
  %122 = add nuw nsw i64 %117, 1
  %123 = select i1 %121, i64 %115, i64 %122
  %124 = select i1 %121, i64 %117, i64 %114
  %125 = icmp slt i64 %123, %124
  br i1 %125, label %113, label %126, !llvm.loop !3

126:                                              ; preds = %113, %111
  %127 = phi i64 [ 0, %111 ], [ %123, %113 ]
  %128 = icmp slt i64 %127, %109
  br i1 %128, label %129, label %134

129:                                              ; preds = %126
  %130 = shl nuw nsw i64 %127, 1
  %131 = or disjoint i64 %130, 1
  %132 = getelementptr inbounds double, ptr %108, i64 %131
  %133 = load double, ptr %132, align 8
  br label %134

134:                                              ; preds = %129, %126
  %135 = phi double [ %133, %129 ], [ 0x7FF0000000000000, %126 ]
  %136 = load ptr, ptr %44, align 8
  store double %135, ptr %136, align 8
  br label %137

137:                                              ; preds = %134, %107
  %138 = load ptr, ptr %45, align 8
  %139 = load i64, ptr %46, align 8
  %140 = icmp eq i64 %139, 0
  br i1 %140, label %167, label %141

141:                                              ; preds = %137
  %142 = icmp sgt i64 %139, 0
  br i1 %142, label %143, label %156

143:                                              ; preds = %141, %143
  %144 = phi i64 [ %154, %143 ], [ %139, %141 ]
  %145 = phi i64 [ %153, %143 ], [ 0, %141 ]
  %146 = add nuw nsw i64 %144, %145
  %147 = lshr i64 %146, 1
  %148 = and i64 %146, -2
  %149 = getelementptr inbounds double, ptr %138, i64 %148
  %150 = load double, ptr %149, align 8
  %151 = fcmp ogt double %150, %101
  %152 = add nuw nsw i64 %147, 1
  %153 = select i1 %151, i64 %145, i64 %152
  %154 = select i1 %151, i64 %147, i64 %144
  %155 = icmp slt i64 %153, %154
  br i1 %155, label %143, label %156, !llvm.loop !3

156:                                              ; preds = %143, %141
  %157 = phi i64 [ 0, %141 ], [ %153, %143 ]
  %158 = icmp slt i64 %157, %139
  br i1 %158, label %159, label %164

159:                                              ; preds = %156
  %160 = shl nuw nsw i64 %157, 1
  %161 = or disjoint i64 %160, 1
  %162 = getelementptr inbounds double, ptr %138, i64 %161
  %163 = load double, ptr %162, align 8
  br label %164

164:                                              ; preds = %159, %156
  %165 = phi double [ %163, %159 ], [ 0x7FF0000000000000, %156 ]
  %166 = load ptr, ptr %47, align 8
  store double %165, ptr %166, align 8
  br label %167

167:                                              ; preds = %164, %137
  %168 = load ptr, ptr %4, align 8
  %169 = load ptr, ptr %48, align 8
  %170 = load ptr, ptr %49, align 8
  store double %101, ptr %170, align 8
  %171 = load i64, ptr %50, align 8
  %172 = icmp sgt i64 %171, 0
  br i1 %172, label %173, label %174

173:                                              ; preds = %167
  tail call fastcc void @sample(ptr noundef nonnull %5) #4
  br label %174

174:                                              ; preds = %167, %173
  %175 = load ptr, ptr %5, align 8
  %176 = load i64, ptr %175, align 8
  %177 = load ptr, ptr %49, align 8
  %178 = load ptr, ptr %51, align 8
  %179 = load ptr, ptr %52, align 8
  %180 = inttoptr i64 %176 to ptr
  %181 = load ptr, ptr %180, align 8
  %182 = tail call i32 %181(ptr noundef %177, ptr noundef %168, ptr noundef %178, ptr noundef %179, ptr noundef %169) #5
  %183 = sext i32 %182 to i64
  %184 = icmp eq i32 %182, 0
  br i1 %184, label %195, label %350

185:                                              ; preds = %105, %185
  %186 = phi i64 [ 0, %105 ], [ %193, %185 ]
  %187 = load ptr, ptr %41, align 8
  %188 = getelementptr double, ptr %187, i64 %106
  %189 = getelementptr double, ptr %188, i64 %186
  %190 = load double, ptr %189, align 8
  %191 = load ptr, ptr %4, align 8
  %192 = getelementptr inbounds double, ptr %191, i64 %186
  store double %190, ptr %192, align 8
  %193 = add nuw nsw i64 %186, 1
  %194 = icmp eq i64 %193, %8
  br i1 %194, label %107, label %185, !llvm.loop !6

195:                                              ; preds = %174
  %196 = load ptr, ptr %53, align 8
  %197 = getelementptr inbounds i8, ptr %196, i64 24
  %198 = load ptr, ptr %0, align 8
  %199 = load i64, ptr %198, align 8
  %200 = load ptr, ptr %54, align 8
  %201 = insertelement <8 x double> poison, double %104, i64 0
  %202 = shufflevector <8 x double> %201, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %202, ptr %200, align 8
  %203 = icmp sgt i64 %199, 1
  br i1 %203, label %208, label %293

204:                                              ; preds = %281
  %205 = add nuw nsw i64 %211, 1
  %206 = icmp slt i64 %205, %199
  %207 = icmp eq i64 %205, %199
  br i1 %207, label %293, label %208, !llvm.loop !7

208:                                              ; preds = %195, %204
  %209 = phi i1 [ %206, %204 ], [ %203, %195 ]
  %210 = phi i64 [ %292, %204 ], [ undef, %195 ]
  %211 = phi i64 [ %205, %204 ], [ 1, %195 ]
  %212 = load ptr, ptr %55, align 8
  %213 = load ptr, ptr %4, align 8
  %214 = load ptr, ptr %5, align 8
  %215 = getelementptr inbounds i8, ptr %214, i64 16
  %216 = load i64, ptr %215, align 8
  %217 = icmp sgt i64 %216, 1
  %218 = zext i1 %217 to i64
  %219 = load ptr, ptr %56, align 8
  %220 = getelementptr inbounds i64, ptr %219, i64 %211
  %221 = load i64, ptr %220, align 8
  %222 = getelementptr i8, ptr %220, i64 8
  %223 = load i64, ptr %222, align 8
  %224 = xor i64 %221, -1
  %225 = add i64 %223, %224
  %226 = load ptr, ptr %54, align 8
  %227 = load ptr, ptr %57, align 8
  %228 = load ptr, ptr %58, align 8
  %229 = getelementptr inbounds i64, ptr %228, i64 %221
  %230 = load ptr, ptr %59, align 8
  %231 = getelementptr inbounds double, ptr %230, i64 %221
  tail call fastcc void @combine(ptr noundef %212, ptr noundef %213, ptr noundef %226, ptr noundef %227, ptr noundef %229, ptr noundef %231, i64 noundef %225, i64 noundef %218, i64 noundef %216) #4
  %232 = icmp eq i64 %216, 1
  br i1 %232, label %233, label %264

233:                                              ; preds = %208
  %234 = load ptr, ptr %56, align 8
  %235 = getelementptr i64, ptr %234, i64 %211
  %236 = getelementptr i8, ptr %235, i64 8
  %237 = load i64, ptr %236, align 8
  %238 = add nsw i64 %237, -1
  %239 = load ptr, ptr %59, align 8
  %240 = getelementptr inbounds double, ptr %239, i64 %238
  %241 = load double, ptr %240, align 8
  %242 = fmul double %104, %241
  %243 = load ptr, ptr %57, align 8
  %244 = load ptr, ptr %58, align 8
  %245 = getelementptr inbounds i64, ptr %244, i64 %238
  %246 = load i64, ptr %245, align 8
  %247 = getelementptr inbounds double, ptr %243, i64 %246
  %248 = load ptr, ptr %5, align 8
  %249 = getelementptr inbounds i8, ptr %248, i64 8
  %250 = load i64, ptr %249, align 8
  %251 = icmp sgt i64 %250, 0
  br i1 %251, label %252, label %264

252:                                              ; preds = %233, %252
  %253 = phi i64 [ %259, %252 ], [ 0, %233 ]
  %254 = getelementptr inbounds double, ptr %247, i64 %253
  %255 = load double, ptr %254, align 8
  %256 = getelementptr inbounds double, ptr %212, i64 %253
  %257 = load double, ptr %256, align 8
  %258 = tail call double @llvm.fma.f64(double %242, double %255, double %257)
  store double %258, ptr %256, align 8
  %259 = add nuw nsw i64 %253, 1
  %260 = load ptr, ptr %5, align 8
  %261 = getelementptr inbounds i8, ptr %260, i64 8
  %262 = load i64, ptr %261, align 8
  %263 = icmp slt i64 %259, %262
  br i1 %263, label %252, label %264, !llvm.loop !8

264:                                              ; preds = %252, %233, %208
  %265 = load ptr, ptr %57, align 8
  %266 = load i64, ptr %60, align 8
  %267 = mul nsw i64 %266, %211
  %268 = getelementptr inbounds double, ptr %265, i64 %267
  %269 = load i64, ptr %197, align 8
  %270 = add nsw i64 %269, 1
  store i64 %270, ptr %197, align 8
  %271 = load ptr, ptr %24, align 8
  %272 = getelementptr inbounds double, ptr %271, i64 %211
  %273 = load double, ptr %272, align 8
  %274 = fmul double %104, %273
  %275 = fadd double %101, %274
  %276 = load ptr, ptr %55, align 8
  %277 = load ptr, ptr %49, align 8
  store double %275, ptr %277, align 8
  %278 = load i64, ptr %50, align 8
  %279 = icmp sgt i64 %278, 0
  br i1 %279, label %280, label %281

280:                                              ; preds = %264
  tail call fastcc void @sample(ptr noundef nonnull %5) #4
  br label %281

281:                                              ; preds = %264, %280
  %282 = load ptr, ptr %5, align 8
  %283 = load i64, ptr %282, align 8
  %284 = load ptr, ptr %49, align 8
  %285 = load ptr, ptr %51, align 8
  %286 = load ptr, ptr %52, align 8
  %287 = inttoptr i64 %283 to ptr
  %288 = load ptr, ptr %287, align 8
  %289 = tail call i32 %288(ptr noundef %284, ptr noundef %276, ptr noundef %285, ptr noundef %286, ptr noundef %268) #5
  %290 = sext i32 %289 to i64
  %291 = icmp eq i32 %289, 0
  %292 = select i1 %291, i64 %210, i64 %290
  br i1 %291, label %204, label %293

293:                                              ; preds = %204, %281, %195
  %294 = phi i1 [ %203, %195 ], [ %206, %204 ], [ %209, %281 ]
  %295 = phi i64 [ 0, %195 ], [ %290, %281 ], [ %290, %204 ]
  %296 = phi i64 [ undef, %195 ], [ %292, %281 ], [ %292, %204 ]
  br i1 %294, label %350, label %297

297:                                              ; preds = %293
  %298 = load ptr, ptr %61, align 8
  %299 = load ptr, ptr %4, align 8
  %300 = load ptr, ptr %5, align 8
  %301 = getelementptr inbounds i8, ptr %300, i64 16
  %302 = load i64, ptr %301, align 8
  %303 = icmp sgt i64 %302, 1
  %304 = zext i1 %303 to i64
  %305 = load ptr, ptr %62, align 8
  %306 = getelementptr inbounds i64, ptr %305, i64 %199
  %307 = load i64, ptr %306, align 8
  %308 = getelementptr i8, ptr %306, i64 8
  %309 = load i64, ptr %308, align 8
  %310 = xor i64 %307, -1
  %311 = add i64 %309, %310
  %312 = load ptr, ptr %54, align 8
  %313 = load ptr, ptr %63, align 8
  %314 = load ptr, ptr %64, align 8
  %315 = getelementptr inbounds i64, ptr %314, i64 %307
  %316 = load ptr, ptr %65, align 8
  %317 = getelementptr inbounds double, ptr %316, i64 %307
  tail call fastcc void @combine(ptr noundef %298, ptr noundef %299, ptr noundef %312, ptr noundef %313, ptr noundef %315, ptr noundef %317, i64 noundef %311, i64 noundef %304, i64 noundef %302) #4
  %318 = icmp eq i64 %302, 1
  br i1 %318, label %319, label %350

319:                                              ; preds = %297
  %320 = load ptr, ptr %62, align 8
  %321 = getelementptr i64, ptr %320, i64 %199
  %322 = getelementptr i8, ptr %321, i64 8
  %323 = load i64, ptr %322, align 8
  %324 = add nsw i64 %323, -1
  %325 = load ptr, ptr %65, align 8
  %326 = getelementptr inbounds double, ptr %325, i64 %324
  %327 = load double, ptr %326, align 8
  %328 = fmul double %104, %327
  %329 = load ptr, ptr %63, align 8
  %330 = load ptr, ptr %64, align 8
  %331 = getelementptr inbounds i64, ptr %330, i64 %324
  %332 = load i64, ptr %331, align 8
  %333 = getelementptr inbounds double, ptr %329, i64 %332
  %334 = load ptr, ptr %5, align 8
  %335 = getelementptr inbounds i8, ptr %334, i64 8
  %336 = load i64, ptr %335, align 8
  %337 = icmp sgt i64 %336, 0
  br i1 %337, label %338, label %350

338:                                              ; preds = %319, %338
  %339 = phi i64 [ %345, %338 ], [ 0, %319 ]
  %340 = getelementptr inbounds double, ptr %333, i64 %339
  %341 = load double, ptr %340, align 8
  %342 = getelementptr inbounds double, ptr %298, i64 %339
  %343 = load double, ptr %342, align 8
  %344 = tail call double @llvm.fma.f64(double %328, double %341, double %343)
  store double %344, ptr %342, align 8
  %345 = add nuw nsw i64 %339, 1
  %346 = load ptr, ptr %5, align 8
  %347 = getelementptr inbounds i8, ptr %346, i64 8
  %348 = load i64, ptr %347, align 8
  %349 = icmp slt i64 %345, %348
  br i1 %349, label %338, label %350, !llvm.loop !8

350:                                              ; preds = %338, %319, %293, %297, %174
  %351 = phi i64 [ %183, %174 ], [ %296, %293 ], [ %295, %297 ], [ %295, %319 ], [ %295, %338 ]
  %352 = icmp eq i64 %351, 0
  %353 = select i1 %66, i1 %352, i1 false
  br i1 %353, label %354, label %362

354:                                              ; preds = %350
  %355 = mul nsw i64 %96, %14
  br label %366

356:                                              ; preds = %447, %433
  %357 = icmp sgt i64 %367, 1
  %358 = icmp eq i32 %413, 0
  %359 = select i1 %357, i1 %358, i1 false
  br i1 %359, label %366, label %360, !llvm.loop !9

360:                                              ; preds = %356
  %361 = sext i32 %413 to i64
  br label %362

362:                                              ; preds = %360, %350
  %363 = phi i64 [ %351, %350 ], [ %361, %360 ]
  %364 = phi i1 [ %352, %350 ], [ %358, %360 ]
  br i1 %364, label %365, label %456

365:                                              ; preds = %362
  br i1 %89, label %459, label %476

366:                                              ; preds = %354, %356
  %367 = phi i64 [ %14, %354 ], [ %368, %356 ]
  %368 = add nsw i64 %367, -1
  %369 = load ptr, ptr %67, align 8
  %370 = load ptr, ptr %4, align 8
  %371 = load ptr, ptr %68, align 8
  %372 = getelementptr inbounds i64, ptr %371, i64 %368
  %373 = load i64, ptr %372, align 8
  %374 = getelementptr i8, ptr %372, i64 8
  %375 = load i64, ptr %374, align 8
  %376 = xor i64 %373, -1
  %377 = add i64 %375, %376
  %378 = load ptr, ptr %69, align 8
  %379 = load ptr, ptr %70, align 8
  %380 = load ptr, ptr %71, align 8
  %381 = getelementptr inbounds i64, ptr %380, i64 %373
  %382 = load ptr, ptr %72, align 8
  %383 = getelementptr inbounds double, ptr %382, i64 %373
  tail call fastcc void @combine(ptr noundef %369, ptr noundef %370, ptr noundef %378, ptr noundef %379, ptr noundef %381, ptr noundef %383, i64 noundef %377, i64 noundef 1, i64 noundef %10) #4
  %384 = getelementptr inbounds i64, ptr %21, i64 %368
  %385 = load i64, ptr %384, align 8
  %386 = getelementptr inbounds i64, ptr %21, i64 %367
  %387 = load i64, ptr %386, align 8
  %388 = sub nsw i64 %387, %385
  %389 = load ptr, ptr %73, align 8
  %390 = load ptr, ptr %74, align 8
  %391 = load ptr, ptr %75, align 8
  %392 = getelementptr inbounds i64, ptr %23, i64 %385
  %393 = getelementptr inbounds double, ptr %27, i64 %385
  tail call fastcc void @combine(ptr noundef %389, ptr noundef %390, ptr noundef %391, ptr noundef %31, ptr noundef %392, ptr noundef %393, i64 noundef %388, i64 noundef 0, i64 noundef %10) #4
  br i1 %76, label %417, label %394

394:                                              ; preds = %417, %366
  %395 = getelementptr inbounds double, ptr %25, i64 %368
  %396 = load double, ptr %395, align 8
  %397 = fmul double %104, %396
  %398 = fadd double %101, %397
  %399 = load ptr, ptr %67, align 8
  %400 = load ptr, ptr %28, align 8
  %401 = load ptr, ptr %77, align 8
  store double %398, ptr %401, align 8
  %402 = load i64, ptr %78, align 8
  %403 = icmp sgt i64 %402, 0
  br i1 %403, label %404, label %405

404:                                              ; preds = %394
  tail call fastcc void @sample(ptr noundef %1) #4
  br label %405

405:                                              ; preds = %394, %404
  %406 = load ptr, ptr %1, align 8
  %407 = load i64, ptr %406, align 8
  %408 = load ptr, ptr %77, align 8
  %409 = load ptr, ptr %32, align 8
  %410 = load ptr, ptr %79, align 8
  %411 = inttoptr i64 %407 to ptr
  %412 = load ptr, ptr %411, align 8
  %413 = tail call i32 %412(ptr noundef %408, ptr noundef %399, ptr noundef %409, ptr noundef %410, ptr noundef %400) #5
  br i1 %80, label %414, label %425

414:                                              ; preds = %405
  %415 = mul nsw i64 %368, %12
  %416 = getelementptr double, ptr %31, i64 %415
  br label %426

417:                                              ; preds = %366, %417
  %418 = phi i64 [ %423, %417 ], [ 0, %366 ]
  %419 = load ptr, ptr %73, align 8
  %420 = getelementptr inbounds double, ptr %419, i64 %418
  %421 = load double, ptr %420, align 8
  %422 = getelementptr inbounds double, ptr %35, i64 %418
  store double %421, ptr %422, align 8
  %423 = add nuw nsw i64 %418, 1
  %424 = icmp eq i64 %423, %8
  br i1 %424, label %394, label %417, !llvm.loop !10

425:                                              ; preds = %426, %405
  br i1 %81, label %437, label %433

426:                                              ; preds = %414, %426
  %427 = phi i64 [ 0, %414 ], [ %431, %426 ]
  %428 = getelementptr inbounds double, ptr %29, i64 %427
  %429 = load double, ptr %428, align 8
  %430 = getelementptr double, ptr %416, i64 %427
  store double %429, ptr %430, align 8
  %431 = add nuw nsw i64 %427, 1
  %432 = icmp eq i64 %431, %8
  br i1 %432, label %425, label %426, !llvm.loop !11

433:                                              ; preds = %437, %425
  br i1 %84, label %434, label %356

434:                                              ; preds = %433
  %435 = add nsw i64 %368, %355
  %436 = mul nsw i64 %435, %19
  br label %447

437:                                              ; preds = %425, %437
  %438 = phi i64 [ %445, %437 ], [ 0, %425 ]
  %439 = getelementptr double, ptr %82, i64 %438
  %440 = load double, ptr %439, align 8
  %441 = load ptr, ptr %83, align 8
  %442 = getelementptr inbounds double, ptr %441, i64 %438
  %443 = load double, ptr %442, align 8
  %444 = fadd double %440, %443
  store double %444, ptr %442, align 8
  %445 = add nuw nsw i64 %438, 1
  %446 = icmp eq i64 %445, %17
  br i1 %446, label %433, label %437, !llvm.loop !12

447:                                              ; preds = %434, %447
  %448 = phi i64 [ 0, %434 ], [ %454, %447 ]
  %449 = getelementptr double, ptr %87, i64 %448
  %450 = load double, ptr %449, align 8
  %451 = load ptr, ptr %88, align 8
  %452 = getelementptr double, ptr %451, i64 %436
  %453 = getelementptr double, ptr %452, i64 %448
  store double %450, ptr %453, align 8
  %454 = add nuw nsw i64 %448, 1
  %455 = icmp eq i64 %454, %19
  br i1 %455, label %356, label %447, !llvm.loop !13

456:                                              ; preds = %362
  %457 = load ptr, ptr %3, align 8
  %458 = getelementptr inbounds i8, ptr %457, i64 24
  store i64 %96, ptr %458, align 8
  br label %476

459:                                              ; preds = %365, %464
  %460 = phi i64 [ %465, %464 ], [ 0, %365 ]
  br i1 %90, label %461, label %464

461:                                              ; preds = %459
  %462 = mul nsw i64 %460, %12
  %463 = getelementptr double, ptr %31, i64 %462
  br label %467

464:                                              ; preds = %467, %459
  %465 = add nuw nsw i64 %460, 1
  %466 = icmp eq i64 %465, %14
  br i1 %466, label %476, label %459, !llvm.loop !14

467:                                              ; preds = %461, %467
  %468 = phi i64 [ 0, %461 ], [ %474, %467 ]
  %469 = getelementptr double, ptr %463, i64 %468
  %470 = load double, ptr %469, align 8
  %471 = getelementptr double, ptr %92, i64 %468
  %472 = load double, ptr %471, align 8
  %473 = fadd double %470, %472
  store double %473, ptr %471, align 8
  %474 = add nuw nsw i64 %468, 1
  %475 = icmp eq i64 %474, %8
  br i1 %475, label %464, label %467, !llvm.loop !15

476:                                              ; preds = %464, %365, %456
  %477 = phi i64 [ %363, %456 ], [ %95, %365 ], [ %95, %464 ]
  br i1 %364, label %93, label %478, !llvm.loop !16

478:                                              ; preds = %93, %476
  %479 = phi i64 [ %477, %476 ], [ 0, %93 ]
  ret i64 %479
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
  br i1 %53, label %54, label %28, !llvm.loop !17

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
  br i1 %98, label %72, label %99, !llvm.loop !18

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
  br i1 %108, label %16, label %22, !llvm.loop !19

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
  br i1 %133, label %114, label %120, !llvm.loop !17

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
  br i1 %148, label %134, label %149, !llvm.loop !18

149:                                              ; preds = %134, %114
  %150 = phi <8 x double> [ %118, %114 ], [ %146, %134 ]
  store <8 x double> %150, ptr %111, align 8
  %151 = add nuw nsw i64 %110, 8
  %152 = icmp slt i64 %151, %11
  br i1 %152, label %109, label %153, !llvm.loop !20

153:                                              ; preds = %149, %16
  ret void
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #2 {
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
  br i1 %60, label %49, label %61, !llvm.loop !21

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
  br i1 %88, label %14, label %13, !llvm.loop !22
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
!22 = distinct !{!22, !4, !5}
