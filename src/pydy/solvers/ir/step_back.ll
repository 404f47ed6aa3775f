; sources 8ab37e690381c35d842b3222240f3e774fa0cf0a5e1a168143ca03946c9f46f5
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
  %42 = getelementptr inbounds i8, ptr %0, i64 320
  %43 = getelementptr inbounds i8, ptr %0, i64 312
  %44 = getelementptr inbounds i8, ptr %0, i64 336
  %45 = getelementptr inbounds i8, ptr %1, i64 176
  %46 = getelementptr inbounds i8, ptr %1, i64 168
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

93:                                               ; preds = %498, %2
  %94 = phi i64 [ %38, %2 ], [ %96, %498 ]
  %95 = phi i64 [ undef, %2 ], [ %499, %498 ]
  %96 = add nsw i64 %94, -1
  %97 = icmp slt i64 %94, 1
  br i1 %97, label %500, label %98

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
  br label %195

107:                                              ; preds = %195, %98
  %108 = load i64, ptr %42, align 8
  %109 = icmp eq i64 %108, 0
  br i1 %109, label %139, label %110

110:                                              ; preds = %107
  %111 = icmp sgt i64 %108, 0
  br i1 %111, label %112, label %127

112:                                              ; preds = %110
  %113 = load ptr, ptr %43, align 8
  br label %114

114:                                              ; preds = %112, %114
  %115 = phi i64 [ 0, %112 ], [ %125, %114 ]
  %116 = phi i64 [ %108, %112 ], [ %124, %114 ]
  %117 = add nuw nsw i64 %115, %116
  %118 = lshr i64 %117, 1
  %119 = mul i64 %118, 24
  %120 = getelementptr inbounds i8, ptr %113, i64 %119
  %121 = load double, ptr %120, align 8
  %122 = fcmp ogt double %121, %101
  %123 = add nuw nsw i64 %118, 1
  %124 = select i1 %122, i64 %118, i64 %116
  %125 = select i1 %122, i64 %115, i64 %123
  %126 = icmp slt i64 %125, %124
  br i1 %126, label %114, label %127, !llvm.loop !3

127:                                              ; preds = %114, %110
  %128 = phi i64 [ 0, %110 ], [ %125, %114 ]
  %129 = icmp slt i64 %128, %108
  br i1 %129, label %130, label %136

130:                                              ; preds = %127
  %131 = load ptr, ptr %43, align 8
  %132 = mul i64 %128, 24
  %133 = getelementptr inbounds i8, ptr %131, i64 %132
  %134 = getelementptr inbounds i8, ptr %133, i64 8
  %135 = load double, ptr %134, align 8
  br label %136

136:                                              ; preds = %130, %127
  %137 = phi double [ %135, %130 ], [ 0x7FF0000000000000, %127 ]
  %138 = load ptr, ptr %44, align 8
  store double %137, ptr %138, align 8
  br label %139

139:                                              ; preds = %136, %107
  %140 = load i64, ptr %45, align 8
  %141 = icmp eq i64 %140, 0
  br i1 %141, label %171, label %142

142:                                              ; preds = %139
  %143 = icmp sgt i64 %140, 0
  br i1 %143, label %144, label %159

144:                                              ; preds = %142
  %145 = load ptr, ptr %46, align 8
  br label %146

146:                                              ; preds = %144, %146
  %147 = phi i64 [ 0, %144 ], [ %157, %146 ]
  %148 = phi i64 [ %140, %144 ], [ %156, %146 ]
  %149 = add nuw nsw i64 %147, %148
  %150 = lshr i64 %149, 1
  %151 = mul i64 %150, 24
  %152 = getelementptr inbounds i8, ptr %145, i64 %151
  %153 = load double, ptr %152, align 8
  %154 = fcmp ogt double %153, %101
  %155 = add nuw nsw i64 %150, 1
  %156 = select i1 %154, i64 %150, i64 %148
  %157 = select i1 %154, i64 %147, i64 %155
  %158 = icmp slt i64 %157, %156
  br i1 %158, label %146, label %159, !llvm.loop !3

159:                                              ; preds = %146, %142
  %160 = phi i64 [ 0, %142 ], [ %157, %146 ]
  %161 = icmp slt i64 %160, %140
  br i1 %161, label %162, label %168

162:                                              ; preds = %159
  %163 = load ptr, ptr %46, align 8
  %164 = mul i64 %160, 24
  %165 = getelementptr inbounds i8, ptr %163, i64 %164
  %166 = getelementptr inbounds i8, ptr %165, i64 8
  %167 = load double, ptr %166, align 8
  br label %168

