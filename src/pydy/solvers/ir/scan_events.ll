; sources 81c0668eafa9d145602e1fe87d7fe5ffe5d328d2c0485fa0a68c2fbf6985b01a
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
  %15 = getelementptr inbounds i8, ptr %0, i64 888
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %0, i64 912
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 576
  %20 = getelementptr inbounds i8, ptr %0, i64 600
  %21 = load ptr, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %21, i64 80
  %23 = load i64, ptr %22, align 8
  %24 = load ptr, ptr %19, align 8
  %25 = getelementptr inbounds i8, ptr %0, i64 936
  %26 = load ptr, ptr %25, align 8
  %27 = shl nsw i64 %12, 4
  %28 = getelementptr inbounds i8, ptr %26, i64 %27
  %29 = mul i64 %12, 88
  %30 = getelementptr inbounds i8, ptr %26, i64 %29
  %31 = getelementptr inbounds double, ptr %26, i64 %12
  %32 = load double, ptr %30, align 8
  %33 = fcmp oeq double %32, %1
  %34 = getelementptr inbounds i8, ptr %0, i64 984
  %35 = getelementptr inbounds i8, ptr %0, i64 408
  %36 = getelementptr inbounds i8, ptr %0, i64 504
  %37 = getelementptr inbounds i8, ptr %0, i64 320
  %38 = getelementptr inbounds i8, ptr %0, i64 168
  %39 = getelementptr inbounds i8, ptr %0, i64 248
  %40 = getelementptr inbounds i8, ptr %0, i64 168
  %41 = getelementptr inbounds i8, ptr %0, i64 192
  %42 = getelementptr inbounds i8, ptr %0, i64 744
  %43 = zext i1 %33 to i64
  br label %51

44:                                               ; preds = %76
  %45 = add nuw nsw i64 %52, 1
  %46 = icmp eq i64 %45, 5
  br i1 %46, label %47, label %51, !llvm.loop !3

47:                                               ; preds = %44
  %48 = icmp sgt i64 %12, 0
  br i1 %48, label %49, label %99

49:                                               ; preds = %47
  %50 = getelementptr inbounds i8, ptr %0, i64 816
  br label %95

51:                                               ; preds = %3, %44
  %52 = phi i64 [ %43, %3 ], [ %45, %44 ]
  %53 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %52
  %54 = load double, ptr %53, align 8
  %55 = add nuw nsw i64 %52, 2
  %56 = load ptr, ptr %34, align 8
  %57 = load ptr, ptr %35, align 8
  %58 = insertelement <8 x double> poison, double %54, i64 0
  %59 = shufflevector <8 x double> %58, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %59, ptr %57, align 8
  %60 = load ptr, ptr %8, align 8
  %61 = load ptr, ptr %36, align 8
  %62 = load i64, ptr %37, align 8
  %63 = load ptr, ptr %0, align 8
  %64 = getelementptr inbounds i8, ptr %63, i64 24
  %65 = load i64, ptr %64, align 8
  %66 = load ptr, ptr %35, align 8
  %67 = load ptr, ptr %6, align 8
  %68 = getelementptr inbounds i8, ptr %67, i64 16
  %69 = load i64, ptr %68, align 8
  tail call fastcc void @nested(ptr noundef %56, ptr noundef %60, ptr noundef %61, i64 noundef %62, i64 noundef %65, ptr noundef %66, i64 noundef %69) #8
  %70 = fmul double %54, %2
  %71 = fadd double %70, %1
  %72 = load ptr, ptr %38, align 8
  store double %71, ptr %72, align 8
  %73 = load i64, ptr %39, align 8
  %74 = icmp sgt i64 %73, 0
  br i1 %74, label %75, label %76

75:                                               ; preds = %51
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %76

76:                                               ; preds = %51, %75
  %77 = load ptr, ptr %9, align 8
  %78 = load i64, ptr %77, align 8
  %79 = load ptr, ptr %40, align 8
  %80 = load ptr, ptr %34, align 8
  %81 = load ptr, ptr %41, align 8
  %82 = load ptr, ptr %42, align 8
  %83 = load ptr, ptr %25, align 8
  %84 = getelementptr inbounds i8, ptr %77, i64 8
  %85 = load i64, ptr %84, align 8
  %86 = mul nsw i64 %85, %55
  %87 = getelementptr inbounds double, ptr %83, i64 %86
  %88 = inttoptr i64 %78 to ptr
  %89 = tail call i32 %88(ptr noundef %79, ptr noundef %80, ptr noundef %81, ptr noundef %82, ptr noundef %87) #9
  %90 = icmp slt i32 %89, 0
  br i1 %90, label %91, label %44

91:                                               ; preds = %76
  %92 = load ptr, ptr %20, align 8
  %93 = getelementptr inbounds i8, ptr %92, i64 80
  store i64 %23, ptr %93, align 8
  %94 = load ptr, ptr %19, align 8
  br label %965

95:                                               ; preds = %49, %115
  %96 = phi i64 [ 0, %49 ], [ %116, %115 ]
  %97 = load double, ptr %30, align 8
  %98 = fcmp une double %97, %1
  br i1 %98, label %101, label %99

99:                                               ; preds = %95, %115, %47
  %100 = call fastcc i64 @resolve(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2) #8
  switch i64 %100, label %969 [
    i64 0, label %122
    i64 -4, label %118
  ]

101:                                              ; preds = %95
  %102 = load ptr, ptr %50, align 8
  %103 = getelementptr inbounds i64, ptr %102, i64 %96
  %104 = load i64, ptr %103, align 8
  %105 = and i64 %104, 2
  %106 = icmp eq i64 %105, 0
  br i1 %106, label %115, label %107

107:                                              ; preds = %101
  %108 = getelementptr inbounds double, ptr %28, i64 %96
  %109 = load double, ptr %108, align 8
  %110 = fcmp une double %109, 0.000000e+00
  br i1 %110, label %111, label %115

111:                                              ; preds = %107
  %112 = fcmp ogt double %109, 0.000000e+00
  %113 = select i1 %112, i64 1, i64 -1
  %114 = getelementptr inbounds i64, ptr %16, i64 %96
  store i64 %113, ptr %114, align 8
  br label %115

115:                                              ; preds = %101, %107, %111
  %116 = add nuw nsw i64 %96, 1
  %117 = icmp eq i64 %116, %12
  br i1 %117, label %99, label %95, !llvm.loop !6

118:                                              ; preds = %99
  %119 = load ptr, ptr %20, align 8
  %120 = getelementptr inbounds i8, ptr %119, i64 80
  store i64 %23, ptr %120, align 8
  %121 = load ptr, ptr %19, align 8
  br label %965

122:                                              ; preds = %99
  store double 0x7FF8000000000000, ptr %30, align 8
  %123 = getelementptr inbounds i8, ptr %0, i64 984
  %124 = load ptr, ptr %7, align 8
  %125 = getelementptr inbounds i8, ptr %124, i64 96
  %126 = getelementptr inbounds i8, ptr %124, i64 192
  %127 = getelementptr inbounds i8, ptr %124, i64 8
  %128 = load ptr, ptr %4, align 8
  %129 = load ptr, ptr %5, align 8
  %130 = getelementptr inbounds i8, ptr %0, i64 168
  %131 = getelementptr inbounds i8, ptr %0, i64 248
  %132 = getelementptr inbounds i8, ptr %0, i64 168
  %133 = getelementptr inbounds i8, ptr %0, i64 192
  %134 = getelementptr inbounds i8, ptr %0, i64 744
  %135 = icmp sgt i64 %12, 0
  %136 = getelementptr inbounds i8, ptr %0, i64 984
  %137 = load ptr, ptr %7, align 8
  %138 = getelementptr inbounds i8, ptr %137, i64 96
  %139 = getelementptr inbounds i8, ptr %137, i64 192
  %140 = getelementptr inbounds i8, ptr %137, i64 8
  %141 = load ptr, ptr %4, align 8
  %142 = load ptr, ptr %5, align 8
  %143 = getelementptr inbounds i8, ptr %0, i64 168
  %144 = getelementptr inbounds i8, ptr %0, i64 248
  %145 = getelementptr inbounds i8, ptr %0, i64 168
  %146 = getelementptr inbounds i8, ptr %0, i64 192
  %147 = getelementptr inbounds i8, ptr %0, i64 744
  %148 = icmp sgt i64 %12, 0
  %149 = icmp sgt i64 %12, 0
  %150 = getelementptr inbounds i8, ptr %0, i64 792
  %151 = getelementptr inbounds i8, ptr %24, i64 48
  %152 = getelementptr inbounds i8, ptr %0, i64 624
  %153 = getelementptr inbounds i8, ptr %0, i64 632
  %154 = fadd double %1, %2
  %155 = tail call double @llvm.fabs.f64(double %154)
  %156 = getelementptr inbounds i8, ptr %0, i64 968
  %157 = getelementptr inbounds i8, ptr %0, i64 960
  %158 = icmp sgt i64 %12, 0
  %159 = getelementptr inbounds i8, ptr %0, i64 1016
  %160 = getelementptr inbounds i8, ptr %0, i64 1008
  %161 = getelementptr inbounds i8, ptr %0, i64 1032
  %162 = getelementptr inbounds i8, ptr %0, i64 1080
  %163 = getelementptr inbounds i8, ptr %0, i64 1056
  %164 = getelementptr inbounds i8, ptr %0, i64 624
  %165 = getelementptr inbounds i8, ptr %0, i64 632
  %166 = fadd double %1, %2
  %167 = tail call double @llvm.fabs.f64(double %166)
  %168 = getelementptr inbounds i8, ptr %0, i64 968
  %169 = getelementptr inbounds i8, ptr %0, i64 960
  %170 = getelementptr inbounds i8, ptr %0, i64 1016
  %171 = getelementptr inbounds i8, ptr %24, i64 48
  %172 = icmp sgt i64 %12, 0
  %173 = getelementptr inbounds i8, ptr %24, i64 48
  %174 = icmp sgt i64 %12, 0
  %175 = getelementptr inbounds i8, ptr %0, i64 968
  %176 = getelementptr inbounds i8, ptr %0, i64 960
  br label %177

