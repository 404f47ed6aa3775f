; sources 76a0c8435a22e836496abcc3aebb9dbf1a85d56b825cbb6d85a2634ac34fe7b5
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define i64 @extend(ptr noundef %0, ptr noundef readonly %1) #0 {
  %3 = getelementptr inbounds i8, ptr %0, i64 144
  %4 = getelementptr inbounds i8, ptr %0, i64 312
  %5 = load ptr, ptr %3, align 8
  %6 = getelementptr inbounds i8, ptr %5, i64 8
  %7 = load i64, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %1, i64 16
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %1, i64 32
  %11 = load i64, ptr %10, align 8
  %12 = icmp sgt i64 %11, 0
  br i1 %12, label %13, label %534

13:                                               ; preds = %2
  %14 = getelementptr inbounds i8, ptr %1, i64 24
  %15 = getelementptr inbounds i8, ptr %1, i64 48
  %16 = getelementptr inbounds i8, ptr %1, i64 72
  %17 = getelementptr inbounds i8, ptr %0, i64 320
  %18 = getelementptr inbounds i8, ptr %0, i64 600
  %19 = getelementptr inbounds i8, ptr %0, i64 480
  %20 = getelementptr inbounds i8, ptr %0, i64 168
  %21 = getelementptr inbounds i8, ptr %0, i64 248
  %22 = getelementptr inbounds i8, ptr %0, i64 192
  %23 = getelementptr inbounds i8, ptr %0, i64 216
  %24 = getelementptr inbounds i8, ptr %0, i64 384
  %25 = getelementptr inbounds i8, ptr %0, i64 360
  %26 = getelementptr inbounds i8, ptr %0, i64 24
  %27 = getelementptr inbounds i8, ptr %0, i64 480
  %28 = getelementptr inbounds i8, ptr %0, i64 48
  %29 = getelementptr inbounds i8, ptr %0, i64 72
  %30 = getelementptr inbounds i8, ptr %0, i64 320
  %31 = getelementptr inbounds i8, ptr %0, i64 96
  %32 = getelementptr inbounds i8, ptr %0, i64 336
  %33 = getelementptr inbounds i8, ptr %0, i64 24
  %34 = getelementptr inbounds i8, ptr %0, i64 480
  %35 = getelementptr inbounds i8, ptr %0, i64 48
  %36 = getelementptr inbounds i8, ptr %0, i64 72
  %37 = getelementptr inbounds i8, ptr %0, i64 336
  %38 = getelementptr inbounds i8, ptr %0, i64 336
  %39 = getelementptr inbounds i8, ptr %0, i64 320
  %40 = getelementptr inbounds i8, ptr %0, i64 480
  %41 = getelementptr inbounds i8, ptr %0, i64 504
  %42 = getelementptr inbounds i8, ptr %0, i64 360
  %43 = getelementptr inbounds i8, ptr %0, i64 24
  %44 = getelementptr inbounds i8, ptr %0, i64 384
  %45 = getelementptr inbounds i8, ptr %0, i64 48
  %46 = getelementptr inbounds i8, ptr %0, i64 72
  %47 = getelementptr inbounds i8, ptr %0, i64 96
  %48 = getelementptr inbounds i8, ptr %0, i64 336
  %49 = getelementptr inbounds i8, ptr %0, i64 432
  %50 = getelementptr inbounds i8, ptr %0, i64 24
  %51 = getelementptr inbounds i8, ptr %0, i64 384
  %52 = getelementptr inbounds i8, ptr %0, i64 48
  %53 = getelementptr inbounds i8, ptr %0, i64 72
  %54 = getelementptr inbounds i8, ptr %0, i64 504
  %55 = getelementptr inbounds i8, ptr %0, i64 408
  %56 = getelementptr inbounds i8, ptr %0, i64 504
  %57 = getelementptr inbounds i8, ptr %0, i64 320
  %58 = getelementptr inbounds i8, ptr %0, i64 648
  %59 = icmp sgt i64 %7, 0
  br label %60