168:                                              ; preds = %162, %159
  %169 = phi double [ %167, %162 ], [ 0x7FF0000000000000, %159 ]
  %170 = load ptr, ptr %47, align 8
  store double %169, ptr %170, align 8
  br label %171

171:                                              ; preds = %168, %139
  %172 = load ptr, ptr %4, align 8
  %173 = load ptr, ptr %48, align 8
  %174 = load ptr, ptr %49, align 8
  store double %101, ptr %174, align 8
  %175 = load ptr, ptr %5, align 8
  %176 = getelementptr inbounds i8, ptr %175, i64 40
  %177 = load i64, ptr %176, align 8
  %178 = icmp eq i64 %177, 0
  br i1 %178, label %180, label %179

179:                                              ; preds = %171
  tail call fastcc void @settle(ptr noundef nonnull %5) #4
  br label %180

180:                                              ; preds = %179, %171
  %181 = load i64, ptr %50, align 8
  %182 = icmp sgt i64 %181, 0
  br i1 %182, label %183, label %184

183:                                              ; preds = %180
  tail call fastcc void @sample(ptr noundef nonnull %5) #4
  br label %184

184:                                              ; preds = %180, %183
  %185 = load ptr, ptr %5, align 8
  %186 = load i64, ptr %185, align 8
  %187 = load ptr, ptr %49, align 8
  %188 = load ptr, ptr %51, align 8
  %189 = load ptr, ptr %52, align 8
  %190 = inttoptr i64 %186 to ptr
  %191 = load ptr, ptr %190, align 8
  %192 = tail call i32 %191(ptr noundef %187, ptr noundef %172, ptr noundef %188, ptr noundef %189, ptr noundef %173) #5
  %193 = sext i32 %192 to i64
  %194 = icmp eq i32 %192, 0
  br i1 %194, label %205, label %366

195:                                              ; preds = %105, %195
  %196 = phi i64 [ 0, %105 ], [ %203, %195 ]
  %197 = load ptr, ptr %41, align 8
  %198 = getelementptr double, ptr %197, i64 %106
  %199 = getelementptr double, ptr %198, i64 %196
  %200 = load double, ptr %199, align 8
  %201 = load ptr, ptr %4, align 8
  %202 = getelementptr inbounds double, ptr %201, i64 %196
  store double %200, ptr %202, align 8
  %203 = add nuw nsw i64 %196, 1
  %204 = icmp eq i64 %203, %8
  br i1 %204, label %107, label %195, !llvm.loop !6

205:                                              ; preds = %184
  %206 = load ptr, ptr %53, align 8
  %207 = getelementptr inbounds i8, ptr %206, i64 24
  %208 = load ptr, ptr %0, align 8
  %209 = load i64, ptr %208, align 8
  %210 = load ptr, ptr %54, align 8
  %211 = insertelement <8 x double> poison, double %104, i64 0
  %212 = shufflevector <8 x double> %211, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %212, ptr %210, align 8
  %213 = icmp sgt i64 %209, 1
  br i1 %213, label %218, label %309

214:                                              ; preds = %297
  %215 = add nuw nsw i64 %221, 1
  %216 = icmp slt i64 %215, %209
  %217 = icmp eq i64 %215, %209
  br i1 %217, label %309, label %218, !llvm.loop !7

218:                                              ; preds = %205, %214
  %219 = phi i1 [ %216, %214 ], [ %213, %205 ]
  %220 = phi i64 [ %308, %214 ], [ undef, %205 ]
  %221 = phi i64 [ %215, %214 ], [ 1, %205 ]
  %222 = load ptr, ptr %55, align 8
  %223 = load ptr, ptr %4, align 8
  %224 = load ptr, ptr %5, align 8
  %225 = getelementptr inbounds i8, ptr %224, i64 16
  %226 = load i64, ptr %225, align 8
  %227 = icmp sgt i64 %226, 1
  %228 = zext i1 %227 to i64
  %229 = load ptr, ptr %56, align 8
  %230 = getelementptr inbounds i64, ptr %229, i64 %221
  %231 = load i64, ptr %230, align 8
  %232 = getelementptr i8, ptr %230, i64 8
  %233 = load i64, ptr %232, align 8
  %234 = xor i64 %231, -1
  %235 = add i64 %233, %234
  %236 = load ptr, ptr %54, align 8
  %237 = load ptr, ptr %57, align 8
  %238 = load ptr, ptr %58, align 8
  %239 = getelementptr inbounds i64, ptr %238, i64 %231
  %240 = load ptr, ptr %59, align 8
  %241 = getelementptr inbounds double, ptr %240, i64 %231
  tail call fastcc void @combine(ptr noundef %222, ptr noundef %223, ptr noundef %236, ptr noundef %237, ptr noundef %239, ptr noundef %241, i64 noundef %235, i64 noundef %228, i64 noundef %226) #4
  %242 = icmp eq i64 %226, 1
  br i1 %242, label %243, label %274

