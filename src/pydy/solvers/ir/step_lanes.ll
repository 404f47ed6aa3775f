; sources b96685b1393add36728f397923b0782a711cf4c11a8a3e5b1e968f58f7cdf143
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

@PLACES = internal unnamed_addr constant [5 x double] [double 0.000000e+00, double 0x3FCE3779B97F4A7C, double 0x3FDCC470A0490974, double 0x3FE76CF5D0B09954, double 1.000000e+00], align 16

define noundef i64 @step_lanes(ptr noundef %0) #0 {
  %2 = alloca %struct.Stepper, align 8
  %3 = alloca [8 x double], align 16
  %4 = alloca [8 x double], align 16
  %5 = alloca i64, align 8
  %6 = alloca [8 x i64], align 16
  %7 = alloca i64, align 8
  store ptr %0, ptr %2, align 8
  %8 = getelementptr inbounds i8, ptr %2, i64 8
  %9 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %9, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %2, i64 16
  %11 = getelementptr inbounds i8, ptr %0, i64 384
  store ptr %11, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 936
  %13 = load ptr, ptr %9, align 8
  %14 = getelementptr inbounds i8, ptr %13, i64 8
  %15 = load i64, ptr %14, align 8
  %16 = load ptr, ptr %0, align 8
  %17 = getelementptr inbounds i8, ptr %0, i64 984
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 992
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr double, ptr %18, i64 %20
  %22 = getelementptr i8, ptr %21, i64 -16
  %23 = load double, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %0, i64 960
  %25 = load ptr, ptr %24, align 8
  %26 = load double, ptr %25, align 8
  %27 = load ptr, ptr %12, align 8
  %28 = getelementptr inbounds i8, ptr %27, i64 16
  %29 = load i64, ptr %28, align 8
  %30 = getelementptr inbounds i8, ptr %0, i64 120
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds i8, ptr %16, i64 8
  %33 = load i64, ptr %32, align 8
  %34 = icmp sgt i64 %33, 0
  %35 = getelementptr inbounds i8, ptr %16, i64 32
  %36 = load i64, ptr %35, align 8
  %37 = getelementptr inbounds i8, ptr %0, i64 1608
  %38 = load ptr, ptr %37, align 8
  %39 = load i64, ptr %38, align 8
  %40 = icmp eq i64 %39, 1
  %41 = getelementptr inbounds i8, ptr %0, i64 1200
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds i8, ptr %42, i64 8
  %44 = load i64, ptr %43, align 8
  %45 = getelementptr inbounds i8, ptr %0, i64 552
  %46 = load ptr, ptr %45, align 8
  %47 = load i64, ptr %16, align 8
  %48 = getelementptr inbounds i8, ptr %0, i64 392
  %49 = load i64, ptr %48, align 8
  %50 = mul nsw i64 %49, %47
  store i64 0, ptr %5, align 8
  %51 = getelementptr inbounds i8, ptr %0, i64 888
  %52 = load ptr, ptr %51, align 8
  br label %139

53:                                               ; preds = %139
  %54 = getelementptr inbounds i8, ptr %0, i64 648
  %55 = sitofp i64 %29 to double
  %56 = zext i1 %34 to i32
  %57 = icmp ne i64 %36, 1
  %58 = select i1 %40, i1 true, i1 %57
  %59 = icmp sgt i64 %44, 0
  %60 = getelementptr inbounds double, ptr %46, i64 %50
  store i64 %147, ptr %5, align 8
  %61 = getelementptr inbounds i8, ptr %0, i64 888
  %62 = getelementptr inbounds i8, ptr %0, i64 1520
  %63 = getelementptr inbounds i8, ptr %0, i64 1152
  %64 = getelementptr inbounds i8, ptr %0, i64 768
  %65 = insertelement <8 x double> poison, double %23, i64 0
  %66 = shufflevector <8 x double> %65, <8 x double> poison, <8 x i32> zeroinitializer
  %67 = getelementptr inbounds i8, ptr %0, i64 672
  %68 = insertelement <8 x double> poison, double %26, i64 0
  %69 = shufflevector <8 x double> %68, <8 x double> poison, <8 x i32> zeroinitializer
  %70 = getelementptr inbounds i8, ptr %0, i64 792
  %71 = getelementptr inbounds i8, ptr %0, i64 816
  %72 = insertelement <8 x double> poison, double %55, i64 0
  %73 = shufflevector <8 x double> %72, <8 x double> poison, <8 x i32> zeroinitializer
  %74 = getelementptr inbounds i8, ptr %0, i64 456
  %75 = getelementptr inbounds i8, ptr %0, i64 432
  %76 = getelementptr inbounds i8, ptr %0, i64 24
  %77 = getelementptr inbounds i8, ptr %0, i64 552
  %78 = getelementptr inbounds i8, ptr %0, i64 48
  %79 = getelementptr inbounds i8, ptr %0, i64 72
  %80 = getelementptr inbounds i8, ptr %0, i64 392
  %81 = getelementptr inbounds i8, ptr %0, i64 96
  %82 = getelementptr inbounds i8, ptr %0, i64 168
  %83 = getelementptr inbounds i8, ptr %0, i64 296
  %84 = getelementptr inbounds i8, ptr %0, i64 192
  %85 = getelementptr inbounds i8, ptr %0, i64 240
  %86 = getelementptr inbounds i8, ptr %0, i64 408
  %87 = getelementptr inbounds i8, ptr %0, i64 24
  %88 = getelementptr inbounds i8, ptr %0, i64 552
  %89 = getelementptr inbounds i8, ptr %0, i64 48
  %90 = getelementptr inbounds i8, ptr %0, i64 72
  %91 = getelementptr inbounds i8, ptr %0, i64 408
  %92 = getelementptr inbounds i8, ptr %0, i64 168
  %93 = getelementptr inbounds i8, ptr %0, i64 296
  %94 = getelementptr inbounds i8, ptr %0, i64 192
  %95 = getelementptr inbounds i8, ptr %0, i64 240
  %96 = icmp sgt i64 %15, 0
  %97 = getelementptr inbounds i8, ptr %0, i64 408
  %98 = getelementptr inbounds i8, ptr %0, i64 528
  %99 = getelementptr inbounds i8, ptr %0, i64 392
  %100 = getelementptr inbounds i8, ptr %0, i64 504
  %101 = getelementptr inbounds i8, ptr %0, i64 624
  %102 = getelementptr inbounds i8, ptr %0, i64 600
  %103 = getelementptr inbounds i8, ptr %0, i64 408
  %104 = getelementptr inbounds i8, ptr %0, i64 408
  %105 = getelementptr inbounds i8, ptr %0, i64 168
  %106 = getelementptr inbounds i8, ptr %0, i64 296
  %107 = getelementptr inbounds i8, ptr %0, i64 192
  %108 = getelementptr inbounds i8, ptr %0, i64 240
  %109 = getelementptr inbounds i8, ptr %0, i64 840
  %110 = sext i1 %57 to i64
  %111 = uitofp i1 %58 to double
  %112 = insertelement <8 x double> poison, double %111, i64 0
  %113 = bitcast <8 x double> %112 to <8 x i64>
  %114 = shufflevector <8 x i64> %113, <8 x i64> poison, <8 x i32> zeroinitializer
  %115 = getelementptr inbounds i8, ptr %0, i64 768
  %116 = getelementptr inbounds i8, ptr %0, i64 392
  %117 = getelementptr inbounds i8, ptr %0, i64 576
  %118 = getelementptr inbounds i8, ptr %0, i64 432
  %119 = getelementptr inbounds i8, ptr %0, i64 96
  %120 = getelementptr inbounds i8, ptr %0, i64 168
  %121 = getelementptr inbounds i8, ptr %0, i64 296
  %122 = getelementptr inbounds i8, ptr %0, i64 192
  %123 = getelementptr inbounds i8, ptr %0, i64 240
  %124 = getelementptr inbounds i8, ptr %0, i64 504
  %125 = getelementptr inbounds i8, ptr %16, i64 16
  %126 = getelementptr inbounds i8, ptr %0, i64 408
  %127 = getelementptr inbounds i8, ptr %0, i64 696
  %128 = getelementptr inbounds i8, ptr %0, i64 720
  %129 = getelementptr inbounds i8, ptr %31, i64 24
  %130 = getelementptr inbounds i8, ptr %31, i64 8
  %131 = getelementptr inbounds i8, ptr %31, i64 16
  %132 = getelementptr inbounds i8, ptr %31, i64 32
  %133 = getelementptr inbounds i8, ptr %31, i64 40
  %134 = getelementptr inbounds i8, ptr %31, i64 24
  %135 = getelementptr inbounds i8, ptr %31, i64 32
  %136 = getelementptr inbounds i8, ptr %0, i64 864
  %137 = icmp sgt i64 %15, 0
  %138 = getelementptr inbounds i8, ptr %0, i64 408
  br label %150

139:                                              ; preds = %1, %139
  %140 = phi i64 [ 0, %1 ], [ %148, %139 ]
  %141 = phi i64 [ 0, %1 ], [ %147, %139 ]
  %142 = getelementptr inbounds i64, ptr %52, i64 %140
  %143 = load i64, ptr %142, align 8
  %144 = icmp sgt i64 %143, -1
  %145 = zext i1 %144 to i64
  %146 = shl nuw nsw i64 %145, %140
  %147 = or i64 %146, %141
  %148 = add nuw nsw i64 %140, 1
  %149 = icmp eq i64 %148, 8
  br i1 %149, label %53, label %139, !llvm.loop !3

150:                                              ; preds = %185, %53
  %151 = phi i32 [ 1, %53 ], [ %186, %185 ]
  %152 = phi i64 [ 0, %53 ], [ %187, %185 ]
  %153 = icmp ne i32 %151, 0
  %154 = icmp ne i64 %152, 0
  %155 = select i1 %153, i1 true, i1 %154
  br i1 %155, label %156, label %188

156:                                              ; preds = %150
  br i1 %153, label %157, label %159

157:                                              ; preds = %156
  %158 = call fastcc i64 @fill(ptr noundef nonnull %0, ptr noundef nonnull %5) #11
  br label %159

159:                                              ; preds = %156, %157
  %160 = phi i64 [ %158, %157 ], [ 0, %156 ]
  %161 = load i64, ptr %5, align 8
  %162 = icmp eq i64 %161, 0
  br i1 %162, label %181, label %163

163:                                              ; preds = %159
  %164 = or i64 %160, %152
  %165 = icmp eq i64 %164, 0
  br i1 %165, label %181, label %166

166:                                              ; preds = %163
  call fastcc void @start(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %160, i64 noundef %152) #11
  br label %167

167:                                              ; preds = %166, %176
  %168 = phi i32 [ 0, %166 ], [ %178, %176 ]
  %169 = phi i64 [ 0, %166 ], [ %179, %176 ]
  %170 = icmp eq i32 %168, 0
  br i1 %170, label %171, label %176

171:                                              ; preds = %167
  %172 = load ptr, ptr %61, align 8
  %173 = getelementptr inbounds i64, ptr %172, i64 %169
  %174 = load i64, ptr %173, align 8
  %175 = icmp eq i64 %174, -1
  br label %176

176:                                              ; preds = %171, %167
  %177 = phi i1 [ true, %167 ], [ %175, %171 ]
  %178 = zext i1 %177 to i32
  %179 = add nuw nsw i64 %169, 1
  %180 = icmp eq i64 %179, 8
  br i1 %180, label %181, label %167, !llvm.loop !6

181:                                              ; preds = %176, %163, %159
  %182 = phi i32 [ 1, %159 ], [ 8, %163 ], [ 0, %176 ]
  %183 = phi i32 [ %151, %159 ], [ 0, %163 ], [ %178, %176 ]
  %184 = phi i64 [ %152, %159 ], [ %152, %163 ], [ 0, %176 ]
  switch i32 %182, label %1103 [
    i32 0, label %185
    i32 8, label %188
  ]

185:                                              ; preds = %181, %1101, %263
  %186 = phi i32 [ %183, %181 ], [ %1102, %1101 ], [ 1, %263 ]
  %187 = phi i64 [ %184, %181 ], [ %1091, %1101 ], [ %190, %263 ]
  br label %150, !llvm.loop !7

188:                                              ; preds = %181, %150
  %189 = phi i32 [ %183, %181 ], [ 0, %150 ]
  %190 = phi i64 [ %184, %181 ], [ 0, %150 ]
  %191 = load ptr, ptr %12, align 8
  %192 = getelementptr inbounds i8, ptr %191, i64 8
  %193 = load i64, ptr %192, align 8
  %194 = icmp slt i64 %193, 1
  br i1 %194, label %1103, label %195

195:                                              ; preds = %188
  br i1 %59, label %196, label %216

196:                                              ; preds = %195
  %197 = load i64, ptr %62, align 8
  %198 = icmp sgt i64 %197, 0
  br i1 %198, label %199, label %213

199:                                              ; preds = %196
  %200 = load ptr, ptr %41, align 8
  %201 = getelementptr inbounds i8, ptr %200, i64 72
  %202 = load i64, ptr %201, align 8
  %203 = load ptr, ptr %63, align 8
  %204 = load i64, ptr %203, align 8
  %205 = inttoptr i64 %204 to ptr
  %206 = getelementptr inbounds i8, ptr %205, i64 1016
  %207 = load i64, ptr %206, align 8
  %208 = shl i64 %207, 4
  %209 = add i64 %202, 16
  %210 = add i64 %209, %208
  %211 = icmp sgt i64 %210, %197
  %212 = zext i1 %211 to i32
  br label %213

213:                                              ; preds = %196, %199
  %214 = phi i32 [ 0, %196 ], [ %212, %199 ]
  %215 = icmp eq i32 %214, 0
  br i1 %215, label %216, label %1103

216:                                              ; preds = %213, %195
  %217 = add nsw i64 %193, -1
  store i64 %217, ptr %192, align 8
  %218 = load i64, ptr %5, align 8
  %219 = trunc i64 %218 to i8
  %220 = bitcast i8 %219 to <8 x i1>
  %221 = load ptr, ptr %54, align 8
  %222 = load <8 x double>, ptr %221, align 8
  br i1 %34, label %226, label %223

223:                                              ; preds = %216
  %224 = load ptr, ptr %64, align 8
  %225 = load <8 x double>, ptr %224, align 8
  br label %226

226:                                              ; preds = %216, %223
  %227 = phi <8 x double> [ %225, %223 ], [ %66, %216 ]
  %228 = load ptr, ptr %67, align 8
  %229 = load <8 x double>, ptr %228, align 8
  br i1 %34, label %230, label %233

230:                                              ; preds = %226
  %231 = fcmp olt <8 x double> %229, %69
  %232 = select <8 x i1> %231, <8 x double> %229, <8 x double> %69
  br label %239

233:                                              ; preds = %226
  %234 = fsub <8 x double> %227, %222
  %235 = fdiv <8 x double> %234, %229
  %236 = fmul <8 x double> %235, <double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1>
  %237 = call <8 x double> @llvm.ceil.v8f64(<8 x double> %236)
  %238 = fdiv <8 x double> %234, %237
  br label %239

239:                                              ; preds = %233, %230
  %240 = phi <8 x double> [ %232, %230 ], [ %238, %233 ]
  %241 = fadd <8 x double> %222, %240
  %242 = fmul <8 x double> %240, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %243 = fsub <8 x double> %227, %242
  %244 = fcmp ogt <8 x double> %241, %243
  %245 = select <8 x i1> %244, <8 x double> %227, <8 x double> %241
  %246 = fsub <8 x double> %245, %222
  %247 = select <8 x i1> %220, <8 x double> %246, <8 x double> zeroinitializer
  %248 = load ptr, ptr %70, align 8
  %249 = load <8 x double>, ptr %248, align 8
  %250 = load ptr, ptr %71, align 8
  %251 = load <8 x double>, ptr %250, align 8
  %252 = fadd <8 x double> %249, %251
  %253 = fcmp oge <8 x double> %252, %73
  %254 = fmul <8 x double> %247, <double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02>
  %255 = fadd <8 x double> %222, %254
  %256 = fcmp ule <8 x double> %255, %222
  %257 = fcmp une <8 x double> %245, %227
  %258 = and <8 x i1> %256, %257
  %259 = or <8 x i1> %258, %253
  %260 = and <8 x i1> %259, %220
  %261 = bitcast <8 x i1> %260 to i8
  %262 = icmp eq i8 %261, 0
  br i1 %262, label %270, label %263

263:                                              ; preds = %239
  %264 = zext i8 %261 to i64
  %265 = bitcast <8 x i1> %253 to i8
  %266 = zext i8 %265 to i64
  %267 = and i64 %264, %266
  call fastcc void @retire(ptr noundef %0, i64 noundef %267, i64 noundef 1) #11
  %268 = xor i64 %266, -1
  %269 = and i64 %264, %268
  call fastcc void @retire(ptr noundef %0, i64 noundef %269, i64 noundef -1) #11
  br label %185

270:                                              ; preds = %239
  %271 = load ptr, ptr %0, align 8
  %272 = load i64, ptr %271, align 8
  %273 = load ptr, ptr %74, align 8
  store <8 x double> %247, ptr %273, align 8
  %274 = icmp sgt i64 %272, 1
  br i1 %274, label %275, label %324

275:                                              ; preds = %270, %312
  %276 = phi i64 [ %321, %312 ], [ 0, %270 ]
  %277 = phi i64 [ %322, %312 ], [ 1, %270 ]
  %278 = load ptr, ptr %75, align 8
  %279 = load ptr, ptr %11, align 8
  %280 = load ptr, ptr %9, align 8
  %281 = getelementptr inbounds i8, ptr %280, i64 16
  %282 = load i64, ptr %281, align 8
  %283 = load ptr, ptr %76, align 8
  %284 = getelementptr inbounds i64, ptr %283, i64 %277
  %285 = load i64, ptr %284, align 8
  %286 = getelementptr i8, ptr %284, i64 8
  %287 = load i64, ptr %286, align 8
  %288 = xor i64 %285, -1
  %289 = add i64 %287, %288
  %290 = load ptr, ptr %74, align 8
  %291 = load ptr, ptr %77, align 8
  %292 = load ptr, ptr %78, align 8
  %293 = getelementptr inbounds i64, ptr %292, i64 %285
  %294 = load ptr, ptr %79, align 8
  %295 = getelementptr inbounds double, ptr %294, i64 %285
  call fastcc void @combine(ptr noundef %278, ptr noundef %279, ptr noundef %290, ptr noundef %291, ptr noundef %293, ptr noundef %295, i64 noundef %289, i64 noundef %282) #11
  %296 = load ptr, ptr %77, align 8
  %297 = load i64, ptr %80, align 8
  %298 = mul nsw i64 %297, %277
  %299 = getelementptr inbounds double, ptr %296, i64 %298
  %300 = load ptr, ptr %81, align 8
  %301 = getelementptr inbounds double, ptr %300, i64 %277
  %302 = load double, ptr %301, align 8
  %303 = insertelement <8 x double> poison, double %302, i64 0
  %304 = shufflevector <8 x double> %303, <8 x double> poison, <8 x i32> zeroinitializer
  %305 = fmul <8 x double> %247, %304
  %306 = fadd <8 x double> %222, %305
  %307 = load ptr, ptr %75, align 8
  %308 = load ptr, ptr %82, align 8
  store <8 x double> %306, ptr %308, align 8
  %309 = load i64, ptr %83, align 8
  %310 = icmp sgt i64 %309, 0
  br i1 %310, label %311, label %312

311:                                              ; preds = %275
  call fastcc void @sample(ptr noundef nonnull %9) #11
  br label %312

312:                                              ; preds = %275, %311
  %313 = load ptr, ptr %9, align 8
  %314 = load i64, ptr %313, align 8
  %315 = load ptr, ptr %82, align 8
  %316 = load ptr, ptr %84, align 8
  %317 = load ptr, ptr %85, align 8
  %318 = inttoptr i64 %314 to ptr
  %319 = call i32 %318(ptr noundef %315, ptr noundef %307, ptr noundef %316, ptr noundef %317, ptr noundef %299) #12
  %320 = zext i32 %319 to i64
  %321 = or i64 %276, %320
  %322 = add nuw nsw i64 %277, 1
  %323 = icmp eq i64 %322, %272
  br i1 %323, label %324, label %275, !llvm.loop !8

324:                                              ; preds = %312, %270
  %325 = phi i64 [ 0, %270 ], [ %321, %312 ]
  %326 = load ptr, ptr %86, align 8
  %327 = load ptr, ptr %11, align 8
  %328 = load ptr, ptr %9, align 8
  %329 = getelementptr inbounds i8, ptr %328, i64 16
  %330 = load i64, ptr %329, align 8
  %331 = load ptr, ptr %87, align 8
  %332 = getelementptr inbounds i64, ptr %331, i64 %272
  %333 = load i64, ptr %332, align 8
  %334 = getelementptr i8, ptr %332, i64 8
  %335 = load i64, ptr %334, align 8
  %336 = xor i64 %333, -1
  %337 = add i64 %335, %336
  %338 = load ptr, ptr %74, align 8
  %339 = load ptr, ptr %88, align 8
  %340 = load ptr, ptr %89, align 8
  %341 = getelementptr inbounds i64, ptr %340, i64 %333
  %342 = load ptr, ptr %90, align 8
  %343 = getelementptr inbounds double, ptr %342, i64 %333
  call fastcc void @combine(ptr noundef %326, ptr noundef %327, ptr noundef %338, ptr noundef %339, ptr noundef %341, ptr noundef %343, i64 noundef %337, i64 noundef %330) #11
  br i1 %57, label %360, label %344

344:                                              ; preds = %324
  %345 = load ptr, ptr %91, align 8
  %346 = load ptr, ptr %92, align 8
  store <8 x double> %245, ptr %346, align 8
  %347 = load i64, ptr %93, align 8
  %348 = icmp sgt i64 %347, 0
  br i1 %348, label %349, label %350

349:                                              ; preds = %344
  call fastcc void @sample(ptr noundef nonnull %9) #11
  br label %350

350:                                              ; preds = %344, %349
  %351 = load ptr, ptr %9, align 8
  %352 = load i64, ptr %351, align 8
  %353 = load ptr, ptr %92, align 8
  %354 = load ptr, ptr %94, align 8
  %355 = load ptr, ptr %95, align 8
  %356 = inttoptr i64 %352 to ptr
  %357 = call i32 %356(ptr noundef %353, ptr noundef %345, ptr noundef %354, ptr noundef %355, ptr noundef %60) #12
  %358 = zext i32 %357 to i64
  %359 = or i64 %325, %358
  br label %360

360:                                              ; preds = %350, %324
  %361 = phi i64 [ %359, %350 ], [ %325, %324 ]
  br i1 %34, label %365, label %362

362:                                              ; preds = %360
  br i1 %96, label %363, label %538

363:                                              ; preds = %362
  %364 = load ptr, ptr %97, align 8
  br label %528

365:                                              ; preds = %360
  %366 = load ptr, ptr %9, align 8
  %367 = load ptr, ptr %0, align 8
  %368 = getelementptr inbounds i8, ptr %366, i64 24
  %369 = load i64, ptr %368, align 8
  %370 = getelementptr inbounds i8, ptr %367, i64 8
  %371 = load i64, ptr %370, align 8
  %372 = load ptr, ptr %98, align 8
  %373 = load i64, ptr %99, align 8
  %374 = getelementptr inbounds double, ptr %372, i64 %373
  %375 = icmp sgt i64 %371, 0
  br i1 %375, label %376, label %378

376:                                              ; preds = %365
  %377 = getelementptr inbounds i8, ptr %366, i64 32
  br label %386

378:                                              ; preds = %386, %365
  %379 = icmp sgt i64 %369, 0
  br i1 %379, label %380, label %412

380:                                              ; preds = %378
  %381 = load ptr, ptr %11, align 8
  %382 = load ptr, ptr %86, align 8
  %383 = load ptr, ptr %101, align 8
  %384 = load ptr, ptr %102, align 8
  %385 = load ptr, ptr %98, align 8
  br label %475

386:                                              ; preds = %376, %386
  %387 = phi i64 [ 0, %376 ], [ %410, %386 ]
  %388 = load i64, ptr %367, align 8
  %389 = load i64, ptr %377, align 8
  %390 = load ptr, ptr %98, align 8
  %391 = load i64, ptr %99, align 8
  %392 = mul nsw i64 %391, %387
  %393 = getelementptr inbounds double, ptr %390, i64 %392
  %394 = load ptr, ptr %100, align 8
  %395 = load ptr, ptr %87, align 8
  %396 = getelementptr i64, ptr %395, i64 %388
  %397 = getelementptr i8, ptr %396, i64 8
  %398 = getelementptr i64, ptr %397, i64 %387
  %399 = load i64, ptr %398, align 8
  %400 = getelementptr i8, ptr %398, i64 8
  %401 = load i64, ptr %400, align 8
  %402 = xor i64 %399, -1
  %403 = add i64 %401, %402
  %404 = load ptr, ptr %74, align 8
  %405 = load ptr, ptr %88, align 8
  %406 = load ptr, ptr %89, align 8
  %407 = getelementptr inbounds i64, ptr %406, i64 %399
  %408 = load ptr, ptr %90, align 8
  %409 = getelementptr inbounds double, ptr %408, i64 %399
  call fastcc void @combine(ptr noundef %393, ptr noundef %394, ptr noundef %404, ptr noundef %405, ptr noundef %407, ptr noundef %409, i64 noundef %403, i64 noundef %389) #11
  %410 = add nuw nsw i64 %387, 1
  %411 = icmp eq i64 %410, %371
  br i1 %411, label %378, label %386, !llvm.loop !9

