; sources ea3bcda5c0dc2a8adadba7c1a99fa32dfaa3ef2512f42b147e4bdf0b39e81f02
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Held = type { ptr, i64, i64, i64, i64, i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

define range(i64 0, 7) i64 @project(ptr noundef readonly %0, double noundef %1, ptr noundef %2, ptr noundef readonly %3) #0 {
  %5 = alloca %struct.Held, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 648
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 88
  %9 = load i64, ptr %8, align 8
  %10 = add nsw i64 %9, 1
  store i64 %10, ptr %8, align 8
  tail call void @llvm.experimental.noalias.scope.decl(metadata !3)
  %11 = getelementptr inbounds i8, ptr %0, i64 696
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %12, i64 64
  %14 = load i64, ptr %13, align 8, !noalias !3
  %15 = inttoptr i64 %14 to ptr
  store ptr %15, ptr %5, align 8, !alias.scope !3
  %16 = getelementptr inbounds i8, ptr %5, i64 8
  %17 = getelementptr inbounds i8, ptr %12, i64 16
  %18 = load i64, ptr %17, align 8, !noalias !3
  store i64 %18, ptr %16, align 8, !alias.scope !3
  %19 = getelementptr inbounds i8, ptr %5, i64 16
  %20 = getelementptr inbounds i8, ptr %12, i64 24
  %21 = load i64, ptr %20, align 8, !noalias !3
  store i64 %21, ptr %19, align 8, !alias.scope !3
  %22 = getelementptr inbounds i8, ptr %5, i64 24
  %23 = getelementptr inbounds i8, ptr %12, i64 32
  %24 = load i64, ptr %23, align 8, !noalias !3
  store i64 %24, ptr %22, align 8, !alias.scope !3
  %25 = getelementptr inbounds i8, ptr %5, i64 32
  %26 = getelementptr inbounds i8, ptr %12, i64 40
  %27 = load i64, ptr %26, align 8, !noalias !3
  store i64 %27, ptr %25, align 8, !alias.scope !3
  %28 = getelementptr inbounds i8, ptr %5, i64 40
  %29 = getelementptr inbounds i8, ptr %12, i64 48
  %30 = load i64, ptr %29, align 8, !noalias !3
  store i64 %30, ptr %28, align 8, !alias.scope !3
  %31 = getelementptr inbounds i8, ptr %5, i64 48
  %32 = getelementptr inbounds i8, ptr %12, i64 80
  %33 = load i64, ptr %32, align 8, !noalias !3
  store i64 %33, ptr %31, align 8, !alias.scope !3
  %34 = getelementptr inbounds i8, ptr %5, i64 56
  %35 = getelementptr inbounds i8, ptr %12, i64 88
  %36 = load i64, ptr %35, align 8, !noalias !3
  store i64 %36, ptr %34, align 8, !alias.scope !3
  %37 = getelementptr inbounds i8, ptr %5, i64 64
  store i64 1, ptr %37, align 8, !alias.scope !3
  %38 = getelementptr inbounds i8, ptr %5, i64 72
  %39 = getelementptr inbounds i8, ptr %0, i64 744
  %40 = load ptr, ptr %39, align 8, !noalias !3
  store ptr %40, ptr %38, align 8, !alias.scope !3
  %41 = getelementptr inbounds i8, ptr %5, i64 80
  store ptr null, ptr %41, align 8, !alias.scope !3
  %42 = getelementptr inbounds i8, ptr %5, i64 88
  store ptr null, ptr %42, align 8, !alias.scope !3
  %43 = getelementptr inbounds i8, ptr %5, i64 96
  store ptr null, ptr %43, align 8, !alias.scope !3
  %44 = getelementptr inbounds i8, ptr %5, i64 104
  store ptr null, ptr %44, align 8, !alias.scope !3
  %45 = getelementptr inbounds i8, ptr %5, i64 112
  store ptr null, ptr %45, align 8, !alias.scope !3
  %46 = getelementptr inbounds i8, ptr %5, i64 120
  store ptr null, ptr %46, align 8, !alias.scope !3
  %47 = getelementptr double, ptr %40, i64 %18
  %48 = getelementptr double, ptr %47, i64 %21
  store ptr %48, ptr %41, align 8, !alias.scope !3
  %49 = mul nsw i64 %24, %18
  %50 = getelementptr inbounds double, ptr %48, i64 %49
  store ptr %50, ptr %42, align 8, !alias.scope !3
  %51 = mul nsw i64 %27, %24
  %52 = getelementptr inbounds double, ptr %50, i64 %51
  store ptr %52, ptr %43, align 8, !alias.scope !3
  %53 = mul nsw i64 %27, %21
  %54 = getelementptr inbounds double, ptr %52, i64 %53
  store ptr %54, ptr %44, align 8, !alias.scope !3
  %55 = mul i64 %27, %27
  %56 = mul i64 %55, %30
  %57 = getelementptr inbounds double, ptr %54, i64 %56
  store ptr %57, ptr %45, align 8, !alias.scope !3
  %58 = getelementptr inbounds double, ptr %57, i64 %18
  store ptr %58, ptr %46, align 8, !alias.scope !3
  %59 = getelementptr inbounds i8, ptr %12, i64 96
  %60 = load i64, ptr %59, align 8
  %61 = icmp eq i64 %60, 0
  %62 = select i1 %61, ptr null, ptr %3
  %63 = getelementptr inbounds i8, ptr %0, i64 144
  %64 = getelementptr inbounds i8, ptr %0, i64 168
  %65 = load ptr, ptr %64, align 8
  store double %1, ptr %65, align 8
  %66 = getelementptr inbounds i8, ptr %0, i64 248
  %67 = load i64, ptr %66, align 8
  %68 = icmp sgt i64 %67, 0
  br i1 %68, label %69, label %70

69:                                               ; preds = %4
  tail call fastcc void @sample(ptr noundef nonnull %63) #7
  br label %70

70:                                               ; preds = %4, %69
  %71 = load ptr, ptr %5, align 8
  %72 = load ptr, ptr %71, align 8
  %73 = load i64, ptr %25, align 8
  %74 = icmp sgt i64 %73, 0
  br i1 %74, label %75, label %89

75:                                               ; preds = %70, %79
  %76 = phi i64 [ %80, %79 ], [ 0, %70 ]
  %77 = mul nuw nsw i64 %76, %73
  %78 = getelementptr double, ptr %72, i64 %77
  br label %82

79:                                               ; preds = %82
  %80 = add nuw nsw i64 %76, 1
  %81 = icmp eq i64 %80, %73
  br i1 %81, label %89, label %75, !llvm.loop !6

82:                                               ; preds = %75, %82
  %83 = phi i64 [ 0, %75 ], [ %87, %82 ]
  %84 = icmp eq i64 %76, %83
  %85 = select i1 %84, double 1.000000e+00, double 0.000000e+00
  %86 = getelementptr double, ptr %78, i64 %83
  store double %85, ptr %86, align 8
  %87 = add nuw nsw i64 %83, 1
  %88 = icmp eq i64 %87, %73
  br i1 %88, label %79, label %82, !llvm.loop !9

89:                                               ; preds = %79, %70
  %90 = load i64, ptr %37, align 8
  %91 = load ptr, ptr %5, align 8
  %92 = getelementptr inbounds i8, ptr %91, i64 240
  %93 = load ptr, ptr %92, align 8
  %94 = load i64, ptr %16, align 8
  %95 = icmp sgt i64 %94, 0
  br i1 %95, label %142, label %96

96:                                               ; preds = %142, %89
  %97 = getelementptr inbounds i8, ptr %0, i64 168
  %98 = getelementptr inbounds i8, ptr %0, i64 192
  %99 = getelementptr inbounds i8, ptr %0, i64 720
  %100 = load ptr, ptr %38, align 8
  %101 = load i64, ptr %37, align 8
  %102 = load ptr, ptr %11, align 8
  %103 = getelementptr inbounds i8, ptr %102, i64 8
  %104 = load i64, ptr %103, align 8
  %105 = load ptr, ptr %97, align 8
  %106 = load ptr, ptr %98, align 8
  %107 = load ptr, ptr %99, align 8
  %108 = inttoptr i64 %104 to ptr
  %109 = load ptr, ptr %108, align 8
  %110 = tail call i32 %109(ptr noundef %105, ptr noundef %2, ptr noundef %106, ptr noundef %107, ptr noundef %100) #8
  %111 = icmp slt i32 %110, 0
  br i1 %111, label %326, label %112

112:                                              ; preds = %96
  %113 = icmp eq i64 %33, %94
  %114 = load i64, ptr %16, align 8
  %115 = icmp sgt i64 %114, 0
  %116 = load ptr, ptr %38, align 8
  %117 = load ptr, ptr %45, align 8
  %118 = load ptr, ptr %5, align 8
  %119 = getelementptr inbounds i8, ptr %118, i64 216
  %120 = icmp ne ptr %62, null
  %121 = load i64, ptr %22, align 8
  %122 = load ptr, ptr %41, align 8
  %123 = load i64, ptr %31, align 8
  %124 = icmp slt i64 %123, %114
  %125 = icmp sgt i64 %114, 0
  %126 = icmp sgt i64 %121, 0
  %127 = getelementptr inbounds i8, ptr %0, i64 600
  %128 = getelementptr inbounds i8, ptr %0, i64 576
  %129 = select i1 %124, double 1.000000e-05, double 0x3CE0000000000000
  %130 = load ptr, ptr %45, align 8
  %131 = load i64, ptr %25, align 8
  %132 = add nsw i64 %131, %121
  %133 = sitofp i64 %132 to double
  %134 = icmp eq i64 %30, 1
  %135 = getelementptr inbounds i8, ptr %91, i64 8
  %136 = getelementptr inbounds i8, ptr %91, i64 16
  %137 = getelementptr inbounds i8, ptr %91, i64 24
  %138 = getelementptr inbounds i8, ptr %91, i64 32
  %139 = getelementptr inbounds i8, ptr %91, i64 40
  %140 = getelementptr inbounds i8, ptr %91, i64 144
  %141 = icmp sgt i64 %114, 0
  br label %159

142:                                              ; preds = %89, %142
  %143 = phi i64 [ %145, %142 ], [ 0, %89 ]
  %144 = getelementptr inbounds double, ptr %93, i64 %143
  store double 0.000000e+00, ptr %144, align 8
  %145 = add nuw nsw i64 %143, 1
  %146 = icmp eq i64 %145, %94
  br i1 %146, label %96, label %142, !llvm.loop !10

147:                                              ; preds = %323
  %148 = add nuw nsw i32 %163, 1
  %149 = load ptr, ptr %11, align 8
  %150 = getelementptr inbounds i8, ptr %149, i64 8
  %151 = load i64, ptr %150, align 8
  %152 = load ptr, ptr %97, align 8
  %153 = load ptr, ptr %98, align 8
  %154 = load ptr, ptr %99, align 8
  %155 = inttoptr i64 %151 to ptr
  %156 = load ptr, ptr %155, align 8
  %157 = tail call i32 %156(ptr noundef %152, ptr noundef %2, ptr noundef %153, ptr noundef %154, ptr noundef %100) #8
  %158 = icmp slt i32 %157, 0
  br i1 %158, label %326, label %159, !llvm.loop !11

159:                                              ; preds = %112, %147
  %160 = phi i64 [ undef, %112 ], [ %325, %147 ]
  %161 = phi i64 [ 0, %112 ], [ %275, %147 ]
  %162 = phi double [ 0x7FF0000000000000, %112 ], [ %324, %147 ]
  %163 = phi i32 [ 0, %112 ], [ %148, %147 ]
  %164 = phi double [ 0.000000e+00, %112 ], [ %261, %147 ]
  %165 = phi i64 [ %101, %112 ], [ %273, %147 ]
  %166 = icmp eq i32 %163, 0
  %167 = select i1 %166, i1 true, i1 %113
  br i1 %115, label %178, label %168

168:                                              ; preds = %199, %159
  %169 = phi double [ 0.000000e+00, %159 ], [ %204, %199 ]
  %170 = phi i32 [ 1, %159 ], [ %206, %199 ]
  %171 = xor i32 %170, -1
  %172 = sext i32 %171 to i64
  %173 = and i64 %165, %172
  %174 = or i64 %173, %161
  %175 = and i1 %120, %166
  %176 = and i1 %125, %175
  %177 = select i1 %175, double 0.000000e+00, double %164
  br i1 %176, label %209, label %260

178:                                              ; preds = %159, %199
  %179 = phi i64 [ %207, %199 ], [ 0, %159 ]
  %180 = phi i32 [ %206, %199 ], [ 1, %159 ]
  %181 = phi double [ %204, %199 ], [ 0.000000e+00, %159 ]
  %182 = getelementptr inbounds double, ptr %116, i64 %179
  %183 = load double, ptr %182, align 8
  %184 = tail call double @llvm.fabs.f64(double %183)
  %185 = getelementptr inbounds double, ptr %117, i64 %179
  %186 = load double, ptr %185, align 8
  %187 = getelementptr inbounds double, ptr %93, i64 %179
  %188 = load double, ptr %187, align 8
  %189 = fcmp ogt double %186, %188
  %190 = select i1 %189, double %186, double %188
  %191 = fmul double %190, 0x3CB0000000000000
  %192 = fcmp une double %183, 0.000000e+00
  br i1 %167, label %199, label %193

193:                                              ; preds = %178
  %194 = load ptr, ptr %119, align 8
  %195 = getelementptr inbounds double, ptr %194, i64 %179
  %196 = load double, ptr %195, align 8
  %197 = fcmp ogt double %196, 0.000000e+00
  %198 = and i1 %192, %197
  br label %199

199:                                              ; preds = %193, %178
  %200 = phi i1 [ %192, %178 ], [ %198, %193 ]
  %201 = fdiv double %184, %191
  %202 = fcmp ogt double %201, %181
  %203 = select i1 %200, i1 %202, i1 false
  %204 = select i1 %203, double %201, double %181
  %205 = fcmp one double %184, 0x7FF0000000000000
  %206 = select i1 %205, i32 %180, i32 0
  %207 = add nuw nsw i64 %179, 1
  %208 = icmp eq i64 %207, %114
  br i1 %208, label %168, label %178, !llvm.loop !12

209:                                              ; preds = %168, %217
  %210 = phi double [ %233, %217 ], [ 0.000000e+00, %168 ]
  %211 = phi i64 [ %234, %217 ], [ 0, %168 ]
  br i1 %126, label %212, label %217

212:                                              ; preds = %209
  %213 = mul nuw nsw i64 %211, %121
  %214 = getelementptr double, ptr %122, i64 %213
  %215 = load ptr, ptr %127, align 8
  %216 = load ptr, ptr %128, align 8
  br label %236

217:                                              ; preds = %236, %209
  %218 = phi double [ 0.000000e+00, %209 ], [ %257, %236 ]
  %219 = getelementptr inbounds double, ptr %130, i64 %211
  %220 = load double, ptr %219, align 8
  %221 = fmul double %129, %220
  %222 = fmul double %218, %133
  %223 = tail call double @llvm.sqrt.f64(double %222)
  %224 = fmul double %223, 3.000000e+00
  %225 = fadd double %221, %224
  %226 = fcmp ule double %218, 0.000000e+00
  %227 = getelementptr inbounds double, ptr %116, i64 %211
  %228 = load double, ptr %227, align 8
  %229 = tail call double @llvm.fabs.f64(double %228)
  %230 = fdiv double %229, %225
  %231 = fcmp ogt double %230, %210
  %232 = select i1 %231, double %230, double %210
  %233 = select i1 %226, double %210, double %232
  %234 = add nuw nsw i64 %211, 1
  %235 = icmp eq i64 %234, %114
  br i1 %235, label %260, label %209, !llvm.loop !13

236:                                              ; preds = %212, %236
  %237 = phi double [ 0.000000e+00, %212 ], [ %257, %236 ]
  %238 = phi i64 [ 0, %212 ], [ %258, %236 ]
  %239 = getelementptr double, ptr %214, i64 %238
  %240 = load double, ptr %239, align 8
  %241 = getelementptr inbounds double, ptr %2, i64 %238
  %242 = load double, ptr %241, align 8
  %243 = getelementptr inbounds double, ptr %62, i64 %238
  %244 = load double, ptr %243, align 8
  %245 = getelementptr inbounds double, ptr %215, i64 %238
  %246 = load double, ptr %245, align 8
  %247 = getelementptr inbounds double, ptr %216, i64 %238
  %248 = load double, ptr %247, align 8
  %249 = tail call double @llvm.fabs.f64(double %244)
  %250 = tail call double @llvm.fabs.f64(double %242)
  %251 = fcmp ogt double %249, %250
  %252 = select i1 %251, double %249, double %250
  %253 = fmul double %252, %248
  %254 = fadd double %246, %253
  %255 = fmul double %240, %254
  %256 = fmul double %255, %255
  %257 = fadd double %237, %256
  %258 = add nuw nsw i64 %238, 1
  %259 = icmp eq i64 %258, %121
  br i1 %259, label %217, label %236, !llvm.loop !14

260:                                              ; preds = %217, %168
  %261 = phi double [ %177, %168 ], [ %233, %217 ]
  %262 = fcmp ole double %169, 1.000000e+00
  %263 = fmul double %162, 5.000000e-01
  %264 = fcmp oge double %169, %263
  %265 = fcmp ole double %169, 8.000000e+00
  %266 = and i1 %264, %265
  %267 = or i1 %262, %266
  %268 = zext i1 %267 to i64
  %269 = or i64 %174, %268
  %270 = xor i64 %269, -1
  %271 = and i64 %165, %270
  %272 = icmp eq i32 %163, 9
  %273 = select i1 %272, i64 0, i64 %271
  %274 = select i1 %272, i64 %271, i64 0
  %275 = or i64 %274, %174
  store i64 %273, ptr %37, align 8
  %276 = icmp eq i64 %273, 0
  br i1 %276, label %323, label %277

277:                                              ; preds = %260
  br i1 %134, label %278, label %296

278:                                              ; preds = %277
  %279 = load i64, ptr %135, align 8
  %280 = load i64, ptr %136, align 8
  %281 = mul nsw i64 %280, %279
  %282 = icmp sgt i64 %281, 0
  br i1 %282, label %283, label %294

283:                                              ; preds = %278, %283
  %284 = phi i64 [ %289, %283 ], [ 0, %278 ]
  %285 = getelementptr inbounds double, ptr %54, i64 %284
  %286 = load double, ptr %285, align 8
  %287 = load ptr, ptr %91, align 8
  %288 = getelementptr inbounds double, ptr %287, i64 %284
  store double %286, ptr %288, align 8
  %289 = add nuw nsw i64 %284, 1
  %290 = load i64, ptr %135, align 8
  %291 = load i64, ptr %136, align 8
  %292 = mul nsw i64 %291, %290
  %293 = icmp slt i64 %289, %292
  br i1 %293, label %283, label %294, !llvm.loop !15

294:                                              ; preds = %283, %278
  %295 = load ptr, ptr %91, align 8
  tail call fastcc void @factorise(ptr noundef %295, i64 noundef %73) #7
  br label %296

296:                                              ; preds = %277, %294
  %297 = load i64, ptr %138, align 8
  %298 = load i64, ptr %139, align 8
  %299 = mul nsw i64 %298, %297
  %300 = icmp sgt i64 %299, 0
  br i1 %300, label %301, label %312

301:                                              ; preds = %296, %301
  %302 = phi i64 [ %307, %301 ], [ 0, %296 ]
  %303 = getelementptr inbounds double, ptr %50, i64 %302
  %304 = load double, ptr %303, align 8
  %305 = load ptr, ptr %137, align 8
  %306 = getelementptr inbounds double, ptr %305, i64 %302
  store double %304, ptr %306, align 8
  %307 = add nuw nsw i64 %302, 1
  %308 = load i64, ptr %138, align 8
  %309 = load i64, ptr %139, align 8
  %310 = mul nsw i64 %309, %308
  %311 = icmp slt i64 %307, %310
  br i1 %311, label %301, label %312, !llvm.loop !15

312:                                              ; preds = %301, %296
  %313 = load ptr, ptr %140, align 8
  br i1 %141, label %314, label %322

314:                                              ; preds = %312, %314
  %315 = phi i64 [ %320, %314 ], [ 0, %312 ]
  %316 = getelementptr inbounds double, ptr %100, i64 %315
  %317 = load double, ptr %316, align 8
  %318 = fneg double %317
  %319 = getelementptr inbounds double, ptr %313, i64 %315
  store double %318, ptr %319, align 8
  %320 = add nuw nsw i64 %315, 1
  %321 = icmp eq i64 %320, %114
  br i1 %321, label %322, label %314, !llvm.loop !16

322:                                              ; preds = %314, %312
  call fastcc void @move_positions(ptr noundef nonnull %5, ptr noundef %2) #7
  br label %323

323:                                              ; preds = %322, %260
  %324 = phi double [ %169, %322 ], [ %162, %260 ]
  %325 = phi i64 [ %160, %322 ], [ %275, %260 ]
  br i1 %276, label %326, label %147

326:                                              ; preds = %323, %147, %96
  %327 = phi double [ 0.000000e+00, %96 ], [ %261, %147 ], [ %261, %323 ]
  %328 = phi i64 [ %90, %96 ], [ %325, %323 ], [ %90, %147 ]
  %329 = load i64, ptr %19, align 8
  %330 = icmp eq i64 %329, 0
  %331 = icmp eq i64 %328, 1
  %332 = select i1 %330, i1 true, i1 %331
  br i1 %332, label %339, label %333

333:                                              ; preds = %326
  %334 = icmp sgt i64 %329, 0
  br i1 %334, label %335, label %343

335:                                              ; preds = %333
  %336 = load ptr, ptr %38, align 8
  %337 = load i64, ptr %16, align 8
  %338 = getelementptr double, ptr %336, i64 %337
  br label %350

339:                                              ; preds = %326
  %340 = fcmp ogt double %327, 1.000000e+00
  %341 = zext i1 %340 to i64
  %342 = or i64 %328, %341
  br label %591

343:                                              ; preds = %350, %333
  %344 = phi double [ 0.000000e+00, %333 ], [ %356, %350 ]
  %345 = load i64, ptr %25, align 8
  %346 = mul nsw i64 %345, %329
  %347 = icmp sgt i64 %346, 0
  br i1 %347, label %348, label %359

348:                                              ; preds = %343
  %349 = load ptr, ptr %43, align 8
  br label %367

350:                                              ; preds = %335, %350
  %351 = phi i64 [ 0, %335 ], [ %357, %350 ]
  %352 = phi double [ 0.000000e+00, %335 ], [ %356, %350 ]
  %353 = getelementptr double, ptr %338, i64 %351
  %354 = load double, ptr %353, align 8
  %355 = fmul double %354, 0.000000e+00
  %356 = fadd double %352, %355
  %357 = add nuw nsw i64 %351, 1
  %358 = icmp eq i64 %357, %329
  br i1 %358, label %343, label %350, !llvm.loop !17

359:                                              ; preds = %367, %343
  %360 = phi double [ %344, %343 ], [ %373, %367 ]
  %361 = fcmp une double %360, 0.000000e+00
  %362 = zext i1 %361 to i64
  %363 = or i64 %328, %362
  %364 = and i64 %363, 1
  %365 = xor i64 %364, 1
  store i64 %365, ptr %37, align 8
  %366 = icmp eq ptr %62, null
  br i1 %366, label %451, label %376

367:                                              ; preds = %348, %367
  %368 = phi i64 [ 0, %348 ], [ %374, %367 ]
  %369 = phi double [ %344, %348 ], [ %373, %367 ]
  %370 = getelementptr inbounds double, ptr %349, i64 %368
  %371 = load double, ptr %370, align 8
  %372 = fmul double %371, 0.000000e+00
  %373 = fadd double %369, %372
  %374 = add nuw nsw i64 %368, 1
  %375 = icmp eq i64 %374, %346
  br i1 %375, label %359, label %367, !llvm.loop !18

376:                                              ; preds = %359
  %377 = load i64, ptr %22, align 8
  %378 = load ptr, ptr %38, align 8
  %379 = load i64, ptr %16, align 8
  %380 = getelementptr inbounds double, ptr %378, i64 %379
  %381 = load ptr, ptr %43, align 8
  %382 = icmp sgt i64 %329, 0
  br i1 %382, label %383, label %447

383:                                              ; preds = %376
  %384 = load i64, ptr %34, align 8
  %385 = icmp slt i64 %384, %329
  %386 = icmp sgt i64 %345, 0
  %387 = getelementptr inbounds i8, ptr %0, i64 600
  %388 = getelementptr inbounds i8, ptr %0, i64 576
  %389 = select i1 %385, double 1.000000e-05, double 0x3CE0000000000000
  %390 = add nsw i64 %377, %345
  %391 = sitofp i64 %390 to double
  br label %392

392:                                              ; preds = %383, %400
  %393 = phi double [ 0.000000e+00, %383 ], [ %415, %400 ]
  %394 = phi i64 [ 0, %383 ], [ %416, %400 ]
  br i1 %386, label %395, label %400

395:                                              ; preds = %392
  %396 = mul nuw nsw i64 %394, %345
  %397 = getelementptr double, ptr %381, i64 %396
  %398 = load ptr, ptr %387, align 8
  %399 = load ptr, ptr %388, align 8
  br label %418

400:                                              ; preds = %418, %392
  %401 = phi double [ 0.000000e+00, %392 ], [ %444, %418 ]
  %402 = phi double [ 0.000000e+00, %392 ], [ %441, %418 ]
  %403 = fmul double %389, %401
  %404 = fmul double %402, %391
  %405 = tail call double @llvm.sqrt.f64(double %404)
  %406 = fmul double %405, 3.000000e+00
  %407 = fadd double %403, %406
  %408 = fcmp ule double %402, 0.000000e+00
  %409 = getelementptr inbounds double, ptr %380, i64 %394
  %410 = load double, ptr %409, align 8
  %411 = tail call double @llvm.fabs.f64(double %410)
  %412 = fdiv double %411, %407
  %413 = fcmp ogt double %412, %393
  %414 = select i1 %413, double %412, double %393
  %415 = select i1 %408, double %393, double %414
  %416 = add nuw nsw i64 %394, 1
  %417 = icmp eq i64 %416, %329
  br i1 %417, label %447, label %392, !llvm.loop !13

418:                                              ; preds = %395, %418
  %419 = phi double [ 0.000000e+00, %395 ], [ %441, %418 ]
  %420 = phi i64 [ 0, %395 ], [ %445, %418 ]
  %421 = phi double [ 0.000000e+00, %395 ], [ %444, %418 ]
  %422 = getelementptr double, ptr %397, i64 %420
  %423 = load double, ptr %422, align 8
  %424 = add nsw i64 %420, %377
  %425 = getelementptr inbounds double, ptr %2, i64 %424
  %426 = load double, ptr %425, align 8
  %427 = getelementptr inbounds double, ptr %62, i64 %424
  %428 = load double, ptr %427, align 8
  %429 = getelementptr inbounds double, ptr %398, i64 %424
  %430 = load double, ptr %429, align 8
  %431 = getelementptr inbounds double, ptr %399, i64 %424
  %432 = load double, ptr %431, align 8
  %433 = tail call double @llvm.fabs.f64(double %428)
  %434 = tail call double @llvm.fabs.f64(double %426)
  %435 = fcmp ogt double %433, %434
  %436 = select i1 %435, double %433, double %434
  %437 = fmul double %436, %432
  %438 = fadd double %430, %437
  %439 = fmul double %423, %438
  %440 = fmul double %439, %439
  %441 = fadd double %419, %440
  %442 = fmul double %423, %426
  %443 = tail call double @llvm.fabs.f64(double %442)
  %444 = fadd double %421, %443
  %445 = add nuw nsw i64 %420, 1
  %446 = icmp eq i64 %445, %345
  br i1 %446, label %400, label %418, !llvm.loop !14

447:                                              ; preds = %400, %376
  %448 = phi double [ 0.000000e+00, %376 ], [ %415, %400 ]
  %449 = fcmp ogt double %448, %327
  %450 = select i1 %449, double %448, double %327
  br label %451

451:                                              ; preds = %447, %359
  %452 = phi double [ %327, %359 ], [ %450, %447 ]
  %453 = load i64, ptr %28, align 8
  %454 = icmp eq i64 %453, 1
  br i1 %454, label %455, label %479

455:                                              ; preds = %451
  %456 = load ptr, ptr %44, align 8
  %457 = load ptr, ptr %5, align 8
  %458 = getelementptr inbounds i8, ptr %457, i64 8
  %459 = getelementptr inbounds i8, ptr %457, i64 16
  %460 = load i64, ptr %458, align 8
  %461 = load i64, ptr %459, align 8
  %462 = mul nsw i64 %461, %460
  %463 = icmp sgt i64 %462, 0
  br i1 %463, label %464, label %475

464:                                              ; preds = %455, %464
  %465 = phi i64 [ %470, %464 ], [ 0, %455 ]
  %466 = getelementptr inbounds double, ptr %456, i64 %465
  %467 = load double, ptr %466, align 8
  %468 = load ptr, ptr %457, align 8
  %469 = getelementptr inbounds double, ptr %468, i64 %465
  store double %467, ptr %469, align 8
  %470 = add nuw nsw i64 %465, 1
  %471 = load i64, ptr %458, align 8
  %472 = load i64, ptr %459, align 8
  %473 = mul nsw i64 %472, %471
  %474 = icmp slt i64 %470, %473
  br i1 %474, label %464, label %475, !llvm.loop !15

475:                                              ; preds = %464, %455
  %476 = load ptr, ptr %5, align 8
  %477 = load ptr, ptr %476, align 8
  %478 = load i64, ptr %25, align 8
  tail call fastcc void @factorise(ptr noundef %477, i64 noundef %478) #7
  br label %479

479:                                              ; preds = %451, %475
  %480 = load ptr, ptr %38, align 8
  %481 = load i64, ptr %16, align 8
  %482 = getelementptr inbounds double, ptr %480, i64 %481
  %483 = load i64, ptr %19, align 8
  %484 = load ptr, ptr %5, align 8
  %485 = getelementptr inbounds i8, ptr %484, i64 144
  %486 = load ptr, ptr %485, align 8
  %487 = icmp sgt i64 %483, 0
  br i1 %487, label %488, label %496

488:                                              ; preds = %479, %488
  %489 = phi i64 [ %494, %488 ], [ 0, %479 ]
  %490 = getelementptr inbounds double, ptr %482, i64 %489
  %491 = load double, ptr %490, align 8
  %492 = fneg double %491
  %493 = getelementptr inbounds double, ptr %486, i64 %489
  store double %492, ptr %493, align 8
  %494 = add nuw nsw i64 %489, 1
  %495 = icmp eq i64 %494, %483
  br i1 %495, label %496, label %488, !llvm.loop !16

496:                                              ; preds = %488, %479
  call fastcc void @move_speeds(ptr noundef nonnull %5, ptr noundef %2) #7
  %497 = load ptr, ptr %63, align 8
  %498 = getelementptr inbounds i8, ptr %497, i64 8
  %499 = load i64, ptr %498, align 8
  %500 = load ptr, ptr %46, align 8
  %501 = load i64, ptr %37, align 8
  %502 = trunc i64 %501 to i32
  %503 = load i64, ptr %19, align 8
  %504 = icmp sgt i64 %503, 0
  br i1 %504, label %505, label %512

505:                                              ; preds = %496
  %506 = load ptr, ptr %5, align 8
  %507 = getelementptr inbounds i8, ptr %506, i64 216
  %508 = getelementptr double, ptr %500, i64 %499
  %509 = getelementptr i8, ptr %508, i64 32
  %510 = getelementptr inbounds i8, ptr %506, i64 192
  %511 = icmp eq i32 %502, 0
  br label %552

512:                                              ; preds = %552, %496
  %513 = phi double [ 0.000000e+00, %496 ], [ %569, %552 ]
  %514 = phi double [ 1.000000e+00, %496 ], [ %573, %552 ]
  %515 = load double, ptr %500, align 8
  %516 = getelementptr inbounds i8, ptr %500, i64 16
  %517 = load double, ptr %516, align 8
  %518 = fcmp ule double %513, %515
  %519 = and i32 %502, 1
  %520 = icmp eq i32 %519, 0
  %521 = select i1 %518, i1 true, i1 %520
  %522 = select i1 %521, double %515, double %513
  store double %522, ptr %500, align 8
  %523 = getelementptr inbounds i8, ptr %500, i64 8
  %524 = load double, ptr %523, align 8
  %525 = select i1 %521, double %524, double 1.000000e+00
  %526 = fcmp uge double %513, %515
  %527 = select i1 %526, double %514, double 0.000000e+00
  %528 = fcmp olt double %527, %517
  %529 = select i1 %528, double %527, double %517
  %530 = icmp eq i32 %502, 0
  %531 = select i1 %530, double %517, double %527
  store double %531, ptr %516, align 8
  %532 = fcmp oge double %529, 5.000000e-02
  %533 = fmul double %452, %529
  %534 = fmul double %533, 5.000000e-02
  %535 = fcmp ogt double %534, 1.000000e+00
  %536 = or i1 %532, %535
  %537 = load i64, ptr %37, align 8
  %538 = fcmp ogt double %452, 1.000000e+00
  %539 = and i1 %538, %536
  %540 = and i64 %537, 1
  %541 = select i1 %539, i64 %540, i64 0
  %542 = xor i64 %541, %537
  %543 = trunc i64 %542 to i32
  %544 = fcmp olt double %527, %525
  %545 = and i32 %543, 1
  %546 = fcmp ogt double %525, 1.000000e-05
  %547 = and i1 %546, %544
  %548 = select i1 %547, i32 %545, i32 0
  %549 = icmp eq i32 %548, 0
  %550 = select i1 %549, double %525, double %527
  store double %550, ptr %523, align 8
  %551 = icmp eq i32 %548, 0
  br i1 %551, label %589, label %576

552:                                              ; preds = %505, %552
  %553 = phi double [ 1.000000e+00, %505 ], [ %573, %552 ]
  %554 = phi double [ 0.000000e+00, %505 ], [ %569, %552 ]
  %555 = phi i64 [ 0, %505 ], [ %574, %552 ]
  %556 = load ptr, ptr %507, align 8
  %557 = getelementptr inbounds double, ptr %556, i64 %555
  %558 = load double, ptr %557, align 8
  %559 = getelementptr double, ptr %509, i64 %555
  %560 = load double, ptr %559, align 8
  %561 = load ptr, ptr %510, align 8
  %562 = getelementptr inbounds double, ptr %561, i64 %555
  %563 = load double, ptr %562, align 8
  %564 = fcmp ogt double %563, %560
  %565 = select i1 %564, double %563, double %560
  %566 = select i1 %511, double %560, double %565
  store double %566, ptr %559, align 8
  %567 = fcmp ule double %558, 0.000000e+00
  %568 = fadd double %554, 1.000000e+00
  %569 = select i1 %567, double %554, double %568
  %570 = fdiv double %558, %565
  %571 = fcmp olt double %570, %553
  %572 = select i1 %571, double %570, double %553
  %573 = select i1 %567, double %553, double %572
  %574 = add nuw nsw i64 %555, 1
  %575 = icmp eq i64 %574, %503
  br i1 %575, label %512, label %552, !llvm.loop !19

576:                                              ; preds = %512
  %577 = getelementptr inbounds i8, ptr %500, i64 24
  store double %1, ptr %577, align 8
  %578 = getelementptr inbounds i8, ptr %500, i64 32
  %579 = icmp sgt i64 %499, 0
  br i1 %579, label %580, label %589

580:                                              ; preds = %576, %580
  %581 = phi i64 [ %587, %580 ], [ 0, %576 ]
  %582 = getelementptr inbounds double, ptr %2, i64 %581
  %583 = load double, ptr %582, align 8
  %584 = getelementptr inbounds double, ptr %578, i64 %581
  %585 = load double, ptr %584, align 8
  %586 = select i1 %549, double %585, double %583
  store double %586, ptr %584, align 8
  %587 = add nuw nsw i64 %581, 1
  %588 = icmp eq i64 %587, %499
  br i1 %588, label %589, label %580, !llvm.loop !20

589:                                              ; preds = %580, %576, %512
  %590 = or i64 %541, %363
  br label %591

591:                                              ; preds = %339, %589
  %592 = phi i64 [ %342, %339 ], [ %590, %589 ]
  %593 = icmp eq i64 %592, 0
  %594 = select i1 %593, i64 0, i64 6
  ret i64 %594
}



