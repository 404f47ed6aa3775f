; sources 7fcff398ff6b7e1d9d6a1d7fd6e531a42053e5a6565b6a72b25b1bda2c022529
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

@PLACES = internal unnamed_addr constant [5 x double] [double 0.000000e+00, double 0x3FCE3779B97F4A7C, double 0x3FDCC470A0490974, double 0x3FE76CF5D0B09954, double 1.000000e+00], align 16

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
  %17 = getelementptr inbounds i8, ptr %0, i64 888
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 576
  %20 = getelementptr inbounds i8, ptr %0, i64 600
  %21 = load ptr, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %21, i64 80
  %23 = load i64, ptr %22, align 8
  %24 = load ptr, ptr %19, align 8
  %25 = getelementptr inbounds i8, ptr %0, i64 912
  %26 = load ptr, ptr %25, align 8
  %27 = shl nsw i64 %12, 4
  %28 = getelementptr inbounds i8, ptr %26, i64 %27
  %29 = mul i64 %12, 88
  %30 = getelementptr inbounds i8, ptr %26, i64 %29
  %31 = getelementptr inbounds double, ptr %26, i64 %12
  %32 = load double, ptr %30, align 8
  %33 = fcmp oeq double %32, %1
  %34 = getelementptr inbounds i8, ptr %0, i64 960
  %35 = getelementptr inbounds i8, ptr %0, i64 408
  %36 = getelementptr inbounds i8, ptr %0, i64 504
  %37 = getelementptr inbounds i8, ptr %0, i64 320
  %38 = getelementptr inbounds i8, ptr %0, i64 168
  %39 = getelementptr inbounds i8, ptr %0, i64 248
  %40 = getelementptr inbounds i8, ptr %0, i64 168
  %41 = getelementptr inbounds i8, ptr %0, i64 192
  %42 = getelementptr inbounds i8, ptr %0, i64 744
  %43 = zext i1 %33 to i64
  br label %47

44:                                               ; preds = %72
  %45 = add nuw nsw i64 %48, 1
  %46 = icmp eq i64 %45, 5
  br i1 %46, label %91, label %47, !llvm.loop !3

47:                                               ; preds = %3, %44
  %48 = phi i64 [ %43, %3 ], [ %45, %44 ]
  %49 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = add nuw nsw i64 %48, 2
  %52 = load ptr, ptr %34, align 8
  %53 = load ptr, ptr %35, align 8
  %54 = insertelement <8 x double> poison, double %50, i64 0
  %55 = shufflevector <8 x double> %54, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %55, ptr %53, align 8
  %56 = load ptr, ptr %8, align 8
  %57 = load ptr, ptr %36, align 8
  %58 = load i64, ptr %37, align 8
  %59 = load ptr, ptr %0, align 8
  %60 = getelementptr inbounds i8, ptr %59, i64 24
  %61 = load i64, ptr %60, align 8
  %62 = load ptr, ptr %35, align 8
  %63 = load ptr, ptr %6, align 8
  %64 = getelementptr inbounds i8, ptr %63, i64 16
  %65 = load i64, ptr %64, align 8
  tail call fastcc void @nested(ptr noundef %52, ptr noundef %56, ptr noundef %57, i64 noundef %58, i64 noundef %61, ptr noundef %62, i64 noundef %65) #8
  %66 = fmul double %50, %2
  %67 = fadd double %66, %1
  %68 = load ptr, ptr %38, align 8
  store double %67, ptr %68, align 8
  %69 = load i64, ptr %39, align 8
  %70 = icmp sgt i64 %69, 0
  br i1 %70, label %71, label %72

71:                                               ; preds = %47
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %72

72:                                               ; preds = %47, %71
  %73 = load ptr, ptr %9, align 8
  %74 = load i64, ptr %73, align 8
  %75 = load ptr, ptr %40, align 8
  %76 = load ptr, ptr %34, align 8
  %77 = load ptr, ptr %41, align 8
  %78 = load ptr, ptr %42, align 8
  %79 = load ptr, ptr %25, align 8
  %80 = getelementptr inbounds i8, ptr %73, i64 8
  %81 = load i64, ptr %80, align 8
  %82 = mul nsw i64 %81, %51
  %83 = getelementptr inbounds double, ptr %79, i64 %82
  %84 = inttoptr i64 %74 to ptr
  %85 = tail call i32 %84(ptr noundef %75, ptr noundef %76, ptr noundef %77, ptr noundef %78, ptr noundef %83) #9
  %86 = icmp slt i32 %85, 0
  br i1 %86, label %87, label %44

87:                                               ; preds = %72
  %88 = load ptr, ptr %20, align 8
  %89 = getelementptr inbounds i8, ptr %88, i64 80
  store i64 %23, ptr %89, align 8
  %90 = load ptr, ptr %19, align 8
  br label %1062

91:                                               ; preds = %44
  %92 = call fastcc i64 @resolve(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2) #8
  switch i64 %92, label %1066 [
    i64 0, label %97
    i64 -4, label %93
  ]

93:                                               ; preds = %91
  %94 = load ptr, ptr %20, align 8
  %95 = getelementptr inbounds i8, ptr %94, i64 80
  store i64 %23, ptr %95, align 8
  %96 = load ptr, ptr %19, align 8
  br label %1062

97:                                               ; preds = %91
  store double 0x7FF8000000000000, ptr %30, align 8
  %98 = getelementptr inbounds i8, ptr %0, i64 792
  %99 = getelementptr inbounds i8, ptr %0, i64 960
  %100 = load ptr, ptr %7, align 8
  %101 = getelementptr inbounds i8, ptr %100, i64 96
  %102 = getelementptr inbounds i8, ptr %100, i64 192
  %103 = getelementptr inbounds i8, ptr %100, i64 8
  %104 = load ptr, ptr %4, align 8
  %105 = load ptr, ptr %5, align 8
  %106 = getelementptr inbounds i8, ptr %0, i64 168
  %107 = getelementptr inbounds i8, ptr %0, i64 248
  %108 = getelementptr inbounds i8, ptr %0, i64 168
  %109 = getelementptr inbounds i8, ptr %0, i64 192
  %110 = getelementptr inbounds i8, ptr %0, i64 744
  %111 = getelementptr inbounds i8, ptr %0, i64 960
  %112 = load ptr, ptr %7, align 8
  %113 = getelementptr inbounds i8, ptr %112, i64 96
  %114 = getelementptr inbounds i8, ptr %112, i64 192
  %115 = getelementptr inbounds i8, ptr %112, i64 8
  %116 = load ptr, ptr %4, align 8
  %117 = load ptr, ptr %5, align 8
  %118 = getelementptr inbounds i8, ptr %0, i64 168
  %119 = getelementptr inbounds i8, ptr %0, i64 248
  %120 = getelementptr inbounds i8, ptr %0, i64 168
  %121 = getelementptr inbounds i8, ptr %0, i64 192
  %122 = getelementptr inbounds i8, ptr %0, i64 744
  %123 = icmp sgt i64 %12, 0
  %124 = getelementptr inbounds i8, ptr %0, i64 792
  %125 = getelementptr inbounds i8, ptr %0, i64 960
  %126 = load ptr, ptr %7, align 8
  %127 = getelementptr inbounds i8, ptr %126, i64 96
  %128 = getelementptr inbounds i8, ptr %126, i64 192
  %129 = getelementptr inbounds i8, ptr %126, i64 8
  %130 = load ptr, ptr %4, align 8
  %131 = load ptr, ptr %5, align 8
  %132 = getelementptr inbounds i8, ptr %0, i64 168
  %133 = getelementptr inbounds i8, ptr %0, i64 248
  %134 = getelementptr inbounds i8, ptr %0, i64 168
  %135 = getelementptr inbounds i8, ptr %0, i64 192
  %136 = getelementptr inbounds i8, ptr %0, i64 744
  %137 = icmp slt i64 %12, 1
  %138 = icmp sgt i64 %12, 0
  %139 = getelementptr inbounds i8, ptr %0, i64 792
  %140 = getelementptr inbounds i8, ptr %24, i64 48
  %141 = getelementptr inbounds i8, ptr %0, i64 624
  %142 = getelementptr inbounds i8, ptr %0, i64 632
  %143 = fadd double %1, %2
  %144 = tail call double @llvm.fabs.f64(double %143)
  %145 = getelementptr inbounds i8, ptr %0, i64 944
  %146 = getelementptr inbounds i8, ptr %0, i64 936
  %147 = icmp sgt i64 %12, 0
  %148 = getelementptr inbounds i8, ptr %0, i64 992
  %149 = getelementptr inbounds i8, ptr %0, i64 984
  %150 = getelementptr inbounds i8, ptr %0, i64 1008
  %151 = getelementptr inbounds i8, ptr %0, i64 1032
  %152 = getelementptr inbounds i8, ptr %0, i64 1048
  %153 = getelementptr inbounds i8, ptr %0, i64 624
  %154 = getelementptr inbounds i8, ptr %0, i64 632
  %155 = fadd double %1, %2
  %156 = tail call double @llvm.fabs.f64(double %155)
  %157 = getelementptr inbounds i8, ptr %0, i64 944
  %158 = getelementptr inbounds i8, ptr %0, i64 936
  %159 = getelementptr inbounds i8, ptr %0, i64 992
  %160 = getelementptr inbounds i8, ptr %24, i64 48
  %161 = icmp sgt i64 %12, 0
  %162 = getelementptr inbounds i8, ptr %24, i64 48
  %163 = icmp sgt i64 %12, 0
  %164 = getelementptr inbounds i8, ptr %0, i64 944
  %165 = getelementptr inbounds i8, ptr %0, i64 936
  br label %166

166:                                              ; preds = %97, %1041
  %167 = phi i1 [ false, %97 ], [ %1045, %1041 ]
  %168 = phi i64 [ -4, %97 ], [ %1039, %1041 ]
  %169 = phi double [ 0.000000e+00, %97 ], [ %1038, %1041 ]
  %170 = phi i32 [ 1, %97 ], [ %1044, %1041 ]
  %171 = zext nneg i32 %170 to i64
  %172 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %171
  %173 = load double, ptr %172, align 8
  %174 = mul nsw i64 %12, %171
  %175 = load ptr, ptr %9, align 8
  %176 = getelementptr inbounds i8, ptr %175, i64 8
  %177 = load i64, ptr %176, align 8
  %178 = load ptr, ptr %25, align 8
  %179 = add nuw nsw i32 %170, 2
  %180 = zext nneg i32 %179 to i64
  %181 = mul nsw i64 %177, %180
  %182 = getelementptr inbounds double, ptr %178, i64 %181
  %183 = icmp sgt i64 %177, 0
  br i1 %183, label %184, label %311

184:                                              ; preds = %166
  %185 = add nsw i32 %170, -1
  %186 = icmp ugt i32 %170, 1
  %187 = select i1 %186, i32 %185, i32 1
  %188 = icmp sle i32 %187, %170
  %189 = icmp slt i32 %187, 4
  %190 = and i1 %188, %189
  %191 = zext nneg i32 %170 to i64
  %192 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %191
  %193 = tail call i32 @llvm.smin.i32(i32 %170, i32 3)
  br label %194

194:                                              ; preds = %184, %308
  %195 = phi double [ 2.000000e+00, %184 ], [ %307, %308 ]
  %196 = phi i64 [ 0, %184 ], [ %309, %308 ]
  %197 = phi double [ 2.000000e+00, %184 ], [ %305, %308 ]
  %198 = load ptr, ptr %15, align 8
  %199 = getelementptr inbounds i64, ptr %198, i64 %196
  %200 = load i64, ptr %199, align 8
  %201 = sitofp i64 %200 to double
  br i1 %190, label %202, label %304

202:                                              ; preds = %194
  %203 = getelementptr inbounds double, ptr %178, i64 %196
  br label %204

204:                                              ; preds = %202, %301
  %205 = phi i32 [ %187, %202 ], [ %302, %301 ]
  %206 = phi double [ %195, %202 ], [ %300, %301 ]
  %207 = phi double [ %197, %202 ], [ %298, %301 ]
  %208 = call fastcc double @least_place(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, i64 noundef %196, double noundef %201, i32 noundef %205, i32 noundef %170) #8
  %209 = fcmp oeq double %208, -4.000000e+00
  br i1 %209, label %297, label %210

210:                                              ; preds = %204
  %211 = fcmp ogt double %208, %169
  br i1 %211, label %212, label %297

212:                                              ; preds = %210
  %213 = load double, ptr %192, align 8
  %214 = fcmp olt double %206, %213
  %215 = select i1 %214, double %206, double %213
  %216 = fcmp olt double %208, %215
  br i1 %216, label %219, label %297

217:                                              ; preds = %254
  %218 = fcmp ugt double %255, 1.000000e+00
  br i1 %218, label %290, label %258

