; sources 34b26abdd8c9a47a696e8486a45b879498e7c355927e471acc969c890c9ef4e7
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define range(i64 0, 9) i64 @act_on_event(ptr noundef readonly %0) #0 {
  %2 = getelementptr inbounds i8, ptr %0, i64 768
  %3 = getelementptr inbounds i8, ptr %0, i64 144
  %4 = getelementptr inbounds i8, ptr %0, i64 624
  %5 = getelementptr inbounds i8, ptr %0, i64 672
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 680
  %8 = load i64, ptr %7, align 8
  %9 = getelementptr double, ptr %6, i64 %8
  %10 = getelementptr i8, ptr %9, i64 -8
  %11 = load double, ptr %10, align 8
  %12 = load double, ptr %6, align 8
  %13 = fsub double %11, %12
  %14 = load ptr, ptr %2, align 8
  %15 = getelementptr inbounds i8, ptr %14, i64 8
  %16 = load i64, ptr %15, align 8
  %17 = load ptr, ptr %3, align 8
  %18 = getelementptr inbounds i8, ptr %17, i64 8
  %19 = load i64, ptr %18, align 8
  %20 = getelementptr inbounds i8, ptr %17, i64 24
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %0, i64 648
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %23, i64 80
  %25 = load i64, ptr %24, align 8
  %26 = getelementptr inbounds i8, ptr %0, i64 360
  %27 = load ptr, ptr %26, align 8
  %28 = load ptr, ptr %4, align 8
  %29 = getelementptr inbounds i8, ptr %0, i64 1224
  %30 = load ptr, ptr %29, align 8
  %31 = load double, ptr %28, align 8
  %32 = getelementptr inbounds i8, ptr %0, i64 984
  %33 = load ptr, ptr %32, align 8
  %34 = getelementptr inbounds double, ptr %33, i64 %16
  %35 = getelementptr inbounds i8, ptr %0, i64 1200
  %36 = load ptr, ptr %35, align 8
  %37 = getelementptr inbounds double, ptr %36, i64 %16
  %38 = icmp sgt i64 %16, 0
  br i1 %38, label %39, label %54

39:                                               ; preds = %1
  %40 = getelementptr inbounds i8, ptr %0, i64 960
  %41 = load ptr, ptr %40, align 8
  br label %42

42:                                               ; preds = %39, %50
  %43 = phi i64 [ -1, %39 ], [ %51, %50 ]
  %44 = phi i64 [ 0, %39 ], [ %52, %50 ]
  %45 = getelementptr inbounds i64, ptr %41, i64 %44
  %46 = load i64, ptr %45, align 8
  %47 = icmp sgt i64 %46, 0
  br i1 %47, label %48, label %50

48:                                               ; preds = %42
  %49 = icmp sgt i64 %43, -1
  br i1 %49, label %372, label %50

50:                                               ; preds = %48, %42
  %51 = phi i64 [ %43, %42 ], [ %44, %48 ]
  %52 = add nuw nsw i64 %44, 1
  %53 = icmp eq i64 %52, %16
  br i1 %53, label %54, label %42, !llvm.loop !3

54:                                               ; preds = %50, %1
  %55 = phi i64 [ -1, %1 ], [ %51, %50 ]
  %56 = icmp slt i64 %55, 0
  br i1 %56, label %372, label %57

57:                                               ; preds = %54
  %58 = getelementptr inbounds i8, ptr %0, i64 864
  %59 = load ptr, ptr %58, align 8
  %60 = getelementptr inbounds i64, ptr %59, i64 %55
  %61 = load i64, ptr %60, align 8
  %62 = and i64 %61, 4
  %63 = icmp eq i64 %62, 0
  br i1 %63, label %372, label %64

64:                                               ; preds = %57
  %65 = add nsw i64 %25, 1
  %66 = add nsw i64 %65, %16
  %67 = getelementptr inbounds i8, ptr %0, i64 1056
  %68 = getelementptr inbounds i8, ptr %0, i64 1064
  %69 = load i64, ptr %68, align 8
  %70 = icmp sgt i64 %66, %69
  br i1 %70, label %372, label %71

