; sources 259fe512857ba4ed46c1c8d1a257775d2000dc9fa24b9013f66cc8a100ece3fe
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
  %158 = call fastcc i64 @fill(ptr noundef nonnull %0, ptr noundef nonnull %5) #10
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
  call fastcc void @start(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %160, i64 noundef %152) #10
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
  switch i32 %182, label %1123 [
    i32 0, label %185
    i32 8, label %188
  ]

185:                                              ; preds = %181, %1121, %263
  %186 = phi i32 [ %183, %181 ], [ %1122, %1121 ], [ 1, %263 ]
  %187 = phi i64 [ %184, %181 ], [ %1111, %1121 ], [ %190, %263 ]
  br label %150, !llvm.loop !7

188:                                              ; preds = %181, %150
  %189 = phi i32 [ %183, %181 ], [ 0, %150 ]
  %190 = phi i64 [ %184, %181 ], [ 0, %150 ]
  %191 = load ptr, ptr %12, align 8
  %192 = getelementptr inbounds i8, ptr %191, i64 8
  %193 = load i64, ptr %192, align 8
  %194 = icmp slt i64 %193, 1
  br i1 %194, label %1123, label %195

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
  br i1 %215, label %216, label %1123

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
  call fastcc void @retire(ptr noundef %0, i64 noundef %267, i64 noundef 1) #10
  %268 = xor i64 %266, -1
  %269 = and i64 %264, %268
  call fastcc void @retire(ptr noundef %0, i64 noundef %269, i64 noundef -1) #10
  br label %185

270:                                              ; preds = %239
  %271 = load ptr, ptr %0, align 8
  %272 = load i64, ptr %271, align 8
  %273 = load ptr, ptr %74, align 8
  store <8 x double> %247, ptr %273, align 8
  %274 = icmp sgt i64 %272, 1
  br i1 %274, label %275, label %325

275:                                              ; preds = %270, %312
  %276 = phi i64 [ %322, %312 ], [ 0, %270 ]
  %277 = phi i64 [ %323, %312 ], [ 1, %270 ]
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
  call fastcc void @combine(ptr noundef %278, ptr noundef %279, ptr noundef %290, ptr noundef %291, ptr noundef %293, ptr noundef %295, i64 noundef %289, i64 noundef %282) #10
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
  call fastcc void @sample(ptr noundef nonnull %9) #10
  br label %312

312:                                              ; preds = %275, %311
  %313 = load ptr, ptr %9, align 8
  %314 = load i64, ptr %313, align 8
  %315 = load ptr, ptr %82, align 8
  %316 = load ptr, ptr %84, align 8
  %317 = load ptr, ptr %85, align 8
  %318 = inttoptr i64 %314 to ptr
  %319 = load ptr, ptr %318, align 8
  %320 = call i32 %319(ptr noundef %315, ptr noundef %307, ptr noundef %316, ptr noundef %317, ptr noundef %299) #11
  %321 = zext i32 %320 to i64
  %322 = or i64 %276, %321
  %323 = add nuw nsw i64 %277, 1
  %324 = icmp eq i64 %323, %272
  br i1 %324, label %325, label %275, !llvm.loop !8

325:                                              ; preds = %312, %270
  %326 = phi i64 [ 0, %270 ], [ %322, %312 ]
  %327 = load ptr, ptr %86, align 8
  %328 = load ptr, ptr %11, align 8
  %329 = load ptr, ptr %9, align 8
  %330 = getelementptr inbounds i8, ptr %329, i64 16
  %331 = load i64, ptr %330, align 8
  %332 = load ptr, ptr %87, align 8
  %333 = getelementptr inbounds i64, ptr %332, i64 %272
  %334 = load i64, ptr %333, align 8
  %335 = getelementptr i8, ptr %333, i64 8
  %336 = load i64, ptr %335, align 8
  %337 = xor i64 %334, -1
  %338 = add i64 %336, %337
  %339 = load ptr, ptr %74, align 8
  %340 = load ptr, ptr %88, align 8
  %341 = load ptr, ptr %89, align 8
  %342 = getelementptr inbounds i64, ptr %341, i64 %334
  %343 = load ptr, ptr %90, align 8
  %344 = getelementptr inbounds double, ptr %343, i64 %334
  call fastcc void @combine(ptr noundef %327, ptr noundef %328, ptr noundef %339, ptr noundef %340, ptr noundef %342, ptr noundef %344, i64 noundef %338, i64 noundef %331) #10
  br i1 %57, label %362, label %345

345:                                              ; preds = %325
  %346 = load ptr, ptr %91, align 8
  %347 = load ptr, ptr %92, align 8
  store <8 x double> %245, ptr %347, align 8
  %348 = load i64, ptr %93, align 8
  %349 = icmp sgt i64 %348, 0
  br i1 %349, label %350, label %351

350:                                              ; preds = %345
  call fastcc void @sample(ptr noundef nonnull %9) #10
  br label %351

351:                                              ; preds = %345, %350
  %352 = load ptr, ptr %9, align 8
  %353 = load i64, ptr %352, align 8
  %354 = load ptr, ptr %92, align 8
  %355 = load ptr, ptr %94, align 8
  %356 = load ptr, ptr %95, align 8
  %357 = inttoptr i64 %353 to ptr
  %358 = load ptr, ptr %357, align 8
  %359 = call i32 %358(ptr noundef %354, ptr noundef %346, ptr noundef %355, ptr noundef %356, ptr noundef %60) #11
  %360 = zext i32 %359 to i64
  %361 = or i64 %326, %360
  br label %362

362:                                              ; preds = %351, %325
  %363 = phi i64 [ %361, %351 ], [ %326, %325 ]
  br i1 %34, label %367, label %364

364:                                              ; preds = %362
  br i1 %96, label %365, label %540

365:                                              ; preds = %364
  %366 = load ptr, ptr %97, align 8
  br label %530

367:                                              ; preds = %362
  %368 = load ptr, ptr %9, align 8
  %369 = load ptr, ptr %0, align 8
  %370 = getelementptr inbounds i8, ptr %368, i64 24
  %371 = load i64, ptr %370, align 8
  %372 = getelementptr inbounds i8, ptr %369, i64 8
  %373 = load i64, ptr %372, align 8
  %374 = load ptr, ptr %98, align 8
  %375 = load i64, ptr %99, align 8
  %376 = getelementptr inbounds double, ptr %374, i64 %375
  %377 = icmp sgt i64 %373, 0
  br i1 %377, label %378, label %380

378:                                              ; preds = %367
  %379 = getelementptr inbounds i8, ptr %368, i64 32
  br label %388

380:                                              ; preds = %388, %367
  %381 = icmp sgt i64 %371, 0
  br i1 %381, label %382, label %414

382:                                              ; preds = %380
  %383 = load ptr, ptr %11, align 8
  %384 = load ptr, ptr %86, align 8
  %385 = load ptr, ptr %101, align 8
  %386 = load ptr, ptr %102, align 8
  %387 = load ptr, ptr %98, align 8
  br label %477

388:                                              ; preds = %378, %388
  %389 = phi i64 [ 0, %378 ], [ %412, %388 ]
  %390 = load i64, ptr %369, align 8
  %391 = load i64, ptr %379, align 8
  %392 = load ptr, ptr %98, align 8
  %393 = load i64, ptr %99, align 8
  %394 = mul nsw i64 %393, %389
  %395 = getelementptr inbounds double, ptr %392, i64 %394
  %396 = load ptr, ptr %100, align 8
  %397 = load ptr, ptr %87, align 8
  %398 = getelementptr i64, ptr %397, i64 %390
  %399 = getelementptr i8, ptr %398, i64 8
  %400 = getelementptr i64, ptr %399, i64 %389
  %401 = load i64, ptr %400, align 8
  %402 = getelementptr i8, ptr %400, i64 8
  %403 = load i64, ptr %402, align 8
  %404 = xor i64 %401, -1
  %405 = add i64 %403, %404
  %406 = load ptr, ptr %74, align 8
  %407 = load ptr, ptr %88, align 8
  %408 = load ptr, ptr %89, align 8
  %409 = getelementptr inbounds i64, ptr %408, i64 %401
  %410 = load ptr, ptr %90, align 8
  %411 = getelementptr inbounds double, ptr %410, i64 %401
  call fastcc void @combine(ptr noundef %395, ptr noundef %396, ptr noundef %406, ptr noundef %407, ptr noundef %409, ptr noundef %411, i64 noundef %405, i64 noundef %391) #10
  %412 = add nuw nsw i64 %389, 1
  %413 = icmp eq i64 %412, %373
  br i1 %413, label %380, label %388, !llvm.loop !9

414:                                              ; preds = %477, %380
  %415 = phi <8 x double> [ zeroinitializer, %380 ], [ %510, %477 ]
  %416 = phi <8 x double> [ zeroinitializer, %380 ], [ %508, %477 ]
  %417 = load ptr, ptr %86, align 8
  %418 = getelementptr inbounds i8, ptr %368, i64 8
  %419 = load i64, ptr %418, align 8
  %420 = add nsw i64 %419, -3
  %421 = getelementptr i8, ptr %417, i64 64
  %422 = getelementptr i8, ptr %417, i64 128
  %423 = getelementptr i8, ptr %417, i64 192
  %424 = icmp slt i64 %371, %420
  br i1 %424, label %432, label %425

425:                                              ; preds = %432, %414
  %426 = phi <8 x double> [ zeroinitializer, %414 ], [ %442, %432 ]
  %427 = phi <8 x double> [ zeroinitializer, %414 ], [ %447, %432 ]
  %428 = phi <8 x double> [ zeroinitializer, %414 ], [ %452, %432 ]
  %429 = phi <8 x double> [ zeroinitializer, %414 ], [ %457, %432 ]
  %430 = phi i64 [ %371, %414 ], [ %458, %432 ]
  %431 = icmp slt i64 %430, %419
  br i1 %431, label %460, label %470

432:                                              ; preds = %414, %432
  %433 = phi i64 [ %458, %432 ], [ %371, %414 ]
  %434 = phi <8 x double> [ %457, %432 ], [ zeroinitializer, %414 ]
  %435 = phi <8 x double> [ %452, %432 ], [ zeroinitializer, %414 ]
  %436 = phi <8 x double> [ %447, %432 ], [ zeroinitializer, %414 ]
  %437 = phi <8 x double> [ %442, %432 ], [ zeroinitializer, %414 ]
  %438 = shl nsw i64 %433, 6
  %439 = getelementptr inbounds i8, ptr %417, i64 %438
  %440 = load <8 x double>, ptr %439, align 8
  %441 = fmul <8 x double> %440, zeroinitializer
  %442 = fadd <8 x double> %437, %441
  %443 = shl i64 %433, 6
  %444 = getelementptr i8, ptr %421, i64 %443
  %445 = load <8 x double>, ptr %444, align 8
  %446 = fmul <8 x double> %445, zeroinitializer
  %447 = fadd <8 x double> %436, %446
  %448 = shl i64 %433, 6
  %449 = getelementptr i8, ptr %422, i64 %448
  %450 = load <8 x double>, ptr %449, align 8
  %451 = fmul <8 x double> %450, zeroinitializer
  %452 = fadd <8 x double> %435, %451
  %453 = shl i64 %433, 6
  %454 = getelementptr i8, ptr %423, i64 %453
  %455 = load <8 x double>, ptr %454, align 8
  %456 = fmul <8 x double> %455, zeroinitializer
  %457 = fadd <8 x double> %434, %456
  %458 = add nsw i64 %433, 4
  %459 = icmp slt i64 %458, %420
  br i1 %459, label %432, label %425, !llvm.loop !10

460:                                              ; preds = %425, %460
  %461 = phi i64 [ %468, %460 ], [ %430, %425 ]
  %462 = phi <8 x double> [ %467, %460 ], [ %426, %425 ]
  %463 = shl nsw i64 %461, 6
  %464 = getelementptr inbounds i8, ptr %417, i64 %463
  %465 = load <8 x double>, ptr %464, align 8
  %466 = fmul <8 x double> %465, zeroinitializer
  %467 = fadd <8 x double> %462, %466
  %468 = add nsw i64 %461, 1
  %469 = icmp eq i64 %468, %419
  br i1 %469, label %470, label %460, !llvm.loop !11

470:                                              ; preds = %460, %425
  %471 = phi <8 x double> [ %426, %425 ], [ %467, %460 ]
  %472 = fadd <8 x double> %427, %471
  %473 = fadd <8 x double> %428, %429
  %474 = fadd <8 x double> %473, %472
  %475 = fadd <8 x double> %416, %474
  %476 = icmp eq i64 %373, 2
  br i1 %476, label %513, label %524

477:                                              ; preds = %382, %477
  %478 = phi <8 x double> [ zeroinitializer, %382 ], [ %508, %477 ]
  %479 = phi <8 x double> [ zeroinitializer, %382 ], [ %510, %477 ]
  %480 = phi i64 [ 0, %382 ], [ %511, %477 ]
  %481 = shl nsw i64 %480, 6
  %482 = getelementptr inbounds i8, ptr %383, i64 %481
  %483 = load <8 x double>, ptr %482, align 8
  %484 = getelementptr inbounds i8, ptr %384, i64 %481
  %485 = load <8 x double>, ptr %484, align 8
  %486 = getelementptr inbounds double, ptr %385, i64 %480
  %487 = load double, ptr %486, align 8
  %488 = insertelement <8 x double> poison, double %487, i64 0
  %489 = shufflevector <8 x double> %488, <8 x double> poison, <8 x i32> zeroinitializer
  %490 = getelementptr inbounds double, ptr %386, i64 %480
  %491 = load double, ptr %490, align 8
  %492 = insertelement <8 x double> poison, double %491, i64 0
  %493 = shufflevector <8 x double> %492, <8 x double> poison, <8 x i32> zeroinitializer
  %494 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %483)
  %495 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %485)
  %496 = fcmp ogt <8 x double> %494, %495
  %497 = select <8 x i1> %496, <8 x double> %494, <8 x double> %495
  %498 = fmul <8 x double> %497, %493
  %499 = fadd <8 x double> %489, %498
  %500 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %499
  %501 = getelementptr inbounds i8, ptr %387, i64 %481
  %502 = load <8 x double>, ptr %501, align 8
  %503 = fmul <8 x double> %502, %500
  %504 = getelementptr inbounds i8, ptr %376, i64 %481
  %505 = load <8 x double>, ptr %504, align 8
  %506 = fmul <8 x double> %505, %500
  %507 = fmul <8 x double> %503, %503
  %508 = fadd <8 x double> %478, %507
  %509 = fmul <8 x double> %506, %506
  %510 = fadd <8 x double> %479, %509
  %511 = add nuw nsw i64 %480, 1
  %512 = icmp eq i64 %511, %371
  br i1 %512, label %414, label %477, !llvm.loop !12

513:                                              ; preds = %470
  %514 = fmul <8 x double> %415, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %515 = fadd <8 x double> %514, %475
  %516 = sitofp i64 %371 to double
  %517 = insertelement <8 x double> poison, double %516, i64 0
  %518 = shufflevector <8 x double> %517, <8 x double> poison, <8 x i32> zeroinitializer
  %519 = fmul <8 x double> %518, %515
  %520 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %519)
  %521 = fdiv <8 x double> %475, %520
  %522 = fcmp oeq <8 x double> %475, zeroinitializer
  %523 = select <8 x i1> %522, <8 x double> zeroinitializer, <8 x double> %521
  br label %540

524:                                              ; preds = %470
  %525 = sitofp i64 %371 to double
  %526 = insertelement <8 x double> poison, double %525, i64 0
  %527 = shufflevector <8 x double> %526, <8 x double> poison, <8 x i32> zeroinitializer
  %528 = fdiv <8 x double> %475, %527
  %529 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %528)
  br label %540

