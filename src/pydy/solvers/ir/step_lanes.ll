; sources 6679f04aa8fe3d915ca5afcdf91e46f2e94d7c793d32eaf6106a0e4faec0228c
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

@scan_points = internal unnamed_addr constant [5 x double] [double 0.000000e+00, double 0x3FCE3779B97F4A7C, double 0x3FDCC470A0490974, double 0x3FE76CF5D0B09954, double 1.000000e+00], align 16

define noundef i64 @step_lanes(ptr noundef %0) #0 {
  %2 = alloca [8 x double], align 16
  %3 = alloca [8 x double], align 16
  %4 = alloca [64 x double], align 16
  %5 = alloca [64 x double], align 16
  %6 = alloca %struct.Stepper, align 8
  %7 = alloca [8 x double], align 16
  %8 = alloca [8 x double], align 16
  %9 = alloca [8 x double], align 16
  %10 = alloca i64, align 8
  %11 = alloca [8 x i64], align 16
  %12 = alloca i64, align 8
  store ptr %0, ptr %6, align 8
  %13 = getelementptr inbounds i8, ptr %6, i64 8
  %14 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %14, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %6, i64 16
  %16 = getelementptr inbounds i8, ptr %0, i64 432
  store ptr %16, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %0, i64 984
  %18 = load ptr, ptr %14, align 8
  %19 = getelementptr inbounds i8, ptr %18, i64 8
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr inbounds i8, ptr %0, i64 1032
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr inbounds i8, ptr %0, i64 1040
  %24 = load i64, ptr %23, align 8
  %25 = getelementptr double, ptr %22, i64 %24
  %26 = getelementptr i8, ptr %25, i64 -16
  %27 = load double, ptr %26, align 8
  %28 = getelementptr inbounds i8, ptr %0, i64 1008
  %29 = load ptr, ptr %28, align 8
  %30 = load double, ptr %29, align 8
  %31 = load ptr, ptr %17, align 8
  %32 = getelementptr inbounds i8, ptr %31, i64 16
  %33 = load i64, ptr %32, align 8
  %34 = load ptr, ptr %0, align 8
  %35 = getelementptr inbounds i8, ptr %34, i64 8
  %36 = load i64, ptr %35, align 8
  %37 = icmp sgt i64 %36, 0
  %38 = getelementptr inbounds i8, ptr %0, i64 1680
  %39 = load ptr, ptr %38, align 8
  %40 = load i64, ptr %39, align 8
  %41 = getelementptr inbounds i8, ptr %0, i64 1272
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds i8, ptr %42, i64 8
  %44 = load i64, ptr %43, align 8
  store i64 0, ptr %10, align 8
  %45 = getelementptr inbounds i8, ptr %0, i64 936
  %46 = load ptr, ptr %45, align 8
  br label %131

47:                                               ; preds = %131
  %48 = getelementptr inbounds i8, ptr %0, i64 696
  %49 = sitofp i64 %33 to double
  %50 = zext i1 %37 to i32
  %51 = icmp eq i64 %40, 1
  %52 = icmp sgt i64 %44, 0
  store i64 %139, ptr %10, align 8
  %53 = getelementptr inbounds i8, ptr %0, i64 936
  %54 = getelementptr inbounds i8, ptr %0, i64 1592
  %55 = getelementptr inbounds i8, ptr %0, i64 1224
  %56 = getelementptr inbounds i8, ptr %0, i64 816
  %57 = insertelement <8 x double> poison, double %27, i64 0
  %58 = shufflevector <8 x double> %57, <8 x double> poison, <8 x i32> zeroinitializer
  %59 = getelementptr inbounds i8, ptr %0, i64 720
  %60 = getelementptr inbounds i8, ptr %0, i64 720
  %61 = insertelement <8 x double> poison, double %30, i64 0
  %62 = shufflevector <8 x double> %61, <8 x double> poison, <8 x i32> zeroinitializer
  %63 = getelementptr inbounds i8, ptr %0, i64 840
  %64 = getelementptr inbounds i8, ptr %0, i64 864
  %65 = insertelement <8 x double> poison, double %49, i64 0
  %66 = shufflevector <8 x double> %65, <8 x double> poison, <8 x i32> zeroinitializer
  %67 = load ptr, ptr %15, align 8
  %68 = load ptr, ptr %6, align 8
  %69 = load ptr, ptr %13, align 8
  %70 = getelementptr inbounds i8, ptr %67, i64 72
  %71 = getelementptr inbounds i8, ptr %67, i64 48
  %72 = getelementptr inbounds i8, ptr %68, i64 24
  %73 = getelementptr inbounds i8, ptr %67, i64 168
  %74 = getelementptr inbounds i8, ptr %68, i64 48
  %75 = getelementptr inbounds i8, ptr %68, i64 72
  %76 = getelementptr inbounds i8, ptr %67, i64 8
  %77 = getelementptr inbounds i8, ptr %68, i64 96
  %78 = getelementptr inbounds i8, ptr %69, i64 24
  %79 = getelementptr inbounds i8, ptr %69, i64 152
  %80 = getelementptr inbounds i8, ptr %69, i64 48
  %81 = getelementptr inbounds i8, ptr %69, i64 96
  %82 = getelementptr inbounds i8, ptr %67, i64 24
  %83 = getelementptr inbounds i8, ptr %68, i64 24
  %84 = getelementptr inbounds i8, ptr %67, i64 168
  %85 = getelementptr inbounds i8, ptr %68, i64 48
  %86 = getelementptr inbounds i8, ptr %68, i64 72
  %87 = getelementptr inbounds i8, ptr %67, i64 8
  %88 = getelementptr inbounds i8, ptr %69, i64 24
  %89 = getelementptr inbounds i8, ptr %69, i64 152
  %90 = getelementptr inbounds i8, ptr %69, i64 48
  %91 = getelementptr inbounds i8, ptr %69, i64 96
  %92 = getelementptr inbounds i8, ptr %67, i64 144
  %93 = getelementptr inbounds i8, ptr %67, i64 8
  %94 = getelementptr inbounds i8, ptr %67, i64 120
  %95 = getelementptr inbounds i8, ptr %67, i64 240
  %96 = getelementptr inbounds i8, ptr %67, i64 216
  %97 = getelementptr inbounds i8, ptr %67, i64 240
  %98 = getelementptr inbounds i8, ptr %67, i64 216
  %99 = getelementptr inbounds i8, ptr %0, i64 888
  %100 = getelementptr inbounds i8, ptr %0, i64 456
  %101 = getelementptr inbounds i8, ptr %67, i64 8
  %102 = getelementptr inbounds i8, ptr %69, i64 24
  %103 = getelementptr inbounds i8, ptr %69, i64 152
  %104 = getelementptr inbounds i8, ptr %69, i64 48
  %105 = getelementptr inbounds i8, ptr %69, i64 96
  %106 = getelementptr inbounds i8, ptr %0, i64 816
  %107 = getelementptr inbounds i8, ptr %67, i64 8
  %108 = getelementptr inbounds i8, ptr %67, i64 192
  %109 = getelementptr inbounds i8, ptr %67, i64 48
  %110 = getelementptr inbounds i8, ptr %68, i64 96
  %111 = getelementptr inbounds i8, ptr %69, i64 24
  %112 = getelementptr inbounds i8, ptr %69, i64 152
  %113 = getelementptr inbounds i8, ptr %69, i64 48
  %114 = getelementptr inbounds i8, ptr %69, i64 96
  %115 = getelementptr inbounds i8, ptr %67, i64 120
  %116 = getelementptr inbounds i8, ptr %0, i64 456
  %117 = getelementptr inbounds i8, ptr %0, i64 120
  %118 = getelementptr inbounds i8, ptr %0, i64 720
  %119 = getelementptr inbounds i8, ptr %0, i64 744
  %120 = getelementptr inbounds i8, ptr %0, i64 768
  %121 = getelementptr inbounds i8, ptr %0, i64 296
  %122 = getelementptr inbounds i8, ptr %0, i64 296
  %123 = getelementptr inbounds i8, ptr %0, i64 296
  %124 = getelementptr inbounds i8, ptr %0, i64 296
  %125 = getelementptr inbounds i8, ptr %0, i64 912
  %126 = icmp sgt i64 %20, 0
  %127 = getelementptr inbounds i8, ptr %0, i64 456
  %128 = getelementptr inbounds i8, ptr %0, i64 600
  %129 = getelementptr inbounds i8, ptr %0, i64 440
  %130 = icmp sgt i64 %20, 0
  br label %142

131:                                              ; preds = %1, %131
  %132 = phi i64 [ 0, %1 ], [ %140, %131 ]
  %133 = phi i64 [ 0, %1 ], [ %139, %131 ]
  %134 = getelementptr inbounds i64, ptr %46, i64 %132
  %135 = load i64, ptr %134, align 8
  %136 = icmp sgt i64 %135, -1
  %137 = zext i1 %136 to i64
  %138 = shl nuw nsw i64 %137, %132
  %139 = or i64 %138, %133
  %140 = add nuw nsw i64 %132, 1
  %141 = icmp eq i64 %140, 8
  br i1 %141, label %47, label %131, !llvm.loop !3

142:                                              ; preds = %177, %47
  %143 = phi i32 [ 1, %47 ], [ %178, %177 ]
  %144 = phi i64 [ 0, %47 ], [ %179, %177 ]
  %145 = icmp ne i32 %143, 0
  %146 = icmp ne i64 %144, 0
  %147 = select i1 %145, i1 true, i1 %146
  br i1 %147, label %148, label %180

148:                                              ; preds = %142
  br i1 %145, label %149, label %151

149:                                              ; preds = %148
  %150 = call fastcc i64 @fill(ptr noundef nonnull %0, ptr noundef nonnull %10) #12
  br label %151

151:                                              ; preds = %148, %149
  %152 = phi i64 [ %150, %149 ], [ 0, %148 ]
  %153 = load i64, ptr %10, align 8
  %154 = icmp eq i64 %153, 0
  br i1 %154, label %173, label %155

155:                                              ; preds = %151
  %156 = or i64 %152, %144
  %157 = icmp eq i64 %156, 0
  br i1 %157, label %173, label %158

158:                                              ; preds = %155
  call fastcc void @start(ptr noundef nonnull %0, ptr noundef nonnull %6, i64 noundef %152, i64 noundef %144) #12
  br label %159

159:                                              ; preds = %158, %168
  %160 = phi i32 [ 0, %158 ], [ %170, %168 ]
  %161 = phi i64 [ 0, %158 ], [ %171, %168 ]
  %162 = icmp eq i32 %160, 0
  br i1 %162, label %163, label %168

163:                                              ; preds = %159
  %164 = load ptr, ptr %53, align 8
  %165 = getelementptr inbounds i64, ptr %164, i64 %161
  %166 = load i64, ptr %165, align 8
  %167 = icmp eq i64 %166, -1
  br label %168

168:                                              ; preds = %163, %159
  %169 = phi i1 [ true, %159 ], [ %167, %163 ]
  %170 = zext i1 %169 to i32
  %171 = add nuw nsw i64 %161, 1
  %172 = icmp eq i64 %171, 8
  br i1 %172, label %173, label %159, !llvm.loop !6

173:                                              ; preds = %168, %155, %151
  %174 = phi i32 [ 1, %151 ], [ 8, %155 ], [ 0, %168 ]
  %175 = phi i32 [ %143, %151 ], [ 0, %155 ], [ %170, %168 ]
  %176 = phi i64 [ %144, %151 ], [ %144, %155 ], [ 0, %168 ]
  switch i32 %174, label %1457 [
    i32 0, label %177
    i32 8, label %180
  ]

177:                                              ; preds = %173, %1455, %260
  %178 = phi i32 [ %175, %173 ], [ %1456, %1455 ], [ 1, %260 ]
  %179 = phi i64 [ %176, %173 ], [ %1433, %1455 ], [ %182, %260 ]
  br label %142, !llvm.loop !7

180:                                              ; preds = %173, %142
  %181 = phi i32 [ %175, %173 ], [ 0, %142 ]
  %182 = phi i64 [ %176, %173 ], [ 0, %142 ]
  %183 = load ptr, ptr %17, align 8
  %184 = getelementptr inbounds i8, ptr %183, i64 8
  %185 = load i64, ptr %184, align 8
  %186 = icmp slt i64 %185, 1
  br i1 %186, label %1457, label %187

187:                                              ; preds = %180
  br i1 %52, label %188, label %208

188:                                              ; preds = %187
  %189 = load i64, ptr %54, align 8
  %190 = icmp sgt i64 %189, 0
  br i1 %190, label %191, label %205

191:                                              ; preds = %188
  %192 = load ptr, ptr %41, align 8
  %193 = getelementptr inbounds i8, ptr %192, i64 72
  %194 = load i64, ptr %193, align 8
  %195 = load ptr, ptr %55, align 8
  %196 = load i64, ptr %195, align 8
  %197 = inttoptr i64 %196 to ptr
  %198 = getelementptr inbounds i8, ptr %197, i64 1064
  %199 = load i64, ptr %198, align 8
  %200 = shl i64 %199, 4
  %201 = add i64 %194, 16
  %202 = add i64 %201, %200
  %203 = icmp sgt i64 %202, %189
  %204 = zext i1 %203 to i32
  br label %205

205:                                              ; preds = %188, %191
  %206 = phi i32 [ 0, %188 ], [ %204, %191 ]
  %207 = icmp eq i32 %206, 0
  br i1 %207, label %208, label %1457

208:                                              ; preds = %205, %187
  %209 = add nsw i64 %185, -1
  store i64 %209, ptr %184, align 8
  %210 = load i64, ptr %10, align 8
  %211 = trunc i64 %210 to i8
  %212 = bitcast i8 %211 to <8 x i1>
  %213 = load ptr, ptr %48, align 8
  %214 = load <8 x double>, ptr %213, align 8
  call fastcc void @hold_all(ptr noundef nonnull %0, ptr noundef nonnull %9) #12
  br i1 %37, label %218, label %215

215:                                              ; preds = %208
  %216 = load ptr, ptr %56, align 8
  %217 = load <8 x double>, ptr %216, align 8
  br label %218

218:                                              ; preds = %208, %215
  %219 = phi <8 x double> [ %217, %215 ], [ %58, %208 ]
  %220 = load <8 x double>, ptr %9, align 16
  %221 = fcmp olt <8 x double> %219, %220
  %222 = select <8 x i1> %221, <8 x double> %219, <8 x double> %220
  br i1 %37, label %223, label %228

223:                                              ; preds = %218
  %224 = load ptr, ptr %60, align 8
  %225 = load <8 x double>, ptr %224, align 8
  %226 = fcmp olt <8 x double> %225, %62
  %227 = select <8 x i1> %226, <8 x double> %225, <8 x double> %62
  br label %236

228:                                              ; preds = %218
  %229 = load ptr, ptr %59, align 8
  %230 = load <8 x double>, ptr %229, align 8
  %231 = fsub <8 x double> %222, %214
  %232 = fdiv <8 x double> %231, %230
  %233 = fmul <8 x double> %232, <double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1>
  %234 = call <8 x double> @llvm.ceil.v8f64(<8 x double> %233)
  %235 = fdiv <8 x double> %231, %234
  br label %236

236:                                              ; preds = %228, %223
  %237 = phi <8 x double> [ %227, %223 ], [ %235, %228 ]
  %238 = fadd <8 x double> %214, %237
  %239 = fmul <8 x double> %237, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %240 = fsub <8 x double> %222, %239
  %241 = fcmp ogt <8 x double> %238, %240
  %242 = select <8 x i1> %241, <8 x double> %222, <8 x double> %238
  %243 = fsub <8 x double> %242, %214
  %244 = select <8 x i1> %212, <8 x double> %243, <8 x double> zeroinitializer
  %245 = load ptr, ptr %63, align 8
  %246 = load <8 x double>, ptr %245, align 8
  %247 = load ptr, ptr %64, align 8
  %248 = load <8 x double>, ptr %247, align 8
  %249 = fadd <8 x double> %246, %248
  %250 = fcmp oge <8 x double> %249, %66
  %251 = fmul <8 x double> %244, <double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02>
  %252 = fadd <8 x double> %214, %251
  %253 = fcmp ule <8 x double> %252, %214
  %254 = fcmp une <8 x double> %242, %222
  %255 = and <8 x i1> %253, %254
  %256 = or <8 x i1> %255, %250
  %257 = and <8 x i1> %256, %212
  %258 = bitcast <8 x i1> %257 to i8
  %259 = icmp eq i8 %258, 0
  br i1 %259, label %267, label %260

260:                                              ; preds = %236
  %261 = zext i8 %258 to i64
  %262 = bitcast <8 x i1> %250 to i8
  %263 = zext i8 %262 to i64
  %264 = and i64 %261, %263
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %264, i64 noundef 1) #12
  %265 = xor i64 %263, -1
  %266 = and i64 %261, %265
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %266, i64 noundef -1) #12
  br label %177

267:                                              ; preds = %236
  %268 = load ptr, ptr %68, align 8, !noalias !8
  %269 = load ptr, ptr %69, align 8, !noalias !8
  %270 = getelementptr inbounds i8, ptr %269, i64 8
  %271 = load i64, ptr %270, align 8, !noalias !8
  %272 = getelementptr inbounds i8, ptr %268, i64 32
  %273 = load i64, ptr %272, align 8, !noalias !8
  %274 = icmp ne i64 %273, 1
  %275 = load i64, ptr %268, align 8, !noalias !8
  %276 = load ptr, ptr %70, align 8, !noalias !8
  store <8 x double> %244, ptr %276, align 8, !noalias !8
  %277 = icmp sgt i64 %275, 1
  br i1 %277, label %278, label %334

278:                                              ; preds = %267, %321
  %279 = phi i64 [ %331, %321 ], [ 0, %267 ]
  %280 = phi i64 [ %332, %321 ], [ 1, %267 ]
  %281 = load ptr, ptr %71, align 8, !noalias !8
  %282 = load ptr, ptr %67, align 8, !noalias !8
  %283 = load ptr, ptr %69, align 8, !noalias !8
  %284 = getelementptr inbounds i8, ptr %283, i64 16
  %285 = load i64, ptr %284, align 8, !noalias !8
  %286 = load ptr, ptr %72, align 8, !noalias !8
  %287 = getelementptr inbounds i64, ptr %286, i64 %280
  %288 = load i64, ptr %287, align 8, !noalias !8
  %289 = getelementptr i8, ptr %287, i64 8
  %290 = load i64, ptr %289, align 8, !noalias !8
  %291 = xor i64 %288, -1
  %292 = add i64 %290, %291
  %293 = load ptr, ptr %70, align 8, !noalias !8
  %294 = load ptr, ptr %73, align 8, !noalias !8
  %295 = load ptr, ptr %74, align 8, !noalias !8
  %296 = getelementptr inbounds i64, ptr %295, i64 %288
  %297 = load ptr, ptr %75, align 8, !noalias !8
  %298 = getelementptr inbounds double, ptr %297, i64 %288
  call fastcc void @combine(ptr noundef %281, ptr noundef %282, ptr noundef %293, ptr noundef %294, ptr noundef %296, ptr noundef %298, i64 noundef %292, i64 noundef %285) #12
  %299 = load ptr, ptr %73, align 8, !noalias !8
  %300 = load i64, ptr %76, align 8, !noalias !8
  %301 = mul nsw i64 %300, %280
  %302 = getelementptr inbounds double, ptr %299, i64 %301
  %303 = load ptr, ptr %77, align 8, !noalias !8
  %304 = getelementptr inbounds double, ptr %303, i64 %280
  %305 = load double, ptr %304, align 8, !noalias !8
  %306 = insertelement <8 x double> poison, double %305, i64 0
  %307 = shufflevector <8 x double> %306, <8 x double> poison, <8 x i32> zeroinitializer
  %308 = fmul <8 x double> %244, %307
  %309 = fadd <8 x double> %214, %308
  %310 = load ptr, ptr %71, align 8, !noalias !8
  %311 = load ptr, ptr %78, align 8, !noalias !8
  store <8 x double> %309, ptr %311, align 8, !noalias !8
  %312 = load ptr, ptr %69, align 8, !noalias !8
  %313 = getelementptr inbounds i8, ptr %312, i64 40
  %314 = load i64, ptr %313, align 8, !noalias !8
  %315 = icmp eq i64 %314, 0
  br i1 %315, label %317, label %316

316:                                              ; preds = %278
  call fastcc void @settle(ptr noundef nonnull %69) #12, !noalias !8
  br label %317

317:                                              ; preds = %316, %278
  %318 = load i64, ptr %79, align 8, !noalias !8
  %319 = icmp sgt i64 %318, 0
  br i1 %319, label %320, label %321

320:                                              ; preds = %317
  call fastcc void @sample(ptr noundef nonnull %69) #12, !noalias !8
  br label %321

321:                                              ; preds = %320, %317
  %322 = load ptr, ptr %69, align 8, !noalias !8
  %323 = load i64, ptr %322, align 8, !noalias !8
  %324 = load ptr, ptr %78, align 8, !noalias !8
  %325 = load ptr, ptr %80, align 8, !noalias !8
  %326 = load ptr, ptr %81, align 8, !noalias !8
  %327 = inttoptr i64 %323 to ptr
  %328 = load ptr, ptr %327, align 8, !noalias !8
  %329 = call i32 %328(ptr noundef %324, ptr noundef %310, ptr noundef %325, ptr noundef %326, ptr noundef %302) #13, !noalias !8
  %330 = zext i32 %329 to i64
  %331 = or i64 %279, %330
  %332 = add nuw nsw i64 %280, 1
  %333 = icmp eq i64 %332, %275
  br i1 %333, label %334, label %278, !llvm.loop !11

334:                                              ; preds = %321, %267
  %335 = phi i64 [ 0, %267 ], [ %331, %321 ]
  %336 = load ptr, ptr %82, align 8, !noalias !8
  %337 = load ptr, ptr %67, align 8, !noalias !8
  %338 = load ptr, ptr %69, align 8, !noalias !8
  %339 = getelementptr inbounds i8, ptr %338, i64 16
  %340 = load i64, ptr %339, align 8, !noalias !8
  %341 = load ptr, ptr %83, align 8, !noalias !8
  %342 = getelementptr inbounds i64, ptr %341, i64 %275
  %343 = load i64, ptr %342, align 8, !noalias !8
  %344 = getelementptr i8, ptr %342, i64 8
  %345 = load i64, ptr %344, align 8, !noalias !8
  %346 = xor i64 %343, -1
  %347 = add i64 %345, %346
  %348 = load ptr, ptr %70, align 8, !noalias !8
  %349 = load ptr, ptr %84, align 8, !noalias !8
  %350 = load ptr, ptr %85, align 8, !noalias !8
  %351 = getelementptr inbounds i64, ptr %350, i64 %343
  %352 = load ptr, ptr %86, align 8, !noalias !8
  %353 = getelementptr inbounds double, ptr %352, i64 %343
  call fastcc void @combine(ptr noundef %336, ptr noundef %337, ptr noundef %348, ptr noundef %349, ptr noundef %351, ptr noundef %353, i64 noundef %347, i64 noundef %340) #12
  br i1 %274, label %382, label %354

354:                                              ; preds = %334
  %355 = load ptr, ptr %82, align 8, !noalias !8
  %356 = load ptr, ptr %84, align 8, !noalias !8
  %357 = load i64, ptr %268, align 8, !noalias !8
  %358 = load i64, ptr %87, align 8, !noalias !8
  %359 = mul nsw i64 %358, %357
  %360 = getelementptr inbounds double, ptr %356, i64 %359
  %361 = load ptr, ptr %88, align 8, !noalias !8
  store <8 x double> %242, ptr %361, align 8, !noalias !8
  %362 = load ptr, ptr %69, align 8, !noalias !8
  %363 = getelementptr inbounds i8, ptr %362, i64 40
  %364 = load i64, ptr %363, align 8, !noalias !8
  %365 = icmp eq i64 %364, 0
  br i1 %365, label %367, label %366

366:                                              ; preds = %354
  call fastcc void @settle(ptr noundef nonnull %69) #12, !noalias !8
  br label %367

367:                                              ; preds = %366, %354
  %368 = load i64, ptr %89, align 8, !noalias !8
  %369 = icmp sgt i64 %368, 0
  br i1 %369, label %370, label %371

370:                                              ; preds = %367
  call fastcc void @sample(ptr noundef nonnull %69) #12, !noalias !8
  br label %371

371:                                              ; preds = %367, %370
  %372 = load ptr, ptr %69, align 8, !noalias !8
  %373 = load i64, ptr %372, align 8, !noalias !8
  %374 = load ptr, ptr %88, align 8, !noalias !8
  %375 = load ptr, ptr %90, align 8, !noalias !8
  %376 = load ptr, ptr %91, align 8, !noalias !8
  %377 = inttoptr i64 %373 to ptr
  %378 = load ptr, ptr %377, align 8, !noalias !8
  %379 = call i32 %378(ptr noundef %374, ptr noundef %355, ptr noundef %375, ptr noundef %376, ptr noundef %360) #13, !noalias !8
  %380 = zext i32 %379 to i64
  %381 = or i64 %335, %380
  br label %382

382:                                              ; preds = %371, %334
  %383 = phi i64 [ %381, %371 ], [ %335, %334 ]
  %384 = load ptr, ptr %0, align 8, !noalias !8
  %385 = getelementptr inbounds i8, ptr %384, i64 8
  %386 = load i64, ptr %385, align 8, !noalias !8
  %387 = icmp slt i64 %386, 1
  br i1 %387, label %388, label %392

388:                                              ; preds = %382
  %389 = icmp sgt i64 %271, 0
  br i1 %389, label %390, label %674

390:                                              ; preds = %388
  %391 = load ptr, ptr %82, align 8, !noalias !8
  br label %664

392:                                              ; preds = %382
  %393 = load ptr, ptr %21, align 8, !noalias !8
  %394 = load i64, ptr %23, align 8, !noalias !8
  %395 = getelementptr double, ptr %393, i64 %394
  %396 = getelementptr i8, ptr %395, i64 -16
  %397 = load double, ptr %396, align 8, !noalias !8
  %398 = load double, ptr %393, align 8, !noalias !8
  %399 = fsub double %397, %398
  %400 = fmul double %399, 0x3D70000000000000
  %401 = load ptr, ptr %69, align 8, !noalias !8
  %402 = load ptr, ptr %68, align 8, !noalias !8
  %403 = getelementptr inbounds i8, ptr %401, i64 24
  %404 = load i64, ptr %403, align 8, !noalias !8
  %405 = getelementptr inbounds i8, ptr %402, i64 8
  %406 = load i64, ptr %405, align 8, !noalias !8
  %407 = load ptr, ptr %92, align 8, !noalias !8
  %408 = load i64, ptr %93, align 8, !noalias !8
  %409 = getelementptr inbounds double, ptr %407, i64 %408
  %410 = icmp sgt i64 %406, 0
  br i1 %410, label %411, label %413

411:                                              ; preds = %392
  %412 = getelementptr inbounds i8, ptr %401, i64 32
  br label %421

413:                                              ; preds = %421, %392
  %414 = icmp sgt i64 %404, 0
  br i1 %414, label %415, label %483

415:                                              ; preds = %413
  %416 = load ptr, ptr %67, align 8, !noalias !8
  %417 = load ptr, ptr %82, align 8, !noalias !8
  %418 = load ptr, ptr %95, align 8, !noalias !8
  %419 = load ptr, ptr %96, align 8, !noalias !8
  %420 = load ptr, ptr %92, align 8, !noalias !8
  br label %447