60:                                               ; preds = %13, %530
  %61 = phi i64 [ undef, %13 ], [ %529, %530 ]
  %62 = phi i64 [ -1, %13 ], [ %528, %530 ]
  %63 = phi i64 [ 0, %13 ], [ %531, %530 ]
  %64 = load ptr, ptr %15, align 8
  %65 = getelementptr inbounds i64, ptr %64, i64 %63
  %66 = load i64, ptr %65, align 8
  %67 = load ptr, ptr %1, align 8
  %68 = mul nsw i64 %66, %9
  %69 = getelementptr inbounds double, ptr %67, i64 %68
  %70 = load ptr, ptr %14, align 8
  %71 = getelementptr inbounds double, ptr %70, i64 %63
  %72 = load double, ptr %71, align 8
  %73 = load ptr, ptr %16, align 8
  %74 = mul nsw i64 %63, %7
  %75 = getelementptr inbounds double, ptr %73, i64 %74
  %76 = getelementptr inbounds i8, ptr %69, i64 8
  %77 = load double, ptr %76, align 8
  %78 = fcmp oeq double %77, 0.000000e+00
  br i1 %78, label %79, label %88

79:                                               ; preds = %60
  %80 = getelementptr inbounds i8, ptr %69, i64 16
  br i1 %59, label %81, label %526

81:                                               ; preds = %79, %81
  %82 = phi i64 [ %86, %81 ], [ 0, %79 ]
  %83 = getelementptr inbounds double, ptr %80, i64 %82
  %84 = load double, ptr %83, align 8
  %85 = getelementptr inbounds double, ptr %75, i64 %82
  store double %84, ptr %85, align 8
  %86 = add nuw nsw i64 %82, 1
  %87 = icmp eq i64 %86, %7
  br i1 %87, label %526, label %81, !llvm.loop !3

88:                                               ; preds = %60
  %89 = icmp eq i64 %66, %62
  br i1 %89, label %496, label %90

90:                                               ; preds = %88
  %91 = getelementptr inbounds double, ptr %69, i64 %9
  %92 = load ptr, ptr %3, align 8
  %93 = getelementptr inbounds i8, ptr %92, i64 8
  %94 = load i64, ptr %93, align 8
  %95 = load i64, ptr %17, align 8
  %96 = load ptr, ptr %0, align 8
  %97 = load i64, ptr %96, align 8
  %98 = load double, ptr %69, align 8
  %99 = load ptr, ptr %18, align 8
  %100 = getelementptr inbounds i8, ptr %99, i64 24
  %101 = getelementptr inbounds i8, ptr %69, i64 16
  %102 = icmp sgt i64 %94, 0
  br i1 %102, label %113, label %103

103:                                              ; preds = %113, %90
  %104 = icmp eq i64 %97, 0
  br i1 %104, label %105, label %143

105:                                              ; preds = %103
  %106 = load ptr, ptr %0, align 8
  %107 = getelementptr inbounds i8, ptr %106, i64 24
  %108 = load i64, ptr %107, align 8
  %109 = icmp sgt i64 %108, 0
  br i1 %109, label %110, label %492

110:                                              ; preds = %105
  %111 = getelementptr i8, ptr %69, i64 16
  %112 = icmp sgt i64 %94, 0
  br label %121

113:                                              ; preds = %90, %113
  %114 = phi i64 [ %119, %113 ], [ 0, %90 ]
  %115 = getelementptr inbounds double, ptr %101, i64 %114
  %116 = load double, ptr %115, align 8
  %117 = load ptr, ptr %4, align 8
  %118 = getelementptr inbounds double, ptr %117, i64 %114
  store double %116, ptr %118, align 8
  %119 = add nuw nsw i64 %114, 1
  %120 = icmp eq i64 %119, %94
  br i1 %120, label %103, label %113, !llvm.loop !6

121:                                              ; preds = %110, %128
  %122 = phi i64 [ 0, %110 ], [ %129, %128 ]
  br i1 %112, label %123, label %128

123:                                              ; preds = %121
  %124 = add nuw nsw i64 %122, 1
  %125 = mul nuw nsw i64 %124, %94
  %126 = getelementptr double, ptr %111, i64 %125
  %127 = mul nsw i64 %122, %95
  br label %134

128:                                              ; preds = %134, %121
  %129 = add nuw nsw i64 %122, 1
  %130 = load ptr, ptr %0, align 8
  %131 = getelementptr inbounds i8, ptr %130, i64 24
  %132 = load i64, ptr %131, align 8
  %133 = icmp slt i64 %129, %132
  br i1 %133, label %121, label %492, !llvm.loop !7

134:                                              ; preds = %123, %134
  %135 = phi i64 [ 0, %123 ], [ %141, %134 ]
  %136 = getelementptr double, ptr %126, i64 %135
  %137 = load double, ptr %136, align 8
  %138 = load ptr, ptr %54, align 8
  %139 = getelementptr double, ptr %138, i64 %127
  %140 = getelementptr double, ptr %139, i64 %135
  store double %137, ptr %140, align 8
  %141 = add nuw nsw i64 %135, 1
  %142 = icmp eq i64 %141, %94
  br i1 %142, label %128, label %134, !llvm.loop !8