412:                                              ; preds = %475, %378
  %413 = phi <8 x double> [ zeroinitializer, %378 ], [ %508, %475 ]
  %414 = phi <8 x double> [ zeroinitializer, %378 ], [ %506, %475 ]
  %415 = load ptr, ptr %86, align 8
  %416 = getelementptr inbounds i8, ptr %366, i64 8
  %417 = load i64, ptr %416, align 8
  %418 = add nsw i64 %417, -3
  %419 = getelementptr i8, ptr %415, i64 64
  %420 = getelementptr i8, ptr %415, i64 128
  %421 = getelementptr i8, ptr %415, i64 192
  %422 = icmp slt i64 %369, %418
  br i1 %422, label %430, label %423

423:                                              ; preds = %430, %412
  %424 = phi <8 x double> [ zeroinitializer, %412 ], [ %440, %430 ]
  %425 = phi <8 x double> [ zeroinitializer, %412 ], [ %445, %430 ]
  %426 = phi <8 x double> [ zeroinitializer, %412 ], [ %450, %430 ]
  %427 = phi <8 x double> [ zeroinitializer, %412 ], [ %455, %430 ]
  %428 = phi i64 [ %369, %412 ], [ %456, %430 ]
  %429 = icmp slt i64 %428, %417
  br i1 %429, label %458, label %468

430:                                              ; preds = %412, %430
  %431 = phi i64 [ %456, %430 ], [ %369, %412 ]
  %432 = phi <8 x double> [ %455, %430 ], [ zeroinitializer, %412 ]
  %433 = phi <8 x double> [ %450, %430 ], [ zeroinitializer, %412 ]
  %434 = phi <8 x double> [ %445, %430 ], [ zeroinitializer, %412 ]
  %435 = phi <8 x double> [ %440, %430 ], [ zeroinitializer, %412 ]
  %436 = shl nsw i64 %431, 6
  %437 = getelementptr inbounds i8, ptr %415, i64 %436
  %438 = load <8 x double>, ptr %437, align 8
  %439 = fmul <8 x double> %438, zeroinitializer
  %440 = fadd <8 x double> %435, %439
  %441 = shl i64 %431, 6
  %442 = getelementptr i8, ptr %419, i64 %441
  %443 = load <8 x double>, ptr %442, align 8
  %444 = fmul <8 x double> %443, zeroinitializer
  %445 = fadd <8 x double> %434, %444
  %446 = shl i64 %431, 6
  %447 = getelementptr i8, ptr %420, i64 %446
  %448 = load <8 x double>, ptr %447, align 8
  %449 = fmul <8 x double> %448, zeroinitializer
  %450 = fadd <8 x double> %433, %449
  %451 = shl i64 %431, 6
  %452 = getelementptr i8, ptr %421, i64 %451
  %453 = load <8 x double>, ptr %452, align 8
  %454 = fmul <8 x double> %453, zeroinitializer
  %455 = fadd <8 x double> %432, %454
  %456 = add nsw i64 %431, 4
  %457 = icmp slt i64 %456, %418
  br i1 %457, label %430, label %423, !llvm.loop !10

458:                                              ; preds = %423, %458
  %459 = phi i64 [ %466, %458 ], [ %428, %423 ]
  %460 = phi <8 x double> [ %465, %458 ], [ %424, %423 ]
  %461 = shl nsw i64 %459, 6
  %462 = getelementptr inbounds i8, ptr %415, i64 %461
  %463 = load <8 x double>, ptr %462, align 8
  %464 = fmul <8 x double> %463, zeroinitializer
  %465 = fadd <8 x double> %460, %464
  %466 = add nsw i64 %459, 1
  %467 = icmp eq i64 %466, %417
  br i1 %467, label %468, label %458, !llvm.loop !11

468:                                              ; preds = %458, %423
  %469 = phi <8 x double> [ %424, %423 ], [ %465, %458 ]
  %470 = fadd <8 x double> %425, %469
  %471 = fadd <8 x double> %426, %427
  %472 = fadd <8 x double> %471, %470
  %473 = fadd <8 x double> %414, %472
  %474 = icmp eq i64 %371, 2
  br i1 %474, label %511, label %522

475:                                              ; preds = %380, %475
  %476 = phi <8 x double> [ zeroinitializer, %380 ], [ %506, %475 ]
  %477 = phi <8 x double> [ zeroinitializer, %380 ], [ %508, %475 ]
  %478 = phi i64 [ 0, %380 ], [ %509, %475 ]
  %479 = shl nsw i64 %478, 6
  %480 = getelementptr inbounds i8, ptr %381, i64 %479
  %481 = load <8 x double>, ptr %480, align 8
  %482 = getelementptr inbounds i8, ptr %382, i64 %479
  %483 = load <8 x double>, ptr %482, align 8
  %484 = getelementptr inbounds double, ptr %383, i64 %478
  %485 = load double, ptr %484, align 8
  %486 = insertelement <8 x double> poison, double %485, i64 0
  %487 = shufflevector <8 x double> %486, <8 x double> poison, <8 x i32> zeroinitializer
  %488 = getelementptr inbounds double, ptr %384, i64 %478
  %489 = load double, ptr %488, align 8
  %490 = insertelement <8 x double> poison, double %489, i64 0
  %491 = shufflevector <8 x double> %490, <8 x double> poison, <8 x i32> zeroinitializer
  %492 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %481)
  %493 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %483)
  %494 = fcmp ogt <8 x double> %492, %493
  %495 = select <8 x i1> %494, <8 x double> %492, <8 x double> %493
  %496 = fmul <8 x double> %495, %491
  %497 = fadd <8 x double> %487, %496
  %498 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %497
  %499 = getelementptr inbounds i8, ptr %385, i64 %479
  %500 = load <8 x double>, ptr %499, align 8
  %501 = fmul <8 x double> %500, %498
  %502 = getelementptr inbounds i8, ptr %374, i64 %479
  %503 = load <8 x double>, ptr %502, align 8
  %504 = fmul <8 x double> %503, %498
  %505 = fmul <8 x double> %501, %501
  %506 = fadd <8 x double> %476, %505
  %507 = fmul <8 x double> %504, %504
  %508 = fadd <8 x double> %477, %507
  %509 = add nuw nsw i64 %478, 1
  %510 = icmp eq i64 %509, %369
  br i1 %510, label %412, label %475, !llvm.loop !12

511:                                              ; preds = %468
  %512 = fmul <8 x double> %413, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %513 = fadd <8 x double> %512, %473
  %514 = sitofp i64 %369 to double
  %515 = insertelement <8 x double> poison, double %514, i64 0
  %516 = shufflevector <8 x double> %515, <8 x double> poison, <8 x i32> zeroinitializer
  %517 = fmul <8 x double> %516, %513
  %518 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %517)
  %519 = fdiv <8 x double> %473, %518
  %520 = fcmp oeq <8 x double> %473, zeroinitializer
  %521 = select <8 x i1> %520, <8 x double> zeroinitializer, <8 x double> %519
  br label %538

522:                                              ; preds = %468
  %523 = sitofp i64 %369 to double
  %524 = insertelement <8 x double> poison, double %523, i64 0
  %525 = shufflevector <8 x double> %524, <8 x double> poison, <8 x i32> zeroinitializer
  %526 = fdiv <8 x double> %473, %525
  %527 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %526)
  br label %538

528:                                              ; preds = %363, %528
  %529 = phi <8 x double> [ zeroinitializer, %363 ], [ %535, %528 ]
  %530 = phi i64 [ 0, %363 ], [ %536, %528 ]
  %531 = shl nsw i64 %530, 6
  %532 = getelementptr inbounds i8, ptr %364, i64 %531
  %533 = load <8 x double>, ptr %532, align 8
  %534 = fmul <8 x double> %533, zeroinitializer
  %535 = fadd <8 x double> %529, %534
  %536 = add nuw nsw i64 %530, 1
  %537 = icmp eq i64 %536, %15
  br i1 %537, label %538, label %528, !llvm.loop !13

538:                                              ; preds = %528, %362, %522, %511
  %539 = phi <8 x double> [ %521, %511 ], [ %527, %522 ], [ zeroinitializer, %362 ], [ %535, %528 ]
  %540 = fcmp uge <8 x double> %539, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %541 = trunc i64 %361 to i8
  %542 = bitcast i8 %541 to <8 x i1>
  %543 = select <8 x i1> %542, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %540
  %544 = xor <8 x i1> %543, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %545 = select <8 x i1> %544, <8 x i1> %220, <8 x i1> zeroinitializer
  %546 = sext <8 x i1> %545 to <8 x i64>
  br i1 %40, label %547, label %559

547:                                              ; preds = %538
  %548 = xor <8 x i1> %543, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %549 = select <8 x i1> %548, <8 x i1> %220, <8 x i1> zeroinitializer
  %550 = bitcast <8 x i1> %549 to i8
  %551 = icmp eq i8 %550, 0
  br i1 %551, label %559, label %552

552:                                              ; preds = %547
  %553 = zext i8 %550 to i64
  store <8 x double> %245, ptr %3, align 16
  %554 = load ptr, ptr %103, align 8
  %555 = call fastcc i64 @hold_lanes(ptr noundef nonnull %0, ptr noundef nonnull %3, ptr noundef %554, i64 noundef %553, i32 noundef %56) #11
  %556 = trunc i64 %555 to i8
  %557 = bitcast i8 %556 to <8 x i1>
  %558 = select <8 x i1> %557, <8 x i64> zeroinitializer, <8 x i64> %546
  br label %559

559:                                              ; preds = %552, %547, %538
  %560 = phi <8 x i64> [ %558, %552 ], [ %546, %547 ], [ %546, %538 ]
  %561 = phi i64 [ %555, %552 ], [ 0, %547 ], [ 0, %538 ]
  %562 = icmp ne <8 x i64> %560, zeroinitializer
  %563 = bitcast <8 x i1> %562 to i8
  %564 = icmp ne i8 %563, 0
  %565 = select i1 %58, i1 %564, i1 false
  br i1 %565, label %566, label %585

566:                                              ; preds = %559
  %567 = load ptr, ptr %104, align 8
  %568 = load ptr, ptr %105, align 8
  store <8 x double> %245, ptr %568, align 8
  %569 = load i64, ptr %106, align 8
  %570 = icmp sgt i64 %569, 0
  br i1 %570, label %571, label %572

571:                                              ; preds = %566
  call fastcc void @sample(ptr noundef nonnull %9) #11
  br label %572

572:                                              ; preds = %566, %571
  %573 = load ptr, ptr %9, align 8
  %574 = load i64, ptr %573, align 8
  %575 = load ptr, ptr %105, align 8
  %576 = load ptr, ptr %107, align 8
  %577 = load ptr, ptr %108, align 8
  %578 = inttoptr i64 %574 to ptr
  %579 = call i32 %578(ptr noundef %575, ptr noundef %567, ptr noundef %576, ptr noundef %577, ptr noundef %60) #12
  %580 = zext i32 %579 to i64
  %581 = or i64 %361, %580
  %582 = trunc i64 %581 to i8
  %583 = bitcast i8 %582 to <8 x i1>
  %584 = select <8 x i1> %583, <8 x i64> zeroinitializer, <8 x i64> %560
  br label %585

585:                                              ; preds = %572, %559
  %586 = phi <8 x i64> [ %584, %572 ], [ %560, %559 ]
  %587 = phi i64 [ %581, %572 ], [ %361, %559 ]
  %588 = load ptr, ptr %109, align 8
  %589 = load <8 x double>, ptr %588, align 8
  %590 = load i64, ptr %16, align 8
  %591 = add i64 %590, %110
  %592 = sitofp i64 %591 to double
  %593 = insertelement <8 x double> poison, double %592, i64 0
  %594 = shufflevector <8 x double> %593, <8 x double> poison, <8 x i32> zeroinitializer
  %595 = icmp slt <8 x i64> %560, zeroinitializer
  %596 = select <8 x i1> %595, <8 x i64> %114, <8 x i64> zeroinitializer
  %597 = bitcast <8 x i64> %596 to <8 x double>
  %598 = fadd <8 x double> %594, %597
  %599 = fadd <8 x double> %589, %598
  store <8 x double> %599, ptr %588, align 8
  br i1 %59, label %600, label %609

600:                                              ; preds = %585
  %601 = icmp ne <8 x i64> %586, zeroinitializer
  %602 = bitcast <8 x i1> %601 to i8
  %603 = icmp eq i8 %602, 0
  br i1 %603, label %609, label %604

604:                                              ; preds = %600
  %605 = zext i8 %602 to i64
  %606 = call fastcc i64 @clear_lanes(ptr noundef %0) #11
  %607 = xor i64 %606, -1
  %608 = and i64 %607, %605
  br label %609

609:                                              ; preds = %585, %600, %604
  %610 = phi i64 [ %608, %604 ], [ 0, %600 ], [ 0, %585 ]
  store i64 0, ptr %7, align 8
  %611 = load ptr, ptr %115, align 8
  %612 = load <8 x double>, ptr %611, align 8
  %613 = fcmp olt <8 x double> %612, %245
  %614 = icmp ne <8 x i64> %586, zeroinitializer
  %615 = select <8 x i1> %613, <8 x i1> %614, <8 x i1> zeroinitializer
  %616 = bitcast <8 x i1> %615 to i8
  %617 = zext i8 %616 to i64
  %618 = or i64 %610, %617
  %619 = icmp eq i64 %618, 0
  br i1 %619, label %798, label %620

620:                                              ; preds = %609
  %621 = load ptr, ptr %0, align 8
  %622 = load ptr, ptr %9, align 8
  %623 = getelementptr inbounds i8, ptr %622, i64 16
  %624 = load i64, ptr %623, align 8
  %625 = load i64, ptr %621, align 8
  %626 = load i64, ptr %116, align 8
  %627 = load ptr, ptr %88, align 8
  %628 = mul nsw i64 %626, %625
  %629 = getelementptr inbounds double, ptr %627, i64 %628
  %630 = load ptr, ptr %117, align 8
  %631 = add nsw i64 %625, 1
  %632 = getelementptr inbounds i8, ptr %621, i64 16
  %633 = load i64, ptr %632, align 8
  %634 = icmp sgt i64 %633, 0
  br i1 %634, label %635, label %637

635:                                              ; preds = %620
  %636 = getelementptr inbounds i8, ptr %621, i64 8
  br label %648

637:                                              ; preds = %683, %620
  %638 = phi i64 [ 0, %620 ], [ %692, %683 ]
  %639 = getelementptr inbounds i8, ptr %621, i64 16
  %640 = load ptr, ptr %9, align 8
  %641 = getelementptr inbounds i8, ptr %640, i64 8
  %642 = load i64, ptr %641, align 8
  %643 = icmp sgt i64 %642, 0
  br i1 %643, label %644, label %697

644:                                              ; preds = %637
  %645 = getelementptr inbounds double, ptr %630, i64 %626
  %646 = shl nsw i64 %626, 4
  %647 = getelementptr inbounds i8, ptr %630, i64 %646
  br label %704

648:                                              ; preds = %635, %683
  %649 = phi i64 [ 0, %635 ], [ %692, %683 ]
  %650 = phi i64 [ %631, %635 ], [ %693, %683 ]
  %651 = load i64, ptr %636, align 8
  %652 = load ptr, ptr %118, align 8
  %653 = load ptr, ptr %11, align 8
  %654 = load ptr, ptr %87, align 8
  %655 = getelementptr i64, ptr %654, i64 %650
  %656 = getelementptr i64, ptr %655, i64 %651
  %657 = load i64, ptr %656, align 8
  %658 = getelementptr i8, ptr %656, i64 8
  %659 = load i64, ptr %658, align 8
  %660 = xor i64 %657, -1
  %661 = add i64 %659, %660
  %662 = load ptr, ptr %74, align 8
  %663 = load ptr, ptr %88, align 8
  %664 = load ptr, ptr %89, align 8
  %665 = getelementptr inbounds i64, ptr %664, i64 %657
  %666 = load ptr, ptr %90, align 8
  %667 = getelementptr inbounds double, ptr %666, i64 %657
  call fastcc void @combine(ptr noundef %652, ptr noundef %653, ptr noundef %662, ptr noundef %663, ptr noundef %665, ptr noundef %667, i64 noundef %661, i64 noundef %624) #11
  %668 = load ptr, ptr %88, align 8
  %669 = mul nsw i64 %650, %626
  %670 = getelementptr inbounds double, ptr %668, i64 %669
  %671 = load ptr, ptr %119, align 8
  %672 = getelementptr inbounds double, ptr %671, i64 %650
  %673 = load double, ptr %672, align 8
  %674 = insertelement <8 x double> poison, double %673, i64 0
  %675 = shufflevector <8 x double> %674, <8 x double> poison, <8 x i32> zeroinitializer
  %676 = fmul <8 x double> %247, %675
  %677 = fadd <8 x double> %222, %676
  %678 = load ptr, ptr %118, align 8
  %679 = load ptr, ptr %120, align 8
  store <8 x double> %677, ptr %679, align 8
  %680 = load i64, ptr %121, align 8
  %681 = icmp sgt i64 %680, 0
  br i1 %681, label %682, label %683

682:                                              ; preds = %648
  call fastcc void @sample(ptr noundef nonnull %9) #11
  br label %683

683:                                              ; preds = %648, %682
  %684 = load ptr, ptr %9, align 8
  %685 = load i64, ptr %684, align 8
  %686 = load ptr, ptr %120, align 8
  %687 = load ptr, ptr %122, align 8
  %688 = load ptr, ptr %123, align 8
  %689 = inttoptr i64 %685 to ptr
  %690 = call i32 %689(ptr noundef %686, ptr noundef %678, ptr noundef %687, ptr noundef %688, ptr noundef %670) #12
  %691 = sext i32 %690 to i64
  %692 = or i64 %649, %691
  %693 = add nsw i64 %650, 1
  %694 = load i64, ptr %632, align 8
  %695 = add nsw i64 %694, %631
  %696 = icmp slt i64 %693, %695
  br i1 %696, label %648, label %637, !llvm.loop !14

697:                                              ; preds = %704, %637
  %698 = getelementptr inbounds i8, ptr %621, i64 8
  %699 = load i64, ptr %698, align 8
  %700 = load i64, ptr %639, align 8
  %701 = getelementptr inbounds i8, ptr %621, i64 24
  %702 = load i64, ptr %701, align 8
  %703 = icmp sgt i64 %702, 3
  br i1 %703, label %732, label %757

704:                                              ; preds = %644, %704
  %705 = phi i64 [ 0, %644 ], [ %727, %704 ]
  %706 = load ptr, ptr %86, align 8
  %707 = shl nsw i64 %705, 6
  %708 = getelementptr inbounds i8, ptr %706, i64 %707
  %709 = load <8 x double>, ptr %708, align 8
  %710 = load ptr, ptr %11, align 8
  %711 = getelementptr inbounds i8, ptr %710, i64 %707
  %712 = load <8 x double>, ptr %711, align 8
  %713 = fsub <8 x double> %709, %712
  %714 = load ptr, ptr %88, align 8
  %715 = getelementptr inbounds i8, ptr %714, i64 %707
  %716 = load <8 x double>, ptr %715, align 8
  %717 = fmul <8 x double> %247, %716
  %718 = fsub <8 x double> %717, %713
  %719 = getelementptr inbounds i8, ptr %630, i64 %707
  store <8 x double> %713, ptr %719, align 8
  %720 = getelementptr inbounds i8, ptr %645, i64 %707
  store <8 x double> %718, ptr %720, align 8
  %721 = fsub <8 x double> %713, %718
  %722 = getelementptr inbounds i8, ptr %629, i64 %707
  %723 = load <8 x double>, ptr %722, align 8
  %724 = fmul <8 x double> %247, %723
  %725 = fsub <8 x double> %721, %724
  %726 = getelementptr inbounds i8, ptr %647, i64 %707
  store <8 x double> %725, ptr %726, align 8
  %727 = add nuw nsw i64 %705, 1
  %728 = load ptr, ptr %9, align 8
  %729 = getelementptr inbounds i8, ptr %728, i64 8
  %730 = load i64, ptr %729, align 8
  %731 = icmp slt i64 %727, %730
  br i1 %731, label %704, label %697, !llvm.loop !15

732:                                              ; preds = %697, %732
  %733 = phi i64 [ %754, %732 ], [ 3, %697 ]
  %734 = mul nsw i64 %733, %626
  %735 = getelementptr inbounds double, ptr %630, i64 %734
  %736 = load ptr, ptr %124, align 8
  %737 = load ptr, ptr %87, align 8
  %738 = getelementptr i64, ptr %737, i64 %631
  %739 = getelementptr i64, ptr %738, i64 %699
  %740 = getelementptr i64, ptr %739, i64 %700
  %741 = getelementptr i64, ptr %740, i64 %733
  %742 = getelementptr i8, ptr %741, i64 -24
  %743 = load i64, ptr %742, align 8
  %744 = getelementptr i8, ptr %741, i64 -16
  %745 = load i64, ptr %744, align 8
  %746 = xor i64 %743, -1
  %747 = add i64 %745, %746
  %748 = load ptr, ptr %74, align 8
  %749 = load ptr, ptr %88, align 8
  %750 = load ptr, ptr %89, align 8
  %751 = getelementptr inbounds i64, ptr %750, i64 %743
  %752 = load ptr, ptr %90, align 8
  %753 = getelementptr inbounds double, ptr %752, i64 %743
  call fastcc void @combine(ptr noundef %735, ptr noundef %736, ptr noundef %748, ptr noundef %749, ptr noundef %751, ptr noundef %753, i64 noundef %747, i64 noundef %624) #11
  %754 = add nuw nsw i64 %733, 1
  %755 = load i64, ptr %701, align 8
  %756 = icmp slt i64 %754, %755
  br i1 %756, label %732, label %757, !llvm.loop !16

757:                                              ; preds = %732, %697
  %758 = and i64 %638, %618
  %759 = load ptr, ptr %109, align 8
  %760 = load <8 x double>, ptr %759, align 8
  %761 = trunc nuw i64 %618 to i8
  %762 = bitcast i8 %761 to <8 x i1>
  %763 = load i64, ptr %125, align 8
  %764 = sitofp i64 %763 to double
  %765 = insertelement <8 x double> poison, double %764, i64 0
  %766 = shufflevector <8 x double> %765, <8 x double> poison, <8 x i32> zeroinitializer
  %767 = select <8 x i1> %762, <8 x double> %766, <8 x double> zeroinitializer
  %768 = fadd <8 x double> %760, %767
  store <8 x double> %768, ptr %759, align 8
  %769 = icmp eq i64 %758, 0
  br i1 %769, label %774, label %770

770:                                              ; preds = %757
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %758, i64 noundef 3) #11
  %771 = xor i64 %758, -1
  %772 = and i64 %218, %771
  store i64 %772, ptr %5, align 8
  %773 = and i64 %610, %771
  br label %774

774:                                              ; preds = %770, %757
  %775 = phi i64 [ %773, %770 ], [ %610, %757 ]
  %776 = phi i32 [ 1, %770 ], [ %189, %757 ]
  store <8 x double> %245, ptr %3, align 16
  %777 = icmp eq i64 %775, 0
  br i1 %777, label %780, label %778

778:                                              ; preds = %774
  %779 = call fastcc i64 @look_for_events(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %775, ptr noundef nonnull %3, ptr noundef nonnull %6, ptr noundef nonnull %4, ptr noundef nonnull %7) #11
  br label %780

780:                                              ; preds = %778, %774
  %781 = phi i64 [ %779, %778 ], [ 0, %774 ]
  %782 = load i64, ptr %7, align 8
  %783 = or i64 %782, %638
  %784 = xor i64 %783, -1
  %785 = and i64 %618, %784
  %786 = icmp eq i64 %781, 0
  %787 = select i1 %786, ptr null, ptr %4
  %788 = call fastcc i64 @write_within(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %785, ptr noundef nonnull %3, ptr noundef %787) #11
  %789 = or i64 %788, %561
  %790 = or i64 %782, %758
  %791 = or i64 %790, %789
  %792 = trunc i64 %791 to i8
  %793 = xor i8 %792, -1
  %794 = bitcast i8 %793 to <8 x i1>
  %795 = select <8 x i1> %794, <8 x i64> %586, <8 x i64> zeroinitializer
  %796 = load <8 x double>, ptr %3, align 16
  br i1 %786, label %798, label %797

797:                                              ; preds = %780
  call fastcc void @end_within(ptr noundef nonnull %2, i64 noundef %781, ptr noundef nonnull %4) #11
  br label %798

