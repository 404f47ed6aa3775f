; sources 4f55485f10984da4a48d73f27592755b1ea7cc879c2e3442f81e889473ed4c1a
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

define noundef i64 @step_lanes(ptr noundef %0) #0 {
  %2 = alloca %struct.Stepper, align 8
  %3 = alloca i64, align 8
  store ptr %0, ptr %2, align 8
  %4 = getelementptr inbounds i8, ptr %2, i64 8
  %5 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %5, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %2, i64 16
  %7 = getelementptr inbounds i8, ptr %0, i64 360
  store ptr %7, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %0, i64 912
  %9 = load ptr, ptr %5, align 8
  %10 = getelementptr inbounds i8, ptr %9, i64 8
  %11 = load i64, ptr %10, align 8
  %12 = load ptr, ptr %0, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 960
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 968
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr double, ptr %14, i64 %16
  %18 = getelementptr i8, ptr %17, i64 -16
  %19 = load double, ptr %18, align 8
  %20 = getelementptr inbounds i8, ptr %0, i64 936
  %21 = load ptr, ptr %20, align 8
  %22 = load double, ptr %21, align 8
  %23 = load ptr, ptr %8, align 8
  %24 = getelementptr inbounds i8, ptr %23, i64 16
  %25 = load i64, ptr %24, align 8
  %26 = getelementptr inbounds i8, ptr %0, i64 120
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds i8, ptr %12, i64 8
  %29 = load i64, ptr %28, align 8
  %30 = getelementptr inbounds i8, ptr %12, i64 32
  %31 = load i64, ptr %30, align 8
  %32 = getelementptr inbounds i8, ptr %0, i64 528
  %33 = load ptr, ptr %32, align 8
  %34 = load i64, ptr %12, align 8
  %35 = getelementptr inbounds i8, ptr %0, i64 368
  %36 = load i64, ptr %35, align 8
  %37 = mul nsw i64 %36, %34
  store i64 0, ptr %3, align 8
  %38 = getelementptr inbounds i8, ptr %0, i64 864
  %39 = load ptr, ptr %38, align 8
  br label %122

40:                                               ; preds = %122
  %41 = getelementptr inbounds i8, ptr %0, i64 624
  %42 = sitofp i64 %25 to double
  %43 = icmp sgt i64 %29, 0
  %44 = icmp ne i64 %31, 1
  %45 = getelementptr inbounds double, ptr %33, i64 %37
  store i64 %130, ptr %3, align 8
  %46 = getelementptr inbounds i8, ptr %0, i64 864
  %47 = getelementptr inbounds i8, ptr %0, i64 744
  %48 = insertelement <8 x double> poison, double %19, i64 0
  %49 = shufflevector <8 x double> %48, <8 x double> poison, <8 x i32> zeroinitializer
  %50 = getelementptr inbounds i8, ptr %0, i64 648
  %51 = insertelement <8 x double> poison, double %22, i64 0
  %52 = shufflevector <8 x double> %51, <8 x double> poison, <8 x i32> zeroinitializer
  %53 = getelementptr inbounds i8, ptr %0, i64 768
  %54 = getelementptr inbounds i8, ptr %0, i64 792
  %55 = insertelement <8 x double> poison, double %42, i64 0
  %56 = shufflevector <8 x double> %55, <8 x double> poison, <8 x i32> zeroinitializer
  %57 = getelementptr inbounds i8, ptr %0, i64 432
  %58 = getelementptr inbounds i8, ptr %0, i64 408
  %59 = getelementptr inbounds i8, ptr %0, i64 24
  %60 = getelementptr inbounds i8, ptr %0, i64 528
  %61 = getelementptr inbounds i8, ptr %0, i64 48
  %62 = getelementptr inbounds i8, ptr %0, i64 72
  %63 = getelementptr inbounds i8, ptr %0, i64 368
  %64 = getelementptr inbounds i8, ptr %0, i64 96
  %65 = getelementptr inbounds i8, ptr %0, i64 168
  %66 = getelementptr inbounds i8, ptr %0, i64 272
  %67 = getelementptr inbounds i8, ptr %0, i64 192
  %68 = getelementptr inbounds i8, ptr %0, i64 240
  %69 = getelementptr inbounds i8, ptr %0, i64 384
  %70 = getelementptr inbounds i8, ptr %0, i64 24
  %71 = getelementptr inbounds i8, ptr %0, i64 528
  %72 = getelementptr inbounds i8, ptr %0, i64 48
  %73 = getelementptr inbounds i8, ptr %0, i64 72
  %74 = getelementptr inbounds i8, ptr %0, i64 384
  %75 = getelementptr inbounds i8, ptr %0, i64 168
  %76 = getelementptr inbounds i8, ptr %0, i64 272
  %77 = getelementptr inbounds i8, ptr %0, i64 192
  %78 = getelementptr inbounds i8, ptr %0, i64 240
  %79 = icmp sgt i64 %11, 0
  %80 = getelementptr inbounds i8, ptr %0, i64 384
  %81 = getelementptr inbounds i8, ptr %0, i64 504
  %82 = getelementptr inbounds i8, ptr %0, i64 368
  %83 = getelementptr inbounds i8, ptr %0, i64 480
  %84 = getelementptr inbounds i8, ptr %0, i64 600
  %85 = getelementptr inbounds i8, ptr %0, i64 576
  %86 = getelementptr inbounds i8, ptr %0, i64 384
  %87 = getelementptr inbounds i8, ptr %0, i64 168
  %88 = getelementptr inbounds i8, ptr %0, i64 272
  %89 = getelementptr inbounds i8, ptr %0, i64 192
  %90 = getelementptr inbounds i8, ptr %0, i64 240
  %91 = getelementptr inbounds i8, ptr %0, i64 816
  %92 = sext i1 %44 to i64
  %93 = uitofp i1 %44 to double
  %94 = insertelement <8 x double> poison, double %93, i64 0
  %95 = shufflevector <8 x double> %94, <8 x double> poison, <8 x i32> zeroinitializer
  %96 = getelementptr inbounds i8, ptr %0, i64 744
  %97 = getelementptr inbounds i8, ptr %0, i64 368
  %98 = getelementptr inbounds i8, ptr %0, i64 552
  %99 = getelementptr inbounds i8, ptr %0, i64 408
  %100 = getelementptr inbounds i8, ptr %0, i64 96
  %101 = getelementptr inbounds i8, ptr %0, i64 168
  %102 = getelementptr inbounds i8, ptr %0, i64 272
  %103 = getelementptr inbounds i8, ptr %0, i64 192
  %104 = getelementptr inbounds i8, ptr %0, i64 240
  %105 = getelementptr inbounds i8, ptr %0, i64 480
  %106 = getelementptr inbounds i8, ptr %12, i64 16
  %107 = getelementptr inbounds i8, ptr %0, i64 408
  %108 = getelementptr inbounds i8, ptr %0, i64 456
  %109 = getelementptr inbounds i8, ptr %0, i64 384
  %110 = getelementptr inbounds i8, ptr %0, i64 672
  %111 = getelementptr inbounds i8, ptr %0, i64 696
  %112 = getelementptr inbounds i8, ptr %27, i64 24
  %113 = getelementptr inbounds i8, ptr %27, i64 8
  %114 = getelementptr inbounds i8, ptr %27, i64 16
  %115 = getelementptr inbounds i8, ptr %27, i64 32
  %116 = getelementptr inbounds i8, ptr %27, i64 40
  %117 = getelementptr inbounds i8, ptr %27, i64 24
  %118 = getelementptr inbounds i8, ptr %27, i64 32
  %119 = getelementptr inbounds i8, ptr %0, i64 840
  %120 = icmp sgt i64 %11, 0
  %121 = getelementptr inbounds i8, ptr %0, i64 384
  br label %133

122:                                              ; preds = %1, %122
  %123 = phi i64 [ 0, %1 ], [ %131, %122 ]
  %124 = phi i64 [ 0, %1 ], [ %130, %122 ]
  %125 = getelementptr inbounds i64, ptr %39, i64 %123
  %126 = load i64, ptr %125, align 8
  %127 = icmp sgt i64 %126, -1
  %128 = zext i1 %127 to i64
  %129 = shl nuw nsw i64 %128, %123
  %130 = or i64 %129, %124
  %131 = add nuw nsw i64 %123, 1
  %132 = icmp eq i64 %131, 8
  br i1 %132, label %40, label %122, !llvm.loop !3

133:                                              ; preds = %160, %40
  %134 = phi i32 [ 1, %40 ], [ %161, %160 ]
  %135 = icmp eq i32 %134, 0
  br i1 %135, label %162, label %136

136:                                              ; preds = %133
  %137 = call fastcc i64 @fill(ptr noundef nonnull %0, ptr noundef nonnull %3) #10
  %138 = load i64, ptr %3, align 8
  %139 = icmp eq i64 %138, 0
  br i1 %139, label %157, label %140

140:                                              ; preds = %136
  %141 = icmp eq i64 %137, 0
  br i1 %141, label %157, label %142

142:                                              ; preds = %140
  call fastcc void @start(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %137) #10
  br label %143

143:                                              ; preds = %142, %152
  %144 = phi i32 [ 0, %142 ], [ %154, %152 ]
  %145 = phi i64 [ 0, %142 ], [ %155, %152 ]
  %146 = icmp eq i32 %144, 0
  br i1 %146, label %147, label %152

147:                                              ; preds = %143
  %148 = load ptr, ptr %46, align 8
  %149 = getelementptr inbounds i64, ptr %148, i64 %145
  %150 = load i64, ptr %149, align 8
  %151 = icmp eq i64 %150, -1
  br label %152

152:                                              ; preds = %147, %143
  %153 = phi i1 [ true, %143 ], [ %151, %147 ]
  %154 = zext i1 %153 to i32
  %155 = add nuw nsw i64 %145, 1
  %156 = icmp eq i64 %155, 8
  br i1 %156, label %157, label %143, !llvm.loop !6

157:                                              ; preds = %152, %140, %136
  %158 = phi i32 [ 1, %136 ], [ 8, %140 ], [ 0, %152 ]
  %159 = phi i32 [ %134, %136 ], [ %134, %140 ], [ %154, %152 ]
  switch i32 %158, label %1015 [
    i32 0, label %160
    i32 8, label %162
  ]

