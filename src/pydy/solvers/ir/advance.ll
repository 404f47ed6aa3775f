; sources e58d954edb829d5f304dc6bd4892e6002b4d9cbc8bd8f7a2474949e830338375
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

159:                                              ; preds = %1646, %72
  %160 = load ptr, ptr %75, align 8
  %161 = load ptr, ptr %76, align 8
  %162 = load ptr, ptr %77, align 8
  %163 = getelementptr inbounds i8, ptr %162, i64 56
  %164 = load i64, ptr %163, align 8
  %165 = icmp eq i64 %164, 0
  br i1 %165, label %1631, label %166

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
  br i1 %196, label %197, label %413

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
  %214 = load ptr, ptr %213, align 8
  %215 = tail call i32 %214(ptr noundef %210, ptr noundef %201, ptr noundef %211, ptr noundef %212, ptr noundef %202) #9
  %216 = icmp eq i32 %215, 0
  br i1 %216, label %221, label %217

217:                                              ; preds = %207
  %218 = getelementptr inbounds i8, ptr %162, i64 72
  store i64 3, ptr %218, align 8
  %219 = icmp slt i32 %215, 0
  %220 = select i1 %219, i64 -4, i64 2
  br label %1631

221:                                              ; preds = %207
  store i64 1, ptr %162, align 8
  %222 = getelementptr inbounds i8, ptr %160, i64 24
  store double 1.000000e-04, ptr %222, align 8
  %223 = getelementptr inbounds i8, ptr %168, i64 40
  %224 = load double, ptr %223, align 8
  %225 = getelementptr inbounds i8, ptr %160, i64 40
  store double %224, ptr %225, align 8
  %226 = load ptr, ptr %74, align 8
  %227 = load ptr, ptr %73, align 8
  %228 = getelementptr inbounds i8, ptr %227, i64 8
  %229 = load i64, ptr %228, align 8
  %230 = load i64, ptr %83, align 8
  %231 = load ptr, ptr %78, align 8
  %232 = load ptr, ptr %77, align 8
  %233 = getelementptr inbounds i8, ptr %232, i64 48
  %234 = load i64, ptr %233, align 8
  %235 = icmp slt i64 %234, %230
  br i1 %235, label %236, label %259

236:                                              ; preds = %221
  %237 = icmp sgt i64 %229, 0
  br label %238

238:                                              ; preds = %236, %249
  %239 = phi i64 [ %234, %236 ], [ %250, %249 ]
  %240 = getelementptr inbounds double, ptr %231, i64 %239
  %241 = load double, ptr %240, align 8
  %242 = load ptr, ptr %75, align 8
  %243 = load double, ptr %242, align 8
  %244 = fcmp ugt double %241, %243
  br i1 %244, label %259, label %245

245:                                              ; preds = %238
  br i1 %237, label %246, label %249

246:                                              ; preds = %245
  %247 = mul nsw i64 %239, %229
  %248 = getelementptr double, ptr %1, i64 %247
  br label %252

249:                                              ; preds = %252, %245
  %250 = add i64 %239, 1
  %251 = icmp eq i64 %250, %230
  br i1 %251, label %259, label %238, !llvm.loop !8

252:                                              ; preds = %246, %252
  %253 = phi i64 [ 0, %246 ], [ %257, %252 ]
  %254 = getelementptr inbounds double, ptr %226, i64 %253
  %255 = load double, ptr %254, align 8
  %256 = getelementptr double, ptr %248, i64 %253
  store double %255, ptr %256, align 8
  %257 = add nuw nsw i64 %253, 1
  %258 = icmp eq i64 %257, %229
  br i1 %258, label %249, label %252, !llvm.loop !9

259:                                              ; preds = %238, %249, %221
  %260 = phi i64 [ %234, %221 ], [ %239, %238 ], [ %230, %249 ]
  %261 = load ptr, ptr %77, align 8
  %262 = getelementptr inbounds i8, ptr %261, i64 48
  store i64 %260, ptr %262, align 8
  %263 = icmp eq i64 %260, %230
  br i1 %263, label %1631, label %264

264:                                              ; preds = %259
  %265 = fcmp oeq double %194, 0.000000e+00
  br i1 %265, label %266, label %413

266:                                              ; preds = %264
  %267 = load ptr, ptr %73, align 8
  %268 = getelementptr inbounds i8, ptr %267, i64 24
  %269 = load i64, ptr %268, align 8
  %270 = load ptr, ptr %75, align 8
  %271 = getelementptr inbounds i8, ptr %270, i64 16
  %272 = load double, ptr %271, align 8
  %273 = load ptr, ptr %74, align 8
  call fastcc void @norm_to(ptr noundef nonnull %4, ptr noundef %273, ptr noundef %273, ptr noundef nonnull %74, i64 noundef %269) #8
  %274 = load double, ptr %4, align 8
  %275 = load ptr, ptr %89, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %275, ptr noundef %273, ptr noundef nonnull %74, i64 noundef %269) #8
  %276 = load double, ptr %5, align 8
  %277 = fcmp uge double %274, 1.000000e-05
  %278 = fcmp uge double %276, 1.000000e-05
  %279 = and i1 %277, %278
  %280 = fmul double %274, 1.000000e-02
  %281 = fdiv double %280, %276
  %282 = select i1 %279, double %281, double 0x3EB0C6F7A0B5ED8D
  %283 = fcmp olt double %272, %282
  %284 = select i1 %283, double %272, double %282
  %285 = load ptr, ptr %73, align 8
  %286 = getelementptr inbounds i8, ptr %285, i64 8
  %287 = load i64, ptr %286, align 8
  %288 = icmp sgt i64 %287, 0
  br i1 %288, label %313, label %289

289:                                              ; preds = %313, %266
  %290 = load ptr, ptr %77, align 8
  %291 = getelementptr inbounds i8, ptr %290, i64 24
  %292 = load i64, ptr %291, align 8
  %293 = add nsw i64 %292, 1
  store i64 %293, ptr %291, align 8
  %294 = fadd double %192, %284
  %295 = load ptr, ptr %91, align 8
  %296 = load ptr, ptr %84, align 8
  %297 = load i64, ptr %80, align 8
  %298 = getelementptr inbounds double, ptr %296, i64 %297
  %299 = load ptr, ptr %85, align 8
  store double %294, ptr %299, align 8
  %300 = load i64, ptr %86, align 8
  %301 = icmp sgt i64 %300, 0
  br i1 %301, label %302, label %303

302:                                              ; preds = %289
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %303

303:                                              ; preds = %289, %302
  %304 = load ptr, ptr %73, align 8
  %305 = load i64, ptr %304, align 8
  %306 = load ptr, ptr %85, align 8
  %307 = load ptr, ptr %87, align 8
  %308 = load ptr, ptr %88, align 8
  %309 = inttoptr i64 %305 to ptr
  %310 = load ptr, ptr %309, align 8
  %311 = tail call i32 %310(ptr noundef %306, ptr noundef %295, ptr noundef %307, ptr noundef %308, ptr noundef %298) #9
  %312 = icmp eq i32 %311, 0
  br i1 %312, label %332, label %330

313:                                              ; preds = %266, %313
  %314 = phi i64 [ %325, %313 ], [ 0, %266 ]
  %315 = load ptr, ptr %74, align 8
  %316 = getelementptr inbounds double, ptr %315, i64 %314
  %317 = load double, ptr %316, align 8
  %318 = load ptr, ptr %84, align 8
  %319 = getelementptr inbounds double, ptr %318, i64 %314
  %320 = load double, ptr %319, align 8
  %321 = fmul double %284, %320
  %322 = fadd double %317, %321
  %323 = load ptr, ptr %90, align 8
  %324 = getelementptr inbounds double, ptr %323, i64 %314
  store double %322, ptr %324, align 8
  %325 = add nuw nsw i64 %314, 1
  %326 = load ptr, ptr %73, align 8
  %327 = getelementptr inbounds i8, ptr %326, i64 8
  %328 = load i64, ptr %327, align 8
  %329 = icmp slt i64 %325, %328
  br i1 %329, label %313, label %289, !llvm.loop !10

330:                                              ; preds = %303
  %331 = fmul double %284, 1.000000e-03
  br label %408

332:                                              ; preds = %303
  %333 = load ptr, ptr %79, align 8
  %334 = load double, ptr %333, align 8
  %335 = load ptr, ptr %89, align 8
  %336 = load i64, ptr %92, align 8
  %337 = getelementptr inbounds double, ptr %335, i64 %336
  %338 = icmp sgt i64 %269, 0
  br i1 %338, label %339, label %348

339:                                              ; preds = %332, %339
  %340 = phi i64 [ %346, %339 ], [ 0, %332 ]
  %341 = getelementptr inbounds double, ptr %337, i64 %340
  %342 = load double, ptr %341, align 8
  %343 = getelementptr inbounds double, ptr %335, i64 %340
  %344 = load double, ptr %343, align 8
  %345 = fsub double %342, %344
  store double %345, ptr %341, align 8
  %346 = add nuw nsw i64 %340, 1
  %347 = icmp eq i64 %346, %269
  br i1 %347, label %348, label %339, !llvm.loop !11

