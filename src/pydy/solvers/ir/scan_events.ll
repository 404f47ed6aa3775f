; sources 60c944f9f6cc473beacfe36ea627812aed26b10fc298bcd912927af5e99d5f20
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
  br label %938

91:                                               ; preds = %44
  %92 = call fastcc i64 @resolve(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2) #8
  switch i64 %92, label %942 [
    i64 0, label %97
    i64 -4, label %93
  ]

93:                                               ; preds = %91
  %94 = load ptr, ptr %20, align 8
  %95 = getelementptr inbounds i8, ptr %94, i64 80
  store i64 %23, ptr %95, align 8
  %96 = load ptr, ptr %19, align 8
  br label %938

97:                                               ; preds = %91
  store double 0x7FF8000000000000, ptr %30, align 8
  %98 = getelementptr inbounds i8, ptr %0, i64 960
  %99 = load ptr, ptr %7, align 8
  %100 = getelementptr inbounds i8, ptr %99, i64 96
  %101 = getelementptr inbounds i8, ptr %99, i64 192
  %102 = getelementptr inbounds i8, ptr %99, i64 8
  %103 = load ptr, ptr %4, align 8
  %104 = load ptr, ptr %5, align 8
  %105 = getelementptr inbounds i8, ptr %0, i64 168
  %106 = getelementptr inbounds i8, ptr %0, i64 248
  %107 = getelementptr inbounds i8, ptr %0, i64 168
  %108 = getelementptr inbounds i8, ptr %0, i64 192
  %109 = getelementptr inbounds i8, ptr %0, i64 744
  %110 = icmp sgt i64 %12, 0
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
  %124 = icmp sgt i64 %12, 0
  %125 = getelementptr inbounds i8, ptr %0, i64 792
  %126 = getelementptr inbounds i8, ptr %24, i64 48
  %127 = getelementptr inbounds i8, ptr %0, i64 624
  %128 = getelementptr inbounds i8, ptr %0, i64 632
  %129 = fadd double %1, %2
  %130 = tail call double @llvm.fabs.f64(double %129)
  %131 = getelementptr inbounds i8, ptr %0, i64 944
  %132 = getelementptr inbounds i8, ptr %0, i64 936
  %133 = icmp sgt i64 %12, 0
  %134 = getelementptr inbounds i8, ptr %0, i64 992
  %135 = getelementptr inbounds i8, ptr %0, i64 984
  %136 = getelementptr inbounds i8, ptr %0, i64 1008
  %137 = getelementptr inbounds i8, ptr %0, i64 1032
  %138 = getelementptr inbounds i8, ptr %0, i64 1048
  %139 = getelementptr inbounds i8, ptr %0, i64 624
  %140 = getelementptr inbounds i8, ptr %0, i64 632
  %141 = fadd double %1, %2
  %142 = tail call double @llvm.fabs.f64(double %141)
  %143 = getelementptr inbounds i8, ptr %0, i64 944
  %144 = getelementptr inbounds i8, ptr %0, i64 936
  %145 = getelementptr inbounds i8, ptr %0, i64 992
  %146 = getelementptr inbounds i8, ptr %24, i64 48
  %147 = icmp sgt i64 %12, 0
  %148 = getelementptr inbounds i8, ptr %24, i64 48
  %149 = icmp sgt i64 %12, 0
  %150 = getelementptr inbounds i8, ptr %0, i64 944
  %151 = getelementptr inbounds i8, ptr %0, i64 936
  br label %152

152:                                              ; preds = %97, %917
  %153 = phi i1 [ false, %97 ], [ %921, %917 ]
  %154 = phi i64 [ -4, %97 ], [ %915, %917 ]
  %155 = phi double [ 0.000000e+00, %97 ], [ %914, %917 ]
  %156 = phi i32 [ 1, %97 ], [ %920, %917 ]
  %157 = zext nneg i32 %156 to i64
  %158 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %157
  %159 = load double, ptr %158, align 8
  %160 = mul nsw i64 %12, %157
  %161 = load ptr, ptr %9, align 8
  %162 = getelementptr inbounds i8, ptr %161, i64 8
  %163 = load i64, ptr %162, align 8
  %164 = icmp sgt i64 %163, 0
  br i1 %164, label %165, label %206

165:                                              ; preds = %152
  %166 = add nsw i32 %156, -1
  %167 = icmp ugt i32 %156, 1
  %168 = select i1 %167, i32 %166, i32 1
  %169 = tail call i32 @llvm.smin.i32(i32 %156, i32 3)
  %170 = icmp sgt i32 %168, %169
  %171 = zext nneg i32 %156 to i64
  %172 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %171
  br label %176

173:                                              ; preds = %203
  %174 = add nuw nsw i64 %178, 1
  %175 = icmp eq i64 %174, %163
  br i1 %175, label %206, label %176, !llvm.loop !6

176:                                              ; preds = %165, %173
  %177 = phi double [ 2.000000e+00, %165 ], [ %205, %173 ]
  %178 = phi i64 [ 0, %165 ], [ %174, %173 ]
  %179 = load ptr, ptr %15, align 8
  %180 = getelementptr inbounds i64, ptr %179, i64 %178
  %181 = load i64, ptr %180, align 8
  %182 = sitofp i64 %181 to double
  br i1 %170, label %203, label %187

183:                                              ; preds = %201
  %184 = add i32 %189, 1
  %185 = icmp sge i32 %189, %169
  %186 = icmp eq i32 %189, %169
  br i1 %186, label %203, label %187, !llvm.loop !7

187:                                              ; preds = %176, %183
  %188 = phi i1 [ %185, %183 ], [ %170, %176 ]
  %189 = phi i32 [ %184, %183 ], [ %168, %176 ]
  %190 = phi double [ %202, %183 ], [ %177, %176 ]
  %191 = call fastcc double @least_place(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, i64 noundef %178, double noundef %182, i32 noundef %189, i32 noundef %156) #8
  %192 = fcmp une double %191, -4.000000e+00
  %193 = fcmp ogt double %191, %155
  %194 = and i1 %192, %193
  br i1 %194, label %195, label %201

195:                                              ; preds = %187
  %196 = load double, ptr %172, align 8
  %197 = fcmp olt double %190, %196
  %198 = select i1 %197, double %190, double %196
  %199 = fcmp olt double %191, %198
  br i1 %199, label %200, label %201

200:                                              ; preds = %195
  br label %201

201:                                              ; preds = %200, %195, %187
  %202 = phi double [ %190, %187 ], [ %191, %200 ], [ %190, %195 ]
  br i1 %192, label %183, label %203

203:                                              ; preds = %183, %201, %176
  %204 = phi i1 [ %170, %176 ], [ %185, %183 ], [ %188, %201 ]
  %205 = phi double [ %177, %176 ], [ %202, %201 ], [ %202, %183 ]
  br i1 %204, label %173, label %206

