; sources acdb501c9a1f34064e6234d2c257f0b22bd85c024ba09101c0cc5c0cf09a8a0c
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
  br i1 %48, label %49, label %100

49:                                               ; preds = %47
  %50 = getelementptr inbounds i8, ptr %0, i64 816
  br label %96

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
  %89 = load ptr, ptr %88, align 8
  %90 = tail call i32 %89(ptr noundef %79, ptr noundef %80, ptr noundef %81, ptr noundef %82, ptr noundef %87) #9
  %91 = icmp slt i32 %90, 0
  br i1 %91, label %92, label %44

92:                                               ; preds = %76
  %93 = load ptr, ptr %20, align 8
  %94 = getelementptr inbounds i8, ptr %93, i64 80
  store i64 %23, ptr %94, align 8
  %95 = load ptr, ptr %19, align 8
  br label %971

96:                                               ; preds = %49, %116
  %97 = phi i64 [ 0, %49 ], [ %117, %116 ]
  %98 = load double, ptr %30, align 8
  %99 = fcmp une double %98, %1
  br i1 %99, label %102, label %100

100:                                              ; preds = %96, %116, %47
  %101 = call fastcc i64 @resolve(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2) #8
  switch i64 %101, label %975 [
    i64 0, label %123
    i64 -4, label %119
  ]

102:                                              ; preds = %96
  %103 = load ptr, ptr %50, align 8
  %104 = getelementptr inbounds i64, ptr %103, i64 %97
  %105 = load i64, ptr %104, align 8
  %106 = and i64 %105, 2
  %107 = icmp eq i64 %106, 0
  br i1 %107, label %116, label %108

108:                                              ; preds = %102
  %109 = getelementptr inbounds double, ptr %28, i64 %97
  %110 = load double, ptr %109, align 8
  %111 = fcmp une double %110, 0.000000e+00
  br i1 %111, label %112, label %116

112:                                              ; preds = %108
  %113 = fcmp ogt double %110, 0.000000e+00
  %114 = select i1 %113, i64 1, i64 -1
  %115 = getelementptr inbounds i64, ptr %16, i64 %97
  store i64 %114, ptr %115, align 8
  br label %116

116:                                              ; preds = %102, %108, %112
  %117 = add nuw nsw i64 %97, 1
  %118 = icmp eq i64 %117, %12
  br i1 %118, label %100, label %96, !llvm.loop !6

119:                                              ; preds = %100
  %120 = load ptr, ptr %20, align 8
  %121 = getelementptr inbounds i8, ptr %120, i64 80
  store i64 %23, ptr %121, align 8
  %122 = load ptr, ptr %19, align 8
  br label %971

123:                                              ; preds = %100
  store double 0x7FF8000000000000, ptr %30, align 8
  %124 = getelementptr inbounds i8, ptr %0, i64 984
  %125 = load ptr, ptr %7, align 8
  %126 = getelementptr inbounds i8, ptr %125, i64 96
  %127 = getelementptr inbounds i8, ptr %125, i64 192
  %128 = getelementptr inbounds i8, ptr %125, i64 8
  %129 = load ptr, ptr %4, align 8
  %130 = load ptr, ptr %5, align 8
  %131 = getelementptr inbounds i8, ptr %0, i64 168
  %132 = getelementptr inbounds i8, ptr %0, i64 248
  %133 = getelementptr inbounds i8, ptr %0, i64 168
  %134 = getelementptr inbounds i8, ptr %0, i64 192
  %135 = getelementptr inbounds i8, ptr %0, i64 744
  %136 = icmp sgt i64 %12, 0
  %137 = getelementptr inbounds i8, ptr %0, i64 984
  %138 = load ptr, ptr %7, align 8
  %139 = getelementptr inbounds i8, ptr %138, i64 96
  %140 = getelementptr inbounds i8, ptr %138, i64 192
  %141 = getelementptr inbounds i8, ptr %138, i64 8
  %142 = load ptr, ptr %4, align 8
  %143 = load ptr, ptr %5, align 8
  %144 = getelementptr inbounds i8, ptr %0, i64 168
  %145 = getelementptr inbounds i8, ptr %0, i64 248
  %146 = getelementptr inbounds i8, ptr %0, i64 168
  %147 = getelementptr inbounds i8, ptr %0, i64 192
  %148 = getelementptr inbounds i8, ptr %0, i64 744
  %149 = icmp sgt i64 %12, 0
  %150 = icmp sgt i64 %12, 0
  %151 = getelementptr inbounds i8, ptr %0, i64 792
  %152 = getelementptr inbounds i8, ptr %24, i64 48
  %153 = getelementptr inbounds i8, ptr %0, i64 624
  %154 = getelementptr inbounds i8, ptr %0, i64 632
  %155 = fadd double %1, %2
  %156 = tail call double @llvm.fabs.f64(double %155)
  %157 = getelementptr inbounds i8, ptr %0, i64 968
  %158 = getelementptr inbounds i8, ptr %0, i64 960
  %159 = icmp sgt i64 %12, 0
  %160 = getelementptr inbounds i8, ptr %0, i64 1016
  %161 = getelementptr inbounds i8, ptr %0, i64 1008
  %162 = getelementptr inbounds i8, ptr %0, i64 1032
  %163 = getelementptr inbounds i8, ptr %0, i64 1080
  %164 = getelementptr inbounds i8, ptr %0, i64 1056
  %165 = getelementptr inbounds i8, ptr %0, i64 624
  %166 = getelementptr inbounds i8, ptr %0, i64 632
  %167 = fadd double %1, %2
  %168 = tail call double @llvm.fabs.f64(double %167)
  %169 = getelementptr inbounds i8, ptr %0, i64 968
  %170 = getelementptr inbounds i8, ptr %0, i64 960
  %171 = getelementptr inbounds i8, ptr %0, i64 1016
  %172 = getelementptr inbounds i8, ptr %24, i64 48
  %173 = icmp sgt i64 %12, 0
  %174 = getelementptr inbounds i8, ptr %24, i64 48
  %175 = icmp sgt i64 %12, 0
  %176 = getelementptr inbounds i8, ptr %0, i64 968
  %177 = getelementptr inbounds i8, ptr %0, i64 960
  br label %178

178:                                              ; preds = %123, %950
  %179 = phi i1 [ false, %123 ], [ %954, %950 ]
  %180 = phi i64 [ -4, %123 ], [ %948, %950 ]
  %181 = phi double [ 0.000000e+00, %123 ], [ %947, %950 ]
  %182 = phi i32 [ 1, %123 ], [ %953, %950 ]
  %183 = zext nneg i32 %182 to i64
  %184 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %183
  %185 = load double, ptr %184, align 8
  %186 = mul nsw i64 %12, %183
  %187 = load ptr, ptr %9, align 8
  %188 = getelementptr inbounds i8, ptr %187, i64 8
  %189 = load i64, ptr %188, align 8
  %190 = icmp sgt i64 %189, 0
  br i1 %190, label %191, label %232

191:                                              ; preds = %178
  %192 = add nsw i32 %182, -1
  %193 = icmp ugt i32 %182, 1
  %194 = select i1 %193, i32 %192, i32 1
  %195 = tail call i32 @llvm.smin.i32(i32 %182, i32 3)
  %196 = icmp sgt i32 %194, %195
  %197 = zext nneg i32 %182 to i64
  %198 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %197
  br label %202

199:                                              ; preds = %229
  %200 = add nuw nsw i64 %204, 1
  %201 = icmp eq i64 %200, %189
  br i1 %201, label %232, label %202, !llvm.loop !7

202:                                              ; preds = %191, %199
  %203 = phi double [ 2.000000e+00, %191 ], [ %231, %199 ]
  %204 = phi i64 [ 0, %191 ], [ %200, %199 ]
  %205 = load ptr, ptr %15, align 8
  %206 = getelementptr inbounds i64, ptr %205, i64 %204
  %207 = load i64, ptr %206, align 8
  %208 = sitofp i64 %207 to double
  br i1 %196, label %229, label %213

209:                                              ; preds = %227
  %210 = add i32 %215, 1
  %211 = icmp sge i32 %215, %195
  %212 = icmp eq i32 %215, %195
  br i1 %212, label %229, label %213, !llvm.loop !8

213:                                              ; preds = %202, %209
  %214 = phi i1 [ %211, %209 ], [ %196, %202 ]
  %215 = phi i32 [ %210, %209 ], [ %194, %202 ]
  %216 = phi double [ %228, %209 ], [ %203, %202 ]
  %217 = call fastcc double @least_place(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, i64 noundef %204, double noundef %208, i32 noundef %215, i32 noundef %182) #8
  %218 = fcmp une double %217, -4.000000e+00
  %219 = fcmp ogt double %217, %181
  %220 = and i1 %218, %219
  br i1 %220, label %221, label %227

221:                                              ; preds = %213
  %222 = load double, ptr %198, align 8
  %223 = fcmp olt double %216, %222
  %224 = select i1 %223, double %216, double %222
  %225 = fcmp olt double %217, %224
  br i1 %225, label %226, label %227

226:                                              ; preds = %221
  br label %227

227:                                              ; preds = %226, %221, %213
  %228 = phi double [ %216, %213 ], [ %217, %226 ], [ %216, %221 ]
  br i1 %218, label %209, label %229

229:                                              ; preds = %209, %227, %202
  %230 = phi i1 [ %196, %202 ], [ %211, %209 ], [ %214, %227 ]
  %231 = phi double [ %203, %202 ], [ %228, %227 ], [ %228, %209 ]
  br i1 %230, label %199, label %232

232:                                              ; preds = %229, %199, %178
  %233 = phi double [ 2.000000e+00, %178 ], [ -4.000000e+00, %229 ], [ %231, %199 ]
  %234 = fcmp olt double %233, 0.000000e+00
  br i1 %234, label %940, label %235

235:                                              ; preds = %232
  %236 = getelementptr double, ptr %28, i64 %186
  %237 = fcmp olt double %233, %185
  br i1 %237, label %238, label %272