160:                                              ; preds = %157, %987, %1013, %216
  %161 = phi i32 [ %159, %157 ], [ %745, %987 ], [ 1, %1013 ], [ 1, %216 ]
  br label %133, !llvm.loop !7

162:                                              ; preds = %157, %133
  %163 = phi i32 [ %159, %157 ], [ 0, %133 ]
  %164 = load ptr, ptr %8, align 8
  %165 = getelementptr inbounds i8, ptr %164, i64 8
  %166 = load i64, ptr %165, align 8
  %167 = icmp slt i64 %166, 1
  br i1 %167, label %1015, label %168

168:                                              ; preds = %162
  %169 = add nsw i64 %166, -1
  store i64 %169, ptr %165, align 8
  %170 = load i64, ptr %3, align 8
  %171 = trunc i64 %170 to i8
  %172 = bitcast i8 %171 to <8 x i1>
  %173 = load ptr, ptr %41, align 8
  %174 = load <8 x double>, ptr %173, align 8
  br i1 %43, label %178, label %175

175:                                              ; preds = %168
  %176 = load ptr, ptr %47, align 8
  %177 = load <8 x double>, ptr %176, align 8
  br label %178

178:                                              ; preds = %168, %175
  %179 = phi <8 x double> [ %177, %175 ], [ %49, %168 ]
  %180 = load ptr, ptr %50, align 8
  %181 = load <8 x double>, ptr %180, align 8
  br i1 %43, label %182, label %185

182:                                              ; preds = %178
  %183 = fcmp olt <8 x double> %181, %52
  %184 = select <8 x i1> %183, <8 x double> %181, <8 x double> %52
  br label %191

185:                                              ; preds = %178
  %186 = fsub <8 x double> %179, %174
  %187 = fdiv <8 x double> %186, %181
  %188 = fmul <8 x double> %187, <double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1>
  %189 = tail call <8 x double> @llvm.ceil.v8f64(<8 x double> %188)
  %190 = fdiv <8 x double> %186, %189
  br label %191

191:                                              ; preds = %185, %182
  %192 = phi <8 x double> [ %184, %182 ], [ %190, %185 ]
  %193 = fadd <8 x double> %174, %192
  %194 = fmul <8 x double> %192, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %195 = fsub <8 x double> %179, %194
  %196 = fcmp ogt <8 x double> %193, %195
  %197 = fsub <8 x double> %179, %174
  %198 = select <8 x i1> %196, <8 x double> %197, <8 x double> %192
  %199 = select <8 x i1> %196, <8 x double> %179, <8 x double> %193
  %200 = select <8 x i1> %172, <8 x double> %198, <8 x double> zeroinitializer
  %201 = load ptr, ptr %53, align 8
  %202 = load <8 x double>, ptr %201, align 8
  %203 = load ptr, ptr %54, align 8
  %204 = load <8 x double>, ptr %203, align 8
  %205 = fadd <8 x double> %202, %204
  %206 = fcmp oge <8 x double> %205, %56
  %207 = fmul <8 x double> %200, <double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02>
  %208 = fadd <8 x double> %174, %207
  %209 = fcmp ule <8 x double> %208, %174
  %210 = fcmp une <8 x double> %199, %179
  %211 = and <8 x i1> %209, %210
  %212 = or <8 x i1> %211, %206
  %213 = and <8 x i1> %212, %172
  %214 = bitcast <8 x i1> %213 to i8
  %215 = icmp eq i8 %214, 0
  br i1 %215, label %223, label %216

216:                                              ; preds = %191
  %217 = zext i8 %214 to i64
  %218 = bitcast <8 x i1> %206 to i8
  %219 = zext i8 %218 to i64
  %220 = and i64 %217, %219
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %220, i64 noundef 1) #10
  %221 = xor i64 %219, -1
  %222 = and i64 %217, %221
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %222, i64 noundef -1) #10
  br label %160

223:                                              ; preds = %191
  %224 = load ptr, ptr %0, align 8
  %225 = load i64, ptr %224, align 8
  %226 = load ptr, ptr %57, align 8
  store <8 x double> %200, ptr %226, align 8
  %227 = icmp sgt i64 %225, 1
  br i1 %227, label %228, label %277

228:                                              ; preds = %223, %265
  %229 = phi i64 [ %274, %265 ], [ 0, %223 ]
  %230 = phi i64 [ %275, %265 ], [ 1, %223 ]
  %231 = load ptr, ptr %58, align 8
  %232 = load ptr, ptr %7, align 8
  %233 = load ptr, ptr %5, align 8
  %234 = getelementptr inbounds i8, ptr %233, i64 16
  %235 = load i64, ptr %234, align 8
  %236 = load ptr, ptr %59, align 8
  %237 = getelementptr inbounds i64, ptr %236, i64 %230
  %238 = load i64, ptr %237, align 8
  %239 = getelementptr i8, ptr %237, i64 8
  %240 = load i64, ptr %239, align 8
  %241 = xor i64 %238, -1
  %242 = add i64 %240, %241
  %243 = load ptr, ptr %57, align 8
  %244 = load ptr, ptr %60, align 8
  %245 = load ptr, ptr %61, align 8
  %246 = getelementptr inbounds i64, ptr %245, i64 %238
  %247 = load ptr, ptr %62, align 8
  %248 = getelementptr inbounds double, ptr %247, i64 %238
  tail call fastcc void @combine(ptr noundef %231, ptr noundef %232, ptr noundef %243, ptr noundef %244, ptr noundef %246, ptr noundef %248, i64 noundef %242, i64 noundef %235) #10
  %249 = load ptr, ptr %60, align 8
  %250 = load i64, ptr %63, align 8
  %251 = mul nsw i64 %250, %230
  %252 = getelementptr inbounds double, ptr %249, i64 %251
  %253 = load ptr, ptr %64, align 8
  %254 = getelementptr inbounds double, ptr %253, i64 %230
  %255 = load double, ptr %254, align 8
  %256 = insertelement <8 x double> poison, double %255, i64 0
  %257 = shufflevector <8 x double> %256, <8 x double> poison, <8 x i32> zeroinitializer
  %258 = fmul <8 x double> %200, %257
  %259 = fadd <8 x double> %174, %258
  %260 = load ptr, ptr %58, align 8
  %261 = load ptr, ptr %65, align 8
  store <8 x double> %259, ptr %261, align 8
  %262 = load i64, ptr %66, align 8
  %263 = icmp sgt i64 %262, 0
  br i1 %263, label %264, label %265

264:                                              ; preds = %228
  tail call fastcc void @sample(ptr noundef nonnull %5) #10
  br label %265

265:                                              ; preds = %228, %264
  %266 = load ptr, ptr %5, align 8
  %267 = load i64, ptr %266, align 8
  %268 = load ptr, ptr %65, align 8
  %269 = load ptr, ptr %67, align 8
  %270 = load ptr, ptr %68, align 8
  %271 = inttoptr i64 %267 to ptr
  %272 = tail call i32 %271(ptr noundef %268, ptr noundef %260, ptr noundef %269, ptr noundef %270, ptr noundef %252) #11
  %273 = zext i32 %272 to i64
  %274 = or i64 %229, %273
  %275 = add nuw nsw i64 %230, 1
  %276 = icmp eq i64 %275, %225
  br i1 %276, label %277, label %228, !llvm.loop !8

277:                                              ; preds = %265, %223
  %278 = phi i64 [ 0, %223 ], [ %274, %265 ]
  %279 = load ptr, ptr %69, align 8
  %280 = load ptr, ptr %7, align 8
  %281 = load ptr, ptr %5, align 8
  %282 = getelementptr inbounds i8, ptr %281, i64 16
  %283 = load i64, ptr %282, align 8
  %284 = load ptr, ptr %70, align 8
  %285 = getelementptr inbounds i64, ptr %284, i64 %225
  %286 = load i64, ptr %285, align 8
  %287 = getelementptr i8, ptr %285, i64 8
  %288 = load i64, ptr %287, align 8
  %289 = xor i64 %286, -1
  %290 = add i64 %288, %289
  %291 = load ptr, ptr %57, align 8
  %292 = load ptr, ptr %71, align 8
  %293 = load ptr, ptr %72, align 8
  %294 = getelementptr inbounds i64, ptr %293, i64 %286
  %295 = load ptr, ptr %73, align 8
  %296 = getelementptr inbounds double, ptr %295, i64 %286
  tail call fastcc void @combine(ptr noundef %279, ptr noundef %280, ptr noundef %291, ptr noundef %292, ptr noundef %294, ptr noundef %296, i64 noundef %290, i64 noundef %283) #10
  br i1 %44, label %313, label %297

297:                                              ; preds = %277
  %298 = load ptr, ptr %74, align 8
  %299 = load ptr, ptr %75, align 8
  store <8 x double> %199, ptr %299, align 8
  %300 = load i64, ptr %76, align 8
  %301 = icmp sgt i64 %300, 0
  br i1 %301, label %302, label %303

302:                                              ; preds = %297
  tail call fastcc void @sample(ptr noundef nonnull %5) #10
  br label %303

303:                                              ; preds = %297, %302
  %304 = load ptr, ptr %5, align 8
  %305 = load i64, ptr %304, align 8
  %306 = load ptr, ptr %75, align 8
  %307 = load ptr, ptr %77, align 8
  %308 = load ptr, ptr %78, align 8
  %309 = inttoptr i64 %305 to ptr
  %310 = tail call i32 %309(ptr noundef %306, ptr noundef %298, ptr noundef %307, ptr noundef %308, ptr noundef %45) #11
  %311 = zext i32 %310 to i64
  %312 = or i64 %278, %311
  br label %313

313:                                              ; preds = %303, %277
  %314 = phi i64 [ %312, %303 ], [ %278, %277 ]
  br i1 %43, label %318, label %315

315:                                              ; preds = %313
  br i1 %79, label %316, label %491

316:                                              ; preds = %315
  %317 = load ptr, ptr %80, align 8
  br label %481

318:                                              ; preds = %313
  %319 = load ptr, ptr %5, align 8
  %320 = load ptr, ptr %0, align 8
  %321 = getelementptr inbounds i8, ptr %319, i64 24
  %322 = load i64, ptr %321, align 8
  %323 = getelementptr inbounds i8, ptr %320, i64 8
  %324 = load i64, ptr %323, align 8
  %325 = load ptr, ptr %81, align 8
  %326 = load i64, ptr %82, align 8
  %327 = getelementptr inbounds double, ptr %325, i64 %326
  %328 = icmp sgt i64 %324, 0
  br i1 %328, label %329, label %331

