; sources 43bf3c764d0b0f01525843b71db70e8ebe737719f9369c045223c7f71de206b4
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define range(i64 0, 2) i64 @sweep_8(ptr noundef readonly %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, ptr noundef readonly %4, ptr noundef %5, ptr noundef writeonly %6, ptr noundef %7) #0 {
  %9 = alloca [5 x i64], align 16
  %10 = getelementptr inbounds i8, ptr %0, i64 88
  %11 = load i64, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 32
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %0, i64 40
  %15 = load i64, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 64
  %17 = load i64, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %0, i64 112
  %19 = load i64, ptr %18, align 8
  %20 = icmp ne i64 %19, 0
  %21 = icmp ne i64 %15, 0
  %22 = select i1 %20, i1 %21, i1 false
  %23 = getelementptr inbounds i8, ptr %0, i64 128
  %24 = getelementptr inbounds i8, ptr %0, i64 136
  %25 = load i64, ptr %24, align 8
  %26 = icmp eq i64 %25, 1
  %27 = ptrtoint ptr %7 to i64
  %28 = add i64 %27, 63
  %29 = and i64 %28, -64
  %30 = inttoptr i64 %29 to ptr
  %31 = getelementptr inbounds i8, ptr %0, i64 48
  %32 = load i64, ptr %31, align 8
  %33 = shl nsw i64 %32, 6
  %34 = getelementptr inbounds i8, ptr %30, i64 %33
  %35 = getelementptr inbounds i8, ptr %0, i64 56
  %36 = load i64, ptr %35, align 8
  %37 = shl nsw i64 %36, 6
  %38 = getelementptr inbounds i8, ptr %34, i64 %37
  %39 = getelementptr inbounds i8, ptr %38, i64 64
  %40 = getelementptr inbounds i8, ptr %0, i64 72
  %41 = load i64, ptr %40, align 8
  %42 = shl i64 %13, 6
  %43 = mul i64 %42, %41
  %44 = getelementptr inbounds i8, ptr %39, i64 %43
  %45 = shl i64 %15, 6
  %46 = mul i64 %45, %41
  %47 = getelementptr inbounds i8, ptr %44, i64 %46
  %48 = icmp slt i64 %11, 1
  br i1 %48, label %838, label %49

49:                                               ; preds = %8
  %50 = icmp sgt i64 %32, 0
  br i1 %50, label %51, label %65

51:                                               ; preds = %49, %56
  %52 = phi i64 [ %57, %56 ], [ 0, %49 ]
  %53 = getelementptr inbounds double, ptr %4, i64 %52
  %54 = shl nsw i64 %52, 6
  %55 = getelementptr inbounds i8, ptr %30, i64 %54
  br label %59

56:                                               ; preds = %59
  %57 = add nuw nsw i64 %52, 1
  %58 = icmp eq i64 %57, %32
  br i1 %58, label %65, label %51, !llvm.loop !3

59:                                               ; preds = %51, %59
  %60 = phi i64 [ 0, %51 ], [ %63, %59 ]
  %61 = load double, ptr %53, align 8
  %62 = getelementptr inbounds double, ptr %55, i64 %60
  store double %61, ptr %62, align 8
  %63 = add nuw nsw i64 %60, 1
  %64 = icmp eq i64 %63, 8
  br i1 %64, label %56, label %59, !llvm.loop !6

65:                                               ; preds = %56, %49
  %66 = getelementptr inbounds i8, ptr %0, i64 8
  %67 = load ptr, ptr %66, align 8
  tail call void %67(ptr noundef %30, ptr noundef %34) #4
  br i1 %22, label %87, label %68

68:                                               ; preds = %65
  %69 = getelementptr inbounds i8, ptr %0, i64 120
  %70 = load i64, ptr %69, align 8
  %71 = icmp sgt i64 %15, 0
  br i1 %71, label %72, label %87

72:                                               ; preds = %68, %78
  %73 = phi i64 [ %79, %78 ], [ 0, %68 ]
  %74 = mul nsw i64 %73, %70
  %75 = getelementptr inbounds double, ptr %3, i64 %74
  %76 = shl nsw i64 %73, 6
  %77 = getelementptr inbounds i8, ptr %44, i64 %76
  br label %81

78:                                               ; preds = %81
  %79 = add nuw nsw i64 %73, 1
  %80 = icmp eq i64 %79, %15
  br i1 %80, label %87, label %72, !llvm.loop !3

81:                                               ; preds = %72, %81
  %82 = phi i64 [ 0, %72 ], [ %85, %81 ]
  %83 = load double, ptr %75, align 8
  %84 = getelementptr inbounds double, ptr %77, i64 %82
  store double %83, ptr %84, align 8
  %85 = add nuw nsw i64 %82, 1
  %86 = icmp eq i64 %85, 8
  br i1 %86, label %78, label %81, !llvm.loop !6

87:                                               ; preds = %78, %68, %65
  %88 = icmp slt i64 %11, 8
  br i1 %88, label %89, label %175

89:                                               ; preds = %87
  %90 = add nsw i64 %11, -1
  %91 = icmp sgt i64 %13, 0
  %92 = icmp sgt i64 %15, 0
  %93 = select i1 %20, i1 %92, i1 false
  %94 = getelementptr inbounds i8, ptr %0, i64 96
  %95 = getelementptr inbounds i8, ptr %0, i64 104
  %96 = getelementptr inbounds i8, ptr %0, i64 120
  br label %115

97:                                               ; preds = %139
  %98 = load ptr, ptr %0, align 8
  %99 = tail call i32 %98(ptr noundef %38, ptr noundef nonnull %39, ptr noundef nonnull %44, ptr noundef %34, ptr noundef nonnull %47) #4
  %100 = sext i32 %99 to i64
  %101 = icmp eq i32 %99, 0
  br i1 %101, label %112, label %102

102:                                              ; preds = %97
  %103 = tail call i64 @llvm.smax.i64(i64 %11, i64 1)
  br label %104

104:                                              ; preds = %102, %104
  %105 = phi i64 [ %110, %104 ], [ 0, %102 ]
  %106 = lshr i64 %100, %105
  %107 = trunc i64 %106 to i8
  %108 = and i8 %107, 1
  %109 = getelementptr inbounds i8, ptr %6, i64 %105
  store i8 %108, ptr %109, align 1
  %110 = add nuw nsw i64 %105, 1
  %111 = icmp eq i64 %110, %103
  br i1 %111, label %112, label %104, !llvm.loop !7

112:                                              ; preds = %104, %97
  %113 = icmp sgt i64 %17, 0
  %114 = tail call i64 @llvm.smax.i64(i64 %11, i64 1)
  br label %156

