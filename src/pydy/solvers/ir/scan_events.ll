; sources 861d6529beb85fcfbedb51ed0cadf6fe1373e52e1c74d20526935c7ced516c53
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

define i64 @scan_events(ptr noundef %0, double noundef %1, double noundef %2) #0 {
  %4 = alloca %struct.Stepper, align 8
  store ptr %0, ptr %4, align 8
  %5 = getelementptr inbounds i8, ptr %4, i64 8
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %6, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %4, i64 16
  %8 = getelementptr inbounds i8, ptr %0, i64 312
  store ptr %8, ptr %7, align 8
  %9 = getelementptr inbounds i8, ptr %0, i64 720
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 768
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 864
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %0, i64 816
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 840
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds i8, ptr %0, i64 576
  %22 = getelementptr inbounds i8, ptr %0, i64 600
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %23, i64 80
  %25 = load i64, ptr %24, align 8
  %26 = load ptr, ptr %21, align 8
  %27 = getelementptr inbounds i8, ptr %0, i64 888
  %28 = getelementptr inbounds i8, ptr %0, i64 408
  %29 = getelementptr inbounds i8, ptr %0, i64 504
  %30 = getelementptr inbounds i8, ptr %0, i64 320
  %31 = getelementptr inbounds i8, ptr %0, i64 168
  %32 = getelementptr inbounds i8, ptr %0, i64 248
  %33 = getelementptr inbounds i8, ptr %0, i64 168
  %34 = getelementptr inbounds i8, ptr %0, i64 192
  %35 = getelementptr inbounds i8, ptr %0, i64 744
  %36 = icmp sgt i64 %12, 0
  %37 = icmp sgt i64 %12, 0
  %38 = getelementptr double, ptr %16, i64 %12
  %39 = icmp sgt i64 %12, 0
  %40 = getelementptr double, ptr %16, i64 %12
  %41 = getelementptr inbounds i8, ptr %0, i64 792
  %42 = getelementptr inbounds i8, ptr %26, i64 48
  %43 = icmp sgt i64 %12, 0
  %44 = getelementptr inbounds i8, ptr %0, i64 912
  %45 = getelementptr inbounds i8, ptr %0, i64 920
  %46 = getelementptr inbounds i8, ptr %0, i64 936
  %47 = getelementptr inbounds i8, ptr %0, i64 960
  %48 = getelementptr inbounds i8, ptr %0, i64 976
  %49 = getelementptr inbounds i8, ptr %26, i64 48
  %50 = icmp sgt i64 %12, 0
  %51 = getelementptr inbounds i8, ptr %26, i64 48
  %52 = icmp sgt i64 %12, 0
  br label %57

53:                                               ; preds = %471
  %54 = add nuw nsw i32 %61, 1
  %55 = icmp ugt i32 %61, 3
  %56 = icmp eq i32 %54, 5
  br i1 %56, label %476, label %57, !llvm.loop !3

57:                                               ; preds = %3, %53
  %58 = phi i1 [ false, %3 ], [ %55, %53 ]
  %59 = phi i64 [ undef, %3 ], [ %474, %53 ]
  %60 = phi double [ 0.000000e+00, %3 ], [ %473, %53 ]
  %61 = phi i32 [ 1, %3 ], [ %54, %53 ]
  %62 = uitofp nneg i32 %61 to double
  %63 = fmul double %62, 2.500000e-01
  %64 = load ptr, ptr %27, align 8
  %65 = load ptr, ptr %28, align 8
  %66 = insertelement <8 x double> poison, double %63, i64 0
  %67 = shufflevector <8 x double> %66, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %67, ptr %65, align 8
  %68 = load ptr, ptr %8, align 8
  %69 = load ptr, ptr %29, align 8
  %70 = load i64, ptr %30, align 8
  %71 = load ptr, ptr %0, align 8
  %72 = getelementptr inbounds i8, ptr %71, i64 24
  %73 = load i64, ptr %72, align 8
  %74 = load ptr, ptr %28, align 8
  %75 = load ptr, ptr %6, align 8
  %76 = getelementptr inbounds i8, ptr %75, i64 16
  %77 = load i64, ptr %76, align 8
  tail call fastcc void @nested(ptr noundef %64, ptr noundef %68, ptr noundef %69, i64 noundef %70, i64 noundef %73, ptr noundef %74, i64 noundef %77) #7
  %78 = fmul double %63, %2
  %79 = fadd double %78, %1
  %80 = load ptr, ptr %31, align 8
  store double %79, ptr %80, align 8
  %81 = load i64, ptr %32, align 8
  %82 = icmp sgt i64 %81, 0
  br i1 %82, label %83, label %84

83:                                               ; preds = %57
  tail call fastcc void @sample(ptr noundef nonnull %6) #7
  br label %84

84:                                               ; preds = %57, %83
  %85 = load ptr, ptr %9, align 8
  %86 = load i64, ptr %85, align 8
  %87 = load ptr, ptr %33, align 8
  %88 = load ptr, ptr %27, align 8
  %89 = load ptr, ptr %34, align 8
  %90 = load ptr, ptr %35, align 8
  %91 = load ptr, ptr %15, align 8
  %92 = inttoptr i64 %86 to ptr
  %93 = tail call i32 %92(ptr noundef %87, ptr noundef %88, ptr noundef %89, ptr noundef %90, ptr noundef %91) #8
  %94 = icmp slt i32 %93, 0
  br i1 %94, label %95, label %100