798:                                              ; preds = %780, %797, %609
  %799 = phi <8 x double> [ %245, %609 ], [ %796, %780 ], [ %796, %797 ]
  %800 = phi <8 x i64> [ %586, %609 ], [ %795, %780 ], [ %795, %797 ]
  %801 = phi i64 [ %561, %609 ], [ %789, %780 ], [ %789, %797 ]
  %802 = phi i32 [ %189, %609 ], [ %776, %780 ], [ %776, %797 ]
  %803 = phi i64 [ 0, %609 ], [ %781, %780 ], [ %781, %797 ]
  %804 = load ptr, ptr %115, align 8
  %805 = load <8 x double>, ptr %804, align 8
  %806 = fcmp oeq <8 x double> %805, %799
  %807 = icmp ne <8 x i64> %800, zeroinitializer
  %808 = select <8 x i1> %806, <8 x i1> %807, <8 x i1> zeroinitializer
  %809 = bitcast <8 x i1> %808 to i8
  %810 = icmp eq i8 %809, 0
  br i1 %810, label %813, label %811

811:                                              ; preds = %798
  %812 = zext i8 %809 to i64
  br label %822

813:                                              ; preds = %822, %798
  %814 = xor <8 x i64> %800, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %815 = select <8 x i1> %220, <8 x i64> %814, <8 x i64> zeroinitializer
  %816 = load ptr, ptr %70, align 8
  %817 = load <8 x double>, ptr %816, align 8
  %818 = icmp slt <8 x i64> %800, zeroinitializer
  %819 = select <8 x i1> %818, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %820 = bitcast <8 x i64> %819 to <8 x double>
  %821 = fadd <8 x double> %817, %820
  store <8 x double> %821, ptr %816, align 8
  br i1 %34, label %832, label %956

822:                                              ; preds = %811, %822
  %823 = phi i64 [ %830, %822 ], [ %812, %811 ]
  %824 = load ptr, ptr %126, align 8
  call fastcc void @write_outputs(ptr noundef %0, ptr noundef %824, i64 noundef %823) #11
  %825 = load ptr, ptr %115, align 8
  %826 = load <8 x double>, ptr %825, align 8
  %827 = fcmp oeq <8 x double> %826, %799
  %828 = bitcast <8 x i1> %827 to i8
  %829 = zext i8 %828 to i64
  %830 = and i64 %823, %829
  %831 = icmp eq i64 %830, 0
  br i1 %831, label %813, label %822, !llvm.loop !17

