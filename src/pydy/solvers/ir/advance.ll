; sources 100339f192be1f726e6a6f60c8fa8b7f0752e701e0bf1f1c428c6422a011c8eb
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define i64 @advance(ptr noundef %0, ptr noundef %1, i64 noundef %2) #0 {
  %4 = alloca [8 x double], align 16
  %5 = alloca [8 x double], align 16
  %6 = alloca [1 x double], align 8
  %7 = alloca [1 x double], align 8
  %8 = alloca [1 x double], align 8
  %9 = icmp eq i64 %2, 1
  br i1 %9, label %10, label %183

10:                                               ; preds = %3
  %11 = getelementptr inbounds i8, ptr %0, i64 144
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %12, i64 8
  %14 = load i64, ptr %13, align 8
  %15 = icmp sgt i64 %14, 0
  br i1 %15, label %16, label %18

16:                                               ; preds = %10
  %17 = getelementptr inbounds i8, ptr %0, i64 360
  br label %26

18:                                               ; preds = %26, %10
  %19 = getelementptr inbounds i8, ptr %0, i64 144
  %20 = getelementptr inbounds i8, ptr %0, i64 632
  %21 = load i64, ptr %20, align 8
  %22 = icmp sgt i64 %21, 0
  br i1 %22, label %23, label %37

23:                                               ; preds = %18
  %24 = getelementptr inbounds i8, ptr %0, i64 624
  %25 = getelementptr inbounds i8, ptr %0, i64 1272
  br label %44

26:                                               ; preds = %16, %26
  %27 = phi i64 [ 0, %16 ], [ %32, %26 ]
  %28 = getelementptr inbounds double, ptr %1, i64 %27
  %29 = load double, ptr %28, align 8
  %30 = load ptr, ptr %17, align 8
  %31 = getelementptr inbounds double, ptr %30, i64 %27
  store double %29, ptr %31, align 8
  %32 = add nuw nsw i64 %27, 1
  %33 = load ptr, ptr %11, align 8
  %34 = getelementptr inbounds i8, ptr %33, i64 8
  %35 = load i64, ptr %34, align 8
  %36 = icmp slt i64 %32, %35
  br i1 %36, label %26, label %18, !llvm.loop !3

37:                                               ; preds = %44, %18
  %38 = getelementptr inbounds i8, ptr %0, i64 648
  %39 = getelementptr inbounds i8, ptr %0, i64 656
  %40 = load i64, ptr %39, align 8
  %41 = icmp sgt i64 %40, 0
  br i1 %41, label %42, label %54

42:                                               ; preds = %37
  %43 = getelementptr inbounds i8, ptr %0, i64 1296
  br label %60

44:                                               ; preds = %23, %44
  %45 = phi i64 [ 0, %23 ], [ %51, %44 ]
  %46 = load ptr, ptr %25, align 8
  %47 = getelementptr inbounds double, ptr %46, i64 %45
  %48 = load double, ptr %47, align 8
  %49 = load ptr, ptr %24, align 8
  %50 = getelementptr inbounds double, ptr %49, i64 %45
  store double %48, ptr %50, align 8
  %51 = add nuw nsw i64 %45, 1
  %52 = load i64, ptr %20, align 8
  %53 = icmp slt i64 %51, %52
  br i1 %53, label %44, label %37, !llvm.loop !6

54:                                               ; preds = %60, %37
  %55 = getelementptr inbounds i8, ptr %0, i64 768
  %56 = load ptr, ptr %55, align 8
  %57 = getelementptr inbounds i8, ptr %56, i64 8
  %58 = load i64, ptr %57, align 8
  %59 = icmp sgt i64 %58, 0
  br i1 %59, label %70, label %75

60:                                               ; preds = %42, %60
  %61 = phi i64 [ 0, %42 ], [ %67, %60 ]
  %62 = load ptr, ptr %43, align 8
  %63 = getelementptr inbounds i64, ptr %62, i64 %61
  %64 = load i64, ptr %63, align 8
  %65 = load ptr, ptr %38, align 8
  %66 = getelementptr inbounds i64, ptr %65, i64 %61
  store i64 %64, ptr %66, align 8
  %67 = add nuw nsw i64 %61, 1
  %68 = load i64, ptr %39, align 8
  %69 = icmp slt i64 %67, %68
  br i1 %69, label %60, label %54, !llvm.loop !7

70:                                               ; preds = %54
  %71 = getelementptr inbounds i8, ptr %0, i64 984
  %72 = load ptr, ptr %71, align 8
  %73 = mul i64 %58, 88
  %74 = getelementptr inbounds i8, ptr %72, i64 %73
  store double 0x7FF8000000000000, ptr %74, align 8
  br label %75

75:                                               ; preds = %70, %54
  %76 = load ptr, ptr %38, align 8
  %77 = getelementptr inbounds i8, ptr %76, i64 56
  %78 = load i64, ptr %77, align 8
  %79 = icmp sgt i64 %78, 0
  br i1 %79, label %80, label %2253

80:                                               ; preds = %75
  %81 = load ptr, ptr %55, align 8
  %82 = getelementptr inbounds i8, ptr %81, i64 8
  %83 = load i64, ptr %82, align 8
  %84 = icmp eq i64 %83, 0
  br i1 %84, label %183, label %85

85:                                               ; preds = %80
  %86 = getelementptr inbounds i8, ptr %0, i64 248
  %87 = load i64, ptr %86, align 8
  %88 = icmp sgt i64 %87, 0
  br i1 %88, label %2253, label %89

89:                                               ; preds = %85
  %90 = load ptr, ptr %19, align 8
  %91 = getelementptr inbounds i8, ptr %90, i64 40
  %92 = load i64, ptr %91, align 8
  %93 = icmp eq i64 %92, 0
  br i1 %93, label %94, label %2253

94:                                               ; preds = %89
  %95 = getelementptr inbounds i8, ptr %0, i64 624
  %96 = load ptr, ptr %95, align 8
  %97 = load double, ptr %96, align 8
  %98 = getelementptr inbounds i8, ptr %0, i64 168
  %99 = load ptr, ptr %98, align 8
  store double %97, ptr %99, align 8
  %100 = load ptr, ptr %55, align 8
  %101 = load i64, ptr %100, align 8
  %102 = load ptr, ptr %98, align 8
  %103 = getelementptr inbounds i8, ptr %0, i64 360
  %104 = load ptr, ptr %103, align 8
  %105 = getelementptr inbounds i8, ptr %0, i64 192
  %106 = load ptr, ptr %105, align 8
  %107 = getelementptr inbounds i8, ptr %0, i64 792
  %108 = load ptr, ptr %107, align 8
  %109 = getelementptr inbounds i8, ptr %0, i64 984
  %110 = load ptr, ptr %109, align 8
  %111 = inttoptr i64 %101 to ptr
  %112 = load ptr, ptr %111, align 8
  %113 = tail call i32 %112(ptr noundef %102, ptr noundef %104, ptr noundef %106, ptr noundef %108, ptr noundef %110) #10
  %114 = load ptr, ptr %55, align 8
  %115 = getelementptr inbounds i8, ptr %114, i64 56
  %116 = load i64, ptr %115, align 8
  %117 = load ptr, ptr %98, align 8
  %118 = load ptr, ptr %103, align 8
  %119 = load ptr, ptr %105, align 8
  %120 = getelementptr inbounds i8, ptr %0, i64 1152
  %121 = load ptr, ptr %120, align 8
  %122 = getelementptr inbounds i8, ptr %0, i64 1200
  %123 = load ptr, ptr %122, align 8
  %124 = inttoptr i64 %116 to ptr
  %125 = load ptr, ptr %124, align 8
  %126 = tail call i32 %125(ptr noundef %117, ptr noundef %118, ptr noundef %119, ptr noundef %121, ptr noundef %123) #10
  %127 = getelementptr inbounds i8, ptr %0, i64 864
  %128 = icmp slt i64 %83, 1
  br i1 %128, label %181, label %129

129:                                              ; preds = %94
  %130 = getelementptr inbounds i8, ptr %0, i64 984
  %131 = getelementptr inbounds i8, ptr %0, i64 1200
  %132 = getelementptr inbounds i8, ptr %0, i64 1200
  %133 = getelementptr inbounds i8, ptr %0, i64 936
  %134 = getelementptr inbounds i8, ptr %0, i64 960
  br label %135

135:                                              ; preds = %129, %166
  %136 = phi i1 [ %128, %129 ], [ %179, %166 ]
  %137 = phi i64 [ 0, %129 ], [ %178, %166 ]
  %138 = load ptr, ptr %130, align 8
  %139 = getelementptr inbounds double, ptr %138, i64 %137
  %140 = load double, ptr %139, align 8
  %141 = fcmp oeq double %140, 0.000000e+00
  br i1 %141, label %142, label %146

142:                                              ; preds = %135
  %143 = load ptr, ptr %131, align 8
  %144 = getelementptr inbounds double, ptr %143, i64 %137
  %145 = load double, ptr %144, align 8
  br label %146

146:                                              ; preds = %142, %135
  %147 = phi double [ %145, %142 ], [ %140, %135 ]
  br i1 %141, label %157, label %148

148:                                              ; preds = %146
  %149 = load ptr, ptr %132, align 8
  %150 = getelementptr double, ptr %149, i64 %83
  %151 = getelementptr double, ptr %150, i64 %137
  %152 = load double, ptr %151, align 8
  %153 = tail call double @llvm.fabs.f64(double %140)
  %154 = fmul double %152, 0x3CE0000000000000
  %155 = fcmp ole double %153, %154
  %156 = zext i1 %155 to i32
  br label %157

157:                                              ; preds = %146, %148
  %158 = phi i32 [ 1, %146 ], [ %156, %148 ]
  %159 = icmp eq i32 %158, 0
  br i1 %159, label %166, label %160

160:                                              ; preds = %157
  %161 = load ptr, ptr %127, align 8
  %162 = getelementptr inbounds i64, ptr %161, i64 %137
  %163 = load i64, ptr %162, align 8
  %164 = and i64 %163, 2
  %165 = icmp eq i64 %164, 0
  br i1 %165, label %181, label %166

166:                                              ; preds = %160, %157
  %167 = tail call double @llvm.fabs.f64(double %147)
  %168 = fcmp ueq double %167, 0x7FF0000000000000
  %169 = fcmp ogt double %147, 0.000000e+00
  %170 = fcmp olt double %147, 0.000000e+00
  %171 = sext i1 %170 to i64
  %172 = select i1 %169, i64 1, i64 %171
  %173 = select i1 %168, i64 0, i64 %172
  %174 = load ptr, ptr %133, align 8
  %175 = getelementptr inbounds i64, ptr %174, i64 %137
  store i64 %173, ptr %175, align 8
  %176 = load ptr, ptr %134, align 8
  %177 = getelementptr inbounds i64, ptr %176, i64 %137
  store i64 0, ptr %177, align 8
  %178 = add nuw nsw i64 %137, 1
  %179 = icmp sge i64 %178, %83
  %180 = icmp eq i64 %178, %83
  br i1 %180, label %181, label %135, !llvm.loop !8

181:                                              ; preds = %160, %166, %94
  %182 = phi i1 [ %128, %94 ], [ %179, %166 ], [ %136, %160 ]
  br i1 %182, label %183, label %2253

183:                                              ; preds = %80, %181, %3
  %184 = getelementptr inbounds i8, ptr %0, i64 144
  %185 = getelementptr inbounds i8, ptr %0, i64 360
  %186 = getelementptr inbounds i8, ptr %0, i64 624
  %187 = getelementptr inbounds i8, ptr %0, i64 384
  %188 = getelementptr inbounds i8, ptr %0, i64 648
  %189 = getelementptr inbounds i8, ptr %0, i64 672
  %190 = getelementptr inbounds i8, ptr %0, i64 120
  %191 = getelementptr inbounds i8, ptr %0, i64 368
  %192 = getelementptr inbounds i8, ptr %0, i64 696
  %193 = getelementptr inbounds i8, ptr %0, i64 768
  %194 = getelementptr inbounds i8, ptr %0, i64 680
  %195 = getelementptr inbounds i8, ptr %0, i64 528
  %196 = getelementptr inbounds i8, ptr %0, i64 320
  %197 = getelementptr inbounds i8, ptr %0, i64 312
  %198 = getelementptr inbounds i8, ptr %0, i64 336
  %199 = getelementptr inbounds i8, ptr %0, i64 168
  %200 = getelementptr inbounds i8, ptr %0, i64 248
  %201 = getelementptr inbounds i8, ptr %0, i64 192
  %202 = getelementptr inbounds i8, ptr %0, i64 216
  %203 = getelementptr inbounds i8, ptr %0, i64 528
  %204 = getelementptr inbounds i8, ptr %0, i64 408
  %205 = getelementptr inbounds i8, ptr %0, i64 408
  %206 = getelementptr inbounds i8, ptr %0, i64 368
  %207 = getelementptr inbounds i8, ptr %0, i64 1320
  %208 = getelementptr inbounds i8, ptr %0, i64 320
  %209 = getelementptr inbounds i8, ptr %0, i64 312
  %210 = getelementptr inbounds i8, ptr %0, i64 336
  %211 = getelementptr inbounds i8, ptr %0, i64 432
  %212 = getelementptr inbounds i8, ptr %0, i64 408
  %213 = getelementptr inbounds i8, ptr %0, i64 24
  %214 = getelementptr inbounds i8, ptr %0, i64 528
  %215 = getelementptr inbounds i8, ptr %0, i64 48
  %216 = getelementptr inbounds i8, ptr %0, i64 72
  %217 = getelementptr inbounds i8, ptr %0, i64 368
  %218 = getelementptr inbounds i8, ptr %0, i64 96
  %219 = getelementptr inbounds i8, ptr %0, i64 168
  %220 = getelementptr inbounds i8, ptr %0, i64 248
  %221 = getelementptr inbounds i8, ptr %0, i64 192
  %222 = getelementptr inbounds i8, ptr %0, i64 216
  %223 = getelementptr inbounds i8, ptr %0, i64 384
  %224 = getelementptr inbounds i8, ptr %0, i64 24
  %225 = getelementptr inbounds i8, ptr %0, i64 528
  %226 = getelementptr inbounds i8, ptr %0, i64 48
  %227 = getelementptr inbounds i8, ptr %0, i64 72
  %228 = getelementptr inbounds i8, ptr %0, i64 168
  %229 = getelementptr inbounds i8, ptr %0, i64 248
  %230 = getelementptr inbounds i8, ptr %0, i64 192
  %231 = getelementptr inbounds i8, ptr %0, i64 216
  %232 = getelementptr inbounds i8, ptr %0, i64 504
  %233 = getelementptr inbounds i8, ptr %0, i64 368
  %234 = getelementptr inbounds i8, ptr %0, i64 480
  %235 = getelementptr inbounds i8, ptr %0, i64 24
  %236 = getelementptr inbounds i8, ptr %0, i64 528
  %237 = getelementptr inbounds i8, ptr %0, i64 48
  %238 = getelementptr inbounds i8, ptr %0, i64 72
  %239 = getelementptr inbounds i8, ptr %0, i64 384
  %240 = getelementptr inbounds i8, ptr %0, i64 600
  %241 = getelementptr inbounds i8, ptr %0, i64 576
  %242 = getelementptr inbounds i8, ptr %0, i64 384
  %243 = getelementptr inbounds i8, ptr %0, i64 600
  %244 = getelementptr inbounds i8, ptr %0, i64 576
  %245 = getelementptr inbounds i8, ptr %0, i64 600
  %246 = getelementptr inbounds i8, ptr %0, i64 576
  %247 = getelementptr inbounds i8, ptr %0, i64 168
  %248 = getelementptr inbounds i8, ptr %0, i64 248
  %249 = getelementptr inbounds i8, ptr %0, i64 192
  %250 = getelementptr inbounds i8, ptr %0, i64 216
  %251 = getelementptr inbounds i8, ptr %0, i64 1344
  %252 = getelementptr inbounds i8, ptr %0, i64 1360
  %253 = getelementptr inbounds i8, ptr %0, i64 888
  %254 = getelementptr inbounds i8, ptr %0, i64 168
  %255 = getelementptr inbounds i8, ptr %0, i64 984
  %256 = getelementptr inbounds i8, ptr %0, i64 912
  %257 = getelementptr inbounds i8, ptr %0, i64 864
  %258 = getelementptr inbounds i8, ptr %0, i64 936
  %259 = getelementptr inbounds i8, ptr %0, i64 368
  %260 = getelementptr inbounds i8, ptr %0, i64 528
  %261 = getelementptr inbounds i8, ptr %0, i64 552
  %262 = getelementptr inbounds i8, ptr %0, i64 408
  %263 = getelementptr inbounds i8, ptr %0, i64 24
  %264 = getelementptr inbounds i8, ptr %0, i64 48
  %265 = getelementptr inbounds i8, ptr %0, i64 72
  %266 = getelementptr inbounds i8, ptr %0, i64 96
  %267 = getelementptr inbounds i8, ptr %0, i64 168
  %268 = getelementptr inbounds i8, ptr %0, i64 248
  %269 = getelementptr inbounds i8, ptr %0, i64 192
  %270 = getelementptr inbounds i8, ptr %0, i64 216
  %271 = getelementptr inbounds i8, ptr %0, i64 384
  %272 = getelementptr inbounds i8, ptr %0, i64 480
  %273 = getelementptr inbounds i8, ptr %0, i64 24
  %274 = getelementptr inbounds i8, ptr %0, i64 48
  %275 = getelementptr inbounds i8, ptr %0, i64 72
  %276 = getelementptr inbounds i8, ptr %0, i64 456
  %277 = getelementptr inbounds i8, ptr %0, i64 408
  %278 = getelementptr inbounds i8, ptr %0, i64 456
  %279 = getelementptr inbounds i8, ptr %0, i64 248
  %280 = getelementptr inbounds i8, ptr %0, i64 336
  %281 = getelementptr inbounds i8, ptr %0, i64 168
  %282 = getelementptr inbounds i8, ptr %0, i64 248
  %283 = getelementptr inbounds i8, ptr %0, i64 192
  %284 = getelementptr inbounds i8, ptr %0, i64 216
  %285 = getelementptr inbounds i8, ptr %0, i64 248
  %286 = getelementptr inbounds i8, ptr %0, i64 768
  br label %287

287:                                              ; preds = %2150, %183
  %288 = load ptr, ptr %186, align 8
  %289 = load ptr, ptr %187, align 8
  %290 = load ptr, ptr %188, align 8
  %291 = getelementptr inbounds i8, ptr %290, i64 56
  %292 = load i64, ptr %291, align 8
  %293 = icmp eq i64 %292, 0
  br i1 %293, label %2135, label %294

