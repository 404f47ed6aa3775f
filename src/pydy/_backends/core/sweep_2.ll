; sources cb0f84c4965216b1dd93409ced1e93ce4194ea2954af8231d02e36c64fac2be2
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define range(i64 0, 2) i64 @sweep_2(ptr noundef readonly %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, ptr noundef readonly %4, ptr noundef %5, ptr noundef writeonly %6, ptr noundef %7) #0 {
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
  %33 = shl nsw i64 %32, 4
  %34 = getelementptr inbounds i8, ptr %30, i64 %33
  %35 = getelementptr inbounds i8, ptr %0, i64 56
  %36 = load i64, ptr %35, align 8
  %37 = shl nsw i64 %36, 4
  %38 = getelementptr inbounds i8, ptr %34, i64 %37
  %39 = getelementptr inbounds i8, ptr %38, i64 16
  %40 = getelementptr inbounds i8, ptr %0, i64 72
  %41 = load i64, ptr %40, align 8
  %42 = shl i64 %13, 4
  %43 = mul i64 %42, %41
  %44 = getelementptr inbounds i8, ptr %39, i64 %43
  %45 = shl i64 %15, 4
  %46 = mul i64 %45, %41
  %47 = getelementptr inbounds i8, ptr %44, i64 %46
  %48 = icmp slt i64 %11, 1
  br i1 %48, label %639, label %49

49:                                               ; preds = %8
  %50 = icmp sgt i64 %32, 0
  br i1 %50, label %51, label %65

51:                                               ; preds = %49, %56
  %52 = phi i64 [ %57, %56 ], [ 0, %49 ]
  %53 = getelementptr inbounds double, ptr %4, i64 %52
  %54 = shl nsw i64 %52, 4
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
  %64 = icmp eq i64 %60, 0
  br i1 %64, label %59, label %56, !llvm.loop !6

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
  %76 = shl nsw i64 %73, 4
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
  %86 = icmp eq i64 %82, 0
  br i1 %86, label %81, label %78, !llvm.loop !6

87:                                               ; preds = %78, %68, %65
  %88 = icmp eq i64 %11, 1
  br i1 %88, label %89, label %147

89:                                               ; preds = %87
  %90 = icmp sgt i64 %13, 0
  %91 = icmp sgt i64 %15, 0
  %92 = select i1 %20, i1 %91, i1 false
  %93 = getelementptr inbounds i8, ptr %0, i64 104
  %94 = getelementptr inbounds i8, ptr %0, i64 120
  br label %104

95:                                               ; preds = %123
  %96 = load ptr, ptr %0, align 8
  %97 = tail call i32 %96(ptr noundef %38, ptr noundef nonnull %39, ptr noundef nonnull %44, ptr noundef %34, ptr noundef nonnull %47) #4
  %98 = icmp eq i32 %97, 0
  br i1 %98, label %102, label %99

99:                                               ; preds = %95
  %100 = trunc i32 %97 to i8
  %101 = and i8 %100, 1
  store i8 %101, ptr %6, align 1
  br label %102

102:                                              ; preds = %99, %95
  %103 = icmp sgt i64 %17, 0
  br i1 %103, label %137, label %639

104:                                              ; preds = %89, %123
  %105 = phi i64 [ 0, %89 ], [ %124, %123 ]
  %106 = load double, ptr %1, align 8
  %107 = getelementptr inbounds double, ptr %38, i64 %105
  store double %106, ptr %107, align 8
  br i1 %90, label %108, label %110

108:                                              ; preds = %104
  %109 = getelementptr inbounds double, ptr %39, i64 %105
  br label %113

110:                                              ; preds = %113, %104
  br i1 %92, label %111, label %123

111:                                              ; preds = %110
  %112 = getelementptr inbounds double, ptr %44, i64 %105
  br label %126

113:                                              ; preds = %108, %113
  %114 = phi i64 [ %121, %113 ], [ 0, %108 ]
  %115 = load i64, ptr %93, align 8
  %116 = mul nsw i64 %115, %114
  %117 = getelementptr double, ptr %2, i64 %116
  %118 = load double, ptr %117, align 8
  %119 = shl nsw i64 %114, 4
  %120 = getelementptr inbounds i8, ptr %109, i64 %119
  store double %118, ptr %120, align 8
  %121 = add nuw nsw i64 %114, 1
  %122 = icmp eq i64 %121, %13
  br i1 %122, label %110, label %113, !llvm.loop !7

123:                                              ; preds = %126, %110
  %124 = add nuw nsw i64 %105, 1
  %125 = icmp eq i64 %105, 0
  br i1 %125, label %104, label %95, !llvm.loop !9