329:                                              ; preds = %318
  %330 = getelementptr inbounds i8, ptr %319, i64 32
  br label %339

331:                                              ; preds = %339, %318
  %332 = icmp sgt i64 %322, 0
  br i1 %332, label %333, label %365

333:                                              ; preds = %331
  %334 = load ptr, ptr %7, align 8
  %335 = load ptr, ptr %69, align 8
  %336 = load ptr, ptr %84, align 8
  %337 = load ptr, ptr %85, align 8
  %338 = load ptr, ptr %81, align 8
  br label %428

339:                                              ; preds = %329, %339
  %340 = phi i64 [ 0, %329 ], [ %363, %339 ]
  %341 = load i64, ptr %320, align 8
  %342 = load i64, ptr %330, align 8
  %343 = load ptr, ptr %81, align 8
  %344 = load i64, ptr %82, align 8
  %345 = mul nsw i64 %344, %340
  %346 = getelementptr inbounds double, ptr %343, i64 %345
  %347 = load ptr, ptr %83, align 8
  %348 = load ptr, ptr %70, align 8
  %349 = getelementptr i64, ptr %348, i64 %341
  %350 = getelementptr i8, ptr %349, i64 8
  %351 = getelementptr i64, ptr %350, i64 %340
  %352 = load i64, ptr %351, align 8
  %353 = getelementptr i8, ptr %351, i64 8
  %354 = load i64, ptr %353, align 8
  %355 = xor i64 %352, -1
  %356 = add i64 %354, %355
  %357 = load ptr, ptr %57, align 8
  %358 = load ptr, ptr %71, align 8
  %359 = load ptr, ptr %72, align 8
  %360 = getelementptr inbounds i64, ptr %359, i64 %352
  %361 = load ptr, ptr %73, align 8
  %362 = getelementptr inbounds double, ptr %361, i64 %352
  tail call fastcc void @combine(ptr noundef %346, ptr noundef %347, ptr noundef %357, ptr noundef %358, ptr noundef %360, ptr noundef %362, i64 noundef %356, i64 noundef %342) #10
  %363 = add nuw nsw i64 %340, 1
  %364 = icmp eq i64 %363, %324
  br i1 %364, label %331, label %339, !llvm.loop !9

365:                                              ; preds = %428, %331
  %366 = phi <8 x double> [ zeroinitializer, %331 ], [ %461, %428 ]
  %367 = phi <8 x double> [ zeroinitializer, %331 ], [ %459, %428 ]
  %368 = load ptr, ptr %69, align 8
  %369 = getelementptr inbounds i8, ptr %319, i64 8
  %370 = load i64, ptr %369, align 8
  %371 = add nsw i64 %370, -3
  %372 = getelementptr i8, ptr %368, i64 64
  %373 = getelementptr i8, ptr %368, i64 128
  %374 = getelementptr i8, ptr %368, i64 192
  %375 = icmp slt i64 %322, %371
  br i1 %375, label %383, label %376

376:                                              ; preds = %383, %365
  %377 = phi <8 x double> [ zeroinitializer, %365 ], [ %393, %383 ]
  %378 = phi <8 x double> [ zeroinitializer, %365 ], [ %398, %383 ]
  %379 = phi <8 x double> [ zeroinitializer, %365 ], [ %403, %383 ]
  %380 = phi <8 x double> [ zeroinitializer, %365 ], [ %408, %383 ]
  %381 = phi i64 [ %322, %365 ], [ %409, %383 ]
  %382 = icmp slt i64 %381, %370
  br i1 %382, label %411, label %421

383:                                              ; preds = %365, %383
  %384 = phi i64 [ %409, %383 ], [ %322, %365 ]
  %385 = phi <8 x double> [ %408, %383 ], [ zeroinitializer, %365 ]
  %386 = phi <8 x double> [ %403, %383 ], [ zeroinitializer, %365 ]
  %387 = phi <8 x double> [ %398, %383 ], [ zeroinitializer, %365 ]
  %388 = phi <8 x double> [ %393, %383 ], [ zeroinitializer, %365 ]
  %389 = shl nsw i64 %384, 6
  %390 = getelementptr inbounds i8, ptr %368, i64 %389
  %391 = load <8 x double>, ptr %390, align 8
  %392 = fmul <8 x double> %391, zeroinitializer
  %393 = fadd <8 x double> %388, %392
  %394 = shl i64 %384, 6
  %395 = getelementptr i8, ptr %372, i64 %394
  %396 = load <8 x double>, ptr %395, align 8
  %397 = fmul <8 x double> %396, zeroinitializer
  %398 = fadd <8 x double> %387, %397
  %399 = shl i64 %384, 6
  %400 = getelementptr i8, ptr %373, i64 %399
  %401 = load <8 x double>, ptr %400, align 8
  %402 = fmul <8 x double> %401, zeroinitializer
  %403 = fadd <8 x double> %386, %402
  %404 = shl i64 %384, 6
  %405 = getelementptr i8, ptr %374, i64 %404
  %406 = load <8 x double>, ptr %405, align 8
  %407 = fmul <8 x double> %406, zeroinitializer
  %408 = fadd <8 x double> %385, %407
  %409 = add nsw i64 %384, 4
  %410 = icmp slt i64 %409, %371
  br i1 %410, label %383, label %376, !llvm.loop !10

411:                                              ; preds = %376, %411
  %412 = phi i64 [ %419, %411 ], [ %381, %376 ]
  %413 = phi <8 x double> [ %418, %411 ], [ %377, %376 ]
  %414 = shl nsw i64 %412, 6
  %415 = getelementptr inbounds i8, ptr %368, i64 %414
  %416 = load <8 x double>, ptr %415, align 8
  %417 = fmul <8 x double> %416, zeroinitializer
  %418 = fadd <8 x double> %413, %417
  %419 = add nsw i64 %412, 1
  %420 = icmp eq i64 %419, %370
  br i1 %420, label %421, label %411, !llvm.loop !11

421:                                              ; preds = %411, %376
  %422 = phi <8 x double> [ %377, %376 ], [ %418, %411 ]
  %423 = fadd <8 x double> %378, %422
  %424 = fadd <8 x double> %379, %380
  %425 = fadd <8 x double> %424, %423
  %426 = fadd <8 x double> %367, %425
  %427 = icmp eq i64 %324, 2
  br i1 %427, label %464, label %475

428:                                              ; preds = %333, %428
  %429 = phi <8 x double> [ zeroinitializer, %333 ], [ %459, %428 ]
  %430 = phi <8 x double> [ zeroinitializer, %333 ], [ %461, %428 ]
  %431 = phi i64 [ 0, %333 ], [ %462, %428 ]
  %432 = shl nsw i64 %431, 6
  %433 = getelementptr inbounds i8, ptr %334, i64 %432
  %434 = load <8 x double>, ptr %433, align 8
  %435 = getelementptr inbounds i8, ptr %335, i64 %432
  %436 = load <8 x double>, ptr %435, align 8
  %437 = getelementptr inbounds double, ptr %336, i64 %431
  %438 = load double, ptr %437, align 8
  %439 = insertelement <8 x double> poison, double %438, i64 0
  %440 = shufflevector <8 x double> %439, <8 x double> poison, <8 x i32> zeroinitializer
  %441 = getelementptr inbounds double, ptr %337, i64 %431
  %442 = load double, ptr %441, align 8
  %443 = insertelement <8 x double> poison, double %442, i64 0
  %444 = shufflevector <8 x double> %443, <8 x double> poison, <8 x i32> zeroinitializer
  %445 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %434)
  %446 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %436)
  %447 = fcmp ogt <8 x double> %445, %446
  %448 = select <8 x i1> %447, <8 x double> %445, <8 x double> %446
  %449 = fmul <8 x double> %448, %444
  %450 = fadd <8 x double> %440, %449
  %451 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %450
  %452 = getelementptr inbounds i8, ptr %338, i64 %432
  %453 = load <8 x double>, ptr %452, align 8
  %454 = fmul <8 x double> %453, %451
  %455 = getelementptr inbounds i8, ptr %327, i64 %432
  %456 = load <8 x double>, ptr %455, align 8
  %457 = fmul <8 x double> %456, %451
  %458 = fmul <8 x double> %454, %454
  %459 = fadd <8 x double> %429, %458
  %460 = fmul <8 x double> %457, %457
  %461 = fadd <8 x double> %430, %460
  %462 = add nuw nsw i64 %431, 1
  %463 = icmp eq i64 %462, %322
  br i1 %463, label %365, label %428, !llvm.loop !12

464:                                              ; preds = %421
  %465 = fmul <8 x double> %366, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %466 = fadd <8 x double> %465, %426
  %467 = sitofp i64 %322 to double
  %468 = insertelement <8 x double> poison, double %467, i64 0
  %469 = shufflevector <8 x double> %468, <8 x double> poison, <8 x i32> zeroinitializer
  %470 = fmul <8 x double> %469, %466
  %471 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %470)
  %472 = fdiv <8 x double> %426, %471
  %473 = fcmp oeq <8 x double> %426, zeroinitializer
  %474 = select <8 x i1> %473, <8 x double> zeroinitializer, <8 x double> %472
  br label %491

475:                                              ; preds = %421
  %476 = sitofp i64 %322 to double
  %477 = insertelement <8 x double> poison, double %476, i64 0
  %478 = shufflevector <8 x double> %477, <8 x double> poison, <8 x i32> zeroinitializer
  %479 = fdiv <8 x double> %426, %478
  %480 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %479)
  br label %491

481:                                              ; preds = %316, %481
  %482 = phi <8 x double> [ zeroinitializer, %316 ], [ %488, %481 ]
  %483 = phi i64 [ 0, %316 ], [ %489, %481 ]
  %484 = shl nsw i64 %483, 6
  %485 = getelementptr inbounds i8, ptr %317, i64 %484
  %486 = load <8 x double>, ptr %485, align 8
  %487 = fmul <8 x double> %486, zeroinitializer
  %488 = fadd <8 x double> %482, %487
  %489 = add nuw nsw i64 %483, 1
  %490 = icmp eq i64 %489, %11
  br i1 %490, label %491, label %481, !llvm.loop !13

