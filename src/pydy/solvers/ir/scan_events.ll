; sources 5c82bcbeec0675ef9b4733ef084d9b48a5637cea040f6e242ce2faeb81809f52
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
  %37 = icmp sgt i64 %12, 0
  %38 = getelementptr double, ptr %16, i64 %12
  %39 = getelementptr inbounds i8, ptr %0, i64 792
  %40 = getelementptr inbounds i8, ptr %26, i64 48
  %41 = icmp sgt i64 %12, 0
  %42 = getelementptr inbounds i8, ptr %0, i64 912
  %43 = getelementptr inbounds i8, ptr %0, i64 920
  %44 = getelementptr inbounds i8, ptr %0, i64 936
  %45 = getelementptr inbounds i8, ptr %0, i64 960
  %46 = getelementptr inbounds i8, ptr %0, i64 976
  %47 = getelementptr inbounds i8, ptr %26, i64 48
  %48 = icmp sgt i64 %12, 0
  %49 = getelementptr inbounds i8, ptr %26, i64 48
  %50 = icmp sgt i64 %12, 0
  br label %55

51:                                               ; preds = %355
  %52 = add nuw nsw i32 %59, 1
  %53 = icmp ugt i32 %59, 3
  %54 = icmp eq i32 %52, 5
  br i1 %54, label %360, label %55, !llvm.loop !3

55:                                               ; preds = %3, %51
  %56 = phi i1 [ false, %3 ], [ %53, %51 ]
  %57 = phi i64 [ undef, %3 ], [ %358, %51 ]
  %58 = phi double [ 0.000000e+00, %3 ], [ %357, %51 ]
  %59 = phi i32 [ 1, %3 ], [ %52, %51 ]
  %60 = uitofp nneg i32 %59 to double
  %61 = fmul double %60, 2.500000e-01
  %62 = load ptr, ptr %27, align 8
  %63 = load ptr, ptr %28, align 8
  %64 = insertelement <8 x double> poison, double %61, i64 0
  %65 = shufflevector <8 x double> %64, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %65, ptr %63, align 8
  %66 = load ptr, ptr %8, align 8
  %67 = load ptr, ptr %29, align 8
  %68 = load i64, ptr %30, align 8
  %69 = load ptr, ptr %0, align 8
  %70 = getelementptr inbounds i8, ptr %69, i64 24
  %71 = load i64, ptr %70, align 8
  %72 = load ptr, ptr %28, align 8
  %73 = load ptr, ptr %6, align 8
  %74 = getelementptr inbounds i8, ptr %73, i64 16
  %75 = load i64, ptr %74, align 8
  tail call fastcc void @nested(ptr noundef %62, ptr noundef %66, ptr noundef %67, i64 noundef %68, i64 noundef %71, ptr noundef %72, i64 noundef %75) #7
  %76 = fmul double %61, %2
  %77 = fadd double %76, %1
  %78 = load ptr, ptr %31, align 8
  store double %77, ptr %78, align 8
  %79 = load i64, ptr %32, align 8
  %80 = icmp sgt i64 %79, 0
  br i1 %80, label %81, label %82

81:                                               ; preds = %55
  tail call fastcc void @sample(ptr noundef nonnull %6) #7
  br label %82

82:                                               ; preds = %55, %81
  %83 = load ptr, ptr %9, align 8
  %84 = load i64, ptr %83, align 8
  %85 = load ptr, ptr %33, align 8
  %86 = load ptr, ptr %27, align 8
  %87 = load ptr, ptr %34, align 8
  %88 = load ptr, ptr %35, align 8
  %89 = load ptr, ptr %15, align 8
  %90 = inttoptr i64 %84 to ptr
  %91 = tail call i32 %90(ptr noundef %85, ptr noundef %86, ptr noundef %87, ptr noundef %88, ptr noundef %89) #8
  %92 = icmp slt i32 %91, 0
  br i1 %92, label %93, label %98

93:                                               ; preds = %82
  %94 = load ptr, ptr %22, align 8
  %95 = getelementptr inbounds i8, ptr %94, i64 80
  store i64 %25, ptr %95, align 8
  %96 = load ptr, ptr %21, align 8
  %97 = getelementptr inbounds i8, ptr %96, i64 48
  store double 1.000000e+00, ptr %97, align 8
  br label %355

98:                                               ; preds = %82, %337
  %99 = phi double [ %339, %337 ], [ %58, %82 ]
  %100 = phi i64 [ %340, %337 ], [ %57, %82 ]
  br i1 %36, label %104, label %101