126:                                              ; preds = %111, %126
  %127 = phi i64 [ %134, %126 ], [ 0, %111 ]
  %128 = load i64, ptr %94, align 8
  %129 = mul nsw i64 %128, %127
  %130 = getelementptr double, ptr %3, i64 %129
  %131 = load double, ptr %130, align 8
  %132 = shl nsw i64 %127, 4
  %133 = getelementptr inbounds i8, ptr %112, i64 %132
  store double %131, ptr %133, align 8
  %134 = add nuw nsw i64 %127, 1
  %135 = icmp slt i64 %134, %15
  %136 = select i1 %22, i1 %135, i1 false
  br i1 %136, label %126, label %123, !llvm.loop !10

137:                                              ; preds = %102, %137
  %138 = phi i64 [ %145, %137 ], [ 0, %102 ]
  %139 = shl nsw i64 %138, 4
  %140 = getelementptr inbounds i8, ptr %47, i64 %139
  %141 = load double, ptr %140, align 8
  %142 = load i64, ptr %24, align 8
  %143 = mul nsw i64 %142, %138
  %144 = getelementptr inbounds double, ptr %5, i64 %143
  store double %141, ptr %144, align 8
  %145 = add nuw nsw i64 %138, 1
  %146 = icmp eq i64 %145, %17
  br i1 %146, label %639, label %137, !llvm.loop !11

147:                                              ; preds = %87
  %148 = getelementptr inbounds i8, ptr %0, i64 96
  %149 = load i64, ptr %148, align 8
  %150 = icmp eq i64 %149, 1
  br i1 %150, label %151, label %158

151:                                              ; preds = %147
  %152 = load i64, ptr %23, align 8
  %153 = icmp eq i64 %152, 1
  %154 = select i1 %153, i1 %22, i1 false
  br i1 %154, label %155, label %158

155:                                              ; preds = %151
  %156 = load i64, ptr %18, align 8
  %157 = icmp eq i64 %156, 1
  br label %158

158:                                              ; preds = %151, %155, %147
  %159 = phi i1 [ %153, %151 ], [ false, %147 ], [ %157, %155 ]
  %160 = getelementptr inbounds i8, ptr %0, i64 80
  %161 = load i64, ptr %160, align 8
  %162 = icmp sgt i64 %11, %161
  br i1 %162, label %163, label %176

163:                                              ; preds = %158
  %164 = getelementptr inbounds i8, ptr %0, i64 104
  %165 = load i64, ptr %164, align 8
  %166 = add nsw i64 %15, %13
  %167 = add nsw i64 %166, %17
  %168 = shl nsw i64 %165, 3
  %169 = sub nsw i64 0, %168
  %170 = and i64 %168, %169
  %171 = tail call i64 @llvm.smin.i64(i64 %170, i64 4096)
  %172 = tail call i64 @llvm.smax.i64(i64 %171, i64 64)
  %173 = udiv i64 4096, %172
  %174 = shl nuw nsw i64 %173, 2
  %175 = icmp sge i64 %174, %167
  br label %176

176:                                              ; preds = %163, %158
  %177 = phi i1 [ true, %158 ], [ %175, %163 ]
  %178 = getelementptr inbounds i8, ptr %0, i64 16
  %179 = load ptr, ptr %178, align 8
  %180 = icmp ne ptr %179, null
  %181 = select i1 %180, i1 %159, i1 false
  %182 = select i1 %181, i1 %177, i1 false
  br i1 %182, label %183, label %282

183:                                              ; preds = %176
  %184 = select i1 %22, ptr %3, ptr %44
  %185 = load i64, ptr %10, align 8
  %186 = add nsw i64 %185, -2
  %187 = ptrtoint ptr %2 to i64
  %188 = shl i64 %187, 60
  %189 = ashr i64 %188, 63
  %190 = load i64, ptr %18, align 8
  %191 = icmp eq i64 %190, 0
  %192 = select i1 %191, i64 0, i64 2
  %193 = getelementptr inbounds i8, ptr %0, i64 104
  %194 = load i64, ptr %193, align 8
  store i64 %194, ptr %9, align 16
  %195 = getelementptr inbounds i8, ptr %9, i64 8
  br i1 %191, label %199, label %196

196:                                              ; preds = %183
  %197 = getelementptr inbounds i8, ptr %0, i64 120
  %198 = load i64, ptr %197, align 8
  br label %199

199:                                              ; preds = %196, %183
  %200 = phi i64 [ %198, %196 ], [ 2, %183 ]
  store i64 %200, ptr %195, align 8
  %201 = getelementptr inbounds i8, ptr %9, i64 16
  %202 = load i64, ptr %24, align 8
  store i64 %202, ptr %201, align 16
  %203 = getelementptr inbounds i8, ptr %9, i64 24
  store i64 1, ptr %203, align 8
  %204 = getelementptr inbounds i8, ptr %9, i64 32
  store i64 %192, ptr %204, align 16
  %205 = getelementptr i8, ptr %6, i64 -2
  %206 = icmp sgt i64 %185, 0
  br i1 %206, label %207, label %275

