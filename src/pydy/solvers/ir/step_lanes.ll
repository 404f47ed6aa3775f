; sources 53fdd933c2c55184d96d53da0a6ce67c58b6d6fbe5ac4a146f8180a4b4b5c139
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

define noundef i64 @step_lanes(ptr noundef %0) #0 {
  %2 = alloca [8 x i64], align 16
  %3 = alloca %struct.Stepper, align 8
  %4 = alloca [8 x double], align 16
  %5 = alloca i64, align 8
  store ptr %0, ptr %3, align 8
  %6 = getelementptr inbounds i8, ptr %3, i64 8
  %7 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %7, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %3, i64 16
  %9 = getelementptr inbounds i8, ptr %0, i64 360
  store ptr %9, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 912
  %11 = load ptr, ptr %7, align 8
  %12 = getelementptr inbounds i8, ptr %11, i64 8
  %13 = load i64, ptr %12, align 8
  %14 = load ptr, ptr %0, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 960
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %0, i64 968
  %18 = load i64, ptr %17, align 8
  %19 = getelementptr double, ptr %16, i64 %18
  %20 = getelementptr i8, ptr %19, i64 -16
  %21 = load double, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %0, i64 936
  %23 = load ptr, ptr %22, align 8
  %24 = load double, ptr %23, align 8
  %25 = load ptr, ptr %10, align 8
  %26 = getelementptr inbounds i8, ptr %25, i64 16
  %27 = load i64, ptr %26, align 8
  %28 = getelementptr inbounds i8, ptr %0, i64 120
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds i8, ptr %14, i64 8
  %31 = load i64, ptr %30, align 8
  %32 = getelementptr inbounds i8, ptr %14, i64 32
  %33 = load i64, ptr %32, align 8
  %34 = getelementptr inbounds i8, ptr %0, i64 1136
  %35 = load i64, ptr %34, align 8
  %36 = icmp sgt i64 %35, 0
  %37 = getelementptr inbounds i8, ptr %0, i64 528
  %38 = load ptr, ptr %37, align 8
  %39 = load i64, ptr %14, align 8
  %40 = getelementptr inbounds i8, ptr %0, i64 368
  %41 = load i64, ptr %40, align 8
  %42 = mul nsw i64 %41, %39
  store i64 0, ptr %5, align 8
  %43 = getelementptr inbounds i8, ptr %0, i64 864
  %44 = load ptr, ptr %43, align 8
  br label %133

45:                                               ; preds = %133
  %46 = getelementptr inbounds i8, ptr %0, i64 624
  %47 = sitofp i64 %27 to double
  %48 = icmp sgt i64 %31, 0
  %49 = icmp ne i64 %33, 1
  %50 = select i1 %36, i1 true, i1 %49
  %51 = getelementptr inbounds double, ptr %38, i64 %42
  store i64 %141, ptr %5, align 8
  %52 = getelementptr inbounds i8, ptr %0, i64 864
  %53 = getelementptr inbounds i8, ptr %0, i64 744
  %54 = insertelement <8 x double> poison, double %21, i64 0
  %55 = shufflevector <8 x double> %54, <8 x double> poison, <8 x i32> zeroinitializer
  %56 = getelementptr inbounds i8, ptr %0, i64 648
  %57 = insertelement <8 x double> poison, double %24, i64 0
  %58 = shufflevector <8 x double> %57, <8 x double> poison, <8 x i32> zeroinitializer
  %59 = getelementptr inbounds i8, ptr %0, i64 768
  %60 = getelementptr inbounds i8, ptr %0, i64 792
  %61 = insertelement <8 x double> poison, double %47, i64 0
  %62 = shufflevector <8 x double> %61, <8 x double> poison, <8 x i32> zeroinitializer
  %63 = getelementptr inbounds i8, ptr %0, i64 432
  %64 = getelementptr inbounds i8, ptr %0, i64 408
  %65 = getelementptr inbounds i8, ptr %0, i64 24
  %66 = getelementptr inbounds i8, ptr %0, i64 528
  %67 = getelementptr inbounds i8, ptr %0, i64 48
  %68 = getelementptr inbounds i8, ptr %0, i64 72
  %69 = getelementptr inbounds i8, ptr %0, i64 368
  %70 = getelementptr inbounds i8, ptr %0, i64 96
  %71 = getelementptr inbounds i8, ptr %0, i64 168
  %72 = getelementptr inbounds i8, ptr %0, i64 272
  %73 = getelementptr inbounds i8, ptr %0, i64 192
  %74 = getelementptr inbounds i8, ptr %0, i64 240
  %75 = getelementptr inbounds i8, ptr %0, i64 384
  %76 = getelementptr inbounds i8, ptr %0, i64 24
  %77 = getelementptr inbounds i8, ptr %0, i64 528
  %78 = getelementptr inbounds i8, ptr %0, i64 48
  %79 = getelementptr inbounds i8, ptr %0, i64 72
  %80 = getelementptr inbounds i8, ptr %0, i64 384
  %81 = getelementptr inbounds i8, ptr %0, i64 168
  %82 = getelementptr inbounds i8, ptr %0, i64 272
  %83 = getelementptr inbounds i8, ptr %0, i64 192
  %84 = getelementptr inbounds i8, ptr %0, i64 240
  %85 = icmp sgt i64 %13, 0
  %86 = getelementptr inbounds i8, ptr %0, i64 384
  %87 = getelementptr inbounds i8, ptr %0, i64 504
  %88 = getelementptr inbounds i8, ptr %0, i64 368
  %89 = getelementptr inbounds i8, ptr %0, i64 480
  %90 = getelementptr inbounds i8, ptr %0, i64 600
  %91 = getelementptr inbounds i8, ptr %0, i64 576
  %92 = getelementptr inbounds i8, ptr %0, i64 384
  %93 = getelementptr inbounds i8, ptr %0, i64 384
  %94 = getelementptr inbounds i8, ptr %0, i64 168
  %95 = getelementptr inbounds i8, ptr %0, i64 272
  %96 = getelementptr inbounds i8, ptr %0, i64 192
  %97 = getelementptr inbounds i8, ptr %0, i64 240
  %98 = getelementptr inbounds i8, ptr %0, i64 816
  %99 = sext i1 %49 to i64
  %100 = uitofp i1 %50 to double
  %101 = insertelement <8 x double> poison, double %100, i64 0
  %102 = bitcast <8 x double> %101 to <8 x i64>
  %103 = shufflevector <8 x i64> %102, <8 x i64> poison, <8 x i32> zeroinitializer
  %104 = getelementptr inbounds i8, ptr %0, i64 744
  %105 = getelementptr inbounds i8, ptr %0, i64 368
  %106 = getelementptr inbounds i8, ptr %0, i64 552
  %107 = getelementptr inbounds i8, ptr %0, i64 408
  %108 = getelementptr inbounds i8, ptr %0, i64 96
  %109 = getelementptr inbounds i8, ptr %0, i64 168
  %110 = getelementptr inbounds i8, ptr %0, i64 272
  %111 = getelementptr inbounds i8, ptr %0, i64 192
  %112 = getelementptr inbounds i8, ptr %0, i64 240
  %113 = getelementptr inbounds i8, ptr %0, i64 480
  %114 = getelementptr inbounds i8, ptr %14, i64 16
  %115 = getelementptr inbounds i8, ptr %0, i64 720
  %116 = getelementptr inbounds i8, ptr %0, i64 408
  %117 = getelementptr inbounds i8, ptr %0, i64 888
  %118 = getelementptr inbounds i8, ptr %0, i64 456
  %119 = getelementptr inbounds i8, ptr %0, i64 888
  %120 = getelementptr inbounds i8, ptr %0, i64 384
  %121 = getelementptr inbounds i8, ptr %0, i64 672
  %122 = getelementptr inbounds i8, ptr %0, i64 696
  %123 = getelementptr inbounds i8, ptr %29, i64 24
  %124 = getelementptr inbounds i8, ptr %29, i64 8
  %125 = getelementptr inbounds i8, ptr %29, i64 16
  %126 = getelementptr inbounds i8, ptr %29, i64 32
  %127 = getelementptr inbounds i8, ptr %29, i64 40
  %128 = getelementptr inbounds i8, ptr %29, i64 24
  %129 = getelementptr inbounds i8, ptr %29, i64 32
  %130 = getelementptr inbounds i8, ptr %0, i64 840
  %131 = icmp sgt i64 %13, 0
  %132 = getelementptr inbounds i8, ptr %0, i64 384
  br label %144

133:                                              ; preds = %1, %133
  %134 = phi i64 [ 0, %1 ], [ %142, %133 ]
  %135 = phi i64 [ 0, %1 ], [ %141, %133 ]
  %136 = getelementptr inbounds i64, ptr %44, i64 %134
  %137 = load i64, ptr %136, align 8
  %138 = icmp sgt i64 %137, -1
  %139 = zext i1 %138 to i64
  %140 = shl nuw nsw i64 %139, %134
  %141 = or i64 %140, %135
  %142 = add nuw nsw i64 %134, 1
  %143 = icmp eq i64 %142, 8
  br i1 %143, label %45, label %133, !llvm.loop !3

144:                                              ; preds = %171, %45
  %145 = phi i32 [ 1, %45 ], [ %172, %171 ]
  %146 = icmp eq i32 %145, 0
  br i1 %146, label %173, label %147

147:                                              ; preds = %144
  %148 = call fastcc i64 @fill(ptr noundef nonnull %0, ptr noundef nonnull %5) #10
  %149 = load i64, ptr %5, align 8
  %150 = icmp eq i64 %149, 0
  br i1 %150, label %168, label %151

151:                                              ; preds = %147
  %152 = icmp eq i64 %148, 0
  br i1 %152, label %168, label %153

153:                                              ; preds = %151
  call fastcc void @start(ptr noundef nonnull %0, ptr noundef nonnull %3, i64 noundef %148) #10
  br label %154

154:                                              ; preds = %153, %163
  %155 = phi i32 [ 0, %153 ], [ %165, %163 ]
  %156 = phi i64 [ 0, %153 ], [ %166, %163 ]
  %157 = icmp eq i32 %155, 0
  br i1 %157, label %158, label %163

158:                                              ; preds = %154
  %159 = load ptr, ptr %52, align 8
  %160 = getelementptr inbounds i64, ptr %159, i64 %156
  %161 = load i64, ptr %160, align 8
  %162 = icmp eq i64 %161, -1
  br label %163

163:                                              ; preds = %158, %154
  %164 = phi i1 [ true, %154 ], [ %162, %158 ]
  %165 = zext i1 %164 to i32
  %166 = add nuw nsw i64 %156, 1
  %167 = icmp eq i64 %166, 8
  br i1 %167, label %168, label %154, !llvm.loop !6

168:                                              ; preds = %163, %151, %147
  %169 = phi i32 [ 1, %147 ], [ 8, %151 ], [ 0, %163 ]
  %170 = phi i32 [ %145, %147 ], [ %145, %151 ], [ %165, %163 ]
  switch i32 %169, label %1097 [
    i32 0, label %171
    i32 8, label %173
  ]

171:                                              ; preds = %168, %1069, %1095, %227
  %172 = phi i32 [ %170, %168 ], [ %820, %1069 ], [ 1, %1095 ], [ 1, %227 ]
  br label %144, !llvm.loop !7

173:                                              ; preds = %168, %144
  %174 = phi i32 [ %170, %168 ], [ 0, %144 ]
  %175 = load ptr, ptr %10, align 8
  %176 = getelementptr inbounds i8, ptr %175, i64 8
  %177 = load i64, ptr %176, align 8
  %178 = icmp slt i64 %177, 1
  br i1 %178, label %1097, label %179

179:                                              ; preds = %173
  %180 = add nsw i64 %177, -1
  store i64 %180, ptr %176, align 8
  %181 = load i64, ptr %5, align 8
  %182 = trunc i64 %181 to i8
  %183 = bitcast i8 %182 to <8 x i1>
  %184 = load ptr, ptr %46, align 8
  %185 = load <8 x double>, ptr %184, align 8
  br i1 %48, label %189, label %186

186:                                              ; preds = %179
  %187 = load ptr, ptr %53, align 8
  %188 = load <8 x double>, ptr %187, align 8
  br label %189

189:                                              ; preds = %179, %186
  %190 = phi <8 x double> [ %188, %186 ], [ %55, %179 ]
  %191 = load ptr, ptr %56, align 8
  %192 = load <8 x double>, ptr %191, align 8
  br i1 %48, label %193, label %196

193:                                              ; preds = %189
  %194 = fcmp olt <8 x double> %192, %58
  %195 = select <8 x i1> %194, <8 x double> %192, <8 x double> %58
  br label %202

196:                                              ; preds = %189
  %197 = fsub <8 x double> %190, %185
  %198 = fdiv <8 x double> %197, %192
  %199 = fmul <8 x double> %198, <double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1>
  %200 = tail call <8 x double> @llvm.ceil.v8f64(<8 x double> %199)
  %201 = fdiv <8 x double> %197, %200
  br label %202

202:                                              ; preds = %196, %193
  %203 = phi <8 x double> [ %195, %193 ], [ %201, %196 ]
  %204 = fadd <8 x double> %185, %203
  %205 = fmul <8 x double> %203, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %206 = fsub <8 x double> %190, %205
  %207 = fcmp ogt <8 x double> %204, %206
  %208 = fsub <8 x double> %190, %185
  %209 = select <8 x i1> %207, <8 x double> %208, <8 x double> %203
  %210 = select <8 x i1> %207, <8 x double> %190, <8 x double> %204
  %211 = select <8 x i1> %183, <8 x double> %209, <8 x double> zeroinitializer
  %212 = load ptr, ptr %59, align 8
  %213 = load <8 x double>, ptr %212, align 8
  %214 = load ptr, ptr %60, align 8
  %215 = load <8 x double>, ptr %214, align 8
  %216 = fadd <8 x double> %213, %215
  %217 = fcmp oge <8 x double> %216, %62
  %218 = fmul <8 x double> %211, <double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02>
  %219 = fadd <8 x double> %185, %218
  %220 = fcmp ule <8 x double> %219, %185
  %221 = fcmp une <8 x double> %210, %190
  %222 = and <8 x i1> %220, %221
  %223 = or <8 x i1> %222, %217
  %224 = and <8 x i1> %223, %183
  %225 = bitcast <8 x i1> %224 to i8
  %226 = icmp eq i8 %225, 0
  br i1 %226, label %234, label %227

227:                                              ; preds = %202
  %228 = zext i8 %225 to i64
  %229 = bitcast <8 x i1> %217 to i8
  %230 = zext i8 %229 to i64
  %231 = and i64 %228, %230
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %231, i64 noundef 1) #10
  %232 = xor i64 %230, -1
  %233 = and i64 %228, %232
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %233, i64 noundef -1) #10
  br label %171

234:                                              ; preds = %202
  %235 = load ptr, ptr %0, align 8
  %236 = load i64, ptr %235, align 8
  %237 = load ptr, ptr %63, align 8
  store <8 x double> %211, ptr %237, align 8
  %238 = icmp sgt i64 %236, 1
  br i1 %238, label %239, label %288

239:                                              ; preds = %234, %276
  %240 = phi i64 [ %285, %276 ], [ 0, %234 ]
  %241 = phi i64 [ %286, %276 ], [ 1, %234 ]
  %242 = load ptr, ptr %64, align 8
  %243 = load ptr, ptr %9, align 8
  %244 = load ptr, ptr %7, align 8
  %245 = getelementptr inbounds i8, ptr %244, i64 16
  %246 = load i64, ptr %245, align 8
  %247 = load ptr, ptr %65, align 8
  %248 = getelementptr inbounds i64, ptr %247, i64 %241
  %249 = load i64, ptr %248, align 8
  %250 = getelementptr i8, ptr %248, i64 8
  %251 = load i64, ptr %250, align 8
  %252 = xor i64 %249, -1
  %253 = add i64 %251, %252
  %254 = load ptr, ptr %63, align 8
  %255 = load ptr, ptr %66, align 8
  %256 = load ptr, ptr %67, align 8
  %257 = getelementptr inbounds i64, ptr %256, i64 %249
  %258 = load ptr, ptr %68, align 8
  %259 = getelementptr inbounds double, ptr %258, i64 %249
  tail call fastcc void @combine(ptr noundef %242, ptr noundef %243, ptr noundef %254, ptr noundef %255, ptr noundef %257, ptr noundef %259, i64 noundef %253, i64 noundef %246) #10
  %260 = load ptr, ptr %66, align 8
  %261 = load i64, ptr %69, align 8
  %262 = mul nsw i64 %261, %241
  %263 = getelementptr inbounds double, ptr %260, i64 %262
  %264 = load ptr, ptr %70, align 8
  %265 = getelementptr inbounds double, ptr %264, i64 %241
  %266 = load double, ptr %265, align 8
  %267 = insertelement <8 x double> poison, double %266, i64 0
  %268 = shufflevector <8 x double> %267, <8 x double> poison, <8 x i32> zeroinitializer
  %269 = fmul <8 x double> %211, %268
  %270 = fadd <8 x double> %185, %269
  %271 = load ptr, ptr %64, align 8
  %272 = load ptr, ptr %71, align 8
  store <8 x double> %270, ptr %272, align 8
  %273 = load i64, ptr %72, align 8
  %274 = icmp sgt i64 %273, 0
  br i1 %274, label %275, label %276

275:                                              ; preds = %239
  tail call fastcc void @sample(ptr noundef nonnull %7) #10
  br label %276

