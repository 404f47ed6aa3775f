; sources 886825ccd8da01ca334b3415f26db2a3f08a518e706bddcc5d7b511f515bfa8d
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
  switch i32 %161, label %1183 [
    i32 0, label %164
    i32 8, label %167
  ]

164:                                              ; preds = %160, %1181, %247
  %165 = phi i32 [ %162, %160 ], [ %1182, %1181 ], [ 1, %247 ]
  %166 = phi i64 [ %163, %160 ], [ %1159, %1181 ], [ %169, %247 ]
  br label %129, !llvm.loop !7

167:                                              ; preds = %160, %129
  %168 = phi i32 [ %162, %160 ], [ 0, %129 ]
  %169 = phi i64 [ %163, %160 ], [ 0, %129 ]
  %170 = load ptr, ptr %13, align 8
  %171 = getelementptr inbounds i8, ptr %170, i64 8
  %172 = load i64, ptr %171, align 8
  %173 = icmp slt i64 %172, 1
  br i1 %173, label %1183, label %174

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
  br i1 %194, label %195, label %1183

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
  br i1 %264, label %265, label %321

265:                                              ; preds = %254, %308
  %266 = phi i64 [ %318, %308 ], [ 0, %254 ]
  %267 = phi i64 [ %319, %308 ], [ 1, %254 ]
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
  %299 = load ptr, ptr %10, align 8, !noalias !8
  %300 = getelementptr inbounds i8, ptr %299, i64 40
  %301 = load i64, ptr %300, align 8, !noalias !8
  %302 = icmp eq i64 %301, 0
  br i1 %302, label %304, label %303

303:                                              ; preds = %265
  call fastcc void @settle(ptr noundef nonnull %10) #10, !noalias !8
  br label %304

304:                                              ; preds = %303, %265
  %305 = load i64, ptr %72, align 8, !noalias !8
  %306 = icmp sgt i64 %305, 0
  br i1 %306, label %307, label %308

307:                                              ; preds = %304
  call fastcc void @sample(ptr noundef nonnull %10) #10, !noalias !8
  br label %308

308:                                              ; preds = %307, %304
  %309 = load ptr, ptr %10, align 8, !noalias !8
  %310 = load i64, ptr %309, align 8, !noalias !8
  %311 = load ptr, ptr %71, align 8, !noalias !8
  %312 = load ptr, ptr %73, align 8, !noalias !8
  %313 = load ptr, ptr %74, align 8, !noalias !8
  %314 = inttoptr i64 %310 to ptr
  %315 = load ptr, ptr %314, align 8, !noalias !8
  %316 = call i32 %315(ptr noundef %311, ptr noundef %297, ptr noundef %312, ptr noundef %313, ptr noundef %289) #11, !noalias !8
  %317 = zext i32 %316 to i64
  %318 = or i64 %266, %317
  %319 = add nuw nsw i64 %267, 1
  %320 = icmp eq i64 %319, %262
  br i1 %320, label %321, label %265, !llvm.loop !11

321:                                              ; preds = %308, %254
  %322 = phi i64 [ 0, %254 ], [ %318, %308 ]
  %323 = load ptr, ptr %75, align 8, !noalias !8
  %324 = load ptr, ptr %12, align 8, !noalias !8
  %325 = load ptr, ptr %10, align 8, !noalias !8
  %326 = getelementptr inbounds i8, ptr %325, i64 16
  %327 = load i64, ptr %326, align 8, !noalias !8
  %328 = load ptr, ptr %76, align 8, !noalias !8
  %329 = getelementptr inbounds i64, ptr %328, i64 %262
  %330 = load i64, ptr %329, align 8, !noalias !8
  %331 = getelementptr i8, ptr %329, i64 8
  %332 = load i64, ptr %331, align 8, !noalias !8
  %333 = xor i64 %330, -1
  %334 = add i64 %332, %333
  %335 = load ptr, ptr %63, align 8, !noalias !8
  %336 = load ptr, ptr %77, align 8, !noalias !8
  %337 = load ptr, ptr %78, align 8, !noalias !8
  %338 = getelementptr inbounds i64, ptr %337, i64 %330
  %339 = load ptr, ptr %79, align 8, !noalias !8
  %340 = getelementptr inbounds double, ptr %339, i64 %330
  call fastcc void @combine(ptr noundef %323, ptr noundef %324, ptr noundef %335, ptr noundef %336, ptr noundef %338, ptr noundef %340, i64 noundef %334, i64 noundef %327) #10
  br i1 %261, label %369, label %341

341:                                              ; preds = %321
  %342 = load ptr, ptr %75, align 8, !noalias !8
  %343 = load ptr, ptr %77, align 8, !noalias !8
  %344 = load i64, ptr %255, align 8, !noalias !8
  %345 = load i64, ptr %80, align 8, !noalias !8
  %346 = mul nsw i64 %345, %344
  %347 = getelementptr inbounds double, ptr %343, i64 %346
  %348 = load ptr, ptr %81, align 8, !noalias !8
  store <8 x double> %229, ptr %348, align 8, !noalias !8
  %349 = load ptr, ptr %10, align 8, !noalias !8
  %350 = getelementptr inbounds i8, ptr %349, i64 40
  %351 = load i64, ptr %350, align 8, !noalias !8
  %352 = icmp eq i64 %351, 0
  br i1 %352, label %354, label %353

353:                                              ; preds = %341
  call fastcc void @settle(ptr noundef nonnull %10) #10, !noalias !8
  br label %354

354:                                              ; preds = %353, %341
  %355 = load i64, ptr %82, align 8, !noalias !8
  %356 = icmp sgt i64 %355, 0
  br i1 %356, label %357, label %358

357:                                              ; preds = %354
  call fastcc void @sample(ptr noundef nonnull %10) #10, !noalias !8
  br label %358

358:                                              ; preds = %354, %357
  %359 = load ptr, ptr %10, align 8, !noalias !8
  %360 = load i64, ptr %359, align 8, !noalias !8
  %361 = load ptr, ptr %81, align 8, !noalias !8
  %362 = load ptr, ptr %83, align 8, !noalias !8
  %363 = load ptr, ptr %84, align 8, !noalias !8
  %364 = inttoptr i64 %360 to ptr
  %365 = load ptr, ptr %364, align 8, !noalias !8
  %366 = call i32 %365(ptr noundef %361, ptr noundef %342, ptr noundef %362, ptr noundef %363, ptr noundef %347) #11, !noalias !8
  %367 = zext i32 %366 to i64
  %368 = or i64 %322, %367
  br label %369

369:                                              ; preds = %358, %321
  %370 = phi i64 [ %368, %358 ], [ %322, %321 ]
  %371 = load ptr, ptr %0, align 8, !noalias !8
  %372 = getelementptr inbounds i8, ptr %371, i64 8
  %373 = load i64, ptr %372, align 8, !noalias !8
  %374 = icmp slt i64 %373, 1
  br i1 %374, label %375, label %379

375:                                              ; preds = %369
  %376 = icmp sgt i64 %258, 0
  br i1 %376, label %377, label %547

377:                                              ; preds = %375
  %378 = load ptr, ptr %75, align 8, !noalias !8
  br label %537

379:                                              ; preds = %369
  %380 = load ptr, ptr %10, align 8, !noalias !8
  %381 = getelementptr inbounds i8, ptr %380, i64 24
  %382 = load i64, ptr %381, align 8, !noalias !8
  %383 = load ptr, ptr %85, align 8, !noalias !8
  %384 = load i64, ptr %86, align 8, !noalias !8
  %385 = getelementptr inbounds i8, ptr %380, i64 32
  br label %395

386:                                              ; preds = %395
  %387 = getelementptr inbounds double, ptr %383, i64 %384
  %388 = icmp sgt i64 %382, 0
  br i1 %388, label %389, label %421

389:                                              ; preds = %386
  %390 = load ptr, ptr %12, align 8, !noalias !8
  %391 = load ptr, ptr %75, align 8, !noalias !8
  %392 = load ptr, ptr %88, align 8, !noalias !8
  %393 = load ptr, ptr %89, align 8, !noalias !8
  %394 = load ptr, ptr %85, align 8, !noalias !8
  br label %484

