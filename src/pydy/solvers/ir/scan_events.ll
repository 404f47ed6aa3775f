; sources 1160dee2d1d2e18f272792231905d78969d191553af1b2ac31181a8875d8da9f
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

@scan_points = internal unnamed_addr constant [5 x double] [double 0.000000e+00, double 0x3FCE3779B97F4A7C, double 0x3FDCC470A0490974, double 0x3FE76CF5D0B09954, double 1.000000e+00], align 16

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

44:                                               ; preds = %82
  %45 = add nuw nsw i64 %52, 1
  %46 = icmp eq i64 %45, 5
  br i1 %46, label %47, label %51, !llvm.loop !3

47:                                               ; preds = %44
  %48 = icmp sgt i64 %12, 0
  br i1 %48, label %49, label %106

49:                                               ; preds = %47
  %50 = getelementptr inbounds i8, ptr %0, i64 864
  br label %102

51:                                               ; preds = %3, %44
  %52 = phi i64 [ %43, %3 ], [ %45, %44 ]
  %53 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %52
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
  %73 = load ptr, ptr %6, align 8
  %74 = getelementptr inbounds i8, ptr %73, i64 40
  %75 = load i64, ptr %74, align 8
  %76 = icmp eq i64 %75, 0
  br i1 %76, label %78, label %77

77:                                               ; preds = %51
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %78

78:                                               ; preds = %77, %51
  %79 = load i64, ptr %39, align 8
  %80 = icmp sgt i64 %79, 0
  br i1 %80, label %81, label %82

81:                                               ; preds = %78
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %82

82:                                               ; preds = %78, %81
  %83 = load ptr, ptr %9, align 8
  %84 = load i64, ptr %83, align 8
  %85 = load ptr, ptr %40, align 8
  %86 = load ptr, ptr %34, align 8
  %87 = load ptr, ptr %41, align 8
  %88 = load ptr, ptr %42, align 8
  %89 = load ptr, ptr %25, align 8
  %90 = getelementptr inbounds i8, ptr %83, i64 8
  %91 = load i64, ptr %90, align 8
  %92 = mul nsw i64 %91, %55
  %93 = getelementptr inbounds double, ptr %89, i64 %92
  %94 = inttoptr i64 %84 to ptr
  %95 = load ptr, ptr %94, align 8
  %96 = tail call i32 %95(ptr noundef %85, ptr noundef %86, ptr noundef %87, ptr noundef %88, ptr noundef %93) #9
  %97 = icmp slt i32 %96, 0
  br i1 %97, label %98, label %44

98:                                               ; preds = %82
  %99 = load ptr, ptr %20, align 8
  %100 = getelementptr inbounds i8, ptr %99, i64 80
  store i64 %23, ptr %100, align 8
  %101 = load ptr, ptr %19, align 8
  br label %1105

102:                                              ; preds = %49, %122
  %103 = phi i64 [ 0, %49 ], [ %123, %122 ]
  %104 = load double, ptr %30, align 8
  %105 = fcmp une double %104, %1
  br i1 %105, label %108, label %106

106:                                              ; preds = %102, %122, %47
  %107 = call fastcc i64 @resolve(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2) #8
  switch i64 %107, label %1109 [
    i64 0, label %129
    i64 -4, label %125
  ]

108:                                              ; preds = %102
  %109 = load ptr, ptr %50, align 8
  %110 = getelementptr inbounds i64, ptr %109, i64 %103
  %111 = load i64, ptr %110, align 8
  %112 = and i64 %111, 2
  %113 = icmp eq i64 %112, 0
  br i1 %113, label %122, label %114

114:                                              ; preds = %108
  %115 = getelementptr inbounds double, ptr %28, i64 %103
  %116 = load double, ptr %115, align 8
  %117 = fcmp une double %116, 0.000000e+00
  br i1 %117, label %118, label %122

118:                                              ; preds = %114
  %119 = fcmp ogt double %116, 0.000000e+00
  %120 = select i1 %119, i64 1, i64 -1
  %121 = getelementptr inbounds i64, ptr %16, i64 %103
  store i64 %120, ptr %121, align 8
  br label %122

122:                                              ; preds = %108, %114, %118
  %123 = add nuw nsw i64 %103, 1
  %124 = icmp eq i64 %123, %12
  br i1 %124, label %106, label %102, !llvm.loop !6

125:                                              ; preds = %106
  %126 = load ptr, ptr %20, align 8
  %127 = getelementptr inbounds i8, ptr %126, i64 80
  store i64 %23, ptr %127, align 8
  %128 = load ptr, ptr %19, align 8
  br label %1105

129:                                              ; preds = %106
  %130 = getelementptr inbounds i8, ptr %0, i64 320
  %131 = load i64, ptr %130, align 8
  %132 = icmp sgt i64 %131, 0
  br i1 %132, label %133, label %193

133:                                              ; preds = %129
  %134 = getelementptr inbounds i8, ptr %0, i64 320
  %135 = load i64, ptr %134, align 8
  %136 = icmp sgt i64 %135, 0
  br i1 %136, label %137, label %140

137:                                              ; preds = %133
  %138 = getelementptr inbounds i8, ptr %0, i64 336
  %139 = load ptr, ptr %138, align 8
  store double 0x7FF0000000000000, ptr %139, align 8
  br label %140

140:                                              ; preds = %133, %137
  %141 = getelementptr inbounds i8, ptr %0, i64 1032
  %142 = load ptr, ptr %141, align 8
  %143 = getelementptr inbounds i8, ptr %0, i64 456
  %144 = load ptr, ptr %143, align 8
  store <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, ptr %144, align 8
  %145 = load ptr, ptr %8, align 8
  %146 = getelementptr inbounds i8, ptr %0, i64 552
  %147 = load ptr, ptr %146, align 8
  %148 = getelementptr inbounds i8, ptr %0, i64 368
  %149 = load i64, ptr %148, align 8
  %150 = load ptr, ptr %0, align 8
  %151 = getelementptr inbounds i8, ptr %150, i64 24
  %152 = load i64, ptr %151, align 8
  %153 = load ptr, ptr %143, align 8
  %154 = load ptr, ptr %6, align 8
  %155 = getelementptr inbounds i8, ptr %154, i64 16
  %156 = load i64, ptr %155, align 8
  tail call fastcc void @nested(ptr noundef %142, ptr noundef %145, ptr noundef %147, i64 noundef %149, i64 noundef %152, ptr noundef %153, i64 noundef %156) #8
  %157 = fadd double %1, %2
  %158 = getelementptr inbounds i8, ptr %0, i64 168
  %159 = load ptr, ptr %158, align 8
  store double %157, ptr %159, align 8
  %160 = load ptr, ptr %6, align 8
  %161 = getelementptr inbounds i8, ptr %160, i64 40
  %162 = load i64, ptr %161, align 8
  %163 = icmp eq i64 %162, 0
  br i1 %163, label %165, label %164

164:                                              ; preds = %140
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %165

165:                                              ; preds = %164, %140
  %166 = getelementptr inbounds i8, ptr %0, i64 248
  %167 = load i64, ptr %166, align 8
  %168 = icmp sgt i64 %167, 0
  br i1 %168, label %169, label %170

169:                                              ; preds = %165
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %170

170:                                              ; preds = %165, %169
  %171 = load ptr, ptr %9, align 8
  %172 = load i64, ptr %171, align 8
  %173 = getelementptr inbounds i8, ptr %0, i64 168
  %174 = load ptr, ptr %173, align 8
  %175 = load ptr, ptr %141, align 8
  %176 = getelementptr inbounds i8, ptr %0, i64 192
  %177 = load ptr, ptr %176, align 8
  %178 = getelementptr inbounds i8, ptr %0, i64 792
  %179 = load ptr, ptr %178, align 8
  %180 = load ptr, ptr %25, align 8
  %181 = getelementptr inbounds i8, ptr %171, i64 8
  %182 = load i64, ptr %181, align 8
  %183 = mul i64 %182, 48
  %184 = getelementptr inbounds i8, ptr %180, i64 %183
  %185 = inttoptr i64 %172 to ptr
  %186 = load ptr, ptr %185, align 8
  %187 = tail call i32 %186(ptr noundef %174, ptr noundef %175, ptr noundef %177, ptr noundef %179, ptr noundef %184) #9
  %188 = icmp slt i32 %187, 0
  br i1 %188, label %189, label %193

189:                                              ; preds = %170
  %190 = load ptr, ptr %20, align 8
  %191 = getelementptr inbounds i8, ptr %190, i64 80
  store i64 %23, ptr %191, align 8
  %192 = load ptr, ptr %19, align 8
  br label %1105

193:                                              ; preds = %170, %129
  store double 0x7FF8000000000000, ptr %30, align 8
  %194 = getelementptr inbounds i8, ptr %0, i64 1032
  %195 = getelementptr inbounds i8, ptr %0, i64 168
  %196 = getelementptr inbounds i8, ptr %0, i64 248
  %197 = getelementptr inbounds i8, ptr %0, i64 168
  %198 = getelementptr inbounds i8, ptr %0, i64 192
  %199 = getelementptr inbounds i8, ptr %0, i64 792
  %200 = icmp sgt i64 %12, 0
  %201 = getelementptr inbounds i8, ptr %0, i64 1032
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
  %236 = load ptr, ptr %7, align 8
  %237 = getelementptr inbounds i8, ptr %236, i64 96
  %238 = getelementptr inbounds i8, ptr %236, i64 192
  %239 = getelementptr inbounds i8, ptr %236, i64 8
  %240 = load ptr, ptr %4, align 8
  %241 = load ptr, ptr %5, align 8
  %242 = load ptr, ptr %7, align 8
  %243 = getelementptr inbounds i8, ptr %242, i64 96
  %244 = getelementptr inbounds i8, ptr %242, i64 192
  %245 = getelementptr inbounds i8, ptr %242, i64 8
  %246 = load ptr, ptr %4, align 8
  %247 = load ptr, ptr %5, align 8
  br label %248

248:                                              ; preds = %193, %1084
  %249 = phi i1 [ false, %193 ], [ %1088, %1084 ]
  %250 = phi i64 [ -4, %193 ], [ %1082, %1084 ]
  %251 = phi double [ 0.000000e+00, %193 ], [ %1081, %1084 ]
  %252 = phi i32 [ 1, %193 ], [ %1087, %1084 ]
  %253 = zext nneg i32 %252 to i64
  %254 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %253
  %255 = load double, ptr %254, align 8
  %256 = mul nsw i64 %12, %253
  %257 = load ptr, ptr %9, align 8
  %258 = getelementptr inbounds i8, ptr %257, i64 8
  %259 = load i64, ptr %258, align 8
  %260 = icmp sgt i64 %259, 0
  br i1 %260, label %261, label %302

261:                                              ; preds = %248
  %262 = add nsw i32 %252, -1
  %263 = icmp ugt i32 %252, 1
  %264 = select i1 %263, i32 %262, i32 1
  %265 = tail call i32 @llvm.smin.i32(i32 %252, i32 3)
  %266 = icmp sgt i32 %264, %265
  %267 = zext nneg i32 %252 to i64
  %268 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %267
  br label %272

269:                                              ; preds = %299
  %270 = add nuw nsw i64 %274, 1
  %271 = icmp eq i64 %270, %259
  br i1 %271, label %302, label %272, !llvm.loop !7

272:                                              ; preds = %261, %269
  %273 = phi double [ 2.000000e+00, %261 ], [ %301, %269 ]
  %274 = phi i64 [ 0, %261 ], [ %270, %269 ]
  %275 = load ptr, ptr %15, align 8
  %276 = getelementptr inbounds i64, ptr %275, i64 %274
  %277 = load i64, ptr %276, align 8
  %278 = sitofp i64 %277 to double
  br i1 %266, label %299, label %283

279:                                              ; preds = %297
  %280 = add i32 %285, 1
  %281 = icmp sge i32 %285, %265
  %282 = icmp eq i32 %285, %265
  br i1 %282, label %299, label %283, !llvm.loop !8

283:                                              ; preds = %272, %279
  %284 = phi i1 [ %281, %279 ], [ %266, %272 ]
  %285 = phi i32 [ %280, %279 ], [ %264, %272 ]
  %286 = phi double [ %298, %279 ], [ %273, %272 ]
  %287 = call fastcc double @least_place(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, i64 noundef %274, double noundef %278, i32 noundef %285, i32 noundef %252) #8
  %288 = fcmp une double %287, -4.000000e+00
  %289 = fcmp ogt double %287, %251
  %290 = and i1 %288, %289
  br i1 %290, label %291, label %297

291:                                              ; preds = %283
  %292 = load double, ptr %268, align 8
  %293 = fcmp olt double %286, %292
  %294 = select i1 %293, double %286, double %292
  %295 = fcmp olt double %287, %294
  br i1 %295, label %296, label %297

296:                                              ; preds = %291
  br label %297

297:                                              ; preds = %296, %291, %283
  %298 = phi double [ %286, %283 ], [ %287, %296 ], [ %286, %291 ]
  br i1 %288, label %279, label %299

299:                                              ; preds = %279, %297, %272
  %300 = phi i1 [ %266, %272 ], [ %281, %279 ], [ %284, %297 ]
  %301 = phi double [ %273, %272 ], [ %298, %297 ], [ %298, %279 ]
  br i1 %300, label %269, label %302

302:                                              ; preds = %299, %269, %248
  %303 = phi double [ 2.000000e+00, %248 ], [ -4.000000e+00, %299 ], [ %301, %269 ]
  %304 = fcmp olt double %303, 0.000000e+00
  br i1 %304, label %1074, label %305

305:                                              ; preds = %302
  %306 = getelementptr double, ptr %28, i64 %256
  %307 = fcmp olt double %303, %255
  br i1 %307, label %308, label %348

308:                                              ; preds = %305
  %309 = load ptr, ptr %25, align 8
  %310 = load ptr, ptr %194, align 8
  %311 = load ptr, ptr %237, align 8
  %312 = insertelement <8 x double> poison, double %303, i64 0
  %313 = shufflevector <8 x double> %312, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %313, ptr %311, align 8
  %314 = load ptr, ptr %236, align 8
  %315 = load ptr, ptr %238, align 8
  %316 = load i64, ptr %239, align 8
  %317 = load ptr, ptr %240, align 8
  %318 = getelementptr inbounds i8, ptr %317, i64 24
  %319 = load i64, ptr %318, align 8
  %320 = load ptr, ptr %237, align 8
  %321 = load ptr, ptr %241, align 8
  %322 = getelementptr inbounds i8, ptr %321, i64 16
  %323 = load i64, ptr %322, align 8
  tail call fastcc void @nested(ptr noundef %310, ptr noundef %314, ptr noundef %315, i64 noundef %316, i64 noundef %319, ptr noundef %320, i64 noundef %323) #8
  %324 = fmul double %303, %2
  %325 = fadd double %324, %1
  %326 = load ptr, ptr %195, align 8
  store double %325, ptr %326, align 8
  %327 = load ptr, ptr %6, align 8
  %328 = getelementptr inbounds i8, ptr %327, i64 40
  %329 = load i64, ptr %328, align 8
  %330 = icmp eq i64 %329, 0
  br i1 %330, label %332, label %331