832:                                              ; preds = %813
  %833 = load ptr, ptr %127, align 8
  %834 = load <8 x double>, ptr %833, align 8
  %835 = load ptr, ptr %128, align 8
  %836 = load <8 x double>, ptr %835, align 8
  %837 = fcmp ogt <8 x double> %539, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %838 = bitcast <8 x double> %539 to <8 x i64>
  %839 = select <8 x i1> %837, <8 x i64> %838, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %840 = load double, ptr %129, align 8
  %841 = insertelement <8 x double> poison, double %840, i64 0
  %842 = shufflevector <8 x double> %841, <8 x double> poison, <8 x i32> zeroinitializer
  %843 = load double, ptr %130, align 8
  %844 = fneg double %843
  %845 = add <8 x i64> %839, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %846 = ashr <8 x i64> %845, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %847 = and <8 x i64> %845, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %848 = sub <8 x i64> %839, %847
  %849 = bitcast <8 x i64> %848 to <8 x double>
  %850 = fadd <8 x double> %849, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %851 = fadd <8 x double> %849, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %852 = fdiv <8 x double> %850, %851
  %853 = fmul <8 x double> %852, %852
  %854 = call <8 x double> @llvm.fma.v8f64(<8 x double> %853, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %855 = call <8 x double> @llvm.fma.v8f64(<8 x double> %854, <8 x double> %853, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %856 = call <8 x double> @llvm.fma.v8f64(<8 x double> %855, <8 x double> %853, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %857 = call <8 x double> @llvm.fma.v8f64(<8 x double> %856, <8 x double> %853, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %858 = trunc nsw <8 x i64> %846 to <8 x i32>
  %859 = sitofp <8 x i32> %858 to <8 x double>
  %860 = fmul <8 x double> %852, %857
  %861 = fadd <8 x double> %860, %859
  %862 = insertelement <8 x double> poison, double %844, i64 0
  %863 = shufflevector <8 x double> %862, <8 x double> poison, <8 x i32> zeroinitializer
  %864 = fmul <8 x double> %861, %863
  %865 = fcmp ogt <8 x double> %864, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %866 = bitcast <8 x double> %864 to <8 x i64>
  %867 = select <8 x i1> %865, <8 x i64> %866, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %868 = bitcast <8 x i64> %867 to <8 x double>
  %869 = fcmp olt <8 x double> %868, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %870 = bitcast <8 x i64> %867 to <8 x double>
  %871 = select <8 x i1> %869, <8 x double> %870, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %872 = call <8 x double> @llvm.rint.v8f64(<8 x double> %871)
  %873 = fsub <8 x double> %871, %872
  %874 = call <8 x double> @llvm.fma.v8f64(<8 x double> %873, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %875 = call <8 x double> @llvm.fma.v8f64(<8 x double> %874, <8 x double> %873, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %876 = call <8 x double> @llvm.fma.v8f64(<8 x double> %875, <8 x double> %873, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %877 = call <8 x double> @llvm.fma.v8f64(<8 x double> %876, <8 x double> %873, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %878 = call <8 x double> @llvm.fma.v8f64(<8 x double> %877, <8 x double> %873, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %879 = call <8 x double> @llvm.fma.v8f64(<8 x double> %878, <8 x double> %873, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %880 = call <8 x double> @llvm.fma.v8f64(<8 x double> %879, <8 x double> %873, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %881 = bitcast <8 x double> %880 to <8 x i64>
  %882 = fptosi <8 x double> %872 to <8 x i32>
  %883 = zext <8 x i32> %882 to <8 x i64>
  %884 = shl <8 x i64> %883, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %885 = add <8 x i64> %884, %881
  %886 = bitcast <8 x i64> %885 to <8 x double>
  %887 = fmul <8 x double> %842, %886
  %888 = load double, ptr %131, align 8
  %889 = fcmp une double %888, 0.000000e+00
  br i1 %889, label %890, label %935

890:                                              ; preds = %832
  %891 = bitcast <8 x double> %834 to <8 x i64>
  %892 = add <8 x i64> %891, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %893 = ashr <8 x i64> %892, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %894 = and <8 x i64> %892, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %895 = sub <8 x i64> %891, %894
  %896 = bitcast <8 x i64> %895 to <8 x double>
  %897 = fadd <8 x double> %896, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %898 = fadd <8 x double> %896, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %899 = fdiv <8 x double> %897, %898
  %900 = fmul <8 x double> %899, %899
  %901 = call <8 x double> @llvm.fma.v8f64(<8 x double> %900, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %902 = call <8 x double> @llvm.fma.v8f64(<8 x double> %901, <8 x double> %900, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %903 = call <8 x double> @llvm.fma.v8f64(<8 x double> %902, <8 x double> %900, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %904 = call <8 x double> @llvm.fma.v8f64(<8 x double> %903, <8 x double> %900, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %905 = trunc nsw <8 x i64> %893 to <8 x i32>
  %906 = sitofp <8 x i32> %905 to <8 x double>
  %907 = fmul <8 x double> %899, %904
  %908 = fadd <8 x double> %907, %906
  %909 = insertelement <8 x double> poison, double %888, i64 0
  %910 = shufflevector <8 x double> %909, <8 x double> poison, <8 x i32> zeroinitializer
  %911 = fmul <8 x double> %910, %908
  %912 = fcmp ogt <8 x double> %911, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %913 = bitcast <8 x double> %911 to <8 x i64>
  %914 = select <8 x i1> %912, <8 x i64> %913, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %915 = bitcast <8 x i64> %914 to <8 x double>
  %916 = fcmp olt <8 x double> %915, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %917 = bitcast <8 x i64> %914 to <8 x double>
  %918 = select <8 x i1> %916, <8 x double> %917, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %919 = call <8 x double> @llvm.rint.v8f64(<8 x double> %918)
  %920 = fsub <8 x double> %918, %919
  %921 = call <8 x double> @llvm.fma.v8f64(<8 x double> %920, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %922 = call <8 x double> @llvm.fma.v8f64(<8 x double> %921, <8 x double> %920, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %923 = call <8 x double> @llvm.fma.v8f64(<8 x double> %922, <8 x double> %920, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %924 = call <8 x double> @llvm.fma.v8f64(<8 x double> %923, <8 x double> %920, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %925 = call <8 x double> @llvm.fma.v8f64(<8 x double> %924, <8 x double> %920, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %926 = call <8 x double> @llvm.fma.v8f64(<8 x double> %925, <8 x double> %920, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %927 = call <8 x double> @llvm.fma.v8f64(<8 x double> %926, <8 x double> %920, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %928 = bitcast <8 x double> %927 to <8 x i64>
  %929 = fptosi <8 x double> %919 to <8 x i32>
  %930 = zext <8 x i32> %929 to <8 x i64>
  %931 = shl <8 x i64> %930, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %932 = add <8 x i64> %931, %928
  %933 = bitcast <8 x i64> %932 to <8 x double>
  %934 = fmul <8 x double> %887, %933
  br label %935

935:                                              ; preds = %832, %890
  %936 = phi <8 x double> [ %934, %890 ], [ %887, %832 ]
  %937 = load double, ptr %132, align 8
  %938 = insertelement <8 x double> poison, double %937, i64 0
  %939 = shufflevector <8 x double> %938, <8 x double> poison, <8 x i32> zeroinitializer
  %940 = fcmp ogt <8 x double> %936, %939
  %941 = select <8 x i1> %940, <8 x double> %936, <8 x double> %939
  %942 = fcmp olt <8 x double> %836, %941
  %943 = select <8 x i1> %942, <8 x double> %836, <8 x double> %941
  %944 = fmul <8 x double> %247, %943
  %945 = fcmp ogt <8 x double> %539, <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>
  %946 = select <8 x i1> %945, <8 x i64> %838, <8 x i64> <i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789>
  %947 = bitcast <8 x double> %834 to <8 x i64>
  %948 = select <8 x i1> %818, <8 x i64> %946, <8 x i64> %947
  store <8 x i64> %948, ptr %833, align 8
  %949 = load ptr, ptr %128, align 8
  %950 = load double, ptr %133, align 8
  %951 = insertelement <8 x double> poison, double %950, i64 0
  %952 = bitcast <8 x double> %951 to <8 x i64>
  %953 = shufflevector <8 x i64> %952, <8 x i64> poison, <8 x i32> zeroinitializer
  %954 = icmp slt <8 x i64> %815, zeroinitializer
  %955 = select <8 x i1> %954, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> %953
  store <8 x i64> %955, ptr %949, align 8
  br label %956

956:                                              ; preds = %935, %813
  %957 = phi <8 x double> [ %944, %935 ], [ %229, %813 ]
  %958 = icmp ne <8 x i64> %815, zeroinitializer
  %959 = bitcast <8 x i1> %958 to i8
  %960 = icmp eq i8 %959, 0
  br i1 %960, label %1054, label %961

961:                                              ; preds = %956
  %962 = trunc i64 %587 to i8
  %963 = bitcast i8 %962 to <8 x i1>
  %964 = trunc i64 %801 to i8
  %965 = bitcast i8 %964 to <8 x i1>
  %966 = load i64, ptr %7, align 8
  %967 = trunc i64 %966 to i8
  %968 = bitcast i8 %967 to <8 x i1>
  %969 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %539)
  %970 = fcmp one <8 x double> %969, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %971 = xor <8 x i1> %963, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %972 = select <8 x i1> %970, <8 x i1> %971, <8 x i1> zeroinitializer
  %973 = or <8 x i1> %968, %965
  %974 = xor <8 x i1> %973, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %975 = and <8 x i1> %972, %974
  br i1 %34, label %976, label %1035

976:                                              ; preds = %961
  %977 = fcmp ogt <8 x double> %539, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %978 = bitcast <8 x double> %539 to <8 x i64>
  %979 = select <8 x i1> %977, <8 x i64> %978, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %980 = load double, ptr %134, align 8
  %981 = insertelement <8 x double> poison, double %980, i64 0
  %982 = shufflevector <8 x double> %981, <8 x double> poison, <8 x i32> zeroinitializer
  %983 = load double, ptr %31, align 8
  %984 = fneg double %983
  %985 = add <8 x i64> %979, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %986 = ashr <8 x i64> %985, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %987 = and <8 x i64> %985, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %988 = sub <8 x i64> %979, %987
  %989 = bitcast <8 x i64> %988 to <8 x double>
  %990 = fadd <8 x double> %989, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %991 = fadd <8 x double> %989, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %992 = fdiv <8 x double> %990, %991
  %993 = fmul <8 x double> %992, %992
  %994 = call <8 x double> @llvm.fma.v8f64(<8 x double> %993, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %995 = call <8 x double> @llvm.fma.v8f64(<8 x double> %994, <8 x double> %993, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %996 = call <8 x double> @llvm.fma.v8f64(<8 x double> %995, <8 x double> %993, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %997 = call <8 x double> @llvm.fma.v8f64(<8 x double> %996, <8 x double> %993, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %998 = trunc nsw <8 x i64> %986 to <8 x i32>
  %999 = sitofp <8 x i32> %998 to <8 x double>
  %1000 = fmul <8 x double> %992, %997
  %1001 = fadd <8 x double> %1000, %999
  %1002 = insertelement <8 x double> poison, double %984, i64 0
  %1003 = shufflevector <8 x double> %1002, <8 x double> poison, <8 x i32> zeroinitializer
  %1004 = fmul <8 x double> %1001, %1003
  %1005 = fcmp ogt <8 x double> %1004, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1006 = bitcast <8 x double> %1004 to <8 x i64>
  %1007 = select <8 x i1> %1005, <8 x i64> %1006, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1008 = bitcast <8 x i64> %1007 to <8 x double>
  %1009 = fcmp olt <8 x double> %1008, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1010 = bitcast <8 x i64> %1007 to <8 x double>
  %1011 = select <8 x i1> %1009, <8 x double> %1010, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1012 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1011)
  %1013 = fsub <8 x double> %1011, %1012
  %1014 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1013, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1015 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1014, <8 x double> %1013, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1016 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1015, <8 x double> %1013, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1017 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1016, <8 x double> %1013, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1018 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1017, <8 x double> %1013, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1019 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1018, <8 x double> %1013, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1020 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1019, <8 x double> %1013, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1021 = bitcast <8 x double> %1020 to <8 x i64>
  %1022 = fptosi <8 x double> %1012 to <8 x i32>
  %1023 = zext <8 x i32> %1022 to <8 x i64>
  %1024 = shl <8 x i64> %1023, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1025 = add <8 x i64> %1024, %1021
  %1026 = bitcast <8 x i64> %1025 to <8 x double>
  %1027 = fmul <8 x double> %982, %1026
  %1028 = load double, ptr %135, align 8
  %1029 = insertelement <8 x double> poison, double %1028, i64 0
  %1030 = shufflevector <8 x double> %1029, <8 x double> poison, <8 x i32> zeroinitializer
  %1031 = fcmp ogt <8 x double> %1027, %1030
  %1032 = select <8 x i1> %1031, <8 x double> %1027, <8 x double> %1030
  %1033 = select <8 x i1> %975, <8 x double> %1032, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1034 = fmul <8 x double> %247, %1033
  br label %1035

1035:                                             ; preds = %961, %976
  %1036 = phi <8 x double> [ %1034, %976 ], [ zeroinitializer, %961 ]
  %1037 = or <8 x i1> %975, %968
  %1038 = select <8 x i1> %1037, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %1039 = icmp slt <8 x i64> %815, zeroinitializer
  %1040 = select <8 x i1> %1039, <8 x double> %1036, <8 x double> %957
  %1041 = load ptr, ptr %136, align 8
  %1042 = select <8 x i1> %965, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> %1038
  %1043 = load <8 x i64>, ptr %1041, align 8
  %1044 = select <8 x i1> %1039, <8 x i64> %1042, <8 x i64> %1043
  store <8 x i64> %1044, ptr %1041, align 8
  %1045 = load ptr, ptr %136, align 8
  %1046 = select <8 x i1> %963, <8 x i64> <i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152>, <8 x i64> %1038
  %1047 = load <8 x i64>, ptr %1045, align 8
  %1048 = select <8 x i1> %1039, <8 x i64> %1046, <8 x i64> %1047
  store <8 x i64> %1048, ptr %1045, align 8
  %1049 = load ptr, ptr %71, align 8
  %1050 = load <8 x double>, ptr %1049, align 8
  %1051 = select <8 x i1> %1039, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %1052 = bitcast <8 x i64> %1051 to <8 x double>
  %1053 = fadd <8 x double> %1050, %1052
  store <8 x double> %1053, ptr %1049, align 8
  br label %1054

1054:                                             ; preds = %1035, %956
  %1055 = phi <8 x double> [ %957, %956 ], [ %1040, %1035 ]
  %1056 = load ptr, ptr %67, align 8
  store <8 x double> %1055, ptr %1056, align 8
  %1057 = load ptr, ptr %54, align 8
  %1058 = select <8 x i1> %818, <8 x double> %799, <8 x double> %222
  store <8 x double> %1058, ptr %1057, align 8
  br i1 %137, label %1061, label %1059

1059:                                             ; preds = %1061, %1054
  %1060 = icmp eq i64 %803, 0
  br i1 %1060, label %1088, label %1079

1061:                                             ; preds = %1054, %1061
  %1062 = phi i64 [ %1077, %1061 ], [ 0, %1054 ]
  %1063 = load ptr, ptr %11, align 8
  %1064 = load ptr, ptr %138, align 8
  %1065 = shl nsw i64 %1062, 6
  %1066 = getelementptr inbounds i8, ptr %1064, i64 %1065
  %1067 = load <8 x i64>, ptr %1066, align 8
  %1068 = getelementptr inbounds i8, ptr %1063, i64 %1065
  %1069 = load <8 x i64>, ptr %1068, align 8
  %1070 = select <8 x i1> %818, <8 x i64> %1067, <8 x i64> %1069
  store <8 x i64> %1070, ptr %1068, align 8
  %1071 = load ptr, ptr %45, align 8
  %1072 = getelementptr inbounds i8, ptr %60, i64 %1065
  %1073 = load <8 x i64>, ptr %1072, align 8
  %1074 = getelementptr inbounds i8, ptr %1071, i64 %1065
  %1075 = load <8 x i64>, ptr %1074, align 8
  %1076 = select <8 x i1> %818, <8 x i64> %1073, <8 x i64> %1075
  store <8 x i64> %1076, ptr %1074, align 8
  %1077 = add nuw nsw i64 %1062, 1
  %1078 = icmp eq i64 %1077, %15
  br i1 %1078, label %1059, label %1061, !llvm.loop !18

1079:                                             ; preds = %1059
  %1080 = call fastcc i64 @act_in_lanes(ptr noundef %0, i64 noundef %803, ptr noundef nonnull %6) #11
  %1081 = icmp ne i32 %802, 0
  %1082 = icmp ne i64 %1080, %803
  %1083 = select i1 %1081, i1 true, i1 %1082
  %1084 = zext i1 %1083 to i32
  %1085 = trunc i64 %803 to i8
  %1086 = bitcast i8 %1085 to <8 x i1>
  %1087 = select <8 x i1> %1086, <8 x i64> zeroinitializer, <8 x i64> %800
  br label %1088

1088:                                             ; preds = %1079, %1059
  %1089 = phi <8 x i64> [ %1087, %1079 ], [ %800, %1059 ]
  %1090 = phi i32 [ %1084, %1079 ], [ %802, %1059 ]
  %1091 = phi i64 [ %1080, %1079 ], [ %190, %1059 ]
  %1092 = load ptr, ptr %115, align 8
  %1093 = load <8 x double>, ptr %1092, align 8
  %1094 = fcmp oeq <8 x double> %1093, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1095 = icmp ne <8 x i64> %1089, zeroinitializer
  %1096 = select <8 x i1> %1094, <8 x i1> %1095, <8 x i1> zeroinitializer
  %1097 = bitcast <8 x i1> %1096 to i8
  %1098 = icmp eq i8 %1097, 0
  br i1 %1098, label %1101, label %1099

1099:                                             ; preds = %1088
  %1100 = zext i8 %1097 to i64
  call fastcc void @retire(ptr noundef %0, i64 noundef %1100, i64 noundef 0) #11
  br label %1101

1101:                                             ; preds = %1099, %1088
  %1102 = phi i32 [ 1, %1099 ], [ %1090, %1088 ]
  br label %185

1103:                                             ; preds = %188, %213, %181
  %1104 = phi i64 [ 1, %181 ], [ 0, %213 ], [ 0, %188 ]
  ret i64 %1104
}



define internal fastcc i64 @fill(ptr noundef readonly %0, ptr noundef writeonly %1) unnamed_addr #2 {
  %3 = getelementptr inbounds i8, ptr %0, i64 648
  %4 = getelementptr inbounds i8, ptr %0, i64 936
  %5 = getelementptr inbounds i8, ptr %0, i64 384
  %6 = load ptr, ptr %4, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 1080
  %8 = getelementptr inbounds i8, ptr %0, i64 1016
  %9 = getelementptr inbounds i8, ptr %0, i64 1008
  %10 = getelementptr inbounds i8, ptr %0, i64 888
  %11 = getelementptr inbounds i8, ptr %0, i64 1096
  %12 = getelementptr inbounds i8, ptr %0, i64 1024
  %13 = getelementptr inbounds i8, ptr %0, i64 1032
  %14 = getelementptr inbounds i8, ptr %0, i64 192
  %15 = getelementptr inbounds i8, ptr %0, i64 1048
  %16 = getelementptr inbounds i8, ptr %0, i64 1056
  %17 = getelementptr inbounds i8, ptr %0, i64 216
  %18 = getelementptr inbounds i8, ptr %0, i64 1072
  %19 = getelementptr inbounds i8, ptr %0, i64 1128
  %20 = getelementptr inbounds i8, ptr %0, i64 1656
  %21 = getelementptr inbounds i8, ptr %0, i64 1664
  %22 = getelementptr inbounds i8, ptr %0, i64 1144
  %23 = getelementptr inbounds i8, ptr %0, i64 1144
  %24 = getelementptr inbounds i8, ptr %0, i64 1160
  %25 = getelementptr inbounds i8, ptr %0, i64 1200
  %26 = getelementptr inbounds i8, ptr %0, i64 1152
  %27 = getelementptr inbounds i8, ptr %0, i64 1048
  %28 = getelementptr inbounds i8, ptr %0, i64 1184
  %29 = getelementptr inbounds i8, ptr %0, i64 1176
  %30 = getelementptr inbounds i8, ptr %0, i64 1192
  %31 = getelementptr inbounds i8, ptr %0, i64 1072
  %32 = getelementptr inbounds i8, ptr %0, i64 1416
  %33 = getelementptr inbounds i8, ptr %0, i64 1432
  %34 = getelementptr inbounds i8, ptr %0, i64 1368
  %35 = getelementptr inbounds i8, ptr %0, i64 1440
  %36 = getelementptr inbounds i8, ptr %0, i64 1456
  %37 = getelementptr inbounds i8, ptr %0, i64 1392
  %38 = getelementptr inbounds i8, ptr %0, i64 984
  br label %39

39:                                               ; preds = %2, %273
  %40 = phi i64 [ 0, %2 ], [ %283, %273 ]
  %41 = phi i64 [ 0, %2 ], [ %274, %273 ]
  %42 = phi i64 [ -1, %2 ], [ %282, %273 ]
  %43 = phi i64 [ 0, %2 ], [ %281, %273 ]
  %44 = load i64, ptr %6, align 8
  %45 = load i64, ptr %8, align 8
  %46 = icmp sge i64 %44, %45
  br i1 %46, label %78, label %47

47:                                               ; preds = %39
  %48 = load ptr, ptr %7, align 8
  %49 = load i64, ptr %11, align 8
  %50 = mul nsw i64 %49, %44
  %51 = getelementptr i64, ptr %48, i64 %50
  %52 = getelementptr i8, ptr %51, i64 24
  %53 = load i64, ptr %52, align 8
  %54 = icmp eq i64 %53, 0
  br i1 %54, label %78, label %73

55:                                               ; preds = %273
  %56 = getelementptr inbounds i8, ptr %0, i64 144
  store i64 %281, ptr %1, align 8
  %57 = icmp slt i64 %282, 0
  br i1 %57, label %387, label %58

58:                                               ; preds = %55
  %59 = getelementptr inbounds i8, ptr %0, i64 888
  %60 = getelementptr inbounds i8, ptr %0, i64 552
  %61 = getelementptr inbounds i8, ptr %0, i64 192
  %62 = getelementptr inbounds i8, ptr %0, i64 216
  %63 = getelementptr inbounds i8, ptr %0, i64 672
  %64 = getelementptr inbounds i8, ptr %0, i64 768
  br label %307

65:                                               ; preds = %73
  %66 = load ptr, ptr %7, align 8
  %67 = load i64, ptr %11, align 8
  %68 = mul nsw i64 %67, %75
  %69 = getelementptr i64, ptr %66, i64 %68
  %70 = getelementptr i8, ptr %69, i64 24
  %71 = load i64, ptr %70, align 8
  %72 = icmp eq i64 %71, 0
  br i1 %72, label %78, label %73, !llvm.loop !19

73:                                               ; preds = %47, %65
  %74 = phi i64 [ %75, %65 ], [ %44, %47 ]
  %75 = add nsw i64 %74, 1
  store i64 %75, ptr %6, align 8
  %76 = load i64, ptr %8, align 8
  %77 = icmp sge i64 %75, %76
  br i1 %77, label %78, label %65, !llvm.loop !19

78:                                               ; preds = %73, %65, %47, %39
  %79 = phi i64 [ %44, %39 ], [ %44, %47 ], [ %75, %65 ], [ %75, %73 ]
  %80 = phi i1 [ %46, %39 ], [ %46, %47 ], [ %77, %65 ], [ %77, %73 ]
  %81 = load ptr, ptr %10, align 8
  %82 = getelementptr inbounds i64, ptr %81, i64 %40
  %83 = load i64, ptr %82, align 8
  %84 = icmp ne i64 %83, -1
  %85 = or i1 %80, %84
  br i1 %85, label %273, label %86

86:                                               ; preds = %78
  %87 = add nsw i64 %79, 1
  store i64 %87, ptr %6, align 8
  %88 = load ptr, ptr %10, align 8
  %89 = getelementptr inbounds i64, ptr %88, i64 %40
  store i64 %79, ptr %89, align 8
  %90 = load ptr, ptr %5, align 8
  %91 = load ptr, ptr %9, align 8
  %92 = load i64, ptr %12, align 8
  %93 = mul nsw i64 %92, %79
  %94 = getelementptr inbounds double, ptr %91, i64 %93
  %95 = getelementptr double, ptr %90, i64 %40
  %96 = icmp sgt i64 %92, 0
  br i1 %96, label %97, label %106

97:                                               ; preds = %86, %97
  %98 = phi i64 [ %103, %97 ], [ 0, %86 ]
  %99 = getelementptr inbounds double, ptr %94, i64 %98
  %100 = load double, ptr %99, align 8
  %101 = shl i64 %98, 6
  %102 = getelementptr i8, ptr %95, i64 %101
  store double %100, ptr %102, align 8
  %103 = add nuw nsw i64 %98, 1
  %104 = load i64, ptr %12, align 8
  %105 = icmp slt i64 %103, %104
  br i1 %105, label %97, label %106, !llvm.loop !20

106:                                              ; preds = %97, %86
  %107 = load ptr, ptr %14, align 8
  %108 = load ptr, ptr %13, align 8
  %109 = load i64, ptr %15, align 8
  %110 = mul nsw i64 %109, %79
  %111 = getelementptr inbounds double, ptr %108, i64 %110
  %112 = getelementptr double, ptr %107, i64 %40
  %113 = icmp sgt i64 %109, 0
  br i1 %113, label %114, label %123

114:                                              ; preds = %106, %114
  %115 = phi i64 [ %120, %114 ], [ 0, %106 ]
  %116 = getelementptr inbounds double, ptr %111, i64 %115
  %117 = load double, ptr %116, align 8
  %118 = shl i64 %115, 6
  %119 = getelementptr i8, ptr %112, i64 %118
  store double %117, ptr %119, align 8
  %120 = add nuw nsw i64 %115, 1
  %121 = load i64, ptr %15, align 8
  %122 = icmp slt i64 %120, %121
  br i1 %122, label %114, label %123, !llvm.loop !20

123:                                              ; preds = %114, %106
  %124 = load ptr, ptr %17, align 8
  %125 = load ptr, ptr %16, align 8
  %126 = load i64, ptr %18, align 8
  %127 = mul nsw i64 %126, %79
  %128 = getelementptr inbounds double, ptr %125, i64 %127
  %129 = getelementptr double, ptr %124, i64 %40
  %130 = icmp sgt i64 %126, 0
  br i1 %130, label %131, label %140

131:                                              ; preds = %123, %131
  %132 = phi i64 [ %137, %131 ], [ 0, %123 ]
  %133 = getelementptr inbounds double, ptr %128, i64 %132
  %134 = load double, ptr %133, align 8
  %135 = shl i64 %132, 6
  %136 = getelementptr i8, ptr %129, i64 %135
  store double %134, ptr %136, align 8
  %137 = add nuw nsw i64 %132, 1
  %138 = load i64, ptr %18, align 8
  %139 = icmp slt i64 %137, %138
  br i1 %139, label %131, label %140, !llvm.loop !20

140:                                              ; preds = %131, %123
  %141 = load ptr, ptr %20, align 8
  %142 = load i64, ptr %21, align 8
  %143 = getelementptr inbounds double, ptr %141, i64 %142
  %144 = load i64, ptr %22, align 8
  %145 = mul i64 %144, -64
  %146 = getelementptr inbounds i8, ptr %143, i64 %145
  %147 = load ptr, ptr %19, align 8
  %148 = mul nsw i64 %144, %79
  %149 = getelementptr inbounds double, ptr %147, i64 %148
  %150 = getelementptr double, ptr %146, i64 %40
  %151 = load i64, ptr %23, align 8
  %152 = icmp sgt i64 %151, 0
  br i1 %152, label %153, label %162

153:                                              ; preds = %140, %153
  %154 = phi i64 [ %159, %153 ], [ 0, %140 ]
  %155 = getelementptr inbounds double, ptr %149, i64 %154
  %156 = load double, ptr %155, align 8
  %157 = shl i64 %154, 6
  %158 = getelementptr i8, ptr %150, i64 %157
  store double %156, ptr %158, align 8
  %159 = add nuw nsw i64 %154, 1
  %160 = load i64, ptr %23, align 8
  %161 = icmp slt i64 %159, %160
  br i1 %161, label %153, label %162, !llvm.loop !20

162:                                              ; preds = %153, %140
  %163 = load i64, ptr %24, align 8
  %164 = icmp sgt i64 %163, 0
  br i1 %164, label %165, label %266

165:                                              ; preds = %162
  %166 = load ptr, ptr %26, align 8
  %167 = getelementptr inbounds i64, ptr %166, i64 %40
  %168 = load i64, ptr %167, align 8
  %169 = inttoptr i64 %168 to ptr
  %170 = load i64, ptr %27, align 8
  %171 = icmp sgt i64 %170, 0
  br i1 %171, label %172, label %174

172:                                              ; preds = %165
  %173 = getelementptr inbounds i8, ptr %169, i64 192
  br label %177

174:                                              ; preds = %177, %165
  %175 = load i64, ptr %28, align 8
  %176 = icmp sgt i64 %175, 0
  br i1 %176, label %198, label %190

177:                                              ; preds = %172, %177
  %178 = phi i64 [ %170, %172 ], [ %188, %177 ]
  %179 = phi i64 [ 0, %172 ], [ %187, %177 ]
  %180 = load ptr, ptr %13, align 8
  %181 = mul nsw i64 %178, %79
  %182 = getelementptr double, ptr %180, i64 %181
  %183 = getelementptr double, ptr %182, i64 %179
  %184 = load double, ptr %183, align 8
  %185 = load ptr, ptr %173, align 8
  %186 = getelementptr inbounds double, ptr %185, i64 %179
  store double %184, ptr %186, align 8
  %187 = add nuw nsw i64 %179, 1
  %188 = load i64, ptr %27, align 8
  %189 = icmp slt i64 %187, %188
  br i1 %189, label %177, label %174, !llvm.loop !22

190:                                              ; preds = %198, %174
  %191 = load ptr, ptr %25, align 8
  %192 = getelementptr inbounds i8, ptr %191, i64 8
  %193 = load i64, ptr %192, align 8
  %194 = icmp sgt i64 %193, 0
  br i1 %194, label %195, label %262

195:                                              ; preds = %190
  %196 = getelementptr inbounds i8, ptr %169, i64 1200
  %197 = getelementptr inbounds i8, ptr %169, i64 960
  br label %217

198:                                              ; preds = %174, %198
  %199 = phi i64 [ %214, %198 ], [ 0, %174 ]
  %200 = load ptr, ptr %29, align 8
  %201 = load i64, ptr %30, align 8
  %202 = mul nsw i64 %201, %199
  %203 = getelementptr inbounds i64, ptr %200, i64 %202
  %204 = load i64, ptr %203, align 8
  %205 = inttoptr i64 %204 to ptr
  %206 = load ptr, ptr %16, align 8
  %207 = load i64, ptr %31, align 8
  %208 = mul nsw i64 %207, %79
  %209 = getelementptr inbounds double, ptr %206, i64 %208
  %210 = getelementptr i64, ptr %203, i64 %40
  %211 = getelementptr i8, ptr %210, i64 8
  %212 = load i64, ptr %211, align 8
  %213 = inttoptr i64 %212 to ptr
  tail call void %205(ptr noundef %209, ptr noundef %213) #12
  %214 = add nuw nsw i64 %199, 1
  %215 = load i64, ptr %28, align 8
  %216 = icmp slt i64 %214, %215
  br i1 %216, label %198, label %190, !llvm.loop !23

217:                                              ; preds = %195, %231
  %218 = phi i64 [ 0, %195 ], [ %240, %231 ]
  %219 = load ptr, ptr %32, align 8
  %220 = load i64, ptr %33, align 8
  %221 = mul nsw i64 %220, %79
  %222 = getelementptr i64, ptr %219, i64 %221
  %223 = getelementptr i64, ptr %222, i64 %218
  %224 = load i64, ptr %223, align 8
  %225 = sitofp i64 %224 to double
  %226 = load ptr, ptr %34, align 8
  %227 = shl i64 %218, 6
  %228 = getelementptr i8, ptr %226, i64 %227
  %229 = getelementptr double, ptr %228, i64 %40
  store double %225, ptr %229, align 8
  %230 = mul i64 %218, 800
  br label %245

231:                                              ; preds = %255
  %232 = load ptr, ptr %197, align 8
  %233 = shl nuw nsw i64 %218, 1
  %234 = or disjoint i64 %233, 1
  %235 = getelementptr inbounds double, ptr %232, i64 %234
  store double 0x7FF8000000000000, ptr %235, align 8
  %236 = load ptr, ptr %197, align 8
  %237 = getelementptr inbounds double, ptr %236, i64 %233
  store double 0x7FF8000000000000, ptr %237, align 8
  %238 = load ptr, ptr %37, align 8
  %239 = getelementptr inbounds double, ptr %238, i64 %40
  store double 0x7FF8000000000000, ptr %239, align 8
  %240 = add nuw nsw i64 %218, 1
  %241 = load ptr, ptr %25, align 8
  %242 = getelementptr inbounds i8, ptr %241, i64 8
  %243 = load i64, ptr %242, align 8
  %244 = icmp slt i64 %240, %243
  br i1 %244, label %217, label %262, !llvm.loop !24

245:                                              ; preds = %217, %255
  %246 = phi i64 [ 0, %217 ], [ %260, %255 ]
  %247 = icmp eq i64 %246, 0
  br i1 %247, label %248, label %255

248:                                              ; preds = %245
  %249 = load ptr, ptr %35, align 8
  %250 = load i64, ptr %36, align 8
  %251 = mul nsw i64 %250, %79
  %252 = getelementptr double, ptr %249, i64 %251
  %253 = getelementptr double, ptr %252, i64 %218
  %254 = load double, ptr %253, align 8
  br label %255

255:                                              ; preds = %248, %245
  %256 = phi double [ %254, %248 ], [ 0xFFF0000000000000, %245 ]
  %257 = load ptr, ptr %196, align 8
  %258 = getelementptr inbounds i8, ptr %257, i64 %230
  %259 = getelementptr inbounds double, ptr %258, i64 %246
  store double %256, ptr %259, align 8
  %260 = add nuw nsw i64 %246, 1
  %261 = icmp eq i64 %260, 100
  br i1 %261, label %231, label %245, !llvm.loop !25

262:                                              ; preds = %231, %190
  %263 = getelementptr inbounds i8, ptr %169, i64 600
  %264 = load ptr, ptr %263, align 8
  %265 = getelementptr inbounds i8, ptr %264, i64 80
  store i64 0, ptr %265, align 8
  br label %266

266:                                              ; preds = %262, %162
  %267 = load ptr, ptr %38, align 8
  %268 = load double, ptr %267, align 8
  %269 = load ptr, ptr %3, align 8
  %270 = getelementptr inbounds double, ptr %269, i64 %40
  store double %268, ptr %270, align 8
  %271 = shl nuw nsw i64 1, %40
  %272 = or i64 %271, %41
  br label %273

273:                                              ; preds = %78, %266
  %274 = phi i64 [ %272, %266 ], [ %41, %78 ]
  %275 = load ptr, ptr %10, align 8
  %276 = getelementptr inbounds i64, ptr %275, i64 %40
  %277 = load i64, ptr %276, align 8
  %278 = icmp sgt i64 %277, -1
  %279 = shl nuw nsw i64 1, %40
  %280 = select i1 %278, i64 %279, i64 0
  %281 = or i64 %280, %43
  %282 = select i1 %278, i64 %40, i64 %42
  %283 = add nuw nsw i64 %40, 1
  %284 = icmp eq i64 %283, 8
  br i1 %284, label %55, label %39, !llvm.loop !26

285:                                              ; preds = %384
  %286 = getelementptr inbounds i8, ptr %0, i64 272
  %287 = load i64, ptr %286, align 8
  %288 = icmp sgt i64 %287, 0
  br i1 %288, label %289, label %387

289:                                              ; preds = %285
  %290 = getelementptr inbounds i8, ptr %0, i64 264
  %291 = getelementptr inbounds i8, ptr %0, i64 216
  br label %292

292:                                              ; preds = %289, %292
  %293 = phi i64 [ 0, %289 ], [ %304, %292 ]
  %294 = load ptr, ptr %290, align 8
  %295 = shl nuw nsw i64 %293, 1
  %296 = getelementptr inbounds i64, ptr %294, i64 %295
  %297 = load i64, ptr %296, align 8
  %298 = inttoptr i64 %297 to ptr
  %299 = load ptr, ptr %291, align 8
  %300 = or disjoint i64 %295, 1
  %301 = getelementptr inbounds i64, ptr %294, i64 %300
  %302 = load i64, ptr %301, align 8
  %303 = inttoptr i64 %302 to ptr
  tail call void %298(ptr noundef %299, ptr noundef %303) #12
  %304 = add nuw nsw i64 %293, 1
  %305 = load i64, ptr %286, align 8
  %306 = icmp slt i64 %304, %305
  br i1 %306, label %292, label %387, !llvm.loop !27

307:                                              ; preds = %58, %384
  %308 = phi i64 [ 0, %58 ], [ %385, %384 ]
  %309 = load ptr, ptr %59, align 8
  %310 = getelementptr inbounds i64, ptr %309, i64 %308
  %311 = load i64, ptr %310, align 8
  %312 = icmp eq i64 %311, -1
  br i1 %312, label %313, label %384

313:                                              ; preds = %307
  %314 = load ptr, ptr %5, align 8
  %315 = load ptr, ptr %56, align 8
  %316 = getelementptr inbounds i8, ptr %315, i64 8
  %317 = load i64, ptr %316, align 8
  %318 = icmp sgt i64 %317, 0
  br i1 %318, label %319, label %328

319:                                              ; preds = %313, %319
  %320 = phi i64 [ %326, %319 ], [ 0, %313 ]
  %321 = shl i64 %320, 6
  %322 = getelementptr i8, ptr %314, i64 %321
  %323 = getelementptr double, ptr %322, i64 %282
  %324 = load double, ptr %323, align 8
  %325 = getelementptr double, ptr %322, i64 %308
  store double %324, ptr %325, align 8
  %326 = add nuw nsw i64 %320, 1
  %327 = icmp eq i64 %326, %317
  br i1 %327, label %328, label %319, !llvm.loop !28

328:                                              ; preds = %319, %313
  %329 = load ptr, ptr %60, align 8
  %330 = load ptr, ptr %56, align 8
  %331 = getelementptr inbounds i8, ptr %330, i64 8
  %332 = load i64, ptr %331, align 8
  %333 = icmp sgt i64 %332, 0
  br i1 %333, label %334, label %343

334:                                              ; preds = %328, %334
  %335 = phi i64 [ %341, %334 ], [ 0, %328 ]
  %336 = shl i64 %335, 6
  %337 = getelementptr i8, ptr %329, i64 %336
  %338 = getelementptr double, ptr %337, i64 %282
  %339 = load double, ptr %338, align 8
  %340 = getelementptr double, ptr %337, i64 %308
  store double %339, ptr %340, align 8
  %341 = add nuw nsw i64 %335, 1
  %342 = icmp eq i64 %341, %332
  br i1 %342, label %343, label %334, !llvm.loop !28

343:                                              ; preds = %334, %328
  %344 = load ptr, ptr %61, align 8
  %345 = load ptr, ptr %56, align 8
  %346 = getelementptr inbounds i8, ptr %345, i64 40
  %347 = load i64, ptr %346, align 8
  %348 = icmp sgt i64 %347, 0
  br i1 %348, label %349, label %358

349:                                              ; preds = %343, %349
  %350 = phi i64 [ %356, %349 ], [ 0, %343 ]
  %351 = shl i64 %350, 6
  %352 = getelementptr i8, ptr %344, i64 %351
  %353 = getelementptr double, ptr %352, i64 %282
  %354 = load double, ptr %353, align 8
  %355 = getelementptr double, ptr %352, i64 %308
  store double %354, ptr %355, align 8
  %356 = add nuw nsw i64 %350, 1
  %357 = icmp eq i64 %356, %347
  br i1 %357, label %358, label %349, !llvm.loop !28

358:                                              ; preds = %349, %343
  %359 = load ptr, ptr %62, align 8
  %360 = load ptr, ptr %56, align 8
  %361 = getelementptr inbounds i8, ptr %360, i64 48
  %362 = load i64, ptr %361, align 8
  %363 = icmp sgt i64 %362, 0
  br i1 %363, label %364, label %373

364:                                              ; preds = %358, %364
  %365 = phi i64 [ %371, %364 ], [ 0, %358 ]
  %366 = shl i64 %365, 6
  %367 = getelementptr i8, ptr %359, i64 %366
  %368 = getelementptr double, ptr %367, i64 %282
  %369 = load double, ptr %368, align 8
  %370 = getelementptr double, ptr %367, i64 %308
  store double %369, ptr %370, align 8
  %371 = add nuw nsw i64 %365, 1
  %372 = icmp eq i64 %371, %362
  br i1 %372, label %373, label %364, !llvm.loop !28

373:                                              ; preds = %364, %358
  %374 = load ptr, ptr %3, align 8
  %375 = getelementptr inbounds double, ptr %374, i64 %282
  %376 = load double, ptr %375, align 8
  %377 = getelementptr inbounds double, ptr %374, i64 %308
  store double %376, ptr %377, align 8
  %378 = load ptr, ptr %63, align 8
  %379 = getelementptr inbounds double, ptr %378, i64 %308
  store double 0.000000e+00, ptr %379, align 8
  %380 = load ptr, ptr %64, align 8
  %381 = getelementptr inbounds double, ptr %380, i64 %308
  store double 0x7FF0000000000000, ptr %381, align 8
  %382 = load ptr, ptr %59, align 8
  %383 = getelementptr inbounds i64, ptr %382, i64 %308
  store i64 -2, ptr %383, align 8
  br label %384

384:                                              ; preds = %307, %373
  %385 = add nuw nsw i64 %308, 1
  %386 = icmp eq i64 %385, 8
  br i1 %386, label %285, label %307, !llvm.loop !29

387:                                              ; preds = %292, %285, %55
  ret i64 %274
}

define internal fastcc void @start(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, i64 noundef %3) unnamed_addr #3 {
  %5 = alloca [8 x double], align 16
  %6 = alloca [8 x double], align 16
  %7 = alloca [8 x double], align 16
  %8 = getelementptr inbounds i8, ptr %0, i64 648
  %9 = getelementptr inbounds i8, ptr %0, i64 936
  %10 = getelementptr inbounds i8, ptr %1, i64 16
  %11 = load ptr, ptr %10, align 8
  %12 = trunc i64 %2 to i8
  %13 = bitcast i8 %12 to <8 x i1>
  %14 = or i64 %3, %2
  %15 = trunc i64 %14 to i8
  %16 = bitcast i8 %15 to <8 x i1>
  %17 = load ptr, ptr %8, align 8
  %18 = load <8 x double>, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %1, i64 8
  %20 = load ptr, ptr %19, align 8
  %21 = load ptr, ptr %11, align 8
  %22 = getelementptr inbounds i8, ptr %11, i64 48
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %20, i64 24
  %25 = load ptr, ptr %24, align 8
  store <8 x double> %18, ptr %25, align 8
  %26 = getelementptr inbounds i8, ptr %20, i64 152
  %27 = load i64, ptr %26, align 8
  %28 = icmp sgt i64 %27, 0
  br i1 %28, label %29, label %30

29:                                               ; preds = %4
  tail call fastcc void @sample(ptr noundef %20) #11
  br label %30

30:                                               ; preds = %4, %29
  %31 = load ptr, ptr %20, align 8
  %32 = load i64, ptr %31, align 8
  %33 = load ptr, ptr %24, align 8
  %34 = getelementptr inbounds i8, ptr %20, i64 48
  %35 = load ptr, ptr %34, align 8
  %36 = getelementptr inbounds i8, ptr %20, i64 96
  %37 = load ptr, ptr %36, align 8
  %38 = inttoptr i64 %32 to ptr
  %39 = tail call i32 %38(ptr noundef %33, ptr noundef %21, ptr noundef %35, ptr noundef %37, ptr noundef %23) #12
  %40 = sext i32 %39 to i64
  %41 = load ptr, ptr %19, align 8
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds i8, ptr %42, i64 8
  %44 = load i64, ptr %43, align 8
  %45 = icmp sgt i64 %44, 0
  br i1 %45, label %46, label %48

46:                                               ; preds = %30
  %47 = getelementptr inbounds i8, ptr %11, i64 168
  br label %56

48:                                               ; preds = %56, %30
  %49 = phi ptr [ %42, %30 ], [ %68, %56 ]
  %50 = getelementptr inbounds i8, ptr %0, i64 960
  %51 = load ptr, ptr %50, align 8
  %52 = getelementptr inbounds i8, ptr %51, i64 8
  %53 = load double, ptr %52, align 8
  %54 = load double, ptr %51, align 8
  %55 = fcmp oeq double %53, 0.000000e+00
  br i1 %55, label %79, label %72

56:                                               ; preds = %46, %56
  %57 = phi i64 [ 0, %46 ], [ %66, %56 ]
  %58 = load ptr, ptr %47, align 8
  %59 = load ptr, ptr %22, align 8
  %60 = shl nsw i64 %57, 6
  %61 = getelementptr inbounds i8, ptr %59, i64 %60
  %62 = load <8 x i64>, ptr %61, align 8
  %63 = getelementptr inbounds i8, ptr %58, i64 %60
  %64 = load <8 x i64>, ptr %63, align 8
  %65 = select <8 x i1> %16, <8 x i64> %62, <8 x i64> %64
  store <8 x i64> %65, ptr %63, align 8
  %66 = add nuw nsw i64 %57, 1
  %67 = load ptr, ptr %19, align 8
  %68 = load ptr, ptr %67, align 8
  %69 = getelementptr inbounds i8, ptr %68, i64 8
  %70 = load i64, ptr %69, align 8
  %71 = icmp slt i64 %66, %70
  br i1 %71, label %56, label %48, !llvm.loop !30

72:                                               ; preds = %48
  %73 = load ptr, ptr %1, align 8
  %74 = load ptr, ptr %73, align 8
  %75 = getelementptr inbounds i8, ptr %74, i64 8
  %76 = load i64, ptr %75, align 8
  %77 = icmp sgt i64 %76, 0
  %78 = select i1 %77, i64 %3, i64 0
  br label %79

79:                                               ; preds = %48, %72
  %80 = phi i64 [ %78, %72 ], [ %14, %48 ]
  %81 = insertelement <8 x double> poison, double %53, i64 0
  %82 = shufflevector <8 x double> %81, <8 x double> poison, <8 x i32> zeroinitializer
  %83 = icmp eq i64 %80, 0
  br i1 %83, label %253, label %84

84:                                               ; preds = %79
  %85 = trunc i64 %80 to i8
  %86 = bitcast i8 %85 to <8 x i1>
  %87 = load ptr, ptr %10, align 8
  %88 = getelementptr inbounds i8, ptr %49, i64 24
  %89 = load i64, ptr %88, align 8
  %90 = load ptr, ptr %87, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %90, ptr noundef %90, ptr noundef nonnull %87, i64 noundef %89) #11
  %91 = load <8 x double>, ptr %5, align 16
  %92 = getelementptr inbounds i8, ptr %87, i64 168
  %93 = load ptr, ptr %92, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %93, ptr noundef %90, ptr noundef nonnull %87, i64 noundef %89) #11
  %94 = load <8 x double>, ptr %6, align 16
  %95 = fcmp olt <8 x double> %91, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %96 = fcmp olt <8 x double> %94, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %97 = or <8 x i1> %96, %95
  %98 = insertelement <8 x double> poison, double %54, i64 0
  %99 = shufflevector <8 x double> %98, <8 x double> poison, <8 x i32> zeroinitializer
  %100 = fmul <8 x double> %91, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %101 = fdiv <8 x double> %100, %94
  %102 = bitcast <8 x double> %101 to <8 x i64>
  %103 = select <8 x i1> %97, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %102
  %104 = bitcast <8 x i64> %103 to <8 x double>
  %105 = fcmp olt <8 x double> %99, %104
  %106 = bitcast <8 x double> %99 to <8 x i64>
  %107 = select <8 x i1> %105, <8 x i64> %106, <8 x i64> %103
  %108 = bitcast <8 x i64> %107 to <8 x double>
  %109 = load ptr, ptr %19, align 8
  %110 = load ptr, ptr %109, align 8
  %111 = getelementptr inbounds i8, ptr %110, i64 8
  %112 = load i64, ptr %111, align 8
  %113 = icmp sgt i64 %112, 0
  br i1 %113, label %114, label %135

114:                                              ; preds = %84
  %115 = getelementptr inbounds i8, ptr %87, i64 48
  br label %116

116:                                              ; preds = %114, %116
  %117 = phi i64 [ 0, %114 ], [ %129, %116 ]
  %118 = load ptr, ptr %115, align 8
  %119 = load ptr, ptr %87, align 8
  %120 = shl nsw i64 %117, 6
  %121 = getelementptr inbounds i8, ptr %119, i64 %120
  %122 = load <8 x double>, ptr %121, align 8
  %123 = load ptr, ptr %92, align 8
  %124 = getelementptr inbounds i8, ptr %123, i64 %120
  %125 = load <8 x double>, ptr %124, align 8
  %126 = fmul <8 x double> %125, %108
  %127 = fadd <8 x double> %122, %126
  %128 = getelementptr inbounds i8, ptr %118, i64 %120
  store <8 x double> %127, ptr %128, align 8
  %129 = add nuw nsw i64 %117, 1
  %130 = load ptr, ptr %19, align 8
  %131 = load ptr, ptr %130, align 8
  %132 = getelementptr inbounds i8, ptr %131, i64 8
  %133 = load i64, ptr %132, align 8
  %134 = icmp slt i64 %129, %133
  br i1 %134, label %116, label %135, !llvm.loop !31

135:                                              ; preds = %116, %84
  %136 = phi ptr [ %109, %84 ], [ %130, %116 ]
  %137 = fadd <8 x double> %18, %108
  %138 = getelementptr inbounds i8, ptr %87, i64 48
  %139 = load ptr, ptr %138, align 8
  %140 = load ptr, ptr %92, align 8
  %141 = getelementptr inbounds i8, ptr %87, i64 8
  %142 = load i64, ptr %141, align 8
  %143 = getelementptr inbounds double, ptr %140, i64 %142
  %144 = getelementptr inbounds i8, ptr %136, i64 24
  %145 = load ptr, ptr %144, align 8
  store <8 x double> %137, ptr %145, align 8
  %146 = getelementptr inbounds i8, ptr %136, i64 152
  %147 = load i64, ptr %146, align 8
  %148 = icmp sgt i64 %147, 0
  br i1 %148, label %149, label %150

149:                                              ; preds = %135
  tail call fastcc void @sample(ptr noundef nonnull %136) #11
  br label %150

150:                                              ; preds = %135, %149
  %151 = load ptr, ptr %136, align 8
  %152 = load i64, ptr %151, align 8
  %153 = load ptr, ptr %144, align 8
  %154 = getelementptr inbounds i8, ptr %136, i64 48
  %155 = load ptr, ptr %154, align 8
  %156 = getelementptr inbounds i8, ptr %136, i64 96
  %157 = load ptr, ptr %156, align 8
  %158 = inttoptr i64 %152 to ptr
  %159 = tail call i32 %158(ptr noundef %153, ptr noundef %139, ptr noundef %155, ptr noundef %157, ptr noundef %143) #12
  %160 = load ptr, ptr %1, align 8
  %161 = getelementptr inbounds i8, ptr %160, i64 120
  %162 = load ptr, ptr %161, align 8
  %163 = load double, ptr %162, align 8
  %164 = load ptr, ptr %92, align 8
  %165 = load i64, ptr %141, align 8
  %166 = getelementptr inbounds double, ptr %164, i64 %165
  %167 = icmp sgt i64 %89, 0
  br i1 %167, label %168, label %178

168:                                              ; preds = %150, %168
  %169 = phi i64 [ %176, %168 ], [ 0, %150 ]
  %170 = shl nsw i64 %169, 6
  %171 = getelementptr inbounds i8, ptr %166, i64 %170
  %172 = load <8 x double>, ptr %171, align 8
  %173 = getelementptr inbounds i8, ptr %164, i64 %170
  %174 = load <8 x double>, ptr %173, align 8
  %175 = fsub <8 x double> %172, %174
  store <8 x double> %175, ptr %171, align 8
  %176 = add nuw nsw i64 %169, 1
  %177 = icmp eq i64 %176, %89
  br i1 %177, label %178, label %168, !llvm.loop !32

178:                                              ; preds = %168, %150
  %179 = load ptr, ptr %87, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %166, ptr noundef %179, ptr noundef nonnull %87, i64 noundef %89) #11
  %180 = load <8 x double>, ptr %7, align 16
  %181 = fdiv <8 x double> %180, %108
  %182 = fcmp ogt <8 x double> %94, %181
  %183 = select <8 x i1> %182, <8 x double> %94, <8 x double> %181
  %184 = fcmp ogt <8 x double> %183, <double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15>
  %185 = fdiv <8 x double> <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>, %183
  %186 = select <8 x i1> %184, <8 x double> %185, <8 x double> <double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13>
  %187 = bitcast <8 x double> %186 to <8 x i64>
  %188 = add <8 x i64> %187, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %189 = ashr <8 x i64> %188, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %190 = and <8 x i64> %188, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %191 = sub <8 x i64> %187, %190
  %192 = bitcast <8 x i64> %191 to <8 x double>
  %193 = fadd <8 x double> %192, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %194 = fadd <8 x double> %192, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %195 = fdiv <8 x double> %193, %194
  %196 = fmul <8 x double> %195, %195
  %197 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %196, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %198 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %197, <8 x double> %196, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %199 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %198, <8 x double> %196, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %200 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %199, <8 x double> %196, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %201 = trunc nsw <8 x i64> %189 to <8 x i32>
  %202 = sitofp <8 x i32> %201 to <8 x double>
  %203 = fmul <8 x double> %195, %200
  %204 = fadd <8 x double> %203, %202
  %205 = insertelement <8 x double> poison, double %163, i64 0
  %206 = shufflevector <8 x double> %205, <8 x double> poison, <8 x i32> zeroinitializer
  %207 = fmul <8 x double> %206, %204
  %208 = fcmp ogt <8 x double> %207, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %209 = bitcast <8 x double> %207 to <8 x i64>
  %210 = select <8 x i1> %208, <8 x i64> %209, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %211 = bitcast <8 x i64> %210 to <8 x double>
  %212 = fcmp olt <8 x double> %211, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %213 = bitcast <8 x i64> %210 to <8 x double>
  %214 = select <8 x i1> %212, <8 x double> %213, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %215 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %214)
  %216 = fsub <8 x double> %214, %215
  %217 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %216, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %218 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %217, <8 x double> %216, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %219 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %218, <8 x double> %216, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %220 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %219, <8 x double> %216, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %221 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %220, <8 x double> %216, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %222 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %221, <8 x double> %216, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %223 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %222, <8 x double> %216, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %224 = bitcast <8 x double> %223 to <8 x i64>
  %225 = fptosi <8 x double> %215 to <8 x i32>
  %226 = zext <8 x i32> %225 to <8 x i64>
  %227 = shl <8 x i64> %226, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %228 = add <8 x i64> %227, %224
  %229 = fmul <8 x double> %108, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %230 = fcmp olt <8 x double> %229, <double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D>
  %231 = bitcast <8 x double> %229 to <8 x i64>
  %232 = select <8 x i1> %230, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %231
  %233 = fmul <8 x double> %108, <double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02>
  %234 = select <8 x i1> %184, <8 x i64> %228, <8 x i64> %232
  %235 = bitcast <8 x i64> %234 to <8 x double>
  %236 = fcmp olt <8 x double> %233, %235
  %237 = bitcast <8 x double> %233 to <8 x i64>
  %238 = select <8 x i1> %236, <8 x i64> %237, <8 x i64> %234
  %239 = bitcast <8 x i64> %238 to <8 x double>
  %240 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %18)
  %241 = fmul <8 x double> %240, <double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000>
  %242 = fcmp ogt <8 x double> %241, %239
  %243 = bitcast <8 x double> %241 to <8 x i64>
  %244 = select <8 x i1> %242, <8 x i64> %243, <8 x i64> %238
  %245 = bitcast <8 x i64> %244 to <8 x double>
  %246 = fcmp olt <8 x double> %99, %245
  %247 = select <8 x i1> %246, <8 x i64> %106, <8 x i64> %244
  %248 = trunc i32 %159 to i8
  %249 = bitcast i8 %248 to <8 x i1>
  %250 = select <8 x i1> %249, <8 x i64> %231, <8 x i64> %247
  %251 = bitcast <8 x i64> %250 to <8 x double>
  %252 = select <8 x i1> %86, <8 x double> %251, <8 x double> %82
  br label %253

253:                                              ; preds = %178, %79
  %254 = phi <8 x double> [ %252, %178 ], [ %82, %79 ]
  %255 = getelementptr inbounds i8, ptr %0, i64 672
  %256 = load ptr, ptr %255, align 8
  %257 = load <8 x double>, ptr %256, align 8
  %258 = select <8 x i1> %16, <8 x double> %254, <8 x double> %257
  store <8 x double> %258, ptr %256, align 8
  %259 = getelementptr inbounds i8, ptr %0, i64 696
  %260 = load ptr, ptr %259, align 8
  %261 = load <8 x double>, ptr %260, align 8
  %262 = select <8 x i1> %16, <8 x double> <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>, <8 x double> %261
  store <8 x double> %262, ptr %260, align 8
  %263 = getelementptr inbounds i8, ptr %0, i64 720
  %264 = load ptr, ptr %263, align 8
  %265 = load ptr, ptr %1, align 8
  %266 = getelementptr inbounds i8, ptr %265, i64 120
  %267 = load ptr, ptr %266, align 8
  %268 = getelementptr inbounds i8, ptr %267, i64 40
  %269 = load double, ptr %268, align 8
  %270 = insertelement <8 x double> poison, double %269, i64 0
  %271 = load <8 x i64>, ptr %264, align 8
  %272 = bitcast <8 x double> %270 to <8 x i64>
  %273 = shufflevector <8 x i64> %272, <8 x i64> poison, <8 x i32> zeroinitializer
  %274 = select <8 x i1> %16, <8 x i64> %273, <8 x i64> %271
  store <8 x i64> %274, ptr %264, align 8
  %275 = getelementptr inbounds i8, ptr %0, i64 792
  %276 = load ptr, ptr %275, align 8
  %277 = load <8 x double>, ptr %276, align 8
  %278 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %277
  store <8 x double> %278, ptr %276, align 8
  %279 = getelementptr inbounds i8, ptr %0, i64 816
  %280 = load ptr, ptr %279, align 8
  %281 = load <8 x double>, ptr %280, align 8
  %282 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %281
  store <8 x double> %282, ptr %280, align 8
  %283 = getelementptr inbounds i8, ptr %0, i64 840
  %284 = load ptr, ptr %283, align 8
  %285 = load <8 x double>, ptr %284, align 8
  %286 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %285
  store <8 x double> %286, ptr %284, align 8
  %287 = getelementptr inbounds i8, ptr %0, i64 864
  %288 = load ptr, ptr %287, align 8
  %289 = tail call <8 x i1> @llvm.is.fpclass.v8f64(<8 x double> %254, i32 384)
  %290 = select <8 x i1> %289, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %291 = load <8 x i64>, ptr %288, align 8
  %292 = select <8 x i1> %16, <8 x i64> %290, <8 x i64> %291
  store <8 x i64> %292, ptr %288, align 8
  %293 = icmp eq i64 %2, 0
  br i1 %293, label %326, label %294

294:                                              ; preds = %253
  %295 = getelementptr inbounds i8, ptr %0, i64 888
  %296 = getelementptr inbounds i8, ptr %0, i64 984
  %297 = getelementptr inbounds i8, ptr %0, i64 992
  %298 = getelementptr inbounds i8, ptr %0, i64 744
  %299 = getelementptr inbounds i8, ptr %0, i64 768
  %300 = getelementptr inbounds i8, ptr %0, i64 912
  br label %301

301:                                              ; preds = %294, %301
  %302 = phi i64 [ %2, %294 ], [ %324, %301 ]
  %303 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %302, i1 true)
  %304 = load ptr, ptr %295, align 8
  %305 = getelementptr inbounds i64, ptr %304, i64 %303
  %306 = load i64, ptr %305, align 8
  %307 = load i64, ptr %297, align 8
  %308 = add nsw i64 %307, -1
  %309 = load ptr, ptr %298, align 8
  %310 = getelementptr inbounds double, ptr %309, i64 %303
  store double 0.000000e+00, ptr %310, align 8
  %311 = load ptr, ptr %296, align 8
  %312 = load double, ptr %311, align 8
  %313 = load ptr, ptr %299, align 8
  %314 = getelementptr inbounds double, ptr %313, i64 %303
  store double %312, ptr %314, align 8
  %315 = load ptr, ptr %9, align 8
  %316 = getelementptr inbounds i8, ptr %315, i64 24
  %317 = load i64, ptr %316, align 8
  %318 = shl i64 %306, 3
  %319 = mul i64 %318, %308
  %320 = add nsw i64 %317, %319
  %321 = load ptr, ptr %300, align 8
  %322 = getelementptr inbounds i64, ptr %321, i64 %303
  store i64 %320, ptr %322, align 8
  %323 = add nsw i64 %302, -1
  %324 = and i64 %323, %302
  %325 = icmp eq i64 %324, 0
  br i1 %325, label %326, label %301, !llvm.loop !33

326:                                              ; preds = %301, %253
  %327 = xor i64 %40, -1
  %328 = and i64 %327, %2
  %329 = icmp eq i64 %328, 0
  br i1 %329, label %333, label %330

330:                                              ; preds = %326
  %331 = getelementptr inbounds i8, ptr %0, i64 768
  %332 = getelementptr inbounds i8, ptr %0, i64 984
  br label %354

333:                                              ; preds = %354, %326
  %334 = and i64 %14, %40
  %335 = xor i64 %334, %14
  %336 = getelementptr inbounds i8, ptr %0, i64 768
  %337 = load ptr, ptr %336, align 8
  %338 = load <8 x double>, ptr %337, align 8
  %339 = fcmp oeq <8 x double> %338, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %340 = bitcast <8 x i1> %339 to i8
  %341 = zext i8 %340 to i64
  %342 = and i64 %335, %341
  %343 = load ptr, ptr %283, align 8
  %344 = load <8 x double>, ptr %343, align 8
  %345 = select <8 x i1> %16, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %346 = or i64 %342, %334
  %347 = xor i64 %346, -1
  %348 = and i64 %80, %347
  %349 = trunc i64 %348 to i8
  %350 = bitcast i8 %349 to <8 x i1>
  %351 = select <8 x i1> %350, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %352 = fadd <8 x double> %345, %351
  %353 = fadd <8 x double> %344, %352
  store <8 x double> %353, ptr %343, align 8
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %334, i64 noundef 3) #11
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %342, i64 noundef 0) #11
  ret void

354:                                              ; preds = %330, %354
  %355 = phi i64 [ %328, %330 ], [ %366, %354 ]
  %356 = load ptr, ptr %11, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %356, i64 noundef %355) #11
  %357 = load ptr, ptr %331, align 8
  %358 = load <8 x double>, ptr %357, align 8
  %359 = load ptr, ptr %332, align 8
  %360 = load double, ptr %359, align 8
  %361 = insertelement <8 x double> poison, double %360, i64 0
  %362 = shufflevector <8 x double> %361, <8 x double> poison, <8 x i32> zeroinitializer
  %363 = fcmp oeq <8 x double> %358, %362
  %364 = bitcast <8 x i1> %363 to i8
  %365 = zext i8 %364 to i64
  %366 = and i64 %355, %365
  %367 = icmp eq i64 %366, 0
  br i1 %367, label %333, label %354, !llvm.loop !34
}

define internal fastcc void @retire(ptr noundef readonly %0, i64 noundef %1, i64 noundef %2) unnamed_addr #4 {
  %4 = getelementptr inbounds i8, ptr %0, i64 648
  %5 = getelementptr inbounds i8, ptr %0, i64 936
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = load ptr, ptr %5, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 32
  %12 = load i64, ptr %11, align 8
  %13 = icmp eq i64 %1, 0
  br i1 %13, label %59, label %14

14:                                               ; preds = %3
  %15 = getelementptr inbounds i8, ptr %0, i64 888
  %16 = getelementptr inbounds i8, ptr %0, i64 912
  %17 = getelementptr inbounds i8, ptr %0, i64 992
  %18 = getelementptr inbounds i8, ptr %0, i64 744
  %19 = icmp sgt i64 %9, 0
  %20 = getelementptr inbounds i8, ptr %0, i64 1080
  %21 = getelementptr inbounds i8, ptr %0, i64 1096
  %22 = getelementptr inbounds i8, ptr %0, i64 792
  %23 = getelementptr inbounds i8, ptr %0, i64 816
  %24 = getelementptr inbounds i8, ptr %0, i64 840
  %25 = icmp slt i64 %2, 0
  %26 = getelementptr inbounds i8, ptr %0, i64 864
  %27 = getelementptr inbounds i8, ptr %0, i64 1104
  %28 = getelementptr inbounds i8, ptr %0, i64 1144
  %29 = getelementptr inbounds i8, ptr %0, i64 1128
  %30 = getelementptr inbounds i8, ptr %0, i64 1656
  %31 = getelementptr inbounds i8, ptr %0, i64 1664
  %32 = getelementptr inbounds i8, ptr %0, i64 1160
  %33 = getelementptr inbounds i8, ptr %0, i64 1200
  %34 = getelementptr inbounds i8, ptr %0, i64 1368
  %35 = getelementptr inbounds i8, ptr %0, i64 1416
  %36 = getelementptr inbounds i8, ptr %0, i64 1432
  %37 = getelementptr inbounds i8, ptr %0, i64 1152
  %38 = getelementptr inbounds i8, ptr %0, i64 1464
  %39 = getelementptr inbounds i8, ptr %0, i64 1480
  br label %40

40:                                               ; preds = %14, %174
  %41 = phi i64 [ %1, %14 ], [ %178, %174 ]
  %42 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %41, i1 true)
  %43 = load ptr, ptr %15, align 8
  %44 = getelementptr inbounds i64, ptr %43, i64 %42
  %45 = load i64, ptr %44, align 8
  %46 = load i64, ptr %17, align 8
  %47 = load ptr, ptr %18, align 8
  %48 = getelementptr inbounds double, ptr %47, i64 %42
  %49 = load double, ptr %48, align 8
  %50 = fptosi double %49 to i64
  %51 = xor i64 %50, -1
  %52 = add i64 %46, %51
  %53 = icmp sgt i64 %52, 0
  br i1 %53, label %54, label %63

54:                                               ; preds = %40
  %55 = load ptr, ptr %16, align 8
  %56 = getelementptr inbounds i64, ptr %55, i64 %42
  %57 = load i64, ptr %56, align 8
  %58 = inttoptr i64 %57 to ptr
  br label %60

59:                                               ; preds = %174, %3
  ret void

60:                                               ; preds = %54, %82
  %61 = phi i64 [ %83, %82 ], [ %52, %54 ]
  %62 = phi ptr [ %84, %82 ], [ %58, %54 ]
  br i1 %19, label %86, label %82

63:                                               ; preds = %82, %40
  %64 = load ptr, ptr %20, align 8
  %65 = load i64, ptr %21, align 8
  %66 = mul nsw i64 %65, %45
  %67 = getelementptr inbounds i64, ptr %64, i64 %66
  %68 = load ptr, ptr %22, align 8
  %69 = getelementptr inbounds double, ptr %68, i64 %42
  %70 = load double, ptr %69, align 8
  %71 = fptosi double %70 to i64
  store i64 %71, ptr %67, align 8
  %72 = load ptr, ptr %23, align 8
  %73 = getelementptr inbounds double, ptr %72, i64 %42
  %74 = load double, ptr %73, align 8
  %75 = fptosi double %74 to i64
  %76 = getelementptr inbounds i8, ptr %67, i64 8
  store i64 %75, ptr %76, align 8
  %77 = load ptr, ptr %24, align 8
  %78 = getelementptr inbounds double, ptr %77, i64 %42
  %79 = load double, ptr %78, align 8
  %80 = fptosi double %79 to i64
  %81 = getelementptr inbounds i8, ptr %67, i64 16
  store i64 %80, ptr %81, align 8
  br i1 %25, label %92, label %97

82:                                               ; preds = %86, %60
  %83 = add nsw i64 %61, -1
  %84 = getelementptr inbounds i8, ptr %62, i64 8
  %85 = icmp sgt i64 %61, 1
  br i1 %85, label %60, label %63, !llvm.loop !35

86:                                               ; preds = %60, %86
  %87 = phi i64 [ %90, %86 ], [ 0, %60 ]
  %88 = mul nsw i64 %87, %12
  %89 = getelementptr inbounds double, ptr %62, i64 %88
  store double 0x7FF8000000000000, ptr %89, align 8
  %90 = add nuw nsw i64 %87, 1
  %91 = icmp eq i64 %90, %9
  br i1 %91, label %82, label %86, !llvm.loop !36

92:                                               ; preds = %63
  %93 = load ptr, ptr %26, align 8
  %94 = getelementptr inbounds double, ptr %93, i64 %42
  %95 = load double, ptr %94, align 8
  %96 = fptosi double %95 to i64
  br label %97

97:                                               ; preds = %63, %92
  %98 = phi i64 [ %96, %92 ], [ %2, %63 ]
  %99 = getelementptr inbounds i8, ptr %67, i64 24
  store i64 %98, ptr %99, align 8
  %100 = load ptr, ptr %4, align 8
  %101 = getelementptr inbounds double, ptr %100, i64 %42
  %102 = load double, ptr %101, align 8
  %103 = load ptr, ptr %27, align 8
  %104 = getelementptr inbounds double, ptr %103, i64 %45
  store double %102, ptr %104, align 8
  %105 = load i64, ptr %28, align 8
  %106 = icmp sgt i64 %105, 0
  br i1 %106, label %110, label %107

107:                                              ; preds = %110, %97
  %108 = load i64, ptr %32, align 8
  %109 = icmp sgt i64 %108, 0
  br i1 %109, label %129, label %174

110:                                              ; preds = %97, %110
  %111 = phi i64 [ %127, %110 ], [ %105, %97 ]
  %112 = phi i64 [ %126, %110 ], [ 0, %97 ]
  %113 = load ptr, ptr %30, align 8
  %114 = load i64, ptr %31, align 8
  %115 = getelementptr inbounds double, ptr %113, i64 %114
  %116 = mul i64 %111, -64
  %117 = getelementptr inbounds i8, ptr %115, i64 %116
  %118 = shl nsw i64 %112, 6
  %119 = getelementptr inbounds i8, ptr %117, i64 %118
  %120 = getelementptr inbounds double, ptr %119, i64 %42
  %121 = load double, ptr %120, align 8
  %122 = load ptr, ptr %29, align 8
  %123 = mul nsw i64 %111, %45
  %124 = getelementptr double, ptr %122, i64 %123
  %125 = getelementptr double, ptr %124, i64 %112
  store double %121, ptr %125, align 8
  %126 = add nuw nsw i64 %112, 1
  %127 = load i64, ptr %28, align 8
  %128 = icmp slt i64 %126, %127
  br i1 %128, label %110, label %107, !llvm.loop !37

129:                                              ; preds = %107
  %130 = load ptr, ptr %33, align 8
  %131 = getelementptr inbounds i8, ptr %130, i64 8
  %132 = load i64, ptr %131, align 8
  %133 = icmp sgt i64 %132, 0
  br i1 %133, label %134, label %173

134:                                              ; preds = %129, %149
  %135 = phi i64 [ %155, %149 ], [ 2, %129 ]
  %136 = phi i64 [ %150, %149 ], [ 0, %129 ]
  %137 = load ptr, ptr %34, align 8
  %138 = shl i64 %136, 6
  %139 = getelementptr i8, ptr %137, i64 %138
  %140 = getelementptr double, ptr %139, i64 %42
  %141 = load double, ptr %140, align 8
  %142 = fptosi double %141 to i64
  %143 = load ptr, ptr %35, align 8
  %144 = load i64, ptr %36, align 8
  %145 = mul nsw i64 %144, %45
  %146 = getelementptr i64, ptr %143, i64 %145
  %147 = getelementptr i64, ptr %146, i64 %136
  store i64 %142, ptr %147, align 8
  %148 = shl nuw nsw i64 %136, 1
  br label %156

149:                                              ; preds = %156
  %150 = add nuw nsw i64 %136, 1
  %151 = load ptr, ptr %33, align 8
  %152 = getelementptr inbounds i8, ptr %151, i64 8
  %153 = load i64, ptr %152, align 8
  %154 = icmp slt i64 %150, %153
  %155 = add nuw i64 %135, 2
  br i1 %154, label %134, label %173, !llvm.loop !38

156:                                              ; preds = %134, %156
  %157 = phi i64 [ %148, %134 ], [ %171, %156 ]
  %158 = load ptr, ptr %37, align 8
  %159 = getelementptr inbounds i64, ptr %158, i64 %42
  %160 = load i64, ptr %159, align 8
  %161 = inttoptr i64 %160 to ptr
  %162 = getelementptr inbounds i8, ptr %161, i64 960
  %163 = load ptr, ptr %162, align 8
  %164 = getelementptr inbounds double, ptr %163, i64 %157
  %165 = load double, ptr %164, align 8
  %166 = load ptr, ptr %38, align 8
  %167 = load i64, ptr %39, align 8
  %168 = mul nsw i64 %167, %45
  %169 = getelementptr double, ptr %166, i64 %168
  %170 = getelementptr double, ptr %169, i64 %157
  store double %165, ptr %170, align 8
  %171 = add nuw nsw i64 %157, 1
  %172 = icmp eq i64 %171, %135
  br i1 %172, label %149, label %156, !llvm.loop !39

173:                                              ; preds = %149, %129
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %42) #11
  br label %174

174:                                              ; preds = %173, %107
  %175 = load ptr, ptr %15, align 8
  %176 = getelementptr inbounds i64, ptr %175, i64 %42
  store i64 -1, ptr %176, align 8
  %177 = add nsw i64 %41, -1
  %178 = and i64 %177, %41
  %179 = icmp eq i64 %178, 0
  br i1 %179, label %59, label %40, !llvm.loop !40
}

define internal fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %1, ptr noundef %2, i64 noundef %3, i32 noundef %4) unnamed_addr #2 {
  %6 = getelementptr inbounds i8, ptr %0, i64 1608
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 56
  %9 = load i64, ptr %8, align 8
  %10 = icmp eq i32 %4, 0
  br i1 %10, label %14, label %11

11:                                               ; preds = %5
  %12 = getelementptr inbounds i8, ptr %0, i64 384
  %13 = load ptr, ptr %12, align 8
  br label %14

14:                                               ; preds = %5, %11
  %15 = phi ptr [ %13, %11 ], [ null, %5 ]
  %16 = inttoptr i64 %9 to ptr
  %17 = tail call i64 %16(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %15, i64 noundef %3) #12
  ret i64 %17
}

define internal fastcc range(i64 0, 256) i64 @clear_lanes(ptr noundef readonly %0) unnamed_addr #3 {
  %2 = getelementptr inbounds i8, ptr %0, i64 384
  %3 = getelementptr inbounds i8, ptr %0, i64 1200
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 1152
  %6 = load ptr, ptr %5, align 8
  %7 = load i64, ptr %6, align 8
  %8 = inttoptr i64 %7 to ptr
  %9 = getelementptr inbounds i8, ptr %8, i64 816
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %4, i64 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 456
  %14 = load ptr, ptr %13, align 8
  %15 = load <8 x double>, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %4, i64 24
  %17 = load i64, ptr %16, align 8
  %18 = icmp eq i64 %17, 0
  br i1 %18, label %142, label %19

19:                                               ; preds = %1
  %20 = getelementptr inbounds i8, ptr %0, i64 1304
  %21 = load i64, ptr %20, align 8
  %22 = icmp sgt i64 %21, 0
  br i1 %22, label %23, label %30

23:                                               ; preds = %19
  %24 = getelementptr inbounds i8, ptr %0, i64 1296
  %25 = getelementptr inbounds i8, ptr %0, i64 408
  %26 = getelementptr inbounds i8, ptr %0, i64 552
  %27 = getelementptr inbounds i8, ptr %0, i64 392
  %28 = getelementptr inbounds i8, ptr %0, i64 1248
  %29 = getelementptr inbounds i8, ptr %4, i64 32
  br label %62

30:                                               ; preds = %85, %19
  %31 = getelementptr inbounds i8, ptr %0, i64 1248
  %32 = load ptr, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %4, i64 32
  %34 = load i64, ptr %33, align 8
  %35 = getelementptr inbounds i8, ptr %4, i64 40
  %36 = load i64, ptr %35, align 8
  %37 = add nsw i64 %36, %34
  %38 = shl nsw i64 %37, 6
  %39 = getelementptr inbounds i8, ptr %32, i64 %38
  store <8 x double> %15, ptr %39, align 8
  %40 = getelementptr inbounds i8, ptr %0, i64 168
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds i8, ptr %0, i64 648
  %43 = load ptr, ptr %42, align 8
  %44 = load <8 x double>, ptr %43, align 8
  store <8 x double> %44, ptr %41, align 8
  %45 = load i64, ptr %16, align 8
  %46 = load ptr, ptr %40, align 8
  %47 = load ptr, ptr %2, align 8
  %48 = load ptr, ptr %31, align 8
  %49 = getelementptr inbounds i8, ptr %0, i64 1272
  %50 = load ptr, ptr %49, align 8
  %51 = getelementptr inbounds i8, ptr %0, i64 1344
  %52 = load ptr, ptr %51, align 8
  %53 = inttoptr i64 %45 to ptr
  %54 = tail call i32 %53(ptr noundef %46, ptr noundef %47, ptr noundef %48, ptr noundef %50, ptr noundef %52) #12
  %55 = trunc i32 %54 to i8
  %56 = xor i8 %55, -1
  %57 = icmp sgt i64 %12, 0
  br i1 %57, label %58, label %113

58:                                               ; preds = %30
  %59 = bitcast i8 %56 to <8 x i1>
  %60 = sext <8 x i1> %59 to <8 x i64>
  %61 = getelementptr inbounds i8, ptr %0, i64 1368
  br label %116

62:                                               ; preds = %23, %85
  %63 = phi i64 [ 0, %23 ], [ %93, %85 ]
  %64 = load ptr, ptr %24, align 8
  %65 = getelementptr inbounds i64, ptr %64, i64 %63
  %66 = load i64, ptr %65, align 8
  %67 = load ptr, ptr %25, align 8
  %68 = shl nsw i64 %66, 6
  %69 = getelementptr inbounds i8, ptr %67, i64 %68
  %70 = load <8 x double>, ptr %69, align 8
  %71 = load ptr, ptr %2, align 8
  %72 = getelementptr inbounds i8, ptr %71, i64 %68
  %73 = load <8 x double>, ptr %72, align 8
  %74 = fsub <8 x double> %70, %73
  %75 = fneg <8 x double> %74
  %76 = fcmp ogt <8 x double> %74, zeroinitializer
  %77 = select <8 x i1> %76, <8 x double> %74, <8 x double> %75
  %78 = load ptr, ptr %0, align 8
  %79 = load i64, ptr %78, align 8
  %80 = icmp slt i64 %79, 0
  br i1 %80, label %85, label %81

81:                                               ; preds = %62
  %82 = load ptr, ptr %26, align 8
  %83 = load i64, ptr %27, align 8
  %84 = getelementptr i8, ptr %82, i64 %68
  br label %96

85:                                               ; preds = %96, %62
  %86 = phi <8 x double> [ %77, %62 ], [ %107, %96 ]
  %87 = load ptr, ptr %28, align 8
  %88 = load i64, ptr %29, align 8
  %89 = add nsw i64 %88, %66
  %90 = fmul <8 x double> %86, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  %91 = shl nsw i64 %89, 6
  %92 = getelementptr inbounds i8, ptr %87, i64 %91
  store <8 x double> %90, ptr %92, align 8
  %93 = add nuw nsw i64 %63, 1
  %94 = load i64, ptr %20, align 8
  %95 = icmp slt i64 %93, %94
  br i1 %95, label %62, label %30, !llvm.loop !41

96:                                               ; preds = %81, %96
  %97 = phi i64 [ 0, %81 ], [ %108, %96 ]
  %98 = phi <8 x double> [ %77, %81 ], [ %107, %96 ]
  %99 = mul nsw i64 %83, %97
  %100 = getelementptr double, ptr %84, i64 %99
  %101 = load <8 x double>, ptr %100, align 8
  %102 = fneg <8 x double> %101
  %103 = fcmp ogt <8 x double> %101, zeroinitializer
  %104 = select <8 x i1> %103, <8 x double> %101, <8 x double> %102
  %105 = fmul <8 x double> %15, %104
  %106 = fcmp ogt <8 x double> %98, %105
  %107 = select <8 x i1> %106, <8 x double> %98, <8 x double> %105
  %108 = add nuw i64 %97, 1
  %109 = icmp eq i64 %97, %79
  br i1 %109, label %85, label %96, !llvm.loop !42

110:                                              ; preds = %138
  %111 = icmp ne <8 x i64> %139, zeroinitializer
  %112 = bitcast <8 x i1> %111 to i8
  br label %113

113:                                              ; preds = %110, %30
  %114 = phi i8 [ %56, %30 ], [ %112, %110 ]
  %115 = zext i8 %114 to i64
  br label %142

116:                                              ; preds = %58, %138
  %117 = phi i64 [ 0, %58 ], [ %140, %138 ]
  %118 = phi <8 x i64> [ %60, %58 ], [ %139, %138 ]
  %119 = getelementptr inbounds i64, ptr %10, i64 %117
  %120 = load i64, ptr %119, align 8
  %121 = and i64 %120, 2
  %122 = icmp eq i64 %121, 0
  br i1 %122, label %123, label %138

123:                                              ; preds = %116
  %124 = load ptr, ptr %51, align 8
  %125 = shl nsw i64 %117, 6
  %126 = getelementptr inbounds i8, ptr %124, i64 %125
  %127 = load <8 x double>, ptr %126, align 8
  %128 = load ptr, ptr %61, align 8
  %129 = getelementptr inbounds i8, ptr %128, i64 %125
  %130 = load <8 x double>, ptr %129, align 8
  %131 = fmul <8 x double> %127, %130
  %132 = add nuw nsw i64 %117, %12
  %133 = shl nsw i64 %132, 6
  %134 = getelementptr inbounds i8, ptr %124, i64 %133
  %135 = load <8 x double>, ptr %134, align 8
  %136 = fcmp ogt <8 x double> %131, %135
  %137 = select <8 x i1> %136, <8 x i64> %118, <8 x i64> zeroinitializer
  br label %138

138:                                              ; preds = %116, %123
  %139 = phi <8 x i64> [ %118, %116 ], [ %137, %123 ]
  %140 = add nuw nsw i64 %117, 1
  %141 = icmp eq i64 %140, %12
  br i1 %141, label %110, label %116, !llvm.loop !43

142:                                              ; preds = %1, %113
  %143 = phi i64 [ %115, %113 ], [ 0, %1 ]
  ret i64 %143
}

define internal fastcc i64 @look_for_events(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef readonly %3, ptr noundef %4, ptr noundef writeonly %5, ptr noundef %6) unnamed_addr #2 {
  br label %13

8:                                                ; preds = %13
  %9 = tail call fastcc i64 @quiet_lanes(ptr noundef %0, ptr noundef %1, i64 noundef %2, ptr noundef %3) #11
  %10 = xor i64 %9, -1
  %11 = and i64 %10, %2
  %12 = icmp eq i64 %11, 0
  br i1 %12, label %40, label %18

13:                                               ; preds = %7, %13
  %14 = phi i64 [ 0, %7 ], [ %16, %13 ]
  %15 = getelementptr inbounds double, ptr %5, i64 %14
  store double 1.000000e+00, ptr %15, align 8
  %16 = add nuw nsw i64 %14, 1
  %17 = icmp eq i64 %16, 8
  br i1 %17, label %8, label %13, !llvm.loop !44

18:                                               ; preds = %8, %43
  %19 = phi i64 [ %45, %43 ], [ %11, %8 ]
  %20 = phi i64 [ %38, %43 ], [ 0, %8 ]
  %21 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %19, i1 true)
  %22 = getelementptr inbounds double, ptr %3, i64 %21
  %23 = load double, ptr %22, align 8
  %24 = getelementptr inbounds double, ptr %5, i64 %21
  %25 = tail call fastcc i64 @look_alone(ptr noundef %0, i64 noundef %21, double noundef %23, ptr noundef %24) #11
  %26 = getelementptr inbounds i64, ptr %4, i64 %21
  store i64 %25, ptr %26, align 8
  %27 = icmp eq i64 %25, -6
  %28 = zext i1 %27 to i64
  %29 = shl nuw i64 %28, %21
  %30 = load i64, ptr %6, align 8
  %31 = or i64 %29, %30
  store i64 %31, ptr %6, align 8
  %32 = load i64, ptr %26, align 8
  %33 = icmp ne i64 %32, 0
  %34 = icmp ne i64 %32, -6
  %35 = and i1 %33, %34
  %36 = zext i1 %35 to i64
  %37 = shl nuw i64 %36, %21
  %38 = or i64 %37, %20
  %39 = icmp eq i64 %32, -6
  br i1 %39, label %42, label %43

40:                                               ; preds = %43, %8
  %41 = phi i64 [ 0, %8 ], [ %38, %43 ]
  ret i64 %41

42:                                               ; preds = %18
  store double 1.000000e+00, ptr %24, align 8
  br label %43

43:                                               ; preds = %18, %42
  %44 = add nsw i64 %19, -1
  %45 = and i64 %44, %19
  %46 = icmp eq i64 %45, 0
  br i1 %46, label %40, label %18, !llvm.loop !45
}

define internal fastcc i64 @write_within(ptr noundef %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef %3, ptr noundef readonly %4) unnamed_addr #3 {
  %6 = alloca [8 x i64], align 16
  %7 = getelementptr inbounds i8, ptr %0, i64 648
  %8 = load ptr, ptr %7, align 8
  %9 = load <8 x double>, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %1, i64 16
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %11, i64 72
  %13 = load ptr, ptr %12, align 8
  %14 = load <8 x double>, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 744
  %16 = load ptr, ptr %15, align 8
  %17 = load <8 x double>, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %0, i64 768
  %19 = load ptr, ptr %18, align 8
  %20 = load <8 x double>, ptr %19, align 8
  %21 = getelementptr inbounds i8, ptr %11, i64 48
  %22 = load ptr, ptr %21, align 8
  %23 = load <8 x double>, ptr %3, align 8
  %24 = icmp eq ptr %4, null
  br i1 %24, label %31, label %25

25:                                               ; preds = %5
  %26 = load <8 x double>, ptr %4, align 8
  %27 = fcmp olt <8 x double> %26, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %28 = fmul <8 x double> %14, %26
  %29 = fadd <8 x double> %9, %28
  %30 = select <8 x i1> %27, <8 x double> %29, <8 x double> %23
  store <8 x double> %30, ptr %3, align 8
  br label %31

31:                                               ; preds = %25, %5
  %32 = phi <8 x double> [ %30, %25 ], [ %23, %5 ]
  %33 = phi <8 x i1> [ %27, %25 ], [ zeroinitializer, %5 ]
  %34 = getelementptr inbounds i8, ptr %0, i64 912
  %35 = load ptr, ptr %34, align 8
  br label %39

36:                                               ; preds = %39
  %37 = getelementptr inbounds i8, ptr %1, i64 8
  %38 = getelementptr inbounds i8, ptr %0, i64 1608
  br label %46

39:                                               ; preds = %31, %39
  %40 = phi i64 [ 0, %31 ], [ %44, %39 ]
  %41 = getelementptr inbounds i64, ptr %35, i64 %40
  %42 = load i64, ptr %41, align 8
  %43 = getelementptr inbounds [8 x i64], ptr %6, i64 0, i64 %40
  store i64 %42, ptr %43, align 8
  %44 = add nuw nsw i64 %40, 1
  %45 = icmp eq i64 %44, 8
  br i1 %45, label %36, label %39, !llvm.loop !46

46:                                               ; preds = %36, %92
  %47 = phi i64 [ %59, %92 ], [ %2, %36 ]
  %48 = phi i64 [ %93, %92 ], [ 0, %36 ]
  %49 = load ptr, ptr %18, align 8
  %50 = load <8 x double>, ptr %49, align 8
  %51 = fcmp olt <8 x double> %50, %32
  %52 = fcmp oeq <8 x double> %50, %32
  %53 = select <8 x i1> %52, <8 x i1> %33, <8 x i1> zeroinitializer
  %54 = select <8 x i1> %51, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %53
  %55 = bitcast <8 x i1> %54 to i8
  %56 = zext i8 %55 to i64
  %57 = xor i64 %48, -1
  %58 = and i64 %47, %57
  %59 = and i64 %58, %56
  %60 = icmp eq i64 %59, 0
  br i1 %60, label %61, label %65

61:                                               ; preds = %46
  %62 = icmp eq i64 %48, 0
  br i1 %62, label %112, label %63

63:                                               ; preds = %61
  %64 = getelementptr inbounds i8, ptr %0, i64 912
  br label %96

65:                                               ; preds = %46
  %66 = fsub <8 x double> %50, %9
  %67 = fdiv <8 x double> %66, %14
  %68 = load ptr, ptr %10, align 8
  %69 = getelementptr inbounds i8, ptr %68, i64 96
  %70 = load ptr, ptr %69, align 8
  store <8 x double> %67, ptr %70, align 8
  %71 = load ptr, ptr %68, align 8
  %72 = getelementptr inbounds i8, ptr %68, i64 192
  %73 = load ptr, ptr %72, align 8
  %74 = getelementptr inbounds i8, ptr %68, i64 8
  %75 = load i64, ptr %74, align 8
  %76 = load ptr, ptr %1, align 8
  %77 = load ptr, ptr %76, align 8
  %78 = getelementptr inbounds i8, ptr %77, i64 24
  %79 = load i64, ptr %78, align 8
  %80 = load ptr, ptr %69, align 8
  %81 = load ptr, ptr %37, align 8
  %82 = load ptr, ptr %81, align 8
  %83 = getelementptr inbounds i8, ptr %82, i64 16
  %84 = load i64, ptr %83, align 8
  tail call fastcc void @nested(ptr noundef %22, ptr noundef %71, ptr noundef %73, i64 noundef %75, i64 noundef %79, ptr noundef %80, i64 noundef %84) #11
  %85 = load ptr, ptr %38, align 8
  %86 = load i64, ptr %85, align 8
  %87 = icmp eq i64 %86, 1
  br i1 %87, label %88, label %92

88:                                               ; preds = %65
  %89 = load ptr, ptr %18, align 8
  %90 = tail call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %89, ptr noundef %22, i64 noundef %59, i32 noundef 0) #11
  %91 = or i64 %90, %48
  br label %92

92:                                               ; preds = %88, %65
  %93 = phi i64 [ %91, %88 ], [ %48, %65 ]
  %94 = xor i64 %93, -1
  %95 = and i64 %59, %94
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %22, i64 noundef %95) #11
  br label %46, !llvm.loop !47

96:                                               ; preds = %63, %96
  %97 = phi i64 [ %48, %63 ], [ %110, %96 ]
  %98 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %97, i1 true)
  %99 = extractelement <8 x double> %17, i64 %98
  %100 = load ptr, ptr %15, align 8
  %101 = getelementptr inbounds double, ptr %100, i64 %98
  store double %99, ptr %101, align 8
  %102 = extractelement <8 x double> %20, i64 %98
  %103 = load ptr, ptr %18, align 8
  %104 = getelementptr inbounds double, ptr %103, i64 %98
  store double %102, ptr %104, align 8
  %105 = getelementptr inbounds [8 x i64], ptr %6, i64 0, i64 %98
  %106 = load i64, ptr %105, align 8
  %107 = load ptr, ptr %64, align 8
  %108 = getelementptr inbounds i64, ptr %107, i64 %98
  store i64 %106, ptr %108, align 8
  %109 = add nsw i64 %97, -1
  %110 = and i64 %109, %97
  %111 = icmp eq i64 %110, 0
  br i1 %111, label %112, label %96, !llvm.loop !48

112:                                              ; preds = %96, %61
  ret i64 %48
}