421:                                              ; preds = %411, %421
  %422 = phi i64 [ 0, %411 ], [ %445, %421 ]
  %423 = load i64, ptr %402, align 8, !noalias !8
  %424 = load i64, ptr %412, align 8, !noalias !8
  %425 = load ptr, ptr %92, align 8, !noalias !8
  %426 = load i64, ptr %93, align 8, !noalias !8
  %427 = mul nsw i64 %426, %422
  %428 = getelementptr inbounds double, ptr %425, i64 %427
  %429 = load ptr, ptr %94, align 8, !noalias !8
  %430 = load ptr, ptr %83, align 8, !noalias !8
  %431 = getelementptr i64, ptr %430, i64 %423
  %432 = getelementptr i8, ptr %431, i64 8
  %433 = getelementptr i64, ptr %432, i64 %422
  %434 = load i64, ptr %433, align 8, !noalias !8
  %435 = getelementptr i8, ptr %433, i64 8
  %436 = load i64, ptr %435, align 8, !noalias !8
  %437 = xor i64 %434, -1
  %438 = add i64 %436, %437
  %439 = load ptr, ptr %70, align 8, !noalias !8
  %440 = load ptr, ptr %84, align 8, !noalias !8
  %441 = load ptr, ptr %85, align 8, !noalias !8
  %442 = getelementptr inbounds i64, ptr %441, i64 %434
  %443 = load ptr, ptr %86, align 8, !noalias !8
  %444 = getelementptr inbounds double, ptr %443, i64 %434
  call fastcc void @combine(ptr noundef %428, ptr noundef %429, ptr noundef %439, ptr noundef %440, ptr noundef %442, ptr noundef %444, i64 noundef %438, i64 noundef %424) #12
  %445 = add nuw nsw i64 %422, 1
  %446 = icmp eq i64 %445, %406
  br i1 %446, label %413, label %421, !llvm.loop !12

447:                                              ; preds = %415, %447
  %448 = phi <8 x double> [ zeroinitializer, %415 ], [ %478, %447 ]
  %449 = phi <8 x double> [ zeroinitializer, %415 ], [ %480, %447 ]
  %450 = phi i64 [ 0, %415 ], [ %481, %447 ]
  %451 = shl nsw i64 %450, 6
  %452 = getelementptr inbounds i8, ptr %416, i64 %451
  %453 = load <8 x double>, ptr %452, align 8, !noalias !8
  %454 = getelementptr inbounds i8, ptr %417, i64 %451
  %455 = load <8 x double>, ptr %454, align 8, !noalias !8
  %456 = getelementptr inbounds double, ptr %418, i64 %450
  %457 = load double, ptr %456, align 8, !noalias !8
  %458 = insertelement <8 x double> poison, double %457, i64 0
  %459 = shufflevector <8 x double> %458, <8 x double> poison, <8 x i32> zeroinitializer
  %460 = getelementptr inbounds double, ptr %419, i64 %450
  %461 = load double, ptr %460, align 8, !noalias !8
  %462 = insertelement <8 x double> poison, double %461, i64 0
  %463 = shufflevector <8 x double> %462, <8 x double> poison, <8 x i32> zeroinitializer
  %464 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %453)
  %465 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %455)
  %466 = fcmp ogt <8 x double> %464, %465
  %467 = select <8 x i1> %466, <8 x double> %464, <8 x double> %465
  %468 = fmul <8 x double> %467, %463
  %469 = fadd <8 x double> %459, %468
  %470 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %469
  %471 = getelementptr inbounds i8, ptr %420, i64 %451
  %472 = load <8 x double>, ptr %471, align 8, !noalias !8
  %473 = fmul <8 x double> %472, %470
  %474 = getelementptr inbounds i8, ptr %409, i64 %451
  %475 = load <8 x double>, ptr %474, align 8, !noalias !8
  %476 = fmul <8 x double> %475, %470
  %477 = fmul <8 x double> %473, %473
  %478 = fadd <8 x double> %448, %477
  %479 = fmul <8 x double> %476, %476
  %480 = fadd <8 x double> %449, %479
  %481 = add nuw nsw i64 %450, 1
  %482 = icmp eq i64 %481, %404
  br i1 %482, label %483, label %447, !llvm.loop !13

483:                                              ; preds = %447, %413
  %484 = phi <8 x double> [ zeroinitializer, %413 ], [ %480, %447 ]
  %485 = phi <8 x double> [ zeroinitializer, %413 ], [ %478, %447 ]
  %486 = load ptr, ptr %82, align 8, !noalias !8
  %487 = getelementptr inbounds i8, ptr %401, i64 8
  %488 = load i64, ptr %487, align 8, !noalias !8
  %489 = add nsw i64 %488, -3
  %490 = getelementptr i8, ptr %486, i64 64
  %491 = getelementptr i8, ptr %486, i64 128
  %492 = getelementptr i8, ptr %486, i64 192
  %493 = icmp slt i64 %404, %489
  br i1 %493, label %501, label %494

494:                                              ; preds = %501, %483
  %495 = phi <8 x double> [ zeroinitializer, %483 ], [ %511, %501 ]
  %496 = phi <8 x double> [ zeroinitializer, %483 ], [ %516, %501 ]
  %497 = phi <8 x double> [ zeroinitializer, %483 ], [ %521, %501 ]
  %498 = phi <8 x double> [ zeroinitializer, %483 ], [ %526, %501 ]
  %499 = phi i64 [ %404, %483 ], [ %527, %501 ]
  %500 = icmp slt i64 %499, %488
  br i1 %500, label %529, label %539

501:                                              ; preds = %483, %501
  %502 = phi i64 [ %527, %501 ], [ %404, %483 ]
  %503 = phi <8 x double> [ %526, %501 ], [ zeroinitializer, %483 ]
  %504 = phi <8 x double> [ %521, %501 ], [ zeroinitializer, %483 ]
  %505 = phi <8 x double> [ %516, %501 ], [ zeroinitializer, %483 ]
  %506 = phi <8 x double> [ %511, %501 ], [ zeroinitializer, %483 ]
  %507 = shl nsw i64 %502, 6
  %508 = getelementptr inbounds i8, ptr %486, i64 %507
  %509 = load <8 x double>, ptr %508, align 8, !noalias !8
  %510 = fmul <8 x double> %509, zeroinitializer
  %511 = fadd <8 x double> %506, %510
  %512 = shl i64 %502, 6
  %513 = getelementptr i8, ptr %490, i64 %512
  %514 = load <8 x double>, ptr %513, align 8, !noalias !8
  %515 = fmul <8 x double> %514, zeroinitializer
  %516 = fadd <8 x double> %505, %515
  %517 = shl i64 %502, 6
  %518 = getelementptr i8, ptr %491, i64 %517
  %519 = load <8 x double>, ptr %518, align 8, !noalias !8
  %520 = fmul <8 x double> %519, zeroinitializer
  %521 = fadd <8 x double> %504, %520
  %522 = shl i64 %502, 6
  %523 = getelementptr i8, ptr %492, i64 %522
  %524 = load <8 x double>, ptr %523, align 8, !noalias !8
  %525 = fmul <8 x double> %524, zeroinitializer
  %526 = fadd <8 x double> %503, %525
  %527 = add nsw i64 %502, 4
  %528 = icmp slt i64 %527, %489
  br i1 %528, label %501, label %494, !llvm.loop !14

529:                                              ; preds = %494, %529
  %530 = phi i64 [ %537, %529 ], [ %499, %494 ]
  %531 = phi <8 x double> [ %536, %529 ], [ %495, %494 ]
  %532 = shl nsw i64 %530, 6
  %533 = getelementptr inbounds i8, ptr %486, i64 %532
  %534 = load <8 x double>, ptr %533, align 8, !noalias !8
  %535 = fmul <8 x double> %534, zeroinitializer
  %536 = fadd <8 x double> %531, %535
  %537 = add nsw i64 %530, 1
  %538 = icmp eq i64 %537, %488
  br i1 %538, label %539, label %529, !llvm.loop !15

539:                                              ; preds = %529, %494
  %540 = phi <8 x double> [ %495, %494 ], [ %536, %529 ]
  %541 = fadd <8 x double> %496, %540
  %542 = fadd <8 x double> %497, %498
  %543 = fadd <8 x double> %542, %541
  %544 = fadd <8 x double> %485, %543
  %545 = icmp eq i64 %406, 2
  br i1 %545, label %546, label %557

546:                                              ; preds = %539
  %547 = fmul <8 x double> %484, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %548 = fadd <8 x double> %547, %544
  %549 = sitofp i64 %404 to double
  %550 = insertelement <8 x double> poison, double %549, i64 0
  %551 = shufflevector <8 x double> %550, <8 x double> poison, <8 x i32> zeroinitializer
  %552 = fmul <8 x double> %551, %548
  %553 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %552)
  %554 = fdiv <8 x double> %544, %553
  %555 = fcmp oeq <8 x double> %544, zeroinitializer
  %556 = select <8 x i1> %555, <8 x double> zeroinitializer, <8 x double> %554
  br label %563

557:                                              ; preds = %539
  %558 = sitofp i64 %404 to double
  %559 = insertelement <8 x double> poison, double %558, i64 0
  %560 = shufflevector <8 x double> %559, <8 x double> poison, <8 x i32> zeroinitializer
  %561 = fdiv <8 x double> %544, %560
  %562 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %561)
  br label %563

563:                                              ; preds = %546, %557
  %564 = phi <8 x double> [ %556, %546 ], [ %562, %557 ]
  %565 = load ptr, ptr %92, align 8, !noalias !8
  %566 = load ptr, ptr %70, align 8, !noalias !8
  %567 = load <8 x double>, ptr %566, align 8, !noalias !8
  %568 = load i64, ptr %403, align 8, !noalias !8
  %569 = getelementptr inbounds i8, ptr %401, i64 48
  %570 = load i64, ptr %569, align 8, !noalias !8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(512) %4, i8 0, i64 512, i1 false), !noalias !8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(512) %5, i8 0, i64 512, i1 false), !noalias !8
  %571 = icmp eq i64 %570, 0
  br i1 %571, label %662, label %572

572:                                              ; preds = %563
  br i1 %545, label %573, label %575

573:                                              ; preds = %572
  %574 = load i64, ptr %93, align 8, !noalias !8
  br label %575

575:                                              ; preds = %573, %572
  %576 = phi i64 [ %574, %573 ], [ 0, %572 ]
  %577 = getelementptr inbounds double, ptr %565, i64 %576
  %578 = icmp slt i64 %568, %570
  br i1 %578, label %580, label %579

579:                                              ; preds = %584, %575
  br label %649

580:                                              ; preds = %575
  %581 = load ptr, ptr %67, align 8, !noalias !8
  %582 = load ptr, ptr %97, align 8, !noalias !8
  %583 = load ptr, ptr %98, align 8, !noalias !8
  br label %584

584:                                              ; preds = %580, %584
  %585 = phi i64 [ %568, %580 ], [ %620, %584 ]
  %586 = shl nsw i64 %585, 6
  %587 = getelementptr inbounds i8, ptr %581, i64 %586
  %588 = load <8 x double>, ptr %587, align 8, !noalias !8
  %589 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %588)
  %590 = getelementptr inbounds i8, ptr %486, i64 %586
  %591 = load <8 x double>, ptr %590, align 8, !noalias !8
  %592 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %591)
  %593 = fcmp ogt <8 x double> %589, %592
  %594 = select <8 x i1> %593, <8 x double> %589, <8 x double> %592
  %595 = getelementptr inbounds i8, ptr %582, i64 %586
  %596 = load <8 x double>, ptr %595, align 8, !noalias !8
  %597 = getelementptr inbounds double, ptr %583, i64 %585
  %598 = load double, ptr %597, align 8, !noalias !8
  %599 = insertelement <8 x double> poison, double %598, i64 0
  %600 = shufflevector <8 x double> %599, <8 x double> poison, <8 x i32> zeroinitializer
  %601 = fmul <8 x double> %594, %600
  %602 = fadd <8 x double> %596, %601
  %603 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %602
  %604 = getelementptr inbounds i8, ptr %565, i64 %586
  %605 = load <8 x double>, ptr %604, align 8, !noalias !8
  %606 = fmul <8 x double> %605, %603
  %607 = getelementptr inbounds i8, ptr %577, i64 %586
  %608 = load <8 x double>, ptr %607, align 8, !noalias !8
  %609 = fmul <8 x double> %608, %603
  %610 = srem i64 %585, 8
  %611 = shl nsw i64 %610, 6
  %612 = getelementptr inbounds i8, ptr %4, i64 %611
  %613 = load <8 x double>, ptr %612, align 16, !noalias !8
  %614 = fmul <8 x double> %606, %606
  %615 = fadd <8 x double> %613, %614
  store <8 x double> %615, ptr %612, align 16, !noalias !8
  %616 = getelementptr inbounds i8, ptr %5, i64 %611
  %617 = load <8 x double>, ptr %616, align 16, !noalias !8
  %618 = fmul <8 x double> %609, %609
  %619 = fadd <8 x double> %617, %618
  store <8 x double> %619, ptr %616, align 16, !noalias !8
  %620 = add nsw i64 %585, 1
  %621 = icmp eq i64 %620, %570
  br i1 %621, label %579, label %584, !llvm.loop !16

622:                                              ; preds = %649
  %623 = sub nsw i64 %570, %568
  br i1 %545, label %624, label %635

624:                                              ; preds = %622
  %625 = fmul <8 x double> %659, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %626 = fadd <8 x double> %656, %625
  %627 = sitofp i64 %623 to double
  %628 = insertelement <8 x double> poison, double %627, i64 0
  %629 = shufflevector <8 x double> %628, <8 x double> poison, <8 x i32> zeroinitializer
  %630 = fmul <8 x double> %629, %626
  %631 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %630)
  %632 = fdiv <8 x double> %656, %631
  %633 = fcmp oeq <8 x double> %656, zeroinitializer
  %634 = select <8 x i1> %633, <8 x double> zeroinitializer, <8 x double> %632
  br label %641

635:                                              ; preds = %622
  %636 = sitofp i64 %623 to double
  %637 = insertelement <8 x double> poison, double %636, i64 0
  %638 = shufflevector <8 x double> %637, <8 x double> poison, <8 x i32> zeroinitializer
  %639 = fdiv <8 x double> %656, %638
  %640 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %639)
  br label %641

641:                                              ; preds = %635, %624
  %642 = phi <8 x double> [ %634, %624 ], [ %640, %635 ]
  %643 = insertelement <8 x double> poison, double %400, i64 0
  %644 = shufflevector <8 x double> %643, <8 x double> poison, <8 x i32> zeroinitializer
  %645 = fcmp ogt <8 x double> %567, %644
  %646 = fcmp ogt <8 x double> %642, %564
  %647 = select <8 x i1> %645, <8 x i1> %646, <8 x i1> zeroinitializer
  %648 = select <8 x i1> %647, <8 x double> %642, <8 x double> %564
  br label %662

649:                                              ; preds = %579, %649
  %650 = phi i64 [ %660, %649 ], [ 0, %579 ]
  %651 = phi <8 x double> [ %659, %649 ], [ zeroinitializer, %579 ]
  %652 = phi <8 x double> [ %656, %649 ], [ zeroinitializer, %579 ]
  %653 = shl nuw nsw i64 %650, 6
  %654 = getelementptr inbounds i8, ptr %4, i64 %653
  %655 = load <8 x double>, ptr %654, align 16, !noalias !8
  %656 = fadd <8 x double> %652, %655
  %657 = getelementptr inbounds i8, ptr %5, i64 %653
  %658 = load <8 x double>, ptr %657, align 16, !noalias !8
  %659 = fadd <8 x double> %651, %658
  %660 = add nuw nsw i64 %650, 1
  %661 = icmp eq i64 %660, 8
  br i1 %661, label %622, label %649, !llvm.loop !17

662:                                              ; preds = %563, %641
  %663 = phi <8 x double> [ %564, %563 ], [ %648, %641 ]
  br label %674

664:                                              ; preds = %390, %664
  %665 = phi i64 [ 0, %390 ], [ %672, %664 ]
  %666 = phi <8 x double> [ zeroinitializer, %390 ], [ %671, %664 ]
  %667 = shl nsw i64 %665, 6
  %668 = getelementptr inbounds i8, ptr %391, i64 %667
  %669 = load <8 x double>, ptr %668, align 8, !noalias !8
  %670 = fmul <8 x double> %669, zeroinitializer
  %671 = fadd <8 x double> %666, %670
  %672 = add nuw nsw i64 %665, 1
  %673 = icmp eq i64 %672, %271
  br i1 %673, label %674, label %664, !llvm.loop !18

674:                                              ; preds = %664, %388, %662
  %675 = phi <8 x double> [ %663, %662 ], [ zeroinitializer, %388 ], [ %671, %664 ]
  %676 = fcmp olt <8 x double> %675, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %677 = bitcast <8 x i1> %676 to i8
  %678 = zext i8 %677 to i64
  %679 = xor i64 %383, -1
  %680 = and i64 %679, %678
  %681 = and i64 %680, %210
  %682 = load ptr, ptr %99, align 8, !noalias !8
  %683 = load <8 x double>, ptr %682, align 8, !noalias !8
  %684 = load i64, ptr %268, align 8, !noalias !8
  %685 = sext i1 %274 to i64
  %686 = add i64 %684, %685
  %687 = sitofp i64 %686 to double
  %688 = insertelement <8 x double> poison, double %687, i64 0
  %689 = shufflevector <8 x double> %688, <8 x double> poison, <8 x i32> zeroinitializer
  %690 = fadd <8 x double> %683, %689
  store <8 x double> %690, ptr %682, align 8, !noalias !8
  %691 = icmp ne i64 %681, 0
  %692 = select i1 %51, i1 %691, i1 false
  br i1 %692, label %693, label %696

693:                                              ; preds = %674
  store <8 x double> %242, ptr %7, align 16
  %694 = load ptr, ptr %100, align 8
  %695 = call fastcc i64 @hold_lanes(ptr noundef nonnull %0, ptr noundef nonnull %7, ptr noundef %694, i64 noundef %681, i32 noundef %50) #12
  br label %696

696:                                              ; preds = %693, %674
  %697 = phi i64 [ %695, %693 ], [ 0, %674 ]
  %698 = xor i64 %697, -1
  %699 = and i64 %681, %698
  %700 = load ptr, ptr %68, align 8
  %701 = icmp eq i64 %699, 0
  br i1 %701, label %746, label %702

702:                                              ; preds = %696
  %703 = getelementptr inbounds i8, ptr %700, i64 32
  %704 = load i64, ptr %703, align 8
  %705 = icmp eq i64 %704, 1
  br i1 %705, label %706, label %710

706:                                              ; preds = %702
  %707 = load ptr, ptr %38, align 8
  %708 = load i64, ptr %707, align 8
  %709 = icmp eq i64 %708, 1
  br i1 %709, label %710, label %746

710:                                              ; preds = %706, %702
  %711 = load ptr, ptr %82, align 8
  %712 = load ptr, ptr %84, align 8
  %713 = load i64, ptr %700, align 8
  %714 = load i64, ptr %101, align 8
  %715 = mul nsw i64 %714, %713
  %716 = getelementptr inbounds double, ptr %712, i64 %715
  %717 = load ptr, ptr %102, align 8
  store <8 x double> %242, ptr %717, align 8
  %718 = load ptr, ptr %69, align 8
  %719 = getelementptr inbounds i8, ptr %718, i64 40
  %720 = load i64, ptr %719, align 8
  %721 = icmp eq i64 %720, 0
  br i1 %721, label %723, label %722

722:                                              ; preds = %710
  call fastcc void @settle(ptr noundef nonnull %69) #12
  br label %723

723:                                              ; preds = %722, %710
  %724 = load i64, ptr %103, align 8
  %725 = icmp sgt i64 %724, 0
  br i1 %725, label %726, label %727

726:                                              ; preds = %723
  call fastcc void @sample(ptr noundef nonnull %69) #12
  br label %727

727:                                              ; preds = %723, %726
  %728 = load ptr, ptr %69, align 8
  %729 = load i64, ptr %728, align 8
  %730 = load ptr, ptr %102, align 8
  %731 = load ptr, ptr %104, align 8
  %732 = load ptr, ptr %105, align 8
  %733 = inttoptr i64 %729 to ptr
  %734 = load ptr, ptr %733, align 8
  %735 = call i32 %734(ptr noundef %730, ptr noundef %711, ptr noundef %731, ptr noundef %732, ptr noundef %716) #13
  %736 = zext i32 %735 to i64
  %737 = or i64 %383, %736
  %738 = load ptr, ptr %99, align 8
  %739 = load <8 x double>, ptr %738, align 8
  %740 = trunc nuw i64 %699 to i8
  %741 = bitcast i8 %740 to <8 x i1>
  %742 = select <8 x i1> %741, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %743 = fadd <8 x double> %742, %739
  store <8 x double> %743, ptr %738, align 8
  %744 = xor i64 %737, -1
  %745 = and i64 %699, %744
  br label %746

746:                                              ; preds = %696, %706, %727
  %747 = phi i64 [ %383, %696 ], [ %737, %727 ], [ %383, %706 ]
  %748 = phi i64 [ %699, %696 ], [ %745, %727 ], [ %699, %706 ]
  %749 = icmp ne i64 %748, 0
  %750 = select i1 %52, i1 %749, i1 false
  br i1 %750, label %751, label %755

751:                                              ; preds = %746
  %752 = call fastcc i64 @clear_lanes(ptr noundef nonnull %0) #12
  %753 = xor i64 %752, -1
  %754 = and i64 %748, %753
  br label %755

755:                                              ; preds = %746, %751
  %756 = phi i64 [ %754, %751 ], [ 0, %746 ]
  store i64 0, ptr %12, align 8
  %757 = load ptr, ptr %106, align 8
  %758 = load <8 x double>, ptr %757, align 8
  %759 = fcmp olt <8 x double> %758, %242
  %760 = bitcast <8 x i1> %759 to i8
  %761 = zext i8 %760 to i64
  %762 = and i64 %748, %761
  %763 = or i64 %762, %756
  %764 = icmp eq i64 %763, 0
  br i1 %764, label %965, label %765

765:                                              ; preds = %755
  %766 = load ptr, ptr %99, align 8
  %767 = load <8 x double>, ptr %766, align 8
  %768 = trunc nuw i64 %763 to i8
  %769 = bitcast i8 %768 to <8 x i1>
  %770 = load ptr, ptr %68, align 8
  %771 = getelementptr inbounds i8, ptr %770, i64 16
  %772 = load i64, ptr %771, align 8
  %773 = sitofp i64 %772 to double
  %774 = insertelement <8 x double> poison, double %773, i64 0
  %775 = shufflevector <8 x double> %774, <8 x double> poison, <8 x i32> zeroinitializer
  %776 = select <8 x i1> %769, <8 x double> %775, <8 x double> zeroinitializer
  %777 = fadd <8 x double> %767, %776
  store <8 x double> %777, ptr %766, align 8
  %778 = load ptr, ptr %68, align 8
  %779 = load ptr, ptr %69, align 8
  %780 = getelementptr inbounds i8, ptr %779, i64 16
  %781 = load i64, ptr %780, align 8
  %782 = load i64, ptr %778, align 8
  %783 = load i64, ptr %107, align 8
  %784 = load ptr, ptr %84, align 8
  %785 = mul nsw i64 %783, %782
  %786 = getelementptr inbounds double, ptr %784, i64 %785
  %787 = load ptr, ptr %108, align 8
  %788 = add nsw i64 %782, 1
  %789 = getelementptr inbounds i8, ptr %778, i64 16
  %790 = load i64, ptr %789, align 8
  %791 = icmp sgt i64 %790, 0
  br i1 %791, label %792, label %794

792:                                              ; preds = %765
  %793 = getelementptr inbounds i8, ptr %778, i64 8
  br label %805

794:                                              ; preds = %846, %765
  %795 = phi i64 [ 0, %765 ], [ %856, %846 ]
  %796 = getelementptr inbounds i8, ptr %778, i64 16
  %797 = load ptr, ptr %69, align 8
  %798 = getelementptr inbounds i8, ptr %797, i64 8
  %799 = load i64, ptr %798, align 8
  %800 = icmp sgt i64 %799, 0
  br i1 %800, label %801, label %861

801:                                              ; preds = %794
  %802 = getelementptr inbounds double, ptr %787, i64 %783
  %803 = shl nsw i64 %783, 4
  %804 = getelementptr inbounds i8, ptr %787, i64 %803
  br label %868

805:                                              ; preds = %792, %846
  %806 = phi i64 [ 0, %792 ], [ %856, %846 ]
  %807 = phi i64 [ %788, %792 ], [ %857, %846 ]
  %808 = load i64, ptr %793, align 8
  %809 = load ptr, ptr %109, align 8
  %810 = load ptr, ptr %67, align 8
  %811 = load ptr, ptr %83, align 8
  %812 = getelementptr i64, ptr %811, i64 %807
  %813 = getelementptr i64, ptr %812, i64 %808
  %814 = load i64, ptr %813, align 8
  %815 = getelementptr i8, ptr %813, i64 8
  %816 = load i64, ptr %815, align 8
  %817 = xor i64 %814, -1
  %818 = add i64 %816, %817
  %819 = load ptr, ptr %70, align 8
  %820 = load ptr, ptr %84, align 8
  %821 = load ptr, ptr %85, align 8
  %822 = getelementptr inbounds i64, ptr %821, i64 %814
  %823 = load ptr, ptr %86, align 8
  %824 = getelementptr inbounds double, ptr %823, i64 %814
  call fastcc void @combine(ptr noundef %809, ptr noundef %810, ptr noundef %819, ptr noundef %820, ptr noundef %822, ptr noundef %824, i64 noundef %818, i64 noundef %781) #12
  %825 = load ptr, ptr %84, align 8
  %826 = mul nsw i64 %807, %783
  %827 = getelementptr inbounds double, ptr %825, i64 %826
  %828 = load ptr, ptr %110, align 8
  %829 = getelementptr inbounds double, ptr %828, i64 %807
  %830 = load double, ptr %829, align 8
  %831 = insertelement <8 x double> poison, double %830, i64 0
  %832 = shufflevector <8 x double> %831, <8 x double> poison, <8 x i32> zeroinitializer
  %833 = fmul <8 x double> %244, %832
  %834 = fadd <8 x double> %214, %833
  %835 = load ptr, ptr %109, align 8
  %836 = load ptr, ptr %111, align 8
  store <8 x double> %834, ptr %836, align 8
  %837 = load ptr, ptr %69, align 8
  %838 = getelementptr inbounds i8, ptr %837, i64 40
  %839 = load i64, ptr %838, align 8
  %840 = icmp eq i64 %839, 0
  br i1 %840, label %842, label %841

841:                                              ; preds = %805
  call fastcc void @settle(ptr noundef nonnull %69) #12
  br label %842

842:                                              ; preds = %841, %805
  %843 = load i64, ptr %112, align 8
  %844 = icmp sgt i64 %843, 0
  br i1 %844, label %845, label %846

845:                                              ; preds = %842
  call fastcc void @sample(ptr noundef nonnull %69) #12
  br label %846

846:                                              ; preds = %845, %842
  %847 = load ptr, ptr %69, align 8
  %848 = load i64, ptr %847, align 8
  %849 = load ptr, ptr %111, align 8
  %850 = load ptr, ptr %113, align 8
  %851 = load ptr, ptr %114, align 8
  %852 = inttoptr i64 %848 to ptr
  %853 = load ptr, ptr %852, align 8
  %854 = call i32 %853(ptr noundef %849, ptr noundef %835, ptr noundef %850, ptr noundef %851, ptr noundef %827) #13
  %855 = sext i32 %854 to i64
  %856 = or i64 %806, %855
  %857 = add nsw i64 %807, 1
  %858 = load i64, ptr %789, align 8
  %859 = add nsw i64 %858, %788
  %860 = icmp slt i64 %857, %859
  br i1 %860, label %805, label %794, !llvm.loop !19

