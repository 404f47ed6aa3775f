; sources fd674529b58db699e92b35817881229ac6b96b751ec7e540ed8bb95ce55081ad
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
  %32 = icmp sgt i64 %31, 0
  %33 = getelementptr inbounds i8, ptr %14, i64 32
  %34 = load i64, ptr %33, align 8
  %35 = getelementptr inbounds i8, ptr %0, i64 1136
  %36 = load i64, ptr %35, align 8
  %37 = icmp sgt i64 %36, 0
  %38 = getelementptr inbounds i8, ptr %0, i64 528
  %39 = load ptr, ptr %38, align 8
  %40 = load i64, ptr %14, align 8
  %41 = getelementptr inbounds i8, ptr %0, i64 368
  %42 = load i64, ptr %41, align 8
  %43 = mul nsw i64 %42, %40
  store i64 0, ptr %5, align 8
  %44 = getelementptr inbounds i8, ptr %0, i64 864
  %45 = load ptr, ptr %44, align 8
  br label %134

46:                                               ; preds = %134
  %47 = getelementptr inbounds i8, ptr %0, i64 624
  %48 = sitofp i64 %27 to double
  %49 = zext i1 %32 to i32
  %50 = icmp ne i64 %34, 1
  %51 = select i1 %37, i1 true, i1 %50
  %52 = getelementptr inbounds double, ptr %39, i64 %43
  store i64 %142, ptr %5, align 8
  %53 = getelementptr inbounds i8, ptr %0, i64 864
  %54 = getelementptr inbounds i8, ptr %0, i64 744
  %55 = insertelement <8 x double> poison, double %21, i64 0
  %56 = shufflevector <8 x double> %55, <8 x double> poison, <8 x i32> zeroinitializer
  %57 = getelementptr inbounds i8, ptr %0, i64 648
  %58 = insertelement <8 x double> poison, double %24, i64 0
  %59 = shufflevector <8 x double> %58, <8 x double> poison, <8 x i32> zeroinitializer
  %60 = getelementptr inbounds i8, ptr %0, i64 768
  %61 = getelementptr inbounds i8, ptr %0, i64 792
  %62 = insertelement <8 x double> poison, double %48, i64 0
  %63 = shufflevector <8 x double> %62, <8 x double> poison, <8 x i32> zeroinitializer
  %64 = getelementptr inbounds i8, ptr %0, i64 432
  %65 = getelementptr inbounds i8, ptr %0, i64 408
  %66 = getelementptr inbounds i8, ptr %0, i64 24
  %67 = getelementptr inbounds i8, ptr %0, i64 528
  %68 = getelementptr inbounds i8, ptr %0, i64 48
  %69 = getelementptr inbounds i8, ptr %0, i64 72
  %70 = getelementptr inbounds i8, ptr %0, i64 368
  %71 = getelementptr inbounds i8, ptr %0, i64 96
  %72 = getelementptr inbounds i8, ptr %0, i64 168
  %73 = getelementptr inbounds i8, ptr %0, i64 272
  %74 = getelementptr inbounds i8, ptr %0, i64 192
  %75 = getelementptr inbounds i8, ptr %0, i64 240
  %76 = getelementptr inbounds i8, ptr %0, i64 384
  %77 = getelementptr inbounds i8, ptr %0, i64 24
  %78 = getelementptr inbounds i8, ptr %0, i64 528
  %79 = getelementptr inbounds i8, ptr %0, i64 48
  %80 = getelementptr inbounds i8, ptr %0, i64 72
  %81 = getelementptr inbounds i8, ptr %0, i64 384
  %82 = getelementptr inbounds i8, ptr %0, i64 168
  %83 = getelementptr inbounds i8, ptr %0, i64 272
  %84 = getelementptr inbounds i8, ptr %0, i64 192
  %85 = getelementptr inbounds i8, ptr %0, i64 240
  %86 = icmp sgt i64 %13, 0
  %87 = getelementptr inbounds i8, ptr %0, i64 384
  %88 = getelementptr inbounds i8, ptr %0, i64 504
  %89 = getelementptr inbounds i8, ptr %0, i64 368
  %90 = getelementptr inbounds i8, ptr %0, i64 480
  %91 = getelementptr inbounds i8, ptr %0, i64 600
  %92 = getelementptr inbounds i8, ptr %0, i64 576
  %93 = getelementptr inbounds i8, ptr %0, i64 384
  %94 = getelementptr inbounds i8, ptr %0, i64 384
  %95 = getelementptr inbounds i8, ptr %0, i64 168
  %96 = getelementptr inbounds i8, ptr %0, i64 272
  %97 = getelementptr inbounds i8, ptr %0, i64 192
  %98 = getelementptr inbounds i8, ptr %0, i64 240
  %99 = getelementptr inbounds i8, ptr %0, i64 816
  %100 = sext i1 %50 to i64
  %101 = uitofp i1 %51 to double
  %102 = insertelement <8 x double> poison, double %101, i64 0
  %103 = bitcast <8 x double> %102 to <8 x i64>
  %104 = shufflevector <8 x i64> %103, <8 x i64> poison, <8 x i32> zeroinitializer
  %105 = getelementptr inbounds i8, ptr %0, i64 744
  %106 = getelementptr inbounds i8, ptr %0, i64 368
  %107 = getelementptr inbounds i8, ptr %0, i64 552
  %108 = getelementptr inbounds i8, ptr %0, i64 408
  %109 = getelementptr inbounds i8, ptr %0, i64 96
  %110 = getelementptr inbounds i8, ptr %0, i64 168
  %111 = getelementptr inbounds i8, ptr %0, i64 272
  %112 = getelementptr inbounds i8, ptr %0, i64 192
  %113 = getelementptr inbounds i8, ptr %0, i64 240
  %114 = getelementptr inbounds i8, ptr %0, i64 480
  %115 = getelementptr inbounds i8, ptr %14, i64 16
  %116 = getelementptr inbounds i8, ptr %0, i64 720
  %117 = getelementptr inbounds i8, ptr %0, i64 408
  %118 = getelementptr inbounds i8, ptr %0, i64 888
  %119 = getelementptr inbounds i8, ptr %0, i64 456
  %120 = getelementptr inbounds i8, ptr %0, i64 888
  %121 = getelementptr inbounds i8, ptr %0, i64 384
  %122 = getelementptr inbounds i8, ptr %0, i64 672
  %123 = getelementptr inbounds i8, ptr %0, i64 696
  %124 = getelementptr inbounds i8, ptr %29, i64 24
  %125 = getelementptr inbounds i8, ptr %29, i64 8
  %126 = getelementptr inbounds i8, ptr %29, i64 16
  %127 = getelementptr inbounds i8, ptr %29, i64 32
  %128 = getelementptr inbounds i8, ptr %29, i64 40
  %129 = getelementptr inbounds i8, ptr %29, i64 24
  %130 = getelementptr inbounds i8, ptr %29, i64 32
  %131 = getelementptr inbounds i8, ptr %0, i64 840
  %132 = icmp sgt i64 %13, 0
  %133 = getelementptr inbounds i8, ptr %0, i64 384
  br label %145

134:                                              ; preds = %1, %134
  %135 = phi i64 [ 0, %1 ], [ %143, %134 ]
  %136 = phi i64 [ 0, %1 ], [ %142, %134 ]
  %137 = getelementptr inbounds i64, ptr %45, i64 %135
  %138 = load i64, ptr %137, align 8
  %139 = icmp sgt i64 %138, -1
  %140 = zext i1 %139 to i64
  %141 = shl nuw nsw i64 %140, %135
  %142 = or i64 %141, %136
  %143 = add nuw nsw i64 %135, 1
  %144 = icmp eq i64 %143, 8
  br i1 %144, label %46, label %134, !llvm.loop !3

145:                                              ; preds = %172, %46
  %146 = phi i32 [ 1, %46 ], [ %173, %172 ]
  %147 = icmp eq i32 %146, 0
  br i1 %147, label %174, label %148

148:                                              ; preds = %145
  %149 = call fastcc i64 @fill(ptr noundef nonnull %0, ptr noundef nonnull %5) #10
  %150 = load i64, ptr %5, align 8
  %151 = icmp eq i64 %150, 0
  br i1 %151, label %169, label %152

152:                                              ; preds = %148
  %153 = icmp eq i64 %149, 0
  br i1 %153, label %169, label %154

154:                                              ; preds = %152
  call fastcc void @start(ptr noundef nonnull %0, ptr noundef nonnull %3, i64 noundef %149) #10
  br label %155

155:                                              ; preds = %154, %164
  %156 = phi i32 [ 0, %154 ], [ %166, %164 ]
  %157 = phi i64 [ 0, %154 ], [ %167, %164 ]
  %158 = icmp eq i32 %156, 0
  br i1 %158, label %159, label %164

