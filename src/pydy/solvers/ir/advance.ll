; sources b2b17f14bf27f8971eb33d0358b6fde33ee1ca7702eea35e136e03bee9996f34
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
  %85 = getelementptr inbounds i8, ptr %0, i64 312
  %86 = getelementptr inbounds i8, ptr %0, i64 320
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
  %97 = getelementptr inbounds i8, ptr %0, i64 312
  %98 = getelementptr inbounds i8, ptr %0, i64 320
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

170:                                              ; preds = %1755, %72
  %171 = load ptr, ptr %75, align 8
  %172 = load ptr, ptr %76, align 8
  %173 = load ptr, ptr %77, align 8
  %174 = getelementptr inbounds i8, ptr %173, i64 56
  %175 = load i64, ptr %174, align 8
  %176 = icmp eq i64 %175, 0
  br i1 %176, label %1740, label %177

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
  br i1 %207, label %208, label %454

208:                                              ; preds = %177
  %209 = load ptr, ptr %85, align 8
  %210 = load i64, ptr %86, align 8
  %211 = icmp eq i64 %210, 0
  br i1 %211, label %238, label %212

212:                                              ; preds = %208
  %213 = icmp sgt i64 %210, 0
  br i1 %213, label %214, label %227

214:                                              ; preds = %212, %214
  %215 = phi i64 [ %225, %214 ], [ %210, %212 ]
  %216 = phi i64 [ %224, %214 ], [ 0, %212 ]
  %217 = add nuw nsw i64 %215, %216
  %218 = lshr i64 %217, 1
  %219 = and i64 %217, -2
  %220 = getelementptr inbounds double, ptr %209, i64 %219
  %221 = load double, ptr %220, align 8
  %222 = fcmp ogt double %221, %203
  %223 = add nuw nsw i64 %218, 1
  %224 = select i1 %222, i64 %216, i64 %223
  %225 = select i1 %222, i64 %218, i64 %215
  %226 = icmp slt i64 %224, %225
  br i1 %226, label %214, label %227, !llvm.loop !8

227:                                              ; preds = %214, %212
  %228 = phi i64 [ 0, %212 ], [ %224, %214 ]
  %229 = icmp slt i64 %228, %210
  br i1 %229, label %230, label %235

230:                                              ; preds = %227
  %231 = shl nuw nsw i64 %228, 1
  %232 = or disjoint i64 %231, 1
  %233 = getelementptr inbounds double, ptr %209, i64 %232
  %234 = load double, ptr %233, align 8
  br label %235

235:                                              ; preds = %230, %227
  %236 = phi double [ %234, %230 ], [ 0x7FF0000000000000, %227 ]
  %237 = load ptr, ptr %87, align 8
  store double %236, ptr %237, align 8
  br label %238

238:                                              ; preds = %235, %208
  %239 = getelementptr inbounds i8, ptr %173, i64 24
  %240 = load i64, ptr %239, align 8
  %241 = add nsw i64 %240, 1
  store i64 %241, ptr %239, align 8
  %242 = load ptr, ptr %74, align 8
  %243 = load ptr, ptr %84, align 8
  %244 = load ptr, ptr %88, align 8
  store double %203, ptr %244, align 8
  %245 = load i64, ptr %89, align 8
  %246 = icmp sgt i64 %245, 0
  br i1 %246, label %247, label %248

247:                                              ; preds = %238
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %248

248:                                              ; preds = %238, %247
  %249 = load ptr, ptr %73, align 8
  %250 = load i64, ptr %249, align 8
  %251 = load ptr, ptr %88, align 8
  %252 = load ptr, ptr %90, align 8
  %253 = load ptr, ptr %91, align 8
  %254 = inttoptr i64 %250 to ptr
  %255 = load ptr, ptr %254, align 8
  %256 = tail call i32 %255(ptr noundef %251, ptr noundef %242, ptr noundef %252, ptr noundef %253, ptr noundef %243) #9
  %257 = icmp eq i32 %256, 0
  br i1 %257, label %262, label %258

258:                                              ; preds = %248
  %259 = getelementptr inbounds i8, ptr %173, i64 72
  store i64 3, ptr %259, align 8
  %260 = icmp slt i32 %256, 0
  %261 = select i1 %260, i64 -4, i64 2
  br label %1740

262:                                              ; preds = %248
  store i64 1, ptr %173, align 8
  %263 = getelementptr inbounds i8, ptr %171, i64 24
  store double 1.000000e-04, ptr %263, align 8
  %264 = getelementptr inbounds i8, ptr %179, i64 40
  %265 = load double, ptr %264, align 8
  %266 = getelementptr inbounds i8, ptr %171, i64 40
  store double %265, ptr %266, align 8
  %267 = load ptr, ptr %74, align 8
  %268 = load ptr, ptr %73, align 8
  %269 = getelementptr inbounds i8, ptr %268, i64 8
  %270 = load i64, ptr %269, align 8
  %271 = load i64, ptr %83, align 8
  %272 = load ptr, ptr %78, align 8
  %273 = load ptr, ptr %77, align 8
  %274 = getelementptr inbounds i8, ptr %273, i64 48
  %275 = load i64, ptr %274, align 8
  %276 = icmp slt i64 %275, %271
  br i1 %276, label %277, label %300

277:                                              ; preds = %262
  %278 = icmp sgt i64 %270, 0
  br label %279

279:                                              ; preds = %277, %290
  %280 = phi i64 [ %275, %277 ], [ %291, %290 ]
  %281 = getelementptr inbounds double, ptr %272, i64 %280
  %282 = load double, ptr %281, align 8
  %283 = load ptr, ptr %75, align 8
  %284 = load double, ptr %283, align 8
  %285 = fcmp ugt double %282, %284
  br i1 %285, label %300, label %286

286:                                              ; preds = %279
  br i1 %278, label %287, label %290

287:                                              ; preds = %286
  %288 = mul nsw i64 %280, %270
  %289 = getelementptr double, ptr %1, i64 %288
  br label %293

290:                                              ; preds = %293, %286
  %291 = add i64 %280, 1
  %292 = icmp eq i64 %291, %271
  br i1 %292, label %300, label %279, !llvm.loop !9

293:                                              ; preds = %287, %293
  %294 = phi i64 [ 0, %287 ], [ %298, %293 ]
  %295 = getelementptr inbounds double, ptr %267, i64 %294
  %296 = load double, ptr %295, align 8
  %297 = getelementptr double, ptr %289, i64 %294
  store double %296, ptr %297, align 8
  %298 = add nuw nsw i64 %294, 1
  %299 = icmp eq i64 %298, %270
  br i1 %299, label %290, label %293, !llvm.loop !10

300:                                              ; preds = %279, %290, %262
  %301 = phi i64 [ %275, %262 ], [ %280, %279 ], [ %271, %290 ]
  %302 = load ptr, ptr %77, align 8
  %303 = getelementptr inbounds i8, ptr %302, i64 48
  store i64 %301, ptr %303, align 8
  %304 = icmp eq i64 %301, %271
  br i1 %304, label %1740, label %305

305:                                              ; preds = %300
  %306 = fcmp oeq double %205, 0.000000e+00
  br i1 %306, label %307, label %454

307:                                              ; preds = %305
  %308 = load ptr, ptr %73, align 8
  %309 = getelementptr inbounds i8, ptr %308, i64 24
  %310 = load i64, ptr %309, align 8
  %311 = load ptr, ptr %75, align 8
  %312 = getelementptr inbounds i8, ptr %311, i64 16
  %313 = load double, ptr %312, align 8
  %314 = load ptr, ptr %74, align 8
  call fastcc void @norm_to(ptr noundef nonnull %4, ptr noundef %314, ptr noundef %314, ptr noundef nonnull %74, i64 noundef %310) #8
  %315 = load double, ptr %4, align 8
  %316 = load ptr, ptr %92, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %316, ptr noundef %314, ptr noundef nonnull %74, i64 noundef %310) #8
  %317 = load double, ptr %5, align 8
  %318 = fcmp uge double %315, 1.000000e-05
  %319 = fcmp uge double %317, 1.000000e-05
  %320 = and i1 %318, %319
  %321 = fmul double %315, 1.000000e-02
  %322 = fdiv double %321, %317
  %323 = select i1 %320, double %322, double 0x3EB0C6F7A0B5ED8D
  %324 = fcmp olt double %313, %323
  %325 = select i1 %324, double %313, double %323
  %326 = load ptr, ptr %73, align 8
  %327 = getelementptr inbounds i8, ptr %326, i64 8
  %328 = load i64, ptr %327, align 8
  %329 = icmp sgt i64 %328, 0
  br i1 %329, label %354, label %330

330:                                              ; preds = %354, %307
  %331 = load ptr, ptr %77, align 8
  %332 = getelementptr inbounds i8, ptr %331, i64 24
  %333 = load i64, ptr %332, align 8
  %334 = add nsw i64 %333, 1
  store i64 %334, ptr %332, align 8
  %335 = fadd double %203, %325
  %336 = load ptr, ptr %94, align 8
  %337 = load ptr, ptr %84, align 8
  %338 = load i64, ptr %80, align 8
  %339 = getelementptr inbounds double, ptr %337, i64 %338
  %340 = load ptr, ptr %88, align 8
  store double %335, ptr %340, align 8
  %341 = load i64, ptr %89, align 8
  %342 = icmp sgt i64 %341, 0
  br i1 %342, label %343, label %344

343:                                              ; preds = %330
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %344

344:                                              ; preds = %330, %343
  %345 = load ptr, ptr %73, align 8
  %346 = load i64, ptr %345, align 8
  %347 = load ptr, ptr %88, align 8
  %348 = load ptr, ptr %90, align 8
  %349 = load ptr, ptr %91, align 8
  %350 = inttoptr i64 %346 to ptr
  %351 = load ptr, ptr %350, align 8
  %352 = tail call i32 %351(ptr noundef %347, ptr noundef %336, ptr noundef %348, ptr noundef %349, ptr noundef %339) #9
  %353 = icmp eq i32 %352, 0
  br i1 %353, label %373, label %371

354:                                              ; preds = %307, %354
  %355 = phi i64 [ %366, %354 ], [ 0, %307 ]
  %356 = load ptr, ptr %74, align 8
  %357 = getelementptr inbounds double, ptr %356, i64 %355
  %358 = load double, ptr %357, align 8
  %359 = load ptr, ptr %84, align 8
  %360 = getelementptr inbounds double, ptr %359, i64 %355
  %361 = load double, ptr %360, align 8
  %362 = fmul double %325, %361
  %363 = fadd double %358, %362
  %364 = load ptr, ptr %93, align 8
  %365 = getelementptr inbounds double, ptr %364, i64 %355
  store double %363, ptr %365, align 8
  %366 = add nuw nsw i64 %355, 1
  %367 = load ptr, ptr %73, align 8
  %368 = getelementptr inbounds i8, ptr %367, i64 8
  %369 = load i64, ptr %368, align 8
  %370 = icmp slt i64 %366, %369
  br i1 %370, label %354, label %330, !llvm.loop !11

371:                                              ; preds = %344
  %372 = fmul double %325, 1.000000e-03
  br label %449

373:                                              ; preds = %344
  %374 = load ptr, ptr %79, align 8
  %375 = load double, ptr %374, align 8
  %376 = load ptr, ptr %92, align 8
  %377 = load i64, ptr %95, align 8
  %378 = getelementptr inbounds double, ptr %376, i64 %377
  %379 = icmp sgt i64 %310, 0
  br i1 %379, label %380, label %389

380:                                              ; preds = %373, %380
  %381 = phi i64 [ %387, %380 ], [ 0, %373 ]
  %382 = getelementptr inbounds double, ptr %378, i64 %381
  %383 = load double, ptr %382, align 8
  %384 = getelementptr inbounds double, ptr %376, i64 %381
  %385 = load double, ptr %384, align 8
  %386 = fsub double %383, %385
  store double %386, ptr %382, align 8
  %387 = add nuw nsw i64 %381, 1
  %388 = icmp eq i64 %387, %310
  br i1 %388, label %389, label %380, !llvm.loop !12