95:                                               ; preds = %84
  %96 = load ptr, ptr %22, align 8
  %97 = getelementptr inbounds i8, ptr %96, i64 80
  store i64 %25, ptr %97, align 8
  %98 = load ptr, ptr %21, align 8
  %99 = getelementptr inbounds i8, ptr %98, i64 48
  store double 1.000000e+00, ptr %99, align 8
  br label %471

100:                                              ; preds = %84, %453
  %101 = phi double [ %455, %453 ], [ %60, %84 ]
  %102 = phi i64 [ %456, %453 ], [ %59, %84 ]
  br i1 %36, label %106, label %103

103:                                              ; preds = %141, %100
  %104 = phi double [ 2.000000e+00, %100 ], [ %142, %141 ]
  %105 = fcmp ogt double %104, 1.000000e+00
  br i1 %105, label %453, label %145

106:                                              ; preds = %100, %141
  %107 = phi i64 [ %143, %141 ], [ 0, %100 ]
  %108 = phi double [ %142, %141 ], [ 2.000000e+00, %100 ]
  %109 = getelementptr inbounds i64, ptr %20, i64 %107
  store i64 0, ptr %109, align 8
  %110 = getelementptr inbounds i64, ptr %18, i64 %107
  %111 = load i64, ptr %110, align 8
  %112 = getelementptr inbounds double, ptr %16, i64 %107
  %113 = load double, ptr %112, align 8
  %114 = getelementptr inbounds i64, ptr %14, i64 %107
  %115 = load i64, ptr %114, align 8
  %116 = icmp slt i64 %111, 0
  %117 = fcmp ogt double %113, 0.000000e+00
  %118 = and i1 %116, %117
  %119 = icmp sgt i64 %115, -1
  %120 = and i1 %118, %119
  br i1 %120, label %128, label %121

121:                                              ; preds = %106
  %122 = icmp sgt i64 %111, 0
  %123 = fcmp olt double %113, 0.000000e+00
  %124 = and i1 %122, %123
  br i1 %124, label %125, label %128

125:                                              ; preds = %121
  %126 = icmp slt i64 %115, 1
  %127 = zext i1 %126 to i32
  br label %128

128:                                              ; preds = %106, %121, %125
  %129 = phi i32 [ 1, %106 ], [ 0, %121 ], [ %127, %125 ]
  %130 = icmp eq i32 %129, 0
  br i1 %130, label %131, label %135

131:                                              ; preds = %128
  %132 = icmp eq i64 %111, 0
  %133 = fcmp ord double %113, 0.000000e+00
  %134 = or i1 %132, %133
  br i1 %134, label %141, label %135

135:                                              ; preds = %131, %128
  %136 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %101, double noundef %63, i64 noundef %107) #7
  %137 = fcmp ole double %136, %101
  %138 = zext i1 %137 to i64
  store i64 %138, ptr %109, align 8
  %139 = fcmp olt double %136, %108
  %140 = select i1 %139, double %136, double %108
  br label %141

141:                                              ; preds = %131, %135
  %142 = phi double [ %140, %135 ], [ %108, %131 ]
  %143 = add nuw nsw i64 %107, 1
  %144 = icmp eq i64 %143, %12
  br i1 %144, label %103, label %106, !llvm.loop !6

145:                                              ; preds = %103
  %146 = load ptr, ptr %27, align 8
  %147 = load ptr, ptr %28, align 8
  %148 = insertelement <8 x double> poison, double %104, i64 0
  %149 = shufflevector <8 x double> %148, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %149, ptr %147, align 8
  %150 = load ptr, ptr %8, align 8
  %151 = load ptr, ptr %29, align 8
  %152 = load i64, ptr %30, align 8
  %153 = load ptr, ptr %0, align 8
  %154 = getelementptr inbounds i8, ptr %153, i64 24
  %155 = load i64, ptr %154, align 8
  %156 = load ptr, ptr %28, align 8
  %157 = load ptr, ptr %6, align 8
  %158 = getelementptr inbounds i8, ptr %157, i64 16
  %159 = load i64, ptr %158, align 8
  tail call fastcc void @nested(ptr noundef %146, ptr noundef %150, ptr noundef %151, i64 noundef %152, i64 noundef %155, ptr noundef %156, i64 noundef %159) #7
  %160 = fmul double %104, %2
  %161 = fadd double %160, %1
  %162 = load ptr, ptr %31, align 8
  store double %161, ptr %162, align 8
  %163 = load i64, ptr %32, align 8
  %164 = icmp sgt i64 %163, 0
  br i1 %164, label %165, label %166

165:                                              ; preds = %145
  tail call fastcc void @sample(ptr noundef nonnull %6) #7
  br label %166

166:                                              ; preds = %145, %165
  %167 = load ptr, ptr %9, align 8
  %168 = load i64, ptr %167, align 8
  %169 = load ptr, ptr %33, align 8
  %170 = load ptr, ptr %27, align 8
  %171 = load ptr, ptr %34, align 8
  %172 = load ptr, ptr %35, align 8
  %173 = load ptr, ptr %15, align 8
  %174 = getelementptr inbounds i8, ptr %167, i64 8
  %175 = load i64, ptr %174, align 8
  %176 = getelementptr inbounds double, ptr %173, i64 %175
  %177 = inttoptr i64 %168 to ptr
  %178 = tail call i32 %177(ptr noundef %169, ptr noundef %170, ptr noundef %171, ptr noundef %172, ptr noundef %176) #8
  %179 = icmp slt i32 %178, 0
  br i1 %179, label %181, label %180

180:                                              ; preds = %166
  br i1 %37, label %186, label %282

