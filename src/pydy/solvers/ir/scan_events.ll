; sources 744b944eee4df1039188d3911a00085148c9753e5c2faa6adea9f3245d1c4823
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

define i64 @scan_events(ptr noundef %0, double noundef %1, double noundef %2) #0 {
  %4 = alloca %struct.Stepper, align 8
  store ptr %0, ptr %4, align 8
  %5 = getelementptr inbounds i8, ptr %4, i64 8
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %6, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %4, i64 16
  %8 = getelementptr inbounds i8, ptr %0, i64 312
  store ptr %8, ptr %7, align 8
  %9 = getelementptr inbounds i8, ptr %0, i64 720
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 768
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 864
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %0, i64 816
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 840
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds i8, ptr %0, i64 576
  %22 = getelementptr inbounds i8, ptr %0, i64 600
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %23, i64 80
  %25 = load i64, ptr %24, align 8
  %26 = load ptr, ptr %21, align 8
  %27 = getelementptr inbounds i8, ptr %0, i64 888
  %28 = getelementptr inbounds i8, ptr %0, i64 408
  %29 = getelementptr inbounds i8, ptr %0, i64 504
  %30 = getelementptr inbounds i8, ptr %0, i64 320
  %31 = getelementptr inbounds i8, ptr %0, i64 168
  %32 = getelementptr inbounds i8, ptr %0, i64 248
  %33 = getelementptr inbounds i8, ptr %0, i64 168
  %34 = getelementptr inbounds i8, ptr %0, i64 192
  %35 = getelementptr inbounds i8, ptr %0, i64 744
  %36 = icmp sgt i64 %12, 0
  %37 = getelementptr inbounds i8, ptr %0, i64 792
  %38 = icmp slt i64 %12, 1
  %39 = getelementptr double, ptr %16, i64 %12
  %40 = icmp sgt i64 %12, 0
  %41 = getelementptr double, ptr %16, i64 %12
  %42 = getelementptr inbounds i8, ptr %0, i64 792
  %43 = getelementptr inbounds i8, ptr %26, i64 48
  %44 = icmp sgt i64 %12, 0
  %45 = getelementptr inbounds i8, ptr %0, i64 912
  %46 = getelementptr inbounds i8, ptr %0, i64 920
  %47 = getelementptr inbounds i8, ptr %0, i64 936
  %48 = getelementptr inbounds i8, ptr %0, i64 960
  %49 = getelementptr inbounds i8, ptr %0, i64 976
  %50 = getelementptr inbounds i8, ptr %26, i64 48
  %51 = icmp sgt i64 %12, 0
  %52 = getelementptr inbounds i8, ptr %26, i64 48
  %53 = icmp sgt i64 %12, 0
  br label %58

54:                                               ; preds = %491
  %55 = add nuw nsw i32 %62, 1
  %56 = icmp ugt i32 %62, 3
  %57 = icmp eq i32 %55, 5
  br i1 %57, label %496, label %58, !llvm.loop !3

58:                                               ; preds = %3, %54
  %59 = phi i1 [ false, %3 ], [ %56, %54 ]
  %60 = phi i64 [ undef, %3 ], [ %494, %54 ]
  %61 = phi double [ 0.000000e+00, %3 ], [ %493, %54 ]
  %62 = phi i32 [ 1, %3 ], [ %55, %54 ]
  %63 = uitofp nneg i32 %62 to double
  %64 = fmul double %63, 2.500000e-01
  %65 = load ptr, ptr %27, align 8
  %66 = load ptr, ptr %28, align 8
  %67 = insertelement <8 x double> poison, double %64, i64 0
  %68 = shufflevector <8 x double> %67, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %68, ptr %66, align 8
  %69 = load ptr, ptr %8, align 8
  %70 = load ptr, ptr %29, align 8
  %71 = load i64, ptr %30, align 8
  %72 = load ptr, ptr %0, align 8
  %73 = getelementptr inbounds i8, ptr %72, i64 24
  %74 = load i64, ptr %73, align 8
  %75 = load ptr, ptr %28, align 8
  %76 = load ptr, ptr %6, align 8
  %77 = getelementptr inbounds i8, ptr %76, i64 16
  %78 = load i64, ptr %77, align 8
  tail call fastcc void @nested(ptr noundef %65, ptr noundef %69, ptr noundef %70, i64 noundef %71, i64 noundef %74, ptr noundef %75, i64 noundef %78) #7
  %79 = fmul double %64, %2
  %80 = fadd double %79, %1
  %81 = load ptr, ptr %31, align 8
  store double %80, ptr %81, align 8
  %82 = load i64, ptr %32, align 8
  %83 = icmp sgt i64 %82, 0
  br i1 %83, label %84, label %85

84:                                               ; preds = %58
  tail call fastcc void @sample(ptr noundef nonnull %6) #7
  br label %85

85:                                               ; preds = %58, %84
  %86 = load ptr, ptr %9, align 8
  %87 = load i64, ptr %86, align 8
  %88 = load ptr, ptr %33, align 8
  %89 = load ptr, ptr %27, align 8
  %90 = load ptr, ptr %34, align 8
  %91 = load ptr, ptr %35, align 8
  %92 = load ptr, ptr %15, align 8
  %93 = inttoptr i64 %87 to ptr
  %94 = tail call i32 %93(ptr noundef %88, ptr noundef %89, ptr noundef %90, ptr noundef %91, ptr noundef %92) #8
  %95 = icmp slt i32 %94, 0
  br i1 %95, label %96, label %101

96:                                               ; preds = %85
  %97 = load ptr, ptr %22, align 8
  %98 = getelementptr inbounds i8, ptr %97, i64 80
  store i64 %25, ptr %98, align 8
  %99 = load ptr, ptr %21, align 8
  %100 = getelementptr inbounds i8, ptr %99, i64 48
  store double 1.000000e+00, ptr %100, align 8
  br label %491

101:                                              ; preds = %85, %473
  %102 = phi double [ %475, %473 ], [ %61, %85 ]
  %103 = phi i64 [ %476, %473 ], [ %60, %85 ]
  br i1 %36, label %108, label %104

