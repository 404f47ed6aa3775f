; sources efa8efbb78b5f8c06a1a5f5ed66d389e441ec821d63ca1f2c067bba36cb0d3c5
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
  %17 = getelementptr inbounds i8, ptr %0, i64 1032
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 1040
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr double, ptr %18, i64 %20
  %22 = getelementptr i8, ptr %21, i64 -16
  %23 = load double, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %0, i64 1008
  %25 = load ptr, ptr %24, align 8
  %26 = load double, ptr %25, align 8
  %27 = load ptr, ptr %13, align 8
  %28 = getelementptr inbounds i8, ptr %27, i64 16
  %29 = load i64, ptr %28, align 8
  %30 = load ptr, ptr %0, align 8
  %31 = getelementptr inbounds i8, ptr %30, i64 8
  %32 = load i64, ptr %31, align 8
  %33 = icmp sgt i64 %32, 0
  %34 = getelementptr inbounds i8, ptr %0, i64 1656
  %35 = load ptr, ptr %34, align 8
  %36 = load i64, ptr %35, align 8
  %37 = getelementptr inbounds i8, ptr %0, i64 1248
  %38 = load ptr, ptr %37, align 8
  %39 = getelementptr inbounds i8, ptr %38, i64 8
  %40 = load i64, ptr %39, align 8
  store i64 0, ptr %6, align 8
  %41 = getelementptr inbounds i8, ptr %0, i64 936
  %42 = load ptr, ptr %41, align 8
  br label %118

43:                                               ; preds = %118
  %44 = getelementptr inbounds i8, ptr %0, i64 696
  %45 = sitofp i64 %29 to double
  %46 = zext i1 %33 to i32
  %47 = icmp eq i64 %36, 1
  %48 = icmp sgt i64 %40, 0
  store i64 %126, ptr %6, align 8
  %49 = getelementptr inbounds i8, ptr %0, i64 936
  %50 = getelementptr inbounds i8, ptr %0, i64 1568
  %51 = getelementptr inbounds i8, ptr %0, i64 1200
  %52 = getelementptr inbounds i8, ptr %0, i64 816
  %53 = insertelement <8 x double> poison, double %23, i64 0
  %54 = shufflevector <8 x double> %53, <8 x double> poison, <8 x i32> zeroinitializer
  %55 = getelementptr inbounds i8, ptr %0, i64 720
  %56 = getelementptr inbounds i8, ptr %0, i64 720
  %57 = insertelement <8 x double> poison, double %26, i64 0
  %58 = shufflevector <8 x double> %57, <8 x double> poison, <8 x i32> zeroinitializer
  %59 = getelementptr inbounds i8, ptr %0, i64 840
  %60 = getelementptr inbounds i8, ptr %0, i64 864
  %61 = insertelement <8 x double> poison, double %45, i64 0
  %62 = shufflevector <8 x double> %61, <8 x double> poison, <8 x i32> zeroinitializer
  %63 = getelementptr inbounds i8, ptr %0, i64 504
  %64 = getelementptr inbounds i8, ptr %0, i64 480
  %65 = getelementptr inbounds i8, ptr %0, i64 24
  %66 = getelementptr inbounds i8, ptr %0, i64 600
  %67 = getelementptr inbounds i8, ptr %0, i64 48
  %68 = getelementptr inbounds i8, ptr %0, i64 72
  %69 = getelementptr inbounds i8, ptr %0, i64 440
  %70 = getelementptr inbounds i8, ptr %0, i64 96
  %71 = getelementptr inbounds i8, ptr %0, i64 168
  %72 = getelementptr inbounds i8, ptr %0, i64 296
  %73 = getelementptr inbounds i8, ptr %0, i64 192
  %74 = getelementptr inbounds i8, ptr %0, i64 240
  %75 = getelementptr inbounds i8, ptr %0, i64 456
  %76 = getelementptr inbounds i8, ptr %0, i64 24
  %77 = getelementptr inbounds i8, ptr %0, i64 600
  %78 = getelementptr inbounds i8, ptr %0, i64 48
  %79 = getelementptr inbounds i8, ptr %0, i64 72
  %80 = getelementptr inbounds i8, ptr %0, i64 440
  %81 = getelementptr inbounds i8, ptr %0, i64 168
  %82 = getelementptr inbounds i8, ptr %0, i64 296
  %83 = getelementptr inbounds i8, ptr %0, i64 192
  %84 = getelementptr inbounds i8, ptr %0, i64 240
  %85 = getelementptr inbounds i8, ptr %0, i64 576
  %86 = getelementptr inbounds i8, ptr %0, i64 440
  %87 = getelementptr inbounds i8, ptr %0, i64 552
  %88 = getelementptr inbounds i8, ptr %0, i64 672
  %89 = getelementptr inbounds i8, ptr %0, i64 648
  %90 = getelementptr inbounds i8, ptr %0, i64 888
  %91 = getelementptr inbounds i8, ptr %0, i64 456
  %92 = getelementptr inbounds i8, ptr %0, i64 440
  %93 = getelementptr inbounds i8, ptr %0, i64 168
  %94 = getelementptr inbounds i8, ptr %0, i64 296
  %95 = getelementptr inbounds i8, ptr %0, i64 192
  %96 = getelementptr inbounds i8, ptr %0, i64 240
  %97 = getelementptr inbounds i8, ptr %0, i64 816
  %98 = getelementptr inbounds i8, ptr %0, i64 440
  %99 = getelementptr inbounds i8, ptr %0, i64 624
  %100 = getelementptr inbounds i8, ptr %0, i64 480
  %101 = getelementptr inbounds i8, ptr %0, i64 96
  %102 = getelementptr inbounds i8, ptr %0, i64 168
  %103 = getelementptr inbounds i8, ptr %0, i64 296
  %104 = getelementptr inbounds i8, ptr %0, i64 192
  %105 = getelementptr inbounds i8, ptr %0, i64 240
  %106 = getelementptr inbounds i8, ptr %0, i64 552
  %107 = getelementptr inbounds i8, ptr %0, i64 456
  %108 = getelementptr inbounds i8, ptr %0, i64 120
  %109 = getelementptr inbounds i8, ptr %0, i64 720
  %110 = getelementptr inbounds i8, ptr %0, i64 744
  %111 = getelementptr inbounds i8, ptr %0, i64 768
  %112 = getelementptr inbounds i8, ptr %0, i64 912
  %113 = icmp sgt i64 %16, 0
  %114 = getelementptr inbounds i8, ptr %0, i64 456
  %115 = getelementptr inbounds i8, ptr %0, i64 600
  %116 = getelementptr inbounds i8, ptr %0, i64 440
  %117 = icmp sgt i64 %16, 0
  br label %129

118:                                              ; preds = %1, %118
  %119 = phi i64 [ 0, %1 ], [ %127, %118 ]
  %120 = phi i64 [ 0, %1 ], [ %126, %118 ]
  %121 = getelementptr inbounds i64, ptr %42, i64 %119
  %122 = load i64, ptr %121, align 8
  %123 = icmp sgt i64 %122, -1
  %124 = zext i1 %123 to i64
  %125 = shl nuw nsw i64 %124, %119
  %126 = or i64 %125, %120
  %127 = add nuw nsw i64 %119, 1
  %128 = icmp eq i64 %127, 8
  br i1 %128, label %43, label %118, !llvm.loop !3

129:                                              ; preds = %164, %43
  %130 = phi i32 [ 1, %43 ], [ %165, %164 ]
  %131 = phi i64 [ 0, %43 ], [ %166, %164 ]
  %132 = icmp ne i32 %130, 0
  %133 = icmp ne i64 %131, 0
  %134 = select i1 %132, i1 true, i1 %133
  br i1 %134, label %135, label %167

135:                                              ; preds = %129
  br i1 %132, label %136, label %138

136:                                              ; preds = %135
  %137 = call fastcc i64 @fill(ptr noundef %0, ptr noundef nonnull %6) #10
  br label %138

138:                                              ; preds = %135, %136
  %139 = phi i64 [ %137, %136 ], [ 0, %135 ]
  %140 = load i64, ptr %6, align 8
  %141 = icmp eq i64 %140, 0
  br i1 %141, label %160, label %142

142:                                              ; preds = %138
  %143 = or i64 %139, %131
  %144 = icmp eq i64 %143, 0
  br i1 %144, label %160, label %145

145:                                              ; preds = %142
  call fastcc void @start(ptr noundef %0, ptr noundef nonnull %2, i64 noundef %139, i64 noundef %131) #10
  br label %146

146:                                              ; preds = %145, %155
  %147 = phi i32 [ 0, %145 ], [ %157, %155 ]
  %148 = phi i64 [ 0, %145 ], [ %158, %155 ]
  %149 = icmp eq i32 %147, 0
  br i1 %149, label %150, label %155

150:                                              ; preds = %146
  %151 = load ptr, ptr %49, align 8
  %152 = getelementptr inbounds i64, ptr %151, i64 %148
  %153 = load i64, ptr %152, align 8
  %154 = icmp eq i64 %153, -1
  br label %155

155:                                              ; preds = %150, %146
  %156 = phi i1 [ true, %146 ], [ %154, %150 ]
  %157 = zext i1 %156 to i32
  %158 = add nuw nsw i64 %148, 1
  %159 = icmp eq i64 %158, 8
  br i1 %159, label %160, label %146, !llvm.loop !6

160:                                              ; preds = %155, %142, %138
  %161 = phi i32 [ 1, %138 ], [ 8, %142 ], [ 0, %155 ]
  %162 = phi i32 [ %130, %138 ], [ 0, %142 ], [ %157, %155 ]
  %163 = phi i64 [ %131, %138 ], [ %131, %142 ], [ 0, %155 ]
  switch i32 %161, label %1159 [
    i32 0, label %164
    i32 8, label %167
  ]

164:                                              ; preds = %160, %1157, %247
  %165 = phi i32 [ %162, %160 ], [ %1158, %1157 ], [ 1, %247 ]
  %166 = phi i64 [ %163, %160 ], [ %1135, %1157 ], [ %169, %247 ]
  br label %129, !llvm.loop !7

167:                                              ; preds = %160, %129
  %168 = phi i32 [ %162, %160 ], [ 0, %129 ]
  %169 = phi i64 [ %163, %160 ], [ 0, %129 ]
  %170 = load ptr, ptr %13, align 8
  %171 = getelementptr inbounds i8, ptr %170, i64 8
  %172 = load i64, ptr %171, align 8
  %173 = icmp slt i64 %172, 1
  br i1 %173, label %1159, label %174

174:                                              ; preds = %167
  br i1 %48, label %175, label %195

175:                                              ; preds = %174
  %176 = load i64, ptr %50, align 8
  %177 = icmp sgt i64 %176, 0
  br i1 %177, label %178, label %192

178:                                              ; preds = %175
  %179 = load ptr, ptr %37, align 8
  %180 = getelementptr inbounds i8, ptr %179, i64 72
  %181 = load i64, ptr %180, align 8
  %182 = load ptr, ptr %51, align 8
  %183 = load i64, ptr %182, align 8
  %184 = inttoptr i64 %183 to ptr
  %185 = getelementptr inbounds i8, ptr %184, i64 1064
  %186 = load i64, ptr %185, align 8
  %187 = shl i64 %186, 4
  %188 = add i64 %181, 16
  %189 = add i64 %188, %187
  %190 = icmp sgt i64 %189, %176
  %191 = zext i1 %190 to i32
  br label %192

192:                                              ; preds = %175, %178
  %193 = phi i32 [ 0, %175 ], [ %191, %178 ]
  %194 = icmp eq i32 %193, 0
  br i1 %194, label %195, label %1159

195:                                              ; preds = %192, %174
  %196 = add nsw i64 %172, -1
  store i64 %196, ptr %171, align 8
  %197 = load i64, ptr %6, align 8
  %198 = trunc i64 %197 to i8
  %199 = bitcast i8 %198 to <8 x i1>
  %200 = load ptr, ptr %44, align 8
  %201 = load <8 x double>, ptr %200, align 8
  call fastcc void @hold_all(ptr noundef %0, ptr noundef nonnull %5) #10
  br i1 %33, label %205, label %202

202:                                              ; preds = %195
  %203 = load ptr, ptr %52, align 8
  %204 = load <8 x double>, ptr %203, align 8
  br label %205

205:                                              ; preds = %195, %202
  %206 = phi <8 x double> [ %204, %202 ], [ %54, %195 ]
  %207 = load <8 x double>, ptr %5, align 16
  %208 = fcmp olt <8 x double> %206, %207
  %209 = select <8 x i1> %208, <8 x double> %206, <8 x double> %207
  br i1 %33, label %210, label %215

210:                                              ; preds = %205
  %211 = load ptr, ptr %56, align 8
  %212 = load <8 x double>, ptr %211, align 8
  %213 = fcmp olt <8 x double> %212, %58
  %214 = select <8 x i1> %213, <8 x double> %212, <8 x double> %58
  br label %223