143:                                              ; preds = %103
  %144 = load ptr, ptr %4, align 8
  %145 = load ptr, ptr %19, align 8
  %146 = load ptr, ptr %20, align 8
  store double %98, ptr %146, align 8
  %147 = load i64, ptr %21, align 8
  %148 = icmp sgt i64 %147, 0
  br i1 %148, label %149, label %150

149:                                              ; preds = %143
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %150

150:                                              ; preds = %143, %149
  %151 = load ptr, ptr %3, align 8
  %152 = load i64, ptr %151, align 8
  %153 = load ptr, ptr %20, align 8
  %154 = load ptr, ptr %22, align 8
  %155 = load ptr, ptr %23, align 8
  %156 = inttoptr i64 %152 to ptr
  %157 = load ptr, ptr %156, align 8
  %158 = tail call i32 %157(ptr noundef %153, ptr noundef %144, ptr noundef %154, ptr noundef %155, ptr noundef %145) #6
  %159 = sext i32 %158 to i64
  %160 = icmp eq i32 %158, 0
  br i1 %160, label %161, label %314

161:                                              ; preds = %150
  %162 = load ptr, ptr %0, align 8
  %163 = load i64, ptr %162, align 8
  %164 = load ptr, ptr %24, align 8
  %165 = insertelement <8 x double> poison, double %77, i64 0
  %166 = shufflevector <8 x double> %165, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %166, ptr %164, align 8
  %167 = icmp sgt i64 %163, 1
  br i1 %167, label %172, label %257

168:                                              ; preds = %245
  %169 = add nuw nsw i64 %175, 1
  %170 = icmp slt i64 %169, %163
  %171 = icmp eq i64 %169, %163
  br i1 %171, label %257, label %172, !llvm.loop !9

172:                                              ; preds = %161, %168
  %173 = phi i1 [ %170, %168 ], [ %167, %161 ]
  %174 = phi i64 [ %256, %168 ], [ undef, %161 ]
  %175 = phi i64 [ %169, %168 ], [ 1, %161 ]
  %176 = load ptr, ptr %25, align 8
  %177 = load ptr, ptr %4, align 8
  %178 = load ptr, ptr %3, align 8
  %179 = getelementptr inbounds i8, ptr %178, i64 16
  %180 = load i64, ptr %179, align 8
  %181 = icmp sgt i64 %180, 1
  %182 = zext i1 %181 to i64
  %183 = load ptr, ptr %26, align 8
  %184 = getelementptr inbounds i64, ptr %183, i64 %175
  %185 = load i64, ptr %184, align 8
  %186 = getelementptr i8, ptr %184, i64 8
  %187 = load i64, ptr %186, align 8
  %188 = xor i64 %185, -1
  %189 = add i64 %187, %188
  %190 = load ptr, ptr %24, align 8
  %191 = load ptr, ptr %27, align 8
  %192 = load ptr, ptr %28, align 8
  %193 = getelementptr inbounds i64, ptr %192, i64 %185
  %194 = load ptr, ptr %29, align 8
  %195 = getelementptr inbounds double, ptr %194, i64 %185
  tail call fastcc void @combine(ptr noundef %176, ptr noundef %177, ptr noundef %190, ptr noundef %191, ptr noundef %193, ptr noundef %195, i64 noundef %189, i64 noundef %182, i64 noundef %180) #5
  %196 = icmp eq i64 %180, 1
  br i1 %196, label %197, label %228

197:                                              ; preds = %172
  %198 = load ptr, ptr %26, align 8
  %199 = getelementptr i64, ptr %198, i64 %175
  %200 = getelementptr i8, ptr %199, i64 8
  %201 = load i64, ptr %200, align 8
  %202 = add nsw i64 %201, -1
  %203 = load ptr, ptr %29, align 8
  %204 = getelementptr inbounds double, ptr %203, i64 %202
  %205 = load double, ptr %204, align 8
  %206 = fmul double %77, %205
  %207 = load ptr, ptr %27, align 8
  %208 = load ptr, ptr %28, align 8
  %209 = getelementptr inbounds i64, ptr %208, i64 %202
  %210 = load i64, ptr %209, align 8
  %211 = getelementptr inbounds double, ptr %207, i64 %210
  %212 = load ptr, ptr %3, align 8
  %213 = getelementptr inbounds i8, ptr %212, i64 8
  %214 = load i64, ptr %213, align 8
  %215 = icmp sgt i64 %214, 0
  br i1 %215, label %216, label %228