177:                                              ; preds = %122, %944
  %178 = phi i1 [ false, %122 ], [ %948, %944 ]
  %179 = phi i64 [ -4, %122 ], [ %942, %944 ]
  %180 = phi double [ 0.000000e+00, %122 ], [ %941, %944 ]
  %181 = phi i32 [ 1, %122 ], [ %947, %944 ]
  %182 = zext nneg i32 %181 to i64
  %183 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %182
  %184 = load double, ptr %183, align 8
  %185 = mul nsw i64 %12, %182
  %186 = load ptr, ptr %9, align 8
  %187 = getelementptr inbounds i8, ptr %186, i64 8
  %188 = load i64, ptr %187, align 8
  %189 = icmp sgt i64 %188, 0
  br i1 %189, label %190, label %231

190:                                              ; preds = %177
  %191 = add nsw i32 %181, -1
  %192 = icmp ugt i32 %181, 1
  %193 = select i1 %192, i32 %191, i32 1
  %194 = tail call i32 @llvm.smin.i32(i32 %181, i32 3)
  %195 = icmp sgt i32 %193, %194
  %196 = zext nneg i32 %181 to i64
  %197 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %196
  br label %201

198:                                              ; preds = %228
  %199 = add nuw nsw i64 %203, 1
  %200 = icmp eq i64 %199, %188
  br i1 %200, label %231, label %201, !llvm.loop !7

201:                                              ; preds = %190, %198
  %202 = phi double [ 2.000000e+00, %190 ], [ %230, %198 ]
  %203 = phi i64 [ 0, %190 ], [ %199, %198 ]
  %204 = load ptr, ptr %15, align 8
  %205 = getelementptr inbounds i64, ptr %204, i64 %203
  %206 = load i64, ptr %205, align 8
  %207 = sitofp i64 %206 to double
  br i1 %195, label %228, label %212

208:                                              ; preds = %226
  %209 = add i32 %214, 1
  %210 = icmp sge i32 %214, %194
  %211 = icmp eq i32 %214, %194
  br i1 %211, label %228, label %212, !llvm.loop !8

212:                                              ; preds = %201, %208
  %213 = phi i1 [ %210, %208 ], [ %195, %201 ]
  %214 = phi i32 [ %209, %208 ], [ %193, %201 ]
  %215 = phi double [ %227, %208 ], [ %202, %201 ]
  %216 = call fastcc double @least_place(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, i64 noundef %203, double noundef %207, i32 noundef %214, i32 noundef %181) #8
  %217 = fcmp une double %216, -4.000000e+00
  %218 = fcmp ogt double %216, %180
  %219 = and i1 %217, %218
  br i1 %219, label %220, label %226

220:                                              ; preds = %212
  %221 = load double, ptr %197, align 8
  %222 = fcmp olt double %215, %221
  %223 = select i1 %222, double %215, double %221
  %224 = fcmp olt double %216, %223
  br i1 %224, label %225, label %226

225:                                              ; preds = %220
  br label %226

226:                                              ; preds = %225, %220, %212
  %227 = phi double [ %215, %212 ], [ %216, %225 ], [ %215, %220 ]
  br i1 %217, label %208, label %228

228:                                              ; preds = %208, %226, %201
  %229 = phi i1 [ %195, %201 ], [ %210, %208 ], [ %213, %226 ]
  %230 = phi double [ %202, %201 ], [ %227, %226 ], [ %227, %208 ]
  br i1 %229, label %198, label %231

231:                                              ; preds = %228, %198, %177
  %232 = phi double [ 2.000000e+00, %177 ], [ -4.000000e+00, %228 ], [ %230, %198 ]
  %233 = fcmp olt double %232, 0.000000e+00
  br i1 %233, label %934, label %234

234:                                              ; preds = %231
  %235 = getelementptr double, ptr %28, i64 %185
  %236 = fcmp olt double %232, %184
  br i1 %236, label %237, label %270

237:                                              ; preds = %234
  %238 = load ptr, ptr %25, align 8
  %239 = load ptr, ptr %123, align 8
  %240 = load ptr, ptr %125, align 8
  %241 = insertelement <8 x double> poison, double %232, i64 0
  %242 = shufflevector <8 x double> %241, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %242, ptr %240, align 8
  %243 = load ptr, ptr %124, align 8
  %244 = load ptr, ptr %126, align 8
  %245 = load i64, ptr %127, align 8
  %246 = load ptr, ptr %128, align 8
  %247 = getelementptr inbounds i8, ptr %246, i64 24
  %248 = load i64, ptr %247, align 8
  %249 = load ptr, ptr %125, align 8
  %250 = load ptr, ptr %129, align 8
  %251 = getelementptr inbounds i8, ptr %250, i64 16
  %252 = load i64, ptr %251, align 8
  tail call fastcc void @nested(ptr noundef %239, ptr noundef %243, ptr noundef %244, i64 noundef %245, i64 noundef %248, ptr noundef %249, i64 noundef %252) #8
  %253 = fmul double %232, %2
  %254 = fadd double %253, %1
  %255 = load ptr, ptr %130, align 8
  store double %254, ptr %255, align 8
  %256 = load i64, ptr %131, align 8
  %257 = icmp sgt i64 %256, 0
  br i1 %257, label %258, label %259

258:                                              ; preds = %237
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %259

259:                                              ; preds = %237, %258
  %260 = load ptr, ptr %9, align 8
  %261 = load i64, ptr %260, align 8
  %262 = load ptr, ptr %132, align 8
  %263 = load ptr, ptr %123, align 8
  %264 = load ptr, ptr %133, align 8
  %265 = load ptr, ptr %134, align 8
  %266 = load ptr, ptr %25, align 8
  %267 = inttoptr i64 %261 to ptr
  %268 = tail call i32 %267(ptr noundef %262, ptr noundef %263, ptr noundef %264, ptr noundef %265, ptr noundef %266) #9
  %269 = icmp slt i32 %268, 0
  br i1 %269, label %934, label %270

270:                                              ; preds = %259, %234
  %271 = phi double [ %232, %259 ], [ %184, %234 ]
  %272 = phi ptr [ %238, %259 ], [ %235, %234 ]
  br label %273

273:                                              ; preds = %878, %270
  %274 = phi double [ %180, %270 ], [ %880, %878 ]
  %275 = phi i64 [ %179, %270 ], [ %881, %878 ]
  br i1 %135, label %279, label %276

276:                                              ; preds = %314, %273
  %277 = phi double [ 2.000000e+00, %273 ], [ %315, %314 ]
  %278 = fcmp ogt double %277, 1.000000e+00
  br i1 %278, label %878, label %318

279:                                              ; preds = %273, %314
  %280 = phi i64 [ %316, %314 ], [ 0, %273 ]
  %281 = phi double [ %315, %314 ], [ 2.000000e+00, %273 ]
  %282 = getelementptr inbounds i64, ptr %18, i64 %280
  store i64 0, ptr %282, align 8
  %283 = getelementptr inbounds i64, ptr %16, i64 %280
  %284 = load i64, ptr %283, align 8
  %285 = getelementptr inbounds double, ptr %272, i64 %280
  %286 = load double, ptr %285, align 8
  %287 = getelementptr inbounds i64, ptr %14, i64 %280
  %288 = load i64, ptr %287, align 8
  %289 = icmp slt i64 %284, 0
  %290 = fcmp ogt double %286, 0.000000e+00
  %291 = and i1 %289, %290
  %292 = icmp sgt i64 %288, -1
  %293 = and i1 %291, %292
  br i1 %293, label %301, label %294

294:                                              ; preds = %279
  %295 = icmp sgt i64 %284, 0
  %296 = fcmp olt double %286, 0.000000e+00
  %297 = and i1 %295, %296
  br i1 %297, label %298, label %301

298:                                              ; preds = %294
  %299 = icmp slt i64 %288, 1
  %300 = zext i1 %299 to i32
  br label %301

301:                                              ; preds = %279, %294, %298
  %302 = phi i32 [ 1, %279 ], [ 0, %294 ], [ %300, %298 ]
  %303 = icmp eq i32 %302, 0
  br i1 %303, label %304, label %308

304:                                              ; preds = %301
  %305 = icmp eq i64 %284, 0
  %306 = fcmp ord double %286, 0.000000e+00
  %307 = or i1 %305, %306
  br i1 %307, label %314, label %308

308:                                              ; preds = %304, %301
  %309 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %274, double noundef %271, i64 noundef %280) #8
  %310 = fcmp ole double %309, %274
  %311 = zext i1 %310 to i64
  store i64 %311, ptr %282, align 8
  %312 = fcmp olt double %309, %281
  %313 = select i1 %312, double %309, double %281
  br label %314

314:                                              ; preds = %304, %308
  %315 = phi double [ %313, %308 ], [ %281, %304 ]
  %316 = add nuw nsw i64 %280, 1
  %317 = icmp eq i64 %316, %12
  br i1 %317, label %276, label %279, !llvm.loop !9

318:                                              ; preds = %276
  %319 = load ptr, ptr %136, align 8
  %320 = load ptr, ptr %138, align 8
  %321 = insertelement <8 x double> poison, double %277, i64 0
  %322 = shufflevector <8 x double> %321, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %322, ptr %320, align 8
  %323 = load ptr, ptr %137, align 8
  %324 = load ptr, ptr %139, align 8
  %325 = load i64, ptr %140, align 8
  %326 = load ptr, ptr %141, align 8
  %327 = getelementptr inbounds i8, ptr %326, i64 24
  %328 = load i64, ptr %327, align 8
  %329 = load ptr, ptr %138, align 8
  %330 = load ptr, ptr %142, align 8
  %331 = getelementptr inbounds i8, ptr %330, i64 16
  %332 = load i64, ptr %331, align 8
  tail call fastcc void @nested(ptr noundef %319, ptr noundef %323, ptr noundef %324, i64 noundef %325, i64 noundef %328, ptr noundef %329, i64 noundef %332) #8
  %333 = fmul double %277, %2
  %334 = fadd double %333, %1
  %335 = load ptr, ptr %143, align 8
  store double %334, ptr %335, align 8
  %336 = load i64, ptr %144, align 8
  %337 = icmp sgt i64 %336, 0
  br i1 %337, label %338, label %339