215:                                              ; preds = %205
  %216 = load ptr, ptr %55, align 8
  %217 = load <8 x double>, ptr %216, align 8
  %218 = fsub <8 x double> %209, %201
  %219 = fdiv <8 x double> %218, %217
  %220 = fmul <8 x double> %219, <double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1, double 0x3FEFFFFFFFFFDCD1>
  %221 = call <8 x double> @llvm.ceil.v8f64(<8 x double> %220)
  %222 = fdiv <8 x double> %218, %221
  br label %223

223:                                              ; preds = %215, %210
  %224 = phi <8 x double> [ %214, %210 ], [ %222, %215 ]
  %225 = fadd <8 x double> %201, %224
  %226 = fmul <8 x double> %224, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %227 = fsub <8 x double> %209, %226
  %228 = fcmp ogt <8 x double> %225, %227
  %229 = select <8 x i1> %228, <8 x double> %209, <8 x double> %225
  %230 = fsub <8 x double> %229, %201
  %231 = select <8 x i1> %199, <8 x double> %230, <8 x double> zeroinitializer
  %232 = load ptr, ptr %59, align 8
  %233 = load <8 x double>, ptr %232, align 8
  %234 = load ptr, ptr %60, align 8
  %235 = load <8 x double>, ptr %234, align 8
  %236 = fadd <8 x double> %233, %235
  %237 = fcmp oge <8 x double> %236, %62
  %238 = fmul <8 x double> %231, <double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02, double 6.250000e-02>
  %239 = fadd <8 x double> %201, %238
  %240 = fcmp ule <8 x double> %239, %201
  %241 = fcmp une <8 x double> %229, %209
  %242 = and <8 x i1> %240, %241
  %243 = or <8 x i1> %242, %237
  %244 = and <8 x i1> %243, %199
  %245 = bitcast <8 x i1> %244 to i8
  %246 = icmp eq i8 %245, 0
  br i1 %246, label %254, label %247

247:                                              ; preds = %223
  %248 = zext i8 %245 to i64
  %249 = bitcast <8 x i1> %237 to i8
  %250 = zext i8 %249 to i64
  %251 = and i64 %248, %250
  call fastcc void @retire(ptr noundef %0, i64 noundef %251, i64 noundef 1) #10
  %252 = xor i64 %250, -1
  %253 = and i64 %248, %252
  call fastcc void @retire(ptr noundef %0, i64 noundef %253, i64 noundef -1) #10
  br label %164

254:                                              ; preds = %223
  %255 = load ptr, ptr %0, align 8, !noalias !8
  %256 = load ptr, ptr %10, align 8, !noalias !8
  %257 = getelementptr inbounds i8, ptr %256, i64 8
  %258 = load i64, ptr %257, align 8, !noalias !8
  %259 = getelementptr inbounds i8, ptr %255, i64 32
  %260 = load i64, ptr %259, align 8, !noalias !8
  %261 = icmp ne i64 %260, 1
  %262 = load i64, ptr %255, align 8, !noalias !8
  %263 = load ptr, ptr %63, align 8, !noalias !8
  store <8 x double> %231, ptr %263, align 8, !noalias !8
  %264 = icmp sgt i64 %262, 1
  br i1 %264, label %265, label %315

265:                                              ; preds = %254, %302
  %266 = phi i64 [ %312, %302 ], [ 0, %254 ]
  %267 = phi i64 [ %313, %302 ], [ 1, %254 ]
  %268 = load ptr, ptr %64, align 8, !noalias !8
  %269 = load ptr, ptr %12, align 8, !noalias !8
  %270 = load ptr, ptr %10, align 8, !noalias !8
  %271 = getelementptr inbounds i8, ptr %270, i64 16
  %272 = load i64, ptr %271, align 8, !noalias !8
  %273 = load ptr, ptr %65, align 8, !noalias !8
  %274 = getelementptr inbounds i64, ptr %273, i64 %267
  %275 = load i64, ptr %274, align 8, !noalias !8
  %276 = getelementptr i8, ptr %274, i64 8
  %277 = load i64, ptr %276, align 8, !noalias !8
  %278 = xor i64 %275, -1
  %279 = add i64 %277, %278
  %280 = load ptr, ptr %63, align 8, !noalias !8
  %281 = load ptr, ptr %66, align 8, !noalias !8
  %282 = load ptr, ptr %67, align 8, !noalias !8
  %283 = getelementptr inbounds i64, ptr %282, i64 %275
  %284 = load ptr, ptr %68, align 8, !noalias !8
  %285 = getelementptr inbounds double, ptr %284, i64 %275
  call fastcc void @combine(ptr noundef %268, ptr noundef %269, ptr noundef %280, ptr noundef %281, ptr noundef %283, ptr noundef %285, i64 noundef %279, i64 noundef %272) #10
  %286 = load ptr, ptr %66, align 8, !noalias !8
  %287 = load i64, ptr %69, align 8, !noalias !8
  %288 = mul nsw i64 %287, %267
  %289 = getelementptr inbounds double, ptr %286, i64 %288
  %290 = load ptr, ptr %70, align 8, !noalias !8
  %291 = getelementptr inbounds double, ptr %290, i64 %267
  %292 = load double, ptr %291, align 8, !noalias !8
  %293 = insertelement <8 x double> poison, double %292, i64 0
  %294 = shufflevector <8 x double> %293, <8 x double> poison, <8 x i32> zeroinitializer
  %295 = fmul <8 x double> %231, %294
  %296 = fadd <8 x double> %201, %295
  %297 = load ptr, ptr %64, align 8, !noalias !8
  %298 = load ptr, ptr %71, align 8, !noalias !8
  store <8 x double> %296, ptr %298, align 8, !noalias !8
  %299 = load i64, ptr %72, align 8, !noalias !8
  %300 = icmp sgt i64 %299, 0
  br i1 %300, label %301, label %302

301:                                              ; preds = %265
  call fastcc void @sample(ptr noundef nonnull %10) #10, !noalias !8
  br label %302

302:                                              ; preds = %301, %265
  %303 = load ptr, ptr %10, align 8, !noalias !8
  %304 = load i64, ptr %303, align 8, !noalias !8
  %305 = load ptr, ptr %71, align 8, !noalias !8
  %306 = load ptr, ptr %73, align 8, !noalias !8
  %307 = load ptr, ptr %74, align 8, !noalias !8
  %308 = inttoptr i64 %304 to ptr
  %309 = load ptr, ptr %308, align 8, !noalias !8
  %310 = call i32 %309(ptr noundef %305, ptr noundef %297, ptr noundef %306, ptr noundef %307, ptr noundef %289) #11, !noalias !8
  %311 = zext i32 %310 to i64
  %312 = or i64 %266, %311
  %313 = add nuw nsw i64 %267, 1
  %314 = icmp eq i64 %313, %262
  br i1 %314, label %315, label %265, !llvm.loop !11

315:                                              ; preds = %302, %254
  %316 = phi i64 [ 0, %254 ], [ %312, %302 ]
  %317 = load ptr, ptr %75, align 8, !noalias !8
  %318 = load ptr, ptr %12, align 8, !noalias !8
  %319 = load ptr, ptr %10, align 8, !noalias !8
  %320 = getelementptr inbounds i8, ptr %319, i64 16
  %321 = load i64, ptr %320, align 8, !noalias !8
  %322 = load ptr, ptr %76, align 8, !noalias !8
  %323 = getelementptr inbounds i64, ptr %322, i64 %262
  %324 = load i64, ptr %323, align 8, !noalias !8
  %325 = getelementptr i8, ptr %323, i64 8
  %326 = load i64, ptr %325, align 8, !noalias !8
  %327 = xor i64 %324, -1
  %328 = add i64 %326, %327
  %329 = load ptr, ptr %63, align 8, !noalias !8
  %330 = load ptr, ptr %77, align 8, !noalias !8
  %331 = load ptr, ptr %78, align 8, !noalias !8
  %332 = getelementptr inbounds i64, ptr %331, i64 %324
  %333 = load ptr, ptr %79, align 8, !noalias !8
  %334 = getelementptr inbounds double, ptr %333, i64 %324
  call fastcc void @combine(ptr noundef %317, ptr noundef %318, ptr noundef %329, ptr noundef %330, ptr noundef %332, ptr noundef %334, i64 noundef %328, i64 noundef %321) #10
  br i1 %261, label %357, label %335

335:                                              ; preds = %315
  %336 = load ptr, ptr %75, align 8, !noalias !8
  %337 = load ptr, ptr %77, align 8, !noalias !8
  %338 = load i64, ptr %255, align 8, !noalias !8
  %339 = load i64, ptr %80, align 8, !noalias !8
  %340 = mul nsw i64 %339, %338
  %341 = getelementptr inbounds double, ptr %337, i64 %340
  %342 = load ptr, ptr %81, align 8, !noalias !8
  store <8 x double> %229, ptr %342, align 8, !noalias !8
  %343 = load i64, ptr %82, align 8, !noalias !8
  %344 = icmp sgt i64 %343, 0
  br i1 %344, label %345, label %346

345:                                              ; preds = %335
  call fastcc void @sample(ptr noundef nonnull %10) #10, !noalias !8
  br label %346

346:                                              ; preds = %335, %345
  %347 = load ptr, ptr %10, align 8, !noalias !8
  %348 = load i64, ptr %347, align 8, !noalias !8
  %349 = load ptr, ptr %81, align 8, !noalias !8
  %350 = load ptr, ptr %83, align 8, !noalias !8
  %351 = load ptr, ptr %84, align 8, !noalias !8
  %352 = inttoptr i64 %348 to ptr
  %353 = load ptr, ptr %352, align 8, !noalias !8
  %354 = call i32 %353(ptr noundef %349, ptr noundef %336, ptr noundef %350, ptr noundef %351, ptr noundef %341) #11, !noalias !8
  %355 = zext i32 %354 to i64
  %356 = or i64 %316, %355
  br label %357

357:                                              ; preds = %346, %315
  %358 = phi i64 [ %356, %346 ], [ %316, %315 ]
  %359 = load ptr, ptr %0, align 8, !noalias !8
  %360 = getelementptr inbounds i8, ptr %359, i64 8
  %361 = load i64, ptr %360, align 8, !noalias !8
  %362 = icmp slt i64 %361, 1
  br i1 %362, label %363, label %367

363:                                              ; preds = %357
  %364 = icmp sgt i64 %258, 0
  br i1 %364, label %365, label %535

365:                                              ; preds = %363
  %366 = load ptr, ptr %75, align 8, !noalias !8
  br label %525

367:                                              ; preds = %357
  %368 = load ptr, ptr %10, align 8, !noalias !8
  %369 = getelementptr inbounds i8, ptr %368, i64 24
  %370 = load i64, ptr %369, align 8, !noalias !8
  %371 = load ptr, ptr %85, align 8, !noalias !8
  %372 = load i64, ptr %86, align 8, !noalias !8
  %373 = getelementptr inbounds i8, ptr %368, i64 32
  br label %383

374:                                              ; preds = %383
  %375 = getelementptr inbounds double, ptr %371, i64 %372
  %376 = icmp sgt i64 %370, 0
  br i1 %376, label %377, label %409

377:                                              ; preds = %374
  %378 = load ptr, ptr %12, align 8, !noalias !8
  %379 = load ptr, ptr %75, align 8, !noalias !8
  %380 = load ptr, ptr %88, align 8, !noalias !8
  %381 = load ptr, ptr %89, align 8, !noalias !8
  %382 = load ptr, ptr %85, align 8, !noalias !8
  br label %472

383:                                              ; preds = %367, %383
  %384 = phi i64 [ 0, %367 ], [ %407, %383 ]
  %385 = load i64, ptr %359, align 8, !noalias !8
  %386 = load i64, ptr %373, align 8, !noalias !8
  %387 = load ptr, ptr %85, align 8, !noalias !8
  %388 = load i64, ptr %86, align 8, !noalias !8
  %389 = mul nsw i64 %388, %384
  %390 = getelementptr inbounds double, ptr %387, i64 %389
  %391 = load ptr, ptr %87, align 8, !noalias !8
  %392 = load ptr, ptr %76, align 8, !noalias !8
  %393 = getelementptr i64, ptr %392, i64 %385
  %394 = getelementptr i8, ptr %393, i64 8
  %395 = getelementptr i64, ptr %394, i64 %384
  %396 = load i64, ptr %395, align 8, !noalias !8
  %397 = getelementptr i8, ptr %395, i64 8
  %398 = load i64, ptr %397, align 8, !noalias !8
  %399 = xor i64 %396, -1
  %400 = add i64 %398, %399
  %401 = load ptr, ptr %63, align 8, !noalias !8
  %402 = load ptr, ptr %77, align 8, !noalias !8
  %403 = load ptr, ptr %78, align 8, !noalias !8
  %404 = getelementptr inbounds i64, ptr %403, i64 %396
  %405 = load ptr, ptr %79, align 8, !noalias !8
  %406 = getelementptr inbounds double, ptr %405, i64 %396
  call fastcc void @combine(ptr noundef %390, ptr noundef %391, ptr noundef %401, ptr noundef %402, ptr noundef %404, ptr noundef %406, i64 noundef %400, i64 noundef %386) #10
  %407 = add nuw nsw i64 %384, 1
  %408 = icmp eq i64 %407, %361
  br i1 %408, label %374, label %383, !llvm.loop !12

