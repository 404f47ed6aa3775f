; sources 9b48017d6fef7dd800f00cc92caee81ae76d0bc6cc4d4e0fc3da945ca0a1c2ea
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

@PLACES = internal unnamed_addr constant [9 x double] [double 0.000000e+00, double 0x3FB8722191A02D60, double 2.500000e-01, double 0x3FD6A09E667F3BCD, double 5.000000e-01, double 0x3FE3988E1409212E, double 7.500000e-01, double 0x3FED2A7FA9D2F8EA, double 1.000000e+00], align 16

define i64 @scan_events(ptr noundef %0, double noundef %1, double noundef %2) #0 {
  %4 = alloca [3 x double], align 16
  %5 = alloca %struct.Stepper, align 8
  store ptr %0, ptr %5, align 8
  %6 = getelementptr inbounds i8, ptr %5, i64 8
  %7 = getelementptr inbounds i8, ptr %0, i64 144
  store ptr %7, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %5, i64 16
  %9 = getelementptr inbounds i8, ptr %0, i64 312
  store ptr %9, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 720
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %11, i64 8
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %0, i64 768
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 816
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %0, i64 840
  %19 = load ptr, ptr %18, align 8
  %20 = getelementptr inbounds i8, ptr %0, i64 576
  %21 = getelementptr inbounds i8, ptr %0, i64 600
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr inbounds i8, ptr %22, i64 80
  %24 = load i64, ptr %23, align 8
  %25 = load ptr, ptr %20, align 8
  %26 = getelementptr inbounds i8, ptr %0, i64 864
  %27 = load ptr, ptr %26, align 8
  %28 = shl nsw i64 %13, 4
  %29 = getelementptr inbounds i8, ptr %27, i64 %28
  %30 = mul i64 %13, 56
  %31 = getelementptr inbounds i8, ptr %27, i64 %30
  %32 = getelementptr inbounds double, ptr %27, i64 %13
  %33 = getelementptr inbounds i8, ptr %0, i64 992
  %34 = load i64, ptr %33, align 8
  %35 = icmp sgt i64 %34, 0
  br i1 %35, label %36, label %47

36:                                               ; preds = %3
  %37 = call fastcc i64 @unresolved(ptr noundef %0, ptr noundef nonnull %5, double noundef %1, double noundef %2) #8
  switch i64 %37, label %44 [
    i64 -4, label %38
    i64 0, label %43
  ]

38:                                               ; preds = %36
  %39 = load ptr, ptr %21, align 8
  %40 = getelementptr inbounds i8, ptr %39, i64 80
  store i64 %24, ptr %40, align 8
  %41 = load ptr, ptr %20, align 8
  %42 = getelementptr inbounds i8, ptr %41, i64 48
  store double 1.000000e+00, ptr %42, align 8
  br label %44

43:                                               ; preds = %36
  br label %44

44:                                               ; preds = %36, %43, %38
  %45 = phi i1 [ false, %38 ], [ true, %43 ], [ false, %36 ]
  %46 = phi i64 [ -4, %38 ], [ undef, %43 ], [ %37, %36 ]
  br i1 %45, label %47, label %822

47:                                               ; preds = %44, %3
  %48 = phi i64 [ %46, %44 ], [ undef, %3 ]
  %49 = load double, ptr %31, align 8
  %50 = fcmp oeq double %49, %1
  %51 = getelementptr inbounds i8, ptr %0, i64 888
  %52 = getelementptr inbounds i8, ptr %0, i64 408
  %53 = getelementptr inbounds i8, ptr %0, i64 504
  %54 = getelementptr inbounds i8, ptr %0, i64 320
  %55 = getelementptr inbounds i8, ptr %0, i64 168
  %56 = getelementptr inbounds i8, ptr %0, i64 248
  %57 = getelementptr inbounds i8, ptr %0, i64 168
  %58 = getelementptr inbounds i8, ptr %0, i64 192
  %59 = getelementptr inbounds i8, ptr %0, i64 744
  %60 = zext i1 %50 to i64
  br label %65

61:                                               ; preds = %92
  %62 = add nuw nsw i64 %66, 1
  %63 = icmp ugt i64 %66, 3
  %64 = icmp eq i64 %62, 5
  br i1 %64, label %112, label %65, !llvm.loop !3

65:                                               ; preds = %47, %61
  %66 = phi i64 [ %60, %47 ], [ %62, %61 ]
  %67 = phi i1 [ false, %47 ], [ %63, %61 ]
  %68 = trunc nuw nsw i64 %66 to i32
  %69 = uitofp nneg i32 %68 to double
  %70 = fmul double %69, 2.500000e-01
  %71 = add nuw nsw i64 %66, 2
  %72 = load ptr, ptr %51, align 8
  %73 = load ptr, ptr %52, align 8
  %74 = insertelement <8 x double> poison, double %70, i64 0
  %75 = shufflevector <8 x double> %74, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %75, ptr %73, align 8
  %76 = load ptr, ptr %9, align 8
  %77 = load ptr, ptr %53, align 8
  %78 = load i64, ptr %54, align 8
  %79 = load ptr, ptr %0, align 8
  %80 = getelementptr inbounds i8, ptr %79, i64 24
  %81 = load i64, ptr %80, align 8
  %82 = load ptr, ptr %52, align 8
  %83 = load ptr, ptr %7, align 8
  %84 = getelementptr inbounds i8, ptr %83, i64 16
  %85 = load i64, ptr %84, align 8
  tail call fastcc void @nested(ptr noundef %72, ptr noundef %76, ptr noundef %77, i64 noundef %78, i64 noundef %81, ptr noundef %82, i64 noundef %85) #8
  %86 = fmul double %70, %2
  %87 = fadd double %86, %1
  %88 = load ptr, ptr %55, align 8
  store double %87, ptr %88, align 8
  %89 = load i64, ptr %56, align 8
  %90 = icmp sgt i64 %89, 0
  br i1 %90, label %91, label %92

91:                                               ; preds = %65
  tail call fastcc void @sample(ptr noundef nonnull %7) #8
  br label %92

92:                                               ; preds = %65, %91
  %93 = load ptr, ptr %10, align 8
  %94 = load i64, ptr %93, align 8
  %95 = load ptr, ptr %57, align 8
  %96 = load ptr, ptr %51, align 8
  %97 = load ptr, ptr %58, align 8
  %98 = load ptr, ptr %59, align 8
  %99 = load ptr, ptr %26, align 8
  %100 = getelementptr inbounds i8, ptr %93, i64 8
  %101 = load i64, ptr %100, align 8
  %102 = mul nsw i64 %101, %71
  %103 = getelementptr inbounds double, ptr %99, i64 %102
  %104 = inttoptr i64 %94 to ptr
  %105 = tail call i32 %104(ptr noundef %95, ptr noundef %96, ptr noundef %97, ptr noundef %98, ptr noundef %103) #9
  %106 = icmp slt i32 %105, 0
  br i1 %106, label %107, label %61

107:                                              ; preds = %92
  %108 = load ptr, ptr %21, align 8
  %109 = getelementptr inbounds i8, ptr %108, i64 80
  store i64 %24, ptr %109, align 8
  %110 = load ptr, ptr %20, align 8
  %111 = getelementptr inbounds i8, ptr %110, i64 48
  store double 1.000000e+00, ptr %111, align 8
  br label %112

112:                                              ; preds = %61, %107
  %113 = phi i1 [ %67, %107 ], [ %63, %61 ]
  %114 = phi i64 [ -4, %107 ], [ %48, %61 ]
  br i1 %113, label %115, label %822

115:                                              ; preds = %112
  store double 0x7FF8000000000000, ptr %31, align 8
  %116 = getelementptr inbounds i8, ptr %4, i64 8
  %117 = getelementptr inbounds i8, ptr %4, i64 16
  %118 = getelementptr inbounds i8, ptr %0, i64 792
  %119 = getelementptr inbounds i8, ptr %0, i64 888
  %120 = getelementptr inbounds i8, ptr %0, i64 408
  %121 = getelementptr inbounds i8, ptr %0, i64 504
  %122 = getelementptr inbounds i8, ptr %0, i64 320
  %123 = getelementptr inbounds i8, ptr %0, i64 168
  %124 = getelementptr inbounds i8, ptr %0, i64 248
  %125 = getelementptr inbounds i8, ptr %0, i64 168
  %126 = getelementptr inbounds i8, ptr %0, i64 192
  %127 = getelementptr inbounds i8, ptr %0, i64 744
  %128 = getelementptr inbounds i8, ptr %0, i64 888
  %129 = getelementptr inbounds i8, ptr %0, i64 408
  %130 = getelementptr inbounds i8, ptr %0, i64 504
  %131 = getelementptr inbounds i8, ptr %0, i64 320
  %132 = getelementptr inbounds i8, ptr %0, i64 168
  %133 = getelementptr inbounds i8, ptr %0, i64 248
  %134 = getelementptr inbounds i8, ptr %0, i64 168
  %135 = getelementptr inbounds i8, ptr %0, i64 192
  %136 = getelementptr inbounds i8, ptr %0, i64 744
  %137 = icmp sgt i64 %13, 0
  %138 = getelementptr inbounds i8, ptr %0, i64 792
  %139 = getelementptr inbounds i8, ptr %0, i64 888
  %140 = getelementptr inbounds i8, ptr %0, i64 408
  %141 = getelementptr inbounds i8, ptr %0, i64 504
  %142 = getelementptr inbounds i8, ptr %0, i64 320
  %143 = getelementptr inbounds i8, ptr %0, i64 168
  %144 = getelementptr inbounds i8, ptr %0, i64 248
  %145 = getelementptr inbounds i8, ptr %0, i64 168
  %146 = getelementptr inbounds i8, ptr %0, i64 192
  %147 = getelementptr inbounds i8, ptr %0, i64 744
  %148 = icmp slt i64 %13, 1
  %149 = icmp sgt i64 %13, 0
  %150 = getelementptr inbounds i8, ptr %0, i64 792
  %151 = getelementptr inbounds i8, ptr %25, i64 48
  %152 = icmp sgt i64 %13, 0
  %153 = getelementptr inbounds i8, ptr %0, i64 920
  %154 = getelementptr inbounds i8, ptr %0, i64 912
  %155 = getelementptr inbounds i8, ptr %0, i64 936
  %156 = getelementptr inbounds i8, ptr %0, i64 960
  %157 = getelementptr inbounds i8, ptr %0, i64 976
  %158 = getelementptr inbounds i8, ptr %0, i64 920
  %159 = getelementptr inbounds i8, ptr %25, i64 48
  %160 = icmp sgt i64 %13, 0
  %161 = getelementptr inbounds i8, ptr %25, i64 48
  %162 = icmp sgt i64 %13, 0
  br label %163

