; sources 8a8b12805fc8917a4859c6111d5ca4d3d5f2bf2533759d39dbd8505364afe6d5
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define i64 @advance(ptr noundef %0, ptr noundef %1, i64 noundef %2) #0 {
  %4 = alloca [8 x double], align 16
  %5 = alloca [8 x double], align 16
  %6 = alloca [1 x double], align 8
  %7 = alloca [1 x double], align 8
  %8 = alloca [1 x double], align 8
  %9 = icmp eq i64 %2, 1
  br i1 %9, label %10, label %74

10:                                               ; preds = %3
  %11 = getelementptr inbounds i8, ptr %0, i64 144
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %12, i64 8
  %14 = load i64, ptr %13, align 8
  %15 = icmp sgt i64 %14, 0
  br i1 %15, label %16, label %18

16:                                               ; preds = %10
  %17 = getelementptr inbounds i8, ptr %0, i64 360
  br label %25

18:                                               ; preds = %25, %10
  %19 = getelementptr inbounds i8, ptr %0, i64 632
  %20 = load i64, ptr %19, align 8
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %22, label %36

22:                                               ; preds = %18
  %23 = getelementptr inbounds i8, ptr %0, i64 624
  %24 = getelementptr inbounds i8, ptr %0, i64 1272
  br label %43

25:                                               ; preds = %16, %25
  %26 = phi i64 [ 0, %16 ], [ %31, %25 ]
  %27 = getelementptr inbounds double, ptr %1, i64 %26
  %28 = load double, ptr %27, align 8
  %29 = load ptr, ptr %17, align 8
  %30 = getelementptr inbounds double, ptr %29, i64 %26
  store double %28, ptr %30, align 8
  %31 = add nuw nsw i64 %26, 1
  %32 = load ptr, ptr %11, align 8
  %33 = getelementptr inbounds i8, ptr %32, i64 8
  %34 = load i64, ptr %33, align 8
  %35 = icmp slt i64 %31, %34
  br i1 %35, label %25, label %18, !llvm.loop !3

36:                                               ; preds = %43, %18
  %37 = getelementptr inbounds i8, ptr %0, i64 656
  %38 = load i64, ptr %37, align 8
  %39 = icmp sgt i64 %38, 0
  br i1 %39, label %40, label %53

40:                                               ; preds = %36
  %41 = getelementptr inbounds i8, ptr %0, i64 648
  %42 = getelementptr inbounds i8, ptr %0, i64 1296
  br label %59

43:                                               ; preds = %22, %43
  %44 = phi i64 [ 0, %22 ], [ %50, %43 ]
  %45 = load ptr, ptr %24, align 8
  %46 = getelementptr inbounds double, ptr %45, i64 %44
  %47 = load double, ptr %46, align 8
  %48 = load ptr, ptr %23, align 8
  %49 = getelementptr inbounds double, ptr %48, i64 %44
  store double %47, ptr %49, align 8
  %50 = add nuw nsw i64 %44, 1
  %51 = load i64, ptr %19, align 8
  %52 = icmp slt i64 %50, %51
  br i1 %52, label %43, label %36, !llvm.loop !6

53:                                               ; preds = %59, %36
  %54 = getelementptr inbounds i8, ptr %0, i64 768
  %55 = load ptr, ptr %54, align 8
  %56 = getelementptr inbounds i8, ptr %55, i64 8
  %57 = load i64, ptr %56, align 8
  %58 = icmp sgt i64 %57, 0
  br i1 %58, label %69, label %74

59:                                               ; preds = %40, %59
  %60 = phi i64 [ 0, %40 ], [ %66, %59 ]
  %61 = load ptr, ptr %42, align 8
  %62 = getelementptr inbounds i64, ptr %61, i64 %60
  %63 = load i64, ptr %62, align 8
  %64 = load ptr, ptr %41, align 8
  %65 = getelementptr inbounds i64, ptr %64, i64 %60
  store i64 %63, ptr %65, align 8
  %66 = add nuw nsw i64 %60, 1
  %67 = load i64, ptr %37, align 8
  %68 = icmp slt i64 %66, %67
  br i1 %68, label %59, label %53, !llvm.loop !7

69:                                               ; preds = %53
  %70 = getelementptr inbounds i8, ptr %0, i64 984
  %71 = load ptr, ptr %70, align 8
  %72 = mul i64 %57, 88
  %73 = getelementptr inbounds i8, ptr %71, i64 %72
  store double 0x7FF8000000000000, ptr %73, align 8
  br label %74

74:                                               ; preds = %69, %53, %3
  %75 = getelementptr inbounds i8, ptr %0, i64 144
  %76 = getelementptr inbounds i8, ptr %0, i64 360
  %77 = getelementptr inbounds i8, ptr %0, i64 624
  %78 = getelementptr inbounds i8, ptr %0, i64 384
  %79 = getelementptr inbounds i8, ptr %0, i64 648
  %80 = getelementptr inbounds i8, ptr %0, i64 672
  %81 = getelementptr inbounds i8, ptr %0, i64 120
  %82 = getelementptr inbounds i8, ptr %0, i64 368
  %83 = getelementptr inbounds i8, ptr %0, i64 696
  %84 = getelementptr inbounds i8, ptr %0, i64 768
  %85 = getelementptr inbounds i8, ptr %0, i64 680
  %86 = getelementptr inbounds i8, ptr %0, i64 528
  %87 = getelementptr inbounds i8, ptr %0, i64 320
  %88 = getelementptr inbounds i8, ptr %0, i64 312
  %89 = getelementptr inbounds i8, ptr %0, i64 336
  %90 = getelementptr inbounds i8, ptr %0, i64 168
  %91 = getelementptr inbounds i8, ptr %0, i64 248
  %92 = getelementptr inbounds i8, ptr %0, i64 192
  %93 = getelementptr inbounds i8, ptr %0, i64 216
  %94 = getelementptr inbounds i8, ptr %0, i64 528
  %95 = getelementptr inbounds i8, ptr %0, i64 408
  %96 = getelementptr inbounds i8, ptr %0, i64 408
  %97 = getelementptr inbounds i8, ptr %0, i64 368
  %98 = getelementptr inbounds i8, ptr %0, i64 1320
  %99 = getelementptr inbounds i8, ptr %0, i64 320
  %100 = getelementptr inbounds i8, ptr %0, i64 312
  %101 = getelementptr inbounds i8, ptr %0, i64 336
  %102 = getelementptr inbounds i8, ptr %0, i64 432
  %103 = getelementptr inbounds i8, ptr %0, i64 408
  %104 = getelementptr inbounds i8, ptr %0, i64 24
  %105 = getelementptr inbounds i8, ptr %0, i64 528
  %106 = getelementptr inbounds i8, ptr %0, i64 48
  %107 = getelementptr inbounds i8, ptr %0, i64 72
  %108 = getelementptr inbounds i8, ptr %0, i64 368
  %109 = getelementptr inbounds i8, ptr %0, i64 96
  %110 = getelementptr inbounds i8, ptr %0, i64 168
  %111 = getelementptr inbounds i8, ptr %0, i64 248
  %112 = getelementptr inbounds i8, ptr %0, i64 192
  %113 = getelementptr inbounds i8, ptr %0, i64 216
  %114 = getelementptr inbounds i8, ptr %0, i64 384
  %115 = getelementptr inbounds i8, ptr %0, i64 24
  %116 = getelementptr inbounds i8, ptr %0, i64 528
  %117 = getelementptr inbounds i8, ptr %0, i64 48
  %118 = getelementptr inbounds i8, ptr %0, i64 72
  %119 = getelementptr inbounds i8, ptr %0, i64 168
  %120 = getelementptr inbounds i8, ptr %0, i64 248
  %121 = getelementptr inbounds i8, ptr %0, i64 192
  %122 = getelementptr inbounds i8, ptr %0, i64 216
  %123 = getelementptr inbounds i8, ptr %0, i64 504
  %124 = getelementptr inbounds i8, ptr %0, i64 368
  %125 = getelementptr inbounds i8, ptr %0, i64 480
  %126 = getelementptr inbounds i8, ptr %0, i64 24
  %127 = getelementptr inbounds i8, ptr %0, i64 528
  %128 = getelementptr inbounds i8, ptr %0, i64 48
  %129 = getelementptr inbounds i8, ptr %0, i64 72
  %130 = getelementptr inbounds i8, ptr %0, i64 384
  %131 = getelementptr inbounds i8, ptr %0, i64 600
  %132 = getelementptr inbounds i8, ptr %0, i64 576
  %133 = getelementptr inbounds i8, ptr %0, i64 384
  %134 = getelementptr inbounds i8, ptr %0, i64 600
  %135 = getelementptr inbounds i8, ptr %0, i64 576
  %136 = getelementptr inbounds i8, ptr %0, i64 600
  %137 = getelementptr inbounds i8, ptr %0, i64 576
  %138 = getelementptr inbounds i8, ptr %0, i64 168
  %139 = getelementptr inbounds i8, ptr %0, i64 248
  %140 = getelementptr inbounds i8, ptr %0, i64 192
  %141 = getelementptr inbounds i8, ptr %0, i64 216
  %142 = getelementptr inbounds i8, ptr %0, i64 1344
  %143 = getelementptr inbounds i8, ptr %0, i64 1360
  %144 = getelementptr inbounds i8, ptr %0, i64 888
  %145 = getelementptr inbounds i8, ptr %0, i64 168
  %146 = getelementptr inbounds i8, ptr %0, i64 984
  %147 = getelementptr inbounds i8, ptr %0, i64 912
  %148 = getelementptr inbounds i8, ptr %0, i64 864
  %149 = getelementptr inbounds i8, ptr %0, i64 936
  %150 = getelementptr inbounds i8, ptr %0, i64 368
  %151 = getelementptr inbounds i8, ptr %0, i64 528
  %152 = getelementptr inbounds i8, ptr %0, i64 552
  %153 = getelementptr inbounds i8, ptr %0, i64 408
  %154 = getelementptr inbounds i8, ptr %0, i64 24
  %155 = getelementptr inbounds i8, ptr %0, i64 48
  %156 = getelementptr inbounds i8, ptr %0, i64 72
  %157 = getelementptr inbounds i8, ptr %0, i64 96
  %158 = getelementptr inbounds i8, ptr %0, i64 168
  %159 = getelementptr inbounds i8, ptr %0, i64 248
  %160 = getelementptr inbounds i8, ptr %0, i64 192
  %161 = getelementptr inbounds i8, ptr %0, i64 216
  %162 = getelementptr inbounds i8, ptr %0, i64 384
  %163 = getelementptr inbounds i8, ptr %0, i64 480
  %164 = getelementptr inbounds i8, ptr %0, i64 24
  %165 = getelementptr inbounds i8, ptr %0, i64 48
  %166 = getelementptr inbounds i8, ptr %0, i64 72
  %167 = getelementptr inbounds i8, ptr %0, i64 456
  %168 = getelementptr inbounds i8, ptr %0, i64 408
  %169 = getelementptr inbounds i8, ptr %0, i64 456
  %170 = getelementptr inbounds i8, ptr %0, i64 336
  %171 = getelementptr inbounds i8, ptr %0, i64 168
  %172 = getelementptr inbounds i8, ptr %0, i64 248
  %173 = getelementptr inbounds i8, ptr %0, i64 192
  %174 = getelementptr inbounds i8, ptr %0, i64 216
  %175 = getelementptr inbounds i8, ptr %0, i64 768
  br label %176

176:                                              ; preds = %1948, %74
  %177 = load ptr, ptr %77, align 8
  %178 = load ptr, ptr %78, align 8
  %179 = load ptr, ptr %79, align 8
  %180 = getelementptr inbounds i8, ptr %179, i64 56
  %181 = load i64, ptr %180, align 8
  %182 = icmp eq i64 %181, 0
  br i1 %182, label %1933, label %183

183:                                              ; preds = %176
  %184 = load ptr, ptr %80, align 8
  %185 = load ptr, ptr %81, align 8
  %186 = load ptr, ptr %0, align 8
  %187 = load i64, ptr %82, align 8
  %188 = load ptr, ptr %83, align 8
  %189 = load i64, ptr %188, align 8
  %190 = icmp ne i64 %189, 1
  %191 = getelementptr inbounds i8, ptr %186, i64 8
  %192 = load i64, ptr %191, align 8
  %193 = icmp slt i64 %192, 1
  %194 = getelementptr inbounds i8, ptr %186, i64 32
  %195 = load i64, ptr %194, align 8
  %196 = icmp eq i64 %195, 1
  %197 = load ptr, ptr %84, align 8
  %198 = getelementptr inbounds i8, ptr %197, i64 8
  %199 = load i64, ptr %198, align 8
  %200 = icmp sgt i64 %199, 0
  %201 = load i64, ptr %85, align 8
  %202 = getelementptr double, ptr %184, i64 %201
  %203 = getelementptr i8, ptr %202, i64 -8
  %204 = load double, ptr %203, align 8
  %205 = load double, ptr %184, align 8
  %206 = fsub double %204, %205
  %207 = fmul double %206, 0x3D70000000000000
  %208 = load ptr, ptr %86, align 8
  %209 = load i64, ptr %186, align 8
  %210 = mul nsw i64 %209, %187
  %211 = getelementptr inbounds double, ptr %208, i64 %210
  %212 = load double, ptr %177, align 8
  %213 = getelementptr inbounds i8, ptr %177, i64 8
  %214 = load double, ptr %213, align 8
  %215 = load i64, ptr %179, align 8
  %216 = icmp eq i64 %215, 0
  br i1 %216, label %217, label %477

217:                                              ; preds = %183
  %218 = load i64, ptr %87, align 8
  %219 = icmp eq i64 %218, 0
  br i1 %219, label %249, label %220

220:                                              ; preds = %217
  %221 = icmp sgt i64 %218, 0
  br i1 %221, label %222, label %237

222:                                              ; preds = %220
  %223 = load ptr, ptr %88, align 8
  br label %224

224:                                              ; preds = %222, %224
  %225 = phi i64 [ 0, %222 ], [ %235, %224 ]
  %226 = phi i64 [ %218, %222 ], [ %234, %224 ]
  %227 = add nuw nsw i64 %225, %226
  %228 = lshr i64 %227, 1
  %229 = mul i64 %228, 24
  %230 = getelementptr inbounds i8, ptr %223, i64 %229
  %231 = load double, ptr %230, align 8
  %232 = fcmp ogt double %231, %212
  %233 = add nuw nsw i64 %228, 1
  %234 = select i1 %232, i64 %228, i64 %226
  %235 = select i1 %232, i64 %225, i64 %233
  %236 = icmp slt i64 %235, %234
  br i1 %236, label %224, label %237, !llvm.loop !8

237:                                              ; preds = %224, %220
  %238 = phi i64 [ 0, %220 ], [ %235, %224 ]
  %239 = icmp slt i64 %238, %218
  br i1 %239, label %240, label %246

240:                                              ; preds = %237
  %241 = load ptr, ptr %88, align 8
  %242 = mul i64 %238, 24
  %243 = getelementptr inbounds i8, ptr %241, i64 %242
  %244 = getelementptr inbounds i8, ptr %243, i64 8
  %245 = load double, ptr %244, align 8
  br label %246

246:                                              ; preds = %240, %237
  %247 = phi double [ %245, %240 ], [ 0x7FF0000000000000, %237 ]
  %248 = load ptr, ptr %89, align 8
  store double %247, ptr %248, align 8
  br label %249

249:                                              ; preds = %246, %217
  %250 = getelementptr inbounds i8, ptr %179, i64 24
  %251 = load i64, ptr %250, align 8
  %252 = add nsw i64 %251, 1
  store i64 %252, ptr %250, align 8
  %253 = load ptr, ptr %76, align 8
  %254 = load ptr, ptr %86, align 8
  %255 = load ptr, ptr %90, align 8
  store double %212, ptr %255, align 8
  %256 = load ptr, ptr %75, align 8
  %257 = getelementptr inbounds i8, ptr %256, i64 40
  %258 = load i64, ptr %257, align 8
  %259 = icmp eq i64 %258, 0
  br i1 %259, label %261, label %260

260:                                              ; preds = %249
  tail call fastcc void @settle(ptr noundef nonnull %75) #9
  br label %261

261:                                              ; preds = %260, %249
  %262 = load i64, ptr %91, align 8
  %263 = icmp sgt i64 %262, 0
  br i1 %263, label %264, label %265