238:                                              ; preds = %235
  %239 = load ptr, ptr %25, align 8
  %240 = load ptr, ptr %124, align 8
  %241 = load ptr, ptr %126, align 8
  %242 = insertelement <8 x double> poison, double %233, i64 0
  %243 = shufflevector <8 x double> %242, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %243, ptr %241, align 8
  %244 = load ptr, ptr %125, align 8
  %245 = load ptr, ptr %127, align 8
  %246 = load i64, ptr %128, align 8
  %247 = load ptr, ptr %129, align 8
  %248 = getelementptr inbounds i8, ptr %247, i64 24
  %249 = load i64, ptr %248, align 8
  %250 = load ptr, ptr %126, align 8
  %251 = load ptr, ptr %130, align 8
  %252 = getelementptr inbounds i8, ptr %251, i64 16
  %253 = load i64, ptr %252, align 8
  tail call fastcc void @nested(ptr noundef %240, ptr noundef %244, ptr noundef %245, i64 noundef %246, i64 noundef %249, ptr noundef %250, i64 noundef %253) #8
  %254 = fmul double %233, %2
  %255 = fadd double %254, %1
  %256 = load ptr, ptr %131, align 8
  store double %255, ptr %256, align 8
  %257 = load i64, ptr %132, align 8
  %258 = icmp sgt i64 %257, 0
  br i1 %258, label %259, label %260

259:                                              ; preds = %238
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %260

260:                                              ; preds = %238, %259
  %261 = load ptr, ptr %9, align 8
  %262 = load i64, ptr %261, align 8
  %263 = load ptr, ptr %133, align 8
  %264 = load ptr, ptr %124, align 8
  %265 = load ptr, ptr %134, align 8
  %266 = load ptr, ptr %135, align 8
  %267 = load ptr, ptr %25, align 8
  %268 = inttoptr i64 %262 to ptr
  %269 = load ptr, ptr %268, align 8
  %270 = tail call i32 %269(ptr noundef %263, ptr noundef %264, ptr noundef %265, ptr noundef %266, ptr noundef %267) #9
  %271 = icmp slt i32 %270, 0
  br i1 %271, label %940, label %272

272:                                              ; preds = %260, %235
  %273 = phi double [ %233, %260 ], [ %185, %235 ]
  %274 = phi ptr [ %239, %260 ], [ %236, %235 ]
  br label %275

275:                                              ; preds = %884, %272
  %276 = phi double [ %181, %272 ], [ %886, %884 ]
  %277 = phi i64 [ %180, %272 ], [ %887, %884 ]
  br i1 %136, label %281, label %278

278:                                              ; preds = %316, %275
  %279 = phi double [ 2.000000e+00, %275 ], [ %317, %316 ]
  %280 = fcmp ogt double %279, 1.000000e+00
  br i1 %280, label %884, label %320

281:                                              ; preds = %275, %316
  %282 = phi i64 [ %318, %316 ], [ 0, %275 ]
  %283 = phi double [ %317, %316 ], [ 2.000000e+00, %275 ]
  %284 = getelementptr inbounds i64, ptr %18, i64 %282
  store i64 0, ptr %284, align 8
  %285 = getelementptr inbounds i64, ptr %16, i64 %282
  %286 = load i64, ptr %285, align 8
  %287 = getelementptr inbounds double, ptr %274, i64 %282
  %288 = load double, ptr %287, align 8
  %289 = getelementptr inbounds i64, ptr %14, i64 %282
  %290 = load i64, ptr %289, align 8
  %291 = icmp slt i64 %286, 0
  %292 = fcmp ogt double %288, 0.000000e+00
  %293 = and i1 %291, %292
  %294 = icmp sgt i64 %290, -1
  %295 = and i1 %293, %294
  br i1 %295, label %303, label %296

296:                                              ; preds = %281
  %297 = icmp sgt i64 %286, 0
  %298 = fcmp olt double %288, 0.000000e+00
  %299 = and i1 %297, %298
  br i1 %299, label %300, label %303

300:                                              ; preds = %296
  %301 = icmp slt i64 %290, 1
  %302 = zext i1 %301 to i32
  br label %303

303:                                              ; preds = %281, %296, %300
  %304 = phi i32 [ 1, %281 ], [ 0, %296 ], [ %302, %300 ]
  %305 = icmp eq i32 %304, 0
  br i1 %305, label %306, label %310

306:                                              ; preds = %303
  %307 = icmp eq i64 %286, 0
  %308 = fcmp ord double %288, 0.000000e+00
  %309 = or i1 %307, %308
  br i1 %309, label %316, label %310

310:                                              ; preds = %306, %303
  %311 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %276, double noundef %273, i64 noundef %282) #8
  %312 = fcmp ole double %311, %276
  %313 = zext i1 %312 to i64
  store i64 %313, ptr %284, align 8
  %314 = fcmp olt double %311, %283
  %315 = select i1 %314, double %311, double %283
  br label %316

316:                                              ; preds = %306, %310
  %317 = phi double [ %315, %310 ], [ %283, %306 ]
  %318 = add nuw nsw i64 %282, 1
  %319 = icmp eq i64 %318, %12
  br i1 %319, label %278, label %281, !llvm.loop !9

320:                                              ; preds = %278
  %321 = load ptr, ptr %137, align 8
  %322 = load ptr, ptr %139, align 8
  %323 = insertelement <8 x double> poison, double %279, i64 0
  %324 = shufflevector <8 x double> %323, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %324, ptr %322, align 8
  %325 = load ptr, ptr %138, align 8
  %326 = load ptr, ptr %140, align 8
  %327 = load i64, ptr %141, align 8
  %328 = load ptr, ptr %142, align 8
  %329 = getelementptr inbounds i8, ptr %328, i64 24
  %330 = load i64, ptr %329, align 8
  %331 = load ptr, ptr %139, align 8
  %332 = load ptr, ptr %143, align 8
  %333 = getelementptr inbounds i8, ptr %332, i64 16
  %334 = load i64, ptr %333, align 8
  tail call fastcc void @nested(ptr noundef %321, ptr noundef %325, ptr noundef %326, i64 noundef %327, i64 noundef %330, ptr noundef %331, i64 noundef %334) #8
  %335 = fmul double %279, %2
  %336 = fadd double %335, %1
  %337 = load ptr, ptr %144, align 8
  store double %336, ptr %337, align 8
  %338 = load i64, ptr %145, align 8
  %339 = icmp sgt i64 %338, 0
  br i1 %339, label %340, label %341

340:                                              ; preds = %320
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %341

341:                                              ; preds = %320, %340
  %342 = load ptr, ptr %9, align 8
  %343 = load i64, ptr %342, align 8
  %344 = load ptr, ptr %146, align 8
  %345 = load ptr, ptr %137, align 8
  %346 = load ptr, ptr %147, align 8
  %347 = load ptr, ptr %148, align 8
  %348 = load ptr, ptr %25, align 8
  %349 = getelementptr inbounds i8, ptr %342, i64 8
  %350 = load i64, ptr %349, align 8
  %351 = getelementptr inbounds double, ptr %348, i64 %350
  %352 = inttoptr i64 %343 to ptr
  %353 = load ptr, ptr %352, align 8
  %354 = tail call i32 %353(ptr noundef %344, ptr noundef %345, ptr noundef %346, ptr noundef %347, ptr noundef %351) #9
  %355 = icmp slt i32 %354, 0
  br i1 %355, label %357, label %356

356:                                              ; preds = %341
  br i1 %149, label %362, label %459

357:                                              ; preds = %341
  %358 = load ptr, ptr %20, align 8
  %359 = getelementptr inbounds i8, ptr %358, i64 80
  store i64 %23, ptr %359, align 8
  %360 = load ptr, ptr %19, align 8
  %361 = getelementptr inbounds i8, ptr %360, i64 48
  store double 1.000000e+00, ptr %361, align 8
  br label %884

362:                                              ; preds = %356, %453
  %363 = phi i1 [ %457, %453 ], [ %149, %356 ]
  %364 = phi i64 [ %455, %453 ], [ %277, %356 ]
  %365 = phi i64 [ %456, %453 ], [ 0, %356 ]
  %366 = phi double [ %454, %453 ], [ %279, %356 ]
  %367 = getelementptr inbounds i64, ptr %16, i64 %365
  %368 = load i64, ptr %367, align 8
  %369 = getelementptr inbounds double, ptr %31, i64 %365
  %370 = load double, ptr %369, align 8
  %371 = getelementptr inbounds i64, ptr %14, i64 %365
  %372 = load i64, ptr %371, align 8
  %373 = icmp slt i64 %368, 0
  %374 = fcmp ogt double %370, 0.000000e+00
  %375 = and i1 %373, %374
  %376 = icmp sgt i64 %372, -1
  %377 = and i1 %375, %376
  br i1 %377, label %385, label %378

378:                                              ; preds = %362
  %379 = icmp sgt i64 %368, 0
  %380 = fcmp olt double %370, 0.000000e+00
  %381 = and i1 %379, %380
  br i1 %381, label %382, label %385

382:                                              ; preds = %378
  %383 = icmp slt i64 %372, 1
  %384 = zext i1 %383 to i32
  br label %385

385:                                              ; preds = %362, %378, %382
  %386 = phi i32 [ 1, %362 ], [ 0, %378 ], [ %384, %382 ]
  %387 = icmp eq i32 %386, 0
  br i1 %387, label %453, label %388

388:                                              ; preds = %385
  %389 = getelementptr inbounds double, ptr %274, i64 %365
  %390 = load double, ptr %389, align 8
  %391 = fcmp ogt double %390, 0.000000e+00
  %392 = and i1 %373, %391
  %393 = and i1 %376, %392
  br i1 %393, label %401, label %394

394:                                              ; preds = %388
  %395 = icmp sgt i64 %368, 0
  %396 = fcmp olt double %390, 0.000000e+00
  %397 = and i1 %395, %396
  br i1 %397, label %398, label %401

398:                                              ; preds = %394
  %399 = icmp slt i64 %372, 1
  %400 = zext i1 %399 to i32
  br label %401

401:                                              ; preds = %388, %394, %398
  %402 = phi i32 [ 1, %388 ], [ 0, %394 ], [ %400, %398 ]
  %403 = icmp eq i32 %402, 0
  br i1 %403, label %404, label %453

404:                                              ; preds = %401
  %405 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %276, double noundef %366, i64 noundef %365) #8
  %406 = fcmp ogt double %405, %276
  br i1 %406, label %407, label %409

407:                                              ; preds = %404
  %408 = getelementptr inbounds i64, ptr %18, i64 %365
  store i64 2, ptr %408, align 8
  br label %409