71:                                               ; preds = %64
  %72 = mul nsw i64 %55, %21
  %73 = getelementptr inbounds double, ptr %30, i64 %72
  %74 = getelementptr inbounds i8, ptr %0, i64 168
  %75 = load ptr, ptr %74, align 8
  store double %31, ptr %75, align 8
  %76 = load ptr, ptr %3, align 8
  %77 = getelementptr inbounds i8, ptr %76, i64 40
  %78 = load i64, ptr %77, align 8
  %79 = icmp eq i64 %78, 0
  br i1 %79, label %81, label %80

80:                                               ; preds = %71
  tail call fastcc void @settle(ptr noundef nonnull %3) #3
  br label %81

81:                                               ; preds = %80, %71
  %82 = getelementptr inbounds i8, ptr %0, i64 248
  %83 = load i64, ptr %82, align 8
  %84 = icmp sgt i64 %83, 0
  br i1 %84, label %85, label %86

85:                                               ; preds = %81
  tail call fastcc void @sample(ptr noundef nonnull %3) #3
  br label %86

86:                                               ; preds = %81, %85
  %87 = load ptr, ptr %2, align 8
  %88 = getelementptr inbounds i8, ptr %87, i64 64
  %89 = load i64, ptr %88, align 8
  %90 = getelementptr inbounds i8, ptr %0, i64 168
  %91 = load ptr, ptr %90, align 8
  %92 = getelementptr inbounds i8, ptr %0, i64 192
  %93 = load ptr, ptr %92, align 8
  %94 = getelementptr inbounds i8, ptr %0, i64 1176
  %95 = load ptr, ptr %94, align 8
  %96 = inttoptr i64 %89 to ptr
  %97 = load ptr, ptr %96, align 8
  %98 = tail call i32 %97(ptr noundef %91, ptr noundef %27, ptr noundef %93, ptr noundef %95, ptr noundef %30) #4
  %99 = icmp eq i32 %98, 0
  br i1 %99, label %100, label %372

100:                                              ; preds = %86
  %101 = load ptr, ptr %2, align 8
  %102 = load i64, ptr %101, align 8
  %103 = load ptr, ptr %90, align 8
  %104 = load ptr, ptr %92, align 8
  %105 = getelementptr inbounds i8, ptr %0, i64 792
  %106 = load ptr, ptr %105, align 8
  %107 = inttoptr i64 %102 to ptr
  %108 = load ptr, ptr %107, align 8
  %109 = tail call i32 %108(ptr noundef %103, ptr noundef %27, ptr noundef %104, ptr noundef %106, ptr noundef %33) #4
  %110 = icmp eq i32 %109, 0
  br i1 %110, label %111, label %372

111:                                              ; preds = %100
  %112 = load ptr, ptr %2, align 8
  %113 = load i64, ptr %112, align 8
  %114 = load ptr, ptr %90, align 8
  %115 = load ptr, ptr %92, align 8
  %116 = load ptr, ptr %105, align 8
  %117 = inttoptr i64 %113 to ptr
  %118 = load ptr, ptr %117, align 8
  %119 = tail call i32 %118(ptr noundef %114, ptr noundef %73, ptr noundef %115, ptr noundef %116, ptr noundef %34) #4
  %120 = icmp eq i32 %119, 0
  br i1 %120, label %121, label %372

121:                                              ; preds = %111
  %122 = load ptr, ptr %2, align 8
  %123 = getelementptr inbounds i8, ptr %122, i64 56
  %124 = load i64, ptr %123, align 8
  %125 = load ptr, ptr %90, align 8
  %126 = load ptr, ptr %92, align 8
  %127 = getelementptr inbounds i8, ptr %0, i64 1152
  %128 = load ptr, ptr %127, align 8
  %129 = load ptr, ptr %35, align 8
  %130 = inttoptr i64 %124 to ptr
  %131 = load ptr, ptr %130, align 8
  %132 = tail call i32 %131(ptr noundef %125, ptr noundef %73, ptr noundef %126, ptr noundef %128, ptr noundef %129) #4
  %133 = icmp eq i32 %132, 0
  br i1 %133, label %134, label %372