219:                                              ; preds = %212, %254
  %220 = phi i64 [ %256, %254 ], [ 0, %212 ]
  %221 = phi double [ %255, %254 ], [ %207, %212 ]
  %222 = load ptr, ptr %98, align 8
  %223 = getelementptr inbounds i64, ptr %222, i64 %220
  %224 = load i64, ptr %223, align 8
  %225 = icmp eq i64 %224, 1
  br i1 %225, label %226, label %254

226:                                              ; preds = %219
  %227 = load ptr, ptr %15, align 8
  %228 = getelementptr inbounds i64, ptr %227, i64 %220
  %229 = load i64, ptr %228, align 8
  %230 = getelementptr inbounds double, ptr %182, i64 %220
  %231 = load double, ptr %230, align 8
  %232 = load ptr, ptr %13, align 8
  %233 = getelementptr inbounds i64, ptr %232, i64 %220
  %234 = load i64, ptr %233, align 8
  %235 = icmp slt i64 %229, 0
  %236 = fcmp ogt double %231, 0.000000e+00
  %237 = and i1 %235, %236
  %238 = icmp sgt i64 %234, -1
  %239 = and i1 %237, %238
  br i1 %239, label %247, label %240

240:                                              ; preds = %226
  %241 = icmp sgt i64 %229, 0
  %242 = fcmp olt double %231, 0.000000e+00
  %243 = and i1 %241, %242
  br i1 %243, label %244, label %247

244:                                              ; preds = %240
  %245 = icmp slt i64 %234, 1
  %246 = zext i1 %245 to i32
  br label %247

247:                                              ; preds = %226, %240, %244
  %248 = phi i32 [ 1, %226 ], [ 0, %240 ], [ %246, %244 ]
  %249 = icmp eq i32 %248, 0
  br i1 %249, label %254, label %250

250:                                              ; preds = %247
  %251 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %169, double noundef %213, i64 noundef %220) #8
  %252 = fcmp olt double %221, %251
  %253 = select i1 %252, double %221, double %251
  br label %254

254:                                              ; preds = %250, %247, %219
  %255 = phi double [ %253, %250 ], [ %221, %247 ], [ %221, %219 ]
  %256 = add nuw nsw i64 %220, 1
  %257 = icmp eq i64 %256, %177
  br i1 %257, label %217, label %219, !llvm.loop !6

258:                                              ; preds = %217
  %259 = load ptr, ptr %99, align 8
  %260 = load ptr, ptr %101, align 8
  %261 = insertelement <8 x double> poison, double %255, i64 0
  %262 = shufflevector <8 x double> %261, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %262, ptr %260, align 8
  %263 = load ptr, ptr %100, align 8
  %264 = load ptr, ptr %102, align 8
  %265 = load i64, ptr %103, align 8
  %266 = load ptr, ptr %104, align 8
  %267 = getelementptr inbounds i8, ptr %266, i64 24
  %268 = load i64, ptr %267, align 8
  %269 = load ptr, ptr %101, align 8
  %270 = load ptr, ptr %105, align 8
  %271 = getelementptr inbounds i8, ptr %270, i64 16
  %272 = load i64, ptr %271, align 8
  tail call fastcc void @nested(ptr noundef %259, ptr noundef %263, ptr noundef %264, i64 noundef %265, i64 noundef %268, ptr noundef %269, i64 noundef %272) #8
  %273 = fmul double %255, %2
  %274 = fadd double %273, %1
  %275 = load ptr, ptr %106, align 8
  store double %274, ptr %275, align 8
  %276 = load i64, ptr %107, align 8
  %277 = icmp sgt i64 %276, 0
  br i1 %277, label %278, label %279

278:                                              ; preds = %258
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %279

279:                                              ; preds = %258, %278
  %280 = load ptr, ptr %9, align 8
  %281 = load i64, ptr %280, align 8
  %282 = load ptr, ptr %108, align 8
  %283 = load ptr, ptr %99, align 8
  %284 = load ptr, ptr %109, align 8
  %285 = load ptr, ptr %110, align 8
  %286 = load ptr, ptr %25, align 8
  %287 = inttoptr i64 %281 to ptr
  %288 = tail call i32 %287(ptr noundef %282, ptr noundef %283, ptr noundef %284, ptr noundef %285, ptr noundef %286) #9
  %289 = icmp slt i32 %288, 0
  br i1 %289, label %297, label %290

290:                                              ; preds = %279, %217
  %291 = fcmp ogt double %255, 1.000000e+00
  br i1 %291, label %296, label %292

292:                                              ; preds = %290
  %293 = load double, ptr %203, align 8
  %294 = fmul double %293, %201
  %295 = fcmp ogt double %294, 0.000000e+00
  br i1 %295, label %296, label %297

296:                                              ; preds = %292, %290
  br label %297

297:                                              ; preds = %296, %292, %279, %212, %210, %204
  %298 = phi double [ %207, %204 ], [ %207, %212 ], [ %207, %210 ], [ %255, %279 ], [ %255, %296 ], [ %255, %292 ]
  %299 = phi i32 [ 1, %204 ], [ 7, %212 ], [ 7, %210 ], [ 1, %279 ], [ 0, %296 ], [ 0, %292 ]
  %300 = phi double [ %206, %204 ], [ %206, %212 ], [ %206, %210 ], [ %206, %279 ], [ %208, %296 ], [ %206, %292 ]
  switch i32 %299, label %304 [
    i32 0, label %301
    i32 7, label %301
  ]

301:                                              ; preds = %297, %297
  %302 = add nsw i32 %205, 1
  %303 = icmp slt i32 %205, %193
  br i1 %303, label %204, label %304, !llvm.loop !7

304:                                              ; preds = %301, %297, %194
  %305 = phi double [ %197, %194 ], [ %298, %297 ], [ %298, %301 ]
  %306 = phi i32 [ 5, %194 ], [ 5, %301 ], [ %299, %297 ]
  %307 = phi double [ %195, %194 ], [ %300, %297 ], [ %300, %301 ]
  switch i32 %306, label %311 [
    i32 5, label %308
    i32 0, label %308
  ]

308:                                              ; preds = %304, %304
  %309 = add nuw nsw i64 %196, 1
  %310 = icmp eq i64 %309, %177
  br i1 %310, label %311, label %194, !llvm.loop !8

311:                                              ; preds = %304, %308, %166
  %312 = phi double [ 2.000000e+00, %166 ], [ -4.000000e+00, %304 ], [ %307, %308 ]
  %313 = fcmp olt double %312, 0.000000e+00
  br i1 %313, label %1031, label %314

314:                                              ; preds = %311
  %315 = getelementptr double, ptr %28, i64 %174
  %316 = fcmp olt double %312, %173
  br i1 %316, label %317, label %350

317:                                              ; preds = %314
  %318 = load ptr, ptr %25, align 8
  %319 = load ptr, ptr %111, align 8
  %320 = load ptr, ptr %113, align 8
  %321 = insertelement <8 x double> poison, double %312, i64 0
  %322 = shufflevector <8 x double> %321, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %322, ptr %320, align 8
  %323 = load ptr, ptr %112, align 8
  %324 = load ptr, ptr %114, align 8
  %325 = load i64, ptr %115, align 8
  %326 = load ptr, ptr %116, align 8
  %327 = getelementptr inbounds i8, ptr %326, i64 24
  %328 = load i64, ptr %327, align 8
  %329 = load ptr, ptr %113, align 8
  %330 = load ptr, ptr %117, align 8
  %331 = getelementptr inbounds i8, ptr %330, i64 16
  %332 = load i64, ptr %331, align 8
  tail call fastcc void @nested(ptr noundef %319, ptr noundef %323, ptr noundef %324, i64 noundef %325, i64 noundef %328, ptr noundef %329, i64 noundef %332) #8
  %333 = fmul double %312, %2
  %334 = fadd double %333, %1
  %335 = load ptr, ptr %118, align 8
  store double %334, ptr %335, align 8
  %336 = load i64, ptr %119, align 8
  %337 = icmp sgt i64 %336, 0
  br i1 %337, label %338, label %339

338:                                              ; preds = %317
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %339

339:                                              ; preds = %317, %338
  %340 = load ptr, ptr %9, align 8
  %341 = load i64, ptr %340, align 8
  %342 = load ptr, ptr %120, align 8
  %343 = load ptr, ptr %111, align 8
  %344 = load ptr, ptr %121, align 8
  %345 = load ptr, ptr %122, align 8
  %346 = load ptr, ptr %25, align 8
  %347 = inttoptr i64 %341 to ptr
  %348 = tail call i32 %347(ptr noundef %342, ptr noundef %343, ptr noundef %344, ptr noundef %345, ptr noundef %346) #9
  %349 = icmp slt i32 %348, 0
  br i1 %349, label %1031, label %350

350:                                              ; preds = %339, %314
  %351 = phi double [ %312, %339 ], [ %173, %314 ]
  %352 = phi ptr [ %318, %339 ], [ %315, %314 ]
  br label %353

353:                                              ; preds = %975, %350
  %354 = phi double [ %169, %350 ], [ %977, %975 ]
  %355 = phi i64 [ %168, %350 ], [ %978, %975 ]
  br i1 %123, label %360, label %356

356:                                              ; preds = %410, %353
  %357 = phi double [ 2.000000e+00, %353 ], [ %411, %410 ]
  %358 = phi i32 [ 0, %353 ], [ %412, %410 ]
  %359 = fcmp ogt double %357, 1.000000e+00
  br i1 %359, label %975, label %415

360:                                              ; preds = %353, %410
  %361 = phi i64 [ %413, %410 ], [ 0, %353 ]
  %362 = phi i32 [ %412, %410 ], [ 0, %353 ]
  %363 = phi double [ %411, %410 ], [ 2.000000e+00, %353 ]
  %364 = getelementptr inbounds i64, ptr %18, i64 %361
  store i64 0, ptr %364, align 8
  %365 = getelementptr inbounds i64, ptr %16, i64 %361
  %366 = load i64, ptr %365, align 8
  %367 = getelementptr inbounds double, ptr %352, i64 %361
  %368 = load double, ptr %367, align 8
  %369 = getelementptr inbounds i64, ptr %14, i64 %361
  %370 = load i64, ptr %369, align 8
  %371 = icmp slt i64 %366, 0
  %372 = fcmp ogt double %368, 0.000000e+00
  %373 = and i1 %371, %372
  %374 = icmp sgt i64 %370, -1
  %375 = and i1 %373, %374
  br i1 %375, label %383, label %376

376:                                              ; preds = %360
  %377 = icmp sgt i64 %366, 0
  %378 = fcmp olt double %368, 0.000000e+00
  %379 = and i1 %377, %378
  br i1 %379, label %380, label %383

380:                                              ; preds = %376
  %381 = icmp slt i64 %370, 1
  %382 = zext i1 %381 to i32
  br label %383

383:                                              ; preds = %360, %376, %380
  %384 = phi i32 [ 1, %360 ], [ 0, %376 ], [ %382, %380 ]
  %385 = icmp eq i32 %384, 0
  br i1 %385, label %386, label %390

386:                                              ; preds = %383
  %387 = icmp eq i64 %366, 0
  %388 = fcmp ord double %368, 0.000000e+00
  %389 = or i1 %387, %388
  br i1 %389, label %410, label %390

390:                                              ; preds = %386, %383
  %391 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %354, double noundef %351, i64 noundef %361) #8
  %392 = fcmp ole double %391, %354
  %393 = zext i1 %392 to i64
  store i64 %393, ptr %364, align 8
  %394 = fcmp uge double %391, %363
  %395 = select i1 %394, i32 %362, i32 0
  %396 = fcmp ugt double %391, %363
  br i1 %396, label %407, label %397

397:                                              ; preds = %390
  %398 = icmp eq i32 %395, 0
  br i1 %398, label %399, label %404

399:                                              ; preds = %397
  %400 = load ptr, ptr %124, align 8
  %401 = getelementptr inbounds i64, ptr %400, i64 %361
  %402 = load i64, ptr %401, align 8
  %403 = icmp eq i64 %402, 1
  br label %404

404:                                              ; preds = %399, %397
  %405 = phi i1 [ true, %397 ], [ %403, %399 ]
  %406 = zext i1 %405 to i32
  br label %407

407:                                              ; preds = %404, %390
  %408 = phi i32 [ %406, %404 ], [ %395, %390 ]
  %409 = select i1 %394, double %363, double %391
  br label %410

410:                                              ; preds = %386, %407
  %411 = phi double [ %409, %407 ], [ %363, %386 ]
  %412 = phi i32 [ %408, %407 ], [ %362, %386 ]
  %413 = add nuw nsw i64 %361, 1
  %414 = icmp eq i64 %413, %12
  br i1 %414, label %356, label %360, !llvm.loop !9