define internal fastcc void @move_speeds(ptr noundef readonly %0, ptr noundef %1) unnamed_addr #2 {
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %0, i64 96
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %3, i64 96
  %7 = getelementptr inbounds i8, ptr %3, i64 104
  %8 = getelementptr inbounds i8, ptr %3, i64 112
  %9 = load i64, ptr %7, align 8
  %10 = load i64, ptr %8, align 8
  %11 = mul nsw i64 %10, %9
  %12 = icmp sgt i64 %11, 0
  br i1 %12, label %13, label %24

13:                                               ; preds = %2, %13
  %14 = phi i64 [ %19, %13 ], [ 0, %2 ]
  %15 = getelementptr inbounds double, ptr %5, i64 %14
  %16 = load double, ptr %15, align 8
  %17 = load ptr, ptr %6, align 8
  %18 = getelementptr inbounds double, ptr %17, i64 %14
  store double %16, ptr %18, align 8
  %19 = add nuw nsw i64 %14, 1
  %20 = load i64, ptr %7, align 8
  %21 = load i64, ptr %8, align 8
  %22 = mul nsw i64 %21, %20
  %23 = icmp slt i64 %19, %22
  br i1 %23, label %13, label %24, !llvm.loop !15

24:                                               ; preds = %13, %2
  %25 = load ptr, ptr %6, align 8
  %26 = getelementptr inbounds i8, ptr %0, i64 16
  %27 = load i64, ptr %26, align 8
  %28 = load ptr, ptr %3, align 8
  %29 = getelementptr inbounds i8, ptr %0, i64 32
  %30 = load i64, ptr %29, align 8
  tail call fastcc void @divide_rows(ptr noundef %25, i64 noundef %27, ptr noundef %28, i64 noundef %30) #7
  %31 = getelementptr inbounds i8, ptr %0, i64 56
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %0, i64 64
  %34 = load i64, ptr %33, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %6, ptr noundef nonnull %3, i64 noundef %32, i64 noundef %34) #7
  %35 = load ptr, ptr %3, align 8
  %36 = load i64, ptr %29, align 8
  %37 = getelementptr inbounds i8, ptr %3, i64 120
  %38 = load ptr, ptr %37, align 8
  tail call fastcc void @divide_transposed(ptr noundef %35, i64 noundef %36, ptr noundef %38) #7
  %39 = load i64, ptr %29, align 8
  %40 = icmp sgt i64 %39, 0
  br i1 %40, label %41, label %43