134:                                              ; preds = %121
  %135 = icmp sgt i64 %21, 0
  br i1 %135, label %145, label %139

136:                                              ; preds = %145
  %137 = add nuw nsw i64 %146, 1
  %138 = icmp eq i64 %137, %21
  br i1 %138, label %139, label %145, !llvm.loop !6

139:                                              ; preds = %136, %134
  %140 = icmp sgt i64 %16, 0
  br i1 %140, label %141, label %200

141:                                              ; preds = %139
  %142 = getelementptr inbounds i8, ptr %0, i64 936
  %143 = getelementptr inbounds i8, ptr %0, i64 840
  %144 = getelementptr inbounds i8, ptr %0, i64 816
  br label %151

145:                                              ; preds = %134, %136
  %146 = phi i64 [ %137, %136 ], [ 0, %134 ]
  %147 = getelementptr inbounds double, ptr %73, i64 %146
  %148 = load double, ptr %147, align 8
  %149 = tail call double @llvm.fabs.f64(double %148)
  %150 = fcmp ueq double %149, 0x7FF0000000000000
  br i1 %150, label %372, label %136

151:                                              ; preds = %141, %197
  %152 = phi i64 [ 0, %141 ], [ %198, %197 ]
  %153 = icmp eq i64 %152, %55
  br i1 %153, label %197, label %154

154:                                              ; preds = %151
  %155 = load ptr, ptr %142, align 8
  %156 = getelementptr inbounds i64, ptr %155, i64 %152
  %157 = load i64, ptr %156, align 8
  %158 = icmp eq i64 %157, 0
  br i1 %158, label %163, label %159

159:                                              ; preds = %154
  %160 = getelementptr inbounds double, ptr %34, i64 %152
  %161 = load double, ptr %160, align 8
  %162 = fcmp uno double %161, 0.000000e+00
  br i1 %162, label %372, label %163

163:                                              ; preds = %159, %154
  %164 = load ptr, ptr %143, align 8
  %165 = getelementptr inbounds i64, ptr %164, i64 %152
  %166 = load i64, ptr %165, align 8
  %167 = icmp eq i64 %166, 1
  br i1 %167, label %168, label %197

168:                                              ; preds = %163
  %169 = getelementptr inbounds double, ptr %34, i64 %152
  %170 = load double, ptr %169, align 8
  %171 = getelementptr inbounds double, ptr %33, i64 %152
  %172 = load double, ptr %171, align 8
  %173 = fcmp oeq double %170, %172
  br i1 %173, label %174, label %197

174:                                              ; preds = %168
  %175 = getelementptr inbounds double, ptr %36, i64 %152
  %176 = load double, ptr %175, align 8
  %177 = load ptr, ptr %144, align 8
  %178 = getelementptr inbounds i64, ptr %177, i64 %152
  %179 = load i64, ptr %178, align 8
  %180 = sitofp i64 %179 to double
  %181 = fmul double %176, %180
  %182 = fcmp oge double %181, 0.000000e+00
  %183 = fcmp une double %176, 0.000000e+00
  %184 = and i1 %183, %182
  br i1 %184, label %185, label %197

185:                                              ; preds = %174
  %186 = fcmp oeq double %170, 0.000000e+00
  br i1 %186, label %194, label %187

187:                                              ; preds = %185
  %188 = getelementptr inbounds double, ptr %37, i64 %152
  %189 = load double, ptr %188, align 8
  %190 = tail call double @llvm.fabs.f64(double %170)
  %191 = fmul double %189, 0x3CE0000000000000
  %192 = fcmp ole double %190, %191
  %193 = zext i1 %192 to i32
  br label %194