491:                                              ; preds = %481, %315, %475, %464
  %492 = phi <8 x double> [ %474, %464 ], [ %480, %475 ], [ zeroinitializer, %315 ], [ %488, %481 ]
  %493 = fcmp uge <8 x double> %492, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %494 = trunc i64 %314 to i8
  %495 = bitcast i8 %494 to <8 x i1>
  %496 = select <8 x i1> %495, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %493
  %497 = xor <8 x i1> %496, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %498 = select <8 x i1> %497, <8 x i1> %172, <8 x i1> zeroinitializer
  %499 = sext <8 x i1> %498 to <8 x i64>
  br i1 %44, label %500, label %524

500:                                              ; preds = %491
  %501 = xor <8 x i1> %496, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %502 = select <8 x i1> %501, <8 x i1> %172, <8 x i1> zeroinitializer
  %503 = bitcast <8 x i1> %502 to i8
  %504 = icmp eq i8 %503, 0
  br i1 %504, label %524, label %505

505:                                              ; preds = %500
  %506 = load ptr, ptr %86, align 8
  %507 = load ptr, ptr %87, align 8
  store <8 x double> %199, ptr %507, align 8
  %508 = load i64, ptr %88, align 8
  %509 = icmp sgt i64 %508, 0
  br i1 %509, label %510, label %511

510:                                              ; preds = %505
  tail call fastcc void @sample(ptr noundef nonnull %5) #10
  br label %511

511:                                              ; preds = %505, %510
  %512 = load ptr, ptr %5, align 8
  %513 = load i64, ptr %512, align 8
  %514 = load ptr, ptr %87, align 8
  %515 = load ptr, ptr %89, align 8
  %516 = load ptr, ptr %90, align 8
  %517 = inttoptr i64 %513 to ptr
  %518 = tail call i32 %517(ptr noundef %514, ptr noundef %506, ptr noundef %515, ptr noundef %516, ptr noundef %45) #11
  %519 = zext i32 %518 to i64
  %520 = or i64 %314, %519
  %521 = trunc i64 %520 to i8
  %522 = bitcast i8 %521 to <8 x i1>
  %523 = select <8 x i1> %522, <8 x i64> zeroinitializer, <8 x i64> %499
  br label %524

524:                                              ; preds = %511, %500, %491
  %525 = phi <8 x i64> [ %499, %491 ], [ %523, %511 ], [ %499, %500 ]
  %526 = phi i64 [ %314, %491 ], [ %520, %511 ], [ %314, %500 ]
  %527 = load ptr, ptr %91, align 8
  %528 = load <8 x double>, ptr %527, align 8
  %529 = load i64, ptr %12, align 8
  %530 = add i64 %529, %92
  %531 = sitofp i64 %530 to double
  %532 = insertelement <8 x double> poison, double %531, i64 0
  %533 = shufflevector <8 x double> %532, <8 x double> poison, <8 x i32> zeroinitializer
  %534 = xor <8 x i1> %496, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %535 = select <8 x i1> %534, <8 x i1> %172, <8 x i1> zeroinitializer
  %536 = select <8 x i1> %535, <8 x double> %95, <8 x double> zeroinitializer
  %537 = fadd <8 x double> %536, %533
  %538 = fadd <8 x double> %528, %537
  store <8 x double> %538, ptr %527, align 8
  %539 = load ptr, ptr %96, align 8
  %540 = load <8 x double>, ptr %539, align 8
  %541 = fcmp olt <8 x double> %540, %199
  %542 = select <8 x i1> %541, <8 x i64> %525, <8 x i64> zeroinitializer
  %543 = icmp ne <8 x i64> %542, zeroinitializer
  %544 = bitcast <8 x i1> %543 to i8
  %545 = zext i8 %544 to i64
  %546 = icmp eq i8 %544, 0
  br i1 %546, label %743, label %547

547:                                              ; preds = %524
  %548 = load ptr, ptr %0, align 8
  %549 = load ptr, ptr %5, align 8
  %550 = getelementptr inbounds i8, ptr %549, i64 16
  %551 = load i64, ptr %550, align 8
  %552 = load i64, ptr %548, align 8
  %553 = load i64, ptr %97, align 8
  %554 = load ptr, ptr %71, align 8
  %555 = mul nsw i64 %553, %552
  %556 = getelementptr inbounds double, ptr %554, i64 %555
  %557 = load ptr, ptr %98, align 8
  %558 = add nsw i64 %552, 1
  %559 = getelementptr inbounds i8, ptr %548, i64 16
  %560 = load i64, ptr %559, align 8
  %561 = icmp sgt i64 %560, 0
  br i1 %561, label %562, label %564

562:                                              ; preds = %547
  %563 = getelementptr inbounds i8, ptr %548, i64 8
  br label %575

564:                                              ; preds = %610, %547
  %565 = phi i64 [ 0, %547 ], [ %619, %610 ]
  %566 = getelementptr inbounds i8, ptr %548, i64 16
  %567 = load ptr, ptr %5, align 8
  %568 = getelementptr inbounds i8, ptr %567, i64 8
  %569 = load i64, ptr %568, align 8
  %570 = icmp sgt i64 %569, 0
  br i1 %570, label %571, label %624

571:                                              ; preds = %564
  %572 = getelementptr inbounds double, ptr %557, i64 %553
  %573 = shl nsw i64 %553, 4
  %574 = getelementptr inbounds i8, ptr %557, i64 %573
  br label %631

575:                                              ; preds = %562, %610
  %576 = phi i64 [ 0, %562 ], [ %619, %610 ]
  %577 = phi i64 [ %558, %562 ], [ %620, %610 ]
  %578 = load i64, ptr %563, align 8
  %579 = load ptr, ptr %99, align 8
  %580 = load ptr, ptr %7, align 8
  %581 = load ptr, ptr %70, align 8
  %582 = getelementptr i64, ptr %581, i64 %577
  %583 = getelementptr i64, ptr %582, i64 %578
  %584 = load i64, ptr %583, align 8
  %585 = getelementptr i8, ptr %583, i64 8
  %586 = load i64, ptr %585, align 8
  %587 = xor i64 %584, -1
  %588 = add i64 %586, %587
  %589 = load ptr, ptr %57, align 8
  %590 = load ptr, ptr %71, align 8
  %591 = load ptr, ptr %72, align 8
  %592 = getelementptr inbounds i64, ptr %591, i64 %584
  %593 = load ptr, ptr %73, align 8
  %594 = getelementptr inbounds double, ptr %593, i64 %584
  tail call fastcc void @combine(ptr noundef %579, ptr noundef %580, ptr noundef %589, ptr noundef %590, ptr noundef %592, ptr noundef %594, i64 noundef %588, i64 noundef %551) #10
  %595 = load ptr, ptr %71, align 8
  %596 = mul nsw i64 %577, %553
  %597 = getelementptr inbounds double, ptr %595, i64 %596
  %598 = load ptr, ptr %100, align 8
  %599 = getelementptr inbounds double, ptr %598, i64 %577
  %600 = load double, ptr %599, align 8
  %601 = insertelement <8 x double> poison, double %600, i64 0
  %602 = shufflevector <8 x double> %601, <8 x double> poison, <8 x i32> zeroinitializer
  %603 = fmul <8 x double> %200, %602
  %604 = fadd <8 x double> %174, %603
  %605 = load ptr, ptr %99, align 8
  %606 = load ptr, ptr %101, align 8
  store <8 x double> %604, ptr %606, align 8
  %607 = load i64, ptr %102, align 8
  %608 = icmp sgt i64 %607, 0
  br i1 %608, label %609, label %610

609:                                              ; preds = %575
  tail call fastcc void @sample(ptr noundef nonnull %5) #10
  br label %610

610:                                              ; preds = %575, %609
  %611 = load ptr, ptr %5, align 8
  %612 = load i64, ptr %611, align 8
  %613 = load ptr, ptr %101, align 8
  %614 = load ptr, ptr %103, align 8
  %615 = load ptr, ptr %104, align 8
  %616 = inttoptr i64 %612 to ptr
  %617 = tail call i32 %616(ptr noundef %613, ptr noundef %605, ptr noundef %614, ptr noundef %615, ptr noundef %597) #11
  %618 = zext i32 %617 to i64
  %619 = or i64 %576, %618
  %620 = add nsw i64 %577, 1
  %621 = load i64, ptr %559, align 8
  %622 = add nsw i64 %621, %558
  %623 = icmp slt i64 %620, %622
  br i1 %623, label %575, label %564, !llvm.loop !14

624:                                              ; preds = %631, %564
  %625 = getelementptr inbounds i8, ptr %548, i64 8
  %626 = load i64, ptr %625, align 8
  %627 = load i64, ptr %566, align 8
  %628 = getelementptr inbounds i8, ptr %548, i64 24
  %629 = load i64, ptr %628, align 8
  %630 = icmp sgt i64 %629, 3
  br i1 %630, label %659, label %684

631:                                              ; preds = %571, %631
  %632 = phi i64 [ 0, %571 ], [ %654, %631 ]
  %633 = load ptr, ptr %69, align 8
  %634 = shl nsw i64 %632, 6
  %635 = getelementptr inbounds i8, ptr %633, i64 %634
  %636 = load <8 x double>, ptr %635, align 8
  %637 = load ptr, ptr %7, align 8
  %638 = getelementptr inbounds i8, ptr %637, i64 %634
  %639 = load <8 x double>, ptr %638, align 8
  %640 = fsub <8 x double> %636, %639
  %641 = load ptr, ptr %71, align 8
  %642 = getelementptr inbounds i8, ptr %641, i64 %634
  %643 = load <8 x double>, ptr %642, align 8
  %644 = fmul <8 x double> %200, %643
  %645 = fsub <8 x double> %644, %640
  %646 = getelementptr inbounds i8, ptr %557, i64 %634
  store <8 x double> %640, ptr %646, align 8
  %647 = getelementptr inbounds i8, ptr %572, i64 %634
  store <8 x double> %645, ptr %647, align 8
  %648 = fsub <8 x double> %640, %645
  %649 = getelementptr inbounds i8, ptr %556, i64 %634
  %650 = load <8 x double>, ptr %649, align 8
  %651 = fmul <8 x double> %200, %650
  %652 = fsub <8 x double> %648, %651
  %653 = getelementptr inbounds i8, ptr %574, i64 %634
  store <8 x double> %652, ptr %653, align 8
  %654 = add nuw nsw i64 %632, 1
  %655 = load ptr, ptr %5, align 8
  %656 = getelementptr inbounds i8, ptr %655, i64 8
  %657 = load i64, ptr %656, align 8
  %658 = icmp slt i64 %654, %657
  br i1 %658, label %631, label %624, !llvm.loop !15