206:                                              ; preds = %203, %173, %152
  %207 = phi double [ 2.000000e+00, %152 ], [ -4.000000e+00, %203 ], [ %205, %173 ]
  %208 = fcmp olt double %207, 0.000000e+00
  br i1 %208, label %907, label %209

209:                                              ; preds = %206
  %210 = getelementptr double, ptr %28, i64 %160
  %211 = fcmp olt double %207, %159
  br i1 %211, label %212, label %245

212:                                              ; preds = %209
  %213 = load ptr, ptr %25, align 8
  %214 = load ptr, ptr %98, align 8
  %215 = load ptr, ptr %100, align 8
  %216 = insertelement <8 x double> poison, double %207, i64 0
  %217 = shufflevector <8 x double> %216, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %217, ptr %215, align 8
  %218 = load ptr, ptr %99, align 8
  %219 = load ptr, ptr %101, align 8
  %220 = load i64, ptr %102, align 8
  %221 = load ptr, ptr %103, align 8
  %222 = getelementptr inbounds i8, ptr %221, i64 24
  %223 = load i64, ptr %222, align 8
  %224 = load ptr, ptr %100, align 8
  %225 = load ptr, ptr %104, align 8
  %226 = getelementptr inbounds i8, ptr %225, i64 16
  %227 = load i64, ptr %226, align 8
  tail call fastcc void @nested(ptr noundef %214, ptr noundef %218, ptr noundef %219, i64 noundef %220, i64 noundef %223, ptr noundef %224, i64 noundef %227) #8
  %228 = fmul double %207, %2
  %229 = fadd double %228, %1
  %230 = load ptr, ptr %105, align 8
  store double %229, ptr %230, align 8
  %231 = load i64, ptr %106, align 8
  %232 = icmp sgt i64 %231, 0
  br i1 %232, label %233, label %234

233:                                              ; preds = %212
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %234

234:                                              ; preds = %212, %233
  %235 = load ptr, ptr %9, align 8
  %236 = load i64, ptr %235, align 8
  %237 = load ptr, ptr %107, align 8
  %238 = load ptr, ptr %98, align 8
  %239 = load ptr, ptr %108, align 8
  %240 = load ptr, ptr %109, align 8
  %241 = load ptr, ptr %25, align 8
  %242 = inttoptr i64 %236 to ptr
  %243 = tail call i32 %242(ptr noundef %237, ptr noundef %238, ptr noundef %239, ptr noundef %240, ptr noundef %241) #9
  %244 = icmp slt i32 %243, 0
  br i1 %244, label %907, label %245

245:                                              ; preds = %234, %209
  %246 = phi double [ %207, %234 ], [ %159, %209 ]
  %247 = phi ptr [ %213, %234 ], [ %210, %209 ]
  br label %248

248:                                              ; preds = %851, %245
  %249 = phi double [ %155, %245 ], [ %853, %851 ]
  %250 = phi i64 [ %154, %245 ], [ %854, %851 ]
  br i1 %110, label %254, label %251

251:                                              ; preds = %289, %248
  %252 = phi double [ 2.000000e+00, %248 ], [ %290, %289 ]
  %253 = fcmp ogt double %252, 1.000000e+00
  br i1 %253, label %851, label %293

254:                                              ; preds = %248, %289
  %255 = phi i64 [ %291, %289 ], [ 0, %248 ]
  %256 = phi double [ %290, %289 ], [ 2.000000e+00, %248 ]
  %257 = getelementptr inbounds i64, ptr %18, i64 %255
  store i64 0, ptr %257, align 8
  %258 = getelementptr inbounds i64, ptr %16, i64 %255
  %259 = load i64, ptr %258, align 8
  %260 = getelementptr inbounds double, ptr %247, i64 %255
  %261 = load double, ptr %260, align 8
  %262 = getelementptr inbounds i64, ptr %14, i64 %255
  %263 = load i64, ptr %262, align 8
  %264 = icmp slt i64 %259, 0
  %265 = fcmp ogt double %261, 0.000000e+00
  %266 = and i1 %264, %265
  %267 = icmp sgt i64 %263, -1
  %268 = and i1 %266, %267
  br i1 %268, label %276, label %269

269:                                              ; preds = %254
  %270 = icmp sgt i64 %259, 0
  %271 = fcmp olt double %261, 0.000000e+00
  %272 = and i1 %270, %271
  br i1 %272, label %273, label %276

273:                                              ; preds = %269
  %274 = icmp slt i64 %263, 1
  %275 = zext i1 %274 to i32
  br label %276

276:                                              ; preds = %254, %269, %273
  %277 = phi i32 [ 1, %254 ], [ 0, %269 ], [ %275, %273 ]
  %278 = icmp eq i32 %277, 0
  br i1 %278, label %279, label %283

279:                                              ; preds = %276
  %280 = icmp eq i64 %259, 0
  %281 = fcmp ord double %261, 0.000000e+00
  %282 = or i1 %280, %281
  br i1 %282, label %289, label %283

283:                                              ; preds = %279, %276
  %284 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %249, double noundef %246, i64 noundef %255) #8
  %285 = fcmp ole double %284, %249
  %286 = zext i1 %285 to i64
  store i64 %286, ptr %257, align 8
  %287 = fcmp olt double %284, %256
  %288 = select i1 %287, double %284, double %256
  br label %289

289:                                              ; preds = %279, %283
  %290 = phi double [ %288, %283 ], [ %256, %279 ]
  %291 = add nuw nsw i64 %255, 1
  %292 = icmp eq i64 %291, %12
  br i1 %292, label %251, label %254, !llvm.loop !8

293:                                              ; preds = %251
  %294 = load ptr, ptr %111, align 8
  %295 = load ptr, ptr %113, align 8
  %296 = insertelement <8 x double> poison, double %252, i64 0
  %297 = shufflevector <8 x double> %296, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %297, ptr %295, align 8
  %298 = load ptr, ptr %112, align 8
  %299 = load ptr, ptr %114, align 8
  %300 = load i64, ptr %115, align 8
  %301 = load ptr, ptr %116, align 8
  %302 = getelementptr inbounds i8, ptr %301, i64 24
  %303 = load i64, ptr %302, align 8
  %304 = load ptr, ptr %113, align 8
  %305 = load ptr, ptr %117, align 8
  %306 = getelementptr inbounds i8, ptr %305, i64 16
  %307 = load i64, ptr %306, align 8
  tail call fastcc void @nested(ptr noundef %294, ptr noundef %298, ptr noundef %299, i64 noundef %300, i64 noundef %303, ptr noundef %304, i64 noundef %307) #8
  %308 = fmul double %252, %2
  %309 = fadd double %308, %1
  %310 = load ptr, ptr %118, align 8
  store double %309, ptr %310, align 8
  %311 = load i64, ptr %119, align 8
  %312 = icmp sgt i64 %311, 0
  br i1 %312, label %313, label %314

313:                                              ; preds = %293
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %314