216:                                              ; preds = %197, %216
  %217 = phi i64 [ %223, %216 ], [ 0, %197 ]
  %218 = getelementptr inbounds double, ptr %211, i64 %217
  %219 = load double, ptr %218, align 8
  %220 = getelementptr inbounds double, ptr %176, i64 %217
  %221 = load double, ptr %220, align 8
  %222 = tail call double @llvm.fma.f64(double %206, double %219, double %221)
  store double %222, ptr %220, align 8
  %223 = add nuw nsw i64 %217, 1
  %224 = load ptr, ptr %3, align 8
  %225 = getelementptr inbounds i8, ptr %224, i64 8
  %226 = load i64, ptr %225, align 8
  %227 = icmp slt i64 %223, %226
  br i1 %227, label %216, label %228, !llvm.loop !10

228:                                              ; preds = %216, %197, %172
  %229 = load ptr, ptr %27, align 8
  %230 = load i64, ptr %30, align 8
  %231 = mul nsw i64 %230, %175
  %232 = getelementptr inbounds double, ptr %229, i64 %231
  %233 = load i64, ptr %100, align 8
  %234 = add nsw i64 %233, 1
  store i64 %234, ptr %100, align 8
  %235 = load ptr, ptr %31, align 8
  %236 = getelementptr inbounds double, ptr %235, i64 %175
  %237 = load double, ptr %236, align 8
  %238 = fmul double %77, %237
  %239 = fadd double %98, %238
  %240 = load ptr, ptr %25, align 8
  %241 = load ptr, ptr %20, align 8
  store double %239, ptr %241, align 8
  %242 = load i64, ptr %21, align 8
  %243 = icmp sgt i64 %242, 0
  br i1 %243, label %244, label %245

244:                                              ; preds = %228
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %245

245:                                              ; preds = %228, %244
  %246 = load ptr, ptr %3, align 8
  %247 = load i64, ptr %246, align 8
  %248 = load ptr, ptr %20, align 8
  %249 = load ptr, ptr %22, align 8
  %250 = load ptr, ptr %23, align 8
  %251 = inttoptr i64 %247 to ptr
  %252 = load ptr, ptr %251, align 8
  %253 = tail call i32 %252(ptr noundef %248, ptr noundef %240, ptr noundef %249, ptr noundef %250, ptr noundef %232) #6
  %254 = sext i32 %253 to i64
  %255 = icmp eq i32 %253, 0
  %256 = select i1 %255, i64 %174, i64 %254
  br i1 %255, label %168, label %257

257:                                              ; preds = %168, %245, %161
  %258 = phi i1 [ %167, %161 ], [ %170, %168 ], [ %173, %245 ]
  %259 = phi i64 [ 0, %161 ], [ %254, %245 ], [ %254, %168 ]
  %260 = phi i64 [ undef, %161 ], [ %256, %245 ], [ %256, %168 ]
  br i1 %258, label %314, label %261

261:                                              ; preds = %257
  %262 = load ptr, ptr %32, align 8
  %263 = load ptr, ptr %4, align 8
  %264 = load ptr, ptr %3, align 8
  %265 = getelementptr inbounds i8, ptr %264, i64 16
  %266 = load i64, ptr %265, align 8
  %267 = icmp sgt i64 %266, 1
  %268 = zext i1 %267 to i64
  %269 = load ptr, ptr %33, align 8
  %270 = getelementptr inbounds i64, ptr %269, i64 %163
  %271 = load i64, ptr %270, align 8
  %272 = getelementptr i8, ptr %270, i64 8
  %273 = load i64, ptr %272, align 8
  %274 = xor i64 %271, -1
  %275 = add i64 %273, %274
  %276 = load ptr, ptr %24, align 8
  %277 = load ptr, ptr %34, align 8
  %278 = load ptr, ptr %35, align 8
  %279 = getelementptr inbounds i64, ptr %278, i64 %271
  %280 = load ptr, ptr %36, align 8
  %281 = getelementptr inbounds double, ptr %280, i64 %271
  tail call fastcc void @combine(ptr noundef %262, ptr noundef %263, ptr noundef %276, ptr noundef %277, ptr noundef %279, ptr noundef %281, i64 noundef %275, i64 noundef %268, i64 noundef %266) #5
  %282 = icmp eq i64 %266, 1
  br i1 %282, label %283, label %314

