; sources 66d0f7da5590b3e89a846a959ccf884ba825bb54af5226e02a333e6ac8017121
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define range(i64 0, 2) i64 @sweep_4(ptr noundef readonly %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, ptr noundef readonly %4, ptr noundef %5, ptr noundef writeonly %6, ptr noundef %7) #0 {
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
  %33 = shl nsw i64 %32, 5
  %34 = getelementptr inbounds i8, ptr %30, i64 %33
  %35 = getelementptr inbounds i8, ptr %0, i64 56
  %36 = load i64, ptr %35, align 8
  %37 = shl nsw i64 %36, 5
  %38 = getelementptr inbounds i8, ptr %34, i64 %37
  %39 = getelementptr inbounds i8, ptr %38, i64 32
  %40 = getelementptr inbounds i8, ptr %0, i64 72
  %41 = load i64, ptr %40, align 8
  %42 = shl i64 %13, 5
  %43 = mul i64 %42, %41
  %44 = getelementptr inbounds i8, ptr %39, i64 %43
  %45 = shl i64 %15, 5
  %46 = mul i64 %45, %41
  %47 = getelementptr inbounds i8, ptr %44, i64 %46
  %48 = icmp slt i64 %11, 1
  br i1 %48, label %710, label %49

49:                                               ; preds = %8
  %50 = icmp sgt i64 %32, 0
  br i1 %50, label %51, label %65

51:                                               ; preds = %49, %56
  %52 = phi i64 [ %57, %56 ], [ 0, %49 ]
  %53 = getelementptr inbounds double, ptr %4, i64 %52
  %54 = shl nsw i64 %52, 5
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
  %64 = icmp eq i64 %63, 4
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
  %76 = shl nsw i64 %73, 5
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
  %86 = icmp eq i64 %85, 4
  br i1 %86, label %78, label %81, !llvm.loop !6

87:                                               ; preds = %78, %68, %65
  %88 = icmp slt i64 %11, 4
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
  %135 = shl nsw i64 %127, 5
  %136 = getelementptr inbounds i8, ptr %122, i64 %135
  store double %134, ptr %136, align 8
  %137 = add nuw nsw i64 %127, 1
  %138 = icmp eq i64 %137, %13
  br i1 %138, label %123, label %126, !llvm.loop !8

139:                                              ; preds = %142, %123
  %140 = add nuw nsw i64 %116, 1
  %141 = icmp eq i64 %140, 4
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
  %151 = shl nsw i64 %143, 5
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
  br i1 %161, label %710, label %156, !llvm.loop !12

162:                                              ; preds = %156, %162
  %163 = phi i64 [ %173, %162 ], [ 0, %156 ]
  %164 = shl nsw i64 %163, 5
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
  %214 = add nsw i64 %213, -4
  %215 = ptrtoint ptr %2 to i64
  %216 = lshr i64 %215, 3
  %217 = and i64 %216, 3
  %218 = load i64, ptr %18, align 8
  %219 = icmp eq i64 %218, 0
  %220 = select i1 %219, i64 0, i64 4
  store i64 %178, ptr %9, align 16
  %221 = getelementptr inbounds i8, ptr %9, i64 8
  br i1 %219, label %225, label %222

222:                                              ; preds = %211
  %223 = getelementptr inbounds i8, ptr %0, i64 120
  %224 = load i64, ptr %223, align 8
  br label %225

225:                                              ; preds = %222, %211
  %226 = phi i64 [ %224, %222 ], [ 4, %211 ]
  store i64 %226, ptr %221, align 8
  %227 = getelementptr inbounds i8, ptr %9, i64 16
  %228 = load i64, ptr %24, align 8
  store i64 %228, ptr %227, align 16
  %229 = getelementptr inbounds i8, ptr %9, i64 24
  store i64 1, ptr %229, align 8
  %230 = getelementptr inbounds i8, ptr %9, i64 32
  store i64 %220, ptr %230, align 16
  %231 = getelementptr i8, ptr %6, i64 -4
  %232 = icmp sgt i64 %213, 0
  br i1 %232, label %233, label %272