define internal fastcc void @end_within(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2) unnamed_addr #5 {
  %4 = getelementptr inbounds i8, ptr %0, i64 16
  %5 = load ptr, ptr %4, align 8
  %6 = trunc i64 %1 to i8
  %7 = bitcast i8 %6 to <8 x i1>
  %8 = load <8 x double>, ptr %2, align 8
  %9 = fcmp olt <8 x double> %8, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %10 = and <8 x i1> %9, %7
  %11 = select <8 x i1> %10, <8 x double> %8, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %12 = getelementptr inbounds i8, ptr %5, i64 48
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %5, i64 96
  %15 = load ptr, ptr %14, align 8
  store <8 x double> %11, ptr %15, align 8
  %16 = load ptr, ptr %5, align 8
  %17 = getelementptr inbounds i8, ptr %5, i64 192
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %5, i64 8
  %20 = load i64, ptr %19, align 8
  %21 = load ptr, ptr %0, align 8
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr inbounds i8, ptr %22, i64 24
  %24 = load i64, ptr %23, align 8
  %25 = load ptr, ptr %14, align 8
  %26 = getelementptr inbounds i8, ptr %0, i64 8
  %27 = load ptr, ptr %26, align 8
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr inbounds i8, ptr %28, i64 16
  %30 = load i64, ptr %29, align 8
  tail call fastcc void @nested(ptr noundef %13, ptr noundef %16, ptr noundef %18, i64 noundef %20, i64 noundef %24, ptr noundef %25, i64 noundef %30) #11
  %31 = load ptr, ptr %26, align 8
  %32 = load ptr, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %32, i64 8
  %34 = load i64, ptr %33, align 8
  %35 = icmp sgt i64 %34, 0
  br i1 %35, label %36, label %38

