; sources 0b8d5c47d63dbd182f2588963e1790defd7b6754be296e5d17d3000e9e74c148
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

@scan_points = internal unnamed_addr constant [5 x double] [double 0.000000e+00, double 0x3FCE3779B97F4A7C, double 0x3FDCC470A0490974, double 0x3FE76CF5D0B09954, double 1.000000e+00], align 16

define noundef i64 @step_lanes(ptr noundef %0) #0 {
  %2 = alloca [64 x double], align 16
  %3 = alloca [64 x double], align 16
  %4 = alloca %struct.Stepper, align 8
  %5 = alloca [8 x double], align 16
  %6 = alloca [8 x double], align 16
  %7 = alloca [8 x double], align 16
  %8 = alloca i64, align 8
  %9 = alloca [8 x i64], align 16
  %10 = alloca i64, align 8
  store ptr %0, ptr %4, align 8
  %11 = getelementptr inbounds i8, ptr %4, i64 8
  %12 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %12, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %4, i64 16
  %14 = getelementptr inbounds i8, ptr %0, i64 432
  store ptr %14, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 984
  %16 = load ptr, ptr %12, align 8
  %17 = getelementptr inbounds i8, ptr %16, i64 8
  %18 = load i64, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 1032
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds i8, ptr %0, i64 1040
  %22 = load i64, ptr %21, align 8
  %23 = getelementptr double, ptr %20, i64 %22
  %24 = getelementptr i8, ptr %23, i64 -16
  %25 = load double, ptr %24, align 8
  %26 = getelementptr inbounds i8, ptr %0, i64 1008
  %27 = load ptr, ptr %26, align 8
  %28 = load double, ptr %27, align 8
  %29 = load ptr, ptr %15, align 8
  %30 = getelementptr inbounds i8, ptr %29, i64 16
  %31 = load i64, ptr %30, align 8
  %32 = load ptr, ptr %0, align 8
  %33 = getelementptr inbounds i8, ptr %32, i64 8
  %34 = load i64, ptr %33, align 8
  %35 = icmp sgt i64 %34, 0
  %36 = getelementptr inbounds i8, ptr %0, i64 1680
  %37 = load ptr, ptr %36, align 8
  %38 = load i64, ptr %37, align 8
  %39 = getelementptr inbounds i8, ptr %0, i64 1272
  %40 = load ptr, ptr %39, align 8
  %41 = getelementptr inbounds i8, ptr %40, i64 8
  %42 = load i64, ptr %41, align 8
  store i64 0, ptr %8, align 8
  %43 = getelementptr inbounds i8, ptr %0, i64 936
  %44 = load ptr, ptr %43, align 8
  br label %125

45:                                               ; preds = %125
  %46 = getelementptr inbounds i8, ptr %0, i64 696
  %47 = sitofp i64 %31 to double
  %48 = zext i1 %35 to i32
  %49 = icmp eq i64 %38, 1
  %50 = icmp sgt i64 %42, 0
  store i64 %133, ptr %8, align 8
  %51 = getelementptr inbounds i8, ptr %0, i64 936
  %52 = getelementptr inbounds i8, ptr %0, i64 1592
  %53 = getelementptr inbounds i8, ptr %0, i64 1224
  %54 = getelementptr inbounds i8, ptr %0, i64 816
  %55 = insertelement <8 x double> poison, double %25, i64 0
  %56 = shufflevector <8 x double> %55, <8 x double> poison, <8 x i32> zeroinitializer
  %57 = getelementptr inbounds i8, ptr %0, i64 720
  %58 = getelementptr inbounds i8, ptr %0, i64 720
  %59 = insertelement <8 x double> poison, double %28, i64 0
  %60 = shufflevector <8 x double> %59, <8 x double> poison, <8 x i32> zeroinitializer
  %61 = getelementptr inbounds i8, ptr %0, i64 840
  %62 = getelementptr inbounds i8, ptr %0, i64 864
  %63 = insertelement <8 x double> poison, double %47, i64 0
  %64 = shufflevector <8 x double> %63, <8 x double> poison, <8 x i32> zeroinitializer
  %65 = load ptr, ptr %13, align 8
  %66 = load ptr, ptr %4, align 8
  %67 = load ptr, ptr %11, align 8
  %68 = getelementptr inbounds i8, ptr %65, i64 72
  %69 = getelementptr inbounds i8, ptr %65, i64 48
  %70 = getelementptr inbounds i8, ptr %66, i64 24
  %71 = getelementptr inbounds i8, ptr %65, i64 168
  %72 = getelementptr inbounds i8, ptr %66, i64 48
  %73 = getelementptr inbounds i8, ptr %66, i64 72
  %74 = getelementptr inbounds i8, ptr %65, i64 8
  %75 = getelementptr inbounds i8, ptr %66, i64 96
  %76 = getelementptr inbounds i8, ptr %67, i64 24
  %77 = getelementptr inbounds i8, ptr %67, i64 152
  %78 = getelementptr inbounds i8, ptr %67, i64 48
  %79 = getelementptr inbounds i8, ptr %67, i64 96
  %80 = getelementptr inbounds i8, ptr %65, i64 24
  %81 = getelementptr inbounds i8, ptr %66, i64 24
  %82 = getelementptr inbounds i8, ptr %65, i64 168
  %83 = getelementptr inbounds i8, ptr %66, i64 48
  %84 = getelementptr inbounds i8, ptr %66, i64 72
  %85 = getelementptr inbounds i8, ptr %65, i64 8
  %86 = getelementptr inbounds i8, ptr %67, i64 24
  %87 = getelementptr inbounds i8, ptr %67, i64 152
  %88 = getelementptr inbounds i8, ptr %67, i64 48
  %89 = getelementptr inbounds i8, ptr %67, i64 96
  %90 = getelementptr inbounds i8, ptr %65, i64 144
  %91 = getelementptr inbounds i8, ptr %65, i64 8
  %92 = getelementptr inbounds i8, ptr %65, i64 120
  %93 = getelementptr inbounds i8, ptr %65, i64 240
  %94 = getelementptr inbounds i8, ptr %65, i64 216
  %95 = getelementptr inbounds i8, ptr %65, i64 240
  %96 = getelementptr inbounds i8, ptr %65, i64 216
  %97 = getelementptr inbounds i8, ptr %0, i64 888
  %98 = getelementptr inbounds i8, ptr %0, i64 456
  %99 = getelementptr inbounds i8, ptr %65, i64 8
  %100 = getelementptr inbounds i8, ptr %67, i64 24
  %101 = getelementptr inbounds i8, ptr %67, i64 152
  %102 = getelementptr inbounds i8, ptr %67, i64 48
  %103 = getelementptr inbounds i8, ptr %67, i64 96
  %104 = getelementptr inbounds i8, ptr %0, i64 816
  %105 = getelementptr inbounds i8, ptr %65, i64 8
  %106 = getelementptr inbounds i8, ptr %65, i64 192
  %107 = getelementptr inbounds i8, ptr %65, i64 48
  %108 = getelementptr inbounds i8, ptr %66, i64 96
  %109 = getelementptr inbounds i8, ptr %67, i64 24
  %110 = getelementptr inbounds i8, ptr %67, i64 152
  %111 = getelementptr inbounds i8, ptr %67, i64 48
  %112 = getelementptr inbounds i8, ptr %67, i64 96
  %113 = getelementptr inbounds i8, ptr %65, i64 120
  %114 = getelementptr inbounds i8, ptr %0, i64 456
  %115 = getelementptr inbounds i8, ptr %0, i64 120
  %116 = getelementptr inbounds i8, ptr %0, i64 720
  %117 = getelementptr inbounds i8, ptr %0, i64 744
  %118 = getelementptr inbounds i8, ptr %0, i64 768
  %119 = getelementptr inbounds i8, ptr %0, i64 912
  %120 = icmp sgt i64 %18, 0
  %121 = getelementptr inbounds i8, ptr %0, i64 456
  %122 = getelementptr inbounds i8, ptr %0, i64 600
  %123 = getelementptr inbounds i8, ptr %0, i64 440
  %124 = icmp sgt i64 %18, 0
  br label %136

125:                                              ; preds = %1, %125
  %126 = phi i64 [ 0, %1 ], [ %134, %125 ]
  %127 = phi i64 [ 0, %1 ], [ %133, %125 ]
  %128 = getelementptr inbounds i64, ptr %44, i64 %126
  %129 = load i64, ptr %128, align 8
  %130 = icmp sgt i64 %129, -1
  %131 = zext i1 %130 to i64
  %132 = shl nuw nsw i64 %131, %126
  %133 = or i64 %132, %127
  %134 = add nuw nsw i64 %126, 1
  %135 = icmp eq i64 %134, 8
  br i1 %135, label %45, label %125, !llvm.loop !3

136:                                              ; preds = %171, %45
  %137 = phi i32 [ 1, %45 ], [ %172, %171 ]
  %138 = phi i64 [ 0, %45 ], [ %173, %171 ]
  %139 = icmp ne i32 %137, 0
  %140 = icmp ne i64 %138, 0
  %141 = select i1 %139, i1 true, i1 %140
  br i1 %141, label %142, label %174

142:                                              ; preds = %136
  br i1 %139, label %143, label %145

143:                                              ; preds = %142
  %144 = call fastcc i64 @fill(ptr noundef nonnull %0, ptr noundef nonnull %8) #11
  br label %145

145:                                              ; preds = %142, %143
  %146 = phi i64 [ %144, %143 ], [ 0, %142 ]
  %147 = load i64, ptr %8, align 8
  %148 = icmp eq i64 %147, 0
  br i1 %148, label %167, label %149

149:                                              ; preds = %145
  %150 = or i64 %146, %138
  %151 = icmp eq i64 %150, 0
  br i1 %151, label %167, label %152

152:                                              ; preds = %149
  call fastcc void @start(ptr noundef nonnull %0, ptr noundef nonnull %4, i64 noundef %146, i64 noundef %138) #11
  br label %153

153:                                              ; preds = %152, %162
  %154 = phi i32 [ 0, %152 ], [ %164, %162 ]
  %155 = phi i64 [ 0, %152 ], [ %165, %162 ]
  %156 = icmp eq i32 %154, 0
  br i1 %156, label %157, label %162

157:                                              ; preds = %153
  %158 = load ptr, ptr %51, align 8
  %159 = getelementptr inbounds i64, ptr %158, i64 %155
  %160 = load i64, ptr %159, align 8
  %161 = icmp eq i64 %160, -1
  br label %162

162:                                              ; preds = %157, %153
  %163 = phi i1 [ true, %153 ], [ %161, %157 ]
  %164 = zext i1 %163 to i32
  %165 = add nuw nsw i64 %155, 1
  %166 = icmp eq i64 %165, 8
  br i1 %166, label %167, label %153, !llvm.loop !6

167:                                              ; preds = %162, %149, %145
  %168 = phi i32 [ 1, %145 ], [ 8, %149 ], [ 0, %162 ]
  %169 = phi i32 [ %137, %145 ], [ 0, %149 ], [ %164, %162 ]
  %170 = phi i64 [ %138, %145 ], [ %138, %149 ], [ 0, %162 ]
  switch i32 %168, label %1304 [
    i32 0, label %171
    i32 8, label %174
  ]

171:                                              ; preds = %167, %1302, %254
  %172 = phi i32 [ %169, %167 ], [ %1303, %1302 ], [ 1, %254 ]
  %173 = phi i64 [ %170, %167 ], [ %1280, %1302 ], [ %176, %254 ]
  br label %136, !llvm.loop !7

174:                                              ; preds = %167, %136
  %175 = phi i32 [ %169, %167 ], [ 0, %136 ]
  %176 = phi i64 [ %170, %167 ], [ 0, %136 ]
  %177 = load ptr, ptr %15, align 8
  %178 = getelementptr inbounds i8, ptr %177, i64 8
  %179 = load i64, ptr %178, align 8
  %180 = icmp slt i64 %179, 1
  br i1 %180, label %1304, label %181

181:                                              ; preds = %174
  br i1 %50, label %182, label %202

182:                                              ; preds = %181
  %183 = load i64, ptr %52, align 8
  %184 = icmp sgt i64 %183, 0
  br i1 %184, label %185, label %199

185:                                              ; preds = %182
  %186 = load ptr, ptr %39, align 8
  %187 = getelementptr inbounds i8, ptr %186, i64 72
  %188 = load i64, ptr %187, align 8
  %189 = load ptr, ptr %53, align 8
  %190 = load i64, ptr %189, align 8
  %191 = inttoptr i64 %190 to ptr
  %192 = getelementptr inbounds i8, ptr %191, i64 1064
  %193 = load i64, ptr %192, align 8
  %194 = shl i64 %193, 4
  %195 = add i64 %188, 16
  %196 = add i64 %195, %194
  %197 = icmp sgt i64 %196, %183
  %198 = zext i1 %197 to i32
  br label %199