409:                                              ; preds = %407, %404
  %410 = phi double [ %405, %407 ], [ %366, %404 ]
  %411 = load ptr, ptr %137, align 8
  %412 = load ptr, ptr %139, align 8
  %413 = insertelement <8 x double> poison, double %410, i64 0
  %414 = shufflevector <8 x double> %413, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %414, ptr %412, align 8
  %415 = load ptr, ptr %138, align 8
  %416 = load ptr, ptr %140, align 8
  %417 = load i64, ptr %141, align 8
  %418 = load ptr, ptr %142, align 8
  %419 = getelementptr inbounds i8, ptr %418, i64 24
  %420 = load i64, ptr %419, align 8
  %421 = load ptr, ptr %139, align 8
  %422 = load ptr, ptr %143, align 8
  %423 = getelementptr inbounds i8, ptr %422, i64 16
  %424 = load i64, ptr %423, align 8
  tail call fastcc void @nested(ptr noundef %411, ptr noundef %415, ptr noundef %416, i64 noundef %417, i64 noundef %420, ptr noundef %421, i64 noundef %424) #8
  %425 = fmul double %410, %2
  %426 = fadd double %425, %1
  %427 = load ptr, ptr %144, align 8
  store double %426, ptr %427, align 8
  %428 = load i64, ptr %145, align 8
  %429 = icmp sgt i64 %428, 0
  br i1 %429, label %430, label %431

430:                                              ; preds = %409
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %431

431:                                              ; preds = %409, %430
  %432 = load ptr, ptr %9, align 8
  %433 = load i64, ptr %432, align 8
  %434 = load ptr, ptr %146, align 8
  %435 = load ptr, ptr %137, align 8
  %436 = load ptr, ptr %147, align 8
  %437 = load ptr, ptr %148, align 8
  %438 = load ptr, ptr %25, align 8
  %439 = getelementptr inbounds i8, ptr %432, i64 8
  %440 = load i64, ptr %439, align 8
  %441 = getelementptr inbounds double, ptr %438, i64 %440
  %442 = inttoptr i64 %433 to ptr
  %443 = load ptr, ptr %442, align 8
  %444 = tail call i32 %443(ptr noundef %434, ptr noundef %435, ptr noundef %436, ptr noundef %437, ptr noundef %441) #9
  %445 = icmp sgt i32 %444, -1
  br i1 %445, label %451, label %446

446:                                              ; preds = %431
  %447 = load ptr, ptr %20, align 8
  %448 = getelementptr inbounds i8, ptr %447, i64 80
  store i64 %23, ptr %448, align 8
  %449 = load ptr, ptr %19, align 8
  %450 = getelementptr inbounds i8, ptr %449, i64 48
  store double 1.000000e+00, ptr %450, align 8
  br label %451

451:                                              ; preds = %431, %446
  %452 = phi i64 [ -4, %446 ], [ %364, %431 ]
  br i1 %445, label %453, label %459

453:                                              ; preds = %385, %401, %451
  %454 = phi double [ %366, %401 ], [ %410, %451 ], [ %366, %385 ]
  %455 = phi i64 [ %364, %401 ], [ %452, %451 ], [ %364, %385 ]
  %456 = add nuw nsw i64 %365, 1
  %457 = icmp slt i64 %456, %12
  %458 = icmp eq i64 %456, %12
  br i1 %458, label %459, label %362, !llvm.loop !10

459:                                              ; preds = %451, %453, %356
  %460 = phi i1 [ %149, %356 ], [ %363, %451 ], [ %457, %453 ]
  %461 = phi i32 [ 16, %356 ], [ 1, %451 ], [ 16, %453 ]
  %462 = phi double [ %279, %356 ], [ %410, %451 ], [ %454, %453 ]
  %463 = phi i64 [ %277, %356 ], [ %452, %451 ], [ %455, %453 ]
  br i1 %460, label %884, label %464

464:                                              ; preds = %459
  br i1 %150, label %475, label %467

465:                                              ; preds = %562
  %466 = zext i1 %563 to i32
  br label %467

467:                                              ; preds = %465, %464
  %468 = phi i32 [ 0, %464 ], [ %466, %465 ]
  %469 = phi i64 [ -1, %464 ], [ %552, %465 ]
  %470 = icmp eq i32 %468, 0
  br i1 %470, label %471, label %566

471:                                              ; preds = %467
  br i1 %159, label %472, label %693

472:                                              ; preds = %471
  %473 = fmul double %462, %2
  %474 = fadd double %473, %1
  br label %815

475:                                              ; preds = %464, %562
  %476 = phi i64 [ %564, %562 ], [ 0, %464 ]
  %477 = phi i64 [ %552, %562 ], [ -1, %464 ]
  %478 = phi i1 [ %563, %562 ], [ false, %464 ]
  %479 = getelementptr inbounds double, ptr %31, i64 %476
  %480 = load double, ptr %479, align 8
  %481 = getelementptr inbounds i64, ptr %16, i64 %476
  %482 = load i64, ptr %481, align 8
  %483 = getelementptr inbounds i64, ptr %14, i64 %476
  %484 = load i64, ptr %483, align 8
  %485 = icmp slt i64 %482, 0
  %486 = fcmp ogt double %480, 0.000000e+00
  %487 = and i1 %486, %485
  %488 = icmp sgt i64 %484, -1
  %489 = and i1 %487, %488
  br i1 %489, label %497, label %490

490:                                              ; preds = %475
  %491 = icmp sgt i64 %482, 0
  %492 = fcmp olt double %480, 0.000000e+00
  %493 = and i1 %492, %491
  br i1 %493, label %494, label %497

494:                                              ; preds = %490
  %495 = icmp slt i64 %484, 1
  %496 = zext i1 %495 to i32
  br label %497

497:                                              ; preds = %475, %490, %494
  %498 = phi i32 [ 1, %475 ], [ 0, %490 ], [ %496, %494 ]
  %499 = icmp eq i32 %498, 0
  br i1 %499, label %500, label %525

500:                                              ; preds = %497
  %501 = getelementptr inbounds double, ptr %274, i64 %476
  %502 = load double, ptr %501, align 8
  %503 = fcmp ogt double %502, 0.000000e+00
  %504 = and i1 %485, %503
  %505 = and i1 %488, %504
  br i1 %505, label %513, label %506

506:                                              ; preds = %500
  %507 = icmp sgt i64 %482, 0
  %508 = fcmp olt double %502, 0.000000e+00
  %509 = and i1 %507, %508
  br i1 %509, label %510, label %513

510:                                              ; preds = %506
  %511 = icmp slt i64 %484, 1
  %512 = zext i1 %511 to i32
  br label %513

513:                                              ; preds = %500, %506, %510
  %514 = phi i32 [ 1, %500 ], [ 0, %506 ], [ %512, %510 ]
  %515 = icmp eq i32 %514, 0
  br i1 %515, label %525, label %516

516:                                              ; preds = %513
  %517 = fcmp oeq double %480, 0.000000e+00
  br i1 %517, label %522, label %518

518:                                              ; preds = %516
  %519 = getelementptr inbounds i64, ptr %18, i64 %476
  %520 = load i64, ptr %519, align 8
  %521 = icmp eq i64 %520, 1
  br label %522

522:                                              ; preds = %518, %516
  %523 = phi i1 [ true, %516 ], [ %521, %518 ]
  %524 = zext i1 %523 to i32
  br label %525

525:                                              ; preds = %522, %513, %497
  %526 = phi i32 [ 1, %497 ], [ %524, %522 ], [ 0, %513 ]
  %527 = icmp eq i32 %526, 0
  br i1 %527, label %528, label %534

528:                                              ; preds = %525
  %529 = getelementptr inbounds i64, ptr %18, i64 %476
  %530 = load i64, ptr %529, align 8
  %531 = icmp eq i64 %530, 2
  %532 = fcmp oeq double %480, 0.000000e+00
  %533 = and i1 %532, %531
  br label %534

534:                                              ; preds = %528, %525
  %535 = phi i1 [ true, %525 ], [ %533, %528 ]
  br i1 %535, label %551, label %536

536:                                              ; preds = %534
  %537 = getelementptr inbounds double, ptr %274, i64 %476
  %538 = load double, ptr %537, align 8
  %539 = icmp eq i64 %482, 0
  %540 = fcmp ord double %538, 0.000000e+00
  %541 = or i1 %539, %540
  br i1 %541, label %551, label %542

542:                                              ; preds = %536
  %543 = sitofp i64 %482 to double
  %544 = fmul double %480, %543
  %545 = fcmp olt double %544, 0.000000e+00
  br i1 %545, label %546, label %548

546:                                              ; preds = %542
  %547 = sub nsw i64 0, %482
  store i64 %547, ptr %481, align 8
  br label %551

548:                                              ; preds = %542
  %549 = fcmp ueq double %480, 0.000000e+00
  %550 = select i1 %549, i64 %476, i64 %477
  br label %551

551:                                              ; preds = %548, %546, %536, %534
  %552 = phi i64 [ %477, %534 ], [ %477, %546 ], [ %477, %536 ], [ %550, %548 ]
  %553 = zext i1 %535 to i64
  %554 = getelementptr inbounds i64, ptr %18, i64 %476
  store i64 %553, ptr %554, align 8
  %555 = xor i1 %535, true
  %556 = or i1 %478, %555
  br i1 %556, label %562, label %557

557:                                              ; preds = %551
  %558 = load ptr, ptr %151, align 8
  %559 = getelementptr inbounds i64, ptr %558, i64 %476
  %560 = load i64, ptr %559, align 8
  %561 = icmp eq i64 %560, 1
  br label %562

562:                                              ; preds = %551, %557
  %563 = phi i1 [ %478, %551 ], [ %561, %557 ]
  %564 = add nuw nsw i64 %476, 1
  %565 = icmp eq i64 %564, %12
  br i1 %565, label %465, label %475, !llvm.loop !11

566:                                              ; preds = %467
  store double %462, ptr %152, align 8
  %567 = load ptr, ptr %9, align 8
  %568 = getelementptr inbounds i8, ptr %567, i64 8
  %569 = load i64, ptr %568, align 8
  %570 = load ptr, ptr %25, align 8
  %571 = getelementptr inbounds double, ptr %570, i64 %569
  %572 = mul i64 %569, 56
  %573 = getelementptr inbounds i8, ptr %570, i64 %572
  %574 = load ptr, ptr %153, align 8
  %575 = load i64, ptr %154, align 8
  %576 = getelementptr double, ptr %574, i64 %575
  %577 = getelementptr i8, ptr %576, i64 -8
  %578 = load double, ptr %577, align 8
  %579 = load double, ptr %574, align 8
  %580 = fsub double %578, %579
  %581 = icmp sgt i64 %569, 0
  br i1 %581, label %585, label %582

582:                                              ; preds = %598, %566
  %583 = phi i32 [ 0, %566 ], [ %600, %598 ]
  %584 = icmp eq i32 %583, 0
  br i1 %584, label %884, label %603