338:                                              ; preds = %318
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %339

339:                                              ; preds = %318, %338
  %340 = load ptr, ptr %9, align 8
  %341 = load i64, ptr %340, align 8
  %342 = load ptr, ptr %145, align 8
  %343 = load ptr, ptr %136, align 8
  %344 = load ptr, ptr %146, align 8
  %345 = load ptr, ptr %147, align 8
  %346 = load ptr, ptr %25, align 8
  %347 = getelementptr inbounds i8, ptr %340, i64 8
  %348 = load i64, ptr %347, align 8
  %349 = getelementptr inbounds double, ptr %346, i64 %348
  %350 = inttoptr i64 %341 to ptr
  %351 = tail call i32 %350(ptr noundef %342, ptr noundef %343, ptr noundef %344, ptr noundef %345, ptr noundef %349) #9
  %352 = icmp slt i32 %351, 0
  br i1 %352, label %354, label %353

353:                                              ; preds = %339
  br i1 %148, label %359, label %455

354:                                              ; preds = %339
  %355 = load ptr, ptr %20, align 8
  %356 = getelementptr inbounds i8, ptr %355, i64 80
  store i64 %23, ptr %356, align 8
  %357 = load ptr, ptr %19, align 8
  %358 = getelementptr inbounds i8, ptr %357, i64 48
  store double 1.000000e+00, ptr %358, align 8
  br label %878

359:                                              ; preds = %353, %449
  %360 = phi i1 [ %453, %449 ], [ %148, %353 ]
  %361 = phi i64 [ %451, %449 ], [ %275, %353 ]
  %362 = phi i64 [ %452, %449 ], [ 0, %353 ]
  %363 = phi double [ %450, %449 ], [ %277, %353 ]
  %364 = getelementptr inbounds i64, ptr %16, i64 %362
  %365 = load i64, ptr %364, align 8
  %366 = getelementptr inbounds double, ptr %31, i64 %362
  %367 = load double, ptr %366, align 8
  %368 = getelementptr inbounds i64, ptr %14, i64 %362
  %369 = load i64, ptr %368, align 8
  %370 = icmp slt i64 %365, 0
  %371 = fcmp ogt double %367, 0.000000e+00
  %372 = and i1 %370, %371
  %373 = icmp sgt i64 %369, -1
  %374 = and i1 %372, %373
  br i1 %374, label %382, label %375

375:                                              ; preds = %359
  %376 = icmp sgt i64 %365, 0
  %377 = fcmp olt double %367, 0.000000e+00
  %378 = and i1 %376, %377
  br i1 %378, label %379, label %382

379:                                              ; preds = %375
  %380 = icmp slt i64 %369, 1
  %381 = zext i1 %380 to i32
  br label %382

382:                                              ; preds = %359, %375, %379
  %383 = phi i32 [ 1, %359 ], [ 0, %375 ], [ %381, %379 ]
  %384 = icmp eq i32 %383, 0
  br i1 %384, label %449, label %385

385:                                              ; preds = %382
  %386 = getelementptr inbounds double, ptr %272, i64 %362
  %387 = load double, ptr %386, align 8
  %388 = fcmp ogt double %387, 0.000000e+00
  %389 = and i1 %370, %388
  %390 = and i1 %373, %389
  br i1 %390, label %398, label %391

391:                                              ; preds = %385
  %392 = icmp sgt i64 %365, 0
  %393 = fcmp olt double %387, 0.000000e+00
  %394 = and i1 %392, %393
  br i1 %394, label %395, label %398

395:                                              ; preds = %391
  %396 = icmp slt i64 %369, 1
  %397 = zext i1 %396 to i32
  br label %398

398:                                              ; preds = %385, %391, %395
  %399 = phi i32 [ 1, %385 ], [ 0, %391 ], [ %397, %395 ]
  %400 = icmp eq i32 %399, 0
  br i1 %400, label %401, label %449

401:                                              ; preds = %398
  %402 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %274, double noundef %363, i64 noundef %362) #8
  %403 = fcmp ogt double %402, %274
  br i1 %403, label %404, label %406

404:                                              ; preds = %401
  %405 = getelementptr inbounds i64, ptr %18, i64 %362
  store i64 2, ptr %405, align 8
  br label %406

406:                                              ; preds = %404, %401
  %407 = phi double [ %402, %404 ], [ %363, %401 ]
  %408 = load ptr, ptr %136, align 8
  %409 = load ptr, ptr %138, align 8
  %410 = insertelement <8 x double> poison, double %407, i64 0
  %411 = shufflevector <8 x double> %410, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %411, ptr %409, align 8
  %412 = load ptr, ptr %137, align 8
  %413 = load ptr, ptr %139, align 8
  %414 = load i64, ptr %140, align 8
  %415 = load ptr, ptr %141, align 8
  %416 = getelementptr inbounds i8, ptr %415, i64 24
  %417 = load i64, ptr %416, align 8
  %418 = load ptr, ptr %138, align 8
  %419 = load ptr, ptr %142, align 8
  %420 = getelementptr inbounds i8, ptr %419, i64 16
  %421 = load i64, ptr %420, align 8
  tail call fastcc void @nested(ptr noundef %408, ptr noundef %412, ptr noundef %413, i64 noundef %414, i64 noundef %417, ptr noundef %418, i64 noundef %421) #8
  %422 = fmul double %407, %2
  %423 = fadd double %422, %1
  %424 = load ptr, ptr %143, align 8
  store double %423, ptr %424, align 8
  %425 = load i64, ptr %144, align 8
  %426 = icmp sgt i64 %425, 0
  br i1 %426, label %427, label %428

427:                                              ; preds = %406
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %428

428:                                              ; preds = %406, %427
  %429 = load ptr, ptr %9, align 8
  %430 = load i64, ptr %429, align 8
  %431 = load ptr, ptr %145, align 8
  %432 = load ptr, ptr %136, align 8
  %433 = load ptr, ptr %146, align 8
  %434 = load ptr, ptr %147, align 8
  %435 = load ptr, ptr %25, align 8
  %436 = getelementptr inbounds i8, ptr %429, i64 8
  %437 = load i64, ptr %436, align 8
  %438 = getelementptr inbounds double, ptr %435, i64 %437
  %439 = inttoptr i64 %430 to ptr
  %440 = tail call i32 %439(ptr noundef %431, ptr noundef %432, ptr noundef %433, ptr noundef %434, ptr noundef %438) #9
  %441 = icmp sgt i32 %440, -1
  br i1 %441, label %447, label %442

442:                                              ; preds = %428
  %443 = load ptr, ptr %20, align 8
  %444 = getelementptr inbounds i8, ptr %443, i64 80
  store i64 %23, ptr %444, align 8
  %445 = load ptr, ptr %19, align 8
  %446 = getelementptr inbounds i8, ptr %445, i64 48
  store double 1.000000e+00, ptr %446, align 8
  br label %447

447:                                              ; preds = %428, %442
  %448 = phi i64 [ -4, %442 ], [ %361, %428 ]
  br i1 %441, label %449, label %455

449:                                              ; preds = %382, %398, %447
  %450 = phi double [ %363, %398 ], [ %407, %447 ], [ %363, %382 ]
  %451 = phi i64 [ %361, %398 ], [ %448, %447 ], [ %361, %382 ]
  %452 = add nuw nsw i64 %362, 1
  %453 = icmp slt i64 %452, %12
  %454 = icmp eq i64 %452, %12
  br i1 %454, label %455, label %359, !llvm.loop !10

455:                                              ; preds = %447, %449, %353
  %456 = phi i1 [ %148, %353 ], [ %360, %447 ], [ %453, %449 ]
  %457 = phi i32 [ 16, %353 ], [ 1, %447 ], [ 16, %449 ]
  %458 = phi double [ %277, %353 ], [ %407, %447 ], [ %450, %449 ]
  %459 = phi i64 [ %275, %353 ], [ %448, %447 ], [ %451, %449 ]
  br i1 %456, label %878, label %460

460:                                              ; preds = %455
  br i1 %149, label %471, label %463

461:                                              ; preds = %558
  %462 = zext i1 %559 to i32
  br label %463

463:                                              ; preds = %461, %460
  %464 = phi i32 [ 0, %460 ], [ %462, %461 ]
  %465 = phi i64 [ -1, %460 ], [ %548, %461 ]
  %466 = icmp eq i32 %464, 0
  br i1 %466, label %467, label %562

467:                                              ; preds = %463
  br i1 %158, label %468, label %688

468:                                              ; preds = %467
  %469 = fmul double %458, %2
  %470 = fadd double %469, %1
  br label %809

471:                                              ; preds = %460, %558
  %472 = phi i64 [ %560, %558 ], [ 0, %460 ]
  %473 = phi i64 [ %548, %558 ], [ -1, %460 ]
  %474 = phi i1 [ %559, %558 ], [ false, %460 ]
  %475 = getelementptr inbounds double, ptr %31, i64 %472
  %476 = load double, ptr %475, align 8
  %477 = getelementptr inbounds i64, ptr %16, i64 %472
  %478 = load i64, ptr %477, align 8
  %479 = getelementptr inbounds i64, ptr %14, i64 %472
  %480 = load i64, ptr %479, align 8
  %481 = icmp slt i64 %478, 0
  %482 = fcmp ogt double %476, 0.000000e+00
  %483 = and i1 %482, %481
  %484 = icmp sgt i64 %480, -1
  %485 = and i1 %483, %484
  br i1 %485, label %493, label %486

486:                                              ; preds = %471
  %487 = icmp sgt i64 %478, 0
  %488 = fcmp olt double %476, 0.000000e+00
  %489 = and i1 %488, %487
  br i1 %489, label %490, label %493

490:                                              ; preds = %486
  %491 = icmp slt i64 %480, 1
  %492 = zext i1 %491 to i32
  br label %493

493:                                              ; preds = %471, %486, %490
  %494 = phi i32 [ 1, %471 ], [ 0, %486 ], [ %492, %490 ]
  %495 = icmp eq i32 %494, 0
  br i1 %495, label %496, label %521