530:                                              ; preds = %365, %530
  %531 = phi <8 x double> [ zeroinitializer, %365 ], [ %537, %530 ]
  %532 = phi i64 [ 0, %365 ], [ %538, %530 ]
  %533 = shl nsw i64 %532, 6
  %534 = getelementptr inbounds i8, ptr %366, i64 %533
  %535 = load <8 x double>, ptr %534, align 8
  %536 = fmul <8 x double> %535, zeroinitializer
  %537 = fadd <8 x double> %531, %536
  %538 = add nuw nsw i64 %532, 1
  %539 = icmp eq i64 %538, %15
  br i1 %539, label %540, label %530, !llvm.loop !13

540:                                              ; preds = %530, %364, %524, %513
  %541 = phi <8 x double> [ %523, %513 ], [ %529, %524 ], [ zeroinitializer, %364 ], [ %537, %530 ]
  %542 = fcmp uge <8 x double> %541, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %543 = trunc i64 %363 to i8
  %544 = bitcast i8 %543 to <8 x i1>
  %545 = select <8 x i1> %544, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %542
  %546 = xor <8 x i1> %545, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %547 = select <8 x i1> %546, <8 x i1> %220, <8 x i1> zeroinitializer
  %548 = sext <8 x i1> %547 to <8 x i64>
  br i1 %40, label %549, label %561

549:                                              ; preds = %540
  %550 = xor <8 x i1> %545, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %551 = select <8 x i1> %550, <8 x i1> %220, <8 x i1> zeroinitializer
  %552 = bitcast <8 x i1> %551 to i8
  %553 = icmp eq i8 %552, 0
  br i1 %553, label %561, label %554

554:                                              ; preds = %549
  %555 = zext i8 %552 to i64
  store <8 x double> %245, ptr %3, align 16
  %556 = load ptr, ptr %103, align 8
  %557 = call fastcc i64 @hold_lanes(ptr noundef nonnull %0, ptr noundef nonnull %3, ptr noundef %556, i64 noundef %555, i32 noundef %56) #10
  %558 = trunc i64 %557 to i8
  %559 = bitcast i8 %558 to <8 x i1>
  %560 = select <8 x i1> %559, <8 x i64> zeroinitializer, <8 x i64> %548
  br label %561

561:                                              ; preds = %554, %549, %540
  %562 = phi <8 x i64> [ %560, %554 ], [ %548, %549 ], [ %548, %540 ]
  %563 = phi i64 [ %557, %554 ], [ 0, %549 ], [ 0, %540 ]
  %564 = icmp ne <8 x i64> %562, zeroinitializer
  %565 = bitcast <8 x i1> %564 to i8
  %566 = icmp ne i8 %565, 0
  %567 = select i1 %58, i1 %566, i1 false
  br i1 %567, label %568, label %588

568:                                              ; preds = %561
  %569 = load ptr, ptr %104, align 8
  %570 = load ptr, ptr %105, align 8
  store <8 x double> %245, ptr %570, align 8
  %571 = load i64, ptr %106, align 8
  %572 = icmp sgt i64 %571, 0
  br i1 %572, label %573, label %574

573:                                              ; preds = %568
  call fastcc void @sample(ptr noundef nonnull %9) #10
  br label %574

574:                                              ; preds = %568, %573
  %575 = load ptr, ptr %9, align 8
  %576 = load i64, ptr %575, align 8
  %577 = load ptr, ptr %105, align 8
  %578 = load ptr, ptr %107, align 8
  %579 = load ptr, ptr %108, align 8
  %580 = inttoptr i64 %576 to ptr
  %581 = load ptr, ptr %580, align 8
  %582 = call i32 %581(ptr noundef %577, ptr noundef %569, ptr noundef %578, ptr noundef %579, ptr noundef %60) #11
  %583 = zext i32 %582 to i64
  %584 = or i64 %363, %583
  %585 = trunc i64 %584 to i8
  %586 = bitcast i8 %585 to <8 x i1>
  %587 = select <8 x i1> %586, <8 x i64> zeroinitializer, <8 x i64> %562
  br label %588

588:                                              ; preds = %574, %561
  %589 = phi <8 x i64> [ %587, %574 ], [ %562, %561 ]
  %590 = phi i64 [ %584, %574 ], [ %363, %561 ]
  %591 = load ptr, ptr %109, align 8
  %592 = load <8 x double>, ptr %591, align 8
  %593 = load i64, ptr %16, align 8
  %594 = add i64 %593, %110
  %595 = sitofp i64 %594 to double
  %596 = insertelement <8 x double> poison, double %595, i64 0
  %597 = shufflevector <8 x double> %596, <8 x double> poison, <8 x i32> zeroinitializer
  %598 = icmp slt <8 x i64> %562, zeroinitializer
  %599 = select <8 x i1> %598, <8 x i64> %114, <8 x i64> zeroinitializer
  %600 = bitcast <8 x i64> %599 to <8 x double>
  %601 = fadd <8 x double> %597, %600
  %602 = fadd <8 x double> %592, %601
  store <8 x double> %602, ptr %591, align 8
  br i1 %59, label %603, label %612

603:                                              ; preds = %588
  %604 = icmp ne <8 x i64> %589, zeroinitializer
  %605 = bitcast <8 x i1> %604 to i8
  %606 = icmp eq i8 %605, 0
  br i1 %606, label %612, label %607

607:                                              ; preds = %603
  %608 = zext i8 %605 to i64
  %609 = call fastcc i64 @clear_lanes(ptr noundef %0) #10
  %610 = xor i64 %609, -1
  %611 = and i64 %610, %608
  br label %612

612:                                              ; preds = %588, %603, %607
  %613 = phi i64 [ %611, %607 ], [ 0, %603 ], [ 0, %588 ]
  store i64 0, ptr %7, align 8
  %614 = load ptr, ptr %115, align 8
  %615 = load <8 x double>, ptr %614, align 8
  %616 = fcmp olt <8 x double> %615, %245
  %617 = icmp ne <8 x i64> %589, zeroinitializer
  %618 = select <8 x i1> %616, <8 x i1> %617, <8 x i1> zeroinitializer
  %619 = bitcast <8 x i1> %618 to i8
  %620 = zext i8 %619 to i64
  %621 = or i64 %613, %620
  %622 = icmp eq i64 %621, 0
  br i1 %622, label %818, label %623

623:                                              ; preds = %612
  %624 = load ptr, ptr %0, align 8
  %625 = load ptr, ptr %9, align 8
  %626 = getelementptr inbounds i8, ptr %625, i64 16
  %627 = load i64, ptr %626, align 8
  %628 = load i64, ptr %624, align 8
  %629 = load i64, ptr %116, align 8
  %630 = load ptr, ptr %88, align 8
  %631 = mul nsw i64 %629, %628
  %632 = getelementptr inbounds double, ptr %630, i64 %631
  %633 = load ptr, ptr %117, align 8
  %634 = add nsw i64 %628, 1
  %635 = getelementptr inbounds i8, ptr %624, i64 16
  %636 = load i64, ptr %635, align 8
  %637 = icmp sgt i64 %636, 0
  br i1 %637, label %638, label %640

638:                                              ; preds = %623
  %639 = getelementptr inbounds i8, ptr %624, i64 8
  br label %651

640:                                              ; preds = %686, %623
  %641 = phi i64 [ 0, %623 ], [ %696, %686 ]
  %642 = getelementptr inbounds i8, ptr %624, i64 16
  %643 = load ptr, ptr %9, align 8
  %644 = getelementptr inbounds i8, ptr %643, i64 8
  %645 = load i64, ptr %644, align 8
  %646 = icmp sgt i64 %645, 0
  br i1 %646, label %647, label %701

647:                                              ; preds = %640
  %648 = getelementptr inbounds double, ptr %633, i64 %629
  %649 = shl nsw i64 %629, 4
  %650 = getelementptr inbounds i8, ptr %633, i64 %649
  br label %708

651:                                              ; preds = %638, %686
  %652 = phi i64 [ 0, %638 ], [ %696, %686 ]
  %653 = phi i64 [ %634, %638 ], [ %697, %686 ]
  %654 = load i64, ptr %639, align 8
  %655 = load ptr, ptr %118, align 8
  %656 = load ptr, ptr %11, align 8
  %657 = load ptr, ptr %87, align 8
  %658 = getelementptr i64, ptr %657, i64 %653
  %659 = getelementptr i64, ptr %658, i64 %654
  %660 = load i64, ptr %659, align 8
  %661 = getelementptr i8, ptr %659, i64 8
  %662 = load i64, ptr %661, align 8
  %663 = xor i64 %660, -1
  %664 = add i64 %662, %663
  %665 = load ptr, ptr %74, align 8
  %666 = load ptr, ptr %88, align 8
  %667 = load ptr, ptr %89, align 8
  %668 = getelementptr inbounds i64, ptr %667, i64 %660
  %669 = load ptr, ptr %90, align 8
  %670 = getelementptr inbounds double, ptr %669, i64 %660
  call fastcc void @combine(ptr noundef %655, ptr noundef %656, ptr noundef %665, ptr noundef %666, ptr noundef %668, ptr noundef %670, i64 noundef %664, i64 noundef %627) #10
  %671 = load ptr, ptr %88, align 8
  %672 = mul nsw i64 %653, %629
  %673 = getelementptr inbounds double, ptr %671, i64 %672
  %674 = load ptr, ptr %119, align 8
  %675 = getelementptr inbounds double, ptr %674, i64 %653
  %676 = load double, ptr %675, align 8
  %677 = insertelement <8 x double> poison, double %676, i64 0
  %678 = shufflevector <8 x double> %677, <8 x double> poison, <8 x i32> zeroinitializer
  %679 = fmul <8 x double> %247, %678
  %680 = fadd <8 x double> %222, %679
  %681 = load ptr, ptr %118, align 8
  %682 = load ptr, ptr %120, align 8
  store <8 x double> %680, ptr %682, align 8
  %683 = load i64, ptr %121, align 8
  %684 = icmp sgt i64 %683, 0
  br i1 %684, label %685, label %686

685:                                              ; preds = %651
  call fastcc void @sample(ptr noundef nonnull %9) #10
  br label %686

686:                                              ; preds = %651, %685
  %687 = load ptr, ptr %9, align 8
  %688 = load i64, ptr %687, align 8
  %689 = load ptr, ptr %120, align 8
  %690 = load ptr, ptr %122, align 8
  %691 = load ptr, ptr %123, align 8
  %692 = inttoptr i64 %688 to ptr
  %693 = load ptr, ptr %692, align 8
  %694 = call i32 %693(ptr noundef %689, ptr noundef %681, ptr noundef %690, ptr noundef %691, ptr noundef %673) #11
  %695 = sext i32 %694 to i64
  %696 = or i64 %652, %695
  %697 = add nsw i64 %653, 1
  %698 = load i64, ptr %635, align 8
  %699 = add nsw i64 %698, %634
  %700 = icmp slt i64 %697, %699
  br i1 %700, label %651, label %640, !llvm.loop !14

701:                                              ; preds = %708, %640
  %702 = getelementptr inbounds i8, ptr %624, i64 8
  %703 = load i64, ptr %702, align 8
  %704 = load i64, ptr %642, align 8
  %705 = getelementptr inbounds i8, ptr %624, i64 24
  %706 = load i64, ptr %705, align 8
  %707 = icmp sgt i64 %706, 3
  br i1 %707, label %736, label %761

708:                                              ; preds = %647, %708
  %709 = phi i64 [ 0, %647 ], [ %731, %708 ]
  %710 = load ptr, ptr %86, align 8
  %711 = shl nsw i64 %709, 6
  %712 = getelementptr inbounds i8, ptr %710, i64 %711
  %713 = load <8 x double>, ptr %712, align 8
  %714 = load ptr, ptr %11, align 8
  %715 = getelementptr inbounds i8, ptr %714, i64 %711
  %716 = load <8 x double>, ptr %715, align 8
  %717 = fsub <8 x double> %713, %716
  %718 = load ptr, ptr %88, align 8
  %719 = getelementptr inbounds i8, ptr %718, i64 %711
  %720 = load <8 x double>, ptr %719, align 8
  %721 = fmul <8 x double> %247, %720
  %722 = fsub <8 x double> %721, %717
  %723 = getelementptr inbounds i8, ptr %633, i64 %711
  store <8 x double> %717, ptr %723, align 8
  %724 = getelementptr inbounds i8, ptr %648, i64 %711
  store <8 x double> %722, ptr %724, align 8
  %725 = fsub <8 x double> %717, %722
  %726 = getelementptr inbounds i8, ptr %632, i64 %711
  %727 = load <8 x double>, ptr %726, align 8
  %728 = fmul <8 x double> %247, %727
  %729 = fsub <8 x double> %725, %728
  %730 = getelementptr inbounds i8, ptr %650, i64 %711
  store <8 x double> %729, ptr %730, align 8
  %731 = add nuw nsw i64 %709, 1
  %732 = load ptr, ptr %9, align 8
  %733 = getelementptr inbounds i8, ptr %732, i64 8
  %734 = load i64, ptr %733, align 8
  %735 = icmp slt i64 %731, %734
  br i1 %735, label %708, label %701, !llvm.loop !15

736:                                              ; preds = %701, %736
  %737 = phi i64 [ %758, %736 ], [ 3, %701 ]
  %738 = mul nsw i64 %737, %629
  %739 = getelementptr inbounds double, ptr %633, i64 %738
  %740 = load ptr, ptr %124, align 8
  %741 = load ptr, ptr %87, align 8
  %742 = getelementptr i64, ptr %741, i64 %634
  %743 = getelementptr i64, ptr %742, i64 %703
  %744 = getelementptr i64, ptr %743, i64 %704
  %745 = getelementptr i64, ptr %744, i64 %737
  %746 = getelementptr i8, ptr %745, i64 -24
  %747 = load i64, ptr %746, align 8
  %748 = getelementptr i8, ptr %745, i64 -16
  %749 = load i64, ptr %748, align 8
  %750 = xor i64 %747, -1
  %751 = add i64 %749, %750
  %752 = load ptr, ptr %74, align 8
  %753 = load ptr, ptr %88, align 8
  %754 = load ptr, ptr %89, align 8
  %755 = getelementptr inbounds i64, ptr %754, i64 %747
  %756 = load ptr, ptr %90, align 8
  %757 = getelementptr inbounds double, ptr %756, i64 %747
  call fastcc void @combine(ptr noundef %739, ptr noundef %740, ptr noundef %752, ptr noundef %753, ptr noundef %755, ptr noundef %757, i64 noundef %751, i64 noundef %627) #10
  %758 = add nuw nsw i64 %737, 1
  %759 = load i64, ptr %705, align 8
  %760 = icmp slt i64 %758, %759
  br i1 %760, label %736, label %761, !llvm.loop !16

761:                                              ; preds = %736, %701
  %762 = and i64 %641, %621
  %763 = load ptr, ptr %109, align 8
  %764 = load <8 x double>, ptr %763, align 8
  %765 = trunc nuw i64 %621 to i8
  %766 = bitcast i8 %765 to <8 x i1>
  %767 = load i64, ptr %125, align 8
  %768 = sitofp i64 %767 to double
  %769 = insertelement <8 x double> poison, double %768, i64 0
  %770 = shufflevector <8 x double> %769, <8 x double> poison, <8 x i32> zeroinitializer
  %771 = select <8 x i1> %766, <8 x double> %770, <8 x double> zeroinitializer
  %772 = fadd <8 x double> %764, %771
  store <8 x double> %772, ptr %763, align 8
  %773 = icmp eq i64 %762, 0
  br i1 %773, label %778, label %774

774:                                              ; preds = %761
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %762, i64 noundef 3) #10
  %775 = xor i64 %762, -1
  %776 = and i64 %218, %775
  store i64 %776, ptr %5, align 8
  %777 = and i64 %613, %775
  br label %778