36:                                               ; preds = %3
  %37 = getelementptr inbounds i8, ptr %5, i64 24
  br label %39

38:                                               ; preds = %39, %3
  ret void

39:                                               ; preds = %36, %39
  %40 = phi i64 [ 0, %36 ], [ %49, %39 ]
  %41 = load ptr, ptr %37, align 8
  %42 = load ptr, ptr %12, align 8
  %43 = shl nsw i64 %40, 6
  %44 = getelementptr inbounds i8, ptr %42, i64 %43
  %45 = load <8 x i64>, ptr %44, align 8
  %46 = getelementptr inbounds i8, ptr %41, i64 %43
  %47 = load <8 x i64>, ptr %46, align 8
  %48 = select <8 x i1> %10, <8 x i64> %45, <8 x i64> %47
  store <8 x i64> %48, ptr %46, align 8
  %49 = add nuw nsw i64 %40, 1
  %50 = load ptr, ptr %26, align 8
  %51 = load ptr, ptr %50, align 8
  %52 = getelementptr inbounds i8, ptr %51, i64 8
  %53 = load i64, ptr %52, align 8
  %54 = icmp slt i64 %49, %53
  br i1 %54, label %39, label %38, !llvm.loop !49
}

define internal fastcc void @write_outputs(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2) unnamed_addr #4 {
  %4 = getelementptr inbounds i8, ptr %0, i64 144
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %5, i64 8
  %7 = load i64, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %0, i64 936
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %9, i64 32
  %11 = load i64, ptr %10, align 8
  %12 = icmp eq i64 %2, 0
  br i1 %12, label %28, label %13

13:                                               ; preds = %3
  %14 = getelementptr inbounds i8, ptr %0, i64 912
  %15 = icmp sgt i64 %7, 0
  %16 = getelementptr inbounds i8, ptr %0, i64 744
  %17 = getelementptr inbounds i8, ptr %0, i64 984
  %18 = getelementptr inbounds i8, ptr %0, i64 768
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
  br i1 %45, label %28, label %19, !llvm.loop !50

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
  br i1 %54, label %29, label %46, !llvm.loop !51
}

declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #6

define internal fastcc i64 @act_in_lanes(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2) unnamed_addr #2 {
  %4 = getelementptr inbounds i8, ptr %0, i64 144
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %5, i64 8
  %7 = load i64, ptr %6, align 8
  %8 = icmp eq i64 %1, 0
  br i1 %8, label %32, label %9

9:                                                ; preds = %3
  %10 = getelementptr inbounds i8, ptr %0, i64 1152
  %11 = icmp sgt i64 %7, 0
  %12 = getelementptr inbounds i8, ptr %0, i64 384
  %13 = getelementptr inbounds i8, ptr %0, i64 648
  %14 = getelementptr inbounds i8, ptr %0, i64 1200
  %15 = getelementptr inbounds i8, ptr %0, i64 1392
  %16 = getelementptr inbounds i8, ptr %0, i64 1368
  %17 = getelementptr inbounds i8, ptr %0, i64 1320
  %18 = icmp sgt i64 %7, 0
  %19 = getelementptr inbounds i8, ptr %0, i64 384
  br label %20