104:                                              ; preds = %158, %101
  %105 = phi double [ 2.000000e+00, %101 ], [ %159, %158 ]
  %106 = phi i32 [ 0, %101 ], [ %160, %158 ]
  %107 = fcmp ogt double %105, 1.000000e+00
  br i1 %107, label %473, label %163

108:                                              ; preds = %101, %158
  %109 = phi i64 [ %161, %158 ], [ 0, %101 ]
  %110 = phi i32 [ %160, %158 ], [ 0, %101 ]
  %111 = phi double [ %159, %158 ], [ 2.000000e+00, %101 ]
  %112 = getelementptr inbounds i64, ptr %20, i64 %109
  store i64 0, ptr %112, align 8
  %113 = getelementptr inbounds i64, ptr %18, i64 %109
  %114 = load i64, ptr %113, align 8
  %115 = getelementptr inbounds double, ptr %16, i64 %109
  %116 = load double, ptr %115, align 8
  %117 = getelementptr inbounds i64, ptr %14, i64 %109
  %118 = load i64, ptr %117, align 8
  %119 = icmp slt i64 %114, 0
  %120 = fcmp ogt double %116, 0.000000e+00
  %121 = and i1 %119, %120
  %122 = icmp sgt i64 %118, -1
  %123 = and i1 %121, %122
  br i1 %123, label %131, label %124

124:                                              ; preds = %108
  %125 = icmp sgt i64 %114, 0
  %126 = fcmp olt double %116, 0.000000e+00
  %127 = and i1 %125, %126
  br i1 %127, label %128, label %131

128:                                              ; preds = %124
  %129 = icmp slt i64 %118, 1
  %130 = zext i1 %129 to i32
  br label %131

131:                                              ; preds = %108, %124, %128
  %132 = phi i32 [ 1, %108 ], [ 0, %124 ], [ %130, %128 ]
  %133 = icmp eq i32 %132, 0
  br i1 %133, label %134, label %138

134:                                              ; preds = %131
  %135 = icmp eq i64 %114, 0
  %136 = fcmp ord double %116, 0.000000e+00
  %137 = or i1 %135, %136
  br i1 %137, label %158, label %138

138:                                              ; preds = %134, %131
  %139 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %102, double noundef %64, i64 noundef %109) #7
  %140 = fcmp ole double %139, %102
  %141 = zext i1 %140 to i64
  store i64 %141, ptr %112, align 8
  %142 = fcmp uge double %139, %111
  %143 = select i1 %142, i32 %110, i32 0
  %144 = fcmp ugt double %139, %111
  br i1 %144, label %155, label %145

145:                                              ; preds = %138
  %146 = icmp eq i32 %143, 0
  br i1 %146, label %147, label %152

147:                                              ; preds = %145
  %148 = load ptr, ptr %37, align 8
  %149 = getelementptr inbounds i64, ptr %148, i64 %109
  %150 = load i64, ptr %149, align 8
  %151 = icmp eq i64 %150, 1
  br label %152

152:                                              ; preds = %147, %145
  %153 = phi i1 [ true, %145 ], [ %151, %147 ]
  %154 = zext i1 %153 to i32
  br label %155

155:                                              ; preds = %152, %138
  %156 = phi i32 [ %154, %152 ], [ %143, %138 ]
  %157 = select i1 %142, double %111, double %139
  br label %158

158:                                              ; preds = %134, %155
  %159 = phi double [ %157, %155 ], [ %111, %134 ]
  %160 = phi i32 [ %156, %155 ], [ %110, %134 ]
  %161 = add nuw nsw i64 %109, 1
  %162 = icmp eq i64 %161, %12
  br i1 %162, label %104, label %108, !llvm.loop !6

163:                                              ; preds = %104
  %164 = load ptr, ptr %27, align 8
  %165 = load ptr, ptr %28, align 8
  %166 = insertelement <8 x double> poison, double %105, i64 0
  %167 = shufflevector <8 x double> %166, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %167, ptr %165, align 8
  %168 = load ptr, ptr %8, align 8
  %169 = load ptr, ptr %29, align 8
  %170 = load i64, ptr %30, align 8
  %171 = load ptr, ptr %0, align 8
  %172 = getelementptr inbounds i8, ptr %171, i64 24
  %173 = load i64, ptr %172, align 8
  %174 = load ptr, ptr %28, align 8
  %175 = load ptr, ptr %6, align 8
  %176 = getelementptr inbounds i8, ptr %175, i64 16
  %177 = load i64, ptr %176, align 8
  tail call fastcc void @nested(ptr noundef %164, ptr noundef %168, ptr noundef %169, i64 noundef %170, i64 noundef %173, ptr noundef %174, i64 noundef %177) #7
  %178 = fmul double %105, %2
  %179 = fadd double %178, %1
  %180 = load ptr, ptr %31, align 8
  store double %179, ptr %180, align 8
  %181 = load i64, ptr %32, align 8
  %182 = icmp sgt i64 %181, 0
  br i1 %182, label %183, label %184

183:                                              ; preds = %163
  tail call fastcc void @sample(ptr noundef nonnull %6) #7
  br label %184

184:                                              ; preds = %163, %183
  %185 = load ptr, ptr %9, align 8
  %186 = load i64, ptr %185, align 8
  %187 = load ptr, ptr %33, align 8
  %188 = load ptr, ptr %27, align 8
  %189 = load ptr, ptr %34, align 8
  %190 = load ptr, ptr %35, align 8
  %191 = load ptr, ptr %15, align 8
  %192 = getelementptr inbounds i8, ptr %185, i64 8
  %193 = load i64, ptr %192, align 8
  %194 = getelementptr inbounds double, ptr %191, i64 %193
  %195 = inttoptr i64 %186 to ptr
  %196 = tail call i32 %195(ptr noundef %187, ptr noundef %188, ptr noundef %189, ptr noundef %190, ptr noundef %194) #8
  %197 = icmp slt i32 %196, 0
  br i1 %197, label %201, label %198

198:                                              ; preds = %184
  %199 = icmp ne i32 %106, 0
  %200 = select i1 %38, i1 true, i1 %199
  br i1 %200, label %302, label %206

201:                                              ; preds = %184
  %202 = load ptr, ptr %22, align 8
  %203 = getelementptr inbounds i8, ptr %202, i64 80
  store i64 %25, ptr %203, align 8
  %204 = load ptr, ptr %21, align 8
  %205 = getelementptr inbounds i8, ptr %204, i64 48
  store double 1.000000e+00, ptr %205, align 8
  br label %473