101:                                              ; preds = %139, %98
  %102 = phi double [ 2.000000e+00, %98 ], [ %140, %139 ]
  %103 = fcmp ogt double %102, 1.000000e+00
  br i1 %103, label %337, label %143

104:                                              ; preds = %98, %139
  %105 = phi i64 [ %141, %139 ], [ 0, %98 ]
  %106 = phi double [ %140, %139 ], [ 2.000000e+00, %98 ]
  %107 = getelementptr inbounds i64, ptr %20, i64 %105
  store i64 0, ptr %107, align 8
  %108 = getelementptr inbounds i64, ptr %18, i64 %105
  %109 = load i64, ptr %108, align 8
  %110 = getelementptr inbounds double, ptr %16, i64 %105
  %111 = load double, ptr %110, align 8
  %112 = getelementptr inbounds i64, ptr %14, i64 %105
  %113 = load i64, ptr %112, align 8
  %114 = icmp slt i64 %109, 0
  %115 = fcmp ogt double %111, 0.000000e+00
  %116 = and i1 %114, %115
  %117 = icmp sgt i64 %113, -1
  %118 = and i1 %116, %117
  br i1 %118, label %126, label %119

119:                                              ; preds = %104
  %120 = icmp sgt i64 %109, 0
  %121 = fcmp olt double %111, 0.000000e+00
  %122 = and i1 %120, %121
  br i1 %122, label %123, label %126

123:                                              ; preds = %119
  %124 = icmp slt i64 %113, 1
  %125 = zext i1 %124 to i32
  br label %126

126:                                              ; preds = %104, %119, %123
  %127 = phi i32 [ 1, %104 ], [ 0, %119 ], [ %125, %123 ]
  %128 = icmp eq i32 %127, 0
  br i1 %128, label %129, label %133

129:                                              ; preds = %126
  %130 = icmp eq i64 %109, 0
  %131 = fcmp ord double %111, 0.000000e+00
  %132 = or i1 %130, %131
  br i1 %132, label %139, label %133

133:                                              ; preds = %129, %126
  %134 = call fastcc double @locate(ptr noundef nonnull %0, ptr noundef nonnull %4, double noundef %1, double noundef %2, double noundef %99, double noundef %61, i64 noundef %105) #7
  %135 = fcmp ole double %134, %99
  %136 = zext i1 %135 to i64
  store i64 %136, ptr %107, align 8
  %137 = fcmp olt double %134, %106
  %138 = select i1 %137, double %134, double %106
  br label %139

139:                                              ; preds = %129, %133
  %140 = phi double [ %138, %133 ], [ %106, %129 ]
  %141 = add nuw nsw i64 %105, 1
  %142 = icmp eq i64 %141, %12
  br i1 %142, label %101, label %104, !llvm.loop !6

143:                                              ; preds = %101
  %144 = load ptr, ptr %27, align 8
  %145 = load ptr, ptr %28, align 8
  %146 = insertelement <8 x double> poison, double %102, i64 0
  %147 = shufflevector <8 x double> %146, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %147, ptr %145, align 8
  %148 = load ptr, ptr %8, align 8
  %149 = load ptr, ptr %29, align 8
  %150 = load i64, ptr %30, align 8
  %151 = load ptr, ptr %0, align 8
  %152 = getelementptr inbounds i8, ptr %151, i64 24
  %153 = load i64, ptr %152, align 8
  %154 = load ptr, ptr %28, align 8
  %155 = load ptr, ptr %6, align 8
  %156 = getelementptr inbounds i8, ptr %155, i64 16
  %157 = load i64, ptr %156, align 8
  tail call fastcc void @nested(ptr noundef %144, ptr noundef %148, ptr noundef %149, i64 noundef %150, i64 noundef %153, ptr noundef %154, i64 noundef %157) #7
  %158 = fmul double %102, %2
  %159 = fadd double %158, %1
  %160 = load ptr, ptr %31, align 8
  store double %159, ptr %160, align 8
  %161 = load i64, ptr %32, align 8
  %162 = icmp sgt i64 %161, 0
  br i1 %162, label %163, label %164

163:                                              ; preds = %143
  tail call fastcc void @sample(ptr noundef nonnull %6) #7
  br label %164

164:                                              ; preds = %143, %163
  %165 = load ptr, ptr %9, align 8
  %166 = load i64, ptr %165, align 8
  %167 = load ptr, ptr %33, align 8
  %168 = load ptr, ptr %27, align 8
  %169 = load ptr, ptr %34, align 8
  %170 = load ptr, ptr %35, align 8
  %171 = load ptr, ptr %15, align 8
  %172 = getelementptr inbounds i8, ptr %165, i64 8
  %173 = load i64, ptr %172, align 8
  %174 = getelementptr inbounds double, ptr %171, i64 %173
  %175 = inttoptr i64 %166 to ptr
  %176 = tail call i32 %175(ptr noundef %167, ptr noundef %168, ptr noundef %169, ptr noundef %170, ptr noundef %174) #8
  %177 = icmp slt i32 %176, 0
  br i1 %177, label %179, label %178

