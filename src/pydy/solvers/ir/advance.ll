; sources beea8178ef82651d8ea62ded22f7084358ab19211078e16dd7ba9f26a140e8dc
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define i64 @advance(ptr noundef %0, ptr noundef %1, i64 noundef %2) #0 {
  %4 = alloca [1 x double], align 8
  %5 = alloca [1 x double], align 8
  %6 = alloca [1 x double], align 8
  %7 = icmp eq i64 %2, 1
  br i1 %7, label %8, label %72

8:                                                ; preds = %3
  %9 = getelementptr inbounds i8, ptr %0, i64 144
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 8
  %12 = load i64, ptr %11, align 8
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %14, label %16

14:                                               ; preds = %8
  %15 = getelementptr inbounds i8, ptr %0, i64 312
  br label %23

16:                                               ; preds = %23, %8
  %17 = getelementptr inbounds i8, ptr %0, i64 584
  %18 = load i64, ptr %17, align 8
  %19 = icmp sgt i64 %18, 0
  br i1 %19, label %20, label %34

20:                                               ; preds = %16
  %21 = getelementptr inbounds i8, ptr %0, i64 576
  %22 = getelementptr inbounds i8, ptr %0, i64 1224
  br label %41

23:                                               ; preds = %14, %23
  %24 = phi i64 [ 0, %14 ], [ %29, %23 ]
  %25 = getelementptr inbounds double, ptr %1, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = load ptr, ptr %15, align 8
  %28 = getelementptr inbounds double, ptr %27, i64 %24
  store double %26, ptr %28, align 8
  %29 = add nuw nsw i64 %24, 1
  %30 = load ptr, ptr %9, align 8
  %31 = getelementptr inbounds i8, ptr %30, i64 8
  %32 = load i64, ptr %31, align 8
  %33 = icmp slt i64 %29, %32
  br i1 %33, label %23, label %16, !llvm.loop !3

34:                                               ; preds = %41, %16
  %35 = getelementptr inbounds i8, ptr %0, i64 608
  %36 = load i64, ptr %35, align 8
  %37 = icmp sgt i64 %36, 0
  br i1 %37, label %38, label %51

38:                                               ; preds = %34
  %39 = getelementptr inbounds i8, ptr %0, i64 600
  %40 = getelementptr inbounds i8, ptr %0, i64 1248
  br label %57

41:                                               ; preds = %20, %41
  %42 = phi i64 [ 0, %20 ], [ %48, %41 ]
  %43 = load ptr, ptr %22, align 8
  %44 = getelementptr inbounds double, ptr %43, i64 %42
  %45 = load double, ptr %44, align 8
  %46 = load ptr, ptr %21, align 8
  %47 = getelementptr inbounds double, ptr %46, i64 %42
  store double %45, ptr %47, align 8
  %48 = add nuw nsw i64 %42, 1
  %49 = load i64, ptr %17, align 8
  %50 = icmp slt i64 %48, %49
  br i1 %50, label %41, label %34, !llvm.loop !6

51:                                               ; preds = %57, %34
  %52 = getelementptr inbounds i8, ptr %0, i64 720
  %53 = load ptr, ptr %52, align 8
  %54 = getelementptr inbounds i8, ptr %53, i64 8
  %55 = load i64, ptr %54, align 8
  %56 = icmp sgt i64 %55, 0
  br i1 %56, label %67, label %72

57:                                               ; preds = %38, %57
  %58 = phi i64 [ 0, %38 ], [ %64, %57 ]
  %59 = load ptr, ptr %40, align 8
  %60 = getelementptr inbounds i64, ptr %59, i64 %58
  %61 = load i64, ptr %60, align 8
  %62 = load ptr, ptr %39, align 8
  %63 = getelementptr inbounds i64, ptr %62, i64 %58
  store i64 %61, ptr %63, align 8
  %64 = add nuw nsw i64 %58, 1
  %65 = load i64, ptr %35, align 8
  %66 = icmp slt i64 %64, %65
  br i1 %66, label %57, label %51, !llvm.loop !7

67:                                               ; preds = %51
  %68 = getelementptr inbounds i8, ptr %0, i64 936
  %69 = load ptr, ptr %68, align 8
  %70 = mul i64 %55, 88
  %71 = getelementptr inbounds i8, ptr %69, i64 %70
  store double 0x7FF8000000000000, ptr %71, align 8
  br label %72

72:                                               ; preds = %67, %51, %3
  %73 = getelementptr inbounds i8, ptr %0, i64 144
  %74 = getelementptr inbounds i8, ptr %0, i64 312
  %75 = getelementptr inbounds i8, ptr %0, i64 576
  %76 = getelementptr inbounds i8, ptr %0, i64 336
  %77 = getelementptr inbounds i8, ptr %0, i64 600
  %78 = getelementptr inbounds i8, ptr %0, i64 624
  %79 = getelementptr inbounds i8, ptr %0, i64 120
  %80 = getelementptr inbounds i8, ptr %0, i64 320
  %81 = getelementptr inbounds i8, ptr %0, i64 648
  %82 = getelementptr inbounds i8, ptr %0, i64 720
  %83 = getelementptr inbounds i8, ptr %0, i64 632
  %84 = getelementptr inbounds i8, ptr %0, i64 480
  %85 = getelementptr inbounds i8, ptr %0, i64 168
  %86 = getelementptr inbounds i8, ptr %0, i64 248
  %87 = getelementptr inbounds i8, ptr %0, i64 192
  %88 = getelementptr inbounds i8, ptr %0, i64 216
  %89 = getelementptr inbounds i8, ptr %0, i64 480
  %90 = getelementptr inbounds i8, ptr %0, i64 360
  %91 = getelementptr inbounds i8, ptr %0, i64 360
  %92 = getelementptr inbounds i8, ptr %0, i64 320
  %93 = getelementptr inbounds i8, ptr %0, i64 1272
  %94 = getelementptr inbounds i8, ptr %0, i64 384
  %95 = getelementptr inbounds i8, ptr %0, i64 360
  %96 = getelementptr inbounds i8, ptr %0, i64 24
  %97 = getelementptr inbounds i8, ptr %0, i64 480
  %98 = getelementptr inbounds i8, ptr %0, i64 48
  %99 = getelementptr inbounds i8, ptr %0, i64 72
  %100 = getelementptr inbounds i8, ptr %0, i64 320
  %101 = getelementptr inbounds i8, ptr %0, i64 96
  %102 = getelementptr inbounds i8, ptr %0, i64 168
  %103 = getelementptr inbounds i8, ptr %0, i64 248
  %104 = getelementptr inbounds i8, ptr %0, i64 192
  %105 = getelementptr inbounds i8, ptr %0, i64 216
  %106 = getelementptr inbounds i8, ptr %0, i64 336
  %107 = getelementptr inbounds i8, ptr %0, i64 24
  %108 = getelementptr inbounds i8, ptr %0, i64 480
  %109 = getelementptr inbounds i8, ptr %0, i64 48
  %110 = getelementptr inbounds i8, ptr %0, i64 72
  %111 = getelementptr inbounds i8, ptr %0, i64 168
  %112 = getelementptr inbounds i8, ptr %0, i64 248
  %113 = getelementptr inbounds i8, ptr %0, i64 192
  %114 = getelementptr inbounds i8, ptr %0, i64 216
  %115 = getelementptr inbounds i8, ptr %0, i64 456
  %116 = getelementptr inbounds i8, ptr %0, i64 320
  %117 = getelementptr inbounds i8, ptr %0, i64 432
  %118 = getelementptr inbounds i8, ptr %0, i64 24
  %119 = getelementptr inbounds i8, ptr %0, i64 480
  %120 = getelementptr inbounds i8, ptr %0, i64 48
  %121 = getelementptr inbounds i8, ptr %0, i64 72
  %122 = getelementptr inbounds i8, ptr %0, i64 336
  %123 = getelementptr inbounds i8, ptr %0, i64 552
  %124 = getelementptr inbounds i8, ptr %0, i64 528
  %125 = getelementptr inbounds i8, ptr %0, i64 336
  %126 = getelementptr inbounds i8, ptr %0, i64 168
  %127 = getelementptr inbounds i8, ptr %0, i64 248
  %128 = getelementptr inbounds i8, ptr %0, i64 192
  %129 = getelementptr inbounds i8, ptr %0, i64 216
  %130 = getelementptr inbounds i8, ptr %0, i64 1296
  %131 = getelementptr inbounds i8, ptr %0, i64 1312
  %132 = getelementptr inbounds i8, ptr %0, i64 840
  %133 = getelementptr inbounds i8, ptr %0, i64 168
  %134 = getelementptr inbounds i8, ptr %0, i64 936
  %135 = getelementptr inbounds i8, ptr %0, i64 864
  %136 = getelementptr inbounds i8, ptr %0, i64 816
  %137 = getelementptr inbounds i8, ptr %0, i64 888
  %138 = getelementptr inbounds i8, ptr %0, i64 320
  %139 = getelementptr inbounds i8, ptr %0, i64 480
  %140 = getelementptr inbounds i8, ptr %0, i64 504
  %141 = getelementptr inbounds i8, ptr %0, i64 360
  %142 = getelementptr inbounds i8, ptr %0, i64 24
  %143 = getelementptr inbounds i8, ptr %0, i64 48
  %144 = getelementptr inbounds i8, ptr %0, i64 72
  %145 = getelementptr inbounds i8, ptr %0, i64 96
  %146 = getelementptr inbounds i8, ptr %0, i64 168
  %147 = getelementptr inbounds i8, ptr %0, i64 248
  %148 = getelementptr inbounds i8, ptr %0, i64 192
  %149 = getelementptr inbounds i8, ptr %0, i64 216
  %150 = getelementptr inbounds i8, ptr %0, i64 336
  %151 = getelementptr inbounds i8, ptr %0, i64 432
  %152 = getelementptr inbounds i8, ptr %0, i64 24
  %153 = getelementptr inbounds i8, ptr %0, i64 48
  %154 = getelementptr inbounds i8, ptr %0, i64 72
  %155 = getelementptr inbounds i8, ptr %0, i64 408
  %156 = getelementptr inbounds i8, ptr %0, i64 360
  %157 = getelementptr inbounds i8, ptr %0, i64 408
  %158 = getelementptr inbounds i8, ptr %0, i64 720
  br label %159

159:                                              ; preds = %1640, %72
  %160 = load ptr, ptr %75, align 8
  %161 = load ptr, ptr %76, align 8
  %162 = load ptr, ptr %77, align 8
  %163 = getelementptr inbounds i8, ptr %162, i64 56
  %164 = load i64, ptr %163, align 8
  %165 = icmp eq i64 %164, 0
  br i1 %165, label %1625, label %166

166:                                              ; preds = %159
  %167 = load ptr, ptr %78, align 8
  %168 = load ptr, ptr %79, align 8
  %169 = load ptr, ptr %0, align 8
  %170 = load i64, ptr %80, align 8
  %171 = load ptr, ptr %81, align 8
  %172 = load i64, ptr %171, align 8
  %173 = icmp ne i64 %172, 1
  %174 = getelementptr inbounds i8, ptr %169, i64 8
  %175 = load i64, ptr %174, align 8
  %176 = icmp slt i64 %175, 1
  %177 = getelementptr inbounds i8, ptr %169, i64 32
  %178 = load i64, ptr %177, align 8
  %179 = icmp eq i64 %178, 1
  %180 = load ptr, ptr %82, align 8
  %181 = getelementptr inbounds i8, ptr %180, i64 8
  %182 = load i64, ptr %181, align 8
  %183 = icmp sgt i64 %182, 0
  %184 = load i64, ptr %83, align 8
  %185 = getelementptr double, ptr %167, i64 %184
  %186 = getelementptr i8, ptr %185, i64 -8
  %187 = load double, ptr %186, align 8
  %188 = load ptr, ptr %84, align 8
  %189 = load i64, ptr %169, align 8
  %190 = mul nsw i64 %189, %170
  %191 = getelementptr inbounds double, ptr %188, i64 %190
  %192 = load double, ptr %160, align 8
  %193 = getelementptr inbounds i8, ptr %160, i64 8
  %194 = load double, ptr %193, align 8
  %195 = load i64, ptr %162, align 8
  %196 = icmp eq i64 %195, 0
  br i1 %196, label %197, label %411

197:                                              ; preds = %166
  %198 = getelementptr inbounds i8, ptr %162, i64 24
  %199 = load i64, ptr %198, align 8
  %200 = add nsw i64 %199, 1
  store i64 %200, ptr %198, align 8
  %201 = load ptr, ptr %74, align 8
  %202 = load ptr, ptr %84, align 8
  %203 = load ptr, ptr %85, align 8
  store double %192, ptr %203, align 8
  %204 = load i64, ptr %86, align 8
  %205 = icmp sgt i64 %204, 0
  br i1 %205, label %206, label %207

206:                                              ; preds = %197
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %207

207:                                              ; preds = %197, %206
  %208 = load ptr, ptr %73, align 8
  %209 = load i64, ptr %208, align 8
  %210 = load ptr, ptr %85, align 8
  %211 = load ptr, ptr %87, align 8
  %212 = load ptr, ptr %88, align 8
  %213 = inttoptr i64 %209 to ptr
  %214 = tail call i32 %213(ptr noundef %210, ptr noundef %201, ptr noundef %211, ptr noundef %212, ptr noundef %202) #9
  %215 = icmp eq i32 %214, 0
  br i1 %215, label %220, label %216

216:                                              ; preds = %207
  %217 = getelementptr inbounds i8, ptr %162, i64 72
  store i64 3, ptr %217, align 8
  %218 = icmp slt i32 %214, 0
  %219 = select i1 %218, i64 -4, i64 2
  br label %1625