283:                                              ; preds = %261
  %284 = load ptr, ptr %33, align 8
  %285 = getelementptr i64, ptr %284, i64 %163
  %286 = getelementptr i8, ptr %285, i64 8
  %287 = load i64, ptr %286, align 8
  %288 = add nsw i64 %287, -1
  %289 = load ptr, ptr %36, align 8
  %290 = getelementptr inbounds double, ptr %289, i64 %288
  %291 = load double, ptr %290, align 8
  %292 = fmul double %77, %291
  %293 = load ptr, ptr %34, align 8
  %294 = load ptr, ptr %35, align 8
  %295 = getelementptr inbounds i64, ptr %294, i64 %288
  %296 = load i64, ptr %295, align 8
  %297 = getelementptr inbounds double, ptr %293, i64 %296
  %298 = load ptr, ptr %3, align 8
  %299 = getelementptr inbounds i8, ptr %298, i64 8
  %300 = load i64, ptr %299, align 8
  %301 = icmp sgt i64 %300, 0
  br i1 %301, label %302, label %314

302:                                              ; preds = %283, %302
  %303 = phi i64 [ %309, %302 ], [ 0, %283 ]
  %304 = getelementptr inbounds double, ptr %297, i64 %303
  %305 = load double, ptr %304, align 8
  %306 = getelementptr inbounds double, ptr %262, i64 %303
  %307 = load double, ptr %306, align 8
  %308 = tail call double @llvm.fma.f64(double %292, double %305, double %307)
  store double %308, ptr %306, align 8
  %309 = add nuw nsw i64 %303, 1
  %310 = load ptr, ptr %3, align 8
  %311 = getelementptr inbounds i8, ptr %310, i64 8
  %312 = load i64, ptr %311, align 8
  %313 = icmp slt i64 %309, %312
  br i1 %313, label %302, label %314, !llvm.loop !10

314:                                              ; preds = %302, %283, %257, %261, %150
  %315 = phi i64 [ %159, %150 ], [ %260, %257 ], [ %259, %261 ], [ %259, %283 ], [ %259, %302 ]
  %316 = icmp eq i64 %315, 0
  br i1 %316, label %317, label %492

317:                                              ; preds = %314
  %318 = getelementptr inbounds i8, ptr %91, i64 16
  %319 = icmp sgt i64 %94, 0
  br i1 %319, label %341, label %320

320:                                              ; preds = %341, %317
  %321 = load double, ptr %91, align 8
  %322 = load ptr, ptr %38, align 8
  %323 = load ptr, ptr %19, align 8
  %324 = mul nsw i64 %97, %95
  %325 = getelementptr inbounds double, ptr %323, i64 %324
  %326 = load ptr, ptr %20, align 8
  store double %321, ptr %326, align 8
  %327 = load i64, ptr %21, align 8
  %328 = icmp sgt i64 %327, 0
  br i1 %328, label %329, label %330

329:                                              ; preds = %320
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %330

330:                                              ; preds = %320, %329
  %331 = load ptr, ptr %3, align 8
  %332 = load i64, ptr %331, align 8
  %333 = load ptr, ptr %20, align 8
  %334 = load ptr, ptr %22, align 8
  %335 = load ptr, ptr %23, align 8
  %336 = inttoptr i64 %332 to ptr
  %337 = load ptr, ptr %336, align 8
  %338 = tail call i32 %337(ptr noundef %333, ptr noundef %322, ptr noundef %334, ptr noundef %335, ptr noundef %325) #6
  %339 = sext i32 %338 to i64
  %340 = icmp eq i32 %338, 0
  br i1 %340, label %349, label %492

341:                                              ; preds = %317, %341
  %342 = phi i64 [ %347, %341 ], [ 0, %317 ]
  %343 = getelementptr inbounds double, ptr %318, i64 %342
  %344 = load double, ptr %343, align 8
  %345 = load ptr, ptr %37, align 8
  %346 = getelementptr inbounds double, ptr %345, i64 %342
  store double %344, ptr %346, align 8
  %347 = add nuw nsw i64 %342, 1
  %348 = icmp eq i64 %347, %94
  br i1 %348, label %320, label %341, !llvm.loop !11

349:                                              ; preds = %330
  %350 = load ptr, ptr %0, align 8
  %351 = load ptr, ptr %3, align 8
  %352 = getelementptr inbounds i8, ptr %351, i64 16
  %353 = load i64, ptr %352, align 8
  %354 = load i64, ptr %350, align 8
  %355 = load i64, ptr %39, align 8
  %356 = load ptr, ptr %40, align 8
  %357 = mul nsw i64 %355, %354
  %358 = getelementptr inbounds double, ptr %356, i64 %357
  %359 = load ptr, ptr %41, align 8
  %360 = add nsw i64 %354, 1
  %361 = getelementptr inbounds i8, ptr %350, i64 16
  %362 = load i64, ptr %361, align 8
  %363 = icmp sgt i64 %362, 0
  br i1 %363, label %364, label %419