163:                                              ; preds = %115, %800
  %164 = phi i1 [ false, %115 ], [ %804, %800 ]
  %165 = phi i64 [ %114, %115 ], [ %798, %800 ]
  %166 = phi double [ 0.000000e+00, %115 ], [ %797, %800 ]
  %167 = phi i32 [ 1, %115 ], [ %803, %800 ]
  %168 = uitofp nneg i32 %167 to double
  %169 = fmul double %168, 2.500000e-01
  %170 = load ptr, ptr %10, align 8
  %171 = getelementptr inbounds i8, ptr %170, i64 8
  %172 = load i64, ptr %171, align 8
  %173 = load ptr, ptr %26, align 8
  %174 = add nuw nsw i32 %167, 2
  %175 = zext nneg i32 %174 to i64
  %176 = mul nsw i64 %172, %175
  %177 = getelementptr inbounds double, ptr %173, i64 %176
  %178 = icmp sgt i64 %172, 0
  br i1 %178, label %179, label %357

179:                                              ; preds = %163
  %180 = shl nsw i64 %172, 4
  %181 = add nsw i32 %167, -1
  %182 = icmp ugt i32 %167, 1
  %183 = select i1 %182, i32 %181, i32 1
  %184 = icmp sle i32 %183, %167
  %185 = icmp slt i32 %183, 4
  %186 = and i1 %184, %185
  %187 = icmp eq i32 %167, 1
  %188 = sext i1 %187 to i32
  %189 = add nsw i32 %181, %188
  %190 = sitofp i32 %189 to double
  %191 = icmp eq i32 %167, 4
  %192 = select i1 %191, i32 5, i32 %167
  %193 = uitofp nneg i32 %192 to double
  %194 = uitofp nneg i32 %167 to double
  %195 = fmul double %194, 2.500000e-01
  %196 = sext i32 %183 to i64
  %197 = zext nneg i32 %167 to i64
  %198 = tail call i64 @llvm.smin.i64(i64 %197, i64 3)
  br label %199

199:                                              ; preds = %179, %354
  %200 = phi double [ 2.000000e+00, %179 ], [ %353, %354 ]
  %201 = phi double [ 2.000000e+00, %179 ], [ %352, %354 ]
  %202 = phi i64 [ 0, %179 ], [ %355, %354 ]
  %203 = load ptr, ptr %26, align 8
  %204 = getelementptr inbounds i8, ptr %203, i64 %180
  %205 = getelementptr inbounds double, ptr %204, i64 %202
  %206 = load ptr, ptr %16, align 8
  %207 = getelementptr inbounds i64, ptr %206, i64 %202
  %208 = load i64, ptr %207, align 8
  %209 = sitofp i64 %208 to double
  br i1 %186, label %210, label %350

210:                                              ; preds = %199
  %211 = getelementptr inbounds double, ptr %173, i64 %202
  br label %212

212:                                              ; preds = %210, %347
  %213 = phi i64 [ %196, %210 ], [ %348, %347 ]
  %214 = phi double [ %200, %210 ], [ %346, %347 ]
  %215 = phi double [ %201, %210 ], [ %345, %347 ]
  %216 = trunc nsw i64 %213 to i32
  %217 = sitofp i32 %216 to double
  %218 = add nsw i64 %213, -1
  br label %229

219:                                              ; preds = %229
  %220 = fmul double %217, 2.500000e-01
  %221 = load double, ptr %4, align 16
  %222 = fcmp ogt double %221, 0.000000e+00
  %223 = load double, ptr %116, align 8
  %224 = fcmp ogt double %223, 0.000000e+00
  %225 = select i1 %222, i1 %224, i1 false
  %226 = load double, ptr %117, align 16
  %227 = fcmp ogt double %226, 0.000000e+00
  %228 = select i1 %225, i1 %227, i1 false
  br i1 %228, label %239, label %343

229:                                              ; preds = %212, %229
  %230 = phi i64 [ 0, %212 ], [ %237, %229 ]
  %231 = add nsw i64 %218, %230
  %232 = mul nsw i64 %172, %231
  %233 = getelementptr inbounds double, ptr %205, i64 %232
  %234 = load double, ptr %233, align 8
  %235 = fmul double %234, %209
  %236 = getelementptr inbounds [3 x double], ptr %4, i64 0, i64 %230
  store double %235, ptr %236, align 8
  %237 = add nuw nsw i64 %230, 1
  %238 = icmp eq i64 %237, 3
  br i1 %238, label %219, label %229, !llvm.loop !6

239:                                              ; preds = %219
  %240 = fsub double %226, %221
  %241 = fmul double %240, 5.000000e-01
  %242 = fmul double %223, 2.000000e+00
  %243 = fsub double %226, %242
  %244 = fadd double %221, %243
  %245 = fmul double %220, 4.000000e+00
  %246 = fdiv double %241, %244
  %247 = fsub double %245, %246
  %248 = fcmp ule double %244, 0.000000e+00
  %249 = fcmp ult double %247, %190
  %250 = select i1 %248, i1 true, i1 %249
  %251 = fcmp ugt double %247, %193
  %252 = select i1 %250, i1 true, i1 %251
  br i1 %252, label %343, label %253

253:                                              ; preds = %239
  %254 = fadd double %220, -2.500000e-01
  %255 = call fastcc double @least_place(ptr noundef %0, ptr noundef nonnull %5, double noundef %1, double noundef %2, i64 noundef %202, double noundef %209, double noundef %254, ptr noundef nonnull %4) #8
  %256 = fcmp oeq double %255, -4.000000e+00
  br i1 %256, label %343, label %257

257:                                              ; preds = %253
  %258 = fcmp ogt double %255, %166
  br i1 %258, label %259, label %343

259:                                              ; preds = %257
  %260 = fcmp olt double %214, %195
  %261 = select i1 %260, double %214, double %195
  %262 = fcmp olt double %255, %261
  br i1 %262, label %265, label %343

263:                                              ; preds = %300
  %264 = fcmp ugt double %301, 1.000000e+00
  br i1 %264, label %336, label %304

265:                                              ; preds = %259, %300
  %266 = phi i64 [ %302, %300 ], [ 0, %259 ]
  %267 = phi double [ %301, %300 ], [ %215, %259 ]
  %268 = load ptr, ptr %118, align 8
  %269 = getelementptr inbounds i64, ptr %268, i64 %266
  %270 = load i64, ptr %269, align 8
  %271 = icmp eq i64 %270, 1
  br i1 %271, label %272, label %300

272:                                              ; preds = %265
  %273 = load ptr, ptr %16, align 8
  %274 = getelementptr inbounds i64, ptr %273, i64 %266
  %275 = load i64, ptr %274, align 8
  %276 = getelementptr inbounds double, ptr %177, i64 %266
  %277 = load double, ptr %276, align 8
  %278 = load ptr, ptr %14, align 8
  %279 = getelementptr inbounds i64, ptr %278, i64 %266
  %280 = load i64, ptr %279, align 8
  %281 = icmp slt i64 %275, 0
  %282 = fcmp ogt double %277, 0.000000e+00
  %283 = and i1 %281, %282
  %284 = icmp sgt i64 %280, -1
  %285 = and i1 %283, %284
  br i1 %285, label %293, label %286

286:                                              ; preds = %272
  %287 = icmp sgt i64 %275, 0
  %288 = fcmp olt double %277, 0.000000e+00
  %289 = and i1 %287, %288
  br i1 %289, label %290, label %293

290:                                              ; preds = %286
  %291 = icmp slt i64 %280, 1
  %292 = zext i1 %291 to i32
  br label %293

293:                                              ; preds = %272, %286, %290
  %294 = phi i32 [ 1, %272 ], [ 0, %286 ], [ %292, %290 ]
  %295 = icmp eq i32 %294, 0
  br i1 %295, label %300, label %296

296:                                              ; preds = %293
  %297 = call fastcc double @locate(ptr noundef %0, ptr noundef nonnull %5, double noundef %1, double noundef %2, double noundef %166, double noundef %195, i64 noundef %266) #8
  %298 = fcmp olt double %267, %297
  %299 = select i1 %298, double %267, double %297
  br label %300

300:                                              ; preds = %296, %293, %265
  %301 = phi double [ %299, %296 ], [ %267, %293 ], [ %267, %265 ]
  %302 = add nuw nsw i64 %266, 1
  %303 = icmp eq i64 %302, %172
  br i1 %303, label %263, label %265, !llvm.loop !7

304:                                              ; preds = %263
  %305 = load ptr, ptr %119, align 8
  %306 = load ptr, ptr %120, align 8
  %307 = insertelement <8 x double> poison, double %301, i64 0
  %308 = shufflevector <8 x double> %307, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %308, ptr %306, align 8
  %309 = load ptr, ptr %9, align 8
  %310 = load ptr, ptr %121, align 8
  %311 = load i64, ptr %122, align 8
  %312 = load ptr, ptr %0, align 8
  %313 = getelementptr inbounds i8, ptr %312, i64 24
  %314 = load i64, ptr %313, align 8
  %315 = load ptr, ptr %120, align 8
  %316 = load ptr, ptr %7, align 8
  %317 = getelementptr inbounds i8, ptr %316, i64 16
  %318 = load i64, ptr %317, align 8
  tail call fastcc void @nested(ptr noundef %305, ptr noundef %309, ptr noundef %310, i64 noundef %311, i64 noundef %314, ptr noundef %315, i64 noundef %318) #8
  %319 = fmul double %301, %2
  %320 = fadd double %319, %1
  %321 = load ptr, ptr %123, align 8
  store double %320, ptr %321, align 8
  %322 = load i64, ptr %124, align 8
  %323 = icmp sgt i64 %322, 0
  br i1 %323, label %324, label %325