199:                                              ; preds = %182, %185
  %200 = phi i32 [ 0, %182 ], [ %198, %185 ]
  %201 = icmp eq i32 %200, 0
  br i1 %201, label %202, label %1304

202:                                              ; preds = %199, %181
  %203 = add nsw i64 %179, -1
  store i64 %203, ptr %178, align 8
  %204 = load i64, ptr %8, align 8
  %205 = trunc i64 %204 to i8
  %206 = bitcast i8 %205 to <8 x i1>
  %207 = load ptr, ptr %46, align 8
  %208 = load <8 x double>, ptr %207, align 8
  call fastcc void @hold_all(ptr noundef nonnull %0, ptr noundef nonnull %7) #11
  br i1 %35, label %212, label %209

209:                                              ; preds = %202
  %210 = load ptr, ptr %54, align 8
  %211 = load <8 x double>, ptr %210, align 8
  br label %212

212:                                              ; preds = %202, %209
  %213 = phi <8 x double> [ %211, %209 ], [ %56, %202 ]
  %214 = load <8 x double>, ptr %7, align 16
  %215 = fcmp olt <8 x double> %213, %214
  %216 = select <8 x i1> %215, <8 x double> %213, <8 x double> %214
  br i1 %35, label %217, label %222

217:                                              ; preds = %212
  %218 = load ptr, ptr %58, align 8
  %219 = load <8 x double>, ptr %218, align 8
  %220 = fcmp olt <8 x double> %219, %60
  %221 = select <8 x i1> %220, <8 x double> %219, <8 x double> %60
  br label %230

222:                                              ; preds = %212
  %223 = load ptr, ptr %57, align 8
  %224 = load <8 x double>, ptr %223, align 8
  %225 = fsub <8 x double> %216, %208
  %226 = fdiv <8 x double> %225, %224
  %227 = fmul <8 x double> %226, <double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1>
  %228 = call <8 x double> @llvm.ceil.v8f64(<8 x double> %227)
  %229 = fdiv <8 x double> %225, %228
  br label %230

230:                                              ; preds = %222, %217
  %231 = phi <8 x double> [ %221, %217 ], [ %229, %222 ]
  %232 = fadd <8 x double> %208, %231
  %233 = fmul <8 x double> %231, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %234 = fsub <8 x double> %216, %233
  %235 = fcmp ogt <8 x double> %232, %234
  %236 = select <8 x i1> %235, <8 x double> %216, <8 x double> %232
  %237 = fsub <8 x double> %236, %208
  %238 = select <8 x i1> %206, <8 x double> %237, <8 x double> zeroinitializer
  %239 = load ptr, ptr %61, align 8
  %240 = load <8 x double>, ptr %239, align 8
  %241 = load ptr, ptr %62, align 8
  %242 = load <8 x double>, ptr %241, align 8
  %243 = fadd <8 x double> %240, %242
  %244 = fcmp oge <8 x double> %243, %64
  %245 = fmul <8 x double> %238, <double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02>
  %246 = fadd <8 x double> %208, %245
  %247 = fcmp ule <8 x double> %246, %208
  %248 = fcmp une <8 x double> %236, %216
  %249 = and <8 x i1> %247, %248
  %250 = or <8 x i1> %249, %244
  %251 = and <8 x i1> %250, %206
  %252 = bitcast <8 x i1> %251 to i8
  %253 = icmp eq i8 %252, 0
  br i1 %253, label %261, label %254

254:                                              ; preds = %230
  %255 = zext i8 %252 to i64
  %256 = bitcast <8 x i1> %244 to i8
  %257 = zext i8 %256 to i64
  %258 = and i64 %255, %257
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %258, i64 noundef 1) #11
  %259 = xor i64 %257, -1
  %260 = and i64 %255, %259
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %260, i64 noundef -1) #11
  br label %171

261:                                              ; preds = %230
  %262 = load ptr, ptr %66, align 8, !noalias !8
  %263 = load ptr, ptr %67, align 8, !noalias !8
  %264 = getelementptr inbounds i8, ptr %263, i64 8
  %265 = load i64, ptr %264, align 8, !noalias !8
  %266 = getelementptr inbounds i8, ptr %262, i64 32
  %267 = load i64, ptr %266, align 8, !noalias !8
  %268 = icmp ne i64 %267, 1
  %269 = load i64, ptr %262, align 8, !noalias !8
  %270 = load ptr, ptr %68, align 8, !noalias !8
  store <8 x double> %238, ptr %270, align 8, !noalias !8
  %271 = icmp sgt i64 %269, 1
  br i1 %271, label %272, label %328

272:                                              ; preds = %261, %315
  %273 = phi i64 [ %325, %315 ], [ 0, %261 ]
  %274 = phi i64 [ %326, %315 ], [ 1, %261 ]
  %275 = load ptr, ptr %69, align 8, !noalias !8
  %276 = load ptr, ptr %65, align 8, !noalias !8
  %277 = load ptr, ptr %67, align 8, !noalias !8
  %278 = getelementptr inbounds i8, ptr %277, i64 16
  %279 = load i64, ptr %278, align 8, !noalias !8
  %280 = load ptr, ptr %70, align 8, !noalias !8
  %281 = getelementptr inbounds i64, ptr %280, i64 %274
  %282 = load i64, ptr %281, align 8, !noalias !8
  %283 = getelementptr i8, ptr %281, i64 8
  %284 = load i64, ptr %283, align 8, !noalias !8
  %285 = xor i64 %282, -1
  %286 = add i64 %284, %285
  %287 = load ptr, ptr %68, align 8, !noalias !8
  %288 = load ptr, ptr %71, align 8, !noalias !8
  %289 = load ptr, ptr %72, align 8, !noalias !8
  %290 = getelementptr inbounds i64, ptr %289, i64 %282
  %291 = load ptr, ptr %73, align 8, !noalias !8
  %292 = getelementptr inbounds double, ptr %291, i64 %282
  call fastcc void @combine(ptr noundef %275, ptr noundef %276, ptr noundef %287, ptr noundef %288, ptr noundef %290, ptr noundef %292, i64 noundef %286, i64 noundef %279) #11
  %293 = load ptr, ptr %71, align 8, !noalias !8
  %294 = load i64, ptr %74, align 8, !noalias !8
  %295 = mul nsw i64 %294, %274
  %296 = getelementptr inbounds double, ptr %293, i64 %295
  %297 = load ptr, ptr %75, align 8, !noalias !8
  %298 = getelementptr inbounds double, ptr %297, i64 %274
  %299 = load double, ptr %298, align 8, !noalias !8
  %300 = insertelement <8 x double> poison, double %299, i64 0
  %301 = shufflevector <8 x double> %300, <8 x double> poison, <8 x i32> zeroinitializer
  %302 = fmul <8 x double> %238, %301
  %303 = fadd <8 x double> %208, %302
  %304 = load ptr, ptr %69, align 8, !noalias !8
  %305 = load ptr, ptr %76, align 8, !noalias !8
  store <8 x double> %303, ptr %305, align 8, !noalias !8
  %306 = load ptr, ptr %67, align 8, !noalias !8
  %307 = getelementptr inbounds i8, ptr %306, i64 40
  %308 = load i64, ptr %307, align 8, !noalias !8
  %309 = icmp eq i64 %308, 0
  br i1 %309, label %311, label %310

310:                                              ; preds = %272
  call fastcc void @settle(ptr noundef nonnull %67) #11, !noalias !8
  br label %311

311:                                              ; preds = %310, %272
  %312 = load i64, ptr %77, align 8, !noalias !8
  %313 = icmp sgt i64 %312, 0
  br i1 %313, label %314, label %315

314:                                              ; preds = %311
  call fastcc void @sample(ptr noundef nonnull %67) #11, !noalias !8
  br label %315

315:                                              ; preds = %314, %311
  %316 = load ptr, ptr %67, align 8, !noalias !8
  %317 = load i64, ptr %316, align 8, !noalias !8
  %318 = load ptr, ptr %76, align 8, !noalias !8
  %319 = load ptr, ptr %78, align 8, !noalias !8
  %320 = load ptr, ptr %79, align 8, !noalias !8
  %321 = inttoptr i64 %317 to ptr
  %322 = load ptr, ptr %321, align 8, !noalias !8
  %323 = call i32 %322(ptr noundef %318, ptr noundef %304, ptr noundef %319, ptr noundef %320, ptr noundef %296) #12, !noalias !8
  %324 = zext i32 %323 to i64
  %325 = or i64 %273, %324
  %326 = add nuw nsw i64 %274, 1
  %327 = icmp eq i64 %326, %269
  br i1 %327, label %328, label %272, !llvm.loop !11

328:                                              ; preds = %315, %261
  %329 = phi i64 [ 0, %261 ], [ %325, %315 ]
  %330 = load ptr, ptr %80, align 8, !noalias !8
  %331 = load ptr, ptr %65, align 8, !noalias !8
  %332 = load ptr, ptr %67, align 8, !noalias !8
  %333 = getelementptr inbounds i8, ptr %332, i64 16
  %334 = load i64, ptr %333, align 8, !noalias !8
  %335 = load ptr, ptr %81, align 8, !noalias !8
  %336 = getelementptr inbounds i64, ptr %335, i64 %269
  %337 = load i64, ptr %336, align 8, !noalias !8
  %338 = getelementptr i8, ptr %336, i64 8
  %339 = load i64, ptr %338, align 8, !noalias !8
  %340 = xor i64 %337, -1
  %341 = add i64 %339, %340
  %342 = load ptr, ptr %68, align 8, !noalias !8
  %343 = load ptr, ptr %82, align 8, !noalias !8
  %344 = load ptr, ptr %83, align 8, !noalias !8
  %345 = getelementptr inbounds i64, ptr %344, i64 %337
  %346 = load ptr, ptr %84, align 8, !noalias !8
  %347 = getelementptr inbounds double, ptr %346, i64 %337
  call fastcc void @combine(ptr noundef %330, ptr noundef %331, ptr noundef %342, ptr noundef %343, ptr noundef %345, ptr noundef %347, i64 noundef %341, i64 noundef %334) #11
  br i1 %268, label %376, label %348

348:                                              ; preds = %328
  %349 = load ptr, ptr %80, align 8, !noalias !8
  %350 = load ptr, ptr %82, align 8, !noalias !8
  %351 = load i64, ptr %262, align 8, !noalias !8
  %352 = load i64, ptr %85, align 8, !noalias !8
  %353 = mul nsw i64 %352, %351
  %354 = getelementptr inbounds double, ptr %350, i64 %353
  %355 = load ptr, ptr %86, align 8, !noalias !8
  store <8 x double> %236, ptr %355, align 8, !noalias !8
  %356 = load ptr, ptr %67, align 8, !noalias !8
  %357 = getelementptr inbounds i8, ptr %356, i64 40
  %358 = load i64, ptr %357, align 8, !noalias !8
  %359 = icmp eq i64 %358, 0
  br i1 %359, label %361, label %360

360:                                              ; preds = %348
  call fastcc void @settle(ptr noundef nonnull %67) #11, !noalias !8
  br label %361

361:                                              ; preds = %360, %348
  %362 = load i64, ptr %87, align 8, !noalias !8
  %363 = icmp sgt i64 %362, 0
  br i1 %363, label %364, label %365

364:                                              ; preds = %361
  call fastcc void @sample(ptr noundef nonnull %67) #11, !noalias !8
  br label %365

365:                                              ; preds = %361, %364
  %366 = load ptr, ptr %67, align 8, !noalias !8
  %367 = load i64, ptr %366, align 8, !noalias !8
  %368 = load ptr, ptr %86, align 8, !noalias !8
  %369 = load ptr, ptr %88, align 8, !noalias !8
  %370 = load ptr, ptr %89, align 8, !noalias !8
  %371 = inttoptr i64 %367 to ptr
  %372 = load ptr, ptr %371, align 8, !noalias !8
  %373 = call i32 %372(ptr noundef %368, ptr noundef %349, ptr noundef %369, ptr noundef %370, ptr noundef %354) #12, !noalias !8
  %374 = zext i32 %373 to i64
  %375 = or i64 %329, %374
  br label %376

376:                                              ; preds = %365, %328
  %377 = phi i64 [ %375, %365 ], [ %329, %328 ]
  %378 = load ptr, ptr %0, align 8, !noalias !8
  %379 = getelementptr inbounds i8, ptr %378, i64 8
  %380 = load i64, ptr %379, align 8, !noalias !8
  %381 = icmp slt i64 %380, 1
  br i1 %381, label %382, label %386

