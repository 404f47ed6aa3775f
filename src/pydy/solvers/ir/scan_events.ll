; sources 8813d0fd2a18f8de47435bb98b91689035cdbe23e34ba1e6a92bb255bdc455a0
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
  %34 = getelementptr inbounds i8, ptr %0, i64 936
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
  br label %750

91:                                               ; preds = %44
  %92 = call fastcc i64 @resolve(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2) #8
  switch i64 %92, label %754 [
    i64 0, label %97
    i64 -4, label %93
  ]

93:                                               ; preds = %91
  %94 = load ptr, ptr %20, align 8
  %95 = getelementptr inbounds i8, ptr %94, i64 80
  store i64 %23, ptr %95, align 8
  %96 = load ptr, ptr %19, align 8
  br label %750

97:                                               ; preds = %91
  store double 0x7FF8000000000000, ptr %30, align 8
  %98 = getelementptr inbounds i8, ptr %0, i64 792
  %99 = getelementptr inbounds i8, ptr %0, i64 936
  %100 = getelementptr inbounds i8, ptr %0, i64 408
  %101 = getelementptr inbounds i8, ptr %0, i64 504
  %102 = getelementptr inbounds i8, ptr %0, i64 320
  %103 = getelementptr inbounds i8, ptr %0, i64 168
  %104 = getelementptr inbounds i8, ptr %0, i64 248
  %105 = getelementptr inbounds i8, ptr %0, i64 168
  %106 = getelementptr inbounds i8, ptr %0, i64 192
  %107 = getelementptr inbounds i8, ptr %0, i64 744
  %108 = getelementptr inbounds i8, ptr %0, i64 936
  %109 = getelementptr inbounds i8, ptr %0, i64 408
  %110 = getelementptr inbounds i8, ptr %0, i64 504
  %111 = getelementptr inbounds i8, ptr %0, i64 320
  %112 = getelementptr inbounds i8, ptr %0, i64 168
  %113 = getelementptr inbounds i8, ptr %0, i64 248
  %114 = getelementptr inbounds i8, ptr %0, i64 168
  %115 = getelementptr inbounds i8, ptr %0, i64 192
  %116 = getelementptr inbounds i8, ptr %0, i64 744
  %117 = icmp sgt i64 %12, 0
  %118 = getelementptr inbounds i8, ptr %0, i64 792
  %119 = getelementptr inbounds i8, ptr %0, i64 936
  %120 = getelementptr inbounds i8, ptr %0, i64 408
  %121 = getelementptr inbounds i8, ptr %0, i64 504
  %122 = getelementptr inbounds i8, ptr %0, i64 320
  %123 = getelementptr inbounds i8, ptr %0, i64 168
  %124 = getelementptr inbounds i8, ptr %0, i64 248
  %125 = getelementptr inbounds i8, ptr %0, i64 168
  %126 = getelementptr inbounds i8, ptr %0, i64 192
  %127 = getelementptr inbounds i8, ptr %0, i64 744
  %128 = icmp slt i64 %12, 1
  %129 = icmp sgt i64 %12, 0
  %130 = getelementptr inbounds i8, ptr %0, i64 792
  %131 = getelementptr inbounds i8, ptr %24, i64 48
  %132 = icmp sgt i64 %12, 0
  %133 = getelementptr inbounds i8, ptr %0, i64 968
  %134 = getelementptr inbounds i8, ptr %0, i64 960
  %135 = getelementptr inbounds i8, ptr %0, i64 984
  %136 = getelementptr inbounds i8, ptr %0, i64 1008
  %137 = getelementptr inbounds i8, ptr %0, i64 1024
  %138 = getelementptr inbounds i8, ptr %0, i64 968
  %139 = getelementptr inbounds i8, ptr %24, i64 48
  %140 = icmp sgt i64 %12, 0
  %141 = getelementptr inbounds i8, ptr %24, i64 48
  %142 = icmp sgt i64 %12, 0
  br label %143

143:                                              ; preds = %97, %729
  %144 = phi i1 [ false, %97 ], [ %733, %729 ]
  %145 = phi i64 [ -4, %97 ], [ %727, %729 ]
  %146 = phi double [ 0.000000e+00, %97 ], [ %726, %729 ]
  %147 = phi i32 [ 1, %97 ], [ %732, %729 ]
  %148 = zext nneg i32 %147 to i64
  %149 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %148
  %150 = load double, ptr %149, align 8
  %151 = load ptr, ptr %9, align 8
  %152 = getelementptr inbounds i8, ptr %151, i64 8
  %153 = load i64, ptr %152, align 8
  %154 = load ptr, ptr %25, align 8
  %155 = add nuw nsw i32 %147, 2
  %156 = zext nneg i32 %155 to i64
  %157 = mul nsw i64 %153, %156
  %158 = getelementptr inbounds double, ptr %154, i64 %157
  %159 = icmp sgt i64 %153, 0
  br i1 %159, label %160, label %287

160:                                              ; preds = %143
  %161 = add nsw i32 %147, -1
  %162 = icmp ugt i32 %147, 1
  %163 = select i1 %162, i32 %161, i32 1
  %164 = icmp sle i32 %163, %147
  %165 = icmp slt i32 %163, 4
  %166 = and i1 %164, %165
  %167 = zext nneg i32 %147 to i64
  %168 = getelementptr inbounds [5 x double], ptr @PLACES, i64 0, i64 %167
  %169 = tail call i32 @llvm.smin.i32(i32 %147, i32 3)
  br label %170

170:                                              ; preds = %160, %284
  %171 = phi double [ 2.000000e+00, %160 ], [ %283, %284 ]
  %172 = phi i64 [ 0, %160 ], [ %285, %284 ]
  %173 = phi double [ 2.000000e+00, %160 ], [ %281, %284 ]
  %174 = load ptr, ptr %15, align 8
  %175 = getelementptr inbounds i64, ptr %174, i64 %172
  %176 = load i64, ptr %175, align 8
  %177 = sitofp i64 %176 to double
  br i1 %166, label %178, label %280

