; sources 2f682aee56a07ebdbfc2ac873415a9a505fdde12924c1bf84cf8034e4ec75c66
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
  %11 = getelementptr inbounds i8, ptr %0, i64 360
  store ptr %11, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 912
  %13 = load ptr, ptr %9, align 8
  %14 = getelementptr inbounds i8, ptr %13, i64 8
  %15 = load i64, ptr %14, align 8
  %16 = load ptr, ptr %0, align 8
  %17 = getelementptr inbounds i8, ptr %0, i64 960
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 968
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr double, ptr %18, i64 %20
  %22 = getelementptr i8, ptr %21, i64 -16
  %23 = load double, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %0, i64 936
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
  %37 = getelementptr inbounds i8, ptr %0, i64 1216
  %38 = load i64, ptr %37, align 8
  %39 = icmp sgt i64 %38, 0
  %40 = getelementptr inbounds i8, ptr %0, i64 1224
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds i8, ptr %41, i64 8
  %43 = load i64, ptr %42, align 8
  %44 = getelementptr inbounds i8, ptr %0, i64 528
  %45 = load ptr, ptr %44, align 8
  %46 = load i64, ptr %16, align 8
  %47 = getelementptr inbounds i8, ptr %0, i64 368
  %48 = load i64, ptr %47, align 8
  %49 = mul nsw i64 %48, %46
  store i64 0, ptr %5, align 8
  %50 = getelementptr inbounds i8, ptr %0, i64 864
  %51 = load ptr, ptr %50, align 8
  br label %138

52:                                               ; preds = %138
  %53 = getelementptr inbounds i8, ptr %0, i64 624
  %54 = sitofp i64 %29 to double
  %55 = zext i1 %34 to i32
  %56 = icmp ne i64 %36, 1
  %57 = select i1 %39, i1 true, i1 %56
  %58 = icmp sgt i64 %43, 0
  %59 = getelementptr inbounds double, ptr %45, i64 %49
  store i64 %146, ptr %5, align 8
  %60 = getelementptr inbounds i8, ptr %0, i64 864
  %61 = getelementptr inbounds i8, ptr %0, i64 1568
  %62 = getelementptr inbounds i8, ptr %0, i64 1128
  %63 = getelementptr inbounds i8, ptr %0, i64 744
  %64 = insertelement <8 x double> poison, double %23, i64 0
  %65 = shufflevector <8 x double> %64, <8 x double> poison, <8 x i32> zeroinitializer
  %66 = getelementptr inbounds i8, ptr %0, i64 648
  %67 = insertelement <8 x double> poison, double %26, i64 0
  %68 = shufflevector <8 x double> %67, <8 x double> poison, <8 x i32> zeroinitializer
  %69 = getelementptr inbounds i8, ptr %0, i64 768
  %70 = getelementptr inbounds i8, ptr %0, i64 792
  %71 = insertelement <8 x double> poison, double %54, i64 0
  %72 = shufflevector <8 x double> %71, <8 x double> poison, <8 x i32> zeroinitializer
  %73 = getelementptr inbounds i8, ptr %0, i64 432
  %74 = getelementptr inbounds i8, ptr %0, i64 408
  %75 = getelementptr inbounds i8, ptr %0, i64 24
  %76 = getelementptr inbounds i8, ptr %0, i64 528
  %77 = getelementptr inbounds i8, ptr %0, i64 48
  %78 = getelementptr inbounds i8, ptr %0, i64 72
  %79 = getelementptr inbounds i8, ptr %0, i64 368
  %80 = getelementptr inbounds i8, ptr %0, i64 96
  %81 = getelementptr inbounds i8, ptr %0, i64 168
  %82 = getelementptr inbounds i8, ptr %0, i64 272
  %83 = getelementptr inbounds i8, ptr %0, i64 192
  %84 = getelementptr inbounds i8, ptr %0, i64 240
  %85 = getelementptr inbounds i8, ptr %0, i64 384
  %86 = getelementptr inbounds i8, ptr %0, i64 24
  %87 = getelementptr inbounds i8, ptr %0, i64 528
  %88 = getelementptr inbounds i8, ptr %0, i64 48
  %89 = getelementptr inbounds i8, ptr %0, i64 72
  %90 = getelementptr inbounds i8, ptr %0, i64 384
  %91 = getelementptr inbounds i8, ptr %0, i64 168
  %92 = getelementptr inbounds i8, ptr %0, i64 272
  %93 = getelementptr inbounds i8, ptr %0, i64 192
  %94 = getelementptr inbounds i8, ptr %0, i64 240
  %95 = icmp sgt i64 %15, 0
  %96 = getelementptr inbounds i8, ptr %0, i64 384
  %97 = getelementptr inbounds i8, ptr %0, i64 504
  %98 = getelementptr inbounds i8, ptr %0, i64 368
  %99 = getelementptr inbounds i8, ptr %0, i64 480
  %100 = getelementptr inbounds i8, ptr %0, i64 600
  %101 = getelementptr inbounds i8, ptr %0, i64 576
  %102 = getelementptr inbounds i8, ptr %0, i64 384
  %103 = getelementptr inbounds i8, ptr %0, i64 384
  %104 = getelementptr inbounds i8, ptr %0, i64 168
  %105 = getelementptr inbounds i8, ptr %0, i64 272
  %106 = getelementptr inbounds i8, ptr %0, i64 192
  %107 = getelementptr inbounds i8, ptr %0, i64 240
  %108 = getelementptr inbounds i8, ptr %0, i64 816
  %109 = sext i1 %56 to i64
  %110 = uitofp i1 %57 to double
  %111 = insertelement <8 x double> poison, double %110, i64 0
  %112 = bitcast <8 x double> %111 to <8 x i64>
  %113 = shufflevector <8 x i64> %112, <8 x i64> poison, <8 x i32> zeroinitializer
  %114 = getelementptr inbounds i8, ptr %0, i64 744
  %115 = getelementptr inbounds i8, ptr %0, i64 368
  %116 = getelementptr inbounds i8, ptr %0, i64 552
  %117 = getelementptr inbounds i8, ptr %0, i64 408
  %118 = getelementptr inbounds i8, ptr %0, i64 96
  %119 = getelementptr inbounds i8, ptr %0, i64 168
  %120 = getelementptr inbounds i8, ptr %0, i64 272
  %121 = getelementptr inbounds i8, ptr %0, i64 192
  %122 = getelementptr inbounds i8, ptr %0, i64 240
  %123 = getelementptr inbounds i8, ptr %0, i64 480
  %124 = getelementptr inbounds i8, ptr %16, i64 16
  %125 = getelementptr inbounds i8, ptr %0, i64 384
  %126 = getelementptr inbounds i8, ptr %0, i64 672
  %127 = getelementptr inbounds i8, ptr %0, i64 696
  %128 = getelementptr inbounds i8, ptr %31, i64 24
  %129 = getelementptr inbounds i8, ptr %31, i64 8
  %130 = getelementptr inbounds i8, ptr %31, i64 16
  %131 = getelementptr inbounds i8, ptr %31, i64 32
  %132 = getelementptr inbounds i8, ptr %31, i64 40
  %133 = getelementptr inbounds i8, ptr %31, i64 24
  %134 = getelementptr inbounds i8, ptr %31, i64 32
  %135 = getelementptr inbounds i8, ptr %0, i64 840
  %136 = icmp sgt i64 %15, 0
  %137 = getelementptr inbounds i8, ptr %0, i64 384
  br label %149

138:                                              ; preds = %1, %138
  %139 = phi i64 [ 0, %1 ], [ %147, %138 ]
  %140 = phi i64 [ 0, %1 ], [ %146, %138 ]
  %141 = getelementptr inbounds i64, ptr %51, i64 %139
  %142 = load i64, ptr %141, align 8
  %143 = icmp sgt i64 %142, -1
  %144 = zext i1 %143 to i64
  %145 = shl nuw nsw i64 %144, %139
  %146 = or i64 %145, %140
  %147 = add nuw nsw i64 %139, 1
  %148 = icmp eq i64 %147, 8
  br i1 %148, label %52, label %138, !llvm.loop !3

149:                                              ; preds = %184, %52
  %150 = phi i32 [ 1, %52 ], [ %185, %184 ]
  %151 = phi i64 [ 0, %52 ], [ %186, %184 ]
  %152 = icmp ne i32 %150, 0
  %153 = icmp ne i64 %151, 0
  %154 = select i1 %152, i1 true, i1 %153
  br i1 %154, label %155, label %187

155:                                              ; preds = %149
  br i1 %152, label %156, label %158

156:                                              ; preds = %155
  %157 = call fastcc i64 @fill(ptr noundef nonnull %0, ptr noundef nonnull %5) #11
  br label %158

158:                                              ; preds = %155, %156
  %159 = phi i64 [ %157, %156 ], [ 0, %155 ]
  %160 = load i64, ptr %5, align 8
  %161 = icmp eq i64 %160, 0
  br i1 %161, label %180, label %162

162:                                              ; preds = %158
  %163 = or i64 %159, %151
  %164 = icmp eq i64 %163, 0
  br i1 %164, label %180, label %165

165:                                              ; preds = %162
  call fastcc void @start(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %159, i64 noundef %151) #11
  br label %166

166:                                              ; preds = %165, %175
  %167 = phi i32 [ 0, %165 ], [ %177, %175 ]
  %168 = phi i64 [ 0, %165 ], [ %178, %175 ]
  %169 = icmp eq i32 %167, 0
  br i1 %169, label %170, label %175

170:                                              ; preds = %166
  %171 = load ptr, ptr %60, align 8
  %172 = getelementptr inbounds i64, ptr %171, i64 %168
  %173 = load i64, ptr %172, align 8
  %174 = icmp eq i64 %173, -1
  br label %175

175:                                              ; preds = %170, %166
  %176 = phi i1 [ true, %166 ], [ %174, %170 ]
  %177 = zext i1 %176 to i32
  %178 = add nuw nsw i64 %168, 1
  %179 = icmp eq i64 %178, 8
  br i1 %179, label %180, label %166, !llvm.loop !6

180:                                              ; preds = %175, %162, %158
  %181 = phi i32 [ 1, %158 ], [ 8, %162 ], [ 0, %175 ]
  %182 = phi i32 [ %150, %158 ], [ 0, %162 ], [ %177, %175 ]
  %183 = phi i64 [ %151, %158 ], [ %151, %162 ], [ 0, %175 ]
  switch i32 %181, label %1102 [
    i32 0, label %184
    i32 8, label %187
  ]

184:                                              ; preds = %180, %1100, %262
  %185 = phi i32 [ %182, %180 ], [ %1101, %1100 ], [ 1, %262 ]
  %186 = phi i64 [ %183, %180 ], [ %1090, %1100 ], [ %189, %262 ]
  br label %149, !llvm.loop !7

187:                                              ; preds = %180, %149
  %188 = phi i32 [ %182, %180 ], [ 0, %149 ]
  %189 = phi i64 [ %183, %180 ], [ 0, %149 ]
  %190 = load ptr, ptr %12, align 8
  %191 = getelementptr inbounds i8, ptr %190, i64 8
  %192 = load i64, ptr %191, align 8
  %193 = icmp slt i64 %192, 1
  br i1 %193, label %1102, label %194

194:                                              ; preds = %187
  br i1 %58, label %195, label %215

195:                                              ; preds = %194
  %196 = load i64, ptr %61, align 8
  %197 = icmp sgt i64 %196, 0
  br i1 %197, label %198, label %212

198:                                              ; preds = %195
  %199 = load ptr, ptr %40, align 8
  %200 = getelementptr inbounds i8, ptr %199, i64 72
  %201 = load i64, ptr %200, align 8
  %202 = load ptr, ptr %62, align 8
  %203 = load i64, ptr %202, align 8
  %204 = inttoptr i64 %203 to ptr
  %205 = getelementptr inbounds i8, ptr %204, i64 1016
  %206 = load i64, ptr %205, align 8
  %207 = shl i64 %206, 4
  %208 = add i64 %201, 16
  %209 = add i64 %208, %207
  %210 = icmp sgt i64 %209, %196
  %211 = zext i1 %210 to i32
  br label %212

212:                                              ; preds = %195, %198
  %213 = phi i32 [ 0, %195 ], [ %211, %198 ]
  %214 = icmp eq i32 %213, 0
  br i1 %214, label %215, label %1102

215:                                              ; preds = %212, %194
  %216 = add nsw i64 %192, -1
  store i64 %216, ptr %191, align 8
  %217 = load i64, ptr %5, align 8
  %218 = trunc i64 %217 to i8
  %219 = bitcast i8 %218 to <8 x i1>
  %220 = load ptr, ptr %53, align 8
  %221 = load <8 x double>, ptr %220, align 8
  br i1 %34, label %225, label %222

222:                                              ; preds = %215
  %223 = load ptr, ptr %63, align 8
  %224 = load <8 x double>, ptr %223, align 8
  br label %225

225:                                              ; preds = %215, %222
  %226 = phi <8 x double> [ %224, %222 ], [ %65, %215 ]
  %227 = load ptr, ptr %66, align 8
  %228 = load <8 x double>, ptr %227, align 8
  br i1 %34, label %229, label %232

229:                                              ; preds = %225
  %230 = fcmp olt <8 x double> %228, %68
  %231 = select <8 x i1> %230, <8 x double> %228, <8 x double> %68
  br label %238

232:                                              ; preds = %225
  %233 = fsub <8 x double> %226, %221
  %234 = fdiv <8 x double> %233, %228
  %235 = fmul <8 x double> %234, <double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1>
  %236 = call <8 x double> @llvm.ceil.v8f64(<8 x double> %235)
  %237 = fdiv <8 x double> %233, %236
  br label %238

238:                                              ; preds = %232, %229
  %239 = phi <8 x double> [ %231, %229 ], [ %237, %232 ]
  %240 = fadd <8 x double> %221, %239
  %241 = fmul <8 x double> %239, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %242 = fsub <8 x double> %226, %241
  %243 = fcmp ogt <8 x double> %240, %242
  %244 = select <8 x i1> %243, <8 x double> %226, <8 x double> %240
  %245 = fsub <8 x double> %244, %221
  %246 = select <8 x i1> %219, <8 x double> %245, <8 x double> zeroinitializer
  %247 = load ptr, ptr %69, align 8
  %248 = load <8 x double>, ptr %247, align 8
  %249 = load ptr, ptr %70, align 8
  %250 = load <8 x double>, ptr %249, align 8
  %251 = fadd <8 x double> %248, %250
  %252 = fcmp oge <8 x double> %251, %72
  %253 = fmul <8 x double> %246, <double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02>
  %254 = fadd <8 x double> %221, %253
  %255 = fcmp ule <8 x double> %254, %221
  %256 = fcmp une <8 x double> %244, %226
  %257 = and <8 x i1> %255, %256
  %258 = or <8 x i1> %257, %252
  %259 = and <8 x i1> %258, %219
  %260 = bitcast <8 x i1> %259 to i8
  %261 = icmp eq i8 %260, 0
  br i1 %261, label %269, label %262

262:                                              ; preds = %238
  %263 = zext i8 %260 to i64
  %264 = bitcast <8 x i1> %252 to i8
  %265 = zext i8 %264 to i64
  %266 = and i64 %263, %265
  call fastcc void @retire(ptr noundef %0, i64 noundef %266, i64 noundef 1) #11
  %267 = xor i64 %265, -1
  %268 = and i64 %263, %267
  call fastcc void @retire(ptr noundef %0, i64 noundef %268, i64 noundef -1) #11
  br label %184

269:                                              ; preds = %238
  %270 = load ptr, ptr %0, align 8
  %271 = load i64, ptr %270, align 8
  %272 = load ptr, ptr %73, align 8
  store <8 x double> %246, ptr %272, align 8
  %273 = icmp sgt i64 %271, 1
  br i1 %273, label %274, label %323