178:                                              ; preds = %164
  br i1 %37, label %191, label %186

179:                                              ; preds = %164
  %180 = load ptr, ptr %22, align 8
  %181 = getelementptr inbounds i8, ptr %180, i64 80
  store i64 %25, ptr %181, align 8
  %182 = load ptr, ptr %21, align 8
  %183 = getelementptr inbounds i8, ptr %182, i64 48
  store double 1.000000e+00, ptr %183, align 8
  br label %337

184:                                              ; preds = %269
  %185 = zext i1 %270 to i32
  br label %186

186:                                              ; preds = %184, %178
  %187 = phi i32 [ 0, %178 ], [ %185, %184 ]
  %188 = phi i64 [ -1, %178 ], [ %260, %184 ]
  %189 = icmp eq i32 %187, 0
  br i1 %189, label %190, label %273

190:                                              ; preds = %186
  br i1 %41, label %274, label %322

191:                                              ; preds = %178, %269
  %192 = phi i64 [ %271, %269 ], [ 0, %178 ]
  %193 = phi i64 [ %260, %269 ], [ -1, %178 ]
  %194 = phi i1 [ %270, %269 ], [ false, %178 ]
  %195 = getelementptr double, ptr %38, i64 %192
  %196 = load double, ptr %195, align 8
  %197 = getelementptr inbounds i64, ptr %18, i64 %192
  %198 = load i64, ptr %197, align 8
  %199 = getelementptr inbounds i64, ptr %14, i64 %192
  %200 = load i64, ptr %199, align 8
  %201 = icmp slt i64 %198, 0
  %202 = fcmp ogt double %196, 0.000000e+00
  %203 = and i1 %202, %201
  %204 = icmp sgt i64 %200, -1
  %205 = and i1 %203, %204
  br i1 %205, label %213, label %206

206:                                              ; preds = %191
  %207 = icmp sgt i64 %198, 0
  %208 = fcmp olt double %196, 0.000000e+00
  %209 = and i1 %208, %207
  br i1 %209, label %210, label %213

210:                                              ; preds = %206
  %211 = icmp slt i64 %200, 1
  %212 = zext i1 %211 to i32
  br label %213

213:                                              ; preds = %191, %206, %210
  %214 = phi i32 [ 1, %191 ], [ 0, %206 ], [ %212, %210 ]
  %215 = icmp eq i32 %214, 0
  br i1 %215, label %216, label %241

216:                                              ; preds = %213
  %217 = getelementptr inbounds double, ptr %16, i64 %192
  %218 = load double, ptr %217, align 8
  %219 = fcmp ogt double %218, 0.000000e+00
  %220 = and i1 %201, %219
  %221 = and i1 %204, %220
  br i1 %221, label %229, label %222

222:                                              ; preds = %216
  %223 = icmp sgt i64 %198, 0
  %224 = fcmp olt double %218, 0.000000e+00
  %225 = and i1 %223, %224
  br i1 %225, label %226, label %229

226:                                              ; preds = %222
  %227 = icmp slt i64 %200, 1
  %228 = zext i1 %227 to i32
  br label %229

229:                                              ; preds = %216, %222, %226
  %230 = phi i32 [ 1, %216 ], [ 0, %222 ], [ %228, %226 ]
  %231 = icmp eq i32 %230, 0
  br i1 %231, label %241, label %232

232:                                              ; preds = %229
  %233 = fcmp oeq double %196, 0.000000e+00
  br i1 %233, label %238, label %234

234:                                              ; preds = %232
  %235 = getelementptr inbounds i64, ptr %20, i64 %192
  %236 = load i64, ptr %235, align 8
  %237 = icmp eq i64 %236, 1
  br label %238

238:                                              ; preds = %234, %232
  %239 = phi i1 [ true, %232 ], [ %237, %234 ]
  %240 = zext i1 %239 to i32
  br label %241

241:                                              ; preds = %238, %229, %213
  %242 = phi i32 [ 1, %213 ], [ %240, %238 ], [ 0, %229 ]
  %243 = icmp eq i32 %242, 0
  br i1 %243, label %244, label %259

244:                                              ; preds = %241
  %245 = getelementptr inbounds double, ptr %16, i64 %192
  %246 = load double, ptr %245, align 8
  %247 = icmp eq i64 %198, 0
  %248 = fcmp ord double %246, 0.000000e+00
  %249 = or i1 %247, %248
  br i1 %249, label %259, label %250

