; sources ae8253d8fe2ee627c30a7c7ff1c27f434c98d75162cd0d27a114c6cf6f3b390f
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Stepper = type { ptr, ptr, ptr }

@PLACES = internal unnamed_addr constant [9 x double] [double 0.000000e+00, double 0x3FB8722191A02D60, double 2.500000e-01, double 0x3FD6A09E667F3BCD, double 5.000000e-01, double 0x3FE3988E1409212E, double 7.500000e-01, double 0x3FED2A7FA9D2F8EA, double 1.000000e+00], align 16

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
  %27 = getelementptr inbounds i8, ptr %0, i64 992
  %28 = load i64, ptr %27, align 8
  %29 = icmp sgt i64 %28, 0
  br i1 %29, label %30, label %41

30:                                               ; preds = %3
  %31 = call fastcc i64 @unresolved(ptr noundef %0, ptr noundef nonnull %4, double noundef %1, double noundef %2) #7
  switch i64 %31, label %38 [
    i64 -4, label %32
    i64 0, label %37
  ]

32:                                               ; preds = %30
  %33 = load ptr, ptr %22, align 8
  %34 = getelementptr inbounds i8, ptr %33, i64 80
  store i64 %25, ptr %34, align 8
  %35 = load ptr, ptr %21, align 8
  %36 = getelementptr inbounds i8, ptr %35, i64 48
  store double 1.000000e+00, ptr %36, align 8
  br label %38

37:                                               ; preds = %30
  br label %38

38:                                               ; preds = %30, %37, %32
  %39 = phi i1 [ false, %32 ], [ true, %37 ], [ false, %30 ]
  %40 = phi i64 [ -4, %32 ], [ undef, %37 ], [ %31, %30 ]
  br i1 %39, label %41, label %516

41:                                               ; preds = %38, %3
  %42 = phi i64 [ %40, %38 ], [ undef, %3 ]
  %43 = getelementptr inbounds i8, ptr %0, i64 888
  %44 = getelementptr inbounds i8, ptr %0, i64 408
  %45 = getelementptr inbounds i8, ptr %0, i64 504
  %46 = getelementptr inbounds i8, ptr %0, i64 320
  %47 = getelementptr inbounds i8, ptr %0, i64 168
  %48 = getelementptr inbounds i8, ptr %0, i64 248
  %49 = getelementptr inbounds i8, ptr %0, i64 168
  %50 = getelementptr inbounds i8, ptr %0, i64 192
  %51 = getelementptr inbounds i8, ptr %0, i64 744
  %52 = icmp sgt i64 %12, 0
  %53 = getelementptr inbounds i8, ptr %0, i64 792
  %54 = icmp slt i64 %12, 1
  %55 = getelementptr double, ptr %16, i64 %12
  %56 = icmp sgt i64 %12, 0
  %57 = getelementptr double, ptr %16, i64 %12
  %58 = getelementptr inbounds i8, ptr %0, i64 792
  %59 = getelementptr inbounds i8, ptr %26, i64 48
  %60 = icmp sgt i64 %12, 0
  %61 = getelementptr inbounds i8, ptr %0, i64 920
  %62 = getelementptr inbounds i8, ptr %0, i64 912
  %63 = getelementptr inbounds i8, ptr %0, i64 936
  %64 = getelementptr inbounds i8, ptr %0, i64 960
  %65 = getelementptr inbounds i8, ptr %0, i64 976
  %66 = getelementptr inbounds i8, ptr %0, i64 920
  %67 = getelementptr inbounds i8, ptr %26, i64 48
  %68 = icmp sgt i64 %12, 0
  %69 = getelementptr inbounds i8, ptr %26, i64 48
  %70 = icmp sgt i64 %12, 0
  br label %75

71:                                               ; preds = %507
  %72 = add nuw nsw i32 %79, 1
  %73 = icmp ugt i32 %79, 3
  %74 = icmp eq i32 %72, 5
  br i1 %74, label %512, label %75, !llvm.loop !3

75:                                               ; preds = %41, %71
  %76 = phi i1 [ false, %41 ], [ %73, %71 ]
  %77 = phi i64 [ %42, %41 ], [ %510, %71 ]
  %78 = phi double [ 0.000000e+00, %41 ], [ %509, %71 ]
  %79 = phi i32 [ 1, %41 ], [ %72, %71 ]
  %80 = uitofp nneg i32 %79 to double
  %81 = fmul double %80, 2.500000e-01
  %82 = load ptr, ptr %43, align 8
  %83 = load ptr, ptr %44, align 8
  %84 = insertelement <8 x double> poison, double %81, i64 0
  %85 = shufflevector <8 x double> %84, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %85, ptr %83, align 8
  %86 = load ptr, ptr %8, align 8
  %87 = load ptr, ptr %45, align 8
  %88 = load i64, ptr %46, align 8
  %89 = load ptr, ptr %0, align 8
  %90 = getelementptr inbounds i8, ptr %89, i64 24
  %91 = load i64, ptr %90, align 8
  %92 = load ptr, ptr %44, align 8
  %93 = load ptr, ptr %6, align 8
  %94 = getelementptr inbounds i8, ptr %93, i64 16
  %95 = load i64, ptr %94, align 8
  tail call fastcc void @nested(ptr noundef %82, ptr noundef %86, ptr noundef %87, i64 noundef %88, i64 noundef %91, ptr noundef %92, i64 noundef %95) #7
  %96 = fmul double %81, %2
  %97 = fadd double %96, %1
  %98 = load ptr, ptr %47, align 8
  store double %97, ptr %98, align 8
  %99 = load i64, ptr %48, align 8
  %100 = icmp sgt i64 %99, 0
  br i1 %100, label %101, label %102

101:                                              ; preds = %75
  tail call fastcc void @sample(ptr noundef nonnull %6) #7
  br label %102