115:                                              ; preds = %89, %139
  %116 = phi i64 [ 0, %89 ], [ %140, %139 ]
  %117 = tail call i64 @llvm.smin.i64(i64 %116, i64 %90)
  %118 = getelementptr inbounds double, ptr %1, i64 %117
  %119 = load double, ptr %118, align 8
  %120 = getelementptr inbounds double, ptr %38, i64 %116
  store double %119, ptr %120, align 8
  br i1 %91, label %121, label %123

121:                                              ; preds = %115
  %122 = getelementptr inbounds double, ptr %39, i64 %116
  br label %126

123:                                              ; preds = %126, %115
  br i1 %93, label %124, label %139

124:                                              ; preds = %123
  %125 = getelementptr inbounds double, ptr %44, i64 %116
  br label %142

126:                                              ; preds = %121, %126
  %127 = phi i64 [ %137, %126 ], [ 0, %121 ]
  %128 = load i64, ptr %94, align 8
  %129 = mul nsw i64 %128, %117
  %130 = load i64, ptr %95, align 8
  %131 = mul nsw i64 %130, %127
  %132 = getelementptr double, ptr %2, i64 %129
  %133 = getelementptr double, ptr %132, i64 %131
  %134 = load double, ptr %133, align 8
  %135 = shl nsw i64 %127, 6
  %136 = getelementptr inbounds i8, ptr %122, i64 %135
  store double %134, ptr %136, align 8
  %137 = add nuw nsw i64 %127, 1
  %138 = icmp eq i64 %137, %13
  br i1 %138, label %123, label %126, !llvm.loop !8

139:                                              ; preds = %142, %123
  %140 = add nuw nsw i64 %116, 1
  %141 = icmp eq i64 %140, 8
  br i1 %141, label %97, label %115, !llvm.loop !10

142:                                              ; preds = %124, %142
  %143 = phi i64 [ %153, %142 ], [ 0, %124 ]
  %144 = load i64, ptr %18, align 8
  %145 = mul nsw i64 %144, %117
  %146 = load i64, ptr %96, align 8
  %147 = mul nsw i64 %146, %143
  %148 = getelementptr double, ptr %3, i64 %145
  %149 = getelementptr double, ptr %148, i64 %147
  %150 = load double, ptr %149, align 8
  %151 = shl nsw i64 %143, 6
  %152 = getelementptr inbounds i8, ptr %125, i64 %151
  store double %150, ptr %152, align 8
  %153 = add nuw nsw i64 %143, 1
  %154 = icmp slt i64 %153, %15
  %155 = select i1 %22, i1 %154, i1 false
  br i1 %155, label %142, label %139, !llvm.loop !11

156:                                              ; preds = %112, %159
  %157 = phi i64 [ 0, %112 ], [ %160, %159 ]
  %158 = getelementptr inbounds double, ptr %47, i64 %157
  br i1 %113, label %162, label %159

159:                                              ; preds = %162, %156
  %160 = add nuw nsw i64 %157, 1
  %161 = icmp eq i64 %160, %114
  br i1 %161, label %838, label %156, !llvm.loop !12

162:                                              ; preds = %156, %162
  %163 = phi i64 [ %173, %162 ], [ 0, %156 ]
  %164 = shl nsw i64 %163, 6
  %165 = getelementptr inbounds i8, ptr %158, i64 %164
  %166 = load double, ptr %165, align 8
  %167 = load i64, ptr %23, align 8
  %168 = mul nsw i64 %167, %157
  %169 = load i64, ptr %24, align 8
  %170 = mul nsw i64 %169, %163
  %171 = getelementptr double, ptr %5, i64 %168
  %172 = getelementptr double, ptr %171, i64 %170
  store double %166, ptr %172, align 8
  %173 = add nuw nsw i64 %163, 1
  %174 = icmp eq i64 %173, %17
  br i1 %174, label %159, label %162, !llvm.loop !13

175:                                              ; preds = %87
  %176 = getelementptr inbounds i8, ptr %0, i64 96
  %177 = getelementptr inbounds i8, ptr %0, i64 104
  %178 = load i64, ptr %177, align 8
  %179 = icmp eq i64 %178, 1
  %180 = select i1 %179, i1 true, i1 %26
  %181 = xor i1 %22, true
  %182 = select i1 %180, i1 true, i1 %181
  %183 = xor i1 %180, true
  br i1 %182, label %188, label %184

184:                                              ; preds = %175
  %185 = getelementptr inbounds i8, ptr %0, i64 120
  %186 = load i64, ptr %185, align 8
  %187 = icmp ne i64 %186, 1
  br label %188

188:                                              ; preds = %175, %184
  %189 = phi i1 [ %183, %175 ], [ %187, %184 ]
  %190 = getelementptr inbounds i8, ptr %0, i64 80
  %191 = load i64, ptr %190, align 8
  %192 = icmp sgt i64 %11, %191
  br i1 %192, label %193, label %204

193:                                              ; preds = %188
  %194 = add nsw i64 %15, %13
  %195 = add nsw i64 %194, %17
  %196 = shl nsw i64 %178, 3
  %197 = sub nsw i64 0, %196
  %198 = and i64 %196, %197
  %199 = tail call i64 @llvm.smin.i64(i64 %198, i64 4096)
  %200 = tail call i64 @llvm.smax.i64(i64 %199, i64 64)
  %201 = udiv i64 4096, %200
  %202 = shl nuw nsw i64 %201, 2
  %203 = icmp sge i64 %202, %195
  br label %204

204:                                              ; preds = %193, %188
  %205 = phi i1 [ true, %188 ], [ %203, %193 ]
  %206 = getelementptr inbounds i8, ptr %0, i64 16
  %207 = load ptr, ptr %206, align 8
  %208 = icmp ne ptr %207, null
  %209 = select i1 %208, i1 %189, i1 false
  %210 = select i1 %209, i1 %205, i1 false
  br i1 %210, label %211, label %273

211:                                              ; preds = %204
  %212 = select i1 %22, ptr %3, ptr %44
  %213 = load i64, ptr %10, align 8
  %214 = add nsw i64 %213, -8
  %215 = ptrtoint ptr %2 to i64
  %216 = lshr i64 %215, 3
  %217 = and i64 %216, 7
  %218 = load i64, ptr %18, align 8
  %219 = icmp eq i64 %218, 0
  %220 = select i1 %219, i64 0, i64 8
  store i64 %178, ptr %9, align 16
  %221 = getelementptr inbounds i8, ptr %9, i64 8
  br i1 %219, label %225, label %222

222:                                              ; preds = %211
  %223 = getelementptr inbounds i8, ptr %0, i64 120
  %224 = load i64, ptr %223, align 8
  br label %225