331:                                              ; preds = %308
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %332

332:                                              ; preds = %331, %308
  %333 = load i64, ptr %196, align 8
  %334 = icmp sgt i64 %333, 0
  br i1 %334, label %335, label %336

335:                                              ; preds = %332
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %336

336:                                              ; preds = %332, %335
  %337 = load ptr, ptr %9, align 8
  %338 = load i64, ptr %337, align 8
  %339 = load ptr, ptr %197, align 8
  %340 = load ptr, ptr %194, align 8
  %341 = load ptr, ptr %198, align 8
  %342 = load ptr, ptr %199, align 8
  %343 = load ptr, ptr %25, align 8
  %344 = inttoptr i64 %338 to ptr
  %345 = load ptr, ptr %344, align 8
  %346 = tail call i32 %345(ptr noundef %339, ptr noundef %340, ptr noundef %341, ptr noundef %342, ptr noundef %343) #9
  %347 = icmp slt i32 %346, 0
  br i1 %347, label %1074, label %348

348:                                              ; preds = %336, %305
  %349 = phi double [ %303, %336 ], [ %255, %305 ]
  %350 = phi ptr [ %309, %336 ], [ %306, %305 ]
  br label %351

351:                                              ; preds = %1002, %348
  %352 = phi double [ %251, %348 ], [ %1004, %1002 ]
  %353 = phi i64 [ %250, %348 ], [ %1005, %1002 ]
  br i1 %200, label %358, label %354

354:                                              ; preds = %397, %351
  %355 = phi double [ 2.000000e+00, %351 ], [ %398, %397 ]
  %356 = phi i64 [ -1, %351 ], [ %399, %397 ]
  %357 = fcmp ogt double %355, 1.000000e+00
  br i1 %357, label %1002, label %402

358:                                              ; preds = %351, %397
  %359 = phi i64 [ %400, %397 ], [ 0, %351 ]
  %360 = phi i64 [ %399, %397 ], [ -1, %351 ]
  %361 = phi double [ %398, %397 ], [ 2.000000e+00, %351 ]
  %362 = getelementptr inbounds i64, ptr %18, i64 %359
  store i64 0, ptr %362, align 8
  %363 = getelementptr inbounds i64, ptr %16, i64 %359
  %364 = load i64, ptr %363, align 8
  %365 = getelementptr inbounds double, ptr %350, i64 %359
  %366 = load double, ptr %365, align 8
  %367 = getelementptr inbounds i64, ptr %14, i64 %359
  %368 = load i64, ptr %367, align 8
  %369 = icmp slt i64 %364, 0
  %370 = fcmp ogt double %366, 0.000000e+00
  %371 = and i1 %369, %370
  %372 = icmp sgt i64 %368, -1
  %373 = and i1 %371, %372
  br i1 %373, label %381, label %374

374:                                              ; preds = %358
  %375 = icmp sgt i64 %364, 0
  %376 = fcmp olt double %366, 0.000000e+00
  %377 = and i1 %375, %376
  br i1 %377, label %378, label %381

378:                                              ; preds = %374
  %379 = icmp slt i64 %368, 1
  %380 = zext i1 %379 to i32
  br label %381

381:                                              ; preds = %358, %374, %378
  %382 = phi i32 [ 1, %358 ], [ 0, %374 ], [ %380, %378 ]
  %383 = icmp eq i32 %382, 0
  br i1 %383, label %384, label %388

384:                                              ; preds = %381
  %385 = icmp eq i64 %364, 0
  %386 = fcmp ord double %366, 0.000000e+00
  %387 = or i1 %385, %386
  br i1 %387, label %397, label %388

388:                                              ; preds = %384, %381
  %389 = call fastcc double @locate(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %352, double noundef %349, i64 noundef %359) #8
  %390 = fcmp oeq double %389, 2.000000e+00
  %391 = fcmp ole double %389, %352
  %392 = zext i1 %391 to i64
  %393 = select i1 %390, i64 -1, i64 %392
  store i64 %393, ptr %362, align 8
  %394 = fcmp olt double %389, %361
  %395 = select i1 %394, double %389, double %361
  %396 = select i1 %394, i64 %359, i64 %360
  br label %397

397:                                              ; preds = %384, %388
  %398 = phi double [ %395, %388 ], [ %361, %384 ]
  %399 = phi i64 [ %396, %388 ], [ %360, %384 ]
  %400 = add nuw nsw i64 %359, 1
  %401 = icmp eq i64 %400, %12
  br i1 %401, label %354, label %358, !llvm.loop !9

402:                                              ; preds = %354
  %403 = load ptr, ptr %201, align 8
  %404 = load ptr, ptr %243, align 8
  %405 = insertelement <8 x double> poison, double %355, i64 0
  %406 = shufflevector <8 x double> %405, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %406, ptr %404, align 8
  %407 = load ptr, ptr %242, align 8
  %408 = load ptr, ptr %244, align 8
  %409 = load i64, ptr %245, align 8
  %410 = load ptr, ptr %246, align 8
  %411 = getelementptr inbounds i8, ptr %410, i64 24
  %412 = load i64, ptr %411, align 8
  %413 = load ptr, ptr %243, align 8
  %414 = load ptr, ptr %247, align 8
  %415 = getelementptr inbounds i8, ptr %414, i64 16
  %416 = load i64, ptr %415, align 8
  tail call fastcc void @nested(ptr noundef %403, ptr noundef %407, ptr noundef %408, i64 noundef %409, i64 noundef %412, ptr noundef %413, i64 noundef %416) #8
  %417 = fmul double %355, %2
  %418 = fadd double %417, %1
  %419 = load ptr, ptr %202, align 8
  store double %418, ptr %419, align 8
  %420 = load ptr, ptr %6, align 8
  %421 = getelementptr inbounds i8, ptr %420, i64 40
  %422 = load i64, ptr %421, align 8
  %423 = icmp eq i64 %422, 0
  br i1 %423, label %425, label %424

424:                                              ; preds = %402
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %425

425:                                              ; preds = %424, %402
  %426 = load i64, ptr %203, align 8
  %427 = icmp sgt i64 %426, 0
  br i1 %427, label %428, label %429

428:                                              ; preds = %425
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %429

429:                                              ; preds = %425, %428
  %430 = load ptr, ptr %9, align 8
  %431 = load i64, ptr %430, align 8
  %432 = load ptr, ptr %204, align 8
  %433 = load ptr, ptr %201, align 8
  %434 = load ptr, ptr %205, align 8
  %435 = load ptr, ptr %206, align 8
  %436 = load ptr, ptr %25, align 8
  %437 = getelementptr inbounds i8, ptr %430, i64 8
  %438 = load i64, ptr %437, align 8
  %439 = getelementptr inbounds double, ptr %436, i64 %438
  %440 = inttoptr i64 %431 to ptr
  %441 = load ptr, ptr %440, align 8
  %442 = tail call i32 %441(ptr noundef %432, ptr noundef %433, ptr noundef %434, ptr noundef %435, ptr noundef %439) #9
  %443 = icmp slt i32 %442, 0
  br i1 %443, label %445, label %444

444:                                              ; preds = %429
  br i1 %207, label %450, label %565

445:                                              ; preds = %429
  %446 = load ptr, ptr %20, align 8
  %447 = getelementptr inbounds i8, ptr %446, i64 80
  store i64 %23, ptr %447, align 8
  %448 = load ptr, ptr %19, align 8
  %449 = getelementptr inbounds i8, ptr %448, i64 48
  store double 1.000000e+00, ptr %449, align 8
  br label %1002

450:                                              ; preds = %444, %560
  %451 = phi i1 [ %563, %560 ], [ %207, %444 ]
  %452 = phi i64 [ %562, %560 ], [ 0, %444 ]
  %453 = phi double [ %561, %560 ], [ %355, %444 ]
  %454 = icmp eq i64 %452, %356
  br i1 %454, label %560, label %455

455:                                              ; preds = %450
  %456 = getelementptr inbounds i64, ptr %18, i64 %452
  %457 = load i64, ptr %456, align 8
  %458 = icmp eq i64 %457, 0
  br i1 %458, label %459, label %560

459:                                              ; preds = %455
  %460 = getelementptr inbounds i64, ptr %16, i64 %452
  %461 = load i64, ptr %460, align 8
  %462 = sitofp i64 %461 to double
  %463 = getelementptr inbounds double, ptr %31, i64 %452
  %464 = load double, ptr %463, align 8
  %465 = fmul double %464, %462
  %466 = fcmp olt double %465, 0.000000e+00
  br i1 %466, label %467, label %560

467:                                              ; preds = %459
  %468 = call fastcc i32 @departs(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %352, double noundef %453, double noundef %464, i64 noundef %452) #8
  %469 = icmp eq i32 %468, 0
  br i1 %469, label %470, label %509

470:                                              ; preds = %467
  %471 = load i64, ptr %460, align 8
  %472 = load double, ptr %463, align 8
  %473 = getelementptr inbounds i64, ptr %14, i64 %452
  %474 = load i64, ptr %473, align 8
  %475 = icmp slt i64 %471, 0
  %476 = fcmp ogt double %472, 0.000000e+00
  %477 = and i1 %475, %476
  %478 = icmp sgt i64 %474, -1
  %479 = and i1 %477, %478
  br i1 %479, label %487, label %480

480:                                              ; preds = %470
  %481 = icmp sgt i64 %471, 0
  %482 = fcmp olt double %472, 0.000000e+00
  %483 = and i1 %481, %482
  br i1 %483, label %484, label %487

484:                                              ; preds = %480
  %485 = icmp slt i64 %474, 1
  %486 = zext i1 %485 to i32
  br label %487

487:                                              ; preds = %470, %480, %484
  %488 = phi i32 [ 1, %470 ], [ 0, %480 ], [ %486, %484 ]
  %489 = icmp eq i32 %488, 0
  br i1 %489, label %512, label %490

490:                                              ; preds = %487
  %491 = getelementptr inbounds double, ptr %350, i64 %452
  %492 = load double, ptr %491, align 8
  %493 = fcmp ogt double %492, 0.000000e+00
  %494 = and i1 %475, %493
  %495 = and i1 %478, %494
  br i1 %495, label %503, label %496

496:                                              ; preds = %490
  %497 = icmp sgt i64 %471, 0
  %498 = fcmp olt double %492, 0.000000e+00
  %499 = and i1 %497, %498
  br i1 %499, label %500, label %503

500:                                              ; preds = %496
  %501 = icmp slt i64 %474, 1
  %502 = zext i1 %501 to i32
  br label %503

503:                                              ; preds = %490, %496, %500
  %504 = phi i32 [ 1, %490 ], [ 0, %496 ], [ %502, %500 ]
  %505 = icmp eq i32 %504, 0
  br i1 %505, label %506, label %512

506:                                              ; preds = %503
  %507 = call fastcc double @locate(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %352, double noundef %453, i64 noundef %452) #8
  %508 = fcmp ogt double %507, %352
  br i1 %508, label %509, label %512

509:                                              ; preds = %506, %467
  %510 = phi i64 [ -1, %467 ], [ 2, %506 ]
  %511 = phi double [ %453, %467 ], [ %507, %506 ]
  store i64 %510, ptr %456, align 8
  br label %512

512:                                              ; preds = %509, %506, %487, %503
  %513 = phi double [ %453, %503 ], [ %453, %487 ], [ %453, %506 ], [ %511, %509 ]
  %514 = load ptr, ptr %201, align 8
  %515 = load ptr, ptr %243, align 8
  %516 = insertelement <8 x double> poison, double %513, i64 0
  %517 = shufflevector <8 x double> %516, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %517, ptr %515, align 8
  %518 = load ptr, ptr %242, align 8
  %519 = load ptr, ptr %244, align 8
  %520 = load i64, ptr %245, align 8
  %521 = load ptr, ptr %246, align 8
  %522 = getelementptr inbounds i8, ptr %521, i64 24
  %523 = load i64, ptr %522, align 8
  %524 = load ptr, ptr %243, align 8
  %525 = load ptr, ptr %247, align 8
  %526 = getelementptr inbounds i8, ptr %525, i64 16
  %527 = load i64, ptr %526, align 8
  tail call fastcc void @nested(ptr noundef %514, ptr noundef %518, ptr noundef %519, i64 noundef %520, i64 noundef %523, ptr noundef %524, i64 noundef %527) #8
  %528 = fmul double %513, %2
  %529 = fadd double %528, %1
  %530 = load ptr, ptr %202, align 8
  store double %529, ptr %530, align 8
  %531 = load ptr, ptr %6, align 8
  %532 = getelementptr inbounds i8, ptr %531, i64 40
  %533 = load i64, ptr %532, align 8
  %534 = icmp eq i64 %533, 0
  br i1 %534, label %536, label %535

535:                                              ; preds = %512
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %536

536:                                              ; preds = %535, %512
  %537 = load i64, ptr %203, align 8
  %538 = icmp sgt i64 %537, 0
  br i1 %538, label %539, label %540

539:                                              ; preds = %536
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %540

540:                                              ; preds = %536, %539
  %541 = load ptr, ptr %9, align 8
  %542 = load i64, ptr %541, align 8
  %543 = load ptr, ptr %204, align 8
  %544 = load ptr, ptr %201, align 8
  %545 = load ptr, ptr %205, align 8
  %546 = load ptr, ptr %206, align 8
  %547 = load ptr, ptr %25, align 8
  %548 = getelementptr inbounds i8, ptr %541, i64 8
  %549 = load i64, ptr %548, align 8
  %550 = getelementptr inbounds double, ptr %547, i64 %549
  %551 = inttoptr i64 %542 to ptr
  %552 = load ptr, ptr %551, align 8
  %553 = tail call i32 %552(ptr noundef %543, ptr noundef %544, ptr noundef %545, ptr noundef %546, ptr noundef %550) #9
  %554 = icmp slt i32 %553, 0
  br i1 %554, label %555, label %560

555:                                              ; preds = %540
  %556 = load ptr, ptr %20, align 8
  %557 = getelementptr inbounds i8, ptr %556, i64 80
  store i64 %23, ptr %557, align 8
  %558 = load ptr, ptr %19, align 8
  %559 = getelementptr inbounds i8, ptr %558, i64 48
  store double 1.000000e+00, ptr %559, align 8
  br label %565

560:                                              ; preds = %540, %450, %455, %459
  %561 = phi double [ %453, %450 ], [ %453, %455 ], [ %513, %540 ], [ %453, %459 ]
  %562 = add nuw nsw i64 %452, 1
  %563 = icmp slt i64 %562, %12
  %564 = icmp eq i64 %562, %12
  br i1 %564, label %565, label %450, !llvm.loop !10