220:                                              ; preds = %207
  store i64 1, ptr %162, align 8
  %221 = getelementptr inbounds i8, ptr %160, i64 24
  store double 1.000000e-04, ptr %221, align 8
  %222 = getelementptr inbounds i8, ptr %168, i64 40
  %223 = load double, ptr %222, align 8
  %224 = getelementptr inbounds i8, ptr %160, i64 40
  store double %223, ptr %224, align 8
  %225 = load ptr, ptr %74, align 8
  %226 = load ptr, ptr %73, align 8
  %227 = getelementptr inbounds i8, ptr %226, i64 8
  %228 = load i64, ptr %227, align 8
  %229 = load i64, ptr %83, align 8
  %230 = load ptr, ptr %78, align 8
  %231 = load ptr, ptr %77, align 8
  %232 = getelementptr inbounds i8, ptr %231, i64 48
  %233 = load i64, ptr %232, align 8
  %234 = icmp slt i64 %233, %229
  br i1 %234, label %235, label %258

235:                                              ; preds = %220
  %236 = icmp sgt i64 %228, 0
  br label %237

237:                                              ; preds = %235, %248
  %238 = phi i64 [ %233, %235 ], [ %249, %248 ]
  %239 = getelementptr inbounds double, ptr %230, i64 %238
  %240 = load double, ptr %239, align 8
  %241 = load ptr, ptr %75, align 8
  %242 = load double, ptr %241, align 8
  %243 = fcmp ugt double %240, %242
  br i1 %243, label %258, label %244

244:                                              ; preds = %237
  br i1 %236, label %245, label %248

245:                                              ; preds = %244
  %246 = mul nsw i64 %238, %228
  %247 = getelementptr double, ptr %1, i64 %246
  br label %251

248:                                              ; preds = %251, %244
  %249 = add i64 %238, 1
  %250 = icmp eq i64 %249, %229
  br i1 %250, label %258, label %237, !llvm.loop !8

251:                                              ; preds = %245, %251
  %252 = phi i64 [ 0, %245 ], [ %256, %251 ]
  %253 = getelementptr inbounds double, ptr %225, i64 %252
  %254 = load double, ptr %253, align 8
  %255 = getelementptr double, ptr %247, i64 %252
  store double %254, ptr %255, align 8
  %256 = add nuw nsw i64 %252, 1
  %257 = icmp eq i64 %256, %228
  br i1 %257, label %248, label %251, !llvm.loop !9

258:                                              ; preds = %237, %248, %220
  %259 = phi i64 [ %233, %220 ], [ %238, %237 ], [ %229, %248 ]
  %260 = load ptr, ptr %77, align 8
  %261 = getelementptr inbounds i8, ptr %260, i64 48
  store i64 %259, ptr %261, align 8
  %262 = icmp eq i64 %259, %229
  br i1 %262, label %1625, label %263

263:                                              ; preds = %258
  %264 = fcmp oeq double %194, 0.000000e+00
  br i1 %264, label %265, label %411

265:                                              ; preds = %263
  %266 = load ptr, ptr %73, align 8
  %267 = getelementptr inbounds i8, ptr %266, i64 24
  %268 = load i64, ptr %267, align 8
  %269 = load ptr, ptr %75, align 8
  %270 = getelementptr inbounds i8, ptr %269, i64 16
  %271 = load double, ptr %270, align 8
  %272 = load ptr, ptr %74, align 8
  call fastcc void @norm_to(ptr noundef nonnull %4, ptr noundef %272, ptr noundef %272, ptr noundef nonnull %74, i64 noundef %268) #8
  %273 = load double, ptr %4, align 8
  %274 = load ptr, ptr %89, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %274, ptr noundef %272, ptr noundef nonnull %74, i64 noundef %268) #8
  %275 = load double, ptr %5, align 8
  %276 = fcmp uge double %273, 1.000000e-05
  %277 = fcmp uge double %275, 1.000000e-05
  %278 = and i1 %276, %277
  %279 = fmul double %273, 1.000000e-02
  %280 = fdiv double %279, %275
  %281 = select i1 %278, double %280, double 0x3EB0C6F7A0B5ED8D
  %282 = fcmp olt double %271, %281
  %283 = select i1 %282, double %271, double %281
  %284 = load ptr, ptr %73, align 8
  %285 = getelementptr inbounds i8, ptr %284, i64 8
  %286 = load i64, ptr %285, align 8
  %287 = icmp sgt i64 %286, 0
  br i1 %287, label %311, label %288

288:                                              ; preds = %311, %265
  %289 = load ptr, ptr %77, align 8
  %290 = getelementptr inbounds i8, ptr %289, i64 24
  %291 = load i64, ptr %290, align 8
  %292 = add nsw i64 %291, 1
  store i64 %292, ptr %290, align 8
  %293 = fadd double %192, %283
  %294 = load ptr, ptr %91, align 8
  %295 = load ptr, ptr %84, align 8
  %296 = load i64, ptr %80, align 8
  %297 = getelementptr inbounds double, ptr %295, i64 %296
  %298 = load ptr, ptr %85, align 8
  store double %293, ptr %298, align 8
  %299 = load i64, ptr %86, align 8
  %300 = icmp sgt i64 %299, 0
  br i1 %300, label %301, label %302

301:                                              ; preds = %288
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %302

302:                                              ; preds = %288, %301
  %303 = load ptr, ptr %73, align 8
  %304 = load i64, ptr %303, align 8
  %305 = load ptr, ptr %85, align 8
  %306 = load ptr, ptr %87, align 8
  %307 = load ptr, ptr %88, align 8
  %308 = inttoptr i64 %304 to ptr
  %309 = tail call i32 %308(ptr noundef %305, ptr noundef %294, ptr noundef %306, ptr noundef %307, ptr noundef %297) #9
  %310 = icmp eq i32 %309, 0
  br i1 %310, label %330, label %328

311:                                              ; preds = %265, %311
  %312 = phi i64 [ %323, %311 ], [ 0, %265 ]
  %313 = load ptr, ptr %74, align 8
  %314 = getelementptr inbounds double, ptr %313, i64 %312
  %315 = load double, ptr %314, align 8
  %316 = load ptr, ptr %84, align 8
  %317 = getelementptr inbounds double, ptr %316, i64 %312
  %318 = load double, ptr %317, align 8
  %319 = fmul double %283, %318
  %320 = fadd double %315, %319
  %321 = load ptr, ptr %90, align 8
  %322 = getelementptr inbounds double, ptr %321, i64 %312
  store double %320, ptr %322, align 8
  %323 = add nuw nsw i64 %312, 1
  %324 = load ptr, ptr %73, align 8
  %325 = getelementptr inbounds i8, ptr %324, i64 8
  %326 = load i64, ptr %325, align 8
  %327 = icmp slt i64 %323, %326
  br i1 %327, label %311, label %288, !llvm.loop !10

328:                                              ; preds = %302
  %329 = fmul double %283, 1.000000e-03
  br label %406

330:                                              ; preds = %302
  %331 = load ptr, ptr %79, align 8
  %332 = load double, ptr %331, align 8
  %333 = load ptr, ptr %89, align 8
  %334 = load i64, ptr %92, align 8
  %335 = getelementptr inbounds double, ptr %333, i64 %334
  %336 = icmp sgt i64 %268, 0
  br i1 %336, label %337, label %346

337:                                              ; preds = %330, %337
  %338 = phi i64 [ %344, %337 ], [ 0, %330 ]
  %339 = getelementptr inbounds double, ptr %335, i64 %338
  %340 = load double, ptr %339, align 8
  %341 = getelementptr inbounds double, ptr %333, i64 %338
  %342 = load double, ptr %341, align 8
  %343 = fsub double %340, %342
  store double %343, ptr %339, align 8
  %344 = add nuw nsw i64 %338, 1
  %345 = icmp eq i64 %344, %268
  br i1 %345, label %346, label %337, !llvm.loop !11