233:                                              ; preds = %225
  %234 = icmp sgt i64 %213, 4
  %235 = sub nuw nsw i64 4, %217
  br label %236

236:                                              ; preds = %233, %268
  %237 = phi i64 [ 0, %233 ], [ %270, %268 ]
  %238 = call i64 @llvm.smin.i64(i64 %237, i64 %214)
  %239 = icmp eq i64 %237, 0
  br i1 %239, label %243, label %240

240:                                              ; preds = %236
  %241 = sub nsw i64 %213, %238
  %242 = sdiv i64 %241, 4
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
  %253 = ashr i64 %252, 30
  %254 = and i64 %253, -4
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
  %267 = icmp eq i64 %266, 4
  br i1 %267, label %268, label %260, !llvm.loop !7

268:                                              ; preds = %260, %243
  %269 = select i1 %239, i1 %234, i1 false
  %270 = select i1 %269, i64 %235, i64 %255
  %271 = icmp slt i64 %270, %213
  br i1 %271, label %236, label %272, !llvm.loop !14

272:                                              ; preds = %268, %225
  br label %710

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
  %286 = add nsw i64 %11, -4
  %287 = icmp sgt i64 %13, 0
  %288 = shl i64 %13, 5
  %289 = icmp sgt i64 %13, 3
  %290 = add nsw i64 %13, -4
  %291 = getelementptr inbounds i8, ptr %0, i64 120
  %292 = icmp sgt i64 %15, 0
  %293 = shl i64 %15, 5
  %294 = icmp sgt i64 %15, 3
  %295 = add nsw i64 %15, -4
  %296 = shl i64 %15, 5
  %297 = shl i64 %17, 5
  %298 = icmp slt i64 %13, 257
  %299 = icmp sgt i64 %13, 0
  %300 = icmp slt i64 %17, 257
  %301 = icmp sgt i64 %17, 0
  %302 = shl i64 %13, 5
  %303 = icmp sgt i64 %17, 0
  %304 = icmp sgt i64 %17, 3
  %305 = add nsw i64 %17, -4
  %306 = icmp sgt i64 %17, 0
  %307 = getelementptr i8, ptr %47, i64 32
  %308 = getelementptr i8, ptr %47, i64 64
  %309 = getelementptr i8, ptr %47, i64 96
  br label %310

310:                                              ; preds = %284, %693
  %311 = phi i64 [ 0, %284 ], [ %695, %693 ]
  %312 = phi <4 x i64> [ zeroinitializer, %284 ], [ %522, %693 ]
  %313 = sub nsw i64 %11, %311
  %314 = sdiv i64 %313, 4
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
  br i1 %287, label %325, label %418

325:                                              ; preds = %324
  %326 = icmp sgt i64 %318, 0
  br label %399

327:                                              ; preds = %310
  %328 = icmp sgt i64 %318, 0
  br i1 %328, label %329, label %418

329:                                              ; preds = %327
  %330 = shl i64 %319, 2
  %331 = shl i64 %319, 4
  %332 = mul i64 %319, 24
  %333 = shl i64 %319, 4
  %334 = mul i64 %319, 24
  br label %335

335:                                              ; preds = %329, %396
  %336 = phi i64 [ 0, %329 ], [ %397, %396 ]
  %337 = mul i64 %330, %336
  %338 = getelementptr inbounds double, ptr %321, i64 %337
  %339 = mul i64 %288, %336
  %340 = getelementptr inbounds i8, ptr %39, i64 %339
  br i1 %289, label %341, label %345

341:                                              ; preds = %335
  %342 = getelementptr i8, ptr %340, i64 32
  %343 = getelementptr i8, ptr %340, i64 64
  %344 = getelementptr i8, ptr %340, i64 96
  br label %348

345:                                              ; preds = %348, %335
  %346 = phi i64 [ 0, %335 ], [ %375, %348 ]
  %347 = icmp slt i64 %346, %13
  br i1 %347, label %378, label %396