250:                                              ; preds = %244
  %251 = sitofp i64 %198 to double
  %252 = fmul double %196, %251
  %253 = fcmp olt double %252, 0.000000e+00
  br i1 %253, label %254, label %256

254:                                              ; preds = %250
  %255 = sub nsw i64 0, %198
  store i64 %255, ptr %197, align 8
  br label %259

256:                                              ; preds = %250
  %257 = fcmp ueq double %196, 0.000000e+00
  %258 = select i1 %257, i64 %192, i64 %193
  br label %259

259:                                              ; preds = %256, %254, %244, %241
  %260 = phi i64 [ %193, %241 ], [ %193, %254 ], [ %193, %244 ], [ %258, %256 ]
  %261 = zext nneg i32 %242 to i64
  %262 = getelementptr inbounds i64, ptr %20, i64 %192
  store i64 %261, ptr %262, align 8
  %263 = or i1 %194, %243
  br i1 %263, label %269, label %264

264:                                              ; preds = %259
  %265 = load ptr, ptr %39, align 8
  %266 = getelementptr inbounds i64, ptr %265, i64 %192
  %267 = load i64, ptr %266, align 8
  %268 = icmp eq i64 %267, 1
  br label %269

269:                                              ; preds = %259, %264
  %270 = phi i1 [ %194, %259 ], [ %268, %264 ]
  %271 = add nuw nsw i64 %192, 1
  %272 = icmp eq i64 %271, %12
  br i1 %272, label %184, label %191, !llvm.loop !7

273:                                              ; preds = %186
  store double %102, ptr %40, align 8
  br label %337

274:                                              ; preds = %190, %318
  %275 = phi i1 [ %320, %318 ], [ %41, %190 ]
  %276 = phi i64 [ %319, %318 ], [ 0, %190 ]
  %277 = getelementptr inbounds i64, ptr %20, i64 %276
  %278 = load i64, ptr %277, align 8
  %279 = icmp eq i64 %278, 0
  br i1 %279, label %318, label %280

280:                                              ; preds = %274
  %281 = load ptr, ptr %22, align 8
  %282 = getelementptr inbounds i8, ptr %281, i64 80
  %283 = load i64, ptr %282, align 8
  %284 = load ptr, ptr %6, align 8
  %285 = getelementptr inbounds i8, ptr %284, i64 8
  %286 = load i64, ptr %285, align 8
  %287 = load i64, ptr %43, align 8
  %288 = icmp eq i64 %287, 0
  br i1 %288, label %314, label %289

289:                                              ; preds = %280
  %290 = icmp eq i64 %283, %287
  br i1 %290, label %313, label %291

291:                                              ; preds = %289
  %292 = load ptr, ptr %42, align 8
  %293 = getelementptr inbounds double, ptr %292, i64 %283
  store double %159, ptr %293, align 8
  %294 = load ptr, ptr %44, align 8
  %295 = getelementptr inbounds i64, ptr %294, i64 %283
  store i64 %276, ptr %295, align 8
  %296 = icmp sgt i64 %286, 0
  br i1 %296, label %301, label %297

297:                                              ; preds = %301, %291
  %298 = add nsw i64 %283, 1
  %299 = load ptr, ptr %22, align 8
  %300 = getelementptr inbounds i8, ptr %299, i64 80
  store i64 %298, ptr %300, align 8
  br label %314

301:                                              ; preds = %291, %301
  %302 = phi i64 [ %311, %301 ], [ 0, %291 ]
  %303 = load ptr, ptr %27, align 8
  %304 = getelementptr inbounds double, ptr %303, i64 %302
  %305 = load double, ptr %304, align 8
  %306 = load ptr, ptr %45, align 8
  %307 = load i64, ptr %46, align 8
  %308 = mul nsw i64 %307, %283
  %309 = getelementptr double, ptr %306, i64 %308
  %310 = getelementptr double, ptr %309, i64 %302
  store double %305, ptr %310, align 8
  %311 = add nuw nsw i64 %302, 1
  %312 = icmp eq i64 %311, %286
  br i1 %312, label %297, label %301, !llvm.loop !8

313:                                              ; preds = %289
  store double %102, ptr %47, align 8
  br label %322

314:                                              ; preds = %297, %280
  %315 = getelementptr inbounds i64, ptr %18, i64 %276
  %316 = load i64, ptr %315, align 8
  %317 = sub nsw i64 0, %316
  store i64 %317, ptr %315, align 8
  br label %318

