; sources dc36436a3fee55362b5581b39d4273316b0fc4de641b998c6f8862268767909e
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
  %15 = getelementptr inbounds i8, ptr %0, i64 360
  br label %23

16:                                               ; preds = %23, %8
  %17 = getelementptr inbounds i8, ptr %0, i64 632
  %18 = load i64, ptr %17, align 8
  %19 = icmp sgt i64 %18, 0
  br i1 %19, label %20, label %34

20:                                               ; preds = %16
  %21 = getelementptr inbounds i8, ptr %0, i64 624
  %22 = getelementptr inbounds i8, ptr %0, i64 1272
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
  %35 = getelementptr inbounds i8, ptr %0, i64 656
  %36 = load i64, ptr %35, align 8
  %37 = icmp sgt i64 %36, 0
  br i1 %37, label %38, label %51

38:                                               ; preds = %34
  %39 = getelementptr inbounds i8, ptr %0, i64 648
  %40 = getelementptr inbounds i8, ptr %0, i64 1296
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
  %52 = getelementptr inbounds i8, ptr %0, i64 768
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
  %68 = getelementptr inbounds i8, ptr %0, i64 984
  %69 = load ptr, ptr %68, align 8
  %70 = mul i64 %55, 88
  %71 = getelementptr inbounds i8, ptr %69, i64 %70
  store double 0x7FF8000000000000, ptr %71, align 8
  br label %72

72:                                               ; preds = %67, %51, %3
  %73 = getelementptr inbounds i8, ptr %0, i64 144
  %74 = getelementptr inbounds i8, ptr %0, i64 360
  %75 = getelementptr inbounds i8, ptr %0, i64 624
  %76 = getelementptr inbounds i8, ptr %0, i64 384
  %77 = getelementptr inbounds i8, ptr %0, i64 648
  %78 = getelementptr inbounds i8, ptr %0, i64 672
  %79 = getelementptr inbounds i8, ptr %0, i64 120
  %80 = getelementptr inbounds i8, ptr %0, i64 368
  %81 = getelementptr inbounds i8, ptr %0, i64 696
  %82 = getelementptr inbounds i8, ptr %0, i64 768
  %83 = getelementptr inbounds i8, ptr %0, i64 680
  %84 = getelementptr inbounds i8, ptr %0, i64 528
  %85 = getelementptr inbounds i8, ptr %0, i64 320
  %86 = getelementptr inbounds i8, ptr %0, i64 312
  %87 = getelementptr inbounds i8, ptr %0, i64 336
  %88 = getelementptr inbounds i8, ptr %0, i64 168
  %89 = getelementptr inbounds i8, ptr %0, i64 248
  %90 = getelementptr inbounds i8, ptr %0, i64 192
  %91 = getelementptr inbounds i8, ptr %0, i64 216
  %92 = getelementptr inbounds i8, ptr %0, i64 528
  %93 = getelementptr inbounds i8, ptr %0, i64 408
  %94 = getelementptr inbounds i8, ptr %0, i64 408
  %95 = getelementptr inbounds i8, ptr %0, i64 368
  %96 = getelementptr inbounds i8, ptr %0, i64 1320
  %97 = getelementptr inbounds i8, ptr %0, i64 320
  %98 = getelementptr inbounds i8, ptr %0, i64 312
  %99 = getelementptr inbounds i8, ptr %0, i64 336
  %100 = getelementptr inbounds i8, ptr %0, i64 432
  %101 = getelementptr inbounds i8, ptr %0, i64 408
  %102 = getelementptr inbounds i8, ptr %0, i64 24
  %103 = getelementptr inbounds i8, ptr %0, i64 528
  %104 = getelementptr inbounds i8, ptr %0, i64 48
  %105 = getelementptr inbounds i8, ptr %0, i64 72
  %106 = getelementptr inbounds i8, ptr %0, i64 368
  %107 = getelementptr inbounds i8, ptr %0, i64 96
  %108 = getelementptr inbounds i8, ptr %0, i64 168
  %109 = getelementptr inbounds i8, ptr %0, i64 248
  %110 = getelementptr inbounds i8, ptr %0, i64 192
  %111 = getelementptr inbounds i8, ptr %0, i64 216
  %112 = getelementptr inbounds i8, ptr %0, i64 384
  %113 = getelementptr inbounds i8, ptr %0, i64 24
  %114 = getelementptr inbounds i8, ptr %0, i64 528
  %115 = getelementptr inbounds i8, ptr %0, i64 48
  %116 = getelementptr inbounds i8, ptr %0, i64 72
  %117 = getelementptr inbounds i8, ptr %0, i64 168
  %118 = getelementptr inbounds i8, ptr %0, i64 248
  %119 = getelementptr inbounds i8, ptr %0, i64 192
  %120 = getelementptr inbounds i8, ptr %0, i64 216
  %121 = getelementptr inbounds i8, ptr %0, i64 504
  %122 = getelementptr inbounds i8, ptr %0, i64 368
  %123 = getelementptr inbounds i8, ptr %0, i64 480
  %124 = getelementptr inbounds i8, ptr %0, i64 24
  %125 = getelementptr inbounds i8, ptr %0, i64 528
  %126 = getelementptr inbounds i8, ptr %0, i64 48
  %127 = getelementptr inbounds i8, ptr %0, i64 72
  %128 = getelementptr inbounds i8, ptr %0, i64 384
  %129 = getelementptr inbounds i8, ptr %0, i64 600
  %130 = getelementptr inbounds i8, ptr %0, i64 576
  %131 = getelementptr inbounds i8, ptr %0, i64 384
  %132 = getelementptr inbounds i8, ptr %0, i64 168
  %133 = getelementptr inbounds i8, ptr %0, i64 248
  %134 = getelementptr inbounds i8, ptr %0, i64 192
  %135 = getelementptr inbounds i8, ptr %0, i64 216
  %136 = getelementptr inbounds i8, ptr %0, i64 1344
  %137 = getelementptr inbounds i8, ptr %0, i64 1360
  %138 = getelementptr inbounds i8, ptr %0, i64 888
  %139 = getelementptr inbounds i8, ptr %0, i64 168
  %140 = getelementptr inbounds i8, ptr %0, i64 984
  %141 = getelementptr inbounds i8, ptr %0, i64 912
  %142 = getelementptr inbounds i8, ptr %0, i64 864
  %143 = getelementptr inbounds i8, ptr %0, i64 936
  %144 = getelementptr inbounds i8, ptr %0, i64 368
  %145 = getelementptr inbounds i8, ptr %0, i64 528
  %146 = getelementptr inbounds i8, ptr %0, i64 552
  %147 = getelementptr inbounds i8, ptr %0, i64 408
  %148 = getelementptr inbounds i8, ptr %0, i64 24
  %149 = getelementptr inbounds i8, ptr %0, i64 48
  %150 = getelementptr inbounds i8, ptr %0, i64 72
  %151 = getelementptr inbounds i8, ptr %0, i64 96
  %152 = getelementptr inbounds i8, ptr %0, i64 168
  %153 = getelementptr inbounds i8, ptr %0, i64 248
  %154 = getelementptr inbounds i8, ptr %0, i64 192
  %155 = getelementptr inbounds i8, ptr %0, i64 216
  %156 = getelementptr inbounds i8, ptr %0, i64 384
  %157 = getelementptr inbounds i8, ptr %0, i64 480
  %158 = getelementptr inbounds i8, ptr %0, i64 24
  %159 = getelementptr inbounds i8, ptr %0, i64 48
  %160 = getelementptr inbounds i8, ptr %0, i64 72
  %161 = getelementptr inbounds i8, ptr %0, i64 456
  %162 = getelementptr inbounds i8, ptr %0, i64 408
  %163 = getelementptr inbounds i8, ptr %0, i64 456
  %164 = getelementptr inbounds i8, ptr %0, i64 336
  %165 = getelementptr inbounds i8, ptr %0, i64 168
  %166 = getelementptr inbounds i8, ptr %0, i64 248
  %167 = getelementptr inbounds i8, ptr %0, i64 192
  %168 = getelementptr inbounds i8, ptr %0, i64 216
  %169 = getelementptr inbounds i8, ptr %0, i64 768
  br label %170

170:                                              ; preds = %1799, %72
  %171 = load ptr, ptr %75, align 8
  %172 = load ptr, ptr %76, align 8
  %173 = load ptr, ptr %77, align 8
  %174 = getelementptr inbounds i8, ptr %173, i64 56
  %175 = load i64, ptr %174, align 8
  %176 = icmp eq i64 %175, 0
  br i1 %176, label %1784, label %177

177:                                              ; preds = %170
  %178 = load ptr, ptr %78, align 8
  %179 = load ptr, ptr %79, align 8
  %180 = load ptr, ptr %0, align 8
  %181 = load i64, ptr %80, align 8
  %182 = load ptr, ptr %81, align 8
  %183 = load i64, ptr %182, align 8
  %184 = icmp ne i64 %183, 1
  %185 = getelementptr inbounds i8, ptr %180, i64 8
  %186 = load i64, ptr %185, align 8
  %187 = icmp slt i64 %186, 1
  %188 = getelementptr inbounds i8, ptr %180, i64 32
  %189 = load i64, ptr %188, align 8
  %190 = icmp eq i64 %189, 1
  %191 = load ptr, ptr %82, align 8
  %192 = getelementptr inbounds i8, ptr %191, i64 8
  %193 = load i64, ptr %192, align 8
  %194 = icmp sgt i64 %193, 0
  %195 = load i64, ptr %83, align 8
  %196 = getelementptr double, ptr %178, i64 %195
  %197 = getelementptr i8, ptr %196, i64 -8
  %198 = load double, ptr %197, align 8
  %199 = load ptr, ptr %84, align 8
  %200 = load i64, ptr %180, align 8
  %201 = mul nsw i64 %200, %181
  %202 = getelementptr inbounds double, ptr %199, i64 %201
  %203 = load double, ptr %171, align 8
  %204 = getelementptr inbounds i8, ptr %171, i64 8
  %205 = load double, ptr %204, align 8
  %206 = load i64, ptr %173, align 8
  %207 = icmp eq i64 %206, 0
  br i1 %207, label %208, label %468

208:                                              ; preds = %177
  %209 = load i64, ptr %85, align 8
  %210 = icmp eq i64 %209, 0
  br i1 %210, label %240, label %211

211:                                              ; preds = %208
  %212 = icmp sgt i64 %209, 0
  br i1 %212, label %213, label %228

213:                                              ; preds = %211
  %214 = load ptr, ptr %86, align 8
  br label %215

215:                                              ; preds = %213, %215
  %216 = phi i64 [ 0, %213 ], [ %226, %215 ]
  %217 = phi i64 [ %209, %213 ], [ %225, %215 ]
  %218 = add nuw nsw i64 %216, %217
  %219 = lshr i64 %218, 1
  %220 = mul i64 %219, 24
  %221 = getelementptr inbounds i8, ptr %214, i64 %220
  %222 = load double, ptr %221, align 8
  %223 = fcmp ogt double %222, %203
  %224 = add nuw nsw i64 %219, 1
  %225 = select i1 %223, i64 %219, i64 %217
  %226 = select i1 %223, i64 %216, i64 %224
  %227 = icmp slt i64 %226, %225
  br i1 %227, label %215, label %228, !llvm.loop !8

228:                                              ; preds = %215, %211
  %229 = phi i64 [ 0, %211 ], [ %226, %215 ]
  %230 = icmp slt i64 %229, %209
  br i1 %230, label %231, label %237

231:                                              ; preds = %228
  %232 = load ptr, ptr %86, align 8
  %233 = mul i64 %229, 24
  %234 = getelementptr inbounds i8, ptr %232, i64 %233
  %235 = getelementptr inbounds i8, ptr %234, i64 8
  %236 = load double, ptr %235, align 8
  br label %237

237:                                              ; preds = %231, %228
  %238 = phi double [ %236, %231 ], [ 0x7FF0000000000000, %228 ]
  %239 = load ptr, ptr %87, align 8
  store double %238, ptr %239, align 8
  br label %240

240:                                              ; preds = %237, %208
  %241 = getelementptr inbounds i8, ptr %173, i64 24
  %242 = load i64, ptr %241, align 8
  %243 = add nsw i64 %242, 1
  store i64 %243, ptr %241, align 8
  %244 = load ptr, ptr %74, align 8
  %245 = load ptr, ptr %84, align 8
  %246 = load ptr, ptr %88, align 8
  store double %203, ptr %246, align 8
  %247 = load ptr, ptr %73, align 8
  %248 = getelementptr inbounds i8, ptr %247, i64 40
  %249 = load i64, ptr %248, align 8
  %250 = icmp eq i64 %249, 0
  br i1 %250, label %252, label %251

251:                                              ; preds = %240
  tail call fastcc void @settle(ptr noundef nonnull %73) #8
  br label %252

252:                                              ; preds = %251, %240
  %253 = load i64, ptr %89, align 8
  %254 = icmp sgt i64 %253, 0
  br i1 %254, label %255, label %256

255:                                              ; preds = %252
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %256

256:                                              ; preds = %252, %255
  %257 = load ptr, ptr %73, align 8
  %258 = load i64, ptr %257, align 8
  %259 = load ptr, ptr %88, align 8
  %260 = load ptr, ptr %90, align 8
  %261 = load ptr, ptr %91, align 8
  %262 = inttoptr i64 %258 to ptr
  %263 = load ptr, ptr %262, align 8
  %264 = tail call i32 %263(ptr noundef %259, ptr noundef %244, ptr noundef %260, ptr noundef %261, ptr noundef %245) #9
  %265 = icmp eq i32 %264, 0
  br i1 %265, label %270, label %266

266:                                              ; preds = %256
  %267 = getelementptr inbounds i8, ptr %173, i64 72
  store i64 3, ptr %267, align 8
  %268 = icmp slt i32 %264, 0
  %269 = select i1 %268, i64 -4, i64 2
  br label %1784

270:                                              ; preds = %256
  store i64 1, ptr %173, align 8
  %271 = getelementptr inbounds i8, ptr %171, i64 24
  store double 1.000000e-04, ptr %271, align 8
  %272 = getelementptr inbounds i8, ptr %179, i64 40
  %273 = load double, ptr %272, align 8
  %274 = getelementptr inbounds i8, ptr %171, i64 40
  store double %273, ptr %274, align 8
  %275 = load ptr, ptr %74, align 8
  %276 = load ptr, ptr %73, align 8
  %277 = getelementptr inbounds i8, ptr %276, i64 8
  %278 = load i64, ptr %277, align 8
  %279 = load i64, ptr %83, align 8
  %280 = load ptr, ptr %78, align 8
  %281 = load ptr, ptr %77, align 8
  %282 = getelementptr inbounds i8, ptr %281, i64 48
  %283 = load i64, ptr %282, align 8
  %284 = icmp slt i64 %283, %279
  br i1 %284, label %285, label %308