159:                                              ; preds = %155
  %160 = load ptr, ptr %53, align 8
  %161 = getelementptr inbounds i64, ptr %160, i64 %157
  %162 = load i64, ptr %161, align 8
  %163 = icmp eq i64 %162, -1
  br label %164

164:                                              ; preds = %159, %155
  %165 = phi i1 [ true, %155 ], [ %163, %159 ]
  %166 = zext i1 %165 to i32
  %167 = add nuw nsw i64 %157, 1
  %168 = icmp eq i64 %167, 8
  br i1 %168, label %169, label %155, !llvm.loop !6

169:                                              ; preds = %164, %152, %148
  %170 = phi i32 [ 1, %148 ], [ 8, %152 ], [ 0, %164 ]
  %171 = phi i32 [ %146, %148 ], [ %146, %152 ], [ %166, %164 ]
  switch i32 %170, label %1098 [
    i32 0, label %172
    i32 8, label %174
  ]

172:                                              ; preds = %169, %1070, %1096, %228
  %173 = phi i32 [ %171, %169 ], [ %821, %1070 ], [ 1, %1096 ], [ 1, %228 ]
  br label %145, !llvm.loop !7

174:                                              ; preds = %169, %145
  %175 = phi i32 [ %171, %169 ], [ 0, %145 ]
  %176 = load ptr, ptr %10, align 8
  %177 = getelementptr inbounds i8, ptr %176, i64 8
  %178 = load i64, ptr %177, align 8
  %179 = icmp slt i64 %178, 1
  br i1 %179, label %1098, label %180

180:                                              ; preds = %174
  %181 = add nsw i64 %178, -1
  store i64 %181, ptr %177, align 8
  %182 = load i64, ptr %5, align 8
  %183 = trunc i64 %182 to i8
  %184 = bitcast i8 %183 to <8 x i1>
  %185 = load ptr, ptr %47, align 8
  %186 = load <8 x double>, ptr %185, align 8
  br i1 %32, label %190, label %187

187:                                              ; preds = %180
  %188 = load ptr, ptr %54, align 8
  %189 = load <8 x double>, ptr %188, align 8
  br label %190

190:                                              ; preds = %180, %187
  %191 = phi <8 x double> [ %189, %187 ], [ %56, %180 ]
  %192 = load ptr, ptr %57, align 8
  %193 = load <8 x double>, ptr %192, align 8
  br i1 %32, label %194, label %197

194:                                              ; preds = %190
  %195 = fcmp olt <8 x double> %193, %59
  %196 = select <8 x i1> %195, <8 x double> %193, <8 x double> %59
  br label %203

197:                                              ; preds = %190
  %198 = fsub <8 x double> %191, %186
  %199 = fdiv <8 x double> %198, %193
  %200 = fmul <8 x double> %199, <double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1>
  %201 = tail call <8 x double> @llvm.ceil.v8f64(<8 x double> %200)
  %202 = fdiv <8 x double> %198, %201
  br label %203

203:                                              ; preds = %197, %194
  %204 = phi <8 x double> [ %196, %194 ], [ %202, %197 ]
  %205 = fadd <8 x double> %186, %204
  %206 = fmul <8 x double> %204, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %207 = fsub <8 x double> %191, %206
  %208 = fcmp ogt <8 x double> %205, %207
  %209 = fsub <8 x double> %191, %186
  %210 = select <8 x i1> %208, <8 x double> %209, <8 x double> %204
  %211 = select <8 x i1> %208, <8 x double> %191, <8 x double> %205
  %212 = select <8 x i1> %184, <8 x double> %210, <8 x double> zeroinitializer
  %213 = load ptr, ptr %60, align 8
  %214 = load <8 x double>, ptr %213, align 8
  %215 = load ptr, ptr %61, align 8
  %216 = load <8 x double>, ptr %215, align 8
  %217 = fadd <8 x double> %214, %216
  %218 = fcmp oge <8 x double> %217, %63
  %219 = fmul <8 x double> %212, <double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02>
  %220 = fadd <8 x double> %186, %219
  %221 = fcmp ule <8 x double> %220, %186
  %222 = fcmp une <8 x double> %211, %191
  %223 = and <8 x i1> %221, %222
  %224 = or <8 x i1> %223, %218
  %225 = and <8 x i1> %224, %184
  %226 = bitcast <8 x i1> %225 to i8
  %227 = icmp eq i8 %226, 0
  br i1 %227, label %235, label %228

228:                                              ; preds = %203
  %229 = zext i8 %226 to i64
  %230 = bitcast <8 x i1> %218 to i8
  %231 = zext i8 %230 to i64
  %232 = and i64 %229, %231
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %232, i64 noundef 1) #10
  %233 = xor i64 %231, -1
  %234 = and i64 %229, %233
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %234, i64 noundef -1) #10
  br label %172

235:                                              ; preds = %203
  %236 = load ptr, ptr %0, align 8
  %237 = load i64, ptr %236, align 8
  %238 = load ptr, ptr %64, align 8
  store <8 x double> %212, ptr %238, align 8
  %239 = icmp sgt i64 %237, 1
  br i1 %239, label %240, label %289

240:                                              ; preds = %235, %277
  %241 = phi i64 [ %286, %277 ], [ 0, %235 ]
  %242 = phi i64 [ %287, %277 ], [ 1, %235 ]
  %243 = load ptr, ptr %65, align 8
  %244 = load ptr, ptr %9, align 8
  %245 = load ptr, ptr %7, align 8
  %246 = getelementptr inbounds i8, ptr %245, i64 16
  %247 = load i64, ptr %246, align 8
  %248 = load ptr, ptr %66, align 8
  %249 = getelementptr inbounds i64, ptr %248, i64 %242
  %250 = load i64, ptr %249, align 8
  %251 = getelementptr i8, ptr %249, i64 8
  %252 = load i64, ptr %251, align 8
  %253 = xor i64 %250, -1
  %254 = add i64 %252, %253
  %255 = load ptr, ptr %64, align 8
  %256 = load ptr, ptr %67, align 8
  %257 = load ptr, ptr %68, align 8
  %258 = getelementptr inbounds i64, ptr %257, i64 %250
  %259 = load ptr, ptr %69, align 8
  %260 = getelementptr inbounds double, ptr %259, i64 %250
  tail call fastcc void @combine(ptr noundef %243, ptr noundef %244, ptr noundef %255, ptr noundef %256, ptr noundef %258, ptr noundef %260, i64 noundef %254, i64 noundef %247) #10
  %261 = load ptr, ptr %67, align 8
  %262 = load i64, ptr %70, align 8
  %263 = mul nsw i64 %262, %242
  %264 = getelementptr inbounds double, ptr %261, i64 %263
  %265 = load ptr, ptr %71, align 8
  %266 = getelementptr inbounds double, ptr %265, i64 %242
  %267 = load double, ptr %266, align 8
  %268 = insertelement <8 x double> poison, double %267, i64 0
  %269 = shufflevector <8 x double> %268, <8 x double> poison, <8 x i32> zeroinitializer
  %270 = fmul <8 x double> %212, %269
  %271 = fadd <8 x double> %186, %270
  %272 = load ptr, ptr %65, align 8
  %273 = load ptr, ptr %72, align 8
  store <8 x double> %271, ptr %273, align 8
  %274 = load i64, ptr %73, align 8
  %275 = icmp sgt i64 %274, 0
  br i1 %275, label %276, label %277

276:                                              ; preds = %240
  tail call fastcc void @sample(ptr noundef nonnull %7) #10
  br label %277

277:                                              ; preds = %240, %276
  %278 = load ptr, ptr %7, align 8
  %279 = load i64, ptr %278, align 8
  %280 = load ptr, ptr %72, align 8
  %281 = load ptr, ptr %74, align 8
  %282 = load ptr, ptr %75, align 8
  %283 = inttoptr i64 %279 to ptr
  %284 = tail call i32 %283(ptr noundef %280, ptr noundef %272, ptr noundef %281, ptr noundef %282, ptr noundef %264) #11
  %285 = zext i32 %284 to i64
  %286 = or i64 %241, %285
  %287 = add nuw nsw i64 %242, 1
  %288 = icmp eq i64 %287, %237
  br i1 %288, label %289, label %240, !llvm.loop !8