565:                                              ; preds = %560, %444, %555
  %566 = phi i1 [ %451, %555 ], [ %207, %444 ], [ %563, %560 ]
  %567 = phi i32 [ 1, %555 ], [ 16, %444 ], [ 16, %560 ]
  %568 = phi double [ %513, %555 ], [ %355, %444 ], [ %561, %560 ]
  %569 = phi i64 [ -4, %555 ], [ %353, %444 ], [ %353, %560 ]
  br i1 %566, label %1002, label %570

570:                                              ; preds = %565
  br i1 %208, label %579, label %571

571:                                              ; preds = %667, %570
  %572 = phi i64 [ -1, %570 ], [ %668, %667 ]
  %573 = phi i32 [ 0, %570 ], [ %669, %667 ]
  %574 = icmp eq i32 %573, 0
  br i1 %574, label %575, label %672

575:                                              ; preds = %571
  br i1 %217, label %576, label %805

576:                                              ; preds = %575
  %577 = fmul double %568, %2
  %578 = fadd double %577, %1
  br label %933

579:                                              ; preds = %570, %667
  %580 = phi i64 [ %670, %667 ], [ 0, %570 ]
  %581 = phi i32 [ %669, %667 ], [ 0, %570 ]
  %582 = phi i64 [ %668, %667 ], [ -1, %570 ]
  %583 = getelementptr inbounds double, ptr %31, i64 %580
  %584 = load double, ptr %583, align 8
  %585 = getelementptr inbounds i64, ptr %18, i64 %580
  %586 = load i64, ptr %585, align 8
  %587 = icmp eq i64 %586, -1
  br i1 %587, label %667, label %588

588:                                              ; preds = %579
  %589 = getelementptr inbounds i64, ptr %16, i64 %580
  %590 = load i64, ptr %589, align 8
  %591 = getelementptr inbounds i64, ptr %14, i64 %580
  %592 = load i64, ptr %591, align 8
  %593 = icmp slt i64 %590, 0
  %594 = fcmp ogt double %584, 0.000000e+00
  %595 = and i1 %594, %593
  %596 = icmp sgt i64 %592, -1
  %597 = and i1 %595, %596
  br i1 %597, label %605, label %598

598:                                              ; preds = %588
  %599 = icmp sgt i64 %590, 0
  %600 = fcmp olt double %584, 0.000000e+00
  %601 = and i1 %600, %599
  br i1 %601, label %602, label %605

602:                                              ; preds = %598
  %603 = icmp slt i64 %592, 1
  %604 = zext i1 %603 to i32
  br label %605

605:                                              ; preds = %588, %598, %602
  %606 = phi i32 [ 1, %588 ], [ 0, %598 ], [ %604, %602 ]
  %607 = icmp eq i32 %606, 0
  br i1 %607, label %608, label %629

608:                                              ; preds = %605
  %609 = getelementptr inbounds double, ptr %350, i64 %580
  %610 = load double, ptr %609, align 8
  %611 = fcmp ogt double %610, 0.000000e+00
  %612 = and i1 %593, %611
  %613 = and i1 %596, %612
  br i1 %613, label %621, label %614

614:                                              ; preds = %608
  %615 = icmp sgt i64 %590, 0
  %616 = fcmp olt double %610, 0.000000e+00
  %617 = and i1 %615, %616
  br i1 %617, label %618, label %621

618:                                              ; preds = %614
  %619 = icmp slt i64 %592, 1
  %620 = zext i1 %619 to i32
  br label %621

621:                                              ; preds = %608, %614, %618
  %622 = phi i32 [ 1, %608 ], [ 0, %614 ], [ %620, %618 ]
  %623 = icmp eq i32 %622, 0
  br i1 %623, label %629, label %624

624:                                              ; preds = %621
  %625 = fcmp oeq double %584, 0.000000e+00
  %626 = icmp eq i64 %586, 1
  %627 = or i1 %625, %626
  %628 = zext i1 %627 to i32
  br label %629

629:                                              ; preds = %624, %621, %605
  %630 = phi i32 [ 1, %605 ], [ %628, %624 ], [ 0, %621 ]
  %631 = icmp eq i32 %630, 0
  br i1 %631, label %632, label %636

632:                                              ; preds = %629
  %633 = icmp eq i64 %586, 2
  %634 = fcmp oeq double %584, 0.000000e+00
  %635 = select i1 %633, i1 %634, i1 false
  br label %636

636:                                              ; preds = %632, %629
  %637 = phi i1 [ true, %629 ], [ %635, %632 ]
  br i1 %637, label %653, label %638

638:                                              ; preds = %636
  %639 = getelementptr inbounds double, ptr %350, i64 %580
  %640 = load double, ptr %639, align 8
  %641 = icmp eq i64 %590, 0
  %642 = fcmp ord double %640, 0.000000e+00
  %643 = or i1 %641, %642
  br i1 %643, label %653, label %644

644:                                              ; preds = %638
  %645 = sitofp i64 %590 to double
  %646 = fmul double %584, %645
  %647 = fcmp olt double %646, 0.000000e+00
  br i1 %647, label %648, label %650

648:                                              ; preds = %644
  %649 = sub nsw i64 0, %590
  store i64 %649, ptr %589, align 8
  br label %653

650:                                              ; preds = %644
  %651 = fcmp ueq double %584, 0.000000e+00
  %652 = select i1 %651, i64 %580, i64 %582
  br label %653

653:                                              ; preds = %650, %648, %638, %636
  %654 = phi i64 [ %582, %636 ], [ %582, %648 ], [ %582, %638 ], [ %652, %650 ]
  %655 = zext i1 %637 to i64
  store i64 %655, ptr %585, align 8
  %656 = icmp ne i32 %581, 0
  %657 = xor i1 %637, true
  %658 = or i1 %656, %657
  br i1 %658, label %664, label %659

659:                                              ; preds = %653
  %660 = load ptr, ptr %209, align 8
  %661 = getelementptr inbounds i64, ptr %660, i64 %580
  %662 = load i64, ptr %661, align 8
  %663 = icmp eq i64 %662, 1
  br label %664

664:                                              ; preds = %653, %659
  %665 = phi i1 [ %656, %653 ], [ %663, %659 ]
  %666 = zext i1 %665 to i32
  br label %667

667:                                              ; preds = %579, %664
  %668 = phi i64 [ %654, %664 ], [ %582, %579 ]
  %669 = phi i32 [ %666, %664 ], [ %581, %579 ]
  %670 = add nuw nsw i64 %580, 1
  %671 = icmp eq i64 %670, %12
  br i1 %671, label %571, label %579, !llvm.loop !11

672:                                              ; preds = %571
  store double %568, ptr %210, align 8
  %673 = load ptr, ptr %9, align 8
  %674 = getelementptr inbounds i8, ptr %673, i64 8
  %675 = load i64, ptr %674, align 8
  %676 = load ptr, ptr %25, align 8
  %677 = getelementptr inbounds double, ptr %676, i64 %675
  %678 = mul i64 %675, 56
  %679 = getelementptr inbounds i8, ptr %676, i64 %678
  %680 = load ptr, ptr %211, align 8
  %681 = load i64, ptr %212, align 8
  %682 = getelementptr double, ptr %680, i64 %681
  %683 = getelementptr i8, ptr %682, i64 -8
  %684 = load double, ptr %683, align 8
  %685 = load double, ptr %680, align 8
  %686 = fsub double %684, %685
  %687 = icmp sgt i64 %675, 0
  br i1 %687, label %691, label %688

688:                                              ; preds = %704, %672
  %689 = phi i32 [ 0, %672 ], [ %706, %704 ]
  %690 = icmp eq i32 %689, 0
  br i1 %690, label %1002, label %709

691:                                              ; preds = %672, %704
  %692 = phi i64 [ %707, %704 ], [ 0, %672 ]
  %693 = phi i32 [ %706, %704 ], [ 0, %672 ]
  %694 = icmp eq i32 %693, 0
  br i1 %694, label %695, label %704

695:                                              ; preds = %691
  %696 = load ptr, ptr %17, align 8
  %697 = getelementptr inbounds i64, ptr %696, i64 %692
  %698 = load i64, ptr %697, align 8
  %699 = icmp sgt i64 %698, 0
  br i1 %699, label %700, label %704

700:                                              ; preds = %695
  %701 = getelementptr inbounds double, ptr %677, i64 %692
  %702 = load double, ptr %701, align 8
  %703 = fcmp oeq double %702, 0.000000e+00
  br label %704

704:                                              ; preds = %700, %695, %691
  %705 = phi i1 [ true, %691 ], [ false, %695 ], [ %703, %700 ]
  %706 = zext i1 %705 to i32
  %707 = add nuw nsw i64 %692, 1
  %708 = icmp eq i64 %707, %675
  br i1 %708, label %688, label %691, !llvm.loop !12

709:                                              ; preds = %688
  %710 = fsub double %349, %568
  %711 = fmul double %710, %2
  %712 = fcmp ogt double %214, %686
  %713 = select i1 %712, double %214, double %686
  %714 = fmul double %713, 0x3F50000000000000
  %715 = fcmp ugt double %711, %714
  br i1 %715, label %716, label %1002

716:                                              ; preds = %709
  %717 = fmul double %710, 0x3F50000000000000
  %718 = fadd double %568, %717
  %719 = load ptr, ptr %201, align 8
  %720 = load ptr, ptr %243, align 8
  %721 = insertelement <8 x double> poison, double %718, i64 0
  %722 = shufflevector <8 x double> %721, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %722, ptr %720, align 8
  %723 = load ptr, ptr %242, align 8
  %724 = load ptr, ptr %244, align 8
  %725 = load i64, ptr %245, align 8
  %726 = load ptr, ptr %246, align 8
  %727 = getelementptr inbounds i8, ptr %726, i64 24
  %728 = load i64, ptr %727, align 8
  %729 = load ptr, ptr %243, align 8
  %730 = load ptr, ptr %247, align 8
  %731 = getelementptr inbounds i8, ptr %730, i64 16
  %732 = load i64, ptr %731, align 8
  tail call fastcc void @nested(ptr noundef %719, ptr noundef %723, ptr noundef %724, i64 noundef %725, i64 noundef %728, ptr noundef %729, i64 noundef %732) #8
  %733 = fmul double %718, %2
  %734 = fadd double %733, %1
  %735 = load ptr, ptr %202, align 8
  store double %734, ptr %735, align 8
  %736 = load ptr, ptr %6, align 8
  %737 = getelementptr inbounds i8, ptr %736, i64 40
  %738 = load i64, ptr %737, align 8
  %739 = icmp eq i64 %738, 0
  br i1 %739, label %741, label %740

740:                                              ; preds = %716
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %741

741:                                              ; preds = %740, %716
  %742 = load i64, ptr %203, align 8
  %743 = icmp sgt i64 %742, 0
  br i1 %743, label %744, label %745

744:                                              ; preds = %741
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %745

745:                                              ; preds = %741, %744
  %746 = load ptr, ptr %9, align 8
  %747 = load i64, ptr %746, align 8
  %748 = load ptr, ptr %204, align 8
  %749 = load ptr, ptr %201, align 8
  %750 = load ptr, ptr %205, align 8
  %751 = load ptr, ptr %206, align 8
  %752 = load ptr, ptr %25, align 8
  %753 = getelementptr inbounds i8, ptr %746, i64 8
  %754 = load i64, ptr %753, align 8
  %755 = mul i64 %754, 56
  %756 = getelementptr inbounds i8, ptr %752, i64 %755
  %757 = inttoptr i64 %747 to ptr
  %758 = load ptr, ptr %757, align 8
  %759 = tail call i32 %758(ptr noundef %748, ptr noundef %749, ptr noundef %750, ptr noundef %751, ptr noundef %756) #9
  %760 = icmp slt i32 %759, 0
  br i1 %760, label %800, label %761

761:                                              ; preds = %745
  %762 = icmp sgt i64 %675, 0
  br i1 %762, label %763, label %1002

763:                                              ; preds = %761
  %764 = fmul double %568, %2
  %765 = fadd double %764, %1
  %766 = fsub double %765, %765
  br label %767

767:                                              ; preds = %763, %797
  %768 = phi i64 [ 0, %763 ], [ %798, %797 ]
  %769 = load ptr, ptr %17, align 8
  %770 = getelementptr inbounds i64, ptr %769, i64 %768
  %771 = load i64, ptr %770, align 8
  %772 = icmp sgt i64 %771, 0
  br i1 %772, label %773, label %797

773:                                              ; preds = %767
  %774 = getelementptr inbounds double, ptr %677, i64 %768
  %775 = load double, ptr %774, align 8
  %776 = fcmp oeq double %775, 0.000000e+00
  br i1 %776, label %777, label %797

777:                                              ; preds = %773
  %778 = getelementptr inbounds double, ptr %679, i64 %768
  %779 = load double, ptr %778, align 8
  %780 = fcmp oeq double %779, 0.000000e+00
  br i1 %780, label %781, label %797

781:                                              ; preds = %777
  %782 = load i64, ptr %215, align 8
  %783 = icmp eq i64 %782, 0
  br i1 %783, label %797, label %784

784:                                              ; preds = %781
  %785 = load ptr, ptr %216, align 8
  %786 = shl nsw i64 %768, 4
  %787 = getelementptr inbounds i8, ptr %785, i64 %786
  %788 = getelementptr inbounds i8, ptr %787, i64 8
  %789 = load double, ptr %788, align 8
  %790 = fcmp oeq double %789, %765
  br i1 %790, label %796, label %791

791:                                              ; preds = %784
  %792 = load double, ptr %787, align 8
  %793 = fsub double %789, %792
  %794 = fcmp ult double %793, %766
  br i1 %794, label %795, label %797

795:                                              ; preds = %791
  store double %765, ptr %787, align 8
  br label %796

796:                                              ; preds = %784, %795
  store double %765, ptr %788, align 8
  br label %797

797:                                              ; preds = %796, %791, %781, %777, %773, %767
  %798 = add nuw nsw i64 %768, 1
  %799 = icmp eq i64 %798, %675
  br i1 %799, label %1002, label %767, !llvm.loop !13

800:                                              ; preds = %745
  %801 = load ptr, ptr %20, align 8
  %802 = getelementptr inbounds i8, ptr %801, i64 80
  store i64 %23, ptr %802, align 8
  %803 = load ptr, ptr %19, align 8
  %804 = getelementptr inbounds i8, ptr %803, i64 48
  store double 1.000000e+00, ptr %804, align 8
  br label %1002