41:                                               ; preds = %24
  %42 = getelementptr inbounds i8, ptr %0, i64 24
  br label %44

43:                                               ; preds = %44, %24
  ret void

44:                                               ; preds = %41, %44
  %45 = phi i64 [ 0, %41 ], [ %58, %44 ]
  %46 = load i64, ptr %42, align 8
  %47 = getelementptr double, ptr %1, i64 %46
  %48 = getelementptr double, ptr %47, i64 %45
  %49 = load double, ptr %48, align 8
  %50 = load i64, ptr %33, align 8
  %51 = load ptr, ptr %37, align 8
  %52 = getelementptr inbounds double, ptr %51, i64 %45
  %53 = load double, ptr %52, align 8
  %54 = fadd double %49, %53
  %55 = and i64 %50, 4294967295
  %56 = icmp eq i64 %55, 0
  %57 = select i1 %56, double %49, double %54
  store double %57, ptr %48, align 8
  %58 = add nuw nsw i64 %45, 1
  %59 = load i64, ptr %29, align 8
  %60 = icmp slt i64 %58, %59
  br i1 %60, label %44, label %43, !llvm.loop !21
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #2 {
  %2 = getelementptr inbounds i8, ptr %0, i64 104
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %13

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 96
  %7 = getelementptr inbounds i8, ptr %0, i64 112
  %8 = getelementptr inbounds i8, ptr %0, i64 24
  %9 = getelementptr inbounds i8, ptr %0, i64 192
  %10 = getelementptr inbounds i8, ptr %0, i64 120
  %11 = getelementptr inbounds i8, ptr %0, i64 144
  %12 = getelementptr inbounds i8, ptr %0, i64 48
  br label %14

