; sources dfd8f314568b824e08181b1389aed84da3e82d5413107bed81f64cc6d9363030
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

@PLACES = internal unnamed_addr constant [5 x double] [double 0.000000e+00, double 0x3FCE3779B97F4A7C, double 0x3FDCC470A0490974, double 0x3FE76CF5D0B09954, double 1.000000e+00], align 16

define i64 @scan_events(ptr noundef %0, double noundef %1, double noundef %2) #0 {
  %4 = alloca %struct.Stepper, align 8
  store ptr %0, ptr %4, align 8
  %5 = getelementptr inbounds i8, ptr %4, i64 8
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %6, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %4, i64 16
  %8 = getelementptr inbounds i8, ptr %0, i64 360
  store ptr %8, ptr %7, align 8
  %9 = getelementptr inbounds i8, ptr %0, i64 768
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 816
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 936
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %0, i64 960
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 624
  %20 = getelementptr inbounds i8, ptr %0, i64 648
  %21 = load ptr, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %21, i64 80
  %23 = load i64, ptr %22, align 8
  %24 = load ptr, ptr %19, align 8
  %25 = getelementptr inbounds i8, ptr %0, i64 984
  %26 = load ptr, ptr %25, align 8
  %27 = shl nsw i64 %12, 4
  %28 = getelementptr inbounds i8, ptr %26, i64 %27
  %29 = mul i64 %12, 88
  %30 = getelementptr inbounds i8, ptr %26, i64 %29
  %31 = getelementptr inbounds double, ptr %26, i64 %12
  %32 = load double, ptr %30, align 8
  %33 = fcmp oeq double %32, %1
  %34 = getelementptr inbounds i8, ptr %0, i64 1032
  %35 = getelementptr inbounds i8, ptr %0, i64 456
  %36 = getelementptr inbounds i8, ptr %0, i64 552
  %37 = getelementptr inbounds i8, ptr %0, i64 368
  %38 = getelementptr inbounds i8, ptr %0, i64 168
  %39 = getelementptr inbounds i8, ptr %0, i64 248
  %40 = getelementptr inbounds i8, ptr %0, i64 168
  %41 = getelementptr inbounds i8, ptr %0, i64 192
  %42 = getelementptr inbounds i8, ptr %0, i64 792
  %43 = zext i1 %33 to i64
  br label %51

44:                                               ; preds = %76
  %45 = add nuw nsw i64 %52, 1
  %46 = icmp eq i64 %45, 5
  br i1 %46, label %47, label %51, !llvm.loop !3

47:                                               ; preds = %44
  %48 = icmp sgt i64 %12, 0
  br i1 %48, label %49, label %100

49:                                               ; preds = %47
  %50 = getelementptr inbounds i8, ptr %0, i64 864
  br label %96

51:                                               ; preds = %3, %44
  %52 = phi i64 [ %43, %3 ], [ %45, %44 ]
  %53 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %52
  %54 = load double, ptr %53, align 8
  %55 = add nuw nsw i64 %52, 2
  %56 = load ptr, ptr %34, align 8
  %57 = load ptr, ptr %35, align 8
  %58 = insertelement <8 x double> poison, double %54, i64 0
  %59 = shufflevector <8 x double> %58, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %59, ptr %57, align 8
  %60 = load ptr, ptr %8, align 8
  %61 = load ptr, ptr %36, align 8
  %62 = load i64, ptr %37, align 8
  %63 = load ptr, ptr %0, align 8
  %64 = getelementptr inbounds i8, ptr %63, i64 24
  %65 = load i64, ptr %64, align 8
  %66 = load ptr, ptr %35, align 8
  %67 = load ptr, ptr %6, align 8
  %68 = getelementptr inbounds i8, ptr %67, i64 16
  %69 = load i64, ptr %68, align 8
  tail call fastcc void @nested(ptr noundef %56, ptr noundef %60, ptr noundef %61, i64 noundef %62, i64 noundef %65, ptr noundef %66, i64 noundef %69) #8
  %70 = fmul double %54, %2
  %71 = fadd double %70, %1
  %72 = load ptr, ptr %38, align 8
  store double %71, ptr %72, align 8
  %73 = load i64, ptr %39, align 8
  %74 = icmp sgt i64 %73, 0
  br i1 %74, label %75, label %76

75:                                               ; preds = %51
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %76

76:                                               ; preds = %51, %75
  %77 = load ptr, ptr %9, align 8
  %78 = load i64, ptr %77, align 8
  %79 = load ptr, ptr %40, align 8
  %80 = load ptr, ptr %34, align 8
  %81 = load ptr, ptr %41, align 8
  %82 = load ptr, ptr %42, align 8
  %83 = load ptr, ptr %25, align 8
  %84 = getelementptr inbounds i8, ptr %77, i64 8
  %85 = load i64, ptr %84, align 8
  %86 = mul nsw i64 %85, %55
  %87 = getelementptr inbounds double, ptr %83, i64 %86
  %88 = inttoptr i64 %78 to ptr
  %89 = load ptr, ptr %88, align 8
  %90 = tail call i32 %89(ptr noundef %79, ptr noundef %80, ptr noundef %81, ptr noundef %82, ptr noundef %87) #9
  %91 = icmp slt i32 %90, 0
  br i1 %91, label %92, label %44

92:                                               ; preds = %76
  %93 = load ptr, ptr %20, align 8
  %94 = getelementptr inbounds i8, ptr %93, i64 80
  store i64 %23, ptr %94, align 8
  %95 = load ptr, ptr %19, align 8
  br label %1029

96:                                               ; preds = %49, %116
  %97 = phi i64 [ 0, %49 ], [ %117, %116 ]
  %98 = load double, ptr %30, align 8
  %99 = fcmp une double %98, %1
  br i1 %99, label %102, label %100

100:                                              ; preds = %96, %116, %47
  %101 = call fastcc i64 @resolve(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2) #8
  switch i64 %101, label %1033 [
    i64 0, label %123
    i64 -4, label %119
  ]

102:                                              ; preds = %96
  %103 = load ptr, ptr %50, align 8
  %104 = getelementptr inbounds i64, ptr %103, i64 %97
  %105 = load i64, ptr %104, align 8
  %106 = and i64 %105, 2
  %107 = icmp eq i64 %106, 0
  br i1 %107, label %116, label %108

108:                                              ; preds = %102
  %109 = getelementptr inbounds double, ptr %28, i64 %97
  %110 = load double, ptr %109, align 8
  %111 = fcmp une double %110, 0.000000e+00
  br i1 %111, label %112, label %116

112:                                              ; preds = %108
  %113 = fcmp ogt double %110, 0.000000e+00
  %114 = select i1 %113, i64 1, i64 -1
  %115 = getelementptr inbounds i64, ptr %16, i64 %97
  store i64 %114, ptr %115, align 8
  br label %116

116:                                              ; preds = %102, %108, %112
  %117 = add nuw nsw i64 %97, 1
  %118 = icmp eq i64 %117, %12
  br i1 %118, label %100, label %96, !llvm.loop !6

119:                                              ; preds = %100
  %120 = load ptr, ptr %20, align 8
  %121 = getelementptr inbounds i8, ptr %120, i64 80
  store i64 %23, ptr %121, align 8
  %122 = load ptr, ptr %19, align 8
  br label %1029

123:                                              ; preds = %100
  %124 = getelementptr inbounds i8, ptr %0, i64 320
  %125 = load i64, ptr %124, align 8
  %126 = icmp sgt i64 %125, 0
  br i1 %126, label %127, label %181

127:                                              ; preds = %123
  %128 = getelementptr inbounds i8, ptr %0, i64 320
  %129 = load i64, ptr %128, align 8
  %130 = icmp sgt i64 %129, 0
  br i1 %130, label %131, label %134

131:                                              ; preds = %127
  %132 = getelementptr inbounds i8, ptr %0, i64 336
  %133 = load ptr, ptr %132, align 8
  store double 0x7FF0000000000000, ptr %133, align 8
  br label %134

134:                                              ; preds = %127, %131
  %135 = getelementptr inbounds i8, ptr %0, i64 1032
  %136 = load ptr, ptr %135, align 8
  %137 = getelementptr inbounds i8, ptr %0, i64 456
  %138 = load ptr, ptr %137, align 8
  store <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, ptr %138, align 8
  %139 = load ptr, ptr %8, align 8
  %140 = getelementptr inbounds i8, ptr %0, i64 552
  %141 = load ptr, ptr %140, align 8
  %142 = getelementptr inbounds i8, ptr %0, i64 368
  %143 = load i64, ptr %142, align 8
  %144 = load ptr, ptr %0, align 8
  %145 = getelementptr inbounds i8, ptr %144, i64 24
  %146 = load i64, ptr %145, align 8
  %147 = load ptr, ptr %137, align 8
  %148 = load ptr, ptr %6, align 8
  %149 = getelementptr inbounds i8, ptr %148, i64 16
  %150 = load i64, ptr %149, align 8
  tail call fastcc void @nested(ptr noundef %136, ptr noundef %139, ptr noundef %141, i64 noundef %143, i64 noundef %146, ptr noundef %147, i64 noundef %150) #8
  %151 = fadd double %1, %2
  %152 = getelementptr inbounds i8, ptr %0, i64 168
  %153 = load ptr, ptr %152, align 8
  store double %151, ptr %153, align 8
  %154 = getelementptr inbounds i8, ptr %0, i64 248
  %155 = load i64, ptr %154, align 8
  %156 = icmp sgt i64 %155, 0
  br i1 %156, label %157, label %158

157:                                              ; preds = %134
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %158

158:                                              ; preds = %134, %157
  %159 = load ptr, ptr %9, align 8
  %160 = load i64, ptr %159, align 8
  %161 = getelementptr inbounds i8, ptr %0, i64 168
  %162 = load ptr, ptr %161, align 8
  %163 = load ptr, ptr %135, align 8
  %164 = getelementptr inbounds i8, ptr %0, i64 192
  %165 = load ptr, ptr %164, align 8
  %166 = getelementptr inbounds i8, ptr %0, i64 792
  %167 = load ptr, ptr %166, align 8
  %168 = load ptr, ptr %25, align 8
  %169 = getelementptr inbounds i8, ptr %159, i64 8
  %170 = load i64, ptr %169, align 8
  %171 = mul i64 %170, 48
  %172 = getelementptr inbounds i8, ptr %168, i64 %171
  %173 = inttoptr i64 %160 to ptr
  %174 = load ptr, ptr %173, align 8
  %175 = tail call i32 %174(ptr noundef %162, ptr noundef %163, ptr noundef %165, ptr noundef %167, ptr noundef %172) #9
  %176 = icmp slt i32 %175, 0
  br i1 %176, label %177, label %181

177:                                              ; preds = %158
  %178 = load ptr, ptr %20, align 8
  %179 = getelementptr inbounds i8, ptr %178, i64 80
  store i64 %23, ptr %179, align 8
  %180 = load ptr, ptr %19, align 8
  br label %1029

181:                                              ; preds = %158, %123
  store double 0x7FF8000000000000, ptr %30, align 8
  %182 = getelementptr inbounds i8, ptr %0, i64 1032
  %183 = load ptr, ptr %7, align 8
  %184 = getelementptr inbounds i8, ptr %183, i64 96
  %185 = getelementptr inbounds i8, ptr %183, i64 192
  %186 = getelementptr inbounds i8, ptr %183, i64 8
  %187 = load ptr, ptr %4, align 8
  %188 = load ptr, ptr %5, align 8
  %189 = getelementptr inbounds i8, ptr %0, i64 168
  %190 = getelementptr inbounds i8, ptr %0, i64 248
  %191 = getelementptr inbounds i8, ptr %0, i64 168
  %192 = getelementptr inbounds i8, ptr %0, i64 192
  %193 = getelementptr inbounds i8, ptr %0, i64 792
  %194 = icmp sgt i64 %12, 0
  %195 = getelementptr inbounds i8, ptr %0, i64 1032
  %196 = load ptr, ptr %7, align 8
  %197 = getelementptr inbounds i8, ptr %196, i64 96
  %198 = getelementptr inbounds i8, ptr %196, i64 192
  %199 = getelementptr inbounds i8, ptr %196, i64 8
  %200 = load ptr, ptr %4, align 8
  %201 = load ptr, ptr %5, align 8
  %202 = getelementptr inbounds i8, ptr %0, i64 168
  %203 = getelementptr inbounds i8, ptr %0, i64 248
  %204 = getelementptr inbounds i8, ptr %0, i64 168
  %205 = getelementptr inbounds i8, ptr %0, i64 192
  %206 = getelementptr inbounds i8, ptr %0, i64 792
  %207 = icmp sgt i64 %12, 0
  %208 = icmp sgt i64 %12, 0
  %209 = getelementptr inbounds i8, ptr %0, i64 840
  %210 = getelementptr inbounds i8, ptr %24, i64 48
  %211 = getelementptr inbounds i8, ptr %0, i64 672
  %212 = getelementptr inbounds i8, ptr %0, i64 680
  %213 = fadd double %1, %2
  %214 = tail call double @llvm.fabs.f64(double %213)
  %215 = getelementptr inbounds i8, ptr %0, i64 1016
  %216 = getelementptr inbounds i8, ptr %0, i64 1008
  %217 = icmp sgt i64 %12, 0
  %218 = getelementptr inbounds i8, ptr %0, i64 1064
  %219 = getelementptr inbounds i8, ptr %0, i64 1056
  %220 = getelementptr inbounds i8, ptr %0, i64 1080
  %221 = getelementptr inbounds i8, ptr %0, i64 1128
  %222 = getelementptr inbounds i8, ptr %0, i64 1104
  %223 = getelementptr inbounds i8, ptr %0, i64 672
  %224 = getelementptr inbounds i8, ptr %0, i64 680
  %225 = fadd double %1, %2
  %226 = tail call double @llvm.fabs.f64(double %225)
  %227 = getelementptr inbounds i8, ptr %0, i64 1016
  %228 = getelementptr inbounds i8, ptr %0, i64 1008
  %229 = getelementptr inbounds i8, ptr %0, i64 1064
  %230 = getelementptr inbounds i8, ptr %24, i64 48
  %231 = icmp sgt i64 %12, 0
  %232 = getelementptr inbounds i8, ptr %24, i64 48
  %233 = icmp sgt i64 %12, 0
  %234 = getelementptr inbounds i8, ptr %0, i64 1016
  %235 = getelementptr inbounds i8, ptr %0, i64 1008
  br label %236