364:                                              ; preds = %349
  %365 = getelementptr inbounds i8, ptr %350, i64 8
  br label %371

366:                                              ; preds = %407
  %367 = add nsw i64 %374, 1
  %368 = load i64, ptr %361, align 8
  %369 = add nsw i64 %368, %360
  %370 = icmp slt i64 %367, %369
  br i1 %370, label %371, label %419, !llvm.loop !12

371:                                              ; preds = %364, %366
  %372 = phi i1 [ %363, %364 ], [ %370, %366 ]
  %373 = phi i64 [ undef, %364 ], [ %418, %366 ]
  %374 = phi i64 [ %360, %364 ], [ %367, %366 ]
  %375 = load i64, ptr %365, align 8
  %376 = load ptr, ptr %42, align 8
  %377 = load ptr, ptr %4, align 8
  %378 = load ptr, ptr %43, align 8
  %379 = getelementptr i64, ptr %378, i64 %374
  %380 = getelementptr i64, ptr %379, i64 %375
  %381 = load i64, ptr %380, align 8
  %382 = getelementptr i8, ptr %380, i64 8
  %383 = load i64, ptr %382, align 8
  %384 = xor i64 %381, -1
  %385 = add i64 %383, %384
  %386 = load ptr, ptr %44, align 8
  %387 = load ptr, ptr %40, align 8
  %388 = load ptr, ptr %45, align 8
  %389 = getelementptr inbounds i64, ptr %388, i64 %381
  %390 = load ptr, ptr %46, align 8
  %391 = getelementptr inbounds double, ptr %390, i64 %381
  tail call fastcc void @combine(ptr noundef %376, ptr noundef %377, ptr noundef %386, ptr noundef %387, ptr noundef %389, ptr noundef %391, i64 noundef %385, i64 noundef 1, i64 noundef %353) #5
  %392 = load ptr, ptr %40, align 8
  %393 = mul nsw i64 %374, %355
  %394 = getelementptr inbounds double, ptr %392, i64 %393
  %395 = load i64, ptr %100, align 8
  %396 = add nsw i64 %395, 1
  store i64 %396, ptr %100, align 8
  %397 = load ptr, ptr %47, align 8
  %398 = getelementptr inbounds double, ptr %397, i64 %374
  %399 = load double, ptr %398, align 8
  %400 = fmul double %77, %399
  %401 = fadd double %98, %400
  %402 = load ptr, ptr %42, align 8
  %403 = load ptr, ptr %20, align 8
  store double %401, ptr %403, align 8
  %404 = load i64, ptr %21, align 8
  %405 = icmp sgt i64 %404, 0
  br i1 %405, label %406, label %407

406:                                              ; preds = %371
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %407

407:                                              ; preds = %371, %406
  %408 = load ptr, ptr %3, align 8
  %409 = load i64, ptr %408, align 8
  %410 = load ptr, ptr %20, align 8
  %411 = load ptr, ptr %22, align 8
  %412 = load ptr, ptr %23, align 8
  %413 = inttoptr i64 %409 to ptr
  %414 = load ptr, ptr %413, align 8
  %415 = tail call i32 %414(ptr noundef %410, ptr noundef %402, ptr noundef %411, ptr noundef %412, ptr noundef %394) #6
  %416 = sext i32 %415 to i64
  %417 = icmp eq i32 %415, 0
  %418 = select i1 %417, i64 %373, i64 %416
  br i1 %417, label %366, label %419

419:                                              ; preds = %366, %407, %349
  %420 = phi i1 [ %363, %349 ], [ %370, %366 ], [ %372, %407 ]
  %421 = phi i64 [ 0, %349 ], [ %416, %407 ], [ %416, %366 ]
  %422 = phi i64 [ undef, %349 ], [ %418, %407 ], [ %418, %366 ]
  %423 = getelementptr inbounds i8, ptr %350, i64 16
  br i1 %420, label %492, label %424

424:                                              ; preds = %419
  %425 = load ptr, ptr %3, align 8
  %426 = getelementptr inbounds i8, ptr %425, i64 8
  %427 = load i64, ptr %426, align 8
  %428 = icmp sgt i64 %427, 0
  br i1 %428, label %429, label %433