294:                                              ; preds = %287
  %295 = load ptr, ptr %189, align 8
  %296 = load ptr, ptr %190, align 8
  %297 = load ptr, ptr %0, align 8
  %298 = load i64, ptr %191, align 8
  %299 = load ptr, ptr %192, align 8
  %300 = load i64, ptr %299, align 8
  %301 = icmp ne i64 %300, 1
  %302 = getelementptr inbounds i8, ptr %297, i64 8
  %303 = load i64, ptr %302, align 8
  %304 = icmp slt i64 %303, 1
  %305 = getelementptr inbounds i8, ptr %297, i64 32
  %306 = load i64, ptr %305, align 8
  %307 = icmp eq i64 %306, 1
  %308 = load ptr, ptr %193, align 8
  %309 = getelementptr inbounds i8, ptr %308, i64 8
  %310 = load i64, ptr %309, align 8
  %311 = icmp sgt i64 %310, 0
  %312 = load i64, ptr %194, align 8
  %313 = getelementptr double, ptr %295, i64 %312
  %314 = getelementptr i8, ptr %313, i64 -8
  %315 = load double, ptr %314, align 8
  %316 = load double, ptr %295, align 8
  %317 = fsub double %315, %316
  %318 = fmul double %317, 0x3D70000000000000
  %319 = load ptr, ptr %195, align 8
  %320 = load i64, ptr %297, align 8
  %321 = mul nsw i64 %320, %298
  %322 = getelementptr inbounds double, ptr %319, i64 %321
  %323 = load double, ptr %288, align 8
  %324 = getelementptr inbounds i8, ptr %288, i64 8
  %325 = load double, ptr %324, align 8
  %326 = load i64, ptr %290, align 8
  %327 = icmp eq i64 %326, 0
  br i1 %327, label %328, label %588

328:                                              ; preds = %294
  %329 = load i64, ptr %196, align 8
  %330 = icmp eq i64 %329, 0
  br i1 %330, label %360, label %331

331:                                              ; preds = %328
  %332 = icmp sgt i64 %329, 0
  br i1 %332, label %333, label %348

333:                                              ; preds = %331
  %334 = load ptr, ptr %197, align 8
  br label %335

335:                                              ; preds = %333, %335
  %336 = phi i64 [ 0, %333 ], [ %346, %335 ]
  %337 = phi i64 [ %329, %333 ], [ %345, %335 ]
  %338 = add nuw nsw i64 %336, %337
  %339 = lshr i64 %338, 1
  %340 = mul i64 %339, 24
  %341 = getelementptr inbounds i8, ptr %334, i64 %340
  %342 = load double, ptr %341, align 8
  %343 = fcmp ogt double %342, %323
  %344 = add nuw nsw i64 %339, 1
  %345 = select i1 %343, i64 %339, i64 %337
  %346 = select i1 %343, i64 %336, i64 %344
  %347 = icmp slt i64 %346, %345
  br i1 %347, label %335, label %348, !llvm.loop !9

348:                                              ; preds = %335, %331
  %349 = phi i64 [ 0, %331 ], [ %346, %335 ]
  %350 = icmp slt i64 %349, %329
  br i1 %350, label %351, label %357

351:                                              ; preds = %348
  %352 = load ptr, ptr %197, align 8
  %353 = mul i64 %349, 24
  %354 = getelementptr inbounds i8, ptr %352, i64 %353
  %355 = getelementptr inbounds i8, ptr %354, i64 8
  %356 = load double, ptr %355, align 8
  br label %357

357:                                              ; preds = %351, %348
  %358 = phi double [ %356, %351 ], [ 0x7FF0000000000000, %348 ]
  %359 = load ptr, ptr %198, align 8
  store double %358, ptr %359, align 8
  br label %360

360:                                              ; preds = %357, %328
  %361 = getelementptr inbounds i8, ptr %290, i64 24
  %362 = load i64, ptr %361, align 8
  %363 = add nsw i64 %362, 1
  store i64 %363, ptr %361, align 8
  %364 = load ptr, ptr %185, align 8
  %365 = load ptr, ptr %195, align 8
  %366 = load ptr, ptr %199, align 8
  store double %323, ptr %366, align 8
  %367 = load ptr, ptr %184, align 8
  %368 = getelementptr inbounds i8, ptr %367, i64 40
  %369 = load i64, ptr %368, align 8
  %370 = icmp eq i64 %369, 0
  br i1 %370, label %372, label %371

371:                                              ; preds = %360
  tail call fastcc void @settle(ptr noundef nonnull %184) #11
  br label %372

372:                                              ; preds = %371, %360
  %373 = load i64, ptr %200, align 8
  %374 = icmp sgt i64 %373, 0
  br i1 %374, label %375, label %376

375:                                              ; preds = %372
  tail call fastcc void @sample(ptr noundef nonnull %184) #11
  br label %376

376:                                              ; preds = %372, %375
  %377 = load ptr, ptr %184, align 8
  %378 = load i64, ptr %377, align 8
  %379 = load ptr, ptr %199, align 8
  %380 = load ptr, ptr %201, align 8
  %381 = load ptr, ptr %202, align 8
  %382 = inttoptr i64 %378 to ptr
  %383 = load ptr, ptr %382, align 8
  %384 = tail call i32 %383(ptr noundef %379, ptr noundef %364, ptr noundef %380, ptr noundef %381, ptr noundef %365) #10
  %385 = icmp eq i32 %384, 0
  br i1 %385, label %390, label %386

386:                                              ; preds = %376
  %387 = getelementptr inbounds i8, ptr %290, i64 72
  store i64 3, ptr %387, align 8
  %388 = icmp slt i32 %384, 0
  %389 = select i1 %388, i64 -4, i64 2
  br label %2135

390:                                              ; preds = %376
  store i64 1, ptr %290, align 8
  %391 = getelementptr inbounds i8, ptr %288, i64 24
  store double 1.000000e-04, ptr %391, align 8
  %392 = getelementptr inbounds i8, ptr %296, i64 40
  %393 = load double, ptr %392, align 8
  %394 = getelementptr inbounds i8, ptr %288, i64 40
  store double %393, ptr %394, align 8
  %395 = load ptr, ptr %185, align 8
  %396 = load ptr, ptr %184, align 8
  %397 = getelementptr inbounds i8, ptr %396, i64 8
  %398 = load i64, ptr %397, align 8
  %399 = load i64, ptr %194, align 8
  %400 = load ptr, ptr %189, align 8
  %401 = load ptr, ptr %188, align 8
  %402 = getelementptr inbounds i8, ptr %401, i64 48
  %403 = load i64, ptr %402, align 8
  %404 = icmp slt i64 %403, %399
  br i1 %404, label %405, label %428

405:                                              ; preds = %390
  %406 = icmp sgt i64 %398, 0
  br label %407

407:                                              ; preds = %405, %418
  %408 = phi i64 [ %403, %405 ], [ %419, %418 ]
  %409 = getelementptr inbounds double, ptr %400, i64 %408
  %410 = load double, ptr %409, align 8
  %411 = load ptr, ptr %186, align 8
  %412 = load double, ptr %411, align 8
  %413 = fcmp ugt double %410, %412
  br i1 %413, label %428, label %414

414:                                              ; preds = %407
  br i1 %406, label %415, label %418

415:                                              ; preds = %414
  %416 = mul nsw i64 %408, %398
  %417 = getelementptr double, ptr %1, i64 %416
  br label %421

418:                                              ; preds = %421, %414
  %419 = add i64 %408, 1
  %420 = icmp eq i64 %419, %399
  br i1 %420, label %428, label %407, !llvm.loop !10

421:                                              ; preds = %415, %421
  %422 = phi i64 [ 0, %415 ], [ %426, %421 ]
  %423 = getelementptr inbounds double, ptr %395, i64 %422
  %424 = load double, ptr %423, align 8
  %425 = getelementptr double, ptr %417, i64 %422
  store double %424, ptr %425, align 8
  %426 = add nuw nsw i64 %422, 1
  %427 = icmp eq i64 %426, %398
  br i1 %427, label %418, label %421, !llvm.loop !11

428:                                              ; preds = %407, %418, %390
  %429 = phi i64 [ %403, %390 ], [ %408, %407 ], [ %399, %418 ]
  %430 = load ptr, ptr %188, align 8
  %431 = getelementptr inbounds i8, ptr %430, i64 48
  store i64 %429, ptr %431, align 8
  %432 = icmp eq i64 %429, %399
  br i1 %432, label %2135, label %433

433:                                              ; preds = %428
  %434 = fcmp oeq double %325, 0.000000e+00
  br i1 %434, label %435, label %588

435:                                              ; preds = %433
  %436 = load ptr, ptr %184, align 8
  %437 = getelementptr inbounds i8, ptr %436, i64 24
  %438 = load i64, ptr %437, align 8
  %439 = load ptr, ptr %186, align 8
  %440 = getelementptr inbounds i8, ptr %439, i64 16
  %441 = load double, ptr %440, align 8
  %442 = load ptr, ptr %185, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %442, ptr noundef %442, ptr noundef nonnull %185, i64 noundef %438) #11
  %443 = load double, ptr %6, align 8
  %444 = load ptr, ptr %203, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %444, ptr noundef %442, ptr noundef nonnull %185, i64 noundef %438) #11
  %445 = load double, ptr %7, align 8
  %446 = fcmp uge double %443, 1.000000e-05
  %447 = fcmp uge double %445, 1.000000e-05
  %448 = and i1 %446, %447
  %449 = fmul double %443, 1.000000e-02
  %450 = fdiv double %449, %445
  %451 = select i1 %448, double %450, double 0x3EB0C6F7A0B5ED8D
  %452 = fcmp olt double %441, %451
  %453 = select i1 %452, double %441, double %451
  %454 = load ptr, ptr %184, align 8
  %455 = getelementptr inbounds i8, ptr %454, i64 8
  %456 = load i64, ptr %455, align 8
  %457 = icmp sgt i64 %456, 0
  br i1 %457, label %488, label %458

458:                                              ; preds = %488, %435
  %459 = load ptr, ptr %188, align 8
  %460 = getelementptr inbounds i8, ptr %459, i64 24
  %461 = load i64, ptr %460, align 8
  %462 = add nsw i64 %461, 1
  store i64 %462, ptr %460, align 8
  %463 = fadd double %323, %453
  %464 = load ptr, ptr %205, align 8
  %465 = load ptr, ptr %195, align 8
  %466 = load i64, ptr %191, align 8
  %467 = getelementptr inbounds double, ptr %465, i64 %466
  %468 = load ptr, ptr %199, align 8
  store double %463, ptr %468, align 8
  %469 = load ptr, ptr %184, align 8
  %470 = getelementptr inbounds i8, ptr %469, i64 40
  %471 = load i64, ptr %470, align 8
  %472 = icmp eq i64 %471, 0
  br i1 %472, label %474, label %473

473:                                              ; preds = %458
  tail call fastcc void @settle(ptr noundef nonnull %184) #11
  br label %474

474:                                              ; preds = %473, %458
  %475 = load i64, ptr %200, align 8
  %476 = icmp sgt i64 %475, 0
  br i1 %476, label %477, label %478

477:                                              ; preds = %474
  tail call fastcc void @sample(ptr noundef nonnull %184) #11
  br label %478

478:                                              ; preds = %474, %477
  %479 = load ptr, ptr %184, align 8
  %480 = load i64, ptr %479, align 8
  %481 = load ptr, ptr %199, align 8
  %482 = load ptr, ptr %201, align 8
  %483 = load ptr, ptr %202, align 8
  %484 = inttoptr i64 %480 to ptr
  %485 = load ptr, ptr %484, align 8
  %486 = tail call i32 %485(ptr noundef %481, ptr noundef %464, ptr noundef %482, ptr noundef %483, ptr noundef %467) #10
  %487 = icmp eq i32 %486, 0
  br i1 %487, label %507, label %505

488:                                              ; preds = %435, %488
  %489 = phi i64 [ %500, %488 ], [ 0, %435 ]
  %490 = load ptr, ptr %185, align 8
  %491 = getelementptr inbounds double, ptr %490, i64 %489
  %492 = load double, ptr %491, align 8
  %493 = load ptr, ptr %195, align 8
  %494 = getelementptr inbounds double, ptr %493, i64 %489
  %495 = load double, ptr %494, align 8
  %496 = fmul double %453, %495
  %497 = fadd double %492, %496
  %498 = load ptr, ptr %204, align 8
  %499 = getelementptr inbounds double, ptr %498, i64 %489
  store double %497, ptr %499, align 8
  %500 = add nuw nsw i64 %489, 1
  %501 = load ptr, ptr %184, align 8
  %502 = getelementptr inbounds i8, ptr %501, i64 8
  %503 = load i64, ptr %502, align 8
  %504 = icmp slt i64 %500, %503
  br i1 %504, label %488, label %458, !llvm.loop !12

505:                                              ; preds = %478
  %506 = fmul double %453, 1.000000e-03
  br label %583

507:                                              ; preds = %478
  %508 = load ptr, ptr %190, align 8
  %509 = load double, ptr %508, align 8
  %510 = load ptr, ptr %203, align 8
  %511 = load i64, ptr %206, align 8
  %512 = getelementptr inbounds double, ptr %510, i64 %511
  %513 = icmp sgt i64 %438, 0
  br i1 %513, label %514, label %523

514:                                              ; preds = %507, %514
  %515 = phi i64 [ %521, %514 ], [ 0, %507 ]
  %516 = getelementptr inbounds double, ptr %512, i64 %515
  %517 = load double, ptr %516, align 8
  %518 = getelementptr inbounds double, ptr %510, i64 %515
  %519 = load double, ptr %518, align 8
  %520 = fsub double %517, %519
  store double %520, ptr %516, align 8
  %521 = add nuw nsw i64 %515, 1
  %522 = icmp eq i64 %521, %438
  br i1 %522, label %523, label %514, !llvm.loop !13