395:                                              ; preds = %379, %395
  %396 = phi i64 [ 0, %379 ], [ %419, %395 ]
  %397 = load i64, ptr %371, align 8, !noalias !8
  %398 = load i64, ptr %385, align 8, !noalias !8
  %399 = load ptr, ptr %85, align 8, !noalias !8
  %400 = load i64, ptr %86, align 8, !noalias !8
  %401 = mul nsw i64 %400, %396
  %402 = getelementptr inbounds double, ptr %399, i64 %401
  %403 = load ptr, ptr %87, align 8, !noalias !8
  %404 = load ptr, ptr %76, align 8, !noalias !8
  %405 = getelementptr i64, ptr %404, i64 %397
  %406 = getelementptr i8, ptr %405, i64 8
  %407 = getelementptr i64, ptr %406, i64 %396
  %408 = load i64, ptr %407, align 8, !noalias !8
  %409 = getelementptr i8, ptr %407, i64 8
  %410 = load i64, ptr %409, align 8, !noalias !8
  %411 = xor i64 %408, -1
  %412 = add i64 %410, %411
  %413 = load ptr, ptr %63, align 8, !noalias !8
  %414 = load ptr, ptr %77, align 8, !noalias !8
  %415 = load ptr, ptr %78, align 8, !noalias !8
  %416 = getelementptr inbounds i64, ptr %415, i64 %408
  %417 = load ptr, ptr %79, align 8, !noalias !8
  %418 = getelementptr inbounds double, ptr %417, i64 %408
  call fastcc void @combine(ptr noundef %402, ptr noundef %403, ptr noundef %413, ptr noundef %414, ptr noundef %416, ptr noundef %418, i64 noundef %412, i64 noundef %398) #10
  %419 = add nuw nsw i64 %396, 1
  %420 = icmp eq i64 %419, %373
  br i1 %420, label %386, label %395, !llvm.loop !12

421:                                              ; preds = %484, %386
  %422 = phi <8 x double> [ zeroinitializer, %386 ], [ %517, %484 ]
  %423 = phi <8 x double> [ zeroinitializer, %386 ], [ %515, %484 ]
  %424 = load ptr, ptr %75, align 8, !noalias !8
  %425 = getelementptr inbounds i8, ptr %380, i64 8
  %426 = load i64, ptr %425, align 8, !noalias !8
  %427 = add nsw i64 %426, -3
  %428 = getelementptr i8, ptr %424, i64 64
  %429 = getelementptr i8, ptr %424, i64 128
  %430 = getelementptr i8, ptr %424, i64 192
  %431 = icmp slt i64 %382, %427
  br i1 %431, label %439, label %432

432:                                              ; preds = %439, %421
  %433 = phi <8 x double> [ zeroinitializer, %421 ], [ %449, %439 ]
  %434 = phi <8 x double> [ zeroinitializer, %421 ], [ %454, %439 ]
  %435 = phi <8 x double> [ zeroinitializer, %421 ], [ %459, %439 ]
  %436 = phi <8 x double> [ zeroinitializer, %421 ], [ %464, %439 ]
  %437 = phi i64 [ %382, %421 ], [ %465, %439 ]
  %438 = icmp slt i64 %437, %426
  br i1 %438, label %467, label %477

439:                                              ; preds = %421, %439
  %440 = phi i64 [ %465, %439 ], [ %382, %421 ]
  %441 = phi <8 x double> [ %464, %439 ], [ zeroinitializer, %421 ]
  %442 = phi <8 x double> [ %459, %439 ], [ zeroinitializer, %421 ]
  %443 = phi <8 x double> [ %454, %439 ], [ zeroinitializer, %421 ]
  %444 = phi <8 x double> [ %449, %439 ], [ zeroinitializer, %421 ]
  %445 = shl nsw i64 %440, 6
  %446 = getelementptr inbounds i8, ptr %424, i64 %445
  %447 = load <8 x double>, ptr %446, align 8, !noalias !8
  %448 = fmul <8 x double> %447, zeroinitializer
  %449 = fadd <8 x double> %444, %448
  %450 = shl i64 %440, 6
  %451 = getelementptr i8, ptr %428, i64 %450
  %452 = load <8 x double>, ptr %451, align 8, !noalias !8
  %453 = fmul <8 x double> %452, zeroinitializer
  %454 = fadd <8 x double> %443, %453
  %455 = shl i64 %440, 6
  %456 = getelementptr i8, ptr %429, i64 %455
  %457 = load <8 x double>, ptr %456, align 8, !noalias !8
  %458 = fmul <8 x double> %457, zeroinitializer
  %459 = fadd <8 x double> %442, %458
  %460 = shl i64 %440, 6
  %461 = getelementptr i8, ptr %430, i64 %460
  %462 = load <8 x double>, ptr %461, align 8, !noalias !8
  %463 = fmul <8 x double> %462, zeroinitializer
  %464 = fadd <8 x double> %441, %463
  %465 = add nsw i64 %440, 4
  %466 = icmp slt i64 %465, %427
  br i1 %466, label %439, label %432, !llvm.loop !13

467:                                              ; preds = %432, %467
  %468 = phi i64 [ %475, %467 ], [ %437, %432 ]
  %469 = phi <8 x double> [ %474, %467 ], [ %433, %432 ]
  %470 = shl nsw i64 %468, 6
  %471 = getelementptr inbounds i8, ptr %424, i64 %470
  %472 = load <8 x double>, ptr %471, align 8, !noalias !8
  %473 = fmul <8 x double> %472, zeroinitializer
  %474 = fadd <8 x double> %469, %473
  %475 = add nsw i64 %468, 1
  %476 = icmp eq i64 %475, %426
  br i1 %476, label %477, label %467, !llvm.loop !14

477:                                              ; preds = %467, %432
  %478 = phi <8 x double> [ %433, %432 ], [ %474, %467 ]
  %479 = fadd <8 x double> %434, %478
  %480 = fadd <8 x double> %435, %436
  %481 = fadd <8 x double> %480, %479
  %482 = fadd <8 x double> %423, %481
  %483 = icmp eq i64 %373, 2
  br i1 %483, label %520, label %531

484:                                              ; preds = %389, %484
  %485 = phi <8 x double> [ zeroinitializer, %389 ], [ %515, %484 ]
  %486 = phi <8 x double> [ zeroinitializer, %389 ], [ %517, %484 ]
  %487 = phi i64 [ 0, %389 ], [ %518, %484 ]
  %488 = shl nsw i64 %487, 6
  %489 = getelementptr inbounds i8, ptr %390, i64 %488
  %490 = load <8 x double>, ptr %489, align 8, !noalias !8
  %491 = getelementptr inbounds i8, ptr %391, i64 %488
  %492 = load <8 x double>, ptr %491, align 8, !noalias !8
  %493 = getelementptr inbounds double, ptr %392, i64 %487
  %494 = load double, ptr %493, align 8, !noalias !8
  %495 = insertelement <8 x double> poison, double %494, i64 0
  %496 = shufflevector <8 x double> %495, <8 x double> poison, <8 x i32> zeroinitializer
  %497 = getelementptr inbounds double, ptr %393, i64 %487
  %498 = load double, ptr %497, align 8, !noalias !8
  %499 = insertelement <8 x double> poison, double %498, i64 0
  %500 = shufflevector <8 x double> %499, <8 x double> poison, <8 x i32> zeroinitializer
  %501 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %490)
  %502 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %492)
  %503 = fcmp ogt <8 x double> %501, %502
  %504 = select <8 x i1> %503, <8 x double> %501, <8 x double> %502
  %505 = fmul <8 x double> %504, %500
  %506 = fadd <8 x double> %496, %505
  %507 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %506
  %508 = getelementptr inbounds i8, ptr %394, i64 %488
  %509 = load <8 x double>, ptr %508, align 8, !noalias !8
  %510 = fmul <8 x double> %509, %507
  %511 = getelementptr inbounds i8, ptr %387, i64 %488
  %512 = load <8 x double>, ptr %511, align 8, !noalias !8
  %513 = fmul <8 x double> %512, %507
  %514 = fmul <8 x double> %510, %510
  %515 = fadd <8 x double> %485, %514
  %516 = fmul <8 x double> %513, %513
  %517 = fadd <8 x double> %486, %516
  %518 = add nuw nsw i64 %487, 1
  %519 = icmp eq i64 %518, %382
  br i1 %519, label %421, label %484, !llvm.loop !15

520:                                              ; preds = %477
  %521 = fmul <8 x double> %422, <double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02, double 1.000000e-02>
  %522 = fadd <8 x double> %521, %482
  %523 = sitofp i64 %382 to double
  %524 = insertelement <8 x double> poison, double %523, i64 0
  %525 = shufflevector <8 x double> %524, <8 x double> poison, <8 x i32> zeroinitializer
  %526 = fmul <8 x double> %525, %522
  %527 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %526)
  %528 = fdiv <8 x double> %482, %527
  %529 = fcmp oeq <8 x double> %482, zeroinitializer
  %530 = select <8 x i1> %529, <8 x double> zeroinitializer, <8 x double> %528
  br label %547

531:                                              ; preds = %477
  %532 = sitofp i64 %382 to double
  %533 = insertelement <8 x double> poison, double %532, i64 0
  %534 = shufflevector <8 x double> %533, <8 x double> poison, <8 x i32> zeroinitializer
  %535 = fdiv <8 x double> %482, %534
  %536 = call <8 x double> @llvm.sqrt.v8f64(<8 x double> %535)
  br label %547