236:                                              ; preds = %181, %1008
  %237 = phi i1 [ false, %181 ], [ %1012, %1008 ]
  %238 = phi i64 [ -4, %181 ], [ %1006, %1008 ]
  %239 = phi double [ 0.000000e+00, %181 ], [ %1005, %1008 ]
  %240 = phi i32 [ 1, %181 ], [ %1011, %1008 ]
  %241 = zext nneg i32 %240 to i64
  %242 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %241
  %243 = load double, ptr %242, align 8
  %244 = mul nsw i64 %12, %241
  %245 = load ptr, ptr %9, align 8
  %246 = getelementptr inbounds i8, ptr %245, i64 8
  %247 = load i64, ptr %246, align 8
  %248 = icmp sgt i64 %247, 0
  br i1 %248, label %249, label %290

249:                                              ; preds = %236
  %250 = add nsw i32 %240, -1
  %251 = icmp ugt i32 %240, 1
  %252 = select i1 %251, i32 %250, i32 1
  %253 = tail call i32 @llvm.smin.i32(i32 %240, i32 3)
  %254 = icmp sgt i32 %252, %253
  %255 = zext nneg i32 %240 to i64
  %256 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %255
  br label %260

257:                                              ; preds = %287
  %258 = add nuw nsw i64 %262, 1
  %259 = icmp eq i64 %258, %247
  br i1 %259, label %290, label %260, !llvm.loop !7

260:                                              ; preds = %249, %257
  %261 = phi double [ 2.000000e+00, %249 ], [ %289, %257 ]
  %262 = phi i64 [ 0, %249 ], [ %258, %257 ]
  %263 = load ptr, ptr %15, align 8
  %264 = getelementptr inbounds i64, ptr %263, i64 %262
  %265 = load i64, ptr %264, align 8
  %266 = sitofp i64 %265 to double
  br i1 %254, label %287, label %271

267:                                              ; preds = %285
  %268 = add i32 %273, 1
  %269 = icmp sge i32 %273, %253
  %270 = icmp eq i32 %273, %253
  br i1 %270, label %287, label %271, !llvm.loop !8

271:                                              ; preds = %260, %267
  %272 = phi i1 [ %269, %267 ], [ %254, %260 ]
  %273 = phi i32 [ %268, %267 ], [ %252, %260 ]
  %274 = phi double [ %286, %267 ], [ %261, %260 ]
  %275 = call fastcc double @least_place(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, i64 noundef %262, double noundef %266, i32 noundef %273, i32 noundef %240) #8
  %276 = fcmp une double %275, -4.000000e+00
  %277 = fcmp ogt double %275, %239
  %278 = and i1 %276, %277
  br i1 %278, label %279, label %285

279:                                              ; preds = %271
  %280 = load double, ptr %256, align 8
  %281 = fcmp olt double %274, %280
  %282 = select i1 %281, double %274, double %280
  %283 = fcmp olt double %275, %282
  br i1 %283, label %284, label %285

284:                                              ; preds = %279
  br label %285

285:                                              ; preds = %284, %279, %271
  %286 = phi double [ %274, %271 ], [ %275, %284 ], [ %274, %279 ]
  br i1 %276, label %267, label %287

287:                                              ; preds = %267, %285, %260
  %288 = phi i1 [ %254, %260 ], [ %269, %267 ], [ %272, %285 ]
  %289 = phi double [ %261, %260 ], [ %286, %285 ], [ %286, %267 ]
  br i1 %288, label %257, label %290

290:                                              ; preds = %287, %257, %236
  %291 = phi double [ 2.000000e+00, %236 ], [ -4.000000e+00, %287 ], [ %289, %257 ]
  %292 = fcmp olt double %291, 0.000000e+00
  br i1 %292, label %998, label %293

293:                                              ; preds = %290
  %294 = getelementptr double, ptr %28, i64 %244
  %295 = fcmp olt double %291, %243
  br i1 %295, label %296, label %330

296:                                              ; preds = %293
  %297 = load ptr, ptr %25, align 8
  %298 = load ptr, ptr %182, align 8
  %299 = load ptr, ptr %184, align 8
  %300 = insertelement <8 x double> poison, double %291, i64 0
  %301 = shufflevector <8 x double> %300, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %301, ptr %299, align 8
  %302 = load ptr, ptr %183, align 8
  %303 = load ptr, ptr %185, align 8
  %304 = load i64, ptr %186, align 8
  %305 = load ptr, ptr %187, align 8
  %306 = getelementptr inbounds i8, ptr %305, i64 24
  %307 = load i64, ptr %306, align 8
  %308 = load ptr, ptr %184, align 8
  %309 = load ptr, ptr %188, align 8
  %310 = getelementptr inbounds i8, ptr %309, i64 16
  %311 = load i64, ptr %310, align 8
  tail call fastcc void @nested(ptr noundef %298, ptr noundef %302, ptr noundef %303, i64 noundef %304, i64 noundef %307, ptr noundef %308, i64 noundef %311) #8
  %312 = fmul double %291, %2
  %313 = fadd double %312, %1
  %314 = load ptr, ptr %189, align 8
  store double %313, ptr %314, align 8
  %315 = load i64, ptr %190, align 8
  %316 = icmp sgt i64 %315, 0
  br i1 %316, label %317, label %318

317:                                              ; preds = %296
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %318

318:                                              ; preds = %296, %317
  %319 = load ptr, ptr %9, align 8
  %320 = load i64, ptr %319, align 8
  %321 = load ptr, ptr %191, align 8
  %322 = load ptr, ptr %182, align 8
  %323 = load ptr, ptr %192, align 8
  %324 = load ptr, ptr %193, align 8
  %325 = load ptr, ptr %25, align 8
  %326 = inttoptr i64 %320 to ptr
  %327 = load ptr, ptr %326, align 8
  %328 = tail call i32 %327(ptr noundef %321, ptr noundef %322, ptr noundef %323, ptr noundef %324, ptr noundef %325) #9
  %329 = icmp slt i32 %328, 0
  br i1 %329, label %998, label %330

330:                                              ; preds = %318, %293
  %331 = phi double [ %291, %318 ], [ %243, %293 ]
  %332 = phi ptr [ %297, %318 ], [ %294, %293 ]
  br label %333

333:                                              ; preds = %942, %330
  %334 = phi double [ %239, %330 ], [ %944, %942 ]
  %335 = phi i64 [ %238, %330 ], [ %945, %942 ]
  br i1 %194, label %339, label %336

336:                                              ; preds = %374, %333
  %337 = phi double [ 2.000000e+00, %333 ], [ %375, %374 ]
  %338 = fcmp ogt double %337, 1.000000e+00
  br i1 %338, label %942, label %378

339:                                              ; preds = %333, %374
  %340 = phi i64 [ %376, %374 ], [ 0, %333 ]
  %341 = phi double [ %375, %374 ], [ 2.000000e+00, %333 ]
  %342 = getelementptr inbounds i64, ptr %18, i64 %340
  store i64 0, ptr %342, align 8
  %343 = getelementptr inbounds i64, ptr %16, i64 %340
  %344 = load i64, ptr %343, align 8
  %345 = getelementptr inbounds double, ptr %332, i64 %340
  %346 = load double, ptr %345, align 8
  %347 = getelementptr inbounds i64, ptr %14, i64 %340
  %348 = load i64, ptr %347, align 8
  %349 = icmp slt i64 %344, 0
  %350 = fcmp ogt double %346, 0.000000e+00
  %351 = and i1 %349, %350
  %352 = icmp sgt i64 %348, -1
  %353 = and i1 %351, %352
  br i1 %353, label %361, label %354

354:                                              ; preds = %339
  %355 = icmp sgt i64 %344, 0
  %356 = fcmp olt double %346, 0.000000e+00
  %357 = and i1 %355, %356
  br i1 %357, label %358, label %361

358:                                              ; preds = %354
  %359 = icmp slt i64 %348, 1
  %360 = zext i1 %359 to i32
  br label %361

361:                                              ; preds = %339, %354, %358
  %362 = phi i32 [ 1, %339 ], [ 0, %354 ], [ %360, %358 ]
  %363 = icmp eq i32 %362, 0
  br i1 %363, label %364, label %368

364:                                              ; preds = %361
  %365 = icmp eq i64 %344, 0
  %366 = fcmp ord double %346, 0.000000e+00
  %367 = or i1 %365, %366
  br i1 %367, label %374, label %368

368:                                              ; preds = %364, %361
  %369 = call fastcc double @locate(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %334, double noundef %331, i64 noundef %340) #8
  %370 = fcmp ole double %369, %334
  %371 = zext i1 %370 to i64
  store i64 %371, ptr %342, align 8
  %372 = fcmp olt double %369, %341
  %373 = select i1 %372, double %369, double %341
  br label %374

374:                                              ; preds = %364, %368
  %375 = phi double [ %373, %368 ], [ %341, %364 ]
  %376 = add nuw nsw i64 %340, 1
  %377 = icmp eq i64 %376, %12
  br i1 %377, label %336, label %339, !llvm.loop !9

378:                                              ; preds = %336
  %379 = load ptr, ptr %195, align 8
  %380 = load ptr, ptr %197, align 8
  %381 = insertelement <8 x double> poison, double %337, i64 0
  %382 = shufflevector <8 x double> %381, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %382, ptr %380, align 8
  %383 = load ptr, ptr %196, align 8
  %384 = load ptr, ptr %198, align 8
  %385 = load i64, ptr %199, align 8
  %386 = load ptr, ptr %200, align 8
  %387 = getelementptr inbounds i8, ptr %386, i64 24
  %388 = load i64, ptr %387, align 8
  %389 = load ptr, ptr %197, align 8
  %390 = load ptr, ptr %201, align 8
  %391 = getelementptr inbounds i8, ptr %390, i64 16
  %392 = load i64, ptr %391, align 8
  tail call fastcc void @nested(ptr noundef %379, ptr noundef %383, ptr noundef %384, i64 noundef %385, i64 noundef %388, ptr noundef %389, i64 noundef %392) #8
  %393 = fmul double %337, %2
  %394 = fadd double %393, %1
  %395 = load ptr, ptr %202, align 8
  store double %394, ptr %395, align 8
  %396 = load i64, ptr %203, align 8
  %397 = icmp sgt i64 %396, 0
  br i1 %397, label %398, label %399

398:                                              ; preds = %378
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %399

399:                                              ; preds = %378, %398
  %400 = load ptr, ptr %9, align 8
  %401 = load i64, ptr %400, align 8
  %402 = load ptr, ptr %204, align 8
  %403 = load ptr, ptr %195, align 8
  %404 = load ptr, ptr %205, align 8
  %405 = load ptr, ptr %206, align 8
  %406 = load ptr, ptr %25, align 8
  %407 = getelementptr inbounds i8, ptr %400, i64 8
  %408 = load i64, ptr %407, align 8
  %409 = getelementptr inbounds double, ptr %406, i64 %408
  %410 = inttoptr i64 %401 to ptr
  %411 = load ptr, ptr %410, align 8
  %412 = tail call i32 %411(ptr noundef %402, ptr noundef %403, ptr noundef %404, ptr noundef %405, ptr noundef %409) #9
  %413 = icmp slt i32 %412, 0
  br i1 %413, label %415, label %414

414:                                              ; preds = %399
  br i1 %207, label %420, label %517

415:                                              ; preds = %399
  %416 = load ptr, ptr %20, align 8
  %417 = getelementptr inbounds i8, ptr %416, i64 80
  store i64 %23, ptr %417, align 8
  %418 = load ptr, ptr %19, align 8
  %419 = getelementptr inbounds i8, ptr %418, i64 48
  store double 1.000000e+00, ptr %419, align 8
  br label %942

420:                                              ; preds = %414, %511
  %421 = phi i1 [ %515, %511 ], [ %207, %414 ]
  %422 = phi i64 [ %513, %511 ], [ %335, %414 ]
  %423 = phi i64 [ %514, %511 ], [ 0, %414 ]
  %424 = phi double [ %512, %511 ], [ %337, %414 ]
  %425 = getelementptr inbounds i64, ptr %16, i64 %423
  %426 = load i64, ptr %425, align 8
  %427 = getelementptr inbounds double, ptr %31, i64 %423
  %428 = load double, ptr %427, align 8
  %429 = getelementptr inbounds i64, ptr %14, i64 %423
  %430 = load i64, ptr %429, align 8
  %431 = icmp slt i64 %426, 0
  %432 = fcmp ogt double %428, 0.000000e+00
  %433 = and i1 %431, %432
  %434 = icmp sgt i64 %430, -1
  %435 = and i1 %433, %434
  br i1 %435, label %443, label %436

436:                                              ; preds = %420
  %437 = icmp sgt i64 %426, 0
  %438 = fcmp olt double %428, 0.000000e+00
  %439 = and i1 %437, %438
  br i1 %439, label %440, label %443