585:                                              ; preds = %566, %598
  %586 = phi i64 [ %601, %598 ], [ 0, %566 ]
  %587 = phi i32 [ %600, %598 ], [ 0, %566 ]
  %588 = icmp eq i32 %587, 0
  br i1 %588, label %589, label %598

589:                                              ; preds = %585
  %590 = load ptr, ptr %17, align 8
  %591 = getelementptr inbounds i64, ptr %590, i64 %586
  %592 = load i64, ptr %591, align 8
  %593 = icmp eq i64 %592, 0
  br i1 %593, label %598, label %594

594:                                              ; preds = %589
  %595 = getelementptr inbounds double, ptr %571, i64 %586
  %596 = load double, ptr %595, align 8
  %597 = fcmp oeq double %596, 0.000000e+00
  br label %598

598:                                              ; preds = %594, %589, %585
  %599 = phi i1 [ true, %585 ], [ false, %589 ], [ %597, %594 ]
  %600 = zext i1 %599 to i32
  %601 = add nuw nsw i64 %586, 1
  %602 = icmp eq i64 %601, %569
  br i1 %602, label %582, label %585, !llvm.loop !12

603:                                              ; preds = %582
  %604 = fsub double %273, %462
  %605 = fmul double %604, %2
  %606 = fcmp ogt double %156, %580
  %607 = select i1 %606, double %156, double %580
  %608 = fmul double %607, 0x3F50000000000000
  %609 = fcmp ugt double %605, %608
  br i1 %609, label %610, label %884

610:                                              ; preds = %603
  %611 = fmul double %604, 0x3F50000000000000
  %612 = fadd double %462, %611
  %613 = load ptr, ptr %137, align 8
  %614 = load ptr, ptr %139, align 8
  %615 = insertelement <8 x double> poison, double %612, i64 0
  %616 = shufflevector <8 x double> %615, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %616, ptr %614, align 8
  %617 = load ptr, ptr %138, align 8
  %618 = load ptr, ptr %140, align 8
  %619 = load i64, ptr %141, align 8
  %620 = load ptr, ptr %142, align 8
  %621 = getelementptr inbounds i8, ptr %620, i64 24
  %622 = load i64, ptr %621, align 8
  %623 = load ptr, ptr %139, align 8
  %624 = load ptr, ptr %143, align 8
  %625 = getelementptr inbounds i8, ptr %624, i64 16
  %626 = load i64, ptr %625, align 8
  tail call fastcc void @nested(ptr noundef %613, ptr noundef %617, ptr noundef %618, i64 noundef %619, i64 noundef %622, ptr noundef %623, i64 noundef %626) #8
  %627 = fmul double %612, %2
  %628 = fadd double %627, %1
  %629 = load ptr, ptr %144, align 8
  store double %628, ptr %629, align 8
  %630 = load i64, ptr %145, align 8
  %631 = icmp sgt i64 %630, 0
  br i1 %631, label %632, label %633

632:                                              ; preds = %610
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %633

633:                                              ; preds = %610, %632
  %634 = load ptr, ptr %9, align 8
  %635 = load i64, ptr %634, align 8
  %636 = load ptr, ptr %146, align 8
  %637 = load ptr, ptr %137, align 8
  %638 = load ptr, ptr %147, align 8
  %639 = load ptr, ptr %148, align 8
  %640 = load ptr, ptr %25, align 8
  %641 = getelementptr inbounds i8, ptr %634, i64 8
  %642 = load i64, ptr %641, align 8
  %643 = mul i64 %642, 56
  %644 = getelementptr inbounds i8, ptr %640, i64 %643
  %645 = inttoptr i64 %635 to ptr
  %646 = load ptr, ptr %645, align 8
  %647 = tail call i32 %646(ptr noundef %636, ptr noundef %637, ptr noundef %638, ptr noundef %639, ptr noundef %644) #9
  %648 = icmp slt i32 %647, 0
  br i1 %648, label %688, label %649

649:                                              ; preds = %633
  %650 = icmp sgt i64 %569, 0
  br i1 %650, label %651, label %884

651:                                              ; preds = %649
  %652 = fmul double %462, %2
  %653 = fadd double %652, %1
  %654 = fsub double %653, %653
  br label %655

655:                                              ; preds = %651, %685
  %656 = phi i64 [ 0, %651 ], [ %686, %685 ]
  %657 = load ptr, ptr %17, align 8
  %658 = getelementptr inbounds i64, ptr %657, i64 %656
  %659 = load i64, ptr %658, align 8
  %660 = icmp eq i64 %659, 0
  br i1 %660, label %685, label %661

661:                                              ; preds = %655
  %662 = getelementptr inbounds double, ptr %571, i64 %656
  %663 = load double, ptr %662, align 8
  %664 = fcmp oeq double %663, 0.000000e+00
  br i1 %664, label %665, label %685

665:                                              ; preds = %661
  %666 = getelementptr inbounds double, ptr %573, i64 %656
  %667 = load double, ptr %666, align 8
  %668 = fcmp oeq double %667, 0.000000e+00
  br i1 %668, label %669, label %685

669:                                              ; preds = %665
  %670 = load i64, ptr %157, align 8
  %671 = icmp eq i64 %670, 0
  br i1 %671, label %685, label %672

672:                                              ; preds = %669
  %673 = load ptr, ptr %158, align 8
  %674 = shl nsw i64 %656, 4
  %675 = getelementptr inbounds i8, ptr %673, i64 %674
  %676 = getelementptr inbounds i8, ptr %675, i64 8
  %677 = load double, ptr %676, align 8
  %678 = fcmp oeq double %677, %653
  br i1 %678, label %684, label %679

679:                                              ; preds = %672
  %680 = load double, ptr %675, align 8
  %681 = fsub double %677, %680
  %682 = fcmp ult double %681, %654
  br i1 %682, label %683, label %685

683:                                              ; preds = %679
  store double %653, ptr %675, align 8
  br label %684

684:                                              ; preds = %672, %683
  store double %653, ptr %676, align 8
  br label %685

685:                                              ; preds = %684, %679, %669, %665, %661, %655
  %686 = add nuw nsw i64 %656, 1
  %687 = icmp eq i64 %686, %569
  br i1 %687, label %884, label %655, !llvm.loop !13

688:                                              ; preds = %633
  %689 = load ptr, ptr %20, align 8
  %690 = getelementptr inbounds i8, ptr %689, i64 80
  store i64 %23, ptr %690, align 8
  %691 = load ptr, ptr %19, align 8
  %692 = getelementptr inbounds i8, ptr %691, i64 48
  store double 1.000000e+00, ptr %692, align 8
  br label %884

693:                                              ; preds = %857, %471
  %694 = load ptr, ptr %9, align 8
  %695 = getelementptr inbounds i8, ptr %694, i64 8
  %696 = load i64, ptr %695, align 8
  %697 = load ptr, ptr %25, align 8
  %698 = getelementptr inbounds double, ptr %697, i64 %696
  %699 = mul i64 %696, 56
  %700 = getelementptr inbounds i8, ptr %697, i64 %699
  %701 = load ptr, ptr %165, align 8
  %702 = load i64, ptr %166, align 8
  %703 = getelementptr double, ptr %701, i64 %702
  %704 = getelementptr i8, ptr %703, i64 -8
  %705 = load double, ptr %704, align 8
  %706 = load double, ptr %701, align 8
  %707 = fsub double %705, %706
  %708 = icmp sgt i64 %696, 0
  br i1 %708, label %712, label %709

709:                                              ; preds = %725, %693
  %710 = phi i32 [ 0, %693 ], [ %727, %725 ]
  %711 = icmp eq i32 %710, 0
  br i1 %711, label %865, label %730

712:                                              ; preds = %693, %725
  %713 = phi i64 [ %728, %725 ], [ 0, %693 ]
  %714 = phi i32 [ %727, %725 ], [ 0, %693 ]
  %715 = icmp eq i32 %714, 0
  br i1 %715, label %716, label %725

716:                                              ; preds = %712
  %717 = load ptr, ptr %17, align 8
  %718 = getelementptr inbounds i64, ptr %717, i64 %713
  %719 = load i64, ptr %718, align 8
  %720 = icmp eq i64 %719, 0
  br i1 %720, label %725, label %721

721:                                              ; preds = %716
  %722 = getelementptr inbounds double, ptr %698, i64 %713
  %723 = load double, ptr %722, align 8
  %724 = fcmp oeq double %723, 0.000000e+00
  br label %725

725:                                              ; preds = %721, %716, %712
  %726 = phi i1 [ true, %712 ], [ false, %716 ], [ %724, %721 ]
  %727 = zext i1 %726 to i32
  %728 = add nuw nsw i64 %713, 1
  %729 = icmp eq i64 %728, %696
  br i1 %729, label %709, label %712, !llvm.loop !12

730:                                              ; preds = %709
  %731 = fsub double %273, %462
  %732 = fmul double %731, %2
  %733 = fcmp ogt double %168, %707
  %734 = select i1 %733, double %168, double %707
  %735 = fmul double %734, 0x3F50000000000000
  %736 = fcmp ugt double %732, %735
  br i1 %736, label %737, label %865

737:                                              ; preds = %730
  %738 = fmul double %731, 0x3F50000000000000
  %739 = fadd double %462, %738
  %740 = load ptr, ptr %137, align 8
  %741 = load ptr, ptr %139, align 8
  %742 = insertelement <8 x double> poison, double %739, i64 0
  %743 = shufflevector <8 x double> %742, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %743, ptr %741, align 8
  %744 = load ptr, ptr %138, align 8
  %745 = load ptr, ptr %140, align 8
  %746 = load i64, ptr %141, align 8
  %747 = load ptr, ptr %142, align 8
  %748 = getelementptr inbounds i8, ptr %747, i64 24
  %749 = load i64, ptr %748, align 8
  %750 = load ptr, ptr %139, align 8
  %751 = load ptr, ptr %143, align 8
  %752 = getelementptr inbounds i8, ptr %751, i64 16
  %753 = load i64, ptr %752, align 8
  tail call fastcc void @nested(ptr noundef %740, ptr noundef %744, ptr noundef %745, i64 noundef %746, i64 noundef %749, ptr noundef %750, i64 noundef %753) #8
  %754 = fmul double %739, %2
  %755 = fadd double %754, %1
  %756 = load ptr, ptr %144, align 8
  store double %755, ptr %756, align 8
  %757 = load i64, ptr %145, align 8
  %758 = icmp sgt i64 %757, 0
  br i1 %758, label %759, label %760

759:                                              ; preds = %737
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %760