537:                                              ; preds = %377, %537
  %538 = phi i64 [ 0, %377 ], [ %545, %537 ]
  %539 = phi <8 x double> [ zeroinitializer, %377 ], [ %544, %537 ]
  %540 = shl nsw i64 %538, 6
  %541 = getelementptr inbounds i8, ptr %378, i64 %540
  %542 = load <8 x double>, ptr %541, align 8, !noalias !8
  %543 = fmul <8 x double> %542, zeroinitializer
  %544 = fadd <8 x double> %539, %543
  %545 = add nuw nsw i64 %538, 1
  %546 = icmp eq i64 %545, %258
  br i1 %546, label %547, label %537, !llvm.loop !16

547:                                              ; preds = %537, %375, %531, %520
  %548 = phi <8 x double> [ %530, %520 ], [ %536, %531 ], [ zeroinitializer, %375 ], [ %544, %537 ]
  %549 = fcmp olt <8 x double> %548, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %550 = bitcast <8 x i1> %549 to i8
  %551 = zext i8 %550 to i64
  %552 = xor i64 %370, -1
  %553 = and i64 %552, %551
  %554 = and i64 %553, %197
  %555 = load ptr, ptr %90, align 8, !noalias !8
  %556 = load <8 x double>, ptr %555, align 8, !noalias !8
  %557 = load i64, ptr %255, align 8, !noalias !8
  %558 = sext i1 %261 to i64
  %559 = add i64 %557, %558
  %560 = sitofp i64 %559 to double
  %561 = insertelement <8 x double> poison, double %560, i64 0
  %562 = shufflevector <8 x double> %561, <8 x double> poison, <8 x i32> zeroinitializer
  %563 = fadd <8 x double> %556, %562
  store <8 x double> %563, ptr %555, align 8, !noalias !8
  %564 = icmp ne i64 %554, 0
  %565 = select i1 %47, i1 %564, i1 false
  br i1 %565, label %566, label %569

566:                                              ; preds = %547
  store <8 x double> %229, ptr %3, align 16
  %567 = load ptr, ptr %91, align 8
  %568 = call fastcc i64 @hold_lanes(ptr noundef %0, ptr noundef nonnull %3, ptr noundef %567, i64 noundef %554, i32 noundef %46) #10
  br label %569

569:                                              ; preds = %566, %547
  %570 = phi i64 [ %568, %566 ], [ 0, %547 ]
  %571 = xor i64 %570, -1
  %572 = and i64 %554, %571
  %573 = load ptr, ptr %0, align 8
  %574 = icmp eq i64 %572, 0
  br i1 %574, label %619, label %575

575:                                              ; preds = %569
  %576 = getelementptr inbounds i8, ptr %573, i64 32
  %577 = load i64, ptr %576, align 8
  %578 = icmp eq i64 %577, 1
  br i1 %578, label %579, label %583

579:                                              ; preds = %575
  %580 = load ptr, ptr %34, align 8
  %581 = load i64, ptr %580, align 8
  %582 = icmp eq i64 %581, 1
  br i1 %582, label %583, label %619

583:                                              ; preds = %579, %575
  %584 = load ptr, ptr %75, align 8
  %585 = load ptr, ptr %77, align 8
  %586 = load i64, ptr %573, align 8
  %587 = load i64, ptr %92, align 8
  %588 = mul nsw i64 %587, %586
  %589 = getelementptr inbounds double, ptr %585, i64 %588
  %590 = load ptr, ptr %93, align 8
  store <8 x double> %229, ptr %590, align 8
  %591 = load ptr, ptr %10, align 8
  %592 = getelementptr inbounds i8, ptr %591, i64 40
  %593 = load i64, ptr %592, align 8
  %594 = icmp eq i64 %593, 0
  br i1 %594, label %596, label %595

595:                                              ; preds = %583
  call fastcc void @settle(ptr noundef nonnull %10) #10
  br label %596

596:                                              ; preds = %595, %583
  %597 = load i64, ptr %94, align 8
  %598 = icmp sgt i64 %597, 0
  br i1 %598, label %599, label %600

599:                                              ; preds = %596
  call fastcc void @sample(ptr noundef nonnull %10) #10
  br label %600

600:                                              ; preds = %596, %599
  %601 = load ptr, ptr %10, align 8
  %602 = load i64, ptr %601, align 8
  %603 = load ptr, ptr %93, align 8
  %604 = load ptr, ptr %95, align 8
  %605 = load ptr, ptr %96, align 8
  %606 = inttoptr i64 %602 to ptr
  %607 = load ptr, ptr %606, align 8
  %608 = call i32 %607(ptr noundef %603, ptr noundef %584, ptr noundef %604, ptr noundef %605, ptr noundef %589) #11
  %609 = zext i32 %608 to i64
  %610 = or i64 %370, %609
  %611 = load ptr, ptr %90, align 8
  %612 = load <8 x double>, ptr %611, align 8
  %613 = trunc nuw i64 %572 to i8
  %614 = bitcast i8 %613 to <8 x i1>
  %615 = select <8 x i1> %614, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %616 = fadd <8 x double> %615, %612
  store <8 x double> %616, ptr %611, align 8
  %617 = xor i64 %610, -1
  %618 = and i64 %572, %617
  br label %619

619:                                              ; preds = %569, %579, %600
  %620 = phi i64 [ %370, %569 ], [ %610, %600 ], [ %370, %579 ]
  %621 = phi i64 [ %572, %569 ], [ %618, %600 ], [ %572, %579 ]
  %622 = icmp ne i64 %621, 0
  %623 = select i1 %48, i1 %622, i1 false
  br i1 %623, label %624, label %628

624:                                              ; preds = %619
  %625 = call fastcc i64 @clear_lanes(ptr noundef %0) #10
  %626 = xor i64 %625, -1
  %627 = and i64 %621, %626
  br label %628

628:                                              ; preds = %619, %624
  %629 = phi i64 [ %627, %624 ], [ 0, %619 ]
  store i64 0, ptr %8, align 8
  %630 = load ptr, ptr %97, align 8
  %631 = load <8 x double>, ptr %630, align 8
  %632 = fcmp olt <8 x double> %631, %229
  %633 = bitcast <8 x i1> %632 to i8
  %634 = zext i8 %633 to i64
  %635 = and i64 %621, %634
  %636 = or i64 %635, %629
  %637 = icmp eq i64 %636, 0
  br i1 %637, label %838, label %638

638:                                              ; preds = %628
  %639 = load ptr, ptr %90, align 8
  %640 = load <8 x double>, ptr %639, align 8
  %641 = trunc nuw i64 %636 to i8
  %642 = bitcast i8 %641 to <8 x i1>
  %643 = load ptr, ptr %0, align 8
  %644 = getelementptr inbounds i8, ptr %643, i64 16
  %645 = load i64, ptr %644, align 8
  %646 = sitofp i64 %645 to double
  %647 = insertelement <8 x double> poison, double %646, i64 0
  %648 = shufflevector <8 x double> %647, <8 x double> poison, <8 x i32> zeroinitializer
  %649 = select <8 x i1> %642, <8 x double> %648, <8 x double> zeroinitializer
  %650 = fadd <8 x double> %640, %649
  store <8 x double> %650, ptr %639, align 8
  %651 = load ptr, ptr %0, align 8
  %652 = load ptr, ptr %10, align 8
  %653 = getelementptr inbounds i8, ptr %652, i64 16
  %654 = load i64, ptr %653, align 8
  %655 = load i64, ptr %651, align 8
  %656 = load i64, ptr %98, align 8
  %657 = load ptr, ptr %77, align 8
  %658 = mul nsw i64 %656, %655
  %659 = getelementptr inbounds double, ptr %657, i64 %658
  %660 = load ptr, ptr %99, align 8
  %661 = add nsw i64 %655, 1
  %662 = getelementptr inbounds i8, ptr %651, i64 16
  %663 = load i64, ptr %662, align 8
  %664 = icmp sgt i64 %663, 0
  br i1 %664, label %665, label %667

665:                                              ; preds = %638
  %666 = getelementptr inbounds i8, ptr %651, i64 8
  br label %678

667:                                              ; preds = %719, %638
  %668 = phi i64 [ 0, %638 ], [ %729, %719 ]
  %669 = getelementptr inbounds i8, ptr %651, i64 16
  %670 = load ptr, ptr %10, align 8
  %671 = getelementptr inbounds i8, ptr %670, i64 8
  %672 = load i64, ptr %671, align 8
  %673 = icmp sgt i64 %672, 0
  br i1 %673, label %674, label %734

674:                                              ; preds = %667
  %675 = getelementptr inbounds double, ptr %660, i64 %656
  %676 = shl nsw i64 %656, 4
  %677 = getelementptr inbounds i8, ptr %660, i64 %676
  br label %741