20:                                               ; preds = %9, %214
  %21 = phi i64 [ 0, %9 ], [ %215, %214 ]
  %22 = phi i64 [ %1, %9 ], [ %217, %214 ]
  %23 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %22, i1 true)
  %24 = load ptr, ptr %10, align 8
  %25 = getelementptr inbounds i64, ptr %24, i64 %23
  %26 = load i64, ptr %25, align 8
  %27 = inttoptr i64 %26 to ptr
  %28 = getelementptr inbounds i64, ptr %2, i64 %23
  %29 = load i64, ptr %28, align 8
  br i1 %11, label %30, label %34

30:                                               ; preds = %20
  %31 = getelementptr inbounds i8, ptr %27, i64 312
  br label %40

32:                                               ; preds = %214, %3
  %33 = phi i64 [ 0, %3 ], [ %215, %214 ]
  ret i64 %33

34:                                               ; preds = %40, %20
  %35 = load ptr, ptr %13, align 8
  %36 = getelementptr inbounds double, ptr %35, i64 %23
  %37 = load double, ptr %36, align 8
  %38 = getelementptr inbounds i8, ptr %27, i64 576
  %39 = load ptr, ptr %38, align 8
  store double %37, ptr %39, align 8
  switch i64 %29, label %156 [
    i64 -3, label %51
    i64 -2, label %52
  ]

40:                                               ; preds = %30, %40
  %41 = phi i64 [ 0, %30 ], [ %49, %40 ]
  %42 = load ptr, ptr %12, align 8
  %43 = shl nsw i64 %41, 6
  %44 = getelementptr inbounds i8, ptr %42, i64 %43
  %45 = getelementptr inbounds double, ptr %44, i64 %23
  %46 = load double, ptr %45, align 8
  %47 = load ptr, ptr %31, align 8
  %48 = getelementptr inbounds double, ptr %47, i64 %41
  store double %46, ptr %48, align 8
  %49 = add nuw nsw i64 %41, 1
  %50 = icmp eq i64 %49, %7
  br i1 %50, label %34, label %40, !llvm.loop !52

51:                                               ; preds = %34
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #11
  br label %156

52:                                               ; preds = %34
  %53 = load ptr, ptr %10, align 8
  %54 = getelementptr inbounds i64, ptr %53, i64 %23
  %55 = load i64, ptr %54, align 8
  %56 = inttoptr i64 %55 to ptr
  %57 = getelementptr inbounds i8, ptr %56, i64 720
  %58 = load ptr, ptr %57, align 8
  %59 = getelementptr inbounds i8, ptr %58, i64 8
  %60 = load i64, ptr %59, align 8
  %61 = getelementptr inbounds i8, ptr %56, i64 144
  %62 = load ptr, ptr %61, align 8
  %63 = getelementptr inbounds i8, ptr %62, i64 8
  %64 = load i64, ptr %63, align 8
  %65 = getelementptr inbounds i8, ptr %56, i64 576
  %66 = getelementptr inbounds i8, ptr %56, i64 600
  %67 = load ptr, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %67, i64 80
  %69 = load i64, ptr %68, align 8
  %70 = add i64 %60, 1
  %71 = add i64 %70, %69
  %72 = getelementptr inbounds i8, ptr %56, i64 1008
  %73 = getelementptr inbounds i8, ptr %56, i64 1016
  %74 = load i64, ptr %73, align 8
  %75 = icmp sgt i64 %71, %74
  %76 = icmp sgt i64 %60, 0
  br i1 %76, label %77, label %80

77:                                               ; preds = %52
  %78 = getelementptr inbounds i8, ptr %56, i64 912
  %79 = load ptr, ptr %78, align 8
  br label %83

80:                                               ; preds = %83, %52
  %81 = phi i64 [ 0, %52 ], [ %90, %83 ]
  %82 = phi i64 [ 0, %52 ], [ %92, %83 ]
  br i1 %75, label %95, label %96

83:                                               ; preds = %77, %83
  %84 = phi i64 [ 0, %77 ], [ %93, %83 ]
  %85 = phi i64 [ 0, %77 ], [ %92, %83 ]
  %86 = phi i64 [ 0, %77 ], [ %90, %83 ]
  %87 = getelementptr inbounds i64, ptr %79, i64 %84
  %88 = load i64, ptr %87, align 8
  %89 = icmp ne i64 %88, 0
  %90 = select i1 %89, i64 %84, i64 %86
  %91 = zext i1 %89 to i64
  %92 = add nuw nsw i64 %85, %91
  %93 = add nuw nsw i64 %84, 1
  %94 = icmp eq i64 %93, %60
  br i1 %94, label %80, label %83, !llvm.loop !53

95:                                               ; preds = %80
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #11
  br label %96

96:                                               ; preds = %95, %80
  %97 = icmp eq i64 %82, 1
  br i1 %97, label %98, label %140

98:                                               ; preds = %96
  %99 = getelementptr inbounds i8, ptr %56, i64 816
  %100 = load ptr, ptr %99, align 8
  %101 = getelementptr inbounds i64, ptr %100, i64 %81
  %102 = load i64, ptr %101, align 8
  %103 = and i64 %102, 8
  %104 = icmp eq i64 %103, 0
  br i1 %104, label %140, label %105

105:                                              ; preds = %98
  %106 = load ptr, ptr %65, align 8
  %107 = load double, ptr %106, align 8
  %108 = load ptr, ptr %72, align 8
  %109 = load i64, ptr %68, align 8
  %110 = getelementptr inbounds double, ptr %108, i64 %109
  store double %107, ptr %110, align 8
  %111 = getelementptr inbounds i8, ptr %56, i64 1032
  %112 = load ptr, ptr %111, align 8
  %113 = load i64, ptr %68, align 8
  %114 = getelementptr inbounds i64, ptr %112, i64 %113
  store i64 %81, ptr %114, align 8
  %115 = icmp sgt i64 %64, 0
  br i1 %115, label %116, label %120

116:                                              ; preds = %105
  %117 = getelementptr inbounds i8, ptr %56, i64 312
  %118 = getelementptr inbounds i8, ptr %56, i64 1080
  %119 = getelementptr inbounds i8, ptr %56, i64 1056
  br label %123

120:                                              ; preds = %123, %105
  %121 = load i64, ptr %68, align 8
  %122 = add nsw i64 %121, 1
  store i64 %122, ptr %68, align 8
  br label %156

123:                                              ; preds = %116, %123
  %124 = phi i64 [ 0, %116 ], [ %138, %123 ]
  %125 = load ptr, ptr %117, align 8
  %126 = getelementptr inbounds double, ptr %125, i64 %124
  %127 = load double, ptr %126, align 8
  %128 = load ptr, ptr %118, align 8
  %129 = load i64, ptr %68, align 8
  %130 = mul nsw i64 %129, %64
  %131 = getelementptr double, ptr %128, i64 %130
  %132 = getelementptr double, ptr %131, i64 %124
  store double %127, ptr %132, align 8
  %133 = load ptr, ptr %119, align 8
  %134 = load i64, ptr %68, align 8
  %135 = mul nsw i64 %134, %64
  %136 = getelementptr double, ptr %133, i64 %135
  %137 = getelementptr double, ptr %136, i64 %124
  store double %127, ptr %137, align 8
  %138 = add nuw nsw i64 %124, 1
  %139 = icmp eq i64 %138, %64
  br i1 %139, label %120, label %123, !llvm.loop !54

140:                                              ; preds = %98, %96
  %141 = load ptr, ptr %57, align 8
  %142 = getelementptr inbounds i8, ptr %141, i64 48
  %143 = load i64, ptr %142, align 8
  %144 = icmp eq i64 %143, 0
  br i1 %144, label %148, label %145

145:                                              ; preds = %140
  %146 = inttoptr i64 %143 to ptr
  %147 = tail call i64 %146(ptr noundef %56) #12
  br label %148

148:                                              ; preds = %145, %140
  %149 = phi i64 [ %147, %145 ], [ 0, %140 ]
  br i1 %75, label %150, label %151

150:                                              ; preds = %148
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #11
  br label %151

151:                                              ; preds = %150, %148
  %152 = icmp eq i64 %149, 1
  %153 = icmp eq i64 %149, 0
  %154 = select i1 %153, i64 -1, i64 %149
  %155 = select i1 %152, i64 -2, i64 %154
  br label %156

156:                                              ; preds = %151, %120, %51, %34
  %157 = phi i64 [ %29, %51 ], [ %29, %34 ], [ 5, %120 ], [ %155, %151 ]
  %158 = load ptr, ptr %10, align 8
  %159 = getelementptr inbounds i64, ptr %158, i64 %23
  %160 = load i64, ptr %159, align 8
  %161 = inttoptr i64 %160 to ptr
  %162 = load ptr, ptr %14, align 8
  %163 = getelementptr inbounds i8, ptr %162, i64 8
  %164 = load i64, ptr %163, align 8
  %165 = getelementptr inbounds i8, ptr %161, i64 936
  %166 = load ptr, ptr %165, align 8
  %167 = shl nsw i64 %164, 4
  %168 = getelementptr inbounds i8, ptr %166, i64 %167
  %169 = mul i64 %164, 88
  %170 = getelementptr inbounds i8, ptr %166, i64 %169
  %171 = load double, ptr %170, align 8
  %172 = load ptr, ptr %15, align 8
  %173 = getelementptr inbounds double, ptr %172, i64 %23
  store double %171, ptr %173, align 8
  %174 = icmp sgt i64 %164, 0
  br i1 %174, label %175, label %177

175:                                              ; preds = %156
  %176 = getelementptr inbounds i8, ptr %161, i64 888
  br label %180

177:                                              ; preds = %180, %156
  br i1 %18, label %178, label %196

178:                                              ; preds = %177
  %179 = getelementptr inbounds i8, ptr %27, i64 312
  br label %200

180:                                              ; preds = %175, %180
  %181 = phi i64 [ 0, %175 ], [ %194, %180 ]
  %182 = load ptr, ptr %176, align 8
  %183 = getelementptr inbounds i64, ptr %182, i64 %181
  %184 = load i64, ptr %183, align 8
  %185 = sitofp i64 %184 to double
  %186 = load ptr, ptr %16, align 8
  %187 = shl nsw i64 %181, 3
  %188 = add nuw nsw i64 %187, %23
  %189 = getelementptr inbounds double, ptr %186, i64 %188
  store double %185, ptr %189, align 8
  %190 = getelementptr inbounds double, ptr %168, i64 %181
  %191 = load double, ptr %190, align 8
  %192 = load ptr, ptr %17, align 8
  %193 = getelementptr inbounds double, ptr %192, i64 %188
  store double %191, ptr %193, align 8
  %194 = add nuw nsw i64 %181, 1
  %195 = icmp eq i64 %194, %164
  br i1 %195, label %177, label %180, !llvm.loop !55

196:                                              ; preds = %200, %177
  %197 = add i64 %157, 3
  %198 = icmp ult i64 %197, 2
  %199 = shl nuw i64 1, %23
  br i1 %198, label %211, label %213

200:                                              ; preds = %178, %200
  %201 = phi i64 [ 0, %178 ], [ %209, %200 ]
  %202 = load ptr, ptr %179, align 8
  %203 = getelementptr inbounds double, ptr %202, i64 %201
  %204 = load double, ptr %203, align 8
  %205 = load ptr, ptr %19, align 8
  %206 = shl nsw i64 %201, 6
  %207 = getelementptr inbounds i8, ptr %205, i64 %206
  %208 = getelementptr inbounds double, ptr %207, i64 %23
  store double %204, ptr %208, align 8
  %209 = add nuw nsw i64 %201, 1
  %210 = icmp eq i64 %209, %7
  br i1 %210, label %196, label %200, !llvm.loop !56

211:                                              ; preds = %196
  %212 = or i64 %199, %21
  br label %214

213:                                              ; preds = %196
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %199, i64 noundef %157) #11
  br label %214

214:                                              ; preds = %213, %211
  %215 = phi i64 [ %212, %211 ], [ %21, %213 ]
  %216 = add nsw i64 %22, -1
  %217 = and i64 %216, %22
  %218 = icmp eq i64 %217, 0
  br i1 %218, label %32, label %20, !llvm.loop !57
}

declare i64 @llvm.cttz.i64(i64, i1 immarg) #6

define internal fastcc void @norm_to(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, i64 noundef %4) unnamed_addr #7 {
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
  br i1 %48, label %13, label %20, !llvm.loop !58
}

declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #6

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #6

declare <8 x double> @llvm.rint.v8f64(<8 x double>) #6

declare <8 x double> @llvm.ceil.v8f64(<8 x double>) #6

define internal fastcc void @empty_log(ptr noundef readonly %0, i64 noundef %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 1200
  %4 = getelementptr inbounds i8, ptr %0, i64 1152
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i64, ptr %5, i64 %1
  %7 = load i64, ptr %6, align 8
  %8 = inttoptr i64 %7 to ptr
  %9 = getelementptr inbounds i8, ptr %8, i64 600
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 80
  %12 = getelementptr inbounds i8, ptr %0, i64 1560
  %13 = getelementptr inbounds i8, ptr %0, i64 1576
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 1520
  %16 = load i64, ptr %11, align 8
  %17 = icmp sgt i64 %16, 0
  br i1 %17, label %18, label %33

18:                                               ; preds = %2
  %19 = getelementptr inbounds i8, ptr %0, i64 1512
  %20 = getelementptr inbounds i8, ptr %0, i64 888
  %21 = getelementptr inbounds i8, ptr %0, i64 1488
  %22 = getelementptr inbounds i8, ptr %8, i64 1008
  %23 = getelementptr inbounds i8, ptr %8, i64 1032
  %24 = getelementptr inbounds i8, ptr %0, i64 1536
  %25 = icmp sgt i64 %14, 0
  %26 = getelementptr inbounds i8, ptr %8, i64 1056
  %27 = getelementptr inbounds i8, ptr %8, i64 1080
  %28 = getelementptr inbounds i8, ptr %0, i64 1584
  br label %29

29:                                               ; preds = %18, %57
  %30 = phi i64 [ 0, %18 ], [ %58, %57 ]
  %31 = load i64, ptr %15, align 8
  %32 = icmp sgt i64 %31, 0
  br i1 %32, label %34, label %33

33:                                               ; preds = %29, %57, %2
  store i64 0, ptr %11, align 8
  ret void

34:                                               ; preds = %29
  %35 = load ptr, ptr %3, align 8
  %36 = getelementptr inbounds i8, ptr %35, i64 72
  %37 = load i64, ptr %36, align 8
  %38 = add nsw i64 %37, 1
  store i64 %38, ptr %36, align 8
  %39 = load ptr, ptr %20, align 8
  %40 = getelementptr inbounds i64, ptr %39, i64 %1
  %41 = load i64, ptr %40, align 8
  %42 = load ptr, ptr %21, align 8
  %43 = getelementptr inbounds i64, ptr %42, i64 %37
  store i64 %41, ptr %43, align 8
  %44 = load ptr, ptr %22, align 8
  %45 = getelementptr inbounds double, ptr %44, i64 %30
  %46 = load double, ptr %45, align 8
  %47 = load ptr, ptr %19, align 8
  %48 = getelementptr inbounds double, ptr %47, i64 %37
  store double %46, ptr %48, align 8
  %49 = load ptr, ptr %23, align 8
  %50 = getelementptr inbounds i64, ptr %49, i64 %30
  %51 = load i64, ptr %50, align 8
  %52 = load ptr, ptr %24, align 8
  %53 = getelementptr inbounds i64, ptr %52, i64 %37
  store i64 %51, ptr %53, align 8
  br i1 %25, label %54, label %57

54:                                               ; preds = %34
  %55 = mul nuw nsw i64 %30, %14
  %56 = mul nsw i64 %37, %14
  br label %61

57:                                               ; preds = %61, %34
  %58 = add nuw nsw i64 %30, 1
  %59 = load i64, ptr %11, align 8
  %60 = icmp slt i64 %58, %59
  br i1 %60, label %29, label %33, !llvm.loop !59

61:                                               ; preds = %54, %61
  %62 = phi i64 [ 0, %54 ], [ %75, %61 ]
  %63 = load ptr, ptr %26, align 8
  %64 = add nuw nsw i64 %62, %55
  %65 = getelementptr inbounds double, ptr %63, i64 %64
  %66 = load double, ptr %65, align 8
  %67 = load ptr, ptr %12, align 8
  %68 = add nsw i64 %62, %56
  %69 = getelementptr inbounds double, ptr %67, i64 %68
  store double %66, ptr %69, align 8
  %70 = load ptr, ptr %27, align 8
  %71 = getelementptr inbounds double, ptr %70, i64 %64
  %72 = load double, ptr %71, align 8
  %73 = load ptr, ptr %28, align 8
  %74 = getelementptr inbounds double, ptr %73, i64 %68
  store double %72, ptr %74, align 8
  %75 = add nuw nsw i64 %62, 1
  %76 = icmp eq i64 %75, %14
  br i1 %76, label %57, label %61, !llvm.loop !60
}

define internal fastcc void @combine(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, ptr noundef readonly %4, ptr noundef readonly %5, i64 noundef %6, i64 noundef %7) unnamed_addr #8 {
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
  br i1 %50, label %51, label %25, !llvm.loop !61

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
  br i1 %98, label %14, label %19, !llvm.loop !62

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
  br i1 %123, label %104, label %110, !llvm.loop !61

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
  br i1 %138, label %99, label %139, !llvm.loop !63

139:                                              ; preds = %135, %14
  ret void
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #4 {
  %2 = getelementptr inbounds i8, ptr %0, i64 152
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %13

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  %7 = getelementptr inbounds i8, ptr %0, i64 160
  %8 = getelementptr inbounds i8, ptr %0, i64 168
  %9 = getelementptr inbounds i8, ptr %0, i64 24
  %10 = getelementptr inbounds i8, ptr %0, i64 192
  %11 = getelementptr inbounds i8, ptr %0, i64 216
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
  br i1 %24, label %14, label %13, !llvm.loop !64

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
  br i1 %70, label %59, label %71, !llvm.loop !65

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
  br i1 %99, label %21, label %25, !llvm.loop !66
}

define internal fastcc range(i64 0, 256) i64 @quiet_lanes(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef readonly %3) unnamed_addr #3 {
  %5 = alloca [5 x <8 x double>], align 64
  %6 = getelementptr inbounds i8, ptr %0, i64 1200
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 1152
  %11 = load ptr, ptr %10, align 8
  %12 = load i64, ptr %11, align 8
  %13 = inttoptr i64 %12 to ptr
  %14 = getelementptr inbounds i8, ptr %13, i64 816
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 1392
  %17 = load ptr, ptr %16, align 8
  %18 = load <8 x double>, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 648
  %20 = load ptr, ptr %19, align 8
  %21 = load <8 x double>, ptr %20, align 8
  %22 = fcmp une <8 x double> %18, %21
  %23 = bitcast <8 x i1> %22 to i8
  %24 = zext i8 %23 to i64
  %25 = and i64 %24, %2
  %26 = icmp eq i64 %25, 0
  br i1 %26, label %94, label %27

27:                                               ; preds = %4
  %28 = getelementptr inbounds i8, ptr %0, i64 1344
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds i8, ptr %1, i64 16
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds i8, ptr %31, i64 72
  %33 = load ptr, ptr %32, align 8
  %34 = load <8 x double>, ptr %33, align 8
  %35 = getelementptr inbounds i8, ptr %31, i64 48
  %36 = load ptr, ptr %35, align 8
  %37 = getelementptr inbounds i8, ptr %31, i64 96
  %38 = load ptr, ptr %37, align 8
  store <8 x double> zeroinitializer, ptr %38, align 8
  %39 = load ptr, ptr %31, align 8
  %40 = getelementptr inbounds i8, ptr %31, i64 192
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds i8, ptr %31, i64 8
  %43 = load i64, ptr %42, align 8
  %44 = load ptr, ptr %1, align 8
  %45 = load ptr, ptr %44, align 8
  %46 = getelementptr inbounds i8, ptr %45, i64 24
  %47 = load i64, ptr %46, align 8
  %48 = load ptr, ptr %37, align 8
  %49 = getelementptr inbounds i8, ptr %1, i64 8
  %50 = load ptr, ptr %49, align 8
  %51 = load ptr, ptr %50, align 8
  %52 = getelementptr inbounds i8, ptr %51, i64 16
  %53 = load i64, ptr %52, align 8
  tail call fastcc void @nested(ptr noundef %36, ptr noundef %39, ptr noundef %41, i64 noundef %43, i64 noundef %47, ptr noundef %48, i64 noundef %53) #11
  %54 = fmul <8 x double> %34, zeroinitializer
  %55 = fadd <8 x double> %21, %54
  %56 = getelementptr inbounds i8, ptr %0, i64 168
  %57 = load ptr, ptr %56, align 8
  store <8 x double> %55, ptr %57, align 8
  %58 = getelementptr inbounds i8, ptr %0, i64 296
  %59 = load i64, ptr %58, align 8
  %60 = icmp sgt i64 %59, 0
  br i1 %60, label %61, label %63

61:                                               ; preds = %27
  %62 = getelementptr inbounds i8, ptr %0, i64 144
  tail call fastcc void @sample(ptr noundef nonnull %62) #11
  br label %63

63:                                               ; preds = %27, %61
  %64 = load ptr, ptr %6, align 8
  %65 = load i64, ptr %64, align 8
  %66 = getelementptr inbounds i8, ptr %0, i64 168
  %67 = load ptr, ptr %66, align 8
  %68 = load ptr, ptr %30, align 8
  %69 = getelementptr inbounds i8, ptr %68, i64 48
  %70 = load ptr, ptr %69, align 8
  %71 = getelementptr inbounds i8, ptr %0, i64 192
  %72 = load ptr, ptr %71, align 8
  %73 = getelementptr inbounds i8, ptr %0, i64 1224
  %74 = load ptr, ptr %73, align 8
  %75 = inttoptr i64 %65 to ptr
  %76 = tail call i32 %75(ptr noundef %67, ptr noundef %70, ptr noundef %72, ptr noundef %74, ptr noundef %29) #12
  %77 = zext i32 %76 to i64
  %78 = and i64 %77, %24
  %79 = icmp sgt i64 %9, 0
  br i1 %79, label %80, label %94

80:                                               ; preds = %63
  %81 = getelementptr inbounds i8, ptr %0, i64 1320
  br label %82

82:                                               ; preds = %80, %82
  %83 = phi i64 [ 0, %80 ], [ %92, %82 ]
  %84 = load ptr, ptr %81, align 8
  %85 = load ptr, ptr %28, align 8
  %86 = shl nsw i64 %83, 6
  %87 = getelementptr inbounds i8, ptr %85, i64 %86
  %88 = load <8 x i64>, ptr %87, align 8
  %89 = getelementptr inbounds i8, ptr %84, i64 %86
  %90 = load <8 x i64>, ptr %89, align 8
  %91 = select <8 x i1> %22, <8 x i64> %88, <8 x i64> %90
  store <8 x i64> %91, ptr %89, align 8
  %92 = add nuw nsw i64 %83, 1
  %93 = icmp eq i64 %92, %9
  br i1 %93, label %94, label %82, !llvm.loop !67

94:                                               ; preds = %82, %63, %4
  %95 = phi i64 [ 0, %4 ], [ %78, %63 ], [ %78, %82 ]
  %96 = getelementptr inbounds i8, ptr %0, i64 1320
  %97 = shl i64 %9, 6
  %98 = getelementptr inbounds i8, ptr %1, i64 16
  %99 = getelementptr inbounds i8, ptr %1, i64 8
  %100 = getelementptr inbounds i8, ptr %0, i64 168
  %101 = getelementptr inbounds i8, ptr %0, i64 296
  %102 = getelementptr inbounds i8, ptr %0, i64 144
  %103 = getelementptr inbounds i8, ptr %0, i64 168
  %104 = getelementptr inbounds i8, ptr %0, i64 192
  %105 = getelementptr inbounds i8, ptr %0, i64 1224
  br label %119

106:                                              ; preds = %159
  %107 = xor i64 %171, -1
  %108 = and i64 %107, %2
  %109 = trunc i64 %108 to i8
  %110 = bitcast i8 %109 to <8 x i1>
  %111 = sext <8 x i1> %110 to <8 x i64>
  %112 = icmp sgt i64 %9, 0
  br i1 %112, label %113, label %174

113:                                              ; preds = %106
  %114 = getelementptr inbounds i8, ptr %0, i64 1368
  %115 = load ptr, ptr %114, align 8
  %116 = getelementptr inbounds i8, ptr %0, i64 1320
  %117 = load ptr, ptr %116, align 8
  %118 = getelementptr inbounds i8, ptr %5, i64 64
  br label %181