805:                                              ; preds = %975, %575
  %806 = load ptr, ptr %9, align 8
  %807 = getelementptr inbounds i8, ptr %806, i64 8
  %808 = load i64, ptr %807, align 8
  %809 = load ptr, ptr %25, align 8
  %810 = getelementptr inbounds double, ptr %809, i64 %808
  %811 = mul i64 %808, 56
  %812 = getelementptr inbounds i8, ptr %809, i64 %811
  %813 = load ptr, ptr %223, align 8
  %814 = load i64, ptr %224, align 8
  %815 = getelementptr double, ptr %813, i64 %814
  %816 = getelementptr i8, ptr %815, i64 -8
  %817 = load double, ptr %816, align 8
  %818 = load double, ptr %813, align 8
  %819 = fsub double %817, %818
  %820 = icmp sgt i64 %808, 0
  br i1 %820, label %824, label %821

821:                                              ; preds = %837, %805
  %822 = phi i32 [ 0, %805 ], [ %839, %837 ]
  %823 = icmp eq i32 %822, 0
  br i1 %823, label %983, label %842

824:                                              ; preds = %805, %837
  %825 = phi i64 [ %840, %837 ], [ 0, %805 ]
  %826 = phi i32 [ %839, %837 ], [ 0, %805 ]
  %827 = icmp eq i32 %826, 0
  br i1 %827, label %828, label %837

828:                                              ; preds = %824
  %829 = load ptr, ptr %17, align 8
  %830 = getelementptr inbounds i64, ptr %829, i64 %825
  %831 = load i64, ptr %830, align 8
  %832 = icmp sgt i64 %831, 0
  br i1 %832, label %833, label %837

833:                                              ; preds = %828
  %834 = getelementptr inbounds double, ptr %810, i64 %825
  %835 = load double, ptr %834, align 8
  %836 = fcmp oeq double %835, 0.000000e+00
  br label %837

837:                                              ; preds = %833, %828, %824
  %838 = phi i1 [ true, %824 ], [ false, %828 ], [ %836, %833 ]
  %839 = zext i1 %838 to i32
  %840 = add nuw nsw i64 %825, 1
  %841 = icmp eq i64 %840, %808
  br i1 %841, label %821, label %824, !llvm.loop !12

842:                                              ; preds = %821
  %843 = fsub double %349, %568
  %844 = fmul double %843, %2
  %845 = fcmp ogt double %226, %819
  %846 = select i1 %845, double %226, double %819
  %847 = fmul double %846, 0x3F50000000000000
  %848 = fcmp ugt double %844, %847
  br i1 %848, label %849, label %983

849:                                              ; preds = %842
  %850 = fmul double %843, 0x3F50000000000000
  %851 = fadd double %568, %850
  %852 = load ptr, ptr %201, align 8
  %853 = load ptr, ptr %243, align 8
  %854 = insertelement <8 x double> poison, double %851, i64 0
  %855 = shufflevector <8 x double> %854, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %855, ptr %853, align 8
  %856 = load ptr, ptr %242, align 8
  %857 = load ptr, ptr %244, align 8
  %858 = load i64, ptr %245, align 8
  %859 = load ptr, ptr %246, align 8
  %860 = getelementptr inbounds i8, ptr %859, i64 24
  %861 = load i64, ptr %860, align 8
  %862 = load ptr, ptr %243, align 8
  %863 = load ptr, ptr %247, align 8
  %864 = getelementptr inbounds i8, ptr %863, i64 16
  %865 = load i64, ptr %864, align 8
  tail call fastcc void @nested(ptr noundef %852, ptr noundef %856, ptr noundef %857, i64 noundef %858, i64 noundef %861, ptr noundef %862, i64 noundef %865) #8
  %866 = fmul double %851, %2
  %867 = fadd double %866, %1
  %868 = load ptr, ptr %202, align 8
  store double %867, ptr %868, align 8
  %869 = load ptr, ptr %6, align 8
  %870 = getelementptr inbounds i8, ptr %869, i64 40
  %871 = load i64, ptr %870, align 8
  %872 = icmp eq i64 %871, 0
  br i1 %872, label %874, label %873

873:                                              ; preds = %849
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %874

874:                                              ; preds = %873, %849
  %875 = load i64, ptr %203, align 8
  %876 = icmp sgt i64 %875, 0
  br i1 %876, label %877, label %878

877:                                              ; preds = %874
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %878

878:                                              ; preds = %874, %877
  %879 = load ptr, ptr %9, align 8
  %880 = load i64, ptr %879, align 8
  %881 = load ptr, ptr %204, align 8
  %882 = load ptr, ptr %201, align 8
  %883 = load ptr, ptr %205, align 8
  %884 = load ptr, ptr %206, align 8
  %885 = load ptr, ptr %25, align 8
  %886 = getelementptr inbounds i8, ptr %879, i64 8
  %887 = load i64, ptr %886, align 8
  %888 = mul i64 %887, 56
  %889 = getelementptr inbounds i8, ptr %885, i64 %888
  %890 = inttoptr i64 %880 to ptr
  %891 = load ptr, ptr %890, align 8
  %892 = tail call i32 %891(ptr noundef %881, ptr noundef %882, ptr noundef %883, ptr noundef %884, ptr noundef %889) #9
  %893 = icmp slt i32 %892, 0
  br i1 %893, label %978, label %894

894:                                              ; preds = %878
  %895 = icmp sgt i64 %808, 0
  br i1 %895, label %896, label %983

896:                                              ; preds = %894
  %897 = fmul double %568, %2
  %898 = fadd double %897, %1
  %899 = fsub double %898, %898
  br label %900

900:                                              ; preds = %896, %930
  %901 = phi i64 [ 0, %896 ], [ %931, %930 ]
  %902 = load ptr, ptr %17, align 8
  %903 = getelementptr inbounds i64, ptr %902, i64 %901
  %904 = load i64, ptr %903, align 8
  %905 = icmp sgt i64 %904, 0
  br i1 %905, label %906, label %930

906:                                              ; preds = %900
  %907 = getelementptr inbounds double, ptr %810, i64 %901
  %908 = load double, ptr %907, align 8
  %909 = fcmp oeq double %908, 0.000000e+00
  br i1 %909, label %910, label %930

910:                                              ; preds = %906
  %911 = getelementptr inbounds double, ptr %812, i64 %901
  %912 = load double, ptr %911, align 8
  %913 = fcmp oeq double %912, 0.000000e+00
  br i1 %913, label %914, label %930

914:                                              ; preds = %910
  %915 = load i64, ptr %227, align 8
  %916 = icmp eq i64 %915, 0
  br i1 %916, label %930, label %917

917:                                              ; preds = %914
  %918 = load ptr, ptr %228, align 8
  %919 = shl nsw i64 %901, 4
  %920 = getelementptr inbounds i8, ptr %918, i64 %919
  %921 = getelementptr inbounds i8, ptr %920, i64 8
  %922 = load double, ptr %921, align 8
  %923 = fcmp oeq double %922, %898
  br i1 %923, label %929, label %924

924:                                              ; preds = %917
  %925 = load double, ptr %920, align 8
  %926 = fsub double %922, %925
  %927 = fcmp ult double %926, %899
  br i1 %927, label %928, label %930

928:                                              ; preds = %924
  store double %898, ptr %920, align 8
  br label %929

929:                                              ; preds = %917, %928
  store double %898, ptr %921, align 8
  br label %930

930:                                              ; preds = %929, %924, %914, %910, %906, %900
  %931 = add nuw nsw i64 %901, 1
  %932 = icmp eq i64 %931, %808
  br i1 %932, label %983, label %900, !llvm.loop !13

933:                                              ; preds = %576, %975
  %934 = phi i64 [ 0, %576 ], [ %976, %975 ]
  %935 = getelementptr inbounds i64, ptr %18, i64 %934
  %936 = load i64, ptr %935, align 8
  %937 = icmp slt i64 %936, 1
  br i1 %937, label %975, label %938

938:                                              ; preds = %933
  %939 = load ptr, ptr %20, align 8
  %940 = getelementptr inbounds i8, ptr %939, i64 80
  %941 = load i64, ptr %940, align 8
  %942 = load ptr, ptr %6, align 8
  %943 = getelementptr inbounds i8, ptr %942, i64 8
  %944 = load i64, ptr %943, align 8
  %945 = load i64, ptr %218, align 8
  %946 = icmp eq i64 %945, 0
  br i1 %946, label %971, label %947

947:                                              ; preds = %938
  %948 = load ptr, ptr %219, align 8
  %949 = getelementptr inbounds double, ptr %948, i64 %941
  store double %578, ptr %949, align 8
  %950 = load ptr, ptr %220, align 8
  %951 = getelementptr inbounds i64, ptr %950, i64 %941
  store i64 %934, ptr %951, align 8
  %952 = icmp sgt i64 %944, 0
  br i1 %952, label %953, label %955

953:                                              ; preds = %947
  %954 = mul nsw i64 %944, %941
  br label %959

955:                                              ; preds = %959, %947
  %956 = add nsw i64 %941, 1
  %957 = load ptr, ptr %20, align 8
  %958 = getelementptr inbounds i8, ptr %957, i64 80
  store i64 %956, ptr %958, align 8
  br label %971

959:                                              ; preds = %953, %959
  %960 = phi i64 [ 0, %953 ], [ %969, %959 ]
  %961 = load ptr, ptr %201, align 8
  %962 = getelementptr inbounds double, ptr %961, i64 %960
  %963 = load double, ptr %962, align 8
  %964 = load ptr, ptr %221, align 8
  %965 = add nsw i64 %960, %954
  %966 = getelementptr inbounds double, ptr %964, i64 %965
  store double %963, ptr %966, align 8
  %967 = load ptr, ptr %222, align 8
  %968 = getelementptr inbounds double, ptr %967, i64 %965
  store double %963, ptr %968, align 8
  %969 = add nuw nsw i64 %960, 1
  %970 = icmp eq i64 %969, %944
  br i1 %970, label %955, label %959, !llvm.loop !14

971:                                              ; preds = %938, %955
  %972 = getelementptr inbounds i64, ptr %16, i64 %934
  %973 = load i64, ptr %972, align 8
  %974 = sub nsw i64 0, %973
  store i64 %974, ptr %972, align 8
  br label %975

975:                                              ; preds = %933, %971
  %976 = add nuw nsw i64 %934, 1
  %977 = icmp eq i64 %976, %12
  br i1 %977, label %805, label %933, !llvm.loop !15

978:                                              ; preds = %878
  %979 = load ptr, ptr %20, align 8
  %980 = getelementptr inbounds i8, ptr %979, i64 80
  store i64 %23, ptr %980, align 8
  %981 = load ptr, ptr %19, align 8
  %982 = getelementptr inbounds i8, ptr %981, i64 48
  store double 1.000000e+00, ptr %982, align 8
  br label %1002

983:                                              ; preds = %930, %894, %842, %821
  %984 = icmp sgt i64 %572, -1
  br i1 %984, label %985, label %994

985:                                              ; preds = %983
  br i1 %231, label %987, label %986

986:                                              ; preds = %987, %985
  store double %568, ptr %232, align 8
  br label %1002

987:                                              ; preds = %985, %987
  %988 = phi i64 [ %992, %987 ], [ 0, %985 ]
  %989 = icmp eq i64 %988, %572
  %990 = zext i1 %989 to i64
  %991 = getelementptr inbounds i64, ptr %18, i64 %988
  store i64 %990, ptr %991, align 8
  %992 = add nuw nsw i64 %988, 1
  %993 = icmp eq i64 %992, %12
  br i1 %993, label %986, label %987, !llvm.loop !16

994:                                              ; preds = %983
  %995 = load i64, ptr %229, align 8
  %996 = icmp sgt i64 %995, 0
  br i1 %996, label %997, label %1002

997:                                              ; preds = %994
  %998 = load i64, ptr %22, align 8
  %999 = add nsw i64 %998, %12
  %1000 = icmp sgt i64 %999, %995
  br i1 %1000, label %1001, label %1002

1001:                                             ; preds = %997
  store double %568, ptr %230, align 8
  br label %1002

1002:                                             ; preds = %797, %761, %709, %688, %978, %986, %1001, %800, %997, %994, %354, %565, %445
  %1003 = phi i32 [ 1, %445 ], [ %567, %565 ], [ 11, %354 ], [ 1, %978 ], [ 1, %986 ], [ 1, %1001 ], [ 1, %800 ], [ 0, %997 ], [ 0, %994 ], [ 1, %688 ], [ 1, %709 ], [ 1, %761 ], [ 1, %797 ]
  %1004 = phi double [ %352, %445 ], [ %352, %565 ], [ %352, %354 ], [ %352, %978 ], [ %352, %986 ], [ %352, %1001 ], [ %352, %800 ], [ %568, %997 ], [ %568, %994 ], [ %352, %688 ], [ %352, %709 ], [ %352, %761 ], [ %352, %797 ]
  %1005 = phi i64 [ -4, %445 ], [ %569, %565 ], [ %353, %354 ], [ -4, %978 ], [ 21, %986 ], [ -3, %1001 ], [ -4, %800 ], [ %569, %997 ], [ %569, %994 ], [ -2, %688 ], [ -2, %709 ], [ -2, %761 ], [ -2, %797 ]
  switch i32 %1003, label %1079 [
    i32 0, label %351
    i32 11, label %1006
  ], !llvm.loop !17

1006:                                             ; preds = %1002
  br i1 %233, label %1007, label %1079

1007:                                             ; preds = %1006
  %1008 = fcmp oeq double %349, %255
  %1009 = add nsw i32 %252, -1
  %1010 = sext i32 %1009 to i64
  %1011 = mul nsw i64 %12, %1010
  %1012 = getelementptr double, ptr %28, i64 %1011
  %1013 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %1010
  %1014 = fmul double %349, %2
  %1015 = fadd double %1014, %1
  br label %1016

1016:                                             ; preds = %1007, %1071
  %1017 = phi i64 [ 0, %1007 ], [ %1072, %1071 ]
  %1018 = getelementptr inbounds double, ptr %350, i64 %1017
  %1019 = load double, ptr %1018, align 8
  %1020 = getelementptr inbounds i64, ptr %16, i64 %1017
  %1021 = load i64, ptr %1020, align 8
  %1022 = sitofp i64 %1021 to double
  %1023 = fmul double %1019, %1022
  %1024 = fcmp olt double %1023, 0.000000e+00
  br i1 %1024, label %1025, label %1031

1025:                                             ; preds = %1016
  %1026 = call fastcc i32 @departs(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %1004, double noundef %349, double noundef %1019, i64 noundef %1017) #8
  %1027 = icmp eq i32 %1026, 0
  br i1 %1027, label %1028, label %1031

1028:                                             ; preds = %1025
  %1029 = load i64, ptr %1020, align 8
  %1030 = sub nsw i64 0, %1029
  br label %1040

1031:                                             ; preds = %1025, %1016
  %1032 = load i64, ptr %1020, align 8
  %1033 = icmp eq i64 %1032, 0
  br i1 %1033, label %1034, label %1042

