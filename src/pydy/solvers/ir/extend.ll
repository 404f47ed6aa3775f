; sources 88e4028e718f8f7983890f61c2a5f626d08c631428097f31511ef71377df2e9d
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
  br i1 %12, label %13, label %530

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

60:                                               ; preds = %13, %526
  %61 = phi i64 [ undef, %13 ], [ %525, %526 ]
  %62 = phi i64 [ -1, %13 ], [ %524, %526 ]
  %63 = phi i64 [ 0, %13 ], [ %527, %526 ]
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
  br i1 %59, label %81, label %522

81:                                               ; preds = %79, %81
  %82 = phi i64 [ %86, %81 ], [ 0, %79 ]
  %83 = getelementptr inbounds double, ptr %80, i64 %82
  %84 = load double, ptr %83, align 8
  %85 = getelementptr inbounds double, ptr %75, i64 %82
  store double %84, ptr %85, align 8
  %86 = add nuw nsw i64 %82, 1
  %87 = icmp eq i64 %86, %7
  br i1 %87, label %522, label %81, !llvm.loop !3

88:                                               ; preds = %60
  %89 = icmp eq i64 %66, %62
  br i1 %89, label %492, label %90

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
  br i1 %109, label %110, label %488

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
  br i1 %133, label %121, label %488, !llvm.loop !7

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
  %157 = tail call i32 %156(ptr noundef %153, ptr noundef %144, ptr noundef %154, ptr noundef %155, ptr noundef %145) #6
  %158 = sext i32 %157 to i64
  %159 = icmp eq i32 %157, 0
  br i1 %159, label %160, label %312

160:                                              ; preds = %150
  %161 = load ptr, ptr %0, align 8
  %162 = load i64, ptr %161, align 8
  %163 = load ptr, ptr %24, align 8
  %164 = insertelement <8 x double> poison, double %77, i64 0
  %165 = shufflevector <8 x double> %164, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %165, ptr %163, align 8
  %166 = icmp sgt i64 %162, 1
  br i1 %166, label %171, label %255

167:                                              ; preds = %244
  %168 = add nuw nsw i64 %174, 1
  %169 = icmp slt i64 %168, %162
  %170 = icmp eq i64 %168, %162
  br i1 %170, label %255, label %171, !llvm.loop !9

171:                                              ; preds = %160, %167
  %172 = phi i1 [ %169, %167 ], [ %166, %160 ]
  %173 = phi i64 [ %254, %167 ], [ undef, %160 ]
  %174 = phi i64 [ %168, %167 ], [ 1, %160 ]
  %175 = load ptr, ptr %25, align 8
  %176 = load ptr, ptr %4, align 8
  %177 = load ptr, ptr %3, align 8
  %178 = getelementptr inbounds i8, ptr %177, i64 16
  %179 = load i64, ptr %178, align 8
  %180 = icmp sgt i64 %179, 1
  %181 = zext i1 %180 to i64
  %182 = load ptr, ptr %26, align 8
  %183 = getelementptr inbounds i64, ptr %182, i64 %174
  %184 = load i64, ptr %183, align 8
  %185 = getelementptr i8, ptr %183, i64 8
  %186 = load i64, ptr %185, align 8
  %187 = xor i64 %184, -1
  %188 = add i64 %186, %187
  %189 = load ptr, ptr %24, align 8
  %190 = load ptr, ptr %27, align 8
  %191 = load ptr, ptr %28, align 8
  %192 = getelementptr inbounds i64, ptr %191, i64 %184
  %193 = load ptr, ptr %29, align 8
  %194 = getelementptr inbounds double, ptr %193, i64 %184
  tail call fastcc void @combine(ptr noundef %175, ptr noundef %176, ptr noundef %189, ptr noundef %190, ptr noundef %192, ptr noundef %194, i64 noundef %188, i64 noundef %181, i64 noundef %179) #5
  %195 = icmp eq i64 %179, 1
  br i1 %195, label %196, label %227