276:                                              ; preds = %239, %275
  %277 = load ptr, ptr %7, align 8
  %278 = load i64, ptr %277, align 8
  %279 = load ptr, ptr %71, align 8
  %280 = load ptr, ptr %73, align 8
  %281 = load ptr, ptr %74, align 8
  %282 = inttoptr i64 %278 to ptr
  %283 = tail call i32 %282(ptr noundef %279, ptr noundef %271, ptr noundef %280, ptr noundef %281, ptr noundef %263) #11
  %284 = zext i32 %283 to i64
  %285 = or i64 %240, %284
  %286 = add nuw nsw i64 %241, 1
  %287 = icmp eq i64 %286, %236
  br i1 %287, label %288, label %239, !llvm.loop !8

288:                                              ; preds = %276, %234
  %289 = phi i64 [ 0, %234 ], [ %285, %276 ]
  %290 = load ptr, ptr %75, align 8
  %291 = load ptr, ptr %9, align 8
  %292 = load ptr, ptr %7, align 8
  %293 = getelementptr inbounds i8, ptr %292, i64 16
  %294 = load i64, ptr %293, align 8
  %295 = load ptr, ptr %76, align 8
  %296 = getelementptr inbounds i64, ptr %295, i64 %236
  %297 = load i64, ptr %296, align 8
  %298 = getelementptr i8, ptr %296, i64 8
  %299 = load i64, ptr %298, align 8
  %300 = xor i64 %297, -1
  %301 = add i64 %299, %300
  %302 = load ptr, ptr %63, align 8
  %303 = load ptr, ptr %77, align 8
  %304 = load ptr, ptr %78, align 8
  %305 = getelementptr inbounds i64, ptr %304, i64 %297
  %306 = load ptr, ptr %79, align 8
  %307 = getelementptr inbounds double, ptr %306, i64 %297
  tail call fastcc void @combine(ptr noundef %290, ptr noundef %291, ptr noundef %302, ptr noundef %303, ptr noundef %305, ptr noundef %307, i64 noundef %301, i64 noundef %294) #10
  br i1 %49, label %324, label %308

308:                                              ; preds = %288
  %309 = load ptr, ptr %80, align 8
  %310 = load ptr, ptr %81, align 8
  store <8 x double> %210, ptr %310, align 8
  %311 = load i64, ptr %82, align 8
  %312 = icmp sgt i64 %311, 0
  br i1 %312, label %313, label %314

313:                                              ; preds = %308
  tail call fastcc void @sample(ptr noundef nonnull %7) #10
  br label %314

314:                                              ; preds = %308, %313
  %315 = load ptr, ptr %7, align 8
  %316 = load i64, ptr %315, align 8
  %317 = load ptr, ptr %81, align 8
  %318 = load ptr, ptr %83, align 8
  %319 = load ptr, ptr %84, align 8
  %320 = inttoptr i64 %316 to ptr
  %321 = tail call i32 %320(ptr noundef %317, ptr noundef %309, ptr noundef %318, ptr noundef %319, ptr noundef %51) #11
  %322 = zext i32 %321 to i64
  %323 = or i64 %289, %322
  br label %324

324:                                              ; preds = %314, %288
  %325 = phi i64 [ %323, %314 ], [ %289, %288 ]
  br i1 %48, label %329, label %326

326:                                              ; preds = %324
  br i1 %85, label %327, label %502

327:                                              ; preds = %326
  %328 = load ptr, ptr %86, align 8
  br label %492

329:                                              ; preds = %324
  %330 = load ptr, ptr %7, align 8
  %331 = load ptr, ptr %0, align 8
  %332 = getelementptr inbounds i8, ptr %330, i64 24
  %333 = load i64, ptr %332, align 8
  %334 = getelementptr inbounds i8, ptr %331, i64 8
  %335 = load i64, ptr %334, align 8
  %336 = load ptr, ptr %87, align 8
  %337 = load i64, ptr %88, align 8
  %338 = getelementptr inbounds double, ptr %336, i64 %337
  %339 = icmp sgt i64 %335, 0
  br i1 %339, label %340, label %342

340:                                              ; preds = %329
  %341 = getelementptr inbounds i8, ptr %330, i64 32
  br label %350

342:                                              ; preds = %350, %329
  %343 = icmp sgt i64 %333, 0
  br i1 %343, label %344, label %376

344:                                              ; preds = %342
  %345 = load ptr, ptr %9, align 8
  %346 = load ptr, ptr %75, align 8
  %347 = load ptr, ptr %90, align 8
  %348 = load ptr, ptr %91, align 8
  %349 = load ptr, ptr %87, align 8
  br label %439

350:                                              ; preds = %340, %350
  %351 = phi i64 [ 0, %340 ], [ %374, %350 ]
  %352 = load i64, ptr %331, align 8
  %353 = load i64, ptr %341, align 8
  %354 = load ptr, ptr %87, align 8
  %355 = load i64, ptr %88, align 8
  %356 = mul nsw i64 %355, %351
  %357 = getelementptr inbounds double, ptr %354, i64 %356
  %358 = load ptr, ptr %89, align 8
  %359 = load ptr, ptr %76, align 8
  %360 = getelementptr i64, ptr %359, i64 %352
  %361 = getelementptr i8, ptr %360, i64 8
  %362 = getelementptr i64, ptr %361, i64 %351
  %363 = load i64, ptr %362, align 8
  %364 = getelementptr i8, ptr %362, i64 8
  %365 = load i64, ptr %364, align 8
  %366 = xor i64 %363, -1
  %367 = add i64 %365, %366
  %368 = load ptr, ptr %63, align 8
  %369 = load ptr, ptr %77, align 8
  %370 = load ptr, ptr %78, align 8
  %371 = getelementptr inbounds i64, ptr %370, i64 %363
  %372 = load ptr, ptr %79, align 8
  %373 = getelementptr inbounds double, ptr %372, i64 %363
  tail call fastcc void @combine(ptr noundef %357, ptr noundef %358, ptr noundef %368, ptr noundef %369, ptr noundef %371, ptr noundef %373, i64 noundef %367, i64 noundef %353) #10
  %374 = add nuw nsw i64 %351, 1
  %375 = icmp eq i64 %374, %335
  br i1 %375, label %342, label %350, !llvm.loop !9

376:                                              ; preds = %439, %342
  %377 = phi <8 x double> [ zeroinitializer, %342 ], [ %472, %439 ]
  %378 = phi <8 x double> [ zeroinitializer, %342 ], [ %470, %439 ]
  %379 = load ptr, ptr %75, align 8
  %380 = getelementptr inbounds i8, ptr %330, i64 8
  %381 = load i64, ptr %380, align 8
  %382 = add nsw i64 %381, -3
  %383 = getelementptr i8, ptr %379, i64 64
  %384 = getelementptr i8, ptr %379, i64 128
  %385 = getelementptr i8, ptr %379, i64 192
  %386 = icmp slt i64 %333, %382
  br i1 %386, label %394, label %387

387:                                              ; preds = %394, %376
  %388 = phi <8 x double> [ zeroinitializer, %376 ], [ %404, %394 ]
  %389 = phi <8 x double> [ zeroinitializer, %376 ], [ %409, %394 ]
  %390 = phi <8 x double> [ zeroinitializer, %376 ], [ %414, %394 ]
  %391 = phi <8 x double> [ zeroinitializer, %376 ], [ %419, %394 ]
  %392 = phi i64 [ %333, %376 ], [ %420, %394 ]
  %393 = icmp slt i64 %392, %381
  br i1 %393, label %422, label %432

394:                                              ; preds = %376, %394
  %395 = phi i64 [ %420, %394 ], [ %333, %376 ]
  %396 = phi <8 x double> [ %419, %394 ], [ zeroinitializer, %376 ]
  %397 = phi <8 x double> [ %414, %394 ], [ zeroinitializer, %376 ]
  %398 = phi <8 x double> [ %409, %394 ], [ zeroinitializer, %376 ]
  %399 = phi <8 x double> [ %404, %394 ], [ zeroinitializer, %376 ]
  %400 = shl nsw i64 %395, 6
  %401 = getelementptr inbounds i8, ptr %379, i64 %400
  %402 = load <8 x double>, ptr %401, align 8
  %403 = fmul <8 x double> %402, zeroinitializer
  %404 = fadd <8 x double> %399, %403
  %405 = shl i64 %395, 6
  %406 = getelementptr i8, ptr %383, i64 %405
  %407 = load <8 x double>, ptr %406, align 8
  %408 = fmul <8 x double> %407, zeroinitializer
  %409 = fadd <8 x double> %398, %408
  %410 = shl i64 %395, 6
  %411 = getelementptr i8, ptr %384, i64 %410
  %412 = load <8 x double>, ptr %411, align 8
  %413 = fmul <8 x double> %412, zeroinitializer
  %414 = fadd <8 x double> %397, %413
  %415 = shl i64 %395, 6
  %416 = getelementptr i8, ptr %385, i64 %415
  %417 = load <8 x double>, ptr %416, align 8
  %418 = fmul <8 x double> %417, zeroinitializer
  %419 = fadd <8 x double> %396, %418
  %420 = add nsw i64 %395, 4
  %421 = icmp slt i64 %420, %382
  br i1 %421, label %394, label %387, !llvm.loop !10

422:                                              ; preds = %387, %422
  %423 = phi i64 [ %430, %422 ], [ %392, %387 ]
  %424 = phi <8 x double> [ %429, %422 ], [ %388, %387 ]
  %425 = shl nsw i64 %423, 6
  %426 = getelementptr inbounds i8, ptr %379, i64 %425
  %427 = load <8 x double>, ptr %426, align 8
  %428 = fmul <8 x double> %427, zeroinitializer
  %429 = fadd <8 x double> %424, %428
  %430 = add nsw i64 %423, 1
  %431 = icmp eq i64 %430, %381
  br i1 %431, label %432, label %422, !llvm.loop !11

432:                                              ; preds = %422, %387
  %433 = phi <8 x double> [ %388, %387 ], [ %429, %422 ]
  %434 = fadd <8 x double> %389, %433
  %435 = fadd <8 x double> %390, %391
  %436 = fadd <8 x double> %435, %434
  %437 = fadd <8 x double> %378, %436
  %438 = icmp eq i64 %335, 2
  br i1 %438, label %475, label %486

439:                                              ; preds = %344, %439
  %440 = phi <8 x double> [ zeroinitializer, %344 ], [ %470, %439 ]
  %441 = phi <8 x double> [ zeroinitializer, %344 ], [ %472, %439 ]
  %442 = phi i64 [ 0, %344 ], [ %473, %439 ]
  %443 = shl nsw i64 %442, 6
  %444 = getelementptr inbounds i8, ptr %345, i64 %443
  %445 = load <8 x double>, ptr %444, align 8
  %446 = getelementptr inbounds i8, ptr %346, i64 %443
  %447 = load <8 x double>, ptr %446, align 8
  %448 = getelementptr inbounds double, ptr %347, i64 %442
  %449 = load double, ptr %448, align 8
  %450 = insertelement <8 x double> poison, double %449, i64 0
  %451 = shufflevector <8 x double> %450, <8 x double> poison, <8 x i32> zeroinitializer
  %452 = getelementptr inbounds double, ptr %348, i64 %442
  %453 = load double, ptr %452, align 8
  %454 = insertelement <8 x double> poison, double %453, i64 0
  %455 = shufflevector <8 x double> %454, <8 x double> poison, <8 x i32> zeroinitializer
  %456 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %445)
  %457 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %447)
  %458 = fcmp ogt <8 x double> %456, %457
  %459 = select <8 x i1> %458, <8 x double> %456, <8 x double> %457
  %460 = fmul <8 x double> %459, %455
  %461 = fadd <8 x double> %451, %460
  %462 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %461
  %463 = getelementptr inbounds i8, ptr %349, i64 %443
  %464 = load <8 x double>, ptr %463, align 8
  %465 = fmul <8 x double> %464, %462
  %466 = getelementptr inbounds i8, ptr %338, i64 %443
  %467 = load <8 x double>, ptr %466, align 8
  %468 = fmul <8 x double> %467, %462
  %469 = fmul <8 x double> %465, %465
  %470 = fadd <8 x double> %440, %469
  %471 = fmul <8 x double> %468, %468
  %472 = fadd <8 x double> %441, %471
  %473 = add nuw nsw i64 %442, 1
  %474 = icmp eq i64 %473, %333
  br i1 %474, label %376, label %439, !llvm.loop !12

475:                                              ; preds = %432
  %476 = fmul <8 x double> %377, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %477 = fadd <8 x double> %476, %437
  %478 = sitofp i64 %333 to double
  %479 = insertelement <8 x double> poison, double %478, i64 0
  %480 = shufflevector <8 x double> %479, <8 x double> poison, <8 x i32> zeroinitializer
  %481 = fmul <8 x double> %480, %477
  %482 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %481)
  %483 = fdiv <8 x double> %437, %482
  %484 = fcmp oeq <8 x double> %437, zeroinitializer
  %485 = select <8 x i1> %484, <8 x double> zeroinitializer, <8 x double> %483
  br label %502

486:                                              ; preds = %432
  %487 = sitofp i64 %333 to double
  %488 = insertelement <8 x double> poison, double %487, i64 0
  %489 = shufflevector <8 x double> %488, <8 x double> poison, <8 x i32> zeroinitializer
  %490 = fdiv <8 x double> %437, %489
  %491 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %490)
  br label %502

492:                                              ; preds = %327, %492
  %493 = phi <8 x double> [ zeroinitializer, %327 ], [ %499, %492 ]
  %494 = phi i64 [ 0, %327 ], [ %500, %492 ]
  %495 = shl nsw i64 %494, 6
  %496 = getelementptr inbounds i8, ptr %328, i64 %495
  %497 = load <8 x double>, ptr %496, align 8
  %498 = fmul <8 x double> %497, zeroinitializer
  %499 = fadd <8 x double> %493, %498
  %500 = add nuw nsw i64 %494, 1
  %501 = icmp eq i64 %500, %13
  br i1 %501, label %502, label %492, !llvm.loop !13

502:                                              ; preds = %492, %326, %486, %475
  %503 = phi <8 x double> [ %485, %475 ], [ %491, %486 ], [ zeroinitializer, %326 ], [ %499, %492 ]
  %504 = fcmp uge <8 x double> %503, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %505 = trunc i64 %325 to i8
  %506 = bitcast i8 %505 to <8 x i1>
  %507 = select <8 x i1> %506, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %504
  %508 = xor <8 x i1> %507, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %509 = select <8 x i1> %508, <8 x i1> %183, <8 x i1> zeroinitializer
  %510 = sext <8 x i1> %509 to <8 x i64>
  br i1 %36, label %511, label %523

511:                                              ; preds = %502
  %512 = xor <8 x i1> %507, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %513 = select <8 x i1> %512, <8 x i1> %183, <8 x i1> zeroinitializer
  %514 = bitcast <8 x i1> %513 to i8
  %515 = icmp eq i8 %514, 0
  br i1 %515, label %523, label %516

516:                                              ; preds = %511
  %517 = zext i8 %514 to i64
  store <8 x double> %210, ptr %4, align 16
  %518 = load ptr, ptr %92, align 8
  %519 = call fastcc i64 @hold_lanes(ptr noundef nonnull %0, ptr noundef nonnull %4, ptr noundef %518, i64 noundef %517) #10
  %520 = trunc nuw i64 %519 to i8
  %521 = bitcast i8 %520 to <8 x i1>
  %522 = select <8 x i1> %521, <8 x i64> zeroinitializer, <8 x i64> %510
  br label %523

523:                                              ; preds = %516, %511, %502
  %524 = phi i64 [ %519, %516 ], [ 0, %511 ], [ 0, %502 ]
  %525 = phi <8 x i64> [ %522, %516 ], [ %510, %511 ], [ %510, %502 ]
  %526 = icmp ne <8 x i64> %525, zeroinitializer
  %527 = bitcast <8 x i1> %526 to i8
  %528 = icmp ne i8 %527, 0
  %529 = select i1 %50, i1 %528, i1 false
  br i1 %529, label %530, label %549

530:                                              ; preds = %523
  %531 = load ptr, ptr %93, align 8
  %532 = load ptr, ptr %94, align 8
  store <8 x double> %210, ptr %532, align 8
  %533 = load i64, ptr %95, align 8
  %534 = icmp sgt i64 %533, 0
  br i1 %534, label %535, label %536

535:                                              ; preds = %530
  tail call fastcc void @sample(ptr noundef nonnull %7) #10
  br label %536

536:                                              ; preds = %530, %535
  %537 = load ptr, ptr %7, align 8
  %538 = load i64, ptr %537, align 8
  %539 = load ptr, ptr %94, align 8
  %540 = load ptr, ptr %96, align 8
  %541 = load ptr, ptr %97, align 8
  %542 = inttoptr i64 %538 to ptr
  %543 = tail call i32 %542(ptr noundef %539, ptr noundef %531, ptr noundef %540, ptr noundef %541, ptr noundef %51) #11
  %544 = zext i32 %543 to i64
  %545 = or i64 %325, %544
  %546 = trunc i64 %545 to i8
  %547 = bitcast i8 %546 to <8 x i1>
  %548 = select <8 x i1> %547, <8 x i64> zeroinitializer, <8 x i64> %525
  br label %549

549:                                              ; preds = %536, %523
  %550 = phi <8 x i64> [ %548, %536 ], [ %525, %523 ]
  %551 = phi i64 [ %545, %536 ], [ %325, %523 ]
  %552 = load ptr, ptr %98, align 8
  %553 = load <8 x double>, ptr %552, align 8
  %554 = load i64, ptr %14, align 8
  %555 = add i64 %554, %99
  %556 = sitofp i64 %555 to double
  %557 = insertelement <8 x double> poison, double %556, i64 0
  %558 = shufflevector <8 x double> %557, <8 x double> poison, <8 x i32> zeroinitializer
  %559 = icmp slt <8 x i64> %525, zeroinitializer
  %560 = select <8 x i1> %559, <8 x i64> %103, <8 x i64> zeroinitializer
  %561 = bitcast <8 x i64> %560 to <8 x double>
  %562 = fadd <8 x double> %558, %561
  %563 = fadd <8 x double> %553, %562
  store <8 x double> %563, ptr %552, align 8
  %564 = load ptr, ptr %104, align 8
  %565 = load <8 x double>, ptr %564, align 8
  %566 = fcmp olt <8 x double> %565, %210
  %567 = select <8 x i1> %566, <8 x i64> %550, <8 x i64> zeroinitializer
  %568 = icmp ne <8 x i64> %567, zeroinitializer
  %569 = bitcast <8 x i1> %568 to i8
  %570 = zext i8 %569 to i64
  %571 = icmp eq i8 %569, 0
  br i1 %571, label %817, label %572