415:                                              ; preds = %356
  %416 = load ptr, ptr %125, align 8
  %417 = load ptr, ptr %127, align 8
  %418 = insertelement <8 x double> poison, double %357, i64 0
  %419 = shufflevector <8 x double> %418, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %419, ptr %417, align 8
  %420 = load ptr, ptr %126, align 8
  %421 = load ptr, ptr %128, align 8
  %422 = load i64, ptr %129, align 8
  %423 = load ptr, ptr %130, align 8
  %424 = getelementptr inbounds i8, ptr %423, i64 24
  %425 = load i64, ptr %424, align 8
  %426 = load ptr, ptr %127, align 8
  %427 = load ptr, ptr %131, align 8
  %428 = getelementptr inbounds i8, ptr %427, i64 16
  %429 = load i64, ptr %428, align 8
  tail call fastcc void @nested(ptr noundef %416, ptr noundef %420, ptr noundef %421, i64 noundef %422, i64 noundef %425, ptr noundef %426, i64 noundef %429) #8
  %430 = fmul double %357, %2
  %431 = fadd double %430, %1
  %432 = load ptr, ptr %132, align 8
  store double %431, ptr %432, align 8
  %433 = load i64, ptr %133, align 8
  %434 = icmp sgt i64 %433, 0
  br i1 %434, label %435, label %436

435:                                              ; preds = %415
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %436

436:                                              ; preds = %415, %435
  %437 = load ptr, ptr %9, align 8
  %438 = load i64, ptr %437, align 8
  %439 = load ptr, ptr %134, align 8
  %440 = load ptr, ptr %125, align 8
  %441 = load ptr, ptr %135, align 8
  %442 = load ptr, ptr %136, align 8
  %443 = load ptr, ptr %25, align 8
  %444 = getelementptr inbounds i8, ptr %437, i64 8
  %445 = load i64, ptr %444, align 8
  %446 = getelementptr inbounds double, ptr %443, i64 %445
  %447 = inttoptr i64 %438 to ptr
  %448 = tail call i32 %447(ptr noundef %439, ptr noundef %440, ptr noundef %441, ptr noundef %442, ptr noundef %446) #9
  %449 = icmp slt i32 %448, 0
  br i1 %449, label %453, label %450

450:                                              ; preds = %436
  %451 = icmp ne i32 %358, 0
  %452 = select i1 %137, i1 true, i1 %451
  br i1 %452, label %554, label %458

453:                                              ; preds = %436
  %454 = load ptr, ptr %20, align 8
  %455 = getelementptr inbounds i8, ptr %454, i64 80
  store i64 %23, ptr %455, align 8
  %456 = load ptr, ptr %19, align 8
  %457 = getelementptr inbounds i8, ptr %456, i64 48
  store double 1.000000e+00, ptr %457, align 8
  br label %975

458:                                              ; preds = %450, %548
  %459 = phi i1 [ %553, %548 ], [ %452, %450 ]
  %460 = phi i64 [ %550, %548 ], [ %355, %450 ]
  %461 = phi i64 [ %551, %548 ], [ 0, %450 ]
  %462 = phi double [ %549, %548 ], [ %357, %450 ]
  %463 = getelementptr inbounds i64, ptr %16, i64 %461
  %464 = load i64, ptr %463, align 8
  %465 = getelementptr inbounds double, ptr %31, i64 %461
  %466 = load double, ptr %465, align 8
  %467 = getelementptr inbounds i64, ptr %14, i64 %461
  %468 = load i64, ptr %467, align 8
  %469 = icmp slt i64 %464, 0
  %470 = fcmp ogt double %466, 0.000000e+00
  %471 = and i1 %469, %470
  %472 = icmp sgt i64 %468, -1
  %473 = and i1 %471, %472
  br i1 %473, label %481, label %474

474:                                              ; preds = %458
  %475 = icmp sgt i64 %464, 0
  %476 = fcmp olt double %466, 0.000000e+00
  %477 = and i1 %475, %476
  br i1 %477, label %478, label %481

478:                                              ; preds = %474
  %479 = icmp slt i64 %468, 1
  %480 = zext i1 %479 to i32
  br label %481

481:                                              ; preds = %458, %474, %478
  %482 = phi i32 [ 1, %458 ], [ 0, %474 ], [ %480, %478 ]
  %483 = icmp eq i32 %482, 0
  br i1 %483, label %548, label %484

484:                                              ; preds = %481
  %485 = getelementptr inbounds double, ptr %352, i64 %461
  %486 = load double, ptr %485, align 8
  %487 = fcmp ogt double %486, 0.000000e+00
  %488 = and i1 %469, %487
  %489 = and i1 %472, %488
  br i1 %489, label %497, label %490

490:                                              ; preds = %484
  %491 = icmp sgt i64 %464, 0
  %492 = fcmp olt double %486, 0.000000e+00
  %493 = and i1 %491, %492
  br i1 %493, label %494, label %497

494:                                              ; preds = %490
  %495 = icmp slt i64 %468, 1
  %496 = zext i1 %495 to i32
  br label %497

497:                                              ; preds = %484, %490, %494
  %498 = phi i32 [ 1, %484 ], [ 0, %490 ], [ %496, %494 ]
  %499 = icmp eq i32 %498, 0
  br i1 %499, label %500, label %548

500:                                              ; preds = %497
  %501 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %354, double noundef %462, i64 noundef %461) #8
  %502 = fcmp ogt double %501, %354
  br i1 %502, label %503, label %505

503:                                              ; preds = %500
  %504 = getelementptr inbounds i64, ptr %18, i64 %461
  store i64 2, ptr %504, align 8
  br label %505

505:                                              ; preds = %503, %500
  %506 = phi double [ %501, %503 ], [ %462, %500 ]
  %507 = load ptr, ptr %125, align 8
  %508 = load ptr, ptr %127, align 8
  %509 = insertelement <8 x double> poison, double %506, i64 0
  %510 = shufflevector <8 x double> %509, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %510, ptr %508, align 8
  %511 = load ptr, ptr %126, align 8
  %512 = load ptr, ptr %128, align 8
  %513 = load i64, ptr %129, align 8
  %514 = load ptr, ptr %130, align 8
  %515 = getelementptr inbounds i8, ptr %514, i64 24
  %516 = load i64, ptr %515, align 8
  %517 = load ptr, ptr %127, align 8
  %518 = load ptr, ptr %131, align 8
  %519 = getelementptr inbounds i8, ptr %518, i64 16
  %520 = load i64, ptr %519, align 8
  tail call fastcc void @nested(ptr noundef %507, ptr noundef %511, ptr noundef %512, i64 noundef %513, i64 noundef %516, ptr noundef %517, i64 noundef %520) #8
  %521 = fmul double %506, %2
  %522 = fadd double %521, %1
  %523 = load ptr, ptr %132, align 8
  store double %522, ptr %523, align 8
  %524 = load i64, ptr %133, align 8
  %525 = icmp sgt i64 %524, 0
  br i1 %525, label %526, label %527

526:                                              ; preds = %505
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %527

527:                                              ; preds = %505, %526
  %528 = load ptr, ptr %9, align 8
  %529 = load i64, ptr %528, align 8
  %530 = load ptr, ptr %134, align 8
  %531 = load ptr, ptr %125, align 8
  %532 = load ptr, ptr %135, align 8
  %533 = load ptr, ptr %136, align 8
  %534 = load ptr, ptr %25, align 8
  %535 = getelementptr inbounds i8, ptr %528, i64 8
  %536 = load i64, ptr %535, align 8
  %537 = getelementptr inbounds double, ptr %534, i64 %536
  %538 = inttoptr i64 %529 to ptr
  %539 = tail call i32 %538(ptr noundef %530, ptr noundef %531, ptr noundef %532, ptr noundef %533, ptr noundef %537) #9
  %540 = icmp sgt i32 %539, -1
  br i1 %540, label %546, label %541

541:                                              ; preds = %527
  %542 = load ptr, ptr %20, align 8
  %543 = getelementptr inbounds i8, ptr %542, i64 80
  store i64 %23, ptr %543, align 8
  %544 = load ptr, ptr %19, align 8
  %545 = getelementptr inbounds i8, ptr %544, i64 48
  store double 1.000000e+00, ptr %545, align 8
  br label %546

546:                                              ; preds = %527, %541
  %547 = phi i64 [ -4, %541 ], [ %460, %527 ]
  br i1 %540, label %548, label %554

548:                                              ; preds = %481, %497, %546
  %549 = phi double [ %462, %497 ], [ %506, %546 ], [ %462, %481 ]
  %550 = phi i64 [ %460, %497 ], [ %547, %546 ], [ %460, %481 ]
  %551 = add nuw nsw i64 %461, 1
  %552 = icmp sge i64 %551, %12
  %553 = select i1 %552, i1 true, i1 %451
  br i1 %553, label %554, label %458, !llvm.loop !10

554:                                              ; preds = %546, %548, %450
  %555 = phi i1 [ %452, %450 ], [ %459, %546 ], [ %553, %548 ]
  %556 = phi i32 [ 13, %450 ], [ 1, %546 ], [ 13, %548 ]
  %557 = phi double [ %357, %450 ], [ %506, %546 ], [ %549, %548 ]
  %558 = phi i64 [ %355, %450 ], [ %547, %546 ], [ %550, %548 ]
  br i1 %555, label %559, label %975

559:                                              ; preds = %554
  br i1 %138, label %570, label %562

560:                                              ; preds = %657
  %561 = zext i1 %658 to i32
  br label %562

562:                                              ; preds = %560, %559
  %563 = phi i32 [ 0, %559 ], [ %561, %560 ]
  %564 = phi i64 [ -1, %559 ], [ %647, %560 ]
  %565 = icmp eq i32 %563, 0
  br i1 %565, label %566, label %661

566:                                              ; preds = %562
  br i1 %147, label %567, label %787

567:                                              ; preds = %566
  %568 = fmul double %557, %2
  %569 = fadd double %568, %1
  br label %908

570:                                              ; preds = %559, %657
  %571 = phi i64 [ %659, %657 ], [ 0, %559 ]
  %572 = phi i64 [ %647, %657 ], [ -1, %559 ]
  %573 = phi i1 [ %658, %657 ], [ false, %559 ]
  %574 = getelementptr inbounds double, ptr %31, i64 %571
  %575 = load double, ptr %574, align 8
  %576 = getelementptr inbounds i64, ptr %16, i64 %571
  %577 = load i64, ptr %576, align 8
  %578 = getelementptr inbounds i64, ptr %14, i64 %571
  %579 = load i64, ptr %578, align 8
  %580 = icmp slt i64 %577, 0
  %581 = fcmp ogt double %575, 0.000000e+00
  %582 = and i1 %581, %580
  %583 = icmp sgt i64 %579, -1
  %584 = and i1 %582, %583
  br i1 %584, label %592, label %585

585:                                              ; preds = %570
  %586 = icmp sgt i64 %577, 0
  %587 = fcmp olt double %575, 0.000000e+00
  %588 = and i1 %587, %586
  br i1 %588, label %589, label %592

589:                                              ; preds = %585
  %590 = icmp slt i64 %579, 1
  %591 = zext i1 %590 to i32
  br label %592

592:                                              ; preds = %570, %585, %589
  %593 = phi i32 [ 1, %570 ], [ 0, %585 ], [ %591, %589 ]
  %594 = icmp eq i32 %593, 0
  br i1 %594, label %595, label %620

595:                                              ; preds = %592
  %596 = getelementptr inbounds double, ptr %352, i64 %571
  %597 = load double, ptr %596, align 8
  %598 = fcmp ogt double %597, 0.000000e+00
  %599 = and i1 %580, %598
  %600 = and i1 %583, %599
  br i1 %600, label %608, label %601

601:                                              ; preds = %595
  %602 = icmp sgt i64 %577, 0
  %603 = fcmp olt double %597, 0.000000e+00
  %604 = and i1 %602, %603
  br i1 %604, label %605, label %608

605:                                              ; preds = %601
  %606 = icmp slt i64 %579, 1
  %607 = zext i1 %606 to i32
  br label %608

608:                                              ; preds = %595, %601, %605
  %609 = phi i32 [ 1, %595 ], [ 0, %601 ], [ %607, %605 ]
  %610 = icmp eq i32 %609, 0
  br i1 %610, label %620, label %611

611:                                              ; preds = %608
  %612 = fcmp oeq double %575, 0.000000e+00
  br i1 %612, label %617, label %613

613:                                              ; preds = %611
  %614 = getelementptr inbounds i64, ptr %18, i64 %571
  %615 = load i64, ptr %614, align 8
  %616 = icmp eq i64 %615, 1
  br label %617

617:                                              ; preds = %613, %611
  %618 = phi i1 [ true, %611 ], [ %616, %613 ]
  %619 = zext i1 %618 to i32
  br label %620

620:                                              ; preds = %617, %608, %592
  %621 = phi i32 [ 1, %592 ], [ %619, %617 ], [ 0, %608 ]
  %622 = icmp eq i32 %621, 0
  br i1 %622, label %623, label %629