324:                                              ; preds = %304
  tail call fastcc void @sample(ptr noundef nonnull %7) #8
  br label %325

325:                                              ; preds = %304, %324
  %326 = load ptr, ptr %10, align 8
  %327 = load i64, ptr %326, align 8
  %328 = load ptr, ptr %125, align 8
  %329 = load ptr, ptr %119, align 8
  %330 = load ptr, ptr %126, align 8
  %331 = load ptr, ptr %127, align 8
  %332 = load ptr, ptr %26, align 8
  %333 = inttoptr i64 %327 to ptr
  %334 = tail call i32 %333(ptr noundef %328, ptr noundef %329, ptr noundef %330, ptr noundef %331, ptr noundef %332) #9
  %335 = icmp slt i32 %334, 0
  br i1 %335, label %343, label %336

336:                                              ; preds = %325, %263
  %337 = fcmp ogt double %301, 1.000000e+00
  br i1 %337, label %342, label %338

338:                                              ; preds = %336
  %339 = load double, ptr %211, align 8
  %340 = fmul double %339, %209
  %341 = fcmp ogt double %340, 0.000000e+00
  br i1 %341, label %342, label %343

342:                                              ; preds = %338, %336
  br label %343

343:                                              ; preds = %342, %338, %325, %259, %257, %253, %239, %219
  %344 = phi i32 [ 7, %219 ], [ 7, %239 ], [ 1, %253 ], [ 7, %259 ], [ 7, %257 ], [ 1, %325 ], [ 0, %342 ], [ 0, %338 ]
  %345 = phi double [ %215, %219 ], [ %215, %239 ], [ %215, %253 ], [ %215, %259 ], [ %215, %257 ], [ %301, %325 ], [ %301, %342 ], [ %301, %338 ]
  %346 = phi double [ %214, %219 ], [ %214, %239 ], [ %214, %253 ], [ %214, %259 ], [ %214, %257 ], [ %214, %325 ], [ %255, %342 ], [ %214, %338 ]
  switch i32 %344, label %350 [
    i32 0, label %347
    i32 7, label %347
  ]

347:                                              ; preds = %343, %343
  %348 = add nsw i64 %213, 1
  %349 = icmp slt i64 %213, %198
  br i1 %349, label %212, label %350, !llvm.loop !8

350:                                              ; preds = %347, %343, %199
  %351 = phi i32 [ 5, %199 ], [ 5, %347 ], [ %344, %343 ]
  %352 = phi double [ %201, %199 ], [ %345, %343 ], [ %345, %347 ]
  %353 = phi double [ %200, %199 ], [ %346, %343 ], [ %346, %347 ]
  switch i32 %351, label %357 [
    i32 5, label %354
    i32 0, label %354
  ]

354:                                              ; preds = %350, %350
  %355 = add nuw nsw i64 %202, 1
  %356 = icmp eq i64 %355, %172
  br i1 %356, label %357, label %199, !llvm.loop !9

357:                                              ; preds = %354, %350, %163
  %358 = phi double [ 2.000000e+00, %163 ], [ %353, %354 ], [ -4.000000e+00, %350 ]
  %359 = fcmp olt double %358, 0.000000e+00
  br i1 %359, label %790, label %360

360:                                              ; preds = %357
  %361 = zext nneg i32 %167 to i64
  %362 = mul nsw i64 %13, %361
  %363 = getelementptr inbounds double, ptr %29, i64 %362
  %364 = fcmp olt double %358, %169
  br i1 %364, label %365, label %398

365:                                              ; preds = %360
  %366 = load ptr, ptr %26, align 8
  %367 = load ptr, ptr %128, align 8
  %368 = load ptr, ptr %129, align 8
  %369 = insertelement <8 x double> poison, double %358, i64 0
  %370 = shufflevector <8 x double> %369, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %370, ptr %368, align 8
  %371 = load ptr, ptr %9, align 8
  %372 = load ptr, ptr %130, align 8
  %373 = load i64, ptr %131, align 8
  %374 = load ptr, ptr %0, align 8
  %375 = getelementptr inbounds i8, ptr %374, i64 24
  %376 = load i64, ptr %375, align 8
  %377 = load ptr, ptr %129, align 8
  %378 = load ptr, ptr %7, align 8
  %379 = getelementptr inbounds i8, ptr %378, i64 16
  %380 = load i64, ptr %379, align 8
  tail call fastcc void @nested(ptr noundef %367, ptr noundef %371, ptr noundef %372, i64 noundef %373, i64 noundef %376, ptr noundef %377, i64 noundef %380) #8
  %381 = fmul double %358, %2
  %382 = fadd double %381, %1
  %383 = load ptr, ptr %132, align 8
  store double %382, ptr %383, align 8
  %384 = load i64, ptr %133, align 8
  %385 = icmp sgt i64 %384, 0
  br i1 %385, label %386, label %387

386:                                              ; preds = %365
  tail call fastcc void @sample(ptr noundef nonnull %7) #8
  br label %387

387:                                              ; preds = %365, %386
  %388 = load ptr, ptr %10, align 8
  %389 = load i64, ptr %388, align 8
  %390 = load ptr, ptr %134, align 8
  %391 = load ptr, ptr %128, align 8
  %392 = load ptr, ptr %135, align 8
  %393 = load ptr, ptr %136, align 8
  %394 = load ptr, ptr %26, align 8
  %395 = inttoptr i64 %389 to ptr
  %396 = tail call i32 %395(ptr noundef %390, ptr noundef %391, ptr noundef %392, ptr noundef %393, ptr noundef %394) #9
  %397 = icmp slt i32 %396, 0
  br i1 %397, label %790, label %398

398:                                              ; preds = %387, %360
  %399 = phi double [ %358, %387 ], [ %169, %360 ]
  %400 = phi ptr [ %366, %387 ], [ %363, %360 ]
  br label %401

401:                                              ; preds = %772, %398
  %402 = phi double [ %166, %398 ], [ %774, %772 ]
  %403 = phi i64 [ %165, %398 ], [ %775, %772 ]
  br i1 %137, label %408, label %404

404:                                              ; preds = %458, %401
  %405 = phi double [ 2.000000e+00, %401 ], [ %459, %458 ]
  %406 = phi i32 [ 0, %401 ], [ %460, %458 ]
  %407 = fcmp ogt double %405, 1.000000e+00
  br i1 %407, label %772, label %463

408:                                              ; preds = %401, %458
  %409 = phi i64 [ %461, %458 ], [ 0, %401 ]
  %410 = phi i32 [ %460, %458 ], [ 0, %401 ]
  %411 = phi double [ %459, %458 ], [ 2.000000e+00, %401 ]
  %412 = getelementptr inbounds i64, ptr %19, i64 %409
  store i64 0, ptr %412, align 8
  %413 = getelementptr inbounds i64, ptr %17, i64 %409
  %414 = load i64, ptr %413, align 8
  %415 = getelementptr inbounds double, ptr %400, i64 %409
  %416 = load double, ptr %415, align 8
  %417 = getelementptr inbounds i64, ptr %15, i64 %409
  %418 = load i64, ptr %417, align 8
  %419 = icmp slt i64 %414, 0
  %420 = fcmp ogt double %416, 0.000000e+00
  %421 = and i1 %419, %420
  %422 = icmp sgt i64 %418, -1
  %423 = and i1 %421, %422
  br i1 %423, label %431, label %424

424:                                              ; preds = %408
  %425 = icmp sgt i64 %414, 0
  %426 = fcmp olt double %416, 0.000000e+00
  %427 = and i1 %425, %426
  br i1 %427, label %428, label %431

428:                                              ; preds = %424
  %429 = icmp slt i64 %418, 1
  %430 = zext i1 %429 to i32
  br label %431

431:                                              ; preds = %408, %424, %428
  %432 = phi i32 [ 1, %408 ], [ 0, %424 ], [ %430, %428 ]
  %433 = icmp eq i32 %432, 0
  br i1 %433, label %434, label %438

434:                                              ; preds = %431
  %435 = icmp eq i64 %414, 0
  %436 = fcmp ord double %416, 0.000000e+00
  %437 = or i1 %435, %436
  br i1 %437, label %458, label %438

438:                                              ; preds = %434, %431
  %439 = call fastcc double @locate(ptr noundef %0, ptr noundef nonnull %5, double noundef %1, double noundef %2, double noundef %402, double noundef %399, i64 noundef %409) #8
  %440 = fcmp ole double %439, %402
  %441 = zext i1 %440 to i64
  store i64 %441, ptr %412, align 8
  %442 = fcmp uge double %439, %411
  %443 = select i1 %442, i32 %410, i32 0
  %444 = fcmp ugt double %439, %411
  br i1 %444, label %455, label %445

445:                                              ; preds = %438
  %446 = icmp eq i32 %443, 0
  br i1 %446, label %447, label %452

447:                                              ; preds = %445
  %448 = load ptr, ptr %138, align 8
  %449 = getelementptr inbounds i64, ptr %448, i64 %409
  %450 = load i64, ptr %449, align 8
  %451 = icmp eq i64 %450, 1
  br label %452

452:                                              ; preds = %447, %445
  %453 = phi i1 [ true, %445 ], [ %451, %447 ]
  %454 = zext i1 %453 to i32
  br label %455

455:                                              ; preds = %452, %438
  %456 = phi i32 [ %454, %452 ], [ %443, %438 ]
  %457 = select i1 %442, double %411, double %439
  br label %458

458:                                              ; preds = %434, %455
  %459 = phi double [ %457, %455 ], [ %411, %434 ]
  %460 = phi i32 [ %456, %455 ], [ %410, %434 ]
  %461 = add nuw nsw i64 %409, 1
  %462 = icmp eq i64 %461, %13
  br i1 %462, label %404, label %408, !llvm.loop !10

