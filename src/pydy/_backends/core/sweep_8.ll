; sources f02e5cf85e68bf26bc1f8b444534616c51bfdb9e0b37734a839afecf018644bb
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
  %26 = icmp ne i64 %25, 1
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
  br i1 %48, label %897, label %49

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
  br i1 %161, label %897, label %156, !llvm.loop !12

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
  br i1 %210, label %211, label %328

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
  %228 = phi i64 [ %226, %224 ], [ 8, %211 ]
  store i64 %228, ptr %223, align 8
  %229 = getelementptr inbounds i8, ptr %9, i64 16
  %230 = load i64, ptr %24, align 8
  store i64 %230, ptr %229, align 16
  %231 = getelementptr inbounds i8, ptr %9, i64 24
  store i64 1, ptr %231, align 8
  %232 = getelementptr inbounds i8, ptr %9, i64 32
  store i64 %220, ptr %232, align 16
  %233 = getelementptr i8, ptr %6, i64 -8
  %234 = icmp sgt i64 %213, 0
  br i1 %234, label %235, label %303

235:                                              ; preds = %227
  %236 = icmp sgt i64 %213, 8
  %237 = sub nuw nsw i64 8, %217
  br label %238

238:                                              ; preds = %235, %278
  %239 = phi <8 x i64> [ zeroinitializer, %235 ], [ %279, %278 ]
  %240 = phi i64 [ 0, %235 ], [ %281, %278 ]
  %241 = call i64 @llvm.smin.i64(i64 %240, i64 %214)
  %242 = icmp eq i64 %240, 0
  br i1 %242, label %246, label %243

243:                                              ; preds = %238
  %244 = sub nsw i64 %213, %241
  %245 = sdiv i64 %244, 8
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
  %257 = shl nsw i64 %256, 3
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
  %270 = icmp eq i64 %269, 8
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
  %279 = phi <8 x i64> [ %239, %271 ], [ %300, %299 ]
  %280 = select i1 %242, i1 %236, i1 false
  %281 = select i1 %280, i64 %237, i64 %258
  %282 = icmp slt i64 %281, %213
  br i1 %282, label %238, label %303, !llvm.loop !14

283:                                              ; preds = %275, %299
  %284 = phi i64 [ 0, %275 ], [ %301, %299 ]
  %285 = phi <8 x i64> [ %239, %275 ], [ %300, %299 ]
  %286 = mul nsw i64 %276, %284
  %287 = getelementptr double, ptr %273, i64 %286
  br i1 %277, label %288, label %299

288:                                              ; preds = %283, %288
  %289 = phi <8 x i64> [ %296, %288 ], [ %285, %283 ]
  %290 = phi i64 [ %297, %288 ], [ 0, %283 ]
  %291 = shl nsw i64 %290, 6
  %292 = getelementptr inbounds i8, ptr %287, i64 %291
  %293 = load <8 x double>, ptr %292, align 8
  %294 = fsub <8 x double> %293, %293
  %295 = bitcast <8 x double> %294 to <8 x i64>
  %296 = or <8 x i64> %289, %295
  %297 = add nuw nsw i64 %290, 1
  %298 = icmp eq i64 %297, %256
  br i1 %298, label %299, label %288, !llvm.loop !15

299:                                              ; preds = %288, %283
  %300 = phi <8 x i64> [ %285, %283 ], [ %296, %288 ]
  %301 = add nuw nsw i64 %284, 1
  %302 = icmp eq i64 %301, %272
  br i1 %302, label %278, label %283, !llvm.loop !16

303:                                              ; preds = %278, %227
  %304 = phi <8 x i64> [ zeroinitializer, %227 ], [ %279, %278 ]
  %305 = extractelement <8 x i64> %304, i64 0
  %306 = icmp eq i64 %305, 0
  %307 = extractelement <8 x i64> %304, i64 1
  %308 = icmp eq i64 %307, 0
  %309 = extractelement <8 x i64> %304, i64 2
  %310 = icmp eq i64 %309, 0
  %311 = extractelement <8 x i64> %304, i64 3
  %312 = icmp eq i64 %311, 0
  %313 = extractelement <8 x i64> %304, i64 4
  %314 = icmp eq i64 %313, 0
  %315 = extractelement <8 x i64> %304, i64 5
  %316 = icmp eq i64 %315, 0
  %317 = extractelement <8 x i64> %304, i64 6
  %318 = icmp eq i64 %317, 0
  %319 = extractelement <8 x i64> %304, i64 7
  %320 = icmp eq i64 %319, 0
  %321 = select i1 %320, i1 %318, i1 false
  %322 = select i1 %321, i1 %316, i1 false
  %323 = select i1 %322, i1 %314, i1 false
  %324 = select i1 %323, i1 %312, i1 false
  %325 = select i1 %324, i1 %310, i1 false
  %326 = select i1 %325, i1 %308, i1 false
  %327 = select i1 %326, i1 %306, i1 false
  br label %897

328:                                              ; preds = %204
  %329 = getelementptr inbounds i8, ptr %0, i64 104
  %330 = load i64, ptr %329, align 8
  %331 = icmp ne i64 %330, 1
  %332 = select i1 %331, i1 true, i1 %26
  %333 = xor i1 %22, true
  %334 = select i1 %332, i1 true, i1 %333
  %335 = xor i1 %332, true
  br i1 %334, label %340, label %336