207:                                              ; preds = %199
  %208 = icmp sgt i64 %185, 2
  %209 = add nsw i64 %189, 2
  br label %210

210:                                              ; preds = %207, %250
  %211 = phi <2 x i64> [ zeroinitializer, %207 ], [ %251, %250 ]
  %212 = phi i64 [ 0, %207 ], [ %253, %250 ]
  %213 = call i64 @llvm.smin.i64(i64 %212, i64 %186)
  %214 = icmp eq i64 %212, 0
  br i1 %214, label %218, label %215

215:                                              ; preds = %210
  %216 = sub nsw i64 %185, %213
  %217 = sdiv i64 %216, 2
  store i64 %217, ptr %203, align 8
  br label %218

218:                                              ; preds = %215, %210
  %219 = load i64, ptr %18, align 8
  %220 = icmp eq i64 %219, 0
  %221 = select i1 %220, i64 0, i64 %213
  %222 = getelementptr inbounds double, ptr %184, i64 %221
  %223 = load ptr, ptr %178, align 8
  %224 = getelementptr inbounds double, ptr %1, i64 %213
  %225 = getelementptr inbounds double, ptr %2, i64 %213
  %226 = getelementptr inbounds double, ptr %5, i64 %213
  %227 = call i64 %223(ptr noundef %224, ptr noundef %225, ptr noundef %222, ptr noundef %34, ptr noundef %226, ptr noundef nonnull %9) #4
  %228 = ashr i64 %227, 32
  %229 = shl nsw i64 %228, 1
  %230 = add nsw i64 %229, %213
  %231 = shl i64 %227, 32
  %232 = ashr exact i64 %231, 32
  %233 = getelementptr i8, ptr %205, i64 %230
  %234 = icmp eq i64 %231, 0
  br i1 %234, label %243, label %235

235:                                              ; preds = %218, %235
  %236 = phi i64 [ %241, %235 ], [ 0, %218 ]
  %237 = lshr i64 %232, %236
  %238 = trunc i64 %237 to i8
  %239 = and i8 %238, 1
  %240 = getelementptr inbounds i8, ptr %233, i64 %236
  store i8 %239, ptr %240, align 1
  %241 = add nuw nsw i64 %236, 1
  %242 = icmp eq i64 %236, 0
  br i1 %242, label %235, label %243, !llvm.loop !12

243:                                              ; preds = %235, %218
  %244 = load i64, ptr %16, align 8
  %245 = getelementptr double, ptr %5, i64 %213
  %246 = icmp sgt i64 %244, 0
  br i1 %246, label %247, label %250

247:                                              ; preds = %243
  %248 = load i64, ptr %24, align 8
  %249 = icmp sgt i64 %228, 0
  br label %255

250:                                              ; preds = %271, %243
  %251 = phi <2 x i64> [ %211, %243 ], [ %272, %271 ]
  %252 = select i1 %214, i1 %208, i1 false
  %253 = select i1 %252, i64 %209, i64 %230
  %254 = icmp slt i64 %253, %185
  br i1 %254, label %210, label %275, !llvm.loop !13

255:                                              ; preds = %247, %271
  %256 = phi i64 [ 0, %247 ], [ %273, %271 ]
  %257 = phi <2 x i64> [ %211, %247 ], [ %272, %271 ]
  %258 = mul nsw i64 %248, %256
  %259 = getelementptr double, ptr %245, i64 %258
  br i1 %249, label %260, label %271

260:                                              ; preds = %255, %260
  %261 = phi <2 x i64> [ %268, %260 ], [ %257, %255 ]
  %262 = phi i64 [ %269, %260 ], [ 0, %255 ]
  %263 = shl nsw i64 %262, 4
  %264 = getelementptr inbounds i8, ptr %259, i64 %263
  %265 = load <2 x double>, ptr %264, align 8
  %266 = fsub <2 x double> %265, %265
  %267 = bitcast <2 x double> %266 to <2 x i64>
  %268 = or <2 x i64> %261, %267
  %269 = add nuw nsw i64 %262, 1
  %270 = icmp eq i64 %269, %228
  br i1 %270, label %271, label %260, !llvm.loop !14

271:                                              ; preds = %260, %255
  %272 = phi <2 x i64> [ %257, %255 ], [ %268, %260 ]
  %273 = add nuw nsw i64 %256, 1
  %274 = icmp eq i64 %273, %244
  br i1 %274, label %250, label %255, !llvm.loop !15

275:                                              ; preds = %250, %199
  %276 = phi <2 x i64> [ zeroinitializer, %199 ], [ %251, %250 ]
  %277 = extractelement <2 x i64> %276, i64 0
  %278 = icmp eq i64 %277, 0
  %279 = extractelement <2 x i64> %276, i64 1
  %280 = icmp eq i64 %279, 0
  %281 = select i1 %280, i1 %278, i1 false
  br label %639