463:                                              ; preds = %404
  %464 = load ptr, ptr %139, align 8
  %465 = load ptr, ptr %140, align 8
  %466 = insertelement <8 x double> poison, double %405, i64 0
  %467 = shufflevector <8 x double> %466, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %467, ptr %465, align 8
  %468 = load ptr, ptr %9, align 8
  %469 = load ptr, ptr %141, align 8
  %470 = load i64, ptr %142, align 8
  %471 = load ptr, ptr %0, align 8
  %472 = getelementptr inbounds i8, ptr %471, i64 24
  %473 = load i64, ptr %472, align 8
  %474 = load ptr, ptr %140, align 8
  %475 = load ptr, ptr %7, align 8
  %476 = getelementptr inbounds i8, ptr %475, i64 16
  %477 = load i64, ptr %476, align 8
  tail call fastcc void @nested(ptr noundef %464, ptr noundef %468, ptr noundef %469, i64 noundef %470, i64 noundef %473, ptr noundef %474, i64 noundef %477) #8
  %478 = fmul double %405, %2
  %479 = fadd double %478, %1
  %480 = load ptr, ptr %143, align 8
  store double %479, ptr %480, align 8
  %481 = load i64, ptr %144, align 8
  %482 = icmp sgt i64 %481, 0
  br i1 %482, label %483, label %484

483:                                              ; preds = %463
  tail call fastcc void @sample(ptr noundef nonnull %7) #8
  br label %484

484:                                              ; preds = %463, %483
  %485 = load ptr, ptr %10, align 8
  %486 = load i64, ptr %485, align 8
  %487 = load ptr, ptr %145, align 8
  %488 = load ptr, ptr %139, align 8
  %489 = load ptr, ptr %146, align 8
  %490 = load ptr, ptr %147, align 8
  %491 = load ptr, ptr %26, align 8
  %492 = getelementptr inbounds i8, ptr %485, i64 8
  %493 = load i64, ptr %492, align 8
  %494 = getelementptr inbounds double, ptr %491, i64 %493
  %495 = inttoptr i64 %486 to ptr
  %496 = tail call i32 %495(ptr noundef %487, ptr noundef %488, ptr noundef %489, ptr noundef %490, ptr noundef %494) #9
  %497 = icmp slt i32 %496, 0
  br i1 %497, label %501, label %498

498:                                              ; preds = %484
  %499 = icmp ne i32 %406, 0
  %500 = select i1 %148, i1 true, i1 %499
  br i1 %500, label %602, label %506

501:                                              ; preds = %484
  %502 = load ptr, ptr %21, align 8
  %503 = getelementptr inbounds i8, ptr %502, i64 80
  store i64 %24, ptr %503, align 8
  %504 = load ptr, ptr %20, align 8
  %505 = getelementptr inbounds i8, ptr %504, i64 48
  store double 1.000000e+00, ptr %505, align 8
  br label %772

506:                                              ; preds = %498, %596
  %507 = phi i1 [ %601, %596 ], [ %500, %498 ]
  %508 = phi i64 [ %598, %596 ], [ %403, %498 ]
  %509 = phi i64 [ %599, %596 ], [ 0, %498 ]
  %510 = phi double [ %597, %596 ], [ %405, %498 ]
  %511 = getelementptr inbounds i64, ptr %17, i64 %509
  %512 = load i64, ptr %511, align 8
  %513 = getelementptr inbounds double, ptr %32, i64 %509
  %514 = load double, ptr %513, align 8
  %515 = getelementptr inbounds i64, ptr %15, i64 %509
  %516 = load i64, ptr %515, align 8
  %517 = icmp slt i64 %512, 0
  %518 = fcmp ogt double %514, 0.000000e+00
  %519 = and i1 %517, %518
  %520 = icmp sgt i64 %516, -1
  %521 = and i1 %519, %520
  br i1 %521, label %529, label %522

522:                                              ; preds = %506
  %523 = icmp sgt i64 %512, 0
  %524 = fcmp olt double %514, 0.000000e+00
  %525 = and i1 %523, %524
  br i1 %525, label %526, label %529

526:                                              ; preds = %522
  %527 = icmp slt i64 %516, 1
  %528 = zext i1 %527 to i32
  br label %529

529:                                              ; preds = %506, %522, %526
  %530 = phi i32 [ 1, %506 ], [ 0, %522 ], [ %528, %526 ]
  %531 = icmp eq i32 %530, 0
  br i1 %531, label %596, label %532

532:                                              ; preds = %529
  %533 = getelementptr inbounds double, ptr %400, i64 %509
  %534 = load double, ptr %533, align 8
  %535 = fcmp ogt double %534, 0.000000e+00
  %536 = and i1 %517, %535
  %537 = and i1 %520, %536
  br i1 %537, label %545, label %538

538:                                              ; preds = %532
  %539 = icmp sgt i64 %512, 0
  %540 = fcmp olt double %534, 0.000000e+00
  %541 = and i1 %539, %540
  br i1 %541, label %542, label %545

542:                                              ; preds = %538
  %543 = icmp slt i64 %516, 1
  %544 = zext i1 %543 to i32
  br label %545

545:                                              ; preds = %532, %538, %542
  %546 = phi i32 [ 1, %532 ], [ 0, %538 ], [ %544, %542 ]
  %547 = icmp eq i32 %546, 0
  br i1 %547, label %548, label %596

548:                                              ; preds = %545
  %549 = call fastcc double @locate(ptr noundef %0, ptr noundef nonnull %5, double noundef %1, double noundef %2, double noundef %402, double noundef %510, i64 noundef %509) #8
  %550 = fcmp ogt double %549, %402
  br i1 %550, label %551, label %553

551:                                              ; preds = %548
  %552 = getelementptr inbounds i64, ptr %19, i64 %509
  store i64 2, ptr %552, align 8
  br label %553

553:                                              ; preds = %551, %548
  %554 = phi double [ %549, %551 ], [ %510, %548 ]
  %555 = load ptr, ptr %139, align 8
  %556 = load ptr, ptr %140, align 8
  %557 = insertelement <8 x double> poison, double %554, i64 0
  %558 = shufflevector <8 x double> %557, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %558, ptr %556, align 8
  %559 = load ptr, ptr %9, align 8
  %560 = load ptr, ptr %141, align 8
  %561 = load i64, ptr %142, align 8
  %562 = load ptr, ptr %0, align 8
  %563 = getelementptr inbounds i8, ptr %562, i64 24
  %564 = load i64, ptr %563, align 8
  %565 = load ptr, ptr %140, align 8
  %566 = load ptr, ptr %7, align 8
  %567 = getelementptr inbounds i8, ptr %566, i64 16
  %568 = load i64, ptr %567, align 8
  tail call fastcc void @nested(ptr noundef %555, ptr noundef %559, ptr noundef %560, i64 noundef %561, i64 noundef %564, ptr noundef %565, i64 noundef %568) #8
  %569 = fmul double %554, %2
  %570 = fadd double %569, %1
  %571 = load ptr, ptr %143, align 8
  store double %570, ptr %571, align 8
  %572 = load i64, ptr %144, align 8
  %573 = icmp sgt i64 %572, 0
  br i1 %573, label %574, label %575

574:                                              ; preds = %553
  tail call fastcc void @sample(ptr noundef nonnull %7) #8
  br label %575

575:                                              ; preds = %553, %574
  %576 = load ptr, ptr %10, align 8
  %577 = load i64, ptr %576, align 8
  %578 = load ptr, ptr %145, align 8
  %579 = load ptr, ptr %139, align 8
  %580 = load ptr, ptr %146, align 8
  %581 = load ptr, ptr %147, align 8
  %582 = load ptr, ptr %26, align 8
  %583 = getelementptr inbounds i8, ptr %576, i64 8
  %584 = load i64, ptr %583, align 8
  %585 = getelementptr inbounds double, ptr %582, i64 %584
  %586 = inttoptr i64 %577 to ptr
  %587 = tail call i32 %586(ptr noundef %578, ptr noundef %579, ptr noundef %580, ptr noundef %581, ptr noundef %585) #9
  %588 = icmp sgt i32 %587, -1
  br i1 %588, label %594, label %589

589:                                              ; preds = %575
  %590 = load ptr, ptr %21, align 8
  %591 = getelementptr inbounds i8, ptr %590, i64 80
  store i64 %24, ptr %591, align 8
  %592 = load ptr, ptr %20, align 8
  %593 = getelementptr inbounds i8, ptr %592, i64 48
  store double 1.000000e+00, ptr %593, align 8
  br label %594

594:                                              ; preds = %575, %589
  %595 = phi i64 [ -4, %589 ], [ %508, %575 ]
  br i1 %588, label %596, label %602

596:                                              ; preds = %529, %545, %594
  %597 = phi double [ %510, %545 ], [ %554, %594 ], [ %510, %529 ]
  %598 = phi i64 [ %508, %545 ], [ %595, %594 ], [ %508, %529 ]
  %599 = add nuw nsw i64 %509, 1
  %600 = icmp sge i64 %599, %13
  %601 = select i1 %600, i1 true, i1 %499
  br i1 %601, label %602, label %506, !llvm.loop !11

602:                                              ; preds = %594, %596, %498
  %603 = phi i1 [ %500, %498 ], [ %507, %594 ], [ %601, %596 ]
  %604 = phi double [ %405, %498 ], [ %554, %594 ], [ %597, %596 ]
  %605 = phi i32 [ 13, %498 ], [ 1, %594 ], [ 13, %596 ]
  %606 = phi i64 [ %403, %498 ], [ %595, %594 ], [ %598, %596 ]
  br i1 %603, label %607, label %772

607:                                              ; preds = %602
  br i1 %149, label %618, label %610

608:                                              ; preds = %705
  %609 = zext i1 %706 to i32
  br label %610

610:                                              ; preds = %608, %607
  %611 = phi i32 [ 0, %607 ], [ %609, %608 ]
  %612 = phi i64 [ -1, %607 ], [ %695, %608 ]
  %613 = icmp eq i32 %611, 0
  br i1 %613, label %614, label %709

614:                                              ; preds = %610
  br i1 %152, label %615, label %710