181:                                              ; preds = %166
  %182 = load ptr, ptr %22, align 8
  %183 = getelementptr inbounds i8, ptr %182, i64 80
  store i64 %25, ptr %183, align 8
  %184 = load ptr, ptr %21, align 8
  %185 = getelementptr inbounds i8, ptr %184, i64 48
  store double 1.000000e+00, ptr %185, align 8
  br label %453

186:                                              ; preds = %180, %276
  %187 = phi i1 [ %280, %276 ], [ %37, %180 ]
  %188 = phi i64 [ %278, %276 ], [ %102, %180 ]
  %189 = phi i64 [ %279, %276 ], [ 0, %180 ]
  %190 = phi double [ %277, %276 ], [ %104, %180 ]
  %191 = getelementptr inbounds i64, ptr %18, i64 %189
  %192 = load i64, ptr %191, align 8
  %193 = getelementptr double, ptr %38, i64 %189
  %194 = load double, ptr %193, align 8
  %195 = getelementptr inbounds i64, ptr %14, i64 %189
  %196 = load i64, ptr %195, align 8
  %197 = icmp slt i64 %192, 0
  %198 = fcmp ogt double %194, 0.000000e+00
  %199 = and i1 %197, %198
  %200 = icmp sgt i64 %196, -1
  %201 = and i1 %199, %200
  br i1 %201, label %209, label %202

202:                                              ; preds = %186
  %203 = icmp sgt i64 %192, 0
  %204 = fcmp olt double %194, 0.000000e+00
  %205 = and i1 %203, %204
  br i1 %205, label %206, label %209

206:                                              ; preds = %202
  %207 = icmp slt i64 %196, 1
  %208 = zext i1 %207 to i32
  br label %209

209:                                              ; preds = %186, %202, %206
  %210 = phi i32 [ 1, %186 ], [ 0, %202 ], [ %208, %206 ]
  %211 = icmp eq i32 %210, 0
  br i1 %211, label %276, label %212

212:                                              ; preds = %209
  %213 = getelementptr inbounds double, ptr %16, i64 %189
  %214 = load double, ptr %213, align 8
  %215 = fcmp ogt double %214, 0.000000e+00
  %216 = and i1 %197, %215
  %217 = and i1 %200, %216
  br i1 %217, label %225, label %218

218:                                              ; preds = %212
  %219 = icmp sgt i64 %192, 0
  %220 = fcmp olt double %214, 0.000000e+00
  %221 = and i1 %219, %220
  br i1 %221, label %222, label %225

222:                                              ; preds = %218
  %223 = icmp slt i64 %196, 1
  %224 = zext i1 %223 to i32
  br label %225

225:                                              ; preds = %212, %218, %222
  %226 = phi i32 [ 1, %212 ], [ 0, %218 ], [ %224, %222 ]
  %227 = icmp eq i32 %226, 0
  br i1 %227, label %228, label %276

228:                                              ; preds = %225
  %229 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %101, double noundef %190, i64 noundef %189) #7
  %230 = fcmp ogt double %229, %101
  br i1 %230, label %231, label %233

231:                                              ; preds = %228
  %232 = getelementptr inbounds i64, ptr %20, i64 %189
  store i64 2, ptr %232, align 8
  br label %233

233:                                              ; preds = %231, %228
  %234 = phi double [ %229, %231 ], [ %190, %228 ]
  %235 = load ptr, ptr %27, align 8
  %236 = load ptr, ptr %28, align 8
  %237 = insertelement <8 x double> poison, double %234, i64 0
  %238 = shufflevector <8 x double> %237, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %238, ptr %236, align 8
  %239 = load ptr, ptr %8, align 8
  %240 = load ptr, ptr %29, align 8
  %241 = load i64, ptr %30, align 8
  %242 = load ptr, ptr %0, align 8
  %243 = getelementptr inbounds i8, ptr %242, i64 24
  %244 = load i64, ptr %243, align 8
  %245 = load ptr, ptr %28, align 8
  %246 = load ptr, ptr %6, align 8
  %247 = getelementptr inbounds i8, ptr %246, i64 16
  %248 = load i64, ptr %247, align 8
  tail call fastcc void @nested(ptr noundef %235, ptr noundef %239, ptr noundef %240, i64 noundef %241, i64 noundef %244, ptr noundef %245, i64 noundef %248) #7
  %249 = fmul double %234, %2
  %250 = fadd double %249, %1
  %251 = load ptr, ptr %31, align 8
  store double %250, ptr %251, align 8
  %252 = load i64, ptr %32, align 8
  %253 = icmp sgt i64 %252, 0
  br i1 %253, label %254, label %255

254:                                              ; preds = %233
  tail call fastcc void @sample(ptr noundef nonnull %6) #7
  br label %255

255:                                              ; preds = %233, %254
  %256 = load ptr, ptr %9, align 8
  %257 = load i64, ptr %256, align 8
  %258 = load ptr, ptr %33, align 8
  %259 = load ptr, ptr %27, align 8
  %260 = load ptr, ptr %34, align 8
  %261 = load ptr, ptr %35, align 8
  %262 = load ptr, ptr %15, align 8
  %263 = getelementptr inbounds i8, ptr %256, i64 8
  %264 = load i64, ptr %263, align 8
  %265 = getelementptr inbounds double, ptr %262, i64 %264
  %266 = inttoptr i64 %257 to ptr
  %267 = tail call i32 %266(ptr noundef %258, ptr noundef %259, ptr noundef %260, ptr noundef %261, ptr noundef %265) #8
  %268 = icmp sgt i32 %267, -1
  br i1 %268, label %274, label %269