194:                                              ; preds = %185, %187
  %195 = phi i32 [ 1, %185 ], [ %193, %187 ]
  %196 = icmp eq i32 %195, 0
  br i1 %196, label %197, label %372

197:                                              ; preds = %163, %168, %174, %194, %151
  %198 = add nuw nsw i64 %152, 1
  %199 = icmp eq i64 %198, %16
  br i1 %199, label %200, label %151, !llvm.loop !7

200:                                              ; preds = %197, %139
  %201 = getelementptr inbounds double, ptr %34, i64 %55
  %202 = load double, ptr %201, align 8
  %203 = getelementptr inbounds double, ptr %33, i64 %55
  %204 = load double, ptr %203, align 8
  %205 = fcmp oeq double %202, %204
  %206 = fcmp oeq double %202, 0.000000e+00
  %207 = or i1 %206, %205
  br i1 %207, label %214, label %208

208:                                              ; preds = %200
  %209 = getelementptr inbounds double, ptr %37, i64 %55
  %210 = load double, ptr %209, align 8
  %211 = tail call double @llvm.fabs.f64(double %202)
  %212 = fmul double %210, 0x3CE0000000000000
  %213 = fcmp ugt double %211, %212
  br label %214

214:                                              ; preds = %208, %200
  %215 = phi i1 [ false, %200 ], [ %213, %208 ]
  br i1 %215, label %238, label %216

216:                                              ; preds = %214
  %217 = getelementptr inbounds i8, ptr %0, i64 816
  %218 = load ptr, ptr %217, align 8
  %219 = getelementptr inbounds i64, ptr %218, i64 %55
  %220 = load i64, ptr %219, align 8
  %221 = icmp eq i64 %220, 0
  br i1 %221, label %238, label %222

222:                                              ; preds = %216
  %223 = load ptr, ptr %58, align 8
  %224 = getelementptr inbounds i64, ptr %223, i64 %55
  %225 = load i64, ptr %224, align 8
  %226 = and i64 %225, 16
  %227 = icmp eq i64 %226, 0
  br i1 %227, label %238, label %228

228:                                              ; preds = %222
  %229 = getelementptr inbounds double, ptr %36, i64 %55
  %230 = load double, ptr %229, align 8
  %231 = getelementptr inbounds i8, ptr %0, i64 936
  %232 = load ptr, ptr %231, align 8
  %233 = getelementptr inbounds i64, ptr %232, i64 %55
  %234 = load i64, ptr %233, align 8
  %235 = sitofp i64 %234 to double
  %236 = fmul double %230, %235
  %237 = fcmp ogt double %236, 0.000000e+00
  br i1 %237, label %238, label %372

238:                                              ; preds = %228, %222, %216, %214
  %239 = getelementptr inbounds i8, ptr %0, i64 1248
  %240 = load ptr, ptr %239, align 8
  %241 = mul nuw nsw i64 %55, 100
  %242 = getelementptr inbounds double, ptr %240, i64 %241
  %243 = load double, ptr %242, align 8
  %244 = fsub double %31, %243
  %245 = getelementptr inbounds double, ptr %37, i64 %55
  %246 = load double, ptr %245, align 8
  %247 = fmul double %246, 0x3D40000000000000
  br i1 %215, label %260, label %248

248:                                              ; preds = %238
  %249 = load ptr, ptr %58, align 8
  %250 = getelementptr inbounds i64, ptr %249, i64 %55
  %251 = load i64, ptr %250, align 8
  %252 = and i64 %251, 16
  %253 = icmp eq i64 %252, 0
  br i1 %253, label %260, label %254

254:                                              ; preds = %248
  %255 = getelementptr inbounds double, ptr %36, i64 %55
  %256 = load double, ptr %255, align 8
  %257 = tail call double @llvm.fabs.f64(double %256)
  %258 = fmul double %244, %257
  %259 = fcmp ugt double %258, %247
  br i1 %259, label %260, label %372

260:                                              ; preds = %254, %248, %238
  %261 = icmp sgt i64 %16, 0
  br i1 %261, label %262, label %265