760:                                              ; preds = %737, %759
  %761 = load ptr, ptr %9, align 8
  %762 = load i64, ptr %761, align 8
  %763 = load ptr, ptr %146, align 8
  %764 = load ptr, ptr %137, align 8
  %765 = load ptr, ptr %147, align 8
  %766 = load ptr, ptr %148, align 8
  %767 = load ptr, ptr %25, align 8
  %768 = getelementptr inbounds i8, ptr %761, i64 8
  %769 = load i64, ptr %768, align 8
  %770 = mul i64 %769, 56
  %771 = getelementptr inbounds i8, ptr %767, i64 %770
  %772 = inttoptr i64 %762 to ptr
  %773 = load ptr, ptr %772, align 8
  %774 = tail call i32 %773(ptr noundef %763, ptr noundef %764, ptr noundef %765, ptr noundef %766, ptr noundef %771) #9
  %775 = icmp slt i32 %774, 0
  br i1 %775, label %860, label %776

776:                                              ; preds = %760
  %777 = icmp sgt i64 %696, 0
  br i1 %777, label %778, label %865

778:                                              ; preds = %776
  %779 = fmul double %462, %2
  %780 = fadd double %779, %1
  %781 = fsub double %780, %780
  br label %782

782:                                              ; preds = %778, %812
  %783 = phi i64 [ 0, %778 ], [ %813, %812 ]
  %784 = load ptr, ptr %17, align 8
  %785 = getelementptr inbounds i64, ptr %784, i64 %783
  %786 = load i64, ptr %785, align 8
  %787 = icmp eq i64 %786, 0
  br i1 %787, label %812, label %788

788:                                              ; preds = %782
  %789 = getelementptr inbounds double, ptr %698, i64 %783
  %790 = load double, ptr %789, align 8
  %791 = fcmp oeq double %790, 0.000000e+00
  br i1 %791, label %792, label %812

792:                                              ; preds = %788
  %793 = getelementptr inbounds double, ptr %700, i64 %783
  %794 = load double, ptr %793, align 8
  %795 = fcmp oeq double %794, 0.000000e+00
  br i1 %795, label %796, label %812

796:                                              ; preds = %792
  %797 = load i64, ptr %169, align 8
  %798 = icmp eq i64 %797, 0
  br i1 %798, label %812, label %799

799:                                              ; preds = %796
  %800 = load ptr, ptr %170, align 8
  %801 = shl nsw i64 %783, 4
  %802 = getelementptr inbounds i8, ptr %800, i64 %801
  %803 = getelementptr inbounds i8, ptr %802, i64 8
  %804 = load double, ptr %803, align 8
  %805 = fcmp oeq double %804, %780
  br i1 %805, label %811, label %806

806:                                              ; preds = %799
  %807 = load double, ptr %802, align 8
  %808 = fsub double %804, %807
  %809 = fcmp ult double %808, %781
  br i1 %809, label %810, label %812

810:                                              ; preds = %806
  store double %780, ptr %802, align 8
  br label %811

811:                                              ; preds = %799, %810
  store double %780, ptr %803, align 8
  br label %812

812:                                              ; preds = %811, %806, %796, %792, %788, %782
  %813 = add nuw nsw i64 %783, 1
  %814 = icmp eq i64 %813, %696
  br i1 %814, label %865, label %782, !llvm.loop !13

815:                                              ; preds = %472, %857
  %816 = phi i64 [ 0, %472 ], [ %858, %857 ]
  %817 = getelementptr inbounds i64, ptr %18, i64 %816
  %818 = load i64, ptr %817, align 8
  %819 = icmp eq i64 %818, 0
  br i1 %819, label %857, label %820

820:                                              ; preds = %815
  %821 = load ptr, ptr %20, align 8
  %822 = getelementptr inbounds i8, ptr %821, i64 80
  %823 = load i64, ptr %822, align 8
  %824 = load ptr, ptr %6, align 8
  %825 = getelementptr inbounds i8, ptr %824, i64 8
  %826 = load i64, ptr %825, align 8
  %827 = load i64, ptr %160, align 8
  %828 = icmp eq i64 %827, 0
  br i1 %828, label %853, label %829

829:                                              ; preds = %820
  %830 = load ptr, ptr %161, align 8
  %831 = getelementptr inbounds double, ptr %830, i64 %823
  store double %474, ptr %831, align 8
  %832 = load ptr, ptr %162, align 8
  %833 = getelementptr inbounds i64, ptr %832, i64 %823
  store i64 %816, ptr %833, align 8
  %834 = icmp sgt i64 %826, 0
  br i1 %834, label %835, label %837

835:                                              ; preds = %829
  %836 = mul nsw i64 %826, %823
  br label %841

837:                                              ; preds = %841, %829
  %838 = add nsw i64 %823, 1
  %839 = load ptr, ptr %20, align 8
  %840 = getelementptr inbounds i8, ptr %839, i64 80
  store i64 %838, ptr %840, align 8
  br label %853

841:                                              ; preds = %835, %841
  %842 = phi i64 [ 0, %835 ], [ %851, %841 ]
  %843 = load ptr, ptr %137, align 8
  %844 = getelementptr inbounds double, ptr %843, i64 %842
  %845 = load double, ptr %844, align 8
  %846 = load ptr, ptr %163, align 8
  %847 = add nsw i64 %842, %836
  %848 = getelementptr inbounds double, ptr %846, i64 %847
  store double %845, ptr %848, align 8
  %849 = load ptr, ptr %164, align 8
  %850 = getelementptr inbounds double, ptr %849, i64 %847
  store double %845, ptr %850, align 8
  %851 = add nuw nsw i64 %842, 1
  %852 = icmp eq i64 %851, %826
  br i1 %852, label %837, label %841, !llvm.loop !14

853:                                              ; preds = %820, %837
  %854 = getelementptr inbounds i64, ptr %16, i64 %816
  %855 = load i64, ptr %854, align 8
  %856 = sub nsw i64 0, %855
  store i64 %856, ptr %854, align 8
  br label %857

857:                                              ; preds = %815, %853
  %858 = add nuw nsw i64 %816, 1
  %859 = icmp eq i64 %858, %12
  br i1 %859, label %693, label %815, !llvm.loop !15

860:                                              ; preds = %760
  %861 = load ptr, ptr %20, align 8
  %862 = getelementptr inbounds i8, ptr %861, i64 80
  store i64 %23, ptr %862, align 8
  %863 = load ptr, ptr %19, align 8
  %864 = getelementptr inbounds i8, ptr %863, i64 48
  store double 1.000000e+00, ptr %864, align 8
  br label %884

865:                                              ; preds = %812, %776, %730, %709
  %866 = icmp sgt i64 %469, -1
  br i1 %866, label %867, label %876

867:                                              ; preds = %865
  br i1 %173, label %869, label %868

868:                                              ; preds = %869, %867
  store double %462, ptr %174, align 8
  br label %884

869:                                              ; preds = %867, %869
  %870 = phi i64 [ %874, %869 ], [ 0, %867 ]
  %871 = icmp eq i64 %870, %469
  %872 = zext i1 %871 to i64
  %873 = getelementptr inbounds i64, ptr %18, i64 %870
  store i64 %872, ptr %873, align 8
  %874 = add nuw nsw i64 %870, 1
  %875 = icmp eq i64 %874, %12
  br i1 %875, label %868, label %869, !llvm.loop !16

876:                                              ; preds = %865
  %877 = load i64, ptr %171, align 8
  %878 = icmp sgt i64 %877, 0
  br i1 %878, label %879, label %884

879:                                              ; preds = %876
  %880 = load i64, ptr %22, align 8
  %881 = add nsw i64 %880, %12
  %882 = icmp sgt i64 %881, %877
  br i1 %882, label %883, label %884

883:                                              ; preds = %879
  store double %462, ptr %172, align 8
  br label %884

884:                                              ; preds = %685, %649, %603, %582, %860, %868, %883, %688, %879, %876, %278, %459, %357
  %885 = phi i32 [ 1, %357 ], [ %461, %459 ], [ 11, %278 ], [ 1, %860 ], [ 1, %868 ], [ 1, %883 ], [ 1, %688 ], [ 0, %879 ], [ 0, %876 ], [ 1, %582 ], [ 1, %603 ], [ 1, %649 ], [ 1, %685 ]
  %886 = phi double [ %276, %357 ], [ %276, %459 ], [ %276, %278 ], [ %276, %860 ], [ %276, %868 ], [ %276, %883 ], [ %276, %688 ], [ %462, %879 ], [ %462, %876 ], [ %276, %582 ], [ %276, %603 ], [ %276, %649 ], [ %276, %685 ]
  %887 = phi i64 [ -4, %357 ], [ %463, %459 ], [ %277, %278 ], [ -4, %860 ], [ 21, %868 ], [ -3, %883 ], [ -4, %688 ], [ %463, %879 ], [ %463, %876 ], [ -2, %582 ], [ -2, %603 ], [ -2, %649 ], [ -2, %685 ]
  switch i32 %885, label %945 [
    i32 0, label %275
    i32 11, label %888
  ], !llvm.loop !17

888:                                              ; preds = %884
  br i1 %175, label %889, label %945

889:                                              ; preds = %888
  %890 = fcmp oeq double %273, %185
  %891 = add nsw i32 %182, -1
  %892 = sext i32 %891 to i64
  %893 = mul nsw i64 %12, %892
  %894 = getelementptr double, ptr %28, i64 %893
  %895 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %892
  %896 = fmul double %273, %2
  %897 = fadd double %896, %1
  br label %898

898:                                              ; preds = %889, %937
  %899 = phi i64 [ 0, %889 ], [ %938, %937 ]
  %900 = getelementptr inbounds double, ptr %274, i64 %899
  %901 = load double, ptr %900, align 8
  %902 = fcmp ogt double %901, 0.000000e+00
  br i1 %902, label %905, label %903

903:                                              ; preds = %898
  %904 = fcmp olt double %901, 0.000000e+00
  br i1 %904, label %905, label %908

905:                                              ; preds = %903, %898
  %906 = phi i64 [ 1, %898 ], [ -1, %903 ]
  %907 = getelementptr inbounds i64, ptr %16, i64 %899
  store i64 %906, ptr %907, align 8
  br label %908

908:                                              ; preds = %905, %903
  br i1 %890, label %909, label %937

909:                                              ; preds = %908
  %910 = getelementptr double, ptr %894, i64 %899
  %911 = load double, ptr %910, align 8
  %912 = fcmp oeq double %911, 0.000000e+00
  br i1 %912, label %913, label %937