13:                                               ; preds = %61, %1
  ret void

14:                                               ; preds = %5, %61
  %15 = phi i64 [ 0, %5 ], [ %86, %61 ]
  %16 = load ptr, ptr %6, align 8
  %17 = load i64, ptr %7, align 8
  %18 = mul nsw i64 %17, %15
  %19 = getelementptr inbounds i64, ptr %16, i64 %18
  %20 = getelementptr inbounds i8, ptr %19, i64 24
  %21 = load ptr, ptr %8, align 8
  %22 = load double, ptr %21, align 8
  %23 = load ptr, ptr %9, align 8
  %24 = load double, ptr %23, align 8
  %25 = fcmp olt double %22, %24
  %26 = select i1 %25, double %22, double %24
  %27 = getelementptr inbounds i8, ptr %19, i64 8
  %28 = load i64, ptr %27, align 8
  %29 = load ptr, ptr %10, align 8
  %30 = getelementptr inbounds double, ptr %29, i64 %28
  %31 = load double, ptr %30, align 8
  %32 = fcmp ogt double %31, %26
  %33 = select i1 %32, double %31, double %26
  %34 = getelementptr inbounds i8, ptr %19, i64 16
  %35 = load i64, ptr %34, align 8
  %36 = load i64, ptr %20, align 8
  %37 = getelementptr inbounds double, ptr %30, i64 %36
  %38 = load double, ptr %37, align 8
  %39 = fcmp ugt double %38, %33
  br i1 %39, label %47, label %40