102:                                              ; preds = %75, %101
  %103 = load ptr, ptr %9, align 8
  %104 = load i64, ptr %103, align 8
  %105 = load ptr, ptr %49, align 8
  %106 = load ptr, ptr %43, align 8
  %107 = load ptr, ptr %50, align 8
  %108 = load ptr, ptr %51, align 8
  %109 = load ptr, ptr %15, align 8
  %110 = inttoptr i64 %104 to ptr
  %111 = tail call i32 %110(ptr noundef %105, ptr noundef %106, ptr noundef %107, ptr noundef %108, ptr noundef %109) #8
  %112 = icmp slt i32 %111, 0
  br i1 %112, label %113, label %118

113:                                              ; preds = %102
  %114 = load ptr, ptr %22, align 8
  %115 = getelementptr inbounds i8, ptr %114, i64 80
  store i64 %25, ptr %115, align 8
  %116 = load ptr, ptr %21, align 8
  %117 = getelementptr inbounds i8, ptr %116, i64 48
  store double 1.000000e+00, ptr %117, align 8
  br label %507

118:                                              ; preds = %102, %489
  %119 = phi double [ %491, %489 ], [ %78, %102 ]
  %120 = phi i64 [ %492, %489 ], [ %77, %102 ]
  br i1 %52, label %125, label %121

121:                                              ; preds = %175, %118
  %122 = phi double [ 2.000000e+00, %118 ], [ %176, %175 ]
  %123 = phi i32 [ 0, %118 ], [ %177, %175 ]
  %124 = fcmp ogt double %122, 1.000000e+00
  br i1 %124, label %489, label %180

125:                                              ; preds = %118, %175
  %126 = phi i64 [ %178, %175 ], [ 0, %118 ]
  %127 = phi i32 [ %177, %175 ], [ 0, %118 ]
  %128 = phi double [ %176, %175 ], [ 2.000000e+00, %118 ]
  %129 = getelementptr inbounds i64, ptr %20, i64 %126
  store i64 0, ptr %129, align 8
  %130 = getelementptr inbounds i64, ptr %18, i64 %126
  %131 = load i64, ptr %130, align 8
  %132 = getelementptr inbounds double, ptr %16, i64 %126
  %133 = load double, ptr %132, align 8
  %134 = getelementptr inbounds i64, ptr %14, i64 %126
  %135 = load i64, ptr %134, align 8
  %136 = icmp slt i64 %131, 0
  %137 = fcmp ogt double %133, 0.000000e+00
  %138 = and i1 %136, %137
  %139 = icmp sgt i64 %135, -1
  %140 = and i1 %138, %139
  br i1 %140, label %148, label %141

141:                                              ; preds = %125
  %142 = icmp sgt i64 %131, 0
  %143 = fcmp olt double %133, 0.000000e+00
  %144 = and i1 %142, %143
  br i1 %144, label %145, label %148

145:                                              ; preds = %141
  %146 = icmp slt i64 %135, 1
  %147 = zext i1 %146 to i32
  br label %148

148:                                              ; preds = %125, %141, %145
  %149 = phi i32 [ 1, %125 ], [ 0, %141 ], [ %147, %145 ]
  %150 = icmp eq i32 %149, 0
  br i1 %150, label %151, label %155

151:                                              ; preds = %148
  %152 = icmp eq i64 %131, 0
  %153 = fcmp ord double %133, 0.000000e+00
  %154 = or i1 %152, %153
  br i1 %154, label %175, label %155

155:                                              ; preds = %151, %148
  %156 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %119, double noundef %81, i64 noundef %126) #7
  %157 = fcmp ole double %156, %119
  %158 = zext i1 %157 to i64
  store i64 %158, ptr %129, align 8
  %159 = fcmp uge double %156, %128
  %160 = select i1 %159, i32 %127, i32 0
  %161 = fcmp ugt double %156, %128
  br i1 %161, label %172, label %162

162:                                              ; preds = %155
  %163 = icmp eq i32 %160, 0
  br i1 %163, label %164, label %169

164:                                              ; preds = %162
  %165 = load ptr, ptr %53, align 8
  %166 = getelementptr inbounds i64, ptr %165, i64 %126
  %167 = load i64, ptr %166, align 8
  %168 = icmp eq i64 %167, 1
  br label %169

169:                                              ; preds = %164, %162
  %170 = phi i1 [ true, %162 ], [ %168, %164 ]
  %171 = zext i1 %170 to i32
  br label %172

172:                                              ; preds = %169, %155
  %173 = phi i32 [ %171, %169 ], [ %160, %155 ]
  %174 = select i1 %159, double %128, double %156
  br label %175

175:                                              ; preds = %151, %172
  %176 = phi double [ %174, %172 ], [ %128, %151 ]
  %177 = phi i32 [ %173, %172 ], [ %127, %151 ]
  %178 = add nuw nsw i64 %126, 1
  %179 = icmp eq i64 %178, %12
  br i1 %179, label %121, label %125, !llvm.loop !6

180:                                              ; preds = %121
  %181 = load ptr, ptr %43, align 8
  %182 = load ptr, ptr %44, align 8
  %183 = insertelement <8 x double> poison, double %122, i64 0
  %184 = shufflevector <8 x double> %183, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %184, ptr %182, align 8
  %185 = load ptr, ptr %8, align 8
  %186 = load ptr, ptr %45, align 8
  %187 = load i64, ptr %46, align 8
  %188 = load ptr, ptr %0, align 8
  %189 = getelementptr inbounds i8, ptr %188, i64 24
  %190 = load i64, ptr %189, align 8
  %191 = load ptr, ptr %44, align 8
  %192 = load ptr, ptr %6, align 8
  %193 = getelementptr inbounds i8, ptr %192, i64 16
  %194 = load i64, ptr %193, align 8
  tail call fastcc void @nested(ptr noundef %181, ptr noundef %185, ptr noundef %186, i64 noundef %187, i64 noundef %190, ptr noundef %191, i64 noundef %194) #7
  %195 = fmul double %122, %2
  %196 = fadd double %195, %1
  %197 = load ptr, ptr %47, align 8
  store double %196, ptr %197, align 8
  %198 = load i64, ptr %48, align 8
  %199 = icmp sgt i64 %198, 0
  br i1 %199, label %200, label %201