289:                                              ; preds = %277, %235
  %290 = phi i64 [ 0, %235 ], [ %286, %277 ]
  %291 = load ptr, ptr %76, align 8
  %292 = load ptr, ptr %9, align 8
  %293 = load ptr, ptr %7, align 8
  %294 = getelementptr inbounds i8, ptr %293, i64 16
  %295 = load i64, ptr %294, align 8
  %296 = load ptr, ptr %77, align 8
  %297 = getelementptr inbounds i64, ptr %296, i64 %237
  %298 = load i64, ptr %297, align 8
  %299 = getelementptr i8, ptr %297, i64 8
  %300 = load i64, ptr %299, align 8
  %301 = xor i64 %298, -1
  %302 = add i64 %300, %301
  %303 = load ptr, ptr %64, align 8
  %304 = load ptr, ptr %78, align 8
  %305 = load ptr, ptr %79, align 8
  %306 = getelementptr inbounds i64, ptr %305, i64 %298
  %307 = load ptr, ptr %80, align 8
  %308 = getelementptr inbounds double, ptr %307, i64 %298
  tail call fastcc void @combine(ptr noundef %291, ptr noundef %292, ptr noundef %303, ptr noundef %304, ptr noundef %306, ptr noundef %308, i64 noundef %302, i64 noundef %295) #10
  br i1 %50, label %325, label %309

309:                                              ; preds = %289
  %310 = load ptr, ptr %81, align 8
  %311 = load ptr, ptr %82, align 8
  store <8 x double> %211, ptr %311, align 8
  %312 = load i64, ptr %83, align 8
  %313 = icmp sgt i64 %312, 0
  br i1 %313, label %314, label %315

314:                                              ; preds = %309
  tail call fastcc void @sample(ptr noundef nonnull %7) #10
  br label %315

315:                                              ; preds = %309, %314
  %316 = load ptr, ptr %7, align 8
  %317 = load i64, ptr %316, align 8
  %318 = load ptr, ptr %82, align 8
  %319 = load ptr, ptr %84, align 8
  %320 = load ptr, ptr %85, align 8
  %321 = inttoptr i64 %317 to ptr
  %322 = tail call i32 %321(ptr noundef %318, ptr noundef %310, ptr noundef %319, ptr noundef %320, ptr noundef %52) #11
  %323 = zext i32 %322 to i64
  %324 = or i64 %290, %323
  br label %325

325:                                              ; preds = %315, %289
  %326 = phi i64 [ %324, %315 ], [ %290, %289 ]
  br i1 %32, label %330, label %327

327:                                              ; preds = %325
  br i1 %86, label %328, label %503

328:                                              ; preds = %327
  %329 = load ptr, ptr %87, align 8
  br label %493

330:                                              ; preds = %325
  %331 = load ptr, ptr %7, align 8
  %332 = load ptr, ptr %0, align 8
  %333 = getelementptr inbounds i8, ptr %331, i64 24
  %334 = load i64, ptr %333, align 8
  %335 = getelementptr inbounds i8, ptr %332, i64 8
  %336 = load i64, ptr %335, align 8
  %337 = load ptr, ptr %88, align 8
  %338 = load i64, ptr %89, align 8
  %339 = getelementptr inbounds double, ptr %337, i64 %338
  %340 = icmp sgt i64 %336, 0
  br i1 %340, label %341, label %343

341:                                              ; preds = %330
  %342 = getelementptr inbounds i8, ptr %331, i64 32
  br label %351

343:                                              ; preds = %351, %330
  %344 = icmp sgt i64 %334, 0
  br i1 %344, label %345, label %377

345:                                              ; preds = %343
  %346 = load ptr, ptr %9, align 8
  %347 = load ptr, ptr %76, align 8
  %348 = load ptr, ptr %91, align 8
  %349 = load ptr, ptr %92, align 8
  %350 = load ptr, ptr %88, align 8
  br label %440

351:                                              ; preds = %341, %351
  %352 = phi i64 [ 0, %341 ], [ %375, %351 ]
  %353 = load i64, ptr %332, align 8
  %354 = load i64, ptr %342, align 8
  %355 = load ptr, ptr %88, align 8
  %356 = load i64, ptr %89, align 8
  %357 = mul nsw i64 %356, %352
  %358 = getelementptr inbounds double, ptr %355, i64 %357
  %359 = load ptr, ptr %90, align 8
  %360 = load ptr, ptr %77, align 8
  %361 = getelementptr i64, ptr %360, i64 %353
  %362 = getelementptr i8, ptr %361, i64 8
  %363 = getelementptr i64, ptr %362, i64 %352
  %364 = load i64, ptr %363, align 8
  %365 = getelementptr i8, ptr %363, i64 8
  %366 = load i64, ptr %365, align 8
  %367 = xor i64 %364, -1
  %368 = add i64 %366, %367
  %369 = load ptr, ptr %64, align 8
  %370 = load ptr, ptr %78, align 8
  %371 = load ptr, ptr %79, align 8
  %372 = getelementptr inbounds i64, ptr %371, i64 %364
  %373 = load ptr, ptr %80, align 8
  %374 = getelementptr inbounds double, ptr %373, i64 %364
  tail call fastcc void @combine(ptr noundef %358, ptr noundef %359, ptr noundef %369, ptr noundef %370, ptr noundef %372, ptr noundef %374, i64 noundef %368, i64 noundef %354) #10
  %375 = add nuw nsw i64 %352, 1
  %376 = icmp eq i64 %375, %336
  br i1 %376, label %343, label %351, !llvm.loop !9

377:                                              ; preds = %440, %343
  %378 = phi <8 x double> [ zeroinitializer, %343 ], [ %473, %440 ]
  %379 = phi <8 x double> [ zeroinitializer, %343 ], [ %471, %440 ]
  %380 = load ptr, ptr %76, align 8
  %381 = getelementptr inbounds i8, ptr %331, i64 8
  %382 = load i64, ptr %381, align 8
  %383 = add nsw i64 %382, -3
  %384 = getelementptr i8, ptr %380, i64 64
  %385 = getelementptr i8, ptr %380, i64 128
  %386 = getelementptr i8, ptr %380, i64 192
  %387 = icmp slt i64 %334, %383
  br i1 %387, label %395, label %388

388:                                              ; preds = %395, %377
  %389 = phi <8 x double> [ zeroinitializer, %377 ], [ %405, %395 ]
  %390 = phi <8 x double> [ zeroinitializer, %377 ], [ %410, %395 ]
  %391 = phi <8 x double> [ zeroinitializer, %377 ], [ %415, %395 ]
  %392 = phi <8 x double> [ zeroinitializer, %377 ], [ %420, %395 ]
  %393 = phi i64 [ %334, %377 ], [ %421, %395 ]
  %394 = icmp slt i64 %393, %382
  br i1 %394, label %423, label %433

395:                                              ; preds = %377, %395
  %396 = phi i64 [ %421, %395 ], [ %334, %377 ]
  %397 = phi <8 x double> [ %420, %395 ], [ zeroinitializer, %377 ]
  %398 = phi <8 x double> [ %415, %395 ], [ zeroinitializer, %377 ]
  %399 = phi <8 x double> [ %410, %395 ], [ zeroinitializer, %377 ]
  %400 = phi <8 x double> [ %405, %395 ], [ zeroinitializer, %377 ]
  %401 = shl nsw i64 %396, 6
  %402 = getelementptr inbounds i8, ptr %380, i64 %401
  %403 = load <8 x double>, ptr %402, align 8
  %404 = fmul <8 x double> %403, zeroinitializer
  %405 = fadd <8 x double> %400, %404
  %406 = shl i64 %396, 6
  %407 = getelementptr i8, ptr %384, i64 %406
  %408 = load <8 x double>, ptr %407, align 8
  %409 = fmul <8 x double> %408, zeroinitializer
  %410 = fadd <8 x double> %399, %409
  %411 = shl i64 %396, 6
  %412 = getelementptr i8, ptr %385, i64 %411
  %413 = load <8 x double>, ptr %412, align 8
  %414 = fmul <8 x double> %413, zeroinitializer
  %415 = fadd <8 x double> %398, %414
  %416 = shl i64 %396, 6
  %417 = getelementptr i8, ptr %386, i64 %416
  %418 = load <8 x double>, ptr %417, align 8
  %419 = fmul <8 x double> %418, zeroinitializer
  %420 = fadd <8 x double> %397, %419
  %421 = add nsw i64 %396, 4
  %422 = icmp slt i64 %421, %383
  br i1 %422, label %395, label %388, !llvm.loop !10

423:                                              ; preds = %388, %423
  %424 = phi i64 [ %431, %423 ], [ %393, %388 ]
  %425 = phi <8 x double> [ %430, %423 ], [ %389, %388 ]
  %426 = shl nsw i64 %424, 6
  %427 = getelementptr inbounds i8, ptr %380, i64 %426
  %428 = load <8 x double>, ptr %427, align 8
  %429 = fmul <8 x double> %428, zeroinitializer
  %430 = fadd <8 x double> %425, %429
  %431 = add nsw i64 %424, 1
  %432 = icmp eq i64 %431, %382
  br i1 %432, label %433, label %423, !llvm.loop !11