440:                                              ; preds = %436
  %441 = icmp slt i64 %430, 1
  %442 = zext i1 %441 to i32
  br label %443

443:                                              ; preds = %420, %436, %440
  %444 = phi i32 [ 1, %420 ], [ 0, %436 ], [ %442, %440 ]
  %445 = icmp eq i32 %444, 0
  br i1 %445, label %511, label %446

446:                                              ; preds = %443
  %447 = getelementptr inbounds double, ptr %332, i64 %423
  %448 = load double, ptr %447, align 8
  %449 = fcmp ogt double %448, 0.000000e+00
  %450 = and i1 %431, %449
  %451 = and i1 %434, %450
  br i1 %451, label %459, label %452

452:                                              ; preds = %446
  %453 = icmp sgt i64 %426, 0
  %454 = fcmp olt double %448, 0.000000e+00
  %455 = and i1 %453, %454
  br i1 %455, label %456, label %459

456:                                              ; preds = %452
  %457 = icmp slt i64 %430, 1
  %458 = zext i1 %457 to i32
  br label %459

459:                                              ; preds = %446, %452, %456
  %460 = phi i32 [ 1, %446 ], [ 0, %452 ], [ %458, %456 ]
  %461 = icmp eq i32 %460, 0
  br i1 %461, label %462, label %511

462:                                              ; preds = %459
  %463 = call fastcc double @locate(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %334, double noundef %424, i64 noundef %423) #8
  %464 = fcmp ogt double %463, %334
  br i1 %464, label %465, label %467

465:                                              ; preds = %462
  %466 = getelementptr inbounds i64, ptr %18, i64 %423
  store i64 2, ptr %466, align 8
  br label %467

467:                                              ; preds = %465, %462
  %468 = phi double [ %463, %465 ], [ %424, %462 ]
  %469 = load ptr, ptr %195, align 8
  %470 = load ptr, ptr %197, align 8
  %471 = insertelement <8 x double> poison, double %468, i64 0
  %472 = shufflevector <8 x double> %471, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %472, ptr %470, align 8
  %473 = load ptr, ptr %196, align 8
  %474 = load ptr, ptr %198, align 8
  %475 = load i64, ptr %199, align 8
  %476 = load ptr, ptr %200, align 8
  %477 = getelementptr inbounds i8, ptr %476, i64 24
  %478 = load i64, ptr %477, align 8
  %479 = load ptr, ptr %197, align 8
  %480 = load ptr, ptr %201, align 8
  %481 = getelementptr inbounds i8, ptr %480, i64 16
  %482 = load i64, ptr %481, align 8
  tail call fastcc void @nested(ptr noundef %469, ptr noundef %473, ptr noundef %474, i64 noundef %475, i64 noundef %478, ptr noundef %479, i64 noundef %482) #8
  %483 = fmul double %468, %2
  %484 = fadd double %483, %1
  %485 = load ptr, ptr %202, align 8
  store double %484, ptr %485, align 8
  %486 = load i64, ptr %203, align 8
  %487 = icmp sgt i64 %486, 0
  br i1 %487, label %488, label %489

488:                                              ; preds = %467
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %489

489:                                              ; preds = %467, %488
  %490 = load ptr, ptr %9, align 8
  %491 = load i64, ptr %490, align 8
  %492 = load ptr, ptr %204, align 8
  %493 = load ptr, ptr %195, align 8
  %494 = load ptr, ptr %205, align 8
  %495 = load ptr, ptr %206, align 8
  %496 = load ptr, ptr %25, align 8
  %497 = getelementptr inbounds i8, ptr %490, i64 8
  %498 = load i64, ptr %497, align 8
  %499 = getelementptr inbounds double, ptr %496, i64 %498
  %500 = inttoptr i64 %491 to ptr
  %501 = load ptr, ptr %500, align 8
  %502 = tail call i32 %501(ptr noundef %492, ptr noundef %493, ptr noundef %494, ptr noundef %495, ptr noundef %499) #9
  %503 = icmp sgt i32 %502, -1
  br i1 %503, label %509, label %504

504:                                              ; preds = %489
  %505 = load ptr, ptr %20, align 8
  %506 = getelementptr inbounds i8, ptr %505, i64 80
  store i64 %23, ptr %506, align 8
  %507 = load ptr, ptr %19, align 8
  %508 = getelementptr inbounds i8, ptr %507, i64 48
  store double 1.000000e+00, ptr %508, align 8
  br label %509

509:                                              ; preds = %489, %504
  %510 = phi i64 [ -4, %504 ], [ %422, %489 ]
  br i1 %503, label %511, label %517

511:                                              ; preds = %443, %459, %509
  %512 = phi double [ %424, %459 ], [ %468, %509 ], [ %424, %443 ]
  %513 = phi i64 [ %422, %459 ], [ %510, %509 ], [ %422, %443 ]
  %514 = add nuw nsw i64 %423, 1
  %515 = icmp slt i64 %514, %12
  %516 = icmp eq i64 %514, %12
  br i1 %516, label %517, label %420, !llvm.loop !10

517:                                              ; preds = %509, %511, %414
  %518 = phi i1 [ %207, %414 ], [ %421, %509 ], [ %515, %511 ]
  %519 = phi i32 [ 16, %414 ], [ 1, %509 ], [ 16, %511 ]
  %520 = phi double [ %337, %414 ], [ %468, %509 ], [ %512, %511 ]
  %521 = phi i64 [ %335, %414 ], [ %510, %509 ], [ %513, %511 ]
  br i1 %518, label %942, label %522

522:                                              ; preds = %517
  br i1 %208, label %533, label %525

523:                                              ; preds = %620
  %524 = zext i1 %621 to i32
  br label %525

525:                                              ; preds = %523, %522
  %526 = phi i32 [ 0, %522 ], [ %524, %523 ]
  %527 = phi i64 [ -1, %522 ], [ %610, %523 ]
  %528 = icmp eq i32 %526, 0
  br i1 %528, label %529, label %624

529:                                              ; preds = %525
  br i1 %217, label %530, label %751

530:                                              ; preds = %529
  %531 = fmul double %520, %2
  %532 = fadd double %531, %1
  br label %873

533:                                              ; preds = %522, %620
  %534 = phi i64 [ %622, %620 ], [ 0, %522 ]
  %535 = phi i64 [ %610, %620 ], [ -1, %522 ]
  %536 = phi i1 [ %621, %620 ], [ false, %522 ]
  %537 = getelementptr inbounds double, ptr %31, i64 %534
  %538 = load double, ptr %537, align 8
  %539 = getelementptr inbounds i64, ptr %16, i64 %534
  %540 = load i64, ptr %539, align 8
  %541 = getelementptr inbounds i64, ptr %14, i64 %534
  %542 = load i64, ptr %541, align 8
  %543 = icmp slt i64 %540, 0
  %544 = fcmp ogt double %538, 0.000000e+00
  %545 = and i1 %544, %543
  %546 = icmp sgt i64 %542, -1
  %547 = and i1 %545, %546
  br i1 %547, label %555, label %548

548:                                              ; preds = %533
  %549 = icmp sgt i64 %540, 0
  %550 = fcmp olt double %538, 0.000000e+00
  %551 = and i1 %550, %549
  br i1 %551, label %552, label %555

552:                                              ; preds = %548
  %553 = icmp slt i64 %542, 1
  %554 = zext i1 %553 to i32
  br label %555

555:                                              ; preds = %533, %548, %552
  %556 = phi i32 [ 1, %533 ], [ 0, %548 ], [ %554, %552 ]
  %557 = icmp eq i32 %556, 0
  br i1 %557, label %558, label %583

558:                                              ; preds = %555
  %559 = getelementptr inbounds double, ptr %332, i64 %534
  %560 = load double, ptr %559, align 8
  %561 = fcmp ogt double %560, 0.000000e+00
  %562 = and i1 %543, %561
  %563 = and i1 %546, %562
  br i1 %563, label %571, label %564

564:                                              ; preds = %558
  %565 = icmp sgt i64 %540, 0
  %566 = fcmp olt double %560, 0.000000e+00
  %567 = and i1 %565, %566
  br i1 %567, label %568, label %571

568:                                              ; preds = %564
  %569 = icmp slt i64 %542, 1
  %570 = zext i1 %569 to i32
  br label %571

571:                                              ; preds = %558, %564, %568
  %572 = phi i32 [ 1, %558 ], [ 0, %564 ], [ %570, %568 ]
  %573 = icmp eq i32 %572, 0
  br i1 %573, label %583, label %574

574:                                              ; preds = %571
  %575 = fcmp oeq double %538, 0.000000e+00
  br i1 %575, label %580, label %576

576:                                              ; preds = %574
  %577 = getelementptr inbounds i64, ptr %18, i64 %534
  %578 = load i64, ptr %577, align 8
  %579 = icmp eq i64 %578, 1
  br label %580

580:                                              ; preds = %576, %574
  %581 = phi i1 [ true, %574 ], [ %579, %576 ]
  %582 = zext i1 %581 to i32
  br label %583

583:                                              ; preds = %580, %571, %555
  %584 = phi i32 [ 1, %555 ], [ %582, %580 ], [ 0, %571 ]
  %585 = icmp eq i32 %584, 0
  br i1 %585, label %586, label %592

586:                                              ; preds = %583
  %587 = getelementptr inbounds i64, ptr %18, i64 %534
  %588 = load i64, ptr %587, align 8
  %589 = icmp eq i64 %588, 2
  %590 = fcmp oeq double %538, 0.000000e+00
  %591 = and i1 %590, %589
  br label %592

592:                                              ; preds = %586, %583
  %593 = phi i1 [ true, %583 ], [ %591, %586 ]
  br i1 %593, label %609, label %594

594:                                              ; preds = %592
  %595 = getelementptr inbounds double, ptr %332, i64 %534
  %596 = load double, ptr %595, align 8
  %597 = icmp eq i64 %540, 0
  %598 = fcmp ord double %596, 0.000000e+00
  %599 = or i1 %597, %598
  br i1 %599, label %609, label %600

600:                                              ; preds = %594
  %601 = sitofp i64 %540 to double
  %602 = fmul double %538, %601
  %603 = fcmp olt double %602, 0.000000e+00
  br i1 %603, label %604, label %606

604:                                              ; preds = %600
  %605 = sub nsw i64 0, %540
  store i64 %605, ptr %539, align 8
  br label %609

606:                                              ; preds = %600
  %607 = fcmp ueq double %538, 0.000000e+00
  %608 = select i1 %607, i64 %534, i64 %535
  br label %609

609:                                              ; preds = %606, %604, %594, %592
  %610 = phi i64 [ %535, %592 ], [ %535, %604 ], [ %535, %594 ], [ %608, %606 ]
  %611 = zext i1 %593 to i64
  %612 = getelementptr inbounds i64, ptr %18, i64 %534
  store i64 %611, ptr %612, align 8
  %613 = xor i1 %593, true
  %614 = or i1 %536, %613
  br i1 %614, label %620, label %615

615:                                              ; preds = %609
  %616 = load ptr, ptr %209, align 8
  %617 = getelementptr inbounds i64, ptr %616, i64 %534
  %618 = load i64, ptr %617, align 8
  %619 = icmp eq i64 %618, 1
  br label %620

620:                                              ; preds = %609, %615
  %621 = phi i1 [ %536, %609 ], [ %619, %615 ]
  %622 = add nuw nsw i64 %534, 1
  %623 = icmp eq i64 %622, %12
  br i1 %623, label %523, label %533, !llvm.loop !11

624:                                              ; preds = %525
  store double %520, ptr %210, align 8
  %625 = load ptr, ptr %9, align 8
  %626 = getelementptr inbounds i8, ptr %625, i64 8
  %627 = load i64, ptr %626, align 8
  %628 = load ptr, ptr %25, align 8
  %629 = getelementptr inbounds double, ptr %628, i64 %627
  %630 = mul i64 %627, 56
  %631 = getelementptr inbounds i8, ptr %628, i64 %630
  %632 = load ptr, ptr %211, align 8
  %633 = load i64, ptr %212, align 8
  %634 = getelementptr double, ptr %632, i64 %633
  %635 = getelementptr i8, ptr %634, i64 -8
  %636 = load double, ptr %635, align 8
  %637 = load double, ptr %632, align 8
  %638 = fsub double %636, %637
  %639 = icmp sgt i64 %627, 0
  br i1 %639, label %643, label %640

640:                                              ; preds = %656, %624
  %641 = phi i32 [ 0, %624 ], [ %658, %656 ]
  %642 = icmp eq i32 %641, 0
  br i1 %642, label %942, label %661

643:                                              ; preds = %624, %656
  %644 = phi i64 [ %659, %656 ], [ 0, %624 ]
  %645 = phi i32 [ %658, %656 ], [ 0, %624 ]
  %646 = icmp eq i32 %645, 0
  br i1 %646, label %647, label %656

647:                                              ; preds = %643
  %648 = load ptr, ptr %17, align 8
  %649 = getelementptr inbounds i64, ptr %648, i64 %644
  %650 = load i64, ptr %649, align 8
  %651 = icmp eq i64 %650, 0
  br i1 %651, label %656, label %652

652:                                              ; preds = %647
  %653 = getelementptr inbounds double, ptr %629, i64 %644
  %654 = load double, ptr %653, align 8
  %655 = fcmp oeq double %654, 0.000000e+00
  br label %656

656:                                              ; preds = %652, %647, %643
  %657 = phi i1 [ true, %643 ], [ false, %647 ], [ %655, %652 ]
  %658 = zext i1 %657 to i32
  %659 = add nuw nsw i64 %644, 1
  %660 = icmp eq i64 %659, %627
  br i1 %660, label %640, label %643, !llvm.loop !12