200:                                              ; preds = %180
  tail call fastcc void @sample(ptr noundef nonnull %6) #7
  br label %201

201:                                              ; preds = %180, %200
  %202 = load ptr, ptr %9, align 8
  %203 = load i64, ptr %202, align 8
  %204 = load ptr, ptr %49, align 8
  %205 = load ptr, ptr %43, align 8
  %206 = load ptr, ptr %50, align 8
  %207 = load ptr, ptr %51, align 8
  %208 = load ptr, ptr %15, align 8
  %209 = getelementptr inbounds i8, ptr %202, i64 8
  %210 = load i64, ptr %209, align 8
  %211 = getelementptr inbounds double, ptr %208, i64 %210
  %212 = inttoptr i64 %203 to ptr
  %213 = tail call i32 %212(ptr noundef %204, ptr noundef %205, ptr noundef %206, ptr noundef %207, ptr noundef %211) #8
  %214 = icmp slt i32 %213, 0
  br i1 %214, label %218, label %215

215:                                              ; preds = %201
  %216 = icmp ne i32 %123, 0
  %217 = select i1 %54, i1 true, i1 %216
  br i1 %217, label %319, label %223

218:                                              ; preds = %201
  %219 = load ptr, ptr %22, align 8
  %220 = getelementptr inbounds i8, ptr %219, i64 80
  store i64 %25, ptr %220, align 8
  %221 = load ptr, ptr %21, align 8
  %222 = getelementptr inbounds i8, ptr %221, i64 48
  store double 1.000000e+00, ptr %222, align 8
  br label %489

223:                                              ; preds = %215, %313
  %224 = phi i1 [ %318, %313 ], [ %217, %215 ]
  %225 = phi i64 [ %315, %313 ], [ %120, %215 ]
  %226 = phi i64 [ %316, %313 ], [ 0, %215 ]
  %227 = phi double [ %314, %313 ], [ %122, %215 ]
  %228 = getelementptr inbounds i64, ptr %18, i64 %226
  %229 = load i64, ptr %228, align 8
  %230 = getelementptr double, ptr %55, i64 %226
  %231 = load double, ptr %230, align 8
  %232 = getelementptr inbounds i64, ptr %14, i64 %226
  %233 = load i64, ptr %232, align 8
  %234 = icmp slt i64 %229, 0
  %235 = fcmp ogt double %231, 0.000000e+00
  %236 = and i1 %234, %235
  %237 = icmp sgt i64 %233, -1
  %238 = and i1 %236, %237
  br i1 %238, label %246, label %239

239:                                              ; preds = %223
  %240 = icmp sgt i64 %229, 0
  %241 = fcmp olt double %231, 0.000000e+00
  %242 = and i1 %240, %241
  br i1 %242, label %243, label %246

243:                                              ; preds = %239
  %244 = icmp slt i64 %233, 1
  %245 = zext i1 %244 to i32
  br label %246

246:                                              ; preds = %223, %239, %243
  %247 = phi i32 [ 1, %223 ], [ 0, %239 ], [ %245, %243 ]
  %248 = icmp eq i32 %247, 0
  br i1 %248, label %313, label %249

249:                                              ; preds = %246
  %250 = getelementptr inbounds double, ptr %16, i64 %226
  %251 = load double, ptr %250, align 8
  %252 = fcmp ogt double %251, 0.000000e+00
  %253 = and i1 %234, %252
  %254 = and i1 %237, %253
  br i1 %254, label %262, label %255

255:                                              ; preds = %249
  %256 = icmp sgt i64 %229, 0
  %257 = fcmp olt double %251, 0.000000e+00
  %258 = and i1 %256, %257
  br i1 %258, label %259, label %262

259:                                              ; preds = %255
  %260 = icmp slt i64 %233, 1
  %261 = zext i1 %260 to i32
  br label %262

262:                                              ; preds = %249, %255, %259
  %263 = phi i32 [ 1, %249 ], [ 0, %255 ], [ %261, %259 ]
  %264 = icmp eq i32 %263, 0
  br i1 %264, label %265, label %313

265:                                              ; preds = %262
  %266 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %119, double noundef %227, i64 noundef %226) #7
  %267 = fcmp ogt double %266, %119
  br i1 %267, label %268, label %270

268:                                              ; preds = %265
  %269 = getelementptr inbounds i64, ptr %20, i64 %226
  store i64 2, ptr %269, align 8
  br label %270

270:                                              ; preds = %268, %265
  %271 = phi double [ %266, %268 ], [ %227, %265 ]
  %272 = load ptr, ptr %43, align 8
  %273 = load ptr, ptr %44, align 8
  %274 = insertelement <8 x double> poison, double %271, i64 0
  %275 = shufflevector <8 x double> %274, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %275, ptr %273, align 8
  %276 = load ptr, ptr %8, align 8
  %277 = load ptr, ptr %45, align 8
  %278 = load i64, ptr %46, align 8
  %279 = load ptr, ptr %0, align 8
  %280 = getelementptr inbounds i8, ptr %279, i64 24
  %281 = load i64, ptr %280, align 8
  %282 = load ptr, ptr %44, align 8
  %283 = load ptr, ptr %6, align 8
  %284 = getelementptr inbounds i8, ptr %283, i64 16
  %285 = load i64, ptr %284, align 8
  tail call fastcc void @nested(ptr noundef %272, ptr noundef %276, ptr noundef %277, i64 noundef %278, i64 noundef %281, ptr noundef %282, i64 noundef %285) #7
  %286 = fmul double %271, %2
  %287 = fadd double %286, %1
  %288 = load ptr, ptr %47, align 8
  store double %287, ptr %288, align 8
  %289 = load i64, ptr %48, align 8
  %290 = icmp sgt i64 %289, 0
  br i1 %290, label %291, label %292