225:                                              ; preds = %222, %211
  %226 = phi i64 [ %224, %222 ], [ 8, %211 ]
  store i64 %226, ptr %221, align 8
  %227 = getelementptr inbounds i8, ptr %9, i64 16
  %228 = load i64, ptr %24, align 8
  store i64 %228, ptr %227, align 16
  %229 = getelementptr inbounds i8, ptr %9, i64 24
  store i64 1, ptr %229, align 8
  %230 = getelementptr inbounds i8, ptr %9, i64 32
  store i64 %220, ptr %230, align 16
  %231 = getelementptr i8, ptr %6, i64 -8
  %232 = icmp sgt i64 %213, 0
  br i1 %232, label %233, label %272

233:                                              ; preds = %225
  %234 = icmp sgt i64 %213, 8
  %235 = sub nuw nsw i64 8, %217
  br label %236

236:                                              ; preds = %233, %268
  %237 = phi i64 [ 0, %233 ], [ %270, %268 ]
  %238 = call i64 @llvm.smin.i64(i64 %237, i64 %214)
  %239 = icmp eq i64 %237, 0
  br i1 %239, label %243, label %240

240:                                              ; preds = %236
  %241 = sub nsw i64 %213, %238
  %242 = sdiv i64 %241, 8
  store i64 %242, ptr %229, align 8
  br label %243

243:                                              ; preds = %240, %236
  %244 = load i64, ptr %18, align 8
  %245 = icmp eq i64 %244, 0
  %246 = select i1 %245, i64 0, i64 %238
  %247 = getelementptr inbounds double, ptr %212, i64 %246
  %248 = load ptr, ptr %206, align 8
  %249 = getelementptr inbounds double, ptr %1, i64 %238
  %250 = getelementptr inbounds double, ptr %2, i64 %238
  %251 = getelementptr inbounds double, ptr %5, i64 %238
  %252 = call i64 %248(ptr noundef %249, ptr noundef %250, ptr noundef %247, ptr noundef %34, ptr noundef %251, ptr noundef nonnull %9) #4
  %253 = ashr i64 %252, 29
  %254 = and i64 %253, -8
  %255 = add nsw i64 %254, %238
  %256 = shl i64 %252, 32
  %257 = ashr exact i64 %256, 32
  %258 = getelementptr i8, ptr %231, i64 %255
  %259 = icmp eq i64 %256, 0
  br i1 %259, label %268, label %260

260:                                              ; preds = %243, %260
  %261 = phi i64 [ %266, %260 ], [ 0, %243 ]
  %262 = lshr i64 %257, %261
  %263 = trunc i64 %262 to i8
  %264 = and i8 %263, 1
  %265 = getelementptr inbounds i8, ptr %258, i64 %261
  store i8 %264, ptr %265, align 1
  %266 = add nuw nsw i64 %261, 1
  %267 = icmp eq i64 %266, 8
  br i1 %267, label %268, label %260, !llvm.loop !7

268:                                              ; preds = %260, %243
  %269 = select i1 %239, i1 %234, i1 false
  %270 = select i1 %269, i64 %235, i64 %255
  %271 = icmp slt i64 %270, %213
  br i1 %271, label %236, label %272, !llvm.loop !14

272:                                              ; preds = %268, %225
  br label %838

273:                                              ; preds = %204
  %274 = select i1 %179, i1 %26, i1 false
  %275 = select i1 %274, i1 %22, i1 false
  br i1 %275, label %276, label %280

276:                                              ; preds = %273
  %277 = getelementptr inbounds i8, ptr %0, i64 120
  %278 = load i64, ptr %277, align 8
  %279 = icmp eq i64 %278, 1
  br label %280

280:                                              ; preds = %273, %276
  %281 = phi i1 [ %274, %273 ], [ %279, %276 ]
  br i1 %281, label %284, label %282

282:                                              ; preds = %280
  %283 = load i64, ptr %40, align 8
  br label %284

284:                                              ; preds = %282, %280
  %285 = phi i64 [ %283, %282 ], [ 1, %280 ]
  %286 = add nsw i64 %11, -8
  %287 = icmp sgt i64 %13, 0
  %288 = shl i64 %13, 6
  %289 = icmp sgt i64 %13, 3
  %290 = add nsw i64 %13, -4
  %291 = getelementptr inbounds i8, ptr %0, i64 120
  %292 = icmp sgt i64 %15, 0
  %293 = shl i64 %15, 6
  %294 = icmp sgt i64 %15, 3
  %295 = add nsw i64 %15, -4
  %296 = shl i64 %15, 6
  %297 = shl i64 %17, 6
  %298 = icmp slt i64 %13, 257
  %299 = icmp sgt i64 %13, 0
  %300 = icmp slt i64 %17, 257
  %301 = icmp sgt i64 %17, 0
  %302 = shl i64 %13, 6
  %303 = icmp sgt i64 %17, 0
  %304 = icmp sgt i64 %17, 3
  %305 = add nsw i64 %17, -4
  %306 = icmp sgt i64 %17, 0
  %307 = getelementptr i8, ptr %47, i64 64
  %308 = getelementptr i8, ptr %47, i64 128
  %309 = getelementptr i8, ptr %47, i64 192
  br label %310

310:                                              ; preds = %284, %809
  %311 = phi i64 [ 0, %284 ], [ %811, %809 ]
  %312 = phi <8 x i64> [ zeroinitializer, %284 ], [ %602, %809 ]
  %313 = sub nsw i64 %11, %311
  %314 = sdiv i64 %313, 8
  %315 = tail call i64 @llvm.smin.i64(i64 %285, i64 %314)
  %316 = icmp eq i64 %315, 0
  %317 = select i1 %316, i64 %286, i64 %311
  %318 = tail call i64 @llvm.umax.i64(i64 %315, i64 1)
  %319 = load i64, ptr %176, align 8
  %320 = mul nsw i64 %319, %317
  %321 = getelementptr inbounds double, ptr %2, i64 %320
  %322 = load i64, ptr %177, align 8
  %323 = icmp eq i64 %322, 1
  br i1 %323, label %327, label %324

324:                                              ; preds = %310
  br i1 %287, label %325, label %458

325:                                              ; preds = %324
  %326 = icmp sgt i64 %318, 0
  br label %439

327:                                              ; preds = %310
  %328 = icmp sgt i64 %318, 0
  br i1 %328, label %329, label %458