861:                                              ; preds = %868, %794
  %862 = getelementptr inbounds i8, ptr %778, i64 8
  %863 = load i64, ptr %862, align 8
  %864 = load i64, ptr %796, align 8
  %865 = getelementptr inbounds i8, ptr %778, i64 24
  %866 = load i64, ptr %865, align 8
  %867 = icmp sgt i64 %866, 3
  br i1 %867, label %896, label %921

868:                                              ; preds = %801, %868
  %869 = phi i64 [ 0, %801 ], [ %891, %868 ]
  %870 = load ptr, ptr %82, align 8
  %871 = shl nsw i64 %869, 6
  %872 = getelementptr inbounds i8, ptr %870, i64 %871
  %873 = load <8 x double>, ptr %872, align 8
  %874 = load ptr, ptr %67, align 8
  %875 = getelementptr inbounds i8, ptr %874, i64 %871
  %876 = load <8 x double>, ptr %875, align 8
  %877 = fsub <8 x double> %873, %876
  %878 = load ptr, ptr %84, align 8
  %879 = getelementptr inbounds i8, ptr %878, i64 %871
  %880 = load <8 x double>, ptr %879, align 8
  %881 = fmul <8 x double> %244, %880
  %882 = fsub <8 x double> %881, %877
  %883 = getelementptr inbounds i8, ptr %787, i64 %871
  store <8 x double> %877, ptr %883, align 8
  %884 = getelementptr inbounds i8, ptr %802, i64 %871
  store <8 x double> %882, ptr %884, align 8
  %885 = fsub <8 x double> %877, %882
  %886 = getelementptr inbounds i8, ptr %786, i64 %871
  %887 = load <8 x double>, ptr %886, align 8
  %888 = fmul <8 x double> %244, %887
  %889 = fsub <8 x double> %885, %888
  %890 = getelementptr inbounds i8, ptr %804, i64 %871
  store <8 x double> %889, ptr %890, align 8
  %891 = add nuw nsw i64 %869, 1
  %892 = load ptr, ptr %69, align 8
  %893 = getelementptr inbounds i8, ptr %892, i64 8
  %894 = load i64, ptr %893, align 8
  %895 = icmp slt i64 %891, %894
  br i1 %895, label %868, label %861, !llvm.loop !20

896:                                              ; preds = %861, %896
  %897 = phi i64 [ %918, %896 ], [ 3, %861 ]
  %898 = mul nsw i64 %897, %783
  %899 = getelementptr inbounds double, ptr %787, i64 %898
  %900 = load ptr, ptr %115, align 8
  %901 = load ptr, ptr %83, align 8
  %902 = getelementptr i64, ptr %901, i64 %788
  %903 = getelementptr i64, ptr %902, i64 %863
  %904 = getelementptr i64, ptr %903, i64 %864
  %905 = getelementptr i64, ptr %904, i64 %897
  %906 = getelementptr i8, ptr %905, i64 -24
  %907 = load i64, ptr %906, align 8
  %908 = getelementptr i8, ptr %905, i64 -16
  %909 = load i64, ptr %908, align 8
  %910 = xor i64 %907, -1
  %911 = add i64 %909, %910
  %912 = load ptr, ptr %70, align 8
  %913 = load ptr, ptr %84, align 8
  %914 = load ptr, ptr %85, align 8
  %915 = getelementptr inbounds i64, ptr %914, i64 %907
  %916 = load ptr, ptr %86, align 8
  %917 = getelementptr inbounds double, ptr %916, i64 %907
  call fastcc void @combine(ptr noundef %899, ptr noundef %900, ptr noundef %912, ptr noundef %913, ptr noundef %915, ptr noundef %917, i64 noundef %911, i64 noundef %781) #12
  %918 = add nuw nsw i64 %897, 1
  %919 = load i64, ptr %865, align 8
  %920 = icmp slt i64 %918, %919
  br i1 %920, label %896, label %921, !llvm.loop !21

921:                                              ; preds = %896, %861
  %922 = and i64 %795, %763
  %923 = icmp eq i64 %922, 0
  br i1 %923, label %928, label %924

924:                                              ; preds = %921
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %922, i64 noundef 3) #12
  %925 = xor i64 %922, -1
  %926 = and i64 %210, %925
  store i64 %926, ptr %10, align 8
  %927 = and i64 %756, %925
  br label %928

928:                                              ; preds = %924, %921
  %929 = phi i32 [ 1, %924 ], [ %181, %921 ]
  %930 = phi i64 [ %927, %924 ], [ %756, %921 ]
  store <8 x double> %242, ptr %7, align 16
  %931 = icmp eq i64 %930, 0
  br i1 %931, label %934, label %932

932:                                              ; preds = %928
  %933 = call fastcc i64 @look_for_events(ptr noundef nonnull %0, ptr noundef nonnull %6, i64 noundef %930, ptr noundef nonnull %7, ptr noundef nonnull %9, ptr noundef nonnull %11, ptr noundef nonnull %8, ptr noundef nonnull %12) #12
  br label %934

934:                                              ; preds = %932, %928
  %935 = phi i64 [ %933, %932 ], [ 0, %928 ]
  %936 = load i64, ptr %12, align 8
  %937 = or i64 %936, %922
  %938 = xor i64 %937, -1
  %939 = and i64 %763, %938
  %940 = icmp eq i64 %935, 0
  %941 = select i1 %940, ptr null, ptr %8
  %942 = call fastcc i64 @write_within(ptr noundef nonnull %0, ptr noundef nonnull %6, i64 noundef %939, ptr noundef nonnull %7, ptr noundef %941) #12
  %943 = load <8 x double>, ptr %7, align 16
  br i1 %940, label %949, label %944

944:                                              ; preds = %934
  %945 = xor i64 %942, -1
  %946 = and i64 %935, %945
  %947 = call fastcc i64 @end_within(ptr noundef nonnull %0, ptr noundef nonnull %6, i64 noundef %946, ptr noundef nonnull %7, ptr noundef nonnull %8) #12
  %948 = or i64 %947, %942
  br label %949

949:                                              ; preds = %944, %934
  %950 = phi i64 [ %948, %944 ], [ %942, %934 ]
  %951 = icmp ne i64 %950, 0
  %952 = select i1 %52, i1 %951, i1 false
  br i1 %952, label %953, label %958

953:                                              ; preds = %949
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %950, i64 noundef 6) #12
  %954 = xor i64 %950, -1
  %955 = load i64, ptr %10, align 8
  %956 = and i64 %955, %954
  store i64 %956, ptr %10, align 8
  %957 = and i64 %935, %954
  br label %958

958:                                              ; preds = %953, %949
  %959 = phi i32 [ 1, %953 ], [ %929, %949 ]
  %960 = phi i64 [ %957, %953 ], [ %935, %949 ]
  %961 = or i64 %950, %697
  %962 = or i64 %950, %937
  %963 = xor i64 %962, -1
  %964 = and i64 %748, %963
  br label %965

965:                                              ; preds = %958, %755
  %966 = phi <8 x double> [ %242, %755 ], [ %943, %958 ]
  %967 = phi i64 [ 0, %755 ], [ %936, %958 ]
  %968 = phi i64 [ %697, %755 ], [ %961, %958 ]
  %969 = phi i32 [ %181, %755 ], [ %959, %958 ]
  %970 = phi i64 [ %748, %755 ], [ %964, %958 ]
  %971 = phi i64 [ 0, %755 ], [ %960, %958 ]
  %972 = load ptr, ptr %106, align 8
  %973 = load <8 x double>, ptr %972, align 8
  %974 = fcmp oeq <8 x double> %973, %966
  %975 = bitcast <8 x i1> %974 to i8
  %976 = zext i8 %975 to i64
  %977 = and i64 %970, %976
  %978 = icmp eq i64 %977, 0
  br i1 %978, label %979, label %1378

979:                                              ; preds = %1378, %965
  %980 = trunc nuw i64 %970 to i8
  %981 = bitcast i8 %980 to <8 x i1>
  %982 = load ptr, ptr %63, align 8
  %983 = load <8 x double>, ptr %982, align 8
  %984 = select <8 x i1> %981, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %985 = fadd <8 x double> %984, %983
  store <8 x double> %985, ptr %982, align 8
  %986 = load ptr, ptr %64, align 8
  %987 = load <8 x double>, ptr %986, align 8
  %988 = xor <8 x i1> %981, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %989 = and <8 x i1> %212, %988
  %990 = select <8 x i1> %989, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %991 = fadd <8 x double> %990, %987
  store <8 x double> %991, ptr %986, align 8
  %992 = load ptr, ptr %117, align 8
  %993 = load ptr, ptr %0, align 8
  %994 = getelementptr inbounds i8, ptr %993, i64 8
  %995 = load i64, ptr %994, align 8
  %996 = icmp slt i64 %995, 1
  %997 = xor i64 %970, -1
  %998 = and i64 %210, %997
  %999 = trunc i64 %998 to i8
  %1000 = bitcast i8 %999 to <8 x i1>
  %1001 = load ptr, ptr %118, align 8
  %1002 = load <8 x double>, ptr %1001, align 8
  br i1 %996, label %1238, label %1003

1003:                                             ; preds = %979
  %1004 = load ptr, ptr %119, align 8
  %1005 = load <8 x double>, ptr %1004, align 8
  %1006 = load ptr, ptr %120, align 8
  %1007 = load <8 x double>, ptr %1006, align 8
  %1008 = fcmp ogt <8 x double> %675, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1009 = bitcast <8 x double> %675 to <8 x i64>
  %1010 = select <8 x i1> %1008, <8 x i64> %1009, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %1011 = getelementptr inbounds i8, ptr %992, i64 24
  %1012 = load double, ptr %1011, align 8
  %1013 = insertelement <8 x double> poison, double %1012, i64 0
  %1014 = shufflevector <8 x double> %1013, <8 x double> poison, <8 x i32> zeroinitializer
  %1015 = getelementptr inbounds i8, ptr %992, i64 8
  %1016 = load double, ptr %1015, align 8
  %1017 = fneg double %1016
  %1018 = add <8 x i64> %1010, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %1019 = ashr <8 x i64> %1018, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1020 = and <8 x i64> %1018, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %1021 = sub <8 x i64> %1010, %1020
  %1022 = bitcast <8 x i64> %1021 to <8 x double>
  %1023 = fadd <8 x double> %1022, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %1024 = fadd <8 x double> %1022, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1025 = fdiv <8 x double> %1023, %1024
  %1026 = fmul <8 x double> %1025, %1025
  %1027 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1026, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %1028 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1027, <8 x double> %1026, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %1029 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1028, <8 x double> %1026, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %1030 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1029, <8 x double> %1026, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %1031 = trunc nsw <8 x i64> %1019 to <8 x i32>
  %1032 = sitofp <8 x i32> %1031 to <8 x double>
  %1033 = fmul <8 x double> %1025, %1030
  %1034 = fadd <8 x double> %1033, %1032
  %1035 = insertelement <8 x double> poison, double %1017, i64 0
  %1036 = shufflevector <8 x double> %1035, <8 x double> poison, <8 x i32> zeroinitializer
  %1037 = fmul <8 x double> %1034, %1036
  %1038 = fcmp ogt <8 x double> %1037, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1039 = bitcast <8 x double> %1037 to <8 x i64>
  %1040 = select <8 x i1> %1038, <8 x i64> %1039, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1041 = bitcast <8 x i64> %1040 to <8 x double>
  %1042 = fcmp olt <8 x double> %1041, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1043 = bitcast <8 x i64> %1040 to <8 x double>
  %1044 = select <8 x i1> %1042, <8 x double> %1043, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1045 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1044)
  %1046 = fsub <8 x double> %1044, %1045
  %1047 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1046, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1048 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1047, <8 x double> %1046, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1049 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1048, <8 x double> %1046, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1050 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1049, <8 x double> %1046, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1051 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1050, <8 x double> %1046, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1052 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1051, <8 x double> %1046, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1053 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1052, <8 x double> %1046, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1054 = bitcast <8 x double> %1053 to <8 x i64>
  %1055 = fptosi <8 x double> %1045 to <8 x i32>
  %1056 = zext <8 x i32> %1055 to <8 x i64>
  %1057 = shl <8 x i64> %1056, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1058 = add <8 x i64> %1057, %1054
  %1059 = bitcast <8 x i64> %1058 to <8 x double>
  %1060 = fmul <8 x double> %1014, %1059
  %1061 = getelementptr inbounds i8, ptr %992, i64 16
  %1062 = load double, ptr %1061, align 8
  %1063 = fcmp une double %1062, 0.000000e+00
  br i1 %1063, label %1064, label %1109

1064:                                             ; preds = %1003
  %1065 = bitcast <8 x double> %1005 to <8 x i64>
  %1066 = add <8 x i64> %1065, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %1067 = ashr <8 x i64> %1066, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1068 = and <8 x i64> %1066, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %1069 = sub <8 x i64> %1065, %1068
  %1070 = bitcast <8 x i64> %1069 to <8 x double>
  %1071 = fadd <8 x double> %1070, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %1072 = fadd <8 x double> %1070, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1073 = fdiv <8 x double> %1071, %1072
  %1074 = fmul <8 x double> %1073, %1073
  %1075 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1074, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %1076 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1075, <8 x double> %1074, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %1077 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1076, <8 x double> %1074, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %1078 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1077, <8 x double> %1074, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %1079 = trunc nsw <8 x i64> %1067 to <8 x i32>
  %1080 = sitofp <8 x i32> %1079 to <8 x double>
  %1081 = fmul <8 x double> %1073, %1078
  %1082 = fadd <8 x double> %1081, %1080
  %1083 = insertelement <8 x double> poison, double %1062, i64 0
  %1084 = shufflevector <8 x double> %1083, <8 x double> poison, <8 x i32> zeroinitializer
  %1085 = fmul <8 x double> %1084, %1082
  %1086 = fcmp ogt <8 x double> %1085, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1087 = bitcast <8 x double> %1085 to <8 x i64>
  %1088 = select <8 x i1> %1086, <8 x i64> %1087, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1089 = bitcast <8 x i64> %1088 to <8 x double>
  %1090 = fcmp olt <8 x double> %1089, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1091 = bitcast <8 x i64> %1088 to <8 x double>
  %1092 = select <8 x i1> %1090, <8 x double> %1091, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1093 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1092)
  %1094 = fsub <8 x double> %1092, %1093
  %1095 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1094, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1096 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1095, <8 x double> %1094, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1097 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1096, <8 x double> %1094, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1098 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1097, <8 x double> %1094, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1099 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1098, <8 x double> %1094, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1100 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1099, <8 x double> %1094, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1101 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1100, <8 x double> %1094, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1102 = bitcast <8 x double> %1101 to <8 x i64>
  %1103 = fptosi <8 x double> %1093 to <8 x i32>
  %1104 = zext <8 x i32> %1103 to <8 x i64>
  %1105 = shl <8 x i64> %1104, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1106 = add <8 x i64> %1105, %1102
  %1107 = bitcast <8 x i64> %1106 to <8 x double>
  %1108 = fmul <8 x double> %1060, %1107
  br label %1109

1109:                                             ; preds = %1003, %1064
  %1110 = phi <8 x double> [ %1108, %1064 ], [ %1060, %1003 ]
  %1111 = getelementptr inbounds i8, ptr %992, i64 32
  %1112 = load double, ptr %1111, align 8
  %1113 = insertelement <8 x double> poison, double %1112, i64 0
  %1114 = shufflevector <8 x double> %1113, <8 x double> poison, <8 x i32> zeroinitializer
  %1115 = fcmp ogt <8 x double> %1110, %1114
  %1116 = select <8 x i1> %1115, <8 x double> %1110, <8 x double> %1114
  %1117 = fcmp olt <8 x double> %1007, %1116
  %1118 = select <8 x i1> %1117, <8 x double> %1007, <8 x double> %1116
  %1119 = fmul <8 x double> %244, %1118
  %1120 = fcmp oeq <8 x double> %1007, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1121 = bitcast <8 x i1> %1120 to i8
  %1122 = zext i8 %1121 to i64
  %1123 = and i64 %970, %1122
  %1124 = icmp eq i64 %1123, 0
  br i1 %1124, label %1222, label %1125

1125:                                             ; preds = %1109
  %1126 = load i64, ptr %121, align 8
  %1127 = icmp sgt i64 %1126, 0
  br i1 %1127, label %1128, label %1222

1128:                                             ; preds = %1125
  %1129 = getelementptr inbounds i8, ptr %992, i64 40
  %1130 = load double, ptr %1129, align 8
  %1131 = insertelement <8 x double> poison, double %1130, i64 0
  %1132 = shufflevector <8 x double> %1131, <8 x double> poison, <8 x i32> zeroinitializer
  br i1 %1063, label %1133, label %1178

1133:                                             ; preds = %1128
  %1134 = bitcast <8 x double> %1005 to <8 x i64>
  %1135 = add <8 x i64> %1134, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %1136 = ashr <8 x i64> %1135, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1137 = and <8 x i64> %1135, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %1138 = sub <8 x i64> %1134, %1137
  %1139 = bitcast <8 x i64> %1138 to <8 x double>
  %1140 = fadd <8 x double> %1139, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %1141 = fadd <8 x double> %1139, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1142 = fdiv <8 x double> %1140, %1141
  %1143 = fmul <8 x double> %1142, %1142
  %1144 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1143, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %1145 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1144, <8 x double> %1143, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %1146 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1145, <8 x double> %1143, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %1147 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1146, <8 x double> %1143, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %1148 = trunc nsw <8 x i64> %1136 to <8 x i32>
  %1149 = sitofp <8 x i32> %1148 to <8 x double>
  %1150 = fmul <8 x double> %1142, %1147
  %1151 = fadd <8 x double> %1150, %1149
  %1152 = insertelement <8 x double> poison, double %1062, i64 0
  %1153 = shufflevector <8 x double> %1152, <8 x double> poison, <8 x i32> zeroinitializer
  %1154 = fmul <8 x double> %1153, %1151
  %1155 = fcmp ogt <8 x double> %1154, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1156 = bitcast <8 x double> %1154 to <8 x i64>
  %1157 = select <8 x i1> %1155, <8 x i64> %1156, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1158 = bitcast <8 x i64> %1157 to <8 x double>
  %1159 = fcmp olt <8 x double> %1158, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1160 = bitcast <8 x i64> %1157 to <8 x double>
  %1161 = select <8 x i1> %1159, <8 x double> %1160, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1162 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1161)
  %1163 = fsub <8 x double> %1161, %1162
  %1164 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1163, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1165 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1164, <8 x double> %1163, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1166 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1165, <8 x double> %1163, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1167 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1166, <8 x double> %1163, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1168 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1167, <8 x double> %1163, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1169 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1168, <8 x double> %1163, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1170 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1169, <8 x double> %1163, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1171 = bitcast <8 x double> %1170 to <8 x i64>
  %1172 = fptosi <8 x double> %1162 to <8 x i32>
  %1173 = zext <8 x i32> %1172 to <8 x i64>
  %1174 = shl <8 x i64> %1173, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1175 = add <8 x i64> %1174, %1171
  %1176 = bitcast <8 x i64> %1175 to <8 x double>
  %1177 = fmul <8 x double> %1060, %1176
  br label %1178

1178:                                             ; preds = %1128, %1133
  %1179 = phi <8 x double> [ %1177, %1133 ], [ %1060, %1128 ]
  %1180 = fcmp ogt <8 x double> %1179, %1114
  %1181 = select <8 x i1> %1180, <8 x double> %1179, <8 x double> %1114
  %1182 = fcmp olt <8 x double> %1132, %1181
  %1183 = select <8 x i1> %1182, <8 x double> %1132, <8 x double> %1181
  %1184 = fmul <8 x double> %244, %1183
  store <8 x double> %1119, ptr %3, align 16
  br label %1185

1185:                                             ; preds = %1178, %1217
  %1186 = phi i64 [ 0, %1178 ], [ %1218, %1217 ]
  %1187 = shl nuw nsw i64 1, %1186
  %1188 = and i64 %1187, %1123
  %1189 = icmp eq i64 %1188, 0
  br i1 %1189, label %1217, label %1190

1190:                                             ; preds = %1185
  %1191 = extractelement <8 x double> %966, i64 %1186
  %1192 = extractelement <8 x double> %1119, i64 %1186
  %1193 = extractelement <8 x double> %1184, i64 %1186
  %1194 = load i64, ptr %122, align 8
  %1195 = icmp eq i64 %1194, 0
  br i1 %1195, label %1214, label %1196

1196:                                             ; preds = %1190
  %1197 = extractelement <8 x double> %214, i64 %1186
  %1198 = call fastcc double @knot_after(ptr noundef nonnull %14, double noundef %1197) #12
  %1199 = fsub double %1191, %1197
  %1200 = fmul double %1199, 1.000000e-03
  %1201 = fsub double %1191, %1200
  %1202 = call double @llvm.fabs.f64(double %1191)
  %1203 = fmul double %1202, 0x3D10000000000000
  %1204 = fsub double %1201, %1203
  %1205 = fcmp ogt double %1204, %1198
  %1206 = fadd double %1191, %1203
  %1207 = fcmp ogt double %1198, %1206
  %1208 = select i1 %1205, i1 true, i1 %1207
  br i1 %1208, label %1214, label %1209

1209:                                             ; preds = %1196
  %1210 = call fastcc double @knot_after(ptr noundef nonnull %14, double noundef %1191) #12
  %1211 = fsub double %1210, %1191
  %1212 = fcmp olt double %1211, %1193
  %1213 = select i1 %1212, double %1211, double %1193
  br label %1214

1214:                                             ; preds = %1190, %1196, %1209
  %1215 = phi double [ %1192, %1190 ], [ %1213, %1209 ], [ %1192, %1196 ]
  %1216 = getelementptr inbounds [8 x double], ptr %3, i64 0, i64 %1186
  store double %1215, ptr %1216, align 8
  br label %1217

1217:                                             ; preds = %1214, %1185
  %1218 = add nuw nsw i64 %1186, 1
  %1219 = icmp eq i64 %1218, 8
  br i1 %1219, label %1220, label %1185, !llvm.loop !22

1220:                                             ; preds = %1217
  %1221 = load <8 x double>, ptr %3, align 16
  br label %1222

1222:                                             ; preds = %1220, %1125, %1109
  %1223 = phi <8 x double> [ %1119, %1109 ], [ %1221, %1220 ], [ %1119, %1125 ]
  %1224 = fcmp oeq <8 x double> %966, %222
  %1225 = fcmp ogt <8 x double> %1002, %1223
  %1226 = select <8 x i1> %1224, <8 x i1> %1225, <8 x i1> zeroinitializer
  %1227 = select <8 x i1> %1226, <8 x double> %1002, <8 x double> %1223
  %1228 = fcmp ogt <8 x double> %675, <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>
  %1229 = select <8 x i1> %1228, <8 x i64> %1009, <8 x i64> <i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789>
  %1230 = bitcast <8 x double> %1005 to <8 x i64>
  %1231 = select <8 x i1> %981, <8 x i64> %1229, <8 x i64> %1230
  store <8 x i64> %1231, ptr %1004, align 8
  %1232 = load ptr, ptr %120, align 8
  %1233 = getelementptr inbounds i8, ptr %992, i64 40
  %1234 = load double, ptr %1233, align 8
  %1235 = insertelement <8 x double> poison, double %1234, i64 0
  %1236 = shufflevector <8 x double> %1235, <8 x double> poison, <8 x i32> zeroinitializer
  %1237 = select <8 x i1> %1000, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> %1236
  store <8 x double> %1237, ptr %1232, align 8
  br label %1238

1238:                                             ; preds = %1222, %979
  %1239 = phi <8 x double> [ %1002, %979 ], [ %1227, %1222 ]
  %1240 = and i64 %998, 255
  %1241 = icmp eq i64 %1240, 0
  br i1 %1241, label %1373, label %1242

1242:                                             ; preds = %1238
  %1243 = trunc i64 %747 to i8
  %1244 = bitcast i8 %1243 to <8 x i1>
  %1245 = trunc i64 %968 to i8
  %1246 = bitcast i8 %1245 to <8 x i1>
  %1247 = trunc i64 %967 to i8
  %1248 = bitcast i8 %1247 to <8 x i1>
  %1249 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %675)
  %1250 = fcmp one <8 x double> %1249, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1251 = xor <8 x i1> %1244, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1252 = select <8 x i1> %1250, <8 x i1> %1251, <8 x i1> zeroinitializer
  %1253 = or <8 x i1> %1246, %1248
  %1254 = xor <8 x i1> %1253, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1255 = and <8 x i1> %1252, %1254
  br i1 %996, label %1317, label %1256

1256:                                             ; preds = %1242
  %1257 = fcmp ogt <8 x double> %675, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1258 = bitcast <8 x double> %675 to <8 x i64>
  %1259 = select <8 x i1> %1257, <8 x i64> %1258, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %1260 = getelementptr inbounds i8, ptr %992, i64 24
  %1261 = load double, ptr %1260, align 8
  %1262 = insertelement <8 x double> poison, double %1261, i64 0
  %1263 = shufflevector <8 x double> %1262, <8 x double> poison, <8 x i32> zeroinitializer
  %1264 = load double, ptr %992, align 8
  %1265 = fneg double %1264
  %1266 = add <8 x i64> %1259, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %1267 = ashr <8 x i64> %1266, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1268 = and <8 x i64> %1266, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %1269 = sub <8 x i64> %1259, %1268
  %1270 = bitcast <8 x i64> %1269 to <8 x double>
  %1271 = fadd <8 x double> %1270, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %1272 = fadd <8 x double> %1270, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1273 = fdiv <8 x double> %1271, %1272
  %1274 = fmul <8 x double> %1273, %1273
  %1275 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1274, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %1276 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1275, <8 x double> %1274, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %1277 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1276, <8 x double> %1274, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %1278 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1277, <8 x double> %1274, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %1279 = trunc nsw <8 x i64> %1267 to <8 x i32>
  %1280 = sitofp <8 x i32> %1279 to <8 x double>
  %1281 = fmul <8 x double> %1273, %1278
  %1282 = fadd <8 x double> %1281, %1280
  %1283 = insertelement <8 x double> poison, double %1265, i64 0
  %1284 = shufflevector <8 x double> %1283, <8 x double> poison, <8 x i32> zeroinitializer
  %1285 = fmul <8 x double> %1282, %1284
  %1286 = fcmp ogt <8 x double> %1285, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1287 = bitcast <8 x double> %1285 to <8 x i64>
  %1288 = select <8 x i1> %1286, <8 x i64> %1287, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1289 = bitcast <8 x i64> %1288 to <8 x double>
  %1290 = fcmp olt <8 x double> %1289, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1291 = bitcast <8 x i64> %1288 to <8 x double>
  %1292 = select <8 x i1> %1290, <8 x double> %1291, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1293 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1292)
  %1294 = fsub <8 x double> %1292, %1293
  %1295 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1294, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1296 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1295, <8 x double> %1294, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1297 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1296, <8 x double> %1294, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1298 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1297, <8 x double> %1294, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1299 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1298, <8 x double> %1294, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1300 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1299, <8 x double> %1294, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1301 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1300, <8 x double> %1294, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1302 = bitcast <8 x double> %1301 to <8 x i64>
  %1303 = fptosi <8 x double> %1293 to <8 x i32>
  %1304 = zext <8 x i32> %1303 to <8 x i64>
  %1305 = shl <8 x i64> %1304, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1306 = add <8 x i64> %1305, %1302
  %1307 = bitcast <8 x i64> %1306 to <8 x double>
  %1308 = fmul <8 x double> %1263, %1307
  %1309 = getelementptr inbounds i8, ptr %992, i64 32
  %1310 = load double, ptr %1309, align 8
  %1311 = insertelement <8 x double> poison, double %1310, i64 0
  %1312 = shufflevector <8 x double> %1311, <8 x double> poison, <8 x i32> zeroinitializer
  %1313 = fcmp ogt <8 x double> %1308, %1312
  %1314 = select <8 x i1> %1313, <8 x double> %1308, <8 x double> %1312
  %1315 = select <8 x i1> %1255, <8 x double> %1314, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1316 = fmul <8 x double> %244, %1315
  br label %1317