572:                                              ; preds = %549
  %573 = load ptr, ptr %0, align 8
  %574 = load ptr, ptr %7, align 8
  %575 = getelementptr inbounds i8, ptr %574, i64 16
  %576 = load i64, ptr %575, align 8
  %577 = load i64, ptr %573, align 8
  %578 = load i64, ptr %105, align 8
  %579 = load ptr, ptr %77, align 8
  %580 = mul nsw i64 %578, %577
  %581 = getelementptr inbounds double, ptr %579, i64 %580
  %582 = load ptr, ptr %106, align 8
  %583 = add nsw i64 %577, 1
  %584 = getelementptr inbounds i8, ptr %573, i64 16
  %585 = load i64, ptr %584, align 8
  %586 = icmp sgt i64 %585, 0
  br i1 %586, label %587, label %589

587:                                              ; preds = %572
  %588 = getelementptr inbounds i8, ptr %573, i64 8
  br label %600

589:                                              ; preds = %635, %572
  %590 = phi i64 [ 0, %572 ], [ %644, %635 ]
  %591 = getelementptr inbounds i8, ptr %573, i64 16
  %592 = load ptr, ptr %7, align 8
  %593 = getelementptr inbounds i8, ptr %592, i64 8
  %594 = load i64, ptr %593, align 8
  %595 = icmp sgt i64 %594, 0
  br i1 %595, label %596, label %649

596:                                              ; preds = %589
  %597 = getelementptr inbounds double, ptr %582, i64 %578
  %598 = shl nsw i64 %578, 4
  %599 = getelementptr inbounds i8, ptr %582, i64 %598
  br label %656

600:                                              ; preds = %587, %635
  %601 = phi i64 [ 0, %587 ], [ %644, %635 ]
  %602 = phi i64 [ %583, %587 ], [ %645, %635 ]
  %603 = load i64, ptr %588, align 8
  %604 = load ptr, ptr %107, align 8
  %605 = load ptr, ptr %9, align 8
  %606 = load ptr, ptr %76, align 8
  %607 = getelementptr i64, ptr %606, i64 %602
  %608 = getelementptr i64, ptr %607, i64 %603
  %609 = load i64, ptr %608, align 8
  %610 = getelementptr i8, ptr %608, i64 8
  %611 = load i64, ptr %610, align 8
  %612 = xor i64 %609, -1
  %613 = add i64 %611, %612
  %614 = load ptr, ptr %63, align 8
  %615 = load ptr, ptr %77, align 8
  %616 = load ptr, ptr %78, align 8
  %617 = getelementptr inbounds i64, ptr %616, i64 %609
  %618 = load ptr, ptr %79, align 8
  %619 = getelementptr inbounds double, ptr %618, i64 %609
  tail call fastcc void @combine(ptr noundef %604, ptr noundef %605, ptr noundef %614, ptr noundef %615, ptr noundef %617, ptr noundef %619, i64 noundef %613, i64 noundef %576) #10
  %620 = load ptr, ptr %77, align 8
  %621 = mul nsw i64 %602, %578
  %622 = getelementptr inbounds double, ptr %620, i64 %621
  %623 = load ptr, ptr %108, align 8
  %624 = getelementptr inbounds double, ptr %623, i64 %602
  %625 = load double, ptr %624, align 8
  %626 = insertelement <8 x double> poison, double %625, i64 0
  %627 = shufflevector <8 x double> %626, <8 x double> poison, <8 x i32> zeroinitializer
  %628 = fmul <8 x double> %211, %627
  %629 = fadd <8 x double> %185, %628
  %630 = load ptr, ptr %107, align 8
  %631 = load ptr, ptr %109, align 8
  store <8 x double> %629, ptr %631, align 8
  %632 = load i64, ptr %110, align 8
  %633 = icmp sgt i64 %632, 0
  br i1 %633, label %634, label %635

634:                                              ; preds = %600
  tail call fastcc void @sample(ptr noundef nonnull %7) #10
  br label %635

635:                                              ; preds = %600, %634
  %636 = load ptr, ptr %7, align 8
  %637 = load i64, ptr %636, align 8
  %638 = load ptr, ptr %109, align 8
  %639 = load ptr, ptr %111, align 8
  %640 = load ptr, ptr %112, align 8
  %641 = inttoptr i64 %637 to ptr
  %642 = tail call i32 %641(ptr noundef %638, ptr noundef %630, ptr noundef %639, ptr noundef %640, ptr noundef %622) #11
  %643 = zext i32 %642 to i64
  %644 = or i64 %601, %643
  %645 = add nsw i64 %602, 1
  %646 = load i64, ptr %584, align 8
  %647 = add nsw i64 %646, %583
  %648 = icmp slt i64 %645, %647
  br i1 %648, label %600, label %589, !llvm.loop !14

649:                                              ; preds = %656, %589
  %650 = getelementptr inbounds i8, ptr %573, i64 8
  %651 = load i64, ptr %650, align 8
  %652 = load i64, ptr %591, align 8
  %653 = getelementptr inbounds i8, ptr %573, i64 24
  %654 = load i64, ptr %653, align 8
  %655 = icmp sgt i64 %654, 3
  br i1 %655, label %684, label %709

656:                                              ; preds = %596, %656
  %657 = phi i64 [ 0, %596 ], [ %679, %656 ]
  %658 = load ptr, ptr %75, align 8
  %659 = shl nsw i64 %657, 6
  %660 = getelementptr inbounds i8, ptr %658, i64 %659
  %661 = load <8 x double>, ptr %660, align 8
  %662 = load ptr, ptr %9, align 8
  %663 = getelementptr inbounds i8, ptr %662, i64 %659
  %664 = load <8 x double>, ptr %663, align 8
  %665 = fsub <8 x double> %661, %664
  %666 = load ptr, ptr %77, align 8
  %667 = getelementptr inbounds i8, ptr %666, i64 %659
  %668 = load <8 x double>, ptr %667, align 8
  %669 = fmul <8 x double> %211, %668
  %670 = fsub <8 x double> %669, %665
  %671 = getelementptr inbounds i8, ptr %582, i64 %659
  store <8 x double> %665, ptr %671, align 8
  %672 = getelementptr inbounds i8, ptr %597, i64 %659
  store <8 x double> %670, ptr %672, align 8
  %673 = fsub <8 x double> %665, %670
  %674 = getelementptr inbounds i8, ptr %581, i64 %659
  %675 = load <8 x double>, ptr %674, align 8
  %676 = fmul <8 x double> %211, %675
  %677 = fsub <8 x double> %673, %676
  %678 = getelementptr inbounds i8, ptr %599, i64 %659
  store <8 x double> %677, ptr %678, align 8
  %679 = add nuw nsw i64 %657, 1
  %680 = load ptr, ptr %7, align 8
  %681 = getelementptr inbounds i8, ptr %680, i64 8
  %682 = load i64, ptr %681, align 8
  %683 = icmp slt i64 %679, %682
  br i1 %683, label %656, label %649, !llvm.loop !15

684:                                              ; preds = %649, %684
  %685 = phi i64 [ %706, %684 ], [ 3, %649 ]
  %686 = mul nsw i64 %685, %578
  %687 = getelementptr inbounds double, ptr %582, i64 %686
  %688 = load ptr, ptr %113, align 8
  %689 = load ptr, ptr %76, align 8
  %690 = getelementptr i64, ptr %689, i64 %583
  %691 = getelementptr i64, ptr %690, i64 %651
  %692 = getelementptr i64, ptr %691, i64 %652
  %693 = getelementptr i64, ptr %692, i64 %685
  %694 = getelementptr i8, ptr %693, i64 -24
  %695 = load i64, ptr %694, align 8
  %696 = getelementptr i8, ptr %693, i64 -16
  %697 = load i64, ptr %696, align 8
  %698 = xor i64 %695, -1
  %699 = add i64 %697, %698
  %700 = load ptr, ptr %63, align 8
  %701 = load ptr, ptr %77, align 8
  %702 = load ptr, ptr %78, align 8
  %703 = getelementptr inbounds i64, ptr %702, i64 %695
  %704 = load ptr, ptr %79, align 8
  %705 = getelementptr inbounds double, ptr %704, i64 %695
  tail call fastcc void @combine(ptr noundef %687, ptr noundef %688, ptr noundef %700, ptr noundef %701, ptr noundef %703, ptr noundef %705, i64 noundef %699, i64 noundef %576) #10
  %706 = add nuw nsw i64 %685, 1
  %707 = load i64, ptr %653, align 8
  %708 = icmp slt i64 %706, %707
  br i1 %708, label %684, label %709, !llvm.loop !16

709:                                              ; preds = %684, %649
  %710 = and i64 %590, %570
  %711 = load ptr, ptr %98, align 8
  %712 = load <8 x double>, ptr %711, align 8
  %713 = load i64, ptr %114, align 8
  %714 = sitofp i64 %713 to double
  %715 = insertelement <8 x double> poison, double %714, i64 0
  %716 = bitcast <8 x double> %715 to <8 x i64>
  %717 = shufflevector <8 x i64> %716, <8 x i64> poison, <8 x i32> zeroinitializer
  %718 = icmp slt <8 x i64> %567, zeroinitializer
  %719 = select <8 x i1> %718, <8 x i64> %717, <8 x i64> zeroinitializer
  %720 = bitcast <8 x i64> %719 to <8 x double>
  %721 = fadd <8 x double> %712, %720
  store <8 x double> %721, ptr %711, align 8
  %722 = icmp eq i64 %710, 0
  br i1 %722, label %730, label %723

723:                                              ; preds = %709
  tail call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %710, i64 noundef 3) #10
  %724 = xor i64 %710, -1
  %725 = and i64 %181, %724
  store i64 %725, ptr %5, align 8
  %726 = trunc i64 %725 to i8
  %727 = bitcast i8 %726 to <8 x i1>
  %728 = select <8 x i1> %727, <8 x i64> %550, <8 x i64> zeroinitializer
  %729 = select <8 x i1> %727, <8 x i64> %567, <8 x i64> zeroinitializer
  br label %730

730:                                              ; preds = %723, %709
  %731 = phi <8 x i64> [ %729, %723 ], [ %567, %709 ]
  %732 = phi <8 x i64> [ %728, %723 ], [ %550, %709 ]
  %733 = phi i32 [ 1, %723 ], [ %174, %709 ]
  %734 = icmp ne <8 x i64> %731, zeroinitializer
  %735 = bitcast <8 x i1> %734 to i8
  %736 = load ptr, ptr %46, align 8
  %737 = load <8 x double>, ptr %736, align 8
  %738 = load ptr, ptr %63, align 8
  %739 = load <8 x double>, ptr %738, align 8
  %740 = load ptr, ptr %115, align 8
  %741 = load <8 x double>, ptr %740, align 8
  %742 = load ptr, ptr %104, align 8
  %743 = load <8 x double>, ptr %742, align 8
  %744 = load ptr, ptr %116, align 8
  %745 = load ptr, ptr %117, align 8
  br label %750

746:                                              ; preds = %750
  %747 = icmp eq i8 %735, 0
  br i1 %747, label %757, label %748

748:                                              ; preds = %746
  %749 = zext i8 %735 to i64
  br label %760

750:                                              ; preds = %730, %750
  %751 = phi i64 [ 0, %730 ], [ %755, %750 ]
  %752 = getelementptr inbounds i64, ptr %745, i64 %751
  %753 = load i64, ptr %752, align 8
  %754 = getelementptr inbounds [8 x i64], ptr %2, i64 0, i64 %751
  store i64 %753, ptr %754, align 8
  %755 = add nuw nsw i64 %751, 1
  %756 = icmp eq i64 %755, 8
  br i1 %756, label %746, label %750, !llvm.loop !17

757:                                              ; preds = %784, %746
  %758 = phi i64 [ 0, %746 ], [ %785, %784 ]
  %759 = icmp eq i64 %758, 0
  br i1 %759, label %812, label %796

760:                                              ; preds = %748, %784
  %761 = phi i64 [ %785, %784 ], [ 0, %748 ]
  %762 = phi i64 [ %794, %784 ], [ %749, %748 ]
  %763 = load ptr, ptr %104, align 8
  %764 = load <8 x double>, ptr %763, align 8
  %765 = fsub <8 x double> %764, %737
  %766 = fdiv <8 x double> %765, %739
  %767 = load ptr, ptr %118, align 8
  store <8 x double> %766, ptr %767, align 8
  %768 = load ptr, ptr %9, align 8
  %769 = load ptr, ptr %106, align 8
  %770 = load i64, ptr %105, align 8
  %771 = load ptr, ptr %0, align 8
  %772 = getelementptr inbounds i8, ptr %771, i64 24
  %773 = load i64, ptr %772, align 8
  %774 = load ptr, ptr %118, align 8
  %775 = load ptr, ptr %7, align 8
  %776 = getelementptr inbounds i8, ptr %775, i64 16
  %777 = load i64, ptr %776, align 8
  tail call fastcc void @nested(ptr noundef %744, ptr noundef %768, ptr noundef %769, i64 noundef %770, i64 noundef %773, ptr noundef %774, i64 noundef %777) #10
  %778 = load i64, ptr %34, align 8
  %779 = icmp sgt i64 %778, 0
  br i1 %779, label %780, label %784

780:                                              ; preds = %760
  %781 = load ptr, ptr %104, align 8
  %782 = tail call fastcc i64 @hold_lanes(ptr noundef nonnull %0, ptr noundef %781, ptr noundef %744, i64 noundef %762) #10
  %783 = or i64 %782, %761
  br label %784

784:                                              ; preds = %780, %760
  %785 = phi i64 [ %783, %780 ], [ %761, %760 ]
  %786 = xor i64 %785, -1
  %787 = and i64 %762, %786
  tail call fastcc void @write_outputs(ptr noundef nonnull %0, ptr noundef %744, i64 noundef %787) #10
  %788 = load ptr, ptr %104, align 8
  %789 = load <8 x double>, ptr %788, align 8
  %790 = fcmp olt <8 x double> %789, %210
  %791 = bitcast <8 x i1> %790 to i8
  %792 = zext i8 %791 to i64
  %793 = and i64 %786, %792
  %794 = and i64 %793, %762
  %795 = icmp eq i64 %794, 0
  br i1 %795, label %757, label %760, !llvm.loop !19

796:                                              ; preds = %757, %796
  %797 = phi i64 [ %810, %796 ], [ %758, %757 ]
  %798 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %797, i1 true)
  %799 = extractelement <8 x double> %741, i64 %798
  %800 = load ptr, ptr %115, align 8
  %801 = getelementptr inbounds double, ptr %800, i64 %798
  store double %799, ptr %801, align 8
  %802 = extractelement <8 x double> %743, i64 %798
  %803 = load ptr, ptr %104, align 8
  %804 = getelementptr inbounds double, ptr %803, i64 %798
  store double %802, ptr %804, align 8
  %805 = getelementptr inbounds [8 x i64], ptr %2, i64 0, i64 %798
  %806 = load i64, ptr %805, align 8
  %807 = load ptr, ptr %119, align 8
  %808 = getelementptr inbounds i64, ptr %807, i64 %798
  store i64 %806, ptr %808, align 8
  %809 = add nsw i64 %797, -1
  %810 = and i64 %809, %797
  %811 = icmp eq i64 %810, 0
  br i1 %811, label %812, label %796, !llvm.loop !20

812:                                              ; preds = %796, %757
  %813 = or i64 %758, %524
  %814 = trunc nuw i64 %758 to i8
  %815 = bitcast i8 %814 to <8 x i1>
  %816 = select <8 x i1> %815, <8 x i64> zeroinitializer, <8 x i64> %732
  br label %817

817:                                              ; preds = %812, %549
  %818 = phi i64 [ %524, %549 ], [ %813, %812 ]
  %819 = phi <8 x i64> [ %550, %549 ], [ %816, %812 ]
  %820 = phi i32 [ %174, %549 ], [ %733, %812 ]
  %821 = load ptr, ptr %104, align 8
  %822 = load <8 x double>, ptr %821, align 8
  %823 = fcmp oeq <8 x double> %822, %210
  %824 = icmp ne <8 x i64> %819, zeroinitializer
  %825 = select <8 x i1> %823, <8 x i1> %824, <8 x i1> zeroinitializer
  %826 = bitcast <8 x i1> %825 to i8
  %827 = icmp eq i8 %826, 0
  br i1 %827, label %830, label %828

828:                                              ; preds = %817
  %829 = zext i8 %826 to i64
  br label %839

830:                                              ; preds = %839, %817
  %831 = xor <8 x i64> %819, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %832 = select <8 x i1> %183, <8 x i64> %831, <8 x i64> zeroinitializer
  %833 = load ptr, ptr %59, align 8
  %834 = load <8 x double>, ptr %833, align 8
  %835 = icmp slt <8 x i64> %819, zeroinitializer
  %836 = select <8 x i1> %835, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %837 = bitcast <8 x i64> %836 to <8 x double>
  %838 = fadd <8 x double> %834, %837
  store <8 x double> %838, ptr %833, align 8
  br i1 %48, label %849, label %973