678:                                              ; preds = %665, %719
  %679 = phi i64 [ 0, %665 ], [ %729, %719 ]
  %680 = phi i64 [ %661, %665 ], [ %730, %719 ]
  %681 = load i64, ptr %666, align 8
  %682 = load ptr, ptr %100, align 8
  %683 = load ptr, ptr %12, align 8
  %684 = load ptr, ptr %76, align 8
  %685 = getelementptr i64, ptr %684, i64 %680
  %686 = getelementptr i64, ptr %685, i64 %681
  %687 = load i64, ptr %686, align 8
  %688 = getelementptr i8, ptr %686, i64 8
  %689 = load i64, ptr %688, align 8
  %690 = xor i64 %687, -1
  %691 = add i64 %689, %690
  %692 = load ptr, ptr %63, align 8
  %693 = load ptr, ptr %77, align 8
  %694 = load ptr, ptr %78, align 8
  %695 = getelementptr inbounds i64, ptr %694, i64 %687
  %696 = load ptr, ptr %79, align 8
  %697 = getelementptr inbounds double, ptr %696, i64 %687
  call fastcc void @combine(ptr noundef %682, ptr noundef %683, ptr noundef %692, ptr noundef %693, ptr noundef %695, ptr noundef %697, i64 noundef %691, i64 noundef %654) #10
  %698 = load ptr, ptr %77, align 8
  %699 = mul nsw i64 %680, %656
  %700 = getelementptr inbounds double, ptr %698, i64 %699
  %701 = load ptr, ptr %101, align 8
  %702 = getelementptr inbounds double, ptr %701, i64 %680
  %703 = load double, ptr %702, align 8
  %704 = insertelement <8 x double> poison, double %703, i64 0
  %705 = shufflevector <8 x double> %704, <8 x double> poison, <8 x i32> zeroinitializer
  %706 = fmul <8 x double> %231, %705
  %707 = fadd <8 x double> %201, %706
  %708 = load ptr, ptr %100, align 8
  %709 = load ptr, ptr %102, align 8
  store <8 x double> %707, ptr %709, align 8
  %710 = load ptr, ptr %10, align 8
  %711 = getelementptr inbounds i8, ptr %710, i64 40
  %712 = load i64, ptr %711, align 8
  %713 = icmp eq i64 %712, 0
  br i1 %713, label %715, label %714

714:                                              ; preds = %678
  call fastcc void @settle(ptr noundef nonnull %10) #10
  br label %715

715:                                              ; preds = %714, %678
  %716 = load i64, ptr %103, align 8
  %717 = icmp sgt i64 %716, 0
  br i1 %717, label %718, label %719

718:                                              ; preds = %715
  call fastcc void @sample(ptr noundef nonnull %10) #10
  br label %719

719:                                              ; preds = %718, %715
  %720 = load ptr, ptr %10, align 8
  %721 = load i64, ptr %720, align 8
  %722 = load ptr, ptr %102, align 8
  %723 = load ptr, ptr %104, align 8
  %724 = load ptr, ptr %105, align 8
  %725 = inttoptr i64 %721 to ptr
  %726 = load ptr, ptr %725, align 8
  %727 = call i32 %726(ptr noundef %722, ptr noundef %708, ptr noundef %723, ptr noundef %724, ptr noundef %700) #11
  %728 = sext i32 %727 to i64
  %729 = or i64 %679, %728
  %730 = add nsw i64 %680, 1
  %731 = load i64, ptr %662, align 8
  %732 = add nsw i64 %731, %661
  %733 = icmp slt i64 %730, %732
  br i1 %733, label %678, label %667, !llvm.loop !17

734:                                              ; preds = %741, %667
  %735 = getelementptr inbounds i8, ptr %651, i64 8
  %736 = load i64, ptr %735, align 8
  %737 = load i64, ptr %669, align 8
  %738 = getelementptr inbounds i8, ptr %651, i64 24
  %739 = load i64, ptr %738, align 8
  %740 = icmp sgt i64 %739, 3
  br i1 %740, label %769, label %794

741:                                              ; preds = %674, %741
  %742 = phi i64 [ 0, %674 ], [ %764, %741 ]
  %743 = load ptr, ptr %75, align 8
  %744 = shl nsw i64 %742, 6
  %745 = getelementptr inbounds i8, ptr %743, i64 %744
  %746 = load <8 x double>, ptr %745, align 8
  %747 = load ptr, ptr %12, align 8
  %748 = getelementptr inbounds i8, ptr %747, i64 %744
  %749 = load <8 x double>, ptr %748, align 8
  %750 = fsub <8 x double> %746, %749
  %751 = load ptr, ptr %77, align 8
  %752 = getelementptr inbounds i8, ptr %751, i64 %744
  %753 = load <8 x double>, ptr %752, align 8
  %754 = fmul <8 x double> %231, %753
  %755 = fsub <8 x double> %754, %750
  %756 = getelementptr inbounds i8, ptr %660, i64 %744
  store <8 x double> %750, ptr %756, align 8
  %757 = getelementptr inbounds i8, ptr %675, i64 %744
  store <8 x double> %755, ptr %757, align 8
  %758 = fsub <8 x double> %750, %755
  %759 = getelementptr inbounds i8, ptr %659, i64 %744
  %760 = load <8 x double>, ptr %759, align 8
  %761 = fmul <8 x double> %231, %760
  %762 = fsub <8 x double> %758, %761
  %763 = getelementptr inbounds i8, ptr %677, i64 %744
  store <8 x double> %762, ptr %763, align 8
  %764 = add nuw nsw i64 %742, 1
  %765 = load ptr, ptr %10, align 8
  %766 = getelementptr inbounds i8, ptr %765, i64 8
  %767 = load i64, ptr %766, align 8
  %768 = icmp slt i64 %764, %767
  br i1 %768, label %741, label %734, !llvm.loop !18

769:                                              ; preds = %734, %769
  %770 = phi i64 [ %791, %769 ], [ 3, %734 ]
  %771 = mul nsw i64 %770, %656
  %772 = getelementptr inbounds double, ptr %660, i64 %771
  %773 = load ptr, ptr %106, align 8
  %774 = load ptr, ptr %76, align 8
  %775 = getelementptr i64, ptr %774, i64 %661
  %776 = getelementptr i64, ptr %775, i64 %736
  %777 = getelementptr i64, ptr %776, i64 %737
  %778 = getelementptr i64, ptr %777, i64 %770
  %779 = getelementptr i8, ptr %778, i64 -24
  %780 = load i64, ptr %779, align 8
  %781 = getelementptr i8, ptr %778, i64 -16
  %782 = load i64, ptr %781, align 8
  %783 = xor i64 %780, -1
  %784 = add i64 %782, %783
  %785 = load ptr, ptr %63, align 8
  %786 = load ptr, ptr %77, align 8
  %787 = load ptr, ptr %78, align 8
  %788 = getelementptr inbounds i64, ptr %787, i64 %780
  %789 = load ptr, ptr %79, align 8
  %790 = getelementptr inbounds double, ptr %789, i64 %780
  call fastcc void @combine(ptr noundef %772, ptr noundef %773, ptr noundef %785, ptr noundef %786, ptr noundef %788, ptr noundef %790, i64 noundef %784, i64 noundef %654) #10
  %791 = add nuw nsw i64 %770, 1
  %792 = load i64, ptr %738, align 8
  %793 = icmp slt i64 %791, %792
  br i1 %793, label %769, label %794, !llvm.loop !19

794:                                              ; preds = %769, %734
  %795 = and i64 %668, %636
  %796 = icmp eq i64 %795, 0
  br i1 %796, label %801, label %797

797:                                              ; preds = %794
  call fastcc void @retire(ptr noundef %0, i64 noundef %795, i64 noundef 3) #10
  %798 = xor i64 %795, -1
  %799 = and i64 %197, %798
  store i64 %799, ptr %6, align 8
  %800 = and i64 %629, %798
  br label %801

801:                                              ; preds = %797, %794
  %802 = phi i32 [ 1, %797 ], [ %168, %794 ]
  %803 = phi i64 [ %800, %797 ], [ %629, %794 ]
  store <8 x double> %229, ptr %3, align 16
  %804 = icmp eq i64 %803, 0
  br i1 %804, label %807, label %805

805:                                              ; preds = %801
  %806 = call fastcc i64 @look_for_events(ptr noundef %0, ptr noundef nonnull %2, i64 noundef %803, ptr noundef nonnull %3, ptr noundef nonnull %5, ptr noundef nonnull %7, ptr noundef nonnull %4, ptr noundef nonnull %8) #10
  br label %807

