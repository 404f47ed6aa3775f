; sources 5635305cc9b32b9636d46eba76c3026f713d44cf7df4051c2e470caeb924e1e6
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

@PLACES = internal unnamed_addr constant [5 x double] [double 0.000000e+00, double 0x3FCE3779B97F4A7C, double 0x3FDCC470A0490974, double 0x3FE76CF5D0B09954, double 1.000000e+00], align 16

define noundef i64 @step_lanes(ptr noundef %0) #0 {
  %2 = alloca %struct.Stepper, align 8
  %3 = alloca [8 x double], align 16
  %4 = alloca [8 x double], align 16
  %5 = alloca [8 x double], align 16
  %6 = alloca i64, align 8
  %7 = alloca [8 x i64], align 16
  %8 = alloca i64, align 8
  store ptr %0, ptr %2, align 8
  %9 = getelementptr inbounds i8, ptr %2, i64 8
  %10 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %10, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %2, i64 16
  %12 = getelementptr inbounds i8, ptr %0, i64 432
  store ptr %12, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 984
  %14 = load ptr, ptr %10, align 8
  %15 = getelementptr inbounds i8, ptr %14, i64 8
  %16 = load i64, ptr %15, align 8
  %17 = load ptr, ptr %0, align 8
  %18 = getelementptr inbounds i8, ptr %0, i64 1032
  %19 = load ptr, ptr %18, align 8
  %20 = getelementptr inbounds i8, ptr %0, i64 1040
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr double, ptr %19, i64 %21
  %23 = getelementptr i8, ptr %22, i64 -16
  %24 = load double, ptr %23, align 8
  %25 = getelementptr inbounds i8, ptr %0, i64 1008
  %26 = load ptr, ptr %25, align 8
  %27 = load double, ptr %26, align 8
  %28 = load ptr, ptr %13, align 8
  %29 = getelementptr inbounds i8, ptr %28, i64 16
  %30 = load i64, ptr %29, align 8
  %31 = getelementptr inbounds i8, ptr %0, i64 120
  %32 = load ptr, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %17, i64 8
  %34 = load i64, ptr %33, align 8
  %35 = icmp sgt i64 %34, 0
  %36 = getelementptr inbounds i8, ptr %17, i64 32
  %37 = load i64, ptr %36, align 8
  %38 = getelementptr inbounds i8, ptr %0, i64 1656
  %39 = load ptr, ptr %38, align 8
  %40 = load i64, ptr %39, align 8
  %41 = icmp eq i64 %40, 1
  %42 = getelementptr inbounds i8, ptr %0, i64 1248
  %43 = load ptr, ptr %42, align 8
  %44 = getelementptr inbounds i8, ptr %43, i64 8
  %45 = load i64, ptr %44, align 8
  %46 = getelementptr inbounds i8, ptr %0, i64 600
  %47 = load ptr, ptr %46, align 8
  %48 = load i64, ptr %17, align 8
  %49 = getelementptr inbounds i8, ptr %0, i64 440
  %50 = load i64, ptr %49, align 8
  %51 = mul nsw i64 %50, %48
  store i64 0, ptr %6, align 8
  %52 = getelementptr inbounds i8, ptr %0, i64 936
  %53 = load ptr, ptr %52, align 8
  br label %140

54:                                               ; preds = %140
  %55 = getelementptr inbounds i8, ptr %0, i64 696
  %56 = sitofp i64 %30 to double
  %57 = zext i1 %35 to i32
  %58 = icmp ne i64 %37, 1
  %59 = select i1 %41, i1 true, i1 %58
  %60 = icmp sgt i64 %45, 0
  %61 = getelementptr inbounds double, ptr %47, i64 %51
  store i64 %148, ptr %6, align 8
  %62 = getelementptr inbounds i8, ptr %0, i64 936
  %63 = getelementptr inbounds i8, ptr %0, i64 1568
  %64 = getelementptr inbounds i8, ptr %0, i64 1200
  %65 = getelementptr inbounds i8, ptr %0, i64 816
  %66 = insertelement <8 x double> poison, double %24, i64 0
  %67 = shufflevector <8 x double> %66, <8 x double> poison, <8 x i32> zeroinitializer
  %68 = getelementptr inbounds i8, ptr %0, i64 720
  %69 = insertelement <8 x double> poison, double %27, i64 0
  %70 = shufflevector <8 x double> %69, <8 x double> poison, <8 x i32> zeroinitializer
  %71 = getelementptr inbounds i8, ptr %0, i64 840
  %72 = getelementptr inbounds i8, ptr %0, i64 864
  %73 = insertelement <8 x double> poison, double %56, i64 0
  %74 = shufflevector <8 x double> %73, <8 x double> poison, <8 x i32> zeroinitializer
  %75 = getelementptr inbounds i8, ptr %0, i64 504
  %76 = getelementptr inbounds i8, ptr %0, i64 480
  %77 = getelementptr inbounds i8, ptr %0, i64 24
  %78 = getelementptr inbounds i8, ptr %0, i64 600
  %79 = getelementptr inbounds i8, ptr %0, i64 48
  %80 = getelementptr inbounds i8, ptr %0, i64 72
  %81 = getelementptr inbounds i8, ptr %0, i64 440
  %82 = getelementptr inbounds i8, ptr %0, i64 96
  %83 = getelementptr inbounds i8, ptr %0, i64 168
  %84 = getelementptr inbounds i8, ptr %0, i64 296
  %85 = getelementptr inbounds i8, ptr %0, i64 192
  %86 = getelementptr inbounds i8, ptr %0, i64 240
  %87 = getelementptr inbounds i8, ptr %0, i64 456
  %88 = getelementptr inbounds i8, ptr %0, i64 24
  %89 = getelementptr inbounds i8, ptr %0, i64 600
  %90 = getelementptr inbounds i8, ptr %0, i64 48
  %91 = getelementptr inbounds i8, ptr %0, i64 72
  %92 = getelementptr inbounds i8, ptr %0, i64 456
  %93 = getelementptr inbounds i8, ptr %0, i64 168
  %94 = getelementptr inbounds i8, ptr %0, i64 296
  %95 = getelementptr inbounds i8, ptr %0, i64 192
  %96 = getelementptr inbounds i8, ptr %0, i64 240
  %97 = icmp sgt i64 %16, 0
  %98 = getelementptr inbounds i8, ptr %0, i64 456
  %99 = getelementptr inbounds i8, ptr %0, i64 576
  %100 = getelementptr inbounds i8, ptr %0, i64 440
  %101 = getelementptr inbounds i8, ptr %0, i64 552
  %102 = getelementptr inbounds i8, ptr %0, i64 672
  %103 = getelementptr inbounds i8, ptr %0, i64 648
  %104 = getelementptr inbounds i8, ptr %0, i64 456
  %105 = getelementptr inbounds i8, ptr %0, i64 456
  %106 = getelementptr inbounds i8, ptr %0, i64 168
  %107 = getelementptr inbounds i8, ptr %0, i64 296
  %108 = getelementptr inbounds i8, ptr %0, i64 192
  %109 = getelementptr inbounds i8, ptr %0, i64 240
  %110 = getelementptr inbounds i8, ptr %0, i64 888
  %111 = sext i1 %58 to i64
  %112 = uitofp i1 %59 to double
  %113 = insertelement <8 x double> poison, double %112, i64 0
  %114 = bitcast <8 x double> %113 to <8 x i64>
  %115 = shufflevector <8 x i64> %114, <8 x i64> poison, <8 x i32> zeroinitializer
  %116 = getelementptr inbounds i8, ptr %0, i64 816
  %117 = getelementptr inbounds i8, ptr %0, i64 440
  %118 = getelementptr inbounds i8, ptr %0, i64 624
  %119 = getelementptr inbounds i8, ptr %0, i64 480
  %120 = getelementptr inbounds i8, ptr %0, i64 96
  %121 = getelementptr inbounds i8, ptr %0, i64 168
  %122 = getelementptr inbounds i8, ptr %0, i64 296
  %123 = getelementptr inbounds i8, ptr %0, i64 192
  %124 = getelementptr inbounds i8, ptr %0, i64 240
  %125 = getelementptr inbounds i8, ptr %0, i64 552
  %126 = getelementptr inbounds i8, ptr %17, i64 16
  %127 = getelementptr inbounds i8, ptr %0, i64 456
  %128 = getelementptr inbounds i8, ptr %0, i64 744
  %129 = getelementptr inbounds i8, ptr %0, i64 768
  %130 = getelementptr inbounds i8, ptr %32, i64 24
  %131 = getelementptr inbounds i8, ptr %32, i64 8
  %132 = getelementptr inbounds i8, ptr %32, i64 16
  %133 = getelementptr inbounds i8, ptr %32, i64 32
  %134 = getelementptr inbounds i8, ptr %32, i64 40
  %135 = getelementptr inbounds i8, ptr %32, i64 24
  %136 = getelementptr inbounds i8, ptr %32, i64 32
  %137 = getelementptr inbounds i8, ptr %0, i64 912
  %138 = icmp sgt i64 %16, 0
  %139 = getelementptr inbounds i8, ptr %0, i64 456
  br label %151

140:                                              ; preds = %1, %140
  %141 = phi i64 [ 0, %1 ], [ %149, %140 ]
  %142 = phi i64 [ 0, %1 ], [ %148, %140 ]
  %143 = getelementptr inbounds i64, ptr %53, i64 %141
  %144 = load i64, ptr %143, align 8
  %145 = icmp sgt i64 %144, -1
  %146 = zext i1 %145 to i64
  %147 = shl nuw nsw i64 %146, %141
  %148 = or i64 %147, %142
  %149 = add nuw nsw i64 %141, 1
  %150 = icmp eq i64 %149, 8
  br i1 %150, label %54, label %140, !llvm.loop !3

151:                                              ; preds = %186, %54
  %152 = phi i32 [ 1, %54 ], [ %187, %186 ]
  %153 = phi i64 [ 0, %54 ], [ %188, %186 ]
  %154 = icmp ne i32 %152, 0
  %155 = icmp ne i64 %153, 0
  %156 = select i1 %154, i1 true, i1 %155
  br i1 %156, label %157, label %189

157:                                              ; preds = %151
  br i1 %154, label %158, label %160

158:                                              ; preds = %157
  %159 = call fastcc i64 @fill(ptr noundef nonnull %0, ptr noundef nonnull %6) #10
  br label %160

160:                                              ; preds = %157, %158
  %161 = phi i64 [ %159, %158 ], [ 0, %157 ]
  %162 = load i64, ptr %6, align 8
  %163 = icmp eq i64 %162, 0
  br i1 %163, label %182, label %164

164:                                              ; preds = %160
  %165 = or i64 %161, %153
  %166 = icmp eq i64 %165, 0
  br i1 %166, label %182, label %167

167:                                              ; preds = %164
  call fastcc void @start(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %161, i64 noundef %153) #10
  br label %168

168:                                              ; preds = %167, %177
  %169 = phi i32 [ 0, %167 ], [ %179, %177 ]
  %170 = phi i64 [ 0, %167 ], [ %180, %177 ]
  %171 = icmp eq i32 %169, 0
  br i1 %171, label %172, label %177

172:                                              ; preds = %168
  %173 = load ptr, ptr %62, align 8
  %174 = getelementptr inbounds i64, ptr %173, i64 %170
  %175 = load i64, ptr %174, align 8
  %176 = icmp eq i64 %175, -1
  br label %177

177:                                              ; preds = %172, %168
  %178 = phi i1 [ true, %168 ], [ %176, %172 ]
  %179 = zext i1 %178 to i32
  %180 = add nuw nsw i64 %170, 1
  %181 = icmp eq i64 %180, 8
  br i1 %181, label %182, label %168, !llvm.loop !6

182:                                              ; preds = %177, %164, %160
  %183 = phi i32 [ 1, %160 ], [ 8, %164 ], [ 0, %177 ]
  %184 = phi i32 [ %152, %160 ], [ 0, %164 ], [ %179, %177 ]
  %185 = phi i64 [ %153, %160 ], [ %153, %164 ], [ 0, %177 ]
  switch i32 %183, label %1147 [
    i32 0, label %186
    i32 8, label %189
  ]

186:                                              ; preds = %182, %1145, %267
  %187 = phi i32 [ %184, %182 ], [ %1146, %1145 ], [ 1, %267 ]
  %188 = phi i64 [ %185, %182 ], [ %1121, %1145 ], [ %191, %267 ]
  br label %151, !llvm.loop !7

189:                                              ; preds = %182, %151
  %190 = phi i32 [ %184, %182 ], [ 0, %151 ]
  %191 = phi i64 [ %185, %182 ], [ 0, %151 ]
  %192 = load ptr, ptr %13, align 8
  %193 = getelementptr inbounds i8, ptr %192, i64 8
  %194 = load i64, ptr %193, align 8
  %195 = icmp slt i64 %194, 1
  br i1 %195, label %1147, label %196

196:                                              ; preds = %189
  br i1 %60, label %197, label %217

197:                                              ; preds = %196
  %198 = load i64, ptr %63, align 8
  %199 = icmp sgt i64 %198, 0
  br i1 %199, label %200, label %214

200:                                              ; preds = %197
  %201 = load ptr, ptr %42, align 8
  %202 = getelementptr inbounds i8, ptr %201, i64 72
  %203 = load i64, ptr %202, align 8
  %204 = load ptr, ptr %64, align 8
  %205 = load i64, ptr %204, align 8
  %206 = inttoptr i64 %205 to ptr
  %207 = getelementptr inbounds i8, ptr %206, i64 1064
  %208 = load i64, ptr %207, align 8
  %209 = shl i64 %208, 4
  %210 = add i64 %203, 16
  %211 = add i64 %210, %209
  %212 = icmp sgt i64 %211, %198
  %213 = zext i1 %212 to i32
  br label %214

214:                                              ; preds = %197, %200
  %215 = phi i32 [ 0, %197 ], [ %213, %200 ]
  %216 = icmp eq i32 %215, 0
  br i1 %216, label %217, label %1147

217:                                              ; preds = %214, %196
  %218 = add nsw i64 %194, -1
  store i64 %218, ptr %193, align 8
  %219 = load i64, ptr %6, align 8
  %220 = trunc i64 %219 to i8
  %221 = bitcast i8 %220 to <8 x i1>
  %222 = load ptr, ptr %55, align 8
  %223 = load <8 x double>, ptr %222, align 8
  call fastcc void @hold_all(ptr noundef nonnull %0, ptr noundef nonnull %5) #10
  br i1 %35, label %227, label %224

224:                                              ; preds = %217
  %225 = load ptr, ptr %65, align 8
  %226 = load <8 x double>, ptr %225, align 8
  br label %227

227:                                              ; preds = %217, %224
  %228 = phi <8 x double> [ %226, %224 ], [ %67, %217 ]
  %229 = load <8 x double>, ptr %5, align 16
  %230 = fcmp olt <8 x double> %228, %229
  %231 = select <8 x i1> %230, <8 x double> %228, <8 x double> %229
  %232 = load ptr, ptr %68, align 8
  %233 = load <8 x double>, ptr %232, align 8
  br i1 %35, label %234, label %237