778:                                              ; preds = %774, %761
  %779 = phi i64 [ %777, %774 ], [ %613, %761 ]
  %780 = phi i32 [ 1, %774 ], [ %189, %761 ]
  store <8 x double> %245, ptr %3, align 16
  %781 = icmp eq i64 %779, 0
  br i1 %781, label %784, label %782

782:                                              ; preds = %778
  %783 = call fastcc i64 @look_for_events(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %779, ptr noundef nonnull %3, ptr noundef nonnull %6, ptr noundef nonnull %4, ptr noundef nonnull %7) #10
  br label %784

784:                                              ; preds = %782, %778
  %785 = phi i64 [ %783, %782 ], [ 0, %778 ]
  %786 = load i64, ptr %7, align 8
  %787 = or i64 %786, %641
  %788 = xor i64 %787, -1
  %789 = and i64 %621, %788
  %790 = icmp eq i64 %785, 0
  %791 = select i1 %790, ptr null, ptr %4
  %792 = call fastcc i64 @write_within(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %789, ptr noundef nonnull %3, ptr noundef %791) #10
  %793 = load <8 x double>, ptr %3, align 16
  br i1 %790, label %799, label %794

794:                                              ; preds = %784
  %795 = xor i64 %792, -1
  %796 = and i64 %785, %795
  %797 = call fastcc i64 @end_within(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %796, ptr noundef nonnull %3, ptr noundef nonnull %4) #10
  %798 = or i64 %797, %792
  br label %799

799:                                              ; preds = %794, %784
  %800 = phi i64 [ %798, %794 ], [ %792, %784 ]
  %801 = icmp ne i64 %800, 0
  %802 = select i1 %59, i1 %801, i1 false
  br i1 %802, label %803, label %808

803:                                              ; preds = %799
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %800, i64 noundef 6) #10
  %804 = xor i64 %800, -1
  %805 = load i64, ptr %5, align 8
  %806 = and i64 %805, %804
  store i64 %806, ptr %5, align 8
  %807 = and i64 %785, %804
  br label %808

808:                                              ; preds = %803, %799
  %809 = phi i32 [ 1, %803 ], [ %780, %799 ]
  %810 = phi i64 [ %807, %803 ], [ %785, %799 ]
  %811 = or i64 %800, %563
  %812 = or i64 %786, %762
  %813 = or i64 %812, %811
  %814 = trunc i64 %813 to i8
  %815 = xor i8 %814, -1
  %816 = bitcast i8 %815 to <8 x i1>
  %817 = select <8 x i1> %816, <8 x i64> %589, <8 x i64> zeroinitializer
  br label %818

818:                                              ; preds = %808, %612
  %819 = phi <8 x double> [ %245, %612 ], [ %793, %808 ]
  %820 = phi <8 x i64> [ %589, %612 ], [ %817, %808 ]
  %821 = phi i64 [ %563, %612 ], [ %811, %808 ]
  %822 = phi i32 [ %189, %612 ], [ %809, %808 ]
  %823 = phi i64 [ 0, %612 ], [ %810, %808 ]
  %824 = load ptr, ptr %115, align 8
  %825 = load <8 x double>, ptr %824, align 8
  %826 = fcmp oeq <8 x double> %825, %819
  %827 = icmp ne <8 x i64> %820, zeroinitializer
  %828 = select <8 x i1> %826, <8 x i1> %827, <8 x i1> zeroinitializer
  %829 = bitcast <8 x i1> %828 to i8
  %830 = icmp eq i8 %829, 0
  br i1 %830, label %833, label %831

831:                                              ; preds = %818
  %832 = zext i8 %829 to i64
  br label %842

833:                                              ; preds = %842, %818
  %834 = xor <8 x i64> %820, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %835 = select <8 x i1> %220, <8 x i64> %834, <8 x i64> zeroinitializer
  %836 = load ptr, ptr %70, align 8
  %837 = load <8 x double>, ptr %836, align 8
  %838 = icmp slt <8 x i64> %820, zeroinitializer
  %839 = select <8 x i1> %838, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %840 = bitcast <8 x i64> %839 to <8 x double>
  %841 = fadd <8 x double> %837, %840
  store <8 x double> %841, ptr %836, align 8
  br i1 %34, label %852, label %976

842:                                              ; preds = %831, %842
  %843 = phi i64 [ %850, %842 ], [ %832, %831 ]
  %844 = load ptr, ptr %126, align 8
  call fastcc void @write_outputs(ptr noundef %0, ptr noundef %844, i64 noundef %843) #10
  %845 = load ptr, ptr %115, align 8
  %846 = load <8 x double>, ptr %845, align 8
  %847 = fcmp oeq <8 x double> %846, %819
  %848 = bitcast <8 x i1> %847 to i8
  %849 = zext i8 %848 to i64
  %850 = and i64 %843, %849
  %851 = icmp eq i64 %850, 0
  br i1 %851, label %833, label %842, !llvm.loop !17