807:                                              ; preds = %805, %801
  %808 = phi i64 [ %806, %805 ], [ 0, %801 ]
  %809 = load i64, ptr %8, align 8
  %810 = or i64 %809, %795
  %811 = xor i64 %810, -1
  %812 = and i64 %636, %811
  %813 = icmp eq i64 %808, 0
  %814 = select i1 %813, ptr null, ptr %4
  %815 = call fastcc i64 @write_within(ptr noundef %0, ptr noundef nonnull %2, i64 noundef %812, ptr noundef nonnull %3, ptr noundef %814) #10
  %816 = load <8 x double>, ptr %3, align 16
  br i1 %813, label %822, label %817

817:                                              ; preds = %807
  %818 = xor i64 %815, -1
  %819 = and i64 %808, %818
  %820 = call fastcc i64 @end_within(ptr noundef %0, ptr noundef nonnull %2, i64 noundef %819, ptr noundef nonnull %3, ptr noundef nonnull %4) #10
  %821 = or i64 %820, %815
  br label %822

822:                                              ; preds = %817, %807
  %823 = phi i64 [ %821, %817 ], [ %815, %807 ]
  %824 = icmp ne i64 %823, 0
  %825 = select i1 %48, i1 %824, i1 false
  br i1 %825, label %826, label %831

826:                                              ; preds = %822
  call fastcc void @retire(ptr noundef %0, i64 noundef %823, i64 noundef 6) #10
  %827 = xor i64 %823, -1
  %828 = load i64, ptr %6, align 8
  %829 = and i64 %828, %827
  store i64 %829, ptr %6, align 8
  %830 = and i64 %808, %827
  br label %831

831:                                              ; preds = %826, %822
  %832 = phi i32 [ 1, %826 ], [ %802, %822 ]
  %833 = phi i64 [ %830, %826 ], [ %808, %822 ]
  %834 = or i64 %823, %570
  %835 = or i64 %823, %810
  %836 = xor i64 %835, -1
  %837 = and i64 %621, %836
  br label %838

838:                                              ; preds = %831, %628
  %839 = phi <8 x double> [ %229, %628 ], [ %816, %831 ]
  %840 = phi i64 [ 0, %628 ], [ %809, %831 ]
  %841 = phi i64 [ %570, %628 ], [ %834, %831 ]
  %842 = phi i32 [ %168, %628 ], [ %832, %831 ]
  %843 = phi i64 [ %621, %628 ], [ %837, %831 ]
  %844 = phi i64 [ 0, %628 ], [ %833, %831 ]
  %845 = load ptr, ptr %97, align 8
  %846 = load <8 x double>, ptr %845, align 8
  %847 = fcmp oeq <8 x double> %846, %839
  %848 = bitcast <8 x i1> %847 to i8
  %849 = zext i8 %848 to i64
  %850 = and i64 %843, %849
  %851 = icmp eq i64 %850, 0
  br i1 %851, label %852, label %1104

852:                                              ; preds = %1104, %838
  %853 = trunc nuw i64 %843 to i8
  %854 = bitcast i8 %853 to <8 x i1>
  %855 = load ptr, ptr %59, align 8
  %856 = load <8 x double>, ptr %855, align 8
  %857 = select <8 x i1> %854, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %858 = fadd <8 x double> %857, %856
  store <8 x double> %858, ptr %855, align 8
  %859 = load ptr, ptr %60, align 8
  %860 = load <8 x double>, ptr %859, align 8
  %861 = xor <8 x i1> %854, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %862 = and <8 x i1> %199, %861
  %863 = select <8 x i1> %862, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> zeroinitializer
  %864 = fadd <8 x double> %863, %860
  store <8 x double> %864, ptr %859, align 8
  %865 = load ptr, ptr %108, align 8
  %866 = load ptr, ptr %0, align 8
  %867 = getelementptr inbounds i8, ptr %866, i64 8
  %868 = load i64, ptr %867, align 8
  %869 = icmp slt i64 %868, 1
  %870 = xor i64 %843, -1
  %871 = and i64 %197, %870
  %872 = trunc i64 %871 to i8
  %873 = bitcast i8 %872 to <8 x i1>
  %874 = load ptr, ptr %109, align 8
  %875 = load <8 x double>, ptr %874, align 8
  br i1 %869, label %1007, label %876

876:                                              ; preds = %852
  %877 = load ptr, ptr %110, align 8
  %878 = load <8 x double>, ptr %877, align 8
  %879 = load ptr, ptr %111, align 8
  %880 = load <8 x double>, ptr %879, align 8
  %881 = fcmp ogt <8 x double> %548, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %882 = bitcast <8 x double> %548 to <8 x i64>
  %883 = select <8 x i1> %881, <8 x i64> %882, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %884 = getelementptr inbounds i8, ptr %865, i64 24
  %885 = load double, ptr %884, align 8
  %886 = insertelement <8 x double> poison, double %885, i64 0
  %887 = shufflevector <8 x double> %886, <8 x double> poison, <8 x i32> zeroinitializer
  %888 = getelementptr inbounds i8, ptr %865, i64 8
  %889 = load double, ptr %888, align 8
  %890 = fneg double %889
  %891 = add <8 x i64> %883, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %892 = ashr <8 x i64> %891, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %893 = and <8 x i64> %891, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %894 = sub <8 x i64> %883, %893
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
  %908 = insertelement <8 x double> poison, double %890, i64 0
  %909 = shufflevector <8 x double> %908, <8 x double> poison, <8 x i32> zeroinitializer
  %910 = fmul <8 x double> %907, %909
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
  %933 = fmul <8 x double> %887, %932
  %934 = getelementptr inbounds i8, ptr %865, i64 16
  %935 = load double, ptr %934, align 8
  %936 = fcmp une double %935, 0.000000e+00
  br i1 %936, label %937, label %982