346:                                              ; preds = %337, %330
  %347 = load ptr, ptr %74, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %335, ptr noundef %347, ptr noundef nonnull %74, i64 noundef %268) #8
  %348 = load double, ptr %6, align 8
  %349 = fdiv double %348, %283
  %350 = fcmp ogt double %275, %349
  %351 = select i1 %350, double %275, double %349
  %352 = fcmp ule double %351, 1.000000e-15
  %353 = fdiv double 1.000000e-02, %351
  %354 = select i1 %352, double 1.000000e+13, double %353
  %355 = bitcast double %354 to i64
  %356 = add nsw i64 %355, -4604544271217802189
  %357 = ashr i64 %356, 52
  %358 = and i64 %356, -4503599627370496
  %359 = sub nsw i64 %355, %358
  %360 = bitcast i64 %359 to double
  %361 = fadd double %360, -1.000000e+00
  %362 = fadd double %360, 1.000000e+00
  %363 = fdiv double %361, %362
  %364 = fmul double %363, %363
  %365 = tail call double @llvm.fma.f64(double %364, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %366 = tail call double @llvm.fma.f64(double %365, double %364, double 0x3FE2776C50EF9BFE)
  %367 = tail call double @llvm.fma.f64(double %366, double %364, double 0x3FEEC709DC3A03FD)
  %368 = tail call double @llvm.fma.f64(double %367, double %364, double 0x40071547652B82FE)
  %369 = trunc nsw i64 %357 to i32
  %370 = sitofp i32 %369 to double
  %371 = fmul double %363, %368
  %372 = fadd double %371, %370
  %373 = fmul double %332, %372
  %374 = fcmp ogt double %373, -1.000000e+03
  %375 = select i1 %374, double %373, double -1.000000e+03
  %376 = fcmp olt double %375, 1.000000e+03
  %377 = select i1 %376, double %375, double 1.000000e+03
  %378 = tail call double @llvm.rint.f64(double %377)
  %379 = fsub double %377, %378
  %380 = tail call double @llvm.fma.f64(double %379, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %381 = tail call double @llvm.fma.f64(double %380, double %379, double 0x3F55D87FE78A6730)
  %382 = tail call double @llvm.fma.f64(double %381, double %379, double 0x3F83B2AB6FBA4E77)
  %383 = tail call double @llvm.fma.f64(double %382, double %379, double 0x3FAC6B08D704A0BF)
  %384 = tail call double @llvm.fma.f64(double %383, double %379, double 0x3FCEBFBDFF82C58E)
  %385 = tail call double @llvm.fma.f64(double %384, double %379, double 0x3FE62E42FEFA39EF)
  %386 = tail call double @llvm.fma.f64(double %385, double %379, double 1.000000e+00)
  %387 = bitcast double %386 to i64
  %388 = fptosi double %378 to i32
  %389 = sext i32 %388 to i64
  %390 = shl nsw i64 %389, 52
  %391 = add nsw i64 %390, %387
  %392 = bitcast i64 %391 to double
  %393 = fmul double %283, 1.000000e-03
  %394 = fcmp olt double %393, 0x3EB0C6F7A0B5ED8D
  %395 = select i1 %394, double 0x3EB0C6F7A0B5ED8D, double %393
  %396 = fmul double %283, 1.000000e+02
  %397 = select i1 %352, double %395, double %392
  %398 = fcmp olt double %396, %397
  %399 = select i1 %398, double %396, double %397
  %400 = tail call double @llvm.fabs.f64(double %192)
  %401 = fmul double %400, 0x3D30000000000000
  %402 = fcmp ogt double %401, %399
  %403 = select i1 %402, double %401, double %399
  %404 = fcmp olt double %271, %403
  %405 = select i1 %404, double %271, double %403
  br label %406

406:                                              ; preds = %328, %346
  %407 = phi double [ %329, %328 ], [ %405, %346 ]
  %408 = tail call i1 @llvm.is.fpclass.f64(double %407, i32 639)
  br i1 %408, label %409, label %411

409:                                              ; preds = %406
  %410 = getelementptr inbounds i8, ptr %162, i64 72
  store i64 4, ptr %410, align 8
  br label %411

411:                                              ; preds = %409, %406, %263, %166
  %412 = phi double [ %407, %406 ], [ %407, %409 ], [ %194, %263 ], [ %194, %166 ]
  %413 = load i64, ptr %163, align 8
  %414 = icmp eq i64 %413, 0
  br i1 %414, label %442, label %415

415:                                              ; preds = %411
  %416 = getelementptr inbounds i8, ptr %162, i64 8
  %417 = getelementptr inbounds i8, ptr %162, i64 16
  %418 = getelementptr inbounds i8, ptr %162, i64 64
  %419 = getelementptr inbounds i8, ptr %162, i64 48
  %420 = getelementptr inbounds i8, ptr %160, i64 16
  %421 = getelementptr inbounds i8, ptr %162, i64 24
  %422 = icmp sgt i64 %170, 0
  %423 = select i1 %173, i1 %179, i1 false
  %424 = getelementptr inbounds i8, ptr %160, i64 32
  %425 = getelementptr inbounds i8, ptr %162, i64 48
  %426 = getelementptr inbounds i8, ptr %162, i64 72
  %427 = getelementptr inbounds i8, ptr %160, i64 24
  %428 = getelementptr inbounds i8, ptr %160, i64 40
  %429 = getelementptr inbounds i8, ptr %168, i64 24
  %430 = getelementptr inbounds i8, ptr %168, i64 8
  %431 = getelementptr inbounds i8, ptr %168, i64 16
  %432 = getelementptr inbounds i8, ptr %168, i64 32
  %433 = getelementptr inbounds i8, ptr %168, i64 40
  %434 = icmp sgt i64 %170, 0
  %435 = getelementptr inbounds i8, ptr %162, i64 48
  %436 = getelementptr inbounds i8, ptr %162, i64 72
  %437 = getelementptr inbounds i8, ptr %160, i64 40
  %438 = getelementptr inbounds i8, ptr %162, i64 72
  %439 = getelementptr inbounds i8, ptr %168, i64 24
  %440 = getelementptr inbounds i8, ptr %168, i64 32
  %441 = getelementptr inbounds i8, ptr %160, i64 40
  br label %444

442:                                              ; preds = %1622, %411
  %443 = phi double [ %412, %411 ], [ %1618, %1622 ]
  store double %443, ptr %193, align 8
  br label %1625

444:                                              ; preds = %415, %1622
  %445 = phi i64 [ %413, %415 ], [ %1623, %1622 ]
  %446 = phi i64 [ undef, %415 ], [ %1621, %1622 ]
  %447 = phi double [ %192, %415 ], [ %1619, %1622 ]
  %448 = phi double [ %412, %415 ], [ %1618, %1622 ]
  %449 = load ptr, ptr %93, align 8
  %450 = getelementptr inbounds i8, ptr %449, i64 8
  %451 = load i64, ptr %450, align 8
  %452 = icmp sgt i64 %451, 0
  br i1 %452, label %453, label %458

453:                                              ; preds = %444
  %454 = load i64, ptr %449, align 8
  %455 = add nsw i64 %454, 3
  %456 = icmp slt i64 %451, %455
  %457 = zext i1 %456 to i32
  br label %458

458:                                              ; preds = %444, %453
  %459 = phi i32 [ 0, %444 ], [ %457, %453 ]
  %460 = icmp eq i32 %459, 0
  br i1 %460, label %462, label %461

461:                                              ; preds = %458
  store double %448, ptr %193, align 8
  br label %1625

462:                                              ; preds = %458
  %463 = add nsw i64 %445, -1
  store i64 %463, ptr %163, align 8
  %464 = load i64, ptr %416, align 8
  %465 = load i64, ptr %417, align 8
  %466 = add nsw i64 %465, %464
  %467 = load i64, ptr %418, align 8
  %468 = icmp slt i64 %466, %467
  br i1 %468, label %470, label %469

469:                                              ; preds = %462
  store double %448, ptr %193, align 8
  br label %1625

470:                                              ; preds = %462
  br i1 %176, label %471, label %475

471:                                              ; preds = %470
  %472 = load i64, ptr %419, align 8
  %473 = getelementptr inbounds double, ptr %167, i64 %472
  %474 = load double, ptr %473, align 8
  br label %475

475:                                              ; preds = %471, %470
  %476 = phi double [ %474, %471 ], [ %187, %470 ]
  br i1 %176, label %481, label %477

477:                                              ; preds = %475
  %478 = load double, ptr %420, align 8
  %479 = fcmp olt double %448, %478
  %480 = select i1 %479, double %448, double %478
  br label %487

481:                                              ; preds = %475
  %482 = fsub double %476, %447
  %483 = fdiv double %482, %448
  %484 = fmul double %483, 0x3FEFFFFFFFFFDCD1
  %485 = tail call double @llvm.ceil.f64(double %484)
  %486 = fdiv double %482, %485
  br label %487

487:                                              ; preds = %481, %477
  %488 = phi double [ %480, %477 ], [ %486, %481 ]
  %489 = fadd double %447, %488
  %490 = fmul double %488, 1.000000e-03
  %491 = fsub double %476, %490
  %492 = fcmp ule double %489, %491
  %493 = fsub double %476, %447
  %494 = select i1 %492, double %488, double %493
  %495 = select i1 %492, double %489, double %476
  %496 = fmul double %494, 6.250000e-02
  %497 = fadd double %447, %496
  %498 = fcmp ule double %497, %447
  %499 = fcmp une double %495, %476
  %500 = and i1 %499, %498
  br i1 %500, label %501, label %502

501:                                              ; preds = %487
  store double %494, ptr %193, align 8
  br label %1617

502:                                              ; preds = %487
  %503 = load ptr, ptr %0, align 8
  %504 = load i64, ptr %503, align 8
  %505 = load ptr, ptr %94, align 8
  %506 = insertelement <8 x double> poison, double %494, i64 0
  %507 = shufflevector <8 x double> %506, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %507, ptr %505, align 8
  %508 = icmp sgt i64 %504, 1
  br i1 %508, label %513, label %597

509:                                              ; preds = %586
  %510 = add nuw nsw i64 %516, 1
  %511 = icmp slt i64 %510, %504
  %512 = icmp eq i64 %510, %504
  br i1 %512, label %597, label %513, !llvm.loop !12

513:                                              ; preds = %502, %509
  %514 = phi i1 [ %511, %509 ], [ %508, %502 ]
  %515 = phi i64 [ %596, %509 ], [ undef, %502 ]
  %516 = phi i64 [ %510, %509 ], [ 1, %502 ]
  %517 = load ptr, ptr %95, align 8
  %518 = load ptr, ptr %74, align 8
  %519 = load ptr, ptr %73, align 8
  %520 = getelementptr inbounds i8, ptr %519, i64 16
  %521 = load i64, ptr %520, align 8
  %522 = icmp sgt i64 %521, 1
  %523 = zext i1 %522 to i64
  %524 = load ptr, ptr %96, align 8
  %525 = getelementptr inbounds i64, ptr %524, i64 %516
  %526 = load i64, ptr %525, align 8
  %527 = getelementptr i8, ptr %525, i64 8
  %528 = load i64, ptr %527, align 8
  %529 = xor i64 %526, -1
  %530 = add i64 %528, %529
  %531 = load ptr, ptr %94, align 8
  %532 = load ptr, ptr %97, align 8
  %533 = load ptr, ptr %98, align 8
  %534 = getelementptr inbounds i64, ptr %533, i64 %526
  %535 = load ptr, ptr %99, align 8
  %536 = getelementptr inbounds double, ptr %535, i64 %526
  tail call fastcc void @combine(ptr noundef %517, ptr noundef %518, ptr noundef %531, ptr noundef %532, ptr noundef %534, ptr noundef %536, i64 noundef %530, i64 noundef %523, i64 noundef %521) #8
  %537 = icmp eq i64 %521, 1
  br i1 %537, label %538, label %569

538:                                              ; preds = %513
  %539 = load ptr, ptr %96, align 8
  %540 = getelementptr i64, ptr %539, i64 %516
  %541 = getelementptr i8, ptr %540, i64 8
  %542 = load i64, ptr %541, align 8
  %543 = add nsw i64 %542, -1
  %544 = load ptr, ptr %99, align 8
  %545 = getelementptr inbounds double, ptr %544, i64 %543
  %546 = load double, ptr %545, align 8
  %547 = fmul double %494, %546
  %548 = load ptr, ptr %97, align 8
  %549 = load ptr, ptr %98, align 8
  %550 = getelementptr inbounds i64, ptr %549, i64 %543
  %551 = load i64, ptr %550, align 8
  %552 = getelementptr inbounds double, ptr %548, i64 %551
  %553 = load ptr, ptr %73, align 8
  %554 = getelementptr inbounds i8, ptr %553, i64 8
  %555 = load i64, ptr %554, align 8
  %556 = icmp sgt i64 %555, 0
  br i1 %556, label %557, label %569

557:                                              ; preds = %538, %557
  %558 = phi i64 [ %564, %557 ], [ 0, %538 ]
  %559 = getelementptr inbounds double, ptr %552, i64 %558
  %560 = load double, ptr %559, align 8
  %561 = getelementptr inbounds double, ptr %517, i64 %558
  %562 = load double, ptr %561, align 8
  %563 = tail call double @llvm.fma.f64(double %547, double %560, double %562)
  store double %563, ptr %561, align 8
  %564 = add nuw nsw i64 %558, 1
  %565 = load ptr, ptr %73, align 8
  %566 = getelementptr inbounds i8, ptr %565, i64 8
  %567 = load i64, ptr %566, align 8
  %568 = icmp slt i64 %564, %567
  br i1 %568, label %557, label %569, !llvm.loop !13

569:                                              ; preds = %557, %538, %513
  %570 = load ptr, ptr %97, align 8
  %571 = load i64, ptr %100, align 8
  %572 = mul nsw i64 %571, %516
  %573 = getelementptr inbounds double, ptr %570, i64 %572
  %574 = load i64, ptr %421, align 8
  %575 = add nsw i64 %574, 1
  store i64 %575, ptr %421, align 8
  %576 = load ptr, ptr %101, align 8
  %577 = getelementptr inbounds double, ptr %576, i64 %516
  %578 = load double, ptr %577, align 8
  %579 = fmul double %494, %578
  %580 = fadd double %447, %579
  %581 = load ptr, ptr %95, align 8
  %582 = load ptr, ptr %102, align 8
  store double %580, ptr %582, align 8
  %583 = load i64, ptr %103, align 8
  %584 = icmp sgt i64 %583, 0
  br i1 %584, label %585, label %586

585:                                              ; preds = %569
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %586

586:                                              ; preds = %569, %585
  %587 = load ptr, ptr %73, align 8
  %588 = load i64, ptr %587, align 8
  %589 = load ptr, ptr %102, align 8
  %590 = load ptr, ptr %104, align 8
  %591 = load ptr, ptr %105, align 8
  %592 = inttoptr i64 %588 to ptr
  %593 = tail call i32 %592(ptr noundef %589, ptr noundef %581, ptr noundef %590, ptr noundef %591, ptr noundef %573) #9
  %594 = sext i32 %593 to i64
  %595 = icmp eq i32 %593, 0
  %596 = select i1 %595, i64 %515, i64 %594
  br i1 %595, label %509, label %597

597:                                              ; preds = %509, %586, %502
  %598 = phi i1 [ %508, %502 ], [ %511, %509 ], [ %514, %586 ]
  %599 = phi i64 [ 0, %502 ], [ %594, %586 ], [ %594, %509 ]
  %600 = phi i64 [ undef, %502 ], [ %596, %586 ], [ %596, %509 ]
  br i1 %598, label %654, label %601

601:                                              ; preds = %597
  %602 = load ptr, ptr %106, align 8
  %603 = load ptr, ptr %74, align 8
  %604 = load ptr, ptr %73, align 8
  %605 = getelementptr inbounds i8, ptr %604, i64 16
  %606 = load i64, ptr %605, align 8
  %607 = icmp sgt i64 %606, 1
  %608 = zext i1 %607 to i64
  %609 = load ptr, ptr %107, align 8
  %610 = getelementptr inbounds i64, ptr %609, i64 %504
  %611 = load i64, ptr %610, align 8
  %612 = getelementptr i8, ptr %610, i64 8
  %613 = load i64, ptr %612, align 8
  %614 = xor i64 %611, -1
  %615 = add i64 %613, %614
  %616 = load ptr, ptr %94, align 8
  %617 = load ptr, ptr %108, align 8
  %618 = load ptr, ptr %109, align 8
  %619 = getelementptr inbounds i64, ptr %618, i64 %611
  %620 = load ptr, ptr %110, align 8
  %621 = getelementptr inbounds double, ptr %620, i64 %611
  tail call fastcc void @combine(ptr noundef %602, ptr noundef %603, ptr noundef %616, ptr noundef %617, ptr noundef %619, ptr noundef %621, i64 noundef %615, i64 noundef %608, i64 noundef %606) #8
  %622 = icmp eq i64 %606, 1
  br i1 %622, label %623, label %654

623:                                              ; preds = %601
  %624 = load ptr, ptr %107, align 8
  %625 = getelementptr i64, ptr %624, i64 %504
  %626 = getelementptr i8, ptr %625, i64 8
  %627 = load i64, ptr %626, align 8
  %628 = add nsw i64 %627, -1
  %629 = load ptr, ptr %110, align 8
  %630 = getelementptr inbounds double, ptr %629, i64 %628
  %631 = load double, ptr %630, align 8
  %632 = fmul double %494, %631
  %633 = load ptr, ptr %108, align 8
  %634 = load ptr, ptr %109, align 8
  %635 = getelementptr inbounds i64, ptr %634, i64 %628
  %636 = load i64, ptr %635, align 8
  %637 = getelementptr inbounds double, ptr %633, i64 %636
  %638 = load ptr, ptr %73, align 8
  %639 = getelementptr inbounds i8, ptr %638, i64 8
  %640 = load i64, ptr %639, align 8
  %641 = icmp sgt i64 %640, 0
  br i1 %641, label %642, label %654

642:                                              ; preds = %623, %642
  %643 = phi i64 [ %649, %642 ], [ 0, %623 ]
  %644 = getelementptr inbounds double, ptr %637, i64 %643
  %645 = load double, ptr %644, align 8
  %646 = getelementptr inbounds double, ptr %602, i64 %643
  %647 = load double, ptr %646, align 8
  %648 = tail call double @llvm.fma.f64(double %632, double %645, double %647)
  store double %648, ptr %646, align 8
  %649 = add nuw nsw i64 %643, 1
  %650 = load ptr, ptr %73, align 8
  %651 = getelementptr inbounds i8, ptr %650, i64 8
  %652 = load i64, ptr %651, align 8
  %653 = icmp slt i64 %649, %652
  br i1 %653, label %642, label %654, !llvm.loop !13

654:                                              ; preds = %642, %623, %601, %597
  %655 = phi i64 [ %600, %597 ], [ %599, %601 ], [ %599, %623 ], [ %599, %642 ]
  %656 = icmp eq i64 %655, 0
  %657 = select i1 %656, i1 %179, i1 false
  br i1 %657, label %658, label %674

658:                                              ; preds = %654
  %659 = load i64, ptr %421, align 8
  %660 = add nsw i64 %659, 1
  store i64 %660, ptr %421, align 8
  %661 = load ptr, ptr %111, align 8
  store double %495, ptr %661, align 8
  %662 = load i64, ptr %112, align 8
  %663 = icmp sgt i64 %662, 0
  br i1 %663, label %664, label %665

664:                                              ; preds = %658
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %665

665:                                              ; preds = %658, %664
  %666 = load ptr, ptr %73, align 8
  %667 = load i64, ptr %666, align 8
  %668 = load ptr, ptr %111, align 8
  %669 = load ptr, ptr %113, align 8
  %670 = load ptr, ptr %114, align 8
  %671 = inttoptr i64 %667 to ptr
  %672 = tail call i32 %671(ptr noundef %668, ptr noundef %161, ptr noundef %669, ptr noundef %670, ptr noundef %191) #9
  %673 = sext i32 %672 to i64
  br label %674

674:                                              ; preds = %665, %654
  %675 = phi i64 [ %673, %665 ], [ %655, %654 ]
  %676 = icmp slt i64 %675, 0
  br i1 %676, label %1617, label %677

677:                                              ; preds = %674
  %678 = icmp eq i64 %675, 0
  br i1 %678, label %679, label %874

679:                                              ; preds = %677
  br i1 %176, label %680, label %681

680:                                              ; preds = %679
  br i1 %422, label %830, label %839

681:                                              ; preds = %679
  %682 = load ptr, ptr %73, align 8
  %683 = load ptr, ptr %0, align 8
  %684 = getelementptr inbounds i8, ptr %682, i64 24
  %685 = load i64, ptr %684, align 8
  %686 = getelementptr inbounds i8, ptr %683, i64 8
  %687 = load i64, ptr %686, align 8
  %688 = load ptr, ptr %115, align 8
  %689 = load i64, ptr %116, align 8
  %690 = getelementptr inbounds double, ptr %688, i64 %689
  %691 = icmp sgt i64 %687, 0
  br i1 %691, label %692, label %694

692:                                              ; preds = %681
  %693 = getelementptr inbounds i8, ptr %682, i64 32
  br label %702

694:                                              ; preds = %702, %681
  %695 = icmp sgt i64 %685, 0
  br i1 %695, label %696, label %728

696:                                              ; preds = %694
  %697 = load ptr, ptr %74, align 8
  %698 = load ptr, ptr %122, align 8
  %699 = load ptr, ptr %123, align 8
  %700 = load ptr, ptr %124, align 8
  %701 = load ptr, ptr %115, align 8
  br label %786

702:                                              ; preds = %692, %702
  %703 = phi i64 [ 0, %692 ], [ %726, %702 ]
  %704 = load i64, ptr %683, align 8
  %705 = load i64, ptr %693, align 8
  %706 = load ptr, ptr %115, align 8
  %707 = load i64, ptr %116, align 8
  %708 = mul nsw i64 %707, %703
  %709 = getelementptr inbounds double, ptr %706, i64 %708
  %710 = load ptr, ptr %117, align 8
  %711 = load ptr, ptr %118, align 8
  %712 = getelementptr i64, ptr %711, i64 %704
  %713 = getelementptr i8, ptr %712, i64 8
  %714 = getelementptr i64, ptr %713, i64 %703
  %715 = load i64, ptr %714, align 8
  %716 = getelementptr i8, ptr %714, i64 8
  %717 = load i64, ptr %716, align 8
  %718 = xor i64 %715, -1
  %719 = add i64 %717, %718
  %720 = load ptr, ptr %94, align 8
  %721 = load ptr, ptr %119, align 8
  %722 = load ptr, ptr %120, align 8
  %723 = getelementptr inbounds i64, ptr %722, i64 %715
  %724 = load ptr, ptr %121, align 8
  %725 = getelementptr inbounds double, ptr %724, i64 %715
  tail call fastcc void @combine(ptr noundef %709, ptr noundef %710, ptr noundef %720, ptr noundef %721, ptr noundef %723, ptr noundef %725, i64 noundef %719, i64 noundef 1, i64 noundef %705) #8
  %726 = add nuw nsw i64 %703, 1
  %727 = icmp eq i64 %726, %687
  br i1 %727, label %694, label %702, !llvm.loop !14

728:                                              ; preds = %786, %694
  %729 = phi double [ 0.000000e+00, %694 ], [ %814, %786 ]
  %730 = phi double [ 0.000000e+00, %694 ], [ %812, %786 ]
  %731 = load ptr, ptr %125, align 8
  %732 = getelementptr inbounds i8, ptr %682, i64 8
  %733 = load i64, ptr %732, align 8
  %734 = add nsw i64 %733, -3
  %735 = getelementptr i8, ptr %731, i64 8
  %736 = getelementptr i8, ptr %731, i64 16
  %737 = getelementptr i8, ptr %731, i64 24
  %738 = icmp slt i64 %685, %734
  br i1 %738, label %746, label %739

739:                                              ; preds = %746, %728
  %740 = phi double [ 0.000000e+00, %728 ], [ %755, %746 ]
  %741 = phi double [ 0.000000e+00, %728 ], [ %759, %746 ]
  %742 = phi double [ 0.000000e+00, %728 ], [ %763, %746 ]
  %743 = phi double [ 0.000000e+00, %728 ], [ %767, %746 ]
  %744 = phi i64 [ %685, %728 ], [ %768, %746 ]
  %745 = icmp slt i64 %744, %733
  br i1 %745, label %770, label %779

746:                                              ; preds = %728, %746
  %747 = phi i64 [ %768, %746 ], [ %685, %728 ]
  %748 = phi double [ %767, %746 ], [ 0.000000e+00, %728 ]
  %749 = phi double [ %763, %746 ], [ 0.000000e+00, %728 ]
  %750 = phi double [ %759, %746 ], [ 0.000000e+00, %728 ]
  %751 = phi double [ %755, %746 ], [ 0.000000e+00, %728 ]
  %752 = getelementptr inbounds double, ptr %731, i64 %747
  %753 = load double, ptr %752, align 8
  %754 = fmul double %753, 0.000000e+00
  %755 = fadd double %751, %754
  %756 = getelementptr double, ptr %735, i64 %747
  %757 = load double, ptr %756, align 8
  %758 = fmul double %757, 0.000000e+00
  %759 = fadd double %750, %758
  %760 = getelementptr double, ptr %736, i64 %747
  %761 = load double, ptr %760, align 8
  %762 = fmul double %761, 0.000000e+00
  %763 = fadd double %749, %762
  %764 = getelementptr double, ptr %737, i64 %747
  %765 = load double, ptr %764, align 8
  %766 = fmul double %765, 0.000000e+00
  %767 = fadd double %748, %766
  %768 = add nsw i64 %747, 4
  %769 = icmp slt i64 %768, %734
  br i1 %769, label %746, label %739, !llvm.loop !15

770:                                              ; preds = %739, %770
  %771 = phi i64 [ %777, %770 ], [ %744, %739 ]
  %772 = phi double [ %776, %770 ], [ %740, %739 ]
  %773 = getelementptr inbounds double, ptr %731, i64 %771
  %774 = load double, ptr %773, align 8
  %775 = fmul double %774, 0.000000e+00
  %776 = fadd double %772, %775
  %777 = add nsw i64 %771, 1
  %778 = icmp eq i64 %777, %733
  br i1 %778, label %779, label %770, !llvm.loop !16

779:                                              ; preds = %770, %739
  %780 = phi double [ %740, %739 ], [ %776, %770 ]
  %781 = fadd double %741, %780
  %782 = fadd double %742, %743
  %783 = fadd double %782, %781
  %784 = fadd double %730, %783
  %785 = icmp eq i64 %687, 2
  br i1 %785, label %817, label %826

786:                                              ; preds = %696, %786
  %787 = phi double [ 0.000000e+00, %696 ], [ %812, %786 ]
  %788 = phi double [ 0.000000e+00, %696 ], [ %814, %786 ]
  %789 = phi i64 [ 0, %696 ], [ %815, %786 ]
  %790 = getelementptr inbounds double, ptr %697, i64 %789
  %791 = load double, ptr %790, align 8
  %792 = getelementptr inbounds double, ptr %698, i64 %789
  %793 = load double, ptr %792, align 8
  %794 = getelementptr inbounds double, ptr %699, i64 %789
  %795 = load double, ptr %794, align 8
  %796 = getelementptr inbounds double, ptr %700, i64 %789
  %797 = load double, ptr %796, align 8
  %798 = tail call double @llvm.fabs.f64(double %791)
  %799 = tail call double @llvm.fabs.f64(double %793)
  %800 = fcmp ogt double %798, %799
  %801 = select i1 %800, double %798, double %799
  %802 = fmul double %801, %797
  %803 = fadd double %795, %802
  %804 = fdiv double 1.000000e+00, %803
  %805 = getelementptr inbounds double, ptr %701, i64 %789
  %806 = load double, ptr %805, align 8
  %807 = fmul double %806, %804
  %808 = getelementptr inbounds double, ptr %690, i64 %789
  %809 = load double, ptr %808, align 8
  %810 = fmul double %809, %804
  %811 = fmul double %807, %807
  %812 = fadd double %787, %811
  %813 = fmul double %810, %810
  %814 = fadd double %788, %813
  %815 = add nuw nsw i64 %789, 1
  %816 = icmp eq i64 %815, %685
  br i1 %816, label %728, label %786, !llvm.loop !17

817:                                              ; preds = %779
  %818 = fmul double %729, 1.000000e-02
  %819 = fadd double %818, %784
  %820 = sitofp i64 %685 to double
  %821 = fmul double %819, %820
  %822 = tail call double @llvm.sqrt.f64(double %821)
  %823 = fdiv double %784, %822
  %824 = fcmp une double %784, 0.000000e+00
  %825 = select i1 %824, double %823, double 0.000000e+00
  br label %839

826:                                              ; preds = %779
  %827 = sitofp i64 %685 to double
  %828 = fdiv double %784, %827
  %829 = tail call double @llvm.sqrt.f64(double %828)
  br label %839

830:                                              ; preds = %680, %830
  %831 = phi i64 [ %837, %830 ], [ 0, %680 ]
  %832 = phi double [ %836, %830 ], [ 0.000000e+00, %680 ]
  %833 = getelementptr inbounds double, ptr %161, i64 %831
  %834 = load double, ptr %833, align 8
  %835 = fmul double %834, 0.000000e+00
  %836 = fadd double %832, %835
  %837 = add nuw nsw i64 %831, 1
  %838 = icmp eq i64 %837, %170
  br i1 %838, label %839, label %830, !llvm.loop !18

839:                                              ; preds = %830, %680, %826, %817
  %840 = phi double [ %825, %817 ], [ %829, %826 ], [ 0.000000e+00, %680 ], [ %836, %830 ]
  %841 = fcmp uge double %840, 1.000000e+00
  %842 = select i1 %841, i1 true, i1 %423
  br i1 %842, label %874, label %843

843:                                              ; preds = %839
  br i1 %173, label %855, label %844

844:                                              ; preds = %843
  br i1 %176, label %847, label %845

845:                                              ; preds = %844
  %846 = load ptr, ptr %74, align 8
  br label %847

847:                                              ; preds = %845, %844
  %848 = phi ptr [ %846, %845 ], [ null, %844 ]
  %849 = load ptr, ptr %81, align 8
  %850 = getelementptr inbounds i8, ptr %849, i64 56
  %851 = load i64, ptr %850, align 8
  %852 = inttoptr i64 %851 to ptr
  %853 = tail call i64 %852(ptr noundef %0, double noundef %495, ptr noundef %161, ptr noundef %848) #9
  %854 = icmp ne i64 %853, 0
  br label %855

855:                                              ; preds = %847, %843
  %856 = phi i1 [ false, %843 ], [ %854, %847 ]
  br i1 %856, label %874, label %857

857:                                              ; preds = %855
  %858 = load i64, ptr %421, align 8
  %859 = add nsw i64 %858, 1
  store i64 %859, ptr %421, align 8
  %860 = load ptr, ptr %126, align 8
  store double %495, ptr %860, align 8
  %861 = load i64, ptr %127, align 8
  %862 = icmp sgt i64 %861, 0
  br i1 %862, label %863, label %864

863:                                              ; preds = %857
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %864

864:                                              ; preds = %857, %863
  %865 = load ptr, ptr %73, align 8
  %866 = load i64, ptr %865, align 8
  %867 = load ptr, ptr %126, align 8
  %868 = load ptr, ptr %128, align 8
  %869 = load ptr, ptr %129, align 8
  %870 = inttoptr i64 %866 to ptr
  %871 = tail call i32 %870(ptr noundef %867, ptr noundef %161, ptr noundef %868, ptr noundef %869, ptr noundef %191) #9
  %872 = sext i32 %871 to i64
  %873 = icmp slt i32 %871, 0
  br i1 %873, label %1617, label %874

874:                                              ; preds = %864, %855, %839, %677
  %875 = phi i64 [ 0, %855 ], [ %872, %864 ], [ 0, %839 ], [ %675, %677 ]
  %876 = phi double [ %840, %855 ], [ %840, %864 ], [ %840, %839 ], [ 0.000000e+00, %677 ]
  %877 = phi i1 [ %856, %855 ], [ %856, %864 ], [ false, %839 ], [ false, %677 ]
  %878 = icmp ne i64 %875, 0
  %879 = fcmp uge double %876, 1.000000e+00
  %880 = or i1 %878, %879
  %881 = or i1 %877, %880
  br i1 %881, label %882, label %945

882:                                              ; preds = %874
  %883 = load i64, ptr %417, align 8
  %884 = add nsw i64 %883, 1
  store i64 %884, ptr %417, align 8
  %885 = or i1 %878, %877
  br i1 %885, label %889, label %886

886:                                              ; preds = %882
  %887 = tail call double @llvm.fabs.f64(double %876)
  %888 = fcmp one double %887, 0x7FF0000000000000
  br label %889

889:                                              ; preds = %886, %882
  %890 = phi i1 [ false, %882 ], [ %888, %886 ]
  %891 = select i1 %890, i64 2, i64 4
  %892 = select i1 %877, i64 6, i64 %891
  %893 = select i1 %878, i64 3, i64 %892
  store i64 %893, ptr %438, align 8
  %894 = fcmp ogt double %876, 1.000000e-10
  %895 = select i1 %894, double %876, double 1.000000e-10
  %896 = load double, ptr %439, align 8
  %897 = load double, ptr %168, align 8
  %898 = fneg double %897
  %899 = bitcast double %895 to i64
  %900 = add nsw i64 %899, -4604544271217802189
  %901 = ashr i64 %900, 52
  %902 = and i64 %900, -4503599627370496
  %903 = sub nsw i64 %899, %902
  %904 = bitcast i64 %903 to double
  %905 = fadd double %904, -1.000000e+00
  %906 = fadd double %904, 1.000000e+00
  %907 = fdiv double %905, %906
  %908 = fmul double %907, %907
  %909 = tail call double @llvm.fma.f64(double %908, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %910 = tail call double @llvm.fma.f64(double %909, double %908, double 0x3FE2776C50EF9BFE)
  %911 = tail call double @llvm.fma.f64(double %910, double %908, double 0x3FEEC709DC3A03FD)
  %912 = tail call double @llvm.fma.f64(double %911, double %908, double 0x40071547652B82FE)
  %913 = trunc nsw i64 %901 to i32
  %914 = sitofp i32 %913 to double
  %915 = fmul double %907, %912
  %916 = fadd double %915, %914
  %917 = fmul double %916, %898
  %918 = fcmp ogt double %917, -1.000000e+03
  %919 = select i1 %918, double %917, double -1.000000e+03
  %920 = fcmp olt double %919, 1.000000e+03
  %921 = select i1 %920, double %919, double 1.000000e+03
  %922 = tail call double @llvm.rint.f64(double %921)
  %923 = fsub double %921, %922
  %924 = tail call double @llvm.fma.f64(double %923, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %925 = tail call double @llvm.fma.f64(double %924, double %923, double 0x3F55D87FE78A6730)
  %926 = tail call double @llvm.fma.f64(double %925, double %923, double 0x3F83B2AB6FBA4E77)
  %927 = tail call double @llvm.fma.f64(double %926, double %923, double 0x3FAC6B08D704A0BF)
  %928 = tail call double @llvm.fma.f64(double %927, double %923, double 0x3FCEBFBDFF82C58E)
  %929 = tail call double @llvm.fma.f64(double %928, double %923, double 0x3FE62E42FEFA39EF)
  %930 = tail call double @llvm.fma.f64(double %929, double %923, double 1.000000e+00)
  %931 = bitcast double %930 to i64
  %932 = fptosi double %922 to i32
  %933 = sext i32 %932 to i64
  %934 = shl nsw i64 %933, 52
  %935 = add nsw i64 %934, %931
  %936 = bitcast i64 %935 to double
  %937 = fmul double %896, %936
  %938 = load double, ptr %440, align 8
  %939 = fcmp ogt double %937, %938
  %940 = select i1 %939, double %937, double %938
  %941 = select i1 %890, double %940, double 2.500000e-01
  %942 = fmul double %494, %941
  br i1 %176, label %943, label %944

943:                                              ; preds = %889
  store double %494, ptr %193, align 8
  br label %1617

944:                                              ; preds = %889
  store double 1.000000e+00, ptr %441, align 8
  br label %1617, !llvm.loop !19

945:                                              ; preds = %874
  %946 = load i64, ptr %416, align 8
  %947 = add nsw i64 %946, 1
  store i64 %947, ptr %416, align 8
  store double %495, ptr %160, align 8
  store double %494, ptr %424, align 8
  %948 = load ptr, ptr %93, align 8
  %949 = getelementptr inbounds i8, ptr %948, i64 8
  %950 = load i64, ptr %949, align 8
  %951 = icmp eq i64 %950, 0
  br i1 %951, label %981, label %952

952:                                              ; preds = %945
  %953 = load i64, ptr %948, align 8
  %954 = load ptr, ptr %73, align 8
  %955 = getelementptr inbounds i8, ptr %954, i64 8
  %956 = load i64, ptr %955, align 8
  %957 = load ptr, ptr %130, align 8
  %958 = load i64, ptr %131, align 8
  %959 = mul nsw i64 %958, %953
  %960 = getelementptr inbounds double, ptr %957, i64 %959
  %961 = getelementptr inbounds double, ptr %960, i64 %958
  store double %447, ptr %960, align 8
  %962 = getelementptr inbounds i8, ptr %960, i64 8
  store double %494, ptr %962, align 8
  store double %495, ptr %961, align 8
  %963 = getelementptr inbounds i8, ptr %961, i64 8
  store double 0.000000e+00, ptr %963, align 8
  %964 = icmp sgt i64 %956, 0
  br i1 %964, label %968, label %965

965:                                              ; preds = %968, %952
  %966 = add nsw i64 %953, 1
  %967 = load ptr, ptr %93, align 8
  store i64 %966, ptr %967, align 8
  br label %981

968:                                              ; preds = %952, %968
  %969 = phi i64 [ %979, %968 ], [ 0, %952 ]
  %970 = load ptr, ptr %74, align 8
  %971 = getelementptr inbounds double, ptr %970, i64 %969
  %972 = load double, ptr %971, align 8
  %973 = add nuw nsw i64 %969, 2
  %974 = getelementptr inbounds double, ptr %960, i64 %973
  store double %972, ptr %974, align 8
  %975 = load ptr, ptr %76, align 8
  %976 = getelementptr inbounds double, ptr %975, i64 %969
  %977 = load double, ptr %976, align 8
  %978 = getelementptr inbounds double, ptr %961, i64 %973
  store double %977, ptr %978, align 8
  %979 = add nuw nsw i64 %969, 1
  %980 = icmp eq i64 %979, %956
  br i1 %980, label %965, label %968, !llvm.loop !20

981:                                              ; preds = %945, %965
  br i1 %183, label %982, label %1091

982:                                              ; preds = %981
  %983 = load ptr, ptr %82, align 8
  %984 = load i64, ptr %80, align 8
  %985 = load ptr, ptr %132, align 8
  %986 = getelementptr inbounds i8, ptr %983, i64 32
  %987 = load i64, ptr %986, align 8
  %988 = getelementptr inbounds double, ptr %985, i64 %987
  %989 = getelementptr inbounds i8, ptr %983, i64 24
  %990 = load i64, ptr %989, align 8
  %991 = icmp eq i64 %990, 0
  br i1 %991, label %1088, label %992

992:                                              ; preds = %982
  %993 = getelementptr inbounds i8, ptr %983, i64 40
  %994 = load i64, ptr %993, align 8
  %995 = icmp sgt i64 %994, 0
  br i1 %995, label %1049, label %996

996:                                              ; preds = %1067, %992
  %997 = load ptr, ptr %133, align 8
  %998 = load ptr, ptr %82, align 8
  %999 = getelementptr inbounds i8, ptr %998, i64 8
  %1000 = load i64, ptr %999, align 8
  %1001 = load ptr, ptr %134, align 8
  %1002 = load ptr, ptr %132, align 8
  %1003 = getelementptr inbounds i8, ptr %998, i64 32
  %1004 = load i64, ptr %1003, align 8
  %1005 = getelementptr inbounds i8, ptr %998, i64 40
  %1006 = load i64, ptr %1005, align 8
  %1007 = getelementptr double, ptr %1002, i64 %1004
  %1008 = getelementptr double, ptr %1007, i64 %1006
  store double %494, ptr %1008, align 8
  %1009 = load ptr, ptr %133, align 8
  store double %447, ptr %1009, align 8
  %1010 = load ptr, ptr %82, align 8
  %1011 = getelementptr inbounds i8, ptr %1010, i64 24
  %1012 = load i64, ptr %1011, align 8
  %1013 = load ptr, ptr %74, align 8
  %1014 = load ptr, ptr %132, align 8
  %1015 = load ptr, ptr %135, align 8
  %1016 = inttoptr i64 %1012 to ptr
  %1017 = tail call i32 %1016(ptr noundef %997, ptr noundef %1013, ptr noundef %1014, ptr noundef %1015, ptr noundef %1001) #9
  %1018 = icmp eq i32 %1017, 0
  br i1 %1018, label %1019, label %1088

1019:                                             ; preds = %996
  %1020 = icmp slt i64 %1000, 1
  br i1 %1020, label %1046, label %1021

1021:                                             ; preds = %1019
  %1022 = load ptr, ptr %136, align 8
  %1023 = getelementptr double, ptr %1001, i64 %1000
  br label %1024

1024:                                             ; preds = %1021, %1042
  %1025 = phi i1 [ %1020, %1021 ], [ %1044, %1042 ]
  %1026 = phi i64 [ 0, %1021 ], [ %1043, %1042 ]
  %1027 = getelementptr inbounds i64, ptr %1022, i64 %1026
  %1028 = load i64, ptr %1027, align 8
  %1029 = and i64 %1028, 2
  %1030 = icmp eq i64 %1029, 0
  br i1 %1030, label %1031, label %1042

1031:                                             ; preds = %1024
  %1032 = getelementptr inbounds double, ptr %1001, i64 %1026
  %1033 = load double, ptr %1032, align 8
  %1034 = load ptr, ptr %137, align 8
  %1035 = getelementptr inbounds i64, ptr %1034, i64 %1026
  %1036 = load i64, ptr %1035, align 8
  %1037 = sitofp i64 %1036 to double
  %1038 = fmul double %1033, %1037
  %1039 = getelementptr double, ptr %1023, i64 %1026
  %1040 = load double, ptr %1039, align 8
  %1041 = fcmp ogt double %1038, %1040
  br i1 %1041, label %1042, label %1046

1042:                                             ; preds = %1031, %1024
  %1043 = add nuw nsw i64 %1026, 1
  %1044 = icmp sge i64 %1043, %1000
  %1045 = icmp eq i64 %1043, %1000
  br i1 %1045, label %1046, label %1024, !llvm.loop !21

1046:                                             ; preds = %1042, %1031, %1019
  %1047 = phi i1 [ %1020, %1019 ], [ %1044, %1042 ], [ %1025, %1031 ]
  %1048 = zext i1 %1047 to i32
  br label %1088

1049:                                             ; preds = %992, %1067
  %1050 = phi i64 [ %1071, %1067 ], [ 0, %992 ]
  %1051 = load ptr, ptr %76, align 8
  %1052 = getelementptr inbounds double, ptr %1051, i64 %1050
  %1053 = load <8 x double>, ptr %1052, align 8
  %1054 = load ptr, ptr %74, align 8
  %1055 = getelementptr inbounds double, ptr %1054, i64 %1050
  %1056 = load <8 x double>, ptr %1055, align 8
  %1057 = fsub <8 x double> %1053, %1056
  %1058 = fneg <8 x double> %1057
  %1059 = fcmp ogt <8 x double> %1057, zeroinitializer
  %1060 = select <8 x i1> %1059, <8 x double> %1057, <8 x double> %1058
  %1061 = load ptr, ptr %0, align 8
  %1062 = load i64, ptr %1061, align 8
  %1063 = icmp slt i64 %1062, 0
  br i1 %1063, label %1067, label %1064

1064:                                             ; preds = %1049
  %1065 = load ptr, ptr %84, align 8
  %1066 = getelementptr double, ptr %1065, i64 %1050
  br label %1074

1067:                                             ; preds = %1074, %1049
  %1068 = phi <8 x double> [ %1060, %1049 ], [ %1085, %1074 ]
  %1069 = getelementptr inbounds double, ptr %988, i64 %1050
  %1070 = fmul <8 x double> %1068, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  store <8 x double> %1070, ptr %1069, align 8
  %1071 = add nuw nsw i64 %1050, 8
  %1072 = load i64, ptr %993, align 8
  %1073 = icmp slt i64 %1071, %1072
  br i1 %1073, label %1049, label %996, !llvm.loop !22

1074:                                             ; preds = %1064, %1074
  %1075 = phi i64 [ 0, %1064 ], [ %1086, %1074 ]
  %1076 = phi <8 x double> [ %1060, %1064 ], [ %1085, %1074 ]
  %1077 = mul nsw i64 %1075, %984
  %1078 = getelementptr double, ptr %1066, i64 %1077
  %1079 = load <8 x double>, ptr %1078, align 8
  %1080 = fneg <8 x double> %1079
  %1081 = fcmp ogt <8 x double> %1079, zeroinitializer
  %1082 = select <8 x i1> %1081, <8 x double> %1079, <8 x double> %1080
  %1083 = fmul <8 x double> %507, %1082
  %1084 = fcmp ogt <8 x double> %1076, %1083
  %1085 = select <8 x i1> %1084, <8 x double> %1076, <8 x double> %1083
  %1086 = add nuw i64 %1075, 1
  %1087 = icmp eq i64 %1075, %1062
  br i1 %1087, label %1067, label %1074, !llvm.loop !23

1088:                                             ; preds = %1046, %996, %982
  %1089 = phi i32 [ 0, %982 ], [ 0, %996 ], [ %1048, %1046 ]
  %1090 = icmp eq i32 %1089, 0
  br label %1091

1091:                                             ; preds = %1088, %981
  %1092 = phi i1 [ false, %981 ], [ %1090, %1088 ]
  br i1 %1092, label %1135, label %1093

1093:                                             ; preds = %1091
  %1094 = load i64, ptr %425, align 8
  %1095 = getelementptr inbounds double, ptr %167, i64 %1094
  %1096 = load double, ptr %1095, align 8
  %1097 = fcmp ult double %1096, %495
  br i1 %1097, label %1135, label %1098

1098:                                             ; preds = %1093
  %1099 = load ptr, ptr %73, align 8
  %1100 = getelementptr inbounds i8, ptr %1099, i64 8
  %1101 = load i64, ptr %1100, align 8
  %1102 = load i64, ptr %83, align 8
  %1103 = load ptr, ptr %78, align 8
  %1104 = load ptr, ptr %77, align 8
  %1105 = getelementptr inbounds i8, ptr %1104, i64 48
  %1106 = load i64, ptr %1105, align 8
  %1107 = icmp slt i64 %1106, %1102
  br i1 %1107, label %1108, label %1131

1108:                                             ; preds = %1098
  %1109 = icmp sgt i64 %1101, 0
  br label %1110

1110:                                             ; preds = %1108, %1121
  %1111 = phi i64 [ %1106, %1108 ], [ %1122, %1121 ]
  %1112 = getelementptr inbounds double, ptr %1103, i64 %1111
  %1113 = load double, ptr %1112, align 8
  %1114 = load ptr, ptr %75, align 8
  %1115 = load double, ptr %1114, align 8
  %1116 = fcmp ugt double %1113, %1115
  br i1 %1116, label %1131, label %1117

1117:                                             ; preds = %1110
  br i1 %1109, label %1118, label %1121

1118:                                             ; preds = %1117
  %1119 = mul nsw i64 %1111, %1101
  %1120 = getelementptr double, ptr %1, i64 %1119
  br label %1124

1121:                                             ; preds = %1124, %1117
  %1122 = add i64 %1111, 1
  %1123 = icmp eq i64 %1122, %1102
  br i1 %1123, label %1131, label %1110, !llvm.loop !8

1124:                                             ; preds = %1118, %1124
  %1125 = phi i64 [ 0, %1118 ], [ %1129, %1124 ]
  %1126 = getelementptr inbounds double, ptr %161, i64 %1125
  %1127 = load double, ptr %1126, align 8
  %1128 = getelementptr double, ptr %1120, i64 %1125
  store double %1127, ptr %1128, align 8
  %1129 = add nuw nsw i64 %1125, 1
  %1130 = icmp eq i64 %1129, %1101
  br i1 %1130, label %1121, label %1124, !llvm.loop !9

1131:                                             ; preds = %1110, %1121, %1098
  %1132 = phi i64 [ %1106, %1098 ], [ %1111, %1110 ], [ %1102, %1121 ]
  %1133 = load ptr, ptr %77, align 8
  %1134 = getelementptr inbounds i8, ptr %1133, i64 48
  store i64 %1132, ptr %1134, align 8
  br label %1494

1135:                                             ; preds = %1093, %1091
  %1136 = load ptr, ptr %0, align 8
  %1137 = load ptr, ptr %73, align 8
  %1138 = getelementptr inbounds i8, ptr %1137, i64 16
  %1139 = load i64, ptr %1138, align 8
  %1140 = load i64, ptr %1136, align 8
  %1141 = load i64, ptr %138, align 8
  %1142 = load ptr, ptr %139, align 8
  %1143 = mul nsw i64 %1141, %1140
  %1144 = getelementptr inbounds double, ptr %1142, i64 %1143
  %1145 = load ptr, ptr %140, align 8
  %1146 = add nsw i64 %1140, 1
  %1147 = getelementptr inbounds i8, ptr %1136, i64 16
  %1148 = load i64, ptr %1147, align 8
  %1149 = icmp sgt i64 %1148, 0
  br i1 %1149, label %1150, label %1204

1150:                                             ; preds = %1135
  %1151 = getelementptr inbounds i8, ptr %1136, i64 8
  br label %1157

1152:                                             ; preds = %1193
  %1153 = add nsw i64 %1160, 1
  %1154 = load i64, ptr %1147, align 8
  %1155 = add nsw i64 %1154, %1146
  %1156 = icmp slt i64 %1153, %1155
  br i1 %1156, label %1157, label %1204, !llvm.loop !24

1157:                                             ; preds = %1150, %1152
  %1158 = phi i1 [ %1149, %1150 ], [ %1156, %1152 ]
  %1159 = phi i64 [ undef, %1150 ], [ %1203, %1152 ]
  %1160 = phi i64 [ %1146, %1150 ], [ %1153, %1152 ]
  %1161 = load i64, ptr %1151, align 8
  %1162 = load ptr, ptr %141, align 8
  %1163 = load ptr, ptr %74, align 8
  %1164 = load ptr, ptr %142, align 8
  %1165 = getelementptr i64, ptr %1164, i64 %1160
  %1166 = getelementptr i64, ptr %1165, i64 %1161
  %1167 = load i64, ptr %1166, align 8
  %1168 = getelementptr i8, ptr %1166, i64 8
  %1169 = load i64, ptr %1168, align 8
  %1170 = xor i64 %1167, -1
  %1171 = add i64 %1169, %1170
  %1172 = load ptr, ptr %94, align 8
  %1173 = load ptr, ptr %139, align 8
  %1174 = load ptr, ptr %143, align 8
  %1175 = getelementptr inbounds i64, ptr %1174, i64 %1167
  %1176 = load ptr, ptr %144, align 8
  %1177 = getelementptr inbounds double, ptr %1176, i64 %1167
  tail call fastcc void @combine(ptr noundef %1162, ptr noundef %1163, ptr noundef %1172, ptr noundef %1173, ptr noundef %1175, ptr noundef %1177, i64 noundef %1171, i64 noundef 1, i64 noundef %1139) #8
  %1178 = load ptr, ptr %139, align 8
  %1179 = mul nsw i64 %1160, %1141
  %1180 = getelementptr inbounds double, ptr %1178, i64 %1179
  %1181 = load i64, ptr %421, align 8
  %1182 = add nsw i64 %1181, 1
  store i64 %1182, ptr %421, align 8
  %1183 = load ptr, ptr %145, align 8
  %1184 = getelementptr inbounds double, ptr %1183, i64 %1160
  %1185 = load double, ptr %1184, align 8
  %1186 = fmul double %494, %1185
  %1187 = fadd double %447, %1186
  %1188 = load ptr, ptr %141, align 8
  %1189 = load ptr, ptr %146, align 8
  store double %1187, ptr %1189, align 8
  %1190 = load i64, ptr %147, align 8
  %1191 = icmp sgt i64 %1190, 0
  br i1 %1191, label %1192, label %1193

1192:                                             ; preds = %1157
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %1193

1193:                                             ; preds = %1157, %1192
  %1194 = load ptr, ptr %73, align 8
  %1195 = load i64, ptr %1194, align 8
  %1196 = load ptr, ptr %146, align 8
  %1197 = load ptr, ptr %148, align 8
  %1198 = load ptr, ptr %149, align 8
  %1199 = inttoptr i64 %1195 to ptr
  %1200 = tail call i32 %1199(ptr noundef %1196, ptr noundef %1188, ptr noundef %1197, ptr noundef %1198, ptr noundef %1180) #9
  %1201 = sext i32 %1200 to i64
  %1202 = icmp eq i32 %1200, 0
  %1203 = select i1 %1202, i64 %1159, i64 %1201
  br i1 %1202, label %1152, label %1204

1204:                                             ; preds = %1152, %1193, %1135
  %1205 = phi i1 [ %1149, %1135 ], [ %1156, %1152 ], [ %1158, %1193 ]
  %1206 = phi i64 [ 0, %1135 ], [ %1201, %1193 ], [ %1201, %1152 ]
  %1207 = phi i64 [ undef, %1135 ], [ %1203, %1193 ], [ %1203, %1152 ]
  %1208 = getelementptr inbounds i8, ptr %1136, i64 16
  br i1 %1205, label %1277, label %1209

1209:                                             ; preds = %1204
  %1210 = load ptr, ptr %73, align 8
  %1211 = getelementptr inbounds i8, ptr %1210, i64 8
  %1212 = load i64, ptr %1211, align 8
  %1213 = icmp sgt i64 %1212, 0
  br i1 %1213, label %1214, label %1218

1214:                                             ; preds = %1209
  %1215 = getelementptr inbounds double, ptr %1145, i64 %1141
  %1216 = shl nsw i64 %1141, 4
  %1217 = getelementptr inbounds i8, ptr %1145, i64 %1216
  br label %1225

1218:                                             ; preds = %1225, %1209
  %1219 = getelementptr inbounds i8, ptr %1136, i64 8
  %1220 = load i64, ptr %1219, align 8
  %1221 = load i64, ptr %1208, align 8
  %1222 = getelementptr inbounds i8, ptr %1136, i64 24
  %1223 = load i64, ptr %1222, align 8
  %1224 = icmp sgt i64 %1223, 3
  br i1 %1224, label %1252, label %1277

1225:                                             ; preds = %1214, %1225
  %1226 = phi i64 [ 0, %1214 ], [ %1247, %1225 ]
  %1227 = load ptr, ptr %150, align 8
  %1228 = getelementptr inbounds double, ptr %1227, i64 %1226
  %1229 = load double, ptr %1228, align 8
  %1230 = load ptr, ptr %74, align 8
  %1231 = getelementptr inbounds double, ptr %1230, i64 %1226
  %1232 = load double, ptr %1231, align 8
  %1233 = fsub double %1229, %1232
  %1234 = load ptr, ptr %139, align 8
  %1235 = getelementptr inbounds double, ptr %1234, i64 %1226
  %1236 = load double, ptr %1235, align 8
  %1237 = fmul double %494, %1236
  %1238 = fsub double %1237, %1233
  %1239 = getelementptr inbounds double, ptr %1145, i64 %1226
  store double %1233, ptr %1239, align 8
  %1240 = getelementptr inbounds double, ptr %1215, i64 %1226
  store double %1238, ptr %1240, align 8
  %1241 = fsub double %1233, %1238
  %1242 = getelementptr inbounds double, ptr %1144, i64 %1226
  %1243 = load double, ptr %1242, align 8
  %1244 = fmul double %494, %1243
  %1245 = fsub double %1241, %1244
  %1246 = getelementptr inbounds double, ptr %1217, i64 %1226
  store double %1245, ptr %1246, align 8
  %1247 = add nuw nsw i64 %1226, 1
  %1248 = load ptr, ptr %73, align 8
  %1249 = getelementptr inbounds i8, ptr %1248, i64 8
  %1250 = load i64, ptr %1249, align 8
  %1251 = icmp slt i64 %1247, %1250
  br i1 %1251, label %1225, label %1218, !llvm.loop !25

1252:                                             ; preds = %1218, %1252
  %1253 = phi i64 [ %1274, %1252 ], [ 3, %1218 ]
  %1254 = mul nsw i64 %1253, %1141
  %1255 = getelementptr inbounds double, ptr %1145, i64 %1254
  %1256 = load ptr, ptr %151, align 8
  %1257 = load ptr, ptr %152, align 8
  %1258 = getelementptr i64, ptr %1257, i64 %1146
  %1259 = getelementptr i64, ptr %1258, i64 %1220
  %1260 = getelementptr i64, ptr %1259, i64 %1221
  %1261 = getelementptr i64, ptr %1260, i64 %1253
  %1262 = getelementptr i8, ptr %1261, i64 -24
  %1263 = load i64, ptr %1262, align 8
  %1264 = getelementptr i8, ptr %1261, i64 -16
  %1265 = load i64, ptr %1264, align 8
  %1266 = xor i64 %1263, -1
  %1267 = add i64 %1265, %1266
  %1268 = load ptr, ptr %94, align 8
  %1269 = load ptr, ptr %139, align 8
  %1270 = load ptr, ptr %153, align 8
  %1271 = getelementptr inbounds i64, ptr %1270, i64 %1263
  %1272 = load ptr, ptr %154, align 8
  %1273 = getelementptr inbounds double, ptr %1272, i64 %1263
  tail call fastcc void @combine(ptr noundef %1255, ptr noundef %1256, ptr noundef %1268, ptr noundef %1269, ptr noundef %1271, ptr noundef %1273, i64 noundef %1267, i64 noundef 1, i64 noundef %1139) #8
  %1274 = add nuw nsw i64 %1253, 1
  %1275 = load i64, ptr %1222, align 8
  %1276 = icmp slt i64 %1274, %1275
  br i1 %1276, label %1252, label %1277, !llvm.loop !26

1277:                                             ; preds = %1252, %1218, %1204
  %1278 = phi i64 [ %1207, %1204 ], [ %1206, %1218 ], [ %1206, %1252 ]
  %1279 = icmp eq i64 %1278, 0
  br i1 %1279, label %1283, label %1280

1280:                                             ; preds = %1277
  store i64 3, ptr %426, align 8
  store double %447, ptr %160, align 8
  %1281 = icmp slt i64 %1278, 0
  %1282 = select i1 %1281, i64 -4, i64 2
  br label %1617

1283:                                             ; preds = %1277
  %1284 = load ptr, ptr %75, align 8
  br i1 %1092, label %1285, label %1296

1285:                                             ; preds = %1283
  %1286 = load ptr, ptr %82, align 8
  %1287 = getelementptr inbounds i8, ptr %1286, i64 16
  %1288 = load i64, ptr %1287, align 8
  %1289 = inttoptr i64 %1288 to ptr
  %1290 = tail call i64 %1289(ptr noundef %0, double noundef %447, double noundef %494) #9
  %1291 = icmp eq i64 %1290, -6
  br i1 %1291, label %1292, label %1293

1292:                                             ; preds = %1285
  store double %447, ptr %1284, align 8
  br label %1471

1293:                                             ; preds = %1285
  %1294 = getelementptr inbounds i8, ptr %1284, i64 48
  %1295 = load double, ptr %1294, align 8
  br label %1296

1296:                                             ; preds = %1293, %1283
  %1297 = phi double [ %1295, %1293 ], [ 1.000000e+00, %1283 ]
  %1298 = phi i64 [ %1290, %1293 ], [ 0, %1283 ]
  %1299 = fcmp oeq double %1297, 1.000000e+00
  br i1 %1299, label %1300, label %1302

1300:                                             ; preds = %1296
  %1301 = load double, ptr %1284, align 8
  br label %1305

1302:                                             ; preds = %1296
  %1303 = fmul double %494, %1297
  %1304 = fadd double %447, %1303
  br label %1305

1305:                                             ; preds = %1302, %1300
  %1306 = phi double [ %1301, %1300 ], [ %1304, %1302 ]
  %1307 = icmp eq i64 %1298, -4
  %1308 = select i1 %1307, i64 -4, i64 0
  br i1 %1307, label %1366, label %1309

1309:                                             ; preds = %1305
  %1310 = fcmp olt double %1297, 1.000000e+00
  %1311 = load ptr, ptr %73, align 8
  %1312 = getelementptr inbounds i8, ptr %1311, i64 8
  %1313 = load i64, ptr %1312, align 8
  %1314 = load i64, ptr %83, align 8
  %1315 = load ptr, ptr %78, align 8
  %1316 = load ptr, ptr %77, align 8
  %1317 = getelementptr inbounds i8, ptr %1316, i64 48
  %1318 = load i64, ptr %1317, align 8
  %1319 = icmp slt i64 %1318, %1314
  br i1 %1319, label %1320, label %1362

1320:                                             ; preds = %1309, %1358
  %1321 = phi i64 [ %1359, %1358 ], [ undef, %1309 ]
  %1322 = phi i64 [ %1360, %1358 ], [ %1318, %1309 ]
  %1323 = getelementptr inbounds double, ptr %1315, i64 %1322
  %1324 = load double, ptr %1323, align 8
  %1325 = fcmp olt double %1324, %1306
  %1326 = fcmp oeq double %1324, %1306
  %1327 = and i1 %1310, %1326
  %1328 = or i1 %1325, %1327
  br i1 %1328, label %1329, label %1362

1329:                                             ; preds = %1320
  %1330 = fsub double %1324, %447
  %1331 = fdiv double %1330, %494
  %1332 = mul nsw i64 %1322, %1313
  %1333 = getelementptr inbounds double, ptr %1, i64 %1332
  %1334 = load ptr, ptr %155, align 8
  %1335 = insertelement <8 x double> poison, double %1331, i64 0
  %1336 = shufflevector <8 x double> %1335, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1336, ptr %1334, align 8
  %1337 = load ptr, ptr %74, align 8
  %1338 = load ptr, ptr %140, align 8
  %1339 = load i64, ptr %138, align 8
  %1340 = load ptr, ptr %0, align 8
  %1341 = getelementptr inbounds i8, ptr %1340, i64 24
  %1342 = load i64, ptr %1341, align 8
  %1343 = load ptr, ptr %155, align 8
  %1344 = load ptr, ptr %73, align 8
  %1345 = getelementptr inbounds i8, ptr %1344, i64 16
  %1346 = load i64, ptr %1345, align 8
  tail call fastcc void @nested(ptr noundef %1333, ptr noundef %1337, ptr noundef %1338, i64 noundef %1339, i64 noundef %1342, ptr noundef %1343, i64 noundef %1346) #8
  %1347 = load ptr, ptr %81, align 8
  %1348 = load i64, ptr %1347, align 8
  %1349 = icmp eq i64 %1348, 1
  br i1 %1349, label %1350, label %1358

1350:                                             ; preds = %1329
  %1351 = load double, ptr %1323, align 8
  %1352 = getelementptr inbounds i8, ptr %1347, i64 56
  %1353 = load i64, ptr %1352, align 8
  %1354 = inttoptr i64 %1353 to ptr
  %1355 = tail call i64 %1354(ptr noundef %0, double noundef %1351, ptr noundef %1333, ptr noundef null) #9
  %1356 = icmp eq i64 %1355, 0
  %1357 = select i1 %1356, i64 %1321, i64 %1355
  br i1 %1356, label %1358, label %1366

1358:                                             ; preds = %1350, %1329
  %1359 = phi i64 [ %1357, %1350 ], [ %1321, %1329 ]
  %1360 = add i64 %1322, 1
  %1361 = icmp eq i64 %1360, %1314
  br i1 %1361, label %1362, label %1320, !llvm.loop !27

1362:                                             ; preds = %1358, %1320, %1309
  %1363 = phi i64 [ %1318, %1309 ], [ %1314, %1358 ], [ %1322, %1320 ]
  %1364 = load ptr, ptr %77, align 8
  %1365 = getelementptr inbounds i8, ptr %1364, i64 48
  store i64 %1363, ptr %1365, align 8
  br label %1366

1366:                                             ; preds = %1350, %1362, %1305
  %1367 = phi i64 [ %1308, %1305 ], [ 0, %1362 ], [ %1357, %1350 ]
  %1368 = icmp eq i64 %1367, 0
  %1369 = icmp ne i64 %1298, 0
  %1370 = fcmp olt double %1297, 1.000000e+00
  %1371 = and i1 %1370, %1368
  %1372 = and i1 %1369, %1371
  br i1 %1372, label %1373, label %1410

1373:                                             ; preds = %1366
  %1374 = load ptr, ptr %156, align 8
  %1375 = load ptr, ptr %157, align 8
  %1376 = insertelement <8 x double> poison, double %1297, i64 0
  %1377 = shufflevector <8 x double> %1376, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1377, ptr %1375, align 8
  %1378 = load ptr, ptr %74, align 8
  %1379 = load ptr, ptr %140, align 8
  %1380 = load i64, ptr %138, align 8
  %1381 = load ptr, ptr %0, align 8
  %1382 = getelementptr inbounds i8, ptr %1381, i64 24
  %1383 = load i64, ptr %1382, align 8
  %1384 = load ptr, ptr %157, align 8
  %1385 = load ptr, ptr %73, align 8
  %1386 = getelementptr inbounds i8, ptr %1385, i64 16
  %1387 = load i64, ptr %1386, align 8
  tail call fastcc void @nested(ptr noundef %1374, ptr noundef %1378, ptr noundef %1379, i64 noundef %1380, i64 noundef %1383, ptr noundef %1384, i64 noundef %1387) #8
  %1388 = load i64, ptr %80, align 8
  %1389 = icmp sgt i64 %1388, 0
  br i1 %1389, label %1394, label %1390

1390:                                             ; preds = %1394, %1373
  %1391 = load ptr, ptr %81, align 8
  %1392 = load i64, ptr %1391, align 8
  %1393 = icmp eq i64 %1392, 1
  br i1 %1393, label %1404, label %1410

1394:                                             ; preds = %1373, %1394
  %1395 = phi i64 [ %1401, %1394 ], [ 0, %1373 ]
  %1396 = load ptr, ptr %156, align 8
  %1397 = getelementptr inbounds double, ptr %1396, i64 %1395
  %1398 = load double, ptr %1397, align 8
  %1399 = load ptr, ptr %76, align 8
  %1400 = getelementptr inbounds double, ptr %1399, i64 %1395
  store double %1398, ptr %1400, align 8
  %1401 = add nuw nsw i64 %1395, 1
  %1402 = load i64, ptr %80, align 8
  %1403 = icmp slt i64 %1401, %1402
  br i1 %1403, label %1394, label %1390, !llvm.loop !28

1404:                                             ; preds = %1390
  %1405 = load ptr, ptr %76, align 8
  %1406 = getelementptr inbounds i8, ptr %1391, i64 56
  %1407 = load i64, ptr %1406, align 8
  %1408 = inttoptr i64 %1407 to ptr
  %1409 = tail call i64 %1408(ptr noundef %0, double noundef %1306, ptr noundef %1405, ptr noundef null) #9
  br label %1410

1410:                                             ; preds = %1404, %1390, %1366
  %1411 = phi i64 [ %1409, %1404 ], [ 0, %1390 ], [ %1367, %1366 ]
  %1412 = icmp eq i64 %1411, 0
  br i1 %1412, label %1415, label %1413

1413:                                             ; preds = %1410
  store double %447, ptr %1284, align 8
  %1414 = getelementptr inbounds i8, ptr %1284, i64 8
  store double %494, ptr %1414, align 8
  br label %1471

1415:                                             ; preds = %1410
  br i1 %1299, label %1416, label %1454

1416:                                             ; preds = %1415
  %1417 = load ptr, ptr %76, align 8
  %1418 = load ptr, ptr %73, align 8
  %1419 = getelementptr inbounds i8, ptr %1418, i64 8
  %1420 = load i64, ptr %1419, align 8
  %1421 = load i64, ptr %83, align 8
  %1422 = load ptr, ptr %78, align 8
  %1423 = load ptr, ptr %77, align 8
  %1424 = getelementptr inbounds i8, ptr %1423, i64 48
  %1425 = load i64, ptr %1424, align 8
  %1426 = icmp slt i64 %1425, %1421
  br i1 %1426, label %1427, label %1450

1427:                                             ; preds = %1416
  %1428 = icmp sgt i64 %1420, 0
  br label %1429

1429:                                             ; preds = %1427, %1440
  %1430 = phi i64 [ %1425, %1427 ], [ %1441, %1440 ]
  %1431 = getelementptr inbounds double, ptr %1422, i64 %1430
  %1432 = load double, ptr %1431, align 8
  %1433 = load ptr, ptr %75, align 8
  %1434 = load double, ptr %1433, align 8
  %1435 = fcmp ugt double %1432, %1434
  br i1 %1435, label %1450, label %1436

1436:                                             ; preds = %1429
  br i1 %1428, label %1437, label %1440

1437:                                             ; preds = %1436
  %1438 = mul nsw i64 %1430, %1420
  %1439 = getelementptr double, ptr %1, i64 %1438
  br label %1443

1440:                                             ; preds = %1443, %1436
  %1441 = add i64 %1430, 1
  %1442 = icmp eq i64 %1441, %1421
  br i1 %1442, label %1450, label %1429, !llvm.loop !8

1443:                                             ; preds = %1437, %1443
  %1444 = phi i64 [ 0, %1437 ], [ %1448, %1443 ]
  %1445 = getelementptr inbounds double, ptr %1417, i64 %1444
  %1446 = load double, ptr %1445, align 8
  %1447 = getelementptr double, ptr %1439, i64 %1444
  store double %1446, ptr %1447, align 8
  %1448 = add nuw nsw i64 %1444, 1
  %1449 = icmp eq i64 %1448, %1420
  br i1 %1449, label %1440, label %1443, !llvm.loop !9

1450:                                             ; preds = %1440, %1429, %1416
  %1451 = phi i64 [ %1425, %1416 ], [ %1421, %1440 ], [ %1430, %1429 ]
  %1452 = load ptr, ptr %77, align 8
  %1453 = getelementptr inbounds i8, ptr %1452, i64 48
  store i64 %1451, ptr %1453, align 8
  br label %1454

1454:                                             ; preds = %1450, %1415
  br i1 %1369, label %1455, label %1471

1455:                                             ; preds = %1454
  %1456 = load i64, ptr %80, align 8
  %1457 = icmp sgt i64 %1456, 0
  br i1 %1457, label %1461, label %1458

1458:                                             ; preds = %1461, %1455
  store double %1306, ptr %1284, align 8
  %1459 = getelementptr inbounds i8, ptr %1284, i64 8
  store double 0.000000e+00, ptr %1459, align 8
  %1460 = load ptr, ptr %77, align 8
  store i64 0, ptr %1460, align 8
  br label %1471

1461:                                             ; preds = %1455, %1461
  %1462 = phi i64 [ %1468, %1461 ], [ 0, %1455 ]
  %1463 = load ptr, ptr %76, align 8
  %1464 = getelementptr inbounds double, ptr %1463, i64 %1462
  %1465 = load double, ptr %1464, align 8
  %1466 = load ptr, ptr %74, align 8
  %1467 = getelementptr inbounds double, ptr %1466, i64 %1462
  store double %1465, ptr %1467, align 8
  %1468 = add nuw nsw i64 %1462, 1
  %1469 = load i64, ptr %80, align 8
  %1470 = icmp slt i64 %1468, %1469
  br i1 %1470, label %1461, label %1458, !llvm.loop !29

1471:                                             ; preds = %1292, %1413, %1454, %1458
  %1472 = phi i64 [ -6, %1292 ], [ %1411, %1413 ], [ %1298, %1458 ], [ %1298, %1454 ]
  %1473 = icmp eq i64 %1472, -6
  br i1 %1473, label %1478, label %1474

1474:                                             ; preds = %1471
  %1475 = icmp ne i64 %1472, 6
  %1476 = select i1 %1475, i1 true, i1 %176
  %1477 = select i1 %1476, i1 true, i1 %183
  br i1 %1477, label %1488, label %1478

1478:                                             ; preds = %1474, %1471
  %1479 = phi i64 [ %1472, %1474 ], [ 2, %1471 ]
  %1480 = load i64, ptr %416, align 8
  %1481 = add nsw i64 %1480, -1
  store i64 %1481, ptr %416, align 8
  %1482 = load ptr, ptr %93, align 8
  %1483 = load i64, ptr %1482, align 8
  %1484 = add nsw i64 %1483, -1
  store i64 %1484, ptr %1482, align 8
  %1485 = load i64, ptr %417, align 8
  %1486 = add nsw i64 %1485, 1
  store i64 %1486, ptr %417, align 8
  store i64 %1479, ptr %436, align 8
  store double 1.000000e+00, ptr %437, align 8
  %1487 = fmul double %494, 2.500000e-01
  br label %1617, !llvm.loop !19

1488:                                             ; preds = %1474
  %1489 = icmp eq i64 %1472, 0
  br i1 %1489, label %1494, label %1490

1490:                                             ; preds = %1488
  %1491 = load ptr, ptr %93, align 8
  %1492 = load i64, ptr %1491, align 8
  %1493 = add nsw i64 %1492, 1
  store i64 %1493, ptr %1491, align 8
  br label %1617

1494:                                             ; preds = %1488, %1131
  br i1 %176, label %1598, label %1495

1495:                                             ; preds = %1494
  %1496 = load double, ptr %428, align 8
  %1497 = fcmp ogt double %876, 1.000000e-10
  %1498 = select i1 %1497, double %876, double 1.000000e-10
  %1499 = load double, ptr %429, align 8
  %1500 = load double, ptr %430, align 8
  %1501 = fneg double %1500
  %1502 = bitcast double %1498 to i64
  %1503 = add nsw i64 %1502, -4604544271217802189
  %1504 = ashr i64 %1503, 52
  %1505 = and i64 %1503, -4503599627370496
  %1506 = sub nsw i64 %1502, %1505
  %1507 = bitcast i64 %1506 to double
  %1508 = fadd double %1507, -1.000000e+00
  %1509 = fadd double %1507, 1.000000e+00
  %1510 = fdiv double %1508, %1509
  %1511 = fmul double %1510, %1510
  %1512 = tail call double @llvm.fma.f64(double %1511, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1513 = tail call double @llvm.fma.f64(double %1512, double %1511, double 0x3FE2776C50EF9BFE)
  %1514 = tail call double @llvm.fma.f64(double %1513, double %1511, double 0x3FEEC709DC3A03FD)
  %1515 = tail call double @llvm.fma.f64(double %1514, double %1511, double 0x40071547652B82FE)
  %1516 = trunc nsw i64 %1504 to i32
  %1517 = sitofp i32 %1516 to double
  %1518 = fmul double %1510, %1515
  %1519 = fadd double %1518, %1517
  %1520 = fmul double %1519, %1501
  %1521 = fcmp ogt double %1520, -1.000000e+03
  %1522 = select i1 %1521, double %1520, double -1.000000e+03
  %1523 = fcmp olt double %1522, 1.000000e+03
  %1524 = select i1 %1523, double %1522, double 1.000000e+03
  %1525 = tail call double @llvm.rint.f64(double %1524)
  %1526 = fsub double %1524, %1525
  %1527 = tail call double @llvm.fma.f64(double %1526, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1528 = tail call double @llvm.fma.f64(double %1527, double %1526, double 0x3F55D87FE78A6730)
  %1529 = tail call double @llvm.fma.f64(double %1528, double %1526, double 0x3F83B2AB6FBA4E77)
  %1530 = tail call double @llvm.fma.f64(double %1529, double %1526, double 0x3FAC6B08D704A0BF)
  %1531 = tail call double @llvm.fma.f64(double %1530, double %1526, double 0x3FCEBFBDFF82C58E)
  %1532 = tail call double @llvm.fma.f64(double %1531, double %1526, double 0x3FE62E42FEFA39EF)
  %1533 = tail call double @llvm.fma.f64(double %1532, double %1526, double 1.000000e+00)
  %1534 = bitcast double %1533 to i64
  %1535 = fptosi double %1525 to i32
  %1536 = sext i32 %1535 to i64
  %1537 = shl nsw i64 %1536, 52
  %1538 = add nsw i64 %1537, %1534
  %1539 = bitcast i64 %1538 to double
  %1540 = fmul double %1499, %1539
  %1541 = load double, ptr %431, align 8
  %1542 = fcmp une double %1541, 0.000000e+00
  br i1 %1542, label %1543, label %1583

1543:                                             ; preds = %1495
  %1544 = load i64, ptr %427, align 8
  %1545 = add nsw i64 %1544, -4604544271217802189
  %1546 = ashr i64 %1545, 52
  %1547 = and i64 %1545, -4503599627370496
  %1548 = sub nsw i64 %1544, %1547
  %1549 = bitcast i64 %1548 to double
  %1550 = fadd double %1549, -1.000000e+00
  %1551 = fadd double %1549, 1.000000e+00
  %1552 = fdiv double %1550, %1551
  %1553 = fmul double %1552, %1552
  %1554 = tail call double @llvm.fma.f64(double %1553, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1555 = tail call double @llvm.fma.f64(double %1554, double %1553, double 0x3FE2776C50EF9BFE)
  %1556 = tail call double @llvm.fma.f64(double %1555, double %1553, double 0x3FEEC709DC3A03FD)
  %1557 = tail call double @llvm.fma.f64(double %1556, double %1553, double 0x40071547652B82FE)
  %1558 = trunc nsw i64 %1546 to i32
  %1559 = sitofp i32 %1558 to double
  %1560 = fmul double %1552, %1557
  %1561 = fadd double %1560, %1559
  %1562 = fmul double %1541, %1561
  %1563 = fcmp ogt double %1562, -1.000000e+03
  %1564 = select i1 %1563, double %1562, double -1.000000e+03
  %1565 = fcmp olt double %1564, 1.000000e+03
  %1566 = select i1 %1565, double %1564, double 1.000000e+03
  %1567 = tail call double @llvm.rint.f64(double %1566)
  %1568 = fsub double %1566, %1567
  %1569 = tail call double @llvm.fma.f64(double %1568, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1570 = tail call double @llvm.fma.f64(double %1569, double %1568, double 0x3F55D87FE78A6730)
  %1571 = tail call double @llvm.fma.f64(double %1570, double %1568, double 0x3F83B2AB6FBA4E77)
  %1572 = tail call double @llvm.fma.f64(double %1571, double %1568, double 0x3FAC6B08D704A0BF)
  %1573 = tail call double @llvm.fma.f64(double %1572, double %1568, double 0x3FCEBFBDFF82C58E)
  %1574 = tail call double @llvm.fma.f64(double %1573, double %1568, double 0x3FE62E42FEFA39EF)
  %1575 = tail call double @llvm.fma.f64(double %1574, double %1568, double 1.000000e+00)
  %1576 = bitcast double %1575 to i64
  %1577 = fptosi double %1567 to i32
  %1578 = sext i32 %1577 to i64
  %1579 = shl nsw i64 %1578, 52
  %1580 = add nsw i64 %1579, %1576
  %1581 = bitcast i64 %1580 to double
  %1582 = fmul double %1540, %1581
  br label %1583

1583:                                             ; preds = %1495, %1543
  %1584 = phi double [ %1582, %1543 ], [ %1540, %1495 ]
  %1585 = load double, ptr %432, align 8
  %1586 = fcmp ogt double %1584, %1585
  %1587 = select i1 %1586, double %1584, double %1585
  %1588 = fcmp olt double %1496, %1587
  %1589 = select i1 %1588, double %1496, double %1587
  %1590 = fmul double %494, %1589
  %1591 = fcmp oeq double %495, %187
  %1592 = fcmp ogt double %448, %1590
  %1593 = select i1 %1591, i1 %1592, i1 false
  %1594 = select i1 %1593, double %448, double %1590
  %1595 = fcmp ogt double %876, 1.000000e-04
  %1596 = select i1 %1595, double %876, double 1.000000e-04
  store double %1596, ptr %427, align 8
  %1597 = load double, ptr %433, align 8
  store double %1597, ptr %428, align 8
  br label %1598

1598:                                             ; preds = %1583, %1494
  %1599 = phi double [ %1594, %1583 ], [ %448, %1494 ]
  br i1 %434, label %1604, label %1600

1600:                                             ; preds = %1604, %1598
  %1601 = load i64, ptr %435, align 8
  %1602 = load i64, ptr %83, align 8
  %1603 = icmp eq i64 %1601, %1602
  br i1 %1603, label %1616, label %1617

1604:                                             ; preds = %1598, %1604
  %1605 = phi i64 [ %1614, %1604 ], [ 0, %1598 ]
  %1606 = getelementptr inbounds double, ptr %161, i64 %1605
  %1607 = load double, ptr %1606, align 8
  %1608 = load ptr, ptr %74, align 8
  %1609 = getelementptr inbounds double, ptr %1608, i64 %1605
  store double %1607, ptr %1609, align 8
  %1610 = getelementptr inbounds double, ptr %191, i64 %1605
  %1611 = load double, ptr %1610, align 8
  %1612 = load ptr, ptr %84, align 8
  %1613 = getelementptr inbounds double, ptr %1612, i64 %1605
  store double %1611, ptr %1613, align 8
  %1614 = add nuw nsw i64 %1605, 1
  %1615 = icmp eq i64 %1614, %170
  br i1 %1615, label %1600, label %1604, !llvm.loop !30

1616:                                             ; preds = %1600
  store double %1599, ptr %193, align 8
  br label %1617

1617:                                             ; preds = %1616, %1600, %1490, %1478, %1280, %944, %943, %864, %674, %501
  %1618 = phi double [ %448, %501 ], [ %448, %674 ], [ %448, %864 ], [ %942, %944 ], [ %942, %943 ], [ %448, %1280 ], [ %1487, %1478 ], [ %448, %1490 ], [ %1599, %1616 ], [ %1599, %1600 ]
  %1619 = phi double [ %447, %501 ], [ %447, %674 ], [ %447, %864 ], [ %447, %944 ], [ %447, %943 ], [ %447, %1280 ], [ %447, %1478 ], [ %447, %1490 ], [ %495, %1616 ], [ %495, %1600 ]
  %1620 = phi i32 [ 1, %501 ], [ 1, %674 ], [ 1, %864 ], [ 3, %944 ], [ 1, %943 ], [ 1, %1280 ], [ 3, %1478 ], [ 1, %1490 ], [ 1, %1616 ], [ 0, %1600 ]
  %1621 = phi i64 [ 2, %501 ], [ -4, %674 ], [ -4, %864 ], [ %446, %944 ], [ 2, %943 ], [ %1282, %1280 ], [ %446, %1478 ], [ %1472, %1490 ], [ 0, %1616 ], [ %446, %1600 ]
  switch i32 %1620, label %1625 [
    i32 0, label %1622
    i32 3, label %1622
  ]

1622:                                             ; preds = %1617, %1617
  %1623 = load i64, ptr %163, align 8
  %1624 = icmp eq i64 %1623, 0
  br i1 %1624, label %442, label %444, !llvm.loop !19

1625:                                             ; preds = %1617, %159, %216, %258, %442, %461, %469
  %1626 = phi i64 [ -1, %159 ], [ %219, %216 ], [ -1, %442 ], [ -5, %461 ], [ 1, %469 ], [ 0, %258 ], [ %1621, %1617 ]
  %1627 = load ptr, ptr %158, align 8
  %1628 = getelementptr inbounds i8, ptr %1627, i64 48
  %1629 = load i64, ptr %1628, align 8
  %1630 = icmp ne i64 %1626, -2
  %1631 = icmp eq i64 %1629, 0
  %1632 = select i1 %1630, i1 true, i1 %1631
  br i1 %1632, label %1640, label %1633

1633:                                             ; preds = %1625
  %1634 = inttoptr i64 %1629 to ptr
  %1635 = tail call i64 %1634(ptr noundef %0) #9
  %1636 = icmp eq i64 %1635, 8
  %1637 = select i1 %1636, i64 8, i64 %1626
  %1638 = icmp eq i64 %1635, 1
  %1639 = zext i1 %1638 to i32
  br label %1640

1640:                                             ; preds = %1625, %1633
  %1641 = phi i64 [ %1626, %1625 ], [ %1637, %1633 ]
  %1642 = phi i32 [ 0, %1625 ], [ %1639, %1633 ]
  %1643 = icmp eq i32 %1642, 0
  br i1 %1643, label %1644, label %159, !llvm.loop !31

1644:                                             ; preds = %1640
  ret i64 %1641
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
  br i1 %55, label %44, label %56, !llvm.loop !32

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
  br i1 %83, label %13, label %12, !llvm.loop !33
}

define internal fastcc void @norm_to(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, i64 noundef %4) unnamed_addr #3 {
  %6 = icmp sgt i64 %4, 0
  br i1 %6, label %7, label %13

7:                                                ; preds = %5
  %8 = load ptr, ptr %3, align 8
  %9 = getelementptr inbounds i8, ptr %3, i64 240
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %3, i64 216
  %12 = load ptr, ptr %11, align 8
  br label %18

13:                                               ; preds = %18, %5
  %14 = phi double [ 0.000000e+00, %5 ], [ %39, %18 ]
  %15 = sitofp i64 %4 to double
  %16 = fdiv double %14, %15
  %17 = tail call double @llvm.sqrt.f64(double %16)
  store double %17, ptr %0, align 8
  ret void

18:                                               ; preds = %7, %18
  %19 = phi double [ 0.000000e+00, %7 ], [ %39, %18 ]
  %20 = phi i64 [ 0, %7 ], [ %40, %18 ]
  %21 = getelementptr inbounds double, ptr %1, i64 %20
  %22 = load double, ptr %21, align 8
  %23 = getelementptr inbounds double, ptr %8, i64 %20
  %24 = load double, ptr %23, align 8
  %25 = getelementptr inbounds double, ptr %2, i64 %20
  %26 = load double, ptr %25, align 8
  %27 = getelementptr inbounds double, ptr %10, i64 %20
  %28 = load double, ptr %27, align 8
  %29 = getelementptr inbounds double, ptr %12, i64 %20
  %30 = load double, ptr %29, align 8
  %31 = tail call double @llvm.fabs.f64(double %24)
  %32 = tail call double @llvm.fabs.f64(double %26)
  %33 = fcmp ogt double %31, %32
  %34 = select i1 %33, double %31, double %32
  %35 = fmul double %34, %30
  %36 = fadd double %28, %35
  %37 = fdiv double %22, %36
  %38 = fmul double %37, %37
  %39 = fadd double %19, %38
  %40 = add nuw nsw i64 %20, 1
  %41 = icmp eq i64 %40, %4
  br i1 %41, label %13, label %18, !llvm.loop !34
}

declare double @llvm.sqrt.f64(double) #4

declare double @llvm.fabs.f64(double) #4

declare double @llvm.fma.f64(double, double, double) #4

declare double @llvm.rint.f64(double) #4

declare double @llvm.ceil.f64(double) #4

define internal fastcc void @combine(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, ptr noundef readonly %4, ptr noundef readonly %5, i64 noundef %6, i64 noundef %7, i64 noundef %8) unnamed_addr #5 {
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
  br i1 %53, label %54, label %28, !llvm.loop !35

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
  br i1 %98, label %72, label %99, !llvm.loop !36

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
  br i1 %108, label %16, label %22, !llvm.loop !37

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
  br i1 %133, label %114, label %120, !llvm.loop !35

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
  br i1 %148, label %134, label %149, !llvm.loop !36

149:                                              ; preds = %134, %114
  %150 = phi <8 x double> [ %118, %114 ], [ %146, %134 ]
  store <8 x double> %150, ptr %111, align 8
  %151 = add nuw nsw i64 %110, 8
  %152 = icmp slt i64 %151, %11
  br i1 %152, label %109, label %153, !llvm.loop !38

153:                                              ; preds = %149, %16
  ret void
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #4

define internal fastcc void @nested(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, i64 noundef %3, i64 noundef %4, ptr noundef readonly %5, i64 noundef %6) unnamed_addr #6 {
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
  br i1 %31, label %20, label %19, !llvm.loop !39

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
  br i1 %43, label %32, label %24, !llvm.loop !40
}

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #7

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind willreturn memory(none) }
attributes #5 = { noinline nounwind }
attributes #6 = { noinline nounwind }
attributes #7 = { nounwind willreturn memory(none) }
attributes #8 = { nounwind }
attributes #9 = { nounwind }
attributes #10 = { nounwind }


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
!19 = distinct !{!19, !5}
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
!36 = distinct !{!36, !4, !5}
!37 = distinct !{!37, !4, !5}
!38 = distinct !{!38, !4, !5}
!39 = distinct !{!39, !4, !5}
!40 = distinct !{!40, !4, !5}