496:                                              ; preds = %493
  %497 = getelementptr inbounds double, ptr %272, i64 %472
  %498 = load double, ptr %497, align 8
  %499 = fcmp ogt double %498, 0.000000e+00
  %500 = and i1 %481, %499
  %501 = and i1 %484, %500
  br i1 %501, label %509, label %502

502:                                              ; preds = %496
  %503 = icmp sgt i64 %478, 0
  %504 = fcmp olt double %498, 0.000000e+00
  %505 = and i1 %503, %504
  br i1 %505, label %506, label %509

506:                                              ; preds = %502
  %507 = icmp slt i64 %480, 1
  %508 = zext i1 %507 to i32
  br label %509

509:                                              ; preds = %496, %502, %506
  %510 = phi i32 [ 1, %496 ], [ 0, %502 ], [ %508, %506 ]
  %511 = icmp eq i32 %510, 0
  br i1 %511, label %521, label %512

512:                                              ; preds = %509
  %513 = fcmp oeq double %476, 0.000000e+00
  br i1 %513, label %518, label %514

514:                                              ; preds = %512
  %515 = getelementptr inbounds i64, ptr %18, i64 %472
  %516 = load i64, ptr %515, align 8
  %517 = icmp eq i64 %516, 1
  br label %518

518:                                              ; preds = %514, %512
  %519 = phi i1 [ true, %512 ], [ %517, %514 ]
  %520 = zext i1 %519 to i32
  br label %521

521:                                              ; preds = %518, %509, %493
  %522 = phi i32 [ 1, %493 ], [ %520, %518 ], [ 0, %509 ]
  %523 = icmp eq i32 %522, 0
  br i1 %523, label %524, label %530

524:                                              ; preds = %521
  %525 = getelementptr inbounds i64, ptr %18, i64 %472
  %526 = load i64, ptr %525, align 8
  %527 = icmp eq i64 %526, 2
  %528 = fcmp oeq double %476, 0.000000e+00
  %529 = and i1 %528, %527
  br label %530

530:                                              ; preds = %524, %521
  %531 = phi i1 [ true, %521 ], [ %529, %524 ]
  br i1 %531, label %547, label %532

532:                                              ; preds = %530
  %533 = getelementptr inbounds double, ptr %272, i64 %472
  %534 = load double, ptr %533, align 8
  %535 = icmp eq i64 %478, 0
  %536 = fcmp ord double %534, 0.000000e+00
  %537 = or i1 %535, %536
  br i1 %537, label %547, label %538

538:                                              ; preds = %532
  %539 = sitofp i64 %478 to double
  %540 = fmul double %476, %539
  %541 = fcmp olt double %540, 0.000000e+00
  br i1 %541, label %542, label %544

542:                                              ; preds = %538
  %543 = sub nsw i64 0, %478
  store i64 %543, ptr %477, align 8
  br label %547

544:                                              ; preds = %538
  %545 = fcmp ueq double %476, 0.000000e+00
  %546 = select i1 %545, i64 %472, i64 %473
  br label %547

547:                                              ; preds = %544, %542, %532, %530
  %548 = phi i64 [ %473, %530 ], [ %473, %542 ], [ %473, %532 ], [ %546, %544 ]
  %549 = zext i1 %531 to i64
  %550 = getelementptr inbounds i64, ptr %18, i64 %472
  store i64 %549, ptr %550, align 8
  %551 = xor i1 %531, true
  %552 = or i1 %474, %551
  br i1 %552, label %558, label %553

553:                                              ; preds = %547
  %554 = load ptr, ptr %150, align 8
  %555 = getelementptr inbounds i64, ptr %554, i64 %472
  %556 = load i64, ptr %555, align 8
  %557 = icmp eq i64 %556, 1
  br label %558

558:                                              ; preds = %547, %553
  %559 = phi i1 [ %474, %547 ], [ %557, %553 ]
  %560 = add nuw nsw i64 %472, 1
  %561 = icmp eq i64 %560, %12
  br i1 %561, label %461, label %471, !llvm.loop !11

562:                                              ; preds = %463
  store double %458, ptr %151, align 8
  %563 = load ptr, ptr %9, align 8
  %564 = getelementptr inbounds i8, ptr %563, i64 8
  %565 = load i64, ptr %564, align 8
  %566 = load ptr, ptr %25, align 8
  %567 = getelementptr inbounds double, ptr %566, i64 %565
  %568 = mul i64 %565, 56
  %569 = getelementptr inbounds i8, ptr %566, i64 %568
  %570 = load ptr, ptr %152, align 8
  %571 = load i64, ptr %153, align 8
  %572 = getelementptr double, ptr %570, i64 %571
  %573 = getelementptr i8, ptr %572, i64 -8
  %574 = load double, ptr %573, align 8
  %575 = load double, ptr %570, align 8
  %576 = fsub double %574, %575
  %577 = icmp sgt i64 %565, 0
  br i1 %577, label %581, label %578

578:                                              ; preds = %594, %562
  %579 = phi i32 [ 0, %562 ], [ %596, %594 ]
  %580 = icmp eq i32 %579, 0
  br i1 %580, label %878, label %599

581:                                              ; preds = %562, %594
  %582 = phi i64 [ %597, %594 ], [ 0, %562 ]
  %583 = phi i32 [ %596, %594 ], [ 0, %562 ]
  %584 = icmp eq i32 %583, 0
  br i1 %584, label %585, label %594

585:                                              ; preds = %581
  %586 = load ptr, ptr %17, align 8
  %587 = getelementptr inbounds i64, ptr %586, i64 %582
  %588 = load i64, ptr %587, align 8
  %589 = icmp eq i64 %588, 0
  br i1 %589, label %594, label %590

590:                                              ; preds = %585
  %591 = getelementptr inbounds double, ptr %567, i64 %582
  %592 = load double, ptr %591, align 8
  %593 = fcmp oeq double %592, 0.000000e+00
  br label %594

594:                                              ; preds = %590, %585, %581
  %595 = phi i1 [ true, %581 ], [ false, %585 ], [ %593, %590 ]
  %596 = zext i1 %595 to i32
  %597 = add nuw nsw i64 %582, 1
  %598 = icmp eq i64 %597, %565
  br i1 %598, label %578, label %581, !llvm.loop !12

599:                                              ; preds = %578
  %600 = fsub double %271, %458
  %601 = fmul double %600, %2
  %602 = fcmp ogt double %155, %576
  %603 = select i1 %602, double %155, double %576
  %604 = fmul double %603, 0x3F50000000000000
  %605 = fcmp ugt double %601, %604
  br i1 %605, label %606, label %878

606:                                              ; preds = %599
  %607 = fmul double %600, 0x3F50000000000000
  %608 = fadd double %458, %607
  %609 = load ptr, ptr %136, align 8
  %610 = load ptr, ptr %138, align 8
  %611 = insertelement <8 x double> poison, double %608, i64 0
  %612 = shufflevector <8 x double> %611, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %612, ptr %610, align 8
  %613 = load ptr, ptr %137, align 8
  %614 = load ptr, ptr %139, align 8
  %615 = load i64, ptr %140, align 8
  %616 = load ptr, ptr %141, align 8
  %617 = getelementptr inbounds i8, ptr %616, i64 24
  %618 = load i64, ptr %617, align 8
  %619 = load ptr, ptr %138, align 8
  %620 = load ptr, ptr %142, align 8
  %621 = getelementptr inbounds i8, ptr %620, i64 16
  %622 = load i64, ptr %621, align 8
  tail call fastcc void @nested(ptr noundef %609, ptr noundef %613, ptr noundef %614, i64 noundef %615, i64 noundef %618, ptr noundef %619, i64 noundef %622) #8
  %623 = fmul double %608, %2
  %624 = fadd double %623, %1
  %625 = load ptr, ptr %143, align 8
  store double %624, ptr %625, align 8
  %626 = load i64, ptr %144, align 8
  %627 = icmp sgt i64 %626, 0
  br i1 %627, label %628, label %629

628:                                              ; preds = %606
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %629

629:                                              ; preds = %606, %628
  %630 = load ptr, ptr %9, align 8
  %631 = load i64, ptr %630, align 8
  %632 = load ptr, ptr %145, align 8
  %633 = load ptr, ptr %136, align 8
  %634 = load ptr, ptr %146, align 8
  %635 = load ptr, ptr %147, align 8
  %636 = load ptr, ptr %25, align 8
  %637 = getelementptr inbounds i8, ptr %630, i64 8
  %638 = load i64, ptr %637, align 8
  %639 = mul i64 %638, 56
  %640 = getelementptr inbounds i8, ptr %636, i64 %639
  %641 = inttoptr i64 %631 to ptr
  %642 = tail call i32 %641(ptr noundef %632, ptr noundef %633, ptr noundef %634, ptr noundef %635, ptr noundef %640) #9
  %643 = icmp slt i32 %642, 0
  br i1 %643, label %683, label %644

644:                                              ; preds = %629
  %645 = icmp sgt i64 %565, 0
  br i1 %645, label %646, label %878

646:                                              ; preds = %644
  %647 = fmul double %458, %2
  %648 = fadd double %647, %1
  %649 = fsub double %648, %648
  br label %650

650:                                              ; preds = %646, %680
  %651 = phi i64 [ 0, %646 ], [ %681, %680 ]
  %652 = load ptr, ptr %17, align 8
  %653 = getelementptr inbounds i64, ptr %652, i64 %651
  %654 = load i64, ptr %653, align 8
  %655 = icmp eq i64 %654, 0
  br i1 %655, label %680, label %656

656:                                              ; preds = %650
  %657 = getelementptr inbounds double, ptr %567, i64 %651
  %658 = load double, ptr %657, align 8
  %659 = fcmp oeq double %658, 0.000000e+00
  br i1 %659, label %660, label %680

660:                                              ; preds = %656
  %661 = getelementptr inbounds double, ptr %569, i64 %651
  %662 = load double, ptr %661, align 8
  %663 = fcmp oeq double %662, 0.000000e+00
  br i1 %663, label %664, label %680