409:                                              ; preds = %472, %374
  %410 = phi <8 x double> [ zeroinitializer, %374 ], [ %505, %472 ]
  %411 = phi <8 x double> [ zeroinitializer, %374 ], [ %503, %472 ]
  %412 = load ptr, ptr %75, align 8, !noalias !8
  %413 = getelementptr inbounds i8, ptr %368, i64 8
  %414 = load i64, ptr %413, align 8, !noalias !8
  %415 = add nsw i64 %414, -3
  %416 = getelementptr i8, ptr %412, i64 64
  %417 = getelementptr i8, ptr %412, i64 128
  %418 = getelementptr i8, ptr %412, i64 192
  %419 = icmp slt i64 %370, %415
  br i1 %419, label %427, label %420

420:                                              ; preds = %427, %409
  %421 = phi <8 x double> [ zeroinitializer, %409 ], [ %437, %427 ]
  %422 = phi <8 x double> [ zeroinitializer, %409 ], [ %442, %427 ]
  %423 = phi <8 x double> [ zeroinitializer, %409 ], [ %447, %427 ]
  %424 = phi <8 x double> [ zeroinitializer, %409 ], [ %452, %427 ]
  %425 = phi i64 [ %370, %409 ], [ %453, %427 ]
  %426 = icmp slt i64 %425, %414
  br i1 %426, label %455, label %465

427:                                              ; preds = %409, %427
  %428 = phi i64 [ %453, %427 ], [ %370, %409 ]
  %429 = phi <8 x double> [ %452, %427 ], [ zeroinitializer, %409 ]
  %430 = phi <8 x double> [ %447, %427 ], [ zeroinitializer, %409 ]
  %431 = phi <8 x double> [ %442, %427 ], [ zeroinitializer, %409 ]
  %432 = phi <8 x double> [ %437, %427 ], [ zeroinitializer, %409 ]
  %433 = shl nsw i64 %428, 6
  %434 = getelementptr inbounds i8, ptr %412, i64 %433
  %435 = load <8 x double>, ptr %434, align 8, !noalias !8
  %436 = fmul <8 x double> %435, zeroinitializer
  %437 = fadd <8 x double> %432, %436
  %438 = shl i64 %428, 6
  %439 = getelementptr i8, ptr %416, i64 %438
  %440 = load <8 x double>, ptr %439, align 8, !noalias !8
  %441 = fmul <8 x double> %440, zeroinitializer
  %442 = fadd <8 x double> %431, %441
  %443 = shl i64 %428, 6
  %444 = getelementptr i8, ptr %417, i64 %443
  %445 = load <8 x double>, ptr %444, align 8, !noalias !8
  %446 = fmul <8 x double> %445, zeroinitializer
  %447 = fadd <8 x double> %430, %446
  %448 = shl i64 %428, 6
  %449 = getelementptr i8, ptr %418, i64 %448
  %450 = load <8 x double>, ptr %449, align 8, !noalias !8
  %451 = fmul <8 x double> %450, zeroinitializer
  %452 = fadd <8 x double> %429, %451
  %453 = add nsw i64 %428, 4
  %454 = icmp slt i64 %453, %415
  br i1 %454, label %427, label %420, !llvm.loop !13

455:                                              ; preds = %420, %455
  %456 = phi i64 [ %463, %455 ], [ %425, %420 ]
  %457 = phi <8 x double> [ %462, %455 ], [ %421, %420 ]
  %458 = shl nsw i64 %456, 6
  %459 = getelementptr inbounds i8, ptr %412, i64 %458
  %460 = load <8 x double>, ptr %459, align 8, !noalias !8
  %461 = fmul <8 x double> %460, zeroinitializer
  %462 = fadd <8 x double> %457, %461
  %463 = add nsw i64 %456, 1
  %464 = icmp eq i64 %463, %414
  br i1 %464, label %465, label %455, !llvm.loop !14

465:                                              ; preds = %455, %420
  %466 = phi <8 x double> [ %421, %420 ], [ %462, %455 ]
  %467 = fadd <8 x double> %422, %466
  %468 = fadd <8 x double> %423, %424
  %469 = fadd <8 x double> %468, %467
  %470 = fadd <8 x double> %411, %469
  %471 = icmp eq i64 %361, 2
  br i1 %471, label %508, label %519

472:                                              ; preds = %377, %472
  %473 = phi <8 x double> [ zeroinitializer, %377 ], [ %503, %472 ]
  %474 = phi <8 x double> [ zeroinitializer, %377 ], [ %505, %472 ]
  %475 = phi i64 [ 0, %377 ], [ %506, %472 ]
  %476 = shl nsw i64 %475, 6
  %477 = getelementptr inbounds i8, ptr %378, i64 %476
  %478 = load <8 x double>, ptr %477, align 8, !noalias !8
  %479 = getelementptr inbounds i8, ptr %379, i64 %476
  %480 = load <8 x double>, ptr %479, align 8, !noalias !8
  %481 = getelementptr inbounds double, ptr %380, i64 %475
  %482 = load double, ptr %481, align 8, !noalias !8
  %483 = insertelement <8 x double> poison, double %482, i64 0
  %484 = shufflevector <8 x double> %483, <8 x double> poison, <8 x i32> zeroinitializer
  %485 = getelementptr inbounds double, ptr %381, i64 %475
  %486 = load double, ptr %485, align 8, !noalias !8
  %487 = insertelement <8 x double> poison, double %486, i64 0
  %488 = shufflevector <8 x double> %487, <8 x double> poison, <8 x i32> zeroinitializer
  %489 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %478)
  %490 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %480)
  %491 = fcmp ogt <8 x double> %489, %490
  %492 = select <8 x i1> %491, <8 x double> %489, <8 x double> %490
  %493 = fmul <8 x double> %492, %488
  %494 = fadd <8 x double> %484, %493
  %495 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %494
  %496 = getelementptr inbounds i8, ptr %382, i64 %476
  %497 = load <8 x double>, ptr %496, align 8, !noalias !8
  %498 = fmul <8 x double> %497, %495
  %499 = getelementptr inbounds i8, ptr %375, i64 %476
  %500 = load <8 x double>, ptr %499, align 8, !noalias !8
  %501 = fmul <8 x double> %500, %495
  %502 = fmul <8 x double> %498, %498
  %503 = fadd <8 x double> %473, %502
  %504 = fmul <8 x double> %501, %501
  %505 = fadd <8 x double> %474, %504
  %506 = add nuw nsw i64 %475, 1
  %507 = icmp eq i64 %506, %370
  br i1 %507, label %409, label %472, !llvm.loop !15

508:                                              ; preds = %465
  %509 = fmul <8 x double> %410, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %510 = fadd <8 x double> %509, %470
  %511 = sitofp i64 %370 to double
  %512 = insertelement <8 x double> poison, double %511, i64 0
  %513 = shufflevector <8 x double> %512, <8 x double> poison, <8 x i32> zeroinitializer
  %514 = fmul <8 x double> %513, %510
  %515 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %514)
  %516 = fdiv <8 x double> %470, %515
  %517 = fcmp oeq <8 x double> %470, zeroinitializer
  %518 = select <8 x i1> %517, <8 x double> zeroinitializer, <8 x double> %516
  br label %535

519:                                              ; preds = %465
  %520 = sitofp i64 %370 to double
  %521 = insertelement <8 x double> poison, double %520, i64 0
  %522 = shufflevector <8 x double> %521, <8 x double> poison, <8 x i32> zeroinitializer
  %523 = fdiv <8 x double> %470, %522
  %524 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %523)
  br label %535

525:                                              ; preds = %365, %525
  %526 = phi i64 [ 0, %365 ], [ %533, %525 ]
  %527 = phi <8 x double> [ zeroinitializer, %365 ], [ %532, %525 ]
  %528 = shl nsw i64 %526, 6
  %529 = getelementptr inbounds i8, ptr %366, i64 %528
  %530 = load <8 x double>, ptr %529, align 8, !noalias !8
  %531 = fmul <8 x double> %530, zeroinitializer
  %532 = fadd <8 x double> %527, %531
  %533 = add nuw nsw i64 %526, 1
  %534 = icmp eq i64 %533, %258
  br i1 %534, label %535, label %525, !llvm.loop !16

535:                                              ; preds = %525, %363, %519, %508
  %536 = phi <8 x double> [ %518, %508 ], [ %524, %519 ], [ zeroinitializer, %363 ], [ %532, %525 ]
  %537 = fcmp olt <8 x double> %536, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %538 = bitcast <8 x i1> %537 to i8
  %539 = zext i8 %538 to i64
  %540 = xor i64 %358, -1
  %541 = and i64 %540, %539
  %542 = and i64 %541, %197
  %543 = load ptr, ptr %90, align 8, !noalias !8
  %544 = load <8 x double>, ptr %543, align 8, !noalias !8
  %545 = load i64, ptr %255, align 8, !noalias !8
  %546 = sext i1 %261 to i64
  %547 = add i64 %545, %546
  %548 = sitofp i64 %547 to double
  %549 = insertelement <8 x double> poison, double %548, i64 0
  %550 = shufflevector <8 x double> %549, <8 x double> poison, <8 x i32> zeroinitializer
  %551 = fadd <8 x double> %544, %550
  store <8 x double> %551, ptr %543, align 8, !noalias !8
  %552 = icmp ne i64 %542, 0
  %553 = select i1 %47, i1 %552, i1 false
  br i1 %553, label %554, label %557

554:                                              ; preds = %535
  store <8 x double> %229, ptr %3, align 16
  %555 = load ptr, ptr %91, align 8
  %556 = call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef nonnull %3, ptr noundef %555, i64 noundef %542, i32 noundef %46) #10
  br label %557

557:                                              ; preds = %554, %535
  %558 = phi i64 [ %556, %554 ], [ 0, %535 ]
  %559 = xor i64 %558, -1
  %560 = and i64 %542, %559
  %561 = load ptr, ptr %0, align 8
  %562 = icmp eq i64 %560, 0
  br i1 %562, label %601, label %563

563:                                              ; preds = %557
  %564 = getelementptr inbounds i8, ptr %561, i64 32
  %565 = load i64, ptr %564, align 8
  %566 = icmp eq i64 %565, 1
  br i1 %566, label %567, label %571

567:                                              ; preds = %563
  %568 = load ptr, ptr %34, align 8
  %569 = load i64, ptr %568, align 8
  %570 = icmp eq i64 %569, 1
  br i1 %570, label %571, label %601

571:                                              ; preds = %567, %563
  %572 = load ptr, ptr %75, align 8
  %573 = load ptr, ptr %77, align 8
  %574 = load i64, ptr %561, align 8
  %575 = load i64, ptr %92, align 8
  %576 = mul nsw i64 %575, %574
  %577 = getelementptr inbounds double, ptr %573, i64 %576
  %578 = load ptr, ptr %93, align 8
  store <8 x double> %229, ptr %578, align 8
  %579 = load i64, ptr %94, align 8
  %580 = icmp sgt i64 %579, 0
  br i1 %580, label %581, label %582

581:                                              ; preds = %571
  call fastcc void @sample(ptr noundef nonnull %10) #10
  br label %582

582:                                              ; preds = %571, %581
  %583 = load ptr, ptr %10, align 8
  %584 = load i64, ptr %583, align 8
  %585 = load ptr, ptr %93, align 8
  %586 = load ptr, ptr %95, align 8
  %587 = load ptr, ptr %96, align 8
  %588 = inttoptr i64 %584 to ptr
  %589 = load ptr, ptr %588, align 8
  %590 = call i32 %589(ptr noundef %585, ptr noundef %572, ptr noundef %586, ptr noundef %587, ptr noundef %577) #11
  %591 = zext i32 %590 to i64
  %592 = or i64 %358, %591
  %593 = load ptr, ptr %90, align 8
  %594 = load <8 x double>, ptr %593, align 8
  %595 = trunc nuw i64 %560 to i8
  %596 = bitcast i8 %595 to <8 x i1>
  %597 = select <8 x i1> %596, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %598 = fadd <8 x double> %597, %594
  store <8 x double> %598, ptr %593, align 8
  %599 = xor i64 %592, -1
  %600 = and i64 %560, %599
  br label %601

601:                                              ; preds = %557, %567, %582
  %602 = phi i64 [ %358, %557 ], [ %592, %582 ], [ %358, %567 ]
  %603 = phi i64 [ %560, %557 ], [ %600, %582 ], [ %560, %567 ]
  %604 = icmp ne i64 %603, 0
  %605 = select i1 %48, i1 %604, i1 false
  br i1 %605, label %606, label %610

606:                                              ; preds = %601
  %607 = call fastcc i64 @clear_lanes(ptr noundef %0) #10
  %608 = xor i64 %607, -1
  %609 = and i64 %603, %608
  br label %610