269:                                              ; preds = %255
  %270 = load ptr, ptr %22, align 8
  %271 = getelementptr inbounds i8, ptr %270, i64 80
  store i64 %25, ptr %271, align 8
  %272 = load ptr, ptr %21, align 8
  %273 = getelementptr inbounds i8, ptr %272, i64 48
  store double 1.000000e+00, ptr %273, align 8
  br label %274

274:                                              ; preds = %255, %269
  %275 = phi i64 [ -4, %269 ], [ %188, %255 ]
  br i1 %268, label %276, label %282

276:                                              ; preds = %209, %225, %274
  %277 = phi double [ %190, %225 ], [ %234, %274 ], [ %190, %209 ]
  %278 = phi i64 [ %188, %225 ], [ %275, %274 ], [ %188, %209 ]
  %279 = add nuw nsw i64 %189, 1
  %280 = icmp slt i64 %279, %12
  %281 = icmp eq i64 %279, %12
  br i1 %281, label %282, label %186, !llvm.loop !7

282:                                              ; preds = %274, %276, %180
  %283 = phi i1 [ %37, %180 ], [ %187, %274 ], [ %280, %276 ]
  %284 = phi i32 [ 10, %180 ], [ 1, %274 ], [ 10, %276 ]
  %285 = phi double [ %104, %180 ], [ %234, %274 ], [ %277, %276 ]
  %286 = phi i64 [ %102, %180 ], [ %275, %274 ], [ %278, %276 ]
  br i1 %283, label %453, label %287

287:                                              ; preds = %282
  br i1 %39, label %298, label %290

288:                                              ; preds = %385
  %289 = zext i1 %386 to i32
  br label %290

290:                                              ; preds = %288, %287
  %291 = phi i32 [ 0, %287 ], [ %289, %288 ]
  %292 = phi i64 [ -1, %287 ], [ %375, %288 ]
  %293 = icmp eq i32 %291, 0
  br i1 %293, label %294, label %389

294:                                              ; preds = %290
  br i1 %43, label %295, label %438

295:                                              ; preds = %294
  %296 = fmul double %285, %2
  %297 = fadd double %296, %1
  br label %390

298:                                              ; preds = %287, %385
  %299 = phi i64 [ %387, %385 ], [ 0, %287 ]
  %300 = phi i64 [ %375, %385 ], [ -1, %287 ]
  %301 = phi i1 [ %386, %385 ], [ false, %287 ]
  %302 = getelementptr double, ptr %40, i64 %299
  %303 = load double, ptr %302, align 8
  %304 = getelementptr inbounds i64, ptr %18, i64 %299
  %305 = load i64, ptr %304, align 8
  %306 = getelementptr inbounds i64, ptr %14, i64 %299
  %307 = load i64, ptr %306, align 8
  %308 = icmp slt i64 %305, 0
  %309 = fcmp ogt double %303, 0.000000e+00
  %310 = and i1 %309, %308
  %311 = icmp sgt i64 %307, -1
  %312 = and i1 %310, %311
  br i1 %312, label %320, label %313

313:                                              ; preds = %298
  %314 = icmp sgt i64 %305, 0
  %315 = fcmp olt double %303, 0.000000e+00
  %316 = and i1 %315, %314
  br i1 %316, label %317, label %320

317:                                              ; preds = %313
  %318 = icmp slt i64 %307, 1
  %319 = zext i1 %318 to i32
  br label %320

320:                                              ; preds = %298, %313, %317
  %321 = phi i32 [ 1, %298 ], [ 0, %313 ], [ %319, %317 ]
  %322 = icmp eq i32 %321, 0
  br i1 %322, label %323, label %348

323:                                              ; preds = %320
  %324 = getelementptr inbounds double, ptr %16, i64 %299
  %325 = load double, ptr %324, align 8
  %326 = fcmp ogt double %325, 0.000000e+00
  %327 = and i1 %308, %326
  %328 = and i1 %311, %327
  br i1 %328, label %336, label %329

329:                                              ; preds = %323
  %330 = icmp sgt i64 %305, 0
  %331 = fcmp olt double %325, 0.000000e+00
  %332 = and i1 %330, %331
  br i1 %332, label %333, label %336

333:                                              ; preds = %329
  %334 = icmp slt i64 %307, 1
  %335 = zext i1 %334 to i32
  br label %336

336:                                              ; preds = %323, %329, %333
  %337 = phi i32 [ 1, %323 ], [ 0, %329 ], [ %335, %333 ]
  %338 = icmp eq i32 %337, 0
  br i1 %338, label %348, label %339

339:                                              ; preds = %336
  %340 = fcmp oeq double %303, 0.000000e+00
  br i1 %340, label %345, label %341

341:                                              ; preds = %339
  %342 = getelementptr inbounds i64, ptr %20, i64 %299
  %343 = load i64, ptr %342, align 8
  %344 = icmp eq i64 %343, 1
  br label %345

345:                                              ; preds = %341, %339
  %346 = phi i1 [ true, %339 ], [ %344, %341 ]
  %347 = zext i1 %346 to i32
  br label %348

348:                                              ; preds = %345, %336, %320
  %349 = phi i32 [ 1, %320 ], [ %347, %345 ], [ 0, %336 ]
  %350 = icmp eq i32 %349, 0
  br i1 %350, label %351, label %357