1034:                                             ; preds = %1031
  %1035 = load double, ptr %1018, align 8
  %1036 = fcmp ogt double %1035, 0.000000e+00
  %1037 = fcmp olt double %1035, 0.000000e+00
  %1038 = sext i1 %1037 to i64
  %1039 = select i1 %1036, i64 1, i64 %1038
  br label %1040

1040:                                             ; preds = %1028, %1034
  %1041 = phi i64 [ %1039, %1034 ], [ %1030, %1028 ]
  store i64 %1041, ptr %1020, align 8
  br label %1042

1042:                                             ; preds = %1040, %1031
  br i1 %1008, label %1043, label %1071

1043:                                             ; preds = %1042
  %1044 = getelementptr double, ptr %1012, i64 %1017
  %1045 = load double, ptr %1044, align 8
  %1046 = fcmp oeq double %1045, 0.000000e+00
  br i1 %1046, label %1047, label %1071

1047:                                             ; preds = %1043
  %1048 = getelementptr double, ptr %306, i64 %1017
  %1049 = load double, ptr %1048, align 8
  %1050 = fcmp oeq double %1049, 0.000000e+00
  br i1 %1050, label %1051, label %1071

1051:                                             ; preds = %1047
  %1052 = load double, ptr %1013, align 8
  %1053 = fmul double %1052, %2
  %1054 = fadd double %1053, %1
  %1055 = load i64, ptr %234, align 8
  %1056 = icmp eq i64 %1055, 0
  br i1 %1056, label %1071, label %1057

1057:                                             ; preds = %1051
  %1058 = load ptr, ptr %235, align 8
  %1059 = shl nsw i64 %1017, 4
  %1060 = getelementptr inbounds i8, ptr %1058, i64 %1059
  %1061 = getelementptr inbounds i8, ptr %1060, i64 8
  %1062 = load double, ptr %1061, align 8
  %1063 = fcmp oeq double %1062, %1054
  br i1 %1063, label %1070, label %1064

1064:                                             ; preds = %1057
  %1065 = load double, ptr %1060, align 8
  %1066 = fsub double %1062, %1065
  %1067 = fsub double %1015, %1054
  %1068 = fcmp ult double %1066, %1067
  br i1 %1068, label %1069, label %1071

1069:                                             ; preds = %1064
  store double %1054, ptr %1060, align 8
  br label %1070

1070:                                             ; preds = %1057, %1069
  store double %1015, ptr %1061, align 8
  br label %1071

1071:                                             ; preds = %1070, %1064, %1051, %1042, %1043, %1047
  %1072 = add nuw nsw i64 %1017, 1
  %1073 = icmp eq i64 %1072, %12
  br i1 %1073, label %1079, label %1016, !llvm.loop !18

1074:                                             ; preds = %336, %302
  %1075 = load ptr, ptr %20, align 8
  %1076 = getelementptr inbounds i8, ptr %1075, i64 80
  store i64 %23, ptr %1076, align 8
  %1077 = load ptr, ptr %19, align 8
  %1078 = getelementptr inbounds i8, ptr %1077, i64 48
  store double 1.000000e+00, ptr %1078, align 8
  br label %1079

1079:                                             ; preds = %1002, %1071, %1074, %1006
  %1080 = phi i32 [ 0, %1006 ], [ 1, %1074 ], [ 0, %1071 ], [ %1003, %1002 ]
  %1081 = phi double [ %349, %1006 ], [ %251, %1074 ], [ %349, %1071 ], [ %1004, %1002 ]
  %1082 = phi i64 [ %1005, %1006 ], [ -4, %1074 ], [ %1005, %1071 ], [ %1005, %1002 ]
  %1083 = icmp eq i32 %1080, 0
  br i1 %1083, label %1084, label %1089

1084:                                             ; preds = %1079
  %1085 = fcmp oeq double %1081, %255
  %1086 = zext i1 %1085 to i32
  %1087 = add nuw nsw i32 %252, %1086
  %1088 = icmp ugt i32 %1087, 4
  br i1 %1088, label %1089, label %248, !llvm.loop !19

1089:                                             ; preds = %1084, %1079
  %1090 = phi i1 [ %1088, %1084 ], [ %249, %1079 ]
  br i1 %1090, label %1091, label %1109

1091:                                             ; preds = %1089
  %1092 = icmp sgt i64 %12, 0
  br i1 %1092, label %1093, label %1096

1093:                                             ; preds = %1091
  %1094 = shl i64 %12, 5
  %1095 = getelementptr i8, ptr %28, i64 %1094
  br label %1098

1096:                                             ; preds = %1098, %1091
  %1097 = load double, ptr %24, align 8
  store double %1097, ptr %30, align 8
  br label %1105

1098:                                             ; preds = %1093, %1098
  %1099 = phi i64 [ 0, %1093 ], [ %1103, %1098 ]
  %1100 = getelementptr double, ptr %1095, i64 %1099
  %1101 = load double, ptr %1100, align 8
  %1102 = getelementptr inbounds double, ptr %28, i64 %1099
  store double %1101, ptr %1102, align 8
  %1103 = add nuw nsw i64 %1099, 1
  %1104 = icmp eq i64 %1103, %12
  br i1 %1104, label %1096, label %1098, !llvm.loop !20

1105:                                             ; preds = %125, %1096, %189, %98
  %1106 = phi ptr [ %101, %98 ], [ %192, %189 ], [ %24, %1096 ], [ %128, %125 ]
  %1107 = phi i64 [ -4, %98 ], [ -4, %189 ], [ 0, %1096 ], [ -4, %125 ]
  %1108 = getelementptr inbounds i8, ptr %1106, i64 48
  store double 1.000000e+00, ptr %1108, align 8
  br label %1109

1109:                                             ; preds = %1105, %1089, %106
  %1110 = phi i64 [ %1082, %1089 ], [ %107, %106 ], [ %1107, %1105 ]
  ret i64 %1110
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
  br i1 %26, label %27, label %365

27:                                               ; preds = %4
  %28 = getelementptr inbounds i8, ptr %0, i64 984
  %29 = shl nsw i64 %9, 4
  %30 = mul i64 %9, 40
  %31 = getelementptr inbounds i8, ptr %0, i64 864
  %32 = getelementptr inbounds i8, ptr %0, i64 144
  %33 = getelementptr inbounds i8, ptr %0, i64 1032
  %34 = getelementptr inbounds i8, ptr %1, i64 16
  %35 = getelementptr inbounds i8, ptr %1, i64 8
  %36 = getelementptr inbounds i8, ptr %0, i64 168
  %37 = getelementptr inbounds i8, ptr %0, i64 248
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

53:                                               ; preds = %27, %362
  %54 = phi i64 [ undef, %27 ], [ %361, %362 ]
  %55 = phi i32 [ 0, %27 ], [ %360, %362 ]
  %56 = phi i32 [ 0, %27 ], [ %359, %362 ]
  %57 = phi i64 [ 0, %27 ], [ %363, %362 ]
  %58 = load ptr, ptr %28, align 8
  %59 = getelementptr inbounds i8, ptr %58, i64 %29
  %60 = getelementptr inbounds double, ptr %59, i64 %57
  %61 = getelementptr inbounds i8, ptr %60, i64 %30
  %62 = load ptr, ptr %31, align 8
  %63 = getelementptr inbounds i64, ptr %62, i64 %57
  %64 = load i64, ptr %63, align 8
  %65 = and i64 %64, 1
  %66 = icmp eq i64 %65, 0
  br i1 %66, label %67, label %357

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
  br i1 %96, label %357, label %97

97:                                               ; preds = %94
  %98 = sext i32 %55 to i64
  br label %99

99:                                               ; preds = %97, %143
  %100 = phi i64 [ %98, %97 ], [ %105, %143 ]
  %101 = icmp slt i64 %100, 4
  br i1 %101, label %102, label %159

102:                                              ; preds = %99
  %103 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %100
  %104 = load double, ptr %103, align 8
  %105 = add nsw i64 %100, 1
  %106 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %105
  %107 = load double, ptr %106, align 8
  %108 = fadd double %104, %107
  %109 = fmul double %108, 5.000000e-01
  %110 = add nsw i64 %100, 7
  %111 = load ptr, ptr %33, align 8
  %112 = load ptr, ptr %34, align 8
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
  %127 = load ptr, ptr %35, align 8
  %128 = load ptr, ptr %127, align 8
  %129 = getelementptr inbounds i8, ptr %128, i64 16
  %130 = load i64, ptr %129, align 8
  tail call fastcc void @nested(ptr noundef %111, ptr noundef %117, ptr noundef %119, i64 noundef %121, i64 noundef %125, ptr noundef %126, i64 noundef %130) #8
  %131 = fmul double %109, %3
  %132 = fadd double %131, %2
  %133 = load ptr, ptr %36, align 8
  store double %132, ptr %133, align 8
  %134 = load ptr, ptr %32, align 8
  %135 = getelementptr inbounds i8, ptr %134, i64 40
  %136 = load i64, ptr %135, align 8
  %137 = icmp eq i64 %136, 0
  br i1 %137, label %139, label %138

138:                                              ; preds = %102
  tail call fastcc void @settle(ptr noundef nonnull %32) #8
  br label %139

139:                                              ; preds = %138, %102
  %140 = load i64, ptr %37, align 8
  %141 = icmp sgt i64 %140, 0
  br i1 %141, label %142, label %143

142:                                              ; preds = %139
  tail call fastcc void @sample(ptr noundef nonnull %32) #8
  br label %143

143:                                              ; preds = %139, %142
  %144 = load ptr, ptr %6, align 8
  %145 = load i64, ptr %144, align 8
  %146 = load ptr, ptr %38, align 8
  %147 = load ptr, ptr %33, align 8
  %148 = load ptr, ptr %39, align 8
  %149 = load ptr, ptr %40, align 8
  %150 = load ptr, ptr %28, align 8
  %151 = getelementptr inbounds i8, ptr %144, i64 8
  %152 = load i64, ptr %151, align 8
  %153 = mul nsw i64 %152, %110
  %154 = getelementptr inbounds double, ptr %150, i64 %153
  %155 = inttoptr i64 %145 to ptr
  %156 = load ptr, ptr %155, align 8
  %157 = tail call i32 %156(ptr noundef %146, ptr noundef %147, ptr noundef %148, ptr noundef %149, ptr noundef %154) #9
  %158 = icmp slt i32 %157, 0
  br i1 %158, label %355, label %99, !llvm.loop !22

159:                                              ; preds = %99
  %160 = load double, ptr %60, align 8
  %161 = tail call double @llvm.fabs.f64(double %160)
  store double %160, ptr %5, align 16
  br label %169

162:                                              ; preds = %219
  %163 = trunc nsw i64 %100 to i32
  %164 = fmul double %230, 0x3E50000000000000
  %165 = fcmp ogt double %224, %164
  br i1 %165, label %166, label %351

166:                                              ; preds = %162
  %167 = fmul double %224, 2.000000e+00
  %168 = fmul double %224, 8.000000e+00
  br label %232

169:                                              ; preds = %159, %219
  %170 = phi i64 [ 0, %159 ], [ %179, %219 ]
  %171 = phi double [ 0.000000e+00, %159 ], [ %224, %219 ]
  %172 = phi double [ %161, %159 ], [ %230, %219 ]
  %173 = mul nuw nsw i64 %9, %170
  %174 = getelementptr inbounds double, ptr %61, i64 %173
  %175 = load double, ptr %174, align 8
  %176 = shl nuw nsw i64 %170, 1
  %177 = or disjoint i64 %176, 1
  %178 = getelementptr inbounds [9 x double], ptr %5, i64 0, i64 %177
  store double %175, ptr %178, align 8
  %179 = add nuw nsw i64 %170, 1
  %180 = mul nuw nsw i64 %9, %179
  %181 = getelementptr inbounds double, ptr %60, i64 %180
  %182 = load double, ptr %181, align 8
  %183 = add nuw nsw i64 %176, 2
  %184 = getelementptr inbounds [9 x double], ptr %5, i64 0, i64 %183
  store double %182, ptr %184, align 16
  %185 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %170
  %186 = load double, ptr %185, align 8
  %187 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %179
  %188 = load double, ptr %187, align 8
  %189 = fadd double %186, %188
  %190 = fmul double %189, 5.000000e-01
  br label %191

191:                                              ; preds = %169, %195
  %192 = phi i64 [ 0, %169 ], [ %201, %195 ]
  %193 = phi double [ 0.000000e+00, %169 ], [ %200, %195 ]
  %194 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %192
  br label %203

195:                                              ; preds = %214
  %196 = mul nuw nsw i64 %9, %192
  %197 = getelementptr inbounds double, ptr %60, i64 %196
  %198 = load double, ptr %197, align 8
  %199 = fmul double %216, %198
  %200 = fadd double %193, %199
  %201 = add nuw nsw i64 %192, 1
  %202 = icmp eq i64 %201, 5
  br i1 %202, label %219, label %191, !llvm.loop !23

203:                                              ; preds = %191, %214
  %204 = phi i64 [ 0, %191 ], [ %217, %214 ]
  %205 = phi double [ 1.000000e+00, %191 ], [ %216, %214 ]
  %206 = icmp eq i64 %204, %192
  br i1 %206, label %214, label %207

207:                                              ; preds = %203
  %208 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %204
  %209 = load double, ptr %208, align 8
  %210 = fsub double %190, %209
  %211 = load double, ptr %194, align 8
  %212 = fsub double %211, %209
  %213 = fdiv double %210, %212
  br label %214

214:                                              ; preds = %207, %203
  %215 = phi double [ %213, %207 ], [ 1.000000e+00, %203 ]
  %216 = fmul double %205, %215
  %217 = add nuw nsw i64 %204, 1
  %218 = icmp eq i64 %217, 5
  br i1 %218, label %195, label %203, !llvm.loop !24

219:                                              ; preds = %195
  %220 = fsub double %175, %200
  %221 = tail call double @llvm.fabs.f64(double %220)
  %222 = fmul double %221, 2.000000e+00
  %223 = fcmp ogt double %171, %222
  %224 = select i1 %223, double %171, double %222
  %225 = tail call double @llvm.fabs.f64(double %175)
  %226 = tail call double @llvm.fabs.f64(double %182)
  %227 = fcmp ogt double %225, %226
  %228 = select i1 %227, double %225, double %226
  %229 = fcmp ogt double %172, %228
  %230 = select i1 %229, double %172, double %228
  %231 = icmp eq i64 %179, 4
  br i1 %231, label %162, label %169, !llvm.loop !25