661:                                              ; preds = %640
  %662 = fsub double %331, %520
  %663 = fmul double %662, %2
  %664 = fcmp ogt double %214, %638
  %665 = select i1 %664, double %214, double %638
  %666 = fmul double %665, 0x3F50000000000000
  %667 = fcmp ugt double %663, %666
  br i1 %667, label %668, label %942

668:                                              ; preds = %661
  %669 = fmul double %662, 0x3F50000000000000
  %670 = fadd double %520, %669
  %671 = load ptr, ptr %195, align 8
  %672 = load ptr, ptr %197, align 8
  %673 = insertelement <8 x double> poison, double %670, i64 0
  %674 = shufflevector <8 x double> %673, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %674, ptr %672, align 8
  %675 = load ptr, ptr %196, align 8
  %676 = load ptr, ptr %198, align 8
  %677 = load i64, ptr %199, align 8
  %678 = load ptr, ptr %200, align 8
  %679 = getelementptr inbounds i8, ptr %678, i64 24
  %680 = load i64, ptr %679, align 8
  %681 = load ptr, ptr %197, align 8
  %682 = load ptr, ptr %201, align 8
  %683 = getelementptr inbounds i8, ptr %682, i64 16
  %684 = load i64, ptr %683, align 8
  tail call fastcc void @nested(ptr noundef %671, ptr noundef %675, ptr noundef %676, i64 noundef %677, i64 noundef %680, ptr noundef %681, i64 noundef %684) #8
  %685 = fmul double %670, %2
  %686 = fadd double %685, %1
  %687 = load ptr, ptr %202, align 8
  store double %686, ptr %687, align 8
  %688 = load i64, ptr %203, align 8
  %689 = icmp sgt i64 %688, 0
  br i1 %689, label %690, label %691

690:                                              ; preds = %668
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %691

691:                                              ; preds = %668, %690
  %692 = load ptr, ptr %9, align 8
  %693 = load i64, ptr %692, align 8
  %694 = load ptr, ptr %204, align 8
  %695 = load ptr, ptr %195, align 8
  %696 = load ptr, ptr %205, align 8
  %697 = load ptr, ptr %206, align 8
  %698 = load ptr, ptr %25, align 8
  %699 = getelementptr inbounds i8, ptr %692, i64 8
  %700 = load i64, ptr %699, align 8
  %701 = mul i64 %700, 56
  %702 = getelementptr inbounds i8, ptr %698, i64 %701
  %703 = inttoptr i64 %693 to ptr
  %704 = load ptr, ptr %703, align 8
  %705 = tail call i32 %704(ptr noundef %694, ptr noundef %695, ptr noundef %696, ptr noundef %697, ptr noundef %702) #9
  %706 = icmp slt i32 %705, 0
  br i1 %706, label %746, label %707

707:                                              ; preds = %691
  %708 = icmp sgt i64 %627, 0
  br i1 %708, label %709, label %942

709:                                              ; preds = %707
  %710 = fmul double %520, %2
  %711 = fadd double %710, %1
  %712 = fsub double %711, %711
  br label %713

713:                                              ; preds = %709, %743
  %714 = phi i64 [ 0, %709 ], [ %744, %743 ]
  %715 = load ptr, ptr %17, align 8
  %716 = getelementptr inbounds i64, ptr %715, i64 %714
  %717 = load i64, ptr %716, align 8
  %718 = icmp eq i64 %717, 0
  br i1 %718, label %743, label %719

719:                                              ; preds = %713
  %720 = getelementptr inbounds double, ptr %629, i64 %714
  %721 = load double, ptr %720, align 8
  %722 = fcmp oeq double %721, 0.000000e+00
  br i1 %722, label %723, label %743

723:                                              ; preds = %719
  %724 = getelementptr inbounds double, ptr %631, i64 %714
  %725 = load double, ptr %724, align 8
  %726 = fcmp oeq double %725, 0.000000e+00
  br i1 %726, label %727, label %743

727:                                              ; preds = %723
  %728 = load i64, ptr %215, align 8
  %729 = icmp eq i64 %728, 0
  br i1 %729, label %743, label %730

730:                                              ; preds = %727
  %731 = load ptr, ptr %216, align 8
  %732 = shl nsw i64 %714, 4
  %733 = getelementptr inbounds i8, ptr %731, i64 %732
  %734 = getelementptr inbounds i8, ptr %733, i64 8
  %735 = load double, ptr %734, align 8
  %736 = fcmp oeq double %735, %711
  br i1 %736, label %742, label %737

737:                                              ; preds = %730
  %738 = load double, ptr %733, align 8
  %739 = fsub double %735, %738
  %740 = fcmp ult double %739, %712
  br i1 %740, label %741, label %743

741:                                              ; preds = %737
  store double %711, ptr %733, align 8
  br label %742

742:                                              ; preds = %730, %741
  store double %711, ptr %734, align 8
  br label %743

743:                                              ; preds = %742, %737, %727, %723, %719, %713
  %744 = add nuw nsw i64 %714, 1
  %745 = icmp eq i64 %744, %627
  br i1 %745, label %942, label %713, !llvm.loop !13

746:                                              ; preds = %691
  %747 = load ptr, ptr %20, align 8
  %748 = getelementptr inbounds i8, ptr %747, i64 80
  store i64 %23, ptr %748, align 8
  %749 = load ptr, ptr %19, align 8
  %750 = getelementptr inbounds i8, ptr %749, i64 48
  store double 1.000000e+00, ptr %750, align 8
  br label %942

751:                                              ; preds = %915, %529
  %752 = load ptr, ptr %9, align 8
  %753 = getelementptr inbounds i8, ptr %752, i64 8
  %754 = load i64, ptr %753, align 8
  %755 = load ptr, ptr %25, align 8
  %756 = getelementptr inbounds double, ptr %755, i64 %754
  %757 = mul i64 %754, 56
  %758 = getelementptr inbounds i8, ptr %755, i64 %757
  %759 = load ptr, ptr %223, align 8
  %760 = load i64, ptr %224, align 8
  %761 = getelementptr double, ptr %759, i64 %760
  %762 = getelementptr i8, ptr %761, i64 -8
  %763 = load double, ptr %762, align 8
  %764 = load double, ptr %759, align 8
  %765 = fsub double %763, %764
  %766 = icmp sgt i64 %754, 0
  br i1 %766, label %770, label %767

767:                                              ; preds = %783, %751
  %768 = phi i32 [ 0, %751 ], [ %785, %783 ]
  %769 = icmp eq i32 %768, 0
  br i1 %769, label %923, label %788

770:                                              ; preds = %751, %783
  %771 = phi i64 [ %786, %783 ], [ 0, %751 ]
  %772 = phi i32 [ %785, %783 ], [ 0, %751 ]
  %773 = icmp eq i32 %772, 0
  br i1 %773, label %774, label %783

774:                                              ; preds = %770
  %775 = load ptr, ptr %17, align 8
  %776 = getelementptr inbounds i64, ptr %775, i64 %771
  %777 = load i64, ptr %776, align 8
  %778 = icmp eq i64 %777, 0
  br i1 %778, label %783, label %779

779:                                              ; preds = %774
  %780 = getelementptr inbounds double, ptr %756, i64 %771
  %781 = load double, ptr %780, align 8
  %782 = fcmp oeq double %781, 0.000000e+00
  br label %783

783:                                              ; preds = %779, %774, %770
  %784 = phi i1 [ true, %770 ], [ false, %774 ], [ %782, %779 ]
  %785 = zext i1 %784 to i32
  %786 = add nuw nsw i64 %771, 1
  %787 = icmp eq i64 %786, %754
  br i1 %787, label %767, label %770, !llvm.loop !12

788:                                              ; preds = %767
  %789 = fsub double %331, %520
  %790 = fmul double %789, %2
  %791 = fcmp ogt double %226, %765
  %792 = select i1 %791, double %226, double %765
  %793 = fmul double %792, 0x3F50000000000000
  %794 = fcmp ugt double %790, %793
  br i1 %794, label %795, label %923

795:                                              ; preds = %788
  %796 = fmul double %789, 0x3F50000000000000
  %797 = fadd double %520, %796
  %798 = load ptr, ptr %195, align 8
  %799 = load ptr, ptr %197, align 8
  %800 = insertelement <8 x double> poison, double %797, i64 0
  %801 = shufflevector <8 x double> %800, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %801, ptr %799, align 8
  %802 = load ptr, ptr %196, align 8
  %803 = load ptr, ptr %198, align 8
  %804 = load i64, ptr %199, align 8
  %805 = load ptr, ptr %200, align 8
  %806 = getelementptr inbounds i8, ptr %805, i64 24
  %807 = load i64, ptr %806, align 8
  %808 = load ptr, ptr %197, align 8
  %809 = load ptr, ptr %201, align 8
  %810 = getelementptr inbounds i8, ptr %809, i64 16
  %811 = load i64, ptr %810, align 8
  tail call fastcc void @nested(ptr noundef %798, ptr noundef %802, ptr noundef %803, i64 noundef %804, i64 noundef %807, ptr noundef %808, i64 noundef %811) #8
  %812 = fmul double %797, %2
  %813 = fadd double %812, %1
  %814 = load ptr, ptr %202, align 8
  store double %813, ptr %814, align 8
  %815 = load i64, ptr %203, align 8
  %816 = icmp sgt i64 %815, 0
  br i1 %816, label %817, label %818

817:                                              ; preds = %795
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %818

818:                                              ; preds = %795, %817
  %819 = load ptr, ptr %9, align 8
  %820 = load i64, ptr %819, align 8
  %821 = load ptr, ptr %204, align 8
  %822 = load ptr, ptr %195, align 8
  %823 = load ptr, ptr %205, align 8
  %824 = load ptr, ptr %206, align 8
  %825 = load ptr, ptr %25, align 8
  %826 = getelementptr inbounds i8, ptr %819, i64 8
  %827 = load i64, ptr %826, align 8
  %828 = mul i64 %827, 56
  %829 = getelementptr inbounds i8, ptr %825, i64 %828
  %830 = inttoptr i64 %820 to ptr
  %831 = load ptr, ptr %830, align 8
  %832 = tail call i32 %831(ptr noundef %821, ptr noundef %822, ptr noundef %823, ptr noundef %824, ptr noundef %829) #9
  %833 = icmp slt i32 %832, 0
  br i1 %833, label %918, label %834

834:                                              ; preds = %818
  %835 = icmp sgt i64 %754, 0
  br i1 %835, label %836, label %923

836:                                              ; preds = %834
  %837 = fmul double %520, %2
  %838 = fadd double %837, %1
  %839 = fsub double %838, %838
  br label %840

840:                                              ; preds = %836, %870
  %841 = phi i64 [ 0, %836 ], [ %871, %870 ]
  %842 = load ptr, ptr %17, align 8
  %843 = getelementptr inbounds i64, ptr %842, i64 %841
  %844 = load i64, ptr %843, align 8
  %845 = icmp eq i64 %844, 0
  br i1 %845, label %870, label %846

846:                                              ; preds = %840
  %847 = getelementptr inbounds double, ptr %756, i64 %841
  %848 = load double, ptr %847, align 8
  %849 = fcmp oeq double %848, 0.000000e+00
  br i1 %849, label %850, label %870

850:                                              ; preds = %846
  %851 = getelementptr inbounds double, ptr %758, i64 %841
  %852 = load double, ptr %851, align 8
  %853 = fcmp oeq double %852, 0.000000e+00
  br i1 %853, label %854, label %870

854:                                              ; preds = %850
  %855 = load i64, ptr %227, align 8
  %856 = icmp eq i64 %855, 0
  br i1 %856, label %870, label %857

857:                                              ; preds = %854
  %858 = load ptr, ptr %228, align 8
  %859 = shl nsw i64 %841, 4
  %860 = getelementptr inbounds i8, ptr %858, i64 %859
  %861 = getelementptr inbounds i8, ptr %860, i64 8
  %862 = load double, ptr %861, align 8
  %863 = fcmp oeq double %862, %838
  br i1 %863, label %869, label %864

864:                                              ; preds = %857
  %865 = load double, ptr %860, align 8
  %866 = fsub double %862, %865
  %867 = fcmp ult double %866, %839
  br i1 %867, label %868, label %870

868:                                              ; preds = %864
  store double %838, ptr %860, align 8
  br label %869

869:                                              ; preds = %857, %868
  store double %838, ptr %861, align 8
  br label %870

870:                                              ; preds = %869, %864, %854, %850, %846, %840
  %871 = add nuw nsw i64 %841, 1
  %872 = icmp eq i64 %871, %754
  br i1 %872, label %923, label %840, !llvm.loop !13

873:                                              ; preds = %530, %915
  %874 = phi i64 [ 0, %530 ], [ %916, %915 ]
  %875 = getelementptr inbounds i64, ptr %18, i64 %874
  %876 = load i64, ptr %875, align 8
  %877 = icmp eq i64 %876, 0
  br i1 %877, label %915, label %878

878:                                              ; preds = %873
  %879 = load ptr, ptr %20, align 8
  %880 = getelementptr inbounds i8, ptr %879, i64 80
  %881 = load i64, ptr %880, align 8
  %882 = load ptr, ptr %6, align 8
  %883 = getelementptr inbounds i8, ptr %882, i64 8
  %884 = load i64, ptr %883, align 8
  %885 = load i64, ptr %218, align 8
  %886 = icmp eq i64 %885, 0
  br i1 %886, label %911, label %887

887:                                              ; preds = %878
  %888 = load ptr, ptr %219, align 8
  %889 = getelementptr inbounds double, ptr %888, i64 %881
  store double %532, ptr %889, align 8
  %890 = load ptr, ptr %220, align 8
  %891 = getelementptr inbounds i64, ptr %890, i64 %881
  store i64 %874, ptr %891, align 8
  %892 = icmp sgt i64 %884, 0
  br i1 %892, label %893, label %895