264:                                              ; preds = %261
  tail call fastcc void @sample(ptr noundef nonnull %75) #9
  br label %265

265:                                              ; preds = %261, %264
  %266 = load ptr, ptr %75, align 8
  %267 = load i64, ptr %266, align 8
  %268 = load ptr, ptr %90, align 8
  %269 = load ptr, ptr %92, align 8
  %270 = load ptr, ptr %93, align 8
  %271 = inttoptr i64 %267 to ptr
  %272 = load ptr, ptr %271, align 8
  %273 = tail call i32 %272(ptr noundef %268, ptr noundef %253, ptr noundef %269, ptr noundef %270, ptr noundef %254) #10
  %274 = icmp eq i32 %273, 0
  br i1 %274, label %279, label %275

275:                                              ; preds = %265
  %276 = getelementptr inbounds i8, ptr %179, i64 72
  store i64 3, ptr %276, align 8
  %277 = icmp slt i32 %273, 0
  %278 = select i1 %277, i64 -4, i64 2
  br label %1933

279:                                              ; preds = %265
  store i64 1, ptr %179, align 8
  %280 = getelementptr inbounds i8, ptr %177, i64 24
  store double 1.000000e-04, ptr %280, align 8
  %281 = getelementptr inbounds i8, ptr %185, i64 40
  %282 = load double, ptr %281, align 8
  %283 = getelementptr inbounds i8, ptr %177, i64 40
  store double %282, ptr %283, align 8
  %284 = load ptr, ptr %76, align 8
  %285 = load ptr, ptr %75, align 8
  %286 = getelementptr inbounds i8, ptr %285, i64 8
  %287 = load i64, ptr %286, align 8
  %288 = load i64, ptr %85, align 8
  %289 = load ptr, ptr %80, align 8
  %290 = load ptr, ptr %79, align 8
  %291 = getelementptr inbounds i8, ptr %290, i64 48
  %292 = load i64, ptr %291, align 8
  %293 = icmp slt i64 %292, %288
  br i1 %293, label %294, label %317

294:                                              ; preds = %279
  %295 = icmp sgt i64 %287, 0
  br label %296

296:                                              ; preds = %294, %307
  %297 = phi i64 [ %292, %294 ], [ %308, %307 ]
  %298 = getelementptr inbounds double, ptr %289, i64 %297
  %299 = load double, ptr %298, align 8
  %300 = load ptr, ptr %77, align 8
  %301 = load double, ptr %300, align 8
  %302 = fcmp ugt double %299, %301
  br i1 %302, label %317, label %303

303:                                              ; preds = %296
  br i1 %295, label %304, label %307

304:                                              ; preds = %303
  %305 = mul nsw i64 %297, %287
  %306 = getelementptr double, ptr %1, i64 %305
  br label %310

307:                                              ; preds = %310, %303
  %308 = add i64 %297, 1
  %309 = icmp eq i64 %308, %288
  br i1 %309, label %317, label %296, !llvm.loop !9

310:                                              ; preds = %304, %310
  %311 = phi i64 [ 0, %304 ], [ %315, %310 ]
  %312 = getelementptr inbounds double, ptr %284, i64 %311
  %313 = load double, ptr %312, align 8
  %314 = getelementptr double, ptr %306, i64 %311
  store double %313, ptr %314, align 8
  %315 = add nuw nsw i64 %311, 1
  %316 = icmp eq i64 %315, %287
  br i1 %316, label %307, label %310, !llvm.loop !10

317:                                              ; preds = %296, %307, %279
  %318 = phi i64 [ %292, %279 ], [ %297, %296 ], [ %288, %307 ]
  %319 = load ptr, ptr %79, align 8
  %320 = getelementptr inbounds i8, ptr %319, i64 48
  store i64 %318, ptr %320, align 8
  %321 = icmp eq i64 %318, %288
  br i1 %321, label %1933, label %322

322:                                              ; preds = %317
  %323 = fcmp oeq double %214, 0.000000e+00
  br i1 %323, label %324, label %477

324:                                              ; preds = %322
  %325 = load ptr, ptr %75, align 8
  %326 = getelementptr inbounds i8, ptr %325, i64 24
  %327 = load i64, ptr %326, align 8
  %328 = load ptr, ptr %77, align 8
  %329 = getelementptr inbounds i8, ptr %328, i64 16
  %330 = load double, ptr %329, align 8
  %331 = load ptr, ptr %76, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %331, ptr noundef %331, ptr noundef nonnull %76, i64 noundef %327) #9
  %332 = load double, ptr %6, align 8
  %333 = load ptr, ptr %94, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %333, ptr noundef %331, ptr noundef nonnull %76, i64 noundef %327) #9
  %334 = load double, ptr %7, align 8
  %335 = fcmp uge double %332, 1.000000e-05
  %336 = fcmp uge double %334, 1.000000e-05
  %337 = and i1 %335, %336
  %338 = fmul double %332, 1.000000e-02
  %339 = fdiv double %338, %334
  %340 = select i1 %337, double %339, double 0x3EB0C6F7A0B5ED8D
  %341 = fcmp olt double %330, %340
  %342 = select i1 %341, double %330, double %340
  %343 = load ptr, ptr %75, align 8
  %344 = getelementptr inbounds i8, ptr %343, i64 8
  %345 = load i64, ptr %344, align 8
  %346 = icmp sgt i64 %345, 0
  br i1 %346, label %377, label %347

347:                                              ; preds = %377, %324
  %348 = load ptr, ptr %79, align 8
  %349 = getelementptr inbounds i8, ptr %348, i64 24
  %350 = load i64, ptr %349, align 8
  %351 = add nsw i64 %350, 1
  store i64 %351, ptr %349, align 8
  %352 = fadd double %212, %342
  %353 = load ptr, ptr %96, align 8
  %354 = load ptr, ptr %86, align 8
  %355 = load i64, ptr %82, align 8
  %356 = getelementptr inbounds double, ptr %354, i64 %355
  %357 = load ptr, ptr %90, align 8
  store double %352, ptr %357, align 8
  %358 = load ptr, ptr %75, align 8
  %359 = getelementptr inbounds i8, ptr %358, i64 40
  %360 = load i64, ptr %359, align 8
  %361 = icmp eq i64 %360, 0
  br i1 %361, label %363, label %362

362:                                              ; preds = %347
  tail call fastcc void @settle(ptr noundef nonnull %75) #9
  br label %363

363:                                              ; preds = %362, %347
  %364 = load i64, ptr %91, align 8
  %365 = icmp sgt i64 %364, 0
  br i1 %365, label %366, label %367

366:                                              ; preds = %363
  tail call fastcc void @sample(ptr noundef nonnull %75) #9
  br label %367

367:                                              ; preds = %363, %366
  %368 = load ptr, ptr %75, align 8
  %369 = load i64, ptr %368, align 8
  %370 = load ptr, ptr %90, align 8
  %371 = load ptr, ptr %92, align 8
  %372 = load ptr, ptr %93, align 8
  %373 = inttoptr i64 %369 to ptr
  %374 = load ptr, ptr %373, align 8
  %375 = tail call i32 %374(ptr noundef %370, ptr noundef %353, ptr noundef %371, ptr noundef %372, ptr noundef %356) #10
  %376 = icmp eq i32 %375, 0
  br i1 %376, label %396, label %394

377:                                              ; preds = %324, %377
  %378 = phi i64 [ %389, %377 ], [ 0, %324 ]
  %379 = load ptr, ptr %76, align 8
  %380 = getelementptr inbounds double, ptr %379, i64 %378
  %381 = load double, ptr %380, align 8
  %382 = load ptr, ptr %86, align 8
  %383 = getelementptr inbounds double, ptr %382, i64 %378
  %384 = load double, ptr %383, align 8
  %385 = fmul double %342, %384
  %386 = fadd double %381, %385
  %387 = load ptr, ptr %95, align 8
  %388 = getelementptr inbounds double, ptr %387, i64 %378
  store double %386, ptr %388, align 8
  %389 = add nuw nsw i64 %378, 1
  %390 = load ptr, ptr %75, align 8
  %391 = getelementptr inbounds i8, ptr %390, i64 8
  %392 = load i64, ptr %391, align 8
  %393 = icmp slt i64 %389, %392
  br i1 %393, label %377, label %347, !llvm.loop !11

394:                                              ; preds = %367
  %395 = fmul double %342, 1.000000e-03
  br label %472

396:                                              ; preds = %367
  %397 = load ptr, ptr %81, align 8
  %398 = load double, ptr %397, align 8
  %399 = load ptr, ptr %94, align 8
  %400 = load i64, ptr %97, align 8
  %401 = getelementptr inbounds double, ptr %399, i64 %400
  %402 = icmp sgt i64 %327, 0
  br i1 %402, label %403, label %412

403:                                              ; preds = %396, %403
  %404 = phi i64 [ %410, %403 ], [ 0, %396 ]
  %405 = getelementptr inbounds double, ptr %401, i64 %404
  %406 = load double, ptr %405, align 8
  %407 = getelementptr inbounds double, ptr %399, i64 %404
  %408 = load double, ptr %407, align 8
  %409 = fsub double %406, %408
  store double %409, ptr %405, align 8
  %410 = add nuw nsw i64 %404, 1
  %411 = icmp eq i64 %410, %327
  br i1 %411, label %412, label %403, !llvm.loop !12