1317:                                             ; preds = %1256, %1242
  %1318 = phi <8 x double> [ zeroinitializer, %1242 ], [ %1316, %1256 ]
  %1319 = or <8 x i1> %1255, %1248
  %1320 = select <8 x i1> %1319, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %1321 = select <8 x i1> %1000, <8 x double> %1318, <8 x double> %1239
  br i1 %996, label %1363, label %1322

1322:                                             ; preds = %1317
  %1323 = load i64, ptr %123, align 8
  %1324 = icmp sgt i64 %1323, 0
  br i1 %1324, label %1325, label %1363

1325:                                             ; preds = %1322
  %1326 = and <8 x i1> %1255, %1000
  %1327 = bitcast <8 x i1> %1326 to i8
  %1328 = zext i8 %1327 to i64
  store <8 x double> %1321, ptr %2, align 16
  br label %1329

1329:                                             ; preds = %1325, %1358
  %1330 = phi i64 [ 0, %1325 ], [ %1359, %1358 ]
  %1331 = shl nuw nsw i64 1, %1330
  %1332 = and i64 %1331, %1328
  %1333 = icmp eq i64 %1332, 0
  br i1 %1333, label %1358, label %1334

1334:                                             ; preds = %1329
  %1335 = extractelement <8 x double> %214, i64 %1330
  %1336 = extractelement <8 x double> %1321, i64 %1330
  %1337 = load i64, ptr %124, align 8
  %1338 = icmp eq i64 %1337, 0
  br i1 %1338, label %1355, label %1339

1339:                                             ; preds = %1334
  %1340 = extractelement <8 x double> %966, i64 %1330
  %1341 = call fastcc double @knot_after(ptr noundef nonnull %14, double noundef %1335) #12
  %1342 = fsub double %1340, %1335
  %1343 = fmul double %1342, 1.000000e-03
  %1344 = fsub double %1340, %1343
  %1345 = call double @llvm.fabs.f64(double %1340)
  %1346 = fmul double %1345, 0x3D10000000000000
  %1347 = fsub double %1344, %1346
  %1348 = fcmp ogt double %1347, %1341
  br i1 %1348, label %1349, label %1355

1349:                                             ; preds = %1339
  %1350 = call fastcc double @knot_after(ptr noundef nonnull %14, double noundef %1341) #12
  %1351 = fadd double %1335, %1336
  %1352 = fcmp ugt double %1350, %1351
  br i1 %1352, label %1353, label %1355

1353:                                             ; preds = %1349
  %1354 = fsub double %1341, %1335
  br label %1355

1355:                                             ; preds = %1334, %1339, %1349, %1353
  %1356 = phi double [ %1336, %1334 ], [ %1354, %1353 ], [ %1336, %1349 ], [ %1336, %1339 ]
  %1357 = getelementptr inbounds [8 x double], ptr %2, i64 0, i64 %1330
  store double %1356, ptr %1357, align 8
  br label %1358

1358:                                             ; preds = %1329, %1355
  %1359 = add nuw nsw i64 %1330, 1
  %1360 = icmp eq i64 %1359, 8
  br i1 %1360, label %1361, label %1329, !llvm.loop !22

1361:                                             ; preds = %1358
  %1362 = load <8 x double>, ptr %2, align 16
  br label %1363

1363:                                             ; preds = %1361, %1322, %1317
  %1364 = phi <8 x double> [ %1362, %1361 ], [ %1321, %1322 ], [ %1321, %1317 ]
  %1365 = load ptr, ptr %125, align 8
  %1366 = select <8 x i1> %1246, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> %1320
  %1367 = load <8 x i64>, ptr %1365, align 8
  %1368 = select <8 x i1> %1000, <8 x i64> %1366, <8 x i64> %1367
  store <8 x i64> %1368, ptr %1365, align 8
  %1369 = load ptr, ptr %125, align 8
  %1370 = select <8 x i1> %1244, <8 x i64> <i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152>, <8 x i64> %1320
  %1371 = load <8 x i64>, ptr %1369, align 8
  %1372 = select <8 x i1> %1000, <8 x i64> %1370, <8 x i64> %1371
  store <8 x i64> %1372, ptr %1369, align 8
  br label %1373

1373:                                             ; preds = %1238, %1363
  %1374 = phi <8 x double> [ %1239, %1238 ], [ %1364, %1363 ]
  %1375 = load ptr, ptr %118, align 8
  store <8 x double> %1374, ptr %1375, align 8
  %1376 = load ptr, ptr %48, align 8
  %1377 = select <8 x i1> %981, <8 x double> %966, <8 x double> %214
  store <8 x double> %1377, ptr %1376, align 8
  br i1 %126, label %1395, label %1388

1378:                                             ; preds = %965, %1378
  %1379 = phi i64 [ %1386, %1378 ], [ %977, %965 ]
  %1380 = load ptr, ptr %116, align 8
  call fastcc void @write_outputs(ptr noundef nonnull %0, ptr noundef %1380, i64 noundef %1379) #12
  %1381 = load ptr, ptr %106, align 8
  %1382 = load <8 x double>, ptr %1381, align 8
  %1383 = fcmp oeq <8 x double> %1382, %966
  %1384 = bitcast <8 x i1> %1383 to i8
  %1385 = zext i8 %1384 to i64
  %1386 = and i64 %1379, %1385
  %1387 = icmp eq i64 %1386, 0
  br i1 %1387, label %979, label %1378, !llvm.loop !24

1388:                                             ; preds = %1395, %1373
  %1389 = load ptr, ptr %128, align 8
  %1390 = load ptr, ptr %68, align 8
  %1391 = load i64, ptr %1390, align 8
  %1392 = load i64, ptr %129, align 8
  %1393 = mul nsw i64 %1392, %1391
  %1394 = getelementptr inbounds double, ptr %1389, i64 %1393
  br i1 %130, label %1409, label %1407

1395:                                             ; preds = %1373, %1395
  %1396 = phi i64 [ %1405, %1395 ], [ 0, %1373 ]
  %1397 = load ptr, ptr %16, align 8
  %1398 = load ptr, ptr %127, align 8
  %1399 = shl nsw i64 %1396, 6
  %1400 = getelementptr inbounds i8, ptr %1398, i64 %1399
  %1401 = load <8 x i64>, ptr %1400, align 8
  %1402 = getelementptr inbounds i8, ptr %1397, i64 %1399
  %1403 = load <8 x i64>, ptr %1402, align 8
  %1404 = select <8 x i1> %981, <8 x i64> %1401, <8 x i64> %1403
  store <8 x i64> %1404, ptr %1402, align 8
  %1405 = add nuw nsw i64 %1396, 1
  %1406 = icmp eq i64 %1405, %20
  br i1 %1406, label %1388, label %1395, !llvm.loop !25

1407:                                             ; preds = %1409, %1388
  %1408 = icmp eq i64 %971, 0
  br i1 %1408, label %1430, label %1420

1409:                                             ; preds = %1388, %1409
  %1410 = phi i64 [ %1418, %1409 ], [ 0, %1388 ]
  %1411 = load ptr, ptr %128, align 8
  %1412 = shl nsw i64 %1410, 6
  %1413 = getelementptr inbounds i8, ptr %1394, i64 %1412
  %1414 = load <8 x i64>, ptr %1413, align 8
  %1415 = getelementptr inbounds i8, ptr %1411, i64 %1412
  %1416 = load <8 x i64>, ptr %1415, align 8
  %1417 = select <8 x i1> %981, <8 x i64> %1414, <8 x i64> %1416
  store <8 x i64> %1417, ptr %1415, align 8
  %1418 = add nuw nsw i64 %1410, 1
  %1419 = icmp eq i64 %1418, %20
  br i1 %1419, label %1407, label %1409, !llvm.loop !26

1420:                                             ; preds = %1407
  %1421 = call fastcc i64 @act_in_lanes(ptr noundef nonnull %0, i64 noundef %971, ptr noundef nonnull %11) #12
  %1422 = icmp ne i32 %969, 0
  %1423 = icmp ne i64 %1421, %971
  %1424 = select i1 %1422, i1 true, i1 %1423
  %1425 = zext i1 %1424 to i32
  %1426 = trunc i64 %971 to i8
  %1427 = bitcast i8 %1426 to <8 x i1>
  %1428 = xor <8 x i1> %1427, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1429 = and <8 x i1> %1428, %981
  br label %1430

1430:                                             ; preds = %1420, %1407
  %1431 = phi i32 [ %1425, %1420 ], [ %969, %1407 ]
  %1432 = phi <8 x i1> [ %1429, %1420 ], [ %981, %1407 ]
  %1433 = phi i64 [ %1421, %1420 ], [ %182, %1407 ]
  %1434 = load ptr, ptr %106, align 8
  %1435 = load <8 x double>, ptr %1434, align 8
  %1436 = fcmp oeq <8 x double> %1435, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1437 = select <8 x i1> %1436, <8 x i1> %1432, <8 x i1> zeroinitializer
  %1438 = bitcast <8 x i1> %1437 to i8
  %1439 = zext i8 %1438 to i64
  %1440 = icmp eq i8 %1438, 0
  br i1 %1440, label %1442, label %1441

1441:                                             ; preds = %1430
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %1439, i64 noundef 0) #12
  br label %1442

1442:                                             ; preds = %1441, %1430
  %1443 = phi i32 [ 1, %1441 ], [ %1431, %1430 ]
  %1444 = fcmp oeq <8 x double> %966, %220
  %1445 = select <8 x i1> %1444, <8 x i1> %1432, <8 x i1> zeroinitializer
  %1446 = bitcast <8 x i1> %1445 to i8
  %1447 = zext i8 %1446 to i64
  %1448 = xor i64 %1439, -1
  %1449 = and i64 %1448, %1447
  %1450 = icmp eq i64 %1449, 0
  br i1 %1450, label %1455, label %1451

1451:                                             ; preds = %1442
  %1452 = call fastcc i64 @start_again(ptr noundef nonnull %0, ptr noundef nonnull %6, i64 noundef %1449) #12
  %1453 = icmp eq i64 %1452, 0
  %1454 = select i1 %1453, i32 %1443, i32 1
  br label %1455

1455:                                             ; preds = %1451, %1442
  %1456 = phi i32 [ %1443, %1442 ], [ %1454, %1451 ]
  br label %177

1457:                                             ; preds = %180, %205, %173
  %1458 = phi i64 [ 1, %173 ], [ 0, %205 ], [ 0, %180 ]
  ret i64 %1458
}



define internal fastcc i64 @fill(ptr noundef readonly %0, ptr noundef writeonly %1) unnamed_addr #2 {
  %3 = getelementptr inbounds i8, ptr %0, i64 696
  %4 = getelementptr inbounds i8, ptr %0, i64 984
  %5 = getelementptr inbounds i8, ptr %0, i64 144
  %6 = getelementptr inbounds i8, ptr %0, i64 432
  %7 = load ptr, ptr %4, align 8
  %8 = getelementptr inbounds i8, ptr %0, i64 1152
  %9 = getelementptr inbounds i8, ptr %0, i64 1064
  %10 = getelementptr inbounds i8, ptr %0, i64 1056
  %11 = getelementptr inbounds i8, ptr %0, i64 936
  %12 = getelementptr inbounds i8, ptr %0, i64 1168
  %13 = getelementptr inbounds i8, ptr %0, i64 1072
  %14 = getelementptr inbounds i8, ptr %0, i64 1080
  %15 = getelementptr inbounds i8, ptr %0, i64 192
  %16 = getelementptr inbounds i8, ptr %0, i64 1096
  %17 = getelementptr inbounds i8, ptr %0, i64 1104
  %18 = getelementptr inbounds i8, ptr %0, i64 216
  %19 = getelementptr inbounds i8, ptr %0, i64 1120
  %20 = getelementptr inbounds i8, ptr %0, i64 1128
  %21 = getelementptr inbounds i8, ptr %0, i64 672
  %22 = getelementptr inbounds i8, ptr %0, i64 1144
  %23 = getelementptr inbounds i8, ptr %0, i64 1200
  %24 = getelementptr inbounds i8, ptr %0, i64 1728
  %25 = getelementptr inbounds i8, ptr %0, i64 1736
  %26 = getelementptr inbounds i8, ptr %0, i64 1216
  %27 = getelementptr inbounds i8, ptr %0, i64 1216
  %28 = getelementptr inbounds i8, ptr %0, i64 1232
  %29 = getelementptr inbounds i8, ptr %0, i64 1272
  %30 = getelementptr inbounds i8, ptr %0, i64 1224
  %31 = getelementptr inbounds i8, ptr %0, i64 1096
  %32 = getelementptr inbounds i8, ptr %0, i64 1256
  %33 = getelementptr inbounds i8, ptr %0, i64 1248
  %34 = getelementptr inbounds i8, ptr %0, i64 1264
  %35 = getelementptr inbounds i8, ptr %0, i64 1120
  %36 = getelementptr inbounds i8, ptr %0, i64 1488
  %37 = getelementptr inbounds i8, ptr %0, i64 1504
  %38 = getelementptr inbounds i8, ptr %0, i64 1440
  %39 = getelementptr inbounds i8, ptr %0, i64 1512
  %40 = getelementptr inbounds i8, ptr %0, i64 1528
  %41 = getelementptr inbounds i8, ptr %0, i64 1464
  %42 = getelementptr inbounds i8, ptr %0, i64 1032
  br label %43

43:                                               ; preds = %2, %301
  %44 = phi i64 [ 0, %2 ], [ %311, %301 ]
  %45 = phi i64 [ 0, %2 ], [ %302, %301 ]
  %46 = phi i64 [ -1, %2 ], [ %310, %301 ]
  %47 = phi i64 [ 0, %2 ], [ %309, %301 ]
  %48 = load i64, ptr %7, align 8
  %49 = load i64, ptr %9, align 8
  %50 = icmp sge i64 %48, %49
  br i1 %50, label %83, label %51

51:                                               ; preds = %43
  %52 = load ptr, ptr %8, align 8
  %53 = load i64, ptr %12, align 8
  %54 = mul nsw i64 %53, %48
  %55 = getelementptr i64, ptr %52, i64 %54
  %56 = getelementptr i8, ptr %55, i64 24
  %57 = load i64, ptr %56, align 8
  %58 = icmp eq i64 %57, 0
  br i1 %58, label %83, label %78

59:                                               ; preds = %301
  store i64 %309, ptr %1, align 8
  %60 = icmp slt i64 %310, 0
  br i1 %60, label %434, label %61

61:                                               ; preds = %59
  %62 = getelementptr inbounds i8, ptr %0, i64 936
  %63 = getelementptr inbounds i8, ptr %0, i64 600
  %64 = getelementptr inbounds i8, ptr %0, i64 192
  %65 = getelementptr inbounds i8, ptr %0, i64 216
  %66 = getelementptr inbounds i8, ptr %0, i64 672
  %67 = getelementptr inbounds i8, ptr %0, i64 1144
  %68 = getelementptr inbounds i8, ptr %0, i64 720
  %69 = getelementptr inbounds i8, ptr %0, i64 816
  br label %336

70:                                               ; preds = %78
  %71 = load ptr, ptr %8, align 8
  %72 = load i64, ptr %12, align 8
  %73 = mul nsw i64 %72, %80
  %74 = getelementptr i64, ptr %71, i64 %73
  %75 = getelementptr i8, ptr %74, i64 24
  %76 = load i64, ptr %75, align 8
  %77 = icmp eq i64 %76, 0
  br i1 %77, label %83, label %78, !llvm.loop !27

78:                                               ; preds = %51, %70
  %79 = phi i64 [ %80, %70 ], [ %48, %51 ]
  %80 = add nsw i64 %79, 1
  store i64 %80, ptr %7, align 8
  %81 = load i64, ptr %9, align 8
  %82 = icmp sge i64 %80, %81
  br i1 %82, label %83, label %70, !llvm.loop !27

83:                                               ; preds = %78, %70, %51, %43
  %84 = phi i64 [ %48, %43 ], [ %48, %51 ], [ %80, %70 ], [ %80, %78 ]
  %85 = phi i1 [ %50, %43 ], [ %50, %51 ], [ %82, %70 ], [ %82, %78 ]
  %86 = load ptr, ptr %11, align 8
  %87 = getelementptr inbounds i64, ptr %86, i64 %44
  %88 = load i64, ptr %87, align 8
  %89 = icmp ne i64 %88, -1
  %90 = or i1 %85, %89
  br i1 %90, label %301, label %91

91:                                               ; preds = %83
  %92 = add nsw i64 %84, 1
  store i64 %92, ptr %7, align 8
  %93 = load ptr, ptr %11, align 8
  %94 = getelementptr inbounds i64, ptr %93, i64 %44
  store i64 %84, ptr %94, align 8
  %95 = load ptr, ptr %6, align 8
  %96 = load ptr, ptr %10, align 8
  %97 = load i64, ptr %13, align 8
  %98 = mul nsw i64 %97, %84
  %99 = getelementptr inbounds double, ptr %96, i64 %98
  %100 = getelementptr double, ptr %95, i64 %44
  %101 = icmp sgt i64 %97, 0
  br i1 %101, label %102, label %111

102:                                              ; preds = %91, %102
  %103 = phi i64 [ %108, %102 ], [ 0, %91 ]
  %104 = getelementptr inbounds double, ptr %99, i64 %103
  %105 = load double, ptr %104, align 8
  %106 = shl i64 %103, 6
  %107 = getelementptr i8, ptr %100, i64 %106
  store double %105, ptr %107, align 8
  %108 = add nuw nsw i64 %103, 1
  %109 = load i64, ptr %13, align 8
  %110 = icmp slt i64 %108, %109
  br i1 %110, label %102, label %111, !llvm.loop !28

111:                                              ; preds = %102, %91
  %112 = load ptr, ptr %15, align 8
  %113 = load ptr, ptr %14, align 8
  %114 = load i64, ptr %16, align 8
  %115 = mul nsw i64 %114, %84
  %116 = getelementptr inbounds double, ptr %113, i64 %115
  %117 = getelementptr double, ptr %112, i64 %44
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
  %126 = load i64, ptr %16, align 8
  %127 = icmp slt i64 %125, %126
  br i1 %127, label %119, label %128, !llvm.loop !28

128:                                              ; preds = %119, %111
  %129 = load ptr, ptr %18, align 8
  %130 = load ptr, ptr %17, align 8
  %131 = load i64, ptr %19, align 8
  %132 = mul nsw i64 %131, %84
  %133 = getelementptr inbounds double, ptr %130, i64 %132
  %134 = getelementptr double, ptr %129, i64 %44
  %135 = icmp sgt i64 %131, 0
  br i1 %135, label %136, label %145

136:                                              ; preds = %128, %136
  %137 = phi i64 [ %142, %136 ], [ 0, %128 ]
  %138 = getelementptr inbounds double, ptr %133, i64 %137
  %139 = load double, ptr %138, align 8
  %140 = shl i64 %137, 6
  %141 = getelementptr i8, ptr %134, i64 %140
  store double %139, ptr %141, align 8
  %142 = add nuw nsw i64 %137, 1
  %143 = load i64, ptr %19, align 8
  %144 = icmp slt i64 %142, %143
  br i1 %144, label %136, label %145, !llvm.loop !28

145:                                              ; preds = %136, %128
  %146 = load ptr, ptr %21, align 8
  %147 = load ptr, ptr %5, align 8
  %148 = getelementptr inbounds i8, ptr %147, i64 24
  %149 = load i64, ptr %148, align 8
  %150 = shl nsw i64 %149, 6
  %151 = getelementptr inbounds i8, ptr %146, i64 %150
  %152 = load ptr, ptr %20, align 8
  %153 = load i64, ptr %22, align 8
  %154 = mul nsw i64 %153, %84
  %155 = getelementptr inbounds double, ptr %152, i64 %154
  %156 = getelementptr double, ptr %151, i64 %44
  %157 = icmp sgt i64 %153, 0
  br i1 %157, label %158, label %167

158:                                              ; preds = %145, %158
  %159 = phi i64 [ %164, %158 ], [ 0, %145 ]
  %160 = getelementptr inbounds double, ptr %155, i64 %159
  %161 = load double, ptr %160, align 8
  %162 = shl i64 %159, 6
  %163 = getelementptr i8, ptr %156, i64 %162
  store double %161, ptr %163, align 8
  %164 = add nuw nsw i64 %159, 1
  %165 = load i64, ptr %22, align 8
  %166 = icmp slt i64 %164, %165
  br i1 %166, label %158, label %167, !llvm.loop !28

167:                                              ; preds = %158, %145
  %168 = load ptr, ptr %24, align 8
  %169 = load i64, ptr %25, align 8
  %170 = getelementptr inbounds double, ptr %168, i64 %169
  %171 = load i64, ptr %26, align 8
  %172 = mul i64 %171, -64
  %173 = getelementptr inbounds i8, ptr %170, i64 %172
  %174 = load ptr, ptr %23, align 8
  %175 = mul nsw i64 %171, %84
  %176 = getelementptr inbounds double, ptr %174, i64 %175
  %177 = getelementptr double, ptr %173, i64 %44
  %178 = load i64, ptr %27, align 8
  %179 = icmp sgt i64 %178, 0
  br i1 %179, label %180, label %189

180:                                              ; preds = %167, %180
  %181 = phi i64 [ %186, %180 ], [ 0, %167 ]
  %182 = getelementptr inbounds double, ptr %176, i64 %181
  %183 = load double, ptr %182, align 8
  %184 = shl i64 %181, 6
  %185 = getelementptr i8, ptr %177, i64 %184
  store double %183, ptr %185, align 8
  %186 = add nuw nsw i64 %181, 1
  %187 = load i64, ptr %27, align 8
  %188 = icmp slt i64 %186, %187
  br i1 %188, label %180, label %189, !llvm.loop !28

189:                                              ; preds = %180, %167
  %190 = load i64, ptr %28, align 8
  %191 = icmp sgt i64 %190, 0
  br i1 %191, label %192, label %294

192:                                              ; preds = %189
  %193 = load ptr, ptr %30, align 8
  %194 = getelementptr inbounds i64, ptr %193, i64 %44
  %195 = load i64, ptr %194, align 8
  %196 = inttoptr i64 %195 to ptr
  %197 = load i64, ptr %31, align 8
  %198 = icmp sgt i64 %197, 0
  br i1 %198, label %199, label %201

199:                                              ; preds = %192
  %200 = getelementptr inbounds i8, ptr %196, i64 192
  br label %204

201:                                              ; preds = %204, %192
  %202 = load i64, ptr %32, align 8
  %203 = icmp sgt i64 %202, 0
  br i1 %203, label %225, label %217

204:                                              ; preds = %199, %204
  %205 = phi i64 [ %197, %199 ], [ %215, %204 ]
  %206 = phi i64 [ 0, %199 ], [ %214, %204 ]
  %207 = load ptr, ptr %14, align 8
  %208 = mul nsw i64 %205, %84
  %209 = getelementptr double, ptr %207, i64 %208
  %210 = getelementptr double, ptr %209, i64 %206
  %211 = load double, ptr %210, align 8
  %212 = load ptr, ptr %200, align 8
  %213 = getelementptr inbounds double, ptr %212, i64 %206
  store double %211, ptr %213, align 8
  %214 = add nuw nsw i64 %206, 1
  %215 = load i64, ptr %31, align 8
  %216 = icmp slt i64 %214, %215
  br i1 %216, label %204, label %201, !llvm.loop !29

217:                                              ; preds = %225, %201
  %218 = load ptr, ptr %29, align 8
  %219 = getelementptr inbounds i8, ptr %218, i64 8
  %220 = load i64, ptr %219, align 8
  %221 = icmp sgt i64 %220, 0
  br i1 %221, label %222, label %290

222:                                              ; preds = %217
  %223 = getelementptr inbounds i8, ptr %196, i64 1248
  %224 = getelementptr inbounds i8, ptr %196, i64 1008
  br label %245

225:                                              ; preds = %201, %225
  %226 = phi i64 [ %242, %225 ], [ 0, %201 ]
  %227 = load ptr, ptr %33, align 8
  %228 = load i64, ptr %34, align 8
  %229 = mul nsw i64 %228, %226
  %230 = getelementptr inbounds i64, ptr %227, i64 %229
  %231 = load i64, ptr %230, align 8
  %232 = inttoptr i64 %231 to ptr
  %233 = load ptr, ptr %232, align 8
  %234 = load ptr, ptr %17, align 8
  %235 = load i64, ptr %35, align 8
  %236 = mul nsw i64 %235, %84
  %237 = getelementptr inbounds double, ptr %234, i64 %236
  %238 = getelementptr i64, ptr %230, i64 %44
  %239 = getelementptr i8, ptr %238, i64 8
  %240 = load i64, ptr %239, align 8
  %241 = inttoptr i64 %240 to ptr
  tail call void %233(ptr noundef %237, ptr noundef %241) #13
  %242 = add nuw nsw i64 %226, 1
  %243 = load i64, ptr %32, align 8
  %244 = icmp slt i64 %242, %243
  br i1 %244, label %225, label %217, !llvm.loop !30

245:                                              ; preds = %222, %259
  %246 = phi i64 [ 0, %222 ], [ %268, %259 ]
  %247 = load ptr, ptr %36, align 8
  %248 = load i64, ptr %37, align 8
  %249 = mul nsw i64 %248, %84
  %250 = getelementptr i64, ptr %247, i64 %249
  %251 = getelementptr i64, ptr %250, i64 %246
  %252 = load i64, ptr %251, align 8
  %253 = sitofp i64 %252 to double
  %254 = load ptr, ptr %38, align 8
  %255 = shl i64 %246, 6
  %256 = getelementptr i8, ptr %254, i64 %255
  %257 = getelementptr double, ptr %256, i64 %44
  store double %253, ptr %257, align 8
  %258 = mul i64 %246, 800
  br label %273

259:                                              ; preds = %283
  %260 = load ptr, ptr %224, align 8
  %261 = shl nuw nsw i64 %246, 1
  %262 = or disjoint i64 %261, 1
  %263 = getelementptr inbounds double, ptr %260, i64 %262
  store double 0x7FF8000000000000, ptr %263, align 8
  %264 = load ptr, ptr %224, align 8
  %265 = getelementptr inbounds double, ptr %264, i64 %261
  store double 0x7FF8000000000000, ptr %265, align 8
  %266 = load ptr, ptr %41, align 8
  %267 = getelementptr inbounds double, ptr %266, i64 %44
  store double 0x7FF8000000000000, ptr %267, align 8
  %268 = add nuw nsw i64 %246, 1
  %269 = load ptr, ptr %29, align 8
  %270 = getelementptr inbounds i8, ptr %269, i64 8
  %271 = load i64, ptr %270, align 8
  %272 = icmp slt i64 %268, %271
  br i1 %272, label %245, label %290, !llvm.loop !31

273:                                              ; preds = %245, %283
  %274 = phi i64 [ 0, %245 ], [ %288, %283 ]
  %275 = icmp eq i64 %274, 0
  br i1 %275, label %276, label %283

276:                                              ; preds = %273
  %277 = load ptr, ptr %39, align 8
  %278 = load i64, ptr %40, align 8
  %279 = mul nsw i64 %278, %84
  %280 = getelementptr double, ptr %277, i64 %279
  %281 = getelementptr double, ptr %280, i64 %246
  %282 = load double, ptr %281, align 8
  br label %283