433:                                              ; preds = %423, %388
  %434 = phi <8 x double> [ %389, %388 ], [ %430, %423 ]
  %435 = fadd <8 x double> %390, %434
  %436 = fadd <8 x double> %391, %392
  %437 = fadd <8 x double> %436, %435
  %438 = fadd <8 x double> %379, %437
  %439 = icmp eq i64 %336, 2
  br i1 %439, label %476, label %487

440:                                              ; preds = %345, %440
  %441 = phi <8 x double> [ zeroinitializer, %345 ], [ %471, %440 ]
  %442 = phi <8 x double> [ zeroinitializer, %345 ], [ %473, %440 ]
  %443 = phi i64 [ 0, %345 ], [ %474, %440 ]
  %444 = shl nsw i64 %443, 6
  %445 = getelementptr inbounds i8, ptr %346, i64 %444
  %446 = load <8 x double>, ptr %445, align 8
  %447 = getelementptr inbounds i8, ptr %347, i64 %444
  %448 = load <8 x double>, ptr %447, align 8
  %449 = getelementptr inbounds double, ptr %348, i64 %443
  %450 = load double, ptr %449, align 8
  %451 = insertelement <8 x double> poison, double %450, i64 0
  %452 = shufflevector <8 x double> %451, <8 x double> poison, <8 x i32> zeroinitializer
  %453 = getelementptr inbounds double, ptr %349, i64 %443
  %454 = load double, ptr %453, align 8
  %455 = insertelement <8 x double> poison, double %454, i64 0
  %456 = shufflevector <8 x double> %455, <8 x double> poison, <8 x i32> zeroinitializer
  %457 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %446)
  %458 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %448)
  %459 = fcmp ogt <8 x double> %457, %458
  %460 = select <8 x i1> %459, <8 x double> %457, <8 x double> %458
  %461 = fmul <8 x double> %460, %456
  %462 = fadd <8 x double> %452, %461
  %463 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %462
  %464 = getelementptr inbounds i8, ptr %350, i64 %444
  %465 = load <8 x double>, ptr %464, align 8
  %466 = fmul <8 x double> %465, %463
  %467 = getelementptr inbounds i8, ptr %339, i64 %444
  %468 = load <8 x double>, ptr %467, align 8
  %469 = fmul <8 x double> %468, %463
  %470 = fmul <8 x double> %466, %466
  %471 = fadd <8 x double> %441, %470
  %472 = fmul <8 x double> %469, %469
  %473 = fadd <8 x double> %442, %472
  %474 = add nuw nsw i64 %443, 1
  %475 = icmp eq i64 %474, %334
  br i1 %475, label %377, label %440, !llvm.loop !12

476:                                              ; preds = %433
  %477 = fmul <8 x double> %378, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %478 = fadd <8 x double> %477, %438
  %479 = sitofp i64 %334 to double
  %480 = insertelement <8 x double> poison, double %479, i64 0
  %481 = shufflevector <8 x double> %480, <8 x double> poison, <8 x i32> zeroinitializer
  %482 = fmul <8 x double> %481, %478
  %483 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %482)
  %484 = fdiv <8 x double> %438, %483
  %485 = fcmp oeq <8 x double> %438, zeroinitializer
  %486 = select <8 x i1> %485, <8 x double> zeroinitializer, <8 x double> %484
  br label %503

487:                                              ; preds = %433
  %488 = sitofp i64 %334 to double
  %489 = insertelement <8 x double> poison, double %488, i64 0
  %490 = shufflevector <8 x double> %489, <8 x double> poison, <8 x i32> zeroinitializer
  %491 = fdiv <8 x double> %438, %490
  %492 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %491)
  br label %503

493:                                              ; preds = %328, %493
  %494 = phi <8 x double> [ zeroinitializer, %328 ], [ %500, %493 ]
  %495 = phi i64 [ 0, %328 ], [ %501, %493 ]
  %496 = shl nsw i64 %495, 6
  %497 = getelementptr inbounds i8, ptr %329, i64 %496
  %498 = load <8 x double>, ptr %497, align 8
  %499 = fmul <8 x double> %498, zeroinitializer
  %500 = fadd <8 x double> %494, %499
  %501 = add nuw nsw i64 %495, 1
  %502 = icmp eq i64 %501, %13
  br i1 %502, label %503, label %493, !llvm.loop !13

503:                                              ; preds = %493, %327, %487, %476
  %504 = phi <8 x double> [ %486, %476 ], [ %492, %487 ], [ zeroinitializer, %327 ], [ %500, %493 ]
  %505 = fcmp uge <8 x double> %504, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %506 = trunc i64 %326 to i8
  %507 = bitcast i8 %506 to <8 x i1>
  %508 = select <8 x i1> %507, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %505
  %509 = xor <8 x i1> %508, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %510 = select <8 x i1> %509, <8 x i1> %184, <8 x i1> zeroinitializer
  %511 = sext <8 x i1> %510 to <8 x i64>
  br i1 %37, label %512, label %524

512:                                              ; preds = %503
  %513 = xor <8 x i1> %508, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %514 = select <8 x i1> %513, <8 x i1> %184, <8 x i1> zeroinitializer
  %515 = bitcast <8 x i1> %514 to i8
  %516 = icmp eq i8 %515, 0
  br i1 %516, label %524, label %517

517:                                              ; preds = %512
  %518 = zext i8 %515 to i64
  store <8 x double> %211, ptr %4, align 16
  %519 = load ptr, ptr %93, align 8
  %520 = call fastcc i64 @hold_lanes(ptr noundef nonnull %0, ptr noundef nonnull %4, ptr noundef %519, i64 noundef %518, i32 noundef %49) #10
  %521 = trunc nuw i64 %520 to i8
  %522 = bitcast i8 %521 to <8 x i1>
  %523 = select <8 x i1> %522, <8 x i64> zeroinitializer, <8 x i64> %511
  br label %524

524:                                              ; preds = %517, %512, %503
  %525 = phi i64 [ %520, %517 ], [ 0, %512 ], [ 0, %503 ]
  %526 = phi <8 x i64> [ %523, %517 ], [ %511, %512 ], [ %511, %503 ]
  %527 = icmp ne <8 x i64> %526, zeroinitializer
  %528 = bitcast <8 x i1> %527 to i8
  %529 = icmp ne i8 %528, 0
  %530 = select i1 %51, i1 %529, i1 false
  br i1 %530, label %531, label %550

531:                                              ; preds = %524
  %532 = load ptr, ptr %94, align 8
  %533 = load ptr, ptr %95, align 8
  store <8 x double> %211, ptr %533, align 8
  %534 = load i64, ptr %96, align 8
  %535 = icmp sgt i64 %534, 0
  br i1 %535, label %536, label %537

536:                                              ; preds = %531
  tail call fastcc void @sample(ptr noundef nonnull %7) #10
  br label %537

537:                                              ; preds = %531, %536
  %538 = load ptr, ptr %7, align 8
  %539 = load i64, ptr %538, align 8
  %540 = load ptr, ptr %95, align 8
  %541 = load ptr, ptr %97, align 8
  %542 = load ptr, ptr %98, align 8
  %543 = inttoptr i64 %539 to ptr
  %544 = tail call i32 %543(ptr noundef %540, ptr noundef %532, ptr noundef %541, ptr noundef %542, ptr noundef %52) #11
  %545 = zext i32 %544 to i64
  %546 = or i64 %326, %545
  %547 = trunc i64 %546 to i8
  %548 = bitcast i8 %547 to <8 x i1>
  %549 = select <8 x i1> %548, <8 x i64> zeroinitializer, <8 x i64> %526
  br label %550

550:                                              ; preds = %537, %524
  %551 = phi <8 x i64> [ %549, %537 ], [ %526, %524 ]
  %552 = phi i64 [ %546, %537 ], [ %326, %524 ]
  %553 = load ptr, ptr %99, align 8
  %554 = load <8 x double>, ptr %553, align 8
  %555 = load i64, ptr %14, align 8
  %556 = add i64 %555, %100
  %557 = sitofp i64 %556 to double
  %558 = insertelement <8 x double> poison, double %557, i64 0
  %559 = shufflevector <8 x double> %558, <8 x double> poison, <8 x i32> zeroinitializer
  %560 = icmp slt <8 x i64> %526, zeroinitializer
  %561 = select <8 x i1> %560, <8 x i64> %104, <8 x i64> zeroinitializer
  %562 = bitcast <8 x i64> %561 to <8 x double>
  %563 = fadd <8 x double> %559, %562
  %564 = fadd <8 x double> %554, %563
  store <8 x double> %564, ptr %553, align 8
  %565 = load ptr, ptr %105, align 8
  %566 = load <8 x double>, ptr %565, align 8
  %567 = fcmp olt <8 x double> %566, %211
  %568 = select <8 x i1> %567, <8 x i64> %551, <8 x i64> zeroinitializer
  %569 = icmp ne <8 x i64> %568, zeroinitializer
  %570 = bitcast <8 x i1> %569 to i8
  %571 = zext i8 %570 to i64
  %572 = icmp eq i8 %570, 0
  br i1 %572, label %818, label %573