382:                                              ; preds = %376
  %383 = icmp sgt i64 %265, 0
  br i1 %383, label %384, label %668

384:                                              ; preds = %382
  %385 = load ptr, ptr %80, align 8, !noalias !8
  br label %658

386:                                              ; preds = %376
  %387 = load ptr, ptr %19, align 8, !noalias !8
  %388 = load i64, ptr %21, align 8, !noalias !8
  %389 = getelementptr double, ptr %387, i64 %388
  %390 = getelementptr i8, ptr %389, i64 -16
  %391 = load double, ptr %390, align 8, !noalias !8
  %392 = load double, ptr %387, align 8, !noalias !8
  %393 = fsub double %391, %392
  %394 = fmul double %393, 0x3D70000000000000
  %395 = load ptr, ptr %67, align 8, !noalias !8
  %396 = load ptr, ptr %66, align 8, !noalias !8
  %397 = getelementptr inbounds i8, ptr %395, i64 24
  %398 = load i64, ptr %397, align 8, !noalias !8
  %399 = getelementptr inbounds i8, ptr %396, i64 8
  %400 = load i64, ptr %399, align 8, !noalias !8
  %401 = load ptr, ptr %90, align 8, !noalias !8
  %402 = load i64, ptr %91, align 8, !noalias !8
  %403 = getelementptr inbounds double, ptr %401, i64 %402
  %404 = icmp sgt i64 %400, 0
  br i1 %404, label %405, label %407

405:                                              ; preds = %386
  %406 = getelementptr inbounds i8, ptr %395, i64 32
  br label %415

407:                                              ; preds = %415, %386
  %408 = icmp sgt i64 %398, 0
  br i1 %408, label %409, label %477

409:                                              ; preds = %407
  %410 = load ptr, ptr %65, align 8, !noalias !8
  %411 = load ptr, ptr %80, align 8, !noalias !8
  %412 = load ptr, ptr %93, align 8, !noalias !8
  %413 = load ptr, ptr %94, align 8, !noalias !8
  %414 = load ptr, ptr %90, align 8, !noalias !8
  br label %441

415:                                              ; preds = %405, %415
  %416 = phi i64 [ 0, %405 ], [ %439, %415 ]
  %417 = load i64, ptr %396, align 8, !noalias !8
  %418 = load i64, ptr %406, align 8, !noalias !8
  %419 = load ptr, ptr %90, align 8, !noalias !8
  %420 = load i64, ptr %91, align 8, !noalias !8
  %421 = mul nsw i64 %420, %416
  %422 = getelementptr inbounds double, ptr %419, i64 %421
  %423 = load ptr, ptr %92, align 8, !noalias !8
  %424 = load ptr, ptr %81, align 8, !noalias !8
  %425 = getelementptr i64, ptr %424, i64 %417
  %426 = getelementptr i8, ptr %425, i64 8
  %427 = getelementptr i64, ptr %426, i64 %416
  %428 = load i64, ptr %427, align 8, !noalias !8
  %429 = getelementptr i8, ptr %427, i64 8
  %430 = load i64, ptr %429, align 8, !noalias !8
  %431 = xor i64 %428, -1
  %432 = add i64 %430, %431
  %433 = load ptr, ptr %68, align 8, !noalias !8
  %434 = load ptr, ptr %82, align 8, !noalias !8
  %435 = load ptr, ptr %83, align 8, !noalias !8
  %436 = getelementptr inbounds i64, ptr %435, i64 %428
  %437 = load ptr, ptr %84, align 8, !noalias !8
  %438 = getelementptr inbounds double, ptr %437, i64 %428
  call fastcc void @combine(ptr noundef %422, ptr noundef %423, ptr noundef %433, ptr noundef %434, ptr noundef %436, ptr noundef %438, i64 noundef %432, i64 noundef %418) #11
  %439 = add nuw nsw i64 %416, 1
  %440 = icmp eq i64 %439, %400
  br i1 %440, label %407, label %415, !llvm.loop !12

441:                                              ; preds = %409, %441
  %442 = phi <8 x double> [ zeroinitializer, %409 ], [ %472, %441 ]
  %443 = phi <8 x double> [ zeroinitializer, %409 ], [ %474, %441 ]
  %444 = phi i64 [ 0, %409 ], [ %475, %441 ]
  %445 = shl nsw i64 %444, 6
  %446 = getelementptr inbounds i8, ptr %410, i64 %445
  %447 = load <8 x double>, ptr %446, align 8, !noalias !8
  %448 = getelementptr inbounds i8, ptr %411, i64 %445
  %449 = load <8 x double>, ptr %448, align 8, !noalias !8
  %450 = getelementptr inbounds double, ptr %412, i64 %444
  %451 = load double, ptr %450, align 8, !noalias !8
  %452 = insertelement <8 x double> poison, double %451, i64 0
  %453 = shufflevector <8 x double> %452, <8 x double> poison, <8 x i32> zeroinitializer
  %454 = getelementptr inbounds double, ptr %413, i64 %444
  %455 = load double, ptr %454, align 8, !noalias !8
  %456 = insertelement <8 x double> poison, double %455, i64 0
  %457 = shufflevector <8 x double> %456, <8 x double> poison, <8 x i32> zeroinitializer
  %458 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %447)
  %459 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %449)
  %460 = fcmp ogt <8 x double> %458, %459
  %461 = select <8 x i1> %460, <8 x double> %458, <8 x double> %459
  %462 = fmul <8 x double> %461, %457
  %463 = fadd <8 x double> %453, %462
  %464 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %463
  %465 = getelementptr inbounds i8, ptr %414, i64 %445
  %466 = load <8 x double>, ptr %465, align 8, !noalias !8
  %467 = fmul <8 x double> %466, %464
  %468 = getelementptr inbounds i8, ptr %403, i64 %445
  %469 = load <8 x double>, ptr %468, align 8, !noalias !8
  %470 = fmul <8 x double> %469, %464
  %471 = fmul <8 x double> %467, %467
  %472 = fadd <8 x double> %442, %471
  %473 = fmul <8 x double> %470, %470
  %474 = fadd <8 x double> %443, %473
  %475 = add nuw nsw i64 %444, 1
  %476 = icmp eq i64 %475, %398
  br i1 %476, label %477, label %441, !llvm.loop !13

477:                                              ; preds = %441, %407
  %478 = phi <8 x double> [ zeroinitializer, %407 ], [ %474, %441 ]
  %479 = phi <8 x double> [ zeroinitializer, %407 ], [ %472, %441 ]
  %480 = load ptr, ptr %80, align 8, !noalias !8
  %481 = getelementptr inbounds i8, ptr %395, i64 8
  %482 = load i64, ptr %481, align 8, !noalias !8
  %483 = add nsw i64 %482, -3
  %484 = getelementptr i8, ptr %480, i64 64
  %485 = getelementptr i8, ptr %480, i64 128
  %486 = getelementptr i8, ptr %480, i64 192
  %487 = icmp slt i64 %398, %483
  br i1 %487, label %495, label %488

488:                                              ; preds = %495, %477
  %489 = phi <8 x double> [ zeroinitializer, %477 ], [ %505, %495 ]
  %490 = phi <8 x double> [ zeroinitializer, %477 ], [ %510, %495 ]
  %491 = phi <8 x double> [ zeroinitializer, %477 ], [ %515, %495 ]
  %492 = phi <8 x double> [ zeroinitializer, %477 ], [ %520, %495 ]
  %493 = phi i64 [ %398, %477 ], [ %521, %495 ]
  %494 = icmp slt i64 %493, %482
  br i1 %494, label %523, label %533

495:                                              ; preds = %477, %495
  %496 = phi i64 [ %521, %495 ], [ %398, %477 ]
  %497 = phi <8 x double> [ %520, %495 ], [ zeroinitializer, %477 ]
  %498 = phi <8 x double> [ %515, %495 ], [ zeroinitializer, %477 ]
  %499 = phi <8 x double> [ %510, %495 ], [ zeroinitializer, %477 ]
  %500 = phi <8 x double> [ %505, %495 ], [ zeroinitializer, %477 ]
  %501 = shl nsw i64 %496, 6
  %502 = getelementptr inbounds i8, ptr %480, i64 %501
  %503 = load <8 x double>, ptr %502, align 8, !noalias !8
  %504 = fmul <8 x double> %503, zeroinitializer
  %505 = fadd <8 x double> %500, %504
  %506 = shl i64 %496, 6
  %507 = getelementptr i8, ptr %484, i64 %506
  %508 = load <8 x double>, ptr %507, align 8, !noalias !8
  %509 = fmul <8 x double> %508, zeroinitializer
  %510 = fadd <8 x double> %499, %509
  %511 = shl i64 %496, 6
  %512 = getelementptr i8, ptr %485, i64 %511
  %513 = load <8 x double>, ptr %512, align 8, !noalias !8
  %514 = fmul <8 x double> %513, zeroinitializer
  %515 = fadd <8 x double> %498, %514
  %516 = shl i64 %496, 6
  %517 = getelementptr i8, ptr %486, i64 %516
  %518 = load <8 x double>, ptr %517, align 8, !noalias !8
  %519 = fmul <8 x double> %518, zeroinitializer
  %520 = fadd <8 x double> %497, %519
  %521 = add nsw i64 %496, 4
  %522 = icmp slt i64 %521, %483
  br i1 %522, label %495, label %488, !llvm.loop !14

523:                                              ; preds = %488, %523
  %524 = phi i64 [ %531, %523 ], [ %493, %488 ]
  %525 = phi <8 x double> [ %530, %523 ], [ %489, %488 ]
  %526 = shl nsw i64 %524, 6
  %527 = getelementptr inbounds i8, ptr %480, i64 %526
  %528 = load <8 x double>, ptr %527, align 8, !noalias !8
  %529 = fmul <8 x double> %528, zeroinitializer
  %530 = fadd <8 x double> %525, %529
  %531 = add nsw i64 %524, 1
  %532 = icmp eq i64 %531, %482
  br i1 %532, label %533, label %523, !llvm.loop !15

533:                                              ; preds = %523, %488
  %534 = phi <8 x double> [ %489, %488 ], [ %530, %523 ]
  %535 = fadd <8 x double> %490, %534
  %536 = fadd <8 x double> %491, %492
  %537 = fadd <8 x double> %536, %535
  %538 = fadd <8 x double> %479, %537
  %539 = icmp eq i64 %400, 2
  br i1 %539, label %540, label %551

540:                                              ; preds = %533
  %541 = fmul <8 x double> %478, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %542 = fadd <8 x double> %541, %538
  %543 = sitofp i64 %398 to double
  %544 = insertelement <8 x double> poison, double %543, i64 0
  %545 = shufflevector <8 x double> %544, <8 x double> poison, <8 x i32> zeroinitializer
  %546 = fmul <8 x double> %545, %542
  %547 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %546)
  %548 = fdiv <8 x double> %538, %547
  %549 = fcmp oeq <8 x double> %538, zeroinitializer
  %550 = select <8 x i1> %549, <8 x double> zeroinitializer, <8 x double> %548
  br label %557

551:                                              ; preds = %533
  %552 = sitofp i64 %398 to double
  %553 = insertelement <8 x double> poison, double %552, i64 0
  %554 = shufflevector <8 x double> %553, <8 x double> poison, <8 x i32> zeroinitializer
  %555 = fdiv <8 x double> %538, %554
  %556 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %555)
  br label %557

557:                                              ; preds = %540, %551
  %558 = phi <8 x double> [ %550, %540 ], [ %556, %551 ]
  %559 = load ptr, ptr %90, align 8, !noalias !8
  %560 = load ptr, ptr %68, align 8, !noalias !8
  %561 = load <8 x double>, ptr %560, align 8, !noalias !8
  %562 = load i64, ptr %397, align 8, !noalias !8
  %563 = getelementptr inbounds i8, ptr %395, i64 48
  %564 = load i64, ptr %563, align 8, !noalias !8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(512) %2, i8 0, i64 512, i1 false), !noalias !8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(512) %3, i8 0, i64 512, i1 false), !noalias !8
  %565 = icmp eq i64 %564, 0
  br i1 %565, label %656, label %566

566:                                              ; preds = %557
  br i1 %539, label %567, label %569

567:                                              ; preds = %566
  %568 = load i64, ptr %91, align 8, !noalias !8
  br label %569

569:                                              ; preds = %567, %566
  %570 = phi i64 [ %568, %567 ], [ 0, %566 ]
  %571 = getelementptr inbounds double, ptr %559, i64 %570
  %572 = icmp slt i64 %562, %564
  br i1 %572, label %574, label %573