291:                                              ; preds = %270
  tail call fastcc void @sample(ptr noundef nonnull %6) #7
  br label %292

292:                                              ; preds = %270, %291
  %293 = load ptr, ptr %9, align 8
  %294 = load i64, ptr %293, align 8
  %295 = load ptr, ptr %49, align 8
  %296 = load ptr, ptr %43, align 8
  %297 = load ptr, ptr %50, align 8
  %298 = load ptr, ptr %51, align 8
  %299 = load ptr, ptr %15, align 8
  %300 = getelementptr inbounds i8, ptr %293, i64 8
  %301 = load i64, ptr %300, align 8
  %302 = getelementptr inbounds double, ptr %299, i64 %301
  %303 = inttoptr i64 %294 to ptr
  %304 = tail call i32 %303(ptr noundef %295, ptr noundef %296, ptr noundef %297, ptr noundef %298, ptr noundef %302) #8
  %305 = icmp sgt i32 %304, -1
  br i1 %305, label %311, label %306

306:                                              ; preds = %292
  %307 = load ptr, ptr %22, align 8
  %308 = getelementptr inbounds i8, ptr %307, i64 80
  store i64 %25, ptr %308, align 8
  %309 = load ptr, ptr %21, align 8
  %310 = getelementptr inbounds i8, ptr %309, i64 48
  store double 1.000000e+00, ptr %310, align 8
  br label %311

311:                                              ; preds = %292, %306
  %312 = phi i64 [ -4, %306 ], [ %225, %292 ]
  br i1 %305, label %313, label %319

313:                                              ; preds = %246, %262, %311
  %314 = phi double [ %227, %262 ], [ %271, %311 ], [ %227, %246 ]
  %315 = phi i64 [ %225, %262 ], [ %312, %311 ], [ %225, %246 ]
  %316 = add nuw nsw i64 %226, 1
  %317 = icmp sge i64 %316, %12
  %318 = select i1 %317, i1 true, i1 %216
  br i1 %318, label %319, label %223, !llvm.loop !7

319:                                              ; preds = %311, %313, %215
  %320 = phi i1 [ %217, %215 ], [ %224, %311 ], [ %318, %313 ]
  %321 = phi double [ %122, %215 ], [ %271, %311 ], [ %314, %313 ]
  %322 = phi i32 [ 10, %215 ], [ 1, %311 ], [ 10, %313 ]
  %323 = phi i64 [ %120, %215 ], [ %312, %311 ], [ %315, %313 ]
  br i1 %320, label %324, label %489

324:                                              ; preds = %319
  br i1 %56, label %335, label %327

325:                                              ; preds = %422
  %326 = zext i1 %423 to i32
  br label %327

327:                                              ; preds = %325, %324
  %328 = phi i32 [ 0, %324 ], [ %326, %325 ]
  %329 = phi i64 [ -1, %324 ], [ %412, %325 ]
  %330 = icmp eq i32 %328, 0
  br i1 %330, label %331, label %426

331:                                              ; preds = %327
  br i1 %60, label %332, label %427

332:                                              ; preds = %331
  %333 = fmul double %321, %2
  %334 = fadd double %333, %1
  br label %430

335:                                              ; preds = %324, %422
  %336 = phi i64 [ %424, %422 ], [ 0, %324 ]
  %337 = phi i64 [ %412, %422 ], [ -1, %324 ]
  %338 = phi i1 [ %423, %422 ], [ false, %324 ]
  %339 = getelementptr double, ptr %57, i64 %336
  %340 = load double, ptr %339, align 8
  %341 = getelementptr inbounds i64, ptr %18, i64 %336
  %342 = load i64, ptr %341, align 8
  %343 = getelementptr inbounds i64, ptr %14, i64 %336
  %344 = load i64, ptr %343, align 8
  %345 = icmp slt i64 %342, 0
  %346 = fcmp ogt double %340, 0.000000e+00
  %347 = and i1 %346, %345
  %348 = icmp sgt i64 %344, -1
  %349 = and i1 %347, %348
  br i1 %349, label %357, label %350

350:                                              ; preds = %335
  %351 = icmp sgt i64 %342, 0
  %352 = fcmp olt double %340, 0.000000e+00
  %353 = and i1 %352, %351
  br i1 %353, label %354, label %357

354:                                              ; preds = %350
  %355 = icmp slt i64 %344, 1
  %356 = zext i1 %355 to i32
  br label %357

357:                                              ; preds = %335, %350, %354
  %358 = phi i32 [ 1, %335 ], [ 0, %350 ], [ %356, %354 ]
  %359 = icmp eq i32 %358, 0
  br i1 %359, label %360, label %385

360:                                              ; preds = %357
  %361 = getelementptr inbounds double, ptr %16, i64 %336
  %362 = load double, ptr %361, align 8
  %363 = fcmp ogt double %362, 0.000000e+00
  %364 = and i1 %345, %363
  %365 = and i1 %348, %364
  br i1 %365, label %373, label %366

366:                                              ; preds = %360
  %367 = icmp sgt i64 %342, 0
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
  br i1 %375, label %385, label %376

376:                                              ; preds = %373
  %377 = fcmp oeq double %340, 0.000000e+00
  br i1 %377, label %382, label %378