664:                                              ; preds = %660
  %665 = load i64, ptr %156, align 8
  %666 = icmp eq i64 %665, 0
  br i1 %666, label %680, label %667

667:                                              ; preds = %664
  %668 = load ptr, ptr %157, align 8
  %669 = shl nsw i64 %651, 4
  %670 = getelementptr inbounds i8, ptr %668, i64 %669
  %671 = getelementptr inbounds i8, ptr %670, i64 8
  %672 = load double, ptr %671, align 8
  %673 = fcmp oeq double %672, %648
  br i1 %673, label %679, label %674

674:                                              ; preds = %667
  %675 = load double, ptr %670, align 8
  %676 = fsub double %672, %675
  %677 = fcmp ult double %676, %649
  br i1 %677, label %678, label %680

678:                                              ; preds = %674
  store double %648, ptr %670, align 8
  br label %679

679:                                              ; preds = %667, %678
  store double %648, ptr %671, align 8
  br label %680

680:                                              ; preds = %679, %674, %664, %660, %656, %650
  %681 = add nuw nsw i64 %651, 1
  %682 = icmp eq i64 %681, %565
  br i1 %682, label %878, label %650, !llvm.loop !13

683:                                              ; preds = %629
  %684 = load ptr, ptr %20, align 8
  %685 = getelementptr inbounds i8, ptr %684, i64 80
  store i64 %23, ptr %685, align 8
  %686 = load ptr, ptr %19, align 8
  %687 = getelementptr inbounds i8, ptr %686, i64 48
  store double 1.000000e+00, ptr %687, align 8
  br label %878

688:                                              ; preds = %851, %467
  %689 = load ptr, ptr %9, align 8
  %690 = getelementptr inbounds i8, ptr %689, i64 8
  %691 = load i64, ptr %690, align 8
  %692 = load ptr, ptr %25, align 8
  %693 = getelementptr inbounds double, ptr %692, i64 %691
  %694 = mul i64 %691, 56
  %695 = getelementptr inbounds i8, ptr %692, i64 %694
  %696 = load ptr, ptr %164, align 8
  %697 = load i64, ptr %165, align 8
  %698 = getelementptr double, ptr %696, i64 %697
  %699 = getelementptr i8, ptr %698, i64 -8
  %700 = load double, ptr %699, align 8
  %701 = load double, ptr %696, align 8
  %702 = fsub double %700, %701
  %703 = icmp sgt i64 %691, 0
  br i1 %703, label %707, label %704

704:                                              ; preds = %720, %688
  %705 = phi i32 [ 0, %688 ], [ %722, %720 ]
  %706 = icmp eq i32 %705, 0
  br i1 %706, label %859, label %725

707:                                              ; preds = %688, %720
  %708 = phi i64 [ %723, %720 ], [ 0, %688 ]
  %709 = phi i32 [ %722, %720 ], [ 0, %688 ]
  %710 = icmp eq i32 %709, 0
  br i1 %710, label %711, label %720

711:                                              ; preds = %707
  %712 = load ptr, ptr %17, align 8
  %713 = getelementptr inbounds i64, ptr %712, i64 %708
  %714 = load i64, ptr %713, align 8
  %715 = icmp eq i64 %714, 0
  br i1 %715, label %720, label %716

716:                                              ; preds = %711
  %717 = getelementptr inbounds double, ptr %693, i64 %708
  %718 = load double, ptr %717, align 8
  %719 = fcmp oeq double %718, 0.000000e+00
  br label %720

720:                                              ; preds = %716, %711, %707
  %721 = phi i1 [ true, %707 ], [ false, %711 ], [ %719, %716 ]
  %722 = zext i1 %721 to i32
  %723 = add nuw nsw i64 %708, 1
  %724 = icmp eq i64 %723, %691
  br i1 %724, label %704, label %707, !llvm.loop !12

725:                                              ; preds = %704
  %726 = fsub double %271, %458
  %727 = fmul double %726, %2
  %728 = fcmp ogt double %167, %702
  %729 = select i1 %728, double %167, double %702
  %730 = fmul double %729, 0x3F50000000000000
  %731 = fcmp ugt double %727, %730
  br i1 %731, label %732, label %859

732:                                              ; preds = %725
  %733 = fmul double %726, 0x3F50000000000000
  %734 = fadd double %458, %733
  %735 = load ptr, ptr %136, align 8
  %736 = load ptr, ptr %138, align 8
  %737 = insertelement <8 x double> poison, double %734, i64 0
  %738 = shufflevector <8 x double> %737, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %738, ptr %736, align 8
  %739 = load ptr, ptr %137, align 8
  %740 = load ptr, ptr %139, align 8
  %741 = load i64, ptr %140, align 8
  %742 = load ptr, ptr %141, align 8
  %743 = getelementptr inbounds i8, ptr %742, i64 24
  %744 = load i64, ptr %743, align 8
  %745 = load ptr, ptr %138, align 8
  %746 = load ptr, ptr %142, align 8
  %747 = getelementptr inbounds i8, ptr %746, i64 16
  %748 = load i64, ptr %747, align 8
  tail call fastcc void @nested(ptr noundef %735, ptr noundef %739, ptr noundef %740, i64 noundef %741, i64 noundef %744, ptr noundef %745, i64 noundef %748) #8
  %749 = fmul double %734, %2
  %750 = fadd double %749, %1
  %751 = load ptr, ptr %143, align 8
  store double %750, ptr %751, align 8
  %752 = load i64, ptr %144, align 8
  %753 = icmp sgt i64 %752, 0
  br i1 %753, label %754, label %755

754:                                              ; preds = %732
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %755

755:                                              ; preds = %732, %754
  %756 = load ptr, ptr %9, align 8
  %757 = load i64, ptr %756, align 8
  %758 = load ptr, ptr %145, align 8
  %759 = load ptr, ptr %136, align 8
  %760 = load ptr, ptr %146, align 8
  %761 = load ptr, ptr %147, align 8
  %762 = load ptr, ptr %25, align 8
  %763 = getelementptr inbounds i8, ptr %756, i64 8
  %764 = load i64, ptr %763, align 8
  %765 = mul i64 %764, 56
  %766 = getelementptr inbounds i8, ptr %762, i64 %765
  %767 = inttoptr i64 %757 to ptr
  %768 = tail call i32 %767(ptr noundef %758, ptr noundef %759, ptr noundef %760, ptr noundef %761, ptr noundef %766) #9
  %769 = icmp slt i32 %768, 0
  br i1 %769, label %854, label %770

770:                                              ; preds = %755
  %771 = icmp sgt i64 %691, 0
  br i1 %771, label %772, label %859

772:                                              ; preds = %770
  %773 = fmul double %458, %2
  %774 = fadd double %773, %1
  %775 = fsub double %774, %774
  br label %776

776:                                              ; preds = %772, %806
  %777 = phi i64 [ 0, %772 ], [ %807, %806 ]
  %778 = load ptr, ptr %17, align 8
  %779 = getelementptr inbounds i64, ptr %778, i64 %777
  %780 = load i64, ptr %779, align 8
  %781 = icmp eq i64 %780, 0
  br i1 %781, label %806, label %782

782:                                              ; preds = %776
  %783 = getelementptr inbounds double, ptr %693, i64 %777
  %784 = load double, ptr %783, align 8
  %785 = fcmp oeq double %784, 0.000000e+00
  br i1 %785, label %786, label %806

786:                                              ; preds = %782
  %787 = getelementptr inbounds double, ptr %695, i64 %777
  %788 = load double, ptr %787, align 8
  %789 = fcmp oeq double %788, 0.000000e+00
  br i1 %789, label %790, label %806

790:                                              ; preds = %786
  %791 = load i64, ptr %168, align 8
  %792 = icmp eq i64 %791, 0
  br i1 %792, label %806, label %793

793:                                              ; preds = %790
  %794 = load ptr, ptr %169, align 8
  %795 = shl nsw i64 %777, 4
  %796 = getelementptr inbounds i8, ptr %794, i64 %795
  %797 = getelementptr inbounds i8, ptr %796, i64 8
  %798 = load double, ptr %797, align 8
  %799 = fcmp oeq double %798, %774
  br i1 %799, label %805, label %800

800:                                              ; preds = %793
  %801 = load double, ptr %796, align 8
  %802 = fsub double %798, %801
  %803 = fcmp ult double %802, %775
  br i1 %803, label %804, label %806

804:                                              ; preds = %800
  store double %774, ptr %796, align 8
  br label %805

805:                                              ; preds = %793, %804
  store double %774, ptr %797, align 8
  br label %806

806:                                              ; preds = %805, %800, %790, %786, %782, %776
  %807 = add nuw nsw i64 %777, 1
  %808 = icmp eq i64 %807, %691
  br i1 %808, label %859, label %776, !llvm.loop !13

809:                                              ; preds = %468, %851
  %810 = phi i64 [ 0, %468 ], [ %852, %851 ]
  %811 = getelementptr inbounds i64, ptr %18, i64 %810
  %812 = load i64, ptr %811, align 8
  %813 = icmp eq i64 %812, 0
  br i1 %813, label %851, label %814

814:                                              ; preds = %809
  %815 = load ptr, ptr %20, align 8
  %816 = getelementptr inbounds i8, ptr %815, i64 80
  %817 = load i64, ptr %816, align 8
  %818 = load ptr, ptr %6, align 8
  %819 = getelementptr inbounds i8, ptr %818, i64 8
  %820 = load i64, ptr %819, align 8
  %821 = load i64, ptr %159, align 8
  %822 = icmp eq i64 %821, 0
  br i1 %822, label %847, label %823

823:                                              ; preds = %814
  %824 = load ptr, ptr %160, align 8
  %825 = getelementptr inbounds double, ptr %824, i64 %817
  store double %470, ptr %825, align 8
  %826 = load ptr, ptr %161, align 8
  %827 = getelementptr inbounds i64, ptr %826, i64 %817
  store i64 %810, ptr %827, align 8
  %828 = icmp sgt i64 %820, 0
  br i1 %828, label %829, label %831

829:                                              ; preds = %823
  %830 = mul nsw i64 %820, %817
  br label %835