351:                                              ; preds = %348
  %352 = getelementptr inbounds i64, ptr %20, i64 %299
  %353 = load i64, ptr %352, align 8
  %354 = icmp eq i64 %353, 2
  %355 = fcmp oeq double %303, 0.000000e+00
  %356 = and i1 %355, %354
  br label %357

357:                                              ; preds = %351, %348
  %358 = phi i1 [ true, %348 ], [ %356, %351 ]
  br i1 %358, label %374, label %359

359:                                              ; preds = %357
  %360 = getelementptr inbounds double, ptr %16, i64 %299
  %361 = load double, ptr %360, align 8
  %362 = icmp eq i64 %305, 0
  %363 = fcmp ord double %361, 0.000000e+00
  %364 = or i1 %362, %363
  br i1 %364, label %374, label %365

365:                                              ; preds = %359
  %366 = sitofp i64 %305 to double
  %367 = fmul double %303, %366
  %368 = fcmp olt double %367, 0.000000e+00
  br i1 %368, label %369, label %371

369:                                              ; preds = %365
  %370 = sub nsw i64 0, %305
  store i64 %370, ptr %304, align 8
  br label %374

371:                                              ; preds = %365
  %372 = fcmp ueq double %303, 0.000000e+00
  %373 = select i1 %372, i64 %299, i64 %300
  br label %374

374:                                              ; preds = %371, %369, %359, %357
  %375 = phi i64 [ %300, %357 ], [ %300, %369 ], [ %300, %359 ], [ %373, %371 ]
  %376 = zext i1 %358 to i64
  %377 = getelementptr inbounds i64, ptr %20, i64 %299
  store i64 %376, ptr %377, align 8
  %378 = xor i1 %358, true
  %379 = or i1 %301, %378
  br i1 %379, label %385, label %380

380:                                              ; preds = %374
  %381 = load ptr, ptr %41, align 8
  %382 = getelementptr inbounds i64, ptr %381, i64 %299
  %383 = load i64, ptr %382, align 8
  %384 = icmp eq i64 %383, 1
  br label %385

385:                                              ; preds = %374, %380
  %386 = phi i1 [ %301, %374 ], [ %384, %380 ]
  %387 = add nuw nsw i64 %299, 1
  %388 = icmp eq i64 %387, %12
  br i1 %388, label %288, label %298, !llvm.loop !8

389:                                              ; preds = %290
  store double %285, ptr %42, align 8
  br label %453

390:                                              ; preds = %295, %434
  %391 = phi i1 [ %43, %295 ], [ %436, %434 ]
  %392 = phi i64 [ 0, %295 ], [ %435, %434 ]
  %393 = getelementptr inbounds i64, ptr %20, i64 %392
  %394 = load i64, ptr %393, align 8
  %395 = icmp eq i64 %394, 0
  br i1 %395, label %434, label %396

396:                                              ; preds = %390
  %397 = load ptr, ptr %22, align 8
  %398 = getelementptr inbounds i8, ptr %397, i64 80
  %399 = load i64, ptr %398, align 8
  %400 = load ptr, ptr %6, align 8
  %401 = getelementptr inbounds i8, ptr %400, i64 8
  %402 = load i64, ptr %401, align 8
  %403 = load i64, ptr %45, align 8
  %404 = icmp eq i64 %403, 0
  br i1 %404, label %430, label %405

405:                                              ; preds = %396
  %406 = icmp eq i64 %399, %403
  br i1 %406, label %429, label %407

407:                                              ; preds = %405
  %408 = load ptr, ptr %44, align 8
  %409 = getelementptr inbounds double, ptr %408, i64 %399
  store double %297, ptr %409, align 8
  %410 = load ptr, ptr %46, align 8
  %411 = getelementptr inbounds i64, ptr %410, i64 %399
  store i64 %392, ptr %411, align 8
  %412 = icmp sgt i64 %402, 0
  br i1 %412, label %417, label %413

413:                                              ; preds = %417, %407
  %414 = add nsw i64 %399, 1
  %415 = load ptr, ptr %22, align 8
  %416 = getelementptr inbounds i8, ptr %415, i64 80
  store i64 %414, ptr %416, align 8
  br label %430

417:                                              ; preds = %407, %417
  %418 = phi i64 [ %427, %417 ], [ 0, %407 ]
  %419 = load ptr, ptr %27, align 8
  %420 = getelementptr inbounds double, ptr %419, i64 %418
  %421 = load double, ptr %420, align 8
  %422 = load ptr, ptr %47, align 8
  %423 = load i64, ptr %48, align 8
  %424 = mul nsw i64 %423, %399
  %425 = getelementptr double, ptr %422, i64 %424
  %426 = getelementptr double, ptr %425, i64 %418
  store double %421, ptr %426, align 8
  %427 = add nuw nsw i64 %418, 1
  %428 = icmp eq i64 %427, %402
  br i1 %428, label %413, label %417, !llvm.loop !9

429:                                              ; preds = %405
  store double %285, ptr %49, align 8
  br label %438

430:                                              ; preds = %413, %396
  %431 = getelementptr inbounds i64, ptr %18, i64 %392
  %432 = load i64, ptr %431, align 8
  %433 = sub nsw i64 0, %432
  store i64 %433, ptr %431, align 8
  br label %434

434:                                              ; preds = %390, %430
  %435 = add nuw nsw i64 %392, 1
  %436 = icmp slt i64 %435, %12
  %437 = icmp eq i64 %435, %12
  br i1 %437, label %438, label %390, !llvm.loop !10