937:                                              ; preds = %876
  %938 = bitcast <8 x double> %878 to <8 x i64>
  %939 = add <8 x i64> %938, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %940 = ashr <8 x i64> %939, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %941 = and <8 x i64> %939, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %942 = sub <8 x i64> %938, %941
  %943 = bitcast <8 x i64> %942 to <8 x double>
  %944 = fadd <8 x double> %943, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %945 = fadd <8 x double> %943, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %946 = fdiv <8 x double> %944, %945
  %947 = fmul <8 x double> %946, %946
  %948 = call <8 x double> @llvm.fma.v8f64(<8 x double> %947, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %949 = call <8 x double> @llvm.fma.v8f64(<8 x double> %948, <8 x double> %947, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %950 = call <8 x double> @llvm.fma.v8f64(<8 x double> %949, <8 x double> %947, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %951 = call <8 x double> @llvm.fma.v8f64(<8 x double> %950, <8 x double> %947, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %952 = trunc nsw <8 x i64> %940 to <8 x i32>
  %953 = sitofp <8 x i32> %952 to <8 x double>
  %954 = fmul <8 x double> %946, %951
  %955 = fadd <8 x double> %954, %953
  %956 = insertelement <8 x double> poison, double %935, i64 0
  %957 = shufflevector <8 x double> %956, <8 x double> poison, <8 x i32> zeroinitializer
  %958 = fmul <8 x double> %957, %955
  %959 = fcmp ogt <8 x double> %958, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %960 = bitcast <8 x double> %958 to <8 x i64>
  %961 = select <8 x i1> %959, <8 x i64> %960, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %962 = bitcast <8 x i64> %961 to <8 x double>
  %963 = fcmp olt <8 x double> %962, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %964 = bitcast <8 x i64> %961 to <8 x double>
  %965 = select <8 x i1> %963, <8 x double> %964, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %966 = call <8 x double> @llvm.rint.v8f64(<8 x double> %965)
  %967 = fsub <8 x double> %965, %966
  %968 = call <8 x double> @llvm.fma.v8f64(<8 x double> %967, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %969 = call <8 x double> @llvm.fma.v8f64(<8 x double> %968, <8 x double> %967, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %970 = call <8 x double> @llvm.fma.v8f64(<8 x double> %969, <8 x double> %967, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %971 = call <8 x double> @llvm.fma.v8f64(<8 x double> %970, <8 x double> %967, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %972 = call <8 x double> @llvm.fma.v8f64(<8 x double> %971, <8 x double> %967, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %973 = call <8 x double> @llvm.fma.v8f64(<8 x double> %972, <8 x double> %967, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %974 = call <8 x double> @llvm.fma.v8f64(<8 x double> %973, <8 x double> %967, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %975 = bitcast <8 x double> %974 to <8 x i64>
  %976 = fptosi <8 x double> %966 to <8 x i32>
  %977 = zext <8 x i32> %976 to <8 x i64>
  %978 = shl <8 x i64> %977, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %979 = add <8 x i64> %978, %975
  %980 = bitcast <8 x i64> %979 to <8 x double>
  %981 = fmul <8 x double> %933, %980
  br label %982

982:                                              ; preds = %876, %937
  %983 = phi <8 x double> [ %981, %937 ], [ %933, %876 ]
  %984 = getelementptr inbounds i8, ptr %865, i64 32
  %985 = load double, ptr %984, align 8
  %986 = insertelement <8 x double> poison, double %985, i64 0
  %987 = shufflevector <8 x double> %986, <8 x double> poison, <8 x i32> zeroinitializer
  %988 = fcmp ogt <8 x double> %983, %987
  %989 = select <8 x i1> %988, <8 x double> %983, <8 x double> %987
  %990 = fcmp olt <8 x double> %880, %989
  %991 = select <8 x i1> %990, <8 x double> %880, <8 x double> %989
  %992 = fmul <8 x double> %231, %991
  %993 = fcmp oeq <8 x double> %839, %209
  %994 = fcmp ogt <8 x double> %875, %992
  %995 = select <8 x i1> %993, <8 x i1> %994, <8 x i1> zeroinitializer
  %996 = select <8 x i1> %995, <8 x double> %875, <8 x double> %992
  %997 = fcmp ogt <8 x double> %548, <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>
  %998 = select <8 x i1> %997, <8 x i64> %882, <8 x i64> <i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789, i64 4547007122018943789>
  %999 = bitcast <8 x double> %878 to <8 x i64>
  %1000 = select <8 x i1> %854, <8 x i64> %998, <8 x i64> %999
  store <8 x i64> %1000, ptr %877, align 8
  %1001 = load ptr, ptr %111, align 8
  %1002 = getelementptr inbounds i8, ptr %865, i64 40
  %1003 = load double, ptr %1002, align 8
  %1004 = insertelement <8 x double> poison, double %1003, i64 0
  %1005 = shufflevector <8 x double> %1004, <8 x double> poison, <8 x i32> zeroinitializer
  %1006 = select <8 x i1> %873, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, <8 x double> %1005
  store <8 x double> %1006, ptr %1001, align 8
  br label %1007

1007:                                             ; preds = %982, %852
  %1008 = phi <8 x double> [ %875, %852 ], [ %996, %982 ]
  %1009 = and i64 %871, 255
  %1010 = icmp eq i64 %1009, 0
  br i1 %1010, label %1099, label %1011

1011:                                             ; preds = %1007
  %1012 = trunc i64 %620 to i8
  %1013 = bitcast i8 %1012 to <8 x i1>
  %1014 = trunc i64 %841 to i8
  %1015 = bitcast i8 %1014 to <8 x i1>
  %1016 = trunc i64 %840 to i8
  %1017 = bitcast i8 %1016 to <8 x i1>
  %1018 = call <8 x double> @llvm.fabs.v8f64(<8 x double> %548)
  %1019 = fcmp one <8 x double> %1018, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1020 = xor <8 x i1> %1013, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1021 = select <8 x i1> %1019, <8 x i1> %1020, <8 x i1> zeroinitializer
  %1022 = or <8 x i1> %1015, %1017
  %1023 = xor <8 x i1> %1022, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1024 = and <8 x i1> %1021, %1023
  br i1 %869, label %1086, label %1025

1025:                                             ; preds = %1011
  %1026 = fcmp ogt <8 x double> %548, <double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10, double 1.000000e-10>
  %1027 = bitcast <8 x double> %548 to <8 x i64>
  %1028 = select <8 x i1> %1026, <8 x i64> %1027, <8 x i64> <i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675, i64 4457293557087583675>
  %1029 = getelementptr inbounds i8, ptr %865, i64 24
  %1030 = load double, ptr %1029, align 8
  %1031 = insertelement <8 x double> poison, double %1030, i64 0
  %1032 = shufflevector <8 x double> %1031, <8 x double> poison, <8 x i32> zeroinitializer
  %1033 = load double, ptr %865, align 8
  %1034 = fneg double %1033
  %1035 = add <8 x i64> %1028, <i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189, i64 -4604544271217802189>
  %1036 = ashr <8 x i64> %1035, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1037 = and <8 x i64> %1035, <i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496, i64 -4503599627370496>
  %1038 = sub <8 x i64> %1028, %1037
  %1039 = bitcast <8 x i64> %1038 to <8 x double>
  %1040 = fadd <8 x double> %1039, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %1041 = fadd <8 x double> %1039, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %1042 = fdiv <8 x double> %1040, %1041
  %1043 = fmul <8 x double> %1042, %1042
  %1044 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1043, <8 x double> <double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9, double 0x3FD484B13D7C02A9>, <8 x double> <double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9, double 0x3FDA61762A7ADED9>)
  %1045 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1044, <8 x double> %1043, <8 x double> <double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE, double 0x3FE2776C50EF9BFE>)
  %1046 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1045, <8 x double> %1043, <8 x double> <double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD, double 0x3FEEC709DC3A03FD>)
  %1047 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1046, <8 x double> %1043, <8 x double> <double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE, double 0x40071547652B82FE>)
  %1048 = trunc nsw <8 x i64> %1036 to <8 x i32>
  %1049 = sitofp <8 x i32> %1048 to <8 x double>
  %1050 = fmul <8 x double> %1042, %1047
  %1051 = fadd <8 x double> %1050, %1049
  %1052 = insertelement <8 x double> poison, double %1034, i64 0
  %1053 = shufflevector <8 x double> %1052, <8 x double> poison, <8 x i32> zeroinitializer
  %1054 = fmul <8 x double> %1051, %1053
  %1055 = fcmp ogt <8 x double> %1054, <double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03, double -1.000000e+03>
  %1056 = bitcast <8 x double> %1054 to <8 x i64>
  %1057 = select <8 x i1> %1055, <8 x i64> %1056, <8 x i64> <i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432, i64 -4571364728013586432>
  %1058 = bitcast <8 x i64> %1057 to <8 x double>
  %1059 = fcmp olt <8 x double> %1058, <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1060 = bitcast <8 x i64> %1057 to <8 x double>
  %1061 = select <8 x i1> %1059, <8 x double> %1060, <8 x double> <double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03, double 1.000000e+03>
  %1062 = call <8 x double> @llvm.rint.v8f64(<8 x double> %1061)
  %1063 = fsub <8 x double> %1061, %1062
  %1064 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1063, <8 x double> <double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5, double 0x3EEFFCBFC588B0C5>, <8 x double> <double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786, double 0x3F2430912F86C786>)
  %1065 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1064, <8 x double> %1063, <8 x double> <double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730, double 0x3F55D87FE78A6730>)
  %1066 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1065, <8 x double> %1063, <8 x double> <double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77, double 0x3F83B2AB6FBA4E77>)
  %1067 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1066, <8 x double> %1063, <8 x double> <double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF, double 0x3FAC6B08D704A0BF>)
  %1068 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1067, <8 x double> %1063, <8 x double> <double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E, double 0x3FCEBFBDFF82C58E>)
  %1069 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1068, <8 x double> %1063, <8 x double> <double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF, double 0x3FE62E42FEFA39EF>)
  %1070 = call <8 x double> @llvm.fma.v8f64(<8 x double> %1069, <8 x double> %1063, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>)
  %1071 = bitcast <8 x double> %1070 to <8 x i64>
  %1072 = fptosi <8 x double> %1062 to <8 x i32>
  %1073 = zext <8 x i32> %1072 to <8 x i64>
  %1074 = shl <8 x i64> %1073, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %1075 = add <8 x i64> %1074, %1071
  %1076 = bitcast <8 x i64> %1075 to <8 x double>
  %1077 = fmul <8 x double> %1032, %1076
  %1078 = getelementptr inbounds i8, ptr %865, i64 32
  %1079 = load double, ptr %1078, align 8
  %1080 = insertelement <8 x double> poison, double %1079, i64 0
  %1081 = shufflevector <8 x double> %1080, <8 x double> poison, <8 x i32> zeroinitializer
  %1082 = fcmp ogt <8 x double> %1077, %1081
  %1083 = select <8 x i1> %1082, <8 x double> %1077, <8 x double> %1081
  %1084 = select <8 x i1> %1024, <8 x double> %1083, <8 x double> <double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01, double 2.500000e-01>
  %1085 = fmul <8 x double> %231, %1084
  br label %1086

1086:                                             ; preds = %1025, %1011
  %1087 = phi <8 x double> [ zeroinitializer, %1011 ], [ %1085, %1025 ]
  %1088 = or <8 x i1> %1024, %1017
  %1089 = select <8 x i1> %1088, <8 x i64> <i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904, i64 4611686018427387904>, <8 x i64> <i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400, i64 4616189618054758400>
  %1090 = select <8 x i1> %873, <8 x double> %1087, <8 x double> %1008
  %1091 = load ptr, ptr %112, align 8
  %1092 = select <8 x i1> %1015, <8 x i64> <i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648, i64 4618441417868443648>, <8 x i64> %1089
  %1093 = load <8 x i64>, ptr %1091, align 8
  %1094 = select <8 x i1> %873, <8 x i64> %1092, <8 x i64> %1093
  store <8 x i64> %1094, ptr %1091, align 8
  %1095 = load ptr, ptr %112, align 8
  %1096 = select <8 x i1> %1013, <8 x i64> <i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152, i64 4613937818241073152>, <8 x i64> %1089
  %1097 = load <8 x i64>, ptr %1095, align 8
  %1098 = select <8 x i1> %873, <8 x i64> %1096, <8 x i64> %1097
  store <8 x i64> %1098, ptr %1095, align 8
  br label %1099

1099:                                             ; preds = %1007, %1086
  %1100 = phi <8 x double> [ %1008, %1007 ], [ %1090, %1086 ]
  %1101 = load ptr, ptr %109, align 8
  store <8 x double> %1100, ptr %1101, align 8
  %1102 = load ptr, ptr %44, align 8
  %1103 = select <8 x i1> %854, <8 x double> %839, <8 x double> %201
  store <8 x double> %1103, ptr %1102, align 8
  br i1 %113, label %1121, label %1114

1104:                                             ; preds = %838, %1104
  %1105 = phi i64 [ %1112, %1104 ], [ %850, %838 ]
  %1106 = load ptr, ptr %107, align 8
  call fastcc void @write_outputs(ptr noundef %0, ptr noundef %1106, i64 noundef %1105) #10
  %1107 = load ptr, ptr %97, align 8
  %1108 = load <8 x double>, ptr %1107, align 8
  %1109 = fcmp oeq <8 x double> %1108, %839
  %1110 = bitcast <8 x i1> %1109 to i8
  %1111 = zext i8 %1110 to i64
  %1112 = and i64 %1105, %1111
  %1113 = icmp eq i64 %1112, 0
  br i1 %1113, label %852, label %1104, !llvm.loop !20

1114:                                             ; preds = %1121, %1099
  %1115 = load ptr, ptr %115, align 8
  %1116 = load ptr, ptr %0, align 8
  %1117 = load i64, ptr %1116, align 8
  %1118 = load i64, ptr %116, align 8
  %1119 = mul nsw i64 %1118, %1117
  %1120 = getelementptr inbounds double, ptr %1115, i64 %1119
  br i1 %117, label %1135, label %1133

1121:                                             ; preds = %1099, %1121
  %1122 = phi i64 [ %1131, %1121 ], [ 0, %1099 ]
  %1123 = load ptr, ptr %12, align 8
  %1124 = load ptr, ptr %114, align 8
  %1125 = shl nsw i64 %1122, 6
  %1126 = getelementptr inbounds i8, ptr %1124, i64 %1125
  %1127 = load <8 x i64>, ptr %1126, align 8
  %1128 = getelementptr inbounds i8, ptr %1123, i64 %1125
  %1129 = load <8 x i64>, ptr %1128, align 8
  %1130 = select <8 x i1> %854, <8 x i64> %1127, <8 x i64> %1129
  store <8 x i64> %1130, ptr %1128, align 8
  %1131 = add nuw nsw i64 %1122, 1
  %1132 = icmp eq i64 %1131, %16
  br i1 %1132, label %1114, label %1121, !llvm.loop !21

1133:                                             ; preds = %1135, %1114
  %1134 = icmp eq i64 %844, 0
  br i1 %1134, label %1156, label %1146

1135:                                             ; preds = %1114, %1135
  %1136 = phi i64 [ %1144, %1135 ], [ 0, %1114 ]
  %1137 = load ptr, ptr %115, align 8
  %1138 = shl nsw i64 %1136, 6
  %1139 = getelementptr inbounds i8, ptr %1120, i64 %1138
  %1140 = load <8 x i64>, ptr %1139, align 8
  %1141 = getelementptr inbounds i8, ptr %1137, i64 %1138
  %1142 = load <8 x i64>, ptr %1141, align 8
  %1143 = select <8 x i1> %854, <8 x i64> %1140, <8 x i64> %1142
  store <8 x i64> %1143, ptr %1141, align 8
  %1144 = add nuw nsw i64 %1136, 1
  %1145 = icmp eq i64 %1144, %16
  br i1 %1145, label %1133, label %1135, !llvm.loop !22

1146:                                             ; preds = %1133
  %1147 = call fastcc i64 @act_in_lanes(ptr noundef %0, i64 noundef %844, ptr noundef nonnull %7) #10
  %1148 = icmp ne i32 %842, 0
  %1149 = icmp ne i64 %1147, %844
  %1150 = select i1 %1148, i1 true, i1 %1149
  %1151 = zext i1 %1150 to i32
  %1152 = trunc i64 %844 to i8
  %1153 = bitcast i8 %1152 to <8 x i1>
  %1154 = xor <8 x i1> %1153, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %1155 = and <8 x i1> %1154, %854
  br label %1156

1156:                                             ; preds = %1146, %1133
  %1157 = phi i32 [ %1151, %1146 ], [ %842, %1133 ]
  %1158 = phi <8 x i1> [ %1155, %1146 ], [ %854, %1133 ]
  %1159 = phi i64 [ %1147, %1146 ], [ %169, %1133 ]
  %1160 = load ptr, ptr %97, align 8
  %1161 = load <8 x double>, ptr %1160, align 8
  %1162 = fcmp oeq <8 x double> %1161, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %1163 = select <8 x i1> %1162, <8 x i1> %1158, <8 x i1> zeroinitializer
  %1164 = bitcast <8 x i1> %1163 to i8
  %1165 = zext i8 %1164 to i64
  %1166 = icmp eq i8 %1164, 0
  br i1 %1166, label %1168, label %1167

1167:                                             ; preds = %1156
  call fastcc void @retire(ptr noundef %0, i64 noundef %1165, i64 noundef 0) #10
  br label %1168

1168:                                             ; preds = %1167, %1156
  %1169 = phi i32 [ 1, %1167 ], [ %1157, %1156 ]
  %1170 = fcmp oeq <8 x double> %839, %207
  %1171 = select <8 x i1> %1170, <8 x i1> %1158, <8 x i1> zeroinitializer
  %1172 = bitcast <8 x i1> %1171 to i8
  %1173 = zext i8 %1172 to i64
  %1174 = xor i64 %1165, -1
  %1175 = and i64 %1174, %1173
  %1176 = icmp eq i64 %1175, 0
  br i1 %1176, label %1181, label %1177

1177:                                             ; preds = %1168
  %1178 = call fastcc i64 @start_again(ptr noundef %0, ptr noundef nonnull %2, i64 noundef %1175) #10
  %1179 = icmp eq i64 %1178, 0
  %1180 = select i1 %1179, i32 %1169, i32 1
  br label %1181

1181:                                             ; preds = %1177, %1168
  %1182 = phi i32 [ %1169, %1168 ], [ %1180, %1177 ]
  br label %164

1183:                                             ; preds = %167, %192, %160
  %1184 = phi i64 [ 1, %160 ], [ 0, %192 ], [ 0, %167 ]
  ret i64 %1184
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
  %348 = getelementptr inbounds i8, ptr %347, i64 48
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
  %363 = getelementptr inbounds i8, ptr %362, i64 56
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
  %27 = load ptr, ptr %21, align 8
  %28 = getelementptr inbounds i8, ptr %27, i64 40
  %29 = load i64, ptr %28, align 8
  %30 = icmp eq i64 %29, 0
  br i1 %30, label %32, label %31

31:                                               ; preds = %4
  tail call fastcc void @settle(ptr noundef nonnull %21) #10
  br label %32

32:                                               ; preds = %31, %4
  %33 = getelementptr inbounds i8, ptr %21, i64 152
  %34 = load i64, ptr %33, align 8
  %35 = icmp sgt i64 %34, 0
  br i1 %35, label %36, label %37

36:                                               ; preds = %32
  tail call fastcc void @sample(ptr noundef nonnull %21) #10
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
  %47 = tail call i32 %46(ptr noundef %40, ptr noundef %22, ptr noundef %42, ptr noundef %44, ptr noundef %24) #11
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
  br i1 %77, label %62, label %56, !llvm.loop !34

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
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %121, ptr noundef %121, ptr noundef nonnull %116, i64 noundef %120) #10
  %122 = load <8 x double>, ptr %5, align 16
  %123 = getelementptr inbounds i8, ptr %116, i64 168
  %124 = load ptr, ptr %123, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %124, ptr noundef %121, ptr noundef nonnull %116, i64 noundef %120) #10
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
  tail call fastcc void @settle(ptr noundef nonnull %148) #10
  br label %163