615:                                              ; preds = %614
  %616 = fmul double %604, %2
  %617 = fadd double %616, %1
  br label %713

618:                                              ; preds = %607, %705
  %619 = phi i64 [ %707, %705 ], [ 0, %607 ]
  %620 = phi i64 [ %695, %705 ], [ -1, %607 ]
  %621 = phi i1 [ %706, %705 ], [ false, %607 ]
  %622 = getelementptr inbounds double, ptr %32, i64 %619
  %623 = load double, ptr %622, align 8
  %624 = getelementptr inbounds i64, ptr %17, i64 %619
  %625 = load i64, ptr %624, align 8
  %626 = getelementptr inbounds i64, ptr %15, i64 %619
  %627 = load i64, ptr %626, align 8
  %628 = icmp slt i64 %625, 0
  %629 = fcmp ogt double %623, 0.000000e+00
  %630 = and i1 %629, %628
  %631 = icmp sgt i64 %627, -1
  %632 = and i1 %630, %631
  br i1 %632, label %640, label %633

633:                                              ; preds = %618
  %634 = icmp sgt i64 %625, 0
  %635 = fcmp olt double %623, 0.000000e+00
  %636 = and i1 %635, %634
  br i1 %636, label %637, label %640

637:                                              ; preds = %633
  %638 = icmp slt i64 %627, 1
  %639 = zext i1 %638 to i32
  br label %640

640:                                              ; preds = %618, %633, %637
  %641 = phi i32 [ 1, %618 ], [ 0, %633 ], [ %639, %637 ]
  %642 = icmp eq i32 %641, 0
  br i1 %642, label %643, label %668

643:                                              ; preds = %640
  %644 = getelementptr inbounds double, ptr %400, i64 %619
  %645 = load double, ptr %644, align 8
  %646 = fcmp ogt double %645, 0.000000e+00
  %647 = and i1 %628, %646
  %648 = and i1 %631, %647
  br i1 %648, label %656, label %649

649:                                              ; preds = %643
  %650 = icmp sgt i64 %625, 0
  %651 = fcmp olt double %645, 0.000000e+00
  %652 = and i1 %650, %651
  br i1 %652, label %653, label %656

653:                                              ; preds = %649
  %654 = icmp slt i64 %627, 1
  %655 = zext i1 %654 to i32
  br label %656

656:                                              ; preds = %643, %649, %653
  %657 = phi i32 [ 1, %643 ], [ 0, %649 ], [ %655, %653 ]
  %658 = icmp eq i32 %657, 0
  br i1 %658, label %668, label %659

659:                                              ; preds = %656
  %660 = fcmp oeq double %623, 0.000000e+00
  br i1 %660, label %665, label %661

661:                                              ; preds = %659
  %662 = getelementptr inbounds i64, ptr %19, i64 %619
  %663 = load i64, ptr %662, align 8
  %664 = icmp eq i64 %663, 1
  br label %665

665:                                              ; preds = %661, %659
  %666 = phi i1 [ true, %659 ], [ %664, %661 ]
  %667 = zext i1 %666 to i32
  br label %668

668:                                              ; preds = %665, %656, %640
  %669 = phi i32 [ 1, %640 ], [ %667, %665 ], [ 0, %656 ]
  %670 = icmp eq i32 %669, 0
  br i1 %670, label %671, label %677

671:                                              ; preds = %668
  %672 = getelementptr inbounds i64, ptr %19, i64 %619
  %673 = load i64, ptr %672, align 8
  %674 = icmp eq i64 %673, 2
  %675 = fcmp oeq double %623, 0.000000e+00
  %676 = and i1 %675, %674
  br label %677

677:                                              ; preds = %671, %668
  %678 = phi i1 [ true, %668 ], [ %676, %671 ]
  br i1 %678, label %694, label %679

679:                                              ; preds = %677
  %680 = getelementptr inbounds double, ptr %400, i64 %619
  %681 = load double, ptr %680, align 8
  %682 = icmp eq i64 %625, 0
  %683 = fcmp ord double %681, 0.000000e+00
  %684 = or i1 %682, %683
  br i1 %684, label %694, label %685

685:                                              ; preds = %679
  %686 = sitofp i64 %625 to double
  %687 = fmul double %623, %686
  %688 = fcmp olt double %687, 0.000000e+00
  br i1 %688, label %689, label %691

689:                                              ; preds = %685
  %690 = sub nsw i64 0, %625
  store i64 %690, ptr %624, align 8
  br label %694

691:                                              ; preds = %685
  %692 = fcmp ueq double %623, 0.000000e+00
  %693 = select i1 %692, i64 %619, i64 %620
  br label %694

694:                                              ; preds = %691, %689, %679, %677
  %695 = phi i64 [ %620, %677 ], [ %620, %689 ], [ %620, %679 ], [ %693, %691 ]
  %696 = zext i1 %678 to i64
  %697 = getelementptr inbounds i64, ptr %19, i64 %619
  store i64 %696, ptr %697, align 8
  %698 = xor i1 %678, true
  %699 = or i1 %621, %698
  br i1 %699, label %705, label %700

700:                                              ; preds = %694
  %701 = load ptr, ptr %150, align 8
  %702 = getelementptr inbounds i64, ptr %701, i64 %619
  %703 = load i64, ptr %702, align 8
  %704 = icmp eq i64 %703, 1
  br label %705

705:                                              ; preds = %694, %700
  %706 = phi i1 [ %621, %694 ], [ %704, %700 ]
  %707 = add nuw nsw i64 %619, 1
  %708 = icmp eq i64 %707, %13
  br i1 %708, label %608, label %618, !llvm.loop !12

709:                                              ; preds = %610
  store double %604, ptr %151, align 8
  br label %772

710:                                              ; preds = %753, %614
  %711 = icmp sgt i64 %612, -1
  br i1 %711, label %712, label %764

712:                                              ; preds = %710
  br i1 %160, label %757, label %756

713:                                              ; preds = %615, %753
  %714 = phi i64 [ 0, %615 ], [ %754, %753 ]
  %715 = getelementptr inbounds i64, ptr %19, i64 %714
  %716 = load i64, ptr %715, align 8
  %717 = icmp eq i64 %716, 0
  br i1 %717, label %753, label %718

718:                                              ; preds = %713
  %719 = load ptr, ptr %21, align 8
  %720 = getelementptr inbounds i8, ptr %719, i64 80
  %721 = load i64, ptr %720, align 8
  %722 = load ptr, ptr %7, align 8
  %723 = getelementptr inbounds i8, ptr %722, i64 8
  %724 = load i64, ptr %723, align 8
  %725 = load i64, ptr %153, align 8
  %726 = icmp eq i64 %725, 0
  br i1 %726, label %749, label %727

727:                                              ; preds = %718
  %728 = load ptr, ptr %154, align 8
  %729 = getelementptr inbounds double, ptr %728, i64 %721
  store double %617, ptr %729, align 8
  %730 = load ptr, ptr %155, align 8
  %731 = getelementptr inbounds i64, ptr %730, i64 %721
  store i64 %714, ptr %731, align 8
  %732 = icmp sgt i64 %724, 0
  br i1 %732, label %737, label %733

733:                                              ; preds = %737, %727
  %734 = add nsw i64 %721, 1
  %735 = load ptr, ptr %21, align 8
  %736 = getelementptr inbounds i8, ptr %735, i64 80
  store i64 %734, ptr %736, align 8
  br label %749

737:                                              ; preds = %727, %737
  %738 = phi i64 [ %747, %737 ], [ 0, %727 ]
  %739 = load ptr, ptr %139, align 8
  %740 = getelementptr inbounds double, ptr %739, i64 %738
  %741 = load double, ptr %740, align 8
  %742 = load ptr, ptr %156, align 8
  %743 = load i64, ptr %157, align 8
  %744 = mul nsw i64 %743, %721
  %745 = getelementptr double, ptr %742, i64 %744
  %746 = getelementptr double, ptr %745, i64 %738
  store double %741, ptr %746, align 8
  %747 = add nuw nsw i64 %738, 1
  %748 = icmp eq i64 %747, %724
  br i1 %748, label %733, label %737, !llvm.loop !13

749:                                              ; preds = %718, %733
  %750 = getelementptr inbounds i64, ptr %17, i64 %714
  %751 = load i64, ptr %750, align 8
  %752 = sub nsw i64 0, %751
  store i64 %752, ptr %750, align 8
  br label %753

753:                                              ; preds = %713, %749
  %754 = add nuw nsw i64 %714, 1
  %755 = icmp eq i64 %754, %13
  br i1 %755, label %710, label %713, !llvm.loop !14

756:                                              ; preds = %757, %712
  store double %604, ptr %161, align 8
  br label %772

757:                                              ; preds = %712, %757
  %758 = phi i64 [ %762, %757 ], [ 0, %712 ]
  %759 = icmp eq i64 %758, %612
  %760 = zext i1 %759 to i64
  %761 = getelementptr inbounds i64, ptr %19, i64 %758
  store i64 %760, ptr %761, align 8
  %762 = add nuw nsw i64 %758, 1
  %763 = icmp eq i64 %762, %13
  br i1 %763, label %756, label %757, !llvm.loop !15

764:                                              ; preds = %710
  %765 = load i64, ptr %158, align 8
  %766 = icmp sgt i64 %765, 0
  br i1 %766, label %767, label %772

767:                                              ; preds = %764
  %768 = load i64, ptr %23, align 8
  %769 = add nsw i64 %768, %13
  %770 = icmp sgt i64 %769, %765
  br i1 %770, label %771, label %772

771:                                              ; preds = %767
  store double %604, ptr %159, align 8
  br label %772