389:                                              ; preds = %380, %373
  %390 = load ptr, ptr %74, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %378, ptr noundef %390, ptr noundef nonnull %74, i64 noundef %310) #8
  %391 = load double, ptr %6, align 8
  %392 = fdiv double %391, %325
  %393 = fcmp ogt double %317, %392
  %394 = select i1 %393, double %317, double %392
  %395 = fcmp ule double %394, 1.000000e-15
  %396 = fdiv double 1.000000e-02, %394
  %397 = select i1 %395, double 1.000000e+13, double %396
  %398 = bitcast double %397 to i64
  %399 = add nsw i64 %398, -4604544271217802189
  %400 = ashr i64 %399, 52
  %401 = and i64 %399, -4503599627370496
  %402 = sub nsw i64 %398, %401
  %403 = bitcast i64 %402 to double
  %404 = fadd double %403, -1.000000e+00
  %405 = fadd double %403, 1.000000e+00
  %406 = fdiv double %404, %405
  %407 = fmul double %406, %406
  %408 = tail call double @llvm.fma.f64(double %407, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %409 = tail call double @llvm.fma.f64(double %408, double %407, double 0x3FE2776C50EF9BFE)
  %410 = tail call double @llvm.fma.f64(double %409, double %407, double 0x3FEEC709DC3A03FD)
  %411 = tail call double @llvm.fma.f64(double %410, double %407, double 0x40071547652B82FE)
  %412 = trunc nsw i64 %400 to i32
  %413 = sitofp i32 %412 to double
  %414 = fmul double %406, %411
  %415 = fadd double %414, %413
  %416 = fmul double %375, %415
  %417 = fcmp ogt double %416, -1.000000e+03
  %418 = select i1 %417, double %416, double -1.000000e+03
  %419 = fcmp olt double %418, 1.000000e+03
  %420 = select i1 %419, double %418, double 1.000000e+03
  %421 = tail call double @llvm.rint.f64(double %420)
  %422 = fsub double %420, %421
  %423 = tail call double @llvm.fma.f64(double %422, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %424 = tail call double @llvm.fma.f64(double %423, double %422, double 0x3F55D87FE78A6730)
  %425 = tail call double @llvm.fma.f64(double %424, double %422, double 0x3F83B2AB6FBA4E77)
  %426 = tail call double @llvm.fma.f64(double %425, double %422, double 0x3FAC6B08D704A0BF)
  %427 = tail call double @llvm.fma.f64(double %426, double %422, double 0x3FCEBFBDFF82C58E)
  %428 = tail call double @llvm.fma.f64(double %427, double %422, double 0x3FE62E42FEFA39EF)
  %429 = tail call double @llvm.fma.f64(double %428, double %422, double 1.000000e+00)
  %430 = bitcast double %429 to i64
  %431 = fptosi double %421 to i32
  %432 = sext i32 %431 to i64
  %433 = shl nsw i64 %432, 52
  %434 = add nsw i64 %433, %430
  %435 = bitcast i64 %434 to double
  %436 = fmul double %325, 1.000000e-03
  %437 = fcmp olt double %436, 0x3EB0C6F7A0B5ED8D
  %438 = select i1 %437, double 0x3EB0C6F7A0B5ED8D, double %436
  %439 = fmul double %325, 1.000000e+02
  %440 = select i1 %395, double %438, double %435
  %441 = fcmp olt double %439, %440
  %442 = select i1 %441, double %439, double %440
  %443 = tail call double @llvm.fabs.f64(double %203)
  %444 = fmul double %443, 0x3D30000000000000
  %445 = fcmp ogt double %444, %442
  %446 = select i1 %445, double %444, double %442
  %447 = fcmp olt double %313, %446
  %448 = select i1 %447, double %313, double %446
  br label %449

449:                                              ; preds = %371, %389
  %450 = phi double [ %372, %371 ], [ %448, %389 ]
  %451 = tail call i1 @llvm.is.fpclass.f64(double %450, i32 639)
  br i1 %451, label %452, label %454

452:                                              ; preds = %449
  %453 = getelementptr inbounds i8, ptr %173, i64 72
  store i64 4, ptr %453, align 8
  br label %454

454:                                              ; preds = %452, %449, %305, %177
  %455 = phi double [ %450, %449 ], [ %450, %452 ], [ %205, %305 ], [ %205, %177 ]
  %456 = load i64, ptr %174, align 8
  %457 = icmp eq i64 %456, 0
  br i1 %457, label %486, label %458

458:                                              ; preds = %454
  %459 = getelementptr inbounds i8, ptr %173, i64 8
  %460 = getelementptr inbounds i8, ptr %173, i64 16
  %461 = getelementptr inbounds i8, ptr %173, i64 64
  %462 = getelementptr inbounds i8, ptr %173, i64 48
  %463 = getelementptr inbounds i8, ptr %171, i64 16
  %464 = getelementptr inbounds i8, ptr %173, i64 24
  %465 = icmp sgt i64 %181, 0
  %466 = select i1 %184, i1 %190, i1 false
  %467 = getelementptr inbounds i8, ptr %171, i64 32
  %468 = getelementptr inbounds i8, ptr %173, i64 48
  %469 = getelementptr inbounds i8, ptr %173, i64 72
  %470 = getelementptr inbounds i8, ptr %171, i64 24
  %471 = getelementptr inbounds i8, ptr %171, i64 40
  %472 = getelementptr inbounds i8, ptr %179, i64 24
  %473 = getelementptr inbounds i8, ptr %179, i64 8
  %474 = getelementptr inbounds i8, ptr %179, i64 16
  %475 = getelementptr inbounds i8, ptr %179, i64 32
  %476 = getelementptr inbounds i8, ptr %179, i64 40
  %477 = icmp sgt i64 %181, 0
  %478 = getelementptr inbounds i8, ptr %173, i64 48
  %479 = getelementptr inbounds i8, ptr %173, i64 72
  %480 = getelementptr inbounds i8, ptr %173, i64 72
  %481 = getelementptr inbounds i8, ptr %171, i64 40
  %482 = getelementptr inbounds i8, ptr %173, i64 72
  %483 = getelementptr inbounds i8, ptr %179, i64 24
  %484 = getelementptr inbounds i8, ptr %179, i64 32
  %485 = getelementptr inbounds i8, ptr %171, i64 40
  br label %488

486:                                              ; preds = %1737, %454
  %487 = phi double [ %455, %454 ], [ %1733, %1737 ]
  store double %487, ptr %204, align 8
  br label %1740

488:                                              ; preds = %458, %1737
  %489 = phi i64 [ %456, %458 ], [ %1738, %1737 ]
  %490 = phi i64 [ undef, %458 ], [ %1736, %1737 ]
  %491 = phi double [ %203, %458 ], [ %1734, %1737 ]
  %492 = phi double [ %455, %458 ], [ %1733, %1737 ]
  %493 = load ptr, ptr %96, align 8
  %494 = getelementptr inbounds i8, ptr %493, i64 8
  %495 = load i64, ptr %494, align 8
  %496 = icmp sgt i64 %495, 0
  br i1 %496, label %497, label %502

497:                                              ; preds = %488
  %498 = load i64, ptr %493, align 8
  %499 = add nsw i64 %498, 3
  %500 = icmp slt i64 %495, %499
  %501 = zext i1 %500 to i32
  br label %502

502:                                              ; preds = %488, %497
  %503 = phi i32 [ 0, %488 ], [ %501, %497 ]
  %504 = icmp eq i32 %503, 0
  br i1 %504, label %506, label %505

505:                                              ; preds = %502
  store double %492, ptr %204, align 8
  br label %1740

506:                                              ; preds = %502
  %507 = add nsw i64 %489, -1
  store i64 %507, ptr %174, align 8
  %508 = load i64, ptr %459, align 8
  %509 = load i64, ptr %460, align 8
  %510 = add nsw i64 %509, %508
  %511 = load i64, ptr %461, align 8
  %512 = icmp slt i64 %510, %511
  br i1 %512, label %514, label %513

513:                                              ; preds = %506
  store double %492, ptr %204, align 8
  br label %1740

514:                                              ; preds = %506
  %515 = load ptr, ptr %97, align 8
  %516 = load i64, ptr %98, align 8
  %517 = icmp eq i64 %516, 0
  br i1 %517, label %550, label %518

518:                                              ; preds = %514
  %519 = icmp sgt i64 %516, 0
  br i1 %519, label %520, label %533

520:                                              ; preds = %518, %520
  %521 = phi i64 [ %531, %520 ], [ %516, %518 ]
  %522 = phi i64 [ %530, %520 ], [ 0, %518 ]
  %523 = add nuw nsw i64 %521, %522
  %524 = lshr i64 %523, 1
  %525 = and i64 %523, -2
  %526 = getelementptr inbounds double, ptr %515, i64 %525
  %527 = load double, ptr %526, align 8
  %528 = fcmp ogt double %527, %491
  %529 = add nuw nsw i64 %524, 1
  %530 = select i1 %528, i64 %522, i64 %529
  %531 = select i1 %528, i64 %524, i64 %521
  %532 = icmp slt i64 %530, %531
  br i1 %532, label %520, label %533, !llvm.loop !8

533:                                              ; preds = %520, %518
  %534 = phi i64 [ 0, %518 ], [ %530, %520 ]
  %535 = icmp slt i64 %534, %516
  br i1 %535, label %536, label %541

536:                                              ; preds = %533
  %537 = shl nuw nsw i64 %534, 1
  %538 = or disjoint i64 %537, 1
  %539 = getelementptr inbounds double, ptr %515, i64 %538
  %540 = load double, ptr %539, align 8
  br label %541

541:                                              ; preds = %536, %533
  %542 = phi double [ %540, %536 ], [ 0x7FF0000000000000, %533 ]
  %543 = load ptr, ptr %99, align 8
  store double %542, ptr %543, align 8
  %544 = load i64, ptr %98, align 8
  %545 = icmp slt i64 %534, %544
  br i1 %545, label %546, label %550

546:                                              ; preds = %541
  %547 = shl nsw i64 %534, 4
  %548 = getelementptr inbounds i8, ptr %515, i64 %547
  %549 = load double, ptr %548, align 8
  br label %550

550:                                              ; preds = %514, %541, %546
  %551 = phi double [ 0x7FF0000000000000, %514 ], [ %549, %546 ], [ 0x7FF0000000000000, %541 ]
  br i1 %187, label %552, label %556

552:                                              ; preds = %550
  %553 = load i64, ptr %462, align 8
  %554 = getelementptr inbounds double, ptr %178, i64 %553
  %555 = load double, ptr %554, align 8
  br label %556

556:                                              ; preds = %552, %550
  %557 = phi double [ %555, %552 ], [ %198, %550 ]
  %558 = fcmp olt double %557, %551
  %559 = select i1 %558, double %557, double %551
  br i1 %187, label %564, label %560

560:                                              ; preds = %556
  %561 = load double, ptr %463, align 8
  %562 = fcmp olt double %492, %561
  %563 = select i1 %562, double %492, double %561
  br label %570

564:                                              ; preds = %556
  %565 = fsub double %559, %491
  %566 = fdiv double %565, %492
  %567 = fmul double %566, 0x3FEFFFFFFFFFDCD1
  %568 = tail call double @llvm.ceil.f64(double %567)
  %569 = fdiv double %565, %568
  br label %570

570:                                              ; preds = %564, %560
  %571 = phi double [ %563, %560 ], [ %569, %564 ]
  %572 = fadd double %491, %571
  %573 = fmul double %571, 1.000000e-03
  %574 = fsub double %559, %573
  %575 = fcmp ule double %572, %574
  %576 = select i1 %575, double %572, double %559
  %577 = fsub double %576, %491
  %578 = fmul double %577, 6.250000e-02
  %579 = fadd double %491, %578
  %580 = fcmp ule double %579, %491
  %581 = fcmp une double %576, %559
  %582 = and i1 %581, %580
  br i1 %582, label %583, label %584

583:                                              ; preds = %570
  store double %577, ptr %204, align 8
  br label %1732

584:                                              ; preds = %570
  %585 = load ptr, ptr %0, align 8
  %586 = load i64, ptr %585, align 8
  %587 = load ptr, ptr %100, align 8
  %588 = insertelement <8 x double> poison, double %577, i64 0
  %589 = shufflevector <8 x double> %588, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %589, ptr %587, align 8
  %590 = icmp sgt i64 %586, 1
  br i1 %590, label %595, label %680

591:                                              ; preds = %668
  %592 = add nuw nsw i64 %598, 1
  %593 = icmp slt i64 %592, %586
  %594 = icmp eq i64 %592, %586
  br i1 %594, label %680, label %595, !llvm.loop !13

595:                                              ; preds = %584, %591
  %596 = phi i1 [ %593, %591 ], [ %590, %584 ]
  %597 = phi i64 [ %679, %591 ], [ undef, %584 ]
  %598 = phi i64 [ %592, %591 ], [ 1, %584 ]
  %599 = load ptr, ptr %101, align 8
  %600 = load ptr, ptr %74, align 8
  %601 = load ptr, ptr %73, align 8
  %602 = getelementptr inbounds i8, ptr %601, i64 16
  %603 = load i64, ptr %602, align 8
  %604 = icmp sgt i64 %603, 1
  %605 = zext i1 %604 to i64
  %606 = load ptr, ptr %102, align 8
  %607 = getelementptr inbounds i64, ptr %606, i64 %598
  %608 = load i64, ptr %607, align 8
  %609 = getelementptr i8, ptr %607, i64 8
  %610 = load i64, ptr %609, align 8
  %611 = xor i64 %608, -1
  %612 = add i64 %610, %611
  %613 = load ptr, ptr %100, align 8
  %614 = load ptr, ptr %103, align 8
  %615 = load ptr, ptr %104, align 8
  %616 = getelementptr inbounds i64, ptr %615, i64 %608
  %617 = load ptr, ptr %105, align 8
  %618 = getelementptr inbounds double, ptr %617, i64 %608
  tail call fastcc void @combine(ptr noundef %599, ptr noundef %600, ptr noundef %613, ptr noundef %614, ptr noundef %616, ptr noundef %618, i64 noundef %612, i64 noundef %605, i64 noundef %603) #8
  %619 = icmp eq i64 %603, 1
  br i1 %619, label %620, label %651

620:                                              ; preds = %595
  %621 = load ptr, ptr %102, align 8
  %622 = getelementptr i64, ptr %621, i64 %598
  %623 = getelementptr i8, ptr %622, i64 8
  %624 = load i64, ptr %623, align 8
  %625 = add nsw i64 %624, -1
  %626 = load ptr, ptr %105, align 8
  %627 = getelementptr inbounds double, ptr %626, i64 %625
  %628 = load double, ptr %627, align 8
  %629 = fmul double %577, %628
  %630 = load ptr, ptr %103, align 8
  %631 = load ptr, ptr %104, align 8
  %632 = getelementptr inbounds i64, ptr %631, i64 %625
  %633 = load i64, ptr %632, align 8
  %634 = getelementptr inbounds double, ptr %630, i64 %633
  %635 = load ptr, ptr %73, align 8
  %636 = getelementptr inbounds i8, ptr %635, i64 8
  %637 = load i64, ptr %636, align 8
  %638 = icmp sgt i64 %637, 0
  br i1 %638, label %639, label %651

639:                                              ; preds = %620, %639
  %640 = phi i64 [ %646, %639 ], [ 0, %620 ]
  %641 = getelementptr inbounds double, ptr %634, i64 %640
  %642 = load double, ptr %641, align 8
  %643 = getelementptr inbounds double, ptr %599, i64 %640
  %644 = load double, ptr %643, align 8
  %645 = tail call double @llvm.fma.f64(double %629, double %642, double %644)
  store double %645, ptr %643, align 8
  %646 = add nuw nsw i64 %640, 1
  %647 = load ptr, ptr %73, align 8
  %648 = getelementptr inbounds i8, ptr %647, i64 8
  %649 = load i64, ptr %648, align 8
  %650 = icmp slt i64 %646, %649
  br i1 %650, label %639, label %651, !llvm.loop !14

651:                                              ; preds = %639, %620, %595
  %652 = load ptr, ptr %103, align 8
  %653 = load i64, ptr %106, align 8
  %654 = mul nsw i64 %653, %598
  %655 = getelementptr inbounds double, ptr %652, i64 %654
  %656 = load i64, ptr %464, align 8
  %657 = add nsw i64 %656, 1
  store i64 %657, ptr %464, align 8
  %658 = load ptr, ptr %107, align 8
  %659 = getelementptr inbounds double, ptr %658, i64 %598
  %660 = load double, ptr %659, align 8
  %661 = fmul double %577, %660
  %662 = fadd double %491, %661
  %663 = load ptr, ptr %101, align 8
  %664 = load ptr, ptr %108, align 8
  store double %662, ptr %664, align 8
  %665 = load i64, ptr %109, align 8
  %666 = icmp sgt i64 %665, 0
  br i1 %666, label %667, label %668

667:                                              ; preds = %651
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %668

668:                                              ; preds = %651, %667
  %669 = load ptr, ptr %73, align 8
  %670 = load i64, ptr %669, align 8
  %671 = load ptr, ptr %108, align 8
  %672 = load ptr, ptr %110, align 8
  %673 = load ptr, ptr %111, align 8
  %674 = inttoptr i64 %670 to ptr
  %675 = load ptr, ptr %674, align 8
  %676 = tail call i32 %675(ptr noundef %671, ptr noundef %663, ptr noundef %672, ptr noundef %673, ptr noundef %655) #9
  %677 = sext i32 %676 to i64
  %678 = icmp eq i32 %676, 0
  %679 = select i1 %678, i64 %597, i64 %677
  br i1 %678, label %591, label %680

680:                                              ; preds = %591, %668, %584
  %681 = phi i1 [ %590, %584 ], [ %593, %591 ], [ %596, %668 ]
  %682 = phi i64 [ 0, %584 ], [ %677, %668 ], [ %677, %591 ]
  %683 = phi i64 [ undef, %584 ], [ %679, %668 ], [ %679, %591 ]
  br i1 %681, label %737, label %684

684:                                              ; preds = %680
  %685 = load ptr, ptr %112, align 8
  %686 = load ptr, ptr %74, align 8
  %687 = load ptr, ptr %73, align 8
  %688 = getelementptr inbounds i8, ptr %687, i64 16
  %689 = load i64, ptr %688, align 8
  %690 = icmp sgt i64 %689, 1
  %691 = zext i1 %690 to i64
  %692 = load ptr, ptr %113, align 8
  %693 = getelementptr inbounds i64, ptr %692, i64 %586
  %694 = load i64, ptr %693, align 8
  %695 = getelementptr i8, ptr %693, i64 8
  %696 = load i64, ptr %695, align 8
  %697 = xor i64 %694, -1
  %698 = add i64 %696, %697
  %699 = load ptr, ptr %100, align 8
  %700 = load ptr, ptr %114, align 8
  %701 = load ptr, ptr %115, align 8
  %702 = getelementptr inbounds i64, ptr %701, i64 %694
  %703 = load ptr, ptr %116, align 8
  %704 = getelementptr inbounds double, ptr %703, i64 %694
  tail call fastcc void @combine(ptr noundef %685, ptr noundef %686, ptr noundef %699, ptr noundef %700, ptr noundef %702, ptr noundef %704, i64 noundef %698, i64 noundef %691, i64 noundef %689) #8
  %705 = icmp eq i64 %689, 1
  br i1 %705, label %706, label %737

706:                                              ; preds = %684
  %707 = load ptr, ptr %113, align 8
  %708 = getelementptr i64, ptr %707, i64 %586
  %709 = getelementptr i8, ptr %708, i64 8
  %710 = load i64, ptr %709, align 8
  %711 = add nsw i64 %710, -1
  %712 = load ptr, ptr %116, align 8
  %713 = getelementptr inbounds double, ptr %712, i64 %711
  %714 = load double, ptr %713, align 8
  %715 = fmul double %577, %714
  %716 = load ptr, ptr %114, align 8
  %717 = load ptr, ptr %115, align 8
  %718 = getelementptr inbounds i64, ptr %717, i64 %711
  %719 = load i64, ptr %718, align 8
  %720 = getelementptr inbounds double, ptr %716, i64 %719
  %721 = load ptr, ptr %73, align 8
  %722 = getelementptr inbounds i8, ptr %721, i64 8
  %723 = load i64, ptr %722, align 8
  %724 = icmp sgt i64 %723, 0
  br i1 %724, label %725, label %737

725:                                              ; preds = %706, %725
  %726 = phi i64 [ %732, %725 ], [ 0, %706 ]
  %727 = getelementptr inbounds double, ptr %720, i64 %726
  %728 = load double, ptr %727, align 8
  %729 = getelementptr inbounds double, ptr %685, i64 %726
  %730 = load double, ptr %729, align 8
  %731 = tail call double @llvm.fma.f64(double %715, double %728, double %730)
  store double %731, ptr %729, align 8
  %732 = add nuw nsw i64 %726, 1
  %733 = load ptr, ptr %73, align 8
  %734 = getelementptr inbounds i8, ptr %733, i64 8
  %735 = load i64, ptr %734, align 8
  %736 = icmp slt i64 %732, %735
  br i1 %736, label %725, label %737, !llvm.loop !14

737:                                              ; preds = %725, %706, %684, %680
  %738 = phi i64 [ %683, %680 ], [ %682, %684 ], [ %682, %706 ], [ %682, %725 ]
  %739 = icmp eq i64 %738, 0
  %740 = select i1 %739, i1 %190, i1 false
  br i1 %740, label %741, label %758

741:                                              ; preds = %737
  %742 = load i64, ptr %464, align 8
  %743 = add nsw i64 %742, 1
  store i64 %743, ptr %464, align 8
  %744 = load ptr, ptr %117, align 8
  store double %576, ptr %744, align 8
  %745 = load i64, ptr %118, align 8
  %746 = icmp sgt i64 %745, 0
  br i1 %746, label %747, label %748

747:                                              ; preds = %741
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %748

748:                                              ; preds = %741, %747
  %749 = load ptr, ptr %73, align 8
  %750 = load i64, ptr %749, align 8
  %751 = load ptr, ptr %117, align 8
  %752 = load ptr, ptr %119, align 8
  %753 = load ptr, ptr %120, align 8
  %754 = inttoptr i64 %750 to ptr
  %755 = load ptr, ptr %754, align 8
  %756 = tail call i32 %755(ptr noundef %751, ptr noundef %172, ptr noundef %752, ptr noundef %753, ptr noundef %202) #9
  %757 = sext i32 %756 to i64
  br label %758

758:                                              ; preds = %748, %737
  %759 = phi i64 [ %757, %748 ], [ %738, %737 ]
  %760 = icmp slt i64 %759, 0
  br i1 %760, label %1732, label %761

761:                                              ; preds = %758
  %762 = icmp eq i64 %759, 0
  br i1 %762, label %763, label %959

763:                                              ; preds = %761
  br i1 %187, label %764, label %765

764:                                              ; preds = %763
  br i1 %465, label %914, label %923

765:                                              ; preds = %763
  %766 = load ptr, ptr %73, align 8
  %767 = load ptr, ptr %0, align 8
  %768 = getelementptr inbounds i8, ptr %766, i64 24
  %769 = load i64, ptr %768, align 8
  %770 = getelementptr inbounds i8, ptr %767, i64 8
  %771 = load i64, ptr %770, align 8
  %772 = load ptr, ptr %121, align 8
  %773 = load i64, ptr %122, align 8
  %774 = getelementptr inbounds double, ptr %772, i64 %773
  %775 = icmp sgt i64 %771, 0
  br i1 %775, label %776, label %778

776:                                              ; preds = %765
  %777 = getelementptr inbounds i8, ptr %766, i64 32
  br label %786

778:                                              ; preds = %786, %765
  %779 = icmp sgt i64 %769, 0
  br i1 %779, label %780, label %812

780:                                              ; preds = %778
  %781 = load ptr, ptr %74, align 8
  %782 = load ptr, ptr %128, align 8
  %783 = load ptr, ptr %129, align 8
  %784 = load ptr, ptr %130, align 8
  %785 = load ptr, ptr %121, align 8
  br label %870

786:                                              ; preds = %776, %786
  %787 = phi i64 [ 0, %776 ], [ %810, %786 ]
  %788 = load i64, ptr %767, align 8
  %789 = load i64, ptr %777, align 8
  %790 = load ptr, ptr %121, align 8
  %791 = load i64, ptr %122, align 8
  %792 = mul nsw i64 %791, %787
  %793 = getelementptr inbounds double, ptr %790, i64 %792
  %794 = load ptr, ptr %123, align 8
  %795 = load ptr, ptr %124, align 8
  %796 = getelementptr i64, ptr %795, i64 %788
  %797 = getelementptr i8, ptr %796, i64 8
  %798 = getelementptr i64, ptr %797, i64 %787
  %799 = load i64, ptr %798, align 8
  %800 = getelementptr i8, ptr %798, i64 8
  %801 = load i64, ptr %800, align 8
  %802 = xor i64 %799, -1
  %803 = add i64 %801, %802
  %804 = load ptr, ptr %100, align 8
  %805 = load ptr, ptr %125, align 8
  %806 = load ptr, ptr %126, align 8
  %807 = getelementptr inbounds i64, ptr %806, i64 %799
  %808 = load ptr, ptr %127, align 8
  %809 = getelementptr inbounds double, ptr %808, i64 %799
  tail call fastcc void @combine(ptr noundef %793, ptr noundef %794, ptr noundef %804, ptr noundef %805, ptr noundef %807, ptr noundef %809, i64 noundef %803, i64 noundef 1, i64 noundef %789) #8
  %810 = add nuw nsw i64 %787, 1
  %811 = icmp eq i64 %810, %771
  br i1 %811, label %778, label %786, !llvm.loop !15

812:                                              ; preds = %870, %778
  %813 = phi double [ 0.000000e+00, %778 ], [ %898, %870 ]
  %814 = phi double [ 0.000000e+00, %778 ], [ %896, %870 ]
  %815 = load ptr, ptr %131, align 8
  %816 = getelementptr inbounds i8, ptr %766, i64 8
  %817 = load i64, ptr %816, align 8
  %818 = add nsw i64 %817, -3
  %819 = getelementptr i8, ptr %815, i64 8
  %820 = getelementptr i8, ptr %815, i64 16
  %821 = getelementptr i8, ptr %815, i64 24
  %822 = icmp slt i64 %769, %818
  br i1 %822, label %830, label %823

823:                                              ; preds = %830, %812
  %824 = phi double [ 0.000000e+00, %812 ], [ %839, %830 ]
  %825 = phi double [ 0.000000e+00, %812 ], [ %843, %830 ]
  %826 = phi double [ 0.000000e+00, %812 ], [ %847, %830 ]
  %827 = phi double [ 0.000000e+00, %812 ], [ %851, %830 ]
  %828 = phi i64 [ %769, %812 ], [ %852, %830 ]
  %829 = icmp slt i64 %828, %817
  br i1 %829, label %854, label %863

830:                                              ; preds = %812, %830
  %831 = phi i64 [ %852, %830 ], [ %769, %812 ]
  %832 = phi double [ %851, %830 ], [ 0.000000e+00, %812 ]
  %833 = phi double [ %847, %830 ], [ 0.000000e+00, %812 ]
  %834 = phi double [ %843, %830 ], [ 0.000000e+00, %812 ]
  %835 = phi double [ %839, %830 ], [ 0.000000e+00, %812 ]
  %836 = getelementptr inbounds double, ptr %815, i64 %831
  %837 = load double, ptr %836, align 8
  %838 = fmul double %837, 0.000000e+00
  %839 = fadd double %835, %838
  %840 = getelementptr double, ptr %819, i64 %831
  %841 = load double, ptr %840, align 8
  %842 = fmul double %841, 0.000000e+00
  %843 = fadd double %834, %842
  %844 = getelementptr double, ptr %820, i64 %831
  %845 = load double, ptr %844, align 8
  %846 = fmul double %845, 0.000000e+00
  %847 = fadd double %833, %846
  %848 = getelementptr double, ptr %821, i64 %831
  %849 = load double, ptr %848, align 8
  %850 = fmul double %849, 0.000000e+00
  %851 = fadd double %832, %850
  %852 = add nsw i64 %831, 4
  %853 = icmp slt i64 %852, %818
  br i1 %853, label %830, label %823, !llvm.loop !16

854:                                              ; preds = %823, %854
  %855 = phi i64 [ %861, %854 ], [ %828, %823 ]
  %856 = phi double [ %860, %854 ], [ %824, %823 ]
  %857 = getelementptr inbounds double, ptr %815, i64 %855
  %858 = load double, ptr %857, align 8
  %859 = fmul double %858, 0.000000e+00
  %860 = fadd double %856, %859
  %861 = add nsw i64 %855, 1
  %862 = icmp eq i64 %861, %817
  br i1 %862, label %863, label %854, !llvm.loop !17

863:                                              ; preds = %854, %823
  %864 = phi double [ %824, %823 ], [ %860, %854 ]
  %865 = fadd double %825, %864
  %866 = fadd double %826, %827
  %867 = fadd double %866, %865
  %868 = fadd double %814, %867
  %869 = icmp eq i64 %771, 2
  br i1 %869, label %901, label %910

870:                                              ; preds = %780, %870
  %871 = phi double [ 0.000000e+00, %780 ], [ %896, %870 ]
  %872 = phi double [ 0.000000e+00, %780 ], [ %898, %870 ]
  %873 = phi i64 [ 0, %780 ], [ %899, %870 ]
  %874 = getelementptr inbounds double, ptr %781, i64 %873
  %875 = load double, ptr %874, align 8
  %876 = getelementptr inbounds double, ptr %782, i64 %873
  %877 = load double, ptr %876, align 8
  %878 = getelementptr inbounds double, ptr %783, i64 %873
  %879 = load double, ptr %878, align 8
  %880 = getelementptr inbounds double, ptr %784, i64 %873
  %881 = load double, ptr %880, align 8
  %882 = tail call double @llvm.fabs.f64(double %875)
  %883 = tail call double @llvm.fabs.f64(double %877)
  %884 = fcmp ogt double %882, %883
  %885 = select i1 %884, double %882, double %883
  %886 = fmul double %885, %881
  %887 = fadd double %879, %886
  %888 = fdiv double 1.000000e+00, %887
  %889 = getelementptr inbounds double, ptr %785, i64 %873
  %890 = load double, ptr %889, align 8
  %891 = fmul double %890, %888
  %892 = getelementptr inbounds double, ptr %774, i64 %873
  %893 = load double, ptr %892, align 8
  %894 = fmul double %893, %888
  %895 = fmul double %891, %891
  %896 = fadd double %871, %895
  %897 = fmul double %894, %894
  %898 = fadd double %872, %897
  %899 = add nuw nsw i64 %873, 1
  %900 = icmp eq i64 %899, %769
  br i1 %900, label %812, label %870, !llvm.loop !18

901:                                              ; preds = %863
  %902 = fmul double %813, 1.000000e-02
  %903 = fadd double %902, %868
  %904 = sitofp i64 %769 to double
  %905 = fmul double %903, %904
  %906 = tail call double @llvm.sqrt.f64(double %905)
  %907 = fdiv double %868, %906
  %908 = fcmp une double %868, 0.000000e+00
  %909 = select i1 %908, double %907, double 0.000000e+00
  br label %923

910:                                              ; preds = %863
  %911 = sitofp i64 %769 to double
  %912 = fdiv double %868, %911
  %913 = tail call double @llvm.sqrt.f64(double %912)
  br label %923

914:                                              ; preds = %764, %914
  %915 = phi i64 [ %921, %914 ], [ 0, %764 ]
  %916 = phi double [ %920, %914 ], [ 0.000000e+00, %764 ]
  %917 = getelementptr inbounds double, ptr %172, i64 %915
  %918 = load double, ptr %917, align 8
  %919 = fmul double %918, 0.000000e+00
  %920 = fadd double %916, %919
  %921 = add nuw nsw i64 %915, 1
  %922 = icmp eq i64 %921, %181
  br i1 %922, label %923, label %914, !llvm.loop !19

923:                                              ; preds = %914, %764, %910, %901
  %924 = phi double [ %909, %901 ], [ %913, %910 ], [ 0.000000e+00, %764 ], [ %920, %914 ]
  %925 = fcmp uge double %924, 1.000000e+00
  %926 = select i1 %925, i1 true, i1 %466
  br i1 %926, label %959, label %927

927:                                              ; preds = %923
  br i1 %184, label %939, label %928

928:                                              ; preds = %927
  br i1 %187, label %931, label %929

929:                                              ; preds = %928
  %930 = load ptr, ptr %74, align 8
  br label %931

931:                                              ; preds = %929, %928
  %932 = phi ptr [ %930, %929 ], [ null, %928 ]
  %933 = load ptr, ptr %81, align 8
  %934 = getelementptr inbounds i8, ptr %933, i64 56
  %935 = load i64, ptr %934, align 8
  %936 = inttoptr i64 %935 to ptr
  %937 = tail call i64 %936(ptr noundef %0, double noundef %576, ptr noundef %172, ptr noundef %932) #9
  %938 = icmp ne i64 %937, 0
  br label %939

939:                                              ; preds = %931, %927
  %940 = phi i1 [ false, %927 ], [ %938, %931 ]
  br i1 %940, label %959, label %941

941:                                              ; preds = %939
  %942 = load i64, ptr %464, align 8
  %943 = add nsw i64 %942, 1
  store i64 %943, ptr %464, align 8
  %944 = load ptr, ptr %132, align 8
  store double %576, ptr %944, align 8
  %945 = load i64, ptr %133, align 8
  %946 = icmp sgt i64 %945, 0
  br i1 %946, label %947, label %948

947:                                              ; preds = %941
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %948

948:                                              ; preds = %941, %947
  %949 = load ptr, ptr %73, align 8
  %950 = load i64, ptr %949, align 8
  %951 = load ptr, ptr %132, align 8
  %952 = load ptr, ptr %134, align 8
  %953 = load ptr, ptr %135, align 8
  %954 = inttoptr i64 %950 to ptr
  %955 = load ptr, ptr %954, align 8
  %956 = tail call i32 %955(ptr noundef %951, ptr noundef %172, ptr noundef %952, ptr noundef %953, ptr noundef %202) #9
  %957 = sext i32 %956 to i64
  %958 = icmp slt i32 %956, 0
  br i1 %958, label %1732, label %959

959:                                              ; preds = %948, %939, %923, %761
  %960 = phi i64 [ 0, %939 ], [ %957, %948 ], [ 0, %923 ], [ %759, %761 ]
  %961 = phi double [ %924, %939 ], [ %924, %948 ], [ %924, %923 ], [ 0.000000e+00, %761 ]
  %962 = phi i1 [ %940, %939 ], [ %940, %948 ], [ false, %923 ], [ false, %761 ]
  %963 = icmp ne i64 %960, 0
  %964 = fcmp uge double %961, 1.000000e+00
  %965 = or i1 %963, %964
  %966 = or i1 %962, %965
  br i1 %966, label %967, label %1030

967:                                              ; preds = %959
  %968 = load i64, ptr %460, align 8
  %969 = add nsw i64 %968, 1
  store i64 %969, ptr %460, align 8
  %970 = or i1 %963, %962
  br i1 %970, label %974, label %971

971:                                              ; preds = %967
  %972 = tail call double @llvm.fabs.f64(double %961)
  %973 = fcmp one double %972, 0x7FF0000000000000
  br label %974

974:                                              ; preds = %971, %967
  %975 = phi i1 [ false, %967 ], [ %973, %971 ]
  %976 = select i1 %975, i64 2, i64 4
  %977 = select i1 %962, i64 6, i64 %976
  %978 = select i1 %963, i64 3, i64 %977
  store i64 %978, ptr %482, align 8
  %979 = fcmp ogt double %961, 1.000000e-10
  %980 = select i1 %979, double %961, double 1.000000e-10
  %981 = load double, ptr %483, align 8
  %982 = load double, ptr %179, align 8
  %983 = fneg double %982
  %984 = bitcast double %980 to i64
  %985 = add nsw i64 %984, -4604544271217802189
  %986 = ashr i64 %985, 52
  %987 = and i64 %985, -4503599627370496
  %988 = sub nsw i64 %984, %987
  %989 = bitcast i64 %988 to double
  %990 = fadd double %989, -1.000000e+00
  %991 = fadd double %989, 1.000000e+00
  %992 = fdiv double %990, %991
  %993 = fmul double %992, %992
  %994 = tail call double @llvm.fma.f64(double %993, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %995 = tail call double @llvm.fma.f64(double %994, double %993, double 0x3FE2776C50EF9BFE)
  %996 = tail call double @llvm.fma.f64(double %995, double %993, double 0x3FEEC709DC3A03FD)
  %997 = tail call double @llvm.fma.f64(double %996, double %993, double 0x40071547652B82FE)
  %998 = trunc nsw i64 %986 to i32
  %999 = sitofp i32 %998 to double
  %1000 = fmul double %992, %997
  %1001 = fadd double %1000, %999
  %1002 = fmul double %1001, %983
  %1003 = fcmp ogt double %1002, -1.000000e+03
  %1004 = select i1 %1003, double %1002, double -1.000000e+03
  %1005 = fcmp olt double %1004, 1.000000e+03
  %1006 = select i1 %1005, double %1004, double 1.000000e+03
  %1007 = tail call double @llvm.rint.f64(double %1006)
  %1008 = fsub double %1006, %1007
  %1009 = tail call double @llvm.fma.f64(double %1008, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1010 = tail call double @llvm.fma.f64(double %1009, double %1008, double 0x3F55D87FE78A6730)
  %1011 = tail call double @llvm.fma.f64(double %1010, double %1008, double 0x3F83B2AB6FBA4E77)
  %1012 = tail call double @llvm.fma.f64(double %1011, double %1008, double 0x3FAC6B08D704A0BF)
  %1013 = tail call double @llvm.fma.f64(double %1012, double %1008, double 0x3FCEBFBDFF82C58E)
  %1014 = tail call double @llvm.fma.f64(double %1013, double %1008, double 0x3FE62E42FEFA39EF)
  %1015 = tail call double @llvm.fma.f64(double %1014, double %1008, double 1.000000e+00)
  %1016 = bitcast double %1015 to i64
  %1017 = fptosi double %1007 to i32
  %1018 = sext i32 %1017 to i64
  %1019 = shl nsw i64 %1018, 52
  %1020 = add nsw i64 %1019, %1016
  %1021 = bitcast i64 %1020 to double
  %1022 = fmul double %981, %1021
  %1023 = load double, ptr %484, align 8
  %1024 = fcmp ogt double %1022, %1023
  %1025 = select i1 %1024, double %1022, double %1023
  %1026 = select i1 %975, double %1025, double 2.500000e-01
  %1027 = fmul double %577, %1026
  br i1 %187, label %1028, label %1029

1028:                                             ; preds = %974
  store double %577, ptr %204, align 8
  br label %1732

1029:                                             ; preds = %974
  store double 1.000000e+00, ptr %485, align 8
  br label %1732, !llvm.loop !20

1030:                                             ; preds = %959
  %1031 = load i64, ptr %459, align 8
  %1032 = add nsw i64 %1031, 1
  store i64 %1032, ptr %459, align 8
  store double %576, ptr %171, align 8
  store double %577, ptr %467, align 8
  %1033 = load ptr, ptr %96, align 8
  %1034 = getelementptr inbounds i8, ptr %1033, i64 8
  %1035 = load i64, ptr %1034, align 8
  %1036 = icmp eq i64 %1035, 0
  br i1 %1036, label %1066, label %1037

1037:                                             ; preds = %1030
  %1038 = load i64, ptr %1033, align 8
  %1039 = load ptr, ptr %73, align 8
  %1040 = getelementptr inbounds i8, ptr %1039, i64 8
  %1041 = load i64, ptr %1040, align 8
  %1042 = load ptr, ptr %136, align 8
  %1043 = load i64, ptr %137, align 8
  %1044 = mul nsw i64 %1043, %1038
  %1045 = getelementptr inbounds double, ptr %1042, i64 %1044
  %1046 = getelementptr inbounds double, ptr %1045, i64 %1043
  store double %491, ptr %1045, align 8
  %1047 = getelementptr inbounds i8, ptr %1045, i64 8
  store double %577, ptr %1047, align 8
  store double %576, ptr %1046, align 8
  %1048 = getelementptr inbounds i8, ptr %1046, i64 8
  store double 0.000000e+00, ptr %1048, align 8
  %1049 = icmp sgt i64 %1041, 0
  br i1 %1049, label %1053, label %1050

1050:                                             ; preds = %1053, %1037
  %1051 = add nsw i64 %1038, 1
  %1052 = load ptr, ptr %96, align 8
  store i64 %1051, ptr %1052, align 8
  br label %1066

1053:                                             ; preds = %1037, %1053
  %1054 = phi i64 [ %1064, %1053 ], [ 0, %1037 ]
  %1055 = load ptr, ptr %74, align 8
  %1056 = getelementptr inbounds double, ptr %1055, i64 %1054
  %1057 = load double, ptr %1056, align 8
  %1058 = add nuw nsw i64 %1054, 2
  %1059 = getelementptr inbounds double, ptr %1045, i64 %1058
  store double %1057, ptr %1059, align 8
  %1060 = load ptr, ptr %76, align 8
  %1061 = getelementptr inbounds double, ptr %1060, i64 %1054
  %1062 = load double, ptr %1061, align 8
  %1063 = getelementptr inbounds double, ptr %1046, i64 %1058
  store double %1062, ptr %1063, align 8
  %1064 = add nuw nsw i64 %1054, 1
  %1065 = icmp eq i64 %1064, %1041
  br i1 %1065, label %1050, label %1053, !llvm.loop !21

1066:                                             ; preds = %1030, %1050
  br i1 %194, label %1067, label %1177

1067:                                             ; preds = %1066
  %1068 = load ptr, ptr %82, align 8
  %1069 = load i64, ptr %80, align 8
  %1070 = load ptr, ptr %138, align 8
  %1071 = getelementptr inbounds i8, ptr %1068, i64 32
  %1072 = load i64, ptr %1071, align 8
  %1073 = getelementptr inbounds double, ptr %1070, i64 %1072
  %1074 = getelementptr inbounds i8, ptr %1068, i64 24
  %1075 = load i64, ptr %1074, align 8
  %1076 = icmp eq i64 %1075, 0
  br i1 %1076, label %1174, label %1077

1077:                                             ; preds = %1067
  %1078 = getelementptr inbounds i8, ptr %1068, i64 40
  %1079 = load i64, ptr %1078, align 8
  %1080 = icmp sgt i64 %1079, 0
  br i1 %1080, label %1135, label %1081

1081:                                             ; preds = %1153, %1077
  %1082 = load ptr, ptr %139, align 8
  %1083 = load ptr, ptr %82, align 8
  %1084 = getelementptr inbounds i8, ptr %1083, i64 8
  %1085 = load i64, ptr %1084, align 8
  %1086 = load ptr, ptr %140, align 8
  %1087 = load ptr, ptr %138, align 8
  %1088 = getelementptr inbounds i8, ptr %1083, i64 32
  %1089 = load i64, ptr %1088, align 8
  %1090 = getelementptr inbounds i8, ptr %1083, i64 40
  %1091 = load i64, ptr %1090, align 8
  %1092 = getelementptr double, ptr %1087, i64 %1089
  %1093 = getelementptr double, ptr %1092, i64 %1091
  store double %577, ptr %1093, align 8
  %1094 = load ptr, ptr %139, align 8
  store double %491, ptr %1094, align 8
  %1095 = load ptr, ptr %82, align 8
  %1096 = getelementptr inbounds i8, ptr %1095, i64 24
  %1097 = load i64, ptr %1096, align 8
  %1098 = load ptr, ptr %74, align 8
  %1099 = load ptr, ptr %138, align 8
  %1100 = load ptr, ptr %141, align 8
  %1101 = inttoptr i64 %1097 to ptr
  %1102 = load ptr, ptr %1101, align 8
  %1103 = tail call i32 %1102(ptr noundef %1082, ptr noundef %1098, ptr noundef %1099, ptr noundef %1100, ptr noundef %1086) #9
  %1104 = icmp eq i32 %1103, 0
  br i1 %1104, label %1105, label %1174

1105:                                             ; preds = %1081
  %1106 = icmp slt i64 %1085, 1
  br i1 %1106, label %1132, label %1107

1107:                                             ; preds = %1105
  %1108 = load ptr, ptr %142, align 8
  %1109 = getelementptr double, ptr %1086, i64 %1085
  br label %1110

1110:                                             ; preds = %1107, %1128
  %1111 = phi i1 [ %1106, %1107 ], [ %1130, %1128 ]
  %1112 = phi i64 [ 0, %1107 ], [ %1129, %1128 ]
  %1113 = getelementptr inbounds i64, ptr %1108, i64 %1112
  %1114 = load i64, ptr %1113, align 8
  %1115 = and i64 %1114, 2
  %1116 = icmp eq i64 %1115, 0
  br i1 %1116, label %1117, label %1128

1117:                                             ; preds = %1110
  %1118 = getelementptr inbounds double, ptr %1086, i64 %1112
  %1119 = load double, ptr %1118, align 8
  %1120 = load ptr, ptr %143, align 8
  %1121 = getelementptr inbounds i64, ptr %1120, i64 %1112
  %1122 = load i64, ptr %1121, align 8
  %1123 = sitofp i64 %1122 to double
  %1124 = fmul double %1119, %1123
  %1125 = getelementptr double, ptr %1109, i64 %1112
  %1126 = load double, ptr %1125, align 8
  %1127 = fcmp ogt double %1124, %1126
  br i1 %1127, label %1128, label %1132

1128:                                             ; preds = %1117, %1110
  %1129 = add nuw nsw i64 %1112, 1
  %1130 = icmp sge i64 %1129, %1085
  %1131 = icmp eq i64 %1129, %1085
  br i1 %1131, label %1132, label %1110, !llvm.loop !22

1132:                                             ; preds = %1128, %1117, %1105
  %1133 = phi i1 [ %1106, %1105 ], [ %1130, %1128 ], [ %1111, %1117 ]
  %1134 = zext i1 %1133 to i32
  br label %1174

1135:                                             ; preds = %1077, %1153
  %1136 = phi i64 [ %1157, %1153 ], [ 0, %1077 ]
  %1137 = load ptr, ptr %76, align 8
  %1138 = getelementptr inbounds double, ptr %1137, i64 %1136
  %1139 = load <8 x double>, ptr %1138, align 8
  %1140 = load ptr, ptr %74, align 8
  %1141 = getelementptr inbounds double, ptr %1140, i64 %1136
  %1142 = load <8 x double>, ptr %1141, align 8
  %1143 = fsub <8 x double> %1139, %1142
  %1144 = fneg <8 x double> %1143
  %1145 = fcmp ogt <8 x double> %1143, zeroinitializer
  %1146 = select <8 x i1> %1145, <8 x double> %1143, <8 x double> %1144
  %1147 = load ptr, ptr %0, align 8
  %1148 = load i64, ptr %1147, align 8
  %1149 = icmp slt i64 %1148, 0
  br i1 %1149, label %1153, label %1150

1150:                                             ; preds = %1135
  %1151 = load ptr, ptr %84, align 8
  %1152 = getelementptr double, ptr %1151, i64 %1136
  br label %1160

1153:                                             ; preds = %1160, %1135
  %1154 = phi <8 x double> [ %1146, %1135 ], [ %1171, %1160 ]
  %1155 = getelementptr inbounds double, ptr %1073, i64 %1136
  %1156 = fmul <8 x double> %1154, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  store <8 x double> %1156, ptr %1155, align 8
  %1157 = add nuw nsw i64 %1136, 8
  %1158 = load i64, ptr %1078, align 8
  %1159 = icmp slt i64 %1157, %1158
  br i1 %1159, label %1135, label %1081, !llvm.loop !23

1160:                                             ; preds = %1150, %1160
  %1161 = phi i64 [ 0, %1150 ], [ %1172, %1160 ]
  %1162 = phi <8 x double> [ %1146, %1150 ], [ %1171, %1160 ]
  %1163 = mul nsw i64 %1161, %1069
  %1164 = getelementptr double, ptr %1152, i64 %1163
  %1165 = load <8 x double>, ptr %1164, align 8
  %1166 = fneg <8 x double> %1165
  %1167 = fcmp ogt <8 x double> %1165, zeroinitializer
  %1168 = select <8 x i1> %1167, <8 x double> %1165, <8 x double> %1166
  %1169 = fmul <8 x double> %589, %1168
  %1170 = fcmp ogt <8 x double> %1162, %1169
  %1171 = select <8 x i1> %1170, <8 x double> %1162, <8 x double> %1169
  %1172 = add nuw i64 %1161, 1
  %1173 = icmp eq i64 %1161, %1148
  br i1 %1173, label %1153, label %1160, !llvm.loop !24

1174:                                             ; preds = %1132, %1081, %1067
  %1175 = phi i32 [ 0, %1067 ], [ 0, %1081 ], [ %1134, %1132 ]
  %1176 = icmp eq i32 %1175, 0
  br label %1177

1177:                                             ; preds = %1174, %1066
  %1178 = phi i1 [ false, %1066 ], [ %1176, %1174 ]
  br i1 %1178, label %1221, label %1179

1179:                                             ; preds = %1177
  %1180 = load i64, ptr %468, align 8
  %1181 = getelementptr inbounds double, ptr %178, i64 %1180
  %1182 = load double, ptr %1181, align 8
  %1183 = fcmp ult double %1182, %576
  br i1 %1183, label %1221, label %1184

1184:                                             ; preds = %1179
  %1185 = load ptr, ptr %73, align 8
  %1186 = getelementptr inbounds i8, ptr %1185, i64 8
  %1187 = load i64, ptr %1186, align 8
  %1188 = load i64, ptr %83, align 8
  %1189 = load ptr, ptr %78, align 8
  %1190 = load ptr, ptr %77, align 8
  %1191 = getelementptr inbounds i8, ptr %1190, i64 48
  %1192 = load i64, ptr %1191, align 8
  %1193 = icmp slt i64 %1192, %1188
  br i1 %1193, label %1194, label %1217

1194:                                             ; preds = %1184
  %1195 = icmp sgt i64 %1187, 0
  br label %1196

1196:                                             ; preds = %1194, %1207
  %1197 = phi i64 [ %1192, %1194 ], [ %1208, %1207 ]
  %1198 = getelementptr inbounds double, ptr %1189, i64 %1197
  %1199 = load double, ptr %1198, align 8
  %1200 = load ptr, ptr %75, align 8
  %1201 = load double, ptr %1200, align 8
  %1202 = fcmp ugt double %1199, %1201
  br i1 %1202, label %1217, label %1203

1203:                                             ; preds = %1196
  br i1 %1195, label %1204, label %1207

1204:                                             ; preds = %1203
  %1205 = mul nsw i64 %1197, %1187
  %1206 = getelementptr double, ptr %1, i64 %1205
  br label %1210

1207:                                             ; preds = %1210, %1203
  %1208 = add i64 %1197, 1
  %1209 = icmp eq i64 %1208, %1188
  br i1 %1209, label %1217, label %1196, !llvm.loop !9

1210:                                             ; preds = %1204, %1210
  %1211 = phi i64 [ 0, %1204 ], [ %1215, %1210 ]
  %1212 = getelementptr inbounds double, ptr %172, i64 %1211
  %1213 = load double, ptr %1212, align 8
  %1214 = getelementptr double, ptr %1206, i64 %1211
  store double %1213, ptr %1214, align 8
  %1215 = add nuw nsw i64 %1211, 1
  %1216 = icmp eq i64 %1215, %1187
  br i1 %1216, label %1207, label %1210, !llvm.loop !10

1217:                                             ; preds = %1196, %1207, %1184
  %1218 = phi i64 [ %1192, %1184 ], [ %1197, %1196 ], [ %1188, %1207 ]
  %1219 = load ptr, ptr %77, align 8
  %1220 = getelementptr inbounds i8, ptr %1219, i64 48
  store i64 %1218, ptr %1220, align 8
  br label %1581

1221:                                             ; preds = %1179, %1177
  %1222 = load ptr, ptr %0, align 8
  %1223 = load ptr, ptr %73, align 8
  %1224 = getelementptr inbounds i8, ptr %1223, i64 16
  %1225 = load i64, ptr %1224, align 8
  %1226 = load i64, ptr %1222, align 8
  %1227 = load i64, ptr %144, align 8
  %1228 = load ptr, ptr %145, align 8
  %1229 = mul nsw i64 %1227, %1226
  %1230 = getelementptr inbounds double, ptr %1228, i64 %1229
  %1231 = load ptr, ptr %146, align 8
  %1232 = add nsw i64 %1226, 1
  %1233 = getelementptr inbounds i8, ptr %1222, i64 16
  %1234 = load i64, ptr %1233, align 8
  %1235 = icmp sgt i64 %1234, 0
  br i1 %1235, label %1236, label %1291

1236:                                             ; preds = %1221
  %1237 = getelementptr inbounds i8, ptr %1222, i64 8
  br label %1243

1238:                                             ; preds = %1279
  %1239 = add nsw i64 %1246, 1
  %1240 = load i64, ptr %1233, align 8
  %1241 = add nsw i64 %1240, %1232
  %1242 = icmp slt i64 %1239, %1241
  br i1 %1242, label %1243, label %1291, !llvm.loop !25

1243:                                             ; preds = %1236, %1238
  %1244 = phi i1 [ %1235, %1236 ], [ %1242, %1238 ]
  %1245 = phi i64 [ undef, %1236 ], [ %1290, %1238 ]
  %1246 = phi i64 [ %1232, %1236 ], [ %1239, %1238 ]
  %1247 = load i64, ptr %1237, align 8
  %1248 = load ptr, ptr %147, align 8
  %1249 = load ptr, ptr %74, align 8
  %1250 = load ptr, ptr %148, align 8
  %1251 = getelementptr i64, ptr %1250, i64 %1246
  %1252 = getelementptr i64, ptr %1251, i64 %1247
  %1253 = load i64, ptr %1252, align 8
  %1254 = getelementptr i8, ptr %1252, i64 8
  %1255 = load i64, ptr %1254, align 8
  %1256 = xor i64 %1253, -1
  %1257 = add i64 %1255, %1256
  %1258 = load ptr, ptr %100, align 8
  %1259 = load ptr, ptr %145, align 8
  %1260 = load ptr, ptr %149, align 8
  %1261 = getelementptr inbounds i64, ptr %1260, i64 %1253
  %1262 = load ptr, ptr %150, align 8
  %1263 = getelementptr inbounds double, ptr %1262, i64 %1253
  tail call fastcc void @combine(ptr noundef %1248, ptr noundef %1249, ptr noundef %1258, ptr noundef %1259, ptr noundef %1261, ptr noundef %1263, i64 noundef %1257, i64 noundef 1, i64 noundef %1225) #8
  %1264 = load ptr, ptr %145, align 8
  %1265 = mul nsw i64 %1246, %1227
  %1266 = getelementptr inbounds double, ptr %1264, i64 %1265
  %1267 = load i64, ptr %464, align 8
  %1268 = add nsw i64 %1267, 1
  store i64 %1268, ptr %464, align 8
  %1269 = load ptr, ptr %151, align 8
  %1270 = getelementptr inbounds double, ptr %1269, i64 %1246
  %1271 = load double, ptr %1270, align 8
  %1272 = fmul double %577, %1271
  %1273 = fadd double %491, %1272
  %1274 = load ptr, ptr %147, align 8
  %1275 = load ptr, ptr %152, align 8
  store double %1273, ptr %1275, align 8
  %1276 = load i64, ptr %153, align 8
  %1277 = icmp sgt i64 %1276, 0
  br i1 %1277, label %1278, label %1279

1278:                                             ; preds = %1243
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %1279

1279:                                             ; preds = %1243, %1278
  %1280 = load ptr, ptr %73, align 8
  %1281 = load i64, ptr %1280, align 8
  %1282 = load ptr, ptr %152, align 8
  %1283 = load ptr, ptr %154, align 8
  %1284 = load ptr, ptr %155, align 8
  %1285 = inttoptr i64 %1281 to ptr
  %1286 = load ptr, ptr %1285, align 8
  %1287 = tail call i32 %1286(ptr noundef %1282, ptr noundef %1274, ptr noundef %1283, ptr noundef %1284, ptr noundef %1266) #9
  %1288 = sext i32 %1287 to i64
  %1289 = icmp eq i32 %1287, 0
  %1290 = select i1 %1289, i64 %1245, i64 %1288
  br i1 %1289, label %1238, label %1291

1291:                                             ; preds = %1238, %1279, %1221
  %1292 = phi i1 [ %1235, %1221 ], [ %1242, %1238 ], [ %1244, %1279 ]
  %1293 = phi i64 [ 0, %1221 ], [ %1288, %1279 ], [ %1288, %1238 ]
  %1294 = phi i64 [ undef, %1221 ], [ %1290, %1279 ], [ %1290, %1238 ]
  %1295 = getelementptr inbounds i8, ptr %1222, i64 16
  br i1 %1292, label %1364, label %1296

1296:                                             ; preds = %1291
  %1297 = load ptr, ptr %73, align 8
  %1298 = getelementptr inbounds i8, ptr %1297, i64 8
  %1299 = load i64, ptr %1298, align 8
  %1300 = icmp sgt i64 %1299, 0
  br i1 %1300, label %1301, label %1305

1301:                                             ; preds = %1296
  %1302 = getelementptr inbounds double, ptr %1231, i64 %1227
  %1303 = shl nsw i64 %1227, 4
  %1304 = getelementptr inbounds i8, ptr %1231, i64 %1303
  br label %1312

1305:                                             ; preds = %1312, %1296
  %1306 = getelementptr inbounds i8, ptr %1222, i64 8
  %1307 = load i64, ptr %1306, align 8
  %1308 = load i64, ptr %1295, align 8
  %1309 = getelementptr inbounds i8, ptr %1222, i64 24
  %1310 = load i64, ptr %1309, align 8
  %1311 = icmp sgt i64 %1310, 3
  br i1 %1311, label %1339, label %1364

1312:                                             ; preds = %1301, %1312
  %1313 = phi i64 [ 0, %1301 ], [ %1334, %1312 ]
  %1314 = load ptr, ptr %156, align 8
  %1315 = getelementptr inbounds double, ptr %1314, i64 %1313
  %1316 = load double, ptr %1315, align 8
  %1317 = load ptr, ptr %74, align 8
  %1318 = getelementptr inbounds double, ptr %1317, i64 %1313
  %1319 = load double, ptr %1318, align 8
  %1320 = fsub double %1316, %1319
  %1321 = load ptr, ptr %145, align 8
  %1322 = getelementptr inbounds double, ptr %1321, i64 %1313
  %1323 = load double, ptr %1322, align 8
  %1324 = fmul double %577, %1323
  %1325 = fsub double %1324, %1320
  %1326 = getelementptr inbounds double, ptr %1231, i64 %1313
  store double %1320, ptr %1326, align 8
  %1327 = getelementptr inbounds double, ptr %1302, i64 %1313
  store double %1325, ptr %1327, align 8
  %1328 = fsub double %1320, %1325
  %1329 = getelementptr inbounds double, ptr %1230, i64 %1313
  %1330 = load double, ptr %1329, align 8
  %1331 = fmul double %577, %1330
  %1332 = fsub double %1328, %1331
  %1333 = getelementptr inbounds double, ptr %1304, i64 %1313
  store double %1332, ptr %1333, align 8
  %1334 = add nuw nsw i64 %1313, 1
  %1335 = load ptr, ptr %73, align 8
  %1336 = getelementptr inbounds i8, ptr %1335, i64 8
  %1337 = load i64, ptr %1336, align 8
  %1338 = icmp slt i64 %1334, %1337
  br i1 %1338, label %1312, label %1305, !llvm.loop !26

1339:                                             ; preds = %1305, %1339
  %1340 = phi i64 [ %1361, %1339 ], [ 3, %1305 ]
  %1341 = mul nsw i64 %1340, %1227
  %1342 = getelementptr inbounds double, ptr %1231, i64 %1341
  %1343 = load ptr, ptr %157, align 8
  %1344 = load ptr, ptr %158, align 8
  %1345 = getelementptr i64, ptr %1344, i64 %1232
  %1346 = getelementptr i64, ptr %1345, i64 %1307
  %1347 = getelementptr i64, ptr %1346, i64 %1308
  %1348 = getelementptr i64, ptr %1347, i64 %1340
  %1349 = getelementptr i8, ptr %1348, i64 -24
  %1350 = load i64, ptr %1349, align 8
  %1351 = getelementptr i8, ptr %1348, i64 -16
  %1352 = load i64, ptr %1351, align 8
  %1353 = xor i64 %1350, -1
  %1354 = add i64 %1352, %1353
  %1355 = load ptr, ptr %100, align 8
  %1356 = load ptr, ptr %145, align 8
  %1357 = load ptr, ptr %159, align 8
  %1358 = getelementptr inbounds i64, ptr %1357, i64 %1350
  %1359 = load ptr, ptr %160, align 8
  %1360 = getelementptr inbounds double, ptr %1359, i64 %1350
  tail call fastcc void @combine(ptr noundef %1342, ptr noundef %1343, ptr noundef %1355, ptr noundef %1356, ptr noundef %1358, ptr noundef %1360, i64 noundef %1354, i64 noundef 1, i64 noundef %1225) #8
  %1361 = add nuw nsw i64 %1340, 1
  %1362 = load i64, ptr %1309, align 8
  %1363 = icmp slt i64 %1361, %1362
  br i1 %1363, label %1339, label %1364, !llvm.loop !27

1364:                                             ; preds = %1339, %1305, %1291
  %1365 = phi i64 [ %1294, %1291 ], [ %1293, %1305 ], [ %1293, %1339 ]
  %1366 = icmp eq i64 %1365, 0
  br i1 %1366, label %1370, label %1367

1367:                                             ; preds = %1364
  store i64 3, ptr %469, align 8
  store double %491, ptr %171, align 8
  %1368 = icmp slt i64 %1365, 0
  %1369 = select i1 %1368, i64 -4, i64 2
  br label %1732

1370:                                             ; preds = %1364
  %1371 = load ptr, ptr %75, align 8
  br i1 %1178, label %1372, label %1383

1372:                                             ; preds = %1370
  %1373 = load ptr, ptr %82, align 8
  %1374 = getelementptr inbounds i8, ptr %1373, i64 16
  %1375 = load i64, ptr %1374, align 8
  %1376 = inttoptr i64 %1375 to ptr
  %1377 = tail call i64 %1376(ptr noundef %0, double noundef %491, double noundef %577) #9
  %1378 = icmp eq i64 %1377, -6
  br i1 %1378, label %1379, label %1380

1379:                                             ; preds = %1372
  store double %491, ptr %1371, align 8
  br label %1558

1380:                                             ; preds = %1372
  %1381 = getelementptr inbounds i8, ptr %1371, i64 48
  %1382 = load double, ptr %1381, align 8
  br label %1383

1383:                                             ; preds = %1380, %1370
  %1384 = phi double [ %1382, %1380 ], [ 1.000000e+00, %1370 ]
  %1385 = phi i64 [ %1377, %1380 ], [ 0, %1370 ]
  %1386 = fcmp oeq double %1384, 1.000000e+00
  br i1 %1386, label %1387, label %1389

1387:                                             ; preds = %1383
  %1388 = load double, ptr %1371, align 8
  br label %1392

1389:                                             ; preds = %1383
  %1390 = fmul double %577, %1384
  %1391 = fadd double %491, %1390
  br label %1392

1392:                                             ; preds = %1389, %1387
  %1393 = phi double [ %1388, %1387 ], [ %1391, %1389 ]
  %1394 = icmp eq i64 %1385, -4
  %1395 = select i1 %1394, i64 -4, i64 0
  br i1 %1394, label %1453, label %1396

1396:                                             ; preds = %1392
  %1397 = fcmp olt double %1384, 1.000000e+00
  %1398 = load ptr, ptr %73, align 8
  %1399 = getelementptr inbounds i8, ptr %1398, i64 8
  %1400 = load i64, ptr %1399, align 8
  %1401 = load i64, ptr %83, align 8
  %1402 = load ptr, ptr %78, align 8
  %1403 = load ptr, ptr %77, align 8
  %1404 = getelementptr inbounds i8, ptr %1403, i64 48
  %1405 = load i64, ptr %1404, align 8
  %1406 = icmp slt i64 %1405, %1401
  br i1 %1406, label %1407, label %1449

1407:                                             ; preds = %1396, %1445
  %1408 = phi i64 [ %1446, %1445 ], [ undef, %1396 ]
  %1409 = phi i64 [ %1447, %1445 ], [ %1405, %1396 ]
  %1410 = getelementptr inbounds double, ptr %1402, i64 %1409
  %1411 = load double, ptr %1410, align 8
  %1412 = fcmp olt double %1411, %1393
  %1413 = fcmp oeq double %1411, %1393
  %1414 = and i1 %1397, %1413
  %1415 = or i1 %1412, %1414
  br i1 %1415, label %1416, label %1449

1416:                                             ; preds = %1407
  %1417 = fsub double %1411, %491
  %1418 = fdiv double %1417, %577
  %1419 = mul nsw i64 %1409, %1400
  %1420 = getelementptr inbounds double, ptr %1, i64 %1419
  %1421 = load ptr, ptr %161, align 8
  %1422 = insertelement <8 x double> poison, double %1418, i64 0
  %1423 = shufflevector <8 x double> %1422, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1423, ptr %1421, align 8
  %1424 = load ptr, ptr %74, align 8
  %1425 = load ptr, ptr %146, align 8
  %1426 = load i64, ptr %144, align 8
  %1427 = load ptr, ptr %0, align 8
  %1428 = getelementptr inbounds i8, ptr %1427, i64 24
  %1429 = load i64, ptr %1428, align 8
  %1430 = load ptr, ptr %161, align 8
  %1431 = load ptr, ptr %73, align 8
  %1432 = getelementptr inbounds i8, ptr %1431, i64 16
  %1433 = load i64, ptr %1432, align 8
  tail call fastcc void @nested(ptr noundef %1420, ptr noundef %1424, ptr noundef %1425, i64 noundef %1426, i64 noundef %1429, ptr noundef %1430, i64 noundef %1433) #8
  %1434 = load ptr, ptr %81, align 8
  %1435 = load i64, ptr %1434, align 8
  %1436 = icmp eq i64 %1435, 1
  br i1 %1436, label %1437, label %1445

1437:                                             ; preds = %1416
  %1438 = load double, ptr %1410, align 8
  %1439 = getelementptr inbounds i8, ptr %1434, i64 56
  %1440 = load i64, ptr %1439, align 8
  %1441 = inttoptr i64 %1440 to ptr
  %1442 = tail call i64 %1441(ptr noundef %0, double noundef %1438, ptr noundef %1420, ptr noundef null) #9
  %1443 = icmp eq i64 %1442, 0
  %1444 = select i1 %1443, i64 %1408, i64 %1442
  br i1 %1443, label %1445, label %1453

1445:                                             ; preds = %1437, %1416
  %1446 = phi i64 [ %1444, %1437 ], [ %1408, %1416 ]
  %1447 = add i64 %1409, 1
  %1448 = icmp eq i64 %1447, %1401
  br i1 %1448, label %1449, label %1407, !llvm.loop !28

1449:                                             ; preds = %1445, %1407, %1396
  %1450 = phi i64 [ %1405, %1396 ], [ %1401, %1445 ], [ %1409, %1407 ]
  %1451 = load ptr, ptr %77, align 8
  %1452 = getelementptr inbounds i8, ptr %1451, i64 48
  store i64 %1450, ptr %1452, align 8
  br label %1453

1453:                                             ; preds = %1437, %1449, %1392
  %1454 = phi i64 [ %1395, %1392 ], [ 0, %1449 ], [ %1444, %1437 ]
  %1455 = icmp eq i64 %1454, 0
  %1456 = icmp ne i64 %1385, 0
  %1457 = fcmp olt double %1384, 1.000000e+00
  %1458 = and i1 %1457, %1455
  %1459 = and i1 %1456, %1458
  br i1 %1459, label %1460, label %1497

1460:                                             ; preds = %1453
  %1461 = load ptr, ptr %162, align 8
  %1462 = load ptr, ptr %163, align 8
  %1463 = insertelement <8 x double> poison, double %1384, i64 0
  %1464 = shufflevector <8 x double> %1463, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1464, ptr %1462, align 8
  %1465 = load ptr, ptr %74, align 8
  %1466 = load ptr, ptr %146, align 8
  %1467 = load i64, ptr %144, align 8
  %1468 = load ptr, ptr %0, align 8
  %1469 = getelementptr inbounds i8, ptr %1468, i64 24
  %1470 = load i64, ptr %1469, align 8
  %1471 = load ptr, ptr %163, align 8
  %1472 = load ptr, ptr %73, align 8
  %1473 = getelementptr inbounds i8, ptr %1472, i64 16
  %1474 = load i64, ptr %1473, align 8
  tail call fastcc void @nested(ptr noundef %1461, ptr noundef %1465, ptr noundef %1466, i64 noundef %1467, i64 noundef %1470, ptr noundef %1471, i64 noundef %1474) #8
  %1475 = load i64, ptr %80, align 8
  %1476 = icmp sgt i64 %1475, 0
  br i1 %1476, label %1481, label %1477

1477:                                             ; preds = %1481, %1460
  %1478 = load ptr, ptr %81, align 8
  %1479 = load i64, ptr %1478, align 8
  %1480 = icmp eq i64 %1479, 1
  br i1 %1480, label %1491, label %1497

1481:                                             ; preds = %1460, %1481
  %1482 = phi i64 [ %1488, %1481 ], [ 0, %1460 ]
  %1483 = load ptr, ptr %162, align 8
  %1484 = getelementptr inbounds double, ptr %1483, i64 %1482
  %1485 = load double, ptr %1484, align 8
  %1486 = load ptr, ptr %76, align 8
  %1487 = getelementptr inbounds double, ptr %1486, i64 %1482
  store double %1485, ptr %1487, align 8
  %1488 = add nuw nsw i64 %1482, 1
  %1489 = load i64, ptr %80, align 8
  %1490 = icmp slt i64 %1488, %1489
  br i1 %1490, label %1481, label %1477, !llvm.loop !29

1491:                                             ; preds = %1477
  %1492 = load ptr, ptr %76, align 8
  %1493 = getelementptr inbounds i8, ptr %1478, i64 56
  %1494 = load i64, ptr %1493, align 8
  %1495 = inttoptr i64 %1494 to ptr
  %1496 = tail call i64 %1495(ptr noundef %0, double noundef %1393, ptr noundef %1492, ptr noundef null) #9
  br label %1497

1497:                                             ; preds = %1491, %1477, %1453
  %1498 = phi i64 [ %1496, %1491 ], [ 0, %1477 ], [ %1454, %1453 ]
  %1499 = icmp eq i64 %1498, 0
  br i1 %1499, label %1502, label %1500

1500:                                             ; preds = %1497
  store double %491, ptr %1371, align 8
  %1501 = getelementptr inbounds i8, ptr %1371, i64 8
  store double %577, ptr %1501, align 8
  br label %1558

1502:                                             ; preds = %1497
  br i1 %1386, label %1503, label %1541

1503:                                             ; preds = %1502
  %1504 = load ptr, ptr %76, align 8
  %1505 = load ptr, ptr %73, align 8
  %1506 = getelementptr inbounds i8, ptr %1505, i64 8
  %1507 = load i64, ptr %1506, align 8
  %1508 = load i64, ptr %83, align 8
  %1509 = load ptr, ptr %78, align 8
  %1510 = load ptr, ptr %77, align 8
  %1511 = getelementptr inbounds i8, ptr %1510, i64 48
  %1512 = load i64, ptr %1511, align 8
  %1513 = icmp slt i64 %1512, %1508
  br i1 %1513, label %1514, label %1537

1514:                                             ; preds = %1503
  %1515 = icmp sgt i64 %1507, 0
  br label %1516

1516:                                             ; preds = %1514, %1527
  %1517 = phi i64 [ %1512, %1514 ], [ %1528, %1527 ]
  %1518 = getelementptr inbounds double, ptr %1509, i64 %1517
  %1519 = load double, ptr %1518, align 8
  %1520 = load ptr, ptr %75, align 8
  %1521 = load double, ptr %1520, align 8
  %1522 = fcmp ugt double %1519, %1521
  br i1 %1522, label %1537, label %1523

1523:                                             ; preds = %1516
  br i1 %1515, label %1524, label %1527

1524:                                             ; preds = %1523
  %1525 = mul nsw i64 %1517, %1507
  %1526 = getelementptr double, ptr %1, i64 %1525
  br label %1530

1527:                                             ; preds = %1530, %1523
  %1528 = add i64 %1517, 1
  %1529 = icmp eq i64 %1528, %1508
  br i1 %1529, label %1537, label %1516, !llvm.loop !9

1530:                                             ; preds = %1524, %1530
  %1531 = phi i64 [ 0, %1524 ], [ %1535, %1530 ]
  %1532 = getelementptr inbounds double, ptr %1504, i64 %1531
  %1533 = load double, ptr %1532, align 8
  %1534 = getelementptr double, ptr %1526, i64 %1531
  store double %1533, ptr %1534, align 8
  %1535 = add nuw nsw i64 %1531, 1
  %1536 = icmp eq i64 %1535, %1507
  br i1 %1536, label %1527, label %1530, !llvm.loop !10

1537:                                             ; preds = %1527, %1516, %1503
  %1538 = phi i64 [ %1512, %1503 ], [ %1508, %1527 ], [ %1517, %1516 ]
  %1539 = load ptr, ptr %77, align 8
  %1540 = getelementptr inbounds i8, ptr %1539, i64 48
  store i64 %1538, ptr %1540, align 8
  br label %1541

1541:                                             ; preds = %1537, %1502
  br i1 %1456, label %1542, label %1558

1542:                                             ; preds = %1541
  %1543 = load i64, ptr %80, align 8
  %1544 = icmp sgt i64 %1543, 0
  br i1 %1544, label %1548, label %1545

1545:                                             ; preds = %1548, %1542
  store double %1393, ptr %1371, align 8
  %1546 = getelementptr inbounds i8, ptr %1371, i64 8
  store double 0.000000e+00, ptr %1546, align 8
  %1547 = load ptr, ptr %77, align 8
  store i64 0, ptr %1547, align 8
  br label %1558

1548:                                             ; preds = %1542, %1548
  %1549 = phi i64 [ %1555, %1548 ], [ 0, %1542 ]
  %1550 = load ptr, ptr %76, align 8
  %1551 = getelementptr inbounds double, ptr %1550, i64 %1549
  %1552 = load double, ptr %1551, align 8
  %1553 = load ptr, ptr %74, align 8
  %1554 = getelementptr inbounds double, ptr %1553, i64 %1549
  store double %1552, ptr %1554, align 8
  %1555 = add nuw nsw i64 %1549, 1
  %1556 = load i64, ptr %80, align 8
  %1557 = icmp slt i64 %1555, %1556
  br i1 %1557, label %1548, label %1545, !llvm.loop !30

1558:                                             ; preds = %1379, %1500, %1541, %1545
  %1559 = phi i64 [ -6, %1379 ], [ %1498, %1500 ], [ %1385, %1545 ], [ %1385, %1541 ]
  %1560 = icmp eq i64 %1559, -6
  br i1 %1560, label %1565, label %1561

1561:                                             ; preds = %1558
  %1562 = icmp ne i64 %1559, 6
  %1563 = select i1 %1562, i1 true, i1 %187
  %1564 = select i1 %1563, i1 true, i1 %194
  br i1 %1564, label %1575, label %1565

1565:                                             ; preds = %1561, %1558
  %1566 = phi i64 [ %1559, %1561 ], [ 2, %1558 ]
  %1567 = load i64, ptr %459, align 8
  %1568 = add nsw i64 %1567, -1
  store i64 %1568, ptr %459, align 8
  %1569 = load ptr, ptr %96, align 8
  %1570 = load i64, ptr %1569, align 8
  %1571 = add nsw i64 %1570, -1
  store i64 %1571, ptr %1569, align 8
  %1572 = load i64, ptr %460, align 8
  %1573 = add nsw i64 %1572, 1
  store i64 %1573, ptr %460, align 8
  store i64 %1566, ptr %480, align 8
  store double 1.000000e+00, ptr %481, align 8
  %1574 = fmul double %577, 2.500000e-01
  br label %1732, !llvm.loop !20

1575:                                             ; preds = %1561
  %1576 = icmp eq i64 %1559, 0
  br i1 %1576, label %1581, label %1577

1577:                                             ; preds = %1575
  %1578 = load ptr, ptr %96, align 8
  %1579 = load i64, ptr %1578, align 8
  %1580 = add nsw i64 %1579, 1
  store i64 %1580, ptr %1578, align 8
  br label %1732

1581:                                             ; preds = %1575, %1217
  br i1 %187, label %1684, label %1582

1582:                                             ; preds = %1581
  %1583 = load double, ptr %471, align 8
  %1584 = fcmp ogt double %961, 1.000000e-10
  %1585 = select i1 %1584, double %961, double 1.000000e-10
  %1586 = load double, ptr %472, align 8
  %1587 = load double, ptr %473, align 8
  %1588 = fneg double %1587
  %1589 = bitcast double %1585 to i64
  %1590 = add nsw i64 %1589, -4604544271217802189
  %1591 = ashr i64 %1590, 52
  %1592 = and i64 %1590, -4503599627370496
  %1593 = sub nsw i64 %1589, %1592
  %1594 = bitcast i64 %1593 to double
  %1595 = fadd double %1594, -1.000000e+00
  %1596 = fadd double %1594, 1.000000e+00
  %1597 = fdiv double %1595, %1596
  %1598 = fmul double %1597, %1597
  %1599 = tail call double @llvm.fma.f64(double %1598, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1600 = tail call double @llvm.fma.f64(double %1599, double %1598, double 0x3FE2776C50EF9BFE)
  %1601 = tail call double @llvm.fma.f64(double %1600, double %1598, double 0x3FEEC709DC3A03FD)
  %1602 = tail call double @llvm.fma.f64(double %1601, double %1598, double 0x40071547652B82FE)
  %1603 = trunc nsw i64 %1591 to i32
  %1604 = sitofp i32 %1603 to double
  %1605 = fmul double %1597, %1602
  %1606 = fadd double %1605, %1604
  %1607 = fmul double %1606, %1588
  %1608 = fcmp ogt double %1607, -1.000000e+03
  %1609 = select i1 %1608, double %1607, double -1.000000e+03
  %1610 = fcmp olt double %1609, 1.000000e+03
  %1611 = select i1 %1610, double %1609, double 1.000000e+03
  %1612 = tail call double @llvm.rint.f64(double %1611)
  %1613 = fsub double %1611, %1612
  %1614 = tail call double @llvm.fma.f64(double %1613, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1615 = tail call double @llvm.fma.f64(double %1614, double %1613, double 0x3F55D87FE78A6730)
  %1616 = tail call double @llvm.fma.f64(double %1615, double %1613, double 0x3F83B2AB6FBA4E77)
  %1617 = tail call double @llvm.fma.f64(double %1616, double %1613, double 0x3FAC6B08D704A0BF)
  %1618 = tail call double @llvm.fma.f64(double %1617, double %1613, double 0x3FCEBFBDFF82C58E)
  %1619 = tail call double @llvm.fma.f64(double %1618, double %1613, double 0x3FE62E42FEFA39EF)
  %1620 = tail call double @llvm.fma.f64(double %1619, double %1613, double 1.000000e+00)
  %1621 = bitcast double %1620 to i64
  %1622 = fptosi double %1612 to i32
  %1623 = sext i32 %1622 to i64
  %1624 = shl nsw i64 %1623, 52
  %1625 = add nsw i64 %1624, %1621
  %1626 = bitcast i64 %1625 to double
  %1627 = fmul double %1586, %1626
  %1628 = load double, ptr %474, align 8
  %1629 = fcmp une double %1628, 0.000000e+00
  br i1 %1629, label %1630, label %1670

1630:                                             ; preds = %1582
  %1631 = load i64, ptr %470, align 8
  %1632 = add nsw i64 %1631, -4604544271217802189
  %1633 = ashr i64 %1632, 52
  %1634 = and i64 %1632, -4503599627370496
  %1635 = sub nsw i64 %1631, %1634
  %1636 = bitcast i64 %1635 to double
  %1637 = fadd double %1636, -1.000000e+00
  %1638 = fadd double %1636, 1.000000e+00
  %1639 = fdiv double %1637, %1638
  %1640 = fmul double %1639, %1639
  %1641 = tail call double @llvm.fma.f64(double %1640, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1642 = tail call double @llvm.fma.f64(double %1641, double %1640, double 0x3FE2776C50EF9BFE)
  %1643 = tail call double @llvm.fma.f64(double %1642, double %1640, double 0x3FEEC709DC3A03FD)
  %1644 = tail call double @llvm.fma.f64(double %1643, double %1640, double 0x40071547652B82FE)
  %1645 = trunc nsw i64 %1633 to i32
  %1646 = sitofp i32 %1645 to double
  %1647 = fmul double %1639, %1644
  %1648 = fadd double %1647, %1646
  %1649 = fmul double %1628, %1648
  %1650 = fcmp ogt double %1649, -1.000000e+03
  %1651 = select i1 %1650, double %1649, double -1.000000e+03
  %1652 = fcmp olt double %1651, 1.000000e+03
  %1653 = select i1 %1652, double %1651, double 1.000000e+03
  %1654 = tail call double @llvm.rint.f64(double %1653)
  %1655 = fsub double %1653, %1654
  %1656 = tail call double @llvm.fma.f64(double %1655, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1657 = tail call double @llvm.fma.f64(double %1656, double %1655, double 0x3F55D87FE78A6730)
  %1658 = tail call double @llvm.fma.f64(double %1657, double %1655, double 0x3F83B2AB6FBA4E77)
  %1659 = tail call double @llvm.fma.f64(double %1658, double %1655, double 0x3FAC6B08D704A0BF)
  %1660 = tail call double @llvm.fma.f64(double %1659, double %1655, double 0x3FCEBFBDFF82C58E)
  %1661 = tail call double @llvm.fma.f64(double %1660, double %1655, double 0x3FE62E42FEFA39EF)
  %1662 = tail call double @llvm.fma.f64(double %1661, double %1655, double 1.000000e+00)
  %1663 = bitcast double %1662 to i64
  %1664 = fptosi double %1654 to i32
  %1665 = sext i32 %1664 to i64
  %1666 = shl nsw i64 %1665, 52
  %1667 = add nsw i64 %1666, %1663
  %1668 = bitcast i64 %1667 to double
  %1669 = fmul double %1627, %1668
  br label %1670

1670:                                             ; preds = %1582, %1630
  %1671 = phi double [ %1669, %1630 ], [ %1627, %1582 ]
  %1672 = load double, ptr %475, align 8
  %1673 = fcmp ogt double %1671, %1672
  %1674 = select i1 %1673, double %1671, double %1672
  %1675 = fcmp olt double %1583, %1674
  %1676 = select i1 %1675, double %1583, double %1674
  %1677 = fmul double %577, %1676
  %1678 = fcmp ogt double %492, %1677
  %1679 = select i1 %1678, double %492, double %1677
  %1680 = select i1 %581, double %1677, double %1679
  %1681 = fcmp ogt double %961, 1.000000e-04
  %1682 = select i1 %1681, double %961, double 1.000000e-04
  store double %1682, ptr %470, align 8
  %1683 = load double, ptr %476, align 8
  store double %1683, ptr %471, align 8
  br label %1684

1684:                                             ; preds = %1670, %1581
  %1685 = phi double [ %1680, %1670 ], [ %492, %1581 ]
  br i1 %477, label %1690, label %1686

1686:                                             ; preds = %1690, %1684
  %1687 = load i64, ptr %478, align 8
  %1688 = load i64, ptr %83, align 8
  %1689 = icmp eq i64 %1687, %1688
  br i1 %1689, label %1702, label %1703

1690:                                             ; preds = %1684, %1690
  %1691 = phi i64 [ %1700, %1690 ], [ 0, %1684 ]
  %1692 = getelementptr inbounds double, ptr %172, i64 %1691
  %1693 = load double, ptr %1692, align 8
  %1694 = load ptr, ptr %74, align 8
  %1695 = getelementptr inbounds double, ptr %1694, i64 %1691
  store double %1693, ptr %1695, align 8
  %1696 = getelementptr inbounds double, ptr %202, i64 %1691
  %1697 = load double, ptr %1696, align 8
  %1698 = load ptr, ptr %84, align 8
  %1699 = getelementptr inbounds double, ptr %1698, i64 %1691
  store double %1697, ptr %1699, align 8
  %1700 = add nuw nsw i64 %1691, 1
  %1701 = icmp eq i64 %1700, %181
  br i1 %1701, label %1686, label %1690, !llvm.loop !31

1702:                                             ; preds = %1686
  store double %1685, ptr %204, align 8
  br label %1732

1703:                                             ; preds = %1686
  %1704 = fcmp oeq double %576, %551
  br i1 %1704, label %1705, label %1732

1705:                                             ; preds = %1703
  %1706 = load i64, ptr %98, align 8
  %1707 = icmp sgt i64 %1706, 0
  br i1 %1707, label %1708, label %1710

1708:                                             ; preds = %1705
  %1709 = load ptr, ptr %164, align 8
  store double 0x7FF0000000000000, ptr %1709, align 8
  br label %1710

1710:                                             ; preds = %1705, %1708
  %1711 = load i64, ptr %464, align 8
  %1712 = add nsw i64 %1711, 1
  store i64 %1712, ptr %464, align 8
  %1713 = load ptr, ptr %74, align 8
  %1714 = load ptr, ptr %84, align 8
  %1715 = load ptr, ptr %165, align 8
  store double %576, ptr %1715, align 8
  %1716 = load i64, ptr %166, align 8
  %1717 = icmp sgt i64 %1716, 0
  br i1 %1717, label %1718, label %1719

1718:                                             ; preds = %1710
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %1719

1719:                                             ; preds = %1710, %1718
  %1720 = load ptr, ptr %73, align 8
  %1721 = load i64, ptr %1720, align 8
  %1722 = load ptr, ptr %165, align 8
  %1723 = load ptr, ptr %167, align 8
  %1724 = load ptr, ptr %168, align 8
  %1725 = inttoptr i64 %1721 to ptr
  %1726 = load ptr, ptr %1725, align 8
  %1727 = tail call i32 %1726(ptr noundef %1722, ptr noundef %1713, ptr noundef %1723, ptr noundef %1724, ptr noundef %1714) #9
  %1728 = icmp eq i32 %1727, 0
  br i1 %1728, label %1732, label %1729

1729:                                             ; preds = %1719
  store i64 3, ptr %479, align 8
  store double %1685, ptr %204, align 8
  %1730 = icmp slt i32 %1727, 0
  %1731 = select i1 %1730, i64 -4, i64 2
  br label %1732

1732:                                             ; preds = %1729, %1719, %1703, %1702, %1577, %1565, %1367, %1029, %1028, %948, %758, %583
  %1733 = phi double [ %492, %583 ], [ %492, %758 ], [ %492, %948 ], [ %1027, %1029 ], [ %1027, %1028 ], [ %492, %1367 ], [ %1574, %1565 ], [ %492, %1577 ], [ %1685, %1702 ], [ %1685, %1729 ], [ %1685, %1719 ], [ %1685, %1703 ]
  %1734 = phi double [ %491, %583 ], [ %491, %758 ], [ %491, %948 ], [ %491, %1029 ], [ %491, %1028 ], [ %491, %1367 ], [ %491, %1565 ], [ %491, %1577 ], [ %576, %1702 ], [ %576, %1729 ], [ %576, %1719 ], [ %576, %1703 ]
  %1735 = phi i32 [ 1, %583 ], [ 1, %758 ], [ 1, %948 ], [ 3, %1029 ], [ 1, %1028 ], [ 1, %1367 ], [ 3, %1565 ], [ 1, %1577 ], [ 1, %1702 ], [ 1, %1729 ], [ 0, %1719 ], [ 0, %1703 ]
  %1736 = phi i64 [ 2, %583 ], [ -4, %758 ], [ -4, %948 ], [ %490, %1029 ], [ 2, %1028 ], [ %1369, %1367 ], [ %490, %1565 ], [ %1559, %1577 ], [ 0, %1702 ], [ %1731, %1729 ], [ %490, %1719 ], [ %490, %1703 ]
  switch i32 %1735, label %1740 [
    i32 0, label %1737
    i32 3, label %1737
  ]

1737:                                             ; preds = %1732, %1732
  %1738 = load i64, ptr %174, align 8
  %1739 = icmp eq i64 %1738, 0
  br i1 %1739, label %486, label %488, !llvm.loop !20

1740:                                             ; preds = %1732, %170, %258, %300, %486, %505, %513
  %1741 = phi i64 [ -1, %170 ], [ %261, %258 ], [ -1, %486 ], [ -5, %505 ], [ 1, %513 ], [ 0, %300 ], [ %1736, %1732 ]
  %1742 = load ptr, ptr %169, align 8
  %1743 = getelementptr inbounds i8, ptr %1742, i64 48
  %1744 = load i64, ptr %1743, align 8
  %1745 = icmp ne i64 %1741, -2
  %1746 = icmp eq i64 %1744, 0
  %1747 = select i1 %1745, i1 true, i1 %1746
  br i1 %1747, label %1755, label %1748

1748:                                             ; preds = %1740
  %1749 = inttoptr i64 %1744 to ptr
  %1750 = tail call i64 %1749(ptr noundef %0) #9
  %1751 = icmp eq i64 %1750, 8
  %1752 = select i1 %1751, i64 8, i64 %1741
  %1753 = icmp eq i64 %1750, 1
  %1754 = zext i1 %1753 to i32
  br label %1755

1755:                                             ; preds = %1740, %1748
  %1756 = phi i64 [ %1741, %1740 ], [ %1752, %1748 ]
  %1757 = phi i32 [ 0, %1740 ], [ %1754, %1748 ]
  %1758 = icmp eq i32 %1757, 0
  br i1 %1758, label %1759, label %170, !llvm.loop !32

1759:                                             ; preds = %1755
  %1760 = getelementptr inbounds i8, ptr %0, i64 320
  %1761 = load i64, ptr %1760, align 8
  %1762 = icmp sgt i64 %1761, 0
  br i1 %1762, label %1763, label %1766

1763:                                             ; preds = %1759
  %1764 = getelementptr inbounds i8, ptr %0, i64 336
  %1765 = load ptr, ptr %1764, align 8
  store double 0x7FF0000000000000, ptr %1765, align 8
  br label %1766

1766:                                             ; preds = %1759, %1763
  ret i64 %1756
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