314:                                              ; preds = %293, %313
  %315 = load ptr, ptr %9, align 8
  %316 = load i64, ptr %315, align 8
  %317 = load ptr, ptr %120, align 8
  %318 = load ptr, ptr %111, align 8
  %319 = load ptr, ptr %121, align 8
  %320 = load ptr, ptr %122, align 8
  %321 = load ptr, ptr %25, align 8
  %322 = getelementptr inbounds i8, ptr %315, i64 8
  %323 = load i64, ptr %322, align 8
  %324 = getelementptr inbounds double, ptr %321, i64 %323
  %325 = inttoptr i64 %316 to ptr
  %326 = tail call i32 %325(ptr noundef %317, ptr noundef %318, ptr noundef %319, ptr noundef %320, ptr noundef %324) #9
  %327 = icmp slt i32 %326, 0
  br i1 %327, label %329, label %328

328:                                              ; preds = %314
  br i1 %123, label %334, label %430

329:                                              ; preds = %314
  %330 = load ptr, ptr %20, align 8
  %331 = getelementptr inbounds i8, ptr %330, i64 80
  store i64 %23, ptr %331, align 8
  %332 = load ptr, ptr %19, align 8
  %333 = getelementptr inbounds i8, ptr %332, i64 48
  store double 1.000000e+00, ptr %333, align 8
  br label %851

334:                                              ; preds = %328, %424
  %335 = phi i1 [ %428, %424 ], [ %123, %328 ]
  %336 = phi i64 [ %426, %424 ], [ %250, %328 ]
  %337 = phi i64 [ %427, %424 ], [ 0, %328 ]
  %338 = phi double [ %425, %424 ], [ %252, %328 ]
  %339 = getelementptr inbounds i64, ptr %16, i64 %337
  %340 = load i64, ptr %339, align 8
  %341 = getelementptr inbounds double, ptr %31, i64 %337
  %342 = load double, ptr %341, align 8
  %343 = getelementptr inbounds i64, ptr %14, i64 %337
  %344 = load i64, ptr %343, align 8
  %345 = icmp slt i64 %340, 0
  %346 = fcmp ogt double %342, 0.000000e+00
  %347 = and i1 %345, %346
  %348 = icmp sgt i64 %344, -1
  %349 = and i1 %347, %348
  br i1 %349, label %357, label %350

350:                                              ; preds = %334
  %351 = icmp sgt i64 %340, 0
  %352 = fcmp olt double %342, 0.000000e+00
  %353 = and i1 %351, %352
  br i1 %353, label %354, label %357

354:                                              ; preds = %350
  %355 = icmp slt i64 %344, 1
  %356 = zext i1 %355 to i32
  br label %357

357:                                              ; preds = %334, %350, %354
  %358 = phi i32 [ 1, %334 ], [ 0, %350 ], [ %356, %354 ]
  %359 = icmp eq i32 %358, 0
  br i1 %359, label %424, label %360

360:                                              ; preds = %357
  %361 = getelementptr inbounds double, ptr %247, i64 %337
  %362 = load double, ptr %361, align 8
  %363 = fcmp ogt double %362, 0.000000e+00
  %364 = and i1 %345, %363
  %365 = and i1 %348, %364
  br i1 %365, label %373, label %366

366:                                              ; preds = %360
  %367 = icmp sgt i64 %340, 0
  %368 = fcmp olt double %362, 0.000000e+00
  %369 = and i1 %367, %368
  br i1 %369, label %370, label %373

370:                                              ; preds = %366
  %371 = icmp slt i64 %344, 1
  %372 = zext i1 %371 to i32
  br label %373

373:                                              ; preds = %360, %366, %370
  %374 = phi i32 [ 1, %360 ], [ 0, %366 ], [ %372, %370 ]
  %375 = icmp eq i32 %374, 0
  br i1 %375, label %376, label %424

376:                                              ; preds = %373
  %377 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %249, double noundef %338, i64 noundef %337) #8
  %378 = fcmp ogt double %377, %249
  br i1 %378, label %379, label %381

379:                                              ; preds = %376
  %380 = getelementptr inbounds i64, ptr %18, i64 %337
  store i64 2, ptr %380, align 8
  br label %381

381:                                              ; preds = %379, %376
  %382 = phi double [ %377, %379 ], [ %338, %376 ]
  %383 = load ptr, ptr %111, align 8
  %384 = load ptr, ptr %113, align 8
  %385 = insertelement <8 x double> poison, double %382, i64 0
  %386 = shufflevector <8 x double> %385, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %386, ptr %384, align 8
  %387 = load ptr, ptr %112, align 8
  %388 = load ptr, ptr %114, align 8
  %389 = load i64, ptr %115, align 8
  %390 = load ptr, ptr %116, align 8
  %391 = getelementptr inbounds i8, ptr %390, i64 24
  %392 = load i64, ptr %391, align 8
  %393 = load ptr, ptr %113, align 8
  %394 = load ptr, ptr %117, align 8
  %395 = getelementptr inbounds i8, ptr %394, i64 16
  %396 = load i64, ptr %395, align 8
  tail call fastcc void @nested(ptr noundef %383, ptr noundef %387, ptr noundef %388, i64 noundef %389, i64 noundef %392, ptr noundef %393, i64 noundef %396) #8
  %397 = fmul double %382, %2
  %398 = fadd double %397, %1
  %399 = load ptr, ptr %118, align 8
  store double %398, ptr %399, align 8
  %400 = load i64, ptr %119, align 8
  %401 = icmp sgt i64 %400, 0
  br i1 %401, label %402, label %403

402:                                              ; preds = %381
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %403

403:                                              ; preds = %381, %402
  %404 = load ptr, ptr %9, align 8
  %405 = load i64, ptr %404, align 8
  %406 = load ptr, ptr %120, align 8
  %407 = load ptr, ptr %111, align 8
  %408 = load ptr, ptr %121, align 8
  %409 = load ptr, ptr %122, align 8
  %410 = load ptr, ptr %25, align 8
  %411 = getelementptr inbounds i8, ptr %404, i64 8
  %412 = load i64, ptr %411, align 8
  %413 = getelementptr inbounds double, ptr %410, i64 %412
  %414 = inttoptr i64 %405 to ptr
  %415 = tail call i32 %414(ptr noundef %406, ptr noundef %407, ptr noundef %408, ptr noundef %409, ptr noundef %413) #9
  %416 = icmp sgt i32 %415, -1
  br i1 %416, label %422, label %417

417:                                              ; preds = %403
  %418 = load ptr, ptr %20, align 8
  %419 = getelementptr inbounds i8, ptr %418, i64 80
  store i64 %23, ptr %419, align 8
  %420 = load ptr, ptr %19, align 8
  %421 = getelementptr inbounds i8, ptr %420, i64 48
  store double 1.000000e+00, ptr %421, align 8
  br label %422

422:                                              ; preds = %403, %417
  %423 = phi i64 [ -4, %417 ], [ %336, %403 ]
  br i1 %416, label %424, label %430