523:                                              ; preds = %514, %507
  %524 = load ptr, ptr %185, align 8
  call fastcc void @norm_to(ptr noundef nonnull %8, ptr noundef %512, ptr noundef %524, ptr noundef nonnull %185, i64 noundef %438) #11
  %525 = load double, ptr %8, align 8
  %526 = fdiv double %525, %453
  %527 = fcmp ogt double %445, %526
  %528 = select i1 %527, double %445, double %526
  %529 = fcmp ule double %528, 1.000000e-15
  %530 = fdiv double 1.000000e-02, %528
  %531 = select i1 %529, double 1.000000e+13, double %530
  %532 = bitcast double %531 to i64
  %533 = add nsw i64 %532, -4604544271217802189
  %534 = ashr i64 %533, 52
  %535 = and i64 %533, -4503599627370496
  %536 = sub nsw i64 %532, %535
  %537 = bitcast i64 %536 to double
  %538 = fadd double %537, -1.000000e+00
  %539 = fadd double %537, 1.000000e+00
  %540 = fdiv double %538, %539
  %541 = fmul double %540, %540
  %542 = tail call double @llvm.fma.f64(double %541, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %543 = tail call double @llvm.fma.f64(double %542, double %541, double 0x3FE2776C50EF9BFE)
  %544 = tail call double @llvm.fma.f64(double %543, double %541, double 0x3FEEC709DC3A03FD)
  %545 = tail call double @llvm.fma.f64(double %544, double %541, double 0x40071547652B82FE)
  %546 = trunc nsw i64 %534 to i32
  %547 = sitofp i32 %546 to double
  %548 = fmul double %540, %545
  %549 = fadd double %548, %547
  %550 = fmul double %509, %549
  %551 = fcmp ogt double %550, -1.000000e+03
  %552 = select i1 %551, double %550, double -1.000000e+03
  %553 = fcmp olt double %552, 1.000000e+03
  %554 = select i1 %553, double %552, double 1.000000e+03
  %555 = tail call double @llvm.rint.f64(double %554)
  %556 = fsub double %554, %555
  %557 = tail call double @llvm.fma.f64(double %556, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %558 = tail call double @llvm.fma.f64(double %557, double %556, double 0x3F55D87FE78A6730)
  %559 = tail call double @llvm.fma.f64(double %558, double %556, double 0x3F83B2AB6FBA4E77)
  %560 = tail call double @llvm.fma.f64(double %559, double %556, double 0x3FAC6B08D704A0BF)
  %561 = tail call double @llvm.fma.f64(double %560, double %556, double 0x3FCEBFBDFF82C58E)
  %562 = tail call double @llvm.fma.f64(double %561, double %556, double 0x3FE62E42FEFA39EF)
  %563 = tail call double @llvm.fma.f64(double %562, double %556, double 1.000000e+00)
  %564 = bitcast double %563 to i64
  %565 = fptosi double %555 to i32
  %566 = sext i32 %565 to i64
  %567 = shl nsw i64 %566, 52
  %568 = add nsw i64 %567, %564
  %569 = bitcast i64 %568 to double
  %570 = fmul double %453, 1.000000e-03
  %571 = fcmp olt double %570, 0x3EB0C6F7A0B5ED8D
  %572 = select i1 %571, double 0x3EB0C6F7A0B5ED8D, double %570
  %573 = fmul double %453, 1.000000e+02
  %574 = select i1 %529, double %572, double %569
  %575 = fcmp olt double %573, %574
  %576 = select i1 %575, double %573, double %574
  %577 = tail call double @llvm.fabs.f64(double %323)
  %578 = fmul double %577, 0x3D30000000000000
  %579 = fcmp ogt double %578, %576
  %580 = select i1 %579, double %578, double %576
  %581 = fcmp olt double %441, %580
  %582 = select i1 %581, double %441, double %580
  br label %583

583:                                              ; preds = %505, %523
  %584 = phi double [ %506, %505 ], [ %582, %523 ]
  %585 = tail call i1 @llvm.is.fpclass.f64(double %584, i32 639)
  br i1 %585, label %586, label %588

586:                                              ; preds = %583
  %587 = getelementptr inbounds i8, ptr %290, i64 72
  store i64 4, ptr %587, align 8
  br label %588

588:                                              ; preds = %586, %583, %433, %294
  %589 = phi double [ %584, %583 ], [ %584, %586 ], [ %325, %433 ], [ %325, %294 ]
  %590 = load i64, ptr %291, align 8
  %591 = icmp eq i64 %590, 0
  br i1 %591, label %621, label %592

592:                                              ; preds = %588
  %593 = getelementptr inbounds i8, ptr %290, i64 8
  %594 = getelementptr inbounds i8, ptr %290, i64 16
  %595 = getelementptr inbounds i8, ptr %290, i64 64
  %596 = getelementptr inbounds i8, ptr %290, i64 48
  %597 = getelementptr inbounds i8, ptr %288, i64 16
  %598 = getelementptr inbounds i8, ptr %290, i64 24
  %599 = icmp sgt i64 %298, 0
  %600 = select i1 %301, i1 %307, i1 false
  %601 = getelementptr inbounds i8, ptr %288, i64 32
  %602 = getelementptr inbounds i8, ptr %290, i64 48
  %603 = getelementptr inbounds i8, ptr %290, i64 72
  %604 = getelementptr inbounds i8, ptr %288, i64 24
  %605 = getelementptr inbounds i8, ptr %288, i64 40
  %606 = getelementptr inbounds i8, ptr %296, i64 24
  %607 = getelementptr inbounds i8, ptr %296, i64 8
  %608 = getelementptr inbounds i8, ptr %296, i64 16
  %609 = getelementptr inbounds i8, ptr %296, i64 32
  %610 = getelementptr inbounds i8, ptr %296, i64 40
  %611 = getelementptr inbounds i8, ptr %296, i64 40
  %612 = icmp sgt i64 %298, 0
  %613 = getelementptr inbounds i8, ptr %290, i64 48
  %614 = getelementptr inbounds i8, ptr %290, i64 72
  %615 = getelementptr inbounds i8, ptr %290, i64 72
  %616 = getelementptr inbounds i8, ptr %288, i64 40
  %617 = getelementptr inbounds i8, ptr %290, i64 72
  %618 = getelementptr inbounds i8, ptr %296, i64 24
  %619 = getelementptr inbounds i8, ptr %296, i64 32
  %620 = getelementptr inbounds i8, ptr %288, i64 40
  br label %623

621:                                              ; preds = %2132, %588
  %622 = phi double [ %589, %588 ], [ %2128, %2132 ]
  store double %622, ptr %324, align 8
  br label %2135

623:                                              ; preds = %592, %2132
  %624 = phi i64 [ %590, %592 ], [ %2133, %2132 ]
  %625 = phi i64 [ undef, %592 ], [ %2131, %2132 ]
  %626 = phi double [ %323, %592 ], [ %2129, %2132 ]
  %627 = phi double [ %589, %592 ], [ %2128, %2132 ]
  %628 = load ptr, ptr %207, align 8
  %629 = getelementptr inbounds i8, ptr %628, i64 8
  %630 = load i64, ptr %629, align 8
  %631 = icmp sgt i64 %630, 0
  br i1 %631, label %632, label %637

632:                                              ; preds = %623
  %633 = load i64, ptr %628, align 8
  %634 = add nsw i64 %633, 3
  %635 = icmp slt i64 %630, %634
  %636 = zext i1 %635 to i32
  br label %637

637:                                              ; preds = %623, %632
  %638 = phi i32 [ 0, %623 ], [ %636, %632 ]
  %639 = icmp eq i32 %638, 0
  br i1 %639, label %641, label %640

640:                                              ; preds = %637
  store double %627, ptr %324, align 8
  br label %2135

641:                                              ; preds = %637
  %642 = add nsw i64 %624, -1
  store i64 %642, ptr %291, align 8
  %643 = load i64, ptr %593, align 8
  %644 = load i64, ptr %594, align 8
  %645 = add nsw i64 %644, %643
  %646 = load i64, ptr %595, align 8
  %647 = icmp slt i64 %645, %646
  br i1 %647, label %649, label %648

648:                                              ; preds = %641
  store double %627, ptr %324, align 8
  br label %2135

649:                                              ; preds = %641
  %650 = load i64, ptr %208, align 8
  %651 = icmp eq i64 %650, 0
  br i1 %651, label %685, label %652

652:                                              ; preds = %649
  %653 = icmp sgt i64 %650, 0
  br i1 %653, label %654, label %669

654:                                              ; preds = %652
  %655 = load ptr, ptr %209, align 8
  br label %656

656:                                              ; preds = %654, %656
  %657 = phi i64 [ 0, %654 ], [ %667, %656 ]
  %658 = phi i64 [ %650, %654 ], [ %666, %656 ]
  %659 = add nuw nsw i64 %657, %658
  %660 = lshr i64 %659, 1
  %661 = mul i64 %660, 24
  %662 = getelementptr inbounds i8, ptr %655, i64 %661
  %663 = load double, ptr %662, align 8
  %664 = fcmp ogt double %663, %626
  %665 = add nuw nsw i64 %660, 1
  %666 = select i1 %664, i64 %660, i64 %658
  %667 = select i1 %664, i64 %657, i64 %665
  %668 = icmp slt i64 %667, %666
  br i1 %668, label %656, label %669, !llvm.loop !9

669:                                              ; preds = %656, %652
  %670 = phi i64 [ 0, %652 ], [ %667, %656 ]
  %671 = load ptr, ptr %209, align 8
  %672 = mul i64 %670, 24
  %673 = getelementptr inbounds i8, ptr %671, i64 %672
  %674 = icmp slt i64 %670, %650
  br i1 %674, label %675, label %678

675:                                              ; preds = %669
  %676 = getelementptr inbounds i8, ptr %673, i64 8
  %677 = load double, ptr %676, align 8
  br label %678

678:                                              ; preds = %675, %669
  %679 = phi double [ %677, %675 ], [ 0x7FF0000000000000, %669 ]
  %680 = load ptr, ptr %210, align 8
  store double %679, ptr %680, align 8
  %681 = load i64, ptr %208, align 8
  %682 = icmp slt i64 %670, %681
  br i1 %682, label %683, label %685

683:                                              ; preds = %678
  %684 = load double, ptr %673, align 8
  br label %685

685:                                              ; preds = %649, %678, %683
  %686 = phi double [ 0x7FF0000000000000, %649 ], [ %684, %683 ], [ 0x7FF0000000000000, %678 ]
  br i1 %304, label %687, label %691

687:                                              ; preds = %685
  %688 = load i64, ptr %596, align 8
  %689 = getelementptr inbounds double, ptr %295, i64 %688
  %690 = load double, ptr %689, align 8
  br label %691

691:                                              ; preds = %687, %685
  %692 = phi double [ %690, %687 ], [ %315, %685 ]
  %693 = fcmp olt double %692, %686
  %694 = select i1 %693, double %692, double %686
  br i1 %304, label %699, label %695

695:                                              ; preds = %691
  %696 = load double, ptr %597, align 8
  %697 = fcmp olt double %627, %696
  %698 = select i1 %697, double %627, double %696
  br label %705

699:                                              ; preds = %691
  %700 = fsub double %694, %626
  %701 = fdiv double %700, %627
  %702 = fmul double %701, 0x3FEFFFFFFFFFDCD1
  %703 = tail call double @llvm.ceil.f64(double %702)
  %704 = fdiv double %700, %703
  br label %705

705:                                              ; preds = %699, %695
  %706 = phi double [ %698, %695 ], [ %704, %699 ]
  %707 = fadd double %626, %706
  %708 = fmul double %706, 1.000000e-03
  %709 = fsub double %694, %708
  %710 = fcmp ule double %707, %709
  %711 = select i1 %710, double %707, double %694
  %712 = fsub double %711, %626
  %713 = fmul double %712, 6.250000e-02
  %714 = fadd double %626, %713
  %715 = fcmp ule double %714, %626
  %716 = fcmp une double %711, %694
  %717 = and i1 %716, %715
  br i1 %717, label %718, label %719

718:                                              ; preds = %705
  store double %712, ptr %324, align 8
  br label %2127

719:                                              ; preds = %705
  %720 = load ptr, ptr %0, align 8
  %721 = load i64, ptr %720, align 8
  %722 = load ptr, ptr %211, align 8
  %723 = insertelement <8 x double> poison, double %712, i64 0
  %724 = shufflevector <8 x double> %723, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %724, ptr %722, align 8
  %725 = icmp sgt i64 %721, 1
  br i1 %725, label %730, label %821

726:                                              ; preds = %809
  %727 = add nuw nsw i64 %733, 1
  %728 = icmp slt i64 %727, %721
  %729 = icmp eq i64 %727, %721
  br i1 %729, label %821, label %730, !llvm.loop !14

730:                                              ; preds = %719, %726
  %731 = phi i1 [ %728, %726 ], [ %725, %719 ]
  %732 = phi i64 [ %820, %726 ], [ undef, %719 ]
  %733 = phi i64 [ %727, %726 ], [ 1, %719 ]
  %734 = load ptr, ptr %212, align 8
  %735 = load ptr, ptr %185, align 8
  %736 = load ptr, ptr %184, align 8
  %737 = getelementptr inbounds i8, ptr %736, i64 16
  %738 = load i64, ptr %737, align 8
  %739 = icmp sgt i64 %738, 1
  %740 = zext i1 %739 to i64
  %741 = load ptr, ptr %213, align 8
  %742 = getelementptr inbounds i64, ptr %741, i64 %733
  %743 = load i64, ptr %742, align 8
  %744 = getelementptr i8, ptr %742, i64 8
  %745 = load i64, ptr %744, align 8
  %746 = xor i64 %743, -1
  %747 = add i64 %745, %746
  %748 = load ptr, ptr %211, align 8
  %749 = load ptr, ptr %214, align 8
  %750 = load ptr, ptr %215, align 8
  %751 = getelementptr inbounds i64, ptr %750, i64 %743
  %752 = load ptr, ptr %216, align 8
  %753 = getelementptr inbounds double, ptr %752, i64 %743
  tail call fastcc void @combine(ptr noundef %734, ptr noundef %735, ptr noundef %748, ptr noundef %749, ptr noundef %751, ptr noundef %753, i64 noundef %747, i64 noundef %740, i64 noundef %738) #11
  %754 = icmp eq i64 %738, 1
  br i1 %754, label %755, label %786

755:                                              ; preds = %730
  %756 = load ptr, ptr %213, align 8
  %757 = getelementptr i64, ptr %756, i64 %733
  %758 = getelementptr i8, ptr %757, i64 8
  %759 = load i64, ptr %758, align 8
  %760 = add nsw i64 %759, -1
  %761 = load ptr, ptr %216, align 8
  %762 = getelementptr inbounds double, ptr %761, i64 %760
  %763 = load double, ptr %762, align 8
  %764 = fmul double %712, %763
  %765 = load ptr, ptr %214, align 8
  %766 = load ptr, ptr %215, align 8
  %767 = getelementptr inbounds i64, ptr %766, i64 %760
  %768 = load i64, ptr %767, align 8
  %769 = getelementptr inbounds double, ptr %765, i64 %768
  %770 = load ptr, ptr %184, align 8
  %771 = getelementptr inbounds i8, ptr %770, i64 8
  %772 = load i64, ptr %771, align 8
  %773 = icmp sgt i64 %772, 0
  br i1 %773, label %774, label %786

774:                                              ; preds = %755, %774
  %775 = phi i64 [ %781, %774 ], [ 0, %755 ]
  %776 = getelementptr inbounds double, ptr %769, i64 %775
  %777 = load double, ptr %776, align 8
  %778 = getelementptr inbounds double, ptr %734, i64 %775
  %779 = load double, ptr %778, align 8
  %780 = tail call double @llvm.fma.f64(double %764, double %777, double %779)
  store double %780, ptr %778, align 8
  %781 = add nuw nsw i64 %775, 1
  %782 = load ptr, ptr %184, align 8
  %783 = getelementptr inbounds i8, ptr %782, i64 8
  %784 = load i64, ptr %783, align 8
  %785 = icmp slt i64 %781, %784
  br i1 %785, label %774, label %786, !llvm.loop !15

786:                                              ; preds = %774, %755, %730
  %787 = load ptr, ptr %214, align 8
  %788 = load i64, ptr %217, align 8
  %789 = mul nsw i64 %788, %733
  %790 = getelementptr inbounds double, ptr %787, i64 %789
  %791 = load i64, ptr %598, align 8
  %792 = add nsw i64 %791, 1
  store i64 %792, ptr %598, align 8
  %793 = load ptr, ptr %218, align 8
  %794 = getelementptr inbounds double, ptr %793, i64 %733
  %795 = load double, ptr %794, align 8
  %796 = fmul double %712, %795
  %797 = fadd double %626, %796
  %798 = load ptr, ptr %212, align 8
  %799 = load ptr, ptr %219, align 8
  store double %797, ptr %799, align 8
  %800 = load ptr, ptr %184, align 8
  %801 = getelementptr inbounds i8, ptr %800, i64 40
  %802 = load i64, ptr %801, align 8
  %803 = icmp eq i64 %802, 0
  br i1 %803, label %805, label %804

804:                                              ; preds = %786
  tail call fastcc void @settle(ptr noundef nonnull %184) #11
  br label %805

805:                                              ; preds = %804, %786
  %806 = load i64, ptr %220, align 8
  %807 = icmp sgt i64 %806, 0
  br i1 %807, label %808, label %809

808:                                              ; preds = %805
  tail call fastcc void @sample(ptr noundef nonnull %184) #11
  br label %809

809:                                              ; preds = %805, %808
  %810 = load ptr, ptr %184, align 8
  %811 = load i64, ptr %810, align 8
  %812 = load ptr, ptr %219, align 8
  %813 = load ptr, ptr %221, align 8
  %814 = load ptr, ptr %222, align 8
  %815 = inttoptr i64 %811 to ptr
  %816 = load ptr, ptr %815, align 8
  %817 = tail call i32 %816(ptr noundef %812, ptr noundef %798, ptr noundef %813, ptr noundef %814, ptr noundef %790) #10
  %818 = sext i32 %817 to i64
  %819 = icmp eq i32 %817, 0
  %820 = select i1 %819, i64 %732, i64 %818
  br i1 %819, label %726, label %821

821:                                              ; preds = %726, %809, %719
  %822 = phi i1 [ %725, %719 ], [ %728, %726 ], [ %731, %809 ]
  %823 = phi i64 [ 0, %719 ], [ %818, %809 ], [ %818, %726 ]
  %824 = phi i64 [ undef, %719 ], [ %820, %809 ], [ %820, %726 ]
  br i1 %822, label %878, label %825

825:                                              ; preds = %821
  %826 = load ptr, ptr %223, align 8
  %827 = load ptr, ptr %185, align 8
  %828 = load ptr, ptr %184, align 8
  %829 = getelementptr inbounds i8, ptr %828, i64 16
  %830 = load i64, ptr %829, align 8
  %831 = icmp sgt i64 %830, 1
  %832 = zext i1 %831 to i64
  %833 = load ptr, ptr %224, align 8
  %834 = getelementptr inbounds i64, ptr %833, i64 %721
  %835 = load i64, ptr %834, align 8
  %836 = getelementptr i8, ptr %834, i64 8
  %837 = load i64, ptr %836, align 8
  %838 = xor i64 %835, -1
  %839 = add i64 %837, %838
  %840 = load ptr, ptr %211, align 8
  %841 = load ptr, ptr %225, align 8
  %842 = load ptr, ptr %226, align 8
  %843 = getelementptr inbounds i64, ptr %842, i64 %835
  %844 = load ptr, ptr %227, align 8
  %845 = getelementptr inbounds double, ptr %844, i64 %835
  tail call fastcc void @combine(ptr noundef %826, ptr noundef %827, ptr noundef %840, ptr noundef %841, ptr noundef %843, ptr noundef %845, i64 noundef %839, i64 noundef %832, i64 noundef %830) #11
  %846 = icmp eq i64 %830, 1
  br i1 %846, label %847, label %878

847:                                              ; preds = %825
  %848 = load ptr, ptr %224, align 8
  %849 = getelementptr i64, ptr %848, i64 %721
  %850 = getelementptr i8, ptr %849, i64 8
  %851 = load i64, ptr %850, align 8
  %852 = add nsw i64 %851, -1
  %853 = load ptr, ptr %227, align 8
  %854 = getelementptr inbounds double, ptr %853, i64 %852
  %855 = load double, ptr %854, align 8
  %856 = fmul double %712, %855
  %857 = load ptr, ptr %225, align 8
  %858 = load ptr, ptr %226, align 8
  %859 = getelementptr inbounds i64, ptr %858, i64 %852
  %860 = load i64, ptr %859, align 8
  %861 = getelementptr inbounds double, ptr %857, i64 %860
  %862 = load ptr, ptr %184, align 8
  %863 = getelementptr inbounds i8, ptr %862, i64 8
  %864 = load i64, ptr %863, align 8
  %865 = icmp sgt i64 %864, 0
  br i1 %865, label %866, label %878

866:                                              ; preds = %847, %866
  %867 = phi i64 [ %873, %866 ], [ 0, %847 ]
  %868 = getelementptr inbounds double, ptr %861, i64 %867
  %869 = load double, ptr %868, align 8
  %870 = getelementptr inbounds double, ptr %826, i64 %867
  %871 = load double, ptr %870, align 8
  %872 = tail call double @llvm.fma.f64(double %856, double %869, double %871)
  store double %872, ptr %870, align 8
  %873 = add nuw nsw i64 %867, 1
  %874 = load ptr, ptr %184, align 8
  %875 = getelementptr inbounds i8, ptr %874, i64 8
  %876 = load i64, ptr %875, align 8
  %877 = icmp slt i64 %873, %876
  br i1 %877, label %866, label %878, !llvm.loop !15

878:                                              ; preds = %866, %847, %825, %821
  %879 = phi i64 [ %824, %821 ], [ %823, %825 ], [ %823, %847 ], [ %823, %866 ]
  %880 = icmp eq i64 %879, 0
  %881 = select i1 %880, i1 %307, i1 false
  br i1 %881, label %882, label %905

882:                                              ; preds = %878
  %883 = load i64, ptr %598, align 8
  %884 = add nsw i64 %883, 1
  store i64 %884, ptr %598, align 8
  %885 = load ptr, ptr %228, align 8
  store double %711, ptr %885, align 8
  %886 = load ptr, ptr %184, align 8
  %887 = getelementptr inbounds i8, ptr %886, i64 40
  %888 = load i64, ptr %887, align 8
  %889 = icmp eq i64 %888, 0
  br i1 %889, label %891, label %890

890:                                              ; preds = %882
  tail call fastcc void @settle(ptr noundef nonnull %184) #11
  br label %891

891:                                              ; preds = %890, %882
  %892 = load i64, ptr %229, align 8
  %893 = icmp sgt i64 %892, 0
  br i1 %893, label %894, label %895

894:                                              ; preds = %891
  tail call fastcc void @sample(ptr noundef nonnull %184) #11
  br label %895

895:                                              ; preds = %891, %894
  %896 = load ptr, ptr %184, align 8
  %897 = load i64, ptr %896, align 8
  %898 = load ptr, ptr %228, align 8
  %899 = load ptr, ptr %230, align 8
  %900 = load ptr, ptr %231, align 8
  %901 = inttoptr i64 %897 to ptr
  %902 = load ptr, ptr %901, align 8
  %903 = tail call i32 %902(ptr noundef %898, ptr noundef %289, ptr noundef %899, ptr noundef %900, ptr noundef %322) #10
  %904 = sext i32 %903 to i64
  br label %905

905:                                              ; preds = %895, %878
  %906 = phi i64 [ %904, %895 ], [ %879, %878 ]
  %907 = icmp slt i64 %906, 0
  br i1 %907, label %2127, label %908

908:                                              ; preds = %905
  %909 = icmp eq i64 %906, 0
  br i1 %909, label %910, label %1252

910:                                              ; preds = %908
  br i1 %304, label %911, label %912

911:                                              ; preds = %910
  br i1 %599, label %1201, label %1210

912:                                              ; preds = %910
  %913 = load ptr, ptr %184, align 8
  %914 = load ptr, ptr %0, align 8
  %915 = getelementptr inbounds i8, ptr %913, i64 24
  %916 = load i64, ptr %915, align 8
  %917 = getelementptr inbounds i8, ptr %914, i64 8
  %918 = load i64, ptr %917, align 8
  %919 = load ptr, ptr %232, align 8
  %920 = load i64, ptr %233, align 8
  %921 = getelementptr inbounds double, ptr %919, i64 %920
  %922 = icmp sgt i64 %918, 0
  br i1 %922, label %923, label %925

923:                                              ; preds = %912
  %924 = getelementptr inbounds i8, ptr %913, i64 32
  br label %933

925:                                              ; preds = %933, %912
  %926 = icmp sgt i64 %916, 0
  br i1 %926, label %927, label %990

927:                                              ; preds = %925
  %928 = load ptr, ptr %185, align 8
  %929 = load ptr, ptr %239, align 8
  %930 = load ptr, ptr %240, align 8
  %931 = load ptr, ptr %241, align 8
  %932 = load ptr, ptr %232, align 8
  br label %959

933:                                              ; preds = %923, %933
  %934 = phi i64 [ 0, %923 ], [ %957, %933 ]
  %935 = load i64, ptr %914, align 8
  %936 = load i64, ptr %924, align 8
  %937 = load ptr, ptr %232, align 8
  %938 = load i64, ptr %233, align 8
  %939 = mul nsw i64 %938, %934
  %940 = getelementptr inbounds double, ptr %937, i64 %939
  %941 = load ptr, ptr %234, align 8
  %942 = load ptr, ptr %235, align 8
  %943 = getelementptr i64, ptr %942, i64 %935
  %944 = getelementptr i8, ptr %943, i64 8
  %945 = getelementptr i64, ptr %944, i64 %934
  %946 = load i64, ptr %945, align 8
  %947 = getelementptr i8, ptr %945, i64 8
  %948 = load i64, ptr %947, align 8
  %949 = xor i64 %946, -1
  %950 = add i64 %948, %949
  %951 = load ptr, ptr %211, align 8
  %952 = load ptr, ptr %236, align 8
  %953 = load ptr, ptr %237, align 8
  %954 = getelementptr inbounds i64, ptr %953, i64 %946
  %955 = load ptr, ptr %238, align 8
  %956 = getelementptr inbounds double, ptr %955, i64 %946
  tail call fastcc void @combine(ptr noundef %940, ptr noundef %941, ptr noundef %951, ptr noundef %952, ptr noundef %954, ptr noundef %956, i64 noundef %950, i64 noundef 1, i64 noundef %936) #11
  %957 = add nuw nsw i64 %934, 1
  %958 = icmp eq i64 %957, %918
  br i1 %958, label %925, label %933, !llvm.loop !16

959:                                              ; preds = %927, %959
  %960 = phi double [ 0.000000e+00, %927 ], [ %985, %959 ]
  %961 = phi double [ 0.000000e+00, %927 ], [ %987, %959 ]
  %962 = phi i64 [ 0, %927 ], [ %988, %959 ]
  %963 = getelementptr inbounds double, ptr %928, i64 %962
  %964 = load double, ptr %963, align 8
  %965 = getelementptr inbounds double, ptr %929, i64 %962
  %966 = load double, ptr %965, align 8
  %967 = getelementptr inbounds double, ptr %930, i64 %962
  %968 = load double, ptr %967, align 8
  %969 = getelementptr inbounds double, ptr %931, i64 %962
  %970 = load double, ptr %969, align 8
  %971 = tail call double @llvm.fabs.f64(double %964)
  %972 = tail call double @llvm.fabs.f64(double %966)
  %973 = fcmp ogt double %971, %972
  %974 = select i1 %973, double %971, double %972
  %975 = fmul double %974, %970
  %976 = fadd double %968, %975
  %977 = fdiv double 1.000000e+00, %976
  %978 = getelementptr inbounds double, ptr %932, i64 %962
  %979 = load double, ptr %978, align 8
  %980 = fmul double %979, %977
  %981 = getelementptr inbounds double, ptr %921, i64 %962
  %982 = load double, ptr %981, align 8
  %983 = fmul double %982, %977
  %984 = fmul double %980, %980
  %985 = fadd double %960, %984
  %986 = fmul double %983, %983
  %987 = fadd double %961, %986
  %988 = add nuw nsw i64 %962, 1
  %989 = icmp eq i64 %988, %916
  br i1 %989, label %990, label %959, !llvm.loop !17

990:                                              ; preds = %959, %925
  %991 = phi double [ 0.000000e+00, %925 ], [ %987, %959 ]
  %992 = phi double [ 0.000000e+00, %925 ], [ %985, %959 ]
  %993 = load ptr, ptr %242, align 8
  %994 = getelementptr inbounds i8, ptr %913, i64 8
  %995 = load i64, ptr %994, align 8
  %996 = add nsw i64 %995, -3
  %997 = getelementptr i8, ptr %993, i64 8
  %998 = getelementptr i8, ptr %993, i64 16
  %999 = getelementptr i8, ptr %993, i64 24
  %1000 = icmp slt i64 %916, %996
  br i1 %1000, label %1008, label %1001

1001:                                             ; preds = %1008, %990
  %1002 = phi double [ 0.000000e+00, %990 ], [ %1017, %1008 ]
  %1003 = phi double [ 0.000000e+00, %990 ], [ %1021, %1008 ]
  %1004 = phi double [ 0.000000e+00, %990 ], [ %1025, %1008 ]
  %1005 = phi double [ 0.000000e+00, %990 ], [ %1029, %1008 ]
  %1006 = phi i64 [ %916, %990 ], [ %1030, %1008 ]
  %1007 = icmp slt i64 %1006, %995
  br i1 %1007, label %1032, label %1041

1008:                                             ; preds = %990, %1008
  %1009 = phi i64 [ %1030, %1008 ], [ %916, %990 ]
  %1010 = phi double [ %1029, %1008 ], [ 0.000000e+00, %990 ]
  %1011 = phi double [ %1025, %1008 ], [ 0.000000e+00, %990 ]
  %1012 = phi double [ %1021, %1008 ], [ 0.000000e+00, %990 ]
  %1013 = phi double [ %1017, %1008 ], [ 0.000000e+00, %990 ]
  %1014 = getelementptr inbounds double, ptr %993, i64 %1009
  %1015 = load double, ptr %1014, align 8
  %1016 = fmul double %1015, 0.000000e+00
  %1017 = fadd double %1013, %1016
  %1018 = getelementptr double, ptr %997, i64 %1009
  %1019 = load double, ptr %1018, align 8
  %1020 = fmul double %1019, 0.000000e+00
  %1021 = fadd double %1012, %1020
  %1022 = getelementptr double, ptr %998, i64 %1009
  %1023 = load double, ptr %1022, align 8
  %1024 = fmul double %1023, 0.000000e+00
  %1025 = fadd double %1011, %1024
  %1026 = getelementptr double, ptr %999, i64 %1009
  %1027 = load double, ptr %1026, align 8
  %1028 = fmul double %1027, 0.000000e+00
  %1029 = fadd double %1010, %1028
  %1030 = add nsw i64 %1009, 4
  %1031 = icmp slt i64 %1030, %996
  br i1 %1031, label %1008, label %1001, !llvm.loop !18

1032:                                             ; preds = %1001, %1032
  %1033 = phi i64 [ %1039, %1032 ], [ %1006, %1001 ]
  %1034 = phi double [ %1038, %1032 ], [ %1002, %1001 ]
  %1035 = getelementptr inbounds double, ptr %993, i64 %1033
  %1036 = load double, ptr %1035, align 8
  %1037 = fmul double %1036, 0.000000e+00
  %1038 = fadd double %1034, %1037
  %1039 = add nsw i64 %1033, 1
  %1040 = icmp eq i64 %1039, %995
  br i1 %1040, label %1041, label %1032, !llvm.loop !19

1041:                                             ; preds = %1032, %1001
  %1042 = phi double [ %1002, %1001 ], [ %1038, %1032 ]
  %1043 = fadd double %1003, %1042
  %1044 = fadd double %1004, %1005
  %1045 = fadd double %1044, %1043
  %1046 = fadd double %992, %1045
  %1047 = icmp eq i64 %918, 2
  br i1 %1047, label %1048, label %1057

1048:                                             ; preds = %1041
  %1049 = fmul double %991, 1.000000e-02
  %1050 = fadd double %1049, %1046
  %1051 = sitofp i64 %916 to double
  %1052 = fmul double %1050, %1051
  %1053 = tail call double @llvm.sqrt.f64(double %1052)
  %1054 = fdiv double %1046, %1053
  %1055 = fcmp une double %1046, 0.000000e+00
  %1056 = select i1 %1055, double %1054, double 0.000000e+00
  br label %1061

1057:                                             ; preds = %1041
  %1058 = sitofp i64 %916 to double
  %1059 = fdiv double %1046, %1058
  %1060 = tail call double @llvm.sqrt.f64(double %1059)
  br label %1061

1061:                                             ; preds = %1048, %1057
  %1062 = phi double [ %1056, %1048 ], [ %1060, %1057 ]
  %1063 = load ptr, ptr %232, align 8
  %1064 = load ptr, ptr %211, align 8
  %1065 = load double, ptr %1064, align 8
  %1066 = load i64, ptr %915, align 8
  %1067 = getelementptr inbounds i8, ptr %913, i64 48
  %1068 = load i64, ptr %1067, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %4, i8 0, i64 64, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %5, i8 0, i64 64, i1 false)
  %1069 = icmp eq i64 %1068, 0
  br i1 %1069, label %1199, label %1070

1070:                                             ; preds = %1061
  br i1 %1047, label %1071, label %1073

1071:                                             ; preds = %1070
  %1072 = load i64, ptr %233, align 8
  br label %1073

1073:                                             ; preds = %1071, %1070
  %1074 = phi i64 [ %1072, %1071 ], [ 0, %1070 ]
  %1075 = getelementptr inbounds double, ptr %1063, i64 %1074
  %1076 = add nsw i64 %1066, 7
  %1077 = sdiv i64 %1076, 8
  %1078 = shl nsw i64 %1077, 3
  %1079 = tail call i64 @llvm.smin.i64(i64 %1078, i64 %1068)
  %1080 = icmp slt i64 %1066, %1079
  br i1 %1080, label %1081, label %1119

1081:                                             ; preds = %1073
  %1082 = load ptr, ptr %185, align 8
  %1083 = load ptr, ptr %243, align 8
  %1084 = load ptr, ptr %244, align 8
  br label %1085

1085:                                             ; preds = %1081, %1085
  %1086 = phi i64 [ %1066, %1081 ], [ %1117, %1085 ]
  %1087 = getelementptr inbounds double, ptr %1082, i64 %1086
  %1088 = load double, ptr %1087, align 8
  %1089 = tail call double @llvm.fabs.f64(double %1088)
  %1090 = getelementptr inbounds double, ptr %993, i64 %1086
  %1091 = load double, ptr %1090, align 8
  %1092 = tail call double @llvm.fabs.f64(double %1091)
  %1093 = fcmp ogt double %1089, %1092
  %1094 = select i1 %1093, double %1089, double %1092
  %1095 = getelementptr inbounds double, ptr %1083, i64 %1086
  %1096 = load double, ptr %1095, align 8
  %1097 = getelementptr inbounds double, ptr %1084, i64 %1086
  %1098 = load double, ptr %1097, align 8
  %1099 = fmul double %1094, %1098
  %1100 = fadd double %1096, %1099
  %1101 = fdiv double 1.000000e+00, %1100
  %1102 = getelementptr inbounds double, ptr %1063, i64 %1086
  %1103 = load double, ptr %1102, align 8
  %1104 = fmul double %1103, %1101
  %1105 = getelementptr inbounds double, ptr %1075, i64 %1086
  %1106 = load double, ptr %1105, align 8
  %1107 = fmul double %1106, %1101
  %1108 = srem i64 %1086, 8
  %1109 = getelementptr inbounds double, ptr %4, i64 %1108
  %1110 = load double, ptr %1109, align 8
  %1111 = fmul double %1104, %1104
  %1112 = fadd double %1110, %1111
  store double %1112, ptr %1109, align 8
  %1113 = getelementptr inbounds double, ptr %5, i64 %1108
  %1114 = load double, ptr %1113, align 8
  %1115 = fmul double %1107, %1107
  %1116 = fadd double %1114, %1115
  store double %1116, ptr %1113, align 8
  %1117 = add nsw i64 %1086, 1
  %1118 = icmp eq i64 %1117, %1079
  br i1 %1118, label %1119, label %1085, !llvm.loop !20

1119:                                             ; preds = %1085, %1073
  %1120 = phi i64 [ %1066, %1073 ], [ %1117, %1085 ]
  %1121 = load <8 x double>, ptr %4, align 16
  %1122 = load <8 x double>, ptr %5, align 16
  %1123 = icmp slt i64 %1120, %1068
  br i1 %1123, label %1124, label %1163

1124:                                             ; preds = %1119
  %1125 = load ptr, ptr %185, align 8
  %1126 = load ptr, ptr %245, align 8
  %1127 = load ptr, ptr %246, align 8
  br label %1128

1128:                                             ; preds = %1124, %1128
  %1129 = phi i64 [ %1120, %1124 ], [ %1161, %1128 ]
  %1130 = phi <8 x double> [ %1121, %1124 ], [ %1158, %1128 ]
  %1131 = phi <8 x double> [ %1122, %1124 ], [ %1160, %1128 ]
  %1132 = getelementptr inbounds double, ptr %1125, i64 %1129
  %1133 = load <8 x double>, ptr %1132, align 8
  %1134 = fneg <8 x double> %1133
  %1135 = fcmp ogt <8 x double> %1133, zeroinitializer
  %1136 = select <8 x i1> %1135, <8 x double> %1133, <8 x double> %1134
  %1137 = getelementptr inbounds double, ptr %993, i64 %1129
  %1138 = load <8 x double>, ptr %1137, align 8
  %1139 = fneg <8 x double> %1138
  %1140 = fcmp ogt <8 x double> %1138, zeroinitializer
  %1141 = select <8 x i1> %1140, <8 x double> %1138, <8 x double> %1139
  %1142 = fcmp ogt <8 x double> %1136, %1141
  %1143 = select <8 x i1> %1142, <8 x double> %1136, <8 x double> %1141
  %1144 = getelementptr inbounds double, ptr %1126, i64 %1129
  %1145 = load <8 x double>, ptr %1144, align 8
  %1146 = getelementptr inbounds double, ptr %1127, i64 %1129
  %1147 = load <8 x double>, ptr %1146, align 8
  %1148 = fmul <8 x double> %1147, %1143
  %1149 = fadd <8 x double> %1145, %1148
  %1150 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %1149
  %1151 = getelementptr inbounds double, ptr %1063, i64 %1129
  %1152 = load <8 x double>, ptr %1151, align 8
  %1153 = fmul <8 x double> %1152, %1150
  %1154 = getelementptr inbounds double, ptr %1075, i64 %1129
  %1155 = load <8 x double>, ptr %1154, align 8
  %1156 = fmul <8 x double> %1155, %1150
  %1157 = fmul <8 x double> %1153, %1153
  %1158 = fadd <8 x double> %1130, %1157
  %1159 = fmul <8 x double> %1156, %1156
  %1160 = fadd <8 x double> %1131, %1159
  %1161 = add nsw i64 %1129, 8
  %1162 = icmp slt i64 %1161, %1068
  br i1 %1162, label %1128, label %1163, !llvm.loop !21

1163:                                             ; preds = %1128, %1119
  %1164 = phi <8 x double> [ %1122, %1119 ], [ %1160, %1128 ]
  %1165 = phi <8 x double> [ %1121, %1119 ], [ %1158, %1128 ]
  store <8 x double> %1165, ptr %4, align 16
  store <8 x double> %1164, ptr %5, align 16
  br label %1187

1166:                                             ; preds = %1187
  %1167 = sub nsw i64 %1068, %1066
  br i1 %1047, label %1168, label %1177

1168:                                             ; preds = %1166
  %1169 = fmul double %1196, 1.000000e-02
  %1170 = fadd double %1193, %1169
  %1171 = sitofp i64 %1167 to double
  %1172 = fmul double %1170, %1171
  %1173 = tail call double @llvm.sqrt.f64(double %1172)
  %1174 = fdiv double %1193, %1173
  %1175 = fcmp une double %1193, 0.000000e+00
  %1176 = select i1 %1175, double %1174, double 0.000000e+00
  br label %1181

1177:                                             ; preds = %1166
  %1178 = sitofp i64 %1167 to double
  %1179 = fdiv double %1193, %1178
  %1180 = tail call double @llvm.sqrt.f64(double %1179)
  br label %1181

1181:                                             ; preds = %1177, %1168
  %1182 = phi double [ %1176, %1168 ], [ %1180, %1177 ]
  %1183 = fcmp ule double %1065, %318
  %1184 = fcmp ogt double %1182, %1062
  %1185 = select i1 %1184, double %1182, double %1062
  %1186 = select i1 %1183, double %1062, double %1185
  br label %1199

1187:                                             ; preds = %1163, %1187
  %1188 = phi i64 [ 0, %1163 ], [ %1197, %1187 ]
  %1189 = phi double [ 0.000000e+00, %1163 ], [ %1196, %1187 ]
  %1190 = phi double [ 0.000000e+00, %1163 ], [ %1193, %1187 ]
  %1191 = getelementptr inbounds double, ptr %4, i64 %1188
  %1192 = load double, ptr %1191, align 8
  %1193 = fadd double %1190, %1192
  %1194 = getelementptr inbounds double, ptr %5, i64 %1188
  %1195 = load double, ptr %1194, align 8
  %1196 = fadd double %1189, %1195
  %1197 = add nuw nsw i64 %1188, 1
  %1198 = icmp eq i64 %1197, 8
  br i1 %1198, label %1166, label %1187, !llvm.loop !22

1199:                                             ; preds = %1061, %1181
  %1200 = phi double [ %1186, %1181 ], [ %1062, %1061 ]
  br label %1210

1201:                                             ; preds = %911, %1201
  %1202 = phi i64 [ %1208, %1201 ], [ 0, %911 ]
  %1203 = phi double [ %1207, %1201 ], [ 0.000000e+00, %911 ]
  %1204 = getelementptr inbounds double, ptr %289, i64 %1202
  %1205 = load double, ptr %1204, align 8
  %1206 = fmul double %1205, 0.000000e+00
  %1207 = fadd double %1203, %1206
  %1208 = add nuw nsw i64 %1202, 1
  %1209 = icmp eq i64 %1208, %298
  br i1 %1209, label %1210, label %1201, !llvm.loop !23

1210:                                             ; preds = %1201, %911, %1199
  %1211 = phi double [ %1200, %1199 ], [ 0.000000e+00, %911 ], [ %1207, %1201 ]
  %1212 = fcmp uge double %1211, 1.000000e+00
  %1213 = select i1 %1212, i1 true, i1 %600
  br i1 %1213, label %1252, label %1214

1214:                                             ; preds = %1210
  br i1 %301, label %1226, label %1215

1215:                                             ; preds = %1214
  br i1 %304, label %1218, label %1216

1216:                                             ; preds = %1215
  %1217 = load ptr, ptr %185, align 8
  br label %1218

1218:                                             ; preds = %1216, %1215
  %1219 = phi ptr [ %1217, %1216 ], [ null, %1215 ]
  %1220 = load ptr, ptr %192, align 8
  %1221 = getelementptr inbounds i8, ptr %1220, i64 56
  %1222 = load i64, ptr %1221, align 8
  %1223 = inttoptr i64 %1222 to ptr
  %1224 = tail call i64 %1223(ptr noundef %0, double noundef %711, ptr noundef %289, ptr noundef %1219) #10
  %1225 = icmp ne i64 %1224, 0
  br label %1226

1226:                                             ; preds = %1218, %1214
  %1227 = phi i1 [ false, %1214 ], [ %1225, %1218 ]
  br i1 %1227, label %1252, label %1228

1228:                                             ; preds = %1226
  %1229 = load i64, ptr %598, align 8
  %1230 = add nsw i64 %1229, 1
  store i64 %1230, ptr %598, align 8
  %1231 = load ptr, ptr %247, align 8
  store double %711, ptr %1231, align 8
  %1232 = load ptr, ptr %184, align 8
  %1233 = getelementptr inbounds i8, ptr %1232, i64 40
  %1234 = load i64, ptr %1233, align 8
  %1235 = icmp eq i64 %1234, 0
  br i1 %1235, label %1237, label %1236

1236:                                             ; preds = %1228
  tail call fastcc void @settle(ptr noundef nonnull %184) #11
  br label %1237

1237:                                             ; preds = %1236, %1228
  %1238 = load i64, ptr %248, align 8
  %1239 = icmp sgt i64 %1238, 0
  br i1 %1239, label %1240, label %1241

1240:                                             ; preds = %1237
  tail call fastcc void @sample(ptr noundef nonnull %184) #11
  br label %1241

1241:                                             ; preds = %1237, %1240
  %1242 = load ptr, ptr %184, align 8
  %1243 = load i64, ptr %1242, align 8
  %1244 = load ptr, ptr %247, align 8
  %1245 = load ptr, ptr %249, align 8
  %1246 = load ptr, ptr %250, align 8
  %1247 = inttoptr i64 %1243 to ptr
  %1248 = load ptr, ptr %1247, align 8
  %1249 = tail call i32 %1248(ptr noundef %1244, ptr noundef %289, ptr noundef %1245, ptr noundef %1246, ptr noundef %322) #10
  %1250 = sext i32 %1249 to i64
  %1251 = icmp slt i32 %1249, 0
  br i1 %1251, label %2127, label %1252

1252:                                             ; preds = %1241, %1226, %1210, %908
  %1253 = phi i64 [ 0, %1226 ], [ %1250, %1241 ], [ 0, %1210 ], [ %906, %908 ]
  %1254 = phi double [ %1211, %1226 ], [ %1211, %1241 ], [ %1211, %1210 ], [ 0.000000e+00, %908 ]
  %1255 = phi i1 [ %1227, %1226 ], [ %1227, %1241 ], [ false, %1210 ], [ false, %908 ]
  %1256 = icmp ne i64 %1253, 0
  %1257 = fcmp uge double %1254, 1.000000e+00
  %1258 = or i1 %1256, %1257
  %1259 = or i1 %1255, %1258
  br i1 %1259, label %1260, label %1342

1260:                                             ; preds = %1252
  %1261 = load i64, ptr %594, align 8
  %1262 = add nsw i64 %1261, 1
  store i64 %1262, ptr %594, align 8
  %1263 = or i1 %1256, %1255
  br i1 %1263, label %1267, label %1264

1264:                                             ; preds = %1260
  %1265 = tail call double @llvm.fabs.f64(double %1254)
  %1266 = fcmp one double %1265, 0x7FF0000000000000
  br label %1267

1267:                                             ; preds = %1264, %1260
  %1268 = phi i1 [ false, %1260 ], [ %1266, %1264 ]
  %1269 = select i1 %1268, i64 2, i64 4
  %1270 = select i1 %1255, i64 6, i64 %1269
  %1271 = select i1 %1256, i64 3, i64 %1270
  store i64 %1271, ptr %617, align 8
  %1272 = fcmp ogt double %1254, 1.000000e-10
  %1273 = select i1 %1272, double %1254, double 1.000000e-10
  %1274 = load double, ptr %618, align 8
  %1275 = load double, ptr %296, align 8
  %1276 = fneg double %1275
  %1277 = bitcast double %1273 to i64
  %1278 = add nsw i64 %1277, -4604544271217802189
  %1279 = ashr i64 %1278, 52
  %1280 = and i64 %1278, -4503599627370496
  %1281 = sub nsw i64 %1277, %1280
  %1282 = bitcast i64 %1281 to double
  %1283 = fadd double %1282, -1.000000e+00
  %1284 = fadd double %1282, 1.000000e+00
  %1285 = fdiv double %1283, %1284
  %1286 = fmul double %1285, %1285
  %1287 = tail call double @llvm.fma.f64(double %1286, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1288 = tail call double @llvm.fma.f64(double %1287, double %1286, double 0x3FE2776C50EF9BFE)
  %1289 = tail call double @llvm.fma.f64(double %1288, double %1286, double 0x3FEEC709DC3A03FD)
  %1290 = tail call double @llvm.fma.f64(double %1289, double %1286, double 0x40071547652B82FE)
  %1291 = trunc nsw i64 %1279 to i32
  %1292 = sitofp i32 %1291 to double
  %1293 = fmul double %1285, %1290
  %1294 = fadd double %1293, %1292
  %1295 = fmul double %1294, %1276
  %1296 = fcmp ogt double %1295, -1.000000e+03
  %1297 = select i1 %1296, double %1295, double -1.000000e+03
  %1298 = fcmp olt double %1297, 1.000000e+03
  %1299 = select i1 %1298, double %1297, double 1.000000e+03
  %1300 = tail call double @llvm.rint.f64(double %1299)
  %1301 = fsub double %1299, %1300
  %1302 = tail call double @llvm.fma.f64(double %1301, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1303 = tail call double @llvm.fma.f64(double %1302, double %1301, double 0x3F55D87FE78A6730)
  %1304 = tail call double @llvm.fma.f64(double %1303, double %1301, double 0x3F83B2AB6FBA4E77)
  %1305 = tail call double @llvm.fma.f64(double %1304, double %1301, double 0x3FAC6B08D704A0BF)
  %1306 = tail call double @llvm.fma.f64(double %1305, double %1301, double 0x3FCEBFBDFF82C58E)
  %1307 = tail call double @llvm.fma.f64(double %1306, double %1301, double 0x3FE62E42FEFA39EF)
  %1308 = tail call double @llvm.fma.f64(double %1307, double %1301, double 1.000000e+00)
  %1309 = bitcast double %1308 to i64
  %1310 = fptosi double %1300 to i32
  %1311 = sext i32 %1310 to i64
  %1312 = shl nsw i64 %1311, 52
  %1313 = add nsw i64 %1312, %1309
  %1314 = bitcast i64 %1313 to double
  %1315 = fmul double %1274, %1314
  %1316 = load double, ptr %619, align 8
  %1317 = fcmp ogt double %1315, %1316
  %1318 = select i1 %1317, double %1315, double %1316
  %1319 = select i1 %1268, double %1318, double 2.500000e-01
  %1320 = fmul double %712, %1319
  br i1 %1268, label %1321, label %1338

1321:                                             ; preds = %1267
  %1322 = load i64, ptr %285, align 8
  %1323 = icmp eq i64 %1322, 0
  br i1 %1323, label %1338, label %1324

1324:                                             ; preds = %1321
  %1325 = tail call fastcc double @knot_after(ptr noundef nonnull %184, double noundef %626) #11
  %1326 = fmul double %712, 1.000000e-03
  %1327 = fsub double %711, %1326
  %1328 = tail call double @llvm.fabs.f64(double %711)
  %1329 = fmul double %1328, 0x3D10000000000000
  %1330 = fsub double %1327, %1329
  %1331 = fcmp ogt double %1330, %1325
  br i1 %1331, label %1332, label %1338

1332:                                             ; preds = %1324
  %1333 = tail call fastcc double @knot_after(ptr noundef nonnull %184, double noundef %1325) #11
  %1334 = fadd double %626, %1320
  %1335 = fcmp ugt double %1333, %1334
  br i1 %1335, label %1336, label %1338

1336:                                             ; preds = %1332
  %1337 = fsub double %1325, %626
  br label %1338

1338:                                             ; preds = %1336, %1332, %1324, %1321, %1267
  %1339 = phi double [ %1320, %1267 ], [ %1320, %1321 ], [ %1337, %1336 ], [ %1320, %1332 ], [ %1320, %1324 ]
  br i1 %304, label %1340, label %1341

1340:                                             ; preds = %1338
  store double %712, ptr %324, align 8
  br label %2127

1341:                                             ; preds = %1338
  store double 1.000000e+00, ptr %620, align 8
  br label %2127, !llvm.loop !24

1342:                                             ; preds = %1252
  %1343 = load i64, ptr %593, align 8
  %1344 = add nsw i64 %1343, 1
  store i64 %1344, ptr %593, align 8
  store double %711, ptr %288, align 8
  store double %712, ptr %601, align 8
  %1345 = load ptr, ptr %207, align 8
  %1346 = getelementptr inbounds i8, ptr %1345, i64 8
  %1347 = load i64, ptr %1346, align 8
  %1348 = icmp eq i64 %1347, 0
  br i1 %1348, label %1378, label %1349

1349:                                             ; preds = %1342
  %1350 = load i64, ptr %1345, align 8
  %1351 = load ptr, ptr %184, align 8
  %1352 = getelementptr inbounds i8, ptr %1351, i64 8
  %1353 = load i64, ptr %1352, align 8
  %1354 = load ptr, ptr %251, align 8
  %1355 = load i64, ptr %252, align 8
  %1356 = mul nsw i64 %1355, %1350
  %1357 = getelementptr inbounds double, ptr %1354, i64 %1356
  %1358 = getelementptr inbounds double, ptr %1357, i64 %1355
  store double %626, ptr %1357, align 8
  %1359 = getelementptr inbounds i8, ptr %1357, i64 8
  store double %712, ptr %1359, align 8
  store double %711, ptr %1358, align 8
  %1360 = getelementptr inbounds i8, ptr %1358, i64 8
  store double 0.000000e+00, ptr %1360, align 8
  %1361 = icmp sgt i64 %1353, 0
  br i1 %1361, label %1365, label %1362

1362:                                             ; preds = %1365, %1349
  %1363 = add nsw i64 %1350, 1
  %1364 = load ptr, ptr %207, align 8
  store i64 %1363, ptr %1364, align 8
  br label %1378

1365:                                             ; preds = %1349, %1365
  %1366 = phi i64 [ %1376, %1365 ], [ 0, %1349 ]
  %1367 = load ptr, ptr %185, align 8
  %1368 = getelementptr inbounds double, ptr %1367, i64 %1366
  %1369 = load double, ptr %1368, align 8
  %1370 = add nuw nsw i64 %1366, 2
  %1371 = getelementptr inbounds double, ptr %1357, i64 %1370
  store double %1369, ptr %1371, align 8
  %1372 = load ptr, ptr %187, align 8
  %1373 = getelementptr inbounds double, ptr %1372, i64 %1366
  %1374 = load double, ptr %1373, align 8
  %1375 = getelementptr inbounds double, ptr %1358, i64 %1370
  store double %1374, ptr %1375, align 8
  %1376 = add nuw nsw i64 %1366, 1
  %1377 = icmp eq i64 %1376, %1353
  br i1 %1377, label %1362, label %1365, !llvm.loop !25

1378:                                             ; preds = %1342, %1362
  br i1 %311, label %1379, label %1489

1379:                                             ; preds = %1378
  %1380 = load ptr, ptr %193, align 8
  %1381 = load i64, ptr %191, align 8
  %1382 = load ptr, ptr %253, align 8
  %1383 = getelementptr inbounds i8, ptr %1380, i64 32
  %1384 = load i64, ptr %1383, align 8
  %1385 = getelementptr inbounds double, ptr %1382, i64 %1384
  %1386 = getelementptr inbounds i8, ptr %1380, i64 24
  %1387 = load i64, ptr %1386, align 8
  %1388 = icmp eq i64 %1387, 0
  br i1 %1388, label %1486, label %1389

1389:                                             ; preds = %1379
  %1390 = getelementptr inbounds i8, ptr %1380, i64 40
  %1391 = load i64, ptr %1390, align 8
  %1392 = icmp sgt i64 %1391, 0
  br i1 %1392, label %1447, label %1393

1393:                                             ; preds = %1465, %1389
  %1394 = load ptr, ptr %254, align 8
  %1395 = load ptr, ptr %193, align 8
  %1396 = getelementptr inbounds i8, ptr %1395, i64 8
  %1397 = load i64, ptr %1396, align 8
  %1398 = load ptr, ptr %255, align 8
  %1399 = load ptr, ptr %253, align 8
  %1400 = getelementptr inbounds i8, ptr %1395, i64 32
  %1401 = load i64, ptr %1400, align 8
  %1402 = getelementptr inbounds i8, ptr %1395, i64 40
  %1403 = load i64, ptr %1402, align 8
  %1404 = getelementptr double, ptr %1399, i64 %1401
  %1405 = getelementptr double, ptr %1404, i64 %1403
  store double %712, ptr %1405, align 8
  %1406 = load ptr, ptr %254, align 8
  store double %626, ptr %1406, align 8
  %1407 = load ptr, ptr %193, align 8
  %1408 = getelementptr inbounds i8, ptr %1407, i64 24
  %1409 = load i64, ptr %1408, align 8
  %1410 = load ptr, ptr %185, align 8
  %1411 = load ptr, ptr %253, align 8
  %1412 = load ptr, ptr %256, align 8
  %1413 = inttoptr i64 %1409 to ptr
  %1414 = load ptr, ptr %1413, align 8
  %1415 = tail call i32 %1414(ptr noundef %1394, ptr noundef %1410, ptr noundef %1411, ptr noundef %1412, ptr noundef %1398) #10
  %1416 = icmp eq i32 %1415, 0
  br i1 %1416, label %1417, label %1486

1417:                                             ; preds = %1393
  %1418 = icmp slt i64 %1397, 1
  br i1 %1418, label %1444, label %1419

1419:                                             ; preds = %1417
  %1420 = load ptr, ptr %257, align 8
  %1421 = getelementptr double, ptr %1398, i64 %1397
  br label %1422

1422:                                             ; preds = %1419, %1440
  %1423 = phi i1 [ %1418, %1419 ], [ %1442, %1440 ]
  %1424 = phi i64 [ 0, %1419 ], [ %1441, %1440 ]
  %1425 = getelementptr inbounds i64, ptr %1420, i64 %1424
  %1426 = load i64, ptr %1425, align 8
  %1427 = and i64 %1426, 2
  %1428 = icmp eq i64 %1427, 0
  br i1 %1428, label %1429, label %1440

1429:                                             ; preds = %1422
  %1430 = getelementptr inbounds double, ptr %1398, i64 %1424
  %1431 = load double, ptr %1430, align 8
  %1432 = load ptr, ptr %258, align 8
  %1433 = getelementptr inbounds i64, ptr %1432, i64 %1424
  %1434 = load i64, ptr %1433, align 8
  %1435 = sitofp i64 %1434 to double
  %1436 = fmul double %1431, %1435
  %1437 = getelementptr double, ptr %1421, i64 %1424
  %1438 = load double, ptr %1437, align 8
  %1439 = fcmp ogt double %1436, %1438
  br i1 %1439, label %1440, label %1444

1440:                                             ; preds = %1429, %1422
  %1441 = add nuw nsw i64 %1424, 1
  %1442 = icmp sge i64 %1441, %1397
  %1443 = icmp eq i64 %1441, %1397
  br i1 %1443, label %1444, label %1422, !llvm.loop !26

1444:                                             ; preds = %1440, %1429, %1417
  %1445 = phi i1 [ %1418, %1417 ], [ %1442, %1440 ], [ %1423, %1429 ]
  %1446 = zext i1 %1445 to i32
  br label %1486

1447:                                             ; preds = %1389, %1465
  %1448 = phi i64 [ %1469, %1465 ], [ 0, %1389 ]
  %1449 = load ptr, ptr %187, align 8
  %1450 = getelementptr inbounds double, ptr %1449, i64 %1448
  %1451 = load <8 x double>, ptr %1450, align 8
  %1452 = load ptr, ptr %185, align 8
  %1453 = getelementptr inbounds double, ptr %1452, i64 %1448
  %1454 = load <8 x double>, ptr %1453, align 8
  %1455 = fsub <8 x double> %1451, %1454
  %1456 = fneg <8 x double> %1455
  %1457 = fcmp ogt <8 x double> %1455, zeroinitializer
  %1458 = select <8 x i1> %1457, <8 x double> %1455, <8 x double> %1456
  %1459 = load ptr, ptr %0, align 8
  %1460 = load i64, ptr %1459, align 8
  %1461 = icmp slt i64 %1460, 0
  br i1 %1461, label %1465, label %1462

1462:                                             ; preds = %1447
  %1463 = load ptr, ptr %195, align 8
  %1464 = getelementptr double, ptr %1463, i64 %1448
  br label %1472

1465:                                             ; preds = %1472, %1447
  %1466 = phi <8 x double> [ %1458, %1447 ], [ %1483, %1472 ]
  %1467 = getelementptr inbounds double, ptr %1385, i64 %1448
  %1468 = fmul <8 x double> %1466, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  store <8 x double> %1468, ptr %1467, align 8
  %1469 = add nuw nsw i64 %1448, 8
  %1470 = load i64, ptr %1390, align 8
  %1471 = icmp slt i64 %1469, %1470
  br i1 %1471, label %1447, label %1393, !llvm.loop !27

1472:                                             ; preds = %1462, %1472
  %1473 = phi i64 [ 0, %1462 ], [ %1484, %1472 ]
  %1474 = phi <8 x double> [ %1458, %1462 ], [ %1483, %1472 ]
  %1475 = mul nsw i64 %1473, %1381
  %1476 = getelementptr double, ptr %1464, i64 %1475
  %1477 = load <8 x double>, ptr %1476, align 8
  %1478 = fneg <8 x double> %1477
  %1479 = fcmp ogt <8 x double> %1477, zeroinitializer
  %1480 = select <8 x i1> %1479, <8 x double> %1477, <8 x double> %1478
  %1481 = fmul <8 x double> %724, %1480
  %1482 = fcmp ogt <8 x double> %1474, %1481
  %1483 = select <8 x i1> %1482, <8 x double> %1474, <8 x double> %1481
  %1484 = add nuw i64 %1473, 1
  %1485 = icmp eq i64 %1473, %1460
  br i1 %1485, label %1465, label %1472, !llvm.loop !28

1486:                                             ; preds = %1444, %1393, %1379
  %1487 = phi i32 [ 0, %1379 ], [ 0, %1393 ], [ %1446, %1444 ]
  %1488 = icmp eq i32 %1487, 0
  br label %1489

1489:                                             ; preds = %1486, %1378
  %1490 = phi i1 [ false, %1378 ], [ %1488, %1486 ]
  br i1 %1490, label %1533, label %1491

1491:                                             ; preds = %1489
  %1492 = load i64, ptr %602, align 8
  %1493 = getelementptr inbounds double, ptr %295, i64 %1492
  %1494 = load double, ptr %1493, align 8
  %1495 = fcmp ult double %1494, %711
  br i1 %1495, label %1533, label %1496

1496:                                             ; preds = %1491
  %1497 = load ptr, ptr %184, align 8
  %1498 = getelementptr inbounds i8, ptr %1497, i64 8
  %1499 = load i64, ptr %1498, align 8
  %1500 = load i64, ptr %194, align 8
  %1501 = load ptr, ptr %189, align 8
  %1502 = load ptr, ptr %188, align 8
  %1503 = getelementptr inbounds i8, ptr %1502, i64 48
  %1504 = load i64, ptr %1503, align 8
  %1505 = icmp slt i64 %1504, %1500
  br i1 %1505, label %1506, label %1529

1506:                                             ; preds = %1496
  %1507 = icmp sgt i64 %1499, 0
  br label %1508

1508:                                             ; preds = %1506, %1519
  %1509 = phi i64 [ %1504, %1506 ], [ %1520, %1519 ]
  %1510 = getelementptr inbounds double, ptr %1501, i64 %1509
  %1511 = load double, ptr %1510, align 8
  %1512 = load ptr, ptr %186, align 8
  %1513 = load double, ptr %1512, align 8
  %1514 = fcmp ugt double %1511, %1513
  br i1 %1514, label %1529, label %1515

1515:                                             ; preds = %1508
  br i1 %1507, label %1516, label %1519

1516:                                             ; preds = %1515
  %1517 = mul nsw i64 %1509, %1499
  %1518 = getelementptr double, ptr %1, i64 %1517
  br label %1522

1519:                                             ; preds = %1522, %1515
  %1520 = add i64 %1509, 1
  %1521 = icmp eq i64 %1520, %1500
  br i1 %1521, label %1529, label %1508, !llvm.loop !10

1522:                                             ; preds = %1516, %1522
  %1523 = phi i64 [ 0, %1516 ], [ %1527, %1522 ]
  %1524 = getelementptr inbounds double, ptr %289, i64 %1523
  %1525 = load double, ptr %1524, align 8
  %1526 = getelementptr double, ptr %1518, i64 %1523
  store double %1525, ptr %1526, align 8
  %1527 = add nuw nsw i64 %1523, 1
  %1528 = icmp eq i64 %1527, %1499
  br i1 %1528, label %1519, label %1522, !llvm.loop !11

1529:                                             ; preds = %1508, %1519, %1496
  %1530 = phi i64 [ %1504, %1496 ], [ %1509, %1508 ], [ %1500, %1519 ]
  %1531 = load ptr, ptr %188, align 8
  %1532 = getelementptr inbounds i8, ptr %1531, i64 48
  store i64 %1530, ptr %1532, align 8
  br label %1899

1533:                                             ; preds = %1491, %1489
  %1534 = load ptr, ptr %0, align 8
  %1535 = load ptr, ptr %184, align 8
  %1536 = getelementptr inbounds i8, ptr %1535, i64 16
  %1537 = load i64, ptr %1536, align 8
  %1538 = load i64, ptr %1534, align 8
  %1539 = load i64, ptr %259, align 8
  %1540 = load ptr, ptr %260, align 8
  %1541 = mul nsw i64 %1539, %1538
  %1542 = getelementptr inbounds double, ptr %1540, i64 %1541
  %1543 = load ptr, ptr %261, align 8
  %1544 = add nsw i64 %1538, 1
  %1545 = getelementptr inbounds i8, ptr %1534, i64 16
  %1546 = load i64, ptr %1545, align 8
  %1547 = icmp sgt i64 %1546, 0
  br i1 %1547, label %1548, label %1609

1548:                                             ; preds = %1533
  %1549 = getelementptr inbounds i8, ptr %1534, i64 8
  br label %1555

1550:                                             ; preds = %1597
  %1551 = add nsw i64 %1558, 1
  %1552 = load i64, ptr %1545, align 8
  %1553 = add nsw i64 %1552, %1544
  %1554 = icmp slt i64 %1551, %1553
  br i1 %1554, label %1555, label %1609, !llvm.loop !29

1555:                                             ; preds = %1548, %1550
  %1556 = phi i1 [ %1547, %1548 ], [ %1554, %1550 ]
  %1557 = phi i64 [ undef, %1548 ], [ %1608, %1550 ]
  %1558 = phi i64 [ %1544, %1548 ], [ %1551, %1550 ]
  %1559 = load i64, ptr %1549, align 8
  %1560 = load ptr, ptr %262, align 8
  %1561 = load ptr, ptr %185, align 8
  %1562 = load ptr, ptr %263, align 8
  %1563 = getelementptr i64, ptr %1562, i64 %1558
  %1564 = getelementptr i64, ptr %1563, i64 %1559
  %1565 = load i64, ptr %1564, align 8
  %1566 = getelementptr i8, ptr %1564, i64 8
  %1567 = load i64, ptr %1566, align 8
  %1568 = xor i64 %1565, -1
  %1569 = add i64 %1567, %1568
  %1570 = load ptr, ptr %211, align 8
  %1571 = load ptr, ptr %260, align 8
  %1572 = load ptr, ptr %264, align 8
  %1573 = getelementptr inbounds i64, ptr %1572, i64 %1565
  %1574 = load ptr, ptr %265, align 8
  %1575 = getelementptr inbounds double, ptr %1574, i64 %1565
  tail call fastcc void @combine(ptr noundef %1560, ptr noundef %1561, ptr noundef %1570, ptr noundef %1571, ptr noundef %1573, ptr noundef %1575, i64 noundef %1569, i64 noundef 1, i64 noundef %1537) #11
  %1576 = load ptr, ptr %260, align 8
  %1577 = mul nsw i64 %1558, %1539
  %1578 = getelementptr inbounds double, ptr %1576, i64 %1577
  %1579 = load i64, ptr %598, align 8
  %1580 = add nsw i64 %1579, 1
  store i64 %1580, ptr %598, align 8
  %1581 = load ptr, ptr %266, align 8
  %1582 = getelementptr inbounds double, ptr %1581, i64 %1558
  %1583 = load double, ptr %1582, align 8
  %1584 = fmul double %712, %1583
  %1585 = fadd double %626, %1584
  %1586 = load ptr, ptr %262, align 8
  %1587 = load ptr, ptr %267, align 8
  store double %1585, ptr %1587, align 8
  %1588 = load ptr, ptr %184, align 8
  %1589 = getelementptr inbounds i8, ptr %1588, i64 40
  %1590 = load i64, ptr %1589, align 8
  %1591 = icmp eq i64 %1590, 0
  br i1 %1591, label %1593, label %1592

1592:                                             ; preds = %1555
  tail call fastcc void @settle(ptr noundef nonnull %184) #11
  br label %1593

1593:                                             ; preds = %1592, %1555
  %1594 = load i64, ptr %268, align 8
  %1595 = icmp sgt i64 %1594, 0
  br i1 %1595, label %1596, label %1597

1596:                                             ; preds = %1593
  tail call fastcc void @sample(ptr noundef nonnull %184) #11
  br label %1597

1597:                                             ; preds = %1593, %1596
  %1598 = load ptr, ptr %184, align 8
  %1599 = load i64, ptr %1598, align 8
  %1600 = load ptr, ptr %267, align 8
  %1601 = load ptr, ptr %269, align 8
  %1602 = load ptr, ptr %270, align 8
  %1603 = inttoptr i64 %1599 to ptr
  %1604 = load ptr, ptr %1603, align 8
  %1605 = tail call i32 %1604(ptr noundef %1600, ptr noundef %1586, ptr noundef %1601, ptr noundef %1602, ptr noundef %1578) #10
  %1606 = sext i32 %1605 to i64
  %1607 = icmp eq i32 %1605, 0
  %1608 = select i1 %1607, i64 %1557, i64 %1606
  br i1 %1607, label %1550, label %1609

1609:                                             ; preds = %1550, %1597, %1533
  %1610 = phi i1 [ %1547, %1533 ], [ %1554, %1550 ], [ %1556, %1597 ]
  %1611 = phi i64 [ 0, %1533 ], [ %1606, %1597 ], [ %1606, %1550 ]
  %1612 = phi i64 [ undef, %1533 ], [ %1608, %1597 ], [ %1608, %1550 ]
  %1613 = getelementptr inbounds i8, ptr %1534, i64 16
  br i1 %1610, label %1682, label %1614

1614:                                             ; preds = %1609
  %1615 = load ptr, ptr %184, align 8
  %1616 = getelementptr inbounds i8, ptr %1615, i64 8
  %1617 = load i64, ptr %1616, align 8
  %1618 = icmp sgt i64 %1617, 0
  br i1 %1618, label %1619, label %1623

1619:                                             ; preds = %1614
  %1620 = getelementptr inbounds double, ptr %1543, i64 %1539
  %1621 = shl nsw i64 %1539, 4
  %1622 = getelementptr inbounds i8, ptr %1543, i64 %1621
  br label %1630

1623:                                             ; preds = %1630, %1614
  %1624 = getelementptr inbounds i8, ptr %1534, i64 8
  %1625 = load i64, ptr %1624, align 8
  %1626 = load i64, ptr %1613, align 8
  %1627 = getelementptr inbounds i8, ptr %1534, i64 24
  %1628 = load i64, ptr %1627, align 8
  %1629 = icmp sgt i64 %1628, 3
  br i1 %1629, label %1657, label %1682

1630:                                             ; preds = %1619, %1630
  %1631 = phi i64 [ 0, %1619 ], [ %1652, %1630 ]
  %1632 = load ptr, ptr %271, align 8
  %1633 = getelementptr inbounds double, ptr %1632, i64 %1631
  %1634 = load double, ptr %1633, align 8
  %1635 = load ptr, ptr %185, align 8
  %1636 = getelementptr inbounds double, ptr %1635, i64 %1631
  %1637 = load double, ptr %1636, align 8
  %1638 = fsub double %1634, %1637
  %1639 = load ptr, ptr %260, align 8
  %1640 = getelementptr inbounds double, ptr %1639, i64 %1631
  %1641 = load double, ptr %1640, align 8
  %1642 = fmul double %712, %1641
  %1643 = fsub double %1642, %1638
  %1644 = getelementptr inbounds double, ptr %1543, i64 %1631
  store double %1638, ptr %1644, align 8
  %1645 = getelementptr inbounds double, ptr %1620, i64 %1631
  store double %1643, ptr %1645, align 8
  %1646 = fsub double %1638, %1643
  %1647 = getelementptr inbounds double, ptr %1542, i64 %1631
  %1648 = load double, ptr %1647, align 8
  %1649 = fmul double %712, %1648
  %1650 = fsub double %1646, %1649
  %1651 = getelementptr inbounds double, ptr %1622, i64 %1631
  store double %1650, ptr %1651, align 8
  %1652 = add nuw nsw i64 %1631, 1
  %1653 = load ptr, ptr %184, align 8
  %1654 = getelementptr inbounds i8, ptr %1653, i64 8
  %1655 = load i64, ptr %1654, align 8
  %1656 = icmp slt i64 %1652, %1655
  br i1 %1656, label %1630, label %1623, !llvm.loop !30

1657:                                             ; preds = %1623, %1657
  %1658 = phi i64 [ %1679, %1657 ], [ 3, %1623 ]
  %1659 = mul nsw i64 %1658, %1539
  %1660 = getelementptr inbounds double, ptr %1543, i64 %1659
  %1661 = load ptr, ptr %272, align 8
  %1662 = load ptr, ptr %273, align 8
  %1663 = getelementptr i64, ptr %1662, i64 %1544
  %1664 = getelementptr i64, ptr %1663, i64 %1625
  %1665 = getelementptr i64, ptr %1664, i64 %1626
  %1666 = getelementptr i64, ptr %1665, i64 %1658
  %1667 = getelementptr i8, ptr %1666, i64 -24
  %1668 = load i64, ptr %1667, align 8
  %1669 = getelementptr i8, ptr %1666, i64 -16
  %1670 = load i64, ptr %1669, align 8
  %1671 = xor i64 %1668, -1
  %1672 = add i64 %1670, %1671
  %1673 = load ptr, ptr %211, align 8
  %1674 = load ptr, ptr %260, align 8
  %1675 = load ptr, ptr %274, align 8
  %1676 = getelementptr inbounds i64, ptr %1675, i64 %1668
  %1677 = load ptr, ptr %275, align 8
  %1678 = getelementptr inbounds double, ptr %1677, i64 %1668
  tail call fastcc void @combine(ptr noundef %1660, ptr noundef %1661, ptr noundef %1673, ptr noundef %1674, ptr noundef %1676, ptr noundef %1678, i64 noundef %1672, i64 noundef 1, i64 noundef %1537) #11
  %1679 = add nuw nsw i64 %1658, 1
  %1680 = load i64, ptr %1627, align 8
  %1681 = icmp slt i64 %1679, %1680
  br i1 %1681, label %1657, label %1682, !llvm.loop !31

1682:                                             ; preds = %1657, %1623, %1609
  %1683 = phi i64 [ %1612, %1609 ], [ %1611, %1623 ], [ %1611, %1657 ]
  %1684 = icmp eq i64 %1683, 0
  br i1 %1684, label %1688, label %1685

1685:                                             ; preds = %1682
  store i64 3, ptr %603, align 8
  store double %626, ptr %288, align 8
  %1686 = icmp slt i64 %1683, 0
  %1687 = select i1 %1686, i64 -4, i64 2
  br label %2127

1688:                                             ; preds = %1682
  %1689 = load ptr, ptr %186, align 8
  br i1 %1490, label %1690, label %1701

1690:                                             ; preds = %1688
  %1691 = load ptr, ptr %193, align 8
  %1692 = getelementptr inbounds i8, ptr %1691, i64 16
  %1693 = load i64, ptr %1692, align 8
  %1694 = inttoptr i64 %1693 to ptr
  %1695 = tail call i64 %1694(ptr noundef %0, double noundef %626, double noundef %712) #10
  %1696 = icmp eq i64 %1695, -6
  br i1 %1696, label %1697, label %1698

1697:                                             ; preds = %1690
  store double %626, ptr %1689, align 8
  br label %1876

1698:                                             ; preds = %1690
  %1699 = getelementptr inbounds i8, ptr %1689, i64 48
  %1700 = load double, ptr %1699, align 8
  br label %1701

1701:                                             ; preds = %1698, %1688
  %1702 = phi double [ %1700, %1698 ], [ 1.000000e+00, %1688 ]
  %1703 = phi i64 [ %1695, %1698 ], [ 0, %1688 ]
  %1704 = fcmp oeq double %1702, 1.000000e+00
  br i1 %1704, label %1705, label %1707

1705:                                             ; preds = %1701
  %1706 = load double, ptr %1689, align 8
  br label %1710

1707:                                             ; preds = %1701
  %1708 = fmul double %712, %1702
  %1709 = fadd double %626, %1708
  br label %1710

1710:                                             ; preds = %1707, %1705
  %1711 = phi double [ %1706, %1705 ], [ %1709, %1707 ]
  %1712 = icmp eq i64 %1703, -4
  %1713 = select i1 %1712, i64 -4, i64 0
  br i1 %1712, label %1771, label %1714

1714:                                             ; preds = %1710
  %1715 = fcmp olt double %1702, 1.000000e+00
  %1716 = load ptr, ptr %184, align 8
  %1717 = getelementptr inbounds i8, ptr %1716, i64 8
  %1718 = load i64, ptr %1717, align 8
  %1719 = load i64, ptr %194, align 8
  %1720 = load ptr, ptr %189, align 8
  %1721 = load ptr, ptr %188, align 8
  %1722 = getelementptr inbounds i8, ptr %1721, i64 48
  %1723 = load i64, ptr %1722, align 8
  %1724 = icmp slt i64 %1723, %1719
  br i1 %1724, label %1725, label %1767

1725:                                             ; preds = %1714, %1763
  %1726 = phi i64 [ %1764, %1763 ], [ undef, %1714 ]
  %1727 = phi i64 [ %1765, %1763 ], [ %1723, %1714 ]
  %1728 = getelementptr inbounds double, ptr %1720, i64 %1727
  %1729 = load double, ptr %1728, align 8
  %1730 = fcmp olt double %1729, %1711
  %1731 = fcmp oeq double %1729, %1711
  %1732 = and i1 %1715, %1731
  %1733 = or i1 %1730, %1732
  br i1 %1733, label %1734, label %1767

1734:                                             ; preds = %1725
  %1735 = fsub double %1729, %626
  %1736 = fdiv double %1735, %712
  %1737 = mul nsw i64 %1727, %1718
  %1738 = getelementptr inbounds double, ptr %1, i64 %1737
  %1739 = load ptr, ptr %276, align 8
  %1740 = insertelement <8 x double> poison, double %1736, i64 0
  %1741 = shufflevector <8 x double> %1740, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1741, ptr %1739, align 8
  %1742 = load ptr, ptr %185, align 8
  %1743 = load ptr, ptr %261, align 8
  %1744 = load i64, ptr %259, align 8
  %1745 = load ptr, ptr %0, align 8
  %1746 = getelementptr inbounds i8, ptr %1745, i64 24
  %1747 = load i64, ptr %1746, align 8
  %1748 = load ptr, ptr %276, align 8
  %1749 = load ptr, ptr %184, align 8
  %1750 = getelementptr inbounds i8, ptr %1749, i64 16
  %1751 = load i64, ptr %1750, align 8
  tail call fastcc void @nested(ptr noundef %1738, ptr noundef %1742, ptr noundef %1743, i64 noundef %1744, i64 noundef %1747, ptr noundef %1748, i64 noundef %1751) #11
  %1752 = load ptr, ptr %192, align 8
  %1753 = load i64, ptr %1752, align 8
  %1754 = icmp eq i64 %1753, 1
  br i1 %1754, label %1755, label %1763

1755:                                             ; preds = %1734
  %1756 = load double, ptr %1728, align 8
  %1757 = getelementptr inbounds i8, ptr %1752, i64 56
  %1758 = load i64, ptr %1757, align 8
  %1759 = inttoptr i64 %1758 to ptr
  %1760 = tail call i64 %1759(ptr noundef %0, double noundef %1756, ptr noundef %1738, ptr noundef null) #10
  %1761 = icmp eq i64 %1760, 0
  %1762 = select i1 %1761, i64 %1726, i64 %1760
  br i1 %1761, label %1763, label %1771

1763:                                             ; preds = %1755, %1734
  %1764 = phi i64 [ %1762, %1755 ], [ %1726, %1734 ]
  %1765 = add i64 %1727, 1
  %1766 = icmp eq i64 %1765, %1719
  br i1 %1766, label %1767, label %1725, !llvm.loop !32

1767:                                             ; preds = %1763, %1725, %1714
  %1768 = phi i64 [ %1723, %1714 ], [ %1719, %1763 ], [ %1727, %1725 ]
  %1769 = load ptr, ptr %188, align 8
  %1770 = getelementptr inbounds i8, ptr %1769, i64 48
  store i64 %1768, ptr %1770, align 8
  br label %1771

1771:                                             ; preds = %1755, %1767, %1710
  %1772 = phi i64 [ %1713, %1710 ], [ 0, %1767 ], [ %1762, %1755 ]
  %1773 = icmp eq i64 %1772, 0
  %1774 = icmp ne i64 %1703, 0
  %1775 = fcmp olt double %1702, 1.000000e+00
  %1776 = and i1 %1775, %1773
  %1777 = and i1 %1774, %1776
  br i1 %1777, label %1778, label %1815

1778:                                             ; preds = %1771
  %1779 = load ptr, ptr %277, align 8
  %1780 = load ptr, ptr %278, align 8
  %1781 = insertelement <8 x double> poison, double %1702, i64 0
  %1782 = shufflevector <8 x double> %1781, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1782, ptr %1780, align 8
  %1783 = load ptr, ptr %185, align 8
  %1784 = load ptr, ptr %261, align 8
  %1785 = load i64, ptr %259, align 8
  %1786 = load ptr, ptr %0, align 8
  %1787 = getelementptr inbounds i8, ptr %1786, i64 24
  %1788 = load i64, ptr %1787, align 8
  %1789 = load ptr, ptr %278, align 8
  %1790 = load ptr, ptr %184, align 8
  %1791 = getelementptr inbounds i8, ptr %1790, i64 16
  %1792 = load i64, ptr %1791, align 8
  tail call fastcc void @nested(ptr noundef %1779, ptr noundef %1783, ptr noundef %1784, i64 noundef %1785, i64 noundef %1788, ptr noundef %1789, i64 noundef %1792) #11
  %1793 = load i64, ptr %191, align 8
  %1794 = icmp sgt i64 %1793, 0
  br i1 %1794, label %1799, label %1795

1795:                                             ; preds = %1799, %1778
  %1796 = load ptr, ptr %192, align 8
  %1797 = load i64, ptr %1796, align 8
  %1798 = icmp eq i64 %1797, 1
  br i1 %1798, label %1809, label %1815

1799:                                             ; preds = %1778, %1799
  %1800 = phi i64 [ %1806, %1799 ], [ 0, %1778 ]
  %1801 = load ptr, ptr %277, align 8
  %1802 = getelementptr inbounds double, ptr %1801, i64 %1800
  %1803 = load double, ptr %1802, align 8
  %1804 = load ptr, ptr %187, align 8
  %1805 = getelementptr inbounds double, ptr %1804, i64 %1800
  store double %1803, ptr %1805, align 8
  %1806 = add nuw nsw i64 %1800, 1
  %1807 = load i64, ptr %191, align 8
  %1808 = icmp slt i64 %1806, %1807
  br i1 %1808, label %1799, label %1795, !llvm.loop !33

1809:                                             ; preds = %1795
  %1810 = load ptr, ptr %187, align 8
  %1811 = getelementptr inbounds i8, ptr %1796, i64 56
  %1812 = load i64, ptr %1811, align 8
  %1813 = inttoptr i64 %1812 to ptr
  %1814 = tail call i64 %1813(ptr noundef %0, double noundef %1711, ptr noundef %1810, ptr noundef null) #10
  br label %1815

1815:                                             ; preds = %1809, %1795, %1771
  %1816 = phi i64 [ %1814, %1809 ], [ 0, %1795 ], [ %1772, %1771 ]
  %1817 = icmp eq i64 %1816, 0
  br i1 %1817, label %1820, label %1818

1818:                                             ; preds = %1815
  store double %626, ptr %1689, align 8
  %1819 = getelementptr inbounds i8, ptr %1689, i64 8
  store double %712, ptr %1819, align 8
  br label %1876

1820:                                             ; preds = %1815
  br i1 %1704, label %1821, label %1859

1821:                                             ; preds = %1820
  %1822 = load ptr, ptr %187, align 8
  %1823 = load ptr, ptr %184, align 8
  %1824 = getelementptr inbounds i8, ptr %1823, i64 8
  %1825 = load i64, ptr %1824, align 8
  %1826 = load i64, ptr %194, align 8
  %1827 = load ptr, ptr %189, align 8
  %1828 = load ptr, ptr %188, align 8
  %1829 = getelementptr inbounds i8, ptr %1828, i64 48
  %1830 = load i64, ptr %1829, align 8
  %1831 = icmp slt i64 %1830, %1826
  br i1 %1831, label %1832, label %1855

1832:                                             ; preds = %1821
  %1833 = icmp sgt i64 %1825, 0
  br label %1834

1834:                                             ; preds = %1832, %1845
  %1835 = phi i64 [ %1830, %1832 ], [ %1846, %1845 ]
  %1836 = getelementptr inbounds double, ptr %1827, i64 %1835
  %1837 = load double, ptr %1836, align 8
  %1838 = load ptr, ptr %186, align 8
  %1839 = load double, ptr %1838, align 8
  %1840 = fcmp ugt double %1837, %1839
  br i1 %1840, label %1855, label %1841

1841:                                             ; preds = %1834
  br i1 %1833, label %1842, label %1845

1842:                                             ; preds = %1841
  %1843 = mul nsw i64 %1835, %1825
  %1844 = getelementptr double, ptr %1, i64 %1843
  br label %1848

1845:                                             ; preds = %1848, %1841
  %1846 = add i64 %1835, 1
  %1847 = icmp eq i64 %1846, %1826
  br i1 %1847, label %1855, label %1834, !llvm.loop !10

1848:                                             ; preds = %1842, %1848
  %1849 = phi i64 [ 0, %1842 ], [ %1853, %1848 ]
  %1850 = getelementptr inbounds double, ptr %1822, i64 %1849
  %1851 = load double, ptr %1850, align 8
  %1852 = getelementptr double, ptr %1844, i64 %1849
  store double %1851, ptr %1852, align 8
  %1853 = add nuw nsw i64 %1849, 1
  %1854 = icmp eq i64 %1853, %1825
  br i1 %1854, label %1845, label %1848, !llvm.loop !11

1855:                                             ; preds = %1845, %1834, %1821
  %1856 = phi i64 [ %1830, %1821 ], [ %1826, %1845 ], [ %1835, %1834 ]
  %1857 = load ptr, ptr %188, align 8
  %1858 = getelementptr inbounds i8, ptr %1857, i64 48
  store i64 %1856, ptr %1858, align 8
  br label %1859

1859:                                             ; preds = %1855, %1820
  br i1 %1774, label %1860, label %1876

1860:                                             ; preds = %1859
  %1861 = load i64, ptr %191, align 8
  %1862 = icmp sgt i64 %1861, 0
  br i1 %1862, label %1866, label %1863

1863:                                             ; preds = %1866, %1860
  store double %1711, ptr %1689, align 8
  %1864 = getelementptr inbounds i8, ptr %1689, i64 8
  store double 0.000000e+00, ptr %1864, align 8
  %1865 = load ptr, ptr %188, align 8
  store i64 0, ptr %1865, align 8
  br label %1876

1866:                                             ; preds = %1860, %1866
  %1867 = phi i64 [ %1873, %1866 ], [ 0, %1860 ]
  %1868 = load ptr, ptr %187, align 8
  %1869 = getelementptr inbounds double, ptr %1868, i64 %1867
  %1870 = load double, ptr %1869, align 8
  %1871 = load ptr, ptr %185, align 8
  %1872 = getelementptr inbounds double, ptr %1871, i64 %1867
  store double %1870, ptr %1872, align 8
  %1873 = add nuw nsw i64 %1867, 1
  %1874 = load i64, ptr %191, align 8
  %1875 = icmp slt i64 %1873, %1874
  br i1 %1875, label %1866, label %1863, !llvm.loop !34

1876:                                             ; preds = %1697, %1818, %1859, %1863
  %1877 = phi i64 [ -6, %1697 ], [ %1816, %1818 ], [ %1703, %1863 ], [ %1703, %1859 ]
  %1878 = icmp eq i64 %1877, -6
  br i1 %1878, label %1883, label %1879

1879:                                             ; preds = %1876
  %1880 = icmp ne i64 %1877, 6
  %1881 = select i1 %1880, i1 true, i1 %304
  %1882 = select i1 %1881, i1 true, i1 %311
  br i1 %1882, label %1893, label %1883

1883:                                             ; preds = %1879, %1876
  %1884 = phi i64 [ %1877, %1879 ], [ 2, %1876 ]
  %1885 = load i64, ptr %593, align 8
  %1886 = add nsw i64 %1885, -1
  store i64 %1886, ptr %593, align 8
  %1887 = load ptr, ptr %207, align 8
  %1888 = load i64, ptr %1887, align 8
  %1889 = add nsw i64 %1888, -1
  store i64 %1889, ptr %1887, align 8
  %1890 = load i64, ptr %594, align 8
  %1891 = add nsw i64 %1890, 1
  store i64 %1891, ptr %594, align 8
  store i64 %1884, ptr %615, align 8
  store double 1.000000e+00, ptr %616, align 8
  %1892 = fmul double %712, 2.500000e-01
  br label %2127, !llvm.loop !24

1893:                                             ; preds = %1879
  %1894 = icmp eq i64 %1877, 0
  br i1 %1894, label %1899, label %1895

1895:                                             ; preds = %1893
  %1896 = load ptr, ptr %207, align 8
  %1897 = load i64, ptr %1896, align 8
  %1898 = add nsw i64 %1897, 1
  store i64 %1898, ptr %1896, align 8
  br label %2127

1899:                                             ; preds = %1893, %1529
  br i1 %304, label %2073, label %1900

1900:                                             ; preds = %1899
  %1901 = load double, ptr %604, align 8
  %1902 = load double, ptr %605, align 8
  %1903 = fcmp ogt double %1254, 1.000000e-10
  %1904 = select i1 %1903, double %1254, double 1.000000e-10
  %1905 = load double, ptr %606, align 8
  %1906 = load double, ptr %607, align 8
  %1907 = fneg double %1906
  %1908 = bitcast double %1904 to i64
  %1909 = add nsw i64 %1908, -4604544271217802189
  %1910 = ashr i64 %1909, 52
  %1911 = and i64 %1909, -4503599627370496
  %1912 = sub nsw i64 %1908, %1911
  %1913 = bitcast i64 %1912 to double
  %1914 = fadd double %1913, -1.000000e+00
  %1915 = fadd double %1913, 1.000000e+00
  %1916 = fdiv double %1914, %1915
  %1917 = fmul double %1916, %1916
  %1918 = tail call double @llvm.fma.f64(double %1917, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1919 = tail call double @llvm.fma.f64(double %1918, double %1917, double 0x3FE2776C50EF9BFE)
  %1920 = tail call double @llvm.fma.f64(double %1919, double %1917, double 0x3FEEC709DC3A03FD)
  %1921 = tail call double @llvm.fma.f64(double %1920, double %1917, double 0x40071547652B82FE)
  %1922 = trunc nsw i64 %1910 to i32
  %1923 = sitofp i32 %1922 to double
  %1924 = fmul double %1916, %1921
  %1925 = fadd double %1924, %1923
  %1926 = fmul double %1925, %1907
  %1927 = fcmp ogt double %1926, -1.000000e+03
  %1928 = select i1 %1927, double %1926, double -1.000000e+03
  %1929 = fcmp olt double %1928, 1.000000e+03
  %1930 = select i1 %1929, double %1928, double 1.000000e+03
  %1931 = tail call double @llvm.rint.f64(double %1930)
  %1932 = fsub double %1930, %1931
  %1933 = tail call double @llvm.fma.f64(double %1932, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1934 = tail call double @llvm.fma.f64(double %1933, double %1932, double 0x3F55D87FE78A6730)
  %1935 = tail call double @llvm.fma.f64(double %1934, double %1932, double 0x3F83B2AB6FBA4E77)
  %1936 = tail call double @llvm.fma.f64(double %1935, double %1932, double 0x3FAC6B08D704A0BF)
  %1937 = tail call double @llvm.fma.f64(double %1936, double %1932, double 0x3FCEBFBDFF82C58E)
  %1938 = tail call double @llvm.fma.f64(double %1937, double %1932, double 0x3FE62E42FEFA39EF)
  %1939 = tail call double @llvm.fma.f64(double %1938, double %1932, double 1.000000e+00)
  %1940 = bitcast double %1939 to i64
  %1941 = fptosi double %1931 to i32
  %1942 = sext i32 %1941 to i64
  %1943 = shl nsw i64 %1942, 52
  %1944 = add nsw i64 %1943, %1940
  %1945 = bitcast i64 %1944 to double
  %1946 = fmul double %1905, %1945
  %1947 = load double, ptr %608, align 8
  %1948 = fcmp une double %1947, 0.000000e+00
  br i1 %1948, label %1949, label %1989

1949:                                             ; preds = %1900
  %1950 = bitcast double %1901 to i64
  %1951 = add nsw i64 %1950, -4604544271217802189
  %1952 = ashr i64 %1951, 52
  %1953 = and i64 %1951, -4503599627370496
  %1954 = sub nsw i64 %1950, %1953
  %1955 = bitcast i64 %1954 to double
  %1956 = fadd double %1955, -1.000000e+00
  %1957 = fadd double %1955, 1.000000e+00
  %1958 = fdiv double %1956, %1957
  %1959 = fmul double %1958, %1958
  %1960 = tail call double @llvm.fma.f64(double %1959, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1961 = tail call double @llvm.fma.f64(double %1960, double %1959, double 0x3FE2776C50EF9BFE)
  %1962 = tail call double @llvm.fma.f64(double %1961, double %1959, double 0x3FEEC709DC3A03FD)
  %1963 = tail call double @llvm.fma.f64(double %1962, double %1959, double 0x40071547652B82FE)
  %1964 = trunc nsw i64 %1952 to i32
  %1965 = sitofp i32 %1964 to double
  %1966 = fmul double %1958, %1963
  %1967 = fadd double %1966, %1965
  %1968 = fmul double %1947, %1967
  %1969 = fcmp ogt double %1968, -1.000000e+03
  %1970 = select i1 %1969, double %1968, double -1.000000e+03
  %1971 = fcmp olt double %1970, 1.000000e+03
  %1972 = select i1 %1971, double %1970, double 1.000000e+03
  %1973 = tail call double @llvm.rint.f64(double %1972)
  %1974 = fsub double %1972, %1973
  %1975 = tail call double @llvm.fma.f64(double %1974, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1976 = tail call double @llvm.fma.f64(double %1975, double %1974, double 0x3F55D87FE78A6730)
  %1977 = tail call double @llvm.fma.f64(double %1976, double %1974, double 0x3F83B2AB6FBA4E77)
  %1978 = tail call double @llvm.fma.f64(double %1977, double %1974, double 0x3FAC6B08D704A0BF)
  %1979 = tail call double @llvm.fma.f64(double %1978, double %1974, double 0x3FCEBFBDFF82C58E)
  %1980 = tail call double @llvm.fma.f64(double %1979, double %1974, double 0x3FE62E42FEFA39EF)
  %1981 = tail call double @llvm.fma.f64(double %1980, double %1974, double 1.000000e+00)
  %1982 = bitcast double %1981 to i64
  %1983 = fptosi double %1973 to i32
  %1984 = sext i32 %1983 to i64
  %1985 = shl nsw i64 %1984, 52
  %1986 = add nsw i64 %1985, %1982
  %1987 = bitcast i64 %1986 to double
  %1988 = fmul double %1946, %1987
  br label %1989

1989:                                             ; preds = %1900, %1949
  %1990 = phi double [ %1988, %1949 ], [ %1946, %1900 ]
  %1991 = load double, ptr %609, align 8
  %1992 = fcmp ogt double %1990, %1991
  %1993 = select i1 %1992, double %1990, double %1991
  %1994 = fcmp olt double %1902, %1993
  %1995 = select i1 %1994, double %1902, double %1993
  %1996 = fmul double %712, %1995
  %1997 = fcmp oeq double %1902, 1.000000e+00
  br i1 %1997, label %1998, label %2065

1998:                                             ; preds = %1989
  %1999 = load double, ptr %610, align 8
  br i1 %1948, label %2000, label %2040

2000:                                             ; preds = %1998
  %2001 = bitcast double %1901 to i64
  %2002 = add nsw i64 %2001, -4604544271217802189
  %2003 = ashr i64 %2002, 52
  %2004 = and i64 %2002, -4503599627370496
  %2005 = sub nsw i64 %2001, %2004
  %2006 = bitcast i64 %2005 to double
  %2007 = fadd double %2006, -1.000000e+00
  %2008 = fadd double %2006, 1.000000e+00
  %2009 = fdiv double %2007, %2008
  %2010 = fmul double %2009, %2009
  %2011 = tail call double @llvm.fma.f64(double %2010, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %2012 = tail call double @llvm.fma.f64(double %2011, double %2010, double 0x3FE2776C50EF9BFE)
  %2013 = tail call double @llvm.fma.f64(double %2012, double %2010, double 0x3FEEC709DC3A03FD)
  %2014 = tail call double @llvm.fma.f64(double %2013, double %2010, double 0x40071547652B82FE)
  %2015 = trunc nsw i64 %2003 to i32
  %2016 = sitofp i32 %2015 to double
  %2017 = fmul double %2009, %2014
  %2018 = fadd double %2017, %2016
  %2019 = fmul double %1947, %2018
  %2020 = fcmp ogt double %2019, -1.000000e+03
  %2021 = select i1 %2020, double %2019, double -1.000000e+03
  %2022 = fcmp olt double %2021, 1.000000e+03
  %2023 = select i1 %2022, double %2021, double 1.000000e+03
  %2024 = tail call double @llvm.rint.f64(double %2023)
  %2025 = fsub double %2023, %2024
  %2026 = tail call double @llvm.fma.f64(double %2025, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %2027 = tail call double @llvm.fma.f64(double %2026, double %2025, double 0x3F55D87FE78A6730)
  %2028 = tail call double @llvm.fma.f64(double %2027, double %2025, double 0x3F83B2AB6FBA4E77)
  %2029 = tail call double @llvm.fma.f64(double %2028, double %2025, double 0x3FAC6B08D704A0BF)
  %2030 = tail call double @llvm.fma.f64(double %2029, double %2025, double 0x3FCEBFBDFF82C58E)
  %2031 = tail call double @llvm.fma.f64(double %2030, double %2025, double 0x3FE62E42FEFA39EF)
  %2032 = tail call double @llvm.fma.f64(double %2031, double %2025, double 1.000000e+00)
  %2033 = bitcast double %2032 to i64
  %2034 = fptosi double %2024 to i32
  %2035 = sext i32 %2034 to i64
  %2036 = shl nsw i64 %2035, 52
  %2037 = add nsw i64 %2036, %2033
  %2038 = bitcast i64 %2037 to double
  %2039 = fmul double %1946, %2038
  br label %2040

2040:                                             ; preds = %1998, %2000
  %2041 = phi double [ %2039, %2000 ], [ %1946, %1998 ]
  %2042 = fcmp ogt double %2041, %1991
  %2043 = select i1 %2042, double %2041, double %1991
  %2044 = fcmp olt double %1999, %2043
  %2045 = select i1 %2044, double %1999, double %2043
  %2046 = fmul double %712, %2045
  %2047 = load i64, ptr %279, align 8
  %2048 = icmp eq i64 %2047, 0
  br i1 %2048, label %2065, label %2049

2049:                                             ; preds = %2040
  %2050 = tail call fastcc double @knot_after(ptr noundef nonnull %184, double noundef %626) #11
  %2051 = fmul double %712, 1.000000e-03
  %2052 = fsub double %711, %2051
  %2053 = tail call double @llvm.fabs.f64(double %711)
  %2054 = fmul double %2053, 0x3D10000000000000
  %2055 = fsub double %2052, %2054
  %2056 = fcmp ogt double %2055, %2050
  %2057 = fadd double %711, %2054
  %2058 = fcmp ogt double %2050, %2057
  %2059 = or i1 %2056, %2058
  br i1 %2059, label %2065, label %2060

2060:                                             ; preds = %2049
  %2061 = tail call fastcc double @knot_after(ptr noundef nonnull %184, double noundef %711) #11
  %2062 = fsub double %2061, %711
  %2063 = fcmp olt double %2062, %2046
  %2064 = select i1 %2063, double %2062, double %2046
  br label %2065

2065:                                             ; preds = %2060, %2049, %2040, %1989
  %2066 = phi double [ %1996, %1989 ], [ %1996, %2040 ], [ %2064, %2060 ], [ %1996, %2049 ]
  %2067 = fcmp ogt double %627, %2066
  %2068 = select i1 %2067, double %627, double %2066
  %2069 = select i1 %716, double %2066, double %2068
  %2070 = fcmp ogt double %1254, 1.000000e-04
  %2071 = select i1 %2070, double %1254, double 1.000000e-04
  store double %2071, ptr %604, align 8
  %2072 = load double, ptr %611, align 8
  store double %2072, ptr %605, align 8
  br label %2073

2073:                                             ; preds = %2065, %1899
  %2074 = phi double [ %2069, %2065 ], [ %627, %1899 ]
  br i1 %612, label %2079, label %2075

2075:                                             ; preds = %2079, %2073
  %2076 = load i64, ptr %613, align 8
  %2077 = load i64, ptr %194, align 8
  %2078 = icmp eq i64 %2076, %2077
  br i1 %2078, label %2091, label %2092

2079:                                             ; preds = %2073, %2079
  %2080 = phi i64 [ %2089, %2079 ], [ 0, %2073 ]
  %2081 = getelementptr inbounds double, ptr %289, i64 %2080
  %2082 = load double, ptr %2081, align 8
  %2083 = load ptr, ptr %185, align 8
  %2084 = getelementptr inbounds double, ptr %2083, i64 %2080
  store double %2082, ptr %2084, align 8
  %2085 = getelementptr inbounds double, ptr %322, i64 %2080
  %2086 = load double, ptr %2085, align 8
  %2087 = load ptr, ptr %195, align 8
  %2088 = getelementptr inbounds double, ptr %2087, i64 %2080
  store double %2086, ptr %2088, align 8
  %2089 = add nuw nsw i64 %2080, 1
  %2090 = icmp eq i64 %2089, %298
  br i1 %2090, label %2075, label %2079, !llvm.loop !35

2091:                                             ; preds = %2075
  store double %2074, ptr %324, align 8
  br label %2127

2092:                                             ; preds = %2075
  %2093 = fcmp oeq double %711, %686
  br i1 %2093, label %2094, label %2127

2094:                                             ; preds = %2092
  %2095 = load i64, ptr %208, align 8
  %2096 = icmp sgt i64 %2095, 0
  br i1 %2096, label %2097, label %2099

2097:                                             ; preds = %2094
  %2098 = load ptr, ptr %280, align 8
  store double 0x7FF0000000000000, ptr %2098, align 8
  br label %2099

2099:                                             ; preds = %2094, %2097
  %2100 = load i64, ptr %598, align 8
  %2101 = add nsw i64 %2100, 1
  store i64 %2101, ptr %598, align 8
  %2102 = load ptr, ptr %185, align 8
  %2103 = load ptr, ptr %195, align 8
  %2104 = load ptr, ptr %281, align 8
  store double %711, ptr %2104, align 8
  %2105 = load ptr, ptr %184, align 8
  %2106 = getelementptr inbounds i8, ptr %2105, i64 40
  %2107 = load i64, ptr %2106, align 8
  %2108 = icmp eq i64 %2107, 0
  br i1 %2108, label %2110, label %2109

2109:                                             ; preds = %2099
  tail call fastcc void @settle(ptr noundef nonnull %184) #11
  br label %2110

2110:                                             ; preds = %2109, %2099
  %2111 = load i64, ptr %282, align 8
  %2112 = icmp sgt i64 %2111, 0
  br i1 %2112, label %2113, label %2114

2113:                                             ; preds = %2110
  tail call fastcc void @sample(ptr noundef nonnull %184) #11
  br label %2114

2114:                                             ; preds = %2110, %2113
  %2115 = load ptr, ptr %184, align 8
  %2116 = load i64, ptr %2115, align 8
  %2117 = load ptr, ptr %281, align 8
  %2118 = load ptr, ptr %283, align 8
  %2119 = load ptr, ptr %284, align 8
  %2120 = inttoptr i64 %2116 to ptr
  %2121 = load ptr, ptr %2120, align 8
  %2122 = tail call i32 %2121(ptr noundef %2117, ptr noundef %2102, ptr noundef %2118, ptr noundef %2119, ptr noundef %2103) #10
  %2123 = icmp eq i32 %2122, 0
  br i1 %2123, label %2127, label %2124

2124:                                             ; preds = %2114
  store i64 3, ptr %614, align 8
  store double %2074, ptr %324, align 8
  %2125 = icmp slt i32 %2122, 0
  %2126 = select i1 %2125, i64 -4, i64 2
  br label %2127

2127:                                             ; preds = %2124, %2114, %2092, %2091, %1895, %1883, %1685, %1341, %1340, %1241, %905, %718
  %2128 = phi double [ %627, %718 ], [ %627, %905 ], [ %627, %1241 ], [ %1339, %1341 ], [ %1339, %1340 ], [ %627, %1685 ], [ %1892, %1883 ], [ %627, %1895 ], [ %2074, %2091 ], [ %2074, %2124 ], [ %2074, %2114 ], [ %2074, %2092 ]
  %2129 = phi double [ %626, %718 ], [ %626, %905 ], [ %626, %1241 ], [ %626, %1341 ], [ %626, %1340 ], [ %626, %1685 ], [ %626, %1883 ], [ %626, %1895 ], [ %711, %2091 ], [ %711, %2124 ], [ %711, %2114 ], [ %711, %2092 ]
  %2130 = phi i32 [ 1, %718 ], [ 1, %905 ], [ 1, %1241 ], [ 3, %1341 ], [ 1, %1340 ], [ 1, %1685 ], [ 3, %1883 ], [ 1, %1895 ], [ 1, %2091 ], [ 1, %2124 ], [ 0, %2114 ], [ 0, %2092 ]
  %2131 = phi i64 [ 2, %718 ], [ -4, %905 ], [ -4, %1241 ], [ %625, %1341 ], [ 2, %1340 ], [ %1687, %1685 ], [ %625, %1883 ], [ %1877, %1895 ], [ 0, %2091 ], [ %2126, %2124 ], [ %625, %2114 ], [ %625, %2092 ]
  switch i32 %2130, label %2135 [
    i32 0, label %2132
    i32 3, label %2132
  ]

2132:                                             ; preds = %2127, %2127
  %2133 = load i64, ptr %291, align 8
  %2134 = icmp eq i64 %2133, 0
  br i1 %2134, label %621, label %623, !llvm.loop !24

2135:                                             ; preds = %2127, %287, %386, %428, %621, %640, %648
  %2136 = phi i64 [ -1, %287 ], [ %389, %386 ], [ -1, %621 ], [ -5, %640 ], [ 1, %648 ], [ 0, %428 ], [ %2131, %2127 ]
  %2137 = load ptr, ptr %286, align 8
  %2138 = getelementptr inbounds i8, ptr %2137, i64 48
  %2139 = load i64, ptr %2138, align 8
  %2140 = icmp ne i64 %2136, -2
  %2141 = icmp eq i64 %2139, 0
  %2142 = select i1 %2140, i1 true, i1 %2141
  br i1 %2142, label %2150, label %2143

2143:                                             ; preds = %2135
  %2144 = inttoptr i64 %2139 to ptr
  %2145 = tail call i64 %2144(ptr noundef %0) #10
  %2146 = icmp eq i64 %2145, 8
  %2147 = select i1 %2146, i64 8, i64 %2136
  %2148 = icmp eq i64 %2145, 1
  %2149 = zext i1 %2148 to i32
  br label %2150

2150:                                             ; preds = %2135, %2143
  %2151 = phi i64 [ %2136, %2135 ], [ %2147, %2143 ]
  %2152 = phi i32 [ 0, %2135 ], [ %2149, %2143 ]
  %2153 = icmp eq i32 %2152, 0
  br i1 %2153, label %2154, label %287, !llvm.loop !36

2154:                                             ; preds = %2150
  %2155 = getelementptr inbounds i8, ptr %0, i64 768
  %2156 = getelementptr inbounds i8, ptr %0, i64 320
  %2157 = load i64, ptr %2156, align 8
  %2158 = icmp sgt i64 %2157, 0
  br i1 %2158, label %2159, label %2162

2159:                                             ; preds = %2154
  %2160 = getelementptr inbounds i8, ptr %0, i64 336
  %2161 = load ptr, ptr %2160, align 8
  store double 0x7FF0000000000000, ptr %2161, align 8
  br label %2162

2162:                                             ; preds = %2154, %2159
  %2163 = icmp eq i64 %2151, 0
  %2164 = and i1 %9, %2163
  br i1 %2164, label %2165, label %2252

2165:                                             ; preds = %2162
  %2166 = load ptr, ptr %2155, align 8
  %2167 = getelementptr inbounds i8, ptr %2166, i64 8
  %2168 = load i64, ptr %2167, align 8
  %2169 = load ptr, ptr %186, align 8
  %2170 = load double, ptr %2169, align 8
  %2171 = tail call double @llvm.fabs.f64(double %2170)
  %2172 = fmul double %2171, 0x3CC0000000000000
  %2173 = icmp eq i64 %2168, 0
  br i1 %2173, label %2252, label %2174

2174:                                             ; preds = %2165
  %2175 = getelementptr inbounds i8, ptr %0, i64 248
  %2176 = load i64, ptr %2175, align 8
  %2177 = icmp sgt i64 %2176, 0
  br i1 %2177, label %2253, label %2178

2178:                                             ; preds = %2174
  %2179 = load ptr, ptr %184, align 8
  %2180 = getelementptr inbounds i8, ptr %2179, i64 40
  %2181 = load i64, ptr %2180, align 8
  %2182 = icmp eq i64 %2181, 0
  br i1 %2182, label %2183, label %2253

2183:                                             ; preds = %2178
  %2184 = getelementptr inbounds i8, ptr %0, i64 168
  %2185 = load ptr, ptr %2184, align 8
  store double %2170, ptr %2185, align 8
  %2186 = load ptr, ptr %2155, align 8
  %2187 = load i64, ptr %2186, align 8
  %2188 = load ptr, ptr %2184, align 8
  %2189 = load ptr, ptr %185, align 8
  %2190 = getelementptr inbounds i8, ptr %0, i64 192
  %2191 = load ptr, ptr %2190, align 8
  %2192 = getelementptr inbounds i8, ptr %0, i64 792
  %2193 = load ptr, ptr %2192, align 8
  %2194 = getelementptr inbounds i8, ptr %0, i64 984
  %2195 = load ptr, ptr %2194, align 8
  %2196 = inttoptr i64 %2187 to ptr
  %2197 = load ptr, ptr %2196, align 8
  %2198 = tail call i32 %2197(ptr noundef %2188, ptr noundef %2189, ptr noundef %2191, ptr noundef %2193, ptr noundef %2195) #10
  %2199 = load ptr, ptr %2155, align 8
  %2200 = getelementptr inbounds i8, ptr %2199, i64 56
  %2201 = load i64, ptr %2200, align 8
  %2202 = load ptr, ptr %2184, align 8
  %2203 = load ptr, ptr %185, align 8
  %2204 = load ptr, ptr %2190, align 8
  %2205 = getelementptr inbounds i8, ptr %0, i64 1152
  %2206 = load ptr, ptr %2205, align 8
  %2207 = getelementptr inbounds i8, ptr %0, i64 1200
  %2208 = load ptr, ptr %2207, align 8
  %2209 = inttoptr i64 %2201 to ptr
  %2210 = load ptr, ptr %2209, align 8
  %2211 = tail call i32 %2210(ptr noundef %2202, ptr noundef %2203, ptr noundef %2204, ptr noundef %2206, ptr noundef %2208) #10
  %2212 = icmp sgt i64 %2168, 0
  br i1 %2212, label %2213, label %2252

2213:                                             ; preds = %2183
  %2214 = getelementptr inbounds i8, ptr %0, i64 984
  %2215 = load ptr, ptr %2214, align 8
  %2216 = getelementptr inbounds i8, ptr %0, i64 936
  %2217 = load ptr, ptr %2216, align 8
  %2218 = getelementptr inbounds i8, ptr %0, i64 1200
  %2219 = load ptr, ptr %2218, align 8
  %2220 = load double, ptr %2215, align 8
  %2221 = load i64, ptr %2217, align 8
  %2222 = sitofp i64 %2221 to double
  %2223 = fmul double %2220, %2222
  %2224 = load double, ptr %2219, align 8
  %2225 = tail call double @llvm.fabs.f64(double %2224)
  %2226 = fmul double %2172, %2225
  %2227 = fcmp ogt double %2223, %2226
  %2228 = fcmp olt double %2223, 0.000000e+00
  %2229 = or i1 %2228, %2227
  br i1 %2229, label %2230, label %2250

2230:                                             ; preds = %2213, %2234
  %2231 = phi i64 [ %2232, %2234 ], [ 0, %2213 ]
  %2232 = add nuw nsw i64 %2231, 1
  %2233 = icmp eq i64 %2232, %2168
  br i1 %2233, label %2252, label %2234, !llvm.loop !37

2234:                                             ; preds = %2230
  %2235 = getelementptr inbounds double, ptr %2215, i64 %2232
  %2236 = load double, ptr %2235, align 8
  %2237 = getelementptr inbounds i64, ptr %2217, i64 %2232
  %2238 = load i64, ptr %2237, align 8
  %2239 = sitofp i64 %2238 to double
  %2240 = fmul double %2236, %2239
  %2241 = getelementptr inbounds double, ptr %2219, i64 %2232
  %2242 = load double, ptr %2241, align 8
  %2243 = tail call double @llvm.fabs.f64(double %2242)
  %2244 = fmul double %2172, %2243
  %2245 = fcmp ogt double %2240, %2244
  %2246 = fcmp olt double %2240, 0.000000e+00
  %2247 = or i1 %2246, %2245
  br i1 %2247, label %2230, label %2248, !llvm.loop !37

2248:                                             ; preds = %2234
  %2249 = icmp slt i64 %2232, %2168
  br label %2250

2250:                                             ; preds = %2248, %2213
  %2251 = phi i1 [ %2249, %2248 ], [ %2212, %2213 ]
  br i1 %2251, label %2253, label %2252

2252:                                             ; preds = %2230, %2183, %2165, %2250, %2162
  br label %2253

2253:                                             ; preds = %85, %89, %75, %2174, %2178, %2252, %2250, %181
  %2254 = phi i64 [ -7, %181 ], [ %2151, %2252 ], [ -8, %2250 ], [ -8, %2178 ], [ -8, %2174 ], [ -7, %75 ], [ -7, %89 ], [ -7, %85 ]
  ret i64 %2254
}



declare double @llvm.fabs.f64(double) #2

define internal fastcc void @settle(ptr noundef readonly %0) unnamed_addr #3 {
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
  br i1 %28, label %16, label %29, !llvm.loop !9

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

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #3 {
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
  br i1 %60, label %49, label %61, !llvm.loop !38

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
  br i1 %88, label %14, label %13, !llvm.loop !39
}

define internal fastcc void @norm_to(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, i64 noundef %4) unnamed_addr #4 {
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
  br i1 %41, label %13, label %18, !llvm.loop !40
}

declare double @llvm.sqrt.f64(double) #2

declare double @llvm.fma.f64(double, double, double) #2

declare double @llvm.rint.f64(double) #2

declare double @llvm.ceil.f64(double) #2

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
  br i1 %53, label %54, label %28, !llvm.loop !41

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
  br i1 %98, label %72, label %99, !llvm.loop !42

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
  br i1 %108, label %16, label %22, !llvm.loop !43

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
  br i1 %133, label %114, label %120, !llvm.loop !41

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
  br i1 %148, label %134, label %149, !llvm.loop !42

149:                                              ; preds = %134, %114
  %150 = phi <8 x double> [ %118, %114 ], [ %146, %134 ]
  store <8 x double> %150, ptr %111, align 8
  %151 = add nuw nsw i64 %110, 8
  %152 = icmp slt i64 %151, %11
  br i1 %152, label %109, label %153, !llvm.loop !44

153:                                              ; preds = %149, %16
  ret void
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

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
  br i1 %54, label %43, label %55, !llvm.loop !38

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
  br i1 %71, label %16, label %18, !llvm.loop !45
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
  br i1 %31, label %20, label %19, !llvm.loop !46

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
  br i1 %43, label %32, label %24, !llvm.loop !47
}

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #9

declare i64 @llvm.smin.i64(i64, i64) #9

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { nounwind willreturn memory(none) }
attributes #3 = { noinline nounwind }
attributes #4 = { noinline nounwind }
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
!23 = distinct !{!23, !4, !5}
!24 = distinct !{!24, !5}
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
!46 = distinct !{!46, !4, !5}
!47 = distinct !{!47, !4, !5}