913:                                              ; preds = %909
  %914 = getelementptr double, ptr %236, i64 %899
  %915 = load double, ptr %914, align 8
  %916 = fcmp oeq double %915, 0.000000e+00
  br i1 %916, label %917, label %937

917:                                              ; preds = %913
  %918 = load double, ptr %895, align 8
  %919 = fmul double %918, %2
  %920 = fadd double %919, %1
  %921 = load i64, ptr %176, align 8
  %922 = icmp eq i64 %921, 0
  br i1 %922, label %937, label %923

923:                                              ; preds = %917
  %924 = load ptr, ptr %177, align 8
  %925 = shl nsw i64 %899, 4
  %926 = getelementptr inbounds i8, ptr %924, i64 %925
  %927 = getelementptr inbounds i8, ptr %926, i64 8
  %928 = load double, ptr %927, align 8
  %929 = fcmp oeq double %928, %920
  br i1 %929, label %936, label %930

930:                                              ; preds = %923
  %931 = load double, ptr %926, align 8
  %932 = fsub double %928, %931
  %933 = fsub double %897, %920
  %934 = fcmp ult double %932, %933
  br i1 %934, label %935, label %937

935:                                              ; preds = %930
  store double %920, ptr %926, align 8
  br label %936

936:                                              ; preds = %923, %935
  store double %897, ptr %927, align 8
  br label %937

937:                                              ; preds = %936, %930, %917, %908, %909, %913
  %938 = add nuw nsw i64 %899, 1
  %939 = icmp eq i64 %938, %12
  br i1 %939, label %945, label %898, !llvm.loop !18

940:                                              ; preds = %260, %232
  %941 = load ptr, ptr %20, align 8
  %942 = getelementptr inbounds i8, ptr %941, i64 80
  store i64 %23, ptr %942, align 8
  %943 = load ptr, ptr %19, align 8
  %944 = getelementptr inbounds i8, ptr %943, i64 48
  store double 1.000000e+00, ptr %944, align 8
  br label %945

945:                                              ; preds = %884, %937, %940, %888
  %946 = phi i32 [ 0, %888 ], [ 1, %940 ], [ 0, %937 ], [ %885, %884 ]
  %947 = phi double [ %273, %888 ], [ %181, %940 ], [ %273, %937 ], [ %886, %884 ]
  %948 = phi i64 [ %887, %888 ], [ -4, %940 ], [ %887, %937 ], [ %887, %884 ]
  %949 = icmp eq i32 %946, 0
  br i1 %949, label %950, label %955

950:                                              ; preds = %945
  %951 = fcmp oeq double %947, %185
  %952 = zext i1 %951 to i32
  %953 = add nuw nsw i32 %182, %952
  %954 = icmp ugt i32 %953, 4
  br i1 %954, label %955, label %178, !llvm.loop !19

955:                                              ; preds = %950, %945
  %956 = phi i1 [ %954, %950 ], [ %179, %945 ]
  br i1 %956, label %957, label %975

957:                                              ; preds = %955
  %958 = icmp sgt i64 %12, 0
  br i1 %958, label %959, label %962

959:                                              ; preds = %957
  %960 = shl i64 %12, 5
  %961 = getelementptr i8, ptr %28, i64 %960
  br label %964

962:                                              ; preds = %964, %957
  %963 = load double, ptr %24, align 8
  store double %963, ptr %30, align 8
  br label %971

964:                                              ; preds = %959, %964
  %965 = phi i64 [ 0, %959 ], [ %969, %964 ]
  %966 = getelementptr double, ptr %961, i64 %965
  %967 = load double, ptr %966, align 8
  %968 = getelementptr inbounds double, ptr %28, i64 %965
  store double %967, ptr %968, align 8
  %969 = add nuw nsw i64 %965, 1
  %970 = icmp eq i64 %969, %12
  br i1 %970, label %962, label %964, !llvm.loop !20

971:                                              ; preds = %119, %962, %92
  %972 = phi ptr [ %95, %92 ], [ %24, %962 ], [ %122, %119 ]
  %973 = phi i64 [ -4, %92 ], [ 0, %962 ], [ -4, %119 ]
  %974 = getelementptr inbounds i8, ptr %972, i64 48
  store double 1.000000e+00, ptr %974, align 8
  br label %975

975:                                              ; preds = %971, %955, %100
  %976 = phi i64 [ %948, %955 ], [ %101, %100 ], [ %973, %971 ]
  ret i64 %976
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
  br i1 %26, label %27, label %353

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

53:                                               ; preds = %27, %350
  %54 = phi i64 [ undef, %27 ], [ %349, %350 ]
  %55 = phi i32 [ 0, %27 ], [ %348, %350 ]
  %56 = phi i32 [ 0, %27 ], [ %347, %350 ]
  %57 = phi i64 [ 0, %27 ], [ %351, %350 ]
  %58 = load ptr, ptr %28, align 8
  %59 = getelementptr inbounds i8, ptr %58, i64 %29
  %60 = getelementptr inbounds double, ptr %59, i64 %57
  %61 = getelementptr inbounds i8, ptr %60, i64 %30
  %62 = load ptr, ptr %31, align 8
  %63 = getelementptr inbounds i64, ptr %62, i64 %57
  %64 = load i64, ptr %63, align 8
  %65 = and i64 %64, 1
  %66 = icmp eq i64 %65, 0
  br i1 %66, label %67, label %345

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
  br i1 %96, label %345, label %97

97:                                               ; preds = %94
  %98 = sext i32 %55 to i64
  br label %99

99:                                               ; preds = %97, %137
  %100 = phi i64 [ %98, %97 ], [ %105, %137 ]
  %101 = icmp slt i64 %100, 4
  br i1 %101, label %102, label %153

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
  %150 = load ptr, ptr %149, align 8
  %151 = tail call i32 %150(ptr noundef %140, ptr noundef %141, ptr noundef %142, ptr noundef %143, ptr noundef %148) #9
  %152 = icmp slt i32 %151, 0
  br i1 %152, label %343, label %99, !llvm.loop !22

153:                                              ; preds = %99
  %154 = load double, ptr %60, align 8
  %155 = tail call double @llvm.fabs.f64(double %154)
  store double %154, ptr %5, align 16
  br label %163

156:                                              ; preds = %213
  %157 = trunc nsw i64 %100 to i32
  %158 = fmul double %224, 0x3E50000000000000
  %159 = fcmp ogt double %218, %158
  br i1 %159, label %160, label %339

160:                                              ; preds = %156
  %161 = fmul double %218, 2.000000e+00
  %162 = fmul double %218, 8.000000e+00
  br label %226

163:                                              ; preds = %153, %213
  %164 = phi i64 [ 0, %153 ], [ %173, %213 ]
  %165 = phi double [ 0.000000e+00, %153 ], [ %218, %213 ]
  %166 = phi double [ %155, %153 ], [ %224, %213 ]
  %167 = mul nuw nsw i64 %9, %164
  %168 = getelementptr inbounds double, ptr %61, i64 %167
  %169 = load double, ptr %168, align 8
  %170 = shl nuw nsw i64 %164, 1
  %171 = or disjoint i64 %170, 1
  %172 = getelementptr inbounds [9 x double], ptr %5, i64 0, i64 %171
  store double %169, ptr %172, align 8
  %173 = add nuw nsw i64 %164, 1
  %174 = mul nuw nsw i64 %9, %173
  %175 = getelementptr inbounds double, ptr %60, i64 %174
  %176 = load double, ptr %175, align 8
  %177 = add nuw nsw i64 %170, 2
  %178 = getelementptr inbounds [9 x double], ptr %5, i64 0, i64 %177
  store double %176, ptr %178, align 16
  %179 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %164
  %180 = load double, ptr %179, align 8
  %181 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %173
  %182 = load double, ptr %181, align 8
  %183 = fadd double %180, %182
  %184 = fmul double %183, 5.000000e-01
  br label %185

185:                                              ; preds = %163, %189
  %186 = phi i64 [ 0, %163 ], [ %195, %189 ]
  %187 = phi double [ 0.000000e+00, %163 ], [ %194, %189 ]
  %188 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %186
  br label %197

189:                                              ; preds = %208
  %190 = mul nuw nsw i64 %9, %186
  %191 = getelementptr inbounds double, ptr %60, i64 %190
  %192 = load double, ptr %191, align 8
  %193 = fmul double %210, %192
  %194 = fadd double %187, %193
  %195 = add nuw nsw i64 %186, 1
  %196 = icmp eq i64 %195, 5
  br i1 %196, label %213, label %185, !llvm.loop !23

197:                                              ; preds = %185, %208
  %198 = phi i64 [ 0, %185 ], [ %211, %208 ]
  %199 = phi double [ 1.000000e+00, %185 ], [ %210, %208 ]
  %200 = icmp eq i64 %198, %186
  br i1 %200, label %208, label %201

201:                                              ; preds = %197
  %202 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %198
  %203 = load double, ptr %202, align 8
  %204 = fsub double %184, %203
  %205 = load double, ptr %188, align 8
  %206 = fsub double %205, %203
  %207 = fdiv double %204, %206
  br label %208

208:                                              ; preds = %201, %197
  %209 = phi double [ %207, %201 ], [ 1.000000e+00, %197 ]
  %210 = fmul double %199, %209
  %211 = add nuw nsw i64 %198, 1
  %212 = icmp eq i64 %211, 5
  br i1 %212, label %189, label %197, !llvm.loop !24

213:                                              ; preds = %189
  %214 = fsub double %169, %194
  %215 = tail call double @llvm.fabs.f64(double %214)
  %216 = fmul double %215, 2.000000e+00
  %217 = fcmp ogt double %165, %216
  %218 = select i1 %217, double %165, double %216
  %219 = tail call double @llvm.fabs.f64(double %169)
  %220 = tail call double @llvm.fabs.f64(double %176)
  %221 = fcmp ogt double %219, %220
  %222 = select i1 %221, double %219, double %220
  %223 = fcmp ogt double %166, %222
  %224 = select i1 %223, double %166, double %222
  %225 = icmp eq i64 %173, 4
  br i1 %225, label %156, label %163, !llvm.loop !25

226:                                              ; preds = %160, %247
  %227 = phi i64 [ 1, %160 ], [ %248, %247 ]
  %228 = phi i1 [ false, %160 ], [ %249, %247 ]
  %229 = getelementptr double, ptr %5, i64 %227
  %230 = getelementptr i8, ptr %229, i64 -8
  %231 = load double, ptr %230, align 8
  %232 = load double, ptr %229, align 8
  %233 = fsub double %231, %232
  %234 = tail call double @llvm.fabs.f64(double %233)
  %235 = fmul double %231, %232
  %236 = fcmp olt double %235, 0.000000e+00
  br i1 %236, label %237, label %239