336:                                              ; preds = %328
  %337 = getelementptr inbounds i8, ptr %0, i64 120
  %338 = load i64, ptr %337, align 8
  %339 = icmp eq i64 %338, 1
  br label %340

340:                                              ; preds = %328, %336
  %341 = phi i1 [ %335, %328 ], [ %339, %336 ]
  br i1 %341, label %344, label %342

342:                                              ; preds = %340
  %343 = load i64, ptr %40, align 8
  br label %344

344:                                              ; preds = %342, %340
  %345 = phi i64 [ %343, %342 ], [ 1, %340 ]
  %346 = add nsw i64 %11, -8
  %347 = icmp sgt i64 %13, 0
  %348 = shl i64 %13, 6
  %349 = icmp sgt i64 %13, 3
  %350 = add nsw i64 %13, -4
  %351 = getelementptr inbounds i8, ptr %0, i64 120
  %352 = icmp sgt i64 %15, 0
  %353 = shl i64 %15, 6
  %354 = icmp sgt i64 %15, 3
  %355 = add nsw i64 %15, -4
  %356 = shl i64 %15, 6
  %357 = shl i64 %17, 6
  %358 = icmp slt i64 %13, 257
  %359 = icmp sgt i64 %13, 0
  %360 = icmp slt i64 %17, 257
  %361 = icmp sgt i64 %17, 0
  %362 = shl i64 %13, 6
  %363 = icmp sgt i64 %17, 0
  %364 = icmp sgt i64 %17, 3
  %365 = add nsw i64 %17, -4
  %366 = icmp sgt i64 %17, 0
  %367 = getelementptr i8, ptr %47, i64 64
  %368 = getelementptr i8, ptr %47, i64 128
  %369 = getelementptr i8, ptr %47, i64 192
  br label %394

370:                                              ; preds = %893
  %371 = extractelement <8 x i64> %686, i64 0
  %372 = icmp eq i64 %371, 0
  %373 = extractelement <8 x i64> %686, i64 1
  %374 = icmp eq i64 %373, 0
  %375 = extractelement <8 x i64> %686, i64 2
  %376 = icmp eq i64 %375, 0
  %377 = extractelement <8 x i64> %686, i64 3
  %378 = icmp eq i64 %377, 0
  %379 = extractelement <8 x i64> %686, i64 4
  %380 = icmp eq i64 %379, 0
  %381 = extractelement <8 x i64> %686, i64 5
  %382 = icmp eq i64 %381, 0
  %383 = extractelement <8 x i64> %686, i64 6
  %384 = icmp eq i64 %383, 0
  %385 = extractelement <8 x i64> %686, i64 7
  %386 = icmp eq i64 %385, 0
  %387 = select i1 %386, i1 %384, i1 false
  %388 = select i1 %387, i1 %382, i1 false
  %389 = select i1 %388, i1 %380, i1 false
  %390 = select i1 %389, i1 %378, i1 false
  %391 = select i1 %390, i1 %376, i1 false
  %392 = select i1 %391, i1 %374, i1 false
  %393 = select i1 %392, i1 %372, i1 false
  br label %897

394:                                              ; preds = %344, %893
  %395 = phi i64 [ 0, %344 ], [ %895, %893 ]
  %396 = phi <8 x i64> [ zeroinitializer, %344 ], [ %686, %893 ]
  %397 = sub nsw i64 %11, %395
  %398 = sdiv i64 %397, 8
  %399 = tail call i64 @llvm.smin.i64(i64 %345, i64 %398)
  %400 = icmp eq i64 %399, 0
  %401 = select i1 %400, i64 %346, i64 %395
  %402 = tail call i64 @llvm.umax.i64(i64 %399, i64 1)
  %403 = load i64, ptr %176, align 8
  %404 = mul nsw i64 %403, %401
  %405 = getelementptr inbounds double, ptr %2, i64 %404
  %406 = load i64, ptr %329, align 8
  %407 = icmp eq i64 %406, 1
  br i1 %407, label %411, label %408

408:                                              ; preds = %394
  br i1 %347, label %409, label %542

409:                                              ; preds = %408
  %410 = icmp sgt i64 %402, 0
  br label %523

411:                                              ; preds = %394
  %412 = icmp sgt i64 %402, 0
  br i1 %412, label %413, label %542

413:                                              ; preds = %411
  %414 = shl i64 %403, 3
  %415 = shl i64 %403, 5
  %416 = mul i64 %403, 40
  %417 = mul i64 %403, 48
  %418 = mul i64 %403, 56
  %419 = shl i64 %403, 4
  %420 = mul i64 %403, 24
  %421 = shl i64 %403, 4
  %422 = mul i64 %403, 24
  %423 = shl i64 %403, 5
  %424 = mul i64 %403, 40
  %425 = mul i64 %403, 48
  %426 = mul i64 %403, 56
  br label %427