232:                                              ; preds = %166, %253
  %233 = phi i64 [ 1, %166 ], [ %254, %253 ]
  %234 = phi i1 [ false, %166 ], [ %255, %253 ]
  %235 = getelementptr double, ptr %5, i64 %233
  %236 = getelementptr i8, ptr %235, i64 -8
  %237 = load double, ptr %236, align 8
  %238 = load double, ptr %235, align 8
  %239 = fsub double %237, %238
  %240 = tail call double @llvm.fabs.f64(double %239)
  %241 = fmul double %237, %238
  %242 = fcmp olt double %241, 0.000000e+00
  br i1 %242, label %243, label %245

243:                                              ; preds = %232
  %244 = fcmp olt double %240, %168
  br i1 %244, label %257, label %253

245:                                              ; preds = %232
  %246 = tail call double @llvm.fabs.f64(double %238)
  %247 = tail call double @llvm.fabs.f64(double %237)
  %248 = fcmp olt double %247, %246
  %249 = select i1 %248, double %247, double %246
  %250 = fcmp ugt double %249, %224
  %251 = fcmp ugt double %240, %167
  %252 = or i1 %251, %250
  br i1 %252, label %253, label %257

253:                                              ; preds = %245, %243
  %254 = add nuw nsw i64 %233, 1
  %255 = icmp ugt i64 %233, 7
  %256 = icmp eq i64 %254, 9
  br i1 %256, label %351, label %232, !llvm.loop !26

257:                                              ; preds = %243, %245
  br i1 %234, label %351, label %258

258:                                              ; preds = %257, %324
  %259 = phi i32 [ 1, %324 ], [ %56, %257 ]
  %260 = icmp eq i32 %259, 0
  br i1 %260, label %261, label %339

261:                                              ; preds = %258
  %262 = load ptr, ptr %42, align 8
  %263 = load ptr, ptr %43, align 8
  %264 = getelementptr inbounds i8, ptr %263, i64 96
  %265 = load ptr, ptr %264, align 8
  store <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, ptr %265, align 8
  %266 = load ptr, ptr %263, align 8
  %267 = getelementptr inbounds i8, ptr %263, i64 192
  %268 = load ptr, ptr %267, align 8
  %269 = getelementptr inbounds i8, ptr %263, i64 8
  %270 = load i64, ptr %269, align 8
  %271 = load ptr, ptr %1, align 8
  %272 = load ptr, ptr %271, align 8
  %273 = getelementptr inbounds i8, ptr %272, i64 24
  %274 = load i64, ptr %273, align 8
  %275 = load ptr, ptr %264, align 8
  %276 = load ptr, ptr %44, align 8
  %277 = load ptr, ptr %276, align 8
  %278 = getelementptr inbounds i8, ptr %277, i64 16
  %279 = load i64, ptr %278, align 8
  tail call fastcc void @nested(ptr noundef %262, ptr noundef %266, ptr noundef %268, i64 noundef %270, i64 noundef %274, ptr noundef %275, i64 noundef %279) #8
  %280 = load ptr, ptr %41, align 8
  %281 = getelementptr inbounds i8, ptr %280, i64 8
  %282 = load i64, ptr %281, align 8
  %283 = icmp sgt i64 %282, 0
  br i1 %283, label %295, label %284

284:                                              ; preds = %295, %261
  %285 = load ptr, ptr %47, align 8
  store double %19, ptr %285, align 8
  %286 = load ptr, ptr %41, align 8
  %287 = getelementptr inbounds i8, ptr %286, i64 40
  %288 = load i64, ptr %287, align 8
  %289 = icmp eq i64 %288, 0
  br i1 %289, label %291, label %290

290:                                              ; preds = %284
  tail call fastcc void @settle(ptr noundef nonnull %41) #8
  br label %291

291:                                              ; preds = %290, %284
  %292 = load i64, ptr %48, align 8
  %293 = icmp sgt i64 %292, 0
  br i1 %293, label %294, label %324

294:                                              ; preds = %291
  tail call fastcc void @sample(ptr noundef nonnull %41) #8
  br label %324

295:                                              ; preds = %261, %295
  %296 = phi i64 [ %319, %295 ], [ 0, %261 ]
  %297 = load ptr, ptr %45, align 8
  %298 = getelementptr inbounds double, ptr %297, i64 %296
  %299 = load double, ptr %298, align 8
  %300 = load ptr, ptr %46, align 8
  %301 = getelementptr inbounds double, ptr %300, i64 %296
  %302 = load double, ptr %301, align 8
  %303 = load ptr, ptr %42, align 8
  %304 = getelementptr inbounds double, ptr %303, i64 %296
  %305 = load double, ptr %304, align 8
  %306 = tail call double @llvm.fabs.f64(double %305)
  %307 = fmul double %302, %306
  %308 = fadd double %299, %307
  %309 = and i64 %296, 1
  %310 = icmp eq i64 %309, 0
  %311 = urem i64 %296, 3
  %312 = uitofp nneg i64 %311 to double
  %313 = fmul double %312, 0x3FE3C6EF372FE950
  %314 = fadd double %313, 1.000000e+00
  %315 = fneg double %314
  %316 = select i1 %310, double %314, double %315
  %317 = fmul double %316, %308
  %318 = fadd double %305, %317
  store double %318, ptr %304, align 8
  %319 = add nuw nsw i64 %296, 1
  %320 = load ptr, ptr %41, align 8
  %321 = getelementptr inbounds i8, ptr %320, i64 8
  %322 = load i64, ptr %321, align 8
  %323 = icmp slt i64 %319, %322
  br i1 %323, label %295, label %284, !llvm.loop !27

324:                                              ; preds = %291, %294
  %325 = load ptr, ptr %6, align 8
  %326 = load i64, ptr %325, align 8
  %327 = load ptr, ptr %49, align 8
  %328 = load ptr, ptr %42, align 8
  %329 = load ptr, ptr %50, align 8
  %330 = load ptr, ptr %51, align 8
  %331 = load ptr, ptr %28, align 8
  %332 = getelementptr inbounds i8, ptr %325, i64 8
  %333 = load i64, ptr %332, align 8
  %334 = getelementptr inbounds double, ptr %331, i64 %333
  %335 = inttoptr i64 %326 to ptr
  %336 = load ptr, ptr %335, align 8
  %337 = tail call i32 %336(ptr noundef %327, ptr noundef %328, ptr noundef %329, ptr noundef %330, ptr noundef %334) #9
  %338 = icmp slt i32 %337, 0
  br i1 %338, label %351, label %258, !llvm.loop !28

339:                                              ; preds = %258
  %340 = load ptr, ptr %28, align 8
  %341 = getelementptr double, ptr %340, i64 %9
  %342 = getelementptr double, ptr %341, i64 %57
  %343 = load double, ptr %342, align 8
  %344 = getelementptr inbounds i8, ptr %60, i64 %52
  %345 = load double, ptr %344, align 8
  %346 = fsub double %343, %345
  %347 = tail call double @llvm.fabs.f64(double %346)
  %348 = fcmp ogt double %224, %347
  %349 = zext i1 %348 to i32
  %350 = select i1 %348, i64 -6, i64 %54
  br label %351

351:                                              ; preds = %253, %324, %339, %162, %257
  %352 = phi i32 [ 4, %257 ], [ 4, %162 ], [ %349, %339 ], [ 1, %324 ], [ 4, %253 ]
  %353 = phi i32 [ %56, %257 ], [ %56, %162 ], [ %259, %339 ], [ %259, %324 ], [ %56, %253 ]
  %354 = phi i64 [ %54, %257 ], [ %54, %162 ], [ %350, %339 ], [ -4, %324 ], [ %54, %253 ]
  br label %357

355:                                              ; preds = %143
  %356 = trunc nsw i64 %100 to i32
  br label %357

357:                                              ; preds = %355, %53, %94, %351
  %358 = phi i32 [ %352, %351 ], [ 4, %94 ], [ 4, %53 ], [ 1, %355 ]
  %359 = phi i32 [ %353, %351 ], [ %56, %94 ], [ %56, %53 ], [ %56, %355 ]
  %360 = phi i32 [ %163, %351 ], [ %55, %94 ], [ %55, %53 ], [ %356, %355 ]
  %361 = phi i64 [ %354, %351 ], [ %54, %94 ], [ %54, %53 ], [ -4, %355 ]
  switch i32 %358, label %365 [
    i32 0, label %362
    i32 4, label %362
  ]

362:                                              ; preds = %357, %357
  %363 = add nuw nsw i64 %57, 1
  %364 = icmp eq i64 %363, %9
  br i1 %364, label %365, label %53, !llvm.loop !29

365:                                              ; preds = %362, %357, %4
  %366 = phi i64 [ 0, %4 ], [ %361, %357 ], [ 0, %362 ]
  ret i64 %366
}

define internal fastcc double @locate(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, double noundef %4, double noundef %5, i64 noundef %6) unnamed_addr #2 {
  %8 = alloca double, align 8
  %9 = alloca double, align 8
  store double %4, ptr %8, align 8
  store double %5, ptr %9, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 768
  %11 = getelementptr inbounds i8, ptr %0, i64 936
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr inbounds i64, ptr %12, i64 %6
  %14 = load i64, ptr %13, align 8
  %15 = sitofp i64 %14 to double
  %16 = fadd double %2, %3
  %17 = tail call double @llvm.fabs.f64(double %16)
  %18 = tail call double @llvm.fabs.f64(double %2)
  %19 = fcmp ogt double %17, %18
  %20 = select i1 %19, double %17, double %18
  %21 = fmul double %20, 0x3CB0000000000000
  %22 = fdiv double %21, %3
  %23 = getelementptr inbounds i8, ptr %0, i64 984
  %24 = load ptr, ptr %23, align 8
  %25 = load ptr, ptr %10, align 8
  %26 = getelementptr inbounds i8, ptr %25, i64 8
  %27 = load i64, ptr %26, align 8
  %28 = getelementptr inbounds double, ptr %24, i64 %27
  %29 = getelementptr inbounds double, ptr %28, i64 %6
  %30 = call fastcc i32 @comes_to_side(ptr noundef %0, ptr noundef %1, double noundef %2, double noundef %3, ptr noundef nonnull %8, ptr noundef nonnull %9, double noundef %22, i64 noundef %6) #8
  %31 = icmp eq i32 %30, 0
  br i1 %31, label %44, label %32

32:                                               ; preds = %7
  %33 = load double, ptr %9, align 8
  %34 = load double, ptr %8, align 8
  %35 = getelementptr inbounds i8, ptr %0, i64 144
  %36 = getelementptr inbounds i8, ptr %0, i64 1032
  %37 = getelementptr inbounds i8, ptr %1, i64 16
  %38 = getelementptr inbounds i8, ptr %1, i64 8
  %39 = getelementptr inbounds i8, ptr %0, i64 168
  %40 = getelementptr inbounds i8, ptr %0, i64 248
  %41 = getelementptr inbounds i8, ptr %0, i64 168
  %42 = getelementptr inbounds i8, ptr %0, i64 192
  %43 = getelementptr inbounds i8, ptr %0, i64 792
  br label %47

44:                                               ; preds = %7
  %45 = load double, ptr %8, align 8
  %46 = tail call fastcc double @turning_place(ptr noundef %0, ptr noundef %1, double noundef %2, double noundef %3, double noundef %45, double noundef %5, double noundef %22, i64 noundef %6) #8
  br label %113

47:                                               ; preds = %32, %91
  %48 = phi double [ %34, %32 ], [ %108, %91 ]
  %49 = phi double [ %33, %32 ], [ %109, %91 ]
  %50 = fsub double %49, %48
  %51 = fcmp ogt double %50, %22
  br i1 %51, label %52, label %110

52:                                               ; preds = %47
  %53 = fmul double %50, 5.000000e-01
  %54 = fadd double %48, %53
  %55 = fcmp une double %54, %48
  %56 = fcmp une double %54, %49
  %57 = and i1 %55, %56
  br i1 %57, label %58, label %110

58:                                               ; preds = %52
  %59 = load ptr, ptr %36, align 8
  %60 = load ptr, ptr %37, align 8
  %61 = getelementptr inbounds i8, ptr %60, i64 96
  %62 = load ptr, ptr %61, align 8
  %63 = insertelement <8 x double> poison, double %54, i64 0
  %64 = shufflevector <8 x double> %63, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %64, ptr %62, align 8
  %65 = load ptr, ptr %60, align 8
  %66 = getelementptr inbounds i8, ptr %60, i64 192
  %67 = load ptr, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %60, i64 8
  %69 = load i64, ptr %68, align 8
  %70 = load ptr, ptr %1, align 8
  %71 = load ptr, ptr %70, align 8
  %72 = getelementptr inbounds i8, ptr %71, i64 24
  %73 = load i64, ptr %72, align 8
  %74 = load ptr, ptr %61, align 8
  %75 = load ptr, ptr %38, align 8
  %76 = load ptr, ptr %75, align 8
  %77 = getelementptr inbounds i8, ptr %76, i64 16
  %78 = load i64, ptr %77, align 8
  tail call fastcc void @nested(ptr noundef %59, ptr noundef %65, ptr noundef %67, i64 noundef %69, i64 noundef %73, ptr noundef %74, i64 noundef %78) #8
  %79 = fmul double %54, %3
  %80 = fadd double %79, %2
  %81 = load ptr, ptr %39, align 8
  store double %80, ptr %81, align 8
  %82 = load ptr, ptr %35, align 8
  %83 = getelementptr inbounds i8, ptr %82, i64 40
  %84 = load i64, ptr %83, align 8
  %85 = icmp eq i64 %84, 0
  br i1 %85, label %87, label %86

86:                                               ; preds = %58
  tail call fastcc void @settle(ptr noundef nonnull %35) #8
  br label %87

87:                                               ; preds = %86, %58
  %88 = load i64, ptr %40, align 8
  %89 = icmp sgt i64 %88, 0
  br i1 %89, label %90, label %91

90:                                               ; preds = %87
  tail call fastcc void @sample(ptr noundef nonnull %35) #8
  br label %91

91:                                               ; preds = %87, %90
  %92 = load ptr, ptr %10, align 8
  %93 = load i64, ptr %92, align 8
  %94 = load ptr, ptr %41, align 8
  %95 = load ptr, ptr %36, align 8
  %96 = load ptr, ptr %42, align 8
  %97 = load ptr, ptr %43, align 8
  %98 = load ptr, ptr %23, align 8
  %99 = getelementptr inbounds i8, ptr %92, i64 8
  %100 = load i64, ptr %99, align 8
  %101 = getelementptr inbounds double, ptr %98, i64 %100
  %102 = inttoptr i64 %93 to ptr
  %103 = load ptr, ptr %102, align 8
  %104 = tail call i32 %103(ptr noundef %94, ptr noundef %95, ptr noundef %96, ptr noundef %97, ptr noundef %101) #9
  %105 = load double, ptr %29, align 8
  %106 = fmul double %105, %15
  %107 = fcmp ogt double %106, 0.000000e+00
  %108 = select i1 %107, double %54, double %48
  %109 = select i1 %107, double %49, double %54
  br i1 %57, label %47, label %110