243:                                              ; preds = %218
  %244 = load ptr, ptr %56, align 8
  %245 = getelementptr i64, ptr %244, i64 %221
  %246 = getelementptr i8, ptr %245, i64 8
  %247 = load i64, ptr %246, align 8
  %248 = add nsw i64 %247, -1
  %249 = load ptr, ptr %59, align 8
  %250 = getelementptr inbounds double, ptr %249, i64 %248
  %251 = load double, ptr %250, align 8
  %252 = fmul double %104, %251
  %253 = load ptr, ptr %57, align 8
  %254 = load ptr, ptr %58, align 8
  %255 = getelementptr inbounds i64, ptr %254, i64 %248
  %256 = load i64, ptr %255, align 8
  %257 = getelementptr inbounds double, ptr %253, i64 %256
  %258 = load ptr, ptr %5, align 8
  %259 = getelementptr inbounds i8, ptr %258, i64 8
  %260 = load i64, ptr %259, align 8
  %261 = icmp sgt i64 %260, 0
  br i1 %261, label %262, label %274

262:                                              ; preds = %243, %262
  %263 = phi i64 [ %269, %262 ], [ 0, %243 ]
  %264 = getelementptr inbounds double, ptr %257, i64 %263
  %265 = load double, ptr %264, align 8
  %266 = getelementptr inbounds double, ptr %222, i64 %263
  %267 = load double, ptr %266, align 8
  %268 = tail call double @llvm.fma.f64(double %252, double %265, double %267)
  store double %268, ptr %266, align 8
  %269 = add nuw nsw i64 %263, 1
  %270 = load ptr, ptr %5, align 8
  %271 = getelementptr inbounds i8, ptr %270, i64 8
  %272 = load i64, ptr %271, align 8
  %273 = icmp slt i64 %269, %272
  br i1 %273, label %262, label %274, !llvm.loop !8

274:                                              ; preds = %262, %243, %218
  %275 = load ptr, ptr %57, align 8
  %276 = load i64, ptr %60, align 8
  %277 = mul nsw i64 %276, %221
  %278 = getelementptr inbounds double, ptr %275, i64 %277
  %279 = load i64, ptr %207, align 8
  %280 = add nsw i64 %279, 1
  store i64 %280, ptr %207, align 8
  %281 = load ptr, ptr %24, align 8
  %282 = getelementptr inbounds double, ptr %281, i64 %221
  %283 = load double, ptr %282, align 8
  %284 = fmul double %104, %283
  %285 = fadd double %101, %284
  %286 = load ptr, ptr %55, align 8
  %287 = load ptr, ptr %49, align 8
  store double %285, ptr %287, align 8
  %288 = load ptr, ptr %5, align 8
  %289 = getelementptr inbounds i8, ptr %288, i64 40
  %290 = load i64, ptr %289, align 8
  %291 = icmp eq i64 %290, 0
  br i1 %291, label %293, label %292

292:                                              ; preds = %274
  tail call fastcc void @settle(ptr noundef nonnull %5) #4
  br label %293

293:                                              ; preds = %292, %274
  %294 = load i64, ptr %50, align 8
  %295 = icmp sgt i64 %294, 0
  br i1 %295, label %296, label %297

296:                                              ; preds = %293
  tail call fastcc void @sample(ptr noundef nonnull %5) #4
  br label %297

297:                                              ; preds = %293, %296
  %298 = load ptr, ptr %5, align 8
  %299 = load i64, ptr %298, align 8
  %300 = load ptr, ptr %49, align 8
  %301 = load ptr, ptr %51, align 8
  %302 = load ptr, ptr %52, align 8
  %303 = inttoptr i64 %299 to ptr
  %304 = load ptr, ptr %303, align 8
  %305 = tail call i32 %304(ptr noundef %300, ptr noundef %286, ptr noundef %301, ptr noundef %302, ptr noundef %278) #5
  %306 = sext i32 %305 to i64
  %307 = icmp eq i32 %305, 0
  %308 = select i1 %307, i64 %220, i64 %306
  br i1 %307, label %214, label %309