893:                                              ; preds = %887
  %894 = mul nsw i64 %884, %881
  br label %899

895:                                              ; preds = %899, %887
  %896 = add nsw i64 %881, 1
  %897 = load ptr, ptr %20, align 8
  %898 = getelementptr inbounds i8, ptr %897, i64 80
  store i64 %896, ptr %898, align 8
  br label %911

899:                                              ; preds = %893, %899
  %900 = phi i64 [ 0, %893 ], [ %909, %899 ]
  %901 = load ptr, ptr %195, align 8
  %902 = getelementptr inbounds double, ptr %901, i64 %900
  %903 = load double, ptr %902, align 8
  %904 = load ptr, ptr %221, align 8
  %905 = add nsw i64 %900, %894
  %906 = getelementptr inbounds double, ptr %904, i64 %905
  store double %903, ptr %906, align 8
  %907 = load ptr, ptr %222, align 8
  %908 = getelementptr inbounds double, ptr %907, i64 %905
  store double %903, ptr %908, align 8
  %909 = add nuw nsw i64 %900, 1
  %910 = icmp eq i64 %909, %884
  br i1 %910, label %895, label %899, !llvm.loop !14

911:                                              ; preds = %878, %895
  %912 = getelementptr inbounds i64, ptr %16, i64 %874
  %913 = load i64, ptr %912, align 8
  %914 = sub nsw i64 0, %913
  store i64 %914, ptr %912, align 8
  br label %915

915:                                              ; preds = %873, %911
  %916 = add nuw nsw i64 %874, 1
  %917 = icmp eq i64 %916, %12
  br i1 %917, label %751, label %873, !llvm.loop !15

918:                                              ; preds = %818
  %919 = load ptr, ptr %20, align 8
  %920 = getelementptr inbounds i8, ptr %919, i64 80
  store i64 %23, ptr %920, align 8
  %921 = load ptr, ptr %19, align 8
  %922 = getelementptr inbounds i8, ptr %921, i64 48
  store double 1.000000e+00, ptr %922, align 8
  br label %942

923:                                              ; preds = %870, %834, %788, %767
  %924 = icmp sgt i64 %527, -1
  br i1 %924, label %925, label %934

925:                                              ; preds = %923
  br i1 %231, label %927, label %926

926:                                              ; preds = %927, %925
  store double %520, ptr %232, align 8
  br label %942

927:                                              ; preds = %925, %927
  %928 = phi i64 [ %932, %927 ], [ 0, %925 ]
  %929 = icmp eq i64 %928, %527
  %930 = zext i1 %929 to i64
  %931 = getelementptr inbounds i64, ptr %18, i64 %928
  store i64 %930, ptr %931, align 8
  %932 = add nuw nsw i64 %928, 1
  %933 = icmp eq i64 %932, %12
  br i1 %933, label %926, label %927, !llvm.loop !16

934:                                              ; preds = %923
  %935 = load i64, ptr %229, align 8
  %936 = icmp sgt i64 %935, 0
  br i1 %936, label %937, label %942

937:                                              ; preds = %934
  %938 = load i64, ptr %22, align 8
  %939 = add nsw i64 %938, %12
  %940 = icmp sgt i64 %939, %935
  br i1 %940, label %941, label %942

941:                                              ; preds = %937
  store double %520, ptr %230, align 8
  br label %942

942:                                              ; preds = %743, %707, %661, %640, %918, %926, %941, %746, %937, %934, %336, %517, %415
  %943 = phi i32 [ 1, %415 ], [ %519, %517 ], [ 11, %336 ], [ 1, %918 ], [ 1, %926 ], [ 1, %941 ], [ 1, %746 ], [ 0, %937 ], [ 0, %934 ], [ 1, %640 ], [ 1, %661 ], [ 1, %707 ], [ 1, %743 ]
  %944 = phi double [ %334, %415 ], [ %334, %517 ], [ %334, %336 ], [ %334, %918 ], [ %334, %926 ], [ %334, %941 ], [ %334, %746 ], [ %520, %937 ], [ %520, %934 ], [ %334, %640 ], [ %334, %661 ], [ %334, %707 ], [ %334, %743 ]
  %945 = phi i64 [ -4, %415 ], [ %521, %517 ], [ %335, %336 ], [ -4, %918 ], [ 21, %926 ], [ -3, %941 ], [ -4, %746 ], [ %521, %937 ], [ %521, %934 ], [ -2, %640 ], [ -2, %661 ], [ -2, %707 ], [ -2, %743 ]
  switch i32 %943, label %1003 [
    i32 0, label %333
    i32 11, label %946
  ], !llvm.loop !17

946:                                              ; preds = %942
  br i1 %233, label %947, label %1003

947:                                              ; preds = %946
  %948 = fcmp oeq double %331, %243
  %949 = add nsw i32 %240, -1
  %950 = sext i32 %949 to i64
  %951 = mul nsw i64 %12, %950
  %952 = getelementptr double, ptr %28, i64 %951
  %953 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %950
  %954 = fmul double %331, %2
  %955 = fadd double %954, %1
  br label %956

956:                                              ; preds = %947, %995
  %957 = phi i64 [ 0, %947 ], [ %996, %995 ]
  %958 = getelementptr inbounds double, ptr %332, i64 %957
  %959 = load double, ptr %958, align 8
  %960 = fcmp ogt double %959, 0.000000e+00
  br i1 %960, label %963, label %961

961:                                              ; preds = %956
  %962 = fcmp olt double %959, 0.000000e+00
  br i1 %962, label %963, label %966

963:                                              ; preds = %961, %956
  %964 = phi i64 [ 1, %956 ], [ -1, %961 ]
  %965 = getelementptr inbounds i64, ptr %16, i64 %957
  store i64 %964, ptr %965, align 8
  br label %966

966:                                              ; preds = %963, %961
  br i1 %948, label %967, label %995

967:                                              ; preds = %966
  %968 = getelementptr double, ptr %952, i64 %957
  %969 = load double, ptr %968, align 8
  %970 = fcmp oeq double %969, 0.000000e+00
  br i1 %970, label %971, label %995

971:                                              ; preds = %967
  %972 = getelementptr double, ptr %294, i64 %957
  %973 = load double, ptr %972, align 8
  %974 = fcmp oeq double %973, 0.000000e+00
  br i1 %974, label %975, label %995

975:                                              ; preds = %971
  %976 = load double, ptr %953, align 8
  %977 = fmul double %976, %2
  %978 = fadd double %977, %1
  %979 = load i64, ptr %234, align 8
  %980 = icmp eq i64 %979, 0
  br i1 %980, label %995, label %981

981:                                              ; preds = %975
  %982 = load ptr, ptr %235, align 8
  %983 = shl nsw i64 %957, 4
  %984 = getelementptr inbounds i8, ptr %982, i64 %983
  %985 = getelementptr inbounds i8, ptr %984, i64 8
  %986 = load double, ptr %985, align 8
  %987 = fcmp oeq double %986, %978
  br i1 %987, label %994, label %988

988:                                              ; preds = %981
  %989 = load double, ptr %984, align 8
  %990 = fsub double %986, %989
  %991 = fsub double %955, %978
  %992 = fcmp ult double %990, %991
  br i1 %992, label %993, label %995

993:                                              ; preds = %988
  store double %978, ptr %984, align 8
  br label %994

994:                                              ; preds = %981, %993
  store double %955, ptr %985, align 8
  br label %995

995:                                              ; preds = %994, %988, %975, %966, %967, %971
  %996 = add nuw nsw i64 %957, 1
  %997 = icmp eq i64 %996, %12
  br i1 %997, label %1003, label %956, !llvm.loop !18

998:                                              ; preds = %318, %290
  %999 = load ptr, ptr %20, align 8
  %1000 = getelementptr inbounds i8, ptr %999, i64 80
  store i64 %23, ptr %1000, align 8
  %1001 = load ptr, ptr %19, align 8
  %1002 = getelementptr inbounds i8, ptr %1001, i64 48
  store double 1.000000e+00, ptr %1002, align 8
  br label %1003

1003:                                             ; preds = %942, %995, %998, %946
  %1004 = phi i32 [ 0, %946 ], [ 1, %998 ], [ 0, %995 ], [ %943, %942 ]
  %1005 = phi double [ %331, %946 ], [ %239, %998 ], [ %331, %995 ], [ %944, %942 ]
  %1006 = phi i64 [ %945, %946 ], [ -4, %998 ], [ %945, %995 ], [ %945, %942 ]
  %1007 = icmp eq i32 %1004, 0
  br i1 %1007, label %1008, label %1013

1008:                                             ; preds = %1003
  %1009 = fcmp oeq double %1005, %243
  %1010 = zext i1 %1009 to i32
  %1011 = add nuw nsw i32 %240, %1010
  %1012 = icmp ugt i32 %1011, 4
  br i1 %1012, label %1013, label %236, !llvm.loop !19

1013:                                             ; preds = %1008, %1003
  %1014 = phi i1 [ %1012, %1008 ], [ %237, %1003 ]
  br i1 %1014, label %1015, label %1033

1015:                                             ; preds = %1013
  %1016 = icmp sgt i64 %12, 0
  br i1 %1016, label %1017, label %1020

1017:                                             ; preds = %1015
  %1018 = shl i64 %12, 5
  %1019 = getelementptr i8, ptr %28, i64 %1018
  br label %1022

1020:                                             ; preds = %1022, %1015
  %1021 = load double, ptr %24, align 8
  store double %1021, ptr %30, align 8
  br label %1029

1022:                                             ; preds = %1017, %1022
  %1023 = phi i64 [ 0, %1017 ], [ %1027, %1022 ]
  %1024 = getelementptr double, ptr %1019, i64 %1023
  %1025 = load double, ptr %1024, align 8
  %1026 = getelementptr inbounds double, ptr %28, i64 %1023
  store double %1025, ptr %1026, align 8
  %1027 = add nuw nsw i64 %1023, 1
  %1028 = icmp eq i64 %1027, %12
  br i1 %1028, label %1020, label %1022, !llvm.loop !20

1029:                                             ; preds = %119, %1020, %177, %92
  %1030 = phi ptr [ %95, %92 ], [ %180, %177 ], [ %24, %1020 ], [ %122, %119 ]
  %1031 = phi i64 [ -4, %92 ], [ -4, %177 ], [ 0, %1020 ], [ -4, %119 ]
  %1032 = getelementptr inbounds i8, ptr %1030, i64 48
  store double 1.000000e+00, ptr %1032, align 8
  br label %1033

1033:                                             ; preds = %1029, %1013, %100
  %1034 = phi i64 [ %1006, %1013 ], [ %101, %100 ], [ %1031, %1029 ]
  ret i64 %1034
}



define internal fastcc i64 @resolve(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3) unnamed_addr #2 {
  %5 = alloca [9 x double], align 16
  %6 = getelementptr inbounds i8, ptr %0, i64 768
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 672
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 680
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr double, ptr %11, i64 %13
  %15 = getelementptr i8, ptr %14, i64 -8
  %16 = load double, ptr %15, align 8
  %17 = load double, ptr %11, align 8
  %18 = fsub double %16, %17
  %19 = fadd double %2, %3
  %20 = tail call double @llvm.fabs.f64(double %19)
  %21 = fcmp ogt double %20, %18
  %22 = select i1 %21, double %20, double %18
  %23 = fmul double %22, 0x3D10000000000000
  %24 = fcmp ult double %23, %3
  %25 = icmp sgt i64 %9, 0
  %26 = select i1 %24, i1 %25, i1 false
  br i1 %26, label %27, label %353

27:                                               ; preds = %4
  %28 = getelementptr inbounds i8, ptr %0, i64 984
  %29 = shl nsw i64 %9, 4
  %30 = mul i64 %9, 40
  %31 = getelementptr inbounds i8, ptr %0, i64 864
  %32 = getelementptr inbounds i8, ptr %0, i64 1032
  %33 = getelementptr inbounds i8, ptr %1, i64 16
  %34 = getelementptr inbounds i8, ptr %1, i64 8
  %35 = getelementptr inbounds i8, ptr %0, i64 168
  %36 = getelementptr inbounds i8, ptr %0, i64 248
  %37 = getelementptr inbounds i8, ptr %0, i64 144
  %38 = getelementptr inbounds i8, ptr %0, i64 168
  %39 = getelementptr inbounds i8, ptr %0, i64 192
  %40 = getelementptr inbounds i8, ptr %0, i64 792
  %41 = getelementptr inbounds i8, ptr %0, i64 144
  %42 = getelementptr inbounds i8, ptr %0, i64 1032
  %43 = getelementptr inbounds i8, ptr %1, i64 16
  %44 = getelementptr inbounds i8, ptr %1, i64 8
  %45 = getelementptr inbounds i8, ptr %0, i64 600
  %46 = getelementptr inbounds i8, ptr %0, i64 576
  %47 = getelementptr inbounds i8, ptr %0, i64 168
  %48 = getelementptr inbounds i8, ptr %0, i64 248
  %49 = getelementptr inbounds i8, ptr %0, i64 168
  %50 = getelementptr inbounds i8, ptr %0, i64 192
  %51 = getelementptr inbounds i8, ptr %0, i64 792
  %52 = shl nsw i64 %9, 5
  br label %53