329:                                              ; preds = %327
  %330 = shl i64 %319, 3
  %331 = shl i64 %319, 5
  %332 = mul i64 %319, 40
  %333 = mul i64 %319, 48
  %334 = mul i64 %319, 56
  %335 = shl i64 %319, 4
  %336 = mul i64 %319, 24
  %337 = shl i64 %319, 4
  %338 = mul i64 %319, 24
  %339 = shl i64 %319, 5
  %340 = mul i64 %319, 40
  %341 = mul i64 %319, 48
  %342 = mul i64 %319, 56
  br label %343

343:                                              ; preds = %329, %436
  %344 = phi i64 [ 0, %329 ], [ %437, %436 ]
  %345 = mul i64 %330, %344
  %346 = getelementptr inbounds double, ptr %321, i64 %345
  %347 = mul i64 %288, %344
  %348 = getelementptr inbounds i8, ptr %39, i64 %347
  br i1 %289, label %349, label %353

349:                                              ; preds = %343
  %350 = getelementptr i8, ptr %348, i64 64
  %351 = getelementptr i8, ptr %348, i64 128
  %352 = getelementptr i8, ptr %348, i64 192
  br label %356

353:                                              ; preds = %356, %343
  %354 = phi i64 [ 0, %343 ], [ %403, %356 ]
  %355 = icmp slt i64 %354, %13
  br i1 %355, label %406, label %436

356:                                              ; preds = %349, %356
  %357 = phi i64 [ %403, %356 ], [ 0, %349 ]
  %358 = tail call i64 @llvm.smin.i64(i64 %357, i64 %290)
  %359 = getelementptr double, ptr %346, i64 %358
  %360 = getelementptr i8, ptr %359, i64 %331
  %361 = load <4 x double>, ptr %360, align 8
  %362 = getelementptr i8, ptr %359, i64 %332
  %363 = load <4 x double>, ptr %362, align 8
  %364 = shufflevector <4 x double> %361, <4 x double> %363, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %365 = getelementptr i8, ptr %359, i64 %333
  %366 = load <4 x double>, ptr %365, align 8
  %367 = getelementptr i8, ptr %359, i64 %334
  %368 = load <4 x double>, ptr %367, align 8
  %369 = shufflevector <4 x double> %366, <4 x double> %368, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %370 = shufflevector <4 x double> %364, <4 x double> %369, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %371 = shufflevector <4 x double> %361, <4 x double> %363, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %372 = shufflevector <4 x double> %366, <4 x double> %368, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %373 = shufflevector <4 x double> %371, <4 x double> %372, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %374 = shufflevector <4 x double> %364, <4 x double> %369, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %375 = shufflevector <4 x double> %371, <4 x double> %372, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %376 = load <4 x double>, ptr %359, align 8
  %377 = getelementptr double, ptr %359, i64 %319
  %378 = load <4 x double>, ptr %377, align 8
  %379 = shufflevector <4 x double> %376, <4 x double> %378, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %380 = getelementptr i8, ptr %359, i64 %335
  %381 = load <4 x double>, ptr %380, align 8
  %382 = getelementptr i8, ptr %359, i64 %336
  %383 = load <4 x double>, ptr %382, align 8
  %384 = shufflevector <4 x double> %381, <4 x double> %383, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %385 = shufflevector <4 x double> %379, <4 x double> %384, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %386 = shufflevector <4 x double> %376, <4 x double> %378, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %387 = shufflevector <4 x double> %381, <4 x double> %383, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %388 = shufflevector <4 x double> %386, <4 x double> %387, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %389 = shufflevector <4 x double> %379, <4 x double> %384, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %390 = shufflevector <4 x double> %386, <4 x double> %387, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %391 = shufflevector <4 x double> %390, <4 x double> %375, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %392 = shl nsw i64 %358, 6
  %393 = getelementptr inbounds i8, ptr %348, i64 %392
  store <8 x double> %391, ptr %393, align 8
  %394 = shufflevector <4 x double> %389, <4 x double> %374, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %395 = shl i64 %358, 6
  %396 = getelementptr i8, ptr %350, i64 %395
  store <8 x double> %394, ptr %396, align 8
  %397 = shufflevector <4 x double> %388, <4 x double> %373, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %398 = shl i64 %358, 6
  %399 = getelementptr i8, ptr %351, i64 %398
  store <8 x double> %397, ptr %399, align 8
  %400 = shufflevector <4 x double> %385, <4 x double> %370, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %401 = shl i64 %358, 6
  %402 = getelementptr i8, ptr %352, i64 %401
  store <8 x double> %400, ptr %402, align 8
  %403 = add nsw i64 %358, 4
  %404 = icmp slt i64 %403, %13
  %405 = select i1 %289, i1 %404, i1 false
  br i1 %405, label %356, label %353, !llvm.loop !15

406:                                              ; preds = %353, %406
  %407 = phi i64 [ %434, %406 ], [ %354, %353 ]
  %408 = getelementptr double, ptr %346, i64 %407
  %409 = load double, ptr %408, align 8
  %410 = insertelement <8 x double> poison, double %409, i64 0
  %411 = getelementptr double, ptr %408, i64 %319
  %412 = load double, ptr %411, align 8
  %413 = insertelement <8 x double> %410, double %412, i64 1
  %414 = getelementptr i8, ptr %408, i64 %337
  %415 = load double, ptr %414, align 8
  %416 = insertelement <8 x double> %413, double %415, i64 2
  %417 = getelementptr i8, ptr %408, i64 %338
  %418 = load double, ptr %417, align 8
  %419 = insertelement <8 x double> %416, double %418, i64 3
  %420 = getelementptr i8, ptr %408, i64 %339
  %421 = load double, ptr %420, align 8
  %422 = insertelement <8 x double> %419, double %421, i64 4
  %423 = getelementptr i8, ptr %408, i64 %340
  %424 = load double, ptr %423, align 8
  %425 = insertelement <8 x double> %422, double %424, i64 5
  %426 = getelementptr i8, ptr %408, i64 %341
  %427 = load double, ptr %426, align 8
  %428 = insertelement <8 x double> %425, double %427, i64 6
  %429 = getelementptr i8, ptr %408, i64 %342
  %430 = load double, ptr %429, align 8
  %431 = insertelement <8 x double> %428, double %430, i64 7
  %432 = shl nsw i64 %407, 6
  %433 = getelementptr inbounds i8, ptr %348, i64 %432
  store <8 x double> %431, ptr %433, align 8
  %434 = add nsw i64 %407, 1
  %435 = icmp eq i64 %434, %13
  br i1 %435, label %436, label %406, !llvm.loop !16

436:                                              ; preds = %406, %353
  %437 = add nuw nsw i64 %344, 1
  %438 = icmp eq i64 %437, %318
  br i1 %438, label %458, label %343, !llvm.loop !17

