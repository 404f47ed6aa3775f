; sources f91957c56a1cc6c68ce18e6f1945a67f321c563665fc42e092901554d9e4bf65
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
  %26 = icmp ne i64 %25, 1
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
  br i1 %48, label %757, label %49

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
  br i1 %161, label %757, label %156, !llvm.loop !12

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
  %177 = load i64, ptr %176, align 8
  %178 = icmp eq i64 %177, 1
  br i1 %178, label %179, label %186

179:                                              ; preds = %175
  %180 = load i64, ptr %23, align 8
  %181 = icmp eq i64 %180, 1
  %182 = select i1 %181, i1 %22, i1 false
  br i1 %182, label %183, label %186

183:                                              ; preds = %179
  %184 = load i64, ptr %18, align 8
  %185 = icmp eq i64 %184, 1
  br label %186

186:                                              ; preds = %179, %183, %175
  %187 = phi i1 [ %181, %179 ], [ false, %175 ], [ %185, %183 ]
  %188 = getelementptr inbounds i8, ptr %0, i64 80
  %189 = load i64, ptr %188, align 8
  %190 = icmp sgt i64 %11, %189
  br i1 %190, label %191, label %204

191:                                              ; preds = %186
  %192 = getelementptr inbounds i8, ptr %0, i64 104
  %193 = load i64, ptr %192, align 8
  %194 = add nsw i64 %15, %13
  %195 = add nsw i64 %194, %17
  %196 = shl nsw i64 %193, 3
  %197 = sub nsw i64 0, %196
  %198 = and i64 %196, %197
  %199 = tail call i64 @llvm.smin.i64(i64 %198, i64 4096)
  %200 = tail call i64 @llvm.smax.i64(i64 %199, i64 64)
  %201 = udiv i64 4096, %200
  %202 = shl nuw nsw i64 %201, 2
  %203 = icmp sge i64 %202, %195
  br label %204

204:                                              ; preds = %191, %186
  %205 = phi i1 [ true, %186 ], [ %203, %191 ]
  %206 = getelementptr inbounds i8, ptr %0, i64 16
  %207 = load ptr, ptr %206, align 8
  %208 = icmp ne ptr %207, null
  %209 = select i1 %208, i1 %187, i1 false
  %210 = select i1 %209, i1 %205, i1 false
  br i1 %210, label %211, label %316

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
  %221 = getelementptr inbounds i8, ptr %0, i64 104
  %222 = load i64, ptr %221, align 8
  store i64 %222, ptr %9, align 16
  %223 = getelementptr inbounds i8, ptr %9, i64 8
  br i1 %219, label %227, label %224

224:                                              ; preds = %211
  %225 = getelementptr inbounds i8, ptr %0, i64 120
  %226 = load i64, ptr %225, align 8
  br label %227

227:                                              ; preds = %224, %211
  %228 = phi i64 [ %226, %224 ], [ 4, %211 ]
  store i64 %228, ptr %223, align 8
  %229 = getelementptr inbounds i8, ptr %9, i64 16
  %230 = load i64, ptr %24, align 8
  store i64 %230, ptr %229, align 16
  %231 = getelementptr inbounds i8, ptr %9, i64 24
  store i64 1, ptr %231, align 8
  %232 = getelementptr inbounds i8, ptr %9, i64 32
  store i64 %220, ptr %232, align 16
  %233 = getelementptr i8, ptr %6, i64 -4
  %234 = icmp sgt i64 %213, 0
  br i1 %234, label %235, label %303

235:                                              ; preds = %227
  %236 = icmp sgt i64 %213, 4
  %237 = sub nuw nsw i64 4, %217
  br label %238

238:                                              ; preds = %235, %278
  %239 = phi <4 x i64> [ zeroinitializer, %235 ], [ %279, %278 ]
  %240 = phi i64 [ 0, %235 ], [ %281, %278 ]
  %241 = call i64 @llvm.smin.i64(i64 %240, i64 %214)
  %242 = icmp eq i64 %240, 0
  br i1 %242, label %246, label %243

243:                                              ; preds = %238
  %244 = sub nsw i64 %213, %241
  %245 = sdiv i64 %244, 4
  store i64 %245, ptr %231, align 8
  br label %246