178:                                              ; preds = %170
  %179 = getelementptr inbounds double, ptr %154, i64 %172
  br label %180

180:                                              ; preds = %178, %277
  %181 = phi i32 [ %163, %178 ], [ %278, %277 ]
  %182 = phi double [ %171, %178 ], [ %276, %277 ]
  %183 = phi double [ %173, %178 ], [ %274, %277 ]
  %184 = call fastcc double @least_place(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, i64 noundef %172, double noundef %177, i32 noundef %181, i32 noundef %147) #8
  %185 = fcmp oeq double %184, -4.000000e+00
  br i1 %185, label %273, label %186

186:                                              ; preds = %180
  %187 = fcmp ogt double %184, %146
  br i1 %187, label %188, label %273

188:                                              ; preds = %186
  %189 = load double, ptr %168, align 8
  %190 = fcmp olt double %182, %189
  %191 = select i1 %190, double %182, double %189
  %192 = fcmp olt double %184, %191
  br i1 %192, label %195, label %273

193:                                              ; preds = %230
  %194 = fcmp ugt double %231, 1.000000e+00
  br i1 %194, label %266, label %234

195:                                              ; preds = %188, %230
  %196 = phi i64 [ %232, %230 ], [ 0, %188 ]
  %197 = phi double [ %231, %230 ], [ %183, %188 ]
  %198 = load ptr, ptr %98, align 8
  %199 = getelementptr inbounds i64, ptr %198, i64 %196
  %200 = load i64, ptr %199, align 8
  %201 = icmp eq i64 %200, 1
  br i1 %201, label %202, label %230

202:                                              ; preds = %195
  %203 = load ptr, ptr %15, align 8
  %204 = getelementptr inbounds i64, ptr %203, i64 %196
  %205 = load i64, ptr %204, align 8
  %206 = getelementptr inbounds double, ptr %158, i64 %196
  %207 = load double, ptr %206, align 8
  %208 = load ptr, ptr %13, align 8
  %209 = getelementptr inbounds i64, ptr %208, i64 %196
  %210 = load i64, ptr %209, align 8
  %211 = icmp slt i64 %205, 0
  %212 = fcmp ogt double %207, 0.000000e+00
  %213 = and i1 %211, %212
  %214 = icmp sgt i64 %210, -1
  %215 = and i1 %213, %214
  br i1 %215, label %223, label %216

216:                                              ; preds = %202
  %217 = icmp sgt i64 %205, 0
  %218 = fcmp olt double %207, 0.000000e+00
  %219 = and i1 %217, %218
  br i1 %219, label %220, label %223

220:                                              ; preds = %216
  %221 = icmp slt i64 %210, 1
  %222 = zext i1 %221 to i32
  br label %223

223:                                              ; preds = %202, %216, %220
  %224 = phi i32 [ 1, %202 ], [ 0, %216 ], [ %222, %220 ]
  %225 = icmp eq i32 %224, 0
  br i1 %225, label %230, label %226

226:                                              ; preds = %223
  %227 = call fastcc double @locate(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %146, double noundef %189, i64 noundef %196) #8
  %228 = fcmp olt double %197, %227
  %229 = select i1 %228, double %197, double %227
  br label %230

230:                                              ; preds = %226, %223, %195
  %231 = phi double [ %229, %226 ], [ %197, %223 ], [ %197, %195 ]
  %232 = add nuw nsw i64 %196, 1
  %233 = icmp eq i64 %232, %153
  br i1 %233, label %193, label %195, !llvm.loop !6

234:                                              ; preds = %193
  %235 = load ptr, ptr %99, align 8
  %236 = load ptr, ptr %100, align 8
  %237 = insertelement <8 x double> poison, double %231, i64 0
  %238 = shufflevector <8 x double> %237, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %238, ptr %236, align 8
  %239 = load ptr, ptr %8, align 8
  %240 = load ptr, ptr %101, align 8
  %241 = load i64, ptr %102, align 8
  %242 = load ptr, ptr %0, align 8
  %243 = getelementptr inbounds i8, ptr %242, i64 24
  %244 = load i64, ptr %243, align 8
  %245 = load ptr, ptr %100, align 8
  %246 = load ptr, ptr %6, align 8
  %247 = getelementptr inbounds i8, ptr %246, i64 16
  %248 = load i64, ptr %247, align 8
  tail call fastcc void @nested(ptr noundef %235, ptr noundef %239, ptr noundef %240, i64 noundef %241, i64 noundef %244, ptr noundef %245, i64 noundef %248) #8
  %249 = fmul double %231, %2
  %250 = fadd double %249, %1
  %251 = load ptr, ptr %103, align 8
  store double %250, ptr %251, align 8
  %252 = load i64, ptr %104, align 8
  %253 = icmp sgt i64 %252, 0
  br i1 %253, label %254, label %255

254:                                              ; preds = %234
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %255

255:                                              ; preds = %234, %254
  %256 = load ptr, ptr %9, align 8
  %257 = load i64, ptr %256, align 8
  %258 = load ptr, ptr %105, align 8
  %259 = load ptr, ptr %99, align 8
  %260 = load ptr, ptr %106, align 8
  %261 = load ptr, ptr %107, align 8
  %262 = load ptr, ptr %25, align 8
  %263 = inttoptr i64 %257 to ptr
  %264 = tail call i32 %263(ptr noundef %258, ptr noundef %259, ptr noundef %260, ptr noundef %261, ptr noundef %262) #9
  %265 = icmp slt i32 %264, 0
  br i1 %265, label %273, label %266

266:                                              ; preds = %255, %193
  %267 = fcmp ogt double %231, 1.000000e+00
  br i1 %267, label %272, label %268