424:                                              ; preds = %357, %373, %422
  %425 = phi double [ %338, %373 ], [ %382, %422 ], [ %338, %357 ]
  %426 = phi i64 [ %336, %373 ], [ %423, %422 ], [ %336, %357 ]
  %427 = add nuw nsw i64 %337, 1
  %428 = icmp slt i64 %427, %12
  %429 = icmp eq i64 %427, %12
  br i1 %429, label %430, label %334, !llvm.loop !9

430:                                              ; preds = %422, %424, %328
  %431 = phi i1 [ %123, %328 ], [ %335, %422 ], [ %428, %424 ]
  %432 = phi i32 [ 13, %328 ], [ 1, %422 ], [ 13, %424 ]
  %433 = phi double [ %252, %328 ], [ %382, %422 ], [ %425, %424 ]
  %434 = phi i64 [ %250, %328 ], [ %423, %422 ], [ %426, %424 ]
  br i1 %431, label %851, label %435

435:                                              ; preds = %430
  br i1 %124, label %446, label %438

436:                                              ; preds = %533
  %437 = zext i1 %534 to i32
  br label %438

438:                                              ; preds = %436, %435
  %439 = phi i32 [ 0, %435 ], [ %437, %436 ]
  %440 = phi i64 [ -1, %435 ], [ %523, %436 ]
  %441 = icmp eq i32 %439, 0
  br i1 %441, label %442, label %537

442:                                              ; preds = %438
  br i1 %133, label %443, label %663

443:                                              ; preds = %442
  %444 = fmul double %433, %2
  %445 = fadd double %444, %1
  br label %784

446:                                              ; preds = %435, %533
  %447 = phi i64 [ %535, %533 ], [ 0, %435 ]
  %448 = phi i64 [ %523, %533 ], [ -1, %435 ]
  %449 = phi i1 [ %534, %533 ], [ false, %435 ]
  %450 = getelementptr inbounds double, ptr %31, i64 %447
  %451 = load double, ptr %450, align 8
  %452 = getelementptr inbounds i64, ptr %16, i64 %447
  %453 = load i64, ptr %452, align 8
  %454 = getelementptr inbounds i64, ptr %14, i64 %447
  %455 = load i64, ptr %454, align 8
  %456 = icmp slt i64 %453, 0
  %457 = fcmp ogt double %451, 0.000000e+00
  %458 = and i1 %457, %456
  %459 = icmp sgt i64 %455, -1
  %460 = and i1 %458, %459
  br i1 %460, label %468, label %461

461:                                              ; preds = %446
  %462 = icmp sgt i64 %453, 0
  %463 = fcmp olt double %451, 0.000000e+00
  %464 = and i1 %463, %462
  br i1 %464, label %465, label %468

465:                                              ; preds = %461
  %466 = icmp slt i64 %455, 1
  %467 = zext i1 %466 to i32
  br label %468

468:                                              ; preds = %446, %461, %465
  %469 = phi i32 [ 1, %446 ], [ 0, %461 ], [ %467, %465 ]
  %470 = icmp eq i32 %469, 0
  br i1 %470, label %471, label %496

471:                                              ; preds = %468
  %472 = getelementptr inbounds double, ptr %247, i64 %447
  %473 = load double, ptr %472, align 8
  %474 = fcmp ogt double %473, 0.000000e+00
  %475 = and i1 %456, %474
  %476 = and i1 %459, %475
  br i1 %476, label %484, label %477

477:                                              ; preds = %471
  %478 = icmp sgt i64 %453, 0
  %479 = fcmp olt double %473, 0.000000e+00
  %480 = and i1 %478, %479
  br i1 %480, label %481, label %484

481:                                              ; preds = %477
  %482 = icmp slt i64 %455, 1
  %483 = zext i1 %482 to i32
  br label %484

484:                                              ; preds = %471, %477, %481
  %485 = phi i32 [ 1, %471 ], [ 0, %477 ], [ %483, %481 ]
  %486 = icmp eq i32 %485, 0
  br i1 %486, label %496, label %487

487:                                              ; preds = %484
  %488 = fcmp oeq double %451, 0.000000e+00
  br i1 %488, label %493, label %489

489:                                              ; preds = %487
  %490 = getelementptr inbounds i64, ptr %18, i64 %447
  %491 = load i64, ptr %490, align 8
  %492 = icmp eq i64 %491, 1
  br label %493

493:                                              ; preds = %489, %487
  %494 = phi i1 [ true, %487 ], [ %492, %489 ]
  %495 = zext i1 %494 to i32
  br label %496

496:                                              ; preds = %493, %484, %468
  %497 = phi i32 [ 1, %468 ], [ %495, %493 ], [ 0, %484 ]
  %498 = icmp eq i32 %497, 0
  br i1 %498, label %499, label %505

499:                                              ; preds = %496
  %500 = getelementptr inbounds i64, ptr %18, i64 %447
  %501 = load i64, ptr %500, align 8
  %502 = icmp eq i64 %501, 2
  %503 = fcmp oeq double %451, 0.000000e+00
  %504 = and i1 %503, %502
  br label %505

505:                                              ; preds = %499, %496
  %506 = phi i1 [ true, %496 ], [ %504, %499 ]
  br i1 %506, label %522, label %507

507:                                              ; preds = %505
  %508 = getelementptr inbounds double, ptr %247, i64 %447
  %509 = load double, ptr %508, align 8
  %510 = icmp eq i64 %453, 0
  %511 = fcmp ord double %509, 0.000000e+00
  %512 = or i1 %510, %511
  br i1 %512, label %522, label %513

513:                                              ; preds = %507
  %514 = sitofp i64 %453 to double
  %515 = fmul double %451, %514
  %516 = fcmp olt double %515, 0.000000e+00
  br i1 %516, label %517, label %519

517:                                              ; preds = %513
  %518 = sub nsw i64 0, %453
  store i64 %518, ptr %452, align 8
  br label %522

519:                                              ; preds = %513
  %520 = fcmp ueq double %451, 0.000000e+00
  %521 = select i1 %520, i64 %447, i64 %448
  br label %522

522:                                              ; preds = %519, %517, %507, %505
  %523 = phi i64 [ %448, %505 ], [ %448, %517 ], [ %448, %507 ], [ %521, %519 ]
  %524 = zext i1 %506 to i64
  %525 = getelementptr inbounds i64, ptr %18, i64 %447
  store i64 %524, ptr %525, align 8
  %526 = xor i1 %506, true
  %527 = or i1 %449, %526
  br i1 %527, label %533, label %528

528:                                              ; preds = %522
  %529 = load ptr, ptr %125, align 8
  %530 = getelementptr inbounds i64, ptr %529, i64 %447
  %531 = load i64, ptr %530, align 8
  %532 = icmp eq i64 %531, 1
  br label %533

533:                                              ; preds = %522, %528
  %534 = phi i1 [ %449, %522 ], [ %532, %528 ]
  %535 = add nuw nsw i64 %447, 1
  %536 = icmp eq i64 %535, %12
  br i1 %536, label %436, label %446, !llvm.loop !10