246:                                              ; preds = %243, %238
  %247 = load i64, ptr %18, align 8
  %248 = icmp eq i64 %247, 0
  %249 = select i1 %248, i64 0, i64 %241
  %250 = getelementptr inbounds double, ptr %212, i64 %249
  %251 = load ptr, ptr %206, align 8
  %252 = getelementptr inbounds double, ptr %1, i64 %241
  %253 = getelementptr inbounds double, ptr %2, i64 %241
  %254 = getelementptr inbounds double, ptr %5, i64 %241
  %255 = call i64 %251(ptr noundef %252, ptr noundef %253, ptr noundef %250, ptr noundef %34, ptr noundef %254, ptr noundef nonnull %9) #4
  %256 = ashr i64 %255, 32
  %257 = shl nsw i64 %256, 2
  %258 = add nsw i64 %257, %241
  %259 = shl i64 %255, 32
  %260 = ashr exact i64 %259, 32
  %261 = getelementptr i8, ptr %233, i64 %258
  %262 = icmp eq i64 %259, 0
  br i1 %262, label %271, label %263

263:                                              ; preds = %246, %263
  %264 = phi i64 [ %269, %263 ], [ 0, %246 ]
  %265 = lshr i64 %260, %264
  %266 = trunc i64 %265 to i8
  %267 = and i8 %266, 1
  %268 = getelementptr inbounds i8, ptr %261, i64 %264
  store i8 %267, ptr %268, align 1
  %269 = add nuw nsw i64 %264, 1
  %270 = icmp eq i64 %269, 4
  br i1 %270, label %271, label %263, !llvm.loop !7

271:                                              ; preds = %263, %246
  %272 = load i64, ptr %16, align 8
  %273 = getelementptr double, ptr %5, i64 %241
  %274 = icmp sgt i64 %272, 0
  br i1 %274, label %275, label %278

275:                                              ; preds = %271
  %276 = load i64, ptr %24, align 8
  %277 = icmp sgt i64 %256, 0
  br label %283

278:                                              ; preds = %299, %271
  %279 = phi <4 x i64> [ %239, %271 ], [ %300, %299 ]
  %280 = select i1 %242, i1 %236, i1 false
  %281 = select i1 %280, i64 %237, i64 %258
  %282 = icmp slt i64 %281, %213
  br i1 %282, label %238, label %303, !llvm.loop !14

283:                                              ; preds = %275, %299
  %284 = phi i64 [ 0, %275 ], [ %301, %299 ]
  %285 = phi <4 x i64> [ %239, %275 ], [ %300, %299 ]
  %286 = mul nsw i64 %276, %284
  %287 = getelementptr double, ptr %273, i64 %286
  br i1 %277, label %288, label %299

288:                                              ; preds = %283, %288
  %289 = phi <4 x i64> [ %296, %288 ], [ %285, %283 ]
  %290 = phi i64 [ %297, %288 ], [ 0, %283 ]
  %291 = shl nsw i64 %290, 5
  %292 = getelementptr inbounds i8, ptr %287, i64 %291
  %293 = load <4 x double>, ptr %292, align 8
  %294 = fsub <4 x double> %293, %293
  %295 = bitcast <4 x double> %294 to <4 x i64>
  %296 = or <4 x i64> %289, %295
  %297 = add nuw nsw i64 %290, 1
  %298 = icmp eq i64 %297, %256
  br i1 %298, label %299, label %288, !llvm.loop !15

299:                                              ; preds = %288, %283
  %300 = phi <4 x i64> [ %285, %283 ], [ %296, %288 ]
  %301 = add nuw nsw i64 %284, 1
  %302 = icmp eq i64 %301, %272
  br i1 %302, label %278, label %283, !llvm.loop !16

303:                                              ; preds = %278, %227
  %304 = phi <4 x i64> [ zeroinitializer, %227 ], [ %279, %278 ]
  %305 = extractelement <4 x i64> %304, i64 0
  %306 = icmp eq i64 %305, 0
  %307 = extractelement <4 x i64> %304, i64 1
  %308 = icmp eq i64 %307, 0
  %309 = extractelement <4 x i64> %304, i64 2
  %310 = icmp eq i64 %309, 0
  %311 = extractelement <4 x i64> %304, i64 3
  %312 = icmp eq i64 %311, 0
  %313 = select i1 %312, i1 %310, i1 false
  %314 = select i1 %313, i1 %308, i1 false
  %315 = select i1 %314, i1 %306, i1 false
  br label %757

316:                                              ; preds = %204
  %317 = getelementptr inbounds i8, ptr %0, i64 104
  %318 = load i64, ptr %317, align 8
  %319 = icmp ne i64 %318, 1
  %320 = select i1 %319, i1 true, i1 %26
  %321 = xor i1 %22, true
  %322 = select i1 %320, i1 true, i1 %321
  %323 = xor i1 %320, true
  br i1 %322, label %328, label %324

324:                                              ; preds = %316
  %325 = getelementptr inbounds i8, ptr %0, i64 120
  %326 = load i64, ptr %325, align 8
  %327 = icmp eq i64 %326, 1
  br label %328