196:                                              ; preds = %171
  %197 = load ptr, ptr %26, align 8
  %198 = getelementptr i64, ptr %197, i64 %174
  %199 = getelementptr i8, ptr %198, i64 8
  %200 = load i64, ptr %199, align 8
  %201 = add nsw i64 %200, -1
  %202 = load ptr, ptr %29, align 8
  %203 = getelementptr inbounds double, ptr %202, i64 %201
  %204 = load double, ptr %203, align 8
  %205 = fmul double %77, %204
  %206 = load ptr, ptr %27, align 8
  %207 = load ptr, ptr %28, align 8
  %208 = getelementptr inbounds i64, ptr %207, i64 %201
  %209 = load i64, ptr %208, align 8
  %210 = getelementptr inbounds double, ptr %206, i64 %209
  %211 = load ptr, ptr %3, align 8
  %212 = getelementptr inbounds i8, ptr %211, i64 8
  %213 = load i64, ptr %212, align 8
  %214 = icmp sgt i64 %213, 0
  br i1 %214, label %215, label %227

215:                                              ; preds = %196, %215
  %216 = phi i64 [ %222, %215 ], [ 0, %196 ]
  %217 = getelementptr inbounds double, ptr %210, i64 %216
  %218 = load double, ptr %217, align 8
  %219 = getelementptr inbounds double, ptr %175, i64 %216
  %220 = load double, ptr %219, align 8
  %221 = tail call double @llvm.fma.f64(double %205, double %218, double %220)
  store double %221, ptr %219, align 8
  %222 = add nuw nsw i64 %216, 1
  %223 = load ptr, ptr %3, align 8
  %224 = getelementptr inbounds i8, ptr %223, i64 8
  %225 = load i64, ptr %224, align 8
  %226 = icmp slt i64 %222, %225
  br i1 %226, label %215, label %227, !llvm.loop !10

227:                                              ; preds = %215, %196, %171
  %228 = load ptr, ptr %27, align 8
  %229 = load i64, ptr %30, align 8
  %230 = mul nsw i64 %229, %174
  %231 = getelementptr inbounds double, ptr %228, i64 %230
  %232 = load i64, ptr %100, align 8
  %233 = add nsw i64 %232, 1
  store i64 %233, ptr %100, align 8
  %234 = load ptr, ptr %31, align 8
  %235 = getelementptr inbounds double, ptr %234, i64 %174
  %236 = load double, ptr %235, align 8
  %237 = fmul double %77, %236
  %238 = fadd double %98, %237
  %239 = load ptr, ptr %25, align 8
  %240 = load ptr, ptr %20, align 8
  store double %238, ptr %240, align 8
  %241 = load i64, ptr %21, align 8
  %242 = icmp sgt i64 %241, 0
  br i1 %242, label %243, label %244

243:                                              ; preds = %227
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %244

244:                                              ; preds = %227, %243
  %245 = load ptr, ptr %3, align 8
  %246 = load i64, ptr %245, align 8
  %247 = load ptr, ptr %20, align 8
  %248 = load ptr, ptr %22, align 8
  %249 = load ptr, ptr %23, align 8
  %250 = inttoptr i64 %246 to ptr
  %251 = tail call i32 %250(ptr noundef %247, ptr noundef %239, ptr noundef %248, ptr noundef %249, ptr noundef %231) #6
  %252 = sext i32 %251 to i64
  %253 = icmp eq i32 %251, 0
  %254 = select i1 %253, i64 %173, i64 %252
  br i1 %253, label %167, label %255

255:                                              ; preds = %167, %244, %160
  %256 = phi i1 [ %166, %160 ], [ %169, %167 ], [ %172, %244 ]
  %257 = phi i64 [ 0, %160 ], [ %252, %244 ], [ %252, %167 ]
  %258 = phi i64 [ undef, %160 ], [ %254, %244 ], [ %254, %167 ]
  br i1 %256, label %312, label %259

259:                                              ; preds = %255
  %260 = load ptr, ptr %32, align 8
  %261 = load ptr, ptr %4, align 8
  %262 = load ptr, ptr %3, align 8
  %263 = getelementptr inbounds i8, ptr %262, i64 16
  %264 = load i64, ptr %263, align 8
  %265 = icmp sgt i64 %264, 1
  %266 = zext i1 %265 to i64
  %267 = load ptr, ptr %33, align 8
  %268 = getelementptr inbounds i64, ptr %267, i64 %162
  %269 = load i64, ptr %268, align 8
  %270 = getelementptr i8, ptr %268, i64 8
  %271 = load i64, ptr %270, align 8
  %272 = xor i64 %269, -1
  %273 = add i64 %271, %272
  %274 = load ptr, ptr %24, align 8
  %275 = load ptr, ptr %34, align 8
  %276 = load ptr, ptr %35, align 8
  %277 = getelementptr inbounds i64, ptr %276, i64 %269
  %278 = load ptr, ptr %36, align 8
  %279 = getelementptr inbounds double, ptr %278, i64 %269
  tail call fastcc void @combine(ptr noundef %260, ptr noundef %261, ptr noundef %274, ptr noundef %275, ptr noundef %277, ptr noundef %279, i64 noundef %273, i64 noundef %266, i64 noundef %264) #5
  %280 = icmp eq i64 %264, 1
  br i1 %280, label %281, label %312