348:                                              ; preds = %341, %348
  %349 = phi i64 [ %375, %348 ], [ 0, %341 ]
  %350 = tail call i64 @llvm.smin.i64(i64 %349, i64 %290)
  %351 = getelementptr double, ptr %338, i64 %350
  %352 = load <4 x double>, ptr %351, align 8
  %353 = getelementptr double, ptr %351, i64 %319
  %354 = load <4 x double>, ptr %353, align 8
  %355 = shufflevector <4 x double> %352, <4 x double> %354, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %356 = getelementptr i8, ptr %351, i64 %331
  %357 = load <4 x double>, ptr %356, align 8
  %358 = getelementptr i8, ptr %351, i64 %332
  %359 = load <4 x double>, ptr %358, align 8
  %360 = shufflevector <4 x double> %357, <4 x double> %359, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %361 = shufflevector <4 x double> %355, <4 x double> %360, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %362 = shufflevector <4 x double> %352, <4 x double> %354, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %363 = shufflevector <4 x double> %357, <4 x double> %359, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %364 = shufflevector <4 x double> %362, <4 x double> %363, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %365 = shufflevector <4 x double> %355, <4 x double> %360, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %366 = shufflevector <4 x double> %362, <4 x double> %363, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %367 = shl nsw i64 %350, 5
  %368 = getelementptr inbounds i8, ptr %340, i64 %367
  store <4 x double> %366, ptr %368, align 8
  %369 = shl i64 %350, 5
  %370 = getelementptr i8, ptr %342, i64 %369
  store <4 x double> %365, ptr %370, align 8
  %371 = shl i64 %350, 5
  %372 = getelementptr i8, ptr %343, i64 %371
  store <4 x double> %364, ptr %372, align 8
  %373 = shl i64 %350, 5
  %374 = getelementptr i8, ptr %344, i64 %373
  store <4 x double> %361, ptr %374, align 8
  %375 = add nsw i64 %350, 4
  %376 = icmp slt i64 %375, %13
  %377 = select i1 %289, i1 %376, i1 false
  br i1 %377, label %348, label %345, !llvm.loop !15

378:                                              ; preds = %345, %378
  %379 = phi i64 [ %394, %378 ], [ %346, %345 ]
  %380 = getelementptr double, ptr %338, i64 %379
  %381 = load double, ptr %380, align 8
  %382 = insertelement <4 x double> poison, double %381, i64 0
  %383 = getelementptr double, ptr %380, i64 %319
  %384 = load double, ptr %383, align 8
  %385 = insertelement <4 x double> %382, double %384, i64 1
  %386 = getelementptr i8, ptr %380, i64 %333
  %387 = load double, ptr %386, align 8
  %388 = insertelement <4 x double> %385, double %387, i64 2
  %389 = getelementptr i8, ptr %380, i64 %334
  %390 = load double, ptr %389, align 8
  %391 = insertelement <4 x double> %388, double %390, i64 3
  %392 = shl nsw i64 %379, 5
  %393 = getelementptr inbounds i8, ptr %340, i64 %392
  store <4 x double> %391, ptr %393, align 8
  %394 = add nsw i64 %379, 1
  %395 = icmp eq i64 %394, %13
  br i1 %395, label %396, label %378, !llvm.loop !16

396:                                              ; preds = %378, %345
  %397 = add nuw nsw i64 %336, 1
  %398 = icmp eq i64 %397, %318
  br i1 %398, label %418, label %335, !llvm.loop !17

399:                                              ; preds = %325, %404
  %400 = phi i64 [ 0, %325 ], [ %405, %404 ]
  br i1 %326, label %401, label %404

401:                                              ; preds = %399
  %402 = mul nsw i64 %400, %322
  %403 = getelementptr inbounds double, ptr %321, i64 %402
  br label %407

404:                                              ; preds = %407, %399
  %405 = add nuw nsw i64 %400, 1
  %406 = icmp eq i64 %405, %13
  br i1 %406, label %418, label %399, !llvm.loop !18