659:                                              ; preds = %624, %659
  %660 = phi i64 [ %681, %659 ], [ 3, %624 ]
  %661 = mul nsw i64 %660, %553
  %662 = getelementptr inbounds double, ptr %557, i64 %661
  %663 = load ptr, ptr %105, align 8
  %664 = load ptr, ptr %70, align 8
  %665 = getelementptr i64, ptr %664, i64 %558
  %666 = getelementptr i64, ptr %665, i64 %626
  %667 = getelementptr i64, ptr %666, i64 %627
  %668 = getelementptr i64, ptr %667, i64 %660
  %669 = getelementptr i8, ptr %668, i64 -24
  %670 = load i64, ptr %669, align 8
  %671 = getelementptr i8, ptr %668, i64 -16
  %672 = load i64, ptr %671, align 8
  %673 = xor i64 %670, -1
  %674 = add i64 %672, %673
  %675 = load ptr, ptr %57, align 8
  %676 = load ptr, ptr %71, align 8
  %677 = load ptr, ptr %72, align 8
  %678 = getelementptr inbounds i64, ptr %677, i64 %670
  %679 = load ptr, ptr %73, align 8
  %680 = getelementptr inbounds double, ptr %679, i64 %670
  tail call fastcc void @combine(ptr noundef %662, ptr noundef %663, ptr noundef %675, ptr noundef %676, ptr noundef %678, ptr noundef %680, i64 noundef %674, i64 noundef %551) #10
  %681 = add nuw nsw i64 %660, 1
  %682 = load i64, ptr %628, align 8
  %683 = icmp slt i64 %681, %682
  br i1 %683, label %659, label %684, !llvm.loop !16

684:                                              ; preds = %659, %624
  %685 = and i64 %565, %545
  %686 = load ptr, ptr %91, align 8
  %687 = load <8 x double>, ptr %686, align 8
  %688 = load i64, ptr %106, align 8
  %689 = sitofp i64 %688 to double
  %690 = insertelement <8 x double> poison, double %689, i64 0
  %691 = bitcast <8 x double> %690 to <8 x i64>
  %692 = shufflevector <8 x i64> %691, <8 x i64> poison, <8 x i32> zeroinitializer
  %693 = icmp slt <8 x i64> %542, zeroinitializer
  %694 = select <8 x i1> %693, <8 x i64> %692, <8 x i64> zeroinitializer
  %695 = bitcast <8 x i64> %694 to <8 x double>
  %696 = fadd <8 x double> %687, %695
  store <8 x double> %696, ptr %686, align 8
  %697 = icmp eq i64 %685, 0
  br i1 %697, label %705, label %698

698:                                              ; preds = %684
  tail call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %685, i64 noundef 3) #10
  %699 = xor i64 %685, -1
  %700 = and i64 %170, %699
  store i64 %700, ptr %3, align 8
  %701 = trunc i64 %700 to i8
  %702 = bitcast i8 %701 to <8 x i1>
  %703 = select <8 x i1> %702, <8 x i64> %525, <8 x i64> zeroinitializer
  %704 = select <8 x i1> %702, <8 x i64> %542, <8 x i64> zeroinitializer
  br label %705

705:                                              ; preds = %698, %684
  %706 = phi <8 x i64> [ %703, %698 ], [ %525, %684 ]
  %707 = phi <8 x i64> [ %704, %698 ], [ %542, %684 ]
  %708 = phi i32 [ 1, %698 ], [ %163, %684 ]
  %709 = icmp ne <8 x i64> %707, zeroinitializer
  %710 = bitcast <8 x i1> %709 to i8
  %711 = load ptr, ptr %41, align 8
  %712 = load <8 x double>, ptr %711, align 8
  %713 = load ptr, ptr %57, align 8
  %714 = load <8 x double>, ptr %713, align 8
  %715 = load ptr, ptr %107, align 8
  %716 = icmp eq i8 %710, 0
  br i1 %716, label %743, label %717

717:                                              ; preds = %705
  %718 = zext i8 %710 to i64
  br label %719

719:                                              ; preds = %717, %719
  %720 = phi i64 [ %741, %719 ], [ %718, %717 ]
  %721 = load ptr, ptr %96, align 8
  %722 = load <8 x double>, ptr %721, align 8
  %723 = fsub <8 x double> %722, %712
  %724 = fdiv <8 x double> %723, %714
  %725 = load ptr, ptr %108, align 8
  store <8 x double> %724, ptr %725, align 8
  %726 = load ptr, ptr %7, align 8
  %727 = load ptr, ptr %98, align 8
  %728 = load i64, ptr %97, align 8
  %729 = load ptr, ptr %0, align 8
  %730 = getelementptr inbounds i8, ptr %729, i64 24
  %731 = load i64, ptr %730, align 8
  %732 = load ptr, ptr %108, align 8
  %733 = load ptr, ptr %5, align 8
  %734 = getelementptr inbounds i8, ptr %733, i64 16
  %735 = load i64, ptr %734, align 8
  tail call fastcc void @nested(ptr noundef %715, ptr noundef %726, ptr noundef %727, i64 noundef %728, i64 noundef %731, ptr noundef %732, i64 noundef %735) #10
  tail call fastcc void @write_outputs(ptr noundef nonnull %0, ptr noundef %715, i64 noundef %720) #10
  %736 = load ptr, ptr %96, align 8
  %737 = load <8 x double>, ptr %736, align 8
  %738 = fcmp olt <8 x double> %737, %199
  %739 = bitcast <8 x i1> %738 to i8
  %740 = zext i8 %739 to i64
  %741 = and i64 %720, %740
  %742 = icmp eq i64 %741, 0
  br i1 %742, label %743, label %719, !llvm.loop !17

743:                                              ; preds = %719, %705, %524
  %744 = phi <8 x i64> [ %525, %524 ], [ %706, %705 ], [ %706, %719 ]
  %745 = phi i32 [ %163, %524 ], [ %708, %705 ], [ %708, %719 ]
  %746 = load ptr, ptr %96, align 8
  %747 = load <8 x double>, ptr %746, align 8
  %748 = fcmp oeq <8 x double> %747, %199
  %749 = icmp ne <8 x i64> %744, zeroinitializer
  %750 = select <8 x i1> %748, <8 x i1> %749, <8 x i1> zeroinitializer
  %751 = bitcast <8 x i1> %750 to i8
  %752 = icmp eq i8 %751, 0
  br i1 %752, label %755, label %753

753:                                              ; preds = %743
  %754 = zext i8 %751 to i64
  br label %764

755:                                              ; preds = %764, %743
  %756 = xor <8 x i64> %744, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %757 = select <8 x i1> %172, <8 x i64> %756, <8 x i64> zeroinitializer
  %758 = load ptr, ptr %53, align 8
  %759 = load <8 x double>, ptr %758, align 8
  %760 = icmp slt <8 x i64> %744, zeroinitializer
  %761 = select <8 x i1> %760, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %762 = bitcast <8 x i64> %761 to <8 x double>
  %763 = fadd <8 x double> %759, %762
  store <8 x double> %763, ptr %758, align 8
  br i1 %43, label %774, label %898

764:                                              ; preds = %753, %764
  %765 = phi i64 [ %772, %764 ], [ %754, %753 ]
  %766 = load ptr, ptr %109, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %766, i64 noundef %765) #10
  %767 = load ptr, ptr %96, align 8
  %768 = load <8 x double>, ptr %767, align 8
  %769 = fcmp oeq <8 x double> %768, %199
  %770 = bitcast <8 x i1> %769 to i8
  %771 = zext i8 %770 to i64
  %772 = and i64 %765, %771
  %773 = icmp eq i64 %772, 0
  br i1 %773, label %755, label %764, !llvm.loop !18

774:                                              ; preds = %755
  %775 = load ptr, ptr %110, align 8
  %776 = load <8 x double>, ptr %775, align 8
  %777 = load ptr, ptr %111, align 8
  %778 = load <8 x double>, ptr %777, align 8
  %779 = fcmp ogt <8 x double> %492, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %780 = bitcast <8 x double> %492 to <8 x i64>
  %781 = select <8 x i1> %779, <8 x i64> %780, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %782 = load double, ptr %112, align 8
  %783 = insertelement <8 x double> poison, double %782, i64 0
  %784 = shufflevector <8 x double> %783, <8 x double> poison, <8 x i32> zeroinitializer
  %785 = load double, ptr %113, align 8
  %786 = fneg double %785
  %787 = add <8 x i64> %781, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %788 = ashr <8 x i64> %787, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %789 = and <8 x i64> %787, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %790 = sub <8 x i64> %781, %789
  %791 = bitcast <8 x i64> %790 to <8 x double>
  %792 = fadd <8 x double> %791, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %793 = fadd <8 x double> %791, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %794 = fdiv <8 x double> %792, %793
  %795 = fmul <8 x double> %794, %794
  %796 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %795, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %797 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %796, <8 x double> %795, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %798 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %797, <8 x double> %795, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %799 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %798, <8 x double> %795, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %800 = trunc nsw <8 x i64> %788 to <8 x i32>
  %801 = sitofp <8 x i32> %800 to <8 x double>
  %802 = fmul <8 x double> %794, %799
  %803 = fadd <8 x double> %802, %801
  %804 = insertelement <8 x double> poison, double %786, i64 0
  %805 = shufflevector <8 x double> %804, <8 x double> poison, <8 x i32> zeroinitializer
  %806 = fmul <8 x double> %803, %805
  %807 = fcmp ogt <8 x double> %806, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %808 = bitcast <8 x double> %806 to <8 x i64>
  %809 = select <8 x i1> %807, <8 x i64> %808, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %810 = bitcast <8 x i64> %809 to <8 x double>
  %811 = fcmp olt <8 x double> %810, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %812 = bitcast <8 x i64> %809 to <8 x double>
  %813 = select <8 x i1> %811, <8 x double> %812, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %814 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %813)
  %815 = fsub <8 x double> %813, %814
  %816 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %815, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %817 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %816, <8 x double> %815, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %818 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %817, <8 x double> %815, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %819 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %818, <8 x double> %815, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %820 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %819, <8 x double> %815, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %821 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %820, <8 x double> %815, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %822 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %821, <8 x double> %815, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %823 = bitcast <8 x double> %822 to <8 x i64>
  %824 = fptosi <8 x double> %814 to <8 x i32>
  %825 = zext <8 x i32> %824 to <8 x i64>
  %826 = shl <8 x i64> %825, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %827 = add <8 x i64> %826, %823
  %828 = bitcast <8 x i64> %827 to <8 x double>
  %829 = fmul <8 x double> %784, %828
  %830 = load double, ptr %114, align 8
  %831 = fcmp une double %830, 0.000000e+00
  br i1 %831, label %832, label %877