282:                                              ; preds = %176
  %283 = getelementptr inbounds i8, ptr %0, i64 104
  %284 = load i64, ptr %283, align 8
  %285 = icmp ne i64 %284, 1
  %286 = select i1 %285, i1 true, i1 %26
  %287 = xor i1 %22, true
  %288 = select i1 %286, i1 true, i1 %287
  %289 = xor i1 %286, true
  br i1 %288, label %294, label %290

290:                                              ; preds = %282
  %291 = getelementptr inbounds i8, ptr %0, i64 120
  %292 = load i64, ptr %291, align 8
  %293 = icmp eq i64 %292, 1
  br label %294

294:                                              ; preds = %282, %290
  %295 = phi i1 [ %289, %282 ], [ %293, %290 ]
  br i1 %295, label %298, label %296

296:                                              ; preds = %294
  %297 = load i64, ptr %40, align 8
  br label %298

298:                                              ; preds = %296, %294
  %299 = phi i64 [ %297, %296 ], [ 1, %294 ]
  %300 = add nsw i64 %11, -2
  %301 = icmp sgt i64 %13, 0
  %302 = shl i64 %13, 4
  %303 = icmp sgt i64 %13, 1
  %304 = add nsw i64 %13, -2
  %305 = getelementptr inbounds i8, ptr %0, i64 120
  %306 = icmp sgt i64 %15, 0
  %307 = shl i64 %15, 4
  %308 = icmp sgt i64 %15, 1
  %309 = add nsw i64 %15, -2
  %310 = shl i64 %15, 4
  %311 = shl i64 %17, 4
  %312 = icmp slt i64 %13, 257
  %313 = icmp sgt i64 %13, 0
  %314 = icmp slt i64 %17, 257
  %315 = icmp sgt i64 %17, 0
  %316 = shl i64 %13, 4
  %317 = icmp sgt i64 %17, 0
  %318 = icmp sgt i64 %17, 1
  %319 = add nsw i64 %17, -2
  %320 = icmp sgt i64 %17, 0
  %321 = getelementptr i8, ptr %47, i64 16
  br label %328

322:                                              ; preds = %635
  %323 = extractelement <2 x i64> %488, i64 0
  %324 = icmp eq i64 %323, 0
  %325 = extractelement <2 x i64> %488, i64 1
  %326 = icmp eq i64 %325, 0
  %327 = select i1 %326, i1 %324, i1 false
  br label %639

328:                                              ; preds = %298, %635
  %329 = phi i64 [ 0, %298 ], [ %637, %635 ]
  %330 = phi <2 x i64> [ zeroinitializer, %298 ], [ %488, %635 ]
  %331 = sub nsw i64 %11, %329
  %332 = sdiv i64 %331, 2
  %333 = tail call i64 @llvm.smin.i64(i64 %299, i64 %332)
  %334 = icmp eq i64 %333, 0
  %335 = select i1 %334, i64 %300, i64 %329
  %336 = tail call i64 @llvm.umax.i64(i64 %333, i64 1)
  %337 = load i64, ptr %148, align 8
  %338 = mul nsw i64 %337, %335
  %339 = getelementptr inbounds double, ptr %2, i64 %338
  %340 = load i64, ptr %283, align 8
  %341 = icmp eq i64 %340, 1
  br i1 %341, label %345, label %342

342:                                              ; preds = %328
  br i1 %301, label %343, label %410

343:                                              ; preds = %342
  %344 = icmp sgt i64 %336, 0
  br label %391

345:                                              ; preds = %328
  %346 = icmp sgt i64 %336, 0
  br i1 %346, label %347, label %410

347:                                              ; preds = %345
  %348 = shl i64 %337, 1
  br label %349

349:                                              ; preds = %347, %388
  %350 = phi i64 [ 0, %347 ], [ %389, %388 ]
  %351 = mul i64 %348, %350
  %352 = getelementptr inbounds double, ptr %339, i64 %351
  %353 = mul i64 %302, %350
  %354 = getelementptr inbounds i8, ptr %39, i64 %353
  br i1 %303, label %355, label %357

355:                                              ; preds = %349
  %356 = getelementptr i8, ptr %354, i64 16
  br label %360

357:                                              ; preds = %360, %349
  %358 = phi i64 [ 0, %349 ], [ %373, %360 ]
  %359 = icmp slt i64 %358, %13
  br i1 %359, label %376, label %388