234:                                              ; preds = %227
  %235 = fcmp olt <8 x double> %233, %70
  %236 = select <8 x i1> %235, <8 x double> %233, <8 x double> %70
  br label %243

237:                                              ; preds = %227
  %238 = fsub <8 x double> %231, %223
  %239 = fdiv <8 x double> %238, %233
  %240 = fmul <8 x double> %239, <double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1>
  %241 = call <8 x double> @llvm.ceil.v8f64(<8 x double> %240)
  %242 = fdiv <8 x double> %238, %241
  br label %243

243:                                              ; preds = %237, %234
  %244 = phi <8 x double> [ %236, %234 ], [ %242, %237 ]
  %245 = fadd <8 x double> %223, %244
  %246 = fmul <8 x double> %244, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %247 = fsub <8 x double> %231, %246
  %248 = fcmp ogt <8 x double> %245, %247
  %249 = select <8 x i1> %248, <8 x double> %231, <8 x double> %245
  %250 = fsub <8 x double> %249, %223
  %251 = select <8 x i1> %221, <8 x double> %250, <8 x double> zeroinitializer
  %252 = load ptr, ptr %71, align 8
  %253 = load <8 x double>, ptr %252, align 8
  %254 = load ptr, ptr %72, align 8
  %255 = load <8 x double>, ptr %254, align 8
  %256 = fadd <8 x double> %253, %255
  %257 = fcmp oge <8 x double> %256, %74
  %258 = fmul <8 x double> %251, <double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02>
  %259 = fadd <8 x double> %223, %258
  %260 = fcmp ule <8 x double> %259, %223
  %261 = fcmp une <8 x double> %249, %231
  %262 = and <8 x i1> %260, %261
  %263 = or <8 x i1> %262, %257
  %264 = and <8 x i1> %263, %221
  %265 = bitcast <8 x i1> %264 to i8
  %266 = icmp eq i8 %265, 0
  br i1 %266, label %274, label %267

267:                                              ; preds = %243
  %268 = zext i8 %265 to i64
  %269 = bitcast <8 x i1> %257 to i8
  %270 = zext i8 %269 to i64
  %271 = and i64 %268, %270
  call fastcc void @retire(ptr noundef %0, i64 noundef %271, i64 noundef 1) #10
  %272 = xor i64 %270, -1
  %273 = and i64 %268, %272
  call fastcc void @retire(ptr noundef %0, i64 noundef %273, i64 noundef -1) #10
  br label %186

274:                                              ; preds = %243
  %275 = load ptr, ptr %0, align 8
  %276 = load i64, ptr %275, align 8
  %277 = load ptr, ptr %75, align 8
  store <8 x double> %251, ptr %277, align 8
  %278 = icmp sgt i64 %276, 1
  br i1 %278, label %279, label %329

279:                                              ; preds = %274, %316
  %280 = phi i64 [ %326, %316 ], [ 0, %274 ]
  %281 = phi i64 [ %327, %316 ], [ 1, %274 ]
  %282 = load ptr, ptr %76, align 8
  %283 = load ptr, ptr %12, align 8
  %284 = load ptr, ptr %10, align 8
  %285 = getelementptr inbounds i8, ptr %284, i64 16
  %286 = load i64, ptr %285, align 8
  %287 = load ptr, ptr %77, align 8
  %288 = getelementptr inbounds i64, ptr %287, i64 %281
  %289 = load i64, ptr %288, align 8
  %290 = getelementptr i8, ptr %288, i64 8
  %291 = load i64, ptr %290, align 8
  %292 = xor i64 %289, -1
  %293 = add i64 %291, %292
  %294 = load ptr, ptr %75, align 8
  %295 = load ptr, ptr %78, align 8
  %296 = load ptr, ptr %79, align 8
  %297 = getelementptr inbounds i64, ptr %296, i64 %289
  %298 = load ptr, ptr %80, align 8
  %299 = getelementptr inbounds double, ptr %298, i64 %289
  call fastcc void @combine(ptr noundef %282, ptr noundef %283, ptr noundef %294, ptr noundef %295, ptr noundef %297, ptr noundef %299, i64 noundef %293, i64 noundef %286) #10
  %300 = load ptr, ptr %78, align 8
  %301 = load i64, ptr %81, align 8
  %302 = mul nsw i64 %301, %281
  %303 = getelementptr inbounds double, ptr %300, i64 %302
  %304 = load ptr, ptr %82, align 8
  %305 = getelementptr inbounds double, ptr %304, i64 %281
  %306 = load double, ptr %305, align 8
  %307 = insertelement <8 x double> poison, double %306, i64 0
  %308 = shufflevector <8 x double> %307, <8 x double> poison, <8 x i32> zeroinitializer
  %309 = fmul <8 x double> %251, %308
  %310 = fadd <8 x double> %223, %309
  %311 = load ptr, ptr %76, align 8
  %312 = load ptr, ptr %83, align 8
  store <8 x double> %310, ptr %312, align 8
  %313 = load i64, ptr %84, align 8
  %314 = icmp sgt i64 %313, 0
  br i1 %314, label %315, label %316

315:                                              ; preds = %279
  call fastcc void @sample(ptr noundef nonnull %10) #10
  br label %316

316:                                              ; preds = %279, %315
  %317 = load ptr, ptr %10, align 8
  %318 = load i64, ptr %317, align 8
  %319 = load ptr, ptr %83, align 8
  %320 = load ptr, ptr %85, align 8
  %321 = load ptr, ptr %86, align 8
  %322 = inttoptr i64 %318 to ptr
  %323 = load ptr, ptr %322, align 8
  %324 = call i32 %323(ptr noundef %319, ptr noundef %311, ptr noundef %320, ptr noundef %321, ptr noundef %303) #11
  %325 = zext i32 %324 to i64
  %326 = or i64 %280, %325
  %327 = add nuw nsw i64 %281, 1
  %328 = icmp eq i64 %327, %276
  br i1 %328, label %329, label %279, !llvm.loop !8

329:                                              ; preds = %316, %274
  %330 = phi i64 [ 0, %274 ], [ %326, %316 ]
  %331 = load ptr, ptr %87, align 8
  %332 = load ptr, ptr %12, align 8
  %333 = load ptr, ptr %10, align 8
  %334 = getelementptr inbounds i8, ptr %333, i64 16
  %335 = load i64, ptr %334, align 8
  %336 = load ptr, ptr %88, align 8
  %337 = getelementptr inbounds i64, ptr %336, i64 %276
  %338 = load i64, ptr %337, align 8
  %339 = getelementptr i8, ptr %337, i64 8
  %340 = load i64, ptr %339, align 8
  %341 = xor i64 %338, -1
  %342 = add i64 %340, %341
  %343 = load ptr, ptr %75, align 8
  %344 = load ptr, ptr %89, align 8
  %345 = load ptr, ptr %90, align 8
  %346 = getelementptr inbounds i64, ptr %345, i64 %338
  %347 = load ptr, ptr %91, align 8
  %348 = getelementptr inbounds double, ptr %347, i64 %338
  call fastcc void @combine(ptr noundef %331, ptr noundef %332, ptr noundef %343, ptr noundef %344, ptr noundef %346, ptr noundef %348, i64 noundef %342, i64 noundef %335) #10
  br i1 %58, label %366, label %349

349:                                              ; preds = %329
  %350 = load ptr, ptr %92, align 8
  %351 = load ptr, ptr %93, align 8
  store <8 x double> %249, ptr %351, align 8
  %352 = load i64, ptr %94, align 8
  %353 = icmp sgt i64 %352, 0
  br i1 %353, label %354, label %355

354:                                              ; preds = %349
  call fastcc void @sample(ptr noundef nonnull %10) #10
  br label %355

355:                                              ; preds = %349, %354
  %356 = load ptr, ptr %10, align 8
  %357 = load i64, ptr %356, align 8
  %358 = load ptr, ptr %93, align 8
  %359 = load ptr, ptr %95, align 8
  %360 = load ptr, ptr %96, align 8
  %361 = inttoptr i64 %357 to ptr
  %362 = load ptr, ptr %361, align 8
  %363 = call i32 %362(ptr noundef %358, ptr noundef %350, ptr noundef %359, ptr noundef %360, ptr noundef %61) #11
  %364 = zext i32 %363 to i64
  %365 = or i64 %330, %364
  br label %366

366:                                              ; preds = %355, %329
  %367 = phi i64 [ %365, %355 ], [ %330, %329 ]
  br i1 %35, label %371, label %368

368:                                              ; preds = %366
  br i1 %97, label %369, label %544

369:                                              ; preds = %368
  %370 = load ptr, ptr %98, align 8
  br label %534

371:                                              ; preds = %366
  %372 = load ptr, ptr %10, align 8
  %373 = load ptr, ptr %0, align 8
  %374 = getelementptr inbounds i8, ptr %372, i64 24
  %375 = load i64, ptr %374, align 8
  %376 = getelementptr inbounds i8, ptr %373, i64 8
  %377 = load i64, ptr %376, align 8
  %378 = load ptr, ptr %99, align 8
  %379 = load i64, ptr %100, align 8
  %380 = getelementptr inbounds double, ptr %378, i64 %379
  %381 = icmp sgt i64 %377, 0
  br i1 %381, label %382, label %384

382:                                              ; preds = %371
  %383 = getelementptr inbounds i8, ptr %372, i64 32
  br label %392

384:                                              ; preds = %392, %371
  %385 = icmp sgt i64 %375, 0
  br i1 %385, label %386, label %418

386:                                              ; preds = %384
  %387 = load ptr, ptr %12, align 8
  %388 = load ptr, ptr %87, align 8
  %389 = load ptr, ptr %102, align 8
  %390 = load ptr, ptr %103, align 8
  %391 = load ptr, ptr %99, align 8
  br label %481

392:                                              ; preds = %382, %392
  %393 = phi i64 [ 0, %382 ], [ %416, %392 ]
  %394 = load i64, ptr %373, align 8
  %395 = load i64, ptr %383, align 8
  %396 = load ptr, ptr %99, align 8
  %397 = load i64, ptr %100, align 8
  %398 = mul nsw i64 %397, %393
  %399 = getelementptr inbounds double, ptr %396, i64 %398
  %400 = load ptr, ptr %101, align 8
  %401 = load ptr, ptr %88, align 8
  %402 = getelementptr i64, ptr %401, i64 %394
  %403 = getelementptr i8, ptr %402, i64 8
  %404 = getelementptr i64, ptr %403, i64 %393
  %405 = load i64, ptr %404, align 8
  %406 = getelementptr i8, ptr %404, i64 8
  %407 = load i64, ptr %406, align 8
  %408 = xor i64 %405, -1
  %409 = add i64 %407, %408
  %410 = load ptr, ptr %75, align 8
  %411 = load ptr, ptr %89, align 8
  %412 = load ptr, ptr %90, align 8
  %413 = getelementptr inbounds i64, ptr %412, i64 %405
  %414 = load ptr, ptr %91, align 8
  %415 = getelementptr inbounds double, ptr %414, i64 %405
  call fastcc void @combine(ptr noundef %399, ptr noundef %400, ptr noundef %410, ptr noundef %411, ptr noundef %413, ptr noundef %415, i64 noundef %409, i64 noundef %395) #10
  %416 = add nuw nsw i64 %393, 1
  %417 = icmp eq i64 %416, %377
  br i1 %417, label %384, label %392, !llvm.loop !9

418:                                              ; preds = %481, %384
  %419 = phi <8 x double> [ zeroinitializer, %384 ], [ %514, %481 ]
  %420 = phi <8 x double> [ zeroinitializer, %384 ], [ %512, %481 ]
  %421 = load ptr, ptr %87, align 8
  %422 = getelementptr inbounds i8, ptr %372, i64 8
  %423 = load i64, ptr %422, align 8
  %424 = add nsw i64 %423, -3
  %425 = getelementptr i8, ptr %421, i64 64
  %426 = getelementptr i8, ptr %421, i64 128
  %427 = getelementptr i8, ptr %421, i64 192
  %428 = icmp slt i64 %375, %424
  br i1 %428, label %436, label %429

429:                                              ; preds = %436, %418
  %430 = phi <8 x double> [ zeroinitializer, %418 ], [ %446, %436 ]
  %431 = phi <8 x double> [ zeroinitializer, %418 ], [ %451, %436 ]
  %432 = phi <8 x double> [ zeroinitializer, %418 ], [ %456, %436 ]
  %433 = phi <8 x double> [ zeroinitializer, %418 ], [ %461, %436 ]
  %434 = phi i64 [ %375, %418 ], [ %462, %436 ]
  %435 = icmp slt i64 %434, %423
  br i1 %435, label %464, label %474

436:                                              ; preds = %418, %436
  %437 = phi i64 [ %462, %436 ], [ %375, %418 ]
  %438 = phi <8 x double> [ %461, %436 ], [ zeroinitializer, %418 ]
  %439 = phi <8 x double> [ %456, %436 ], [ zeroinitializer, %418 ]
  %440 = phi <8 x double> [ %451, %436 ], [ zeroinitializer, %418 ]
  %441 = phi <8 x double> [ %446, %436 ], [ zeroinitializer, %418 ]
  %442 = shl nsw i64 %437, 6
  %443 = getelementptr inbounds i8, ptr %421, i64 %442
  %444 = load <8 x double>, ptr %443, align 8
  %445 = fmul <8 x double> %444, zeroinitializer
  %446 = fadd <8 x double> %441, %445
  %447 = shl i64 %437, 6
  %448 = getelementptr i8, ptr %425, i64 %447
  %449 = load <8 x double>, ptr %448, align 8
  %450 = fmul <8 x double> %449, zeroinitializer
  %451 = fadd <8 x double> %440, %450
  %452 = shl i64 %437, 6
  %453 = getelementptr i8, ptr %426, i64 %452
  %454 = load <8 x double>, ptr %453, align 8
  %455 = fmul <8 x double> %454, zeroinitializer
  %456 = fadd <8 x double> %439, %455
  %457 = shl i64 %437, 6
  %458 = getelementptr i8, ptr %427, i64 %457
  %459 = load <8 x double>, ptr %458, align 8
  %460 = fmul <8 x double> %459, zeroinitializer
  %461 = fadd <8 x double> %438, %460
  %462 = add nsw i64 %437, 4
  %463 = icmp slt i64 %462, %424
  br i1 %463, label %436, label %429, !llvm.loop !10

464:                                              ; preds = %429, %464
  %465 = phi i64 [ %472, %464 ], [ %434, %429 ]
  %466 = phi <8 x double> [ %471, %464 ], [ %430, %429 ]
  %467 = shl nsw i64 %465, 6
  %468 = getelementptr inbounds i8, ptr %421, i64 %467
  %469 = load <8 x double>, ptr %468, align 8
  %470 = fmul <8 x double> %469, zeroinitializer
  %471 = fadd <8 x double> %466, %470
  %472 = add nsw i64 %465, 1
  %473 = icmp eq i64 %472, %423
  br i1 %473, label %474, label %464, !llvm.loop !11

