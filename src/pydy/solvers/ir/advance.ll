; sources 83a95e624712bc53d2888bab34ca475a5780e7200c9e7e6238c0189896e8813c
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define i64 @advance(ptr noundef %0, ptr noundef %1, i64 noundef %2) #0 {
  %4 = alloca [1 x double], align 8
  %5 = alloca [1 x double], align 8
  %6 = alloca [1 x double], align 8
  %7 = icmp eq i64 %2, 1
  br i1 %7, label %8, label %72

8:                                                ; preds = %3
  %9 = getelementptr inbounds i8, ptr %0, i64 144
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %10, i64 8
  %12 = load i64, ptr %11, align 8
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %14, label %16

14:                                               ; preds = %8
  %15 = getelementptr inbounds i8, ptr %0, i64 312
  br label %23

16:                                               ; preds = %23, %8
  %17 = getelementptr inbounds i8, ptr %0, i64 584
  %18 = load i64, ptr %17, align 8
  %19 = icmp sgt i64 %18, 0
  br i1 %19, label %20, label %34

20:                                               ; preds = %16
  %21 = getelementptr inbounds i8, ptr %0, i64 576
  %22 = getelementptr inbounds i8, ptr %0, i64 1056
  br label %41

23:                                               ; preds = %14, %23
  %24 = phi i64 [ 0, %14 ], [ %29, %23 ]
  %25 = getelementptr inbounds double, ptr %1, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = load ptr, ptr %15, align 8
  %28 = getelementptr inbounds double, ptr %27, i64 %24
  store double %26, ptr %28, align 8
  %29 = add nuw nsw i64 %24, 1
  %30 = load ptr, ptr %9, align 8
  %31 = getelementptr inbounds i8, ptr %30, i64 8
  %32 = load i64, ptr %31, align 8
  %33 = icmp slt i64 %29, %32
  br i1 %33, label %23, label %16, !llvm.loop !3

34:                                               ; preds = %41, %16
  %35 = getelementptr inbounds i8, ptr %0, i64 608
  %36 = load i64, ptr %35, align 8
  %37 = icmp sgt i64 %36, 0
  br i1 %37, label %38, label %51

38:                                               ; preds = %34
  %39 = getelementptr inbounds i8, ptr %0, i64 600
  %40 = getelementptr inbounds i8, ptr %0, i64 1080
  br label %57

41:                                               ; preds = %20, %41
  %42 = phi i64 [ 0, %20 ], [ %48, %41 ]
  %43 = load ptr, ptr %22, align 8
  %44 = getelementptr inbounds double, ptr %43, i64 %42
  %45 = load double, ptr %44, align 8
  %46 = load ptr, ptr %21, align 8
  %47 = getelementptr inbounds double, ptr %46, i64 %42
  store double %45, ptr %47, align 8
  %48 = add nuw nsw i64 %42, 1
  %49 = load i64, ptr %17, align 8
  %50 = icmp slt i64 %48, %49
  br i1 %50, label %41, label %34, !llvm.loop !6

51:                                               ; preds = %57, %34
  %52 = getelementptr inbounds i8, ptr %0, i64 720
  %53 = load ptr, ptr %52, align 8
  %54 = getelementptr inbounds i8, ptr %53, i64 8
  %55 = load i64, ptr %54, align 8
  %56 = icmp sgt i64 %55, 0
  br i1 %56, label %67, label %72

57:                                               ; preds = %38, %57
  %58 = phi i64 [ 0, %38 ], [ %64, %57 ]
  %59 = load ptr, ptr %40, align 8
  %60 = getelementptr inbounds i64, ptr %59, i64 %58
  %61 = load i64, ptr %60, align 8
  %62 = load ptr, ptr %39, align 8
  %63 = getelementptr inbounds i64, ptr %62, i64 %58
  store i64 %61, ptr %63, align 8
  %64 = add nuw nsw i64 %58, 1
  %65 = load i64, ptr %35, align 8
  %66 = icmp slt i64 %64, %65
  br i1 %66, label %57, label %51, !llvm.loop !7

67:                                               ; preds = %51
  %68 = getelementptr inbounds i8, ptr %0, i64 912
  %69 = load ptr, ptr %68, align 8
  %70 = mul i64 %55, 88
  %71 = getelementptr inbounds i8, ptr %69, i64 %70
  store double 0x7FF8000000000000, ptr %71, align 8
  br label %72

72:                                               ; preds = %67, %51, %3
  %73 = getelementptr inbounds i8, ptr %0, i64 144
  %74 = getelementptr inbounds i8, ptr %0, i64 312
  %75 = getelementptr inbounds i8, ptr %0, i64 576
  %76 = load ptr, ptr %75, align 8
  %77 = getelementptr inbounds i8, ptr %0, i64 336
  %78 = load ptr, ptr %77, align 8
  %79 = getelementptr inbounds i8, ptr %0, i64 600
  %80 = load ptr, ptr %79, align 8
  %81 = getelementptr inbounds i8, ptr %80, i64 56
  %82 = load i64, ptr %81, align 8
  %83 = icmp eq i64 %82, 0
  br i1 %83, label %1636, label %84

84:                                               ; preds = %72
  %85 = getelementptr inbounds i8, ptr %0, i64 624
  %86 = load ptr, ptr %85, align 8
  %87 = getelementptr inbounds i8, ptr %0, i64 120
  %88 = load ptr, ptr %87, align 8
  %89 = load ptr, ptr %0, align 8
  %90 = getelementptr inbounds i8, ptr %0, i64 320
  %91 = load i64, ptr %90, align 8
  %92 = getelementptr inbounds i8, ptr %0, i64 648
  %93 = load ptr, ptr %92, align 8
  %94 = load i64, ptr %93, align 8
  %95 = icmp ne i64 %94, 1
  %96 = getelementptr inbounds i8, ptr %89, i64 8
  %97 = load i64, ptr %96, align 8
  %98 = icmp slt i64 %97, 1
  %99 = getelementptr inbounds i8, ptr %89, i64 32
  %100 = load i64, ptr %99, align 8
  %101 = icmp eq i64 %100, 1
  %102 = getelementptr inbounds i8, ptr %0, i64 720
  %103 = load ptr, ptr %102, align 8
  %104 = getelementptr inbounds i8, ptr %103, i64 8
  %105 = load i64, ptr %104, align 8
  %106 = icmp sgt i64 %105, 0
  %107 = getelementptr inbounds i8, ptr %0, i64 632
  %108 = load i64, ptr %107, align 8
  %109 = getelementptr double, ptr %86, i64 %108
  %110 = getelementptr i8, ptr %109, i64 -8
  %111 = load double, ptr %110, align 8
  %112 = getelementptr inbounds i8, ptr %0, i64 480
  %113 = load ptr, ptr %112, align 8
  %114 = load i64, ptr %89, align 8
  %115 = mul nsw i64 %114, %91
  %116 = getelementptr inbounds double, ptr %113, i64 %115
  %117 = load double, ptr %76, align 8
  %118 = getelementptr inbounds i8, ptr %76, i64 8
  %119 = load double, ptr %118, align 8
  %120 = load i64, ptr %80, align 8
  %121 = icmp eq i64 %120, 0
  br i1 %121, label %122, label %345

122:                                              ; preds = %84
  %123 = getelementptr inbounds i8, ptr %80, i64 24
  %124 = load i64, ptr %123, align 8
  %125 = add nsw i64 %124, 1
  store i64 %125, ptr %123, align 8
  %126 = load ptr, ptr %74, align 8
  %127 = load ptr, ptr %112, align 8
  %128 = getelementptr inbounds i8, ptr %0, i64 168
  %129 = load ptr, ptr %128, align 8
  store double %117, ptr %129, align 8
  %130 = getelementptr inbounds i8, ptr %0, i64 248
  %131 = load i64, ptr %130, align 8
  %132 = icmp sgt i64 %131, 0
  br i1 %132, label %133, label %134

133:                                              ; preds = %122
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %134

134:                                              ; preds = %122, %133
  %135 = load ptr, ptr %73, align 8
  %136 = load i64, ptr %135, align 8
  %137 = load ptr, ptr %128, align 8
  %138 = getelementptr inbounds i8, ptr %0, i64 192
  %139 = load ptr, ptr %138, align 8
  %140 = getelementptr inbounds i8, ptr %0, i64 216
  %141 = load ptr, ptr %140, align 8
  %142 = inttoptr i64 %136 to ptr
  %143 = tail call i32 %142(ptr noundef %137, ptr noundef %126, ptr noundef %139, ptr noundef %141, ptr noundef %127) #9
  %144 = icmp eq i32 %143, 0
  br i1 %144, label %149, label %145

145:                                              ; preds = %134
  %146 = getelementptr inbounds i8, ptr %80, i64 72
  store i64 3, ptr %146, align 8
  %147 = icmp slt i32 %143, 0
  %148 = select i1 %147, i64 -4, i64 2
  br label %1636

149:                                              ; preds = %134
  store i64 1, ptr %80, align 8
  %150 = getelementptr inbounds i8, ptr %76, i64 24
  store double 1.000000e-04, ptr %150, align 8
  %151 = getelementptr inbounds i8, ptr %88, i64 40
  %152 = load double, ptr %151, align 8
  %153 = getelementptr inbounds i8, ptr %76, i64 40
  store double %152, ptr %153, align 8
  %154 = load ptr, ptr %74, align 8
  %155 = load ptr, ptr %73, align 8
  %156 = getelementptr inbounds i8, ptr %155, i64 8
  %157 = load i64, ptr %156, align 8
  %158 = load i64, ptr %107, align 8
  %159 = load ptr, ptr %85, align 8
  %160 = load ptr, ptr %79, align 8
  %161 = getelementptr inbounds i8, ptr %160, i64 48
  %162 = load i64, ptr %161, align 8
  %163 = icmp slt i64 %162, %158
  br i1 %163, label %164, label %187

164:                                              ; preds = %149
  %165 = icmp sgt i64 %157, 0
  br label %166

166:                                              ; preds = %164, %177
  %167 = phi i64 [ %162, %164 ], [ %178, %177 ]
  %168 = getelementptr inbounds double, ptr %159, i64 %167
  %169 = load double, ptr %168, align 8
  %170 = load ptr, ptr %75, align 8
  %171 = load double, ptr %170, align 8
  %172 = fcmp ugt double %169, %171
  br i1 %172, label %187, label %173

173:                                              ; preds = %166
  br i1 %165, label %174, label %177

174:                                              ; preds = %173
  %175 = mul nsw i64 %167, %157
  %176 = getelementptr double, ptr %1, i64 %175
  br label %180

177:                                              ; preds = %180, %173
  %178 = add i64 %167, 1
  %179 = icmp eq i64 %178, %158
  br i1 %179, label %187, label %166, !llvm.loop !8

180:                                              ; preds = %174, %180
  %181 = phi i64 [ 0, %174 ], [ %185, %180 ]
  %182 = getelementptr inbounds double, ptr %154, i64 %181
  %183 = load double, ptr %182, align 8
  %184 = getelementptr double, ptr %176, i64 %181
  store double %183, ptr %184, align 8
  %185 = add nuw nsw i64 %181, 1
  %186 = icmp eq i64 %185, %157
  br i1 %186, label %177, label %180, !llvm.loop !9

187:                                              ; preds = %166, %177, %149
  %188 = phi i64 [ %162, %149 ], [ %167, %166 ], [ %158, %177 ]
  %189 = load ptr, ptr %79, align 8
  %190 = getelementptr inbounds i8, ptr %189, i64 48
  store i64 %188, ptr %190, align 8
  %191 = icmp eq i64 %188, %158
  br i1 %191, label %1636, label %192

192:                                              ; preds = %187
  %193 = fcmp oeq double %119, 0.000000e+00
  br i1 %193, label %194, label %345

194:                                              ; preds = %192
  %195 = load ptr, ptr %73, align 8
  %196 = getelementptr inbounds i8, ptr %195, i64 24
  %197 = load i64, ptr %196, align 8
  %198 = load ptr, ptr %75, align 8
  %199 = getelementptr inbounds i8, ptr %198, i64 16
  %200 = load double, ptr %199, align 8
  %201 = load ptr, ptr %74, align 8
  call fastcc void @norm_to(ptr noundef nonnull %4, ptr noundef %201, ptr noundef %201, ptr noundef nonnull %74, i64 noundef %197) #8
  %202 = load double, ptr %4, align 8
  %203 = getelementptr inbounds i8, ptr %0, i64 480
  %204 = load ptr, ptr %203, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %204, ptr noundef %201, ptr noundef nonnull %74, i64 noundef %197) #8
  %205 = load double, ptr %5, align 8
  %206 = fcmp uge double %202, 1.000000e-05
  %207 = fcmp uge double %205, 1.000000e-05
  %208 = and i1 %206, %207
  %209 = fmul double %202, 1.000000e-02
  %210 = fdiv double %209, %205
  %211 = select i1 %208, double %210, double 0x3EB0C6F7A0B5ED8D
  %212 = fcmp olt double %200, %211
  %213 = select i1 %212, double %200, double %211
  %214 = load ptr, ptr %73, align 8
  %215 = getelementptr inbounds i8, ptr %214, i64 8
  %216 = load i64, ptr %215, align 8
  %217 = icmp sgt i64 %216, 0
  br i1 %217, label %218, label %220

218:                                              ; preds = %194
  %219 = getelementptr inbounds i8, ptr %0, i64 360
  br label %244

220:                                              ; preds = %244, %194
  %221 = load ptr, ptr %79, align 8
  %222 = getelementptr inbounds i8, ptr %221, i64 24
  %223 = load i64, ptr %222, align 8
  %224 = add nsw i64 %223, 1
  store i64 %224, ptr %222, align 8
  %225 = fadd double %117, %213
  %226 = getelementptr inbounds i8, ptr %0, i64 360
  %227 = load ptr, ptr %226, align 8
  %228 = load ptr, ptr %112, align 8
  %229 = load i64, ptr %90, align 8
  %230 = getelementptr inbounds double, ptr %228, i64 %229
  %231 = load ptr, ptr %128, align 8
  store double %225, ptr %231, align 8
  %232 = load i64, ptr %130, align 8
  %233 = icmp sgt i64 %232, 0
  br i1 %233, label %234, label %235

234:                                              ; preds = %220
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %235

235:                                              ; preds = %220, %234
  %236 = load ptr, ptr %73, align 8
  %237 = load i64, ptr %236, align 8
  %238 = load ptr, ptr %128, align 8
  %239 = load ptr, ptr %138, align 8
  %240 = load ptr, ptr %140, align 8
  %241 = inttoptr i64 %237 to ptr
  %242 = tail call i32 %241(ptr noundef %238, ptr noundef %227, ptr noundef %239, ptr noundef %240, ptr noundef %230) #9
  %243 = icmp eq i32 %242, 0
  br i1 %243, label %263, label %261