438:                                              ; preds = %434, %294, %429
  %439 = phi i1 [ %391, %429 ], [ %43, %294 ], [ %436, %434 ]
  %440 = phi i32 [ 1, %429 ], [ 16, %294 ], [ 16, %434 ]
  %441 = phi i64 [ -3, %429 ], [ %286, %294 ], [ %286, %434 ]
  br i1 %439, label %453, label %442

442:                                              ; preds = %438
  %443 = icmp sgt i64 %292, -1
  br i1 %443, label %444, label %453

444:                                              ; preds = %442
  br i1 %50, label %446, label %445

445:                                              ; preds = %446, %444
  store double %285, ptr %51, align 8
  br label %453

446:                                              ; preds = %444, %446
  %447 = phi i64 [ %451, %446 ], [ 0, %444 ]
  %448 = icmp eq i64 %447, %292
  %449 = zext i1 %448 to i64
  %450 = getelementptr inbounds i64, ptr %20, i64 %447
  store i64 %449, ptr %450, align 8
  %451 = add nuw nsw i64 %447, 1
  %452 = icmp eq i64 %451, %12
  br i1 %452, label %445, label %446, !llvm.loop !11

453:                                              ; preds = %389, %445, %438, %442, %103, %282, %181
  %454 = phi i32 [ 1, %181 ], [ %284, %282 ], [ 5, %103 ], [ 1, %389 ], [ 1, %445 ], [ %440, %438 ], [ 0, %442 ]
  %455 = phi double [ %101, %181 ], [ %101, %282 ], [ %101, %103 ], [ %101, %389 ], [ %101, %445 ], [ %101, %438 ], [ %285, %442 ]
  %456 = phi i64 [ -4, %181 ], [ %286, %282 ], [ %102, %103 ], [ -2, %389 ], [ 21, %445 ], [ %441, %438 ], [ %441, %442 ]
  switch i32 %454, label %471 [
    i32 0, label %100
    i32 5, label %457
  ], !llvm.loop !12

457:                                              ; preds = %453
  br i1 %52, label %458, label %471

458:                                              ; preds = %457, %468
  %459 = phi i64 [ %469, %468 ], [ 0, %457 ]
  %460 = getelementptr inbounds double, ptr %16, i64 %459
  %461 = load double, ptr %460, align 8
  %462 = fcmp ogt double %461, 0.000000e+00
  br i1 %462, label %465, label %463

463:                                              ; preds = %458
  %464 = fcmp olt double %461, 0.000000e+00
  br i1 %464, label %465, label %468

465:                                              ; preds = %463, %458
  %466 = phi i64 [ 1, %458 ], [ -1, %463 ]
  %467 = getelementptr inbounds i64, ptr %18, i64 %459
  store i64 %466, ptr %467, align 8
  br label %468

468:                                              ; preds = %465, %463
  %469 = add nuw nsw i64 %459, 1
  %470 = icmp eq i64 %469, %12
  br i1 %470, label %471, label %458, !llvm.loop !13

471:                                              ; preds = %453, %468, %457, %95
  %472 = phi i32 [ 1, %95 ], [ 0, %457 ], [ 0, %468 ], [ %454, %453 ]
  %473 = phi double [ %60, %95 ], [ %63, %457 ], [ %63, %468 ], [ %455, %453 ]
  %474 = phi i64 [ -4, %95 ], [ %456, %457 ], [ %456, %468 ], [ %456, %453 ]
  %475 = icmp eq i32 %472, 0
  br i1 %475, label %53, label %476

476:                                              ; preds = %53, %471
  %477 = phi i1 [ %55, %53 ], [ %58, %471 ]
  br i1 %477, label %478, label %480

478:                                              ; preds = %476
  %479 = getelementptr inbounds i8, ptr %26, i64 48
  store double 1.000000e+00, ptr %479, align 8
  br label %480

480:                                              ; preds = %476, %478
  %481 = phi i64 [ 0, %478 ], [ %474, %476 ]
  ret i64 %481
}


define internal fastcc double @locate(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, double noundef %4, double noundef %5, i64 noundef %6) unnamed_addr #2 {
  %8 = getelementptr inbounds i8, ptr %0, i64 720
  %9 = getelementptr inbounds i8, ptr %0, i64 816
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i64, ptr %10, i64 %6
  %12 = load i64, ptr %11, align 8
  %13 = sitofp i64 %12 to double
  %14 = getelementptr inbounds i8, ptr %0, i64 864
  %15 = load ptr, ptr %14, align 8
  %16 = load ptr, ptr %8, align 8
  %17 = getelementptr inbounds i8, ptr %16, i64 8
  %18 = load i64, ptr %17, align 8
  %19 = getelementptr inbounds double, ptr %15, i64 %18
  %20 = getelementptr inbounds double, ptr %19, i64 %6
  %21 = fadd double %2, %3
  %22 = tail call double @llvm.fabs.f64(double %21)
  %23 = tail call double @llvm.fabs.f64(double %2)
  %24 = fcmp ogt double %22, %23
  %25 = select i1 %24, double %22, double %23
  %26 = fmul double %25, 0x3CB0000000000000
  %27 = fdiv double %26, %3
  %28 = getelementptr inbounds i8, ptr %0, i64 144
  %29 = getelementptr inbounds i8, ptr %0, i64 888
  %30 = load ptr, ptr %29, align 8
  %31 = getelementptr inbounds i8, ptr %1, i64 16
  %32 = load ptr, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %32, i64 96
  %34 = load ptr, ptr %33, align 8
  %35 = insertelement <8 x double> poison, double %4, i64 0
  %36 = shufflevector <8 x double> %35, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %36, ptr %34, align 8
  %37 = load ptr, ptr %32, align 8
  %38 = getelementptr inbounds i8, ptr %32, i64 192
  %39 = load ptr, ptr %38, align 8
  %40 = getelementptr inbounds i8, ptr %32, i64 8
  %41 = load i64, ptr %40, align 8
  %42 = load ptr, ptr %1, align 8
  %43 = load ptr, ptr %42, align 8
  %44 = getelementptr inbounds i8, ptr %43, i64 24
  %45 = load i64, ptr %44, align 8
  %46 = load ptr, ptr %33, align 8
  %47 = getelementptr inbounds i8, ptr %1, i64 8
  %48 = load ptr, ptr %47, align 8
  %49 = load ptr, ptr %48, align 8
  %50 = getelementptr inbounds i8, ptr %49, i64 16
  %51 = load i64, ptr %50, align 8
  tail call fastcc void @nested(ptr noundef %30, ptr noundef %37, ptr noundef %39, i64 noundef %41, i64 noundef %45, ptr noundef %46, i64 noundef %51) #7
  %52 = fmul double %3, %4
  %53 = fadd double %52, %2
  %54 = getelementptr inbounds i8, ptr %0, i64 168
  %55 = load ptr, ptr %54, align 8
  store double %53, ptr %55, align 8
  %56 = getelementptr inbounds i8, ptr %0, i64 248
  %57 = load i64, ptr %56, align 8
  %58 = icmp sgt i64 %57, 0
  br i1 %58, label %59, label %60