573:                                              ; preds = %550
  %574 = load ptr, ptr %0, align 8
  %575 = load ptr, ptr %7, align 8
  %576 = getelementptr inbounds i8, ptr %575, i64 16
  %577 = load i64, ptr %576, align 8
  %578 = load i64, ptr %574, align 8
  %579 = load i64, ptr %106, align 8
  %580 = load ptr, ptr %78, align 8
  %581 = mul nsw i64 %579, %578
  %582 = getelementptr inbounds double, ptr %580, i64 %581
  %583 = load ptr, ptr %107, align 8
  %584 = add nsw i64 %578, 1
  %585 = getelementptr inbounds i8, ptr %574, i64 16
  %586 = load i64, ptr %585, align 8
  %587 = icmp sgt i64 %586, 0
  br i1 %587, label %588, label %590

588:                                              ; preds = %573
  %589 = getelementptr inbounds i8, ptr %574, i64 8
  br label %601

590:                                              ; preds = %636, %573
  %591 = phi i64 [ 0, %573 ], [ %645, %636 ]
  %592 = getelementptr inbounds i8, ptr %574, i64 16
  %593 = load ptr, ptr %7, align 8
  %594 = getelementptr inbounds i8, ptr %593, i64 8
  %595 = load i64, ptr %594, align 8
  %596 = icmp sgt i64 %595, 0
  br i1 %596, label %597, label %650

597:                                              ; preds = %590
  %598 = getelementptr inbounds double, ptr %583, i64 %579
  %599 = shl nsw i64 %579, 4
  %600 = getelementptr inbounds i8, ptr %583, i64 %599
  br label %657

601:                                              ; preds = %588, %636
  %602 = phi i64 [ 0, %588 ], [ %645, %636 ]
  %603 = phi i64 [ %584, %588 ], [ %646, %636 ]
  %604 = load i64, ptr %589, align 8
  %605 = load ptr, ptr %108, align 8
  %606 = load ptr, ptr %9, align 8
  %607 = load ptr, ptr %77, align 8
  %608 = getelementptr i64, ptr %607, i64 %603
  %609 = getelementptr i64, ptr %608, i64 %604
  %610 = load i64, ptr %609, align 8
  %611 = getelementptr i8, ptr %609, i64 8
  %612 = load i64, ptr %611, align 8
  %613 = xor i64 %610, -1
  %614 = add i64 %612, %613
  %615 = load ptr, ptr %64, align 8
  %616 = load ptr, ptr %78, align 8
  %617 = load ptr, ptr %79, align 8
  %618 = getelementptr inbounds i64, ptr %617, i64 %610
  %619 = load ptr, ptr %80, align 8
  %620 = getelementptr inbounds double, ptr %619, i64 %610
  tail call fastcc void @combine(ptr noundef %605, ptr noundef %606, ptr noundef %615, ptr noundef %616, ptr noundef %618, ptr noundef %620, i64 noundef %614, i64 noundef %577) #10
  %621 = load ptr, ptr %78, align 8
  %622 = mul nsw i64 %603, %579
  %623 = getelementptr inbounds double, ptr %621, i64 %622
  %624 = load ptr, ptr %109, align 8
  %625 = getelementptr inbounds double, ptr %624, i64 %603
  %626 = load double, ptr %625, align 8
  %627 = insertelement <8 x double> poison, double %626, i64 0
  %628 = shufflevector <8 x double> %627, <8 x double> poison, <8 x i32> zeroinitializer
  %629 = fmul <8 x double> %212, %628
  %630 = fadd <8 x double> %186, %629
  %631 = load ptr, ptr %108, align 8
  %632 = load ptr, ptr %110, align 8
  store <8 x double> %630, ptr %632, align 8
  %633 = load i64, ptr %111, align 8
  %634 = icmp sgt i64 %633, 0
  br i1 %634, label %635, label %636

635:                                              ; preds = %601
  tail call fastcc void @sample(ptr noundef nonnull %7) #10
  br label %636

636:                                              ; preds = %601, %635
  %637 = load ptr, ptr %7, align 8
  %638 = load i64, ptr %637, align 8
  %639 = load ptr, ptr %110, align 8
  %640 = load ptr, ptr %112, align 8
  %641 = load ptr, ptr %113, align 8
  %642 = inttoptr i64 %638 to ptr
  %643 = tail call i32 %642(ptr noundef %639, ptr noundef %631, ptr noundef %640, ptr noundef %641, ptr noundef %623) #11
  %644 = zext i32 %643 to i64
  %645 = or i64 %602, %644
  %646 = add nsw i64 %603, 1
  %647 = load i64, ptr %585, align 8
  %648 = add nsw i64 %647, %584
  %649 = icmp slt i64 %646, %648
  br i1 %649, label %601, label %590, !llvm.loop !14

650:                                              ; preds = %657, %590
  %651 = getelementptr inbounds i8, ptr %574, i64 8
  %652 = load i64, ptr %651, align 8
  %653 = load i64, ptr %592, align 8
  %654 = getelementptr inbounds i8, ptr %574, i64 24
  %655 = load i64, ptr %654, align 8
  %656 = icmp sgt i64 %655, 3
  br i1 %656, label %685, label %710

657:                                              ; preds = %597, %657
  %658 = phi i64 [ 0, %597 ], [ %680, %657 ]
  %659 = load ptr, ptr %76, align 8
  %660 = shl nsw i64 %658, 6
  %661 = getelementptr inbounds i8, ptr %659, i64 %660
  %662 = load <8 x double>, ptr %661, align 8
  %663 = load ptr, ptr %9, align 8
  %664 = getelementptr inbounds i8, ptr %663, i64 %660
  %665 = load <8 x double>, ptr %664, align 8
  %666 = fsub <8 x double> %662, %665
  %667 = load ptr, ptr %78, align 8
  %668 = getelementptr inbounds i8, ptr %667, i64 %660
  %669 = load <8 x double>, ptr %668, align 8
  %670 = fmul <8 x double> %212, %669
  %671 = fsub <8 x double> %670, %666
  %672 = getelementptr inbounds i8, ptr %583, i64 %660
  store <8 x double> %666, ptr %672, align 8
  %673 = getelementptr inbounds i8, ptr %598, i64 %660
  store <8 x double> %671, ptr %673, align 8
  %674 = fsub <8 x double> %666, %671
  %675 = getelementptr inbounds i8, ptr %582, i64 %660
  %676 = load <8 x double>, ptr %675, align 8
  %677 = fmul <8 x double> %212, %676
  %678 = fsub <8 x double> %674, %677
  %679 = getelementptr inbounds i8, ptr %600, i64 %660
  store <8 x double> %678, ptr %679, align 8
  %680 = add nuw nsw i64 %658, 1
  %681 = load ptr, ptr %7, align 8
  %682 = getelementptr inbounds i8, ptr %681, i64 8
  %683 = load i64, ptr %682, align 8
  %684 = icmp slt i64 %680, %683
  br i1 %684, label %657, label %650, !llvm.loop !15

685:                                              ; preds = %650, %685
  %686 = phi i64 [ %707, %685 ], [ 3, %650 ]
  %687 = mul nsw i64 %686, %579
  %688 = getelementptr inbounds double, ptr %583, i64 %687
  %689 = load ptr, ptr %114, align 8
  %690 = load ptr, ptr %77, align 8
  %691 = getelementptr i64, ptr %690, i64 %584
  %692 = getelementptr i64, ptr %691, i64 %652
  %693 = getelementptr i64, ptr %692, i64 %653
  %694 = getelementptr i64, ptr %693, i64 %686
  %695 = getelementptr i8, ptr %694, i64 -24
  %696 = load i64, ptr %695, align 8
  %697 = getelementptr i8, ptr %694, i64 -16
  %698 = load i64, ptr %697, align 8
  %699 = xor i64 %696, -1
  %700 = add i64 %698, %699
  %701 = load ptr, ptr %64, align 8
  %702 = load ptr, ptr %78, align 8
  %703 = load ptr, ptr %79, align 8
  %704 = getelementptr inbounds i64, ptr %703, i64 %696
  %705 = load ptr, ptr %80, align 8
  %706 = getelementptr inbounds double, ptr %705, i64 %696
  tail call fastcc void @combine(ptr noundef %688, ptr noundef %689, ptr noundef %701, ptr noundef %702, ptr noundef %704, ptr noundef %706, i64 noundef %700, i64 noundef %577) #10
  %707 = add nuw nsw i64 %686, 1
  %708 = load i64, ptr %654, align 8
  %709 = icmp slt i64 %707, %708
  br i1 %709, label %685, label %710, !llvm.loop !16