244:                                              ; preds = %218, %244
  %245 = phi i64 [ 0, %218 ], [ %256, %244 ]
  %246 = load ptr, ptr %74, align 8
  %247 = getelementptr inbounds double, ptr %246, i64 %245
  %248 = load double, ptr %247, align 8
  %249 = load ptr, ptr %112, align 8
  %250 = getelementptr inbounds double, ptr %249, i64 %245
  %251 = load double, ptr %250, align 8
  %252 = fmul double %213, %251
  %253 = fadd double %248, %252
  %254 = load ptr, ptr %219, align 8
  %255 = getelementptr inbounds double, ptr %254, i64 %245
  store double %253, ptr %255, align 8
  %256 = add nuw nsw i64 %245, 1
  %257 = load ptr, ptr %73, align 8
  %258 = getelementptr inbounds i8, ptr %257, i64 8
  %259 = load i64, ptr %258, align 8
  %260 = icmp slt i64 %256, %259
  br i1 %260, label %244, label %220, !llvm.loop !10

261:                                              ; preds = %235
  %262 = fmul double %213, 1.000000e-03
  br label %340

263:                                              ; preds = %235
  %264 = load ptr, ptr %87, align 8
  %265 = load double, ptr %264, align 8
  %266 = load ptr, ptr %203, align 8
  %267 = getelementptr inbounds i8, ptr %0, i64 320
  %268 = load i64, ptr %267, align 8
  %269 = getelementptr inbounds double, ptr %266, i64 %268
  %270 = icmp sgt i64 %197, 0
  br i1 %270, label %271, label %280

271:                                              ; preds = %263, %271
  %272 = phi i64 [ %278, %271 ], [ 0, %263 ]
  %273 = getelementptr inbounds double, ptr %269, i64 %272
  %274 = load double, ptr %273, align 8
  %275 = getelementptr inbounds double, ptr %266, i64 %272
  %276 = load double, ptr %275, align 8
  %277 = fsub double %274, %276
  store double %277, ptr %273, align 8
  %278 = add nuw nsw i64 %272, 1
  %279 = icmp eq i64 %278, %197
  br i1 %279, label %280, label %271, !llvm.loop !11