309:                                              ; preds = %214, %297, %205
  %310 = phi i1 [ %213, %205 ], [ %216, %214 ], [ %219, %297 ]
  %311 = phi i64 [ 0, %205 ], [ %306, %297 ], [ %306, %214 ]
  %312 = phi i64 [ undef, %205 ], [ %308, %297 ], [ %308, %214 ]
  br i1 %310, label %366, label %313

313:                                              ; preds = %309
  %314 = load ptr, ptr %61, align 8
  %315 = load ptr, ptr %4, align 8
  %316 = load ptr, ptr %5, align 8
  %317 = getelementptr inbounds i8, ptr %316, i64 16
  %318 = load i64, ptr %317, align 8
  %319 = icmp sgt i64 %318, 1
  %320 = zext i1 %319 to i64
  %321 = load ptr, ptr %62, align 8
  %322 = getelementptr inbounds i64, ptr %321, i64 %209
  %323 = load i64, ptr %322, align 8
  %324 = getelementptr i8, ptr %322, i64 8
  %325 = load i64, ptr %324, align 8
  %326 = xor i64 %323, -1
  %327 = add i64 %325, %326
  %328 = load ptr, ptr %54, align 8
  %329 = load ptr, ptr %63, align 8
  %330 = load ptr, ptr %64, align 8
  %331 = getelementptr inbounds i64, ptr %330, i64 %323
  %332 = load ptr, ptr %65, align 8
  %333 = getelementptr inbounds double, ptr %332, i64 %323
  tail call fastcc void @combine(ptr noundef %314, ptr noundef %315, ptr noundef %328, ptr noundef %329, ptr noundef %331, ptr noundef %333, i64 noundef %327, i64 noundef %320, i64 noundef %318) #4
  %334 = icmp eq i64 %318, 1
  br i1 %334, label %335, label %366

335:                                              ; preds = %313
  %336 = load ptr, ptr %62, align 8
  %337 = getelementptr i64, ptr %336, i64 %209
  %338 = getelementptr i8, ptr %337, i64 8
  %339 = load i64, ptr %338, align 8
  %340 = add nsw i64 %339, -1
  %341 = load ptr, ptr %65, align 8
  %342 = getelementptr inbounds double, ptr %341, i64 %340
  %343 = load double, ptr %342, align 8
  %344 = fmul double %104, %343
  %345 = load ptr, ptr %63, align 8
  %346 = load ptr, ptr %64, align 8
  %347 = getelementptr inbounds i64, ptr %346, i64 %340
  %348 = load i64, ptr %347, align 8
  %349 = getelementptr inbounds double, ptr %345, i64 %348
  %350 = load ptr, ptr %5, align 8
  %351 = getelementptr inbounds i8, ptr %350, i64 8
  %352 = load i64, ptr %351, align 8
  %353 = icmp sgt i64 %352, 0
  br i1 %353, label %354, label %366

354:                                              ; preds = %335, %354
  %355 = phi i64 [ %361, %354 ], [ 0, %335 ]
  %356 = getelementptr inbounds double, ptr %349, i64 %355
  %357 = load double, ptr %356, align 8
  %358 = getelementptr inbounds double, ptr %314, i64 %355
  %359 = load double, ptr %358, align 8
  %360 = tail call double @llvm.fma.f64(double %344, double %357, double %359)
  store double %360, ptr %358, align 8
  %361 = add nuw nsw i64 %355, 1
  %362 = load ptr, ptr %5, align 8
  %363 = getelementptr inbounds i8, ptr %362, i64 8
  %364 = load i64, ptr %363, align 8
  %365 = icmp slt i64 %361, %364
  br i1 %365, label %354, label %366, !llvm.loop !8

366:                                              ; preds = %354, %335, %309, %313, %184
  %367 = phi i64 [ %193, %184 ], [ %312, %309 ], [ %311, %313 ], [ %311, %335 ], [ %311, %354 ]
  %368 = icmp eq i64 %367, 0
  %369 = select i1 %66, i1 %368, i1 false
  br i1 %369, label %370, label %378

370:                                              ; preds = %366
  %371 = mul nsw i64 %96, %14
  br label %382