439:                                              ; preds = %325, %444
  %440 = phi i64 [ 0, %325 ], [ %445, %444 ]
  br i1 %326, label %441, label %444

441:                                              ; preds = %439
  %442 = mul nsw i64 %440, %322
  %443 = getelementptr inbounds double, ptr %321, i64 %442
  br label %447

444:                                              ; preds = %447, %439
  %445 = add nuw nsw i64 %440, 1
  %446 = icmp eq i64 %445, %13
  br i1 %446, label %458, label %439, !llvm.loop !18

447:                                              ; preds = %441, %447
  %448 = phi i64 [ 0, %441 ], [ %456, %447 ]
  %449 = shl nsw i64 %448, 6
  %450 = getelementptr inbounds i8, ptr %443, i64 %449
  %451 = load <8 x double>, ptr %450, align 8
  %452 = mul nuw nsw i64 %448, %13
  %453 = add nuw nsw i64 %452, %440
  %454 = shl nsw i64 %453, 6
  %455 = getelementptr inbounds i8, ptr %39, i64 %454
  store <8 x double> %451, ptr %455, align 64
  %456 = add nuw nsw i64 %448, 1
  %457 = icmp eq i64 %456, %318
  br i1 %457, label %444, label %447, !llvm.loop !19

458:                                              ; preds = %444, %436, %324, %327
  br i1 %22, label %459, label %599

459:                                              ; preds = %458
  %460 = load i64, ptr %18, align 8
  %461 = mul nsw i64 %460, %317
  %462 = getelementptr inbounds double, ptr %3, i64 %461
  %463 = load i64, ptr %291, align 8
  %464 = icmp eq i64 %463, 1
  br i1 %464, label %468, label %465

465:                                              ; preds = %459
  br i1 %292, label %466, label %599

466:                                              ; preds = %465
  %467 = icmp sgt i64 %318, 0
  br label %580

468:                                              ; preds = %459
  %469 = icmp sgt i64 %318, 0
  br i1 %469, label %470, label %599

470:                                              ; preds = %468
  %471 = shl i64 %460, 3
  %472 = shl i64 %460, 5
  %473 = mul i64 %460, 40
  %474 = mul i64 %460, 48
  %475 = mul i64 %460, 56
  %476 = shl i64 %460, 4
  %477 = mul i64 %460, 24
  %478 = shl i64 %460, 4
  %479 = mul i64 %460, 24
  %480 = shl i64 %460, 5
  %481 = mul i64 %460, 40
  %482 = mul i64 %460, 48
  %483 = mul i64 %460, 56
  br label %484

484:                                              ; preds = %470, %577
  %485 = phi i64 [ 0, %470 ], [ %578, %577 ]
  %486 = mul i64 %471, %485
  %487 = getelementptr inbounds double, ptr %462, i64 %486
  %488 = mul i64 %293, %485
  %489 = getelementptr inbounds i8, ptr %44, i64 %488
  br i1 %294, label %490, label %494

490:                                              ; preds = %484
  %491 = getelementptr i8, ptr %489, i64 64
  %492 = getelementptr i8, ptr %489, i64 128
  %493 = getelementptr i8, ptr %489, i64 192
  br label %497

494:                                              ; preds = %497, %484
  %495 = phi i64 [ 0, %484 ], [ %544, %497 ]
  %496 = icmp slt i64 %495, %15
  br i1 %496, label %547, label %577

497:                                              ; preds = %490, %497
  %498 = phi i64 [ %544, %497 ], [ 0, %490 ]
  %499 = tail call i64 @llvm.smin.i64(i64 %498, i64 %295)
  %500 = getelementptr double, ptr %487, i64 %499
  %501 = getelementptr i8, ptr %500, i64 %472
  %502 = load <4 x double>, ptr %501, align 8
  %503 = getelementptr i8, ptr %500, i64 %473
  %504 = load <4 x double>, ptr %503, align 8
  %505 = shufflevector <4 x double> %502, <4 x double> %504, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %506 = getelementptr i8, ptr %500, i64 %474
  %507 = load <4 x double>, ptr %506, align 8
  %508 = getelementptr i8, ptr %500, i64 %475
  %509 = load <4 x double>, ptr %508, align 8
  %510 = shufflevector <4 x double> %507, <4 x double> %509, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %511 = shufflevector <4 x double> %505, <4 x double> %510, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %512 = shufflevector <4 x double> %502, <4 x double> %504, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %513 = shufflevector <4 x double> %507, <4 x double> %509, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %514 = shufflevector <4 x double> %512, <4 x double> %513, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %515 = shufflevector <4 x double> %505, <4 x double> %510, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %516 = shufflevector <4 x double> %512, <4 x double> %513, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %517 = load <4 x double>, ptr %500, align 8
  %518 = getelementptr double, ptr %500, i64 %460
  %519 = load <4 x double>, ptr %518, align 8
  %520 = shufflevector <4 x double> %517, <4 x double> %519, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %521 = getelementptr i8, ptr %500, i64 %476
  %522 = load <4 x double>, ptr %521, align 8
  %523 = getelementptr i8, ptr %500, i64 %477
  %524 = load <4 x double>, ptr %523, align 8
  %525 = shufflevector <4 x double> %522, <4 x double> %524, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %526 = shufflevector <4 x double> %520, <4 x double> %525, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %527 = shufflevector <4 x double> %517, <4 x double> %519, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %528 = shufflevector <4 x double> %522, <4 x double> %524, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %529 = shufflevector <4 x double> %527, <4 x double> %528, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %530 = shufflevector <4 x double> %520, <4 x double> %525, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %531 = shufflevector <4 x double> %527, <4 x double> %528, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %532 = shufflevector <4 x double> %531, <4 x double> %516, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %533 = shl nsw i64 %499, 6
  %534 = getelementptr inbounds i8, ptr %489, i64 %533
  store <8 x double> %532, ptr %534, align 8
  %535 = shufflevector <4 x double> %530, <4 x double> %515, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %536 = shl i64 %499, 6
  %537 = getelementptr i8, ptr %491, i64 %536
  store <8 x double> %535, ptr %537, align 8
  %538 = shufflevector <4 x double> %529, <4 x double> %514, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %539 = shl i64 %499, 6
  %540 = getelementptr i8, ptr %492, i64 %539
  store <8 x double> %538, ptr %540, align 8
  %541 = shufflevector <4 x double> %526, <4 x double> %511, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %542 = shl i64 %499, 6
  %543 = getelementptr i8, ptr %493, i64 %542
  store <8 x double> %541, ptr %543, align 8
  %544 = add nsw i64 %499, 4
  %545 = icmp slt i64 %544, %15
  %546 = select i1 %294, i1 %545, i1 false
  br i1 %546, label %497, label %494, !llvm.loop !15