573:                                              ; preds = %578, %569
  br label %643

574:                                              ; preds = %569
  %575 = load ptr, ptr %65, align 8, !noalias !8
  %576 = load ptr, ptr %95, align 8, !noalias !8
  %577 = load ptr, ptr %96, align 8, !noalias !8
  br label %578

578:                                              ; preds = %574, %578
  %579 = phi i64 [ %562, %574 ], [ %614, %578 ]
  %580 = shl nsw i64 %579, 6
  %581 = getelementptr inbounds i8, ptr %575, i64 %580
  %582 = load <8 x double>, ptr %581, align 8, !noalias !8
  %583 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %582)
  %584 = getelementptr inbounds i8, ptr %480, i64 %580
  %585 = load <8 x double>, ptr %584, align 8, !noalias !8
  %586 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %585)
  %587 = fcmp ogt <8 x double> %583, %586
  %588 = select <8 x i1> %587, <8 x double> %583, <8 x double> %586
  %589 = getelementptr inbounds i8, ptr %576, i64 %580
  %590 = load <8 x double>, ptr %589, align 8, !noalias !8
  %591 = getelementptr inbounds double, ptr %577, i64 %579
  %592 = load double, ptr %591, align 8, !noalias !8
  %593 = insertelement <8 x double> poison, double %592, i64 0
  %594 = shufflevector <8 x double> %593, <8 x double> poison, <8 x i32> zeroinitializer
  %595 = fmul <8 x double> %588, %594
  %596 = fadd <8 x double> %590, %595
  %597 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %596
  %598 = getelementptr inbounds i8, ptr %559, i64 %580
  %599 = load <8 x double>, ptr %598, align 8, !noalias !8
  %600 = fmul <8 x double> %599, %597
  %601 = getelementptr inbounds i8, ptr %571, i64 %580
  %602 = load <8 x double>, ptr %601, align 8, !noalias !8
  %603 = fmul <8 x double> %602, %597
  %604 = srem i64 %579, 8
  %605 = shl nsw i64 %604, 6
  %606 = getelementptr inbounds i8, ptr %2, i64 %605
  %607 = load <8 x double>, ptr %606, align 16, !noalias !8
  %608 = fmul <8 x double> %600, %600
  %609 = fadd <8 x double> %607, %608
  store <8 x double> %609, ptr %606, align 16, !noalias !8
  %610 = getelementptr inbounds i8, ptr %3, i64 %605
  %611 = load <8 x double>, ptr %610, align 16, !noalias !8
  %612 = fmul <8 x double> %603, %603
  %613 = fadd <8 x double> %611, %612
  store <8 x double> %613, ptr %610, align 16, !noalias !8
  %614 = add nsw i64 %579, 1
  %615 = icmp eq i64 %614, %564
  br i1 %615, label %573, label %578, !llvm.loop !16

616:                                              ; preds = %643
  %617 = sub nsw i64 %564, %562
  br i1 %539, label %618, label %629

618:                                              ; preds = %616
  %619 = fmul <8 x double> %653, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %620 = fadd <8 x double> %650, %619
  %621 = sitofp i64 %617 to double
  %622 = insertelement <8 x double> poison, double %621, i64 0
  %623 = shufflevector <8 x double> %622, <8 x double> poison, <8 x i32> zeroinitializer
  %624 = fmul <8 x double> %623, %620
  %625 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %624)
  %626 = fdiv <8 x double> %650, %625
  %627 = fcmp oeq <8 x double> %650, zeroinitializer
  %628 = select <8 x i1> %627, <8 x double> zeroinitializer, <8 x double> %626
  br label %635

629:                                              ; preds = %616
  %630 = sitofp i64 %617 to double
  %631 = insertelement <8 x double> poison, double %630, i64 0
  %632 = shufflevector <8 x double> %631, <8 x double> poison, <8 x i32> zeroinitializer
  %633 = fdiv <8 x double> %650, %632
  %634 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %633)
  br label %635

635:                                              ; preds = %629, %618
  %636 = phi <8 x double> [ %628, %618 ], [ %634, %629 ]
  %637 = insertelement <8 x double> poison, double %394, i64 0
  %638 = shufflevector <8 x double> %637, <8 x double> poison, <8 x i32> zeroinitializer
  %639 = fcmp ogt <8 x double> %561, %638
  %640 = fcmp ogt <8 x double> %636, %558
  %641 = select <8 x i1> %639, <8 x i1> %640, <8 x i1> zeroinitializer
  %642 = select <8 x i1> %641, <8 x double> %636, <8 x double> %558
  br label %656

643:                                              ; preds = %573, %643
  %644 = phi i64 [ %654, %643 ], [ 0, %573 ]
  %645 = phi <8 x double> [ %653, %643 ], [ zeroinitializer, %573 ]
  %646 = phi <8 x double> [ %650, %643 ], [ zeroinitializer, %573 ]
  %647 = shl nuw nsw i64 %644, 6
  %648 = getelementptr inbounds i8, ptr %2, i64 %647
  %649 = load <8 x double>, ptr %648, align 16, !noalias !8
  %650 = fadd <8 x double> %646, %649
  %651 = getelementptr inbounds i8, ptr %3, i64 %647
  %652 = load <8 x double>, ptr %651, align 16, !noalias !8
  %653 = fadd <8 x double> %645, %652
  %654 = add nuw nsw i64 %644, 1
  %655 = icmp eq i64 %654, 8
  br i1 %655, label %616, label %643, !llvm.loop !17

656:                                              ; preds = %557, %635
  %657 = phi <8 x double> [ %558, %557 ], [ %642, %635 ]
  br label %668

658:                                              ; preds = %384, %658
  %659 = phi i64 [ 0, %384 ], [ %666, %658 ]
  %660 = phi <8 x double> [ zeroinitializer, %384 ], [ %665, %658 ]
  %661 = shl nsw i64 %659, 6
  %662 = getelementptr inbounds i8, ptr %385, i64 %661
  %663 = load <8 x double>, ptr %662, align 8, !noalias !8
  %664 = fmul <8 x double> %663, zeroinitializer
  %665 = fadd <8 x double> %660, %664
  %666 = add nuw nsw i64 %659, 1
  %667 = icmp eq i64 %666, %265
  br i1 %667, label %668, label %658, !llvm.loop !18

668:                                              ; preds = %658, %382, %656
  %669 = phi <8 x double> [ %657, %656 ], [ zeroinitializer, %382 ], [ %665, %658 ]
  %670 = fcmp olt <8 x double> %669, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %671 = bitcast <8 x i1> %670 to i8
  %672 = zext i8 %671 to i64
  %673 = xor i64 %377, -1
  %674 = and i64 %673, %672
  %675 = and i64 %674, %204
  %676 = load ptr, ptr %97, align 8, !noalias !8
  %677 = load <8 x double>, ptr %676, align 8, !noalias !8
  %678 = load i64, ptr %262, align 8, !noalias !8
  %679 = sext i1 %268 to i64
  %680 = add i64 %678, %679
  %681 = sitofp i64 %680 to double
  %682 = insertelement <8 x double> poison, double %681, i64 0
  %683 = shufflevector <8 x double> %682, <8 x double> poison, <8 x i32> zeroinitializer
  %684 = fadd <8 x double> %677, %683
  store <8 x double> %684, ptr %676, align 8, !noalias !8
  %685 = icmp ne i64 %675, 0
  %686 = select i1 %49, i1 %685, i1 false
  br i1 %686, label %687, label %690

687:                                              ; preds = %668
  store <8 x double> %236, ptr %5, align 16
  %688 = load ptr, ptr %98, align 8
  %689 = call fastcc i64 @hold_lanes(ptr noundef nonnull %0, ptr noundef nonnull %5, ptr noundef %688, i64 noundef %675, i32 noundef %48) #11
  br label %690

690:                                              ; preds = %687, %668
  %691 = phi i64 [ %689, %687 ], [ 0, %668 ]
  %692 = xor i64 %691, -1
  %693 = and i64 %675, %692
  %694 = load ptr, ptr %66, align 8
  %695 = icmp eq i64 %693, 0
  br i1 %695, label %740, label %696

696:                                              ; preds = %690
  %697 = getelementptr inbounds i8, ptr %694, i64 32
  %698 = load i64, ptr %697, align 8
  %699 = icmp eq i64 %698, 1
  br i1 %699, label %700, label %704

700:                                              ; preds = %696
  %701 = load ptr, ptr %36, align 8
  %702 = load i64, ptr %701, align 8
  %703 = icmp eq i64 %702, 1
  br i1 %703, label %704, label %740

704:                                              ; preds = %700, %696
  %705 = load ptr, ptr %80, align 8
  %706 = load ptr, ptr %82, align 8
  %707 = load i64, ptr %694, align 8
  %708 = load i64, ptr %99, align 8
  %709 = mul nsw i64 %708, %707
  %710 = getelementptr inbounds double, ptr %706, i64 %709
  %711 = load ptr, ptr %100, align 8
  store <8 x double> %236, ptr %711, align 8
  %712 = load ptr, ptr %67, align 8
  %713 = getelementptr inbounds i8, ptr %712, i64 40
  %714 = load i64, ptr %713, align 8
  %715 = icmp eq i64 %714, 0
  br i1 %715, label %717, label %716

716:                                              ; preds = %704
  call fastcc void @settle(ptr noundef nonnull %67) #11
  br label %717

717:                                              ; preds = %716, %704
  %718 = load i64, ptr %101, align 8
  %719 = icmp sgt i64 %718, 0
  br i1 %719, label %720, label %721

720:                                              ; preds = %717
  call fastcc void @sample(ptr noundef nonnull %67) #11
  br label %721

721:                                              ; preds = %717, %720
  %722 = load ptr, ptr %67, align 8
  %723 = load i64, ptr %722, align 8
  %724 = load ptr, ptr %100, align 8
  %725 = load ptr, ptr %102, align 8
  %726 = load ptr, ptr %103, align 8
  %727 = inttoptr i64 %723 to ptr
  %728 = load ptr, ptr %727, align 8
  %729 = call i32 %728(ptr noundef %724, ptr noundef %705, ptr noundef %725, ptr noundef %726, ptr noundef %710) #12
  %730 = zext i32 %729 to i64
  %731 = or i64 %377, %730
  %732 = load ptr, ptr %97, align 8
  %733 = load <8 x double>, ptr %732, align 8
  %734 = trunc nuw i64 %693 to i8
  %735 = bitcast i8 %734 to <8 x i1>
  %736 = select <8 x i1> %735, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %737 = fadd <8 x double> %736, %733
  store <8 x double> %737, ptr %732, align 8
  %738 = xor i64 %731, -1
  %739 = and i64 %693, %738
  br label %740

740:                                              ; preds = %690, %700, %721
  %741 = phi i64 [ %377, %690 ], [ %731, %721 ], [ %377, %700 ]
  %742 = phi i64 [ %693, %690 ], [ %739, %721 ], [ %693, %700 ]
  %743 = icmp ne i64 %742, 0
  %744 = select i1 %50, i1 %743, i1 false
  br i1 %744, label %745, label %749

745:                                              ; preds = %740
  %746 = call fastcc i64 @clear_lanes(ptr noundef nonnull %0) #11
  %747 = xor i64 %746, -1
  %748 = and i64 %742, %747
  br label %749

749:                                              ; preds = %740, %745
  %750 = phi i64 [ %748, %745 ], [ 0, %740 ]
  store i64 0, ptr %10, align 8
  %751 = load ptr, ptr %104, align 8
  %752 = load <8 x double>, ptr %751, align 8
  %753 = fcmp olt <8 x double> %752, %236
  %754 = bitcast <8 x i1> %753 to i8
  %755 = zext i8 %754 to i64
  %756 = and i64 %742, %755
  %757 = or i64 %756, %750
  %758 = icmp eq i64 %757, 0
  br i1 %758, label %959, label %759

759:                                              ; preds = %749
  %760 = load ptr, ptr %97, align 8
  %761 = load <8 x double>, ptr %760, align 8
  %762 = trunc nuw i64 %757 to i8
  %763 = bitcast i8 %762 to <8 x i1>
  %764 = load ptr, ptr %66, align 8
  %765 = getelementptr inbounds i8, ptr %764, i64 16
  %766 = load i64, ptr %765, align 8
  %767 = sitofp i64 %766 to double
  %768 = insertelement <8 x double> poison, double %767, i64 0
  %769 = shufflevector <8 x double> %768, <8 x double> poison, <8 x i32> zeroinitializer
  %770 = select <8 x i1> %763, <8 x double> %769, <8 x double> zeroinitializer
  %771 = fadd <8 x double> %761, %770
  store <8 x double> %771, ptr %760, align 8
  %772 = load ptr, ptr %66, align 8
  %773 = load ptr, ptr %67, align 8
  %774 = getelementptr inbounds i8, ptr %773, i64 16
  %775 = load i64, ptr %774, align 8
  %776 = load i64, ptr %772, align 8
  %777 = load i64, ptr %105, align 8
  %778 = load ptr, ptr %82, align 8
  %779 = mul nsw i64 %777, %776
  %780 = getelementptr inbounds double, ptr %778, i64 %779
  %781 = load ptr, ptr %106, align 8
  %782 = add nsw i64 %776, 1
  %783 = getelementptr inbounds i8, ptr %772, i64 16
  %784 = load i64, ptr %783, align 8
  %785 = icmp sgt i64 %784, 0
  br i1 %785, label %786, label %788