280:                                              ; preds = %271, %263
  %281 = load ptr, ptr %74, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %269, ptr noundef %281, ptr noundef nonnull %74, i64 noundef %197) #8
  %282 = load double, ptr %6, align 8
  %283 = fdiv double %282, %213
  %284 = fcmp ogt double %205, %283
  %285 = select i1 %284, double %205, double %283
  %286 = fcmp ule double %285, 1.000000e-15
  %287 = fdiv double 1.000000e-02, %285
  %288 = select i1 %286, double 1.000000e+13, double %287
  %289 = bitcast double %288 to i64
  %290 = add nsw i64 %289, -4604544271217802189
  %291 = ashr i64 %290, 52
  %292 = and i64 %290, -4503599627370496
  %293 = sub nsw i64 %289, %292
  %294 = bitcast i64 %293 to double
  %295 = fadd double %294, -1.000000e+00
  %296 = fadd double %294, 1.000000e+00
  %297 = fdiv double %295, %296
  %298 = fmul double %297, %297
  %299 = tail call double @llvm.fma.f64(double %298, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %300 = tail call double @llvm.fma.f64(double %299, double %298, double 0x3FE2776C50EF9BFE)
  %301 = tail call double @llvm.fma.f64(double %300, double %298, double 0x3FEEC709DC3A03FD)
  %302 = tail call double @llvm.fma.f64(double %301, double %298, double 0x40071547652B82FE)
  %303 = trunc nsw i64 %291 to i32
  %304 = sitofp i32 %303 to double
  %305 = fmul double %297, %302
  %306 = fadd double %305, %304
  %307 = fmul double %265, %306
  %308 = fcmp ogt double %307, -1.000000e+03
  %309 = select i1 %308, double %307, double -1.000000e+03
  %310 = fcmp olt double %309, 1.000000e+03
  %311 = select i1 %310, double %309, double 1.000000e+03
  %312 = tail call double @llvm.rint.f64(double %311)
  %313 = fsub double %311, %312
  %314 = tail call double @llvm.fma.f64(double %313, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %315 = tail call double @llvm.fma.f64(double %314, double %313, double 0x3F55D87FE78A6730)
  %316 = tail call double @llvm.fma.f64(double %315, double %313, double 0x3F83B2AB6FBA4E77)
  %317 = tail call double @llvm.fma.f64(double %316, double %313, double 0x3FAC6B08D704A0BF)
  %318 = tail call double @llvm.fma.f64(double %317, double %313, double 0x3FCEBFBDFF82C58E)
  %319 = tail call double @llvm.fma.f64(double %318, double %313, double 0x3FE62E42FEFA39EF)
  %320 = tail call double @llvm.fma.f64(double %319, double %313, double 1.000000e+00)
  %321 = bitcast double %320 to i64
  %322 = fptosi double %312 to i32
  %323 = sext i32 %322 to i64
  %324 = shl nsw i64 %323, 52
  %325 = add nsw i64 %324, %321
  %326 = bitcast i64 %325 to double
  %327 = fmul double %213, 1.000000e-03
  %328 = fcmp olt double %327, 0x3EB0C6F7A0B5ED8D
  %329 = select i1 %328, double 0x3EB0C6F7A0B5ED8D, double %327
  %330 = fmul double %213, 1.000000e+02
  %331 = select i1 %286, double %329, double %326
  %332 = fcmp olt double %330, %331
  %333 = select i1 %332, double %330, double %331
  %334 = tail call double @llvm.fabs.f64(double %117)
  %335 = fmul double %334, 0x3D30000000000000
  %336 = fcmp ogt double %335, %333
  %337 = select i1 %336, double %335, double %333
  %338 = fcmp olt double %200, %337
  %339 = select i1 %338, double %200, double %337
  br label %340

340:                                              ; preds = %261, %280
  %341 = phi double [ %262, %261 ], [ %339, %280 ]
  %342 = tail call i1 @llvm.is.fpclass.f64(double %341, i32 639)
  br i1 %342, label %343, label %345

343:                                              ; preds = %340
  %344 = getelementptr inbounds i8, ptr %80, i64 72
  store i64 4, ptr %344, align 8
  br label %345

345:                                              ; preds = %192, %343, %340, %84
  %346 = phi double [ %341, %340 ], [ %341, %343 ], [ %119, %192 ], [ %119, %84 ]
  %347 = load i64, ptr %81, align 8
  %348 = icmp eq i64 %347, 0
  br i1 %348, label %445, label %349

349:                                              ; preds = %345
  %350 = getelementptr inbounds i8, ptr %0, i64 1104
  %351 = getelementptr inbounds i8, ptr %80, i64 8
  %352 = getelementptr inbounds i8, ptr %80, i64 16
  %353 = getelementptr inbounds i8, ptr %80, i64 64
  %354 = getelementptr inbounds i8, ptr %80, i64 48
  %355 = getelementptr inbounds i8, ptr %76, i64 16
  %356 = getelementptr inbounds i8, ptr %80, i64 24
  %357 = getelementptr inbounds i8, ptr %0, i64 384
  %358 = getelementptr inbounds i8, ptr %0, i64 360
  %359 = getelementptr inbounds i8, ptr %0, i64 24
  %360 = getelementptr inbounds i8, ptr %0, i64 480
  %361 = getelementptr inbounds i8, ptr %0, i64 48
  %362 = getelementptr inbounds i8, ptr %0, i64 72
  %363 = getelementptr inbounds i8, ptr %0, i64 320
  %364 = getelementptr inbounds i8, ptr %0, i64 96
  %365 = getelementptr inbounds i8, ptr %0, i64 168
  %366 = getelementptr inbounds i8, ptr %0, i64 248
  %367 = getelementptr inbounds i8, ptr %0, i64 192
  %368 = getelementptr inbounds i8, ptr %0, i64 216
  %369 = getelementptr inbounds i8, ptr %0, i64 336
  %370 = getelementptr inbounds i8, ptr %0, i64 24
  %371 = getelementptr inbounds i8, ptr %0, i64 480
  %372 = getelementptr inbounds i8, ptr %0, i64 48
  %373 = getelementptr inbounds i8, ptr %0, i64 72
  %374 = getelementptr inbounds i8, ptr %0, i64 168
  %375 = getelementptr inbounds i8, ptr %0, i64 248
  %376 = getelementptr inbounds i8, ptr %0, i64 192
  %377 = getelementptr inbounds i8, ptr %0, i64 216
  %378 = getelementptr inbounds i8, ptr %0, i64 456
  %379 = getelementptr inbounds i8, ptr %0, i64 320
  %380 = getelementptr inbounds i8, ptr %0, i64 432
  %381 = getelementptr inbounds i8, ptr %0, i64 24
  %382 = getelementptr inbounds i8, ptr %0, i64 480
  %383 = getelementptr inbounds i8, ptr %0, i64 48
  %384 = getelementptr inbounds i8, ptr %0, i64 72
  %385 = getelementptr inbounds i8, ptr %0, i64 336
  %386 = getelementptr inbounds i8, ptr %0, i64 552
  %387 = getelementptr inbounds i8, ptr %0, i64 528
  %388 = getelementptr inbounds i8, ptr %0, i64 336
  %389 = icmp sgt i64 %91, 0
  %390 = select i1 %95, i1 %101, i1 false
  %391 = getelementptr inbounds i8, ptr %0, i64 168
  %392 = getelementptr inbounds i8, ptr %0, i64 248
  %393 = getelementptr inbounds i8, ptr %0, i64 192
  %394 = getelementptr inbounds i8, ptr %0, i64 216
  %395 = getelementptr inbounds i8, ptr %76, i64 32
  %396 = getelementptr inbounds i8, ptr %0, i64 1128
  %397 = getelementptr inbounds i8, ptr %0, i64 1144
  %398 = getelementptr inbounds i8, ptr %0, i64 840
  %399 = getelementptr inbounds i8, ptr %0, i64 856
  %400 = getelementptr inbounds i8, ptr %0, i64 912
  %401 = getelementptr inbounds i8, ptr %0, i64 848
  %402 = getelementptr inbounds i8, ptr %0, i64 168
  %403 = getelementptr inbounds i8, ptr %0, i64 248
  %404 = getelementptr inbounds i8, ptr %0, i64 168
  %405 = getelementptr inbounds i8, ptr %0, i64 192
  %406 = getelementptr inbounds i8, ptr %0, i64 744
  %407 = getelementptr inbounds i8, ptr %0, i64 864
  %408 = getelementptr inbounds i8, ptr %80, i64 48
  %409 = getelementptr inbounds i8, ptr %0, i64 320
  %410 = getelementptr inbounds i8, ptr %0, i64 480
  %411 = getelementptr inbounds i8, ptr %0, i64 504
  %412 = getelementptr inbounds i8, ptr %0, i64 360
  %413 = getelementptr inbounds i8, ptr %0, i64 24
  %414 = getelementptr inbounds i8, ptr %0, i64 48
  %415 = getelementptr inbounds i8, ptr %0, i64 72
  %416 = getelementptr inbounds i8, ptr %0, i64 96
  %417 = getelementptr inbounds i8, ptr %0, i64 168
  %418 = getelementptr inbounds i8, ptr %0, i64 248
  %419 = getelementptr inbounds i8, ptr %0, i64 192
  %420 = getelementptr inbounds i8, ptr %0, i64 216
  %421 = getelementptr inbounds i8, ptr %0, i64 336
  %422 = getelementptr inbounds i8, ptr %0, i64 432
  %423 = getelementptr inbounds i8, ptr %0, i64 24
  %424 = getelementptr inbounds i8, ptr %0, i64 48
  %425 = getelementptr inbounds i8, ptr %0, i64 72
  %426 = getelementptr inbounds i8, ptr %80, i64 72
  %427 = getelementptr inbounds i8, ptr %0, i64 408
  %428 = getelementptr inbounds i8, ptr %0, i64 360
  %429 = getelementptr inbounds i8, ptr %0, i64 408
  %430 = getelementptr inbounds i8, ptr %76, i64 24
  %431 = getelementptr inbounds i8, ptr %76, i64 40
  %432 = getelementptr inbounds i8, ptr %88, i64 24
  %433 = getelementptr inbounds i8, ptr %88, i64 8
  %434 = getelementptr inbounds i8, ptr %88, i64 16
  %435 = getelementptr inbounds i8, ptr %88, i64 32
  %436 = getelementptr inbounds i8, ptr %88, i64 40
  %437 = icmp sgt i64 %91, 0
  %438 = getelementptr inbounds i8, ptr %80, i64 48
  %439 = getelementptr inbounds i8, ptr %80, i64 72
  %440 = getelementptr inbounds i8, ptr %76, i64 40
  %441 = getelementptr inbounds i8, ptr %80, i64 72
  %442 = getelementptr inbounds i8, ptr %88, i64 24
  %443 = getelementptr inbounds i8, ptr %88, i64 32
  %444 = getelementptr inbounds i8, ptr %76, i64 40
  br label %447

445:                                              ; preds = %1633, %345
  %446 = phi double [ %346, %345 ], [ %1629, %1633 ]
  store double %446, ptr %118, align 8
  br label %1636

447:                                              ; preds = %349, %1633
  %448 = phi i64 [ %347, %349 ], [ %1634, %1633 ]
  %449 = phi i64 [ undef, %349 ], [ %1632, %1633 ]
  %450 = phi double [ %117, %349 ], [ %1630, %1633 ]
  %451 = phi double [ %346, %349 ], [ %1629, %1633 ]
  %452 = load ptr, ptr %350, align 8
  %453 = getelementptr inbounds i8, ptr %452, i64 8
  %454 = load i64, ptr %453, align 8
  %455 = icmp sgt i64 %454, 0
  br i1 %455, label %456, label %461

456:                                              ; preds = %447
  %457 = load i64, ptr %452, align 8
  %458 = add nsw i64 %457, 3
  %459 = icmp slt i64 %454, %458
  %460 = zext i1 %459 to i32
  br label %461

461:                                              ; preds = %447, %456
  %462 = phi i32 [ 0, %447 ], [ %460, %456 ]
  %463 = icmp eq i32 %462, 0
  br i1 %463, label %465, label %464

464:                                              ; preds = %461
  store double %451, ptr %118, align 8
  br label %1636

465:                                              ; preds = %461
  %466 = add nsw i64 %448, -1
  store i64 %466, ptr %81, align 8
  %467 = load i64, ptr %351, align 8
  %468 = load i64, ptr %352, align 8
  %469 = add nsw i64 %468, %467
  %470 = load i64, ptr %353, align 8
  %471 = icmp slt i64 %469, %470
  br i1 %471, label %473, label %472

472:                                              ; preds = %465
  store double %451, ptr %118, align 8
  br label %1636

473:                                              ; preds = %465
  br i1 %98, label %474, label %478

474:                                              ; preds = %473
  %475 = load i64, ptr %354, align 8
  %476 = getelementptr inbounds double, ptr %86, i64 %475
  %477 = load double, ptr %476, align 8
  br label %478

478:                                              ; preds = %473, %474
  %479 = phi double [ %477, %474 ], [ %111, %473 ]
  br i1 %98, label %484, label %480

480:                                              ; preds = %478
  %481 = load double, ptr %355, align 8
  %482 = fcmp olt double %451, %481
  %483 = select i1 %482, double %451, double %481
  br label %490

484:                                              ; preds = %478
  %485 = fsub double %479, %450
  %486 = fdiv double %485, %451
  %487 = fmul double %486, 0x3FEFFFFFFFFFDCD1
  %488 = tail call double @llvm.ceil.f64(double %487)
  %489 = fdiv double %485, %488
  br label %490

490:                                              ; preds = %484, %480
  %491 = phi double [ %483, %480 ], [ %489, %484 ]
  %492 = fadd double %450, %491
  %493 = fmul double %491, 1.000000e-03
  %494 = fsub double %479, %493
  %495 = fcmp ule double %492, %494
  %496 = fsub double %479, %450
  %497 = select i1 %495, double %491, double %496
  %498 = select i1 %495, double %492, double %479
  %499 = fmul double %497, 6.250000e-02
  %500 = fadd double %450, %499
  %501 = fcmp ule double %500, %450
  %502 = fcmp une double %498, %479
  %503 = and i1 %502, %501
  br i1 %503, label %504, label %505

504:                                              ; preds = %490
  store double %497, ptr %118, align 8
  br label %1628

505:                                              ; preds = %490
  %506 = load ptr, ptr %0, align 8
  %507 = load i64, ptr %506, align 8
  %508 = load ptr, ptr %357, align 8
  %509 = insertelement <8 x double> poison, double %497, i64 0
  %510 = shufflevector <8 x double> %509, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %510, ptr %508, align 8
  %511 = icmp sgt i64 %507, 1
  br i1 %511, label %516, label %600

512:                                              ; preds = %589
  %513 = add nuw nsw i64 %519, 1
  %514 = icmp slt i64 %513, %507
  %515 = icmp eq i64 %513, %507
  br i1 %515, label %600, label %516, !llvm.loop !12

516:                                              ; preds = %505, %512
  %517 = phi i1 [ %514, %512 ], [ %511, %505 ]
  %518 = phi i64 [ %599, %512 ], [ undef, %505 ]
  %519 = phi i64 [ %513, %512 ], [ 1, %505 ]
  %520 = load ptr, ptr %358, align 8
  %521 = load ptr, ptr %74, align 8
  %522 = load ptr, ptr %73, align 8
  %523 = getelementptr inbounds i8, ptr %522, i64 16
  %524 = load i64, ptr %523, align 8
  %525 = icmp sgt i64 %524, 1
  %526 = zext i1 %525 to i64
  %527 = load ptr, ptr %359, align 8
  %528 = getelementptr inbounds i64, ptr %527, i64 %519
  %529 = load i64, ptr %528, align 8
  %530 = getelementptr i8, ptr %528, i64 8
  %531 = load i64, ptr %530, align 8
  %532 = xor i64 %529, -1
  %533 = add i64 %531, %532
  %534 = load ptr, ptr %357, align 8
  %535 = load ptr, ptr %360, align 8
  %536 = load ptr, ptr %361, align 8
  %537 = getelementptr inbounds i64, ptr %536, i64 %529
  %538 = load ptr, ptr %362, align 8
  %539 = getelementptr inbounds double, ptr %538, i64 %529
  tail call fastcc void @combine(ptr noundef %520, ptr noundef %521, ptr noundef %534, ptr noundef %535, ptr noundef %537, ptr noundef %539, i64 noundef %533, i64 noundef %526, i64 noundef %524) #8
  %540 = icmp eq i64 %524, 1
  br i1 %540, label %541, label %572

541:                                              ; preds = %516
  %542 = load ptr, ptr %359, align 8
  %543 = getelementptr i64, ptr %542, i64 %519
  %544 = getelementptr i8, ptr %543, i64 8
  %545 = load i64, ptr %544, align 8
  %546 = add nsw i64 %545, -1
  %547 = load ptr, ptr %362, align 8
  %548 = getelementptr inbounds double, ptr %547, i64 %546
  %549 = load double, ptr %548, align 8
  %550 = fmul double %497, %549
  %551 = load ptr, ptr %360, align 8
  %552 = load ptr, ptr %361, align 8
  %553 = getelementptr inbounds i64, ptr %552, i64 %546
  %554 = load i64, ptr %553, align 8
  %555 = getelementptr inbounds double, ptr %551, i64 %554
  %556 = load ptr, ptr %73, align 8
  %557 = getelementptr inbounds i8, ptr %556, i64 8
  %558 = load i64, ptr %557, align 8
  %559 = icmp sgt i64 %558, 0
  br i1 %559, label %560, label %572

560:                                              ; preds = %541, %560
  %561 = phi i64 [ %567, %560 ], [ 0, %541 ]
  %562 = getelementptr inbounds double, ptr %555, i64 %561
  %563 = load double, ptr %562, align 8
  %564 = getelementptr inbounds double, ptr %520, i64 %561
  %565 = load double, ptr %564, align 8
  %566 = tail call double @llvm.fma.f64(double %550, double %563, double %565)
  store double %566, ptr %564, align 8
  %567 = add nuw nsw i64 %561, 1
  %568 = load ptr, ptr %73, align 8
  %569 = getelementptr inbounds i8, ptr %568, i64 8
  %570 = load i64, ptr %569, align 8
  %571 = icmp slt i64 %567, %570
  br i1 %571, label %560, label %572, !llvm.loop !13

572:                                              ; preds = %560, %541, %516
  %573 = load ptr, ptr %360, align 8
  %574 = load i64, ptr %363, align 8
  %575 = mul nsw i64 %574, %519
  %576 = getelementptr inbounds double, ptr %573, i64 %575
  %577 = load i64, ptr %356, align 8
  %578 = add nsw i64 %577, 1
  store i64 %578, ptr %356, align 8
  %579 = load ptr, ptr %364, align 8
  %580 = getelementptr inbounds double, ptr %579, i64 %519
  %581 = load double, ptr %580, align 8
  %582 = fmul double %497, %581
  %583 = fadd double %450, %582
  %584 = load ptr, ptr %358, align 8
  %585 = load ptr, ptr %365, align 8
  store double %583, ptr %585, align 8
  %586 = load i64, ptr %366, align 8
  %587 = icmp sgt i64 %586, 0
  br i1 %587, label %588, label %589

588:                                              ; preds = %572
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %589

589:                                              ; preds = %572, %588
  %590 = load ptr, ptr %73, align 8
  %591 = load i64, ptr %590, align 8
  %592 = load ptr, ptr %365, align 8
  %593 = load ptr, ptr %367, align 8
  %594 = load ptr, ptr %368, align 8
  %595 = inttoptr i64 %591 to ptr
  %596 = tail call i32 %595(ptr noundef %592, ptr noundef %584, ptr noundef %593, ptr noundef %594, ptr noundef %576) #9
  %597 = sext i32 %596 to i64
  %598 = icmp eq i32 %596, 0
  %599 = select i1 %598, i64 %518, i64 %597
  br i1 %598, label %512, label %600

600:                                              ; preds = %512, %589, %505
  %601 = phi i1 [ %511, %505 ], [ %514, %512 ], [ %517, %589 ]
  %602 = phi i64 [ 0, %505 ], [ %597, %589 ], [ %597, %512 ]
  %603 = phi i64 [ undef, %505 ], [ %599, %589 ], [ %599, %512 ]
  br i1 %601, label %657, label %604

604:                                              ; preds = %600
  %605 = load ptr, ptr %369, align 8
  %606 = load ptr, ptr %74, align 8
  %607 = load ptr, ptr %73, align 8
  %608 = getelementptr inbounds i8, ptr %607, i64 16
  %609 = load i64, ptr %608, align 8
  %610 = icmp sgt i64 %609, 1
  %611 = zext i1 %610 to i64
  %612 = load ptr, ptr %370, align 8
  %613 = getelementptr inbounds i64, ptr %612, i64 %507
  %614 = load i64, ptr %613, align 8
  %615 = getelementptr i8, ptr %613, i64 8
  %616 = load i64, ptr %615, align 8
  %617 = xor i64 %614, -1
  %618 = add i64 %616, %617
  %619 = load ptr, ptr %357, align 8
  %620 = load ptr, ptr %371, align 8
  %621 = load ptr, ptr %372, align 8
  %622 = getelementptr inbounds i64, ptr %621, i64 %614
  %623 = load ptr, ptr %373, align 8
  %624 = getelementptr inbounds double, ptr %623, i64 %614
  tail call fastcc void @combine(ptr noundef %605, ptr noundef %606, ptr noundef %619, ptr noundef %620, ptr noundef %622, ptr noundef %624, i64 noundef %618, i64 noundef %611, i64 noundef %609) #8
  %625 = icmp eq i64 %609, 1
  br i1 %625, label %626, label %657

626:                                              ; preds = %604
  %627 = load ptr, ptr %370, align 8
  %628 = getelementptr i64, ptr %627, i64 %507
  %629 = getelementptr i8, ptr %628, i64 8
  %630 = load i64, ptr %629, align 8
  %631 = add nsw i64 %630, -1
  %632 = load ptr, ptr %373, align 8
  %633 = getelementptr inbounds double, ptr %632, i64 %631
  %634 = load double, ptr %633, align 8
  %635 = fmul double %497, %634
  %636 = load ptr, ptr %371, align 8
  %637 = load ptr, ptr %372, align 8
  %638 = getelementptr inbounds i64, ptr %637, i64 %631
  %639 = load i64, ptr %638, align 8
  %640 = getelementptr inbounds double, ptr %636, i64 %639
  %641 = load ptr, ptr %73, align 8
  %642 = getelementptr inbounds i8, ptr %641, i64 8
  %643 = load i64, ptr %642, align 8
  %644 = icmp sgt i64 %643, 0
  br i1 %644, label %645, label %657

645:                                              ; preds = %626, %645
  %646 = phi i64 [ %652, %645 ], [ 0, %626 ]
  %647 = getelementptr inbounds double, ptr %640, i64 %646
  %648 = load double, ptr %647, align 8
  %649 = getelementptr inbounds double, ptr %605, i64 %646
  %650 = load double, ptr %649, align 8
  %651 = tail call double @llvm.fma.f64(double %635, double %648, double %650)
  store double %651, ptr %649, align 8
  %652 = add nuw nsw i64 %646, 1
  %653 = load ptr, ptr %73, align 8
  %654 = getelementptr inbounds i8, ptr %653, i64 8
  %655 = load i64, ptr %654, align 8
  %656 = icmp slt i64 %652, %655
  br i1 %656, label %645, label %657, !llvm.loop !13

657:                                              ; preds = %645, %626, %604, %600
  %658 = phi i64 [ %603, %600 ], [ %602, %604 ], [ %602, %626 ], [ %602, %645 ]
  %659 = icmp eq i64 %658, 0
  %660 = select i1 %659, i1 %101, i1 false
  br i1 %660, label %661, label %677

661:                                              ; preds = %657
  %662 = load i64, ptr %356, align 8
  %663 = add nsw i64 %662, 1
  store i64 %663, ptr %356, align 8
  %664 = load ptr, ptr %374, align 8
  store double %498, ptr %664, align 8
  %665 = load i64, ptr %375, align 8
  %666 = icmp sgt i64 %665, 0
  br i1 %666, label %667, label %668

667:                                              ; preds = %661
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %668

668:                                              ; preds = %661, %667
  %669 = load ptr, ptr %73, align 8
  %670 = load i64, ptr %669, align 8
  %671 = load ptr, ptr %374, align 8
  %672 = load ptr, ptr %376, align 8
  %673 = load ptr, ptr %377, align 8
  %674 = inttoptr i64 %670 to ptr
  %675 = tail call i32 %674(ptr noundef %671, ptr noundef %78, ptr noundef %672, ptr noundef %673, ptr noundef %116) #9
  %676 = sext i32 %675 to i64
  br label %677

677:                                              ; preds = %668, %657
  %678 = phi i64 [ %676, %668 ], [ %658, %657 ]
  %679 = icmp slt i64 %678, 0
  br i1 %679, label %1628, label %680

680:                                              ; preds = %677
  %681 = icmp eq i64 %678, 0
  br i1 %681, label %682, label %877

682:                                              ; preds = %680
  br i1 %98, label %683, label %684

683:                                              ; preds = %682
  br i1 %389, label %833, label %842

684:                                              ; preds = %682
  %685 = load ptr, ptr %73, align 8
  %686 = load ptr, ptr %0, align 8
  %687 = getelementptr inbounds i8, ptr %685, i64 24
  %688 = load i64, ptr %687, align 8
  %689 = getelementptr inbounds i8, ptr %686, i64 8
  %690 = load i64, ptr %689, align 8
  %691 = load ptr, ptr %378, align 8
  %692 = load i64, ptr %379, align 8
  %693 = getelementptr inbounds double, ptr %691, i64 %692
  %694 = icmp sgt i64 %690, 0
  br i1 %694, label %695, label %697

695:                                              ; preds = %684
  %696 = getelementptr inbounds i8, ptr %685, i64 32
  br label %705

697:                                              ; preds = %705, %684
  %698 = icmp sgt i64 %688, 0
  br i1 %698, label %699, label %731

699:                                              ; preds = %697
  %700 = load ptr, ptr %74, align 8
  %701 = load ptr, ptr %385, align 8
  %702 = load ptr, ptr %386, align 8
  %703 = load ptr, ptr %387, align 8
  %704 = load ptr, ptr %378, align 8
  br label %789

705:                                              ; preds = %695, %705
  %706 = phi i64 [ 0, %695 ], [ %729, %705 ]
  %707 = load i64, ptr %686, align 8
  %708 = load i64, ptr %696, align 8
  %709 = load ptr, ptr %378, align 8
  %710 = load i64, ptr %379, align 8
  %711 = mul nsw i64 %710, %706
  %712 = getelementptr inbounds double, ptr %709, i64 %711
  %713 = load ptr, ptr %380, align 8
  %714 = load ptr, ptr %381, align 8
  %715 = getelementptr i64, ptr %714, i64 %707
  %716 = getelementptr i8, ptr %715, i64 8
  %717 = getelementptr i64, ptr %716, i64 %706
  %718 = load i64, ptr %717, align 8
  %719 = getelementptr i8, ptr %717, i64 8
  %720 = load i64, ptr %719, align 8
  %721 = xor i64 %718, -1
  %722 = add i64 %720, %721
  %723 = load ptr, ptr %357, align 8
  %724 = load ptr, ptr %382, align 8
  %725 = load ptr, ptr %383, align 8
  %726 = getelementptr inbounds i64, ptr %725, i64 %718
  %727 = load ptr, ptr %384, align 8
  %728 = getelementptr inbounds double, ptr %727, i64 %718
  tail call fastcc void @combine(ptr noundef %712, ptr noundef %713, ptr noundef %723, ptr noundef %724, ptr noundef %726, ptr noundef %728, i64 noundef %722, i64 noundef 1, i64 noundef %708) #8
  %729 = add nuw nsw i64 %706, 1
  %730 = icmp eq i64 %729, %690
  br i1 %730, label %697, label %705, !llvm.loop !14

731:                                              ; preds = %789, %697
  %732 = phi double [ 0.000000e+00, %697 ], [ %817, %789 ]
  %733 = phi double [ 0.000000e+00, %697 ], [ %815, %789 ]
  %734 = load ptr, ptr %388, align 8
  %735 = getelementptr inbounds i8, ptr %685, i64 8
  %736 = load i64, ptr %735, align 8
  %737 = add nsw i64 %736, -3
  %738 = getelementptr i8, ptr %734, i64 8
  %739 = getelementptr i8, ptr %734, i64 16
  %740 = getelementptr i8, ptr %734, i64 24
  %741 = icmp slt i64 %688, %737
  br i1 %741, label %749, label %742

742:                                              ; preds = %749, %731
  %743 = phi double [ 0.000000e+00, %731 ], [ %758, %749 ]
  %744 = phi double [ 0.000000e+00, %731 ], [ %762, %749 ]
  %745 = phi double [ 0.000000e+00, %731 ], [ %766, %749 ]
  %746 = phi double [ 0.000000e+00, %731 ], [ %770, %749 ]
  %747 = phi i64 [ %688, %731 ], [ %771, %749 ]
  %748 = icmp slt i64 %747, %736
  br i1 %748, label %773, label %782

749:                                              ; preds = %731, %749
  %750 = phi i64 [ %771, %749 ], [ %688, %731 ]
  %751 = phi double [ %770, %749 ], [ 0.000000e+00, %731 ]
  %752 = phi double [ %766, %749 ], [ 0.000000e+00, %731 ]
  %753 = phi double [ %762, %749 ], [ 0.000000e+00, %731 ]
  %754 = phi double [ %758, %749 ], [ 0.000000e+00, %731 ]
  %755 = getelementptr inbounds double, ptr %734, i64 %750
  %756 = load double, ptr %755, align 8
  %757 = fmul double %756, 0.000000e+00
  %758 = fadd double %754, %757
  %759 = getelementptr double, ptr %738, i64 %750
  %760 = load double, ptr %759, align 8
  %761 = fmul double %760, 0.000000e+00
  %762 = fadd double %753, %761
  %763 = getelementptr double, ptr %739, i64 %750
  %764 = load double, ptr %763, align 8
  %765 = fmul double %764, 0.000000e+00
  %766 = fadd double %752, %765
  %767 = getelementptr double, ptr %740, i64 %750
  %768 = load double, ptr %767, align 8
  %769 = fmul double %768, 0.000000e+00
  %770 = fadd double %751, %769
  %771 = add nsw i64 %750, 4
  %772 = icmp slt i64 %771, %737
  br i1 %772, label %749, label %742, !llvm.loop !15

773:                                              ; preds = %742, %773
  %774 = phi i64 [ %780, %773 ], [ %747, %742 ]
  %775 = phi double [ %779, %773 ], [ %743, %742 ]
  %776 = getelementptr inbounds double, ptr %734, i64 %774
  %777 = load double, ptr %776, align 8
  %778 = fmul double %777, 0.000000e+00
  %779 = fadd double %775, %778
  %780 = add nsw i64 %774, 1
  %781 = icmp eq i64 %780, %736
  br i1 %781, label %782, label %773, !llvm.loop !16

782:                                              ; preds = %773, %742
  %783 = phi double [ %743, %742 ], [ %779, %773 ]
  %784 = fadd double %744, %783
  %785 = fadd double %745, %746
  %786 = fadd double %785, %784
  %787 = fadd double %733, %786
  %788 = icmp eq i64 %690, 2
  br i1 %788, label %820, label %829

789:                                              ; preds = %699, %789
  %790 = phi double [ 0.000000e+00, %699 ], [ %815, %789 ]
  %791 = phi double [ 0.000000e+00, %699 ], [ %817, %789 ]
  %792 = phi i64 [ 0, %699 ], [ %818, %789 ]
  %793 = getelementptr inbounds double, ptr %700, i64 %792
  %794 = load double, ptr %793, align 8
  %795 = getelementptr inbounds double, ptr %701, i64 %792
  %796 = load double, ptr %795, align 8
  %797 = getelementptr inbounds double, ptr %702, i64 %792
  %798 = load double, ptr %797, align 8
  %799 = getelementptr inbounds double, ptr %703, i64 %792
  %800 = load double, ptr %799, align 8
  %801 = tail call double @llvm.fabs.f64(double %794)
  %802 = tail call double @llvm.fabs.f64(double %796)
  %803 = fcmp ogt double %801, %802
  %804 = select i1 %803, double %801, double %802
  %805 = fmul double %804, %800
  %806 = fadd double %798, %805
  %807 = fdiv double 1.000000e+00, %806
  %808 = getelementptr inbounds double, ptr %704, i64 %792
  %809 = load double, ptr %808, align 8
  %810 = fmul double %809, %807
  %811 = getelementptr inbounds double, ptr %693, i64 %792
  %812 = load double, ptr %811, align 8
  %813 = fmul double %812, %807
  %814 = fmul double %810, %810
  %815 = fadd double %790, %814
  %816 = fmul double %813, %813
  %817 = fadd double %791, %816
  %818 = add nuw nsw i64 %792, 1
  %819 = icmp eq i64 %818, %688
  br i1 %819, label %731, label %789, !llvm.loop !17

820:                                              ; preds = %782
  %821 = fmul double %732, 1.000000e-02
  %822 = fadd double %821, %787
  %823 = sitofp i64 %688 to double
  %824 = fmul double %822, %823
  %825 = tail call double @llvm.sqrt.f64(double %824)
  %826 = fdiv double %787, %825
  %827 = fcmp une double %787, 0.000000e+00
  %828 = select i1 %827, double %826, double 0.000000e+00
  br label %842

829:                                              ; preds = %782
  %830 = sitofp i64 %688 to double
  %831 = fdiv double %787, %830
  %832 = tail call double @llvm.sqrt.f64(double %831)
  br label %842

833:                                              ; preds = %683, %833
  %834 = phi i64 [ %840, %833 ], [ 0, %683 ]
  %835 = phi double [ %839, %833 ], [ 0.000000e+00, %683 ]
  %836 = getelementptr inbounds double, ptr %78, i64 %834
  %837 = load double, ptr %836, align 8
  %838 = fmul double %837, 0.000000e+00
  %839 = fadd double %835, %838
  %840 = add nuw nsw i64 %834, 1
  %841 = icmp eq i64 %840, %91
  br i1 %841, label %842, label %833, !llvm.loop !18

842:                                              ; preds = %833, %683, %829, %820
  %843 = phi double [ %828, %820 ], [ %832, %829 ], [ 0.000000e+00, %683 ], [ %839, %833 ]
  %844 = fcmp uge double %843, 1.000000e+00
  %845 = select i1 %844, i1 true, i1 %390
  br i1 %845, label %877, label %846

846:                                              ; preds = %842
  br i1 %95, label %858, label %847

847:                                              ; preds = %846
  br i1 %98, label %850, label %848

848:                                              ; preds = %847
  %849 = load ptr, ptr %74, align 8
  br label %850

850:                                              ; preds = %847, %848
  %851 = phi ptr [ %849, %848 ], [ null, %847 ]
  %852 = load ptr, ptr %92, align 8
  %853 = getelementptr inbounds i8, ptr %852, i64 56
  %854 = load i64, ptr %853, align 8
  %855 = inttoptr i64 %854 to ptr
  %856 = tail call i64 %855(ptr noundef %0, double noundef %498, ptr noundef %78, ptr noundef %851) #9
  %857 = icmp ne i64 %856, 0
  br label %858

858:                                              ; preds = %850, %846
  %859 = phi i1 [ false, %846 ], [ %857, %850 ]
  br i1 %859, label %877, label %860

860:                                              ; preds = %858
  %861 = load i64, ptr %356, align 8
  %862 = add nsw i64 %861, 1
  store i64 %862, ptr %356, align 8
  %863 = load ptr, ptr %391, align 8
  store double %498, ptr %863, align 8
  %864 = load i64, ptr %392, align 8
  %865 = icmp sgt i64 %864, 0
  br i1 %865, label %866, label %867

866:                                              ; preds = %860
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %867

867:                                              ; preds = %860, %866
  %868 = load ptr, ptr %73, align 8
  %869 = load i64, ptr %868, align 8
  %870 = load ptr, ptr %391, align 8
  %871 = load ptr, ptr %393, align 8
  %872 = load ptr, ptr %394, align 8
  %873 = inttoptr i64 %869 to ptr
  %874 = tail call i32 %873(ptr noundef %870, ptr noundef %78, ptr noundef %871, ptr noundef %872, ptr noundef %116) #9
  %875 = sext i32 %874 to i64
  %876 = icmp slt i32 %874, 0
  br i1 %876, label %1628, label %877

877:                                              ; preds = %842, %867, %858, %680
  %878 = phi i64 [ 0, %858 ], [ %875, %867 ], [ 0, %842 ], [ %678, %680 ]
  %879 = phi double [ %843, %858 ], [ %843, %867 ], [ %843, %842 ], [ 0.000000e+00, %680 ]
  %880 = phi i1 [ %859, %858 ], [ %859, %867 ], [ false, %842 ], [ false, %680 ]
  %881 = icmp ne i64 %878, 0
  %882 = fcmp uge double %879, 1.000000e+00
  %883 = or i1 %881, %882
  %884 = or i1 %880, %883
  br i1 %884, label %885, label %948

885:                                              ; preds = %877
  %886 = load i64, ptr %352, align 8
  %887 = add nsw i64 %886, 1
  store i64 %887, ptr %352, align 8
  %888 = or i1 %881, %880
  br i1 %888, label %892, label %889

889:                                              ; preds = %885
  %890 = tail call double @llvm.fabs.f64(double %879)
  %891 = fcmp one double %890, 0x7FF0000000000000
  br label %892

892:                                              ; preds = %889, %885
  %893 = phi i1 [ false, %885 ], [ %891, %889 ]
  %894 = select i1 %893, i64 2, i64 4
  %895 = select i1 %880, i64 6, i64 %894
  %896 = select i1 %881, i64 3, i64 %895
  store i64 %896, ptr %441, align 8
  %897 = fcmp ogt double %879, 1.000000e-10
  %898 = select i1 %897, double %879, double 1.000000e-10
  %899 = load double, ptr %442, align 8
  %900 = load double, ptr %88, align 8
  %901 = fneg double %900
  %902 = bitcast double %898 to i64
  %903 = add nsw i64 %902, -4604544271217802189
  %904 = ashr i64 %903, 52
  %905 = and i64 %903, -4503599627370496
  %906 = sub nsw i64 %902, %905
  %907 = bitcast i64 %906 to double
  %908 = fadd double %907, -1.000000e+00
  %909 = fadd double %907, 1.000000e+00
  %910 = fdiv double %908, %909
  %911 = fmul double %910, %910
  %912 = tail call double @llvm.fma.f64(double %911, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %913 = tail call double @llvm.fma.f64(double %912, double %911, double 0x3FE2776C50EF9BFE)
  %914 = tail call double @llvm.fma.f64(double %913, double %911, double 0x3FEEC709DC3A03FD)
  %915 = tail call double @llvm.fma.f64(double %914, double %911, double 0x40071547652B82FE)
  %916 = trunc nsw i64 %904 to i32
  %917 = sitofp i32 %916 to double
  %918 = fmul double %910, %915
  %919 = fadd double %918, %917
  %920 = fmul double %919, %901
  %921 = fcmp ogt double %920, -1.000000e+03
  %922 = select i1 %921, double %920, double -1.000000e+03
  %923 = fcmp olt double %922, 1.000000e+03
  %924 = select i1 %923, double %922, double 1.000000e+03
  %925 = tail call double @llvm.rint.f64(double %924)
  %926 = fsub double %924, %925
  %927 = tail call double @llvm.fma.f64(double %926, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %928 = tail call double @llvm.fma.f64(double %927, double %926, double 0x3F55D87FE78A6730)
  %929 = tail call double @llvm.fma.f64(double %928, double %926, double 0x3F83B2AB6FBA4E77)
  %930 = tail call double @llvm.fma.f64(double %929, double %926, double 0x3FAC6B08D704A0BF)
  %931 = tail call double @llvm.fma.f64(double %930, double %926, double 0x3FCEBFBDFF82C58E)
  %932 = tail call double @llvm.fma.f64(double %931, double %926, double 0x3FE62E42FEFA39EF)
  %933 = tail call double @llvm.fma.f64(double %932, double %926, double 1.000000e+00)
  %934 = bitcast double %933 to i64
  %935 = fptosi double %925 to i32
  %936 = sext i32 %935 to i64
  %937 = shl nsw i64 %936, 52
  %938 = add nsw i64 %937, %934
  %939 = bitcast i64 %938 to double
  %940 = fmul double %899, %939
  %941 = load double, ptr %443, align 8
  %942 = fcmp ogt double %940, %941
  %943 = select i1 %942, double %940, double %941
  %944 = select i1 %893, double %943, double 2.500000e-01
  %945 = fmul double %497, %944
  br i1 %98, label %946, label %947

946:                                              ; preds = %892
  store double %497, ptr %118, align 8
  br label %1628

947:                                              ; preds = %892
  store double 1.000000e+00, ptr %444, align 8
  br label %1628, !llvm.loop !19

948:                                              ; preds = %877
  %949 = load i64, ptr %351, align 8
  %950 = add nsw i64 %949, 1
  store i64 %950, ptr %351, align 8
  store double %498, ptr %76, align 8
  store double %497, ptr %395, align 8
  %951 = load ptr, ptr %350, align 8
  %952 = getelementptr inbounds i8, ptr %951, i64 8
  %953 = load i64, ptr %952, align 8
  %954 = icmp eq i64 %953, 0
  br i1 %954, label %984, label %955

955:                                              ; preds = %948
  %956 = load i64, ptr %951, align 8
  %957 = load ptr, ptr %73, align 8
  %958 = getelementptr inbounds i8, ptr %957, i64 8
  %959 = load i64, ptr %958, align 8
  %960 = load ptr, ptr %396, align 8
  %961 = load i64, ptr %397, align 8
  %962 = mul nsw i64 %961, %956
  %963 = getelementptr inbounds double, ptr %960, i64 %962
  %964 = getelementptr inbounds double, ptr %963, i64 %961
  store double %450, ptr %963, align 8
  %965 = getelementptr inbounds i8, ptr %963, i64 8
  store double %497, ptr %965, align 8
  store double %498, ptr %964, align 8
  %966 = getelementptr inbounds i8, ptr %964, i64 8
  store double 0.000000e+00, ptr %966, align 8
  %967 = icmp sgt i64 %959, 0
  br i1 %967, label %971, label %968

968:                                              ; preds = %971, %955
  %969 = add nsw i64 %956, 1
  %970 = load ptr, ptr %350, align 8
  store i64 %969, ptr %970, align 8
  br label %984

971:                                              ; preds = %955, %971
  %972 = phi i64 [ %982, %971 ], [ 0, %955 ]
  %973 = load ptr, ptr %74, align 8
  %974 = getelementptr inbounds double, ptr %973, i64 %972
  %975 = load double, ptr %974, align 8
  %976 = add nuw nsw i64 %972, 2
  %977 = getelementptr inbounds double, ptr %963, i64 %976
  store double %975, ptr %977, align 8
  %978 = load ptr, ptr %77, align 8
  %979 = getelementptr inbounds double, ptr %978, i64 %972
  %980 = load double, ptr %979, align 8
  %981 = getelementptr inbounds double, ptr %964, i64 %976
  store double %980, ptr %981, align 8
  %982 = add nuw nsw i64 %972, 1
  %983 = icmp eq i64 %982, %959
  br i1 %983, label %968, label %971, !llvm.loop !20

984:                                              ; preds = %948, %968
  br i1 %106, label %985, label %1102

985:                                              ; preds = %984
  %986 = load ptr, ptr %102, align 8
  %987 = getelementptr inbounds i8, ptr %986, i64 8
  %988 = load i64, ptr %987, align 8
  %989 = load i64, ptr %399, align 8
  %990 = add i64 %989, -1
  %991 = load ptr, ptr %400, align 8
  %992 = shl nsw i64 %988, 4
  %993 = getelementptr inbounds i8, ptr %991, i64 %992
  %994 = mul i64 %988, 88
  %995 = getelementptr inbounds i8, ptr %991, i64 %994
  %996 = getelementptr inbounds double, ptr %991, i64 %988
  %997 = load i64, ptr %401, align 8
  %998 = icmp eq i64 %997, 0
  br i1 %998, label %1102, label %999

999:                                              ; preds = %985
  %1000 = load double, ptr %995, align 8
  %1001 = fcmp une double %1000, %450
  br i1 %1001, label %1102, label %1002

1002:                                             ; preds = %999
  %1003 = icmp sgt i64 %988, 0
  br i1 %1003, label %1004, label %1059

1004:                                             ; preds = %1002
  %1005 = load ptr, ptr %398, align 8
  %1006 = icmp sgt i64 %989, 1
  br label %1010

1007:                                             ; preds = %1017
  %1008 = add nuw nsw i64 %1011, 1
  %1009 = icmp eq i64 %1008, %988
  br i1 %1009, label %1059, label %1010, !llvm.loop !21

1010:                                             ; preds = %1004, %1007
  %1011 = phi i64 [ 0, %1004 ], [ %1008, %1007 ]
  %1012 = mul nsw i64 %1011, %989
  %1013 = getelementptr inbounds double, ptr %1005, i64 %1012
  %1014 = getelementptr inbounds double, ptr %1013, i64 %990
  %1015 = load double, ptr %1014, align 8
  %1016 = tail call double @llvm.fabs.f64(double %1015)
  br i1 %1006, label %1025, label %1017

1017:                                             ; preds = %1055, %1010
  %1018 = phi double [ %1016, %1010 ], [ %1056, %1055 ]
  %1019 = getelementptr inbounds double, ptr %993, i64 %1011
  %1020 = load double, ptr %1019, align 8
  %1021 = tail call double @llvm.fabs.f64(double %1020)
  %1022 = fmul double %1018, 8.000000e+00
  %1023 = fmul double %497, %1022
  %1024 = fcmp ogt double %1021, %1023
  br i1 %1024, label %1007, label %1102

1025:                                             ; preds = %1010, %1055
  %1026 = phi i64 [ %1057, %1055 ], [ 0, %1010 ]
  %1027 = phi double [ %1056, %1055 ], [ %1016, %1010 ]
  %1028 = getelementptr inbounds double, ptr %1013, i64 %1026
  %1029 = load double, ptr %1028, align 8
  %1030 = fcmp oeq double %1029, 0.000000e+00
  br i1 %1030, label %1055, label %1031

1031:                                             ; preds = %1025
  %1032 = load ptr, ptr %0, align 8
  %1033 = load i64, ptr %1032, align 8
  %1034 = icmp slt i64 %1033, 0
  br i1 %1034, label %1039, label %1035

1035:                                             ; preds = %1031
  %1036 = load ptr, ptr %112, align 8
  %1037 = load i64, ptr %90, align 8
  %1038 = getelementptr double, ptr %1036, i64 %1026
  br label %1044

1039:                                             ; preds = %1044, %1031
  %1040 = phi double [ 0.000000e+00, %1031 ], [ %1052, %1044 ]
  %1041 = tail call double @llvm.fabs.f64(double %1029)
  %1042 = fmul double %1041, %1040
  %1043 = fadd double %1027, %1042
  br label %1055

1044:                                             ; preds = %1035, %1044
  %1045 = phi i64 [ 0, %1035 ], [ %1053, %1044 ]
  %1046 = phi double [ 0.000000e+00, %1035 ], [ %1052, %1044 ]
  %1047 = mul nsw i64 %1037, %1045
  %1048 = getelementptr double, ptr %1038, i64 %1047
  %1049 = load double, ptr %1048, align 8
  %1050 = tail call double @llvm.fabs.f64(double %1049)
  %1051 = fcmp ogt double %1046, %1050
  %1052 = select i1 %1051, double %1046, double %1050
  %1053 = add nuw i64 %1045, 1
  %1054 = icmp eq i64 %1045, %1033
  br i1 %1054, label %1039, label %1044, !llvm.loop !22

1055:                                             ; preds = %1039, %1025
  %1056 = phi double [ %1027, %1025 ], [ %1043, %1039 ]
  %1057 = add nuw nsw i64 %1026, 1
  %1058 = icmp eq i64 %1057, %990
  br i1 %1058, label %1017, label %1025, !llvm.loop !23

1059:                                             ; preds = %1007, %1002
  %1060 = load ptr, ptr %402, align 8
  store double %498, ptr %1060, align 8
  %1061 = load i64, ptr %403, align 8
  %1062 = icmp sgt i64 %1061, 0
  br i1 %1062, label %1063, label %1064

1063:                                             ; preds = %1059
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %1064

1064:                                             ; preds = %1059, %1063
  %1065 = load ptr, ptr %102, align 8
  %1066 = load i64, ptr %1065, align 8
  %1067 = load ptr, ptr %404, align 8
  %1068 = load ptr, ptr %77, align 8
  %1069 = load ptr, ptr %405, align 8
  %1070 = load ptr, ptr %406, align 8
  %1071 = load ptr, ptr %400, align 8
  %1072 = getelementptr inbounds double, ptr %1071, i64 %988
  %1073 = inttoptr i64 %1066 to ptr
  %1074 = tail call i32 %1073(ptr noundef %1067, ptr noundef %1068, ptr noundef %1069, ptr noundef %1070, ptr noundef %1072) #9
  %1075 = icmp slt i32 %1074, 0
  br i1 %1075, label %1102, label %1076

1076:                                             ; preds = %1064
  %1077 = icmp sgt i64 %988, 0
  br i1 %1077, label %1078, label %1083

1078:                                             ; preds = %1076
  %1079 = load ptr, ptr %407, align 8
  br label %1085

1080:                                             ; preds = %1085
  %1081 = add nuw nsw i64 %1086, 1
  %1082 = icmp eq i64 %1081, %988
  br i1 %1082, label %1083, label %1085, !llvm.loop !24

1083:                                             ; preds = %1080, %1076
  %1084 = icmp sgt i64 %988, 0
  br i1 %1084, label %1095, label %1094

1085:                                             ; preds = %1078, %1080
  %1086 = phi i64 [ 0, %1078 ], [ %1081, %1080 ]
  %1087 = getelementptr inbounds double, ptr %996, i64 %1086
  %1088 = load double, ptr %1087, align 8
  %1089 = getelementptr inbounds i64, ptr %1079, i64 %1086
  %1090 = load i64, ptr %1089, align 8
  %1091 = sitofp i64 %1090 to double
  %1092 = fmul double %1088, %1091
  %1093 = fcmp ogt double %1092, 0.000000e+00
  br i1 %1093, label %1080, label %1102

1094:                                             ; preds = %1095, %1083
  store double %498, ptr %995, align 8
  br label %1102

1095:                                             ; preds = %1083, %1095
  %1096 = phi i64 [ %1100, %1095 ], [ 0, %1083 ]
  %1097 = getelementptr inbounds double, ptr %996, i64 %1096
  %1098 = load double, ptr %1097, align 8
  %1099 = getelementptr inbounds double, ptr %993, i64 %1096
  store double %1098, ptr %1099, align 8
  %1100 = add nuw nsw i64 %1096, 1
  %1101 = icmp eq i64 %1100, %988
  br i1 %1101, label %1094, label %1095, !llvm.loop !25

1102:                                             ; preds = %1017, %1085, %1094, %1064, %999, %985, %984
  %1103 = phi i1 [ false, %984 ], [ false, %1094 ], [ true, %999 ], [ true, %985 ], [ true, %1064 ], [ true, %1085 ], [ true, %1017 ]
  br i1 %1103, label %1146, label %1104

1104:                                             ; preds = %1102
  %1105 = load i64, ptr %408, align 8
  %1106 = getelementptr inbounds double, ptr %86, i64 %1105
  %1107 = load double, ptr %1106, align 8
  %1108 = fcmp ult double %1107, %498
  br i1 %1108, label %1146, label %1109

1109:                                             ; preds = %1104
  %1110 = load ptr, ptr %73, align 8
  %1111 = getelementptr inbounds i8, ptr %1110, i64 8
  %1112 = load i64, ptr %1111, align 8
  %1113 = load i64, ptr %107, align 8
  %1114 = load ptr, ptr %85, align 8
  %1115 = load ptr, ptr %79, align 8
  %1116 = getelementptr inbounds i8, ptr %1115, i64 48
  %1117 = load i64, ptr %1116, align 8
  %1118 = icmp slt i64 %1117, %1113
  br i1 %1118, label %1119, label %1142

1119:                                             ; preds = %1109
  %1120 = icmp sgt i64 %1112, 0
  br label %1121

1121:                                             ; preds = %1119, %1132
  %1122 = phi i64 [ %1117, %1119 ], [ %1133, %1132 ]
  %1123 = getelementptr inbounds double, ptr %1114, i64 %1122
  %1124 = load double, ptr %1123, align 8
  %1125 = load ptr, ptr %75, align 8
  %1126 = load double, ptr %1125, align 8
  %1127 = fcmp ugt double %1124, %1126
  br i1 %1127, label %1142, label %1128

1128:                                             ; preds = %1121
  br i1 %1120, label %1129, label %1132

1129:                                             ; preds = %1128
  %1130 = mul nsw i64 %1122, %1112
  %1131 = getelementptr double, ptr %1, i64 %1130
  br label %1135

1132:                                             ; preds = %1135, %1128
  %1133 = add i64 %1122, 1
  %1134 = icmp eq i64 %1133, %1113
  br i1 %1134, label %1142, label %1121, !llvm.loop !8

1135:                                             ; preds = %1129, %1135
  %1136 = phi i64 [ 0, %1129 ], [ %1140, %1135 ]
  %1137 = getelementptr inbounds double, ptr %78, i64 %1136
  %1138 = load double, ptr %1137, align 8
  %1139 = getelementptr double, ptr %1131, i64 %1136
  store double %1138, ptr %1139, align 8
  %1140 = add nuw nsw i64 %1136, 1
  %1141 = icmp eq i64 %1140, %1112
  br i1 %1141, label %1132, label %1135, !llvm.loop !9

1142:                                             ; preds = %1121, %1132, %1109
  %1143 = phi i64 [ %1117, %1109 ], [ %1122, %1121 ], [ %1113, %1132 ]
  %1144 = load ptr, ptr %79, align 8
  %1145 = getelementptr inbounds i8, ptr %1144, i64 48
  store i64 %1143, ptr %1145, align 8
  br label %1505

1146:                                             ; preds = %1104, %1102
  %1147 = load ptr, ptr %0, align 8
  %1148 = load ptr, ptr %73, align 8
  %1149 = getelementptr inbounds i8, ptr %1148, i64 16
  %1150 = load i64, ptr %1149, align 8
  %1151 = load i64, ptr %1147, align 8
  %1152 = load i64, ptr %409, align 8
  %1153 = load ptr, ptr %410, align 8
  %1154 = mul nsw i64 %1152, %1151
  %1155 = getelementptr inbounds double, ptr %1153, i64 %1154
  %1156 = load ptr, ptr %411, align 8
  %1157 = add nsw i64 %1151, 1
  %1158 = getelementptr inbounds i8, ptr %1147, i64 16
  %1159 = load i64, ptr %1158, align 8
  %1160 = icmp sgt i64 %1159, 0
  br i1 %1160, label %1161, label %1215

1161:                                             ; preds = %1146
  %1162 = getelementptr inbounds i8, ptr %1147, i64 8
  br label %1168

1163:                                             ; preds = %1204
  %1164 = add nsw i64 %1171, 1
  %1165 = load i64, ptr %1158, align 8
  %1166 = add nsw i64 %1165, %1157
  %1167 = icmp slt i64 %1164, %1166
  br i1 %1167, label %1168, label %1215, !llvm.loop !26

1168:                                             ; preds = %1161, %1163
  %1169 = phi i1 [ %1160, %1161 ], [ %1167, %1163 ]
  %1170 = phi i64 [ undef, %1161 ], [ %1214, %1163 ]
  %1171 = phi i64 [ %1157, %1161 ], [ %1164, %1163 ]
  %1172 = load i64, ptr %1162, align 8
  %1173 = load ptr, ptr %412, align 8
  %1174 = load ptr, ptr %74, align 8
  %1175 = load ptr, ptr %413, align 8
  %1176 = getelementptr i64, ptr %1175, i64 %1171
  %1177 = getelementptr i64, ptr %1176, i64 %1172
  %1178 = load i64, ptr %1177, align 8
  %1179 = getelementptr i8, ptr %1177, i64 8
  %1180 = load i64, ptr %1179, align 8
  %1181 = xor i64 %1178, -1
  %1182 = add i64 %1180, %1181
  %1183 = load ptr, ptr %357, align 8
  %1184 = load ptr, ptr %410, align 8
  %1185 = load ptr, ptr %414, align 8
  %1186 = getelementptr inbounds i64, ptr %1185, i64 %1178
  %1187 = load ptr, ptr %415, align 8
  %1188 = getelementptr inbounds double, ptr %1187, i64 %1178
  tail call fastcc void @combine(ptr noundef %1173, ptr noundef %1174, ptr noundef %1183, ptr noundef %1184, ptr noundef %1186, ptr noundef %1188, i64 noundef %1182, i64 noundef 1, i64 noundef %1150) #8
  %1189 = load ptr, ptr %410, align 8
  %1190 = mul nsw i64 %1171, %1152
  %1191 = getelementptr inbounds double, ptr %1189, i64 %1190
  %1192 = load i64, ptr %356, align 8
  %1193 = add nsw i64 %1192, 1
  store i64 %1193, ptr %356, align 8
  %1194 = load ptr, ptr %416, align 8
  %1195 = getelementptr inbounds double, ptr %1194, i64 %1171
  %1196 = load double, ptr %1195, align 8
  %1197 = fmul double %497, %1196
  %1198 = fadd double %450, %1197
  %1199 = load ptr, ptr %412, align 8
  %1200 = load ptr, ptr %417, align 8
  store double %1198, ptr %1200, align 8
  %1201 = load i64, ptr %418, align 8
  %1202 = icmp sgt i64 %1201, 0
  br i1 %1202, label %1203, label %1204

1203:                                             ; preds = %1168
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %1204

1204:                                             ; preds = %1168, %1203
  %1205 = load ptr, ptr %73, align 8
  %1206 = load i64, ptr %1205, align 8
  %1207 = load ptr, ptr %417, align 8
  %1208 = load ptr, ptr %419, align 8
  %1209 = load ptr, ptr %420, align 8
  %1210 = inttoptr i64 %1206 to ptr
  %1211 = tail call i32 %1210(ptr noundef %1207, ptr noundef %1199, ptr noundef %1208, ptr noundef %1209, ptr noundef %1191) #9
  %1212 = sext i32 %1211 to i64
  %1213 = icmp eq i32 %1211, 0
  %1214 = select i1 %1213, i64 %1170, i64 %1212
  br i1 %1213, label %1163, label %1215

1215:                                             ; preds = %1163, %1204, %1146
  %1216 = phi i1 [ %1160, %1146 ], [ %1167, %1163 ], [ %1169, %1204 ]
  %1217 = phi i64 [ 0, %1146 ], [ %1212, %1204 ], [ %1212, %1163 ]
  %1218 = phi i64 [ undef, %1146 ], [ %1214, %1204 ], [ %1214, %1163 ]
  %1219 = getelementptr inbounds i8, ptr %1147, i64 16
  br i1 %1216, label %1288, label %1220

1220:                                             ; preds = %1215
  %1221 = load ptr, ptr %73, align 8
  %1222 = getelementptr inbounds i8, ptr %1221, i64 8
  %1223 = load i64, ptr %1222, align 8
  %1224 = icmp sgt i64 %1223, 0
  br i1 %1224, label %1225, label %1229

1225:                                             ; preds = %1220
  %1226 = getelementptr inbounds double, ptr %1156, i64 %1152
  %1227 = shl nsw i64 %1152, 4
  %1228 = getelementptr inbounds i8, ptr %1156, i64 %1227
  br label %1236

1229:                                             ; preds = %1236, %1220
  %1230 = getelementptr inbounds i8, ptr %1147, i64 8
  %1231 = load i64, ptr %1230, align 8
  %1232 = load i64, ptr %1219, align 8
  %1233 = getelementptr inbounds i8, ptr %1147, i64 24
  %1234 = load i64, ptr %1233, align 8
  %1235 = icmp sgt i64 %1234, 3
  br i1 %1235, label %1263, label %1288

1236:                                             ; preds = %1225, %1236
  %1237 = phi i64 [ 0, %1225 ], [ %1258, %1236 ]
  %1238 = load ptr, ptr %421, align 8
  %1239 = getelementptr inbounds double, ptr %1238, i64 %1237
  %1240 = load double, ptr %1239, align 8
  %1241 = load ptr, ptr %74, align 8
  %1242 = getelementptr inbounds double, ptr %1241, i64 %1237
  %1243 = load double, ptr %1242, align 8
  %1244 = fsub double %1240, %1243
  %1245 = load ptr, ptr %410, align 8
  %1246 = getelementptr inbounds double, ptr %1245, i64 %1237
  %1247 = load double, ptr %1246, align 8
  %1248 = fmul double %497, %1247
  %1249 = fsub double %1248, %1244
  %1250 = getelementptr inbounds double, ptr %1156, i64 %1237
  store double %1244, ptr %1250, align 8
  %1251 = getelementptr inbounds double, ptr %1226, i64 %1237
  store double %1249, ptr %1251, align 8
  %1252 = fsub double %1244, %1249
  %1253 = getelementptr inbounds double, ptr %1155, i64 %1237
  %1254 = load double, ptr %1253, align 8
  %1255 = fmul double %497, %1254
  %1256 = fsub double %1252, %1255
  %1257 = getelementptr inbounds double, ptr %1228, i64 %1237
  store double %1256, ptr %1257, align 8
  %1258 = add nuw nsw i64 %1237, 1
  %1259 = load ptr, ptr %73, align 8
  %1260 = getelementptr inbounds i8, ptr %1259, i64 8
  %1261 = load i64, ptr %1260, align 8
  %1262 = icmp slt i64 %1258, %1261
  br i1 %1262, label %1236, label %1229, !llvm.loop !27

1263:                                             ; preds = %1229, %1263
  %1264 = phi i64 [ %1285, %1263 ], [ 3, %1229 ]
  %1265 = mul nsw i64 %1264, %1152
  %1266 = getelementptr inbounds double, ptr %1156, i64 %1265
  %1267 = load ptr, ptr %422, align 8
  %1268 = load ptr, ptr %423, align 8
  %1269 = getelementptr i64, ptr %1268, i64 %1157
  %1270 = getelementptr i64, ptr %1269, i64 %1231
  %1271 = getelementptr i64, ptr %1270, i64 %1232
  %1272 = getelementptr i64, ptr %1271, i64 %1264
  %1273 = getelementptr i8, ptr %1272, i64 -24
  %1274 = load i64, ptr %1273, align 8
  %1275 = getelementptr i8, ptr %1272, i64 -16
  %1276 = load i64, ptr %1275, align 8
  %1277 = xor i64 %1274, -1
  %1278 = add i64 %1276, %1277
  %1279 = load ptr, ptr %357, align 8
  %1280 = load ptr, ptr %410, align 8
  %1281 = load ptr, ptr %424, align 8
  %1282 = getelementptr inbounds i64, ptr %1281, i64 %1274
  %1283 = load ptr, ptr %425, align 8
  %1284 = getelementptr inbounds double, ptr %1283, i64 %1274
  tail call fastcc void @combine(ptr noundef %1266, ptr noundef %1267, ptr noundef %1279, ptr noundef %1280, ptr noundef %1282, ptr noundef %1284, i64 noundef %1278, i64 noundef 1, i64 noundef %1150) #8
  %1285 = add nuw nsw i64 %1264, 1
  %1286 = load i64, ptr %1233, align 8
  %1287 = icmp slt i64 %1285, %1286
  br i1 %1287, label %1263, label %1288, !llvm.loop !28

1288:                                             ; preds = %1263, %1229, %1215
  %1289 = phi i64 [ %1218, %1215 ], [ %1217, %1229 ], [ %1217, %1263 ]
  %1290 = icmp eq i64 %1289, 0
  br i1 %1290, label %1294, label %1291

1291:                                             ; preds = %1288
  store i64 3, ptr %426, align 8
  store double %450, ptr %76, align 8
  %1292 = icmp slt i64 %1289, 0
  %1293 = select i1 %1292, i64 -4, i64 2
  br label %1628

1294:                                             ; preds = %1288
  %1295 = load ptr, ptr %75, align 8
  br i1 %1103, label %1296, label %1307

1296:                                             ; preds = %1294
  %1297 = load ptr, ptr %102, align 8
  %1298 = getelementptr inbounds i8, ptr %1297, i64 16
  %1299 = load i64, ptr %1298, align 8
  %1300 = inttoptr i64 %1299 to ptr
  %1301 = tail call i64 %1300(ptr noundef %0, double noundef %450, double noundef %497) #9
  %1302 = icmp eq i64 %1301, -6
  br i1 %1302, label %1303, label %1304

1303:                                             ; preds = %1296
  store double %450, ptr %1295, align 8
  br label %1482

1304:                                             ; preds = %1296
  %1305 = getelementptr inbounds i8, ptr %1295, i64 48
  %1306 = load double, ptr %1305, align 8
  br label %1307

1307:                                             ; preds = %1304, %1294
  %1308 = phi double [ %1306, %1304 ], [ 1.000000e+00, %1294 ]
  %1309 = phi i64 [ %1301, %1304 ], [ 0, %1294 ]
  %1310 = fcmp oeq double %1308, 1.000000e+00
  br i1 %1310, label %1311, label %1313

1311:                                             ; preds = %1307
  %1312 = load double, ptr %1295, align 8
  br label %1316

1313:                                             ; preds = %1307
  %1314 = fmul double %497, %1308
  %1315 = fadd double %450, %1314
  br label %1316

1316:                                             ; preds = %1313, %1311
  %1317 = phi double [ %1312, %1311 ], [ %1315, %1313 ]
  %1318 = icmp eq i64 %1309, -4
  %1319 = select i1 %1318, i64 -4, i64 0
  br i1 %1318, label %1377, label %1320

1320:                                             ; preds = %1316
  %1321 = fcmp olt double %1308, 1.000000e+00
  %1322 = load ptr, ptr %73, align 8
  %1323 = getelementptr inbounds i8, ptr %1322, i64 8
  %1324 = load i64, ptr %1323, align 8
  %1325 = load i64, ptr %107, align 8
  %1326 = load ptr, ptr %85, align 8
  %1327 = load ptr, ptr %79, align 8
  %1328 = getelementptr inbounds i8, ptr %1327, i64 48
  %1329 = load i64, ptr %1328, align 8
  %1330 = icmp slt i64 %1329, %1325
  br i1 %1330, label %1331, label %1373

1331:                                             ; preds = %1320, %1369
  %1332 = phi i64 [ %1370, %1369 ], [ undef, %1320 ]
  %1333 = phi i64 [ %1371, %1369 ], [ %1329, %1320 ]
  %1334 = getelementptr inbounds double, ptr %1326, i64 %1333
  %1335 = load double, ptr %1334, align 8
  %1336 = fcmp olt double %1335, %1317
  %1337 = fcmp oeq double %1335, %1317
  %1338 = and i1 %1321, %1337
  %1339 = or i1 %1336, %1338
  br i1 %1339, label %1340, label %1373

1340:                                             ; preds = %1331
  %1341 = fsub double %1335, %450
  %1342 = fdiv double %1341, %497
  %1343 = mul nsw i64 %1333, %1324
  %1344 = getelementptr inbounds double, ptr %1, i64 %1343
  %1345 = load ptr, ptr %427, align 8
  %1346 = insertelement <8 x double> poison, double %1342, i64 0
  %1347 = shufflevector <8 x double> %1346, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1347, ptr %1345, align 8
  %1348 = load ptr, ptr %74, align 8
  %1349 = load ptr, ptr %411, align 8
  %1350 = load i64, ptr %409, align 8
  %1351 = load ptr, ptr %0, align 8
  %1352 = getelementptr inbounds i8, ptr %1351, i64 24
  %1353 = load i64, ptr %1352, align 8
  %1354 = load ptr, ptr %427, align 8
  %1355 = load ptr, ptr %73, align 8
  %1356 = getelementptr inbounds i8, ptr %1355, i64 16
  %1357 = load i64, ptr %1356, align 8
  tail call fastcc void @nested(ptr noundef %1344, ptr noundef %1348, ptr noundef %1349, i64 noundef %1350, i64 noundef %1353, ptr noundef %1354, i64 noundef %1357) #8
  %1358 = load ptr, ptr %92, align 8
  %1359 = load i64, ptr %1358, align 8
  %1360 = icmp eq i64 %1359, 1
  br i1 %1360, label %1361, label %1369

1361:                                             ; preds = %1340
  %1362 = load double, ptr %1334, align 8
  %1363 = getelementptr inbounds i8, ptr %1358, i64 56
  %1364 = load i64, ptr %1363, align 8
  %1365 = inttoptr i64 %1364 to ptr
  %1366 = tail call i64 %1365(ptr noundef %0, double noundef %1362, ptr noundef %1344, ptr noundef null) #9
  %1367 = icmp eq i64 %1366, 0
  %1368 = select i1 %1367, i64 %1332, i64 %1366
  br i1 %1367, label %1369, label %1377

1369:                                             ; preds = %1361, %1340
  %1370 = phi i64 [ %1368, %1361 ], [ %1332, %1340 ]
  %1371 = add i64 %1333, 1
  %1372 = icmp eq i64 %1371, %1325
  br i1 %1372, label %1373, label %1331, !llvm.loop !29

1373:                                             ; preds = %1369, %1331, %1320
  %1374 = phi i64 [ %1329, %1320 ], [ %1325, %1369 ], [ %1333, %1331 ]
  %1375 = load ptr, ptr %79, align 8
  %1376 = getelementptr inbounds i8, ptr %1375, i64 48
  store i64 %1374, ptr %1376, align 8
  br label %1377

1377:                                             ; preds = %1361, %1373, %1316
  %1378 = phi i64 [ %1319, %1316 ], [ 0, %1373 ], [ %1368, %1361 ]
  %1379 = icmp eq i64 %1378, 0
  %1380 = icmp ne i64 %1309, 0
  %1381 = fcmp olt double %1308, 1.000000e+00
  %1382 = and i1 %1381, %1379
  %1383 = and i1 %1380, %1382
  br i1 %1383, label %1384, label %1421

1384:                                             ; preds = %1377
  %1385 = load ptr, ptr %428, align 8
  %1386 = load ptr, ptr %429, align 8
  %1387 = insertelement <8 x double> poison, double %1308, i64 0
  %1388 = shufflevector <8 x double> %1387, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1388, ptr %1386, align 8
  %1389 = load ptr, ptr %74, align 8
  %1390 = load ptr, ptr %411, align 8
  %1391 = load i64, ptr %409, align 8
  %1392 = load ptr, ptr %0, align 8
  %1393 = getelementptr inbounds i8, ptr %1392, i64 24
  %1394 = load i64, ptr %1393, align 8
  %1395 = load ptr, ptr %429, align 8
  %1396 = load ptr, ptr %73, align 8
  %1397 = getelementptr inbounds i8, ptr %1396, i64 16
  %1398 = load i64, ptr %1397, align 8
  tail call fastcc void @nested(ptr noundef %1385, ptr noundef %1389, ptr noundef %1390, i64 noundef %1391, i64 noundef %1394, ptr noundef %1395, i64 noundef %1398) #8
  %1399 = load i64, ptr %90, align 8
  %1400 = icmp sgt i64 %1399, 0
  br i1 %1400, label %1405, label %1401

1401:                                             ; preds = %1405, %1384
  %1402 = load ptr, ptr %92, align 8
  %1403 = load i64, ptr %1402, align 8
  %1404 = icmp eq i64 %1403, 1
  br i1 %1404, label %1415, label %1421

1405:                                             ; preds = %1384, %1405
  %1406 = phi i64 [ %1412, %1405 ], [ 0, %1384 ]
  %1407 = load ptr, ptr %428, align 8
  %1408 = getelementptr inbounds double, ptr %1407, i64 %1406
  %1409 = load double, ptr %1408, align 8
  %1410 = load ptr, ptr %77, align 8
  %1411 = getelementptr inbounds double, ptr %1410, i64 %1406
  store double %1409, ptr %1411, align 8
  %1412 = add nuw nsw i64 %1406, 1
  %1413 = load i64, ptr %90, align 8
  %1414 = icmp slt i64 %1412, %1413
  br i1 %1414, label %1405, label %1401, !llvm.loop !30

1415:                                             ; preds = %1401
  %1416 = load ptr, ptr %77, align 8
  %1417 = getelementptr inbounds i8, ptr %1402, i64 56
  %1418 = load i64, ptr %1417, align 8
  %1419 = inttoptr i64 %1418 to ptr
  %1420 = tail call i64 %1419(ptr noundef %0, double noundef %1317, ptr noundef %1416, ptr noundef null) #9
  br label %1421

1421:                                             ; preds = %1415, %1401, %1377
  %1422 = phi i64 [ %1420, %1415 ], [ 0, %1401 ], [ %1378, %1377 ]
  %1423 = icmp eq i64 %1422, 0
  br i1 %1423, label %1426, label %1424

1424:                                             ; preds = %1421
  store double %450, ptr %1295, align 8
  %1425 = getelementptr inbounds i8, ptr %1295, i64 8
  store double %497, ptr %1425, align 8
  br label %1482

1426:                                             ; preds = %1421
  br i1 %1310, label %1427, label %1465

1427:                                             ; preds = %1426
  %1428 = load ptr, ptr %77, align 8
  %1429 = load ptr, ptr %73, align 8
  %1430 = getelementptr inbounds i8, ptr %1429, i64 8
  %1431 = load i64, ptr %1430, align 8
  %1432 = load i64, ptr %107, align 8
  %1433 = load ptr, ptr %85, align 8
  %1434 = load ptr, ptr %79, align 8
  %1435 = getelementptr inbounds i8, ptr %1434, i64 48
  %1436 = load i64, ptr %1435, align 8
  %1437 = icmp slt i64 %1436, %1432
  br i1 %1437, label %1438, label %1461

1438:                                             ; preds = %1427
  %1439 = icmp sgt i64 %1431, 0
  br label %1440

1440:                                             ; preds = %1438, %1451
  %1441 = phi i64 [ %1436, %1438 ], [ %1452, %1451 ]
  %1442 = getelementptr inbounds double, ptr %1433, i64 %1441
  %1443 = load double, ptr %1442, align 8
  %1444 = load ptr, ptr %75, align 8
  %1445 = load double, ptr %1444, align 8
  %1446 = fcmp ugt double %1443, %1445
  br i1 %1446, label %1461, label %1447

1447:                                             ; preds = %1440
  br i1 %1439, label %1448, label %1451

1448:                                             ; preds = %1447
  %1449 = mul nsw i64 %1441, %1431
  %1450 = getelementptr double, ptr %1, i64 %1449
  br label %1454

1451:                                             ; preds = %1454, %1447
  %1452 = add i64 %1441, 1
  %1453 = icmp eq i64 %1452, %1432
  br i1 %1453, label %1461, label %1440, !llvm.loop !8

1454:                                             ; preds = %1448, %1454
  %1455 = phi i64 [ 0, %1448 ], [ %1459, %1454 ]
  %1456 = getelementptr inbounds double, ptr %1428, i64 %1455
  %1457 = load double, ptr %1456, align 8
  %1458 = getelementptr double, ptr %1450, i64 %1455
  store double %1457, ptr %1458, align 8
  %1459 = add nuw nsw i64 %1455, 1
  %1460 = icmp eq i64 %1459, %1431
  br i1 %1460, label %1451, label %1454, !llvm.loop !9

1461:                                             ; preds = %1451, %1440, %1427
  %1462 = phi i64 [ %1436, %1427 ], [ %1432, %1451 ], [ %1441, %1440 ]
  %1463 = load ptr, ptr %79, align 8
  %1464 = getelementptr inbounds i8, ptr %1463, i64 48
  store i64 %1462, ptr %1464, align 8
  br label %1465

1465:                                             ; preds = %1461, %1426
  br i1 %1380, label %1466, label %1482

1466:                                             ; preds = %1465
  %1467 = load i64, ptr %90, align 8
  %1468 = icmp sgt i64 %1467, 0
  br i1 %1468, label %1472, label %1469

1469:                                             ; preds = %1472, %1466
  store double %1317, ptr %1295, align 8
  %1470 = getelementptr inbounds i8, ptr %1295, i64 8
  store double 0.000000e+00, ptr %1470, align 8
  %1471 = load ptr, ptr %79, align 8
  store i64 0, ptr %1471, align 8
  br label %1482

1472:                                             ; preds = %1466, %1472
  %1473 = phi i64 [ %1479, %1472 ], [ 0, %1466 ]
  %1474 = load ptr, ptr %77, align 8
  %1475 = getelementptr inbounds double, ptr %1474, i64 %1473
  %1476 = load double, ptr %1475, align 8
  %1477 = load ptr, ptr %74, align 8
  %1478 = getelementptr inbounds double, ptr %1477, i64 %1473
  store double %1476, ptr %1478, align 8
  %1479 = add nuw nsw i64 %1473, 1
  %1480 = load i64, ptr %90, align 8
  %1481 = icmp slt i64 %1479, %1480
  br i1 %1481, label %1472, label %1469, !llvm.loop !31

1482:                                             ; preds = %1303, %1424, %1465, %1469
  %1483 = phi i64 [ -6, %1303 ], [ %1422, %1424 ], [ %1309, %1469 ], [ %1309, %1465 ]
  %1484 = icmp eq i64 %1483, -6
  br i1 %1484, label %1489, label %1485

1485:                                             ; preds = %1482
  %1486 = icmp ne i64 %1483, 6
  %1487 = select i1 %1486, i1 true, i1 %98
  %1488 = select i1 %1487, i1 true, i1 %106
  br i1 %1488, label %1499, label %1489

1489:                                             ; preds = %1485, %1482
  %1490 = phi i64 [ %1483, %1485 ], [ 2, %1482 ]
  %1491 = load i64, ptr %351, align 8
  %1492 = add nsw i64 %1491, -1
  store i64 %1492, ptr %351, align 8
  %1493 = load ptr, ptr %350, align 8
  %1494 = load i64, ptr %1493, align 8
  %1495 = add nsw i64 %1494, -1
  store i64 %1495, ptr %1493, align 8
  %1496 = load i64, ptr %352, align 8
  %1497 = add nsw i64 %1496, 1
  store i64 %1497, ptr %352, align 8
  store i64 %1490, ptr %439, align 8
  store double 1.000000e+00, ptr %440, align 8
  %1498 = fmul double %497, 2.500000e-01
  br label %1628, !llvm.loop !19

1499:                                             ; preds = %1485
  %1500 = icmp eq i64 %1483, 0
  br i1 %1500, label %1505, label %1501

1501:                                             ; preds = %1499
  %1502 = load ptr, ptr %350, align 8
  %1503 = load i64, ptr %1502, align 8
  %1504 = add nsw i64 %1503, 1
  store i64 %1504, ptr %1502, align 8
  br label %1628

1505:                                             ; preds = %1499, %1142
  br i1 %98, label %1609, label %1506

1506:                                             ; preds = %1505
  %1507 = load double, ptr %431, align 8
  %1508 = fcmp ogt double %879, 1.000000e-10
  %1509 = select i1 %1508, double %879, double 1.000000e-10
  %1510 = load double, ptr %432, align 8
  %1511 = load double, ptr %433, align 8
  %1512 = fneg double %1511
  %1513 = bitcast double %1509 to i64
  %1514 = add nsw i64 %1513, -4604544271217802189
  %1515 = ashr i64 %1514, 52
  %1516 = and i64 %1514, -4503599627370496
  %1517 = sub nsw i64 %1513, %1516
  %1518 = bitcast i64 %1517 to double
  %1519 = fadd double %1518, -1.000000e+00
  %1520 = fadd double %1518, 1.000000e+00
  %1521 = fdiv double %1519, %1520
  %1522 = fmul double %1521, %1521
  %1523 = tail call double @llvm.fma.f64(double %1522, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1524 = tail call double @llvm.fma.f64(double %1523, double %1522, double 0x3FE2776C50EF9BFE)
  %1525 = tail call double @llvm.fma.f64(double %1524, double %1522, double 0x3FEEC709DC3A03FD)
  %1526 = tail call double @llvm.fma.f64(double %1525, double %1522, double 0x40071547652B82FE)
  %1527 = trunc nsw i64 %1515 to i32
  %1528 = sitofp i32 %1527 to double
  %1529 = fmul double %1521, %1526
  %1530 = fadd double %1529, %1528
  %1531 = fmul double %1530, %1512
  %1532 = fcmp ogt double %1531, -1.000000e+03
  %1533 = select i1 %1532, double %1531, double -1.000000e+03
  %1534 = fcmp olt double %1533, 1.000000e+03
  %1535 = select i1 %1534, double %1533, double 1.000000e+03
  %1536 = tail call double @llvm.rint.f64(double %1535)
  %1537 = fsub double %1535, %1536
  %1538 = tail call double @llvm.fma.f64(double %1537, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1539 = tail call double @llvm.fma.f64(double %1538, double %1537, double 0x3F55D87FE78A6730)
  %1540 = tail call double @llvm.fma.f64(double %1539, double %1537, double 0x3F83B2AB6FBA4E77)
  %1541 = tail call double @llvm.fma.f64(double %1540, double %1537, double 0x3FAC6B08D704A0BF)
  %1542 = tail call double @llvm.fma.f64(double %1541, double %1537, double 0x3FCEBFBDFF82C58E)
  %1543 = tail call double @llvm.fma.f64(double %1542, double %1537, double 0x3FE62E42FEFA39EF)
  %1544 = tail call double @llvm.fma.f64(double %1543, double %1537, double 1.000000e+00)
  %1545 = bitcast double %1544 to i64
  %1546 = fptosi double %1536 to i32
  %1547 = sext i32 %1546 to i64
  %1548 = shl nsw i64 %1547, 52
  %1549 = add nsw i64 %1548, %1545
  %1550 = bitcast i64 %1549 to double
  %1551 = fmul double %1510, %1550
  %1552 = load double, ptr %434, align 8
  %1553 = fcmp une double %1552, 0.000000e+00
  br i1 %1553, label %1554, label %1594

1554:                                             ; preds = %1506
  %1555 = load i64, ptr %430, align 8
  %1556 = add nsw i64 %1555, -4604544271217802189
  %1557 = ashr i64 %1556, 52
  %1558 = and i64 %1556, -4503599627370496
  %1559 = sub nsw i64 %1555, %1558
  %1560 = bitcast i64 %1559 to double
  %1561 = fadd double %1560, -1.000000e+00
  %1562 = fadd double %1560, 1.000000e+00
  %1563 = fdiv double %1561, %1562
  %1564 = fmul double %1563, %1563
  %1565 = tail call double @llvm.fma.f64(double %1564, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1566 = tail call double @llvm.fma.f64(double %1565, double %1564, double 0x3FE2776C50EF9BFE)
  %1567 = tail call double @llvm.fma.f64(double %1566, double %1564, double 0x3FEEC709DC3A03FD)
  %1568 = tail call double @llvm.fma.f64(double %1567, double %1564, double 0x40071547652B82FE)
  %1569 = trunc nsw i64 %1557 to i32
  %1570 = sitofp i32 %1569 to double
  %1571 = fmul double %1563, %1568
  %1572 = fadd double %1571, %1570
  %1573 = fmul double %1552, %1572
  %1574 = fcmp ogt double %1573, -1.000000e+03
  %1575 = select i1 %1574, double %1573, double -1.000000e+03
  %1576 = fcmp olt double %1575, 1.000000e+03
  %1577 = select i1 %1576, double %1575, double 1.000000e+03
  %1578 = tail call double @llvm.rint.f64(double %1577)
  %1579 = fsub double %1577, %1578
  %1580 = tail call double @llvm.fma.f64(double %1579, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1581 = tail call double @llvm.fma.f64(double %1580, double %1579, double 0x3F55D87FE78A6730)
  %1582 = tail call double @llvm.fma.f64(double %1581, double %1579, double 0x3F83B2AB6FBA4E77)
  %1583 = tail call double @llvm.fma.f64(double %1582, double %1579, double 0x3FAC6B08D704A0BF)
  %1584 = tail call double @llvm.fma.f64(double %1583, double %1579, double 0x3FCEBFBDFF82C58E)
  %1585 = tail call double @llvm.fma.f64(double %1584, double %1579, double 0x3FE62E42FEFA39EF)
  %1586 = tail call double @llvm.fma.f64(double %1585, double %1579, double 1.000000e+00)
  %1587 = bitcast double %1586 to i64
  %1588 = fptosi double %1578 to i32
  %1589 = sext i32 %1588 to i64
  %1590 = shl nsw i64 %1589, 52
  %1591 = add nsw i64 %1590, %1587
  %1592 = bitcast i64 %1591 to double
  %1593 = fmul double %1551, %1592
  br label %1594

1594:                                             ; preds = %1506, %1554
  %1595 = phi double [ %1593, %1554 ], [ %1551, %1506 ]
  %1596 = load double, ptr %435, align 8
  %1597 = fcmp ogt double %1595, %1596
  %1598 = select i1 %1597, double %1595, double %1596
  %1599 = fcmp olt double %1507, %1598
  %1600 = select i1 %1599, double %1507, double %1598
  %1601 = fmul double %497, %1600
  %1602 = fcmp oeq double %498, %111
  %1603 = fcmp ogt double %451, %1601
  %1604 = select i1 %1602, i1 %1603, i1 false
  %1605 = select i1 %1604, double %451, double %1601
  %1606 = fcmp ogt double %879, 1.000000e-04
  %1607 = select i1 %1606, double %879, double 1.000000e-04
  store double %1607, ptr %430, align 8
  %1608 = load double, ptr %436, align 8
  store double %1608, ptr %431, align 8
  br label %1609

1609:                                             ; preds = %1594, %1505
  %1610 = phi double [ %1605, %1594 ], [ %451, %1505 ]
  br i1 %437, label %1615, label %1611

1611:                                             ; preds = %1615, %1609
  %1612 = load i64, ptr %438, align 8
  %1613 = load i64, ptr %107, align 8
  %1614 = icmp eq i64 %1612, %1613
  br i1 %1614, label %1627, label %1628

1615:                                             ; preds = %1609, %1615
  %1616 = phi i64 [ %1625, %1615 ], [ 0, %1609 ]
  %1617 = getelementptr inbounds double, ptr %78, i64 %1616
  %1618 = load double, ptr %1617, align 8
  %1619 = load ptr, ptr %74, align 8
  %1620 = getelementptr inbounds double, ptr %1619, i64 %1616
  store double %1618, ptr %1620, align 8
  %1621 = getelementptr inbounds double, ptr %116, i64 %1616
  %1622 = load double, ptr %1621, align 8
  %1623 = load ptr, ptr %112, align 8
  %1624 = getelementptr inbounds double, ptr %1623, i64 %1616
  store double %1622, ptr %1624, align 8
  %1625 = add nuw nsw i64 %1616, 1
  %1626 = icmp eq i64 %1625, %91
  br i1 %1626, label %1611, label %1615, !llvm.loop !32

1627:                                             ; preds = %1611
  store double %1610, ptr %118, align 8
  br label %1628

1628:                                             ; preds = %867, %947, %946, %1611, %1627, %1501, %1489, %1291, %677, %504
  %1629 = phi double [ %451, %504 ], [ %451, %677 ], [ %451, %867 ], [ %945, %947 ], [ %945, %946 ], [ %451, %1291 ], [ %1498, %1489 ], [ %451, %1501 ], [ %1610, %1627 ], [ %1610, %1611 ]
  %1630 = phi double [ %450, %504 ], [ %450, %677 ], [ %450, %867 ], [ %450, %947 ], [ %450, %946 ], [ %450, %1291 ], [ %450, %1489 ], [ %450, %1501 ], [ %498, %1627 ], [ %498, %1611 ]
  %1631 = phi i32 [ 1, %504 ], [ 1, %677 ], [ 1, %867 ], [ 3, %947 ], [ 1, %946 ], [ 1, %1291 ], [ 3, %1489 ], [ 1, %1501 ], [ 1, %1627 ], [ 0, %1611 ]
  %1632 = phi i64 [ 2, %504 ], [ -4, %677 ], [ -4, %867 ], [ %449, %947 ], [ 2, %946 ], [ %1293, %1291 ], [ %449, %1489 ], [ %1483, %1501 ], [ 0, %1627 ], [ %449, %1611 ]
  switch i32 %1631, label %1636 [
    i32 0, label %1633
    i32 3, label %1633
  ]

1633:                                             ; preds = %1628, %1628
  %1634 = load i64, ptr %81, align 8
  %1635 = icmp eq i64 %1634, 0
  br i1 %1635, label %445, label %447, !llvm.loop !19

1636:                                             ; preds = %1628, %145, %445, %464, %472, %187, %72
  %1637 = phi i64 [ -1, %72 ], [ %148, %145 ], [ -1, %445 ], [ -5, %464 ], [ 1, %472 ], [ 0, %187 ], [ %1632, %1628 ]
  ret i64 %1637
}



define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #2 {
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

define internal fastcc void @norm_to(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, i64 noundef %4) unnamed_addr #3 {
  %6 = icmp sgt i64 %4, 0
  br i1 %6, label %7, label %13

7:                                                ; preds = %5
  %8 = load ptr, ptr %3, align 8
  %9 = getelementptr inbounds i8, ptr %3, i64 240
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %3, i64 216
  %12 = load ptr, ptr %11, align 8
  br label %18

13:                                               ; preds = %18, %5
  %14 = phi double [ 0.000000e+00, %5 ], [ %39, %18 ]
  %15 = sitofp i64 %4 to double
  %16 = fdiv double %14, %15
  %17 = tail call double @llvm.sqrt.f64(double %16)
  store double %17, ptr %0, align 8
  ret void

18:                                               ; preds = %7, %18
  %19 = phi double [ 0.000000e+00, %7 ], [ %39, %18 ]
  %20 = phi i64 [ 0, %7 ], [ %40, %18 ]
  %21 = getelementptr inbounds double, ptr %1, i64 %20
  %22 = load double, ptr %21, align 8
  %23 = getelementptr inbounds double, ptr %8, i64 %20
  %24 = load double, ptr %23, align 8
  %25 = getelementptr inbounds double, ptr %2, i64 %20
  %26 = load double, ptr %25, align 8
  %27 = getelementptr inbounds double, ptr %10, i64 %20
  %28 = load double, ptr %27, align 8
  %29 = getelementptr inbounds double, ptr %12, i64 %20
  %30 = load double, ptr %29, align 8
  %31 = tail call double @llvm.fabs.f64(double %24)
  %32 = tail call double @llvm.fabs.f64(double %26)
  %33 = fcmp ogt double %31, %32
  %34 = select i1 %33, double %31, double %32
  %35 = fmul double %34, %30
  %36 = fadd double %28, %35
  %37 = fdiv double %22, %36
  %38 = fmul double %37, %37
  %39 = fadd double %19, %38
  %40 = add nuw nsw i64 %20, 1
  %41 = icmp eq i64 %40, %4
  br i1 %41, label %13, label %18, !llvm.loop !35
}

declare double @llvm.sqrt.f64(double) #4

declare double @llvm.fabs.f64(double) #4

declare double @llvm.fma.f64(double, double, double) #4

declare double @llvm.rint.f64(double) #4

declare double @llvm.ceil.f64(double) #4

define internal fastcc void @combine(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, ptr noundef readonly %4, ptr noundef readonly %5, i64 noundef %6, i64 noundef %7, i64 noundef %8) unnamed_addr #5 {
  %10 = load <8 x double>, ptr %2, align 8
  %11 = shl nsw i64 %8, 3
  %12 = icmp slt i64 %8, 4
  br i1 %12, label %16, label %13

13:                                               ; preds = %9
  %14 = icmp sgt i64 %6, 0
  %15 = add nsw i64 %7, %6
  br label %22

16:                                               ; preds = %99, %9
  %17 = phi i64 [ 0, %9 ], [ %23, %99 ]
  %18 = icmp slt i64 %17, %11
  br i1 %18, label %19, label %153

19:                                               ; preds = %16
  %20 = icmp sgt i64 %6, 0
  %21 = add nsw i64 %7, %6
  br label %109

22:                                               ; preds = %13, %99
  %23 = phi i64 [ 32, %13 ], [ %107, %99 ]
  %24 = phi i64 [ 0, %13 ], [ %23, %99 ]
  %25 = getelementptr inbounds double, ptr %1, i64 %24
  %26 = getelementptr inbounds double, ptr %0, i64 %24
  %27 = getelementptr inbounds double, ptr %3, i64 %24
  br i1 %14, label %28, label %54

28:                                               ; preds = %22, %28
  %29 = phi <8 x double> [ %48, %28 ], [ zeroinitializer, %22 ]
  %30 = phi <8 x double> [ %45, %28 ], [ zeroinitializer, %22 ]
  %31 = phi <8 x double> [ %42, %28 ], [ zeroinitializer, %22 ]
  %32 = phi <8 x double> [ %51, %28 ], [ zeroinitializer, %22 ]
  %33 = phi i64 [ %52, %28 ], [ 0, %22 ]
  %34 = getelementptr inbounds i64, ptr %4, i64 %33
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds double, ptr %27, i64 %35
  %37 = getelementptr inbounds double, ptr %5, i64 %33
  %38 = load double, ptr %37, align 8
  %39 = insertelement <8 x double> poison, double %38, i64 0
  %40 = shufflevector <8 x double> %39, <8 x double> poison, <8 x i32> zeroinitializer
  %41 = load <8 x double>, ptr %36, align 8
  %42 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %40, <8 x double> %41, <8 x double> %31)
  %43 = getelementptr inbounds i8, ptr %36, i64 64
  %44 = load <8 x double>, ptr %43, align 8
  %45 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %40, <8 x double> %44, <8 x double> %30)
  %46 = getelementptr inbounds i8, ptr %36, i64 128
  %47 = load <8 x double>, ptr %46, align 8
  %48 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %40, <8 x double> %47, <8 x double> %29)
  %49 = getelementptr inbounds i8, ptr %36, i64 192
  %50 = load <8 x double>, ptr %49, align 8
  %51 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %40, <8 x double> %50, <8 x double> %32)
  %52 = add nuw nsw i64 %33, 1
  %53 = icmp eq i64 %52, %6
  br i1 %53, label %54, label %28, !llvm.loop !36

54:                                               ; preds = %28, %22
  %55 = phi <8 x double> [ zeroinitializer, %22 ], [ %48, %28 ]
  %56 = phi <8 x double> [ zeroinitializer, %22 ], [ %45, %28 ]
  %57 = phi <8 x double> [ zeroinitializer, %22 ], [ %42, %28 ]
  %58 = phi <8 x double> [ zeroinitializer, %22 ], [ %51, %28 ]
  %59 = phi i64 [ 0, %22 ], [ %6, %28 ]
  %60 = load <8 x double>, ptr %25, align 8
  %61 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %57, <8 x double> %60)
  %62 = getelementptr inbounds i8, ptr %25, i64 64
  %63 = load <8 x double>, ptr %62, align 8
  %64 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %56, <8 x double> %63)
  %65 = getelementptr inbounds i8, ptr %25, i64 128
  %66 = load <8 x double>, ptr %65, align 8
  %67 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %55, <8 x double> %66)
  %68 = getelementptr inbounds i8, ptr %25, i64 192
  %69 = load <8 x double>, ptr %68, align 8
  %70 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %58, <8 x double> %69)
  %71 = icmp slt i64 %59, %15
  br i1 %71, label %72, label %99

