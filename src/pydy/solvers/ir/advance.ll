; sources 783ed61051ae737cb559f156f6685c122ed35752f1aa72e0d592075b838b82a0
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
  %170 = getelementptr inbounds i8, ptr %0, i64 248
  %171 = getelementptr inbounds i8, ptr %0, i64 336
  %172 = getelementptr inbounds i8, ptr %0, i64 168
  %173 = getelementptr inbounds i8, ptr %0, i64 248
  %174 = getelementptr inbounds i8, ptr %0, i64 192
  %175 = getelementptr inbounds i8, ptr %0, i64 216
  %176 = getelementptr inbounds i8, ptr %0, i64 248
  %177 = getelementptr inbounds i8, ptr %0, i64 768
  br label %178

178:                                              ; preds = %2041, %74
  %179 = load ptr, ptr %77, align 8
  %180 = load ptr, ptr %78, align 8
  %181 = load ptr, ptr %79, align 8
  %182 = getelementptr inbounds i8, ptr %181, i64 56
  %183 = load i64, ptr %182, align 8
  %184 = icmp eq i64 %183, 0
  br i1 %184, label %2026, label %185

185:                                              ; preds = %178
  %186 = load ptr, ptr %80, align 8
  %187 = load ptr, ptr %81, align 8
  %188 = load ptr, ptr %0, align 8
  %189 = load i64, ptr %82, align 8
  %190 = load ptr, ptr %83, align 8
  %191 = load i64, ptr %190, align 8
  %192 = icmp ne i64 %191, 1
  %193 = getelementptr inbounds i8, ptr %188, i64 8
  %194 = load i64, ptr %193, align 8
  %195 = icmp slt i64 %194, 1
  %196 = getelementptr inbounds i8, ptr %188, i64 32
  %197 = load i64, ptr %196, align 8
  %198 = icmp eq i64 %197, 1
  %199 = load ptr, ptr %84, align 8
  %200 = getelementptr inbounds i8, ptr %199, i64 8
  %201 = load i64, ptr %200, align 8
  %202 = icmp sgt i64 %201, 0
  %203 = load i64, ptr %85, align 8
  %204 = getelementptr double, ptr %186, i64 %203
  %205 = getelementptr i8, ptr %204, i64 -8
  %206 = load double, ptr %205, align 8
  %207 = load double, ptr %186, align 8
  %208 = fsub double %206, %207
  %209 = fmul double %208, 0x3D70000000000000
  %210 = load ptr, ptr %86, align 8
  %211 = load i64, ptr %188, align 8
  %212 = mul nsw i64 %211, %189
  %213 = getelementptr inbounds double, ptr %210, i64 %212
  %214 = load double, ptr %179, align 8
  %215 = getelementptr inbounds i8, ptr %179, i64 8
  %216 = load double, ptr %215, align 8
  %217 = load i64, ptr %181, align 8
  %218 = icmp eq i64 %217, 0
  br i1 %218, label %219, label %479

219:                                              ; preds = %185
  %220 = load i64, ptr %87, align 8
  %221 = icmp eq i64 %220, 0
  br i1 %221, label %251, label %222

222:                                              ; preds = %219
  %223 = icmp sgt i64 %220, 0
  br i1 %223, label %224, label %239

224:                                              ; preds = %222
  %225 = load ptr, ptr %88, align 8
  br label %226

226:                                              ; preds = %224, %226
  %227 = phi i64 [ 0, %224 ], [ %237, %226 ]
  %228 = phi i64 [ %220, %224 ], [ %236, %226 ]
  %229 = add nuw nsw i64 %227, %228
  %230 = lshr i64 %229, 1
  %231 = mul i64 %230, 24
  %232 = getelementptr inbounds i8, ptr %225, i64 %231
  %233 = load double, ptr %232, align 8
  %234 = fcmp ogt double %233, %214
  %235 = add nuw nsw i64 %230, 1
  %236 = select i1 %234, i64 %230, i64 %228
  %237 = select i1 %234, i64 %227, i64 %235
  %238 = icmp slt i64 %237, %236
  br i1 %238, label %226, label %239, !llvm.loop !8

239:                                              ; preds = %226, %222
  %240 = phi i64 [ 0, %222 ], [ %237, %226 ]
  %241 = icmp slt i64 %240, %220
  br i1 %241, label %242, label %248

242:                                              ; preds = %239
  %243 = load ptr, ptr %88, align 8
  %244 = mul i64 %240, 24
  %245 = getelementptr inbounds i8, ptr %243, i64 %244
  %246 = getelementptr inbounds i8, ptr %245, i64 8
  %247 = load double, ptr %246, align 8
  br label %248

248:                                              ; preds = %242, %239
  %249 = phi double [ %247, %242 ], [ 0x7FF0000000000000, %239 ]
  %250 = load ptr, ptr %89, align 8
  store double %249, ptr %250, align 8
  br label %251

251:                                              ; preds = %248, %219
  %252 = getelementptr inbounds i8, ptr %181, i64 24
  %253 = load i64, ptr %252, align 8
  %254 = add nsw i64 %253, 1
  store i64 %254, ptr %252, align 8
  %255 = load ptr, ptr %76, align 8
  %256 = load ptr, ptr %86, align 8
  %257 = load ptr, ptr %90, align 8
  store double %214, ptr %257, align 8
  %258 = load ptr, ptr %75, align 8
  %259 = getelementptr inbounds i8, ptr %258, i64 40
  %260 = load i64, ptr %259, align 8
  %261 = icmp eq i64 %260, 0
  br i1 %261, label %263, label %262

262:                                              ; preds = %251
  tail call fastcc void @settle(ptr noundef nonnull %75) #10
  br label %263

263:                                              ; preds = %262, %251
  %264 = load i64, ptr %91, align 8
  %265 = icmp sgt i64 %264, 0
  br i1 %265, label %266, label %267

266:                                              ; preds = %263
  tail call fastcc void @sample(ptr noundef nonnull %75) #10
  br label %267

267:                                              ; preds = %263, %266
  %268 = load ptr, ptr %75, align 8
  %269 = load i64, ptr %268, align 8
  %270 = load ptr, ptr %90, align 8
  %271 = load ptr, ptr %92, align 8
  %272 = load ptr, ptr %93, align 8
  %273 = inttoptr i64 %269 to ptr
  %274 = load ptr, ptr %273, align 8
  %275 = tail call i32 %274(ptr noundef %270, ptr noundef %255, ptr noundef %271, ptr noundef %272, ptr noundef %256) #11
  %276 = icmp eq i32 %275, 0
  br i1 %276, label %281, label %277

277:                                              ; preds = %267
  %278 = getelementptr inbounds i8, ptr %181, i64 72
  store i64 3, ptr %278, align 8
  %279 = icmp slt i32 %275, 0
  %280 = select i1 %279, i64 -4, i64 2
  br label %2026

281:                                              ; preds = %267
  store i64 1, ptr %181, align 8
  %282 = getelementptr inbounds i8, ptr %179, i64 24
  store double 1.000000e-04, ptr %282, align 8
  %283 = getelementptr inbounds i8, ptr %187, i64 40
  %284 = load double, ptr %283, align 8
  %285 = getelementptr inbounds i8, ptr %179, i64 40
  store double %284, ptr %285, align 8
  %286 = load ptr, ptr %76, align 8
  %287 = load ptr, ptr %75, align 8
  %288 = getelementptr inbounds i8, ptr %287, i64 8
  %289 = load i64, ptr %288, align 8
  %290 = load i64, ptr %85, align 8
  %291 = load ptr, ptr %80, align 8
  %292 = load ptr, ptr %79, align 8
  %293 = getelementptr inbounds i8, ptr %292, i64 48
  %294 = load i64, ptr %293, align 8
  %295 = icmp slt i64 %294, %290
  br i1 %295, label %296, label %319

296:                                              ; preds = %281
  %297 = icmp sgt i64 %289, 0
  br label %298

298:                                              ; preds = %296, %309
  %299 = phi i64 [ %294, %296 ], [ %310, %309 ]
  %300 = getelementptr inbounds double, ptr %291, i64 %299
  %301 = load double, ptr %300, align 8
  %302 = load ptr, ptr %77, align 8
  %303 = load double, ptr %302, align 8
  %304 = fcmp ugt double %301, %303
  br i1 %304, label %319, label %305

305:                                              ; preds = %298
  br i1 %297, label %306, label %309

306:                                              ; preds = %305
  %307 = mul nsw i64 %299, %289
  %308 = getelementptr double, ptr %1, i64 %307
  br label %312

309:                                              ; preds = %312, %305
  %310 = add i64 %299, 1
  %311 = icmp eq i64 %310, %290
  br i1 %311, label %319, label %298, !llvm.loop !9

312:                                              ; preds = %306, %312
  %313 = phi i64 [ 0, %306 ], [ %317, %312 ]
  %314 = getelementptr inbounds double, ptr %286, i64 %313
  %315 = load double, ptr %314, align 8
  %316 = getelementptr double, ptr %308, i64 %313
  store double %315, ptr %316, align 8
  %317 = add nuw nsw i64 %313, 1
  %318 = icmp eq i64 %317, %289
  br i1 %318, label %309, label %312, !llvm.loop !10

319:                                              ; preds = %298, %309, %281
  %320 = phi i64 [ %294, %281 ], [ %299, %298 ], [ %290, %309 ]
  %321 = load ptr, ptr %79, align 8
  %322 = getelementptr inbounds i8, ptr %321, i64 48
  store i64 %320, ptr %322, align 8
  %323 = icmp eq i64 %320, %290
  br i1 %323, label %2026, label %324

324:                                              ; preds = %319
  %325 = fcmp oeq double %216, 0.000000e+00
  br i1 %325, label %326, label %479

326:                                              ; preds = %324
  %327 = load ptr, ptr %75, align 8
  %328 = getelementptr inbounds i8, ptr %327, i64 24
  %329 = load i64, ptr %328, align 8
  %330 = load ptr, ptr %77, align 8
  %331 = getelementptr inbounds i8, ptr %330, i64 16
  %332 = load double, ptr %331, align 8
  %333 = load ptr, ptr %76, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %333, ptr noundef %333, ptr noundef nonnull %76, i64 noundef %329) #10
  %334 = load double, ptr %6, align 8
  %335 = load ptr, ptr %94, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %335, ptr noundef %333, ptr noundef nonnull %76, i64 noundef %329) #10
  %336 = load double, ptr %7, align 8
  %337 = fcmp uge double %334, 1.000000e-05
  %338 = fcmp uge double %336, 1.000000e-05
  %339 = and i1 %337, %338
  %340 = fmul double %334, 1.000000e-02
  %341 = fdiv double %340, %336
  %342 = select i1 %339, double %341, double 0x3EB0C6F7A0B5ED8D
  %343 = fcmp olt double %332, %342
  %344 = select i1 %343, double %332, double %342
  %345 = load ptr, ptr %75, align 8
  %346 = getelementptr inbounds i8, ptr %345, i64 8
  %347 = load i64, ptr %346, align 8
  %348 = icmp sgt i64 %347, 0
  br i1 %348, label %379, label %349

349:                                              ; preds = %379, %326
  %350 = load ptr, ptr %79, align 8
  %351 = getelementptr inbounds i8, ptr %350, i64 24
  %352 = load i64, ptr %351, align 8
  %353 = add nsw i64 %352, 1
  store i64 %353, ptr %351, align 8
  %354 = fadd double %214, %344
  %355 = load ptr, ptr %96, align 8
  %356 = load ptr, ptr %86, align 8
  %357 = load i64, ptr %82, align 8
  %358 = getelementptr inbounds double, ptr %356, i64 %357
  %359 = load ptr, ptr %90, align 8
  store double %354, ptr %359, align 8
  %360 = load ptr, ptr %75, align 8
  %361 = getelementptr inbounds i8, ptr %360, i64 40
  %362 = load i64, ptr %361, align 8
  %363 = icmp eq i64 %362, 0
  br i1 %363, label %365, label %364

364:                                              ; preds = %349
  tail call fastcc void @settle(ptr noundef nonnull %75) #10
  br label %365

365:                                              ; preds = %364, %349
  %366 = load i64, ptr %91, align 8
  %367 = icmp sgt i64 %366, 0
  br i1 %367, label %368, label %369

368:                                              ; preds = %365
  tail call fastcc void @sample(ptr noundef nonnull %75) #10
  br label %369

369:                                              ; preds = %365, %368
  %370 = load ptr, ptr %75, align 8
  %371 = load i64, ptr %370, align 8
  %372 = load ptr, ptr %90, align 8
  %373 = load ptr, ptr %92, align 8
  %374 = load ptr, ptr %93, align 8
  %375 = inttoptr i64 %371 to ptr
  %376 = load ptr, ptr %375, align 8
  %377 = tail call i32 %376(ptr noundef %372, ptr noundef %355, ptr noundef %373, ptr noundef %374, ptr noundef %358) #11
  %378 = icmp eq i32 %377, 0
  br i1 %378, label %398, label %396

379:                                              ; preds = %326, %379
  %380 = phi i64 [ %391, %379 ], [ 0, %326 ]
  %381 = load ptr, ptr %76, align 8
  %382 = getelementptr inbounds double, ptr %381, i64 %380
  %383 = load double, ptr %382, align 8
  %384 = load ptr, ptr %86, align 8
  %385 = getelementptr inbounds double, ptr %384, i64 %380
  %386 = load double, ptr %385, align 8
  %387 = fmul double %344, %386
  %388 = fadd double %383, %387
  %389 = load ptr, ptr %95, align 8
  %390 = getelementptr inbounds double, ptr %389, i64 %380
  store double %388, ptr %390, align 8
  %391 = add nuw nsw i64 %380, 1
  %392 = load ptr, ptr %75, align 8
  %393 = getelementptr inbounds i8, ptr %392, i64 8
  %394 = load i64, ptr %393, align 8
  %395 = icmp slt i64 %391, %394
  br i1 %395, label %379, label %349, !llvm.loop !11

396:                                              ; preds = %369
  %397 = fmul double %344, 1.000000e-03
  br label %474

398:                                              ; preds = %369
  %399 = load ptr, ptr %81, align 8
  %400 = load double, ptr %399, align 8
  %401 = load ptr, ptr %94, align 8
  %402 = load i64, ptr %97, align 8
  %403 = getelementptr inbounds double, ptr %401, i64 %402
  %404 = icmp sgt i64 %329, 0
  br i1 %404, label %405, label %414

405:                                              ; preds = %398, %405
  %406 = phi i64 [ %412, %405 ], [ 0, %398 ]
  %407 = getelementptr inbounds double, ptr %403, i64 %406
  %408 = load double, ptr %407, align 8
  %409 = getelementptr inbounds double, ptr %401, i64 %406
  %410 = load double, ptr %409, align 8
  %411 = fsub double %408, %410
  store double %411, ptr %407, align 8
  %412 = add nuw nsw i64 %406, 1
  %413 = icmp eq i64 %412, %329
  br i1 %413, label %414, label %405, !llvm.loop !12