59:                                               ; preds = %7
  tail call fastcc void @sample(ptr noundef nonnull %28) #7
  br label %60

60:                                               ; preds = %7, %59
  %61 = load ptr, ptr %8, align 8
  %62 = load i64, ptr %61, align 8
  %63 = getelementptr inbounds i8, ptr %0, i64 168
  %64 = load ptr, ptr %63, align 8
  %65 = load ptr, ptr %29, align 8
  %66 = getelementptr inbounds i8, ptr %0, i64 192
  %67 = load ptr, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %0, i64 744
  %69 = load ptr, ptr %68, align 8
  %70 = load ptr, ptr %14, align 8
  %71 = getelementptr inbounds i8, ptr %61, i64 8
  %72 = load i64, ptr %71, align 8
  %73 = getelementptr inbounds double, ptr %70, i64 %72
  %74 = inttoptr i64 %62 to ptr
  %75 = tail call i32 %74(ptr noundef %64, ptr noundef %65, ptr noundef %67, ptr noundef %69, ptr noundef %73) #8
  %76 = load double, ptr %20, align 8
  %77 = fmul double %76, %13
  %78 = fcmp ugt double %77, 0.000000e+00
  br i1 %78, label %131, label %79

79:                                               ; preds = %60, %113
  %80 = phi double [ %83, %113 ], [ %5, %60 ]
  %81 = fsub double %80, %4
  %82 = fmul double %81, 5.000000e-01
  %83 = fadd double %82, %4
  %84 = fsub double %83, %4
  %85 = fcmp uge double %84, %27
  br i1 %85, label %86, label %129

86:                                               ; preds = %79
  %87 = load ptr, ptr %29, align 8
  %88 = load ptr, ptr %31, align 8
  %89 = getelementptr inbounds i8, ptr %88, i64 96
  %90 = load ptr, ptr %89, align 8
  %91 = insertelement <8 x double> poison, double %83, i64 0
  %92 = shufflevector <8 x double> %91, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %92, ptr %90, align 8
  %93 = load ptr, ptr %88, align 8
  %94 = getelementptr inbounds i8, ptr %88, i64 192
  %95 = load ptr, ptr %94, align 8
  %96 = getelementptr inbounds i8, ptr %88, i64 8
  %97 = load i64, ptr %96, align 8
  %98 = load ptr, ptr %1, align 8
  %99 = load ptr, ptr %98, align 8
  %100 = getelementptr inbounds i8, ptr %99, i64 24
  %101 = load i64, ptr %100, align 8
  %102 = load ptr, ptr %89, align 8
  %103 = load ptr, ptr %47, align 8
  %104 = load ptr, ptr %103, align 8
  %105 = getelementptr inbounds i8, ptr %104, i64 16
  %106 = load i64, ptr %105, align 8
  tail call fastcc void @nested(ptr noundef %87, ptr noundef %93, ptr noundef %95, i64 noundef %97, i64 noundef %101, ptr noundef %102, i64 noundef %106) #7
  %107 = fmul double %83, %3
  %108 = fadd double %107, %2
  %109 = load ptr, ptr %54, align 8
  store double %108, ptr %109, align 8
  %110 = load i64, ptr %56, align 8
  %111 = icmp sgt i64 %110, 0
  br i1 %111, label %112, label %113

112:                                              ; preds = %86
  tail call fastcc void @sample(ptr noundef nonnull %28) #7
  br label %113

113:                                              ; preds = %86, %112
  %114 = load ptr, ptr %8, align 8
  %115 = load i64, ptr %114, align 8
  %116 = load ptr, ptr %63, align 8
  %117 = load ptr, ptr %29, align 8
  %118 = load ptr, ptr %66, align 8
  %119 = load ptr, ptr %68, align 8
  %120 = load ptr, ptr %14, align 8
  %121 = getelementptr inbounds i8, ptr %114, i64 8
  %122 = load i64, ptr %121, align 8
  %123 = getelementptr inbounds double, ptr %120, i64 %122
  %124 = inttoptr i64 %115 to ptr
  %125 = tail call i32 %124(ptr noundef %116, ptr noundef %117, ptr noundef %118, ptr noundef %119, ptr noundef %123) #8
  %126 = load double, ptr %20, align 8
  %127 = fmul double %126, %13
  %128 = fcmp ogt double %127, 0.000000e+00
  br i1 %128, label %129, label %79, !llvm.loop !14