610:                                              ; preds = %601, %606
  %611 = phi i64 [ %609, %606 ], [ 0, %601 ]
  store i64 0, ptr %8, align 8
  %612 = load ptr, ptr %97, align 8
  %613 = load <8 x double>, ptr %612, align 8
  %614 = fcmp olt <8 x double> %613, %229
  %615 = bitcast <8 x i1> %614 to i8
  %616 = zext i8 %615 to i64
  %617 = and i64 %603, %616
  %618 = or i64 %617, %611
  %619 = icmp eq i64 %618, 0
  br i1 %619, label %814, label %620

620:                                              ; preds = %610
  %621 = load ptr, ptr %90, align 8
  %622 = load <8 x double>, ptr %621, align 8
  %623 = trunc nuw i64 %618 to i8
  %624 = bitcast i8 %623 to <8 x i1>
  %625 = load ptr, ptr %0, align 8
  %626 = getelementptr inbounds i8, ptr %625, i64 16
  %627 = load i64, ptr %626, align 8
  %628 = sitofp i64 %627 to double
  %629 = insertelement <8 x double> poison, double %628, i64 0
  %630 = shufflevector <8 x double> %629, <8 x double> poison, <8 x i32> zeroinitializer
  %631 = select <8 x i1> %624, <8 x double> %630, <8 x double> zeroinitializer
  %632 = fadd <8 x double> %622, %631
  store <8 x double> %632, ptr %621, align 8
  %633 = load ptr, ptr %0, align 8
  %634 = load ptr, ptr %10, align 8
  %635 = getelementptr inbounds i8, ptr %634, i64 16
  %636 = load i64, ptr %635, align 8
  %637 = load i64, ptr %633, align 8
  %638 = load i64, ptr %98, align 8
  %639 = load ptr, ptr %77, align 8
  %640 = mul nsw i64 %638, %637
  %641 = getelementptr inbounds double, ptr %639, i64 %640
  %642 = load ptr, ptr %99, align 8
  %643 = add nsw i64 %637, 1
  %644 = getelementptr inbounds i8, ptr %633, i64 16
  %645 = load i64, ptr %644, align 8
  %646 = icmp sgt i64 %645, 0
  br i1 %646, label %647, label %649

647:                                              ; preds = %620
  %648 = getelementptr inbounds i8, ptr %633, i64 8
  br label %660

649:                                              ; preds = %695, %620
  %650 = phi i64 [ 0, %620 ], [ %705, %695 ]
  %651 = getelementptr inbounds i8, ptr %633, i64 16
  %652 = load ptr, ptr %10, align 8
  %653 = getelementptr inbounds i8, ptr %652, i64 8
  %654 = load i64, ptr %653, align 8
  %655 = icmp sgt i64 %654, 0
  br i1 %655, label %656, label %710

656:                                              ; preds = %649
  %657 = getelementptr inbounds double, ptr %642, i64 %638
  %658 = shl nsw i64 %638, 4
  %659 = getelementptr inbounds i8, ptr %642, i64 %658
  br label %717

660:                                              ; preds = %647, %695
  %661 = phi i64 [ 0, %647 ], [ %705, %695 ]
  %662 = phi i64 [ %643, %647 ], [ %706, %695 ]
  %663 = load i64, ptr %648, align 8
  %664 = load ptr, ptr %100, align 8
  %665 = load ptr, ptr %12, align 8
  %666 = load ptr, ptr %76, align 8
  %667 = getelementptr i64, ptr %666, i64 %662
  %668 = getelementptr i64, ptr %667, i64 %663
  %669 = load i64, ptr %668, align 8
  %670 = getelementptr i8, ptr %668, i64 8
  %671 = load i64, ptr %670, align 8
  %672 = xor i64 %669, -1
  %673 = add i64 %671, %672
  %674 = load ptr, ptr %63, align 8
  %675 = load ptr, ptr %77, align 8
  %676 = load ptr, ptr %78, align 8
  %677 = getelementptr inbounds i64, ptr %676, i64 %669
  %678 = load ptr, ptr %79, align 8
  %679 = getelementptr inbounds double, ptr %678, i64 %669
  call fastcc void @combine(ptr noundef %664, ptr noundef %665, ptr noundef %674, ptr noundef %675, ptr noundef %677, ptr noundef %679, i64 noundef %673, i64 noundef %636) #10
  %680 = load ptr, ptr %77, align 8
  %681 = mul nsw i64 %662, %638
  %682 = getelementptr inbounds double, ptr %680, i64 %681
  %683 = load ptr, ptr %101, align 8
  %684 = getelementptr inbounds double, ptr %683, i64 %662
  %685 = load double, ptr %684, align 8
  %686 = insertelement <8 x double> poison, double %685, i64 0
  %687 = shufflevector <8 x double> %686, <8 x double> poison, <8 x i32> zeroinitializer
  %688 = fmul <8 x double> %231, %687
  %689 = fadd <8 x double> %201, %688
  %690 = load ptr, ptr %100, align 8
  %691 = load ptr, ptr %102, align 8
  store <8 x double> %689, ptr %691, align 8
  %692 = load i64, ptr %103, align 8
  %693 = icmp sgt i64 %692, 0
  br i1 %693, label %694, label %695

694:                                              ; preds = %660
  call fastcc void @sample(ptr noundef nonnull %10) #10
  br label %695

695:                                              ; preds = %694, %660
  %696 = load ptr, ptr %10, align 8
  %697 = load i64, ptr %696, align 8
  %698 = load ptr, ptr %102, align 8
  %699 = load ptr, ptr %104, align 8
  %700 = load ptr, ptr %105, align 8
  %701 = inttoptr i64 %697 to ptr
  %702 = load ptr, ptr %701, align 8
  %703 = call i32 %702(ptr noundef %698, ptr noundef %690, ptr noundef %699, ptr noundef %700, ptr noundef %682) #11
  %704 = sext i32 %703 to i64
  %705 = or i64 %661, %704
  %706 = add nsw i64 %662, 1
  %707 = load i64, ptr %644, align 8
  %708 = add nsw i64 %707, %643
  %709 = icmp slt i64 %706, %708
  br i1 %709, label %660, label %649, !llvm.loop !17

710:                                              ; preds = %717, %649
  %711 = getelementptr inbounds i8, ptr %633, i64 8
  %712 = load i64, ptr %711, align 8
  %713 = load i64, ptr %651, align 8
  %714 = getelementptr inbounds i8, ptr %633, i64 24
  %715 = load i64, ptr %714, align 8
  %716 = icmp sgt i64 %715, 3
  br i1 %716, label %745, label %770

717:                                              ; preds = %656, %717
  %718 = phi i64 [ 0, %656 ], [ %740, %717 ]
  %719 = load ptr, ptr %75, align 8
  %720 = shl nsw i64 %718, 6
  %721 = getelementptr inbounds i8, ptr %719, i64 %720
  %722 = load <8 x double>, ptr %721, align 8
  %723 = load ptr, ptr %12, align 8
  %724 = getelementptr inbounds i8, ptr %723, i64 %720
  %725 = load <8 x double>, ptr %724, align 8
  %726 = fsub <8 x double> %722, %725
  %727 = load ptr, ptr %77, align 8
  %728 = getelementptr inbounds i8, ptr %727, i64 %720
  %729 = load <8 x double>, ptr %728, align 8
  %730 = fmul <8 x double> %231, %729
  %731 = fsub <8 x double> %730, %726
  %732 = getelementptr inbounds i8, ptr %642, i64 %720
  store <8 x double> %726, ptr %732, align 8
  %733 = getelementptr inbounds i8, ptr %657, i64 %720
  store <8 x double> %731, ptr %733, align 8
  %734 = fsub <8 x double> %726, %731
  %735 = getelementptr inbounds i8, ptr %641, i64 %720
  %736 = load <8 x double>, ptr %735, align 8
  %737 = fmul <8 x double> %231, %736
  %738 = fsub <8 x double> %734, %737
  %739 = getelementptr inbounds i8, ptr %659, i64 %720
  store <8 x double> %738, ptr %739, align 8
  %740 = add nuw nsw i64 %718, 1
  %741 = load ptr, ptr %10, align 8
  %742 = getelementptr inbounds i8, ptr %741, i64 8
  %743 = load i64, ptr %742, align 8
  %744 = icmp slt i64 %740, %743
  br i1 %744, label %717, label %710, !llvm.loop !18

745:                                              ; preds = %710, %745
  %746 = phi i64 [ %767, %745 ], [ 3, %710 ]
  %747 = mul nsw i64 %746, %638
  %748 = getelementptr inbounds double, ptr %642, i64 %747
  %749 = load ptr, ptr %106, align 8
  %750 = load ptr, ptr %76, align 8
  %751 = getelementptr i64, ptr %750, i64 %643
  %752 = getelementptr i64, ptr %751, i64 %712
  %753 = getelementptr i64, ptr %752, i64 %713
  %754 = getelementptr i64, ptr %753, i64 %746
  %755 = getelementptr i8, ptr %754, i64 -24
  %756 = load i64, ptr %755, align 8
  %757 = getelementptr i8, ptr %754, i64 -16
  %758 = load i64, ptr %757, align 8
  %759 = xor i64 %756, -1
  %760 = add i64 %758, %759
  %761 = load ptr, ptr %63, align 8
  %762 = load ptr, ptr %77, align 8
  %763 = load ptr, ptr %78, align 8
  %764 = getelementptr inbounds i64, ptr %763, i64 %756
  %765 = load ptr, ptr %79, align 8
  %766 = getelementptr inbounds double, ptr %765, i64 %756
  call fastcc void @combine(ptr noundef %748, ptr noundef %749, ptr noundef %761, ptr noundef %762, ptr noundef %764, ptr noundef %766, i64 noundef %760, i64 noundef %636) #10
  %767 = add nuw nsw i64 %746, 1
  %768 = load i64, ptr %714, align 8
  %769 = icmp slt i64 %767, %768
  br i1 %769, label %745, label %770, !llvm.loop !19

770:                                              ; preds = %745, %710
  %771 = and i64 %650, %618
  %772 = icmp eq i64 %771, 0
  br i1 %772, label %777, label %773

773:                                              ; preds = %770
  call fastcc void @retire(ptr noundef %0, i64 noundef %771, i64 noundef 3) #10
  %774 = xor i64 %771, -1
  %775 = and i64 %197, %774
  store i64 %775, ptr %6, align 8
  %776 = and i64 %611, %774
  br label %777

777:                                              ; preds = %773, %770
  %778 = phi i32 [ 1, %773 ], [ %168, %770 ]
  %779 = phi i64 [ %776, %773 ], [ %611, %770 ]
  store <8 x double> %229, ptr %3, align 16
  %780 = icmp eq i64 %779, 0
  br i1 %780, label %783, label %781

781:                                              ; preds = %777
  %782 = call fastcc i64 @look_for_events(ptr noundef %0, ptr noundef nonnull %2, i64 noundef %779, ptr noundef nonnull %3, ptr noundef nonnull %5, ptr noundef nonnull %7, ptr noundef nonnull %4, ptr noundef nonnull %8) #10
  br label %783

783:                                              ; preds = %781, %777
  %784 = phi i64 [ %782, %781 ], [ 0, %777 ]
  %785 = load i64, ptr %8, align 8
  %786 = or i64 %785, %771
  %787 = xor i64 %786, -1
  %788 = and i64 %618, %787
  %789 = icmp eq i64 %784, 0
  %790 = select i1 %789, ptr null, ptr %4
  %791 = call fastcc i64 @write_within(ptr noundef %0, ptr noundef nonnull %2, i64 noundef %788, ptr noundef nonnull %3, ptr noundef %790) #10
  %792 = load <8 x double>, ptr %3, align 16
  br i1 %789, label %798, label %793

793:                                              ; preds = %783
  %794 = xor i64 %791, -1
  %795 = and i64 %784, %794
  %796 = call fastcc i64 @end_within(ptr noundef %0, ptr noundef nonnull %2, i64 noundef %795, ptr noundef nonnull %3, ptr noundef nonnull %4) #10
  %797 = or i64 %796, %791
  br label %798

798:                                              ; preds = %793, %783
  %799 = phi i64 [ %797, %793 ], [ %791, %783 ]
  %800 = icmp ne i64 %799, 0
  %801 = select i1 %48, i1 %800, i1 false
  br i1 %801, label %802, label %807

802:                                              ; preds = %798
  call fastcc void @retire(ptr noundef %0, i64 noundef %799, i64 noundef 6) #10
  %803 = xor i64 %799, -1
  %804 = load i64, ptr %6, align 8
  %805 = and i64 %804, %803
  store i64 %805, ptr %6, align 8
  %806 = and i64 %784, %803
  br label %807

807:                                              ; preds = %802, %798
  %808 = phi i32 [ 1, %802 ], [ %778, %798 ]
  %809 = phi i64 [ %806, %802 ], [ %784, %798 ]
  %810 = or i64 %799, %558
  %811 = or i64 %799, %786
  %812 = xor i64 %811, -1
  %813 = and i64 %603, %812
  br label %814