427:                                              ; preds = %413, %520
  %428 = phi i64 [ 0, %413 ], [ %521, %520 ]
  %429 = mul i64 %414, %428
  %430 = getelementptr inbounds double, ptr %405, i64 %429
  %431 = mul i64 %348, %428
  %432 = getelementptr inbounds i8, ptr %39, i64 %431
  br i1 %349, label %433, label %437

433:                                              ; preds = %427
  %434 = getelementptr i8, ptr %432, i64 64
  %435 = getelementptr i8, ptr %432, i64 128
  %436 = getelementptr i8, ptr %432, i64 192
  br label %440

437:                                              ; preds = %440, %427
  %438 = phi i64 [ 0, %427 ], [ %487, %440 ]
  %439 = icmp slt i64 %438, %13
  br i1 %439, label %490, label %520

440:                                              ; preds = %433, %440
  %441 = phi i64 [ %487, %440 ], [ 0, %433 ]
  %442 = tail call i64 @llvm.smin.i64(i64 %441, i64 %350)
  %443 = getelementptr double, ptr %430, i64 %442
  %444 = getelementptr i8, ptr %443, i64 %415
  %445 = load <4 x double>, ptr %444, align 8
  %446 = getelementptr i8, ptr %443, i64 %416
  %447 = load <4 x double>, ptr %446, align 8
  %448 = shufflevector <4 x double> %445, <4 x double> %447, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %449 = getelementptr i8, ptr %443, i64 %417
  %450 = load <4 x double>, ptr %449, align 8
  %451 = getelementptr i8, ptr %443, i64 %418
  %452 = load <4 x double>, ptr %451, align 8
  %453 = shufflevector <4 x double> %450, <4 x double> %452, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %454 = shufflevector <4 x double> %448, <4 x double> %453, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %455 = shufflevector <4 x double> %445, <4 x double> %447, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %456 = shufflevector <4 x double> %450, <4 x double> %452, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %457 = shufflevector <4 x double> %455, <4 x double> %456, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %458 = shufflevector <4 x double> %448, <4 x double> %453, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %459 = shufflevector <4 x double> %455, <4 x double> %456, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %460 = load <4 x double>, ptr %443, align 8
  %461 = getelementptr double, ptr %443, i64 %403
  %462 = load <4 x double>, ptr %461, align 8
  %463 = shufflevector <4 x double> %460, <4 x double> %462, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %464 = getelementptr i8, ptr %443, i64 %419
  %465 = load <4 x double>, ptr %464, align 8
  %466 = getelementptr i8, ptr %443, i64 %420
  %467 = load <4 x double>, ptr %466, align 8
  %468 = shufflevector <4 x double> %465, <4 x double> %467, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %469 = shufflevector <4 x double> %463, <4 x double> %468, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %470 = shufflevector <4 x double> %460, <4 x double> %462, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %471 = shufflevector <4 x double> %465, <4 x double> %467, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %472 = shufflevector <4 x double> %470, <4 x double> %471, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %473 = shufflevector <4 x double> %463, <4 x double> %468, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %474 = shufflevector <4 x double> %470, <4 x double> %471, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %475 = shufflevector <4 x double> %474, <4 x double> %459, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %476 = shl nsw i64 %442, 6
  %477 = getelementptr inbounds i8, ptr %432, i64 %476
  store <8 x double> %475, ptr %477, align 8
  %478 = shufflevector <4 x double> %473, <4 x double> %458, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %479 = shl i64 %442, 6
  %480 = getelementptr i8, ptr %434, i64 %479
  store <8 x double> %478, ptr %480, align 8
  %481 = shufflevector <4 x double> %472, <4 x double> %457, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %482 = shl i64 %442, 6
  %483 = getelementptr i8, ptr %435, i64 %482
  store <8 x double> %481, ptr %483, align 8
  %484 = shufflevector <4 x double> %469, <4 x double> %454, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %485 = shl i64 %442, 6
  %486 = getelementptr i8, ptr %436, i64 %485
  store <8 x double> %484, ptr %486, align 8
  %487 = add nsw i64 %442, 4
  %488 = icmp slt i64 %487, %13
  %489 = select i1 %349, i1 %488, i1 false
  br i1 %489, label %440, label %437, !llvm.loop !17

490:                                              ; preds = %437, %490
  %491 = phi i64 [ %518, %490 ], [ %438, %437 ]
  %492 = getelementptr double, ptr %430, i64 %491
  %493 = load double, ptr %492, align 8
  %494 = insertelement <8 x double> poison, double %493, i64 0
  %495 = getelementptr double, ptr %492, i64 %403
  %496 = load double, ptr %495, align 8
  %497 = insertelement <8 x double> %494, double %496, i64 1
  %498 = getelementptr i8, ptr %492, i64 %421
  %499 = load double, ptr %498, align 8
  %500 = insertelement <8 x double> %497, double %499, i64 2
  %501 = getelementptr i8, ptr %492, i64 %422
  %502 = load double, ptr %501, align 8
  %503 = insertelement <8 x double> %500, double %502, i64 3
  %504 = getelementptr i8, ptr %492, i64 %423
  %505 = load double, ptr %504, align 8
  %506 = insertelement <8 x double> %503, double %505, i64 4
  %507 = getelementptr i8, ptr %492, i64 %424
  %508 = load double, ptr %507, align 8
  %509 = insertelement <8 x double> %506, double %508, i64 5
  %510 = getelementptr i8, ptr %492, i64 %425
  %511 = load double, ptr %510, align 8
  %512 = insertelement <8 x double> %509, double %511, i64 6
  %513 = getelementptr i8, ptr %492, i64 %426
  %514 = load double, ptr %513, align 8
  %515 = insertelement <8 x double> %512, double %514, i64 7
  %516 = shl nsw i64 %491, 6
  %517 = getelementptr inbounds i8, ptr %432, i64 %516
  store <8 x double> %515, ptr %517, align 8
  %518 = add nsw i64 %491, 1
  %519 = icmp eq i64 %518, %13
  br i1 %519, label %520, label %490, !llvm.loop !18