206:                                              ; preds = %198, %296
  %207 = phi i1 [ %301, %296 ], [ %200, %198 ]
  %208 = phi i64 [ %298, %296 ], [ %103, %198 ]
  %209 = phi i64 [ %299, %296 ], [ 0, %198 ]
  %210 = phi double [ %297, %296 ], [ %105, %198 ]
  %211 = getelementptr inbounds i64, ptr %18, i64 %209
  %212 = load i64, ptr %211, align 8
  %213 = getelementptr double, ptr %39, i64 %209
  %214 = load double, ptr %213, align 8
  %215 = getelementptr inbounds i64, ptr %14, i64 %209
  %216 = load i64, ptr %215, align 8
  %217 = icmp slt i64 %212, 0
  %218 = fcmp ogt double %214, 0.000000e+00
  %219 = and i1 %217, %218
  %220 = icmp sgt i64 %216, -1
  %221 = and i1 %219, %220
  br i1 %221, label %229, label %222

222:                                              ; preds = %206
  %223 = icmp sgt i64 %212, 0
  %224 = fcmp olt double %214, 0.000000e+00
  %225 = and i1 %223, %224
  br i1 %225, label %226, label %229

226:                                              ; preds = %222
  %227 = icmp slt i64 %216, 1
  %228 = zext i1 %227 to i32
  br label %229

229:                                              ; preds = %206, %222, %226
  %230 = phi i32 [ 1, %206 ], [ 0, %222 ], [ %228, %226 ]
  %231 = icmp eq i32 %230, 0
  br i1 %231, label %296, label %232

232:                                              ; preds = %229
  %233 = getelementptr inbounds double, ptr %16, i64 %209
  %234 = load double, ptr %233, align 8
  %235 = fcmp ogt double %234, 0.000000e+00
  %236 = and i1 %217, %235
  %237 = and i1 %220, %236
  br i1 %237, label %245, label %238

238:                                              ; preds = %232
  %239 = icmp sgt i64 %212, 0
  %240 = fcmp olt double %234, 0.000000e+00
  %241 = and i1 %239, %240
  br i1 %241, label %242, label %245

242:                                              ; preds = %238
  %243 = icmp slt i64 %216, 1
  %244 = zext i1 %243 to i32
  br label %245

245:                                              ; preds = %232, %238, %242
  %246 = phi i32 [ 1, %232 ], [ 0, %238 ], [ %244, %242 ]
  %247 = icmp eq i32 %246, 0
  br i1 %247, label %248, label %296

248:                                              ; preds = %245
  %249 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %102, double noundef %210, i64 noundef %209) #7
  %250 = fcmp ogt double %249, %102
  br i1 %250, label %251, label %253

251:                                              ; preds = %248
  %252 = getelementptr inbounds i64, ptr %20, i64 %209
  store i64 2, ptr %252, align 8
  br label %253

253:                                              ; preds = %251, %248
  %254 = phi double [ %249, %251 ], [ %210, %248 ]
  %255 = load ptr, ptr %27, align 8
  %256 = load ptr, ptr %28, align 8
  %257 = insertelement <8 x double> poison, double %254, i64 0
  %258 = shufflevector <8 x double> %257, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %258, ptr %256, align 8
  %259 = load ptr, ptr %8, align 8
  %260 = load ptr, ptr %29, align 8
  %261 = load i64, ptr %30, align 8
  %262 = load ptr, ptr %0, align 8
  %263 = getelementptr inbounds i8, ptr %262, i64 24
  %264 = load i64, ptr %263, align 8
  %265 = load ptr, ptr %28, align 8
  %266 = load ptr, ptr %6, align 8
  %267 = getelementptr inbounds i8, ptr %266, i64 16
  %268 = load i64, ptr %267, align 8
  tail call fastcc void @nested(ptr noundef %255, ptr noundef %259, ptr noundef %260, i64 noundef %261, i64 noundef %264, ptr noundef %265, i64 noundef %268) #7
  %269 = fmul double %254, %2
  %270 = fadd double %269, %1
  %271 = load ptr, ptr %31, align 8
  store double %270, ptr %271, align 8
  %272 = load i64, ptr %32, align 8
  %273 = icmp sgt i64 %272, 0
  br i1 %273, label %274, label %275

274:                                              ; preds = %253
  tail call fastcc void @sample(ptr noundef nonnull %6) #7
  br label %275

275:                                              ; preds = %253, %274
  %276 = load ptr, ptr %9, align 8
  %277 = load i64, ptr %276, align 8
  %278 = load ptr, ptr %33, align 8
  %279 = load ptr, ptr %27, align 8
  %280 = load ptr, ptr %34, align 8
  %281 = load ptr, ptr %35, align 8
  %282 = load ptr, ptr %15, align 8
  %283 = getelementptr inbounds i8, ptr %276, i64 8
  %284 = load i64, ptr %283, align 8
  %285 = getelementptr inbounds double, ptr %282, i64 %284
  %286 = inttoptr i64 %277 to ptr
  %287 = tail call i32 %286(ptr noundef %278, ptr noundef %279, ptr noundef %280, ptr noundef %281, ptr noundef %285) #8
  %288 = icmp sgt i32 %287, -1
  br i1 %288, label %294, label %289

289:                                              ; preds = %275
  %290 = load ptr, ptr %22, align 8
  %291 = getelementptr inbounds i8, ptr %290, i64 80
  store i64 %25, ptr %291, align 8
  %292 = load ptr, ptr %21, align 8
  %293 = getelementptr inbounds i8, ptr %292, i64 48
  store double 1.000000e+00, ptr %293, align 8
  br label %294

294:                                              ; preds = %275, %289
  %295 = phi i64 [ -4, %289 ], [ %208, %275 ]
  br i1 %288, label %296, label %302

296:                                              ; preds = %229, %245, %294
  %297 = phi double [ %210, %245 ], [ %254, %294 ], [ %210, %229 ]
  %298 = phi i64 [ %208, %245 ], [ %295, %294 ], [ %208, %229 ]
  %299 = add nuw nsw i64 %209, 1
  %300 = icmp sge i64 %299, %12
  %301 = select i1 %300, i1 true, i1 %199
  br i1 %301, label %302, label %206, !llvm.loop !7