285:                                              ; preds = %270
  %286 = icmp sgt i64 %278, 0
  br label %287

287:                                              ; preds = %285, %298
  %288 = phi i64 [ %283, %285 ], [ %299, %298 ]
  %289 = getelementptr inbounds double, ptr %280, i64 %288
  %290 = load double, ptr %289, align 8
  %291 = load ptr, ptr %75, align 8
  %292 = load double, ptr %291, align 8
  %293 = fcmp ugt double %290, %292
  br i1 %293, label %308, label %294

294:                                              ; preds = %287
  br i1 %286, label %295, label %298

295:                                              ; preds = %294
  %296 = mul nsw i64 %288, %278
  %297 = getelementptr double, ptr %1, i64 %296
  br label %301

298:                                              ; preds = %301, %294
  %299 = add i64 %288, 1
  %300 = icmp eq i64 %299, %279
  br i1 %300, label %308, label %287, !llvm.loop !9

301:                                              ; preds = %295, %301
  %302 = phi i64 [ 0, %295 ], [ %306, %301 ]
  %303 = getelementptr inbounds double, ptr %275, i64 %302
  %304 = load double, ptr %303, align 8
  %305 = getelementptr double, ptr %297, i64 %302
  store double %304, ptr %305, align 8
  %306 = add nuw nsw i64 %302, 1
  %307 = icmp eq i64 %306, %278
  br i1 %307, label %298, label %301, !llvm.loop !10

308:                                              ; preds = %287, %298, %270
  %309 = phi i64 [ %283, %270 ], [ %288, %287 ], [ %279, %298 ]
  %310 = load ptr, ptr %77, align 8
  %311 = getelementptr inbounds i8, ptr %310, i64 48
  store i64 %309, ptr %311, align 8
  %312 = icmp eq i64 %309, %279
  br i1 %312, label %1784, label %313

313:                                              ; preds = %308
  %314 = fcmp oeq double %205, 0.000000e+00
  br i1 %314, label %315, label %468

315:                                              ; preds = %313
  %316 = load ptr, ptr %73, align 8
  %317 = getelementptr inbounds i8, ptr %316, i64 24
  %318 = load i64, ptr %317, align 8
  %319 = load ptr, ptr %75, align 8
  %320 = getelementptr inbounds i8, ptr %319, i64 16
  %321 = load double, ptr %320, align 8
  %322 = load ptr, ptr %74, align 8
  call fastcc void @norm_to(ptr noundef nonnull %4, ptr noundef %322, ptr noundef %322, ptr noundef nonnull %74, i64 noundef %318) #8
  %323 = load double, ptr %4, align 8
  %324 = load ptr, ptr %92, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %324, ptr noundef %322, ptr noundef nonnull %74, i64 noundef %318) #8
  %325 = load double, ptr %5, align 8
  %326 = fcmp uge double %323, 1.000000e-05
  %327 = fcmp uge double %325, 1.000000e-05
  %328 = and i1 %326, %327
  %329 = fmul double %323, 1.000000e-02
  %330 = fdiv double %329, %325
  %331 = select i1 %328, double %330, double 0x3EB0C6F7A0B5ED8D
  %332 = fcmp olt double %321, %331
  %333 = select i1 %332, double %321, double %331
  %334 = load ptr, ptr %73, align 8
  %335 = getelementptr inbounds i8, ptr %334, i64 8
  %336 = load i64, ptr %335, align 8
  %337 = icmp sgt i64 %336, 0
  br i1 %337, label %368, label %338

338:                                              ; preds = %368, %315
  %339 = load ptr, ptr %77, align 8
  %340 = getelementptr inbounds i8, ptr %339, i64 24
  %341 = load i64, ptr %340, align 8
  %342 = add nsw i64 %341, 1
  store i64 %342, ptr %340, align 8
  %343 = fadd double %203, %333
  %344 = load ptr, ptr %94, align 8
  %345 = load ptr, ptr %84, align 8
  %346 = load i64, ptr %80, align 8
  %347 = getelementptr inbounds double, ptr %345, i64 %346
  %348 = load ptr, ptr %88, align 8
  store double %343, ptr %348, align 8
  %349 = load ptr, ptr %73, align 8
  %350 = getelementptr inbounds i8, ptr %349, i64 40
  %351 = load i64, ptr %350, align 8
  %352 = icmp eq i64 %351, 0
  br i1 %352, label %354, label %353

353:                                              ; preds = %338
  tail call fastcc void @settle(ptr noundef nonnull %73) #8
  br label %354

354:                                              ; preds = %353, %338
  %355 = load i64, ptr %89, align 8
  %356 = icmp sgt i64 %355, 0
  br i1 %356, label %357, label %358

357:                                              ; preds = %354
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %358

358:                                              ; preds = %354, %357
  %359 = load ptr, ptr %73, align 8
  %360 = load i64, ptr %359, align 8
  %361 = load ptr, ptr %88, align 8
  %362 = load ptr, ptr %90, align 8
  %363 = load ptr, ptr %91, align 8
  %364 = inttoptr i64 %360 to ptr
  %365 = load ptr, ptr %364, align 8
  %366 = tail call i32 %365(ptr noundef %361, ptr noundef %344, ptr noundef %362, ptr noundef %363, ptr noundef %347) #9
  %367 = icmp eq i32 %366, 0
  br i1 %367, label %387, label %385

368:                                              ; preds = %315, %368
  %369 = phi i64 [ %380, %368 ], [ 0, %315 ]
  %370 = load ptr, ptr %74, align 8
  %371 = getelementptr inbounds double, ptr %370, i64 %369
  %372 = load double, ptr %371, align 8
  %373 = load ptr, ptr %84, align 8
  %374 = getelementptr inbounds double, ptr %373, i64 %369
  %375 = load double, ptr %374, align 8
  %376 = fmul double %333, %375
  %377 = fadd double %372, %376
  %378 = load ptr, ptr %93, align 8
  %379 = getelementptr inbounds double, ptr %378, i64 %369
  store double %377, ptr %379, align 8
  %380 = add nuw nsw i64 %369, 1
  %381 = load ptr, ptr %73, align 8
  %382 = getelementptr inbounds i8, ptr %381, i64 8
  %383 = load i64, ptr %382, align 8
  %384 = icmp slt i64 %380, %383
  br i1 %384, label %368, label %338, !llvm.loop !11

385:                                              ; preds = %358
  %386 = fmul double %333, 1.000000e-03
  br label %463

387:                                              ; preds = %358
  %388 = load ptr, ptr %79, align 8
  %389 = load double, ptr %388, align 8
  %390 = load ptr, ptr %92, align 8
  %391 = load i64, ptr %95, align 8
  %392 = getelementptr inbounds double, ptr %390, i64 %391
  %393 = icmp sgt i64 %318, 0
  br i1 %393, label %394, label %403

394:                                              ; preds = %387, %394
  %395 = phi i64 [ %401, %394 ], [ 0, %387 ]
  %396 = getelementptr inbounds double, ptr %392, i64 %395
  %397 = load double, ptr %396, align 8
  %398 = getelementptr inbounds double, ptr %390, i64 %395
  %399 = load double, ptr %398, align 8
  %400 = fsub double %397, %399
  store double %400, ptr %396, align 8
  %401 = add nuw nsw i64 %395, 1
  %402 = icmp eq i64 %401, %318
  br i1 %402, label %403, label %394, !llvm.loop !12