852:                                              ; preds = %833
  %853 = load ptr, ptr %127, align 8
  %854 = load <8 x double>, ptr %853, align 8
  %855 = load ptr, ptr %128, align 8
  %856 = load <8 x double>, ptr %855, align 8
  %857 = fcmp ogt <8 x double> %541, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %858 = bitcast <8 x double> %541 to <8 x i64>
  %859 = select <8 x i1> %857, <8 x i64> %858, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %860 = load double, ptr %129, align 8
  %861 = insertelement <8 x double> poison, double %860, i64 0
  %862 = shufflevector <8 x double> %861, <8 x double> poison, <8 x i32> zeroinitializer
  %863 = load double, ptr %130, align 8
  %864 = fneg double %863
  %865 = add <8 x i64> %859, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %866 = ashr <8 x i64> %865, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %867 = and <8 x i64> %865, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %868 = sub <8 x i64> %859, %867
  %869 = bitcast <8 x i64> %868 to <8 x double>
  %870 = fadd <8 x double> %869, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %871 = fadd <8 x double> %869, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %872 = fdiv <8 x double> %870, %871
  %873 = fmul <8 x double> %872, %872
  %874 = call <8 x double> @llvm.fma.v8f64(<8 x double> %873, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %875 = call <8 x double> @llvm.fma.v8f64(<8 x double> %874, <8 x double> %873, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %876 = call <8 x double> @llvm.fma.v8f64(<8 x double> %875, <8 x double> %873, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %877 = call <8 x double> @llvm.fma.v8f64(<8 x double> %876, <8 x double> %873, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %878 = trunc nsw <8 x i64> %866 to <8 x i32>
  %879 = sitofp <8 x i32> %878 to <8 x double>
  %880 = fmul <8 x double> %872, %877
  %881 = fadd <8 x double> %880, %879
  %882 = insertelement <8 x double> poison, double %864, i64 0
  %883 = shufflevector <8 x double> %882, <8 x double> poison, <8 x i32> zeroinitializer
  %884 = fmul <8 x double> %881, %883
  %885 = fcmp ogt <8 x double> %884, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %886 = bitcast <8 x double> %884 to <8 x i64>
  %887 = select <8 x i1> %885, <8 x i64> %886, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %888 = bitcast <8 x i64> %887 to <8 x double>
  %889 = fcmp olt <8 x double> %888, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %890 = bitcast <8 x i64> %887 to <8 x double>
  %891 = select <8 x i1> %889, <8 x double> %890, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %892 = call <8 x double> @llvm.rint.v8f64(<8 x double> %891)
  %893 = fsub <8 x double> %891, %892
  %894 = call <8 x double> @llvm.fma.v8f64(<8 x double> %893, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %895 = call <8 x double> @llvm.fma.v8f64(<8 x double> %894, <8 x double> %893, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %896 = call <8 x double> @llvm.fma.v8f64(<8 x double> %895, <8 x double> %893, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %897 = call <8 x double> @llvm.fma.v8f64(<8 x double> %896, <8 x double> %893, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %898 = call <8 x double> @llvm.fma.v8f64(<8 x double> %897, <8 x double> %893, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %899 = call <8 x double> @llvm.fma.v8f64(<8 x double> %898, <8 x double> %893, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %900 = call <8 x double> @llvm.fma.v8f64(<8 x double> %899, <8 x double> %893, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %901 = bitcast <8 x double> %900 to <8 x i64>
  %902 = fptosi <8 x double> %892 to <8 x i32>
  %903 = zext <8 x i32> %902 to <8 x i64>
  %904 = shl <8 x i64> %903, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %905 = add <8 x i64> %904, %901
  %906 = bitcast <8 x i64> %905 to <8 x double>
  %907 = fmul <8 x double> %862, %906
  %908 = load double, ptr %131, align 8
  %909 = fcmp une double %908, 0.000000e+00
  br i1 %909, label %910, label %955

910:                                              ; preds = %852
  %911 = bitcast <8 x double> %854 to <8 x i64>
  %912 = add <8 x i64> %911, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %913 = ashr <8 x i64> %912, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %914 = and <8 x i64> %912, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %915 = sub <8 x i64> %911, %914
  %916 = bitcast <8 x i64> %915 to <8 x double>
  %917 = fadd <8 x double> %916, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %918 = fadd <8 x double> %916, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %919 = fdiv <8 x double> %917, %918
  %920 = fmul <8 x double> %919, %919
  %921 = call <8 x double> @llvm.fma.v8f64(<8 x double> %920, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %922 = call <8 x double> @llvm.fma.v8f64(<8 x double> %921, <8 x double> %920, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %923 = call <8 x double> @llvm.fma.v8f64(<8 x double> %922, <8 x double> %920, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %924 = call <8 x double> @llvm.fma.v8f64(<8 x double> %923, <8 x double> %920, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %925 = trunc nsw <8 x i64> %913 to <8 x i32>
  %926 = sitofp <8 x i32> %925 to <8 x double>
  %927 = fmul <8 x double> %919, %924
  %928 = fadd <8 x double> %927, %926
  %929 = insertelement <8 x double> poison, double %908, i64 0
  %930 = shufflevector <8 x double> %929, <8 x double> poison, <8 x i32> zeroinitializer
  %931 = fmul <8 x double> %930, %928
  %932 = fcmp ogt <8 x double> %931, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %933 = bitcast <8 x double> %931 to <8 x i64>
  %934 = select <8 x i1> %932, <8 x i64> %933, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %935 = bitcast <8 x i64> %934 to <8 x double>
  %936 = fcmp olt <8 x double> %935, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %937 = bitcast <8 x i64> %934 to <8 x double>
  %938 = select <8 x i1> %936, <8 x double> %937, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %939 = call <8 x double> @llvm.rint.v8f64(<8 x double> %938)
  %940 = fsub <8 x double> %938, %939
  %941 = call <8 x double> @llvm.fma.v8f64(<8 x double> %940, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %942 = call <8 x double> @llvm.fma.v8f64(<8 x double> %941, <8 x double> %940, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %943 = call <8 x double> @llvm.fma.v8f64(<8 x double> %942, <8 x double> %940, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %944 = call <8 x double> @llvm.fma.v8f64(<8 x double> %943, <8 x double> %940, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %945 = call <8 x double> @llvm.fma.v8f64(<8 x double> %944, <8 x double> %940, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %946 = call <8 x double> @llvm.fma.v8f64(<8 x double> %945, <8 x double> %940, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %947 = call <8 x double> @llvm.fma.v8f64(<8 x double> %946, <8 x double> %940, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %948 = bitcast <8 x double> %947 to <8 x i64>
  %949 = fptosi <8 x double> %939 to <8 x i32>
  %950 = zext <8 x i32> %949 to <8 x i64>
  %951 = shl <8 x i64> %950, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %952 = add <8 x i64> %951, %948
  %953 = bitcast <8 x i64> %952 to <8 x double>
  %954 = fmul <8 x double> %907, %953
  br label %955

955:                                              ; preds = %852, %910
  %956 = phi <8 x double> [ %954, %910 ], [ %907, %852 ]
  %957 = load double, ptr %132, align 8
  %958 = insertelement <8 x double> poison, double %957, i64 0
  %959 = shufflevector <8 x double> %958, <8 x double> poison, <8 x i32> zeroinitializer
  %960 = fcmp ogt <8 x double> %956, %959
  %961 = select <8 x i1> %960, <8 x double> %956, <8 x double> %959
  %962 = fcmp olt <8 x double> %856, %961
  %963 = select <8 x i1> %962, <8 x double> %856, <8 x double> %961
  %964 = fmul <8 x double> %247, %963
  %965 = fcmp ogt <8 x double> %541, <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>
  %966 = select <8 x i1> %965, <8 x i64> %858, <8 x i64> <i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789>
  %967 = bitcast <8 x double> %854 to <8 x i64>
  %968 = select <8 x i1> %838, <8 x i64> %966, <8 x i64> %967
  store <8 x i64> %968, ptr %853, align 8
  %969 = load ptr, ptr %128, align 8
  %970 = load double, ptr %133, align 8
  %971 = insertelement <8 x double> poison, double %970, i64 0
  %972 = bitcast <8 x double> %971 to <8 x i64>
  %973 = shufflevector <8 x i64> %972, <8 x i64> poison, <8 x i32> zeroinitializer
  %974 = icmp slt <8 x i64> %835, zeroinitializer
  %975 = select <8 x i1> %974, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> %973
  store <8 x i64> %975, ptr %969, align 8
  br label %976

976:                                              ; preds = %955, %833
  %977 = phi <8 x double> [ %964, %955 ], [ %229, %833 ]
  %978 = icmp ne <8 x i64> %835, zeroinitializer
  %979 = bitcast <8 x i1> %978 to i8
  %980 = icmp eq i8 %979, 0
  br i1 %980, label %1074, label %981

981:                                              ; preds = %976
  %982 = trunc i64 %590 to i8
  %983 = bitcast i8 %982 to <8 x i1>
  %984 = trunc i64 %821 to i8
  %985 = bitcast i8 %984 to <8 x i1>
  %986 = load i64, ptr %7, align 8
  %987 = trunc i64 %986 to i8
  %988 = bitcast i8 %987 to <8 x i1>
  %989 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %541)
  %990 = fcmp one <8 x double> %989, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %991 = xor <8 x i1> %983, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %992 = select <8 x i1> %990, <8 x i1> %991, <8 x i1> zeroinitializer
  %993 = or <8 x i1> %988, %985
  %994 = xor <8 x i1> %993, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %995 = and <8 x i1> %992, %994
  br i1 %34, label %996, label %1055

996:                                              ; preds = %981
  %997 = fcmp ogt <8 x double> %541, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %998 = bitcast <8 x double> %541 to <8 x i64>
  %999 = select <8 x i1> %997, <8 x i64> %998, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %1000 = load double, ptr %134, align 8
  %1001 = insertelement <8 x double> poison, double %1000, i64 0
  %1002 = shufflevector <8 x double> %1001, <8 x double> poison, <8 x i32> zeroinitializer
  %1003 = load double, ptr %31, align 8
  %1004 = fneg double %1003
  %1005 = add <8 x i64> %999, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %1006 = ashr <8 x i64> %1005, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1007 = and <8 x i64> %1005, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %1008 = sub <8 x i64> %999, %1007
  %1009 = bitcast <8 x i64> %1008 to <8 x double>
  %1010 = fadd <8 x double> %1009, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %1011 = fadd <8 x double> %1009, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1012 = fdiv <8 x double> %1010, %1011
  %1013 = fmul <8 x double> %1012, %1012
  %1014 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1013, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %1015 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1014, <8 x double> %1013, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %1016 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1015, <8 x double> %1013, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %1017 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1016, <8 x double> %1013, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %1018 = trunc nsw <8 x i64> %1006 to <8 x i32>
  %1019 = sitofp <8 x i32> %1018 to <8 x double>
  %1020 = fmul <8 x double> %1012, %1017
  %1021 = fadd <8 x double> %1020, %1019
  %1022 = insertelement <8 x double> poison, double %1004, i64 0
  %1023 = shufflevector <8 x double> %1022, <8 x double> poison, <8 x i32> zeroinitializer
  %1024 = fmul <8 x double> %1021, %1023
  %1025 = fcmp ogt <8 x double> %1024, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1026 = bitcast <8 x double> %1024 to <8 x i64>
  %1027 = select <8 x i1> %1025, <8 x i64> %1026, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1028 = bitcast <8 x i64> %1027 to <8 x double>
  %1029 = fcmp olt <8 x double> %1028, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1030 = bitcast <8 x i64> %1027 to <8 x double>
  %1031 = select <8 x i1> %1029, <8 x double> %1030, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1032 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1031)
  %1033 = fsub <8 x double> %1031, %1032
  %1034 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1033, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1035 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1034, <8 x double> %1033, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1036 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1035, <8 x double> %1033, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1037 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1036, <8 x double> %1033, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1038 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1037, <8 x double> %1033, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1039 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1038, <8 x double> %1033, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1040 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1039, <8 x double> %1033, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1041 = bitcast <8 x double> %1040 to <8 x i64>
  %1042 = fptosi <8 x double> %1032 to <8 x i32>
  %1043 = zext <8 x i32> %1042 to <8 x i64>
  %1044 = shl <8 x i64> %1043, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1045 = add <8 x i64> %1044, %1041
  %1046 = bitcast <8 x i64> %1045 to <8 x double>
  %1047 = fmul <8 x double> %1002, %1046
  %1048 = load double, ptr %135, align 8
  %1049 = insertelement <8 x double> poison, double %1048, i64 0
  %1050 = shufflevector <8 x double> %1049, <8 x double> poison, <8 x i32> zeroinitializer
  %1051 = fcmp ogt <8 x double> %1047, %1050
  %1052 = select <8 x i1> %1051, <8 x double> %1047, <8 x double> %1050
  %1053 = select <8 x i1> %995, <8 x double> %1052, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1054 = fmul <8 x double> %247, %1053
  br label %1055

1055:                                             ; preds = %981, %996
  %1056 = phi <8 x double> [ %1054, %996 ], [ zeroinitializer, %981 ]
  %1057 = or <8 x i1> %995, %988
  %1058 = select <8 x i1> %1057, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %1059 = icmp slt <8 x i64> %835, zeroinitializer
  %1060 = select <8 x i1> %1059, <8 x double> %1056, <8 x double> %977
  %1061 = load ptr, ptr %136, align 8
  %1062 = select <8 x i1> %985, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> %1058
  %1063 = load <8 x i64>, ptr %1061, align 8
  %1064 = select <8 x i1> %1059, <8 x i64> %1062, <8 x i64> %1063
  store <8 x i64> %1064, ptr %1061, align 8
  %1065 = load ptr, ptr %136, align 8
  %1066 = select <8 x i1> %983, <8 x i64> <i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152>, <8 x i64> %1058
  %1067 = load <8 x i64>, ptr %1065, align 8
  %1068 = select <8 x i1> %1059, <8 x i64> %1066, <8 x i64> %1067
  store <8 x i64> %1068, ptr %1065, align 8
  %1069 = load ptr, ptr %71, align 8
  %1070 = load <8 x double>, ptr %1069, align 8
  %1071 = select <8 x i1> %1059, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %1072 = bitcast <8 x i64> %1071 to <8 x double>
  %1073 = fadd <8 x double> %1070, %1072
  store <8 x double> %1073, ptr %1069, align 8
  br label %1074

1074:                                             ; preds = %1055, %976
  %1075 = phi <8 x double> [ %977, %976 ], [ %1060, %1055 ]
  %1076 = load ptr, ptr %67, align 8
  store <8 x double> %1075, ptr %1076, align 8
  %1077 = load ptr, ptr %54, align 8
  %1078 = select <8 x i1> %838, <8 x double> %819, <8 x double> %222
  store <8 x double> %1078, ptr %1077, align 8
  br i1 %137, label %1081, label %1079

1079:                                             ; preds = %1081, %1074
  %1080 = icmp eq i64 %823, 0
  br i1 %1080, label %1108, label %1099

1081:                                             ; preds = %1074, %1081
  %1082 = phi i64 [ %1097, %1081 ], [ 0, %1074 ]
  %1083 = load ptr, ptr %11, align 8
  %1084 = load ptr, ptr %138, align 8
  %1085 = shl nsw i64 %1082, 6
  %1086 = getelementptr inbounds i8, ptr %1084, i64 %1085
  %1087 = load <8 x i64>, ptr %1086, align 8
  %1088 = getelementptr inbounds i8, ptr %1083, i64 %1085
  %1089 = load <8 x i64>, ptr %1088, align 8
  %1090 = select <8 x i1> %838, <8 x i64> %1087, <8 x i64> %1089
  store <8 x i64> %1090, ptr %1088, align 8
  %1091 = load ptr, ptr %45, align 8
  %1092 = getelementptr inbounds i8, ptr %60, i64 %1085
  %1093 = load <8 x i64>, ptr %1092, align 8
  %1094 = getelementptr inbounds i8, ptr %1091, i64 %1085
  %1095 = load <8 x i64>, ptr %1094, align 8
  %1096 = select <8 x i1> %838, <8 x i64> %1093, <8 x i64> %1095
  store <8 x i64> %1096, ptr %1094, align 8
  %1097 = add nuw nsw i64 %1082, 1
  %1098 = icmp eq i64 %1097, %15
  br i1 %1098, label %1079, label %1081, !llvm.loop !18

1099:                                             ; preds = %1079
  %1100 = call fastcc i64 @act_in_lanes(ptr noundef %0, i64 noundef %823, ptr noundef nonnull %6) #10
  %1101 = icmp ne i32 %822, 0
  %1102 = icmp ne i64 %1100, %823
  %1103 = select i1 %1101, i1 true, i1 %1102
  %1104 = zext i1 %1103 to i32
  %1105 = trunc i64 %823 to i8
  %1106 = bitcast i8 %1105 to <8 x i1>
  %1107 = select <8 x i1> %1106, <8 x i64> zeroinitializer, <8 x i64> %820
  br label %1108

1108:                                             ; preds = %1099, %1079
  %1109 = phi <8 x i64> [ %1107, %1099 ], [ %820, %1079 ]
  %1110 = phi i32 [ %1104, %1099 ], [ %822, %1079 ]
  %1111 = phi i64 [ %1100, %1099 ], [ %190, %1079 ]
  %1112 = load ptr, ptr %115, align 8
  %1113 = load <8 x double>, ptr %1112, align 8
  %1114 = fcmp oeq <8 x double> %1113, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1115 = icmp ne <8 x i64> %1109, zeroinitializer
  %1116 = select <8 x i1> %1114, <8 x i1> %1115, <8 x i1> zeroinitializer
  %1117 = bitcast <8 x i1> %1116 to i8
  %1118 = icmp eq i8 %1117, 0
  br i1 %1118, label %1121, label %1119

1119:                                             ; preds = %1108
  %1120 = zext i8 %1117 to i64
  call fastcc void @retire(ptr noundef %0, i64 noundef %1120, i64 noundef 0) #10
  br label %1121

1121:                                             ; preds = %1119, %1108
  %1122 = phi i32 [ 1, %1119 ], [ %1110, %1108 ]
  br label %185

1123:                                             ; preds = %188, %213, %181
  %1124 = phi i64 [ 1, %181 ], [ 0, %213 ], [ 0, %188 ]
  ret i64 %1124
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

39:                                               ; preds = %2, %274
  %40 = phi i64 [ 0, %2 ], [ %284, %274 ]
  %41 = phi i64 [ 0, %2 ], [ %275, %274 ]
  %42 = phi i64 [ -1, %2 ], [ %283, %274 ]
  %43 = phi i64 [ 0, %2 ], [ %282, %274 ]
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

55:                                               ; preds = %274
  %56 = getelementptr inbounds i8, ptr %0, i64 144
  store i64 %282, ptr %1, align 8
  %57 = icmp slt i64 %283, 0
  br i1 %57, label %389, label %58

58:                                               ; preds = %55
  %59 = getelementptr inbounds i8, ptr %0, i64 888
  %60 = getelementptr inbounds i8, ptr %0, i64 552
  %61 = getelementptr inbounds i8, ptr %0, i64 192
  %62 = getelementptr inbounds i8, ptr %0, i64 216
  %63 = getelementptr inbounds i8, ptr %0, i64 672
  %64 = getelementptr inbounds i8, ptr %0, i64 768
  br label %309

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
  br i1 %85, label %274, label %86

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
  br i1 %164, label %165, label %267

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
  br i1 %194, label %195, label %263

195:                                              ; preds = %190
  %196 = getelementptr inbounds i8, ptr %169, i64 1200
  %197 = getelementptr inbounds i8, ptr %169, i64 960
  br label %218

198:                                              ; preds = %174, %198
  %199 = phi i64 [ %215, %198 ], [ 0, %174 ]
  %200 = load ptr, ptr %29, align 8
  %201 = load i64, ptr %30, align 8
  %202 = mul nsw i64 %201, %199
  %203 = getelementptr inbounds i64, ptr %200, i64 %202
  %204 = load i64, ptr %203, align 8
  %205 = inttoptr i64 %204 to ptr
  %206 = load ptr, ptr %205, align 8
  %207 = load ptr, ptr %16, align 8
  %208 = load i64, ptr %31, align 8
  %209 = mul nsw i64 %208, %79
  %210 = getelementptr inbounds double, ptr %207, i64 %209
  %211 = getelementptr i64, ptr %203, i64 %40
  %212 = getelementptr i8, ptr %211, i64 8
  %213 = load i64, ptr %212, align 8
  %214 = inttoptr i64 %213 to ptr
  tail call void %206(ptr noundef %210, ptr noundef %214) #11
  %215 = add nuw nsw i64 %199, 1
  %216 = load i64, ptr %28, align 8
  %217 = icmp slt i64 %215, %216
  br i1 %217, label %198, label %190, !llvm.loop !23

218:                                              ; preds = %195, %232
  %219 = phi i64 [ 0, %195 ], [ %241, %232 ]
  %220 = load ptr, ptr %32, align 8
  %221 = load i64, ptr %33, align 8
  %222 = mul nsw i64 %221, %79
  %223 = getelementptr i64, ptr %220, i64 %222
  %224 = getelementptr i64, ptr %223, i64 %219
  %225 = load i64, ptr %224, align 8
  %226 = sitofp i64 %225 to double
  %227 = load ptr, ptr %34, align 8
  %228 = shl i64 %219, 6
  %229 = getelementptr i8, ptr %227, i64 %228
  %230 = getelementptr double, ptr %229, i64 %40
  store double %226, ptr %230, align 8
  %231 = mul i64 %219, 800
  br label %246

232:                                              ; preds = %256
  %233 = load ptr, ptr %197, align 8
  %234 = shl nuw nsw i64 %219, 1
  %235 = or disjoint i64 %234, 1
  %236 = getelementptr inbounds double, ptr %233, i64 %235
  store double 0x7FF8000000000000, ptr %236, align 8
  %237 = load ptr, ptr %197, align 8
  %238 = getelementptr inbounds double, ptr %237, i64 %234
  store double 0x7FF8000000000000, ptr %238, align 8
  %239 = load ptr, ptr %37, align 8
  %240 = getelementptr inbounds double, ptr %239, i64 %40
  store double 0x7FF8000000000000, ptr %240, align 8
  %241 = add nuw nsw i64 %219, 1
  %242 = load ptr, ptr %25, align 8
  %243 = getelementptr inbounds i8, ptr %242, i64 8
  %244 = load i64, ptr %243, align 8
  %245 = icmp slt i64 %241, %244
  br i1 %245, label %218, label %263, !llvm.loop !24

246:                                              ; preds = %218, %256
  %247 = phi i64 [ 0, %218 ], [ %261, %256 ]
  %248 = icmp eq i64 %247, 0
  br i1 %248, label %249, label %256

249:                                              ; preds = %246
  %250 = load ptr, ptr %35, align 8
  %251 = load i64, ptr %36, align 8
  %252 = mul nsw i64 %251, %79
  %253 = getelementptr double, ptr %250, i64 %252
  %254 = getelementptr double, ptr %253, i64 %219
  %255 = load double, ptr %254, align 8
  br label %256

256:                                              ; preds = %249, %246
  %257 = phi double [ %255, %249 ], [ 0xFFF0000000000000, %246 ]
  %258 = load ptr, ptr %196, align 8
  %259 = getelementptr inbounds i8, ptr %258, i64 %231
  %260 = getelementptr inbounds double, ptr %259, i64 %247
  store double %257, ptr %260, align 8
  %261 = add nuw nsw i64 %247, 1
  %262 = icmp eq i64 %261, 100
  br i1 %262, label %232, label %246, !llvm.loop !25

263:                                              ; preds = %232, %190
  %264 = getelementptr inbounds i8, ptr %169, i64 600
  %265 = load ptr, ptr %264, align 8
  %266 = getelementptr inbounds i8, ptr %265, i64 80
  store i64 0, ptr %266, align 8
  br label %267

267:                                              ; preds = %263, %162
  %268 = load ptr, ptr %38, align 8
  %269 = load double, ptr %268, align 8
  %270 = load ptr, ptr %3, align 8
  %271 = getelementptr inbounds double, ptr %270, i64 %40
  store double %269, ptr %271, align 8
  %272 = shl nuw nsw i64 1, %40
  %273 = or i64 %272, %41
  br label %274

274:                                              ; preds = %78, %267
  %275 = phi i64 [ %273, %267 ], [ %41, %78 ]
  %276 = load ptr, ptr %10, align 8
  %277 = getelementptr inbounds i64, ptr %276, i64 %40
  %278 = load i64, ptr %277, align 8
  %279 = icmp sgt i64 %278, -1
  %280 = shl nuw nsw i64 1, %40
  %281 = select i1 %279, i64 %280, i64 0
  %282 = or i64 %281, %43
  %283 = select i1 %279, i64 %40, i64 %42
  %284 = add nuw nsw i64 %40, 1
  %285 = icmp eq i64 %284, 8
  br i1 %285, label %55, label %39, !llvm.loop !26

286:                                              ; preds = %386
  %287 = getelementptr inbounds i8, ptr %0, i64 272
  %288 = load i64, ptr %287, align 8
  %289 = icmp sgt i64 %288, 0
  br i1 %289, label %290, label %389

290:                                              ; preds = %286
  %291 = getelementptr inbounds i8, ptr %0, i64 264
  %292 = getelementptr inbounds i8, ptr %0, i64 216
  br label %293

293:                                              ; preds = %290, %293
  %294 = phi i64 [ 0, %290 ], [ %306, %293 ]
  %295 = load ptr, ptr %291, align 8
  %296 = shl nuw nsw i64 %294, 1
  %297 = getelementptr inbounds i64, ptr %295, i64 %296
  %298 = load i64, ptr %297, align 8
  %299 = inttoptr i64 %298 to ptr
  %300 = load ptr, ptr %299, align 8
  %301 = load ptr, ptr %292, align 8
  %302 = or disjoint i64 %296, 1
  %303 = getelementptr inbounds i64, ptr %295, i64 %302
  %304 = load i64, ptr %303, align 8
  %305 = inttoptr i64 %304 to ptr
  tail call void %300(ptr noundef %301, ptr noundef %305) #11
  %306 = add nuw nsw i64 %294, 1
  %307 = load i64, ptr %287, align 8
  %308 = icmp slt i64 %306, %307
  br i1 %308, label %293, label %389, !llvm.loop !27

309:                                              ; preds = %58, %386
  %310 = phi i64 [ 0, %58 ], [ %387, %386 ]
  %311 = load ptr, ptr %59, align 8
  %312 = getelementptr inbounds i64, ptr %311, i64 %310
  %313 = load i64, ptr %312, align 8
  %314 = icmp eq i64 %313, -1
  br i1 %314, label %315, label %386

315:                                              ; preds = %309
  %316 = load ptr, ptr %5, align 8
  %317 = load ptr, ptr %56, align 8
  %318 = getelementptr inbounds i8, ptr %317, i64 8
  %319 = load i64, ptr %318, align 8
  %320 = icmp sgt i64 %319, 0
  br i1 %320, label %321, label %330

321:                                              ; preds = %315, %321
  %322 = phi i64 [ %328, %321 ], [ 0, %315 ]
  %323 = shl i64 %322, 6
  %324 = getelementptr i8, ptr %316, i64 %323
  %325 = getelementptr double, ptr %324, i64 %283
  %326 = load double, ptr %325, align 8
  %327 = getelementptr double, ptr %324, i64 %310
  store double %326, ptr %327, align 8
  %328 = add nuw nsw i64 %322, 1
  %329 = icmp eq i64 %328, %319
  br i1 %329, label %330, label %321, !llvm.loop !28

330:                                              ; preds = %321, %315
  %331 = load ptr, ptr %60, align 8
  %332 = load ptr, ptr %56, align 8
  %333 = getelementptr inbounds i8, ptr %332, i64 8
  %334 = load i64, ptr %333, align 8
  %335 = icmp sgt i64 %334, 0
  br i1 %335, label %336, label %345

336:                                              ; preds = %330, %336
  %337 = phi i64 [ %343, %336 ], [ 0, %330 ]
  %338 = shl i64 %337, 6
  %339 = getelementptr i8, ptr %331, i64 %338
  %340 = getelementptr double, ptr %339, i64 %283
  %341 = load double, ptr %340, align 8
  %342 = getelementptr double, ptr %339, i64 %310
  store double %341, ptr %342, align 8
  %343 = add nuw nsw i64 %337, 1
  %344 = icmp eq i64 %343, %334
  br i1 %344, label %345, label %336, !llvm.loop !28

345:                                              ; preds = %336, %330
  %346 = load ptr, ptr %61, align 8
  %347 = load ptr, ptr %56, align 8
  %348 = getelementptr inbounds i8, ptr %347, i64 40
  %349 = load i64, ptr %348, align 8
  %350 = icmp sgt i64 %349, 0
  br i1 %350, label %351, label %360

351:                                              ; preds = %345, %351
  %352 = phi i64 [ %358, %351 ], [ 0, %345 ]
  %353 = shl i64 %352, 6
  %354 = getelementptr i8, ptr %346, i64 %353
  %355 = getelementptr double, ptr %354, i64 %283
  %356 = load double, ptr %355, align 8
  %357 = getelementptr double, ptr %354, i64 %310
  store double %356, ptr %357, align 8
  %358 = add nuw nsw i64 %352, 1
  %359 = icmp eq i64 %358, %349
  br i1 %359, label %360, label %351, !llvm.loop !28

360:                                              ; preds = %351, %345
  %361 = load ptr, ptr %62, align 8
  %362 = load ptr, ptr %56, align 8
  %363 = getelementptr inbounds i8, ptr %362, i64 48
  %364 = load i64, ptr %363, align 8
  %365 = icmp sgt i64 %364, 0
  br i1 %365, label %366, label %375

366:                                              ; preds = %360, %366
  %367 = phi i64 [ %373, %366 ], [ 0, %360 ]
  %368 = shl i64 %367, 6
  %369 = getelementptr i8, ptr %361, i64 %368
  %370 = getelementptr double, ptr %369, i64 %283
  %371 = load double, ptr %370, align 8
  %372 = getelementptr double, ptr %369, i64 %310
  store double %371, ptr %372, align 8
  %373 = add nuw nsw i64 %367, 1
  %374 = icmp eq i64 %373, %364
  br i1 %374, label %375, label %366, !llvm.loop !28

375:                                              ; preds = %366, %360
  %376 = load ptr, ptr %3, align 8
  %377 = getelementptr inbounds double, ptr %376, i64 %283
  %378 = load double, ptr %377, align 8
  %379 = getelementptr inbounds double, ptr %376, i64 %310
  store double %378, ptr %379, align 8
  %380 = load ptr, ptr %63, align 8
  %381 = getelementptr inbounds double, ptr %380, i64 %310
  store double 0.000000e+00, ptr %381, align 8
  %382 = load ptr, ptr %64, align 8
  %383 = getelementptr inbounds double, ptr %382, i64 %310
  store double 0x7FF0000000000000, ptr %383, align 8
  %384 = load ptr, ptr %59, align 8
  %385 = getelementptr inbounds i64, ptr %384, i64 %310
  store i64 -2, ptr %385, align 8
  br label %386

386:                                              ; preds = %309, %375
  %387 = add nuw nsw i64 %310, 1
  %388 = icmp eq i64 %387, 8
  br i1 %388, label %286, label %309, !llvm.loop !29

389:                                              ; preds = %293, %286, %55
  ret i64 %275
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
  tail call fastcc void @sample(ptr noundef %20) #10
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
  %39 = load ptr, ptr %38, align 8
  %40 = tail call i32 %39(ptr noundef %33, ptr noundef %21, ptr noundef %35, ptr noundef %37, ptr noundef %23) #11
  %41 = sext i32 %40 to i64
  %42 = load ptr, ptr %19, align 8
  %43 = load ptr, ptr %42, align 8
  %44 = getelementptr inbounds i8, ptr %43, i64 8
  %45 = load i64, ptr %44, align 8
  %46 = icmp sgt i64 %45, 0
  br i1 %46, label %47, label %49

47:                                               ; preds = %30
  %48 = getelementptr inbounds i8, ptr %11, i64 168
  br label %57

49:                                               ; preds = %57, %30
  %50 = phi ptr [ %43, %30 ], [ %69, %57 ]
  %51 = getelementptr inbounds i8, ptr %0, i64 960
  %52 = load ptr, ptr %51, align 8
  %53 = getelementptr inbounds i8, ptr %52, i64 8
  %54 = load double, ptr %53, align 8
  %55 = load double, ptr %52, align 8
  %56 = fcmp oeq double %54, 0.000000e+00
  br i1 %56, label %80, label %73

57:                                               ; preds = %47, %57
  %58 = phi i64 [ 0, %47 ], [ %67, %57 ]
  %59 = load ptr, ptr %48, align 8
  %60 = load ptr, ptr %22, align 8
  %61 = shl nsw i64 %58, 6
  %62 = getelementptr inbounds i8, ptr %60, i64 %61
  %63 = load <8 x i64>, ptr %62, align 8
  %64 = getelementptr inbounds i8, ptr %59, i64 %61
  %65 = load <8 x i64>, ptr %64, align 8
  %66 = select <8 x i1> %16, <8 x i64> %63, <8 x i64> %65
  store <8 x i64> %66, ptr %64, align 8
  %67 = add nuw nsw i64 %58, 1
  %68 = load ptr, ptr %19, align 8
  %69 = load ptr, ptr %68, align 8
  %70 = getelementptr inbounds i8, ptr %69, i64 8
  %71 = load i64, ptr %70, align 8
  %72 = icmp slt i64 %67, %71
  br i1 %72, label %57, label %49, !llvm.loop !30

73:                                               ; preds = %49
  %74 = load ptr, ptr %1, align 8
  %75 = load ptr, ptr %74, align 8
  %76 = getelementptr inbounds i8, ptr %75, i64 8
  %77 = load i64, ptr %76, align 8
  %78 = icmp sgt i64 %77, 0
  %79 = select i1 %78, i64 %3, i64 0
  br label %80

80:                                               ; preds = %49, %73
  %81 = phi i64 [ %79, %73 ], [ %14, %49 ]
  %82 = insertelement <8 x double> poison, double %54, i64 0
  %83 = shufflevector <8 x double> %82, <8 x double> poison, <8 x i32> zeroinitializer
  %84 = icmp eq i64 %81, 0
  br i1 %84, label %255, label %85

85:                                               ; preds = %80
  %86 = trunc i64 %81 to i8
  %87 = bitcast i8 %86 to <8 x i1>
  %88 = load ptr, ptr %10, align 8
  %89 = getelementptr inbounds i8, ptr %50, i64 24
  %90 = load i64, ptr %89, align 8
  %91 = load ptr, ptr %88, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %91, ptr noundef %91, ptr noundef nonnull %88, i64 noundef %90) #10
  %92 = load <8 x double>, ptr %5, align 16
  %93 = getelementptr inbounds i8, ptr %88, i64 168
  %94 = load ptr, ptr %93, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %94, ptr noundef %91, ptr noundef nonnull %88, i64 noundef %90) #10
  %95 = load <8 x double>, ptr %6, align 16
  %96 = fcmp olt <8 x double> %92, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %97 = fcmp olt <8 x double> %95, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %98 = or <8 x i1> %97, %96
  %99 = insertelement <8 x double> poison, double %55, i64 0
  %100 = shufflevector <8 x double> %99, <8 x double> poison, <8 x i32> zeroinitializer
  %101 = fmul <8 x double> %92, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %102 = fdiv <8 x double> %101, %95
  %103 = bitcast <8 x double> %102 to <8 x i64>
  %104 = select <8 x i1> %98, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %103
  %105 = bitcast <8 x i64> %104 to <8 x double>
  %106 = fcmp olt <8 x double> %100, %105
  %107 = bitcast <8 x double> %100 to <8 x i64>
  %108 = select <8 x i1> %106, <8 x i64> %107, <8 x i64> %104
  %109 = bitcast <8 x i64> %108 to <8 x double>
  %110 = load ptr, ptr %19, align 8
  %111 = load ptr, ptr %110, align 8
  %112 = getelementptr inbounds i8, ptr %111, i64 8
  %113 = load i64, ptr %112, align 8
  %114 = icmp sgt i64 %113, 0
  br i1 %114, label %115, label %136

115:                                              ; preds = %85
  %116 = getelementptr inbounds i8, ptr %88, i64 48
  br label %117

117:                                              ; preds = %115, %117
  %118 = phi i64 [ 0, %115 ], [ %130, %117 ]
  %119 = load ptr, ptr %116, align 8
  %120 = load ptr, ptr %88, align 8
  %121 = shl nsw i64 %118, 6
  %122 = getelementptr inbounds i8, ptr %120, i64 %121
  %123 = load <8 x double>, ptr %122, align 8
  %124 = load ptr, ptr %93, align 8
  %125 = getelementptr inbounds i8, ptr %124, i64 %121
  %126 = load <8 x double>, ptr %125, align 8
  %127 = fmul <8 x double> %126, %109
  %128 = fadd <8 x double> %123, %127
  %129 = getelementptr inbounds i8, ptr %119, i64 %121
  store <8 x double> %128, ptr %129, align 8
  %130 = add nuw nsw i64 %118, 1
  %131 = load ptr, ptr %19, align 8
  %132 = load ptr, ptr %131, align 8
  %133 = getelementptr inbounds i8, ptr %132, i64 8
  %134 = load i64, ptr %133, align 8
  %135 = icmp slt i64 %130, %134
  br i1 %135, label %117, label %136, !llvm.loop !31

136:                                              ; preds = %117, %85
  %137 = phi ptr [ %110, %85 ], [ %131, %117 ]
  %138 = fadd <8 x double> %18, %109
  %139 = getelementptr inbounds i8, ptr %88, i64 48
  %140 = load ptr, ptr %139, align 8
  %141 = load ptr, ptr %93, align 8
  %142 = getelementptr inbounds i8, ptr %88, i64 8
  %143 = load i64, ptr %142, align 8
  %144 = getelementptr inbounds double, ptr %141, i64 %143
  %145 = getelementptr inbounds i8, ptr %137, i64 24
  %146 = load ptr, ptr %145, align 8
  store <8 x double> %138, ptr %146, align 8
  %147 = getelementptr inbounds i8, ptr %137, i64 152
  %148 = load i64, ptr %147, align 8
  %149 = icmp sgt i64 %148, 0
  br i1 %149, label %150, label %151

150:                                              ; preds = %136
  tail call fastcc void @sample(ptr noundef nonnull %137) #10
  br label %151

151:                                              ; preds = %136, %150
  %152 = load ptr, ptr %137, align 8
  %153 = load i64, ptr %152, align 8
  %154 = load ptr, ptr %145, align 8
  %155 = getelementptr inbounds i8, ptr %137, i64 48
  %156 = load ptr, ptr %155, align 8
  %157 = getelementptr inbounds i8, ptr %137, i64 96
  %158 = load ptr, ptr %157, align 8
  %159 = inttoptr i64 %153 to ptr
  %160 = load ptr, ptr %159, align 8
  %161 = tail call i32 %160(ptr noundef %154, ptr noundef %140, ptr noundef %156, ptr noundef %158, ptr noundef %144) #11
  %162 = load ptr, ptr %1, align 8
  %163 = getelementptr inbounds i8, ptr %162, i64 120
  %164 = load ptr, ptr %163, align 8
  %165 = load double, ptr %164, align 8
  %166 = load ptr, ptr %93, align 8
  %167 = load i64, ptr %142, align 8
  %168 = getelementptr inbounds double, ptr %166, i64 %167
  %169 = icmp sgt i64 %90, 0
  br i1 %169, label %170, label %180

170:                                              ; preds = %151, %170
  %171 = phi i64 [ %178, %170 ], [ 0, %151 ]
  %172 = shl nsw i64 %171, 6
  %173 = getelementptr inbounds i8, ptr %168, i64 %172
  %174 = load <8 x double>, ptr %173, align 8
  %175 = getelementptr inbounds i8, ptr %166, i64 %172
  %176 = load <8 x double>, ptr %175, align 8
  %177 = fsub <8 x double> %174, %176
  store <8 x double> %177, ptr %173, align 8
  %178 = add nuw nsw i64 %171, 1
  %179 = icmp eq i64 %178, %90
  br i1 %179, label %180, label %170, !llvm.loop !32

180:                                              ; preds = %170, %151
  %181 = load ptr, ptr %88, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %168, ptr noundef %181, ptr noundef nonnull %88, i64 noundef %90) #10
  %182 = load <8 x double>, ptr %7, align 16
  %183 = fdiv <8 x double> %182, %109
  %184 = fcmp ogt <8 x double> %95, %183
  %185 = select <8 x i1> %184, <8 x double> %95, <8 x double> %183
  %186 = fcmp ogt <8 x double> %185, <double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15>
  %187 = fdiv <8 x double> <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>, %185
  %188 = select <8 x i1> %186, <8 x double> %187, <8 x double> <double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13>
  %189 = bitcast <8 x double> %188 to <8 x i64>
  %190 = add <8 x i64> %189, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %191 = ashr <8 x i64> %190, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %192 = and <8 x i64> %190, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %193 = sub <8 x i64> %189, %192
  %194 = bitcast <8 x i64> %193 to <8 x double>
  %195 = fadd <8 x double> %194, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %196 = fadd <8 x double> %194, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %197 = fdiv <8 x double> %195, %196
  %198 = fmul <8 x double> %197, %197
  %199 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %198, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %200 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %199, <8 x double> %198, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %201 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %200, <8 x double> %198, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %202 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %201, <8 x double> %198, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %203 = trunc nsw <8 x i64> %191 to <8 x i32>
  %204 = sitofp <8 x i32> %203 to <8 x double>
  %205 = fmul <8 x double> %197, %202
  %206 = fadd <8 x double> %205, %204
  %207 = insertelement <8 x double> poison, double %165, i64 0
  %208 = shufflevector <8 x double> %207, <8 x double> poison, <8 x i32> zeroinitializer
  %209 = fmul <8 x double> %208, %206
  %210 = fcmp ogt <8 x double> %209, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %211 = bitcast <8 x double> %209 to <8 x i64>
  %212 = select <8 x i1> %210, <8 x i64> %211, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %213 = bitcast <8 x i64> %212 to <8 x double>
  %214 = fcmp olt <8 x double> %213, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %215 = bitcast <8 x i64> %212 to <8 x double>
  %216 = select <8 x i1> %214, <8 x double> %215, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %217 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %216)
  %218 = fsub <8 x double> %216, %217
  %219 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %218, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %220 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %219, <8 x double> %218, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %221 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %220, <8 x double> %218, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %222 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %221, <8 x double> %218, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %223 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %222, <8 x double> %218, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %224 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %223, <8 x double> %218, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %225 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %224, <8 x double> %218, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %226 = bitcast <8 x double> %225 to <8 x i64>
  %227 = fptosi <8 x double> %217 to <8 x i32>
  %228 = zext <8 x i32> %227 to <8 x i64>
  %229 = shl <8 x i64> %228, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %230 = add <8 x i64> %229, %226
  %231 = fmul <8 x double> %109, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %232 = fcmp olt <8 x double> %231, <double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D>
  %233 = bitcast <8 x double> %231 to <8 x i64>
  %234 = select <8 x i1> %232, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %233
  %235 = fmul <8 x double> %109, <double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02>
  %236 = select <8 x i1> %186, <8 x i64> %230, <8 x i64> %234
  %237 = bitcast <8 x i64> %236 to <8 x double>
  %238 = fcmp olt <8 x double> %235, %237
  %239 = bitcast <8 x double> %235 to <8 x i64>
  %240 = select <8 x i1> %238, <8 x i64> %239, <8 x i64> %236
  %241 = bitcast <8 x i64> %240 to <8 x double>
  %242 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %18)
  %243 = fmul <8 x double> %242, <double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000>
  %244 = fcmp ogt <8 x double> %243, %241
  %245 = bitcast <8 x double> %243 to <8 x i64>
  %246 = select <8 x i1> %244, <8 x i64> %245, <8 x i64> %240
  %247 = bitcast <8 x i64> %246 to <8 x double>
  %248 = fcmp olt <8 x double> %100, %247
  %249 = select <8 x i1> %248, <8 x i64> %107, <8 x i64> %246
  %250 = trunc i32 %161 to i8
  %251 = bitcast i8 %250 to <8 x i1>
  %252 = select <8 x i1> %251, <8 x i64> %233, <8 x i64> %249
  %253 = bitcast <8 x i64> %252 to <8 x double>
  %254 = select <8 x i1> %87, <8 x double> %253, <8 x double> %83
  br label %255

255:                                              ; preds = %180, %80
  %256 = phi <8 x double> [ %254, %180 ], [ %83, %80 ]
  %257 = getelementptr inbounds i8, ptr %0, i64 672
  %258 = load ptr, ptr %257, align 8
  %259 = load <8 x double>, ptr %258, align 8
  %260 = select <8 x i1> %16, <8 x double> %256, <8 x double> %259
  store <8 x double> %260, ptr %258, align 8
  %261 = getelementptr inbounds i8, ptr %0, i64 696
  %262 = load ptr, ptr %261, align 8
  %263 = load <8 x double>, ptr %262, align 8
  %264 = select <8 x i1> %16, <8 x double> <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>, <8 x double> %263
  store <8 x double> %264, ptr %262, align 8
  %265 = getelementptr inbounds i8, ptr %0, i64 720
  %266 = load ptr, ptr %265, align 8
  %267 = load ptr, ptr %1, align 8
  %268 = getelementptr inbounds i8, ptr %267, i64 120
  %269 = load ptr, ptr %268, align 8
  %270 = getelementptr inbounds i8, ptr %269, i64 40
  %271 = load double, ptr %270, align 8
  %272 = insertelement <8 x double> poison, double %271, i64 0
  %273 = load <8 x i64>, ptr %266, align 8
  %274 = bitcast <8 x double> %272 to <8 x i64>
  %275 = shufflevector <8 x i64> %274, <8 x i64> poison, <8 x i32> zeroinitializer
  %276 = select <8 x i1> %16, <8 x i64> %275, <8 x i64> %273
  store <8 x i64> %276, ptr %266, align 8
  %277 = getelementptr inbounds i8, ptr %0, i64 792
  %278 = load ptr, ptr %277, align 8
  %279 = load <8 x double>, ptr %278, align 8
  %280 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %279
  store <8 x double> %280, ptr %278, align 8
  %281 = getelementptr inbounds i8, ptr %0, i64 816
  %282 = load ptr, ptr %281, align 8
  %283 = load <8 x double>, ptr %282, align 8
  %284 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %283
  store <8 x double> %284, ptr %282, align 8
  %285 = getelementptr inbounds i8, ptr %0, i64 840
  %286 = load ptr, ptr %285, align 8
  %287 = load <8 x double>, ptr %286, align 8
  %288 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %287
  store <8 x double> %288, ptr %286, align 8
  %289 = getelementptr inbounds i8, ptr %0, i64 864
  %290 = load ptr, ptr %289, align 8
  %291 = tail call <8 x i1> @llvm.is.fpclass.v8f64(<8 x double> %256, i32 384)
  %292 = select <8 x i1> %291, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %293 = load <8 x i64>, ptr %290, align 8
  %294 = select <8 x i1> %16, <8 x i64> %292, <8 x i64> %293
  store <8 x i64> %294, ptr %290, align 8
  %295 = icmp eq i64 %2, 0
  br i1 %295, label %328, label %296

296:                                              ; preds = %255
  %297 = getelementptr inbounds i8, ptr %0, i64 888
  %298 = getelementptr inbounds i8, ptr %0, i64 984
  %299 = getelementptr inbounds i8, ptr %0, i64 992
  %300 = getelementptr inbounds i8, ptr %0, i64 744
  %301 = getelementptr inbounds i8, ptr %0, i64 768
  %302 = getelementptr inbounds i8, ptr %0, i64 912
  br label %303

303:                                              ; preds = %296, %303
  %304 = phi i64 [ %2, %296 ], [ %326, %303 ]
  %305 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %304, i1 true)
  %306 = load ptr, ptr %297, align 8
  %307 = getelementptr inbounds i64, ptr %306, i64 %305
  %308 = load i64, ptr %307, align 8
  %309 = load i64, ptr %299, align 8
  %310 = add nsw i64 %309, -1
  %311 = load ptr, ptr %300, align 8
  %312 = getelementptr inbounds double, ptr %311, i64 %305
  store double 0.000000e+00, ptr %312, align 8
  %313 = load ptr, ptr %298, align 8
  %314 = load double, ptr %313, align 8
  %315 = load ptr, ptr %301, align 8
  %316 = getelementptr inbounds double, ptr %315, i64 %305
  store double %314, ptr %316, align 8
  %317 = load ptr, ptr %9, align 8
  %318 = getelementptr inbounds i8, ptr %317, i64 24
  %319 = load i64, ptr %318, align 8
  %320 = shl i64 %308, 3
  %321 = mul i64 %320, %310
  %322 = add nsw i64 %319, %321
  %323 = load ptr, ptr %302, align 8
  %324 = getelementptr inbounds i64, ptr %323, i64 %305
  store i64 %322, ptr %324, align 8
  %325 = add nsw i64 %304, -1
  %326 = and i64 %325, %304
  %327 = icmp eq i64 %326, 0
  br i1 %327, label %328, label %303, !llvm.loop !33

328:                                              ; preds = %303, %255
  %329 = xor i64 %41, -1
  %330 = and i64 %329, %2
  %331 = icmp eq i64 %330, 0
  br i1 %331, label %335, label %332

332:                                              ; preds = %328
  %333 = getelementptr inbounds i8, ptr %0, i64 768
  %334 = getelementptr inbounds i8, ptr %0, i64 984
  br label %356

335:                                              ; preds = %356, %328
  %336 = and i64 %14, %41
  %337 = xor i64 %336, %14
  %338 = getelementptr inbounds i8, ptr %0, i64 768
  %339 = load ptr, ptr %338, align 8
  %340 = load <8 x double>, ptr %339, align 8
  %341 = fcmp oeq <8 x double> %340, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %342 = bitcast <8 x i1> %341 to i8
  %343 = zext i8 %342 to i64
  %344 = and i64 %337, %343
  %345 = load ptr, ptr %285, align 8
  %346 = load <8 x double>, ptr %345, align 8
  %347 = select <8 x i1> %16, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %348 = or i64 %344, %336
  %349 = xor i64 %348, -1
  %350 = and i64 %81, %349
  %351 = trunc i64 %350 to i8
  %352 = bitcast i8 %351 to <8 x i1>
  %353 = select <8 x i1> %352, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %354 = fadd <8 x double> %347, %353
  %355 = fadd <8 x double> %346, %354
  store <8 x double> %355, ptr %345, align 8
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %336, i64 noundef 3) #10
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %344, i64 noundef 0) #10
  ret void

356:                                              ; preds = %332, %356
  %357 = phi i64 [ %330, %332 ], [ %368, %356 ]
  %358 = load ptr, ptr %11, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %358, i64 noundef %357) #10
  %359 = load ptr, ptr %333, align 8
  %360 = load <8 x double>, ptr %359, align 8
  %361 = load ptr, ptr %334, align 8
  %362 = load double, ptr %361, align 8
  %363 = insertelement <8 x double> poison, double %362, i64 0
  %364 = shufflevector <8 x double> %363, <8 x double> poison, <8 x i32> zeroinitializer
  %365 = fcmp oeq <8 x double> %360, %364
  %366 = bitcast <8 x i1> %365 to i8
  %367 = zext i8 %366 to i64
  %368 = and i64 %357, %367
  %369 = icmp eq i64 %368, 0
  br i1 %369, label %335, label %356, !llvm.loop !34
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
  br i1 %13, label %60, label %14

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
  %28 = getelementptr inbounds i8, ptr %0, i64 1656
  %29 = getelementptr inbounds i8, ptr %0, i64 1664
  %30 = getelementptr inbounds i8, ptr %0, i64 1144
  %31 = getelementptr inbounds i8, ptr %0, i64 1128
  %32 = getelementptr inbounds i8, ptr %0, i64 1144
  %33 = getelementptr inbounds i8, ptr %0, i64 1160
  %34 = getelementptr inbounds i8, ptr %0, i64 1200
  %35 = getelementptr inbounds i8, ptr %0, i64 1368
  %36 = getelementptr inbounds i8, ptr %0, i64 1416
  %37 = getelementptr inbounds i8, ptr %0, i64 1432
  %38 = getelementptr inbounds i8, ptr %0, i64 1152
  %39 = getelementptr inbounds i8, ptr %0, i64 1464
  %40 = getelementptr inbounds i8, ptr %0, i64 1480
  br label %41

41:                                               ; preds = %14, %175
  %42 = phi i64 [ %1, %14 ], [ %179, %175 ]
  %43 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %42, i1 true)
  %44 = load ptr, ptr %15, align 8
  %45 = getelementptr inbounds i64, ptr %44, i64 %43
  %46 = load i64, ptr %45, align 8
  %47 = load i64, ptr %17, align 8
  %48 = load ptr, ptr %18, align 8
  %49 = getelementptr inbounds double, ptr %48, i64 %43
  %50 = load double, ptr %49, align 8
  %51 = fptosi double %50 to i64
  %52 = xor i64 %51, -1
  %53 = add i64 %47, %52
  %54 = icmp sgt i64 %53, 0
  br i1 %54, label %55, label %64

55:                                               ; preds = %41
  %56 = load ptr, ptr %16, align 8
  %57 = getelementptr inbounds i64, ptr %56, i64 %43
  %58 = load i64, ptr %57, align 8
  %59 = inttoptr i64 %58 to ptr
  br label %61

60:                                               ; preds = %175, %3
  ret void

61:                                               ; preds = %55, %83
  %62 = phi i64 [ %84, %83 ], [ %53, %55 ]
  %63 = phi ptr [ %85, %83 ], [ %59, %55 ]
  br i1 %19, label %87, label %83

64:                                               ; preds = %83, %41
  %65 = load ptr, ptr %20, align 8
  %66 = load i64, ptr %21, align 8
  %67 = mul nsw i64 %66, %46
  %68 = getelementptr inbounds i64, ptr %65, i64 %67
  %69 = load ptr, ptr %22, align 8
  %70 = getelementptr inbounds double, ptr %69, i64 %43
  %71 = load double, ptr %70, align 8
  %72 = fptosi double %71 to i64
  store i64 %72, ptr %68, align 8
  %73 = load ptr, ptr %23, align 8
  %74 = getelementptr inbounds double, ptr %73, i64 %43
  %75 = load double, ptr %74, align 8
  %76 = fptosi double %75 to i64
  %77 = getelementptr inbounds i8, ptr %68, i64 8
  store i64 %76, ptr %77, align 8
  %78 = load ptr, ptr %24, align 8
  %79 = getelementptr inbounds double, ptr %78, i64 %43
  %80 = load double, ptr %79, align 8
  %81 = fptosi double %80 to i64
  %82 = getelementptr inbounds i8, ptr %68, i64 16
  store i64 %81, ptr %82, align 8
  br i1 %25, label %93, label %98

83:                                               ; preds = %87, %61
  %84 = add nsw i64 %62, -1
  %85 = getelementptr inbounds i8, ptr %63, i64 8
  %86 = icmp sgt i64 %62, 1
  br i1 %86, label %61, label %64, !llvm.loop !35

87:                                               ; preds = %61, %87
  %88 = phi i64 [ %91, %87 ], [ 0, %61 ]
  %89 = mul nsw i64 %88, %12
  %90 = getelementptr inbounds double, ptr %63, i64 %89
  store double 0x7FF8000000000000, ptr %90, align 8
  %91 = add nuw nsw i64 %88, 1
  %92 = icmp eq i64 %91, %9
  br i1 %92, label %83, label %87, !llvm.loop !36

93:                                               ; preds = %64
  %94 = load ptr, ptr %26, align 8
  %95 = getelementptr inbounds double, ptr %94, i64 %43
  %96 = load double, ptr %95, align 8
  %97 = fptosi double %96 to i64
  br label %98

98:                                               ; preds = %64, %93
  %99 = phi i64 [ %97, %93 ], [ %2, %64 ]
  %100 = getelementptr inbounds i8, ptr %68, i64 24
  store i64 %99, ptr %100, align 8
  %101 = load ptr, ptr %4, align 8
  %102 = getelementptr inbounds double, ptr %101, i64 %43
  %103 = load double, ptr %102, align 8
  %104 = load ptr, ptr %27, align 8
  %105 = getelementptr inbounds double, ptr %104, i64 %46
  store double %103, ptr %105, align 8
  %106 = load ptr, ptr %28, align 8
  %107 = load i64, ptr %29, align 8
  %108 = getelementptr inbounds double, ptr %106, i64 %107
  %109 = load i64, ptr %30, align 8
  %110 = mul i64 %109, -64
  %111 = getelementptr inbounds i8, ptr %108, i64 %110
  %112 = load ptr, ptr %31, align 8
  %113 = mul nsw i64 %109, %46
  %114 = getelementptr inbounds double, ptr %112, i64 %113
  %115 = getelementptr double, ptr %111, i64 %43
  %116 = load i64, ptr %32, align 8
  %117 = icmp sgt i64 %116, 0
  br i1 %117, label %118, label %127

118:                                              ; preds = %98, %118
  %119 = phi i64 [ %124, %118 ], [ 0, %98 ]
  %120 = shl i64 %119, 6
  %121 = getelementptr i8, ptr %115, i64 %120
  %122 = load double, ptr %121, align 8
  %123 = getelementptr inbounds double, ptr %114, i64 %119
  store double %122, ptr %123, align 8
  %124 = add nuw nsw i64 %119, 1
  %125 = load i64, ptr %32, align 8
  %126 = icmp slt i64 %124, %125
  br i1 %126, label %118, label %127, !llvm.loop !37

127:                                              ; preds = %118, %98
  %128 = load i64, ptr %33, align 8
  %129 = icmp sgt i64 %128, 0
  br i1 %129, label %130, label %175

130:                                              ; preds = %127
  %131 = load ptr, ptr %34, align 8
  %132 = getelementptr inbounds i8, ptr %131, i64 8
  %133 = load i64, ptr %132, align 8
  %134 = icmp sgt i64 %133, 0
  br i1 %134, label %135, label %174

135:                                              ; preds = %130, %150
  %136 = phi i64 [ %156, %150 ], [ 2, %130 ]
  %137 = phi i64 [ %151, %150 ], [ 0, %130 ]
  %138 = load ptr, ptr %35, align 8
  %139 = shl i64 %137, 6
  %140 = getelementptr i8, ptr %138, i64 %139
  %141 = getelementptr double, ptr %140, i64 %43
  %142 = load double, ptr %141, align 8
  %143 = fptosi double %142 to i64
  %144 = load ptr, ptr %36, align 8
  %145 = load i64, ptr %37, align 8
  %146 = mul nsw i64 %145, %46
  %147 = getelementptr i64, ptr %144, i64 %146
  %148 = getelementptr i64, ptr %147, i64 %137
  store i64 %143, ptr %148, align 8
  %149 = shl nuw nsw i64 %137, 1
  br label %157

150:                                              ; preds = %157
  %151 = add nuw nsw i64 %137, 1
  %152 = load ptr, ptr %34, align 8
  %153 = getelementptr inbounds i8, ptr %152, i64 8
  %154 = load i64, ptr %153, align 8
  %155 = icmp slt i64 %151, %154
  %156 = add nuw i64 %136, 2
  br i1 %155, label %135, label %174, !llvm.loop !38

157:                                              ; preds = %135, %157
  %158 = phi i64 [ %149, %135 ], [ %172, %157 ]
  %159 = load ptr, ptr %38, align 8
  %160 = getelementptr inbounds i64, ptr %159, i64 %43
  %161 = load i64, ptr %160, align 8
  %162 = inttoptr i64 %161 to ptr
  %163 = getelementptr inbounds i8, ptr %162, i64 960
  %164 = load ptr, ptr %163, align 8
  %165 = getelementptr inbounds double, ptr %164, i64 %158
  %166 = load double, ptr %165, align 8
  %167 = load ptr, ptr %39, align 8
  %168 = load i64, ptr %40, align 8
  %169 = mul nsw i64 %168, %46
  %170 = getelementptr double, ptr %167, i64 %169
  %171 = getelementptr double, ptr %170, i64 %158
  store double %166, ptr %171, align 8
  %172 = add nuw nsw i64 %158, 1
  %173 = icmp eq i64 %172, %136
  br i1 %173, label %150, label %157, !llvm.loop !39

174:                                              ; preds = %150, %130
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %43) #10
  br label %175

175:                                              ; preds = %174, %127
  %176 = load ptr, ptr %15, align 8
  %177 = getelementptr inbounds i64, ptr %176, i64 %43
  store i64 -1, ptr %177, align 8
  %178 = add nsw i64 %42, -1
  %179 = and i64 %178, %42
  %180 = icmp eq i64 %179, 0
  br i1 %180, label %60, label %41, !llvm.loop !40
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
  %17 = tail call i64 %16(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %15, i64 noundef %3) #11
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
  br i1 %18, label %143, label %19

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
  br label %63

30:                                               ; preds = %86, %19
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
  %54 = load ptr, ptr %53, align 8
  %55 = tail call i32 %54(ptr noundef %46, ptr noundef %47, ptr noundef %48, ptr noundef %50, ptr noundef %52) #11
  %56 = trunc i32 %55 to i8
  %57 = xor i8 %56, -1
  %58 = icmp sgt i64 %12, 0
  br i1 %58, label %59, label %114

59:                                               ; preds = %30
  %60 = bitcast i8 %57 to <8 x i1>
  %61 = sext <8 x i1> %60 to <8 x i64>
  %62 = getelementptr inbounds i8, ptr %0, i64 1368
  br label %117

63:                                               ; preds = %23, %86
  %64 = phi i64 [ 0, %23 ], [ %94, %86 ]
  %65 = load ptr, ptr %24, align 8
  %66 = getelementptr inbounds i64, ptr %65, i64 %64
  %67 = load i64, ptr %66, align 8
  %68 = load ptr, ptr %25, align 8
  %69 = shl nsw i64 %67, 6
  %70 = getelementptr inbounds i8, ptr %68, i64 %69
  %71 = load <8 x double>, ptr %70, align 8
  %72 = load ptr, ptr %2, align 8
  %73 = getelementptr inbounds i8, ptr %72, i64 %69
  %74 = load <8 x double>, ptr %73, align 8
  %75 = fsub <8 x double> %71, %74
  %76 = fneg <8 x double> %75
  %77 = fcmp ogt <8 x double> %75, zeroinitializer
  %78 = select <8 x i1> %77, <8 x double> %75, <8 x double> %76
  %79 = load ptr, ptr %0, align 8
  %80 = load i64, ptr %79, align 8
  %81 = icmp slt i64 %80, 0
  br i1 %81, label %86, label %82

82:                                               ; preds = %63
  %83 = load ptr, ptr %26, align 8
  %84 = load i64, ptr %27, align 8
  %85 = getelementptr i8, ptr %83, i64 %69
  br label %97

86:                                               ; preds = %97, %63
  %87 = phi <8 x double> [ %78, %63 ], [ %108, %97 ]
  %88 = load ptr, ptr %28, align 8
  %89 = load i64, ptr %29, align 8
  %90 = add nsw i64 %89, %67
  %91 = fmul <8 x double> %87, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  %92 = shl nsw i64 %90, 6
  %93 = getelementptr inbounds i8, ptr %88, i64 %92
  store <8 x double> %91, ptr %93, align 8
  %94 = add nuw nsw i64 %64, 1
  %95 = load i64, ptr %20, align 8
  %96 = icmp slt i64 %94, %95
  br i1 %96, label %63, label %30, !llvm.loop !41

97:                                               ; preds = %82, %97
  %98 = phi i64 [ 0, %82 ], [ %109, %97 ]
  %99 = phi <8 x double> [ %78, %82 ], [ %108, %97 ]
  %100 = mul nsw i64 %84, %98
  %101 = getelementptr double, ptr %85, i64 %100
  %102 = load <8 x double>, ptr %101, align 8
  %103 = fneg <8 x double> %102
  %104 = fcmp ogt <8 x double> %102, zeroinitializer
  %105 = select <8 x i1> %104, <8 x double> %102, <8 x double> %103
  %106 = fmul <8 x double> %15, %105
  %107 = fcmp ogt <8 x double> %99, %106
  %108 = select <8 x i1> %107, <8 x double> %99, <8 x double> %106
  %109 = add nuw i64 %98, 1
  %110 = icmp eq i64 %98, %80
  br i1 %110, label %86, label %97, !llvm.loop !42

111:                                              ; preds = %139
  %112 = icmp ne <8 x i64> %140, zeroinitializer
  %113 = bitcast <8 x i1> %112 to i8
  br label %114

114:                                              ; preds = %111, %30
  %115 = phi i8 [ %57, %30 ], [ %113, %111 ]
  %116 = zext i8 %115 to i64
  br label %143

117:                                              ; preds = %59, %139
  %118 = phi i64 [ 0, %59 ], [ %141, %139 ]
  %119 = phi <8 x i64> [ %61, %59 ], [ %140, %139 ]
  %120 = getelementptr inbounds i64, ptr %10, i64 %118
  %121 = load i64, ptr %120, align 8
  %122 = and i64 %121, 2
  %123 = icmp eq i64 %122, 0
  br i1 %123, label %124, label %139

124:                                              ; preds = %117
  %125 = load ptr, ptr %51, align 8
  %126 = shl nsw i64 %118, 6
  %127 = getelementptr inbounds i8, ptr %125, i64 %126
  %128 = load <8 x double>, ptr %127, align 8
  %129 = load ptr, ptr %62, align 8
  %130 = getelementptr inbounds i8, ptr %129, i64 %126
  %131 = load <8 x double>, ptr %130, align 8
  %132 = fmul <8 x double> %128, %131
  %133 = add nuw nsw i64 %118, %12
  %134 = shl nsw i64 %133, 6
  %135 = getelementptr inbounds i8, ptr %125, i64 %134
  %136 = load <8 x double>, ptr %135, align 8
  %137 = fcmp ogt <8 x double> %132, %136
  %138 = select <8 x i1> %137, <8 x i64> %119, <8 x i64> zeroinitializer
  br label %139

139:                                              ; preds = %117, %124
  %140 = phi <8 x i64> [ %119, %117 ], [ %138, %124 ]
  %141 = add nuw nsw i64 %118, 1
  %142 = icmp eq i64 %141, %12
  br i1 %142, label %111, label %117, !llvm.loop !43

143:                                              ; preds = %1, %114
  %144 = phi i64 [ %116, %114 ], [ 0, %1 ]
  ret i64 %144
}

define internal fastcc i64 @look_for_events(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef readonly %3, ptr noundef %4, ptr noundef writeonly %5, ptr noundef %6) unnamed_addr #2 {
  br label %13

8:                                                ; preds = %13
  %9 = tail call fastcc i64 @quiet_lanes(ptr noundef %0, ptr noundef %1, i64 noundef %2, ptr noundef %3) #10
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
  %25 = tail call fastcc i64 @look_alone(ptr noundef %0, i64 noundef %21, double noundef %23, ptr noundef %24) #10
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
  tail call fastcc void @nested(ptr noundef %22, ptr noundef %71, ptr noundef %73, i64 noundef %75, i64 noundef %79, ptr noundef %80, i64 noundef %84) #10
  %85 = load ptr, ptr %38, align 8
  %86 = load i64, ptr %85, align 8
  %87 = icmp eq i64 %86, 1
  br i1 %87, label %88, label %92

88:                                               ; preds = %65
  %89 = load ptr, ptr %18, align 8
  %90 = tail call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %89, ptr noundef %22, i64 noundef %59, i32 noundef 0) #10
  %91 = or i64 %90, %48
  br label %92

92:                                               ; preds = %88, %65
  %93 = phi i64 [ %91, %88 ], [ %48, %65 ]
  %94 = xor i64 %93, -1
  %95 = and i64 %59, %94
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %22, i64 noundef %95) #10
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

define internal fastcc i64 @end_within(ptr noundef %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef %3, ptr noundef readonly %4) unnamed_addr #3 {
  %6 = getelementptr inbounds i8, ptr %1, i64 16
  %7 = load ptr, ptr %6, align 8
  %8 = trunc i64 %2 to i8
  %9 = bitcast i8 %8 to <8 x i1>
  %10 = load <8 x double>, ptr %4, align 8
  %11 = fcmp olt <8 x double> %10, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %12 = and <8 x i1> %11, %9
  %13 = select <8 x i1> %12, <8 x double> %10, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %14 = getelementptr inbounds i8, ptr %7, i64 48
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %7, i64 96
  %17 = load ptr, ptr %16, align 8
  store <8 x double> %13, ptr %17, align 8
  %18 = load ptr, ptr %7, align 8
  %19 = getelementptr inbounds i8, ptr %7, i64 192
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds i8, ptr %7, i64 8
  %22 = load i64, ptr %21, align 8
  %23 = load ptr, ptr %1, align 8
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr inbounds i8, ptr %24, i64 24
  %26 = load i64, ptr %25, align 8
  %27 = load ptr, ptr %16, align 8
  %28 = getelementptr inbounds i8, ptr %1, i64 8
  %29 = load ptr, ptr %28, align 8
  %30 = load ptr, ptr %29, align 8
  %31 = getelementptr inbounds i8, ptr %30, i64 16
  %32 = load i64, ptr %31, align 8
  tail call fastcc void @nested(ptr noundef %15, ptr noundef %18, ptr noundef %20, i64 noundef %22, i64 noundef %26, ptr noundef %27, i64 noundef %32) #10
  %33 = load ptr, ptr %28, align 8
  %34 = load ptr, ptr %33, align 8
  %35 = getelementptr inbounds i8, ptr %34, i64 8
  %36 = load i64, ptr %35, align 8
  %37 = icmp sgt i64 %36, 0
  br i1 %37, label %38, label %40

38:                                               ; preds = %5
  %39 = getelementptr inbounds i8, ptr %7, i64 24
  br label %45

40:                                               ; preds = %45, %5
  %41 = getelementptr inbounds i8, ptr %0, i64 1608
  %42 = load ptr, ptr %41, align 8
  %43 = load i64, ptr %42, align 8
  %44 = icmp eq i64 %43, 1
  br i1 %44, label %61, label %69

45:                                               ; preds = %38, %45
  %46 = phi i64 [ 0, %38 ], [ %55, %45 ]
  %47 = load ptr, ptr %39, align 8
  %48 = load ptr, ptr %14, align 8
  %49 = shl nsw i64 %46, 6
  %50 = getelementptr inbounds i8, ptr %48, i64 %49
  %51 = load <8 x i64>, ptr %50, align 8
  %52 = getelementptr inbounds i8, ptr %47, i64 %49
  %53 = load <8 x i64>, ptr %52, align 8
  %54 = select <8 x i1> %12, <8 x i64> %51, <8 x i64> %53
  store <8 x i64> %54, ptr %52, align 8
  %55 = add nuw nsw i64 %46, 1
  %56 = load ptr, ptr %28, align 8
  %57 = load ptr, ptr %56, align 8
  %58 = getelementptr inbounds i8, ptr %57, i64 8
  %59 = load i64, ptr %58, align 8
  %60 = icmp slt i64 %55, %59
  br i1 %60, label %45, label %40, !llvm.loop !49

61:                                               ; preds = %40
  %62 = bitcast <8 x i1> %12 to i8
  %63 = icmp eq i8 %62, 0
  br i1 %63, label %69, label %64

64:                                               ; preds = %61
  %65 = zext i8 %62 to i64
  %66 = getelementptr inbounds i8, ptr %7, i64 24
  %67 = load ptr, ptr %66, align 8
  %68 = tail call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %3, ptr noundef %67, i64 noundef %65, i32 noundef 0) #10
  br label %69

69:                                               ; preds = %40, %61, %64
  %70 = phi i64 [ %68, %64 ], [ 0, %61 ], [ 0, %40 ]
  ret i64 %70
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

declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #5

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
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #10
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
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #10
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
  %147 = tail call i64 %146(ptr noundef %56) #11
  br label %148

148:                                              ; preds = %145, %140
  %149 = phi i64 [ %147, %145 ], [ 0, %140 ]
  br i1 %75, label %150, label %151

150:                                              ; preds = %148
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #10
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
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %199, i64 noundef %157) #10
  br label %214

214:                                              ; preds = %213, %211
  %215 = phi i64 [ %212, %211 ], [ %21, %213 ]
  %216 = add nsw i64 %22, -1
  %217 = and i64 %216, %22
  %218 = icmp eq i64 %217, 0
  br i1 %218, label %32, label %20, !llvm.loop !57
}

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
  br i1 %48, label %13, label %20, !llvm.loop !58
}

declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #5

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #5

declare <8 x double> @llvm.rint.v8f64(<8 x double>) #5

declare <8 x double> @llvm.ceil.v8f64(<8 x double>) #5

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
  br i1 %26, label %95, label %27

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
  tail call fastcc void @nested(ptr noundef %36, ptr noundef %39, ptr noundef %41, i64 noundef %43, i64 noundef %47, ptr noundef %48, i64 noundef %53) #10
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
  tail call fastcc void @sample(ptr noundef nonnull %62) #10
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
  %76 = load ptr, ptr %75, align 8
  %77 = tail call i32 %76(ptr noundef %67, ptr noundef %70, ptr noundef %72, ptr noundef %74, ptr noundef %29) #11
  %78 = zext i32 %77 to i64
  %79 = and i64 %78, %24
  %80 = icmp sgt i64 %9, 0
  br i1 %80, label %81, label %95

81:                                               ; preds = %63
  %82 = getelementptr inbounds i8, ptr %0, i64 1320
  br label %83

83:                                               ; preds = %81, %83
  %84 = phi i64 [ 0, %81 ], [ %93, %83 ]
  %85 = load ptr, ptr %82, align 8
  %86 = load ptr, ptr %28, align 8
  %87 = shl nsw i64 %84, 6
  %88 = getelementptr inbounds i8, ptr %86, i64 %87
  %89 = load <8 x i64>, ptr %88, align 8
  %90 = getelementptr inbounds i8, ptr %85, i64 %87
  %91 = load <8 x i64>, ptr %90, align 8
  %92 = select <8 x i1> %22, <8 x i64> %89, <8 x i64> %91
  store <8 x i64> %92, ptr %90, align 8
  %93 = add nuw nsw i64 %84, 1
  %94 = icmp eq i64 %93, %9
  br i1 %94, label %95, label %83, !llvm.loop !67

95:                                               ; preds = %83, %63, %4
  %96 = phi i64 [ 0, %4 ], [ %79, %63 ], [ %79, %83 ]
  %97 = getelementptr inbounds i8, ptr %0, i64 1320
  %98 = shl i64 %9, 6
  %99 = getelementptr inbounds i8, ptr %1, i64 16
  %100 = getelementptr inbounds i8, ptr %1, i64 8
  %101 = getelementptr inbounds i8, ptr %0, i64 168
  %102 = getelementptr inbounds i8, ptr %0, i64 296
  %103 = getelementptr inbounds i8, ptr %0, i64 144
  %104 = getelementptr inbounds i8, ptr %0, i64 168
  %105 = getelementptr inbounds i8, ptr %0, i64 192
  %106 = getelementptr inbounds i8, ptr %0, i64 1224
  br label %120

107:                                              ; preds = %160
  %108 = xor i64 %173, -1
  %109 = and i64 %108, %2
  %110 = trunc i64 %109 to i8
  %111 = bitcast i8 %110 to <8 x i1>
  %112 = sext <8 x i1> %111 to <8 x i64>
  %113 = icmp sgt i64 %9, 0
  br i1 %113, label %114, label %176

114:                                              ; preds = %107
  %115 = getelementptr inbounds i8, ptr %0, i64 1368
  %116 = load ptr, ptr %115, align 8
  %117 = getelementptr inbounds i8, ptr %0, i64 1320
  %118 = load ptr, ptr %117, align 8
  %119 = getelementptr inbounds i8, ptr %5, i64 64
  br label %183

120:                                              ; preds = %95, %160
  %121 = phi i64 [ 1, %95 ], [ %174, %160 ]
  %122 = phi i64 [ %96, %95 ], [ %173, %160 ]
  %123 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %121
  %124 = load double, ptr %123, align 8
  %125 = load ptr, ptr %97, align 8
  %126 = mul i64 %98, %121
  %127 = getelementptr inbounds i8, ptr %125, i64 %126
  %128 = load ptr, ptr %19, align 8
  %129 = load <8 x double>, ptr %128, align 8
  %130 = load ptr, ptr %99, align 8
  %131 = getelementptr inbounds i8, ptr %130, i64 72
  %132 = load ptr, ptr %131, align 8
  %133 = load <8 x double>, ptr %132, align 8
  %134 = insertelement <8 x double> poison, double %124, i64 0
  %135 = shufflevector <8 x double> %134, <8 x double> poison, <8 x i32> zeroinitializer
  %136 = getelementptr inbounds i8, ptr %130, i64 48
  %137 = load ptr, ptr %136, align 8
  %138 = getelementptr inbounds i8, ptr %130, i64 96
  %139 = load ptr, ptr %138, align 8
  store <8 x double> %135, ptr %139, align 8
  %140 = load ptr, ptr %130, align 8
  %141 = getelementptr inbounds i8, ptr %130, i64 192
  %142 = load ptr, ptr %141, align 8
  %143 = getelementptr inbounds i8, ptr %130, i64 8
  %144 = load i64, ptr %143, align 8
  %145 = load ptr, ptr %1, align 8
  %146 = load ptr, ptr %145, align 8
  %147 = getelementptr inbounds i8, ptr %146, i64 24
  %148 = load i64, ptr %147, align 8
  %149 = load ptr, ptr %138, align 8
  %150 = load ptr, ptr %100, align 8
  %151 = load ptr, ptr %150, align 8
  %152 = getelementptr inbounds i8, ptr %151, i64 16
  %153 = load i64, ptr %152, align 8
  tail call fastcc void @nested(ptr noundef %137, ptr noundef %140, ptr noundef %142, i64 noundef %144, i64 noundef %148, ptr noundef %149, i64 noundef %153) #10
  %154 = fmul <8 x double> %135, %133
  %155 = fadd <8 x double> %129, %154
  %156 = load ptr, ptr %101, align 8
  store <8 x double> %155, ptr %156, align 8
  %157 = load i64, ptr %102, align 8
  %158 = icmp sgt i64 %157, 0
  br i1 %158, label %159, label %160

159:                                              ; preds = %120
  tail call fastcc void @sample(ptr noundef nonnull %103) #10
  br label %160

160:                                              ; preds = %120, %159
  %161 = load ptr, ptr %6, align 8
  %162 = load i64, ptr %161, align 8
  %163 = load ptr, ptr %104, align 8
  %164 = load ptr, ptr %99, align 8
  %165 = getelementptr inbounds i8, ptr %164, i64 48
  %166 = load ptr, ptr %165, align 8
  %167 = load ptr, ptr %105, align 8
  %168 = load ptr, ptr %106, align 8
  %169 = inttoptr i64 %162 to ptr
  %170 = load ptr, ptr %169, align 8
  %171 = tail call i32 %170(ptr noundef %163, ptr noundef %166, ptr noundef %167, ptr noundef %168, ptr noundef %127) #11
  %172 = zext i32 %171 to i64
  %173 = or i64 %122, %172
  %174 = add nuw nsw i64 %121, 1
  %175 = icmp eq i64 %174, 5
  br i1 %175, label %107, label %120, !llvm.loop !68

176:                                              ; preds = %304, %107
  %177 = phi <8 x i64> [ %112, %107 ], [ %306, %304 ]
  %178 = icmp sgt i64 %9, 0
  br i1 %178, label %179, label %309

179:                                              ; preds = %176
  %180 = getelementptr inbounds i8, ptr %0, i64 1320
  %181 = shl i64 %9, 8
  %182 = icmp slt <8 x i64> %177, zeroinitializer
  br label %318

183:                                              ; preds = %114, %304
  %184 = phi <8 x double> [ undef, %114 ], [ %218, %304 ]
  %185 = phi <8 x double> [ undef, %114 ], [ %213, %304 ]
  %186 = phi i64 [ 0, %114 ], [ %307, %304 ]
  %187 = phi <8 x i64> [ %112, %114 ], [ %306, %304 ]
  %188 = shl nsw i64 %186, 6
  %189 = getelementptr inbounds i8, ptr %116, i64 %188
  %190 = load <8 x double>, ptr %189, align 8
  br label %196

191:                                              ; preds = %222
  %192 = getelementptr inbounds i64, ptr %15, i64 %186
  %193 = load i64, ptr %192, align 8
  %194 = and i64 %193, 1
  %195 = icmp eq i64 %194, 0
  br i1 %195, label %226, label %238

196:                                              ; preds = %183, %222
  %197 = phi i64 [ 0, %183 ], [ %224, %222 ]
  %198 = phi <8 x double> [ %184, %183 ], [ %218, %222 ]
  %199 = phi <8 x double> [ %185, %183 ], [ %213, %222 ]
  %200 = phi <8 x i64> [ %187, %183 ], [ %223, %222 ]
  %201 = mul nuw nsw i64 %9, %197
  %202 = add nuw nsw i64 %201, %186
  %203 = shl nsw i64 %202, 6
  %204 = getelementptr inbounds i8, ptr %118, i64 %203
  %205 = load <8 x double>, ptr %204, align 8
  %206 = fmul <8 x double> %190, %205
  %207 = getelementptr inbounds [5 x <8 x double>], ptr %5, i64 0, i64 %197
  store <8 x double> %206, ptr %207, align 64
  %208 = icmp eq i64 %197, 0
  br i1 %208, label %212, label %209

209:                                              ; preds = %196
  %210 = fcmp olt <8 x double> %199, %205
  %211 = select <8 x i1> %210, <8 x double> %199, <8 x double> %205
  br label %212

212:                                              ; preds = %196, %209
  %213 = phi <8 x double> [ %205, %196 ], [ %211, %209 ]
  br i1 %208, label %217, label %214

214:                                              ; preds = %212
  %215 = fcmp ogt <8 x double> %198, %205
  %216 = select <8 x i1> %215, <8 x double> %198, <8 x double> %205
  br label %217

217:                                              ; preds = %212, %214
  %218 = phi <8 x double> [ %205, %212 ], [ %216, %214 ]
  br i1 %208, label %222, label %219

219:                                              ; preds = %217
  %220 = fcmp ogt <8 x double> %206, zeroinitializer
  %221 = select <8 x i1> %220, <8 x i64> %200, <8 x i64> zeroinitializer
  br label %222

222:                                              ; preds = %217, %219
  %223 = phi <8 x i64> [ %221, %219 ], [ %200, %217 ]
  %224 = add nuw nsw i64 %197, 1
  %225 = icmp eq i64 %224, 5
  br i1 %225, label %191, label %196, !llvm.loop !69

226:                                              ; preds = %191
  %227 = fmul <8 x double> %213, %218
  %228 = fcmp ogt <8 x double> %227, zeroinitializer
  %229 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %213)
  %230 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %218)
  %231 = fcmp olt <8 x double> %229, %230
  %232 = select <8 x i1> %231, <8 x double> %229, <8 x double> %230
  %233 = fsub <8 x double> %218, %213
  %234 = fmul <8 x double> %233, <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>
  %235 = fcmp ogt <8 x double> %232, %234
  %236 = select <8 x i1> %235, <8 x i1> %228, <8 x i1> zeroinitializer
  %237 = select <8 x i1> %236, <8 x i64> %223, <8 x i64> zeroinitializer
  br label %238