302:                                              ; preds = %294, %296, %198
  %303 = phi i1 [ %200, %198 ], [ %207, %294 ], [ %301, %296 ]
  %304 = phi i32 [ 10, %198 ], [ 1, %294 ], [ 10, %296 ]
  %305 = phi double [ %105, %198 ], [ %254, %294 ], [ %297, %296 ]
  %306 = phi i64 [ %103, %198 ], [ %295, %294 ], [ %298, %296 ]
  br i1 %303, label %307, label %473

307:                                              ; preds = %302
  br i1 %40, label %318, label %310

308:                                              ; preds = %405
  %309 = zext i1 %406 to i32
  br label %310

310:                                              ; preds = %308, %307
  %311 = phi i32 [ 0, %307 ], [ %309, %308 ]
  %312 = phi i64 [ -1, %307 ], [ %395, %308 ]
  %313 = icmp eq i32 %311, 0
  br i1 %313, label %314, label %409

314:                                              ; preds = %310
  br i1 %44, label %315, label %458

315:                                              ; preds = %314
  %316 = fmul double %305, %2
  %317 = fadd double %316, %1
  br label %410

318:                                              ; preds = %307, %405
  %319 = phi i64 [ %407, %405 ], [ 0, %307 ]
  %320 = phi i64 [ %395, %405 ], [ -1, %307 ]
  %321 = phi i1 [ %406, %405 ], [ false, %307 ]
  %322 = getelementptr double, ptr %41, i64 %319
  %323 = load double, ptr %322, align 8
  %324 = getelementptr inbounds i64, ptr %18, i64 %319
  %325 = load i64, ptr %324, align 8
  %326 = getelementptr inbounds i64, ptr %14, i64 %319
  %327 = load i64, ptr %326, align 8
  %328 = icmp slt i64 %325, 0
  %329 = fcmp ogt double %323, 0.000000e+00
  %330 = and i1 %329, %328
  %331 = icmp sgt i64 %327, -1
  %332 = and i1 %330, %331
  br i1 %332, label %340, label %333

333:                                              ; preds = %318
  %334 = icmp sgt i64 %325, 0
  %335 = fcmp olt double %323, 0.000000e+00
  %336 = and i1 %335, %334
  br i1 %336, label %337, label %340

337:                                              ; preds = %333
  %338 = icmp slt i64 %327, 1
  %339 = zext i1 %338 to i32
  br label %340

340:                                              ; preds = %318, %333, %337
  %341 = phi i32 [ 1, %318 ], [ 0, %333 ], [ %339, %337 ]
  %342 = icmp eq i32 %341, 0
  br i1 %342, label %343, label %368

343:                                              ; preds = %340
  %344 = getelementptr inbounds double, ptr %16, i64 %319
  %345 = load double, ptr %344, align 8
  %346 = fcmp ogt double %345, 0.000000e+00
  %347 = and i1 %328, %346
  %348 = and i1 %331, %347
  br i1 %348, label %356, label %349

349:                                              ; preds = %343
  %350 = icmp sgt i64 %325, 0
  %351 = fcmp olt double %345, 0.000000e+00
  %352 = and i1 %350, %351
  br i1 %352, label %353, label %356

353:                                              ; preds = %349
  %354 = icmp slt i64 %327, 1
  %355 = zext i1 %354 to i32
  br label %356

356:                                              ; preds = %343, %349, %353
  %357 = phi i32 [ 1, %343 ], [ 0, %349 ], [ %355, %353 ]
  %358 = icmp eq i32 %357, 0
  br i1 %358, label %368, label %359

359:                                              ; preds = %356
  %360 = fcmp oeq double %323, 0.000000e+00
  br i1 %360, label %365, label %361

361:                                              ; preds = %359
  %362 = getelementptr inbounds i64, ptr %20, i64 %319
  %363 = load i64, ptr %362, align 8
  %364 = icmp eq i64 %363, 1
  br label %365

365:                                              ; preds = %361, %359
  %366 = phi i1 [ true, %359 ], [ %364, %361 ]
  %367 = zext i1 %366 to i32
  br label %368

368:                                              ; preds = %365, %356, %340
  %369 = phi i32 [ 1, %340 ], [ %367, %365 ], [ 0, %356 ]
  %370 = icmp eq i32 %369, 0
  br i1 %370, label %371, label %377

371:                                              ; preds = %368
  %372 = getelementptr inbounds i64, ptr %20, i64 %319
  %373 = load i64, ptr %372, align 8
  %374 = icmp eq i64 %373, 2
  %375 = fcmp oeq double %323, 0.000000e+00
  %376 = and i1 %375, %374
  br label %377

377:                                              ; preds = %371, %368
  %378 = phi i1 [ true, %368 ], [ %376, %371 ]
  br i1 %378, label %394, label %379

379:                                              ; preds = %377
  %380 = getelementptr inbounds double, ptr %16, i64 %319
  %381 = load double, ptr %380, align 8
  %382 = icmp eq i64 %325, 0
  %383 = fcmp ord double %381, 0.000000e+00
  %384 = or i1 %382, %383
  br i1 %384, label %394, label %385

385:                                              ; preds = %379
  %386 = sitofp i64 %325 to double
  %387 = fmul double %323, %386
  %388 = fcmp olt double %387, 0.000000e+00
  br i1 %388, label %389, label %391

389:                                              ; preds = %385
  %390 = sub nsw i64 0, %325
  store i64 %390, ptr %324, align 8
  br label %394

391:                                              ; preds = %385
  %392 = fcmp ueq double %323, 0.000000e+00
  %393 = select i1 %392, i64 %319, i64 %320
  br label %394

394:                                              ; preds = %391, %389, %379, %377
  %395 = phi i64 [ %320, %377 ], [ %320, %389 ], [ %320, %379 ], [ %393, %391 ]
  %396 = zext i1 %378 to i64
  %397 = getelementptr inbounds i64, ptr %20, i64 %319
  store i64 %396, ptr %397, align 8
  %398 = xor i1 %378, true
  %399 = or i1 %321, %398
  br i1 %399, label %405, label %400