110:                                              ; preds = %52, %91, %47
  %111 = phi double [ %48, %52 ], [ %108, %91 ], [ %48, %47 ]
  %112 = phi double [ %49, %52 ], [ %109, %91 ], [ %49, %47 ]
  store double %112, ptr %9, align 8
  store double %111, ptr %8, align 8
  br label %113

113:                                              ; preds = %110, %44
  %114 = phi double [ %112, %110 ], [ %46, %44 ]
  ret double %114
}

define internal fastcc range(i32 0, 2) i32 @departs(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, double noundef %4, double noundef %5, double noundef %6, i64 noundef %7) unnamed_addr #2 {
  %9 = alloca double, align 8
  %10 = alloca double, align 8
  store double %4, ptr %9, align 8
  store double %5, ptr %10, align 8
  %11 = fadd double %2, %3
  %12 = tail call double @llvm.fabs.f64(double %11)
  %13 = tail call double @llvm.fabs.f64(double %2)
  %14 = fcmp ogt double %12, %13
  %15 = select i1 %14, double %12, double %13
  %16 = fmul double %15, 0x3CB0000000000000
  %17 = fdiv double %16, %3
  %18 = getelementptr inbounds i8, ptr %0, i64 936
  %19 = load ptr, ptr %18, align 8
  %20 = getelementptr inbounds i64, ptr %19, i64 %7
  %21 = load i64, ptr %20, align 8
  %22 = sitofp i64 %21 to double
  %23 = fmul double %22, %6
  %24 = fcmp olt double %23, 0.000000e+00
  br i1 %24, label %25, label %32

25:                                               ; preds = %8
  %26 = call fastcc i32 @comes_to_side(ptr noundef %0, ptr noundef %1, double noundef %2, double noundef %3, ptr noundef nonnull %9, ptr noundef nonnull %10, double noundef %17, i64 noundef %7) #8
  %27 = icmp eq i32 %26, 0
  br i1 %27, label %28, label %32

28:                                               ; preds = %25
  %29 = tail call fastcc double @turning_place(ptr noundef %0, ptr noundef %1, double noundef %2, double noundef %3, double noundef %4, double noundef %5, double noundef %17, i64 noundef %7) #8
  %30 = fcmp oeq double %29, 2.000000e+00
  %31 = zext i1 %30 to i32
  br label %32

32:                                               ; preds = %28, %25, %8
  %33 = phi i32 [ 0, %25 ], [ 0, %8 ], [ %31, %28 ]
  ret i32 %33
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
  br i1 %31, label %20, label %19, !llvm.loop !30

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
  br i1 %43, label %32, label %24, !llvm.loop !31
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #4

define internal fastcc void @settle(ptr noundef readonly %0) unnamed_addr #5 {
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
  br i1 %28, label %16, label %29, !llvm.loop !32

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
  br i1 %34, label %35, label %217

35:                                               ; preds = %8
  %36 = fcmp ogt double %26, %29
  %37 = select i1 %36, double %26, double %29
  %38 = fcmp ogt double %24, %37
  %39 = select i1 %38, double %24, double %37
  %40 = add nsw i32 %6, 1
  %41 = sext i32 %40 to i64
  %42 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %41
  %43 = load double, ptr %42, align 8
  %44 = sext i32 %6 to i64
  %45 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = add nsw i32 %6, -1
  %48 = sext i32 %47 to i64
  %49 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = icmp sgt i32 %7, 1
  %52 = add nsw i32 %7, -1
  %53 = zext nneg i32 %52 to i64
  %54 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %53
  %55 = icmp slt i32 %7, 4
  %56 = sext i32 %7 to i64
  %57 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %56
  %58 = getelementptr inbounds i8, ptr %0, i64 144
  %59 = getelementptr inbounds i8, ptr %0, i64 1032
  %60 = getelementptr inbounds i8, ptr %1, i64 16
  %61 = getelementptr inbounds i8, ptr %1, i64 8
  %62 = getelementptr inbounds i8, ptr %0, i64 168
  %63 = getelementptr inbounds i8, ptr %0, i64 248
  %64 = getelementptr inbounds i8, ptr %0, i64 168
  %65 = getelementptr inbounds i8, ptr %0, i64 192
  %66 = getelementptr inbounds i8, ptr %0, i64 792
  %67 = fmul double %39, 0xBCE0000000000000
  br label %72

68:                                               ; preds = %204
  %69 = add nuw nsw i32 %82, 1
  %70 = icmp ugt i32 %82, 18
  %71 = icmp eq i32 %69, 20
  br i1 %71, label %214, label %72, !llvm.loop !35

72:                                               ; preds = %35, %68
  %73 = phi i1 [ false, %35 ], [ %70, %68 ]
  %74 = phi double [ undef, %35 ], [ %213, %68 ]
  %75 = phi double [ %50, %35 ], [ %212, %68 ]
  %76 = phi double [ %46, %35 ], [ %211, %68 ]
  %77 = phi double [ %43, %35 ], [ %210, %68 ]
  %78 = phi double [ 0x7FF0000000000000, %35 ], [ %209, %68 ]
  %79 = phi double [ %24, %35 ], [ %208, %68 ]
  %80 = phi double [ %26, %35 ], [ %207, %68 ]
  %81 = phi double [ %29, %35 ], [ %206, %68 ]
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
  br i1 %97, label %98, label %204

98:                                               ; preds = %72
  %99 = fsub double %96, %76
  %100 = fmul double %94, %99
  %101 = fadd double %80, %100
  %102 = fmul double %78, 2.000000e+00
  %103 = fcmp ugt double %101, %102
  br i1 %103, label %204, label %104

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
  br i1 %117, label %204, label %118

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
  br i1 %137, label %204, label %138

138:                                              ; preds = %126
  %139 = load ptr, ptr %59, align 8
  %140 = load ptr, ptr %60, align 8
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
  %155 = load ptr, ptr %61, align 8
  %156 = load ptr, ptr %155, align 8
  %157 = getelementptr inbounds i8, ptr %156, i64 16
  %158 = load i64, ptr %157, align 8
  tail call fastcc void @nested(ptr noundef %139, ptr noundef %145, ptr noundef %147, i64 noundef %149, i64 noundef %153, ptr noundef %154, i64 noundef %158) #8
  %159 = fmul double %127, %3
  %160 = fadd double %159, %2
  %161 = load ptr, ptr %62, align 8
  store double %160, ptr %161, align 8
  %162 = load ptr, ptr %58, align 8
  %163 = getelementptr inbounds i8, ptr %162, i64 40
  %164 = load i64, ptr %163, align 8
  %165 = icmp eq i64 %164, 0
  br i1 %165, label %167, label %166

166:                                              ; preds = %138
  tail call fastcc void @settle(ptr noundef nonnull %58) #8
  br label %167

167:                                              ; preds = %166, %138
  %168 = load i64, ptr %63, align 8
  %169 = icmp sgt i64 %168, 0
  br i1 %169, label %170, label %171

170:                                              ; preds = %167
  tail call fastcc void @sample(ptr noundef nonnull %58) #8
  br label %171

171:                                              ; preds = %167, %170
  %172 = load ptr, ptr %9, align 8
  %173 = load i64, ptr %172, align 8
  %174 = load ptr, ptr %64, align 8
  %175 = load ptr, ptr %59, align 8
  %176 = load ptr, ptr %65, align 8
  %177 = load ptr, ptr %66, align 8
  %178 = load ptr, ptr %13, align 8
  %179 = inttoptr i64 %173 to ptr
  %180 = load ptr, ptr %179, align 8
  %181 = tail call i32 %180(ptr noundef %174, ptr noundef %175, ptr noundef %176, ptr noundef %177, ptr noundef %178) #9
  %182 = icmp slt i32 %181, 0
  br i1 %182, label %204, label %183

183:                                              ; preds = %171
  %184 = load double, ptr %15, align 8
  %185 = fmul double %184, %5
  %186 = fcmp olt double %185, 0.000000e+00
  br i1 %186, label %187, label %190

187:                                              ; preds = %183
  %188 = fcmp olt double %185, %67
  %189 = select i1 %188, double %127, double 2.000000e+00
  br label %204

190:                                              ; preds = %183
  %191 = fsub double %185, %132
  %192 = tail call double @llvm.fabs.f64(double %191)
  %193 = fcmp uge double %127, %76
  %194 = fcmp ugt double %185, %80
  %195 = or i1 %193, %194
  br i1 %195, label %196, label %204

196:                                              ; preds = %190
  br i1 %193, label %197, label %204

197:                                              ; preds = %196
  %198 = select i1 %194, double %185, double %81
  %199 = select i1 %194, double %80, double %185
  %200 = select i1 %194, double %79, double %80
  %201 = select i1 %194, double %127, double %77
  %202 = select i1 %194, double %76, double %127
  %203 = select i1 %194, double %75, double %76
  br label %204

204:                                              ; preds = %114, %187, %197, %196, %190, %171, %126, %72, %98
  %205 = phi i1 [ false, %98 ], [ false, %72 ], [ false, %114 ], [ false, %126 ], [ false, %171 ], [ false, %187 ], [ true, %197 ], [ true, %196 ], [ true, %190 ]
  %206 = phi double [ %81, %98 ], [ %81, %72 ], [ %81, %114 ], [ %81, %126 ], [ %81, %171 ], [ %81, %187 ], [ %198, %197 ], [ %81, %196 ], [ %80, %190 ]
  %207 = phi double [ %80, %98 ], [ %80, %72 ], [ %80, %114 ], [ %80, %126 ], [ %80, %171 ], [ %80, %187 ], [ %199, %197 ], [ %80, %196 ], [ %185, %190 ]
  %208 = phi double [ %79, %98 ], [ %79, %72 ], [ %79, %114 ], [ %79, %126 ], [ %79, %171 ], [ %79, %187 ], [ %200, %197 ], [ %185, %196 ], [ %79, %190 ]
  %209 = phi double [ %78, %98 ], [ %78, %72 ], [ %78, %114 ], [ %78, %126 ], [ %78, %171 ], [ %78, %187 ], [ %192, %197 ], [ %192, %196 ], [ %192, %190 ]
  %210 = phi double [ %77, %98 ], [ %77, %72 ], [ %77, %114 ], [ %77, %126 ], [ %77, %171 ], [ %77, %187 ], [ %201, %197 ], [ %77, %196 ], [ %76, %190 ]
  %211 = phi double [ %76, %98 ], [ %76, %72 ], [ %76, %114 ], [ %76, %126 ], [ %76, %171 ], [ %76, %187 ], [ %202, %197 ], [ %76, %196 ], [ %127, %190 ]
  %212 = phi double [ %75, %98 ], [ %75, %72 ], [ %75, %114 ], [ %75, %126 ], [ %75, %171 ], [ %75, %187 ], [ %203, %197 ], [ %127, %196 ], [ %75, %190 ]
  %213 = phi double [ 2.000000e+00, %98 ], [ 2.000000e+00, %72 ], [ 2.000000e+00, %114 ], [ 2.000000e+00, %126 ], [ -4.000000e+00, %171 ], [ %189, %187 ], [ %74, %197 ], [ %74, %196 ], [ %74, %190 ]
  br i1 %205, label %68, label %214

214:                                              ; preds = %68, %204
  %215 = phi i1 [ %70, %68 ], [ %73, %204 ]
  br i1 %215, label %216, label %217

216:                                              ; preds = %214
  br label %217

217:                                              ; preds = %8, %214, %216
  %218 = phi double [ 2.000000e+00, %216 ], [ %213, %214 ], [ 2.000000e+00, %8 ]
  ret double %218
}

define internal fastcc range(i32 0, 2) i32 @comes_to_side(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, ptr noundef %4, ptr noundef %5, double noundef %6, i64 noundef %7) unnamed_addr #2 {
  %9 = getelementptr inbounds i8, ptr %0, i64 768
  %10 = getelementptr inbounds i8, ptr %0, i64 936
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i64, ptr %11, i64 %7
  %13 = load i64, ptr %12, align 8
  %14 = sitofp i64 %13 to double
  %15 = load double, ptr %4, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 984
  %17 = load ptr, ptr %16, align 8
  %18 = load ptr, ptr %9, align 8
  %19 = getelementptr inbounds i8, ptr %18, i64 8
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr inbounds double, ptr %17, i64 %20
  %22 = getelementptr inbounds double, ptr %21, i64 %7
  %23 = getelementptr inbounds i8, ptr %0, i64 144
  %24 = getelementptr inbounds i8, ptr %0, i64 1032
  %25 = load ptr, ptr %24, align 8
  %26 = getelementptr inbounds i8, ptr %1, i64 16
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds i8, ptr %27, i64 96
  %29 = load ptr, ptr %28, align 8
  %30 = insertelement <8 x double> poison, double %15, i64 0
  %31 = shufflevector <8 x double> %30, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %31, ptr %29, align 8
  %32 = load ptr, ptr %27, align 8
  %33 = getelementptr inbounds i8, ptr %27, i64 192
  %34 = load ptr, ptr %33, align 8
  %35 = getelementptr inbounds i8, ptr %27, i64 8
  %36 = load i64, ptr %35, align 8
  %37 = load ptr, ptr %1, align 8
  %38 = load ptr, ptr %37, align 8
  %39 = getelementptr inbounds i8, ptr %38, i64 24
  %40 = load i64, ptr %39, align 8
  %41 = load ptr, ptr %28, align 8
  %42 = getelementptr inbounds i8, ptr %1, i64 8
  %43 = load ptr, ptr %42, align 8
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr inbounds i8, ptr %44, i64 16
  %46 = load i64, ptr %45, align 8
  tail call fastcc void @nested(ptr noundef %25, ptr noundef %32, ptr noundef %34, i64 noundef %36, i64 noundef %40, ptr noundef %41, i64 noundef %46) #8
  %47 = fmul double %15, %3
  %48 = fadd double %47, %2
  %49 = getelementptr inbounds i8, ptr %0, i64 168
  %50 = load ptr, ptr %49, align 8
  store double %48, ptr %50, align 8
  %51 = load ptr, ptr %23, align 8
  %52 = getelementptr inbounds i8, ptr %51, i64 40
  %53 = load i64, ptr %52, align 8
  %54 = icmp eq i64 %53, 0
  br i1 %54, label %56, label %55

55:                                               ; preds = %8
  tail call fastcc void @settle(ptr noundef nonnull %23) #8
  br label %56

56:                                               ; preds = %55, %8
  %57 = getelementptr inbounds i8, ptr %0, i64 248
  %58 = load i64, ptr %57, align 8
  %59 = icmp sgt i64 %58, 0
  br i1 %59, label %60, label %61

60:                                               ; preds = %56
  tail call fastcc void @sample(ptr noundef nonnull %23) #8
  br label %61