281:                                              ; preds = %259
  %282 = load ptr, ptr %33, align 8
  %283 = getelementptr i64, ptr %282, i64 %162
  %284 = getelementptr i8, ptr %283, i64 8
  %285 = load i64, ptr %284, align 8
  %286 = add nsw i64 %285, -1
  %287 = load ptr, ptr %36, align 8
  %288 = getelementptr inbounds double, ptr %287, i64 %286
  %289 = load double, ptr %288, align 8
  %290 = fmul double %77, %289
  %291 = load ptr, ptr %34, align 8
  %292 = load ptr, ptr %35, align 8
  %293 = getelementptr inbounds i64, ptr %292, i64 %286
  %294 = load i64, ptr %293, align 8
  %295 = getelementptr inbounds double, ptr %291, i64 %294
  %296 = load ptr, ptr %3, align 8
  %297 = getelementptr inbounds i8, ptr %296, i64 8
  %298 = load i64, ptr %297, align 8
  %299 = icmp sgt i64 %298, 0
  br i1 %299, label %300, label %312

300:                                              ; preds = %281, %300
  %301 = phi i64 [ %307, %300 ], [ 0, %281 ]
  %302 = getelementptr inbounds double, ptr %295, i64 %301
  %303 = load double, ptr %302, align 8
  %304 = getelementptr inbounds double, ptr %260, i64 %301
  %305 = load double, ptr %304, align 8
  %306 = tail call double @llvm.fma.f64(double %290, double %303, double %305)
  store double %306, ptr %304, align 8
  %307 = add nuw nsw i64 %301, 1
  %308 = load ptr, ptr %3, align 8
  %309 = getelementptr inbounds i8, ptr %308, i64 8
  %310 = load i64, ptr %309, align 8
  %311 = icmp slt i64 %307, %310
  br i1 %311, label %300, label %312, !llvm.loop !10

312:                                              ; preds = %300, %281, %255, %259, %150
  %313 = phi i64 [ %158, %150 ], [ %258, %255 ], [ %257, %259 ], [ %257, %281 ], [ %257, %300 ]
  %314 = icmp eq i64 %313, 0
  br i1 %314, label %315, label %488

315:                                              ; preds = %312
  %316 = getelementptr inbounds i8, ptr %91, i64 16
  %317 = icmp sgt i64 %94, 0
  br i1 %317, label %338, label %318

318:                                              ; preds = %338, %315
  %319 = load double, ptr %91, align 8
  %320 = load ptr, ptr %38, align 8
  %321 = load ptr, ptr %19, align 8
  %322 = mul nsw i64 %97, %95
  %323 = getelementptr inbounds double, ptr %321, i64 %322
  %324 = load ptr, ptr %20, align 8
  store double %319, ptr %324, align 8
  %325 = load i64, ptr %21, align 8
  %326 = icmp sgt i64 %325, 0
  br i1 %326, label %327, label %328

327:                                              ; preds = %318
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %328

328:                                              ; preds = %318, %327
  %329 = load ptr, ptr %3, align 8
  %330 = load i64, ptr %329, align 8
  %331 = load ptr, ptr %20, align 8
  %332 = load ptr, ptr %22, align 8
  %333 = load ptr, ptr %23, align 8
  %334 = inttoptr i64 %330 to ptr
  %335 = tail call i32 %334(ptr noundef %331, ptr noundef %320, ptr noundef %332, ptr noundef %333, ptr noundef %323) #6
  %336 = sext i32 %335 to i64
  %337 = icmp eq i32 %335, 0
  br i1 %337, label %346, label %488