163:                                              ; preds = %162, %147
  %164 = getelementptr inbounds i8, ptr %148, i64 152
  %165 = load i64, ptr %164, align 8
  %166 = icmp sgt i64 %165, 0
  br i1 %166, label %167, label %187

167:                                              ; preds = %163
  tail call fastcc void @sample(ptr noundef nonnull %148) #10
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
  br i1 %186, label %168, label %147, !llvm.loop !35

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
  %197 = tail call i32 %196(ptr noundef %190, ptr noundef %151, ptr noundef %192, ptr noundef %194, ptr noundef %155) #11
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
  br i1 %215, label %216, label %206, !llvm.loop !36

216:                                              ; preds = %206, %187
  %217 = load ptr, ptr %116, align 8
  call fastcc void @norm_to(ptr noundef nonnull %7, ptr noundef %204, ptr noundef %217, ptr noundef nonnull %116, i64 noundef %120) #10
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
  br i1 %345, label %346, label %321, !llvm.loop !37

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
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %354, i64 noundef 3) #10
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %362, i64 noundef 0) #10
  ret void

374:                                              ; preds = %350, %374
  %375 = phi i64 [ %348, %350 ], [ %386, %374 ]
  %376 = load ptr, ptr %12, align 8
  tail call fastcc void @write_outputs(ptr noundef %0, ptr noundef %376, i64 noundef %375) #10
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
  br i1 %387, label %353, label %374, !llvm.loop !38
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
  br i1 %31, label %19, label %32, !llvm.loop !39

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
  %26 = load ptr, ptr %18, align 8
  %27 = getelementptr inbounds i8, ptr %26, i64 40
  %28 = load i64, ptr %27, align 8
  %29 = icmp eq i64 %28, 0
  br i1 %29, label %31, label %30