40:                                               ; preds = %14
  %41 = add nsw i64 %35, -1
  %42 = icmp eq i64 %41, %36
  br i1 %42, label %61, label %43

43:                                               ; preds = %40
  %44 = getelementptr i8, ptr %37, i64 8
  %45 = load double, ptr %44, align 8
  %46 = fcmp ogt double %45, %33
  br i1 %46, label %61, label %47

47:                                               ; preds = %43, %14
  %48 = icmp sgt i64 %35, 1
  br i1 %48, label %49, label %61

49:                                               ; preds = %47, %49
  %50 = phi i64 [ %58, %49 ], [ %35, %47 ]
  %51 = phi i64 [ %57, %49 ], [ 0, %47 ]
  %52 = add nsw i64 %50, %51
  %53 = sdiv i64 %52, 2
  %54 = getelementptr inbounds double, ptr %30, i64 %53
  %55 = load double, ptr %54, align 8
  %56 = fcmp ugt double %55, %33
  %57 = select i1 %56, i64 %51, i64 %53
  %58 = select i1 %56, i64 %53, i64 %50
  %59 = sub nsw i64 %58, %57
  %60 = icmp sgt i64 %59, 1
  br i1 %60, label %49, label %61, !llvm.loop !22

61:                                               ; preds = %49, %47, %40, %43
  %62 = phi i64 [ %36, %43 ], [ %36, %40 ], [ 0, %47 ], [ %57, %49 ]
  store i64 %62, ptr %20, align 8
  %63 = getelementptr inbounds double, ptr %30, i64 %62
  %64 = load double, ptr %63, align 8
  %65 = fsub double %33, %64
  %66 = load ptr, ptr %11, align 8
  %67 = add nsw i64 %62, %28
  %68 = shl nsw i64 %67, 5
  %69 = getelementptr inbounds i8, ptr %66, i64 %68
  %70 = load double, ptr %69, align 8
  %71 = getelementptr inbounds i8, ptr %69, i64 8
  %72 = load double, ptr %71, align 8
  %73 = getelementptr inbounds i8, ptr %69, i64 16
  %74 = load double, ptr %73, align 8
  %75 = getelementptr inbounds i8, ptr %69, i64 24
  %76 = load double, ptr %75, align 8
  %77 = fmul double %65, %76
  %78 = fadd double %74, %77
  %79 = fmul double %65, %78
  %80 = fadd double %72, %79
  %81 = fmul double %65, %80
  %82 = fadd double %70, %81
  %83 = load ptr, ptr %12, align 8
  %84 = load i64, ptr %19, align 8
  %85 = getelementptr inbounds double, ptr %83, i64 %84
  store double %82, ptr %85, align 8
  %86 = add nuw nsw i64 %15, 1
  %87 = load i64, ptr %2, align 8
  %88 = icmp slt i64 %86, %87
  br i1 %88, label %14, label %13, !llvm.loop !23
}

declare double @llvm.fabs.f64(double) #3

define internal fastcc void @move_positions(ptr noundef readonly %0, ptr noundef %1) unnamed_addr #2 {
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %3, i64 120
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 80
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %3, i64 48
  %9 = getelementptr inbounds i8, ptr %3, i64 56
  %10 = getelementptr inbounds i8, ptr %3, i64 64
  %11 = load i64, ptr %9, align 8
  %12 = load i64, ptr %10, align 8
  %13 = mul nsw i64 %12, %11
  %14 = icmp sgt i64 %13, 0
  br i1 %14, label %15, label %26

15:                                               ; preds = %2, %15
  %16 = phi i64 [ %21, %15 ], [ 0, %2 ]
  %17 = getelementptr inbounds double, ptr %7, i64 %16
  %18 = load double, ptr %17, align 8
  %19 = load ptr, ptr %8, align 8
  %20 = getelementptr inbounds double, ptr %19, i64 %16
  store double %18, ptr %20, align 8
  %21 = add nuw nsw i64 %16, 1
  %22 = load i64, ptr %9, align 8
  %23 = load i64, ptr %10, align 8
  %24 = mul nsw i64 %23, %22
  %25 = icmp slt i64 %21, %24
  br i1 %25, label %15, label %26, !llvm.loop !15

26:                                               ; preds = %15, %2
  tail call fastcc void @set_rows(ptr noundef nonnull %0) #7
  %27 = getelementptr inbounds i8, ptr %3, i64 72
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr inbounds i8, ptr %0, i64 8
  %30 = load i64, ptr %29, align 8
  %31 = load ptr, ptr %3, align 8
  %32 = getelementptr inbounds i8, ptr %0, i64 32
  %33 = load i64, ptr %32, align 8
  tail call fastcc void @divide_rows(ptr noundef %28, i64 noundef %30, ptr noundef %31, i64 noundef %33) #7
  %34 = getelementptr inbounds i8, ptr %0, i64 48
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds i8, ptr %0, i64 64
  %37 = load i64, ptr %36, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %27, ptr noundef nonnull %3, i64 noundef %35, i64 noundef %37) #7
  %38 = load i64, ptr %32, align 8
  %39 = icmp sgt i64 %38, 0
  br i1 %39, label %40, label %49

40:                                               ; preds = %26, %40
  %41 = phi i64 [ %47, %40 ], [ 0, %26 ]
  %42 = phi double [ %46, %40 ], [ 0.000000e+00, %26 ]
  %43 = getelementptr inbounds double, ptr %5, i64 %41
  %44 = load double, ptr %43, align 8
  %45 = fmul double %44, %44
  %46 = fadd double %42, %45
  %47 = add nuw nsw i64 %41, 1
  %48 = icmp eq i64 %47, %38
  br i1 %48, label %49, label %40, !llvm.loop !24

49:                                               ; preds = %40, %26
  %50 = phi double [ 0.000000e+00, %26 ], [ %46, %40 ]
  %51 = tail call double @llvm.sqrt.f64(double %50)
  %52 = load i64, ptr %29, align 8
  %53 = icmp sgt i64 %52, 0
  br i1 %53, label %54, label %57

54:                                               ; preds = %49
  %55 = getelementptr inbounds i8, ptr %3, i64 240
  %56 = getelementptr inbounds i8, ptr %3, i64 192
  br label %66

57:                                               ; preds = %66, %49
  %58 = load ptr, ptr %3, align 8
  %59 = load i64, ptr %32, align 8
  %60 = load ptr, ptr %4, align 8
  tail call fastcc void @divide_transposed(ptr noundef %58, i64 noundef %59, ptr noundef %60) #7
  %61 = getelementptr inbounds i8, ptr %0, i64 24
  %62 = load i64, ptr %61, align 8
  %63 = icmp sgt i64 %62, 0
  br i1 %63, label %64, label %80

64:                                               ; preds = %57
  %65 = getelementptr inbounds i8, ptr %3, i64 24
  br label %87

66:                                               ; preds = %54, %66
  %67 = phi i64 [ 0, %54 ], [ %77, %66 ]
  %68 = load ptr, ptr %55, align 8
  %69 = getelementptr inbounds double, ptr %68, i64 %67
  %70 = load double, ptr %69, align 8
  %71 = fcmp une double %70, 0.000000e+00
  %72 = load ptr, ptr %56, align 8
  %73 = getelementptr inbounds double, ptr %72, i64 %67
  %74 = load double, ptr %73, align 8
  %75 = fmul double %51, %74
  %76 = select i1 %71, double %70, double %75
  store double %76, ptr %69, align 8
  %77 = add nuw nsw i64 %67, 1
  %78 = load i64, ptr %29, align 8
  %79 = icmp slt i64 %77, %78
  br i1 %79, label %66, label %57, !llvm.loop !25

80:                                               ; preds = %97, %57
  %81 = getelementptr inbounds i8, ptr %0, i64 24
  %82 = load i64, ptr %29, align 8
  %83 = icmp sgt i64 %82, 0
  br i1 %83, label %84, label %119

84:                                               ; preds = %80
  %85 = getelementptr inbounds i8, ptr %3, i64 144
  %86 = load ptr, ptr %85, align 8
  br label %125

87:                                               ; preds = %64, %97
  %88 = phi i64 [ 0, %64 ], [ %103, %97 ]
  %89 = getelementptr inbounds double, ptr %1, i64 %88
  %90 = load double, ptr %89, align 8
  %91 = load i64, ptr %32, align 8
  %92 = icmp sgt i64 %91, 0
  br i1 %92, label %93, label %97

93:                                               ; preds = %87
  %94 = load ptr, ptr %65, align 8
  %95 = mul nuw nsw i64 %91, %88
  %96 = getelementptr double, ptr %94, i64 %95
  br label %106

97:                                               ; preds = %106, %87
  %98 = phi double [ %90, %87 ], [ %114, %106 ]
  %99 = load i64, ptr %36, align 8
  %100 = and i64 %99, 4294967295
  %101 = icmp eq i64 %100, 0
  %102 = select i1 %101, double %90, double %98
  store double %102, ptr %89, align 8
  %103 = add nuw nsw i64 %88, 1
  %104 = load i64, ptr %61, align 8
  %105 = icmp slt i64 %103, %104
  br i1 %105, label %87, label %80, !llvm.loop !26

106:                                              ; preds = %93, %106
  %107 = phi i64 [ 0, %93 ], [ %115, %106 ]
  %108 = phi double [ %90, %93 ], [ %114, %106 ]
  %109 = getelementptr double, ptr %96, i64 %107
  %110 = load double, ptr %109, align 8
  %111 = getelementptr inbounds double, ptr %5, i64 %107
  %112 = load double, ptr %111, align 8
  %113 = fmul double %110, %112
  %114 = fadd double %108, %113
  %115 = add nuw nsw i64 %107, 1
  %116 = icmp eq i64 %115, %91
  br i1 %116, label %97, label %106, !llvm.loop !27

117:                                              ; preds = %125
  %118 = fcmp ule double %132, 0.000000e+00
  br label %119

119:                                              ; preds = %117, %80
  %120 = phi i1 [ true, %80 ], [ %118, %117 ]
  %121 = load i64, ptr %36, align 8
  %122 = and i64 %121, 1
  %123 = icmp eq i64 %122, 0
  %124 = select i1 %120, i1 true, i1 %123
  br i1 %124, label %149, label %135