623:                                              ; preds = %620
  %624 = getelementptr inbounds i64, ptr %18, i64 %571
  %625 = load i64, ptr %624, align 8
  %626 = icmp eq i64 %625, 2
  %627 = fcmp oeq double %575, 0.000000e+00
  %628 = and i1 %627, %626
  br label %629

629:                                              ; preds = %623, %620
  %630 = phi i1 [ true, %620 ], [ %628, %623 ]
  br i1 %630, label %646, label %631

631:                                              ; preds = %629
  %632 = getelementptr inbounds double, ptr %352, i64 %571
  %633 = load double, ptr %632, align 8
  %634 = icmp eq i64 %577, 0
  %635 = fcmp ord double %633, 0.000000e+00
  %636 = or i1 %634, %635
  br i1 %636, label %646, label %637

637:                                              ; preds = %631
  %638 = sitofp i64 %577 to double
  %639 = fmul double %575, %638
  %640 = fcmp olt double %639, 0.000000e+00
  br i1 %640, label %641, label %643

641:                                              ; preds = %637
  %642 = sub nsw i64 0, %577
  store i64 %642, ptr %576, align 8
  br label %646

643:                                              ; preds = %637
  %644 = fcmp ueq double %575, 0.000000e+00
  %645 = select i1 %644, i64 %571, i64 %572
  br label %646

646:                                              ; preds = %643, %641, %631, %629
  %647 = phi i64 [ %572, %629 ], [ %572, %641 ], [ %572, %631 ], [ %645, %643 ]
  %648 = zext i1 %630 to i64
  %649 = getelementptr inbounds i64, ptr %18, i64 %571
  store i64 %648, ptr %649, align 8
  %650 = xor i1 %630, true
  %651 = or i1 %573, %650
  br i1 %651, label %657, label %652

652:                                              ; preds = %646
  %653 = load ptr, ptr %139, align 8
  %654 = getelementptr inbounds i64, ptr %653, i64 %571
  %655 = load i64, ptr %654, align 8
  %656 = icmp eq i64 %655, 1
  br label %657

657:                                              ; preds = %646, %652
  %658 = phi i1 [ %573, %646 ], [ %656, %652 ]
  %659 = add nuw nsw i64 %571, 1
  %660 = icmp eq i64 %659, %12
  br i1 %660, label %560, label %570, !llvm.loop !11

661:                                              ; preds = %562
  store double %557, ptr %140, align 8
  %662 = load ptr, ptr %9, align 8
  %663 = getelementptr inbounds i8, ptr %662, i64 8
  %664 = load i64, ptr %663, align 8
  %665 = load ptr, ptr %25, align 8
  %666 = getelementptr inbounds double, ptr %665, i64 %664
  %667 = mul i64 %664, 56
  %668 = getelementptr inbounds i8, ptr %665, i64 %667
  %669 = load ptr, ptr %141, align 8
  %670 = load i64, ptr %142, align 8
  %671 = getelementptr double, ptr %669, i64 %670
  %672 = getelementptr i8, ptr %671, i64 -8
  %673 = load double, ptr %672, align 8
  %674 = load double, ptr %669, align 8
  %675 = fsub double %673, %674
  %676 = icmp sgt i64 %664, 0
  br i1 %676, label %680, label %677

677:                                              ; preds = %693, %661
  %678 = phi i32 [ 0, %661 ], [ %695, %693 ]
  %679 = icmp eq i32 %678, 0
  br i1 %679, label %975, label %698

680:                                              ; preds = %661, %693
  %681 = phi i64 [ %696, %693 ], [ 0, %661 ]
  %682 = phi i32 [ %695, %693 ], [ 0, %661 ]
  %683 = icmp eq i32 %682, 0
  br i1 %683, label %684, label %693

684:                                              ; preds = %680
  %685 = load ptr, ptr %17, align 8
  %686 = getelementptr inbounds i64, ptr %685, i64 %681
  %687 = load i64, ptr %686, align 8
  %688 = icmp eq i64 %687, 0
  br i1 %688, label %693, label %689

689:                                              ; preds = %684
  %690 = getelementptr inbounds double, ptr %666, i64 %681
  %691 = load double, ptr %690, align 8
  %692 = fcmp oeq double %691, 0.000000e+00
  br label %693

693:                                              ; preds = %689, %684, %680
  %694 = phi i1 [ true, %680 ], [ false, %684 ], [ %692, %689 ]
  %695 = zext i1 %694 to i32
  %696 = add nuw nsw i64 %681, 1
  %697 = icmp eq i64 %696, %664
  br i1 %697, label %677, label %680, !llvm.loop !12

698:                                              ; preds = %677
  %699 = fsub double %351, %557
  %700 = fmul double %699, %2
  %701 = fcmp ogt double %144, %675
  %702 = select i1 %701, double %144, double %675
  %703 = fmul double %702, 0x3F50000000000000
  %704 = fcmp ugt double %700, %703
  br i1 %704, label %705, label %975

705:                                              ; preds = %698
  %706 = fmul double %699, 0x3F50000000000000
  %707 = fadd double %557, %706
  %708 = load ptr, ptr %125, align 8
  %709 = load ptr, ptr %127, align 8
  %710 = insertelement <8 x double> poison, double %707, i64 0
  %711 = shufflevector <8 x double> %710, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %711, ptr %709, align 8
  %712 = load ptr, ptr %126, align 8
  %713 = load ptr, ptr %128, align 8
  %714 = load i64, ptr %129, align 8
  %715 = load ptr, ptr %130, align 8
  %716 = getelementptr inbounds i8, ptr %715, i64 24
  %717 = load i64, ptr %716, align 8
  %718 = load ptr, ptr %127, align 8
  %719 = load ptr, ptr %131, align 8
  %720 = getelementptr inbounds i8, ptr %719, i64 16
  %721 = load i64, ptr %720, align 8
  tail call fastcc void @nested(ptr noundef %708, ptr noundef %712, ptr noundef %713, i64 noundef %714, i64 noundef %717, ptr noundef %718, i64 noundef %721) #8
  %722 = fmul double %707, %2
  %723 = fadd double %722, %1
  %724 = load ptr, ptr %132, align 8
  store double %723, ptr %724, align 8
  %725 = load i64, ptr %133, align 8
  %726 = icmp sgt i64 %725, 0
  br i1 %726, label %727, label %728

727:                                              ; preds = %705
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %728

728:                                              ; preds = %705, %727
  %729 = load ptr, ptr %9, align 8
  %730 = load i64, ptr %729, align 8
  %731 = load ptr, ptr %134, align 8
  %732 = load ptr, ptr %125, align 8
  %733 = load ptr, ptr %135, align 8
  %734 = load ptr, ptr %136, align 8
  %735 = load ptr, ptr %25, align 8
  %736 = getelementptr inbounds i8, ptr %729, i64 8
  %737 = load i64, ptr %736, align 8
  %738 = mul i64 %737, 56
  %739 = getelementptr inbounds i8, ptr %735, i64 %738
  %740 = inttoptr i64 %730 to ptr
  %741 = tail call i32 %740(ptr noundef %731, ptr noundef %732, ptr noundef %733, ptr noundef %734, ptr noundef %739) #9
  %742 = icmp slt i32 %741, 0
  br i1 %742, label %782, label %743

743:                                              ; preds = %728
  %744 = icmp sgt i64 %664, 0
  br i1 %744, label %745, label %975

745:                                              ; preds = %743
  %746 = fmul double %557, %2
  %747 = fadd double %746, %1
  %748 = fsub double %747, %747
  br label %749

749:                                              ; preds = %745, %779
  %750 = phi i64 [ 0, %745 ], [ %780, %779 ]
  %751 = load ptr, ptr %17, align 8
  %752 = getelementptr inbounds i64, ptr %751, i64 %750
  %753 = load i64, ptr %752, align 8
  %754 = icmp eq i64 %753, 0
  br i1 %754, label %779, label %755

755:                                              ; preds = %749
  %756 = getelementptr inbounds double, ptr %666, i64 %750
  %757 = load double, ptr %756, align 8
  %758 = fcmp oeq double %757, 0.000000e+00
  br i1 %758, label %759, label %779

759:                                              ; preds = %755
  %760 = getelementptr inbounds double, ptr %668, i64 %750
  %761 = load double, ptr %760, align 8
  %762 = fcmp oeq double %761, 0.000000e+00
  br i1 %762, label %763, label %779

763:                                              ; preds = %759
  %764 = load i64, ptr %145, align 8
  %765 = icmp eq i64 %764, 0
  br i1 %765, label %779, label %766

766:                                              ; preds = %763
  %767 = load ptr, ptr %146, align 8
  %768 = shl nsw i64 %750, 4
  %769 = getelementptr inbounds i8, ptr %767, i64 %768
  %770 = getelementptr inbounds i8, ptr %769, i64 8
  %771 = load double, ptr %770, align 8
  %772 = fcmp oeq double %771, %747
  br i1 %772, label %778, label %773

773:                                              ; preds = %766
  %774 = load double, ptr %769, align 8
  %775 = fsub double %771, %774
  %776 = fcmp ult double %775, %748
  br i1 %776, label %777, label %779

777:                                              ; preds = %773
  store double %747, ptr %769, align 8
  br label %778

778:                                              ; preds = %766, %777
  store double %747, ptr %770, align 8
  br label %779

779:                                              ; preds = %778, %773, %763, %759, %755, %749
  %780 = add nuw nsw i64 %750, 1
  %781 = icmp eq i64 %780, %664
  br i1 %781, label %975, label %749, !llvm.loop !13

782:                                              ; preds = %728
  %783 = load ptr, ptr %20, align 8
  %784 = getelementptr inbounds i8, ptr %783, i64 80
  store i64 %23, ptr %784, align 8
  %785 = load ptr, ptr %19, align 8
  %786 = getelementptr inbounds i8, ptr %785, i64 48
  store double 1.000000e+00, ptr %786, align 8
  br label %975

787:                                              ; preds = %948, %566
  %788 = load ptr, ptr %9, align 8
  %789 = getelementptr inbounds i8, ptr %788, i64 8
  %790 = load i64, ptr %789, align 8
  %791 = load ptr, ptr %25, align 8
  %792 = getelementptr inbounds double, ptr %791, i64 %790
  %793 = mul i64 %790, 56
  %794 = getelementptr inbounds i8, ptr %791, i64 %793
  %795 = load ptr, ptr %153, align 8
  %796 = load i64, ptr %154, align 8
  %797 = getelementptr double, ptr %795, i64 %796
  %798 = getelementptr i8, ptr %797, i64 -8
  %799 = load double, ptr %798, align 8
  %800 = load double, ptr %795, align 8
  %801 = fsub double %799, %800
  %802 = icmp sgt i64 %790, 0
  br i1 %802, label %806, label %803

803:                                              ; preds = %819, %787
  %804 = phi i32 [ 0, %787 ], [ %821, %819 ]
  %805 = icmp eq i32 %804, 0
  br i1 %805, label %956, label %824

806:                                              ; preds = %787, %819
  %807 = phi i64 [ %822, %819 ], [ 0, %787 ]
  %808 = phi i32 [ %821, %819 ], [ 0, %787 ]
  %809 = icmp eq i32 %808, 0
  br i1 %809, label %810, label %819

810:                                              ; preds = %806
  %811 = load ptr, ptr %17, align 8
  %812 = getelementptr inbounds i64, ptr %811, i64 %807
  %813 = load i64, ptr %812, align 8
  %814 = icmp eq i64 %813, 0
  br i1 %814, label %819, label %815

815:                                              ; preds = %810
  %816 = getelementptr inbounds double, ptr %792, i64 %807
  %817 = load double, ptr %816, align 8
  %818 = fcmp oeq double %817, 0.000000e+00
  br label %819

819:                                              ; preds = %815, %810, %806
  %820 = phi i1 [ true, %806 ], [ false, %810 ], [ %818, %815 ]
  %821 = zext i1 %820 to i32
  %822 = add nuw nsw i64 %807, 1
  %823 = icmp eq i64 %822, %790
  br i1 %823, label %803, label %806, !llvm.loop !12

824:                                              ; preds = %803
  %825 = fsub double %351, %557
  %826 = fmul double %825, %2
  %827 = fcmp ogt double %156, %801
  %828 = select i1 %827, double %156, double %801
  %829 = fmul double %828, 0x3F50000000000000
  %830 = fcmp ugt double %826, %829
  br i1 %830, label %831, label %956