786:                                              ; preds = %759
  %787 = getelementptr inbounds i8, ptr %772, i64 8
  br label %799

788:                                              ; preds = %840, %759
  %789 = phi i64 [ 0, %759 ], [ %850, %840 ]
  %790 = getelementptr inbounds i8, ptr %772, i64 16
  %791 = load ptr, ptr %67, align 8
  %792 = getelementptr inbounds i8, ptr %791, i64 8
  %793 = load i64, ptr %792, align 8
  %794 = icmp sgt i64 %793, 0
  br i1 %794, label %795, label %855

795:                                              ; preds = %788
  %796 = getelementptr inbounds double, ptr %781, i64 %777
  %797 = shl nsw i64 %777, 4
  %798 = getelementptr inbounds i8, ptr %781, i64 %797
  br label %862

799:                                              ; preds = %786, %840
  %800 = phi i64 [ 0, %786 ], [ %850, %840 ]
  %801 = phi i64 [ %782, %786 ], [ %851, %840 ]
  %802 = load i64, ptr %787, align 8
  %803 = load ptr, ptr %107, align 8
  %804 = load ptr, ptr %65, align 8
  %805 = load ptr, ptr %81, align 8
  %806 = getelementptr i64, ptr %805, i64 %801
  %807 = getelementptr i64, ptr %806, i64 %802
  %808 = load i64, ptr %807, align 8
  %809 = getelementptr i8, ptr %807, i64 8
  %810 = load i64, ptr %809, align 8
  %811 = xor i64 %808, -1
  %812 = add i64 %810, %811
  %813 = load ptr, ptr %68, align 8
  %814 = load ptr, ptr %82, align 8
  %815 = load ptr, ptr %83, align 8
  %816 = getelementptr inbounds i64, ptr %815, i64 %808
  %817 = load ptr, ptr %84, align 8
  %818 = getelementptr inbounds double, ptr %817, i64 %808
  call fastcc void @combine(ptr noundef %803, ptr noundef %804, ptr noundef %813, ptr noundef %814, ptr noundef %816, ptr noundef %818, i64 noundef %812, i64 noundef %775) #11
  %819 = load ptr, ptr %82, align 8
  %820 = mul nsw i64 %801, %777
  %821 = getelementptr inbounds double, ptr %819, i64 %820
  %822 = load ptr, ptr %108, align 8
  %823 = getelementptr inbounds double, ptr %822, i64 %801
  %824 = load double, ptr %823, align 8
  %825 = insertelement <8 x double> poison, double %824, i64 0
  %826 = shufflevector <8 x double> %825, <8 x double> poison, <8 x i32> zeroinitializer
  %827 = fmul <8 x double> %238, %826
  %828 = fadd <8 x double> %208, %827
  %829 = load ptr, ptr %107, align 8
  %830 = load ptr, ptr %109, align 8
  store <8 x double> %828, ptr %830, align 8
  %831 = load ptr, ptr %67, align 8
  %832 = getelementptr inbounds i8, ptr %831, i64 40
  %833 = load i64, ptr %832, align 8
  %834 = icmp eq i64 %833, 0
  br i1 %834, label %836, label %835

835:                                              ; preds = %799
  call fastcc void @settle(ptr noundef nonnull %67) #11
  br label %836

836:                                              ; preds = %835, %799
  %837 = load i64, ptr %110, align 8
  %838 = icmp sgt i64 %837, 0
  br i1 %838, label %839, label %840

839:                                              ; preds = %836
  call fastcc void @sample(ptr noundef nonnull %67) #11
  br label %840

840:                                              ; preds = %839, %836
  %841 = load ptr, ptr %67, align 8
  %842 = load i64, ptr %841, align 8
  %843 = load ptr, ptr %109, align 8
  %844 = load ptr, ptr %111, align 8
  %845 = load ptr, ptr %112, align 8
  %846 = inttoptr i64 %842 to ptr
  %847 = load ptr, ptr %846, align 8
  %848 = call i32 %847(ptr noundef %843, ptr noundef %829, ptr noundef %844, ptr noundef %845, ptr noundef %821) #12
  %849 = sext i32 %848 to i64
  %850 = or i64 %800, %849
  %851 = add nsw i64 %801, 1
  %852 = load i64, ptr %783, align 8
  %853 = add nsw i64 %852, %782
  %854 = icmp slt i64 %851, %853
  br i1 %854, label %799, label %788, !llvm.loop !19

855:                                              ; preds = %862, %788
  %856 = getelementptr inbounds i8, ptr %772, i64 8
  %857 = load i64, ptr %856, align 8
  %858 = load i64, ptr %790, align 8
  %859 = getelementptr inbounds i8, ptr %772, i64 24
  %860 = load i64, ptr %859, align 8
  %861 = icmp sgt i64 %860, 3
  br i1 %861, label %890, label %915

862:                                              ; preds = %795, %862
  %863 = phi i64 [ 0, %795 ], [ %885, %862 ]
  %864 = load ptr, ptr %80, align 8
  %865 = shl nsw i64 %863, 6
  %866 = getelementptr inbounds i8, ptr %864, i64 %865
  %867 = load <8 x double>, ptr %866, align 8
  %868 = load ptr, ptr %65, align 8
  %869 = getelementptr inbounds i8, ptr %868, i64 %865
  %870 = load <8 x double>, ptr %869, align 8
  %871 = fsub <8 x double> %867, %870
  %872 = load ptr, ptr %82, align 8
  %873 = getelementptr inbounds i8, ptr %872, i64 %865
  %874 = load <8 x double>, ptr %873, align 8
  %875 = fmul <8 x double> %238, %874
  %876 = fsub <8 x double> %875, %871
  %877 = getelementptr inbounds i8, ptr %781, i64 %865
  store <8 x double> %871, ptr %877, align 8
  %878 = getelementptr inbounds i8, ptr %796, i64 %865
  store <8 x double> %876, ptr %878, align 8
  %879 = fsub <8 x double> %871, %876
  %880 = getelementptr inbounds i8, ptr %780, i64 %865
  %881 = load <8 x double>, ptr %880, align 8
  %882 = fmul <8 x double> %238, %881
  %883 = fsub <8 x double> %879, %882
  %884 = getelementptr inbounds i8, ptr %798, i64 %865
  store <8 x double> %883, ptr %884, align 8
  %885 = add nuw nsw i64 %863, 1
  %886 = load ptr, ptr %67, align 8
  %887 = getelementptr inbounds i8, ptr %886, i64 8
  %888 = load i64, ptr %887, align 8
  %889 = icmp slt i64 %885, %888
  br i1 %889, label %862, label %855, !llvm.loop !20

890:                                              ; preds = %855, %890
  %891 = phi i64 [ %912, %890 ], [ 3, %855 ]
  %892 = mul nsw i64 %891, %777
  %893 = getelementptr inbounds double, ptr %781, i64 %892
  %894 = load ptr, ptr %113, align 8
  %895 = load ptr, ptr %81, align 8
  %896 = getelementptr i64, ptr %895, i64 %782
  %897 = getelementptr i64, ptr %896, i64 %857
  %898 = getelementptr i64, ptr %897, i64 %858
  %899 = getelementptr i64, ptr %898, i64 %891
  %900 = getelementptr i8, ptr %899, i64 -24
  %901 = load i64, ptr %900, align 8
  %902 = getelementptr i8, ptr %899, i64 -16
  %903 = load i64, ptr %902, align 8
  %904 = xor i64 %901, -1
  %905 = add i64 %903, %904
  %906 = load ptr, ptr %68, align 8
  %907 = load ptr, ptr %82, align 8
  %908 = load ptr, ptr %83, align 8
  %909 = getelementptr inbounds i64, ptr %908, i64 %901
  %910 = load ptr, ptr %84, align 8
  %911 = getelementptr inbounds double, ptr %910, i64 %901
  call fastcc void @combine(ptr noundef %893, ptr noundef %894, ptr noundef %906, ptr noundef %907, ptr noundef %909, ptr noundef %911, i64 noundef %905, i64 noundef %775) #11
  %912 = add nuw nsw i64 %891, 1
  %913 = load i64, ptr %859, align 8
  %914 = icmp slt i64 %912, %913
  br i1 %914, label %890, label %915, !llvm.loop !21

915:                                              ; preds = %890, %855
  %916 = and i64 %789, %757
  %917 = icmp eq i64 %916, 0
  br i1 %917, label %922, label %918

918:                                              ; preds = %915
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %916, i64 noundef 3) #11
  %919 = xor i64 %916, -1
  %920 = and i64 %204, %919
  store i64 %920, ptr %8, align 8
  %921 = and i64 %750, %919
  br label %922

922:                                              ; preds = %918, %915
  %923 = phi i32 [ 1, %918 ], [ %175, %915 ]
  %924 = phi i64 [ %921, %918 ], [ %750, %915 ]
  store <8 x double> %236, ptr %5, align 16
  %925 = icmp eq i64 %924, 0
  br i1 %925, label %928, label %926

926:                                              ; preds = %922
  %927 = call fastcc i64 @look_for_events(ptr noundef nonnull %0, ptr noundef nonnull %4, i64 noundef %924, ptr noundef nonnull %5, ptr noundef nonnull %7, ptr noundef nonnull %9, ptr noundef nonnull %6, ptr noundef nonnull %10) #11
  br label %928

928:                                              ; preds = %926, %922
  %929 = phi i64 [ %927, %926 ], [ 0, %922 ]
  %930 = load i64, ptr %10, align 8
  %931 = or i64 %930, %916
  %932 = xor i64 %931, -1
  %933 = and i64 %757, %932
  %934 = icmp eq i64 %929, 0
  %935 = select i1 %934, ptr null, ptr %6
  %936 = call fastcc i64 @write_within(ptr noundef nonnull %0, ptr noundef nonnull %4, i64 noundef %933, ptr noundef nonnull %5, ptr noundef %935) #11
  %937 = load <8 x double>, ptr %5, align 16
  br i1 %934, label %943, label %938

938:                                              ; preds = %928
  %939 = xor i64 %936, -1
  %940 = and i64 %929, %939
  %941 = call fastcc i64 @end_within(ptr noundef nonnull %0, ptr noundef nonnull %4, i64 noundef %940, ptr noundef nonnull %5, ptr noundef nonnull %6) #11
  %942 = or i64 %941, %936
  br label %943

943:                                              ; preds = %938, %928
  %944 = phi i64 [ %942, %938 ], [ %936, %928 ]
  %945 = icmp ne i64 %944, 0
  %946 = select i1 %50, i1 %945, i1 false
  br i1 %946, label %947, label %952

947:                                              ; preds = %943
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %944, i64 noundef 6) #11
  %948 = xor i64 %944, -1
  %949 = load i64, ptr %8, align 8
  %950 = and i64 %949, %948
  store i64 %950, ptr %8, align 8
  %951 = and i64 %929, %948
  br label %952

952:                                              ; preds = %947, %943
  %953 = phi i32 [ 1, %947 ], [ %923, %943 ]
  %954 = phi i64 [ %951, %947 ], [ %929, %943 ]
  %955 = or i64 %944, %691
  %956 = or i64 %944, %931
  %957 = xor i64 %956, -1
  %958 = and i64 %742, %957
  br label %959

959:                                              ; preds = %952, %749
  %960 = phi <8 x double> [ %236, %749 ], [ %937, %952 ]
  %961 = phi i64 [ 0, %749 ], [ %930, %952 ]
  %962 = phi i64 [ %691, %749 ], [ %955, %952 ]
  %963 = phi i32 [ %175, %749 ], [ %953, %952 ]
  %964 = phi i64 [ %742, %749 ], [ %958, %952 ]
  %965 = phi i64 [ 0, %749 ], [ %954, %952 ]
  %966 = load ptr, ptr %104, align 8
  %967 = load <8 x double>, ptr %966, align 8
  %968 = fcmp oeq <8 x double> %967, %960
  %969 = bitcast <8 x i1> %968 to i8
  %970 = zext i8 %969 to i64
  %971 = and i64 %964, %970
  %972 = icmp eq i64 %971, 0
  br i1 %972, label %973, label %1225