61:                                               ; preds = %56, %60
  %62 = load ptr, ptr %9, align 8
  %63 = load i64, ptr %62, align 8
  %64 = getelementptr inbounds i8, ptr %0, i64 168
  %65 = load ptr, ptr %64, align 8
  %66 = load ptr, ptr %24, align 8
  %67 = getelementptr inbounds i8, ptr %0, i64 192
  %68 = load ptr, ptr %67, align 8
  %69 = getelementptr inbounds i8, ptr %0, i64 792
  %70 = load ptr, ptr %69, align 8
  %71 = load ptr, ptr %16, align 8
  %72 = getelementptr inbounds i8, ptr %62, i64 8
  %73 = load i64, ptr %72, align 8
  %74 = getelementptr inbounds double, ptr %71, i64 %73
  %75 = inttoptr i64 %63 to ptr
  %76 = load ptr, ptr %75, align 8
  %77 = tail call i32 %76(ptr noundef %65, ptr noundef %66, ptr noundef %68, ptr noundef %70, ptr noundef %74) #9
  %78 = load double, ptr %22, align 8
  %79 = fmul double %78, %14
  %80 = fcmp ugt double %79, 0.000000e+00
  br i1 %80, label %146, label %81

81:                                               ; preds = %61
  %82 = load double, ptr %5, align 8
  %83 = fsub double %82, %15
  %84 = fmul double %83, 5.000000e-01
  %85 = fadd double %15, %84
  %86 = fsub double %85, %15
  %87 = fcmp olt double %86, %6
  br i1 %87, label %146, label %88

88:                                               ; preds = %81, %140
  %89 = phi double [ %143, %140 ], [ %85, %81 ]
  %90 = load ptr, ptr %24, align 8
  %91 = load ptr, ptr %26, align 8
  %92 = getelementptr inbounds i8, ptr %91, i64 96
  %93 = load ptr, ptr %92, align 8
  %94 = insertelement <8 x double> poison, double %89, i64 0
  %95 = shufflevector <8 x double> %94, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %95, ptr %93, align 8
  %96 = load ptr, ptr %91, align 8
  %97 = getelementptr inbounds i8, ptr %91, i64 192
  %98 = load ptr, ptr %97, align 8
  %99 = getelementptr inbounds i8, ptr %91, i64 8
  %100 = load i64, ptr %99, align 8
  %101 = load ptr, ptr %1, align 8
  %102 = load ptr, ptr %101, align 8
  %103 = getelementptr inbounds i8, ptr %102, i64 24
  %104 = load i64, ptr %103, align 8
  %105 = load ptr, ptr %92, align 8
  %106 = load ptr, ptr %42, align 8
  %107 = load ptr, ptr %106, align 8
  %108 = getelementptr inbounds i8, ptr %107, i64 16
  %109 = load i64, ptr %108, align 8
  tail call fastcc void @nested(ptr noundef %90, ptr noundef %96, ptr noundef %98, i64 noundef %100, i64 noundef %104, ptr noundef %105, i64 noundef %109) #8
  %110 = fmul double %89, %3
  %111 = fadd double %110, %2
  %112 = load ptr, ptr %49, align 8
  store double %111, ptr %112, align 8
  %113 = load ptr, ptr %23, align 8
  %114 = getelementptr inbounds i8, ptr %113, i64 40
  %115 = load i64, ptr %114, align 8
  %116 = icmp eq i64 %115, 0
  br i1 %116, label %118, label %117

117:                                              ; preds = %88
  tail call fastcc void @settle(ptr noundef nonnull %23) #8
  br label %118

118:                                              ; preds = %117, %88
  %119 = load i64, ptr %57, align 8
  %120 = icmp sgt i64 %119, 0
  br i1 %120, label %121, label %122

121:                                              ; preds = %118
  tail call fastcc void @sample(ptr noundef nonnull %23) #8
  br label %122

122:                                              ; preds = %118, %121
  %123 = load ptr, ptr %9, align 8
  %124 = load i64, ptr %123, align 8
  %125 = load ptr, ptr %64, align 8
  %126 = load ptr, ptr %24, align 8
  %127 = load ptr, ptr %67, align 8
  %128 = load ptr, ptr %69, align 8
  %129 = load ptr, ptr %16, align 8
  %130 = getelementptr inbounds i8, ptr %123, i64 8
  %131 = load i64, ptr %130, align 8
  %132 = getelementptr inbounds double, ptr %129, i64 %131
  %133 = inttoptr i64 %124 to ptr
  %134 = load ptr, ptr %133, align 8
  %135 = tail call i32 %134(ptr noundef %125, ptr noundef %126, ptr noundef %127, ptr noundef %128, ptr noundef %132) #9
  %136 = load double, ptr %22, align 8
  %137 = fmul double %136, %14
  %138 = fcmp ogt double %137, 0.000000e+00
  br i1 %138, label %139, label %140

139:                                              ; preds = %122
  store double %89, ptr %4, align 8
  br label %146

140:                                              ; preds = %122
  store double %89, ptr %5, align 8
  %141 = fsub double %89, %15
  %142 = fmul double %141, 5.000000e-01
  %143 = fadd double %15, %142
  %144 = fsub double %143, %15
  %145 = fcmp olt double %144, %6
  br i1 %145, label %146, label %88, !llvm.loop !36

146:                                              ; preds = %140, %81, %139, %61
  %147 = phi i32 [ 1, %61 ], [ 1, %139 ], [ 0, %81 ], [ 0, %140 ]
  ret i32 %147
}

define internal fastcc double @turning_place(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, double noundef %4, double noundef %5, double noundef %6, i64 noundef %7) unnamed_addr #2 {
  %9 = getelementptr inbounds i8, ptr %0, i64 768
  %10 = getelementptr inbounds i8, ptr %0, i64 144
  %11 = getelementptr inbounds i8, ptr %0, i64 1032
  %12 = getelementptr inbounds i8, ptr %1, i64 16
  %13 = getelementptr inbounds i8, ptr %1, i64 8
  %14 = getelementptr inbounds i8, ptr %0, i64 168
  %15 = getelementptr inbounds i8, ptr %0, i64 248
  %16 = getelementptr inbounds i8, ptr %0, i64 168
  %17 = getelementptr inbounds i8, ptr %0, i64 192
  %18 = getelementptr inbounds i8, ptr %0, i64 1152
  %19 = getelementptr inbounds i8, ptr %0, i64 1200
  %20 = getelementptr inbounds i8, ptr %0, i64 936
  %21 = insertelement <8 x double> poison, double %4, i64 0
  %22 = shufflevector <8 x double> %21, <8 x double> poison, <8 x i32> zeroinitializer
  %23 = fmul double %3, %4
  %24 = fadd double %23, %2
  %25 = getelementptr inbounds i8, ptr %0, i64 936
  br label %26

26:                                               ; preds = %152, %8
  %27 = phi double [ 2.000000e+00, %8 ], [ %87, %152 ]
  %28 = phi double [ %5, %8 ], [ %153, %152 ]
  %29 = phi double [ undef, %8 ], [ %151, %152 ]
  %30 = load ptr, ptr %11, align 8
  %31 = load ptr, ptr %12, align 8
  %32 = getelementptr inbounds i8, ptr %31, i64 96
  %33 = load ptr, ptr %32, align 8
  %34 = insertelement <8 x double> poison, double %28, i64 0
  %35 = shufflevector <8 x double> %34, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %35, ptr %33, align 8
  %36 = load ptr, ptr %31, align 8
  %37 = getelementptr inbounds i8, ptr %31, i64 192
  %38 = load ptr, ptr %37, align 8
  %39 = getelementptr inbounds i8, ptr %31, i64 8
  %40 = load i64, ptr %39, align 8
  %41 = load ptr, ptr %1, align 8
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds i8, ptr %42, i64 24
  %44 = load i64, ptr %43, align 8
  %45 = load ptr, ptr %32, align 8
  %46 = load ptr, ptr %13, align 8
  %47 = load ptr, ptr %46, align 8
  %48 = getelementptr inbounds i8, ptr %47, i64 16
  %49 = load i64, ptr %48, align 8
  tail call fastcc void @nested(ptr noundef %30, ptr noundef %36, ptr noundef %38, i64 noundef %40, i64 noundef %44, ptr noundef %45, i64 noundef %49) #8
  %50 = fmul double %28, %3
  %51 = fadd double %50, %2
  %52 = load ptr, ptr %14, align 8
  store double %51, ptr %52, align 8
  %53 = load ptr, ptr %10, align 8
  %54 = getelementptr inbounds i8, ptr %53, i64 40
  %55 = load i64, ptr %54, align 8
  %56 = icmp eq i64 %55, 0
  br i1 %56, label %58, label %57

57:                                               ; preds = %26
  tail call fastcc void @settle(ptr noundef nonnull %10) #8
  br label %58

58:                                               ; preds = %57, %26
  %59 = load i64, ptr %15, align 8
  %60 = icmp sgt i64 %59, 0
  br i1 %60, label %61, label %62

61:                                               ; preds = %58
  tail call fastcc void @sample(ptr noundef nonnull %10) #8
  br label %62

62:                                               ; preds = %61, %58
  %63 = load ptr, ptr %9, align 8
  %64 = getelementptr inbounds i8, ptr %63, i64 56
  %65 = load i64, ptr %64, align 8
  %66 = load ptr, ptr %16, align 8
  %67 = load ptr, ptr %11, align 8
  %68 = load ptr, ptr %17, align 8
  %69 = load ptr, ptr %18, align 8
  %70 = load ptr, ptr %19, align 8
  %71 = inttoptr i64 %65 to ptr
  %72 = load ptr, ptr %71, align 8
  %73 = tail call i32 %72(ptr noundef %66, ptr noundef %67, ptr noundef %68, ptr noundef %69, ptr noundef %70) #9
  %74 = icmp eq i32 %73, 0
  br i1 %74, label %75, label %85

75:                                               ; preds = %62
  %76 = load ptr, ptr %19, align 8
  %77 = getelementptr inbounds double, ptr %76, i64 %7
  %78 = load double, ptr %77, align 8
  %79 = load ptr, ptr %20, align 8
  %80 = getelementptr inbounds i64, ptr %79, i64 %7
  %81 = load i64, ptr %80, align 8
  %82 = sitofp i64 %81 to double
  %83 = fmul double %78, %82
  %84 = fcmp ogt double %83, 0.000000e+00
  br label %85

85:                                               ; preds = %62, %75
  %86 = phi i1 [ false, %62 ], [ %84, %75 ]
  %87 = select i1 %86, double %27, double %28
  %88 = fsub double %28, %4
  %89 = fmul double %88, 5.000000e-01
  %90 = fcmp uge double %89, %6
  %91 = select i1 %90, i1 true, i1 %86
  %92 = select i1 %90, double %29, double %87
  br i1 %91, label %150, label %93

93:                                               ; preds = %85
  %94 = load ptr, ptr %11, align 8
  %95 = load ptr, ptr %12, align 8
  %96 = getelementptr inbounds i8, ptr %95, i64 96
  %97 = load ptr, ptr %96, align 8
  store <8 x double> %22, ptr %97, align 8
  %98 = load ptr, ptr %95, align 8
  %99 = getelementptr inbounds i8, ptr %95, i64 192
  %100 = load ptr, ptr %99, align 8
  %101 = getelementptr inbounds i8, ptr %95, i64 8
  %102 = load i64, ptr %101, align 8
  %103 = load ptr, ptr %1, align 8
  %104 = load ptr, ptr %103, align 8
  %105 = getelementptr inbounds i8, ptr %104, i64 24
  %106 = load i64, ptr %105, align 8
  %107 = load ptr, ptr %96, align 8
  %108 = load ptr, ptr %13, align 8
  %109 = load ptr, ptr %108, align 8
  %110 = getelementptr inbounds i8, ptr %109, i64 16
  %111 = load i64, ptr %110, align 8
  tail call fastcc void @nested(ptr noundef %94, ptr noundef %98, ptr noundef %100, i64 noundef %102, i64 noundef %106, ptr noundef %107, i64 noundef %111) #8
  %112 = load ptr, ptr %14, align 8
  store double %24, ptr %112, align 8
  %113 = load ptr, ptr %10, align 8
  %114 = getelementptr inbounds i8, ptr %113, i64 40
  %115 = load i64, ptr %114, align 8
  %116 = icmp eq i64 %115, 0
  br i1 %116, label %118, label %117

117:                                              ; preds = %93
  tail call fastcc void @settle(ptr noundef nonnull %10) #8
  br label %118

118:                                              ; preds = %117, %93
  %119 = load i64, ptr %15, align 8
  %120 = icmp sgt i64 %119, 0
  br i1 %120, label %121, label %122

121:                                              ; preds = %118
  tail call fastcc void @sample(ptr noundef nonnull %10) #8
  br label %122

122:                                              ; preds = %121, %118
  %123 = load ptr, ptr %9, align 8
  %124 = getelementptr inbounds i8, ptr %123, i64 56
  %125 = load i64, ptr %124, align 8
  %126 = load ptr, ptr %16, align 8
  %127 = load ptr, ptr %11, align 8
  %128 = load ptr, ptr %17, align 8
  %129 = load ptr, ptr %18, align 8
  %130 = load ptr, ptr %19, align 8
  %131 = inttoptr i64 %125 to ptr
  %132 = load ptr, ptr %131, align 8
  %133 = tail call i32 %132(ptr noundef %126, ptr noundef %127, ptr noundef %128, ptr noundef %129, ptr noundef %130) #9
  %134 = icmp eq i32 %133, 0
  br i1 %134, label %135, label %146

135:                                              ; preds = %122
  %136 = load ptr, ptr %19, align 8
  %137 = getelementptr inbounds double, ptr %136, i64 %7
  %138 = load double, ptr %137, align 8
  %139 = load ptr, ptr %25, align 8
  %140 = getelementptr inbounds i64, ptr %139, i64 %7
  %141 = load i64, ptr %140, align 8
  %142 = sitofp i64 %141 to double
  %143 = fmul double %138, %142
  %144 = fcmp ogt double %143, 0.000000e+00
  %145 = zext i1 %144 to i32
  br label %146

146:                                              ; preds = %122, %135
  %147 = phi i32 [ 0, %122 ], [ %145, %135 ]
  %148 = icmp eq i32 %147, 0
  br i1 %148, label %149, label %150

149:                                              ; preds = %146
  br label %150

150:                                              ; preds = %85, %149, %146
  %151 = phi double [ %4, %149 ], [ %87, %146 ], [ %92, %85 ]
  br i1 %90, label %152, label %154

152:                                              ; preds = %150
  %153 = fadd double %89, %4
  br label %26, !llvm.loop !37

154:                                              ; preds = %150
  ret double %151
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
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5}
!35 = distinct !{!35, !4, !5}
!36 = distinct !{!36, !5}
!37 = distinct !{!37, !5}