348:                                              ; preds = %339, %332
  %349 = load ptr, ptr %74, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %337, ptr noundef %349, ptr noundef nonnull %74, i64 noundef %269) #8
  %350 = load double, ptr %6, align 8
  %351 = fdiv double %350, %284
  %352 = fcmp ogt double %276, %351
  %353 = select i1 %352, double %276, double %351
  %354 = fcmp ule double %353, 1.000000e-15
  %355 = fdiv double 1.000000e-02, %353
  %356 = select i1 %354, double 1.000000e+13, double %355
  %357 = bitcast double %356 to i64
  %358 = add nsw i64 %357, -4604544271217802189
  %359 = ashr i64 %358, 52
  %360 = and i64 %358, -4503599627370496
  %361 = sub nsw i64 %357, %360
  %362 = bitcast i64 %361 to double
  %363 = fadd double %362, -1.000000e+00
  %364 = fadd double %362, 1.000000e+00
  %365 = fdiv double %363, %364
  %366 = fmul double %365, %365
  %367 = tail call double @llvm.fma.f64(double %366, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %368 = tail call double @llvm.fma.f64(double %367, double %366, double 0x3FE2776C50EF9BFE)
  %369 = tail call double @llvm.fma.f64(double %368, double %366, double 0x3FEEC709DC3A03FD)
  %370 = tail call double @llvm.fma.f64(double %369, double %366, double 0x40071547652B82FE)
  %371 = trunc nsw i64 %359 to i32
  %372 = sitofp i32 %371 to double
  %373 = fmul double %365, %370
  %374 = fadd double %373, %372
  %375 = fmul double %334, %374
  %376 = fcmp ogt double %375, -1.000000e+03
  %377 = select i1 %376, double %375, double -1.000000e+03
  %378 = fcmp olt double %377, 1.000000e+03
  %379 = select i1 %378, double %377, double 1.000000e+03
  %380 = tail call double @llvm.rint.f64(double %379)
  %381 = fsub double %379, %380
  %382 = tail call double @llvm.fma.f64(double %381, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %383 = tail call double @llvm.fma.f64(double %382, double %381, double 0x3F55D87FE78A6730)
  %384 = tail call double @llvm.fma.f64(double %383, double %381, double 0x3F83B2AB6FBA4E77)
  %385 = tail call double @llvm.fma.f64(double %384, double %381, double 0x3FAC6B08D704A0BF)
  %386 = tail call double @llvm.fma.f64(double %385, double %381, double 0x3FCEBFBDFF82C58E)
  %387 = tail call double @llvm.fma.f64(double %386, double %381, double 0x3FE62E42FEFA39EF)
  %388 = tail call double @llvm.fma.f64(double %387, double %381, double 1.000000e+00)
  %389 = bitcast double %388 to i64
  %390 = fptosi double %380 to i32
  %391 = sext i32 %390 to i64
  %392 = shl nsw i64 %391, 52
  %393 = add nsw i64 %392, %389
  %394 = bitcast i64 %393 to double
  %395 = fmul double %284, 1.000000e-03
  %396 = fcmp olt double %395, 0x3EB0C6F7A0B5ED8D
  %397 = select i1 %396, double 0x3EB0C6F7A0B5ED8D, double %395
  %398 = fmul double %284, 1.000000e+02
  %399 = select i1 %354, double %397, double %394
  %400 = fcmp olt double %398, %399
  %401 = select i1 %400, double %398, double %399
  %402 = tail call double @llvm.fabs.f64(double %192)
  %403 = fmul double %402, 0x3D30000000000000
  %404 = fcmp ogt double %403, %401
  %405 = select i1 %404, double %403, double %401
  %406 = fcmp olt double %272, %405
  %407 = select i1 %406, double %272, double %405
  br label %408

408:                                              ; preds = %330, %348
  %409 = phi double [ %331, %330 ], [ %407, %348 ]
  %410 = tail call i1 @llvm.is.fpclass.f64(double %409, i32 639)
  br i1 %410, label %411, label %413

411:                                              ; preds = %408
  %412 = getelementptr inbounds i8, ptr %162, i64 72
  store i64 4, ptr %412, align 8
  br label %413

413:                                              ; preds = %411, %408, %264, %166
  %414 = phi double [ %409, %408 ], [ %409, %411 ], [ %194, %264 ], [ %194, %166 ]
  %415 = load i64, ptr %163, align 8
  %416 = icmp eq i64 %415, 0
  br i1 %416, label %444, label %417

417:                                              ; preds = %413
  %418 = getelementptr inbounds i8, ptr %162, i64 8
  %419 = getelementptr inbounds i8, ptr %162, i64 16
  %420 = getelementptr inbounds i8, ptr %162, i64 64
  %421 = getelementptr inbounds i8, ptr %162, i64 48
  %422 = getelementptr inbounds i8, ptr %160, i64 16
  %423 = getelementptr inbounds i8, ptr %162, i64 24
  %424 = icmp sgt i64 %170, 0
  %425 = select i1 %173, i1 %179, i1 false
  %426 = getelementptr inbounds i8, ptr %160, i64 32
  %427 = getelementptr inbounds i8, ptr %162, i64 48
  %428 = getelementptr inbounds i8, ptr %162, i64 72
  %429 = getelementptr inbounds i8, ptr %160, i64 24
  %430 = getelementptr inbounds i8, ptr %160, i64 40
  %431 = getelementptr inbounds i8, ptr %168, i64 24
  %432 = getelementptr inbounds i8, ptr %168, i64 8
  %433 = getelementptr inbounds i8, ptr %168, i64 16
  %434 = getelementptr inbounds i8, ptr %168, i64 32
  %435 = getelementptr inbounds i8, ptr %168, i64 40
  %436 = icmp sgt i64 %170, 0
  %437 = getelementptr inbounds i8, ptr %162, i64 48
  %438 = getelementptr inbounds i8, ptr %162, i64 72
  %439 = getelementptr inbounds i8, ptr %160, i64 40
  %440 = getelementptr inbounds i8, ptr %162, i64 72
  %441 = getelementptr inbounds i8, ptr %168, i64 24
  %442 = getelementptr inbounds i8, ptr %168, i64 32
  %443 = getelementptr inbounds i8, ptr %160, i64 40
  br label %446

444:                                              ; preds = %1628, %413
  %445 = phi double [ %414, %413 ], [ %1624, %1628 ]
  store double %445, ptr %193, align 8
  br label %1631

446:                                              ; preds = %417, %1628
  %447 = phi i64 [ %415, %417 ], [ %1629, %1628 ]
  %448 = phi i64 [ undef, %417 ], [ %1627, %1628 ]
  %449 = phi double [ %192, %417 ], [ %1625, %1628 ]
  %450 = phi double [ %414, %417 ], [ %1624, %1628 ]
  %451 = load ptr, ptr %93, align 8
  %452 = getelementptr inbounds i8, ptr %451, i64 8
  %453 = load i64, ptr %452, align 8
  %454 = icmp sgt i64 %453, 0
  br i1 %454, label %455, label %460

455:                                              ; preds = %446
  %456 = load i64, ptr %451, align 8
  %457 = add nsw i64 %456, 3
  %458 = icmp slt i64 %453, %457
  %459 = zext i1 %458 to i32
  br label %460

460:                                              ; preds = %446, %455
  %461 = phi i32 [ 0, %446 ], [ %459, %455 ]
  %462 = icmp eq i32 %461, 0
  br i1 %462, label %464, label %463

463:                                              ; preds = %460
  store double %450, ptr %193, align 8
  br label %1631

464:                                              ; preds = %460
  %465 = add nsw i64 %447, -1
  store i64 %465, ptr %163, align 8
  %466 = load i64, ptr %418, align 8
  %467 = load i64, ptr %419, align 8
  %468 = add nsw i64 %467, %466
  %469 = load i64, ptr %420, align 8
  %470 = icmp slt i64 %468, %469
  br i1 %470, label %472, label %471

471:                                              ; preds = %464
  store double %450, ptr %193, align 8
  br label %1631

472:                                              ; preds = %464
  br i1 %176, label %473, label %477

473:                                              ; preds = %472
  %474 = load i64, ptr %421, align 8
  %475 = getelementptr inbounds double, ptr %167, i64 %474
  %476 = load double, ptr %475, align 8
  br label %477

477:                                              ; preds = %473, %472
  %478 = phi double [ %476, %473 ], [ %187, %472 ]
  br i1 %176, label %483, label %479

479:                                              ; preds = %477
  %480 = load double, ptr %422, align 8
  %481 = fcmp olt double %450, %480
  %482 = select i1 %481, double %450, double %480
  br label %489

483:                                              ; preds = %477
  %484 = fsub double %478, %449
  %485 = fdiv double %484, %450
  %486 = fmul double %485, 0x3FEFFFFFFFFFDCD1
  %487 = tail call double @llvm.ceil.f64(double %486)
  %488 = fdiv double %484, %487
  br label %489

489:                                              ; preds = %483, %479
  %490 = phi double [ %482, %479 ], [ %488, %483 ]
  %491 = fadd double %449, %490
  %492 = fmul double %490, 1.000000e-03
  %493 = fsub double %478, %492
  %494 = fcmp ule double %491, %493
  %495 = select i1 %494, double %491, double %478
  %496 = fsub double %495, %449
  %497 = fmul double %496, 6.250000e-02
  %498 = fadd double %449, %497
  %499 = fcmp ule double %498, %449
  %500 = fcmp une double %495, %478
  %501 = and i1 %500, %499
  br i1 %501, label %502, label %503

502:                                              ; preds = %489
  store double %496, ptr %193, align 8
  br label %1623

503:                                              ; preds = %489
  %504 = load ptr, ptr %0, align 8
  %505 = load i64, ptr %504, align 8
  %506 = load ptr, ptr %94, align 8
  %507 = insertelement <8 x double> poison, double %496, i64 0
  %508 = shufflevector <8 x double> %507, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %508, ptr %506, align 8
  %509 = icmp sgt i64 %505, 1
  br i1 %509, label %514, label %599

510:                                              ; preds = %587
  %511 = add nuw nsw i64 %517, 1
  %512 = icmp slt i64 %511, %505
  %513 = icmp eq i64 %511, %505
  br i1 %513, label %599, label %514, !llvm.loop !12

514:                                              ; preds = %503, %510
  %515 = phi i1 [ %512, %510 ], [ %509, %503 ]
  %516 = phi i64 [ %598, %510 ], [ undef, %503 ]
  %517 = phi i64 [ %511, %510 ], [ 1, %503 ]
  %518 = load ptr, ptr %95, align 8
  %519 = load ptr, ptr %74, align 8
  %520 = load ptr, ptr %73, align 8
  %521 = getelementptr inbounds i8, ptr %520, i64 16
  %522 = load i64, ptr %521, align 8
  %523 = icmp sgt i64 %522, 1
  %524 = zext i1 %523 to i64
  %525 = load ptr, ptr %96, align 8
  %526 = getelementptr inbounds i64, ptr %525, i64 %517
  %527 = load i64, ptr %526, align 8
  %528 = getelementptr i8, ptr %526, i64 8
  %529 = load i64, ptr %528, align 8
  %530 = xor i64 %527, -1
  %531 = add i64 %529, %530
  %532 = load ptr, ptr %94, align 8
  %533 = load ptr, ptr %97, align 8
  %534 = load ptr, ptr %98, align 8
  %535 = getelementptr inbounds i64, ptr %534, i64 %527
  %536 = load ptr, ptr %99, align 8
  %537 = getelementptr inbounds double, ptr %536, i64 %527
  tail call fastcc void @combine(ptr noundef %518, ptr noundef %519, ptr noundef %532, ptr noundef %533, ptr noundef %535, ptr noundef %537, i64 noundef %531, i64 noundef %524, i64 noundef %522) #8
  %538 = icmp eq i64 %522, 1
  br i1 %538, label %539, label %570

539:                                              ; preds = %514
  %540 = load ptr, ptr %96, align 8
  %541 = getelementptr i64, ptr %540, i64 %517
  %542 = getelementptr i8, ptr %541, i64 8
  %543 = load i64, ptr %542, align 8
  %544 = add nsw i64 %543, -1
  %545 = load ptr, ptr %99, align 8
  %546 = getelementptr inbounds double, ptr %545, i64 %544
  %547 = load double, ptr %546, align 8
  %548 = fmul double %496, %547
  %549 = load ptr, ptr %97, align 8
  %550 = load ptr, ptr %98, align 8
  %551 = getelementptr inbounds i64, ptr %550, i64 %544
  %552 = load i64, ptr %551, align 8
  %553 = getelementptr inbounds double, ptr %549, i64 %552
  %554 = load ptr, ptr %73, align 8
  %555 = getelementptr inbounds i8, ptr %554, i64 8
  %556 = load i64, ptr %555, align 8
  %557 = icmp sgt i64 %556, 0
  br i1 %557, label %558, label %570

558:                                              ; preds = %539, %558
  %559 = phi i64 [ %565, %558 ], [ 0, %539 ]
  %560 = getelementptr inbounds double, ptr %553, i64 %559
  %561 = load double, ptr %560, align 8
  %562 = getelementptr inbounds double, ptr %518, i64 %559
  %563 = load double, ptr %562, align 8
  %564 = tail call double @llvm.fma.f64(double %548, double %561, double %563)
  store double %564, ptr %562, align 8
  %565 = add nuw nsw i64 %559, 1
  %566 = load ptr, ptr %73, align 8
  %567 = getelementptr inbounds i8, ptr %566, i64 8
  %568 = load i64, ptr %567, align 8
  %569 = icmp slt i64 %565, %568
  br i1 %569, label %558, label %570, !llvm.loop !13

570:                                              ; preds = %558, %539, %514
  %571 = load ptr, ptr %97, align 8
  %572 = load i64, ptr %100, align 8
  %573 = mul nsw i64 %572, %517
  %574 = getelementptr inbounds double, ptr %571, i64 %573
  %575 = load i64, ptr %423, align 8
  %576 = add nsw i64 %575, 1
  store i64 %576, ptr %423, align 8
  %577 = load ptr, ptr %101, align 8
  %578 = getelementptr inbounds double, ptr %577, i64 %517
  %579 = load double, ptr %578, align 8
  %580 = fmul double %496, %579
  %581 = fadd double %449, %580
  %582 = load ptr, ptr %95, align 8
  %583 = load ptr, ptr %102, align 8
  store double %581, ptr %583, align 8
  %584 = load i64, ptr %103, align 8
  %585 = icmp sgt i64 %584, 0
  br i1 %585, label %586, label %587

586:                                              ; preds = %570
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %587

587:                                              ; preds = %570, %586
  %588 = load ptr, ptr %73, align 8
  %589 = load i64, ptr %588, align 8
  %590 = load ptr, ptr %102, align 8
  %591 = load ptr, ptr %104, align 8
  %592 = load ptr, ptr %105, align 8
  %593 = inttoptr i64 %589 to ptr
  %594 = load ptr, ptr %593, align 8
  %595 = tail call i32 %594(ptr noundef %590, ptr noundef %582, ptr noundef %591, ptr noundef %592, ptr noundef %574) #9
  %596 = sext i32 %595 to i64
  %597 = icmp eq i32 %595, 0
  %598 = select i1 %597, i64 %516, i64 %596
  br i1 %597, label %510, label %599

599:                                              ; preds = %510, %587, %503
  %600 = phi i1 [ %509, %503 ], [ %512, %510 ], [ %515, %587 ]
  %601 = phi i64 [ 0, %503 ], [ %596, %587 ], [ %596, %510 ]
  %602 = phi i64 [ undef, %503 ], [ %598, %587 ], [ %598, %510 ]
  br i1 %600, label %656, label %603

603:                                              ; preds = %599
  %604 = load ptr, ptr %106, align 8
  %605 = load ptr, ptr %74, align 8
  %606 = load ptr, ptr %73, align 8
  %607 = getelementptr inbounds i8, ptr %606, i64 16
  %608 = load i64, ptr %607, align 8
  %609 = icmp sgt i64 %608, 1
  %610 = zext i1 %609 to i64
  %611 = load ptr, ptr %107, align 8
  %612 = getelementptr inbounds i64, ptr %611, i64 %505
  %613 = load i64, ptr %612, align 8
  %614 = getelementptr i8, ptr %612, i64 8
  %615 = load i64, ptr %614, align 8
  %616 = xor i64 %613, -1
  %617 = add i64 %615, %616
  %618 = load ptr, ptr %94, align 8
  %619 = load ptr, ptr %108, align 8
  %620 = load ptr, ptr %109, align 8
  %621 = getelementptr inbounds i64, ptr %620, i64 %613
  %622 = load ptr, ptr %110, align 8
  %623 = getelementptr inbounds double, ptr %622, i64 %613
  tail call fastcc void @combine(ptr noundef %604, ptr noundef %605, ptr noundef %618, ptr noundef %619, ptr noundef %621, ptr noundef %623, i64 noundef %617, i64 noundef %610, i64 noundef %608) #8
  %624 = icmp eq i64 %608, 1
  br i1 %624, label %625, label %656

625:                                              ; preds = %603
  %626 = load ptr, ptr %107, align 8
  %627 = getelementptr i64, ptr %626, i64 %505
  %628 = getelementptr i8, ptr %627, i64 8
  %629 = load i64, ptr %628, align 8
  %630 = add nsw i64 %629, -1
  %631 = load ptr, ptr %110, align 8
  %632 = getelementptr inbounds double, ptr %631, i64 %630
  %633 = load double, ptr %632, align 8
  %634 = fmul double %496, %633
  %635 = load ptr, ptr %108, align 8
  %636 = load ptr, ptr %109, align 8
  %637 = getelementptr inbounds i64, ptr %636, i64 %630
  %638 = load i64, ptr %637, align 8
  %639 = getelementptr inbounds double, ptr %635, i64 %638
  %640 = load ptr, ptr %73, align 8
  %641 = getelementptr inbounds i8, ptr %640, i64 8
  %642 = load i64, ptr %641, align 8
  %643 = icmp sgt i64 %642, 0
  br i1 %643, label %644, label %656

644:                                              ; preds = %625, %644
  %645 = phi i64 [ %651, %644 ], [ 0, %625 ]
  %646 = getelementptr inbounds double, ptr %639, i64 %645
  %647 = load double, ptr %646, align 8
  %648 = getelementptr inbounds double, ptr %604, i64 %645
  %649 = load double, ptr %648, align 8
  %650 = tail call double @llvm.fma.f64(double %634, double %647, double %649)
  store double %650, ptr %648, align 8
  %651 = add nuw nsw i64 %645, 1
  %652 = load ptr, ptr %73, align 8
  %653 = getelementptr inbounds i8, ptr %652, i64 8
  %654 = load i64, ptr %653, align 8
  %655 = icmp slt i64 %651, %654
  br i1 %655, label %644, label %656, !llvm.loop !13

656:                                              ; preds = %644, %625, %603, %599
  %657 = phi i64 [ %602, %599 ], [ %601, %603 ], [ %601, %625 ], [ %601, %644 ]
  %658 = icmp eq i64 %657, 0
  %659 = select i1 %658, i1 %179, i1 false
  br i1 %659, label %660, label %677

660:                                              ; preds = %656
  %661 = load i64, ptr %423, align 8
  %662 = add nsw i64 %661, 1
  store i64 %662, ptr %423, align 8
  %663 = load ptr, ptr %111, align 8
  store double %495, ptr %663, align 8
  %664 = load i64, ptr %112, align 8
  %665 = icmp sgt i64 %664, 0
  br i1 %665, label %666, label %667

666:                                              ; preds = %660
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %667

667:                                              ; preds = %660, %666
  %668 = load ptr, ptr %73, align 8
  %669 = load i64, ptr %668, align 8
  %670 = load ptr, ptr %111, align 8
  %671 = load ptr, ptr %113, align 8
  %672 = load ptr, ptr %114, align 8
  %673 = inttoptr i64 %669 to ptr
  %674 = load ptr, ptr %673, align 8
  %675 = tail call i32 %674(ptr noundef %670, ptr noundef %161, ptr noundef %671, ptr noundef %672, ptr noundef %191) #9
  %676 = sext i32 %675 to i64
  br label %677

677:                                              ; preds = %667, %656
  %678 = phi i64 [ %676, %667 ], [ %657, %656 ]
  %679 = icmp slt i64 %678, 0
  br i1 %679, label %1623, label %680

680:                                              ; preds = %677
  %681 = icmp eq i64 %678, 0
  br i1 %681, label %682, label %878

682:                                              ; preds = %680
  br i1 %176, label %683, label %684

683:                                              ; preds = %682
  br i1 %424, label %833, label %842

684:                                              ; preds = %682
  %685 = load ptr, ptr %73, align 8
  %686 = load ptr, ptr %0, align 8
  %687 = getelementptr inbounds i8, ptr %685, i64 24
  %688 = load i64, ptr %687, align 8
  %689 = getelementptr inbounds i8, ptr %686, i64 8
  %690 = load i64, ptr %689, align 8
  %691 = load ptr, ptr %115, align 8
  %692 = load i64, ptr %116, align 8
  %693 = getelementptr inbounds double, ptr %691, i64 %692
  %694 = icmp sgt i64 %690, 0
  br i1 %694, label %695, label %697

695:                                              ; preds = %684
  %696 = getelementptr inbounds i8, ptr %685, i64 32
  br label %705

697:                                              ; preds = %705, %684
  %698 = icmp sgt i64 %688, 0
  br i1 %698, label %699, label %731

699:                                              ; preds = %697
  %700 = load ptr, ptr %74, align 8
  %701 = load ptr, ptr %122, align 8
  %702 = load ptr, ptr %123, align 8
  %703 = load ptr, ptr %124, align 8
  %704 = load ptr, ptr %115, align 8
  br label %789

705:                                              ; preds = %695, %705
  %706 = phi i64 [ 0, %695 ], [ %729, %705 ]
  %707 = load i64, ptr %686, align 8
  %708 = load i64, ptr %696, align 8
  %709 = load ptr, ptr %115, align 8
  %710 = load i64, ptr %116, align 8
  %711 = mul nsw i64 %710, %706
  %712 = getelementptr inbounds double, ptr %709, i64 %711
  %713 = load ptr, ptr %117, align 8
  %714 = load ptr, ptr %118, align 8
  %715 = getelementptr i64, ptr %714, i64 %707
  %716 = getelementptr i8, ptr %715, i64 8
  %717 = getelementptr i64, ptr %716, i64 %706
  %718 = load i64, ptr %717, align 8
  %719 = getelementptr i8, ptr %717, i64 8
  %720 = load i64, ptr %719, align 8
  %721 = xor i64 %718, -1
  %722 = add i64 %720, %721
  %723 = load ptr, ptr %94, align 8
  %724 = load ptr, ptr %119, align 8
  %725 = load ptr, ptr %120, align 8
  %726 = getelementptr inbounds i64, ptr %725, i64 %718
  %727 = load ptr, ptr %121, align 8
  %728 = getelementptr inbounds double, ptr %727, i64 %718
  tail call fastcc void @combine(ptr noundef %712, ptr noundef %713, ptr noundef %723, ptr noundef %724, ptr noundef %726, ptr noundef %728, i64 noundef %722, i64 noundef 1, i64 noundef %708) #8
  %729 = add nuw nsw i64 %706, 1
  %730 = icmp eq i64 %729, %690
  br i1 %730, label %697, label %705, !llvm.loop !14

731:                                              ; preds = %789, %697
  %732 = phi double [ 0.000000e+00, %697 ], [ %817, %789 ]
  %733 = phi double [ 0.000000e+00, %697 ], [ %815, %789 ]
  %734 = load ptr, ptr %125, align 8
  %735 = getelementptr inbounds i8, ptr %685, i64 8
  %736 = load i64, ptr %735, align 8
  %737 = add nsw i64 %736, -3
  %738 = getelementptr i8, ptr %734, i64 8
  %739 = getelementptr i8, ptr %734, i64 16
  %740 = getelementptr i8, ptr %734, i64 24
  %741 = icmp slt i64 %688, %737
  br i1 %741, label %749, label %742

742:                                              ; preds = %749, %731
  %743 = phi double [ 0.000000e+00, %731 ], [ %758, %749 ]
  %744 = phi double [ 0.000000e+00, %731 ], [ %762, %749 ]
  %745 = phi double [ 0.000000e+00, %731 ], [ %766, %749 ]
  %746 = phi double [ 0.000000e+00, %731 ], [ %770, %749 ]
  %747 = phi i64 [ %688, %731 ], [ %771, %749 ]
  %748 = icmp slt i64 %747, %736
  br i1 %748, label %773, label %782

749:                                              ; preds = %731, %749
  %750 = phi i64 [ %771, %749 ], [ %688, %731 ]
  %751 = phi double [ %770, %749 ], [ 0.000000e+00, %731 ]
  %752 = phi double [ %766, %749 ], [ 0.000000e+00, %731 ]
  %753 = phi double [ %762, %749 ], [ 0.000000e+00, %731 ]
  %754 = phi double [ %758, %749 ], [ 0.000000e+00, %731 ]
  %755 = getelementptr inbounds double, ptr %734, i64 %750
  %756 = load double, ptr %755, align 8
  %757 = fmul double %756, 0.000000e+00
  %758 = fadd double %754, %757
  %759 = getelementptr double, ptr %738, i64 %750
  %760 = load double, ptr %759, align 8
  %761 = fmul double %760, 0.000000e+00
  %762 = fadd double %753, %761
  %763 = getelementptr double, ptr %739, i64 %750
  %764 = load double, ptr %763, align 8
  %765 = fmul double %764, 0.000000e+00
  %766 = fadd double %752, %765
  %767 = getelementptr double, ptr %740, i64 %750
  %768 = load double, ptr %767, align 8
  %769 = fmul double %768, 0.000000e+00
  %770 = fadd double %751, %769
  %771 = add nsw i64 %750, 4
  %772 = icmp slt i64 %771, %737
  br i1 %772, label %749, label %742, !llvm.loop !15

773:                                              ; preds = %742, %773
  %774 = phi i64 [ %780, %773 ], [ %747, %742 ]
  %775 = phi double [ %779, %773 ], [ %743, %742 ]
  %776 = getelementptr inbounds double, ptr %734, i64 %774
  %777 = load double, ptr %776, align 8
  %778 = fmul double %777, 0.000000e+00
  %779 = fadd double %775, %778
  %780 = add nsw i64 %774, 1
  %781 = icmp eq i64 %780, %736
  br i1 %781, label %782, label %773, !llvm.loop !16

782:                                              ; preds = %773, %742
  %783 = phi double [ %743, %742 ], [ %779, %773 ]
  %784 = fadd double %744, %783
  %785 = fadd double %745, %746
  %786 = fadd double %785, %784
  %787 = fadd double %733, %786
  %788 = icmp eq i64 %690, 2
  br i1 %788, label %820, label %829

789:                                              ; preds = %699, %789
  %790 = phi double [ 0.000000e+00, %699 ], [ %815, %789 ]
  %791 = phi double [ 0.000000e+00, %699 ], [ %817, %789 ]
  %792 = phi i64 [ 0, %699 ], [ %818, %789 ]
  %793 = getelementptr inbounds double, ptr %700, i64 %792
  %794 = load double, ptr %793, align 8
  %795 = getelementptr inbounds double, ptr %701, i64 %792
  %796 = load double, ptr %795, align 8
  %797 = getelementptr inbounds double, ptr %702, i64 %792
  %798 = load double, ptr %797, align 8
  %799 = getelementptr inbounds double, ptr %703, i64 %792
  %800 = load double, ptr %799, align 8
  %801 = tail call double @llvm.fabs.f64(double %794)
  %802 = tail call double @llvm.fabs.f64(double %796)
  %803 = fcmp ogt double %801, %802
  %804 = select i1 %803, double %801, double %802
  %805 = fmul double %804, %800
  %806 = fadd double %798, %805
  %807 = fdiv double 1.000000e+00, %806
  %808 = getelementptr inbounds double, ptr %704, i64 %792
  %809 = load double, ptr %808, align 8
  %810 = fmul double %809, %807
  %811 = getelementptr inbounds double, ptr %693, i64 %792
  %812 = load double, ptr %811, align 8
  %813 = fmul double %812, %807
  %814 = fmul double %810, %810
  %815 = fadd double %790, %814
  %816 = fmul double %813, %813
  %817 = fadd double %791, %816
  %818 = add nuw nsw i64 %792, 1
  %819 = icmp eq i64 %818, %688
  br i1 %819, label %731, label %789, !llvm.loop !17

820:                                              ; preds = %782
  %821 = fmul double %732, 1.000000e-02
  %822 = fadd double %821, %787
  %823 = sitofp i64 %688 to double
  %824 = fmul double %822, %823
  %825 = tail call double @llvm.sqrt.f64(double %824)
  %826 = fdiv double %787, %825
  %827 = fcmp une double %787, 0.000000e+00
  %828 = select i1 %827, double %826, double 0.000000e+00
  br label %842

829:                                              ; preds = %782
  %830 = sitofp i64 %688 to double
  %831 = fdiv double %787, %830
  %832 = tail call double @llvm.sqrt.f64(double %831)
  br label %842

833:                                              ; preds = %683, %833
  %834 = phi i64 [ %840, %833 ], [ 0, %683 ]
  %835 = phi double [ %839, %833 ], [ 0.000000e+00, %683 ]
  %836 = getelementptr inbounds double, ptr %161, i64 %834
  %837 = load double, ptr %836, align 8
  %838 = fmul double %837, 0.000000e+00
  %839 = fadd double %835, %838
  %840 = add nuw nsw i64 %834, 1
  %841 = icmp eq i64 %840, %170
  br i1 %841, label %842, label %833, !llvm.loop !18

842:                                              ; preds = %833, %683, %829, %820
  %843 = phi double [ %828, %820 ], [ %832, %829 ], [ 0.000000e+00, %683 ], [ %839, %833 ]
  %844 = fcmp uge double %843, 1.000000e+00
  %845 = select i1 %844, i1 true, i1 %425
  br i1 %845, label %878, label %846

846:                                              ; preds = %842
  br i1 %173, label %858, label %847

847:                                              ; preds = %846
  br i1 %176, label %850, label %848

848:                                              ; preds = %847
  %849 = load ptr, ptr %74, align 8
  br label %850

850:                                              ; preds = %848, %847
  %851 = phi ptr [ %849, %848 ], [ null, %847 ]
  %852 = load ptr, ptr %81, align 8
  %853 = getelementptr inbounds i8, ptr %852, i64 56
  %854 = load i64, ptr %853, align 8
  %855 = inttoptr i64 %854 to ptr
  %856 = tail call i64 %855(ptr noundef %0, double noundef %495, ptr noundef %161, ptr noundef %851) #9
  %857 = icmp ne i64 %856, 0
  br label %858

858:                                              ; preds = %850, %846
  %859 = phi i1 [ false, %846 ], [ %857, %850 ]
  br i1 %859, label %878, label %860

860:                                              ; preds = %858
  %861 = load i64, ptr %423, align 8
  %862 = add nsw i64 %861, 1
  store i64 %862, ptr %423, align 8
  %863 = load ptr, ptr %126, align 8
  store double %495, ptr %863, align 8
  %864 = load i64, ptr %127, align 8
  %865 = icmp sgt i64 %864, 0
  br i1 %865, label %866, label %867

866:                                              ; preds = %860
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %867

867:                                              ; preds = %860, %866
  %868 = load ptr, ptr %73, align 8
  %869 = load i64, ptr %868, align 8
  %870 = load ptr, ptr %126, align 8
  %871 = load ptr, ptr %128, align 8
  %872 = load ptr, ptr %129, align 8
  %873 = inttoptr i64 %869 to ptr
  %874 = load ptr, ptr %873, align 8
  %875 = tail call i32 %874(ptr noundef %870, ptr noundef %161, ptr noundef %871, ptr noundef %872, ptr noundef %191) #9
  %876 = sext i32 %875 to i64
  %877 = icmp slt i32 %875, 0
  br i1 %877, label %1623, label %878

878:                                              ; preds = %867, %858, %842, %680
  %879 = phi i64 [ 0, %858 ], [ %876, %867 ], [ 0, %842 ], [ %678, %680 ]
  %880 = phi double [ %843, %858 ], [ %843, %867 ], [ %843, %842 ], [ 0.000000e+00, %680 ]
  %881 = phi i1 [ %859, %858 ], [ %859, %867 ], [ false, %842 ], [ false, %680 ]
  %882 = icmp ne i64 %879, 0
  %883 = fcmp uge double %880, 1.000000e+00
  %884 = or i1 %882, %883
  %885 = or i1 %881, %884
  br i1 %885, label %886, label %949

886:                                              ; preds = %878
  %887 = load i64, ptr %419, align 8
  %888 = add nsw i64 %887, 1
  store i64 %888, ptr %419, align 8
  %889 = or i1 %882, %881
  br i1 %889, label %893, label %890

890:                                              ; preds = %886
  %891 = tail call double @llvm.fabs.f64(double %880)
  %892 = fcmp one double %891, 0x7FF0000000000000
  br label %893

893:                                              ; preds = %890, %886
  %894 = phi i1 [ false, %886 ], [ %892, %890 ]
  %895 = select i1 %894, i64 2, i64 4
  %896 = select i1 %881, i64 6, i64 %895
  %897 = select i1 %882, i64 3, i64 %896
  store i64 %897, ptr %440, align 8
  %898 = fcmp ogt double %880, 1.000000e-10
  %899 = select i1 %898, double %880, double 1.000000e-10
  %900 = load double, ptr %441, align 8
  %901 = load double, ptr %168, align 8
  %902 = fneg double %901
  %903 = bitcast double %899 to i64
  %904 = add nsw i64 %903, -4604544271217802189
  %905 = ashr i64 %904, 52
  %906 = and i64 %904, -4503599627370496
  %907 = sub nsw i64 %903, %906
  %908 = bitcast i64 %907 to double
  %909 = fadd double %908, -1.000000e+00
  %910 = fadd double %908, 1.000000e+00
  %911 = fdiv double %909, %910
  %912 = fmul double %911, %911
  %913 = tail call double @llvm.fma.f64(double %912, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %914 = tail call double @llvm.fma.f64(double %913, double %912, double 0x3FE2776C50EF9BFE)
  %915 = tail call double @llvm.fma.f64(double %914, double %912, double 0x3FEEC709DC3A03FD)
  %916 = tail call double @llvm.fma.f64(double %915, double %912, double 0x40071547652B82FE)
  %917 = trunc nsw i64 %905 to i32
  %918 = sitofp i32 %917 to double
  %919 = fmul double %911, %916
  %920 = fadd double %919, %918
  %921 = fmul double %920, %902
  %922 = fcmp ogt double %921, -1.000000e+03
  %923 = select i1 %922, double %921, double -1.000000e+03
  %924 = fcmp olt double %923, 1.000000e+03
  %925 = select i1 %924, double %923, double 1.000000e+03
  %926 = tail call double @llvm.rint.f64(double %925)
  %927 = fsub double %925, %926
  %928 = tail call double @llvm.fma.f64(double %927, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %929 = tail call double @llvm.fma.f64(double %928, double %927, double 0x3F55D87FE78A6730)
  %930 = tail call double @llvm.fma.f64(double %929, double %927, double 0x3F83B2AB6FBA4E77)
  %931 = tail call double @llvm.fma.f64(double %930, double %927, double 0x3FAC6B08D704A0BF)
  %932 = tail call double @llvm.fma.f64(double %931, double %927, double 0x3FCEBFBDFF82C58E)
  %933 = tail call double @llvm.fma.f64(double %932, double %927, double 0x3FE62E42FEFA39EF)
  %934 = tail call double @llvm.fma.f64(double %933, double %927, double 1.000000e+00)
  %935 = bitcast double %934 to i64
  %936 = fptosi double %926 to i32
  %937 = sext i32 %936 to i64
  %938 = shl nsw i64 %937, 52
  %939 = add nsw i64 %938, %935
  %940 = bitcast i64 %939 to double
  %941 = fmul double %900, %940
  %942 = load double, ptr %442, align 8
  %943 = fcmp ogt double %941, %942
  %944 = select i1 %943, double %941, double %942
  %945 = select i1 %894, double %944, double 2.500000e-01
  %946 = fmul double %496, %945
  br i1 %176, label %947, label %948

947:                                              ; preds = %893
  store double %496, ptr %193, align 8
  br label %1623

948:                                              ; preds = %893
  store double 1.000000e+00, ptr %443, align 8
  br label %1623, !llvm.loop !19

949:                                              ; preds = %878
  %950 = load i64, ptr %418, align 8
  %951 = add nsw i64 %950, 1
  store i64 %951, ptr %418, align 8
  store double %495, ptr %160, align 8
  store double %496, ptr %426, align 8
  %952 = load ptr, ptr %93, align 8
  %953 = getelementptr inbounds i8, ptr %952, i64 8
  %954 = load i64, ptr %953, align 8
  %955 = icmp eq i64 %954, 0
  br i1 %955, label %985, label %956

956:                                              ; preds = %949
  %957 = load i64, ptr %952, align 8
  %958 = load ptr, ptr %73, align 8
  %959 = getelementptr inbounds i8, ptr %958, i64 8
  %960 = load i64, ptr %959, align 8
  %961 = load ptr, ptr %130, align 8
  %962 = load i64, ptr %131, align 8
  %963 = mul nsw i64 %962, %957
  %964 = getelementptr inbounds double, ptr %961, i64 %963
  %965 = getelementptr inbounds double, ptr %964, i64 %962
  store double %449, ptr %964, align 8
  %966 = getelementptr inbounds i8, ptr %964, i64 8
  store double %496, ptr %966, align 8
  store double %495, ptr %965, align 8
  %967 = getelementptr inbounds i8, ptr %965, i64 8
  store double 0.000000e+00, ptr %967, align 8
  %968 = icmp sgt i64 %960, 0
  br i1 %968, label %972, label %969

969:                                              ; preds = %972, %956
  %970 = add nsw i64 %957, 1
  %971 = load ptr, ptr %93, align 8
  store i64 %970, ptr %971, align 8
  br label %985

972:                                              ; preds = %956, %972
  %973 = phi i64 [ %983, %972 ], [ 0, %956 ]
  %974 = load ptr, ptr %74, align 8
  %975 = getelementptr inbounds double, ptr %974, i64 %973
  %976 = load double, ptr %975, align 8
  %977 = add nuw nsw i64 %973, 2
  %978 = getelementptr inbounds double, ptr %964, i64 %977
  store double %976, ptr %978, align 8
  %979 = load ptr, ptr %76, align 8
  %980 = getelementptr inbounds double, ptr %979, i64 %973
  %981 = load double, ptr %980, align 8
  %982 = getelementptr inbounds double, ptr %965, i64 %977
  store double %981, ptr %982, align 8
  %983 = add nuw nsw i64 %973, 1
  %984 = icmp eq i64 %983, %960
  br i1 %984, label %969, label %972, !llvm.loop !20

985:                                              ; preds = %949, %969
  br i1 %183, label %986, label %1096

986:                                              ; preds = %985
  %987 = load ptr, ptr %82, align 8
  %988 = load i64, ptr %80, align 8
  %989 = load ptr, ptr %132, align 8
  %990 = getelementptr inbounds i8, ptr %987, i64 32
  %991 = load i64, ptr %990, align 8
  %992 = getelementptr inbounds double, ptr %989, i64 %991
  %993 = getelementptr inbounds i8, ptr %987, i64 24
  %994 = load i64, ptr %993, align 8
  %995 = icmp eq i64 %994, 0
  br i1 %995, label %1093, label %996

996:                                              ; preds = %986
  %997 = getelementptr inbounds i8, ptr %987, i64 40
  %998 = load i64, ptr %997, align 8
  %999 = icmp sgt i64 %998, 0
  br i1 %999, label %1054, label %1000

1000:                                             ; preds = %1072, %996
  %1001 = load ptr, ptr %133, align 8
  %1002 = load ptr, ptr %82, align 8
  %1003 = getelementptr inbounds i8, ptr %1002, i64 8
  %1004 = load i64, ptr %1003, align 8
  %1005 = load ptr, ptr %134, align 8
  %1006 = load ptr, ptr %132, align 8
  %1007 = getelementptr inbounds i8, ptr %1002, i64 32
  %1008 = load i64, ptr %1007, align 8
  %1009 = getelementptr inbounds i8, ptr %1002, i64 40
  %1010 = load i64, ptr %1009, align 8
  %1011 = getelementptr double, ptr %1006, i64 %1008
  %1012 = getelementptr double, ptr %1011, i64 %1010
  store double %496, ptr %1012, align 8
  %1013 = load ptr, ptr %133, align 8
  store double %449, ptr %1013, align 8
  %1014 = load ptr, ptr %82, align 8
  %1015 = getelementptr inbounds i8, ptr %1014, i64 24
  %1016 = load i64, ptr %1015, align 8
  %1017 = load ptr, ptr %74, align 8
  %1018 = load ptr, ptr %132, align 8
  %1019 = load ptr, ptr %135, align 8
  %1020 = inttoptr i64 %1016 to ptr
  %1021 = load ptr, ptr %1020, align 8
  %1022 = tail call i32 %1021(ptr noundef %1001, ptr noundef %1017, ptr noundef %1018, ptr noundef %1019, ptr noundef %1005) #9
  %1023 = icmp eq i32 %1022, 0
  br i1 %1023, label %1024, label %1093

1024:                                             ; preds = %1000
  %1025 = icmp slt i64 %1004, 1
  br i1 %1025, label %1051, label %1026

1026:                                             ; preds = %1024
  %1027 = load ptr, ptr %136, align 8
  %1028 = getelementptr double, ptr %1005, i64 %1004
  br label %1029

1029:                                             ; preds = %1026, %1047
  %1030 = phi i1 [ %1025, %1026 ], [ %1049, %1047 ]
  %1031 = phi i64 [ 0, %1026 ], [ %1048, %1047 ]
  %1032 = getelementptr inbounds i64, ptr %1027, i64 %1031
  %1033 = load i64, ptr %1032, align 8
  %1034 = and i64 %1033, 2
  %1035 = icmp eq i64 %1034, 0
  br i1 %1035, label %1036, label %1047

1036:                                             ; preds = %1029
  %1037 = getelementptr inbounds double, ptr %1005, i64 %1031
  %1038 = load double, ptr %1037, align 8
  %1039 = load ptr, ptr %137, align 8
  %1040 = getelementptr inbounds i64, ptr %1039, i64 %1031
  %1041 = load i64, ptr %1040, align 8
  %1042 = sitofp i64 %1041 to double
  %1043 = fmul double %1038, %1042
  %1044 = getelementptr double, ptr %1028, i64 %1031
  %1045 = load double, ptr %1044, align 8
  %1046 = fcmp ogt double %1043, %1045
  br i1 %1046, label %1047, label %1051

1047:                                             ; preds = %1036, %1029
  %1048 = add nuw nsw i64 %1031, 1
  %1049 = icmp sge i64 %1048, %1004
  %1050 = icmp eq i64 %1048, %1004
  br i1 %1050, label %1051, label %1029, !llvm.loop !21

1051:                                             ; preds = %1047, %1036, %1024
  %1052 = phi i1 [ %1025, %1024 ], [ %1049, %1047 ], [ %1030, %1036 ]
  %1053 = zext i1 %1052 to i32
  br label %1093

1054:                                             ; preds = %996, %1072
  %1055 = phi i64 [ %1076, %1072 ], [ 0, %996 ]
  %1056 = load ptr, ptr %76, align 8
  %1057 = getelementptr inbounds double, ptr %1056, i64 %1055
  %1058 = load <8 x double>, ptr %1057, align 8
  %1059 = load ptr, ptr %74, align 8
  %1060 = getelementptr inbounds double, ptr %1059, i64 %1055
  %1061 = load <8 x double>, ptr %1060, align 8
  %1062 = fsub <8 x double> %1058, %1061
  %1063 = fneg <8 x double> %1062
  %1064 = fcmp ogt <8 x double> %1062, zeroinitializer
  %1065 = select <8 x i1> %1064, <8 x double> %1062, <8 x double> %1063
  %1066 = load ptr, ptr %0, align 8
  %1067 = load i64, ptr %1066, align 8
  %1068 = icmp slt i64 %1067, 0
  br i1 %1068, label %1072, label %1069

1069:                                             ; preds = %1054
  %1070 = load ptr, ptr %84, align 8
  %1071 = getelementptr double, ptr %1070, i64 %1055
  br label %1079

1072:                                             ; preds = %1079, %1054
  %1073 = phi <8 x double> [ %1065, %1054 ], [ %1090, %1079 ]
  %1074 = getelementptr inbounds double, ptr %992, i64 %1055
  %1075 = fmul <8 x double> %1073, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  store <8 x double> %1075, ptr %1074, align 8
  %1076 = add nuw nsw i64 %1055, 8
  %1077 = load i64, ptr %997, align 8
  %1078 = icmp slt i64 %1076, %1077
  br i1 %1078, label %1054, label %1000, !llvm.loop !22

1079:                                             ; preds = %1069, %1079
  %1080 = phi i64 [ 0, %1069 ], [ %1091, %1079 ]
  %1081 = phi <8 x double> [ %1065, %1069 ], [ %1090, %1079 ]
  %1082 = mul nsw i64 %1080, %988
  %1083 = getelementptr double, ptr %1071, i64 %1082
  %1084 = load <8 x double>, ptr %1083, align 8
  %1085 = fneg <8 x double> %1084
  %1086 = fcmp ogt <8 x double> %1084, zeroinitializer
  %1087 = select <8 x i1> %1086, <8 x double> %1084, <8 x double> %1085
  %1088 = fmul <8 x double> %508, %1087
  %1089 = fcmp ogt <8 x double> %1081, %1088
  %1090 = select <8 x i1> %1089, <8 x double> %1081, <8 x double> %1088
  %1091 = add nuw i64 %1080, 1
  %1092 = icmp eq i64 %1080, %1067
  br i1 %1092, label %1072, label %1079, !llvm.loop !23

1093:                                             ; preds = %1051, %1000, %986
  %1094 = phi i32 [ 0, %986 ], [ 0, %1000 ], [ %1053, %1051 ]
  %1095 = icmp eq i32 %1094, 0
  br label %1096

1096:                                             ; preds = %1093, %985
  %1097 = phi i1 [ false, %985 ], [ %1095, %1093 ]
  br i1 %1097, label %1140, label %1098

1098:                                             ; preds = %1096
  %1099 = load i64, ptr %427, align 8
  %1100 = getelementptr inbounds double, ptr %167, i64 %1099
  %1101 = load double, ptr %1100, align 8
  %1102 = fcmp ult double %1101, %495
  br i1 %1102, label %1140, label %1103

1103:                                             ; preds = %1098
  %1104 = load ptr, ptr %73, align 8
  %1105 = getelementptr inbounds i8, ptr %1104, i64 8
  %1106 = load i64, ptr %1105, align 8
  %1107 = load i64, ptr %83, align 8
  %1108 = load ptr, ptr %78, align 8
  %1109 = load ptr, ptr %77, align 8
  %1110 = getelementptr inbounds i8, ptr %1109, i64 48
  %1111 = load i64, ptr %1110, align 8
  %1112 = icmp slt i64 %1111, %1107
  br i1 %1112, label %1113, label %1136

1113:                                             ; preds = %1103
  %1114 = icmp sgt i64 %1106, 0
  br label %1115

1115:                                             ; preds = %1113, %1126
  %1116 = phi i64 [ %1111, %1113 ], [ %1127, %1126 ]
  %1117 = getelementptr inbounds double, ptr %1108, i64 %1116
  %1118 = load double, ptr %1117, align 8
  %1119 = load ptr, ptr %75, align 8
  %1120 = load double, ptr %1119, align 8
  %1121 = fcmp ugt double %1118, %1120
  br i1 %1121, label %1136, label %1122

1122:                                             ; preds = %1115
  br i1 %1114, label %1123, label %1126

1123:                                             ; preds = %1122
  %1124 = mul nsw i64 %1116, %1106
  %1125 = getelementptr double, ptr %1, i64 %1124
  br label %1129

1126:                                             ; preds = %1129, %1122
  %1127 = add i64 %1116, 1
  %1128 = icmp eq i64 %1127, %1107
  br i1 %1128, label %1136, label %1115, !llvm.loop !8

1129:                                             ; preds = %1123, %1129
  %1130 = phi i64 [ 0, %1123 ], [ %1134, %1129 ]
  %1131 = getelementptr inbounds double, ptr %161, i64 %1130
  %1132 = load double, ptr %1131, align 8
  %1133 = getelementptr double, ptr %1125, i64 %1130
  store double %1132, ptr %1133, align 8
  %1134 = add nuw nsw i64 %1130, 1
  %1135 = icmp eq i64 %1134, %1106
  br i1 %1135, label %1126, label %1129, !llvm.loop !9

1136:                                             ; preds = %1115, %1126, %1103
  %1137 = phi i64 [ %1111, %1103 ], [ %1116, %1115 ], [ %1107, %1126 ]
  %1138 = load ptr, ptr %77, align 8
  %1139 = getelementptr inbounds i8, ptr %1138, i64 48
  store i64 %1137, ptr %1139, align 8
  br label %1500

1140:                                             ; preds = %1098, %1096
  %1141 = load ptr, ptr %0, align 8
  %1142 = load ptr, ptr %73, align 8
  %1143 = getelementptr inbounds i8, ptr %1142, i64 16
  %1144 = load i64, ptr %1143, align 8
  %1145 = load i64, ptr %1141, align 8
  %1146 = load i64, ptr %138, align 8
  %1147 = load ptr, ptr %139, align 8
  %1148 = mul nsw i64 %1146, %1145
  %1149 = getelementptr inbounds double, ptr %1147, i64 %1148
  %1150 = load ptr, ptr %140, align 8
  %1151 = add nsw i64 %1145, 1
  %1152 = getelementptr inbounds i8, ptr %1141, i64 16
  %1153 = load i64, ptr %1152, align 8
  %1154 = icmp sgt i64 %1153, 0
  br i1 %1154, label %1155, label %1210

1155:                                             ; preds = %1140
  %1156 = getelementptr inbounds i8, ptr %1141, i64 8
  br label %1162

1157:                                             ; preds = %1198
  %1158 = add nsw i64 %1165, 1
  %1159 = load i64, ptr %1152, align 8
  %1160 = add nsw i64 %1159, %1151
  %1161 = icmp slt i64 %1158, %1160
  br i1 %1161, label %1162, label %1210, !llvm.loop !24

1162:                                             ; preds = %1155, %1157
  %1163 = phi i1 [ %1154, %1155 ], [ %1161, %1157 ]
  %1164 = phi i64 [ undef, %1155 ], [ %1209, %1157 ]
  %1165 = phi i64 [ %1151, %1155 ], [ %1158, %1157 ]
  %1166 = load i64, ptr %1156, align 8
  %1167 = load ptr, ptr %141, align 8
  %1168 = load ptr, ptr %74, align 8
  %1169 = load ptr, ptr %142, align 8
  %1170 = getelementptr i64, ptr %1169, i64 %1165
  %1171 = getelementptr i64, ptr %1170, i64 %1166
  %1172 = load i64, ptr %1171, align 8
  %1173 = getelementptr i8, ptr %1171, i64 8
  %1174 = load i64, ptr %1173, align 8
  %1175 = xor i64 %1172, -1
  %1176 = add i64 %1174, %1175
  %1177 = load ptr, ptr %94, align 8
  %1178 = load ptr, ptr %139, align 8
  %1179 = load ptr, ptr %143, align 8
  %1180 = getelementptr inbounds i64, ptr %1179, i64 %1172
  %1181 = load ptr, ptr %144, align 8
  %1182 = getelementptr inbounds double, ptr %1181, i64 %1172
  tail call fastcc void @combine(ptr noundef %1167, ptr noundef %1168, ptr noundef %1177, ptr noundef %1178, ptr noundef %1180, ptr noundef %1182, i64 noundef %1176, i64 noundef 1, i64 noundef %1144) #8
  %1183 = load ptr, ptr %139, align 8
  %1184 = mul nsw i64 %1165, %1146
  %1185 = getelementptr inbounds double, ptr %1183, i64 %1184
  %1186 = load i64, ptr %423, align 8
  %1187 = add nsw i64 %1186, 1
  store i64 %1187, ptr %423, align 8
  %1188 = load ptr, ptr %145, align 8
  %1189 = getelementptr inbounds double, ptr %1188, i64 %1165
  %1190 = load double, ptr %1189, align 8
  %1191 = fmul double %496, %1190
  %1192 = fadd double %449, %1191
  %1193 = load ptr, ptr %141, align 8
  %1194 = load ptr, ptr %146, align 8
  store double %1192, ptr %1194, align 8
  %1195 = load i64, ptr %147, align 8
  %1196 = icmp sgt i64 %1195, 0
  br i1 %1196, label %1197, label %1198

1197:                                             ; preds = %1162
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %1198

1198:                                             ; preds = %1162, %1197
  %1199 = load ptr, ptr %73, align 8
  %1200 = load i64, ptr %1199, align 8
  %1201 = load ptr, ptr %146, align 8
  %1202 = load ptr, ptr %148, align 8
  %1203 = load ptr, ptr %149, align 8
  %1204 = inttoptr i64 %1200 to ptr
  %1205 = load ptr, ptr %1204, align 8
  %1206 = tail call i32 %1205(ptr noundef %1201, ptr noundef %1193, ptr noundef %1202, ptr noundef %1203, ptr noundef %1185) #9
  %1207 = sext i32 %1206 to i64
  %1208 = icmp eq i32 %1206, 0
  %1209 = select i1 %1208, i64 %1164, i64 %1207
  br i1 %1208, label %1157, label %1210

1210:                                             ; preds = %1157, %1198, %1140
  %1211 = phi i1 [ %1154, %1140 ], [ %1161, %1157 ], [ %1163, %1198 ]
  %1212 = phi i64 [ 0, %1140 ], [ %1207, %1198 ], [ %1207, %1157 ]
  %1213 = phi i64 [ undef, %1140 ], [ %1209, %1198 ], [ %1209, %1157 ]
  %1214 = getelementptr inbounds i8, ptr %1141, i64 16
  br i1 %1211, label %1283, label %1215

1215:                                             ; preds = %1210
  %1216 = load ptr, ptr %73, align 8
  %1217 = getelementptr inbounds i8, ptr %1216, i64 8
  %1218 = load i64, ptr %1217, align 8
  %1219 = icmp sgt i64 %1218, 0
  br i1 %1219, label %1220, label %1224

1220:                                             ; preds = %1215
  %1221 = getelementptr inbounds double, ptr %1150, i64 %1146
  %1222 = shl nsw i64 %1146, 4
  %1223 = getelementptr inbounds i8, ptr %1150, i64 %1222
  br label %1231

1224:                                             ; preds = %1231, %1215
  %1225 = getelementptr inbounds i8, ptr %1141, i64 8
  %1226 = load i64, ptr %1225, align 8
  %1227 = load i64, ptr %1214, align 8
  %1228 = getelementptr inbounds i8, ptr %1141, i64 24
  %1229 = load i64, ptr %1228, align 8
  %1230 = icmp sgt i64 %1229, 3
  br i1 %1230, label %1258, label %1283

1231:                                             ; preds = %1220, %1231
  %1232 = phi i64 [ 0, %1220 ], [ %1253, %1231 ]
  %1233 = load ptr, ptr %150, align 8
  %1234 = getelementptr inbounds double, ptr %1233, i64 %1232
  %1235 = load double, ptr %1234, align 8
  %1236 = load ptr, ptr %74, align 8
  %1237 = getelementptr inbounds double, ptr %1236, i64 %1232
  %1238 = load double, ptr %1237, align 8
  %1239 = fsub double %1235, %1238
  %1240 = load ptr, ptr %139, align 8
  %1241 = getelementptr inbounds double, ptr %1240, i64 %1232
  %1242 = load double, ptr %1241, align 8
  %1243 = fmul double %496, %1242
  %1244 = fsub double %1243, %1239
  %1245 = getelementptr inbounds double, ptr %1150, i64 %1232
  store double %1239, ptr %1245, align 8
  %1246 = getelementptr inbounds double, ptr %1221, i64 %1232
  store double %1244, ptr %1246, align 8
  %1247 = fsub double %1239, %1244
  %1248 = getelementptr inbounds double, ptr %1149, i64 %1232
  %1249 = load double, ptr %1248, align 8
  %1250 = fmul double %496, %1249
  %1251 = fsub double %1247, %1250
  %1252 = getelementptr inbounds double, ptr %1223, i64 %1232
  store double %1251, ptr %1252, align 8
  %1253 = add nuw nsw i64 %1232, 1
  %1254 = load ptr, ptr %73, align 8
  %1255 = getelementptr inbounds i8, ptr %1254, i64 8
  %1256 = load i64, ptr %1255, align 8
  %1257 = icmp slt i64 %1253, %1256
  br i1 %1257, label %1231, label %1224, !llvm.loop !25

1258:                                             ; preds = %1224, %1258
  %1259 = phi i64 [ %1280, %1258 ], [ 3, %1224 ]
  %1260 = mul nsw i64 %1259, %1146
  %1261 = getelementptr inbounds double, ptr %1150, i64 %1260
  %1262 = load ptr, ptr %151, align 8
  %1263 = load ptr, ptr %152, align 8
  %1264 = getelementptr i64, ptr %1263, i64 %1151
  %1265 = getelementptr i64, ptr %1264, i64 %1226
  %1266 = getelementptr i64, ptr %1265, i64 %1227
  %1267 = getelementptr i64, ptr %1266, i64 %1259
  %1268 = getelementptr i8, ptr %1267, i64 -24
  %1269 = load i64, ptr %1268, align 8
  %1270 = getelementptr i8, ptr %1267, i64 -16
  %1271 = load i64, ptr %1270, align 8
  %1272 = xor i64 %1269, -1
  %1273 = add i64 %1271, %1272
  %1274 = load ptr, ptr %94, align 8
  %1275 = load ptr, ptr %139, align 8
  %1276 = load ptr, ptr %153, align 8
  %1277 = getelementptr inbounds i64, ptr %1276, i64 %1269
  %1278 = load ptr, ptr %154, align 8
  %1279 = getelementptr inbounds double, ptr %1278, i64 %1269
  tail call fastcc void @combine(ptr noundef %1261, ptr noundef %1262, ptr noundef %1274, ptr noundef %1275, ptr noundef %1277, ptr noundef %1279, i64 noundef %1273, i64 noundef 1, i64 noundef %1144) #8
  %1280 = add nuw nsw i64 %1259, 1
  %1281 = load i64, ptr %1228, align 8
  %1282 = icmp slt i64 %1280, %1281
  br i1 %1282, label %1258, label %1283, !llvm.loop !26

1283:                                             ; preds = %1258, %1224, %1210
  %1284 = phi i64 [ %1213, %1210 ], [ %1212, %1224 ], [ %1212, %1258 ]
  %1285 = icmp eq i64 %1284, 0
  br i1 %1285, label %1289, label %1286

1286:                                             ; preds = %1283
  store i64 3, ptr %428, align 8
  store double %449, ptr %160, align 8
  %1287 = icmp slt i64 %1284, 0
  %1288 = select i1 %1287, i64 -4, i64 2
  br label %1623

1289:                                             ; preds = %1283
  %1290 = load ptr, ptr %75, align 8
  br i1 %1097, label %1291, label %1302

1291:                                             ; preds = %1289
  %1292 = load ptr, ptr %82, align 8
  %1293 = getelementptr inbounds i8, ptr %1292, i64 16
  %1294 = load i64, ptr %1293, align 8
  %1295 = inttoptr i64 %1294 to ptr
  %1296 = tail call i64 %1295(ptr noundef %0, double noundef %449, double noundef %496) #9
  %1297 = icmp eq i64 %1296, -6
  br i1 %1297, label %1298, label %1299

1298:                                             ; preds = %1291
  store double %449, ptr %1290, align 8
  br label %1477

1299:                                             ; preds = %1291
  %1300 = getelementptr inbounds i8, ptr %1290, i64 48
  %1301 = load double, ptr %1300, align 8
  br label %1302

1302:                                             ; preds = %1299, %1289
  %1303 = phi double [ %1301, %1299 ], [ 1.000000e+00, %1289 ]
  %1304 = phi i64 [ %1296, %1299 ], [ 0, %1289 ]
  %1305 = fcmp oeq double %1303, 1.000000e+00
  br i1 %1305, label %1306, label %1308

1306:                                             ; preds = %1302
  %1307 = load double, ptr %1290, align 8
  br label %1311

1308:                                             ; preds = %1302
  %1309 = fmul double %496, %1303
  %1310 = fadd double %449, %1309
  br label %1311

1311:                                             ; preds = %1308, %1306
  %1312 = phi double [ %1307, %1306 ], [ %1310, %1308 ]
  %1313 = icmp eq i64 %1304, -4
  %1314 = select i1 %1313, i64 -4, i64 0
  br i1 %1313, label %1372, label %1315

1315:                                             ; preds = %1311
  %1316 = fcmp olt double %1303, 1.000000e+00
  %1317 = load ptr, ptr %73, align 8
  %1318 = getelementptr inbounds i8, ptr %1317, i64 8
  %1319 = load i64, ptr %1318, align 8
  %1320 = load i64, ptr %83, align 8
  %1321 = load ptr, ptr %78, align 8
  %1322 = load ptr, ptr %77, align 8
  %1323 = getelementptr inbounds i8, ptr %1322, i64 48
  %1324 = load i64, ptr %1323, align 8
  %1325 = icmp slt i64 %1324, %1320
  br i1 %1325, label %1326, label %1368

1326:                                             ; preds = %1315, %1364
  %1327 = phi i64 [ %1365, %1364 ], [ undef, %1315 ]
  %1328 = phi i64 [ %1366, %1364 ], [ %1324, %1315 ]
  %1329 = getelementptr inbounds double, ptr %1321, i64 %1328
  %1330 = load double, ptr %1329, align 8
  %1331 = fcmp olt double %1330, %1312
  %1332 = fcmp oeq double %1330, %1312
  %1333 = and i1 %1316, %1332
  %1334 = or i1 %1331, %1333
  br i1 %1334, label %1335, label %1368

1335:                                             ; preds = %1326
  %1336 = fsub double %1330, %449
  %1337 = fdiv double %1336, %496
  %1338 = mul nsw i64 %1328, %1319
  %1339 = getelementptr inbounds double, ptr %1, i64 %1338
  %1340 = load ptr, ptr %155, align 8
  %1341 = insertelement <8 x double> poison, double %1337, i64 0
  %1342 = shufflevector <8 x double> %1341, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1342, ptr %1340, align 8
  %1343 = load ptr, ptr %74, align 8
  %1344 = load ptr, ptr %140, align 8
  %1345 = load i64, ptr %138, align 8
  %1346 = load ptr, ptr %0, align 8
  %1347 = getelementptr inbounds i8, ptr %1346, i64 24
  %1348 = load i64, ptr %1347, align 8
  %1349 = load ptr, ptr %155, align 8
  %1350 = load ptr, ptr %73, align 8
  %1351 = getelementptr inbounds i8, ptr %1350, i64 16
  %1352 = load i64, ptr %1351, align 8
  tail call fastcc void @nested(ptr noundef %1339, ptr noundef %1343, ptr noundef %1344, i64 noundef %1345, i64 noundef %1348, ptr noundef %1349, i64 noundef %1352) #8
  %1353 = load ptr, ptr %81, align 8
  %1354 = load i64, ptr %1353, align 8
  %1355 = icmp eq i64 %1354, 1
  br i1 %1355, label %1356, label %1364

1356:                                             ; preds = %1335
  %1357 = load double, ptr %1329, align 8
  %1358 = getelementptr inbounds i8, ptr %1353, i64 56
  %1359 = load i64, ptr %1358, align 8
  %1360 = inttoptr i64 %1359 to ptr
  %1361 = tail call i64 %1360(ptr noundef %0, double noundef %1357, ptr noundef %1339, ptr noundef null) #9
  %1362 = icmp eq i64 %1361, 0
  %1363 = select i1 %1362, i64 %1327, i64 %1361
  br i1 %1362, label %1364, label %1372

1364:                                             ; preds = %1356, %1335
  %1365 = phi i64 [ %1363, %1356 ], [ %1327, %1335 ]
  %1366 = add i64 %1328, 1
  %1367 = icmp eq i64 %1366, %1320
  br i1 %1367, label %1368, label %1326, !llvm.loop !27

1368:                                             ; preds = %1364, %1326, %1315
  %1369 = phi i64 [ %1324, %1315 ], [ %1320, %1364 ], [ %1328, %1326 ]
  %1370 = load ptr, ptr %77, align 8
  %1371 = getelementptr inbounds i8, ptr %1370, i64 48
  store i64 %1369, ptr %1371, align 8
  br label %1372

1372:                                             ; preds = %1356, %1368, %1311
  %1373 = phi i64 [ %1314, %1311 ], [ 0, %1368 ], [ %1363, %1356 ]
  %1374 = icmp eq i64 %1373, 0
  %1375 = icmp ne i64 %1304, 0
  %1376 = fcmp olt double %1303, 1.000000e+00
  %1377 = and i1 %1376, %1374
  %1378 = and i1 %1375, %1377
  br i1 %1378, label %1379, label %1416

1379:                                             ; preds = %1372
  %1380 = load ptr, ptr %156, align 8
  %1381 = load ptr, ptr %157, align 8
  %1382 = insertelement <8 x double> poison, double %1303, i64 0
  %1383 = shufflevector <8 x double> %1382, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1383, ptr %1381, align 8
  %1384 = load ptr, ptr %74, align 8
  %1385 = load ptr, ptr %140, align 8
  %1386 = load i64, ptr %138, align 8
  %1387 = load ptr, ptr %0, align 8
  %1388 = getelementptr inbounds i8, ptr %1387, i64 24
  %1389 = load i64, ptr %1388, align 8
  %1390 = load ptr, ptr %157, align 8
  %1391 = load ptr, ptr %73, align 8
  %1392 = getelementptr inbounds i8, ptr %1391, i64 16
  %1393 = load i64, ptr %1392, align 8
  tail call fastcc void @nested(ptr noundef %1380, ptr noundef %1384, ptr noundef %1385, i64 noundef %1386, i64 noundef %1389, ptr noundef %1390, i64 noundef %1393) #8
  %1394 = load i64, ptr %80, align 8
  %1395 = icmp sgt i64 %1394, 0
  br i1 %1395, label %1400, label %1396

1396:                                             ; preds = %1400, %1379
  %1397 = load ptr, ptr %81, align 8
  %1398 = load i64, ptr %1397, align 8
  %1399 = icmp eq i64 %1398, 1
  br i1 %1399, label %1410, label %1416

1400:                                             ; preds = %1379, %1400
  %1401 = phi i64 [ %1407, %1400 ], [ 0, %1379 ]
  %1402 = load ptr, ptr %156, align 8
  %1403 = getelementptr inbounds double, ptr %1402, i64 %1401
  %1404 = load double, ptr %1403, align 8
  %1405 = load ptr, ptr %76, align 8
  %1406 = getelementptr inbounds double, ptr %1405, i64 %1401
  store double %1404, ptr %1406, align 8
  %1407 = add nuw nsw i64 %1401, 1
  %1408 = load i64, ptr %80, align 8
  %1409 = icmp slt i64 %1407, %1408
  br i1 %1409, label %1400, label %1396, !llvm.loop !28

1410:                                             ; preds = %1396
  %1411 = load ptr, ptr %76, align 8
  %1412 = getelementptr inbounds i8, ptr %1397, i64 56
  %1413 = load i64, ptr %1412, align 8
  %1414 = inttoptr i64 %1413 to ptr
  %1415 = tail call i64 %1414(ptr noundef %0, double noundef %1312, ptr noundef %1411, ptr noundef null) #9
  br label %1416

1416:                                             ; preds = %1410, %1396, %1372
  %1417 = phi i64 [ %1415, %1410 ], [ 0, %1396 ], [ %1373, %1372 ]
  %1418 = icmp eq i64 %1417, 0
  br i1 %1418, label %1421, label %1419

1419:                                             ; preds = %1416
  store double %449, ptr %1290, align 8
  %1420 = getelementptr inbounds i8, ptr %1290, i64 8
  store double %496, ptr %1420, align 8
  br label %1477

1421:                                             ; preds = %1416
  br i1 %1305, label %1422, label %1460

1422:                                             ; preds = %1421
  %1423 = load ptr, ptr %76, align 8
  %1424 = load ptr, ptr %73, align 8
  %1425 = getelementptr inbounds i8, ptr %1424, i64 8
  %1426 = load i64, ptr %1425, align 8
  %1427 = load i64, ptr %83, align 8
  %1428 = load ptr, ptr %78, align 8
  %1429 = load ptr, ptr %77, align 8
  %1430 = getelementptr inbounds i8, ptr %1429, i64 48
  %1431 = load i64, ptr %1430, align 8
  %1432 = icmp slt i64 %1431, %1427
  br i1 %1432, label %1433, label %1456

1433:                                             ; preds = %1422
  %1434 = icmp sgt i64 %1426, 0
  br label %1435

1435:                                             ; preds = %1433, %1446
  %1436 = phi i64 [ %1431, %1433 ], [ %1447, %1446 ]
  %1437 = getelementptr inbounds double, ptr %1428, i64 %1436
  %1438 = load double, ptr %1437, align 8
  %1439 = load ptr, ptr %75, align 8
  %1440 = load double, ptr %1439, align 8
  %1441 = fcmp ugt double %1438, %1440
  br i1 %1441, label %1456, label %1442

1442:                                             ; preds = %1435
  br i1 %1434, label %1443, label %1446

1443:                                             ; preds = %1442
  %1444 = mul nsw i64 %1436, %1426
  %1445 = getelementptr double, ptr %1, i64 %1444
  br label %1449

1446:                                             ; preds = %1449, %1442
  %1447 = add i64 %1436, 1
  %1448 = icmp eq i64 %1447, %1427
  br i1 %1448, label %1456, label %1435, !llvm.loop !8

1449:                                             ; preds = %1443, %1449
  %1450 = phi i64 [ 0, %1443 ], [ %1454, %1449 ]
  %1451 = getelementptr inbounds double, ptr %1423, i64 %1450
  %1452 = load double, ptr %1451, align 8
  %1453 = getelementptr double, ptr %1445, i64 %1450
  store double %1452, ptr %1453, align 8
  %1454 = add nuw nsw i64 %1450, 1
  %1455 = icmp eq i64 %1454, %1426
  br i1 %1455, label %1446, label %1449, !llvm.loop !9

1456:                                             ; preds = %1446, %1435, %1422
  %1457 = phi i64 [ %1431, %1422 ], [ %1427, %1446 ], [ %1436, %1435 ]
  %1458 = load ptr, ptr %77, align 8
  %1459 = getelementptr inbounds i8, ptr %1458, i64 48
  store i64 %1457, ptr %1459, align 8
  br label %1460

1460:                                             ; preds = %1456, %1421
  br i1 %1375, label %1461, label %1477

1461:                                             ; preds = %1460
  %1462 = load i64, ptr %80, align 8
  %1463 = icmp sgt i64 %1462, 0
  br i1 %1463, label %1467, label %1464

1464:                                             ; preds = %1467, %1461
  store double %1312, ptr %1290, align 8
  %1465 = getelementptr inbounds i8, ptr %1290, i64 8
  store double 0.000000e+00, ptr %1465, align 8
  %1466 = load ptr, ptr %77, align 8
  store i64 0, ptr %1466, align 8
  br label %1477

1467:                                             ; preds = %1461, %1467
  %1468 = phi i64 [ %1474, %1467 ], [ 0, %1461 ]
  %1469 = load ptr, ptr %76, align 8
  %1470 = getelementptr inbounds double, ptr %1469, i64 %1468
  %1471 = load double, ptr %1470, align 8
  %1472 = load ptr, ptr %74, align 8
  %1473 = getelementptr inbounds double, ptr %1472, i64 %1468
  store double %1471, ptr %1473, align 8
  %1474 = add nuw nsw i64 %1468, 1
  %1475 = load i64, ptr %80, align 8
  %1476 = icmp slt i64 %1474, %1475
  br i1 %1476, label %1467, label %1464, !llvm.loop !29

1477:                                             ; preds = %1298, %1419, %1460, %1464
  %1478 = phi i64 [ -6, %1298 ], [ %1417, %1419 ], [ %1304, %1464 ], [ %1304, %1460 ]
  %1479 = icmp eq i64 %1478, -6
  br i1 %1479, label %1484, label %1480

1480:                                             ; preds = %1477
  %1481 = icmp ne i64 %1478, 6
  %1482 = select i1 %1481, i1 true, i1 %176
  %1483 = select i1 %1482, i1 true, i1 %183
  br i1 %1483, label %1494, label %1484

1484:                                             ; preds = %1480, %1477
  %1485 = phi i64 [ %1478, %1480 ], [ 2, %1477 ]
  %1486 = load i64, ptr %418, align 8
  %1487 = add nsw i64 %1486, -1
  store i64 %1487, ptr %418, align 8
  %1488 = load ptr, ptr %93, align 8
  %1489 = load i64, ptr %1488, align 8
  %1490 = add nsw i64 %1489, -1
  store i64 %1490, ptr %1488, align 8
  %1491 = load i64, ptr %419, align 8
  %1492 = add nsw i64 %1491, 1
  store i64 %1492, ptr %419, align 8
  store i64 %1485, ptr %438, align 8
  store double 1.000000e+00, ptr %439, align 8
  %1493 = fmul double %496, 2.500000e-01
  br label %1623, !llvm.loop !19

1494:                                             ; preds = %1480
  %1495 = icmp eq i64 %1478, 0
  br i1 %1495, label %1500, label %1496

1496:                                             ; preds = %1494
  %1497 = load ptr, ptr %93, align 8
  %1498 = load i64, ptr %1497, align 8
  %1499 = add nsw i64 %1498, 1
  store i64 %1499, ptr %1497, align 8
  br label %1623

1500:                                             ; preds = %1494, %1136
  br i1 %176, label %1604, label %1501

1501:                                             ; preds = %1500
  %1502 = load double, ptr %430, align 8
  %1503 = fcmp ogt double %880, 1.000000e-10
  %1504 = select i1 %1503, double %880, double 1.000000e-10
  %1505 = load double, ptr %431, align 8
  %1506 = load double, ptr %432, align 8
  %1507 = fneg double %1506
  %1508 = bitcast double %1504 to i64
  %1509 = add nsw i64 %1508, -4604544271217802189
  %1510 = ashr i64 %1509, 52
  %1511 = and i64 %1509, -4503599627370496
  %1512 = sub nsw i64 %1508, %1511
  %1513 = bitcast i64 %1512 to double
  %1514 = fadd double %1513, -1.000000e+00
  %1515 = fadd double %1513, 1.000000e+00
  %1516 = fdiv double %1514, %1515
  %1517 = fmul double %1516, %1516
  %1518 = tail call double @llvm.fma.f64(double %1517, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1519 = tail call double @llvm.fma.f64(double %1518, double %1517, double 0x3FE2776C50EF9BFE)
  %1520 = tail call double @llvm.fma.f64(double %1519, double %1517, double 0x3FEEC709DC3A03FD)
  %1521 = tail call double @llvm.fma.f64(double %1520, double %1517, double 0x40071547652B82FE)
  %1522 = trunc nsw i64 %1510 to i32
  %1523 = sitofp i32 %1522 to double
  %1524 = fmul double %1516, %1521
  %1525 = fadd double %1524, %1523
  %1526 = fmul double %1525, %1507
  %1527 = fcmp ogt double %1526, -1.000000e+03
  %1528 = select i1 %1527, double %1526, double -1.000000e+03
  %1529 = fcmp olt double %1528, 1.000000e+03
  %1530 = select i1 %1529, double %1528, double 1.000000e+03
  %1531 = tail call double @llvm.rint.f64(double %1530)
  %1532 = fsub double %1530, %1531
  %1533 = tail call double @llvm.fma.f64(double %1532, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1534 = tail call double @llvm.fma.f64(double %1533, double %1532, double 0x3F55D87FE78A6730)
  %1535 = tail call double @llvm.fma.f64(double %1534, double %1532, double 0x3F83B2AB6FBA4E77)
  %1536 = tail call double @llvm.fma.f64(double %1535, double %1532, double 0x3FAC6B08D704A0BF)
  %1537 = tail call double @llvm.fma.f64(double %1536, double %1532, double 0x3FCEBFBDFF82C58E)
  %1538 = tail call double @llvm.fma.f64(double %1537, double %1532, double 0x3FE62E42FEFA39EF)
  %1539 = tail call double @llvm.fma.f64(double %1538, double %1532, double 1.000000e+00)
  %1540 = bitcast double %1539 to i64
  %1541 = fptosi double %1531 to i32
  %1542 = sext i32 %1541 to i64
  %1543 = shl nsw i64 %1542, 52
  %1544 = add nsw i64 %1543, %1540
  %1545 = bitcast i64 %1544 to double
  %1546 = fmul double %1505, %1545
  %1547 = load double, ptr %433, align 8
  %1548 = fcmp une double %1547, 0.000000e+00
  br i1 %1548, label %1549, label %1589

1549:                                             ; preds = %1501
  %1550 = load i64, ptr %429, align 8
  %1551 = add nsw i64 %1550, -4604544271217802189
  %1552 = ashr i64 %1551, 52
  %1553 = and i64 %1551, -4503599627370496
  %1554 = sub nsw i64 %1550, %1553
  %1555 = bitcast i64 %1554 to double
  %1556 = fadd double %1555, -1.000000e+00
  %1557 = fadd double %1555, 1.000000e+00
  %1558 = fdiv double %1556, %1557
  %1559 = fmul double %1558, %1558
  %1560 = tail call double @llvm.fma.f64(double %1559, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1561 = tail call double @llvm.fma.f64(double %1560, double %1559, double 0x3FE2776C50EF9BFE)
  %1562 = tail call double @llvm.fma.f64(double %1561, double %1559, double 0x3FEEC709DC3A03FD)
  %1563 = tail call double @llvm.fma.f64(double %1562, double %1559, double 0x40071547652B82FE)
  %1564 = trunc nsw i64 %1552 to i32
  %1565 = sitofp i32 %1564 to double
  %1566 = fmul double %1558, %1563
  %1567 = fadd double %1566, %1565
  %1568 = fmul double %1547, %1567
  %1569 = fcmp ogt double %1568, -1.000000e+03
  %1570 = select i1 %1569, double %1568, double -1.000000e+03
  %1571 = fcmp olt double %1570, 1.000000e+03
  %1572 = select i1 %1571, double %1570, double 1.000000e+03
  %1573 = tail call double @llvm.rint.f64(double %1572)
  %1574 = fsub double %1572, %1573
  %1575 = tail call double @llvm.fma.f64(double %1574, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1576 = tail call double @llvm.fma.f64(double %1575, double %1574, double 0x3F55D87FE78A6730)
  %1577 = tail call double @llvm.fma.f64(double %1576, double %1574, double 0x3F83B2AB6FBA4E77)
  %1578 = tail call double @llvm.fma.f64(double %1577, double %1574, double 0x3FAC6B08D704A0BF)
  %1579 = tail call double @llvm.fma.f64(double %1578, double %1574, double 0x3FCEBFBDFF82C58E)
  %1580 = tail call double @llvm.fma.f64(double %1579, double %1574, double 0x3FE62E42FEFA39EF)
  %1581 = tail call double @llvm.fma.f64(double %1580, double %1574, double 1.000000e+00)
  %1582 = bitcast double %1581 to i64
  %1583 = fptosi double %1573 to i32
  %1584 = sext i32 %1583 to i64
  %1585 = shl nsw i64 %1584, 52
  %1586 = add nsw i64 %1585, %1582
  %1587 = bitcast i64 %1586 to double
  %1588 = fmul double %1546, %1587
  br label %1589

1589:                                             ; preds = %1501, %1549
  %1590 = phi double [ %1588, %1549 ], [ %1546, %1501 ]
  %1591 = load double, ptr %434, align 8
  %1592 = fcmp ogt double %1590, %1591
  %1593 = select i1 %1592, double %1590, double %1591
  %1594 = fcmp olt double %1502, %1593
  %1595 = select i1 %1594, double %1502, double %1593
  %1596 = fmul double %496, %1595
  %1597 = fcmp oeq double %495, %187
  %1598 = fcmp ogt double %450, %1596
  %1599 = select i1 %1597, i1 %1598, i1 false
  %1600 = select i1 %1599, double %450, double %1596
  %1601 = fcmp ogt double %880, 1.000000e-04
  %1602 = select i1 %1601, double %880, double 1.000000e-04
  store double %1602, ptr %429, align 8
  %1603 = load double, ptr %435, align 8
  store double %1603, ptr %430, align 8
  br label %1604

1604:                                             ; preds = %1589, %1500
  %1605 = phi double [ %1600, %1589 ], [ %450, %1500 ]
  br i1 %436, label %1610, label %1606

1606:                                             ; preds = %1610, %1604
  %1607 = load i64, ptr %437, align 8
  %1608 = load i64, ptr %83, align 8
  %1609 = icmp eq i64 %1607, %1608
  br i1 %1609, label %1622, label %1623

1610:                                             ; preds = %1604, %1610
  %1611 = phi i64 [ %1620, %1610 ], [ 0, %1604 ]
  %1612 = getelementptr inbounds double, ptr %161, i64 %1611
  %1613 = load double, ptr %1612, align 8
  %1614 = load ptr, ptr %74, align 8
  %1615 = getelementptr inbounds double, ptr %1614, i64 %1611
  store double %1613, ptr %1615, align 8
  %1616 = getelementptr inbounds double, ptr %191, i64 %1611
  %1617 = load double, ptr %1616, align 8
  %1618 = load ptr, ptr %84, align 8
  %1619 = getelementptr inbounds double, ptr %1618, i64 %1611
  store double %1617, ptr %1619, align 8
  %1620 = add nuw nsw i64 %1611, 1
  %1621 = icmp eq i64 %1620, %170
  br i1 %1621, label %1606, label %1610, !llvm.loop !30

1622:                                             ; preds = %1606
  store double %1605, ptr %193, align 8
  br label %1623

1623:                                             ; preds = %1622, %1606, %1496, %1484, %1286, %948, %947, %867, %677, %502
  %1624 = phi double [ %450, %502 ], [ %450, %677 ], [ %450, %867 ], [ %946, %948 ], [ %946, %947 ], [ %450, %1286 ], [ %1493, %1484 ], [ %450, %1496 ], [ %1605, %1622 ], [ %1605, %1606 ]
  %1625 = phi double [ %449, %502 ], [ %449, %677 ], [ %449, %867 ], [ %449, %948 ], [ %449, %947 ], [ %449, %1286 ], [ %449, %1484 ], [ %449, %1496 ], [ %495, %1622 ], [ %495, %1606 ]
  %1626 = phi i32 [ 1, %502 ], [ 1, %677 ], [ 1, %867 ], [ 3, %948 ], [ 1, %947 ], [ 1, %1286 ], [ 3, %1484 ], [ 1, %1496 ], [ 1, %1622 ], [ 0, %1606 ]
  %1627 = phi i64 [ 2, %502 ], [ -4, %677 ], [ -4, %867 ], [ %448, %948 ], [ 2, %947 ], [ %1288, %1286 ], [ %448, %1484 ], [ %1478, %1496 ], [ 0, %1622 ], [ %448, %1606 ]
  switch i32 %1626, label %1631 [
    i32 0, label %1628
    i32 3, label %1628
  ]

1628:                                             ; preds = %1623, %1623
  %1629 = load i64, ptr %163, align 8
  %1630 = icmp eq i64 %1629, 0
  br i1 %1630, label %444, label %446, !llvm.loop !19

1631:                                             ; preds = %1623, %159, %217, %259, %444, %463, %471
  %1632 = phi i64 [ -1, %159 ], [ %220, %217 ], [ -1, %444 ], [ -5, %463 ], [ 1, %471 ], [ 0, %259 ], [ %1627, %1623 ]
  %1633 = load ptr, ptr %158, align 8
  %1634 = getelementptr inbounds i8, ptr %1633, i64 48
  %1635 = load i64, ptr %1634, align 8
  %1636 = icmp ne i64 %1632, -2
  %1637 = icmp eq i64 %1635, 0
  %1638 = select i1 %1636, i1 true, i1 %1637
  br i1 %1638, label %1646, label %1639

1639:                                             ; preds = %1631
  %1640 = inttoptr i64 %1635 to ptr
  %1641 = tail call i64 %1640(ptr noundef %0) #9
  %1642 = icmp eq i64 %1641, 8
  %1643 = select i1 %1642, i64 8, i64 %1632
  %1644 = icmp eq i64 %1641, 1
  %1645 = zext i1 %1644 to i32
  br label %1646

1646:                                             ; preds = %1631, %1639
  %1647 = phi i64 [ %1632, %1631 ], [ %1643, %1639 ]
  %1648 = phi i32 [ 0, %1631 ], [ %1645, %1639 ]
  %1649 = icmp eq i32 %1648, 0
  br i1 %1649, label %1650, label %159, !llvm.loop !31

1650:                                             ; preds = %1646
  ret i64 %1647
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