831:                                              ; preds = %824
  %832 = fmul double %825, 0x3F50000000000000
  %833 = fadd double %557, %832
  %834 = load ptr, ptr %125, align 8
  %835 = load ptr, ptr %127, align 8
  %836 = insertelement <8 x double> poison, double %833, i64 0
  %837 = shufflevector <8 x double> %836, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %837, ptr %835, align 8
  %838 = load ptr, ptr %126, align 8
  %839 = load ptr, ptr %128, align 8
  %840 = load i64, ptr %129, align 8
  %841 = load ptr, ptr %130, align 8
  %842 = getelementptr inbounds i8, ptr %841, i64 24
  %843 = load i64, ptr %842, align 8
  %844 = load ptr, ptr %127, align 8
  %845 = load ptr, ptr %131, align 8
  %846 = getelementptr inbounds i8, ptr %845, i64 16
  %847 = load i64, ptr %846, align 8
  tail call fastcc void @nested(ptr noundef %834, ptr noundef %838, ptr noundef %839, i64 noundef %840, i64 noundef %843, ptr noundef %844, i64 noundef %847) #8
  %848 = fmul double %833, %2
  %849 = fadd double %848, %1
  %850 = load ptr, ptr %132, align 8
  store double %849, ptr %850, align 8
  %851 = load i64, ptr %133, align 8
  %852 = icmp sgt i64 %851, 0
  br i1 %852, label %853, label %854

853:                                              ; preds = %831
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %854

854:                                              ; preds = %831, %853
  %855 = load ptr, ptr %9, align 8
  %856 = load i64, ptr %855, align 8
  %857 = load ptr, ptr %134, align 8
  %858 = load ptr, ptr %125, align 8
  %859 = load ptr, ptr %135, align 8
  %860 = load ptr, ptr %136, align 8
  %861 = load ptr, ptr %25, align 8
  %862 = getelementptr inbounds i8, ptr %855, i64 8
  %863 = load i64, ptr %862, align 8
  %864 = mul i64 %863, 56
  %865 = getelementptr inbounds i8, ptr %861, i64 %864
  %866 = inttoptr i64 %856 to ptr
  %867 = tail call i32 %866(ptr noundef %857, ptr noundef %858, ptr noundef %859, ptr noundef %860, ptr noundef %865) #9
  %868 = icmp slt i32 %867, 0
  br i1 %868, label %951, label %869

869:                                              ; preds = %854
  %870 = icmp sgt i64 %790, 0
  br i1 %870, label %871, label %956

871:                                              ; preds = %869
  %872 = fmul double %557, %2
  %873 = fadd double %872, %1
  %874 = fsub double %873, %873
  br label %875

875:                                              ; preds = %871, %905
  %876 = phi i64 [ 0, %871 ], [ %906, %905 ]
  %877 = load ptr, ptr %17, align 8
  %878 = getelementptr inbounds i64, ptr %877, i64 %876
  %879 = load i64, ptr %878, align 8
  %880 = icmp eq i64 %879, 0
  br i1 %880, label %905, label %881

881:                                              ; preds = %875
  %882 = getelementptr inbounds double, ptr %792, i64 %876
  %883 = load double, ptr %882, align 8
  %884 = fcmp oeq double %883, 0.000000e+00
  br i1 %884, label %885, label %905

885:                                              ; preds = %881
  %886 = getelementptr inbounds double, ptr %794, i64 %876
  %887 = load double, ptr %886, align 8
  %888 = fcmp oeq double %887, 0.000000e+00
  br i1 %888, label %889, label %905

889:                                              ; preds = %885
  %890 = load i64, ptr %157, align 8
  %891 = icmp eq i64 %890, 0
  br i1 %891, label %905, label %892

892:                                              ; preds = %889
  %893 = load ptr, ptr %158, align 8
  %894 = shl nsw i64 %876, 4
  %895 = getelementptr inbounds i8, ptr %893, i64 %894
  %896 = getelementptr inbounds i8, ptr %895, i64 8
  %897 = load double, ptr %896, align 8
  %898 = fcmp oeq double %897, %873
  br i1 %898, label %904, label %899

899:                                              ; preds = %892
  %900 = load double, ptr %895, align 8
  %901 = fsub double %897, %900
  %902 = fcmp ult double %901, %874
  br i1 %902, label %903, label %905

903:                                              ; preds = %899
  store double %873, ptr %895, align 8
  br label %904

904:                                              ; preds = %892, %903
  store double %873, ptr %896, align 8
  br label %905

905:                                              ; preds = %904, %899, %889, %885, %881, %875
  %906 = add nuw nsw i64 %876, 1
  %907 = icmp eq i64 %906, %790
  br i1 %907, label %956, label %875, !llvm.loop !13

908:                                              ; preds = %567, %948
  %909 = phi i64 [ 0, %567 ], [ %949, %948 ]
  %910 = getelementptr inbounds i64, ptr %18, i64 %909
  %911 = load i64, ptr %910, align 8
  %912 = icmp eq i64 %911, 0
  br i1 %912, label %948, label %913

913:                                              ; preds = %908
  %914 = load ptr, ptr %20, align 8
  %915 = getelementptr inbounds i8, ptr %914, i64 80
  %916 = load i64, ptr %915, align 8
  %917 = load ptr, ptr %6, align 8
  %918 = getelementptr inbounds i8, ptr %917, i64 8
  %919 = load i64, ptr %918, align 8
  %920 = load i64, ptr %148, align 8
  %921 = icmp eq i64 %920, 0
  br i1 %921, label %944, label %922

922:                                              ; preds = %913
  %923 = load ptr, ptr %149, align 8
  %924 = getelementptr inbounds double, ptr %923, i64 %916
  store double %569, ptr %924, align 8
  %925 = load ptr, ptr %150, align 8
  %926 = getelementptr inbounds i64, ptr %925, i64 %916
  store i64 %909, ptr %926, align 8
  %927 = icmp sgt i64 %919, 0
  br i1 %927, label %932, label %928

928:                                              ; preds = %932, %922
  %929 = add nsw i64 %916, 1
  %930 = load ptr, ptr %20, align 8
  %931 = getelementptr inbounds i8, ptr %930, i64 80
  store i64 %929, ptr %931, align 8
  br label %944

932:                                              ; preds = %922, %932
  %933 = phi i64 [ %942, %932 ], [ 0, %922 ]
  %934 = load ptr, ptr %125, align 8
  %935 = getelementptr inbounds double, ptr %934, i64 %933
  %936 = load double, ptr %935, align 8
  %937 = load ptr, ptr %151, align 8
  %938 = load i64, ptr %152, align 8
  %939 = mul nsw i64 %938, %916
  %940 = getelementptr double, ptr %937, i64 %939
  %941 = getelementptr double, ptr %940, i64 %933
  store double %936, ptr %941, align 8
  %942 = add nuw nsw i64 %933, 1
  %943 = icmp eq i64 %942, %919
  br i1 %943, label %928, label %932, !llvm.loop !14

944:                                              ; preds = %913, %928
  %945 = getelementptr inbounds i64, ptr %16, i64 %909
  %946 = load i64, ptr %945, align 8
  %947 = sub nsw i64 0, %946
  store i64 %947, ptr %945, align 8
  br label %948

948:                                              ; preds = %908, %944
  %949 = add nuw nsw i64 %909, 1
  %950 = icmp eq i64 %949, %12
  br i1 %950, label %787, label %908, !llvm.loop !15

951:                                              ; preds = %854
  %952 = load ptr, ptr %20, align 8
  %953 = getelementptr inbounds i8, ptr %952, i64 80
  store i64 %23, ptr %953, align 8
  %954 = load ptr, ptr %19, align 8
  %955 = getelementptr inbounds i8, ptr %954, i64 48
  store double 1.000000e+00, ptr %955, align 8
  br label %975

956:                                              ; preds = %905, %869, %824, %803
  %957 = icmp sgt i64 %564, -1
  br i1 %957, label %958, label %967

958:                                              ; preds = %956
  br i1 %161, label %960, label %959

959:                                              ; preds = %960, %958
  store double %557, ptr %162, align 8
  br label %975

960:                                              ; preds = %958, %960
  %961 = phi i64 [ %965, %960 ], [ 0, %958 ]
  %962 = icmp eq i64 %961, %564
  %963 = zext i1 %962 to i64
  %964 = getelementptr inbounds i64, ptr %18, i64 %961
  store i64 %963, ptr %964, align 8
  %965 = add nuw nsw i64 %961, 1
  %966 = icmp eq i64 %965, %12
  br i1 %966, label %959, label %960, !llvm.loop !16

967:                                              ; preds = %956
  %968 = load i64, ptr %159, align 8
  %969 = icmp sgt i64 %968, 0
  br i1 %969, label %970, label %975

970:                                              ; preds = %967
  %971 = load i64, ptr %22, align 8
  %972 = add nsw i64 %971, %12
  %973 = icmp sgt i64 %972, %968
  br i1 %973, label %974, label %975

974:                                              ; preds = %970
  store double %557, ptr %160, align 8
  br label %975

975:                                              ; preds = %779, %743, %698, %677, %951, %959, %974, %782, %970, %967, %356, %554, %453
  %976 = phi i32 [ 1, %453 ], [ %556, %554 ], [ 8, %356 ], [ 1, %951 ], [ 1, %959 ], [ 1, %974 ], [ 1, %782 ], [ 0, %970 ], [ 0, %967 ], [ 1, %677 ], [ 1, %698 ], [ 1, %743 ], [ 1, %779 ]
  %977 = phi double [ %354, %453 ], [ %354, %554 ], [ %354, %356 ], [ %354, %951 ], [ %354, %959 ], [ %354, %974 ], [ %354, %782 ], [ %557, %970 ], [ %557, %967 ], [ %354, %677 ], [ %354, %698 ], [ %354, %743 ], [ %354, %779 ]
  %978 = phi i64 [ -4, %453 ], [ %558, %554 ], [ %355, %356 ], [ -4, %951 ], [ 21, %959 ], [ -3, %974 ], [ -4, %782 ], [ %558, %970 ], [ %558, %967 ], [ -2, %677 ], [ -2, %698 ], [ -2, %743 ], [ -2, %779 ]
  switch i32 %976, label %1036 [
    i32 0, label %353
    i32 8, label %979
  ], !llvm.loop !17

979:                                              ; preds = %975
  br i1 %163, label %980, label %1036

980:                                              ; preds = %979
  %981 = fcmp oeq double %351, %173
  %982 = add nsw i32 %170, -1
  %983 = sext i32 %982 to i64
  %984 = mul nsw i64 %12, %983
  %985 = getelementptr double, ptr %28, i64 %984
  %986 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %983
  %987 = fmul double %351, %2
  %988 = fadd double %987, %1
  br label %989

989:                                              ; preds = %980, %1028
  %990 = phi i64 [ 0, %980 ], [ %1029, %1028 ]
  %991 = getelementptr inbounds double, ptr %352, i64 %990
  %992 = load double, ptr %991, align 8
  %993 = fcmp ogt double %992, 0.000000e+00
  br i1 %993, label %996, label %994

994:                                              ; preds = %989
  %995 = fcmp olt double %992, 0.000000e+00
  br i1 %995, label %996, label %999

996:                                              ; preds = %994, %989
  %997 = phi i64 [ 1, %989 ], [ -1, %994 ]
  %998 = getelementptr inbounds i64, ptr %16, i64 %990
  store i64 %997, ptr %998, align 8
  br label %999

999:                                              ; preds = %996, %994
  br i1 %981, label %1000, label %1028

1000:                                             ; preds = %999
  %1001 = getelementptr double, ptr %985, i64 %990
  %1002 = load double, ptr %1001, align 8
  %1003 = fcmp oeq double %1002, 0.000000e+00
  br i1 %1003, label %1004, label %1028

1004:                                             ; preds = %1000
  %1005 = getelementptr double, ptr %315, i64 %990
  %1006 = load double, ptr %1005, align 8
  %1007 = fcmp oeq double %1006, 0.000000e+00
  br i1 %1007, label %1008, label %1028

1008:                                             ; preds = %1004
  %1009 = load double, ptr %986, align 8
  %1010 = fmul double %1009, %2
  %1011 = fadd double %1010, %1
  %1012 = load i64, ptr %164, align 8
  %1013 = icmp eq i64 %1012, 0
  br i1 %1013, label %1028, label %1014

1014:                                             ; preds = %1008
  %1015 = load ptr, ptr %165, align 8
  %1016 = shl nsw i64 %990, 4
  %1017 = getelementptr inbounds i8, ptr %1015, i64 %1016
  %1018 = getelementptr inbounds i8, ptr %1017, i64 8
  %1019 = load double, ptr %1018, align 8
  %1020 = fcmp oeq double %1019, %1011
  br i1 %1020, label %1027, label %1021

1021:                                             ; preds = %1014
  %1022 = load double, ptr %1017, align 8
  %1023 = fsub double %1019, %1022
  %1024 = fsub double %988, %1011
  %1025 = fcmp ult double %1023, %1024
  br i1 %1025, label %1026, label %1028

1026:                                             ; preds = %1021
  store double %1011, ptr %1017, align 8
  br label %1027

1027:                                             ; preds = %1014, %1026
  store double %988, ptr %1018, align 8
  br label %1028

