; sources 9fa991a2517b3919e14040f4f67b8695e47220f546e266bed9a7998a396a5c4c
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

159:                                              ; preds = %1639, %72
  %160 = load ptr, ptr %75, align 8
  %161 = load ptr, ptr %76, align 8
  %162 = load ptr, ptr %77, align 8
  %163 = getelementptr inbounds i8, ptr %162, i64 56
  %164 = load i64, ptr %163, align 8
  %165 = icmp eq i64 %164, 0
  br i1 %165, label %1624, label %166

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
  br label %1624

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
  br i1 %262, label %1624, label %263

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

442:                                              ; preds = %1621, %411
  %443 = phi double [ %412, %411 ], [ %1617, %1621 ]
  store double %443, ptr %193, align 8
  br label %1624

444:                                              ; preds = %415, %1621
  %445 = phi i64 [ %413, %415 ], [ %1622, %1621 ]
  %446 = phi i64 [ undef, %415 ], [ %1620, %1621 ]
  %447 = phi double [ %192, %415 ], [ %1618, %1621 ]
  %448 = phi double [ %412, %415 ], [ %1617, %1621 ]
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
  br label %1624

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
  br label %1624

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
  %493 = select i1 %492, double %489, double %476
  %494 = fsub double %493, %447
  %495 = fmul double %494, 6.250000e-02
  %496 = fadd double %447, %495
  %497 = fcmp ule double %496, %447
  %498 = fcmp une double %493, %476
  %499 = and i1 %498, %497
  br i1 %499, label %500, label %501

500:                                              ; preds = %487
  store double %494, ptr %193, align 8
  br label %1616

501:                                              ; preds = %487
  %502 = load ptr, ptr %0, align 8
  %503 = load i64, ptr %502, align 8
  %504 = load ptr, ptr %94, align 8
  %505 = insertelement <8 x double> poison, double %494, i64 0
  %506 = shufflevector <8 x double> %505, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %506, ptr %504, align 8
  %507 = icmp sgt i64 %503, 1
  br i1 %507, label %512, label %596

508:                                              ; preds = %585
  %509 = add nuw nsw i64 %515, 1
  %510 = icmp slt i64 %509, %503
  %511 = icmp eq i64 %509, %503
  br i1 %511, label %596, label %512, !llvm.loop !12

512:                                              ; preds = %501, %508
  %513 = phi i1 [ %510, %508 ], [ %507, %501 ]
  %514 = phi i64 [ %595, %508 ], [ undef, %501 ]
  %515 = phi i64 [ %509, %508 ], [ 1, %501 ]
  %516 = load ptr, ptr %95, align 8
  %517 = load ptr, ptr %74, align 8
  %518 = load ptr, ptr %73, align 8
  %519 = getelementptr inbounds i8, ptr %518, i64 16
  %520 = load i64, ptr %519, align 8
  %521 = icmp sgt i64 %520, 1
  %522 = zext i1 %521 to i64
  %523 = load ptr, ptr %96, align 8
  %524 = getelementptr inbounds i64, ptr %523, i64 %515
  %525 = load i64, ptr %524, align 8
  %526 = getelementptr i8, ptr %524, i64 8
  %527 = load i64, ptr %526, align 8
  %528 = xor i64 %525, -1
  %529 = add i64 %527, %528
  %530 = load ptr, ptr %94, align 8
  %531 = load ptr, ptr %97, align 8
  %532 = load ptr, ptr %98, align 8
  %533 = getelementptr inbounds i64, ptr %532, i64 %525
  %534 = load ptr, ptr %99, align 8
  %535 = getelementptr inbounds double, ptr %534, i64 %525
  tail call fastcc void @combine(ptr noundef %516, ptr noundef %517, ptr noundef %530, ptr noundef %531, ptr noundef %533, ptr noundef %535, i64 noundef %529, i64 noundef %522, i64 noundef %520) #8
  %536 = icmp eq i64 %520, 1
  br i1 %536, label %537, label %568

537:                                              ; preds = %512
  %538 = load ptr, ptr %96, align 8
  %539 = getelementptr i64, ptr %538, i64 %515
  %540 = getelementptr i8, ptr %539, i64 8
  %541 = load i64, ptr %540, align 8
  %542 = add nsw i64 %541, -1
  %543 = load ptr, ptr %99, align 8
  %544 = getelementptr inbounds double, ptr %543, i64 %542
  %545 = load double, ptr %544, align 8
  %546 = fmul double %494, %545
  %547 = load ptr, ptr %97, align 8
  %548 = load ptr, ptr %98, align 8
  %549 = getelementptr inbounds i64, ptr %548, i64 %542
  %550 = load i64, ptr %549, align 8
  %551 = getelementptr inbounds double, ptr %547, i64 %550
  %552 = load ptr, ptr %73, align 8
  %553 = getelementptr inbounds i8, ptr %552, i64 8
  %554 = load i64, ptr %553, align 8
  %555 = icmp sgt i64 %554, 0
  br i1 %555, label %556, label %568

556:                                              ; preds = %537, %556
  %557 = phi i64 [ %563, %556 ], [ 0, %537 ]
  %558 = getelementptr inbounds double, ptr %551, i64 %557
  %559 = load double, ptr %558, align 8
  %560 = getelementptr inbounds double, ptr %516, i64 %557
  %561 = load double, ptr %560, align 8
  %562 = tail call double @llvm.fma.f64(double %546, double %559, double %561)
  store double %562, ptr %560, align 8
  %563 = add nuw nsw i64 %557, 1
  %564 = load ptr, ptr %73, align 8
  %565 = getelementptr inbounds i8, ptr %564, i64 8
  %566 = load i64, ptr %565, align 8
  %567 = icmp slt i64 %563, %566
  br i1 %567, label %556, label %568, !llvm.loop !13

568:                                              ; preds = %556, %537, %512
  %569 = load ptr, ptr %97, align 8
  %570 = load i64, ptr %100, align 8
  %571 = mul nsw i64 %570, %515
  %572 = getelementptr inbounds double, ptr %569, i64 %571
  %573 = load i64, ptr %421, align 8
  %574 = add nsw i64 %573, 1
  store i64 %574, ptr %421, align 8
  %575 = load ptr, ptr %101, align 8
  %576 = getelementptr inbounds double, ptr %575, i64 %515
  %577 = load double, ptr %576, align 8
  %578 = fmul double %494, %577
  %579 = fadd double %447, %578
  %580 = load ptr, ptr %95, align 8
  %581 = load ptr, ptr %102, align 8
  store double %579, ptr %581, align 8
  %582 = load i64, ptr %103, align 8
  %583 = icmp sgt i64 %582, 0
  br i1 %583, label %584, label %585

584:                                              ; preds = %568
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %585

585:                                              ; preds = %568, %584
  %586 = load ptr, ptr %73, align 8
  %587 = load i64, ptr %586, align 8
  %588 = load ptr, ptr %102, align 8
  %589 = load ptr, ptr %104, align 8
  %590 = load ptr, ptr %105, align 8
  %591 = inttoptr i64 %587 to ptr
  %592 = tail call i32 %591(ptr noundef %588, ptr noundef %580, ptr noundef %589, ptr noundef %590, ptr noundef %572) #9
  %593 = sext i32 %592 to i64
  %594 = icmp eq i32 %592, 0
  %595 = select i1 %594, i64 %514, i64 %593
  br i1 %594, label %508, label %596

596:                                              ; preds = %508, %585, %501
  %597 = phi i1 [ %507, %501 ], [ %510, %508 ], [ %513, %585 ]
  %598 = phi i64 [ 0, %501 ], [ %593, %585 ], [ %593, %508 ]
  %599 = phi i64 [ undef, %501 ], [ %595, %585 ], [ %595, %508 ]
  br i1 %597, label %653, label %600

600:                                              ; preds = %596
  %601 = load ptr, ptr %106, align 8
  %602 = load ptr, ptr %74, align 8
  %603 = load ptr, ptr %73, align 8
  %604 = getelementptr inbounds i8, ptr %603, i64 16
  %605 = load i64, ptr %604, align 8
  %606 = icmp sgt i64 %605, 1
  %607 = zext i1 %606 to i64
  %608 = load ptr, ptr %107, align 8
  %609 = getelementptr inbounds i64, ptr %608, i64 %503
  %610 = load i64, ptr %609, align 8
  %611 = getelementptr i8, ptr %609, i64 8
  %612 = load i64, ptr %611, align 8
  %613 = xor i64 %610, -1
  %614 = add i64 %612, %613
  %615 = load ptr, ptr %94, align 8
  %616 = load ptr, ptr %108, align 8
  %617 = load ptr, ptr %109, align 8
  %618 = getelementptr inbounds i64, ptr %617, i64 %610
  %619 = load ptr, ptr %110, align 8
  %620 = getelementptr inbounds double, ptr %619, i64 %610
  tail call fastcc void @combine(ptr noundef %601, ptr noundef %602, ptr noundef %615, ptr noundef %616, ptr noundef %618, ptr noundef %620, i64 noundef %614, i64 noundef %607, i64 noundef %605) #8
  %621 = icmp eq i64 %605, 1
  br i1 %621, label %622, label %653

622:                                              ; preds = %600
  %623 = load ptr, ptr %107, align 8
  %624 = getelementptr i64, ptr %623, i64 %503
  %625 = getelementptr i8, ptr %624, i64 8
  %626 = load i64, ptr %625, align 8
  %627 = add nsw i64 %626, -1
  %628 = load ptr, ptr %110, align 8
  %629 = getelementptr inbounds double, ptr %628, i64 %627
  %630 = load double, ptr %629, align 8
  %631 = fmul double %494, %630
  %632 = load ptr, ptr %108, align 8
  %633 = load ptr, ptr %109, align 8
  %634 = getelementptr inbounds i64, ptr %633, i64 %627
  %635 = load i64, ptr %634, align 8
  %636 = getelementptr inbounds double, ptr %632, i64 %635
  %637 = load ptr, ptr %73, align 8
  %638 = getelementptr inbounds i8, ptr %637, i64 8
  %639 = load i64, ptr %638, align 8
  %640 = icmp sgt i64 %639, 0
  br i1 %640, label %641, label %653