839:                                              ; preds = %828, %839
  %840 = phi i64 [ %847, %839 ], [ %829, %828 ]
  %841 = load ptr, ptr %120, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %841, i64 noundef %840) #10
  %842 = load ptr, ptr %104, align 8
  %843 = load <8 x double>, ptr %842, align 8
  %844 = fcmp oeq <8 x double> %843, %210
  %845 = bitcast <8 x i1> %844 to i8
  %846 = zext i8 %845 to i64
  %847 = and i64 %840, %846
  %848 = icmp eq i64 %847, 0
  br i1 %848, label %830, label %839, !llvm.loop !21

849:                                              ; preds = %830
  %850 = load ptr, ptr %121, align 8
  %851 = load <8 x double>, ptr %850, align 8
  %852 = load ptr, ptr %122, align 8
  %853 = load <8 x double>, ptr %852, align 8
  %854 = fcmp ogt <8 x double> %503, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %855 = bitcast <8 x double> %503 to <8 x i64>
  %856 = select <8 x i1> %854, <8 x i64> %855, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %857 = load double, ptr %123, align 8
  %858 = insertelement <8 x double> poison, double %857, i64 0
  %859 = shufflevector <8 x double> %858, <8 x double> poison, <8 x i32> zeroinitializer
  %860 = load double, ptr %124, align 8
  %861 = fneg double %860
  %862 = add <8 x i64> %856, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %863 = ashr <8 x i64> %862, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %864 = and <8 x i64> %862, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %865 = sub <8 x i64> %856, %864
  %866 = bitcast <8 x i64> %865 to <8 x double>
  %867 = fadd <8 x double> %866, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %868 = fadd <8 x double> %866, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %869 = fdiv <8 x double> %867, %868
  %870 = fmul <8 x double> %869, %869
  %871 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %870, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %872 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %871, <8 x double> %870, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %873 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %872, <8 x double> %870, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %874 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %873, <8 x double> %870, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %875 = trunc nsw <8 x i64> %863 to <8 x i32>
  %876 = sitofp <8 x i32> %875 to <8 x double>
  %877 = fmul <8 x double> %869, %874
  %878 = fadd <8 x double> %877, %876
  %879 = insertelement <8 x double> poison, double %861, i64 0
  %880 = shufflevector <8 x double> %879, <8 x double> poison, <8 x i32> zeroinitializer
  %881 = fmul <8 x double> %878, %880
  %882 = fcmp ogt <8 x double> %881, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %883 = bitcast <8 x double> %881 to <8 x i64>
  %884 = select <8 x i1> %882, <8 x i64> %883, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %885 = bitcast <8 x i64> %884 to <8 x double>
  %886 = fcmp olt <8 x double> %885, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %887 = bitcast <8 x i64> %884 to <8 x double>
  %888 = select <8 x i1> %886, <8 x double> %887, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %889 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %888)
  %890 = fsub <8 x double> %888, %889
  %891 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %890, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %892 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %891, <8 x double> %890, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %893 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %892, <8 x double> %890, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %894 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %893, <8 x double> %890, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %895 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %894, <8 x double> %890, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %896 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %895, <8 x double> %890, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %897 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %896, <8 x double> %890, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %898 = bitcast <8 x double> %897 to <8 x i64>
  %899 = fptosi <8 x double> %889 to <8 x i32>
  %900 = zext <8 x i32> %899 to <8 x i64>
  %901 = shl <8 x i64> %900, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %902 = add <8 x i64> %901, %898
  %903 = bitcast <8 x i64> %902 to <8 x double>
  %904 = fmul <8 x double> %859, %903
  %905 = load double, ptr %125, align 8
  %906 = fcmp une double %905, 0.000000e+00
  br i1 %906, label %907, label %952

907:                                              ; preds = %849
  %908 = bitcast <8 x double> %851 to <8 x i64>
  %909 = add <8 x i64> %908, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %910 = ashr <8 x i64> %909, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %911 = and <8 x i64> %909, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %912 = sub <8 x i64> %908, %911
  %913 = bitcast <8 x i64> %912 to <8 x double>
  %914 = fadd <8 x double> %913, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %915 = fadd <8 x double> %913, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %916 = fdiv <8 x double> %914, %915
  %917 = fmul <8 x double> %916, %916
  %918 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %917, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %919 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %918, <8 x double> %917, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %920 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %919, <8 x double> %917, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %921 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %920, <8 x double> %917, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %922 = trunc nsw <8 x i64> %910 to <8 x i32>
  %923 = sitofp <8 x i32> %922 to <8 x double>
  %924 = fmul <8 x double> %916, %921
  %925 = fadd <8 x double> %924, %923
  %926 = insertelement <8 x double> poison, double %905, i64 0
  %927 = shufflevector <8 x double> %926, <8 x double> poison, <8 x i32> zeroinitializer
  %928 = fmul <8 x double> %927, %925
  %929 = fcmp ogt <8 x double> %928, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %930 = bitcast <8 x double> %928 to <8 x i64>
  %931 = select <8 x i1> %929, <8 x i64> %930, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %932 = bitcast <8 x i64> %931 to <8 x double>
  %933 = fcmp olt <8 x double> %932, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %934 = bitcast <8 x i64> %931 to <8 x double>
  %935 = select <8 x i1> %933, <8 x double> %934, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %936 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %935)
  %937 = fsub <8 x double> %935, %936
  %938 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %937, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %939 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %938, <8 x double> %937, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %940 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %939, <8 x double> %937, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %941 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %940, <8 x double> %937, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %942 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %941, <8 x double> %937, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %943 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %942, <8 x double> %937, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %944 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %943, <8 x double> %937, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %945 = bitcast <8 x double> %944 to <8 x i64>
  %946 = fptosi <8 x double> %936 to <8 x i32>
  %947 = zext <8 x i32> %946 to <8 x i64>
  %948 = shl <8 x i64> %947, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %949 = add <8 x i64> %948, %945
  %950 = bitcast <8 x i64> %949 to <8 x double>
  %951 = fmul <8 x double> %904, %950
  br label %952

952:                                              ; preds = %849, %907
  %953 = phi <8 x double> [ %951, %907 ], [ %904, %849 ]
  %954 = load double, ptr %126, align 8
  %955 = insertelement <8 x double> poison, double %954, i64 0
  %956 = shufflevector <8 x double> %955, <8 x double> poison, <8 x i32> zeroinitializer
  %957 = fcmp ogt <8 x double> %953, %956
  %958 = select <8 x i1> %957, <8 x double> %953, <8 x double> %956
  %959 = fcmp olt <8 x double> %853, %958
  %960 = select <8 x i1> %959, <8 x double> %853, <8 x double> %958
  %961 = fmul <8 x double> %211, %960
  %962 = fcmp ogt <8 x double> %503, <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>
  %963 = select <8 x i1> %962, <8 x i64> %855, <8 x i64> <i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789>
  %964 = bitcast <8 x double> %851 to <8 x i64>
  %965 = select <8 x i1> %835, <8 x i64> %963, <8 x i64> %964
  store <8 x i64> %965, ptr %850, align 8
  %966 = load ptr, ptr %122, align 8
  %967 = load double, ptr %127, align 8
  %968 = insertelement <8 x double> poison, double %967, i64 0
  %969 = bitcast <8 x double> %968 to <8 x i64>
  %970 = shufflevector <8 x i64> %969, <8 x i64> poison, <8 x i32> zeroinitializer
  %971 = icmp slt <8 x i64> %832, zeroinitializer
  %972 = select <8 x i1> %971, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> %970
  store <8 x i64> %972, ptr %966, align 8
  br label %973

973:                                              ; preds = %952, %830
  %974 = phi <8 x double> [ %961, %952 ], [ %192, %830 ]
  %975 = icmp ne <8 x i64> %832, zeroinitializer
  %976 = bitcast <8 x i1> %975 to i8
  %977 = icmp eq i8 %976, 0
  br i1 %977, label %1064, label %978

978:                                              ; preds = %973
  %979 = trunc i64 %551 to i8
  %980 = bitcast i8 %979 to <8 x i1>
  %981 = trunc nuw i64 %818 to i8
  %982 = bitcast i8 %981 to <8 x i1>
  %983 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %503)
  %984 = fcmp ueq <8 x double> %983, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %985 = select <8 x i1> %984, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %980
  %986 = or <8 x i1> %985, %982
  br i1 %48, label %987, label %1046

987:                                              ; preds = %978
  %988 = fcmp ogt <8 x double> %503, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %989 = bitcast <8 x double> %503 to <8 x i64>
  %990 = select <8 x i1> %988, <8 x i64> %989, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %991 = load double, ptr %128, align 8
  %992 = insertelement <8 x double> poison, double %991, i64 0
  %993 = shufflevector <8 x double> %992, <8 x double> poison, <8 x i32> zeroinitializer
  %994 = load double, ptr %29, align 8
  %995 = fneg double %994
  %996 = add <8 x i64> %990, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %997 = ashr <8 x i64> %996, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %998 = and <8 x i64> %996, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %999 = sub <8 x i64> %990, %998
  %1000 = bitcast <8 x i64> %999 to <8 x double>
  %1001 = fadd <8 x double> %1000, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %1002 = fadd <8 x double> %1000, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1003 = fdiv <8 x double> %1001, %1002
  %1004 = fmul <8 x double> %1003, %1003
  %1005 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1004, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %1006 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1005, <8 x double> %1004, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %1007 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1006, <8 x double> %1004, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %1008 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1007, <8 x double> %1004, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %1009 = trunc nsw <8 x i64> %997 to <8 x i32>
  %1010 = sitofp <8 x i32> %1009 to <8 x double>
  %1011 = fmul <8 x double> %1003, %1008
  %1012 = fadd <8 x double> %1011, %1010
  %1013 = insertelement <8 x double> poison, double %995, i64 0
  %1014 = shufflevector <8 x double> %1013, <8 x double> poison, <8 x i32> zeroinitializer
  %1015 = fmul <8 x double> %1012, %1014
  %1016 = fcmp ogt <8 x double> %1015, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1017 = bitcast <8 x double> %1015 to <8 x i64>
  %1018 = select <8 x i1> %1016, <8 x i64> %1017, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1019 = bitcast <8 x i64> %1018 to <8 x double>
  %1020 = fcmp olt <8 x double> %1019, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1021 = bitcast <8 x i64> %1018 to <8 x double>
  %1022 = select <8 x i1> %1020, <8 x double> %1021, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1023 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %1022)
  %1024 = fsub <8 x double> %1022, %1023
  %1025 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1024, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1026 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1025, <8 x double> %1024, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1027 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1026, <8 x double> %1024, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1028 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1027, <8 x double> %1024, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1029 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1028, <8 x double> %1024, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1030 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1029, <8 x double> %1024, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1031 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1030, <8 x double> %1024, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1032 = bitcast <8 x double> %1031 to <8 x i64>
  %1033 = fptosi <8 x double> %1023 to <8 x i32>
  %1034 = zext <8 x i32> %1033 to <8 x i64>
  %1035 = shl <8 x i64> %1034, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1036 = add <8 x i64> %1035, %1032
  %1037 = bitcast <8 x i64> %1036 to <8 x double>
  %1038 = fmul <8 x double> %993, %1037
  %1039 = load double, ptr %129, align 8
  %1040 = insertelement <8 x double> poison, double %1039, i64 0
  %1041 = shufflevector <8 x double> %1040, <8 x double> poison, <8 x i32> zeroinitializer
  %1042 = fcmp ogt <8 x double> %1038, %1041
  %1043 = select <8 x i1> %1042, <8 x double> %1038, <8 x double> %1041
  %1044 = select <8 x i1> %986, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>, <8 x double> %1043
  %1045 = fmul <8 x double> %211, %1044
  br label %1046

1046:                                             ; preds = %978, %987
  %1047 = phi <8 x double> [ %1045, %987 ], [ zeroinitializer, %978 ]
  %1048 = select <8 x i1> %986, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>
  %1049 = icmp slt <8 x i64> %832, zeroinitializer
  %1050 = select <8 x i1> %1049, <8 x double> %1047, <8 x double> %974
  %1051 = load ptr, ptr %130, align 8
  %1052 = select <8 x i1> %982, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> %1048
  %1053 = load <8 x i64>, ptr %1051, align 8
  %1054 = select <8 x i1> %1049, <8 x i64> %1052, <8 x i64> %1053
  store <8 x i64> %1054, ptr %1051, align 8
  %1055 = load ptr, ptr %130, align 8
  %1056 = select <8 x i1> %980, <8 x i64> <i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152>, <8 x i64> %1048
  %1057 = load <8 x i64>, ptr %1055, align 8
  %1058 = select <8 x i1> %1049, <8 x i64> %1056, <8 x i64> %1057
  store <8 x i64> %1058, ptr %1055, align 8
  %1059 = load ptr, ptr %60, align 8
  %1060 = load <8 x double>, ptr %1059, align 8
  %1061 = select <8 x i1> %1049, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %1062 = bitcast <8 x i64> %1061 to <8 x double>
  %1063 = fadd <8 x double> %1060, %1062
  store <8 x double> %1063, ptr %1059, align 8
  br label %1064

1064:                                             ; preds = %1046, %973
  %1065 = phi <8 x double> [ %974, %973 ], [ %1050, %1046 ]
  %1066 = load ptr, ptr %56, align 8
  store <8 x double> %1065, ptr %1066, align 8
  %1067 = load ptr, ptr %46, align 8
  %1068 = select <8 x i1> %835, <8 x double> %210, <8 x double> %185
  store <8 x double> %1068, ptr %1067, align 8
  br i1 %131, label %1077, label %1069

1069:                                             ; preds = %1077, %1064
  %1070 = load ptr, ptr %104, align 8
  %1071 = load <8 x double>, ptr %1070, align 8
  %1072 = fcmp oeq <8 x double> %1071, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1073 = icmp ne <8 x i64> %819, zeroinitializer
  %1074 = select <8 x i1> %1072, <8 x i1> %1073, <8 x i1> zeroinitializer
  %1075 = bitcast <8 x i1> %1074 to i8
  %1076 = icmp eq i8 %1075, 0
  br i1 %1076, label %171, label %1095

1077:                                             ; preds = %1064, %1077
  %1078 = phi i64 [ %1093, %1077 ], [ 0, %1064 ]
  %1079 = load ptr, ptr %9, align 8
  %1080 = load ptr, ptr %132, align 8
  %1081 = shl nsw i64 %1078, 6
  %1082 = getelementptr inbounds i8, ptr %1080, i64 %1081
  %1083 = load <8 x i64>, ptr %1082, align 8
  %1084 = getelementptr inbounds i8, ptr %1079, i64 %1081
  %1085 = load <8 x i64>, ptr %1084, align 8
  %1086 = select <8 x i1> %835, <8 x i64> %1083, <8 x i64> %1085
  store <8 x i64> %1086, ptr %1084, align 8
  %1087 = load ptr, ptr %37, align 8
  %1088 = getelementptr inbounds i8, ptr %51, i64 %1081
  %1089 = load <8 x i64>, ptr %1088, align 8
  %1090 = getelementptr inbounds i8, ptr %1087, i64 %1081
  %1091 = load <8 x i64>, ptr %1090, align 8
  %1092 = select <8 x i1> %835, <8 x i64> %1089, <8 x i64> %1091
  store <8 x i64> %1092, ptr %1090, align 8
  %1093 = add nuw nsw i64 %1078, 1
  %1094 = icmp eq i64 %1093, %13
  br i1 %1094, label %1069, label %1077, !llvm.loop !22

1095:                                             ; preds = %1069
  %1096 = zext i8 %1075 to i64
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %1096, i64 noundef 0) #10
  br label %171

1097:                                             ; preds = %173, %168
  %1098 = phi i64 [ 1, %168 ], [ 0, %173 ]
  ret i64 %1098
}



define internal fastcc i64 @fill(ptr noundef readonly %0, ptr noundef writeonly %1) unnamed_addr #2 {
  %3 = getelementptr inbounds i8, ptr %0, i64 624
  %4 = getelementptr inbounds i8, ptr %0, i64 912
  %5 = getelementptr inbounds i8, ptr %0, i64 360
  %6 = load ptr, ptr %4, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 1056
  %8 = getelementptr inbounds i8, ptr %0, i64 992
  %9 = getelementptr inbounds i8, ptr %0, i64 984
  %10 = getelementptr inbounds i8, ptr %0, i64 864
  %11 = getelementptr inbounds i8, ptr %0, i64 1072
  %12 = getelementptr inbounds i8, ptr %0, i64 1000
  %13 = getelementptr inbounds i8, ptr %0, i64 1008
  %14 = getelementptr inbounds i8, ptr %0, i64 192
  %15 = getelementptr inbounds i8, ptr %0, i64 1024
  %16 = getelementptr inbounds i8, ptr %0, i64 1032
  %17 = getelementptr inbounds i8, ptr %0, i64 216
  %18 = getelementptr inbounds i8, ptr %0, i64 1048
  %19 = getelementptr inbounds i8, ptr %0, i64 1136
  %20 = getelementptr inbounds i8, ptr %0, i64 1104
  %21 = getelementptr inbounds i8, ptr %0, i64 1128
  %22 = getelementptr inbounds i8, ptr %0, i64 1024
  %23 = getelementptr inbounds i8, ptr %0, i64 1048
  %24 = getelementptr inbounds i8, ptr %0, i64 1192
  %25 = getelementptr inbounds i8, ptr %0, i64 1176
  %26 = getelementptr inbounds i8, ptr %0, i64 960
  br label %27

27:                                               ; preds = %2, %194
  %28 = phi i64 [ 0, %2 ], [ %204, %194 ]
  %29 = phi i64 [ 0, %2 ], [ %195, %194 ]
  %30 = phi i64 [ -1, %2 ], [ %203, %194 ]
  %31 = phi i64 [ 0, %2 ], [ %202, %194 ]
  %32 = load i64, ptr %6, align 8
  %33 = load i64, ptr %8, align 8
  %34 = icmp sge i64 %32, %33
  br i1 %34, label %66, label %35