831:                                              ; preds = %835, %823
  %832 = add nsw i64 %817, 1
  %833 = load ptr, ptr %20, align 8
  %834 = getelementptr inbounds i8, ptr %833, i64 80
  store i64 %832, ptr %834, align 8
  br label %847

835:                                              ; preds = %829, %835
  %836 = phi i64 [ 0, %829 ], [ %845, %835 ]
  %837 = load ptr, ptr %136, align 8
  %838 = getelementptr inbounds double, ptr %837, i64 %836
  %839 = load double, ptr %838, align 8
  %840 = load ptr, ptr %162, align 8
  %841 = add nsw i64 %836, %830
  %842 = getelementptr inbounds double, ptr %840, i64 %841
  store double %839, ptr %842, align 8
  %843 = load ptr, ptr %163, align 8
  %844 = getelementptr inbounds double, ptr %843, i64 %841
  store double %839, ptr %844, align 8
  %845 = add nuw nsw i64 %836, 1
  %846 = icmp eq i64 %845, %820
  br i1 %846, label %831, label %835, !llvm.loop !14

847:                                              ; preds = %814, %831
  %848 = getelementptr inbounds i64, ptr %16, i64 %810
  %849 = load i64, ptr %848, align 8
  %850 = sub nsw i64 0, %849
  store i64 %850, ptr %848, align 8
  br label %851

851:                                              ; preds = %809, %847
  %852 = add nuw nsw i64 %810, 1
  %853 = icmp eq i64 %852, %12
  br i1 %853, label %688, label %809, !llvm.loop !15

854:                                              ; preds = %755
  %855 = load ptr, ptr %20, align 8
  %856 = getelementptr inbounds i8, ptr %855, i64 80
  store i64 %23, ptr %856, align 8
  %857 = load ptr, ptr %19, align 8
  %858 = getelementptr inbounds i8, ptr %857, i64 48
  store double 1.000000e+00, ptr %858, align 8
  br label %878

859:                                              ; preds = %806, %770, %725, %704
  %860 = icmp sgt i64 %465, -1
  br i1 %860, label %861, label %870

861:                                              ; preds = %859
  br i1 %172, label %863, label %862

862:                                              ; preds = %863, %861
  store double %458, ptr %173, align 8
  br label %878

863:                                              ; preds = %861, %863
  %864 = phi i64 [ %868, %863 ], [ 0, %861 ]
  %865 = icmp eq i64 %864, %465
  %866 = zext i1 %865 to i64
  %867 = getelementptr inbounds i64, ptr %18, i64 %864
  store i64 %866, ptr %867, align 8
  %868 = add nuw nsw i64 %864, 1
  %869 = icmp eq i64 %868, %12
  br i1 %869, label %862, label %863, !llvm.loop !16

870:                                              ; preds = %859
  %871 = load i64, ptr %170, align 8
  %872 = icmp sgt i64 %871, 0
  br i1 %872, label %873, label %878

873:                                              ; preds = %870
  %874 = load i64, ptr %22, align 8
  %875 = add nsw i64 %874, %12
  %876 = icmp sgt i64 %875, %871
  br i1 %876, label %877, label %878

877:                                              ; preds = %873
  store double %458, ptr %171, align 8
  br label %878

878:                                              ; preds = %680, %644, %599, %578, %854, %862, %877, %683, %873, %870, %276, %455, %354
  %879 = phi i32 [ 1, %354 ], [ %457, %455 ], [ 11, %276 ], [ 1, %854 ], [ 1, %862 ], [ 1, %877 ], [ 1, %683 ], [ 0, %873 ], [ 0, %870 ], [ 1, %578 ], [ 1, %599 ], [ 1, %644 ], [ 1, %680 ]
  %880 = phi double [ %274, %354 ], [ %274, %455 ], [ %274, %276 ], [ %274, %854 ], [ %274, %862 ], [ %274, %877 ], [ %274, %683 ], [ %458, %873 ], [ %458, %870 ], [ %274, %578 ], [ %274, %599 ], [ %274, %644 ], [ %274, %680 ]
  %881 = phi i64 [ -4, %354 ], [ %459, %455 ], [ %275, %276 ], [ -4, %854 ], [ 21, %862 ], [ -3, %877 ], [ -4, %683 ], [ %459, %873 ], [ %459, %870 ], [ -2, %578 ], [ -2, %599 ], [ -2, %644 ], [ -2, %680 ]
  switch i32 %879, label %939 [
    i32 0, label %273
    i32 11, label %882
  ], !llvm.loop !17

882:                                              ; preds = %878
  br i1 %174, label %883, label %939

883:                                              ; preds = %882
  %884 = fcmp oeq double %271, %184
  %885 = add nsw i32 %181, -1
  %886 = sext i32 %885 to i64
  %887 = mul nsw i64 %12, %886
  %888 = getelementptr double, ptr %28, i64 %887
  %889 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %886
  %890 = fmul double %271, %2
  %891 = fadd double %890, %1
  br label %892

892:                                              ; preds = %883, %931
  %893 = phi i64 [ 0, %883 ], [ %932, %931 ]
  %894 = getelementptr inbounds double, ptr %272, i64 %893
  %895 = load double, ptr %894, align 8
  %896 = fcmp ogt double %895, 0.000000e+00
  br i1 %896, label %899, label %897

897:                                              ; preds = %892
  %898 = fcmp olt double %895, 0.000000e+00
  br i1 %898, label %899, label %902

899:                                              ; preds = %897, %892
  %900 = phi i64 [ 1, %892 ], [ -1, %897 ]
  %901 = getelementptr inbounds i64, ptr %16, i64 %893
  store i64 %900, ptr %901, align 8
  br label %902

902:                                              ; preds = %899, %897
  br i1 %884, label %903, label %931

903:                                              ; preds = %902
  %904 = getelementptr double, ptr %888, i64 %893
  %905 = load double, ptr %904, align 8
  %906 = fcmp oeq double %905, 0.000000e+00
  br i1 %906, label %907, label %931

907:                                              ; preds = %903
  %908 = getelementptr double, ptr %235, i64 %893
  %909 = load double, ptr %908, align 8
  %910 = fcmp oeq double %909, 0.000000e+00
  br i1 %910, label %911, label %931

911:                                              ; preds = %907
  %912 = load double, ptr %889, align 8
  %913 = fmul double %912, %2
  %914 = fadd double %913, %1
  %915 = load i64, ptr %175, align 8
  %916 = icmp eq i64 %915, 0
  br i1 %916, label %931, label %917

917:                                              ; preds = %911
  %918 = load ptr, ptr %176, align 8
  %919 = shl nsw i64 %893, 4
  %920 = getelementptr inbounds i8, ptr %918, i64 %919
  %921 = getelementptr inbounds i8, ptr %920, i64 8
  %922 = load double, ptr %921, align 8
  %923 = fcmp oeq double %922, %914
  br i1 %923, label %930, label %924

924:                                              ; preds = %917
  %925 = load double, ptr %920, align 8
  %926 = fsub double %922, %925
  %927 = fsub double %891, %914
  %928 = fcmp ult double %926, %927
  br i1 %928, label %929, label %931

929:                                              ; preds = %924
  store double %914, ptr %920, align 8
  br label %930

930:                                              ; preds = %917, %929
  store double %891, ptr %921, align 8
  br label %931

931:                                              ; preds = %930, %924, %911, %902, %903, %907
  %932 = add nuw nsw i64 %893, 1
  %933 = icmp eq i64 %932, %12
  br i1 %933, label %939, label %892, !llvm.loop !18

934:                                              ; preds = %259, %231
  %935 = load ptr, ptr %20, align 8
  %936 = getelementptr inbounds i8, ptr %935, i64 80
  store i64 %23, ptr %936, align 8
  %937 = load ptr, ptr %19, align 8
  %938 = getelementptr inbounds i8, ptr %937, i64 48
  store double 1.000000e+00, ptr %938, align 8
  br label %939

939:                                              ; preds = %878, %931, %934, %882
  %940 = phi i32 [ 0, %882 ], [ 1, %934 ], [ 0, %931 ], [ %879, %878 ]
  %941 = phi double [ %271, %882 ], [ %180, %934 ], [ %271, %931 ], [ %880, %878 ]
  %942 = phi i64 [ %881, %882 ], [ -4, %934 ], [ %881, %931 ], [ %881, %878 ]
  %943 = icmp eq i32 %940, 0
  br i1 %943, label %944, label %949

944:                                              ; preds = %939
  %945 = fcmp oeq double %941, %184
  %946 = zext i1 %945 to i32
  %947 = add nuw nsw i32 %181, %946
  %948 = icmp ugt i32 %947, 4
  br i1 %948, label %949, label %177, !llvm.loop !19

949:                                              ; preds = %944, %939
  %950 = phi i1 [ %948, %944 ], [ %178, %939 ]
  br i1 %950, label %951, label %969

951:                                              ; preds = %949
  %952 = icmp sgt i64 %12, 0
  br i1 %952, label %953, label %956

953:                                              ; preds = %951
  %954 = shl i64 %12, 5
  %955 = getelementptr i8, ptr %28, i64 %954
  br label %958

956:                                              ; preds = %958, %951
  %957 = load double, ptr %24, align 8
  store double %957, ptr %30, align 8
  br label %965

958:                                              ; preds = %953, %958
  %959 = phi i64 [ 0, %953 ], [ %963, %958 ]
  %960 = getelementptr double, ptr %955, i64 %959
  %961 = load double, ptr %960, align 8
  %962 = getelementptr inbounds double, ptr %28, i64 %959
  store double %961, ptr %962, align 8
  %963 = add nuw nsw i64 %959, 1
  %964 = icmp eq i64 %963, %12
  br i1 %964, label %956, label %958, !llvm.loop !20

965:                                              ; preds = %118, %956, %91
  %966 = phi ptr [ %94, %91 ], [ %24, %956 ], [ %121, %118 ]
  %967 = phi i64 [ -4, %91 ], [ 0, %956 ], [ -4, %118 ]
  %968 = getelementptr inbounds i8, ptr %966, i64 48
  store double 1.000000e+00, ptr %968, align 8
  br label %969