641:                                              ; preds = %622, %641
  %642 = phi i64 [ %648, %641 ], [ 0, %622 ]
  %643 = getelementptr inbounds double, ptr %636, i64 %642
  %644 = load double, ptr %643, align 8
  %645 = getelementptr inbounds double, ptr %601, i64 %642
  %646 = load double, ptr %645, align 8
  %647 = tail call double @llvm.fma.f64(double %631, double %644, double %646)
  store double %647, ptr %645, align 8
  %648 = add nuw nsw i64 %642, 1
  %649 = load ptr, ptr %73, align 8
  %650 = getelementptr inbounds i8, ptr %649, i64 8
  %651 = load i64, ptr %650, align 8
  %652 = icmp slt i64 %648, %651
  br i1 %652, label %641, label %653, !llvm.loop !13

653:                                              ; preds = %641, %622, %600, %596
  %654 = phi i64 [ %599, %596 ], [ %598, %600 ], [ %598, %622 ], [ %598, %641 ]
  %655 = icmp eq i64 %654, 0
  %656 = select i1 %655, i1 %179, i1 false
  br i1 %656, label %657, label %673

657:                                              ; preds = %653
  %658 = load i64, ptr %421, align 8
  %659 = add nsw i64 %658, 1
  store i64 %659, ptr %421, align 8
  %660 = load ptr, ptr %111, align 8
  store double %493, ptr %660, align 8
  %661 = load i64, ptr %112, align 8
  %662 = icmp sgt i64 %661, 0
  br i1 %662, label %663, label %664

663:                                              ; preds = %657
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %664

664:                                              ; preds = %657, %663
  %665 = load ptr, ptr %73, align 8
  %666 = load i64, ptr %665, align 8
  %667 = load ptr, ptr %111, align 8
  %668 = load ptr, ptr %113, align 8
  %669 = load ptr, ptr %114, align 8
  %670 = inttoptr i64 %666 to ptr
  %671 = tail call i32 %670(ptr noundef %667, ptr noundef %161, ptr noundef %668, ptr noundef %669, ptr noundef %191) #9
  %672 = sext i32 %671 to i64
  br label %673

673:                                              ; preds = %664, %653
  %674 = phi i64 [ %672, %664 ], [ %654, %653 ]
  %675 = icmp slt i64 %674, 0
  br i1 %675, label %1616, label %676

676:                                              ; preds = %673
  %677 = icmp eq i64 %674, 0
  br i1 %677, label %678, label %873

678:                                              ; preds = %676
  br i1 %176, label %679, label %680

679:                                              ; preds = %678
  br i1 %422, label %829, label %838

680:                                              ; preds = %678
  %681 = load ptr, ptr %73, align 8
  %682 = load ptr, ptr %0, align 8
  %683 = getelementptr inbounds i8, ptr %681, i64 24
  %684 = load i64, ptr %683, align 8
  %685 = getelementptr inbounds i8, ptr %682, i64 8
  %686 = load i64, ptr %685, align 8
  %687 = load ptr, ptr %115, align 8
  %688 = load i64, ptr %116, align 8
  %689 = getelementptr inbounds double, ptr %687, i64 %688
  %690 = icmp sgt i64 %686, 0
  br i1 %690, label %691, label %693

691:                                              ; preds = %680
  %692 = getelementptr inbounds i8, ptr %681, i64 32
  br label %701

693:                                              ; preds = %701, %680
  %694 = icmp sgt i64 %684, 0
  br i1 %694, label %695, label %727

695:                                              ; preds = %693
  %696 = load ptr, ptr %74, align 8
  %697 = load ptr, ptr %122, align 8
  %698 = load ptr, ptr %123, align 8
  %699 = load ptr, ptr %124, align 8
  %700 = load ptr, ptr %115, align 8
  br label %785

701:                                              ; preds = %691, %701
  %702 = phi i64 [ 0, %691 ], [ %725, %701 ]
  %703 = load i64, ptr %682, align 8
  %704 = load i64, ptr %692, align 8
  %705 = load ptr, ptr %115, align 8
  %706 = load i64, ptr %116, align 8
  %707 = mul nsw i64 %706, %702
  %708 = getelementptr inbounds double, ptr %705, i64 %707
  %709 = load ptr, ptr %117, align 8
  %710 = load ptr, ptr %118, align 8
  %711 = getelementptr i64, ptr %710, i64 %703
  %712 = getelementptr i8, ptr %711, i64 8
  %713 = getelementptr i64, ptr %712, i64 %702
  %714 = load i64, ptr %713, align 8
  %715 = getelementptr i8, ptr %713, i64 8
  %716 = load i64, ptr %715, align 8
  %717 = xor i64 %714, -1
  %718 = add i64 %716, %717
  %719 = load ptr, ptr %94, align 8
  %720 = load ptr, ptr %119, align 8
  %721 = load ptr, ptr %120, align 8
  %722 = getelementptr inbounds i64, ptr %721, i64 %714
  %723 = load ptr, ptr %121, align 8
  %724 = getelementptr inbounds double, ptr %723, i64 %714
  tail call fastcc void @combine(ptr noundef %708, ptr noundef %709, ptr noundef %719, ptr noundef %720, ptr noundef %722, ptr noundef %724, i64 noundef %718, i64 noundef 1, i64 noundef %704) #8
  %725 = add nuw nsw i64 %702, 1
  %726 = icmp eq i64 %725, %686
  br i1 %726, label %693, label %701, !llvm.loop !14

727:                                              ; preds = %785, %693
  %728 = phi double [ 0.000000e+00, %693 ], [ %813, %785 ]
  %729 = phi double [ 0.000000e+00, %693 ], [ %811, %785 ]
  %730 = load ptr, ptr %125, align 8
  %731 = getelementptr inbounds i8, ptr %681, i64 8
  %732 = load i64, ptr %731, align 8
  %733 = add nsw i64 %732, -3
  %734 = getelementptr i8, ptr %730, i64 8
  %735 = getelementptr i8, ptr %730, i64 16
  %736 = getelementptr i8, ptr %730, i64 24
  %737 = icmp slt i64 %684, %733
  br i1 %737, label %745, label %738

738:                                              ; preds = %745, %727
  %739 = phi double [ 0.000000e+00, %727 ], [ %754, %745 ]
  %740 = phi double [ 0.000000e+00, %727 ], [ %758, %745 ]
  %741 = phi double [ 0.000000e+00, %727 ], [ %762, %745 ]
  %742 = phi double [ 0.000000e+00, %727 ], [ %766, %745 ]
  %743 = phi i64 [ %684, %727 ], [ %767, %745 ]
  %744 = icmp slt i64 %743, %732
  br i1 %744, label %769, label %778

745:                                              ; preds = %727, %745
  %746 = phi i64 [ %767, %745 ], [ %684, %727 ]
  %747 = phi double [ %766, %745 ], [ 0.000000e+00, %727 ]
  %748 = phi double [ %762, %745 ], [ 0.000000e+00, %727 ]
  %749 = phi double [ %758, %745 ], [ 0.000000e+00, %727 ]
  %750 = phi double [ %754, %745 ], [ 0.000000e+00, %727 ]
  %751 = getelementptr inbounds double, ptr %730, i64 %746
  %752 = load double, ptr %751, align 8
  %753 = fmul double %752, 0.000000e+00
  %754 = fadd double %750, %753
  %755 = getelementptr double, ptr %734, i64 %746
  %756 = load double, ptr %755, align 8
  %757 = fmul double %756, 0.000000e+00
  %758 = fadd double %749, %757
  %759 = getelementptr double, ptr %735, i64 %746
  %760 = load double, ptr %759, align 8
  %761 = fmul double %760, 0.000000e+00
  %762 = fadd double %748, %761
  %763 = getelementptr double, ptr %736, i64 %746
  %764 = load double, ptr %763, align 8
  %765 = fmul double %764, 0.000000e+00
  %766 = fadd double %747, %765
  %767 = add nsw i64 %746, 4
  %768 = icmp slt i64 %767, %733
  br i1 %768, label %745, label %738, !llvm.loop !15

769:                                              ; preds = %738, %769
  %770 = phi i64 [ %776, %769 ], [ %743, %738 ]
  %771 = phi double [ %775, %769 ], [ %739, %738 ]
  %772 = getelementptr inbounds double, ptr %730, i64 %770
  %773 = load double, ptr %772, align 8
  %774 = fmul double %773, 0.000000e+00
  %775 = fadd double %771, %774
  %776 = add nsw i64 %770, 1
  %777 = icmp eq i64 %776, %732
  br i1 %777, label %778, label %769, !llvm.loop !16

778:                                              ; preds = %769, %738
  %779 = phi double [ %739, %738 ], [ %775, %769 ]
  %780 = fadd double %740, %779
  %781 = fadd double %741, %742
  %782 = fadd double %781, %780
  %783 = fadd double %729, %782
  %784 = icmp eq i64 %686, 2
  br i1 %784, label %816, label %825