262:                                              ; preds = %260
  %263 = getelementptr inbounds i8, ptr %0, i64 960
  %264 = getelementptr inbounds i8, ptr %0, i64 936
  br label %276

265:                                              ; preds = %305, %260
  %266 = load ptr, ptr %67, align 8
  %267 = getelementptr inbounds double, ptr %266, i64 %25
  store double %31, ptr %267, align 8
  %268 = getelementptr inbounds i8, ptr %0, i64 1080
  %269 = load ptr, ptr %268, align 8
  %270 = getelementptr inbounds i64, ptr %269, i64 %25
  store i64 %55, ptr %270, align 8
  %271 = icmp sgt i64 %21, 0
  br i1 %271, label %272, label %319

272:                                              ; preds = %265
  %273 = getelementptr inbounds i8, ptr %0, i64 1104
  %274 = mul nsw i64 %25, %19
  %275 = getelementptr inbounds i8, ptr %0, i64 1128
  br label %326

276:                                              ; preds = %262, %305
  %277 = phi i64 [ 0, %262 ], [ %317, %305 ]
  %278 = getelementptr inbounds double, ptr %34, i64 %277
  %279 = load double, ptr %278, align 8
  %280 = getelementptr inbounds double, ptr %33, i64 %277
  %281 = load double, ptr %280, align 8
  %282 = fcmp oeq double %279, %281
  %283 = fcmp oeq double %279, 0.000000e+00
  %284 = or i1 %283, %282
  br i1 %284, label %291, label %285

285:                                              ; preds = %276
  %286 = getelementptr inbounds double, ptr %37, i64 %277
  %287 = load double, ptr %286, align 8
  %288 = tail call double @llvm.fabs.f64(double %279)
  %289 = fmul double %287, 0x3CE0000000000000
  %290 = fcmp ole double %288, %289
  br label %291

291:                                              ; preds = %285, %276
  %292 = phi i1 [ true, %276 ], [ %290, %285 ]
  %293 = fcmp une double %279, 0.000000e+00
  %294 = icmp ne i64 %277, %55
  %295 = or i1 %215, %294
  %296 = and i1 %293, %295
  br i1 %296, label %297, label %303

297:                                              ; preds = %291
  %298 = load ptr, ptr %263, align 8
  %299 = getelementptr inbounds i64, ptr %298, i64 %277
  %300 = load i64, ptr %299, align 8
  %301 = icmp slt i64 %300, 0
  %302 = select i1 %301, i1 %292, i1 false
  br i1 %302, label %303, label %305

303:                                              ; preds = %291, %297
  %304 = getelementptr inbounds double, ptr %36, i64 %277
  br label %305

305:                                              ; preds = %297, %303
  %306 = phi ptr [ %304, %303 ], [ %278, %297 ]
  %307 = load double, ptr %306, align 8
  %308 = tail call double @llvm.fabs.f64(double %307)
  %309 = fcmp ueq double %308, 0x7FF0000000000000
  %310 = fcmp ogt double %307, 0.000000e+00
  %311 = fcmp olt double %307, 0.000000e+00
  %312 = sext i1 %311 to i64
  %313 = select i1 %310, i64 1, i64 %312
  %314 = select i1 %309, i64 0, i64 %313
  %315 = load ptr, ptr %264, align 8
  %316 = getelementptr inbounds i64, ptr %315, i64 %277
  store i64 %314, ptr %316, align 8
  %317 = add nuw nsw i64 %277, 1
  %318 = icmp eq i64 %317, %16
  br i1 %318, label %265, label %276, !llvm.loop !8

319:                                              ; preds = %326, %265
  %320 = load ptr, ptr %22, align 8
  %321 = getelementptr inbounds i8, ptr %320, i64 80
  store i64 %65, ptr %321, align 8
  %322 = load ptr, ptr %0, align 8
  %323 = getelementptr inbounds i8, ptr %322, i64 8
  %324 = load i64, ptr %323, align 8
  %325 = icmp eq i64 %324, 0
  br i1 %325, label %339, label %345