520:                                              ; preds = %490, %437
  %521 = add nuw nsw i64 %428, 1
  %522 = icmp eq i64 %521, %402
  br i1 %522, label %542, label %427, !llvm.loop !19

523:                                              ; preds = %409, %528
  %524 = phi i64 [ 0, %409 ], [ %529, %528 ]
  br i1 %410, label %525, label %528

525:                                              ; preds = %523
  %526 = mul nsw i64 %524, %406
  %527 = getelementptr inbounds double, ptr %405, i64 %526
  br label %531

528:                                              ; preds = %531, %523
  %529 = add nuw nsw i64 %524, 1
  %530 = icmp eq i64 %529, %13
  br i1 %530, label %542, label %523, !llvm.loop !20

531:                                              ; preds = %525, %531
  %532 = phi i64 [ 0, %525 ], [ %540, %531 ]
  %533 = shl nsw i64 %532, 6
  %534 = getelementptr inbounds i8, ptr %527, i64 %533
  %535 = load <8 x double>, ptr %534, align 8
  %536 = mul nuw nsw i64 %532, %13
  %537 = add nuw nsw i64 %536, %524
  %538 = shl nsw i64 %537, 6
  %539 = getelementptr inbounds i8, ptr %39, i64 %538
  store <8 x double> %535, ptr %539, align 64
  %540 = add nuw nsw i64 %532, 1
  %541 = icmp eq i64 %540, %402
  br i1 %541, label %528, label %531, !llvm.loop !21

542:                                              ; preds = %528, %520, %408, %411
  br i1 %22, label %543, label %683

543:                                              ; preds = %542
  %544 = load i64, ptr %18, align 8
  %545 = mul nsw i64 %544, %401
  %546 = getelementptr inbounds double, ptr %3, i64 %545
  %547 = load i64, ptr %351, align 8
  %548 = icmp eq i64 %547, 1
  br i1 %548, label %552, label %549

549:                                              ; preds = %543
  br i1 %352, label %550, label %683

550:                                              ; preds = %549
  %551 = icmp sgt i64 %402, 0
  br label %664

552:                                              ; preds = %543
  %553 = icmp sgt i64 %402, 0
  br i1 %553, label %554, label %683

554:                                              ; preds = %552
  %555 = shl i64 %544, 3
  %556 = shl i64 %544, 5
  %557 = mul i64 %544, 40
  %558 = mul i64 %544, 48
  %559 = mul i64 %544, 56
  %560 = shl i64 %544, 4
  %561 = mul i64 %544, 24
  %562 = shl i64 %544, 4
  %563 = mul i64 %544, 24
  %564 = shl i64 %544, 5
  %565 = mul i64 %544, 40
  %566 = mul i64 %544, 48
  %567 = mul i64 %544, 56
  br label %568

568:                                              ; preds = %554, %661
  %569 = phi i64 [ 0, %554 ], [ %662, %661 ]
  %570 = mul i64 %555, %569
  %571 = getelementptr inbounds double, ptr %546, i64 %570
  %572 = mul i64 %353, %569
  %573 = getelementptr inbounds i8, ptr %44, i64 %572
  br i1 %354, label %574, label %578

574:                                              ; preds = %568
  %575 = getelementptr i8, ptr %573, i64 64
  %576 = getelementptr i8, ptr %573, i64 128
  %577 = getelementptr i8, ptr %573, i64 192
  br label %581

578:                                              ; preds = %581, %568
  %579 = phi i64 [ 0, %568 ], [ %628, %581 ]
  %580 = icmp slt i64 %579, %15
  br i1 %580, label %631, label %661