785:                                              ; preds = %695, %785
  %786 = phi double [ 0.000000e+00, %695 ], [ %811, %785 ]
  %787 = phi double [ 0.000000e+00, %695 ], [ %813, %785 ]
  %788 = phi i64 [ 0, %695 ], [ %814, %785 ]
  %789 = getelementptr inbounds double, ptr %696, i64 %788
  %790 = load double, ptr %789, align 8
  %791 = getelementptr inbounds double, ptr %697, i64 %788
  %792 = load double, ptr %791, align 8
  %793 = getelementptr inbounds double, ptr %698, i64 %788
  %794 = load double, ptr %793, align 8
  %795 = getelementptr inbounds double, ptr %699, i64 %788
  %796 = load double, ptr %795, align 8
  %797 = tail call double @llvm.fabs.f64(double %790)
  %798 = tail call double @llvm.fabs.f64(double %792)
  %799 = fcmp ogt double %797, %798
  %800 = select i1 %799, double %797, double %798
  %801 = fmul double %800, %796
  %802 = fadd double %794, %801
  %803 = fdiv double 1.000000e+00, %802
  %804 = getelementptr inbounds double, ptr %700, i64 %788
  %805 = load double, ptr %804, align 8
  %806 = fmul double %805, %803
  %807 = getelementptr inbounds double, ptr %689, i64 %788
  %808 = load double, ptr %807, align 8
  %809 = fmul double %808, %803
  %810 = fmul double %806, %806
  %811 = fadd double %786, %810
  %812 = fmul double %809, %809
  %813 = fadd double %787, %812
  %814 = add nuw nsw i64 %788, 1
  %815 = icmp eq i64 %814, %684
  br i1 %815, label %727, label %785, !llvm.loop !17

816:                                              ; preds = %778
  %817 = fmul double %728, 1.000000e-02
  %818 = fadd double %817, %783
  %819 = sitofp i64 %684 to double
  %820 = fmul double %818, %819
  %821 = tail call double @llvm.sqrt.f64(double %820)
  %822 = fdiv double %783, %821
  %823 = fcmp une double %783, 0.000000e+00
  %824 = select i1 %823, double %822, double 0.000000e+00
  br label %838

825:                                              ; preds = %778
  %826 = sitofp i64 %684 to double
  %827 = fdiv double %783, %826
  %828 = tail call double @llvm.sqrt.f64(double %827)
  br label %838

829:                                              ; preds = %679, %829
  %830 = phi i64 [ %836, %829 ], [ 0, %679 ]
  %831 = phi double [ %835, %829 ], [ 0.000000e+00, %679 ]
  %832 = getelementptr inbounds double, ptr %161, i64 %830
  %833 = load double, ptr %832, align 8
  %834 = fmul double %833, 0.000000e+00
  %835 = fadd double %831, %834
  %836 = add nuw nsw i64 %830, 1
  %837 = icmp eq i64 %836, %170
  br i1 %837, label %838, label %829, !llvm.loop !18

838:                                              ; preds = %829, %679, %825, %816
  %839 = phi double [ %824, %816 ], [ %828, %825 ], [ 0.000000e+00, %679 ], [ %835, %829 ]
  %840 = fcmp uge double %839, 1.000000e+00
  %841 = select i1 %840, i1 true, i1 %423
  br i1 %841, label %873, label %842

842:                                              ; preds = %838
  br i1 %173, label %854, label %843

843:                                              ; preds = %842
  br i1 %176, label %846, label %844

844:                                              ; preds = %843
  %845 = load ptr, ptr %74, align 8
  br label %846

846:                                              ; preds = %844, %843
  %847 = phi ptr [ %845, %844 ], [ null, %843 ]
  %848 = load ptr, ptr %81, align 8
  %849 = getelementptr inbounds i8, ptr %848, i64 56
  %850 = load i64, ptr %849, align 8
  %851 = inttoptr i64 %850 to ptr
  %852 = tail call i64 %851(ptr noundef %0, double noundef %493, ptr noundef %161, ptr noundef %847) #9
  %853 = icmp ne i64 %852, 0
  br label %854

854:                                              ; preds = %846, %842
  %855 = phi i1 [ false, %842 ], [ %853, %846 ]
  br i1 %855, label %873, label %856

856:                                              ; preds = %854
  %857 = load i64, ptr %421, align 8
  %858 = add nsw i64 %857, 1
  store i64 %858, ptr %421, align 8
  %859 = load ptr, ptr %126, align 8
  store double %493, ptr %859, align 8
  %860 = load i64, ptr %127, align 8
  %861 = icmp sgt i64 %860, 0
  br i1 %861, label %862, label %863

862:                                              ; preds = %856
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %863

863:                                              ; preds = %856, %862
  %864 = load ptr, ptr %73, align 8
  %865 = load i64, ptr %864, align 8
  %866 = load ptr, ptr %126, align 8
  %867 = load ptr, ptr %128, align 8
  %868 = load ptr, ptr %129, align 8
  %869 = inttoptr i64 %865 to ptr
  %870 = tail call i32 %869(ptr noundef %866, ptr noundef %161, ptr noundef %867, ptr noundef %868, ptr noundef %191) #9
  %871 = sext i32 %870 to i64
  %872 = icmp slt i32 %870, 0
  br i1 %872, label %1616, label %873

873:                                              ; preds = %863, %854, %838, %676
  %874 = phi i64 [ 0, %854 ], [ %871, %863 ], [ 0, %838 ], [ %674, %676 ]
  %875 = phi double [ %839, %854 ], [ %839, %863 ], [ %839, %838 ], [ 0.000000e+00, %676 ]
  %876 = phi i1 [ %855, %854 ], [ %855, %863 ], [ false, %838 ], [ false, %676 ]
  %877 = icmp ne i64 %874, 0
  %878 = fcmp uge double %875, 1.000000e+00
  %879 = or i1 %877, %878
  %880 = or i1 %876, %879
  br i1 %880, label %881, label %944

881:                                              ; preds = %873
  %882 = load i64, ptr %417, align 8
  %883 = add nsw i64 %882, 1
  store i64 %883, ptr %417, align 8
  %884 = or i1 %877, %876
  br i1 %884, label %888, label %885

885:                                              ; preds = %881
  %886 = tail call double @llvm.fabs.f64(double %875)
  %887 = fcmp one double %886, 0x7FF0000000000000
  br label %888