283:                                              ; preds = %276, %273
  %284 = phi double [ %282, %276 ], [ 0xFFF0000000000000, %273 ]
  %285 = load ptr, ptr %223, align 8
  %286 = getelementptr inbounds i8, ptr %285, i64 %258
  %287 = getelementptr inbounds double, ptr %286, i64 %274
  store double %284, ptr %287, align 8
  %288 = add nuw nsw i64 %274, 1
  %289 = icmp eq i64 %288, 100
  br i1 %289, label %259, label %273, !llvm.loop !32

290:                                              ; preds = %259, %217
  %291 = getelementptr inbounds i8, ptr %196, i64 648
  %292 = load ptr, ptr %291, align 8
  %293 = getelementptr inbounds i8, ptr %292, i64 80
  store i64 0, ptr %293, align 8
  br label %294

294:                                              ; preds = %290, %189
  %295 = load ptr, ptr %42, align 8
  %296 = load double, ptr %295, align 8
  %297 = load ptr, ptr %3, align 8
  %298 = getelementptr inbounds double, ptr %297, i64 %44
  store double %296, ptr %298, align 8
  %299 = shl nuw nsw i64 1, %44
  %300 = or i64 %299, %45
  br label %301

301:                                              ; preds = %83, %294
  %302 = phi i64 [ %300, %294 ], [ %45, %83 ]
  %303 = load ptr, ptr %11, align 8
  %304 = getelementptr inbounds i64, ptr %303, i64 %44
  %305 = load i64, ptr %304, align 8
  %306 = icmp sgt i64 %305, -1
  %307 = shl nuw nsw i64 1, %44
  %308 = select i1 %306, i64 %307, i64 0
  %309 = or i64 %308, %47
  %310 = select i1 %306, i64 %44, i64 %46
  %311 = add nuw nsw i64 %44, 1
  %312 = icmp eq i64 %311, 8
  br i1 %312, label %59, label %43, !llvm.loop !33

313:                                              ; preds = %431
  %314 = getelementptr inbounds i8, ptr %0, i64 272
  %315 = load i64, ptr %314, align 8
  %316 = icmp sgt i64 %315, 0
  br i1 %316, label %317, label %434

317:                                              ; preds = %313
  %318 = getelementptr inbounds i8, ptr %0, i64 264
  %319 = getelementptr inbounds i8, ptr %0, i64 216
  br label %320

320:                                              ; preds = %317, %320
  %321 = phi i64 [ 0, %317 ], [ %333, %320 ]
  %322 = load ptr, ptr %318, align 8
  %323 = shl nuw nsw i64 %321, 1
  %324 = getelementptr inbounds i64, ptr %322, i64 %323
  %325 = load i64, ptr %324, align 8
  %326 = inttoptr i64 %325 to ptr
  %327 = load ptr, ptr %326, align 8
  %328 = load ptr, ptr %319, align 8
  %329 = or disjoint i64 %323, 1
  %330 = getelementptr inbounds i64, ptr %322, i64 %329
  %331 = load i64, ptr %330, align 8
  %332 = inttoptr i64 %331 to ptr
  tail call void %327(ptr noundef %328, ptr noundef %332) #13
  %333 = add nuw nsw i64 %321, 1
  %334 = load i64, ptr %314, align 8
  %335 = icmp slt i64 %333, %334
  br i1 %335, label %320, label %434, !llvm.loop !34

336:                                              ; preds = %61, %431
  %337 = phi i64 [ 0, %61 ], [ %432, %431 ]
  %338 = load ptr, ptr %62, align 8
  %339 = getelementptr inbounds i64, ptr %338, i64 %337
  %340 = load i64, ptr %339, align 8
  %341 = icmp eq i64 %340, -1
  br i1 %341, label %342, label %431

342:                                              ; preds = %336
  %343 = load ptr, ptr %6, align 8
  %344 = load ptr, ptr %5, align 8
  %345 = getelementptr inbounds i8, ptr %344, i64 8
  %346 = load i64, ptr %345, align 8
  %347 = icmp sgt i64 %346, 0
  br i1 %347, label %348, label %357

348:                                              ; preds = %342, %348
  %349 = phi i64 [ %355, %348 ], [ 0, %342 ]
  %350 = shl i64 %349, 6
  %351 = getelementptr i8, ptr %343, i64 %350
  %352 = getelementptr double, ptr %351, i64 %310
  %353 = load double, ptr %352, align 8
  %354 = getelementptr double, ptr %351, i64 %337
  store double %353, ptr %354, align 8
  %355 = add nuw nsw i64 %349, 1
  %356 = icmp eq i64 %355, %346
  br i1 %356, label %357, label %348, !llvm.loop !35

357:                                              ; preds = %348, %342
  %358 = load ptr, ptr %63, align 8
  %359 = load ptr, ptr %5, align 8
  %360 = getelementptr inbounds i8, ptr %359, i64 8
  %361 = load i64, ptr %360, align 8
  %362 = icmp sgt i64 %361, 0
  br i1 %362, label %363, label %372

363:                                              ; preds = %357, %363
  %364 = phi i64 [ %370, %363 ], [ 0, %357 ]
  %365 = shl i64 %364, 6
  %366 = getelementptr i8, ptr %358, i64 %365
  %367 = getelementptr double, ptr %366, i64 %310
  %368 = load double, ptr %367, align 8
  %369 = getelementptr double, ptr %366, i64 %337
  store double %368, ptr %369, align 8
  %370 = add nuw nsw i64 %364, 1
  %371 = icmp eq i64 %370, %361
  br i1 %371, label %372, label %363, !llvm.loop !35

372:                                              ; preds = %363, %357
  %373 = load ptr, ptr %64, align 8
  %374 = load ptr, ptr %5, align 8
  %375 = getelementptr inbounds i8, ptr %374, i64 56
  %376 = load i64, ptr %375, align 8
  %377 = icmp sgt i64 %376, 0
  br i1 %377, label %378, label %387

378:                                              ; preds = %372, %378
  %379 = phi i64 [ %385, %378 ], [ 0, %372 ]
  %380 = shl i64 %379, 6
  %381 = getelementptr i8, ptr %373, i64 %380
  %382 = getelementptr double, ptr %381, i64 %310
  %383 = load double, ptr %382, align 8
  %384 = getelementptr double, ptr %381, i64 %337
  store double %383, ptr %384, align 8
  %385 = add nuw nsw i64 %379, 1
  %386 = icmp eq i64 %385, %376
  br i1 %386, label %387, label %378, !llvm.loop !35

387:                                              ; preds = %378, %372
  %388 = load ptr, ptr %65, align 8
  %389 = load ptr, ptr %5, align 8
  %390 = getelementptr inbounds i8, ptr %389, i64 64
  %391 = load i64, ptr %390, align 8
  %392 = icmp sgt i64 %391, 0
  br i1 %392, label %393, label %402

393:                                              ; preds = %387, %393
  %394 = phi i64 [ %400, %393 ], [ 0, %387 ]
  %395 = shl i64 %394, 6
  %396 = getelementptr i8, ptr %388, i64 %395
  %397 = getelementptr double, ptr %396, i64 %310
  %398 = load double, ptr %397, align 8
  %399 = getelementptr double, ptr %396, i64 %337
  store double %398, ptr %399, align 8
  %400 = add nuw nsw i64 %394, 1
  %401 = icmp eq i64 %400, %391
  br i1 %401, label %402, label %393, !llvm.loop !35

402:                                              ; preds = %393, %387
  %403 = load ptr, ptr %66, align 8
  %404 = load ptr, ptr %5, align 8
  %405 = getelementptr inbounds i8, ptr %404, i64 24
  %406 = load i64, ptr %405, align 8
  %407 = shl nsw i64 %406, 6
  %408 = getelementptr inbounds i8, ptr %403, i64 %407
  %409 = load i64, ptr %67, align 8
  %410 = icmp sgt i64 %409, 0
  br i1 %410, label %411, label %420

411:                                              ; preds = %402, %411
  %412 = phi i64 [ %418, %411 ], [ 0, %402 ]
  %413 = shl i64 %412, 6
  %414 = getelementptr i8, ptr %408, i64 %413
  %415 = getelementptr double, ptr %414, i64 %310
  %416 = load double, ptr %415, align 8
  %417 = getelementptr double, ptr %414, i64 %337
  store double %416, ptr %417, align 8
  %418 = add nuw nsw i64 %412, 1
  %419 = icmp eq i64 %418, %409
  br i1 %419, label %420, label %411, !llvm.loop !35

420:                                              ; preds = %411, %402
  %421 = load ptr, ptr %3, align 8
  %422 = getelementptr inbounds double, ptr %421, i64 %310
  %423 = load double, ptr %422, align 8
  %424 = getelementptr inbounds double, ptr %421, i64 %337
  store double %423, ptr %424, align 8
  %425 = load ptr, ptr %68, align 8
  %426 = getelementptr inbounds double, ptr %425, i64 %337
  store double 0.000000e+00, ptr %426, align 8
  %427 = load ptr, ptr %69, align 8
  %428 = getelementptr inbounds double, ptr %427, i64 %337
  store double 0x7FF0000000000000, ptr %428, align 8
  %429 = load ptr, ptr %62, align 8
  %430 = getelementptr inbounds i64, ptr %429, i64 %337
  store i64 -2, ptr %430, align 8
  br label %431

431:                                              ; preds = %336, %420
  %432 = add nuw nsw i64 %337, 1
  %433 = icmp eq i64 %432, 8
  br i1 %433, label %313, label %336, !llvm.loop !36

434:                                              ; preds = %320, %313, %59
  ret i64 %302
}

define internal fastcc void @start(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, i64 noundef %3) unnamed_addr #3 {
  %5 = alloca [8 x double], align 16
  %6 = alloca [8 x double], align 16
  %7 = alloca [8 x double], align 16
  %8 = alloca [8 x double], align 16
  %9 = getelementptr inbounds i8, ptr %0, i64 696
  %10 = getelementptr inbounds i8, ptr %0, i64 984
  %11 = getelementptr inbounds i8, ptr %1, i64 16
  %12 = load ptr, ptr %11, align 8
  %13 = trunc i64 %2 to i8
  %14 = bitcast i8 %13 to <8 x i1>
  %15 = or i64 %3, %2
  %16 = trunc i64 %15 to i8
  %17 = bitcast i8 %16 to <8 x i1>
  %18 = load ptr, ptr %9, align 8
  %19 = load <8 x double>, ptr %18, align 8
  call fastcc void @hold_all(ptr noundef %0, ptr noundef nonnull %8) #12
  %20 = getelementptr inbounds i8, ptr %1, i64 8
  %21 = load ptr, ptr %20, align 8
  %22 = load ptr, ptr %12, align 8
  %23 = getelementptr inbounds i8, ptr %12, i64 48
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr inbounds i8, ptr %21, i64 24
  %26 = load ptr, ptr %25, align 8
  store <8 x double> %19, ptr %26, align 8
  %27 = load ptr, ptr %21, align 8
  %28 = getelementptr inbounds i8, ptr %27, i64 40
  %29 = load i64, ptr %28, align 8
  %30 = icmp eq i64 %29, 0
  br i1 %30, label %32, label %31

31:                                               ; preds = %4
  tail call fastcc void @settle(ptr noundef nonnull %21) #12
  br label %32

32:                                               ; preds = %31, %4
  %33 = getelementptr inbounds i8, ptr %21, i64 152
  %34 = load i64, ptr %33, align 8
  %35 = icmp sgt i64 %34, 0
  br i1 %35, label %36, label %37

36:                                               ; preds = %32
  tail call fastcc void @sample(ptr noundef nonnull %21) #12
  br label %37

37:                                               ; preds = %32, %36
  %38 = load ptr, ptr %21, align 8
  %39 = load i64, ptr %38, align 8
  %40 = load ptr, ptr %25, align 8
  %41 = getelementptr inbounds i8, ptr %21, i64 48
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds i8, ptr %21, i64 96
  %44 = load ptr, ptr %43, align 8
  %45 = inttoptr i64 %39 to ptr
  %46 = load ptr, ptr %45, align 8
  %47 = tail call i32 %46(ptr noundef %40, ptr noundef %22, ptr noundef %42, ptr noundef %44, ptr noundef %24) #13
  %48 = sext i32 %47 to i64
  %49 = load ptr, ptr %20, align 8
  %50 = load ptr, ptr %49, align 8
  %51 = getelementptr inbounds i8, ptr %50, i64 8
  %52 = load i64, ptr %51, align 8
  %53 = icmp sgt i64 %52, 0
  br i1 %53, label %54, label %56

54:                                               ; preds = %37
  %55 = getelementptr inbounds i8, ptr %12, i64 168
  br label %62

56:                                               ; preds = %62, %37
  %57 = getelementptr inbounds i8, ptr %0, i64 1008
  %58 = load ptr, ptr %57, align 8
  %59 = getelementptr inbounds i8, ptr %58, i64 8
  %60 = load double, ptr %59, align 8
  %61 = fcmp oeq double %60, 0.000000e+00
  br i1 %61, label %84, label %78

62:                                               ; preds = %54, %62
  %63 = phi i64 [ 0, %54 ], [ %72, %62 ]
  %64 = load ptr, ptr %55, align 8
  %65 = load ptr, ptr %23, align 8
  %66 = shl nsw i64 %63, 6
  %67 = getelementptr inbounds i8, ptr %65, i64 %66
  %68 = load <8 x i64>, ptr %67, align 8
  %69 = getelementptr inbounds i8, ptr %64, i64 %66
  %70 = load <8 x i64>, ptr %69, align 8
  %71 = select <8 x i1> %17, <8 x i64> %68, <8 x i64> %70
  store <8 x i64> %71, ptr %69, align 8
  %72 = add nuw nsw i64 %63, 1
  %73 = load ptr, ptr %20, align 8
  %74 = load ptr, ptr %73, align 8
  %75 = getelementptr inbounds i8, ptr %74, i64 8
  %76 = load i64, ptr %75, align 8
  %77 = icmp slt i64 %72, %76
  br i1 %77, label %62, label %56, !llvm.loop !37

78:                                               ; preds = %56
  %79 = load ptr, ptr %0, align 8
  %80 = getelementptr inbounds i8, ptr %79, i64 8
  %81 = load i64, ptr %80, align 8
  %82 = icmp sgt i64 %81, 0
  %83 = select i1 %82, i64 %3, i64 0
  br label %84

84:                                               ; preds = %56, %78
  %85 = phi i64 [ %83, %78 ], [ %15, %56 ]
  %86 = getelementptr inbounds i8, ptr %0, i64 720
  %87 = load ptr, ptr %86, align 8
  %88 = insertelement <8 x double> poison, double %60, i64 0
  %89 = load <8 x i64>, ptr %87, align 8
  %90 = bitcast <8 x double> %88 to <8 x i64>
  %91 = shufflevector <8 x i64> %90, <8 x i64> poison, <8 x i32> zeroinitializer
  %92 = select <8 x i1> %17, <8 x i64> %91, <8 x i64> %89
  store <8 x i64> %92, ptr %87, align 8
  %93 = getelementptr inbounds i8, ptr %0, i64 744
  %94 = load ptr, ptr %93, align 8
  %95 = load <8 x double>, ptr %94, align 8
  %96 = select <8 x i1> %17, <8 x double> <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>, <8 x double> %95
  store <8 x double> %96, ptr %94, align 8
  %97 = getelementptr inbounds i8, ptr %0, i64 768
  %98 = load ptr, ptr %97, align 8
  %99 = load ptr, ptr %1, align 8
  %100 = getelementptr inbounds i8, ptr %99, i64 120
  %101 = load ptr, ptr %100, align 8
  %102 = getelementptr inbounds i8, ptr %101, i64 40
  %103 = load double, ptr %102, align 8
  %104 = insertelement <8 x double> poison, double %103, i64 0
  %105 = load <8 x i64>, ptr %98, align 8
  %106 = bitcast <8 x double> %104 to <8 x i64>
  %107 = shufflevector <8 x i64> %106, <8 x i64> poison, <8 x i32> zeroinitializer
  %108 = select <8 x i1> %17, <8 x i64> %107, <8 x i64> %105
  store <8 x i64> %108, ptr %98, align 8
  %109 = icmp eq i64 %85, 0
  br i1 %109, label %292, label %110

110:                                              ; preds = %84
  %111 = load ptr, ptr %86, align 8
  %112 = trunc i64 %85 to i8
  %113 = bitcast i8 %112 to <8 x i1>
  %114 = load ptr, ptr %57, align 8
  %115 = load double, ptr %114, align 8
  %116 = load ptr, ptr %11, align 8
  %117 = load ptr, ptr %20, align 8
  %118 = load ptr, ptr %117, align 8
  %119 = getelementptr inbounds i8, ptr %118, i64 24
  %120 = load i64, ptr %119, align 8
  %121 = load ptr, ptr %116, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %121, ptr noundef %121, ptr noundef nonnull %116, i64 noundef %120) #12
  %122 = load <8 x double>, ptr %5, align 16
  %123 = getelementptr inbounds i8, ptr %116, i64 168
  %124 = load ptr, ptr %123, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %124, ptr noundef %121, ptr noundef nonnull %116, i64 noundef %120) #12
  %125 = load <8 x double>, ptr %6, align 16
  %126 = fcmp olt <8 x double> %122, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %127 = fcmp olt <8 x double> %125, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %128 = or <8 x i1> %127, %126
  %129 = insertelement <8 x double> poison, double %115, i64 0
  %130 = shufflevector <8 x double> %129, <8 x double> poison, <8 x i32> zeroinitializer
  %131 = fmul <8 x double> %122, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %132 = fdiv <8 x double> %131, %125
  %133 = bitcast <8 x double> %132 to <8 x i64>
  %134 = select <8 x i1> %128, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %133
  %135 = bitcast <8 x i64> %134 to <8 x double>
  %136 = fcmp olt <8 x double> %130, %135
  %137 = bitcast <8 x double> %130 to <8 x i64>
  %138 = select <8 x i1> %136, <8 x i64> %137, <8 x i64> %134
  %139 = bitcast <8 x i64> %138 to <8 x double>
  %140 = load ptr, ptr %20, align 8
  %141 = load ptr, ptr %140, align 8
  %142 = getelementptr inbounds i8, ptr %141, i64 8
  %143 = load i64, ptr %142, align 8
  %144 = icmp sgt i64 %143, 0
  br i1 %144, label %145, label %147

145:                                              ; preds = %110
  %146 = getelementptr inbounds i8, ptr %116, i64 48
  br label %168

147:                                              ; preds = %168, %110
  %148 = phi ptr [ %140, %110 ], [ %182, %168 ]
  %149 = fadd <8 x double> %19, %139
  %150 = getelementptr inbounds i8, ptr %116, i64 48
  %151 = load ptr, ptr %150, align 8
  %152 = load ptr, ptr %123, align 8
  %153 = getelementptr inbounds i8, ptr %116, i64 8
  %154 = load i64, ptr %153, align 8
  %155 = getelementptr inbounds double, ptr %152, i64 %154
  %156 = getelementptr inbounds i8, ptr %148, i64 24
  %157 = load ptr, ptr %156, align 8
  store <8 x double> %149, ptr %157, align 8
  %158 = load ptr, ptr %148, align 8
  %159 = getelementptr inbounds i8, ptr %158, i64 40
  %160 = load i64, ptr %159, align 8
  %161 = icmp eq i64 %160, 0
  br i1 %161, label %163, label %162

162:                                              ; preds = %147
  tail call fastcc void @settle(ptr noundef nonnull %148) #12
  br label %163

163:                                              ; preds = %162, %147
  %164 = getelementptr inbounds i8, ptr %148, i64 152
  %165 = load i64, ptr %164, align 8
  %166 = icmp sgt i64 %165, 0
  br i1 %166, label %167, label %187

167:                                              ; preds = %163
  tail call fastcc void @sample(ptr noundef nonnull %148) #12
  br label %187

168:                                              ; preds = %145, %168
  %169 = phi i64 [ 0, %145 ], [ %181, %168 ]
  %170 = load ptr, ptr %146, align 8
  %171 = load ptr, ptr %116, align 8
  %172 = shl nsw i64 %169, 6
  %173 = getelementptr inbounds i8, ptr %171, i64 %172
  %174 = load <8 x double>, ptr %173, align 8
  %175 = load ptr, ptr %123, align 8
  %176 = getelementptr inbounds i8, ptr %175, i64 %172
  %177 = load <8 x double>, ptr %176, align 8
  %178 = fmul <8 x double> %177, %139
  %179 = fadd <8 x double> %174, %178
  %180 = getelementptr inbounds i8, ptr %170, i64 %172
  store <8 x double> %179, ptr %180, align 8
  %181 = add nuw nsw i64 %169, 1
  %182 = load ptr, ptr %20, align 8
  %183 = load ptr, ptr %182, align 8
  %184 = getelementptr inbounds i8, ptr %183, i64 8
  %185 = load i64, ptr %184, align 8
  %186 = icmp slt i64 %181, %185
  br i1 %186, label %168, label %147, !llvm.loop !38

187:                                              ; preds = %163, %167
  %188 = load ptr, ptr %148, align 8
  %189 = load i64, ptr %188, align 8
  %190 = load ptr, ptr %156, align 8
  %191 = getelementptr inbounds i8, ptr %148, i64 48
  %192 = load ptr, ptr %191, align 8
  %193 = getelementptr inbounds i8, ptr %148, i64 96
  %194 = load ptr, ptr %193, align 8
  %195 = inttoptr i64 %189 to ptr
  %196 = load ptr, ptr %195, align 8
  %197 = tail call i32 %196(ptr noundef %190, ptr noundef %151, ptr noundef %192, ptr noundef %194, ptr noundef %155) #13
  %198 = load ptr, ptr %1, align 8
  %199 = getelementptr inbounds i8, ptr %198, i64 120
  %200 = load ptr, ptr %199, align 8
  %201 = load double, ptr %200, align 8
  %202 = load ptr, ptr %123, align 8
  %203 = load i64, ptr %153, align 8
  %204 = getelementptr inbounds double, ptr %202, i64 %203
  %205 = icmp sgt i64 %120, 0
  br i1 %205, label %206, label %216

206:                                              ; preds = %187, %206
  %207 = phi i64 [ %214, %206 ], [ 0, %187 ]
  %208 = shl nsw i64 %207, 6
  %209 = getelementptr inbounds i8, ptr %204, i64 %208
  %210 = load <8 x double>, ptr %209, align 8
  %211 = getelementptr inbounds i8, ptr %202, i64 %208
  %212 = load <8 x double>, ptr %211, align 8
  %213 = fsub <8 x double> %210, %212
  store <8 x double> %213, ptr %209, align 8
  %214 = add nuw nsw i64 %207, 1
  %215 = icmp eq i64 %214, %120
  br i1 %215, label %216, label %206, !llvm.loop !39

216:                                              ; preds = %206, %187
  %217 = load ptr, ptr %116, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %204, ptr noundef %217, ptr noundef nonnull %116, i64 noundef %120) #12
  %218 = load <8 x double>, ptr %7, align 16
  %219 = fdiv <8 x double> %218, %139
  %220 = fcmp ogt <8 x double> %125, %219
  %221 = select <8 x i1> %220, <8 x double> %125, <8 x double> %219
  %222 = fcmp ogt <8 x double> %221, <double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15>
  %223 = fdiv <8 x double> <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>, %221
  %224 = select <8 x i1> %222, <8 x double> %223, <8 x double> <double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13>
  %225 = bitcast <8 x double> %224 to <8 x i64>
  %226 = add <8 x i64> %225, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %227 = ashr <8 x i64> %226, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %228 = and <8 x i64> %226, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %229 = sub <8 x i64> %225, %228
  %230 = bitcast <8 x i64> %229 to <8 x double>
  %231 = fadd <8 x double> %230, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %232 = fadd <8 x double> %230, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %233 = fdiv <8 x double> %231, %232
  %234 = fmul <8 x double> %233, %233
  %235 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %234, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %236 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %235, <8 x double> %234, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %237 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %236, <8 x double> %234, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %238 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %237, <8 x double> %234, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %239 = trunc nsw <8 x i64> %227 to <8 x i32>
  %240 = sitofp <8 x i32> %239 to <8 x double>
  %241 = fmul <8 x double> %233, %238
  %242 = fadd <8 x double> %241, %240
  %243 = insertelement <8 x double> poison, double %201, i64 0
  %244 = shufflevector <8 x double> %243, <8 x double> poison, <8 x i32> zeroinitializer
  %245 = fmul <8 x double> %244, %242
  %246 = fcmp ogt <8 x double> %245, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %247 = bitcast <8 x double> %245 to <8 x i64>
  %248 = select <8 x i1> %246, <8 x i64> %247, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %249 = bitcast <8 x i64> %248 to <8 x double>
  %250 = fcmp olt <8 x double> %249, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %251 = bitcast <8 x i64> %248 to <8 x double>
  %252 = select <8 x i1> %250, <8 x double> %251, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %253 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %252)
  %254 = fsub <8 x double> %252, %253
  %255 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %254, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %256 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %255, <8 x double> %254, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %257 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %256, <8 x double> %254, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %258 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %257, <8 x double> %254, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %259 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %258, <8 x double> %254, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %260 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %259, <8 x double> %254, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %261 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %260, <8 x double> %254, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %262 = bitcast <8 x double> %261 to <8 x i64>
  %263 = fptosi <8 x double> %253 to <8 x i32>
  %264 = zext <8 x i32> %263 to <8 x i64>
  %265 = shl <8 x i64> %264, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %266 = add <8 x i64> %265, %262
  %267 = fmul <8 x double> %139, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %268 = fcmp olt <8 x double> %267, <double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D>
  %269 = bitcast <8 x double> %267 to <8 x i64>
  %270 = select <8 x i1> %268, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %269
  %271 = fmul <8 x double> %139, <double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02>
  %272 = select <8 x i1> %222, <8 x i64> %266, <8 x i64> %270
  %273 = bitcast <8 x i64> %272 to <8 x double>
  %274 = fcmp olt <8 x double> %271, %273
  %275 = bitcast <8 x double> %271 to <8 x i64>
  %276 = select <8 x i1> %274, <8 x i64> %275, <8 x i64> %272
  %277 = bitcast <8 x i64> %276 to <8 x double>
  %278 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %19)
  %279 = fmul <8 x double> %278, <double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000>
  %280 = fcmp ogt <8 x double> %279, %277
  %281 = bitcast <8 x double> %279 to <8 x i64>
  %282 = select <8 x i1> %280, <8 x i64> %281, <8 x i64> %276
  %283 = bitcast <8 x i64> %282 to <8 x double>
  %284 = fcmp olt <8 x double> %130, %283
  %285 = select <8 x i1> %284, <8 x i64> %137, <8 x i64> %282
  %286 = trunc i32 %197 to i8
  %287 = bitcast i8 %286 to <8 x i1>
  %288 = select <8 x i1> %287, <8 x i64> %269, <8 x i64> %285
  %289 = load ptr, ptr %86, align 8
  %290 = load <8 x i64>, ptr %289, align 8
  %291 = select <8 x i1> %113, <8 x i64> %288, <8 x i64> %290
  store <8 x i64> %291, ptr %111, align 8
  br label %292