407:                                              ; preds = %401, %407
  %408 = phi i64 [ 0, %401 ], [ %416, %407 ]
  %409 = shl nsw i64 %408, 5
  %410 = getelementptr inbounds i8, ptr %403, i64 %409
  %411 = load <4 x double>, ptr %410, align 8
  %412 = mul nuw nsw i64 %408, %13
  %413 = add nuw nsw i64 %412, %400
  %414 = shl nsw i64 %413, 5
  %415 = getelementptr inbounds i8, ptr %39, i64 %414
  store <4 x double> %411, ptr %415, align 32
  %416 = add nuw nsw i64 %408, 1
  %417 = icmp eq i64 %416, %318
  br i1 %417, label %404, label %407, !llvm.loop !19

418:                                              ; preds = %404, %396, %324, %327
  br i1 %22, label %419, label %519

419:                                              ; preds = %418
  %420 = load i64, ptr %18, align 8
  %421 = mul nsw i64 %420, %317
  %422 = getelementptr inbounds double, ptr %3, i64 %421
  %423 = load i64, ptr %291, align 8
  %424 = icmp eq i64 %423, 1
  br i1 %424, label %428, label %425

425:                                              ; preds = %419
  br i1 %292, label %426, label %519

426:                                              ; preds = %425
  %427 = icmp sgt i64 %318, 0
  br label %500

428:                                              ; preds = %419
  %429 = icmp sgt i64 %318, 0
  br i1 %429, label %430, label %519

430:                                              ; preds = %428
  %431 = shl i64 %420, 2
  %432 = shl i64 %420, 4
  %433 = mul i64 %420, 24
  %434 = shl i64 %420, 4
  %435 = mul i64 %420, 24
  br label %436

436:                                              ; preds = %430, %497
  %437 = phi i64 [ 0, %430 ], [ %498, %497 ]
  %438 = mul i64 %431, %437
  %439 = getelementptr inbounds double, ptr %422, i64 %438
  %440 = mul i64 %293, %437
  %441 = getelementptr inbounds i8, ptr %44, i64 %440
  br i1 %294, label %442, label %446

442:                                              ; preds = %436
  %443 = getelementptr i8, ptr %441, i64 32
  %444 = getelementptr i8, ptr %441, i64 64
  %445 = getelementptr i8, ptr %441, i64 96
  br label %449

446:                                              ; preds = %449, %436
  %447 = phi i64 [ 0, %436 ], [ %476, %449 ]
  %448 = icmp slt i64 %447, %15
  br i1 %448, label %479, label %497

449:                                              ; preds = %442, %449
  %450 = phi i64 [ %476, %449 ], [ 0, %442 ]
  %451 = tail call i64 @llvm.smin.i64(i64 %450, i64 %295)
  %452 = getelementptr double, ptr %439, i64 %451
  %453 = load <4 x double>, ptr %452, align 8
  %454 = getelementptr double, ptr %452, i64 %420
  %455 = load <4 x double>, ptr %454, align 8
  %456 = shufflevector <4 x double> %453, <4 x double> %455, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %457 = getelementptr i8, ptr %452, i64 %432
  %458 = load <4 x double>, ptr %457, align 8
  %459 = getelementptr i8, ptr %452, i64 %433
  %460 = load <4 x double>, ptr %459, align 8
  %461 = shufflevector <4 x double> %458, <4 x double> %460, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %462 = shufflevector <4 x double> %456, <4 x double> %461, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %463 = shufflevector <4 x double> %453, <4 x double> %455, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %464 = shufflevector <4 x double> %458, <4 x double> %460, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %465 = shufflevector <4 x double> %463, <4 x double> %464, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %466 = shufflevector <4 x double> %456, <4 x double> %461, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %467 = shufflevector <4 x double> %463, <4 x double> %464, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %468 = shl nsw i64 %451, 5
  %469 = getelementptr inbounds i8, ptr %441, i64 %468
  store <4 x double> %467, ptr %469, align 8
  %470 = shl i64 %451, 5
  %471 = getelementptr i8, ptr %443, i64 %470
  store <4 x double> %466, ptr %471, align 8
  %472 = shl i64 %451, 5
  %473 = getelementptr i8, ptr %444, i64 %472
  store <4 x double> %465, ptr %473, align 8
  %474 = shl i64 %451, 5
  %475 = getelementptr i8, ptr %445, i64 %474
  store <4 x double> %462, ptr %475, align 8
  %476 = add nsw i64 %451, 4
  %477 = icmp slt i64 %476, %15
  %478 = select i1 %294, i1 %477, i1 false
  br i1 %478, label %449, label %446, !llvm.loop !15