973:                                              ; preds = %1225, %959
  %974 = trunc nuw i64 %964 to i8
  %975 = bitcast i8 %974 to <8 x i1>
  %976 = load ptr, ptr %61, align 8
  %977 = load <8 x double>, ptr %976, align 8
  %978 = select <8 x i1> %975, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %979 = fadd <8 x double> %978, %977
  store <8 x double> %979, ptr %976, align 8
  %980 = load ptr, ptr %62, align 8
  %981 = load <8 x double>, ptr %980, align 8
  %982 = xor <8 x i1> %975, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %983 = and <8 x i1> %206, %982
  %984 = select <8 x i1> %983, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %985 = fadd <8 x double> %984, %981
  store <8 x double> %985, ptr %980, align 8
  %986 = load ptr, ptr %115, align 8
  %987 = load ptr, ptr %0, align 8
  %988 = getelementptr inbounds i8, ptr %987, i64 8
  %989 = load i64, ptr %988, align 8
  %990 = icmp slt i64 %989, 1
  %991 = xor i64 %964, -1
  %992 = and i64 %204, %991
  %993 = trunc i64 %992 to i8
  %994 = bitcast i8 %993 to <8 x i1>
  %995 = load ptr, ptr %116, align 8
  %996 = load <8 x double>, ptr %995, align 8
  br i1 %990, label %1128, label %997

997:                                              ; preds = %973
  %998 = load ptr, ptr %117, align 8
  %999 = load <8 x double>, ptr %998, align 8
  %1000 = load ptr, ptr %118, align 8
  %1001 = load <8 x double>, ptr %1000, align 8
  %1002 = fcmp ogt <8 x double> %669, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1003 = bitcast <8 x double> %669 to <8 x i64>
  %1004 = select <8 x i1> %1002, <8 x i64> %1003, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %1005 = getelementptr inbounds i8, ptr %986, i64 24
  %1006 = load double, ptr %1005, align 8
  %1007 = insertelement <8 x double> poison, double %1006, i64 0
  %1008 = shufflevector <8 x double> %1007, <8 x double> poison, <8 x i32> zeroinitializer
  %1009 = getelementptr inbounds i8, ptr %986, i64 8
  %1010 = load double, ptr %1009, align 8
  %1011 = fneg double %1010
  %1012 = add <8 x i64> %1004, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %1013 = ashr <8 x i64> %1012, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1014 = and <8 x i64> %1012, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %1015 = sub <8 x i64> %1004, %1014
  %1016 = bitcast <8 x i64> %1015 to <8 x double>
  %1017 = fadd <8 x double> %1016, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %1018 = fadd <8 x double> %1016, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1019 = fdiv <8 x double> %1017, %1018
  %1020 = fmul <8 x double> %1019, %1019
  %1021 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1020, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %1022 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1021, <8 x double> %1020, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %1023 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1022, <8 x double> %1020, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %1024 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1023, <8 x double> %1020, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %1025 = trunc nsw <8 x i64> %1013 to <8 x i32>
  %1026 = sitofp <8 x i32> %1025 to <8 x double>
  %1027 = fmul <8 x double> %1019, %1024
  %1028 = fadd <8 x double> %1027, %1026
  %1029 = insertelement <8 x double> poison, double %1011, i64 0
  %1030 = shufflevector <8 x double> %1029, <8 x double> poison, <8 x i32> zeroinitializer
  %1031 = fmul <8 x double> %1028, %1030
  %1032 = fcmp ogt <8 x double> %1031, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1033 = bitcast <8 x double> %1031 to <8 x i64>
  %1034 = select <8 x i1> %1032, <8 x i64> %1033, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1035 = bitcast <8 x i64> %1034 to <8 x double>
  %1036 = fcmp olt <8 x double> %1035, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1037 = bitcast <8 x i64> %1034 to <8 x double>
  %1038 = select <8 x i1> %1036, <8 x double> %1037, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1039 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1038)
  %1040 = fsub <8 x double> %1038, %1039
  %1041 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1040, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1042 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1041, <8 x double> %1040, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1043 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1042, <8 x double> %1040, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1044 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1043, <8 x double> %1040, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1045 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1044, <8 x double> %1040, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1046 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1045, <8 x double> %1040, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1047 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1046, <8 x double> %1040, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1048 = bitcast <8 x double> %1047 to <8 x i64>
  %1049 = fptosi <8 x double> %1039 to <8 x i32>
  %1050 = zext <8 x i32> %1049 to <8 x i64>
  %1051 = shl <8 x i64> %1050, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1052 = add <8 x i64> %1051, %1048
  %1053 = bitcast <8 x i64> %1052 to <8 x double>
  %1054 = fmul <8 x double> %1008, %1053
  %1055 = getelementptr inbounds i8, ptr %986, i64 16
  %1056 = load double, ptr %1055, align 8
  %1057 = fcmp une double %1056, 0.000000e+00
  br i1 %1057, label %1058, label %1103

1058:                                             ; preds = %997
  %1059 = bitcast <8 x double> %999 to <8 x i64>
  %1060 = add <8 x i64> %1059, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %1061 = ashr <8 x i64> %1060, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1062 = and <8 x i64> %1060, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %1063 = sub <8 x i64> %1059, %1062
  %1064 = bitcast <8 x i64> %1063 to <8 x double>
  %1065 = fadd <8 x double> %1064, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %1066 = fadd <8 x double> %1064, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1067 = fdiv <8 x double> %1065, %1066
  %1068 = fmul <8 x double> %1067, %1067
  %1069 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1068, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %1070 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1069, <8 x double> %1068, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %1071 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1070, <8 x double> %1068, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %1072 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1071, <8 x double> %1068, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %1073 = trunc nsw <8 x i64> %1061 to <8 x i32>
  %1074 = sitofp <8 x i32> %1073 to <8 x double>
  %1075 = fmul <8 x double> %1067, %1072
  %1076 = fadd <8 x double> %1075, %1074
  %1077 = insertelement <8 x double> poison, double %1056, i64 0
  %1078 = shufflevector <8 x double> %1077, <8 x double> poison, <8 x i32> zeroinitializer
  %1079 = fmul <8 x double> %1078, %1076
  %1080 = fcmp ogt <8 x double> %1079, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1081 = bitcast <8 x double> %1079 to <8 x i64>
  %1082 = select <8 x i1> %1080, <8 x i64> %1081, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1083 = bitcast <8 x i64> %1082 to <8 x double>
  %1084 = fcmp olt <8 x double> %1083, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1085 = bitcast <8 x i64> %1082 to <8 x double>
  %1086 = select <8 x i1> %1084, <8 x double> %1085, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1087 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1086)
  %1088 = fsub <8 x double> %1086, %1087
  %1089 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1088, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1090 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1089, <8 x double> %1088, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1091 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1090, <8 x double> %1088, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1092 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1091, <8 x double> %1088, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1093 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1092, <8 x double> %1088, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1094 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1093, <8 x double> %1088, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1095 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1094, <8 x double> %1088, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1096 = bitcast <8 x double> %1095 to <8 x i64>
  %1097 = fptosi <8 x double> %1087 to <8 x i32>
  %1098 = zext <8 x i32> %1097 to <8 x i64>
  %1099 = shl <8 x i64> %1098, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1100 = add <8 x i64> %1099, %1096
  %1101 = bitcast <8 x i64> %1100 to <8 x double>
  %1102 = fmul <8 x double> %1054, %1101
  br label %1103

1103:                                             ; preds = %997, %1058
  %1104 = phi <8 x double> [ %1102, %1058 ], [ %1054, %997 ]
  %1105 = getelementptr inbounds i8, ptr %986, i64 32
  %1106 = load double, ptr %1105, align 8
  %1107 = insertelement <8 x double> poison, double %1106, i64 0
  %1108 = shufflevector <8 x double> %1107, <8 x double> poison, <8 x i32> zeroinitializer
  %1109 = fcmp ogt <8 x double> %1104, %1108
  %1110 = select <8 x i1> %1109, <8 x double> %1104, <8 x double> %1108
  %1111 = fcmp olt <8 x double> %1001, %1110
  %1112 = select <8 x i1> %1111, <8 x double> %1001, <8 x double> %1110
  %1113 = fmul <8 x double> %238, %1112
  %1114 = fcmp oeq <8 x double> %960, %216
  %1115 = fcmp ogt <8 x double> %996, %1113
  %1116 = select <8 x i1> %1114, <8 x i1> %1115, <8 x i1> zeroinitializer
  %1117 = select <8 x i1> %1116, <8 x double> %996, <8 x double> %1113
  %1118 = fcmp ogt <8 x double> %669, <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>
  %1119 = select <8 x i1> %1118, <8 x i64> %1003, <8 x i64> <i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789>
  %1120 = bitcast <8 x double> %999 to <8 x i64>
  %1121 = select <8 x i1> %975, <8 x i64> %1119, <8 x i64> %1120
  store <8 x i64> %1121, ptr %998, align 8
  %1122 = load ptr, ptr %118, align 8
  %1123 = getelementptr inbounds i8, ptr %986, i64 40
  %1124 = load double, ptr %1123, align 8
  %1125 = insertelement <8 x double> poison, double %1124, i64 0
  %1126 = shufflevector <8 x double> %1125, <8 x double> poison, <8 x i32> zeroinitializer
  %1127 = select <8 x i1> %994, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> %1126
  store <8 x double> %1127, ptr %1122, align 8
  br label %1128

1128:                                             ; preds = %1103, %973
  %1129 = phi <8 x double> [ %996, %973 ], [ %1117, %1103 ]
  %1130 = and i64 %992, 255
  %1131 = icmp eq i64 %1130, 0
  br i1 %1131, label %1220, label %1132

1132:                                             ; preds = %1128
  %1133 = trunc i64 %741 to i8
  %1134 = bitcast i8 %1133 to <8 x i1>
  %1135 = trunc i64 %962 to i8
  %1136 = bitcast i8 %1135 to <8 x i1>
  %1137 = trunc i64 %961 to i8
  %1138 = bitcast i8 %1137 to <8 x i1>
  %1139 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %669)
  %1140 = fcmp one <8 x double> %1139, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1141 = xor <8 x i1> %1134, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1142 = select <8 x i1> %1140, <8 x i1> %1141, <8 x i1> zeroinitializer
  %1143 = or <8 x i1> %1136, %1138
  %1144 = xor <8 x i1> %1143, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1145 = and <8 x i1> %1142, %1144
  br i1 %990, label %1207, label %1146

1146:                                             ; preds = %1132
  %1147 = fcmp ogt <8 x double> %669, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1148 = bitcast <8 x double> %669 to <8 x i64>
  %1149 = select <8 x i1> %1147, <8 x i64> %1148, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %1150 = getelementptr inbounds i8, ptr %986, i64 24
  %1151 = load double, ptr %1150, align 8
  %1152 = insertelement <8 x double> poison, double %1151, i64 0
  %1153 = shufflevector <8 x double> %1152, <8 x double> poison, <8 x i32> zeroinitializer
  %1154 = load double, ptr %986, align 8
  %1155 = fneg double %1154
  %1156 = add <8 x i64> %1149, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %1157 = ashr <8 x i64> %1156, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1158 = and <8 x i64> %1156, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %1159 = sub <8 x i64> %1149, %1158
  %1160 = bitcast <8 x i64> %1159 to <8 x double>
  %1161 = fadd <8 x double> %1160, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %1162 = fadd <8 x double> %1160, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1163 = fdiv <8 x double> %1161, %1162
  %1164 = fmul <8 x double> %1163, %1163
  %1165 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1164, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %1166 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1165, <8 x double> %1164, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %1167 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1166, <8 x double> %1164, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %1168 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1167, <8 x double> %1164, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %1169 = trunc nsw <8 x i64> %1157 to <8 x i32>
  %1170 = sitofp <8 x i32> %1169 to <8 x double>
  %1171 = fmul <8 x double> %1163, %1168
  %1172 = fadd <8 x double> %1171, %1170
  %1173 = insertelement <8 x double> poison, double %1155, i64 0
  %1174 = shufflevector <8 x double> %1173, <8 x double> poison, <8 x i32> zeroinitializer
  %1175 = fmul <8 x double> %1172, %1174
  %1176 = fcmp ogt <8 x double> %1175, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1177 = bitcast <8 x double> %1175 to <8 x i64>
  %1178 = select <8 x i1> %1176, <8 x i64> %1177, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1179 = bitcast <8 x i64> %1178 to <8 x double>
  %1180 = fcmp olt <8 x double> %1179, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1181 = bitcast <8 x i64> %1178 to <8 x double>
  %1182 = select <8 x i1> %1180, <8 x double> %1181, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1183 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1182)
  %1184 = fsub <8 x double> %1182, %1183
  %1185 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1184, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1186 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1185, <8 x double> %1184, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1187 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1186, <8 x double> %1184, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1188 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1187, <8 x double> %1184, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1189 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1188, <8 x double> %1184, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1190 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1189, <8 x double> %1184, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1191 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1190, <8 x double> %1184, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1192 = bitcast <8 x double> %1191 to <8 x i64>
  %1193 = fptosi <8 x double> %1183 to <8 x i32>
  %1194 = zext <8 x i32> %1193 to <8 x i64>
  %1195 = shl <8 x i64> %1194, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1196 = add <8 x i64> %1195, %1192
  %1197 = bitcast <8 x i64> %1196 to <8 x double>
  %1198 = fmul <8 x double> %1153, %1197
  %1199 = getelementptr inbounds i8, ptr %986, i64 32
  %1200 = load double, ptr %1199, align 8
  %1201 = insertelement <8 x double> poison, double %1200, i64 0
  %1202 = shufflevector <8 x double> %1201, <8 x double> poison, <8 x i32> zeroinitializer
  %1203 = fcmp ogt <8 x double> %1198, %1202
  %1204 = select <8 x i1> %1203, <8 x double> %1198, <8 x double> %1202
  %1205 = select <8 x i1> %1145, <8 x double> %1204, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1206 = fmul <8 x double> %238, %1205
  br label %1207