328:                                              ; preds = %316, %324
  %329 = phi i1 [ %323, %316 ], [ %327, %324 ]
  br i1 %329, label %332, label %330

330:                                              ; preds = %328
  %331 = load i64, ptr %40, align 8
  br label %332

332:                                              ; preds = %330, %328
  %333 = phi i64 [ %331, %330 ], [ 1, %328 ]
  %334 = add nsw i64 %11, -4
  %335 = icmp sgt i64 %13, 0
  %336 = shl i64 %13, 5
  %337 = icmp sgt i64 %13, 3
  %338 = add nsw i64 %13, -4
  %339 = getelementptr inbounds i8, ptr %0, i64 120
  %340 = icmp sgt i64 %15, 0
  %341 = shl i64 %15, 5
  %342 = icmp sgt i64 %15, 3
  %343 = add nsw i64 %15, -4
  %344 = shl i64 %15, 5
  %345 = shl i64 %17, 5
  %346 = icmp slt i64 %13, 257
  %347 = icmp sgt i64 %13, 0
  %348 = icmp slt i64 %17, 257
  %349 = icmp sgt i64 %17, 0
  %350 = shl i64 %13, 5
  %351 = icmp sgt i64 %17, 0
  %352 = icmp sgt i64 %17, 3
  %353 = add nsw i64 %17, -4
  %354 = icmp sgt i64 %17, 0
  %355 = getelementptr i8, ptr %47, i64 32
  %356 = getelementptr i8, ptr %47, i64 64
  %357 = getelementptr i8, ptr %47, i64 96
  br label %370

358:                                              ; preds = %753
  %359 = extractelement <4 x i64> %582, i64 0
  %360 = icmp eq i64 %359, 0
  %361 = extractelement <4 x i64> %582, i64 1
  %362 = icmp eq i64 %361, 0
  %363 = extractelement <4 x i64> %582, i64 2
  %364 = icmp eq i64 %363, 0
  %365 = extractelement <4 x i64> %582, i64 3
  %366 = icmp eq i64 %365, 0
  %367 = select i1 %366, i1 %364, i1 false
  %368 = select i1 %367, i1 %362, i1 false
  %369 = select i1 %368, i1 %360, i1 false
  br label %757

370:                                              ; preds = %332, %753
  %371 = phi i64 [ 0, %332 ], [ %755, %753 ]
  %372 = phi <4 x i64> [ zeroinitializer, %332 ], [ %582, %753 ]
  %373 = sub nsw i64 %11, %371
  %374 = sdiv i64 %373, 4
  %375 = tail call i64 @llvm.smin.i64(i64 %333, i64 %374)
  %376 = icmp eq i64 %375, 0
  %377 = select i1 %376, i64 %334, i64 %371
  %378 = tail call i64 @llvm.umax.i64(i64 %375, i64 1)
  %379 = load i64, ptr %176, align 8
  %380 = mul nsw i64 %379, %377
  %381 = getelementptr inbounds double, ptr %2, i64 %380
  %382 = load i64, ptr %317, align 8
  %383 = icmp eq i64 %382, 1
  br i1 %383, label %387, label %384

384:                                              ; preds = %370
  br i1 %335, label %385, label %478

385:                                              ; preds = %384
  %386 = icmp sgt i64 %378, 0
  br label %459

387:                                              ; preds = %370
  %388 = icmp sgt i64 %378, 0
  br i1 %388, label %389, label %478

389:                                              ; preds = %387
  %390 = shl i64 %379, 2
  %391 = shl i64 %379, 4
  %392 = mul i64 %379, 24
  %393 = shl i64 %379, 4
  %394 = mul i64 %379, 24
  br label %395

395:                                              ; preds = %389, %456
  %396 = phi i64 [ 0, %389 ], [ %457, %456 ]
  %397 = mul i64 %390, %396
  %398 = getelementptr inbounds double, ptr %381, i64 %397
  %399 = mul i64 %336, %396
  %400 = getelementptr inbounds i8, ptr %39, i64 %399
  br i1 %337, label %401, label %405

401:                                              ; preds = %395
  %402 = getelementptr i8, ptr %400, i64 32
  %403 = getelementptr i8, ptr %400, i64 64
  %404 = getelementptr i8, ptr %400, i64 96
  br label %408

405:                                              ; preds = %408, %395
  %406 = phi i64 [ 0, %395 ], [ %435, %408 ]
  %407 = icmp slt i64 %406, %13
  br i1 %407, label %438, label %456