772:                                              ; preds = %709, %756, %771, %767, %764, %404, %602, %501
  %773 = phi i32 [ 1, %501 ], [ %605, %602 ], [ 8, %404 ], [ 1, %709 ], [ 1, %756 ], [ 1, %771 ], [ 0, %767 ], [ 0, %764 ]
  %774 = phi double [ %402, %501 ], [ %402, %602 ], [ %402, %404 ], [ %402, %709 ], [ %402, %756 ], [ %402, %771 ], [ %604, %767 ], [ %604, %764 ]
  %775 = phi i64 [ -4, %501 ], [ %606, %602 ], [ %403, %404 ], [ -2, %709 ], [ 21, %756 ], [ -3, %771 ], [ %606, %767 ], [ %606, %764 ]
  switch i32 %773, label %795 [
    i32 0, label %401
    i32 8, label %776
  ], !llvm.loop !16

776:                                              ; preds = %772
  br i1 %162, label %777, label %795

777:                                              ; preds = %776, %787
  %778 = phi i64 [ %788, %787 ], [ 0, %776 ]
  %779 = getelementptr inbounds double, ptr %400, i64 %778
  %780 = load double, ptr %779, align 8
  %781 = fcmp ogt double %780, 0.000000e+00
  br i1 %781, label %784, label %782

782:                                              ; preds = %777
  %783 = fcmp olt double %780, 0.000000e+00
  br i1 %783, label %784, label %787

784:                                              ; preds = %782, %777
  %785 = phi i64 [ 1, %777 ], [ -1, %782 ]
  %786 = getelementptr inbounds i64, ptr %17, i64 %778
  store i64 %785, ptr %786, align 8
  br label %787

787:                                              ; preds = %784, %782
  %788 = add nuw nsw i64 %778, 1
  %789 = icmp eq i64 %788, %13
  br i1 %789, label %795, label %777, !llvm.loop !17

790:                                              ; preds = %387, %357
  %791 = load ptr, ptr %21, align 8
  %792 = getelementptr inbounds i8, ptr %791, i64 80
  store i64 %24, ptr %792, align 8
  %793 = load ptr, ptr %20, align 8
  %794 = getelementptr inbounds i8, ptr %793, i64 48
  store double 1.000000e+00, ptr %794, align 8
  br label %795

795:                                              ; preds = %772, %787, %790, %776
  %796 = phi i32 [ 0, %776 ], [ 1, %790 ], [ 0, %787 ], [ %773, %772 ]
  %797 = phi double [ %399, %776 ], [ %166, %790 ], [ %399, %787 ], [ %774, %772 ]
  %798 = phi i64 [ %775, %776 ], [ -4, %790 ], [ %775, %787 ], [ %775, %772 ]
  %799 = icmp eq i32 %796, 0
  br i1 %799, label %800, label %805

800:                                              ; preds = %795
  %801 = fcmp oeq double %797, %169
  %802 = zext i1 %801 to i32
  %803 = add nuw nsw i32 %167, %802
  %804 = icmp ugt i32 %803, 4
  br i1 %804, label %805, label %163, !llvm.loop !18

805:                                              ; preds = %800, %795
  %806 = phi i1 [ %804, %800 ], [ %164, %795 ]
  br i1 %806, label %807, label %822

807:                                              ; preds = %805
  %808 = icmp sgt i64 %13, 0
  br i1 %808, label %809, label %812

809:                                              ; preds = %807
  %810 = shl i64 %13, 5
  %811 = getelementptr i8, ptr %29, i64 %810
  br label %815

812:                                              ; preds = %815, %807
  %813 = load double, ptr %25, align 8
  store double %813, ptr %31, align 8
  %814 = getelementptr inbounds i8, ptr %25, i64 48
  store double 1.000000e+00, ptr %814, align 8
  br label %822

815:                                              ; preds = %809, %815
  %816 = phi i64 [ 0, %809 ], [ %820, %815 ]
  %817 = getelementptr double, ptr %811, i64 %816
  %818 = load double, ptr %817, align 8
  %819 = getelementptr inbounds double, ptr %29, i64 %816
  store double %818, ptr %819, align 8
  %820 = add nuw nsw i64 %816, 1
  %821 = icmp eq i64 %820, %13
  br i1 %821, label %812, label %815, !llvm.loop !19

822:                                              ; preds = %44, %805, %112, %812
  %823 = phi i64 [ 0, %812 ], [ %798, %805 ], [ %114, %112 ], [ %46, %44 ]
  ret i64 %823
}


define internal fastcc range(i64 -6, 1) i64 @unresolved(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3) unnamed_addr #2 {
  %5 = getelementptr inbounds i8, ptr %0, i64 720
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  %7 = getelementptr inbounds i8, ptr %0, i64 984
  %8 = getelementptr inbounds i8, ptr %0, i64 1000
  %9 = load i64, ptr %8, align 8
  %10 = sdiv i64 %9, 2
  %11 = getelementptr inbounds i8, ptr %0, i64 624
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 632
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr double, ptr %12, i64 %14
  %16 = getelementptr i8, ptr %15, i64 -8
  %17 = load double, ptr %16, align 8
  %18 = load double, ptr %12, align 8
  %19 = fsub double %17, %18
  %20 = fadd double %2, %3
  %21 = tail call double @llvm.fabs.f64(double %20)
  %22 = fcmp ogt double %21, %19
  %23 = select i1 %22, double %21, double %19
  %24 = fmul double %23, 0x3D10000000000000
  %25 = fcmp ult double %24, %3
  br i1 %25, label %26, label %211

26:                                               ; preds = %4
  %27 = getelementptr inbounds i8, ptr %0, i64 888
  %28 = getelementptr inbounds i8, ptr %1, i64 16
  %29 = getelementptr inbounds i8, ptr %1, i64 8
  %30 = getelementptr inbounds i8, ptr %0, i64 168
  %31 = getelementptr inbounds i8, ptr %0, i64 248
  %32 = getelementptr inbounds i8, ptr %0, i64 168
  %33 = getelementptr inbounds i8, ptr %0, i64 192
  %34 = getelementptr inbounds i8, ptr %0, i64 1008
  br label %42

35:                                               ; preds = %72
  %36 = add nuw nsw i64 %43, 1
  %37 = icmp eq i64 %36, 9
  br i1 %37, label %38, label %42, !llvm.loop !20

38:                                               ; preds = %35
  %39 = icmp sgt i64 %9, 1
  br i1 %39, label %40, label %211

40:                                               ; preds = %38
  %41 = load ptr, ptr %7, align 8
  br label %89

42:                                               ; preds = %26, %35
  %43 = phi i64 [ 0, %26 ], [ %36, %35 ]
  %44 = getelementptr inbounds [9 x double], ptr @PLACES, i64 0, i64 %43
  %45 = load double, ptr %44, align 8
  %46 = load ptr, ptr %27, align 8
  %47 = load ptr, ptr %28, align 8
  %48 = getelementptr inbounds i8, ptr %47, i64 96
  %49 = load ptr, ptr %48, align 8
  %50 = insertelement <8 x double> poison, double %45, i64 0
  %51 = shufflevector <8 x double> %50, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %51, ptr %49, align 8
  %52 = load ptr, ptr %47, align 8
  %53 = getelementptr inbounds i8, ptr %47, i64 192
  %54 = load ptr, ptr %53, align 8
  %55 = getelementptr inbounds i8, ptr %47, i64 8
  %56 = load i64, ptr %55, align 8
  %57 = load ptr, ptr %1, align 8
  %58 = load ptr, ptr %57, align 8
  %59 = getelementptr inbounds i8, ptr %58, i64 24
  %60 = load i64, ptr %59, align 8
  %61 = load ptr, ptr %48, align 8
  %62 = load ptr, ptr %29, align 8
  %63 = load ptr, ptr %62, align 8
  %64 = getelementptr inbounds i8, ptr %63, i64 16
  %65 = load i64, ptr %64, align 8
  tail call fastcc void @nested(ptr noundef %46, ptr noundef %52, ptr noundef %54, i64 noundef %56, i64 noundef %60, ptr noundef %61, i64 noundef %65) #8
  %66 = fmul double %45, %3
  %67 = fadd double %66, %2
  %68 = load ptr, ptr %30, align 8
  store double %67, ptr %68, align 8
  %69 = load i64, ptr %31, align 8
  %70 = icmp sgt i64 %69, 0
  br i1 %70, label %71, label %72

71:                                               ; preds = %42
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %72

72:                                               ; preds = %42, %71
  %73 = load ptr, ptr %5, align 8
  %74 = getelementptr inbounds i8, ptr %73, i64 24
  %75 = load i64, ptr %74, align 8
  %76 = load ptr, ptr %32, align 8
  %77 = load ptr, ptr %27, align 8
  %78 = load ptr, ptr %33, align 8
  %79 = load ptr, ptr %34, align 8
  %80 = load ptr, ptr %7, align 8
  %81 = mul nsw i64 %9, %43
  %82 = getelementptr inbounds double, ptr %80, i64 %81
  %83 = inttoptr i64 %75 to ptr
  %84 = tail call i32 %83(ptr noundef %76, ptr noundef %77, ptr noundef %78, ptr noundef %79, ptr noundef %82) #9
  %85 = icmp slt i32 %84, 0
  br i1 %85, label %211, label %35

86:                                               ; preds = %150
  %87 = add nuw nsw i64 %91, 1
  %88 = icmp eq i64 %87, %10
  br i1 %88, label %211, label %89, !llvm.loop !21

89:                                               ; preds = %40, %86
  %90 = phi i64 [ -4, %40 ], [ %153, %86 ]
  %91 = phi i64 [ 0, %40 ], [ %87, %86 ]
  %92 = getelementptr inbounds double, ptr %41, i64 %91
  br label %154

93:                                               ; preds = %207
  %94 = fmul double %168, 0x3CE0000000000000
  %95 = fmul double %164, 0x3E50000000000000
  %96 = fcmp ogt double %208, %95
  %97 = fmul double %208, 2.000000e+00
  %98 = select i1 %96, double %97, double 0.000000e+00
  %99 = fcmp ule double %98, %94
  %100 = fmul double %98, 2.000000e+00
  %101 = fneg double %94
  br label %105

102:                                              ; preds = %147
  %103 = add nuw nsw i64 %106, 1
  %104 = icmp eq i64 %103, 9
  br i1 %104, label %150, label %105, !llvm.loop !22