338:                                              ; preds = %315, %338
  %339 = phi i64 [ %344, %338 ], [ 0, %315 ]
  %340 = getelementptr inbounds double, ptr %316, i64 %339
  %341 = load double, ptr %340, align 8
  %342 = load ptr, ptr %37, align 8
  %343 = getelementptr inbounds double, ptr %342, i64 %339
  store double %341, ptr %343, align 8
  %344 = add nuw nsw i64 %339, 1
  %345 = icmp eq i64 %344, %94
  br i1 %345, label %318, label %338, !llvm.loop !11

346:                                              ; preds = %328
  %347 = load ptr, ptr %0, align 8
  %348 = load ptr, ptr %3, align 8
  %349 = getelementptr inbounds i8, ptr %348, i64 16
  %350 = load i64, ptr %349, align 8
  %351 = load i64, ptr %347, align 8
  %352 = load i64, ptr %39, align 8
  %353 = load ptr, ptr %40, align 8
  %354 = mul nsw i64 %352, %351
  %355 = getelementptr inbounds double, ptr %353, i64 %354
  %356 = load ptr, ptr %41, align 8
  %357 = add nsw i64 %351, 1
  %358 = getelementptr inbounds i8, ptr %347, i64 16
  %359 = load i64, ptr %358, align 8
  %360 = icmp sgt i64 %359, 0
  br i1 %360, label %361, label %415

361:                                              ; preds = %346
  %362 = getelementptr inbounds i8, ptr %347, i64 8
  br label %368

363:                                              ; preds = %404
  %364 = add nsw i64 %371, 1
  %365 = load i64, ptr %358, align 8
  %366 = add nsw i64 %365, %357
  %367 = icmp slt i64 %364, %366
  br i1 %367, label %368, label %415, !llvm.loop !12

368:                                              ; preds = %361, %363
  %369 = phi i1 [ %360, %361 ], [ %367, %363 ]
  %370 = phi i64 [ undef, %361 ], [ %414, %363 ]
  %371 = phi i64 [ %357, %361 ], [ %364, %363 ]
  %372 = load i64, ptr %362, align 8
  %373 = load ptr, ptr %42, align 8
  %374 = load ptr, ptr %4, align 8
  %375 = load ptr, ptr %43, align 8
  %376 = getelementptr i64, ptr %375, i64 %371
  %377 = getelementptr i64, ptr %376, i64 %372
  %378 = load i64, ptr %377, align 8
  %379 = getelementptr i8, ptr %377, i64 8
  %380 = load i64, ptr %379, align 8
  %381 = xor i64 %378, -1
  %382 = add i64 %380, %381
  %383 = load ptr, ptr %44, align 8
  %384 = load ptr, ptr %40, align 8
  %385 = load ptr, ptr %45, align 8
  %386 = getelementptr inbounds i64, ptr %385, i64 %378
  %387 = load ptr, ptr %46, align 8
  %388 = getelementptr inbounds double, ptr %387, i64 %378
  tail call fastcc void @combine(ptr noundef %373, ptr noundef %374, ptr noundef %383, ptr noundef %384, ptr noundef %386, ptr noundef %388, i64 noundef %382, i64 noundef 1, i64 noundef %350) #5
  %389 = load ptr, ptr %40, align 8
  %390 = mul nsw i64 %371, %352
  %391 = getelementptr inbounds double, ptr %389, i64 %390
  %392 = load i64, ptr %100, align 8
  %393 = add nsw i64 %392, 1
  store i64 %393, ptr %100, align 8
  %394 = load ptr, ptr %47, align 8
  %395 = getelementptr inbounds double, ptr %394, i64 %371
  %396 = load double, ptr %395, align 8
  %397 = fmul double %77, %396
  %398 = fadd double %98, %397
  %399 = load ptr, ptr %42, align 8
  %400 = load ptr, ptr %20, align 8
  store double %398, ptr %400, align 8
  %401 = load i64, ptr %21, align 8
  %402 = icmp sgt i64 %401, 0
  br i1 %402, label %403, label %404

403:                                              ; preds = %368
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %404