1207:                                             ; preds = %1146, %1132
  %1208 = phi <8 x double> [ zeroinitializer, %1132 ], [ %1206, %1146 ]
  %1209 = or <8 x i1> %1145, %1138
  %1210 = select <8 x i1> %1209, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %1211 = select <8 x i1> %994, <8 x double> %1208, <8 x double> %1129
  %1212 = load ptr, ptr %119, align 8
  %1213 = select <8 x i1> %1136, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> %1210
  %1214 = load <8 x i64>, ptr %1212, align 8
  %1215 = select <8 x i1> %994, <8 x i64> %1213, <8 x i64> %1214
  store <8 x i64> %1215, ptr %1212, align 8
  %1216 = load ptr, ptr %119, align 8
  %1217 = select <8 x i1> %1134, <8 x i64> <i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152>, <8 x i64> %1210
  %1218 = load <8 x i64>, ptr %1216, align 8
  %1219 = select <8 x i1> %994, <8 x i64> %1217, <8 x i64> %1218
  store <8 x i64> %1219, ptr %1216, align 8
  br label %1220

1220:                                             ; preds = %1128, %1207
  %1221 = phi <8 x double> [ %1129, %1128 ], [ %1211, %1207 ]
  %1222 = load ptr, ptr %116, align 8
  store <8 x double> %1221, ptr %1222, align 8
  %1223 = load ptr, ptr %46, align 8
  %1224 = select <8 x i1> %975, <8 x double> %960, <8 x double> %208
  store <8 x double> %1224, ptr %1223, align 8
  br i1 %120, label %1242, label %1235

1225:                                             ; preds = %959, %1225
  %1226 = phi i64 [ %1233, %1225 ], [ %971, %959 ]
  %1227 = load ptr, ptr %114, align 8
  call fastcc void @write_outputs(ptr noundef nonnull %0, ptr noundef %1227, i64 noundef %1226) #11
  %1228 = load ptr, ptr %104, align 8
  %1229 = load <8 x double>, ptr %1228, align 8
  %1230 = fcmp oeq <8 x double> %1229, %960
  %1231 = bitcast <8 x i1> %1230 to i8
  %1232 = zext i8 %1231 to i64
  %1233 = and i64 %1226, %1232
  %1234 = icmp eq i64 %1233, 0
  br i1 %1234, label %973, label %1225, !llvm.loop !22

1235:                                             ; preds = %1242, %1220
  %1236 = load ptr, ptr %122, align 8
  %1237 = load ptr, ptr %66, align 8
  %1238 = load i64, ptr %1237, align 8
  %1239 = load i64, ptr %123, align 8
  %1240 = mul nsw i64 %1239, %1238
  %1241 = getelementptr inbounds double, ptr %1236, i64 %1240
  br i1 %124, label %1256, label %1254

1242:                                             ; preds = %1220, %1242
  %1243 = phi i64 [ %1252, %1242 ], [ 0, %1220 ]
  %1244 = load ptr, ptr %14, align 8
  %1245 = load ptr, ptr %121, align 8
  %1246 = shl nsw i64 %1243, 6
  %1247 = getelementptr inbounds i8, ptr %1245, i64 %1246
  %1248 = load <8 x i64>, ptr %1247, align 8
  %1249 = getelementptr inbounds i8, ptr %1244, i64 %1246
  %1250 = load <8 x i64>, ptr %1249, align 8
  %1251 = select <8 x i1> %975, <8 x i64> %1248, <8 x i64> %1250
  store <8 x i64> %1251, ptr %1249, align 8
  %1252 = add nuw nsw i64 %1243, 1
  %1253 = icmp eq i64 %1252, %18
  br i1 %1253, label %1235, label %1242, !llvm.loop !23

1254:                                             ; preds = %1256, %1235
  %1255 = icmp eq i64 %965, 0
  br i1 %1255, label %1277, label %1267

1256:                                             ; preds = %1235, %1256
  %1257 = phi i64 [ %1265, %1256 ], [ 0, %1235 ]
  %1258 = load ptr, ptr %122, align 8
  %1259 = shl nsw i64 %1257, 6
  %1260 = getelementptr inbounds i8, ptr %1241, i64 %1259
  %1261 = load <8 x i64>, ptr %1260, align 8
  %1262 = getelementptr inbounds i8, ptr %1258, i64 %1259
  %1263 = load <8 x i64>, ptr %1262, align 8
  %1264 = select <8 x i1> %975, <8 x i64> %1261, <8 x i64> %1263
  store <8 x i64> %1264, ptr %1262, align 8
  %1265 = add nuw nsw i64 %1257, 1
  %1266 = icmp eq i64 %1265, %18
  br i1 %1266, label %1254, label %1256, !llvm.loop !24

1267:                                             ; preds = %1254
  %1268 = call fastcc i64 @act_in_lanes(ptr noundef nonnull %0, i64 noundef %965, ptr noundef nonnull %9) #11
  %1269 = icmp ne i32 %963, 0
  %1270 = icmp ne i64 %1268, %965
  %1271 = select i1 %1269, i1 true, i1 %1270
  %1272 = zext i1 %1271 to i32
  %1273 = trunc i64 %965 to i8
  %1274 = bitcast i8 %1273 to <8 x i1>
  %1275 = xor <8 x i1> %1274, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1276 = and <8 x i1> %1275, %975
  br label %1277

1277:                                             ; preds = %1267, %1254
  %1278 = phi i32 [ %1272, %1267 ], [ %963, %1254 ]
  %1279 = phi <8 x i1> [ %1276, %1267 ], [ %975, %1254 ]
  %1280 = phi i64 [ %1268, %1267 ], [ %176, %1254 ]
  %1281 = load ptr, ptr %104, align 8
  %1282 = load <8 x double>, ptr %1281, align 8
  %1283 = fcmp oeq <8 x double> %1282, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1284 = select <8 x i1> %1283, <8 x i1> %1279, <8 x i1> zeroinitializer
  %1285 = bitcast <8 x i1> %1284 to i8
  %1286 = zext i8 %1285 to i64
  %1287 = icmp eq i8 %1285, 0
  br i1 %1287, label %1289, label %1288

1288:                                             ; preds = %1277
  call fastcc void @retire(ptr noundef nonnull %0, i64 noundef %1286, i64 noundef 0) #11
  br label %1289

1289:                                             ; preds = %1288, %1277
  %1290 = phi i32 [ 1, %1288 ], [ %1278, %1277 ]
  %1291 = fcmp oeq <8 x double> %960, %214
  %1292 = select <8 x i1> %1291, <8 x i1> %1279, <8 x i1> zeroinitializer
  %1293 = bitcast <8 x i1> %1292 to i8
  %1294 = zext i8 %1293 to i64
  %1295 = xor i64 %1286, -1
  %1296 = and i64 %1295, %1294
  %1297 = icmp eq i64 %1296, 0
  br i1 %1297, label %1302, label %1298

1298:                                             ; preds = %1289
  %1299 = call fastcc i64 @start_again(ptr noundef nonnull %0, ptr noundef nonnull %4, i64 noundef %1296) #11
  %1300 = icmp eq i64 %1299, 0
  %1301 = select i1 %1300, i32 %1290, i32 1
  br label %1302

1302:                                             ; preds = %1298, %1289
  %1303 = phi i32 [ %1290, %1289 ], [ %1301, %1298 ]
  br label %171

1304:                                             ; preds = %174, %199, %167
  %1305 = phi i64 [ 1, %167 ], [ 0, %199 ], [ 0, %174 ]
  ret i64 %1305
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
  br i1 %77, label %83, label %78, !llvm.loop !25

78:                                               ; preds = %51, %70
  %79 = phi i64 [ %80, %70 ], [ %48, %51 ]
  %80 = add nsw i64 %79, 1
  store i64 %80, ptr %7, align 8
  %81 = load i64, ptr %9, align 8
  %82 = icmp sge i64 %80, %81
  br i1 %82, label %83, label %70, !llvm.loop !25

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
  br i1 %110, label %102, label %111, !llvm.loop !26

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
  br i1 %127, label %119, label %128, !llvm.loop !26

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
  br i1 %144, label %136, label %145, !llvm.loop !26

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
  br i1 %166, label %158, label %167, !llvm.loop !26

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
  br i1 %188, label %180, label %189, !llvm.loop !26

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
  br i1 %216, label %204, label %201, !llvm.loop !28

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
  tail call void %233(ptr noundef %237, ptr noundef %241) #12
  %242 = add nuw nsw i64 %226, 1
  %243 = load i64, ptr %32, align 8
  %244 = icmp slt i64 %242, %243
  br i1 %244, label %225, label %217, !llvm.loop !29

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
  br i1 %272, label %245, label %290, !llvm.loop !30

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
  br i1 %289, label %259, label %273, !llvm.loop !31

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
  br i1 %312, label %59, label %43, !llvm.loop !32

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
  tail call void %327(ptr noundef %328, ptr noundef %332) #12
  %333 = add nuw nsw i64 %321, 1
  %334 = load i64, ptr %314, align 8
  %335 = icmp slt i64 %333, %334
  br i1 %335, label %320, label %434, !llvm.loop !33

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
  br i1 %356, label %357, label %348, !llvm.loop !34

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
  br i1 %371, label %372, label %363, !llvm.loop !34

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
  br i1 %386, label %387, label %378, !llvm.loop !34

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
  br i1 %401, label %402, label %393, !llvm.loop !34

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
  br i1 %419, label %420, label %411, !llvm.loop !34

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
  br i1 %433, label %313, label %336, !llvm.loop !35

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
  call fastcc void @hold_all(ptr noundef %0, ptr noundef nonnull %8) #11
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
  tail call fastcc void @settle(ptr noundef nonnull %21) #11
  br label %32

32:                                               ; preds = %31, %4
  %33 = getelementptr inbounds i8, ptr %21, i64 152
  %34 = load i64, ptr %33, align 8
  %35 = icmp sgt i64 %34, 0
  br i1 %35, label %36, label %37

36:                                               ; preds = %32
  tail call fastcc void @sample(ptr noundef nonnull %21) #11
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
  %47 = tail call i32 %46(ptr noundef %40, ptr noundef %22, ptr noundef %42, ptr noundef %44, ptr noundef %24) #12
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
  br i1 %77, label %62, label %56, !llvm.loop !36

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
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %121, ptr noundef %121, ptr noundef nonnull %116, i64 noundef %120) #11
  %122 = load <8 x double>, ptr %5, align 16
  %123 = getelementptr inbounds i8, ptr %116, i64 168
  %124 = load ptr, ptr %123, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %124, ptr noundef %121, ptr noundef nonnull %116, i64 noundef %120) #11
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
  tail call fastcc void @settle(ptr noundef nonnull %148) #11
  br label %163

163:                                              ; preds = %162, %147
  %164 = getelementptr inbounds i8, ptr %148, i64 152
  %165 = load i64, ptr %164, align 8
  %166 = icmp sgt i64 %165, 0
  br i1 %166, label %167, label %187