105:                                              ; preds = %93, %102
  %106 = phi i64 [ 1, %93 ], [ %103, %102 ]
  %107 = phi i32 [ undef, %93 ], [ %149, %102 ]
  %108 = add nsw i64 %106, -1
  %109 = mul nsw i64 %9, %108
  %110 = getelementptr inbounds double, ptr %92, i64 %109
  %111 = load double, ptr %110, align 8
  %112 = mul nuw nsw i64 %9, %106
  %113 = getelementptr inbounds double, ptr %92, i64 %112
  %114 = load double, ptr %113, align 8
  %115 = tail call double @llvm.fabs.f64(double %111)
  %116 = tail call double @llvm.fabs.f64(double %114)
  %117 = fcmp olt double %115, %116
  %118 = select i1 %117, double %115, double %116
  %119 = fmul double %111, %114
  %120 = fcmp ult double %119, 0.000000e+00
  %121 = or i1 %99, %120
  %122 = fcmp ugt double %118, %98
  %123 = or i1 %121, %122
  br i1 %123, label %128, label %124

124:                                              ; preds = %105
  %125 = fsub double %111, %114
  %126 = tail call double @llvm.fabs.f64(double %125)
  %127 = fcmp ugt double %126, %100
  br i1 %127, label %128, label %147

128:                                              ; preds = %124, %105
  %129 = add nuw nsw i64 %106, 1
  %130 = icmp eq i64 %129, 9
  br i1 %130, label %147, label %131

131:                                              ; preds = %128
  %132 = mul nuw nsw i64 %9, %129
  %133 = getelementptr inbounds double, ptr %92, i64 %132
  %134 = load double, ptr %133, align 8
  %135 = and i64 %106, 1
  %136 = icmp eq i64 %135, 0
  %137 = fmul double %111, %134
  %138 = fcmp ult double %137, 0.000000e+00
  %139 = select i1 %136, i1 true, i1 %138
  br i1 %139, label %146, label %140

140:                                              ; preds = %131
  %141 = fadd double %111, %134
  %142 = fcmp olt double %141, 0.000000e+00
  %143 = fneg double %114
  %144 = select i1 %142, double %143, double %114
  %145 = fcmp olt double %144, %101
  br i1 %145, label %147, label %146

146:                                              ; preds = %140, %131
  br label %147

147:                                              ; preds = %146, %140, %128, %124
  %148 = phi i1 [ false, %124 ], [ false, %128 ], [ true, %146 ], [ false, %140 ]
  %149 = phi i32 [ 1, %124 ], [ 0, %128 ], [ %107, %146 ], [ 1, %140 ]
  br i1 %148, label %102, label %150

150:                                              ; preds = %102, %147
  %151 = phi i32 [ %149, %147 ], [ 0, %102 ]
  %152 = icmp eq i32 %151, 0
  %153 = select i1 %152, i64 %90, i64 -6
  br i1 %152, label %86, label %211

154:                                              ; preds = %89, %207
  %155 = phi i64 [ 0, %89 ], [ %209, %207 ]
  %156 = phi double [ 0.000000e+00, %89 ], [ %208, %207 ]
  %157 = phi double [ 0.000000e+00, %89 ], [ %168, %207 ]
  %158 = phi double [ 0.000000e+00, %89 ], [ %164, %207 ]
  %159 = mul nuw nsw i64 %9, %155
  %160 = getelementptr inbounds double, ptr %92, i64 %159
  %161 = load double, ptr %160, align 8
  %162 = tail call double @llvm.fabs.f64(double %161)
  %163 = fcmp ogt double %158, %162
  %164 = select i1 %163, double %158, double %162
  %165 = getelementptr double, ptr %160, i64 %10
  %166 = load double, ptr %165, align 8
  %167 = fcmp ogt double %157, %166
  %168 = select i1 %167, double %157, double %166
  %169 = and i64 %155, 1
  %170 = icmp eq i64 %169, 0
  br i1 %170, label %207, label %171

171:                                              ; preds = %154
  %172 = getelementptr inbounds [9 x double], ptr @PLACES, i64 0, i64 %155
  %173 = load double, ptr %172, align 8
  br label %174

174:                                              ; preds = %171, %178
  %175 = phi i64 [ 0, %171 ], [ %184, %178 ]
  %176 = phi double [ 0.000000e+00, %171 ], [ %183, %178 ]
  %177 = getelementptr inbounds [9 x double], ptr @PLACES, i64 0, i64 %175
  br label %186

178:                                              ; preds = %198
  %179 = mul nuw nsw i64 %9, %175
  %180 = getelementptr inbounds double, ptr %92, i64 %179
  %181 = load double, ptr %180, align 8
  %182 = fmul double %199, %181
  %183 = fadd double %176, %182
  %184 = add nuw nsw i64 %175, 2
  %185 = icmp ult i64 %175, 7
  br i1 %185, label %174, label %202, !llvm.loop !23

186:                                              ; preds = %174, %198
  %187 = phi i64 [ 0, %174 ], [ %200, %198 ]
  %188 = phi double [ 1.000000e+00, %174 ], [ %199, %198 ]
  %189 = icmp eq i64 %187, %175
  br i1 %189, label %198, label %190

190:                                              ; preds = %186
  %191 = getelementptr inbounds [9 x double], ptr @PLACES, i64 0, i64 %187
  %192 = load double, ptr %191, align 16
  %193 = fsub double %173, %192
  %194 = load double, ptr %177, align 16
  %195 = fsub double %194, %192
  %196 = fdiv double %193, %195
  %197 = fmul double %188, %196
  br label %198

198:                                              ; preds = %190, %186
  %199 = phi double [ %197, %190 ], [ %188, %186 ]
  %200 = add nuw nsw i64 %187, 2
  %201 = icmp ult i64 %187, 7
  br i1 %201, label %186, label %178, !llvm.loop !24

202:                                              ; preds = %178
  %203 = fsub double %161, %183
  %204 = tail call double @llvm.fabs.f64(double %203)
  %205 = fcmp ogt double %156, %204
  %206 = select i1 %205, double %156, double %204
  br label %207

207:                                              ; preds = %154, %202
  %208 = phi double [ %206, %202 ], [ %156, %154 ]
  %209 = add nuw nsw i64 %155, 1
  %210 = icmp eq i64 %209, 9
  br i1 %210, label %93, label %154, !llvm.loop !25

211:                                              ; preds = %72, %86, %150, %38, %4
  %212 = phi i64 [ 0, %4 ], [ 0, %38 ], [ %153, %150 ], [ 0, %86 ], [ -4, %72 ]
  ret i64 %212
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
  tail call fastcc void @nested(ptr noundef %30, ptr noundef %37, ptr noundef %39, i64 noundef %41, i64 noundef %45, ptr noundef %46, i64 noundef %51) #8
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
  tail call fastcc void @sample(ptr noundef nonnull %28) #8
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
  %75 = tail call i32 %74(ptr noundef %64, ptr noundef %65, ptr noundef %67, ptr noundef %69, ptr noundef %73) #9
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
  tail call fastcc void @nested(ptr noundef %87, ptr noundef %93, ptr noundef %95, i64 noundef %97, i64 noundef %101, ptr noundef %102, i64 noundef %106) #8
  %107 = fmul double %83, %3
  %108 = fadd double %107, %2
  %109 = load ptr, ptr %54, align 8
  store double %108, ptr %109, align 8
  %110 = load i64, ptr %56, align 8
  %111 = icmp sgt i64 %110, 0
  br i1 %111, label %112, label %113

112:                                              ; preds = %86
  tail call fastcc void @sample(ptr noundef nonnull %28) #8
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
  %125 = tail call i32 %124(ptr noundef %116, ptr noundef %117, ptr noundef %118, ptr noundef %119, ptr noundef %123) #9
  %126 = load double, ptr %20, align 8
  %127 = fmul double %126, %13
  %128 = fcmp ogt double %127, 0.000000e+00
  br i1 %128, label %129, label %79, !llvm.loop !26

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
  tail call fastcc void @nested(ptr noundef %146, ptr noundef %152, ptr noundef %154, i64 noundef %156, i64 noundef %160, ptr noundef %161, i64 noundef %165) #8
  %166 = fmul double %141, %3
  %167 = fadd double %166, %2
  %168 = load ptr, ptr %54, align 8
  store double %167, ptr %168, align 8
  %169 = load i64, ptr %56, align 8
  %170 = icmp sgt i64 %169, 0
  br i1 %170, label %171, label %172

171:                                              ; preds = %145
  tail call fastcc void @sample(ptr noundef nonnull %28) #8
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
  %184 = tail call i32 %183(ptr noundef %175, ptr noundef %176, ptr noundef %177, ptr noundef %178, ptr noundef %182) #9
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

declare double @llvm.fabs.f64(double) #3

define internal fastcc void @nested(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, i64 noundef %3, i64 noundef %4, ptr noundef readonly %5, i64 noundef %6) unnamed_addr #4 {
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
  br i1 %31, label %20, label %19, !llvm.loop !27

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
  br i1 %43, label %32, label %24, !llvm.loop !28
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #3

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
  br i1 %55, label %44, label %56, !llvm.loop !29

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
  br i1 %83, label %13, label %12, !llvm.loop !30
}

define internal fastcc double @least_place(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, i64 noundef %4, double noundef %5, double noundef %6, ptr noundef readonly %7) unnamed_addr #2 {
  %9 = getelementptr inbounds i8, ptr %0, i64 864
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds double, ptr %10, i64 %4
  %12 = fadd double %6, 2.500000e-01
  %13 = fadd double %12, 2.500000e-01
  %14 = load double, ptr %7, align 8
  %15 = getelementptr inbounds i8, ptr %7, i64 8
  %16 = load double, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %7, i64 16
  %18 = load double, ptr %17, align 8
  %19 = fcmp ogt double %16, %18
  %20 = select i1 %19, double %16, double %18
  %21 = fcmp ogt double %14, %20
  %22 = select i1 %21, double %14, double %20
  %23 = getelementptr inbounds i8, ptr %0, i64 720
  %24 = getelementptr inbounds i8, ptr %0, i64 888
  %25 = getelementptr inbounds i8, ptr %1, i64 16
  %26 = getelementptr inbounds i8, ptr %1, i64 8
  %27 = getelementptr inbounds i8, ptr %0, i64 168
  %28 = getelementptr inbounds i8, ptr %0, i64 248
  %29 = getelementptr inbounds i8, ptr %0, i64 144
  %30 = getelementptr inbounds i8, ptr %0, i64 168
  %31 = getelementptr inbounds i8, ptr %0, i64 192
  %32 = getelementptr inbounds i8, ptr %0, i64 744
  %33 = fmul double %22, 0xBCE0000000000000
  br label %37