292:                                              ; preds = %84, %216
  %293 = getelementptr inbounds i8, ptr %0, i64 840
  %294 = load ptr, ptr %293, align 8
  %295 = load <8 x double>, ptr %294, align 8
  %296 = select <8 x i1> %14, <8 x double> zeroinitializer, <8 x double> %295
  store <8 x double> %296, ptr %294, align 8
  %297 = getelementptr inbounds i8, ptr %0, i64 864
  %298 = load ptr, ptr %297, align 8
  %299 = load <8 x double>, ptr %298, align 8
  %300 = select <8 x i1> %14, <8 x double> zeroinitializer, <8 x double> %299
  store <8 x double> %300, ptr %298, align 8
  %301 = getelementptr inbounds i8, ptr %0, i64 888
  %302 = load ptr, ptr %301, align 8
  %303 = load <8 x double>, ptr %302, align 8
  %304 = select <8 x i1> %14, <8 x double> zeroinitializer, <8 x double> %303
  store <8 x double> %304, ptr %302, align 8
  %305 = getelementptr inbounds i8, ptr %0, i64 912
  %306 = load ptr, ptr %305, align 8
  %307 = load ptr, ptr %86, align 8
  %308 = load <8 x double>, ptr %307, align 8
  %309 = tail call <8 x i1> @llvm.is.fpclass.v8f64(<8 x double> %308, i32 384)
  %310 = select <8 x i1> %309, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %311 = load <8 x i64>, ptr %306, align 8
  %312 = select <8 x i1> %17, <8 x i64> %310, <8 x i64> %311
  store <8 x i64> %312, ptr %306, align 8
  %313 = icmp eq i64 %2, 0
  br i1 %313, label %346, label %314

314:                                              ; preds = %292
  %315 = getelementptr inbounds i8, ptr %0, i64 936
  %316 = getelementptr inbounds i8, ptr %0, i64 1032
  %317 = getelementptr inbounds i8, ptr %0, i64 1040
  %318 = getelementptr inbounds i8, ptr %0, i64 792
  %319 = getelementptr inbounds i8, ptr %0, i64 816
  %320 = getelementptr inbounds i8, ptr %0, i64 960
  br label %321

321:                                              ; preds = %314, %321
  %322 = phi i64 [ %2, %314 ], [ %344, %321 ]
  %323 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %322, i1 true)
  %324 = load ptr, ptr %315, align 8
  %325 = getelementptr inbounds i64, ptr %324, i64 %323
  %326 = load i64, ptr %325, align 8
  %327 = load i64, ptr %317, align 8
  %328 = add nsw i64 %327, -1
  %329 = load ptr, ptr %318, align 8
  %330 = getelementptr inbounds double, ptr %329, i64 %323
  store double 0.000000e+00, ptr %330, align 8
  %331 = load ptr, ptr %316, align 8
  %332 = load double, ptr %331, align 8
  %333 = load ptr, ptr %319, align 8
  %334 = getelementptr inbounds double, ptr %333, i64 %323
  store double %332, ptr %334, align 8
  %335 = load ptr, ptr %10, align 8
  %336 = getelementptr inbounds i8, ptr %335, i64 24
  %337 = load i64, ptr %336, align 8
  %338 = shl i64 %326, 3
  %339 = mul i64 %338, %328
  %340 = add nsw i64 %337, %339
  %341 = load ptr, ptr %320, align 8
  %342 = getelementptr inbounds i64, ptr %341, i64 %323
  store i64 %340, ptr %342, align 8
  %343 = add nsw i64 %322, -1
  %344 = and i64 %343, %322
  %345 = icmp eq i64 %344, 0
  br i1 %345, label %346, label %321, !llvm.loop !40

346:                                              ; preds = %321, %292
  %347 = xor i64 %48, -1
  %348 = and i64 %347, %2
  %349 = icmp eq i64 %348, 0
  br i1 %349, label %353, label %350

350:                                              ; preds = %346
  %351 = getelementptr inbounds i8, ptr %0, i64 816
  %352 = getelementptr inbounds i8, ptr %0, i64 1032
  br label %374

353:                                              ; preds = %374, %346
  %354 = and i64 %15, %48
  %355 = xor i64 %354, %15
  %356 = getelementptr inbounds i8, ptr %0, i64 816
  %357 = load ptr, ptr %356, align 8
  %358 = load <8 x double>, ptr %357, align 8
  %359 = fcmp oeq <8 x double> %358, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %360 = bitcast <8 x i1> %359 to i8
  %361 = zext i8 %360 to i64
  %362 = and i64 %355, %361
  %363 = load ptr, ptr %301, align 8
  %364 = load <8 x double>, ptr %363, align 8
  %365 = select <8 x i1> %17, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %366 = or i64 %362, %354
  %367 = xor i64 %366, -1
  %368 = and i64 %85, %367
  %369 = trunc i64 %368 to i8
  %370 = bitcast i8 %369 to <8 x i1>
  %371 = select <8 x i1> %370, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %372 = fadd <8 x double> %365, %371
  %373 = fadd <8 x double> %364, %372
  store <8 x double> %373, ptr %363, align 8
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %354, i64 noundef 3) #12
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %362, i64 noundef 0) #12
  ret void

374:                                              ; preds = %350, %374
  %375 = phi i64 [ %348, %350 ], [ %386, %374 ]
  %376 = load ptr, ptr %12, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %376, i64 noundef %375) #12
  %377 = load ptr, ptr %351, align 8
  %378 = load <8 x double>, ptr %377, align 8
  %379 = load ptr, ptr %352, align 8
  %380 = load double, ptr %379, align 8
  %381 = insertelement <8 x double> poison, double %380, i64 0
  %382 = shufflevector <8 x double> %381, <8 x double> poison, <8 x i32> zeroinitializer
  %383 = fcmp oeq <8 x double> %378, %382
  %384 = bitcast <8 x i1> %383 to i8
  %385 = zext i8 %384 to i64
  %386 = and i64 %375, %385
  %387 = icmp eq i64 %386, 0
  br i1 %387, label %353, label %374, !llvm.loop !41
}

define internal fastcc void @hold_all(ptr noundef readonly %0, ptr noundef writeonly %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 696
  %4 = getelementptr inbounds i8, ptr %0, i64 392
  %5 = getelementptr inbounds i8, ptr %0, i64 384
  %6 = getelementptr inbounds i8, ptr %0, i64 408
  br label %8

7:                                                ; preds = %49
  ret void

8:                                                ; preds = %2, %49
  %9 = phi i64 [ 0, %2 ], [ %52, %49 ]
  %10 = load ptr, ptr %3, align 8
  %11 = getelementptr inbounds double, ptr %10, i64 %9
  %12 = load double, ptr %11, align 8
  %13 = load i64, ptr %4, align 8
  %14 = icmp eq i64 %13, 0
  br i1 %14, label %49, label %15

15:                                               ; preds = %8
  %16 = icmp sgt i64 %13, 0
  br i1 %16, label %17, label %32

17:                                               ; preds = %15
  %18 = load ptr, ptr %5, align 8
  br label %19

19:                                               ; preds = %17, %19
  %20 = phi i64 [ 0, %17 ], [ %30, %19 ]
  %21 = phi i64 [ %13, %17 ], [ %29, %19 ]
  %22 = add nuw nsw i64 %20, %21
  %23 = lshr i64 %22, 1
  %24 = mul i64 %23, 24
  %25 = getelementptr inbounds i8, ptr %18, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = fcmp ogt double %26, %12
  %28 = add nuw nsw i64 %23, 1
  %29 = select i1 %27, i64 %23, i64 %21
  %30 = select i1 %27, i64 %20, i64 %28
  %31 = icmp slt i64 %30, %29
  br i1 %31, label %19, label %32, !llvm.loop !42

32:                                               ; preds = %19, %15
  %33 = phi i64 [ 0, %15 ], [ %30, %19 ]
  %34 = load ptr, ptr %5, align 8
  %35 = mul i64 %33, 24
  %36 = getelementptr inbounds i8, ptr %34, i64 %35
  %37 = icmp slt i64 %33, %13
  br i1 %37, label %38, label %41

38:                                               ; preds = %32
  %39 = getelementptr inbounds i8, ptr %36, i64 8
  %40 = load double, ptr %39, align 8
  br label %41

41:                                               ; preds = %38, %32
  %42 = phi double [ %40, %38 ], [ 0x7FF0000000000000, %32 ]
  %43 = load ptr, ptr %6, align 8
  %44 = getelementptr inbounds double, ptr %43, i64 %9
  store double %42, ptr %44, align 8
  %45 = load i64, ptr %4, align 8
  %46 = icmp slt i64 %33, %45
  br i1 %46, label %47, label %49

47:                                               ; preds = %41
  %48 = load double, ptr %36, align 8
  br label %49

49:                                               ; preds = %8, %41, %47
  %50 = phi double [ 0x7FF0000000000000, %8 ], [ %48, %47 ], [ 0x7FF0000000000000, %41 ]
  %51 = getelementptr inbounds double, ptr %1, i64 %9
  store double %50, ptr %51, align 8
  %52 = add nuw nsw i64 %9, 1
  %53 = icmp eq i64 %52, 8
  br i1 %53, label %7, label %8, !llvm.loop !43
}

define internal fastcc void @retire(ptr noundef readonly %0, i64 noundef %1, i64 noundef %2) unnamed_addr #4 {
  %4 = getelementptr inbounds i8, ptr %0, i64 696
  %5 = getelementptr inbounds i8, ptr %0, i64 984
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
  %15 = getelementptr inbounds i8, ptr %0, i64 936
  %16 = getelementptr inbounds i8, ptr %0, i64 960
  %17 = getelementptr inbounds i8, ptr %0, i64 1040
  %18 = getelementptr inbounds i8, ptr %0, i64 792
  %19 = icmp sgt i64 %9, 0
  %20 = getelementptr inbounds i8, ptr %0, i64 1152
  %21 = getelementptr inbounds i8, ptr %0, i64 1168
  %22 = getelementptr inbounds i8, ptr %0, i64 840
  %23 = getelementptr inbounds i8, ptr %0, i64 864
  %24 = getelementptr inbounds i8, ptr %0, i64 888
  %25 = icmp slt i64 %2, 0
  %26 = getelementptr inbounds i8, ptr %0, i64 912
  %27 = getelementptr inbounds i8, ptr %0, i64 1176
  %28 = getelementptr inbounds i8, ptr %0, i64 1728
  %29 = getelementptr inbounds i8, ptr %0, i64 1736
  %30 = getelementptr inbounds i8, ptr %0, i64 1216
  %31 = getelementptr inbounds i8, ptr %0, i64 1200
  %32 = getelementptr inbounds i8, ptr %0, i64 1216
  %33 = getelementptr inbounds i8, ptr %0, i64 1232
  %34 = getelementptr inbounds i8, ptr %0, i64 1272
  %35 = getelementptr inbounds i8, ptr %0, i64 1440
  %36 = getelementptr inbounds i8, ptr %0, i64 1488
  %37 = getelementptr inbounds i8, ptr %0, i64 1504
  %38 = getelementptr inbounds i8, ptr %0, i64 1224
  %39 = getelementptr inbounds i8, ptr %0, i64 1536
  %40 = getelementptr inbounds i8, ptr %0, i64 1552
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
  br i1 %86, label %61, label %64, !llvm.loop !44

87:                                               ; preds = %61, %87
  %88 = phi i64 [ %91, %87 ], [ 0, %61 ]
  %89 = mul nsw i64 %88, %12
  %90 = getelementptr inbounds double, ptr %63, i64 %89
  store double 0x7FF8000000000000, ptr %90, align 8
  %91 = add nuw nsw i64 %88, 1
  %92 = icmp eq i64 %91, %9
  br i1 %92, label %83, label %87, !llvm.loop !45

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
  br i1 %126, label %118, label %127, !llvm.loop !46

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
  br i1 %155, label %135, label %174, !llvm.loop !47

157:                                              ; preds = %135, %157
  %158 = phi i64 [ %149, %135 ], [ %172, %157 ]
  %159 = load ptr, ptr %38, align 8
  %160 = getelementptr inbounds i64, ptr %159, i64 %43
  %161 = load i64, ptr %160, align 8
  %162 = inttoptr i64 %161 to ptr
  %163 = getelementptr inbounds i8, ptr %162, i64 1008
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
  br i1 %173, label %150, label %157, !llvm.loop !48

174:                                              ; preds = %150, %130
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %43) #12
  br label %175

175:                                              ; preds = %174, %127
  %176 = load ptr, ptr %15, align 8
  %177 = getelementptr inbounds i64, ptr %176, i64 %43
  store i64 -1, ptr %177, align 8
  %178 = add nsw i64 %42, -1
  %179 = and i64 %178, %42
  %180 = icmp eq i64 %179, 0
  br i1 %180, label %60, label %41, !llvm.loop !49
}

define internal fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %1, ptr noundef %2, i64 noundef %3, i32 noundef %4) unnamed_addr #2 {
  %6 = getelementptr inbounds i8, ptr %0, i64 1680
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 56
  %9 = load i64, ptr %8, align 8
  %10 = icmp eq i32 %4, 0
  br i1 %10, label %14, label %11

11:                                               ; preds = %5
  %12 = getelementptr inbounds i8, ptr %0, i64 432
  %13 = load ptr, ptr %12, align 8
  br label %14

14:                                               ; preds = %5, %11
  %15 = phi ptr [ %13, %11 ], [ null, %5 ]
  %16 = inttoptr i64 %9 to ptr
  %17 = tail call i64 %16(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %15, i64 noundef %3) #13
  ret i64 %17
}

define internal fastcc range(i64 0, 256) i64 @clear_lanes(ptr noundef readonly %0) unnamed_addr #3 {
  %2 = getelementptr inbounds i8, ptr %0, i64 432
  %3 = getelementptr inbounds i8, ptr %0, i64 1272
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 1224
  %6 = load ptr, ptr %5, align 8
  %7 = load i64, ptr %6, align 8
  %8 = inttoptr i64 %7 to ptr
  %9 = getelementptr inbounds i8, ptr %8, i64 864
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %4, i64 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 504
  %14 = load ptr, ptr %13, align 8
  %15 = load <8 x double>, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %4, i64 24
  %17 = load i64, ptr %16, align 8
  %18 = icmp eq i64 %17, 0
  br i1 %18, label %143, label %19

19:                                               ; preds = %1
  %20 = getelementptr inbounds i8, ptr %0, i64 1376
  %21 = load i64, ptr %20, align 8
  %22 = icmp sgt i64 %21, 0
  br i1 %22, label %23, label %30

23:                                               ; preds = %19
  %24 = getelementptr inbounds i8, ptr %0, i64 1368
  %25 = getelementptr inbounds i8, ptr %0, i64 456
  %26 = getelementptr inbounds i8, ptr %0, i64 600
  %27 = getelementptr inbounds i8, ptr %0, i64 440
  %28 = getelementptr inbounds i8, ptr %0, i64 1320
  %29 = getelementptr inbounds i8, ptr %4, i64 32
  br label %63

30:                                               ; preds = %86, %19
  %31 = getelementptr inbounds i8, ptr %0, i64 1320
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
  %42 = getelementptr inbounds i8, ptr %0, i64 696
  %43 = load ptr, ptr %42, align 8
  %44 = load <8 x double>, ptr %43, align 8
  store <8 x double> %44, ptr %41, align 8
  %45 = load i64, ptr %16, align 8
  %46 = load ptr, ptr %40, align 8
  %47 = load ptr, ptr %2, align 8
  %48 = load ptr, ptr %31, align 8
  %49 = getelementptr inbounds i8, ptr %0, i64 1344
  %50 = load ptr, ptr %49, align 8
  %51 = getelementptr inbounds i8, ptr %0, i64 1416
  %52 = load ptr, ptr %51, align 8
  %53 = inttoptr i64 %45 to ptr
  %54 = load ptr, ptr %53, align 8
  %55 = tail call i32 %54(ptr noundef %46, ptr noundef %47, ptr noundef %48, ptr noundef %50, ptr noundef %52) #13
  %56 = trunc i32 %55 to i8
  %57 = xor i8 %56, -1
  %58 = icmp sgt i64 %12, 0
  br i1 %58, label %59, label %114

59:                                               ; preds = %30
  %60 = bitcast i8 %57 to <8 x i1>
  %61 = sext <8 x i1> %60 to <8 x i64>
  %62 = getelementptr inbounds i8, ptr %0, i64 1440
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
  br i1 %96, label %63, label %30, !llvm.loop !50

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
  br i1 %110, label %86, label %97, !llvm.loop !51

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
  br i1 %142, label %111, label %117, !llvm.loop !52

143:                                              ; preds = %1, %114
  %144 = phi i64 [ %116, %114 ], [ 0, %1 ]
  ret i64 %144
}

define internal fastcc i64 @look_for_events(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef readonly %3, ptr noundef readonly %4, ptr noundef %5, ptr noundef writeonly %6, ptr noundef %7) unnamed_addr #3 {
  br label %21

9:                                                ; preds = %21
  %10 = load <8 x double>, ptr %3, align 8
  %11 = load <8 x double>, ptr %4, align 8
  %12 = fcmp oeq <8 x double> %10, %11
  %13 = bitcast <8 x i1> %12 to i8
  %14 = zext i8 %13 to i64
  %15 = xor i64 %14, -1
  %16 = and i64 %15, %2
  %17 = tail call fastcc i64 @quiet_lanes(ptr noundef %0, ptr noundef %1, i64 noundef %16, ptr noundef nonnull %3) #12
  %18 = xor i64 %17, -1
  %19 = and i64 %18, %2
  %20 = icmp eq i64 %19, 0
  br i1 %20, label %48, label %26

21:                                               ; preds = %8, %21
  %22 = phi i64 [ 0, %8 ], [ %24, %21 ]
  %23 = getelementptr inbounds double, ptr %6, i64 %22
  store double 1.000000e+00, ptr %23, align 8
  %24 = add nuw nsw i64 %22, 1
  %25 = icmp eq i64 %24, 8
  br i1 %25, label %9, label %21, !llvm.loop !53

26:                                               ; preds = %9, %51
  %27 = phi i64 [ %53, %51 ], [ %19, %9 ]
  %28 = phi i64 [ %46, %51 ], [ 0, %9 ]
  %29 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %27, i1 true)
  %30 = getelementptr inbounds double, ptr %3, i64 %29
  %31 = load double, ptr %30, align 8
  %32 = getelementptr inbounds double, ptr %6, i64 %29
  %33 = tail call fastcc i64 @look_alone(ptr noundef %0, i64 noundef %29, double noundef %31, ptr noundef %32) #12
  %34 = getelementptr inbounds i64, ptr %5, i64 %29
  store i64 %33, ptr %34, align 8
  %35 = icmp eq i64 %33, -6
  %36 = zext i1 %35 to i64
  %37 = shl nuw i64 %36, %29
  %38 = load i64, ptr %7, align 8
  %39 = or i64 %37, %38
  store i64 %39, ptr %7, align 8
  %40 = load i64, ptr %34, align 8
  %41 = icmp ne i64 %40, 0
  %42 = icmp ne i64 %40, -6
  %43 = and i1 %41, %42
  %44 = zext i1 %43 to i64
  %45 = shl nuw i64 %44, %29
  %46 = or i64 %45, %28
  %47 = icmp eq i64 %40, -6
  br i1 %47, label %50, label %51

48:                                               ; preds = %51, %9
  %49 = phi i64 [ 0, %9 ], [ %46, %51 ]
  ret i64 %49

50:                                               ; preds = %26
  store double 1.000000e+00, ptr %32, align 8
  br label %51

51:                                               ; preds = %26, %50
  %52 = add nsw i64 %27, -1
  %53 = and i64 %52, %27
  %54 = icmp eq i64 %53, 0
  br i1 %54, label %48, label %26, !llvm.loop !54
}

define internal fastcc i64 @write_within(ptr noundef %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef %3, ptr noundef readonly %4) unnamed_addr #3 {
  %6 = alloca [8 x i64], align 16
  %7 = getelementptr inbounds i8, ptr %0, i64 696
  %8 = load ptr, ptr %7, align 8
  %9 = load <8 x double>, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %1, i64 16
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %11, i64 72
  %13 = load ptr, ptr %12, align 8
  %14 = load <8 x double>, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 792
  %16 = load ptr, ptr %15, align 8
  %17 = load <8 x double>, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %0, i64 816
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
  %34 = getelementptr inbounds i8, ptr %0, i64 960
  %35 = load ptr, ptr %34, align 8
  br label %39

36:                                               ; preds = %39
  %37 = getelementptr inbounds i8, ptr %1, i64 8
  %38 = getelementptr inbounds i8, ptr %0, i64 1680
  br label %46

39:                                               ; preds = %31, %39
  %40 = phi i64 [ 0, %31 ], [ %44, %39 ]
  %41 = getelementptr inbounds i64, ptr %35, i64 %40
  %42 = load i64, ptr %41, align 8
  %43 = getelementptr inbounds [8 x i64], ptr %6, i64 0, i64 %40
  store i64 %42, ptr %43, align 8
  %44 = add nuw nsw i64 %40, 1
  %45 = icmp eq i64 %44, 8
  br i1 %45, label %36, label %39, !llvm.loop !55

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
  %64 = getelementptr inbounds i8, ptr %0, i64 960
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
  tail call fastcc void @nested(ptr noundef %22, ptr noundef %71, ptr noundef %73, i64 noundef %75, i64 noundef %79, ptr noundef %80, i64 noundef %84) #12
  %85 = load ptr, ptr %38, align 8
  %86 = load i64, ptr %85, align 8
  %87 = icmp eq i64 %86, 1
  br i1 %87, label %88, label %92

88:                                               ; preds = %65
  %89 = load ptr, ptr %18, align 8
  %90 = tail call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %89, ptr noundef %22, i64 noundef %59, i32 noundef 0) #12
  %91 = or i64 %90, %48
  br label %92

92:                                               ; preds = %88, %65
  %93 = phi i64 [ %91, %88 ], [ %48, %65 ]
  %94 = xor i64 %93, -1
  %95 = and i64 %59, %94
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %22, i64 noundef %95) #12
  br label %46, !llvm.loop !56

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
  br i1 %111, label %112, label %96, !llvm.loop !57

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
  tail call fastcc void @nested(ptr noundef %15, ptr noundef %18, ptr noundef %20, i64 noundef %22, i64 noundef %26, ptr noundef %27, i64 noundef %32) #12
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
  %41 = getelementptr inbounds i8, ptr %0, i64 1680
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
  br i1 %60, label %45, label %40, !llvm.loop !58

61:                                               ; preds = %40
  %62 = bitcast <8 x i1> %12 to i8
  %63 = icmp eq i8 %62, 0
  br i1 %63, label %69, label %64

64:                                               ; preds = %61
  %65 = zext i8 %62 to i64
  %66 = getelementptr inbounds i8, ptr %7, i64 24
  %67 = load ptr, ptr %66, align 8
  %68 = tail call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %3, ptr noundef %67, i64 noundef %65, i32 noundef 0) #12
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
  %8 = getelementptr inbounds i8, ptr %0, i64 984
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %9, i64 32
  %11 = load i64, ptr %10, align 8
  %12 = icmp eq i64 %2, 0
  br i1 %12, label %28, label %13

13:                                               ; preds = %3
  %14 = getelementptr inbounds i8, ptr %0, i64 960
  %15 = icmp sgt i64 %7, 0
  %16 = getelementptr inbounds i8, ptr %0, i64 792
  %17 = getelementptr inbounds i8, ptr %0, i64 1032
  %18 = getelementptr inbounds i8, ptr %0, i64 816
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
  br i1 %45, label %28, label %19, !llvm.loop !59

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
  br i1 %54, label %29, label %46, !llvm.loop !60
}

define internal fastcc i64 @act_in_lanes(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2) unnamed_addr #2 {
  %4 = getelementptr inbounds i8, ptr %0, i64 144
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %5, i64 8
  %7 = load i64, ptr %6, align 8
  %8 = icmp eq i64 %1, 0
  br i1 %8, label %32, label %9

9:                                                ; preds = %3
  %10 = getelementptr inbounds i8, ptr %0, i64 1224
  %11 = icmp sgt i64 %7, 0
  %12 = getelementptr inbounds i8, ptr %0, i64 432
  %13 = getelementptr inbounds i8, ptr %0, i64 696
  %14 = getelementptr inbounds i8, ptr %0, i64 1272
  %15 = getelementptr inbounds i8, ptr %0, i64 1464
  %16 = getelementptr inbounds i8, ptr %0, i64 1440
  %17 = getelementptr inbounds i8, ptr %0, i64 1392
  %18 = icmp sgt i64 %7, 0
  %19 = getelementptr inbounds i8, ptr %0, i64 432
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
  %31 = getelementptr inbounds i8, ptr %27, i64 360
  br label %40

32:                                               ; preds = %214, %3
  %33 = phi i64 [ 0, %3 ], [ %215, %214 ]
  ret i64 %33

34:                                               ; preds = %40, %20
  %35 = load ptr, ptr %13, align 8
  %36 = getelementptr inbounds double, ptr %35, i64 %23
  %37 = load double, ptr %36, align 8
  %38 = getelementptr inbounds i8, ptr %27, i64 624
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
  br i1 %50, label %34, label %40, !llvm.loop !61

51:                                               ; preds = %34
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #12
  br label %156

52:                                               ; preds = %34
  %53 = load ptr, ptr %10, align 8
  %54 = getelementptr inbounds i64, ptr %53, i64 %23
  %55 = load i64, ptr %54, align 8
  %56 = inttoptr i64 %55 to ptr
  %57 = getelementptr inbounds i8, ptr %56, i64 768
  %58 = load ptr, ptr %57, align 8
  %59 = getelementptr inbounds i8, ptr %58, i64 8
  %60 = load i64, ptr %59, align 8
  %61 = getelementptr inbounds i8, ptr %56, i64 144
  %62 = load ptr, ptr %61, align 8
  %63 = getelementptr inbounds i8, ptr %62, i64 8
  %64 = load i64, ptr %63, align 8
  %65 = getelementptr inbounds i8, ptr %56, i64 624
  %66 = getelementptr inbounds i8, ptr %56, i64 648
  %67 = load ptr, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %67, i64 80
  %69 = load i64, ptr %68, align 8
  %70 = add i64 %60, 1
  %71 = add i64 %70, %69
  %72 = getelementptr inbounds i8, ptr %56, i64 1056
  %73 = getelementptr inbounds i8, ptr %56, i64 1064
  %74 = load i64, ptr %73, align 8
  %75 = icmp sgt i64 %71, %74
  %76 = icmp sgt i64 %60, 0
  br i1 %76, label %77, label %80

77:                                               ; preds = %52
  %78 = getelementptr inbounds i8, ptr %56, i64 960
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
  %89 = icmp sgt i64 %88, 0
  %90 = select i1 %89, i64 %84, i64 %86
  %91 = zext i1 %89 to i64
  %92 = add nuw nsw i64 %85, %91
  %93 = add nuw nsw i64 %84, 1
  %94 = icmp eq i64 %93, %60
  br i1 %94, label %80, label %83, !llvm.loop !62

95:                                               ; preds = %80
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #12
  br label %96

96:                                               ; preds = %95, %80
  %97 = icmp eq i64 %82, 1
  br i1 %97, label %98, label %140

98:                                               ; preds = %96
  %99 = getelementptr inbounds i8, ptr %56, i64 864
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
  %111 = getelementptr inbounds i8, ptr %56, i64 1080
  %112 = load ptr, ptr %111, align 8
  %113 = load i64, ptr %68, align 8
  %114 = getelementptr inbounds i64, ptr %112, i64 %113
  store i64 %81, ptr %114, align 8
  %115 = icmp sgt i64 %64, 0
  br i1 %115, label %116, label %120

116:                                              ; preds = %105
  %117 = getelementptr inbounds i8, ptr %56, i64 360
  %118 = getelementptr inbounds i8, ptr %56, i64 1128
  %119 = getelementptr inbounds i8, ptr %56, i64 1104
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
  br i1 %139, label %120, label %123, !llvm.loop !63