537:                                              ; preds = %438
  store double %433, ptr %126, align 8
  %538 = load ptr, ptr %9, align 8
  %539 = getelementptr inbounds i8, ptr %538, i64 8
  %540 = load i64, ptr %539, align 8
  %541 = load ptr, ptr %25, align 8
  %542 = getelementptr inbounds double, ptr %541, i64 %540
  %543 = mul i64 %540, 56
  %544 = getelementptr inbounds i8, ptr %541, i64 %543
  %545 = load ptr, ptr %127, align 8
  %546 = load i64, ptr %128, align 8
  %547 = getelementptr double, ptr %545, i64 %546
  %548 = getelementptr i8, ptr %547, i64 -8
  %549 = load double, ptr %548, align 8
  %550 = load double, ptr %545, align 8
  %551 = fsub double %549, %550
  %552 = icmp sgt i64 %540, 0
  br i1 %552, label %556, label %553

553:                                              ; preds = %569, %537
  %554 = phi i32 [ 0, %537 ], [ %571, %569 ]
  %555 = icmp eq i32 %554, 0
  br i1 %555, label %851, label %574

556:                                              ; preds = %537, %569
  %557 = phi i64 [ %572, %569 ], [ 0, %537 ]
  %558 = phi i32 [ %571, %569 ], [ 0, %537 ]
  %559 = icmp eq i32 %558, 0
  br i1 %559, label %560, label %569

560:                                              ; preds = %556
  %561 = load ptr, ptr %17, align 8
  %562 = getelementptr inbounds i64, ptr %561, i64 %557
  %563 = load i64, ptr %562, align 8
  %564 = icmp eq i64 %563, 0
  br i1 %564, label %569, label %565

565:                                              ; preds = %560
  %566 = getelementptr inbounds double, ptr %542, i64 %557
  %567 = load double, ptr %566, align 8
  %568 = fcmp oeq double %567, 0.000000e+00
  br label %569

569:                                              ; preds = %565, %560, %556
  %570 = phi i1 [ true, %556 ], [ false, %560 ], [ %568, %565 ]
  %571 = zext i1 %570 to i32
  %572 = add nuw nsw i64 %557, 1
  %573 = icmp eq i64 %572, %540
  br i1 %573, label %553, label %556, !llvm.loop !11

574:                                              ; preds = %553
  %575 = fsub double %246, %433
  %576 = fmul double %575, %2
  %577 = fcmp ogt double %130, %551
  %578 = select i1 %577, double %130, double %551
  %579 = fmul double %578, 0x3F50000000000000
  %580 = fcmp ugt double %576, %579
  br i1 %580, label %581, label %851

581:                                              ; preds = %574
  %582 = fmul double %575, 0x3F50000000000000
  %583 = fadd double %433, %582
  %584 = load ptr, ptr %111, align 8
  %585 = load ptr, ptr %113, align 8
  %586 = insertelement <8 x double> poison, double %583, i64 0
  %587 = shufflevector <8 x double> %586, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %587, ptr %585, align 8
  %588 = load ptr, ptr %112, align 8
  %589 = load ptr, ptr %114, align 8
  %590 = load i64, ptr %115, align 8
  %591 = load ptr, ptr %116, align 8
  %592 = getelementptr inbounds i8, ptr %591, i64 24
  %593 = load i64, ptr %592, align 8
  %594 = load ptr, ptr %113, align 8
  %595 = load ptr, ptr %117, align 8
  %596 = getelementptr inbounds i8, ptr %595, i64 16
  %597 = load i64, ptr %596, align 8
  tail call fastcc void @nested(ptr noundef %584, ptr noundef %588, ptr noundef %589, i64 noundef %590, i64 noundef %593, ptr noundef %594, i64 noundef %597) #8
  %598 = fmul double %583, %2
  %599 = fadd double %598, %1
  %600 = load ptr, ptr %118, align 8
  store double %599, ptr %600, align 8
  %601 = load i64, ptr %119, align 8
  %602 = icmp sgt i64 %601, 0
  br i1 %602, label %603, label %604

603:                                              ; preds = %581
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %604

604:                                              ; preds = %581, %603
  %605 = load ptr, ptr %9, align 8
  %606 = load i64, ptr %605, align 8
  %607 = load ptr, ptr %120, align 8
  %608 = load ptr, ptr %111, align 8
  %609 = load ptr, ptr %121, align 8
  %610 = load ptr, ptr %122, align 8
  %611 = load ptr, ptr %25, align 8
  %612 = getelementptr inbounds i8, ptr %605, i64 8
  %613 = load i64, ptr %612, align 8
  %614 = mul i64 %613, 56
  %615 = getelementptr inbounds i8, ptr %611, i64 %614
  %616 = inttoptr i64 %606 to ptr
  %617 = tail call i32 %616(ptr noundef %607, ptr noundef %608, ptr noundef %609, ptr noundef %610, ptr noundef %615) #9
  %618 = icmp slt i32 %617, 0
  br i1 %618, label %658, label %619

619:                                              ; preds = %604
  %620 = icmp sgt i64 %540, 0
  br i1 %620, label %621, label %851

621:                                              ; preds = %619
  %622 = fmul double %433, %2
  %623 = fadd double %622, %1
  %624 = fsub double %623, %623
  br label %625

625:                                              ; preds = %621, %655
  %626 = phi i64 [ 0, %621 ], [ %656, %655 ]
  %627 = load ptr, ptr %17, align 8
  %628 = getelementptr inbounds i64, ptr %627, i64 %626
  %629 = load i64, ptr %628, align 8
  %630 = icmp eq i64 %629, 0
  br i1 %630, label %655, label %631

631:                                              ; preds = %625
  %632 = getelementptr inbounds double, ptr %542, i64 %626
  %633 = load double, ptr %632, align 8
  %634 = fcmp oeq double %633, 0.000000e+00
  br i1 %634, label %635, label %655

635:                                              ; preds = %631
  %636 = getelementptr inbounds double, ptr %544, i64 %626
  %637 = load double, ptr %636, align 8
  %638 = fcmp oeq double %637, 0.000000e+00
  br i1 %638, label %639, label %655

639:                                              ; preds = %635
  %640 = load i64, ptr %131, align 8
  %641 = icmp eq i64 %640, 0
  br i1 %641, label %655, label %642

642:                                              ; preds = %639
  %643 = load ptr, ptr %132, align 8
  %644 = shl nsw i64 %626, 4
  %645 = getelementptr inbounds i8, ptr %643, i64 %644
  %646 = getelementptr inbounds i8, ptr %645, i64 8
  %647 = load double, ptr %646, align 8
  %648 = fcmp oeq double %647, %623
  br i1 %648, label %654, label %649

649:                                              ; preds = %642
  %650 = load double, ptr %645, align 8
  %651 = fsub double %647, %650
  %652 = fcmp ult double %651, %624
  br i1 %652, label %653, label %655