479:                                              ; preds = %446, %479
  %480 = phi i64 [ %495, %479 ], [ %447, %446 ]
  %481 = getelementptr double, ptr %439, i64 %480
  %482 = load double, ptr %481, align 8
  %483 = insertelement <4 x double> poison, double %482, i64 0
  %484 = getelementptr double, ptr %481, i64 %420
  %485 = load double, ptr %484, align 8
  %486 = insertelement <4 x double> %483, double %485, i64 1
  %487 = getelementptr i8, ptr %481, i64 %434
  %488 = load double, ptr %487, align 8
  %489 = insertelement <4 x double> %486, double %488, i64 2
  %490 = getelementptr i8, ptr %481, i64 %435
  %491 = load double, ptr %490, align 8
  %492 = insertelement <4 x double> %489, double %491, i64 3
  %493 = shl nsw i64 %480, 5
  %494 = getelementptr inbounds i8, ptr %441, i64 %493
  store <4 x double> %492, ptr %494, align 8
  %495 = add nsw i64 %480, 1
  %496 = icmp eq i64 %495, %15
  br i1 %496, label %497, label %479, !llvm.loop !16

497:                                              ; preds = %479, %446
  %498 = add nuw nsw i64 %437, 1
  %499 = icmp eq i64 %498, %318
  br i1 %499, label %519, label %436, !llvm.loop !17

500:                                              ; preds = %426, %505
  %501 = phi i64 [ 0, %426 ], [ %506, %505 ]
  br i1 %427, label %502, label %505

502:                                              ; preds = %500
  %503 = mul nsw i64 %501, %423
  %504 = getelementptr inbounds double, ptr %422, i64 %503
  br label %508

505:                                              ; preds = %508, %500
  %506 = add nuw nsw i64 %501, 1
  %507 = icmp eq i64 %506, %15
  br i1 %507, label %519, label %500, !llvm.loop !18

508:                                              ; preds = %502, %508
  %509 = phi i64 [ 0, %502 ], [ %517, %508 ]
  %510 = shl nsw i64 %509, 5
  %511 = getelementptr inbounds i8, ptr %504, i64 %510
  %512 = load <4 x double>, ptr %511, align 8
  %513 = mul nuw nsw i64 %509, %15
  %514 = add nuw nsw i64 %513, %501
  %515 = shl nsw i64 %514, 5
  %516 = getelementptr inbounds i8, ptr %44, i64 %515
  store <4 x double> %512, ptr %516, align 8
  %517 = add nuw nsw i64 %509, 1
  %518 = icmp eq i64 %517, %318
  br i1 %518, label %505, label %508, !llvm.loop !19

519:                                              ; preds = %505, %497, %425, %428, %418
  %520 = icmp sgt i64 %318, 0
  br i1 %520, label %523, label %521

521:                                              ; preds = %666, %519
  %522 = phi <4 x i64> [ %312, %519 ], [ %607, %666 ]
  br i1 %26, label %693, label %669

523:                                              ; preds = %519, %666
  %524 = phi i64 [ %667, %666 ], [ 0, %519 ]
  %525 = phi <4 x i64> [ %607, %666 ], [ %312, %519 ]
  %526 = shl nsw i64 %524, 2
  %527 = add nsw i64 %526, %317
  %528 = mul i64 %296, %524
  %529 = select i1 %20, i64 %528, i64 0
  %530 = getelementptr inbounds i8, ptr %44, i64 %529
  %531 = mul i64 %297, %524
  %532 = select i1 %26, i64 0, i64 %531
  %533 = getelementptr inbounds i8, ptr %47, i64 %532
  %534 = add nsw i64 %527, 8
  %535 = icmp sle i64 %534, %11
  %536 = select i1 %26, i1 %535, i1 false
  br i1 %536, label %537, label %577