408:                                              ; preds = %401, %408
  %409 = phi i64 [ %435, %408 ], [ 0, %401 ]
  %410 = tail call i64 @llvm.smin.i64(i64 %409, i64 %338)
  %411 = getelementptr double, ptr %398, i64 %410
  %412 = load <4 x double>, ptr %411, align 8
  %413 = getelementptr double, ptr %411, i64 %379
  %414 = load <4 x double>, ptr %413, align 8
  %415 = shufflevector <4 x double> %412, <4 x double> %414, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %416 = getelementptr i8, ptr %411, i64 %391
  %417 = load <4 x double>, ptr %416, align 8
  %418 = getelementptr i8, ptr %411, i64 %392
  %419 = load <4 x double>, ptr %418, align 8
  %420 = shufflevector <4 x double> %417, <4 x double> %419, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %421 = shufflevector <4 x double> %415, <4 x double> %420, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %422 = shufflevector <4 x double> %412, <4 x double> %414, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %423 = shufflevector <4 x double> %417, <4 x double> %419, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %424 = shufflevector <4 x double> %422, <4 x double> %423, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %425 = shufflevector <4 x double> %415, <4 x double> %420, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %426 = shufflevector <4 x double> %422, <4 x double> %423, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %427 = shl nsw i64 %410, 5
  %428 = getelementptr inbounds i8, ptr %400, i64 %427
  store <4 x double> %426, ptr %428, align 8
  %429 = shl i64 %410, 5
  %430 = getelementptr i8, ptr %402, i64 %429
  store <4 x double> %425, ptr %430, align 8
  %431 = shl i64 %410, 5
  %432 = getelementptr i8, ptr %403, i64 %431
  store <4 x double> %424, ptr %432, align 8
  %433 = shl i64 %410, 5
  %434 = getelementptr i8, ptr %404, i64 %433
  store <4 x double> %421, ptr %434, align 8
  %435 = add nsw i64 %410, 4
  %436 = icmp slt i64 %435, %13
  %437 = select i1 %337, i1 %436, i1 false
  br i1 %437, label %408, label %405, !llvm.loop !17

438:                                              ; preds = %405, %438
  %439 = phi i64 [ %454, %438 ], [ %406, %405 ]
  %440 = getelementptr double, ptr %398, i64 %439
  %441 = load double, ptr %440, align 8
  %442 = insertelement <4 x double> poison, double %441, i64 0
  %443 = getelementptr double, ptr %440, i64 %379
  %444 = load double, ptr %443, align 8
  %445 = insertelement <4 x double> %442, double %444, i64 1
  %446 = getelementptr i8, ptr %440, i64 %393
  %447 = load double, ptr %446, align 8
  %448 = insertelement <4 x double> %445, double %447, i64 2
  %449 = getelementptr i8, ptr %440, i64 %394
  %450 = load double, ptr %449, align 8
  %451 = insertelement <4 x double> %448, double %450, i64 3
  %452 = shl nsw i64 %439, 5
  %453 = getelementptr inbounds i8, ptr %400, i64 %452
  store <4 x double> %451, ptr %453, align 8
  %454 = add nsw i64 %439, 1
  %455 = icmp eq i64 %454, %13
  br i1 %455, label %456, label %438, !llvm.loop !18

456:                                              ; preds = %438, %405
  %457 = add nuw nsw i64 %396, 1
  %458 = icmp eq i64 %457, %378
  br i1 %458, label %478, label %395, !llvm.loop !19

459:                                              ; preds = %385, %464
  %460 = phi i64 [ 0, %385 ], [ %465, %464 ]
  br i1 %386, label %461, label %464

461:                                              ; preds = %459
  %462 = mul nsw i64 %460, %382
  %463 = getelementptr inbounds double, ptr %381, i64 %462
  br label %467

464:                                              ; preds = %467, %459
  %465 = add nuw nsw i64 %460, 1
  %466 = icmp eq i64 %465, %13
  br i1 %466, label %478, label %459, !llvm.loop !20

467:                                              ; preds = %461, %467
  %468 = phi i64 [ 0, %461 ], [ %476, %467 ]
  %469 = shl nsw i64 %468, 5
  %470 = getelementptr inbounds i8, ptr %463, i64 %469
  %471 = load <4 x double>, ptr %470, align 8
  %472 = mul nuw nsw i64 %468, %13
  %473 = add nuw nsw i64 %472, %460
  %474 = shl nsw i64 %473, 5
  %475 = getelementptr inbounds i8, ptr %39, i64 %474
  store <4 x double> %471, ptr %475, align 32
  %476 = add nuw nsw i64 %468, 1
  %477 = icmp eq i64 %476, %378
  br i1 %477, label %464, label %467, !llvm.loop !21

478:                                              ; preds = %464, %456, %384, %387
  br i1 %22, label %479, label %579