34:                                               ; preds = %147
  %35 = add nuw nsw i32 %44, 1
  %36 = icmp eq i32 %35, 20
  br i1 %36, label %157, label %37, !llvm.loop !31

37:                                               ; preds = %8, %34
  %38 = phi double [ undef, %8 ], [ %156, %34 ]
  %39 = phi double [ %6, %8 ], [ %155, %34 ]
  %40 = phi double [ %12, %8 ], [ %154, %34 ]
  %41 = phi double [ %13, %8 ], [ %153, %34 ]
  %42 = phi double [ %14, %8 ], [ %152, %34 ]
  %43 = phi double [ %16, %8 ], [ %151, %34 ]
  %44 = phi i32 [ 0, %8 ], [ %35, %34 ]
  %45 = phi double [ %18, %8 ], [ %149, %34 ]
  %46 = phi double [ 0x7FF0000000000000, %8 ], [ %148, %34 ]
  %47 = fsub double %43, %42
  %48 = fsub double %40, %39
  %49 = fdiv double %47, %48
  %50 = fsub double %45, %43
  %51 = fsub double %41, %40
  %52 = fdiv double %50, %51
  %53 = fsub double %52, %49
  %54 = fsub double %41, %39
  %55 = fdiv double %53, %54
  %56 = fmul double %48, %55
  %57 = fadd double %49, %56
  %58 = fmul double %57, 5.000000e-01
  %59 = fdiv double %58, %55
  %60 = fsub double %40, %59
  %61 = fcmp ogt double %55, 0.000000e+00
  br i1 %61, label %62, label %147

62:                                               ; preds = %37
  %63 = fsub double %60, %40
  %64 = fmul double %58, %63
  %65 = fadd double %43, %64
  %66 = fmul double %46, 2.000000e+00
  %67 = fcmp ugt double %65, %66
  br i1 %67, label %147, label %68

68:                                               ; preds = %62
  %69 = fcmp ugt double %60, %39
  br i1 %69, label %70, label %72

70:                                               ; preds = %68
  %71 = fcmp ult double %60, %41
  br i1 %71, label %76, label %72

72:                                               ; preds = %70, %68
  %73 = phi double [ %41, %70 ], [ %39, %68 ]
  %74 = fadd double %40, %73
  %75 = fmul double %74, 5.000000e-01
  br label %76

76:                                               ; preds = %72, %70
  %77 = phi double [ %75, %72 ], [ %60, %70 ]
  %78 = fsub double %77, %40
  %79 = fmul double %55, %78
  %80 = fadd double %57, %79
  %81 = fmul double %78, %80
  %82 = fadd double %43, %81
  %83 = fcmp ule double %77, %39
  %84 = fcmp uge double %77, %41
  %85 = or i1 %83, %84
  %86 = fcmp oeq double %77, %40
  %87 = or i1 %85, %86
  br i1 %87, label %147, label %88

88:                                               ; preds = %76
  %89 = load ptr, ptr %24, align 8
  %90 = load ptr, ptr %25, align 8
  %91 = getelementptr inbounds i8, ptr %90, i64 96
  %92 = load ptr, ptr %91, align 8
  %93 = insertelement <8 x double> poison, double %77, i64 0
  %94 = shufflevector <8 x double> %93, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %94, ptr %92, align 8
  %95 = load ptr, ptr %90, align 8
  %96 = getelementptr inbounds i8, ptr %90, i64 192
  %97 = load ptr, ptr %96, align 8
  %98 = getelementptr inbounds i8, ptr %90, i64 8
  %99 = load i64, ptr %98, align 8
  %100 = load ptr, ptr %1, align 8
  %101 = load ptr, ptr %100, align 8
  %102 = getelementptr inbounds i8, ptr %101, i64 24
  %103 = load i64, ptr %102, align 8
  %104 = load ptr, ptr %91, align 8
  %105 = load ptr, ptr %26, align 8
  %106 = load ptr, ptr %105, align 8
  %107 = getelementptr inbounds i8, ptr %106, i64 16
  %108 = load i64, ptr %107, align 8
  tail call fastcc void @nested(ptr noundef %89, ptr noundef %95, ptr noundef %97, i64 noundef %99, i64 noundef %103, ptr noundef %104, i64 noundef %108) #8
  %109 = fmul double %77, %3
  %110 = fadd double %109, %2
  %111 = load ptr, ptr %27, align 8
  store double %110, ptr %111, align 8
  %112 = load i64, ptr %28, align 8
  %113 = icmp sgt i64 %112, 0
  br i1 %113, label %114, label %115

114:                                              ; preds = %88
  tail call fastcc void @sample(ptr noundef nonnull %29) #8
  br label %115

115:                                              ; preds = %88, %114
  %116 = load ptr, ptr %23, align 8
  %117 = load i64, ptr %116, align 8
  %118 = load ptr, ptr %30, align 8
  %119 = load ptr, ptr %24, align 8
  %120 = load ptr, ptr %31, align 8
  %121 = load ptr, ptr %32, align 8
  %122 = load ptr, ptr %9, align 8
  %123 = inttoptr i64 %117 to ptr
  %124 = tail call i32 %123(ptr noundef %118, ptr noundef %119, ptr noundef %120, ptr noundef %121, ptr noundef %122) #9
  %125 = icmp slt i32 %124, 0
  br i1 %125, label %147, label %126

126:                                              ; preds = %115
  %127 = load double, ptr %11, align 8
  %128 = fmul double %127, %5
  %129 = fcmp olt double %128, 0.000000e+00
  br i1 %129, label %130, label %133

130:                                              ; preds = %126
  %131 = fcmp olt double %128, %33
  %132 = select i1 %131, double %77, double 2.000000e+00
  br label %147

133:                                              ; preds = %126
  %134 = fsub double %128, %82
  %135 = tail call double @llvm.fabs.f64(double %134)
  %136 = fcmp uge double %77, %40
  %137 = fcmp ugt double %128, %43
  %138 = or i1 %136, %137
  br i1 %138, label %139, label %147

139:                                              ; preds = %133
  br i1 %136, label %140, label %147

140:                                              ; preds = %139
  %141 = select i1 %137, double %128, double %45
  %142 = select i1 %137, double %43, double %128
  %143 = select i1 %137, double %42, double %43
  %144 = select i1 %137, double %77, double %41
  %145 = select i1 %137, double %40, double %77
  %146 = select i1 %137, double %39, double %40
  br label %147

147:                                              ; preds = %76, %115, %133, %139, %140, %130, %37, %62
  %148 = phi double [ %46, %62 ], [ %46, %37 ], [ %46, %76 ], [ %46, %115 ], [ %46, %130 ], [ %135, %140 ], [ %135, %139 ], [ %135, %133 ]
  %149 = phi double [ %45, %62 ], [ %45, %37 ], [ %45, %76 ], [ %45, %115 ], [ %45, %130 ], [ %141, %140 ], [ %45, %139 ], [ %43, %133 ]
  %150 = phi i1 [ false, %62 ], [ false, %37 ], [ false, %76 ], [ false, %115 ], [ false, %130 ], [ true, %140 ], [ true, %139 ], [ true, %133 ]
  %151 = phi double [ %43, %62 ], [ %43, %37 ], [ %43, %76 ], [ %43, %115 ], [ %43, %130 ], [ %142, %140 ], [ %43, %139 ], [ %128, %133 ]
  %152 = phi double [ %42, %62 ], [ %42, %37 ], [ %42, %76 ], [ %42, %115 ], [ %42, %130 ], [ %143, %140 ], [ %128, %139 ], [ %42, %133 ]
  %153 = phi double [ %41, %62 ], [ %41, %37 ], [ %41, %76 ], [ %41, %115 ], [ %41, %130 ], [ %144, %140 ], [ %41, %139 ], [ %40, %133 ]
  %154 = phi double [ %40, %62 ], [ %40, %37 ], [ %40, %76 ], [ %40, %115 ], [ %40, %130 ], [ %145, %140 ], [ %40, %139 ], [ %77, %133 ]
  %155 = phi double [ %39, %62 ], [ %39, %37 ], [ %39, %76 ], [ %39, %115 ], [ %39, %130 ], [ %146, %140 ], [ %77, %139 ], [ %39, %133 ]
  %156 = phi double [ 2.000000e+00, %62 ], [ 2.000000e+00, %37 ], [ 2.000000e+00, %76 ], [ -4.000000e+00, %115 ], [ %132, %130 ], [ %38, %140 ], [ %38, %139 ], [ %38, %133 ]
  br i1 %150, label %34, label %157

157:                                              ; preds = %34, %147
  %158 = phi double [ %156, %147 ], [ 2.000000e+00, %34 ]
  ret double %158
}

declare i64 @llvm.smin.i64(i64, i64) #6

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { nounwind willreturn memory(none) }
attributes #4 = { noinline nounwind }
attributes #5 = { noinline nounwind }
attributes #6 = { nounwind willreturn memory(none) }
attributes #7 = { nounwind }
attributes #8 = { nounwind }
attributes #9 = { nounwind }


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
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5}
!14 = distinct !{!14, !4, !5}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !5}
!17 = distinct !{!17, !4, !5}
!18 = distinct !{!18, !4, !5}
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !4, !5}
!21 = distinct !{!21, !4, !5}
!22 = distinct !{!22, !4, !5}
!23 = distinct !{!23, !4, !5}
!24 = distinct !{!24, !4, !5}
!25 = distinct !{!25, !4, !5}
!26 = distinct !{!26, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5}
!29 = distinct !{!29, !4, !5}
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