35:                                               ; preds = %27
  %36 = load ptr, ptr %7, align 8
  %37 = load i64, ptr %11, align 8
  %38 = mul nsw i64 %37, %32
  %39 = getelementptr i64, ptr %36, i64 %38
  %40 = getelementptr i8, ptr %39, i64 24
  %41 = load i64, ptr %40, align 8
  %42 = icmp eq i64 %41, 0
  br i1 %42, label %66, label %61

43:                                               ; preds = %194
  %44 = getelementptr inbounds i8, ptr %0, i64 144
  store i64 %202, ptr %1, align 8
  %45 = icmp slt i64 %203, 0
  br i1 %45, label %295, label %46

46:                                               ; preds = %43
  %47 = getelementptr inbounds i8, ptr %0, i64 864
  %48 = getelementptr inbounds i8, ptr %0, i64 528
  %49 = getelementptr inbounds i8, ptr %0, i64 192
  %50 = getelementptr inbounds i8, ptr %0, i64 216
  %51 = getelementptr inbounds i8, ptr %0, i64 648
  %52 = getelementptr inbounds i8, ptr %0, i64 744
  br label %215

53:                                               ; preds = %61
  %54 = load ptr, ptr %7, align 8
  %55 = load i64, ptr %11, align 8
  %56 = mul nsw i64 %55, %63
  %57 = getelementptr i64, ptr %54, i64 %56
  %58 = getelementptr i8, ptr %57, i64 24
  %59 = load i64, ptr %58, align 8
  %60 = icmp eq i64 %59, 0
  br i1 %60, label %66, label %61, !llvm.loop !23

61:                                               ; preds = %35, %53
  %62 = phi i64 [ %63, %53 ], [ %32, %35 ]
  %63 = add nsw i64 %62, 1
  store i64 %63, ptr %6, align 8
  %64 = load i64, ptr %8, align 8
  %65 = icmp sge i64 %63, %64
  br i1 %65, label %66, label %53, !llvm.loop !23

66:                                               ; preds = %61, %53, %35, %27
  %67 = phi i64 [ %32, %27 ], [ %32, %35 ], [ %63, %53 ], [ %63, %61 ]
  %68 = phi i1 [ %34, %27 ], [ %34, %35 ], [ %65, %53 ], [ %65, %61 ]
  %69 = load ptr, ptr %10, align 8
  %70 = getelementptr inbounds i64, ptr %69, i64 %28
  %71 = load i64, ptr %70, align 8
  %72 = icmp ne i64 %71, -1
  %73 = or i1 %68, %72
  br i1 %73, label %194, label %74

74:                                               ; preds = %66
  %75 = add nsw i64 %67, 1
  store i64 %75, ptr %6, align 8
  %76 = load ptr, ptr %10, align 8
  %77 = getelementptr inbounds i64, ptr %76, i64 %28
  store i64 %67, ptr %77, align 8
  %78 = load ptr, ptr %5, align 8
  %79 = load ptr, ptr %9, align 8
  %80 = load i64, ptr %12, align 8
  %81 = mul nsw i64 %80, %67
  %82 = getelementptr inbounds double, ptr %79, i64 %81
  %83 = getelementptr double, ptr %78, i64 %28
  %84 = icmp sgt i64 %80, 0
  br i1 %84, label %85, label %94

85:                                               ; preds = %74, %85
  %86 = phi i64 [ %91, %85 ], [ 0, %74 ]
  %87 = getelementptr inbounds double, ptr %82, i64 %86
  %88 = load double, ptr %87, align 8
  %89 = shl i64 %86, 6
  %90 = getelementptr i8, ptr %83, i64 %89
  store double %88, ptr %90, align 8
  %91 = add nuw nsw i64 %86, 1
  %92 = load i64, ptr %12, align 8
  %93 = icmp slt i64 %91, %92
  br i1 %93, label %85, label %94, !llvm.loop !24

94:                                               ; preds = %85, %74
  %95 = load ptr, ptr %14, align 8
  %96 = load ptr, ptr %13, align 8
  %97 = load i64, ptr %15, align 8
  %98 = mul nsw i64 %97, %67
  %99 = getelementptr inbounds double, ptr %96, i64 %98
  %100 = getelementptr double, ptr %95, i64 %28
  %101 = icmp sgt i64 %97, 0
  br i1 %101, label %102, label %111

102:                                              ; preds = %94, %102
  %103 = phi i64 [ %108, %102 ], [ 0, %94 ]
  %104 = getelementptr inbounds double, ptr %99, i64 %103
  %105 = load double, ptr %104, align 8
  %106 = shl i64 %103, 6
  %107 = getelementptr i8, ptr %100, i64 %106
  store double %105, ptr %107, align 8
  %108 = add nuw nsw i64 %103, 1
  %109 = load i64, ptr %15, align 8
  %110 = icmp slt i64 %108, %109
  br i1 %110, label %102, label %111, !llvm.loop !24

111:                                              ; preds = %102, %94
  %112 = load ptr, ptr %17, align 8
  %113 = load ptr, ptr %16, align 8
  %114 = load i64, ptr %18, align 8
  %115 = mul nsw i64 %114, %67
  %116 = getelementptr inbounds double, ptr %113, i64 %115
  %117 = getelementptr double, ptr %112, i64 %28
  %118 = icmp sgt i64 %114, 0
  br i1 %118, label %119, label %128

119:                                              ; preds = %111, %119
  %120 = phi i64 [ %125, %119 ], [ 0, %111 ]
  %121 = getelementptr inbounds double, ptr %116, i64 %120
  %122 = load double, ptr %121, align 8
  %123 = shl i64 %120, 6
  %124 = getelementptr i8, ptr %117, i64 %123
  store double %122, ptr %124, align 8
  %125 = add nuw nsw i64 %120, 1
  %126 = load i64, ptr %18, align 8
  %127 = icmp slt i64 %125, %126
  br i1 %127, label %119, label %128, !llvm.loop !24

128:                                              ; preds = %119, %111
  %129 = load i64, ptr %19, align 8
  %130 = icmp sgt i64 %129, 0
  br i1 %130, label %131, label %187

131:                                              ; preds = %128
  %132 = load ptr, ptr %21, align 8
  %133 = getelementptr inbounds i64, ptr %132, i64 %28
  %134 = load i64, ptr %133, align 8
  %135 = inttoptr i64 %134 to ptr
  %136 = load i64, ptr %22, align 8
  %137 = icmp sgt i64 %136, 0
  br i1 %137, label %138, label %140

138:                                              ; preds = %131
  %139 = getelementptr inbounds i8, ptr %135, i64 192
  br label %152

140:                                              ; preds = %152, %131
  %141 = load ptr, ptr %20, align 8
  %142 = load i64, ptr %141, align 8
  %143 = inttoptr i64 %142 to ptr
  %144 = load ptr, ptr %16, align 8
  %145 = load i64, ptr %23, align 8
  %146 = mul nsw i64 %145, %67
  %147 = getelementptr inbounds double, ptr %144, i64 %146
  %148 = getelementptr inbounds i8, ptr %135, i64 672
  %149 = load ptr, ptr %148, align 8
  tail call void %143(ptr noundef %147, ptr noundef %149) #11
  %150 = load i64, ptr %24, align 8
  %151 = icmp sgt i64 %150, 0
  br i1 %151, label %165, label %187

152:                                              ; preds = %138, %152
  %153 = phi i64 [ %136, %138 ], [ %163, %152 ]
  %154 = phi i64 [ 0, %138 ], [ %162, %152 ]
  %155 = load ptr, ptr %13, align 8
  %156 = mul nsw i64 %153, %67
  %157 = getelementptr double, ptr %155, i64 %156
  %158 = getelementptr double, ptr %157, i64 %154
  %159 = load double, ptr %158, align 8
  %160 = load ptr, ptr %139, align 8
  %161 = getelementptr inbounds double, ptr %160, i64 %154
  store double %159, ptr %161, align 8
  %162 = add nuw nsw i64 %154, 1
  %163 = load i64, ptr %22, align 8
  %164 = icmp slt i64 %162, %163
  br i1 %164, label %152, label %140, !llvm.loop !25

165:                                              ; preds = %140, %165
  %166 = phi i64 [ %185, %165 ], [ %150, %140 ]
  %167 = phi i64 [ %184, %165 ], [ 0, %140 ]
  %168 = load ptr, ptr %25, align 8
  %169 = mul nsw i64 %166, %67
  %170 = getelementptr double, ptr %168, i64 %169
  %171 = getelementptr double, ptr %170, i64 %167
  %172 = load double, ptr %171, align 8
  %173 = load ptr, ptr %21, align 8
  %174 = getelementptr inbounds i64, ptr %173, i64 %28
  %175 = load i64, ptr %174, align 8
  %176 = inttoptr i64 %175 to ptr
  %177 = getelementptr inbounds i8, ptr %176, i64 696
  %178 = load ptr, ptr %177, align 8
  %179 = load ptr, ptr %20, align 8
  %180 = getelementptr inbounds i8, ptr %179, i64 8
  %181 = load i64, ptr %180, align 8
  %182 = getelementptr inbounds double, ptr %178, i64 %181
  %183 = getelementptr inbounds double, ptr %182, i64 %167
  store double %172, ptr %183, align 8
  %184 = add nuw nsw i64 %167, 1
  %185 = load i64, ptr %24, align 8
  %186 = icmp slt i64 %184, %185
  br i1 %186, label %165, label %187, !llvm.loop !26

187:                                              ; preds = %165, %140, %128
  %188 = load ptr, ptr %26, align 8
  %189 = load double, ptr %188, align 8
  %190 = load ptr, ptr %3, align 8
  %191 = getelementptr inbounds double, ptr %190, i64 %28
  store double %189, ptr %191, align 8
  %192 = shl nuw nsw i64 1, %28
  %193 = or i64 %192, %29
  br label %194

194:                                              ; preds = %66, %187
  %195 = phi i64 [ %193, %187 ], [ %29, %66 ]
  %196 = load ptr, ptr %10, align 8
  %197 = getelementptr inbounds i64, ptr %196, i64 %28
  %198 = load i64, ptr %197, align 8
  %199 = icmp sgt i64 %198, -1
  %200 = shl nuw nsw i64 1, %28
  %201 = select i1 %199, i64 %200, i64 0
  %202 = or i64 %201, %31
  %203 = select i1 %199, i64 %28, i64 %30
  %204 = add nuw nsw i64 %28, 1
  %205 = icmp eq i64 %204, 8
  br i1 %205, label %43, label %27, !llvm.loop !27

206:                                              ; preds = %292
  %207 = load ptr, ptr %44, align 8
  %208 = getelementptr inbounds i8, ptr %207, i64 40
  %209 = load i64, ptr %208, align 8
  %210 = inttoptr i64 %209 to ptr
  %211 = getelementptr inbounds i8, ptr %0, i64 216
  %212 = load ptr, ptr %211, align 8
  %213 = getelementptr inbounds i8, ptr %0, i64 240
  %214 = load ptr, ptr %213, align 8
  tail call void %210(ptr noundef %212, ptr noundef %214) #11
  br label %295

215:                                              ; preds = %46, %292
  %216 = phi i64 [ 0, %46 ], [ %293, %292 ]
  %217 = load ptr, ptr %47, align 8
  %218 = getelementptr inbounds i64, ptr %217, i64 %216
  %219 = load i64, ptr %218, align 8
  %220 = icmp eq i64 %219, -1
  br i1 %220, label %221, label %292

221:                                              ; preds = %215
  %222 = load ptr, ptr %5, align 8
  %223 = load ptr, ptr %44, align 8
  %224 = getelementptr inbounds i8, ptr %223, i64 8
  %225 = load i64, ptr %224, align 8
  %226 = icmp sgt i64 %225, 0
  br i1 %226, label %227, label %236

227:                                              ; preds = %221, %227
  %228 = phi i64 [ %234, %227 ], [ 0, %221 ]
  %229 = shl i64 %228, 6
  %230 = getelementptr i8, ptr %222, i64 %229
  %231 = getelementptr double, ptr %230, i64 %203
  %232 = load double, ptr %231, align 8
  %233 = getelementptr double, ptr %230, i64 %216
  store double %232, ptr %233, align 8
  %234 = add nuw nsw i64 %228, 1
  %235 = icmp eq i64 %234, %225
  br i1 %235, label %236, label %227, !llvm.loop !28

236:                                              ; preds = %227, %221
  %237 = load ptr, ptr %48, align 8
  %238 = load ptr, ptr %44, align 8
  %239 = getelementptr inbounds i8, ptr %238, i64 8
  %240 = load i64, ptr %239, align 8
  %241 = icmp sgt i64 %240, 0
  br i1 %241, label %242, label %251

242:                                              ; preds = %236, %242
  %243 = phi i64 [ %249, %242 ], [ 0, %236 ]
  %244 = shl i64 %243, 6
  %245 = getelementptr i8, ptr %237, i64 %244
  %246 = getelementptr double, ptr %245, i64 %203
  %247 = load double, ptr %246, align 8
  %248 = getelementptr double, ptr %245, i64 %216
  store double %247, ptr %248, align 8
  %249 = add nuw nsw i64 %243, 1
  %250 = icmp eq i64 %249, %240
  br i1 %250, label %251, label %242, !llvm.loop !28

251:                                              ; preds = %242, %236
  %252 = load ptr, ptr %49, align 8
  %253 = load ptr, ptr %44, align 8
  %254 = getelementptr inbounds i8, ptr %253, i64 48
  %255 = load i64, ptr %254, align 8
  %256 = icmp sgt i64 %255, 0
  br i1 %256, label %257, label %266

257:                                              ; preds = %251, %257
  %258 = phi i64 [ %264, %257 ], [ 0, %251 ]
  %259 = shl i64 %258, 6
  %260 = getelementptr i8, ptr %252, i64 %259
  %261 = getelementptr double, ptr %260, i64 %203
  %262 = load double, ptr %261, align 8
  %263 = getelementptr double, ptr %260, i64 %216
  store double %262, ptr %263, align 8
  %264 = add nuw nsw i64 %258, 1
  %265 = icmp eq i64 %264, %255
  br i1 %265, label %266, label %257, !llvm.loop !28

266:                                              ; preds = %257, %251
  %267 = load ptr, ptr %50, align 8
  %268 = load ptr, ptr %44, align 8
  %269 = getelementptr inbounds i8, ptr %268, i64 56
  %270 = load i64, ptr %269, align 8
  %271 = icmp sgt i64 %270, 0
  br i1 %271, label %272, label %281

272:                                              ; preds = %266, %272
  %273 = phi i64 [ %279, %272 ], [ 0, %266 ]
  %274 = shl i64 %273, 6
  %275 = getelementptr i8, ptr %267, i64 %274
  %276 = getelementptr double, ptr %275, i64 %203
  %277 = load double, ptr %276, align 8
  %278 = getelementptr double, ptr %275, i64 %216
  store double %277, ptr %278, align 8
  %279 = add nuw nsw i64 %273, 1
  %280 = icmp eq i64 %279, %270
  br i1 %280, label %281, label %272, !llvm.loop !28

281:                                              ; preds = %272, %266
  %282 = load ptr, ptr %3, align 8
  %283 = getelementptr inbounds double, ptr %282, i64 %203
  %284 = load double, ptr %283, align 8
  %285 = getelementptr inbounds double, ptr %282, i64 %216
  store double %284, ptr %285, align 8
  %286 = load ptr, ptr %51, align 8
  %287 = getelementptr inbounds double, ptr %286, i64 %216
  store double 0.000000e+00, ptr %287, align 8
  %288 = load ptr, ptr %52, align 8
  %289 = getelementptr inbounds double, ptr %288, i64 %216
  store double 0x7FF0000000000000, ptr %289, align 8
  %290 = load ptr, ptr %47, align 8
  %291 = getelementptr inbounds i64, ptr %290, i64 %216
  store i64 -2, ptr %291, align 8
  br label %292

292:                                              ; preds = %215, %281
  %293 = add nuw nsw i64 %216, 1
  %294 = icmp eq i64 %293, 8
  br i1 %294, label %206, label %215, !llvm.loop !29

295:                                              ; preds = %43, %206
  ret i64 %195
}

define internal fastcc void @start(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2) unnamed_addr #3 {
  %4 = alloca [8 x double], align 16
  %5 = alloca [8 x double], align 16
  %6 = alloca [8 x double], align 16
  %7 = getelementptr inbounds i8, ptr %0, i64 624
  %8 = getelementptr inbounds i8, ptr %0, i64 912
  %9 = getelementptr inbounds i8, ptr %1, i64 16
  %10 = load ptr, ptr %9, align 8
  %11 = trunc i64 %2 to i8
  %12 = bitcast i8 %11 to <8 x i1>
  %13 = load ptr, ptr %7, align 8
  %14 = load <8 x double>, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %1, i64 8
  %16 = load ptr, ptr %15, align 8
  %17 = load ptr, ptr %10, align 8
  %18 = getelementptr inbounds i8, ptr %10, i64 48
  %19 = load ptr, ptr %18, align 8
  %20 = getelementptr inbounds i8, ptr %16, i64 24
  %21 = load ptr, ptr %20, align 8
  store <8 x double> %14, ptr %21, align 8
  %22 = getelementptr inbounds i8, ptr %16, i64 128
  %23 = load i64, ptr %22, align 8
  %24 = icmp sgt i64 %23, 0
  br i1 %24, label %25, label %26

25:                                               ; preds = %3
  tail call fastcc void @sample(ptr noundef %16) #10
  br label %26