72:                                               ; preds = %54, %72
  %73 = phi <8 x double> [ %93, %72 ], [ %67, %54 ]
  %74 = phi <8 x double> [ %90, %72 ], [ %64, %54 ]
  %75 = phi <8 x double> [ %87, %72 ], [ %61, %54 ]
  %76 = phi <8 x double> [ %96, %72 ], [ %70, %54 ]
  %77 = phi i64 [ %97, %72 ], [ %59, %54 ]
  %78 = getelementptr inbounds i64, ptr %4, i64 %77
  %79 = load i64, ptr %78, align 8
  %80 = getelementptr inbounds double, ptr %27, i64 %79
  %81 = getelementptr inbounds double, ptr %5, i64 %77
  %82 = load double, ptr %81, align 8
  %83 = insertelement <8 x double> poison, double %82, i64 0
  %84 = shufflevector <8 x double> %83, <8 x double> poison, <8 x i32> zeroinitializer
  %85 = fmul <8 x double> %10, %84
  %86 = load <8 x double>, ptr %80, align 8
  %87 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %85, <8 x double> %86, <8 x double> %75)
  %88 = getelementptr inbounds i8, ptr %80, i64 64
  %89 = load <8 x double>, ptr %88, align 8
  %90 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %85, <8 x double> %89, <8 x double> %74)
  %91 = getelementptr inbounds i8, ptr %80, i64 128
  %92 = load <8 x double>, ptr %91, align 8
  %93 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %85, <8 x double> %92, <8 x double> %73)
  %94 = getelementptr inbounds i8, ptr %80, i64 192
  %95 = load <8 x double>, ptr %94, align 8
  %96 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %85, <8 x double> %95, <8 x double> %76)
  %97 = add nuw nsw i64 %77, 1
  %98 = icmp slt i64 %97, %15
  br i1 %98, label %72, label %99, !llvm.loop !37