581:                                              ; preds = %574, %581
  %582 = phi i64 [ %628, %581 ], [ 0, %574 ]
  %583 = tail call i64 @llvm.smin.i64(i64 %582, i64 %355)
  %584 = getelementptr double, ptr %571, i64 %583
  %585 = getelementptr i8, ptr %584, i64 %556
  %586 = load <4 x double>, ptr %585, align 8
  %587 = getelementptr i8, ptr %584, i64 %557
  %588 = load <4 x double>, ptr %587, align 8
  %589 = shufflevector <4 x double> %586, <4 x double> %588, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %590 = getelementptr i8, ptr %584, i64 %558
  %591 = load <4 x double>, ptr %590, align 8
  %592 = getelementptr i8, ptr %584, i64 %559
  %593 = load <4 x double>, ptr %592, align 8
  %594 = shufflevector <4 x double> %591, <4 x double> %593, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %595 = shufflevector <4 x double> %589, <4 x double> %594, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %596 = shufflevector <4 x double> %586, <4 x double> %588, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %597 = shufflevector <4 x double> %591, <4 x double> %593, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %598 = shufflevector <4 x double> %596, <4 x double> %597, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %599 = shufflevector <4 x double> %589, <4 x double> %594, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %600 = shufflevector <4 x double> %596, <4 x double> %597, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %601 = load <4 x double>, ptr %584, align 8
  %602 = getelementptr double, ptr %584, i64 %544
  %603 = load <4 x double>, ptr %602, align 8
  %604 = shufflevector <4 x double> %601, <4 x double> %603, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %605 = getelementptr i8, ptr %584, i64 %560
  %606 = load <4 x double>, ptr %605, align 8
  %607 = getelementptr i8, ptr %584, i64 %561
  %608 = load <4 x double>, ptr %607, align 8
  %609 = shufflevector <4 x double> %606, <4 x double> %608, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %610 = shufflevector <4 x double> %604, <4 x double> %609, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %611 = shufflevector <4 x double> %601, <4 x double> %603, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %612 = shufflevector <4 x double> %606, <4 x double> %608, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %613 = shufflevector <4 x double> %611, <4 x double> %612, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %614 = shufflevector <4 x double> %604, <4 x double> %609, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %615 = shufflevector <4 x double> %611, <4 x double> %612, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %616 = shufflevector <4 x double> %615, <4 x double> %600, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %617 = shl nsw i64 %583, 6
  %618 = getelementptr inbounds i8, ptr %573, i64 %617
  store <8 x double> %616, ptr %618, align 8
  %619 = shufflevector <4 x double> %614, <4 x double> %599, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %620 = shl i64 %583, 6
  %621 = getelementptr i8, ptr %575, i64 %620
  store <8 x double> %619, ptr %621, align 8
  %622 = shufflevector <4 x double> %613, <4 x double> %598, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %623 = shl i64 %583, 6
  %624 = getelementptr i8, ptr %576, i64 %623
  store <8 x double> %622, ptr %624, align 8
  %625 = shufflevector <4 x double> %610, <4 x double> %595, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %626 = shl i64 %583, 6
  %627 = getelementptr i8, ptr %577, i64 %626
  store <8 x double> %625, ptr %627, align 8
  %628 = add nsw i64 %583, 4
  %629 = icmp slt i64 %628, %15
  %630 = select i1 %354, i1 %629, i1 false
  br i1 %630, label %581, label %578, !llvm.loop !17

631:                                              ; preds = %578, %631
  %632 = phi i64 [ %659, %631 ], [ %579, %578 ]
  %633 = getelementptr double, ptr %571, i64 %632
  %634 = load double, ptr %633, align 8
  %635 = insertelement <8 x double> poison, double %634, i64 0
  %636 = getelementptr double, ptr %633, i64 %544
  %637 = load double, ptr %636, align 8
  %638 = insertelement <8 x double> %635, double %637, i64 1
  %639 = getelementptr i8, ptr %633, i64 %562
  %640 = load double, ptr %639, align 8
  %641 = insertelement <8 x double> %638, double %640, i64 2
  %642 = getelementptr i8, ptr %633, i64 %563
  %643 = load double, ptr %642, align 8
  %644 = insertelement <8 x double> %641, double %643, i64 3
  %645 = getelementptr i8, ptr %633, i64 %564
  %646 = load double, ptr %645, align 8
  %647 = insertelement <8 x double> %644, double %646, i64 4
  %648 = getelementptr i8, ptr %633, i64 %565
  %649 = load double, ptr %648, align 8
  %650 = insertelement <8 x double> %647, double %649, i64 5
  %651 = getelementptr i8, ptr %633, i64 %566
  %652 = load double, ptr %651, align 8
  %653 = insertelement <8 x double> %650, double %652, i64 6
  %654 = getelementptr i8, ptr %633, i64 %567
  %655 = load double, ptr %654, align 8
  %656 = insertelement <8 x double> %653, double %655, i64 7
  %657 = shl nsw i64 %632, 6
  %658 = getelementptr inbounds i8, ptr %573, i64 %657
  store <8 x double> %656, ptr %658, align 8
  %659 = add nsw i64 %632, 1
  %660 = icmp eq i64 %659, %15
  br i1 %660, label %661, label %631, !llvm.loop !18

661:                                              ; preds = %631, %578
  %662 = add nuw nsw i64 %569, 1
  %663 = icmp eq i64 %662, %402
  br i1 %663, label %683, label %568, !llvm.loop !19

664:                                              ; preds = %550, %669
  %665 = phi i64 [ 0, %550 ], [ %670, %669 ]
  br i1 %551, label %666, label %669

666:                                              ; preds = %664
  %667 = mul nsw i64 %665, %547
  %668 = getelementptr inbounds double, ptr %546, i64 %667
  br label %672

669:                                              ; preds = %672, %664
  %670 = add nuw nsw i64 %665, 1
  %671 = icmp eq i64 %670, %15
  br i1 %671, label %683, label %664, !llvm.loop !20