26:                                               ; preds = %3, %25
  %27 = load ptr, ptr %16, align 8
  %28 = load i64, ptr %27, align 8
  %29 = load ptr, ptr %20, align 8
  %30 = getelementptr inbounds i8, ptr %16, i64 48
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds i8, ptr %16, i64 96
  %33 = load ptr, ptr %32, align 8
  %34 = inttoptr i64 %28 to ptr
  %35 = tail call i32 %34(ptr noundef %29, ptr noundef %17, ptr noundef %31, ptr noundef %33, ptr noundef %19) #11
  %36 = sext i32 %35 to i64
  %37 = and i64 %36, %2
  %38 = load ptr, ptr %15, align 8
  %39 = load ptr, ptr %38, align 8
  %40 = getelementptr inbounds i8, ptr %39, i64 8
  %41 = load i64, ptr %40, align 8
  %42 = icmp sgt i64 %41, 0
  br i1 %42, label %43, label %45

43:                                               ; preds = %26
  %44 = getelementptr inbounds i8, ptr %10, i64 168
  br label %52

45:                                               ; preds = %52, %26
  %46 = phi ptr [ %39, %26 ], [ %64, %52 ]
  %47 = getelementptr inbounds i8, ptr %0, i64 936
  %48 = load ptr, ptr %47, align 8
  %49 = getelementptr inbounds i8, ptr %48, i64 8
  %50 = load double, ptr %49, align 8
  %51 = fcmp oeq double %50, 0.000000e+00
  br i1 %51, label %68, label %235

52:                                               ; preds = %43, %52
  %53 = phi i64 [ 0, %43 ], [ %62, %52 ]
  %54 = load ptr, ptr %44, align 8
  %55 = load ptr, ptr %18, align 8
  %56 = shl nsw i64 %53, 6
  %57 = getelementptr inbounds i8, ptr %55, i64 %56
  %58 = load <8 x i64>, ptr %57, align 8
  %59 = getelementptr inbounds i8, ptr %54, i64 %56
  %60 = load <8 x i64>, ptr %59, align 8
  %61 = select <8 x i1> %12, <8 x i64> %58, <8 x i64> %60
  store <8 x i64> %61, ptr %59, align 8
  %62 = add nuw nsw i64 %53, 1
  %63 = load ptr, ptr %15, align 8
  %64 = load ptr, ptr %63, align 8
  %65 = getelementptr inbounds i8, ptr %64, i64 8
  %66 = load i64, ptr %65, align 8
  %67 = icmp slt i64 %62, %66
  br i1 %67, label %52, label %45, !llvm.loop !30

68:                                               ; preds = %45
  %69 = load double, ptr %48, align 8
  %70 = load ptr, ptr %9, align 8
  %71 = getelementptr inbounds i8, ptr %46, i64 24
  %72 = load i64, ptr %71, align 8
  %73 = load ptr, ptr %70, align 8
  call fastcc void @norm_to(ptr noundef nonnull %4, ptr noundef %73, ptr noundef %73, ptr noundef nonnull %70, i64 noundef %72) #10
  %74 = load <8 x double>, ptr %4, align 16
  %75 = getelementptr inbounds i8, ptr %70, i64 168
  %76 = load ptr, ptr %75, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %76, ptr noundef %73, ptr noundef nonnull %70, i64 noundef %72) #10
  %77 = load <8 x double>, ptr %5, align 16
  %78 = fcmp olt <8 x double> %74, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %79 = fcmp olt <8 x double> %77, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %80 = or <8 x i1> %79, %78
  %81 = insertelement <8 x double> poison, double %69, i64 0
  %82 = shufflevector <8 x double> %81, <8 x double> poison, <8 x i32> zeroinitializer
  %83 = fmul <8 x double> %74, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %84 = fdiv <8 x double> %83, %77
  %85 = bitcast <8 x double> %84 to <8 x i64>
  %86 = select <8 x i1> %80, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %85
  %87 = bitcast <8 x i64> %86 to <8 x double>
  %88 = fcmp olt <8 x double> %82, %87
  %89 = bitcast <8 x double> %82 to <8 x i64>
  %90 = select <8 x i1> %88, <8 x i64> %89, <8 x i64> %86
  %91 = bitcast <8 x i64> %90 to <8 x double>
  %92 = load ptr, ptr %15, align 8
  %93 = load ptr, ptr %92, align 8
  %94 = getelementptr inbounds i8, ptr %93, i64 8
  %95 = load i64, ptr %94, align 8
  %96 = icmp sgt i64 %95, 0
  br i1 %96, label %97, label %118

97:                                               ; preds = %68
  %98 = getelementptr inbounds i8, ptr %70, i64 48
  br label %99

99:                                               ; preds = %97, %99
  %100 = phi i64 [ 0, %97 ], [ %112, %99 ]
  %101 = load ptr, ptr %98, align 8
  %102 = load ptr, ptr %70, align 8
  %103 = shl nsw i64 %100, 6
  %104 = getelementptr inbounds i8, ptr %102, i64 %103
  %105 = load <8 x double>, ptr %104, align 8
  %106 = load ptr, ptr %75, align 8
  %107 = getelementptr inbounds i8, ptr %106, i64 %103
  %108 = load <8 x double>, ptr %107, align 8
  %109 = fmul <8 x double> %108, %91
  %110 = fadd <8 x double> %105, %109
  %111 = getelementptr inbounds i8, ptr %101, i64 %103
  store <8 x double> %110, ptr %111, align 8
  %112 = add nuw nsw i64 %100, 1
  %113 = load ptr, ptr %15, align 8
  %114 = load ptr, ptr %113, align 8
  %115 = getelementptr inbounds i8, ptr %114, i64 8
  %116 = load i64, ptr %115, align 8
  %117 = icmp slt i64 %112, %116
  br i1 %117, label %99, label %118, !llvm.loop !31

118:                                              ; preds = %99, %68
  %119 = phi ptr [ %92, %68 ], [ %113, %99 ]
  %120 = fadd <8 x double> %14, %91
  %121 = getelementptr inbounds i8, ptr %70, i64 48
  %122 = load ptr, ptr %121, align 8
  %123 = load ptr, ptr %75, align 8
  %124 = getelementptr inbounds i8, ptr %70, i64 8
  %125 = load i64, ptr %124, align 8
  %126 = getelementptr inbounds double, ptr %123, i64 %125
  %127 = getelementptr inbounds i8, ptr %119, i64 24
  %128 = load ptr, ptr %127, align 8
  store <8 x double> %120, ptr %128, align 8
  %129 = getelementptr inbounds i8, ptr %119, i64 128
  %130 = load i64, ptr %129, align 8
  %131 = icmp sgt i64 %130, 0
  br i1 %131, label %132, label %133

132:                                              ; preds = %118
  tail call fastcc void @sample(ptr noundef nonnull %119) #10
  br label %133

133:                                              ; preds = %118, %132
  %134 = load ptr, ptr %119, align 8
  %135 = load i64, ptr %134, align 8
  %136 = load ptr, ptr %127, align 8
  %137 = getelementptr inbounds i8, ptr %119, i64 48
  %138 = load ptr, ptr %137, align 8
  %139 = getelementptr inbounds i8, ptr %119, i64 96
  %140 = load ptr, ptr %139, align 8
  %141 = inttoptr i64 %135 to ptr
  %142 = tail call i32 %141(ptr noundef %136, ptr noundef %122, ptr noundef %138, ptr noundef %140, ptr noundef %126) #11
  %143 = load ptr, ptr %1, align 8
  %144 = getelementptr inbounds i8, ptr %143, i64 120
  %145 = load ptr, ptr %144, align 8
  %146 = load double, ptr %145, align 8
  %147 = load ptr, ptr %75, align 8
  %148 = load i64, ptr %124, align 8
  %149 = getelementptr inbounds double, ptr %147, i64 %148
  %150 = icmp sgt i64 %72, 0
  br i1 %150, label %151, label %161

151:                                              ; preds = %133, %151
  %152 = phi i64 [ %159, %151 ], [ 0, %133 ]
  %153 = shl nsw i64 %152, 6
  %154 = getelementptr inbounds i8, ptr %149, i64 %153
  %155 = load <8 x double>, ptr %154, align 8
  %156 = getelementptr inbounds i8, ptr %147, i64 %153
  %157 = load <8 x double>, ptr %156, align 8
  %158 = fsub <8 x double> %155, %157
  store <8 x double> %158, ptr %154, align 8
  %159 = add nuw nsw i64 %152, 1
  %160 = icmp eq i64 %159, %72
  br i1 %160, label %161, label %151, !llvm.loop !32

161:                                              ; preds = %151, %133
  %162 = load ptr, ptr %70, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %149, ptr noundef %162, ptr noundef nonnull %70, i64 noundef %72) #10
  %163 = load <8 x double>, ptr %6, align 16
  %164 = fdiv <8 x double> %163, %91
  %165 = fcmp ogt <8 x double> %77, %164
  %166 = select <8 x i1> %165, <8 x double> %77, <8 x double> %164
  %167 = fcmp ogt <8 x double> %166, <double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15>
  %168 = fdiv <8 x double> <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>, %166
  %169 = select <8 x i1> %167, <8 x double> %168, <8 x double> <double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13>
  %170 = bitcast <8 x double> %169 to <8 x i64>
  %171 = add <8 x i64> %170, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %172 = ashr <8 x i64> %171, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %173 = and <8 x i64> %171, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %174 = sub <8 x i64> %170, %173
  %175 = bitcast <8 x i64> %174 to <8 x double>
  %176 = fadd <8 x double> %175, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %177 = fadd <8 x double> %175, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %178 = fdiv <8 x double> %176, %177
  %179 = fmul <8 x double> %178, %178
  %180 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %179, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %181 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %180, <8 x double> %179, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %182 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %181, <8 x double> %179, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %183 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %182, <8 x double> %179, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %184 = trunc nsw <8 x i64> %172 to <8 x i32>
  %185 = sitofp <8 x i32> %184 to <8 x double>
  %186 = fmul <8 x double> %178, %183
  %187 = fadd <8 x double> %186, %185
  %188 = insertelement <8 x double> poison, double %146, i64 0
  %189 = shufflevector <8 x double> %188, <8 x double> poison, <8 x i32> zeroinitializer
  %190 = fmul <8 x double> %189, %187
  %191 = fcmp ogt <8 x double> %190, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %192 = bitcast <8 x double> %190 to <8 x i64>
  %193 = select <8 x i1> %191, <8 x i64> %192, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %194 = bitcast <8 x i64> %193 to <8 x double>
  %195 = fcmp olt <8 x double> %194, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %196 = bitcast <8 x i64> %193 to <8 x double>
  %197 = select <8 x i1> %195, <8 x double> %196, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %198 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %197)
  %199 = fsub <8 x double> %197, %198
  %200 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %199, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %201 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %200, <8 x double> %199, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %202 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %201, <8 x double> %199, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %203 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %202, <8 x double> %199, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %204 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %203, <8 x double> %199, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %205 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %204, <8 x double> %199, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %206 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %205, <8 x double> %199, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %207 = bitcast <8 x double> %206 to <8 x i64>
  %208 = fptosi <8 x double> %198 to <8 x i32>
  %209 = zext <8 x i32> %208 to <8 x i64>
  %210 = shl <8 x i64> %209, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %211 = add <8 x i64> %210, %207
  %212 = fmul <8 x double> %91, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %213 = fcmp olt <8 x double> %212, <double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D>
  %214 = bitcast <8 x double> %212 to <8 x i64>
  %215 = select <8 x i1> %213, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %214
  %216 = fmul <8 x double> %91, <double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02>
  %217 = select <8 x i1> %167, <8 x i64> %211, <8 x i64> %215
  %218 = bitcast <8 x i64> %217 to <8 x double>
  %219 = fcmp olt <8 x double> %216, %218
  %220 = bitcast <8 x double> %216 to <8 x i64>
  %221 = select <8 x i1> %219, <8 x i64> %220, <8 x i64> %217
  %222 = bitcast <8 x i64> %221 to <8 x double>
  %223 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %14)
  %224 = fmul <8 x double> %223, <double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000>
  %225 = fcmp ogt <8 x double> %224, %222
  %226 = bitcast <8 x double> %224 to <8 x i64>
  %227 = select <8 x i1> %225, <8 x i64> %226, <8 x i64> %221
  %228 = bitcast <8 x i64> %227 to <8 x double>
  %229 = fcmp olt <8 x double> %82, %228
  %230 = select <8 x i1> %229, <8 x i64> %89, <8 x i64> %227
  %231 = trunc i32 %142 to i8
  %232 = bitcast i8 %231 to <8 x i1>
  %233 = select <8 x i1> %232, <8 x i64> %214, <8 x i64> %230
  %234 = bitcast <8 x i64> %233 to <8 x double>
  br label %238

235:                                              ; preds = %45
  %236 = insertelement <8 x double> poison, double %50, i64 0
  %237 = shufflevector <8 x double> %236, <8 x double> poison, <8 x i32> zeroinitializer
  br label %238

238:                                              ; preds = %235, %161
  %239 = phi double [ 2.000000e+00, %161 ], [ 1.000000e+00, %235 ]
  %240 = phi <8 x double> [ %234, %161 ], [ %237, %235 ]
  %241 = getelementptr inbounds i8, ptr %0, i64 648
  %242 = load ptr, ptr %241, align 8
  %243 = load <8 x double>, ptr %242, align 8
  %244 = select <8 x i1> %12, <8 x double> %240, <8 x double> %243
  store <8 x double> %244, ptr %242, align 8
  %245 = getelementptr inbounds i8, ptr %0, i64 672
  %246 = load ptr, ptr %245, align 8
  %247 = load <8 x double>, ptr %246, align 8
  %248 = select <8 x i1> %12, <8 x double> <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>, <8 x double> %247
  store <8 x double> %248, ptr %246, align 8
  %249 = getelementptr inbounds i8, ptr %0, i64 696
  %250 = load ptr, ptr %249, align 8
  %251 = load ptr, ptr %1, align 8
  %252 = getelementptr inbounds i8, ptr %251, i64 120
  %253 = load ptr, ptr %252, align 8
  %254 = getelementptr inbounds i8, ptr %253, i64 40
  %255 = load double, ptr %254, align 8
  %256 = insertelement <8 x double> poison, double %255, i64 0
  %257 = load <8 x i64>, ptr %250, align 8
  %258 = bitcast <8 x double> %256 to <8 x i64>
  %259 = shufflevector <8 x i64> %258, <8 x i64> poison, <8 x i32> zeroinitializer
  %260 = select <8 x i1> %12, <8 x i64> %259, <8 x i64> %257
  store <8 x i64> %260, ptr %250, align 8
  %261 = getelementptr inbounds i8, ptr %0, i64 768
  %262 = load ptr, ptr %261, align 8
  %263 = load <8 x double>, ptr %262, align 8
  %264 = select <8 x i1> %12, <8 x double> zeroinitializer, <8 x double> %263
  store <8 x double> %264, ptr %262, align 8
  %265 = getelementptr inbounds i8, ptr %0, i64 792
  %266 = load ptr, ptr %265, align 8
  %267 = load <8 x double>, ptr %266, align 8
  %268 = select <8 x i1> %12, <8 x double> zeroinitializer, <8 x double> %267
  store <8 x double> %268, ptr %266, align 8
  %269 = getelementptr inbounds i8, ptr %0, i64 816
  %270 = load ptr, ptr %269, align 8
  %271 = insertelement <8 x double> poison, double %239, i64 0
  %272 = load <8 x i64>, ptr %270, align 8
  %273 = bitcast <8 x double> %271 to <8 x i64>
  %274 = shufflevector <8 x i64> %273, <8 x i64> poison, <8 x i32> zeroinitializer
  %275 = select <8 x i1> %12, <8 x i64> %274, <8 x i64> %272
  store <8 x i64> %275, ptr %270, align 8
  %276 = getelementptr inbounds i8, ptr %0, i64 840
  %277 = load ptr, ptr %276, align 8
  %278 = tail call <8 x i1> @llvm.is.fpclass.v8f64(<8 x double> %240, i32 384)
  %279 = select <8 x i1> %278, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %280 = load <8 x i64>, ptr %277, align 8
  %281 = select <8 x i1> %12, <8 x i64> %279, <8 x i64> %280
  store <8 x i64> %281, ptr %277, align 8
  %282 = icmp eq i64 %2, 0
  br i1 %282, label %315, label %283

283:                                              ; preds = %238
  %284 = getelementptr inbounds i8, ptr %0, i64 864
  %285 = getelementptr inbounds i8, ptr %0, i64 960
  %286 = getelementptr inbounds i8, ptr %0, i64 968
  %287 = getelementptr inbounds i8, ptr %0, i64 720
  %288 = getelementptr inbounds i8, ptr %0, i64 744
  %289 = getelementptr inbounds i8, ptr %0, i64 888
  br label %290

290:                                              ; preds = %283, %290
  %291 = phi i64 [ %2, %283 ], [ %313, %290 ]
  %292 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %291, i1 true)
  %293 = load ptr, ptr %284, align 8
  %294 = getelementptr inbounds i64, ptr %293, i64 %292
  %295 = load i64, ptr %294, align 8
  %296 = load i64, ptr %286, align 8
  %297 = add nsw i64 %296, -1
  %298 = load ptr, ptr %287, align 8
  %299 = getelementptr inbounds double, ptr %298, i64 %292
  store double 0.000000e+00, ptr %299, align 8
  %300 = load ptr, ptr %285, align 8
  %301 = load double, ptr %300, align 8
  %302 = load ptr, ptr %288, align 8
  %303 = getelementptr inbounds double, ptr %302, i64 %292
  store double %301, ptr %303, align 8
  %304 = load ptr, ptr %8, align 8
  %305 = getelementptr inbounds i8, ptr %304, i64 24
  %306 = load i64, ptr %305, align 8
  %307 = shl i64 %295, 3
  %308 = mul i64 %307, %297
  %309 = add nsw i64 %306, %308
  %310 = load ptr, ptr %289, align 8
  %311 = getelementptr inbounds i64, ptr %310, i64 %292
  store i64 %309, ptr %311, align 8
  %312 = add nsw i64 %291, -1
  %313 = and i64 %312, %291
  %314 = icmp eq i64 %313, 0
  br i1 %314, label %315, label %290, !llvm.loop !33