547:                                              ; preds = %494, %547
  %548 = phi i64 [ %575, %547 ], [ %495, %494 ]
  %549 = getelementptr double, ptr %487, i64 %548
  %550 = load double, ptr %549, align 8
  %551 = insertelement <8 x double> poison, double %550, i64 0
  %552 = getelementptr double, ptr %549, i64 %460
  %553 = load double, ptr %552, align 8
  %554 = insertelement <8 x double> %551, double %553, i64 1
  %555 = getelementptr i8, ptr %549, i64 %478
  %556 = load double, ptr %555, align 8
  %557 = insertelement <8 x double> %554, double %556, i64 2
  %558 = getelementptr i8, ptr %549, i64 %479
  %559 = load double, ptr %558, align 8
  %560 = insertelement <8 x double> %557, double %559, i64 3
  %561 = getelementptr i8, ptr %549, i64 %480
  %562 = load double, ptr %561, align 8
  %563 = insertelement <8 x double> %560, double %562, i64 4
  %564 = getelementptr i8, ptr %549, i64 %481
  %565 = load double, ptr %564, align 8
  %566 = insertelement <8 x double> %563, double %565, i64 5
  %567 = getelementptr i8, ptr %549, i64 %482
  %568 = load double, ptr %567, align 8
  %569 = insertelement <8 x double> %566, double %568, i64 6
  %570 = getelementptr i8, ptr %549, i64 %483
  %571 = load double, ptr %570, align 8
  %572 = insertelement <8 x double> %569, double %571, i64 7
  %573 = shl nsw i64 %548, 6
  %574 = getelementptr inbounds i8, ptr %489, i64 %573
  store <8 x double> %572, ptr %574, align 8
  %575 = add nsw i64 %548, 1
  %576 = icmp eq i64 %575, %15
  br i1 %576, label %577, label %547, !llvm.loop !16

577:                                              ; preds = %547, %494
  %578 = add nuw nsw i64 %485, 1
  %579 = icmp eq i64 %578, %318
  br i1 %579, label %599, label %484, !llvm.loop !17

580:                                              ; preds = %466, %585
  %581 = phi i64 [ 0, %466 ], [ %586, %585 ]
  br i1 %467, label %582, label %585

582:                                              ; preds = %580
  %583 = mul nsw i64 %581, %463
  %584 = getelementptr inbounds double, ptr %462, i64 %583
  br label %588

585:                                              ; preds = %588, %580
  %586 = add nuw nsw i64 %581, 1
  %587 = icmp eq i64 %586, %15
  br i1 %587, label %599, label %580, !llvm.loop !18

588:                                              ; preds = %582, %588
  %589 = phi i64 [ 0, %582 ], [ %597, %588 ]
  %590 = shl nsw i64 %589, 6
  %591 = getelementptr inbounds i8, ptr %584, i64 %590
  %592 = load <8 x double>, ptr %591, align 8
  %593 = mul nuw nsw i64 %589, %15
  %594 = add nuw nsw i64 %593, %581
  %595 = shl nsw i64 %594, 6
  %596 = getelementptr inbounds i8, ptr %44, i64 %595
  store <8 x double> %592, ptr %596, align 8
  %597 = add nuw nsw i64 %589, 1
  %598 = icmp eq i64 %597, %318
  br i1 %598, label %585, label %588, !llvm.loop !19

599:                                              ; preds = %585, %577, %465, %468, %458
  %600 = icmp sgt i64 %318, 0
  br i1 %600, label %603, label %601

601:                                              ; preds = %782, %599
  %602 = phi <8 x i64> [ %312, %599 ], [ %687, %782 ]
  br i1 %26, label %809, label %785

603:                                              ; preds = %599, %782
  %604 = phi i64 [ %783, %782 ], [ 0, %599 ]
  %605 = phi <8 x i64> [ %687, %782 ], [ %312, %599 ]
  %606 = shl nsw i64 %604, 3
  %607 = add nsw i64 %606, %317
  %608 = mul i64 %296, %604
  %609 = select i1 %20, i64 %608, i64 0
  %610 = getelementptr inbounds i8, ptr %44, i64 %609
  %611 = mul i64 %297, %604
  %612 = select i1 %26, i64 0, i64 %611
  %613 = getelementptr inbounds i8, ptr %47, i64 %612
  %614 = add nsw i64 %607, 16
  %615 = icmp sle i64 %614, %11
  %616 = select i1 %26, i1 %615, i1 false
  br i1 %616, label %617, label %657

617:                                              ; preds = %603
  %618 = add nsw i64 %607, 8
  %619 = load i64, ptr %177, align 8
  %620 = icmp eq i64 %619, 1
  %621 = select i1 %620, i1 %298, i1 false
  br i1 %621, label %622, label %639

622:                                              ; preds = %617, %630
  %623 = phi i64 [ %631, %630 ], [ 0, %617 ]
  br i1 %299, label %624, label %630

624:                                              ; preds = %622
  %625 = load i64, ptr %176, align 8
  %626 = mul nsw i64 %625, %618
  %627 = getelementptr inbounds double, ptr %2, i64 %626
  %628 = mul nsw i64 %625, %623
  %629 = getelementptr inbounds double, ptr %627, i64 %628
  br label %634

630:                                              ; preds = %634, %622
  %631 = add nuw nsw i64 %623, 1
  %632 = icmp ult i64 %623, 7
  %633 = select i1 %298, i1 %632, i1 false
  br i1 %633, label %622, label %639, !llvm.loop !20

634:                                              ; preds = %624, %634
  %635 = phi i64 [ 0, %624 ], [ %637, %634 ]
  %636 = getelementptr inbounds double, ptr %629, i64 %635
  tail call void @llvm.prefetch.p0(ptr %636, i32 0, i32 3, i32 1)
  %637 = add nuw nsw i64 %635, 8
  %638 = icmp slt i64 %637, %13
  br i1 %638, label %634, label %630, !llvm.loop !21

639:                                              ; preds = %630, %617
  br i1 %300, label %640, label %657

640:                                              ; preds = %639, %648
  %641 = phi i64 [ %649, %648 ], [ 0, %639 ]
  br i1 %301, label %642, label %648

642:                                              ; preds = %640
  %643 = load i64, ptr %23, align 8
  %644 = mul nsw i64 %643, %618
  %645 = getelementptr inbounds double, ptr %5, i64 %644
  %646 = mul nsw i64 %643, %641
  %647 = getelementptr inbounds double, ptr %645, i64 %646
  br label %652