672:                                              ; preds = %666, %672
  %673 = phi i64 [ 0, %666 ], [ %681, %672 ]
  %674 = shl nsw i64 %673, 6
  %675 = getelementptr inbounds i8, ptr %668, i64 %674
  %676 = load <8 x double>, ptr %675, align 8
  %677 = mul nuw nsw i64 %673, %15
  %678 = add nuw nsw i64 %677, %665
  %679 = shl nsw i64 %678, 6
  %680 = getelementptr inbounds i8, ptr %44, i64 %679
  store <8 x double> %676, ptr %680, align 8
  %681 = add nuw nsw i64 %673, 1
  %682 = icmp eq i64 %681, %402
  br i1 %682, label %669, label %672, !llvm.loop !21

683:                                              ; preds = %669, %661, %549, %552, %542
  %684 = icmp sgt i64 %402, 0
  br i1 %684, label %687, label %685

685:                                              ; preds = %866, %683
  %686 = phi <8 x i64> [ %396, %683 ], [ %771, %866 ]
  br i1 %26, label %869, label %893

687:                                              ; preds = %683, %866
  %688 = phi i64 [ %867, %866 ], [ 0, %683 ]
  %689 = phi <8 x i64> [ %771, %866 ], [ %396, %683 ]
  %690 = shl nsw i64 %688, 3
  %691 = add nsw i64 %690, %401
  %692 = mul i64 %356, %688
  %693 = select i1 %20, i64 %692, i64 0
  %694 = getelementptr inbounds i8, ptr %44, i64 %693
  %695 = mul i64 %357, %688
  %696 = select i1 %26, i64 %695, i64 0
  %697 = getelementptr inbounds i8, ptr %47, i64 %696
  %698 = add nsw i64 %691, 16
  %699 = icmp sgt i64 %698, %11
  %700 = select i1 %26, i1 true, i1 %699
  br i1 %700, label %741, label %701

701:                                              ; preds = %687
  %702 = add nsw i64 %691, 8
  %703 = load i64, ptr %329, align 8
  %704 = icmp eq i64 %703, 1
  %705 = select i1 %704, i1 %358, i1 false
  br i1 %705, label %706, label %723

706:                                              ; preds = %701, %714
  %707 = phi i64 [ %715, %714 ], [ 0, %701 ]
  br i1 %359, label %708, label %714

708:                                              ; preds = %706
  %709 = load i64, ptr %176, align 8
  %710 = mul nsw i64 %709, %702
  %711 = getelementptr inbounds double, ptr %2, i64 %710
  %712 = mul nsw i64 %709, %707
  %713 = getelementptr inbounds double, ptr %711, i64 %712
  br label %718

714:                                              ; preds = %718, %706
  %715 = add nuw nsw i64 %707, 1
  %716 = icmp ult i64 %707, 7
  %717 = select i1 %358, i1 %716, i1 false
  br i1 %717, label %706, label %723, !llvm.loop !22

718:                                              ; preds = %708, %718
  %719 = phi i64 [ 0, %708 ], [ %721, %718 ]
  %720 = getelementptr inbounds double, ptr %713, i64 %719
  tail call void @llvm.prefetch.p0(ptr %720, i32 0, i32 3, i32 1)
  %721 = add nuw nsw i64 %719, 8
  %722 = icmp slt i64 %721, %13
  br i1 %722, label %718, label %714, !llvm.loop !23

723:                                              ; preds = %714, %701
  br i1 %360, label %724, label %741

724:                                              ; preds = %723, %732
  %725 = phi i64 [ %733, %732 ], [ 0, %723 ]
  br i1 %361, label %726, label %732

726:                                              ; preds = %724
  %727 = load i64, ptr %23, align 8
  %728 = mul nsw i64 %727, %702
  %729 = getelementptr inbounds double, ptr %5, i64 %728
  %730 = mul nsw i64 %727, %725
  %731 = getelementptr inbounds double, ptr %729, i64 %730
  br label %736

732:                                              ; preds = %736, %724
  %733 = add nuw nsw i64 %725, 1
  %734 = icmp ult i64 %725, 7
  %735 = select i1 %360, i1 %734, i1 false
  br i1 %735, label %724, label %741, !llvm.loop !24

736:                                              ; preds = %726, %736
  %737 = phi i64 [ 0, %726 ], [ %739, %736 ]
  %738 = getelementptr inbounds double, ptr %731, i64 %737
  tail call void @llvm.prefetch.p0(ptr %738, i32 1, i32 3, i32 1)
  %739 = add nuw nsw i64 %737, 8
  %740 = icmp slt i64 %739, %17
  br i1 %740, label %736, label %732, !llvm.loop !25

741:                                              ; preds = %732, %723, %687
  %742 = load ptr, ptr %0, align 8
  %743 = getelementptr inbounds double, ptr %1, i64 %691
  %744 = mul i64 %362, %688
  %745 = getelementptr inbounds i8, ptr %39, i64 %744
  %746 = tail call i32 %742(ptr noundef %743, ptr noundef nonnull %745, ptr noundef nonnull %694, ptr noundef %34, ptr noundef nonnull %697) #4
  %747 = sext i32 %746 to i64
  %748 = getelementptr inbounds i8, ptr %6, i64 %691
  %749 = icmp eq i32 %746, 0
  br i1 %749, label %758, label %750