537:                                              ; preds = %523
  %538 = add nsw i64 %527, 4
  %539 = load i64, ptr %177, align 8
  %540 = icmp eq i64 %539, 1
  %541 = select i1 %540, i1 %298, i1 false
  br i1 %541, label %542, label %559

542:                                              ; preds = %537, %550
  %543 = phi i64 [ %551, %550 ], [ 0, %537 ]
  br i1 %299, label %544, label %550

544:                                              ; preds = %542
  %545 = load i64, ptr %176, align 8
  %546 = mul nsw i64 %545, %538
  %547 = getelementptr inbounds double, ptr %2, i64 %546
  %548 = mul nsw i64 %545, %543
  %549 = getelementptr inbounds double, ptr %547, i64 %548
  br label %554

550:                                              ; preds = %554, %542
  %551 = add nuw nsw i64 %543, 1
  %552 = icmp ult i64 %543, 3
  %553 = select i1 %298, i1 %552, i1 false
  br i1 %553, label %542, label %559, !llvm.loop !20

554:                                              ; preds = %544, %554
  %555 = phi i64 [ 0, %544 ], [ %557, %554 ]
  %556 = getelementptr inbounds double, ptr %549, i64 %555
  tail call void @llvm.prefetch.p0(ptr %556, i32 0, i32 3, i32 1)
  %557 = add nuw nsw i64 %555, 8
  %558 = icmp slt i64 %557, %13
  br i1 %558, label %554, label %550, !llvm.loop !21

559:                                              ; preds = %550, %537
  br i1 %300, label %560, label %577

560:                                              ; preds = %559, %568
  %561 = phi i64 [ %569, %568 ], [ 0, %559 ]
  br i1 %301, label %562, label %568

562:                                              ; preds = %560
  %563 = load i64, ptr %23, align 8
  %564 = mul nsw i64 %563, %538
  %565 = getelementptr inbounds double, ptr %5, i64 %564
  %566 = mul nsw i64 %563, %561
  %567 = getelementptr inbounds double, ptr %565, i64 %566
  br label %572

568:                                              ; preds = %572, %560
  %569 = add nuw nsw i64 %561, 1
  %570 = icmp ult i64 %561, 3
  %571 = select i1 %300, i1 %570, i1 false
  br i1 %571, label %560, label %577, !llvm.loop !22

572:                                              ; preds = %562, %572
  %573 = phi i64 [ 0, %562 ], [ %575, %572 ]
  %574 = getelementptr inbounds double, ptr %567, i64 %573
  tail call void @llvm.prefetch.p0(ptr %574, i32 1, i32 3, i32 1)
  %575 = add nuw nsw i64 %573, 8
  %576 = icmp slt i64 %575, %17
  br i1 %576, label %572, label %568, !llvm.loop !23

577:                                              ; preds = %568, %559, %523
  %578 = load ptr, ptr %0, align 8
  %579 = getelementptr inbounds double, ptr %1, i64 %527
  %580 = mul i64 %302, %524
  %581 = getelementptr inbounds i8, ptr %39, i64 %580
  %582 = tail call i32 %578(ptr noundef %579, ptr noundef nonnull %581, ptr noundef nonnull %530, ptr noundef %34, ptr noundef nonnull %533) #4
  %583 = sext i32 %582 to i64
  %584 = getelementptr inbounds i8, ptr %6, i64 %527
  %585 = icmp eq i32 %582, 0
  br i1 %585, label %594, label %586

586:                                              ; preds = %577, %586
  %587 = phi i64 [ %592, %586 ], [ 0, %577 ]
  %588 = lshr i64 %583, %587
  %589 = trunc i64 %588 to i8
  %590 = and i8 %589, 1
  %591 = getelementptr inbounds i8, ptr %584, i64 %587
  store i8 %590, ptr %591, align 1
  %592 = add nuw nsw i64 %587, 1
  %593 = icmp eq i64 %592, 4
  br i1 %593, label %594, label %586, !llvm.loop !7