268:                                              ; preds = %266
  %269 = load double, ptr %179, align 8
  %270 = fmul double %269, %177
  %271 = fcmp ogt double %270, 0.000000e+00
  br i1 %271, label %272, label %273

272:                                              ; preds = %268, %266
  br label %273

273:                                              ; preds = %272, %268, %255, %188, %186, %180
  %274 = phi double [ %183, %180 ], [ %183, %188 ], [ %183, %186 ], [ %231, %255 ], [ %231, %272 ], [ %231, %268 ]
  %275 = phi i32 [ 1, %180 ], [ 7, %188 ], [ 7, %186 ], [ 1, %255 ], [ 0, %272 ], [ 0, %268 ]
  %276 = phi double [ %182, %180 ], [ %182, %188 ], [ %182, %186 ], [ %182, %255 ], [ %184, %272 ], [ %182, %268 ]
  switch i32 %275, label %280 [
    i32 0, label %277
    i32 7, label %277
  ]

277:                                              ; preds = %273, %273
  %278 = add nsw i32 %181, 1
  %279 = icmp slt i32 %181, %169
  br i1 %279, label %180, label %280, !llvm.loop !7

280:                                              ; preds = %277, %273, %170
  %281 = phi double [ %173, %170 ], [ %274, %273 ], [ %274, %277 ]
  %282 = phi i32 [ 5, %170 ], [ 5, %277 ], [ %275, %273 ]
  %283 = phi double [ %171, %170 ], [ %276, %273 ], [ %276, %277 ]
  switch i32 %282, label %287 [
    i32 5, label %284
    i32 0, label %284
  ]

284:                                              ; preds = %280, %280
  %285 = add nuw nsw i64 %172, 1
  %286 = icmp eq i64 %285, %153
  br i1 %286, label %287, label %170, !llvm.loop !8

287:                                              ; preds = %280, %284, %143
  %288 = phi double [ 2.000000e+00, %143 ], [ -4.000000e+00, %280 ], [ %283, %284 ]
  %289 = fcmp olt double %288, 0.000000e+00
  br i1 %289, label %719, label %290

290:                                              ; preds = %287
  %291 = mul nsw i64 %12, %148
  %292 = getelementptr inbounds double, ptr %28, i64 %291
  %293 = fcmp olt double %288, %150
  br i1 %293, label %294, label %327

294:                                              ; preds = %290
  %295 = load ptr, ptr %25, align 8
  %296 = load ptr, ptr %108, align 8
  %297 = load ptr, ptr %109, align 8
  %298 = insertelement <8 x double> poison, double %288, i64 0
  %299 = shufflevector <8 x double> %298, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %299, ptr %297, align 8
  %300 = load ptr, ptr %8, align 8
  %301 = load ptr, ptr %110, align 8
  %302 = load i64, ptr %111, align 8
  %303 = load ptr, ptr %0, align 8
  %304 = getelementptr inbounds i8, ptr %303, i64 24
  %305 = load i64, ptr %304, align 8
  %306 = load ptr, ptr %109, align 8
  %307 = load ptr, ptr %6, align 8
  %308 = getelementptr inbounds i8, ptr %307, i64 16
  %309 = load i64, ptr %308, align 8
  tail call fastcc void @nested(ptr noundef %296, ptr noundef %300, ptr noundef %301, i64 noundef %302, i64 noundef %305, ptr noundef %306, i64 noundef %309) #8
  %310 = fmul double %288, %2
  %311 = fadd double %310, %1
  %312 = load ptr, ptr %112, align 8
  store double %311, ptr %312, align 8
  %313 = load i64, ptr %113, align 8
  %314 = icmp sgt i64 %313, 0
  br i1 %314, label %315, label %316

315:                                              ; preds = %294
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %316

316:                                              ; preds = %294, %315
  %317 = load ptr, ptr %9, align 8
  %318 = load i64, ptr %317, align 8
  %319 = load ptr, ptr %114, align 8
  %320 = load ptr, ptr %108, align 8
  %321 = load ptr, ptr %115, align 8
  %322 = load ptr, ptr %116, align 8
  %323 = load ptr, ptr %25, align 8
  %324 = inttoptr i64 %318 to ptr
  %325 = tail call i32 %324(ptr noundef %319, ptr noundef %320, ptr noundef %321, ptr noundef %322, ptr noundef %323) #9
  %326 = icmp slt i32 %325, 0
  br i1 %326, label %719, label %327

327:                                              ; preds = %316, %290
  %328 = phi double [ %288, %316 ], [ %150, %290 ]
  %329 = phi ptr [ %295, %316 ], [ %292, %290 ]
  br label %330

330:                                              ; preds = %701, %327
  %331 = phi double [ %146, %327 ], [ %703, %701 ]
  %332 = phi i64 [ %145, %327 ], [ %704, %701 ]
  br i1 %117, label %337, label %333

333:                                              ; preds = %387, %330
  %334 = phi double [ 2.000000e+00, %330 ], [ %388, %387 ]
  %335 = phi i32 [ 0, %330 ], [ %389, %387 ]
  %336 = fcmp ogt double %334, 1.000000e+00
  br i1 %336, label %701, label %392

337:                                              ; preds = %330, %387
  %338 = phi i64 [ %390, %387 ], [ 0, %330 ]
  %339 = phi i32 [ %389, %387 ], [ 0, %330 ]
  %340 = phi double [ %388, %387 ], [ 2.000000e+00, %330 ]
  %341 = getelementptr inbounds i64, ptr %18, i64 %338
  store i64 0, ptr %341, align 8
  %342 = getelementptr inbounds i64, ptr %16, i64 %338
  %343 = load i64, ptr %342, align 8
  %344 = getelementptr inbounds double, ptr %329, i64 %338
  %345 = load double, ptr %344, align 8
  %346 = getelementptr inbounds i64, ptr %14, i64 %338
  %347 = load i64, ptr %346, align 8
  %348 = icmp slt i64 %343, 0
  %349 = fcmp ogt double %345, 0.000000e+00
  %350 = and i1 %348, %349
  %351 = icmp sgt i64 %347, -1
  %352 = and i1 %350, %351
  br i1 %352, label %360, label %353