403:                                              ; preds = %394, %387
  %404 = load ptr, ptr %74, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %392, ptr noundef %404, ptr noundef nonnull %74, i64 noundef %318) #8
  %405 = load double, ptr %6, align 8
  %406 = fdiv double %405, %333
  %407 = fcmp ogt double %325, %406
  %408 = select i1 %407, double %325, double %406
  %409 = fcmp ule double %408, 1.000000e-15
  %410 = fdiv double 1.000000e-02, %408
  %411 = select i1 %409, double 1.000000e+13, double %410
  %412 = bitcast double %411 to i64
  %413 = add nsw i64 %412, -4604544271217802189
  %414 = ashr i64 %413, 52
  %415 = and i64 %413, -4503599627370496
  %416 = sub nsw i64 %412, %415
  %417 = bitcast i64 %416 to double
  %418 = fadd double %417, -1.000000e+00
  %419 = fadd double %417, 1.000000e+00
  %420 = fdiv double %418, %419
  %421 = fmul double %420, %420
  %422 = tail call double @llvm.fma.f64(double %421, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %423 = tail call double @llvm.fma.f64(double %422, double %421, double 0x3FE2776C50EF9BFE)
  %424 = tail call double @llvm.fma.f64(double %423, double %421, double 0x3FEEC709DC3A03FD)
  %425 = tail call double @llvm.fma.f64(double %424, double %421, double 0x40071547652B82FE)
  %426 = trunc nsw i64 %414 to i32
  %427 = sitofp i32 %426 to double
  %428 = fmul double %420, %425
  %429 = fadd double %428, %427
  %430 = fmul double %389, %429
  %431 = fcmp ogt double %430, -1.000000e+03
  %432 = select i1 %431, double %430, double -1.000000e+03
  %433 = fcmp olt double %432, 1.000000e+03
  %434 = select i1 %433, double %432, double 1.000000e+03
  %435 = tail call double @llvm.rint.f64(double %434)
  %436 = fsub double %434, %435
  %437 = tail call double @llvm.fma.f64(double %436, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %438 = tail call double @llvm.fma.f64(double %437, double %436, double 0x3F55D87FE78A6730)
  %439 = tail call double @llvm.fma.f64(double %438, double %436, double 0x3F83B2AB6FBA4E77)
  %440 = tail call double @llvm.fma.f64(double %439, double %436, double 0x3FAC6B08D704A0BF)
  %441 = tail call double @llvm.fma.f64(double %440, double %436, double 0x3FCEBFBDFF82C58E)
  %442 = tail call double @llvm.fma.f64(double %441, double %436, double 0x3FE62E42FEFA39EF)
  %443 = tail call double @llvm.fma.f64(double %442, double %436, double 1.000000e+00)
  %444 = bitcast double %443 to i64
  %445 = fptosi double %435 to i32
  %446 = sext i32 %445 to i64
  %447 = shl nsw i64 %446, 52
  %448 = add nsw i64 %447, %444
  %449 = bitcast i64 %448 to double
  %450 = fmul double %333, 1.000000e-03
  %451 = fcmp olt double %450, 0x3EB0C6F7A0B5ED8D
  %452 = select i1 %451, double 0x3EB0C6F7A0B5ED8D, double %450
  %453 = fmul double %333, 1.000000e+02
  %454 = select i1 %409, double %452, double %449
  %455 = fcmp olt double %453, %454
  %456 = select i1 %455, double %453, double %454
  %457 = tail call double @llvm.fabs.f64(double %203)
  %458 = fmul double %457, 0x3D30000000000000
  %459 = fcmp ogt double %458, %456
  %460 = select i1 %459, double %458, double %456
  %461 = fcmp olt double %321, %460
  %462 = select i1 %461, double %321, double %460
  br label %463

463:                                              ; preds = %385, %403
  %464 = phi double [ %386, %385 ], [ %462, %403 ]
  %465 = tail call i1 @llvm.is.fpclass.f64(double %464, i32 639)
  br i1 %465, label %466, label %468

466:                                              ; preds = %463
  %467 = getelementptr inbounds i8, ptr %173, i64 72
  store i64 4, ptr %467, align 8
  br label %468

468:                                              ; preds = %466, %463, %313, %177
  %469 = phi double [ %464, %463 ], [ %464, %466 ], [ %205, %313 ], [ %205, %177 ]
  %470 = load i64, ptr %174, align 8
  %471 = icmp eq i64 %470, 0
  br i1 %471, label %500, label %472

472:                                              ; preds = %468
  %473 = getelementptr inbounds i8, ptr %173, i64 8
  %474 = getelementptr inbounds i8, ptr %173, i64 16
  %475 = getelementptr inbounds i8, ptr %173, i64 64
  %476 = getelementptr inbounds i8, ptr %173, i64 48
  %477 = getelementptr inbounds i8, ptr %171, i64 16
  %478 = getelementptr inbounds i8, ptr %173, i64 24
  %479 = icmp sgt i64 %181, 0
  %480 = select i1 %184, i1 %190, i1 false
  %481 = getelementptr inbounds i8, ptr %171, i64 32
  %482 = getelementptr inbounds i8, ptr %173, i64 48
  %483 = getelementptr inbounds i8, ptr %173, i64 72
  %484 = getelementptr inbounds i8, ptr %171, i64 24
  %485 = getelementptr inbounds i8, ptr %171, i64 40
  %486 = getelementptr inbounds i8, ptr %179, i64 24
  %487 = getelementptr inbounds i8, ptr %179, i64 8
  %488 = getelementptr inbounds i8, ptr %179, i64 16
  %489 = getelementptr inbounds i8, ptr %179, i64 32
  %490 = getelementptr inbounds i8, ptr %179, i64 40
  %491 = icmp sgt i64 %181, 0
  %492 = getelementptr inbounds i8, ptr %173, i64 48
  %493 = getelementptr inbounds i8, ptr %173, i64 72
  %494 = getelementptr inbounds i8, ptr %173, i64 72
  %495 = getelementptr inbounds i8, ptr %171, i64 40
  %496 = getelementptr inbounds i8, ptr %173, i64 72
  %497 = getelementptr inbounds i8, ptr %179, i64 24
  %498 = getelementptr inbounds i8, ptr %179, i64 32
  %499 = getelementptr inbounds i8, ptr %171, i64 40
  br label %502

500:                                              ; preds = %1781, %468
  %501 = phi double [ %469, %468 ], [ %1777, %1781 ]
  store double %501, ptr %204, align 8
  br label %1784

502:                                              ; preds = %472, %1781
  %503 = phi i64 [ %470, %472 ], [ %1782, %1781 ]
  %504 = phi i64 [ undef, %472 ], [ %1780, %1781 ]
  %505 = phi double [ %203, %472 ], [ %1778, %1781 ]
  %506 = phi double [ %469, %472 ], [ %1777, %1781 ]
  %507 = load ptr, ptr %96, align 8
  %508 = getelementptr inbounds i8, ptr %507, i64 8
  %509 = load i64, ptr %508, align 8
  %510 = icmp sgt i64 %509, 0
  br i1 %510, label %511, label %516

511:                                              ; preds = %502
  %512 = load i64, ptr %507, align 8
  %513 = add nsw i64 %512, 3
  %514 = icmp slt i64 %509, %513
  %515 = zext i1 %514 to i32
  br label %516

516:                                              ; preds = %502, %511
  %517 = phi i32 [ 0, %502 ], [ %515, %511 ]
  %518 = icmp eq i32 %517, 0
  br i1 %518, label %520, label %519

519:                                              ; preds = %516
  store double %506, ptr %204, align 8
  br label %1784

520:                                              ; preds = %516
  %521 = add nsw i64 %503, -1
  store i64 %521, ptr %174, align 8
  %522 = load i64, ptr %473, align 8
  %523 = load i64, ptr %474, align 8
  %524 = add nsw i64 %523, %522
  %525 = load i64, ptr %475, align 8
  %526 = icmp slt i64 %524, %525
  br i1 %526, label %528, label %527

527:                                              ; preds = %520
  store double %506, ptr %204, align 8
  br label %1784

528:                                              ; preds = %520
  %529 = load i64, ptr %97, align 8
  %530 = icmp eq i64 %529, 0
  br i1 %530, label %564, label %531

531:                                              ; preds = %528
  %532 = icmp sgt i64 %529, 0
  br i1 %532, label %533, label %548

533:                                              ; preds = %531
  %534 = load ptr, ptr %98, align 8
  br label %535

535:                                              ; preds = %533, %535
  %536 = phi i64 [ 0, %533 ], [ %546, %535 ]
  %537 = phi i64 [ %529, %533 ], [ %545, %535 ]
  %538 = add nuw nsw i64 %536, %537
  %539 = lshr i64 %538, 1
  %540 = mul i64 %539, 24
  %541 = getelementptr inbounds i8, ptr %534, i64 %540
  %542 = load double, ptr %541, align 8
  %543 = fcmp ogt double %542, %505
  %544 = add nuw nsw i64 %539, 1
  %545 = select i1 %543, i64 %539, i64 %537
  %546 = select i1 %543, i64 %536, i64 %544
  %547 = icmp slt i64 %546, %545
  br i1 %547, label %535, label %548, !llvm.loop !8

548:                                              ; preds = %535, %531
  %549 = phi i64 [ 0, %531 ], [ %546, %535 ]
  %550 = load ptr, ptr %98, align 8
  %551 = mul i64 %549, 24
  %552 = getelementptr inbounds i8, ptr %550, i64 %551
  %553 = icmp slt i64 %549, %529
  br i1 %553, label %554, label %557

554:                                              ; preds = %548
  %555 = getelementptr inbounds i8, ptr %552, i64 8
  %556 = load double, ptr %555, align 8
  br label %557

557:                                              ; preds = %554, %548
  %558 = phi double [ %556, %554 ], [ 0x7FF0000000000000, %548 ]
  %559 = load ptr, ptr %99, align 8
  store double %558, ptr %559, align 8
  %560 = load i64, ptr %97, align 8
  %561 = icmp slt i64 %549, %560
  br i1 %561, label %562, label %564

562:                                              ; preds = %557
  %563 = load double, ptr %552, align 8
  br label %564

564:                                              ; preds = %528, %557, %562
  %565 = phi double [ 0x7FF0000000000000, %528 ], [ %563, %562 ], [ 0x7FF0000000000000, %557 ]
  br i1 %187, label %566, label %570

566:                                              ; preds = %564
  %567 = load i64, ptr %476, align 8
  %568 = getelementptr inbounds double, ptr %178, i64 %567
  %569 = load double, ptr %568, align 8
  br label %570

570:                                              ; preds = %566, %564
  %571 = phi double [ %569, %566 ], [ %198, %564 ]
  %572 = fcmp olt double %571, %565
  %573 = select i1 %572, double %571, double %565
  br i1 %187, label %578, label %574

574:                                              ; preds = %570
  %575 = load double, ptr %477, align 8
  %576 = fcmp olt double %506, %575
  %577 = select i1 %576, double %506, double %575
  br label %584

578:                                              ; preds = %570
  %579 = fsub double %573, %505
  %580 = fdiv double %579, %506
  %581 = fmul double %580, 0x3FEFFFFFFFFFDCD1
  %582 = tail call double @llvm.ceil.f64(double %581)
  %583 = fdiv double %579, %582
  br label %584

584:                                              ; preds = %578, %574
  %585 = phi double [ %577, %574 ], [ %583, %578 ]
  %586 = fadd double %505, %585
  %587 = fmul double %585, 1.000000e-03
  %588 = fsub double %573, %587
  %589 = fcmp ule double %586, %588
  %590 = select i1 %589, double %586, double %573
  %591 = fsub double %590, %505
  %592 = fmul double %591, 6.250000e-02
  %593 = fadd double %505, %592
  %594 = fcmp ule double %593, %505
  %595 = fcmp une double %590, %573
  %596 = and i1 %595, %594
  br i1 %596, label %597, label %598

597:                                              ; preds = %584
  store double %591, ptr %204, align 8
  br label %1776

598:                                              ; preds = %584
  %599 = load ptr, ptr %0, align 8
  %600 = load i64, ptr %599, align 8
  %601 = load ptr, ptr %100, align 8
  %602 = insertelement <8 x double> poison, double %591, i64 0
  %603 = shufflevector <8 x double> %602, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %603, ptr %601, align 8
  %604 = icmp sgt i64 %600, 1
  br i1 %604, label %609, label %700

605:                                              ; preds = %688
  %606 = add nuw nsw i64 %612, 1
  %607 = icmp slt i64 %606, %600
  %608 = icmp eq i64 %606, %600
  br i1 %608, label %700, label %609, !llvm.loop !13

609:                                              ; preds = %598, %605
  %610 = phi i1 [ %607, %605 ], [ %604, %598 ]
  %611 = phi i64 [ %699, %605 ], [ undef, %598 ]
  %612 = phi i64 [ %606, %605 ], [ 1, %598 ]
  %613 = load ptr, ptr %101, align 8
  %614 = load ptr, ptr %74, align 8
  %615 = load ptr, ptr %73, align 8
  %616 = getelementptr inbounds i8, ptr %615, i64 16
  %617 = load i64, ptr %616, align 8
  %618 = icmp sgt i64 %617, 1
  %619 = zext i1 %618 to i64
  %620 = load ptr, ptr %102, align 8
  %621 = getelementptr inbounds i64, ptr %620, i64 %612
  %622 = load i64, ptr %621, align 8
  %623 = getelementptr i8, ptr %621, i64 8
  %624 = load i64, ptr %623, align 8
  %625 = xor i64 %622, -1
  %626 = add i64 %624, %625
  %627 = load ptr, ptr %100, align 8
  %628 = load ptr, ptr %103, align 8
  %629 = load ptr, ptr %104, align 8
  %630 = getelementptr inbounds i64, ptr %629, i64 %622
  %631 = load ptr, ptr %105, align 8
  %632 = getelementptr inbounds double, ptr %631, i64 %622
  tail call fastcc void @combine(ptr noundef %613, ptr noundef %614, ptr noundef %627, ptr noundef %628, ptr noundef %630, ptr noundef %632, i64 noundef %626, i64 noundef %619, i64 noundef %617) #8
  %633 = icmp eq i64 %617, 1
  br i1 %633, label %634, label %665

634:                                              ; preds = %609
  %635 = load ptr, ptr %102, align 8
  %636 = getelementptr i64, ptr %635, i64 %612
  %637 = getelementptr i8, ptr %636, i64 8
  %638 = load i64, ptr %637, align 8
  %639 = add nsw i64 %638, -1
  %640 = load ptr, ptr %105, align 8
  %641 = getelementptr inbounds double, ptr %640, i64 %639
  %642 = load double, ptr %641, align 8
  %643 = fmul double %591, %642
  %644 = load ptr, ptr %103, align 8
  %645 = load ptr, ptr %104, align 8
  %646 = getelementptr inbounds i64, ptr %645, i64 %639
  %647 = load i64, ptr %646, align 8
  %648 = getelementptr inbounds double, ptr %644, i64 %647
  %649 = load ptr, ptr %73, align 8
  %650 = getelementptr inbounds i8, ptr %649, i64 8
  %651 = load i64, ptr %650, align 8
  %652 = icmp sgt i64 %651, 0
  br i1 %652, label %653, label %665

653:                                              ; preds = %634, %653
  %654 = phi i64 [ %660, %653 ], [ 0, %634 ]
  %655 = getelementptr inbounds double, ptr %648, i64 %654
  %656 = load double, ptr %655, align 8
  %657 = getelementptr inbounds double, ptr %613, i64 %654
  %658 = load double, ptr %657, align 8
  %659 = tail call double @llvm.fma.f64(double %643, double %656, double %658)
  store double %659, ptr %657, align 8
  %660 = add nuw nsw i64 %654, 1
  %661 = load ptr, ptr %73, align 8
  %662 = getelementptr inbounds i8, ptr %661, i64 8
  %663 = load i64, ptr %662, align 8
  %664 = icmp slt i64 %660, %663
  br i1 %664, label %653, label %665, !llvm.loop !14

665:                                              ; preds = %653, %634, %609
  %666 = load ptr, ptr %103, align 8
  %667 = load i64, ptr %106, align 8
  %668 = mul nsw i64 %667, %612
  %669 = getelementptr inbounds double, ptr %666, i64 %668
  %670 = load i64, ptr %478, align 8
  %671 = add nsw i64 %670, 1
  store i64 %671, ptr %478, align 8
  %672 = load ptr, ptr %107, align 8
  %673 = getelementptr inbounds double, ptr %672, i64 %612
  %674 = load double, ptr %673, align 8
  %675 = fmul double %591, %674
  %676 = fadd double %505, %675
  %677 = load ptr, ptr %101, align 8
  %678 = load ptr, ptr %108, align 8
  store double %676, ptr %678, align 8
  %679 = load ptr, ptr %73, align 8
  %680 = getelementptr inbounds i8, ptr %679, i64 40
  %681 = load i64, ptr %680, align 8
  %682 = icmp eq i64 %681, 0
  br i1 %682, label %684, label %683

683:                                              ; preds = %665
  tail call fastcc void @settle(ptr noundef nonnull %73) #8
  br label %684

684:                                              ; preds = %683, %665
  %685 = load i64, ptr %109, align 8
  %686 = icmp sgt i64 %685, 0
  br i1 %686, label %687, label %688

687:                                              ; preds = %684
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %688

688:                                              ; preds = %684, %687
  %689 = load ptr, ptr %73, align 8
  %690 = load i64, ptr %689, align 8
  %691 = load ptr, ptr %108, align 8
  %692 = load ptr, ptr %110, align 8
  %693 = load ptr, ptr %111, align 8
  %694 = inttoptr i64 %690 to ptr
  %695 = load ptr, ptr %694, align 8
  %696 = tail call i32 %695(ptr noundef %691, ptr noundef %677, ptr noundef %692, ptr noundef %693, ptr noundef %669) #9
  %697 = sext i32 %696 to i64
  %698 = icmp eq i32 %696, 0
  %699 = select i1 %698, i64 %611, i64 %697
  br i1 %698, label %605, label %700

700:                                              ; preds = %605, %688, %598
  %701 = phi i1 [ %604, %598 ], [ %607, %605 ], [ %610, %688 ]
  %702 = phi i64 [ 0, %598 ], [ %697, %688 ], [ %697, %605 ]
  %703 = phi i64 [ undef, %598 ], [ %699, %688 ], [ %699, %605 ]
  br i1 %701, label %757, label %704

704:                                              ; preds = %700
  %705 = load ptr, ptr %112, align 8
  %706 = load ptr, ptr %74, align 8
  %707 = load ptr, ptr %73, align 8
  %708 = getelementptr inbounds i8, ptr %707, i64 16
  %709 = load i64, ptr %708, align 8
  %710 = icmp sgt i64 %709, 1
  %711 = zext i1 %710 to i64
  %712 = load ptr, ptr %113, align 8
  %713 = getelementptr inbounds i64, ptr %712, i64 %600
  %714 = load i64, ptr %713, align 8
  %715 = getelementptr i8, ptr %713, i64 8
  %716 = load i64, ptr %715, align 8
  %717 = xor i64 %714, -1
  %718 = add i64 %716, %717
  %719 = load ptr, ptr %100, align 8
  %720 = load ptr, ptr %114, align 8
  %721 = load ptr, ptr %115, align 8
  %722 = getelementptr inbounds i64, ptr %721, i64 %714
  %723 = load ptr, ptr %116, align 8
  %724 = getelementptr inbounds double, ptr %723, i64 %714
  tail call fastcc void @combine(ptr noundef %705, ptr noundef %706, ptr noundef %719, ptr noundef %720, ptr noundef %722, ptr noundef %724, i64 noundef %718, i64 noundef %711, i64 noundef %709) #8
  %725 = icmp eq i64 %709, 1
  br i1 %725, label %726, label %757

726:                                              ; preds = %704
  %727 = load ptr, ptr %113, align 8
  %728 = getelementptr i64, ptr %727, i64 %600
  %729 = getelementptr i8, ptr %728, i64 8
  %730 = load i64, ptr %729, align 8
  %731 = add nsw i64 %730, -1
  %732 = load ptr, ptr %116, align 8
  %733 = getelementptr inbounds double, ptr %732, i64 %731
  %734 = load double, ptr %733, align 8
  %735 = fmul double %591, %734
  %736 = load ptr, ptr %114, align 8
  %737 = load ptr, ptr %115, align 8
  %738 = getelementptr inbounds i64, ptr %737, i64 %731
  %739 = load i64, ptr %738, align 8
  %740 = getelementptr inbounds double, ptr %736, i64 %739
  %741 = load ptr, ptr %73, align 8
  %742 = getelementptr inbounds i8, ptr %741, i64 8
  %743 = load i64, ptr %742, align 8
  %744 = icmp sgt i64 %743, 0
  br i1 %744, label %745, label %757

745:                                              ; preds = %726, %745
  %746 = phi i64 [ %752, %745 ], [ 0, %726 ]
  %747 = getelementptr inbounds double, ptr %740, i64 %746
  %748 = load double, ptr %747, align 8
  %749 = getelementptr inbounds double, ptr %705, i64 %746
  %750 = load double, ptr %749, align 8
  %751 = tail call double @llvm.fma.f64(double %735, double %748, double %750)
  store double %751, ptr %749, align 8
  %752 = add nuw nsw i64 %746, 1
  %753 = load ptr, ptr %73, align 8
  %754 = getelementptr inbounds i8, ptr %753, i64 8
  %755 = load i64, ptr %754, align 8
  %756 = icmp slt i64 %752, %755
  br i1 %756, label %745, label %757, !llvm.loop !14

757:                                              ; preds = %745, %726, %704, %700
  %758 = phi i64 [ %703, %700 ], [ %702, %704 ], [ %702, %726 ], [ %702, %745 ]
  %759 = icmp eq i64 %758, 0
  %760 = select i1 %759, i1 %190, i1 false
  br i1 %760, label %761, label %784

761:                                              ; preds = %757
  %762 = load i64, ptr %478, align 8
  %763 = add nsw i64 %762, 1
  store i64 %763, ptr %478, align 8
  %764 = load ptr, ptr %117, align 8
  store double %590, ptr %764, align 8
  %765 = load ptr, ptr %73, align 8
  %766 = getelementptr inbounds i8, ptr %765, i64 40
  %767 = load i64, ptr %766, align 8
  %768 = icmp eq i64 %767, 0
  br i1 %768, label %770, label %769

769:                                              ; preds = %761
  tail call fastcc void @settle(ptr noundef nonnull %73) #8
  br label %770

770:                                              ; preds = %769, %761
  %771 = load i64, ptr %118, align 8
  %772 = icmp sgt i64 %771, 0
  br i1 %772, label %773, label %774

773:                                              ; preds = %770
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %774

774:                                              ; preds = %770, %773
  %775 = load ptr, ptr %73, align 8
  %776 = load i64, ptr %775, align 8
  %777 = load ptr, ptr %117, align 8
  %778 = load ptr, ptr %119, align 8
  %779 = load ptr, ptr %120, align 8
  %780 = inttoptr i64 %776 to ptr
  %781 = load ptr, ptr %780, align 8
  %782 = tail call i32 %781(ptr noundef %777, ptr noundef %172, ptr noundef %778, ptr noundef %779, ptr noundef %202) #9
  %783 = sext i32 %782 to i64
  br label %784

784:                                              ; preds = %774, %757
  %785 = phi i64 [ %783, %774 ], [ %758, %757 ]
  %786 = icmp slt i64 %785, 0
  br i1 %786, label %1776, label %787

787:                                              ; preds = %784
  %788 = icmp eq i64 %785, 0
  br i1 %788, label %789, label %991

789:                                              ; preds = %787
  br i1 %187, label %790, label %791

790:                                              ; preds = %789
  br i1 %479, label %940, label %949

791:                                              ; preds = %789
  %792 = load ptr, ptr %73, align 8
  %793 = load ptr, ptr %0, align 8
  %794 = getelementptr inbounds i8, ptr %792, i64 24
  %795 = load i64, ptr %794, align 8
  %796 = getelementptr inbounds i8, ptr %793, i64 8
  %797 = load i64, ptr %796, align 8
  %798 = load ptr, ptr %121, align 8
  %799 = load i64, ptr %122, align 8
  %800 = getelementptr inbounds double, ptr %798, i64 %799
  %801 = icmp sgt i64 %797, 0
  br i1 %801, label %802, label %804

802:                                              ; preds = %791
  %803 = getelementptr inbounds i8, ptr %792, i64 32
  br label %812

804:                                              ; preds = %812, %791
  %805 = icmp sgt i64 %795, 0
  br i1 %805, label %806, label %838

806:                                              ; preds = %804
  %807 = load ptr, ptr %74, align 8
  %808 = load ptr, ptr %128, align 8
  %809 = load ptr, ptr %129, align 8
  %810 = load ptr, ptr %130, align 8
  %811 = load ptr, ptr %121, align 8
  br label %896

812:                                              ; preds = %802, %812
  %813 = phi i64 [ 0, %802 ], [ %836, %812 ]
  %814 = load i64, ptr %793, align 8
  %815 = load i64, ptr %803, align 8
  %816 = load ptr, ptr %121, align 8
  %817 = load i64, ptr %122, align 8
  %818 = mul nsw i64 %817, %813
  %819 = getelementptr inbounds double, ptr %816, i64 %818
  %820 = load ptr, ptr %123, align 8
  %821 = load ptr, ptr %124, align 8
  %822 = getelementptr i64, ptr %821, i64 %814
  %823 = getelementptr i8, ptr %822, i64 8
  %824 = getelementptr i64, ptr %823, i64 %813
  %825 = load i64, ptr %824, align 8
  %826 = getelementptr i8, ptr %824, i64 8
  %827 = load i64, ptr %826, align 8
  %828 = xor i64 %825, -1
  %829 = add i64 %827, %828
  %830 = load ptr, ptr %100, align 8
  %831 = load ptr, ptr %125, align 8
  %832 = load ptr, ptr %126, align 8
  %833 = getelementptr inbounds i64, ptr %832, i64 %825
  %834 = load ptr, ptr %127, align 8
  %835 = getelementptr inbounds double, ptr %834, i64 %825
  tail call fastcc void @combine(ptr noundef %819, ptr noundef %820, ptr noundef %830, ptr noundef %831, ptr noundef %833, ptr noundef %835, i64 noundef %829, i64 noundef 1, i64 noundef %815) #8
  %836 = add nuw nsw i64 %813, 1
  %837 = icmp eq i64 %836, %797
  br i1 %837, label %804, label %812, !llvm.loop !15

838:                                              ; preds = %896, %804
  %839 = phi double [ 0.000000e+00, %804 ], [ %924, %896 ]
  %840 = phi double [ 0.000000e+00, %804 ], [ %922, %896 ]
  %841 = load ptr, ptr %131, align 8
  %842 = getelementptr inbounds i8, ptr %792, i64 8
  %843 = load i64, ptr %842, align 8
  %844 = add nsw i64 %843, -3
  %845 = getelementptr i8, ptr %841, i64 8
  %846 = getelementptr i8, ptr %841, i64 16
  %847 = getelementptr i8, ptr %841, i64 24
  %848 = icmp slt i64 %795, %844
  br i1 %848, label %856, label %849

849:                                              ; preds = %856, %838
  %850 = phi double [ 0.000000e+00, %838 ], [ %865, %856 ]
  %851 = phi double [ 0.000000e+00, %838 ], [ %869, %856 ]
  %852 = phi double [ 0.000000e+00, %838 ], [ %873, %856 ]
  %853 = phi double [ 0.000000e+00, %838 ], [ %877, %856 ]
  %854 = phi i64 [ %795, %838 ], [ %878, %856 ]
  %855 = icmp slt i64 %854, %843
  br i1 %855, label %880, label %889

856:                                              ; preds = %838, %856
  %857 = phi i64 [ %878, %856 ], [ %795, %838 ]
  %858 = phi double [ %877, %856 ], [ 0.000000e+00, %838 ]
  %859 = phi double [ %873, %856 ], [ 0.000000e+00, %838 ]
  %860 = phi double [ %869, %856 ], [ 0.000000e+00, %838 ]
  %861 = phi double [ %865, %856 ], [ 0.000000e+00, %838 ]
  %862 = getelementptr inbounds double, ptr %841, i64 %857
  %863 = load double, ptr %862, align 8
  %864 = fmul double %863, 0.000000e+00
  %865 = fadd double %861, %864
  %866 = getelementptr double, ptr %845, i64 %857
  %867 = load double, ptr %866, align 8
  %868 = fmul double %867, 0.000000e+00
  %869 = fadd double %860, %868
  %870 = getelementptr double, ptr %846, i64 %857
  %871 = load double, ptr %870, align 8
  %872 = fmul double %871, 0.000000e+00
  %873 = fadd double %859, %872
  %874 = getelementptr double, ptr %847, i64 %857
  %875 = load double, ptr %874, align 8
  %876 = fmul double %875, 0.000000e+00
  %877 = fadd double %858, %876
  %878 = add nsw i64 %857, 4
  %879 = icmp slt i64 %878, %844
  br i1 %879, label %856, label %849, !llvm.loop !16

880:                                              ; preds = %849, %880
  %881 = phi i64 [ %887, %880 ], [ %854, %849 ]
  %882 = phi double [ %886, %880 ], [ %850, %849 ]
  %883 = getelementptr inbounds double, ptr %841, i64 %881
  %884 = load double, ptr %883, align 8
  %885 = fmul double %884, 0.000000e+00
  %886 = fadd double %882, %885
  %887 = add nsw i64 %881, 1
  %888 = icmp eq i64 %887, %843
  br i1 %888, label %889, label %880, !llvm.loop !17

889:                                              ; preds = %880, %849
  %890 = phi double [ %850, %849 ], [ %886, %880 ]
  %891 = fadd double %851, %890
  %892 = fadd double %852, %853
  %893 = fadd double %892, %891
  %894 = fadd double %840, %893
  %895 = icmp eq i64 %797, 2
  br i1 %895, label %927, label %936

896:                                              ; preds = %806, %896
  %897 = phi double [ 0.000000e+00, %806 ], [ %922, %896 ]
  %898 = phi double [ 0.000000e+00, %806 ], [ %924, %896 ]
  %899 = phi i64 [ 0, %806 ], [ %925, %896 ]
  %900 = getelementptr inbounds double, ptr %807, i64 %899
  %901 = load double, ptr %900, align 8
  %902 = getelementptr inbounds double, ptr %808, i64 %899
  %903 = load double, ptr %902, align 8
  %904 = getelementptr inbounds double, ptr %809, i64 %899
  %905 = load double, ptr %904, align 8
  %906 = getelementptr inbounds double, ptr %810, i64 %899
  %907 = load double, ptr %906, align 8
  %908 = tail call double @llvm.fabs.f64(double %901)
  %909 = tail call double @llvm.fabs.f64(double %903)
  %910 = fcmp ogt double %908, %909
  %911 = select i1 %910, double %908, double %909
  %912 = fmul double %911, %907
  %913 = fadd double %905, %912
  %914 = fdiv double 1.000000e+00, %913
  %915 = getelementptr inbounds double, ptr %811, i64 %899
  %916 = load double, ptr %915, align 8
  %917 = fmul double %916, %914
  %918 = getelementptr inbounds double, ptr %800, i64 %899
  %919 = load double, ptr %918, align 8
  %920 = fmul double %919, %914
  %921 = fmul double %917, %917
  %922 = fadd double %897, %921
  %923 = fmul double %920, %920
  %924 = fadd double %898, %923
  %925 = add nuw nsw i64 %899, 1
  %926 = icmp eq i64 %925, %795
  br i1 %926, label %838, label %896, !llvm.loop !18

927:                                              ; preds = %889
  %928 = fmul double %839, 1.000000e-02
  %929 = fadd double %928, %894
  %930 = sitofp i64 %795 to double
  %931 = fmul double %929, %930
  %932 = tail call double @llvm.sqrt.f64(double %931)
  %933 = fdiv double %894, %932
  %934 = fcmp une double %894, 0.000000e+00
  %935 = select i1 %934, double %933, double 0.000000e+00
  br label %949

936:                                              ; preds = %889
  %937 = sitofp i64 %795 to double
  %938 = fdiv double %894, %937
  %939 = tail call double @llvm.sqrt.f64(double %938)
  br label %949

940:                                              ; preds = %790, %940
  %941 = phi i64 [ %947, %940 ], [ 0, %790 ]
  %942 = phi double [ %946, %940 ], [ 0.000000e+00, %790 ]
  %943 = getelementptr inbounds double, ptr %172, i64 %941
  %944 = load double, ptr %943, align 8
  %945 = fmul double %944, 0.000000e+00
  %946 = fadd double %942, %945
  %947 = add nuw nsw i64 %941, 1
  %948 = icmp eq i64 %947, %181
  br i1 %948, label %949, label %940, !llvm.loop !19

949:                                              ; preds = %940, %790, %936, %927
  %950 = phi double [ %935, %927 ], [ %939, %936 ], [ 0.000000e+00, %790 ], [ %946, %940 ]
  %951 = fcmp uge double %950, 1.000000e+00
  %952 = select i1 %951, i1 true, i1 %480
  br i1 %952, label %991, label %953

953:                                              ; preds = %949
  br i1 %184, label %965, label %954

954:                                              ; preds = %953
  br i1 %187, label %957, label %955

955:                                              ; preds = %954
  %956 = load ptr, ptr %74, align 8
  br label %957

957:                                              ; preds = %955, %954
  %958 = phi ptr [ %956, %955 ], [ null, %954 ]
  %959 = load ptr, ptr %81, align 8
  %960 = getelementptr inbounds i8, ptr %959, i64 56
  %961 = load i64, ptr %960, align 8
  %962 = inttoptr i64 %961 to ptr
  %963 = tail call i64 %962(ptr noundef %0, double noundef %590, ptr noundef %172, ptr noundef %958) #9
  %964 = icmp ne i64 %963, 0
  br label %965

965:                                              ; preds = %957, %953
  %966 = phi i1 [ false, %953 ], [ %964, %957 ]
  br i1 %966, label %991, label %967

967:                                              ; preds = %965
  %968 = load i64, ptr %478, align 8
  %969 = add nsw i64 %968, 1
  store i64 %969, ptr %478, align 8
  %970 = load ptr, ptr %132, align 8
  store double %590, ptr %970, align 8
  %971 = load ptr, ptr %73, align 8
  %972 = getelementptr inbounds i8, ptr %971, i64 40
  %973 = load i64, ptr %972, align 8
  %974 = icmp eq i64 %973, 0
  br i1 %974, label %976, label %975

975:                                              ; preds = %967
  tail call fastcc void @settle(ptr noundef nonnull %73) #8
  br label %976

976:                                              ; preds = %975, %967
  %977 = load i64, ptr %133, align 8
  %978 = icmp sgt i64 %977, 0
  br i1 %978, label %979, label %980

979:                                              ; preds = %976
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %980

980:                                              ; preds = %976, %979
  %981 = load ptr, ptr %73, align 8
  %982 = load i64, ptr %981, align 8
  %983 = load ptr, ptr %132, align 8
  %984 = load ptr, ptr %134, align 8
  %985 = load ptr, ptr %135, align 8
  %986 = inttoptr i64 %982 to ptr
  %987 = load ptr, ptr %986, align 8
  %988 = tail call i32 %987(ptr noundef %983, ptr noundef %172, ptr noundef %984, ptr noundef %985, ptr noundef %202) #9
  %989 = sext i32 %988 to i64
  %990 = icmp slt i32 %988, 0
  br i1 %990, label %1776, label %991

991:                                              ; preds = %980, %965, %949, %787
  %992 = phi i64 [ 0, %965 ], [ %989, %980 ], [ 0, %949 ], [ %785, %787 ]
  %993 = phi double [ %950, %965 ], [ %950, %980 ], [ %950, %949 ], [ 0.000000e+00, %787 ]
  %994 = phi i1 [ %966, %965 ], [ %966, %980 ], [ false, %949 ], [ false, %787 ]
  %995 = icmp ne i64 %992, 0
  %996 = fcmp uge double %993, 1.000000e+00
  %997 = or i1 %995, %996
  %998 = or i1 %994, %997
  br i1 %998, label %999, label %1062

999:                                              ; preds = %991
  %1000 = load i64, ptr %474, align 8
  %1001 = add nsw i64 %1000, 1
  store i64 %1001, ptr %474, align 8
  %1002 = or i1 %995, %994
  br i1 %1002, label %1006, label %1003

1003:                                             ; preds = %999
  %1004 = tail call double @llvm.fabs.f64(double %993)
  %1005 = fcmp one double %1004, 0x7FF0000000000000
  br label %1006

1006:                                             ; preds = %1003, %999
  %1007 = phi i1 [ false, %999 ], [ %1005, %1003 ]
  %1008 = select i1 %1007, i64 2, i64 4
  %1009 = select i1 %994, i64 6, i64 %1008
  %1010 = select i1 %995, i64 3, i64 %1009
  store i64 %1010, ptr %496, align 8
  %1011 = fcmp ogt double %993, 1.000000e-10
  %1012 = select i1 %1011, double %993, double 1.000000e-10
  %1013 = load double, ptr %497, align 8
  %1014 = load double, ptr %179, align 8
  %1015 = fneg double %1014
  %1016 = bitcast double %1012 to i64
  %1017 = add nsw i64 %1016, -4604544271217802189
  %1018 = ashr i64 %1017, 52
  %1019 = and i64 %1017, -4503599627370496
  %1020 = sub nsw i64 %1016, %1019
  %1021 = bitcast i64 %1020 to double
  %1022 = fadd double %1021, -1.000000e+00
  %1023 = fadd double %1021, 1.000000e+00
  %1024 = fdiv double %1022, %1023
  %1025 = fmul double %1024, %1024
  %1026 = tail call double @llvm.fma.f64(double %1025, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1027 = tail call double @llvm.fma.f64(double %1026, double %1025, double 0x3FE2776C50EF9BFE)
  %1028 = tail call double @llvm.fma.f64(double %1027, double %1025, double 0x3FEEC709DC3A03FD)
  %1029 = tail call double @llvm.fma.f64(double %1028, double %1025, double 0x40071547652B82FE)
  %1030 = trunc nsw i64 %1018 to i32
  %1031 = sitofp i32 %1030 to double
  %1032 = fmul double %1024, %1029
  %1033 = fadd double %1032, %1031
  %1034 = fmul double %1033, %1015
  %1035 = fcmp ogt double %1034, -1.000000e+03
  %1036 = select i1 %1035, double %1034, double -1.000000e+03
  %1037 = fcmp olt double %1036, 1.000000e+03
  %1038 = select i1 %1037, double %1036, double 1.000000e+03
  %1039 = tail call double @llvm.rint.f64(double %1038)
  %1040 = fsub double %1038, %1039
  %1041 = tail call double @llvm.fma.f64(double %1040, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1042 = tail call double @llvm.fma.f64(double %1041, double %1040, double 0x3F55D87FE78A6730)
  %1043 = tail call double @llvm.fma.f64(double %1042, double %1040, double 0x3F83B2AB6FBA4E77)
  %1044 = tail call double @llvm.fma.f64(double %1043, double %1040, double 0x3FAC6B08D704A0BF)
  %1045 = tail call double @llvm.fma.f64(double %1044, double %1040, double 0x3FCEBFBDFF82C58E)
  %1046 = tail call double @llvm.fma.f64(double %1045, double %1040, double 0x3FE62E42FEFA39EF)
  %1047 = tail call double @llvm.fma.f64(double %1046, double %1040, double 1.000000e+00)
  %1048 = bitcast double %1047 to i64
  %1049 = fptosi double %1039 to i32
  %1050 = sext i32 %1049 to i64
  %1051 = shl nsw i64 %1050, 52
  %1052 = add nsw i64 %1051, %1048
  %1053 = bitcast i64 %1052 to double
  %1054 = fmul double %1013, %1053
  %1055 = load double, ptr %498, align 8
  %1056 = fcmp ogt double %1054, %1055
  %1057 = select i1 %1056, double %1054, double %1055
  %1058 = select i1 %1007, double %1057, double 2.500000e-01
  %1059 = fmul double %591, %1058
  br i1 %187, label %1060, label %1061

1060:                                             ; preds = %1006
  store double %591, ptr %204, align 8
  br label %1776

1061:                                             ; preds = %1006
  store double 1.000000e+00, ptr %499, align 8
  br label %1776, !llvm.loop !20

1062:                                             ; preds = %991
  %1063 = load i64, ptr %473, align 8
  %1064 = add nsw i64 %1063, 1
  store i64 %1064, ptr %473, align 8
  store double %590, ptr %171, align 8
  store double %591, ptr %481, align 8
  %1065 = load ptr, ptr %96, align 8
  %1066 = getelementptr inbounds i8, ptr %1065, i64 8
  %1067 = load i64, ptr %1066, align 8
  %1068 = icmp eq i64 %1067, 0
  br i1 %1068, label %1098, label %1069

1069:                                             ; preds = %1062
  %1070 = load i64, ptr %1065, align 8
  %1071 = load ptr, ptr %73, align 8
  %1072 = getelementptr inbounds i8, ptr %1071, i64 8
  %1073 = load i64, ptr %1072, align 8
  %1074 = load ptr, ptr %136, align 8
  %1075 = load i64, ptr %137, align 8
  %1076 = mul nsw i64 %1075, %1070
  %1077 = getelementptr inbounds double, ptr %1074, i64 %1076
  %1078 = getelementptr inbounds double, ptr %1077, i64 %1075
  store double %505, ptr %1077, align 8
  %1079 = getelementptr inbounds i8, ptr %1077, i64 8
  store double %591, ptr %1079, align 8
  store double %590, ptr %1078, align 8
  %1080 = getelementptr inbounds i8, ptr %1078, i64 8
  store double 0.000000e+00, ptr %1080, align 8
  %1081 = icmp sgt i64 %1073, 0
  br i1 %1081, label %1085, label %1082

1082:                                             ; preds = %1085, %1069
  %1083 = add nsw i64 %1070, 1
  %1084 = load ptr, ptr %96, align 8
  store i64 %1083, ptr %1084, align 8
  br label %1098

1085:                                             ; preds = %1069, %1085
  %1086 = phi i64 [ %1096, %1085 ], [ 0, %1069 ]
  %1087 = load ptr, ptr %74, align 8
  %1088 = getelementptr inbounds double, ptr %1087, i64 %1086
  %1089 = load double, ptr %1088, align 8
  %1090 = add nuw nsw i64 %1086, 2
  %1091 = getelementptr inbounds double, ptr %1077, i64 %1090
  store double %1089, ptr %1091, align 8
  %1092 = load ptr, ptr %76, align 8
  %1093 = getelementptr inbounds double, ptr %1092, i64 %1086
  %1094 = load double, ptr %1093, align 8
  %1095 = getelementptr inbounds double, ptr %1078, i64 %1090
  store double %1094, ptr %1095, align 8
  %1096 = add nuw nsw i64 %1086, 1
  %1097 = icmp eq i64 %1096, %1073
  br i1 %1097, label %1082, label %1085, !llvm.loop !21

1098:                                             ; preds = %1062, %1082
  br i1 %194, label %1099, label %1209

1099:                                             ; preds = %1098
  %1100 = load ptr, ptr %82, align 8
  %1101 = load i64, ptr %80, align 8
  %1102 = load ptr, ptr %138, align 8
  %1103 = getelementptr inbounds i8, ptr %1100, i64 32
  %1104 = load i64, ptr %1103, align 8
  %1105 = getelementptr inbounds double, ptr %1102, i64 %1104
  %1106 = getelementptr inbounds i8, ptr %1100, i64 24
  %1107 = load i64, ptr %1106, align 8
  %1108 = icmp eq i64 %1107, 0
  br i1 %1108, label %1206, label %1109

1109:                                             ; preds = %1099
  %1110 = getelementptr inbounds i8, ptr %1100, i64 40
  %1111 = load i64, ptr %1110, align 8
  %1112 = icmp sgt i64 %1111, 0
  br i1 %1112, label %1167, label %1113

1113:                                             ; preds = %1185, %1109
  %1114 = load ptr, ptr %139, align 8
  %1115 = load ptr, ptr %82, align 8
  %1116 = getelementptr inbounds i8, ptr %1115, i64 8
  %1117 = load i64, ptr %1116, align 8
  %1118 = load ptr, ptr %140, align 8
  %1119 = load ptr, ptr %138, align 8
  %1120 = getelementptr inbounds i8, ptr %1115, i64 32
  %1121 = load i64, ptr %1120, align 8
  %1122 = getelementptr inbounds i8, ptr %1115, i64 40
  %1123 = load i64, ptr %1122, align 8
  %1124 = getelementptr double, ptr %1119, i64 %1121
  %1125 = getelementptr double, ptr %1124, i64 %1123
  store double %591, ptr %1125, align 8
  %1126 = load ptr, ptr %139, align 8
  store double %505, ptr %1126, align 8
  %1127 = load ptr, ptr %82, align 8
  %1128 = getelementptr inbounds i8, ptr %1127, i64 24
  %1129 = load i64, ptr %1128, align 8
  %1130 = load ptr, ptr %74, align 8
  %1131 = load ptr, ptr %138, align 8
  %1132 = load ptr, ptr %141, align 8
  %1133 = inttoptr i64 %1129 to ptr
  %1134 = load ptr, ptr %1133, align 8
  %1135 = tail call i32 %1134(ptr noundef %1114, ptr noundef %1130, ptr noundef %1131, ptr noundef %1132, ptr noundef %1118) #9
  %1136 = icmp eq i32 %1135, 0
  br i1 %1136, label %1137, label %1206

1137:                                             ; preds = %1113
  %1138 = icmp slt i64 %1117, 1
  br i1 %1138, label %1164, label %1139

1139:                                             ; preds = %1137
  %1140 = load ptr, ptr %142, align 8
  %1141 = getelementptr double, ptr %1118, i64 %1117
  br label %1142

1142:                                             ; preds = %1139, %1160
  %1143 = phi i1 [ %1138, %1139 ], [ %1162, %1160 ]
  %1144 = phi i64 [ 0, %1139 ], [ %1161, %1160 ]
  %1145 = getelementptr inbounds i64, ptr %1140, i64 %1144
  %1146 = load i64, ptr %1145, align 8
  %1147 = and i64 %1146, 2
  %1148 = icmp eq i64 %1147, 0
  br i1 %1148, label %1149, label %1160

1149:                                             ; preds = %1142
  %1150 = getelementptr inbounds double, ptr %1118, i64 %1144
  %1151 = load double, ptr %1150, align 8
  %1152 = load ptr, ptr %143, align 8
  %1153 = getelementptr inbounds i64, ptr %1152, i64 %1144
  %1154 = load i64, ptr %1153, align 8
  %1155 = sitofp i64 %1154 to double
  %1156 = fmul double %1151, %1155
  %1157 = getelementptr double, ptr %1141, i64 %1144
  %1158 = load double, ptr %1157, align 8
  %1159 = fcmp ogt double %1156, %1158
  br i1 %1159, label %1160, label %1164

1160:                                             ; preds = %1149, %1142
  %1161 = add nuw nsw i64 %1144, 1
  %1162 = icmp sge i64 %1161, %1117
  %1163 = icmp eq i64 %1161, %1117
  br i1 %1163, label %1164, label %1142, !llvm.loop !22

1164:                                             ; preds = %1160, %1149, %1137
  %1165 = phi i1 [ %1138, %1137 ], [ %1162, %1160 ], [ %1143, %1149 ]
  %1166 = zext i1 %1165 to i32
  br label %1206

1167:                                             ; preds = %1109, %1185
  %1168 = phi i64 [ %1189, %1185 ], [ 0, %1109 ]
  %1169 = load ptr, ptr %76, align 8
  %1170 = getelementptr inbounds double, ptr %1169, i64 %1168
  %1171 = load <8 x double>, ptr %1170, align 8
  %1172 = load ptr, ptr %74, align 8
  %1173 = getelementptr inbounds double, ptr %1172, i64 %1168
  %1174 = load <8 x double>, ptr %1173, align 8
  %1175 = fsub <8 x double> %1171, %1174
  %1176 = fneg <8 x double> %1175
  %1177 = fcmp ogt <8 x double> %1175, zeroinitializer
  %1178 = select <8 x i1> %1177, <8 x double> %1175, <8 x double> %1176
  %1179 = load ptr, ptr %0, align 8
  %1180 = load i64, ptr %1179, align 8
  %1181 = icmp slt i64 %1180, 0
  br i1 %1181, label %1185, label %1182

1182:                                             ; preds = %1167
  %1183 = load ptr, ptr %84, align 8
  %1184 = getelementptr double, ptr %1183, i64 %1168
  br label %1192

1185:                                             ; preds = %1192, %1167
  %1186 = phi <8 x double> [ %1178, %1167 ], [ %1203, %1192 ]
  %1187 = getelementptr inbounds double, ptr %1105, i64 %1168
  %1188 = fmul <8 x double> %1186, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  store <8 x double> %1188, ptr %1187, align 8
  %1189 = add nuw nsw i64 %1168, 8
  %1190 = load i64, ptr %1110, align 8
  %1191 = icmp slt i64 %1189, %1190
  br i1 %1191, label %1167, label %1113, !llvm.loop !23

1192:                                             ; preds = %1182, %1192
  %1193 = phi i64 [ 0, %1182 ], [ %1204, %1192 ]
  %1194 = phi <8 x double> [ %1178, %1182 ], [ %1203, %1192 ]
  %1195 = mul nsw i64 %1193, %1101
  %1196 = getelementptr double, ptr %1184, i64 %1195
  %1197 = load <8 x double>, ptr %1196, align 8
  %1198 = fneg <8 x double> %1197
  %1199 = fcmp ogt <8 x double> %1197, zeroinitializer
  %1200 = select <8 x i1> %1199, <8 x double> %1197, <8 x double> %1198
  %1201 = fmul <8 x double> %603, %1200
  %1202 = fcmp ogt <8 x double> %1194, %1201
  %1203 = select <8 x i1> %1202, <8 x double> %1194, <8 x double> %1201
  %1204 = add nuw i64 %1193, 1
  %1205 = icmp eq i64 %1193, %1180
  br i1 %1205, label %1185, label %1192, !llvm.loop !24

1206:                                             ; preds = %1164, %1113, %1099
  %1207 = phi i32 [ 0, %1099 ], [ 0, %1113 ], [ %1166, %1164 ]
  %1208 = icmp eq i32 %1207, 0
  br label %1209

1209:                                             ; preds = %1206, %1098
  %1210 = phi i1 [ false, %1098 ], [ %1208, %1206 ]
  br i1 %1210, label %1253, label %1211

1211:                                             ; preds = %1209
  %1212 = load i64, ptr %482, align 8
  %1213 = getelementptr inbounds double, ptr %178, i64 %1212
  %1214 = load double, ptr %1213, align 8
  %1215 = fcmp ult double %1214, %590
  br i1 %1215, label %1253, label %1216

1216:                                             ; preds = %1211
  %1217 = load ptr, ptr %73, align 8
  %1218 = getelementptr inbounds i8, ptr %1217, i64 8
  %1219 = load i64, ptr %1218, align 8
  %1220 = load i64, ptr %83, align 8
  %1221 = load ptr, ptr %78, align 8
  %1222 = load ptr, ptr %77, align 8
  %1223 = getelementptr inbounds i8, ptr %1222, i64 48
  %1224 = load i64, ptr %1223, align 8
  %1225 = icmp slt i64 %1224, %1220
  br i1 %1225, label %1226, label %1249

1226:                                             ; preds = %1216
  %1227 = icmp sgt i64 %1219, 0
  br label %1228

1228:                                             ; preds = %1226, %1239
  %1229 = phi i64 [ %1224, %1226 ], [ %1240, %1239 ]
  %1230 = getelementptr inbounds double, ptr %1221, i64 %1229
  %1231 = load double, ptr %1230, align 8
  %1232 = load ptr, ptr %75, align 8
  %1233 = load double, ptr %1232, align 8
  %1234 = fcmp ugt double %1231, %1233
  br i1 %1234, label %1249, label %1235

1235:                                             ; preds = %1228
  br i1 %1227, label %1236, label %1239

1236:                                             ; preds = %1235
  %1237 = mul nsw i64 %1229, %1219
  %1238 = getelementptr double, ptr %1, i64 %1237
  br label %1242

1239:                                             ; preds = %1242, %1235
  %1240 = add i64 %1229, 1
  %1241 = icmp eq i64 %1240, %1220
  br i1 %1241, label %1249, label %1228, !llvm.loop !9

1242:                                             ; preds = %1236, %1242
  %1243 = phi i64 [ 0, %1236 ], [ %1247, %1242 ]
  %1244 = getelementptr inbounds double, ptr %172, i64 %1243
  %1245 = load double, ptr %1244, align 8
  %1246 = getelementptr double, ptr %1238, i64 %1243
  store double %1245, ptr %1246, align 8
  %1247 = add nuw nsw i64 %1243, 1
  %1248 = icmp eq i64 %1247, %1219
  br i1 %1248, label %1239, label %1242, !llvm.loop !10

1249:                                             ; preds = %1228, %1239, %1216
  %1250 = phi i64 [ %1224, %1216 ], [ %1229, %1228 ], [ %1220, %1239 ]
  %1251 = load ptr, ptr %77, align 8
  %1252 = getelementptr inbounds i8, ptr %1251, i64 48
  store i64 %1250, ptr %1252, align 8
  br label %1619

1253:                                             ; preds = %1211, %1209
  %1254 = load ptr, ptr %0, align 8
  %1255 = load ptr, ptr %73, align 8
  %1256 = getelementptr inbounds i8, ptr %1255, i64 16
  %1257 = load i64, ptr %1256, align 8
  %1258 = load i64, ptr %1254, align 8
  %1259 = load i64, ptr %144, align 8
  %1260 = load ptr, ptr %145, align 8
  %1261 = mul nsw i64 %1259, %1258
  %1262 = getelementptr inbounds double, ptr %1260, i64 %1261
  %1263 = load ptr, ptr %146, align 8
  %1264 = add nsw i64 %1258, 1
  %1265 = getelementptr inbounds i8, ptr %1254, i64 16
  %1266 = load i64, ptr %1265, align 8
  %1267 = icmp sgt i64 %1266, 0
  br i1 %1267, label %1268, label %1329

1268:                                             ; preds = %1253
  %1269 = getelementptr inbounds i8, ptr %1254, i64 8
  br label %1275

1270:                                             ; preds = %1317
  %1271 = add nsw i64 %1278, 1
  %1272 = load i64, ptr %1265, align 8
  %1273 = add nsw i64 %1272, %1264
  %1274 = icmp slt i64 %1271, %1273
  br i1 %1274, label %1275, label %1329, !llvm.loop !25

1275:                                             ; preds = %1268, %1270
  %1276 = phi i1 [ %1267, %1268 ], [ %1274, %1270 ]
  %1277 = phi i64 [ undef, %1268 ], [ %1328, %1270 ]
  %1278 = phi i64 [ %1264, %1268 ], [ %1271, %1270 ]
  %1279 = load i64, ptr %1269, align 8
  %1280 = load ptr, ptr %147, align 8
  %1281 = load ptr, ptr %74, align 8
  %1282 = load ptr, ptr %148, align 8
  %1283 = getelementptr i64, ptr %1282, i64 %1278
  %1284 = getelementptr i64, ptr %1283, i64 %1279
  %1285 = load i64, ptr %1284, align 8
  %1286 = getelementptr i8, ptr %1284, i64 8
  %1287 = load i64, ptr %1286, align 8
  %1288 = xor i64 %1285, -1
  %1289 = add i64 %1287, %1288
  %1290 = load ptr, ptr %100, align 8
  %1291 = load ptr, ptr %145, align 8
  %1292 = load ptr, ptr %149, align 8
  %1293 = getelementptr inbounds i64, ptr %1292, i64 %1285
  %1294 = load ptr, ptr %150, align 8
  %1295 = getelementptr inbounds double, ptr %1294, i64 %1285
  tail call fastcc void @combine(ptr noundef %1280, ptr noundef %1281, ptr noundef %1290, ptr noundef %1291, ptr noundef %1293, ptr noundef %1295, i64 noundef %1289, i64 noundef 1, i64 noundef %1257) #8
  %1296 = load ptr, ptr %145, align 8
  %1297 = mul nsw i64 %1278, %1259
  %1298 = getelementptr inbounds double, ptr %1296, i64 %1297
  %1299 = load i64, ptr %478, align 8
  %1300 = add nsw i64 %1299, 1
  store i64 %1300, ptr %478, align 8
  %1301 = load ptr, ptr %151, align 8
  %1302 = getelementptr inbounds double, ptr %1301, i64 %1278
  %1303 = load double, ptr %1302, align 8
  %1304 = fmul double %591, %1303
  %1305 = fadd double %505, %1304
  %1306 = load ptr, ptr %147, align 8
  %1307 = load ptr, ptr %152, align 8
  store double %1305, ptr %1307, align 8
  %1308 = load ptr, ptr %73, align 8
  %1309 = getelementptr inbounds i8, ptr %1308, i64 40
  %1310 = load i64, ptr %1309, align 8
  %1311 = icmp eq i64 %1310, 0
  br i1 %1311, label %1313, label %1312

1312:                                             ; preds = %1275
  tail call fastcc void @settle(ptr noundef nonnull %73) #8
  br label %1313

1313:                                             ; preds = %1312, %1275
  %1314 = load i64, ptr %153, align 8
  %1315 = icmp sgt i64 %1314, 0
  br i1 %1315, label %1316, label %1317

1316:                                             ; preds = %1313
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %1317

1317:                                             ; preds = %1313, %1316
  %1318 = load ptr, ptr %73, align 8
  %1319 = load i64, ptr %1318, align 8
  %1320 = load ptr, ptr %152, align 8
  %1321 = load ptr, ptr %154, align 8
  %1322 = load ptr, ptr %155, align 8
  %1323 = inttoptr i64 %1319 to ptr
  %1324 = load ptr, ptr %1323, align 8
  %1325 = tail call i32 %1324(ptr noundef %1320, ptr noundef %1306, ptr noundef %1321, ptr noundef %1322, ptr noundef %1298) #9
  %1326 = sext i32 %1325 to i64
  %1327 = icmp eq i32 %1325, 0
  %1328 = select i1 %1327, i64 %1277, i64 %1326
  br i1 %1327, label %1270, label %1329

1329:                                             ; preds = %1270, %1317, %1253
  %1330 = phi i1 [ %1267, %1253 ], [ %1274, %1270 ], [ %1276, %1317 ]
  %1331 = phi i64 [ 0, %1253 ], [ %1326, %1317 ], [ %1326, %1270 ]
  %1332 = phi i64 [ undef, %1253 ], [ %1328, %1317 ], [ %1328, %1270 ]
  %1333 = getelementptr inbounds i8, ptr %1254, i64 16
  br i1 %1330, label %1402, label %1334

1334:                                             ; preds = %1329
  %1335 = load ptr, ptr %73, align 8
  %1336 = getelementptr inbounds i8, ptr %1335, i64 8
  %1337 = load i64, ptr %1336, align 8
  %1338 = icmp sgt i64 %1337, 0
  br i1 %1338, label %1339, label %1343

1339:                                             ; preds = %1334
  %1340 = getelementptr inbounds double, ptr %1263, i64 %1259
  %1341 = shl nsw i64 %1259, 4
  %1342 = getelementptr inbounds i8, ptr %1263, i64 %1341
  br label %1350

1343:                                             ; preds = %1350, %1334
  %1344 = getelementptr inbounds i8, ptr %1254, i64 8
  %1345 = load i64, ptr %1344, align 8
  %1346 = load i64, ptr %1333, align 8
  %1347 = getelementptr inbounds i8, ptr %1254, i64 24
  %1348 = load i64, ptr %1347, align 8
  %1349 = icmp sgt i64 %1348, 3
  br i1 %1349, label %1377, label %1402

1350:                                             ; preds = %1339, %1350
  %1351 = phi i64 [ 0, %1339 ], [ %1372, %1350 ]
  %1352 = load ptr, ptr %156, align 8
  %1353 = getelementptr inbounds double, ptr %1352, i64 %1351
  %1354 = load double, ptr %1353, align 8
  %1355 = load ptr, ptr %74, align 8
  %1356 = getelementptr inbounds double, ptr %1355, i64 %1351
  %1357 = load double, ptr %1356, align 8
  %1358 = fsub double %1354, %1357
  %1359 = load ptr, ptr %145, align 8
  %1360 = getelementptr inbounds double, ptr %1359, i64 %1351
  %1361 = load double, ptr %1360, align 8
  %1362 = fmul double %591, %1361
  %1363 = fsub double %1362, %1358
  %1364 = getelementptr inbounds double, ptr %1263, i64 %1351
  store double %1358, ptr %1364, align 8
  %1365 = getelementptr inbounds double, ptr %1340, i64 %1351
  store double %1363, ptr %1365, align 8
  %1366 = fsub double %1358, %1363
  %1367 = getelementptr inbounds double, ptr %1262, i64 %1351
  %1368 = load double, ptr %1367, align 8
  %1369 = fmul double %591, %1368
  %1370 = fsub double %1366, %1369
  %1371 = getelementptr inbounds double, ptr %1342, i64 %1351
  store double %1370, ptr %1371, align 8
  %1372 = add nuw nsw i64 %1351, 1
  %1373 = load ptr, ptr %73, align 8
  %1374 = getelementptr inbounds i8, ptr %1373, i64 8
  %1375 = load i64, ptr %1374, align 8
  %1376 = icmp slt i64 %1372, %1375
  br i1 %1376, label %1350, label %1343, !llvm.loop !26

1377:                                             ; preds = %1343, %1377
  %1378 = phi i64 [ %1399, %1377 ], [ 3, %1343 ]
  %1379 = mul nsw i64 %1378, %1259
  %1380 = getelementptr inbounds double, ptr %1263, i64 %1379
  %1381 = load ptr, ptr %157, align 8
  %1382 = load ptr, ptr %158, align 8
  %1383 = getelementptr i64, ptr %1382, i64 %1264
  %1384 = getelementptr i64, ptr %1383, i64 %1345
  %1385 = getelementptr i64, ptr %1384, i64 %1346
  %1386 = getelementptr i64, ptr %1385, i64 %1378
  %1387 = getelementptr i8, ptr %1386, i64 -24
  %1388 = load i64, ptr %1387, align 8
  %1389 = getelementptr i8, ptr %1386, i64 -16
  %1390 = load i64, ptr %1389, align 8
  %1391 = xor i64 %1388, -1
  %1392 = add i64 %1390, %1391
  %1393 = load ptr, ptr %100, align 8
  %1394 = load ptr, ptr %145, align 8
  %1395 = load ptr, ptr %159, align 8
  %1396 = getelementptr inbounds i64, ptr %1395, i64 %1388
  %1397 = load ptr, ptr %160, align 8
  %1398 = getelementptr inbounds double, ptr %1397, i64 %1388
  tail call fastcc void @combine(ptr noundef %1380, ptr noundef %1381, ptr noundef %1393, ptr noundef %1394, ptr noundef %1396, ptr noundef %1398, i64 noundef %1392, i64 noundef 1, i64 noundef %1257) #8
  %1399 = add nuw nsw i64 %1378, 1
  %1400 = load i64, ptr %1347, align 8
  %1401 = icmp slt i64 %1399, %1400
  br i1 %1401, label %1377, label %1402, !llvm.loop !27

1402:                                             ; preds = %1377, %1343, %1329
  %1403 = phi i64 [ %1332, %1329 ], [ %1331, %1343 ], [ %1331, %1377 ]
  %1404 = icmp eq i64 %1403, 0
  br i1 %1404, label %1408, label %1405

1405:                                             ; preds = %1402
  store i64 3, ptr %483, align 8
  store double %505, ptr %171, align 8
  %1406 = icmp slt i64 %1403, 0
  %1407 = select i1 %1406, i64 -4, i64 2
  br label %1776

1408:                                             ; preds = %1402
  %1409 = load ptr, ptr %75, align 8
  br i1 %1210, label %1410, label %1421

1410:                                             ; preds = %1408
  %1411 = load ptr, ptr %82, align 8
  %1412 = getelementptr inbounds i8, ptr %1411, i64 16
  %1413 = load i64, ptr %1412, align 8
  %1414 = inttoptr i64 %1413 to ptr
  %1415 = tail call i64 %1414(ptr noundef %0, double noundef %505, double noundef %591) #9
  %1416 = icmp eq i64 %1415, -6
  br i1 %1416, label %1417, label %1418

1417:                                             ; preds = %1410
  store double %505, ptr %1409, align 8
  br label %1596

1418:                                             ; preds = %1410
  %1419 = getelementptr inbounds i8, ptr %1409, i64 48
  %1420 = load double, ptr %1419, align 8
  br label %1421

1421:                                             ; preds = %1418, %1408
  %1422 = phi double [ %1420, %1418 ], [ 1.000000e+00, %1408 ]
  %1423 = phi i64 [ %1415, %1418 ], [ 0, %1408 ]
  %1424 = fcmp oeq double %1422, 1.000000e+00
  br i1 %1424, label %1425, label %1427

1425:                                             ; preds = %1421
  %1426 = load double, ptr %1409, align 8
  br label %1430

1427:                                             ; preds = %1421
  %1428 = fmul double %591, %1422
  %1429 = fadd double %505, %1428
  br label %1430

1430:                                             ; preds = %1427, %1425
  %1431 = phi double [ %1426, %1425 ], [ %1429, %1427 ]
  %1432 = icmp eq i64 %1423, -4
  %1433 = select i1 %1432, i64 -4, i64 0
  br i1 %1432, label %1491, label %1434

1434:                                             ; preds = %1430
  %1435 = fcmp olt double %1422, 1.000000e+00
  %1436 = load ptr, ptr %73, align 8
  %1437 = getelementptr inbounds i8, ptr %1436, i64 8
  %1438 = load i64, ptr %1437, align 8
  %1439 = load i64, ptr %83, align 8
  %1440 = load ptr, ptr %78, align 8
  %1441 = load ptr, ptr %77, align 8
  %1442 = getelementptr inbounds i8, ptr %1441, i64 48
  %1443 = load i64, ptr %1442, align 8
  %1444 = icmp slt i64 %1443, %1439
  br i1 %1444, label %1445, label %1487

1445:                                             ; preds = %1434, %1483
  %1446 = phi i64 [ %1484, %1483 ], [ undef, %1434 ]
  %1447 = phi i64 [ %1485, %1483 ], [ %1443, %1434 ]
  %1448 = getelementptr inbounds double, ptr %1440, i64 %1447
  %1449 = load double, ptr %1448, align 8
  %1450 = fcmp olt double %1449, %1431
  %1451 = fcmp oeq double %1449, %1431
  %1452 = and i1 %1435, %1451
  %1453 = or i1 %1450, %1452
  br i1 %1453, label %1454, label %1487

1454:                                             ; preds = %1445
  %1455 = fsub double %1449, %505
  %1456 = fdiv double %1455, %591
  %1457 = mul nsw i64 %1447, %1438
  %1458 = getelementptr inbounds double, ptr %1, i64 %1457
  %1459 = load ptr, ptr %161, align 8
  %1460 = insertelement <8 x double> poison, double %1456, i64 0
  %1461 = shufflevector <8 x double> %1460, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1461, ptr %1459, align 8
  %1462 = load ptr, ptr %74, align 8
  %1463 = load ptr, ptr %146, align 8
  %1464 = load i64, ptr %144, align 8
  %1465 = load ptr, ptr %0, align 8
  %1466 = getelementptr inbounds i8, ptr %1465, i64 24
  %1467 = load i64, ptr %1466, align 8
  %1468 = load ptr, ptr %161, align 8
  %1469 = load ptr, ptr %73, align 8
  %1470 = getelementptr inbounds i8, ptr %1469, i64 16
  %1471 = load i64, ptr %1470, align 8
  tail call fastcc void @nested(ptr noundef %1458, ptr noundef %1462, ptr noundef %1463, i64 noundef %1464, i64 noundef %1467, ptr noundef %1468, i64 noundef %1471) #8
  %1472 = load ptr, ptr %81, align 8
  %1473 = load i64, ptr %1472, align 8
  %1474 = icmp eq i64 %1473, 1
  br i1 %1474, label %1475, label %1483

1475:                                             ; preds = %1454
  %1476 = load double, ptr %1448, align 8
  %1477 = getelementptr inbounds i8, ptr %1472, i64 56
  %1478 = load i64, ptr %1477, align 8
  %1479 = inttoptr i64 %1478 to ptr
  %1480 = tail call i64 %1479(ptr noundef %0, double noundef %1476, ptr noundef %1458, ptr noundef null) #9
  %1481 = icmp eq i64 %1480, 0
  %1482 = select i1 %1481, i64 %1446, i64 %1480
  br i1 %1481, label %1483, label %1491

1483:                                             ; preds = %1475, %1454
  %1484 = phi i64 [ %1482, %1475 ], [ %1446, %1454 ]
  %1485 = add i64 %1447, 1
  %1486 = icmp eq i64 %1485, %1439
  br i1 %1486, label %1487, label %1445, !llvm.loop !28

1487:                                             ; preds = %1483, %1445, %1434
  %1488 = phi i64 [ %1443, %1434 ], [ %1439, %1483 ], [ %1447, %1445 ]
  %1489 = load ptr, ptr %77, align 8
  %1490 = getelementptr inbounds i8, ptr %1489, i64 48
  store i64 %1488, ptr %1490, align 8
  br label %1491

1491:                                             ; preds = %1475, %1487, %1430
  %1492 = phi i64 [ %1433, %1430 ], [ 0, %1487 ], [ %1482, %1475 ]
  %1493 = icmp eq i64 %1492, 0
  %1494 = icmp ne i64 %1423, 0
  %1495 = fcmp olt double %1422, 1.000000e+00
  %1496 = and i1 %1495, %1493
  %1497 = and i1 %1494, %1496
  br i1 %1497, label %1498, label %1535

1498:                                             ; preds = %1491
  %1499 = load ptr, ptr %162, align 8
  %1500 = load ptr, ptr %163, align 8
  %1501 = insertelement <8 x double> poison, double %1422, i64 0
  %1502 = shufflevector <8 x double> %1501, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1502, ptr %1500, align 8
  %1503 = load ptr, ptr %74, align 8
  %1504 = load ptr, ptr %146, align 8
  %1505 = load i64, ptr %144, align 8
  %1506 = load ptr, ptr %0, align 8
  %1507 = getelementptr inbounds i8, ptr %1506, i64 24
  %1508 = load i64, ptr %1507, align 8
  %1509 = load ptr, ptr %163, align 8
  %1510 = load ptr, ptr %73, align 8
  %1511 = getelementptr inbounds i8, ptr %1510, i64 16
  %1512 = load i64, ptr %1511, align 8
  tail call fastcc void @nested(ptr noundef %1499, ptr noundef %1503, ptr noundef %1504, i64 noundef %1505, i64 noundef %1508, ptr noundef %1509, i64 noundef %1512) #8
  %1513 = load i64, ptr %80, align 8
  %1514 = icmp sgt i64 %1513, 0
  br i1 %1514, label %1519, label %1515

1515:                                             ; preds = %1519, %1498
  %1516 = load ptr, ptr %81, align 8
  %1517 = load i64, ptr %1516, align 8
  %1518 = icmp eq i64 %1517, 1
  br i1 %1518, label %1529, label %1535

1519:                                             ; preds = %1498, %1519
  %1520 = phi i64 [ %1526, %1519 ], [ 0, %1498 ]
  %1521 = load ptr, ptr %162, align 8
  %1522 = getelementptr inbounds double, ptr %1521, i64 %1520
  %1523 = load double, ptr %1522, align 8
  %1524 = load ptr, ptr %76, align 8
  %1525 = getelementptr inbounds double, ptr %1524, i64 %1520
  store double %1523, ptr %1525, align 8
  %1526 = add nuw nsw i64 %1520, 1
  %1527 = load i64, ptr %80, align 8
  %1528 = icmp slt i64 %1526, %1527
  br i1 %1528, label %1519, label %1515, !llvm.loop !29

1529:                                             ; preds = %1515
  %1530 = load ptr, ptr %76, align 8
  %1531 = getelementptr inbounds i8, ptr %1516, i64 56
  %1532 = load i64, ptr %1531, align 8
  %1533 = inttoptr i64 %1532 to ptr
  %1534 = tail call i64 %1533(ptr noundef %0, double noundef %1431, ptr noundef %1530, ptr noundef null) #9
  br label %1535

1535:                                             ; preds = %1529, %1515, %1491
  %1536 = phi i64 [ %1534, %1529 ], [ 0, %1515 ], [ %1492, %1491 ]
  %1537 = icmp eq i64 %1536, 0
  br i1 %1537, label %1540, label %1538

1538:                                             ; preds = %1535
  store double %505, ptr %1409, align 8
  %1539 = getelementptr inbounds i8, ptr %1409, i64 8
  store double %591, ptr %1539, align 8
  br label %1596

1540:                                             ; preds = %1535
  br i1 %1424, label %1541, label %1579

1541:                                             ; preds = %1540
  %1542 = load ptr, ptr %76, align 8
  %1543 = load ptr, ptr %73, align 8
  %1544 = getelementptr inbounds i8, ptr %1543, i64 8
  %1545 = load i64, ptr %1544, align 8
  %1546 = load i64, ptr %83, align 8
  %1547 = load ptr, ptr %78, align 8
  %1548 = load ptr, ptr %77, align 8
  %1549 = getelementptr inbounds i8, ptr %1548, i64 48
  %1550 = load i64, ptr %1549, align 8
  %1551 = icmp slt i64 %1550, %1546
  br i1 %1551, label %1552, label %1575

1552:                                             ; preds = %1541
  %1553 = icmp sgt i64 %1545, 0
  br label %1554

1554:                                             ; preds = %1552, %1565
  %1555 = phi i64 [ %1550, %1552 ], [ %1566, %1565 ]
  %1556 = getelementptr inbounds double, ptr %1547, i64 %1555
  %1557 = load double, ptr %1556, align 8
  %1558 = load ptr, ptr %75, align 8
  %1559 = load double, ptr %1558, align 8
  %1560 = fcmp ugt double %1557, %1559
  br i1 %1560, label %1575, label %1561

1561:                                             ; preds = %1554
  br i1 %1553, label %1562, label %1565

1562:                                             ; preds = %1561
  %1563 = mul nsw i64 %1555, %1545
  %1564 = getelementptr double, ptr %1, i64 %1563
  br label %1568

1565:                                             ; preds = %1568, %1561
  %1566 = add i64 %1555, 1
  %1567 = icmp eq i64 %1566, %1546
  br i1 %1567, label %1575, label %1554, !llvm.loop !9

1568:                                             ; preds = %1562, %1568
  %1569 = phi i64 [ 0, %1562 ], [ %1573, %1568 ]
  %1570 = getelementptr inbounds double, ptr %1542, i64 %1569
  %1571 = load double, ptr %1570, align 8
  %1572 = getelementptr double, ptr %1564, i64 %1569
  store double %1571, ptr %1572, align 8
  %1573 = add nuw nsw i64 %1569, 1
  %1574 = icmp eq i64 %1573, %1545
  br i1 %1574, label %1565, label %1568, !llvm.loop !10

1575:                                             ; preds = %1565, %1554, %1541
  %1576 = phi i64 [ %1550, %1541 ], [ %1546, %1565 ], [ %1555, %1554 ]
  %1577 = load ptr, ptr %77, align 8
  %1578 = getelementptr inbounds i8, ptr %1577, i64 48
  store i64 %1576, ptr %1578, align 8
  br label %1579

1579:                                             ; preds = %1575, %1540
  br i1 %1494, label %1580, label %1596

1580:                                             ; preds = %1579
  %1581 = load i64, ptr %80, align 8
  %1582 = icmp sgt i64 %1581, 0
  br i1 %1582, label %1586, label %1583

1583:                                             ; preds = %1586, %1580
  store double %1431, ptr %1409, align 8
  %1584 = getelementptr inbounds i8, ptr %1409, i64 8
  store double 0.000000e+00, ptr %1584, align 8
  %1585 = load ptr, ptr %77, align 8
  store i64 0, ptr %1585, align 8
  br label %1596

1586:                                             ; preds = %1580, %1586
  %1587 = phi i64 [ %1593, %1586 ], [ 0, %1580 ]
  %1588 = load ptr, ptr %76, align 8
  %1589 = getelementptr inbounds double, ptr %1588, i64 %1587
  %1590 = load double, ptr %1589, align 8
  %1591 = load ptr, ptr %74, align 8
  %1592 = getelementptr inbounds double, ptr %1591, i64 %1587
  store double %1590, ptr %1592, align 8
  %1593 = add nuw nsw i64 %1587, 1
  %1594 = load i64, ptr %80, align 8
  %1595 = icmp slt i64 %1593, %1594
  br i1 %1595, label %1586, label %1583, !llvm.loop !30

1596:                                             ; preds = %1417, %1538, %1579, %1583
  %1597 = phi i64 [ -6, %1417 ], [ %1536, %1538 ], [ %1423, %1583 ], [ %1423, %1579 ]
  %1598 = icmp eq i64 %1597, -6
  br i1 %1598, label %1603, label %1599

1599:                                             ; preds = %1596
  %1600 = icmp ne i64 %1597, 6
  %1601 = select i1 %1600, i1 true, i1 %187
  %1602 = select i1 %1601, i1 true, i1 %194
  br i1 %1602, label %1613, label %1603

1603:                                             ; preds = %1599, %1596
  %1604 = phi i64 [ %1597, %1599 ], [ 2, %1596 ]
  %1605 = load i64, ptr %473, align 8
  %1606 = add nsw i64 %1605, -1
  store i64 %1606, ptr %473, align 8
  %1607 = load ptr, ptr %96, align 8
  %1608 = load i64, ptr %1607, align 8
  %1609 = add nsw i64 %1608, -1
  store i64 %1609, ptr %1607, align 8
  %1610 = load i64, ptr %474, align 8
  %1611 = add nsw i64 %1610, 1
  store i64 %1611, ptr %474, align 8
  store i64 %1604, ptr %494, align 8
  store double 1.000000e+00, ptr %495, align 8
  %1612 = fmul double %591, 2.500000e-01
  br label %1776, !llvm.loop !20

1613:                                             ; preds = %1599
  %1614 = icmp eq i64 %1597, 0
  br i1 %1614, label %1619, label %1615

1615:                                             ; preds = %1613
  %1616 = load ptr, ptr %96, align 8
  %1617 = load i64, ptr %1616, align 8
  %1618 = add nsw i64 %1617, 1
  store i64 %1618, ptr %1616, align 8
  br label %1776

1619:                                             ; preds = %1613, %1249
  br i1 %187, label %1722, label %1620

1620:                                             ; preds = %1619
  %1621 = load double, ptr %485, align 8
  %1622 = fcmp ogt double %993, 1.000000e-10
  %1623 = select i1 %1622, double %993, double 1.000000e-10
  %1624 = load double, ptr %486, align 8
  %1625 = load double, ptr %487, align 8
  %1626 = fneg double %1625
  %1627 = bitcast double %1623 to i64
  %1628 = add nsw i64 %1627, -4604544271217802189
  %1629 = ashr i64 %1628, 52
  %1630 = and i64 %1628, -4503599627370496
  %1631 = sub nsw i64 %1627, %1630
  %1632 = bitcast i64 %1631 to double
  %1633 = fadd double %1632, -1.000000e+00
  %1634 = fadd double %1632, 1.000000e+00
  %1635 = fdiv double %1633, %1634
  %1636 = fmul double %1635, %1635
  %1637 = tail call double @llvm.fma.f64(double %1636, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1638 = tail call double @llvm.fma.f64(double %1637, double %1636, double 0x3FE2776C50EF9BFE)
  %1639 = tail call double @llvm.fma.f64(double %1638, double %1636, double 0x3FEEC709DC3A03FD)
  %1640 = tail call double @llvm.fma.f64(double %1639, double %1636, double 0x40071547652B82FE)
  %1641 = trunc nsw i64 %1629 to i32
  %1642 = sitofp i32 %1641 to double
  %1643 = fmul double %1635, %1640
  %1644 = fadd double %1643, %1642
  %1645 = fmul double %1644, %1626
  %1646 = fcmp ogt double %1645, -1.000000e+03
  %1647 = select i1 %1646, double %1645, double -1.000000e+03
  %1648 = fcmp olt double %1647, 1.000000e+03
  %1649 = select i1 %1648, double %1647, double 1.000000e+03
  %1650 = tail call double @llvm.rint.f64(double %1649)
  %1651 = fsub double %1649, %1650
  %1652 = tail call double @llvm.fma.f64(double %1651, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1653 = tail call double @llvm.fma.f64(double %1652, double %1651, double 0x3F55D87FE78A6730)
  %1654 = tail call double @llvm.fma.f64(double %1653, double %1651, double 0x3F83B2AB6FBA4E77)
  %1655 = tail call double @llvm.fma.f64(double %1654, double %1651, double 0x3FAC6B08D704A0BF)
  %1656 = tail call double @llvm.fma.f64(double %1655, double %1651, double 0x3FCEBFBDFF82C58E)
  %1657 = tail call double @llvm.fma.f64(double %1656, double %1651, double 0x3FE62E42FEFA39EF)
  %1658 = tail call double @llvm.fma.f64(double %1657, double %1651, double 1.000000e+00)
  %1659 = bitcast double %1658 to i64
  %1660 = fptosi double %1650 to i32
  %1661 = sext i32 %1660 to i64
  %1662 = shl nsw i64 %1661, 52
  %1663 = add nsw i64 %1662, %1659
  %1664 = bitcast i64 %1663 to double
  %1665 = fmul double %1624, %1664
  %1666 = load double, ptr %488, align 8
  %1667 = fcmp une double %1666, 0.000000e+00
  br i1 %1667, label %1668, label %1708

1668:                                             ; preds = %1620
  %1669 = load i64, ptr %484, align 8
  %1670 = add nsw i64 %1669, -4604544271217802189
  %1671 = ashr i64 %1670, 52
  %1672 = and i64 %1670, -4503599627370496
  %1673 = sub nsw i64 %1669, %1672
  %1674 = bitcast i64 %1673 to double
  %1675 = fadd double %1674, -1.000000e+00
  %1676 = fadd double %1674, 1.000000e+00
  %1677 = fdiv double %1675, %1676
  %1678 = fmul double %1677, %1677
  %1679 = tail call double @llvm.fma.f64(double %1678, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1680 = tail call double @llvm.fma.f64(double %1679, double %1678, double 0x3FE2776C50EF9BFE)
  %1681 = tail call double @llvm.fma.f64(double %1680, double %1678, double 0x3FEEC709DC3A03FD)
  %1682 = tail call double @llvm.fma.f64(double %1681, double %1678, double 0x40071547652B82FE)
  %1683 = trunc nsw i64 %1671 to i32
  %1684 = sitofp i32 %1683 to double
  %1685 = fmul double %1677, %1682
  %1686 = fadd double %1685, %1684
  %1687 = fmul double %1666, %1686
  %1688 = fcmp ogt double %1687, -1.000000e+03
  %1689 = select i1 %1688, double %1687, double -1.000000e+03
  %1690 = fcmp olt double %1689, 1.000000e+03
  %1691 = select i1 %1690, double %1689, double 1.000000e+03
  %1692 = tail call double @llvm.rint.f64(double %1691)
  %1693 = fsub double %1691, %1692
  %1694 = tail call double @llvm.fma.f64(double %1693, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1695 = tail call double @llvm.fma.f64(double %1694, double %1693, double 0x3F55D87FE78A6730)
  %1696 = tail call double @llvm.fma.f64(double %1695, double %1693, double 0x3F83B2AB6FBA4E77)
  %1697 = tail call double @llvm.fma.f64(double %1696, double %1693, double 0x3FAC6B08D704A0BF)
  %1698 = tail call double @llvm.fma.f64(double %1697, double %1693, double 0x3FCEBFBDFF82C58E)
  %1699 = tail call double @llvm.fma.f64(double %1698, double %1693, double 0x3FE62E42FEFA39EF)
  %1700 = tail call double @llvm.fma.f64(double %1699, double %1693, double 1.000000e+00)
  %1701 = bitcast double %1700 to i64
  %1702 = fptosi double %1692 to i32
  %1703 = sext i32 %1702 to i64
  %1704 = shl nsw i64 %1703, 52
  %1705 = add nsw i64 %1704, %1701
  %1706 = bitcast i64 %1705 to double
  %1707 = fmul double %1665, %1706
  br label %1708

1708:                                             ; preds = %1620, %1668
  %1709 = phi double [ %1707, %1668 ], [ %1665, %1620 ]
  %1710 = load double, ptr %489, align 8
  %1711 = fcmp ogt double %1709, %1710
  %1712 = select i1 %1711, double %1709, double %1710
  %1713 = fcmp olt double %1621, %1712
  %1714 = select i1 %1713, double %1621, double %1712
  %1715 = fmul double %591, %1714
  %1716 = fcmp ogt double %506, %1715
  %1717 = select i1 %1716, double %506, double %1715
  %1718 = select i1 %595, double %1715, double %1717
  %1719 = fcmp ogt double %993, 1.000000e-04
  %1720 = select i1 %1719, double %993, double 1.000000e-04
  store double %1720, ptr %484, align 8
  %1721 = load double, ptr %490, align 8
  store double %1721, ptr %485, align 8
  br label %1722

1722:                                             ; preds = %1708, %1619
  %1723 = phi double [ %1718, %1708 ], [ %506, %1619 ]
  br i1 %491, label %1728, label %1724

1724:                                             ; preds = %1728, %1722
  %1725 = load i64, ptr %492, align 8
  %1726 = load i64, ptr %83, align 8
  %1727 = icmp eq i64 %1725, %1726
  br i1 %1727, label %1740, label %1741

1728:                                             ; preds = %1722, %1728
  %1729 = phi i64 [ %1738, %1728 ], [ 0, %1722 ]
  %1730 = getelementptr inbounds double, ptr %172, i64 %1729
  %1731 = load double, ptr %1730, align 8
  %1732 = load ptr, ptr %74, align 8
  %1733 = getelementptr inbounds double, ptr %1732, i64 %1729
  store double %1731, ptr %1733, align 8
  %1734 = getelementptr inbounds double, ptr %202, i64 %1729
  %1735 = load double, ptr %1734, align 8
  %1736 = load ptr, ptr %84, align 8
  %1737 = getelementptr inbounds double, ptr %1736, i64 %1729
  store double %1735, ptr %1737, align 8
  %1738 = add nuw nsw i64 %1729, 1
  %1739 = icmp eq i64 %1738, %181
  br i1 %1739, label %1724, label %1728, !llvm.loop !31

1740:                                             ; preds = %1724
  store double %1723, ptr %204, align 8
  br label %1776

1741:                                             ; preds = %1724
  %1742 = fcmp oeq double %590, %565
  br i1 %1742, label %1743, label %1776

1743:                                             ; preds = %1741
  %1744 = load i64, ptr %97, align 8
  %1745 = icmp sgt i64 %1744, 0
  br i1 %1745, label %1746, label %1748

1746:                                             ; preds = %1743
  %1747 = load ptr, ptr %164, align 8
  store double 0x7FF0000000000000, ptr %1747, align 8
  br label %1748

1748:                                             ; preds = %1743, %1746
  %1749 = load i64, ptr %478, align 8
  %1750 = add nsw i64 %1749, 1
  store i64 %1750, ptr %478, align 8
  %1751 = load ptr, ptr %74, align 8
  %1752 = load ptr, ptr %84, align 8
  %1753 = load ptr, ptr %165, align 8
  store double %590, ptr %1753, align 8
  %1754 = load ptr, ptr %73, align 8
  %1755 = getelementptr inbounds i8, ptr %1754, i64 40
  %1756 = load i64, ptr %1755, align 8
  %1757 = icmp eq i64 %1756, 0
  br i1 %1757, label %1759, label %1758

1758:                                             ; preds = %1748
  tail call fastcc void @settle(ptr noundef nonnull %73) #8
  br label %1759

1759:                                             ; preds = %1758, %1748
  %1760 = load i64, ptr %166, align 8
  %1761 = icmp sgt i64 %1760, 0
  br i1 %1761, label %1762, label %1763

1762:                                             ; preds = %1759
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %1763

1763:                                             ; preds = %1759, %1762
  %1764 = load ptr, ptr %73, align 8
  %1765 = load i64, ptr %1764, align 8
  %1766 = load ptr, ptr %165, align 8
  %1767 = load ptr, ptr %167, align 8
  %1768 = load ptr, ptr %168, align 8
  %1769 = inttoptr i64 %1765 to ptr
  %1770 = load ptr, ptr %1769, align 8
  %1771 = tail call i32 %1770(ptr noundef %1766, ptr noundef %1751, ptr noundef %1767, ptr noundef %1768, ptr noundef %1752) #9
  %1772 = icmp eq i32 %1771, 0
  br i1 %1772, label %1776, label %1773

1773:                                             ; preds = %1763
  store i64 3, ptr %493, align 8
  store double %1723, ptr %204, align 8
  %1774 = icmp slt i32 %1771, 0
  %1775 = select i1 %1774, i64 -4, i64 2
  br label %1776

1776:                                             ; preds = %1773, %1763, %1741, %1740, %1615, %1603, %1405, %1061, %1060, %980, %784, %597
  %1777 = phi double [ %506, %597 ], [ %506, %784 ], [ %506, %980 ], [ %1059, %1061 ], [ %1059, %1060 ], [ %506, %1405 ], [ %1612, %1603 ], [ %506, %1615 ], [ %1723, %1740 ], [ %1723, %1773 ], [ %1723, %1763 ], [ %1723, %1741 ]
  %1778 = phi double [ %505, %597 ], [ %505, %784 ], [ %505, %980 ], [ %505, %1061 ], [ %505, %1060 ], [ %505, %1405 ], [ %505, %1603 ], [ %505, %1615 ], [ %590, %1740 ], [ %590, %1773 ], [ %590, %1763 ], [ %590, %1741 ]
  %1779 = phi i32 [ 1, %597 ], [ 1, %784 ], [ 1, %980 ], [ 3, %1061 ], [ 1, %1060 ], [ 1, %1405 ], [ 3, %1603 ], [ 1, %1615 ], [ 1, %1740 ], [ 1, %1773 ], [ 0, %1763 ], [ 0, %1741 ]
  %1780 = phi i64 [ 2, %597 ], [ -4, %784 ], [ -4, %980 ], [ %504, %1061 ], [ 2, %1060 ], [ %1407, %1405 ], [ %504, %1603 ], [ %1597, %1615 ], [ 0, %1740 ], [ %1775, %1773 ], [ %504, %1763 ], [ %504, %1741 ]
  switch i32 %1779, label %1784 [
    i32 0, label %1781
    i32 3, label %1781
  ]

1781:                                             ; preds = %1776, %1776
  %1782 = load i64, ptr %174, align 8
  %1783 = icmp eq i64 %1782, 0
  br i1 %1783, label %500, label %502, !llvm.loop !20

1784:                                             ; preds = %1776, %170, %266, %308, %500, %519, %527
  %1785 = phi i64 [ -1, %170 ], [ %269, %266 ], [ -1, %500 ], [ -5, %519 ], [ 1, %527 ], [ 0, %308 ], [ %1780, %1776 ]
  %1786 = load ptr, ptr %169, align 8
  %1787 = getelementptr inbounds i8, ptr %1786, i64 48
  %1788 = load i64, ptr %1787, align 8
  %1789 = icmp ne i64 %1785, -2
  %1790 = icmp eq i64 %1788, 0
  %1791 = select i1 %1789, i1 true, i1 %1790
  br i1 %1791, label %1799, label %1792

1792:                                             ; preds = %1784
  %1793 = inttoptr i64 %1788 to ptr
  %1794 = tail call i64 %1793(ptr noundef %0) #9
  %1795 = icmp eq i64 %1794, 8
  %1796 = select i1 %1795, i64 8, i64 %1785
  %1797 = icmp eq i64 %1794, 1
  %1798 = zext i1 %1797 to i32
  br label %1799

1799:                                             ; preds = %1784, %1792
  %1800 = phi i64 [ %1785, %1784 ], [ %1796, %1792 ]
  %1801 = phi i32 [ 0, %1784 ], [ %1798, %1792 ]
  %1802 = icmp eq i32 %1801, 0
  br i1 %1802, label %1803, label %170, !llvm.loop !32

1803:                                             ; preds = %1799
  %1804 = getelementptr inbounds i8, ptr %0, i64 320
  %1805 = load i64, ptr %1804, align 8
  %1806 = icmp sgt i64 %1805, 0
  br i1 %1806, label %1807, label %1810

1807:                                             ; preds = %1803
  %1808 = getelementptr inbounds i8, ptr %0, i64 336
  %1809 = load ptr, ptr %1808, align 8
  store double 0x7FF0000000000000, ptr %1809, align 8
  br label %1810

1810:                                             ; preds = %1803, %1807
  ret i64 %1800
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
  br i1 %28, label %16, label %29, !llvm.loop !8

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
  br i1 %60, label %49, label %61, !llvm.loop !33

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
  br i1 %88, label %14, label %13, !llvm.loop !34
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
  br i1 %41, label %13, label %18, !llvm.loop !35
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
  br i1 %53, label %54, label %28, !llvm.loop !36

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
  br i1 %98, label %72, label %99, !llvm.loop !37

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
  br i1 %108, label %16, label %22, !llvm.loop !38

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
  br i1 %133, label %114, label %120, !llvm.loop !36

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
  br i1 %148, label %134, label %149, !llvm.loop !37

149:                                              ; preds = %134, %114
  %150 = phi <8 x double> [ %118, %114 ], [ %146, %134 ]
  store <8 x double> %150, ptr %111, align 8
  %151 = add nuw nsw i64 %110, 8
  %152 = icmp slt i64 %151, %11
  br i1 %152, label %109, label %153, !llvm.loop !39

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
  br i1 %31, label %20, label %19, !llvm.loop !40

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
  br i1 %43, label %32, label %24, !llvm.loop !41
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
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !5}
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
!41 = distinct !{!41, !4, !5}