710:                                              ; preds = %685, %650
  %711 = and i64 %591, %571
  %712 = load ptr, ptr %99, align 8
  %713 = load <8 x double>, ptr %712, align 8
  %714 = load i64, ptr %115, align 8
  %715 = sitofp i64 %714 to double
  %716 = insertelement <8 x double> poison, double %715, i64 0
  %717 = bitcast <8 x double> %716 to <8 x i64>
  %718 = shufflevector <8 x i64> %717, <8 x i64> poison, <8 x i32> zeroinitializer
  %719 = icmp slt <8 x i64> %568, zeroinitializer
  %720 = select <8 x i1> %719, <8 x i64> %718, <8 x i64> zeroinitializer
  %721 = bitcast <8 x i64> %720 to <8 x double>
  %722 = fadd <8 x double> %713, %721
  store <8 x double> %722, ptr %712, align 8
  %723 = icmp eq i64 %711, 0
  br i1 %723, label %731, label %724

724:                                              ; preds = %710
  tail call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %711, i64 noundef 3) #10
  %725 = xor i64 %711, -1
  %726 = and i64 %182, %725
  store i64 %726, ptr %5, align 8
  %727 = trunc i64 %726 to i8
  %728 = bitcast i8 %727 to <8 x i1>
  %729 = select <8 x i1> %728, <8 x i64> %551, <8 x i64> zeroinitializer
  %730 = select <8 x i1> %728, <8 x i64> %568, <8 x i64> zeroinitializer
  br label %731

731:                                              ; preds = %724, %710
  %732 = phi <8 x i64> [ %730, %724 ], [ %568, %710 ]
  %733 = phi <8 x i64> [ %729, %724 ], [ %551, %710 ]
  %734 = phi i32 [ 1, %724 ], [ %175, %710 ]
  %735 = icmp ne <8 x i64> %732, zeroinitializer
  %736 = bitcast <8 x i1> %735 to i8
  %737 = load ptr, ptr %47, align 8
  %738 = load <8 x double>, ptr %737, align 8
  %739 = load ptr, ptr %64, align 8
  %740 = load <8 x double>, ptr %739, align 8
  %741 = load ptr, ptr %116, align 8
  %742 = load <8 x double>, ptr %741, align 8
  %743 = load ptr, ptr %105, align 8
  %744 = load <8 x double>, ptr %743, align 8
  %745 = load ptr, ptr %117, align 8
  %746 = load ptr, ptr %118, align 8
  br label %751

747:                                              ; preds = %751
  %748 = icmp eq i8 %736, 0
  br i1 %748, label %758, label %749

749:                                              ; preds = %747
  %750 = zext i8 %736 to i64
  br label %761

751:                                              ; preds = %731, %751
  %752 = phi i64 [ 0, %731 ], [ %756, %751 ]
  %753 = getelementptr inbounds i64, ptr %746, i64 %752
  %754 = load i64, ptr %753, align 8
  %755 = getelementptr inbounds [8 x i64], ptr %2, i64 0, i64 %752
  store i64 %754, ptr %755, align 8
  %756 = add nuw nsw i64 %752, 1
  %757 = icmp eq i64 %756, 8
  br i1 %757, label %747, label %751, !llvm.loop !17

758:                                              ; preds = %785, %747
  %759 = phi i64 [ 0, %747 ], [ %786, %785 ]
  %760 = icmp eq i64 %759, 0
  br i1 %760, label %813, label %797

761:                                              ; preds = %749, %785
  %762 = phi i64 [ %786, %785 ], [ 0, %749 ]
  %763 = phi i64 [ %795, %785 ], [ %750, %749 ]
  %764 = load ptr, ptr %105, align 8
  %765 = load <8 x double>, ptr %764, align 8
  %766 = fsub <8 x double> %765, %738
  %767 = fdiv <8 x double> %766, %740
  %768 = load ptr, ptr %119, align 8
  store <8 x double> %767, ptr %768, align 8
  %769 = load ptr, ptr %9, align 8
  %770 = load ptr, ptr %107, align 8
  %771 = load i64, ptr %106, align 8
  %772 = load ptr, ptr %0, align 8
  %773 = getelementptr inbounds i8, ptr %772, i64 24
  %774 = load i64, ptr %773, align 8
  %775 = load ptr, ptr %119, align 8
  %776 = load ptr, ptr %7, align 8
  %777 = getelementptr inbounds i8, ptr %776, i64 16
  %778 = load i64, ptr %777, align 8
  tail call fastcc void @nested(ptr noundef %745, ptr noundef %769, ptr noundef %770, i64 noundef %771, i64 noundef %774, ptr noundef %775, i64 noundef %778) #10
  %779 = load i64, ptr %35, align 8
  %780 = icmp sgt i64 %779, 0
  br i1 %780, label %781, label %785

781:                                              ; preds = %761
  %782 = load ptr, ptr %105, align 8
  %783 = tail call fastcc i64 @hold_lanes(ptr noundef nonnull %0, ptr noundef %782, ptr noundef %745, i64 noundef %763, i32 noundef 0) #10
  %784 = or i64 %783, %762
  br label %785

785:                                              ; preds = %781, %761
  %786 = phi i64 [ %784, %781 ], [ %762, %761 ]
  %787 = xor i64 %786, -1
  %788 = and i64 %763, %787
  tail call fastcc void @write_outputs(ptr noundef nonnull %0, ptr noundef %745, i64 noundef %788) #10
  %789 = load ptr, ptr %105, align 8
  %790 = load <8 x double>, ptr %789, align 8
  %791 = fcmp olt <8 x double> %790, %211
  %792 = bitcast <8 x i1> %791 to i8
  %793 = zext i8 %792 to i64
  %794 = and i64 %787, %793
  %795 = and i64 %794, %763
  %796 = icmp eq i64 %795, 0
  br i1 %796, label %758, label %761, !llvm.loop !19

797:                                              ; preds = %758, %797
  %798 = phi i64 [ %811, %797 ], [ %759, %758 ]
  %799 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %798, i1 true)
  %800 = extractelement <8 x double> %742, i64 %799
  %801 = load ptr, ptr %116, align 8
  %802 = getelementptr inbounds double, ptr %801, i64 %799
  store double %800, ptr %802, align 8
  %803 = extractelement <8 x double> %744, i64 %799
  %804 = load ptr, ptr %105, align 8
  %805 = getelementptr inbounds double, ptr %804, i64 %799
  store double %803, ptr %805, align 8
  %806 = getelementptr inbounds [8 x i64], ptr %2, i64 0, i64 %799
  %807 = load i64, ptr %806, align 8
  %808 = load ptr, ptr %120, align 8
  %809 = getelementptr inbounds i64, ptr %808, i64 %799
  store i64 %807, ptr %809, align 8
  %810 = add nsw i64 %798, -1
  %811 = and i64 %810, %798
  %812 = icmp eq i64 %811, 0
  br i1 %812, label %813, label %797, !llvm.loop !20

813:                                              ; preds = %797, %758
  %814 = or i64 %759, %525
  %815 = trunc nuw i64 %759 to i8
  %816 = bitcast i8 %815 to <8 x i1>
  %817 = select <8 x i1> %816, <8 x i64> zeroinitializer, <8 x i64> %733
  br label %818

818:                                              ; preds = %813, %550
  %819 = phi i64 [ %525, %550 ], [ %814, %813 ]
  %820 = phi <8 x i64> [ %551, %550 ], [ %817, %813 ]
  %821 = phi i32 [ %175, %550 ], [ %734, %813 ]
  %822 = load ptr, ptr %105, align 8
  %823 = load <8 x double>, ptr %822, align 8
  %824 = fcmp oeq <8 x double> %823, %211
  %825 = icmp ne <8 x i64> %820, zeroinitializer
  %826 = select <8 x i1> %824, <8 x i1> %825, <8 x i1> zeroinitializer
  %827 = bitcast <8 x i1> %826 to i8
  %828 = icmp eq i8 %827, 0
  br i1 %828, label %831, label %829

829:                                              ; preds = %818
  %830 = zext i8 %827 to i64
  br label %840

831:                                              ; preds = %840, %818
  %832 = xor <8 x i64> %820, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %833 = select <8 x i1> %184, <8 x i64> %832, <8 x i64> zeroinitializer
  %834 = load ptr, ptr %60, align 8
  %835 = load <8 x double>, ptr %834, align 8
  %836 = icmp slt <8 x i64> %820, zeroinitializer
  %837 = select <8 x i1> %836, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %838 = bitcast <8 x i64> %837 to <8 x double>
  %839 = fadd <8 x double> %835, %838
  store <8 x double> %839, ptr %834, align 8
  br i1 %32, label %850, label %974