378:                                              ; preds = %376
  %379 = getelementptr inbounds i64, ptr %20, i64 %336
  %380 = load i64, ptr %379, align 8
  %381 = icmp eq i64 %380, 1
  br label %382

382:                                              ; preds = %378, %376
  %383 = phi i1 [ true, %376 ], [ %381, %378 ]
  %384 = zext i1 %383 to i32
  br label %385

385:                                              ; preds = %382, %373, %357
  %386 = phi i32 [ 1, %357 ], [ %384, %382 ], [ 0, %373 ]
  %387 = icmp eq i32 %386, 0
  br i1 %387, label %388, label %394

388:                                              ; preds = %385
  %389 = getelementptr inbounds i64, ptr %20, i64 %336
  %390 = load i64, ptr %389, align 8
  %391 = icmp eq i64 %390, 2
  %392 = fcmp oeq double %340, 0.000000e+00
  %393 = and i1 %392, %391
  br label %394

394:                                              ; preds = %388, %385
  %395 = phi i1 [ true, %385 ], [ %393, %388 ]
  br i1 %395, label %411, label %396

396:                                              ; preds = %394
  %397 = getelementptr inbounds double, ptr %16, i64 %336
  %398 = load double, ptr %397, align 8
  %399 = icmp eq i64 %342, 0
  %400 = fcmp ord double %398, 0.000000e+00
  %401 = or i1 %399, %400
  br i1 %401, label %411, label %402

402:                                              ; preds = %396
  %403 = sitofp i64 %342 to double
  %404 = fmul double %340, %403
  %405 = fcmp olt double %404, 0.000000e+00
  br i1 %405, label %406, label %408

406:                                              ; preds = %402
  %407 = sub nsw i64 0, %342
  store i64 %407, ptr %341, align 8
  br label %411

408:                                              ; preds = %402
  %409 = fcmp ueq double %340, 0.000000e+00
  %410 = select i1 %409, i64 %336, i64 %337
  br label %411

411:                                              ; preds = %408, %406, %396, %394
  %412 = phi i64 [ %337, %394 ], [ %337, %406 ], [ %337, %396 ], [ %410, %408 ]
  %413 = zext i1 %395 to i64
  %414 = getelementptr inbounds i64, ptr %20, i64 %336
  store i64 %413, ptr %414, align 8
  %415 = xor i1 %395, true
  %416 = or i1 %338, %415
  br i1 %416, label %422, label %417

417:                                              ; preds = %411
  %418 = load ptr, ptr %58, align 8
  %419 = getelementptr inbounds i64, ptr %418, i64 %336
  %420 = load i64, ptr %419, align 8
  %421 = icmp eq i64 %420, 1
  br label %422

422:                                              ; preds = %411, %417
  %423 = phi i1 [ %338, %411 ], [ %421, %417 ]
  %424 = add nuw nsw i64 %336, 1
  %425 = icmp eq i64 %424, %12
  br i1 %425, label %325, label %335, !llvm.loop !8

426:                                              ; preds = %327
  store double %321, ptr %59, align 8
  br label %489

427:                                              ; preds = %470, %331
  %428 = icmp sgt i64 %329, -1
  br i1 %428, label %429, label %481

429:                                              ; preds = %427
  br i1 %68, label %474, label %473

430:                                              ; preds = %332, %470
  %431 = phi i64 [ 0, %332 ], [ %471, %470 ]
  %432 = getelementptr inbounds i64, ptr %20, i64 %431
  %433 = load i64, ptr %432, align 8
  %434 = icmp eq i64 %433, 0
  br i1 %434, label %470, label %435

435:                                              ; preds = %430
  %436 = load ptr, ptr %22, align 8
  %437 = getelementptr inbounds i8, ptr %436, i64 80
  %438 = load i64, ptr %437, align 8
  %439 = load ptr, ptr %6, align 8
  %440 = getelementptr inbounds i8, ptr %439, i64 8
  %441 = load i64, ptr %440, align 8
  %442 = load i64, ptr %61, align 8
  %443 = icmp eq i64 %442, 0
  br i1 %443, label %466, label %444

444:                                              ; preds = %435
  %445 = load ptr, ptr %62, align 8
  %446 = getelementptr inbounds double, ptr %445, i64 %438
  store double %334, ptr %446, align 8
  %447 = load ptr, ptr %63, align 8
  %448 = getelementptr inbounds i64, ptr %447, i64 %438
  store i64 %431, ptr %448, align 8
  %449 = icmp sgt i64 %441, 0
  br i1 %449, label %454, label %450

450:                                              ; preds = %454, %444
  %451 = add nsw i64 %438, 1
  %452 = load ptr, ptr %22, align 8
  %453 = getelementptr inbounds i8, ptr %452, i64 80
  store i64 %451, ptr %453, align 8
  br label %466

454:                                              ; preds = %444, %454
  %455 = phi i64 [ %464, %454 ], [ 0, %444 ]
  %456 = load ptr, ptr %43, align 8
  %457 = getelementptr inbounds double, ptr %456, i64 %455
  %458 = load double, ptr %457, align 8
  %459 = load ptr, ptr %64, align 8
  %460 = load i64, ptr %65, align 8
  %461 = mul nsw i64 %460, %438
  %462 = getelementptr double, ptr %459, i64 %461
  %463 = getelementptr double, ptr %462, i64 %455
  store double %458, ptr %463, align 8
  %464 = add nuw nsw i64 %455, 1
  %465 = icmp eq i64 %464, %441
  br i1 %465, label %450, label %454, !llvm.loop !9

466:                                              ; preds = %435, %450
  %467 = getelementptr inbounds i64, ptr %18, i64 %431
  %468 = load i64, ptr %467, align 8
  %469 = sub nsw i64 0, %468
  store i64 %469, ptr %467, align 8
  br label %470

