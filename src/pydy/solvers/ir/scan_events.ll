; sources 071fb5939804b170e978d345350793d3b3eeb191fe0ab5432695dacd2bed3c13
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
  br label %1071

102:                                              ; preds = %49, %122
  %103 = phi i64 [ 0, %49 ], [ %123, %122 ]
  %104 = load double, ptr %30, align 8
  %105 = fcmp une double %104, %1
  br i1 %105, label %108, label %106

106:                                              ; preds = %102, %122, %47
  %107 = call fastcc i64 @resolve(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2) #8
  switch i64 %107, label %1075 [
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
  br label %1071

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
  br label %1071

193:                                              ; preds = %170, %129
  store double 0x7FF8000000000000, ptr %30, align 8
  %194 = getelementptr inbounds i8, ptr %0, i64 1032
  %195 = load ptr, ptr %7, align 8
  %196 = getelementptr inbounds i8, ptr %195, i64 96
  %197 = getelementptr inbounds i8, ptr %195, i64 192
  %198 = getelementptr inbounds i8, ptr %195, i64 8
  %199 = load ptr, ptr %4, align 8
  %200 = load ptr, ptr %5, align 8
  %201 = getelementptr inbounds i8, ptr %0, i64 168
  %202 = getelementptr inbounds i8, ptr %0, i64 248
  %203 = getelementptr inbounds i8, ptr %0, i64 168
  %204 = getelementptr inbounds i8, ptr %0, i64 192
  %205 = getelementptr inbounds i8, ptr %0, i64 792
  %206 = icmp sgt i64 %12, 0
  %207 = getelementptr inbounds i8, ptr %0, i64 1032
  %208 = load ptr, ptr %7, align 8
  %209 = getelementptr inbounds i8, ptr %208, i64 96
  %210 = getelementptr inbounds i8, ptr %208, i64 192
  %211 = getelementptr inbounds i8, ptr %208, i64 8
  %212 = load ptr, ptr %4, align 8
  %213 = load ptr, ptr %5, align 8
  %214 = getelementptr inbounds i8, ptr %0, i64 168
  %215 = getelementptr inbounds i8, ptr %0, i64 248
  %216 = getelementptr inbounds i8, ptr %0, i64 168
  %217 = getelementptr inbounds i8, ptr %0, i64 192
  %218 = getelementptr inbounds i8, ptr %0, i64 792
  %219 = icmp sgt i64 %12, 0
  %220 = icmp sgt i64 %12, 0
  %221 = getelementptr inbounds i8, ptr %0, i64 840
  %222 = getelementptr inbounds i8, ptr %24, i64 48
  %223 = getelementptr inbounds i8, ptr %0, i64 672
  %224 = getelementptr inbounds i8, ptr %0, i64 680
  %225 = fadd double %1, %2
  %226 = tail call double @llvm.fabs.f64(double %225)
  %227 = getelementptr inbounds i8, ptr %0, i64 1016
  %228 = getelementptr inbounds i8, ptr %0, i64 1008
  %229 = icmp sgt i64 %12, 0
  %230 = getelementptr inbounds i8, ptr %0, i64 1064
  %231 = getelementptr inbounds i8, ptr %0, i64 1056
  %232 = getelementptr inbounds i8, ptr %0, i64 1080
  %233 = getelementptr inbounds i8, ptr %0, i64 1128
  %234 = getelementptr inbounds i8, ptr %0, i64 1104
  %235 = getelementptr inbounds i8, ptr %0, i64 672
  %236 = getelementptr inbounds i8, ptr %0, i64 680
  %237 = fadd double %1, %2
  %238 = tail call double @llvm.fabs.f64(double %237)
  %239 = getelementptr inbounds i8, ptr %0, i64 1016
  %240 = getelementptr inbounds i8, ptr %0, i64 1008
  %241 = getelementptr inbounds i8, ptr %0, i64 1064
  %242 = getelementptr inbounds i8, ptr %24, i64 48
  %243 = icmp sgt i64 %12, 0
  %244 = getelementptr inbounds i8, ptr %24, i64 48
  %245 = icmp sgt i64 %12, 0
  %246 = getelementptr inbounds i8, ptr %0, i64 1016
  %247 = getelementptr inbounds i8, ptr %0, i64 1008
  br label %248

248:                                              ; preds = %193, %1050
  %249 = phi i1 [ false, %193 ], [ %1054, %1050 ]
  %250 = phi i64 [ -4, %193 ], [ %1048, %1050 ]
  %251 = phi double [ 0.000000e+00, %193 ], [ %1047, %1050 ]
  %252 = phi i32 [ 1, %193 ], [ %1053, %1050 ]
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
  br i1 %304, label %1040, label %305

305:                                              ; preds = %302
  %306 = getelementptr double, ptr %28, i64 %256
  %307 = fcmp olt double %303, %255
  br i1 %307, label %308, label %348

308:                                              ; preds = %305
  %309 = load ptr, ptr %25, align 8
  %310 = load ptr, ptr %194, align 8
  %311 = load ptr, ptr %196, align 8
  %312 = insertelement <8 x double> poison, double %303, i64 0
  %313 = shufflevector <8 x double> %312, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %313, ptr %311, align 8
  %314 = load ptr, ptr %195, align 8
  %315 = load ptr, ptr %197, align 8
  %316 = load i64, ptr %198, align 8
  %317 = load ptr, ptr %199, align 8
  %318 = getelementptr inbounds i8, ptr %317, i64 24
  %319 = load i64, ptr %318, align 8
  %320 = load ptr, ptr %196, align 8
  %321 = load ptr, ptr %200, align 8
  %322 = getelementptr inbounds i8, ptr %321, i64 16
  %323 = load i64, ptr %322, align 8
  tail call fastcc void @nested(ptr noundef %310, ptr noundef %314, ptr noundef %315, i64 noundef %316, i64 noundef %319, ptr noundef %320, i64 noundef %323) #8
  %324 = fmul double %303, %2
  %325 = fadd double %324, %1
  %326 = load ptr, ptr %201, align 8
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
  %333 = load i64, ptr %202, align 8
  %334 = icmp sgt i64 %333, 0
  br i1 %334, label %335, label %336

335:                                              ; preds = %332
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %336

336:                                              ; preds = %332, %335
  %337 = load ptr, ptr %9, align 8
  %338 = load i64, ptr %337, align 8
  %339 = load ptr, ptr %203, align 8
  %340 = load ptr, ptr %194, align 8
  %341 = load ptr, ptr %204, align 8
  %342 = load ptr, ptr %205, align 8
  %343 = load ptr, ptr %25, align 8
  %344 = inttoptr i64 %338 to ptr
  %345 = load ptr, ptr %344, align 8
  %346 = tail call i32 %345(ptr noundef %339, ptr noundef %340, ptr noundef %341, ptr noundef %342, ptr noundef %343) #9
  %347 = icmp slt i32 %346, 0
  br i1 %347, label %1040, label %348

348:                                              ; preds = %336, %305
  %349 = phi double [ %303, %336 ], [ %255, %305 ]
  %350 = phi ptr [ %309, %336 ], [ %306, %305 ]
  br label %351

351:                                              ; preds = %984, %348
  %352 = phi double [ %251, %348 ], [ %986, %984 ]
  %353 = phi i64 [ %250, %348 ], [ %987, %984 ]
  br i1 %206, label %357, label %354

354:                                              ; preds = %392, %351
  %355 = phi double [ 2.000000e+00, %351 ], [ %393, %392 ]
  %356 = fcmp ogt double %355, 1.000000e+00
  br i1 %356, label %984, label %396

357:                                              ; preds = %351, %392
  %358 = phi i64 [ %394, %392 ], [ 0, %351 ]
  %359 = phi double [ %393, %392 ], [ 2.000000e+00, %351 ]
  %360 = getelementptr inbounds i64, ptr %18, i64 %358
  store i64 0, ptr %360, align 8
  %361 = getelementptr inbounds i64, ptr %16, i64 %358
  %362 = load i64, ptr %361, align 8
  %363 = getelementptr inbounds double, ptr %350, i64 %358
  %364 = load double, ptr %363, align 8
  %365 = getelementptr inbounds i64, ptr %14, i64 %358
  %366 = load i64, ptr %365, align 8
  %367 = icmp slt i64 %362, 0
  %368 = fcmp ogt double %364, 0.000000e+00
  %369 = and i1 %367, %368
  %370 = icmp sgt i64 %366, -1
  %371 = and i1 %369, %370
  br i1 %371, label %379, label %372

372:                                              ; preds = %357
  %373 = icmp sgt i64 %362, 0
  %374 = fcmp olt double %364, 0.000000e+00
  %375 = and i1 %373, %374
  br i1 %375, label %376, label %379

376:                                              ; preds = %372
  %377 = icmp slt i64 %366, 1
  %378 = zext i1 %377 to i32
  br label %379

379:                                              ; preds = %357, %372, %376
  %380 = phi i32 [ 1, %357 ], [ 0, %372 ], [ %378, %376 ]
  %381 = icmp eq i32 %380, 0
  br i1 %381, label %382, label %386

382:                                              ; preds = %379
  %383 = icmp eq i64 %362, 0
  %384 = fcmp ord double %364, 0.000000e+00
  %385 = or i1 %383, %384
  br i1 %385, label %392, label %386

386:                                              ; preds = %382, %379
  %387 = call fastcc double @locate(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %352, double noundef %349, i64 noundef %358) #8
  %388 = fcmp ole double %387, %352
  %389 = zext i1 %388 to i64
  store i64 %389, ptr %360, align 8
  %390 = fcmp olt double %387, %359
  %391 = select i1 %390, double %387, double %359
  br label %392

392:                                              ; preds = %382, %386
  %393 = phi double [ %391, %386 ], [ %359, %382 ]
  %394 = add nuw nsw i64 %358, 1
  %395 = icmp eq i64 %394, %12
  br i1 %395, label %354, label %357, !llvm.loop !9

396:                                              ; preds = %354
  %397 = load ptr, ptr %207, align 8
  %398 = load ptr, ptr %209, align 8
  %399 = insertelement <8 x double> poison, double %355, i64 0
  %400 = shufflevector <8 x double> %399, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %400, ptr %398, align 8
  %401 = load ptr, ptr %208, align 8
  %402 = load ptr, ptr %210, align 8
  %403 = load i64, ptr %211, align 8
  %404 = load ptr, ptr %212, align 8
  %405 = getelementptr inbounds i8, ptr %404, i64 24
  %406 = load i64, ptr %405, align 8
  %407 = load ptr, ptr %209, align 8
  %408 = load ptr, ptr %213, align 8
  %409 = getelementptr inbounds i8, ptr %408, i64 16
  %410 = load i64, ptr %409, align 8
  tail call fastcc void @nested(ptr noundef %397, ptr noundef %401, ptr noundef %402, i64 noundef %403, i64 noundef %406, ptr noundef %407, i64 noundef %410) #8
  %411 = fmul double %355, %2
  %412 = fadd double %411, %1
  %413 = load ptr, ptr %214, align 8
  store double %412, ptr %413, align 8
  %414 = load ptr, ptr %6, align 8
  %415 = getelementptr inbounds i8, ptr %414, i64 40
  %416 = load i64, ptr %415, align 8
  %417 = icmp eq i64 %416, 0
  br i1 %417, label %419, label %418

418:                                              ; preds = %396
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %419

419:                                              ; preds = %418, %396
  %420 = load i64, ptr %215, align 8
  %421 = icmp sgt i64 %420, 0
  br i1 %421, label %422, label %423

422:                                              ; preds = %419
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %423

423:                                              ; preds = %419, %422
  %424 = load ptr, ptr %9, align 8
  %425 = load i64, ptr %424, align 8
  %426 = load ptr, ptr %216, align 8
  %427 = load ptr, ptr %207, align 8
  %428 = load ptr, ptr %217, align 8
  %429 = load ptr, ptr %218, align 8
  %430 = load ptr, ptr %25, align 8
  %431 = getelementptr inbounds i8, ptr %424, i64 8
  %432 = load i64, ptr %431, align 8
  %433 = getelementptr inbounds double, ptr %430, i64 %432
  %434 = inttoptr i64 %425 to ptr
  %435 = load ptr, ptr %434, align 8
  %436 = tail call i32 %435(ptr noundef %426, ptr noundef %427, ptr noundef %428, ptr noundef %429, ptr noundef %433) #9
  %437 = icmp slt i32 %436, 0
  br i1 %437, label %439, label %438

438:                                              ; preds = %423
  br i1 %219, label %444, label %547

439:                                              ; preds = %423
  %440 = load ptr, ptr %20, align 8
  %441 = getelementptr inbounds i8, ptr %440, i64 80
  store i64 %23, ptr %441, align 8
  %442 = load ptr, ptr %19, align 8
  %443 = getelementptr inbounds i8, ptr %442, i64 48
  store double 1.000000e+00, ptr %443, align 8
  br label %984

444:                                              ; preds = %438, %541
  %445 = phi i1 [ %545, %541 ], [ %219, %438 ]
  %446 = phi i64 [ %543, %541 ], [ %353, %438 ]
  %447 = phi i64 [ %544, %541 ], [ 0, %438 ]
  %448 = phi double [ %542, %541 ], [ %355, %438 ]
  %449 = getelementptr inbounds i64, ptr %16, i64 %447
  %450 = load i64, ptr %449, align 8
  %451 = getelementptr inbounds double, ptr %31, i64 %447
  %452 = load double, ptr %451, align 8
  %453 = getelementptr inbounds i64, ptr %14, i64 %447
  %454 = load i64, ptr %453, align 8
  %455 = icmp slt i64 %450, 0
  %456 = fcmp ogt double %452, 0.000000e+00
  %457 = and i1 %455, %456
  %458 = icmp sgt i64 %454, -1
  %459 = and i1 %457, %458
  br i1 %459, label %467, label %460

460:                                              ; preds = %444
  %461 = icmp sgt i64 %450, 0
  %462 = fcmp olt double %452, 0.000000e+00
  %463 = and i1 %461, %462
  br i1 %463, label %464, label %467

464:                                              ; preds = %460
  %465 = icmp slt i64 %454, 1
  %466 = zext i1 %465 to i32
  br label %467

467:                                              ; preds = %444, %460, %464
  %468 = phi i32 [ 1, %444 ], [ 0, %460 ], [ %466, %464 ]
  %469 = icmp eq i32 %468, 0
  br i1 %469, label %541, label %470

470:                                              ; preds = %467
  %471 = getelementptr inbounds double, ptr %350, i64 %447
  %472 = load double, ptr %471, align 8
  %473 = fcmp ogt double %472, 0.000000e+00
  %474 = and i1 %455, %473
  %475 = and i1 %458, %474
  br i1 %475, label %483, label %476

476:                                              ; preds = %470
  %477 = icmp sgt i64 %450, 0
  %478 = fcmp olt double %472, 0.000000e+00
  %479 = and i1 %477, %478
  br i1 %479, label %480, label %483

480:                                              ; preds = %476
  %481 = icmp slt i64 %454, 1
  %482 = zext i1 %481 to i32
  br label %483

483:                                              ; preds = %470, %476, %480
  %484 = phi i32 [ 1, %470 ], [ 0, %476 ], [ %482, %480 ]
  %485 = icmp eq i32 %484, 0
  br i1 %485, label %486, label %541

486:                                              ; preds = %483
  %487 = call fastcc double @locate(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %352, double noundef %448, i64 noundef %447) #8
  %488 = fcmp ogt double %487, %352
  br i1 %488, label %489, label %491

489:                                              ; preds = %486
  %490 = getelementptr inbounds i64, ptr %18, i64 %447
  store i64 2, ptr %490, align 8
  br label %491

491:                                              ; preds = %489, %486
  %492 = phi double [ %487, %489 ], [ %448, %486 ]
  %493 = load ptr, ptr %207, align 8
  %494 = load ptr, ptr %209, align 8
  %495 = insertelement <8 x double> poison, double %492, i64 0
  %496 = shufflevector <8 x double> %495, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %496, ptr %494, align 8
  %497 = load ptr, ptr %208, align 8
  %498 = load ptr, ptr %210, align 8
  %499 = load i64, ptr %211, align 8
  %500 = load ptr, ptr %212, align 8
  %501 = getelementptr inbounds i8, ptr %500, i64 24
  %502 = load i64, ptr %501, align 8
  %503 = load ptr, ptr %209, align 8
  %504 = load ptr, ptr %213, align 8
  %505 = getelementptr inbounds i8, ptr %504, i64 16
  %506 = load i64, ptr %505, align 8
  tail call fastcc void @nested(ptr noundef %493, ptr noundef %497, ptr noundef %498, i64 noundef %499, i64 noundef %502, ptr noundef %503, i64 noundef %506) #8
  %507 = fmul double %492, %2
  %508 = fadd double %507, %1
  %509 = load ptr, ptr %214, align 8
  store double %508, ptr %509, align 8
  %510 = load ptr, ptr %6, align 8
  %511 = getelementptr inbounds i8, ptr %510, i64 40
  %512 = load i64, ptr %511, align 8
  %513 = icmp eq i64 %512, 0
  br i1 %513, label %515, label %514

514:                                              ; preds = %491
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %515

515:                                              ; preds = %514, %491
  %516 = load i64, ptr %215, align 8
  %517 = icmp sgt i64 %516, 0
  br i1 %517, label %518, label %519

518:                                              ; preds = %515
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %519

519:                                              ; preds = %515, %518
  %520 = load ptr, ptr %9, align 8
  %521 = load i64, ptr %520, align 8
  %522 = load ptr, ptr %216, align 8
  %523 = load ptr, ptr %207, align 8
  %524 = load ptr, ptr %217, align 8
  %525 = load ptr, ptr %218, align 8
  %526 = load ptr, ptr %25, align 8
  %527 = getelementptr inbounds i8, ptr %520, i64 8
  %528 = load i64, ptr %527, align 8
  %529 = getelementptr inbounds double, ptr %526, i64 %528
  %530 = inttoptr i64 %521 to ptr
  %531 = load ptr, ptr %530, align 8
  %532 = tail call i32 %531(ptr noundef %522, ptr noundef %523, ptr noundef %524, ptr noundef %525, ptr noundef %529) #9
  %533 = icmp sgt i32 %532, -1
  br i1 %533, label %539, label %534

534:                                              ; preds = %519
  %535 = load ptr, ptr %20, align 8
  %536 = getelementptr inbounds i8, ptr %535, i64 80
  store i64 %23, ptr %536, align 8
  %537 = load ptr, ptr %19, align 8
  %538 = getelementptr inbounds i8, ptr %537, i64 48
  store double 1.000000e+00, ptr %538, align 8
  br label %539

539:                                              ; preds = %519, %534
  %540 = phi i64 [ -4, %534 ], [ %446, %519 ]
  br i1 %533, label %541, label %547

541:                                              ; preds = %467, %483, %539
  %542 = phi double [ %448, %483 ], [ %492, %539 ], [ %448, %467 ]
  %543 = phi i64 [ %446, %483 ], [ %540, %539 ], [ %446, %467 ]
  %544 = add nuw nsw i64 %447, 1
  %545 = icmp slt i64 %544, %12
  %546 = icmp eq i64 %544, %12
  br i1 %546, label %547, label %444, !llvm.loop !10

547:                                              ; preds = %539, %541, %438
  %548 = phi i1 [ %219, %438 ], [ %445, %539 ], [ %545, %541 ]
  %549 = phi i32 [ 16, %438 ], [ 1, %539 ], [ 16, %541 ]
  %550 = phi double [ %355, %438 ], [ %492, %539 ], [ %542, %541 ]
  %551 = phi i64 [ %353, %438 ], [ %540, %539 ], [ %543, %541 ]
  br i1 %548, label %984, label %552

552:                                              ; preds = %547
  br i1 %220, label %563, label %555

553:                                              ; preds = %650
  %554 = zext i1 %651 to i32
  br label %555

555:                                              ; preds = %553, %552
  %556 = phi i32 [ 0, %552 ], [ %554, %553 ]
  %557 = phi i64 [ -1, %552 ], [ %640, %553 ]
  %558 = icmp eq i32 %556, 0
  br i1 %558, label %559, label %654

559:                                              ; preds = %555
  br i1 %229, label %560, label %787

560:                                              ; preds = %559
  %561 = fmul double %550, %2
  %562 = fadd double %561, %1
  br label %915

563:                                              ; preds = %552, %650
  %564 = phi i64 [ %652, %650 ], [ 0, %552 ]
  %565 = phi i64 [ %640, %650 ], [ -1, %552 ]
  %566 = phi i1 [ %651, %650 ], [ false, %552 ]
  %567 = getelementptr inbounds double, ptr %31, i64 %564
  %568 = load double, ptr %567, align 8
  %569 = getelementptr inbounds i64, ptr %16, i64 %564
  %570 = load i64, ptr %569, align 8
  %571 = getelementptr inbounds i64, ptr %14, i64 %564
  %572 = load i64, ptr %571, align 8
  %573 = icmp slt i64 %570, 0
  %574 = fcmp ogt double %568, 0.000000e+00
  %575 = and i1 %574, %573
  %576 = icmp sgt i64 %572, -1
  %577 = and i1 %575, %576
  br i1 %577, label %585, label %578

578:                                              ; preds = %563
  %579 = icmp sgt i64 %570, 0
  %580 = fcmp olt double %568, 0.000000e+00
  %581 = and i1 %580, %579
  br i1 %581, label %582, label %585

582:                                              ; preds = %578
  %583 = icmp slt i64 %572, 1
  %584 = zext i1 %583 to i32
  br label %585

585:                                              ; preds = %563, %578, %582
  %586 = phi i32 [ 1, %563 ], [ 0, %578 ], [ %584, %582 ]
  %587 = icmp eq i32 %586, 0
  br i1 %587, label %588, label %613

588:                                              ; preds = %585
  %589 = getelementptr inbounds double, ptr %350, i64 %564
  %590 = load double, ptr %589, align 8
  %591 = fcmp ogt double %590, 0.000000e+00
  %592 = and i1 %573, %591
  %593 = and i1 %576, %592
  br i1 %593, label %601, label %594

594:                                              ; preds = %588
  %595 = icmp sgt i64 %570, 0
  %596 = fcmp olt double %590, 0.000000e+00
  %597 = and i1 %595, %596
  br i1 %597, label %598, label %601

598:                                              ; preds = %594
  %599 = icmp slt i64 %572, 1
  %600 = zext i1 %599 to i32
  br label %601

601:                                              ; preds = %588, %594, %598
  %602 = phi i32 [ 1, %588 ], [ 0, %594 ], [ %600, %598 ]
  %603 = icmp eq i32 %602, 0
  br i1 %603, label %613, label %604

604:                                              ; preds = %601
  %605 = fcmp oeq double %568, 0.000000e+00
  br i1 %605, label %610, label %606

606:                                              ; preds = %604
  %607 = getelementptr inbounds i64, ptr %18, i64 %564
  %608 = load i64, ptr %607, align 8
  %609 = icmp eq i64 %608, 1
  br label %610

610:                                              ; preds = %606, %604
  %611 = phi i1 [ true, %604 ], [ %609, %606 ]
  %612 = zext i1 %611 to i32
  br label %613

613:                                              ; preds = %610, %601, %585
  %614 = phi i32 [ 1, %585 ], [ %612, %610 ], [ 0, %601 ]
  %615 = icmp eq i32 %614, 0
  br i1 %615, label %616, label %622

616:                                              ; preds = %613
  %617 = getelementptr inbounds i64, ptr %18, i64 %564
  %618 = load i64, ptr %617, align 8
  %619 = icmp eq i64 %618, 2
  %620 = fcmp oeq double %568, 0.000000e+00
  %621 = and i1 %620, %619
  br label %622

622:                                              ; preds = %616, %613
  %623 = phi i1 [ true, %613 ], [ %621, %616 ]
  br i1 %623, label %639, label %624

624:                                              ; preds = %622
  %625 = getelementptr inbounds double, ptr %350, i64 %564
  %626 = load double, ptr %625, align 8
  %627 = icmp eq i64 %570, 0
  %628 = fcmp ord double %626, 0.000000e+00
  %629 = or i1 %627, %628
  br i1 %629, label %639, label %630

630:                                              ; preds = %624
  %631 = sitofp i64 %570 to double
  %632 = fmul double %568, %631
  %633 = fcmp olt double %632, 0.000000e+00
  br i1 %633, label %634, label %636

634:                                              ; preds = %630
  %635 = sub nsw i64 0, %570
  store i64 %635, ptr %569, align 8
  br label %639

636:                                              ; preds = %630
  %637 = fcmp ueq double %568, 0.000000e+00
  %638 = select i1 %637, i64 %564, i64 %565
  br label %639

639:                                              ; preds = %636, %634, %624, %622
  %640 = phi i64 [ %565, %622 ], [ %565, %634 ], [ %565, %624 ], [ %638, %636 ]
  %641 = zext i1 %623 to i64
  %642 = getelementptr inbounds i64, ptr %18, i64 %564
  store i64 %641, ptr %642, align 8
  %643 = xor i1 %623, true
  %644 = or i1 %566, %643
  br i1 %644, label %650, label %645

645:                                              ; preds = %639
  %646 = load ptr, ptr %221, align 8
  %647 = getelementptr inbounds i64, ptr %646, i64 %564
  %648 = load i64, ptr %647, align 8
  %649 = icmp eq i64 %648, 1
  br label %650

650:                                              ; preds = %639, %645
  %651 = phi i1 [ %566, %639 ], [ %649, %645 ]
  %652 = add nuw nsw i64 %564, 1
  %653 = icmp eq i64 %652, %12
  br i1 %653, label %553, label %563, !llvm.loop !11

654:                                              ; preds = %555
  store double %550, ptr %222, align 8
  %655 = load ptr, ptr %9, align 8
  %656 = getelementptr inbounds i8, ptr %655, i64 8
  %657 = load i64, ptr %656, align 8
  %658 = load ptr, ptr %25, align 8
  %659 = getelementptr inbounds double, ptr %658, i64 %657
  %660 = mul i64 %657, 56
  %661 = getelementptr inbounds i8, ptr %658, i64 %660
  %662 = load ptr, ptr %223, align 8
  %663 = load i64, ptr %224, align 8
  %664 = getelementptr double, ptr %662, i64 %663
  %665 = getelementptr i8, ptr %664, i64 -8
  %666 = load double, ptr %665, align 8
  %667 = load double, ptr %662, align 8
  %668 = fsub double %666, %667
  %669 = icmp sgt i64 %657, 0
  br i1 %669, label %673, label %670

670:                                              ; preds = %686, %654
  %671 = phi i32 [ 0, %654 ], [ %688, %686 ]
  %672 = icmp eq i32 %671, 0
  br i1 %672, label %984, label %691

673:                                              ; preds = %654, %686
  %674 = phi i64 [ %689, %686 ], [ 0, %654 ]
  %675 = phi i32 [ %688, %686 ], [ 0, %654 ]
  %676 = icmp eq i32 %675, 0
  br i1 %676, label %677, label %686

677:                                              ; preds = %673
  %678 = load ptr, ptr %17, align 8
  %679 = getelementptr inbounds i64, ptr %678, i64 %674
  %680 = load i64, ptr %679, align 8
  %681 = icmp eq i64 %680, 0
  br i1 %681, label %686, label %682

682:                                              ; preds = %677
  %683 = getelementptr inbounds double, ptr %659, i64 %674
  %684 = load double, ptr %683, align 8
  %685 = fcmp oeq double %684, 0.000000e+00
  br label %686

686:                                              ; preds = %682, %677, %673
  %687 = phi i1 [ true, %673 ], [ false, %677 ], [ %685, %682 ]
  %688 = zext i1 %687 to i32
  %689 = add nuw nsw i64 %674, 1
  %690 = icmp eq i64 %689, %657
  br i1 %690, label %670, label %673, !llvm.loop !12

691:                                              ; preds = %670
  %692 = fsub double %349, %550
  %693 = fmul double %692, %2
  %694 = fcmp ogt double %226, %668
  %695 = select i1 %694, double %226, double %668
  %696 = fmul double %695, 0x3F50000000000000
  %697 = fcmp ugt double %693, %696
  br i1 %697, label %698, label %984

698:                                              ; preds = %691
  %699 = fmul double %692, 0x3F50000000000000
  %700 = fadd double %550, %699
  %701 = load ptr, ptr %207, align 8
  %702 = load ptr, ptr %209, align 8
  %703 = insertelement <8 x double> poison, double %700, i64 0
  %704 = shufflevector <8 x double> %703, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %704, ptr %702, align 8
  %705 = load ptr, ptr %208, align 8
  %706 = load ptr, ptr %210, align 8
  %707 = load i64, ptr %211, align 8
  %708 = load ptr, ptr %212, align 8
  %709 = getelementptr inbounds i8, ptr %708, i64 24
  %710 = load i64, ptr %709, align 8
  %711 = load ptr, ptr %209, align 8
  %712 = load ptr, ptr %213, align 8
  %713 = getelementptr inbounds i8, ptr %712, i64 16
  %714 = load i64, ptr %713, align 8
  tail call fastcc void @nested(ptr noundef %701, ptr noundef %705, ptr noundef %706, i64 noundef %707, i64 noundef %710, ptr noundef %711, i64 noundef %714) #8
  %715 = fmul double %700, %2
  %716 = fadd double %715, %1
  %717 = load ptr, ptr %214, align 8
  store double %716, ptr %717, align 8
  %718 = load ptr, ptr %6, align 8
  %719 = getelementptr inbounds i8, ptr %718, i64 40
  %720 = load i64, ptr %719, align 8
  %721 = icmp eq i64 %720, 0
  br i1 %721, label %723, label %722

722:                                              ; preds = %698
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %723

723:                                              ; preds = %722, %698
  %724 = load i64, ptr %215, align 8
  %725 = icmp sgt i64 %724, 0
  br i1 %725, label %726, label %727

726:                                              ; preds = %723
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %727

727:                                              ; preds = %723, %726
  %728 = load ptr, ptr %9, align 8
  %729 = load i64, ptr %728, align 8
  %730 = load ptr, ptr %216, align 8
  %731 = load ptr, ptr %207, align 8
  %732 = load ptr, ptr %217, align 8
  %733 = load ptr, ptr %218, align 8
  %734 = load ptr, ptr %25, align 8
  %735 = getelementptr inbounds i8, ptr %728, i64 8
  %736 = load i64, ptr %735, align 8
  %737 = mul i64 %736, 56
  %738 = getelementptr inbounds i8, ptr %734, i64 %737
  %739 = inttoptr i64 %729 to ptr
  %740 = load ptr, ptr %739, align 8
  %741 = tail call i32 %740(ptr noundef %730, ptr noundef %731, ptr noundef %732, ptr noundef %733, ptr noundef %738) #9
  %742 = icmp slt i32 %741, 0
  br i1 %742, label %782, label %743

743:                                              ; preds = %727
  %744 = icmp sgt i64 %657, 0
  br i1 %744, label %745, label %984

745:                                              ; preds = %743
  %746 = fmul double %550, %2
  %747 = fadd double %746, %1
  %748 = fsub double %747, %747
  br label %749

749:                                              ; preds = %745, %779
  %750 = phi i64 [ 0, %745 ], [ %780, %779 ]
  %751 = load ptr, ptr %17, align 8
  %752 = getelementptr inbounds i64, ptr %751, i64 %750
  %753 = load i64, ptr %752, align 8
  %754 = icmp eq i64 %753, 0
  br i1 %754, label %779, label %755

755:                                              ; preds = %749
  %756 = getelementptr inbounds double, ptr %659, i64 %750
  %757 = load double, ptr %756, align 8
  %758 = fcmp oeq double %757, 0.000000e+00
  br i1 %758, label %759, label %779

759:                                              ; preds = %755
  %760 = getelementptr inbounds double, ptr %661, i64 %750
  %761 = load double, ptr %760, align 8
  %762 = fcmp oeq double %761, 0.000000e+00
  br i1 %762, label %763, label %779

763:                                              ; preds = %759
  %764 = load i64, ptr %227, align 8
  %765 = icmp eq i64 %764, 0
  br i1 %765, label %779, label %766

766:                                              ; preds = %763
  %767 = load ptr, ptr %228, align 8
  %768 = shl nsw i64 %750, 4
  %769 = getelementptr inbounds i8, ptr %767, i64 %768
  %770 = getelementptr inbounds i8, ptr %769, i64 8
  %771 = load double, ptr %770, align 8
  %772 = fcmp oeq double %771, %747
  br i1 %772, label %778, label %773

773:                                              ; preds = %766
  %774 = load double, ptr %769, align 8
  %775 = fsub double %771, %774
  %776 = fcmp ult double %775, %748
  br i1 %776, label %777, label %779

777:                                              ; preds = %773
  store double %747, ptr %769, align 8
  br label %778

778:                                              ; preds = %766, %777
  store double %747, ptr %770, align 8
  br label %779

779:                                              ; preds = %778, %773, %763, %759, %755, %749
  %780 = add nuw nsw i64 %750, 1
  %781 = icmp eq i64 %780, %657
  br i1 %781, label %984, label %749, !llvm.loop !13

782:                                              ; preds = %727
  %783 = load ptr, ptr %20, align 8
  %784 = getelementptr inbounds i8, ptr %783, i64 80
  store i64 %23, ptr %784, align 8
  %785 = load ptr, ptr %19, align 8
  %786 = getelementptr inbounds i8, ptr %785, i64 48
  store double 1.000000e+00, ptr %786, align 8
  br label %984

787:                                              ; preds = %957, %559
  %788 = load ptr, ptr %9, align 8
  %789 = getelementptr inbounds i8, ptr %788, i64 8
  %790 = load i64, ptr %789, align 8
  %791 = load ptr, ptr %25, align 8
  %792 = getelementptr inbounds double, ptr %791, i64 %790
  %793 = mul i64 %790, 56
  %794 = getelementptr inbounds i8, ptr %791, i64 %793
  %795 = load ptr, ptr %235, align 8
  %796 = load i64, ptr %236, align 8
  %797 = getelementptr double, ptr %795, i64 %796
  %798 = getelementptr i8, ptr %797, i64 -8
  %799 = load double, ptr %798, align 8
  %800 = load double, ptr %795, align 8
  %801 = fsub double %799, %800
  %802 = icmp sgt i64 %790, 0
  br i1 %802, label %806, label %803

803:                                              ; preds = %819, %787
  %804 = phi i32 [ 0, %787 ], [ %821, %819 ]
  %805 = icmp eq i32 %804, 0
  br i1 %805, label %965, label %824

806:                                              ; preds = %787, %819
  %807 = phi i64 [ %822, %819 ], [ 0, %787 ]
  %808 = phi i32 [ %821, %819 ], [ 0, %787 ]
  %809 = icmp eq i32 %808, 0
  br i1 %809, label %810, label %819

810:                                              ; preds = %806
  %811 = load ptr, ptr %17, align 8
  %812 = getelementptr inbounds i64, ptr %811, i64 %807
  %813 = load i64, ptr %812, align 8
  %814 = icmp eq i64 %813, 0
  br i1 %814, label %819, label %815

815:                                              ; preds = %810
  %816 = getelementptr inbounds double, ptr %792, i64 %807
  %817 = load double, ptr %816, align 8
  %818 = fcmp oeq double %817, 0.000000e+00
  br label %819

819:                                              ; preds = %815, %810, %806
  %820 = phi i1 [ true, %806 ], [ false, %810 ], [ %818, %815 ]
  %821 = zext i1 %820 to i32
  %822 = add nuw nsw i64 %807, 1
  %823 = icmp eq i64 %822, %790
  br i1 %823, label %803, label %806, !llvm.loop !12

824:                                              ; preds = %803
  %825 = fsub double %349, %550
  %826 = fmul double %825, %2
  %827 = fcmp ogt double %238, %801
  %828 = select i1 %827, double %238, double %801
  %829 = fmul double %828, 0x3F50000000000000
  %830 = fcmp ugt double %826, %829
  br i1 %830, label %831, label %965

831:                                              ; preds = %824
  %832 = fmul double %825, 0x3F50000000000000
  %833 = fadd double %550, %832
  %834 = load ptr, ptr %207, align 8
  %835 = load ptr, ptr %209, align 8
  %836 = insertelement <8 x double> poison, double %833, i64 0
  %837 = shufflevector <8 x double> %836, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %837, ptr %835, align 8
  %838 = load ptr, ptr %208, align 8
  %839 = load ptr, ptr %210, align 8
  %840 = load i64, ptr %211, align 8
  %841 = load ptr, ptr %212, align 8
  %842 = getelementptr inbounds i8, ptr %841, i64 24
  %843 = load i64, ptr %842, align 8
  %844 = load ptr, ptr %209, align 8
  %845 = load ptr, ptr %213, align 8
  %846 = getelementptr inbounds i8, ptr %845, i64 16
  %847 = load i64, ptr %846, align 8
  tail call fastcc void @nested(ptr noundef %834, ptr noundef %838, ptr noundef %839, i64 noundef %840, i64 noundef %843, ptr noundef %844, i64 noundef %847) #8
  %848 = fmul double %833, %2
  %849 = fadd double %848, %1
  %850 = load ptr, ptr %214, align 8
  store double %849, ptr %850, align 8
  %851 = load ptr, ptr %6, align 8
  %852 = getelementptr inbounds i8, ptr %851, i64 40
  %853 = load i64, ptr %852, align 8
  %854 = icmp eq i64 %853, 0
  br i1 %854, label %856, label %855

855:                                              ; preds = %831
  tail call fastcc void @settle(ptr noundef nonnull %6) #8
  br label %856

856:                                              ; preds = %855, %831
  %857 = load i64, ptr %215, align 8
  %858 = icmp sgt i64 %857, 0
  br i1 %858, label %859, label %860

859:                                              ; preds = %856
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %860

860:                                              ; preds = %856, %859
  %861 = load ptr, ptr %9, align 8
  %862 = load i64, ptr %861, align 8
  %863 = load ptr, ptr %216, align 8
  %864 = load ptr, ptr %207, align 8
  %865 = load ptr, ptr %217, align 8
  %866 = load ptr, ptr %218, align 8
  %867 = load ptr, ptr %25, align 8
  %868 = getelementptr inbounds i8, ptr %861, i64 8
  %869 = load i64, ptr %868, align 8
  %870 = mul i64 %869, 56
  %871 = getelementptr inbounds i8, ptr %867, i64 %870
  %872 = inttoptr i64 %862 to ptr
  %873 = load ptr, ptr %872, align 8
  %874 = tail call i32 %873(ptr noundef %863, ptr noundef %864, ptr noundef %865, ptr noundef %866, ptr noundef %871) #9
  %875 = icmp slt i32 %874, 0
  br i1 %875, label %960, label %876

876:                                              ; preds = %860
  %877 = icmp sgt i64 %790, 0
  br i1 %877, label %878, label %965

878:                                              ; preds = %876
  %879 = fmul double %550, %2
  %880 = fadd double %879, %1
  %881 = fsub double %880, %880
  br label %882

882:                                              ; preds = %878, %912
  %883 = phi i64 [ 0, %878 ], [ %913, %912 ]
  %884 = load ptr, ptr %17, align 8
  %885 = getelementptr inbounds i64, ptr %884, i64 %883
  %886 = load i64, ptr %885, align 8
  %887 = icmp eq i64 %886, 0
  br i1 %887, label %912, label %888

888:                                              ; preds = %882
  %889 = getelementptr inbounds double, ptr %792, i64 %883
  %890 = load double, ptr %889, align 8
  %891 = fcmp oeq double %890, 0.000000e+00
  br i1 %891, label %892, label %912

892:                                              ; preds = %888
  %893 = getelementptr inbounds double, ptr %794, i64 %883
  %894 = load double, ptr %893, align 8
  %895 = fcmp oeq double %894, 0.000000e+00
  br i1 %895, label %896, label %912

896:                                              ; preds = %892
  %897 = load i64, ptr %239, align 8
  %898 = icmp eq i64 %897, 0
  br i1 %898, label %912, label %899

899:                                              ; preds = %896
  %900 = load ptr, ptr %240, align 8
  %901 = shl nsw i64 %883, 4
  %902 = getelementptr inbounds i8, ptr %900, i64 %901
  %903 = getelementptr inbounds i8, ptr %902, i64 8
  %904 = load double, ptr %903, align 8
  %905 = fcmp oeq double %904, %880
  br i1 %905, label %911, label %906

906:                                              ; preds = %899
  %907 = load double, ptr %902, align 8
  %908 = fsub double %904, %907
  %909 = fcmp ult double %908, %881
  br i1 %909, label %910, label %912

910:                                              ; preds = %906
  store double %880, ptr %902, align 8
  br label %911

911:                                              ; preds = %899, %910
  store double %880, ptr %903, align 8
  br label %912

912:                                              ; preds = %911, %906, %896, %892, %888, %882
  %913 = add nuw nsw i64 %883, 1
  %914 = icmp eq i64 %913, %790
  br i1 %914, label %965, label %882, !llvm.loop !13

915:                                              ; preds = %560, %957
  %916 = phi i64 [ 0, %560 ], [ %958, %957 ]
  %917 = getelementptr inbounds i64, ptr %18, i64 %916
  %918 = load i64, ptr %917, align 8
  %919 = icmp eq i64 %918, 0
  br i1 %919, label %957, label %920

920:                                              ; preds = %915
  %921 = load ptr, ptr %20, align 8
  %922 = getelementptr inbounds i8, ptr %921, i64 80
  %923 = load i64, ptr %922, align 8
  %924 = load ptr, ptr %6, align 8
  %925 = getelementptr inbounds i8, ptr %924, i64 8
  %926 = load i64, ptr %925, align 8
  %927 = load i64, ptr %230, align 8
  %928 = icmp eq i64 %927, 0
  br i1 %928, label %953, label %929

929:                                              ; preds = %920
  %930 = load ptr, ptr %231, align 8
  %931 = getelementptr inbounds double, ptr %930, i64 %923
  store double %562, ptr %931, align 8
  %932 = load ptr, ptr %232, align 8
  %933 = getelementptr inbounds i64, ptr %932, i64 %923
  store i64 %916, ptr %933, align 8
  %934 = icmp sgt i64 %926, 0
  br i1 %934, label %935, label %937

935:                                              ; preds = %929
  %936 = mul nsw i64 %926, %923
  br label %941

937:                                              ; preds = %941, %929
  %938 = add nsw i64 %923, 1
  %939 = load ptr, ptr %20, align 8
  %940 = getelementptr inbounds i8, ptr %939, i64 80
  store i64 %938, ptr %940, align 8
  br label %953

941:                                              ; preds = %935, %941
  %942 = phi i64 [ 0, %935 ], [ %951, %941 ]
  %943 = load ptr, ptr %207, align 8
  %944 = getelementptr inbounds double, ptr %943, i64 %942
  %945 = load double, ptr %944, align 8
  %946 = load ptr, ptr %233, align 8
  %947 = add nsw i64 %942, %936
  %948 = getelementptr inbounds double, ptr %946, i64 %947
  store double %945, ptr %948, align 8
  %949 = load ptr, ptr %234, align 8
  %950 = getelementptr inbounds double, ptr %949, i64 %947
  store double %945, ptr %950, align 8
  %951 = add nuw nsw i64 %942, 1
  %952 = icmp eq i64 %951, %926
  br i1 %952, label %937, label %941, !llvm.loop !14

953:                                              ; preds = %920, %937
  %954 = getelementptr inbounds i64, ptr %16, i64 %916
  %955 = load i64, ptr %954, align 8
  %956 = sub nsw i64 0, %955
  store i64 %956, ptr %954, align 8
  br label %957

957:                                              ; preds = %915, %953
  %958 = add nuw nsw i64 %916, 1
  %959 = icmp eq i64 %958, %12
  br i1 %959, label %787, label %915, !llvm.loop !15

960:                                              ; preds = %860
  %961 = load ptr, ptr %20, align 8
  %962 = getelementptr inbounds i8, ptr %961, i64 80
  store i64 %23, ptr %962, align 8
  %963 = load ptr, ptr %19, align 8
  %964 = getelementptr inbounds i8, ptr %963, i64 48
  store double 1.000000e+00, ptr %964, align 8
  br label %984

965:                                              ; preds = %912, %876, %824, %803
  %966 = icmp sgt i64 %557, -1
  br i1 %966, label %967, label %976

967:                                              ; preds = %965
  br i1 %243, label %969, label %968

968:                                              ; preds = %969, %967
  store double %550, ptr %244, align 8
  br label %984

969:                                              ; preds = %967, %969
  %970 = phi i64 [ %974, %969 ], [ 0, %967 ]
  %971 = icmp eq i64 %970, %557
  %972 = zext i1 %971 to i64
  %973 = getelementptr inbounds i64, ptr %18, i64 %970
  store i64 %972, ptr %973, align 8
  %974 = add nuw nsw i64 %970, 1
  %975 = icmp eq i64 %974, %12
  br i1 %975, label %968, label %969, !llvm.loop !16

976:                                              ; preds = %965
  %977 = load i64, ptr %241, align 8
  %978 = icmp sgt i64 %977, 0
  br i1 %978, label %979, label %984

979:                                              ; preds = %976
  %980 = load i64, ptr %22, align 8
  %981 = add nsw i64 %980, %12
  %982 = icmp sgt i64 %981, %977
  br i1 %982, label %983, label %984

983:                                              ; preds = %979
  store double %550, ptr %242, align 8
  br label %984

984:                                              ; preds = %779, %743, %691, %670, %960, %968, %983, %782, %979, %976, %354, %547, %439
  %985 = phi i32 [ 1, %439 ], [ %549, %547 ], [ 11, %354 ], [ 1, %960 ], [ 1, %968 ], [ 1, %983 ], [ 1, %782 ], [ 0, %979 ], [ 0, %976 ], [ 1, %670 ], [ 1, %691 ], [ 1, %743 ], [ 1, %779 ]
  %986 = phi double [ %352, %439 ], [ %352, %547 ], [ %352, %354 ], [ %352, %960 ], [ %352, %968 ], [ %352, %983 ], [ %352, %782 ], [ %550, %979 ], [ %550, %976 ], [ %352, %670 ], [ %352, %691 ], [ %352, %743 ], [ %352, %779 ]
  %987 = phi i64 [ -4, %439 ], [ %551, %547 ], [ %353, %354 ], [ -4, %960 ], [ 21, %968 ], [ -3, %983 ], [ -4, %782 ], [ %551, %979 ], [ %551, %976 ], [ -2, %670 ], [ -2, %691 ], [ -2, %743 ], [ -2, %779 ]
  switch i32 %985, label %1045 [
    i32 0, label %351
    i32 11, label %988
  ], !llvm.loop !17

988:                                              ; preds = %984
  br i1 %245, label %989, label %1045

989:                                              ; preds = %988
  %990 = fcmp oeq double %349, %255
  %991 = add nsw i32 %252, -1
  %992 = sext i32 %991 to i64
  %993 = mul nsw i64 %12, %992
  %994 = getelementptr double, ptr %28, i64 %993
  %995 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %992
  %996 = fmul double %349, %2
  %997 = fadd double %996, %1
  br label %998

998:                                              ; preds = %989, %1037
  %999 = phi i64 [ 0, %989 ], [ %1038, %1037 ]
  %1000 = getelementptr inbounds double, ptr %350, i64 %999
  %1001 = load double, ptr %1000, align 8
  %1002 = fcmp ogt double %1001, 0.000000e+00
  br i1 %1002, label %1005, label %1003

1003:                                             ; preds = %998
  %1004 = fcmp olt double %1001, 0.000000e+00
  br i1 %1004, label %1005, label %1008

1005:                                             ; preds = %1003, %998
  %1006 = phi i64 [ 1, %998 ], [ -1, %1003 ]
  %1007 = getelementptr inbounds i64, ptr %16, i64 %999
  store i64 %1006, ptr %1007, align 8
  br label %1008

1008:                                             ; preds = %1005, %1003
  br i1 %990, label %1009, label %1037

1009:                                             ; preds = %1008
  %1010 = getelementptr double, ptr %994, i64 %999
  %1011 = load double, ptr %1010, align 8
  %1012 = fcmp oeq double %1011, 0.000000e+00
  br i1 %1012, label %1013, label %1037

1013:                                             ; preds = %1009
  %1014 = getelementptr double, ptr %306, i64 %999
  %1015 = load double, ptr %1014, align 8
  %1016 = fcmp oeq double %1015, 0.000000e+00
  br i1 %1016, label %1017, label %1037

1017:                                             ; preds = %1013
  %1018 = load double, ptr %995, align 8
  %1019 = fmul double %1018, %2
  %1020 = fadd double %1019, %1
  %1021 = load i64, ptr %246, align 8
  %1022 = icmp eq i64 %1021, 0
  br i1 %1022, label %1037, label %1023

1023:                                             ; preds = %1017
  %1024 = load ptr, ptr %247, align 8
  %1025 = shl nsw i64 %999, 4
  %1026 = getelementptr inbounds i8, ptr %1024, i64 %1025
  %1027 = getelementptr inbounds i8, ptr %1026, i64 8
  %1028 = load double, ptr %1027, align 8
  %1029 = fcmp oeq double %1028, %1020
  br i1 %1029, label %1036, label %1030

1030:                                             ; preds = %1023
  %1031 = load double, ptr %1026, align 8
  %1032 = fsub double %1028, %1031
  %1033 = fsub double %997, %1020
  %1034 = fcmp ult double %1032, %1033
  br i1 %1034, label %1035, label %1037

1035:                                             ; preds = %1030
  store double %1020, ptr %1026, align 8
  br label %1036

1036:                                             ; preds = %1023, %1035
  store double %997, ptr %1027, align 8
  br label %1037

1037:                                             ; preds = %1036, %1030, %1017, %1008, %1009, %1013
  %1038 = add nuw nsw i64 %999, 1
  %1039 = icmp eq i64 %1038, %12
  br i1 %1039, label %1045, label %998, !llvm.loop !18

1040:                                             ; preds = %336, %302
  %1041 = load ptr, ptr %20, align 8
  %1042 = getelementptr inbounds i8, ptr %1041, i64 80
  store i64 %23, ptr %1042, align 8
  %1043 = load ptr, ptr %19, align 8
  %1044 = getelementptr inbounds i8, ptr %1043, i64 48
  store double 1.000000e+00, ptr %1044, align 8
  br label %1045

1045:                                             ; preds = %984, %1037, %1040, %988
  %1046 = phi i32 [ 0, %988 ], [ 1, %1040 ], [ 0, %1037 ], [ %985, %984 ]
  %1047 = phi double [ %349, %988 ], [ %251, %1040 ], [ %349, %1037 ], [ %986, %984 ]
  %1048 = phi i64 [ %987, %988 ], [ -4, %1040 ], [ %987, %1037 ], [ %987, %984 ]
  %1049 = icmp eq i32 %1046, 0
  br i1 %1049, label %1050, label %1055

1050:                                             ; preds = %1045
  %1051 = fcmp oeq double %1047, %255
  %1052 = zext i1 %1051 to i32
  %1053 = add nuw nsw i32 %252, %1052
  %1054 = icmp ugt i32 %1053, 4
  br i1 %1054, label %1055, label %248, !llvm.loop !19

1055:                                             ; preds = %1050, %1045
  %1056 = phi i1 [ %1054, %1050 ], [ %249, %1045 ]
  br i1 %1056, label %1057, label %1075

1057:                                             ; preds = %1055
  %1058 = icmp sgt i64 %12, 0
  br i1 %1058, label %1059, label %1062

1059:                                             ; preds = %1057
  %1060 = shl i64 %12, 5
  %1061 = getelementptr i8, ptr %28, i64 %1060
  br label %1064

1062:                                             ; preds = %1064, %1057
  %1063 = load double, ptr %24, align 8
  store double %1063, ptr %30, align 8
  br label %1071

1064:                                             ; preds = %1059, %1064
  %1065 = phi i64 [ 0, %1059 ], [ %1069, %1064 ]
  %1066 = getelementptr double, ptr %1061, i64 %1065
  %1067 = load double, ptr %1066, align 8
  %1068 = getelementptr inbounds double, ptr %28, i64 %1065
  store double %1067, ptr %1068, align 8
  %1069 = add nuw nsw i64 %1065, 1
  %1070 = icmp eq i64 %1069, %12
  br i1 %1070, label %1062, label %1064, !llvm.loop !20

1071:                                             ; preds = %125, %1062, %189, %98
  %1072 = phi ptr [ %101, %98 ], [ %192, %189 ], [ %24, %1062 ], [ %128, %125 ]
  %1073 = phi i64 [ -4, %98 ], [ -4, %189 ], [ 0, %1062 ], [ -4, %125 ]
  %1074 = getelementptr inbounds i8, ptr %1072, i64 48
  store double 1.000000e+00, ptr %1074, align 8
  br label %1075

1075:                                             ; preds = %1071, %1055, %106
  %1076 = phi i64 [ %1048, %1055 ], [ %107, %106 ], [ %1073, %1071 ]
  ret i64 %1076
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
  %56 = load ptr, ptr %28, align 8
  %57 = getelementptr inbounds i8, ptr %56, i64 40
  %58 = load i64, ptr %57, align 8
  %59 = icmp eq i64 %58, 0
  br i1 %59, label %61, label %60

60:                                               ; preds = %7
  tail call fastcc void @settle(ptr noundef nonnull %28) #8
  br label %61

61:                                               ; preds = %60, %7
  %62 = getelementptr inbounds i8, ptr %0, i64 248
  %63 = load i64, ptr %62, align 8
  %64 = icmp sgt i64 %63, 0
  br i1 %64, label %65, label %66

65:                                               ; preds = %61
  tail call fastcc void @sample(ptr noundef nonnull %28) #8
  br label %66

66:                                               ; preds = %61, %65
  %67 = load ptr, ptr %8, align 8
  %68 = load i64, ptr %67, align 8
  %69 = getelementptr inbounds i8, ptr %0, i64 168
  %70 = load ptr, ptr %69, align 8
  %71 = load ptr, ptr %29, align 8
  %72 = getelementptr inbounds i8, ptr %0, i64 192
  %73 = load ptr, ptr %72, align 8
  %74 = getelementptr inbounds i8, ptr %0, i64 792
  %75 = load ptr, ptr %74, align 8
  %76 = load ptr, ptr %14, align 8
  %77 = getelementptr inbounds i8, ptr %67, i64 8
  %78 = load i64, ptr %77, align 8
  %79 = getelementptr inbounds double, ptr %76, i64 %78
  %80 = inttoptr i64 %68 to ptr
  %81 = load ptr, ptr %80, align 8
  %82 = tail call i32 %81(ptr noundef %70, ptr noundef %71, ptr noundef %73, ptr noundef %75, ptr noundef %79) #9
  %83 = load double, ptr %20, align 8
  %84 = fmul double %83, %13
  %85 = fcmp ugt double %84, 0.000000e+00
  br i1 %85, label %145, label %86

86:                                               ; preds = %66, %126
  %87 = phi double [ %90, %126 ], [ %5, %66 ]
  %88 = fsub double %87, %4
  %89 = fmul double %88, 5.000000e-01
  %90 = fadd double %89, %4
  %91 = fsub double %90, %4
  %92 = fcmp uge double %91, %27
  br i1 %92, label %93, label %143

93:                                               ; preds = %86
  %94 = load ptr, ptr %29, align 8
  %95 = load ptr, ptr %31, align 8
  %96 = getelementptr inbounds i8, ptr %95, i64 96
  %97 = load ptr, ptr %96, align 8
  %98 = insertelement <8 x double> poison, double %90, i64 0
  %99 = shufflevector <8 x double> %98, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %99, ptr %97, align 8
  %100 = load ptr, ptr %95, align 8
  %101 = getelementptr inbounds i8, ptr %95, i64 192
  %102 = load ptr, ptr %101, align 8
  %103 = getelementptr inbounds i8, ptr %95, i64 8
  %104 = load i64, ptr %103, align 8
  %105 = load ptr, ptr %1, align 8
  %106 = load ptr, ptr %105, align 8
  %107 = getelementptr inbounds i8, ptr %106, i64 24
  %108 = load i64, ptr %107, align 8
  %109 = load ptr, ptr %96, align 8
  %110 = load ptr, ptr %47, align 8
  %111 = load ptr, ptr %110, align 8
  %112 = getelementptr inbounds i8, ptr %111, i64 16
  %113 = load i64, ptr %112, align 8
  tail call fastcc void @nested(ptr noundef %94, ptr noundef %100, ptr noundef %102, i64 noundef %104, i64 noundef %108, ptr noundef %109, i64 noundef %113) #8
  %114 = fmul double %90, %3
  %115 = fadd double %114, %2
  %116 = load ptr, ptr %54, align 8
  store double %115, ptr %116, align 8
  %117 = load ptr, ptr %28, align 8
  %118 = getelementptr inbounds i8, ptr %117, i64 40
  %119 = load i64, ptr %118, align 8
  %120 = icmp eq i64 %119, 0
  br i1 %120, label %122, label %121

121:                                              ; preds = %93
  tail call fastcc void @settle(ptr noundef nonnull %28) #8
  br label %122

122:                                              ; preds = %121, %93
  %123 = load i64, ptr %62, align 8
  %124 = icmp sgt i64 %123, 0
  br i1 %124, label %125, label %126

125:                                              ; preds = %122
  tail call fastcc void @sample(ptr noundef nonnull %28) #8
  br label %126

126:                                              ; preds = %122, %125
  %127 = load ptr, ptr %8, align 8
  %128 = load i64, ptr %127, align 8
  %129 = load ptr, ptr %69, align 8
  %130 = load ptr, ptr %29, align 8
  %131 = load ptr, ptr %72, align 8
  %132 = load ptr, ptr %74, align 8
  %133 = load ptr, ptr %14, align 8
  %134 = getelementptr inbounds i8, ptr %127, i64 8
  %135 = load i64, ptr %134, align 8
  %136 = getelementptr inbounds double, ptr %133, i64 %135
  %137 = inttoptr i64 %128 to ptr
  %138 = load ptr, ptr %137, align 8
  %139 = tail call i32 %138(ptr noundef %129, ptr noundef %130, ptr noundef %131, ptr noundef %132, ptr noundef %136) #9
  %140 = load double, ptr %20, align 8
  %141 = fmul double %140, %13
  %142 = fcmp ogt double %141, 0.000000e+00
  br i1 %142, label %143, label %86, !llvm.loop !30

143:                                              ; preds = %126, %86
  %144 = phi double [ %4, %86 ], [ %90, %126 ]
  br i1 %92, label %145, label %214

145:                                              ; preds = %143, %66
  %146 = phi double [ %5, %66 ], [ %87, %143 ]
  %147 = phi double [ %4, %66 ], [ %144, %143 ]
  br label %148

148:                                              ; preds = %145, %211
  %149 = phi double [ %212, %211 ], [ %146, %145 ]
  %150 = phi double [ %213, %211 ], [ %147, %145 ]
  %151 = fsub double %149, %150
  %152 = fcmp ogt double %151, %27
  br i1 %152, label %153, label %214

153:                                              ; preds = %148
  %154 = fmul double %151, 5.000000e-01
  %155 = fadd double %150, %154
  %156 = fcmp une double %155, %150
  %157 = fcmp une double %155, %149
  %158 = and i1 %156, %157
  br i1 %158, label %159, label %211

159:                                              ; preds = %153
  %160 = load ptr, ptr %29, align 8
  %161 = load ptr, ptr %31, align 8
  %162 = getelementptr inbounds i8, ptr %161, i64 96
  %163 = load ptr, ptr %162, align 8
  %164 = insertelement <8 x double> poison, double %155, i64 0
  %165 = shufflevector <8 x double> %164, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %165, ptr %163, align 8
  %166 = load ptr, ptr %161, align 8
  %167 = getelementptr inbounds i8, ptr %161, i64 192
  %168 = load ptr, ptr %167, align 8
  %169 = getelementptr inbounds i8, ptr %161, i64 8
  %170 = load i64, ptr %169, align 8
  %171 = load ptr, ptr %1, align 8
  %172 = load ptr, ptr %171, align 8
  %173 = getelementptr inbounds i8, ptr %172, i64 24
  %174 = load i64, ptr %173, align 8
  %175 = load ptr, ptr %162, align 8
  %176 = load ptr, ptr %47, align 8
  %177 = load ptr, ptr %176, align 8
  %178 = getelementptr inbounds i8, ptr %177, i64 16
  %179 = load i64, ptr %178, align 8
  tail call fastcc void @nested(ptr noundef %160, ptr noundef %166, ptr noundef %168, i64 noundef %170, i64 noundef %174, ptr noundef %175, i64 noundef %179) #8
  %180 = fmul double %155, %3
  %181 = fadd double %180, %2
  %182 = load ptr, ptr %54, align 8
  store double %181, ptr %182, align 8
  %183 = load ptr, ptr %28, align 8
  %184 = getelementptr inbounds i8, ptr %183, i64 40
  %185 = load i64, ptr %184, align 8
  %186 = icmp eq i64 %185, 0
  br i1 %186, label %188, label %187

187:                                              ; preds = %159
  tail call fastcc void @settle(ptr noundef nonnull %28) #8
  br label %188

188:                                              ; preds = %187, %159
  %189 = load i64, ptr %62, align 8
  %190 = icmp sgt i64 %189, 0
  br i1 %190, label %191, label %192

191:                                              ; preds = %188
  tail call fastcc void @sample(ptr noundef nonnull %28) #8
  br label %192

192:                                              ; preds = %188, %191
  %193 = load ptr, ptr %8, align 8
  %194 = load i64, ptr %193, align 8
  %195 = load ptr, ptr %69, align 8
  %196 = load ptr, ptr %29, align 8
  %197 = load ptr, ptr %72, align 8
  %198 = load ptr, ptr %74, align 8
  %199 = load ptr, ptr %14, align 8
  %200 = getelementptr inbounds i8, ptr %193, i64 8
  %201 = load i64, ptr %200, align 8
  %202 = getelementptr inbounds double, ptr %199, i64 %201
  %203 = inttoptr i64 %194 to ptr
  %204 = load ptr, ptr %203, align 8
  %205 = tail call i32 %204(ptr noundef %195, ptr noundef %196, ptr noundef %197, ptr noundef %198, ptr noundef %202) #9
  %206 = load double, ptr %20, align 8
  %207 = fmul double %206, %13
  %208 = fcmp ogt double %207, 0.000000e+00
  %209 = select i1 %208, double %149, double %155
  %210 = select i1 %208, double %155, double %150
  br label %211

211:                                              ; preds = %153, %192
  %212 = phi double [ %209, %192 ], [ %149, %153 ]
  %213 = phi double [ %210, %192 ], [ %150, %153 ]
  br i1 %158, label %148, label %214

214:                                              ; preds = %148, %211, %143
  %215 = phi double [ %4, %143 ], [ %212, %211 ], [ %149, %148 ]
  ret double %215
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
  br i1 %28, label %16, label %29, !llvm.loop !33

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
  br i1 %60, label %49, label %61, !llvm.loop !34

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
  br i1 %88, label %14, label %13, !llvm.loop !35
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
  br i1 %71, label %214, label %72, !llvm.loop !36

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
!36 = distinct !{!36, !4, !5}