404:                                              ; preds = %368, %403
  %405 = load ptr, ptr %3, align 8
  %406 = load i64, ptr %405, align 8
  %407 = load ptr, ptr %20, align 8
  %408 = load ptr, ptr %22, align 8
  %409 = load ptr, ptr %23, align 8
  %410 = inttoptr i64 %406 to ptr
  %411 = tail call i32 %410(ptr noundef %407, ptr noundef %399, ptr noundef %408, ptr noundef %409, ptr noundef %391) #6
  %412 = sext i32 %411 to i64
  %413 = icmp eq i32 %411, 0
  %414 = select i1 %413, i64 %370, i64 %412
  br i1 %413, label %363, label %415

415:                                              ; preds = %363, %404, %346
  %416 = phi i1 [ %360, %346 ], [ %367, %363 ], [ %369, %404 ]
  %417 = phi i64 [ 0, %346 ], [ %412, %404 ], [ %412, %363 ]
  %418 = phi i64 [ undef, %346 ], [ %414, %404 ], [ %414, %363 ]
  %419 = getelementptr inbounds i8, ptr %347, i64 16
  br i1 %416, label %488, label %420

420:                                              ; preds = %415
  %421 = load ptr, ptr %3, align 8
  %422 = getelementptr inbounds i8, ptr %421, i64 8
  %423 = load i64, ptr %422, align 8
  %424 = icmp sgt i64 %423, 0
  br i1 %424, label %425, label %429

425:                                              ; preds = %420
  %426 = getelementptr inbounds double, ptr %356, i64 %352
  %427 = shl nsw i64 %352, 4
  %428 = getelementptr inbounds i8, ptr %356, i64 %427
  br label %436

429:                                              ; preds = %436, %420
  %430 = getelementptr inbounds i8, ptr %347, i64 8
  %431 = load i64, ptr %430, align 8
  %432 = load i64, ptr %419, align 8
  %433 = getelementptr inbounds i8, ptr %347, i64 24
  %434 = load i64, ptr %433, align 8
  %435 = icmp sgt i64 %434, 3
  br i1 %435, label %463, label %488

436:                                              ; preds = %425, %436
  %437 = phi i64 [ 0, %425 ], [ %458, %436 ]
  %438 = load ptr, ptr %48, align 8
  %439 = getelementptr inbounds double, ptr %438, i64 %437
  %440 = load double, ptr %439, align 8
  %441 = load ptr, ptr %4, align 8
  %442 = getelementptr inbounds double, ptr %441, i64 %437
  %443 = load double, ptr %442, align 8
  %444 = fsub double %440, %443
  %445 = load ptr, ptr %40, align 8
  %446 = getelementptr inbounds double, ptr %445, i64 %437
  %447 = load double, ptr %446, align 8
  %448 = fmul double %77, %447
  %449 = fsub double %448, %444
  %450 = getelementptr inbounds double, ptr %356, i64 %437
  store double %444, ptr %450, align 8
  %451 = getelementptr inbounds double, ptr %426, i64 %437
  store double %449, ptr %451, align 8
  %452 = fsub double %444, %449
  %453 = getelementptr inbounds double, ptr %355, i64 %437
  %454 = load double, ptr %453, align 8
  %455 = fmul double %77, %454
  %456 = fsub double %452, %455
  %457 = getelementptr inbounds double, ptr %428, i64 %437
  store double %456, ptr %457, align 8
  %458 = add nuw nsw i64 %437, 1
  %459 = load ptr, ptr %3, align 8
  %460 = getelementptr inbounds i8, ptr %459, i64 8
  %461 = load i64, ptr %460, align 8
  %462 = icmp slt i64 %458, %461
  br i1 %462, label %436, label %429, !llvm.loop !13