653:                                              ; preds = %649
  store double %623, ptr %645, align 8
  br label %654

654:                                              ; preds = %642, %653
  store double %623, ptr %646, align 8
  br label %655

655:                                              ; preds = %654, %649, %639, %635, %631, %625
  %656 = add nuw nsw i64 %626, 1
  %657 = icmp eq i64 %656, %540
  br i1 %657, label %851, label %625, !llvm.loop !12

658:                                              ; preds = %604
  %659 = load ptr, ptr %20, align 8
  %660 = getelementptr inbounds i8, ptr %659, i64 80
  store i64 %23, ptr %660, align 8
  %661 = load ptr, ptr %19, align 8
  %662 = getelementptr inbounds i8, ptr %661, i64 48
  store double 1.000000e+00, ptr %662, align 8
  br label %851

663:                                              ; preds = %824, %442
  %664 = load ptr, ptr %9, align 8
  %665 = getelementptr inbounds i8, ptr %664, i64 8
  %666 = load i64, ptr %665, align 8
  %667 = load ptr, ptr %25, align 8
  %668 = getelementptr inbounds double, ptr %667, i64 %666
  %669 = mul i64 %666, 56
  %670 = getelementptr inbounds i8, ptr %667, i64 %669
  %671 = load ptr, ptr %139, align 8
  %672 = load i64, ptr %140, align 8
  %673 = getelementptr double, ptr %671, i64 %672
  %674 = getelementptr i8, ptr %673, i64 -8
  %675 = load double, ptr %674, align 8
  %676 = load double, ptr %671, align 8
  %677 = fsub double %675, %676
  %678 = icmp sgt i64 %666, 0
  br i1 %678, label %682, label %679

679:                                              ; preds = %695, %663
  %680 = phi i32 [ 0, %663 ], [ %697, %695 ]
  %681 = icmp eq i32 %680, 0
  br i1 %681, label %832, label %700

682:                                              ; preds = %663, %695
  %683 = phi i64 [ %698, %695 ], [ 0, %663 ]
  %684 = phi i32 [ %697, %695 ], [ 0, %663 ]
  %685 = icmp eq i32 %684, 0
  br i1 %685, label %686, label %695

686:                                              ; preds = %682
  %687 = load ptr, ptr %17, align 8
  %688 = getelementptr inbounds i64, ptr %687, i64 %683
  %689 = load i64, ptr %688, align 8
  %690 = icmp eq i64 %689, 0
  br i1 %690, label %695, label %691

691:                                              ; preds = %686
  %692 = getelementptr inbounds double, ptr %668, i64 %683
  %693 = load double, ptr %692, align 8
  %694 = fcmp oeq double %693, 0.000000e+00
  br label %695

695:                                              ; preds = %691, %686, %682
  %696 = phi i1 [ true, %682 ], [ false, %686 ], [ %694, %691 ]
  %697 = zext i1 %696 to i32
  %698 = add nuw nsw i64 %683, 1
  %699 = icmp eq i64 %698, %666
  br i1 %699, label %679, label %682, !llvm.loop !11

700:                                              ; preds = %679
  %701 = fsub double %246, %433
  %702 = fmul double %701, %2
  %703 = fcmp ogt double %142, %677
  %704 = select i1 %703, double %142, double %677
  %705 = fmul double %704, 0x3F50000000000000
  %706 = fcmp ugt double %702, %705
  br i1 %706, label %707, label %832

707:                                              ; preds = %700
  %708 = fmul double %701, 0x3F50000000000000
  %709 = fadd double %433, %708
  %710 = load ptr, ptr %111, align 8
  %711 = load ptr, ptr %113, align 8
  %712 = insertelement <8 x double> poison, double %709, i64 0
  %713 = shufflevector <8 x double> %712, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %713, ptr %711, align 8
  %714 = load ptr, ptr %112, align 8
  %715 = load ptr, ptr %114, align 8
  %716 = load i64, ptr %115, align 8
  %717 = load ptr, ptr %116, align 8
  %718 = getelementptr inbounds i8, ptr %717, i64 24
  %719 = load i64, ptr %718, align 8
  %720 = load ptr, ptr %113, align 8
  %721 = load ptr, ptr %117, align 8
  %722 = getelementptr inbounds i8, ptr %721, i64 16
  %723 = load i64, ptr %722, align 8
  tail call fastcc void @nested(ptr noundef %710, ptr noundef %714, ptr noundef %715, i64 noundef %716, i64 noundef %719, ptr noundef %720, i64 noundef %723) #8
  %724 = fmul double %709, %2
  %725 = fadd double %724, %1
  %726 = load ptr, ptr %118, align 8
  store double %725, ptr %726, align 8
  %727 = load i64, ptr %119, align 8
  %728 = icmp sgt i64 %727, 0
  br i1 %728, label %729, label %730

729:                                              ; preds = %707
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %730

730:                                              ; preds = %707, %729
  %731 = load ptr, ptr %9, align 8
  %732 = load i64, ptr %731, align 8
  %733 = load ptr, ptr %120, align 8
  %734 = load ptr, ptr %111, align 8
  %735 = load ptr, ptr %121, align 8
  %736 = load ptr, ptr %122, align 8
  %737 = load ptr, ptr %25, align 8
  %738 = getelementptr inbounds i8, ptr %731, i64 8
  %739 = load i64, ptr %738, align 8
  %740 = mul i64 %739, 56
  %741 = getelementptr inbounds i8, ptr %737, i64 %740
  %742 = inttoptr i64 %732 to ptr
  %743 = tail call i32 %742(ptr noundef %733, ptr noundef %734, ptr noundef %735, ptr noundef %736, ptr noundef %741) #9
  %744 = icmp slt i32 %743, 0
  br i1 %744, label %827, label %745

745:                                              ; preds = %730
  %746 = icmp sgt i64 %666, 0
  br i1 %746, label %747, label %832

747:                                              ; preds = %745
  %748 = fmul double %433, %2
  %749 = fadd double %748, %1
  %750 = fsub double %749, %749
  br label %751

751:                                              ; preds = %747, %781
  %752 = phi i64 [ 0, %747 ], [ %782, %781 ]
  %753 = load ptr, ptr %17, align 8
  %754 = getelementptr inbounds i64, ptr %753, i64 %752
  %755 = load i64, ptr %754, align 8
  %756 = icmp eq i64 %755, 0
  br i1 %756, label %781, label %757

757:                                              ; preds = %751
  %758 = getelementptr inbounds double, ptr %668, i64 %752
  %759 = load double, ptr %758, align 8
  %760 = fcmp oeq double %759, 0.000000e+00
  br i1 %760, label %761, label %781

761:                                              ; preds = %757
  %762 = getelementptr inbounds double, ptr %670, i64 %752
  %763 = load double, ptr %762, align 8
  %764 = fcmp oeq double %763, 0.000000e+00
  br i1 %764, label %765, label %781