400:                                              ; preds = %394
  %401 = load ptr, ptr %42, align 8
  %402 = getelementptr inbounds i64, ptr %401, i64 %319
  %403 = load i64, ptr %402, align 8
  %404 = icmp eq i64 %403, 1
  br label %405

405:                                              ; preds = %394, %400
  %406 = phi i1 [ %321, %394 ], [ %404, %400 ]
  %407 = add nuw nsw i64 %319, 1
  %408 = icmp eq i64 %407, %12
  br i1 %408, label %308, label %318, !llvm.loop !8

409:                                              ; preds = %310
  store double %305, ptr %43, align 8
  br label %473

410:                                              ; preds = %315, %454
  %411 = phi i1 [ %44, %315 ], [ %456, %454 ]
  %412 = phi i64 [ 0, %315 ], [ %455, %454 ]
  %413 = getelementptr inbounds i64, ptr %20, i64 %412
  %414 = load i64, ptr %413, align 8
  %415 = icmp eq i64 %414, 0
  br i1 %415, label %454, label %416

416:                                              ; preds = %410
  %417 = load ptr, ptr %22, align 8
  %418 = getelementptr inbounds i8, ptr %417, i64 80
  %419 = load i64, ptr %418, align 8
  %420 = load ptr, ptr %6, align 8
  %421 = getelementptr inbounds i8, ptr %420, i64 8
  %422 = load i64, ptr %421, align 8
  %423 = load i64, ptr %46, align 8
  %424 = icmp eq i64 %423, 0
  br i1 %424, label %450, label %425

425:                                              ; preds = %416
  %426 = icmp eq i64 %419, %423
  br i1 %426, label %449, label %427

427:                                              ; preds = %425
  %428 = load ptr, ptr %45, align 8
  %429 = getelementptr inbounds double, ptr %428, i64 %419
  store double %317, ptr %429, align 8
  %430 = load ptr, ptr %47, align 8
  %431 = getelementptr inbounds i64, ptr %430, i64 %419
  store i64 %412, ptr %431, align 8
  %432 = icmp sgt i64 %422, 0
  br i1 %432, label %437, label %433

433:                                              ; preds = %437, %427
  %434 = add nsw i64 %419, 1
  %435 = load ptr, ptr %22, align 8
  %436 = getelementptr inbounds i8, ptr %435, i64 80
  store i64 %434, ptr %436, align 8
  br label %450

437:                                              ; preds = %427, %437
  %438 = phi i64 [ %447, %437 ], [ 0, %427 ]
  %439 = load ptr, ptr %27, align 8
  %440 = getelementptr inbounds double, ptr %439, i64 %438
  %441 = load double, ptr %440, align 8
  %442 = load ptr, ptr %48, align 8
  %443 = load i64, ptr %49, align 8
  %444 = mul nsw i64 %443, %419
  %445 = getelementptr double, ptr %442, i64 %444
  %446 = getelementptr double, ptr %445, i64 %438
  store double %441, ptr %446, align 8
  %447 = add nuw nsw i64 %438, 1
  %448 = icmp eq i64 %447, %422
  br i1 %448, label %433, label %437, !llvm.loop !9

449:                                              ; preds = %425
  store double %305, ptr %50, align 8
  br label %458

450:                                              ; preds = %433, %416
  %451 = getelementptr inbounds i64, ptr %18, i64 %412
  %452 = load i64, ptr %451, align 8
  %453 = sub nsw i64 0, %452
  store i64 %453, ptr %451, align 8
  br label %454

454:                                              ; preds = %410, %450
  %455 = add nuw nsw i64 %412, 1
  %456 = icmp slt i64 %455, %12
  %457 = icmp eq i64 %455, %12
  br i1 %457, label %458, label %410, !llvm.loop !10

458:                                              ; preds = %454, %314, %449
  %459 = phi i1 [ %411, %449 ], [ %44, %314 ], [ %456, %454 ]
  %460 = phi i32 [ 1, %449 ], [ 16, %314 ], [ 16, %454 ]
  %461 = phi i64 [ -3, %449 ], [ %306, %314 ], [ %306, %454 ]
  br i1 %459, label %473, label %462

462:                                              ; preds = %458
  %463 = icmp sgt i64 %312, -1
  br i1 %463, label %464, label %473

464:                                              ; preds = %462
  br i1 %51, label %466, label %465

465:                                              ; preds = %466, %464
  store double %305, ptr %52, align 8
  br label %473

466:                                              ; preds = %464, %466
  %467 = phi i64 [ %471, %466 ], [ 0, %464 ]
  %468 = icmp eq i64 %467, %312
  %469 = zext i1 %468 to i64
  %470 = getelementptr inbounds i64, ptr %20, i64 %467
  store i64 %469, ptr %470, align 8
  %471 = add nuw nsw i64 %467, 1
  %472 = icmp eq i64 %471, %12
  br i1 %472, label %465, label %466, !llvm.loop !11

473:                                              ; preds = %409, %465, %458, %462, %104, %302, %201
  %474 = phi i32 [ 1, %201 ], [ %304, %302 ], [ 5, %104 ], [ 1, %409 ], [ 1, %465 ], [ %460, %458 ], [ 0, %462 ]
  %475 = phi double [ %102, %201 ], [ %102, %302 ], [ %102, %104 ], [ %102, %409 ], [ %102, %465 ], [ %102, %458 ], [ %305, %462 ]
  %476 = phi i64 [ -4, %201 ], [ %306, %302 ], [ %103, %104 ], [ -2, %409 ], [ 21, %465 ], [ %461, %458 ], [ %461, %462 ]
  switch i32 %474, label %491 [
    i32 0, label %101
    i32 5, label %477
  ], !llvm.loop !12

477:                                              ; preds = %473
  br i1 %53, label %478, label %491

478:                                              ; preds = %477, %488
  %479 = phi i64 [ %489, %488 ], [ 0, %477 ]
  %480 = getelementptr inbounds double, ptr %16, i64 %479
  %481 = load double, ptr %480, align 8
  %482 = fcmp ogt double %481, 0.000000e+00
  br i1 %482, label %485, label %483

483:                                              ; preds = %478
  %484 = fcmp olt double %481, 0.000000e+00
  br i1 %484, label %485, label %488