648:                                              ; preds = %652, %640
  %649 = add nuw nsw i64 %641, 1
  %650 = icmp ult i64 %641, 7
  %651 = select i1 %300, i1 %650, i1 false
  br i1 %651, label %640, label %657, !llvm.loop !22

652:                                              ; preds = %642, %652
  %653 = phi i64 [ 0, %642 ], [ %655, %652 ]
  %654 = getelementptr inbounds double, ptr %647, i64 %653
  tail call void @llvm.prefetch.p0(ptr %654, i32 1, i32 3, i32 1)
  %655 = add nuw nsw i64 %653, 8
  %656 = icmp slt i64 %655, %17
  br i1 %656, label %652, label %648, !llvm.loop !23

657:                                              ; preds = %648, %639, %603
  %658 = load ptr, ptr %0, align 8
  %659 = getelementptr inbounds double, ptr %1, i64 %607
  %660 = mul i64 %302, %604
  %661 = getelementptr inbounds i8, ptr %39, i64 %660
  %662 = tail call i32 %658(ptr noundef %659, ptr noundef nonnull %661, ptr noundef nonnull %610, ptr noundef %34, ptr noundef nonnull %613) #4
  %663 = sext i32 %662 to i64
  %664 = getelementptr inbounds i8, ptr %6, i64 %607
  %665 = icmp eq i32 %662, 0
  br i1 %665, label %674, label %666

666:                                              ; preds = %657, %666
  %667 = phi i64 [ %672, %666 ], [ 0, %657 ]
  %668 = lshr i64 %663, %667
  %669 = trunc i64 %668 to i8
  %670 = and i8 %669, 1
  %671 = getelementptr inbounds i8, ptr %664, i64 %667
  store i8 %670, ptr %671, align 1
  %672 = add nuw nsw i64 %667, 1
  %673 = icmp eq i64 %672, 8
  br i1 %673, label %674, label %666, !llvm.loop !7

674:                                              ; preds = %666, %657
  br i1 %303, label %675, label %686

675:                                              ; preds = %674, %675
  %676 = phi <8 x i64> [ %683, %675 ], [ %605, %674 ]
  %677 = phi i64 [ %684, %675 ], [ 0, %674 ]
  %678 = shl nsw i64 %677, 6
  %679 = getelementptr inbounds i8, ptr %613, i64 %678
  %680 = load <8 x double>, ptr %679, align 8
  %681 = fsub <8 x double> %680, %680
  %682 = bitcast <8 x double> %681 to <8 x i64>
  %683 = or <8 x i64> %676, %682
  %684 = add nuw nsw i64 %677, 1
  %685 = icmp eq i64 %684, %17
  br i1 %685, label %686, label %675, !llvm.loop !24

686:                                              ; preds = %675, %674
  %687 = phi <8 x i64> [ %605, %674 ], [ %683, %675 ]
  br i1 %26, label %688, label %782

688:                                              ; preds = %686
  %689 = load i64, ptr %23, align 8
  %690 = mul nsw i64 %689, %607
  %691 = getelementptr inbounds double, ptr %5, i64 %690
  br i1 %304, label %692, label %699

692:                                              ; preds = %688
  %693 = shl i64 %689, 4
  %694 = mul i64 %689, 24
  %695 = shl i64 %689, 5
  %696 = mul i64 %689, 40
  %697 = mul i64 %689, 48
  %698 = mul i64 %689, 56
  br label %709

699:                                              ; preds = %709, %688
  %700 = phi i64 [ 0, %688 ], [ %756, %709 ]
  %701 = icmp slt i64 %700, %17
  br i1 %701, label %702, label %782

702:                                              ; preds = %699
  %703 = shl i64 %689, 4
  %704 = mul i64 %689, 24
  %705 = shl i64 %689, 5
  %706 = mul i64 %689, 40
  %707 = mul i64 %689, 48
  %708 = mul i64 %689, 56
  br label %759

709:                                              ; preds = %692, %709
  %710 = phi i64 [ %756, %709 ], [ 0, %692 ]
  %711 = tail call i64 @llvm.smin.i64(i64 %710, i64 %305)
  %712 = getelementptr double, ptr %691, i64 %711
  %713 = shl nsw i64 %711, 6
  %714 = getelementptr inbounds i8, ptr %47, i64 %713
  %715 = load <8 x double>, ptr %714, align 8
  %716 = shufflevector <8 x double> %715, <8 x double> poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %717 = shl i64 %711, 6
  %718 = getelementptr i8, ptr %307, i64 %717
  %719 = load <8 x double>, ptr %718, align 8
  %720 = shufflevector <8 x double> %719, <8 x double> poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %721 = shufflevector <4 x double> %716, <4 x double> %720, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %722 = shl i64 %711, 6
  %723 = getelementptr i8, ptr %308, i64 %722
  %724 = load <8 x double>, ptr %723, align 8
  %725 = shufflevector <8 x double> %724, <8 x double> poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %726 = shl i64 %711, 6
  %727 = getelementptr i8, ptr %309, i64 %726
  %728 = load <8 x double>, ptr %727, align 8
  %729 = shufflevector <8 x double> %728, <8 x double> poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %730 = shufflevector <4 x double> %725, <4 x double> %729, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %731 = shufflevector <4 x double> %721, <4 x double> %730, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %732 = shufflevector <4 x double> %716, <4 x double> %720, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %733 = shufflevector <4 x double> %725, <4 x double> %729, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %734 = shufflevector <4 x double> %732, <4 x double> %733, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %735 = shufflevector <4 x double> %721, <4 x double> %730, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %736 = shufflevector <4 x double> %732, <4 x double> %733, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %737 = shufflevector <8 x double> %715, <8 x double> poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %738 = shufflevector <8 x double> %719, <8 x double> poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %739 = shufflevector <4 x double> %737, <4 x double> %738, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %740 = shufflevector <8 x double> %724, <8 x double> poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %741 = shufflevector <8 x double> %728, <8 x double> poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %742 = shufflevector <4 x double> %740, <4 x double> %741, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %743 = shufflevector <4 x double> %739, <4 x double> %742, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %744 = shufflevector <4 x double> %737, <4 x double> %738, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %745 = shufflevector <4 x double> %740, <4 x double> %741, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %746 = shufflevector <4 x double> %744, <4 x double> %745, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %747 = shufflevector <4 x double> %739, <4 x double> %742, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %748 = shufflevector <4 x double> %744, <4 x double> %745, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  store <4 x double> %748, ptr %712, align 8
  %749 = getelementptr double, ptr %712, i64 %689
  store <4 x double> %747, ptr %749, align 8
  %750 = getelementptr i8, ptr %712, i64 %693
  store <4 x double> %746, ptr %750, align 8
  %751 = getelementptr i8, ptr %712, i64 %694
  store <4 x double> %743, ptr %751, align 8
  %752 = getelementptr i8, ptr %712, i64 %695
  store <4 x double> %736, ptr %752, align 8
  %753 = getelementptr i8, ptr %712, i64 %696
  store <4 x double> %735, ptr %753, align 8
  %754 = getelementptr i8, ptr %712, i64 %697
  store <4 x double> %734, ptr %754, align 8
  %755 = getelementptr i8, ptr %712, i64 %698
  store <4 x double> %731, ptr %755, align 8
  %756 = add nsw i64 %711, 4
  %757 = icmp slt i64 %756, %17
  %758 = select i1 %304, i1 %757, i1 false
  br i1 %758, label %709, label %699, !llvm.loop !25