479:                                              ; preds = %478
  %480 = load i64, ptr %18, align 8
  %481 = mul nsw i64 %480, %377
  %482 = getelementptr inbounds double, ptr %3, i64 %481
  %483 = load i64, ptr %339, align 8
  %484 = icmp eq i64 %483, 1
  br i1 %484, label %488, label %485

485:                                              ; preds = %479
  br i1 %340, label %486, label %579

486:                                              ; preds = %485
  %487 = icmp sgt i64 %378, 0
  br label %560

488:                                              ; preds = %479
  %489 = icmp sgt i64 %378, 0
  br i1 %489, label %490, label %579

490:                                              ; preds = %488
  %491 = shl i64 %480, 2
  %492 = shl i64 %480, 4
  %493 = mul i64 %480, 24
  %494 = shl i64 %480, 4
  %495 = mul i64 %480, 24
  br label %496

496:                                              ; preds = %490, %557
  %497 = phi i64 [ 0, %490 ], [ %558, %557 ]
  %498 = mul i64 %491, %497
  %499 = getelementptr inbounds double, ptr %482, i64 %498
  %500 = mul i64 %341, %497
  %501 = getelementptr inbounds i8, ptr %44, i64 %500
  br i1 %342, label %502, label %506

502:                                              ; preds = %496
  %503 = getelementptr i8, ptr %501, i64 32
  %504 = getelementptr i8, ptr %501, i64 64
  %505 = getelementptr i8, ptr %501, i64 96
  br label %509

506:                                              ; preds = %509, %496
  %507 = phi i64 [ 0, %496 ], [ %536, %509 ]
  %508 = icmp slt i64 %507, %15
  br i1 %508, label %539, label %557

509:                                              ; preds = %502, %509
  %510 = phi i64 [ %536, %509 ], [ 0, %502 ]
  %511 = tail call i64 @llvm.smin.i64(i64 %510, i64 %343)
  %512 = getelementptr double, ptr %499, i64 %511
  %513 = load <4 x double>, ptr %512, align 8
  %514 = getelementptr double, ptr %512, i64 %480
  %515 = load <4 x double>, ptr %514, align 8
  %516 = shufflevector <4 x double> %513, <4 x double> %515, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %517 = getelementptr i8, ptr %512, i64 %492
  %518 = load <4 x double>, ptr %517, align 8
  %519 = getelementptr i8, ptr %512, i64 %493
  %520 = load <4 x double>, ptr %519, align 8
  %521 = shufflevector <4 x double> %518, <4 x double> %520, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %522 = shufflevector <4 x double> %516, <4 x double> %521, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %523 = shufflevector <4 x double> %513, <4 x double> %515, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %524 = shufflevector <4 x double> %518, <4 x double> %520, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %525 = shufflevector <4 x double> %523, <4 x double> %524, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %526 = shufflevector <4 x double> %516, <4 x double> %521, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %527 = shufflevector <4 x double> %523, <4 x double> %524, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %528 = shl nsw i64 %511, 5
  %529 = getelementptr inbounds i8, ptr %501, i64 %528
  store <4 x double> %527, ptr %529, align 8
  %530 = shl i64 %511, 5
  %531 = getelementptr i8, ptr %503, i64 %530
  store <4 x double> %526, ptr %531, align 8
  %532 = shl i64 %511, 5
  %533 = getelementptr i8, ptr %504, i64 %532
  store <4 x double> %525, ptr %533, align 8
  %534 = shl i64 %511, 5
  %535 = getelementptr i8, ptr %505, i64 %534
  store <4 x double> %522, ptr %535, align 8
  %536 = add nsw i64 %511, 4
  %537 = icmp slt i64 %536, %15
  %538 = select i1 %342, i1 %537, i1 false
  br i1 %538, label %509, label %506, !llvm.loop !17

539:                                              ; preds = %506, %539
  %540 = phi i64 [ %555, %539 ], [ %507, %506 ]
  %541 = getelementptr double, ptr %499, i64 %540
  %542 = load double, ptr %541, align 8
  %543 = insertelement <4 x double> poison, double %542, i64 0
  %544 = getelementptr double, ptr %541, i64 %480
  %545 = load double, ptr %544, align 8
  %546 = insertelement <4 x double> %543, double %545, i64 1
  %547 = getelementptr i8, ptr %541, i64 %494
  %548 = load double, ptr %547, align 8
  %549 = insertelement <4 x double> %546, double %548, i64 2
  %550 = getelementptr i8, ptr %541, i64 %495
  %551 = load double, ptr %550, align 8
  %552 = insertelement <4 x double> %549, double %551, i64 3
  %553 = shl nsw i64 %540, 5
  %554 = getelementptr inbounds i8, ptr %501, i64 %553
  store <4 x double> %552, ptr %554, align 8
  %555 = add nsw i64 %540, 1
  %556 = icmp eq i64 %555, %15
  br i1 %556, label %557, label %539, !llvm.loop !18