99:                                               ; preds = %72, %54
  %100 = phi <8 x double> [ %67, %54 ], [ %93, %72 ]
  %101 = phi <8 x double> [ %64, %54 ], [ %90, %72 ]
  %102 = phi <8 x double> [ %61, %54 ], [ %87, %72 ]
  %103 = phi <8 x double> [ %70, %54 ], [ %96, %72 ]
  store <8 x double> %102, ptr %26, align 8
  %104 = getelementptr inbounds i8, ptr %26, i64 64
  store <8 x double> %101, ptr %104, align 8
  %105 = getelementptr inbounds i8, ptr %26, i64 128
  store <8 x double> %100, ptr %105, align 8
  %106 = getelementptr inbounds i8, ptr %26, i64 192
  store <8 x double> %103, ptr %106, align 8
  %107 = add nuw nsw i64 %23, 32
  %108 = icmp sgt i64 %107, %11
  br i1 %108, label %16, label %22, !llvm.loop !38

109:                                              ; preds = %19, %149
  %110 = phi i64 [ %17, %19 ], [ %151, %149 ]
  %111 = getelementptr inbounds double, ptr %0, i64 %110
  %112 = getelementptr inbounds double, ptr %1, i64 %110
  %113 = getelementptr inbounds double, ptr %3, i64 %110
  br i1 %20, label %120, label %114