318:                                              ; preds = %274, %314
  %319 = add nuw nsw i64 %276, 1
  %320 = icmp slt i64 %319, %12
  %321 = icmp eq i64 %319, %12
  br i1 %321, label %322, label %274, !llvm.loop !9

322:                                              ; preds = %318, %190, %313
  %323 = phi i1 [ %275, %313 ], [ %41, %190 ], [ %320, %318 ]
  %324 = phi i32 [ 1, %313 ], [ 13, %190 ], [ 13, %318 ]
  %325 = phi i64 [ -3, %313 ], [ %100, %190 ], [ %100, %318 ]
  br i1 %323, label %337, label %326

326:                                              ; preds = %322
  %327 = icmp sgt i64 %188, -1
  br i1 %327, label %328, label %337

328:                                              ; preds = %326
  br i1 %48, label %330, label %329

329:                                              ; preds = %330, %328
  store double %102, ptr %49, align 8
  br label %337

330:                                              ; preds = %328, %330
  %331 = phi i64 [ %335, %330 ], [ 0, %328 ]
  %332 = icmp eq i64 %331, %188
  %333 = zext i1 %332 to i64
  %334 = getelementptr inbounds i64, ptr %20, i64 %331
  store i64 %333, ptr %334, align 8
  %335 = add nuw nsw i64 %331, 1
  %336 = icmp eq i64 %335, %12
  br i1 %336, label %329, label %330, !llvm.loop !10

337:                                              ; preds = %273, %329, %322, %326, %101, %179
  %338 = phi i32 [ 1, %179 ], [ 5, %101 ], [ 1, %273 ], [ 1, %329 ], [ %324, %322 ], [ 0, %326 ]
  %339 = phi double [ %99, %179 ], [ %99, %101 ], [ %99, %273 ], [ %99, %329 ], [ %99, %322 ], [ %102, %326 ]
  %340 = phi i64 [ -4, %179 ], [ %100, %101 ], [ -2, %273 ], [ 21, %329 ], [ %325, %322 ], [ %325, %326 ]
  switch i32 %338, label %355 [
    i32 0, label %98
    i32 5, label %341
  ], !llvm.loop !11

341:                                              ; preds = %337
  br i1 %50, label %342, label %355

342:                                              ; preds = %341, %352
  %343 = phi i64 [ %353, %352 ], [ 0, %341 ]
  %344 = getelementptr inbounds double, ptr %16, i64 %343
  %345 = load double, ptr %344, align 8
  %346 = fcmp ogt double %345, 0.000000e+00
  br i1 %346, label %349, label %347

347:                                              ; preds = %342
  %348 = fcmp olt double %345, 0.000000e+00
  br i1 %348, label %349, label %352

349:                                              ; preds = %347, %342
  %350 = phi i64 [ 1, %342 ], [ -1, %347 ]
  %351 = getelementptr inbounds i64, ptr %18, i64 %343
  store i64 %350, ptr %351, align 8
  br label %352

352:                                              ; preds = %349, %347
  %353 = add nuw nsw i64 %343, 1
  %354 = icmp eq i64 %353, %12
  br i1 %354, label %355, label %342, !llvm.loop !12

355:                                              ; preds = %337, %352, %341, %93
  %356 = phi i32 [ 1, %93 ], [ 0, %341 ], [ 0, %352 ], [ %338, %337 ]
  %357 = phi double [ %58, %93 ], [ %61, %341 ], [ %61, %352 ], [ %339, %337 ]
  %358 = phi i64 [ -4, %93 ], [ %340, %341 ], [ %340, %352 ], [ %340, %337 ]
  %359 = icmp eq i32 %356, 0
  br i1 %359, label %51, label %360

360:                                              ; preds = %51, %355
  %361 = phi i1 [ %53, %51 ], [ %56, %355 ]
  br i1 %361, label %362, label %364

362:                                              ; preds = %360
  %363 = getelementptr inbounds i8, ptr %26, i64 48
  store double 1.000000e+00, ptr %363, align 8
  br label %364

364:                                              ; preds = %360, %362
  %365 = phi i64 [ 0, %362 ], [ %358, %360 ]
  ret i64 %365
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
  br i1 %128, label %129, label %79, !llvm.loop !13

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
  br i1 %31, label %20, label %19, !llvm.loop !14

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
  br i1 %43, label %32, label %24, !llvm.loop !15
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
  br i1 %55, label %44, label %56, !llvm.loop !16

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
  br i1 %83, label %13, label %12, !llvm.loop !17
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
!11 = distinct !{!11, !5}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !5}
!14 = distinct !{!14, !4, !5}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5}
!17 = distinct !{!17, !4, !5}