832:                                              ; preds = %774
  %833 = bitcast <8 x double> %776 to <8 x i64>
  %834 = add <8 x i64> %833, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %835 = ashr <8 x i64> %834, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %836 = and <8 x i64> %834, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %837 = sub <8 x i64> %833, %836
  %838 = bitcast <8 x i64> %837 to <8 x double>
  %839 = fadd <8 x double> %838, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %840 = fadd <8 x double> %838, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %841 = fdiv <8 x double> %839, %840
  %842 = fmul <8 x double> %841, %841
  %843 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %842, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %844 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %843, <8 x double> %842, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %845 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %844, <8 x double> %842, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %846 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %845, <8 x double> %842, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %847 = trunc nsw <8 x i64> %835 to <8 x i32>
  %848 = sitofp <8 x i32> %847 to <8 x double>
  %849 = fmul <8 x double> %841, %846
  %850 = fadd <8 x double> %849, %848
  %851 = insertelement <8 x double> poison, double %830, i64 0
  %852 = shufflevector <8 x double> %851, <8 x double> poison, <8 x i32> zeroinitializer
  %853 = fmul <8 x double> %852, %850
  %854 = fcmp ogt <8 x double> %853, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %855 = bitcast <8 x double> %853 to <8 x i64>
  %856 = select <8 x i1> %854, <8 x i64> %855, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %857 = bitcast <8 x i64> %856 to <8 x double>
  %858 = fcmp olt <8 x double> %857, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %859 = bitcast <8 x i64> %856 to <8 x double>
  %860 = select <8 x i1> %858, <8 x double> %859, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %861 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %860)
  %862 = fsub <8 x double> %860, %861
  %863 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %862, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %864 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %863, <8 x double> %862, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %865 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %864, <8 x double> %862, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %866 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %865, <8 x double> %862, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %867 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %866, <8 x double> %862, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %868 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %867, <8 x double> %862, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %869 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %868, <8 x double> %862, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %870 = bitcast <8 x double> %869 to <8 x i64>
  %871 = fptosi <8 x double> %861 to <8 x i32>
  %872 = zext <8 x i32> %871 to <8 x i64>
  %873 = shl <8 x i64> %872, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %874 = add <8 x i64> %873, %870
  %875 = bitcast <8 x i64> %874 to <8 x double>
  %876 = fmul <8 x double> %829, %875
  br label %877

877:                                              ; preds = %774, %832
  %878 = phi <8 x double> [ %876, %832 ], [ %829, %774 ]
  %879 = load double, ptr %115, align 8
  %880 = insertelement <8 x double> poison, double %879, i64 0
  %881 = shufflevector <8 x double> %880, <8 x double> poison, <8 x i32> zeroinitializer
  %882 = fcmp ogt <8 x double> %878, %881
  %883 = select <8 x i1> %882, <8 x double> %878, <8 x double> %881
  %884 = fcmp olt <8 x double> %778, %883
  %885 = select <8 x i1> %884, <8 x double> %778, <8 x double> %883
  %886 = fmul <8 x double> %200, %885
  %887 = fcmp ogt <8 x double> %492, <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>
  %888 = select <8 x i1> %887, <8 x i64> %780, <8 x i64> <i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789>
  %889 = bitcast <8 x double> %776 to <8 x i64>
  %890 = select <8 x i1> %760, <8 x i64> %888, <8 x i64> %889
  store <8 x i64> %890, ptr %775, align 8
  %891 = load ptr, ptr %111, align 8
  %892 = load double, ptr %116, align 8
  %893 = insertelement <8 x double> poison, double %892, i64 0
  %894 = bitcast <8 x double> %893 to <8 x i64>
  %895 = shufflevector <8 x i64> %894, <8 x i64> poison, <8 x i32> zeroinitializer
  %896 = icmp slt <8 x i64> %757, zeroinitializer
  %897 = select <8 x i1> %896, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> %895
  store <8 x i64> %897, ptr %891, align 8
  br label %898

898:                                              ; preds = %877, %755
  %899 = phi <8 x double> [ %886, %877 ], [ %181, %755 ]
  %900 = icmp ne <8 x i64> %757, zeroinitializer
  %901 = bitcast <8 x i1> %900 to i8
  %902 = icmp eq i8 %901, 0
  br i1 %902, label %982, label %903

903:                                              ; preds = %898
  %904 = trunc i64 %526 to i8
  %905 = bitcast i8 %904 to <8 x i1>
  %906 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %492)
  %907 = fcmp ueq <8 x double> %906, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %908 = select <8 x i1> %907, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %905
  br i1 %43, label %909, label %968

909:                                              ; preds = %903
  %910 = fcmp ogt <8 x double> %492, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %911 = bitcast <8 x double> %492 to <8 x i64>
  %912 = select <8 x i1> %910, <8 x i64> %911, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %913 = load double, ptr %117, align 8
  %914 = insertelement <8 x double> poison, double %913, i64 0
  %915 = shufflevector <8 x double> %914, <8 x double> poison, <8 x i32> zeroinitializer
  %916 = load double, ptr %27, align 8
  %917 = fneg double %916
  %918 = add <8 x i64> %912, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %919 = ashr <8 x i64> %918, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %920 = and <8 x i64> %918, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %921 = sub <8 x i64> %912, %920
  %922 = bitcast <8 x i64> %921 to <8 x double>
  %923 = fadd <8 x double> %922, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %924 = fadd <8 x double> %922, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %925 = fdiv <8 x double> %923, %924
  %926 = fmul <8 x double> %925, %925
  %927 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %926, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %928 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %927, <8 x double> %926, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %929 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %928, <8 x double> %926, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %930 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %929, <8 x double> %926, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %931 = trunc nsw <8 x i64> %919 to <8 x i32>
  %932 = sitofp <8 x i32> %931 to <8 x double>
  %933 = fmul <8 x double> %925, %930
  %934 = fadd <8 x double> %933, %932
  %935 = insertelement <8 x double> poison, double %917, i64 0
  %936 = shufflevector <8 x double> %935, <8 x double> poison, <8 x i32> zeroinitializer
  %937 = fmul <8 x double> %934, %936
  %938 = fcmp ogt <8 x double> %937, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %939 = bitcast <8 x double> %937 to <8 x i64>
  %940 = select <8 x i1> %938, <8 x i64> %939, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %941 = bitcast <8 x i64> %940 to <8 x double>
  %942 = fcmp olt <8 x double> %941, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %943 = bitcast <8 x i64> %940 to <8 x double>
  %944 = select <8 x i1> %942, <8 x double> %943, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %945 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %944)
  %946 = fsub <8 x double> %944, %945
  %947 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %946, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %948 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %947, <8 x double> %946, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %949 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %948, <8 x double> %946, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %950 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %949, <8 x double> %946, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %951 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %950, <8 x double> %946, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %952 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %951, <8 x double> %946, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %953 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %952, <8 x double> %946, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %954 = bitcast <8 x double> %953 to <8 x i64>
  %955 = fptosi <8 x double> %945 to <8 x i32>
  %956 = zext <8 x i32> %955 to <8 x i64>
  %957 = shl <8 x i64> %956, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %958 = add <8 x i64> %957, %954
  %959 = bitcast <8 x i64> %958 to <8 x double>
  %960 = fmul <8 x double> %915, %959
  %961 = load double, ptr %118, align 8
  %962 = insertelement <8 x double> poison, double %961, i64 0
  %963 = shufflevector <8 x double> %962, <8 x double> poison, <8 x i32> zeroinitializer
  %964 = fcmp ogt <8 x double> %960, %963
  %965 = select <8 x i1> %964, <8 x double> %960, <8 x double> %963
  %966 = select <8 x i1> %908, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>, <8 x double> %965
  %967 = fmul <8 x double> %200, %966
  br label %968

968:                                              ; preds = %903, %909
  %969 = phi <8 x double> [ %967, %909 ], [ zeroinitializer, %903 ]
  %970 = select <8 x i1> %908, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>
  %971 = icmp slt <8 x i64> %757, zeroinitializer
  %972 = select <8 x i1> %971, <8 x double> %969, <8 x double> %899
  %973 = load ptr, ptr %119, align 8
  %974 = select <8 x i1> %905, <8 x i64> <i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152>, <8 x i64> %970
  %975 = load <8 x i64>, ptr %973, align 8
  %976 = select <8 x i1> %971, <8 x i64> %974, <8 x i64> %975
  store <8 x i64> %976, ptr %973, align 8
  %977 = load ptr, ptr %54, align 8
  %978 = load <8 x double>, ptr %977, align 8
  %979 = select <8 x i1> %971, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %980 = bitcast <8 x i64> %979 to <8 x double>
  %981 = fadd <8 x double> %978, %980
  store <8 x double> %981, ptr %977, align 8
  br label %982

982:                                              ; preds = %968, %898
  %983 = phi <8 x double> [ %899, %898 ], [ %972, %968 ]
  %984 = load ptr, ptr %50, align 8
  store <8 x double> %983, ptr %984, align 8
  %985 = load ptr, ptr %41, align 8
  %986 = select <8 x i1> %760, <8 x double> %199, <8 x double> %174
  store <8 x double> %986, ptr %985, align 8
  br i1 %120, label %995, label %987

987:                                              ; preds = %995, %982
  %988 = load ptr, ptr %96, align 8
  %989 = load <8 x double>, ptr %988, align 8
  %990 = fcmp oeq <8 x double> %989, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %991 = icmp ne <8 x i64> %744, zeroinitializer
  %992 = select <8 x i1> %990, <8 x i1> %991, <8 x i1> zeroinitializer
  %993 = bitcast <8 x i1> %992 to i8
  %994 = icmp eq i8 %993, 0
  br i1 %994, label %160, label %1013