125:                                              ; preds = %84, %125
  %126 = phi i64 [ 0, %84 ], [ %133, %125 ]
  %127 = phi double [ 0.000000e+00, %84 ], [ %132, %125 ]
  %128 = getelementptr inbounds double, ptr %86, i64 %126
  %129 = load double, ptr %128, align 8
  %130 = tail call double @llvm.fabs.f64(double %129)
  %131 = fcmp ogt double %130, %127
  %132 = select i1 %131, double %130, double %127
  %133 = add nuw nsw i64 %126, 1
  %134 = icmp eq i64 %133, %82
  br i1 %134, label %117, label %125, !llvm.loop !28

135:                                              ; preds = %119
  %136 = load i64, ptr %34, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %8, ptr noundef nonnull %3, i64 noundef %136, i64 noundef %122) #7
  %137 = load i64, ptr %81, align 8
  %138 = icmp sgt i64 %137, 0
  br i1 %138, label %139, label %149

139:                                              ; preds = %135, %139
  %140 = phi i64 [ %146, %139 ], [ 0, %135 ]
  %141 = getelementptr inbounds double, ptr %1, i64 %140
  %142 = load double, ptr %141, align 8
  %143 = getelementptr inbounds double, ptr %5, i64 %140
  %144 = load double, ptr %143, align 8
  %145 = fadd double %142, %144
  store double %145, ptr %141, align 8
  %146 = add nuw nsw i64 %140, 1
  %147 = load i64, ptr %81, align 8
  %148 = icmp slt i64 %146, %147
  br i1 %148, label %139, label %149, !llvm.loop !29

149:                                              ; preds = %139, %135, %119
  ret void
}

define internal fastcc void @set_rows(ptr noundef readonly %0) unnamed_addr #2 {
  %2 = getelementptr inbounds i8, ptr %0, i64 8
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %16

5:                                                ; preds = %1
  %6 = load ptr, ptr %0, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 32
  %8 = getelementptr inbounds i8, ptr %0, i64 24
  %9 = getelementptr inbounds i8, ptr %6, i64 48
  %10 = getelementptr inbounds i8, ptr %6, i64 24
  %11 = getelementptr inbounds i8, ptr %6, i64 72
  br label %12

12:                                               ; preds = %5, %28
  %13 = phi i64 [ 0, %5 ], [ %29, %28 ]
  %14 = load i64, ptr %7, align 8
  %15 = icmp sgt i64 %14, 0
  br i1 %15, label %17, label %28

16:                                               ; preds = %28, %1
  ret void

17:                                               ; preds = %12, %32
  %18 = phi i64 [ %47, %32 ], [ %14, %12 ]
  %19 = phi i64 [ %46, %32 ], [ 0, %12 ]
  %20 = load i64, ptr %8, align 8
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %22, label %32

22:                                               ; preds = %17
  %23 = load ptr, ptr %9, align 8
  %24 = mul nuw nsw i64 %20, %13
  %25 = getelementptr double, ptr %23, i64 %24
  %26 = load ptr, ptr %10, align 8
  %27 = getelementptr double, ptr %26, i64 %19
  br label %49

28:                                               ; preds = %32, %12
  %29 = add nuw nsw i64 %13, 1
  %30 = load i64, ptr %2, align 8
  %31 = icmp slt i64 %29, %30
  br i1 %31, label %12, label %16, !llvm.loop !30

32:                                               ; preds = %49, %17
  %33 = phi double [ 0.000000e+00, %17 ], [ %59, %49 ]
  %34 = phi double [ 0.000000e+00, %17 ], [ %61, %49 ]
  %35 = tail call double @llvm.fabs.f64(double %33)
  %36 = sitofp i64 %20 to double
  %37 = fmul double %36, 4.000000e+00
  %38 = fmul double %37, 0x3CB0000000000000
  %39 = fmul double %34, %38
  %40 = fcmp ugt double %35, %39
  %41 = load ptr, ptr %11, align 8
  %42 = mul nsw i64 %18, %13
  %43 = select i1 %40, double %33, double 0.000000e+00
  %44 = getelementptr double, ptr %41, i64 %42
  %45 = getelementptr double, ptr %44, i64 %19
  store double %43, ptr %45, align 8
  %46 = add nuw nsw i64 %19, 1
  %47 = load i64, ptr %7, align 8
  %48 = icmp slt i64 %46, %47
  br i1 %48, label %17, label %28, !llvm.loop !31

49:                                               ; preds = %22, %49
  %50 = phi i64 [ 0, %22 ], [ %62, %49 ]
  %51 = phi double [ 0.000000e+00, %22 ], [ %61, %49 ]
  %52 = phi double [ 0.000000e+00, %22 ], [ %59, %49 ]
  %53 = getelementptr double, ptr %25, i64 %50
  %54 = load double, ptr %53, align 8
  %55 = mul nsw i64 %50, %18
  %56 = getelementptr double, ptr %27, i64 %55
  %57 = load double, ptr %56, align 8
  %58 = fmul double %54, %57
  %59 = fadd double %52, %58
  %60 = tail call double @llvm.fabs.f64(double %58)
  %61 = fadd double %51, %60
  %62 = add nuw nsw i64 %50, 1
  %63 = icmp eq i64 %62, %20
  br i1 %63, label %32, label %49, !llvm.loop !32
}

define internal fastcc void @divide_rows(ptr noundef %0, i64 noundef %1, ptr noundef readonly %2, i64 noundef %3) unnamed_addr #4 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %6, label %15

6:                                                ; preds = %4
  %7 = icmp sgt i64 %3, 0
  %8 = add i64 %3, 1
  br label %9

9:                                                ; preds = %6, %16
  %10 = phi i64 [ 0, %6 ], [ %17, %16 ]
  br i1 %7, label %11, label %16

11:                                               ; preds = %9
  %12 = mul nuw nsw i64 %10, %3
  %13 = getelementptr double, ptr %0, i64 %12
  %14 = getelementptr double, ptr %0, i64 %12
  br label %19

15:                                               ; preds = %16, %4
  ret void

16:                                               ; preds = %27, %9
  %17 = add nuw nsw i64 %10, 1
  %18 = icmp eq i64 %17, %1
  br i1 %18, label %15, label %9, !llvm.loop !33

19:                                               ; preds = %11, %27
  %20 = phi i64 [ 0, %11 ], [ %33, %27 ]
  %21 = getelementptr double, ptr %13, i64 %20
  %22 = load double, ptr %21, align 8
  %23 = icmp eq i64 %20, 0
  br i1 %23, label %27, label %24

24:                                               ; preds = %19
  %25 = mul nuw nsw i64 %20, %3
  %26 = getelementptr double, ptr %2, i64 %25
  br label %35

27:                                               ; preds = %35, %19
  %28 = phi double [ %22, %19 ], [ %43, %35 ]
  %29 = mul i64 %20, %8
  %30 = getelementptr inbounds double, ptr %2, i64 %29
  %31 = load double, ptr %30, align 8
  %32 = fdiv double %28, %31
  store double %32, ptr %21, align 8
  %33 = add nuw nsw i64 %20, 1
  %34 = icmp eq i64 %33, %3
  br i1 %34, label %16, label %19, !llvm.loop !34

35:                                               ; preds = %24, %35
  %36 = phi i64 [ 0, %24 ], [ %44, %35 ]
  %37 = phi double [ %22, %24 ], [ %43, %35 ]
  %38 = getelementptr double, ptr %26, i64 %36
  %39 = load double, ptr %38, align 8
  %40 = getelementptr double, ptr %14, i64 %36
  %41 = load double, ptr %40, align 8
  %42 = fmul double %39, %41
  %43 = fsub double %37, %42
  %44 = add nuw nsw i64 %36, 1
  %45 = icmp eq i64 %44, %20
  br i1 %45, label %27, label %35, !llvm.loop !35
}

define internal fastcc void @minimum_norm(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, i64 noundef %3) unnamed_addr #2 {
  %5 = getelementptr inbounds i8, ptr %0, i64 8
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 16
  %8 = load i64, ptr %7, align 8
  %9 = load ptr, ptr %0, align 8
  %10 = getelementptr inbounds i8, ptr %1, i64 120
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %1, i64 144
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %1, i64 168
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %1, i64 192
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %1, i64 216
  %19 = load ptr, ptr %18, align 8
  %20 = getelementptr inbounds i8, ptr %1, i64 264
  %21 = load ptr, ptr %20, align 8
  %22 = trunc i64 %3 to i32
  %23 = icmp sgt i64 %8, 0
  br i1 %23, label %30, label %24

24:                                               ; preds = %30, %4
  %25 = icmp sgt i64 %6, 0
  br i1 %25, label %26, label %35

26:                                               ; preds = %24
  %27 = icmp sgt i64 %8, 0
  %28 = icmp eq i32 %22, 0
  %29 = icmp sgt i64 %8, 0
  br label %46

30:                                               ; preds = %4, %30
  %31 = phi i64 [ %33, %30 ], [ 0, %4 ]
  %32 = getelementptr inbounds double, ptr %11, i64 %31
  store double 0.000000e+00, ptr %32, align 8
  %33 = add nuw nsw i64 %31, 1
  %34 = icmp eq i64 %33, %8
  br i1 %34, label %24, label %30, !llvm.loop !36

35:                                               ; preds = %74, %24
  %36 = icmp sgt i64 %2, 0
  br i1 %36, label %37, label %220

37:                                               ; preds = %35
  %38 = icmp sgt i64 %6, 0
  %39 = icmp sgt i64 %8, 0
  %40 = icmp sgt i64 %6, 0
  %41 = icmp sgt i64 %8, 0
  %42 = icmp sgt i64 %8, 0
  %43 = icmp sgt i64 %6, 0
  %44 = icmp sgt i64 %8, 0
  %45 = icmp sgt i64 %8, 0
  br label %84

46:                                               ; preds = %26, %74
  %47 = phi i64 [ 0, %26 ], [ %75, %74 ]
  %48 = mul nsw i64 %47, %8
  %49 = getelementptr inbounds double, ptr %9, i64 %48
  br i1 %27, label %50, label %59

50:                                               ; preds = %46, %50
  %51 = phi i64 [ %57, %50 ], [ 0, %46 ]
  %52 = phi double [ %56, %50 ], [ 0.000000e+00, %46 ]
  %53 = getelementptr inbounds double, ptr %49, i64 %51
  %54 = load double, ptr %53, align 8
  %55 = fmul double %54, %54
  %56 = fadd double %52, %55
  %57 = add nuw nsw i64 %51, 1
  %58 = icmp eq i64 %57, %8
  br i1 %58, label %59, label %50, !llvm.loop !24