840:                                              ; preds = %829, %840
  %841 = phi i64 [ %848, %840 ], [ %830, %829 ]
  %842 = load ptr, ptr %121, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %842, i64 noundef %841) #10
  %843 = load ptr, ptr %105, align 8
  %844 = load <8 x double>, ptr %843, align 8
  %845 = fcmp oeq <8 x double> %844, %211
  %846 = bitcast <8 x i1> %845 to i8
  %847 = zext i8 %846 to i64
  %848 = and i64 %841, %847
  %849 = icmp eq i64 %848, 0
  br i1 %849, label %831, label %840, !llvm.loop !21

850:                                              ; preds = %831
  %851 = load ptr, ptr %122, align 8
  %852 = load <8 x double>, ptr %851, align 8
  %853 = load ptr, ptr %123, align 8
  %854 = load <8 x double>, ptr %853, align 8
  %855 = fcmp ogt <8 x double> %504, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %856 = bitcast <8 x double> %504 to <8 x i64>
  %857 = select <8 x i1> %855, <8 x i64> %856, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %858 = load double, ptr %124, align 8
  %859 = insertelement <8 x double> poison, double %858, i64 0
  %860 = shufflevector <8 x double> %859, <8 x double> poison, <8 x i32> zeroinitializer
  %861 = load double, ptr %125, align 8
  %862 = fneg double %861
  %863 = add <8 x i64> %857, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %864 = ashr <8 x i64> %863, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %865 = and <8 x i64> %863, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %866 = sub <8 x i64> %857, %865
  %867 = bitcast <8 x i64> %866 to <8 x double>
  %868 = fadd <8 x double> %867, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %869 = fadd <8 x double> %867, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %870 = fdiv <8 x double> %868, %869
  %871 = fmul <8 x double> %870, %870
  %872 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %871, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %873 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %872, <8 x double> %871, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %874 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %873, <8 x double> %871, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %875 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %874, <8 x double> %871, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %876 = trunc nsw <8 x i64> %864 to <8 x i32>
  %877 = sitofp <8 x i32> %876 to <8 x double>
  %878 = fmul <8 x double> %870, %875
  %879 = fadd <8 x double> %878, %877
  %880 = insertelement <8 x double> poison, double %862, i64 0
  %881 = shufflevector <8 x double> %880, <8 x double> poison, <8 x i32> zeroinitializer
  %882 = fmul <8 x double> %879, %881
  %883 = fcmp ogt <8 x double> %882, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %884 = bitcast <8 x double> %882 to <8 x i64>
  %885 = select <8 x i1> %883, <8 x i64> %884, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %886 = bitcast <8 x i64> %885 to <8 x double>
  %887 = fcmp olt <8 x double> %886, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %888 = bitcast <8 x i64> %885 to <8 x double>
  %889 = select <8 x i1> %887, <8 x double> %888, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %890 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %889)
  %891 = fsub <8 x double> %889, %890
  %892 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %891, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %893 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %892, <8 x double> %891, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %894 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %893, <8 x double> %891, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %895 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %894, <8 x double> %891, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %896 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %895, <8 x double> %891, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %897 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %896, <8 x double> %891, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %898 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %897, <8 x double> %891, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %899 = bitcast <8 x double> %898 to <8 x i64>
  %900 = fptosi <8 x double> %890 to <8 x i32>
  %901 = zext <8 x i32> %900 to <8 x i64>
  %902 = shl <8 x i64> %901, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %903 = add <8 x i64> %902, %899
  %904 = bitcast <8 x i64> %903 to <8 x double>
  %905 = fmul <8 x double> %860, %904
  %906 = load double, ptr %126, align 8
  %907 = fcmp une double %906, 0.000000e+00
  br i1 %907, label %908, label %953

908:                                              ; preds = %850
  %909 = bitcast <8 x double> %852 to <8 x i64>
  %910 = add <8 x i64> %909, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %911 = ashr <8 x i64> %910, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %912 = and <8 x i64> %910, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %913 = sub <8 x i64> %909, %912
  %914 = bitcast <8 x i64> %913 to <8 x double>
  %915 = fadd <8 x double> %914, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %916 = fadd <8 x double> %914, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %917 = fdiv <8 x double> %915, %916
  %918 = fmul <8 x double> %917, %917
  %919 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %918, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %920 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %919, <8 x double> %918, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %921 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %920, <8 x double> %918, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %922 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %921, <8 x double> %918, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %923 = trunc nsw <8 x i64> %911 to <8 x i32>
  %924 = sitofp <8 x i32> %923 to <8 x double>
  %925 = fmul <8 x double> %917, %922
  %926 = fadd <8 x double> %925, %924
  %927 = insertelement <8 x double> poison, double %906, i64 0
  %928 = shufflevector <8 x double> %927, <8 x double> poison, <8 x i32> zeroinitializer
  %929 = fmul <8 x double> %928, %926
  %930 = fcmp ogt <8 x double> %929, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %931 = bitcast <8 x double> %929 to <8 x i64>
  %932 = select <8 x i1> %930, <8 x i64> %931, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %933 = bitcast <8 x i64> %932 to <8 x double>
  %934 = fcmp olt <8 x double> %933, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %935 = bitcast <8 x i64> %932 to <8 x double>
  %936 = select <8 x i1> %934, <8 x double> %935, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %937 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %936)
  %938 = fsub <8 x double> %936, %937
  %939 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %938, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %940 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %939, <8 x double> %938, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %941 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %940, <8 x double> %938, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %942 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %941, <8 x double> %938, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %943 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %942, <8 x double> %938, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %944 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %943, <8 x double> %938, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %945 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %944, <8 x double> %938, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %946 = bitcast <8 x double> %945 to <8 x i64>
  %947 = fptosi <8 x double> %937 to <8 x i32>
  %948 = zext <8 x i32> %947 to <8 x i64>
  %949 = shl <8 x i64> %948, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %950 = add <8 x i64> %949, %946
  %951 = bitcast <8 x i64> %950 to <8 x double>
  %952 = fmul <8 x double> %905, %951
  br label %953

953:                                              ; preds = %850, %908
  %954 = phi <8 x double> [ %952, %908 ], [ %905, %850 ]
  %955 = load double, ptr %127, align 8
  %956 = insertelement <8 x double> poison, double %955, i64 0
  %957 = shufflevector <8 x double> %956, <8 x double> poison, <8 x i32> zeroinitializer
  %958 = fcmp ogt <8 x double> %954, %957
  %959 = select <8 x i1> %958, <8 x double> %954, <8 x double> %957
  %960 = fcmp olt <8 x double> %854, %959
  %961 = select <8 x i1> %960, <8 x double> %854, <8 x double> %959
  %962 = fmul <8 x double> %212, %961
  %963 = fcmp ogt <8 x double> %504, <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>
  %964 = select <8 x i1> %963, <8 x i64> %856, <8 x i64> <i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789>
  %965 = bitcast <8 x double> %852 to <8 x i64>
  %966 = select <8 x i1> %836, <8 x i64> %964, <8 x i64> %965
  store <8 x i64> %966, ptr %851, align 8
  %967 = load ptr, ptr %123, align 8
  %968 = load double, ptr %128, align 8
  %969 = insertelement <8 x double> poison, double %968, i64 0
  %970 = bitcast <8 x double> %969 to <8 x i64>
  %971 = shufflevector <8 x i64> %970, <8 x i64> poison, <8 x i32> zeroinitializer
  %972 = icmp slt <8 x i64> %833, zeroinitializer
  %973 = select <8 x i1> %972, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> %971
  store <8 x i64> %973, ptr %967, align 8
  br label %974

974:                                              ; preds = %953, %831
  %975 = phi <8 x double> [ %962, %953 ], [ %193, %831 ]
  %976 = icmp ne <8 x i64> %833, zeroinitializer
  %977 = bitcast <8 x i1> %976 to i8
  %978 = icmp eq i8 %977, 0
  br i1 %978, label %1065, label %979

979:                                              ; preds = %974
  %980 = trunc i64 %552 to i8
  %981 = bitcast i8 %980 to <8 x i1>
  %982 = trunc nuw i64 %819 to i8
  %983 = bitcast i8 %982 to <8 x i1>
  %984 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %504)
  %985 = fcmp ueq <8 x double> %984, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %986 = select <8 x i1> %985, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %981
  %987 = or <8 x i1> %986, %983
  br i1 %32, label %988, label %1047