326:                                              ; preds = %272, %326
  %327 = phi i64 [ 0, %272 ], [ %337, %326 ]
  %328 = getelementptr inbounds double, ptr %27, i64 %327
  %329 = load double, ptr %328, align 8
  %330 = load ptr, ptr %273, align 8
  %331 = add nsw i64 %327, %274
  %332 = getelementptr inbounds double, ptr %330, i64 %331
  store double %329, ptr %332, align 8
  %333 = getelementptr inbounds double, ptr %73, i64 %327
  %334 = load double, ptr %333, align 8
  store double %334, ptr %328, align 8
  %335 = load ptr, ptr %275, align 8
  %336 = getelementptr inbounds double, ptr %335, i64 %331
  store double %334, ptr %336, align 8
  %337 = add nuw nsw i64 %327, 1
  %338 = icmp eq i64 %337, %21
  br i1 %338, label %319, label %326, !llvm.loop !9

339:                                              ; preds = %319
  %340 = getelementptr inbounds i8, ptr %0, i64 1272
  %341 = load ptr, ptr %340, align 8
  %342 = getelementptr inbounds i8, ptr %341, i64 8
  %343 = load double, ptr %342, align 8
  %344 = getelementptr inbounds i8, ptr %28, i64 8
  store double %343, ptr %344, align 8
  br label %345

345:                                              ; preds = %339, %319
  %346 = load ptr, ptr %239, align 8
  %347 = getelementptr inbounds double, ptr %346, i64 %241
  %348 = load double, ptr %347, align 8
  %349 = fsub double %31, %348
  %350 = tail call double @llvm.fabs.f64(double %31)
  %351 = fcmp ogt double %350, %13
  %352 = select i1 %351, double %350, double %13
  %353 = fmul double %352, 0x3CF0000000000000
  %354 = fcmp ugt double %349, %353
  br i1 %354, label %355, label %362

355:                                              ; preds = %345
  %356 = getelementptr inbounds i8, ptr %347, i64 784
  %357 = load double, ptr %356, align 8
  %358 = fsub double %31, %357
  %359 = fmul double %13, 1.000000e-09
  %360 = fcmp olt double %358, %359
  %361 = select i1 %360, i64 8, i64 1
  br label %362

362:                                              ; preds = %355, %345
  %363 = phi i64 [ 8, %345 ], [ %361, %355 ]
  br label %365

364:                                              ; preds = %365
  store double %31, ptr %347, align 8
  br label %372

365:                                              ; preds = %362, %365
  %366 = phi i64 [ 99, %362 ], [ %370, %365 ]
  %367 = getelementptr double, ptr %347, i64 %366
  %368 = getelementptr i8, ptr %367, i64 -8
  %369 = load double, ptr %368, align 8
  store double %369, ptr %367, align 8
  %370 = add nsw i64 %366, -1
  %371 = icmp ugt i64 %366, 1
  br i1 %371, label %365, label %364, !llvm.loop !10

372:                                              ; preds = %48, %145, %159, %194, %121, %111, %100, %86, %364, %254, %228, %54, %57, %64
  %373 = phi i64 [ 0, %64 ], [ 0, %57 ], [ 0, %54 ], [ 0, %121 ], [ 0, %111 ], [ 0, %100 ], [ 0, %86 ], [ 0, %228 ], [ %363, %364 ], [ 0, %254 ], [ 0, %194 ], [ 0, %159 ], [ 0, %145 ], [ 0, %48 ]
  ret i64 %373
}

declare double @llvm.fabs.f64(double) #1

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
  br i1 %28, label %16, label %29, !llvm.loop !11

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
  br i1 %60, label %49, label %61, !llvm.loop !12

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
  br i1 %88, label %14, label %13, !llvm.loop !13
}

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn memory(none) }
attributes #2 = { noinline nounwind }
attributes #3 = { nounwind }
attributes #4 = { nounwind }


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