485:                                              ; preds = %483, %478
  %486 = phi i64 [ 1, %478 ], [ -1, %483 ]
  %487 = getelementptr inbounds i64, ptr %18, i64 %479
  store i64 %486, ptr %487, align 8
  br label %488

488:                                              ; preds = %485, %483
  %489 = add nuw nsw i64 %479, 1
  %490 = icmp eq i64 %489, %12
  br i1 %490, label %491, label %478, !llvm.loop !13

491:                                              ; preds = %473, %488, %477, %96
  %492 = phi i32 [ 1, %96 ], [ 0, %477 ], [ 0, %488 ], [ %474, %473 ]
  %493 = phi double [ %61, %96 ], [ %64, %477 ], [ %64, %488 ], [ %475, %473 ]
  %494 = phi i64 [ -4, %96 ], [ %476, %477 ], [ %476, %488 ], [ %476, %473 ]
  %495 = icmp eq i32 %492, 0
  br i1 %495, label %54, label %496

496:                                              ; preds = %54, %491
  %497 = phi i1 [ %56, %54 ], [ %59, %491 ]
  br i1 %497, label %498, label %500

498:                                              ; preds = %496
  %499 = getelementptr inbounds i8, ptr %26, i64 48
  store double 1.000000e+00, ptr %499, align 8
  br label %500

500:                                              ; preds = %496, %498
  %501 = phi i64 [ 0, %498 ], [ %494, %496 ]
  ret i64 %501
}


define internal fastcc double @locate(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, double noundef %4, double noundef %5, i64 noundef %6) unnamed_addr #2 {
  %8 = getelementptr inbounds i8, ptr %0, i64 720
  %9 = getelementptr inbounds i8, ptr %0, i64 816
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i64, ptr %10, i64 %6
  %12 = load i64, ptr %11, align 8
  %13 = sitofp i64 %12 to double
  %14 = getelementptr inbounds i8, ptr %0, i64 864
  %15 = load ptr, ptr %14, align 8
  %16 = load ptr, ptr %8, align 8
  %17 = getelementptr inbounds i8, ptr %16, i64 8
  %18 = load i64, ptr %17, align 8
  %19 = getelementptr inbounds double, ptr %15, i64 %18
  %20 = getelementptr inbounds double, ptr %19, i64 %6
  %21 = fadd double %2, %3
  %22 = tail call double @llvm.fabs.f64(double %21)
  %23 = tail call double @llvm.fabs.f64(double %2)
  %24 = fcmp ogt double %22, %23
  %25 = select i1 %24, double %22, double %23
  %26 = fmul double %25, 0x3CB0000000000000
  %27 = fdiv double %26, %3
  %28 = getelementptr inbounds i8, ptr %0, i64 144
  %29 = getelementptr inbounds i8, ptr %0, i64 888
  %30 = load ptr, ptr %29, align 8
  %31 = getelementptr inbounds i8, ptr %1, i64 16
  %32 = load ptr, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %32, i64 96
  %34 = load ptr, ptr %33, align 8
  %35 = insertelement <8 x double> poison, double %4, i64 0
  %36 = shufflevector <8 x double> %35, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %36, ptr %34, align 8
  %37 = load ptr, ptr %32, align 8
  %38 = getelementptr inbounds i8, ptr %32, i64 192
  %39 = load ptr, ptr %38, align 8
  %40 = getelementptr inbounds i8, ptr %32, i64 8
  %41 = load i64, ptr %40, align 8
  %42 = load ptr, ptr %1, align 8
  %43 = load ptr, ptr %42, align 8
  %44 = getelementptr inbounds i8, ptr %43, i64 24
  %45 = load i64, ptr %44, align 8
  %46 = load ptr, ptr %33, align 8
  %47 = getelementptr inbounds i8, ptr %1, i64 8
  %48 = load ptr, ptr %47, align 8
  %49 = load ptr, ptr %48, align 8
  %50 = getelementptr inbounds i8, ptr %49, i64 16
  %51 = load i64, ptr %50, align 8
  tail call fastcc void @nested(ptr noundef %30, ptr noundef %37, ptr noundef %39, i64 noundef %41, i64 noundef %45, ptr noundef %46, i64 noundef %51) #7
  %52 = fmul double %3, %4
  %53 = fadd double %52, %2
  %54 = getelementptr inbounds i8, ptr %0, i64 168
  %55 = load ptr, ptr %54, align 8
  store double %53, ptr %55, align 8
  %56 = getelementptr inbounds i8, ptr %0, i64 248
  %57 = load i64, ptr %56, align 8
  %58 = icmp sgt i64 %57, 0
  br i1 %58, label %59, label %60

59:                                               ; preds = %7
  tail call fastcc void @sample(ptr noundef nonnull %28) #7
  br label %60

60:                                               ; preds = %7, %59
  %61 = load ptr, ptr %8, align 8
  %62 = load i64, ptr %61, align 8
  %63 = getelementptr inbounds i8, ptr %0, i64 168
  %64 = load ptr, ptr %63, align 8
  %65 = load ptr, ptr %29, align 8
  %66 = getelementptr inbounds i8, ptr %0, i64 192
  %67 = load ptr, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %0, i64 744
  %69 = load ptr, ptr %68, align 8
  %70 = load ptr, ptr %14, align 8
  %71 = getelementptr inbounds i8, ptr %61, i64 8
  %72 = load i64, ptr %71, align 8
  %73 = getelementptr inbounds double, ptr %70, i64 %72
  %74 = inttoptr i64 %62 to ptr
  %75 = tail call i32 %74(ptr noundef %64, ptr noundef %65, ptr noundef %67, ptr noundef %69, ptr noundef %73) #8
  %76 = load double, ptr %20, align 8
  %77 = fmul double %76, %13
  %78 = fcmp ugt double %77, 0.000000e+00
  br i1 %78, label %131, label %79

79:                                               ; preds = %60, %113
  %80 = phi double [ %83, %113 ], [ %5, %60 ]
  %81 = fsub double %80, %4
  %82 = fmul double %81, 5.000000e-01
  %83 = fadd double %82, %4
  %84 = fsub double %83, %4
  %85 = fcmp uge double %84, %27
  br i1 %85, label %86, label %129