1028:                                             ; preds = %1027, %1021, %1008, %999, %1000, %1004
  %1029 = add nuw nsw i64 %990, 1
  %1030 = icmp eq i64 %1029, %12
  br i1 %1030, label %1036, label %989, !llvm.loop !18

1031:                                             ; preds = %339, %311
  %1032 = load ptr, ptr %20, align 8
  %1033 = getelementptr inbounds i8, ptr %1032, i64 80
  store i64 %23, ptr %1033, align 8
  %1034 = load ptr, ptr %19, align 8
  %1035 = getelementptr inbounds i8, ptr %1034, i64 48
  store double 1.000000e+00, ptr %1035, align 8
  br label %1036

1036:                                             ; preds = %975, %1028, %1031, %979
  %1037 = phi i32 [ 0, %979 ], [ 1, %1031 ], [ 0, %1028 ], [ %976, %975 ]
  %1038 = phi double [ %351, %979 ], [ %169, %1031 ], [ %351, %1028 ], [ %977, %975 ]
  %1039 = phi i64 [ %978, %979 ], [ -4, %1031 ], [ %978, %1028 ], [ %978, %975 ]
  %1040 = icmp eq i32 %1037, 0
  br i1 %1040, label %1041, label %1046

1041:                                             ; preds = %1036
  %1042 = fcmp oeq double %1038, %173
  %1043 = zext i1 %1042 to i32
  %1044 = add nuw nsw i32 %170, %1043
  %1045 = icmp ugt i32 %1044, 4
  br i1 %1045, label %1046, label %166, !llvm.loop !19

1046:                                             ; preds = %1041, %1036
  %1047 = phi i1 [ %1045, %1041 ], [ %167, %1036 ]
  br i1 %1047, label %1048, label %1066

1048:                                             ; preds = %1046
  %1049 = icmp sgt i64 %12, 0
  br i1 %1049, label %1050, label %1053

1050:                                             ; preds = %1048
  %1051 = shl i64 %12, 5
  %1052 = getelementptr i8, ptr %28, i64 %1051
  br label %1055

1053:                                             ; preds = %1055, %1048
  %1054 = load double, ptr %24, align 8
  store double %1054, ptr %30, align 8
  br label %1062

1055:                                             ; preds = %1050, %1055
  %1056 = phi i64 [ 0, %1050 ], [ %1060, %1055 ]
  %1057 = getelementptr double, ptr %1052, i64 %1056
  %1058 = load double, ptr %1057, align 8
  %1059 = getelementptr inbounds double, ptr %28, i64 %1056
  store double %1058, ptr %1059, align 8
  %1060 = add nuw nsw i64 %1056, 1
  %1061 = icmp eq i64 %1060, %12
  br i1 %1061, label %1053, label %1055, !llvm.loop !20

1062:                                             ; preds = %93, %1053, %87
  %1063 = phi ptr [ %90, %87 ], [ %24, %1053 ], [ %96, %93 ]
  %1064 = phi i64 [ -4, %87 ], [ 0, %1053 ], [ -4, %93 ]
  %1065 = getelementptr inbounds i8, ptr %1063, i64 48
  store double 1.000000e+00, ptr %1065, align 8
  br label %1066

1066:                                             ; preds = %1062, %1046, %91
  %1067 = phi i64 [ %1039, %1046 ], [ %92, %91 ], [ %1064, %1062 ]
  ret i64 %1067
}



define internal fastcc i64 @resolve(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3) unnamed_addr #2 {
  %5 = alloca [9 x double], align 16
  %6 = getelementptr inbounds i8, ptr %0, i64 720
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 624
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 632
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr double, ptr %11, i64 %13
  %15 = getelementptr i8, ptr %14, i64 -8
  %16 = load double, ptr %15, align 8
  %17 = load double, ptr %11, align 8
  %18 = fsub double %16, %17
  %19 = fadd double %2, %3
  %20 = tail call double @llvm.fabs.f64(double %19)
  %21 = fcmp ogt double %20, %18
  %22 = select i1 %21, double %20, double %18
  %23 = fmul double %22, 0x3D10000000000000
  %24 = fcmp ult double %23, %3
  %25 = icmp sgt i64 %9, 0
  %26 = select i1 %24, i1 %25, i1 false
  br i1 %26, label %27, label %350

27:                                               ; preds = %4
  %28 = getelementptr inbounds i8, ptr %0, i64 912
  %29 = shl nsw i64 %9, 4
  %30 = mul i64 %9, 40
  %31 = getelementptr inbounds i8, ptr %0, i64 816
  %32 = getelementptr inbounds i8, ptr %0, i64 960
  %33 = getelementptr inbounds i8, ptr %1, i64 16
  %34 = getelementptr inbounds i8, ptr %1, i64 8
  %35 = getelementptr inbounds i8, ptr %0, i64 168
  %36 = getelementptr inbounds i8, ptr %0, i64 248
  %37 = getelementptr inbounds i8, ptr %0, i64 144
  %38 = getelementptr inbounds i8, ptr %0, i64 168
  %39 = getelementptr inbounds i8, ptr %0, i64 192
  %40 = getelementptr inbounds i8, ptr %0, i64 744
  %41 = getelementptr inbounds i8, ptr %0, i64 144
  %42 = getelementptr inbounds i8, ptr %0, i64 960
  %43 = getelementptr inbounds i8, ptr %1, i64 16
  %44 = getelementptr inbounds i8, ptr %1, i64 8
  %45 = getelementptr inbounds i8, ptr %0, i64 552
  %46 = getelementptr inbounds i8, ptr %0, i64 528
  %47 = getelementptr inbounds i8, ptr %0, i64 168
  %48 = getelementptr inbounds i8, ptr %0, i64 248
  %49 = getelementptr inbounds i8, ptr %0, i64 168
  %50 = getelementptr inbounds i8, ptr %0, i64 192
  %51 = getelementptr inbounds i8, ptr %0, i64 744
  %52 = shl nsw i64 %9, 5
  br label %53

53:                                               ; preds = %27, %347
  %54 = phi i64 [ undef, %27 ], [ %346, %347 ]
  %55 = phi i32 [ 0, %27 ], [ %345, %347 ]
  %56 = phi i32 [ 0, %27 ], [ %344, %347 ]
  %57 = phi i64 [ 0, %27 ], [ %348, %347 ]
  %58 = load ptr, ptr %28, align 8
  %59 = getelementptr inbounds i8, ptr %58, i64 %29
  %60 = getelementptr inbounds double, ptr %59, i64 %57
  %61 = getelementptr inbounds i8, ptr %60, i64 %30
  %62 = load ptr, ptr %31, align 8
  %63 = getelementptr inbounds i64, ptr %62, i64 %57
  %64 = load i64, ptr %63, align 8
  %65 = icmp eq i64 %64, 1
  br i1 %65, label %342, label %66

66:                                               ; preds = %53
  %67 = load double, ptr %60, align 8
  br label %71

68:                                               ; preds = %71
  %69 = fmul double %79, %81
  %70 = fcmp ugt double %69, 0.000000e+00
  br i1 %70, label %84, label %93

71:                                               ; preds = %66, %71
  %72 = phi i64 [ 1, %66 ], [ %82, %71 ]
  %73 = phi double [ %67, %66 ], [ %81, %71 ]
  %74 = phi double [ %67, %66 ], [ %79, %71 ]
  %75 = mul nuw nsw i64 %9, %72
  %76 = getelementptr inbounds double, ptr %60, i64 %75
  %77 = load double, ptr %76, align 8
  %78 = fcmp olt double %74, %77
  %79 = select i1 %78, double %74, double %77
  %80 = fcmp ogt double %73, %77
  %81 = select i1 %80, double %73, double %77
  %82 = add nuw nsw i64 %72, 1
  %83 = icmp eq i64 %82, 5
  br i1 %83, label %68, label %71, !llvm.loop !21

84:                                               ; preds = %68
  %85 = tail call double @llvm.fabs.f64(double %79)
  %86 = tail call double @llvm.fabs.f64(double %81)
  %87 = fcmp olt double %85, %86
  %88 = select i1 %87, double %85, double %86
  %89 = fsub double %81, %79
  %90 = fmul double %89, 4.000000e+00
  %91 = fcmp ole double %88, %90
  %92 = zext i1 %91 to i32
  br label %93

93:                                               ; preds = %68, %84
  %94 = phi i32 [ 1, %68 ], [ %92, %84 ]
  %95 = icmp eq i32 %94, 0
  br i1 %95, label %342, label %96

96:                                               ; preds = %93
  %97 = sext i32 %55 to i64
  br label %98

98:                                               ; preds = %96, %136
  %99 = phi i64 [ %97, %96 ], [ %104, %136 ]
  %100 = icmp slt i64 %99, 4
  br i1 %100, label %101, label %151

101:                                              ; preds = %98
  %102 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %99
  %103 = load double, ptr %102, align 8
  %104 = add nsw i64 %99, 1
  %105 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %104
  %106 = load double, ptr %105, align 8
  %107 = fadd double %103, %106
  %108 = fmul double %107, 5.000000e-01
  %109 = add nsw i64 %99, 7
  %110 = load ptr, ptr %32, align 8
  %111 = load ptr, ptr %33, align 8
  %112 = getelementptr inbounds i8, ptr %111, i64 96
  %113 = load ptr, ptr %112, align 8
  %114 = insertelement <8 x double> poison, double %108, i64 0
  %115 = shufflevector <8 x double> %114, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %115, ptr %113, align 8
  %116 = load ptr, ptr %111, align 8
  %117 = getelementptr inbounds i8, ptr %111, i64 192
  %118 = load ptr, ptr %117, align 8
  %119 = getelementptr inbounds i8, ptr %111, i64 8
  %120 = load i64, ptr %119, align 8
  %121 = load ptr, ptr %1, align 8
  %122 = load ptr, ptr %121, align 8
  %123 = getelementptr inbounds i8, ptr %122, i64 24
  %124 = load i64, ptr %123, align 8
  %125 = load ptr, ptr %112, align 8
  %126 = load ptr, ptr %34, align 8
  %127 = load ptr, ptr %126, align 8
  %128 = getelementptr inbounds i8, ptr %127, i64 16
  %129 = load i64, ptr %128, align 8
  tail call fastcc void @nested(ptr noundef %110, ptr noundef %116, ptr noundef %118, i64 noundef %120, i64 noundef %124, ptr noundef %125, i64 noundef %129) #8
  %130 = fmul double %108, %3
  %131 = fadd double %130, %2
  %132 = load ptr, ptr %35, align 8
  store double %131, ptr %132, align 8
  %133 = load i64, ptr %36, align 8
  %134 = icmp sgt i64 %133, 0
  br i1 %134, label %135, label %136

135:                                              ; preds = %101
  tail call fastcc void @sample(ptr noundef nonnull %37) #8
  br label %136

136:                                              ; preds = %101, %135
  %137 = load ptr, ptr %6, align 8
  %138 = load i64, ptr %137, align 8
  %139 = load ptr, ptr %38, align 8
  %140 = load ptr, ptr %32, align 8
  %141 = load ptr, ptr %39, align 8
  %142 = load ptr, ptr %40, align 8
  %143 = load ptr, ptr %28, align 8
  %144 = getelementptr inbounds i8, ptr %137, i64 8
  %145 = load i64, ptr %144, align 8
  %146 = mul nsw i64 %145, %109
  %147 = getelementptr inbounds double, ptr %143, i64 %146
  %148 = inttoptr i64 %138 to ptr
  %149 = tail call i32 %148(ptr noundef %139, ptr noundef %140, ptr noundef %141, ptr noundef %142, ptr noundef %147) #9
  %150 = icmp slt i32 %149, 0
  br i1 %150, label %340, label %98, !llvm.loop !22

151:                                              ; preds = %98
  %152 = load double, ptr %60, align 8
  %153 = tail call double @llvm.fabs.f64(double %152)
  store double %152, ptr %5, align 16
  br label %161

154:                                              ; preds = %211
  %155 = trunc nsw i64 %99 to i32
  %156 = fmul double %222, 0x3E50000000000000
  %157 = fcmp ogt double %216, %156
  br i1 %157, label %158, label %336

158:                                              ; preds = %154
  %159 = fmul double %216, 2.000000e+00
  %160 = fmul double %216, 8.000000e+00
  br label %224