474:                                              ; preds = %464, %429
  %475 = phi <8 x double> [ %430, %429 ], [ %471, %464 ]
  %476 = fadd <8 x double> %431, %475
  %477 = fadd <8 x double> %432, %433
  %478 = fadd <8 x double> %477, %476
  %479 = fadd <8 x double> %420, %478
  %480 = icmp eq i64 %377, 2
  br i1 %480, label %517, label %528

481:                                              ; preds = %386, %481
  %482 = phi <8 x double> [ zeroinitializer, %386 ], [ %512, %481 ]
  %483 = phi <8 x double> [ zeroinitializer, %386 ], [ %514, %481 ]
  %484 = phi i64 [ 0, %386 ], [ %515, %481 ]
  %485 = shl nsw i64 %484, 6
  %486 = getelementptr inbounds i8, ptr %387, i64 %485
  %487 = load <8 x double>, ptr %486, align 8
  %488 = getelementptr inbounds i8, ptr %388, i64 %485
  %489 = load <8 x double>, ptr %488, align 8
  %490 = getelementptr inbounds double, ptr %389, i64 %484
  %491 = load double, ptr %490, align 8
  %492 = insertelement <8 x double> poison, double %491, i64 0
  %493 = shufflevector <8 x double> %492, <8 x double> poison, <8 x i32> zeroinitializer
  %494 = getelementptr inbounds double, ptr %390, i64 %484
  %495 = load double, ptr %494, align 8
  %496 = insertelement <8 x double> poison, double %495, i64 0
  %497 = shufflevector <8 x double> %496, <8 x double> poison, <8 x i32> zeroinitializer
  %498 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %487)
  %499 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %489)
  %500 = fcmp ogt <8 x double> %498, %499
  %501 = select <8 x i1> %500, <8 x double> %498, <8 x double> %499
  %502 = fmul <8 x double> %501, %497
  %503 = fadd <8 x double> %493, %502
  %504 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %503
  %505 = getelementptr inbounds i8, ptr %391, i64 %485
  %506 = load <8 x double>, ptr %505, align 8
  %507 = fmul <8 x double> %506, %504
  %508 = getelementptr inbounds i8, ptr %380, i64 %485
  %509 = load <8 x double>, ptr %508, align 8
  %510 = fmul <8 x double> %509, %504
  %511 = fmul <8 x double> %507, %507
  %512 = fadd <8 x double> %482, %511
  %513 = fmul <8 x double> %510, %510
  %514 = fadd <8 x double> %483, %513
  %515 = add nuw nsw i64 %484, 1
  %516 = icmp eq i64 %515, %375
  br i1 %516, label %418, label %481, !llvm.loop !12

517:                                              ; preds = %474
  %518 = fmul <8 x double> %419, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %519 = fadd <8 x double> %518, %479
  %520 = sitofp i64 %375 to double
  %521 = insertelement <8 x double> poison, double %520, i64 0
  %522 = shufflevector <8 x double> %521, <8 x double> poison, <8 x i32> zeroinitializer
  %523 = fmul <8 x double> %522, %519
  %524 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %523)
  %525 = fdiv <8 x double> %479, %524
  %526 = fcmp oeq <8 x double> %479, zeroinitializer
  %527 = select <8 x i1> %526, <8 x double> zeroinitializer, <8 x double> %525
  br label %544

528:                                              ; preds = %474
  %529 = sitofp i64 %375 to double
  %530 = insertelement <8 x double> poison, double %529, i64 0
  %531 = shufflevector <8 x double> %530, <8 x double> poison, <8 x i32> zeroinitializer
  %532 = fdiv <8 x double> %479, %531
  %533 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %532)
  br label %544

534:                                              ; preds = %369, %534
  %535 = phi <8 x double> [ zeroinitializer, %369 ], [ %541, %534 ]
  %536 = phi i64 [ 0, %369 ], [ %542, %534 ]
  %537 = shl nsw i64 %536, 6
  %538 = getelementptr inbounds i8, ptr %370, i64 %537
  %539 = load <8 x double>, ptr %538, align 8
  %540 = fmul <8 x double> %539, zeroinitializer
  %541 = fadd <8 x double> %535, %540
  %542 = add nuw nsw i64 %536, 1
  %543 = icmp eq i64 %542, %16
  br i1 %543, label %544, label %534, !llvm.loop !13

544:                                              ; preds = %534, %368, %528, %517
  %545 = phi <8 x double> [ %527, %517 ], [ %533, %528 ], [ zeroinitializer, %368 ], [ %541, %534 ]
  %546 = fcmp uge <8 x double> %545, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %547 = trunc i64 %367 to i8
  %548 = bitcast i8 %547 to <8 x i1>
  %549 = select <8 x i1> %548, <8 x i1> <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>, <8 x i1> %546
  %550 = xor <8 x i1> %549, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %551 = select <8 x i1> %550, <8 x i1> %221, <8 x i1> zeroinitializer
  %552 = sext <8 x i1> %551 to <8 x i64>
  br i1 %41, label %553, label %565

553:                                              ; preds = %544
  %554 = xor <8 x i1> %549, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %555 = select <8 x i1> %554, <8 x i1> %221, <8 x i1> zeroinitializer
  %556 = bitcast <8 x i1> %555 to i8
  %557 = icmp eq i8 %556, 0
  br i1 %557, label %565, label %558

558:                                              ; preds = %553
  %559 = zext i8 %556 to i64
  store <8 x double> %249, ptr %3, align 16
  %560 = load ptr, ptr %104, align 8
  %561 = call fastcc i64 @hold_lanes(ptr noundef nonnull %0, ptr noundef nonnull %3, ptr noundef %560, i64 noundef %559, i32 noundef %57) #10
  %562 = trunc i64 %561 to i8
  %563 = bitcast i8 %562 to <8 x i1>
  %564 = select <8 x i1> %563, <8 x i64> zeroinitializer, <8 x i64> %552
  br label %565

565:                                              ; preds = %558, %553, %544
  %566 = phi i64 [ %561, %558 ], [ 0, %553 ], [ 0, %544 ]
  %567 = phi <8 x i64> [ %564, %558 ], [ %552, %553 ], [ %552, %544 ]
  %568 = icmp ne <8 x i64> %567, zeroinitializer
  %569 = bitcast <8 x i1> %568 to i8
  %570 = icmp ne i8 %569, 0
  %571 = select i1 %59, i1 %570, i1 false
  br i1 %571, label %572, label %592

572:                                              ; preds = %565
  %573 = load ptr, ptr %105, align 8
  %574 = load ptr, ptr %106, align 8
  store <8 x double> %249, ptr %574, align 8
  %575 = load i64, ptr %107, align 8
  %576 = icmp sgt i64 %575, 0
  br i1 %576, label %577, label %578

577:                                              ; preds = %572
  call fastcc void @sample(ptr noundef nonnull %10) #10
  br label %578

578:                                              ; preds = %572, %577
  %579 = load ptr, ptr %10, align 8
  %580 = load i64, ptr %579, align 8
  %581 = load ptr, ptr %106, align 8
  %582 = load ptr, ptr %108, align 8
  %583 = load ptr, ptr %109, align 8
  %584 = inttoptr i64 %580 to ptr
  %585 = load ptr, ptr %584, align 8
  %586 = call i32 %585(ptr noundef %581, ptr noundef %573, ptr noundef %582, ptr noundef %583, ptr noundef %61) #11
  %587 = zext i32 %586 to i64
  %588 = or i64 %367, %587
  %589 = trunc i64 %588 to i8
  %590 = bitcast i8 %589 to <8 x i1>
  %591 = select <8 x i1> %590, <8 x i64> zeroinitializer, <8 x i64> %567
  br label %592

592:                                              ; preds = %578, %565
  %593 = phi <8 x i64> [ %591, %578 ], [ %567, %565 ]
  %594 = phi i64 [ %588, %578 ], [ %367, %565 ]
  %595 = load ptr, ptr %110, align 8
  %596 = load <8 x double>, ptr %595, align 8
  %597 = load i64, ptr %17, align 8
  %598 = add i64 %597, %111
  %599 = sitofp i64 %598 to double
  %600 = insertelement <8 x double> poison, double %599, i64 0
  %601 = shufflevector <8 x double> %600, <8 x double> poison, <8 x i32> zeroinitializer
  %602 = icmp slt <8 x i64> %567, zeroinitializer
  %603 = select <8 x i1> %602, <8 x i64> %115, <8 x i64> zeroinitializer
  %604 = bitcast <8 x i64> %603 to <8 x double>
  %605 = fadd <8 x double> %601, %604
  %606 = fadd <8 x double> %596, %605
  store <8 x double> %606, ptr %595, align 8
  br i1 %60, label %607, label %616

607:                                              ; preds = %592
  %608 = icmp ne <8 x i64> %593, zeroinitializer
  %609 = bitcast <8 x i1> %608 to i8
  %610 = icmp eq i8 %609, 0
  br i1 %610, label %616, label %611

611:                                              ; preds = %607
  %612 = zext i8 %609 to i64
  %613 = call fastcc i64 @clear_lanes(ptr noundef %0) #10
  %614 = xor i64 %613, -1
  %615 = and i64 %614, %612
  br label %616

616:                                              ; preds = %592, %607, %611
  %617 = phi i64 [ %615, %611 ], [ 0, %607 ], [ 0, %592 ]
  store i64 0, ptr %8, align 8
  %618 = load ptr, ptr %116, align 8
  %619 = load <8 x double>, ptr %618, align 8
  %620 = fcmp olt <8 x double> %619, %249
  %621 = icmp ne <8 x i64> %593, zeroinitializer
  %622 = select <8 x i1> %620, <8 x i1> %621, <8 x i1> zeroinitializer
  %623 = bitcast <8 x i1> %622 to i8
  %624 = zext i8 %623 to i64
  %625 = or i64 %617, %624
  %626 = icmp eq i64 %625, 0
  br i1 %626, label %822, label %627

627:                                              ; preds = %616
  %628 = load ptr, ptr %0, align 8
  %629 = load ptr, ptr %10, align 8
  %630 = getelementptr inbounds i8, ptr %629, i64 16
  %631 = load i64, ptr %630, align 8
  %632 = load i64, ptr %628, align 8
  %633 = load i64, ptr %117, align 8
  %634 = load ptr, ptr %89, align 8
  %635 = mul nsw i64 %633, %632
  %636 = getelementptr inbounds double, ptr %634, i64 %635
  %637 = load ptr, ptr %118, align 8
  %638 = add nsw i64 %632, 1
  %639 = getelementptr inbounds i8, ptr %628, i64 16
  %640 = load i64, ptr %639, align 8
  %641 = icmp sgt i64 %640, 0
  br i1 %641, label %642, label %644

642:                                              ; preds = %627
  %643 = getelementptr inbounds i8, ptr %628, i64 8
  br label %655

644:                                              ; preds = %690, %627
  %645 = phi i64 [ 0, %627 ], [ %700, %690 ]
  %646 = getelementptr inbounds i8, ptr %628, i64 16
  %647 = load ptr, ptr %10, align 8
  %648 = getelementptr inbounds i8, ptr %647, i64 8
  %649 = load i64, ptr %648, align 8
  %650 = icmp sgt i64 %649, 0
  br i1 %650, label %651, label %705

651:                                              ; preds = %644
  %652 = getelementptr inbounds double, ptr %637, i64 %633
  %653 = shl nsw i64 %633, 4
  %654 = getelementptr inbounds i8, ptr %637, i64 %653
  br label %712

655:                                              ; preds = %642, %690
  %656 = phi i64 [ 0, %642 ], [ %700, %690 ]
  %657 = phi i64 [ %638, %642 ], [ %701, %690 ]
  %658 = load i64, ptr %643, align 8
  %659 = load ptr, ptr %119, align 8
  %660 = load ptr, ptr %12, align 8
  %661 = load ptr, ptr %88, align 8
  %662 = getelementptr i64, ptr %661, i64 %657
  %663 = getelementptr i64, ptr %662, i64 %658
  %664 = load i64, ptr %663, align 8
  %665 = getelementptr i8, ptr %663, i64 8
  %666 = load i64, ptr %665, align 8
  %667 = xor i64 %664, -1
  %668 = add i64 %666, %667
  %669 = load ptr, ptr %75, align 8
  %670 = load ptr, ptr %89, align 8
  %671 = load ptr, ptr %90, align 8
  %672 = getelementptr inbounds i64, ptr %671, i64 %664
  %673 = load ptr, ptr %91, align 8
  %674 = getelementptr inbounds double, ptr %673, i64 %664
  call fastcc void @combine(ptr noundef %659, ptr noundef %660, ptr noundef %669, ptr noundef %670, ptr noundef %672, ptr noundef %674, i64 noundef %668, i64 noundef %631) #10
  %675 = load ptr, ptr %89, align 8
  %676 = mul nsw i64 %657, %633
  %677 = getelementptr inbounds double, ptr %675, i64 %676
  %678 = load ptr, ptr %120, align 8
  %679 = getelementptr inbounds double, ptr %678, i64 %657
  %680 = load double, ptr %679, align 8
  %681 = insertelement <8 x double> poison, double %680, i64 0
  %682 = shufflevector <8 x double> %681, <8 x double> poison, <8 x i32> zeroinitializer
  %683 = fmul <8 x double> %251, %682
  %684 = fadd <8 x double> %223, %683
  %685 = load ptr, ptr %119, align 8
  %686 = load ptr, ptr %121, align 8
  store <8 x double> %684, ptr %686, align 8
  %687 = load i64, ptr %122, align 8
  %688 = icmp sgt i64 %687, 0
  br i1 %688, label %689, label %690

689:                                              ; preds = %655
  call fastcc void @sample(ptr noundef nonnull %10) #10
  br label %690

690:                                              ; preds = %655, %689
  %691 = load ptr, ptr %10, align 8
  %692 = load i64, ptr %691, align 8
  %693 = load ptr, ptr %121, align 8
  %694 = load ptr, ptr %123, align 8
  %695 = load ptr, ptr %124, align 8
  %696 = inttoptr i64 %692 to ptr
  %697 = load ptr, ptr %696, align 8
  %698 = call i32 %697(ptr noundef %693, ptr noundef %685, ptr noundef %694, ptr noundef %695, ptr noundef %677) #11
  %699 = sext i32 %698 to i64
  %700 = or i64 %656, %699
  %701 = add nsw i64 %657, 1
  %702 = load i64, ptr %639, align 8
  %703 = add nsw i64 %702, %638
  %704 = icmp slt i64 %701, %703
  br i1 %704, label %655, label %644, !llvm.loop !14

705:                                              ; preds = %712, %644
  %706 = getelementptr inbounds i8, ptr %628, i64 8
  %707 = load i64, ptr %706, align 8
  %708 = load i64, ptr %646, align 8
  %709 = getelementptr inbounds i8, ptr %628, i64 24
  %710 = load i64, ptr %709, align 8
  %711 = icmp sgt i64 %710, 3
  br i1 %711, label %740, label %765