557:                                              ; preds = %539, %506
  %558 = add nuw nsw i64 %497, 1
  %559 = icmp eq i64 %558, %378
  br i1 %559, label %579, label %496, !llvm.loop !19

560:                                              ; preds = %486, %565
  %561 = phi i64 [ 0, %486 ], [ %566, %565 ]
  br i1 %487, label %562, label %565

562:                                              ; preds = %560
  %563 = mul nsw i64 %561, %483
  %564 = getelementptr inbounds double, ptr %482, i64 %563
  br label %568

565:                                              ; preds = %568, %560
  %566 = add nuw nsw i64 %561, 1
  %567 = icmp eq i64 %566, %15
  br i1 %567, label %579, label %560, !llvm.loop !20

568:                                              ; preds = %562, %568
  %569 = phi i64 [ 0, %562 ], [ %577, %568 ]
  %570 = shl nsw i64 %569, 5
  %571 = getelementptr inbounds i8, ptr %564, i64 %570
  %572 = load <4 x double>, ptr %571, align 8
  %573 = mul nuw nsw i64 %569, %15
  %574 = add nuw nsw i64 %573, %561
  %575 = shl nsw i64 %574, 5
  %576 = getelementptr inbounds i8, ptr %44, i64 %575
  store <4 x double> %572, ptr %576, align 8
  %577 = add nuw nsw i64 %569, 1
  %578 = icmp eq i64 %577, %378
  br i1 %578, label %565, label %568, !llvm.loop !21

579:                                              ; preds = %565, %557, %485, %488, %478
  %580 = icmp sgt i64 %378, 0
  br i1 %580, label %583, label %581

581:                                              ; preds = %726, %579
  %582 = phi <4 x i64> [ %372, %579 ], [ %667, %726 ]
  br i1 %26, label %729, label %753

583:                                              ; preds = %579, %726
  %584 = phi i64 [ %727, %726 ], [ 0, %579 ]
  %585 = phi <4 x i64> [ %667, %726 ], [ %372, %579 ]
  %586 = shl nsw i64 %584, 2
  %587 = add nsw i64 %586, %377
  %588 = mul i64 %344, %584
  %589 = select i1 %20, i64 %588, i64 0
  %590 = getelementptr inbounds i8, ptr %44, i64 %589
  %591 = mul i64 %345, %584
  %592 = select i1 %26, i64 %591, i64 0
  %593 = getelementptr inbounds i8, ptr %47, i64 %592
  %594 = add nsw i64 %587, 8
  %595 = icmp sgt i64 %594, %11
  %596 = select i1 %26, i1 true, i1 %595
  br i1 %596, label %637, label %597

597:                                              ; preds = %583
  %598 = add nsw i64 %587, 4
  %599 = load i64, ptr %317, align 8
  %600 = icmp eq i64 %599, 1
  %601 = select i1 %600, i1 %346, i1 false
  br i1 %601, label %602, label %619

602:                                              ; preds = %597, %610
  %603 = phi i64 [ %611, %610 ], [ 0, %597 ]
  br i1 %347, label %604, label %610

604:                                              ; preds = %602
  %605 = load i64, ptr %176, align 8
  %606 = mul nsw i64 %605, %598
  %607 = getelementptr inbounds double, ptr %2, i64 %606
  %608 = mul nsw i64 %605, %603
  %609 = getelementptr inbounds double, ptr %607, i64 %608
  br label %614

610:                                              ; preds = %614, %602
  %611 = add nuw nsw i64 %603, 1
  %612 = icmp ult i64 %603, 3
  %613 = select i1 %346, i1 %612, i1 false
  br i1 %613, label %602, label %619, !llvm.loop !22

614:                                              ; preds = %604, %614
  %615 = phi i64 [ 0, %604 ], [ %617, %614 ]
  %616 = getelementptr inbounds double, ptr %609, i64 %615
  tail call void @llvm.prefetch.p0(ptr %616, i32 0, i32 3, i32 1)
  %617 = add nuw nsw i64 %615, 8
  %618 = icmp slt i64 %617, %13
  br i1 %618, label %614, label %610, !llvm.loop !23

619:                                              ; preds = %610, %597
  br i1 %348, label %620, label %637

620:                                              ; preds = %619, %628
  %621 = phi i64 [ %629, %628 ], [ 0, %619 ]
  br i1 %349, label %622, label %628