750:                                              ; preds = %741, %750
  %751 = phi i64 [ %756, %750 ], [ 0, %741 ]
  %752 = lshr i64 %747, %751
  %753 = trunc i64 %752 to i8
  %754 = and i8 %753, 1
  %755 = getelementptr inbounds i8, ptr %748, i64 %751
  store i8 %754, ptr %755, align 1
  %756 = add nuw nsw i64 %751, 1
  %757 = icmp eq i64 %756, 8
  br i1 %757, label %758, label %750, !llvm.loop !7

758:                                              ; preds = %750, %741
  br i1 %363, label %759, label %770

759:                                              ; preds = %758, %759
  %760 = phi <8 x i64> [ %767, %759 ], [ %689, %758 ]
  %761 = phi i64 [ %768, %759 ], [ 0, %758 ]
  %762 = shl nsw i64 %761, 6
  %763 = getelementptr inbounds i8, ptr %697, i64 %762
  %764 = load <8 x double>, ptr %763, align 8
  %765 = fsub <8 x double> %764, %764
  %766 = bitcast <8 x double> %765 to <8 x i64>
  %767 = or <8 x i64> %760, %766
  %768 = add nuw nsw i64 %761, 1
  %769 = icmp eq i64 %768, %17
  br i1 %769, label %770, label %759, !llvm.loop !15

770:                                              ; preds = %759, %758
  %771 = phi <8 x i64> [ %689, %758 ], [ %767, %759 ]
  br i1 %26, label %866, label %772

772:                                              ; preds = %770
  %773 = load i64, ptr %23, align 8
  %774 = mul nsw i64 %773, %691
  %775 = getelementptr inbounds double, ptr %5, i64 %774
  br i1 %364, label %776, label %783

776:                                              ; preds = %772
  %777 = shl i64 %773, 4
  %778 = mul i64 %773, 24
  %779 = shl i64 %773, 5
  %780 = mul i64 %773, 40
  %781 = mul i64 %773, 48
  %782 = mul i64 %773, 56
  br label %793

783:                                              ; preds = %793, %772
  %784 = phi i64 [ 0, %772 ], [ %840, %793 ]
  %785 = icmp slt i64 %784, %17
  br i1 %785, label %786, label %866

786:                                              ; preds = %783
  %787 = shl i64 %773, 4
  %788 = mul i64 %773, 24
  %789 = shl i64 %773, 5
  %790 = mul i64 %773, 40
  %791 = mul i64 %773, 48
  %792 = mul i64 %773, 56
  br label %843

793:                                              ; preds = %776, %793
  %794 = phi i64 [ %840, %793 ], [ 0, %776 ]
  %795 = tail call i64 @llvm.smin.i64(i64 %794, i64 %365)
  %796 = getelementptr double, ptr %775, i64 %795
  %797 = shl nsw i64 %795, 6
  %798 = getelementptr inbounds i8, ptr %47, i64 %797
  %799 = load <8 x double>, ptr %798, align 8
  %800 = shufflevector <8 x double> %799, <8 x double> poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %801 = shl i64 %795, 6
  %802 = getelementptr i8, ptr %367, i64 %801
  %803 = load <8 x double>, ptr %802, align 8
  %804 = shufflevector <8 x double> %803, <8 x double> poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %805 = shufflevector <4 x double> %800, <4 x double> %804, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %806 = shl i64 %795, 6
  %807 = getelementptr i8, ptr %368, i64 %806
  %808 = load <8 x double>, ptr %807, align 8
  %809 = shufflevector <8 x double> %808, <8 x double> poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %810 = shl i64 %795, 6
  %811 = getelementptr i8, ptr %369, i64 %810
  %812 = load <8 x double>, ptr %811, align 8
  %813 = shufflevector <8 x double> %812, <8 x double> poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %814 = shufflevector <4 x double> %809, <4 x double> %813, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %815 = shufflevector <4 x double> %805, <4 x double> %814, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %816 = shufflevector <4 x double> %800, <4 x double> %804, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %817 = shufflevector <4 x double> %809, <4 x double> %813, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %818 = shufflevector <4 x double> %816, <4 x double> %817, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %819 = shufflevector <4 x double> %805, <4 x double> %814, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %820 = shufflevector <4 x double> %816, <4 x double> %817, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %821 = shufflevector <8 x double> %799, <8 x double> poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %822 = shufflevector <8 x double> %803, <8 x double> poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %823 = shufflevector <4 x double> %821, <4 x double> %822, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %824 = shufflevector <8 x double> %808, <8 x double> poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %825 = shufflevector <8 x double> %812, <8 x double> poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %826 = shufflevector <4 x double> %824, <4 x double> %825, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %827 = shufflevector <4 x double> %823, <4 x double> %826, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %828 = shufflevector <4 x double> %821, <4 x double> %822, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %829 = shufflevector <4 x double> %824, <4 x double> %825, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %830 = shufflevector <4 x double> %828, <4 x double> %829, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %831 = shufflevector <4 x double> %823, <4 x double> %826, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %832 = shufflevector <4 x double> %828, <4 x double> %829, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  store <4 x double> %832, ptr %796, align 8
  %833 = getelementptr double, ptr %796, i64 %773
  store <4 x double> %831, ptr %833, align 8
  %834 = getelementptr i8, ptr %796, i64 %777
  store <4 x double> %830, ptr %834, align 8
  %835 = getelementptr i8, ptr %796, i64 %778
  store <4 x double> %827, ptr %835, align 8
  %836 = getelementptr i8, ptr %796, i64 %779
  store <4 x double> %820, ptr %836, align 8
  %837 = getelementptr i8, ptr %796, i64 %780
  store <4 x double> %819, ptr %837, align 8
  %838 = getelementptr i8, ptr %796, i64 %781
  store <4 x double> %818, ptr %838, align 8
  %839 = getelementptr i8, ptr %796, i64 %782
  store <4 x double> %815, ptr %839, align 8
  %840 = add nsw i64 %795, 4
  %841 = icmp slt i64 %840, %17
  %842 = select i1 %364, i1 %841, i1 false
  br i1 %842, label %793, label %783, !llvm.loop !26