274:                                              ; preds = %269, %311
  %275 = phi i64 [ %320, %311 ], [ 0, %269 ]
  %276 = phi i64 [ %321, %311 ], [ 1, %269 ]
  %277 = load ptr, ptr %74, align 8
  %278 = load ptr, ptr %11, align 8
  %279 = load ptr, ptr %9, align 8
  %280 = getelementptr inbounds i8, ptr %279, i64 16
  %281 = load i64, ptr %280, align 8
  %282 = load ptr, ptr %75, align 8
  %283 = getelementptr inbounds i64, ptr %282, i64 %276
  %284 = load i64, ptr %283, align 8
  %285 = getelementptr i8, ptr %283, i64 8
  %286 = load i64, ptr %285, align 8
  %287 = xor i64 %284, -1
  %288 = add i64 %286, %287
  %289 = load ptr, ptr %73, align 8
  %290 = load ptr, ptr %76, align 8
  %291 = load ptr, ptr %77, align 8
  %292 = getelementptr inbounds i64, ptr %291, i64 %284
  %293 = load ptr, ptr %78, align 8
  %294 = getelementptr inbounds double, ptr %293, i64 %284
  call fastcc void @combine(ptr noundef %277, ptr noundef %278, ptr noundef %289, ptr noundef %290, ptr noundef %292, ptr noundef %294, i64 noundef %288, i64 noundef %281) #11
  %295 = load ptr, ptr %76, align 8
  %296 = load i64, ptr %79, align 8
  %297 = mul nsw i64 %296, %276
  %298 = getelementptr inbounds double, ptr %295, i64 %297
  %299 = load ptr, ptr %80, align 8
  %300 = getelementptr inbounds double, ptr %299, i64 %276
  %301 = load double, ptr %300, align 8
  %302 = insertelement <8 x double> poison, double %301, i64 0
  %303 = shufflevector <8 x double> %302, <8 x double> poison, <8 x i32> zeroinitializer
  %304 = fmul <8 x double> %246, %303
  %305 = fadd <8 x double> %221, %304
  %306 = load ptr, ptr %74, align 8
  %307 = load ptr, ptr %81, align 8
  store <8 x double> %305, ptr %307, align 8
  %308 = load i64, ptr %82, align 8
  %309 = icmp sgt i64 %308, 0
  br i1 %309, label %310, label %311

310:                                              ; preds = %274
  call fastcc void @sample(ptr noundef nonnull %9) #11
  br label %311

311:                                              ; preds = %274, %310
  %312 = load ptr, ptr %9, align 8
  %313 = load i64, ptr %312, align 8
  %314 = load ptr, ptr %81, align 8
  %315 = load ptr, ptr %83, align 8
  %316 = load ptr, ptr %84, align 8
  %317 = inttoptr i64 %313 to ptr
  %318 = call i32 %317(ptr noundef %314, ptr noundef %306, ptr noundef %315, ptr noundef %316, ptr noundef %298) #12
  %319 = zext i32 %318 to i64
  %320 = or i64 %275, %319
  %321 = add nuw nsw i64 %276, 1
  %322 = icmp eq i64 %321, %271
  br i1 %322, label %323, label %274, !llvm.loop !8

323:                                              ; preds = %311, %269
  %324 = phi i64 [ 0, %269 ], [ %320, %311 ]
  %325 = load ptr, ptr %85, align 8
  %326 = load ptr, ptr %11, align 8
  %327 = load ptr, ptr %9, align 8
  %328 = getelementptr inbounds i8, ptr %327, i64 16
  %329 = load i64, ptr %328, align 8
  %330 = load ptr, ptr %86, align 8
  %331 = getelementptr inbounds i64, ptr %330, i64 %271
  %332 = load i64, ptr %331, align 8
  %333 = getelementptr i8, ptr %331, i64 8
  %334 = load i64, ptr %333, align 8
  %335 = xor i64 %332, -1
  %336 = add i64 %334, %335
  %337 = load ptr, ptr %73, align 8
  %338 = load ptr, ptr %87, align 8
  %339 = load ptr, ptr %88, align 8
  %340 = getelementptr inbounds i64, ptr %339, i64 %332
  %341 = load ptr, ptr %89, align 8
  %342 = getelementptr inbounds double, ptr %341, i64 %332
  call fastcc void @combine(ptr noundef %325, ptr noundef %326, ptr noundef %337, ptr noundef %338, ptr noundef %340, ptr noundef %342, i64 noundef %336, i64 noundef %329) #11
  br i1 %56, label %359, label %343

343:                                              ; preds = %323
  %344 = load ptr, ptr %90, align 8
  %345 = load ptr, ptr %91, align 8
  store <8 x double> %244, ptr %345, align 8
  %346 = load i64, ptr %92, align 8
  %347 = icmp sgt i64 %346, 0
  br i1 %347, label %348, label %349

348:                                              ; preds = %343
  call fastcc void @sample(ptr noundef nonnull %9) #11
  br label %349

349:                                              ; preds = %343, %348
  %350 = load ptr, ptr %9, align 8
  %351 = load i64, ptr %350, align 8
  %352 = load ptr, ptr %91, align 8
  %353 = load ptr, ptr %93, align 8
  %354 = load ptr, ptr %94, align 8
  %355 = inttoptr i64 %351 to ptr
  %356 = call i32 %355(ptr noundef %352, ptr noundef %344, ptr noundef %353, ptr noundef %354, ptr noundef %59) #12
  %357 = zext i32 %356 to i64
  %358 = or i64 %324, %357
  br label %359

359:                                              ; preds = %349, %323
  %360 = phi i64 [ %358, %349 ], [ %324, %323 ]
  br i1 %34, label %364, label %361

361:                                              ; preds = %359
  br i1 %95, label %362, label %537

362:                                              ; preds = %361
  %363 = load ptr, ptr %96, align 8
  br label %527

364:                                              ; preds = %359
  %365 = load ptr, ptr %9, align 8
  %366 = load ptr, ptr %0, align 8
  %367 = getelementptr inbounds i8, ptr %365, i64 24
  %368 = load i64, ptr %367, align 8
  %369 = getelementptr inbounds i8, ptr %366, i64 8
  %370 = load i64, ptr %369, align 8
  %371 = load ptr, ptr %97, align 8
  %372 = load i64, ptr %98, align 8
  %373 = getelementptr inbounds double, ptr %371, i64 %372
  %374 = icmp sgt i64 %370, 0
  br i1 %374, label %375, label %377

375:                                              ; preds = %364
  %376 = getelementptr inbounds i8, ptr %365, i64 32
  br label %385

377:                                              ; preds = %385, %364
  %378 = icmp sgt i64 %368, 0
  br i1 %378, label %379, label %411

379:                                              ; preds = %377
  %380 = load ptr, ptr %11, align 8
  %381 = load ptr, ptr %85, align 8
  %382 = load ptr, ptr %100, align 8
  %383 = load ptr, ptr %101, align 8
  %384 = load ptr, ptr %97, align 8
  br label %474

385:                                              ; preds = %375, %385
  %386 = phi i64 [ 0, %375 ], [ %409, %385 ]
  %387 = load i64, ptr %366, align 8
  %388 = load i64, ptr %376, align 8
  %389 = load ptr, ptr %97, align 8
  %390 = load i64, ptr %98, align 8
  %391 = mul nsw i64 %390, %386
  %392 = getelementptr inbounds double, ptr %389, i64 %391
  %393 = load ptr, ptr %99, align 8
  %394 = load ptr, ptr %86, align 8
  %395 = getelementptr i64, ptr %394, i64 %387
  %396 = getelementptr i8, ptr %395, i64 8
  %397 = getelementptr i64, ptr %396, i64 %386
  %398 = load i64, ptr %397, align 8
  %399 = getelementptr i8, ptr %397, i64 8
  %400 = load i64, ptr %399, align 8
  %401 = xor i64 %398, -1
  %402 = add i64 %400, %401
  %403 = load ptr, ptr %73, align 8
  %404 = load ptr, ptr %87, align 8
  %405 = load ptr, ptr %88, align 8
  %406 = getelementptr inbounds i64, ptr %405, i64 %398
  %407 = load ptr, ptr %89, align 8
  %408 = getelementptr inbounds double, ptr %407, i64 %398
  call fastcc void @combine(ptr noundef %392, ptr noundef %393, ptr noundef %403, ptr noundef %404, ptr noundef %406, ptr noundef %408, i64 noundef %402, i64 noundef %388) #11
  %409 = add nuw nsw i64 %386, 1
  %410 = icmp eq i64 %409, %370
  br i1 %410, label %377, label %385, !llvm.loop !9

411:                                              ; preds = %474, %377
  %412 = phi <8 x double> [ zeroinitializer, %377 ], [ %507, %474 ]
  %413 = phi <8 x double> [ zeroinitializer, %377 ], [ %505, %474 ]
  %414 = load ptr, ptr %85, align 8
  %415 = getelementptr inbounds i8, ptr %365, i64 8
  %416 = load i64, ptr %415, align 8
  %417 = add nsw i64 %416, -3
  %418 = getelementptr i8, ptr %414, i64 64
  %419 = getelementptr i8, ptr %414, i64 128
  %420 = getelementptr i8, ptr %414, i64 192
  %421 = icmp slt i64 %368, %417
  br i1 %421, label %429, label %422

422:                                              ; preds = %429, %411
  %423 = phi <8 x double> [ zeroinitializer, %411 ], [ %439, %429 ]
  %424 = phi <8 x double> [ zeroinitializer, %411 ], [ %444, %429 ]
  %425 = phi <8 x double> [ zeroinitializer, %411 ], [ %449, %429 ]
  %426 = phi <8 x double> [ zeroinitializer, %411 ], [ %454, %429 ]
  %427 = phi i64 [ %368, %411 ], [ %455, %429 ]
  %428 = icmp slt i64 %427, %416
  br i1 %428, label %457, label %467

429:                                              ; preds = %411, %429
  %430 = phi i64 [ %455, %429 ], [ %368, %411 ]
  %431 = phi <8 x double> [ %454, %429 ], [ zeroinitializer, %411 ]
  %432 = phi <8 x double> [ %449, %429 ], [ zeroinitializer, %411 ]
  %433 = phi <8 x double> [ %444, %429 ], [ zeroinitializer, %411 ]
  %434 = phi <8 x double> [ %439, %429 ], [ zeroinitializer, %411 ]
  %435 = shl nsw i64 %430, 6
  %436 = getelementptr inbounds i8, ptr %414, i64 %435
  %437 = load <8 x double>, ptr %436, align 8
  %438 = fmul <8 x double> %437, zeroinitializer
  %439 = fadd <8 x double> %434, %438
  %440 = shl i64 %430, 6
  %441 = getelementptr i8, ptr %418, i64 %440
  %442 = load <8 x double>, ptr %441, align 8
  %443 = fmul <8 x double> %442, zeroinitializer
  %444 = fadd <8 x double> %433, %443
  %445 = shl i64 %430, 6
  %446 = getelementptr i8, ptr %419, i64 %445
  %447 = load <8 x double>, ptr %446, align 8
  %448 = fmul <8 x double> %447, zeroinitializer
  %449 = fadd <8 x double> %432, %448
  %450 = shl i64 %430, 6
  %451 = getelementptr i8, ptr %420, i64 %450
  %452 = load <8 x double>, ptr %451, align 8
  %453 = fmul <8 x double> %452, zeroinitializer
  %454 = fadd <8 x double> %431, %453
  %455 = add nsw i64 %430, 4
  %456 = icmp slt i64 %455, %417
  br i1 %456, label %429, label %422, !llvm.loop !10

457:                                              ; preds = %422, %457
  %458 = phi i64 [ %465, %457 ], [ %427, %422 ]
  %459 = phi <8 x double> [ %464, %457 ], [ %423, %422 ]
  %460 = shl nsw i64 %458, 6
  %461 = getelementptr inbounds i8, ptr %414, i64 %460
  %462 = load <8 x double>, ptr %461, align 8
  %463 = fmul <8 x double> %462, zeroinitializer
  %464 = fadd <8 x double> %459, %463
  %465 = add nsw i64 %458, 1
  %466 = icmp eq i64 %465, %416
  br i1 %466, label %467, label %457, !llvm.loop !11

467:                                              ; preds = %457, %422
  %468 = phi <8 x double> [ %423, %422 ], [ %464, %457 ]
  %469 = fadd <8 x double> %424, %468
  %470 = fadd <8 x double> %425, %426
  %471 = fadd <8 x double> %470, %469
  %472 = fadd <8 x double> %413, %471
  %473 = icmp eq i64 %370, 2
  br i1 %473, label %510, label %521

474:                                              ; preds = %379, %474
  %475 = phi <8 x double> [ zeroinitializer, %379 ], [ %505, %474 ]
  %476 = phi <8 x double> [ zeroinitializer, %379 ], [ %507, %474 ]
  %477 = phi i64 [ 0, %379 ], [ %508, %474 ]
  %478 = shl nsw i64 %477, 6
  %479 = getelementptr inbounds i8, ptr %380, i64 %478
  %480 = load <8 x double>, ptr %479, align 8
  %481 = getelementptr inbounds i8, ptr %381, i64 %478
  %482 = load <8 x double>, ptr %481, align 8
  %483 = getelementptr inbounds double, ptr %382, i64 %477
  %484 = load double, ptr %483, align 8
  %485 = insertelement <8 x double> poison, double %484, i64 0
  %486 = shufflevector <8 x double> %485, <8 x double> poison, <8 x i32> zeroinitializer
  %487 = getelementptr inbounds double, ptr %383, i64 %477
  %488 = load double, ptr %487, align 8
  %489 = insertelement <8 x double> poison, double %488, i64 0
  %490 = shufflevector <8 x double> %489, <8 x double> poison, <8 x i32> zeroinitializer
  %491 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %480)
  %492 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %482)
  %493 = fcmp ogt <8 x double> %491, %492
  %494 = select <8 x i1> %493, <8 x double> %491, <8 x double> %492
  %495 = fmul <8 x double> %494, %490
  %496 = fadd <8 x double> %486, %495
  %497 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %496
  %498 = getelementptr inbounds i8, ptr %384, i64 %478
  %499 = load <8 x double>, ptr %498, align 8
  %500 = fmul <8 x double> %499, %497
  %501 = getelementptr inbounds i8, ptr %373, i64 %478
  %502 = load <8 x double>, ptr %501, align 8
  %503 = fmul <8 x double> %502, %497
  %504 = fmul <8 x double> %500, %500
  %505 = fadd <8 x double> %475, %504
  %506 = fmul <8 x double> %503, %503
  %507 = fadd <8 x double> %476, %506
  %508 = add nuw nsw i64 %477, 1
  %509 = icmp eq i64 %508, %368
  br i1 %509, label %411, label %474, !llvm.loop !12

510:                                              ; preds = %467
  %511 = fmul <8 x double> %412, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %512 = fadd <8 x double> %511, %472
  %513 = sitofp i64 %368 to double
  %514 = insertelement <8 x double> poison, double %513, i64 0
  %515 = shufflevector <8 x double> %514, <8 x double> poison, <8 x i32> zeroinitializer
  %516 = fmul <8 x double> %515, %512
  %517 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %516)
  %518 = fdiv <8 x double> %472, %517
  %519 = fcmp oeq <8 x double> %472, zeroinitializer
  %520 = select <8 x i1> %519, <8 x double> zeroinitializer, <8 x double> %518
  br label %537

521:                                              ; preds = %467
  %522 = sitofp i64 %368 to double
  %523 = insertelement <8 x double> poison, double %522, i64 0
  %524 = shufflevector <8 x double> %523, <8 x double> poison, <8 x i32> zeroinitializer
  %525 = fdiv <8 x double> %472, %524
  %526 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %525)
  br label %537