814:                                              ; preds = %807, %610
  %815 = phi <8 x double> [ %229, %610 ], [ %792, %807 ]
  %816 = phi i64 [ 0, %610 ], [ %785, %807 ]
  %817 = phi i64 [ %558, %610 ], [ %810, %807 ]
  %818 = phi i32 [ %168, %610 ], [ %808, %807 ]
  %819 = phi i64 [ %603, %610 ], [ %813, %807 ]
  %820 = phi i64 [ 0, %610 ], [ %809, %807 ]
  %821 = load ptr, ptr %97, align 8
  %822 = load <8 x double>, ptr %821, align 8
  %823 = fcmp oeq <8 x double> %822, %815
  %824 = bitcast <8 x i1> %823 to i8
  %825 = zext i8 %824 to i64
  %826 = and i64 %819, %825
  %827 = icmp eq i64 %826, 0
  br i1 %827, label %828, label %1080

828:                                              ; preds = %1080, %814
  %829 = trunc nuw i64 %819 to i8
  %830 = bitcast i8 %829 to <8 x i1>
  %831 = load ptr, ptr %59, align 8
  %832 = load <8 x double>, ptr %831, align 8
  %833 = select <8 x i1> %830, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %834 = fadd <8 x double> %833, %832
  store <8 x double> %834, ptr %831, align 8
  %835 = load ptr, ptr %60, align 8
  %836 = load <8 x double>, ptr %835, align 8
  %837 = xor <8 x i1> %830, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %838 = and <8 x i1> %199, %837
  %839 = select <8 x i1> %838, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %840 = fadd <8 x double> %839, %836
  store <8 x double> %840, ptr %835, align 8
  %841 = load ptr, ptr %108, align 8
  %842 = load ptr, ptr %0, align 8
  %843 = getelementptr inbounds i8, ptr %842, i64 8
  %844 = load i64, ptr %843, align 8
  %845 = icmp slt i64 %844, 1
  %846 = xor i64 %819, -1
  %847 = and i64 %197, %846
  %848 = trunc i64 %847 to i8
  %849 = bitcast i8 %848 to <8 x i1>
  %850 = load ptr, ptr %109, align 8
  %851 = load <8 x double>, ptr %850, align 8
  br i1 %845, label %983, label %852