765:                                              ; preds = %761
  %766 = load i64, ptr %143, align 8
  %767 = icmp eq i64 %766, 0
  br i1 %767, label %781, label %768

768:                                              ; preds = %765
  %769 = load ptr, ptr %144, align 8
  %770 = shl nsw i64 %752, 4
  %771 = getelementptr inbounds i8, ptr %769, i64 %770
  %772 = getelementptr inbounds i8, ptr %771, i64 8
  %773 = load double, ptr %772, align 8
  %774 = fcmp oeq double %773, %749
  br i1 %774, label %780, label %775

775:                                              ; preds = %768
  %776 = load double, ptr %771, align 8
  %777 = fsub double %773, %776
  %778 = fcmp ult double %777, %750
  br i1 %778, label %779, label %781

779:                                              ; preds = %775
  store double %749, ptr %771, align 8
  br label %780

780:                                              ; preds = %768, %779
  store double %749, ptr %772, align 8
  br label %781

781:                                              ; preds = %780, %775, %765, %761, %757, %751
  %782 = add nuw nsw i64 %752, 1
  %783 = icmp eq i64 %782, %666
  br i1 %783, label %832, label %751, !llvm.loop !12

784:                                              ; preds = %443, %824
  %785 = phi i64 [ 0, %443 ], [ %825, %824 ]
  %786 = getelementptr inbounds i64, ptr %18, i64 %785
  %787 = load i64, ptr %786, align 8
  %788 = icmp eq i64 %787, 0
  br i1 %788, label %824, label %789

789:                                              ; preds = %784
  %790 = load ptr, ptr %20, align 8
  %791 = getelementptr inbounds i8, ptr %790, i64 80
  %792 = load i64, ptr %791, align 8
  %793 = load ptr, ptr %6, align 8
  %794 = getelementptr inbounds i8, ptr %793, i64 8
  %795 = load i64, ptr %794, align 8
  %796 = load i64, ptr %134, align 8
  %797 = icmp eq i64 %796, 0
  br i1 %797, label %820, label %798

798:                                              ; preds = %789
  %799 = load ptr, ptr %135, align 8
  %800 = getelementptr inbounds double, ptr %799, i64 %792
  store double %445, ptr %800, align 8
  %801 = load ptr, ptr %136, align 8
  %802 = getelementptr inbounds i64, ptr %801, i64 %792
  store i64 %785, ptr %802, align 8
  %803 = icmp sgt i64 %795, 0
  br i1 %803, label %808, label %804

804:                                              ; preds = %808, %798
  %805 = add nsw i64 %792, 1
  %806 = load ptr, ptr %20, align 8
  %807 = getelementptr inbounds i8, ptr %806, i64 80
  store i64 %805, ptr %807, align 8
  br label %820

808:                                              ; preds = %798, %808
  %809 = phi i64 [ %818, %808 ], [ 0, %798 ]
  %810 = load ptr, ptr %111, align 8
  %811 = getelementptr inbounds double, ptr %810, i64 %809
  %812 = load double, ptr %811, align 8
  %813 = load ptr, ptr %137, align 8
  %814 = load i64, ptr %138, align 8
  %815 = mul nsw i64 %814, %792
  %816 = getelementptr double, ptr %813, i64 %815
  %817 = getelementptr double, ptr %816, i64 %809
  store double %812, ptr %817, align 8
  %818 = add nuw nsw i64 %809, 1
  %819 = icmp eq i64 %818, %795
  br i1 %819, label %804, label %808, !llvm.loop !13

820:                                              ; preds = %789, %804
  %821 = getelementptr inbounds i64, ptr %16, i64 %785
  %822 = load i64, ptr %821, align 8
  %823 = sub nsw i64 0, %822
  store i64 %823, ptr %821, align 8
  br label %824

824:                                              ; preds = %784, %820
  %825 = add nuw nsw i64 %785, 1
  %826 = icmp eq i64 %825, %12
  br i1 %826, label %663, label %784, !llvm.loop !14

827:                                              ; preds = %730
  %828 = load ptr, ptr %20, align 8
  %829 = getelementptr inbounds i8, ptr %828, i64 80
  store i64 %23, ptr %829, align 8
  %830 = load ptr, ptr %19, align 8
  %831 = getelementptr inbounds i8, ptr %830, i64 48
  store double 1.000000e+00, ptr %831, align 8
  br label %851

832:                                              ; preds = %781, %745, %700, %679
  %833 = icmp sgt i64 %440, -1
  br i1 %833, label %834, label %843

834:                                              ; preds = %832
  br i1 %147, label %836, label %835

835:                                              ; preds = %836, %834
  store double %433, ptr %148, align 8
  br label %851

836:                                              ; preds = %834, %836
  %837 = phi i64 [ %841, %836 ], [ 0, %834 ]
  %838 = icmp eq i64 %837, %440
  %839 = zext i1 %838 to i64
  %840 = getelementptr inbounds i64, ptr %18, i64 %837
  store i64 %839, ptr %840, align 8
  %841 = add nuw nsw i64 %837, 1
  %842 = icmp eq i64 %841, %12
  br i1 %842, label %835, label %836, !llvm.loop !15

843:                                              ; preds = %832
  %844 = load i64, ptr %145, align 8
  %845 = icmp sgt i64 %844, 0
  br i1 %845, label %846, label %851

846:                                              ; preds = %843
  %847 = load i64, ptr %22, align 8
  %848 = add nsw i64 %847, %12
  %849 = icmp sgt i64 %848, %844
  br i1 %849, label %850, label %851

850:                                              ; preds = %846
  store double %433, ptr %146, align 8
  br label %851

851:                                              ; preds = %655, %619, %574, %553, %827, %835, %850, %658, %846, %843, %251, %430, %329
  %852 = phi i32 [ 1, %329 ], [ %432, %430 ], [ 8, %251 ], [ 1, %827 ], [ 1, %835 ], [ 1, %850 ], [ 1, %658 ], [ 0, %846 ], [ 0, %843 ], [ 1, %553 ], [ 1, %574 ], [ 1, %619 ], [ 1, %655 ]
  %853 = phi double [ %249, %329 ], [ %249, %430 ], [ %249, %251 ], [ %249, %827 ], [ %249, %835 ], [ %249, %850 ], [ %249, %658 ], [ %433, %846 ], [ %433, %843 ], [ %249, %553 ], [ %249, %574 ], [ %249, %619 ], [ %249, %655 ]
  %854 = phi i64 [ -4, %329 ], [ %434, %430 ], [ %250, %251 ], [ -4, %827 ], [ 21, %835 ], [ -3, %850 ], [ -4, %658 ], [ %434, %846 ], [ %434, %843 ], [ -2, %553 ], [ -2, %574 ], [ -2, %619 ], [ -2, %655 ]
  switch i32 %852, label %912 [
    i32 0, label %248
    i32 8, label %855
  ], !llvm.loop !16

855:                                              ; preds = %851
  br i1 %149, label %856, label %912