888:                                              ; preds = %885, %881
  %889 = phi i1 [ false, %881 ], [ %887, %885 ]
  %890 = select i1 %889, i64 2, i64 4
  %891 = select i1 %876, i64 6, i64 %890
  %892 = select i1 %877, i64 3, i64 %891
  store i64 %892, ptr %438, align 8
  %893 = fcmp ogt double %875, 1.000000e-10
  %894 = select i1 %893, double %875, double 1.000000e-10
  %895 = load double, ptr %439, align 8
  %896 = load double, ptr %168, align 8
  %897 = fneg double %896
  %898 = bitcast double %894 to i64
  %899 = add nsw i64 %898, -4604544271217802189
  %900 = ashr i64 %899, 52
  %901 = and i64 %899, -4503599627370496
  %902 = sub nsw i64 %898, %901
  %903 = bitcast i64 %902 to double
  %904 = fadd double %903, -1.000000e+00
  %905 = fadd double %903, 1.000000e+00
  %906 = fdiv double %904, %905
  %907 = fmul double %906, %906
  %908 = tail call double @llvm.fma.f64(double %907, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %909 = tail call double @llvm.fma.f64(double %908, double %907, double 0x3FE2776C50EF9BFE)
  %910 = tail call double @llvm.fma.f64(double %909, double %907, double 0x3FEEC709DC3A03FD)
  %911 = tail call double @llvm.fma.f64(double %910, double %907, double 0x40071547652B82FE)
  %912 = trunc nsw i64 %900 to i32
  %913 = sitofp i32 %912 to double
  %914 = fmul double %906, %911
  %915 = fadd double %914, %913
  %916 = fmul double %915, %897
  %917 = fcmp ogt double %916, -1.000000e+03
  %918 = select i1 %917, double %916, double -1.000000e+03
  %919 = fcmp olt double %918, 1.000000e+03
  %920 = select i1 %919, double %918, double 1.000000e+03
  %921 = tail call double @llvm.rint.f64(double %920)
  %922 = fsub double %920, %921
  %923 = tail call double @llvm.fma.f64(double %922, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %924 = tail call double @llvm.fma.f64(double %923, double %922, double 0x3F55D87FE78A6730)
  %925 = tail call double @llvm.fma.f64(double %924, double %922, double 0x3F83B2AB6FBA4E77)
  %926 = tail call double @llvm.fma.f64(double %925, double %922, double 0x3FAC6B08D704A0BF)
  %927 = tail call double @llvm.fma.f64(double %926, double %922, double 0x3FCEBFBDFF82C58E)
  %928 = tail call double @llvm.fma.f64(double %927, double %922, double 0x3FE62E42FEFA39EF)
  %929 = tail call double @llvm.fma.f64(double %928, double %922, double 1.000000e+00)
  %930 = bitcast double %929 to i64
  %931 = fptosi double %921 to i32
  %932 = sext i32 %931 to i64
  %933 = shl nsw i64 %932, 52
  %934 = add nsw i64 %933, %930
  %935 = bitcast i64 %934 to double
  %936 = fmul double %895, %935
  %937 = load double, ptr %440, align 8
  %938 = fcmp ogt double %936, %937
  %939 = select i1 %938, double %936, double %937
  %940 = select i1 %889, double %939, double 2.500000e-01
  %941 = fmul double %494, %940
  br i1 %176, label %942, label %943

942:                                              ; preds = %888
  store double %494, ptr %193, align 8
  br label %1616

943:                                              ; preds = %888
  store double 1.000000e+00, ptr %441, align 8
  br label %1616, !llvm.loop !19

944:                                              ; preds = %873
  %945 = load i64, ptr %416, align 8
  %946 = add nsw i64 %945, 1
  store i64 %946, ptr %416, align 8
  store double %493, ptr %160, align 8
  store double %494, ptr %424, align 8
  %947 = load ptr, ptr %93, align 8
  %948 = getelementptr inbounds i8, ptr %947, i64 8
  %949 = load i64, ptr %948, align 8
  %950 = icmp eq i64 %949, 0
  br i1 %950, label %980, label %951

951:                                              ; preds = %944
  %952 = load i64, ptr %947, align 8
  %953 = load ptr, ptr %73, align 8
  %954 = getelementptr inbounds i8, ptr %953, i64 8
  %955 = load i64, ptr %954, align 8
  %956 = load ptr, ptr %130, align 8
  %957 = load i64, ptr %131, align 8
  %958 = mul nsw i64 %957, %952
  %959 = getelementptr inbounds double, ptr %956, i64 %958
  %960 = getelementptr inbounds double, ptr %959, i64 %957
  store double %447, ptr %959, align 8
  %961 = getelementptr inbounds i8, ptr %959, i64 8
  store double %494, ptr %961, align 8
  store double %493, ptr %960, align 8
  %962 = getelementptr inbounds i8, ptr %960, i64 8
  store double 0.000000e+00, ptr %962, align 8
  %963 = icmp sgt i64 %955, 0
  br i1 %963, label %967, label %964

964:                                              ; preds = %967, %951
  %965 = add nsw i64 %952, 1
  %966 = load ptr, ptr %93, align 8
  store i64 %965, ptr %966, align 8
  br label %980

967:                                              ; preds = %951, %967
  %968 = phi i64 [ %978, %967 ], [ 0, %951 ]
  %969 = load ptr, ptr %74, align 8
  %970 = getelementptr inbounds double, ptr %969, i64 %968
  %971 = load double, ptr %970, align 8
  %972 = add nuw nsw i64 %968, 2
  %973 = getelementptr inbounds double, ptr %959, i64 %972
  store double %971, ptr %973, align 8
  %974 = load ptr, ptr %76, align 8
  %975 = getelementptr inbounds double, ptr %974, i64 %968
  %976 = load double, ptr %975, align 8
  %977 = getelementptr inbounds double, ptr %960, i64 %972
  store double %976, ptr %977, align 8
  %978 = add nuw nsw i64 %968, 1
  %979 = icmp eq i64 %978, %955
  br i1 %979, label %964, label %967, !llvm.loop !20

980:                                              ; preds = %944, %964
  br i1 %183, label %981, label %1090

981:                                              ; preds = %980
  %982 = load ptr, ptr %82, align 8
  %983 = load i64, ptr %80, align 8
  %984 = load ptr, ptr %132, align 8
  %985 = getelementptr inbounds i8, ptr %982, i64 32
  %986 = load i64, ptr %985, align 8
  %987 = getelementptr inbounds double, ptr %984, i64 %986
  %988 = getelementptr inbounds i8, ptr %982, i64 24
  %989 = load i64, ptr %988, align 8
  %990 = icmp eq i64 %989, 0
  br i1 %990, label %1087, label %991

991:                                              ; preds = %981
  %992 = getelementptr inbounds i8, ptr %982, i64 40
  %993 = load i64, ptr %992, align 8
  %994 = icmp sgt i64 %993, 0
  br i1 %994, label %1048, label %995

995:                                              ; preds = %1066, %991
  %996 = load ptr, ptr %133, align 8
  %997 = load ptr, ptr %82, align 8
  %998 = getelementptr inbounds i8, ptr %997, i64 8
  %999 = load i64, ptr %998, align 8
  %1000 = load ptr, ptr %134, align 8
  %1001 = load ptr, ptr %132, align 8
  %1002 = getelementptr inbounds i8, ptr %997, i64 32
  %1003 = load i64, ptr %1002, align 8
  %1004 = getelementptr inbounds i8, ptr %997, i64 40
  %1005 = load i64, ptr %1004, align 8
  %1006 = getelementptr double, ptr %1001, i64 %1003
  %1007 = getelementptr double, ptr %1006, i64 %1005
  store double %494, ptr %1007, align 8
  %1008 = load ptr, ptr %133, align 8
  store double %447, ptr %1008, align 8
  %1009 = load ptr, ptr %82, align 8
  %1010 = getelementptr inbounds i8, ptr %1009, i64 24
  %1011 = load i64, ptr %1010, align 8
  %1012 = load ptr, ptr %74, align 8
  %1013 = load ptr, ptr %132, align 8
  %1014 = load ptr, ptr %135, align 8
  %1015 = inttoptr i64 %1011 to ptr
  %1016 = tail call i32 %1015(ptr noundef %996, ptr noundef %1012, ptr noundef %1013, ptr noundef %1014, ptr noundef %1000) #9
  %1017 = icmp eq i32 %1016, 0
  br i1 %1017, label %1018, label %1087

1018:                                             ; preds = %995
  %1019 = icmp slt i64 %999, 1
  br i1 %1019, label %1045, label %1020

1020:                                             ; preds = %1018
  %1021 = load ptr, ptr %136, align 8
  %1022 = getelementptr double, ptr %1000, i64 %999
  br label %1023

1023:                                             ; preds = %1020, %1041
  %1024 = phi i1 [ %1019, %1020 ], [ %1043, %1041 ]
  %1025 = phi i64 [ 0, %1020 ], [ %1042, %1041 ]
  %1026 = getelementptr inbounds i64, ptr %1021, i64 %1025
  %1027 = load i64, ptr %1026, align 8
  %1028 = and i64 %1027, 2
  %1029 = icmp eq i64 %1028, 0
  br i1 %1029, label %1030, label %1041

1030:                                             ; preds = %1023
  %1031 = getelementptr inbounds double, ptr %1000, i64 %1025
  %1032 = load double, ptr %1031, align 8
  %1033 = load ptr, ptr %137, align 8
  %1034 = getelementptr inbounds i64, ptr %1033, i64 %1025
  %1035 = load i64, ptr %1034, align 8
  %1036 = sitofp i64 %1035 to double
  %1037 = fmul double %1032, %1036
  %1038 = getelementptr double, ptr %1022, i64 %1025
  %1039 = load double, ptr %1038, align 8
  %1040 = fcmp ogt double %1037, %1039
  br i1 %1040, label %1041, label %1045

1041:                                             ; preds = %1030, %1023
  %1042 = add nuw nsw i64 %1025, 1
  %1043 = icmp sge i64 %1042, %999
  %1044 = icmp eq i64 %1042, %999
  br i1 %1044, label %1045, label %1023, !llvm.loop !21

1045:                                             ; preds = %1041, %1030, %1018
  %1046 = phi i1 [ %1019, %1018 ], [ %1043, %1041 ], [ %1024, %1030 ]
  %1047 = zext i1 %1046 to i32
  br label %1087

1048:                                             ; preds = %991, %1066
  %1049 = phi i64 [ %1070, %1066 ], [ 0, %991 ]
  %1050 = load ptr, ptr %76, align 8
  %1051 = getelementptr inbounds double, ptr %1050, i64 %1049
  %1052 = load <8 x double>, ptr %1051, align 8
  %1053 = load ptr, ptr %74, align 8
  %1054 = getelementptr inbounds double, ptr %1053, i64 %1049
  %1055 = load <8 x double>, ptr %1054, align 8
  %1056 = fsub <8 x double> %1052, %1055
  %1057 = fneg <8 x double> %1056
  %1058 = fcmp ogt <8 x double> %1056, zeroinitializer
  %1059 = select <8 x i1> %1058, <8 x double> %1056, <8 x double> %1057
  %1060 = load ptr, ptr %0, align 8
  %1061 = load i64, ptr %1060, align 8
  %1062 = icmp slt i64 %1061, 0
  br i1 %1062, label %1066, label %1063

1063:                                             ; preds = %1048
  %1064 = load ptr, ptr %84, align 8
  %1065 = getelementptr double, ptr %1064, i64 %1049
  br label %1073

1066:                                             ; preds = %1073, %1048
  %1067 = phi <8 x double> [ %1059, %1048 ], [ %1084, %1073 ]
  %1068 = getelementptr inbounds double, ptr %987, i64 %1049
  %1069 = fmul <8 x double> %1067, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  store <8 x double> %1069, ptr %1068, align 8
  %1070 = add nuw nsw i64 %1049, 8
  %1071 = load i64, ptr %992, align 8
  %1072 = icmp slt i64 %1070, %1071
  br i1 %1072, label %1048, label %995, !llvm.loop !22

1073:                                             ; preds = %1063, %1073
  %1074 = phi i64 [ 0, %1063 ], [ %1085, %1073 ]
  %1075 = phi <8 x double> [ %1059, %1063 ], [ %1084, %1073 ]
  %1076 = mul nsw i64 %1074, %983
  %1077 = getelementptr double, ptr %1065, i64 %1076
  %1078 = load <8 x double>, ptr %1077, align 8
  %1079 = fneg <8 x double> %1078
  %1080 = fcmp ogt <8 x double> %1078, zeroinitializer
  %1081 = select <8 x i1> %1080, <8 x double> %1078, <8 x double> %1079
  %1082 = fmul <8 x double> %506, %1081
  %1083 = fcmp ogt <8 x double> %1075, %1082
  %1084 = select <8 x i1> %1083, <8 x double> %1075, <8 x double> %1082
  %1085 = add nuw i64 %1074, 1
  %1086 = icmp eq i64 %1074, %1061
  br i1 %1086, label %1066, label %1073, !llvm.loop !23

1087:                                             ; preds = %1045, %995, %981
  %1088 = phi i32 [ 0, %981 ], [ 0, %995 ], [ %1047, %1045 ]
  %1089 = icmp eq i32 %1088, 0
  br label %1090

1090:                                             ; preds = %1087, %980
  %1091 = phi i1 [ false, %980 ], [ %1089, %1087 ]
  br i1 %1091, label %1134, label %1092

1092:                                             ; preds = %1090
  %1093 = load i64, ptr %425, align 8
  %1094 = getelementptr inbounds double, ptr %167, i64 %1093
  %1095 = load double, ptr %1094, align 8
  %1096 = fcmp ult double %1095, %493
  br i1 %1096, label %1134, label %1097

1097:                                             ; preds = %1092
  %1098 = load ptr, ptr %73, align 8
  %1099 = getelementptr inbounds i8, ptr %1098, i64 8
  %1100 = load i64, ptr %1099, align 8
  %1101 = load i64, ptr %83, align 8
  %1102 = load ptr, ptr %78, align 8
  %1103 = load ptr, ptr %77, align 8
  %1104 = getelementptr inbounds i8, ptr %1103, i64 48
  %1105 = load i64, ptr %1104, align 8
  %1106 = icmp slt i64 %1105, %1101
  br i1 %1106, label %1107, label %1130

1107:                                             ; preds = %1097
  %1108 = icmp sgt i64 %1100, 0
  br label %1109

1109:                                             ; preds = %1107, %1120
  %1110 = phi i64 [ %1105, %1107 ], [ %1121, %1120 ]
  %1111 = getelementptr inbounds double, ptr %1102, i64 %1110
  %1112 = load double, ptr %1111, align 8
  %1113 = load ptr, ptr %75, align 8
  %1114 = load double, ptr %1113, align 8
  %1115 = fcmp ugt double %1112, %1114
  br i1 %1115, label %1130, label %1116

1116:                                             ; preds = %1109
  br i1 %1108, label %1117, label %1120

1117:                                             ; preds = %1116
  %1118 = mul nsw i64 %1110, %1100
  %1119 = getelementptr double, ptr %1, i64 %1118
  br label %1123

1120:                                             ; preds = %1123, %1116
  %1121 = add i64 %1110, 1
  %1122 = icmp eq i64 %1121, %1101
  br i1 %1122, label %1130, label %1109, !llvm.loop !8

1123:                                             ; preds = %1117, %1123
  %1124 = phi i64 [ 0, %1117 ], [ %1128, %1123 ]
  %1125 = getelementptr inbounds double, ptr %161, i64 %1124
  %1126 = load double, ptr %1125, align 8
  %1127 = getelementptr double, ptr %1119, i64 %1124
  store double %1126, ptr %1127, align 8
  %1128 = add nuw nsw i64 %1124, 1
  %1129 = icmp eq i64 %1128, %1100
  br i1 %1129, label %1120, label %1123, !llvm.loop !9

1130:                                             ; preds = %1109, %1120, %1097
  %1131 = phi i64 [ %1105, %1097 ], [ %1110, %1109 ], [ %1101, %1120 ]
  %1132 = load ptr, ptr %77, align 8
  %1133 = getelementptr inbounds i8, ptr %1132, i64 48
  store i64 %1131, ptr %1133, align 8
  br label %1493

1134:                                             ; preds = %1092, %1090
  %1135 = load ptr, ptr %0, align 8
  %1136 = load ptr, ptr %73, align 8
  %1137 = getelementptr inbounds i8, ptr %1136, i64 16
  %1138 = load i64, ptr %1137, align 8
  %1139 = load i64, ptr %1135, align 8
  %1140 = load i64, ptr %138, align 8
  %1141 = load ptr, ptr %139, align 8
  %1142 = mul nsw i64 %1140, %1139
  %1143 = getelementptr inbounds double, ptr %1141, i64 %1142
  %1144 = load ptr, ptr %140, align 8
  %1145 = add nsw i64 %1139, 1
  %1146 = getelementptr inbounds i8, ptr %1135, i64 16
  %1147 = load i64, ptr %1146, align 8
  %1148 = icmp sgt i64 %1147, 0
  br i1 %1148, label %1149, label %1203

1149:                                             ; preds = %1134
  %1150 = getelementptr inbounds i8, ptr %1135, i64 8
  br label %1156

1151:                                             ; preds = %1192
  %1152 = add nsw i64 %1159, 1
  %1153 = load i64, ptr %1146, align 8
  %1154 = add nsw i64 %1153, %1145
  %1155 = icmp slt i64 %1152, %1154
  br i1 %1155, label %1156, label %1203, !llvm.loop !24

1156:                                             ; preds = %1149, %1151
  %1157 = phi i1 [ %1148, %1149 ], [ %1155, %1151 ]
  %1158 = phi i64 [ undef, %1149 ], [ %1202, %1151 ]
  %1159 = phi i64 [ %1145, %1149 ], [ %1152, %1151 ]
  %1160 = load i64, ptr %1150, align 8
  %1161 = load ptr, ptr %141, align 8
  %1162 = load ptr, ptr %74, align 8
  %1163 = load ptr, ptr %142, align 8
  %1164 = getelementptr i64, ptr %1163, i64 %1159
  %1165 = getelementptr i64, ptr %1164, i64 %1160
  %1166 = load i64, ptr %1165, align 8
  %1167 = getelementptr i8, ptr %1165, i64 8
  %1168 = load i64, ptr %1167, align 8
  %1169 = xor i64 %1166, -1
  %1170 = add i64 %1168, %1169
  %1171 = load ptr, ptr %94, align 8
  %1172 = load ptr, ptr %139, align 8
  %1173 = load ptr, ptr %143, align 8
  %1174 = getelementptr inbounds i64, ptr %1173, i64 %1166
  %1175 = load ptr, ptr %144, align 8
  %1176 = getelementptr inbounds double, ptr %1175, i64 %1166
  tail call fastcc void @combine(ptr noundef %1161, ptr noundef %1162, ptr noundef %1171, ptr noundef %1172, ptr noundef %1174, ptr noundef %1176, i64 noundef %1170, i64 noundef 1, i64 noundef %1138) #8
  %1177 = load ptr, ptr %139, align 8
  %1178 = mul nsw i64 %1159, %1140
  %1179 = getelementptr inbounds double, ptr %1177, i64 %1178
  %1180 = load i64, ptr %421, align 8
  %1181 = add nsw i64 %1180, 1
  store i64 %1181, ptr %421, align 8
  %1182 = load ptr, ptr %145, align 8
  %1183 = getelementptr inbounds double, ptr %1182, i64 %1159
  %1184 = load double, ptr %1183, align 8
  %1185 = fmul double %494, %1184
  %1186 = fadd double %447, %1185
  %1187 = load ptr, ptr %141, align 8
  %1188 = load ptr, ptr %146, align 8
  store double %1186, ptr %1188, align 8
  %1189 = load i64, ptr %147, align 8
  %1190 = icmp sgt i64 %1189, 0
  br i1 %1190, label %1191, label %1192

1191:                                             ; preds = %1156
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %1192

1192:                                             ; preds = %1156, %1191
  %1193 = load ptr, ptr %73, align 8
  %1194 = load i64, ptr %1193, align 8
  %1195 = load ptr, ptr %146, align 8
  %1196 = load ptr, ptr %148, align 8
  %1197 = load ptr, ptr %149, align 8
  %1198 = inttoptr i64 %1194 to ptr
  %1199 = tail call i32 %1198(ptr noundef %1195, ptr noundef %1187, ptr noundef %1196, ptr noundef %1197, ptr noundef %1179) #9
  %1200 = sext i32 %1199 to i64
  %1201 = icmp eq i32 %1199, 0
  %1202 = select i1 %1201, i64 %1158, i64 %1200
  br i1 %1201, label %1151, label %1203

1203:                                             ; preds = %1151, %1192, %1134
  %1204 = phi i1 [ %1148, %1134 ], [ %1155, %1151 ], [ %1157, %1192 ]
  %1205 = phi i64 [ 0, %1134 ], [ %1200, %1192 ], [ %1200, %1151 ]
  %1206 = phi i64 [ undef, %1134 ], [ %1202, %1192 ], [ %1202, %1151 ]
  %1207 = getelementptr inbounds i8, ptr %1135, i64 16
  br i1 %1204, label %1276, label %1208

1208:                                             ; preds = %1203
  %1209 = load ptr, ptr %73, align 8
  %1210 = getelementptr inbounds i8, ptr %1209, i64 8
  %1211 = load i64, ptr %1210, align 8
  %1212 = icmp sgt i64 %1211, 0
  br i1 %1212, label %1213, label %1217

1213:                                             ; preds = %1208
  %1214 = getelementptr inbounds double, ptr %1144, i64 %1140
  %1215 = shl nsw i64 %1140, 4
  %1216 = getelementptr inbounds i8, ptr %1144, i64 %1215
  br label %1224

1217:                                             ; preds = %1224, %1208
  %1218 = getelementptr inbounds i8, ptr %1135, i64 8
  %1219 = load i64, ptr %1218, align 8
  %1220 = load i64, ptr %1207, align 8
  %1221 = getelementptr inbounds i8, ptr %1135, i64 24
  %1222 = load i64, ptr %1221, align 8
  %1223 = icmp sgt i64 %1222, 3
  br i1 %1223, label %1251, label %1276

1224:                                             ; preds = %1213, %1224
  %1225 = phi i64 [ 0, %1213 ], [ %1246, %1224 ]
  %1226 = load ptr, ptr %150, align 8
  %1227 = getelementptr inbounds double, ptr %1226, i64 %1225
  %1228 = load double, ptr %1227, align 8
  %1229 = load ptr, ptr %74, align 8
  %1230 = getelementptr inbounds double, ptr %1229, i64 %1225
  %1231 = load double, ptr %1230, align 8
  %1232 = fsub double %1228, %1231
  %1233 = load ptr, ptr %139, align 8
  %1234 = getelementptr inbounds double, ptr %1233, i64 %1225
  %1235 = load double, ptr %1234, align 8
  %1236 = fmul double %494, %1235
  %1237 = fsub double %1236, %1232
  %1238 = getelementptr inbounds double, ptr %1144, i64 %1225
  store double %1232, ptr %1238, align 8
  %1239 = getelementptr inbounds double, ptr %1214, i64 %1225
  store double %1237, ptr %1239, align 8
  %1240 = fsub double %1232, %1237
  %1241 = getelementptr inbounds double, ptr %1143, i64 %1225
  %1242 = load double, ptr %1241, align 8
  %1243 = fmul double %494, %1242
  %1244 = fsub double %1240, %1243
  %1245 = getelementptr inbounds double, ptr %1216, i64 %1225
  store double %1244, ptr %1245, align 8
  %1246 = add nuw nsw i64 %1225, 1
  %1247 = load ptr, ptr %73, align 8
  %1248 = getelementptr inbounds i8, ptr %1247, i64 8
  %1249 = load i64, ptr %1248, align 8
  %1250 = icmp slt i64 %1246, %1249
  br i1 %1250, label %1224, label %1217, !llvm.loop !25

1251:                                             ; preds = %1217, %1251
  %1252 = phi i64 [ %1273, %1251 ], [ 3, %1217 ]
  %1253 = mul nsw i64 %1252, %1140
  %1254 = getelementptr inbounds double, ptr %1144, i64 %1253
  %1255 = load ptr, ptr %151, align 8
  %1256 = load ptr, ptr %152, align 8
  %1257 = getelementptr i64, ptr %1256, i64 %1145
  %1258 = getelementptr i64, ptr %1257, i64 %1219
  %1259 = getelementptr i64, ptr %1258, i64 %1220
  %1260 = getelementptr i64, ptr %1259, i64 %1252
  %1261 = getelementptr i8, ptr %1260, i64 -24
  %1262 = load i64, ptr %1261, align 8
  %1263 = getelementptr i8, ptr %1260, i64 -16
  %1264 = load i64, ptr %1263, align 8
  %1265 = xor i64 %1262, -1
  %1266 = add i64 %1264, %1265
  %1267 = load ptr, ptr %94, align 8
  %1268 = load ptr, ptr %139, align 8
  %1269 = load ptr, ptr %153, align 8
  %1270 = getelementptr inbounds i64, ptr %1269, i64 %1262
  %1271 = load ptr, ptr %154, align 8
  %1272 = getelementptr inbounds double, ptr %1271, i64 %1262
  tail call fastcc void @combine(ptr noundef %1254, ptr noundef %1255, ptr noundef %1267, ptr noundef %1268, ptr noundef %1270, ptr noundef %1272, i64 noundef %1266, i64 noundef 1, i64 noundef %1138) #8
  %1273 = add nuw nsw i64 %1252, 1
  %1274 = load i64, ptr %1221, align 8
  %1275 = icmp slt i64 %1273, %1274
  br i1 %1275, label %1251, label %1276, !llvm.loop !26

1276:                                             ; preds = %1251, %1217, %1203
  %1277 = phi i64 [ %1206, %1203 ], [ %1205, %1217 ], [ %1205, %1251 ]
  %1278 = icmp eq i64 %1277, 0
  br i1 %1278, label %1282, label %1279

1279:                                             ; preds = %1276
  store i64 3, ptr %426, align 8
  store double %447, ptr %160, align 8
  %1280 = icmp slt i64 %1277, 0
  %1281 = select i1 %1280, i64 -4, i64 2
  br label %1616

1282:                                             ; preds = %1276
  %1283 = load ptr, ptr %75, align 8
  br i1 %1091, label %1284, label %1295

1284:                                             ; preds = %1282
  %1285 = load ptr, ptr %82, align 8
  %1286 = getelementptr inbounds i8, ptr %1285, i64 16
  %1287 = load i64, ptr %1286, align 8
  %1288 = inttoptr i64 %1287 to ptr
  %1289 = tail call i64 %1288(ptr noundef %0, double noundef %447, double noundef %494) #9
  %1290 = icmp eq i64 %1289, -6
  br i1 %1290, label %1291, label %1292

1291:                                             ; preds = %1284
  store double %447, ptr %1283, align 8
  br label %1470

1292:                                             ; preds = %1284
  %1293 = getelementptr inbounds i8, ptr %1283, i64 48
  %1294 = load double, ptr %1293, align 8
  br label %1295

1295:                                             ; preds = %1292, %1282
  %1296 = phi double [ %1294, %1292 ], [ 1.000000e+00, %1282 ]
  %1297 = phi i64 [ %1289, %1292 ], [ 0, %1282 ]
  %1298 = fcmp oeq double %1296, 1.000000e+00
  br i1 %1298, label %1299, label %1301

1299:                                             ; preds = %1295
  %1300 = load double, ptr %1283, align 8
  br label %1304

1301:                                             ; preds = %1295
  %1302 = fmul double %494, %1296
  %1303 = fadd double %447, %1302
  br label %1304

1304:                                             ; preds = %1301, %1299
  %1305 = phi double [ %1300, %1299 ], [ %1303, %1301 ]
  %1306 = icmp eq i64 %1297, -4
  %1307 = select i1 %1306, i64 -4, i64 0
  br i1 %1306, label %1365, label %1308

1308:                                             ; preds = %1304
  %1309 = fcmp olt double %1296, 1.000000e+00
  %1310 = load ptr, ptr %73, align 8
  %1311 = getelementptr inbounds i8, ptr %1310, i64 8
  %1312 = load i64, ptr %1311, align 8
  %1313 = load i64, ptr %83, align 8
  %1314 = load ptr, ptr %78, align 8
  %1315 = load ptr, ptr %77, align 8
  %1316 = getelementptr inbounds i8, ptr %1315, i64 48
  %1317 = load i64, ptr %1316, align 8
  %1318 = icmp slt i64 %1317, %1313
  br i1 %1318, label %1319, label %1361

1319:                                             ; preds = %1308, %1357
  %1320 = phi i64 [ %1358, %1357 ], [ undef, %1308 ]
  %1321 = phi i64 [ %1359, %1357 ], [ %1317, %1308 ]
  %1322 = getelementptr inbounds double, ptr %1314, i64 %1321
  %1323 = load double, ptr %1322, align 8
  %1324 = fcmp olt double %1323, %1305
  %1325 = fcmp oeq double %1323, %1305
  %1326 = and i1 %1309, %1325
  %1327 = or i1 %1324, %1326
  br i1 %1327, label %1328, label %1361

1328:                                             ; preds = %1319
  %1329 = fsub double %1323, %447
  %1330 = fdiv double %1329, %494
  %1331 = mul nsw i64 %1321, %1312
  %1332 = getelementptr inbounds double, ptr %1, i64 %1331
  %1333 = load ptr, ptr %155, align 8
  %1334 = insertelement <8 x double> poison, double %1330, i64 0
  %1335 = shufflevector <8 x double> %1334, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1335, ptr %1333, align 8
  %1336 = load ptr, ptr %74, align 8
  %1337 = load ptr, ptr %140, align 8
  %1338 = load i64, ptr %138, align 8
  %1339 = load ptr, ptr %0, align 8
  %1340 = getelementptr inbounds i8, ptr %1339, i64 24
  %1341 = load i64, ptr %1340, align 8
  %1342 = load ptr, ptr %155, align 8
  %1343 = load ptr, ptr %73, align 8
  %1344 = getelementptr inbounds i8, ptr %1343, i64 16
  %1345 = load i64, ptr %1344, align 8
  tail call fastcc void @nested(ptr noundef %1332, ptr noundef %1336, ptr noundef %1337, i64 noundef %1338, i64 noundef %1341, ptr noundef %1342, i64 noundef %1345) #8
  %1346 = load ptr, ptr %81, align 8
  %1347 = load i64, ptr %1346, align 8
  %1348 = icmp eq i64 %1347, 1
  br i1 %1348, label %1349, label %1357

1349:                                             ; preds = %1328
  %1350 = load double, ptr %1322, align 8
  %1351 = getelementptr inbounds i8, ptr %1346, i64 56
  %1352 = load i64, ptr %1351, align 8
  %1353 = inttoptr i64 %1352 to ptr
  %1354 = tail call i64 %1353(ptr noundef %0, double noundef %1350, ptr noundef %1332, ptr noundef null) #9
  %1355 = icmp eq i64 %1354, 0
  %1356 = select i1 %1355, i64 %1320, i64 %1354
  br i1 %1355, label %1357, label %1365

1357:                                             ; preds = %1349, %1328
  %1358 = phi i64 [ %1356, %1349 ], [ %1320, %1328 ]
  %1359 = add i64 %1321, 1
  %1360 = icmp eq i64 %1359, %1313
  br i1 %1360, label %1361, label %1319, !llvm.loop !27

1361:                                             ; preds = %1357, %1319, %1308
  %1362 = phi i64 [ %1317, %1308 ], [ %1313, %1357 ], [ %1321, %1319 ]
  %1363 = load ptr, ptr %77, align 8
  %1364 = getelementptr inbounds i8, ptr %1363, i64 48
  store i64 %1362, ptr %1364, align 8
  br label %1365

1365:                                             ; preds = %1349, %1361, %1304
  %1366 = phi i64 [ %1307, %1304 ], [ 0, %1361 ], [ %1356, %1349 ]
  %1367 = icmp eq i64 %1366, 0
  %1368 = icmp ne i64 %1297, 0
  %1369 = fcmp olt double %1296, 1.000000e+00
  %1370 = and i1 %1369, %1367
  %1371 = and i1 %1368, %1370
  br i1 %1371, label %1372, label %1409

1372:                                             ; preds = %1365
  %1373 = load ptr, ptr %156, align 8
  %1374 = load ptr, ptr %157, align 8
  %1375 = insertelement <8 x double> poison, double %1296, i64 0
  %1376 = shufflevector <8 x double> %1375, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1376, ptr %1374, align 8
  %1377 = load ptr, ptr %74, align 8
  %1378 = load ptr, ptr %140, align 8
  %1379 = load i64, ptr %138, align 8
  %1380 = load ptr, ptr %0, align 8
  %1381 = getelementptr inbounds i8, ptr %1380, i64 24
  %1382 = load i64, ptr %1381, align 8
  %1383 = load ptr, ptr %157, align 8
  %1384 = load ptr, ptr %73, align 8
  %1385 = getelementptr inbounds i8, ptr %1384, i64 16
  %1386 = load i64, ptr %1385, align 8
  tail call fastcc void @nested(ptr noundef %1373, ptr noundef %1377, ptr noundef %1378, i64 noundef %1379, i64 noundef %1382, ptr noundef %1383, i64 noundef %1386) #8
  %1387 = load i64, ptr %80, align 8
  %1388 = icmp sgt i64 %1387, 0
  br i1 %1388, label %1393, label %1389

1389:                                             ; preds = %1393, %1372
  %1390 = load ptr, ptr %81, align 8
  %1391 = load i64, ptr %1390, align 8
  %1392 = icmp eq i64 %1391, 1
  br i1 %1392, label %1403, label %1409

1393:                                             ; preds = %1372, %1393
  %1394 = phi i64 [ %1400, %1393 ], [ 0, %1372 ]
  %1395 = load ptr, ptr %156, align 8
  %1396 = getelementptr inbounds double, ptr %1395, i64 %1394
  %1397 = load double, ptr %1396, align 8
  %1398 = load ptr, ptr %76, align 8
  %1399 = getelementptr inbounds double, ptr %1398, i64 %1394
  store double %1397, ptr %1399, align 8
  %1400 = add nuw nsw i64 %1394, 1
  %1401 = load i64, ptr %80, align 8
  %1402 = icmp slt i64 %1400, %1401
  br i1 %1402, label %1393, label %1389, !llvm.loop !28

1403:                                             ; preds = %1389
  %1404 = load ptr, ptr %76, align 8
  %1405 = getelementptr inbounds i8, ptr %1390, i64 56
  %1406 = load i64, ptr %1405, align 8
  %1407 = inttoptr i64 %1406 to ptr
  %1408 = tail call i64 %1407(ptr noundef %0, double noundef %1305, ptr noundef %1404, ptr noundef null) #9
  br label %1409

1409:                                             ; preds = %1403, %1389, %1365
  %1410 = phi i64 [ %1408, %1403 ], [ 0, %1389 ], [ %1366, %1365 ]
  %1411 = icmp eq i64 %1410, 0
  br i1 %1411, label %1414, label %1412

1412:                                             ; preds = %1409
  store double %447, ptr %1283, align 8
  %1413 = getelementptr inbounds i8, ptr %1283, i64 8
  store double %494, ptr %1413, align 8
  br label %1470

1414:                                             ; preds = %1409
  br i1 %1298, label %1415, label %1453

1415:                                             ; preds = %1414
  %1416 = load ptr, ptr %76, align 8
  %1417 = load ptr, ptr %73, align 8
  %1418 = getelementptr inbounds i8, ptr %1417, i64 8
  %1419 = load i64, ptr %1418, align 8
  %1420 = load i64, ptr %83, align 8
  %1421 = load ptr, ptr %78, align 8
  %1422 = load ptr, ptr %77, align 8
  %1423 = getelementptr inbounds i8, ptr %1422, i64 48
  %1424 = load i64, ptr %1423, align 8
  %1425 = icmp slt i64 %1424, %1420
  br i1 %1425, label %1426, label %1449

1426:                                             ; preds = %1415
  %1427 = icmp sgt i64 %1419, 0
  br label %1428

1428:                                             ; preds = %1426, %1439
  %1429 = phi i64 [ %1424, %1426 ], [ %1440, %1439 ]
  %1430 = getelementptr inbounds double, ptr %1421, i64 %1429
  %1431 = load double, ptr %1430, align 8
  %1432 = load ptr, ptr %75, align 8
  %1433 = load double, ptr %1432, align 8
  %1434 = fcmp ugt double %1431, %1433
  br i1 %1434, label %1449, label %1435

1435:                                             ; preds = %1428
  br i1 %1427, label %1436, label %1439

1436:                                             ; preds = %1435
  %1437 = mul nsw i64 %1429, %1419
  %1438 = getelementptr double, ptr %1, i64 %1437
  br label %1442

1439:                                             ; preds = %1442, %1435
  %1440 = add i64 %1429, 1
  %1441 = icmp eq i64 %1440, %1420
  br i1 %1441, label %1449, label %1428, !llvm.loop !8

1442:                                             ; preds = %1436, %1442
  %1443 = phi i64 [ 0, %1436 ], [ %1447, %1442 ]
  %1444 = getelementptr inbounds double, ptr %1416, i64 %1443
  %1445 = load double, ptr %1444, align 8
  %1446 = getelementptr double, ptr %1438, i64 %1443
  store double %1445, ptr %1446, align 8
  %1447 = add nuw nsw i64 %1443, 1
  %1448 = icmp eq i64 %1447, %1419
  br i1 %1448, label %1439, label %1442, !llvm.loop !9

1449:                                             ; preds = %1439, %1428, %1415
  %1450 = phi i64 [ %1424, %1415 ], [ %1420, %1439 ], [ %1429, %1428 ]
  %1451 = load ptr, ptr %77, align 8
  %1452 = getelementptr inbounds i8, ptr %1451, i64 48
  store i64 %1450, ptr %1452, align 8
  br label %1453

1453:                                             ; preds = %1449, %1414
  br i1 %1368, label %1454, label %1470

1454:                                             ; preds = %1453
  %1455 = load i64, ptr %80, align 8
  %1456 = icmp sgt i64 %1455, 0
  br i1 %1456, label %1460, label %1457

1457:                                             ; preds = %1460, %1454
  store double %1305, ptr %1283, align 8
  %1458 = getelementptr inbounds i8, ptr %1283, i64 8
  store double 0.000000e+00, ptr %1458, align 8
  %1459 = load ptr, ptr %77, align 8
  store i64 0, ptr %1459, align 8
  br label %1470

1460:                                             ; preds = %1454, %1460
  %1461 = phi i64 [ %1467, %1460 ], [ 0, %1454 ]
  %1462 = load ptr, ptr %76, align 8
  %1463 = getelementptr inbounds double, ptr %1462, i64 %1461
  %1464 = load double, ptr %1463, align 8
  %1465 = load ptr, ptr %74, align 8
  %1466 = getelementptr inbounds double, ptr %1465, i64 %1461
  store double %1464, ptr %1466, align 8
  %1467 = add nuw nsw i64 %1461, 1
  %1468 = load i64, ptr %80, align 8
  %1469 = icmp slt i64 %1467, %1468
  br i1 %1469, label %1460, label %1457, !llvm.loop !29

1470:                                             ; preds = %1291, %1412, %1453, %1457
  %1471 = phi i64 [ -6, %1291 ], [ %1410, %1412 ], [ %1297, %1457 ], [ %1297, %1453 ]
  %1472 = icmp eq i64 %1471, -6
  br i1 %1472, label %1477, label %1473

1473:                                             ; preds = %1470
  %1474 = icmp ne i64 %1471, 6
  %1475 = select i1 %1474, i1 true, i1 %176
  %1476 = select i1 %1475, i1 true, i1 %183
  br i1 %1476, label %1487, label %1477

1477:                                             ; preds = %1473, %1470
  %1478 = phi i64 [ %1471, %1473 ], [ 2, %1470 ]
  %1479 = load i64, ptr %416, align 8
  %1480 = add nsw i64 %1479, -1
  store i64 %1480, ptr %416, align 8
  %1481 = load ptr, ptr %93, align 8
  %1482 = load i64, ptr %1481, align 8
  %1483 = add nsw i64 %1482, -1
  store i64 %1483, ptr %1481, align 8
  %1484 = load i64, ptr %417, align 8
  %1485 = add nsw i64 %1484, 1
  store i64 %1485, ptr %417, align 8
  store i64 %1478, ptr %436, align 8
  store double 1.000000e+00, ptr %437, align 8
  %1486 = fmul double %494, 2.500000e-01
  br label %1616, !llvm.loop !19

1487:                                             ; preds = %1473
  %1488 = icmp eq i64 %1471, 0
  br i1 %1488, label %1493, label %1489

1489:                                             ; preds = %1487
  %1490 = load ptr, ptr %93, align 8
  %1491 = load i64, ptr %1490, align 8
  %1492 = add nsw i64 %1491, 1
  store i64 %1492, ptr %1490, align 8
  br label %1616

1493:                                             ; preds = %1487, %1130
  br i1 %176, label %1597, label %1494

1494:                                             ; preds = %1493
  %1495 = load double, ptr %428, align 8
  %1496 = fcmp ogt double %875, 1.000000e-10
  %1497 = select i1 %1496, double %875, double 1.000000e-10
  %1498 = load double, ptr %429, align 8
  %1499 = load double, ptr %430, align 8
  %1500 = fneg double %1499
  %1501 = bitcast double %1497 to i64
  %1502 = add nsw i64 %1501, -4604544271217802189
  %1503 = ashr i64 %1502, 52
  %1504 = and i64 %1502, -4503599627370496
  %1505 = sub nsw i64 %1501, %1504
  %1506 = bitcast i64 %1505 to double
  %1507 = fadd double %1506, -1.000000e+00
  %1508 = fadd double %1506, 1.000000e+00
  %1509 = fdiv double %1507, %1508
  %1510 = fmul double %1509, %1509
  %1511 = tail call double @llvm.fma.f64(double %1510, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1512 = tail call double @llvm.fma.f64(double %1511, double %1510, double 0x3FE2776C50EF9BFE)
  %1513 = tail call double @llvm.fma.f64(double %1512, double %1510, double 0x3FEEC709DC3A03FD)
  %1514 = tail call double @llvm.fma.f64(double %1513, double %1510, double 0x40071547652B82FE)
  %1515 = trunc nsw i64 %1503 to i32
  %1516 = sitofp i32 %1515 to double
  %1517 = fmul double %1509, %1514
  %1518 = fadd double %1517, %1516
  %1519 = fmul double %1518, %1500
  %1520 = fcmp ogt double %1519, -1.000000e+03
  %1521 = select i1 %1520, double %1519, double -1.000000e+03
  %1522 = fcmp olt double %1521, 1.000000e+03
  %1523 = select i1 %1522, double %1521, double 1.000000e+03
  %1524 = tail call double @llvm.rint.f64(double %1523)
  %1525 = fsub double %1523, %1524
  %1526 = tail call double @llvm.fma.f64(double %1525, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1527 = tail call double @llvm.fma.f64(double %1526, double %1525, double 0x3F55D87FE78A6730)
  %1528 = tail call double @llvm.fma.f64(double %1527, double %1525, double 0x3F83B2AB6FBA4E77)
  %1529 = tail call double @llvm.fma.f64(double %1528, double %1525, double 0x3FAC6B08D704A0BF)
  %1530 = tail call double @llvm.fma.f64(double %1529, double %1525, double 0x3FCEBFBDFF82C58E)
  %1531 = tail call double @llvm.fma.f64(double %1530, double %1525, double 0x3FE62E42FEFA39EF)
  %1532 = tail call double @llvm.fma.f64(double %1531, double %1525, double 1.000000e+00)
  %1533 = bitcast double %1532 to i64
  %1534 = fptosi double %1524 to i32
  %1535 = sext i32 %1534 to i64
  %1536 = shl nsw i64 %1535, 52
  %1537 = add nsw i64 %1536, %1533
  %1538 = bitcast i64 %1537 to double
  %1539 = fmul double %1498, %1538
  %1540 = load double, ptr %431, align 8
  %1541 = fcmp une double %1540, 0.000000e+00
  br i1 %1541, label %1542, label %1582

1542:                                             ; preds = %1494
  %1543 = load i64, ptr %427, align 8
  %1544 = add nsw i64 %1543, -4604544271217802189
  %1545 = ashr i64 %1544, 52
  %1546 = and i64 %1544, -4503599627370496
  %1547 = sub nsw i64 %1543, %1546
  %1548 = bitcast i64 %1547 to double
  %1549 = fadd double %1548, -1.000000e+00
  %1550 = fadd double %1548, 1.000000e+00
  %1551 = fdiv double %1549, %1550
  %1552 = fmul double %1551, %1551
  %1553 = tail call double @llvm.fma.f64(double %1552, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1554 = tail call double @llvm.fma.f64(double %1553, double %1552, double 0x3FE2776C50EF9BFE)
  %1555 = tail call double @llvm.fma.f64(double %1554, double %1552, double 0x3FEEC709DC3A03FD)
  %1556 = tail call double @llvm.fma.f64(double %1555, double %1552, double 0x40071547652B82FE)
  %1557 = trunc nsw i64 %1545 to i32
  %1558 = sitofp i32 %1557 to double
  %1559 = fmul double %1551, %1556
  %1560 = fadd double %1559, %1558
  %1561 = fmul double %1540, %1560
  %1562 = fcmp ogt double %1561, -1.000000e+03
  %1563 = select i1 %1562, double %1561, double -1.000000e+03
  %1564 = fcmp olt double %1563, 1.000000e+03
  %1565 = select i1 %1564, double %1563, double 1.000000e+03
  %1566 = tail call double @llvm.rint.f64(double %1565)
  %1567 = fsub double %1565, %1566
  %1568 = tail call double @llvm.fma.f64(double %1567, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1569 = tail call double @llvm.fma.f64(double %1568, double %1567, double 0x3F55D87FE78A6730)
  %1570 = tail call double @llvm.fma.f64(double %1569, double %1567, double 0x3F83B2AB6FBA4E77)
  %1571 = tail call double @llvm.fma.f64(double %1570, double %1567, double 0x3FAC6B08D704A0BF)
  %1572 = tail call double @llvm.fma.f64(double %1571, double %1567, double 0x3FCEBFBDFF82C58E)
  %1573 = tail call double @llvm.fma.f64(double %1572, double %1567, double 0x3FE62E42FEFA39EF)
  %1574 = tail call double @llvm.fma.f64(double %1573, double %1567, double 1.000000e+00)
  %1575 = bitcast double %1574 to i64
  %1576 = fptosi double %1566 to i32
  %1577 = sext i32 %1576 to i64
  %1578 = shl nsw i64 %1577, 52
  %1579 = add nsw i64 %1578, %1575
  %1580 = bitcast i64 %1579 to double
  %1581 = fmul double %1539, %1580
  br label %1582

1582:                                             ; preds = %1494, %1542
  %1583 = phi double [ %1581, %1542 ], [ %1539, %1494 ]
  %1584 = load double, ptr %432, align 8
  %1585 = fcmp ogt double %1583, %1584
  %1586 = select i1 %1585, double %1583, double %1584
  %1587 = fcmp olt double %1495, %1586
  %1588 = select i1 %1587, double %1495, double %1586
  %1589 = fmul double %494, %1588
  %1590 = fcmp oeq double %493, %187
  %1591 = fcmp ogt double %448, %1589
  %1592 = select i1 %1590, i1 %1591, i1 false
  %1593 = select i1 %1592, double %448, double %1589
  %1594 = fcmp ogt double %875, 1.000000e-04
  %1595 = select i1 %1594, double %875, double 1.000000e-04
  store double %1595, ptr %427, align 8
  %1596 = load double, ptr %433, align 8
  store double %1596, ptr %428, align 8
  br label %1597

1597:                                             ; preds = %1582, %1493
  %1598 = phi double [ %1593, %1582 ], [ %448, %1493 ]
  br i1 %434, label %1603, label %1599

1599:                                             ; preds = %1603, %1597
  %1600 = load i64, ptr %435, align 8
  %1601 = load i64, ptr %83, align 8
  %1602 = icmp eq i64 %1600, %1601
  br i1 %1602, label %1615, label %1616

1603:                                             ; preds = %1597, %1603
  %1604 = phi i64 [ %1613, %1603 ], [ 0, %1597 ]
  %1605 = getelementptr inbounds double, ptr %161, i64 %1604
  %1606 = load double, ptr %1605, align 8
  %1607 = load ptr, ptr %74, align 8
  %1608 = getelementptr inbounds double, ptr %1607, i64 %1604
  store double %1606, ptr %1608, align 8
  %1609 = getelementptr inbounds double, ptr %191, i64 %1604
  %1610 = load double, ptr %1609, align 8
  %1611 = load ptr, ptr %84, align 8
  %1612 = getelementptr inbounds double, ptr %1611, i64 %1604
  store double %1610, ptr %1612, align 8
  %1613 = add nuw nsw i64 %1604, 1
  %1614 = icmp eq i64 %1613, %170
  br i1 %1614, label %1599, label %1603, !llvm.loop !30

1615:                                             ; preds = %1599
  store double %1598, ptr %193, align 8
  br label %1616

1616:                                             ; preds = %1615, %1599, %1489, %1477, %1279, %943, %942, %863, %673, %500
  %1617 = phi double [ %448, %500 ], [ %448, %673 ], [ %448, %863 ], [ %941, %943 ], [ %941, %942 ], [ %448, %1279 ], [ %1486, %1477 ], [ %448, %1489 ], [ %1598, %1615 ], [ %1598, %1599 ]
  %1618 = phi double [ %447, %500 ], [ %447, %673 ], [ %447, %863 ], [ %447, %943 ], [ %447, %942 ], [ %447, %1279 ], [ %447, %1477 ], [ %447, %1489 ], [ %493, %1615 ], [ %493, %1599 ]
  %1619 = phi i32 [ 1, %500 ], [ 1, %673 ], [ 1, %863 ], [ 3, %943 ], [ 1, %942 ], [ 1, %1279 ], [ 3, %1477 ], [ 1, %1489 ], [ 1, %1615 ], [ 0, %1599 ]
  %1620 = phi i64 [ 2, %500 ], [ -4, %673 ], [ -4, %863 ], [ %446, %943 ], [ 2, %942 ], [ %1281, %1279 ], [ %446, %1477 ], [ %1471, %1489 ], [ 0, %1615 ], [ %446, %1599 ]
  switch i32 %1619, label %1624 [
    i32 0, label %1621
    i32 3, label %1621
  ]

1621:                                             ; preds = %1616, %1616
  %1622 = load i64, ptr %163, align 8
  %1623 = icmp eq i64 %1622, 0
  br i1 %1623, label %442, label %444, !llvm.loop !19

1624:                                             ; preds = %1616, %159, %216, %258, %442, %461, %469
  %1625 = phi i64 [ -1, %159 ], [ %219, %216 ], [ -1, %442 ], [ -5, %461 ], [ 1, %469 ], [ 0, %258 ], [ %1620, %1616 ]
  %1626 = load ptr, ptr %158, align 8
  %1627 = getelementptr inbounds i8, ptr %1626, i64 48
  %1628 = load i64, ptr %1627, align 8
  %1629 = icmp ne i64 %1625, -2
  %1630 = icmp eq i64 %1628, 0
  %1631 = select i1 %1629, i1 true, i1 %1630
  br i1 %1631, label %1639, label %1632

1632:                                             ; preds = %1624
  %1633 = inttoptr i64 %1628 to ptr
  %1634 = tail call i64 %1633(ptr noundef %0) #9
  %1635 = icmp eq i64 %1634, 8
  %1636 = select i1 %1635, i64 8, i64 %1625
  %1637 = icmp eq i64 %1634, 1
  %1638 = zext i1 %1637 to i32
  br label %1639

1639:                                             ; preds = %1624, %1632
  %1640 = phi i64 [ %1625, %1624 ], [ %1636, %1632 ]
  %1641 = phi i32 [ 0, %1624 ], [ %1638, %1632 ]
  %1642 = icmp eq i32 %1641, 0
  br i1 %1642, label %1643, label %159, !llvm.loop !31

1643:                                             ; preds = %1639
  ret i64 %1640
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