995:                                              ; preds = %982, %995
  %996 = phi i64 [ %1011, %995 ], [ 0, %982 ]
  %997 = load ptr, ptr %7, align 8
  %998 = load ptr, ptr %121, align 8
  %999 = shl nsw i64 %996, 6
  %1000 = getelementptr inbounds i8, ptr %998, i64 %999
  %1001 = load <8 x i64>, ptr %1000, align 8
  %1002 = getelementptr inbounds i8, ptr %997, i64 %999
  %1003 = load <8 x i64>, ptr %1002, align 8
  %1004 = select <8 x i1> %760, <8 x i64> %1001, <8 x i64> %1003
  store <8 x i64> %1004, ptr %1002, align 8
  %1005 = load ptr, ptr %32, align 8
  %1006 = getelementptr inbounds i8, ptr %45, i64 %999
  %1007 = load <8 x i64>, ptr %1006, align 8
  %1008 = getelementptr inbounds i8, ptr %1005, i64 %999
  %1009 = load <8 x i64>, ptr %1008, align 8
  %1010 = select <8 x i1> %760, <8 x i64> %1007, <8 x i64> %1009
  store <8 x i64> %1010, ptr %1008, align 8
  %1011 = add nuw nsw i64 %996, 1
  %1012 = icmp eq i64 %1011, %11
  br i1 %1012, label %987, label %995, !llvm.loop !19

1013:                                             ; preds = %987
  %1014 = zext i8 %993 to i64
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %1014, i64 noundef 0) #10
  br label %160

1015:                                             ; preds = %162, %157
  %1016 = phi i64 [ 1, %157 ], [ 0, %162 ]
  ret i64 %1016
}



define internal fastcc i64 @fill(ptr noundef readonly %0, ptr noundef writeonly %1) unnamed_addr #2 {
  %3 = getelementptr inbounds i8, ptr %0, i64 624
  %4 = getelementptr inbounds i8, ptr %0, i64 912
  %5 = getelementptr inbounds i8, ptr %0, i64 360
  %6 = getelementptr inbounds i8, ptr %0, i64 864
  %7 = getelementptr inbounds i8, ptr %0, i64 992
  %8 = getelementptr inbounds i8, ptr %0, i64 984
  %9 = getelementptr inbounds i8, ptr %0, i64 1000
  %10 = getelementptr inbounds i8, ptr %0, i64 1008
  %11 = getelementptr inbounds i8, ptr %0, i64 192
  %12 = getelementptr inbounds i8, ptr %0, i64 1024
  %13 = getelementptr inbounds i8, ptr %0, i64 1032
  %14 = getelementptr inbounds i8, ptr %0, i64 216
  %15 = getelementptr inbounds i8, ptr %0, i64 1048
  %16 = getelementptr inbounds i8, ptr %0, i64 960
  br label %27

17:                                               ; preds = %102
  %18 = getelementptr inbounds i8, ptr %0, i64 144
  store i64 %110, ptr %1, align 8
  %19 = icmp slt i64 %111, 0
  br i1 %19, label %203, label %20

20:                                               ; preds = %17
  %21 = getelementptr inbounds i8, ptr %0, i64 864
  %22 = getelementptr inbounds i8, ptr %0, i64 528
  %23 = getelementptr inbounds i8, ptr %0, i64 192
  %24 = getelementptr inbounds i8, ptr %0, i64 216
  %25 = getelementptr inbounds i8, ptr %0, i64 648
  %26 = getelementptr inbounds i8, ptr %0, i64 744
  br label %123

27:                                               ; preds = %2, %102
  %28 = phi i64 [ 0, %2 ], [ %112, %102 ]
  %29 = phi i64 [ -1, %2 ], [ %111, %102 ]
  %30 = phi i64 [ 0, %2 ], [ %110, %102 ]
  %31 = phi i64 [ 0, %2 ], [ %103, %102 ]
  %32 = load ptr, ptr %6, align 8
  %33 = getelementptr inbounds i64, ptr %32, i64 %28
  %34 = load i64, ptr %33, align 8
  %35 = icmp eq i64 %34, -1
  br i1 %35, label %36, label %102

36:                                               ; preds = %27
  %37 = load ptr, ptr %4, align 8
  %38 = load i64, ptr %37, align 8
  %39 = load i64, ptr %7, align 8
  %40 = icmp slt i64 %38, %39
  br i1 %40, label %41, label %102

41:                                               ; preds = %36
  %42 = add nsw i64 %38, 1
  store i64 %42, ptr %37, align 8
  %43 = load ptr, ptr %6, align 8
  %44 = getelementptr inbounds i64, ptr %43, i64 %28
  store i64 %38, ptr %44, align 8
  %45 = load ptr, ptr %5, align 8
  %46 = load ptr, ptr %8, align 8
  %47 = load i64, ptr %9, align 8
  %48 = mul nsw i64 %47, %38
  %49 = getelementptr inbounds double, ptr %46, i64 %48
  %50 = getelementptr double, ptr %45, i64 %28
  %51 = icmp sgt i64 %47, 0
  br i1 %51, label %52, label %61

52:                                               ; preds = %41, %52
  %53 = phi i64 [ %58, %52 ], [ 0, %41 ]
  %54 = getelementptr inbounds double, ptr %49, i64 %53
  %55 = load double, ptr %54, align 8
  %56 = shl i64 %53, 6
  %57 = getelementptr i8, ptr %50, i64 %56
  store double %55, ptr %57, align 8
  %58 = add nuw nsw i64 %53, 1
  %59 = load i64, ptr %9, align 8
  %60 = icmp slt i64 %58, %59
  br i1 %60, label %52, label %61, !llvm.loop !20

61:                                               ; preds = %52, %41
  %62 = load ptr, ptr %11, align 8
  %63 = load ptr, ptr %10, align 8
  %64 = load i64, ptr %12, align 8
  %65 = mul nsw i64 %64, %38
  %66 = getelementptr inbounds double, ptr %63, i64 %65
  %67 = getelementptr double, ptr %62, i64 %28
  %68 = icmp sgt i64 %64, 0
  br i1 %68, label %69, label %78

69:                                               ; preds = %61, %69
  %70 = phi i64 [ %75, %69 ], [ 0, %61 ]
  %71 = getelementptr inbounds double, ptr %66, i64 %70
  %72 = load double, ptr %71, align 8
  %73 = shl i64 %70, 6
  %74 = getelementptr i8, ptr %67, i64 %73
  store double %72, ptr %74, align 8
  %75 = add nuw nsw i64 %70, 1
  %76 = load i64, ptr %12, align 8
  %77 = icmp slt i64 %75, %76
  br i1 %77, label %69, label %78, !llvm.loop !20

78:                                               ; preds = %69, %61
  %79 = load ptr, ptr %14, align 8
  %80 = load ptr, ptr %13, align 8
  %81 = load i64, ptr %15, align 8
  %82 = mul nsw i64 %81, %38
  %83 = getelementptr inbounds double, ptr %80, i64 %82
  %84 = getelementptr double, ptr %79, i64 %28
  %85 = icmp sgt i64 %81, 0
  br i1 %85, label %86, label %95

86:                                               ; preds = %78, %86
  %87 = phi i64 [ %92, %86 ], [ 0, %78 ]
  %88 = getelementptr inbounds double, ptr %83, i64 %87
  %89 = load double, ptr %88, align 8
  %90 = shl i64 %87, 6
  %91 = getelementptr i8, ptr %84, i64 %90
  store double %89, ptr %91, align 8
  %92 = add nuw nsw i64 %87, 1
  %93 = load i64, ptr %15, align 8
  %94 = icmp slt i64 %92, %93
  br i1 %94, label %86, label %95, !llvm.loop !20

95:                                               ; preds = %86, %78
  %96 = load ptr, ptr %16, align 8
  %97 = load double, ptr %96, align 8
  %98 = load ptr, ptr %3, align 8
  %99 = getelementptr inbounds double, ptr %98, i64 %28
  store double %97, ptr %99, align 8
  %100 = shl nuw nsw i64 1, %28
  %101 = or i64 %100, %31
  br label %102

102:                                              ; preds = %95, %36, %27
  %103 = phi i64 [ %101, %95 ], [ %31, %36 ], [ %31, %27 ]
  %104 = load ptr, ptr %6, align 8
  %105 = getelementptr inbounds i64, ptr %104, i64 %28
  %106 = load i64, ptr %105, align 8
  %107 = icmp sgt i64 %106, -1
  %108 = shl nuw nsw i64 1, %28
  %109 = select i1 %107, i64 %108, i64 0
  %110 = or i64 %109, %30
  %111 = select i1 %107, i64 %28, i64 %29
  %112 = add nuw nsw i64 %28, 1
  %113 = icmp eq i64 %112, 8
  br i1 %113, label %17, label %27, !llvm.loop !22

114:                                              ; preds = %200
  %115 = load ptr, ptr %18, align 8
  %116 = getelementptr inbounds i8, ptr %115, i64 40
  %117 = load i64, ptr %116, align 8
  %118 = inttoptr i64 %117 to ptr
  %119 = getelementptr inbounds i8, ptr %0, i64 216
  %120 = load ptr, ptr %119, align 8
  %121 = getelementptr inbounds i8, ptr %0, i64 240
  %122 = load ptr, ptr %121, align 8
  tail call void %118(ptr noundef %120, ptr noundef %122) #11
  br label %203

123:                                              ; preds = %20, %200
  %124 = phi i64 [ 0, %20 ], [ %201, %200 ]
  %125 = load ptr, ptr %21, align 8
  %126 = getelementptr inbounds i64, ptr %125, i64 %124
  %127 = load i64, ptr %126, align 8
  %128 = icmp eq i64 %127, -1
  br i1 %128, label %129, label %200

129:                                              ; preds = %123
  %130 = load ptr, ptr %5, align 8
  %131 = load ptr, ptr %18, align 8
  %132 = getelementptr inbounds i8, ptr %131, i64 8
  %133 = load i64, ptr %132, align 8
  %134 = icmp sgt i64 %133, 0
  br i1 %134, label %135, label %144

135:                                              ; preds = %129, %135
  %136 = phi i64 [ %142, %135 ], [ 0, %129 ]
  %137 = shl i64 %136, 6
  %138 = getelementptr i8, ptr %130, i64 %137
  %139 = getelementptr double, ptr %138, i64 %111
  %140 = load double, ptr %139, align 8
  %141 = getelementptr double, ptr %138, i64 %124
  store double %140, ptr %141, align 8
  %142 = add nuw nsw i64 %136, 1
  %143 = icmp eq i64 %142, %133
  br i1 %143, label %144, label %135, !llvm.loop !23