353:                                              ; preds = %337
  %354 = icmp sgt i64 %343, 0
  %355 = fcmp olt double %345, 0.000000e+00
  %356 = and i1 %354, %355
  br i1 %356, label %357, label %360

357:                                              ; preds = %353
  %358 = icmp slt i64 %347, 1
  %359 = zext i1 %358 to i32
  br label %360

360:                                              ; preds = %337, %353, %357
  %361 = phi i32 [ 1, %337 ], [ 0, %353 ], [ %359, %357 ]
  %362 = icmp eq i32 %361, 0
  br i1 %362, label %363, label %367

363:                                              ; preds = %360
  %364 = icmp eq i64 %343, 0
  %365 = fcmp ord double %345, 0.000000e+00
  %366 = or i1 %364, %365
  br i1 %366, label %387, label %367

367:                                              ; preds = %363, %360
  %368 = call fastcc double @locate(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %331, double noundef %328, i64 noundef %338) #8
  %369 = fcmp ole double %368, %331
  %370 = zext i1 %369 to i64
  store i64 %370, ptr %341, align 8
  %371 = fcmp uge double %368, %340
  %372 = select i1 %371, i32 %339, i32 0
  %373 = fcmp ugt double %368, %340
  br i1 %373, label %384, label %374

374:                                              ; preds = %367
  %375 = icmp eq i32 %372, 0
  br i1 %375, label %376, label %381

376:                                              ; preds = %374
  %377 = load ptr, ptr %118, align 8
  %378 = getelementptr inbounds i64, ptr %377, i64 %338
  %379 = load i64, ptr %378, align 8
  %380 = icmp eq i64 %379, 1
  br label %381

381:                                              ; preds = %376, %374
  %382 = phi i1 [ true, %374 ], [ %380, %376 ]
  %383 = zext i1 %382 to i32
  br label %384

384:                                              ; preds = %381, %367
  %385 = phi i32 [ %383, %381 ], [ %372, %367 ]
  %386 = select i1 %371, double %340, double %368
  br label %387

387:                                              ; preds = %363, %384
  %388 = phi double [ %386, %384 ], [ %340, %363 ]
  %389 = phi i32 [ %385, %384 ], [ %339, %363 ]
  %390 = add nuw nsw i64 %338, 1
  %391 = icmp eq i64 %390, %12
  br i1 %391, label %333, label %337, !llvm.loop !9

392:                                              ; preds = %333
  %393 = load ptr, ptr %119, align 8
  %394 = load ptr, ptr %120, align 8
  %395 = insertelement <8 x double> poison, double %334, i64 0
  %396 = shufflevector <8 x double> %395, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %396, ptr %394, align 8
  %397 = load ptr, ptr %8, align 8
  %398 = load ptr, ptr %121, align 8
  %399 = load i64, ptr %122, align 8
  %400 = load ptr, ptr %0, align 8
  %401 = getelementptr inbounds i8, ptr %400, i64 24
  %402 = load i64, ptr %401, align 8
  %403 = load ptr, ptr %120, align 8
  %404 = load ptr, ptr %6, align 8
  %405 = getelementptr inbounds i8, ptr %404, i64 16
  %406 = load i64, ptr %405, align 8
  tail call fastcc void @nested(ptr noundef %393, ptr noundef %397, ptr noundef %398, i64 noundef %399, i64 noundef %402, ptr noundef %403, i64 noundef %406) #8
  %407 = fmul double %334, %2
  %408 = fadd double %407, %1
  %409 = load ptr, ptr %123, align 8
  store double %408, ptr %409, align 8
  %410 = load i64, ptr %124, align 8
  %411 = icmp sgt i64 %410, 0
  br i1 %411, label %412, label %413

412:                                              ; preds = %392
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %413

413:                                              ; preds = %392, %412
  %414 = load ptr, ptr %9, align 8
  %415 = load i64, ptr %414, align 8
  %416 = load ptr, ptr %125, align 8
  %417 = load ptr, ptr %119, align 8
  %418 = load ptr, ptr %126, align 8
  %419 = load ptr, ptr %127, align 8
  %420 = load ptr, ptr %25, align 8
  %421 = getelementptr inbounds i8, ptr %414, i64 8
  %422 = load i64, ptr %421, align 8
  %423 = getelementptr inbounds double, ptr %420, i64 %422
  %424 = inttoptr i64 %415 to ptr
  %425 = tail call i32 %424(ptr noundef %416, ptr noundef %417, ptr noundef %418, ptr noundef %419, ptr noundef %423) #9
  %426 = icmp slt i32 %425, 0
  br i1 %426, label %430, label %427

427:                                              ; preds = %413
  %428 = icmp ne i32 %335, 0
  %429 = select i1 %128, i1 true, i1 %428
  br i1 %429, label %531, label %435

430:                                              ; preds = %413
  %431 = load ptr, ptr %20, align 8
  %432 = getelementptr inbounds i8, ptr %431, i64 80
  store i64 %23, ptr %432, align 8
  %433 = load ptr, ptr %19, align 8
  %434 = getelementptr inbounds i8, ptr %433, i64 48
  store double 1.000000e+00, ptr %434, align 8
  br label %701