86:                                               ; preds = %79
  %87 = load ptr, ptr %29, align 8
  %88 = load ptr, ptr %31, align 8
  %89 = getelementptr inbounds i8, ptr %88, i64 96
  %90 = load ptr, ptr %89, align 8
  %91 = insertelement <8 x double> poison, double %83, i64 0
  %92 = shufflevector <8 x double> %91, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %92, ptr %90, align 8
  %93 = load ptr, ptr %88, align 8
  %94 = getelementptr inbounds i8, ptr %88, i64 192
  %95 = load ptr, ptr %94, align 8
  %96 = getelementptr inbounds i8, ptr %88, i64 8
  %97 = load i64, ptr %96, align 8
  %98 = load ptr, ptr %1, align 8
  %99 = load ptr, ptr %98, align 8
  %100 = getelementptr inbounds i8, ptr %99, i64 24
  %101 = load i64, ptr %100, align 8
  %102 = load ptr, ptr %89, align 8
  %103 = load ptr, ptr %47, align 8
  %104 = load ptr, ptr %103, align 8
  %105 = getelementptr inbounds i8, ptr %104, i64 16
  %106 = load i64, ptr %105, align 8
  tail call fastcc void @nested(ptr noundef %87, ptr noundef %93, ptr noundef %95, i64 noundef %97, i64 noundef %101, ptr noundef %102, i64 noundef %106) #7
  %107 = fmul double %83, %3
  %108 = fadd double %107, %2
  %109 = load ptr, ptr %54, align 8
  store double %108, ptr %109, align 8
  %110 = load i64, ptr %56, align 8
  %111 = icmp sgt i64 %110, 0
  br i1 %111, label %112, label %113

112:                                              ; preds = %86
  tail call fastcc void @sample(ptr noundef nonnull %28) #7
  br label %113

113:                                              ; preds = %86, %112
  %114 = load ptr, ptr %8, align 8
  %115 = load i64, ptr %114, align 8
  %116 = load ptr, ptr %63, align 8
  %117 = load ptr, ptr %29, align 8
  %118 = load ptr, ptr %66, align 8
  %119 = load ptr, ptr %68, align 8
  %120 = load ptr, ptr %14, align 8
  %121 = getelementptr inbounds i8, ptr %114, i64 8
  %122 = load i64, ptr %121, align 8
  %123 = getelementptr inbounds double, ptr %120, i64 %122
  %124 = inttoptr i64 %115 to ptr
  %125 = tail call i32 %124(ptr noundef %116, ptr noundef %117, ptr noundef %118, ptr noundef %119, ptr noundef %123) #8
  %126 = load double, ptr %20, align 8
  %127 = fmul double %126, %13
  %128 = fcmp ogt double %127, 0.000000e+00
  br i1 %128, label %129, label %79, !llvm.loop !14

129:                                              ; preds = %113, %79
  %130 = phi double [ %4, %79 ], [ %83, %113 ]
  br i1 %85, label %131, label %193

131:                                              ; preds = %129, %60
  %132 = phi double [ %5, %60 ], [ %80, %129 ]
  %133 = phi double [ %4, %60 ], [ %130, %129 ]
  br label %134

134:                                              ; preds = %131, %190
  %135 = phi double [ %191, %190 ], [ %132, %131 ]
  %136 = phi double [ %192, %190 ], [ %133, %131 ]
  %137 = fsub double %135, %136
  %138 = fcmp ogt double %137, %27
  br i1 %138, label %139, label %193

139:                                              ; preds = %134
  %140 = fmul double %137, 5.000000e-01
  %141 = fadd double %136, %140
  %142 = fcmp une double %141, %136
  %143 = fcmp une double %141, %135
  %144 = and i1 %142, %143
  br i1 %144, label %145, label %190

145:                                              ; preds = %139
  %146 = load ptr, ptr %29, align 8
  %147 = load ptr, ptr %31, align 8
  %148 = getelementptr inbounds i8, ptr %147, i64 96
  %149 = load ptr, ptr %148, align 8
  %150 = insertelement <8 x double> poison, double %141, i64 0
  %151 = shufflevector <8 x double> %150, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %151, ptr %149, align 8
  %152 = load ptr, ptr %147, align 8
  %153 = getelementptr inbounds i8, ptr %147, i64 192
  %154 = load ptr, ptr %153, align 8
  %155 = getelementptr inbounds i8, ptr %147, i64 8
  %156 = load i64, ptr %155, align 8
  %157 = load ptr, ptr %1, align 8
  %158 = load ptr, ptr %157, align 8
  %159 = getelementptr inbounds i8, ptr %158, i64 24
  %160 = load i64, ptr %159, align 8
  %161 = load ptr, ptr %148, align 8
  %162 = load ptr, ptr %47, align 8
  %163 = load ptr, ptr %162, align 8
  %164 = getelementptr inbounds i8, ptr %163, i64 16
  %165 = load i64, ptr %164, align 8
  tail call fastcc void @nested(ptr noundef %146, ptr noundef %152, ptr noundef %154, i64 noundef %156, i64 noundef %160, ptr noundef %161, i64 noundef %165) #7
  %166 = fmul double %141, %3
  %167 = fadd double %166, %2
  %168 = load ptr, ptr %54, align 8
  store double %167, ptr %168, align 8
  %169 = load i64, ptr %56, align 8
  %170 = icmp sgt i64 %169, 0
  br i1 %170, label %171, label %172

171:                                              ; preds = %145
  tail call fastcc void @sample(ptr noundef nonnull %28) #7
  br label %172

172:                                              ; preds = %145, %171
  %173 = load ptr, ptr %8, align 8
  %174 = load i64, ptr %173, align 8
  %175 = load ptr, ptr %63, align 8
  %176 = load ptr, ptr %29, align 8
  %177 = load ptr, ptr %66, align 8
  %178 = load ptr, ptr %68, align 8
  %179 = load ptr, ptr %14, align 8
  %180 = getelementptr inbounds i8, ptr %173, i64 8
  %181 = load i64, ptr %180, align 8
  %182 = getelementptr inbounds double, ptr %179, i64 %181
  %183 = inttoptr i64 %174 to ptr
  %184 = tail call i32 %183(ptr noundef %175, ptr noundef %176, ptr noundef %177, ptr noundef %178, ptr noundef %182) #8
  %185 = load double, ptr %20, align 8
  %186 = fmul double %185, %13
  %187 = fcmp ogt double %186, 0.000000e+00
  %188 = select i1 %187, double %135, double %141
  %189 = select i1 %187, double %141, double %136
  br label %190