59:                                               ; preds = %50, %46
  %60 = phi double [ 0.000000e+00, %46 ], [ %56, %50 ]
  %61 = tail call double @llvm.sqrt.f64(double %60)
  %62 = fcmp ule double %60, 0.000000e+00
  %63 = fdiv double 1.000000e+00, %61
  %64 = select i1 %62, double 1.000000e+00, double %63
  %65 = select i1 %62, double 0.000000e+00, double %61
  %66 = getelementptr inbounds double, ptr %17, i64 %47
  store double %65, ptr %66, align 8
  %67 = getelementptr inbounds double, ptr %19, i64 %47
  %68 = load double, ptr %67, align 8
  %69 = select i1 %28, double %68, double 0.000000e+00
  store double %69, ptr %67, align 8
  %70 = getelementptr inbounds double, ptr %15, i64 %47
  store double %64, ptr %70, align 8
  %71 = getelementptr inbounds double, ptr %13, i64 %47
  %72 = load double, ptr %71, align 8
  %73 = fmul double %64, %72
  store double %73, ptr %71, align 8
  br i1 %29, label %77, label %74

74:                                               ; preds = %77, %59
  %75 = add nuw nsw i64 %47, 1
  %76 = icmp eq i64 %75, %6
  br i1 %76, label %35, label %46, !llvm.loop !37

77:                                               ; preds = %59, %77
  %78 = phi i64 [ %82, %77 ], [ 0, %59 ]
  %79 = getelementptr inbounds double, ptr %49, i64 %78
  %80 = load double, ptr %79, align 8
  %81 = fmul double %64, %80
  store double %81, ptr %79, align 8
  %82 = add nuw nsw i64 %78, 1
  %83 = icmp eq i64 %82, %8
  br i1 %83, label %74, label %77, !llvm.loop !38

84:                                               ; preds = %215, %37
  %85 = phi i32 [ %22, %37 ], [ %93, %215 ]
  %86 = phi double [ 0.000000e+00, %37 ], [ %216, %215 ]
  %87 = phi i64 [ 0, %37 ], [ %217, %215 ]
  br i1 %38, label %95, label %88

88:                                               ; preds = %128, %84
  %89 = phi double [ 0x3BC79CA10C924224, %84 ], [ %129, %128 ]
  %90 = phi double [ -1.000000e+00, %84 ], [ %130, %128 ]
  %91 = fcmp oge double %90, 0.000000e+00
  %92 = and i32 %85, 1
  %93 = select i1 %91, i32 %92, i32 0
  %94 = icmp eq i32 %93, 0
  br i1 %94, label %215, label %133

95:                                               ; preds = %84, %128
  %96 = phi double [ %130, %128 ], [ -1.000000e+00, %84 ]
  %97 = phi double [ %129, %128 ], [ 0x3BC79CA10C924224, %84 ]
  %98 = phi i64 [ %131, %128 ], [ 0, %84 ]
  %99 = phi i32 [ %103, %128 ], [ %85, %84 ]
  %100 = icmp eq i64 %98, %2
  %101 = fcmp ole double %97, 1.000000e-04
  %102 = select i1 %101, i32 %99, i32 0
  %103 = select i1 %100, i32 %102, i32 %99
  %104 = getelementptr inbounds double, ptr %19, i64 %98
  %105 = load double, ptr %104, align 8
  %106 = fcmp une double %105, 0.000000e+00
  %107 = and i32 %103, 1
  %108 = icmp eq i32 %107, 0
  %109 = select i1 %106, i1 true, i1 %108
  br i1 %109, label %128, label %110

110:                                              ; preds = %95
  %111 = mul nsw i64 %98, %8
  %112 = getelementptr inbounds double, ptr %9, i64 %111
  br i1 %39, label %113, label %122

113:                                              ; preds = %110, %113
  %114 = phi i64 [ %120, %113 ], [ 0, %110 ]
  %115 = phi double [ %119, %113 ], [ 0.000000e+00, %110 ]
  %116 = getelementptr inbounds double, ptr %112, i64 %114
  %117 = load double, ptr %116, align 8
  %118 = fmul double %117, %117
  %119 = fadd double %115, %118
  %120 = add nuw nsw i64 %114, 1
  %121 = icmp eq i64 %120, %8
  br i1 %121, label %122, label %113, !llvm.loop !24

122:                                              ; preds = %113, %110
  %123 = phi double [ 0.000000e+00, %110 ], [ %119, %113 ]
  %124 = fcmp ule double %123, %97
  %125 = uitofp nneg i64 %98 to double
  %126 = select i1 %124, double %96, double %125
  %127 = select i1 %124, double %97, double %123
  br label %128

128:                                              ; preds = %122, %95
  %129 = phi double [ %127, %122 ], [ %97, %95 ]
  %130 = phi double [ %126, %122 ], [ %96, %95 ]
  %131 = add nuw nsw i64 %98, 1
  %132 = icmp eq i64 %131, %6
  br i1 %132, label %88, label %95, !llvm.loop !39

133:                                              ; preds = %88
  %134 = fadd double %86, 1.000000e+00
  %135 = tail call double @llvm.sqrt.f64(double %89)
  br i1 %40, label %138, label %136

136:                                              ; preds = %162, %133
  %137 = phi double [ 0.000000e+00, %133 ], [ %163, %162 ]
  br i1 %42, label %167, label %166

138:                                              ; preds = %133, %162
  %139 = phi i64 [ %164, %162 ], [ 0, %133 ]
  %140 = phi double [ %163, %162 ], [ 0.000000e+00, %133 ]
  %141 = uitofp nneg i64 %139 to double
  %142 = fcmp une double %90, %141
  br i1 %142, label %162, label %143

143:                                              ; preds = %138
  %144 = getelementptr inbounds double, ptr %13, i64 %139
  %145 = load double, ptr %144, align 8
  %146 = fdiv double %145, %135
  store double 0.000000e+00, ptr %144, align 8
  %147 = getelementptr inbounds double, ptr %17, i64 %139
  %148 = load double, ptr %147, align 8
  %149 = fmul double %135, %148
  %150 = getelementptr inbounds double, ptr %19, i64 %139
  store double %149, ptr %150, align 8
  br i1 %41, label %151, label %162

151:                                              ; preds = %143
  %152 = mul nuw nsw i64 %139, %8
  %153 = getelementptr double, ptr %9, i64 %152
  br label %154

154:                                              ; preds = %151, %154
  %155 = phi i64 [ 0, %151 ], [ %160, %154 ]
  %156 = getelementptr double, ptr %153, i64 %155
  %157 = load double, ptr %156, align 8
  %158 = fdiv double %157, %135
  %159 = getelementptr inbounds double, ptr %21, i64 %155
  store double %158, ptr %159, align 8
  %160 = add nuw nsw i64 %155, 1
  %161 = icmp eq i64 %160, %8
  br i1 %161, label %162, label %154, !llvm.loop !40

162:                                              ; preds = %154, %143, %138
  %163 = phi double [ %140, %138 ], [ %146, %143 ], [ %146, %154 ]
  %164 = add nuw nsw i64 %139, 1
  %165 = icmp eq i64 %164, %6
  br i1 %165, label %136, label %138, !llvm.loop !41

166:                                              ; preds = %167, %136
  br i1 %43, label %177, label %215

167:                                              ; preds = %136, %167
  %168 = phi i64 [ %175, %167 ], [ 0, %136 ]
  %169 = getelementptr inbounds double, ptr %11, i64 %168
  %170 = load double, ptr %169, align 8
  %171 = getelementptr inbounds double, ptr %21, i64 %168
  %172 = load double, ptr %171, align 8
  %173 = fmul double %137, %172
  %174 = fadd double %170, %173
  store double %174, ptr %169, align 8
  %175 = add nuw nsw i64 %168, 1
  %176 = icmp eq i64 %175, %8
  br i1 %176, label %166, label %167, !llvm.loop !42

177:                                              ; preds = %166, %212
  %178 = phi i64 [ %213, %212 ], [ 0, %166 ]
  %179 = mul nsw i64 %178, %8
  %180 = getelementptr inbounds double, ptr %9, i64 %179
  %181 = getelementptr inbounds double, ptr %19, i64 %178
  %182 = load double, ptr %181, align 8
  %183 = fcmp une double %182, 0.000000e+00
  br i1 %183, label %212, label %184

184:                                              ; preds = %177
  br i1 %44, label %185, label %196

185:                                              ; preds = %184, %185
  %186 = phi i64 [ %194, %185 ], [ 0, %184 ]
  %187 = phi double [ %193, %185 ], [ 0.000000e+00, %184 ]
  %188 = getelementptr inbounds double, ptr %180, i64 %186
  %189 = load double, ptr %188, align 8
  %190 = getelementptr inbounds double, ptr %21, i64 %186
  %191 = load double, ptr %190, align 8
  %192 = fmul double %189, %191
  %193 = fadd double %187, %192
  %194 = add nuw nsw i64 %186, 1
  %195 = icmp eq i64 %194, %8
  br i1 %195, label %196, label %185, !llvm.loop !24

196:                                              ; preds = %185, %184
  %197 = phi double [ 0.000000e+00, %184 ], [ %193, %185 ]
  %198 = getelementptr inbounds double, ptr %13, i64 %178
  %199 = load double, ptr %198, align 8
  %200 = fmul double %137, %197
  %201 = fsub double %199, %200
  store double %201, ptr %198, align 8
  br i1 %45, label %202, label %212

202:                                              ; preds = %196, %202
  %203 = phi i64 [ %210, %202 ], [ 0, %196 ]
  %204 = getelementptr inbounds double, ptr %180, i64 %203
  %205 = load double, ptr %204, align 8
  %206 = getelementptr inbounds double, ptr %21, i64 %203
  %207 = load double, ptr %206, align 8
  %208 = fmul double %197, %207
  %209 = fsub double %205, %208
  store double %209, ptr %204, align 8
  %210 = add nuw nsw i64 %203, 1
  %211 = icmp eq i64 %210, %8
  br i1 %211, label %212, label %202, !llvm.loop !43

212:                                              ; preds = %202, %196, %177
  %213 = add nuw nsw i64 %178, 1
  %214 = icmp eq i64 %213, %6
  br i1 %214, label %215, label %177, !llvm.loop !44

215:                                              ; preds = %212, %166, %88
  %216 = phi double [ %86, %88 ], [ %134, %166 ], [ %134, %212 ]
  %217 = add nuw nsw i64 %87, 1
  %218 = icmp eq i64 %217, %2
  %219 = select i1 %94, i1 true, i1 %218
  br i1 %219, label %220, label %84, !llvm.loop !45