238:                                              ; preds = %226, %191
  %239 = phi <8 x i64> [ %223, %191 ], [ %237, %226 ]
  %240 = load <8 x double>, ptr %119, align 64
  %241 = load <8 x double>, ptr %5, align 64
  %242 = fsub <8 x double> %240, %241
  %243 = fdiv <8 x double> %242, <double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C>
  br label %244

244:                                              ; preds = %238, %301
  %245 = phi i64 [ 1, %238 ], [ %251, %301 ]
  %246 = phi <8 x i64> [ zeroinitializer, %238 ], [ %302, %301 ]
  %247 = phi <8 x double> [ %243, %238 ], [ %262, %301 ]
  %248 = add nsw i64 %245, -1
  %249 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %245
  %250 = load double, ptr %249, align 8
  %251 = add nuw nsw i64 %245, 1
  %252 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %251
  %253 = load double, ptr %252, align 8
  %254 = getelementptr inbounds <8 x double>, ptr %5, i64 %251
  %255 = load <8 x double>, ptr %254, align 64
  %256 = getelementptr inbounds <8 x double>, ptr %5, i64 %245
  %257 = load <8 x double>, ptr %256, align 64
  %258 = fsub <8 x double> %255, %257
  %259 = fsub double %253, %250
  %260 = insertelement <8 x double> poison, double %259, i64 0
  %261 = shufflevector <8 x double> %260, <8 x double> poison, <8 x i32> zeroinitializer
  %262 = fdiv <8 x double> %258, %261
  %263 = fcmp ogt <8 x double> %262, %247
  %264 = getelementptr inbounds <8 x double>, ptr %5, i64 %248
  %265 = load <8 x double>, ptr %264, align 64
  %266 = fcmp ogt <8 x double> %265, zeroinitializer
  %267 = and <8 x i1> %263, %266
  %268 = bitcast <8 x i1> %267 to i8
  %269 = icmp eq i8 %268, 0
  br i1 %269, label %301, label %270