372:                                              ; preds = %469, %455
  %373 = icmp sgt i64 %383, 1
  %374 = icmp eq i32 %435, 0
  %375 = select i1 %373, i1 %374, i1 false
  br i1 %375, label %382, label %376, !llvm.loop !9

376:                                              ; preds = %372
  %377 = sext i32 %435 to i64
  br label %378

378:                                              ; preds = %376, %366
  %379 = phi i64 [ %367, %366 ], [ %377, %376 ]
  %380 = phi i1 [ %368, %366 ], [ %374, %376 ]
  br i1 %380, label %381, label %478

381:                                              ; preds = %378
  br i1 %89, label %481, label %498

382:                                              ; preds = %370, %372
  %383 = phi i64 [ %14, %370 ], [ %384, %372 ]
  %384 = add nsw i64 %383, -1
  %385 = load ptr, ptr %67, align 8
  %386 = load ptr, ptr %4, align 8
  %387 = load ptr, ptr %68, align 8
  %388 = getelementptr inbounds i64, ptr %387, i64 %384
  %389 = load i64, ptr %388, align 8
  %390 = getelementptr i8, ptr %388, i64 8
  %391 = load i64, ptr %390, align 8
  %392 = xor i64 %389, -1
  %393 = add i64 %391, %392
  %394 = load ptr, ptr %69, align 8
  %395 = load ptr, ptr %70, align 8
  %396 = load ptr, ptr %71, align 8
  %397 = getelementptr inbounds i64, ptr %396, i64 %389
  %398 = load ptr, ptr %72, align 8
  %399 = getelementptr inbounds double, ptr %398, i64 %389
  tail call fastcc void @combine(ptr noundef %385, ptr noundef %386, ptr noundef %394, ptr noundef %395, ptr noundef %397, ptr noundef %399, i64 noundef %393, i64 noundef 1, i64 noundef %10) #4
  %400 = getelementptr inbounds i64, ptr %21, i64 %384
  %401 = load i64, ptr %400, align 8
  %402 = getelementptr inbounds i64, ptr %21, i64 %383
  %403 = load i64, ptr %402, align 8
  %404 = sub nsw i64 %403, %401
  %405 = load ptr, ptr %73, align 8
  %406 = load ptr, ptr %74, align 8
  %407 = load ptr, ptr %75, align 8
  %408 = getelementptr inbounds i64, ptr %23, i64 %401
  %409 = getelementptr inbounds double, ptr %27, i64 %401
  tail call fastcc void @combine(ptr noundef %405, ptr noundef %406, ptr noundef %407, ptr noundef %31, ptr noundef %408, ptr noundef %409, i64 noundef %404, i64 noundef 0, i64 noundef %10) #4
  br i1 %76, label %439, label %410

410:                                              ; preds = %439, %382
  %411 = getelementptr inbounds double, ptr %25, i64 %384
  %412 = load double, ptr %411, align 8
  %413 = fmul double %104, %412
  %414 = fadd double %101, %413
  %415 = load ptr, ptr %67, align 8
  %416 = load ptr, ptr %28, align 8
  %417 = load ptr, ptr %77, align 8
  store double %414, ptr %417, align 8
  %418 = load ptr, ptr %1, align 8
  %419 = getelementptr inbounds i8, ptr %418, i64 40
  %420 = load i64, ptr %419, align 8
  %421 = icmp eq i64 %420, 0
  br i1 %421, label %423, label %422

422:                                              ; preds = %410
  tail call fastcc void @settle(ptr noundef nonnull %1) #4
  br label %423

423:                                              ; preds = %422, %410
  %424 = load i64, ptr %78, align 8
  %425 = icmp sgt i64 %424, 0
  br i1 %425, label %426, label %427

426:                                              ; preds = %423
  tail call fastcc void @sample(ptr noundef nonnull %1) #4
  br label %427

427:                                              ; preds = %423, %426
  %428 = load ptr, ptr %1, align 8
  %429 = load i64, ptr %428, align 8
  %430 = load ptr, ptr %77, align 8
  %431 = load ptr, ptr %32, align 8
  %432 = load ptr, ptr %79, align 8
  %433 = inttoptr i64 %429 to ptr
  %434 = load ptr, ptr %433, align 8
  %435 = tail call i32 %434(ptr noundef %430, ptr noundef %415, ptr noundef %431, ptr noundef %432, ptr noundef %416) #5
  br i1 %80, label %436, label %447

436:                                              ; preds = %427
  %437 = mul nsw i64 %384, %12
  %438 = getelementptr double, ptr %31, i64 %437
  br label %448