237:                                              ; preds = %226
  %238 = fcmp olt double %234, %162
  br i1 %238, label %251, label %247

239:                                              ; preds = %226
  %240 = tail call double @llvm.fabs.f64(double %232)
  %241 = tail call double @llvm.fabs.f64(double %231)
  %242 = fcmp olt double %241, %240
  %243 = select i1 %242, double %241, double %240
  %244 = fcmp ugt double %243, %218
  %245 = fcmp ugt double %234, %161
  %246 = or i1 %245, %244
  br i1 %246, label %247, label %251

247:                                              ; preds = %239, %237
  %248 = add nuw nsw i64 %227, 1
  %249 = icmp ugt i64 %227, 7
  %250 = icmp eq i64 %248, 9
  br i1 %250, label %339, label %226, !llvm.loop !26

251:                                              ; preds = %237, %239
  br i1 %228, label %339, label %252

252:                                              ; preds = %251, %312
  %253 = phi i32 [ 1, %312 ], [ %56, %251 ]
  %254 = icmp eq i32 %253, 0
  br i1 %254, label %255, label %327

255:                                              ; preds = %252
  %256 = load ptr, ptr %42, align 8
  %257 = load ptr, ptr %43, align 8
  %258 = getelementptr inbounds i8, ptr %257, i64 96
  %259 = load ptr, ptr %258, align 8
  store <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, ptr %259, align 8
  %260 = load ptr, ptr %257, align 8
  %261 = getelementptr inbounds i8, ptr %257, i64 192
  %262 = load ptr, ptr %261, align 8
  %263 = getelementptr inbounds i8, ptr %257, i64 8
  %264 = load i64, ptr %263, align 8
  %265 = load ptr, ptr %1, align 8
  %266 = load ptr, ptr %265, align 8
  %267 = getelementptr inbounds i8, ptr %266, i64 24
  %268 = load i64, ptr %267, align 8
  %269 = load ptr, ptr %258, align 8
  %270 = load ptr, ptr %44, align 8
  %271 = load ptr, ptr %270, align 8
  %272 = getelementptr inbounds i8, ptr %271, i64 16
  %273 = load i64, ptr %272, align 8
  tail call fastcc void @nested(ptr noundef %256, ptr noundef %260, ptr noundef %262, i64 noundef %264, i64 noundef %268, ptr noundef %269, i64 noundef %273) #8
  %274 = load ptr, ptr %41, align 8
  %275 = getelementptr inbounds i8, ptr %274, i64 8
  %276 = load i64, ptr %275, align 8
  %277 = icmp sgt i64 %276, 0
  br i1 %277, label %283, label %278

278:                                              ; preds = %283, %255
  %279 = load ptr, ptr %47, align 8
  store double %19, ptr %279, align 8
  %280 = load i64, ptr %48, align 8
  %281 = icmp sgt i64 %280, 0
  br i1 %281, label %282, label %312

282:                                              ; preds = %278
  tail call fastcc void @sample(ptr noundef nonnull %41) #8
  br label %312

283:                                              ; preds = %255, %283
  %284 = phi i64 [ %307, %283 ], [ 0, %255 ]
  %285 = load ptr, ptr %45, align 8
  %286 = getelementptr inbounds double, ptr %285, i64 %284
  %287 = load double, ptr %286, align 8
  %288 = load ptr, ptr %46, align 8
  %289 = getelementptr inbounds double, ptr %288, i64 %284
  %290 = load double, ptr %289, align 8
  %291 = load ptr, ptr %42, align 8
  %292 = getelementptr inbounds double, ptr %291, i64 %284
  %293 = load double, ptr %292, align 8
  %294 = tail call double @llvm.fabs.f64(double %293)
  %295 = fmul double %290, %294
  %296 = fadd double %287, %295
  %297 = and i64 %284, 1
  %298 = icmp eq i64 %297, 0
  %299 = urem i64 %284, 3
  %300 = uitofp nneg i64 %299 to double
  %301 = fmul double %300, 0x3FE3C6EF372FE950
  %302 = fadd double %301, 1.000000e+00
  %303 = fneg double %302
  %304 = select i1 %298, double %302, double %303
  %305 = fmul double %304, %296
  %306 = fadd double %293, %305
  store double %306, ptr %292, align 8
  %307 = add nuw nsw i64 %284, 1
  %308 = load ptr, ptr %41, align 8
  %309 = getelementptr inbounds i8, ptr %308, i64 8
  %310 = load i64, ptr %309, align 8
  %311 = icmp slt i64 %307, %310
  br i1 %311, label %283, label %278, !llvm.loop !27

312:                                              ; preds = %278, %282
  %313 = load ptr, ptr %6, align 8
  %314 = load i64, ptr %313, align 8
  %315 = load ptr, ptr %49, align 8
  %316 = load ptr, ptr %42, align 8
  %317 = load ptr, ptr %50, align 8
  %318 = load ptr, ptr %51, align 8
  %319 = load ptr, ptr %28, align 8
  %320 = getelementptr inbounds i8, ptr %313, i64 8
  %321 = load i64, ptr %320, align 8
  %322 = getelementptr inbounds double, ptr %319, i64 %321
  %323 = inttoptr i64 %314 to ptr
  %324 = load ptr, ptr %323, align 8
  %325 = tail call i32 %324(ptr noundef %315, ptr noundef %316, ptr noundef %317, ptr noundef %318, ptr noundef %322) #9
  %326 = icmp slt i32 %325, 0
  br i1 %326, label %339, label %252, !llvm.loop !28

327:                                              ; preds = %252
  %328 = load ptr, ptr %28, align 8
  %329 = getelementptr double, ptr %328, i64 %9
  %330 = getelementptr double, ptr %329, i64 %57
  %331 = load double, ptr %330, align 8
  %332 = getelementptr inbounds i8, ptr %60, i64 %52
  %333 = load double, ptr %332, align 8
  %334 = fsub double %331, %333
  %335 = tail call double @llvm.fabs.f64(double %334)
  %336 = fcmp ogt double %218, %335
  %337 = zext i1 %336 to i32
  %338 = select i1 %336, i64 -6, i64 %54
  br label %339

339:                                              ; preds = %247, %312, %327, %156, %251
  %340 = phi i32 [ 4, %251 ], [ 4, %156 ], [ %337, %327 ], [ 1, %312 ], [ 4, %247 ]
  %341 = phi i32 [ %56, %251 ], [ %56, %156 ], [ %253, %327 ], [ %253, %312 ], [ %56, %247 ]
  %342 = phi i64 [ %54, %251 ], [ %54, %156 ], [ %338, %327 ], [ -4, %312 ], [ %54, %247 ]
  br label %345

343:                                              ; preds = %137
  %344 = trunc nsw i64 %100 to i32
  br label %345

345:                                              ; preds = %343, %53, %94, %339
  %346 = phi i32 [ %340, %339 ], [ 4, %94 ], [ 4, %53 ], [ 1, %343 ]
  %347 = phi i32 [ %341, %339 ], [ %56, %94 ], [ %56, %53 ], [ %56, %343 ]
  %348 = phi i32 [ %157, %339 ], [ %55, %94 ], [ %55, %53 ], [ %344, %343 ]
  %349 = phi i64 [ %342, %339 ], [ %54, %94 ], [ %54, %53 ], [ -4, %343 ]
  switch i32 %346, label %353 [
    i32 0, label %350
    i32 4, label %350
  ]

350:                                              ; preds = %345, %345
  %351 = add nuw nsw i64 %57, 1
  %352 = icmp eq i64 %351, %9
  br i1 %352, label %353, label %53, !llvm.loop !29

353:                                              ; preds = %350, %345, %4
  %354 = phi i64 [ 0, %4 ], [ %349, %345 ], [ 0, %350 ]
  ret i64 %354
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
  %75 = load ptr, ptr %74, align 8
  %76 = tail call i32 %75(ptr noundef %64, ptr noundef %65, ptr noundef %67, ptr noundef %69, ptr noundef %73) #9
  %77 = load double, ptr %20, align 8
  %78 = fmul double %77, %13
  %79 = fcmp ugt double %78, 0.000000e+00
  br i1 %79, label %133, label %80

80:                                               ; preds = %60, %114
  %81 = phi double [ %84, %114 ], [ %5, %60 ]
  %82 = fsub double %81, %4
  %83 = fmul double %82, 5.000000e-01
  %84 = fadd double %83, %4
  %85 = fsub double %84, %4
  %86 = fcmp uge double %85, %27
  br i1 %86, label %87, label %131

87:                                               ; preds = %80
  %88 = load ptr, ptr %29, align 8
  %89 = load ptr, ptr %31, align 8
  %90 = getelementptr inbounds i8, ptr %89, i64 96
  %91 = load ptr, ptr %90, align 8
  %92 = insertelement <8 x double> poison, double %84, i64 0
  %93 = shufflevector <8 x double> %92, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %93, ptr %91, align 8
  %94 = load ptr, ptr %89, align 8
  %95 = getelementptr inbounds i8, ptr %89, i64 192
  %96 = load ptr, ptr %95, align 8
  %97 = getelementptr inbounds i8, ptr %89, i64 8
  %98 = load i64, ptr %97, align 8
  %99 = load ptr, ptr %1, align 8
  %100 = load ptr, ptr %99, align 8
  %101 = getelementptr inbounds i8, ptr %100, i64 24
  %102 = load i64, ptr %101, align 8
  %103 = load ptr, ptr %90, align 8
  %104 = load ptr, ptr %47, align 8
  %105 = load ptr, ptr %104, align 8
  %106 = getelementptr inbounds i8, ptr %105, i64 16
  %107 = load i64, ptr %106, align 8
  tail call fastcc void @nested(ptr noundef %88, ptr noundef %94, ptr noundef %96, i64 noundef %98, i64 noundef %102, ptr noundef %103, i64 noundef %107) #8
  %108 = fmul double %84, %3
  %109 = fadd double %108, %2
  %110 = load ptr, ptr %54, align 8
  store double %109, ptr %110, align 8
  %111 = load i64, ptr %56, align 8
  %112 = icmp sgt i64 %111, 0
  br i1 %112, label %113, label %114

113:                                              ; preds = %87
  tail call fastcc void @sample(ptr noundef nonnull %28) #8
  br label %114