270:                                              ; preds = %244
  %271 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %248
  %272 = load double, ptr %271, align 8
  %273 = fsub <8 x double> %262, %247
  %274 = fsub double %253, %272
  %275 = insertelement <8 x double> poison, double %274, i64 0
  %276 = shufflevector <8 x double> %275, <8 x double> poison, <8 x i32> zeroinitializer
  %277 = fdiv <8 x double> %273, %276
  %278 = fsub double %250, %272
  %279 = insertelement <8 x double> poison, double %278, i64 0
  %280 = shufflevector <8 x double> %279, <8 x double> poison, <8 x i32> zeroinitializer
  %281 = fmul <8 x double> %280, %277
  %282 = fadd <8 x double> %247, %281
  %283 = insertelement <8 x double> poison, double %250, i64 0
  %284 = shufflevector <8 x double> %283, <8 x double> poison, <8 x i32> zeroinitializer
  %285 = fmul <8 x double> %282, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %286 = fdiv <8 x double> %285, %277
  %287 = fsub <8 x double> %284, %286
  %288 = icmp ugt i64 %245, 1
  %289 = select i1 %288, double %272, double 0xBFCE3779B97F4A7C
  %290 = icmp eq i64 %245, 3
  %291 = select i1 %290, double 0x3FF4498517A7B356, double %253
  %292 = insertelement <8 x double> poison, double %289, i64 0
  %293 = shufflevector <8 x double> %292, <8 x double> poison, <8 x i32> zeroinitializer
  %294 = fcmp oge <8 x double> %287, %293
  %295 = insertelement <8 x double> poison, double %291, i64 0
  %296 = shufflevector <8 x double> %295, <8 x double> poison, <8 x i32> zeroinitializer
  %297 = fcmp ole <8 x double> %287, %296
  %298 = and <8 x i1> %297, %294
  %299 = and <8 x i1> %298, %267
  %300 = select <8 x i1> %299, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, <8 x i64> %246
  br label %301