439:                                              ; preds = %382, %439
  %440 = phi i64 [ %445, %439 ], [ 0, %382 ]
  %441 = load ptr, ptr %73, align 8
  %442 = getelementptr inbounds double, ptr %441, i64 %440
  %443 = load double, ptr %442, align 8
  %444 = getelementptr inbounds double, ptr %35, i64 %440
  store double %443, ptr %444, align 8
  %445 = add nuw nsw i64 %440, 1
  %446 = icmp eq i64 %445, %8
  br i1 %446, label %410, label %439, !llvm.loop !10

447:                                              ; preds = %448, %427
  br i1 %81, label %459, label %455

448:                                              ; preds = %436, %448
  %449 = phi i64 [ 0, %436 ], [ %453, %448 ]
  %450 = getelementptr inbounds double, ptr %29, i64 %449
  %451 = load double, ptr %450, align 8
  %452 = getelementptr double, ptr %438, i64 %449
  store double %451, ptr %452, align 8
  %453 = add nuw nsw i64 %449, 1
  %454 = icmp eq i64 %453, %8
  br i1 %454, label %447, label %448, !llvm.loop !11

455:                                              ; preds = %459, %447
  br i1 %84, label %456, label %372

456:                                              ; preds = %455
  %457 = add nsw i64 %384, %371
  %458 = mul nsw i64 %457, %19
  br label %469

459:                                              ; preds = %447, %459
  %460 = phi i64 [ %467, %459 ], [ 0, %447 ]
  %461 = getelementptr double, ptr %82, i64 %460
  %462 = load double, ptr %461, align 8
  %463 = load ptr, ptr %83, align 8
  %464 = getelementptr inbounds double, ptr %463, i64 %460
  %465 = load double, ptr %464, align 8
  %466 = fadd double %462, %465
  store double %466, ptr %464, align 8
  %467 = add nuw nsw i64 %460, 1
  %468 = icmp eq i64 %467, %17
  br i1 %468, label %455, label %459, !llvm.loop !12

469:                                              ; preds = %456, %469
  %470 = phi i64 [ 0, %456 ], [ %476, %469 ]
  %471 = getelementptr double, ptr %87, i64 %470
  %472 = load double, ptr %471, align 8
  %473 = load ptr, ptr %88, align 8
  %474 = getelementptr double, ptr %473, i64 %458
  %475 = getelementptr double, ptr %474, i64 %470
  store double %472, ptr %475, align 8
  %476 = add nuw nsw i64 %470, 1
  %477 = icmp eq i64 %476, %19
  br i1 %477, label %372, label %469, !llvm.loop !13

478:                                              ; preds = %378
  %479 = load ptr, ptr %3, align 8
  %480 = getelementptr inbounds i8, ptr %479, i64 24
  store i64 %96, ptr %480, align 8
  br label %498

481:                                              ; preds = %381, %486
  %482 = phi i64 [ %487, %486 ], [ 0, %381 ]
  br i1 %90, label %483, label %486

483:                                              ; preds = %481
  %484 = mul nsw i64 %482, %12
  %485 = getelementptr double, ptr %31, i64 %484
  br label %489

486:                                              ; preds = %489, %481
  %487 = add nuw nsw i64 %482, 1
  %488 = icmp eq i64 %487, %14
  br i1 %488, label %498, label %481, !llvm.loop !14

489:                                              ; preds = %483, %489
  %490 = phi i64 [ 0, %483 ], [ %496, %489 ]
  %491 = getelementptr double, ptr %485, i64 %490
  %492 = load double, ptr %491, align 8
  %493 = getelementptr double, ptr %92, i64 %490
  %494 = load double, ptr %493, align 8
  %495 = fadd double %492, %494
  store double %495, ptr %493, align 8
  %496 = add nuw nsw i64 %490, 1
  %497 = icmp eq i64 %496, %8
  br i1 %497, label %486, label %489, !llvm.loop !15

498:                                              ; preds = %486, %381, %478
  %499 = phi i64 [ %379, %478 ], [ %95, %381 ], [ %95, %486 ]
  br i1 %380, label %93, label %500, !llvm.loop !16

500:                                              ; preds = %93, %498
  %501 = phi i64 [ %499, %498 ], [ 0, %93 ]
  ret i64 %501
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

define internal fastcc void @settle(ptr noundef readonly %0) unnamed_addr #2 {
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
  br i1 %28, label %16, label %29, !llvm.loop !3

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