527:                                              ; preds = %362, %527
  %528 = phi <8 x double> [ zeroinitializer, %362 ], [ %534, %527 ]
  %529 = phi i64 [ 0, %362 ], [ %535, %527 ]
  %530 = shl nsw i64 %529, 6
  %531 = getelementptr inbounds i8, ptr %363, i64 %530
  %532 = load <8 x double>, ptr %531, align 8
  %533 = fmul <8 x double> %532, zeroinitializer
  %534 = fadd <8 x double> %528, %533
  %535 = add nuw nsw i64 %529, 1
  %536 = icmp eq i64 %535, %15
  br i1 %536, label %537, label %527, !llvm.loop !13

537:                                              ; preds = %527, %361, %521, %510
  %538 = phi <8 x double> [ %520, %510 ], [ %526, %521 ], [ zeroinitializer, %361 ], [ %534, %527 ]
  %539 = fcmp uge <8 x double> %538, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %540 = trunc i64 %360 to i8
  %541 = bitcast i8 %540 to <8 x i1>
  %542 = select <8 x i1> %541, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %539
  %543 = xor <8 x i1> %542, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %544 = select <8 x i1> %543, <8 x i1> %219, <8 x i1> zeroinitializer
  %545 = sext <8 x i1> %544 to <8 x i64>
  br i1 %39, label %546, label %558

546:                                              ; preds = %537
  %547 = xor <8 x i1> %542, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %548 = select <8 x i1> %547, <8 x i1> %219, <8 x i1> zeroinitializer
  %549 = bitcast <8 x i1> %548 to i8
  %550 = icmp eq i8 %549, 0
  br i1 %550, label %558, label %551

551:                                              ; preds = %546
  %552 = zext i8 %549 to i64
  store <8 x double> %244, ptr %3, align 16
  %553 = load ptr, ptr %102, align 8
  %554 = call fastcc i64 @hold_lanes(ptr noundef nonnull %0, ptr noundef nonnull %3, ptr noundef %553, i64 noundef %552, i32 noundef %55) #11
  %555 = trunc nuw i64 %554 to i8
  %556 = bitcast i8 %555 to <8 x i1>
  %557 = select <8 x i1> %556, <8 x i64> zeroinitializer, <8 x i64> %545
  br label %558

558:                                              ; preds = %551, %546, %537
  %559 = phi <8 x i64> [ %557, %551 ], [ %545, %546 ], [ %545, %537 ]
  %560 = phi i64 [ %554, %551 ], [ 0, %546 ], [ 0, %537 ]
  %561 = icmp ne <8 x i64> %559, zeroinitializer
  %562 = bitcast <8 x i1> %561 to i8
  %563 = icmp ne i8 %562, 0
  %564 = select i1 %57, i1 %563, i1 false
  br i1 %564, label %565, label %584

565:                                              ; preds = %558
  %566 = load ptr, ptr %103, align 8
  %567 = load ptr, ptr %104, align 8
  store <8 x double> %244, ptr %567, align 8
  %568 = load i64, ptr %105, align 8
  %569 = icmp sgt i64 %568, 0
  br i1 %569, label %570, label %571

570:                                              ; preds = %565
  call fastcc void @sample(ptr noundef nonnull %9) #11
  br label %571

571:                                              ; preds = %565, %570
  %572 = load ptr, ptr %9, align 8
  %573 = load i64, ptr %572, align 8
  %574 = load ptr, ptr %104, align 8
  %575 = load ptr, ptr %106, align 8
  %576 = load ptr, ptr %107, align 8
  %577 = inttoptr i64 %573 to ptr
  %578 = call i32 %577(ptr noundef %574, ptr noundef %566, ptr noundef %575, ptr noundef %576, ptr noundef %59) #12
  %579 = zext i32 %578 to i64
  %580 = or i64 %360, %579
  %581 = trunc i64 %580 to i8
  %582 = bitcast i8 %581 to <8 x i1>
  %583 = select <8 x i1> %582, <8 x i64> zeroinitializer, <8 x i64> %559
  br label %584

584:                                              ; preds = %571, %558
  %585 = phi <8 x i64> [ %583, %571 ], [ %559, %558 ]
  %586 = phi i64 [ %580, %571 ], [ %360, %558 ]
  %587 = load ptr, ptr %108, align 8
  %588 = load <8 x double>, ptr %587, align 8
  %589 = load i64, ptr %16, align 8
  %590 = add i64 %589, %109
  %591 = sitofp i64 %590 to double
  %592 = insertelement <8 x double> poison, double %591, i64 0
  %593 = shufflevector <8 x double> %592, <8 x double> poison, <8 x i32> zeroinitializer
  %594 = icmp slt <8 x i64> %559, zeroinitializer
  %595 = select <8 x i1> %594, <8 x i64> %113, <8 x i64> zeroinitializer
  %596 = bitcast <8 x i64> %595 to <8 x double>
  %597 = fadd <8 x double> %593, %596
  %598 = fadd <8 x double> %588, %597
  store <8 x double> %598, ptr %587, align 8
  br i1 %58, label %599, label %608

599:                                              ; preds = %584
  %600 = icmp ne <8 x i64> %585, zeroinitializer
  %601 = bitcast <8 x i1> %600 to i8
  %602 = icmp eq i8 %601, 0
  br i1 %602, label %608, label %603

603:                                              ; preds = %599
  %604 = zext i8 %601 to i64
  %605 = call fastcc i64 @clear_lanes(ptr noundef %0) #11
  %606 = xor i64 %605, -1
  %607 = and i64 %606, %604
  br label %608

608:                                              ; preds = %584, %599, %603
  %609 = phi i64 [ %607, %603 ], [ 0, %599 ], [ 0, %584 ]
  store i64 0, ptr %7, align 8
  %610 = load ptr, ptr %114, align 8
  %611 = load <8 x double>, ptr %610, align 8
  %612 = fcmp olt <8 x double> %611, %244
  %613 = icmp ne <8 x i64> %585, zeroinitializer
  %614 = select <8 x i1> %612, <8 x i1> %613, <8 x i1> zeroinitializer
  %615 = bitcast <8 x i1> %614 to i8
  %616 = zext i8 %615 to i64
  %617 = or i64 %609, %616
  %618 = icmp eq i64 %617, 0
  br i1 %618, label %797, label %619

619:                                              ; preds = %608
  %620 = load ptr, ptr %0, align 8
  %621 = load ptr, ptr %9, align 8
  %622 = getelementptr inbounds i8, ptr %621, i64 16
  %623 = load i64, ptr %622, align 8
  %624 = load i64, ptr %620, align 8
  %625 = load i64, ptr %115, align 8
  %626 = load ptr, ptr %87, align 8
  %627 = mul nsw i64 %625, %624
  %628 = getelementptr inbounds double, ptr %626, i64 %627
  %629 = load ptr, ptr %116, align 8
  %630 = add nsw i64 %624, 1
  %631 = getelementptr inbounds i8, ptr %620, i64 16
  %632 = load i64, ptr %631, align 8
  %633 = icmp sgt i64 %632, 0
  br i1 %633, label %634, label %636

634:                                              ; preds = %619
  %635 = getelementptr inbounds i8, ptr %620, i64 8
  br label %647

636:                                              ; preds = %682, %619
  %637 = phi i64 [ 0, %619 ], [ %691, %682 ]
  %638 = getelementptr inbounds i8, ptr %620, i64 16
  %639 = load ptr, ptr %9, align 8
  %640 = getelementptr inbounds i8, ptr %639, i64 8
  %641 = load i64, ptr %640, align 8
  %642 = icmp sgt i64 %641, 0
  br i1 %642, label %643, label %696

643:                                              ; preds = %636
  %644 = getelementptr inbounds double, ptr %629, i64 %625
  %645 = shl nsw i64 %625, 4
  %646 = getelementptr inbounds i8, ptr %629, i64 %645
  br label %703

647:                                              ; preds = %634, %682
  %648 = phi i64 [ 0, %634 ], [ %691, %682 ]
  %649 = phi i64 [ %630, %634 ], [ %692, %682 ]
  %650 = load i64, ptr %635, align 8
  %651 = load ptr, ptr %117, align 8
  %652 = load ptr, ptr %11, align 8
  %653 = load ptr, ptr %86, align 8
  %654 = getelementptr i64, ptr %653, i64 %649
  %655 = getelementptr i64, ptr %654, i64 %650
  %656 = load i64, ptr %655, align 8
  %657 = getelementptr i8, ptr %655, i64 8
  %658 = load i64, ptr %657, align 8
  %659 = xor i64 %656, -1
  %660 = add i64 %658, %659
  %661 = load ptr, ptr %73, align 8
  %662 = load ptr, ptr %87, align 8
  %663 = load ptr, ptr %88, align 8
  %664 = getelementptr inbounds i64, ptr %663, i64 %656
  %665 = load ptr, ptr %89, align 8
  %666 = getelementptr inbounds double, ptr %665, i64 %656
  call fastcc void @combine(ptr noundef %651, ptr noundef %652, ptr noundef %661, ptr noundef %662, ptr noundef %664, ptr noundef %666, i64 noundef %660, i64 noundef %623) #11
  %667 = load ptr, ptr %87, align 8
  %668 = mul nsw i64 %649, %625
  %669 = getelementptr inbounds double, ptr %667, i64 %668
  %670 = load ptr, ptr %118, align 8
  %671 = getelementptr inbounds double, ptr %670, i64 %649
  %672 = load double, ptr %671, align 8
  %673 = insertelement <8 x double> poison, double %672, i64 0
  %674 = shufflevector <8 x double> %673, <8 x double> poison, <8 x i32> zeroinitializer
  %675 = fmul <8 x double> %246, %674
  %676 = fadd <8 x double> %221, %675
  %677 = load ptr, ptr %117, align 8
  %678 = load ptr, ptr %119, align 8
  store <8 x double> %676, ptr %678, align 8
  %679 = load i64, ptr %120, align 8
  %680 = icmp sgt i64 %679, 0
  br i1 %680, label %681, label %682

681:                                              ; preds = %647
  call fastcc void @sample(ptr noundef nonnull %9) #11
  br label %682

682:                                              ; preds = %647, %681
  %683 = load ptr, ptr %9, align 8
  %684 = load i64, ptr %683, align 8
  %685 = load ptr, ptr %119, align 8
  %686 = load ptr, ptr %121, align 8
  %687 = load ptr, ptr %122, align 8
  %688 = inttoptr i64 %684 to ptr
  %689 = call i32 %688(ptr noundef %685, ptr noundef %677, ptr noundef %686, ptr noundef %687, ptr noundef %669) #12
  %690 = sext i32 %689 to i64
  %691 = or i64 %648, %690
  %692 = add nsw i64 %649, 1
  %693 = load i64, ptr %631, align 8
  %694 = add nsw i64 %693, %630
  %695 = icmp slt i64 %692, %694
  br i1 %695, label %647, label %636, !llvm.loop !14

696:                                              ; preds = %703, %636
  %697 = getelementptr inbounds i8, ptr %620, i64 8
  %698 = load i64, ptr %697, align 8
  %699 = load i64, ptr %638, align 8
  %700 = getelementptr inbounds i8, ptr %620, i64 24
  %701 = load i64, ptr %700, align 8
  %702 = icmp sgt i64 %701, 3
  br i1 %702, label %731, label %756

703:                                              ; preds = %643, %703
  %704 = phi i64 [ 0, %643 ], [ %726, %703 ]
  %705 = load ptr, ptr %85, align 8
  %706 = shl nsw i64 %704, 6
  %707 = getelementptr inbounds i8, ptr %705, i64 %706
  %708 = load <8 x double>, ptr %707, align 8
  %709 = load ptr, ptr %11, align 8
  %710 = getelementptr inbounds i8, ptr %709, i64 %706
  %711 = load <8 x double>, ptr %710, align 8
  %712 = fsub <8 x double> %708, %711
  %713 = load ptr, ptr %87, align 8
  %714 = getelementptr inbounds i8, ptr %713, i64 %706
  %715 = load <8 x double>, ptr %714, align 8
  %716 = fmul <8 x double> %246, %715
  %717 = fsub <8 x double> %716, %712
  %718 = getelementptr inbounds i8, ptr %629, i64 %706
  store <8 x double> %712, ptr %718, align 8
  %719 = getelementptr inbounds i8, ptr %644, i64 %706
  store <8 x double> %717, ptr %719, align 8
  %720 = fsub <8 x double> %712, %717
  %721 = getelementptr inbounds i8, ptr %628, i64 %706
  %722 = load <8 x double>, ptr %721, align 8
  %723 = fmul <8 x double> %246, %722
  %724 = fsub <8 x double> %720, %723
  %725 = getelementptr inbounds i8, ptr %646, i64 %706
  store <8 x double> %724, ptr %725, align 8
  %726 = add nuw nsw i64 %704, 1
  %727 = load ptr, ptr %9, align 8
  %728 = getelementptr inbounds i8, ptr %727, i64 8
  %729 = load i64, ptr %728, align 8
  %730 = icmp slt i64 %726, %729
  br i1 %730, label %703, label %696, !llvm.loop !15

731:                                              ; preds = %696, %731
  %732 = phi i64 [ %753, %731 ], [ 3, %696 ]
  %733 = mul nsw i64 %732, %625
  %734 = getelementptr inbounds double, ptr %629, i64 %733
  %735 = load ptr, ptr %123, align 8
  %736 = load ptr, ptr %86, align 8
  %737 = getelementptr i64, ptr %736, i64 %630
  %738 = getelementptr i64, ptr %737, i64 %698
  %739 = getelementptr i64, ptr %738, i64 %699
  %740 = getelementptr i64, ptr %739, i64 %732
  %741 = getelementptr i8, ptr %740, i64 -24
  %742 = load i64, ptr %741, align 8
  %743 = getelementptr i8, ptr %740, i64 -16
  %744 = load i64, ptr %743, align 8
  %745 = xor i64 %742, -1
  %746 = add i64 %744, %745
  %747 = load ptr, ptr %73, align 8
  %748 = load ptr, ptr %87, align 8
  %749 = load ptr, ptr %88, align 8
  %750 = getelementptr inbounds i64, ptr %749, i64 %742
  %751 = load ptr, ptr %89, align 8
  %752 = getelementptr inbounds double, ptr %751, i64 %742
  call fastcc void @combine(ptr noundef %734, ptr noundef %735, ptr noundef %747, ptr noundef %748, ptr noundef %750, ptr noundef %752, i64 noundef %746, i64 noundef %623) #11
  %753 = add nuw nsw i64 %732, 1
  %754 = load i64, ptr %700, align 8
  %755 = icmp slt i64 %753, %754
  br i1 %755, label %731, label %756, !llvm.loop !16

756:                                              ; preds = %731, %696
  %757 = and i64 %637, %617
  %758 = load ptr, ptr %108, align 8
  %759 = load <8 x double>, ptr %758, align 8
  %760 = trunc nuw i64 %617 to i8
  %761 = bitcast i8 %760 to <8 x i1>
  %762 = load i64, ptr %124, align 8
  %763 = sitofp i64 %762 to double
  %764 = insertelement <8 x double> poison, double %763, i64 0
  %765 = shufflevector <8 x double> %764, <8 x double> poison, <8 x i32> zeroinitializer
  %766 = select <8 x i1> %761, <8 x double> %765, <8 x double> zeroinitializer
  %767 = fadd <8 x double> %759, %766
  store <8 x double> %767, ptr %758, align 8
  %768 = icmp eq i64 %757, 0
  br i1 %768, label %773, label %769

769:                                              ; preds = %756
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %757, i64 noundef 3) #11
  %770 = xor i64 %757, -1
  %771 = and i64 %217, %770
  store i64 %771, ptr %5, align 8
  %772 = and i64 %609, %770
  br label %773