463:                                              ; preds = %429, %463
  %464 = phi i64 [ %485, %463 ], [ 3, %429 ]
  %465 = mul nsw i64 %464, %352
  %466 = getelementptr inbounds double, ptr %356, i64 %465
  %467 = load ptr, ptr %49, align 8
  %468 = load ptr, ptr %50, align 8
  %469 = getelementptr i64, ptr %468, i64 %357
  %470 = getelementptr i64, ptr %469, i64 %431
  %471 = getelementptr i64, ptr %470, i64 %432
  %472 = getelementptr i64, ptr %471, i64 %464
  %473 = getelementptr i8, ptr %472, i64 -24
  %474 = load i64, ptr %473, align 8
  %475 = getelementptr i8, ptr %472, i64 -16
  %476 = load i64, ptr %475, align 8
  %477 = xor i64 %474, -1
  %478 = add i64 %476, %477
  %479 = load ptr, ptr %51, align 8
  %480 = load ptr, ptr %40, align 8
  %481 = load ptr, ptr %52, align 8
  %482 = getelementptr inbounds i64, ptr %481, i64 %474
  %483 = load ptr, ptr %53, align 8
  %484 = getelementptr inbounds double, ptr %483, i64 %474
  tail call fastcc void @combine(ptr noundef %466, ptr noundef %467, ptr noundef %479, ptr noundef %480, ptr noundef %482, ptr noundef %484, i64 noundef %478, i64 noundef 1, i64 noundef %350) #5
  %485 = add nuw nsw i64 %464, 1
  %486 = load i64, ptr %433, align 8
  %487 = icmp slt i64 %485, %486
  br i1 %487, label %463, label %488, !llvm.loop !14

488:                                              ; preds = %463, %128, %429, %105, %415, %312, %328
  %489 = phi i64 [ %313, %312 ], [ %336, %328 ], [ %418, %415 ], [ 0, %105 ], [ %417, %429 ], [ 0, %128 ], [ %417, %463 ]
  %490 = icmp eq i64 %489, 0
  %491 = select i1 %490, i64 %61, i64 %489
  br i1 %490, label %492, label %522

492:                                              ; preds = %488, %88
  %493 = phi i64 [ %66, %488 ], [ %62, %88 ]
  %494 = phi i64 [ %491, %488 ], [ %61, %88 ]
  %495 = load double, ptr %69, align 8
  %496 = fsub double %72, %495
  %497 = load double, ptr %76, align 8
  %498 = fdiv double %496, %497
  %499 = load ptr, ptr %55, align 8
  %500 = insertelement <8 x double> poison, double %498, i64 0
  %501 = shufflevector <8 x double> %500, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %501, ptr %499, align 8
  %502 = load ptr, ptr %4, align 8
  %503 = load ptr, ptr %56, align 8
  %504 = load i64, ptr %57, align 8
  %505 = load ptr, ptr %0, align 8
  %506 = getelementptr inbounds i8, ptr %505, i64 24
  %507 = load i64, ptr %506, align 8
  %508 = load ptr, ptr %55, align 8
  %509 = load ptr, ptr %3, align 8
  %510 = getelementptr inbounds i8, ptr %509, i64 16
  %511 = load i64, ptr %510, align 8
  tail call fastcc void @nested(ptr noundef %75, ptr noundef %502, ptr noundef %503, i64 noundef %504, i64 noundef %507, ptr noundef %508, i64 noundef %511) #5
  %512 = load ptr, ptr %58, align 8
  %513 = load i64, ptr %512, align 8
  %514 = icmp eq i64 %513, 1
  %515 = fcmp ogt double %498, 0.000000e+00
  %516 = and i1 %515, %514
  br i1 %516, label %517, label %522

517:                                              ; preds = %492
  %518 = getelementptr inbounds i8, ptr %512, i64 56
  %519 = load i64, ptr %518, align 8
  %520 = inttoptr i64 %519 to ptr
  %521 = tail call i64 %520(ptr noundef %0, double noundef %72, ptr noundef %75, ptr noundef null) #6
  br label %522

522:                                              ; preds = %81, %79, %492, %517, %488
  %523 = phi i32 [ 1, %488 ], [ 0, %517 ], [ 0, %492 ], [ 4, %79 ], [ 4, %81 ]
  %524 = phi i64 [ %66, %488 ], [ %493, %517 ], [ %493, %492 ], [ %62, %79 ], [ %62, %81 ]
  %525 = phi i64 [ %491, %488 ], [ %494, %517 ], [ %494, %492 ], [ %61, %79 ], [ %61, %81 ]
  switch i32 %523, label %530 [
    i32 0, label %526
    i32 4, label %526
  ]

526:                                              ; preds = %522, %522
  %527 = add nuw nsw i64 %63, 1
  %528 = load i64, ptr %10, align 8
  %529 = icmp slt i64 %527, %528
  br i1 %529, label %60, label %530, !llvm.loop !15

530:                                              ; preds = %522, %526, %2
  %531 = phi i64 [ 0, %2 ], [ %525, %522 ], [ 0, %526 ]
  ret i64 %531
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