470:                                              ; preds = %430, %466
  %471 = add nuw nsw i64 %431, 1
  %472 = icmp eq i64 %471, %12
  br i1 %472, label %427, label %430, !llvm.loop !10

473:                                              ; preds = %474, %429
  store double %321, ptr %69, align 8
  br label %489

474:                                              ; preds = %429, %474
  %475 = phi i64 [ %479, %474 ], [ 0, %429 ]
  %476 = icmp eq i64 %475, %329
  %477 = zext i1 %476 to i64
  %478 = getelementptr inbounds i64, ptr %20, i64 %475
  store i64 %477, ptr %478, align 8
  %479 = add nuw nsw i64 %475, 1
  %480 = icmp eq i64 %479, %12
  br i1 %480, label %473, label %474, !llvm.loop !11

481:                                              ; preds = %427
  %482 = load i64, ptr %66, align 8
  %483 = icmp sgt i64 %482, 0
  br i1 %483, label %484, label %489

484:                                              ; preds = %481
  %485 = load i64, ptr %24, align 8
  %486 = add nsw i64 %485, %12
  %487 = icmp sgt i64 %486, %482
  br i1 %487, label %488, label %489

488:                                              ; preds = %484
  store double %321, ptr %67, align 8
  br label %489

489:                                              ; preds = %426, %473, %488, %484, %481, %121, %319, %218
  %490 = phi i32 [ 1, %218 ], [ %322, %319 ], [ 5, %121 ], [ 1, %426 ], [ 1, %473 ], [ 1, %488 ], [ 0, %484 ], [ 0, %481 ]
  %491 = phi double [ %119, %218 ], [ %119, %319 ], [ %119, %121 ], [ %119, %426 ], [ %119, %473 ], [ %119, %488 ], [ %321, %484 ], [ %321, %481 ]
  %492 = phi i64 [ -4, %218 ], [ %323, %319 ], [ %120, %121 ], [ -2, %426 ], [ 21, %473 ], [ -3, %488 ], [ %323, %484 ], [ %323, %481 ]
  switch i32 %490, label %507 [
    i32 0, label %118
    i32 5, label %493
  ], !llvm.loop !12

493:                                              ; preds = %489
  br i1 %70, label %494, label %507

494:                                              ; preds = %493, %504
  %495 = phi i64 [ %505, %504 ], [ 0, %493 ]
  %496 = getelementptr inbounds double, ptr %16, i64 %495
  %497 = load double, ptr %496, align 8
  %498 = fcmp ogt double %497, 0.000000e+00
  br i1 %498, label %501, label %499

499:                                              ; preds = %494
  %500 = fcmp olt double %497, 0.000000e+00
  br i1 %500, label %501, label %504

501:                                              ; preds = %499, %494
  %502 = phi i64 [ 1, %494 ], [ -1, %499 ]
  %503 = getelementptr inbounds i64, ptr %18, i64 %495
  store i64 %502, ptr %503, align 8
  br label %504

504:                                              ; preds = %501, %499
  %505 = add nuw nsw i64 %495, 1
  %506 = icmp eq i64 %505, %12
  br i1 %506, label %507, label %494, !llvm.loop !13

507:                                              ; preds = %489, %504, %493, %113
  %508 = phi i32 [ 1, %113 ], [ 0, %493 ], [ 0, %504 ], [ %490, %489 ]
  %509 = phi double [ %78, %113 ], [ %81, %493 ], [ %81, %504 ], [ %491, %489 ]
  %510 = phi i64 [ -4, %113 ], [ %492, %493 ], [ %492, %504 ], [ %492, %489 ]
  %511 = icmp eq i32 %508, 0
  br i1 %511, label %71, label %512

512:                                              ; preds = %71, %507
  %513 = phi i1 [ %73, %71 ], [ %76, %507 ]
  br i1 %513, label %514, label %516

514:                                              ; preds = %512
  %515 = getelementptr inbounds i8, ptr %26, i64 48
  store double 1.000000e+00, ptr %515, align 8
  br label %516

516:                                              ; preds = %38, %512, %514
  %517 = phi i64 [ 0, %514 ], [ %510, %512 ], [ %40, %38 ]
  ret i64 %517
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
  br i1 %25, label %26, label %277

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
  br i1 %37, label %38, label %42, !llvm.loop !14

38:                                               ; preds = %35
  %39 = icmp sgt i64 %9, 1
  br i1 %39, label %40, label %277

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
  tail call fastcc void @nested(ptr noundef %46, ptr noundef %52, ptr noundef %54, i64 noundef %56, i64 noundef %60, ptr noundef %61, i64 noundef %65) #7
  %66 = fmul double %45, %3
  %67 = fadd double %66, %2
  %68 = load ptr, ptr %30, align 8
  store double %67, ptr %68, align 8
  %69 = load i64, ptr %31, align 8
  %70 = icmp sgt i64 %69, 0
  br i1 %70, label %71, label %72

71:                                               ; preds = %42
  tail call fastcc void @sample(ptr noundef nonnull %6) #7
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
  %84 = tail call i32 %83(ptr noundef %76, ptr noundef %77, ptr noundef %78, ptr noundef %79, ptr noundef %82) #8
  %85 = icmp slt i32 %84, 0
  br i1 %85, label %277, label %35

86:                                               ; preds = %216
  %87 = add nuw nsw i64 %91, 1
  %88 = icmp eq i64 %87, %10
  br i1 %88, label %277, label %89, !llvm.loop !15

89:                                               ; preds = %40, %86
  %90 = phi i64 [ -4, %40 ], [ %219, %86 ]
  %91 = phi i64 [ 0, %40 ], [ %87, %86 ]
  %92 = getelementptr inbounds double, ptr %41, i64 %91
  br label %220