856:                                              ; preds = %855
  %857 = fcmp oeq double %246, %159
  %858 = add nsw i32 %156, -1
  %859 = sext i32 %858 to i64
  %860 = mul nsw i64 %12, %859
  %861 = getelementptr double, ptr %28, i64 %860
  %862 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %859
  %863 = fmul double %246, %2
  %864 = fadd double %863, %1
  br label %865

865:                                              ; preds = %856, %904
  %866 = phi i64 [ 0, %856 ], [ %905, %904 ]
  %867 = getelementptr inbounds double, ptr %247, i64 %866
  %868 = load double, ptr %867, align 8
  %869 = fcmp ogt double %868, 0.000000e+00
  br i1 %869, label %872, label %870

870:                                              ; preds = %865
  %871 = fcmp olt double %868, 0.000000e+00
  br i1 %871, label %872, label %875

872:                                              ; preds = %870, %865
  %873 = phi i64 [ 1, %865 ], [ -1, %870 ]
  %874 = getelementptr inbounds i64, ptr %16, i64 %866
  store i64 %873, ptr %874, align 8
  br label %875

875:                                              ; preds = %872, %870
  br i1 %857, label %876, label %904

876:                                              ; preds = %875
  %877 = getelementptr double, ptr %861, i64 %866
  %878 = load double, ptr %877, align 8
  %879 = fcmp oeq double %878, 0.000000e+00
  br i1 %879, label %880, label %904

880:                                              ; preds = %876
  %881 = getelementptr double, ptr %210, i64 %866
  %882 = load double, ptr %881, align 8
  %883 = fcmp oeq double %882, 0.000000e+00
  br i1 %883, label %884, label %904

884:                                              ; preds = %880
  %885 = load double, ptr %862, align 8
  %886 = fmul double %885, %2
  %887 = fadd double %886, %1
  %888 = load i64, ptr %150, align 8
  %889 = icmp eq i64 %888, 0
  br i1 %889, label %904, label %890

890:                                              ; preds = %884
  %891 = load ptr, ptr %151, align 8
  %892 = shl nsw i64 %866, 4
  %893 = getelementptr inbounds i8, ptr %891, i64 %892
  %894 = getelementptr inbounds i8, ptr %893, i64 8
  %895 = load double, ptr %894, align 8
  %896 = fcmp oeq double %895, %887
  br i1 %896, label %903, label %897

897:                                              ; preds = %890
  %898 = load double, ptr %893, align 8
  %899 = fsub double %895, %898
  %900 = fsub double %864, %887
  %901 = fcmp ult double %899, %900
  br i1 %901, label %902, label %904

902:                                              ; preds = %897
  store double %887, ptr %893, align 8
  br label %903

903:                                              ; preds = %890, %902
  store double %864, ptr %894, align 8
  br label %904

904:                                              ; preds = %903, %897, %884, %875, %876, %880
  %905 = add nuw nsw i64 %866, 1
  %906 = icmp eq i64 %905, %12
  br i1 %906, label %912, label %865, !llvm.loop !17

907:                                              ; preds = %234, %206
  %908 = load ptr, ptr %20, align 8
  %909 = getelementptr inbounds i8, ptr %908, i64 80
  store i64 %23, ptr %909, align 8
  %910 = load ptr, ptr %19, align 8
  %911 = getelementptr inbounds i8, ptr %910, i64 48
  store double 1.000000e+00, ptr %911, align 8
  br label %912

912:                                              ; preds = %851, %904, %907, %855
  %913 = phi i32 [ 0, %855 ], [ 1, %907 ], [ 0, %904 ], [ %852, %851 ]
  %914 = phi double [ %246, %855 ], [ %155, %907 ], [ %246, %904 ], [ %853, %851 ]
  %915 = phi i64 [ %854, %855 ], [ -4, %907 ], [ %854, %904 ], [ %854, %851 ]
  %916 = icmp eq i32 %913, 0
  br i1 %916, label %917, label %922

917:                                              ; preds = %912
  %918 = fcmp oeq double %914, %159
  %919 = zext i1 %918 to i32
  %920 = add nuw nsw i32 %156, %919
  %921 = icmp ugt i32 %920, 4
  br i1 %921, label %922, label %152, !llvm.loop !18

922:                                              ; preds = %917, %912
  %923 = phi i1 [ %921, %917 ], [ %153, %912 ]
  br i1 %923, label %924, label %942

924:                                              ; preds = %922
  %925 = icmp sgt i64 %12, 0
  br i1 %925, label %926, label %929

926:                                              ; preds = %924
  %927 = shl i64 %12, 5
  %928 = getelementptr i8, ptr %28, i64 %927
  br label %931

929:                                              ; preds = %931, %924
  %930 = load double, ptr %24, align 8
  store double %930, ptr %30, align 8
  br label %938

931:                                              ; preds = %926, %931
  %932 = phi i64 [ 0, %926 ], [ %936, %931 ]
  %933 = getelementptr double, ptr %928, i64 %932
  %934 = load double, ptr %933, align 8
  %935 = getelementptr inbounds double, ptr %28, i64 %932
  store double %934, ptr %935, align 8
  %936 = add nuw nsw i64 %932, 1
  %937 = icmp eq i64 %936, %12
  br i1 %937, label %929, label %931, !llvm.loop !19

938:                                              ; preds = %93, %929, %87
  %939 = phi ptr [ %90, %87 ], [ %24, %929 ], [ %96, %93 ]
  %940 = phi i64 [ -4, %87 ], [ 0, %929 ], [ -4, %93 ]
  %941 = getelementptr inbounds i8, ptr %939, i64 48
  store double 1.000000e+00, ptr %941, align 8
  br label %942

942:                                              ; preds = %938, %922, %91
  %943 = phi i64 [ %915, %922 ], [ %92, %91 ], [ %940, %938 ]
  ret i64 %943
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
  br i1 %83, label %68, label %71, !llvm.loop !20

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
  br i1 %150, label %340, label %98, !llvm.loop !21

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
  br i1 %194, label %211, label %183, !llvm.loop !22

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
  br i1 %210, label %187, label %195, !llvm.loop !23

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
  br i1 %223, label %154, label %161, !llvm.loop !24

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
  br i1 %248, label %336, label %224, !llvm.loop !25

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
  br i1 %309, label %281, label %276, !llvm.loop !26

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
  br i1 %323, label %336, label %250, !llvm.loop !27

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
  br i1 %349, label %350, label %53, !llvm.loop !28

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
  br i1 %128, label %129, label %79, !llvm.loop !29

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
  br i1 %31, label %20, label %19, !llvm.loop !30

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
  br i1 %43, label %32, label %24, !llvm.loop !31
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
  br i1 %55, label %44, label %56, !llvm.loop !32

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
  br i1 %83, label %13, label %12, !llvm.loop !33
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
  br i1 %71, label %207, label %72, !llvm.loop !34

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
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5}
!29 = distinct !{!29, !5}
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5}