414:                                              ; preds = %405, %398
  %415 = load ptr, ptr %76, align 8
  call fastcc void @norm_to(ptr noundef nonnull %8, ptr noundef %403, ptr noundef %415, ptr noundef nonnull %76, i64 noundef %329) #10
  %416 = load double, ptr %8, align 8
  %417 = fdiv double %416, %344
  %418 = fcmp ogt double %336, %417
  %419 = select i1 %418, double %336, double %417
  %420 = fcmp ule double %419, 1.000000e-15
  %421 = fdiv double 1.000000e-02, %419
  %422 = select i1 %420, double 1.000000e+13, double %421
  %423 = bitcast double %422 to i64
  %424 = add nsw i64 %423, -4604544271217802189
  %425 = ashr i64 %424, 52
  %426 = and i64 %424, -4503599627370496
  %427 = sub nsw i64 %423, %426
  %428 = bitcast i64 %427 to double
  %429 = fadd double %428, -1.000000e+00
  %430 = fadd double %428, 1.000000e+00
  %431 = fdiv double %429, %430
  %432 = fmul double %431, %431
  %433 = tail call double @llvm.fma.f64(double %432, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %434 = tail call double @llvm.fma.f64(double %433, double %432, double 0x3FE2776C50EF9BFE)
  %435 = tail call double @llvm.fma.f64(double %434, double %432, double 0x3FEEC709DC3A03FD)
  %436 = tail call double @llvm.fma.f64(double %435, double %432, double 0x40071547652B82FE)
  %437 = trunc nsw i64 %425 to i32
  %438 = sitofp i32 %437 to double
  %439 = fmul double %431, %436
  %440 = fadd double %439, %438
  %441 = fmul double %400, %440
  %442 = fcmp ogt double %441, -1.000000e+03
  %443 = select i1 %442, double %441, double -1.000000e+03
  %444 = fcmp olt double %443, 1.000000e+03
  %445 = select i1 %444, double %443, double 1.000000e+03
  %446 = tail call double @llvm.rint.f64(double %445)
  %447 = fsub double %445, %446
  %448 = tail call double @llvm.fma.f64(double %447, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %449 = tail call double @llvm.fma.f64(double %448, double %447, double 0x3F55D87FE78A6730)
  %450 = tail call double @llvm.fma.f64(double %449, double %447, double 0x3F83B2AB6FBA4E77)
  %451 = tail call double @llvm.fma.f64(double %450, double %447, double 0x3FAC6B08D704A0BF)
  %452 = tail call double @llvm.fma.f64(double %451, double %447, double 0x3FCEBFBDFF82C58E)
  %453 = tail call double @llvm.fma.f64(double %452, double %447, double 0x3FE62E42FEFA39EF)
  %454 = tail call double @llvm.fma.f64(double %453, double %447, double 1.000000e+00)
  %455 = bitcast double %454 to i64
  %456 = fptosi double %446 to i32
  %457 = sext i32 %456 to i64
  %458 = shl nsw i64 %457, 52
  %459 = add nsw i64 %458, %455
  %460 = bitcast i64 %459 to double
  %461 = fmul double %344, 1.000000e-03
  %462 = fcmp olt double %461, 0x3EB0C6F7A0B5ED8D
  %463 = select i1 %462, double 0x3EB0C6F7A0B5ED8D, double %461
  %464 = fmul double %344, 1.000000e+02
  %465 = select i1 %420, double %463, double %460
  %466 = fcmp olt double %464, %465
  %467 = select i1 %466, double %464, double %465
  %468 = tail call double @llvm.fabs.f64(double %214)
  %469 = fmul double %468, 0x3D30000000000000
  %470 = fcmp ogt double %469, %467
  %471 = select i1 %470, double %469, double %467
  %472 = fcmp olt double %332, %471
  %473 = select i1 %472, double %332, double %471
  br label %474

474:                                              ; preds = %396, %414
  %475 = phi double [ %397, %396 ], [ %473, %414 ]
  %476 = tail call i1 @llvm.is.fpclass.f64(double %475, i32 639)
  br i1 %476, label %477, label %479

477:                                              ; preds = %474
  %478 = getelementptr inbounds i8, ptr %181, i64 72
  store i64 4, ptr %478, align 8
  br label %479

479:                                              ; preds = %477, %474, %324, %185
  %480 = phi double [ %475, %474 ], [ %475, %477 ], [ %216, %324 ], [ %216, %185 ]
  %481 = load i64, ptr %182, align 8
  %482 = icmp eq i64 %481, 0
  br i1 %482, label %512, label %483

483:                                              ; preds = %479
  %484 = getelementptr inbounds i8, ptr %181, i64 8
  %485 = getelementptr inbounds i8, ptr %181, i64 16
  %486 = getelementptr inbounds i8, ptr %181, i64 64
  %487 = getelementptr inbounds i8, ptr %181, i64 48
  %488 = getelementptr inbounds i8, ptr %179, i64 16
  %489 = getelementptr inbounds i8, ptr %181, i64 24
  %490 = icmp sgt i64 %189, 0
  %491 = select i1 %192, i1 %198, i1 false
  %492 = getelementptr inbounds i8, ptr %179, i64 32
  %493 = getelementptr inbounds i8, ptr %181, i64 48
  %494 = getelementptr inbounds i8, ptr %181, i64 72
  %495 = getelementptr inbounds i8, ptr %179, i64 24
  %496 = getelementptr inbounds i8, ptr %179, i64 40
  %497 = getelementptr inbounds i8, ptr %187, i64 24
  %498 = getelementptr inbounds i8, ptr %187, i64 8
  %499 = getelementptr inbounds i8, ptr %187, i64 16
  %500 = getelementptr inbounds i8, ptr %187, i64 32
  %501 = getelementptr inbounds i8, ptr %187, i64 40
  %502 = getelementptr inbounds i8, ptr %187, i64 40
  %503 = icmp sgt i64 %189, 0
  %504 = getelementptr inbounds i8, ptr %181, i64 48
  %505 = getelementptr inbounds i8, ptr %181, i64 72
  %506 = getelementptr inbounds i8, ptr %181, i64 72
  %507 = getelementptr inbounds i8, ptr %179, i64 40
  %508 = getelementptr inbounds i8, ptr %181, i64 72
  %509 = getelementptr inbounds i8, ptr %187, i64 24
  %510 = getelementptr inbounds i8, ptr %187, i64 32
  %511 = getelementptr inbounds i8, ptr %179, i64 40
  br label %514

512:                                              ; preds = %2023, %479
  %513 = phi double [ %480, %479 ], [ %2019, %2023 ]
  store double %513, ptr %215, align 8
  br label %2026

514:                                              ; preds = %483, %2023
  %515 = phi i64 [ %481, %483 ], [ %2024, %2023 ]
  %516 = phi i64 [ undef, %483 ], [ %2022, %2023 ]
  %517 = phi double [ %214, %483 ], [ %2020, %2023 ]
  %518 = phi double [ %480, %483 ], [ %2019, %2023 ]
  %519 = load ptr, ptr %98, align 8
  %520 = getelementptr inbounds i8, ptr %519, i64 8
  %521 = load i64, ptr %520, align 8
  %522 = icmp sgt i64 %521, 0
  br i1 %522, label %523, label %528

523:                                              ; preds = %514
  %524 = load i64, ptr %519, align 8
  %525 = add nsw i64 %524, 3
  %526 = icmp slt i64 %521, %525
  %527 = zext i1 %526 to i32
  br label %528

528:                                              ; preds = %514, %523
  %529 = phi i32 [ 0, %514 ], [ %527, %523 ]
  %530 = icmp eq i32 %529, 0
  br i1 %530, label %532, label %531

531:                                              ; preds = %528
  store double %518, ptr %215, align 8
  br label %2026

532:                                              ; preds = %528
  %533 = add nsw i64 %515, -1
  store i64 %533, ptr %182, align 8
  %534 = load i64, ptr %484, align 8
  %535 = load i64, ptr %485, align 8
  %536 = add nsw i64 %535, %534
  %537 = load i64, ptr %486, align 8
  %538 = icmp slt i64 %536, %537
  br i1 %538, label %540, label %539

539:                                              ; preds = %532
  store double %518, ptr %215, align 8
  br label %2026

540:                                              ; preds = %532
  %541 = load i64, ptr %99, align 8
  %542 = icmp eq i64 %541, 0
  br i1 %542, label %576, label %543

543:                                              ; preds = %540
  %544 = icmp sgt i64 %541, 0
  br i1 %544, label %545, label %560

545:                                              ; preds = %543
  %546 = load ptr, ptr %100, align 8
  br label %547

547:                                              ; preds = %545, %547
  %548 = phi i64 [ 0, %545 ], [ %558, %547 ]
  %549 = phi i64 [ %541, %545 ], [ %557, %547 ]
  %550 = add nuw nsw i64 %548, %549
  %551 = lshr i64 %550, 1
  %552 = mul i64 %551, 24
  %553 = getelementptr inbounds i8, ptr %546, i64 %552
  %554 = load double, ptr %553, align 8
  %555 = fcmp ogt double %554, %517
  %556 = add nuw nsw i64 %551, 1
  %557 = select i1 %555, i64 %551, i64 %549
  %558 = select i1 %555, i64 %548, i64 %556
  %559 = icmp slt i64 %558, %557
  br i1 %559, label %547, label %560, !llvm.loop !8

560:                                              ; preds = %547, %543
  %561 = phi i64 [ 0, %543 ], [ %558, %547 ]
  %562 = load ptr, ptr %100, align 8
  %563 = mul i64 %561, 24
  %564 = getelementptr inbounds i8, ptr %562, i64 %563
  %565 = icmp slt i64 %561, %541
  br i1 %565, label %566, label %569

566:                                              ; preds = %560
  %567 = getelementptr inbounds i8, ptr %564, i64 8
  %568 = load double, ptr %567, align 8
  br label %569

569:                                              ; preds = %566, %560
  %570 = phi double [ %568, %566 ], [ 0x7FF0000000000000, %560 ]
  %571 = load ptr, ptr %101, align 8
  store double %570, ptr %571, align 8
  %572 = load i64, ptr %99, align 8
  %573 = icmp slt i64 %561, %572
  br i1 %573, label %574, label %576

574:                                              ; preds = %569
  %575 = load double, ptr %564, align 8
  br label %576

576:                                              ; preds = %540, %569, %574
  %577 = phi double [ 0x7FF0000000000000, %540 ], [ %575, %574 ], [ 0x7FF0000000000000, %569 ]
  br i1 %195, label %578, label %582

578:                                              ; preds = %576
  %579 = load i64, ptr %487, align 8
  %580 = getelementptr inbounds double, ptr %186, i64 %579
  %581 = load double, ptr %580, align 8
  br label %582

582:                                              ; preds = %578, %576
  %583 = phi double [ %581, %578 ], [ %206, %576 ]
  %584 = fcmp olt double %583, %577
  %585 = select i1 %584, double %583, double %577
  br i1 %195, label %590, label %586

586:                                              ; preds = %582
  %587 = load double, ptr %488, align 8
  %588 = fcmp olt double %518, %587
  %589 = select i1 %588, double %518, double %587
  br label %596

590:                                              ; preds = %582
  %591 = fsub double %585, %517
  %592 = fdiv double %591, %518
  %593 = fmul double %592, 0x3FEFFFFFFFFFDCD1
  %594 = tail call double @llvm.ceil.f64(double %593)
  %595 = fdiv double %591, %594
  br label %596

596:                                              ; preds = %590, %586
  %597 = phi double [ %589, %586 ], [ %595, %590 ]
  %598 = fadd double %517, %597
  %599 = fmul double %597, 1.000000e-03
  %600 = fsub double %585, %599
  %601 = fcmp ule double %598, %600
  %602 = select i1 %601, double %598, double %585
  %603 = fsub double %602, %517
  %604 = fmul double %603, 6.250000e-02
  %605 = fadd double %517, %604
  %606 = fcmp ule double %605, %517
  %607 = fcmp une double %602, %585
  %608 = and i1 %607, %606
  br i1 %608, label %609, label %610

609:                                              ; preds = %596
  store double %603, ptr %215, align 8
  br label %2018

610:                                              ; preds = %596
  %611 = load ptr, ptr %0, align 8
  %612 = load i64, ptr %611, align 8
  %613 = load ptr, ptr %102, align 8
  %614 = insertelement <8 x double> poison, double %603, i64 0
  %615 = shufflevector <8 x double> %614, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %615, ptr %613, align 8
  %616 = icmp sgt i64 %612, 1
  br i1 %616, label %621, label %712

617:                                              ; preds = %700
  %618 = add nuw nsw i64 %624, 1
  %619 = icmp slt i64 %618, %612
  %620 = icmp eq i64 %618, %612
  br i1 %620, label %712, label %621, !llvm.loop !13

621:                                              ; preds = %610, %617
  %622 = phi i1 [ %619, %617 ], [ %616, %610 ]
  %623 = phi i64 [ %711, %617 ], [ undef, %610 ]
  %624 = phi i64 [ %618, %617 ], [ 1, %610 ]
  %625 = load ptr, ptr %103, align 8
  %626 = load ptr, ptr %76, align 8
  %627 = load ptr, ptr %75, align 8
  %628 = getelementptr inbounds i8, ptr %627, i64 16
  %629 = load i64, ptr %628, align 8
  %630 = icmp sgt i64 %629, 1
  %631 = zext i1 %630 to i64
  %632 = load ptr, ptr %104, align 8
  %633 = getelementptr inbounds i64, ptr %632, i64 %624
  %634 = load i64, ptr %633, align 8
  %635 = getelementptr i8, ptr %633, i64 8
  %636 = load i64, ptr %635, align 8
  %637 = xor i64 %634, -1
  %638 = add i64 %636, %637
  %639 = load ptr, ptr %102, align 8
  %640 = load ptr, ptr %105, align 8
  %641 = load ptr, ptr %106, align 8
  %642 = getelementptr inbounds i64, ptr %641, i64 %634
  %643 = load ptr, ptr %107, align 8
  %644 = getelementptr inbounds double, ptr %643, i64 %634
  tail call fastcc void @combine(ptr noundef %625, ptr noundef %626, ptr noundef %639, ptr noundef %640, ptr noundef %642, ptr noundef %644, i64 noundef %638, i64 noundef %631, i64 noundef %629) #10
  %645 = icmp eq i64 %629, 1
  br i1 %645, label %646, label %677

646:                                              ; preds = %621
  %647 = load ptr, ptr %104, align 8
  %648 = getelementptr i64, ptr %647, i64 %624
  %649 = getelementptr i8, ptr %648, i64 8
  %650 = load i64, ptr %649, align 8
  %651 = add nsw i64 %650, -1
  %652 = load ptr, ptr %107, align 8
  %653 = getelementptr inbounds double, ptr %652, i64 %651
  %654 = load double, ptr %653, align 8
  %655 = fmul double %603, %654
  %656 = load ptr, ptr %105, align 8
  %657 = load ptr, ptr %106, align 8
  %658 = getelementptr inbounds i64, ptr %657, i64 %651
  %659 = load i64, ptr %658, align 8
  %660 = getelementptr inbounds double, ptr %656, i64 %659
  %661 = load ptr, ptr %75, align 8
  %662 = getelementptr inbounds i8, ptr %661, i64 8
  %663 = load i64, ptr %662, align 8
  %664 = icmp sgt i64 %663, 0
  br i1 %664, label %665, label %677

665:                                              ; preds = %646, %665
  %666 = phi i64 [ %672, %665 ], [ 0, %646 ]
  %667 = getelementptr inbounds double, ptr %660, i64 %666
  %668 = load double, ptr %667, align 8
  %669 = getelementptr inbounds double, ptr %625, i64 %666
  %670 = load double, ptr %669, align 8
  %671 = tail call double @llvm.fma.f64(double %655, double %668, double %670)
  store double %671, ptr %669, align 8
  %672 = add nuw nsw i64 %666, 1
  %673 = load ptr, ptr %75, align 8
  %674 = getelementptr inbounds i8, ptr %673, i64 8
  %675 = load i64, ptr %674, align 8
  %676 = icmp slt i64 %672, %675
  br i1 %676, label %665, label %677, !llvm.loop !14

677:                                              ; preds = %665, %646, %621
  %678 = load ptr, ptr %105, align 8
  %679 = load i64, ptr %108, align 8
  %680 = mul nsw i64 %679, %624
  %681 = getelementptr inbounds double, ptr %678, i64 %680
  %682 = load i64, ptr %489, align 8
  %683 = add nsw i64 %682, 1
  store i64 %683, ptr %489, align 8
  %684 = load ptr, ptr %109, align 8
  %685 = getelementptr inbounds double, ptr %684, i64 %624
  %686 = load double, ptr %685, align 8
  %687 = fmul double %603, %686
  %688 = fadd double %517, %687
  %689 = load ptr, ptr %103, align 8
  %690 = load ptr, ptr %110, align 8
  store double %688, ptr %690, align 8
  %691 = load ptr, ptr %75, align 8
  %692 = getelementptr inbounds i8, ptr %691, i64 40
  %693 = load i64, ptr %692, align 8
  %694 = icmp eq i64 %693, 0
  br i1 %694, label %696, label %695

695:                                              ; preds = %677
  tail call fastcc void @settle(ptr noundef nonnull %75) #10
  br label %696

696:                                              ; preds = %695, %677
  %697 = load i64, ptr %111, align 8
  %698 = icmp sgt i64 %697, 0
  br i1 %698, label %699, label %700

699:                                              ; preds = %696
  tail call fastcc void @sample(ptr noundef nonnull %75) #10
  br label %700

700:                                              ; preds = %696, %699
  %701 = load ptr, ptr %75, align 8
  %702 = load i64, ptr %701, align 8
  %703 = load ptr, ptr %110, align 8
  %704 = load ptr, ptr %112, align 8
  %705 = load ptr, ptr %113, align 8
  %706 = inttoptr i64 %702 to ptr
  %707 = load ptr, ptr %706, align 8
  %708 = tail call i32 %707(ptr noundef %703, ptr noundef %689, ptr noundef %704, ptr noundef %705, ptr noundef %681) #11
  %709 = sext i32 %708 to i64
  %710 = icmp eq i32 %708, 0
  %711 = select i1 %710, i64 %623, i64 %709
  br i1 %710, label %617, label %712

712:                                              ; preds = %617, %700, %610
  %713 = phi i1 [ %616, %610 ], [ %619, %617 ], [ %622, %700 ]
  %714 = phi i64 [ 0, %610 ], [ %709, %700 ], [ %709, %617 ]
  %715 = phi i64 [ undef, %610 ], [ %711, %700 ], [ %711, %617 ]
  br i1 %713, label %769, label %716

716:                                              ; preds = %712
  %717 = load ptr, ptr %114, align 8
  %718 = load ptr, ptr %76, align 8
  %719 = load ptr, ptr %75, align 8
  %720 = getelementptr inbounds i8, ptr %719, i64 16
  %721 = load i64, ptr %720, align 8
  %722 = icmp sgt i64 %721, 1
  %723 = zext i1 %722 to i64
  %724 = load ptr, ptr %115, align 8
  %725 = getelementptr inbounds i64, ptr %724, i64 %612
  %726 = load i64, ptr %725, align 8
  %727 = getelementptr i8, ptr %725, i64 8
  %728 = load i64, ptr %727, align 8
  %729 = xor i64 %726, -1
  %730 = add i64 %728, %729
  %731 = load ptr, ptr %102, align 8
  %732 = load ptr, ptr %116, align 8
  %733 = load ptr, ptr %117, align 8
  %734 = getelementptr inbounds i64, ptr %733, i64 %726
  %735 = load ptr, ptr %118, align 8
  %736 = getelementptr inbounds double, ptr %735, i64 %726
  tail call fastcc void @combine(ptr noundef %717, ptr noundef %718, ptr noundef %731, ptr noundef %732, ptr noundef %734, ptr noundef %736, i64 noundef %730, i64 noundef %723, i64 noundef %721) #10
  %737 = icmp eq i64 %721, 1
  br i1 %737, label %738, label %769

738:                                              ; preds = %716
  %739 = load ptr, ptr %115, align 8
  %740 = getelementptr i64, ptr %739, i64 %612
  %741 = getelementptr i8, ptr %740, i64 8
  %742 = load i64, ptr %741, align 8
  %743 = add nsw i64 %742, -1
  %744 = load ptr, ptr %118, align 8
  %745 = getelementptr inbounds double, ptr %744, i64 %743
  %746 = load double, ptr %745, align 8
  %747 = fmul double %603, %746
  %748 = load ptr, ptr %116, align 8
  %749 = load ptr, ptr %117, align 8
  %750 = getelementptr inbounds i64, ptr %749, i64 %743
  %751 = load i64, ptr %750, align 8
  %752 = getelementptr inbounds double, ptr %748, i64 %751
  %753 = load ptr, ptr %75, align 8
  %754 = getelementptr inbounds i8, ptr %753, i64 8
  %755 = load i64, ptr %754, align 8
  %756 = icmp sgt i64 %755, 0
  br i1 %756, label %757, label %769

757:                                              ; preds = %738, %757
  %758 = phi i64 [ %764, %757 ], [ 0, %738 ]
  %759 = getelementptr inbounds double, ptr %752, i64 %758
  %760 = load double, ptr %759, align 8
  %761 = getelementptr inbounds double, ptr %717, i64 %758
  %762 = load double, ptr %761, align 8
  %763 = tail call double @llvm.fma.f64(double %747, double %760, double %762)
  store double %763, ptr %761, align 8
  %764 = add nuw nsw i64 %758, 1
  %765 = load ptr, ptr %75, align 8
  %766 = getelementptr inbounds i8, ptr %765, i64 8
  %767 = load i64, ptr %766, align 8
  %768 = icmp slt i64 %764, %767
  br i1 %768, label %757, label %769, !llvm.loop !14

769:                                              ; preds = %757, %738, %716, %712
  %770 = phi i64 [ %715, %712 ], [ %714, %716 ], [ %714, %738 ], [ %714, %757 ]
  %771 = icmp eq i64 %770, 0
  %772 = select i1 %771, i1 %198, i1 false
  br i1 %772, label %773, label %796

773:                                              ; preds = %769
  %774 = load i64, ptr %489, align 8
  %775 = add nsw i64 %774, 1
  store i64 %775, ptr %489, align 8
  %776 = load ptr, ptr %119, align 8
  store double %602, ptr %776, align 8
  %777 = load ptr, ptr %75, align 8
  %778 = getelementptr inbounds i8, ptr %777, i64 40
  %779 = load i64, ptr %778, align 8
  %780 = icmp eq i64 %779, 0
  br i1 %780, label %782, label %781

781:                                              ; preds = %773
  tail call fastcc void @settle(ptr noundef nonnull %75) #10
  br label %782

782:                                              ; preds = %781, %773
  %783 = load i64, ptr %120, align 8
  %784 = icmp sgt i64 %783, 0
  br i1 %784, label %785, label %786

785:                                              ; preds = %782
  tail call fastcc void @sample(ptr noundef nonnull %75) #10
  br label %786

786:                                              ; preds = %782, %785
  %787 = load ptr, ptr %75, align 8
  %788 = load i64, ptr %787, align 8
  %789 = load ptr, ptr %119, align 8
  %790 = load ptr, ptr %121, align 8
  %791 = load ptr, ptr %122, align 8
  %792 = inttoptr i64 %788 to ptr
  %793 = load ptr, ptr %792, align 8
  %794 = tail call i32 %793(ptr noundef %789, ptr noundef %180, ptr noundef %790, ptr noundef %791, ptr noundef %213) #11
  %795 = sext i32 %794 to i64
  br label %796

796:                                              ; preds = %786, %769
  %797 = phi i64 [ %795, %786 ], [ %770, %769 ]
  %798 = icmp slt i64 %797, 0
  br i1 %798, label %2018, label %799

799:                                              ; preds = %796
  %800 = icmp eq i64 %797, 0
  br i1 %800, label %801, label %1143

801:                                              ; preds = %799
  br i1 %195, label %802, label %803

802:                                              ; preds = %801
  br i1 %490, label %1092, label %1101

803:                                              ; preds = %801
  %804 = load ptr, ptr %75, align 8
  %805 = load ptr, ptr %0, align 8
  %806 = getelementptr inbounds i8, ptr %804, i64 24
  %807 = load i64, ptr %806, align 8
  %808 = getelementptr inbounds i8, ptr %805, i64 8
  %809 = load i64, ptr %808, align 8
  %810 = load ptr, ptr %123, align 8
  %811 = load i64, ptr %124, align 8
  %812 = getelementptr inbounds double, ptr %810, i64 %811
  %813 = icmp sgt i64 %809, 0
  br i1 %813, label %814, label %816

814:                                              ; preds = %803
  %815 = getelementptr inbounds i8, ptr %804, i64 32
  br label %824

816:                                              ; preds = %824, %803
  %817 = icmp sgt i64 %807, 0
  br i1 %817, label %818, label %881

818:                                              ; preds = %816
  %819 = load ptr, ptr %76, align 8
  %820 = load ptr, ptr %130, align 8
  %821 = load ptr, ptr %131, align 8
  %822 = load ptr, ptr %132, align 8
  %823 = load ptr, ptr %123, align 8
  br label %850

824:                                              ; preds = %814, %824
  %825 = phi i64 [ 0, %814 ], [ %848, %824 ]
  %826 = load i64, ptr %805, align 8
  %827 = load i64, ptr %815, align 8
  %828 = load ptr, ptr %123, align 8
  %829 = load i64, ptr %124, align 8
  %830 = mul nsw i64 %829, %825
  %831 = getelementptr inbounds double, ptr %828, i64 %830
  %832 = load ptr, ptr %125, align 8
  %833 = load ptr, ptr %126, align 8
  %834 = getelementptr i64, ptr %833, i64 %826
  %835 = getelementptr i8, ptr %834, i64 8
  %836 = getelementptr i64, ptr %835, i64 %825
  %837 = load i64, ptr %836, align 8
  %838 = getelementptr i8, ptr %836, i64 8
  %839 = load i64, ptr %838, align 8
  %840 = xor i64 %837, -1
  %841 = add i64 %839, %840
  %842 = load ptr, ptr %102, align 8
  %843 = load ptr, ptr %127, align 8
  %844 = load ptr, ptr %128, align 8
  %845 = getelementptr inbounds i64, ptr %844, i64 %837
  %846 = load ptr, ptr %129, align 8
  %847 = getelementptr inbounds double, ptr %846, i64 %837
  tail call fastcc void @combine(ptr noundef %831, ptr noundef %832, ptr noundef %842, ptr noundef %843, ptr noundef %845, ptr noundef %847, i64 noundef %841, i64 noundef 1, i64 noundef %827) #10
  %848 = add nuw nsw i64 %825, 1
  %849 = icmp eq i64 %848, %809
  br i1 %849, label %816, label %824, !llvm.loop !15

850:                                              ; preds = %818, %850
  %851 = phi double [ 0.000000e+00, %818 ], [ %876, %850 ]
  %852 = phi double [ 0.000000e+00, %818 ], [ %878, %850 ]
  %853 = phi i64 [ 0, %818 ], [ %879, %850 ]
  %854 = getelementptr inbounds double, ptr %819, i64 %853
  %855 = load double, ptr %854, align 8
  %856 = getelementptr inbounds double, ptr %820, i64 %853
  %857 = load double, ptr %856, align 8
  %858 = getelementptr inbounds double, ptr %821, i64 %853
  %859 = load double, ptr %858, align 8
  %860 = getelementptr inbounds double, ptr %822, i64 %853
  %861 = load double, ptr %860, align 8
  %862 = tail call double @llvm.fabs.f64(double %855)
  %863 = tail call double @llvm.fabs.f64(double %857)
  %864 = fcmp ogt double %862, %863
  %865 = select i1 %864, double %862, double %863
  %866 = fmul double %865, %861
  %867 = fadd double %859, %866
  %868 = fdiv double 1.000000e+00, %867
  %869 = getelementptr inbounds double, ptr %823, i64 %853
  %870 = load double, ptr %869, align 8
  %871 = fmul double %870, %868
  %872 = getelementptr inbounds double, ptr %812, i64 %853
  %873 = load double, ptr %872, align 8
  %874 = fmul double %873, %868
  %875 = fmul double %871, %871
  %876 = fadd double %851, %875
  %877 = fmul double %874, %874
  %878 = fadd double %852, %877
  %879 = add nuw nsw i64 %853, 1
  %880 = icmp eq i64 %879, %807
  br i1 %880, label %881, label %850, !llvm.loop !16

881:                                              ; preds = %850, %816
  %882 = phi double [ 0.000000e+00, %816 ], [ %878, %850 ]
  %883 = phi double [ 0.000000e+00, %816 ], [ %876, %850 ]
  %884 = load ptr, ptr %133, align 8
  %885 = getelementptr inbounds i8, ptr %804, i64 8
  %886 = load i64, ptr %885, align 8
  %887 = add nsw i64 %886, -3
  %888 = getelementptr i8, ptr %884, i64 8
  %889 = getelementptr i8, ptr %884, i64 16
  %890 = getelementptr i8, ptr %884, i64 24
  %891 = icmp slt i64 %807, %887
  br i1 %891, label %899, label %892

892:                                              ; preds = %899, %881
  %893 = phi double [ 0.000000e+00, %881 ], [ %908, %899 ]
  %894 = phi double [ 0.000000e+00, %881 ], [ %912, %899 ]
  %895 = phi double [ 0.000000e+00, %881 ], [ %916, %899 ]
  %896 = phi double [ 0.000000e+00, %881 ], [ %920, %899 ]
  %897 = phi i64 [ %807, %881 ], [ %921, %899 ]
  %898 = icmp slt i64 %897, %886
  br i1 %898, label %923, label %932

899:                                              ; preds = %881, %899
  %900 = phi i64 [ %921, %899 ], [ %807, %881 ]
  %901 = phi double [ %920, %899 ], [ 0.000000e+00, %881 ]
  %902 = phi double [ %916, %899 ], [ 0.000000e+00, %881 ]
  %903 = phi double [ %912, %899 ], [ 0.000000e+00, %881 ]
  %904 = phi double [ %908, %899 ], [ 0.000000e+00, %881 ]
  %905 = getelementptr inbounds double, ptr %884, i64 %900
  %906 = load double, ptr %905, align 8
  %907 = fmul double %906, 0.000000e+00
  %908 = fadd double %904, %907
  %909 = getelementptr double, ptr %888, i64 %900
  %910 = load double, ptr %909, align 8
  %911 = fmul double %910, 0.000000e+00
  %912 = fadd double %903, %911
  %913 = getelementptr double, ptr %889, i64 %900
  %914 = load double, ptr %913, align 8
  %915 = fmul double %914, 0.000000e+00
  %916 = fadd double %902, %915
  %917 = getelementptr double, ptr %890, i64 %900
  %918 = load double, ptr %917, align 8
  %919 = fmul double %918, 0.000000e+00
  %920 = fadd double %901, %919
  %921 = add nsw i64 %900, 4
  %922 = icmp slt i64 %921, %887
  br i1 %922, label %899, label %892, !llvm.loop !17

923:                                              ; preds = %892, %923
  %924 = phi i64 [ %930, %923 ], [ %897, %892 ]
  %925 = phi double [ %929, %923 ], [ %893, %892 ]
  %926 = getelementptr inbounds double, ptr %884, i64 %924
  %927 = load double, ptr %926, align 8
  %928 = fmul double %927, 0.000000e+00
  %929 = fadd double %925, %928
  %930 = add nsw i64 %924, 1
  %931 = icmp eq i64 %930, %886
  br i1 %931, label %932, label %923, !llvm.loop !18

932:                                              ; preds = %923, %892
  %933 = phi double [ %893, %892 ], [ %929, %923 ]
  %934 = fadd double %894, %933
  %935 = fadd double %895, %896
  %936 = fadd double %935, %934
  %937 = fadd double %883, %936
  %938 = icmp eq i64 %809, 2
  br i1 %938, label %939, label %948

939:                                              ; preds = %932
  %940 = fmul double %882, 1.000000e-02
  %941 = fadd double %940, %937
  %942 = sitofp i64 %807 to double
  %943 = fmul double %941, %942
  %944 = tail call double @llvm.sqrt.f64(double %943)
  %945 = fdiv double %937, %944
  %946 = fcmp une double %937, 0.000000e+00
  %947 = select i1 %946, double %945, double 0.000000e+00
  br label %952

948:                                              ; preds = %932
  %949 = sitofp i64 %807 to double
  %950 = fdiv double %937, %949
  %951 = tail call double @llvm.sqrt.f64(double %950)
  br label %952

952:                                              ; preds = %939, %948
  %953 = phi double [ %947, %939 ], [ %951, %948 ]
  %954 = load ptr, ptr %123, align 8
  %955 = load ptr, ptr %102, align 8
  %956 = load double, ptr %955, align 8
  %957 = load i64, ptr %806, align 8
  %958 = getelementptr inbounds i8, ptr %804, i64 48
  %959 = load i64, ptr %958, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %4, i8 0, i64 64, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %5, i8 0, i64 64, i1 false)
  %960 = icmp eq i64 %959, 0
  br i1 %960, label %1090, label %961

961:                                              ; preds = %952
  br i1 %938, label %962, label %964

962:                                              ; preds = %961
  %963 = load i64, ptr %124, align 8
  br label %964

964:                                              ; preds = %962, %961
  %965 = phi i64 [ %963, %962 ], [ 0, %961 ]
  %966 = getelementptr inbounds double, ptr %954, i64 %965
  %967 = add nsw i64 %957, 7
  %968 = sdiv i64 %967, 8
  %969 = shl nsw i64 %968, 3
  %970 = tail call i64 @llvm.smin.i64(i64 %969, i64 %959)
  %971 = icmp slt i64 %957, %970
  br i1 %971, label %972, label %1010

972:                                              ; preds = %964
  %973 = load ptr, ptr %76, align 8
  %974 = load ptr, ptr %134, align 8
  %975 = load ptr, ptr %135, align 8
  br label %976

976:                                              ; preds = %972, %976
  %977 = phi i64 [ %957, %972 ], [ %1008, %976 ]
  %978 = getelementptr inbounds double, ptr %973, i64 %977
  %979 = load double, ptr %978, align 8
  %980 = tail call double @llvm.fabs.f64(double %979)
  %981 = getelementptr inbounds double, ptr %884, i64 %977
  %982 = load double, ptr %981, align 8
  %983 = tail call double @llvm.fabs.f64(double %982)
  %984 = fcmp ogt double %980, %983
  %985 = select i1 %984, double %980, double %983
  %986 = getelementptr inbounds double, ptr %974, i64 %977
  %987 = load double, ptr %986, align 8
  %988 = getelementptr inbounds double, ptr %975, i64 %977
  %989 = load double, ptr %988, align 8
  %990 = fmul double %985, %989
  %991 = fadd double %987, %990
  %992 = fdiv double 1.000000e+00, %991
  %993 = getelementptr inbounds double, ptr %954, i64 %977
  %994 = load double, ptr %993, align 8
  %995 = fmul double %994, %992
  %996 = getelementptr inbounds double, ptr %966, i64 %977
  %997 = load double, ptr %996, align 8
  %998 = fmul double %997, %992
  %999 = srem i64 %977, 8
  %1000 = getelementptr inbounds double, ptr %4, i64 %999
  %1001 = load double, ptr %1000, align 8
  %1002 = fmul double %995, %995
  %1003 = fadd double %1001, %1002
  store double %1003, ptr %1000, align 8
  %1004 = getelementptr inbounds double, ptr %5, i64 %999
  %1005 = load double, ptr %1004, align 8
  %1006 = fmul double %998, %998
  %1007 = fadd double %1005, %1006
  store double %1007, ptr %1004, align 8
  %1008 = add nsw i64 %977, 1
  %1009 = icmp eq i64 %1008, %970
  br i1 %1009, label %1010, label %976, !llvm.loop !19

1010:                                             ; preds = %976, %964
  %1011 = phi i64 [ %957, %964 ], [ %1008, %976 ]
  %1012 = load <8 x double>, ptr %4, align 16
  %1013 = load <8 x double>, ptr %5, align 16
  %1014 = icmp slt i64 %1011, %959
  br i1 %1014, label %1015, label %1054

1015:                                             ; preds = %1010
  %1016 = load ptr, ptr %76, align 8
  %1017 = load ptr, ptr %136, align 8
  %1018 = load ptr, ptr %137, align 8
  br label %1019

1019:                                             ; preds = %1015, %1019
  %1020 = phi i64 [ %1011, %1015 ], [ %1052, %1019 ]
  %1021 = phi <8 x double> [ %1012, %1015 ], [ %1049, %1019 ]
  %1022 = phi <8 x double> [ %1013, %1015 ], [ %1051, %1019 ]
  %1023 = getelementptr inbounds double, ptr %1016, i64 %1020
  %1024 = load <8 x double>, ptr %1023, align 8
  %1025 = fneg <8 x double> %1024
  %1026 = fcmp ogt <8 x double> %1024, zeroinitializer
  %1027 = select <8 x i1> %1026, <8 x double> %1024, <8 x double> %1025
  %1028 = getelementptr inbounds double, ptr %884, i64 %1020
  %1029 = load <8 x double>, ptr %1028, align 8
  %1030 = fneg <8 x double> %1029
  %1031 = fcmp ogt <8 x double> %1029, zeroinitializer
  %1032 = select <8 x i1> %1031, <8 x double> %1029, <8 x double> %1030
  %1033 = fcmp ogt <8 x double> %1027, %1032
  %1034 = select <8 x i1> %1033, <8 x double> %1027, <8 x double> %1032
  %1035 = getelementptr inbounds double, ptr %1017, i64 %1020
  %1036 = load <8 x double>, ptr %1035, align 8
  %1037 = getelementptr inbounds double, ptr %1018, i64 %1020
  %1038 = load <8 x double>, ptr %1037, align 8
  %1039 = fmul <8 x double> %1038, %1034
  %1040 = fadd <8 x double> %1036, %1039
  %1041 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1040
  %1042 = getelementptr inbounds double, ptr %954, i64 %1020
  %1043 = load <8 x double>, ptr %1042, align 8
  %1044 = fmul <8 x double> %1043, %1041
  %1045 = getelementptr inbounds double, ptr %966, i64 %1020
  %1046 = load <8 x double>, ptr %1045, align 8
  %1047 = fmul <8 x double> %1046, %1041
  %1048 = fmul <8 x double> %1044, %1044
  %1049 = fadd <8 x double> %1021, %1048
  %1050 = fmul <8 x double> %1047, %1047
  %1051 = fadd <8 x double> %1022, %1050
  %1052 = add nsw i64 %1020, 8
  %1053 = icmp slt i64 %1052, %959
  br i1 %1053, label %1019, label %1054, !llvm.loop !20

1054:                                             ; preds = %1019, %1010
  %1055 = phi <8 x double> [ %1013, %1010 ], [ %1051, %1019 ]
  %1056 = phi <8 x double> [ %1012, %1010 ], [ %1049, %1019 ]
  store <8 x double> %1056, ptr %4, align 16
  store <8 x double> %1055, ptr %5, align 16
  br label %1078

1057:                                             ; preds = %1078
  %1058 = sub nsw i64 %959, %957
  br i1 %938, label %1059, label %1068

1059:                                             ; preds = %1057
  %1060 = fmul double %1087, 1.000000e-02
  %1061 = fadd double %1084, %1060
  %1062 = sitofp i64 %1058 to double
  %1063 = fmul double %1061, %1062
  %1064 = tail call double @llvm.sqrt.f64(double %1063)
  %1065 = fdiv double %1084, %1064
  %1066 = fcmp une double %1084, 0.000000e+00
  %1067 = select i1 %1066, double %1065, double 0.000000e+00
  br label %1072

1068:                                             ; preds = %1057
  %1069 = sitofp i64 %1058 to double
  %1070 = fdiv double %1084, %1069
  %1071 = tail call double @llvm.sqrt.f64(double %1070)
  br label %1072

1072:                                             ; preds = %1068, %1059
  %1073 = phi double [ %1067, %1059 ], [ %1071, %1068 ]
  %1074 = fcmp ule double %956, %209
  %1075 = fcmp ogt double %1073, %953
  %1076 = select i1 %1075, double %1073, double %953
  %1077 = select i1 %1074, double %953, double %1076
  br label %1090

1078:                                             ; preds = %1054, %1078
  %1079 = phi i64 [ 0, %1054 ], [ %1088, %1078 ]
  %1080 = phi double [ 0.000000e+00, %1054 ], [ %1087, %1078 ]
  %1081 = phi double [ 0.000000e+00, %1054 ], [ %1084, %1078 ]
  %1082 = getelementptr inbounds double, ptr %4, i64 %1079
  %1083 = load double, ptr %1082, align 8
  %1084 = fadd double %1081, %1083
  %1085 = getelementptr inbounds double, ptr %5, i64 %1079
  %1086 = load double, ptr %1085, align 8
  %1087 = fadd double %1080, %1086
  %1088 = add nuw nsw i64 %1079, 1
  %1089 = icmp eq i64 %1088, 8
  br i1 %1089, label %1057, label %1078, !llvm.loop !21

1090:                                             ; preds = %952, %1072
  %1091 = phi double [ %1077, %1072 ], [ %953, %952 ]
  br label %1101

1092:                                             ; preds = %802, %1092
  %1093 = phi i64 [ %1099, %1092 ], [ 0, %802 ]
  %1094 = phi double [ %1098, %1092 ], [ 0.000000e+00, %802 ]
  %1095 = getelementptr inbounds double, ptr %180, i64 %1093
  %1096 = load double, ptr %1095, align 8
  %1097 = fmul double %1096, 0.000000e+00
  %1098 = fadd double %1094, %1097
  %1099 = add nuw nsw i64 %1093, 1
  %1100 = icmp eq i64 %1099, %189
  br i1 %1100, label %1101, label %1092, !llvm.loop !22

1101:                                             ; preds = %1092, %802, %1090
  %1102 = phi double [ %1091, %1090 ], [ 0.000000e+00, %802 ], [ %1098, %1092 ]
  %1103 = fcmp uge double %1102, 1.000000e+00
  %1104 = select i1 %1103, i1 true, i1 %491
  br i1 %1104, label %1143, label %1105

1105:                                             ; preds = %1101
  br i1 %192, label %1117, label %1106

1106:                                             ; preds = %1105
  br i1 %195, label %1109, label %1107

1107:                                             ; preds = %1106
  %1108 = load ptr, ptr %76, align 8
  br label %1109

1109:                                             ; preds = %1107, %1106
  %1110 = phi ptr [ %1108, %1107 ], [ null, %1106 ]
  %1111 = load ptr, ptr %83, align 8
  %1112 = getelementptr inbounds i8, ptr %1111, i64 56
  %1113 = load i64, ptr %1112, align 8
  %1114 = inttoptr i64 %1113 to ptr
  %1115 = tail call i64 %1114(ptr noundef %0, double noundef %602, ptr noundef %180, ptr noundef %1110) #11
  %1116 = icmp ne i64 %1115, 0
  br label %1117

1117:                                             ; preds = %1109, %1105
  %1118 = phi i1 [ false, %1105 ], [ %1116, %1109 ]
  br i1 %1118, label %1143, label %1119

1119:                                             ; preds = %1117
  %1120 = load i64, ptr %489, align 8
  %1121 = add nsw i64 %1120, 1
  store i64 %1121, ptr %489, align 8
  %1122 = load ptr, ptr %138, align 8
  store double %602, ptr %1122, align 8
  %1123 = load ptr, ptr %75, align 8
  %1124 = getelementptr inbounds i8, ptr %1123, i64 40
  %1125 = load i64, ptr %1124, align 8
  %1126 = icmp eq i64 %1125, 0
  br i1 %1126, label %1128, label %1127

1127:                                             ; preds = %1119
  tail call fastcc void @settle(ptr noundef nonnull %75) #10
  br label %1128

1128:                                             ; preds = %1127, %1119
  %1129 = load i64, ptr %139, align 8
  %1130 = icmp sgt i64 %1129, 0
  br i1 %1130, label %1131, label %1132

1131:                                             ; preds = %1128
  tail call fastcc void @sample(ptr noundef nonnull %75) #10
  br label %1132

1132:                                             ; preds = %1128, %1131
  %1133 = load ptr, ptr %75, align 8
  %1134 = load i64, ptr %1133, align 8
  %1135 = load ptr, ptr %138, align 8
  %1136 = load ptr, ptr %140, align 8
  %1137 = load ptr, ptr %141, align 8
  %1138 = inttoptr i64 %1134 to ptr
  %1139 = load ptr, ptr %1138, align 8
  %1140 = tail call i32 %1139(ptr noundef %1135, ptr noundef %180, ptr noundef %1136, ptr noundef %1137, ptr noundef %213) #11
  %1141 = sext i32 %1140 to i64
  %1142 = icmp slt i32 %1140, 0
  br i1 %1142, label %2018, label %1143

1143:                                             ; preds = %1132, %1117, %1101, %799
  %1144 = phi i64 [ 0, %1117 ], [ %1141, %1132 ], [ 0, %1101 ], [ %797, %799 ]
  %1145 = phi double [ %1102, %1117 ], [ %1102, %1132 ], [ %1102, %1101 ], [ 0.000000e+00, %799 ]
  %1146 = phi i1 [ %1118, %1117 ], [ %1118, %1132 ], [ false, %1101 ], [ false, %799 ]
  %1147 = icmp ne i64 %1144, 0
  %1148 = fcmp uge double %1145, 1.000000e+00
  %1149 = or i1 %1147, %1148
  %1150 = or i1 %1146, %1149
  br i1 %1150, label %1151, label %1233

1151:                                             ; preds = %1143
  %1152 = load i64, ptr %485, align 8
  %1153 = add nsw i64 %1152, 1
  store i64 %1153, ptr %485, align 8
  %1154 = or i1 %1147, %1146
  br i1 %1154, label %1158, label %1155

1155:                                             ; preds = %1151
  %1156 = tail call double @llvm.fabs.f64(double %1145)
  %1157 = fcmp one double %1156, 0x7FF0000000000000
  br label %1158

1158:                                             ; preds = %1155, %1151
  %1159 = phi i1 [ false, %1151 ], [ %1157, %1155 ]
  %1160 = select i1 %1159, i64 2, i64 4
  %1161 = select i1 %1146, i64 6, i64 %1160
  %1162 = select i1 %1147, i64 3, i64 %1161
  store i64 %1162, ptr %508, align 8
  %1163 = fcmp ogt double %1145, 1.000000e-10
  %1164 = select i1 %1163, double %1145, double 1.000000e-10
  %1165 = load double, ptr %509, align 8
  %1166 = load double, ptr %187, align 8
  %1167 = fneg double %1166
  %1168 = bitcast double %1164 to i64
  %1169 = add nsw i64 %1168, -4604544271217802189
  %1170 = ashr i64 %1169, 52
  %1171 = and i64 %1169, -4503599627370496
  %1172 = sub nsw i64 %1168, %1171
  %1173 = bitcast i64 %1172 to double
  %1174 = fadd double %1173, -1.000000e+00
  %1175 = fadd double %1173, 1.000000e+00
  %1176 = fdiv double %1174, %1175
  %1177 = fmul double %1176, %1176
  %1178 = tail call double @llvm.fma.f64(double %1177, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1179 = tail call double @llvm.fma.f64(double %1178, double %1177, double 0x3FE2776C50EF9BFE)
  %1180 = tail call double @llvm.fma.f64(double %1179, double %1177, double 0x3FEEC709DC3A03FD)
  %1181 = tail call double @llvm.fma.f64(double %1180, double %1177, double 0x40071547652B82FE)
  %1182 = trunc nsw i64 %1170 to i32
  %1183 = sitofp i32 %1182 to double
  %1184 = fmul double %1176, %1181
  %1185 = fadd double %1184, %1183
  %1186 = fmul double %1185, %1167
  %1187 = fcmp ogt double %1186, -1.000000e+03
  %1188 = select i1 %1187, double %1186, double -1.000000e+03
  %1189 = fcmp olt double %1188, 1.000000e+03
  %1190 = select i1 %1189, double %1188, double 1.000000e+03
  %1191 = tail call double @llvm.rint.f64(double %1190)
  %1192 = fsub double %1190, %1191
  %1193 = tail call double @llvm.fma.f64(double %1192, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1194 = tail call double @llvm.fma.f64(double %1193, double %1192, double 0x3F55D87FE78A6730)
  %1195 = tail call double @llvm.fma.f64(double %1194, double %1192, double 0x3F83B2AB6FBA4E77)
  %1196 = tail call double @llvm.fma.f64(double %1195, double %1192, double 0x3FAC6B08D704A0BF)
  %1197 = tail call double @llvm.fma.f64(double %1196, double %1192, double 0x3FCEBFBDFF82C58E)
  %1198 = tail call double @llvm.fma.f64(double %1197, double %1192, double 0x3FE62E42FEFA39EF)
  %1199 = tail call double @llvm.fma.f64(double %1198, double %1192, double 1.000000e+00)
  %1200 = bitcast double %1199 to i64
  %1201 = fptosi double %1191 to i32
  %1202 = sext i32 %1201 to i64
  %1203 = shl nsw i64 %1202, 52
  %1204 = add nsw i64 %1203, %1200
  %1205 = bitcast i64 %1204 to double
  %1206 = fmul double %1165, %1205
  %1207 = load double, ptr %510, align 8
  %1208 = fcmp ogt double %1206, %1207
  %1209 = select i1 %1208, double %1206, double %1207
  %1210 = select i1 %1159, double %1209, double 2.500000e-01
  %1211 = fmul double %603, %1210
  br i1 %1159, label %1212, label %1229

1212:                                             ; preds = %1158
  %1213 = load i64, ptr %176, align 8
  %1214 = icmp eq i64 %1213, 0
  br i1 %1214, label %1229, label %1215

1215:                                             ; preds = %1212
  %1216 = tail call fastcc double @knot_after(ptr noundef nonnull %75, double noundef %517) #10
  %1217 = fmul double %603, 1.000000e-03
  %1218 = fsub double %602, %1217
  %1219 = tail call double @llvm.fabs.f64(double %602)
  %1220 = fmul double %1219, 0x3D10000000000000
  %1221 = fsub double %1218, %1220
  %1222 = fcmp ogt double %1221, %1216
  br i1 %1222, label %1223, label %1229

1223:                                             ; preds = %1215
  %1224 = tail call fastcc double @knot_after(ptr noundef nonnull %75, double noundef %1216) #10
  %1225 = fadd double %517, %1211
  %1226 = fcmp ugt double %1224, %1225
  br i1 %1226, label %1227, label %1229

1227:                                             ; preds = %1223
  %1228 = fsub double %1216, %517
  br label %1229

1229:                                             ; preds = %1227, %1223, %1215, %1212, %1158
  %1230 = phi double [ %1211, %1158 ], [ %1211, %1212 ], [ %1228, %1227 ], [ %1211, %1223 ], [ %1211, %1215 ]
  br i1 %195, label %1231, label %1232

1231:                                             ; preds = %1229
  store double %603, ptr %215, align 8
  br label %2018

1232:                                             ; preds = %1229
  store double 1.000000e+00, ptr %511, align 8
  br label %2018, !llvm.loop !23

1233:                                             ; preds = %1143
  %1234 = load i64, ptr %484, align 8
  %1235 = add nsw i64 %1234, 1
  store i64 %1235, ptr %484, align 8
  store double %602, ptr %179, align 8
  store double %603, ptr %492, align 8
  %1236 = load ptr, ptr %98, align 8
  %1237 = getelementptr inbounds i8, ptr %1236, i64 8
  %1238 = load i64, ptr %1237, align 8
  %1239 = icmp eq i64 %1238, 0
  br i1 %1239, label %1269, label %1240

1240:                                             ; preds = %1233
  %1241 = load i64, ptr %1236, align 8
  %1242 = load ptr, ptr %75, align 8
  %1243 = getelementptr inbounds i8, ptr %1242, i64 8
  %1244 = load i64, ptr %1243, align 8
  %1245 = load ptr, ptr %142, align 8
  %1246 = load i64, ptr %143, align 8
  %1247 = mul nsw i64 %1246, %1241
  %1248 = getelementptr inbounds double, ptr %1245, i64 %1247
  %1249 = getelementptr inbounds double, ptr %1248, i64 %1246
  store double %517, ptr %1248, align 8
  %1250 = getelementptr inbounds i8, ptr %1248, i64 8
  store double %603, ptr %1250, align 8
  store double %602, ptr %1249, align 8
  %1251 = getelementptr inbounds i8, ptr %1249, i64 8
  store double 0.000000e+00, ptr %1251, align 8
  %1252 = icmp sgt i64 %1244, 0
  br i1 %1252, label %1256, label %1253

1253:                                             ; preds = %1256, %1240
  %1254 = add nsw i64 %1241, 1
  %1255 = load ptr, ptr %98, align 8
  store i64 %1254, ptr %1255, align 8
  br label %1269

1256:                                             ; preds = %1240, %1256
  %1257 = phi i64 [ %1267, %1256 ], [ 0, %1240 ]
  %1258 = load ptr, ptr %76, align 8
  %1259 = getelementptr inbounds double, ptr %1258, i64 %1257
  %1260 = load double, ptr %1259, align 8
  %1261 = add nuw nsw i64 %1257, 2
  %1262 = getelementptr inbounds double, ptr %1248, i64 %1261
  store double %1260, ptr %1262, align 8
  %1263 = load ptr, ptr %78, align 8
  %1264 = getelementptr inbounds double, ptr %1263, i64 %1257
  %1265 = load double, ptr %1264, align 8
  %1266 = getelementptr inbounds double, ptr %1249, i64 %1261
  store double %1265, ptr %1266, align 8
  %1267 = add nuw nsw i64 %1257, 1
  %1268 = icmp eq i64 %1267, %1244
  br i1 %1268, label %1253, label %1256, !llvm.loop !24

1269:                                             ; preds = %1233, %1253
  br i1 %202, label %1270, label %1380

1270:                                             ; preds = %1269
  %1271 = load ptr, ptr %84, align 8
  %1272 = load i64, ptr %82, align 8
  %1273 = load ptr, ptr %144, align 8
  %1274 = getelementptr inbounds i8, ptr %1271, i64 32
  %1275 = load i64, ptr %1274, align 8
  %1276 = getelementptr inbounds double, ptr %1273, i64 %1275
  %1277 = getelementptr inbounds i8, ptr %1271, i64 24
  %1278 = load i64, ptr %1277, align 8
  %1279 = icmp eq i64 %1278, 0
  br i1 %1279, label %1377, label %1280

1280:                                             ; preds = %1270
  %1281 = getelementptr inbounds i8, ptr %1271, i64 40
  %1282 = load i64, ptr %1281, align 8
  %1283 = icmp sgt i64 %1282, 0
  br i1 %1283, label %1338, label %1284

1284:                                             ; preds = %1356, %1280
  %1285 = load ptr, ptr %145, align 8
  %1286 = load ptr, ptr %84, align 8
  %1287 = getelementptr inbounds i8, ptr %1286, i64 8
  %1288 = load i64, ptr %1287, align 8
  %1289 = load ptr, ptr %146, align 8
  %1290 = load ptr, ptr %144, align 8
  %1291 = getelementptr inbounds i8, ptr %1286, i64 32
  %1292 = load i64, ptr %1291, align 8
  %1293 = getelementptr inbounds i8, ptr %1286, i64 40
  %1294 = load i64, ptr %1293, align 8
  %1295 = getelementptr double, ptr %1290, i64 %1292
  %1296 = getelementptr double, ptr %1295, i64 %1294
  store double %603, ptr %1296, align 8
  %1297 = load ptr, ptr %145, align 8
  store double %517, ptr %1297, align 8
  %1298 = load ptr, ptr %84, align 8
  %1299 = getelementptr inbounds i8, ptr %1298, i64 24
  %1300 = load i64, ptr %1299, align 8
  %1301 = load ptr, ptr %76, align 8
  %1302 = load ptr, ptr %144, align 8
  %1303 = load ptr, ptr %147, align 8
  %1304 = inttoptr i64 %1300 to ptr
  %1305 = load ptr, ptr %1304, align 8
  %1306 = tail call i32 %1305(ptr noundef %1285, ptr noundef %1301, ptr noundef %1302, ptr noundef %1303, ptr noundef %1289) #11
  %1307 = icmp eq i32 %1306, 0
  br i1 %1307, label %1308, label %1377

1308:                                             ; preds = %1284
  %1309 = icmp slt i64 %1288, 1
  br i1 %1309, label %1335, label %1310

1310:                                             ; preds = %1308
  %1311 = load ptr, ptr %148, align 8
  %1312 = getelementptr double, ptr %1289, i64 %1288
  br label %1313

1313:                                             ; preds = %1310, %1331
  %1314 = phi i1 [ %1309, %1310 ], [ %1333, %1331 ]
  %1315 = phi i64 [ 0, %1310 ], [ %1332, %1331 ]
  %1316 = getelementptr inbounds i64, ptr %1311, i64 %1315
  %1317 = load i64, ptr %1316, align 8
  %1318 = and i64 %1317, 2
  %1319 = icmp eq i64 %1318, 0
  br i1 %1319, label %1320, label %1331

1320:                                             ; preds = %1313
  %1321 = getelementptr inbounds double, ptr %1289, i64 %1315
  %1322 = load double, ptr %1321, align 8
  %1323 = load ptr, ptr %149, align 8
  %1324 = getelementptr inbounds i64, ptr %1323, i64 %1315
  %1325 = load i64, ptr %1324, align 8
  %1326 = sitofp i64 %1325 to double
  %1327 = fmul double %1322, %1326
  %1328 = getelementptr double, ptr %1312, i64 %1315
  %1329 = load double, ptr %1328, align 8
  %1330 = fcmp ogt double %1327, %1329
  br i1 %1330, label %1331, label %1335

1331:                                             ; preds = %1320, %1313
  %1332 = add nuw nsw i64 %1315, 1
  %1333 = icmp sge i64 %1332, %1288
  %1334 = icmp eq i64 %1332, %1288
  br i1 %1334, label %1335, label %1313, !llvm.loop !25

1335:                                             ; preds = %1331, %1320, %1308
  %1336 = phi i1 [ %1309, %1308 ], [ %1333, %1331 ], [ %1314, %1320 ]
  %1337 = zext i1 %1336 to i32
  br label %1377

1338:                                             ; preds = %1280, %1356
  %1339 = phi i64 [ %1360, %1356 ], [ 0, %1280 ]
  %1340 = load ptr, ptr %78, align 8
  %1341 = getelementptr inbounds double, ptr %1340, i64 %1339
  %1342 = load <8 x double>, ptr %1341, align 8
  %1343 = load ptr, ptr %76, align 8
  %1344 = getelementptr inbounds double, ptr %1343, i64 %1339
  %1345 = load <8 x double>, ptr %1344, align 8
  %1346 = fsub <8 x double> %1342, %1345
  %1347 = fneg <8 x double> %1346
  %1348 = fcmp ogt <8 x double> %1346, zeroinitializer
  %1349 = select <8 x i1> %1348, <8 x double> %1346, <8 x double> %1347
  %1350 = load ptr, ptr %0, align 8
  %1351 = load i64, ptr %1350, align 8
  %1352 = icmp slt i64 %1351, 0
  br i1 %1352, label %1356, label %1353

1353:                                             ; preds = %1338
  %1354 = load ptr, ptr %86, align 8
  %1355 = getelementptr double, ptr %1354, i64 %1339
  br label %1363

1356:                                             ; preds = %1363, %1338
  %1357 = phi <8 x double> [ %1349, %1338 ], [ %1374, %1363 ]
  %1358 = getelementptr inbounds double, ptr %1276, i64 %1339
  %1359 = fmul <8 x double> %1357, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  store <8 x double> %1359, ptr %1358, align 8
  %1360 = add nuw nsw i64 %1339, 8
  %1361 = load i64, ptr %1281, align 8
  %1362 = icmp slt i64 %1360, %1361
  br i1 %1362, label %1338, label %1284, !llvm.loop !26

1363:                                             ; preds = %1353, %1363
  %1364 = phi i64 [ 0, %1353 ], [ %1375, %1363 ]
  %1365 = phi <8 x double> [ %1349, %1353 ], [ %1374, %1363 ]
  %1366 = mul nsw i64 %1364, %1272
  %1367 = getelementptr double, ptr %1355, i64 %1366
  %1368 = load <8 x double>, ptr %1367, align 8
  %1369 = fneg <8 x double> %1368
  %1370 = fcmp ogt <8 x double> %1368, zeroinitializer
  %1371 = select <8 x i1> %1370, <8 x double> %1368, <8 x double> %1369
  %1372 = fmul <8 x double> %615, %1371
  %1373 = fcmp ogt <8 x double> %1365, %1372
  %1374 = select <8 x i1> %1373, <8 x double> %1365, <8 x double> %1372
  %1375 = add nuw i64 %1364, 1
  %1376 = icmp eq i64 %1364, %1351
  br i1 %1376, label %1356, label %1363, !llvm.loop !27

1377:                                             ; preds = %1335, %1284, %1270
  %1378 = phi i32 [ 0, %1270 ], [ 0, %1284 ], [ %1337, %1335 ]
  %1379 = icmp eq i32 %1378, 0
  br label %1380

1380:                                             ; preds = %1377, %1269
  %1381 = phi i1 [ false, %1269 ], [ %1379, %1377 ]
  br i1 %1381, label %1424, label %1382

1382:                                             ; preds = %1380
  %1383 = load i64, ptr %493, align 8
  %1384 = getelementptr inbounds double, ptr %186, i64 %1383
  %1385 = load double, ptr %1384, align 8
  %1386 = fcmp ult double %1385, %602
  br i1 %1386, label %1424, label %1387

1387:                                             ; preds = %1382
  %1388 = load ptr, ptr %75, align 8
  %1389 = getelementptr inbounds i8, ptr %1388, i64 8
  %1390 = load i64, ptr %1389, align 8
  %1391 = load i64, ptr %85, align 8
  %1392 = load ptr, ptr %80, align 8
  %1393 = load ptr, ptr %79, align 8
  %1394 = getelementptr inbounds i8, ptr %1393, i64 48
  %1395 = load i64, ptr %1394, align 8
  %1396 = icmp slt i64 %1395, %1391
  br i1 %1396, label %1397, label %1420

1397:                                             ; preds = %1387
  %1398 = icmp sgt i64 %1390, 0
  br label %1399

1399:                                             ; preds = %1397, %1410
  %1400 = phi i64 [ %1395, %1397 ], [ %1411, %1410 ]
  %1401 = getelementptr inbounds double, ptr %1392, i64 %1400
  %1402 = load double, ptr %1401, align 8
  %1403 = load ptr, ptr %77, align 8
  %1404 = load double, ptr %1403, align 8
  %1405 = fcmp ugt double %1402, %1404
  br i1 %1405, label %1420, label %1406

1406:                                             ; preds = %1399
  br i1 %1398, label %1407, label %1410

1407:                                             ; preds = %1406
  %1408 = mul nsw i64 %1400, %1390
  %1409 = getelementptr double, ptr %1, i64 %1408
  br label %1413

1410:                                             ; preds = %1413, %1406
  %1411 = add i64 %1400, 1
  %1412 = icmp eq i64 %1411, %1391
  br i1 %1412, label %1420, label %1399, !llvm.loop !9

1413:                                             ; preds = %1407, %1413
  %1414 = phi i64 [ 0, %1407 ], [ %1418, %1413 ]
  %1415 = getelementptr inbounds double, ptr %180, i64 %1414
  %1416 = load double, ptr %1415, align 8
  %1417 = getelementptr double, ptr %1409, i64 %1414
  store double %1416, ptr %1417, align 8
  %1418 = add nuw nsw i64 %1414, 1
  %1419 = icmp eq i64 %1418, %1390
  br i1 %1419, label %1410, label %1413, !llvm.loop !10

1420:                                             ; preds = %1399, %1410, %1387
  %1421 = phi i64 [ %1395, %1387 ], [ %1400, %1399 ], [ %1391, %1410 ]
  %1422 = load ptr, ptr %79, align 8
  %1423 = getelementptr inbounds i8, ptr %1422, i64 48
  store i64 %1421, ptr %1423, align 8
  br label %1790

1424:                                             ; preds = %1382, %1380
  %1425 = load ptr, ptr %0, align 8
  %1426 = load ptr, ptr %75, align 8
  %1427 = getelementptr inbounds i8, ptr %1426, i64 16
  %1428 = load i64, ptr %1427, align 8
  %1429 = load i64, ptr %1425, align 8
  %1430 = load i64, ptr %150, align 8
  %1431 = load ptr, ptr %151, align 8
  %1432 = mul nsw i64 %1430, %1429
  %1433 = getelementptr inbounds double, ptr %1431, i64 %1432
  %1434 = load ptr, ptr %152, align 8
  %1435 = add nsw i64 %1429, 1
  %1436 = getelementptr inbounds i8, ptr %1425, i64 16
  %1437 = load i64, ptr %1436, align 8
  %1438 = icmp sgt i64 %1437, 0
  br i1 %1438, label %1439, label %1500

1439:                                             ; preds = %1424
  %1440 = getelementptr inbounds i8, ptr %1425, i64 8
  br label %1446

1441:                                             ; preds = %1488
  %1442 = add nsw i64 %1449, 1
  %1443 = load i64, ptr %1436, align 8
  %1444 = add nsw i64 %1443, %1435
  %1445 = icmp slt i64 %1442, %1444
  br i1 %1445, label %1446, label %1500, !llvm.loop !28

1446:                                             ; preds = %1439, %1441
  %1447 = phi i1 [ %1438, %1439 ], [ %1445, %1441 ]
  %1448 = phi i64 [ undef, %1439 ], [ %1499, %1441 ]
  %1449 = phi i64 [ %1435, %1439 ], [ %1442, %1441 ]
  %1450 = load i64, ptr %1440, align 8
  %1451 = load ptr, ptr %153, align 8
  %1452 = load ptr, ptr %76, align 8
  %1453 = load ptr, ptr %154, align 8
  %1454 = getelementptr i64, ptr %1453, i64 %1449
  %1455 = getelementptr i64, ptr %1454, i64 %1450
  %1456 = load i64, ptr %1455, align 8
  %1457 = getelementptr i8, ptr %1455, i64 8
  %1458 = load i64, ptr %1457, align 8
  %1459 = xor i64 %1456, -1
  %1460 = add i64 %1458, %1459
  %1461 = load ptr, ptr %102, align 8
  %1462 = load ptr, ptr %151, align 8
  %1463 = load ptr, ptr %155, align 8
  %1464 = getelementptr inbounds i64, ptr %1463, i64 %1456
  %1465 = load ptr, ptr %156, align 8
  %1466 = getelementptr inbounds double, ptr %1465, i64 %1456
  tail call fastcc void @combine(ptr noundef %1451, ptr noundef %1452, ptr noundef %1461, ptr noundef %1462, ptr noundef %1464, ptr noundef %1466, i64 noundef %1460, i64 noundef 1, i64 noundef %1428) #10
  %1467 = load ptr, ptr %151, align 8
  %1468 = mul nsw i64 %1449, %1430
  %1469 = getelementptr inbounds double, ptr %1467, i64 %1468
  %1470 = load i64, ptr %489, align 8
  %1471 = add nsw i64 %1470, 1
  store i64 %1471, ptr %489, align 8
  %1472 = load ptr, ptr %157, align 8
  %1473 = getelementptr inbounds double, ptr %1472, i64 %1449
  %1474 = load double, ptr %1473, align 8
  %1475 = fmul double %603, %1474
  %1476 = fadd double %517, %1475
  %1477 = load ptr, ptr %153, align 8
  %1478 = load ptr, ptr %158, align 8
  store double %1476, ptr %1478, align 8
  %1479 = load ptr, ptr %75, align 8
  %1480 = getelementptr inbounds i8, ptr %1479, i64 40
  %1481 = load i64, ptr %1480, align 8
  %1482 = icmp eq i64 %1481, 0
  br i1 %1482, label %1484, label %1483

1483:                                             ; preds = %1446
  tail call fastcc void @settle(ptr noundef nonnull %75) #10
  br label %1484

1484:                                             ; preds = %1483, %1446
  %1485 = load i64, ptr %159, align 8
  %1486 = icmp sgt i64 %1485, 0
  br i1 %1486, label %1487, label %1488

1487:                                             ; preds = %1484
  tail call fastcc void @sample(ptr noundef nonnull %75) #10
  br label %1488

1488:                                             ; preds = %1484, %1487
  %1489 = load ptr, ptr %75, align 8
  %1490 = load i64, ptr %1489, align 8
  %1491 = load ptr, ptr %158, align 8
  %1492 = load ptr, ptr %160, align 8
  %1493 = load ptr, ptr %161, align 8
  %1494 = inttoptr i64 %1490 to ptr
  %1495 = load ptr, ptr %1494, align 8
  %1496 = tail call i32 %1495(ptr noundef %1491, ptr noundef %1477, ptr noundef %1492, ptr noundef %1493, ptr noundef %1469) #11
  %1497 = sext i32 %1496 to i64
  %1498 = icmp eq i32 %1496, 0
  %1499 = select i1 %1498, i64 %1448, i64 %1497
  br i1 %1498, label %1441, label %1500

1500:                                             ; preds = %1441, %1488, %1424
  %1501 = phi i1 [ %1438, %1424 ], [ %1445, %1441 ], [ %1447, %1488 ]
  %1502 = phi i64 [ 0, %1424 ], [ %1497, %1488 ], [ %1497, %1441 ]
  %1503 = phi i64 [ undef, %1424 ], [ %1499, %1488 ], [ %1499, %1441 ]
  %1504 = getelementptr inbounds i8, ptr %1425, i64 16
  br i1 %1501, label %1573, label %1505

1505:                                             ; preds = %1500
  %1506 = load ptr, ptr %75, align 8
  %1507 = getelementptr inbounds i8, ptr %1506, i64 8
  %1508 = load i64, ptr %1507, align 8
  %1509 = icmp sgt i64 %1508, 0
  br i1 %1509, label %1510, label %1514

1510:                                             ; preds = %1505
  %1511 = getelementptr inbounds double, ptr %1434, i64 %1430
  %1512 = shl nsw i64 %1430, 4
  %1513 = getelementptr inbounds i8, ptr %1434, i64 %1512
  br label %1521

1514:                                             ; preds = %1521, %1505
  %1515 = getelementptr inbounds i8, ptr %1425, i64 8
  %1516 = load i64, ptr %1515, align 8
  %1517 = load i64, ptr %1504, align 8
  %1518 = getelementptr inbounds i8, ptr %1425, i64 24
  %1519 = load i64, ptr %1518, align 8
  %1520 = icmp sgt i64 %1519, 3
  br i1 %1520, label %1548, label %1573

1521:                                             ; preds = %1510, %1521
  %1522 = phi i64 [ 0, %1510 ], [ %1543, %1521 ]
  %1523 = load ptr, ptr %162, align 8
  %1524 = getelementptr inbounds double, ptr %1523, i64 %1522
  %1525 = load double, ptr %1524, align 8
  %1526 = load ptr, ptr %76, align 8
  %1527 = getelementptr inbounds double, ptr %1526, i64 %1522
  %1528 = load double, ptr %1527, align 8
  %1529 = fsub double %1525, %1528
  %1530 = load ptr, ptr %151, align 8
  %1531 = getelementptr inbounds double, ptr %1530, i64 %1522
  %1532 = load double, ptr %1531, align 8
  %1533 = fmul double %603, %1532
  %1534 = fsub double %1533, %1529
  %1535 = getelementptr inbounds double, ptr %1434, i64 %1522
  store double %1529, ptr %1535, align 8
  %1536 = getelementptr inbounds double, ptr %1511, i64 %1522
  store double %1534, ptr %1536, align 8
  %1537 = fsub double %1529, %1534
  %1538 = getelementptr inbounds double, ptr %1433, i64 %1522
  %1539 = load double, ptr %1538, align 8
  %1540 = fmul double %603, %1539
  %1541 = fsub double %1537, %1540
  %1542 = getelementptr inbounds double, ptr %1513, i64 %1522
  store double %1541, ptr %1542, align 8
  %1543 = add nuw nsw i64 %1522, 1
  %1544 = load ptr, ptr %75, align 8
  %1545 = getelementptr inbounds i8, ptr %1544, i64 8
  %1546 = load i64, ptr %1545, align 8
  %1547 = icmp slt i64 %1543, %1546
  br i1 %1547, label %1521, label %1514, !llvm.loop !29

1548:                                             ; preds = %1514, %1548
  %1549 = phi i64 [ %1570, %1548 ], [ 3, %1514 ]
  %1550 = mul nsw i64 %1549, %1430
  %1551 = getelementptr inbounds double, ptr %1434, i64 %1550
  %1552 = load ptr, ptr %163, align 8
  %1553 = load ptr, ptr %164, align 8
  %1554 = getelementptr i64, ptr %1553, i64 %1435
  %1555 = getelementptr i64, ptr %1554, i64 %1516
  %1556 = getelementptr i64, ptr %1555, i64 %1517
  %1557 = getelementptr i64, ptr %1556, i64 %1549
  %1558 = getelementptr i8, ptr %1557, i64 -24
  %1559 = load i64, ptr %1558, align 8
  %1560 = getelementptr i8, ptr %1557, i64 -16
  %1561 = load i64, ptr %1560, align 8
  %1562 = xor i64 %1559, -1
  %1563 = add i64 %1561, %1562
  %1564 = load ptr, ptr %102, align 8
  %1565 = load ptr, ptr %151, align 8
  %1566 = load ptr, ptr %165, align 8
  %1567 = getelementptr inbounds i64, ptr %1566, i64 %1559
  %1568 = load ptr, ptr %166, align 8
  %1569 = getelementptr inbounds double, ptr %1568, i64 %1559
  tail call fastcc void @combine(ptr noundef %1551, ptr noundef %1552, ptr noundef %1564, ptr noundef %1565, ptr noundef %1567, ptr noundef %1569, i64 noundef %1563, i64 noundef 1, i64 noundef %1428) #10
  %1570 = add nuw nsw i64 %1549, 1
  %1571 = load i64, ptr %1518, align 8
  %1572 = icmp slt i64 %1570, %1571
  br i1 %1572, label %1548, label %1573, !llvm.loop !30

1573:                                             ; preds = %1548, %1514, %1500
  %1574 = phi i64 [ %1503, %1500 ], [ %1502, %1514 ], [ %1502, %1548 ]
  %1575 = icmp eq i64 %1574, 0
  br i1 %1575, label %1579, label %1576

1576:                                             ; preds = %1573
  store i64 3, ptr %494, align 8
  store double %517, ptr %179, align 8
  %1577 = icmp slt i64 %1574, 0
  %1578 = select i1 %1577, i64 -4, i64 2
  br label %2018

1579:                                             ; preds = %1573
  %1580 = load ptr, ptr %77, align 8
  br i1 %1381, label %1581, label %1592

1581:                                             ; preds = %1579
  %1582 = load ptr, ptr %84, align 8
  %1583 = getelementptr inbounds i8, ptr %1582, i64 16
  %1584 = load i64, ptr %1583, align 8
  %1585 = inttoptr i64 %1584 to ptr
  %1586 = tail call i64 %1585(ptr noundef %0, double noundef %517, double noundef %603) #11
  %1587 = icmp eq i64 %1586, -6
  br i1 %1587, label %1588, label %1589

1588:                                             ; preds = %1581
  store double %517, ptr %1580, align 8
  br label %1767

1589:                                             ; preds = %1581
  %1590 = getelementptr inbounds i8, ptr %1580, i64 48
  %1591 = load double, ptr %1590, align 8
  br label %1592

1592:                                             ; preds = %1589, %1579
  %1593 = phi double [ %1591, %1589 ], [ 1.000000e+00, %1579 ]
  %1594 = phi i64 [ %1586, %1589 ], [ 0, %1579 ]
  %1595 = fcmp oeq double %1593, 1.000000e+00
  br i1 %1595, label %1596, label %1598

1596:                                             ; preds = %1592
  %1597 = load double, ptr %1580, align 8
  br label %1601

1598:                                             ; preds = %1592
  %1599 = fmul double %603, %1593
  %1600 = fadd double %517, %1599
  br label %1601

1601:                                             ; preds = %1598, %1596
  %1602 = phi double [ %1597, %1596 ], [ %1600, %1598 ]
  %1603 = icmp eq i64 %1594, -4
  %1604 = select i1 %1603, i64 -4, i64 0
  br i1 %1603, label %1662, label %1605

1605:                                             ; preds = %1601
  %1606 = fcmp olt double %1593, 1.000000e+00
  %1607 = load ptr, ptr %75, align 8
  %1608 = getelementptr inbounds i8, ptr %1607, i64 8
  %1609 = load i64, ptr %1608, align 8
  %1610 = load i64, ptr %85, align 8
  %1611 = load ptr, ptr %80, align 8
  %1612 = load ptr, ptr %79, align 8
  %1613 = getelementptr inbounds i8, ptr %1612, i64 48
  %1614 = load i64, ptr %1613, align 8
  %1615 = icmp slt i64 %1614, %1610
  br i1 %1615, label %1616, label %1658

1616:                                             ; preds = %1605, %1654
  %1617 = phi i64 [ %1655, %1654 ], [ undef, %1605 ]
  %1618 = phi i64 [ %1656, %1654 ], [ %1614, %1605 ]
  %1619 = getelementptr inbounds double, ptr %1611, i64 %1618
  %1620 = load double, ptr %1619, align 8
  %1621 = fcmp olt double %1620, %1602
  %1622 = fcmp oeq double %1620, %1602
  %1623 = and i1 %1606, %1622
  %1624 = or i1 %1621, %1623
  br i1 %1624, label %1625, label %1658

1625:                                             ; preds = %1616
  %1626 = fsub double %1620, %517
  %1627 = fdiv double %1626, %603
  %1628 = mul nsw i64 %1618, %1609
  %1629 = getelementptr inbounds double, ptr %1, i64 %1628
  %1630 = load ptr, ptr %167, align 8
  %1631 = insertelement <8 x double> poison, double %1627, i64 0
  %1632 = shufflevector <8 x double> %1631, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1632, ptr %1630, align 8
  %1633 = load ptr, ptr %76, align 8
  %1634 = load ptr, ptr %152, align 8
  %1635 = load i64, ptr %150, align 8
  %1636 = load ptr, ptr %0, align 8
  %1637 = getelementptr inbounds i8, ptr %1636, i64 24
  %1638 = load i64, ptr %1637, align 8
  %1639 = load ptr, ptr %167, align 8
  %1640 = load ptr, ptr %75, align 8
  %1641 = getelementptr inbounds i8, ptr %1640, i64 16
  %1642 = load i64, ptr %1641, align 8
  tail call fastcc void @nested(ptr noundef %1629, ptr noundef %1633, ptr noundef %1634, i64 noundef %1635, i64 noundef %1638, ptr noundef %1639, i64 noundef %1642) #10
  %1643 = load ptr, ptr %83, align 8
  %1644 = load i64, ptr %1643, align 8
  %1645 = icmp eq i64 %1644, 1
  br i1 %1645, label %1646, label %1654

1646:                                             ; preds = %1625
  %1647 = load double, ptr %1619, align 8
  %1648 = getelementptr inbounds i8, ptr %1643, i64 56
  %1649 = load i64, ptr %1648, align 8
  %1650 = inttoptr i64 %1649 to ptr
  %1651 = tail call i64 %1650(ptr noundef %0, double noundef %1647, ptr noundef %1629, ptr noundef null) #11
  %1652 = icmp eq i64 %1651, 0
  %1653 = select i1 %1652, i64 %1617, i64 %1651
  br i1 %1652, label %1654, label %1662

1654:                                             ; preds = %1646, %1625
  %1655 = phi i64 [ %1653, %1646 ], [ %1617, %1625 ]
  %1656 = add i64 %1618, 1
  %1657 = icmp eq i64 %1656, %1610
  br i1 %1657, label %1658, label %1616, !llvm.loop !31

1658:                                             ; preds = %1654, %1616, %1605
  %1659 = phi i64 [ %1614, %1605 ], [ %1610, %1654 ], [ %1618, %1616 ]
  %1660 = load ptr, ptr %79, align 8
  %1661 = getelementptr inbounds i8, ptr %1660, i64 48
  store i64 %1659, ptr %1661, align 8
  br label %1662

1662:                                             ; preds = %1646, %1658, %1601
  %1663 = phi i64 [ %1604, %1601 ], [ 0, %1658 ], [ %1653, %1646 ]
  %1664 = icmp eq i64 %1663, 0
  %1665 = icmp ne i64 %1594, 0
  %1666 = fcmp olt double %1593, 1.000000e+00
  %1667 = and i1 %1666, %1664
  %1668 = and i1 %1665, %1667
  br i1 %1668, label %1669, label %1706

1669:                                             ; preds = %1662
  %1670 = load ptr, ptr %168, align 8
  %1671 = load ptr, ptr %169, align 8
  %1672 = insertelement <8 x double> poison, double %1593, i64 0
  %1673 = shufflevector <8 x double> %1672, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1673, ptr %1671, align 8
  %1674 = load ptr, ptr %76, align 8
  %1675 = load ptr, ptr %152, align 8
  %1676 = load i64, ptr %150, align 8
  %1677 = load ptr, ptr %0, align 8
  %1678 = getelementptr inbounds i8, ptr %1677, i64 24
  %1679 = load i64, ptr %1678, align 8
  %1680 = load ptr, ptr %169, align 8
  %1681 = load ptr, ptr %75, align 8
  %1682 = getelementptr inbounds i8, ptr %1681, i64 16
  %1683 = load i64, ptr %1682, align 8
  tail call fastcc void @nested(ptr noundef %1670, ptr noundef %1674, ptr noundef %1675, i64 noundef %1676, i64 noundef %1679, ptr noundef %1680, i64 noundef %1683) #10
  %1684 = load i64, ptr %82, align 8
  %1685 = icmp sgt i64 %1684, 0
  br i1 %1685, label %1690, label %1686

1686:                                             ; preds = %1690, %1669
  %1687 = load ptr, ptr %83, align 8
  %1688 = load i64, ptr %1687, align 8
  %1689 = icmp eq i64 %1688, 1
  br i1 %1689, label %1700, label %1706

1690:                                             ; preds = %1669, %1690
  %1691 = phi i64 [ %1697, %1690 ], [ 0, %1669 ]
  %1692 = load ptr, ptr %168, align 8
  %1693 = getelementptr inbounds double, ptr %1692, i64 %1691
  %1694 = load double, ptr %1693, align 8
  %1695 = load ptr, ptr %78, align 8
  %1696 = getelementptr inbounds double, ptr %1695, i64 %1691
  store double %1694, ptr %1696, align 8
  %1697 = add nuw nsw i64 %1691, 1
  %1698 = load i64, ptr %82, align 8
  %1699 = icmp slt i64 %1697, %1698
  br i1 %1699, label %1690, label %1686, !llvm.loop !32

1700:                                             ; preds = %1686
  %1701 = load ptr, ptr %78, align 8
  %1702 = getelementptr inbounds i8, ptr %1687, i64 56
  %1703 = load i64, ptr %1702, align 8
  %1704 = inttoptr i64 %1703 to ptr
  %1705 = tail call i64 %1704(ptr noundef %0, double noundef %1602, ptr noundef %1701, ptr noundef null) #11
  br label %1706

1706:                                             ; preds = %1700, %1686, %1662
  %1707 = phi i64 [ %1705, %1700 ], [ 0, %1686 ], [ %1663, %1662 ]
  %1708 = icmp eq i64 %1707, 0
  br i1 %1708, label %1711, label %1709

1709:                                             ; preds = %1706
  store double %517, ptr %1580, align 8
  %1710 = getelementptr inbounds i8, ptr %1580, i64 8
  store double %603, ptr %1710, align 8
  br label %1767

1711:                                             ; preds = %1706
  br i1 %1595, label %1712, label %1750

1712:                                             ; preds = %1711
  %1713 = load ptr, ptr %78, align 8
  %1714 = load ptr, ptr %75, align 8
  %1715 = getelementptr inbounds i8, ptr %1714, i64 8
  %1716 = load i64, ptr %1715, align 8
  %1717 = load i64, ptr %85, align 8
  %1718 = load ptr, ptr %80, align 8
  %1719 = load ptr, ptr %79, align 8
  %1720 = getelementptr inbounds i8, ptr %1719, i64 48
  %1721 = load i64, ptr %1720, align 8
  %1722 = icmp slt i64 %1721, %1717
  br i1 %1722, label %1723, label %1746

1723:                                             ; preds = %1712
  %1724 = icmp sgt i64 %1716, 0
  br label %1725

1725:                                             ; preds = %1723, %1736
  %1726 = phi i64 [ %1721, %1723 ], [ %1737, %1736 ]
  %1727 = getelementptr inbounds double, ptr %1718, i64 %1726
  %1728 = load double, ptr %1727, align 8
  %1729 = load ptr, ptr %77, align 8
  %1730 = load double, ptr %1729, align 8
  %1731 = fcmp ugt double %1728, %1730
  br i1 %1731, label %1746, label %1732

1732:                                             ; preds = %1725
  br i1 %1724, label %1733, label %1736

1733:                                             ; preds = %1732
  %1734 = mul nsw i64 %1726, %1716
  %1735 = getelementptr double, ptr %1, i64 %1734
  br label %1739

1736:                                             ; preds = %1739, %1732
  %1737 = add i64 %1726, 1
  %1738 = icmp eq i64 %1737, %1717
  br i1 %1738, label %1746, label %1725, !llvm.loop !9

1739:                                             ; preds = %1733, %1739
  %1740 = phi i64 [ 0, %1733 ], [ %1744, %1739 ]
  %1741 = getelementptr inbounds double, ptr %1713, i64 %1740
  %1742 = load double, ptr %1741, align 8
  %1743 = getelementptr double, ptr %1735, i64 %1740
  store double %1742, ptr %1743, align 8
  %1744 = add nuw nsw i64 %1740, 1
  %1745 = icmp eq i64 %1744, %1716
  br i1 %1745, label %1736, label %1739, !llvm.loop !10

1746:                                             ; preds = %1736, %1725, %1712
  %1747 = phi i64 [ %1721, %1712 ], [ %1717, %1736 ], [ %1726, %1725 ]
  %1748 = load ptr, ptr %79, align 8
  %1749 = getelementptr inbounds i8, ptr %1748, i64 48
  store i64 %1747, ptr %1749, align 8
  br label %1750

1750:                                             ; preds = %1746, %1711
  br i1 %1665, label %1751, label %1767

1751:                                             ; preds = %1750
  %1752 = load i64, ptr %82, align 8
  %1753 = icmp sgt i64 %1752, 0
  br i1 %1753, label %1757, label %1754

1754:                                             ; preds = %1757, %1751
  store double %1602, ptr %1580, align 8
  %1755 = getelementptr inbounds i8, ptr %1580, i64 8
  store double 0.000000e+00, ptr %1755, align 8
  %1756 = load ptr, ptr %79, align 8
  store i64 0, ptr %1756, align 8
  br label %1767

1757:                                             ; preds = %1751, %1757
  %1758 = phi i64 [ %1764, %1757 ], [ 0, %1751 ]
  %1759 = load ptr, ptr %78, align 8
  %1760 = getelementptr inbounds double, ptr %1759, i64 %1758
  %1761 = load double, ptr %1760, align 8
  %1762 = load ptr, ptr %76, align 8
  %1763 = getelementptr inbounds double, ptr %1762, i64 %1758
  store double %1761, ptr %1763, align 8
  %1764 = add nuw nsw i64 %1758, 1
  %1765 = load i64, ptr %82, align 8
  %1766 = icmp slt i64 %1764, %1765
  br i1 %1766, label %1757, label %1754, !llvm.loop !33

1767:                                             ; preds = %1588, %1709, %1750, %1754
  %1768 = phi i64 [ -6, %1588 ], [ %1707, %1709 ], [ %1594, %1754 ], [ %1594, %1750 ]
  %1769 = icmp eq i64 %1768, -6
  br i1 %1769, label %1774, label %1770

1770:                                             ; preds = %1767
  %1771 = icmp ne i64 %1768, 6
  %1772 = select i1 %1771, i1 true, i1 %195
  %1773 = select i1 %1772, i1 true, i1 %202
  br i1 %1773, label %1784, label %1774

1774:                                             ; preds = %1770, %1767
  %1775 = phi i64 [ %1768, %1770 ], [ 2, %1767 ]
  %1776 = load i64, ptr %484, align 8
  %1777 = add nsw i64 %1776, -1
  store i64 %1777, ptr %484, align 8
  %1778 = load ptr, ptr %98, align 8
  %1779 = load i64, ptr %1778, align 8
  %1780 = add nsw i64 %1779, -1
  store i64 %1780, ptr %1778, align 8
  %1781 = load i64, ptr %485, align 8
  %1782 = add nsw i64 %1781, 1
  store i64 %1782, ptr %485, align 8
  store i64 %1775, ptr %506, align 8
  store double 1.000000e+00, ptr %507, align 8
  %1783 = fmul double %603, 2.500000e-01
  br label %2018, !llvm.loop !23

1784:                                             ; preds = %1770
  %1785 = icmp eq i64 %1768, 0
  br i1 %1785, label %1790, label %1786

1786:                                             ; preds = %1784
  %1787 = load ptr, ptr %98, align 8
  %1788 = load i64, ptr %1787, align 8
  %1789 = add nsw i64 %1788, 1
  store i64 %1789, ptr %1787, align 8
  br label %2018

1790:                                             ; preds = %1784, %1420
  br i1 %195, label %1964, label %1791

1791:                                             ; preds = %1790
  %1792 = load double, ptr %495, align 8
  %1793 = load double, ptr %496, align 8
  %1794 = fcmp ogt double %1145, 1.000000e-10
  %1795 = select i1 %1794, double %1145, double 1.000000e-10
  %1796 = load double, ptr %497, align 8
  %1797 = load double, ptr %498, align 8
  %1798 = fneg double %1797
  %1799 = bitcast double %1795 to i64
  %1800 = add nsw i64 %1799, -4604544271217802189
  %1801 = ashr i64 %1800, 52
  %1802 = and i64 %1800, -4503599627370496
  %1803 = sub nsw i64 %1799, %1802
  %1804 = bitcast i64 %1803 to double
  %1805 = fadd double %1804, -1.000000e+00
  %1806 = fadd double %1804, 1.000000e+00
  %1807 = fdiv double %1805, %1806
  %1808 = fmul double %1807, %1807
  %1809 = tail call double @llvm.fma.f64(double %1808, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1810 = tail call double @llvm.fma.f64(double %1809, double %1808, double 0x3FE2776C50EF9BFE)
  %1811 = tail call double @llvm.fma.f64(double %1810, double %1808, double 0x3FEEC709DC3A03FD)
  %1812 = tail call double @llvm.fma.f64(double %1811, double %1808, double 0x40071547652B82FE)
  %1813 = trunc nsw i64 %1801 to i32
  %1814 = sitofp i32 %1813 to double
  %1815 = fmul double %1807, %1812
  %1816 = fadd double %1815, %1814
  %1817 = fmul double %1816, %1798
  %1818 = fcmp ogt double %1817, -1.000000e+03
  %1819 = select i1 %1818, double %1817, double -1.000000e+03
  %1820 = fcmp olt double %1819, 1.000000e+03
  %1821 = select i1 %1820, double %1819, double 1.000000e+03
  %1822 = tail call double @llvm.rint.f64(double %1821)
  %1823 = fsub double %1821, %1822
  %1824 = tail call double @llvm.fma.f64(double %1823, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1825 = tail call double @llvm.fma.f64(double %1824, double %1823, double 0x3F55D87FE78A6730)
  %1826 = tail call double @llvm.fma.f64(double %1825, double %1823, double 0x3F83B2AB6FBA4E77)
  %1827 = tail call double @llvm.fma.f64(double %1826, double %1823, double 0x3FAC6B08D704A0BF)
  %1828 = tail call double @llvm.fma.f64(double %1827, double %1823, double 0x3FCEBFBDFF82C58E)
  %1829 = tail call double @llvm.fma.f64(double %1828, double %1823, double 0x3FE62E42FEFA39EF)
  %1830 = tail call double @llvm.fma.f64(double %1829, double %1823, double 1.000000e+00)
  %1831 = bitcast double %1830 to i64
  %1832 = fptosi double %1822 to i32
  %1833 = sext i32 %1832 to i64
  %1834 = shl nsw i64 %1833, 52
  %1835 = add nsw i64 %1834, %1831
  %1836 = bitcast i64 %1835 to double
  %1837 = fmul double %1796, %1836
  %1838 = load double, ptr %499, align 8
  %1839 = fcmp une double %1838, 0.000000e+00
  br i1 %1839, label %1840, label %1880

1840:                                             ; preds = %1791
  %1841 = bitcast double %1792 to i64
  %1842 = add nsw i64 %1841, -4604544271217802189
  %1843 = ashr i64 %1842, 52
  %1844 = and i64 %1842, -4503599627370496
  %1845 = sub nsw i64 %1841, %1844
  %1846 = bitcast i64 %1845 to double
  %1847 = fadd double %1846, -1.000000e+00
  %1848 = fadd double %1846, 1.000000e+00
  %1849 = fdiv double %1847, %1848
  %1850 = fmul double %1849, %1849
  %1851 = tail call double @llvm.fma.f64(double %1850, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1852 = tail call double @llvm.fma.f64(double %1851, double %1850, double 0x3FE2776C50EF9BFE)
  %1853 = tail call double @llvm.fma.f64(double %1852, double %1850, double 0x3FEEC709DC3A03FD)
  %1854 = tail call double @llvm.fma.f64(double %1853, double %1850, double 0x40071547652B82FE)
  %1855 = trunc nsw i64 %1843 to i32
  %1856 = sitofp i32 %1855 to double
  %1857 = fmul double %1849, %1854
  %1858 = fadd double %1857, %1856
  %1859 = fmul double %1838, %1858
  %1860 = fcmp ogt double %1859, -1.000000e+03
  %1861 = select i1 %1860, double %1859, double -1.000000e+03
  %1862 = fcmp olt double %1861, 1.000000e+03
  %1863 = select i1 %1862, double %1861, double 1.000000e+03
  %1864 = tail call double @llvm.rint.f64(double %1863)
  %1865 = fsub double %1863, %1864
  %1866 = tail call double @llvm.fma.f64(double %1865, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1867 = tail call double @llvm.fma.f64(double %1866, double %1865, double 0x3F55D87FE78A6730)
  %1868 = tail call double @llvm.fma.f64(double %1867, double %1865, double 0x3F83B2AB6FBA4E77)
  %1869 = tail call double @llvm.fma.f64(double %1868, double %1865, double 0x3FAC6B08D704A0BF)
  %1870 = tail call double @llvm.fma.f64(double %1869, double %1865, double 0x3FCEBFBDFF82C58E)
  %1871 = tail call double @llvm.fma.f64(double %1870, double %1865, double 0x3FE62E42FEFA39EF)
  %1872 = tail call double @llvm.fma.f64(double %1871, double %1865, double 1.000000e+00)
  %1873 = bitcast double %1872 to i64
  %1874 = fptosi double %1864 to i32
  %1875 = sext i32 %1874 to i64
  %1876 = shl nsw i64 %1875, 52
  %1877 = add nsw i64 %1876, %1873
  %1878 = bitcast i64 %1877 to double
  %1879 = fmul double %1837, %1878
  br label %1880

1880:                                             ; preds = %1791, %1840
  %1881 = phi double [ %1879, %1840 ], [ %1837, %1791 ]
  %1882 = load double, ptr %500, align 8
  %1883 = fcmp ogt double %1881, %1882
  %1884 = select i1 %1883, double %1881, double %1882
  %1885 = fcmp olt double %1793, %1884
  %1886 = select i1 %1885, double %1793, double %1884
  %1887 = fmul double %603, %1886
  %1888 = fcmp oeq double %1793, 1.000000e+00
  br i1 %1888, label %1889, label %1956

1889:                                             ; preds = %1880
  %1890 = load double, ptr %501, align 8
  br i1 %1839, label %1891, label %1931

1891:                                             ; preds = %1889
  %1892 = bitcast double %1792 to i64
  %1893 = add nsw i64 %1892, -4604544271217802189
  %1894 = ashr i64 %1893, 52
  %1895 = and i64 %1893, -4503599627370496
  %1896 = sub nsw i64 %1892, %1895
  %1897 = bitcast i64 %1896 to double
  %1898 = fadd double %1897, -1.000000e+00
  %1899 = fadd double %1897, 1.000000e+00
  %1900 = fdiv double %1898, %1899
  %1901 = fmul double %1900, %1900
  %1902 = tail call double @llvm.fma.f64(double %1901, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1903 = tail call double @llvm.fma.f64(double %1902, double %1901, double 0x3FE2776C50EF9BFE)
  %1904 = tail call double @llvm.fma.f64(double %1903, double %1901, double 0x3FEEC709DC3A03FD)
  %1905 = tail call double @llvm.fma.f64(double %1904, double %1901, double 0x40071547652B82FE)
  %1906 = trunc nsw i64 %1894 to i32
  %1907 = sitofp i32 %1906 to double
  %1908 = fmul double %1900, %1905
  %1909 = fadd double %1908, %1907
  %1910 = fmul double %1838, %1909
  %1911 = fcmp ogt double %1910, -1.000000e+03
  %1912 = select i1 %1911, double %1910, double -1.000000e+03
  %1913 = fcmp olt double %1912, 1.000000e+03
  %1914 = select i1 %1913, double %1912, double 1.000000e+03
  %1915 = tail call double @llvm.rint.f64(double %1914)
  %1916 = fsub double %1914, %1915
  %1917 = tail call double @llvm.fma.f64(double %1916, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1918 = tail call double @llvm.fma.f64(double %1917, double %1916, double 0x3F55D87FE78A6730)
  %1919 = tail call double @llvm.fma.f64(double %1918, double %1916, double 0x3F83B2AB6FBA4E77)
  %1920 = tail call double @llvm.fma.f64(double %1919, double %1916, double 0x3FAC6B08D704A0BF)
  %1921 = tail call double @llvm.fma.f64(double %1920, double %1916, double 0x3FCEBFBDFF82C58E)
  %1922 = tail call double @llvm.fma.f64(double %1921, double %1916, double 0x3FE62E42FEFA39EF)
  %1923 = tail call double @llvm.fma.f64(double %1922, double %1916, double 1.000000e+00)
  %1924 = bitcast double %1923 to i64
  %1925 = fptosi double %1915 to i32
  %1926 = sext i32 %1925 to i64
  %1927 = shl nsw i64 %1926, 52
  %1928 = add nsw i64 %1927, %1924
  %1929 = bitcast i64 %1928 to double
  %1930 = fmul double %1837, %1929
  br label %1931

1931:                                             ; preds = %1889, %1891
  %1932 = phi double [ %1930, %1891 ], [ %1837, %1889 ]
  %1933 = fcmp ogt double %1932, %1882
  %1934 = select i1 %1933, double %1932, double %1882
  %1935 = fcmp olt double %1890, %1934
  %1936 = select i1 %1935, double %1890, double %1934
  %1937 = fmul double %603, %1936
  %1938 = load i64, ptr %170, align 8
  %1939 = icmp eq i64 %1938, 0
  br i1 %1939, label %1956, label %1940

1940:                                             ; preds = %1931
  %1941 = tail call fastcc double @knot_after(ptr noundef nonnull %75, double noundef %517) #10
  %1942 = fmul double %603, 1.000000e-03
  %1943 = fsub double %602, %1942
  %1944 = tail call double @llvm.fabs.f64(double %602)
  %1945 = fmul double %1944, 0x3D10000000000000
  %1946 = fsub double %1943, %1945
  %1947 = fcmp ogt double %1946, %1941
  %1948 = fadd double %602, %1945
  %1949 = fcmp ogt double %1941, %1948
  %1950 = or i1 %1947, %1949
  br i1 %1950, label %1956, label %1951

1951:                                             ; preds = %1940
  %1952 = tail call fastcc double @knot_after(ptr noundef nonnull %75, double noundef %602) #10
  %1953 = fsub double %1952, %602
  %1954 = fcmp olt double %1953, %1937
  %1955 = select i1 %1954, double %1953, double %1937
  br label %1956

1956:                                             ; preds = %1951, %1940, %1931, %1880
  %1957 = phi double [ %1887, %1880 ], [ %1887, %1931 ], [ %1955, %1951 ], [ %1887, %1940 ]
  %1958 = fcmp ogt double %518, %1957
  %1959 = select i1 %1958, double %518, double %1957
  %1960 = select i1 %607, double %1957, double %1959
  %1961 = fcmp ogt double %1145, 1.000000e-04
  %1962 = select i1 %1961, double %1145, double 1.000000e-04
  store double %1962, ptr %495, align 8
  %1963 = load double, ptr %502, align 8
  store double %1963, ptr %496, align 8
  br label %1964

1964:                                             ; preds = %1956, %1790
  %1965 = phi double [ %1960, %1956 ], [ %518, %1790 ]
  br i1 %503, label %1970, label %1966

1966:                                             ; preds = %1970, %1964
  %1967 = load i64, ptr %504, align 8
  %1968 = load i64, ptr %85, align 8
  %1969 = icmp eq i64 %1967, %1968
  br i1 %1969, label %1982, label %1983

1970:                                             ; preds = %1964, %1970
  %1971 = phi i64 [ %1980, %1970 ], [ 0, %1964 ]
  %1972 = getelementptr inbounds double, ptr %180, i64 %1971
  %1973 = load double, ptr %1972, align 8
  %1974 = load ptr, ptr %76, align 8
  %1975 = getelementptr inbounds double, ptr %1974, i64 %1971
  store double %1973, ptr %1975, align 8
  %1976 = getelementptr inbounds double, ptr %213, i64 %1971
  %1977 = load double, ptr %1976, align 8
  %1978 = load ptr, ptr %86, align 8
  %1979 = getelementptr inbounds double, ptr %1978, i64 %1971
  store double %1977, ptr %1979, align 8
  %1980 = add nuw nsw i64 %1971, 1
  %1981 = icmp eq i64 %1980, %189
  br i1 %1981, label %1966, label %1970, !llvm.loop !34

1982:                                             ; preds = %1966
  store double %1965, ptr %215, align 8
  br label %2018

1983:                                             ; preds = %1966
  %1984 = fcmp oeq double %602, %577
  br i1 %1984, label %1985, label %2018

1985:                                             ; preds = %1983
  %1986 = load i64, ptr %99, align 8
  %1987 = icmp sgt i64 %1986, 0
  br i1 %1987, label %1988, label %1990

1988:                                             ; preds = %1985
  %1989 = load ptr, ptr %171, align 8
  store double 0x7FF0000000000000, ptr %1989, align 8
  br label %1990

1990:                                             ; preds = %1985, %1988
  %1991 = load i64, ptr %489, align 8
  %1992 = add nsw i64 %1991, 1
  store i64 %1992, ptr %489, align 8
  %1993 = load ptr, ptr %76, align 8
  %1994 = load ptr, ptr %86, align 8
  %1995 = load ptr, ptr %172, align 8
  store double %602, ptr %1995, align 8
  %1996 = load ptr, ptr %75, align 8
  %1997 = getelementptr inbounds i8, ptr %1996, i64 40
  %1998 = load i64, ptr %1997, align 8
  %1999 = icmp eq i64 %1998, 0
  br i1 %1999, label %2001, label %2000

2000:                                             ; preds = %1990
  tail call fastcc void @settle(ptr noundef nonnull %75) #10
  br label %2001

2001:                                             ; preds = %2000, %1990
  %2002 = load i64, ptr %173, align 8
  %2003 = icmp sgt i64 %2002, 0
  br i1 %2003, label %2004, label %2005

2004:                                             ; preds = %2001
  tail call fastcc void @sample(ptr noundef nonnull %75) #10
  br label %2005

2005:                                             ; preds = %2001, %2004
  %2006 = load ptr, ptr %75, align 8
  %2007 = load i64, ptr %2006, align 8
  %2008 = load ptr, ptr %172, align 8
  %2009 = load ptr, ptr %174, align 8
  %2010 = load ptr, ptr %175, align 8
  %2011 = inttoptr i64 %2007 to ptr
  %2012 = load ptr, ptr %2011, align 8
  %2013 = tail call i32 %2012(ptr noundef %2008, ptr noundef %1993, ptr noundef %2009, ptr noundef %2010, ptr noundef %1994) #11
  %2014 = icmp eq i32 %2013, 0
  br i1 %2014, label %2018, label %2015

2015:                                             ; preds = %2005
  store i64 3, ptr %505, align 8
  store double %1965, ptr %215, align 8
  %2016 = icmp slt i32 %2013, 0
  %2017 = select i1 %2016, i64 -4, i64 2
  br label %2018

2018:                                             ; preds = %2015, %2005, %1983, %1982, %1786, %1774, %1576, %1232, %1231, %1132, %796, %609
  %2019 = phi double [ %518, %609 ], [ %518, %796 ], [ %518, %1132 ], [ %1230, %1232 ], [ %1230, %1231 ], [ %518, %1576 ], [ %1783, %1774 ], [ %518, %1786 ], [ %1965, %1982 ], [ %1965, %2015 ], [ %1965, %2005 ], [ %1965, %1983 ]
  %2020 = phi double [ %517, %609 ], [ %517, %796 ], [ %517, %1132 ], [ %517, %1232 ], [ %517, %1231 ], [ %517, %1576 ], [ %517, %1774 ], [ %517, %1786 ], [ %602, %1982 ], [ %602, %2015 ], [ %602, %2005 ], [ %602, %1983 ]
  %2021 = phi i32 [ 1, %609 ], [ 1, %796 ], [ 1, %1132 ], [ 3, %1232 ], [ 1, %1231 ], [ 1, %1576 ], [ 3, %1774 ], [ 1, %1786 ], [ 1, %1982 ], [ 1, %2015 ], [ 0, %2005 ], [ 0, %1983 ]
  %2022 = phi i64 [ 2, %609 ], [ -4, %796 ], [ -4, %1132 ], [ %516, %1232 ], [ 2, %1231 ], [ %1578, %1576 ], [ %516, %1774 ], [ %1768, %1786 ], [ 0, %1982 ], [ %2017, %2015 ], [ %516, %2005 ], [ %516, %1983 ]
  switch i32 %2021, label %2026 [
    i32 0, label %2023
    i32 3, label %2023
  ]

2023:                                             ; preds = %2018, %2018
  %2024 = load i64, ptr %182, align 8
  %2025 = icmp eq i64 %2024, 0
  br i1 %2025, label %512, label %514, !llvm.loop !23

2026:                                             ; preds = %2018, %178, %277, %319, %512, %531, %539
  %2027 = phi i64 [ -1, %178 ], [ %280, %277 ], [ -1, %512 ], [ -5, %531 ], [ 1, %539 ], [ 0, %319 ], [ %2022, %2018 ]
  %2028 = load ptr, ptr %177, align 8
  %2029 = getelementptr inbounds i8, ptr %2028, i64 48
  %2030 = load i64, ptr %2029, align 8
  %2031 = icmp ne i64 %2027, -2
  %2032 = icmp eq i64 %2030, 0
  %2033 = select i1 %2031, i1 true, i1 %2032
  br i1 %2033, label %2041, label %2034

2034:                                             ; preds = %2026
  %2035 = inttoptr i64 %2030 to ptr
  %2036 = tail call i64 %2035(ptr noundef %0) #11
  %2037 = icmp eq i64 %2036, 8
  %2038 = select i1 %2037, i64 8, i64 %2027
  %2039 = icmp eq i64 %2036, 1
  %2040 = zext i1 %2039 to i32
  br label %2041

2041:                                             ; preds = %2026, %2034
  %2042 = phi i64 [ %2027, %2026 ], [ %2038, %2034 ]
  %2043 = phi i32 [ 0, %2026 ], [ %2040, %2034 ]
  %2044 = icmp eq i32 %2043, 0
  br i1 %2044, label %2045, label %178, !llvm.loop !35

2045:                                             ; preds = %2041
  %2046 = getelementptr inbounds i8, ptr %0, i64 320
  %2047 = load i64, ptr %2046, align 8
  %2048 = icmp sgt i64 %2047, 0
  br i1 %2048, label %2049, label %2052

2049:                                             ; preds = %2045
  %2050 = getelementptr inbounds i8, ptr %0, i64 336
  %2051 = load ptr, ptr %2050, align 8
  store double 0x7FF0000000000000, ptr %2051, align 8
  br label %2052

2052:                                             ; preds = %2045, %2049
  ret i64 %2042
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

define internal fastcc double @knot_after(ptr noundef readonly %0, double noundef %1) unnamed_addr #7 {
  %3 = tail call double @llvm.fabs.f64(double %1)
  %4 = fmul double %3, 0x3D10000000000000
  %5 = fadd double %4, %1
  %6 = getelementptr inbounds i8, ptr %0, i64 104
  %7 = load i64, ptr %6, align 8
  %8 = icmp sgt i64 %7, 0
  br i1 %8, label %9, label %16

9:                                                ; preds = %2
  %10 = getelementptr inbounds i8, ptr %0, i64 96
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 112
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %0, i64 120
  %15 = load ptr, ptr %14, align 8
  br label %18

16:                                               ; preds = %68, %2
  %17 = phi double [ 0x7FF0000000000000, %2 ], [ %69, %68 ]
  ret double %17

18:                                               ; preds = %9, %68
  %19 = phi double [ 0x7FF0000000000000, %9 ], [ %69, %68 ]
  %20 = phi i64 [ 0, %9 ], [ %70, %68 ]
  %21 = mul nsw i64 %13, %20
  %22 = getelementptr inbounds i64, ptr %11, i64 %21
  %23 = getelementptr inbounds i8, ptr %22, i64 8
  %24 = load i64, ptr %23, align 8
  %25 = getelementptr inbounds double, ptr %15, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = fcmp ogt double %26, %5
  br i1 %27, label %58, label %28

28:                                               ; preds = %18
  %29 = getelementptr inbounds i8, ptr %22, i64 16
  %30 = load i64, ptr %29, align 8
  %31 = fcmp ugt double %26, %5
  br i1 %31, label %40, label %32

32:                                               ; preds = %28
  %33 = icmp eq i64 %30, 1
  br i1 %33, label %55, label %34

34:                                               ; preds = %32
  %35 = getelementptr i8, ptr %25, i64 8
  %36 = load double, ptr %35, align 8
  %37 = fcmp ule double %36, %5
  %38 = icmp sgt i64 %30, 1
  %39 = select i1 %37, i1 %38, i1 false
  br i1 %39, label %42, label %55

40:                                               ; preds = %28
  %41 = icmp sgt i64 %30, 1
  br i1 %41, label %42, label %55

42:                                               ; preds = %40, %34
  br label %43

43:                                               ; preds = %42, %43
  %44 = phi i64 [ %52, %43 ], [ %30, %42 ]
  %45 = phi i64 [ %51, %43 ], [ 0, %42 ]
  %46 = add nsw i64 %44, %45
  %47 = sdiv i64 %46, 2
  %48 = getelementptr inbounds double, ptr %25, i64 %47
  %49 = load double, ptr %48, align 8
  %50 = fcmp ugt double %49, %5
  %51 = select i1 %50, i64 %45, i64 %47
  %52 = select i1 %50, i64 %47, i64 %44
  %53 = sub nsw i64 %52, %51
  %54 = icmp sgt i64 %53, 1
  br i1 %54, label %43, label %55, !llvm.loop !36

55:                                               ; preds = %43, %40, %32, %34
  %56 = phi i64 [ 0, %34 ], [ 0, %32 ], [ 0, %40 ], [ %51, %43 ]
  %57 = add nsw i64 %56, 1
  br label %58

58:                                               ; preds = %18, %55
  %59 = phi i64 [ %57, %55 ], [ 0, %18 ]
  %60 = getelementptr inbounds i8, ptr %22, i64 16
  %61 = load i64, ptr %60, align 8
  %62 = icmp slt i64 %59, %61
  br i1 %62, label %63, label %68

63:                                               ; preds = %58
  %64 = getelementptr inbounds double, ptr %25, i64 %59
  %65 = load double, ptr %64, align 8
  %66 = fcmp olt double %65, %19
  br i1 %66, label %67, label %68

67:                                               ; preds = %63
  br label %68

68:                                               ; preds = %67, %63, %58
  %69 = phi double [ %65, %67 ], [ %19, %63 ], [ %19, %58 ]
  %70 = add nuw nsw i64 %20, 1
  %71 = icmp eq i64 %70, %7
  br i1 %71, label %16, label %18, !llvm.loop !43
}

define internal fastcc void @nested(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, i64 noundef %3, i64 noundef %4, ptr noundef readonly %5, i64 noundef %6) unnamed_addr #8 {
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
  br i1 %31, label %20, label %19, !llvm.loop !44

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
  br i1 %43, label %32, label %24, !llvm.loop !45
}

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #9

declare i64 @llvm.smin.i64(i64, i64) #9

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind willreturn memory(none) }
attributes #5 = { noinline nounwind }
attributes #6 = { nounwind willreturn }
attributes #7 = { noinline nounwind }
attributes #8 = { noinline nounwind }
attributes #9 = { nounwind willreturn memory(none) }
attributes #10 = { nounwind }
attributes #11 = { nounwind }
attributes #12 = { nounwind }


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
!45 = distinct !{!45, !4, !5}