435:                                              ; preds = %427, %525
  %436 = phi i1 [ %530, %525 ], [ %429, %427 ]
  %437 = phi i64 [ %527, %525 ], [ %332, %427 ]
  %438 = phi i64 [ %528, %525 ], [ 0, %427 ]
  %439 = phi double [ %526, %525 ], [ %334, %427 ]
  %440 = getelementptr inbounds i64, ptr %16, i64 %438
  %441 = load i64, ptr %440, align 8
  %442 = getelementptr inbounds double, ptr %31, i64 %438
  %443 = load double, ptr %442, align 8
  %444 = getelementptr inbounds i64, ptr %14, i64 %438
  %445 = load i64, ptr %444, align 8
  %446 = icmp slt i64 %441, 0
  %447 = fcmp ogt double %443, 0.000000e+00
  %448 = and i1 %446, %447
  %449 = icmp sgt i64 %445, -1
  %450 = and i1 %448, %449
  br i1 %450, label %458, label %451

451:                                              ; preds = %435
  %452 = icmp sgt i64 %441, 0
  %453 = fcmp olt double %443, 0.000000e+00
  %454 = and i1 %452, %453
  br i1 %454, label %455, label %458

455:                                              ; preds = %451
  %456 = icmp slt i64 %445, 1
  %457 = zext i1 %456 to i32
  br label %458

458:                                              ; preds = %435, %451, %455
  %459 = phi i32 [ 1, %435 ], [ 0, %451 ], [ %457, %455 ]
  %460 = icmp eq i32 %459, 0
  br i1 %460, label %525, label %461

461:                                              ; preds = %458
  %462 = getelementptr inbounds double, ptr %329, i64 %438
  %463 = load double, ptr %462, align 8
  %464 = fcmp ogt double %463, 0.000000e+00
  %465 = and i1 %446, %464
  %466 = and i1 %449, %465
  br i1 %466, label %474, label %467

467:                                              ; preds = %461
  %468 = icmp sgt i64 %441, 0
  %469 = fcmp olt double %463, 0.000000e+00
  %470 = and i1 %468, %469
  br i1 %470, label %471, label %474

471:                                              ; preds = %467
  %472 = icmp slt i64 %445, 1
  %473 = zext i1 %472 to i32
  br label %474

474:                                              ; preds = %461, %467, %471
  %475 = phi i32 [ 1, %461 ], [ 0, %467 ], [ %473, %471 ]
  %476 = icmp eq i32 %475, 0
  br i1 %476, label %477, label %525

477:                                              ; preds = %474
  %478 = call fastcc double @locate(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %331, double noundef %439, i64 noundef %438) #8
  %479 = fcmp ogt double %478, %331
  br i1 %479, label %480, label %482

480:                                              ; preds = %477
  %481 = getelementptr inbounds i64, ptr %18, i64 %438
  store i64 2, ptr %481, align 8
  br label %482

482:                                              ; preds = %480, %477
  %483 = phi double [ %478, %480 ], [ %439, %477 ]
  %484 = load ptr, ptr %119, align 8
  %485 = load ptr, ptr %120, align 8
  %486 = insertelement <8 x double> poison, double %483, i64 0
  %487 = shufflevector <8 x double> %486, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %487, ptr %485, align 8
  %488 = load ptr, ptr %8, align 8
  %489 = load ptr, ptr %121, align 8
  %490 = load i64, ptr %122, align 8
  %491 = load ptr, ptr %0, align 8
  %492 = getelementptr inbounds i8, ptr %491, i64 24
  %493 = load i64, ptr %492, align 8
  %494 = load ptr, ptr %120, align 8
  %495 = load ptr, ptr %6, align 8
  %496 = getelementptr inbounds i8, ptr %495, i64 16
  %497 = load i64, ptr %496, align 8
  tail call fastcc void @nested(ptr noundef %484, ptr noundef %488, ptr noundef %489, i64 noundef %490, i64 noundef %493, ptr noundef %494, i64 noundef %497) #8
  %498 = fmul double %483, %2
  %499 = fadd double %498, %1
  %500 = load ptr, ptr %123, align 8
  store double %499, ptr %500, align 8
  %501 = load i64, ptr %124, align 8
  %502 = icmp sgt i64 %501, 0
  br i1 %502, label %503, label %504

503:                                              ; preds = %482
  tail call fastcc void @sample(ptr noundef nonnull %6) #8
  br label %504

504:                                              ; preds = %482, %503
  %505 = load ptr, ptr %9, align 8
  %506 = load i64, ptr %505, align 8
  %507 = load ptr, ptr %125, align 8
  %508 = load ptr, ptr %119, align 8
  %509 = load ptr, ptr %126, align 8
  %510 = load ptr, ptr %127, align 8
  %511 = load ptr, ptr %25, align 8
  %512 = getelementptr inbounds i8, ptr %505, i64 8
  %513 = load i64, ptr %512, align 8
  %514 = getelementptr inbounds double, ptr %511, i64 %513
  %515 = inttoptr i64 %506 to ptr
  %516 = tail call i32 %515(ptr noundef %507, ptr noundef %508, ptr noundef %509, ptr noundef %510, ptr noundef %514) #9
  %517 = icmp sgt i32 %516, -1
  br i1 %517, label %523, label %518

518:                                              ; preds = %504
  %519 = load ptr, ptr %20, align 8
  %520 = getelementptr inbounds i8, ptr %519, i64 80
  store i64 %23, ptr %520, align 8
  %521 = load ptr, ptr %19, align 8
  %522 = getelementptr inbounds i8, ptr %521, i64 48
  store double 1.000000e+00, ptr %522, align 8
  br label %523

523:                                              ; preds = %504, %518
  %524 = phi i64 [ -4, %518 ], [ %437, %504 ]
  br i1 %517, label %525, label %531

525:                                              ; preds = %458, %474, %523
  %526 = phi double [ %439, %474 ], [ %483, %523 ], [ %439, %458 ]
  %527 = phi i64 [ %437, %474 ], [ %524, %523 ], [ %437, %458 ]
  %528 = add nuw nsw i64 %438, 1
  %529 = icmp sge i64 %528, %12
  %530 = select i1 %529, i1 true, i1 %428
  br i1 %530, label %531, label %435, !llvm.loop !10