161:                                              ; preds = %151, %211
  %162 = phi i64 [ 0, %151 ], [ %171, %211 ]
  %163 = phi double [ 0.000000e+00, %151 ], [ %216, %211 ]
  %164 = phi double [ %153, %151 ], [ %222, %211 ]
  %165 = mul nuw nsw i64 %9, %162
  %166 = getelementptr inbounds double, ptr %61, i64 %165
  %167 = load double, ptr %166, align 8
  %168 = shl nuw nsw i64 %162, 1
  %169 = or disjoint i64 %168, 1
  %170 = getelementptr inbounds [9 x double], ptr %5, i64 0, i64 %169
  store double %167, ptr %170, align 8
  %171 = add nuw nsw i64 %162, 1
  %172 = mul nuw nsw i64 %9, %171
  %173 = getelementptr inbounds double, ptr %60, i64 %172
  %174 = load double, ptr %173, align 8
  %175 = add nuw nsw i64 %168, 2
  %176 = getelementptr inbounds [9 x double], ptr %5, i64 0, i64 %175
  store double %174, ptr %176, align 16
  %177 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %162
  %178 = load double, ptr %177, align 8
  %179 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %171
  %180 = load double, ptr %179, align 8
  %181 = fadd double %178, %180
  %182 = fmul double %181, 5.000000e-01
  br label %183

183:                                              ; preds = %161, %187
  %184 = phi i64 [ 0, %161 ], [ %193, %187 ]
  %185 = phi double [ 0.000000e+00, %161 ], [ %192, %187 ]
  %186 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %184
  br label %195

187:                                              ; preds = %206
  %188 = mul nuw nsw i64 %9, %184
  %189 = getelementptr inbounds double, ptr %60, i64 %188
  %190 = load double, ptr %189, align 8
  %191 = fmul double %208, %190
  %192 = fadd double %185, %191
  %193 = add nuw nsw i64 %184, 1
  %194 = icmp eq i64 %193, 5
  br i1 %194, label %211, label %183, !llvm.loop !23

195:                                              ; preds = %183, %206
  %196 = phi i64 [ 0, %183 ], [ %209, %206 ]
  %197 = phi double [ 1.000000e+00, %183 ], [ %208, %206 ]
  %198 = icmp eq i64 %196, %184
  br i1 %198, label %206, label %199

199:                                              ; preds = %195
  %200 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %196
  %201 = load double, ptr %200, align 8
  %202 = fsub double %182, %201
  %203 = load double, ptr %186, align 8
  %204 = fsub double %203, %201
  %205 = fdiv double %202, %204
  br label %206

206:                                              ; preds = %199, %195
  %207 = phi double [ %205, %199 ], [ 1.000000e+00, %195 ]
  %208 = fmul double %197, %207
  %209 = add nuw nsw i64 %196, 1
  %210 = icmp eq i64 %209, 5
  br i1 %210, label %187, label %195, !llvm.loop !24

211:                                              ; preds = %187
  %212 = fsub double %167, %192
  %213 = tail call double @llvm.fabs.f64(double %212)
  %214 = fmul double %213, 2.000000e+00
  %215 = fcmp ogt double %163, %214
  %216 = select i1 %215, double %163, double %214
  %217 = tail call double @llvm.fabs.f64(double %167)
  %218 = tail call double @llvm.fabs.f64(double %174)
  %219 = fcmp ogt double %217, %218
  %220 = select i1 %219, double %217, double %218
  %221 = fcmp ogt double %164, %220
  %222 = select i1 %221, double %164, double %220
  %223 = icmp eq i64 %171, 4
  br i1 %223, label %154, label %161, !llvm.loop !25

224:                                              ; preds = %158, %245
  %225 = phi i64 [ 1, %158 ], [ %246, %245 ]
  %226 = phi i1 [ false, %158 ], [ %247, %245 ]
  %227 = getelementptr double, ptr %5, i64 %225
  %228 = getelementptr i8, ptr %227, i64 -8
  %229 = load double, ptr %228, align 8
  %230 = load double, ptr %227, align 8
  %231 = fsub double %229, %230
  %232 = tail call double @llvm.fabs.f64(double %231)
  %233 = fmul double %229, %230
  %234 = fcmp olt double %233, 0.000000e+00
  br i1 %234, label %235, label %237

235:                                              ; preds = %224
  %236 = fcmp olt double %232, %160
  br i1 %236, label %249, label %245

237:                                              ; preds = %224
  %238 = tail call double @llvm.fabs.f64(double %230)
  %239 = tail call double @llvm.fabs.f64(double %229)
  %240 = fcmp olt double %239, %238
  %241 = select i1 %240, double %239, double %238
  %242 = fcmp ugt double %241, %216
  %243 = fcmp ugt double %232, %159
  %244 = or i1 %243, %242
  br i1 %244, label %245, label %249

245:                                              ; preds = %237, %235
  %246 = add nuw nsw i64 %225, 1
  %247 = icmp ugt i64 %225, 7
  %248 = icmp eq i64 %246, 9
  br i1 %248, label %336, label %224, !llvm.loop !26

249:                                              ; preds = %235, %237
  br i1 %226, label %336, label %250

250:                                              ; preds = %249, %310
  %251 = phi i32 [ 1, %310 ], [ %56, %249 ]
  %252 = icmp eq i32 %251, 0
  br i1 %252, label %253, label %324

253:                                              ; preds = %250
  %254 = load ptr, ptr %42, align 8
  %255 = load ptr, ptr %43, align 8
  %256 = getelementptr inbounds i8, ptr %255, i64 96
  %257 = load ptr, ptr %256, align 8
  store <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, ptr %257, align 8
  %258 = load ptr, ptr %255, align 8
  %259 = getelementptr inbounds i8, ptr %255, i64 192
  %260 = load ptr, ptr %259, align 8
  %261 = getelementptr inbounds i8, ptr %255, i64 8
  %262 = load i64, ptr %261, align 8
  %263 = load ptr, ptr %1, align 8
  %264 = load ptr, ptr %263, align 8
  %265 = getelementptr inbounds i8, ptr %264, i64 24
  %266 = load i64, ptr %265, align 8
  %267 = load ptr, ptr %256, align 8
  %268 = load ptr, ptr %44, align 8
  %269 = load ptr, ptr %268, align 8
  %270 = getelementptr inbounds i8, ptr %269, i64 16
  %271 = load i64, ptr %270, align 8
  tail call fastcc void @nested(ptr noundef %254, ptr noundef %258, ptr noundef %260, i64 noundef %262, i64 noundef %266, ptr noundef %267, i64 noundef %271) #8
  %272 = load ptr, ptr %41, align 8
  %273 = getelementptr inbounds i8, ptr %272, i64 8
  %274 = load i64, ptr %273, align 8
  %275 = icmp sgt i64 %274, 0
  br i1 %275, label %281, label %276

276:                                              ; preds = %281, %253
  %277 = load ptr, ptr %47, align 8
  store double %19, ptr %277, align 8
  %278 = load i64, ptr %48, align 8
  %279 = icmp sgt i64 %278, 0
  br i1 %279, label %280, label %310

280:                                              ; preds = %276
  tail call fastcc void @sample(ptr noundef nonnull %41) #8
  br label %310

281:                                              ; preds = %253, %281
  %282 = phi i64 [ %305, %281 ], [ 0, %253 ]
  %283 = load ptr, ptr %45, align 8
  %284 = getelementptr inbounds double, ptr %283, i64 %282
  %285 = load double, ptr %284, align 8
  %286 = load ptr, ptr %46, align 8
  %287 = getelementptr inbounds double, ptr %286, i64 %282
  %288 = load double, ptr %287, align 8
  %289 = load ptr, ptr %42, align 8
  %290 = getelementptr inbounds double, ptr %289, i64 %282
  %291 = load double, ptr %290, align 8
  %292 = tail call double @llvm.fabs.f64(double %291)
  %293 = fmul double %288, %292
  %294 = fadd double %285, %293
  %295 = and i64 %282, 1
  %296 = icmp eq i64 %295, 0
  %297 = urem i64 %282, 3
  %298 = uitofp nneg i64 %297 to double
  %299 = fmul double %298, 0x3FE3C6EF372FE950
  %300 = fadd double %299, 1.000000e+00
  %301 = fneg double %300
  %302 = select i1 %296, double %300, double %301
  %303 = fmul double %302, %294
  %304 = fadd double %291, %303
  store double %304, ptr %290, align 8
  %305 = add nuw nsw i64 %282, 1
  %306 = load ptr, ptr %41, align 8
  %307 = getelementptr inbounds i8, ptr %306, i64 8
  %308 = load i64, ptr %307, align 8
  %309 = icmp slt i64 %305, %308
  br i1 %309, label %281, label %276, !llvm.loop !27

310:                                              ; preds = %276, %280
  %311 = load ptr, ptr %6, align 8
  %312 = load i64, ptr %311, align 8
  %313 = load ptr, ptr %49, align 8
  %314 = load ptr, ptr %42, align 8
  %315 = load ptr, ptr %50, align 8
  %316 = load ptr, ptr %51, align 8
  %317 = load ptr, ptr %28, align 8
  %318 = getelementptr inbounds i8, ptr %311, i64 8
  %319 = load i64, ptr %318, align 8
  %320 = getelementptr inbounds double, ptr %317, i64 %319
  %321 = inttoptr i64 %312 to ptr
  %322 = tail call i32 %321(ptr noundef %313, ptr noundef %314, ptr noundef %315, ptr noundef %316, ptr noundef %320) #9
  %323 = icmp slt i32 %322, 0
  br i1 %323, label %336, label %250, !llvm.loop !28

324:                                              ; preds = %250
  %325 = load ptr, ptr %28, align 8
  %326 = getelementptr double, ptr %325, i64 %9
  %327 = getelementptr double, ptr %326, i64 %57
  %328 = load double, ptr %327, align 8
  %329 = getelementptr inbounds i8, ptr %60, i64 %52
  %330 = load double, ptr %329, align 8
  %331 = fsub double %328, %330
  %332 = tail call double @llvm.fabs.f64(double %331)
  %333 = fcmp ogt double %216, %332
  %334 = zext i1 %333 to i32
  %335 = select i1 %333, i64 -6, i64 %54
  br label %336

336:                                              ; preds = %245, %310, %324, %154, %249
  %337 = phi i32 [ 4, %249 ], [ 4, %154 ], [ %334, %324 ], [ 1, %310 ], [ 4, %245 ]
  %338 = phi i32 [ %56, %249 ], [ %56, %154 ], [ %251, %324 ], [ %251, %310 ], [ %56, %245 ]
  %339 = phi i64 [ %54, %249 ], [ %54, %154 ], [ %335, %324 ], [ -4, %310 ], [ %54, %245 ]
  br label %342

340:                                              ; preds = %136
  %341 = trunc nsw i64 %99 to i32
  br label %342

342:                                              ; preds = %340, %53, %93, %336
  %343 = phi i32 [ %337, %336 ], [ 4, %93 ], [ 4, %53 ], [ 1, %340 ]
  %344 = phi i32 [ %338, %336 ], [ %56, %93 ], [ %56, %53 ], [ %56, %340 ]
  %345 = phi i32 [ %155, %336 ], [ %55, %93 ], [ %55, %53 ], [ %341, %340 ]
  %346 = phi i64 [ %339, %336 ], [ %54, %93 ], [ %54, %53 ], [ -4, %340 ]
  switch i32 %343, label %350 [
    i32 0, label %347
    i32 4, label %347
  ]

347:                                              ; preds = %342, %342
  %348 = add nuw nsw i64 %57, 1
  %349 = icmp eq i64 %348, %9
  br i1 %349, label %350, label %53, !llvm.loop !29

350:                                              ; preds = %347, %342, %4
  %351 = phi i64 [ 0, %4 ], [ %346, %342 ], [ 0, %347 ]
  ret i64 %351
}

define internal fastcc double @locate(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, double noundef %4, double noundef %5, i64 noundef %6) unnamed_addr #2 {
  %8 = getelementptr inbounds i8, ptr %0, i64 720
  %9 = getelementptr inbounds i8, ptr %0, i64 864
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i64, ptr %10, i64 %6
  %12 = load i64, ptr %11, align 8
  %13 = sitofp i64 %12 to double
  %14 = getelementptr inbounds i8, ptr %0, i64 912
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
  %29 = getelementptr inbounds i8, ptr %0, i64 960
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
  br i1 %128, label %129, label %79, !llvm.loop !30

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
  br i1 %31, label %20, label %19, !llvm.loop !31

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
  br i1 %43, label %32, label %24, !llvm.loop !32
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
  br i1 %55, label %44, label %56, !llvm.loop !33

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
  br i1 %83, label %13, label %12, !llvm.loop !34
}

declare double @llvm.fabs.f64(double) #4