360:                                              ; preds = %355, %360
  %361 = phi i64 [ %373, %360 ], [ 0, %355 ]
  %362 = tail call i64 @llvm.smin.i64(i64 %361, i64 %304)
  %363 = getelementptr double, ptr %352, i64 %362
  %364 = load <2 x double>, ptr %363, align 8
  %365 = getelementptr double, ptr %363, i64 %337
  %366 = load <2 x double>, ptr %365, align 8
  %367 = shufflevector <2 x double> %364, <2 x double> %366, <2 x i32> <i32 1, i32 3>
  %368 = shufflevector <2 x double> %364, <2 x double> %366, <2 x i32> <i32 0, i32 2>
  %369 = shl nsw i64 %362, 4
  %370 = getelementptr inbounds i8, ptr %354, i64 %369
  store <2 x double> %368, ptr %370, align 8
  %371 = shl i64 %362, 4
  %372 = getelementptr i8, ptr %356, i64 %371
  store <2 x double> %367, ptr %372, align 8
  %373 = add nsw i64 %362, 2
  %374 = icmp slt i64 %373, %13
  %375 = select i1 %303, i1 %374, i1 false
  br i1 %375, label %360, label %357, !llvm.loop !16

376:                                              ; preds = %357, %376
  %377 = phi i64 [ %386, %376 ], [ %358, %357 ]
  %378 = getelementptr double, ptr %352, i64 %377
  %379 = load double, ptr %378, align 8
  %380 = insertelement <2 x double> poison, double %379, i64 0
  %381 = getelementptr double, ptr %378, i64 %337
  %382 = load double, ptr %381, align 8
  %383 = insertelement <2 x double> %380, double %382, i64 1
  %384 = shl nsw i64 %377, 4
  %385 = getelementptr inbounds i8, ptr %354, i64 %384
  store <2 x double> %383, ptr %385, align 8
  %386 = add nsw i64 %377, 1
  %387 = icmp eq i64 %386, %13
  br i1 %387, label %388, label %376, !llvm.loop !17

388:                                              ; preds = %376, %357
  %389 = add nuw nsw i64 %350, 1
  %390 = icmp eq i64 %389, %336
  br i1 %390, label %410, label %349, !llvm.loop !18

391:                                              ; preds = %343, %396
  %392 = phi i64 [ 0, %343 ], [ %397, %396 ]
  br i1 %344, label %393, label %396

393:                                              ; preds = %391
  %394 = mul nsw i64 %392, %340
  %395 = getelementptr inbounds double, ptr %339, i64 %394
  br label %399

396:                                              ; preds = %399, %391
  %397 = add nuw nsw i64 %392, 1
  %398 = icmp eq i64 %397, %13
  br i1 %398, label %410, label %391, !llvm.loop !19

399:                                              ; preds = %393, %399
  %400 = phi i64 [ 0, %393 ], [ %408, %399 ]
  %401 = shl nsw i64 %400, 4
  %402 = getelementptr inbounds i8, ptr %395, i64 %401
  %403 = load <2 x double>, ptr %402, align 8
  %404 = mul nuw nsw i64 %400, %13
  %405 = add nuw nsw i64 %404, %392
  %406 = shl nsw i64 %405, 4
  %407 = getelementptr inbounds i8, ptr %39, i64 %406
  store <2 x double> %403, ptr %407, align 16
  %408 = add nuw nsw i64 %400, 1
  %409 = icmp eq i64 %408, %336
  br i1 %409, label %396, label %399, !llvm.loop !20

410:                                              ; preds = %396, %388, %342, %345
  br i1 %22, label %411, label %485

411:                                              ; preds = %410
  %412 = load i64, ptr %18, align 8
  %413 = mul nsw i64 %412, %335
  %414 = getelementptr inbounds double, ptr %3, i64 %413
  %415 = load i64, ptr %305, align 8
  %416 = icmp eq i64 %415, 1
  br i1 %416, label %420, label %417

417:                                              ; preds = %411
  br i1 %306, label %418, label %485

418:                                              ; preds = %417
  %419 = icmp sgt i64 %336, 0
  br label %466

420:                                              ; preds = %411
  %421 = icmp sgt i64 %336, 0
  br i1 %421, label %422, label %485

422:                                              ; preds = %420
  %423 = shl i64 %412, 1
  br label %424

424:                                              ; preds = %422, %463
  %425 = phi i64 [ 0, %422 ], [ %464, %463 ]
  %426 = mul i64 %423, %425
  %427 = getelementptr inbounds double, ptr %414, i64 %426
  %428 = mul i64 %307, %425
  %429 = getelementptr inbounds i8, ptr %44, i64 %428
  br i1 %308, label %430, label %432

430:                                              ; preds = %424
  %431 = getelementptr i8, ptr %429, i64 16
  br label %435

432:                                              ; preds = %435, %424
  %433 = phi i64 [ 0, %424 ], [ %448, %435 ]
  %434 = icmp slt i64 %433, %15
  br i1 %434, label %451, label %463