531:                                              ; preds = %523, %525, %427
  %532 = phi i1 [ %429, %427 ], [ %436, %523 ], [ %530, %525 ]
  %533 = phi i32 [ 13, %427 ], [ 1, %523 ], [ 13, %525 ]
  %534 = phi double [ %334, %427 ], [ %483, %523 ], [ %526, %525 ]
  %535 = phi i64 [ %332, %427 ], [ %524, %523 ], [ %527, %525 ]
  br i1 %532, label %536, label %701

536:                                              ; preds = %531
  br i1 %129, label %547, label %539

537:                                              ; preds = %634
  %538 = zext i1 %635 to i32
  br label %539

539:                                              ; preds = %537, %536
  %540 = phi i32 [ 0, %536 ], [ %538, %537 ]
  %541 = phi i64 [ -1, %536 ], [ %624, %537 ]
  %542 = icmp eq i32 %540, 0
  br i1 %542, label %543, label %638

543:                                              ; preds = %539
  br i1 %132, label %544, label %639

544:                                              ; preds = %543
  %545 = fmul double %534, %2
  %546 = fadd double %545, %1
  br label %642

547:                                              ; preds = %536, %634
  %548 = phi i64 [ %636, %634 ], [ 0, %536 ]
  %549 = phi i64 [ %624, %634 ], [ -1, %536 ]
  %550 = phi i1 [ %635, %634 ], [ false, %536 ]
  %551 = getelementptr inbounds double, ptr %31, i64 %548
  %552 = load double, ptr %551, align 8
  %553 = getelementptr inbounds i64, ptr %16, i64 %548
  %554 = load i64, ptr %553, align 8
  %555 = getelementptr inbounds i64, ptr %14, i64 %548
  %556 = load i64, ptr %555, align 8
  %557 = icmp slt i64 %554, 0
  %558 = fcmp ogt double %552, 0.000000e+00
  %559 = and i1 %558, %557
  %560 = icmp sgt i64 %556, -1
  %561 = and i1 %559, %560
  br i1 %561, label %569, label %562

562:                                              ; preds = %547
  %563 = icmp sgt i64 %554, 0
  %564 = fcmp olt double %552, 0.000000e+00
  %565 = and i1 %564, %563
  br i1 %565, label %566, label %569

566:                                              ; preds = %562
  %567 = icmp slt i64 %556, 1
  %568 = zext i1 %567 to i32
  br label %569

569:                                              ; preds = %547, %562, %566
  %570 = phi i32 [ 1, %547 ], [ 0, %562 ], [ %568, %566 ]
  %571 = icmp eq i32 %570, 0
  br i1 %571, label %572, label %597

572:                                              ; preds = %569
  %573 = getelementptr inbounds double, ptr %329, i64 %548
  %574 = load double, ptr %573, align 8
  %575 = fcmp ogt double %574, 0.000000e+00
  %576 = and i1 %557, %575
  %577 = and i1 %560, %576
  br i1 %577, label %585, label %578

578:                                              ; preds = %572
  %579 = icmp sgt i64 %554, 0
  %580 = fcmp olt double %574, 0.000000e+00
  %581 = and i1 %579, %580
  br i1 %581, label %582, label %585

582:                                              ; preds = %578
  %583 = icmp slt i64 %556, 1
  %584 = zext i1 %583 to i32
  br label %585

585:                                              ; preds = %572, %578, %582
  %586 = phi i32 [ 1, %572 ], [ 0, %578 ], [ %584, %582 ]
  %587 = icmp eq i32 %586, 0
  br i1 %587, label %597, label %588

588:                                              ; preds = %585
  %589 = fcmp oeq double %552, 0.000000e+00
  br i1 %589, label %594, label %590

590:                                              ; preds = %588
  %591 = getelementptr inbounds i64, ptr %18, i64 %548
  %592 = load i64, ptr %591, align 8
  %593 = icmp eq i64 %592, 1
  br label %594

594:                                              ; preds = %590, %588
  %595 = phi i1 [ true, %588 ], [ %593, %590 ]
  %596 = zext i1 %595 to i32
  br label %597

597:                                              ; preds = %594, %585, %569
  %598 = phi i32 [ 1, %569 ], [ %596, %594 ], [ 0, %585 ]
  %599 = icmp eq i32 %598, 0
  br i1 %599, label %600, label %606

600:                                              ; preds = %597
  %601 = getelementptr inbounds i64, ptr %18, i64 %548
  %602 = load i64, ptr %601, align 8
  %603 = icmp eq i64 %602, 2
  %604 = fcmp oeq double %552, 0.000000e+00
  %605 = and i1 %604, %603
  br label %606

606:                                              ; preds = %600, %597
  %607 = phi i1 [ true, %597 ], [ %605, %600 ]
  br i1 %607, label %623, label %608

608:                                              ; preds = %606
  %609 = getelementptr inbounds double, ptr %329, i64 %548
  %610 = load double, ptr %609, align 8
  %611 = icmp eq i64 %554, 0
  %612 = fcmp ord double %610, 0.000000e+00
  %613 = or i1 %611, %612
  br i1 %613, label %623, label %614

614:                                              ; preds = %608
  %615 = sitofp i64 %554 to double
  %616 = fmul double %552, %615
  %617 = fcmp olt double %616, 0.000000e+00
  br i1 %617, label %618, label %620

618:                                              ; preds = %614
  %619 = sub nsw i64 0, %554
  store i64 %619, ptr %553, align 8
  br label %623

620:                                              ; preds = %614
  %621 = fcmp ueq double %552, 0.000000e+00
  %622 = select i1 %621, i64 %548, i64 %549
  br label %623