622:                                              ; preds = %620
  %623 = load i64, ptr %23, align 8
  %624 = mul nsw i64 %623, %598
  %625 = getelementptr inbounds double, ptr %5, i64 %624
  %626 = mul nsw i64 %623, %621
  %627 = getelementptr inbounds double, ptr %625, i64 %626
  br label %632

628:                                              ; preds = %632, %620
  %629 = add nuw nsw i64 %621, 1
  %630 = icmp ult i64 %621, 3
  %631 = select i1 %348, i1 %630, i1 false
  br i1 %631, label %620, label %637, !llvm.loop !24

632:                                              ; preds = %622, %632
  %633 = phi i64 [ 0, %622 ], [ %635, %632 ]
  %634 = getelementptr inbounds double, ptr %627, i64 %633
  tail call void @llvm.prefetch.p0(ptr %634, i32 1, i32 3, i32 1)
  %635 = add nuw nsw i64 %633, 8
  %636 = icmp slt i64 %635, %17
  br i1 %636, label %632, label %628, !llvm.loop !25

637:                                              ; preds = %628, %619, %583
  %638 = load ptr, ptr %0, align 8
  %639 = getelementptr inbounds double, ptr %1, i64 %587
  %640 = mul i64 %350, %584
  %641 = getelementptr inbounds i8, ptr %39, i64 %640
  %642 = tail call i32 %638(ptr noundef %639, ptr noundef nonnull %641, ptr noundef nonnull %590, ptr noundef %34, ptr noundef nonnull %593) #4
  %643 = sext i32 %642 to i64
  %644 = getelementptr inbounds i8, ptr %6, i64 %587
  %645 = icmp eq i32 %642, 0
  br i1 %645, label %654, label %646

646:                                              ; preds = %637, %646
  %647 = phi i64 [ %652, %646 ], [ 0, %637 ]
  %648 = lshr i64 %643, %647
  %649 = trunc i64 %648 to i8
  %650 = and i8 %649, 1
  %651 = getelementptr inbounds i8, ptr %644, i64 %647
  store i8 %650, ptr %651, align 1
  %652 = add nuw nsw i64 %647, 1
  %653 = icmp eq i64 %652, 4
  br i1 %653, label %654, label %646, !llvm.loop !7

654:                                              ; preds = %646, %637
  br i1 %351, label %655, label %666

655:                                              ; preds = %654, %655
  %656 = phi <4 x i64> [ %663, %655 ], [ %585, %654 ]
  %657 = phi i64 [ %664, %655 ], [ 0, %654 ]
  %658 = shl nsw i64 %657, 5
  %659 = getelementptr inbounds i8, ptr %593, i64 %658
  %660 = load <4 x double>, ptr %659, align 8
  %661 = fsub <4 x double> %660, %660
  %662 = bitcast <4 x double> %661 to <4 x i64>
  %663 = or <4 x i64> %656, %662
  %664 = add nuw nsw i64 %657, 1
  %665 = icmp eq i64 %664, %17
  br i1 %665, label %666, label %655, !llvm.loop !15

666:                                              ; preds = %655, %654
  %667 = phi <4 x i64> [ %585, %654 ], [ %663, %655 ]
  br i1 %26, label %726, label %668

668:                                              ; preds = %666
  %669 = load i64, ptr %23, align 8
  %670 = mul nsw i64 %669, %587
  %671 = getelementptr inbounds double, ptr %5, i64 %670
  br i1 %352, label %672, label %675

672:                                              ; preds = %668
  %673 = shl i64 %669, 4
  %674 = mul i64 %669, 24
  br label %681

675:                                              ; preds = %681, %668
  %676 = phi i64 [ 0, %668 ], [ %708, %681 ]
  %677 = icmp slt i64 %676, %17
  br i1 %677, label %678, label %726

678:                                              ; preds = %675
  %679 = shl i64 %669, 4
  %680 = mul i64 %669, 24
  br label %711