93:                                               ; preds = %273
  %94 = fmul double %234, 0x3CE0000000000000
  %95 = fmul double %230, 0x3E50000000000000
  %96 = fcmp ogt double %274, %95
  %97 = fmul double %274, 2.000000e+00
  %98 = select i1 %96, double %97, double 0.000000e+00
  %99 = fcmp ule double %98, %94
  %100 = fmul double %98, 2.000000e+00
  %101 = fneg double %94
  %102 = fcmp ogt double %98, %94
  br label %103

103:                                              ; preds = %93, %213
  %104 = phi i64 [ 1, %93 ], [ %214, %213 ]
  %105 = phi i32 [ undef, %93 ], [ %212, %213 ]
  %106 = add nsw i64 %104, -1
  %107 = mul nsw i64 %9, %106
  %108 = getelementptr inbounds double, ptr %92, i64 %107
  %109 = load double, ptr %108, align 8
  %110 = mul nuw nsw i64 %9, %104
  %111 = getelementptr inbounds double, ptr %92, i64 %110
  %112 = load double, ptr %111, align 8
  %113 = tail call double @llvm.fabs.f64(double %109)
  %114 = tail call double @llvm.fabs.f64(double %112)
  %115 = fcmp olt double %113, %114
  %116 = select i1 %115, double %113, double %114
  %117 = fmul double %109, %112
  %118 = fcmp ult double %117, 0.000000e+00
  %119 = or i1 %99, %118
  %120 = fcmp ugt double %116, %98
  %121 = or i1 %119, %120
  br i1 %121, label %126, label %122

122:                                              ; preds = %103
  %123 = fsub double %109, %112
  %124 = tail call double @llvm.fabs.f64(double %123)
  %125 = fcmp ugt double %124, %100
  br i1 %125, label %126, label %210

126:                                              ; preds = %122, %103
  %127 = add nuw nsw i64 %104, 1
  %128 = icmp eq i64 %127, 9
  br i1 %128, label %210, label %129

129:                                              ; preds = %126
  %130 = mul nuw nsw i64 %9, %127
  %131 = getelementptr inbounds double, ptr %92, i64 %130
  %132 = load double, ptr %131, align 8
  %133 = fadd double %109, %132
  %134 = fcmp olt double %133, 0.000000e+00
  %135 = select i1 %134, double -1.000000e+00, double 1.000000e+00
  %136 = fmul double %109, %132
  %137 = fcmp olt double %136, 0.000000e+00
  br i1 %137, label %210, label %138

138:                                              ; preds = %129
  %139 = fmul double %112, %135
  %140 = fcmp olt double %139, 0.000000e+00
  br i1 %140, label %141, label %148

141:                                              ; preds = %138
  %142 = and i64 %104, 1
  %143 = icmp ne i64 %142, 0
  %144 = fcmp ogt double %114, %94
  %145 = and i1 %143, %144
  %146 = select i1 %145, i32 1, i32 4
  %147 = select i1 %145, i32 1, i32 %105
  br label %210

148:                                              ; preds = %138
  %149 = getelementptr inbounds [9 x double], ptr @PLACES, i64 0, i64 %104
  %150 = load double, ptr %149, align 8
  %151 = getelementptr inbounds [9 x double], ptr @PLACES, i64 0, i64 %106
  %152 = load double, ptr %151, align 8
  %153 = fsub double %150, %152
  %154 = getelementptr inbounds [9 x double], ptr @PLACES, i64 0, i64 %127
  %155 = load double, ptr %154, align 8
  %156 = fsub double %155, %150
  %157 = fsub double %112, %109
  %158 = fdiv double %157, %153
  %159 = fsub double %132, %112
  %160 = fdiv double %159, %156
  %161 = fadd double %153, %156
  %162 = fmul double %158, %156
  %163 = fmul double %153, %160
  %164 = fadd double %162, %163
  %165 = fdiv double %164, %161
  %166 = fmul double %165, 5.000000e-01
  %167 = fmul double %161, %166
  %168 = fsub double %160, %158
  %169 = fdiv double %167, %168
  %170 = fsub double %150, %169
  %171 = fcmp ult double %170, %152
  %172 = fcmp ugt double %170, %155
  %173 = or i1 %171, %172
  br i1 %173, label %210, label %174

174:                                              ; preds = %148, %178
  %175 = phi i64 [ %184, %178 ], [ 0, %148 ]
  %176 = phi double [ %183, %178 ], [ 0.000000e+00, %148 ]
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
  br i1 %185, label %174, label %202, !llvm.loop !16

186:                                              ; preds = %174, %198
  %187 = phi i64 [ 0, %174 ], [ %200, %198 ]
  %188 = phi double [ 1.000000e+00, %174 ], [ %199, %198 ]
  %189 = icmp eq i64 %187, %175
  br i1 %189, label %198, label %190

190:                                              ; preds = %186
  %191 = getelementptr inbounds [9 x double], ptr @PLACES, i64 0, i64 %187
  %192 = load double, ptr %191, align 16
  %193 = fsub double %170, %192
  %194 = load double, ptr %177, align 16
  %195 = fsub double %194, %192
  %196 = fdiv double %193, %195
  %197 = fmul double %188, %196
  br label %198

198:                                              ; preds = %190, %186
  %199 = phi double [ %197, %190 ], [ %188, %186 ]
  %200 = add nuw nsw i64 %187, 2
  %201 = icmp ult i64 %187, 7
  br i1 %201, label %186, label %178, !llvm.loop !17

202:                                              ; preds = %178
  %203 = fmul double %135, %183
  %204 = fcmp olt double %203, %101
  br i1 %204, label %210, label %205