594:                                              ; preds = %586, %577
  br i1 %303, label %595, label %606

595:                                              ; preds = %594, %595
  %596 = phi <4 x i64> [ %603, %595 ], [ %525, %594 ]
  %597 = phi i64 [ %604, %595 ], [ 0, %594 ]
  %598 = shl nsw i64 %597, 5
  %599 = getelementptr inbounds i8, ptr %533, i64 %598
  %600 = load <4 x double>, ptr %599, align 8
  %601 = fsub <4 x double> %600, %600
  %602 = bitcast <4 x double> %601 to <4 x i64>
  %603 = or <4 x i64> %596, %602
  %604 = add nuw nsw i64 %597, 1
  %605 = icmp eq i64 %604, %17
  br i1 %605, label %606, label %595, !llvm.loop !24

606:                                              ; preds = %595, %594
  %607 = phi <4 x i64> [ %525, %594 ], [ %603, %595 ]
  br i1 %26, label %608, label %666

608:                                              ; preds = %606
  %609 = load i64, ptr %23, align 8
  %610 = mul nsw i64 %609, %527
  %611 = getelementptr inbounds double, ptr %5, i64 %610
  br i1 %304, label %612, label %615

612:                                              ; preds = %608
  %613 = shl i64 %609, 4
  %614 = mul i64 %609, 24
  br label %621

615:                                              ; preds = %621, %608
  %616 = phi i64 [ 0, %608 ], [ %648, %621 ]
  %617 = icmp slt i64 %616, %17
  br i1 %617, label %618, label %666

618:                                              ; preds = %615
  %619 = shl i64 %609, 4
  %620 = mul i64 %609, 24
  br label %651

621:                                              ; preds = %612, %621
  %622 = phi i64 [ %648, %621 ], [ 0, %612 ]
  %623 = tail call i64 @llvm.smin.i64(i64 %622, i64 %305)
  %624 = getelementptr double, ptr %611, i64 %623
  %625 = shl nsw i64 %623, 5
  %626 = getelementptr inbounds i8, ptr %47, i64 %625
  %627 = load <4 x double>, ptr %626, align 8
  %628 = shl i64 %623, 5
  %629 = getelementptr i8, ptr %307, i64 %628
  %630 = load <4 x double>, ptr %629, align 8
  %631 = shufflevector <4 x double> %627, <4 x double> %630, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %632 = shl i64 %623, 5
  %633 = getelementptr i8, ptr %308, i64 %632
  %634 = load <4 x double>, ptr %633, align 8
  %635 = shl i64 %623, 5
  %636 = getelementptr i8, ptr %309, i64 %635
  %637 = load <4 x double>, ptr %636, align 8
  %638 = shufflevector <4 x double> %634, <4 x double> %637, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %639 = shufflevector <4 x double> %631, <4 x double> %638, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %640 = shufflevector <4 x double> %627, <4 x double> %630, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %641 = shufflevector <4 x double> %634, <4 x double> %637, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %642 = shufflevector <4 x double> %640, <4 x double> %641, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %643 = shufflevector <4 x double> %631, <4 x double> %638, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %644 = shufflevector <4 x double> %640, <4 x double> %641, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  store <4 x double> %644, ptr %624, align 8
  %645 = getelementptr double, ptr %624, i64 %609
  store <4 x double> %643, ptr %645, align 8
  %646 = getelementptr i8, ptr %624, i64 %613
  store <4 x double> %642, ptr %646, align 8
  %647 = getelementptr i8, ptr %624, i64 %614
  store <4 x double> %639, ptr %647, align 8
  %648 = add nsw i64 %623, 4
  %649 = icmp slt i64 %648, %17
  %650 = select i1 %304, i1 %649, i1 false
  br i1 %650, label %621, label %615, !llvm.loop !25