623:                                              ; preds = %620, %618, %608, %606
  %624 = phi i64 [ %549, %606 ], [ %549, %618 ], [ %549, %608 ], [ %622, %620 ]
  %625 = zext i1 %607 to i64
  %626 = getelementptr inbounds i64, ptr %18, i64 %548
  store i64 %625, ptr %626, align 8
  %627 = xor i1 %607, true
  %628 = or i1 %550, %627
  br i1 %628, label %634, label %629

629:                                              ; preds = %623
  %630 = load ptr, ptr %130, align 8
  %631 = getelementptr inbounds i64, ptr %630, i64 %548
  %632 = load i64, ptr %631, align 8
  %633 = icmp eq i64 %632, 1
  br label %634

634:                                              ; preds = %623, %629
  %635 = phi i1 [ %550, %623 ], [ %633, %629 ]
  %636 = add nuw nsw i64 %548, 1
  %637 = icmp eq i64 %636, %12
  br i1 %637, label %537, label %547, !llvm.loop !11

638:                                              ; preds = %539
  store double %534, ptr %131, align 8
  br label %701

639:                                              ; preds = %682, %543
  %640 = icmp sgt i64 %541, -1
  br i1 %640, label %641, label %693

641:                                              ; preds = %639
  br i1 %140, label %686, label %685

642:                                              ; preds = %544, %682
  %643 = phi i64 [ 0, %544 ], [ %683, %682 ]
  %644 = getelementptr inbounds i64, ptr %18, i64 %643
  %645 = load i64, ptr %644, align 8
  %646 = icmp eq i64 %645, 0
  br i1 %646, label %682, label %647

647:                                              ; preds = %642
  %648 = load ptr, ptr %20, align 8
  %649 = getelementptr inbounds i8, ptr %648, i64 80
  %650 = load i64, ptr %649, align 8
  %651 = load ptr, ptr %6, align 8
  %652 = getelementptr inbounds i8, ptr %651, i64 8
  %653 = load i64, ptr %652, align 8
  %654 = load i64, ptr %133, align 8
  %655 = icmp eq i64 %654, 0
  br i1 %655, label %678, label %656

656:                                              ; preds = %647
  %657 = load ptr, ptr %134, align 8
  %658 = getelementptr inbounds double, ptr %657, i64 %650
  store double %546, ptr %658, align 8
  %659 = load ptr, ptr %135, align 8
  %660 = getelementptr inbounds i64, ptr %659, i64 %650
  store i64 %643, ptr %660, align 8
  %661 = icmp sgt i64 %653, 0
  br i1 %661, label %666, label %662

662:                                              ; preds = %666, %656
  %663 = add nsw i64 %650, 1
  %664 = load ptr, ptr %20, align 8
  %665 = getelementptr inbounds i8, ptr %664, i64 80
  store i64 %663, ptr %665, align 8
  br label %678

666:                                              ; preds = %656, %666
  %667 = phi i64 [ %676, %666 ], [ 0, %656 ]
  %668 = load ptr, ptr %119, align 8
  %669 = getelementptr inbounds double, ptr %668, i64 %667
  %670 = load double, ptr %669, align 8
  %671 = load ptr, ptr %136, align 8
  %672 = load i64, ptr %137, align 8
  %673 = mul nsw i64 %672, %650
  %674 = getelementptr double, ptr %671, i64 %673
  %675 = getelementptr double, ptr %674, i64 %667
  store double %670, ptr %675, align 8
  %676 = add nuw nsw i64 %667, 1
  %677 = icmp eq i64 %676, %653
  br i1 %677, label %662, label %666, !llvm.loop !12

678:                                              ; preds = %647, %662
  %679 = getelementptr inbounds i64, ptr %16, i64 %643
  %680 = load i64, ptr %679, align 8
  %681 = sub nsw i64 0, %680
  store i64 %681, ptr %679, align 8
  br label %682

682:                                              ; preds = %642, %678
  %683 = add nuw nsw i64 %643, 1
  %684 = icmp eq i64 %683, %12
  br i1 %684, label %639, label %642, !llvm.loop !13

685:                                              ; preds = %686, %641
  store double %534, ptr %141, align 8
  br label %701

686:                                              ; preds = %641, %686
  %687 = phi i64 [ %691, %686 ], [ 0, %641 ]
  %688 = icmp eq i64 %687, %541
  %689 = zext i1 %688 to i64
  %690 = getelementptr inbounds i64, ptr %18, i64 %687
  store i64 %689, ptr %690, align 8
  %691 = add nuw nsw i64 %687, 1
  %692 = icmp eq i64 %691, %12
  br i1 %692, label %685, label %686, !llvm.loop !14

693:                                              ; preds = %639
  %694 = load i64, ptr %138, align 8
  %695 = icmp sgt i64 %694, 0
  br i1 %695, label %696, label %701

696:                                              ; preds = %693
  %697 = load i64, ptr %22, align 8
  %698 = add nsw i64 %697, %12
  %699 = icmp sgt i64 %698, %694
  br i1 %699, label %700, label %701

700:                                              ; preds = %696
  store double %534, ptr %139, align 8
  br label %701

701:                                              ; preds = %638, %685, %700, %696, %693, %333, %531, %430
  %702 = phi i32 [ 1, %430 ], [ %533, %531 ], [ 8, %333 ], [ 1, %638 ], [ 1, %685 ], [ 1, %700 ], [ 0, %696 ], [ 0, %693 ]
  %703 = phi double [ %331, %430 ], [ %331, %531 ], [ %331, %333 ], [ %331, %638 ], [ %331, %685 ], [ %331, %700 ], [ %534, %696 ], [ %534, %693 ]
  %704 = phi i64 [ -4, %430 ], [ %535, %531 ], [ %332, %333 ], [ -2, %638 ], [ 21, %685 ], [ -3, %700 ], [ %535, %696 ], [ %535, %693 ]
  switch i32 %702, label %724 [
    i32 0, label %330
    i32 8, label %705
  ], !llvm.loop !15

705:                                              ; preds = %701
  br i1 %142, label %706, label %724