140:                                              ; preds = %98, %96
  %141 = load ptr, ptr %57, align 8
  %142 = getelementptr inbounds i8, ptr %141, i64 48
  %143 = load i64, ptr %142, align 8
  %144 = icmp eq i64 %143, 0
  br i1 %144, label %148, label %145

145:                                              ; preds = %140
  %146 = inttoptr i64 %143 to ptr
  %147 = tail call i64 %146(ptr noundef %56) #13
  br label %148

148:                                              ; preds = %145, %140
  %149 = phi i64 [ %147, %145 ], [ 0, %140 ]
  br i1 %75, label %150, label %151

150:                                              ; preds = %148
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #12
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
  %165 = getelementptr inbounds i8, ptr %161, i64 984
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
  %176 = getelementptr inbounds i8, ptr %161, i64 936
  br label %180

177:                                              ; preds = %180, %156
  br i1 %18, label %178, label %196

178:                                              ; preds = %177
  %179 = getelementptr inbounds i8, ptr %27, i64 360
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
  br i1 %195, label %177, label %180, !llvm.loop !64

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
  br i1 %210, label %196, label %200, !llvm.loop !65

211:                                              ; preds = %196
  %212 = or i64 %199, %21
  br label %214

213:                                              ; preds = %196
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %199, i64 noundef %157) #12
  br label %214

214:                                              ; preds = %213, %211
  %215 = phi i64 [ %212, %211 ], [ %21, %213 ]
  %216 = add nsw i64 %22, -1
  %217 = and i64 %216, %22
  %218 = icmp eq i64 %217, 0
  br i1 %218, label %32, label %20, !llvm.loop !66
}

define internal fastcc range(i64 0, 256) i64 @start_again(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2) unnamed_addr #3 {
  %4 = getelementptr inbounds i8, ptr %0, i64 696
  %5 = getelementptr inbounds i8, ptr %1, i64 16
  %6 = load ptr, ptr %5, align 8
  %7 = trunc i64 %2 to i8
  %8 = bitcast i8 %7 to <8 x i1>
  %9 = getelementptr inbounds i8, ptr %1, i64 8
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 248
  %12 = load i64, ptr %11, align 8
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %14, label %17

14:                                               ; preds = %3
  %15 = getelementptr inbounds i8, ptr %10, i64 264
  %16 = load ptr, ptr %15, align 8
  store <8 x double> <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>, ptr %16, align 8
  br label %17

17:                                               ; preds = %3, %14
  %18 = load ptr, ptr %9, align 8
  %19 = load ptr, ptr %4, align 8
  %20 = load <8 x double>, ptr %19, align 8
  %21 = load ptr, ptr %6, align 8
  %22 = getelementptr inbounds i8, ptr %6, i64 48
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %18, i64 24
  %25 = load ptr, ptr %24, align 8
  store <8 x double> %20, ptr %25, align 8
  %26 = load ptr, ptr %18, align 8
  %27 = getelementptr inbounds i8, ptr %26, i64 40
  %28 = load i64, ptr %27, align 8
  %29 = icmp eq i64 %28, 0
  br i1 %29, label %31, label %30

30:                                               ; preds = %17
  tail call fastcc void @settle(ptr noundef nonnull %18) #12
  br label %31

31:                                               ; preds = %30, %17
  %32 = getelementptr inbounds i8, ptr %18, i64 152
  %33 = load i64, ptr %32, align 8
  %34 = icmp sgt i64 %33, 0
  br i1 %34, label %35, label %36

35:                                               ; preds = %31
  tail call fastcc void @sample(ptr noundef nonnull %18) #12
  br label %36

36:                                               ; preds = %31, %35
  %37 = load ptr, ptr %18, align 8
  %38 = load i64, ptr %37, align 8
  %39 = load ptr, ptr %24, align 8
  %40 = getelementptr inbounds i8, ptr %18, i64 48
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds i8, ptr %18, i64 96
  %43 = load ptr, ptr %42, align 8
  %44 = inttoptr i64 %38 to ptr
  %45 = load ptr, ptr %44, align 8
  %46 = tail call i32 %45(ptr noundef %39, ptr noundef %21, ptr noundef %41, ptr noundef %43, ptr noundef %23) #13
  %47 = load ptr, ptr %9, align 8
  %48 = load ptr, ptr %47, align 8
  %49 = getelementptr inbounds i8, ptr %48, i64 8
  %50 = load i64, ptr %49, align 8
  %51 = icmp sgt i64 %50, 0
  br i1 %51, label %52, label %54

52:                                               ; preds = %36
  %53 = getelementptr inbounds i8, ptr %6, i64 168
  br label %62

54:                                               ; preds = %62, %36
  %55 = sext i32 %46 to i64
  %56 = and i64 %55, %2
  %57 = getelementptr inbounds i8, ptr %0, i64 888
  %58 = load ptr, ptr %57, align 8
  %59 = load <8 x double>, ptr %58, align 8
  %60 = select <8 x i1> %8, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %61 = fadd <8 x double> %60, %59
  store <8 x double> %61, ptr %58, align 8
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %56, i64 noundef 3) #12
  ret i64 %56

62:                                               ; preds = %52, %62
  %63 = phi i64 [ 0, %52 ], [ %72, %62 ]
  %64 = load ptr, ptr %53, align 8
  %65 = load ptr, ptr %22, align 8
  %66 = shl nsw i64 %63, 6
  %67 = getelementptr inbounds i8, ptr %65, i64 %66
  %68 = load <8 x i64>, ptr %67, align 8
  %69 = getelementptr inbounds i8, ptr %64, i64 %66
  %70 = load <8 x i64>, ptr %69, align 8
  %71 = select <8 x i1> %8, <8 x i64> %68, <8 x i64> %70
  store <8 x i64> %71, ptr %69, align 8
  %72 = add nuw nsw i64 %63, 1
  %73 = load ptr, ptr %9, align 8
  %74 = load ptr, ptr %73, align 8
  %75 = getelementptr inbounds i8, ptr %74, i64 8
  %76 = load i64, ptr %75, align 8
  %77 = icmp slt i64 %72, %76
  br i1 %77, label %62, label %54, !llvm.loop !67
}

declare i64 @llvm.cttz.i64(i64, i1 immarg) #5

define internal fastcc void @settle(ptr noundef readonly %0) unnamed_addr #4 {
  %2 = getelementptr inbounds i8, ptr %0, i64 264
  %3 = getelementptr inbounds i8, ptr %0, i64 24
  %4 = getelementptr inbounds i8, ptr %0, i64 240
  %5 = getelementptr inbounds i8, ptr %0, i64 248
  br label %7

6:                                                ; preds = %51
  ret void

7:                                                ; preds = %1, %51
  %8 = phi i64 [ 0, %1 ], [ %53, %51 ]
  %9 = load ptr, ptr %2, align 8
  %10 = getelementptr inbounds double, ptr %9, i64 %8
  %11 = load double, ptr %10, align 8
  %12 = load ptr, ptr %3, align 8
  %13 = getelementptr inbounds double, ptr %12, i64 %8
  %14 = load double, ptr %13, align 8
  %15 = fcmp olt double %14, %11
  %16 = select i1 %15, double %14, double %11
  %17 = load i64, ptr %5, align 8
  %18 = icmp sgt i64 %17, 0
  br i1 %18, label %19, label %34

19:                                               ; preds = %7
  %20 = load ptr, ptr %4, align 8
  br label %21

21:                                               ; preds = %19, %21
  %22 = phi i64 [ 0, %19 ], [ %32, %21 ]
  %23 = phi i64 [ %17, %19 ], [ %31, %21 ]
  %24 = add nuw nsw i64 %22, %23
  %25 = lshr i64 %24, 1
  %26 = mul i64 %25, 24
  %27 = getelementptr inbounds i8, ptr %20, i64 %26
  %28 = load double, ptr %27, align 8
  %29 = fcmp ogt double %28, %16
  %30 = add nuw nsw i64 %25, 1
  %31 = select i1 %29, i64 %25, i64 %23
  %32 = select i1 %29, i64 %22, i64 %30
  %33 = icmp slt i64 %32, %31
  br i1 %33, label %21, label %34, !llvm.loop !42

34:                                               ; preds = %21, %7
  %35 = phi i64 [ 0, %7 ], [ %32, %21 ]
  %36 = load ptr, ptr %4, align 8
  %37 = mul i64 %35, 24
  %38 = getelementptr inbounds i8, ptr %36, i64 %37
  %39 = icmp eq i64 %35, 0
  br i1 %39, label %44, label %40

40:                                               ; preds = %34
  %41 = getelementptr inbounds i8, ptr %38, i64 -8
  %42 = load double, ptr %41, align 8
  %43 = fcmp olt double %16, %42
  br i1 %43, label %51, label %44

44:                                               ; preds = %40, %34
  %45 = icmp slt i64 %35, %17
  br i1 %45, label %46, label %50

46:                                               ; preds = %44
  %47 = getelementptr inbounds i8, ptr %38, i64 8
  %48 = load double, ptr %47, align 8
  %49 = fcmp ogt double %16, %48
  br i1 %49, label %51, label %50

50:                                               ; preds = %46, %44
  br label %51

51:                                               ; preds = %50, %46, %40
  %52 = phi double [ %42, %40 ], [ %16, %50 ], [ %48, %46 ]
  store double %52, ptr %13, align 8
  %53 = add nuw nsw i64 %8, 1
  %54 = icmp eq i64 %53, 8
  br i1 %54, label %6, label %7, !llvm.loop !68
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #4 {
  %2 = getelementptr inbounds i8, ptr %0, i64 152
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %14

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  %7 = getelementptr inbounds i8, ptr %0, i64 160
  %8 = getelementptr inbounds i8, ptr %0, i64 168
  %9 = getelementptr inbounds i8, ptr %0, i64 24
  %10 = getelementptr inbounds i8, ptr %0, i64 264
  %11 = getelementptr inbounds i8, ptr %0, i64 192
  %12 = getelementptr inbounds i8, ptr %0, i64 216
  %13 = getelementptr inbounds i8, ptr %0, i64 48
  br label %15

14:                                               ; preds = %22, %1
  ret void

15:                                               ; preds = %5, %22
  %16 = phi i64 [ 0, %5 ], [ %23, %22 ]
  %17 = load ptr, ptr %6, align 8
  %18 = load i64, ptr %7, align 8
  %19 = mul nsw i64 %18, %16
  %20 = getelementptr inbounds i64, ptr %17, i64 %19
  %21 = shl nsw i64 %16, 6
  br label %26

22:                                               ; preds = %77
  %23 = add nuw nsw i64 %16, 1
  %24 = load i64, ptr %2, align 8
  %25 = icmp slt i64 %23, %24
  br i1 %25, label %15, label %14, !llvm.loop !69

26:                                               ; preds = %15, %77
  %27 = phi i64 [ 0, %15 ], [ %104, %77 ]
  %28 = load ptr, ptr %8, align 8
  %29 = getelementptr inbounds i8, ptr %28, i64 %21
  %30 = getelementptr inbounds i64, ptr %29, i64 %27
  %31 = load ptr, ptr %9, align 8
  %32 = getelementptr inbounds double, ptr %31, i64 %27
  %33 = load double, ptr %32, align 8
  %34 = load ptr, ptr %10, align 8
  %35 = getelementptr inbounds double, ptr %34, i64 %27
  %36 = load double, ptr %35, align 8
  %37 = fcmp olt double %33, %36
  %38 = select i1 %37, double %33, double %36
  %39 = load ptr, ptr %6, align 8
  %40 = load i64, ptr %7, align 8
  %41 = mul nsw i64 %40, %16
  %42 = getelementptr inbounds i64, ptr %39, i64 %41
  %43 = getelementptr inbounds i8, ptr %42, i64 8
  %44 = load i64, ptr %43, align 8
  %45 = load ptr, ptr %11, align 8
  %46 = getelementptr inbounds double, ptr %45, i64 %44
  %47 = load double, ptr %46, align 8
  %48 = fcmp ogt double %47, %38
  %49 = select i1 %48, double %47, double %38
  %50 = getelementptr inbounds i8, ptr %42, i64 16
  %51 = load i64, ptr %50, align 8
  %52 = load i64, ptr %30, align 8
  %53 = getelementptr inbounds double, ptr %46, i64 %52
  %54 = load double, ptr %53, align 8
  %55 = fcmp ugt double %54, %49
  br i1 %55, label %63, label %56

56:                                               ; preds = %26
  %57 = add nsw i64 %51, -1
  %58 = icmp eq i64 %57, %52
  br i1 %58, label %77, label %59

59:                                               ; preds = %56
  %60 = getelementptr i8, ptr %53, i64 8
  %61 = load double, ptr %60, align 8
  %62 = fcmp ogt double %61, %49
  br i1 %62, label %77, label %63

63:                                               ; preds = %59, %26
  %64 = icmp sgt i64 %51, 1
  br i1 %64, label %65, label %77

65:                                               ; preds = %63, %65
  %66 = phi i64 [ %74, %65 ], [ %51, %63 ]
  %67 = phi i64 [ %73, %65 ], [ 0, %63 ]
  %68 = add nsw i64 %66, %67
  %69 = sdiv i64 %68, 2
  %70 = getelementptr inbounds double, ptr %46, i64 %69
  %71 = load double, ptr %70, align 8
  %72 = fcmp ugt double %71, %49
  %73 = select i1 %72, i64 %67, i64 %69
  %74 = select i1 %72, i64 %69, i64 %66
  %75 = sub nsw i64 %74, %73
  %76 = icmp sgt i64 %75, 1
  br i1 %76, label %65, label %77, !llvm.loop !70

77:                                               ; preds = %65, %63, %56, %59
  %78 = phi i64 [ %52, %59 ], [ %52, %56 ], [ 0, %63 ], [ %73, %65 ]
  store i64 %78, ptr %30, align 8
  %79 = getelementptr inbounds double, ptr %46, i64 %78
  %80 = load double, ptr %79, align 8
  %81 = fsub double %49, %80
  %82 = load ptr, ptr %12, align 8
  %83 = add nsw i64 %78, %44
  %84 = shl nsw i64 %83, 5
  %85 = getelementptr inbounds i8, ptr %82, i64 %84
  %86 = load double, ptr %85, align 8
  %87 = getelementptr inbounds i8, ptr %85, i64 8
  %88 = load double, ptr %87, align 8
  %89 = getelementptr inbounds i8, ptr %85, i64 16
  %90 = load double, ptr %89, align 8
  %91 = getelementptr inbounds i8, ptr %85, i64 24
  %92 = load double, ptr %91, align 8
  %93 = fmul double %81, %92
  %94 = fadd double %90, %93
  %95 = fmul double %81, %94
  %96 = fadd double %88, %95
  %97 = fmul double %81, %96
  %98 = fadd double %86, %97
  %99 = load ptr, ptr %13, align 8
  %100 = load i64, ptr %20, align 8
  %101 = shl i64 %100, 6
  %102 = getelementptr i8, ptr %99, i64 %101
  %103 = getelementptr double, ptr %102, i64 %27
  store double %98, ptr %103, align 8
  %104 = add nuw nsw i64 %27, 1
  %105 = icmp eq i64 %104, 8
  br i1 %105, label %22, label %26, !llvm.loop !71
}

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
  br i1 %48, label %13, label %20, !llvm.loop !72
}

declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #5

declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #5

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #5

declare <8 x double> @llvm.rint.v8f64(<8 x double>) #5

declare <8 x double> @llvm.ceil.v8f64(<8 x double>) #5

define internal fastcc void @empty_log(ptr noundef readonly %0, i64 noundef %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 1272
  %4 = getelementptr inbounds i8, ptr %0, i64 1224
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i64, ptr %5, i64 %1
  %7 = load i64, ptr %6, align 8
  %8 = inttoptr i64 %7 to ptr
  %9 = getelementptr inbounds i8, ptr %8, i64 648
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 80
  %12 = getelementptr inbounds i8, ptr %0, i64 1632
  %13 = getelementptr inbounds i8, ptr %0, i64 1648
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 1592
  %16 = load i64, ptr %11, align 8
  %17 = icmp sgt i64 %16, 0
  br i1 %17, label %18, label %33

18:                                               ; preds = %2
  %19 = getelementptr inbounds i8, ptr %0, i64 1584
  %20 = getelementptr inbounds i8, ptr %0, i64 936
  %21 = getelementptr inbounds i8, ptr %0, i64 1560
  %22 = getelementptr inbounds i8, ptr %8, i64 1056
  %23 = getelementptr inbounds i8, ptr %8, i64 1080
  %24 = getelementptr inbounds i8, ptr %0, i64 1608
  %25 = icmp sgt i64 %14, 0
  %26 = getelementptr inbounds i8, ptr %8, i64 1104
  %27 = getelementptr inbounds i8, ptr %8, i64 1128
  %28 = getelementptr inbounds i8, ptr %0, i64 1656
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
  br i1 %60, label %29, label %33, !llvm.loop !73

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
  br i1 %76, label %57, label %61, !llvm.loop !74
}

declare void @llvm.memset.p0.i64(ptr writeonly, i8, i64, i1 immarg) #7

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
  br i1 %50, label %51, label %25, !llvm.loop !75

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
  br i1 %98, label %14, label %19, !llvm.loop !76

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
  br i1 %123, label %104, label %110, !llvm.loop !75

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
  br i1 %138, label %99, label %139, !llvm.loop !77

139:                                              ; preds = %135, %14
  ret void
}

define internal fastcc range(i64 0, 256) i64 @quiet_lanes(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef readonly %3) unnamed_addr #3 {
  %5 = alloca [5 x <8 x double>], align 64
  %6 = getelementptr inbounds i8, ptr %0, i64 1272
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 1224
  %11 = load ptr, ptr %10, align 8
  %12 = load i64, ptr %11, align 8
  %13 = inttoptr i64 %12 to ptr
  %14 = getelementptr inbounds i8, ptr %13, i64 864
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 1464
  %17 = load ptr, ptr %16, align 8
  %18 = load <8 x double>, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 696
  %20 = load ptr, ptr %19, align 8
  %21 = load <8 x double>, ptr %20, align 8
  %22 = fcmp une <8 x double> %18, %21
  %23 = bitcast <8 x i1> %22 to i8
  %24 = zext i8 %23 to i64
  %25 = and i64 %24, %2
  %26 = icmp eq i64 %25, 0
  br i1 %26, label %101, label %27

27:                                               ; preds = %4
  %28 = getelementptr inbounds i8, ptr %0, i64 1416
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds i8, ptr %0, i64 144
  %31 = getelementptr inbounds i8, ptr %1, i64 16
  %32 = load ptr, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %32, i64 72
  %34 = load ptr, ptr %33, align 8
  %35 = load <8 x double>, ptr %34, align 8
  %36 = getelementptr inbounds i8, ptr %32, i64 48
  %37 = load ptr, ptr %36, align 8
  %38 = getelementptr inbounds i8, ptr %32, i64 96
  %39 = load ptr, ptr %38, align 8
  store <8 x double> zeroinitializer, ptr %39, align 8
  %40 = load ptr, ptr %32, align 8
  %41 = getelementptr inbounds i8, ptr %32, i64 192
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds i8, ptr %32, i64 8
  %44 = load i64, ptr %43, align 8
  %45 = load ptr, ptr %1, align 8
  %46 = load ptr, ptr %45, align 8
  %47 = getelementptr inbounds i8, ptr %46, i64 24
  %48 = load i64, ptr %47, align 8
  %49 = load ptr, ptr %38, align 8
  %50 = getelementptr inbounds i8, ptr %1, i64 8
  %51 = load ptr, ptr %50, align 8
  %52 = load ptr, ptr %51, align 8
  %53 = getelementptr inbounds i8, ptr %52, i64 16
  %54 = load i64, ptr %53, align 8
  tail call fastcc void @nested(ptr noundef %37, ptr noundef %40, ptr noundef %42, i64 noundef %44, i64 noundef %48, ptr noundef %49, i64 noundef %54) #12
  %55 = fmul <8 x double> %35, zeroinitializer
  %56 = fadd <8 x double> %21, %55
  %57 = getelementptr inbounds i8, ptr %0, i64 168
  %58 = load ptr, ptr %57, align 8
  store <8 x double> %56, ptr %58, align 8
  %59 = load ptr, ptr %30, align 8
  %60 = getelementptr inbounds i8, ptr %59, i64 40
  %61 = load i64, ptr %60, align 8
  %62 = icmp eq i64 %61, 0
  br i1 %62, label %64, label %63

63:                                               ; preds = %27
  tail call fastcc void @settle(ptr noundef nonnull %30) #12
  br label %64

64:                                               ; preds = %63, %27
  %65 = getelementptr inbounds i8, ptr %0, i64 296
  %66 = load i64, ptr %65, align 8
  %67 = icmp sgt i64 %66, 0
  br i1 %67, label %68, label %69

68:                                               ; preds = %64
  tail call fastcc void @sample(ptr noundef nonnull %30) #12
  br label %69

69:                                               ; preds = %64, %68
  %70 = load ptr, ptr %6, align 8
  %71 = load i64, ptr %70, align 8
  %72 = getelementptr inbounds i8, ptr %0, i64 168
  %73 = load ptr, ptr %72, align 8
  %74 = load ptr, ptr %31, align 8
  %75 = getelementptr inbounds i8, ptr %74, i64 48
  %76 = load ptr, ptr %75, align 8
  %77 = getelementptr inbounds i8, ptr %0, i64 192
  %78 = load ptr, ptr %77, align 8
  %79 = getelementptr inbounds i8, ptr %0, i64 1296
  %80 = load ptr, ptr %79, align 8
  %81 = inttoptr i64 %71 to ptr
  %82 = load ptr, ptr %81, align 8
  %83 = tail call i32 %82(ptr noundef %73, ptr noundef %76, ptr noundef %78, ptr noundef %80, ptr noundef %29) #13
  %84 = zext i32 %83 to i64
  %85 = and i64 %84, %24
  %86 = icmp sgt i64 %9, 0
  br i1 %86, label %87, label %101

87:                                               ; preds = %69
  %88 = getelementptr inbounds i8, ptr %0, i64 1392
  br label %89

89:                                               ; preds = %87, %89
  %90 = phi i64 [ 0, %87 ], [ %99, %89 ]
  %91 = load ptr, ptr %88, align 8
  %92 = load ptr, ptr %28, align 8
  %93 = shl nsw i64 %90, 6
  %94 = getelementptr inbounds i8, ptr %92, i64 %93
  %95 = load <8 x i64>, ptr %94, align 8
  %96 = getelementptr inbounds i8, ptr %91, i64 %93
  %97 = load <8 x i64>, ptr %96, align 8
  %98 = select <8 x i1> %22, <8 x i64> %95, <8 x i64> %97
  store <8 x i64> %98, ptr %96, align 8
  %99 = add nuw nsw i64 %90, 1
  %100 = icmp eq i64 %99, %9
  br i1 %100, label %101, label %89, !llvm.loop !78

101:                                              ; preds = %89, %69, %4
  %102 = phi i64 [ 0, %4 ], [ %85, %69 ], [ %85, %89 ]
  %103 = getelementptr inbounds i8, ptr %0, i64 1392
  %104 = shl i64 %9, 6
  %105 = getelementptr inbounds i8, ptr %0, i64 144
  %106 = getelementptr inbounds i8, ptr %1, i64 16
  %107 = getelementptr inbounds i8, ptr %1, i64 8
  %108 = getelementptr inbounds i8, ptr %0, i64 168
  %109 = getelementptr inbounds i8, ptr %0, i64 296
  %110 = getelementptr inbounds i8, ptr %0, i64 168
  %111 = getelementptr inbounds i8, ptr %0, i64 192
  %112 = getelementptr inbounds i8, ptr %0, i64 1296
  br label %126

113:                                              ; preds = %172
  %114 = xor i64 %185, -1
  %115 = and i64 %114, %2
  %116 = trunc i64 %115 to i8
  %117 = bitcast i8 %116 to <8 x i1>
  %118 = sext <8 x i1> %117 to <8 x i64>
  %119 = icmp sgt i64 %9, 0
  br i1 %119, label %120, label %188

120:                                              ; preds = %113
  %121 = getelementptr inbounds i8, ptr %0, i64 1440
  %122 = load ptr, ptr %121, align 8
  %123 = getelementptr inbounds i8, ptr %0, i64 1392
  %124 = load ptr, ptr %123, align 8
  %125 = getelementptr inbounds i8, ptr %5, i64 64
  br label %195

126:                                              ; preds = %101, %172
  %127 = phi i64 [ 1, %101 ], [ %186, %172 ]
  %128 = phi i64 [ %102, %101 ], [ %185, %172 ]
  %129 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %127
  %130 = load double, ptr %129, align 8
  %131 = load ptr, ptr %103, align 8
  %132 = mul i64 %104, %127
  %133 = getelementptr inbounds i8, ptr %131, i64 %132
  %134 = load ptr, ptr %19, align 8
  %135 = load <8 x double>, ptr %134, align 8
  %136 = load ptr, ptr %106, align 8
  %137 = getelementptr inbounds i8, ptr %136, i64 72
  %138 = load ptr, ptr %137, align 8
  %139 = load <8 x double>, ptr %138, align 8
  %140 = insertelement <8 x double> poison, double %130, i64 0
  %141 = shufflevector <8 x double> %140, <8 x double> poison, <8 x i32> zeroinitializer
  %142 = getelementptr inbounds i8, ptr %136, i64 48
  %143 = load ptr, ptr %142, align 8
  %144 = getelementptr inbounds i8, ptr %136, i64 96
  %145 = load ptr, ptr %144, align 8
  store <8 x double> %141, ptr %145, align 8
  %146 = load ptr, ptr %136, align 8
  %147 = getelementptr inbounds i8, ptr %136, i64 192
  %148 = load ptr, ptr %147, align 8
  %149 = getelementptr inbounds i8, ptr %136, i64 8
  %150 = load i64, ptr %149, align 8
  %151 = load ptr, ptr %1, align 8
  %152 = load ptr, ptr %151, align 8
  %153 = getelementptr inbounds i8, ptr %152, i64 24
  %154 = load i64, ptr %153, align 8
  %155 = load ptr, ptr %144, align 8
  %156 = load ptr, ptr %107, align 8
  %157 = load ptr, ptr %156, align 8
  %158 = getelementptr inbounds i8, ptr %157, i64 16
  %159 = load i64, ptr %158, align 8
  tail call fastcc void @nested(ptr noundef %143, ptr noundef %146, ptr noundef %148, i64 noundef %150, i64 noundef %154, ptr noundef %155, i64 noundef %159) #12
  %160 = fmul <8 x double> %141, %139
  %161 = fadd <8 x double> %135, %160
  %162 = load ptr, ptr %108, align 8
  store <8 x double> %161, ptr %162, align 8
  %163 = load ptr, ptr %105, align 8
  %164 = getelementptr inbounds i8, ptr %163, i64 40
  %165 = load i64, ptr %164, align 8
  %166 = icmp eq i64 %165, 0
  br i1 %166, label %168, label %167

167:                                              ; preds = %126
  tail call fastcc void @settle(ptr noundef nonnull %105) #12
  br label %168

168:                                              ; preds = %167, %126
  %169 = load i64, ptr %109, align 8
  %170 = icmp sgt i64 %169, 0
  br i1 %170, label %171, label %172

171:                                              ; preds = %168
  tail call fastcc void @sample(ptr noundef nonnull %105) #12
  br label %172