429:                                              ; preds = %424
  %430 = getelementptr inbounds double, ptr %359, i64 %355
  %431 = shl nsw i64 %355, 4
  %432 = getelementptr inbounds i8, ptr %359, i64 %431
  br label %440

433:                                              ; preds = %440, %424
  %434 = getelementptr inbounds i8, ptr %350, i64 8
  %435 = load i64, ptr %434, align 8
  %436 = load i64, ptr %423, align 8
  %437 = getelementptr inbounds i8, ptr %350, i64 24
  %438 = load i64, ptr %437, align 8
  %439 = icmp sgt i64 %438, 3
  br i1 %439, label %467, label %492

440:                                              ; preds = %429, %440
  %441 = phi i64 [ 0, %429 ], [ %462, %440 ]
  %442 = load ptr, ptr %48, align 8
  %443 = getelementptr inbounds double, ptr %442, i64 %441
  %444 = load double, ptr %443, align 8
  %445 = load ptr, ptr %4, align 8
  %446 = getelementptr inbounds double, ptr %445, i64 %441
  %447 = load double, ptr %446, align 8
  %448 = fsub double %444, %447
  %449 = load ptr, ptr %40, align 8
  %450 = getelementptr inbounds double, ptr %449, i64 %441
  %451 = load double, ptr %450, align 8
  %452 = fmul double %77, %451
  %453 = fsub double %452, %448
  %454 = getelementptr inbounds double, ptr %359, i64 %441
  store double %448, ptr %454, align 8
  %455 = getelementptr inbounds double, ptr %430, i64 %441
  store double %453, ptr %455, align 8
  %456 = fsub double %448, %453
  %457 = getelementptr inbounds double, ptr %358, i64 %441
  %458 = load double, ptr %457, align 8
  %459 = fmul double %77, %458
  %460 = fsub double %456, %459
  %461 = getelementptr inbounds double, ptr %432, i64 %441
  store double %460, ptr %461, align 8
  %462 = add nuw nsw i64 %441, 1
  %463 = load ptr, ptr %3, align 8
  %464 = getelementptr inbounds i8, ptr %463, i64 8
  %465 = load i64, ptr %464, align 8
  %466 = icmp slt i64 %462, %465
  br i1 %466, label %440, label %433, !llvm.loop !13

467:                                              ; preds = %433, %467
  %468 = phi i64 [ %489, %467 ], [ 3, %433 ]
  %469 = mul nsw i64 %468, %355
  %470 = getelementptr inbounds double, ptr %359, i64 %469
  %471 = load ptr, ptr %49, align 8
  %472 = load ptr, ptr %50, align 8
  %473 = getelementptr i64, ptr %472, i64 %360
  %474 = getelementptr i64, ptr %473, i64 %435
  %475 = getelementptr i64, ptr %474, i64 %436
  %476 = getelementptr i64, ptr %475, i64 %468
  %477 = getelementptr i8, ptr %476, i64 -24
  %478 = load i64, ptr %477, align 8
  %479 = getelementptr i8, ptr %476, i64 -16
  %480 = load i64, ptr %479, align 8
  %481 = xor i64 %478, -1
  %482 = add i64 %480, %481
  %483 = load ptr, ptr %51, align 8
  %484 = load ptr, ptr %40, align 8
  %485 = load ptr, ptr %52, align 8
  %486 = getelementptr inbounds i64, ptr %485, i64 %478
  %487 = load ptr, ptr %53, align 8
  %488 = getelementptr inbounds double, ptr %487, i64 %478
  tail call fastcc void @combine(ptr noundef %470, ptr noundef %471, ptr noundef %483, ptr noundef %484, ptr noundef %486, ptr noundef %488, i64 noundef %482, i64 noundef 1, i64 noundef %353) #5
  %489 = add nuw nsw i64 %468, 1
  %490 = load i64, ptr %437, align 8
  %491 = icmp slt i64 %489, %490
  br i1 %491, label %467, label %492, !llvm.loop !14

492:                                              ; preds = %467, %128, %433, %105, %419, %314, %330
  %493 = phi i64 [ %315, %314 ], [ %339, %330 ], [ %422, %419 ], [ 0, %105 ], [ %421, %433 ], [ 0, %128 ], [ %421, %467 ]
  %494 = icmp eq i64 %493, 0
  %495 = select i1 %494, i64 %61, i64 %493
  br i1 %494, label %496, label %526