205:                                              ; preds = %202
  %206 = fcmp ole double %203, %98
  %207 = and i1 %102, %206
  %208 = zext i1 %207 to i32
  %209 = select i1 %207, i32 1, i32 %105
  br label %210

210:                                              ; preds = %205, %202, %148, %141, %129, %126, %122
  %211 = phi i32 [ 1, %122 ], [ 1, %126 ], [ 4, %129 ], [ 4, %148 ], [ 1, %202 ], [ %146, %141 ], [ %208, %205 ]
  %212 = phi i32 [ 1, %122 ], [ 0, %126 ], [ %105, %129 ], [ %105, %148 ], [ 1, %202 ], [ %147, %141 ], [ %209, %205 ]
  switch i32 %211, label %216 [
    i32 0, label %213
    i32 4, label %213
  ]

213:                                              ; preds = %210, %210
  %214 = add nuw nsw i64 %104, 1
  %215 = icmp eq i64 %214, 9
  br i1 %215, label %216, label %103, !llvm.loop !18

216:                                              ; preds = %213, %210
  %217 = phi i32 [ %212, %210 ], [ 0, %213 ]
  %218 = icmp eq i32 %217, 0
  %219 = select i1 %218, i64 %90, i64 -6
  br i1 %218, label %86, label %277

220:                                              ; preds = %89, %273
  %221 = phi i64 [ 0, %89 ], [ %275, %273 ]
  %222 = phi double [ 0.000000e+00, %89 ], [ %274, %273 ]
  %223 = phi double [ 0.000000e+00, %89 ], [ %234, %273 ]
  %224 = phi double [ 0.000000e+00, %89 ], [ %230, %273 ]
  %225 = mul nuw nsw i64 %9, %221
  %226 = getelementptr inbounds double, ptr %92, i64 %225
  %227 = load double, ptr %226, align 8
  %228 = tail call double @llvm.fabs.f64(double %227)
  %229 = fcmp ogt double %224, %228
  %230 = select i1 %229, double %224, double %228
  %231 = getelementptr double, ptr %226, i64 %10
  %232 = load double, ptr %231, align 8
  %233 = fcmp ogt double %223, %232
  %234 = select i1 %233, double %223, double %232
  %235 = and i64 %221, 1
  %236 = icmp eq i64 %235, 0
  br i1 %236, label %273, label %237

237:                                              ; preds = %220
  %238 = getelementptr inbounds [9 x double], ptr @PLACES, i64 0, i64 %221
  %239 = load double, ptr %238, align 8
  br label %240

240:                                              ; preds = %237, %244
  %241 = phi i64 [ 0, %237 ], [ %250, %244 ]
  %242 = phi double [ 0.000000e+00, %237 ], [ %249, %244 ]
  %243 = getelementptr inbounds [9 x double], ptr @PLACES, i64 0, i64 %241
  br label %252

244:                                              ; preds = %264
  %245 = mul nuw nsw i64 %9, %241
  %246 = getelementptr inbounds double, ptr %92, i64 %245
  %247 = load double, ptr %246, align 8
  %248 = fmul double %265, %247
  %249 = fadd double %242, %248
  %250 = add nuw nsw i64 %241, 2
  %251 = icmp ult i64 %241, 7
  br i1 %251, label %240, label %268, !llvm.loop !16

252:                                              ; preds = %240, %264
  %253 = phi i64 [ 0, %240 ], [ %266, %264 ]
  %254 = phi double [ 1.000000e+00, %240 ], [ %265, %264 ]
  %255 = icmp eq i64 %253, %241
  br i1 %255, label %264, label %256

256:                                              ; preds = %252
  %257 = getelementptr inbounds [9 x double], ptr @PLACES, i64 0, i64 %253
  %258 = load double, ptr %257, align 16
  %259 = fsub double %239, %258
  %260 = load double, ptr %243, align 16
  %261 = fsub double %260, %258
  %262 = fdiv double %259, %261
  %263 = fmul double %254, %262
  br label %264

264:                                              ; preds = %256, %252
  %265 = phi double [ %263, %256 ], [ %254, %252 ]
  %266 = add nuw nsw i64 %253, 2
  %267 = icmp ult i64 %253, 7
  br i1 %267, label %252, label %244, !llvm.loop !17

268:                                              ; preds = %244
  %269 = fsub double %227, %249
  %270 = tail call double @llvm.fabs.f64(double %269)
  %271 = fcmp ogt double %222, %270
  %272 = select i1 %271, double %222, double %270
  br label %273

273:                                              ; preds = %220, %268
  %274 = phi double [ %272, %268 ], [ %222, %220 ]
  %275 = add nuw nsw i64 %221, 1
  %276 = icmp eq i64 %275, 9
  br i1 %276, label %93, label %220, !llvm.loop !19

277:                                              ; preds = %72, %86, %216, %38, %4
  %278 = phi i64 [ 0, %4 ], [ 0, %38 ], [ %219, %216 ], [ 0, %86 ], [ -4, %72 ]
  ret i64 %278
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
  br i1 %128, label %129, label %79, !llvm.loop !20

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
  br i1 %31, label %20, label %19, !llvm.loop !21

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
  br i1 %43, label %32, label %24, !llvm.loop !22
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
  br i1 %55, label %44, label %56, !llvm.loop !23

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
  br i1 %83, label %13, label %12, !llvm.loop !24
}

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { nounwind willreturn memory(none) }
attributes #4 = { noinline nounwind }
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
!14 = distinct !{!14, !4, !5}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5}
!17 = distinct !{!17, !4, !5}
!18 = distinct !{!18, !4, !5}
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !5}
!21 = distinct !{!21, !4, !5}
!22 = distinct !{!22, !4, !5}
!23 = distinct !{!23, !4, !5}
!24 = distinct !{!24, !4, !5}