114:                                              ; preds = %87, %113
  %115 = load ptr, ptr %8, align 8
  %116 = load i64, ptr %115, align 8
  %117 = load ptr, ptr %63, align 8
  %118 = load ptr, ptr %29, align 8
  %119 = load ptr, ptr %66, align 8
  %120 = load ptr, ptr %68, align 8
  %121 = load ptr, ptr %14, align 8
  %122 = getelementptr inbounds i8, ptr %115, i64 8
  %123 = load i64, ptr %122, align 8
  %124 = getelementptr inbounds double, ptr %121, i64 %123
  %125 = inttoptr i64 %116 to ptr
  %126 = load ptr, ptr %125, align 8
  %127 = tail call i32 %126(ptr noundef %117, ptr noundef %118, ptr noundef %119, ptr noundef %120, ptr noundef %124) #9
  %128 = load double, ptr %20, align 8
  %129 = fmul double %128, %13
  %130 = fcmp ogt double %129, 0.000000e+00
  br i1 %130, label %131, label %80, !llvm.loop !30

131:                                              ; preds = %114, %80
  %132 = phi double [ %4, %80 ], [ %84, %114 ]
  br i1 %86, label %133, label %196

133:                                              ; preds = %131, %60
  %134 = phi double [ %5, %60 ], [ %81, %131 ]
  %135 = phi double [ %4, %60 ], [ %132, %131 ]
  br label %136

136:                                              ; preds = %133, %193
  %137 = phi double [ %194, %193 ], [ %134, %133 ]
  %138 = phi double [ %195, %193 ], [ %135, %133 ]
  %139 = fsub double %137, %138
  %140 = fcmp ogt double %139, %27
  br i1 %140, label %141, label %196

141:                                              ; preds = %136
  %142 = fmul double %139, 5.000000e-01
  %143 = fadd double %138, %142
  %144 = fcmp une double %143, %138
  %145 = fcmp une double %143, %137
  %146 = and i1 %144, %145
  br i1 %146, label %147, label %193

147:                                              ; preds = %141
  %148 = load ptr, ptr %29, align 8
  %149 = load ptr, ptr %31, align 8
  %150 = getelementptr inbounds i8, ptr %149, i64 96
  %151 = load ptr, ptr %150, align 8
  %152 = insertelement <8 x double> poison, double %143, i64 0
  %153 = shufflevector <8 x double> %152, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %153, ptr %151, align 8
  %154 = load ptr, ptr %149, align 8
  %155 = getelementptr inbounds i8, ptr %149, i64 192
  %156 = load ptr, ptr %155, align 8
  %157 = getelementptr inbounds i8, ptr %149, i64 8
  %158 = load i64, ptr %157, align 8
  %159 = load ptr, ptr %1, align 8
  %160 = load ptr, ptr %159, align 8
  %161 = getelementptr inbounds i8, ptr %160, i64 24
  %162 = load i64, ptr %161, align 8
  %163 = load ptr, ptr %150, align 8
  %164 = load ptr, ptr %47, align 8
  %165 = load ptr, ptr %164, align 8
  %166 = getelementptr inbounds i8, ptr %165, i64 16
  %167 = load i64, ptr %166, align 8
  tail call fastcc void @nested(ptr noundef %148, ptr noundef %154, ptr noundef %156, i64 noundef %158, i64 noundef %162, ptr noundef %163, i64 noundef %167) #8
  %168 = fmul double %143, %3
  %169 = fadd double %168, %2
  %170 = load ptr, ptr %54, align 8
  store double %169, ptr %170, align 8
  %171 = load i64, ptr %56, align 8
  %172 = icmp sgt i64 %171, 0
  br i1 %172, label %173, label %174

173:                                              ; preds = %147
  tail call fastcc void @sample(ptr noundef nonnull %28) #8
  br label %174

174:                                              ; preds = %147, %173
  %175 = load ptr, ptr %8, align 8
  %176 = load i64, ptr %175, align 8
  %177 = load ptr, ptr %63, align 8
  %178 = load ptr, ptr %29, align 8
  %179 = load ptr, ptr %66, align 8
  %180 = load ptr, ptr %68, align 8
  %181 = load ptr, ptr %14, align 8
  %182 = getelementptr inbounds i8, ptr %175, i64 8
  %183 = load i64, ptr %182, align 8
  %184 = getelementptr inbounds double, ptr %181, i64 %183
  %185 = inttoptr i64 %176 to ptr
  %186 = load ptr, ptr %185, align 8
  %187 = tail call i32 %186(ptr noundef %177, ptr noundef %178, ptr noundef %179, ptr noundef %180, ptr noundef %184) #9
  %188 = load double, ptr %20, align 8
  %189 = fmul double %188, %13
  %190 = fcmp ogt double %189, 0.000000e+00
  %191 = select i1 %190, double %137, double %143
  %192 = select i1 %190, double %143, double %138
  br label %193

193:                                              ; preds = %141, %174
  %194 = phi double [ %191, %174 ], [ %137, %141 ]
  %195 = phi double [ %192, %174 ], [ %138, %141 ]
  br i1 %146, label %136, label %196

196:                                              ; preds = %136, %193, %131
  %197 = phi double [ %4, %131 ], [ %194, %193 ], [ %137, %136 ]
  ret double %197
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
  br i1 %34, label %35, label %211

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

68:                                               ; preds = %198
  %69 = add nuw nsw i32 %82, 1
  %70 = icmp ugt i32 %82, 18
  %71 = icmp eq i32 %69, 20
  br i1 %71, label %208, label %72, !llvm.loop !35

72:                                               ; preds = %35, %68
  %73 = phi i1 [ false, %35 ], [ %70, %68 ]
  %74 = phi double [ undef, %35 ], [ %207, %68 ]
  %75 = phi double [ %50, %35 ], [ %206, %68 ]
  %76 = phi double [ %46, %35 ], [ %205, %68 ]
  %77 = phi double [ %43, %35 ], [ %204, %68 ]
  %78 = phi double [ 0x7FF0000000000000, %35 ], [ %203, %68 ]
  %79 = phi double [ %24, %35 ], [ %202, %68 ]
  %80 = phi double [ %26, %35 ], [ %201, %68 ]
  %81 = phi double [ %29, %35 ], [ %200, %68 ]
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
  br i1 %97, label %98, label %198

98:                                               ; preds = %72
  %99 = fsub double %96, %76
  %100 = fmul double %94, %99
  %101 = fadd double %80, %100
  %102 = fmul double %78, 2.000000e+00
  %103 = fcmp ugt double %101, %102
  br i1 %103, label %198, label %104

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
  br i1 %117, label %198, label %118

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
  br i1 %137, label %198, label %138

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
  %174 = load ptr, ptr %173, align 8
  %175 = tail call i32 %174(ptr noundef %168, ptr noundef %169, ptr noundef %170, ptr noundef %171, ptr noundef %172) #9
  %176 = icmp slt i32 %175, 0
  br i1 %176, label %198, label %177

177:                                              ; preds = %165
  %178 = load double, ptr %15, align 8
  %179 = fmul double %178, %5
  %180 = fcmp olt double %179, 0.000000e+00
  br i1 %180, label %181, label %184

181:                                              ; preds = %177
  %182 = fcmp olt double %179, %67
  %183 = select i1 %182, double %127, double 2.000000e+00
  br label %198

184:                                              ; preds = %177
  %185 = fsub double %179, %132
  %186 = tail call double @llvm.fabs.f64(double %185)
  %187 = fcmp uge double %127, %76
  %188 = fcmp ugt double %179, %80
  %189 = or i1 %187, %188
  br i1 %189, label %190, label %198

190:                                              ; preds = %184
  br i1 %187, label %191, label %198

191:                                              ; preds = %190
  %192 = select i1 %188, double %179, double %81
  %193 = select i1 %188, double %80, double %179
  %194 = select i1 %188, double %79, double %80
  %195 = select i1 %188, double %127, double %77
  %196 = select i1 %188, double %76, double %127
  %197 = select i1 %188, double %75, double %76
  br label %198

198:                                              ; preds = %114, %181, %191, %190, %184, %165, %126, %72, %98
  %199 = phi i1 [ false, %98 ], [ false, %72 ], [ false, %114 ], [ false, %126 ], [ false, %165 ], [ false, %181 ], [ true, %191 ], [ true, %190 ], [ true, %184 ]
  %200 = phi double [ %81, %98 ], [ %81, %72 ], [ %81, %114 ], [ %81, %126 ], [ %81, %165 ], [ %81, %181 ], [ %192, %191 ], [ %81, %190 ], [ %80, %184 ]
  %201 = phi double [ %80, %98 ], [ %80, %72 ], [ %80, %114 ], [ %80, %126 ], [ %80, %165 ], [ %80, %181 ], [ %193, %191 ], [ %80, %190 ], [ %179, %184 ]
  %202 = phi double [ %79, %98 ], [ %79, %72 ], [ %79, %114 ], [ %79, %126 ], [ %79, %165 ], [ %79, %181 ], [ %194, %191 ], [ %179, %190 ], [ %79, %184 ]
  %203 = phi double [ %78, %98 ], [ %78, %72 ], [ %78, %114 ], [ %78, %126 ], [ %78, %165 ], [ %78, %181 ], [ %186, %191 ], [ %186, %190 ], [ %186, %184 ]
  %204 = phi double [ %77, %98 ], [ %77, %72 ], [ %77, %114 ], [ %77, %126 ], [ %77, %165 ], [ %77, %181 ], [ %195, %191 ], [ %77, %190 ], [ %76, %184 ]
  %205 = phi double [ %76, %98 ], [ %76, %72 ], [ %76, %114 ], [ %76, %126 ], [ %76, %165 ], [ %76, %181 ], [ %196, %191 ], [ %76, %190 ], [ %127, %184 ]
  %206 = phi double [ %75, %98 ], [ %75, %72 ], [ %75, %114 ], [ %75, %126 ], [ %75, %165 ], [ %75, %181 ], [ %197, %191 ], [ %127, %190 ], [ %75, %184 ]
  %207 = phi double [ 2.000000e+00, %98 ], [ 2.000000e+00, %72 ], [ 2.000000e+00, %114 ], [ 2.000000e+00, %126 ], [ -4.000000e+00, %165 ], [ %183, %181 ], [ %74, %191 ], [ %74, %190 ], [ %74, %184 ]
  br i1 %199, label %68, label %208

208:                                              ; preds = %68, %198
  %209 = phi i1 [ %70, %68 ], [ %73, %198 ]
  br i1 %209, label %210, label %211

210:                                              ; preds = %208
  br label %211

211:                                              ; preds = %8, %208, %210
  %212 = phi double [ 2.000000e+00, %210 ], [ %207, %208 ], [ 2.000000e+00, %8 ]
  ret double %212
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