53:                                               ; preds = %27, %350
  %54 = phi i64 [ undef, %27 ], [ %349, %350 ]
  %55 = phi i32 [ 0, %27 ], [ %348, %350 ]
  %56 = phi i32 [ 0, %27 ], [ %347, %350 ]
  %57 = phi i64 [ 0, %27 ], [ %351, %350 ]
  %58 = load ptr, ptr %28, align 8
  %59 = getelementptr inbounds i8, ptr %58, i64 %29
  %60 = getelementptr inbounds double, ptr %59, i64 %57
  %61 = getelementptr inbounds i8, ptr %60, i64 %30
  %62 = load ptr, ptr %31, align 8
  %63 = getelementptr inbounds i64, ptr %62, i64 %57
  %64 = load i64, ptr %63, align 8
  %65 = and i64 %64, 1
  %66 = icmp eq i64 %65, 0
  br i1 %66, label %67, label %345

67:                                               ; preds = %53
  %68 = load double, ptr %60, align 8
  br label %72

69:                                               ; preds = %72
  %70 = fmul double %80, %82
  %71 = fcmp ugt double %70, 0.000000e+00
  br i1 %71, label %85, label %94

72:                                               ; preds = %67, %72
  %73 = phi i64 [ 1, %67 ], [ %83, %72 ]
  %74 = phi double [ %68, %67 ], [ %82, %72 ]
  %75 = phi double [ %68, %67 ], [ %80, %72 ]
  %76 = mul nuw nsw i64 %9, %73
  %77 = getelementptr inbounds double, ptr %60, i64 %76
  %78 = load double, ptr %77, align 8
  %79 = fcmp olt double %75, %78
  %80 = select i1 %79, double %75, double %78
  %81 = fcmp ogt double %74, %78
  %82 = select i1 %81, double %74, double %78
  %83 = add nuw nsw i64 %73, 1
  %84 = icmp eq i64 %83, 5
  br i1 %84, label %69, label %72, !llvm.loop !21

85:                                               ; preds = %69
  %86 = tail call double @llvm.fabs.f64(double %80)
  %87 = tail call double @llvm.fabs.f64(double %82)
  %88 = fcmp olt double %86, %87
  %89 = select i1 %88, double %86, double %87
  %90 = fsub double %82, %80
  %91 = fmul double %90, 4.000000e+00
  %92 = fcmp ole double %89, %91
  %93 = zext i1 %92 to i32
  br label %94

94:                                               ; preds = %69, %85
  %95 = phi i32 [ 1, %69 ], [ %93, %85 ]
  %96 = icmp eq i32 %95, 0
  br i1 %96, label %345, label %97

97:                                               ; preds = %94
  %98 = sext i32 %55 to i64
  br label %99

99:                                               ; preds = %97, %137
  %100 = phi i64 [ %98, %97 ], [ %105, %137 ]
  %101 = icmp slt i64 %100, 4
  br i1 %101, label %102, label %153

102:                                              ; preds = %99
  %103 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %100
  %104 = load double, ptr %103, align 8
  %105 = add nsw i64 %100, 1
  %106 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %105
  %107 = load double, ptr %106, align 8
  %108 = fadd double %104, %107
  %109 = fmul double %108, 5.000000e-01
  %110 = add nsw i64 %100, 7
  %111 = load ptr, ptr %32, align 8
  %112 = load ptr, ptr %33, align 8
  %113 = getelementptr inbounds i8, ptr %112, i64 96
  %114 = load ptr, ptr %113, align 8
  %115 = insertelement <8 x double> poison, double %109, i64 0
  %116 = shufflevector <8 x double> %115, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %116, ptr %114, align 8
  %117 = load ptr, ptr %112, align 8
  %118 = getelementptr inbounds i8, ptr %112, i64 192
  %119 = load ptr, ptr %118, align 8
  %120 = getelementptr inbounds i8, ptr %112, i64 8
  %121 = load i64, ptr %120, align 8
  %122 = load ptr, ptr %1, align 8
  %123 = load ptr, ptr %122, align 8
  %124 = getelementptr inbounds i8, ptr %123, i64 24
  %125 = load i64, ptr %124, align 8
  %126 = load ptr, ptr %113, align 8
  %127 = load ptr, ptr %34, align 8
  %128 = load ptr, ptr %127, align 8
  %129 = getelementptr inbounds i8, ptr %128, i64 16
  %130 = load i64, ptr %129, align 8
  tail call fastcc void @nested(ptr noundef %111, ptr noundef %117, ptr noundef %119, i64 noundef %121, i64 noundef %125, ptr noundef %126, i64 noundef %130) #8
  %131 = fmul double %109, %3
  %132 = fadd double %131, %2
  %133 = load ptr, ptr %35, align 8
  store double %132, ptr %133, align 8
  %134 = load i64, ptr %36, align 8
  %135 = icmp sgt i64 %134, 0
  br i1 %135, label %136, label %137

136:                                              ; preds = %102
  tail call fastcc void @sample(ptr noundef nonnull %37) #8
  br label %137

137:                                              ; preds = %102, %136
  %138 = load ptr, ptr %6, align 8
  %139 = load i64, ptr %138, align 8
  %140 = load ptr, ptr %38, align 8
  %141 = load ptr, ptr %32, align 8
  %142 = load ptr, ptr %39, align 8
  %143 = load ptr, ptr %40, align 8
  %144 = load ptr, ptr %28, align 8
  %145 = getelementptr inbounds i8, ptr %138, i64 8
  %146 = load i64, ptr %145, align 8
  %147 = mul nsw i64 %146, %110
  %148 = getelementptr inbounds double, ptr %144, i64 %147
  %149 = inttoptr i64 %139 to ptr
  %150 = load ptr, ptr %149, align 8
  %151 = tail call i32 %150(ptr noundef %140, ptr noundef %141, ptr noundef %142, ptr noundef %143, ptr noundef %148) #9
  %152 = icmp slt i32 %151, 0
  br i1 %152, label %343, label %99, !llvm.loop !22

153:                                              ; preds = %99
  %154 = load double, ptr %60, align 8
  %155 = tail call double @llvm.fabs.f64(double %154)
  store double %154, ptr %5, align 16
  br label %163

156:                                              ; preds = %213
  %157 = trunc nsw i64 %100 to i32
  %158 = fmul double %224, 0x3E50000000000000
  %159 = fcmp ogt double %218, %158
  br i1 %159, label %160, label %339

160:                                              ; preds = %156
  %161 = fmul double %218, 2.000000e+00
  %162 = fmul double %218, 8.000000e+00
  br label %226

163:                                              ; preds = %153, %213
  %164 = phi i64 [ 0, %153 ], [ %173, %213 ]
  %165 = phi double [ 0.000000e+00, %153 ], [ %218, %213 ]
  %166 = phi double [ %155, %153 ], [ %224, %213 ]
  %167 = mul nuw nsw i64 %9, %164
  %168 = getelementptr inbounds double, ptr %61, i64 %167
  %169 = load double, ptr %168, align 8
  %170 = shl nuw nsw i64 %164, 1
  %171 = or disjoint i64 %170, 1
  %172 = getelementptr inbounds [9 x double], ptr %5, i64 0, i64 %171
  store double %169, ptr %172, align 8
  %173 = add nuw nsw i64 %164, 1
  %174 = mul nuw nsw i64 %9, %173
  %175 = getelementptr inbounds double, ptr %60, i64 %174
  %176 = load double, ptr %175, align 8
  %177 = add nuw nsw i64 %170, 2
  %178 = getelementptr inbounds [9 x double], ptr %5, i64 0, i64 %177
  store double %176, ptr %178, align 16
  %179 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %164
  %180 = load double, ptr %179, align 8
  %181 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %173
  %182 = load double, ptr %181, align 8
  %183 = fadd double %180, %182
  %184 = fmul double %183, 5.000000e-01
  br label %185

185:                                              ; preds = %163, %189
  %186 = phi i64 [ 0, %163 ], [ %195, %189 ]
  %187 = phi double [ 0.000000e+00, %163 ], [ %194, %189 ]
  %188 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %186
  br label %197

189:                                              ; preds = %208
  %190 = mul nuw nsw i64 %9, %186
  %191 = getelementptr inbounds double, ptr %60, i64 %190
  %192 = load double, ptr %191, align 8
  %193 = fmul double %210, %192
  %194 = fadd double %187, %193
  %195 = add nuw nsw i64 %186, 1
  %196 = icmp eq i64 %195, 5
  br i1 %196, label %213, label %185, !llvm.loop !23

197:                                              ; preds = %185, %208
  %198 = phi i64 [ 0, %185 ], [ %211, %208 ]
  %199 = phi double [ 1.000000e+00, %185 ], [ %210, %208 ]
  %200 = icmp eq i64 %198, %186
  br i1 %200, label %208, label %201

201:                                              ; preds = %197
  %202 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %198
  %203 = load double, ptr %202, align 8
  %204 = fsub double %184, %203
  %205 = load double, ptr %188, align 8
  %206 = fsub double %205, %203
  %207 = fdiv double %204, %206
  br label %208

208:                                              ; preds = %201, %197
  %209 = phi double [ %207, %201 ], [ 1.000000e+00, %197 ]
  %210 = fmul double %199, %209
  %211 = add nuw nsw i64 %198, 1
  %212 = icmp eq i64 %211, 5
  br i1 %212, label %189, label %197, !llvm.loop !24

213:                                              ; preds = %189
  %214 = fsub double %169, %194
  %215 = tail call double @llvm.fabs.f64(double %214)
  %216 = fmul double %215, 2.000000e+00
  %217 = fcmp ogt double %165, %216
  %218 = select i1 %217, double %165, double %216
  %219 = tail call double @llvm.fabs.f64(double %169)
  %220 = tail call double @llvm.fabs.f64(double %176)
  %221 = fcmp ogt double %219, %220
  %222 = select i1 %221, double %219, double %220
  %223 = fcmp ogt double %166, %222
  %224 = select i1 %223, double %166, double %222
  %225 = icmp eq i64 %173, 4
  br i1 %225, label %156, label %163, !llvm.loop !25

226:                                              ; preds = %160, %247
  %227 = phi i64 [ 1, %160 ], [ %248, %247 ]
  %228 = phi i1 [ false, %160 ], [ %249, %247 ]
  %229 = getelementptr double, ptr %5, i64 %227
  %230 = getelementptr i8, ptr %229, i64 -8
  %231 = load double, ptr %230, align 8
  %232 = load double, ptr %229, align 8
  %233 = fsub double %231, %232
  %234 = tail call double @llvm.fabs.f64(double %233)
  %235 = fmul double %231, %232
  %236 = fcmp olt double %235, 0.000000e+00
  br i1 %236, label %237, label %239

237:                                              ; preds = %226
  %238 = fcmp olt double %234, %162
  br i1 %238, label %251, label %247

239:                                              ; preds = %226
  %240 = tail call double @llvm.fabs.f64(double %232)
  %241 = tail call double @llvm.fabs.f64(double %231)
  %242 = fcmp olt double %241, %240
  %243 = select i1 %242, double %241, double %240
  %244 = fcmp ugt double %243, %218
  %245 = fcmp ugt double %234, %161
  %246 = or i1 %245, %244
  br i1 %246, label %247, label %251

247:                                              ; preds = %239, %237
  %248 = add nuw nsw i64 %227, 1
  %249 = icmp ugt i64 %227, 7
  %250 = icmp eq i64 %248, 9
  br i1 %250, label %339, label %226, !llvm.loop !26

251:                                              ; preds = %237, %239
  br i1 %228, label %339, label %252

252:                                              ; preds = %251, %312
  %253 = phi i32 [ 1, %312 ], [ %56, %251 ]
  %254 = icmp eq i32 %253, 0
  br i1 %254, label %255, label %327

255:                                              ; preds = %252
  %256 = load ptr, ptr %42, align 8
  %257 = load ptr, ptr %43, align 8
  %258 = getelementptr inbounds i8, ptr %257, i64 96
  %259 = load ptr, ptr %258, align 8
  store <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, ptr %259, align 8
  %260 = load ptr, ptr %257, align 8
  %261 = getelementptr inbounds i8, ptr %257, i64 192
  %262 = load ptr, ptr %261, align 8
  %263 = getelementptr inbounds i8, ptr %257, i64 8
  %264 = load i64, ptr %263, align 8
  %265 = load ptr, ptr %1, align 8
  %266 = load ptr, ptr %265, align 8
  %267 = getelementptr inbounds i8, ptr %266, i64 24
  %268 = load i64, ptr %267, align 8
  %269 = load ptr, ptr %258, align 8
  %270 = load ptr, ptr %44, align 8
  %271 = load ptr, ptr %270, align 8
  %272 = getelementptr inbounds i8, ptr %271, i64 16
  %273 = load i64, ptr %272, align 8
  tail call fastcc void @nested(ptr noundef %256, ptr noundef %260, ptr noundef %262, i64 noundef %264, i64 noundef %268, ptr noundef %269, i64 noundef %273) #8
  %274 = load ptr, ptr %41, align 8
  %275 = getelementptr inbounds i8, ptr %274, i64 8
  %276 = load i64, ptr %275, align 8
  %277 = icmp sgt i64 %276, 0
  br i1 %277, label %283, label %278

278:                                              ; preds = %283, %255
  %279 = load ptr, ptr %47, align 8
  store double %19, ptr %279, align 8
  %280 = load i64, ptr %48, align 8
  %281 = icmp sgt i64 %280, 0
  br i1 %281, label %282, label %312

282:                                              ; preds = %278
  tail call fastcc void @sample(ptr noundef nonnull %41) #8
  br label %312