129:                                              ; preds = %113, %79
  %130 = phi double [ %4, %79 ], [ %83, %113 ]
  br i1 %85, label %131, label %193

131:                                              ; preds = %129, %60
  %132 = phi double [ %5, %60 ], [ %80, %129 ]
  %133 = phi double [ %4, %60 ], [ %130, %129 ]
  br label %134

134:                                              ; preds = %131, %190
  %135 = phi double [ %191, %190 ], [ %132, %131 ]
  %136 = phi double [ %192, %190 ], [ %133, %131 ]
  %137 = fsub double %135, %136
  %138 = fcmp ogt double %137, %27
  br i1 %138, label %139, label %193

139:                                              ; preds = %134
  %140 = fmul double %137, 5.000000e-01
  %141 = fadd double %136, %140
  %142 = fcmp une double %141, %136
  %143 = fcmp une double %141, %135
  %144 = and i1 %142, %143
  br i1 %144, label %145, label %190

145:                                              ; preds = %139
  %146 = load ptr, ptr %29, align 8
  %147 = load ptr, ptr %31, align 8
  %148 = getelementptr inbounds i8, ptr %147, i64 96
  %149 = load ptr, ptr %148, align 8
  %150 = insertelement <8 x double> poison, double %141, i64 0
  %151 = shufflevector <8 x double> %150, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %151, ptr %149, align 8
  %152 = load ptr, ptr %147, align 8
  %153 = getelementptr inbounds i8, ptr %147, i64 192
  %154 = load ptr, ptr %153, align 8
  %155 = getelementptr inbounds i8, ptr %147, i64 8
  %156 = load i64, ptr %155, align 8
  %157 = load ptr, ptr %1, align 8
  %158 = load ptr, ptr %157, align 8
  %159 = getelementptr inbounds i8, ptr %158, i64 24
  %160 = load i64, ptr %159, align 8
  %161 = load ptr, ptr %148, align 8
  %162 = load ptr, ptr %47, align 8
  %163 = load ptr, ptr %162, align 8
  %164 = getelementptr inbounds i8, ptr %163, i64 16
  %165 = load i64, ptr %164, align 8
  tail call fastcc void @nested(ptr noundef %146, ptr noundef %152, ptr noundef %154, i64 noundef %156, i64 noundef %160, ptr noundef %161, i64 noundef %165) #7
  %166 = fmul double %141, %3
  %167 = fadd double %166, %2
  %168 = load ptr, ptr %54, align 8
  store double %167, ptr %168, align 8
  %169 = load i64, ptr %56, align 8
  %170 = icmp sgt i64 %169, 0
  br i1 %170, label %171, label %172

171:                                              ; preds = %145
  tail call fastcc void @sample(ptr noundef nonnull %28) #7
  br label %172

172:                                              ; preds = %145, %171
  %173 = load ptr, ptr %8, align 8
  %174 = load i64, ptr %173, align 8
  %175 = load ptr, ptr %63, align 8
  %176 = load ptr, ptr %29, align 8
  %177 = load ptr, ptr %66, align 8
  %178 = load ptr, ptr %68, align 8
  %179 = load ptr, ptr %14, align 8
  %180 = getelementptr inbounds i8, ptr %173, i64 8
  %181 = load i64, ptr %180, align 8
  %182 = getelementptr inbounds double, ptr %179, i64 %181
  %183 = inttoptr i64 %174 to ptr
  %184 = tail call i32 %183(ptr noundef %175, ptr noundef %176, ptr noundef %177, ptr noundef %178, ptr noundef %182) #8
  %185 = load double, ptr %20, align 8
  %186 = fmul double %185, %13
  %187 = fcmp ogt double %186, 0.000000e+00
  %188 = select i1 %187, double %135, double %141
  %189 = select i1 %187, double %141, double %136
  br label %190

190:                                              ; preds = %139, %172
  %191 = phi double [ %188, %172 ], [ %135, %139 ]
  %192 = phi double [ %189, %172 ], [ %136, %139 ]
  br i1 %144, label %134, label %193

193:                                              ; preds = %134, %190, %129
  %194 = phi double [ %4, %129 ], [ %191, %190 ], [ %135, %134 ]
  ret double %194
}


define internal fastcc void @nested(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, i64 noundef %3, i64 noundef %4, ptr noundef readonly %5, i64 noundef %6) unnamed_addr #3 {
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
  br i1 %31, label %20, label %19, !llvm.loop !15

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
  br i1 %43, label %32, label %24, !llvm.loop !16
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #4

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #5 {
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
  br i1 %55, label %44, label %56, !llvm.loop !17

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
  br i1 %83, label %13, label %12, !llvm.loop !18
}

declare double @llvm.fabs.f64(double) #4

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind willreturn memory(none) }
attributes #5 = { noinline nounwind }
attributes #6 = { nounwind }
attributes #7 = { nounwind }
attributes #8 = { nounwind }


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
!12 = distinct !{!12, !5}
!13 = distinct !{!13, !4, !5}
!14 = distinct !{!14, !5}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5}
!17 = distinct !{!17, !4, !5}
!18 = distinct !{!18, !4, !5}