988:                                              ; preds = %979
  %989 = fcmp ogt <8 x double> %504, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %990 = bitcast <8 x double> %504 to <8 x i64>
  %991 = select <8 x i1> %989, <8 x i64> %990, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %992 = load double, ptr %129, align 8
  %993 = insertelement <8 x double> poison, double %992, i64 0
  %994 = shufflevector <8 x double> %993, <8 x double> poison, <8 x i32> zeroinitializer
  %995 = load double, ptr %29, align 8
  %996 = fneg double %995
  %997 = add <8 x i64> %991, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %998 = ashr <8 x i64> %997, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %999 = and <8 x i64> %997, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %1000 = sub <8 x i64> %991, %999
  %1001 = bitcast <8 x i64> %1000 to <8 x double>
  %1002 = fadd <8 x double> %1001, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %1003 = fadd <8 x double> %1001, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1004 = fdiv <8 x double> %1002, %1003
  %1005 = fmul <8 x double> %1004, %1004
  %1006 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1005, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %1007 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1006, <8 x double> %1005, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %1008 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1007, <8 x double> %1005, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %1009 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1008, <8 x double> %1005, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %1010 = trunc nsw <8 x i64> %998 to <8 x i32>
  %1011 = sitofp <8 x i32> %1010 to <8 x double>
  %1012 = fmul <8 x double> %1004, %1009
  %1013 = fadd <8 x double> %1012, %1011
  %1014 = insertelement <8 x double> poison, double %996, i64 0
  %1015 = shufflevector <8 x double> %1014, <8 x double> poison, <8 x i32> zeroinitializer
  %1016 = fmul <8 x double> %1013, %1015
  %1017 = fcmp ogt <8 x double> %1016, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1018 = bitcast <8 x double> %1016 to <8 x i64>
  %1019 = select <8 x i1> %1017, <8 x i64> %1018, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1020 = bitcast <8 x i64> %1019 to <8 x double>
  %1021 = fcmp olt <8 x double> %1020, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1022 = bitcast <8 x i64> %1019 to <8 x double>
  %1023 = select <8 x i1> %1021, <8 x double> %1022, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1024 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %1023)
  %1025 = fsub <8 x double> %1023, %1024
  %1026 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1025, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1027 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1026, <8 x double> %1025, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1028 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1027, <8 x double> %1025, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1029 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1028, <8 x double> %1025, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1030 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1029, <8 x double> %1025, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1031 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1030, <8 x double> %1025, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1032 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %1031, <8 x double> %1025, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1033 = bitcast <8 x double> %1032 to <8 x i64>
  %1034 = fptosi <8 x double> %1024 to <8 x i32>
  %1035 = zext <8 x i32> %1034 to <8 x i64>
  %1036 = shl <8 x i64> %1035, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1037 = add <8 x i64> %1036, %1033
  %1038 = bitcast <8 x i64> %1037 to <8 x double>
  %1039 = fmul <8 x double> %994, %1038
  %1040 = load double, ptr %130, align 8
  %1041 = insertelement <8 x double> poison, double %1040, i64 0
  %1042 = shufflevector <8 x double> %1041, <8 x double> poison, <8 x i32> zeroinitializer
  %1043 = fcmp ogt <8 x double> %1039, %1042
  %1044 = select <8 x i1> %1043, <8 x double> %1039, <8 x double> %1042
  %1045 = select <8 x i1> %987, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>, <8 x double> %1044
  %1046 = fmul <8 x double> %212, %1045
  br label %1047

1047:                                             ; preds = %979, %988
  %1048 = phi <8 x double> [ %1046, %988 ], [ zeroinitializer, %979 ]
  %1049 = select <8 x i1> %987, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>
  %1050 = icmp slt <8 x i64> %833, zeroinitializer
  %1051 = select <8 x i1> %1050, <8 x double> %1048, <8 x double> %975
  %1052 = load ptr, ptr %131, align 8
  %1053 = select <8 x i1> %983, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> %1049
  %1054 = load <8 x i64>, ptr %1052, align 8
  %1055 = select <8 x i1> %1050, <8 x i64> %1053, <8 x i64> %1054
  store <8 x i64> %1055, ptr %1052, align 8
  %1056 = load ptr, ptr %131, align 8
  %1057 = select <8 x i1> %981, <8 x i64> <i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152>, <8 x i64> %1049
  %1058 = load <8 x i64>, ptr %1056, align 8
  %1059 = select <8 x i1> %1050, <8 x i64> %1057, <8 x i64> %1058
  store <8 x i64> %1059, ptr %1056, align 8
  %1060 = load ptr, ptr %61, align 8
  %1061 = load <8 x double>, ptr %1060, align 8
  %1062 = select <8 x i1> %1050, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %1063 = bitcast <8 x i64> %1062 to <8 x double>
  %1064 = fadd <8 x double> %1061, %1063
  store <8 x double> %1064, ptr %1060, align 8
  br label %1065

1065:                                             ; preds = %1047, %974
  %1066 = phi <8 x double> [ %975, %974 ], [ %1051, %1047 ]
  %1067 = load ptr, ptr %57, align 8
  store <8 x double> %1066, ptr %1067, align 8
  %1068 = load ptr, ptr %47, align 8
  %1069 = select <8 x i1> %836, <8 x double> %211, <8 x double> %186
  store <8 x double> %1069, ptr %1068, align 8
  br i1 %132, label %1078, label %1070

1070:                                             ; preds = %1078, %1065
  %1071 = load ptr, ptr %105, align 8
  %1072 = load <8 x double>, ptr %1071, align 8
  %1073 = fcmp oeq <8 x double> %1072, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1074 = icmp ne <8 x i64> %820, zeroinitializer
  %1075 = select <8 x i1> %1073, <8 x i1> %1074, <8 x i1> zeroinitializer
  %1076 = bitcast <8 x i1> %1075 to i8
  %1077 = icmp eq i8 %1076, 0
  br i1 %1077, label %172, label %1096

1078:                                             ; preds = %1065, %1078
  %1079 = phi i64 [ %1094, %1078 ], [ 0, %1065 ]
  %1080 = load ptr, ptr %9, align 8
  %1081 = load ptr, ptr %133, align 8
  %1082 = shl nsw i64 %1079, 6
  %1083 = getelementptr inbounds i8, ptr %1081, i64 %1082
  %1084 = load <8 x i64>, ptr %1083, align 8
  %1085 = getelementptr inbounds i8, ptr %1080, i64 %1082
  %1086 = load <8 x i64>, ptr %1085, align 8
  %1087 = select <8 x i1> %836, <8 x i64> %1084, <8 x i64> %1086
  store <8 x i64> %1087, ptr %1085, align 8
  %1088 = load ptr, ptr %38, align 8
  %1089 = getelementptr inbounds i8, ptr %52, i64 %1082
  %1090 = load <8 x i64>, ptr %1089, align 8
  %1091 = getelementptr inbounds i8, ptr %1088, i64 %1082
  %1092 = load <8 x i64>, ptr %1091, align 8
  %1093 = select <8 x i1> %836, <8 x i64> %1090, <8 x i64> %1092
  store <8 x i64> %1093, ptr %1091, align 8
  %1094 = add nuw nsw i64 %1079, 1
  %1095 = icmp eq i64 %1094, %13
  br i1 %1095, label %1070, label %1078, !llvm.loop !22

1096:                                             ; preds = %1070
  %1097 = zext i8 %1076 to i64
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %1097, i64 noundef 0) #10
  br label %172

1098:                                             ; preds = %174, %169
  %1099 = phi i64 [ 1, %169 ], [ 0, %174 ]
  ret i64 %1099
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

define internal fastcc range(i64 0, 256) i64 @hold_lanes(ptr noundef readonly %0, ptr noundef readonly %1, ptr noundef %2, i64 noundef %3, i32 noundef %4) unnamed_addr #2 {
  %6 = getelementptr inbounds i8, ptr %0, i64 1152
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
  %40 = tail call i64 %36(ptr noundef %26, double noundef %38, ptr noundef %7, ptr noundef %39) #11
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
  br i1 %58, label %31, label %46, !llvm.loop !39

59:                                               ; preds = %63, %31
  %60 = add nsw i64 %21, -1
  %61 = and i64 %60, %21
  %62 = icmp eq i64 %61, 0
  br i1 %62, label %29, label %19, !llvm.loop !40

63:                                               ; preds = %31, %63
  %64 = phi i64 [ %69, %63 ], [ 0, %31 ]
  %65 = getelementptr inbounds double, ptr %7, i64 %64
  %66 = load double, ptr %65, align 8
  %67 = shl nsw i64 %64, 6
  %68 = getelementptr inbounds i8, ptr %45, i64 %67
  store double %66, ptr %68, align 8
  %69 = add nuw nsw i64 %64, 1
  %70 = icmp eq i64 %69, %11
  br i1 %70, label %59, label %63, !llvm.loop !41
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