114:                                              ; preds = %120, %109
  %115 = phi <8 x double> [ zeroinitializer, %109 ], [ %131, %120 ]
  %116 = phi i64 [ 0, %109 ], [ %6, %120 ]
  %117 = load <8 x double>, ptr %112, align 8
  %118 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %115, <8 x double> %117)
  %119 = icmp slt i64 %116, %21
  br i1 %119, label %134, label %149

120:                                              ; preds = %109, %120
  %121 = phi <8 x double> [ %131, %120 ], [ zeroinitializer, %109 ]
  %122 = phi i64 [ %132, %120 ], [ 0, %109 ]
  %123 = getelementptr inbounds double, ptr %5, i64 %122
  %124 = load double, ptr %123, align 8
  %125 = insertelement <8 x double> poison, double %124, i64 0
  %126 = shufflevector <8 x double> %125, <8 x double> poison, <8 x i32> zeroinitializer
  %127 = getelementptr inbounds i64, ptr %4, i64 %122
  %128 = load i64, ptr %127, align 8
  %129 = getelementptr inbounds double, ptr %113, i64 %128
  %130 = load <8 x double>, ptr %129, align 8
  %131 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %126, <8 x double> %130, <8 x double> %121)
  %132 = add nuw nsw i64 %122, 1
  %133 = icmp eq i64 %132, %6
  br i1 %133, label %114, label %120, !llvm.loop !36