969:                                              ; preds = %965, %949, %99
  %970 = phi i64 [ %942, %949 ], [ %100, %99 ], [ %967, %965 ]
  ret i64 %970
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
  br i1 %26, label %27, label %351

27:                                               ; preds = %4
  %28 = getelementptr inbounds i8, ptr %0, i64 936
  %29 = shl nsw i64 %9, 4
  %30 = mul i64 %9, 40
  %31 = getelementptr inbounds i8, ptr %0, i64 816
  %32 = getelementptr inbounds i8, ptr %0, i64 984
  %33 = getelementptr inbounds i8, ptr %1, i64 16
  %34 = getelementptr inbounds i8, ptr %1, i64 8
  %35 = getelementptr inbounds i8, ptr %0, i64 168
  %36 = getelementptr inbounds i8, ptr %0, i64 248
  %37 = getelementptr inbounds i8, ptr %0, i64 144
  %38 = getelementptr inbounds i8, ptr %0, i64 168
  %39 = getelementptr inbounds i8, ptr %0, i64 192
  %40 = getelementptr inbounds i8, ptr %0, i64 744
  %41 = getelementptr inbounds i8, ptr %0, i64 144
  %42 = getelementptr inbounds i8, ptr %0, i64 984
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

53:                                               ; preds = %27, %348
  %54 = phi i64 [ undef, %27 ], [ %347, %348 ]
  %55 = phi i32 [ 0, %27 ], [ %346, %348 ]
  %56 = phi i32 [ 0, %27 ], [ %345, %348 ]
  %57 = phi i64 [ 0, %27 ], [ %349, %348 ]
  %58 = load ptr, ptr %28, align 8
  %59 = getelementptr inbounds i8, ptr %58, i64 %29
  %60 = getelementptr inbounds double, ptr %59, i64 %57
  %61 = getelementptr inbounds i8, ptr %60, i64 %30
  %62 = load ptr, ptr %31, align 8
  %63 = getelementptr inbounds i64, ptr %62, i64 %57
  %64 = load i64, ptr %63, align 8
  %65 = and i64 %64, 1
  %66 = icmp eq i64 %65, 0
  br i1 %66, label %67, label %343

67:                                               ; preds = %53
  %68 = load double, ptr %60, align 8
  br label %72

69:                                               ; preds = %72
  %70 = fmul double %80, %82
  %71 = fcmp ugt double %70, 0.000000e+00
  br i1 %71, label %85, label %94

72:                                               ; preds = %67, %72
  %73 = phi i64 [ 1, %67 ], [ %83, %72 ]
  %74 = phi double [ %68, %67 ], [ %82, %72 ]
  %75 = phi double [ %68, %67 ], [ %80, %72 ]
  %76 = mul nuw nsw i64 %9, %73
  %77 = getelementptr inbounds double, ptr %60, i64 %76
  %78 = load double, ptr %77, align 8
  %79 = fcmp olt double %75, %78
  %80 = select i1 %79, double %75, double %78
  %81 = fcmp ogt double %74, %78
  %82 = select i1 %81, double %74, double %78
  %83 = add nuw nsw i64 %73, 1
  %84 = icmp eq i64 %83, 5
  br i1 %84, label %69, label %72, !llvm.loop !21

85:                                               ; preds = %69
  %86 = tail call double @llvm.fabs.f64(double %80)
  %87 = tail call double @llvm.fabs.f64(double %82)
  %88 = fcmp olt double %86, %87
  %89 = select i1 %88, double %86, double %87
  %90 = fsub double %82, %80
  %91 = fmul double %90, 4.000000e+00
  %92 = fcmp ole double %89, %91
  %93 = zext i1 %92 to i32
  br label %94

94:                                               ; preds = %69, %85
  %95 = phi i32 [ 1, %69 ], [ %93, %85 ]
  %96 = icmp eq i32 %95, 0
  br i1 %96, label %343, label %97

97:                                               ; preds = %94
  %98 = sext i32 %55 to i64
  br label %99

99:                                               ; preds = %97, %137
  %100 = phi i64 [ %98, %97 ], [ %105, %137 ]
  %101 = icmp slt i64 %100, 4
  br i1 %101, label %102, label %152

102:                                              ; preds = %99
  %103 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %100
  %104 = load double, ptr %103, align 8
  %105 = add nsw i64 %100, 1
  %106 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %105
  %107 = load double, ptr %106, align 8
  %108 = fadd double %104, %107
  %109 = fmul double %108, 5.000000e-01
  %110 = add nsw i64 %100, 7
  %111 = load ptr, ptr %32, align 8
  %112 = load ptr, ptr %33, align 8
  %113 = getelementptr inbounds i8, ptr %112, i64 96
  %114 = load ptr, ptr %113, align 8
  %115 = insertelement <8 x double> poison, double %109, i64 0
  %116 = shufflevector <8 x double> %115, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %116, ptr %114, align 8
  %117 = load ptr, ptr %112, align 8
  %118 = getelementptr inbounds i8, ptr %112, i64 192
  %119 = load ptr, ptr %118, align 8
  %120 = getelementptr inbounds i8, ptr %112, i64 8
  %121 = load i64, ptr %120, align 8
  %122 = load ptr, ptr %1, align 8
  %123 = load ptr, ptr %122, align 8
  %124 = getelementptr inbounds i8, ptr %123, i64 24
  %125 = load i64, ptr %124, align 8
  %126 = load ptr, ptr %113, align 8
  %127 = load ptr, ptr %34, align 8
  %128 = load ptr, ptr %127, align 8
  %129 = getelementptr inbounds i8, ptr %128, i64 16
  %130 = load i64, ptr %129, align 8
  tail call fastcc void @nested(ptr noundef %111, ptr noundef %117, ptr noundef %119, i64 noundef %121, i64 noundef %125, ptr noundef %126, i64 noundef %130) #8
  %131 = fmul double %109, %3
  %132 = fadd double %131, %2
  %133 = load ptr, ptr %35, align 8
  store double %132, ptr %133, align 8
  %134 = load i64, ptr %36, align 8
  %135 = icmp sgt i64 %134, 0
  br i1 %135, label %136, label %137

136:                                              ; preds = %102
  tail call fastcc void @sample(ptr noundef nonnull %37) #8
  br label %137

137:                                              ; preds = %102, %136
  %138 = load ptr, ptr %6, align 8
  %139 = load i64, ptr %138, align 8
  %140 = load ptr, ptr %38, align 8
  %141 = load ptr, ptr %32, align 8
  %142 = load ptr, ptr %39, align 8
  %143 = load ptr, ptr %40, align 8
  %144 = load ptr, ptr %28, align 8
  %145 = getelementptr inbounds i8, ptr %138, i64 8
  %146 = load i64, ptr %145, align 8
  %147 = mul nsw i64 %146, %110
  %148 = getelementptr inbounds double, ptr %144, i64 %147
  %149 = inttoptr i64 %139 to ptr
  %150 = tail call i32 %149(ptr noundef %140, ptr noundef %141, ptr noundef %142, ptr noundef %143, ptr noundef %148) #9
  %151 = icmp slt i32 %150, 0
  br i1 %151, label %341, label %99, !llvm.loop !22

152:                                              ; preds = %99
  %153 = load double, ptr %60, align 8
  %154 = tail call double @llvm.fabs.f64(double %153)
  store double %153, ptr %5, align 16
  br label %162

155:                                              ; preds = %212
  %156 = trunc nsw i64 %100 to i32
  %157 = fmul double %223, 0x3E50000000000000
  %158 = fcmp ogt double %217, %157
  br i1 %158, label %159, label %337

159:                                              ; preds = %155
  %160 = fmul double %217, 2.000000e+00
  %161 = fmul double %217, 8.000000e+00
  br label %225

162:                                              ; preds = %152, %212
  %163 = phi i64 [ 0, %152 ], [ %172, %212 ]
  %164 = phi double [ 0.000000e+00, %152 ], [ %217, %212 ]
  %165 = phi double [ %154, %152 ], [ %223, %212 ]
  %166 = mul nuw nsw i64 %9, %163
  %167 = getelementptr inbounds double, ptr %61, i64 %166
  %168 = load double, ptr %167, align 8
  %169 = shl nuw nsw i64 %163, 1
  %170 = or disjoint i64 %169, 1
  %171 = getelementptr inbounds [9 x double], ptr %5, i64 0, i64 %170
  store double %168, ptr %171, align 8
  %172 = add nuw nsw i64 %163, 1
  %173 = mul nuw nsw i64 %9, %172
  %174 = getelementptr inbounds double, ptr %60, i64 %173
  %175 = load double, ptr %174, align 8
  %176 = add nuw nsw i64 %169, 2
  %177 = getelementptr inbounds [9 x double], ptr %5, i64 0, i64 %176
  store double %175, ptr %177, align 16
  %178 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %163
  %179 = load double, ptr %178, align 8
  %180 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %172
  %181 = load double, ptr %180, align 8
  %182 = fadd double %179, %181
  %183 = fmul double %182, 5.000000e-01
  br label %184

184:                                              ; preds = %162, %188
  %185 = phi i64 [ 0, %162 ], [ %194, %188 ]
  %186 = phi double [ 0.000000e+00, %162 ], [ %193, %188 ]
  %187 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %185
  br label %196

188:                                              ; preds = %207
  %189 = mul nuw nsw i64 %9, %185
  %190 = getelementptr inbounds double, ptr %60, i64 %189
  %191 = load double, ptr %190, align 8
  %192 = fmul double %209, %191
  %193 = fadd double %186, %192
  %194 = add nuw nsw i64 %185, 1
  %195 = icmp eq i64 %194, 5
  br i1 %195, label %212, label %184, !llvm.loop !23

196:                                              ; preds = %184, %207
  %197 = phi i64 [ 0, %184 ], [ %210, %207 ]
  %198 = phi double [ 1.000000e+00, %184 ], [ %209, %207 ]
  %199 = icmp eq i64 %197, %185
  br i1 %199, label %207, label %200

200:                                              ; preds = %196
  %201 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %197
  %202 = load double, ptr %201, align 8
  %203 = fsub double %183, %202
  %204 = load double, ptr %187, align 8
  %205 = fsub double %204, %202
  %206 = fdiv double %203, %205
  br label %207