435:                                              ; preds = %430, %435
  %436 = phi i64 [ %448, %435 ], [ 0, %430 ]
  %437 = tail call i64 @llvm.smin.i64(i64 %436, i64 %309)
  %438 = getelementptr double, ptr %427, i64 %437
  %439 = load <2 x double>, ptr %438, align 8
  %440 = getelementptr double, ptr %438, i64 %412
  %441 = load <2 x double>, ptr %440, align 8
  %442 = shufflevector <2 x double> %439, <2 x double> %441, <2 x i32> <i32 1, i32 3>
  %443 = shufflevector <2 x double> %439, <2 x double> %441, <2 x i32> <i32 0, i32 2>
  %444 = shl nsw i64 %437, 4
  %445 = getelementptr inbounds i8, ptr %429, i64 %444
  store <2 x double> %443, ptr %445, align 8
  %446 = shl i64 %437, 4
  %447 = getelementptr i8, ptr %431, i64 %446
  store <2 x double> %442, ptr %447, align 8
  %448 = add nsw i64 %437, 2
  %449 = icmp slt i64 %448, %15
  %450 = select i1 %308, i1 %449, i1 false
  br i1 %450, label %435, label %432, !llvm.loop !16

451:                                              ; preds = %432, %451
  %452 = phi i64 [ %461, %451 ], [ %433, %432 ]
  %453 = getelementptr double, ptr %427, i64 %452
  %454 = load double, ptr %453, align 8
  %455 = insertelement <2 x double> poison, double %454, i64 0
  %456 = getelementptr double, ptr %453, i64 %412
  %457 = load double, ptr %456, align 8
  %458 = insertelement <2 x double> %455, double %457, i64 1
  %459 = shl nsw i64 %452, 4
  %460 = getelementptr inbounds i8, ptr %429, i64 %459
  store <2 x double> %458, ptr %460, align 8
  %461 = add nsw i64 %452, 1
  %462 = icmp eq i64 %461, %15
  br i1 %462, label %463, label %451, !llvm.loop !17

463:                                              ; preds = %451, %432
  %464 = add nuw nsw i64 %425, 1
  %465 = icmp eq i64 %464, %336
  br i1 %465, label %485, label %424, !llvm.loop !18

466:                                              ; preds = %418, %471
  %467 = phi i64 [ 0, %418 ], [ %472, %471 ]
  br i1 %419, label %468, label %471

468:                                              ; preds = %466
  %469 = mul nsw i64 %467, %415
  %470 = getelementptr inbounds double, ptr %414, i64 %469
  br label %474

471:                                              ; preds = %474, %466
  %472 = add nuw nsw i64 %467, 1
  %473 = icmp eq i64 %472, %15
  br i1 %473, label %485, label %466, !llvm.loop !19

474:                                              ; preds = %468, %474
  %475 = phi i64 [ 0, %468 ], [ %483, %474 ]
  %476 = shl nsw i64 %475, 4
  %477 = getelementptr inbounds i8, ptr %470, i64 %476
  %478 = load <2 x double>, ptr %477, align 8
  %479 = mul nuw nsw i64 %475, %15
  %480 = add nuw nsw i64 %479, %467
  %481 = shl nsw i64 %480, 4
  %482 = getelementptr inbounds i8, ptr %44, i64 %481
  store <2 x double> %478, ptr %482, align 8
  %483 = add nuw nsw i64 %475, 1
  %484 = icmp eq i64 %483, %336
  br i1 %484, label %471, label %474, !llvm.loop !20

485:                                              ; preds = %471, %463, %417, %420, %410
  %486 = icmp sgt i64 %336, 0
  br i1 %486, label %489, label %487

487:                                              ; preds = %608, %485
  %488 = phi <2 x i64> [ %330, %485 ], [ %573, %608 ]
  br i1 %26, label %611, label %635

489:                                              ; preds = %485, %608
  %490 = phi i64 [ %609, %608 ], [ 0, %485 ]
  %491 = phi <2 x i64> [ %573, %608 ], [ %330, %485 ]
  %492 = shl nuw nsw i64 %490, 1
  %493 = add nsw i64 %492, %335
  %494 = mul i64 %310, %490
  %495 = select i1 %20, i64 %494, i64 0
  %496 = getelementptr inbounds i8, ptr %44, i64 %495
  %497 = mul i64 %311, %490
  %498 = select i1 %26, i64 %497, i64 0
  %499 = getelementptr inbounds i8, ptr %47, i64 %498
  %500 = add nsw i64 %493, 4
  %501 = icmp sgt i64 %500, %11
  %502 = select i1 %26, i1 true, i1 %501
  br i1 %502, label %543, label %503

503:                                              ; preds = %489
  %504 = add nsw i64 %493, 2
  %505 = load i64, ptr %283, align 8
  %506 = icmp eq i64 %505, 1
  %507 = select i1 %506, i1 %312, i1 false
  br i1 %507, label %508, label %525