773:                                              ; preds = %769, %756
  %774 = phi i64 [ %772, %769 ], [ %609, %756 ]
  %775 = phi i32 [ 1, %769 ], [ %188, %756 ]
  store <8 x double> %244, ptr %3, align 16
  %776 = icmp eq i64 %774, 0
  br i1 %776, label %779, label %777

777:                                              ; preds = %773
  %778 = call fastcc i64 @look_for_events(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %774, ptr noundef nonnull %3, ptr noundef nonnull %6, ptr noundef nonnull %4, ptr noundef nonnull %7) #11
  br label %779

779:                                              ; preds = %777, %773
  %780 = phi i64 [ %778, %777 ], [ 0, %773 ]
  %781 = load i64, ptr %7, align 8
  %782 = or i64 %781, %637
  %783 = xor i64 %782, -1
  %784 = and i64 %617, %783
  %785 = icmp eq i64 %780, 0
  %786 = select i1 %785, ptr null, ptr %4
  %787 = call fastcc i64 @write_within(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %784, ptr noundef nonnull %3, ptr noundef %786) #11
  %788 = or i64 %787, %560
  %789 = or i64 %781, %757
  %790 = or i64 %789, %788
  %791 = trunc i64 %790 to i8
  %792 = xor i8 %791, -1
  %793 = bitcast i8 %792 to <8 x i1>
  %794 = select <8 x i1> %793, <8 x i64> %585, <8 x i64> zeroinitializer
  %795 = load <8 x double>, ptr %3, align 16
  br i1 %785, label %797, label %796

796:                                              ; preds = %779
  call fastcc void @end_within(ptr noundef nonnull %2, i64 noundef %780, ptr noundef nonnull %4) #11
  br label %797

797:                                              ; preds = %779, %796, %608
  %798 = phi <8 x double> [ %244, %608 ], [ %795, %779 ], [ %795, %796 ]
  %799 = phi <8 x i64> [ %585, %608 ], [ %794, %779 ], [ %794, %796 ]
  %800 = phi i64 [ %560, %608 ], [ %788, %779 ], [ %788, %796 ]
  %801 = phi i32 [ %188, %608 ], [ %775, %779 ], [ %775, %796 ]
  %802 = phi i64 [ 0, %608 ], [ %780, %779 ], [ %780, %796 ]
  %803 = load ptr, ptr %114, align 8
  %804 = load <8 x double>, ptr %803, align 8
  %805 = fcmp oeq <8 x double> %804, %798
  %806 = icmp ne <8 x i64> %799, zeroinitializer
  %807 = select <8 x i1> %805, <8 x i1> %806, <8 x i1> zeroinitializer
  %808 = bitcast <8 x i1> %807 to i8
  %809 = icmp eq i8 %808, 0
  br i1 %809, label %812, label %810

810:                                              ; preds = %797
  %811 = zext i8 %808 to i64
  br label %821

812:                                              ; preds = %821, %797
  %813 = xor <8 x i64> %799, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %814 = select <8 x i1> %219, <8 x i64> %813, <8 x i64> zeroinitializer
  %815 = load ptr, ptr %69, align 8
  %816 = load <8 x double>, ptr %815, align 8
  %817 = icmp slt <8 x i64> %799, zeroinitializer
  %818 = select <8 x i1> %817, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %819 = bitcast <8 x i64> %818 to <8 x double>
  %820 = fadd <8 x double> %816, %819
  store <8 x double> %820, ptr %815, align 8
  br i1 %34, label %831, label %955

821:                                              ; preds = %810, %821
  %822 = phi i64 [ %829, %821 ], [ %811, %810 ]
  %823 = load ptr, ptr %125, align 8
  call fastcc void @write_outputs(ptr noundef %0, ptr noundef %823, i64 noundef %822) #11
  %824 = load ptr, ptr %114, align 8
  %825 = load <8 x double>, ptr %824, align 8
  %826 = fcmp oeq <8 x double> %825, %798
  %827 = bitcast <8 x i1> %826 to i8
  %828 = zext i8 %827 to i64
  %829 = and i64 %822, %828
  %830 = icmp eq i64 %829, 0
  br i1 %830, label %812, label %821, !llvm.loop !17