651:                                              ; preds = %618, %651
  %652 = phi i64 [ %664, %651 ], [ %616, %618 ]
  %653 = getelementptr double, ptr %611, i64 %652
  %654 = shl nsw i64 %652, 5
  %655 = getelementptr inbounds i8, ptr %47, i64 %654
  %656 = load <4 x double>, ptr %655, align 8
  %657 = extractelement <4 x double> %656, i64 0
  store double %657, ptr %653, align 8
  %658 = extractelement <4 x double> %656, i64 1
  %659 = getelementptr double, ptr %653, i64 %609
  store double %658, ptr %659, align 8
  %660 = extractelement <4 x double> %656, i64 2
  %661 = getelementptr i8, ptr %653, i64 %619
  store double %660, ptr %661, align 8
  %662 = extractelement <4 x double> %656, i64 3
  %663 = getelementptr i8, ptr %653, i64 %620
  store double %662, ptr %663, align 8
  %664 = add nsw i64 %652, 1
  %665 = icmp eq i64 %664, %17
  br i1 %665, label %666, label %651, !llvm.loop !26

666:                                              ; preds = %651, %615, %606
  %667 = add nuw nsw i64 %524, 1
  %668 = icmp eq i64 %667, %318
  br i1 %668, label %521, label %523, !llvm.loop !27

669:                                              ; preds = %521
  %670 = load i64, ptr %24, align 8
  %671 = getelementptr inbounds double, ptr %5, i64 %317
  br i1 %306, label %672, label %693

672:                                              ; preds = %669
  %673 = icmp sgt i64 %318, 0
  br label %674

674:                                              ; preds = %672, %679
  %675 = phi i64 [ 0, %672 ], [ %680, %679 ]
  br i1 %673, label %676, label %679

676:                                              ; preds = %674
  %677 = mul nsw i64 %675, %670
  %678 = getelementptr inbounds double, ptr %671, i64 %677
  br label %682

679:                                              ; preds = %682, %674
  %680 = add nuw nsw i64 %675, 1
  %681 = icmp eq i64 %680, %17
  br i1 %681, label %693, label %674, !llvm.loop !28

682:                                              ; preds = %676, %682
  %683 = phi i64 [ 0, %676 ], [ %691, %682 ]
  %684 = mul nuw nsw i64 %683, %17
  %685 = add nuw nsw i64 %684, %675
  %686 = shl nsw i64 %685, 5
  %687 = getelementptr inbounds i8, ptr %47, i64 %686
  %688 = load <4 x double>, ptr %687, align 8
  %689 = shl nsw i64 %683, 5
  %690 = getelementptr inbounds i8, ptr %678, i64 %689
  store <4 x double> %688, ptr %690, align 8
  %691 = add nuw nsw i64 %683, 1
  %692 = icmp eq i64 %691, %318
  br i1 %692, label %679, label %682, !llvm.loop !29

693:                                              ; preds = %679, %669, %521
  %694 = shl nsw i64 %318, 2
  %695 = add nsw i64 %317, %694
  %696 = icmp slt i64 %695, %11
  br i1 %696, label %310, label %697, !llvm.loop !30

697:                                              ; preds = %693
  %698 = extractelement <4 x i64> %522, i64 0
  %699 = icmp eq i64 %698, 0
  %700 = extractelement <4 x i64> %522, i64 1
  %701 = icmp eq i64 %700, 0
  %702 = extractelement <4 x i64> %522, i64 2
  %703 = icmp eq i64 %702, 0
  %704 = extractelement <4 x i64> %522, i64 3
  %705 = icmp eq i64 %704, 0
  %706 = select i1 %705, i1 %703, i1 false
  %707 = select i1 %706, i1 %701, i1 false
  %708 = select i1 %707, i1 %699, i1 false
  %709 = zext i1 %708 to i64
  br label %710

710:                                              ; preds = %159, %272, %697, %8
  %711 = phi i64 [ 1, %8 ], [ 0, %272 ], [ %709, %697 ], [ 0, %159 ]
  ret i64 %711
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