508:                                              ; preds = %503, %516
  %509 = phi i64 [ %517, %516 ], [ 0, %503 ]
  br i1 %313, label %510, label %516

510:                                              ; preds = %508
  %511 = load i64, ptr %148, align 8
  %512 = mul nsw i64 %511, %504
  %513 = getelementptr inbounds double, ptr %2, i64 %512
  %514 = mul nuw nsw i64 %511, %509
  %515 = getelementptr inbounds double, ptr %513, i64 %514
  br label %520

516:                                              ; preds = %520, %508
  %517 = add nuw nsw i64 %509, 1
  %518 = icmp eq i64 %509, 0
  %519 = select i1 %312, i1 %518, i1 false
  br i1 %519, label %508, label %525, !llvm.loop !21

520:                                              ; preds = %510, %520
  %521 = phi i64 [ 0, %510 ], [ %523, %520 ]
  %522 = getelementptr inbounds double, ptr %515, i64 %521
  tail call void @llvm.prefetch.p0(ptr %522, i32 0, i32 3, i32 1)
  %523 = add nuw nsw i64 %521, 8
  %524 = icmp slt i64 %523, %13
  br i1 %524, label %520, label %516, !llvm.loop !22

525:                                              ; preds = %516, %503
  br i1 %314, label %526, label %543

526:                                              ; preds = %525, %534
  %527 = phi i64 [ %535, %534 ], [ 0, %525 ]
  br i1 %315, label %528, label %534

528:                                              ; preds = %526
  %529 = load i64, ptr %23, align 8
  %530 = mul nsw i64 %529, %504
  %531 = getelementptr inbounds double, ptr %5, i64 %530
  %532 = mul nuw nsw i64 %529, %527
  %533 = getelementptr inbounds double, ptr %531, i64 %532
  br label %538

534:                                              ; preds = %538, %526
  %535 = add nuw nsw i64 %527, 1
  %536 = icmp eq i64 %527, 0
  %537 = select i1 %314, i1 %536, i1 false
  br i1 %537, label %526, label %543, !llvm.loop !23

538:                                              ; preds = %528, %538
  %539 = phi i64 [ 0, %528 ], [ %541, %538 ]
  %540 = getelementptr inbounds double, ptr %533, i64 %539
  tail call void @llvm.prefetch.p0(ptr %540, i32 1, i32 3, i32 1)
  %541 = add nuw nsw i64 %539, 8
  %542 = icmp slt i64 %541, %17
  br i1 %542, label %538, label %534, !llvm.loop !24

543:                                              ; preds = %534, %525, %489
  %544 = load ptr, ptr %0, align 8
  %545 = getelementptr inbounds double, ptr %1, i64 %493
  %546 = mul i64 %316, %490
  %547 = getelementptr inbounds i8, ptr %39, i64 %546
  %548 = tail call i32 %544(ptr noundef %545, ptr noundef nonnull %547, ptr noundef nonnull %496, ptr noundef %34, ptr noundef nonnull %499) #4
  %549 = sext i32 %548 to i64
  %550 = getelementptr inbounds i8, ptr %6, i64 %493
  %551 = icmp eq i32 %548, 0
  br i1 %551, label %560, label %552

552:                                              ; preds = %543, %552
  %553 = phi i64 [ %558, %552 ], [ 0, %543 ]
  %554 = lshr i64 %549, %553
  %555 = trunc i64 %554 to i8
  %556 = and i8 %555, 1
  %557 = getelementptr inbounds i8, ptr %550, i64 %553
  store i8 %556, ptr %557, align 1
  %558 = add nuw nsw i64 %553, 1
  %559 = icmp eq i64 %553, 0
  br i1 %559, label %552, label %560, !llvm.loop !12

560:                                              ; preds = %552, %543
  br i1 %317, label %561, label %572

561:                                              ; preds = %560, %561
  %562 = phi <2 x i64> [ %569, %561 ], [ %491, %560 ]
  %563 = phi i64 [ %570, %561 ], [ 0, %560 ]
  %564 = shl nsw i64 %563, 4
  %565 = getelementptr inbounds i8, ptr %499, i64 %564
  %566 = load <2 x double>, ptr %565, align 8
  %567 = fsub <2 x double> %566, %566
  %568 = bitcast <2 x double> %567 to <2 x i64>
  %569 = or <2 x i64> %562, %568
  %570 = add nuw nsw i64 %563, 1
  %571 = icmp eq i64 %570, %17
  br i1 %571, label %572, label %561, !llvm.loop !14

572:                                              ; preds = %561, %560
  %573 = phi <2 x i64> [ %491, %560 ], [ %569, %561 ]
  br i1 %26, label %608, label %574

574:                                              ; preds = %572
  %575 = load i64, ptr %23, align 8
  %576 = mul nsw i64 %575, %493
  %577 = getelementptr inbounds double, ptr %5, i64 %576
  br i1 %318, label %581, label %578