831:                                              ; preds = %812
  %832 = load ptr, ptr %126, align 8
  %833 = load <8 x double>, ptr %832, align 8
  %834 = load ptr, ptr %127, align 8
  %835 = load <8 x double>, ptr %834, align 8
  %836 = fcmp ogt <8 x double> %538, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %837 = bitcast <8 x double> %538 to <8 x i64>
  %838 = select <8 x i1> %836, <8 x i64> %837, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %839 = load double, ptr %128, align 8
  %840 = insertelement <8 x double> poison, double %839, i64 0
  %841 = shufflevector <8 x double> %840, <8 x double> poison, <8 x i32> zeroinitializer
  %842 = load double, ptr %129, align 8
  %843 = fneg double %842
  %844 = add <8 x i64> %838, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %845 = ashr <8 x i64> %844, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %846 = and <8 x i64> %844, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %847 = sub <8 x i64> %838, %846
  %848 = bitcast <8 x i64> %847 to <8 x double>
  %849 = fadd <8 x double> %848, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %850 = fadd <8 x double> %848, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %851 = fdiv <8 x double> %849, %850
  %852 = fmul <8 x double> %851, %851
  %853 = call <8 x double> @llvm.fma.v8f64(<8 x double> %852, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %854 = call <8 x double> @llvm.fma.v8f64(<8 x double> %853, <8 x double> %852, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %855 = call <8 x double> @llvm.fma.v8f64(<8 x double> %854, <8 x double> %852, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %856 = call <8 x double> @llvm.fma.v8f64(<8 x double> %855, <8 x double> %852, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %857 = trunc nsw <8 x i64> %845 to <8 x i32>
  %858 = sitofp <8 x i32> %857 to <8 x double>
  %859 = fmul <8 x double> %851, %856
  %860 = fadd <8 x double> %859, %858
  %861 = insertelement <8 x double> poison, double %843, i64 0
  %862 = shufflevector <8 x double> %861, <8 x double> poison, <8 x i32> zeroinitializer
  %863 = fmul <8 x double> %860, %862
  %864 = fcmp ogt <8 x double> %863, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %865 = bitcast <8 x double> %863 to <8 x i64>
  %866 = select <8 x i1> %864, <8 x i64> %865, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %867 = bitcast <8 x i64> %866 to <8 x double>
  %868 = fcmp olt <8 x double> %867, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %869 = bitcast <8 x i64> %866 to <8 x double>
  %870 = select <8 x i1> %868, <8 x double> %869, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %871 = call <8 x double> @llvm.rint.v8f64(<8 x double> %870)
  %872 = fsub <8 x double> %870, %871
  %873 = call <8 x double> @llvm.fma.v8f64(<8 x double> %872, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %874 = call <8 x double> @llvm.fma.v8f64(<8 x double> %873, <8 x double> %872, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %875 = call <8 x double> @llvm.fma.v8f64(<8 x double> %874, <8 x double> %872, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %876 = call <8 x double> @llvm.fma.v8f64(<8 x double> %875, <8 x double> %872, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %877 = call <8 x double> @llvm.fma.v8f64(<8 x double> %876, <8 x double> %872, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %878 = call <8 x double> @llvm.fma.v8f64(<8 x double> %877, <8 x double> %872, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %879 = call <8 x double> @llvm.fma.v8f64(<8 x double> %878, <8 x double> %872, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %880 = bitcast <8 x double> %879 to <8 x i64>
  %881 = fptosi <8 x double> %871 to <8 x i32>
  %882 = zext <8 x i32> %881 to <8 x i64>
  %883 = shl <8 x i64> %882, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %884 = add <8 x i64> %883, %880
  %885 = bitcast <8 x i64> %884 to <8 x double>
  %886 = fmul <8 x double> %841, %885
  %887 = load double, ptr %130, align 8
  %888 = fcmp une double %887, 0.000000e+00
  br i1 %888, label %889, label %934

889:                                              ; preds = %831
  %890 = bitcast <8 x double> %833 to <8 x i64>
  %891 = add <8 x i64> %890, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %892 = ashr <8 x i64> %891, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %893 = and <8 x i64> %891, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %894 = sub <8 x i64> %890, %893
  %895 = bitcast <8 x i64> %894 to <8 x double>
  %896 = fadd <8 x double> %895, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %897 = fadd <8 x double> %895, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %898 = fdiv <8 x double> %896, %897
  %899 = fmul <8 x double> %898, %898
  %900 = call <8 x double> @llvm.fma.v8f64(<8 x double> %899, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %901 = call <8 x double> @llvm.fma.v8f64(<8 x double> %900, <8 x double> %899, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %902 = call <8 x double> @llvm.fma.v8f64(<8 x double> %901, <8 x double> %899, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %903 = call <8 x double> @llvm.fma.v8f64(<8 x double> %902, <8 x double> %899, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %904 = trunc nsw <8 x i64> %892 to <8 x i32>
  %905 = sitofp <8 x i32> %904 to <8 x double>
  %906 = fmul <8 x double> %898, %903
  %907 = fadd <8 x double> %906, %905
  %908 = insertelement <8 x double> poison, double %887, i64 0
  %909 = shufflevector <8 x double> %908, <8 x double> poison, <8 x i32> zeroinitializer
  %910 = fmul <8 x double> %909, %907
  %911 = fcmp ogt <8 x double> %910, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %912 = bitcast <8 x double> %910 to <8 x i64>
  %913 = select <8 x i1> %911, <8 x i64> %912, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %914 = bitcast <8 x i64> %913 to <8 x double>
  %915 = fcmp olt <8 x double> %914, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %916 = bitcast <8 x i64> %913 to <8 x double>
  %917 = select <8 x i1> %915, <8 x double> %916, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %918 = call <8 x double> @llvm.rint.v8f64(<8 x double> %917)
  %919 = fsub <8 x double> %917, %918
  %920 = call <8 x double> @llvm.fma.v8f64(<8 x double> %919, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %921 = call <8 x double> @llvm.fma.v8f64(<8 x double> %920, <8 x double> %919, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %922 = call <8 x double> @llvm.fma.v8f64(<8 x double> %921, <8 x double> %919, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %923 = call <8 x double> @llvm.fma.v8f64(<8 x double> %922, <8 x double> %919, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %924 = call <8 x double> @llvm.fma.v8f64(<8 x double> %923, <8 x double> %919, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %925 = call <8 x double> @llvm.fma.v8f64(<8 x double> %924, <8 x double> %919, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %926 = call <8 x double> @llvm.fma.v8f64(<8 x double> %925, <8 x double> %919, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %927 = bitcast <8 x double> %926 to <8 x i64>
  %928 = fptosi <8 x double> %918 to <8 x i32>
  %929 = zext <8 x i32> %928 to <8 x i64>
  %930 = shl <8 x i64> %929, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %931 = add <8 x i64> %930, %927
  %932 = bitcast <8 x i64> %931 to <8 x double>
  %933 = fmul <8 x double> %886, %932
  br label %934

934:                                              ; preds = %831, %889
  %935 = phi <8 x double> [ %933, %889 ], [ %886, %831 ]
  %936 = load double, ptr %131, align 8
  %937 = insertelement <8 x double> poison, double %936, i64 0
  %938 = shufflevector <8 x double> %937, <8 x double> poison, <8 x i32> zeroinitializer
  %939 = fcmp ogt <8 x double> %935, %938
  %940 = select <8 x i1> %939, <8 x double> %935, <8 x double> %938
  %941 = fcmp olt <8 x double> %835, %940
  %942 = select <8 x i1> %941, <8 x double> %835, <8 x double> %940
  %943 = fmul <8 x double> %246, %942
  %944 = fcmp ogt <8 x double> %538, <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>
  %945 = select <8 x i1> %944, <8 x i64> %837, <8 x i64> <i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789>
  %946 = bitcast <8 x double> %833 to <8 x i64>
  %947 = select <8 x i1> %817, <8 x i64> %945, <8 x i64> %946
  store <8 x i64> %947, ptr %832, align 8
  %948 = load ptr, ptr %127, align 8
  %949 = load double, ptr %132, align 8
  %950 = insertelement <8 x double> poison, double %949, i64 0
  %951 = bitcast <8 x double> %950 to <8 x i64>
  %952 = shufflevector <8 x i64> %951, <8 x i64> poison, <8 x i32> zeroinitializer
  %953 = icmp slt <8 x i64> %814, zeroinitializer
  %954 = select <8 x i1> %953, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> %952
  store <8 x i64> %954, ptr %948, align 8
  br label %955

955:                                              ; preds = %934, %812
  %956 = phi <8 x double> [ %943, %934 ], [ %228, %812 ]
  %957 = icmp ne <8 x i64> %814, zeroinitializer
  %958 = bitcast <8 x i1> %957 to i8
  %959 = icmp eq i8 %958, 0
  br i1 %959, label %1053, label %960

960:                                              ; preds = %955
  %961 = trunc i64 %586 to i8
  %962 = bitcast i8 %961 to <8 x i1>
  %963 = trunc nuw i64 %800 to i8
  %964 = bitcast i8 %963 to <8 x i1>
  %965 = load i64, ptr %7, align 8
  %966 = trunc i64 %965 to i8
  %967 = bitcast i8 %966 to <8 x i1>
  %968 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %538)
  %969 = fcmp one <8 x double> %968, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %970 = xor <8 x i1> %962, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %971 = select <8 x i1> %969, <8 x i1> %970, <8 x i1> zeroinitializer
  %972 = or <8 x i1> %967, %964
  %973 = xor <8 x i1> %972, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %974 = and <8 x i1> %971, %973
  br i1 %34, label %975, label %1034

975:                                              ; preds = %960
  %976 = fcmp ogt <8 x double> %538, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %977 = bitcast <8 x double> %538 to <8 x i64>
  %978 = select <8 x i1> %976, <8 x i64> %977, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %979 = load double, ptr %133, align 8
  %980 = insertelement <8 x double> poison, double %979, i64 0
  %981 = shufflevector <8 x double> %980, <8 x double> poison, <8 x i32> zeroinitializer
  %982 = load double, ptr %31, align 8
  %983 = fneg double %982
  %984 = add <8 x i64> %978, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %985 = ashr <8 x i64> %984, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %986 = and <8 x i64> %984, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %987 = sub <8 x i64> %978, %986
  %988 = bitcast <8 x i64> %987 to <8 x double>
  %989 = fadd <8 x double> %988, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %990 = fadd <8 x double> %988, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %991 = fdiv <8 x double> %989, %990
  %992 = fmul <8 x double> %991, %991
  %993 = call <8 x double> @llvm.fma.v8f64(<8 x double> %992, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %994 = call <8 x double> @llvm.fma.v8f64(<8 x double> %993, <8 x double> %992, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %995 = call <8 x double> @llvm.fma.v8f64(<8 x double> %994, <8 x double> %992, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %996 = call <8 x double> @llvm.fma.v8f64(<8 x double> %995, <8 x double> %992, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %997 = trunc nsw <8 x i64> %985 to <8 x i32>
  %998 = sitofp <8 x i32> %997 to <8 x double>
  %999 = fmul <8 x double> %991, %996
  %1000 = fadd <8 x double> %999, %998
  %1001 = insertelement <8 x double> poison, double %983, i64 0
  %1002 = shufflevector <8 x double> %1001, <8 x double> poison, <8 x i32> zeroinitializer
  %1003 = fmul <8 x double> %1000, %1002
  %1004 = fcmp ogt <8 x double> %1003, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1005 = bitcast <8 x double> %1003 to <8 x i64>
  %1006 = select <8 x i1> %1004, <8 x i64> %1005, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1007 = bitcast <8 x i64> %1006 to <8 x double>
  %1008 = fcmp olt <8 x double> %1007, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1009 = bitcast <8 x i64> %1006 to <8 x double>
  %1010 = select <8 x i1> %1008, <8 x double> %1009, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1011 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1010)
  %1012 = fsub <8 x double> %1010, %1011
  %1013 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1012, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1014 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1013, <8 x double> %1012, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1015 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1014, <8 x double> %1012, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1016 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1015, <8 x double> %1012, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1017 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1016, <8 x double> %1012, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1018 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1017, <8 x double> %1012, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1019 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1018, <8 x double> %1012, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1020 = bitcast <8 x double> %1019 to <8 x i64>
  %1021 = fptosi <8 x double> %1011 to <8 x i32>
  %1022 = zext <8 x i32> %1021 to <8 x i64>
  %1023 = shl <8 x i64> %1022, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1024 = add <8 x i64> %1023, %1020
  %1025 = bitcast <8 x i64> %1024 to <8 x double>
  %1026 = fmul <8 x double> %981, %1025
  %1027 = load double, ptr %134, align 8
  %1028 = insertelement <8 x double> poison, double %1027, i64 0
  %1029 = shufflevector <8 x double> %1028, <8 x double> poison, <8 x i32> zeroinitializer
  %1030 = fcmp ogt <8 x double> %1026, %1029
  %1031 = select <8 x i1> %1030, <8 x double> %1026, <8 x double> %1029
  %1032 = select <8 x i1> %974, <8 x double> %1031, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1033 = fmul <8 x double> %246, %1032
  br label %1034

1034:                                             ; preds = %960, %975
  %1035 = phi <8 x double> [ %1033, %975 ], [ zeroinitializer, %960 ]
  %1036 = or <8 x i1> %974, %967
  %1037 = select <8 x i1> %1036, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %1038 = icmp slt <8 x i64> %814, zeroinitializer
  %1039 = select <8 x i1> %1038, <8 x double> %1035, <8 x double> %956
  %1040 = load ptr, ptr %135, align 8
  %1041 = select <8 x i1> %964, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> %1037
  %1042 = load <8 x i64>, ptr %1040, align 8
  %1043 = select <8 x i1> %1038, <8 x i64> %1041, <8 x i64> %1042
  store <8 x i64> %1043, ptr %1040, align 8
  %1044 = load ptr, ptr %135, align 8
  %1045 = select <8 x i1> %962, <8 x i64> <i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152>, <8 x i64> %1037
  %1046 = load <8 x i64>, ptr %1044, align 8
  %1047 = select <8 x i1> %1038, <8 x i64> %1045, <8 x i64> %1046
  store <8 x i64> %1047, ptr %1044, align 8
  %1048 = load ptr, ptr %70, align 8
  %1049 = load <8 x double>, ptr %1048, align 8
  %1050 = select <8 x i1> %1038, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %1051 = bitcast <8 x i64> %1050 to <8 x double>
  %1052 = fadd <8 x double> %1049, %1051
  store <8 x double> %1052, ptr %1048, align 8
  br label %1053

1053:                                             ; preds = %1034, %955
  %1054 = phi <8 x double> [ %956, %955 ], [ %1039, %1034 ]
  %1055 = load ptr, ptr %66, align 8
  store <8 x double> %1054, ptr %1055, align 8
  %1056 = load ptr, ptr %53, align 8
  %1057 = select <8 x i1> %817, <8 x double> %798, <8 x double> %221
  store <8 x double> %1057, ptr %1056, align 8
  br i1 %136, label %1060, label %1058

1058:                                             ; preds = %1060, %1053
  %1059 = icmp eq i64 %802, 0
  br i1 %1059, label %1087, label %1078

1060:                                             ; preds = %1053, %1060
  %1061 = phi i64 [ %1076, %1060 ], [ 0, %1053 ]
  %1062 = load ptr, ptr %11, align 8
  %1063 = load ptr, ptr %137, align 8
  %1064 = shl nsw i64 %1061, 6
  %1065 = getelementptr inbounds i8, ptr %1063, i64 %1064
  %1066 = load <8 x i64>, ptr %1065, align 8
  %1067 = getelementptr inbounds i8, ptr %1062, i64 %1064
  %1068 = load <8 x i64>, ptr %1067, align 8
  %1069 = select <8 x i1> %817, <8 x i64> %1066, <8 x i64> %1068
  store <8 x i64> %1069, ptr %1067, align 8
  %1070 = load ptr, ptr %44, align 8
  %1071 = getelementptr inbounds i8, ptr %59, i64 %1064
  %1072 = load <8 x i64>, ptr %1071, align 8
  %1073 = getelementptr inbounds i8, ptr %1070, i64 %1064
  %1074 = load <8 x i64>, ptr %1073, align 8
  %1075 = select <8 x i1> %817, <8 x i64> %1072, <8 x i64> %1074
  store <8 x i64> %1075, ptr %1073, align 8
  %1076 = add nuw nsw i64 %1061, 1
  %1077 = icmp eq i64 %1076, %15
  br i1 %1077, label %1058, label %1060, !llvm.loop !18

1078:                                             ; preds = %1058
  %1079 = call fastcc i64 @act_in_lanes(ptr noundef %0, i64 noundef %802, ptr noundef nonnull %6) #11
  %1080 = icmp ne i32 %801, 0
  %1081 = icmp ne i64 %1079, %802
  %1082 = select i1 %1080, i1 true, i1 %1081
  %1083 = zext i1 %1082 to i32
  %1084 = trunc i64 %802 to i8
  %1085 = bitcast i8 %1084 to <8 x i1>
  %1086 = select <8 x i1> %1085, <8 x i64> zeroinitializer, <8 x i64> %799
  br label %1087

1087:                                             ; preds = %1078, %1058
  %1088 = phi <8 x i64> [ %1086, %1078 ], [ %799, %1058 ]
  %1089 = phi i32 [ %1083, %1078 ], [ %801, %1058 ]
  %1090 = phi i64 [ %1079, %1078 ], [ %189, %1058 ]
  %1091 = load ptr, ptr %114, align 8
  %1092 = load <8 x double>, ptr %1091, align 8
  %1093 = fcmp oeq <8 x double> %1092, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1094 = icmp ne <8 x i64> %1088, zeroinitializer
  %1095 = select <8 x i1> %1093, <8 x i1> %1094, <8 x i1> zeroinitializer
  %1096 = bitcast <8 x i1> %1095 to i8
  %1097 = icmp eq i8 %1096, 0
  br i1 %1097, label %1100, label %1098

1098:                                             ; preds = %1087
  %1099 = zext i8 %1096 to i64
  call fastcc void @retire(ptr noundef %0, i64 noundef %1099, i64 noundef 0) #11
  br label %1100

1100:                                             ; preds = %1098, %1087
  %1101 = phi i32 [ 1, %1098 ], [ %1089, %1087 ]
  br label %184

1102:                                             ; preds = %187, %212, %180
  %1103 = phi i64 [ 1, %180 ], [ 0, %212 ], [ 0, %187 ]
  ret i64 %1103
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
  %20 = getelementptr inbounds i8, ptr %0, i64 1224
  %21 = getelementptr inbounds i8, ptr %0, i64 1128
  %22 = getelementptr inbounds i8, ptr %0, i64 1024
  %23 = getelementptr inbounds i8, ptr %0, i64 1160
  %24 = getelementptr inbounds i8, ptr %0, i64 1152
  %25 = getelementptr inbounds i8, ptr %0, i64 1168
  %26 = getelementptr inbounds i8, ptr %0, i64 1048
  %27 = getelementptr inbounds i8, ptr %0, i64 1216
  %28 = getelementptr inbounds i8, ptr %0, i64 1200
  %29 = getelementptr inbounds i8, ptr %0, i64 1104
  %30 = getelementptr inbounds i8, ptr %0, i64 1464
  %31 = getelementptr inbounds i8, ptr %0, i64 1480
  %32 = getelementptr inbounds i8, ptr %0, i64 1416
  %33 = getelementptr inbounds i8, ptr %0, i64 1488
  %34 = getelementptr inbounds i8, ptr %0, i64 1504
  %35 = getelementptr inbounds i8, ptr %0, i64 1440
  %36 = getelementptr inbounds i8, ptr %0, i64 960
  br label %37

37:                                               ; preds = %2, %273
  %38 = phi i64 [ 0, %2 ], [ %283, %273 ]
  %39 = phi i64 [ 0, %2 ], [ %274, %273 ]
  %40 = phi i64 [ -1, %2 ], [ %282, %273 ]
  %41 = phi i64 [ 0, %2 ], [ %281, %273 ]
  %42 = load i64, ptr %6, align 8
  %43 = load i64, ptr %8, align 8
  %44 = icmp sge i64 %42, %43
  br i1 %44, label %76, label %45

45:                                               ; preds = %37
  %46 = load ptr, ptr %7, align 8
  %47 = load i64, ptr %11, align 8
  %48 = mul nsw i64 %47, %42
  %49 = getelementptr i64, ptr %46, i64 %48
  %50 = getelementptr i8, ptr %49, i64 24
  %51 = load i64, ptr %50, align 8
  %52 = icmp eq i64 %51, 0
  br i1 %52, label %76, label %71

53:                                               ; preds = %273
  %54 = getelementptr inbounds i8, ptr %0, i64 144
  store i64 %281, ptr %1, align 8
  %55 = icmp slt i64 %282, 0
  br i1 %55, label %395, label %56

56:                                               ; preds = %53
  %57 = getelementptr inbounds i8, ptr %0, i64 864
  %58 = getelementptr inbounds i8, ptr %0, i64 528
  %59 = getelementptr inbounds i8, ptr %0, i64 192
  %60 = getelementptr inbounds i8, ptr %0, i64 216
  %61 = getelementptr inbounds i8, ptr %0, i64 648
  %62 = getelementptr inbounds i8, ptr %0, i64 744
  br label %300

63:                                               ; preds = %71
  %64 = load ptr, ptr %7, align 8
  %65 = load i64, ptr %11, align 8
  %66 = mul nsw i64 %65, %73
  %67 = getelementptr i64, ptr %64, i64 %66
  %68 = getelementptr i8, ptr %67, i64 24
  %69 = load i64, ptr %68, align 8
  %70 = icmp eq i64 %69, 0
  br i1 %70, label %76, label %71, !llvm.loop !19

71:                                               ; preds = %45, %63
  %72 = phi i64 [ %73, %63 ], [ %42, %45 ]
  %73 = add nsw i64 %72, 1
  store i64 %73, ptr %6, align 8
  %74 = load i64, ptr %8, align 8
  %75 = icmp sge i64 %73, %74
  br i1 %75, label %76, label %63, !llvm.loop !19

76:                                               ; preds = %71, %63, %45, %37
  %77 = phi i64 [ %42, %37 ], [ %42, %45 ], [ %73, %63 ], [ %73, %71 ]
  %78 = phi i1 [ %44, %37 ], [ %44, %45 ], [ %75, %63 ], [ %75, %71 ]
  %79 = load ptr, ptr %10, align 8
  %80 = getelementptr inbounds i64, ptr %79, i64 %38
  %81 = load i64, ptr %80, align 8
  %82 = icmp ne i64 %81, -1
  %83 = or i1 %78, %82
  br i1 %83, label %273, label %84

84:                                               ; preds = %76
  %85 = add nsw i64 %77, 1
  store i64 %85, ptr %6, align 8
  %86 = load ptr, ptr %10, align 8
  %87 = getelementptr inbounds i64, ptr %86, i64 %38
  store i64 %77, ptr %87, align 8
  %88 = load ptr, ptr %5, align 8
  %89 = load ptr, ptr %9, align 8
  %90 = load i64, ptr %12, align 8
  %91 = mul nsw i64 %90, %77
  %92 = getelementptr inbounds double, ptr %89, i64 %91
  %93 = getelementptr double, ptr %88, i64 %38
  %94 = icmp sgt i64 %90, 0
  br i1 %94, label %95, label %104

95:                                               ; preds = %84, %95
  %96 = phi i64 [ %101, %95 ], [ 0, %84 ]
  %97 = getelementptr inbounds double, ptr %92, i64 %96
  %98 = load double, ptr %97, align 8
  %99 = shl i64 %96, 6
  %100 = getelementptr i8, ptr %93, i64 %99
  store double %98, ptr %100, align 8
  %101 = add nuw nsw i64 %96, 1
  %102 = load i64, ptr %12, align 8
  %103 = icmp slt i64 %101, %102
  br i1 %103, label %95, label %104, !llvm.loop !20

104:                                              ; preds = %95, %84
  %105 = load ptr, ptr %14, align 8
  %106 = load ptr, ptr %13, align 8
  %107 = load i64, ptr %15, align 8
  %108 = mul nsw i64 %107, %77
  %109 = getelementptr inbounds double, ptr %106, i64 %108
  %110 = getelementptr double, ptr %105, i64 %38
  %111 = icmp sgt i64 %107, 0
  br i1 %111, label %112, label %121

112:                                              ; preds = %104, %112
  %113 = phi i64 [ %118, %112 ], [ 0, %104 ]
  %114 = getelementptr inbounds double, ptr %109, i64 %113
  %115 = load double, ptr %114, align 8
  %116 = shl i64 %113, 6
  %117 = getelementptr i8, ptr %110, i64 %116
  store double %115, ptr %117, align 8
  %118 = add nuw nsw i64 %113, 1
  %119 = load i64, ptr %15, align 8
  %120 = icmp slt i64 %118, %119
  br i1 %120, label %112, label %121, !llvm.loop !20

121:                                              ; preds = %112, %104
  %122 = load ptr, ptr %17, align 8
  %123 = load ptr, ptr %16, align 8
  %124 = load i64, ptr %18, align 8
  %125 = mul nsw i64 %124, %77
  %126 = getelementptr inbounds double, ptr %123, i64 %125
  %127 = getelementptr double, ptr %122, i64 %38
  %128 = icmp sgt i64 %124, 0
  br i1 %128, label %129, label %138

129:                                              ; preds = %121, %129
  %130 = phi i64 [ %135, %129 ], [ 0, %121 ]
  %131 = getelementptr inbounds double, ptr %126, i64 %130
  %132 = load double, ptr %131, align 8
  %133 = shl i64 %130, 6
  %134 = getelementptr i8, ptr %127, i64 %133
  store double %132, ptr %134, align 8
  %135 = add nuw nsw i64 %130, 1
  %136 = load i64, ptr %18, align 8
  %137 = icmp slt i64 %135, %136
  br i1 %137, label %129, label %138, !llvm.loop !20

138:                                              ; preds = %129, %121
  %139 = load i64, ptr %19, align 8
  %140 = icmp sgt i64 %139, 0
  br i1 %140, label %141, label %266

141:                                              ; preds = %138
  %142 = load ptr, ptr %21, align 8
  %143 = getelementptr inbounds i64, ptr %142, i64 %38
  %144 = load i64, ptr %143, align 8
  %145 = inttoptr i64 %144 to ptr
  %146 = load i64, ptr %22, align 8
  %147 = icmp sgt i64 %146, 0
  br i1 %147, label %148, label %150

148:                                              ; preds = %141
  %149 = getelementptr inbounds i8, ptr %145, i64 192
  br label %153

150:                                              ; preds = %153, %141
  %151 = load i64, ptr %23, align 8
  %152 = icmp sgt i64 %151, 0
  br i1 %152, label %169, label %166

153:                                              ; preds = %148, %153
  %154 = phi i64 [ %146, %148 ], [ %164, %153 ]
  %155 = phi i64 [ 0, %148 ], [ %163, %153 ]
  %156 = load ptr, ptr %13, align 8
  %157 = mul nsw i64 %154, %77
  %158 = getelementptr double, ptr %156, i64 %157
  %159 = getelementptr double, ptr %158, i64 %155
  %160 = load double, ptr %159, align 8
  %161 = load ptr, ptr %149, align 8
  %162 = getelementptr inbounds double, ptr %161, i64 %155
  store double %160, ptr %162, align 8
  %163 = add nuw nsw i64 %155, 1
  %164 = load i64, ptr %22, align 8
  %165 = icmp slt i64 %163, %164
  br i1 %165, label %153, label %150, !llvm.loop !22

166:                                              ; preds = %169, %150
  %167 = load i64, ptr %27, align 8
  %168 = icmp sgt i64 %167, 0
  br i1 %168, label %196, label %188

169:                                              ; preds = %150, %169
  %170 = phi i64 [ %185, %169 ], [ 0, %150 ]
  %171 = load ptr, ptr %24, align 8
  %172 = load i64, ptr %25, align 8
  %173 = mul nsw i64 %172, %170
  %174 = getelementptr inbounds i64, ptr %171, i64 %173
  %175 = load i64, ptr %174, align 8
  %176 = inttoptr i64 %175 to ptr
  %177 = load ptr, ptr %16, align 8
  %178 = load i64, ptr %26, align 8
  %179 = mul nsw i64 %178, %77
  %180 = getelementptr inbounds double, ptr %177, i64 %179
  %181 = getelementptr i64, ptr %174, i64 %38
  %182 = getelementptr i8, ptr %181, i64 8
  %183 = load i64, ptr %182, align 8
  %184 = inttoptr i64 %183 to ptr
  tail call void %176(ptr noundef %180, ptr noundef %184) #12
  %185 = add nuw nsw i64 %170, 1
  %186 = load i64, ptr %23, align 8
  %187 = icmp slt i64 %185, %186
  br i1 %187, label %169, label %166, !llvm.loop !23

188:                                              ; preds = %196, %166
  %189 = load ptr, ptr %20, align 8
  %190 = getelementptr inbounds i8, ptr %189, i64 8
  %191 = load i64, ptr %190, align 8
  %192 = icmp sgt i64 %191, 0
  br i1 %192, label %193, label %262

193:                                              ; preds = %188
  %194 = getelementptr inbounds i8, ptr %145, i64 1200
  %195 = getelementptr inbounds i8, ptr %145, i64 960
  br label %217

196:                                              ; preds = %166, %196
  %197 = phi i64 [ %215, %196 ], [ %167, %166 ]
  %198 = phi i64 [ %214, %196 ], [ 0, %166 ]
  %199 = load ptr, ptr %28, align 8
  %200 = mul nsw i64 %197, %77
  %201 = getelementptr double, ptr %199, i64 %200
  %202 = getelementptr double, ptr %201, i64 %198
  %203 = load double, ptr %202, align 8
  %204 = load ptr, ptr %21, align 8
  %205 = getelementptr inbounds i64, ptr %204, i64 %38
  %206 = load i64, ptr %205, align 8
  %207 = inttoptr i64 %206 to ptr
  %208 = getelementptr inbounds i8, ptr %207, i64 696
  %209 = load ptr, ptr %208, align 8
  %210 = load ptr, ptr %29, align 8
  %211 = load i64, ptr %210, align 8
  %212 = getelementptr inbounds double, ptr %209, i64 %211
  %213 = getelementptr inbounds double, ptr %212, i64 %198
  store double %203, ptr %213, align 8
  %214 = add nuw nsw i64 %198, 1
  %215 = load i64, ptr %27, align 8
  %216 = icmp slt i64 %214, %215
  br i1 %216, label %196, label %188, !llvm.loop !24

217:                                              ; preds = %193, %231
  %218 = phi i64 [ 0, %193 ], [ %240, %231 ]
  %219 = load ptr, ptr %30, align 8
  %220 = load i64, ptr %31, align 8
  %221 = mul nsw i64 %220, %77
  %222 = getelementptr i64, ptr %219, i64 %221
  %223 = getelementptr i64, ptr %222, i64 %218
  %224 = load i64, ptr %223, align 8
  %225 = sitofp i64 %224 to double
  %226 = load ptr, ptr %32, align 8
  %227 = shl i64 %218, 6
  %228 = getelementptr i8, ptr %226, i64 %227
  %229 = getelementptr double, ptr %228, i64 %38
  store double %225, ptr %229, align 8
  %230 = mul i64 %218, 800
  br label %245

231:                                              ; preds = %255
  %232 = load ptr, ptr %195, align 8
  %233 = shl nuw nsw i64 %218, 1
  %234 = or disjoint i64 %233, 1
  %235 = getelementptr inbounds double, ptr %232, i64 %234
  store double 0x7FF8000000000000, ptr %235, align 8
  %236 = load ptr, ptr %195, align 8
  %237 = getelementptr inbounds double, ptr %236, i64 %233
  store double 0x7FF8000000000000, ptr %237, align 8
  %238 = load ptr, ptr %35, align 8
  %239 = getelementptr inbounds double, ptr %238, i64 %38
  store double 0x7FF8000000000000, ptr %239, align 8
  %240 = add nuw nsw i64 %218, 1
  %241 = load ptr, ptr %20, align 8
  %242 = getelementptr inbounds i8, ptr %241, i64 8
  %243 = load i64, ptr %242, align 8
  %244 = icmp slt i64 %240, %243
  br i1 %244, label %217, label %262, !llvm.loop !25

245:                                              ; preds = %217, %255
  %246 = phi i64 [ 0, %217 ], [ %260, %255 ]
  %247 = icmp eq i64 %246, 0
  br i1 %247, label %248, label %255

248:                                              ; preds = %245
  %249 = load ptr, ptr %33, align 8
  %250 = load i64, ptr %34, align 8
  %251 = mul nsw i64 %250, %77
  %252 = getelementptr double, ptr %249, i64 %251
  %253 = getelementptr double, ptr %252, i64 %218
  %254 = load double, ptr %253, align 8
  br label %255

255:                                              ; preds = %248, %245
  %256 = phi double [ %254, %248 ], [ 0xFFF0000000000000, %245 ]
  %257 = load ptr, ptr %194, align 8
  %258 = getelementptr inbounds i8, ptr %257, i64 %230
  %259 = getelementptr inbounds double, ptr %258, i64 %246
  store double %256, ptr %259, align 8
  %260 = add nuw nsw i64 %246, 1
  %261 = icmp eq i64 %260, 100
  br i1 %261, label %231, label %245, !llvm.loop !26

262:                                              ; preds = %231, %188
  %263 = getelementptr inbounds i8, ptr %145, i64 600
  %264 = load ptr, ptr %263, align 8
  %265 = getelementptr inbounds i8, ptr %264, i64 80
  store i64 0, ptr %265, align 8
  br label %266

266:                                              ; preds = %262, %138
  %267 = load ptr, ptr %36, align 8
  %268 = load double, ptr %267, align 8
  %269 = load ptr, ptr %3, align 8
  %270 = getelementptr inbounds double, ptr %269, i64 %38
  store double %268, ptr %270, align 8
  %271 = shl nuw nsw i64 1, %38
  %272 = or i64 %271, %39
  br label %273

273:                                              ; preds = %76, %266
  %274 = phi i64 [ %272, %266 ], [ %39, %76 ]
  %275 = load ptr, ptr %10, align 8
  %276 = getelementptr inbounds i64, ptr %275, i64 %38
  %277 = load i64, ptr %276, align 8
  %278 = icmp sgt i64 %277, -1
  %279 = shl nuw nsw i64 1, %38
  %280 = select i1 %278, i64 %279, i64 0
  %281 = or i64 %280, %41
  %282 = select i1 %278, i64 %38, i64 %40
  %283 = add nuw nsw i64 %38, 1
  %284 = icmp eq i64 %283, 8
  br i1 %284, label %53, label %37, !llvm.loop !27

285:                                              ; preds = %377
  %286 = load ptr, ptr %54, align 8
  %287 = getelementptr inbounds i8, ptr %286, i64 40
  %288 = load i64, ptr %287, align 8
  %289 = inttoptr i64 %288 to ptr
  %290 = getelementptr inbounds i8, ptr %0, i64 216
  %291 = load ptr, ptr %290, align 8
  %292 = getelementptr inbounds i8, ptr %0, i64 240
  %293 = load ptr, ptr %292, align 8
  tail call void %289(ptr noundef %291, ptr noundef %293) #12
  %294 = getelementptr inbounds i8, ptr %0, i64 1256
  %295 = load i64, ptr %294, align 8
  %296 = icmp sgt i64 %295, 0
  br i1 %296, label %297, label %395

297:                                              ; preds = %285
  %298 = getelementptr inbounds i8, ptr %0, i64 1248
  %299 = getelementptr inbounds i8, ptr %0, i64 216
  br label %380

300:                                              ; preds = %56, %377
  %301 = phi i64 [ 0, %56 ], [ %378, %377 ]
  %302 = load ptr, ptr %57, align 8
  %303 = getelementptr inbounds i64, ptr %302, i64 %301
  %304 = load i64, ptr %303, align 8
  %305 = icmp eq i64 %304, -1
  br i1 %305, label %306, label %377

306:                                              ; preds = %300
  %307 = load ptr, ptr %5, align 8
  %308 = load ptr, ptr %54, align 8
  %309 = getelementptr inbounds i8, ptr %308, i64 8
  %310 = load i64, ptr %309, align 8
  %311 = icmp sgt i64 %310, 0
  br i1 %311, label %312, label %321

312:                                              ; preds = %306, %312
  %313 = phi i64 [ %319, %312 ], [ 0, %306 ]
  %314 = shl i64 %313, 6
  %315 = getelementptr i8, ptr %307, i64 %314
  %316 = getelementptr double, ptr %315, i64 %282
  %317 = load double, ptr %316, align 8
  %318 = getelementptr double, ptr %315, i64 %301
  store double %317, ptr %318, align 8
  %319 = add nuw nsw i64 %313, 1
  %320 = icmp eq i64 %319, %310
  br i1 %320, label %321, label %312, !llvm.loop !28

321:                                              ; preds = %312, %306
  %322 = load ptr, ptr %58, align 8
  %323 = load ptr, ptr %54, align 8
  %324 = getelementptr inbounds i8, ptr %323, i64 8
  %325 = load i64, ptr %324, align 8
  %326 = icmp sgt i64 %325, 0
  br i1 %326, label %327, label %336

327:                                              ; preds = %321, %327
  %328 = phi i64 [ %334, %327 ], [ 0, %321 ]
  %329 = shl i64 %328, 6
  %330 = getelementptr i8, ptr %322, i64 %329
  %331 = getelementptr double, ptr %330, i64 %282
  %332 = load double, ptr %331, align 8
  %333 = getelementptr double, ptr %330, i64 %301
  store double %332, ptr %333, align 8
  %334 = add nuw nsw i64 %328, 1
  %335 = icmp eq i64 %334, %325
  br i1 %335, label %336, label %327, !llvm.loop !28

336:                                              ; preds = %327, %321
  %337 = load ptr, ptr %59, align 8
  %338 = load ptr, ptr %54, align 8
  %339 = getelementptr inbounds i8, ptr %338, i64 48
  %340 = load i64, ptr %339, align 8
  %341 = icmp sgt i64 %340, 0
  br i1 %341, label %342, label %351

342:                                              ; preds = %336, %342
  %343 = phi i64 [ %349, %342 ], [ 0, %336 ]
  %344 = shl i64 %343, 6
  %345 = getelementptr i8, ptr %337, i64 %344
  %346 = getelementptr double, ptr %345, i64 %282
  %347 = load double, ptr %346, align 8
  %348 = getelementptr double, ptr %345, i64 %301
  store double %347, ptr %348, align 8
  %349 = add nuw nsw i64 %343, 1
  %350 = icmp eq i64 %349, %340
  br i1 %350, label %351, label %342, !llvm.loop !28

351:                                              ; preds = %342, %336
  %352 = load ptr, ptr %60, align 8
  %353 = load ptr, ptr %54, align 8
  %354 = getelementptr inbounds i8, ptr %353, i64 56
  %355 = load i64, ptr %354, align 8
  %356 = icmp sgt i64 %355, 0
  br i1 %356, label %357, label %366

357:                                              ; preds = %351, %357
  %358 = phi i64 [ %364, %357 ], [ 0, %351 ]
  %359 = shl i64 %358, 6
  %360 = getelementptr i8, ptr %352, i64 %359
  %361 = getelementptr double, ptr %360, i64 %282
  %362 = load double, ptr %361, align 8
  %363 = getelementptr double, ptr %360, i64 %301
  store double %362, ptr %363, align 8
  %364 = add nuw nsw i64 %358, 1
  %365 = icmp eq i64 %364, %355
  br i1 %365, label %366, label %357, !llvm.loop !28

366:                                              ; preds = %357, %351
  %367 = load ptr, ptr %3, align 8
  %368 = getelementptr inbounds double, ptr %367, i64 %282
  %369 = load double, ptr %368, align 8
  %370 = getelementptr inbounds double, ptr %367, i64 %301
  store double %369, ptr %370, align 8
  %371 = load ptr, ptr %61, align 8
  %372 = getelementptr inbounds double, ptr %371, i64 %301
  store double 0.000000e+00, ptr %372, align 8
  %373 = load ptr, ptr %62, align 8
  %374 = getelementptr inbounds double, ptr %373, i64 %301
  store double 0x7FF0000000000000, ptr %374, align 8
  %375 = load ptr, ptr %57, align 8
  %376 = getelementptr inbounds i64, ptr %375, i64 %301
  store i64 -2, ptr %376, align 8
  br label %377

377:                                              ; preds = %300, %366
  %378 = add nuw nsw i64 %301, 1
  %379 = icmp eq i64 %378, 8
  br i1 %379, label %285, label %300, !llvm.loop !29

380:                                              ; preds = %297, %380
  %381 = phi i64 [ 0, %297 ], [ %392, %380 ]
  %382 = load ptr, ptr %298, align 8
  %383 = shl nuw nsw i64 %381, 1
  %384 = getelementptr inbounds i64, ptr %382, i64 %383
  %385 = load i64, ptr %384, align 8
  %386 = inttoptr i64 %385 to ptr
  %387 = load ptr, ptr %299, align 8
  %388 = or disjoint i64 %383, 1
  %389 = getelementptr inbounds i64, ptr %382, i64 %388
  %390 = load i64, ptr %389, align 8
  %391 = inttoptr i64 %390 to ptr
  tail call void %386(ptr noundef %387, ptr noundef %391) #12
  %392 = add nuw nsw i64 %381, 1
  %393 = load i64, ptr %294, align 8
  %394 = icmp slt i64 %392, %393
  br i1 %394, label %380, label %395, !llvm.loop !30

395:                                              ; preds = %380, %285, %53
  ret i64 %274
}

define internal fastcc void @start(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, i64 noundef %3) unnamed_addr #3 {
  %5 = alloca [8 x double], align 16
  %6 = alloca [8 x double], align 16
  %7 = alloca [8 x double], align 16
  %8 = getelementptr inbounds i8, ptr %0, i64 624
  %9 = getelementptr inbounds i8, ptr %0, i64 912
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
  %26 = getelementptr inbounds i8, ptr %20, i64 128
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
  %50 = getelementptr inbounds i8, ptr %0, i64 936
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
  br i1 %71, label %56, label %48, !llvm.loop !31

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
  br i1 %134, label %116, label %135, !llvm.loop !32

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
  %146 = getelementptr inbounds i8, ptr %136, i64 128
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
  br i1 %177, label %178, label %168, !llvm.loop !33

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
  %255 = getelementptr inbounds i8, ptr %0, i64 648
  %256 = load ptr, ptr %255, align 8
  %257 = load <8 x double>, ptr %256, align 8
  %258 = select <8 x i1> %16, <8 x double> %254, <8 x double> %257
  store <8 x double> %258, ptr %256, align 8
  %259 = getelementptr inbounds i8, ptr %0, i64 672
  %260 = load ptr, ptr %259, align 8
  %261 = load <8 x double>, ptr %260, align 8
  %262 = select <8 x i1> %16, <8 x double> <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>, <8 x double> %261
  store <8 x double> %262, ptr %260, align 8
  %263 = getelementptr inbounds i8, ptr %0, i64 696
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
  %275 = getelementptr inbounds i8, ptr %0, i64 768
  %276 = load ptr, ptr %275, align 8
  %277 = load <8 x double>, ptr %276, align 8
  %278 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %277
  store <8 x double> %278, ptr %276, align 8
  %279 = getelementptr inbounds i8, ptr %0, i64 792
  %280 = load ptr, ptr %279, align 8
  %281 = load <8 x double>, ptr %280, align 8
  %282 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %281
  store <8 x double> %282, ptr %280, align 8
  %283 = getelementptr inbounds i8, ptr %0, i64 816
  %284 = load ptr, ptr %283, align 8
  %285 = load <8 x double>, ptr %284, align 8
  %286 = select <8 x i1> %13, <8 x double> zeroinitializer, <8 x double> %285
  store <8 x double> %286, ptr %284, align 8
  %287 = getelementptr inbounds i8, ptr %0, i64 840
  %288 = load ptr, ptr %287, align 8
  %289 = tail call <8 x i1> @llvm.is.fpclass.v8f64(<8 x double> %254, i32 384)
  %290 = select <8 x i1> %289, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %291 = load <8 x i64>, ptr %288, align 8
  %292 = select <8 x i1> %16, <8 x i64> %290, <8 x i64> %291
  store <8 x i64> %292, ptr %288, align 8
  %293 = icmp eq i64 %2, 0
  br i1 %293, label %326, label %294

294:                                              ; preds = %253
  %295 = getelementptr inbounds i8, ptr %0, i64 864
  %296 = getelementptr inbounds i8, ptr %0, i64 960
  %297 = getelementptr inbounds i8, ptr %0, i64 968
  %298 = getelementptr inbounds i8, ptr %0, i64 720
  %299 = getelementptr inbounds i8, ptr %0, i64 744
  %300 = getelementptr inbounds i8, ptr %0, i64 888
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
  br i1 %325, label %326, label %301, !llvm.loop !34

326:                                              ; preds = %301, %253
  %327 = xor i64 %40, -1
  %328 = and i64 %327, %2
  %329 = icmp eq i64 %328, 0
  br i1 %329, label %333, label %330

330:                                              ; preds = %326
  %331 = getelementptr inbounds i8, ptr %0, i64 744
  %332 = getelementptr inbounds i8, ptr %0, i64 960
  br label %354

333:                                              ; preds = %354, %326
  %334 = and i64 %14, %40
  %335 = xor i64 %334, %14
  %336 = getelementptr inbounds i8, ptr %0, i64 744
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
  br i1 %367, label %333, label %354, !llvm.loop !35
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
  br i1 %13, label %59, label %14

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
  %28 = getelementptr inbounds i8, ptr %0, i64 1136
  %29 = getelementptr inbounds i8, ptr %0, i64 1200
  %30 = getelementptr inbounds i8, ptr %0, i64 1224
  %31 = getelementptr inbounds i8, ptr %0, i64 1216
  %32 = getelementptr inbounds i8, ptr %0, i64 1128
  %33 = getelementptr inbounds i8, ptr %0, i64 1104
  %34 = getelementptr inbounds i8, ptr %0, i64 1416
  %35 = getelementptr inbounds i8, ptr %0, i64 1464
  %36 = getelementptr inbounds i8, ptr %0, i64 1480
  %37 = getelementptr inbounds i8, ptr %0, i64 1128
  %38 = getelementptr inbounds i8, ptr %0, i64 1512
  %39 = getelementptr inbounds i8, ptr %0, i64 1528
  br label %40

40:                                               ; preds = %14, %176
  %41 = phi i64 [ %1, %14 ], [ %180, %176 ]
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

59:                                               ; preds = %176, %3
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
  br i1 %85, label %60, label %63, !llvm.loop !36

86:                                               ; preds = %60, %86
  %87 = phi i64 [ %90, %86 ], [ 0, %60 ]
  %88 = mul nsw i64 %87, %12
  %89 = getelementptr inbounds double, ptr %62, i64 %88
  store double 0x7FF8000000000000, ptr %89, align 8
  %90 = add nuw nsw i64 %87, 1
  %91 = icmp eq i64 %90, %9
  br i1 %91, label %82, label %86, !llvm.loop !37

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
  br i1 %106, label %107, label %176

107:                                              ; preds = %97
  %108 = load i64, ptr %31, align 8
  %109 = icmp sgt i64 %108, 0
  br i1 %109, label %115, label %110

110:                                              ; preds = %115, %107
  %111 = load ptr, ptr %30, align 8
  %112 = getelementptr inbounds i8, ptr %111, i64 8
  %113 = load i64, ptr %112, align 8
  %114 = icmp sgt i64 %113, 0
  br i1 %114, label %136, label %175

115:                                              ; preds = %107, %115
  %116 = phi i64 [ %134, %115 ], [ %108, %107 ]
  %117 = phi i64 [ %133, %115 ], [ 0, %107 ]
  %118 = load ptr, ptr %32, align 8
  %119 = getelementptr inbounds i64, ptr %118, i64 %42
  %120 = load i64, ptr %119, align 8
  %121 = inttoptr i64 %120 to ptr
  %122 = getelementptr inbounds i8, ptr %121, i64 696
  %123 = load ptr, ptr %122, align 8
  %124 = load ptr, ptr %33, align 8
  %125 = load i64, ptr %124, align 8
  %126 = getelementptr inbounds double, ptr %123, i64 %125
  %127 = getelementptr inbounds double, ptr %126, i64 %117
  %128 = load double, ptr %127, align 8
  %129 = load ptr, ptr %29, align 8
  %130 = mul nsw i64 %116, %45
  %131 = getelementptr double, ptr %129, i64 %130
  %132 = getelementptr double, ptr %131, i64 %117
  store double %128, ptr %132, align 8
  %133 = add nuw nsw i64 %117, 1
  %134 = load i64, ptr %31, align 8
  %135 = icmp slt i64 %133, %134
  br i1 %135, label %115, label %110, !llvm.loop !38

136:                                              ; preds = %110, %151
  %137 = phi i64 [ %157, %151 ], [ 2, %110 ]
  %138 = phi i64 [ %152, %151 ], [ 0, %110 ]
  %139 = load ptr, ptr %34, align 8
  %140 = shl i64 %138, 6
  %141 = getelementptr i8, ptr %139, i64 %140
  %142 = getelementptr double, ptr %141, i64 %42
  %143 = load double, ptr %142, align 8
  %144 = fptosi double %143 to i64
  %145 = load ptr, ptr %35, align 8
  %146 = load i64, ptr %36, align 8
  %147 = mul nsw i64 %146, %45
  %148 = getelementptr i64, ptr %145, i64 %147
  %149 = getelementptr i64, ptr %148, i64 %138
  store i64 %144, ptr %149, align 8
  %150 = shl nuw nsw i64 %138, 1
  br label %158

151:                                              ; preds = %158
  %152 = add nuw nsw i64 %138, 1
  %153 = load ptr, ptr %30, align 8
  %154 = getelementptr inbounds i8, ptr %153, i64 8
  %155 = load i64, ptr %154, align 8
  %156 = icmp slt i64 %152, %155
  %157 = add nuw i64 %137, 2
  br i1 %156, label %136, label %175, !llvm.loop !39

158:                                              ; preds = %136, %158
  %159 = phi i64 [ %150, %136 ], [ %173, %158 ]
  %160 = load ptr, ptr %37, align 8
  %161 = getelementptr inbounds i64, ptr %160, i64 %42
  %162 = load i64, ptr %161, align 8
  %163 = inttoptr i64 %162 to ptr
  %164 = getelementptr inbounds i8, ptr %163, i64 960
  %165 = load ptr, ptr %164, align 8
  %166 = getelementptr inbounds double, ptr %165, i64 %159
  %167 = load double, ptr %166, align 8
  %168 = load ptr, ptr %38, align 8
  %169 = load i64, ptr %39, align 8
  %170 = mul nsw i64 %169, %45
  %171 = getelementptr double, ptr %168, i64 %170
  %172 = getelementptr double, ptr %171, i64 %159
  store double %167, ptr %172, align 8
  %173 = add nuw nsw i64 %159, 1
  %174 = icmp eq i64 %173, %137
  br i1 %174, label %151, label %158, !llvm.loop !40

175:                                              ; preds = %151, %110
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %42) #11
  br label %176

176:                                              ; preds = %175, %97
  %177 = load ptr, ptr %15, align 8
  %178 = getelementptr inbounds i64, ptr %177, i64 %42
  store i64 -1, ptr %178, align 8
  %179 = add nsw i64 %41, -1
  %180 = and i64 %179, %41
  %181 = icmp eq i64 %180, 0
  br i1 %181, label %59, label %40, !llvm.loop !41
}

define internal fastcc range(i64 0, 256) i64 @hold_lanes(ptr noundef readonly %0, ptr noundef readonly %1, ptr noundef %2, i64 noundef %3, i32 noundef %4) unnamed_addr #2 {
  %6 = getelementptr inbounds i8, ptr %0, i64 1176
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %0, i64 144
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %9, i64 8
  %11 = load i64, ptr %10, align 8
  %12 = icmp eq i64 %3, 0
  br i1 %12, label %29, label %13

13:                                               ; preds = %5
  %14 = getelementptr inbounds i8, ptr %0, i64 1128
  %15 = icmp sgt i64 %11, 0
  %16 = getelementptr inbounds i8, ptr %0, i64 360
  %17 = icmp eq i32 %4, 0
  %18 = icmp sgt i64 %11, 0
  br label %19

19:                                               ; preds = %13, %59
  %20 = phi i64 [ 0, %13 ], [ %44, %59 ]
  %21 = phi i64 [ %3, %13 ], [ %61, %59 ]
  %22 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %21, i1 true)
  %23 = load ptr, ptr %14, align 8
  %24 = getelementptr inbounds i64, ptr %23, i64 %22
  %25 = load i64, ptr %24, align 8
  %26 = inttoptr i64 %25 to ptr
  %27 = getelementptr inbounds i8, ptr %26, i64 312
  %28 = load ptr, ptr %27, align 8
  br i1 %15, label %46, label %31

29:                                               ; preds = %59, %5
  %30 = phi i64 [ 0, %5 ], [ %44, %59 ]
  ret i64 %30

31:                                               ; preds = %46, %19
  %32 = getelementptr inbounds i8, ptr %26, i64 648
  %33 = load ptr, ptr %32, align 8
  %34 = getelementptr inbounds i8, ptr %33, i64 56
  %35 = load i64, ptr %34, align 8
  %36 = inttoptr i64 %35 to ptr
  %37 = getelementptr inbounds double, ptr %1, i64 %22
  %38 = load double, ptr %37, align 8
  %39 = select i1 %17, ptr null, ptr %28
  %40 = tail call i64 %36(ptr noundef %26, double noundef %38, ptr noundef %7, ptr noundef %39) #12
  %41 = icmp eq i64 %40, 0
  %42 = shl nuw i64 1, %22
  %43 = select i1 %41, i64 0, i64 %42
  %44 = or i64 %43, %20
  %45 = getelementptr inbounds double, ptr %2, i64 %22
  br i1 %18, label %63, label %59

46:                                               ; preds = %19, %46
  %47 = phi i64 [ %57, %46 ], [ 0, %19 ]
  %48 = shl nsw i64 %47, 3
  %49 = add nuw nsw i64 %48, %22
  %50 = getelementptr inbounds double, ptr %2, i64 %49
  %51 = load double, ptr %50, align 8
  %52 = getelementptr inbounds double, ptr %7, i64 %47
  store double %51, ptr %52, align 8
  %53 = load ptr, ptr %16, align 8
  %54 = getelementptr inbounds double, ptr %53, i64 %49
  %55 = load double, ptr %54, align 8
  %56 = getelementptr inbounds double, ptr %28, i64 %47
  store double %55, ptr %56, align 8
  %57 = add nuw nsw i64 %47, 1
  %58 = icmp eq i64 %57, %11
  br i1 %58, label %31, label %46, !llvm.loop !42

59:                                               ; preds = %63, %31
  %60 = add nsw i64 %21, -1
  %61 = and i64 %60, %21
  %62 = icmp eq i64 %61, 0
  br i1 %62, label %29, label %19, !llvm.loop !43

63:                                               ; preds = %31, %63
  %64 = phi i64 [ %69, %63 ], [ 0, %31 ]
  %65 = getelementptr inbounds double, ptr %7, i64 %64
  %66 = load double, ptr %65, align 8
  %67 = shl nsw i64 %64, 6
  %68 = getelementptr inbounds i8, ptr %45, i64 %67
  store double %66, ptr %68, align 8
  %69 = add nuw nsw i64 %64, 1
  %70 = icmp eq i64 %69, %11
  br i1 %70, label %59, label %63, !llvm.loop !44
}

define internal fastcc range(i64 0, 256) i64 @clear_lanes(ptr noundef readonly %0) unnamed_addr #3 {
  %2 = getelementptr inbounds i8, ptr %0, i64 360
  %3 = getelementptr inbounds i8, ptr %0, i64 1224
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 1128
  %6 = load ptr, ptr %5, align 8
  %7 = load i64, ptr %6, align 8
  %8 = inttoptr i64 %7 to ptr
  %9 = getelementptr inbounds i8, ptr %8, i64 816
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %4, i64 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 432
  %14 = load ptr, ptr %13, align 8
  %15 = load <8 x double>, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %4, i64 24
  %17 = load i64, ptr %16, align 8
  %18 = icmp eq i64 %17, 0
  br i1 %18, label %142, label %19

19:                                               ; preds = %1
  %20 = getelementptr inbounds i8, ptr %0, i64 1352
  %21 = load i64, ptr %20, align 8
  %22 = icmp sgt i64 %21, 0
  br i1 %22, label %23, label %30

23:                                               ; preds = %19
  %24 = getelementptr inbounds i8, ptr %0, i64 1344
  %25 = getelementptr inbounds i8, ptr %0, i64 384
  %26 = getelementptr inbounds i8, ptr %0, i64 528
  %27 = getelementptr inbounds i8, ptr %0, i64 368
  %28 = getelementptr inbounds i8, ptr %0, i64 1296
  %29 = getelementptr inbounds i8, ptr %4, i64 32
  br label %62

30:                                               ; preds = %85, %19
  %31 = getelementptr inbounds i8, ptr %0, i64 1296
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
  %42 = getelementptr inbounds i8, ptr %0, i64 624
  %43 = load ptr, ptr %42, align 8
  %44 = load <8 x double>, ptr %43, align 8
  store <8 x double> %44, ptr %41, align 8
  %45 = load i64, ptr %16, align 8
  %46 = load ptr, ptr %40, align 8
  %47 = load ptr, ptr %2, align 8
  %48 = load ptr, ptr %31, align 8
  %49 = getelementptr inbounds i8, ptr %0, i64 1320
  %50 = load ptr, ptr %49, align 8
  %51 = getelementptr inbounds i8, ptr %0, i64 1392
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
  %61 = getelementptr inbounds i8, ptr %0, i64 1416
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
  br i1 %95, label %62, label %30, !llvm.loop !45

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
  br i1 %109, label %85, label %96, !llvm.loop !46

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
  br i1 %141, label %110, label %116, !llvm.loop !47

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
  br i1 %17, label %8, label %13, !llvm.loop !48

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
  br i1 %46, label %40, label %18, !llvm.loop !49
}

define internal fastcc range(i64 0, 256) i64 @write_within(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef %3, ptr noundef readonly %4) unnamed_addr #3 {
  %6 = alloca [8 x i64], align 16
  %7 = getelementptr inbounds i8, ptr %0, i64 624
  %8 = load ptr, ptr %7, align 8
  %9 = load <8 x double>, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %1, i64 16
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %11, i64 72
  %13 = load ptr, ptr %12, align 8
  %14 = load <8 x double>, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 720
  %16 = load ptr, ptr %15, align 8
  %17 = load <8 x double>, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %0, i64 744
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
  %34 = getelementptr inbounds i8, ptr %0, i64 888
  %35 = load ptr, ptr %34, align 8
  br label %39

36:                                               ; preds = %39
  %37 = getelementptr inbounds i8, ptr %1, i64 8
  %38 = getelementptr inbounds i8, ptr %0, i64 1216
  br label %46

39:                                               ; preds = %31, %39
  %40 = phi i64 [ 0, %31 ], [ %44, %39 ]
  %41 = getelementptr inbounds i64, ptr %35, i64 %40
  %42 = load i64, ptr %41, align 8
  %43 = getelementptr inbounds [8 x i64], ptr %6, i64 0, i64 %40
  store i64 %42, ptr %43, align 8
  %44 = add nuw nsw i64 %40, 1
  %45 = icmp eq i64 %44, 8
  br i1 %45, label %36, label %39, !llvm.loop !50

46:                                               ; preds = %36, %91
  %47 = phi i64 [ %59, %91 ], [ %2, %36 ]
  %48 = phi i64 [ %92, %91 ], [ 0, %36 ]
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
  br i1 %62, label %111, label %63

63:                                               ; preds = %61
  %64 = getelementptr inbounds i8, ptr %0, i64 888
  br label %95

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
  %85 = load i64, ptr %38, align 8
  %86 = icmp sgt i64 %85, 0
  br i1 %86, label %87, label %91

87:                                               ; preds = %65
  %88 = load ptr, ptr %18, align 8
  %89 = tail call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %88, ptr noundef %22, i64 noundef %59, i32 noundef 0) #11
  %90 = or i64 %89, %48
  br label %91

91:                                               ; preds = %87, %65
  %92 = phi i64 [ %90, %87 ], [ %48, %65 ]
  %93 = xor i64 %92, -1
  %94 = and i64 %59, %93
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %22, i64 noundef %94) #11
  br label %46, !llvm.loop !51

95:                                               ; preds = %63, %95
  %96 = phi i64 [ %48, %63 ], [ %109, %95 ]
  %97 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %96, i1 true)
  %98 = extractelement <8 x double> %17, i64 %97
  %99 = load ptr, ptr %15, align 8
  %100 = getelementptr inbounds double, ptr %99, i64 %97
  store double %98, ptr %100, align 8
  %101 = extractelement <8 x double> %20, i64 %97
  %102 = load ptr, ptr %18, align 8
  %103 = getelementptr inbounds double, ptr %102, i64 %97
  store double %101, ptr %103, align 8
  %104 = getelementptr inbounds [8 x i64], ptr %6, i64 0, i64 %97
  %105 = load i64, ptr %104, align 8
  %106 = load ptr, ptr %64, align 8
  %107 = getelementptr inbounds i64, ptr %106, i64 %97
  store i64 %105, ptr %107, align 8
  %108 = add nsw i64 %96, -1
  %109 = and i64 %108, %96
  %110 = icmp eq i64 %109, 0
  br i1 %110, label %111, label %95, !llvm.loop !52

111:                                              ; preds = %95, %61
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
  br i1 %54, label %39, label %38, !llvm.loop !53
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
  br i1 %45, label %28, label %19, !llvm.loop !54

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
  br i1 %54, label %29, label %46, !llvm.loop !55
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
  %10 = getelementptr inbounds i8, ptr %0, i64 1128
  %11 = icmp sgt i64 %7, 0
  %12 = getelementptr inbounds i8, ptr %0, i64 360
  %13 = getelementptr inbounds i8, ptr %0, i64 624
  %14 = getelementptr inbounds i8, ptr %0, i64 1224
  %15 = getelementptr inbounds i8, ptr %0, i64 1440
  %16 = getelementptr inbounds i8, ptr %0, i64 1416
  %17 = getelementptr inbounds i8, ptr %0, i64 1368
  %18 = icmp sgt i64 %7, 0
  %19 = getelementptr inbounds i8, ptr %0, i64 360
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
  br i1 %50, label %34, label %40, !llvm.loop !56

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
  br i1 %94, label %80, label %83, !llvm.loop !57

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
  br i1 %139, label %120, label %123, !llvm.loop !58

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
  br i1 %195, label %177, label %180, !llvm.loop !59

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
  br i1 %210, label %196, label %200, !llvm.loop !60

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
  br i1 %218, label %32, label %20, !llvm.loop !61
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
  br i1 %48, label %13, label %20, !llvm.loop !62
}

declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #6

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #6

declare <8 x double> @llvm.rint.v8f64(<8 x double>) #6

declare <8 x double> @llvm.ceil.v8f64(<8 x double>) #6

define internal fastcc void @empty_log(ptr noundef readonly %0, i64 noundef %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 1224
  %4 = getelementptr inbounds i8, ptr %0, i64 1128
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i64, ptr %5, i64 %1
  %7 = load i64, ptr %6, align 8
  %8 = inttoptr i64 %7 to ptr
  %9 = getelementptr inbounds i8, ptr %8, i64 600
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 80
  %12 = getelementptr inbounds i8, ptr %0, i64 1608
  %13 = getelementptr inbounds i8, ptr %0, i64 1624
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 1568
  %16 = load i64, ptr %11, align 8
  %17 = icmp sgt i64 %16, 0
  br i1 %17, label %18, label %33

18:                                               ; preds = %2
  %19 = getelementptr inbounds i8, ptr %0, i64 1560
  %20 = getelementptr inbounds i8, ptr %0, i64 864
  %21 = getelementptr inbounds i8, ptr %0, i64 1536
  %22 = getelementptr inbounds i8, ptr %8, i64 1008
  %23 = getelementptr inbounds i8, ptr %8, i64 1032
  %24 = getelementptr inbounds i8, ptr %0, i64 1584
  %25 = icmp sgt i64 %14, 0
  %26 = getelementptr inbounds i8, ptr %8, i64 1056
  %27 = getelementptr inbounds i8, ptr %8, i64 1080
  %28 = getelementptr inbounds i8, ptr %0, i64 1632
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
  br i1 %60, label %29, label %33, !llvm.loop !63

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
  br i1 %76, label %57, label %61, !llvm.loop !64
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
  br i1 %50, label %51, label %25, !llvm.loop !65

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
  br i1 %98, label %14, label %19, !llvm.loop !66

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
  br i1 %123, label %104, label %110, !llvm.loop !65

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
  br i1 %138, label %99, label %139, !llvm.loop !67

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
  br i1 %24, label %14, label %13, !llvm.loop !68

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
  br i1 %70, label %59, label %71, !llvm.loop !69

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
  br i1 %99, label %21, label %25, !llvm.loop !70
}

define internal fastcc range(i64 0, 256) i64 @quiet_lanes(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef readonly %3) unnamed_addr #3 {
  %5 = alloca [5 x <8 x double>], align 64
  %6 = getelementptr inbounds i8, ptr %0, i64 1224
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 1128
  %11 = load ptr, ptr %10, align 8
  %12 = load i64, ptr %11, align 8
  %13 = inttoptr i64 %12 to ptr
  %14 = getelementptr inbounds i8, ptr %13, i64 816
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 1440
  %17 = load ptr, ptr %16, align 8
  %18 = load <8 x double>, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 624
  %20 = load ptr, ptr %19, align 8
  %21 = load <8 x double>, ptr %20, align 8
  %22 = fcmp une <8 x double> %18, %21
  %23 = bitcast <8 x i1> %22 to i8
  %24 = zext i8 %23 to i64
  %25 = and i64 %24, %2
  %26 = icmp eq i64 %25, 0
  br i1 %26, label %94, label %27

27:                                               ; preds = %4
  %28 = getelementptr inbounds i8, ptr %0, i64 1392
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
  %58 = getelementptr inbounds i8, ptr %0, i64 272
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
  %73 = getelementptr inbounds i8, ptr %0, i64 1272
  %74 = load ptr, ptr %73, align 8
  %75 = inttoptr i64 %65 to ptr
  %76 = tail call i32 %75(ptr noundef %67, ptr noundef %70, ptr noundef %72, ptr noundef %74, ptr noundef %29) #12
  %77 = zext i32 %76 to i64
  %78 = and i64 %77, %24
  %79 = icmp sgt i64 %9, 0
  br i1 %79, label %80, label %94

80:                                               ; preds = %63
  %81 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %93, label %94, label %82, !llvm.loop !71

94:                                               ; preds = %82, %63, %4
  %95 = phi i64 [ 0, %4 ], [ %78, %63 ], [ %78, %82 ]
  %96 = getelementptr inbounds i8, ptr %0, i64 1368
  %97 = shl i64 %9, 6
  %98 = getelementptr inbounds i8, ptr %1, i64 16
  %99 = getelementptr inbounds i8, ptr %1, i64 8
  %100 = getelementptr inbounds i8, ptr %0, i64 168
  %101 = getelementptr inbounds i8, ptr %0, i64 272
  %102 = getelementptr inbounds i8, ptr %0, i64 144
  %103 = getelementptr inbounds i8, ptr %0, i64 168
  %104 = getelementptr inbounds i8, ptr %0, i64 192
  %105 = getelementptr inbounds i8, ptr %0, i64 1272
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
  %114 = getelementptr inbounds i8, ptr %0, i64 1416
  %115 = load ptr, ptr %114, align 8
  %116 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %173, label %106, label %119, !llvm.loop !72

174:                                              ; preds = %302, %106
  %175 = phi <8 x i64> [ %111, %106 ], [ %304, %302 ]
  %176 = icmp sgt i64 %9, 0
  br i1 %176, label %177, label %307

177:                                              ; preds = %174
  %178 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %223, label %189, label %194, !llvm.loop !73

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
  br i1 %301, label %302, label %242, !llvm.loop !74

302:                                              ; preds = %299
  %303 = xor <8 x i64> %300, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %304 = and <8 x i64> %237, %303
  %305 = add nuw nsw i64 %184, 1
  %306 = icmp eq i64 %305, %9
  br i1 %306, label %174, label %181, !llvm.loop !75

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
  br i1 %328, label %307, label %316, !llvm.loop !76
}

define internal fastcc i64 @look_alone(ptr noundef readonly %0, i64 noundef %1, double noundef %2, ptr noundef writeonly %3) unnamed_addr #2 {
  %5 = getelementptr inbounds i8, ptr %0, i64 1128
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds i64, ptr %6, i64 %1
  %8 = load i64, ptr %7, align 8
  %9 = inttoptr i64 %8 to ptr
  %10 = getelementptr inbounds i8, ptr %0, i64 360
  %11 = getelementptr inbounds i8, ptr %9, i64 312
  %12 = getelementptr inbounds i8, ptr %0, i64 144
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %13, i64 8
  %15 = load i64, ptr %14, align 8
  %16 = icmp sgt i64 %15, 0
  br i1 %16, label %17, label %24

17:                                               ; preds = %4
  %18 = getelementptr inbounds i8, ptr %0, i64 384
  %19 = getelementptr inbounds i8, ptr %9, i64 336
  %20 = getelementptr inbounds i8, ptr %0, i64 552
  %21 = getelementptr inbounds i8, ptr %0, i64 368
  %22 = getelementptr inbounds i8, ptr %9, i64 504
  %23 = getelementptr inbounds i8, ptr %9, i64 320
  br label %122

24:                                               ; preds = %140, %4
  %25 = getelementptr inbounds i8, ptr %0, i64 1224
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
  %39 = getelementptr inbounds i8, ptr %0, i64 1440
  %40 = load ptr, ptr %39, align 8
  %41 = getelementptr inbounds double, ptr %40, i64 %1
  %42 = load double, ptr %41, align 8
  store double %42, ptr %38, align 8
  %43 = icmp sgt i64 %32, 0
  br i1 %43, label %44, label %64

44:                                               ; preds = %24
  %45 = getelementptr inbounds i8, ptr %0, i64 1416
  %46 = getelementptr inbounds i8, ptr %29, i64 888
  %47 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %63, label %64, label %48, !llvm.loop !59

64:                                               ; preds = %48, %24
  %65 = getelementptr inbounds i8, ptr %9, i64 576
  %66 = load ptr, ptr %65, align 8
  store double %2, ptr %66, align 8
  %67 = getelementptr inbounds i8, ptr %9, i64 720
  %68 = load ptr, ptr %67, align 8
  %69 = getelementptr inbounds i8, ptr %68, i64 16
  %70 = load i64, ptr %69, align 8
  %71 = inttoptr i64 %70 to ptr
  %72 = getelementptr inbounds i8, ptr %0, i64 624
  %73 = load ptr, ptr %72, align 8
  %74 = getelementptr inbounds double, ptr %73, i64 %1
  %75 = load double, ptr %74, align 8
  %76 = getelementptr inbounds i8, ptr %0, i64 432
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
  %103 = getelementptr inbounds i8, ptr %0, i64 1416
  %104 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %120, label %121, label %105, !llvm.loop !59

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
  br i1 %142, label %24, label %122, !llvm.loop !77

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
  br i1 %161, label %143, label %140, !llvm.loop !78
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
  br i1 %31, label %20, label %19, !llvm.loop !79

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
  br i1 %43, label %32, label %24, !llvm.loop !80
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
!24 = distinct !{!24, !4, !5, !21}
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
!36 = distinct !{!36, !4, !5}
!37 = distinct !{!37, !4, !5, !21}
!38 = distinct !{!38, !4, !5, !21}
!39 = distinct !{!39, !4, !5}
!40 = distinct !{!40, !4, !5}
!41 = distinct !{!41, !4, !5}
!42 = distinct !{!42, !4, !5, !21}
!43 = distinct !{!43, !4, !5}
!44 = distinct !{!44, !4, !5, !21}
!45 = distinct !{!45, !4, !5}
!46 = distinct !{!46, !4, !5}
!47 = distinct !{!47, !4, !5}
!48 = distinct !{!48, !4, !5}
!49 = distinct !{!49, !4, !5}
!50 = distinct !{!50, !4, !5, !21}
!51 = distinct !{!51, !5}
!52 = distinct !{!52, !4, !5}
!53 = distinct !{!53, !4, !5}
!54 = distinct !{!54, !4, !5}
!55 = distinct !{!55, !4, !5, !21}
!56 = distinct !{!56, !4, !5}
!57 = distinct !{!57, !4, !5}
!58 = distinct !{!58, !4, !5}
!59 = distinct !{!59, !4, !5, !21}
!60 = distinct !{!60, !4, !5}
!61 = distinct !{!61, !4, !5}
!62 = distinct !{!62, !4, !5}
!63 = distinct !{!63, !4, !5}
!64 = distinct !{!64, !4, !5, !21}
!65 = distinct !{!65, !4, !5}
!66 = distinct !{!66, !4, !5}
!67 = distinct !{!67, !4, !5}
!68 = distinct !{!68, !4, !5}
!69 = distinct !{!69, !4, !5}
!70 = distinct !{!70, !4, !5}
!71 = distinct !{!71, !4, !5}
!72 = distinct !{!72, !4, !5}
!73 = distinct !{!73, !4, !5}
!74 = distinct !{!74, !4, !5}
!75 = distinct !{!75, !4, !5}
!76 = distinct !{!76, !4, !5}
!77 = distinct !{!77, !4, !5, !21}
!78 = distinct !{!78, !4, !5}
!79 = distinct !{!79, !4, !5}
!80 = distinct !{!80, !4, !5}