706:                                              ; preds = %705, %716
  %707 = phi i64 [ %717, %716 ], [ 0, %705 ]
  %708 = getelementptr inbounds double, ptr %329, i64 %707
  %709 = load double, ptr %708, align 8
  %710 = fcmp ogt double %709, 0.000000e+00
  br i1 %710, label %713, label %711

711:                                              ; preds = %706
  %712 = fcmp olt double %709, 0.000000e+00
  br i1 %712, label %713, label %716

713:                                              ; preds = %711, %706
  %714 = phi i64 [ 1, %706 ], [ -1, %711 ]
  %715 = getelementptr inbounds i64, ptr %16, i64 %707
  store i64 %714, ptr %715, align 8
  br label %716

716:                                              ; preds = %713, %711
  %717 = add nuw nsw i64 %707, 1
  %718 = icmp eq i64 %717, %12
  br i1 %718, label %724, label %706, !llvm.loop !16

719:                                              ; preds = %316, %287
  %720 = load ptr, ptr %20, align 8
  %721 = getelementptr inbounds i8, ptr %720, i64 80
  store i64 %23, ptr %721, align 8
  %722 = load ptr, ptr %19, align 8
  %723 = getelementptr inbounds i8, ptr %722, i64 48
  store double 1.000000e+00, ptr %723, align 8
  br label %724

724:                                              ; preds = %701, %716, %719, %705
  %725 = phi i32 [ 0, %705 ], [ 1, %719 ], [ 0, %716 ], [ %702, %701 ]
  %726 = phi double [ %328, %705 ], [ %146, %719 ], [ %328, %716 ], [ %703, %701 ]
  %727 = phi i64 [ %704, %705 ], [ -4, %719 ], [ %704, %716 ], [ %704, %701 ]
  %728 = icmp eq i32 %725, 0
  br i1 %728, label %729, label %734

729:                                              ; preds = %724
  %730 = fcmp oeq double %726, %150
  %731 = zext i1 %730 to i32
  %732 = add nuw nsw i32 %147, %731
  %733 = icmp ugt i32 %732, 4
  br i1 %733, label %734, label %143, !llvm.loop !17

734:                                              ; preds = %729, %724
  %735 = phi i1 [ %733, %729 ], [ %144, %724 ]
  br i1 %735, label %736, label %754

736:                                              ; preds = %734
  %737 = icmp sgt i64 %12, 0
  br i1 %737, label %738, label %741

738:                                              ; preds = %736
  %739 = shl i64 %12, 5
  %740 = getelementptr i8, ptr %28, i64 %739
  br label %743

741:                                              ; preds = %743, %736
  %742 = load double, ptr %24, align 8
  store double %742, ptr %30, align 8
  br label %750

743:                                              ; preds = %738, %743
  %744 = phi i64 [ 0, %738 ], [ %748, %743 ]
  %745 = getelementptr double, ptr %740, i64 %744
  %746 = load double, ptr %745, align 8
  %747 = getelementptr inbounds double, ptr %28, i64 %744
  store double %746, ptr %747, align 8
  %748 = add nuw nsw i64 %744, 1
  %749 = icmp eq i64 %748, %12
  br i1 %749, label %741, label %743, !llvm.loop !18

750:                                              ; preds = %93, %741, %87
  %751 = phi ptr [ %90, %87 ], [ %24, %741 ], [ %96, %93 ]
  %752 = phi i64 [ -4, %87 ], [ 0, %741 ], [ -4, %93 ]
  %753 = getelementptr inbounds i8, ptr %751, i64 48
  store double 1.000000e+00, ptr %753, align 8
  br label %754

754:                                              ; preds = %750, %734, %91
  %755 = phi i64 [ %727, %734 ], [ %92, %91 ], [ %752, %750 ]
  ret i64 %755
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
  %32 = getelementptr inbounds i8, ptr %0, i64 936
  %33 = getelementptr inbounds i8, ptr %1, i64 16
  %34 = getelementptr inbounds i8, ptr %1, i64 8
  %35 = getelementptr inbounds i8, ptr %0, i64 168
  %36 = getelementptr inbounds i8, ptr %0, i64 248
  %37 = getelementptr inbounds i8, ptr %0, i64 144
  %38 = getelementptr inbounds i8, ptr %0, i64 168
  %39 = getelementptr inbounds i8, ptr %0, i64 192
  %40 = getelementptr inbounds i8, ptr %0, i64 744
  %41 = getelementptr inbounds i8, ptr %0, i64 144
  %42 = getelementptr inbounds i8, ptr %0, i64 936
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
  br i1 %83, label %68, label %71, !llvm.loop !19

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
  br i1 %150, label %340, label %98, !llvm.loop !20

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
  br i1 %194, label %211, label %183, !llvm.loop !21

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
  br i1 %210, label %187, label %195, !llvm.loop !22

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
  br i1 %223, label %154, label %161, !llvm.loop !23

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
  br i1 %248, label %336, label %224, !llvm.loop !24

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
  br i1 %309, label %281, label %276, !llvm.loop !25

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
  br i1 %323, label %336, label %250, !llvm.loop !26

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
  br i1 %349, label %350, label %53, !llvm.loop !27

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
  %29 = getelementptr inbounds i8, ptr %0, i64 936
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
  br i1 %128, label %129, label %79, !llvm.loop !28

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
  br i1 %31, label %20, label %19, !llvm.loop !29

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
  br i1 %43, label %32, label %24, !llvm.loop !30
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
  br i1 %55, label %44, label %56, !llvm.loop !31

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
  br i1 %83, label %13, label %12, !llvm.loop !32
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
  %58 = getelementptr inbounds i8, ptr %0, i64 936
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
  br i1 %71, label %207, label %72, !llvm.loop !33

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
!15 = distinct !{!15, !5}
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
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !5}
!29 = distinct !{!29, !4, !5}
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