315:                                              ; preds = %290, %238
  %316 = xor i64 %37, %2
  %317 = icmp eq i64 %37, %2
  br i1 %317, label %321, label %318

318:                                              ; preds = %315
  %319 = getelementptr inbounds i8, ptr %0, i64 744
  %320 = getelementptr inbounds i8, ptr %0, i64 960
  br label %329

321:                                              ; preds = %329, %315
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %37, i64 noundef 3) #10
  %322 = getelementptr inbounds i8, ptr %0, i64 744
  %323 = load ptr, ptr %322, align 8
  %324 = load <8 x double>, ptr %323, align 8
  %325 = fcmp oeq <8 x double> %324, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %326 = bitcast <8 x i1> %325 to i8
  %327 = zext i8 %326 to i64
  %328 = and i64 %316, %327
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %328, i64 noundef 0) #10
  ret void

329:                                              ; preds = %318, %329
  %330 = phi i64 [ %316, %318 ], [ %341, %329 ]
  %331 = load ptr, ptr %10, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %331, i64 noundef %330) #10
  %332 = load ptr, ptr %319, align 8
  %333 = load <8 x double>, ptr %332, align 8
  %334 = load ptr, ptr %320, align 8
  %335 = load double, ptr %334, align 8
  %336 = insertelement <8 x double> poison, double %335, i64 0
  %337 = shufflevector <8 x double> %336, <8 x double> poison, <8 x i32> zeroinitializer
  %338 = fcmp oeq <8 x double> %333, %337
  %339 = bitcast <8 x i1> %338 to i8
  %340 = zext i8 %339 to i64
  %341 = and i64 %330, %340
  %342 = icmp eq i64 %341, 0
  br i1 %342, label %321, label %329, !llvm.loop !34
}

define internal fastcc void @retire(ptr noundef readonly %0, i64 noundef %1, i64 noundef %2) unnamed_addr #4 {
  %4 = getelementptr inbounds i8, ptr %0, i64 624
  %5 = getelementptr inbounds i8, ptr %0, i64 912
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = load ptr, ptr %5, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 32
  %12 = load i64, ptr %11, align 8
  %13 = icmp eq i64 %1, 0
  br i1 %13, label %51, label %14

14:                                               ; preds = %3
  %15 = getelementptr inbounds i8, ptr %0, i64 864
  %16 = getelementptr inbounds i8, ptr %0, i64 888
  %17 = getelementptr inbounds i8, ptr %0, i64 968
  %18 = getelementptr inbounds i8, ptr %0, i64 720
  %19 = icmp sgt i64 %9, 0
  %20 = getelementptr inbounds i8, ptr %0, i64 1056
  %21 = getelementptr inbounds i8, ptr %0, i64 1072
  %22 = getelementptr inbounds i8, ptr %0, i64 768
  %23 = getelementptr inbounds i8, ptr %0, i64 792
  %24 = getelementptr inbounds i8, ptr %0, i64 816
  %25 = icmp slt i64 %2, 0
  %26 = getelementptr inbounds i8, ptr %0, i64 840
  %27 = getelementptr inbounds i8, ptr %0, i64 1080
  %28 = getelementptr inbounds i8, ptr %0, i64 1192
  %29 = getelementptr inbounds i8, ptr %0, i64 1176
  %30 = getelementptr inbounds i8, ptr %0, i64 1128
  %31 = getelementptr inbounds i8, ptr %0, i64 1104
  br label %32

32:                                               ; preds = %14, %99
  %33 = phi i64 [ %1, %14 ], [ %103, %99 ]
  %34 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %33, i1 true)
  %35 = load ptr, ptr %15, align 8
  %36 = getelementptr inbounds i64, ptr %35, i64 %34
  %37 = load i64, ptr %36, align 8
  %38 = load i64, ptr %17, align 8
  %39 = load ptr, ptr %18, align 8
  %40 = getelementptr inbounds double, ptr %39, i64 %34
  %41 = load double, ptr %40, align 8
  %42 = fptosi double %41 to i64
  %43 = xor i64 %42, -1
  %44 = add i64 %38, %43
  %45 = icmp sgt i64 %44, 0
  br i1 %45, label %46, label %55

46:                                               ; preds = %32
  %47 = load ptr, ptr %16, align 8
  %48 = getelementptr inbounds i64, ptr %47, i64 %34
  %49 = load i64, ptr %48, align 8
  %50 = inttoptr i64 %49 to ptr
  br label %52

51:                                               ; preds = %99, %3
  ret void

52:                                               ; preds = %46, %74
  %53 = phi i64 [ %75, %74 ], [ %44, %46 ]
  %54 = phi ptr [ %76, %74 ], [ %50, %46 ]
  br i1 %19, label %78, label %74

55:                                               ; preds = %74, %32
  %56 = load ptr, ptr %20, align 8
  %57 = load i64, ptr %21, align 8
  %58 = mul nsw i64 %57, %37
  %59 = getelementptr inbounds i64, ptr %56, i64 %58
  %60 = load ptr, ptr %22, align 8
  %61 = getelementptr inbounds double, ptr %60, i64 %34
  %62 = load double, ptr %61, align 8
  %63 = fptosi double %62 to i64
  store i64 %63, ptr %59, align 8
  %64 = load ptr, ptr %23, align 8
  %65 = getelementptr inbounds double, ptr %64, i64 %34
  %66 = load double, ptr %65, align 8
  %67 = fptosi double %66 to i64
  %68 = getelementptr inbounds i8, ptr %59, i64 8
  store i64 %67, ptr %68, align 8
  %69 = load ptr, ptr %24, align 8
  %70 = getelementptr inbounds double, ptr %69, i64 %34
  %71 = load double, ptr %70, align 8
  %72 = fptosi double %71 to i64
  %73 = getelementptr inbounds i8, ptr %59, i64 16
  store i64 %72, ptr %73, align 8
  br i1 %25, label %84, label %89

74:                                               ; preds = %78, %52
  %75 = add nsw i64 %53, -1
  %76 = getelementptr inbounds i8, ptr %54, i64 8
  %77 = icmp sgt i64 %53, 1
  br i1 %77, label %52, label %55, !llvm.loop !35

78:                                               ; preds = %52, %78
  %79 = phi i64 [ %82, %78 ], [ 0, %52 ]
  %80 = mul nsw i64 %79, %12
  %81 = getelementptr inbounds double, ptr %54, i64 %80
  store double 0x7FF8000000000000, ptr %81, align 8
  %82 = add nuw nsw i64 %79, 1
  %83 = icmp eq i64 %82, %9
  br i1 %83, label %74, label %78, !llvm.loop !36

84:                                               ; preds = %55
  %85 = load ptr, ptr %26, align 8
  %86 = getelementptr inbounds double, ptr %85, i64 %34
  %87 = load double, ptr %86, align 8
  %88 = fptosi double %87 to i64
  br label %89

89:                                               ; preds = %55, %84
  %90 = phi i64 [ %88, %84 ], [ %2, %55 ]
  %91 = getelementptr inbounds i8, ptr %59, i64 24
  store i64 %90, ptr %91, align 8
  %92 = load ptr, ptr %4, align 8
  %93 = getelementptr inbounds double, ptr %92, i64 %34
  %94 = load double, ptr %93, align 8
  %95 = load ptr, ptr %27, align 8
  %96 = getelementptr inbounds double, ptr %95, i64 %37
  store double %94, ptr %96, align 8
  %97 = load i64, ptr %28, align 8
  %98 = icmp sgt i64 %97, 0
  br i1 %98, label %105, label %99

99:                                               ; preds = %105, %89
  %100 = load ptr, ptr %15, align 8
  %101 = getelementptr inbounds i64, ptr %100, i64 %34
  store i64 -1, ptr %101, align 8
  %102 = add nsw i64 %33, -1
  %103 = and i64 %102, %33
  %104 = icmp eq i64 %103, 0
  br i1 %104, label %51, label %32, !llvm.loop !37

105:                                              ; preds = %89, %105
  %106 = phi i64 [ %125, %105 ], [ %97, %89 ]
  %107 = phi i64 [ %124, %105 ], [ 0, %89 ]
  %108 = load ptr, ptr %30, align 8
  %109 = getelementptr inbounds i64, ptr %108, i64 %34
  %110 = load i64, ptr %109, align 8
  %111 = inttoptr i64 %110 to ptr
  %112 = getelementptr inbounds i8, ptr %111, i64 696
  %113 = load ptr, ptr %112, align 8
  %114 = load ptr, ptr %31, align 8
  %115 = getelementptr inbounds i8, ptr %114, i64 8
  %116 = load i64, ptr %115, align 8
  %117 = getelementptr inbounds double, ptr %113, i64 %116
  %118 = getelementptr inbounds double, ptr %117, i64 %107
  %119 = load double, ptr %118, align 8
  %120 = load ptr, ptr %29, align 8
  %121 = mul nsw i64 %106, %37
  %122 = getelementptr double, ptr %120, i64 %121
  %123 = getelementptr double, ptr %122, i64 %107
  store double %119, ptr %123, align 8
  %124 = add nuw nsw i64 %107, 1
  %125 = load i64, ptr %28, align 8
  %126 = icmp slt i64 %124, %125
  br i1 %126, label %105, label %99, !llvm.loop !38
}

define internal fastcc range(i64 0, 256) i64 @hold_lanes(ptr noundef readonly %0, ptr noundef readonly %1, ptr noundef %2, i64 noundef %3) unnamed_addr #2 {
  %5 = getelementptr inbounds i8, ptr %0, i64 1152
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 144
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr inbounds i8, ptr %8, i64 8
  %10 = load i64, ptr %9, align 8
  %11 = icmp eq i64 %3, 0
  br i1 %11, label %25, label %12

12:                                               ; preds = %4
  %13 = getelementptr inbounds i8, ptr %0, i64 1128
  %14 = icmp sgt i64 %10, 0
  %15 = icmp sgt i64 %10, 0
  br label %16

16:                                               ; preds = %12, %49
  %17 = phi i64 [ 0, %12 ], [ %39, %49 ]
  %18 = phi i64 [ %3, %12 ], [ %51, %49 ]
  %19 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %18, i1 true)
  %20 = load ptr, ptr %13, align 8
  %21 = getelementptr inbounds i64, ptr %20, i64 %19
  %22 = load i64, ptr %21, align 8
  %23 = inttoptr i64 %22 to ptr
  %24 = getelementptr inbounds double, ptr %2, i64 %19
  br i1 %14, label %41, label %27

25:                                               ; preds = %49, %4
  %26 = phi i64 [ 0, %4 ], [ %39, %49 ]
  ret i64 %26

27:                                               ; preds = %41, %16
  %28 = getelementptr inbounds i8, ptr %23, i64 648
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds i8, ptr %29, i64 56
  %31 = load i64, ptr %30, align 8
  %32 = inttoptr i64 %31 to ptr
  %33 = getelementptr inbounds double, ptr %1, i64 %19
  %34 = load double, ptr %33, align 8
  %35 = tail call i64 %32(ptr noundef %23, double noundef %34, ptr noundef %6) #11
  %36 = icmp eq i64 %35, 0
  %37 = shl nuw i64 1, %19
  %38 = select i1 %36, i64 0, i64 %37
  %39 = or i64 %38, %17
  %40 = getelementptr inbounds double, ptr %2, i64 %19
  br i1 %15, label %53, label %49

41:                                               ; preds = %16, %41
  %42 = phi i64 [ %47, %41 ], [ 0, %16 ]
  %43 = shl nsw i64 %42, 6
  %44 = getelementptr inbounds i8, ptr %24, i64 %43
  %45 = load double, ptr %44, align 8
  %46 = getelementptr inbounds double, ptr %6, i64 %42
  store double %45, ptr %46, align 8
  %47 = add nuw nsw i64 %42, 1
  %48 = icmp eq i64 %47, %10
  br i1 %48, label %27, label %41, !llvm.loop !39

49:                                               ; preds = %53, %27
  %50 = add nsw i64 %18, -1
  %51 = and i64 %50, %18
  %52 = icmp eq i64 %51, 0
  br i1 %52, label %25, label %16, !llvm.loop !40

53:                                               ; preds = %27, %53
  %54 = phi i64 [ %59, %53 ], [ 0, %27 ]
  %55 = getelementptr inbounds double, ptr %6, i64 %54
  %56 = load double, ptr %55, align 8
  %57 = shl nsw i64 %54, 6
  %58 = getelementptr inbounds i8, ptr %40, i64 %57
  store double %56, ptr %58, align 8
  %59 = add nuw nsw i64 %54, 1
  %60 = icmp eq i64 %59, %10
  br i1 %60, label %49, label %53, !llvm.loop !41
}

define internal fastcc void @write_outputs(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2) unnamed_addr #4 {
  %4 = getelementptr inbounds i8, ptr %0, i64 144
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %5, i64 8
  %7 = load i64, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %0, i64 912
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %9, i64 32
  %11 = load i64, ptr %10, align 8
  %12 = icmp eq i64 %2, 0
  br i1 %12, label %28, label %13

13:                                               ; preds = %3
  %14 = getelementptr inbounds i8, ptr %0, i64 888
  %15 = icmp sgt i64 %7, 0
  %16 = getelementptr inbounds i8, ptr %0, i64 720
  %17 = getelementptr inbounds i8, ptr %0, i64 960
  %18 = getelementptr inbounds i8, ptr %0, i64 744
  br label %19

19:                                               ; preds = %13, %29
  %20 = phi i64 [ %2, %13 ], [ %44, %29 ]
  %21 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %20, i1 true)
  %22 = load ptr, ptr %14, align 8
  %23 = getelementptr inbounds i64, ptr %22, i64 %21
  %24 = load i64, ptr %23, align 8
  %25 = inttoptr i64 %24 to ptr
  %26 = add nsw i64 %24, 8
  store i64 %26, ptr %23, align 8
  %27 = getelementptr inbounds double, ptr %1, i64 %21
  br i1 %15, label %46, label %29

28:                                               ; preds = %29, %3
  ret void

29:                                               ; preds = %46, %19
  %30 = load ptr, ptr %16, align 8
  %31 = getelementptr inbounds double, ptr %30, i64 %21
  %32 = load double, ptr %31, align 8
  %33 = fadd double %32, 1.000000e+00
  store double %33, ptr %31, align 8
  %34 = load ptr, ptr %17, align 8
  %35 = load ptr, ptr %16, align 8
  %36 = getelementptr inbounds double, ptr %35, i64 %21
  %37 = load double, ptr %36, align 8
  %38 = fptosi double %37 to i64
  %39 = getelementptr inbounds double, ptr %34, i64 %38
  %40 = load double, ptr %39, align 8
  %41 = load ptr, ptr %18, align 8
  %42 = getelementptr inbounds double, ptr %41, i64 %21
  store double %40, ptr %42, align 8
  %43 = add nsw i64 %20, -1
  %44 = and i64 %43, %20
  %45 = icmp eq i64 %44, 0
  br i1 %45, label %28, label %19, !llvm.loop !42

46:                                               ; preds = %19, %46
  %47 = phi i64 [ %53, %46 ], [ 0, %19 ]
  %48 = shl nsw i64 %47, 6
  %49 = getelementptr inbounds i8, ptr %27, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = mul nsw i64 %47, %11
  %52 = getelementptr inbounds double, ptr %25, i64 %51
  store double %50, ptr %52, align 8
  %53 = add nuw nsw i64 %47, 1
  %54 = icmp eq i64 %53, %7
  br i1 %54, label %29, label %46, !llvm.loop !43
}

declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #5

declare i64 @llvm.cttz.i64(i64, i1 immarg) #5

define internal fastcc void @norm_to(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, i64 noundef %4) unnamed_addr #6 {
  %6 = icmp sgt i64 %4, 0
  br i1 %6, label %7, label %13

7:                                                ; preds = %5
  %8 = load ptr, ptr %3, align 8
  %9 = getelementptr inbounds i8, ptr %3, i64 240
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %3, i64 216
  %12 = load ptr, ptr %11, align 8
  br label %20

13:                                               ; preds = %20, %5
  %14 = phi <8 x double> [ zeroinitializer, %5 ], [ %46, %20 ]
  %15 = sitofp i64 %4 to double
  %16 = insertelement <8 x double> poison, double %15, i64 0
  %17 = shufflevector <8 x double> %16, <8 x double> poison, <8 x i32> zeroinitializer
  %18 = fdiv <8 x double> %14, %17
  %19 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %18)
  store <8 x double> %19, ptr %0, align 8
  ret void

20:                                               ; preds = %7, %20
  %21 = phi <8 x double> [ zeroinitializer, %7 ], [ %46, %20 ]
  %22 = phi i64 [ 0, %7 ], [ %47, %20 ]
  %23 = shl nsw i64 %22, 6
  %24 = getelementptr inbounds i8, ptr %1, i64 %23
  %25 = load <8 x double>, ptr %24, align 8
  %26 = getelementptr inbounds i8, ptr %8, i64 %23
  %27 = load <8 x double>, ptr %26, align 8
  %28 = getelementptr inbounds i8, ptr %2, i64 %23
  %29 = load <8 x double>, ptr %28, align 8
  %30 = getelementptr inbounds double, ptr %10, i64 %22
  %31 = load double, ptr %30, align 8
  %32 = insertelement <8 x double> poison, double %31, i64 0
  %33 = shufflevector <8 x double> %32, <8 x double> poison, <8 x i32> zeroinitializer
  %34 = getelementptr inbounds double, ptr %12, i64 %22
  %35 = load double, ptr %34, align 8
  %36 = insertelement <8 x double> poison, double %35, i64 0
  %37 = shufflevector <8 x double> %36, <8 x double> poison, <8 x i32> zeroinitializer
  %38 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %27)
  %39 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %29)
  %40 = fcmp ogt <8 x double> %38, %39
  %41 = select <8 x i1> %40, <8 x double> %38, <8 x double> %39
  %42 = fmul <8 x double> %41, %37
  %43 = fadd <8 x double> %33, %42
  %44 = fdiv <8 x double> %25, %43
  %45 = fmul <8 x double> %44, %44
  %46 = fadd <8 x double> %21, %45
  %47 = add nuw nsw i64 %22, 1
  %48 = icmp eq i64 %47, %4
  br i1 %48, label %13, label %20, !llvm.loop !44
}

declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #5

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #5

declare <8 x double> @llvm.rint.v8f64(<8 x double>) #5

declare <8 x double> @llvm.ceil.v8f64(<8 x double>) #5

define internal fastcc void @combine(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, ptr noundef readonly %4, ptr noundef readonly %5, i64 noundef %6, i64 noundef %7) unnamed_addr #7 {
  %9 = load <8 x double>, ptr %2, align 8
  %10 = shl nsw i64 %7, 3
  %11 = icmp slt i64 %7, 4
  br i1 %11, label %14, label %12

12:                                               ; preds = %8
  %13 = icmp sgt i64 %6, 0
  br label %19

14:                                               ; preds = %89, %8
  %15 = phi i64 [ 0, %8 ], [ %20, %89 ]
  %16 = icmp slt i64 %15, %10
  br i1 %16, label %17, label %139

17:                                               ; preds = %14
  %18 = icmp sgt i64 %6, 0
  br label %99

19:                                               ; preds = %12, %89
  %20 = phi i64 [ 32, %12 ], [ %97, %89 ]
  %21 = phi i64 [ 0, %12 ], [ %20, %89 ]
  %22 = getelementptr inbounds double, ptr %1, i64 %21
  %23 = getelementptr inbounds double, ptr %0, i64 %21
  %24 = getelementptr inbounds double, ptr %3, i64 %21
  br i1 %13, label %25, label %51

25:                                               ; preds = %19, %25
  %26 = phi <8 x double> [ %45, %25 ], [ zeroinitializer, %19 ]
  %27 = phi <8 x double> [ %42, %25 ], [ zeroinitializer, %19 ]
  %28 = phi <8 x double> [ %39, %25 ], [ zeroinitializer, %19 ]
  %29 = phi <8 x double> [ %48, %25 ], [ zeroinitializer, %19 ]
  %30 = phi i64 [ %49, %25 ], [ 0, %19 ]
  %31 = getelementptr inbounds i64, ptr %4, i64 %30
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr inbounds double, ptr %24, i64 %32
  %34 = getelementptr inbounds double, ptr %5, i64 %30
  %35 = load double, ptr %34, align 8
  %36 = insertelement <8 x double> poison, double %35, i64 0
  %37 = shufflevector <8 x double> %36, <8 x double> poison, <8 x i32> zeroinitializer
  %38 = load <8 x double>, ptr %33, align 8
  %39 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %37, <8 x double> %38, <8 x double> %28)
  %40 = getelementptr inbounds i8, ptr %33, i64 64
  %41 = load <8 x double>, ptr %40, align 8
  %42 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %37, <8 x double> %41, <8 x double> %27)
  %43 = getelementptr inbounds i8, ptr %33, i64 128
  %44 = load <8 x double>, ptr %43, align 8
  %45 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %37, <8 x double> %44, <8 x double> %26)
  %46 = getelementptr inbounds i8, ptr %33, i64 192
  %47 = load <8 x double>, ptr %46, align 8
  %48 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %37, <8 x double> %47, <8 x double> %29)
  %49 = add nuw nsw i64 %30, 1
  %50 = icmp eq i64 %49, %6
  br i1 %50, label %51, label %25, !llvm.loop !45

51:                                               ; preds = %25, %19
  %52 = phi <8 x double> [ zeroinitializer, %19 ], [ %45, %25 ]
  %53 = phi <8 x double> [ zeroinitializer, %19 ], [ %42, %25 ]
  %54 = phi <8 x double> [ zeroinitializer, %19 ], [ %39, %25 ]
  %55 = phi <8 x double> [ zeroinitializer, %19 ], [ %48, %25 ]
  %56 = phi i64 [ 0, %19 ], [ %6, %25 ]
  %57 = load <8 x double>, ptr %22, align 8
  %58 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %9, <8 x double> %54, <8 x double> %57)
  %59 = getelementptr inbounds i8, ptr %22, i64 64
  %60 = load <8 x double>, ptr %59, align 8
  %61 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %9, <8 x double> %53, <8 x double> %60)
  %62 = getelementptr inbounds i8, ptr %22, i64 128
  %63 = load <8 x double>, ptr %62, align 8
  %64 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %9, <8 x double> %52, <8 x double> %63)
  %65 = getelementptr inbounds i8, ptr %22, i64 192
  %66 = load <8 x double>, ptr %65, align 8
  %67 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %9, <8 x double> %55, <8 x double> %66)
  %68 = icmp sgt i64 %56, %6
  br i1 %68, label %89, label %69

69:                                               ; preds = %51
  %70 = getelementptr inbounds double, ptr %5, i64 %56
  %71 = load double, ptr %70, align 8
  %72 = insertelement <8 x double> poison, double %71, i64 0
  %73 = shufflevector <8 x double> %72, <8 x double> poison, <8 x i32> zeroinitializer
  %74 = fmul <8 x double> %9, %73
  %75 = getelementptr inbounds i64, ptr %4, i64 %56
  %76 = load i64, ptr %75, align 8
  %77 = getelementptr inbounds double, ptr %24, i64 %76
  %78 = getelementptr inbounds i8, ptr %77, i64 192
  %79 = load <8 x double>, ptr %78, align 8
  %80 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %74, <8 x double> %79, <8 x double> %67)
  %81 = getelementptr inbounds i8, ptr %77, i64 128
  %82 = load <8 x double>, ptr %81, align 8
  %83 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %74, <8 x double> %82, <8 x double> %64)
  %84 = getelementptr inbounds i8, ptr %77, i64 64
  %85 = load <8 x double>, ptr %84, align 8
  %86 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %74, <8 x double> %85, <8 x double> %61)
  %87 = load <8 x double>, ptr %77, align 8
  %88 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %74, <8 x double> %87, <8 x double> %58)
  br label %89

89:                                               ; preds = %69, %51
  %90 = phi <8 x double> [ %64, %51 ], [ %83, %69 ]
  %91 = phi <8 x double> [ %61, %51 ], [ %86, %69 ]
  %92 = phi <8 x double> [ %58, %51 ], [ %88, %69 ]
  %93 = phi <8 x double> [ %67, %51 ], [ %80, %69 ]
  store <8 x double> %92, ptr %23, align 8
  %94 = getelementptr inbounds i8, ptr %23, i64 64
  store <8 x double> %91, ptr %94, align 8
  %95 = getelementptr inbounds i8, ptr %23, i64 128
  store <8 x double> %90, ptr %95, align 8
  %96 = getelementptr inbounds i8, ptr %23, i64 192
  store <8 x double> %93, ptr %96, align 8
  %97 = add nuw nsw i64 %20, 32
  %98 = icmp sgt i64 %97, %10
  br i1 %98, label %14, label %19, !llvm.loop !46

99:                                               ; preds = %17, %135
  %100 = phi i64 [ %15, %17 ], [ %137, %135 ]
  %101 = getelementptr inbounds double, ptr %0, i64 %100
  %102 = getelementptr inbounds double, ptr %1, i64 %100
  %103 = getelementptr inbounds double, ptr %3, i64 %100
  br i1 %18, label %110, label %104

104:                                              ; preds = %110, %99
  %105 = phi <8 x double> [ zeroinitializer, %99 ], [ %121, %110 ]
  %106 = phi i64 [ 0, %99 ], [ %6, %110 ]
  %107 = load <8 x double>, ptr %102, align 8
  %108 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %9, <8 x double> %105, <8 x double> %107)
  %109 = icmp sgt i64 %106, %6
  br i1 %109, label %135, label %124

110:                                              ; preds = %99, %110
  %111 = phi <8 x double> [ %121, %110 ], [ zeroinitializer, %99 ]
  %112 = phi i64 [ %122, %110 ], [ 0, %99 ]
  %113 = getelementptr inbounds double, ptr %5, i64 %112
  %114 = load double, ptr %113, align 8
  %115 = insertelement <8 x double> poison, double %114, i64 0
  %116 = shufflevector <8 x double> %115, <8 x double> poison, <8 x i32> zeroinitializer
  %117 = getelementptr inbounds i64, ptr %4, i64 %112
  %118 = load i64, ptr %117, align 8
  %119 = getelementptr inbounds double, ptr %103, i64 %118
  %120 = load <8 x double>, ptr %119, align 8
  %121 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %116, <8 x double> %120, <8 x double> %111)
  %122 = add nuw nsw i64 %112, 1
  %123 = icmp eq i64 %122, %6
  br i1 %123, label %104, label %110, !llvm.loop !45

124:                                              ; preds = %104
  %125 = getelementptr inbounds double, ptr %5, i64 %106
  %126 = load double, ptr %125, align 8
  %127 = insertelement <8 x double> poison, double %126, i64 0
  %128 = shufflevector <8 x double> %127, <8 x double> poison, <8 x i32> zeroinitializer
  %129 = fmul <8 x double> %9, %128
  %130 = getelementptr inbounds i64, ptr %4, i64 %106
  %131 = load i64, ptr %130, align 8
  %132 = getelementptr inbounds double, ptr %103, i64 %131
  %133 = load <8 x double>, ptr %132, align 8
  %134 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %129, <8 x double> %133, <8 x double> %108)
  br label %135

135:                                              ; preds = %124, %104
  %136 = phi <8 x double> [ %108, %104 ], [ %134, %124 ]
  store <8 x double> %136, ptr %101, align 8
  %137 = add nuw nsw i64 %100, 8
  %138 = icmp slt i64 %137, %10
  br i1 %138, label %99, label %139, !llvm.loop !47

139:                                              ; preds = %135, %14
  ret void
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #4 {
  %2 = getelementptr inbounds i8, ptr %0, i64 128
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %13

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 120
  %7 = getelementptr inbounds i8, ptr %0, i64 136
  %8 = getelementptr inbounds i8, ptr %0, i64 144
  %9 = getelementptr inbounds i8, ptr %0, i64 24
  %10 = getelementptr inbounds i8, ptr %0, i64 168
  %11 = getelementptr inbounds i8, ptr %0, i64 192
  %12 = getelementptr inbounds i8, ptr %0, i64 48
  br label %14

13:                                               ; preds = %21, %1
  ret void

14:                                               ; preds = %5, %21
  %15 = phi i64 [ 0, %5 ], [ %22, %21 ]
  %16 = load ptr, ptr %6, align 8
  %17 = load i64, ptr %7, align 8
  %18 = mul nsw i64 %17, %15
  %19 = getelementptr inbounds i64, ptr %16, i64 %18
  %20 = shl nsw i64 %15, 6
  br label %25

21:                                               ; preds = %71
  %22 = add nuw nsw i64 %15, 1
  %23 = load i64, ptr %2, align 8
  %24 = icmp slt i64 %22, %23
  br i1 %24, label %14, label %13, !llvm.loop !48

25:                                               ; preds = %14, %71
  %26 = phi i64 [ 0, %14 ], [ %98, %71 ]
  %27 = load ptr, ptr %8, align 8
  %28 = getelementptr inbounds i8, ptr %27, i64 %20
  %29 = getelementptr inbounds i64, ptr %28, i64 %26
  %30 = load ptr, ptr %9, align 8
  %31 = getelementptr inbounds double, ptr %30, i64 %26
  %32 = load double, ptr %31, align 8
  %33 = load ptr, ptr %6, align 8
  %34 = load i64, ptr %7, align 8
  %35 = mul nsw i64 %34, %15
  %36 = getelementptr inbounds i64, ptr %33, i64 %35
  %37 = getelementptr inbounds i8, ptr %36, i64 8
  %38 = load i64, ptr %37, align 8
  %39 = load ptr, ptr %10, align 8
  %40 = getelementptr inbounds double, ptr %39, i64 %38
  %41 = load double, ptr %40, align 8
  %42 = fcmp ogt double %41, %32
  %43 = select i1 %42, double %41, double %32
  %44 = getelementptr inbounds i8, ptr %36, i64 16
  %45 = load i64, ptr %44, align 8
  %46 = load i64, ptr %29, align 8
  %47 = getelementptr inbounds double, ptr %40, i64 %46
  %48 = load double, ptr %47, align 8
  %49 = fcmp ugt double %48, %43
  br i1 %49, label %57, label %50

50:                                               ; preds = %25
  %51 = add nsw i64 %45, -1
  %52 = icmp eq i64 %51, %46
  br i1 %52, label %71, label %53

53:                                               ; preds = %50
  %54 = getelementptr i8, ptr %47, i64 8
  %55 = load double, ptr %54, align 8
  %56 = fcmp ogt double %55, %43
  br i1 %56, label %71, label %57

57:                                               ; preds = %53, %25
  %58 = icmp sgt i64 %45, 1
  br i1 %58, label %59, label %71

59:                                               ; preds = %57, %59
  %60 = phi i64 [ %68, %59 ], [ %45, %57 ]
  %61 = phi i64 [ %67, %59 ], [ 0, %57 ]
  %62 = add nsw i64 %60, %61
  %63 = sdiv i64 %62, 2
  %64 = getelementptr inbounds double, ptr %40, i64 %63
  %65 = load double, ptr %64, align 8
  %66 = fcmp ugt double %65, %43
  %67 = select i1 %66, i64 %61, i64 %63
  %68 = select i1 %66, i64 %63, i64 %60
  %69 = sub nsw i64 %68, %67
  %70 = icmp sgt i64 %69, 1
  br i1 %70, label %59, label %71, !llvm.loop !49

71:                                               ; preds = %59, %57, %50, %53
  %72 = phi i64 [ %46, %53 ], [ %46, %50 ], [ 0, %57 ], [ %67, %59 ]
  store i64 %72, ptr %29, align 8
  %73 = getelementptr inbounds double, ptr %40, i64 %72
  %74 = load double, ptr %73, align 8
  %75 = fsub double %43, %74
  %76 = load ptr, ptr %11, align 8
  %77 = add nsw i64 %72, %38
  %78 = shl nsw i64 %77, 5
  %79 = getelementptr inbounds i8, ptr %76, i64 %78
  %80 = load double, ptr %79, align 8
  %81 = getelementptr inbounds i8, ptr %79, i64 8
  %82 = load double, ptr %81, align 8
  %83 = getelementptr inbounds i8, ptr %79, i64 16
  %84 = load double, ptr %83, align 8
  %85 = getelementptr inbounds i8, ptr %79, i64 24
  %86 = load double, ptr %85, align 8
  %87 = fmul double %75, %86
  %88 = fadd double %84, %87
  %89 = fmul double %75, %88
  %90 = fadd double %82, %89
  %91 = fmul double %75, %90
  %92 = fadd double %80, %91
  %93 = load ptr, ptr %12, align 8
  %94 = load i64, ptr %19, align 8
  %95 = shl i64 %94, 6
  %96 = getelementptr i8, ptr %93, i64 %95
  %97 = getelementptr double, ptr %96, i64 %26
  store double %92, ptr %97, align 8
  %98 = add nuw nsw i64 %26, 1
  %99 = icmp eq i64 %98, 8
  br i1 %99, label %21, label %25, !llvm.loop !50
}

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
  br i1 %31, label %20, label %19, !llvm.loop !51

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
  br i1 %43, label %32, label %24, !llvm.loop !52
}

declare <8 x i1> @llvm.is.fpclass.v8f64(<8 x double>, i32 immarg) #8

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { noinline nounwind }
attributes #5 = { nounwind willreturn memory(none) }
attributes #6 = { noinline nounwind }
attributes #7 = { noinline nounwind }
attributes #8 = { nounwind willreturn memory(none) }
attributes #9 = { nounwind }
attributes #10 = { nounwind }
attributes #11 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = distinct !{!3, !4, !5}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
!6 = distinct !{!6, !4, !5}
!7 = distinct !{!7, !5}
!8 = distinct !{!8, !4, !5}
!9 = distinct !{!9, !4, !5}
!10 = distinct !{!10, !4, !5}
!11 = distinct !{!11, !4, !5}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5}
!14 = distinct !{!14, !4, !5}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5}
!17 = distinct !{!17, !4, !5, !18}
!18 = !{!"llvm.loop.vectorize.width", i32 1}
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !4, !5}
!21 = distinct !{!21, !4, !5}
!22 = distinct !{!22, !4, !5}
!23 = distinct !{!23, !4, !5}
!24 = distinct !{!24, !4, !5, !18}
!25 = distinct !{!25, !4, !5, !18}
!26 = distinct !{!26, !4, !5, !18}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5, !18}
!29 = distinct !{!29, !4, !5}
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5}
!35 = distinct !{!35, !4, !5}
!36 = distinct !{!36, !4, !5, !18}
!37 = distinct !{!37, !4, !5}
!38 = distinct !{!38, !4, !5, !18}
!39 = distinct !{!39, !4, !5, !18}
!40 = distinct !{!40, !4, !5}
!41 = distinct !{!41, !4, !5, !18}
!42 = distinct !{!42, !4, !5}
!43 = distinct !{!43, !4, !5, !18}
!44 = distinct !{!44, !4, !5}
!45 = distinct !{!45, !4, !5}
!46 = distinct !{!46, !4, !5}
!47 = distinct !{!47, !4, !5}
!48 = distinct !{!48, !4, !5}
!49 = distinct !{!49, !4, !5}
!50 = distinct !{!50, !4, !5}
!51 = distinct !{!51, !4, !5}
!52 = distinct !{!52, !4, !5}