496:                                              ; preds = %492, %88
  %497 = phi i64 [ %66, %492 ], [ %62, %88 ]
  %498 = phi i64 [ %495, %492 ], [ %61, %88 ]
  %499 = load double, ptr %69, align 8
  %500 = fsub double %72, %499
  %501 = load double, ptr %76, align 8
  %502 = fdiv double %500, %501
  %503 = load ptr, ptr %55, align 8
  %504 = insertelement <8 x double> poison, double %502, i64 0
  %505 = shufflevector <8 x double> %504, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %505, ptr %503, align 8
  %506 = load ptr, ptr %4, align 8
  %507 = load ptr, ptr %56, align 8
  %508 = load i64, ptr %57, align 8
  %509 = load ptr, ptr %0, align 8
  %510 = getelementptr inbounds i8, ptr %509, i64 24
  %511 = load i64, ptr %510, align 8
  %512 = load ptr, ptr %55, align 8
  %513 = load ptr, ptr %3, align 8
  %514 = getelementptr inbounds i8, ptr %513, i64 16
  %515 = load i64, ptr %514, align 8
  tail call fastcc void @nested(ptr noundef %75, ptr noundef %506, ptr noundef %507, i64 noundef %508, i64 noundef %511, ptr noundef %512, i64 noundef %515) #5
  %516 = load ptr, ptr %58, align 8
  %517 = load i64, ptr %516, align 8
  %518 = icmp eq i64 %517, 1
  %519 = fcmp ogt double %502, 0.000000e+00
  %520 = and i1 %519, %518
  br i1 %520, label %521, label %526

521:                                              ; preds = %496
  %522 = getelementptr inbounds i8, ptr %516, i64 56
  %523 = load i64, ptr %522, align 8
  %524 = inttoptr i64 %523 to ptr
  %525 = tail call i64 %524(ptr noundef %0, double noundef %72, ptr noundef %75, ptr noundef null) #6
  br label %526

526:                                              ; preds = %81, %79, %496, %521, %492
  %527 = phi i32 [ 1, %492 ], [ 0, %521 ], [ 0, %496 ], [ 4, %79 ], [ 4, %81 ]
  %528 = phi i64 [ %66, %492 ], [ %497, %521 ], [ %497, %496 ], [ %62, %79 ], [ %62, %81 ]
  %529 = phi i64 [ %495, %492 ], [ %498, %521 ], [ %498, %496 ], [ %61, %79 ], [ %61, %81 ]
  switch i32 %527, label %534 [
    i32 0, label %530
    i32 4, label %530
  ]

530:                                              ; preds = %526, %526
  %531 = add nuw nsw i64 %63, 1
  %532 = load i64, ptr %10, align 8
  %533 = icmp slt i64 %531, %532
  br i1 %533, label %60, label %534, !llvm.loop !15

534:                                              ; preds = %526, %530, %2
  %535 = phi i64 [ 0, %2 ], [ %529, %526 ], [ 0, %530 ]
  ret i64 %535
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #1 {
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
  br i1 %55, label %44, label %56, !llvm.loop !16

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
  br i1 %83, label %13, label %12, !llvm.loop !17
}

declare double @llvm.fma.f64(double, double, double) #2

define internal fastcc void @combine(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, ptr noundef readonly %4, ptr noundef readonly %5, i64 noundef %6, i64 noundef %7, i64 noundef %8) unnamed_addr #3 {
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
  br i1 %53, label %54, label %28, !llvm.loop !18

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
  br i1 %98, label %72, label %99, !llvm.loop !19

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
  br i1 %108, label %16, label %22, !llvm.loop !20

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
  br i1 %133, label %114, label %120, !llvm.loop !18

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
  br i1 %148, label %134, label %149, !llvm.loop !19

149:                                              ; preds = %134, %114
  %150 = phi <8 x double> [ %118, %114 ], [ %146, %134 ]
  store <8 x double> %150, ptr %111, align 8
  %151 = add nuw nsw i64 %110, 8
  %152 = icmp slt i64 %151, %11
  br i1 %152, label %109, label %153, !llvm.loop !21

153:                                              ; preds = %149, %16
  ret void
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

define internal fastcc void @nested(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, i64 noundef %3, i64 noundef %4, ptr noundef readonly %5, i64 noundef %6) unnamed_addr #4 {
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
  br i1 %31, label %20, label %19, !llvm.loop !22

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
  br i1 %43, label %32, label %24, !llvm.loop !23
}

attributes #0 = { nounwind }
attributes #1 = { noinline nounwind }
attributes #2 = { nounwind willreturn memory(none) }
attributes #3 = { noinline nounwind }
attributes #4 = { noinline nounwind }
attributes #5 = { nounwind }
attributes #6 = { nounwind }


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