712:                                              ; preds = %651, %712
  %713 = phi i64 [ 0, %651 ], [ %735, %712 ]
  %714 = load ptr, ptr %87, align 8
  %715 = shl nsw i64 %713, 6
  %716 = getelementptr inbounds i8, ptr %714, i64 %715
  %717 = load <8 x double>, ptr %716, align 8
  %718 = load ptr, ptr %12, align 8
  %719 = getelementptr inbounds i8, ptr %718, i64 %715
  %720 = load <8 x double>, ptr %719, align 8
  %721 = fsub <8 x double> %717, %720
  %722 = load ptr, ptr %89, align 8
  %723 = getelementptr inbounds i8, ptr %722, i64 %715
  %724 = load <8 x double>, ptr %723, align 8
  %725 = fmul <8 x double> %251, %724
  %726 = fsub <8 x double> %725, %721
  %727 = getelementptr inbounds i8, ptr %637, i64 %715
  store <8 x double> %721, ptr %727, align 8
  %728 = getelementptr inbounds i8, ptr %652, i64 %715
  store <8 x double> %726, ptr %728, align 8
  %729 = fsub <8 x double> %721, %726
  %730 = getelementptr inbounds i8, ptr %636, i64 %715
  %731 = load <8 x double>, ptr %730, align 8
  %732 = fmul <8 x double> %251, %731
  %733 = fsub <8 x double> %729, %732
  %734 = getelementptr inbounds i8, ptr %654, i64 %715
  store <8 x double> %733, ptr %734, align 8
  %735 = add nuw nsw i64 %713, 1
  %736 = load ptr, ptr %10, align 8
  %737 = getelementptr inbounds i8, ptr %736, i64 8
  %738 = load i64, ptr %737, align 8
  %739 = icmp slt i64 %735, %738
  br i1 %739, label %712, label %705, !llvm.loop !15

740:                                              ; preds = %705, %740
  %741 = phi i64 [ %762, %740 ], [ 3, %705 ]
  %742 = mul nsw i64 %741, %633
  %743 = getelementptr inbounds double, ptr %637, i64 %742
  %744 = load ptr, ptr %125, align 8
  %745 = load ptr, ptr %88, align 8
  %746 = getelementptr i64, ptr %745, i64 %638
  %747 = getelementptr i64, ptr %746, i64 %707
  %748 = getelementptr i64, ptr %747, i64 %708
  %749 = getelementptr i64, ptr %748, i64 %741
  %750 = getelementptr i8, ptr %749, i64 -24
  %751 = load i64, ptr %750, align 8
  %752 = getelementptr i8, ptr %749, i64 -16
  %753 = load i64, ptr %752, align 8
  %754 = xor i64 %751, -1
  %755 = add i64 %753, %754
  %756 = load ptr, ptr %75, align 8
  %757 = load ptr, ptr %89, align 8
  %758 = load ptr, ptr %90, align 8
  %759 = getelementptr inbounds i64, ptr %758, i64 %751
  %760 = load ptr, ptr %91, align 8
  %761 = getelementptr inbounds double, ptr %760, i64 %751
  call fastcc void @combine(ptr noundef %743, ptr noundef %744, ptr noundef %756, ptr noundef %757, ptr noundef %759, ptr noundef %761, i64 noundef %755, i64 noundef %631) #10
  %762 = add nuw nsw i64 %741, 1
  %763 = load i64, ptr %709, align 8
  %764 = icmp slt i64 %762, %763
  br i1 %764, label %740, label %765, !llvm.loop !16

765:                                              ; preds = %740, %705
  %766 = and i64 %645, %625
  %767 = load ptr, ptr %110, align 8
  %768 = load <8 x double>, ptr %767, align 8
  %769 = trunc nuw i64 %625 to i8
  %770 = bitcast i8 %769 to <8 x i1>
  %771 = load i64, ptr %126, align 8
  %772 = sitofp i64 %771 to double
  %773 = insertelement <8 x double> poison, double %772, i64 0
  %774 = shufflevector <8 x double> %773, <8 x double> poison, <8 x i32> zeroinitializer
  %775 = select <8 x i1> %770, <8 x double> %774, <8 x double> zeroinitializer
  %776 = fadd <8 x double> %768, %775
  store <8 x double> %776, ptr %767, align 8
  %777 = icmp eq i64 %766, 0
  br i1 %777, label %782, label %778

778:                                              ; preds = %765
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %766, i64 noundef 3) #10
  %779 = xor i64 %766, -1
  %780 = and i64 %219, %779
  store i64 %780, ptr %6, align 8
  %781 = and i64 %617, %779
  br label %782

782:                                              ; preds = %778, %765
  %783 = phi i64 [ %781, %778 ], [ %617, %765 ]
  %784 = phi i32 [ 1, %778 ], [ %190, %765 ]
  store <8 x double> %249, ptr %3, align 16
  %785 = icmp eq i64 %783, 0
  br i1 %785, label %788, label %786

786:                                              ; preds = %782
  %787 = call fastcc i64 @look_for_events(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %783, ptr noundef nonnull %3, ptr noundef nonnull %5, ptr noundef nonnull %7, ptr noundef nonnull %4, ptr noundef nonnull %8) #10
  br label %788

788:                                              ; preds = %786, %782
  %789 = phi i64 [ %787, %786 ], [ 0, %782 ]
  %790 = load i64, ptr %8, align 8
  %791 = or i64 %790, %645
  %792 = xor i64 %791, -1
  %793 = and i64 %625, %792
  %794 = icmp eq i64 %789, 0
  %795 = select i1 %794, ptr null, ptr %4
  %796 = call fastcc i64 @write_within(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %793, ptr noundef nonnull %3, ptr noundef %795) #10
  %797 = load <8 x double>, ptr %3, align 16
  br i1 %794, label %803, label %798

798:                                              ; preds = %788
  %799 = xor i64 %796, -1
  %800 = and i64 %789, %799
  %801 = call fastcc i64 @end_within(ptr noundef nonnull %0, ptr noundef nonnull %2, i64 noundef %800, ptr noundef nonnull %3, ptr noundef nonnull %4) #10
  %802 = or i64 %801, %796
  br label %803

803:                                              ; preds = %798, %788
  %804 = phi i64 [ %802, %798 ], [ %796, %788 ]
  %805 = icmp ne i64 %804, 0
  %806 = select i1 %60, i1 %805, i1 false
  br i1 %806, label %807, label %812

807:                                              ; preds = %803
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %804, i64 noundef 6) #10
  %808 = xor i64 %804, -1
  %809 = load i64, ptr %6, align 8
  %810 = and i64 %809, %808
  store i64 %810, ptr %6, align 8
  %811 = and i64 %789, %808
  br label %812

812:                                              ; preds = %807, %803
  %813 = phi i32 [ 1, %807 ], [ %784, %803 ]
  %814 = phi i64 [ %811, %807 ], [ %789, %803 ]
  %815 = or i64 %804, %566
  %816 = or i64 %790, %766
  %817 = or i64 %816, %815
  %818 = trunc i64 %817 to i8
  %819 = xor i8 %818, -1
  %820 = bitcast i8 %819 to <8 x i1>
  %821 = select <8 x i1> %820, <8 x i64> %593, <8 x i64> zeroinitializer
  br label %822

822:                                              ; preds = %812, %616
  %823 = phi <8 x double> [ %249, %616 ], [ %797, %812 ]
  %824 = phi i64 [ %566, %616 ], [ %815, %812 ]
  %825 = phi <8 x i64> [ %593, %616 ], [ %821, %812 ]
  %826 = phi i32 [ %190, %616 ], [ %813, %812 ]
  %827 = phi i64 [ 0, %616 ], [ %814, %812 ]
  %828 = load ptr, ptr %116, align 8
  %829 = load <8 x double>, ptr %828, align 8
  %830 = fcmp oeq <8 x double> %829, %823
  %831 = icmp ne <8 x i64> %825, zeroinitializer
  %832 = select <8 x i1> %830, <8 x i1> %831, <8 x i1> zeroinitializer
  %833 = bitcast <8 x i1> %832 to i8
  %834 = icmp eq i8 %833, 0
  br i1 %834, label %837, label %835

835:                                              ; preds = %822
  %836 = zext i8 %833 to i64
  br label %846

837:                                              ; preds = %846, %822
  %838 = xor <8 x i64> %825, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %839 = select <8 x i1> %221, <8 x i64> %838, <8 x i64> zeroinitializer
  %840 = load ptr, ptr %71, align 8
  %841 = load <8 x double>, ptr %840, align 8
  %842 = icmp slt <8 x i64> %825, zeroinitializer
  %843 = select <8 x i1> %842, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %844 = bitcast <8 x i64> %843 to <8 x double>
  %845 = fadd <8 x double> %841, %844
  store <8 x double> %845, ptr %840, align 8
  br i1 %35, label %856, label %986

846:                                              ; preds = %835, %846
  %847 = phi i64 [ %854, %846 ], [ %836, %835 ]
  %848 = load ptr, ptr %127, align 8
  call fastcc void @write_outputs(ptr noundef %0, ptr noundef %848, i64 noundef %847) #10
  %849 = load ptr, ptr %116, align 8
  %850 = load <8 x double>, ptr %849, align 8
  %851 = fcmp oeq <8 x double> %850, %823
  %852 = bitcast <8 x i1> %851 to i8
  %853 = zext i8 %852 to i64
  %854 = and i64 %847, %853
  %855 = icmp eq i64 %854, 0
  br i1 %855, label %837, label %846, !llvm.loop !17