283:                                              ; preds = %255, %283
  %284 = phi i64 [ %307, %283 ], [ 0, %255 ]
  %285 = load ptr, ptr %45, align 8
  %286 = getelementptr inbounds double, ptr %285, i64 %284
  %287 = load double, ptr %286, align 8
  %288 = load ptr, ptr %46, align 8
  %289 = getelementptr inbounds double, ptr %288, i64 %284
  %290 = load double, ptr %289, align 8
  %291 = load ptr, ptr %42, align 8
  %292 = getelementptr inbounds double, ptr %291, i64 %284
  %293 = load double, ptr %292, align 8
  %294 = tail call double @llvm.fabs.f64(double %293)
  %295 = fmul double %290, %294
  %296 = fadd double %287, %295
  %297 = and i64 %284, 1
  %298 = icmp eq i64 %297, 0
  %299 = urem i64 %284, 3
  %300 = uitofp nneg i64 %299 to double
  %301 = fmul double %300, 0x3FE3C6EF372FE950
  %302 = fadd double %301, 1.000000e+00
  %303 = fneg double %302
  %304 = select i1 %298, double %302, double %303
  %305 = fmul double %304, %296
  %306 = fadd double %293, %305
  store double %306, ptr %292, align 8
  %307 = add nuw nsw i64 %284, 1
  %308 = load ptr, ptr %41, align 8
  %309 = getelementptr inbounds i8, ptr %308, i64 8
  %310 = load i64, ptr %309, align 8
  %311 = icmp slt i64 %307, %310
  br i1 %311, label %283, label %278, !llvm.loop !27

312:                                              ; preds = %278, %282
  %313 = load ptr, ptr %6, align 8
  %314 = load i64, ptr %313, align 8
  %315 = load ptr, ptr %49, align 8
  %316 = load ptr, ptr %42, align 8
  %317 = load ptr, ptr %50, align 8
  %318 = load ptr, ptr %51, align 8
  %319 = load ptr, ptr %28, align 8
  %320 = getelementptr inbounds i8, ptr %313, i64 8
  %321 = load i64, ptr %320, align 8
  %322 = getelementptr inbounds double, ptr %319, i64 %321
  %323 = inttoptr i64 %314 to ptr
  %324 = load ptr, ptr %323, align 8
  %325 = tail call i32 %324(ptr noundef %315, ptr noundef %316, ptr noundef %317, ptr noundef %318, ptr noundef %322) #9
  %326 = icmp slt i32 %325, 0
  br i1 %326, label %339, label %252, !llvm.loop !28

327:                                              ; preds = %252
  %328 = load ptr, ptr %28, align 8
  %329 = getelementptr double, ptr %328, i64 %9
  %330 = getelementptr double, ptr %329, i64 %57
  %331 = load double, ptr %330, align 8
  %332 = getelementptr inbounds i8, ptr %60, i64 %52
  %333 = load double, ptr %332, align 8
  %334 = fsub double %331, %333
  %335 = tail call double @llvm.fabs.f64(double %334)
  %336 = fcmp ogt double %218, %335
  %337 = zext i1 %336 to i32
  %338 = select i1 %336, i64 -6, i64 %54
  br label %339

339:                                              ; preds = %247, %312, %327, %156, %251
  %340 = phi i32 [ 4, %251 ], [ 4, %156 ], [ %337, %327 ], [ 1, %312 ], [ 4, %247 ]
  %341 = phi i32 [ %56, %251 ], [ %56, %156 ], [ %253, %327 ], [ %253, %312 ], [ %56, %247 ]
  %342 = phi i64 [ %54, %251 ], [ %54, %156 ], [ %338, %327 ], [ -4, %312 ], [ %54, %247 ]
  br label %345

343:                                              ; preds = %137
  %344 = trunc nsw i64 %100 to i32
  br label %345

345:                                              ; preds = %343, %53, %94, %339
  %346 = phi i32 [ %340, %339 ], [ 4, %94 ], [ 4, %53 ], [ 1, %343 ]
  %347 = phi i32 [ %341, %339 ], [ %56, %94 ], [ %56, %53 ], [ %56, %343 ]
  %348 = phi i32 [ %157, %339 ], [ %55, %94 ], [ %55, %53 ], [ %344, %343 ]
  %349 = phi i64 [ %342, %339 ], [ %54, %94 ], [ %54, %53 ], [ -4, %343 ]
  switch i32 %346, label %353 [
    i32 0, label %350
    i32 4, label %350
  ]

350:                                              ; preds = %345, %345
  %351 = add nuw nsw i64 %57, 1
  %352 = icmp eq i64 %351, %9
  br i1 %352, label %353, label %53, !llvm.loop !29

353:                                              ; preds = %350, %345, %4
  %354 = phi i64 [ 0, %4 ], [ %349, %345 ], [ 0, %350 ]
  ret i64 %354
}

define internal fastcc double @locate(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, double noundef %4, double noundef %5, i64 noundef %6) unnamed_addr #2 {
  %8 = getelementptr inbounds i8, ptr %0, i64 768
  %9 = getelementptr inbounds i8, ptr %0, i64 936
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i64, ptr %10, i64 %6
  %12 = load i64, ptr %11, align 8
  %13 = sitofp i64 %12 to double
  %14 = getelementptr inbounds i8, ptr %0, i64 984
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
  %29 = getelementptr inbounds i8, ptr %0, i64 1032
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
  tail call fastcc void @nested(ptr noundef %30, ptr noundef %37, ptr noundef %39, i64 noundef %41, i64 noundef %45, ptr noundef %46, i64 noundef %51) #8
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
  tail call fastcc void @sample(ptr noundef nonnull %28) #8
  br label %60

60:                                               ; preds = %7, %59
  %61 = load ptr, ptr %8, align 8
  %62 = load i64, ptr %61, align 8
  %63 = getelementptr inbounds i8, ptr %0, i64 168
  %64 = load ptr, ptr %63, align 8
  %65 = load ptr, ptr %29, align 8
  %66 = getelementptr inbounds i8, ptr %0, i64 192
  %67 = load ptr, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %0, i64 792
  %69 = load ptr, ptr %68, align 8
  %70 = load ptr, ptr %14, align 8
  %71 = getelementptr inbounds i8, ptr %61, i64 8
  %72 = load i64, ptr %71, align 8
  %73 = getelementptr inbounds double, ptr %70, i64 %72
  %74 = inttoptr i64 %62 to ptr
  %75 = load ptr, ptr %74, align 8
  %76 = tail call i32 %75(ptr noundef %64, ptr noundef %65, ptr noundef %67, ptr noundef %69, ptr noundef %73) #9
  %77 = load double, ptr %20, align 8
  %78 = fmul double %77, %13
  %79 = fcmp ugt double %78, 0.000000e+00
  br i1 %79, label %133, label %80

80:                                               ; preds = %60, %114
  %81 = phi double [ %84, %114 ], [ %5, %60 ]
  %82 = fsub double %81, %4
  %83 = fmul double %82, 5.000000e-01
  %84 = fadd double %83, %4
  %85 = fsub double %84, %4
  %86 = fcmp uge double %85, %27
  br i1 %86, label %87, label %131

87:                                               ; preds = %80
  %88 = load ptr, ptr %29, align 8
  %89 = load ptr, ptr %31, align 8
  %90 = getelementptr inbounds i8, ptr %89, i64 96
  %91 = load ptr, ptr %90, align 8
  %92 = insertelement <8 x double> poison, double %84, i64 0
  %93 = shufflevector <8 x double> %92, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %93, ptr %91, align 8
  %94 = load ptr, ptr %89, align 8
  %95 = getelementptr inbounds i8, ptr %89, i64 192
  %96 = load ptr, ptr %95, align 8
  %97 = getelementptr inbounds i8, ptr %89, i64 8
  %98 = load i64, ptr %97, align 8
  %99 = load ptr, ptr %1, align 8
  %100 = load ptr, ptr %99, align 8
  %101 = getelementptr inbounds i8, ptr %100, i64 24
  %102 = load i64, ptr %101, align 8
  %103 = load ptr, ptr %90, align 8
  %104 = load ptr, ptr %47, align 8
  %105 = load ptr, ptr %104, align 8
  %106 = getelementptr inbounds i8, ptr %105, i64 16
  %107 = load i64, ptr %106, align 8
  tail call fastcc void @nested(ptr noundef %88, ptr noundef %94, ptr noundef %96, i64 noundef %98, i64 noundef %102, ptr noundef %103, i64 noundef %107) #8
  %108 = fmul double %84, %3
  %109 = fadd double %108, %2
  %110 = load ptr, ptr %54, align 8
  store double %109, ptr %110, align 8
  %111 = load i64, ptr %56, align 8
  %112 = icmp sgt i64 %111, 0
  br i1 %112, label %113, label %114

113:                                              ; preds = %87
  tail call fastcc void @sample(ptr noundef nonnull %28) #8
  br label %114

114:                                              ; preds = %87, %113
  %115 = load ptr, ptr %8, align 8
  %116 = load i64, ptr %115, align 8
  %117 = load ptr, ptr %63, align 8
  %118 = load ptr, ptr %29, align 8
  %119 = load ptr, ptr %66, align 8
  %120 = load ptr, ptr %68, align 8
  %121 = load ptr, ptr %14, align 8
  %122 = getelementptr inbounds i8, ptr %115, i64 8
  %123 = load i64, ptr %122, align 8
  %124 = getelementptr inbounds double, ptr %121, i64 %123
  %125 = inttoptr i64 %116 to ptr
  %126 = load ptr, ptr %125, align 8
  %127 = tail call i32 %126(ptr noundef %117, ptr noundef %118, ptr noundef %119, ptr noundef %120, ptr noundef %124) #9
  %128 = load double, ptr %20, align 8
  %129 = fmul double %128, %13
  %130 = fcmp ogt double %129, 0.000000e+00
  br i1 %130, label %131, label %80, !llvm.loop !30

131:                                              ; preds = %114, %80
  %132 = phi double [ %4, %80 ], [ %84, %114 ]
  br i1 %86, label %133, label %196

133:                                              ; preds = %131, %60
  %134 = phi double [ %5, %60 ], [ %81, %131 ]
  %135 = phi double [ %4, %60 ], [ %132, %131 ]
  br label %136

136:                                              ; preds = %133, %193
  %137 = phi double [ %194, %193 ], [ %134, %133 ]
  %138 = phi double [ %195, %193 ], [ %135, %133 ]
  %139 = fsub double %137, %138
  %140 = fcmp ogt double %139, %27
  br i1 %140, label %141, label %196

141:                                              ; preds = %136
  %142 = fmul double %139, 5.000000e-01
  %143 = fadd double %138, %142
  %144 = fcmp une double %143, %138
  %145 = fcmp une double %143, %137
  %146 = and i1 %144, %145
  br i1 %146, label %147, label %193

147:                                              ; preds = %141
  %148 = load ptr, ptr %29, align 8
  %149 = load ptr, ptr %31, align 8
  %150 = getelementptr inbounds i8, ptr %149, i64 96
  %151 = load ptr, ptr %150, align 8
  %152 = insertelement <8 x double> poison, double %143, i64 0
  %153 = shufflevector <8 x double> %152, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %153, ptr %151, align 8
  %154 = load ptr, ptr %149, align 8
  %155 = getelementptr inbounds i8, ptr %149, i64 192
  %156 = load ptr, ptr %155, align 8
  %157 = getelementptr inbounds i8, ptr %149, i64 8
  %158 = load i64, ptr %157, align 8
  %159 = load ptr, ptr %1, align 8
  %160 = load ptr, ptr %159, align 8
  %161 = getelementptr inbounds i8, ptr %160, i64 24
  %162 = load i64, ptr %161, align 8
  %163 = load ptr, ptr %150, align 8
  %164 = load ptr, ptr %47, align 8
  %165 = load ptr, ptr %164, align 8
  %166 = getelementptr inbounds i8, ptr %165, i64 16
  %167 = load i64, ptr %166, align 8
  tail call fastcc void @nested(ptr noundef %148, ptr noundef %154, ptr noundef %156, i64 noundef %158, i64 noundef %162, ptr noundef %163, i64 noundef %167) #8
  %168 = fmul double %143, %3
  %169 = fadd double %168, %2
  %170 = load ptr, ptr %54, align 8
  store double %169, ptr %170, align 8
  %171 = load i64, ptr %56, align 8
  %172 = icmp sgt i64 %171, 0
  br i1 %172, label %173, label %174

173:                                              ; preds = %147
  tail call fastcc void @sample(ptr noundef nonnull %28) #8
  br label %174

174:                                              ; preds = %147, %173
  %175 = load ptr, ptr %8, align 8
  %176 = load i64, ptr %175, align 8
  %177 = load ptr, ptr %63, align 8
  %178 = load ptr, ptr %29, align 8
  %179 = load ptr, ptr %66, align 8
  %180 = load ptr, ptr %68, align 8
  %181 = load ptr, ptr %14, align 8
  %182 = getelementptr inbounds i8, ptr %175, i64 8
  %183 = load i64, ptr %182, align 8
  %184 = getelementptr inbounds double, ptr %181, i64 %183
  %185 = inttoptr i64 %176 to ptr
  %186 = load ptr, ptr %185, align 8
  %187 = tail call i32 %186(ptr noundef %177, ptr noundef %178, ptr noundef %179, ptr noundef %180, ptr noundef %184) #9
  %188 = load double, ptr %20, align 8
  %189 = fmul double %188, %13
  %190 = fcmp ogt double %189, 0.000000e+00
  %191 = select i1 %190, double %137, double %143
  %192 = select i1 %190, double %143, double %138
  br label %193

193:                                              ; preds = %141, %174
  %194 = phi double [ %191, %174 ], [ %137, %141 ]
  %195 = phi double [ %192, %174 ], [ %138, %141 ]
  br i1 %146, label %136, label %196