define internal fastcc double @least_place(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, i64 noundef %4, double noundef %5, i32 noundef %6, i32 noundef %7) unnamed_addr #2 {
  %9 = getelementptr inbounds i8, ptr %0, i64 720
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 912
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds double, ptr %14, i64 %4
  %16 = add nsw i32 %6, 2
  %17 = sext i32 %16 to i64
  %18 = mul nsw i64 %12, %17
  %19 = getelementptr inbounds double, ptr %14, i64 %18
  %20 = getelementptr inbounds double, ptr %19, i64 %4
  %21 = sub nsw i64 0, %12
  %22 = getelementptr inbounds double, ptr %20, i64 %21
  %23 = load double, ptr %22, align 8
  %24 = fmul double %23, %5
  %25 = load double, ptr %20, align 8
  %26 = fmul double %25, %5
  %27 = getelementptr inbounds double, ptr %20, i64 %12
  %28 = load double, ptr %27, align 8
  %29 = fmul double %28, %5
  %30 = fcmp ogt double %24, 0.000000e+00
  %31 = fcmp ogt double %26, 0.000000e+00
  %32 = and i1 %30, %31
  %33 = fcmp ogt double %29, 0.000000e+00
  %34 = and i1 %32, %33
  br i1 %34, label %35, label %210

35:                                               ; preds = %8
  %36 = fcmp ogt double %26, %29
  %37 = select i1 %36, double %26, double %29
  %38 = fcmp ogt double %24, %37
  %39 = select i1 %38, double %24, double %37
  %40 = add nsw i32 %6, 1
  %41 = sext i32 %40 to i64
  %42 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %41
  %43 = load double, ptr %42, align 8
  %44 = sext i32 %6 to i64
  %45 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = add nsw i32 %6, -1
  %48 = sext i32 %47 to i64
  %49 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = icmp sgt i32 %7, 1
  %52 = add nsw i32 %7, -1
  %53 = zext nneg i32 %52 to i64
  %54 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %53
  %55 = icmp slt i32 %7, 4
  %56 = sext i32 %7 to i64
  %57 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %56
  %58 = getelementptr inbounds i8, ptr %0, i64 960
  %59 = getelementptr inbounds i8, ptr %1, i64 16
  %60 = getelementptr inbounds i8, ptr %1, i64 8
  %61 = getelementptr inbounds i8, ptr %0, i64 168
  %62 = getelementptr inbounds i8, ptr %0, i64 248
  %63 = getelementptr inbounds i8, ptr %0, i64 144
  %64 = getelementptr inbounds i8, ptr %0, i64 168
  %65 = getelementptr inbounds i8, ptr %0, i64 192
  %66 = getelementptr inbounds i8, ptr %0, i64 744
  %67 = fmul double %39, 0xBCE0000000000000
  br label %72

68:                                               ; preds = %197
  %69 = add nuw nsw i32 %82, 1
  %70 = icmp ugt i32 %82, 18
  %71 = icmp eq i32 %69, 20
  br i1 %71, label %207, label %72, !llvm.loop !35

72:                                               ; preds = %35, %68
  %73 = phi i1 [ false, %35 ], [ %70, %68 ]
  %74 = phi double [ undef, %35 ], [ %206, %68 ]
  %75 = phi double [ %50, %35 ], [ %205, %68 ]
  %76 = phi double [ %46, %35 ], [ %204, %68 ]
  %77 = phi double [ %43, %35 ], [ %203, %68 ]
  %78 = phi double [ 0x7FF0000000000000, %35 ], [ %202, %68 ]
  %79 = phi double [ %24, %35 ], [ %201, %68 ]
  %80 = phi double [ %26, %35 ], [ %200, %68 ]
  %81 = phi double [ %29, %35 ], [ %199, %68 ]
  %82 = phi i32 [ 0, %35 ], [ %69, %68 ]
  %83 = fsub double %80, %79
  %84 = fsub double %76, %75
  %85 = fdiv double %83, %84
  %86 = fsub double %81, %80
  %87 = fsub double %77, %76
  %88 = fdiv double %86, %87
  %89 = fsub double %88, %85
  %90 = fsub double %77, %75
  %91 = fdiv double %89, %90
  %92 = fmul double %84, %91
  %93 = fadd double %85, %92
  %94 = fmul double %93, 5.000000e-01
  %95 = fdiv double %94, %91
  %96 = fsub double %76, %95
  %97 = fcmp ogt double %91, 0.000000e+00
  br i1 %97, label %98, label %197

98:                                               ; preds = %72
  %99 = fsub double %96, %76
  %100 = fmul double %94, %99
  %101 = fadd double %80, %100
  %102 = fmul double %78, 2.000000e+00
  %103 = fcmp ugt double %101, %102
  br i1 %103, label %197, label %104

104:                                              ; preds = %98
  br i1 %51, label %105, label %107

105:                                              ; preds = %104
  %106 = load double, ptr %54, align 8
  br label %107

107:                                              ; preds = %104, %105
  %108 = phi double [ %106, %105 ], [ 0xBFCE3779B97F4A7C, %104 ]
  br i1 %55, label %109, label %111

109:                                              ; preds = %107
  %110 = load double, ptr %57, align 8
  br label %111

111:                                              ; preds = %107, %109
  %112 = phi double [ %110, %109 ], [ 0x3FF4498517A7B356, %107 ]
  %113 = icmp eq i32 %82, 0
  br i1 %113, label %114, label %118

114:                                              ; preds = %111
  %115 = fcmp ult double %96, %108
  %116 = fcmp ugt double %96, %112
  %117 = select i1 %115, i1 true, i1 %116
  br i1 %117, label %197, label %118

118:                                              ; preds = %114, %111
  %119 = fcmp ugt double %96, %75
  br i1 %119, label %120, label %122

120:                                              ; preds = %118
  %121 = fcmp ult double %96, %77
  br i1 %121, label %126, label %122

122:                                              ; preds = %120, %118
  %123 = phi double [ %77, %120 ], [ %75, %118 ]
  %124 = fadd double %76, %123
  %125 = fmul double %124, 5.000000e-01
  br label %126

126:                                              ; preds = %122, %120
  %127 = phi double [ %125, %122 ], [ %96, %120 ]
  %128 = fsub double %127, %76
  %129 = fmul double %91, %128
  %130 = fadd double %93, %129
  %131 = fmul double %128, %130
  %132 = fadd double %80, %131
  %133 = fcmp ule double %127, %75
  %134 = fcmp uge double %127, %77
  %135 = or i1 %133, %134
  %136 = fcmp oeq double %127, %76
  %137 = or i1 %135, %136
  br i1 %137, label %197, label %138

138:                                              ; preds = %126
  %139 = load ptr, ptr %58, align 8
  %140 = load ptr, ptr %59, align 8
  %141 = getelementptr inbounds i8, ptr %140, i64 96
  %142 = load ptr, ptr %141, align 8
  %143 = insertelement <8 x double> poison, double %127, i64 0
  %144 = shufflevector <8 x double> %143, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %144, ptr %142, align 8
  %145 = load ptr, ptr %140, align 8
  %146 = getelementptr inbounds i8, ptr %140, i64 192
  %147 = load ptr, ptr %146, align 8
  %148 = getelementptr inbounds i8, ptr %140, i64 8
  %149 = load i64, ptr %148, align 8
  %150 = load ptr, ptr %1, align 8
  %151 = load ptr, ptr %150, align 8
  %152 = getelementptr inbounds i8, ptr %151, i64 24
  %153 = load i64, ptr %152, align 8
  %154 = load ptr, ptr %141, align 8
  %155 = load ptr, ptr %60, align 8
  %156 = load ptr, ptr %155, align 8
  %157 = getelementptr inbounds i8, ptr %156, i64 16
  %158 = load i64, ptr %157, align 8
  tail call fastcc void @nested(ptr noundef %139, ptr noundef %145, ptr noundef %147, i64 noundef %149, i64 noundef %153, ptr noundef %154, i64 noundef %158) #8
  %159 = fmul double %127, %3
  %160 = fadd double %159, %2
  %161 = load ptr, ptr %61, align 8
  store double %160, ptr %161, align 8
  %162 = load i64, ptr %62, align 8
  %163 = icmp sgt i64 %162, 0
  br i1 %163, label %164, label %165

164:                                              ; preds = %138
  tail call fastcc void @sample(ptr noundef nonnull %63) #8
  br label %165

165:                                              ; preds = %138, %164
  %166 = load ptr, ptr %9, align 8
  %167 = load i64, ptr %166, align 8
  %168 = load ptr, ptr %64, align 8
  %169 = load ptr, ptr %58, align 8
  %170 = load ptr, ptr %65, align 8
  %171 = load ptr, ptr %66, align 8
  %172 = load ptr, ptr %13, align 8
  %173 = inttoptr i64 %167 to ptr
  %174 = tail call i32 %173(ptr noundef %168, ptr noundef %169, ptr noundef %170, ptr noundef %171, ptr noundef %172) #9
  %175 = icmp slt i32 %174, 0
  br i1 %175, label %197, label %176

176:                                              ; preds = %165
  %177 = load double, ptr %15, align 8
  %178 = fmul double %177, %5
  %179 = fcmp olt double %178, 0.000000e+00
  br i1 %179, label %180, label %183

180:                                              ; preds = %176
  %181 = fcmp olt double %178, %67
  %182 = select i1 %181, double %127, double 2.000000e+00
  br label %197

183:                                              ; preds = %176
  %184 = fsub double %178, %132
  %185 = tail call double @llvm.fabs.f64(double %184)
  %186 = fcmp uge double %127, %76
  %187 = fcmp ugt double %178, %80
  %188 = or i1 %186, %187
  br i1 %188, label %189, label %197

189:                                              ; preds = %183
  br i1 %186, label %190, label %197

190:                                              ; preds = %189
  %191 = select i1 %187, double %178, double %81
  %192 = select i1 %187, double %80, double %178
  %193 = select i1 %187, double %79, double %80
  %194 = select i1 %187, double %127, double %77
  %195 = select i1 %187, double %76, double %127
  %196 = select i1 %187, double %75, double %76
  br label %197

197:                                              ; preds = %114, %180, %190, %189, %183, %165, %126, %72, %98
  %198 = phi i1 [ false, %98 ], [ false, %72 ], [ false, %114 ], [ false, %126 ], [ false, %165 ], [ false, %180 ], [ true, %190 ], [ true, %189 ], [ true, %183 ]
  %199 = phi double [ %81, %98 ], [ %81, %72 ], [ %81, %114 ], [ %81, %126 ], [ %81, %165 ], [ %81, %180 ], [ %191, %190 ], [ %81, %189 ], [ %80, %183 ]
  %200 = phi double [ %80, %98 ], [ %80, %72 ], [ %80, %114 ], [ %80, %126 ], [ %80, %165 ], [ %80, %180 ], [ %192, %190 ], [ %80, %189 ], [ %178, %183 ]
  %201 = phi double [ %79, %98 ], [ %79, %72 ], [ %79, %114 ], [ %79, %126 ], [ %79, %165 ], [ %79, %180 ], [ %193, %190 ], [ %178, %189 ], [ %79, %183 ]
  %202 = phi double [ %78, %98 ], [ %78, %72 ], [ %78, %114 ], [ %78, %126 ], [ %78, %165 ], [ %78, %180 ], [ %185, %190 ], [ %185, %189 ], [ %185, %183 ]
  %203 = phi double [ %77, %98 ], [ %77, %72 ], [ %77, %114 ], [ %77, %126 ], [ %77, %165 ], [ %77, %180 ], [ %194, %190 ], [ %77, %189 ], [ %76, %183 ]
  %204 = phi double [ %76, %98 ], [ %76, %72 ], [ %76, %114 ], [ %76, %126 ], [ %76, %165 ], [ %76, %180 ], [ %195, %190 ], [ %76, %189 ], [ %127, %183 ]
  %205 = phi double [ %75, %98 ], [ %75, %72 ], [ %75, %114 ], [ %75, %126 ], [ %75, %165 ], [ %75, %180 ], [ %196, %190 ], [ %127, %189 ], [ %75, %183 ]
  %206 = phi double [ 2.000000e+00, %98 ], [ 2.000000e+00, %72 ], [ 2.000000e+00, %114 ], [ 2.000000e+00, %126 ], [ -4.000000e+00, %165 ], [ %182, %180 ], [ %74, %190 ], [ %74, %189 ], [ %74, %183 ]
  br i1 %198, label %68, label %207

207:                                              ; preds = %68, %197
  %208 = phi i1 [ %70, %68 ], [ %73, %197 ]
  br i1 %208, label %209, label %210

209:                                              ; preds = %207
  br label %210

210:                                              ; preds = %8, %207, %209
  %211 = phi double [ 2.000000e+00, %209 ], [ %206, %207 ], [ 2.000000e+00, %8 ]
  ret double %211
}

declare i32 @llvm.smin.i32(i32, i32) #6

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind willreturn memory(none) }
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
!16 = distinct !{!16, !4, !5}
!17 = distinct !{!17, !5}
!18 = distinct !{!18, !4, !5}
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !4, !5}
!21 = distinct !{!21, !4, !5}
!22 = distinct !{!22, !4, !5}
!23 = distinct !{!23, !4, !5}
!24 = distinct !{!24, !4, !5}
!25 = distinct !{!25, !4, !5}
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5}
!29 = distinct !{!29, !4, !5}
!30 = distinct !{!30, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5}
!35 = distinct !{!35, !4, !5}