172:                                              ; preds = %168, %171
  %173 = load ptr, ptr %6, align 8
  %174 = load i64, ptr %173, align 8
  %175 = load ptr, ptr %110, align 8
  %176 = load ptr, ptr %106, align 8
  %177 = getelementptr inbounds i8, ptr %176, i64 48
  %178 = load ptr, ptr %177, align 8
  %179 = load ptr, ptr %111, align 8
  %180 = load ptr, ptr %112, align 8
  %181 = inttoptr i64 %174 to ptr
  %182 = load ptr, ptr %181, align 8
  %183 = tail call i32 %182(ptr noundef %175, ptr noundef %178, ptr noundef %179, ptr noundef %180, ptr noundef %133) #13
  %184 = zext i32 %183 to i64
  %185 = or i64 %128, %184
  %186 = add nuw nsw i64 %127, 1
  %187 = icmp eq i64 %186, 5
  br i1 %187, label %113, label %126, !llvm.loop !79

188:                                              ; preds = %316, %113
  %189 = phi <8 x i64> [ %118, %113 ], [ %318, %316 ]
  %190 = icmp sgt i64 %9, 0
  br i1 %190, label %191, label %321

191:                                              ; preds = %188
  %192 = getelementptr inbounds i8, ptr %0, i64 1392
  %193 = shl i64 %9, 8
  %194 = icmp slt <8 x i64> %189, zeroinitializer
  br label %330

195:                                              ; preds = %120, %316
  %196 = phi <8 x double> [ undef, %120 ], [ %230, %316 ]
  %197 = phi <8 x double> [ undef, %120 ], [ %225, %316 ]
  %198 = phi i64 [ 0, %120 ], [ %319, %316 ]
  %199 = phi <8 x i64> [ %118, %120 ], [ %318, %316 ]
  %200 = shl nsw i64 %198, 6
  %201 = getelementptr inbounds i8, ptr %122, i64 %200
  %202 = load <8 x double>, ptr %201, align 8
  br label %208

203:                                              ; preds = %234
  %204 = getelementptr inbounds i64, ptr %15, i64 %198
  %205 = load i64, ptr %204, align 8
  %206 = and i64 %205, 1
  %207 = icmp eq i64 %206, 0
  br i1 %207, label %238, label %250

208:                                              ; preds = %195, %234
  %209 = phi i64 [ 0, %195 ], [ %236, %234 ]
  %210 = phi <8 x double> [ %196, %195 ], [ %230, %234 ]
  %211 = phi <8 x double> [ %197, %195 ], [ %225, %234 ]
  %212 = phi <8 x i64> [ %199, %195 ], [ %235, %234 ]
  %213 = mul nuw nsw i64 %9, %209
  %214 = add nuw nsw i64 %213, %198
  %215 = shl nsw i64 %214, 6
  %216 = getelementptr inbounds i8, ptr %124, i64 %215
  %217 = load <8 x double>, ptr %216, align 8
  %218 = fmul <8 x double> %202, %217
  %219 = getelementptr inbounds [5 x <8 x double>], ptr %5, i64 0, i64 %209
  store <8 x double> %218, ptr %219, align 64
  %220 = icmp eq i64 %209, 0
  br i1 %220, label %224, label %221

221:                                              ; preds = %208
  %222 = fcmp olt <8 x double> %211, %217
  %223 = select <8 x i1> %222, <8 x double> %211, <8 x double> %217
  br label %224

224:                                              ; preds = %208, %221
  %225 = phi <8 x double> [ %217, %208 ], [ %223, %221 ]
  br i1 %220, label %229, label %226

226:                                              ; preds = %224
  %227 = fcmp ogt <8 x double> %210, %217
  %228 = select <8 x i1> %227, <8 x double> %210, <8 x double> %217
  br label %229

229:                                              ; preds = %224, %226
  %230 = phi <8 x double> [ %217, %224 ], [ %228, %226 ]
  br i1 %220, label %234, label %231

231:                                              ; preds = %229
  %232 = fcmp ogt <8 x double> %218, zeroinitializer
  %233 = select <8 x i1> %232, <8 x i64> %212, <8 x i64> zeroinitializer
  br label %234

234:                                              ; preds = %229, %231
  %235 = phi <8 x i64> [ %233, %231 ], [ %212, %229 ]
  %236 = add nuw nsw i64 %209, 1
  %237 = icmp eq i64 %236, 5
  br i1 %237, label %203, label %208, !llvm.loop !80

238:                                              ; preds = %203
  %239 = fmul <8 x double> %225, %230
  %240 = fcmp ogt <8 x double> %239, zeroinitializer
  %241 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %225)
  %242 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %230)
  %243 = fcmp olt <8 x double> %241, %242
  %244 = select <8 x i1> %243, <8 x double> %241, <8 x double> %242
  %245 = fsub <8 x double> %230, %225
  %246 = fmul <8 x double> %245, <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>
  %247 = fcmp ogt <8 x double> %244, %246
  %248 = select <8 x i1> %247, <8 x i1> %240, <8 x i1> zeroinitializer
  %249 = select <8 x i1> %248, <8 x i64> %235, <8 x i64> zeroinitializer
  br label %250

250:                                              ; preds = %238, %203
  %251 = phi <8 x i64> [ %235, %203 ], [ %249, %238 ]
  %252 = load <8 x double>, ptr %125, align 64
  %253 = load <8 x double>, ptr %5, align 64
  %254 = fsub <8 x double> %252, %253
  %255 = fdiv <8 x double> %254, <double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C, double 0x3FCE3779B97F4A7C>
  br label %256

256:                                              ; preds = %250, %313
  %257 = phi i64 [ 1, %250 ], [ %263, %313 ]
  %258 = phi <8 x i64> [ zeroinitializer, %250 ], [ %314, %313 ]
  %259 = phi <8 x double> [ %255, %250 ], [ %274, %313 ]
  %260 = add nsw i64 %257, -1
  %261 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %257
  %262 = load double, ptr %261, align 8
  %263 = add nuw nsw i64 %257, 1
  %264 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %263
  %265 = load double, ptr %264, align 8
  %266 = getelementptr inbounds <8 x double>, ptr %5, i64 %263
  %267 = load <8 x double>, ptr %266, align 64
  %268 = getelementptr inbounds <8 x double>, ptr %5, i64 %257
  %269 = load <8 x double>, ptr %268, align 64
  %270 = fsub <8 x double> %267, %269
  %271 = fsub double %265, %262
  %272 = insertelement <8 x double> poison, double %271, i64 0
  %273 = shufflevector <8 x double> %272, <8 x double> poison, <8 x i32> zeroinitializer
  %274 = fdiv <8 x double> %270, %273
  %275 = fcmp ogt <8 x double> %274, %259
  %276 = getelementptr inbounds <8 x double>, ptr %5, i64 %260
  %277 = load <8 x double>, ptr %276, align 64
  %278 = fcmp ogt <8 x double> %277, zeroinitializer
  %279 = and <8 x i1> %275, %278
  %280 = bitcast <8 x i1> %279 to i8
  %281 = icmp eq i8 %280, 0
  br i1 %281, label %313, label %282

282:                                              ; preds = %256
  %283 = getelementptr inbounds [5 x double], ptr @scan_points, i64 0, i64 %260
  %284 = load double, ptr %283, align 8
  %285 = fsub <8 x double> %274, %259
  %286 = fsub double %265, %284
  %287 = insertelement <8 x double> poison, double %286, i64 0
  %288 = shufflevector <8 x double> %287, <8 x double> poison, <8 x i32> zeroinitializer
  %289 = fdiv <8 x double> %285, %288
  %290 = fsub double %262, %284
  %291 = insertelement <8 x double> poison, double %290, i64 0
  %292 = shufflevector <8 x double> %291, <8 x double> poison, <8 x i32> zeroinitializer
  %293 = fmul <8 x double> %292, %289
  %294 = fadd <8 x double> %259, %293
  %295 = insertelement <8 x double> poison, double %262, i64 0
  %296 = shufflevector <8 x double> %295, <8 x double> poison, <8 x i32> zeroinitializer
  %297 = fmul <8 x double> %294, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %298 = fdiv <8 x double> %297, %289
  %299 = fsub <8 x double> %296, %298
  %300 = icmp ugt i64 %257, 1
  %301 = select i1 %300, double %284, double 0xBFCE3779B97F4A7C
  %302 = icmp eq i64 %257, 3
  %303 = select i1 %302, double 0x3FF4498517A7B356, double %265
  %304 = insertelement <8 x double> poison, double %301, i64 0
  %305 = shufflevector <8 x double> %304, <8 x double> poison, <8 x i32> zeroinitializer
  %306 = fcmp oge <8 x double> %299, %305
  %307 = insertelement <8 x double> poison, double %303, i64 0
  %308 = shufflevector <8 x double> %307, <8 x double> poison, <8 x i32> zeroinitializer
  %309 = fcmp ole <8 x double> %299, %308
  %310 = and <8 x i1> %309, %306
  %311 = and <8 x i1> %310, %279
  %312 = select <8 x i1> %311, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, <8 x i64> %258
  br label %313

313:                                              ; preds = %282, %256
  %314 = phi <8 x i64> [ %312, %282 ], [ %258, %256 ]
  %315 = icmp eq i64 %263, 4
  br i1 %315, label %316, label %256, !llvm.loop !81

316:                                              ; preds = %313
  %317 = xor <8 x i64> %314, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %318 = and <8 x i64> %251, %317
  %319 = add nuw nsw i64 %198, 1
  %320 = icmp eq i64 %319, %9
  br i1 %320, label %188, label %195, !llvm.loop !82

321:                                              ; preds = %330, %188
  %322 = load ptr, ptr %16, align 8
  %323 = load <8 x i64>, ptr %3, align 8
  %324 = load <8 x i64>, ptr %322, align 8
  %325 = icmp slt <8 x i64> %189, zeroinitializer
  %326 = select <8 x i1> %325, <8 x i64> %323, <8 x i64> %324
  store <8 x i64> %326, ptr %322, align 8
  %327 = icmp ne <8 x i64> %189, zeroinitializer
  %328 = bitcast <8 x i1> %327 to i8
  %329 = zext i8 %328 to i64
  ret i64 %329

330:                                              ; preds = %191, %330
  %331 = phi i64 [ 0, %191 ], [ %341, %330 ]
  %332 = load ptr, ptr %192, align 8
  %333 = shl i64 %331, 6
  %334 = getelementptr i8, ptr %332, i64 %193
  %335 = getelementptr i8, ptr %334, i64 %333
  %336 = load <8 x i64>, ptr %335, align 8
  %337 = shl nsw i64 %331, 6
  %338 = getelementptr inbounds i8, ptr %332, i64 %337
  %339 = load <8 x i64>, ptr %338, align 8
  %340 = select <8 x i1> %194, <8 x i64> %336, <8 x i64> %339
  store <8 x i64> %340, ptr %338, align 8
  %341 = add nuw nsw i64 %331, 1
  %342 = icmp eq i64 %341, %9
  br i1 %342, label %321, label %330, !llvm.loop !83
}

define internal fastcc i64 @look_alone(ptr noundef readonly %0, i64 noundef %1, double noundef %2, ptr noundef writeonly %3) unnamed_addr #2 {
  %5 = getelementptr inbounds i8, ptr %0, i64 1224
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds i64, ptr %6, i64 %1
  %8 = load i64, ptr %7, align 8
  %9 = inttoptr i64 %8 to ptr
  %10 = getelementptr inbounds i8, ptr %0, i64 432
  %11 = getelementptr inbounds i8, ptr %9, i64 360
  %12 = getelementptr inbounds i8, ptr %0, i64 144
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %13, i64 8
  %15 = load i64, ptr %14, align 8
  %16 = icmp sgt i64 %15, 0
  br i1 %16, label %17, label %24

17:                                               ; preds = %4
  %18 = getelementptr inbounds i8, ptr %0, i64 456
  %19 = getelementptr inbounds i8, ptr %9, i64 384
  %20 = getelementptr inbounds i8, ptr %0, i64 624
  %21 = getelementptr inbounds i8, ptr %0, i64 440
  %22 = getelementptr inbounds i8, ptr %9, i64 552
  %23 = getelementptr inbounds i8, ptr %9, i64 368
  br label %129

24:                                               ; preds = %147, %4
  %25 = getelementptr inbounds i8, ptr %0, i64 1272
  %26 = load ptr, ptr %5, align 8
  %27 = getelementptr inbounds i64, ptr %26, i64 %1
  %28 = load i64, ptr %27, align 8
  %29 = inttoptr i64 %28 to ptr
  %30 = load ptr, ptr %25, align 8
  %31 = getelementptr inbounds i8, ptr %30, i64 8
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %29, i64 984
  %34 = load ptr, ptr %33, align 8
  %35 = shl nsw i64 %32, 4
  %36 = getelementptr inbounds i8, ptr %34, i64 %35
  %37 = mul i64 %32, 88
  %38 = getelementptr inbounds i8, ptr %34, i64 %37
  %39 = getelementptr inbounds i8, ptr %0, i64 1464
  %40 = load ptr, ptr %39, align 8
  %41 = getelementptr inbounds double, ptr %40, i64 %1
  %42 = load double, ptr %41, align 8
  store double %42, ptr %38, align 8
  %43 = icmp sgt i64 %32, 0
  br i1 %43, label %44, label %64

44:                                               ; preds = %24
  %45 = getelementptr inbounds i8, ptr %0, i64 1440
  %46 = getelementptr inbounds i8, ptr %29, i64 936
  %47 = getelementptr inbounds i8, ptr %0, i64 1392
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
  br i1 %63, label %64, label %48, !llvm.loop !64

64:                                               ; preds = %48, %24
  %65 = getelementptr inbounds i8, ptr %9, i64 624
  %66 = load ptr, ptr %65, align 8
  store double %2, ptr %66, align 8
  %67 = getelementptr inbounds i8, ptr %0, i64 696
  %68 = load ptr, ptr %67, align 8
  %69 = getelementptr inbounds double, ptr %68, i64 %1
  %70 = load double, ptr %69, align 8
  %71 = getelementptr inbounds i8, ptr %0, i64 408
  %72 = load ptr, ptr %71, align 8
  %73 = getelementptr inbounds double, ptr %72, i64 %1
  %74 = load double, ptr %73, align 8
  %75 = getelementptr inbounds i8, ptr %9, i64 336
  %76 = load ptr, ptr %75, align 8
  store double %74, ptr %76, align 8
  %77 = getelementptr inbounds i8, ptr %9, i64 768
  %78 = load ptr, ptr %77, align 8
  %79 = getelementptr inbounds i8, ptr %78, i64 16
  %80 = load i64, ptr %79, align 8
  %81 = inttoptr i64 %80 to ptr
  %82 = getelementptr inbounds i8, ptr %0, i64 504
  %83 = load ptr, ptr %82, align 8
  %84 = getelementptr inbounds double, ptr %83, i64 %1
  %85 = load double, ptr %84, align 8
  %86 = tail call i64 %81(ptr noundef %9, double noundef %70, double noundef %85) #13
  %87 = load ptr, ptr %75, align 8
  store double 0x7FF0000000000000, ptr %87, align 8
  %88 = load ptr, ptr %65, align 8
  %89 = getelementptr inbounds i8, ptr %88, i64 48
  %90 = load double, ptr %89, align 8
  store double %90, ptr %3, align 8
  %91 = load ptr, ptr %5, align 8
  %92 = getelementptr inbounds i64, ptr %91, i64 %1
  %93 = load i64, ptr %92, align 8
  %94 = inttoptr i64 %93 to ptr
  %95 = load ptr, ptr %25, align 8
  %96 = getelementptr inbounds i8, ptr %95, i64 8
  %97 = load i64, ptr %96, align 8
  %98 = getelementptr inbounds i8, ptr %94, i64 984
  %99 = load ptr, ptr %98, align 8
  %100 = shl nsw i64 %97, 4
  %101 = getelementptr inbounds i8, ptr %99, i64 %100
  %102 = mul i64 %97, 88
  %103 = getelementptr inbounds i8, ptr %99, i64 %102
  %104 = load double, ptr %103, align 8
  %105 = load ptr, ptr %39, align 8
  %106 = getelementptr inbounds double, ptr %105, i64 %1
  store double %104, ptr %106, align 8
  %107 = icmp sgt i64 %97, 0
  br i1 %107, label %108, label %128

108:                                              ; preds = %64
  %109 = getelementptr inbounds i8, ptr %94, i64 936
  %110 = getelementptr inbounds i8, ptr %0, i64 1440
  %111 = getelementptr inbounds i8, ptr %0, i64 1392
  br label %112

112:                                              ; preds = %108, %112
  %113 = phi i64 [ 0, %108 ], [ %126, %112 ]
  %114 = load ptr, ptr %109, align 8
  %115 = getelementptr inbounds i64, ptr %114, i64 %113
  %116 = load i64, ptr %115, align 8
  %117 = sitofp i64 %116 to double
  %118 = load ptr, ptr %110, align 8
  %119 = shl nsw i64 %113, 3
  %120 = add nsw i64 %119, %1
  %121 = getelementptr inbounds double, ptr %118, i64 %120
  store double %117, ptr %121, align 8
  %122 = getelementptr inbounds double, ptr %101, i64 %113
  %123 = load double, ptr %122, align 8
  %124 = load ptr, ptr %111, align 8
  %125 = getelementptr inbounds double, ptr %124, i64 %120
  store double %123, ptr %125, align 8
  %126 = add nuw nsw i64 %113, 1
  %127 = icmp eq i64 %126, %97
  br i1 %127, label %128, label %112, !llvm.loop !64

128:                                              ; preds = %112, %64
  ret i64 %86

129:                                              ; preds = %17, %147
  %130 = phi i64 [ 0, %17 ], [ %148, %147 ]
  %131 = load ptr, ptr %10, align 8
  %132 = shl nsw i64 %130, 3
  %133 = add nsw i64 %132, %1
  %134 = getelementptr inbounds double, ptr %131, i64 %133
  %135 = load double, ptr %134, align 8
  %136 = load ptr, ptr %11, align 8
  %137 = getelementptr inbounds double, ptr %136, i64 %130
  store double %135, ptr %137, align 8
  %138 = load ptr, ptr %18, align 8
  %139 = getelementptr inbounds double, ptr %138, i64 %133
  %140 = load double, ptr %139, align 8
  %141 = load ptr, ptr %19, align 8
  %142 = getelementptr inbounds double, ptr %141, i64 %130
  store double %140, ptr %142, align 8
  %143 = load ptr, ptr %0, align 8
  %144 = getelementptr inbounds i8, ptr %143, i64 24
  %145 = load i64, ptr %144, align 8
  %146 = icmp sgt i64 %145, 0
  br i1 %146, label %150, label %147

147:                                              ; preds = %150, %129
  %148 = add nuw nsw i64 %130, 1
  %149 = icmp eq i64 %148, %15
  br i1 %149, label %24, label %129, !llvm.loop !84

150:                                              ; preds = %129, %150
  %151 = phi i64 [ %164, %150 ], [ 0, %129 ]
  %152 = load ptr, ptr %20, align 8
  %153 = load i64, ptr %21, align 8
  %154 = mul nsw i64 %153, %151
  %155 = getelementptr double, ptr %152, i64 %154
  %156 = getelementptr double, ptr %155, i64 %132
  %157 = getelementptr double, ptr %156, i64 %1
  %158 = load double, ptr %157, align 8
  %159 = load ptr, ptr %22, align 8
  %160 = load i64, ptr %23, align 8
  %161 = mul nsw i64 %160, %151
  %162 = getelementptr double, ptr %159, i64 %161
  %163 = getelementptr double, ptr %162, i64 %130
  store double %158, ptr %163, align 8
  %164 = add nuw nsw i64 %151, 1
  %165 = load ptr, ptr %0, align 8
  %166 = getelementptr inbounds i8, ptr %165, i64 24
  %167 = load i64, ptr %166, align 8
  %168 = icmp slt i64 %164, %167
  br i1 %168, label %150, label %147, !llvm.loop !85
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
  br i1 %31, label %20, label %19, !llvm.loop !86

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
  br i1 %43, label %32, label %24, !llvm.loop !87
}

define internal fastcc double @knot_after(ptr noundef readonly %0, double noundef %1) unnamed_addr #9 {
  %3 = tail call double @llvm.fabs.f64(double %1)
  %4 = fmul double %3, 0x3D10000000000000
  %5 = fadd double %4, %1
  %6 = getelementptr inbounds i8, ptr %0, i64 152
  %7 = load i64, ptr %6, align 8
  %8 = icmp sgt i64 %7, 0
  br i1 %8, label %9, label %16

9:                                                ; preds = %2
  %10 = getelementptr inbounds i8, ptr %0, i64 144
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 160
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %0, i64 192
  %15 = load ptr, ptr %14, align 8
  br label %18

16:                                               ; preds = %68, %2
  %17 = phi double [ 0x7FF0000000000000, %2 ], [ %69, %68 ]
  ret double %17

18:                                               ; preds = %9, %68
  %19 = phi double [ 0x7FF0000000000000, %9 ], [ %69, %68 ]
  %20 = phi i64 [ 0, %9 ], [ %70, %68 ]
  %21 = mul nsw i64 %13, %20
  %22 = getelementptr inbounds i64, ptr %11, i64 %21
  %23 = getelementptr inbounds i8, ptr %22, i64 8
  %24 = load i64, ptr %23, align 8
  %25 = getelementptr inbounds double, ptr %15, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = fcmp ogt double %26, %5
  br i1 %27, label %58, label %28

28:                                               ; preds = %18
  %29 = getelementptr inbounds i8, ptr %22, i64 16
  %30 = load i64, ptr %29, align 8
  %31 = fcmp ugt double %26, %5
  br i1 %31, label %40, label %32

32:                                               ; preds = %28
  %33 = icmp eq i64 %30, 1
  br i1 %33, label %55, label %34

34:                                               ; preds = %32
  %35 = getelementptr i8, ptr %25, i64 8
  %36 = load double, ptr %35, align 8
  %37 = fcmp ule double %36, %5
  %38 = icmp sgt i64 %30, 1
  %39 = select i1 %37, i1 %38, i1 false
  br i1 %39, label %42, label %55

40:                                               ; preds = %28
  %41 = icmp sgt i64 %30, 1
  br i1 %41, label %42, label %55

42:                                               ; preds = %40, %34
  br label %43

43:                                               ; preds = %42, %43
  %44 = phi i64 [ %52, %43 ], [ %30, %42 ]
  %45 = phi i64 [ %51, %43 ], [ 0, %42 ]
  %46 = add nsw i64 %44, %45
  %47 = sdiv i64 %46, 2
  %48 = getelementptr inbounds double, ptr %25, i64 %47
  %49 = load double, ptr %48, align 8
  %50 = fcmp ugt double %49, %5
  %51 = select i1 %50, i64 %45, i64 %47
  %52 = select i1 %50, i64 %47, i64 %44
  %53 = sub nsw i64 %52, %51
  %54 = icmp sgt i64 %53, 1
  br i1 %54, label %43, label %55, !llvm.loop !70

55:                                               ; preds = %43, %40, %32, %34
  %56 = phi i64 [ 0, %34 ], [ 0, %32 ], [ 0, %40 ], [ %51, %43 ]
  %57 = add nsw i64 %56, 1
  br label %58

58:                                               ; preds = %18, %55
  %59 = phi i64 [ %57, %55 ], [ 0, %18 ]
  %60 = getelementptr inbounds i8, ptr %22, i64 16
  %61 = load i64, ptr %60, align 8
  %62 = icmp slt i64 %59, %61
  br i1 %62, label %63, label %68

63:                                               ; preds = %58
  %64 = getelementptr inbounds double, ptr %25, i64 %59
  %65 = load double, ptr %64, align 8
  %66 = fcmp olt double %65, %19
  br i1 %66, label %67, label %68

67:                                               ; preds = %63
  br label %68

68:                                               ; preds = %67, %63, %58
  %69 = phi double [ %65, %67 ], [ %19, %63 ], [ %19, %58 ]
  %70 = add nuw nsw i64 %20, 1
  %71 = icmp eq i64 %70, %7
  br i1 %71, label %16, label %18, !llvm.loop !88
}

declare double @llvm.fabs.f64(double) #5

declare <8 x i1> @llvm.is.fpclass.v8f64(<8 x double>, i32 immarg) #10

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { noinline nounwind }
attributes #5 = { nounwind willreturn memory(none) }
attributes #6 = { noinline nounwind }
attributes #7 = { nounwind willreturn }
attributes #8 = { noinline nounwind }
attributes #9 = { noinline nounwind }
attributes #10 = { nounwind willreturn memory(none) }
attributes #11 = { nounwind }
attributes #12 = { nounwind }
attributes #13 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = distinct !{!3, !4, !5}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
!6 = distinct !{!6, !4, !5}
!7 = distinct !{!7, !5}
!8 = !{!9}
!9 = distinct !{!9, !10, !"attempt: argument 0"}
!10 = distinct !{!10, !"attempt"}
!11 = distinct !{!11, !4, !5}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5}
!14 = distinct !{!14, !4, !5}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5}
!17 = distinct !{!17, !4, !5}
!18 = distinct !{!18, !4, !5}
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !4, !5}
!21 = distinct !{!21, !4, !5}
!22 = distinct !{!22, !4, !5, !23}
!23 = !{!"llvm.loop.vectorize.width", i32 1}
!24 = distinct !{!24, !4, !5}
!25 = distinct !{!25, !4, !5}
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5, !23}
!29 = distinct !{!29, !4, !5, !23}
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5}
!35 = distinct !{!35, !4, !5, !23}
!36 = distinct !{!36, !4, !5}
!37 = distinct !{!37, !4, !5}
!38 = distinct !{!38, !4, !5}
!39 = distinct !{!39, !4, !5}
!40 = distinct !{!40, !4, !5}
!41 = distinct !{!41, !4, !5}
!42 = distinct !{!42, !4, !5}
!43 = distinct !{!43, !4, !5}
!44 = distinct !{!44, !4, !5}
!45 = distinct !{!45, !4, !5, !23}
!46 = distinct !{!46, !4, !5, !23}
!47 = distinct !{!47, !4, !5}
!48 = distinct !{!48, !4, !5}
!49 = distinct !{!49, !4, !5}
!50 = distinct !{!50, !4, !5}
!51 = distinct !{!51, !4, !5}
!52 = distinct !{!52, !4, !5}
!53 = distinct !{!53, !4, !5}
!54 = distinct !{!54, !4, !5}
!55 = distinct !{!55, !4, !5, !23}
!56 = distinct !{!56, !5}
!57 = distinct !{!57, !4, !5}
!58 = distinct !{!58, !4, !5}
!59 = distinct !{!59, !4, !5}
!60 = distinct !{!60, !4, !5, !23}
!61 = distinct !{!61, !4, !5}
!62 = distinct !{!62, !4, !5}
!63 = distinct !{!63, !4, !5}
!64 = distinct !{!64, !4, !5, !23}
!65 = distinct !{!65, !4, !5}
!66 = distinct !{!66, !4, !5}
!67 = distinct !{!67, !4, !5}
!68 = distinct !{!68, !4, !5}
!69 = distinct !{!69, !4, !5}
!70 = distinct !{!70, !4, !5}
!71 = distinct !{!71, !4, !5}
!72 = distinct !{!72, !4, !5}
!73 = distinct !{!73, !4, !5}
!74 = distinct !{!74, !4, !5, !23}
!75 = distinct !{!75, !4, !5}
!76 = distinct !{!76, !4, !5}
!77 = distinct !{!77, !4, !5}
!78 = distinct !{!78, !4, !5}
!79 = distinct !{!79, !4, !5}
!80 = distinct !{!80, !4, !5}
!81 = distinct !{!81, !4, !5}
!82 = distinct !{!82, !4, !5}
!83 = distinct !{!83, !4, !5}
!84 = distinct !{!84, !4, !5, !23}
!85 = distinct !{!85, !4, !5}
!86 = distinct !{!86, !4, !5}
!87 = distinct !{!87, !4, !5}
!88 = distinct !{!88, !4, !5}