167:                                              ; preds = %163
  tail call fastcc void @sample(ptr noundef nonnull %148) #11
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
  br i1 %186, label %168, label %147, !llvm.loop !37

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
  %197 = tail call i32 %196(ptr noundef %190, ptr noundef %151, ptr noundef %192, ptr noundef %194, ptr noundef %155) #12
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
  br i1 %215, label %216, label %206, !llvm.loop !38

216:                                              ; preds = %206, %187
  %217 = load ptr, ptr %116, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %204, ptr noundef %217, ptr noundef nonnull %116, i64 noundef %120) #11
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
  br i1 %345, label %346, label %321, !llvm.loop !39

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
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %354, i64 noundef 3) #11
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %362, i64 noundef 0) #11
  ret void

374:                                              ; preds = %350, %374
  %375 = phi i64 [ %348, %350 ], [ %386, %374 ]
  %376 = load ptr, ptr %12, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %376, i64 noundef %375) #11
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
  br i1 %387, label %353, label %374, !llvm.loop !40
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
  br i1 %31, label %19, label %32, !llvm.loop !41

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
  br i1 %53, label %7, label %8, !llvm.loop !42
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
  br i1 %86, label %61, label %64, !llvm.loop !43

87:                                               ; preds = %61, %87
  %88 = phi i64 [ %91, %87 ], [ 0, %61 ]
  %89 = mul nsw i64 %88, %12
  %90 = getelementptr inbounds double, ptr %63, i64 %89
  store double 0x7FF8000000000000, ptr %90, align 8
  %91 = add nuw nsw i64 %88, 1
  %92 = icmp eq i64 %91, %9
  br i1 %92, label %83, label %87, !llvm.loop !44

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
  br i1 %126, label %118, label %127, !llvm.loop !45

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
  br i1 %155, label %135, label %174, !llvm.loop !46

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
  br i1 %173, label %150, label %157, !llvm.loop !47

174:                                              ; preds = %150, %130
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %43) #11
  br label %175

175:                                              ; preds = %174, %127
  %176 = load ptr, ptr %15, align 8
  %177 = getelementptr inbounds i64, ptr %176, i64 %43
  store i64 -1, ptr %177, align 8
  %178 = add nsw i64 %42, -1
  %179 = and i64 %178, %42
  %180 = icmp eq i64 %179, 0
  br i1 %180, label %60, label %41, !llvm.loop !48
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
  %17 = tail call i64 %16(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %15, i64 noundef %3) #12
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
  %55 = tail call i32 %54(ptr noundef %46, ptr noundef %47, ptr noundef %48, ptr noundef %50, ptr noundef %52) #12
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
  br i1 %96, label %63, label %30, !llvm.loop !49

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
  br i1 %110, label %86, label %97, !llvm.loop !50

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
  br i1 %142, label %111, label %117, !llvm.loop !51

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
  %17 = tail call fastcc i64 @quiet_lanes(ptr noundef %0, ptr noundef %1, i64 noundef %16, ptr noundef nonnull %3) #11
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
  br i1 %25, label %9, label %21, !llvm.loop !52

26:                                               ; preds = %9, %51
  %27 = phi i64 [ %53, %51 ], [ %19, %9 ]
  %28 = phi i64 [ %46, %51 ], [ 0, %9 ]
  %29 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %27, i1 true)
  %30 = getelementptr inbounds double, ptr %3, i64 %29
  %31 = load double, ptr %30, align 8
  %32 = getelementptr inbounds double, ptr %6, i64 %29
  %33 = tail call fastcc i64 @look_alone(ptr noundef %0, i64 noundef %29, double noundef %31, ptr noundef %32) #11
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
  br i1 %54, label %48, label %26, !llvm.loop !53
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
  br i1 %45, label %36, label %39, !llvm.loop !54

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
  br label %46, !llvm.loop !55

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
  br i1 %111, label %112, label %96, !llvm.loop !56

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
  tail call fastcc void @nested(ptr noundef %15, ptr noundef %18, ptr noundef %20, i64 noundef %22, i64 noundef %26, ptr noundef %27, i64 noundef %32) #11
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
  br i1 %60, label %45, label %40, !llvm.loop !57

61:                                               ; preds = %40
  %62 = bitcast <8 x i1> %12 to i8
  %63 = icmp eq i8 %62, 0
  br i1 %63, label %69, label %64

64:                                               ; preds = %61
  %65 = zext i8 %62 to i64
  %66 = getelementptr inbounds i8, ptr %7, i64 24
  %67 = load ptr, ptr %66, align 8
  %68 = tail call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef %3, ptr noundef %67, i64 noundef %65, i32 noundef 0) #11
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
  br i1 %45, label %28, label %19, !llvm.loop !58

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
  br i1 %54, label %29, label %46, !llvm.loop !59
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
  br i1 %50, label %34, label %40, !llvm.loop !60

51:                                               ; preds = %34
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #11
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
  br i1 %94, label %80, label %83, !llvm.loop !61

95:                                               ; preds = %80
  tail call fastcc void @empty_log(ptr noundef %0, i64 noundef %23) #11
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
  br i1 %139, label %120, label %123, !llvm.loop !62

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
  br i1 %195, label %177, label %180, !llvm.loop !63

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
  br i1 %210, label %196, label %200, !llvm.loop !64

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
  br i1 %218, label %32, label %20, !llvm.loop !65
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
  tail call fastcc void @settle(ptr noundef nonnull %18) #11
  br label %31

31:                                               ; preds = %30, %17
  %32 = getelementptr inbounds i8, ptr %18, i64 152
  %33 = load i64, ptr %32, align 8
  %34 = icmp sgt i64 %33, 0
  br i1 %34, label %35, label %36

35:                                               ; preds = %31
  tail call fastcc void @sample(ptr noundef nonnull %18) #11
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
  %46 = tail call i32 %45(ptr noundef %39, ptr noundef %21, ptr noundef %41, ptr noundef %43, ptr noundef %23) #12
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
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %56, i64 noundef 3) #11
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
  br i1 %77, label %62, label %54, !llvm.loop !66
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
  br i1 %33, label %21, label %34, !llvm.loop !41

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
  br i1 %54, label %6, label %7, !llvm.loop !67
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
  br i1 %25, label %15, label %14, !llvm.loop !68

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
  br i1 %76, label %65, label %77, !llvm.loop !69

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
  br i1 %105, label %22, label %26, !llvm.loop !70
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
  br i1 %48, label %13, label %20, !llvm.loop !71
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
  br i1 %60, label %29, label %33, !llvm.loop !72

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
  br i1 %76, label %57, label %61, !llvm.loop !73
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
  br i1 %50, label %51, label %25, !llvm.loop !74

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
  br i1 %98, label %14, label %19, !llvm.loop !75

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
  br i1 %123, label %104, label %110, !llvm.loop !74

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
  br i1 %138, label %99, label %139, !llvm.loop !76

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
  tail call fastcc void @nested(ptr noundef %37, ptr noundef %40, ptr noundef %42, i64 noundef %44, i64 noundef %48, ptr noundef %49, i64 noundef %54) #11
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
  tail call fastcc void @settle(ptr noundef nonnull %30) #11
  br label %64

64:                                               ; preds = %63, %27
  %65 = getelementptr inbounds i8, ptr %0, i64 296
  %66 = load i64, ptr %65, align 8
  %67 = icmp sgt i64 %66, 0
  br i1 %67, label %68, label %69

68:                                               ; preds = %64
  tail call fastcc void @sample(ptr noundef nonnull %30) #11
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
  %83 = tail call i32 %82(ptr noundef %73, ptr noundef %76, ptr noundef %78, ptr noundef %80, ptr noundef %29) #12
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
  br i1 %100, label %101, label %89, !llvm.loop !77

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
  tail call fastcc void @nested(ptr noundef %143, ptr noundef %146, ptr noundef %148, i64 noundef %150, i64 noundef %154, ptr noundef %155, i64 noundef %159) #11
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
  tail call fastcc void @settle(ptr noundef nonnull %105) #11
  br label %168

168:                                              ; preds = %167, %126
  %169 = load i64, ptr %109, align 8
  %170 = icmp sgt i64 %169, 0
  br i1 %170, label %171, label %172

171:                                              ; preds = %168
  tail call fastcc void @sample(ptr noundef nonnull %105) #11
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
  %183 = tail call i32 %182(ptr noundef %175, ptr noundef %178, ptr noundef %179, ptr noundef %180, ptr noundef %133) #12
  %184 = zext i32 %183 to i64
  %185 = or i64 %128, %184
  %186 = add nuw nsw i64 %127, 1
  %187 = icmp eq i64 %186, 5
  br i1 %187, label %113, label %126, !llvm.loop !78

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
  br i1 %237, label %203, label %208, !llvm.loop !79

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
  br i1 %315, label %316, label %256, !llvm.loop !80

316:                                              ; preds = %313
  %317 = xor <8 x i64> %314, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %318 = and <8 x i64> %251, %317
  %319 = add nuw nsw i64 %198, 1
  %320 = icmp eq i64 %319, %9
  br i1 %320, label %188, label %195, !llvm.loop !81

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
  br i1 %342, label %321, label %330, !llvm.loop !82
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
  br i1 %63, label %64, label %48, !llvm.loop !63

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
  %86 = tail call i64 %81(ptr noundef %9, double noundef %70, double noundef %85) #12
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
  br i1 %127, label %128, label %112, !llvm.loop !63

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
  br i1 %149, label %24, label %129, !llvm.loop !83

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
  br i1 %168, label %150, label %147, !llvm.loop !84
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
  br i1 %31, label %20, label %19, !llvm.loop !85

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
  br i1 %43, label %32, label %24, !llvm.loop !86
}

declare <8 x i1> @llvm.is.fpclass.v8f64(<8 x double>, i32 immarg) #9

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { noinline nounwind }
attributes #5 = { nounwind willreturn memory(none) }
attributes #6 = { noinline nounwind }
attributes #7 = { nounwind willreturn }
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
!22 = distinct !{!22, !4, !5}
!23 = distinct !{!23, !4, !5}
!24 = distinct !{!24, !4, !5}
!25 = distinct !{!25, !4, !5}
!26 = distinct !{!26, !4, !5, !27}
!27 = !{!"llvm.loop.vectorize.width", i32 1}
!28 = distinct !{!28, !4, !5, !27}
!29 = distinct !{!29, !4, !5}
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5, !27}
!35 = distinct !{!35, !4, !5}
!36 = distinct !{!36, !4, !5}
!37 = distinct !{!37, !4, !5}
!38 = distinct !{!38, !4, !5}
!39 = distinct !{!39, !4, !5}
!40 = distinct !{!40, !4, !5}
!41 = distinct !{!41, !4, !5}
!42 = distinct !{!42, !4, !5}
!43 = distinct !{!43, !4, !5}
!44 = distinct !{!44, !4, !5, !27}
!45 = distinct !{!45, !4, !5, !27}
!46 = distinct !{!46, !4, !5}
!47 = distinct !{!47, !4, !5}
!48 = distinct !{!48, !4, !5}
!49 = distinct !{!49, !4, !5}
!50 = distinct !{!50, !4, !5}
!51 = distinct !{!51, !4, !5}
!52 = distinct !{!52, !4, !5}
!53 = distinct !{!53, !4, !5}
!54 = distinct !{!54, !4, !5, !27}
!55 = distinct !{!55, !5}
!56 = distinct !{!56, !4, !5}
!57 = distinct !{!57, !4, !5}
!58 = distinct !{!58, !4, !5}
!59 = distinct !{!59, !4, !5, !27}
!60 = distinct !{!60, !4, !5}
!61 = distinct !{!61, !4, !5}
!62 = distinct !{!62, !4, !5}
!63 = distinct !{!63, !4, !5, !27}
!64 = distinct !{!64, !4, !5}
!65 = distinct !{!65, !4, !5}
!66 = distinct !{!66, !4, !5}
!67 = distinct !{!67, !4, !5}
!68 = distinct !{!68, !4, !5}
!69 = distinct !{!69, !4, !5}
!70 = distinct !{!70, !4, !5}
!71 = distinct !{!71, !4, !5}
!72 = distinct !{!72, !4, !5}
!73 = distinct !{!73, !4, !5, !27}
!74 = distinct !{!74, !4, !5}
!75 = distinct !{!75, !4, !5}
!76 = distinct !{!76, !4, !5}
!77 = distinct !{!77, !4, !5}
!78 = distinct !{!78, !4, !5}
!79 = distinct !{!79, !4, !5}
!80 = distinct !{!80, !4, !5}
!81 = distinct !{!81, !4, !5}
!82 = distinct !{!82, !4, !5}
!83 = distinct !{!83, !4, !5, !27}
!84 = distinct !{!84, !4, !5}
!85 = distinct !{!85, !4, !5}
!86 = distinct !{!86, !4, !5}