759:                                              ; preds = %702, %759
  %760 = phi i64 [ %780, %759 ], [ %700, %702 ]
  %761 = getelementptr double, ptr %691, i64 %760
  %762 = shl nsw i64 %760, 6
  %763 = getelementptr inbounds i8, ptr %47, i64 %762
  %764 = load <8 x double>, ptr %763, align 8
  %765 = extractelement <8 x double> %764, i64 0
  store double %765, ptr %761, align 8
  %766 = extractelement <8 x double> %764, i64 1
  %767 = getelementptr double, ptr %761, i64 %689
  store double %766, ptr %767, align 8
  %768 = extractelement <8 x double> %764, i64 2
  %769 = getelementptr i8, ptr %761, i64 %703
  store double %768, ptr %769, align 8
  %770 = extractelement <8 x double> %764, i64 3
  %771 = getelementptr i8, ptr %761, i64 %704
  store double %770, ptr %771, align 8
  %772 = extractelement <8 x double> %764, i64 4
  %773 = getelementptr i8, ptr %761, i64 %705
  store double %772, ptr %773, align 8
  %774 = extractelement <8 x double> %764, i64 5
  %775 = getelementptr i8, ptr %761, i64 %706
  store double %774, ptr %775, align 8
  %776 = extractelement <8 x double> %764, i64 6
  %777 = getelementptr i8, ptr %761, i64 %707
  store double %776, ptr %777, align 8
  %778 = extractelement <8 x double> %764, i64 7
  %779 = getelementptr i8, ptr %761, i64 %708
  store double %778, ptr %779, align 8
  %780 = add nsw i64 %760, 1
  %781 = icmp eq i64 %780, %17
  br i1 %781, label %782, label %759, !llvm.loop !26

782:                                              ; preds = %759, %699, %686
  %783 = add nuw nsw i64 %604, 1
  %784 = icmp eq i64 %783, %318
  br i1 %784, label %601, label %603, !llvm.loop !27

785:                                              ; preds = %601
  %786 = load i64, ptr %24, align 8
  %787 = getelementptr inbounds double, ptr %5, i64 %317
  br i1 %306, label %788, label %809

788:                                              ; preds = %785
  %789 = icmp sgt i64 %318, 0
  br label %790

790:                                              ; preds = %788, %795
  %791 = phi i64 [ 0, %788 ], [ %796, %795 ]
  br i1 %789, label %792, label %795

792:                                              ; preds = %790
  %793 = mul nsw i64 %791, %786
  %794 = getelementptr inbounds double, ptr %787, i64 %793
  br label %798

795:                                              ; preds = %798, %790
  %796 = add nuw nsw i64 %791, 1
  %797 = icmp eq i64 %796, %17
  br i1 %797, label %809, label %790, !llvm.loop !28

798:                                              ; preds = %792, %798
  %799 = phi i64 [ 0, %792 ], [ %807, %798 ]
  %800 = mul nuw nsw i64 %799, %17
  %801 = add nuw nsw i64 %800, %791
  %802 = shl nsw i64 %801, 6
  %803 = getelementptr inbounds i8, ptr %47, i64 %802
  %804 = load <8 x double>, ptr %803, align 8
  %805 = shl nsw i64 %799, 6
  %806 = getelementptr inbounds i8, ptr %794, i64 %805
  store <8 x double> %804, ptr %806, align 8
  %807 = add nuw nsw i64 %799, 1
  %808 = icmp eq i64 %807, %318
  br i1 %808, label %795, label %798, !llvm.loop !29

809:                                              ; preds = %795, %785, %601
  %810 = shl nsw i64 %318, 3
  %811 = add nsw i64 %317, %810
  %812 = icmp slt i64 %811, %11
  br i1 %812, label %310, label %813, !llvm.loop !30

813:                                              ; preds = %809
  %814 = extractelement <8 x i64> %602, i64 0
  %815 = icmp eq i64 %814, 0
  %816 = extractelement <8 x i64> %602, i64 1
  %817 = icmp eq i64 %816, 0
  %818 = extractelement <8 x i64> %602, i64 2
  %819 = icmp eq i64 %818, 0
  %820 = extractelement <8 x i64> %602, i64 3
  %821 = icmp eq i64 %820, 0
  %822 = extractelement <8 x i64> %602, i64 4
  %823 = icmp eq i64 %822, 0
  %824 = extractelement <8 x i64> %602, i64 5
  %825 = icmp eq i64 %824, 0
  %826 = extractelement <8 x i64> %602, i64 6
  %827 = icmp eq i64 %826, 0
  %828 = extractelement <8 x i64> %602, i64 7
  %829 = icmp eq i64 %828, 0
  %830 = select i1 %829, i1 %827, i1 false
  %831 = select i1 %830, i1 %825, i1 false
  %832 = select i1 %831, i1 %823, i1 false
  %833 = select i1 %832, i1 %821, i1 false
  %834 = select i1 %833, i1 %819, i1 false
  %835 = select i1 %834, i1 %817, i1 false
  %836 = select i1 %835, i1 %815, i1 false
  %837 = zext i1 %836 to i64
  br label %838

838:                                              ; preds = %159, %272, %813, %8
  %839 = phi i64 [ 1, %8 ], [ 0, %272 ], [ %837, %813 ], [ 0, %159 ]
  ret i64 %839
}



declare void @llvm.prefetch.p0(ptr readonly, i32 immarg, i32 immarg, i32 immarg) #2

declare i64 @llvm.smin.i64(i64, i64) #3

declare i64 @llvm.smax.i64(i64, i64) #3

declare i64 @llvm.umax.i64(i64, i64) #3

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { nounwind willreturn }
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
!8 = distinct !{!8, !4, !5, !9}
!9 = !{!"llvm.loop.vectorize.width", i32 1}
!10 = distinct !{!10, !4, !5}
!11 = distinct !{!11, !4, !5, !9}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5, !9}
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