412:                                              ; preds = %403, %396
  %413 = load ptr, ptr %76, align 8
  call fastcc void @norm_to(ptr noundef nonnull %8, ptr noundef %401, ptr noundef %413, ptr noundef nonnull %76, i64 noundef %327) #9
  %414 = load double, ptr %8, align 8
  %415 = fdiv double %414, %342
  %416 = fcmp ogt double %334, %415
  %417 = select i1 %416, double %334, double %415
  %418 = fcmp ule double %417, 1.000000e-15
  %419 = fdiv double 1.000000e-02, %417
  %420 = select i1 %418, double 1.000000e+13, double %419
  %421 = bitcast double %420 to i64
  %422 = add nsw i64 %421, -4604544271217802189
  %423 = ashr i64 %422, 52
  %424 = and i64 %422, -4503599627370496
  %425 = sub nsw i64 %421, %424
  %426 = bitcast i64 %425 to double
  %427 = fadd double %426, -1.000000e+00
  %428 = fadd double %426, 1.000000e+00
  %429 = fdiv double %427, %428
  %430 = fmul double %429, %429
  %431 = tail call double @llvm.fma.f64(double %430, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %432 = tail call double @llvm.fma.f64(double %431, double %430, double 0x3FE2776C50EF9BFE)
  %433 = tail call double @llvm.fma.f64(double %432, double %430, double 0x3FEEC709DC3A03FD)
  %434 = tail call double @llvm.fma.f64(double %433, double %430, double 0x40071547652B82FE)
  %435 = trunc nsw i64 %423 to i32
  %436 = sitofp i32 %435 to double
  %437 = fmul double %429, %434
  %438 = fadd double %437, %436
  %439 = fmul double %398, %438
  %440 = fcmp ogt double %439, -1.000000e+03
  %441 = select i1 %440, double %439, double -1.000000e+03
  %442 = fcmp olt double %441, 1.000000e+03
  %443 = select i1 %442, double %441, double 1.000000e+03
  %444 = tail call double @llvm.rint.f64(double %443)
  %445 = fsub double %443, %444
  %446 = tail call double @llvm.fma.f64(double %445, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %447 = tail call double @llvm.fma.f64(double %446, double %445, double 0x3F55D87FE78A6730)
  %448 = tail call double @llvm.fma.f64(double %447, double %445, double 0x3F83B2AB6FBA4E77)
  %449 = tail call double @llvm.fma.f64(double %448, double %445, double 0x3FAC6B08D704A0BF)
  %450 = tail call double @llvm.fma.f64(double %449, double %445, double 0x3FCEBFBDFF82C58E)
  %451 = tail call double @llvm.fma.f64(double %450, double %445, double 0x3FE62E42FEFA39EF)
  %452 = tail call double @llvm.fma.f64(double %451, double %445, double 1.000000e+00)
  %453 = bitcast double %452 to i64
  %454 = fptosi double %444 to i32
  %455 = sext i32 %454 to i64
  %456 = shl nsw i64 %455, 52
  %457 = add nsw i64 %456, %453
  %458 = bitcast i64 %457 to double
  %459 = fmul double %342, 1.000000e-03
  %460 = fcmp olt double %459, 0x3EB0C6F7A0B5ED8D
  %461 = select i1 %460, double 0x3EB0C6F7A0B5ED8D, double %459
  %462 = fmul double %342, 1.000000e+02
  %463 = select i1 %418, double %461, double %458
  %464 = fcmp olt double %462, %463
  %465 = select i1 %464, double %462, double %463
  %466 = tail call double @llvm.fabs.f64(double %212)
  %467 = fmul double %466, 0x3D30000000000000
  %468 = fcmp ogt double %467, %465
  %469 = select i1 %468, double %467, double %465
  %470 = fcmp olt double %330, %469
  %471 = select i1 %470, double %330, double %469
  br label %472

472:                                              ; preds = %394, %412
  %473 = phi double [ %395, %394 ], [ %471, %412 ]
  %474 = tail call i1 @llvm.is.fpclass.f64(double %473, i32 639)
  br i1 %474, label %475, label %477

475:                                              ; preds = %472
  %476 = getelementptr inbounds i8, ptr %179, i64 72
  store i64 4, ptr %476, align 8
  br label %477

477:                                              ; preds = %475, %472, %322, %183
  %478 = phi double [ %473, %472 ], [ %473, %475 ], [ %214, %322 ], [ %214, %183 ]
  %479 = load i64, ptr %180, align 8
  %480 = icmp eq i64 %479, 0
  br i1 %480, label %509, label %481

481:                                              ; preds = %477
  %482 = getelementptr inbounds i8, ptr %179, i64 8
  %483 = getelementptr inbounds i8, ptr %179, i64 16
  %484 = getelementptr inbounds i8, ptr %179, i64 64
  %485 = getelementptr inbounds i8, ptr %179, i64 48
  %486 = getelementptr inbounds i8, ptr %177, i64 16
  %487 = getelementptr inbounds i8, ptr %179, i64 24
  %488 = icmp sgt i64 %187, 0
  %489 = select i1 %190, i1 %196, i1 false
  %490 = getelementptr inbounds i8, ptr %177, i64 32
  %491 = getelementptr inbounds i8, ptr %179, i64 48
  %492 = getelementptr inbounds i8, ptr %179, i64 72
  %493 = getelementptr inbounds i8, ptr %177, i64 24
  %494 = getelementptr inbounds i8, ptr %177, i64 40
  %495 = getelementptr inbounds i8, ptr %185, i64 24
  %496 = getelementptr inbounds i8, ptr %185, i64 8
  %497 = getelementptr inbounds i8, ptr %185, i64 16
  %498 = getelementptr inbounds i8, ptr %185, i64 32
  %499 = getelementptr inbounds i8, ptr %185, i64 40
  %500 = icmp sgt i64 %187, 0
  %501 = getelementptr inbounds i8, ptr %179, i64 48
  %502 = getelementptr inbounds i8, ptr %179, i64 72
  %503 = getelementptr inbounds i8, ptr %179, i64 72
  %504 = getelementptr inbounds i8, ptr %177, i64 40
  %505 = getelementptr inbounds i8, ptr %179, i64 72
  %506 = getelementptr inbounds i8, ptr %185, i64 24
  %507 = getelementptr inbounds i8, ptr %185, i64 32
  %508 = getelementptr inbounds i8, ptr %177, i64 40
  br label %511

509:                                              ; preds = %1930, %477
  %510 = phi double [ %478, %477 ], [ %1926, %1930 ]
  store double %510, ptr %213, align 8
  br label %1933

511:                                              ; preds = %481, %1930
  %512 = phi i64 [ %479, %481 ], [ %1931, %1930 ]
  %513 = phi i64 [ undef, %481 ], [ %1929, %1930 ]
  %514 = phi double [ %212, %481 ], [ %1927, %1930 ]
  %515 = phi double [ %478, %481 ], [ %1926, %1930 ]
  %516 = load ptr, ptr %98, align 8
  %517 = getelementptr inbounds i8, ptr %516, i64 8
  %518 = load i64, ptr %517, align 8
  %519 = icmp sgt i64 %518, 0
  br i1 %519, label %520, label %525

520:                                              ; preds = %511
  %521 = load i64, ptr %516, align 8
  %522 = add nsw i64 %521, 3
  %523 = icmp slt i64 %518, %522
  %524 = zext i1 %523 to i32
  br label %525

525:                                              ; preds = %511, %520
  %526 = phi i32 [ 0, %511 ], [ %524, %520 ]
  %527 = icmp eq i32 %526, 0
  br i1 %527, label %529, label %528

528:                                              ; preds = %525
  store double %515, ptr %213, align 8
  br label %1933

529:                                              ; preds = %525
  %530 = add nsw i64 %512, -1
  store i64 %530, ptr %180, align 8
  %531 = load i64, ptr %482, align 8
  %532 = load i64, ptr %483, align 8
  %533 = add nsw i64 %532, %531
  %534 = load i64, ptr %484, align 8
  %535 = icmp slt i64 %533, %534
  br i1 %535, label %537, label %536

536:                                              ; preds = %529
  store double %515, ptr %213, align 8
  br label %1933

537:                                              ; preds = %529
  %538 = load i64, ptr %99, align 8
  %539 = icmp eq i64 %538, 0
  br i1 %539, label %573, label %540

540:                                              ; preds = %537
  %541 = icmp sgt i64 %538, 0
  br i1 %541, label %542, label %557

542:                                              ; preds = %540
  %543 = load ptr, ptr %100, align 8
  br label %544

544:                                              ; preds = %542, %544
  %545 = phi i64 [ 0, %542 ], [ %555, %544 ]
  %546 = phi i64 [ %538, %542 ], [ %554, %544 ]
  %547 = add nuw nsw i64 %545, %546
  %548 = lshr i64 %547, 1
  %549 = mul i64 %548, 24
  %550 = getelementptr inbounds i8, ptr %543, i64 %549
  %551 = load double, ptr %550, align 8
  %552 = fcmp ogt double %551, %514
  %553 = add nuw nsw i64 %548, 1
  %554 = select i1 %552, i64 %548, i64 %546
  %555 = select i1 %552, i64 %545, i64 %553
  %556 = icmp slt i64 %555, %554
  br i1 %556, label %544, label %557, !llvm.loop !8

557:                                              ; preds = %544, %540
  %558 = phi i64 [ 0, %540 ], [ %555, %544 ]
  %559 = load ptr, ptr %100, align 8
  %560 = mul i64 %558, 24
  %561 = getelementptr inbounds i8, ptr %559, i64 %560
  %562 = icmp slt i64 %558, %538
  br i1 %562, label %563, label %566

563:                                              ; preds = %557
  %564 = getelementptr inbounds i8, ptr %561, i64 8
  %565 = load double, ptr %564, align 8
  br label %566

566:                                              ; preds = %563, %557
  %567 = phi double [ %565, %563 ], [ 0x7FF0000000000000, %557 ]
  %568 = load ptr, ptr %101, align 8
  store double %567, ptr %568, align 8
  %569 = load i64, ptr %99, align 8
  %570 = icmp slt i64 %558, %569
  br i1 %570, label %571, label %573

571:                                              ; preds = %566
  %572 = load double, ptr %561, align 8
  br label %573

573:                                              ; preds = %537, %566, %571
  %574 = phi double [ 0x7FF0000000000000, %537 ], [ %572, %571 ], [ 0x7FF0000000000000, %566 ]
  br i1 %193, label %575, label %579

575:                                              ; preds = %573
  %576 = load i64, ptr %485, align 8
  %577 = getelementptr inbounds double, ptr %184, i64 %576
  %578 = load double, ptr %577, align 8
  br label %579

579:                                              ; preds = %575, %573
  %580 = phi double [ %578, %575 ], [ %204, %573 ]
  %581 = fcmp olt double %580, %574
  %582 = select i1 %581, double %580, double %574
  br i1 %193, label %587, label %583

583:                                              ; preds = %579
  %584 = load double, ptr %486, align 8
  %585 = fcmp olt double %515, %584
  %586 = select i1 %585, double %515, double %584
  br label %593

587:                                              ; preds = %579
  %588 = fsub double %582, %514
  %589 = fdiv double %588, %515
  %590 = fmul double %589, 0x3FEFFFFFFFFFDCD1
  %591 = tail call double @llvm.ceil.f64(double %590)
  %592 = fdiv double %588, %591
  br label %593

593:                                              ; preds = %587, %583
  %594 = phi double [ %586, %583 ], [ %592, %587 ]
  %595 = fadd double %514, %594
  %596 = fmul double %594, 1.000000e-03
  %597 = fsub double %582, %596
  %598 = fcmp ule double %595, %597
  %599 = select i1 %598, double %595, double %582
  %600 = fsub double %599, %514
  %601 = fmul double %600, 6.250000e-02
  %602 = fadd double %514, %601
  %603 = fcmp ule double %602, %514
  %604 = fcmp une double %599, %582
  %605 = and i1 %604, %603
  br i1 %605, label %606, label %607

606:                                              ; preds = %593
  store double %600, ptr %213, align 8
  br label %1925

607:                                              ; preds = %593
  %608 = load ptr, ptr %0, align 8
  %609 = load i64, ptr %608, align 8
  %610 = load ptr, ptr %102, align 8
  %611 = insertelement <8 x double> poison, double %600, i64 0
  %612 = shufflevector <8 x double> %611, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %612, ptr %610, align 8
  %613 = icmp sgt i64 %609, 1
  br i1 %613, label %618, label %709

614:                                              ; preds = %697
  %615 = add nuw nsw i64 %621, 1
  %616 = icmp slt i64 %615, %609
  %617 = icmp eq i64 %615, %609
  br i1 %617, label %709, label %618, !llvm.loop !13

618:                                              ; preds = %607, %614
  %619 = phi i1 [ %616, %614 ], [ %613, %607 ]
  %620 = phi i64 [ %708, %614 ], [ undef, %607 ]
  %621 = phi i64 [ %615, %614 ], [ 1, %607 ]
  %622 = load ptr, ptr %103, align 8
  %623 = load ptr, ptr %76, align 8
  %624 = load ptr, ptr %75, align 8
  %625 = getelementptr inbounds i8, ptr %624, i64 16
  %626 = load i64, ptr %625, align 8
  %627 = icmp sgt i64 %626, 1
  %628 = zext i1 %627 to i64
  %629 = load ptr, ptr %104, align 8
  %630 = getelementptr inbounds i64, ptr %629, i64 %621
  %631 = load i64, ptr %630, align 8
  %632 = getelementptr i8, ptr %630, i64 8
  %633 = load i64, ptr %632, align 8
  %634 = xor i64 %631, -1
  %635 = add i64 %633, %634
  %636 = load ptr, ptr %102, align 8
  %637 = load ptr, ptr %105, align 8
  %638 = load ptr, ptr %106, align 8
  %639 = getelementptr inbounds i64, ptr %638, i64 %631
  %640 = load ptr, ptr %107, align 8
  %641 = getelementptr inbounds double, ptr %640, i64 %631
  tail call fastcc void @combine(ptr noundef %622, ptr noundef %623, ptr noundef %636, ptr noundef %637, ptr noundef %639, ptr noundef %641, i64 noundef %635, i64 noundef %628, i64 noundef %626) #9
  %642 = icmp eq i64 %626, 1
  br i1 %642, label %643, label %674

643:                                              ; preds = %618
  %644 = load ptr, ptr %104, align 8
  %645 = getelementptr i64, ptr %644, i64 %621
  %646 = getelementptr i8, ptr %645, i64 8
  %647 = load i64, ptr %646, align 8
  %648 = add nsw i64 %647, -1
  %649 = load ptr, ptr %107, align 8
  %650 = getelementptr inbounds double, ptr %649, i64 %648
  %651 = load double, ptr %650, align 8
  %652 = fmul double %600, %651
  %653 = load ptr, ptr %105, align 8
  %654 = load ptr, ptr %106, align 8
  %655 = getelementptr inbounds i64, ptr %654, i64 %648
  %656 = load i64, ptr %655, align 8
  %657 = getelementptr inbounds double, ptr %653, i64 %656
  %658 = load ptr, ptr %75, align 8
  %659 = getelementptr inbounds i8, ptr %658, i64 8
  %660 = load i64, ptr %659, align 8
  %661 = icmp sgt i64 %660, 0
  br i1 %661, label %662, label %674

662:                                              ; preds = %643, %662
  %663 = phi i64 [ %669, %662 ], [ 0, %643 ]
  %664 = getelementptr inbounds double, ptr %657, i64 %663
  %665 = load double, ptr %664, align 8
  %666 = getelementptr inbounds double, ptr %622, i64 %663
  %667 = load double, ptr %666, align 8
  %668 = tail call double @llvm.fma.f64(double %652, double %665, double %667)
  store double %668, ptr %666, align 8
  %669 = add nuw nsw i64 %663, 1
  %670 = load ptr, ptr %75, align 8
  %671 = getelementptr inbounds i8, ptr %670, i64 8
  %672 = load i64, ptr %671, align 8
  %673 = icmp slt i64 %669, %672
  br i1 %673, label %662, label %674, !llvm.loop !14

674:                                              ; preds = %662, %643, %618
  %675 = load ptr, ptr %105, align 8
  %676 = load i64, ptr %108, align 8
  %677 = mul nsw i64 %676, %621
  %678 = getelementptr inbounds double, ptr %675, i64 %677
  %679 = load i64, ptr %487, align 8
  %680 = add nsw i64 %679, 1
  store i64 %680, ptr %487, align 8
  %681 = load ptr, ptr %109, align 8
  %682 = getelementptr inbounds double, ptr %681, i64 %621
  %683 = load double, ptr %682, align 8
  %684 = fmul double %600, %683
  %685 = fadd double %514, %684
  %686 = load ptr, ptr %103, align 8
  %687 = load ptr, ptr %110, align 8
  store double %685, ptr %687, align 8
  %688 = load ptr, ptr %75, align 8
  %689 = getelementptr inbounds i8, ptr %688, i64 40
  %690 = load i64, ptr %689, align 8
  %691 = icmp eq i64 %690, 0
  br i1 %691, label %693, label %692

692:                                              ; preds = %674
  tail call fastcc void @settle(ptr noundef nonnull %75) #9
  br label %693

693:                                              ; preds = %692, %674
  %694 = load i64, ptr %111, align 8
  %695 = icmp sgt i64 %694, 0
  br i1 %695, label %696, label %697

696:                                              ; preds = %693
  tail call fastcc void @sample(ptr noundef nonnull %75) #9
  br label %697

697:                                              ; preds = %693, %696
  %698 = load ptr, ptr %75, align 8
  %699 = load i64, ptr %698, align 8
  %700 = load ptr, ptr %110, align 8
  %701 = load ptr, ptr %112, align 8
  %702 = load ptr, ptr %113, align 8
  %703 = inttoptr i64 %699 to ptr
  %704 = load ptr, ptr %703, align 8
  %705 = tail call i32 %704(ptr noundef %700, ptr noundef %686, ptr noundef %701, ptr noundef %702, ptr noundef %678) #10
  %706 = sext i32 %705 to i64
  %707 = icmp eq i32 %705, 0
  %708 = select i1 %707, i64 %620, i64 %706
  br i1 %707, label %614, label %709

709:                                              ; preds = %614, %697, %607
  %710 = phi i1 [ %613, %607 ], [ %616, %614 ], [ %619, %697 ]
  %711 = phi i64 [ 0, %607 ], [ %706, %697 ], [ %706, %614 ]
  %712 = phi i64 [ undef, %607 ], [ %708, %697 ], [ %708, %614 ]
  br i1 %710, label %766, label %713

713:                                              ; preds = %709
  %714 = load ptr, ptr %114, align 8
  %715 = load ptr, ptr %76, align 8
  %716 = load ptr, ptr %75, align 8
  %717 = getelementptr inbounds i8, ptr %716, i64 16
  %718 = load i64, ptr %717, align 8
  %719 = icmp sgt i64 %718, 1
  %720 = zext i1 %719 to i64
  %721 = load ptr, ptr %115, align 8
  %722 = getelementptr inbounds i64, ptr %721, i64 %609
  %723 = load i64, ptr %722, align 8
  %724 = getelementptr i8, ptr %722, i64 8
  %725 = load i64, ptr %724, align 8
  %726 = xor i64 %723, -1
  %727 = add i64 %725, %726
  %728 = load ptr, ptr %102, align 8
  %729 = load ptr, ptr %116, align 8
  %730 = load ptr, ptr %117, align 8
  %731 = getelementptr inbounds i64, ptr %730, i64 %723
  %732 = load ptr, ptr %118, align 8
  %733 = getelementptr inbounds double, ptr %732, i64 %723
  tail call fastcc void @combine(ptr noundef %714, ptr noundef %715, ptr noundef %728, ptr noundef %729, ptr noundef %731, ptr noundef %733, i64 noundef %727, i64 noundef %720, i64 noundef %718) #9
  %734 = icmp eq i64 %718, 1
  br i1 %734, label %735, label %766

735:                                              ; preds = %713
  %736 = load ptr, ptr %115, align 8
  %737 = getelementptr i64, ptr %736, i64 %609
  %738 = getelementptr i8, ptr %737, i64 8
  %739 = load i64, ptr %738, align 8
  %740 = add nsw i64 %739, -1
  %741 = load ptr, ptr %118, align 8
  %742 = getelementptr inbounds double, ptr %741, i64 %740
  %743 = load double, ptr %742, align 8
  %744 = fmul double %600, %743
  %745 = load ptr, ptr %116, align 8
  %746 = load ptr, ptr %117, align 8
  %747 = getelementptr inbounds i64, ptr %746, i64 %740
  %748 = load i64, ptr %747, align 8
  %749 = getelementptr inbounds double, ptr %745, i64 %748
  %750 = load ptr, ptr %75, align 8
  %751 = getelementptr inbounds i8, ptr %750, i64 8
  %752 = load i64, ptr %751, align 8
  %753 = icmp sgt i64 %752, 0
  br i1 %753, label %754, label %766

754:                                              ; preds = %735, %754
  %755 = phi i64 [ %761, %754 ], [ 0, %735 ]
  %756 = getelementptr inbounds double, ptr %749, i64 %755
  %757 = load double, ptr %756, align 8
  %758 = getelementptr inbounds double, ptr %714, i64 %755
  %759 = load double, ptr %758, align 8
  %760 = tail call double @llvm.fma.f64(double %744, double %757, double %759)
  store double %760, ptr %758, align 8
  %761 = add nuw nsw i64 %755, 1
  %762 = load ptr, ptr %75, align 8
  %763 = getelementptr inbounds i8, ptr %762, i64 8
  %764 = load i64, ptr %763, align 8
  %765 = icmp slt i64 %761, %764
  br i1 %765, label %754, label %766, !llvm.loop !14

766:                                              ; preds = %754, %735, %713, %709
  %767 = phi i64 [ %712, %709 ], [ %711, %713 ], [ %711, %735 ], [ %711, %754 ]
  %768 = icmp eq i64 %767, 0
  %769 = select i1 %768, i1 %196, i1 false
  br i1 %769, label %770, label %793

770:                                              ; preds = %766
  %771 = load i64, ptr %487, align 8
  %772 = add nsw i64 %771, 1
  store i64 %772, ptr %487, align 8
  %773 = load ptr, ptr %119, align 8
  store double %599, ptr %773, align 8
  %774 = load ptr, ptr %75, align 8
  %775 = getelementptr inbounds i8, ptr %774, i64 40
  %776 = load i64, ptr %775, align 8
  %777 = icmp eq i64 %776, 0
  br i1 %777, label %779, label %778

778:                                              ; preds = %770
  tail call fastcc void @settle(ptr noundef nonnull %75) #9
  br label %779

779:                                              ; preds = %778, %770
  %780 = load i64, ptr %120, align 8
  %781 = icmp sgt i64 %780, 0
  br i1 %781, label %782, label %783

782:                                              ; preds = %779
  tail call fastcc void @sample(ptr noundef nonnull %75) #9
  br label %783

783:                                              ; preds = %779, %782
  %784 = load ptr, ptr %75, align 8
  %785 = load i64, ptr %784, align 8
  %786 = load ptr, ptr %119, align 8
  %787 = load ptr, ptr %121, align 8
  %788 = load ptr, ptr %122, align 8
  %789 = inttoptr i64 %785 to ptr
  %790 = load ptr, ptr %789, align 8
  %791 = tail call i32 %790(ptr noundef %786, ptr noundef %178, ptr noundef %787, ptr noundef %788, ptr noundef %211) #10
  %792 = sext i32 %791 to i64
  br label %793

793:                                              ; preds = %783, %766
  %794 = phi i64 [ %792, %783 ], [ %767, %766 ]
  %795 = icmp slt i64 %794, 0
  br i1 %795, label %1925, label %796

796:                                              ; preds = %793
  %797 = icmp eq i64 %794, 0
  br i1 %797, label %798, label %1140

798:                                              ; preds = %796
  br i1 %193, label %799, label %800

799:                                              ; preds = %798
  br i1 %488, label %1089, label %1098

800:                                              ; preds = %798
  %801 = load ptr, ptr %75, align 8
  %802 = load ptr, ptr %0, align 8
  %803 = getelementptr inbounds i8, ptr %801, i64 24
  %804 = load i64, ptr %803, align 8
  %805 = getelementptr inbounds i8, ptr %802, i64 8
  %806 = load i64, ptr %805, align 8
  %807 = load ptr, ptr %123, align 8
  %808 = load i64, ptr %124, align 8
  %809 = getelementptr inbounds double, ptr %807, i64 %808
  %810 = icmp sgt i64 %806, 0
  br i1 %810, label %811, label %813

811:                                              ; preds = %800
  %812 = getelementptr inbounds i8, ptr %801, i64 32
  br label %821

813:                                              ; preds = %821, %800
  %814 = icmp sgt i64 %804, 0
  br i1 %814, label %815, label %878

815:                                              ; preds = %813
  %816 = load ptr, ptr %76, align 8
  %817 = load ptr, ptr %130, align 8
  %818 = load ptr, ptr %131, align 8
  %819 = load ptr, ptr %132, align 8
  %820 = load ptr, ptr %123, align 8
  br label %847

821:                                              ; preds = %811, %821
  %822 = phi i64 [ 0, %811 ], [ %845, %821 ]
  %823 = load i64, ptr %802, align 8
  %824 = load i64, ptr %812, align 8
  %825 = load ptr, ptr %123, align 8
  %826 = load i64, ptr %124, align 8
  %827 = mul nsw i64 %826, %822
  %828 = getelementptr inbounds double, ptr %825, i64 %827
  %829 = load ptr, ptr %125, align 8
  %830 = load ptr, ptr %126, align 8
  %831 = getelementptr i64, ptr %830, i64 %823
  %832 = getelementptr i8, ptr %831, i64 8
  %833 = getelementptr i64, ptr %832, i64 %822
  %834 = load i64, ptr %833, align 8
  %835 = getelementptr i8, ptr %833, i64 8
  %836 = load i64, ptr %835, align 8
  %837 = xor i64 %834, -1
  %838 = add i64 %836, %837
  %839 = load ptr, ptr %102, align 8
  %840 = load ptr, ptr %127, align 8
  %841 = load ptr, ptr %128, align 8
  %842 = getelementptr inbounds i64, ptr %841, i64 %834
  %843 = load ptr, ptr %129, align 8
  %844 = getelementptr inbounds double, ptr %843, i64 %834
  tail call fastcc void @combine(ptr noundef %828, ptr noundef %829, ptr noundef %839, ptr noundef %840, ptr noundef %842, ptr noundef %844, i64 noundef %838, i64 noundef 1, i64 noundef %824) #9
  %845 = add nuw nsw i64 %822, 1
  %846 = icmp eq i64 %845, %806
  br i1 %846, label %813, label %821, !llvm.loop !15

847:                                              ; preds = %815, %847
  %848 = phi double [ 0.000000e+00, %815 ], [ %873, %847 ]
  %849 = phi double [ 0.000000e+00, %815 ], [ %875, %847 ]
  %850 = phi i64 [ 0, %815 ], [ %876, %847 ]
  %851 = getelementptr inbounds double, ptr %816, i64 %850
  %852 = load double, ptr %851, align 8
  %853 = getelementptr inbounds double, ptr %817, i64 %850
  %854 = load double, ptr %853, align 8
  %855 = getelementptr inbounds double, ptr %818, i64 %850
  %856 = load double, ptr %855, align 8
  %857 = getelementptr inbounds double, ptr %819, i64 %850
  %858 = load double, ptr %857, align 8
  %859 = tail call double @llvm.fabs.f64(double %852)
  %860 = tail call double @llvm.fabs.f64(double %854)
  %861 = fcmp ogt double %859, %860
  %862 = select i1 %861, double %859, double %860
  %863 = fmul double %862, %858
  %864 = fadd double %856, %863
  %865 = fdiv double 1.000000e+00, %864
  %866 = getelementptr inbounds double, ptr %820, i64 %850
  %867 = load double, ptr %866, align 8
  %868 = fmul double %867, %865
  %869 = getelementptr inbounds double, ptr %809, i64 %850
  %870 = load double, ptr %869, align 8
  %871 = fmul double %870, %865
  %872 = fmul double %868, %868
  %873 = fadd double %848, %872
  %874 = fmul double %871, %871
  %875 = fadd double %849, %874
  %876 = add nuw nsw i64 %850, 1
  %877 = icmp eq i64 %876, %804
  br i1 %877, label %878, label %847, !llvm.loop !16

878:                                              ; preds = %847, %813
  %879 = phi double [ 0.000000e+00, %813 ], [ %875, %847 ]
  %880 = phi double [ 0.000000e+00, %813 ], [ %873, %847 ]
  %881 = load ptr, ptr %133, align 8
  %882 = getelementptr inbounds i8, ptr %801, i64 8
  %883 = load i64, ptr %882, align 8
  %884 = add nsw i64 %883, -3
  %885 = getelementptr i8, ptr %881, i64 8
  %886 = getelementptr i8, ptr %881, i64 16
  %887 = getelementptr i8, ptr %881, i64 24
  %888 = icmp slt i64 %804, %884
  br i1 %888, label %896, label %889

889:                                              ; preds = %896, %878
  %890 = phi double [ 0.000000e+00, %878 ], [ %905, %896 ]
  %891 = phi double [ 0.000000e+00, %878 ], [ %909, %896 ]
  %892 = phi double [ 0.000000e+00, %878 ], [ %913, %896 ]
  %893 = phi double [ 0.000000e+00, %878 ], [ %917, %896 ]
  %894 = phi i64 [ %804, %878 ], [ %918, %896 ]
  %895 = icmp slt i64 %894, %883
  br i1 %895, label %920, label %929

896:                                              ; preds = %878, %896
  %897 = phi i64 [ %918, %896 ], [ %804, %878 ]
  %898 = phi double [ %917, %896 ], [ 0.000000e+00, %878 ]
  %899 = phi double [ %913, %896 ], [ 0.000000e+00, %878 ]
  %900 = phi double [ %909, %896 ], [ 0.000000e+00, %878 ]
  %901 = phi double [ %905, %896 ], [ 0.000000e+00, %878 ]
  %902 = getelementptr inbounds double, ptr %881, i64 %897
  %903 = load double, ptr %902, align 8
  %904 = fmul double %903, 0.000000e+00
  %905 = fadd double %901, %904
  %906 = getelementptr double, ptr %885, i64 %897
  %907 = load double, ptr %906, align 8
  %908 = fmul double %907, 0.000000e+00
  %909 = fadd double %900, %908
  %910 = getelementptr double, ptr %886, i64 %897
  %911 = load double, ptr %910, align 8
  %912 = fmul double %911, 0.000000e+00
  %913 = fadd double %899, %912
  %914 = getelementptr double, ptr %887, i64 %897
  %915 = load double, ptr %914, align 8
  %916 = fmul double %915, 0.000000e+00
  %917 = fadd double %898, %916
  %918 = add nsw i64 %897, 4
  %919 = icmp slt i64 %918, %884
  br i1 %919, label %896, label %889, !llvm.loop !17

920:                                              ; preds = %889, %920
  %921 = phi i64 [ %927, %920 ], [ %894, %889 ]
  %922 = phi double [ %926, %920 ], [ %890, %889 ]
  %923 = getelementptr inbounds double, ptr %881, i64 %921
  %924 = load double, ptr %923, align 8
  %925 = fmul double %924, 0.000000e+00
  %926 = fadd double %922, %925
  %927 = add nsw i64 %921, 1
  %928 = icmp eq i64 %927, %883
  br i1 %928, label %929, label %920, !llvm.loop !18

929:                                              ; preds = %920, %889
  %930 = phi double [ %890, %889 ], [ %926, %920 ]
  %931 = fadd double %891, %930
  %932 = fadd double %892, %893
  %933 = fadd double %932, %931
  %934 = fadd double %880, %933
  %935 = icmp eq i64 %806, 2
  br i1 %935, label %936, label %945

936:                                              ; preds = %929
  %937 = fmul double %879, 1.000000e-02
  %938 = fadd double %937, %934
  %939 = sitofp i64 %804 to double
  %940 = fmul double %938, %939
  %941 = tail call double @llvm.sqrt.f64(double %940)
  %942 = fdiv double %934, %941
  %943 = fcmp une double %934, 0.000000e+00
  %944 = select i1 %943, double %942, double 0.000000e+00
  br label %949

945:                                              ; preds = %929
  %946 = sitofp i64 %804 to double
  %947 = fdiv double %934, %946
  %948 = tail call double @llvm.sqrt.f64(double %947)
  br label %949

949:                                              ; preds = %936, %945
  %950 = phi double [ %944, %936 ], [ %948, %945 ]
  %951 = load ptr, ptr %123, align 8
  %952 = load ptr, ptr %102, align 8
  %953 = load double, ptr %952, align 8
  %954 = load i64, ptr %803, align 8
  %955 = getelementptr inbounds i8, ptr %801, i64 48
  %956 = load i64, ptr %955, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %4, i8 0, i64 64, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %5, i8 0, i64 64, i1 false)
  %957 = icmp eq i64 %956, 0
  br i1 %957, label %1087, label %958

958:                                              ; preds = %949
  br i1 %935, label %959, label %961

959:                                              ; preds = %958
  %960 = load i64, ptr %124, align 8
  br label %961

961:                                              ; preds = %959, %958
  %962 = phi i64 [ %960, %959 ], [ 0, %958 ]
  %963 = getelementptr inbounds double, ptr %951, i64 %962
  %964 = add nsw i64 %954, 7
  %965 = sdiv i64 %964, 8
  %966 = shl nsw i64 %965, 3
  %967 = tail call i64 @llvm.smin.i64(i64 %966, i64 %956)
  %968 = icmp slt i64 %954, %967
  br i1 %968, label %969, label %1007

969:                                              ; preds = %961
  %970 = load ptr, ptr %76, align 8
  %971 = load ptr, ptr %134, align 8
  %972 = load ptr, ptr %135, align 8
  br label %973

973:                                              ; preds = %969, %973
  %974 = phi i64 [ %954, %969 ], [ %1005, %973 ]
  %975 = getelementptr inbounds double, ptr %970, i64 %974
  %976 = load double, ptr %975, align 8
  %977 = tail call double @llvm.fabs.f64(double %976)
  %978 = getelementptr inbounds double, ptr %881, i64 %974
  %979 = load double, ptr %978, align 8
  %980 = tail call double @llvm.fabs.f64(double %979)
  %981 = fcmp ogt double %977, %980
  %982 = select i1 %981, double %977, double %980
  %983 = getelementptr inbounds double, ptr %971, i64 %974
  %984 = load double, ptr %983, align 8
  %985 = getelementptr inbounds double, ptr %972, i64 %974
  %986 = load double, ptr %985, align 8
  %987 = fmul double %982, %986
  %988 = fadd double %984, %987
  %989 = fdiv double 1.000000e+00, %988
  %990 = getelementptr inbounds double, ptr %951, i64 %974
  %991 = load double, ptr %990, align 8
  %992 = fmul double %991, %989
  %993 = getelementptr inbounds double, ptr %963, i64 %974
  %994 = load double, ptr %993, align 8
  %995 = fmul double %994, %989
  %996 = srem i64 %974, 8
  %997 = getelementptr inbounds double, ptr %4, i64 %996
  %998 = load double, ptr %997, align 8
  %999 = fmul double %992, %992
  %1000 = fadd double %998, %999
  store double %1000, ptr %997, align 8
  %1001 = getelementptr inbounds double, ptr %5, i64 %996
  %1002 = load double, ptr %1001, align 8
  %1003 = fmul double %995, %995
  %1004 = fadd double %1002, %1003
  store double %1004, ptr %1001, align 8
  %1005 = add nsw i64 %974, 1
  %1006 = icmp eq i64 %1005, %967
  br i1 %1006, label %1007, label %973, !llvm.loop !19

1007:                                             ; preds = %973, %961
  %1008 = phi i64 [ %954, %961 ], [ %1005, %973 ]
  %1009 = load <8 x double>, ptr %4, align 16
  %1010 = load <8 x double>, ptr %5, align 16
  %1011 = icmp slt i64 %1008, %956
  br i1 %1011, label %1012, label %1051

1012:                                             ; preds = %1007
  %1013 = load ptr, ptr %76, align 8
  %1014 = load ptr, ptr %136, align 8
  %1015 = load ptr, ptr %137, align 8
  br label %1016

1016:                                             ; preds = %1012, %1016
  %1017 = phi i64 [ %1008, %1012 ], [ %1049, %1016 ]
  %1018 = phi <8 x double> [ %1009, %1012 ], [ %1046, %1016 ]
  %1019 = phi <8 x double> [ %1010, %1012 ], [ %1048, %1016 ]
  %1020 = getelementptr inbounds double, ptr %1013, i64 %1017
  %1021 = load <8 x double>, ptr %1020, align 8
  %1022 = fneg <8 x double> %1021
  %1023 = fcmp ogt <8 x double> %1021, zeroinitializer
  %1024 = select <8 x i1> %1023, <8 x double> %1021, <8 x double> %1022
  %1025 = getelementptr inbounds double, ptr %881, i64 %1017
  %1026 = load <8 x double>, ptr %1025, align 8
  %1027 = fneg <8 x double> %1026
  %1028 = fcmp ogt <8 x double> %1026, zeroinitializer
  %1029 = select <8 x i1> %1028, <8 x double> %1026, <8 x double> %1027
  %1030 = fcmp ogt <8 x double> %1024, %1029
  %1031 = select <8 x i1> %1030, <8 x double> %1024, <8 x double> %1029
  %1032 = getelementptr inbounds double, ptr %1014, i64 %1017
  %1033 = load <8 x double>, ptr %1032, align 8
  %1034 = getelementptr inbounds double, ptr %1015, i64 %1017
  %1035 = load <8 x double>, ptr %1034, align 8
  %1036 = fmul <8 x double> %1035, %1031
  %1037 = fadd <8 x double> %1033, %1036
  %1038 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1037
  %1039 = getelementptr inbounds double, ptr %951, i64 %1017
  %1040 = load <8 x double>, ptr %1039, align 8
  %1041 = fmul <8 x double> %1040, %1038
  %1042 = getelementptr inbounds double, ptr %963, i64 %1017
  %1043 = load <8 x double>, ptr %1042, align 8
  %1044 = fmul <8 x double> %1043, %1038
  %1045 = fmul <8 x double> %1041, %1041
  %1046 = fadd <8 x double> %1018, %1045
  %1047 = fmul <8 x double> %1044, %1044
  %1048 = fadd <8 x double> %1019, %1047
  %1049 = add nsw i64 %1017, 8
  %1050 = icmp slt i64 %1049, %956
  br i1 %1050, label %1016, label %1051, !llvm.loop !20

1051:                                             ; preds = %1016, %1007
  %1052 = phi <8 x double> [ %1010, %1007 ], [ %1048, %1016 ]
  %1053 = phi <8 x double> [ %1009, %1007 ], [ %1046, %1016 ]
  store <8 x double> %1053, ptr %4, align 16
  store <8 x double> %1052, ptr %5, align 16
  br label %1075

1054:                                             ; preds = %1075
  %1055 = sub nsw i64 %956, %954
  br i1 %935, label %1056, label %1065

1056:                                             ; preds = %1054
  %1057 = fmul double %1084, 1.000000e-02
  %1058 = fadd double %1081, %1057
  %1059 = sitofp i64 %1055 to double
  %1060 = fmul double %1058, %1059
  %1061 = tail call double @llvm.sqrt.f64(double %1060)
  %1062 = fdiv double %1081, %1061
  %1063 = fcmp une double %1081, 0.000000e+00
  %1064 = select i1 %1063, double %1062, double 0.000000e+00
  br label %1069

1065:                                             ; preds = %1054
  %1066 = sitofp i64 %1055 to double
  %1067 = fdiv double %1081, %1066
  %1068 = tail call double @llvm.sqrt.f64(double %1067)
  br label %1069

1069:                                             ; preds = %1065, %1056
  %1070 = phi double [ %1064, %1056 ], [ %1068, %1065 ]
  %1071 = fcmp ule double %953, %207
  %1072 = fcmp ogt double %1070, %950
  %1073 = select i1 %1072, double %1070, double %950
  %1074 = select i1 %1071, double %950, double %1073
  br label %1087

1075:                                             ; preds = %1051, %1075
  %1076 = phi i64 [ 0, %1051 ], [ %1085, %1075 ]
  %1077 = phi double [ 0.000000e+00, %1051 ], [ %1084, %1075 ]
  %1078 = phi double [ 0.000000e+00, %1051 ], [ %1081, %1075 ]
  %1079 = getelementptr inbounds double, ptr %4, i64 %1076
  %1080 = load double, ptr %1079, align 8
  %1081 = fadd double %1078, %1080
  %1082 = getelementptr inbounds double, ptr %5, i64 %1076
  %1083 = load double, ptr %1082, align 8
  %1084 = fadd double %1077, %1083
  %1085 = add nuw nsw i64 %1076, 1
  %1086 = icmp eq i64 %1085, 8
  br i1 %1086, label %1054, label %1075, !llvm.loop !21

1087:                                             ; preds = %949, %1069
  %1088 = phi double [ %1074, %1069 ], [ %950, %949 ]
  br label %1098

1089:                                             ; preds = %799, %1089
  %1090 = phi i64 [ %1096, %1089 ], [ 0, %799 ]
  %1091 = phi double [ %1095, %1089 ], [ 0.000000e+00, %799 ]
  %1092 = getelementptr inbounds double, ptr %178, i64 %1090
  %1093 = load double, ptr %1092, align 8
  %1094 = fmul double %1093, 0.000000e+00
  %1095 = fadd double %1091, %1094
  %1096 = add nuw nsw i64 %1090, 1
  %1097 = icmp eq i64 %1096, %187
  br i1 %1097, label %1098, label %1089, !llvm.loop !22

1098:                                             ; preds = %1089, %799, %1087
  %1099 = phi double [ %1088, %1087 ], [ 0.000000e+00, %799 ], [ %1095, %1089 ]
  %1100 = fcmp uge double %1099, 1.000000e+00
  %1101 = select i1 %1100, i1 true, i1 %489
  br i1 %1101, label %1140, label %1102

1102:                                             ; preds = %1098
  br i1 %190, label %1114, label %1103

1103:                                             ; preds = %1102
  br i1 %193, label %1106, label %1104

1104:                                             ; preds = %1103
  %1105 = load ptr, ptr %76, align 8
  br label %1106

1106:                                             ; preds = %1104, %1103
  %1107 = phi ptr [ %1105, %1104 ], [ null, %1103 ]
  %1108 = load ptr, ptr %83, align 8
  %1109 = getelementptr inbounds i8, ptr %1108, i64 56
  %1110 = load i64, ptr %1109, align 8
  %1111 = inttoptr i64 %1110 to ptr
  %1112 = tail call i64 %1111(ptr noundef %0, double noundef %599, ptr noundef %178, ptr noundef %1107) #10
  %1113 = icmp ne i64 %1112, 0
  br label %1114

1114:                                             ; preds = %1106, %1102
  %1115 = phi i1 [ false, %1102 ], [ %1113, %1106 ]
  br i1 %1115, label %1140, label %1116

1116:                                             ; preds = %1114
  %1117 = load i64, ptr %487, align 8
  %1118 = add nsw i64 %1117, 1
  store i64 %1118, ptr %487, align 8
  %1119 = load ptr, ptr %138, align 8
  store double %599, ptr %1119, align 8
  %1120 = load ptr, ptr %75, align 8
  %1121 = getelementptr inbounds i8, ptr %1120, i64 40
  %1122 = load i64, ptr %1121, align 8
  %1123 = icmp eq i64 %1122, 0
  br i1 %1123, label %1125, label %1124

1124:                                             ; preds = %1116
  tail call fastcc void @settle(ptr noundef nonnull %75) #9
  br label %1125

1125:                                             ; preds = %1124, %1116
  %1126 = load i64, ptr %139, align 8
  %1127 = icmp sgt i64 %1126, 0
  br i1 %1127, label %1128, label %1129

1128:                                             ; preds = %1125
  tail call fastcc void @sample(ptr noundef nonnull %75) #9
  br label %1129

1129:                                             ; preds = %1125, %1128
  %1130 = load ptr, ptr %75, align 8
  %1131 = load i64, ptr %1130, align 8
  %1132 = load ptr, ptr %138, align 8
  %1133 = load ptr, ptr %140, align 8
  %1134 = load ptr, ptr %141, align 8
  %1135 = inttoptr i64 %1131 to ptr
  %1136 = load ptr, ptr %1135, align 8
  %1137 = tail call i32 %1136(ptr noundef %1132, ptr noundef %178, ptr noundef %1133, ptr noundef %1134, ptr noundef %211) #10
  %1138 = sext i32 %1137 to i64
  %1139 = icmp slt i32 %1137, 0
  br i1 %1139, label %1925, label %1140

1140:                                             ; preds = %1129, %1114, %1098, %796
  %1141 = phi i64 [ 0, %1114 ], [ %1138, %1129 ], [ 0, %1098 ], [ %794, %796 ]
  %1142 = phi double [ %1099, %1114 ], [ %1099, %1129 ], [ %1099, %1098 ], [ 0.000000e+00, %796 ]
  %1143 = phi i1 [ %1115, %1114 ], [ %1115, %1129 ], [ false, %1098 ], [ false, %796 ]
  %1144 = icmp ne i64 %1141, 0
  %1145 = fcmp uge double %1142, 1.000000e+00
  %1146 = or i1 %1144, %1145
  %1147 = or i1 %1143, %1146
  br i1 %1147, label %1148, label %1211

1148:                                             ; preds = %1140
  %1149 = load i64, ptr %483, align 8
  %1150 = add nsw i64 %1149, 1
  store i64 %1150, ptr %483, align 8
  %1151 = or i1 %1144, %1143
  br i1 %1151, label %1155, label %1152

1152:                                             ; preds = %1148
  %1153 = tail call double @llvm.fabs.f64(double %1142)
  %1154 = fcmp one double %1153, 0x7FF0000000000000
  br label %1155

1155:                                             ; preds = %1152, %1148
  %1156 = phi i1 [ false, %1148 ], [ %1154, %1152 ]
  %1157 = select i1 %1156, i64 2, i64 4
  %1158 = select i1 %1143, i64 6, i64 %1157
  %1159 = select i1 %1144, i64 3, i64 %1158
  store i64 %1159, ptr %505, align 8
  %1160 = fcmp ogt double %1142, 1.000000e-10
  %1161 = select i1 %1160, double %1142, double 1.000000e-10
  %1162 = load double, ptr %506, align 8
  %1163 = load double, ptr %185, align 8
  %1164 = fneg double %1163
  %1165 = bitcast double %1161 to i64
  %1166 = add nsw i64 %1165, -4604544271217802189
  %1167 = ashr i64 %1166, 52
  %1168 = and i64 %1166, -4503599627370496
  %1169 = sub nsw i64 %1165, %1168
  %1170 = bitcast i64 %1169 to double
  %1171 = fadd double %1170, -1.000000e+00
  %1172 = fadd double %1170, 1.000000e+00
  %1173 = fdiv double %1171, %1172
  %1174 = fmul double %1173, %1173
  %1175 = tail call double @llvm.fma.f64(double %1174, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1176 = tail call double @llvm.fma.f64(double %1175, double %1174, double 0x3FE2776C50EF9BFE)
  %1177 = tail call double @llvm.fma.f64(double %1176, double %1174, double 0x3FEEC709DC3A03FD)
  %1178 = tail call double @llvm.fma.f64(double %1177, double %1174, double 0x40071547652B82FE)
  %1179 = trunc nsw i64 %1167 to i32
  %1180 = sitofp i32 %1179 to double
  %1181 = fmul double %1173, %1178
  %1182 = fadd double %1181, %1180
  %1183 = fmul double %1182, %1164
  %1184 = fcmp ogt double %1183, -1.000000e+03
  %1185 = select i1 %1184, double %1183, double -1.000000e+03
  %1186 = fcmp olt double %1185, 1.000000e+03
  %1187 = select i1 %1186, double %1185, double 1.000000e+03
  %1188 = tail call double @llvm.rint.f64(double %1187)
  %1189 = fsub double %1187, %1188
  %1190 = tail call double @llvm.fma.f64(double %1189, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1191 = tail call double @llvm.fma.f64(double %1190, double %1189, double 0x3F55D87FE78A6730)
  %1192 = tail call double @llvm.fma.f64(double %1191, double %1189, double 0x3F83B2AB6FBA4E77)
  %1193 = tail call double @llvm.fma.f64(double %1192, double %1189, double 0x3FAC6B08D704A0BF)
  %1194 = tail call double @llvm.fma.f64(double %1193, double %1189, double 0x3FCEBFBDFF82C58E)
  %1195 = tail call double @llvm.fma.f64(double %1194, double %1189, double 0x3FE62E42FEFA39EF)
  %1196 = tail call double @llvm.fma.f64(double %1195, double %1189, double 1.000000e+00)
  %1197 = bitcast double %1196 to i64
  %1198 = fptosi double %1188 to i32
  %1199 = sext i32 %1198 to i64
  %1200 = shl nsw i64 %1199, 52
  %1201 = add nsw i64 %1200, %1197
  %1202 = bitcast i64 %1201 to double
  %1203 = fmul double %1162, %1202
  %1204 = load double, ptr %507, align 8
  %1205 = fcmp ogt double %1203, %1204
  %1206 = select i1 %1205, double %1203, double %1204
  %1207 = select i1 %1156, double %1206, double 2.500000e-01
  %1208 = fmul double %600, %1207
  br i1 %193, label %1209, label %1210

1209:                                             ; preds = %1155
  store double %600, ptr %213, align 8
  br label %1925

1210:                                             ; preds = %1155
  store double 1.000000e+00, ptr %508, align 8
  br label %1925, !llvm.loop !23

1211:                                             ; preds = %1140
  %1212 = load i64, ptr %482, align 8
  %1213 = add nsw i64 %1212, 1
  store i64 %1213, ptr %482, align 8
  store double %599, ptr %177, align 8
  store double %600, ptr %490, align 8
  %1214 = load ptr, ptr %98, align 8
  %1215 = getelementptr inbounds i8, ptr %1214, i64 8
  %1216 = load i64, ptr %1215, align 8
  %1217 = icmp eq i64 %1216, 0
  br i1 %1217, label %1247, label %1218

1218:                                             ; preds = %1211
  %1219 = load i64, ptr %1214, align 8
  %1220 = load ptr, ptr %75, align 8
  %1221 = getelementptr inbounds i8, ptr %1220, i64 8
  %1222 = load i64, ptr %1221, align 8
  %1223 = load ptr, ptr %142, align 8
  %1224 = load i64, ptr %143, align 8
  %1225 = mul nsw i64 %1224, %1219
  %1226 = getelementptr inbounds double, ptr %1223, i64 %1225
  %1227 = getelementptr inbounds double, ptr %1226, i64 %1224
  store double %514, ptr %1226, align 8
  %1228 = getelementptr inbounds i8, ptr %1226, i64 8
  store double %600, ptr %1228, align 8
  store double %599, ptr %1227, align 8
  %1229 = getelementptr inbounds i8, ptr %1227, i64 8
  store double 0.000000e+00, ptr %1229, align 8
  %1230 = icmp sgt i64 %1222, 0
  br i1 %1230, label %1234, label %1231

1231:                                             ; preds = %1234, %1218
  %1232 = add nsw i64 %1219, 1
  %1233 = load ptr, ptr %98, align 8
  store i64 %1232, ptr %1233, align 8
  br label %1247

1234:                                             ; preds = %1218, %1234
  %1235 = phi i64 [ %1245, %1234 ], [ 0, %1218 ]
  %1236 = load ptr, ptr %76, align 8
  %1237 = getelementptr inbounds double, ptr %1236, i64 %1235
  %1238 = load double, ptr %1237, align 8
  %1239 = add nuw nsw i64 %1235, 2
  %1240 = getelementptr inbounds double, ptr %1226, i64 %1239
  store double %1238, ptr %1240, align 8
  %1241 = load ptr, ptr %78, align 8
  %1242 = getelementptr inbounds double, ptr %1241, i64 %1235
  %1243 = load double, ptr %1242, align 8
  %1244 = getelementptr inbounds double, ptr %1227, i64 %1239
  store double %1243, ptr %1244, align 8
  %1245 = add nuw nsw i64 %1235, 1
  %1246 = icmp eq i64 %1245, %1222
  br i1 %1246, label %1231, label %1234, !llvm.loop !24

1247:                                             ; preds = %1211, %1231
  br i1 %200, label %1248, label %1358

1248:                                             ; preds = %1247
  %1249 = load ptr, ptr %84, align 8
  %1250 = load i64, ptr %82, align 8
  %1251 = load ptr, ptr %144, align 8
  %1252 = getelementptr inbounds i8, ptr %1249, i64 32
  %1253 = load i64, ptr %1252, align 8
  %1254 = getelementptr inbounds double, ptr %1251, i64 %1253
  %1255 = getelementptr inbounds i8, ptr %1249, i64 24
  %1256 = load i64, ptr %1255, align 8
  %1257 = icmp eq i64 %1256, 0
  br i1 %1257, label %1355, label %1258

1258:                                             ; preds = %1248
  %1259 = getelementptr inbounds i8, ptr %1249, i64 40
  %1260 = load i64, ptr %1259, align 8
  %1261 = icmp sgt i64 %1260, 0
  br i1 %1261, label %1316, label %1262

1262:                                             ; preds = %1334, %1258
  %1263 = load ptr, ptr %145, align 8
  %1264 = load ptr, ptr %84, align 8
  %1265 = getelementptr inbounds i8, ptr %1264, i64 8
  %1266 = load i64, ptr %1265, align 8
  %1267 = load ptr, ptr %146, align 8
  %1268 = load ptr, ptr %144, align 8
  %1269 = getelementptr inbounds i8, ptr %1264, i64 32
  %1270 = load i64, ptr %1269, align 8
  %1271 = getelementptr inbounds i8, ptr %1264, i64 40
  %1272 = load i64, ptr %1271, align 8
  %1273 = getelementptr double, ptr %1268, i64 %1270
  %1274 = getelementptr double, ptr %1273, i64 %1272
  store double %600, ptr %1274, align 8
  %1275 = load ptr, ptr %145, align 8
  store double %514, ptr %1275, align 8
  %1276 = load ptr, ptr %84, align 8
  %1277 = getelementptr inbounds i8, ptr %1276, i64 24
  %1278 = load i64, ptr %1277, align 8
  %1279 = load ptr, ptr %76, align 8
  %1280 = load ptr, ptr %144, align 8
  %1281 = load ptr, ptr %147, align 8
  %1282 = inttoptr i64 %1278 to ptr
  %1283 = load ptr, ptr %1282, align 8
  %1284 = tail call i32 %1283(ptr noundef %1263, ptr noundef %1279, ptr noundef %1280, ptr noundef %1281, ptr noundef %1267) #10
  %1285 = icmp eq i32 %1284, 0
  br i1 %1285, label %1286, label %1355

1286:                                             ; preds = %1262
  %1287 = icmp slt i64 %1266, 1
  br i1 %1287, label %1313, label %1288

1288:                                             ; preds = %1286
  %1289 = load ptr, ptr %148, align 8
  %1290 = getelementptr double, ptr %1267, i64 %1266
  br label %1291

1291:                                             ; preds = %1288, %1309
  %1292 = phi i1 [ %1287, %1288 ], [ %1311, %1309 ]
  %1293 = phi i64 [ 0, %1288 ], [ %1310, %1309 ]
  %1294 = getelementptr inbounds i64, ptr %1289, i64 %1293
  %1295 = load i64, ptr %1294, align 8
  %1296 = and i64 %1295, 2
  %1297 = icmp eq i64 %1296, 0
  br i1 %1297, label %1298, label %1309

1298:                                             ; preds = %1291
  %1299 = getelementptr inbounds double, ptr %1267, i64 %1293
  %1300 = load double, ptr %1299, align 8
  %1301 = load ptr, ptr %149, align 8
  %1302 = getelementptr inbounds i64, ptr %1301, i64 %1293
  %1303 = load i64, ptr %1302, align 8
  %1304 = sitofp i64 %1303 to double
  %1305 = fmul double %1300, %1304
  %1306 = getelementptr double, ptr %1290, i64 %1293
  %1307 = load double, ptr %1306, align 8
  %1308 = fcmp ogt double %1305, %1307
  br i1 %1308, label %1309, label %1313

1309:                                             ; preds = %1298, %1291
  %1310 = add nuw nsw i64 %1293, 1
  %1311 = icmp sge i64 %1310, %1266
  %1312 = icmp eq i64 %1310, %1266
  br i1 %1312, label %1313, label %1291, !llvm.loop !25

1313:                                             ; preds = %1309, %1298, %1286
  %1314 = phi i1 [ %1287, %1286 ], [ %1311, %1309 ], [ %1292, %1298 ]
  %1315 = zext i1 %1314 to i32
  br label %1355

1316:                                             ; preds = %1258, %1334
  %1317 = phi i64 [ %1338, %1334 ], [ 0, %1258 ]
  %1318 = load ptr, ptr %78, align 8
  %1319 = getelementptr inbounds double, ptr %1318, i64 %1317
  %1320 = load <8 x double>, ptr %1319, align 8
  %1321 = load ptr, ptr %76, align 8
  %1322 = getelementptr inbounds double, ptr %1321, i64 %1317
  %1323 = load <8 x double>, ptr %1322, align 8
  %1324 = fsub <8 x double> %1320, %1323
  %1325 = fneg <8 x double> %1324
  %1326 = fcmp ogt <8 x double> %1324, zeroinitializer
  %1327 = select <8 x i1> %1326, <8 x double> %1324, <8 x double> %1325
  %1328 = load ptr, ptr %0, align 8
  %1329 = load i64, ptr %1328, align 8
  %1330 = icmp slt i64 %1329, 0
  br i1 %1330, label %1334, label %1331

1331:                                             ; preds = %1316
  %1332 = load ptr, ptr %86, align 8
  %1333 = getelementptr double, ptr %1332, i64 %1317
  br label %1341

1334:                                             ; preds = %1341, %1316
  %1335 = phi <8 x double> [ %1327, %1316 ], [ %1352, %1341 ]
  %1336 = getelementptr inbounds double, ptr %1254, i64 %1317
  %1337 = fmul <8 x double> %1335, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  store <8 x double> %1337, ptr %1336, align 8
  %1338 = add nuw nsw i64 %1317, 8
  %1339 = load i64, ptr %1259, align 8
  %1340 = icmp slt i64 %1338, %1339
  br i1 %1340, label %1316, label %1262, !llvm.loop !26

1341:                                             ; preds = %1331, %1341
  %1342 = phi i64 [ 0, %1331 ], [ %1353, %1341 ]
  %1343 = phi <8 x double> [ %1327, %1331 ], [ %1352, %1341 ]
  %1344 = mul nsw i64 %1342, %1250
  %1345 = getelementptr double, ptr %1333, i64 %1344
  %1346 = load <8 x double>, ptr %1345, align 8
  %1347 = fneg <8 x double> %1346
  %1348 = fcmp ogt <8 x double> %1346, zeroinitializer
  %1349 = select <8 x i1> %1348, <8 x double> %1346, <8 x double> %1347
  %1350 = fmul <8 x double> %612, %1349
  %1351 = fcmp ogt <8 x double> %1343, %1350
  %1352 = select <8 x i1> %1351, <8 x double> %1343, <8 x double> %1350
  %1353 = add nuw i64 %1342, 1
  %1354 = icmp eq i64 %1342, %1329
  br i1 %1354, label %1334, label %1341, !llvm.loop !27

1355:                                             ; preds = %1313, %1262, %1248
  %1356 = phi i32 [ 0, %1248 ], [ 0, %1262 ], [ %1315, %1313 ]
  %1357 = icmp eq i32 %1356, 0
  br label %1358

1358:                                             ; preds = %1355, %1247
  %1359 = phi i1 [ false, %1247 ], [ %1357, %1355 ]
  br i1 %1359, label %1402, label %1360

1360:                                             ; preds = %1358
  %1361 = load i64, ptr %491, align 8
  %1362 = getelementptr inbounds double, ptr %184, i64 %1361
  %1363 = load double, ptr %1362, align 8
  %1364 = fcmp ult double %1363, %599
  br i1 %1364, label %1402, label %1365

1365:                                             ; preds = %1360
  %1366 = load ptr, ptr %75, align 8
  %1367 = getelementptr inbounds i8, ptr %1366, i64 8
  %1368 = load i64, ptr %1367, align 8
  %1369 = load i64, ptr %85, align 8
  %1370 = load ptr, ptr %80, align 8
  %1371 = load ptr, ptr %79, align 8
  %1372 = getelementptr inbounds i8, ptr %1371, i64 48
  %1373 = load i64, ptr %1372, align 8
  %1374 = icmp slt i64 %1373, %1369
  br i1 %1374, label %1375, label %1398

1375:                                             ; preds = %1365
  %1376 = icmp sgt i64 %1368, 0
  br label %1377

1377:                                             ; preds = %1375, %1388
  %1378 = phi i64 [ %1373, %1375 ], [ %1389, %1388 ]
  %1379 = getelementptr inbounds double, ptr %1370, i64 %1378
  %1380 = load double, ptr %1379, align 8
  %1381 = load ptr, ptr %77, align 8
  %1382 = load double, ptr %1381, align 8
  %1383 = fcmp ugt double %1380, %1382
  br i1 %1383, label %1398, label %1384

1384:                                             ; preds = %1377
  br i1 %1376, label %1385, label %1388

1385:                                             ; preds = %1384
  %1386 = mul nsw i64 %1378, %1368
  %1387 = getelementptr double, ptr %1, i64 %1386
  br label %1391

1388:                                             ; preds = %1391, %1384
  %1389 = add i64 %1378, 1
  %1390 = icmp eq i64 %1389, %1369
  br i1 %1390, label %1398, label %1377, !llvm.loop !9

1391:                                             ; preds = %1385, %1391
  %1392 = phi i64 [ 0, %1385 ], [ %1396, %1391 ]
  %1393 = getelementptr inbounds double, ptr %178, i64 %1392
  %1394 = load double, ptr %1393, align 8
  %1395 = getelementptr double, ptr %1387, i64 %1392
  store double %1394, ptr %1395, align 8
  %1396 = add nuw nsw i64 %1392, 1
  %1397 = icmp eq i64 %1396, %1368
  br i1 %1397, label %1388, label %1391, !llvm.loop !10

1398:                                             ; preds = %1377, %1388, %1365
  %1399 = phi i64 [ %1373, %1365 ], [ %1378, %1377 ], [ %1369, %1388 ]
  %1400 = load ptr, ptr %79, align 8
  %1401 = getelementptr inbounds i8, ptr %1400, i64 48
  store i64 %1399, ptr %1401, align 8
  br label %1768

1402:                                             ; preds = %1360, %1358
  %1403 = load ptr, ptr %0, align 8
  %1404 = load ptr, ptr %75, align 8
  %1405 = getelementptr inbounds i8, ptr %1404, i64 16
  %1406 = load i64, ptr %1405, align 8
  %1407 = load i64, ptr %1403, align 8
  %1408 = load i64, ptr %150, align 8
  %1409 = load ptr, ptr %151, align 8
  %1410 = mul nsw i64 %1408, %1407
  %1411 = getelementptr inbounds double, ptr %1409, i64 %1410
  %1412 = load ptr, ptr %152, align 8
  %1413 = add nsw i64 %1407, 1
  %1414 = getelementptr inbounds i8, ptr %1403, i64 16
  %1415 = load i64, ptr %1414, align 8
  %1416 = icmp sgt i64 %1415, 0
  br i1 %1416, label %1417, label %1478

1417:                                             ; preds = %1402
  %1418 = getelementptr inbounds i8, ptr %1403, i64 8
  br label %1424

1419:                                             ; preds = %1466
  %1420 = add nsw i64 %1427, 1
  %1421 = load i64, ptr %1414, align 8
  %1422 = add nsw i64 %1421, %1413
  %1423 = icmp slt i64 %1420, %1422
  br i1 %1423, label %1424, label %1478, !llvm.loop !28

1424:                                             ; preds = %1417, %1419
  %1425 = phi i1 [ %1416, %1417 ], [ %1423, %1419 ]
  %1426 = phi i64 [ undef, %1417 ], [ %1477, %1419 ]
  %1427 = phi i64 [ %1413, %1417 ], [ %1420, %1419 ]
  %1428 = load i64, ptr %1418, align 8
  %1429 = load ptr, ptr %153, align 8
  %1430 = load ptr, ptr %76, align 8
  %1431 = load ptr, ptr %154, align 8
  %1432 = getelementptr i64, ptr %1431, i64 %1427
  %1433 = getelementptr i64, ptr %1432, i64 %1428
  %1434 = load i64, ptr %1433, align 8
  %1435 = getelementptr i8, ptr %1433, i64 8
  %1436 = load i64, ptr %1435, align 8
  %1437 = xor i64 %1434, -1
  %1438 = add i64 %1436, %1437
  %1439 = load ptr, ptr %102, align 8
  %1440 = load ptr, ptr %151, align 8
  %1441 = load ptr, ptr %155, align 8
  %1442 = getelementptr inbounds i64, ptr %1441, i64 %1434
  %1443 = load ptr, ptr %156, align 8
  %1444 = getelementptr inbounds double, ptr %1443, i64 %1434
  tail call fastcc void @combine(ptr noundef %1429, ptr noundef %1430, ptr noundef %1439, ptr noundef %1440, ptr noundef %1442, ptr noundef %1444, i64 noundef %1438, i64 noundef 1, i64 noundef %1406) #9
  %1445 = load ptr, ptr %151, align 8
  %1446 = mul nsw i64 %1427, %1408
  %1447 = getelementptr inbounds double, ptr %1445, i64 %1446
  %1448 = load i64, ptr %487, align 8
  %1449 = add nsw i64 %1448, 1
  store i64 %1449, ptr %487, align 8
  %1450 = load ptr, ptr %157, align 8
  %1451 = getelementptr inbounds double, ptr %1450, i64 %1427
  %1452 = load double, ptr %1451, align 8
  %1453 = fmul double %600, %1452
  %1454 = fadd double %514, %1453
  %1455 = load ptr, ptr %153, align 8
  %1456 = load ptr, ptr %158, align 8
  store double %1454, ptr %1456, align 8
  %1457 = load ptr, ptr %75, align 8
  %1458 = getelementptr inbounds i8, ptr %1457, i64 40
  %1459 = load i64, ptr %1458, align 8
  %1460 = icmp eq i64 %1459, 0
  br i1 %1460, label %1462, label %1461

1461:                                             ; preds = %1424
  tail call fastcc void @settle(ptr noundef nonnull %75) #9
  br label %1462

1462:                                             ; preds = %1461, %1424
  %1463 = load i64, ptr %159, align 8
  %1464 = icmp sgt i64 %1463, 0
  br i1 %1464, label %1465, label %1466

1465:                                             ; preds = %1462
  tail call fastcc void @sample(ptr noundef nonnull %75) #9
  br label %1466

1466:                                             ; preds = %1462, %1465
  %1467 = load ptr, ptr %75, align 8
  %1468 = load i64, ptr %1467, align 8
  %1469 = load ptr, ptr %158, align 8
  %1470 = load ptr, ptr %160, align 8
  %1471 = load ptr, ptr %161, align 8
  %1472 = inttoptr i64 %1468 to ptr
  %1473 = load ptr, ptr %1472, align 8
  %1474 = tail call i32 %1473(ptr noundef %1469, ptr noundef %1455, ptr noundef %1470, ptr noundef %1471, ptr noundef %1447) #10
  %1475 = sext i32 %1474 to i64
  %1476 = icmp eq i32 %1474, 0
  %1477 = select i1 %1476, i64 %1426, i64 %1475
  br i1 %1476, label %1419, label %1478

1478:                                             ; preds = %1419, %1466, %1402
  %1479 = phi i1 [ %1416, %1402 ], [ %1423, %1419 ], [ %1425, %1466 ]
  %1480 = phi i64 [ 0, %1402 ], [ %1475, %1466 ], [ %1475, %1419 ]
  %1481 = phi i64 [ undef, %1402 ], [ %1477, %1466 ], [ %1477, %1419 ]
  %1482 = getelementptr inbounds i8, ptr %1403, i64 16
  br i1 %1479, label %1551, label %1483

1483:                                             ; preds = %1478
  %1484 = load ptr, ptr %75, align 8
  %1485 = getelementptr inbounds i8, ptr %1484, i64 8
  %1486 = load i64, ptr %1485, align 8
  %1487 = icmp sgt i64 %1486, 0
  br i1 %1487, label %1488, label %1492

1488:                                             ; preds = %1483
  %1489 = getelementptr inbounds double, ptr %1412, i64 %1408
  %1490 = shl nsw i64 %1408, 4
  %1491 = getelementptr inbounds i8, ptr %1412, i64 %1490
  br label %1499

1492:                                             ; preds = %1499, %1483
  %1493 = getelementptr inbounds i8, ptr %1403, i64 8
  %1494 = load i64, ptr %1493, align 8
  %1495 = load i64, ptr %1482, align 8
  %1496 = getelementptr inbounds i8, ptr %1403, i64 24
  %1497 = load i64, ptr %1496, align 8
  %1498 = icmp sgt i64 %1497, 3
  br i1 %1498, label %1526, label %1551

1499:                                             ; preds = %1488, %1499
  %1500 = phi i64 [ 0, %1488 ], [ %1521, %1499 ]
  %1501 = load ptr, ptr %162, align 8
  %1502 = getelementptr inbounds double, ptr %1501, i64 %1500
  %1503 = load double, ptr %1502, align 8
  %1504 = load ptr, ptr %76, align 8
  %1505 = getelementptr inbounds double, ptr %1504, i64 %1500
  %1506 = load double, ptr %1505, align 8
  %1507 = fsub double %1503, %1506
  %1508 = load ptr, ptr %151, align 8
  %1509 = getelementptr inbounds double, ptr %1508, i64 %1500
  %1510 = load double, ptr %1509, align 8
  %1511 = fmul double %600, %1510
  %1512 = fsub double %1511, %1507
  %1513 = getelementptr inbounds double, ptr %1412, i64 %1500
  store double %1507, ptr %1513, align 8
  %1514 = getelementptr inbounds double, ptr %1489, i64 %1500
  store double %1512, ptr %1514, align 8
  %1515 = fsub double %1507, %1512
  %1516 = getelementptr inbounds double, ptr %1411, i64 %1500
  %1517 = load double, ptr %1516, align 8
  %1518 = fmul double %600, %1517
  %1519 = fsub double %1515, %1518
  %1520 = getelementptr inbounds double, ptr %1491, i64 %1500
  store double %1519, ptr %1520, align 8
  %1521 = add nuw nsw i64 %1500, 1
  %1522 = load ptr, ptr %75, align 8
  %1523 = getelementptr inbounds i8, ptr %1522, i64 8
  %1524 = load i64, ptr %1523, align 8
  %1525 = icmp slt i64 %1521, %1524
  br i1 %1525, label %1499, label %1492, !llvm.loop !29

1526:                                             ; preds = %1492, %1526
  %1527 = phi i64 [ %1548, %1526 ], [ 3, %1492 ]
  %1528 = mul nsw i64 %1527, %1408
  %1529 = getelementptr inbounds double, ptr %1412, i64 %1528
  %1530 = load ptr, ptr %163, align 8
  %1531 = load ptr, ptr %164, align 8
  %1532 = getelementptr i64, ptr %1531, i64 %1413
  %1533 = getelementptr i64, ptr %1532, i64 %1494
  %1534 = getelementptr i64, ptr %1533, i64 %1495
  %1535 = getelementptr i64, ptr %1534, i64 %1527
  %1536 = getelementptr i8, ptr %1535, i64 -24
  %1537 = load i64, ptr %1536, align 8
  %1538 = getelementptr i8, ptr %1535, i64 -16
  %1539 = load i64, ptr %1538, align 8
  %1540 = xor i64 %1537, -1
  %1541 = add i64 %1539, %1540
  %1542 = load ptr, ptr %102, align 8
  %1543 = load ptr, ptr %151, align 8
  %1544 = load ptr, ptr %165, align 8
  %1545 = getelementptr inbounds i64, ptr %1544, i64 %1537
  %1546 = load ptr, ptr %166, align 8
  %1547 = getelementptr inbounds double, ptr %1546, i64 %1537
  tail call fastcc void @combine(ptr noundef %1529, ptr noundef %1530, ptr noundef %1542, ptr noundef %1543, ptr noundef %1545, ptr noundef %1547, i64 noundef %1541, i64 noundef 1, i64 noundef %1406) #9
  %1548 = add nuw nsw i64 %1527, 1
  %1549 = load i64, ptr %1496, align 8
  %1550 = icmp slt i64 %1548, %1549
  br i1 %1550, label %1526, label %1551, !llvm.loop !30

1551:                                             ; preds = %1526, %1492, %1478
  %1552 = phi i64 [ %1481, %1478 ], [ %1480, %1492 ], [ %1480, %1526 ]
  %1553 = icmp eq i64 %1552, 0
  br i1 %1553, label %1557, label %1554

1554:                                             ; preds = %1551
  store i64 3, ptr %492, align 8
  store double %514, ptr %177, align 8
  %1555 = icmp slt i64 %1552, 0
  %1556 = select i1 %1555, i64 -4, i64 2
  br label %1925

1557:                                             ; preds = %1551
  %1558 = load ptr, ptr %77, align 8
  br i1 %1359, label %1559, label %1570

1559:                                             ; preds = %1557
  %1560 = load ptr, ptr %84, align 8
  %1561 = getelementptr inbounds i8, ptr %1560, i64 16
  %1562 = load i64, ptr %1561, align 8
  %1563 = inttoptr i64 %1562 to ptr
  %1564 = tail call i64 %1563(ptr noundef %0, double noundef %514, double noundef %600) #10
  %1565 = icmp eq i64 %1564, -6
  br i1 %1565, label %1566, label %1567

1566:                                             ; preds = %1559
  store double %514, ptr %1558, align 8
  br label %1745

1567:                                             ; preds = %1559
  %1568 = getelementptr inbounds i8, ptr %1558, i64 48
  %1569 = load double, ptr %1568, align 8
  br label %1570

1570:                                             ; preds = %1567, %1557
  %1571 = phi double [ %1569, %1567 ], [ 1.000000e+00, %1557 ]
  %1572 = phi i64 [ %1564, %1567 ], [ 0, %1557 ]
  %1573 = fcmp oeq double %1571, 1.000000e+00
  br i1 %1573, label %1574, label %1576

1574:                                             ; preds = %1570
  %1575 = load double, ptr %1558, align 8
  br label %1579

1576:                                             ; preds = %1570
  %1577 = fmul double %600, %1571
  %1578 = fadd double %514, %1577
  br label %1579

1579:                                             ; preds = %1576, %1574
  %1580 = phi double [ %1575, %1574 ], [ %1578, %1576 ]
  %1581 = icmp eq i64 %1572, -4
  %1582 = select i1 %1581, i64 -4, i64 0
  br i1 %1581, label %1640, label %1583

1583:                                             ; preds = %1579
  %1584 = fcmp olt double %1571, 1.000000e+00
  %1585 = load ptr, ptr %75, align 8
  %1586 = getelementptr inbounds i8, ptr %1585, i64 8
  %1587 = load i64, ptr %1586, align 8
  %1588 = load i64, ptr %85, align 8
  %1589 = load ptr, ptr %80, align 8
  %1590 = load ptr, ptr %79, align 8
  %1591 = getelementptr inbounds i8, ptr %1590, i64 48
  %1592 = load i64, ptr %1591, align 8
  %1593 = icmp slt i64 %1592, %1588
  br i1 %1593, label %1594, label %1636

1594:                                             ; preds = %1583, %1632
  %1595 = phi i64 [ %1633, %1632 ], [ undef, %1583 ]
  %1596 = phi i64 [ %1634, %1632 ], [ %1592, %1583 ]
  %1597 = getelementptr inbounds double, ptr %1589, i64 %1596
  %1598 = load double, ptr %1597, align 8
  %1599 = fcmp olt double %1598, %1580
  %1600 = fcmp oeq double %1598, %1580
  %1601 = and i1 %1584, %1600
  %1602 = or i1 %1599, %1601
  br i1 %1602, label %1603, label %1636

1603:                                             ; preds = %1594
  %1604 = fsub double %1598, %514
  %1605 = fdiv double %1604, %600
  %1606 = mul nsw i64 %1596, %1587
  %1607 = getelementptr inbounds double, ptr %1, i64 %1606
  %1608 = load ptr, ptr %167, align 8
  %1609 = insertelement <8 x double> poison, double %1605, i64 0
  %1610 = shufflevector <8 x double> %1609, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1610, ptr %1608, align 8
  %1611 = load ptr, ptr %76, align 8
  %1612 = load ptr, ptr %152, align 8
  %1613 = load i64, ptr %150, align 8
  %1614 = load ptr, ptr %0, align 8
  %1615 = getelementptr inbounds i8, ptr %1614, i64 24
  %1616 = load i64, ptr %1615, align 8
  %1617 = load ptr, ptr %167, align 8
  %1618 = load ptr, ptr %75, align 8
  %1619 = getelementptr inbounds i8, ptr %1618, i64 16
  %1620 = load i64, ptr %1619, align 8
  tail call fastcc void @nested(ptr noundef %1607, ptr noundef %1611, ptr noundef %1612, i64 noundef %1613, i64 noundef %1616, ptr noundef %1617, i64 noundef %1620) #9
  %1621 = load ptr, ptr %83, align 8
  %1622 = load i64, ptr %1621, align 8
  %1623 = icmp eq i64 %1622, 1
  br i1 %1623, label %1624, label %1632

1624:                                             ; preds = %1603
  %1625 = load double, ptr %1597, align 8
  %1626 = getelementptr inbounds i8, ptr %1621, i64 56
  %1627 = load i64, ptr %1626, align 8
  %1628 = inttoptr i64 %1627 to ptr
  %1629 = tail call i64 %1628(ptr noundef %0, double noundef %1625, ptr noundef %1607, ptr noundef null) #10
  %1630 = icmp eq i64 %1629, 0
  %1631 = select i1 %1630, i64 %1595, i64 %1629
  br i1 %1630, label %1632, label %1640

1632:                                             ; preds = %1624, %1603
  %1633 = phi i64 [ %1631, %1624 ], [ %1595, %1603 ]
  %1634 = add i64 %1596, 1
  %1635 = icmp eq i64 %1634, %1588
  br i1 %1635, label %1636, label %1594, !llvm.loop !31

1636:                                             ; preds = %1632, %1594, %1583
  %1637 = phi i64 [ %1592, %1583 ], [ %1588, %1632 ], [ %1596, %1594 ]
  %1638 = load ptr, ptr %79, align 8
  %1639 = getelementptr inbounds i8, ptr %1638, i64 48
  store i64 %1637, ptr %1639, align 8
  br label %1640

1640:                                             ; preds = %1624, %1636, %1579
  %1641 = phi i64 [ %1582, %1579 ], [ 0, %1636 ], [ %1631, %1624 ]
  %1642 = icmp eq i64 %1641, 0
  %1643 = icmp ne i64 %1572, 0
  %1644 = fcmp olt double %1571, 1.000000e+00
  %1645 = and i1 %1644, %1642
  %1646 = and i1 %1643, %1645
  br i1 %1646, label %1647, label %1684

1647:                                             ; preds = %1640
  %1648 = load ptr, ptr %168, align 8
  %1649 = load ptr, ptr %169, align 8
  %1650 = insertelement <8 x double> poison, double %1571, i64 0
  %1651 = shufflevector <8 x double> %1650, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1651, ptr %1649, align 8
  %1652 = load ptr, ptr %76, align 8
  %1653 = load ptr, ptr %152, align 8
  %1654 = load i64, ptr %150, align 8
  %1655 = load ptr, ptr %0, align 8
  %1656 = getelementptr inbounds i8, ptr %1655, i64 24
  %1657 = load i64, ptr %1656, align 8
  %1658 = load ptr, ptr %169, align 8
  %1659 = load ptr, ptr %75, align 8
  %1660 = getelementptr inbounds i8, ptr %1659, i64 16
  %1661 = load i64, ptr %1660, align 8
  tail call fastcc void @nested(ptr noundef %1648, ptr noundef %1652, ptr noundef %1653, i64 noundef %1654, i64 noundef %1657, ptr noundef %1658, i64 noundef %1661) #9
  %1662 = load i64, ptr %82, align 8
  %1663 = icmp sgt i64 %1662, 0
  br i1 %1663, label %1668, label %1664

1664:                                             ; preds = %1668, %1647
  %1665 = load ptr, ptr %83, align 8
  %1666 = load i64, ptr %1665, align 8
  %1667 = icmp eq i64 %1666, 1
  br i1 %1667, label %1678, label %1684

1668:                                             ; preds = %1647, %1668
  %1669 = phi i64 [ %1675, %1668 ], [ 0, %1647 ]
  %1670 = load ptr, ptr %168, align 8
  %1671 = getelementptr inbounds double, ptr %1670, i64 %1669
  %1672 = load double, ptr %1671, align 8
  %1673 = load ptr, ptr %78, align 8
  %1674 = getelementptr inbounds double, ptr %1673, i64 %1669
  store double %1672, ptr %1674, align 8
  %1675 = add nuw nsw i64 %1669, 1
  %1676 = load i64, ptr %82, align 8
  %1677 = icmp slt i64 %1675, %1676
  br i1 %1677, label %1668, label %1664, !llvm.loop !32

1678:                                             ; preds = %1664
  %1679 = load ptr, ptr %78, align 8
  %1680 = getelementptr inbounds i8, ptr %1665, i64 56
  %1681 = load i64, ptr %1680, align 8
  %1682 = inttoptr i64 %1681 to ptr
  %1683 = tail call i64 %1682(ptr noundef %0, double noundef %1580, ptr noundef %1679, ptr noundef null) #10
  br label %1684

1684:                                             ; preds = %1678, %1664, %1640
  %1685 = phi i64 [ %1683, %1678 ], [ 0, %1664 ], [ %1641, %1640 ]
  %1686 = icmp eq i64 %1685, 0
  br i1 %1686, label %1689, label %1687

1687:                                             ; preds = %1684
  store double %514, ptr %1558, align 8
  %1688 = getelementptr inbounds i8, ptr %1558, i64 8
  store double %600, ptr %1688, align 8
  br label %1745

1689:                                             ; preds = %1684
  br i1 %1573, label %1690, label %1728

1690:                                             ; preds = %1689
  %1691 = load ptr, ptr %78, align 8
  %1692 = load ptr, ptr %75, align 8
  %1693 = getelementptr inbounds i8, ptr %1692, i64 8
  %1694 = load i64, ptr %1693, align 8
  %1695 = load i64, ptr %85, align 8
  %1696 = load ptr, ptr %80, align 8
  %1697 = load ptr, ptr %79, align 8
  %1698 = getelementptr inbounds i8, ptr %1697, i64 48
  %1699 = load i64, ptr %1698, align 8
  %1700 = icmp slt i64 %1699, %1695
  br i1 %1700, label %1701, label %1724

1701:                                             ; preds = %1690
  %1702 = icmp sgt i64 %1694, 0
  br label %1703

1703:                                             ; preds = %1701, %1714
  %1704 = phi i64 [ %1699, %1701 ], [ %1715, %1714 ]
  %1705 = getelementptr inbounds double, ptr %1696, i64 %1704
  %1706 = load double, ptr %1705, align 8
  %1707 = load ptr, ptr %77, align 8
  %1708 = load double, ptr %1707, align 8
  %1709 = fcmp ugt double %1706, %1708
  br i1 %1709, label %1724, label %1710

1710:                                             ; preds = %1703
  br i1 %1702, label %1711, label %1714

1711:                                             ; preds = %1710
  %1712 = mul nsw i64 %1704, %1694
  %1713 = getelementptr double, ptr %1, i64 %1712
  br label %1717

1714:                                             ; preds = %1717, %1710
  %1715 = add i64 %1704, 1
  %1716 = icmp eq i64 %1715, %1695
  br i1 %1716, label %1724, label %1703, !llvm.loop !9

1717:                                             ; preds = %1711, %1717
  %1718 = phi i64 [ 0, %1711 ], [ %1722, %1717 ]
  %1719 = getelementptr inbounds double, ptr %1691, i64 %1718
  %1720 = load double, ptr %1719, align 8
  %1721 = getelementptr double, ptr %1713, i64 %1718
  store double %1720, ptr %1721, align 8
  %1722 = add nuw nsw i64 %1718, 1
  %1723 = icmp eq i64 %1722, %1694
  br i1 %1723, label %1714, label %1717, !llvm.loop !10

1724:                                             ; preds = %1714, %1703, %1690
  %1725 = phi i64 [ %1699, %1690 ], [ %1695, %1714 ], [ %1704, %1703 ]
  %1726 = load ptr, ptr %79, align 8
  %1727 = getelementptr inbounds i8, ptr %1726, i64 48
  store i64 %1725, ptr %1727, align 8
  br label %1728

1728:                                             ; preds = %1724, %1689
  br i1 %1643, label %1729, label %1745

1729:                                             ; preds = %1728
  %1730 = load i64, ptr %82, align 8
  %1731 = icmp sgt i64 %1730, 0
  br i1 %1731, label %1735, label %1732

1732:                                             ; preds = %1735, %1729
  store double %1580, ptr %1558, align 8
  %1733 = getelementptr inbounds i8, ptr %1558, i64 8
  store double 0.000000e+00, ptr %1733, align 8
  %1734 = load ptr, ptr %79, align 8
  store i64 0, ptr %1734, align 8
  br label %1745

1735:                                             ; preds = %1729, %1735
  %1736 = phi i64 [ %1742, %1735 ], [ 0, %1729 ]
  %1737 = load ptr, ptr %78, align 8
  %1738 = getelementptr inbounds double, ptr %1737, i64 %1736
  %1739 = load double, ptr %1738, align 8
  %1740 = load ptr, ptr %76, align 8
  %1741 = getelementptr inbounds double, ptr %1740, i64 %1736
  store double %1739, ptr %1741, align 8
  %1742 = add nuw nsw i64 %1736, 1
  %1743 = load i64, ptr %82, align 8
  %1744 = icmp slt i64 %1742, %1743
  br i1 %1744, label %1735, label %1732, !llvm.loop !33

1745:                                             ; preds = %1566, %1687, %1728, %1732
  %1746 = phi i64 [ -6, %1566 ], [ %1685, %1687 ], [ %1572, %1732 ], [ %1572, %1728 ]
  %1747 = icmp eq i64 %1746, -6
  br i1 %1747, label %1752, label %1748

1748:                                             ; preds = %1745
  %1749 = icmp ne i64 %1746, 6
  %1750 = select i1 %1749, i1 true, i1 %193
  %1751 = select i1 %1750, i1 true, i1 %200
  br i1 %1751, label %1762, label %1752

1752:                                             ; preds = %1748, %1745
  %1753 = phi i64 [ %1746, %1748 ], [ 2, %1745 ]
  %1754 = load i64, ptr %482, align 8
  %1755 = add nsw i64 %1754, -1
  store i64 %1755, ptr %482, align 8
  %1756 = load ptr, ptr %98, align 8
  %1757 = load i64, ptr %1756, align 8
  %1758 = add nsw i64 %1757, -1
  store i64 %1758, ptr %1756, align 8
  %1759 = load i64, ptr %483, align 8
  %1760 = add nsw i64 %1759, 1
  store i64 %1760, ptr %483, align 8
  store i64 %1753, ptr %503, align 8
  store double 1.000000e+00, ptr %504, align 8
  %1761 = fmul double %600, 2.500000e-01
  br label %1925, !llvm.loop !23

1762:                                             ; preds = %1748
  %1763 = icmp eq i64 %1746, 0
  br i1 %1763, label %1768, label %1764

1764:                                             ; preds = %1762
  %1765 = load ptr, ptr %98, align 8
  %1766 = load i64, ptr %1765, align 8
  %1767 = add nsw i64 %1766, 1
  store i64 %1767, ptr %1765, align 8
  br label %1925

1768:                                             ; preds = %1762, %1398
  br i1 %193, label %1871, label %1769

1769:                                             ; preds = %1768
  %1770 = load double, ptr %494, align 8
  %1771 = fcmp ogt double %1142, 1.000000e-10
  %1772 = select i1 %1771, double %1142, double 1.000000e-10
  %1773 = load double, ptr %495, align 8
  %1774 = load double, ptr %496, align 8
  %1775 = fneg double %1774
  %1776 = bitcast double %1772 to i64
  %1777 = add nsw i64 %1776, -4604544271217802189
  %1778 = ashr i64 %1777, 52
  %1779 = and i64 %1777, -4503599627370496
  %1780 = sub nsw i64 %1776, %1779
  %1781 = bitcast i64 %1780 to double
  %1782 = fadd double %1781, -1.000000e+00
  %1783 = fadd double %1781, 1.000000e+00
  %1784 = fdiv double %1782, %1783
  %1785 = fmul double %1784, %1784
  %1786 = tail call double @llvm.fma.f64(double %1785, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1787 = tail call double @llvm.fma.f64(double %1786, double %1785, double 0x3FE2776C50EF9BFE)
  %1788 = tail call double @llvm.fma.f64(double %1787, double %1785, double 0x3FEEC709DC3A03FD)
  %1789 = tail call double @llvm.fma.f64(double %1788, double %1785, double 0x40071547652B82FE)
  %1790 = trunc nsw i64 %1778 to i32
  %1791 = sitofp i32 %1790 to double
  %1792 = fmul double %1784, %1789
  %1793 = fadd double %1792, %1791
  %1794 = fmul double %1793, %1775
  %1795 = fcmp ogt double %1794, -1.000000e+03
  %1796 = select i1 %1795, double %1794, double -1.000000e+03
  %1797 = fcmp olt double %1796, 1.000000e+03
  %1798 = select i1 %1797, double %1796, double 1.000000e+03
  %1799 = tail call double @llvm.rint.f64(double %1798)
  %1800 = fsub double %1798, %1799
  %1801 = tail call double @llvm.fma.f64(double %1800, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1802 = tail call double @llvm.fma.f64(double %1801, double %1800, double 0x3F55D87FE78A6730)
  %1803 = tail call double @llvm.fma.f64(double %1802, double %1800, double 0x3F83B2AB6FBA4E77)
  %1804 = tail call double @llvm.fma.f64(double %1803, double %1800, double 0x3FAC6B08D704A0BF)
  %1805 = tail call double @llvm.fma.f64(double %1804, double %1800, double 0x3FCEBFBDFF82C58E)
  %1806 = tail call double @llvm.fma.f64(double %1805, double %1800, double 0x3FE62E42FEFA39EF)
  %1807 = tail call double @llvm.fma.f64(double %1806, double %1800, double 1.000000e+00)
  %1808 = bitcast double %1807 to i64
  %1809 = fptosi double %1799 to i32
  %1810 = sext i32 %1809 to i64
  %1811 = shl nsw i64 %1810, 52
  %1812 = add nsw i64 %1811, %1808
  %1813 = bitcast i64 %1812 to double
  %1814 = fmul double %1773, %1813
  %1815 = load double, ptr %497, align 8
  %1816 = fcmp une double %1815, 0.000000e+00
  br i1 %1816, label %1817, label %1857

1817:                                             ; preds = %1769
  %1818 = load i64, ptr %493, align 8
  %1819 = add nsw i64 %1818, -4604544271217802189
  %1820 = ashr i64 %1819, 52
  %1821 = and i64 %1819, -4503599627370496
  %1822 = sub nsw i64 %1818, %1821
  %1823 = bitcast i64 %1822 to double
  %1824 = fadd double %1823, -1.000000e+00
  %1825 = fadd double %1823, 1.000000e+00
  %1826 = fdiv double %1824, %1825
  %1827 = fmul double %1826, %1826
  %1828 = tail call double @llvm.fma.f64(double %1827, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1829 = tail call double @llvm.fma.f64(double %1828, double %1827, double 0x3FE2776C50EF9BFE)
  %1830 = tail call double @llvm.fma.f64(double %1829, double %1827, double 0x3FEEC709DC3A03FD)
  %1831 = tail call double @llvm.fma.f64(double %1830, double %1827, double 0x40071547652B82FE)
  %1832 = trunc nsw i64 %1820 to i32
  %1833 = sitofp i32 %1832 to double
  %1834 = fmul double %1826, %1831
  %1835 = fadd double %1834, %1833
  %1836 = fmul double %1815, %1835
  %1837 = fcmp ogt double %1836, -1.000000e+03
  %1838 = select i1 %1837, double %1836, double -1.000000e+03
  %1839 = fcmp olt double %1838, 1.000000e+03
  %1840 = select i1 %1839, double %1838, double 1.000000e+03
  %1841 = tail call double @llvm.rint.f64(double %1840)
  %1842 = fsub double %1840, %1841
  %1843 = tail call double @llvm.fma.f64(double %1842, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1844 = tail call double @llvm.fma.f64(double %1843, double %1842, double 0x3F55D87FE78A6730)
  %1845 = tail call double @llvm.fma.f64(double %1844, double %1842, double 0x3F83B2AB6FBA4E77)
  %1846 = tail call double @llvm.fma.f64(double %1845, double %1842, double 0x3FAC6B08D704A0BF)
  %1847 = tail call double @llvm.fma.f64(double %1846, double %1842, double 0x3FCEBFBDFF82C58E)
  %1848 = tail call double @llvm.fma.f64(double %1847, double %1842, double 0x3FE62E42FEFA39EF)
  %1849 = tail call double @llvm.fma.f64(double %1848, double %1842, double 1.000000e+00)
  %1850 = bitcast double %1849 to i64
  %1851 = fptosi double %1841 to i32
  %1852 = sext i32 %1851 to i64
  %1853 = shl nsw i64 %1852, 52
  %1854 = add nsw i64 %1853, %1850
  %1855 = bitcast i64 %1854 to double
  %1856 = fmul double %1814, %1855
  br label %1857

1857:                                             ; preds = %1769, %1817
  %1858 = phi double [ %1856, %1817 ], [ %1814, %1769 ]
  %1859 = load double, ptr %498, align 8
  %1860 = fcmp ogt double %1858, %1859
  %1861 = select i1 %1860, double %1858, double %1859
  %1862 = fcmp olt double %1770, %1861
  %1863 = select i1 %1862, double %1770, double %1861
  %1864 = fmul double %600, %1863
  %1865 = fcmp ogt double %515, %1864
  %1866 = select i1 %1865, double %515, double %1864
  %1867 = select i1 %604, double %1864, double %1866
  %1868 = fcmp ogt double %1142, 1.000000e-04
  %1869 = select i1 %1868, double %1142, double 1.000000e-04
  store double %1869, ptr %493, align 8
  %1870 = load double, ptr %499, align 8
  store double %1870, ptr %494, align 8
  br label %1871

1871:                                             ; preds = %1857, %1768
  %1872 = phi double [ %1867, %1857 ], [ %515, %1768 ]
  br i1 %500, label %1877, label %1873

1873:                                             ; preds = %1877, %1871
  %1874 = load i64, ptr %501, align 8
  %1875 = load i64, ptr %85, align 8
  %1876 = icmp eq i64 %1874, %1875
  br i1 %1876, label %1889, label %1890

1877:                                             ; preds = %1871, %1877
  %1878 = phi i64 [ %1887, %1877 ], [ 0, %1871 ]
  %1879 = getelementptr inbounds double, ptr %178, i64 %1878
  %1880 = load double, ptr %1879, align 8
  %1881 = load ptr, ptr %76, align 8
  %1882 = getelementptr inbounds double, ptr %1881, i64 %1878
  store double %1880, ptr %1882, align 8
  %1883 = getelementptr inbounds double, ptr %211, i64 %1878
  %1884 = load double, ptr %1883, align 8
  %1885 = load ptr, ptr %86, align 8
  %1886 = getelementptr inbounds double, ptr %1885, i64 %1878
  store double %1884, ptr %1886, align 8
  %1887 = add nuw nsw i64 %1878, 1
  %1888 = icmp eq i64 %1887, %187
  br i1 %1888, label %1873, label %1877, !llvm.loop !34

1889:                                             ; preds = %1873
  store double %1872, ptr %213, align 8
  br label %1925

1890:                                             ; preds = %1873
  %1891 = fcmp oeq double %599, %574
  br i1 %1891, label %1892, label %1925

1892:                                             ; preds = %1890
  %1893 = load i64, ptr %99, align 8
  %1894 = icmp sgt i64 %1893, 0
  br i1 %1894, label %1895, label %1897

1895:                                             ; preds = %1892
  %1896 = load ptr, ptr %170, align 8
  store double 0x7FF0000000000000, ptr %1896, align 8
  br label %1897

1897:                                             ; preds = %1892, %1895
  %1898 = load i64, ptr %487, align 8
  %1899 = add nsw i64 %1898, 1
  store i64 %1899, ptr %487, align 8
  %1900 = load ptr, ptr %76, align 8
  %1901 = load ptr, ptr %86, align 8
  %1902 = load ptr, ptr %171, align 8
  store double %599, ptr %1902, align 8
  %1903 = load ptr, ptr %75, align 8
  %1904 = getelementptr inbounds i8, ptr %1903, i64 40
  %1905 = load i64, ptr %1904, align 8
  %1906 = icmp eq i64 %1905, 0
  br i1 %1906, label %1908, label %1907

1907:                                             ; preds = %1897
  tail call fastcc void @settle(ptr noundef nonnull %75) #9
  br label %1908

1908:                                             ; preds = %1907, %1897
  %1909 = load i64, ptr %172, align 8
  %1910 = icmp sgt i64 %1909, 0
  br i1 %1910, label %1911, label %1912

1911:                                             ; preds = %1908
  tail call fastcc void @sample(ptr noundef nonnull %75) #9
  br label %1912

1912:                                             ; preds = %1908, %1911
  %1913 = load ptr, ptr %75, align 8
  %1914 = load i64, ptr %1913, align 8
  %1915 = load ptr, ptr %171, align 8
  %1916 = load ptr, ptr %173, align 8
  %1917 = load ptr, ptr %174, align 8
  %1918 = inttoptr i64 %1914 to ptr
  %1919 = load ptr, ptr %1918, align 8
  %1920 = tail call i32 %1919(ptr noundef %1915, ptr noundef %1900, ptr noundef %1916, ptr noundef %1917, ptr noundef %1901) #10
  %1921 = icmp eq i32 %1920, 0
  br i1 %1921, label %1925, label %1922

1922:                                             ; preds = %1912
  store i64 3, ptr %502, align 8
  store double %1872, ptr %213, align 8
  %1923 = icmp slt i32 %1920, 0
  %1924 = select i1 %1923, i64 -4, i64 2
  br label %1925

1925:                                             ; preds = %1922, %1912, %1890, %1889, %1764, %1752, %1554, %1210, %1209, %1129, %793, %606
  %1926 = phi double [ %515, %606 ], [ %515, %793 ], [ %515, %1129 ], [ %1208, %1210 ], [ %1208, %1209 ], [ %515, %1554 ], [ %1761, %1752 ], [ %515, %1764 ], [ %1872, %1889 ], [ %1872, %1922 ], [ %1872, %1912 ], [ %1872, %1890 ]
  %1927 = phi double [ %514, %606 ], [ %514, %793 ], [ %514, %1129 ], [ %514, %1210 ], [ %514, %1209 ], [ %514, %1554 ], [ %514, %1752 ], [ %514, %1764 ], [ %599, %1889 ], [ %599, %1922 ], [ %599, %1912 ], [ %599, %1890 ]
  %1928 = phi i32 [ 1, %606 ], [ 1, %793 ], [ 1, %1129 ], [ 3, %1210 ], [ 1, %1209 ], [ 1, %1554 ], [ 3, %1752 ], [ 1, %1764 ], [ 1, %1889 ], [ 1, %1922 ], [ 0, %1912 ], [ 0, %1890 ]
  %1929 = phi i64 [ 2, %606 ], [ -4, %793 ], [ -4, %1129 ], [ %513, %1210 ], [ 2, %1209 ], [ %1556, %1554 ], [ %513, %1752 ], [ %1746, %1764 ], [ 0, %1889 ], [ %1924, %1922 ], [ %513, %1912 ], [ %513, %1890 ]
  switch i32 %1928, label %1933 [
    i32 0, label %1930
    i32 3, label %1930
  ]

1930:                                             ; preds = %1925, %1925
  %1931 = load i64, ptr %180, align 8
  %1932 = icmp eq i64 %1931, 0
  br i1 %1932, label %509, label %511, !llvm.loop !23

1933:                                             ; preds = %1925, %176, %275, %317, %509, %528, %536
  %1934 = phi i64 [ -1, %176 ], [ %278, %275 ], [ -1, %509 ], [ -5, %528 ], [ 1, %536 ], [ 0, %317 ], [ %1929, %1925 ]
  %1935 = load ptr, ptr %175, align 8
  %1936 = getelementptr inbounds i8, ptr %1935, i64 48
  %1937 = load i64, ptr %1936, align 8
  %1938 = icmp ne i64 %1934, -2
  %1939 = icmp eq i64 %1937, 0
  %1940 = select i1 %1938, i1 true, i1 %1939
  br i1 %1940, label %1948, label %1941

1941:                                             ; preds = %1933
  %1942 = inttoptr i64 %1937 to ptr
  %1943 = tail call i64 %1942(ptr noundef %0) #10
  %1944 = icmp eq i64 %1943, 8
  %1945 = select i1 %1944, i64 8, i64 %1934
  %1946 = icmp eq i64 %1943, 1
  %1947 = zext i1 %1946 to i32
  br label %1948

1948:                                             ; preds = %1933, %1941
  %1949 = phi i64 [ %1934, %1933 ], [ %1945, %1941 ]
  %1950 = phi i32 [ 0, %1933 ], [ %1947, %1941 ]
  %1951 = icmp eq i32 %1950, 0
  br i1 %1951, label %1952, label %176, !llvm.loop !35

1952:                                             ; preds = %1948
  %1953 = getelementptr inbounds i8, ptr %0, i64 320
  %1954 = load i64, ptr %1953, align 8
  %1955 = icmp sgt i64 %1954, 0
  br i1 %1955, label %1956, label %1959

1956:                                             ; preds = %1952
  %1957 = getelementptr inbounds i8, ptr %0, i64 336
  %1958 = load ptr, ptr %1957, align 8
  store double 0x7FF0000000000000, ptr %1958, align 8
  br label %1959

1959:                                             ; preds = %1952, %1956
  ret i64 %1949
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
  br i1 %60, label %49, label %61, !llvm.loop !36

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
  br i1 %88, label %14, label %13, !llvm.loop !37
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
  br i1 %41, label %13, label %18, !llvm.loop !38
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
  br i1 %53, label %54, label %28, !llvm.loop !39

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
  br i1 %98, label %72, label %99, !llvm.loop !40

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
  br i1 %108, label %16, label %22, !llvm.loop !41

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
  br i1 %133, label %114, label %120, !llvm.loop !39

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
  br i1 %148, label %134, label %149, !llvm.loop !40

149:                                              ; preds = %134, %114
  %150 = phi <8 x double> [ %118, %114 ], [ %146, %134 ]
  store <8 x double> %150, ptr %111, align 8
  %151 = add nuw nsw i64 %110, 8
  %152 = icmp slt i64 %151, %11
  br i1 %152, label %109, label %153, !llvm.loop !42

153:                                              ; preds = %149, %16
  ret void
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #4

declare void @llvm.memset.p0.i64(ptr writeonly, i8, i64, i1 immarg) #6

define internal fastcc void @nested(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, i64 noundef %3, i64 noundef %4, ptr noundef readonly %5, i64 noundef %6) unnamed_addr #7 {
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
  br i1 %31, label %20, label %19, !llvm.loop !43

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
  br i1 %43, label %32, label %24, !llvm.loop !44
}

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #8

declare i64 @llvm.smin.i64(i64, i64) #8

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind willreturn memory(none) }
attributes #5 = { noinline nounwind }
attributes #6 = { nounwind willreturn }
attributes #7 = { noinline nounwind }
attributes #8 = { nounwind willreturn memory(none) }
attributes #9 = { nounwind }
attributes #10 = { nounwind }
attributes #11 = { nounwind }


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
!23 = distinct !{!23, !5}
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
!42 = distinct !{!42, !4, !5}
!43 = distinct !{!43, !4, !5}
!44 = distinct !{!44, !4, !5}