119:                                              ; preds = %94, %159
  %120 = phi i64 [ 1, %94 ], [ %172, %159 ]
  %121 = phi i64 [ %95, %94 ], [ %171, %159 ]
  %122 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %120
  %123 = load double, ptr %122, align 8
  %124 = load ptr, ptr %96, align 8
  %125 = mul i64 %97, %120
  %126 = getelementptr inbounds i8, ptr %124, i64 %125
  %127 = load ptr, ptr %19, align 8
  %128 = load <8 x double>, ptr %127, align 8
  %129 = load ptr, ptr %98, align 8
  %130 = getelementptr inbounds i8, ptr %129, i64 72
  %131 = load ptr, ptr %130, align 8
  %132 = load <8 x double>, ptr %131, align 8
  %133 = insertelement <8 x double> poison, double %123, i64 0
  %134 = shufflevector <8 x double> %133, <8 x double> poison, <8 x i32> zeroinitializer
  %135 = getelementptr inbounds i8, ptr %129, i64 48
  %136 = load ptr, ptr %135, align 8
  %137 = getelementptr inbounds i8, ptr %129, i64 96
  %138 = load ptr, ptr %137, align 8
  store <8 x double> %134, ptr %138, align 8
  %139 = load ptr, ptr %129, align 8
  %140 = getelementptr inbounds i8, ptr %129, i64 192
  %141 = load ptr, ptr %140, align 8
  %142 = getelementptr inbounds i8, ptr %129, i64 8
  %143 = load i64, ptr %142, align 8
  %144 = load ptr, ptr %1, align 8
  %145 = load ptr, ptr %144, align 8
  %146 = getelementptr inbounds i8, ptr %145, i64 24
  %147 = load i64, ptr %146, align 8
  %148 = load ptr, ptr %137, align 8
  %149 = load ptr, ptr %99, align 8
  %150 = load ptr, ptr %149, align 8
  %151 = getelementptr inbounds i8, ptr %150, i64 16
  %152 = load i64, ptr %151, align 8
  tail call fastcc void @nested(ptr noundef %136, ptr noundef %139, ptr noundef %141, i64 noundef %143, i64 noundef %147, ptr noundef %148, i64 noundef %152) #11
  %153 = fmul <8 x double> %134, %132
  %154 = fadd <8 x double> %128, %153
  %155 = load ptr, ptr %100, align 8
  store <8 x double> %154, ptr %155, align 8
  %156 = load i64, ptr %101, align 8
  %157 = icmp sgt i64 %156, 0
  br i1 %157, label %158, label %159

158:                                              ; preds = %119
  tail call fastcc void @sample(ptr noundef nonnull %102) #11
  br label %159

159:                                              ; preds = %119, %158
  %160 = load ptr, ptr %6, align 8
  %161 = load i64, ptr %160, align 8
  %162 = load ptr, ptr %103, align 8
  %163 = load ptr, ptr %98, align 8
  %164 = getelementptr inbounds i8, ptr %163, i64 48
  %165 = load ptr, ptr %164, align 8
  %166 = load ptr, ptr %104, align 8
  %167 = load ptr, ptr %105, align 8
  %168 = inttoptr i64 %161 to ptr
  %169 = tail call i32 %168(ptr noundef %162, ptr noundef %165, ptr noundef %166, ptr noundef %167, ptr noundef %126) #12
  %170 = zext i32 %169 to i64
  %171 = or i64 %121, %170
  %172 = add nuw nsw i64 %120, 1
  %173 = icmp eq i64 %172, 5
  br i1 %173, label %106, label %119, !llvm.loop !68

174:                                              ; preds = %302, %106
  %175 = phi <8 x i64> [ %111, %106 ], [ %304, %302 ]
  %176 = icmp sgt i64 %9, 0
  br i1 %176, label %177, label %307

177:                                              ; preds = %174
  %178 = getelementptr inbounds i8, ptr %0, i64 1320
  %179 = shl i64 %9, 8
  %180 = icmp slt <8 x i64> %175, zeroinitializer
  br label %316

181:                                              ; preds = %113, %302
  %182 = phi <8 x double> [ undef, %113 ], [ %216, %302 ]
  %183 = phi <8 x double> [ undef, %113 ], [ %211, %302 ]
  %184 = phi i64 [ 0, %113 ], [ %305, %302 ]
  %185 = phi <8 x i64> [ %111, %113 ], [ %304, %302 ]
  %186 = shl nsw i64 %184, 6
  %187 = getelementptr inbounds i8, ptr %115, i64 %186
  %188 = load <8 x double>, ptr %187, align 8
  br label %194

189:                                              ; preds = %220
  %190 = getelementptr inbounds i64, ptr %15, i64 %184
  %191 = load i64, ptr %190, align 8
  %192 = and i64 %191, 1
  %193 = icmp eq i64 %192, 0
  br i1 %193, label %224, label %236

194:                                              ; preds = %181, %220
  %195 = phi i64 [ 0, %181 ], [ %222, %220 ]
  %196 = phi <8 x double> [ %182, %181 ], [ %216, %220 ]
  %197 = phi <8 x double> [ %183, %181 ], [ %211, %220 ]
  %198 = phi <8 x i64> [ %185, %181 ], [ %221, %220 ]
  %199 = mul nuw nsw i64 %9, %195
  %200 = add nuw nsw i64 %199, %184
  %201 = shl nsw i64 %200, 6
  %202 = getelementptr inbounds i8, ptr %117, i64 %201
  %203 = load <8 x double>, ptr %202, align 8
  %204 = fmul <8 x double> %188, %203
  %205 = getelementptr inbounds [5 x <8 x double>], ptr %5, i64 0, i64 %195
  store <8 x double> %204, ptr %205, align 64
  %206 = icmp eq i64 %195, 0
  br i1 %206, label %210, label %207

207:                                              ; preds = %194
  %208 = fcmp olt <8 x double> %197, %203
  %209 = select <8 x i1> %208, <8 x double> %197, <8 x double> %203
  br label %210

210:                                              ; preds = %194, %207
  %211 = phi <8 x double> [ %203, %194 ], [ %209, %207 ]
  br i1 %206, label %215, label %212

212:                                              ; preds = %210
  %213 = fcmp ogt <8 x double> %196, %203
  %214 = select <8 x i1> %213, <8 x double> %196, <8 x double> %203
  br label %215

215:                                              ; preds = %210, %212
  %216 = phi <8 x double> [ %203, %210 ], [ %214, %212 ]
  br i1 %206, label %220, label %217

217:                                              ; preds = %215
  %218 = fcmp ogt <8 x double> %204, zeroinitializer
  %219 = select <8 x i1> %218, <8 x i64> %198, <8 x i64> zeroinitializer
  br label %220

220:                                              ; preds = %215, %217
  %221 = phi <8 x i64> [ %219, %217 ], [ %198, %215 ]
  %222 = add nuw nsw i64 %195, 1
  %223 = icmp eq i64 %222, 5
  br i1 %223, label %189, label %194, !llvm.loop !69

224:                                              ; preds = %189
  %225 = fmul <8 x double> %211, %216
  %226 = fcmp ogt <8 x double> %225, zeroinitializer
  %227 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %211)
  %228 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %216)
  %229 = fcmp olt <8 x double> %227, %228
  %230 = select <8 x i1> %229, <8 x double> %227, <8 x double> %228
  %231 = fsub <8 x double> %216, %211
  %232 = fmul <8 x double> %231, <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>
  %233 = fcmp ogt <8 x double> %230, %232
  %234 = select <8 x i1> %233, <8 x i1> %226, <8 x i1> zeroinitializer
  %235 = select <8 x i1> %234, <8 x i64> %221, <8 x i64> zeroinitializer
  br label %236

236:                                              ; preds = %224, %189
  %237 = phi <8 x i64> [ %221, %189 ], [ %235, %224 ]
  %238 = load <8 x double>, ptr %118, align 64
  %239 = load <8 x double>, ptr %5, align 64
  %240 = fsub <8 x double> %238, %239
  %241 = fdiv <8 x double> %240, <double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C>
  br label %242

242:                                              ; preds = %236, %299
  %243 = phi i64 [ 1, %236 ], [ %249, %299 ]
  %244 = phi <8 x i64> [ zeroinitializer, %236 ], [ %300, %299 ]
  %245 = phi <8 x double> [ %241, %236 ], [ %260, %299 ]
  %246 = add nsw i64 %243, -1
  %247 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %243
  %248 = load double, ptr %247, align 8
  %249 = add nuw nsw i64 %243, 1
  %250 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %249
  %251 = load double, ptr %250, align 8
  %252 = getelementptr inbounds <8 x double>, ptr %5, i64 %249
  %253 = load <8 x double>, ptr %252, align 64
  %254 = getelementptr inbounds <8 x double>, ptr %5, i64 %243
  %255 = load <8 x double>, ptr %254, align 64
  %256 = fsub <8 x double> %253, %255
  %257 = fsub double %251, %248
  %258 = insertelement <8 x double> poison, double %257, i64 0
  %259 = shufflevector <8 x double> %258, <8 x double> poison, <8 x i32> zeroinitializer
  %260 = fdiv <8 x double> %256, %259
  %261 = fcmp ogt <8 x double> %260, %245
  %262 = getelementptr inbounds <8 x double>, ptr %5, i64 %246
  %263 = load <8 x double>, ptr %262, align 64
  %264 = fcmp ogt <8 x double> %263, zeroinitializer
  %265 = and <8 x i1> %261, %264
  %266 = bitcast <8 x i1> %265 to i8
  %267 = icmp eq i8 %266, 0
  br i1 %267, label %299, label %268

268:                                              ; preds = %242
  %269 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %246
  %270 = load double, ptr %269, align 8
  %271 = fsub <8 x double> %260, %245
  %272 = fsub double %251, %270
  %273 = insertelement <8 x double> poison, double %272, i64 0
  %274 = shufflevector <8 x double> %273, <8 x double> poison, <8 x i32> zeroinitializer
  %275 = fdiv <8 x double> %271, %274
  %276 = fsub double %248, %270
  %277 = insertelement <8 x double> poison, double %276, i64 0
  %278 = shufflevector <8 x double> %277, <8 x double> poison, <8 x i32> zeroinitializer
  %279 = fmul <8 x double> %278, %275
  %280 = fadd <8 x double> %245, %279
  %281 = insertelement <8 x double> poison, double %248, i64 0
  %282 = shufflevector <8 x double> %281, <8 x double> poison, <8 x i32> zeroinitializer
  %283 = fmul <8 x double> %280, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %284 = fdiv <8 x double> %283, %275
  %285 = fsub <8 x double> %282, %284
  %286 = icmp ugt i64 %243, 1
  %287 = select i1 %286, double %270, double 0xBFCE3779B97F4A7C
  %288 = icmp eq i64 %243, 3
  %289 = select i1 %288, double 0x3FF4498517A7B356, double %251
  %290 = insertelement <8 x double> poison, double %287, i64 0
  %291 = shufflevector <8 x double> %290, <8 x double> poison, <8 x i32> zeroinitializer
  %292 = fcmp oge <8 x double> %285, %291
  %293 = insertelement <8 x double> poison, double %289, i64 0
  %294 = shufflevector <8 x double> %293, <8 x double> poison, <8 x i32> zeroinitializer
  %295 = fcmp ole <8 x double> %285, %294
  %296 = and <8 x i1> %295, %292
  %297 = and <8 x i1> %296, %265
  %298 = select <8 x i1> %297, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, <8 x i64> %244
  br label %299

299:                                              ; preds = %268, %242
  %300 = phi <8 x i64> [ %298, %268 ], [ %244, %242 ]
  %301 = icmp eq i64 %249, 4
  br i1 %301, label %302, label %242, !llvm.loop !70

302:                                              ; preds = %299
  %303 = xor <8 x i64> %300, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %304 = and <8 x i64> %237, %303
  %305 = add nuw nsw i64 %184, 1
  %306 = icmp eq i64 %305, %9
  br i1 %306, label %174, label %181, !llvm.loop !71

307:                                              ; preds = %316, %174
  %308 = load ptr, ptr %16, align 8
  %309 = load <8 x i64>, ptr %3, align 8
  %310 = load <8 x i64>, ptr %308, align 8
  %311 = icmp slt <8 x i64> %175, zeroinitializer
  %312 = select <8 x i1> %311, <8 x i64> %309, <8 x i64> %310
  store <8 x i64> %312, ptr %308, align 8
  %313 = icmp ne <8 x i64> %175, zeroinitializer
  %314 = bitcast <8 x i1> %313 to i8
  %315 = zext i8 %314 to i64
  ret i64 %315

316:                                              ; preds = %177, %316
  %317 = phi i64 [ 0, %177 ], [ %327, %316 ]
  %318 = load ptr, ptr %178, align 8
  %319 = shl i64 %317, 6
  %320 = getelementptr i8, ptr %318, i64 %179
  %321 = getelementptr i8, ptr %320, i64 %319
  %322 = load <8 x i64>, ptr %321, align 8
  %323 = shl nsw i64 %317, 6
  %324 = getelementptr inbounds i8, ptr %318, i64 %323
  %325 = load <8 x i64>, ptr %324, align 8
  %326 = select <8 x i1> %180, <8 x i64> %322, <8 x i64> %325
  store <8 x i64> %326, ptr %324, align 8
  %327 = add nuw nsw i64 %317, 1
  %328 = icmp eq i64 %327, %9
  br i1 %328, label %307, label %316, !llvm.loop !72
}

define internal fastcc i64 @look_alone(ptr noundef readonly %0, i64 noundef %1, double noundef %2, ptr noundef writeonly %3) unnamed_addr #2 {
  %5 = getelementptr inbounds i8, ptr %0, i64 1152
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds i64, ptr %6, i64 %1
  %8 = load i64, ptr %7, align 8
  %9 = inttoptr i64 %8 to ptr
  %10 = getelementptr inbounds i8, ptr %0, i64 384
  %11 = getelementptr inbounds i8, ptr %9, i64 312
  %12 = getelementptr inbounds i8, ptr %0, i64 144
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %13, i64 8
  %15 = load i64, ptr %14, align 8
  %16 = icmp sgt i64 %15, 0
  br i1 %16, label %17, label %24

17:                                               ; preds = %4
  %18 = getelementptr inbounds i8, ptr %0, i64 408
  %19 = getelementptr inbounds i8, ptr %9, i64 336
  %20 = getelementptr inbounds i8, ptr %0, i64 576
  %21 = getelementptr inbounds i8, ptr %0, i64 392
  %22 = getelementptr inbounds i8, ptr %9, i64 504
  %23 = getelementptr inbounds i8, ptr %9, i64 320
  br label %122

24:                                               ; preds = %140, %4
  %25 = getelementptr inbounds i8, ptr %0, i64 1200
  %26 = load ptr, ptr %5, align 8
  %27 = getelementptr inbounds i64, ptr %26, i64 %1
  %28 = load i64, ptr %27, align 8
  %29 = inttoptr i64 %28 to ptr
  %30 = load ptr, ptr %25, align 8
  %31 = getelementptr inbounds i8, ptr %30, i64 8
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %29, i64 936
  %34 = load ptr, ptr %33, align 8
  %35 = shl nsw i64 %32, 4
  %36 = getelementptr inbounds i8, ptr %34, i64 %35
  %37 = mul i64 %32, 88
  %38 = getelementptr inbounds i8, ptr %34, i64 %37
  %39 = getelementptr inbounds i8, ptr %0, i64 1392
  %40 = load ptr, ptr %39, align 8
  %41 = getelementptr inbounds double, ptr %40, i64 %1
  %42 = load double, ptr %41, align 8
  store double %42, ptr %38, align 8
  %43 = icmp sgt i64 %32, 0
  br i1 %43, label %44, label %64

44:                                               ; preds = %24
  %45 = getelementptr inbounds i8, ptr %0, i64 1368
  %46 = getelementptr inbounds i8, ptr %29, i64 888
  %47 = getelementptr inbounds i8, ptr %0, i64 1320
  br label %48

48:                                               ; preds = %44, %48
  %49 = phi i64 [ 0, %44 ], [ %62, %48 ]
  %50 = load ptr, ptr %45, align 8
  %51 = shl nsw i64 %49, 3
  %52 = add nsw i64 %51, %1
  %53 = getelementptr inbounds double, ptr %50, i64 %52
  %54 = load double, ptr %53, align 8
  %55 = fptosi double %54 to i64
  %56 = load ptr, ptr %46, align 8
  %57 = getelementptr inbounds i64, ptr %56, i64 %49
  store i64 %55, ptr %57, align 8
  %58 = load ptr, ptr %47, align 8
  %59 = getelementptr inbounds double, ptr %58, i64 %52
  %60 = load double, ptr %59, align 8
  %61 = getelementptr inbounds double, ptr %36, i64 %49
  store double %60, ptr %61, align 8
  %62 = add nuw nsw i64 %49, 1
  %63 = icmp eq i64 %62, %32
  br i1 %63, label %64, label %48, !llvm.loop !55

64:                                               ; preds = %48, %24
  %65 = getelementptr inbounds i8, ptr %9, i64 576
  %66 = load ptr, ptr %65, align 8
  store double %2, ptr %66, align 8
  %67 = getelementptr inbounds i8, ptr %9, i64 720
  %68 = load ptr, ptr %67, align 8
  %69 = getelementptr inbounds i8, ptr %68, i64 16
  %70 = load i64, ptr %69, align 8
  %71 = inttoptr i64 %70 to ptr
  %72 = getelementptr inbounds i8, ptr %0, i64 648
  %73 = load ptr, ptr %72, align 8
  %74 = getelementptr inbounds double, ptr %73, i64 %1
  %75 = load double, ptr %74, align 8
  %76 = getelementptr inbounds i8, ptr %0, i64 456
  %77 = load ptr, ptr %76, align 8
  %78 = getelementptr inbounds double, ptr %77, i64 %1
  %79 = load double, ptr %78, align 8
  %80 = tail call i64 %71(ptr noundef %9, double noundef %75, double noundef %79) #12
  %81 = load ptr, ptr %65, align 8
  %82 = getelementptr inbounds i8, ptr %81, i64 48
  %83 = load double, ptr %82, align 8
  store double %83, ptr %3, align 8
  %84 = load ptr, ptr %5, align 8
  %85 = getelementptr inbounds i64, ptr %84, i64 %1
  %86 = load i64, ptr %85, align 8
  %87 = inttoptr i64 %86 to ptr
  %88 = load ptr, ptr %25, align 8
  %89 = getelementptr inbounds i8, ptr %88, i64 8
  %90 = load i64, ptr %89, align 8
  %91 = getelementptr inbounds i8, ptr %87, i64 936
  %92 = load ptr, ptr %91, align 8
  %93 = shl nsw i64 %90, 4
  %94 = getelementptr inbounds i8, ptr %92, i64 %93
  %95 = mul i64 %90, 88
  %96 = getelementptr inbounds i8, ptr %92, i64 %95
  %97 = load double, ptr %96, align 8
  %98 = load ptr, ptr %39, align 8
  %99 = getelementptr inbounds double, ptr %98, i64 %1
  store double %97, ptr %99, align 8
  %100 = icmp sgt i64 %90, 0
  br i1 %100, label %101, label %121

101:                                              ; preds = %64
  %102 = getelementptr inbounds i8, ptr %87, i64 888
  %103 = getelementptr inbounds i8, ptr %0, i64 1368
  %104 = getelementptr inbounds i8, ptr %0, i64 1320
  br label %105

105:                                              ; preds = %101, %105
  %106 = phi i64 [ 0, %101 ], [ %119, %105 ]
  %107 = load ptr, ptr %102, align 8
  %108 = getelementptr inbounds i64, ptr %107, i64 %106
  %109 = load i64, ptr %108, align 8
  %110 = sitofp i64 %109 to double
  %111 = load ptr, ptr %103, align 8
  %112 = shl nsw i64 %106, 3
  %113 = add nsw i64 %112, %1
  %114 = getelementptr inbounds double, ptr %111, i64 %113
  store double %110, ptr %114, align 8
  %115 = getelementptr inbounds double, ptr %94, i64 %106
  %116 = load double, ptr %115, align 8
  %117 = load ptr, ptr %104, align 8
  %118 = getelementptr inbounds double, ptr %117, i64 %113
  store double %116, ptr %118, align 8
  %119 = add nuw nsw i64 %106, 1
  %120 = icmp eq i64 %119, %90
  br i1 %120, label %121, label %105, !llvm.loop !55

121:                                              ; preds = %105, %64
  ret i64 %80

122:                                              ; preds = %17, %140
  %123 = phi i64 [ 0, %17 ], [ %141, %140 ]
  %124 = load ptr, ptr %10, align 8
  %125 = shl nsw i64 %123, 3
  %126 = add nsw i64 %125, %1
  %127 = getelementptr inbounds double, ptr %124, i64 %126
  %128 = load double, ptr %127, align 8
  %129 = load ptr, ptr %11, align 8
  %130 = getelementptr inbounds double, ptr %129, i64 %123
  store double %128, ptr %130, align 8
  %131 = load ptr, ptr %18, align 8
  %132 = getelementptr inbounds double, ptr %131, i64 %126
  %133 = load double, ptr %132, align 8
  %134 = load ptr, ptr %19, align 8
  %135 = getelementptr inbounds double, ptr %134, i64 %123
  store double %133, ptr %135, align 8
  %136 = load ptr, ptr %0, align 8
  %137 = getelementptr inbounds i8, ptr %136, i64 24
  %138 = load i64, ptr %137, align 8
  %139 = icmp sgt i64 %138, 0
  br i1 %139, label %143, label %140

140:                                              ; preds = %143, %122
  %141 = add nuw nsw i64 %123, 1
  %142 = icmp eq i64 %141, %15
  br i1 %142, label %24, label %122, !llvm.loop !73

143:                                              ; preds = %122, %143
  %144 = phi i64 [ %157, %143 ], [ 0, %122 ]
  %145 = load ptr, ptr %20, align 8
  %146 = load i64, ptr %21, align 8
  %147 = mul nsw i64 %146, %144
  %148 = getelementptr double, ptr %145, i64 %147
  %149 = getelementptr double, ptr %148, i64 %125
  %150 = getelementptr double, ptr %149, i64 %1
  %151 = load double, ptr %150, align 8
  %152 = load ptr, ptr %22, align 8
  %153 = load i64, ptr %23, align 8
  %154 = mul nsw i64 %153, %144
  %155 = getelementptr double, ptr %152, i64 %154
  %156 = getelementptr double, ptr %155, i64 %123
  store double %151, ptr %156, align 8
  %157 = add nuw nsw i64 %144, 1
  %158 = load ptr, ptr %0, align 8
  %159 = getelementptr inbounds i8, ptr %158, i64 24
  %160 = load i64, ptr %159, align 8
  %161 = icmp slt i64 %157, %160
  br i1 %161, label %143, label %140, !llvm.loop !74
}

define internal fastcc void @nested(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, i64 noundef %3, i64 noundef %4, ptr noundef readonly %5, i64 noundef %6) unnamed_addr #7 {
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
  br i1 %31, label %20, label %19, !llvm.loop !75

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
  br i1 %43, label %32, label %24, !llvm.loop !76
}

declare <8 x i1> @llvm.is.fpclass.v8f64(<8 x double>, i32 immarg) #9

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { noinline nounwind }
attributes #5 = { noinline nounwind }
attributes #6 = { nounwind willreturn memory(none) }
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
!17 = distinct !{!17, !4, !5}
!18 = distinct !{!18, !4, !5}
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !4, !5, !21}
!21 = !{!"llvm.loop.vectorize.width", i32 1}
!22 = distinct !{!22, !4, !5, !21}
!23 = distinct !{!23, !4, !5}
!24 = distinct !{!24, !4, !5}
!25 = distinct !{!25, !4, !5}
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5, !21}
!29 = distinct !{!29, !4, !5}
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5}
!35 = distinct !{!35, !4, !5}
!36 = distinct !{!36, !4, !5, !21}
!37 = distinct !{!37, !4, !5, !21}
!38 = distinct !{!38, !4, !5}
!39 = distinct !{!39, !4, !5}
!40 = distinct !{!40, !4, !5}
!41 = distinct !{!41, !4, !5}
!42 = distinct !{!42, !4, !5}
!43 = distinct !{!43, !4, !5}
!44 = distinct !{!44, !4, !5}
!45 = distinct !{!45, !4, !5}
!46 = distinct !{!46, !4, !5, !21}
!47 = distinct !{!47, !5}
!48 = distinct !{!48, !4, !5}
!49 = distinct !{!49, !4, !5}
!50 = distinct !{!50, !4, !5}
!51 = distinct !{!51, !4, !5, !21}
!52 = distinct !{!52, !4, !5}
!53 = distinct !{!53, !4, !5}
!54 = distinct !{!54, !4, !5}
!55 = distinct !{!55, !4, !5, !21}
!56 = distinct !{!56, !4, !5}
!57 = distinct !{!57, !4, !5}
!58 = distinct !{!58, !4, !5}
!59 = distinct !{!59, !4, !5}
!60 = distinct !{!60, !4, !5, !21}
!61 = distinct !{!61, !4, !5}
!62 = distinct !{!62, !4, !5}
!63 = distinct !{!63, !4, !5}
!64 = distinct !{!64, !4, !5}
!65 = distinct !{!65, !4, !5}
!66 = distinct !{!66, !4, !5}
!67 = distinct !{!67, !4, !5}
!68 = distinct !{!68, !4, !5}
!69 = distinct !{!69, !4, !5}
!70 = distinct !{!70, !4, !5}
!71 = distinct !{!71, !4, !5}
!72 = distinct !{!72, !4, !5}
!73 = distinct !{!73, !4, !5, !21}
!74 = distinct !{!74, !4, !5}
!75 = distinct !{!75, !4, !5}
!76 = distinct !{!76, !4, !5}