190:                                              ; preds = %139, %172
  %191 = phi double [ %188, %172 ], [ %135, %139 ]
  %192 = phi double [ %189, %172 ], [ %136, %139 ]
  br i1 %144, label %134, label %193

193:                                              ; preds = %134, %190, %129
  %194 = phi double [ %4, %129 ], [ %191, %190 ], [ %135, %134 ]
  ret double %194
}


define internal fastcc void @nested(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, i64 noundef %3, i64 noundef %4, ptr noundef readonly %5, i64 noundef %6) unnamed_addr #3 {
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
  br i1 %31, label %20, label %19, !llvm.loop !15

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
  br i1 %43, label %32, label %24, !llvm.loop !16
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #4

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #5 {
  %2 = getelementptr inbounds i8, ptr %0, i64 104
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %12

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 96
  %7 = getelementptr inbounds i8, ptr %0, i64 112
  %8 = getelementptr inbounds i8, ptr %0, i64 24
  %9 = getelementptr inbounds i8, ptr %0, i64 120
  %10 = getelementptr inbounds i8, ptr %0, i64 144
  %11 = getelementptr inbounds i8, ptr %0, i64 48
  br label %13

12:                                               ; preds = %56, %1
  ret void

13:                                               ; preds = %5, %56
  %14 = phi i64 [ 0, %5 ], [ %81, %56 ]
  %15 = load ptr, ptr %6, align 8
  %16 = load i64, ptr %7, align 8
  %17 = mul nsw i64 %16, %14
  %18 = getelementptr inbounds i64, ptr %15, i64 %17
  %19 = getelementptr inbounds i8, ptr %18, i64 24
  %20 = load ptr, ptr %8, align 8
  %21 = load double, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %18, i64 8
  %23 = load i64, ptr %22, align 8
  %24 = load ptr, ptr %9, align 8
  %25 = getelementptr inbounds double, ptr %24, i64 %23
  %26 = load double, ptr %25, align 8
  %27 = fcmp ogt double %26, %21
  %28 = select i1 %27, double %26, double %21
  %29 = getelementptr inbounds i8, ptr %18, i64 16
  %30 = load i64, ptr %29, align 8
  %31 = load i64, ptr %19, align 8
  %32 = getelementptr inbounds double, ptr %25, i64 %31
  %33 = load double, ptr %32, align 8
  %34 = fcmp ugt double %33, %28
  br i1 %34, label %42, label %35

35:                                               ; preds = %13
  %36 = add nsw i64 %30, -1
  %37 = icmp eq i64 %36, %31
  br i1 %37, label %56, label %38

38:                                               ; preds = %35
  %39 = getelementptr i8, ptr %32, i64 8
  %40 = load double, ptr %39, align 8
  %41 = fcmp ogt double %40, %28
  br i1 %41, label %56, label %42

42:                                               ; preds = %38, %13
  %43 = icmp sgt i64 %30, 1
  br i1 %43, label %44, label %56

44:                                               ; preds = %42, %44
  %45 = phi i64 [ %53, %44 ], [ %30, %42 ]
  %46 = phi i64 [ %52, %44 ], [ 0, %42 ]
  %47 = add nsw i64 %45, %46
  %48 = sdiv i64 %47, 2
  %49 = getelementptr inbounds double, ptr %25, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = fcmp ugt double %50, %28
  %52 = select i1 %51, i64 %46, i64 %48
  %53 = select i1 %51, i64 %48, i64 %45
  %54 = sub nsw i64 %53, %52
  %55 = icmp sgt i64 %54, 1
  br i1 %55, label %44, label %56, !llvm.loop !17

56:                                               ; preds = %44, %42, %35, %38
  %57 = phi i64 [ %31, %38 ], [ %31, %35 ], [ 0, %42 ], [ %52, %44 ]
  store i64 %57, ptr %19, align 8
  %58 = getelementptr inbounds double, ptr %25, i64 %57
  %59 = load double, ptr %58, align 8
  %60 = fsub double %28, %59
  %61 = load ptr, ptr %10, align 8
  %62 = add nsw i64 %57, %23
  %63 = shl nsw i64 %62, 5
  %64 = getelementptr inbounds i8, ptr %61, i64 %63
  %65 = load double, ptr %64, align 8
  %66 = getelementptr inbounds i8, ptr %64, i64 8
  %67 = load double, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %64, i64 16
  %69 = load double, ptr %68, align 8
  %70 = getelementptr inbounds i8, ptr %64, i64 24
  %71 = load double, ptr %70, align 8
  %72 = fmul double %60, %71
  %73 = fadd double %69, %72
  %74 = fmul double %60, %73
  %75 = fadd double %67, %74
  %76 = fmul double %60, %75
  %77 = fadd double %65, %76
  %78 = load ptr, ptr %11, align 8
  %79 = load i64, ptr %18, align 8
  %80 = getelementptr inbounds double, ptr %78, i64 %79
  store double %77, ptr %80, align 8
  %81 = add nuw nsw i64 %14, 1
  %82 = load i64, ptr %2, align 8
  %83 = icmp slt i64 %81, %82
  br i1 %83, label %13, label %12, !llvm.loop !18
}

declare double @llvm.fabs.f64(double) #4

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind willreturn memory(none) }
attributes #5 = { noinline nounwind }
attributes #6 = { nounwind }
attributes #7 = { nounwind }
attributes #8 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = distinct !{!3, !4, !5}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
!6 = distinct !{!6, !4, !5}
!7 = distinct !{!7, !4, !5}
!8 = distinct !{!8, !4, !5}
!9 = distinct !{!9, !4, !5}
!10 = distinct !{!10, !4, !5}
!11 = distinct !{!11, !4, !5}
!12 = distinct !{!12, !5}
!13 = distinct !{!13, !4, !5}
!14 = distinct !{!14, !5}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5}
!17 = distinct !{!17, !4, !5}
!18 = distinct !{!18, !4, !5}