843:                                              ; preds = %786, %843
  %844 = phi i64 [ %864, %843 ], [ %784, %786 ]
  %845 = getelementptr double, ptr %775, i64 %844
  %846 = shl nsw i64 %844, 6
  %847 = getelementptr inbounds i8, ptr %47, i64 %846
  %848 = load <8 x double>, ptr %847, align 8
  %849 = extractelement <8 x double> %848, i64 0
  store double %849, ptr %845, align 8
  %850 = extractelement <8 x double> %848, i64 1
  %851 = getelementptr double, ptr %845, i64 %773
  store double %850, ptr %851, align 8
  %852 = extractelement <8 x double> %848, i64 2
  %853 = getelementptr i8, ptr %845, i64 %787
  store double %852, ptr %853, align 8
  %854 = extractelement <8 x double> %848, i64 3
  %855 = getelementptr i8, ptr %845, i64 %788
  store double %854, ptr %855, align 8
  %856 = extractelement <8 x double> %848, i64 4
  %857 = getelementptr i8, ptr %845, i64 %789
  store double %856, ptr %857, align 8
  %858 = extractelement <8 x double> %848, i64 5
  %859 = getelementptr i8, ptr %845, i64 %790
  store double %858, ptr %859, align 8
  %860 = extractelement <8 x double> %848, i64 6
  %861 = getelementptr i8, ptr %845, i64 %791
  store double %860, ptr %861, align 8
  %862 = extractelement <8 x double> %848, i64 7
  %863 = getelementptr i8, ptr %845, i64 %792
  store double %862, ptr %863, align 8
  %864 = add nsw i64 %844, 1
  %865 = icmp eq i64 %864, %17
  br i1 %865, label %866, label %843, !llvm.loop !27

866:                                              ; preds = %843, %783, %770
  %867 = add nuw nsw i64 %688, 1
  %868 = icmp eq i64 %867, %402
  br i1 %868, label %685, label %687, !llvm.loop !28

869:                                              ; preds = %685
  %870 = load i64, ptr %24, align 8
  %871 = getelementptr inbounds double, ptr %5, i64 %401
  br i1 %366, label %872, label %893

872:                                              ; preds = %869
  %873 = icmp sgt i64 %402, 0
  br label %874

874:                                              ; preds = %872, %879
  %875 = phi i64 [ 0, %872 ], [ %880, %879 ]
  br i1 %873, label %876, label %879

876:                                              ; preds = %874
  %877 = mul nsw i64 %875, %870
  %878 = getelementptr inbounds double, ptr %871, i64 %877
  br label %882

879:                                              ; preds = %882, %874
  %880 = add nuw nsw i64 %875, 1
  %881 = icmp eq i64 %880, %17
  br i1 %881, label %893, label %874, !llvm.loop !29

882:                                              ; preds = %876, %882
  %883 = phi i64 [ 0, %876 ], [ %891, %882 ]
  %884 = mul nuw nsw i64 %883, %17
  %885 = add nuw nsw i64 %884, %875
  %886 = shl nsw i64 %885, 6
  %887 = getelementptr inbounds i8, ptr %47, i64 %886
  %888 = load <8 x double>, ptr %887, align 8
  %889 = shl nsw i64 %883, 6
  %890 = getelementptr inbounds i8, ptr %878, i64 %889
  store <8 x double> %888, ptr %890, align 8
  %891 = add nuw nsw i64 %883, 1
  %892 = icmp eq i64 %891, %402
  br i1 %892, label %879, label %882, !llvm.loop !30

893:                                              ; preds = %879, %869, %685
  %894 = shl nsw i64 %402, 3
  %895 = add nsw i64 %401, %894
  %896 = icmp slt i64 %895, %11
  br i1 %896, label %394, label %370, !llvm.loop !31

897:                                              ; preds = %159, %370, %303, %8
  %898 = phi i1 [ true, %8 ], [ %327, %303 ], [ %393, %370 ], [ false, %159 ]
  %899 = zext i1 %898 to i64
  ret i64 %899
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