681:                                              ; preds = %672, %681
  %682 = phi i64 [ %708, %681 ], [ 0, %672 ]
  %683 = tail call i64 @llvm.smin.i64(i64 %682, i64 %353)
  %684 = getelementptr double, ptr %671, i64 %683
  %685 = shl nsw i64 %683, 5
  %686 = getelementptr inbounds i8, ptr %47, i64 %685
  %687 = load <4 x double>, ptr %686, align 8
  %688 = shl i64 %683, 5
  %689 = getelementptr i8, ptr %355, i64 %688
  %690 = load <4 x double>, ptr %689, align 8
  %691 = shufflevector <4 x double> %687, <4 x double> %690, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %692 = shl i64 %683, 5
  %693 = getelementptr i8, ptr %356, i64 %692
  %694 = load <4 x double>, ptr %693, align 8
  %695 = shl i64 %683, 5
  %696 = getelementptr i8, ptr %357, i64 %695
  %697 = load <4 x double>, ptr %696, align 8
  %698 = shufflevector <4 x double> %694, <4 x double> %697, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %699 = shufflevector <4 x double> %691, <4 x double> %698, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %700 = shufflevector <4 x double> %687, <4 x double> %690, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %701 = shufflevector <4 x double> %694, <4 x double> %697, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %702 = shufflevector <4 x double> %700, <4 x double> %701, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %703 = shufflevector <4 x double> %691, <4 x double> %698, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %704 = shufflevector <4 x double> %700, <4 x double> %701, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  store <4 x double> %704, ptr %684, align 8
  %705 = getelementptr double, ptr %684, i64 %669
  store <4 x double> %703, ptr %705, align 8
  %706 = getelementptr i8, ptr %684, i64 %673
  store <4 x double> %702, ptr %706, align 8
  %707 = getelementptr i8, ptr %684, i64 %674
  store <4 x double> %699, ptr %707, align 8
  %708 = add nsw i64 %683, 4
  %709 = icmp slt i64 %708, %17
  %710 = select i1 %352, i1 %709, i1 false
  br i1 %710, label %681, label %675, !llvm.loop !26

711:                                              ; preds = %678, %711
  %712 = phi i64 [ %724, %711 ], [ %676, %678 ]
  %713 = getelementptr double, ptr %671, i64 %712
  %714 = shl nsw i64 %712, 5
  %715 = getelementptr inbounds i8, ptr %47, i64 %714
  %716 = load <4 x double>, ptr %715, align 8
  %717 = extractelement <4 x double> %716, i64 0
  store double %717, ptr %713, align 8
  %718 = extractelement <4 x double> %716, i64 1
  %719 = getelementptr double, ptr %713, i64 %669
  store double %718, ptr %719, align 8
  %720 = extractelement <4 x double> %716, i64 2
  %721 = getelementptr i8, ptr %713, i64 %679
  store double %720, ptr %721, align 8
  %722 = extractelement <4 x double> %716, i64 3
  %723 = getelementptr i8, ptr %713, i64 %680
  store double %722, ptr %723, align 8
  %724 = add nsw i64 %712, 1
  %725 = icmp eq i64 %724, %17
  br i1 %725, label %726, label %711, !llvm.loop !27

726:                                              ; preds = %711, %675, %666
  %727 = add nuw nsw i64 %584, 1
  %728 = icmp eq i64 %727, %378
  br i1 %728, label %581, label %583, !llvm.loop !28

729:                                              ; preds = %581
  %730 = load i64, ptr %24, align 8
  %731 = getelementptr inbounds double, ptr %5, i64 %377
  br i1 %354, label %732, label %753

732:                                              ; preds = %729
  %733 = icmp sgt i64 %378, 0
  br label %734

734:                                              ; preds = %732, %739
  %735 = phi i64 [ 0, %732 ], [ %740, %739 ]
  br i1 %733, label %736, label %739

736:                                              ; preds = %734
  %737 = mul nsw i64 %735, %730
  %738 = getelementptr inbounds double, ptr %731, i64 %737
  br label %742

739:                                              ; preds = %742, %734
  %740 = add nuw nsw i64 %735, 1
  %741 = icmp eq i64 %740, %17
  br i1 %741, label %753, label %734, !llvm.loop !29

742:                                              ; preds = %736, %742
  %743 = phi i64 [ 0, %736 ], [ %751, %742 ]
  %744 = mul nuw nsw i64 %743, %17
  %745 = add nuw nsw i64 %744, %735
  %746 = shl nsw i64 %745, 5
  %747 = getelementptr inbounds i8, ptr %47, i64 %746
  %748 = load <4 x double>, ptr %747, align 8
  %749 = shl nsw i64 %743, 5
  %750 = getelementptr inbounds i8, ptr %738, i64 %749
  store <4 x double> %748, ptr %750, align 8
  %751 = add nuw nsw i64 %743, 1
  %752 = icmp eq i64 %751, %378
  br i1 %752, label %739, label %742, !llvm.loop !30

753:                                              ; preds = %739, %729, %581
  %754 = shl nsw i64 %378, 2
  %755 = add nsw i64 %377, %754
  %756 = icmp slt i64 %755, %11
  br i1 %756, label %370, label %358, !llvm.loop !31

757:                                              ; preds = %159, %358, %303, %8
  %758 = phi i1 [ true, %8 ], [ %315, %303 ], [ %369, %358 ], [ false, %159 ]
  %759 = zext i1 %758 to i64
  ret i64 %759
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
!31 = distinct !{!31, !4, !5}