207:                                              ; preds = %200, %196
  %208 = phi double [ %206, %200 ], [ 1.000000e+00, %196 ]
  %209 = fmul double %198, %208
  %210 = add nuw nsw i64 %197, 1
  %211 = icmp eq i64 %210, 5
  br i1 %211, label %188, label %196, !llvm.loop !24

212:                                              ; preds = %188
  %213 = fsub double %168, %193
  %214 = tail call double @llvm.fabs.f64(double %213)
  %215 = fmul double %214, 2.000000e+00
  %216 = fcmp ogt double %164, %215
  %217 = select i1 %216, double %164, double %215
  %218 = tail call double @llvm.fabs.f64(double %168)
  %219 = tail call double @llvm.fabs.f64(double %175)
  %220 = fcmp ogt double %218, %219
  %221 = select i1 %220, double %218, double %219
  %222 = fcmp ogt double %165, %221
  %223 = select i1 %222, double %165, double %221
  %224 = icmp eq i64 %172, 4
  br i1 %224, label %155, label %162, !llvm.loop !25

225:                                              ; preds = %159, %246
  %226 = phi i64 [ 1, %159 ], [ %247, %246 ]
  %227 = phi i1 [ false, %159 ], [ %248, %246 ]
  %228 = getelementptr double, ptr %5, i64 %226
  %229 = getelementptr i8, ptr %228, i64 -8
  %230 = load double, ptr %229, align 8
  %231 = load double, ptr %228, align 8
  %232 = fsub double %230, %231
  %233 = tail call double @llvm.fabs.f64(double %232)
  %234 = fmul double %230, %231
  %235 = fcmp olt double %234, 0.000000e+00
  br i1 %235, label %236, label %238

236:                                              ; preds = %225
  %237 = fcmp olt double %233, %161
  br i1 %237, label %250, label %246

238:                                              ; preds = %225
  %239 = tail call double @llvm.fabs.f64(double %231)
  %240 = tail call double @llvm.fabs.f64(double %230)
  %241 = fcmp olt double %240, %239
  %242 = select i1 %241, double %240, double %239
  %243 = fcmp ugt double %242, %217
  %244 = fcmp ugt double %233, %160
  %245 = or i1 %244, %243
  br i1 %245, label %246, label %250

246:                                              ; preds = %238, %236
  %247 = add nuw nsw i64 %226, 1
  %248 = icmp ugt i64 %226, 7
  %249 = icmp eq i64 %247, 9
  br i1 %249, label %337, label %225, !llvm.loop !26

250:                                              ; preds = %236, %238
  br i1 %227, label %337, label %251

251:                                              ; preds = %250, %311
  %252 = phi i32 [ 1, %311 ], [ %56, %250 ]
  %253 = icmp eq i32 %252, 0
  br i1 %253, label %254, label %325

254:                                              ; preds = %251
  %255 = load ptr, ptr %42, align 8
  %256 = load ptr, ptr %43, align 8
  %257 = getelementptr inbounds i8, ptr %256, i64 96
  %258 = load ptr, ptr %257, align 8
  store <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, ptr %258, align 8
  %259 = load ptr, ptr %256, align 8
  %260 = getelementptr inbounds i8, ptr %256, i64 192
  %261 = load ptr, ptr %260, align 8
  %262 = getelementptr inbounds i8, ptr %256, i64 8
  %263 = load i64, ptr %262, align 8
  %264 = load ptr, ptr %1, align 8
  %265 = load ptr, ptr %264, align 8
  %266 = getelementptr inbounds i8, ptr %265, i64 24
  %267 = load i64, ptr %266, align 8
  %268 = load ptr, ptr %257, align 8
  %269 = load ptr, ptr %44, align 8
  %270 = load ptr, ptr %269, align 8
  %271 = getelementptr inbounds i8, ptr %270, i64 16
  %272 = load i64, ptr %271, align 8
  tail call fastcc void @nested(ptr noundef %255, ptr noundef %259, ptr noundef %261, i64 noundef %263, i64 noundef %267, ptr noundef %268, i64 noundef %272) #8
  %273 = load ptr, ptr %41, align 8
  %274 = getelementptr inbounds i8, ptr %273, i64 8
  %275 = load i64, ptr %274, align 8
  %276 = icmp sgt i64 %275, 0
  br i1 %276, label %282, label %277

277:                                              ; preds = %282, %254
  %278 = load ptr, ptr %47, align 8
  store double %19, ptr %278, align 8
  %279 = load i64, ptr %48, align 8
  %280 = icmp sgt i64 %279, 0
  br i1 %280, label %281, label %311

281:                                              ; preds = %277
  tail call fastcc void @sample(ptr noundef nonnull %41) #8
  br label %311

282:                                              ; preds = %254, %282
  %283 = phi i64 [ %306, %282 ], [ 0, %254 ]
  %284 = load ptr, ptr %45, align 8
  %285 = getelementptr inbounds double, ptr %284, i64 %283
  %286 = load double, ptr %285, align 8
  %287 = load ptr, ptr %46, align 8
  %288 = getelementptr inbounds double, ptr %287, i64 %283
  %289 = load double, ptr %288, align 8
  %290 = load ptr, ptr %42, align 8
  %291 = getelementptr inbounds double, ptr %290, i64 %283
  %292 = load double, ptr %291, align 8
  %293 = tail call double @llvm.fabs.f64(double %292)
  %294 = fmul double %289, %293
  %295 = fadd double %286, %294
  %296 = and i64 %283, 1
  %297 = icmp eq i64 %296, 0
  %298 = urem i64 %283, 3
  %299 = uitofp nneg i64 %298 to double
  %300 = fmul double %299, 0x3FE3C6EF372FE950
  %301 = fadd double %300, 1.000000e+00
  %302 = fneg double %301
  %303 = select i1 %297, double %301, double %302
  %304 = fmul double %303, %295
  %305 = fadd double %292, %304
  store double %305, ptr %291, align 8
  %306 = add nuw nsw i64 %283, 1
  %307 = load ptr, ptr %41, align 8
  %308 = getelementptr inbounds i8, ptr %307, i64 8
  %309 = load i64, ptr %308, align 8
  %310 = icmp slt i64 %306, %309
  br i1 %310, label %282, label %277, !llvm.loop !27

311:                                              ; preds = %277, %281
  %312 = load ptr, ptr %6, align 8
  %313 = load i64, ptr %312, align 8
  %314 = load ptr, ptr %49, align 8
  %315 = load ptr, ptr %42, align 8
  %316 = load ptr, ptr %50, align 8
  %317 = load ptr, ptr %51, align 8
  %318 = load ptr, ptr %28, align 8
  %319 = getelementptr inbounds i8, ptr %312, i64 8
  %320 = load i64, ptr %319, align 8
  %321 = getelementptr inbounds double, ptr %318, i64 %320
  %322 = inttoptr i64 %313 to ptr
  %323 = tail call i32 %322(ptr noundef %314, ptr noundef %315, ptr noundef %316, ptr noundef %317, ptr noundef %321) #9
  %324 = icmp slt i32 %323, 0
  br i1 %324, label %337, label %251, !llvm.loop !28

325:                                              ; preds = %251
  %326 = load ptr, ptr %28, align 8
  %327 = getelementptr double, ptr %326, i64 %9
  %328 = getelementptr double, ptr %327, i64 %57
  %329 = load double, ptr %328, align 8
  %330 = getelementptr inbounds i8, ptr %60, i64 %52
  %331 = load double, ptr %330, align 8
  %332 = fsub double %329, %331
  %333 = tail call double @llvm.fabs.f64(double %332)
  %334 = fcmp ogt double %217, %333
  %335 = zext i1 %334 to i32
  %336 = select i1 %334, i64 -6, i64 %54
  br label %337

337:                                              ; preds = %246, %311, %325, %155, %250
  %338 = phi i32 [ 4, %250 ], [ 4, %155 ], [ %335, %325 ], [ 1, %311 ], [ 4, %246 ]
  %339 = phi i32 [ %56, %250 ], [ %56, %155 ], [ %252, %325 ], [ %252, %311 ], [ %56, %246 ]
  %340 = phi i64 [ %54, %250 ], [ %54, %155 ], [ %336, %325 ], [ -4, %311 ], [ %54, %246 ]
  br label %343

341:                                              ; preds = %137
  %342 = trunc nsw i64 %100 to i32
  br label %343

343:                                              ; preds = %341, %53, %94, %337
  %344 = phi i32 [ %338, %337 ], [ 4, %94 ], [ 4, %53 ], [ 1, %341 ]
  %345 = phi i32 [ %339, %337 ], [ %56, %94 ], [ %56, %53 ], [ %56, %341 ]
  %346 = phi i32 [ %156, %337 ], [ %55, %94 ], [ %55, %53 ], [ %342, %341 ]
  %347 = phi i64 [ %340, %337 ], [ %54, %94 ], [ %54, %53 ], [ -4, %341 ]
  switch i32 %344, label %351 [
    i32 0, label %348
    i32 4, label %348
  ]

348:                                              ; preds = %343, %343
  %349 = add nuw nsw i64 %57, 1
  %350 = icmp eq i64 %349, %9
  br i1 %350, label %351, label %53, !llvm.loop !29

351:                                              ; preds = %348, %343, %4
  %352 = phi i64 [ 0, %4 ], [ %347, %343 ], [ 0, %348 ]
  ret i64 %352
}

define internal fastcc double @locate(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, double noundef %3, double noundef %4, double noundef %5, i64 noundef %6) unnamed_addr #2 {
  %8 = getelementptr inbounds i8, ptr %0, i64 720
  %9 = getelementptr inbounds i8, ptr %0, i64 888
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i64, ptr %10, i64 %6
  %12 = load i64, ptr %11, align 8
  %13 = sitofp i64 %12 to double
  %14 = getelementptr inbounds i8, ptr %0, i64 936
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
  %29 = getelementptr inbounds i8, ptr %0, i64 984
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
  %13 = getelementptr inbounds i8, ptr %0, i64 936
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
  %58 = getelementptr inbounds i8, ptr %0, i64 984
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