220:                                              ; preds = %215, %35
  %221 = phi double [ 0.000000e+00, %35 ], [ %216, %215 ]
  %222 = icmp sgt i64 %6, %2
  %223 = select i1 %222, i64 %2, i64 -1
  %224 = sitofp i64 %223 to double
  %225 = fcmp une double %221, %224
  %226 = icmp sgt i64 %6, 0
  br i1 %226, label %228, label %227

227:                                              ; preds = %228, %220
  ret void

228:                                              ; preds = %220, %228
  %229 = phi i64 [ %236, %228 ], [ 0, %220 ]
  %230 = getelementptr inbounds double, ptr %13, i64 %229
  %231 = load double, ptr %230, align 8
  %232 = getelementptr inbounds double, ptr %15, i64 %229
  %233 = load double, ptr %232, align 8
  %234 = fdiv double %231, %233
  %235 = select i1 %225, double %234, double 0.000000e+00
  store double %235, ptr %230, align 8
  %236 = add nuw nsw i64 %229, 1
  %237 = icmp eq i64 %236, %6
  br i1 %237, label %227, label %228, !llvm.loop !46
}

declare double @llvm.sqrt.f64(double) #3

define internal fastcc void @divide_transposed(ptr noundef readonly %0, i64 noundef %1, ptr noundef %2) unnamed_addr #4 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %5, label %7

5:                                                ; preds = %3
  %6 = add nuw i64 %1, 1
  br label %8

7:                                                ; preds = %15, %3
  ret void

8:                                                ; preds = %5, %15
  %9 = phi i64 [ %1, %5 ], [ %10, %15 ]
  %10 = add nsw i64 %9, -1
  %11 = getelementptr inbounds double, ptr %2, i64 %10
  %12 = load double, ptr %11, align 8
  %13 = getelementptr double, ptr %0, i64 %10
  %14 = icmp slt i64 %9, %1
  br i1 %14, label %22, label %15

15:                                               ; preds = %22, %8
  %16 = phi double [ %12, %8 ], [ %31, %22 ]
  %17 = mul i64 %10, %6
  %18 = getelementptr inbounds double, ptr %0, i64 %17
  %19 = load double, ptr %18, align 8
  %20 = fdiv double %16, %19
  store double %20, ptr %11, align 8
  %21 = icmp sgt i64 %9, 1
  br i1 %21, label %8, label %7, !llvm.loop !47

22:                                               ; preds = %8, %22
  %23 = phi i64 [ %32, %22 ], [ %9, %8 ]
  %24 = phi double [ %31, %22 ], [ %12, %8 ]
  %25 = mul nsw i64 %23, %1
  %26 = getelementptr double, ptr %13, i64 %25
  %27 = load double, ptr %26, align 8
  %28 = getelementptr inbounds double, ptr %2, i64 %23
  %29 = load double, ptr %28, align 8
  %30 = fmul double %27, %29
  %31 = fsub double %24, %30
  %32 = add nuw nsw i64 %23, 1
  %33 = icmp eq i64 %32, %1
  br i1 %33, label %15, label %22, !llvm.loop !48
}

define internal fastcc void @factorise(ptr noundef %0, i64 noundef %1) unnamed_addr #4 {
  %3 = icmp sgt i64 %1, 0
  br i1 %3, label %4, label %13

4:                                                ; preds = %2
  %5 = sitofp i64 %1 to double
  %6 = fmul double %5, 4.000000e+00
  %7 = fmul double %6, 0x3CB0000000000000
  br label %17

8:                                                ; preds = %53, %26
  %9 = icmp slt i64 %31, %1
  %10 = select i1 %9, i1 %29, i1 false
  br i1 %10, label %17, label %11, !llvm.loop !49

11:                                               ; preds = %8
  %12 = xor i1 %29, true
  br label %13

13:                                               ; preds = %11, %2
  %14 = phi i1 [ false, %2 ], [ %12, %11 ]
  %15 = icmp sgt i64 %1, 0
  %16 = and i1 %14, %15
  br i1 %16, label %69, label %83

17:                                               ; preds = %4, %8
  %18 = phi i64 [ 0, %4 ], [ %31, %8 ]
  %19 = mul nuw nsw i64 %18, %1
  %20 = getelementptr double, ptr %0, i64 %19
  %21 = getelementptr double, ptr %20, i64 %18
  %22 = load double, ptr %21, align 8
  %23 = icmp eq i64 %18, 0
  br i1 %23, label %26, label %24

24:                                               ; preds = %17
  %25 = getelementptr double, ptr %0, i64 %19
  br label %37

26:                                               ; preds = %37, %17
  %27 = phi double [ %22, %17 ], [ %43, %37 ]
  %28 = fmul double %7, %22
  %29 = fcmp ogt double %27, %28
  %30 = tail call double @llvm.sqrt.f64(double %27)
  store double %30, ptr %21, align 8
  %31 = add nuw nsw i64 %18, 1
  %32 = getelementptr double, ptr %0, i64 %18
  %33 = icmp slt i64 %31, %1
  br i1 %33, label %34, label %8

34:                                               ; preds = %26
  %35 = icmp eq i64 %18, 0
  %36 = getelementptr double, ptr %0, i64 %19
  br label %46

37:                                               ; preds = %24, %37
  %38 = phi i64 [ 0, %24 ], [ %44, %37 ]
  %39 = phi double [ %22, %24 ], [ %43, %37 ]
  %40 = getelementptr double, ptr %25, i64 %38
  %41 = load double, ptr %40, align 8
  %42 = fmul double %41, %41
  %43 = fsub double %39, %42
  %44 = add nuw nsw i64 %38, 1
  %45 = icmp eq i64 %44, %18
  br i1 %45, label %26, label %37, !llvm.loop !50

46:                                               ; preds = %34, %53
  %47 = phi i64 [ %31, %34 ], [ %56, %53 ]
  %48 = mul nuw nsw i64 %47, %1
  %49 = getelementptr double, ptr %32, i64 %48
  %50 = load double, ptr %49, align 8
  br i1 %35, label %53, label %51

51:                                               ; preds = %46
  %52 = getelementptr double, ptr %0, i64 %48
  br label %58

53:                                               ; preds = %58, %46
  %54 = phi double [ %50, %46 ], [ %66, %58 ]
  %55 = fdiv double %54, %30
  store double %55, ptr %49, align 8
  %56 = add nuw nsw i64 %47, 1
  %57 = icmp slt i64 %56, %1
  br i1 %57, label %46, label %8, !llvm.loop !51

58:                                               ; preds = %51, %58
  %59 = phi i64 [ 0, %51 ], [ %67, %58 ]
  %60 = phi double [ %50, %51 ], [ %66, %58 ]
  %61 = getelementptr double, ptr %52, i64 %59
  %62 = load double, ptr %61, align 8
  %63 = getelementptr double, ptr %36, i64 %59
  %64 = load double, ptr %63, align 8
  %65 = fmul double %62, %64
  %66 = fsub double %60, %65
  %67 = add nuw nsw i64 %59, 1
  %68 = icmp eq i64 %67, %18
  br i1 %68, label %53, label %58, !llvm.loop !52

69:                                               ; preds = %13, %73
  %70 = phi i64 [ %74, %73 ], [ 0, %13 ]
  %71 = mul nuw nsw i64 %70, %1
  %72 = getelementptr double, ptr %0, i64 %71
  br label %76

73:                                               ; preds = %76
  %74 = add nuw nsw i64 %70, 1
  %75 = icmp eq i64 %74, %1
  br i1 %75, label %83, label %69, !llvm.loop !6

76:                                               ; preds = %69, %76
  %77 = phi i64 [ 0, %69 ], [ %81, %76 ]
  %78 = icmp eq i64 %70, %77
  %79 = select i1 %78, double 1.000000e+00, double 0.000000e+00
  %80 = getelementptr double, ptr %72, i64 %77
  store double %79, ptr %80, align 8
  %81 = add nuw nsw i64 %77, 1
  %82 = icmp eq i64 %81, %1
  br i1 %82, label %73, label %76, !llvm.loop !9

83:                                               ; preds = %73, %13
  ret void
}

declare void @llvm.experimental.noalias.scope.decl(metadata) #5

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { nounwind willreturn memory(none) }
attributes #4 = { noinline nounwind }
attributes #5 = { nounwind willreturn }
attributes #6 = { nounwind }
attributes #7 = { nounwind }
attributes #8 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = !{!4}
!4 = distinct !{!4, !5, !"held_by: argument 0"}
!5 = distinct !{!5, !"held_by"}
!6 = distinct !{!6, !7, !8}
!7 = !{!"llvm.loop.mustprogress"}
!8 = !{!"llvm.loop.unroll.disable"}
!9 = distinct !{!9, !7, !8}
!10 = distinct !{!10, !7, !8}
!11 = distinct !{!11, !8}
!12 = distinct !{!12, !7, !8}
!13 = distinct !{!13, !7, !8}
!14 = distinct !{!14, !7, !8}
!15 = distinct !{!15, !7, !8}
!16 = distinct !{!16, !7, !8}
!17 = distinct !{!17, !7, !8}
!18 = distinct !{!18, !7, !8}
!19 = distinct !{!19, !7, !8}
!20 = distinct !{!20, !7, !8}
!21 = distinct !{!21, !7, !8}
!22 = distinct !{!22, !7, !8}
!23 = distinct !{!23, !7, !8}
!24 = distinct !{!24, !7, !8}
!25 = distinct !{!25, !7, !8}
!26 = distinct !{!26, !7, !8}
!27 = distinct !{!27, !7, !8}
!28 = distinct !{!28, !7, !8}
!29 = distinct !{!29, !7, !8}
!30 = distinct !{!30, !7, !8}
!31 = distinct !{!31, !7, !8}
!32 = distinct !{!32, !7, !8}
!33 = distinct !{!33, !7, !8}
!34 = distinct !{!34, !7, !8}
!35 = distinct !{!35, !7, !8}
!36 = distinct !{!36, !7, !8}
!37 = distinct !{!37, !7, !8}
!38 = distinct !{!38, !7, !8}
!39 = distinct !{!39, !7, !8}
!40 = distinct !{!40, !7, !8}
!41 = distinct !{!41, !7, !8}
!42 = distinct !{!42, !7, !8}
!43 = distinct !{!43, !7, !8}
!44 = distinct !{!44, !7, !8}
!45 = distinct !{!45, !7, !8}
!46 = distinct !{!46, !7, !8}
!47 = distinct !{!47, !7, !8}
!48 = distinct !{!48, !7, !8}
!49 = distinct !{!49, !7, !8}
!50 = distinct !{!50, !7, !8}
!51 = distinct !{!51, !7, !8}
!52 = distinct !{!52, !7, !8}