134:                                              ; preds = %114, %134
  %135 = phi <8 x double> [ %146, %134 ], [ %118, %114 ]
  %136 = phi i64 [ %147, %134 ], [ %116, %114 ]
  %137 = getelementptr inbounds double, ptr %5, i64 %136
  %138 = load double, ptr %137, align 8
  %139 = insertelement <8 x double> poison, double %138, i64 0
  %140 = shufflevector <8 x double> %139, <8 x double> poison, <8 x i32> zeroinitializer
  %141 = fmul <8 x double> %10, %140
  %142 = getelementptr inbounds i64, ptr %4, i64 %136
  %143 = load i64, ptr %142, align 8
  %144 = getelementptr inbounds double, ptr %113, i64 %143
  %145 = load <8 x double>, ptr %144, align 8
  %146 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %141, <8 x double> %145, <8 x double> %135)
  %147 = add nuw nsw i64 %136, 1
  %148 = icmp slt i64 %147, %21
  br i1 %148, label %134, label %149, !llvm.loop !37

149:                                              ; preds = %134, %114
  %150 = phi <8 x double> [ %118, %114 ], [ %146, %134 ]
  store <8 x double> %150, ptr %111, align 8
  %151 = add nuw nsw i64 %110, 8
  %152 = icmp slt i64 %151, %11
  br i1 %152, label %109, label %153, !llvm.loop !39

153:                                              ; preds = %149, %16
  ret void
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #4

define internal fastcc void @nested(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, i64 noundef %3, i64 noundef %4, ptr noundef readonly %5, i64 noundef %6) unnamed_addr #6 {
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
  br i1 %31, label %20, label %19, !llvm.loop !40

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
  br i1 %43, label %32, label %24, !llvm.loop !41
}

declare i1 @llvm.is.fpclass.f64(double, i32 immarg) #7

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind willreturn memory(none) }
attributes #5 = { noinline nounwind }
attributes #6 = { noinline nounwind }
attributes #7 = { nounwind willreturn memory(none) }
attributes #8 = { nounwind }
attributes #9 = { nounwind }
attributes #10 = { nounwind }


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
!17 = distinct !{!17, !4, !5}
!18 = distinct !{!18, !4, !5}
!19 = distinct !{!19, !5}
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
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5}
!35 = distinct !{!35, !4, !5}
!36 = distinct !{!36, !4, !5}
!37 = distinct !{!37, !4, !5}
!38 = distinct !{!38, !4, !5}
!39 = distinct !{!39, !4, !5}
!40 = distinct !{!40, !4, !5}
!41 = distinct !{!41, !4, !5}