301:                                              ; preds = %270, %244
  %302 = phi <8 x i64> [ %300, %270 ], [ %246, %244 ]
  %303 = icmp eq i64 %251, 4
  br i1 %303, label %304, label %244, !llvm.loop !70

304:                                              ; preds = %301
  %305 = xor <8 x i64> %302, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %306 = and <8 x i64> %239, %305
  %307 = add nuw nsw i64 %186, 1
  %308 = icmp eq i64 %307, %9
  br i1 %308, label %176, label %183, !llvm.loop !71

309:                                              ; preds = %318, %176
  %310 = load ptr, ptr %16, align 8
  %311 = load <8 x i64>, ptr %3, align 8
  %312 = load <8 x i64>, ptr %310, align 8
  %313 = icmp slt <8 x i64> %177, zeroinitializer
  %314 = select <8 x i1> %313, <8 x i64> %311, <8 x i64> %312
  store <8 x i64> %314, ptr %310, align 8
  %315 = icmp ne <8 x i64> %177, zeroinitializer
  %316 = bitcast <8 x i1> %315 to i8
  %317 = zext i8 %316 to i64
  ret i64 %317

318:                                              ; preds = %179, %318
  %319 = phi i64 [ 0, %179 ], [ %329, %318 ]
  %320 = load ptr, ptr %180, align 8
  %321 = shl i64 %319, 6
  %322 = getelementptr i8, ptr %320, i64 %181
  %323 = getelementptr i8, ptr %322, i64 %321
  %324 = load <8 x i64>, ptr %323, align 8
  %325 = shl nsw i64 %319, 6
  %326 = getelementptr inbounds i8, ptr %320, i64 %325
  %327 = load <8 x i64>, ptr %326, align 8
  %328 = select <8 x i1> %182, <8 x i64> %324, <8 x i64> %327
  store <8 x i64> %328, ptr %326, align 8
  %329 = add nuw nsw i64 %319, 1
  %330 = icmp eq i64 %329, %9
  br i1 %330, label %309, label %318, !llvm.loop !72
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
  %80 = tail call i64 %71(ptr noundef %9, double noundef %75, double noundef %79) #11
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