856:                                              ; preds = %837
  %857 = load ptr, ptr %128, align 8
  %858 = load <8 x double>, ptr %857, align 8
  %859 = load ptr, ptr %129, align 8
  %860 = load <8 x double>, ptr %859, align 8
  %861 = fcmp ogt <8 x double> %545, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %862 = bitcast <8 x double> %545 to <8 x i64>
  %863 = select <8 x i1> %861, <8 x i64> %862, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %864 = load double, ptr %130, align 8
  %865 = insertelement <8 x double> poison, double %864, i64 0
  %866 = shufflevector <8 x double> %865, <8 x double> poison, <8 x i32> zeroinitializer
  %867 = load double, ptr %131, align 8
  %868 = fneg double %867
  %869 = add <8 x i64> %863, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %870 = ashr <8 x i64> %869, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %871 = and <8 x i64> %869, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %872 = sub <8 x i64> %863, %871
  %873 = bitcast <8 x i64> %872 to <8 x double>
  %874 = fadd <8 x double> %873, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %875 = fadd <8 x double> %873, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %876 = fdiv <8 x double> %874, %875
  %877 = fmul <8 x double> %876, %876
  %878 = call <8 x double> @llvm.fma.v8f64(<8 x double> %877, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %879 = call <8 x double> @llvm.fma.v8f64(<8 x double> %878, <8 x double> %877, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %880 = call <8 x double> @llvm.fma.v8f64(<8 x double> %879, <8 x double> %877, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %881 = call <8 x double> @llvm.fma.v8f64(<8 x double> %880, <8 x double> %877, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %882 = trunc nsw <8 x i64> %870 to <8 x i32>
  %883 = sitofp <8 x i32> %882 to <8 x double>
  %884 = fmul <8 x double> %876, %881
  %885 = fadd <8 x double> %884, %883
  %886 = insertelement <8 x double> poison, double %868, i64 0
  %887 = shufflevector <8 x double> %886, <8 x double> poison, <8 x i32> zeroinitializer
  %888 = fmul <8 x double> %885, %887
  %889 = fcmp ogt <8 x double> %888, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %890 = bitcast <8 x double> %888 to <8 x i64>
  %891 = select <8 x i1> %889, <8 x i64> %890, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %892 = bitcast <8 x i64> %891 to <8 x double>
  %893 = fcmp olt <8 x double> %892, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %894 = bitcast <8 x i64> %891 to <8 x double>
  %895 = select <8 x i1> %893, <8 x double> %894, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %896 = call <8 x double> @llvm.rint.v8f64(<8 x double> %895)
  %897 = fsub <8 x double> %895, %896
  %898 = call <8 x double> @llvm.fma.v8f64(<8 x double> %897, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %899 = call <8 x double> @llvm.fma.v8f64(<8 x double> %898, <8 x double> %897, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %900 = call <8 x double> @llvm.fma.v8f64(<8 x double> %899, <8 x double> %897, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %901 = call <8 x double> @llvm.fma.v8f64(<8 x double> %900, <8 x double> %897, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %902 = call <8 x double> @llvm.fma.v8f64(<8 x double> %901, <8 x double> %897, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %903 = call <8 x double> @llvm.fma.v8f64(<8 x double> %902, <8 x double> %897, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %904 = call <8 x double> @llvm.fma.v8f64(<8 x double> %903, <8 x double> %897, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %905 = bitcast <8 x double> %904 to <8 x i64>
  %906 = fptosi <8 x double> %896 to <8 x i32>
  %907 = zext <8 x i32> %906 to <8 x i64>
  %908 = shl <8 x i64> %907, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %909 = add <8 x i64> %908, %905
  %910 = bitcast <8 x i64> %909 to <8 x double>
  %911 = fmul <8 x double> %866, %910
  %912 = load double, ptr %132, align 8
  %913 = fcmp une double %912, 0.000000e+00
  br i1 %913, label %914, label %959

914:                                              ; preds = %856
  %915 = bitcast <8 x double> %858 to <8 x i64>
  %916 = add <8 x i64> %915, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %917 = ashr <8 x i64> %916, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %918 = and <8 x i64> %916, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %919 = sub <8 x i64> %915, %918
  %920 = bitcast <8 x i64> %919 to <8 x double>
  %921 = fadd <8 x double> %920, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %922 = fadd <8 x double> %920, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %923 = fdiv <8 x double> %921, %922
  %924 = fmul <8 x double> %923, %923
  %925 = call <8 x double> @llvm.fma.v8f64(<8 x double> %924, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %926 = call <8 x double> @llvm.fma.v8f64(<8 x double> %925, <8 x double> %924, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %927 = call <8 x double> @llvm.fma.v8f64(<8 x double> %926, <8 x double> %924, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %928 = call <8 x double> @llvm.fma.v8f64(<8 x double> %927, <8 x double> %924, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %929 = trunc nsw <8 x i64> %917 to <8 x i32>
  %930 = sitofp <8 x i32> %929 to <8 x double>
  %931 = fmul <8 x double> %923, %928
  %932 = fadd <8 x double> %931, %930
  %933 = insertelement <8 x double> poison, double %912, i64 0
  %934 = shufflevector <8 x double> %933, <8 x double> poison, <8 x i32> zeroinitializer
  %935 = fmul <8 x double> %934, %932
  %936 = fcmp ogt <8 x double> %935, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %937 = bitcast <8 x double> %935 to <8 x i64>
  %938 = select <8 x i1> %936, <8 x i64> %937, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %939 = bitcast <8 x i64> %938 to <8 x double>
  %940 = fcmp olt <8 x double> %939, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %941 = bitcast <8 x i64> %938 to <8 x double>
  %942 = select <8 x i1> %940, <8 x double> %941, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %943 = call <8 x double> @llvm.rint.v8f64(<8 x double> %942)
  %944 = fsub <8 x double> %942, %943
  %945 = call <8 x double> @llvm.fma.v8f64(<8 x double> %944, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %946 = call <8 x double> @llvm.fma.v8f64(<8 x double> %945, <8 x double> %944, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %947 = call <8 x double> @llvm.fma.v8f64(<8 x double> %946, <8 x double> %944, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %948 = call <8 x double> @llvm.fma.v8f64(<8 x double> %947, <8 x double> %944, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %949 = call <8 x double> @llvm.fma.v8f64(<8 x double> %948, <8 x double> %944, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %950 = call <8 x double> @llvm.fma.v8f64(<8 x double> %949, <8 x double> %944, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %951 = call <8 x double> @llvm.fma.v8f64(<8 x double> %950, <8 x double> %944, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %952 = bitcast <8 x double> %951 to <8 x i64>
  %953 = fptosi <8 x double> %943 to <8 x i32>
  %954 = zext <8 x i32> %953 to <8 x i64>
  %955 = shl <8 x i64> %954, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %956 = add <8 x i64> %955, %952
  %957 = bitcast <8 x i64> %956 to <8 x double>
  %958 = fmul <8 x double> %911, %957
  br label %959

959:                                              ; preds = %856, %914
  %960 = phi <8 x double> [ %958, %914 ], [ %911, %856 ]
  %961 = load double, ptr %133, align 8
  %962 = insertelement <8 x double> poison, double %961, i64 0
  %963 = shufflevector <8 x double> %962, <8 x double> poison, <8 x i32> zeroinitializer
  %964 = fcmp ogt <8 x double> %960, %963
  %965 = select <8 x i1> %964, <8 x double> %960, <8 x double> %963
  %966 = fcmp olt <8 x double> %860, %965
  %967 = select <8 x i1> %966, <8 x double> %860, <8 x double> %965
  %968 = fmul <8 x double> %251, %967
  %969 = fcmp oeq <8 x double> %823, %231
  %970 = load ptr, ptr %68, align 8
  %971 = load <8 x double>, ptr %970, align 8
  %972 = fcmp ogt <8 x double> %971, %968
  %973 = select <8 x i1> %969, <8 x i1> %972, <8 x i1> zeroinitializer
  %974 = select <8 x i1> %973, <8 x double> %971, <8 x double> %968
  %975 = fcmp ogt <8 x double> %545, <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>
  %976 = select <8 x i1> %975, <8 x i64> %862, <8 x i64> <i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789>
  %977 = bitcast <8 x double> %858 to <8 x i64>
  %978 = select <8 x i1> %842, <8 x i64> %976, <8 x i64> %977
  store <8 x i64> %978, ptr %857, align 8
  %979 = load ptr, ptr %129, align 8
  %980 = load double, ptr %134, align 8
  %981 = insertelement <8 x double> poison, double %980, i64 0
  %982 = bitcast <8 x double> %981 to <8 x i64>
  %983 = shufflevector <8 x i64> %982, <8 x i64> poison, <8 x i32> zeroinitializer
  %984 = icmp slt <8 x i64> %839, zeroinitializer
  %985 = select <8 x i1> %984, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> %983
  store <8 x i64> %985, ptr %979, align 8
  br label %986

986:                                              ; preds = %959, %837
  %987 = phi <8 x double> [ %974, %959 ], [ %233, %837 ]
  %988 = icmp ne <8 x i64> %839, zeroinitializer
  %989 = bitcast <8 x i1> %988 to i8
  %990 = icmp eq i8 %989, 0
  br i1 %990, label %1084, label %991

991:                                              ; preds = %986
  %992 = trunc i64 %594 to i8
  %993 = bitcast i8 %992 to <8 x i1>
  %994 = trunc i64 %824 to i8
  %995 = bitcast i8 %994 to <8 x i1>
  %996 = load i64, ptr %8, align 8
  %997 = trunc i64 %996 to i8
  %998 = bitcast i8 %997 to <8 x i1>
  %999 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %545)
  %1000 = fcmp one <8 x double> %999, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1001 = xor <8 x i1> %993, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1002 = select <8 x i1> %1000, <8 x i1> %1001, <8 x i1> zeroinitializer
  %1003 = or <8 x i1> %998, %995
  %1004 = xor <8 x i1> %1003, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1005 = and <8 x i1> %1002, %1004
  br i1 %35, label %1006, label %1065

1006:                                             ; preds = %991
  %1007 = fcmp ogt <8 x double> %545, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1008 = bitcast <8 x double> %545 to <8 x i64>
  %1009 = select <8 x i1> %1007, <8 x i64> %1008, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %1010 = load double, ptr %135, align 8
  %1011 = insertelement <8 x double> poison, double %1010, i64 0
  %1012 = shufflevector <8 x double> %1011, <8 x double> poison, <8 x i32> zeroinitializer
  %1013 = load double, ptr %32, align 8
  %1014 = fneg double %1013
  %1015 = add <8 x i64> %1009, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %1016 = ashr <8 x i64> %1015, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1017 = and <8 x i64> %1015, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %1018 = sub <8 x i64> %1009, %1017
  %1019 = bitcast <8 x i64> %1018 to <8 x double>
  %1020 = fadd <8 x double> %1019, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %1021 = fadd <8 x double> %1019, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1022 = fdiv <8 x double> %1020, %1021
  %1023 = fmul <8 x double> %1022, %1022
  %1024 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1023, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %1025 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1024, <8 x double> %1023, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %1026 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1025, <8 x double> %1023, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %1027 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1026, <8 x double> %1023, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %1028 = trunc nsw <8 x i64> %1016 to <8 x i32>
  %1029 = sitofp <8 x i32> %1028 to <8 x double>
  %1030 = fmul <8 x double> %1022, %1027
  %1031 = fadd <8 x double> %1030, %1029
  %1032 = insertelement <8 x double> poison, double %1014, i64 0
  %1033 = shufflevector <8 x double> %1032, <8 x double> poison, <8 x i32> zeroinitializer
  %1034 = fmul <8 x double> %1031, %1033
  %1035 = fcmp ogt <8 x double> %1034, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1036 = bitcast <8 x double> %1034 to <8 x i64>
  %1037 = select <8 x i1> %1035, <8 x i64> %1036, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1038 = bitcast <8 x i64> %1037 to <8 x double>
  %1039 = fcmp olt <8 x double> %1038, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1040 = bitcast <8 x i64> %1037 to <8 x double>
  %1041 = select <8 x i1> %1039, <8 x double> %1040, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1042 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1041)
  %1043 = fsub <8 x double> %1041, %1042
  %1044 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1043, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1045 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1044, <8 x double> %1043, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1046 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1045, <8 x double> %1043, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1047 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1046, <8 x double> %1043, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1048 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1047, <8 x double> %1043, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1049 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1048, <8 x double> %1043, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1050 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1049, <8 x double> %1043, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1051 = bitcast <8 x double> %1050 to <8 x i64>
  %1052 = fptosi <8 x double> %1042 to <8 x i32>
  %1053 = zext <8 x i32> %1052 to <8 x i64>
  %1054 = shl <8 x i64> %1053, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1055 = add <8 x i64> %1054, %1051
  %1056 = bitcast <8 x i64> %1055 to <8 x double>
  %1057 = fmul <8 x double> %1012, %1056
  %1058 = load double, ptr %136, align 8
  %1059 = insertelement <8 x double> poison, double %1058, i64 0
  %1060 = shufflevector <8 x double> %1059, <8 x double> poison, <8 x i32> zeroinitializer
  %1061 = fcmp ogt <8 x double> %1057, %1060
  %1062 = select <8 x i1> %1061, <8 x double> %1057, <8 x double> %1060
  %1063 = select <8 x i1> %1005, <8 x double> %1062, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1064 = fmul <8 x double> %251, %1063
  br label %1065

1065:                                             ; preds = %991, %1006
  %1066 = phi <8 x double> [ %1064, %1006 ], [ zeroinitializer, %991 ]
  %1067 = or <8 x i1> %1005, %998
  %1068 = select <8 x i1> %1067, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %1069 = icmp slt <8 x i64> %839, zeroinitializer
  %1070 = select <8 x i1> %1069, <8 x double> %1066, <8 x double> %987
  %1071 = load ptr, ptr %137, align 8
  %1072 = select <8 x i1> %995, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> %1068
  %1073 = load <8 x i64>, ptr %1071, align 8
  %1074 = select <8 x i1> %1069, <8 x i64> %1072, <8 x i64> %1073
  store <8 x i64> %1074, ptr %1071, align 8
  %1075 = load ptr, ptr %137, align 8
  %1076 = select <8 x i1> %993, <8 x i64> <i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152>, <8 x i64> %1068
  %1077 = load <8 x i64>, ptr %1075, align 8
  %1078 = select <8 x i1> %1069, <8 x i64> %1076, <8 x i64> %1077
  store <8 x i64> %1078, ptr %1075, align 8
  %1079 = load ptr, ptr %72, align 8
  %1080 = load <8 x double>, ptr %1079, align 8
  %1081 = select <8 x i1> %1069, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> zeroinitializer
  %1082 = bitcast <8 x i64> %1081 to <8 x double>
  %1083 = fadd <8 x double> %1080, %1082
  store <8 x double> %1083, ptr %1079, align 8
  br label %1084

1084:                                             ; preds = %1065, %986
  %1085 = phi <8 x double> [ %987, %986 ], [ %1070, %1065 ]
  %1086 = load ptr, ptr %68, align 8
  store <8 x double> %1085, ptr %1086, align 8
  %1087 = load ptr, ptr %55, align 8
  %1088 = select <8 x i1> %842, <8 x double> %823, <8 x double> %223
  store <8 x double> %1088, ptr %1087, align 8
  br i1 %138, label %1091, label %1089

1089:                                             ; preds = %1091, %1084
  %1090 = icmp eq i64 %827, 0
  br i1 %1090, label %1118, label %1109

1091:                                             ; preds = %1084, %1091
  %1092 = phi i64 [ %1107, %1091 ], [ 0, %1084 ]
  %1093 = load ptr, ptr %12, align 8
  %1094 = load ptr, ptr %139, align 8
  %1095 = shl nsw i64 %1092, 6
  %1096 = getelementptr inbounds i8, ptr %1094, i64 %1095
  %1097 = load <8 x i64>, ptr %1096, align 8
  %1098 = getelementptr inbounds i8, ptr %1093, i64 %1095
  %1099 = load <8 x i64>, ptr %1098, align 8
  %1100 = select <8 x i1> %842, <8 x i64> %1097, <8 x i64> %1099
  store <8 x i64> %1100, ptr %1098, align 8
  %1101 = load ptr, ptr %46, align 8
  %1102 = getelementptr inbounds i8, ptr %61, i64 %1095
  %1103 = load <8 x i64>, ptr %1102, align 8
  %1104 = getelementptr inbounds i8, ptr %1101, i64 %1095
  %1105 = load <8 x i64>, ptr %1104, align 8
  %1106 = select <8 x i1> %842, <8 x i64> %1103, <8 x i64> %1105
  store <8 x i64> %1106, ptr %1104, align 8
  %1107 = add nuw nsw i64 %1092, 1
  %1108 = icmp eq i64 %1107, %16
  br i1 %1108, label %1089, label %1091, !llvm.loop !18

1109:                                             ; preds = %1089
  %1110 = call fastcc i64 @act_in_lanes(ptr noundef %0, i64 noundef %827, ptr noundef nonnull %7) #10
  %1111 = icmp ne i32 %826, 0
  %1112 = icmp ne i64 %1110, %827
  %1113 = select i1 %1111, i1 true, i1 %1112
  %1114 = zext i1 %1113 to i32
  %1115 = trunc i64 %827 to i8
  %1116 = bitcast i8 %1115 to <8 x i1>
  %1117 = select <8 x i1> %1116, <8 x i64> zeroinitializer, <8 x i64> %825
  br label %1118

1118:                                             ; preds = %1109, %1089
  %1119 = phi <8 x i64> [ %1117, %1109 ], [ %825, %1089 ]
  %1120 = phi i32 [ %1114, %1109 ], [ %826, %1089 ]
  %1121 = phi i64 [ %1110, %1109 ], [ %191, %1089 ]
  %1122 = load ptr, ptr %116, align 8
  %1123 = load <8 x double>, ptr %1122, align 8
  %1124 = fcmp oeq <8 x double> %1123, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1125 = icmp ne <8 x i64> %1119, zeroinitializer
  %1126 = select <8 x i1> %1124, <8 x i1> %1125, <8 x i1> zeroinitializer
  %1127 = bitcast <8 x i1> %1126 to i8
  %1128 = zext i8 %1127 to i64
  %1129 = icmp eq i8 %1127, 0
  br i1 %1129, label %1131, label %1130

1130:                                             ; preds = %1118
  call fastcc void @retire(ptr noundef %0, i64 noundef %1128, i64 noundef 0) #10
  br label %1131

1131:                                             ; preds = %1130, %1118
  %1132 = phi i32 [ 1, %1130 ], [ %1120, %1118 ]
  %1133 = fcmp oeq <8 x double> %823, %229
  %1134 = icmp ne <8 x i64> %1119, zeroinitializer
  %1135 = select <8 x i1> %1133, <8 x i1> %1134, <8 x i1> zeroinitializer
  %1136 = bitcast <8 x i1> %1135 to i8
  %1137 = zext i8 %1136 to i64
  %1138 = xor i64 %1128, -1
  %1139 = and i64 %1138, %1137
  %1140 = icmp eq i64 %1139, 0
  br i1 %1140, label %1145, label %1141

1141:                                             ; preds = %1131
  %1142 = call fastcc i64 @start_again(ptr noundef %0, ptr noundef nonnull %2, i64 noundef %1139) #10
  %1143 = icmp eq i64 %1142, 0
  %1144 = select i1 %1143, i32 %1132, i32 1
  br label %1145

1145:                                             ; preds = %1141, %1131
  %1146 = phi i32 [ %1132, %1131 ], [ %1144, %1141 ]
  br label %186

1147:                                             ; preds = %189, %214, %182
  %1148 = phi i64 [ 1, %182 ], [ 0, %214 ], [ 0, %189 ]
  ret i64 %1148
}



define internal fastcc i64 @fill(ptr noundef readonly %0, ptr noundef writeonly %1) unnamed_addr #2 {
  %3 = getelementptr inbounds i8, ptr %0, i64 696
  %4 = getelementptr inbounds i8, ptr %0, i64 984
  %5 = getelementptr inbounds i8, ptr %0, i64 432
  %6 = load ptr, ptr %4, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 1128
  %8 = getelementptr inbounds i8, ptr %0, i64 1064
  %9 = getelementptr inbounds i8, ptr %0, i64 1056
  %10 = getelementptr inbounds i8, ptr %0, i64 936
  %11 = getelementptr inbounds i8, ptr %0, i64 1144
  %12 = getelementptr inbounds i8, ptr %0, i64 1072
  %13 = getelementptr inbounds i8, ptr %0, i64 1080
  %14 = getelementptr inbounds i8, ptr %0, i64 192
  %15 = getelementptr inbounds i8, ptr %0, i64 1096
  %16 = getelementptr inbounds i8, ptr %0, i64 1104
  %17 = getelementptr inbounds i8, ptr %0, i64 216
  %18 = getelementptr inbounds i8, ptr %0, i64 1120
  %19 = getelementptr inbounds i8, ptr %0, i64 1176
  %20 = getelementptr inbounds i8, ptr %0, i64 1704
  %21 = getelementptr inbounds i8, ptr %0, i64 1712
  %22 = getelementptr inbounds i8, ptr %0, i64 1192
  %23 = getelementptr inbounds i8, ptr %0, i64 1192
  %24 = getelementptr inbounds i8, ptr %0, i64 1208
  %25 = getelementptr inbounds i8, ptr %0, i64 1248
  %26 = getelementptr inbounds i8, ptr %0, i64 1200
  %27 = getelementptr inbounds i8, ptr %0, i64 1096
  %28 = getelementptr inbounds i8, ptr %0, i64 1232
  %29 = getelementptr inbounds i8, ptr %0, i64 1224
  %30 = getelementptr inbounds i8, ptr %0, i64 1240
  %31 = getelementptr inbounds i8, ptr %0, i64 1120
  %32 = getelementptr inbounds i8, ptr %0, i64 1464
  %33 = getelementptr inbounds i8, ptr %0, i64 1480
  %34 = getelementptr inbounds i8, ptr %0, i64 1416
  %35 = getelementptr inbounds i8, ptr %0, i64 1488
  %36 = getelementptr inbounds i8, ptr %0, i64 1504
  %37 = getelementptr inbounds i8, ptr %0, i64 1440
  %38 = getelementptr inbounds i8, ptr %0, i64 1032
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
  %59 = getelementptr inbounds i8, ptr %0, i64 936
  %60 = getelementptr inbounds i8, ptr %0, i64 600
  %61 = getelementptr inbounds i8, ptr %0, i64 192
  %62 = getelementptr inbounds i8, ptr %0, i64 216
  %63 = getelementptr inbounds i8, ptr %0, i64 720
  %64 = getelementptr inbounds i8, ptr %0, i64 816
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
  %196 = getelementptr inbounds i8, ptr %169, i64 1248
  %197 = getelementptr inbounds i8, ptr %169, i64 1008
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
  %264 = getelementptr inbounds i8, ptr %169, i64 648
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
  call fastcc void @hold_all(ptr noundef %0, ptr noundef nonnull %8) #10
  %20 = getelementptr inbounds i8, ptr %1, i64 8
  %21 = load ptr, ptr %20, align 8
  %22 = load ptr, ptr %12, align 8
  %23 = getelementptr inbounds i8, ptr %12, i64 48
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr inbounds i8, ptr %21, i64 24
  %26 = load ptr, ptr %25, align 8
  store <8 x double> %19, ptr %26, align 8
  %27 = getelementptr inbounds i8, ptr %21, i64 152
  %28 = load i64, ptr %27, align 8
  %29 = icmp sgt i64 %28, 0
  br i1 %29, label %30, label %31

30:                                               ; preds = %4
  tail call fastcc void @sample(ptr noundef %21) #10
  br label %31

31:                                               ; preds = %4, %30
  %32 = load ptr, ptr %21, align 8
  %33 = load i64, ptr %32, align 8
  %34 = load ptr, ptr %25, align 8
  %35 = getelementptr inbounds i8, ptr %21, i64 48
  %36 = load ptr, ptr %35, align 8
  %37 = getelementptr inbounds i8, ptr %21, i64 96
  %38 = load ptr, ptr %37, align 8
  %39 = inttoptr i64 %33 to ptr
  %40 = load ptr, ptr %39, align 8
  %41 = tail call i32 %40(ptr noundef %34, ptr noundef %22, ptr noundef %36, ptr noundef %38, ptr noundef %24) #11
  %42 = sext i32 %41 to i64
  %43 = load ptr, ptr %20, align 8
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr inbounds i8, ptr %44, i64 8
  %46 = load i64, ptr %45, align 8
  %47 = icmp sgt i64 %46, 0
  br i1 %47, label %48, label %50

48:                                               ; preds = %31
  %49 = getelementptr inbounds i8, ptr %12, i64 168
  br label %58

50:                                               ; preds = %58, %31
  %51 = phi ptr [ %44, %31 ], [ %70, %58 ]
  %52 = getelementptr inbounds i8, ptr %0, i64 1008
  %53 = load ptr, ptr %52, align 8
  %54 = getelementptr inbounds i8, ptr %53, i64 8
  %55 = load double, ptr %54, align 8
  %56 = load double, ptr %53, align 8
  %57 = fcmp oeq double %55, 0.000000e+00
  br i1 %57, label %81, label %74

58:                                               ; preds = %48, %58
  %59 = phi i64 [ 0, %48 ], [ %68, %58 ]
  %60 = load ptr, ptr %49, align 8
  %61 = load ptr, ptr %23, align 8
  %62 = shl nsw i64 %59, 6
  %63 = getelementptr inbounds i8, ptr %61, i64 %62
  %64 = load <8 x i64>, ptr %63, align 8
  %65 = getelementptr inbounds i8, ptr %60, i64 %62
  %66 = load <8 x i64>, ptr %65, align 8
  %67 = select <8 x i1> %17, <8 x i64> %64, <8 x i64> %66
  store <8 x i64> %67, ptr %65, align 8
  %68 = add nuw nsw i64 %59, 1
  %69 = load ptr, ptr %20, align 8
  %70 = load ptr, ptr %69, align 8
  %71 = getelementptr inbounds i8, ptr %70, i64 8
  %72 = load i64, ptr %71, align 8
  %73 = icmp slt i64 %68, %72
  br i1 %73, label %58, label %50, !llvm.loop !30

74:                                               ; preds = %50
  %75 = load ptr, ptr %1, align 8
  %76 = load ptr, ptr %75, align 8
  %77 = getelementptr inbounds i8, ptr %76, i64 8
  %78 = load i64, ptr %77, align 8
  %79 = icmp sgt i64 %78, 0
  %80 = select i1 %79, i64 %3, i64 0
  br label %81

81:                                               ; preds = %50, %74
  %82 = phi i64 [ %80, %74 ], [ %15, %50 ]
  %83 = insertelement <8 x double> poison, double %55, i64 0
  %84 = shufflevector <8 x double> %83, <8 x double> poison, <8 x i32> zeroinitializer
  %85 = icmp eq i64 %82, 0
  br i1 %85, label %256, label %86

86:                                               ; preds = %81
  %87 = trunc i64 %82 to i8
  %88 = bitcast i8 %87 to <8 x i1>
  %89 = load ptr, ptr %11, align 8
  %90 = getelementptr inbounds i8, ptr %51, i64 24
  %91 = load i64, ptr %90, align 8
  %92 = load ptr, ptr %89, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %92, ptr noundef %92, ptr noundef nonnull %89, i64 noundef %91) #10
  %93 = load <8 x double>, ptr %5, align 16
  %94 = getelementptr inbounds i8, ptr %89, i64 168
  %95 = load ptr, ptr %94, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %95, ptr noundef %92, ptr noundef nonnull %89, i64 noundef %91) #10
  %96 = load <8 x double>, ptr %6, align 16
  %97 = fcmp olt <8 x double> %93, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %98 = fcmp olt <8 x double> %96, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %99 = or <8 x i1> %98, %97
  %100 = insertelement <8 x double> poison, double %56, i64 0
  %101 = shufflevector <8 x double> %100, <8 x double> poison, <8 x i32> zeroinitializer
  %102 = fmul <8 x double> %93, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %103 = fdiv <8 x double> %102, %96
  %104 = bitcast <8 x double> %103 to <8 x i64>
  %105 = select <8 x i1> %99, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %104
  %106 = bitcast <8 x i64> %105 to <8 x double>
  %107 = fcmp olt <8 x double> %101, %106
  %108 = bitcast <8 x double> %101 to <8 x i64>
  %109 = select <8 x i1> %107, <8 x i64> %108, <8 x i64> %105
  %110 = bitcast <8 x i64> %109 to <8 x double>
  %111 = load ptr, ptr %20, align 8
  %112 = load ptr, ptr %111, align 8
  %113 = getelementptr inbounds i8, ptr %112, i64 8
  %114 = load i64, ptr %113, align 8
  %115 = icmp sgt i64 %114, 0
  br i1 %115, label %116, label %137

116:                                              ; preds = %86
  %117 = getelementptr inbounds i8, ptr %89, i64 48
  br label %118

118:                                              ; preds = %116, %118
  %119 = phi i64 [ 0, %116 ], [ %131, %118 ]
  %120 = load ptr, ptr %117, align 8
  %121 = load ptr, ptr %89, align 8
  %122 = shl nsw i64 %119, 6
  %123 = getelementptr inbounds i8, ptr %121, i64 %122
  %124 = load <8 x double>, ptr %123, align 8
  %125 = load ptr, ptr %94, align 8
  %126 = getelementptr inbounds i8, ptr %125, i64 %122
  %127 = load <8 x double>, ptr %126, align 8
  %128 = fmul <8 x double> %127, %110
  %129 = fadd <8 x double> %124, %128
  %130 = getelementptr inbounds i8, ptr %120, i64 %122
  store <8 x double> %129, ptr %130, align 8
  %131 = add nuw nsw i64 %119, 1
  %132 = load ptr, ptr %20, align 8
  %133 = load ptr, ptr %132, align 8
  %134 = getelementptr inbounds i8, ptr %133, i64 8
  %135 = load i64, ptr %134, align 8
  %136 = icmp slt i64 %131, %135
  br i1 %136, label %118, label %137, !llvm.loop !31

137:                                              ; preds = %118, %86
  %138 = phi ptr [ %111, %86 ], [ %132, %118 ]
  %139 = fadd <8 x double> %19, %110
  %140 = getelementptr inbounds i8, ptr %89, i64 48
  %141 = load ptr, ptr %140, align 8
  %142 = load ptr, ptr %94, align 8
  %143 = getelementptr inbounds i8, ptr %89, i64 8
  %144 = load i64, ptr %143, align 8
  %145 = getelementptr inbounds double, ptr %142, i64 %144
  %146 = getelementptr inbounds i8, ptr %138, i64 24
  %147 = load ptr, ptr %146, align 8
  store <8 x double> %139, ptr %147, align 8
  %148 = getelementptr inbounds i8, ptr %138, i64 152
  %149 = load i64, ptr %148, align 8
  %150 = icmp sgt i64 %149, 0
  br i1 %150, label %151, label %152

151:                                              ; preds = %137
  tail call fastcc void @sample(ptr noundef nonnull %138) #10
  br label %152

152:                                              ; preds = %137, %151
  %153 = load ptr, ptr %138, align 8
  %154 = load i64, ptr %153, align 8
  %155 = load ptr, ptr %146, align 8
  %156 = getelementptr inbounds i8, ptr %138, i64 48
  %157 = load ptr, ptr %156, align 8
  %158 = getelementptr inbounds i8, ptr %138, i64 96
  %159 = load ptr, ptr %158, align 8
  %160 = inttoptr i64 %154 to ptr
  %161 = load ptr, ptr %160, align 8
  %162 = tail call i32 %161(ptr noundef %155, ptr noundef %141, ptr noundef %157, ptr noundef %159, ptr noundef %145) #11
  %163 = load ptr, ptr %1, align 8
  %164 = getelementptr inbounds i8, ptr %163, i64 120
  %165 = load ptr, ptr %164, align 8
  %166 = load double, ptr %165, align 8
  %167 = load ptr, ptr %94, align 8
  %168 = load i64, ptr %143, align 8
  %169 = getelementptr inbounds double, ptr %167, i64 %168
  %170 = icmp sgt i64 %91, 0
  br i1 %170, label %171, label %181

171:                                              ; preds = %152, %171
  %172 = phi i64 [ %179, %171 ], [ 0, %152 ]
  %173 = shl nsw i64 %172, 6
  %174 = getelementptr inbounds i8, ptr %169, i64 %173
  %175 = load <8 x double>, ptr %174, align 8
  %176 = getelementptr inbounds i8, ptr %167, i64 %173
  %177 = load <8 x double>, ptr %176, align 8
  %178 = fsub <8 x double> %175, %177
  store <8 x double> %178, ptr %174, align 8
  %179 = add nuw nsw i64 %172, 1
  %180 = icmp eq i64 %179, %91
  br i1 %180, label %181, label %171, !llvm.loop !32

181:                                              ; preds = %171, %152
  %182 = load ptr, ptr %89, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %169, ptr noundef %182, ptr noundef nonnull %89, i64 noundef %91) #10
  %183 = load <8 x double>, ptr %7, align 16
  %184 = fdiv <8 x double> %183, %110
  %185 = fcmp ogt <8 x double> %96, %184
  %186 = select <8 x i1> %185, <8 x double> %96, <8 x double> %184
  %187 = fcmp ogt <8 x double> %186, <double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15>
  %188 = fdiv <8 x double> <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>, %186
  %189 = select <8 x i1> %187, <8 x double> %188, <8 x double> <double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13>
  %190 = bitcast <8 x double> %189 to <8 x i64>
  %191 = add <8 x i64> %190, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %192 = ashr <8 x i64> %191, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %193 = and <8 x i64> %191, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %194 = sub <8 x i64> %190, %193
  %195 = bitcast <8 x i64> %194 to <8 x double>
  %196 = fadd <8 x double> %195, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %197 = fadd <8 x double> %195, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %198 = fdiv <8 x double> %196, %197
  %199 = fmul <8 x double> %198, %198
  %200 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %199, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %201 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %200, <8 x double> %199, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %202 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %201, <8 x double> %199, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %203 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %202, <8 x double> %199, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %204 = trunc nsw <8 x i64> %192 to <8 x i32>
  %205 = sitofp <8 x i32> %204 to <8 x double>
  %206 = fmul <8 x double> %198, %203
  %207 = fadd <8 x double> %206, %205
  %208 = insertelement <8 x double> poison, double %166, i64 0
  %209 = shufflevector <8 x double> %208, <8 x double> poison, <8 x i32> zeroinitializer
  %210 = fmul <8 x double> %209, %207
  %211 = fcmp ogt <8 x double> %210, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %212 = bitcast <8 x double> %210 to <8 x i64>
  %213 = select <8 x i1> %211, <8 x i64> %212, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %214 = bitcast <8 x i64> %213 to <8 x double>
  %215 = fcmp olt <8 x double> %214, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %216 = bitcast <8 x i64> %213 to <8 x double>
  %217 = select <8 x i1> %215, <8 x double> %216, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %218 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %217)
  %219 = fsub <8 x double> %217, %218
  %220 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %219, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %221 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %220, <8 x double> %219, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %222 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %221, <8 x double> %219, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %223 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %222, <8 x double> %219, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %224 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %223, <8 x double> %219, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %225 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %224, <8 x double> %219, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %226 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %225, <8 x double> %219, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %227 = bitcast <8 x double> %226 to <8 x i64>
  %228 = fptosi <8 x double> %218 to <8 x i32>
  %229 = zext <8 x i32> %228 to <8 x i64>
  %230 = shl <8 x i64> %229, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %231 = add <8 x i64> %230, %227
  %232 = fmul <8 x double> %110, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %233 = fcmp olt <8 x double> %232, <double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D>
  %234 = bitcast <8 x double> %232 to <8 x i64>
  %235 = select <8 x i1> %233, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %234
  %236 = fmul <8 x double> %110, <double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02>
  %237 = select <8 x i1> %187, <8 x i64> %231, <8 x i64> %235
  %238 = bitcast <8 x i64> %237 to <8 x double>
  %239 = fcmp olt <8 x double> %236, %238
  %240 = bitcast <8 x double> %236 to <8 x i64>
  %241 = select <8 x i1> %239, <8 x i64> %240, <8 x i64> %237
  %242 = bitcast <8 x i64> %241 to <8 x double>
  %243 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %19)
  %244 = fmul <8 x double> %243, <double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000>
  %245 = fcmp ogt <8 x double> %244, %242
  %246 = bitcast <8 x double> %244 to <8 x i64>
  %247 = select <8 x i1> %245, <8 x i64> %246, <8 x i64> %241
  %248 = bitcast <8 x i64> %247 to <8 x double>
  %249 = fcmp olt <8 x double> %101, %248
  %250 = select <8 x i1> %249, <8 x i64> %108, <8 x i64> %247
  %251 = trunc i32 %162 to i8
  %252 = bitcast i8 %251 to <8 x i1>
  %253 = select <8 x i1> %252, <8 x i64> %234, <8 x i64> %250
  %254 = bitcast <8 x i64> %253 to <8 x double>
  %255 = select <8 x i1> %88, <8 x double> %254, <8 x double> %84
  br label %256

256:                                              ; preds = %181, %81
  %257 = phi <8 x double> [ %255, %181 ], [ %84, %81 ]
  %258 = getelementptr inbounds i8, ptr %0, i64 720
  %259 = load ptr, ptr %258, align 8
  %260 = load <8 x double>, ptr %259, align 8
  %261 = select <8 x i1> %17, <8 x double> %257, <8 x double> %260
  store <8 x double> %261, ptr %259, align 8
  %262 = getelementptr inbounds i8, ptr %0, i64 744
  %263 = load ptr, ptr %262, align 8
  %264 = load <8 x double>, ptr %263, align 8
  %265 = select <8 x i1> %17, <8 x double> <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>, <8 x double> %264
  store <8 x double> %265, ptr %263, align 8
  %266 = getelementptr inbounds i8, ptr %0, i64 768
  %267 = load ptr, ptr %266, align 8
  %268 = load ptr, ptr %1, align 8
  %269 = getelementptr inbounds i8, ptr %268, i64 120
  %270 = load ptr, ptr %269, align 8
  %271 = getelementptr inbounds i8, ptr %270, i64 40
  %272 = load double, ptr %271, align 8
  %273 = insertelement <8 x double> poison, double %272, i64 0
  %274 = load <8 x i64>, ptr %267, align 8
  %275 = bitcast <8 x double> %273 to <8 x i64>
  %276 = shufflevector <8 x i64> %275, <8 x i64> poison, <8 x i32> zeroinitializer
  %277 = select <8 x i1> %17, <8 x i64> %276, <8 x i64> %274
  store <8 x i64> %277, ptr %267, align 8
  %278 = getelementptr inbounds i8, ptr %0, i64 840
  %279 = load ptr, ptr %278, align 8
  %280 = load <8 x double>, ptr %279, align 8
  %281 = select <8 x i1> %14, <8 x double> zeroinitializer, <8 x double> %280
  store <8 x double> %281, ptr %279, align 8
  %282 = getelementptr inbounds i8, ptr %0, i64 864
  %283 = load ptr, ptr %282, align 8
  %284 = load <8 x double>, ptr %283, align 8
  %285 = select <8 x i1> %14, <8 x double> zeroinitializer, <8 x double> %284
  store <8 x double> %285, ptr %283, align 8
  %286 = getelementptr inbounds i8, ptr %0, i64 888
  %287 = load ptr, ptr %286, align 8
  %288 = load <8 x double>, ptr %287, align 8
  %289 = select <8 x i1> %14, <8 x double> zeroinitializer, <8 x double> %288
  store <8 x double> %289, ptr %287, align 8
  %290 = getelementptr inbounds i8, ptr %0, i64 912
  %291 = load ptr, ptr %290, align 8
  %292 = tail call <8 x i1> @llvm.is.fpclass.v8f64(<8 x double> %257, i32 384)
  %293 = select <8 x i1> %292, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %294 = load <8 x i64>, ptr %291, align 8
  %295 = select <8 x i1> %17, <8 x i64> %293, <8 x i64> %294
  store <8 x i64> %295, ptr %291, align 8
  %296 = icmp eq i64 %2, 0
  br i1 %296, label %329, label %297

297:                                              ; preds = %256
  %298 = getelementptr inbounds i8, ptr %0, i64 936
  %299 = getelementptr inbounds i8, ptr %0, i64 1032
  %300 = getelementptr inbounds i8, ptr %0, i64 1040
  %301 = getelementptr inbounds i8, ptr %0, i64 792
  %302 = getelementptr inbounds i8, ptr %0, i64 816
  %303 = getelementptr inbounds i8, ptr %0, i64 960
  br label %304

304:                                              ; preds = %297, %304
  %305 = phi i64 [ %2, %297 ], [ %327, %304 ]
  %306 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %305, i1 true)
  %307 = load ptr, ptr %298, align 8
  %308 = getelementptr inbounds i64, ptr %307, i64 %306
  %309 = load i64, ptr %308, align 8
  %310 = load i64, ptr %300, align 8
  %311 = add nsw i64 %310, -1
  %312 = load ptr, ptr %301, align 8
  %313 = getelementptr inbounds double, ptr %312, i64 %306
  store double 0.000000e+00, ptr %313, align 8
  %314 = load ptr, ptr %299, align 8
  %315 = load double, ptr %314, align 8
  %316 = load ptr, ptr %302, align 8
  %317 = getelementptr inbounds double, ptr %316, i64 %306
  store double %315, ptr %317, align 8
  %318 = load ptr, ptr %10, align 8
  %319 = getelementptr inbounds i8, ptr %318, i64 24
  %320 = load i64, ptr %319, align 8
  %321 = shl i64 %309, 3
  %322 = mul i64 %321, %311
  %323 = add nsw i64 %320, %322
  %324 = load ptr, ptr %303, align 8
  %325 = getelementptr inbounds i64, ptr %324, i64 %306
  store i64 %323, ptr %325, align 8
  %326 = add nsw i64 %305, -1
  %327 = and i64 %326, %305
  %328 = icmp eq i64 %327, 0
  br i1 %328, label %329, label %304, !llvm.loop !33

329:                                              ; preds = %304, %256
  %330 = xor i64 %42, -1
  %331 = and i64 %330, %2
  %332 = icmp eq i64 %331, 0
  br i1 %332, label %336, label %333

333:                                              ; preds = %329
  %334 = getelementptr inbounds i8, ptr %0, i64 816
  %335 = getelementptr inbounds i8, ptr %0, i64 1032
  br label %357

336:                                              ; preds = %357, %329
  %337 = and i64 %15, %42
  %338 = xor i64 %337, %15
  %339 = getelementptr inbounds i8, ptr %0, i64 816
  %340 = load ptr, ptr %339, align 8
  %341 = load <8 x double>, ptr %340, align 8
  %342 = fcmp oeq <8 x double> %341, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %343 = bitcast <8 x i1> %342 to i8
  %344 = zext i8 %343 to i64
  %345 = and i64 %338, %344
  %346 = load ptr, ptr %286, align 8
  %347 = load <8 x double>, ptr %346, align 8
  %348 = select <8 x i1> %17, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %349 = or i64 %345, %337
  %350 = xor i64 %349, -1
  %351 = and i64 %82, %350
  %352 = trunc i64 %351 to i8
  %353 = bitcast i8 %352 to <8 x i1>
  %354 = select <8 x i1> %353, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %355 = fadd <8 x double> %348, %354
  %356 = fadd <8 x double> %347, %355
  store <8 x double> %356, ptr %346, align 8
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %337, i64 noundef 3) #10
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %345, i64 noundef 0) #10
  ret void

357:                                              ; preds = %333, %357
  %358 = phi i64 [ %331, %333 ], [ %369, %357 ]
  %359 = load ptr, ptr %12, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %359, i64 noundef %358) #10
  %360 = load ptr, ptr %334, align 8
  %361 = load <8 x double>, ptr %360, align 8
  %362 = load ptr, ptr %335, align 8
  %363 = load double, ptr %362, align 8
  %364 = insertelement <8 x double> poison, double %363, i64 0
  %365 = shufflevector <8 x double> %364, <8 x double> poison, <8 x i32> zeroinitializer
  %366 = fcmp oeq <8 x double> %361, %365
  %367 = bitcast <8 x i1> %366 to i8
  %368 = zext i8 %367 to i64
  %369 = and i64 %358, %368
  %370 = icmp eq i64 %369, 0
  br i1 %370, label %336, label %357, !llvm.loop !34
}

define internal fastcc void @hold_all(ptr noundef readonly %0, ptr noundef writeonly %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 696
  %4 = getelementptr inbounds i8, ptr %0, i64 384
  %5 = getelementptr inbounds i8, ptr %0, i64 392
  %6 = getelementptr inbounds i8, ptr %0, i64 408
  br label %8

7:                                                ; preds = %49
  ret void

8:                                                ; preds = %2, %49
  %9 = phi i64 [ 0, %2 ], [ %52, %49 ]
  %10 = load ptr, ptr %3, align 8
  %11 = getelementptr inbounds double, ptr %10, i64 %9
  %12 = load double, ptr %11, align 8
  %13 = load ptr, ptr %4, align 8
  %14 = load i64, ptr %5, align 8
  %15 = icmp eq i64 %14, 0
  br i1 %15, label %49, label %16

16:                                               ; preds = %8
  %17 = icmp sgt i64 %14, 0
  br i1 %17, label %18, label %31

18:                                               ; preds = %16, %18
  %19 = phi i64 [ %29, %18 ], [ %14, %16 ]
  %20 = phi i64 [ %28, %18 ], [ 0, %16 ]
  %21 = add nuw nsw i64 %19, %20
  %22 = lshr i64 %21, 1
  %23 = and i64 %21, -2
  %24 = getelementptr inbounds double, ptr %13, i64 %23
  %25 = load double, ptr %24, align 8
  %26 = fcmp ogt double %25, %12
  %27 = add nuw nsw i64 %22, 1
  %28 = select i1 %26, i64 %20, i64 %27
  %29 = select i1 %26, i64 %22, i64 %19
  %30 = icmp slt i64 %28, %29
  br i1 %30, label %18, label %31, !llvm.loop !35

31:                                               ; preds = %18, %16
  %32 = phi i64 [ 0, %16 ], [ %28, %18 ]
  %33 = icmp slt i64 %32, %14
  br i1 %33, label %34, label %39

34:                                               ; preds = %31
  %35 = shl nuw nsw i64 %32, 1
  %36 = or disjoint i64 %35, 1
  %37 = getelementptr inbounds double, ptr %13, i64 %36
  %38 = load double, ptr %37, align 8
  br label %39

39:                                               ; preds = %34, %31
  %40 = phi double [ %38, %34 ], [ 0x7FF0000000000000, %31 ]
  %41 = load ptr, ptr %6, align 8
  %42 = getelementptr inbounds double, ptr %41, i64 %9
  store double %40, ptr %42, align 8
  %43 = load i64, ptr %5, align 8
  %44 = icmp slt i64 %32, %43
  br i1 %44, label %45, label %49

45:                                               ; preds = %39
  %46 = shl nsw i64 %32, 4
  %47 = getelementptr inbounds i8, ptr %13, i64 %46
  %48 = load double, ptr %47, align 8
  br label %49

49:                                               ; preds = %8, %39, %45
  %50 = phi double [ 0x7FF0000000000000, %8 ], [ %48, %45 ], [ 0x7FF0000000000000, %39 ]
  %51 = getelementptr inbounds double, ptr %1, i64 %9
  store double %50, ptr %51, align 8
  %52 = add nuw nsw i64 %9, 1
  %53 = icmp eq i64 %52, 8
  br i1 %53, label %7, label %8, !llvm.loop !36
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
  %20 = getelementptr inbounds i8, ptr %0, i64 1128
  %21 = getelementptr inbounds i8, ptr %0, i64 1144
  %22 = getelementptr inbounds i8, ptr %0, i64 840
  %23 = getelementptr inbounds i8, ptr %0, i64 864
  %24 = getelementptr inbounds i8, ptr %0, i64 888
  %25 = icmp slt i64 %2, 0
  %26 = getelementptr inbounds i8, ptr %0, i64 912
  %27 = getelementptr inbounds i8, ptr %0, i64 1152
  %28 = getelementptr inbounds i8, ptr %0, i64 1704
  %29 = getelementptr inbounds i8, ptr %0, i64 1712
  %30 = getelementptr inbounds i8, ptr %0, i64 1192
  %31 = getelementptr inbounds i8, ptr %0, i64 1176
  %32 = getelementptr inbounds i8, ptr %0, i64 1192
  %33 = getelementptr inbounds i8, ptr %0, i64 1208
  %34 = getelementptr inbounds i8, ptr %0, i64 1248
  %35 = getelementptr inbounds i8, ptr %0, i64 1416
  %36 = getelementptr inbounds i8, ptr %0, i64 1464
  %37 = getelementptr inbounds i8, ptr %0, i64 1480
  %38 = getelementptr inbounds i8, ptr %0, i64 1200
  %39 = getelementptr inbounds i8, ptr %0, i64 1512
  %40 = getelementptr inbounds i8, ptr %0, i64 1528
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
  br i1 %86, label %61, label %64, !llvm.loop !37

87:                                               ; preds = %61, %87
  %88 = phi i64 [ %91, %87 ], [ 0, %61 ]
  %89 = mul nsw i64 %88, %12
  %90 = getelementptr inbounds double, ptr %63, i64 %89
  store double 0x7FF8000000000000, ptr %90, align 8
  %91 = add nuw nsw i64 %88, 1
  %92 = icmp eq i64 %91, %9
  br i1 %92, label %83, label %87, !llvm.loop !38

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
  br i1 %126, label %118, label %127, !llvm.loop !39

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
  br i1 %155, label %135, label %174, !llvm.loop !40

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
  br i1 %173, label %150, label %157, !llvm.loop !41

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
  br i1 %180, label %60, label %41, !llvm.loop !42
}

define internal fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %1, ptr noundef %2, i64 noundef %3, i32 noundef %4) unnamed_addr #2 {
  %6 = getelementptr inbounds i8, ptr %0, i64 1656
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
  %17 = tail call i64 %16(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %15, i64 noundef %3) #11
  ret i64 %17
}

define internal fastcc range(i64 0, 256) i64 @clear_lanes(ptr noundef readonly %0) unnamed_addr #3 {
  %2 = getelementptr inbounds i8, ptr %0, i64 432
  %3 = getelementptr inbounds i8, ptr %0, i64 1248
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 1200
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
  %20 = getelementptr inbounds i8, ptr %0, i64 1352
  %21 = load i64, ptr %20, align 8
  %22 = icmp sgt i64 %21, 0
  br i1 %22, label %23, label %30

23:                                               ; preds = %19
  %24 = getelementptr inbounds i8, ptr %0, i64 1344
  %25 = getelementptr inbounds i8, ptr %0, i64 456
  %26 = getelementptr inbounds i8, ptr %0, i64 600
  %27 = getelementptr inbounds i8, ptr %0, i64 440
  %28 = getelementptr inbounds i8, ptr %0, i64 1296
  %29 = getelementptr inbounds i8, ptr %4, i64 32
  br label %63

30:                                               ; preds = %86, %19
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
  %42 = getelementptr inbounds i8, ptr %0, i64 696
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
  %54 = load ptr, ptr %53, align 8
  %55 = tail call i32 %54(ptr noundef %46, ptr noundef %47, ptr noundef %48, ptr noundef %50, ptr noundef %52) #11
  %56 = trunc i32 %55 to i8
  %57 = xor i8 %56, -1
  %58 = icmp sgt i64 %12, 0
  br i1 %58, label %59, label %114

59:                                               ; preds = %30
  %60 = bitcast i8 %57 to <8 x i1>
  %61 = sext <8 x i1> %60 to <8 x i64>
  %62 = getelementptr inbounds i8, ptr %0, i64 1416
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
  br i1 %96, label %63, label %30, !llvm.loop !43

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
  br i1 %110, label %86, label %97, !llvm.loop !44

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
  br i1 %142, label %111, label %117, !llvm.loop !45

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
  %17 = tail call fastcc i64 @quiet_lanes(ptr noundef %0, ptr noundef %1, i64 noundef %16, ptr noundef nonnull %3) #10
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
  br i1 %25, label %9, label %21, !llvm.loop !46

26:                                               ; preds = %9, %51
  %27 = phi i64 [ %53, %51 ], [ %19, %9 ]
  %28 = phi i64 [ %46, %51 ], [ 0, %9 ]
  %29 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %27, i1 true)
  %30 = getelementptr inbounds double, ptr %3, i64 %29
  %31 = load double, ptr %30, align 8
  %32 = getelementptr inbounds double, ptr %6, i64 %29
  %33 = tail call fastcc i64 @look_alone(ptr noundef %0, i64 noundef %29, double noundef %31, ptr noundef %32) #10
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
  br i1 %54, label %48, label %26, !llvm.loop !47
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
  %38 = getelementptr inbounds i8, ptr %0, i64 1656
  br label %46

39:                                               ; preds = %31, %39
  %40 = phi i64 [ 0, %31 ], [ %44, %39 ]
  %41 = getelementptr inbounds i64, ptr %35, i64 %40
  %42 = load i64, ptr %41, align 8
  %43 = getelementptr inbounds [8 x i64], ptr %6, i64 0, i64 %40
  store i64 %42, ptr %43, align 8
  %44 = add nuw nsw i64 %40, 1
  %45 = icmp eq i64 %44, 8
  br i1 %45, label %36, label %39, !llvm.loop !48

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
  br label %46, !llvm.loop !49

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
  br i1 %111, label %112, label %96, !llvm.loop !50

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
  %41 = getelementptr inbounds i8, ptr %0, i64 1656
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
  br i1 %60, label %45, label %40, !llvm.loop !51

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
  br i1 %45, label %28, label %19, !llvm.loop !52

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
  br i1 %54, label %29, label %46, !llvm.loop !53
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
  %10 = getelementptr inbounds i8, ptr %0, i64 1200
  %11 = icmp sgt i64 %7, 0
  %12 = getelementptr inbounds i8, ptr %0, i64 432
  %13 = getelementptr inbounds i8, ptr %0, i64 696
  %14 = getelementptr inbounds i8, ptr %0, i64 1248
  %15 = getelementptr inbounds i8, ptr %0, i64 1440
  %16 = getelementptr inbounds i8, ptr %0, i64 1416
  %17 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %50, label %34, label %40, !llvm.loop !54

51:                                               ; preds = %34
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #10
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
  %89 = icmp ne i64 %88, 0
  %90 = select i1 %89, i64 %84, i64 %86
  %91 = zext i1 %89 to i64
  %92 = add nuw nsw i64 %85, %91
  %93 = add nuw nsw i64 %84, 1
  %94 = icmp eq i64 %93, %60
  br i1 %94, label %80, label %83, !llvm.loop !55

95:                                               ; preds = %80
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #10
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
  br i1 %139, label %120, label %123, !llvm.loop !56

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
  br i1 %195, label %177, label %180, !llvm.loop !57

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
  br i1 %210, label %196, label %200, !llvm.loop !58

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
  br i1 %218, label %32, label %20, !llvm.loop !59
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
  %26 = getelementptr inbounds i8, ptr %18, i64 152
  %27 = load i64, ptr %26, align 8
  %28 = icmp sgt i64 %27, 0
  br i1 %28, label %29, label %30

29:                                               ; preds = %17
  tail call fastcc void @sample(ptr noundef %18) #10
  br label %30

30:                                               ; preds = %17, %29
  %31 = load ptr, ptr %18, align 8
  %32 = load i64, ptr %31, align 8
  %33 = load ptr, ptr %24, align 8
  %34 = getelementptr inbounds i8, ptr %18, i64 48
  %35 = load ptr, ptr %34, align 8
  %36 = getelementptr inbounds i8, ptr %18, i64 96
  %37 = load ptr, ptr %36, align 8
  %38 = inttoptr i64 %32 to ptr
  %39 = load ptr, ptr %38, align 8
  %40 = tail call i32 %39(ptr noundef %33, ptr noundef %21, ptr noundef %35, ptr noundef %37, ptr noundef %23) #11
  %41 = load ptr, ptr %9, align 8
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds i8, ptr %42, i64 8
  %44 = load i64, ptr %43, align 8
  %45 = icmp sgt i64 %44, 0
  br i1 %45, label %46, label %48

46:                                               ; preds = %30
  %47 = getelementptr inbounds i8, ptr %6, i64 168
  br label %56

48:                                               ; preds = %56, %30
  %49 = sext i32 %40 to i64
  %50 = and i64 %49, %2
  %51 = getelementptr inbounds i8, ptr %0, i64 888
  %52 = load ptr, ptr %51, align 8
  %53 = load <8 x double>, ptr %52, align 8
  %54 = select <8 x i1> %8, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %55 = fadd <8 x double> %54, %53
  store <8 x double> %55, ptr %52, align 8
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %50, i64 noundef 3) #10
  ret i64 %50

56:                                               ; preds = %46, %56
  %57 = phi i64 [ 0, %46 ], [ %66, %56 ]
  %58 = load ptr, ptr %47, align 8
  %59 = load ptr, ptr %22, align 8
  %60 = shl nsw i64 %57, 6
  %61 = getelementptr inbounds i8, ptr %59, i64 %60
  %62 = load <8 x i64>, ptr %61, align 8
  %63 = getelementptr inbounds i8, ptr %58, i64 %60
  %64 = load <8 x i64>, ptr %63, align 8
  %65 = select <8 x i1> %8, <8 x i64> %62, <8 x i64> %64
  store <8 x i64> %65, ptr %63, align 8
  %66 = add nuw nsw i64 %57, 1
  %67 = load ptr, ptr %9, align 8
  %68 = load ptr, ptr %67, align 8
  %69 = getelementptr inbounds i8, ptr %68, i64 8
  %70 = load i64, ptr %69, align 8
  %71 = icmp slt i64 %66, %70
  br i1 %71, label %56, label %48, !llvm.loop !60
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
  br i1 %48, label %13, label %20, !llvm.loop !61
}

declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #5

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #5

declare <8 x double> @llvm.rint.v8f64(<8 x double>) #5

declare <8 x double> @llvm.ceil.v8f64(<8 x double>) #5

define internal fastcc void @empty_log(ptr noundef readonly %0, i64 noundef %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 1248
  %4 = getelementptr inbounds i8, ptr %0, i64 1200
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i64, ptr %5, i64 %1
  %7 = load i64, ptr %6, align 8
  %8 = inttoptr i64 %7 to ptr
  %9 = getelementptr inbounds i8, ptr %8, i64 648
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
  %20 = getelementptr inbounds i8, ptr %0, i64 936
  %21 = getelementptr inbounds i8, ptr %0, i64 1536
  %22 = getelementptr inbounds i8, ptr %8, i64 1056
  %23 = getelementptr inbounds i8, ptr %8, i64 1080
  %24 = getelementptr inbounds i8, ptr %0, i64 1584
  %25 = icmp sgt i64 %14, 0
  %26 = getelementptr inbounds i8, ptr %8, i64 1104
  %27 = getelementptr inbounds i8, ptr %8, i64 1128
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
  br i1 %60, label %29, label %33, !llvm.loop !62

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
  br i1 %76, label %57, label %61, !llvm.loop !63
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
  br i1 %50, label %51, label %25, !llvm.loop !64

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
  br i1 %98, label %14, label %19, !llvm.loop !65

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
  br i1 %123, label %104, label %110, !llvm.loop !64

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
  br i1 %138, label %99, label %139, !llvm.loop !66

139:                                              ; preds = %135, %14
  ret void
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
  br i1 %25, label %15, label %14, !llvm.loop !67

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
  br i1 %76, label %65, label %77, !llvm.loop !68

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
  br i1 %105, label %22, label %26, !llvm.loop !69
}

define internal fastcc range(i64 0, 256) i64 @quiet_lanes(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, ptr noundef readonly %3) unnamed_addr #3 {
  %5 = alloca [5 x <8 x double>], align 64
  %6 = getelementptr inbounds i8, ptr %0, i64 1248
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 1200
  %11 = load ptr, ptr %10, align 8
  %12 = load i64, ptr %11, align 8
  %13 = inttoptr i64 %12 to ptr
  %14 = getelementptr inbounds i8, ptr %13, i64 864
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 1440
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
  br i1 %26, label %95, label %27

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
  %73 = getelementptr inbounds i8, ptr %0, i64 1272
  %74 = load ptr, ptr %73, align 8
  %75 = inttoptr i64 %65 to ptr
  %76 = load ptr, ptr %75, align 8
  %77 = tail call i32 %76(ptr noundef %67, ptr noundef %70, ptr noundef %72, ptr noundef %74, ptr noundef %29) #11
  %78 = zext i32 %77 to i64
  %79 = and i64 %78, %24
  %80 = icmp sgt i64 %9, 0
  br i1 %80, label %81, label %95

81:                                               ; preds = %63
  %82 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %94, label %95, label %83, !llvm.loop !70

95:                                               ; preds = %83, %63, %4
  %96 = phi i64 [ 0, %4 ], [ %79, %63 ], [ %79, %83 ]
  %97 = getelementptr inbounds i8, ptr %0, i64 1368
  %98 = shl i64 %9, 6
  %99 = getelementptr inbounds i8, ptr %1, i64 16
  %100 = getelementptr inbounds i8, ptr %1, i64 8
  %101 = getelementptr inbounds i8, ptr %0, i64 168
  %102 = getelementptr inbounds i8, ptr %0, i64 296
  %103 = getelementptr inbounds i8, ptr %0, i64 144
  %104 = getelementptr inbounds i8, ptr %0, i64 168
  %105 = getelementptr inbounds i8, ptr %0, i64 192
  %106 = getelementptr inbounds i8, ptr %0, i64 1272
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
  %115 = getelementptr inbounds i8, ptr %0, i64 1416
  %116 = load ptr, ptr %115, align 8
  %117 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %175, label %107, label %120, !llvm.loop !71

176:                                              ; preds = %304, %107
  %177 = phi <8 x i64> [ %112, %107 ], [ %306, %304 ]
  %178 = icmp sgt i64 %9, 0
  br i1 %178, label %179, label %309

179:                                              ; preds = %176
  %180 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %225, label %191, label %196, !llvm.loop !72

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
  br i1 %303, label %304, label %244, !llvm.loop !73

304:                                              ; preds = %301
  %305 = xor <8 x i64> %302, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %306 = and <8 x i64> %239, %305
  %307 = add nuw nsw i64 %186, 1
  %308 = icmp eq i64 %307, %9
  br i1 %308, label %176, label %183, !llvm.loop !74

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
  br i1 %330, label %309, label %318, !llvm.loop !75
}

define internal fastcc i64 @look_alone(ptr noundef readonly %0, i64 noundef %1, double noundef %2, ptr noundef writeonly %3) unnamed_addr #2 {
  %5 = getelementptr inbounds i8, ptr %0, i64 1200
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
  %25 = getelementptr inbounds i8, ptr %0, i64 1248
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
  %39 = getelementptr inbounds i8, ptr %0, i64 1440
  %40 = load ptr, ptr %39, align 8
  %41 = getelementptr inbounds double, ptr %40, i64 %1
  %42 = load double, ptr %41, align 8
  store double %42, ptr %38, align 8
  %43 = icmp sgt i64 %32, 0
  br i1 %43, label %44, label %64

44:                                               ; preds = %24
  %45 = getelementptr inbounds i8, ptr %0, i64 1416
  %46 = getelementptr inbounds i8, ptr %29, i64 936
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
  br i1 %63, label %64, label %48, !llvm.loop !57

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
  %86 = tail call i64 %81(ptr noundef %9, double noundef %70, double noundef %85) #11
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
  %110 = getelementptr inbounds i8, ptr %0, i64 1416
  %111 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %127, label %128, label %112, !llvm.loop !57

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
  br i1 %149, label %24, label %129, !llvm.loop !76

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
  br i1 %168, label %150, label %147, !llvm.loop !77
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
  br i1 %31, label %20, label %19, !llvm.loop !78

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
  br i1 %43, label %32, label %24, !llvm.loop !79
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
!36 = distinct !{!36, !4, !5}
!37 = distinct !{!37, !4, !5}
!38 = distinct !{!38, !4, !5, !21}
!39 = distinct !{!39, !4, !5, !21}
!40 = distinct !{!40, !4, !5}
!41 = distinct !{!41, !4, !5}
!42 = distinct !{!42, !4, !5}
!43 = distinct !{!43, !4, !5}
!44 = distinct !{!44, !4, !5}
!45 = distinct !{!45, !4, !5}
!46 = distinct !{!46, !4, !5}
!47 = distinct !{!47, !4, !5}
!48 = distinct !{!48, !4, !5, !21}
!49 = distinct !{!49, !5}
!50 = distinct !{!50, !4, !5}
!51 = distinct !{!51, !4, !5}
!52 = distinct !{!52, !4, !5}
!53 = distinct !{!53, !4, !5, !21}
!54 = distinct !{!54, !4, !5}
!55 = distinct !{!55, !4, !5}
!56 = distinct !{!56, !4, !5}
!57 = distinct !{!57, !4, !5, !21}
!58 = distinct !{!58, !4, !5}
!59 = distinct !{!59, !4, !5}
!60 = distinct !{!60, !4, !5}
!61 = distinct !{!61, !4, !5}
!62 = distinct !{!62, !4, !5}
!63 = distinct !{!63, !4, !5, !21}
!64 = distinct !{!64, !4, !5}
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
!76 = distinct !{!76, !4, !5, !21}
!77 = distinct !{!77, !4, !5}
!78 = distinct !{!78, !4, !5}
!79 = distinct !{!79, !4, !5}