852:                                              ; preds = %828
  %853 = load ptr, ptr %110, align 8
  %854 = load <8 x double>, ptr %853, align 8
  %855 = load ptr, ptr %111, align 8
  %856 = load <8 x double>, ptr %855, align 8
  %857 = fcmp ogt <8 x double> %536, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %858 = bitcast <8 x double> %536 to <8 x i64>
  %859 = select <8 x i1> %857, <8 x i64> %858, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %860 = getelementptr inbounds i8, ptr %841, i64 24
  %861 = load double, ptr %860, align 8
  %862 = insertelement <8 x double> poison, double %861, i64 0
  %863 = shufflevector <8 x double> %862, <8 x double> poison, <8 x i32> zeroinitializer
  %864 = getelementptr inbounds i8, ptr %841, i64 8
  %865 = load double, ptr %864, align 8
  %866 = fneg double %865
  %867 = add <8 x i64> %859, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %868 = ashr <8 x i64> %867, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %869 = and <8 x i64> %867, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %870 = sub <8 x i64> %859, %869
  %871 = bitcast <8 x i64> %870 to <8 x double>
  %872 = fadd <8 x double> %871, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %873 = fadd <8 x double> %871, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %874 = fdiv <8 x double> %872, %873
  %875 = fmul <8 x double> %874, %874
  %876 = call <8 x double> @llvm.fma.v8f64(<8 x double> %875, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %877 = call <8 x double> @llvm.fma.v8f64(<8 x double> %876, <8 x double> %875, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %878 = call <8 x double> @llvm.fma.v8f64(<8 x double> %877, <8 x double> %875, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %879 = call <8 x double> @llvm.fma.v8f64(<8 x double> %878, <8 x double> %875, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %880 = trunc nsw <8 x i64> %868 to <8 x i32>
  %881 = sitofp <8 x i32> %880 to <8 x double>
  %882 = fmul <8 x double> %874, %879
  %883 = fadd <8 x double> %882, %881
  %884 = insertelement <8 x double> poison, double %866, i64 0
  %885 = shufflevector <8 x double> %884, <8 x double> poison, <8 x i32> zeroinitializer
  %886 = fmul <8 x double> %883, %885
  %887 = fcmp ogt <8 x double> %886, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %888 = bitcast <8 x double> %886 to <8 x i64>
  %889 = select <8 x i1> %887, <8 x i64> %888, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %890 = bitcast <8 x i64> %889 to <8 x double>
  %891 = fcmp olt <8 x double> %890, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %892 = bitcast <8 x i64> %889 to <8 x double>
  %893 = select <8 x i1> %891, <8 x double> %892, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %894 = call <8 x double> @llvm.rint.v8f64(<8 x double> %893)
  %895 = fsub <8 x double> %893, %894
  %896 = call <8 x double> @llvm.fma.v8f64(<8 x double> %895, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %897 = call <8 x double> @llvm.fma.v8f64(<8 x double> %896, <8 x double> %895, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %898 = call <8 x double> @llvm.fma.v8f64(<8 x double> %897, <8 x double> %895, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %899 = call <8 x double> @llvm.fma.v8f64(<8 x double> %898, <8 x double> %895, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %900 = call <8 x double> @llvm.fma.v8f64(<8 x double> %899, <8 x double> %895, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %901 = call <8 x double> @llvm.fma.v8f64(<8 x double> %900, <8 x double> %895, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %902 = call <8 x double> @llvm.fma.v8f64(<8 x double> %901, <8 x double> %895, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %903 = bitcast <8 x double> %902 to <8 x i64>
  %904 = fptosi <8 x double> %894 to <8 x i32>
  %905 = zext <8 x i32> %904 to <8 x i64>
  %906 = shl <8 x i64> %905, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %907 = add <8 x i64> %906, %903
  %908 = bitcast <8 x i64> %907 to <8 x double>
  %909 = fmul <8 x double> %863, %908
  %910 = getelementptr inbounds i8, ptr %841, i64 16
  %911 = load double, ptr %910, align 8
  %912 = fcmp une double %911, 0.000000e+00
  br i1 %912, label %913, label %958

913:                                              ; preds = %852
  %914 = bitcast <8 x double> %854 to <8 x i64>
  %915 = add <8 x i64> %914, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %916 = ashr <8 x i64> %915, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %917 = and <8 x i64> %915, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %918 = sub <8 x i64> %914, %917
  %919 = bitcast <8 x i64> %918 to <8 x double>
  %920 = fadd <8 x double> %919, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %921 = fadd <8 x double> %919, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %922 = fdiv <8 x double> %920, %921
  %923 = fmul <8 x double> %922, %922
  %924 = call <8 x double> @llvm.fma.v8f64(<8 x double> %923, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %925 = call <8 x double> @llvm.fma.v8f64(<8 x double> %924, <8 x double> %923, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %926 = call <8 x double> @llvm.fma.v8f64(<8 x double> %925, <8 x double> %923, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %927 = call <8 x double> @llvm.fma.v8f64(<8 x double> %926, <8 x double> %923, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %928 = trunc nsw <8 x i64> %916 to <8 x i32>
  %929 = sitofp <8 x i32> %928 to <8 x double>
  %930 = fmul <8 x double> %922, %927
  %931 = fadd <8 x double> %930, %929
  %932 = insertelement <8 x double> poison, double %911, i64 0
  %933 = shufflevector <8 x double> %932, <8 x double> poison, <8 x i32> zeroinitializer
  %934 = fmul <8 x double> %933, %931
  %935 = fcmp ogt <8 x double> %934, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %936 = bitcast <8 x double> %934 to <8 x i64>
  %937 = select <8 x i1> %935, <8 x i64> %936, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %938 = bitcast <8 x i64> %937 to <8 x double>
  %939 = fcmp olt <8 x double> %938, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %940 = bitcast <8 x i64> %937 to <8 x double>
  %941 = select <8 x i1> %939, <8 x double> %940, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %942 = call <8 x double> @llvm.rint.v8f64(<8 x double> %941)
  %943 = fsub <8 x double> %941, %942
  %944 = call <8 x double> @llvm.fma.v8f64(<8 x double> %943, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %945 = call <8 x double> @llvm.fma.v8f64(<8 x double> %944, <8 x double> %943, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %946 = call <8 x double> @llvm.fma.v8f64(<8 x double> %945, <8 x double> %943, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %947 = call <8 x double> @llvm.fma.v8f64(<8 x double> %946, <8 x double> %943, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %948 = call <8 x double> @llvm.fma.v8f64(<8 x double> %947, <8 x double> %943, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %949 = call <8 x double> @llvm.fma.v8f64(<8 x double> %948, <8 x double> %943, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %950 = call <8 x double> @llvm.fma.v8f64(<8 x double> %949, <8 x double> %943, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %951 = bitcast <8 x double> %950 to <8 x i64>
  %952 = fptosi <8 x double> %942 to <8 x i32>
  %953 = zext <8 x i32> %952 to <8 x i64>
  %954 = shl <8 x i64> %953, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %955 = add <8 x i64> %954, %951
  %956 = bitcast <8 x i64> %955 to <8 x double>
  %957 = fmul <8 x double> %909, %956
  br label %958

958:                                              ; preds = %852, %913
  %959 = phi <8 x double> [ %957, %913 ], [ %909, %852 ]
  %960 = getelementptr inbounds i8, ptr %841, i64 32
  %961 = load double, ptr %960, align 8
  %962 = insertelement <8 x double> poison, double %961, i64 0
  %963 = shufflevector <8 x double> %962, <8 x double> poison, <8 x i32> zeroinitializer
  %964 = fcmp ogt <8 x double> %959, %963
  %965 = select <8 x i1> %964, <8 x double> %959, <8 x double> %963
  %966 = fcmp olt <8 x double> %856, %965
  %967 = select <8 x i1> %966, <8 x double> %856, <8 x double> %965
  %968 = fmul <8 x double> %231, %967
  %969 = fcmp oeq <8 x double> %815, %209
  %970 = fcmp ogt <8 x double> %851, %968
  %971 = select <8 x i1> %969, <8 x i1> %970, <8 x i1> zeroinitializer
  %972 = select <8 x i1> %971, <8 x double> %851, <8 x double> %968
  %973 = fcmp ogt <8 x double> %536, <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>
  %974 = select <8 x i1> %973, <8 x i64> %858, <8 x i64> <i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789>
  %975 = bitcast <8 x double> %854 to <8 x i64>
  %976 = select <8 x i1> %830, <8 x i64> %974, <8 x i64> %975
  store <8 x i64> %976, ptr %853, align 8
  %977 = load ptr, ptr %111, align 8
  %978 = getelementptr inbounds i8, ptr %841, i64 40
  %979 = load double, ptr %978, align 8
  %980 = insertelement <8 x double> poison, double %979, i64 0
  %981 = shufflevector <8 x double> %980, <8 x double> poison, <8 x i32> zeroinitializer
  %982 = select <8 x i1> %849, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> %981
  store <8 x double> %982, ptr %977, align 8
  br label %983

983:                                              ; preds = %958, %828
  %984 = phi <8 x double> [ %851, %828 ], [ %972, %958 ]
  %985 = and i64 %847, 255
  %986 = icmp eq i64 %985, 0
  br i1 %986, label %1075, label %987

987:                                              ; preds = %983
  %988 = trunc i64 %602 to i8
  %989 = bitcast i8 %988 to <8 x i1>
  %990 = trunc i64 %817 to i8
  %991 = bitcast i8 %990 to <8 x i1>
  %992 = trunc i64 %816 to i8
  %993 = bitcast i8 %992 to <8 x i1>
  %994 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %536)
  %995 = fcmp one <8 x double> %994, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %996 = xor <8 x i1> %989, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %997 = select <8 x i1> %995, <8 x i1> %996, <8 x i1> zeroinitializer
  %998 = or <8 x i1> %991, %993
  %999 = xor <8 x i1> %998, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1000 = and <8 x i1> %997, %999
  br i1 %845, label %1062, label %1001

1001:                                             ; preds = %987
  %1002 = fcmp ogt <8 x double> %536, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1003 = bitcast <8 x double> %536 to <8 x i64>
  %1004 = select <8 x i1> %1002, <8 x i64> %1003, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %1005 = getelementptr inbounds i8, ptr %841, i64 24
  %1006 = load double, ptr %1005, align 8
  %1007 = insertelement <8 x double> poison, double %1006, i64 0
  %1008 = shufflevector <8 x double> %1007, <8 x double> poison, <8 x i32> zeroinitializer
  %1009 = load double, ptr %841, align 8
  %1010 = fneg double %1009
  %1011 = add <8 x i64> %1004, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %1012 = ashr <8 x i64> %1011, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1013 = and <8 x i64> %1011, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %1014 = sub <8 x i64> %1004, %1013
  %1015 = bitcast <8 x i64> %1014 to <8 x double>
  %1016 = fadd <8 x double> %1015, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %1017 = fadd <8 x double> %1015, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1018 = fdiv <8 x double> %1016, %1017
  %1019 = fmul <8 x double> %1018, %1018
  %1020 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1019, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %1021 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1020, <8 x double> %1019, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %1022 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1021, <8 x double> %1019, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %1023 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1022, <8 x double> %1019, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %1024 = trunc nsw <8 x i64> %1012 to <8 x i32>
  %1025 = sitofp <8 x i32> %1024 to <8 x double>
  %1026 = fmul <8 x double> %1018, %1023
  %1027 = fadd <8 x double> %1026, %1025
  %1028 = insertelement <8 x double> poison, double %1010, i64 0
  %1029 = shufflevector <8 x double> %1028, <8 x double> poison, <8 x i32> zeroinitializer
  %1030 = fmul <8 x double> %1027, %1029
  %1031 = fcmp ogt <8 x double> %1030, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1032 = bitcast <8 x double> %1030 to <8 x i64>
  %1033 = select <8 x i1> %1031, <8 x i64> %1032, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1034 = bitcast <8 x i64> %1033 to <8 x double>
  %1035 = fcmp olt <8 x double> %1034, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1036 = bitcast <8 x i64> %1033 to <8 x double>
  %1037 = select <8 x i1> %1035, <8 x double> %1036, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1038 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1037)
  %1039 = fsub <8 x double> %1037, %1038
  %1040 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1039, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1041 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1040, <8 x double> %1039, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1042 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1041, <8 x double> %1039, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1043 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1042, <8 x double> %1039, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1044 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1043, <8 x double> %1039, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1045 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1044, <8 x double> %1039, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1046 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1045, <8 x double> %1039, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1047 = bitcast <8 x double> %1046 to <8 x i64>
  %1048 = fptosi <8 x double> %1038 to <8 x i32>
  %1049 = zext <8 x i32> %1048 to <8 x i64>
  %1050 = shl <8 x i64> %1049, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1051 = add <8 x i64> %1050, %1047
  %1052 = bitcast <8 x i64> %1051 to <8 x double>
  %1053 = fmul <8 x double> %1008, %1052
  %1054 = getelementptr inbounds i8, ptr %841, i64 32
  %1055 = load double, ptr %1054, align 8
  %1056 = insertelement <8 x double> poison, double %1055, i64 0
  %1057 = shufflevector <8 x double> %1056, <8 x double> poison, <8 x i32> zeroinitializer
  %1058 = fcmp ogt <8 x double> %1053, %1057
  %1059 = select <8 x i1> %1058, <8 x double> %1053, <8 x double> %1057
  %1060 = select <8 x i1> %1000, <8 x double> %1059, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1061 = fmul <8 x double> %231, %1060
  br label %1062

1062:                                             ; preds = %1001, %987
  %1063 = phi <8 x double> [ zeroinitializer, %987 ], [ %1061, %1001 ]
  %1064 = or <8 x i1> %1000, %993
  %1065 = select <8 x i1> %1064, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %1066 = select <8 x i1> %849, <8 x double> %1063, <8 x double> %984
  %1067 = load ptr, ptr %112, align 8
  %1068 = select <8 x i1> %991, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> %1065
  %1069 = load <8 x i64>, ptr %1067, align 8
  %1070 = select <8 x i1> %849, <8 x i64> %1068, <8 x i64> %1069
  store <8 x i64> %1070, ptr %1067, align 8
  %1071 = load ptr, ptr %112, align 8
  %1072 = select <8 x i1> %989, <8 x i64> <i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152>, <8 x i64> %1065
  %1073 = load <8 x i64>, ptr %1071, align 8
  %1074 = select <8 x i1> %849, <8 x i64> %1072, <8 x i64> %1073
  store <8 x i64> %1074, ptr %1071, align 8
  br label %1075

1075:                                             ; preds = %983, %1062
  %1076 = phi <8 x double> [ %984, %983 ], [ %1066, %1062 ]
  %1077 = load ptr, ptr %109, align 8
  store <8 x double> %1076, ptr %1077, align 8
  %1078 = load ptr, ptr %44, align 8
  %1079 = select <8 x i1> %830, <8 x double> %815, <8 x double> %201
  store <8 x double> %1079, ptr %1078, align 8
  br i1 %113, label %1097, label %1090

1080:                                             ; preds = %814, %1080
  %1081 = phi i64 [ %1088, %1080 ], [ %826, %814 ]
  %1082 = load ptr, ptr %107, align 8
  call fastcc void @write_outputs(ptr noundef %0, ptr noundef %1082, i64 noundef %1081) #10
  %1083 = load ptr, ptr %97, align 8
  %1084 = load <8 x double>, ptr %1083, align 8
  %1085 = fcmp oeq <8 x double> %1084, %815
  %1086 = bitcast <8 x i1> %1085 to i8
  %1087 = zext i8 %1086 to i64
  %1088 = and i64 %1081, %1087
  %1089 = icmp eq i64 %1088, 0
  br i1 %1089, label %828, label %1080, !llvm.loop !20

1090:                                             ; preds = %1097, %1075
  %1091 = load ptr, ptr %115, align 8
  %1092 = load ptr, ptr %0, align 8
  %1093 = load i64, ptr %1092, align 8
  %1094 = load i64, ptr %116, align 8
  %1095 = mul nsw i64 %1094, %1093
  %1096 = getelementptr inbounds double, ptr %1091, i64 %1095
  br i1 %117, label %1111, label %1109

1097:                                             ; preds = %1075, %1097
  %1098 = phi i64 [ %1107, %1097 ], [ 0, %1075 ]
  %1099 = load ptr, ptr %12, align 8
  %1100 = load ptr, ptr %114, align 8
  %1101 = shl nsw i64 %1098, 6
  %1102 = getelementptr inbounds i8, ptr %1100, i64 %1101
  %1103 = load <8 x i64>, ptr %1102, align 8
  %1104 = getelementptr inbounds i8, ptr %1099, i64 %1101
  %1105 = load <8 x i64>, ptr %1104, align 8
  %1106 = select <8 x i1> %830, <8 x i64> %1103, <8 x i64> %1105
  store <8 x i64> %1106, ptr %1104, align 8
  %1107 = add nuw nsw i64 %1098, 1
  %1108 = icmp eq i64 %1107, %16
  br i1 %1108, label %1090, label %1097, !llvm.loop !21

1109:                                             ; preds = %1111, %1090
  %1110 = icmp eq i64 %820, 0
  br i1 %1110, label %1132, label %1122

1111:                                             ; preds = %1090, %1111
  %1112 = phi i64 [ %1120, %1111 ], [ 0, %1090 ]
  %1113 = load ptr, ptr %115, align 8
  %1114 = shl nsw i64 %1112, 6
  %1115 = getelementptr inbounds i8, ptr %1096, i64 %1114
  %1116 = load <8 x i64>, ptr %1115, align 8
  %1117 = getelementptr inbounds i8, ptr %1113, i64 %1114
  %1118 = load <8 x i64>, ptr %1117, align 8
  %1119 = select <8 x i1> %830, <8 x i64> %1116, <8 x i64> %1118
  store <8 x i64> %1119, ptr %1117, align 8
  %1120 = add nuw nsw i64 %1112, 1
  %1121 = icmp eq i64 %1120, %16
  br i1 %1121, label %1109, label %1111, !llvm.loop !22

1122:                                             ; preds = %1109
  %1123 = call fastcc i64 @act_in_lanes(ptr noundef %0, i64 noundef %820, ptr noundef nonnull %7) #10
  %1124 = icmp ne i32 %818, 0
  %1125 = icmp ne i64 %1123, %820
  %1126 = select i1 %1124, i1 true, i1 %1125
  %1127 = zext i1 %1126 to i32
  %1128 = trunc i64 %820 to i8
  %1129 = bitcast i8 %1128 to <8 x i1>
  %1130 = xor <8 x i1> %1129, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1131 = and <8 x i1> %1130, %830
  br label %1132

1132:                                             ; preds = %1122, %1109
  %1133 = phi i32 [ %1127, %1122 ], [ %818, %1109 ]
  %1134 = phi <8 x i1> [ %1131, %1122 ], [ %830, %1109 ]
  %1135 = phi i64 [ %1123, %1122 ], [ %169, %1109 ]
  %1136 = load ptr, ptr %97, align 8
  %1137 = load <8 x double>, ptr %1136, align 8
  %1138 = fcmp oeq <8 x double> %1137, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1139 = select <8 x i1> %1138, <8 x i1> %1134, <8 x i1> zeroinitializer
  %1140 = bitcast <8 x i1> %1139 to i8
  %1141 = zext i8 %1140 to i64
  %1142 = icmp eq i8 %1140, 0
  br i1 %1142, label %1144, label %1143

1143:                                             ; preds = %1132
  call fastcc void @retire(ptr noundef %0, i64 noundef %1141, i64 noundef 0) #10
  br label %1144

1144:                                             ; preds = %1143, %1132
  %1145 = phi i32 [ 1, %1143 ], [ %1133, %1132 ]
  %1146 = fcmp oeq <8 x double> %815, %207
  %1147 = select <8 x i1> %1146, <8 x i1> %1134, <8 x i1> zeroinitializer
  %1148 = bitcast <8 x i1> %1147 to i8
  %1149 = zext i8 %1148 to i64
  %1150 = xor i64 %1141, -1
  %1151 = and i64 %1150, %1149
  %1152 = icmp eq i64 %1151, 0
  br i1 %1152, label %1157, label %1153

1153:                                             ; preds = %1144
  %1154 = call fastcc i64 @start_again(ptr noundef %0, ptr noundef nonnull %2, i64 noundef %1151) #10
  %1155 = icmp eq i64 %1154, 0
  %1156 = select i1 %1155, i32 %1145, i32 1
  br label %1157

1157:                                             ; preds = %1153, %1144
  %1158 = phi i32 [ %1145, %1144 ], [ %1156, %1153 ]
  br label %164

1159:                                             ; preds = %167, %192, %160
  %1160 = phi i64 [ 1, %160 ], [ 0, %192 ], [ 0, %167 ]
  ret i64 %1160
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
  br i1 %72, label %78, label %73, !llvm.loop !23

73:                                               ; preds = %47, %65
  %74 = phi i64 [ %75, %65 ], [ %44, %47 ]
  %75 = add nsw i64 %74, 1
  store i64 %75, ptr %6, align 8
  %76 = load i64, ptr %8, align 8
  %77 = icmp sge i64 %75, %76
  br i1 %77, label %78, label %65, !llvm.loop !23

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
  br i1 %105, label %97, label %106, !llvm.loop !24

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
  br i1 %122, label %114, label %123, !llvm.loop !24

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
  br i1 %139, label %131, label %140, !llvm.loop !24

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
  br i1 %161, label %153, label %162, !llvm.loop !24

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
  br i1 %189, label %177, label %174, !llvm.loop !26

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
  br i1 %217, label %198, label %190, !llvm.loop !27

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
  br i1 %245, label %218, label %263, !llvm.loop !28

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
  br i1 %262, label %232, label %246, !llvm.loop !29

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
  br i1 %285, label %55, label %39, !llvm.loop !30

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
  br i1 %308, label %293, label %389, !llvm.loop !31

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
  br i1 %329, label %330, label %321, !llvm.loop !32

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
  br i1 %344, label %345, label %336, !llvm.loop !32

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
  br i1 %359, label %360, label %351, !llvm.loop !32

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
  br i1 %374, label %375, label %366, !llvm.loop !32

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
  br i1 %388, label %286, label %309, !llvm.loop !33

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
  br label %56

50:                                               ; preds = %56, %31
  %51 = getelementptr inbounds i8, ptr %0, i64 1008
  %52 = load ptr, ptr %51, align 8
  %53 = getelementptr inbounds i8, ptr %52, i64 8
  %54 = load double, ptr %53, align 8
  %55 = fcmp oeq double %54, 0.000000e+00
  br i1 %55, label %78, label %72

56:                                               ; preds = %48, %56
  %57 = phi i64 [ 0, %48 ], [ %66, %56 ]
  %58 = load ptr, ptr %49, align 8
  %59 = load ptr, ptr %23, align 8
  %60 = shl nsw i64 %57, 6
  %61 = getelementptr inbounds i8, ptr %59, i64 %60
  %62 = load <8 x i64>, ptr %61, align 8
  %63 = getelementptr inbounds i8, ptr %58, i64 %60
  %64 = load <8 x i64>, ptr %63, align 8
  %65 = select <8 x i1> %17, <8 x i64> %62, <8 x i64> %64
  store <8 x i64> %65, ptr %63, align 8
  %66 = add nuw nsw i64 %57, 1
  %67 = load ptr, ptr %20, align 8
  %68 = load ptr, ptr %67, align 8
  %69 = getelementptr inbounds i8, ptr %68, i64 8
  %70 = load i64, ptr %69, align 8
  %71 = icmp slt i64 %66, %70
  br i1 %71, label %56, label %50, !llvm.loop !34

72:                                               ; preds = %50
  %73 = load ptr, ptr %0, align 8
  %74 = getelementptr inbounds i8, ptr %73, i64 8
  %75 = load i64, ptr %74, align 8
  %76 = icmp sgt i64 %75, 0
  %77 = select i1 %76, i64 %3, i64 0
  br label %78

78:                                               ; preds = %50, %72
  %79 = phi i64 [ %77, %72 ], [ %15, %50 ]
  %80 = getelementptr inbounds i8, ptr %0, i64 720
  %81 = load ptr, ptr %80, align 8
  %82 = insertelement <8 x double> poison, double %54, i64 0
  %83 = load <8 x i64>, ptr %81, align 8
  %84 = bitcast <8 x double> %82 to <8 x i64>
  %85 = shufflevector <8 x i64> %84, <8 x i64> poison, <8 x i32> zeroinitializer
  %86 = select <8 x i1> %17, <8 x i64> %85, <8 x i64> %83
  store <8 x i64> %86, ptr %81, align 8
  %87 = getelementptr inbounds i8, ptr %0, i64 744
  %88 = load ptr, ptr %87, align 8
  %89 = load <8 x double>, ptr %88, align 8
  %90 = select <8 x i1> %17, <8 x double> <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>, <8 x double> %89
  store <8 x double> %90, ptr %88, align 8
  %91 = getelementptr inbounds i8, ptr %0, i64 768
  %92 = load ptr, ptr %91, align 8
  %93 = load ptr, ptr %1, align 8
  %94 = getelementptr inbounds i8, ptr %93, i64 120
  %95 = load ptr, ptr %94, align 8
  %96 = getelementptr inbounds i8, ptr %95, i64 40
  %97 = load double, ptr %96, align 8
  %98 = insertelement <8 x double> poison, double %97, i64 0
  %99 = load <8 x i64>, ptr %92, align 8
  %100 = bitcast <8 x double> %98 to <8 x i64>
  %101 = shufflevector <8 x i64> %100, <8 x i64> poison, <8 x i32> zeroinitializer
  %102 = select <8 x i1> %17, <8 x i64> %101, <8 x i64> %99
  store <8 x i64> %102, ptr %92, align 8
  %103 = icmp eq i64 %79, 0
  br i1 %103, label %280, label %104

104:                                              ; preds = %78
  %105 = load ptr, ptr %80, align 8
  %106 = trunc i64 %79 to i8
  %107 = bitcast i8 %106 to <8 x i1>
  %108 = load ptr, ptr %51, align 8
  %109 = load double, ptr %108, align 8
  %110 = load ptr, ptr %11, align 8
  %111 = load ptr, ptr %20, align 8
  %112 = load ptr, ptr %111, align 8
  %113 = getelementptr inbounds i8, ptr %112, i64 24
  %114 = load i64, ptr %113, align 8
  %115 = load ptr, ptr %110, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %115, ptr noundef %115, ptr noundef nonnull %110, i64 noundef %114) #10
  %116 = load <8 x double>, ptr %5, align 16
  %117 = getelementptr inbounds i8, ptr %110, i64 168
  %118 = load ptr, ptr %117, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %118, ptr noundef %115, ptr noundef nonnull %110, i64 noundef %114) #10
  %119 = load <8 x double>, ptr %6, align 16
  %120 = fcmp olt <8 x double> %116, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %121 = fcmp olt <8 x double> %119, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %122 = or <8 x i1> %121, %120
  %123 = insertelement <8 x double> poison, double %109, i64 0
  %124 = shufflevector <8 x double> %123, <8 x double> poison, <8 x i32> zeroinitializer
  %125 = fmul <8 x double> %116, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %126 = fdiv <8 x double> %125, %119
  %127 = bitcast <8 x double> %126 to <8 x i64>
  %128 = select <8 x i1> %122, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %127
  %129 = bitcast <8 x i64> %128 to <8 x double>
  %130 = fcmp olt <8 x double> %124, %129
  %131 = bitcast <8 x double> %124 to <8 x i64>
  %132 = select <8 x i1> %130, <8 x i64> %131, <8 x i64> %128
  %133 = bitcast <8 x i64> %132 to <8 x double>
  %134 = load ptr, ptr %20, align 8
  %135 = load ptr, ptr %134, align 8
  %136 = getelementptr inbounds i8, ptr %135, i64 8
  %137 = load i64, ptr %136, align 8
  %138 = icmp sgt i64 %137, 0
  br i1 %138, label %139, label %141

139:                                              ; preds = %104
  %140 = getelementptr inbounds i8, ptr %110, i64 48
  br label %156

141:                                              ; preds = %156, %104
  %142 = phi ptr [ %134, %104 ], [ %170, %156 ]
  %143 = fadd <8 x double> %19, %133
  %144 = getelementptr inbounds i8, ptr %110, i64 48
  %145 = load ptr, ptr %144, align 8
  %146 = load ptr, ptr %117, align 8
  %147 = getelementptr inbounds i8, ptr %110, i64 8
  %148 = load i64, ptr %147, align 8
  %149 = getelementptr inbounds double, ptr %146, i64 %148
  %150 = getelementptr inbounds i8, ptr %142, i64 24
  %151 = load ptr, ptr %150, align 8
  store <8 x double> %143, ptr %151, align 8
  %152 = getelementptr inbounds i8, ptr %142, i64 152
  %153 = load i64, ptr %152, align 8
  %154 = icmp sgt i64 %153, 0
  br i1 %154, label %155, label %175

155:                                              ; preds = %141
  tail call fastcc void @sample(ptr noundef nonnull %142) #10
  br label %175

156:                                              ; preds = %139, %156
  %157 = phi i64 [ 0, %139 ], [ %169, %156 ]
  %158 = load ptr, ptr %140, align 8
  %159 = load ptr, ptr %110, align 8
  %160 = shl nsw i64 %157, 6
  %161 = getelementptr inbounds i8, ptr %159, i64 %160
  %162 = load <8 x double>, ptr %161, align 8
  %163 = load ptr, ptr %117, align 8
  %164 = getelementptr inbounds i8, ptr %163, i64 %160
  %165 = load <8 x double>, ptr %164, align 8
  %166 = fmul <8 x double> %165, %133
  %167 = fadd <8 x double> %162, %166
  %168 = getelementptr inbounds i8, ptr %158, i64 %160
  store <8 x double> %167, ptr %168, align 8
  %169 = add nuw nsw i64 %157, 1
  %170 = load ptr, ptr %20, align 8
  %171 = load ptr, ptr %170, align 8
  %172 = getelementptr inbounds i8, ptr %171, i64 8
  %173 = load i64, ptr %172, align 8
  %174 = icmp slt i64 %169, %173
  br i1 %174, label %156, label %141, !llvm.loop !35

175:                                              ; preds = %141, %155
  %176 = load ptr, ptr %142, align 8
  %177 = load i64, ptr %176, align 8
  %178 = load ptr, ptr %150, align 8
  %179 = getelementptr inbounds i8, ptr %142, i64 48
  %180 = load ptr, ptr %179, align 8
  %181 = getelementptr inbounds i8, ptr %142, i64 96
  %182 = load ptr, ptr %181, align 8
  %183 = inttoptr i64 %177 to ptr
  %184 = load ptr, ptr %183, align 8
  %185 = tail call i32 %184(ptr noundef %178, ptr noundef %145, ptr noundef %180, ptr noundef %182, ptr noundef %149) #11
  %186 = load ptr, ptr %1, align 8
  %187 = getelementptr inbounds i8, ptr %186, i64 120
  %188 = load ptr, ptr %187, align 8
  %189 = load double, ptr %188, align 8
  %190 = load ptr, ptr %117, align 8
  %191 = load i64, ptr %147, align 8
  %192 = getelementptr inbounds double, ptr %190, i64 %191
  %193 = icmp sgt i64 %114, 0
  br i1 %193, label %194, label %204

194:                                              ; preds = %175, %194
  %195 = phi i64 [ %202, %194 ], [ 0, %175 ]
  %196 = shl nsw i64 %195, 6
  %197 = getelementptr inbounds i8, ptr %192, i64 %196
  %198 = load <8 x double>, ptr %197, align 8
  %199 = getelementptr inbounds i8, ptr %190, i64 %196
  %200 = load <8 x double>, ptr %199, align 8
  %201 = fsub <8 x double> %198, %200
  store <8 x double> %201, ptr %197, align 8
  %202 = add nuw nsw i64 %195, 1
  %203 = icmp eq i64 %202, %114
  br i1 %203, label %204, label %194, !llvm.loop !36

204:                                              ; preds = %194, %175
  %205 = load ptr, ptr %110, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %192, ptr noundef %205, ptr noundef nonnull %110, i64 noundef %114) #10
  %206 = load <8 x double>, ptr %7, align 16
  %207 = fdiv <8 x double> %206, %133
  %208 = fcmp ogt <8 x double> %119, %207
  %209 = select <8 x i1> %208, <8 x double> %119, <8 x double> %207
  %210 = fcmp ogt <8 x double> %209, <double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15, double 1.000000e-15>
  %211 = fdiv <8 x double> <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>, %209
  %212 = select <8 x i1> %210, <8 x double> %211, <8 x double> <double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13, double 1.000000e+13>
  %213 = bitcast <8 x double> %212 to <8 x i64>
  %214 = add <8 x i64> %213, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %215 = ashr <8 x i64> %214, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %216 = and <8 x i64> %214, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %217 = sub <8 x i64> %213, %216
  %218 = bitcast <8 x i64> %217 to <8 x double>
  %219 = fadd <8 x double> %218, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %220 = fadd <8 x double> %218, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %221 = fdiv <8 x double> %219, %220
  %222 = fmul <8 x double> %221, %221
  %223 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %222, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %224 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %223, <8 x double> %222, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %225 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %224, <8 x double> %222, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %226 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %225, <8 x double> %222, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %227 = trunc nsw <8 x i64> %215 to <8 x i32>
  %228 = sitofp <8 x i32> %227 to <8 x double>
  %229 = fmul <8 x double> %221, %226
  %230 = fadd <8 x double> %229, %228
  %231 = insertelement <8 x double> poison, double %189, i64 0
  %232 = shufflevector <8 x double> %231, <8 x double> poison, <8 x i32> zeroinitializer
  %233 = fmul <8 x double> %232, %230
  %234 = fcmp ogt <8 x double> %233, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %235 = bitcast <8 x double> %233 to <8 x i64>
  %236 = select <8 x i1> %234, <8 x i64> %235, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %237 = bitcast <8 x i64> %236 to <8 x double>
  %238 = fcmp olt <8 x double> %237, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %239 = bitcast <8 x i64> %236 to <8 x double>
  %240 = select <8 x i1> %238, <8 x double> %239, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %241 = tail call <8 x double> @llvm.rint.v8f64(<8 x double> %240)
  %242 = fsub <8 x double> %240, %241
  %243 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %242, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %244 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %243, <8 x double> %242, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %245 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %244, <8 x double> %242, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %246 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %245, <8 x double> %242, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %247 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %246, <8 x double> %242, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %248 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %247, <8 x double> %242, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %249 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %248, <8 x double> %242, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %250 = bitcast <8 x double> %249 to <8 x i64>
  %251 = fptosi <8 x double> %241 to <8 x i32>
  %252 = zext <8 x i32> %251 to <8 x i64>
  %253 = shl <8 x i64> %252, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %254 = add <8 x i64> %253, %250
  %255 = fmul <8 x double> %133, <double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03, double 1.000000e-03>
  %256 = fcmp olt <8 x double> %255, <double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D, double 0x3EB0C6F7A0B5ED8D>
  %257 = bitcast <8 x double> %255 to <8 x i64>
  %258 = select <8 x i1> %256, <8 x i64> <i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637, i64 4517329193108106637>, <8 x i64> %257
  %259 = fmul <8 x double> %133, <double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02, double 1.000000e+02>
  %260 = select <8 x i1> %210, <8 x i64> %254, <8 x i64> %258
  %261 = bitcast <8 x i64> %260 to <8 x double>
  %262 = fcmp olt <8 x double> %259, %261
  %263 = bitcast <8 x double> %259 to <8 x i64>
  %264 = select <8 x i1> %262, <8 x i64> %263, <8 x i64> %260
  %265 = bitcast <8 x i64> %264 to <8 x double>
  %266 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %19)
  %267 = fmul <8 x double> %266, <double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000, double 0x3D30000000000000>
  %268 = fcmp ogt <8 x double> %267, %265
  %269 = bitcast <8 x double> %267 to <8 x i64>
  %270 = select <8 x i1> %268, <8 x i64> %269, <8 x i64> %264
  %271 = bitcast <8 x i64> %270 to <8 x double>
  %272 = fcmp olt <8 x double> %124, %271
  %273 = select <8 x i1> %272, <8 x i64> %131, <8 x i64> %270
  %274 = trunc i32 %185 to i8
  %275 = bitcast i8 %274 to <8 x i1>
  %276 = select <8 x i1> %275, <8 x i64> %257, <8 x i64> %273
  %277 = load ptr, ptr %80, align 8
  %278 = load <8 x i64>, ptr %277, align 8
  %279 = select <8 x i1> %107, <8 x i64> %276, <8 x i64> %278
  store <8 x i64> %279, ptr %105, align 8
  br label %280

280:                                              ; preds = %78, %204
  %281 = getelementptr inbounds i8, ptr %0, i64 840
  %282 = load ptr, ptr %281, align 8
  %283 = load <8 x double>, ptr %282, align 8
  %284 = select <8 x i1> %14, <8 x double> zeroinitializer, <8 x double> %283
  store <8 x double> %284, ptr %282, align 8
  %285 = getelementptr inbounds i8, ptr %0, i64 864
  %286 = load ptr, ptr %285, align 8
  %287 = load <8 x double>, ptr %286, align 8
  %288 = select <8 x i1> %14, <8 x double> zeroinitializer, <8 x double> %287
  store <8 x double> %288, ptr %286, align 8
  %289 = getelementptr inbounds i8, ptr %0, i64 888
  %290 = load ptr, ptr %289, align 8
  %291 = load <8 x double>, ptr %290, align 8
  %292 = select <8 x i1> %14, <8 x double> zeroinitializer, <8 x double> %291
  store <8 x double> %292, ptr %290, align 8
  %293 = getelementptr inbounds i8, ptr %0, i64 912
  %294 = load ptr, ptr %293, align 8
  %295 = load ptr, ptr %80, align 8
  %296 = load <8 x double>, ptr %295, align 8
  %297 = tail call <8 x i1> @llvm.is.fpclass.v8f64(<8 x double> %296, i32 384)
  %298 = select <8 x i1> %297, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %299 = load <8 x i64>, ptr %294, align 8
  %300 = select <8 x i1> %17, <8 x i64> %298, <8 x i64> %299
  store <8 x i64> %300, ptr %294, align 8
  %301 = icmp eq i64 %2, 0
  br i1 %301, label %334, label %302

302:                                              ; preds = %280
  %303 = getelementptr inbounds i8, ptr %0, i64 936
  %304 = getelementptr inbounds i8, ptr %0, i64 1032
  %305 = getelementptr inbounds i8, ptr %0, i64 1040
  %306 = getelementptr inbounds i8, ptr %0, i64 792
  %307 = getelementptr inbounds i8, ptr %0, i64 816
  %308 = getelementptr inbounds i8, ptr %0, i64 960
  br label %309

309:                                              ; preds = %302, %309
  %310 = phi i64 [ %2, %302 ], [ %332, %309 ]
  %311 = tail call range(i64 0, 65) i64 @llvm.cttz.i64(i64 %310, i1 true)
  %312 = load ptr, ptr %303, align 8
  %313 = getelementptr inbounds i64, ptr %312, i64 %311
  %314 = load i64, ptr %313, align 8
  %315 = load i64, ptr %305, align 8
  %316 = add nsw i64 %315, -1
  %317 = load ptr, ptr %306, align 8
  %318 = getelementptr inbounds double, ptr %317, i64 %311
  store double 0.000000e+00, ptr %318, align 8
  %319 = load ptr, ptr %304, align 8
  %320 = load double, ptr %319, align 8
  %321 = load ptr, ptr %307, align 8
  %322 = getelementptr inbounds double, ptr %321, i64 %311
  store double %320, ptr %322, align 8
  %323 = load ptr, ptr %10, align 8
  %324 = getelementptr inbounds i8, ptr %323, i64 24
  %325 = load i64, ptr %324, align 8
  %326 = shl i64 %314, 3
  %327 = mul i64 %326, %316
  %328 = add nsw i64 %325, %327
  %329 = load ptr, ptr %308, align 8
  %330 = getelementptr inbounds i64, ptr %329, i64 %311
  store i64 %328, ptr %330, align 8
  %331 = add nsw i64 %310, -1
  %332 = and i64 %331, %310
  %333 = icmp eq i64 %332, 0
  br i1 %333, label %334, label %309, !llvm.loop !37

334:                                              ; preds = %309, %280
  %335 = xor i64 %42, -1
  %336 = and i64 %335, %2
  %337 = icmp eq i64 %336, 0
  br i1 %337, label %341, label %338

338:                                              ; preds = %334
  %339 = getelementptr inbounds i8, ptr %0, i64 816
  %340 = getelementptr inbounds i8, ptr %0, i64 1032
  br label %362

341:                                              ; preds = %362, %334
  %342 = and i64 %15, %42
  %343 = xor i64 %342, %15
  %344 = getelementptr inbounds i8, ptr %0, i64 816
  %345 = load ptr, ptr %344, align 8
  %346 = load <8 x double>, ptr %345, align 8
  %347 = fcmp oeq <8 x double> %346, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %348 = bitcast <8 x i1> %347 to i8
  %349 = zext i8 %348 to i64
  %350 = and i64 %343, %349
  %351 = load ptr, ptr %289, align 8
  %352 = load <8 x double>, ptr %351, align 8
  %353 = select <8 x i1> %17, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %354 = or i64 %350, %342
  %355 = xor i64 %354, -1
  %356 = and i64 %79, %355
  %357 = trunc i64 %356 to i8
  %358 = bitcast i8 %357 to <8 x i1>
  %359 = select <8 x i1> %358, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %360 = fadd <8 x double> %353, %359
  %361 = fadd <8 x double> %352, %360
  store <8 x double> %361, ptr %351, align 8
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %342, i64 noundef 3) #10
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %350, i64 noundef 0) #10
  ret void

362:                                              ; preds = %338, %362
  %363 = phi i64 [ %336, %338 ], [ %374, %362 ]
  %364 = load ptr, ptr %12, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %364, i64 noundef %363) #10
  %365 = load ptr, ptr %339, align 8
  %366 = load <8 x double>, ptr %365, align 8
  %367 = load ptr, ptr %340, align 8
  %368 = load double, ptr %367, align 8
  %369 = insertelement <8 x double> poison, double %368, i64 0
  %370 = shufflevector <8 x double> %369, <8 x double> poison, <8 x i32> zeroinitializer
  %371 = fcmp oeq <8 x double> %366, %370
  %372 = bitcast <8 x i1> %371 to i8
  %373 = zext i8 %372 to i64
  %374 = and i64 %363, %373
  %375 = icmp eq i64 %374, 0
  br i1 %375, label %341, label %362, !llvm.loop !38
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
  br i1 %30, label %18, label %31, !llvm.loop !39

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
  br i1 %53, label %7, label %8, !llvm.loop !40
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
  br i1 %86, label %61, label %64, !llvm.loop !41

87:                                               ; preds = %61, %87
  %88 = phi i64 [ %91, %87 ], [ 0, %61 ]
  %89 = mul nsw i64 %88, %12
  %90 = getelementptr inbounds double, ptr %63, i64 %89
  store double 0x7FF8000000000000, ptr %90, align 8
  %91 = add nuw nsw i64 %88, 1
  %92 = icmp eq i64 %91, %9
  br i1 %92, label %83, label %87, !llvm.loop !42

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
  br i1 %126, label %118, label %127, !llvm.loop !43

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
  br i1 %155, label %135, label %174, !llvm.loop !44

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
  br i1 %173, label %150, label %157, !llvm.loop !45

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
  br i1 %180, label %60, label %41, !llvm.loop !46
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
  br i1 %96, label %63, label %30, !llvm.loop !47

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
  br i1 %110, label %86, label %97, !llvm.loop !48

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
  br i1 %142, label %111, label %117, !llvm.loop !49

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
  br i1 %25, label %9, label %21, !llvm.loop !50

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
  br i1 %54, label %48, label %26, !llvm.loop !51
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
  br i1 %45, label %36, label %39, !llvm.loop !52

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
  br label %46, !llvm.loop !53

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
  br i1 %111, label %112, label %96, !llvm.loop !54

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
  br i1 %60, label %45, label %40, !llvm.loop !55

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
  br i1 %45, label %28, label %19, !llvm.loop !56

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
  br i1 %54, label %29, label %46, !llvm.loop !57
}

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
  br i1 %50, label %34, label %40, !llvm.loop !58

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
  br i1 %94, label %80, label %83, !llvm.loop !59

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
  br i1 %139, label %120, label %123, !llvm.loop !60

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
  br i1 %195, label %177, label %180, !llvm.loop !61

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
  br i1 %210, label %196, label %200, !llvm.loop !62

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
  br i1 %218, label %32, label %20, !llvm.loop !63
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
  br i1 %71, label %56, label %48, !llvm.loop !64
}

declare i64 @llvm.cttz.i64(i64, i1 immarg) #5

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
  br i1 %25, label %15, label %14, !llvm.loop !65

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
  br i1 %76, label %65, label %77, !llvm.loop !66

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
  br i1 %105, label %22, label %26, !llvm.loop !67
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
  br i1 %48, label %13, label %20, !llvm.loop !68
}

declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #5

declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #5

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
  br i1 %60, label %29, label %33, !llvm.loop !69

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
  br i1 %76, label %57, label %61, !llvm.loop !70
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
  br i1 %50, label %51, label %25, !llvm.loop !71

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
  br i1 %98, label %14, label %19, !llvm.loop !72

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
  br i1 %123, label %104, label %110, !llvm.loop !71

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
  br i1 %138, label %99, label %139, !llvm.loop !73

139:                                              ; preds = %135, %14
  ret void
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
  br i1 %94, label %95, label %83, !llvm.loop !74

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
  br i1 %175, label %107, label %120, !llvm.loop !75

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
  br i1 %225, label %191, label %196, !llvm.loop !76

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
  br i1 %303, label %304, label %244, !llvm.loop !77

304:                                              ; preds = %301
  %305 = xor <8 x i64> %302, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %306 = and <8 x i64> %239, %305
  %307 = add nuw nsw i64 %186, 1
  %308 = icmp eq i64 %307, %9
  br i1 %308, label %176, label %183, !llvm.loop !78

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
  br i1 %330, label %309, label %318, !llvm.loop !79
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
  br i1 %63, label %64, label %48, !llvm.loop !61

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
  br i1 %127, label %128, label %112, !llvm.loop !61

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
  br i1 %149, label %24, label %129, !llvm.loop !80

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
  br i1 %168, label %150, label %147, !llvm.loop !81
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
  br i1 %31, label %20, label %19, !llvm.loop !82

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
  br i1 %43, label %32, label %24, !llvm.loop !83
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
!24 = distinct !{!24, !4, !5, !25}
!25 = !{!"llvm.loop.vectorize.width", i32 1}
!26 = distinct !{!26, !4, !5, !25}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5}
!29 = distinct !{!29, !4, !5}
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5, !25}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5}
!35 = distinct !{!35, !4, !5}
!36 = distinct !{!36, !4, !5}
!37 = distinct !{!37, !4, !5}
!38 = distinct !{!38, !4, !5}
!39 = distinct !{!39, !4, !5}
!40 = distinct !{!40, !4, !5}
!41 = distinct !{!41, !4, !5}
!42 = distinct !{!42, !4, !5, !25}
!43 = distinct !{!43, !4, !5, !25}
!44 = distinct !{!44, !4, !5}
!45 = distinct !{!45, !4, !5}
!46 = distinct !{!46, !4, !5}
!47 = distinct !{!47, !4, !5}
!48 = distinct !{!48, !4, !5}
!49 = distinct !{!49, !4, !5}
!50 = distinct !{!50, !4, !5}
!51 = distinct !{!51, !4, !5}
!52 = distinct !{!52, !4, !5, !25}
!53 = distinct !{!53, !5}
!54 = distinct !{!54, !4, !5}
!55 = distinct !{!55, !4, !5}
!56 = distinct !{!56, !4, !5}
!57 = distinct !{!57, !4, !5, !25}
!58 = distinct !{!58, !4, !5}
!59 = distinct !{!59, !4, !5}
!60 = distinct !{!60, !4, !5}
!61 = distinct !{!61, !4, !5, !25}
!62 = distinct !{!62, !4, !5}
!63 = distinct !{!63, !4, !5}
!64 = distinct !{!64, !4, !5}
!65 = distinct !{!65, !4, !5}
!66 = distinct !{!66, !4, !5}
!67 = distinct !{!67, !4, !5}
!68 = distinct !{!68, !4, !5}
!69 = distinct !{!69, !4, !5}
!70 = distinct !{!70, !4, !5, !25}
!71 = distinct !{!71, !4, !5}
!72 = distinct !{!72, !4, !5}
!73 = distinct !{!73, !4, !5}
!74 = distinct !{!74, !4, !5}
!75 = distinct !{!75, !4, !5}
!76 = distinct !{!76, !4, !5}
!77 = distinct !{!77, !4, !5}
!78 = distinct !{!78, !4, !5}
!79 = distinct !{!79, !4, !5}
!80 = distinct !{!80, !4, !5, !25}
!81 = distinct !{!81, !4, !5}
!82 = distinct !{!82, !4, !5}
!83 = distinct !{!83, !4, !5}