144:                                              ; preds = %135, %129
  %145 = load ptr, ptr %22, align 8
  %146 = load ptr, ptr %18, align 8
  %147 = getelementptr inbounds i8, ptr %146, i64 8
  %148 = load i64, ptr %147, align 8
  %149 = icmp sgt i64 %148, 0
  br i1 %149, label %150, label %159

150:                                              ; preds = %144, %150
  %151 = phi i64 [ %157, %150 ], [ 0, %144 ]
  %152 = shl i64 %151, 6
  %153 = getelementptr i8, ptr %145, i64 %152
  %154 = getelementptr double, ptr %153, i64 %111
  %155 = load double, ptr %154, align 8
  %156 = getelementptr double, ptr %153, i64 %124
  store double %155, ptr %156, align 8
  %157 = add nuw nsw i64 %151, 1
  %158 = icmp eq i64 %157, %148
  br i1 %158, label %159, label %150, !llvm.loop !23

159:                                              ; preds = %150, %144
  %160 = load ptr, ptr %23, align 8
  %161 = load ptr, ptr %18, align 8
  %162 = getelementptr inbounds i8, ptr %161, i64 48
  %163 = load i64, ptr %162, align 8
  %164 = icmp sgt i64 %163, 0
  br i1 %164, label %165, label %174

165:                                              ; preds = %159, %165
  %166 = phi i64 [ %172, %165 ], [ 0, %159 ]
  %167 = shl i64 %166, 6
  %168 = getelementptr i8, ptr %160, i64 %167
  %169 = getelementptr double, ptr %168, i64 %111
  %170 = load double, ptr %169, align 8
  %171 = getelementptr double, ptr %168, i64 %124
  store double %170, ptr %171, align 8
  %172 = add nuw nsw i64 %166, 1
  %173 = icmp eq i64 %172, %163
  br i1 %173, label %174, label %165, !llvm.loop !23

174:                                              ; preds = %165, %159
  %175 = load ptr, ptr %24, align 8
  %176 = load ptr, ptr %18, align 8
  %177 = getelementptr inbounds i8, ptr %176, i64 56
  %178 = load i64, ptr %177, align 8
  %179 = icmp sgt i64 %178, 0
  br i1 %179, label %180, label %189

180:                                              ; preds = %174, %180
  %181 = phi i64 [ %187, %180 ], [ 0, %174 ]
  %182 = shl i64 %181, 6
  %183 = getelementptr i8, ptr %175, i64 %182
  %184 = getelementptr double, ptr %183, i64 %111
  %185 = load double, ptr %184, align 8
  %186 = getelementptr double, ptr %183, i64 %124
  store double %185, ptr %186, align 8
  %187 = add nuw nsw i64 %181, 1
  %188 = icmp eq i64 %187, %178
  br i1 %188, label %189, label %180, !llvm.loop !23

189:                                              ; preds = %180, %174
  %190 = load ptr, ptr %3, align 8
  %191 = getelementptr inbounds double, ptr %190, i64 %111
  %192 = load double, ptr %191, align 8
  %193 = getelementptr inbounds double, ptr %190, i64 %124
  store double %192, ptr %193, align 8
  %194 = load ptr, ptr %25, align 8
  %195 = getelementptr inbounds double, ptr %194, i64 %124
  store double 0.000000e+00, ptr %195, align 8
  %196 = load ptr, ptr %26, align 8
  %197 = getelementptr inbounds double, ptr %196, i64 %124
  store double 0x7FF0000000000000, ptr %197, align 8
  %198 = load ptr, ptr %21, align 8
  %199 = getelementptr inbounds i64, ptr %198, i64 %124
  store i64 -2, ptr %199, align 8
  br label %200

200:                                              ; preds = %123, %189
  %201 = add nuw nsw i64 %124, 1
  %202 = icmp eq i64 %201, 8
  br i1 %202, label %114, label %123, !llvm.loop !24

203:                                              ; preds = %17, %114
  ret i64 %103
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
  br i1 %67, label %52, label %45, !llvm.loop !25

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
  br i1 %117, label %99, label %118, !llvm.loop !26

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
  br i1 %160, label %161, label %151, !llvm.loop !27

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
  br i1 %314, label %315, label %290, !llvm.loop !28

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
  br i1 %342, label %321, label %329, !llvm.loop !29
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
  br i1 %13, label %47, label %14

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
  br label %28

28:                                               ; preds = %14, %85
  %29 = phi i64 [ %1, %14 ], [ %96, %85 ]
  %30 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %29, i1 true)
  %31 = load ptr, ptr %15, align 8
  %32 = getelementptr inbounds i64, ptr %31, i64 %30
  %33 = load i64, ptr %32, align 8
  %34 = load i64, ptr %17, align 8
  %35 = load ptr, ptr %18, align 8
  %36 = getelementptr inbounds double, ptr %35, i64 %30
  %37 = load double, ptr %36, align 8
  %38 = fptosi double %37 to i64
  %39 = xor i64 %38, -1
  %40 = add i64 %34, %39
  %41 = icmp sgt i64 %40, 0
  br i1 %41, label %42, label %51

42:                                               ; preds = %28
  %43 = load ptr, ptr %16, align 8
  %44 = getelementptr inbounds i64, ptr %43, i64 %30
  %45 = load i64, ptr %44, align 8
  %46 = inttoptr i64 %45 to ptr
  br label %48

47:                                               ; preds = %85, %3
  ret void

48:                                               ; preds = %42, %70
  %49 = phi i64 [ %71, %70 ], [ %40, %42 ]
  %50 = phi ptr [ %72, %70 ], [ %46, %42 ]
  br i1 %19, label %74, label %70

51:                                               ; preds = %70, %28
  %52 = load ptr, ptr %20, align 8
  %53 = load i64, ptr %21, align 8
  %54 = mul nsw i64 %53, %33
  %55 = getelementptr inbounds i64, ptr %52, i64 %54
  %56 = load ptr, ptr %22, align 8
  %57 = getelementptr inbounds double, ptr %56, i64 %30
  %58 = load double, ptr %57, align 8
  %59 = fptosi double %58 to i64
  store i64 %59, ptr %55, align 8
  %60 = load ptr, ptr %23, align 8
  %61 = getelementptr inbounds double, ptr %60, i64 %30
  %62 = load double, ptr %61, align 8
  %63 = fptosi double %62 to i64
  %64 = getelementptr inbounds i8, ptr %55, i64 8
  store i64 %63, ptr %64, align 8
  %65 = load ptr, ptr %24, align 8
  %66 = getelementptr inbounds double, ptr %65, i64 %30
  %67 = load double, ptr %66, align 8
  %68 = fptosi double %67 to i64
  %69 = getelementptr inbounds i8, ptr %55, i64 16
  store i64 %68, ptr %69, align 8
  br i1 %25, label %80, label %85

70:                                               ; preds = %74, %48
  %71 = add nsw i64 %49, -1
  %72 = getelementptr inbounds i8, ptr %50, i64 8
  %73 = icmp sgt i64 %49, 1
  br i1 %73, label %48, label %51, !llvm.loop !30

74:                                               ; preds = %48, %74
  %75 = phi i64 [ %78, %74 ], [ 0, %48 ]
  %76 = mul nsw i64 %75, %12
  %77 = getelementptr inbounds double, ptr %50, i64 %76
  store double 0x7FF8000000000000, ptr %77, align 8
  %78 = add nuw nsw i64 %75, 1
  %79 = icmp eq i64 %78, %9
  br i1 %79, label %70, label %74, !llvm.loop !31

80:                                               ; preds = %51
  %81 = load ptr, ptr %26, align 8
  %82 = getelementptr inbounds double, ptr %81, i64 %30
  %83 = load double, ptr %82, align 8
  %84 = fptosi double %83 to i64
  br label %85

85:                                               ; preds = %51, %80
  %86 = phi i64 [ %84, %80 ], [ %2, %51 ]
  %87 = getelementptr inbounds i8, ptr %55, i64 24
  store i64 %86, ptr %87, align 8
  %88 = load ptr, ptr %4, align 8
  %89 = getelementptr inbounds double, ptr %88, i64 %30
  %90 = load double, ptr %89, align 8
  %91 = load ptr, ptr %27, align 8
  %92 = getelementptr inbounds double, ptr %91, i64 %33
  store double %90, ptr %92, align 8
  %93 = load ptr, ptr %15, align 8
  %94 = getelementptr inbounds i64, ptr %93, i64 %30
  store i64 -1, ptr %94, align 8
  %95 = add nsw i64 %29, -1
  %96 = and i64 %95, %29
  %97 = icmp eq i64 %96, 0
  br i1 %97, label %47, label %28, !llvm.loop !32
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
  br i1 %45, label %28, label %19, !llvm.loop !33

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
  br i1 %54, label %29, label %46, !llvm.loop !34
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
  br i1 %48, label %13, label %20, !llvm.loop !35
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
  br i1 %50, label %51, label %25, !llvm.loop !36

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
  br i1 %98, label %14, label %19, !llvm.loop !37

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
  br i1 %123, label %104, label %110, !llvm.loop !36

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
  br i1 %138, label %99, label %139, !llvm.loop !38

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
  br i1 %24, label %14, label %13, !llvm.loop !39

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
  br i1 %70, label %59, label %71, !llvm.loop !40

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
  br i1 %99, label %21, label %25, !llvm.loop !41
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
  br i1 %31, label %20, label %19, !llvm.loop !42

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
  br i1 %43, label %32, label %24, !llvm.loop !43
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
!22 = distinct !{!22, !4, !5}
!23 = distinct !{!23, !4, !5, !21}
!24 = distinct !{!24, !4, !5}
!25 = distinct !{!25, !4, !5}
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5}
!29 = distinct !{!29, !4, !5}
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5, !21}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5, !21}
!35 = distinct !{!35, !4, !5}
!36 = distinct !{!36, !4, !5}
!37 = distinct !{!37, !4, !5}
!38 = distinct !{!38, !4, !5}
!39 = distinct !{!39, !4, !5}
!40 = distinct !{!40, !4, !5}
!41 = distinct !{!41, !4, !5}
!42 = distinct !{!42, !4, !5}
!43 = distinct !{!43, !4, !5}