30:                                               ; preds = %17
  tail call fastcc void @settle(ptr noundef nonnull %18) #10
  br label %31

31:                                               ; preds = %30, %17
  %32 = getelementptr inbounds i8, ptr %18, i64 152
  %33 = load i64, ptr %32, align 8
  %34 = icmp sgt i64 %33, 0
  br i1 %34, label %35, label %36

35:                                               ; preds = %31
  tail call fastcc void @sample(ptr noundef nonnull %18) #10
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
  %46 = tail call i32 %45(ptr noundef %39, ptr noundef %21, ptr noundef %41, ptr noundef %43, ptr noundef %23) #11
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
  tail call fastcc void @retire(ptr noundef %0, i64 noundef %56, i64 noundef 3) #10
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
  br i1 %77, label %62, label %54, !llvm.loop !64
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
  br i1 %33, label %21, label %34, !llvm.loop !39

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
  br i1 %54, label %6, label %7, !llvm.loop !65
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
  br i1 %25, label %15, label %14, !llvm.loop !66

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
  br i1 %76, label %65, label %77, !llvm.loop !67

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
  br i1 %105, label %22, label %26, !llvm.loop !68
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
  br i1 %48, label %13, label %20, !llvm.loop !69
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
  br i1 %60, label %29, label %33, !llvm.loop !70

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
  br i1 %76, label %57, label %61, !llvm.loop !71
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
  br i1 %50, label %51, label %25, !llvm.loop !72

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
  br i1 %98, label %14, label %19, !llvm.loop !73

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
  br i1 %123, label %104, label %110, !llvm.loop !72

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
  br i1 %138, label %99, label %139, !llvm.loop !74

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
  br i1 %26, label %101, label %27

27:                                               ; preds = %4
  %28 = getelementptr inbounds i8, ptr %0, i64 1392
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
  tail call fastcc void @nested(ptr noundef %37, ptr noundef %40, ptr noundef %42, i64 noundef %44, i64 noundef %48, ptr noundef %49, i64 noundef %54) #10
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
  tail call fastcc void @settle(ptr noundef nonnull %30) #10
  br label %64

64:                                               ; preds = %63, %27
  %65 = getelementptr inbounds i8, ptr %0, i64 296
  %66 = load i64, ptr %65, align 8
  %67 = icmp sgt i64 %66, 0
  br i1 %67, label %68, label %69

68:                                               ; preds = %64
  tail call fastcc void @sample(ptr noundef nonnull %30) #10
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
  %79 = getelementptr inbounds i8, ptr %0, i64 1272
  %80 = load ptr, ptr %79, align 8
  %81 = inttoptr i64 %71 to ptr
  %82 = load ptr, ptr %81, align 8
  %83 = tail call i32 %82(ptr noundef %73, ptr noundef %76, ptr noundef %78, ptr noundef %80, ptr noundef %29) #11
  %84 = zext i32 %83 to i64
  %85 = and i64 %84, %24
  %86 = icmp sgt i64 %9, 0
  br i1 %86, label %87, label %101

87:                                               ; preds = %69
  %88 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %100, label %101, label %89, !llvm.loop !75

101:                                              ; preds = %89, %69, %4
  %102 = phi i64 [ 0, %4 ], [ %85, %69 ], [ %85, %89 ]
  %103 = getelementptr inbounds i8, ptr %0, i64 1368
  %104 = shl i64 %9, 6
  %105 = getelementptr inbounds i8, ptr %0, i64 144
  %106 = getelementptr inbounds i8, ptr %1, i64 16
  %107 = getelementptr inbounds i8, ptr %1, i64 8
  %108 = getelementptr inbounds i8, ptr %0, i64 168
  %109 = getelementptr inbounds i8, ptr %0, i64 296
  %110 = getelementptr inbounds i8, ptr %0, i64 168
  %111 = getelementptr inbounds i8, ptr %0, i64 192
  %112 = getelementptr inbounds i8, ptr %0, i64 1272
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
  %121 = getelementptr inbounds i8, ptr %0, i64 1416
  %122 = load ptr, ptr %121, align 8
  %123 = getelementptr inbounds i8, ptr %0, i64 1368
  %124 = load ptr, ptr %123, align 8
  %125 = getelementptr inbounds i8, ptr %5, i64 64
  br label %195

126:                                              ; preds = %101, %172
  %127 = phi i64 [ 1, %101 ], [ %186, %172 ]
  %128 = phi i64 [ %102, %101 ], [ %185, %172 ]
  %129 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %127
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
  tail call fastcc void @nested(ptr noundef %143, ptr noundef %146, ptr noundef %148, i64 noundef %150, i64 noundef %154, ptr noundef %155, i64 noundef %159) #10
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
  tail call fastcc void @settle(ptr noundef nonnull %105) #10
  br label %168

168:                                              ; preds = %167, %126
  %169 = load i64, ptr %109, align 8
  %170 = icmp sgt i64 %169, 0
  br i1 %170, label %171, label %172

171:                                              ; preds = %168
  tail call fastcc void @sample(ptr noundef nonnull %105) #10
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
  %183 = tail call i32 %182(ptr noundef %175, ptr noundef %178, ptr noundef %179, ptr noundef %180, ptr noundef %133) #11
  %184 = zext i32 %183 to i64
  %185 = or i64 %128, %184
  %186 = add nuw nsw i64 %127, 1
  %187 = icmp eq i64 %186, 5
  br i1 %187, label %113, label %126, !llvm.loop !76

188:                                              ; preds = %316, %113
  %189 = phi <8 x i64> [ %118, %113 ], [ %318, %316 ]
  %190 = icmp sgt i64 %9, 0
  br i1 %190, label %191, label %321

191:                                              ; preds = %188
  %192 = getelementptr inbounds i8, ptr %0, i64 1368
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
  br i1 %237, label %203, label %208, !llvm.loop !77

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
  %261 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %257
  %262 = load double, ptr %261, align 8
  %263 = add nuw nsw i64 %257, 1
  %264 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %263
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
  %283 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %260
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
  br i1 %315, label %316, label %256, !llvm.loop !78

316:                                              ; preds = %313
  %317 = xor <8 x i64> %314, <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %318 = and <8 x i64> %251, %317
  %319 = add nuw nsw i64 %198, 1
  %320 = icmp eq i64 %319, %9
  br i1 %320, label %188, label %195, !llvm.loop !79

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
  br i1 %342, label %321, label %330, !llvm.loop !80
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
  br i1 %149, label %24, label %129, !llvm.loop !81

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
  br i1 %168, label %150, label %147, !llvm.loop !82
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
  br i1 %31, label %20, label %19, !llvm.loop !83

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
  br i1 %43, label %32, label %24, !llvm.loop !84
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
!70 = distinct !{!70, !4, !5}
!71 = distinct !{!71, !4, !5, !25}
!72 = distinct !{!72, !4, !5}
!73 = distinct !{!73, !4, !5}
!74 = distinct !{!74, !4, !5}
!75 = distinct !{!75, !4, !5}
!76 = distinct !{!76, !4, !5}
!77 = distinct !{!77, !4, !5}
!78 = distinct !{!78, !4, !5}
!79 = distinct !{!79, !4, !5}
!80 = distinct !{!80, !4, !5}
!81 = distinct !{!81, !4, !5, !25}
!82 = distinct !{!82, !4, !5}
!83 = distinct !{!83, !4, !5}
!84 = distinct !{!84, !4, !5}