578:                                              ; preds = %581, %574
  %579 = phi i64 [ 0, %574 ], [ %594, %581 ]
  %580 = icmp slt i64 %579, %17
  br i1 %580, label %597, label %608

581:                                              ; preds = %574, %581
  %582 = phi i64 [ %594, %581 ], [ 0, %574 ]
  %583 = tail call i64 @llvm.smin.i64(i64 %582, i64 %319)
  %584 = getelementptr double, ptr %577, i64 %583
  %585 = shl nsw i64 %583, 4
  %586 = getelementptr inbounds i8, ptr %47, i64 %585
  %587 = load <2 x double>, ptr %586, align 8
  %588 = shl i64 %583, 4
  %589 = getelementptr i8, ptr %321, i64 %588
  %590 = load <2 x double>, ptr %589, align 8
  %591 = shufflevector <2 x double> %587, <2 x double> %590, <2 x i32> <i32 1, i32 3>
  %592 = shufflevector <2 x double> %587, <2 x double> %590, <2 x i32> <i32 0, i32 2>
  store <2 x double> %592, ptr %584, align 8
  %593 = getelementptr double, ptr %584, i64 %575
  store <2 x double> %591, ptr %593, align 8
  %594 = add nsw i64 %583, 2
  %595 = icmp slt i64 %594, %17
  %596 = select i1 %318, i1 %595, i1 false
  br i1 %596, label %581, label %578, !llvm.loop !25

597:                                              ; preds = %578, %597
  %598 = phi i64 [ %606, %597 ], [ %579, %578 ]
  %599 = getelementptr double, ptr %577, i64 %598
  %600 = shl nsw i64 %598, 4
  %601 = getelementptr inbounds i8, ptr %47, i64 %600
  %602 = load <2 x double>, ptr %601, align 8
  %603 = extractelement <2 x double> %602, i64 0
  store double %603, ptr %599, align 8
  %604 = extractelement <2 x double> %602, i64 1
  %605 = getelementptr double, ptr %599, i64 %575
  store double %604, ptr %605, align 8
  %606 = add nsw i64 %598, 1
  %607 = icmp eq i64 %606, %17
  br i1 %607, label %608, label %597, !llvm.loop !26

608:                                              ; preds = %597, %578, %572
  %609 = add nuw nsw i64 %490, 1
  %610 = icmp eq i64 %609, %336
  br i1 %610, label %487, label %489, !llvm.loop !27

611:                                              ; preds = %487
  %612 = load i64, ptr %24, align 8
  %613 = getelementptr inbounds double, ptr %5, i64 %335
  br i1 %320, label %614, label %635

614:                                              ; preds = %611
  %615 = icmp sgt i64 %336, 0
  br label %616

616:                                              ; preds = %614, %621
  %617 = phi i64 [ 0, %614 ], [ %622, %621 ]
  br i1 %615, label %618, label %621

618:                                              ; preds = %616
  %619 = mul nsw i64 %617, %612
  %620 = getelementptr inbounds double, ptr %613, i64 %619
  br label %624

621:                                              ; preds = %624, %616
  %622 = add nuw nsw i64 %617, 1
  %623 = icmp eq i64 %622, %17
  br i1 %623, label %635, label %616, !llvm.loop !28

624:                                              ; preds = %618, %624
  %625 = phi i64 [ 0, %618 ], [ %633, %624 ]
  %626 = mul nuw nsw i64 %625, %17
  %627 = add nuw nsw i64 %626, %617
  %628 = shl nsw i64 %627, 4
  %629 = getelementptr inbounds i8, ptr %47, i64 %628
  %630 = load <2 x double>, ptr %629, align 8
  %631 = shl nsw i64 %625, 4
  %632 = getelementptr inbounds i8, ptr %620, i64 %631
  store <2 x double> %630, ptr %632, align 8
  %633 = add nuw nsw i64 %625, 1
  %634 = icmp eq i64 %633, %336
  br i1 %634, label %621, label %624, !llvm.loop !29

635:                                              ; preds = %621, %611, %487
  %636 = shl nsw i64 %336, 1
  %637 = add nsw i64 %335, %636
  %638 = icmp slt i64 %637, %11
  br i1 %638, label %328, label %322, !llvm.loop !30

639:                                              ; preds = %137, %322, %102, %275, %8
  %640 = phi i1 [ true, %8 ], [ %281, %275 ], [ false, %102 ], [ %327, %322 ], [ false, %137 ]
  %641 = zext i1 %640 to i64
  ret i64 %641
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
!7 = distinct !{!7, !4, !5, !8}
!8 = !{!"llvm.loop.vectorize.width", i32 1}
!9 = distinct !{!9, !4, !5}
!10 = distinct !{!10, !4, !5, !8}
!11 = distinct !{!11, !4, !5, !8}
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