196:                                              ; preds = %136, %193, %131
  %197 = phi double [ %4, %131 ], [ %194, %193 ], [ %137, %136 ]
  ret double %197
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
  br i1 %31, label %20, label %19, !llvm.loop !31

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
  br i1 %43, label %32, label %24, !llvm.loop !32
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #4

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #5 {
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

declare double @llvm.fabs.f64(double) #4

define internal fastcc double @least_place(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, i64 noundef %4, double noundef %5, i32 noundef %6, i32 noundef %7) unnamed_addr #2 {
  %9 = getelementptr inbounds i8, ptr %0, i64 768
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 984
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds double, ptr %14, i64 %4
  %16 = add nsw i32 %6, 2
  %17 = sext i32 %16 to i64
  %18 = mul nsw i64 %12, %17
  %19 = getelementptr inbounds double, ptr %14, i64 %18
  %20 = getelementptr inbounds double, ptr %19, i64 %4
  %21 = sub nsw i64 0, %12
  %22 = getelementptr inbounds double, ptr %20, i64 %21
  %23 = load double, ptr %22, align 8
  %24 = fmul double %23, %5
  %25 = load double, ptr %20, align 8
  %26 = fmul double %25, %5
  %27 = getelementptr inbounds double, ptr %20, i64 %12
  %28 = load double, ptr %27, align 8
  %29 = fmul double %28, %5
  %30 = fcmp ogt double %24, 0.000000e+00
  %31 = fcmp ogt double %26, 0.000000e+00
  %32 = and i1 %30, %31
  %33 = fcmp ogt double %29, 0.000000e+00
  %34 = and i1 %32, %33
  br i1 %34, label %35, label %211

35:                                               ; preds = %8
  %36 = fcmp ogt double %26, %29
  %37 = select i1 %36, double %26, double %29
  %38 = fcmp ogt double %24, %37
  %39 = select i1 %38, double %24, double %37
  %40 = add nsw i32 %6, 1
  %41 = sext i32 %40 to i64
  %42 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %41
  %43 = load double, ptr %42, align 8
  %44 = sext i32 %6 to i64
  %45 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = add nsw i32 %6, -1
  %48 = sext i32 %47 to i64
  %49 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = icmp sgt i32 %7, 1
  %52 = add nsw i32 %7, -1
  %53 = zext nneg i32 %52 to i64
  %54 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %53
  %55 = icmp slt i32 %7, 4
  %56 = sext i32 %7 to i64
  %57 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %56
  %58 = getelementptr inbounds i8, ptr %0, i64 1032
  %59 = getelementptr inbounds i8, ptr %1, i64 16
  %60 = getelementptr inbounds i8, ptr %1, i64 8
  %61 = getelementptr inbounds i8, ptr %0, i64 168
  %62 = getelementptr inbounds i8, ptr %0, i64 248
  %63 = getelementptr inbounds i8, ptr %0, i64 144
  %64 = getelementptr inbounds i8, ptr %0, i64 168
  %65 = getelementptr inbounds i8, ptr %0, i64 192
  %66 = getelementptr inbounds i8, ptr %0, i64 792
  %67 = fmul double %39, 0xBCE0000000000000
  br label %72

68:                                               ; preds = %198
  %69 = add nuw nsw i32 %82, 1
  %70 = icmp ugt i32 %82, 18
  %71 = icmp eq i32 %69, 20
  br i1 %71, label %208, label %72, !llvm.loop !35

72:                                               ; preds = %35, %68
  %73 = phi i1 [ false, %35 ], [ %70, %68 ]
  %74 = phi double [ undef, %35 ], [ %207, %68 ]
  %75 = phi double [ %50, %35 ], [ %206, %68 ]
  %76 = phi double [ %46, %35 ], [ %205, %68 ]
  %77 = phi double [ %43, %35 ], [ %204, %68 ]
  %78 = phi double [ 0x7FF0000000000000, %35 ], [ %203, %68 ]
  %79 = phi double [ %24, %35 ], [ %202, %68 ]
  %80 = phi double [ %26, %35 ], [ %201, %68 ]
  %81 = phi double [ %29, %35 ], [ %200, %68 ]
  %82 = phi i32 [ 0, %35 ], [ %69, %68 ]
  %83 = fsub double %80, %79
  %84 = fsub double %76, %75
  %85 = fdiv double %83, %84
  %86 = fsub double %81, %80
  %87 = fsub double %77, %76
  %88 = fdiv double %86, %87
  %89 = fsub double %88, %85
  %90 = fsub double %77, %75
  %91 = fdiv double %89, %90
  %92 = fmul double %84, %91
  %93 = fadd double %85, %92
  %94 = fmul double %93, 5.000000e-01
  %95 = fdiv double %94, %91
  %96 = fsub double %76, %95
  %97 = fcmp ogt double %91, 0.000000e+00
  br i1 %97, label %98, label %198

98:                                               ; preds = %72
  %99 = fsub double %96, %76
  %100 = fmul double %94, %99
  %101 = fadd double %80, %100
  %102 = fmul double %78, 2.000000e+00
  %103 = fcmp ugt double %101, %102
  br i1 %103, label %198, label %104

104:                                              ; preds = %98
  br i1 %51, label %105, label %107

105:                                              ; preds = %104
  %106 = load double, ptr %54, align 8
  br label %107

107:                                              ; preds = %104, %105
  %108 = phi double [ %106, %105 ], [ 0xBFCE3779B97F4A7C, %104 ]
  br i1 %55, label %109, label %111

109:                                              ; preds = %107
  %110 = load double, ptr %57, align 8
  br label %111

111:                                              ; preds = %107, %109
  %112 = phi double [ %110, %109 ], [ 0x3FF4498517A7B356, %107 ]
  %113 = icmp eq i32 %82, 0
  br i1 %113, label %114, label %118

114:                                              ; preds = %111
  %115 = fcmp ult double %96, %108
  %116 = fcmp ugt double %96, %112
  %117 = select i1 %115, i1 true, i1 %116
  br i1 %117, label %198, label %118

118:                                              ; preds = %114, %111
  %119 = fcmp ugt double %96, %75
  br i1 %119, label %120, label %122

120:                                              ; preds = %118
  %121 = fcmp ult double %96, %77
  br i1 %121, label %126, label %122

122:                                              ; preds = %120, %118
  %123 = phi double [ %77, %120 ], [ %75, %118 ]
  %124 = fadd double %76, %123
  %125 = fmul double %124, 5.000000e-01
  br label %126

126:                                              ; preds = %122, %120
  %127 = phi double [ %125, %122 ], [ %96, %120 ]
  %128 = fsub double %127, %76
  %129 = fmul double %91, %128
  %130 = fadd double %93, %129
  %131 = fmul double %128, %130
  %132 = fadd double %80, %131
  %133 = fcmp ule double %127, %75
  %134 = fcmp uge double %127, %77
  %135 = or i1 %133, %134
  %136 = fcmp oeq double %127, %76
  %137 = or i1 %135, %136
  br i1 %137, label %198, label %138

138:                                              ; preds = %126
  %139 = load ptr, ptr %58, align 8
  %140 = load ptr, ptr %59, align 8
  %141 = getelementptr inbounds i8, ptr %140, i64 96
  %142 = load ptr, ptr %141, align 8
  %143 = insertelement <8 x double> poison, double %127, i64 0
  %144 = shufflevector <8 x double> %143, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %144, ptr %142, align 8
  %145 = load ptr, ptr %140, align 8
  %146 = getelementptr inbounds i8, ptr %140, i64 192
  %147 = load ptr, ptr %146, align 8
  %148 = getelementptr inbounds i8, ptr %140, i64 8
  %149 = load i64, ptr %148, align 8
  %150 = load ptr, ptr %1, align 8
  %151 = load ptr, ptr %150, align 8
  %152 = getelementptr inbounds i8, ptr %151, i64 24
  %153 = load i64, ptr %152, align 8
  %154 = load ptr, ptr %141, align 8
  %155 = load ptr, ptr %60, align 8
  %156 = load ptr, ptr %155, align 8
  %157 = getelementptr inbounds i8, ptr %156, i64 16
  %158 = load i64, ptr %157, align 8
  tail call fastcc void @nested(ptr noundef %139, ptr noundef %145, ptr noundef %147, i64 noundef %149, i64 noundef %153, ptr noundef %154, i64 noundef %158) #8
  %159 = fmul double %127, %3
  %160 = fadd double %159, %2
  %161 = load ptr, ptr %61, align 8
  store double %160, ptr %161, align 8
  %162 = load i64, ptr %62, align 8
  %163 = icmp sgt i64 %162, 0
  br i1 %163, label %164, label %165

164:                                              ; preds = %138
  tail call fastcc void @sample(ptr noundef nonnull %63) #8
  br label %165

165:                                              ; preds = %138, %164
  %166 = load ptr, ptr %9, align 8
  %167 = load i64, ptr %166, align 8
  %168 = load ptr, ptr %64, align 8
  %169 = load ptr, ptr %58, align 8
  %170 = load ptr, ptr %65, align 8
  %171 = load ptr, ptr %66, align 8
  %172 = load ptr, ptr %13, align 8
  %173 = inttoptr i64 %167 to ptr
  %174 = load ptr, ptr %173, align 8
  %175 = tail call i32 %174(ptr noundef %168, ptr noundef %169, ptr noundef %170, ptr noundef %171, ptr noundef %172) #9
  %176 = icmp slt i32 %175, 0
  br i1 %176, label %198, label %177

177:                                              ; preds = %165
  %178 = load double, ptr %15, align 8
  %179 = fmul double %178, %5
  %180 = fcmp olt double %179, 0.000000e+00
  br i1 %180, label %181, label %184

181:                                              ; preds = %177
  %182 = fcmp olt double %179, %67
  %183 = select i1 %182, double %127, double 2.000000e+00
  br label %198

184:                                              ; preds = %177
  %185 = fsub double %179, %132
  %186 = tail call double @llvm.fabs.f64(double %185)
  %187 = fcmp uge double %127, %76
  %188 = fcmp ugt double %179, %80
  %189 = or i1 %187, %188
  br i1 %189, label %190, label %198

190:                                              ; preds = %184
  br i1 %187, label %191, label %198

191:                                              ; preds = %190
  %192 = select i1 %188, double %179, double %81
  %193 = select i1 %188, double %80, double %179
  %194 = select i1 %188, double %79, double %80
  %195 = select i1 %188, double %127, double %77
  %196 = select i1 %188, double %76, double %127
  %197 = select i1 %188, double %75, double %76
  br label %198

198:                                              ; preds = %114, %181, %191, %190, %184, %165, %126, %72, %98
  %199 = phi i1 [ false, %98 ], [ false, %72 ], [ false, %114 ], [ false, %126 ], [ false, %165 ], [ false, %181 ], [ true, %191 ], [ true, %190 ], [ true, %184 ]
  %200 = phi double [ %81, %98 ], [ %81, %72 ], [ %81, %114 ], [ %81, %126 ], [ %81, %165 ], [ %81, %181 ], [ %192, %191 ], [ %81, %190 ], [ %80, %184 ]
  %201 = phi double [ %80, %98 ], [ %80, %72 ], [ %80, %114 ], [ %80, %126 ], [ %80, %165 ], [ %80, %181 ], [ %193, %191 ], [ %80, %190 ], [ %179, %184 ]
  %202 = phi double [ %79, %98 ], [ %79, %72 ], [ %79, %114 ], [ %79, %126 ], [ %79, %165 ], [ %79, %181 ], [ %194, %191 ], [ %179, %190 ], [ %79, %184 ]
  %203 = phi double [ %78, %98 ], [ %78, %72 ], [ %78, %114 ], [ %78, %126 ], [ %78, %165 ], [ %78, %181 ], [ %186, %191 ], [ %186, %190 ], [ %186, %184 ]
  %204 = phi double [ %77, %98 ], [ %77, %72 ], [ %77, %114 ], [ %77, %126 ], [ %77, %165 ], [ %77, %181 ], [ %195, %191 ], [ %77, %190 ], [ %76, %184 ]
  %205 = phi double [ %76, %98 ], [ %76, %72 ], [ %76, %114 ], [ %76, %126 ], [ %76, %165 ], [ %76, %181 ], [ %196, %191 ], [ %76, %190 ], [ %127, %184 ]
  %206 = phi double [ %75, %98 ], [ %75, %72 ], [ %75, %114 ], [ %75, %126 ], [ %75, %165 ], [ %75, %181 ], [ %197, %191 ], [ %127, %190 ], [ %75, %184 ]
  %207 = phi double [ 2.000000e+00, %98 ], [ 2.000000e+00, %72 ], [ 2.000000e+00, %114 ], [ 2.000000e+00, %126 ], [ -4.000000e+00, %165 ], [ %183, %181 ], [ %74, %191 ], [ %74, %190 ], [ %74, %184 ]
  br i1 %199, label %68, label %208

208:                                              ; preds = %68, %198
  %209 = phi i1 [ %70, %68 ], [ %73, %198 ]
  br i1 %209, label %210, label %211

210:                                              ; preds = %208
  br label %211

211:                                              ; preds = %8, %208, %210
  %212 = phi double [ 2.000000e+00, %210 ], [ %207, %208 ], [ 2.000000e+00, %8 ]
  ret double %212
}

declare i32 @llvm.smin.i32(i32, i32) #6

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind willreturn memory(none) }
attributes #5 = { noinline nounwind }
attributes #6 = { nounwind willreturn memory(none) }
attributes #7 = { nounwind }
attributes #8 = { nounwind }
attributes #9 = { nounwind }


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
!17 = distinct !{!17, !5}
!18 = distinct !{!18, !4, !5}
!19 = distinct !{!19, !4, !5}
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
!30 = distinct !{!30, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5}
!35 = distinct !{!35, !4, !5}
