; sources 8f5a7ea5f7fa35f12fda413bef2b5bd9a6c860f0d991cebdf9c307a03e85f70b
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
  br i1 %83, label %1632, label %84

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
  br label %1632

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
  br i1 %191, label %1632, label %192

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

445:                                              ; preds = %1629, %345
  %446 = phi double [ %346, %345 ], [ %1625, %1629 ]
  store double %446, ptr %118, align 8
  br label %1632

447:                                              ; preds = %349, %1629
  %448 = phi i64 [ %347, %349 ], [ %1630, %1629 ]
  %449 = phi i64 [ undef, %349 ], [ %1628, %1629 ]
  %450 = phi double [ %117, %349 ], [ %1626, %1629 ]
  %451 = phi double [ %346, %349 ], [ %1625, %1629 ]
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
  br label %1632

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
  br label %1632

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
  br label %1624

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
  br i1 %679, label %1624, label %680

680:                                              ; preds = %677
  %681 = icmp eq i64 %678, 0
  br i1 %681, label %682, label %873

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
  br i1 %845, label %873, label %846

846:                                              ; preds = %842
  br i1 %95, label %854, label %847

847:                                              ; preds = %846
  %848 = load ptr, ptr %92, align 8
  %849 = getelementptr inbounds i8, ptr %848, i64 56
  %850 = load i64, ptr %849, align 8
  %851 = inttoptr i64 %850 to ptr
  %852 = tail call i64 %851(ptr noundef %0, double noundef %498, ptr noundef %78) #9
  %853 = icmp ne i64 %852, 0
  br label %854

854:                                              ; preds = %847, %846
  %855 = phi i1 [ false, %846 ], [ %853, %847 ]
  br i1 %855, label %873, label %856

856:                                              ; preds = %854
  %857 = load i64, ptr %356, align 8
  %858 = add nsw i64 %857, 1
  store i64 %858, ptr %356, align 8
  %859 = load ptr, ptr %391, align 8
  store double %498, ptr %859, align 8
  %860 = load i64, ptr %392, align 8
  %861 = icmp sgt i64 %860, 0
  br i1 %861, label %862, label %863

862:                                              ; preds = %856
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %863

863:                                              ; preds = %856, %862
  %864 = load ptr, ptr %73, align 8
  %865 = load i64, ptr %864, align 8
  %866 = load ptr, ptr %391, align 8
  %867 = load ptr, ptr %393, align 8
  %868 = load ptr, ptr %394, align 8
  %869 = inttoptr i64 %865 to ptr
  %870 = tail call i32 %869(ptr noundef %866, ptr noundef %78, ptr noundef %867, ptr noundef %868, ptr noundef %116) #9
  %871 = sext i32 %870 to i64
  %872 = icmp slt i32 %870, 0
  br i1 %872, label %1624, label %873

873:                                              ; preds = %842, %863, %854, %680
  %874 = phi i64 [ 0, %854 ], [ %871, %863 ], [ 0, %842 ], [ %678, %680 ]
  %875 = phi double [ %843, %854 ], [ %843, %863 ], [ %843, %842 ], [ 0.000000e+00, %680 ]
  %876 = phi i1 [ %855, %854 ], [ %855, %863 ], [ false, %842 ], [ false, %680 ]
  %877 = icmp ne i64 %874, 0
  %878 = fcmp uge double %875, 1.000000e+00
  %879 = or i1 %877, %878
  %880 = or i1 %876, %879
  br i1 %880, label %881, label %944

881:                                              ; preds = %873
  %882 = load i64, ptr %352, align 8
  %883 = add nsw i64 %882, 1
  store i64 %883, ptr %352, align 8
  %884 = or i1 %877, %876
  br i1 %884, label %888, label %885

885:                                              ; preds = %881
  %886 = tail call double @llvm.fabs.f64(double %875)
  %887 = fcmp one double %886, 0x7FF0000000000000
  br label %888

888:                                              ; preds = %885, %881
  %889 = phi i1 [ false, %881 ], [ %887, %885 ]
  %890 = select i1 %889, i64 2, i64 4
  %891 = select i1 %876, i64 6, i64 %890
  %892 = select i1 %877, i64 3, i64 %891
  store i64 %892, ptr %441, align 8
  %893 = fcmp ogt double %875, 1.000000e-10
  %894 = select i1 %893, double %875, double 1.000000e-10
  %895 = load double, ptr %442, align 8
  %896 = load double, ptr %88, align 8
  %897 = fneg double %896
  %898 = bitcast double %894 to i64
  %899 = add nsw i64 %898, -4604544271217802189
  %900 = ashr i64 %899, 52
  %901 = and i64 %899, -4503599627370496
  %902 = sub nsw i64 %898, %901
  %903 = bitcast i64 %902 to double
  %904 = fadd double %903, -1.000000e+00
  %905 = fadd double %903, 1.000000e+00
  %906 = fdiv double %904, %905
  %907 = fmul double %906, %906
  %908 = tail call double @llvm.fma.f64(double %907, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %909 = tail call double @llvm.fma.f64(double %908, double %907, double 0x3FE2776C50EF9BFE)
  %910 = tail call double @llvm.fma.f64(double %909, double %907, double 0x3FEEC709DC3A03FD)
  %911 = tail call double @llvm.fma.f64(double %910, double %907, double 0x40071547652B82FE)
  %912 = trunc nsw i64 %900 to i32
  %913 = sitofp i32 %912 to double
  %914 = fmul double %906, %911
  %915 = fadd double %914, %913
  %916 = fmul double %915, %897
  %917 = fcmp ogt double %916, -1.000000e+03
  %918 = select i1 %917, double %916, double -1.000000e+03
  %919 = fcmp olt double %918, 1.000000e+03
  %920 = select i1 %919, double %918, double 1.000000e+03
  %921 = tail call double @llvm.rint.f64(double %920)
  %922 = fsub double %920, %921
  %923 = tail call double @llvm.fma.f64(double %922, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %924 = tail call double @llvm.fma.f64(double %923, double %922, double 0x3F55D87FE78A6730)
  %925 = tail call double @llvm.fma.f64(double %924, double %922, double 0x3F83B2AB6FBA4E77)
  %926 = tail call double @llvm.fma.f64(double %925, double %922, double 0x3FAC6B08D704A0BF)
  %927 = tail call double @llvm.fma.f64(double %926, double %922, double 0x3FCEBFBDFF82C58E)
  %928 = tail call double @llvm.fma.f64(double %927, double %922, double 0x3FE62E42FEFA39EF)
  %929 = tail call double @llvm.fma.f64(double %928, double %922, double 1.000000e+00)
  %930 = bitcast double %929 to i64
  %931 = fptosi double %921 to i32
  %932 = sext i32 %931 to i64
  %933 = shl nsw i64 %932, 52
  %934 = add nsw i64 %933, %930
  %935 = bitcast i64 %934 to double
  %936 = fmul double %895, %935
  %937 = load double, ptr %443, align 8
  %938 = fcmp ogt double %936, %937
  %939 = select i1 %938, double %936, double %937
  %940 = select i1 %889, double %939, double 2.500000e-01
  %941 = fmul double %497, %940
  br i1 %98, label %942, label %943

942:                                              ; preds = %888
  store double %497, ptr %118, align 8
  br label %1624

943:                                              ; preds = %888
  store double 1.000000e+00, ptr %444, align 8
  br label %1624, !llvm.loop !19

944:                                              ; preds = %873
  %945 = load i64, ptr %351, align 8
  %946 = add nsw i64 %945, 1
  store i64 %946, ptr %351, align 8
  store double %498, ptr %76, align 8
  store double %497, ptr %395, align 8
  %947 = load ptr, ptr %350, align 8
  %948 = getelementptr inbounds i8, ptr %947, i64 8
  %949 = load i64, ptr %948, align 8
  %950 = icmp eq i64 %949, 0
  br i1 %950, label %980, label %951

951:                                              ; preds = %944
  %952 = load i64, ptr %947, align 8
  %953 = load ptr, ptr %73, align 8
  %954 = getelementptr inbounds i8, ptr %953, i64 8
  %955 = load i64, ptr %954, align 8
  %956 = load ptr, ptr %396, align 8
  %957 = load i64, ptr %397, align 8
  %958 = mul nsw i64 %957, %952
  %959 = getelementptr inbounds double, ptr %956, i64 %958
  %960 = getelementptr inbounds double, ptr %959, i64 %957
  store double %450, ptr %959, align 8
  %961 = getelementptr inbounds i8, ptr %959, i64 8
  store double %497, ptr %961, align 8
  store double %498, ptr %960, align 8
  %962 = getelementptr inbounds i8, ptr %960, i64 8
  store double 0.000000e+00, ptr %962, align 8
  %963 = icmp sgt i64 %955, 0
  br i1 %963, label %967, label %964

964:                                              ; preds = %967, %951
  %965 = add nsw i64 %952, 1
  %966 = load ptr, ptr %350, align 8
  store i64 %965, ptr %966, align 8
  br label %980

967:                                              ; preds = %951, %967
  %968 = phi i64 [ %978, %967 ], [ 0, %951 ]
  %969 = load ptr, ptr %74, align 8
  %970 = getelementptr inbounds double, ptr %969, i64 %968
  %971 = load double, ptr %970, align 8
  %972 = add nuw nsw i64 %968, 2
  %973 = getelementptr inbounds double, ptr %959, i64 %972
  store double %971, ptr %973, align 8
  %974 = load ptr, ptr %77, align 8
  %975 = getelementptr inbounds double, ptr %974, i64 %968
  %976 = load double, ptr %975, align 8
  %977 = getelementptr inbounds double, ptr %960, i64 %972
  store double %976, ptr %977, align 8
  %978 = add nuw nsw i64 %968, 1
  %979 = icmp eq i64 %978, %955
  br i1 %979, label %964, label %967, !llvm.loop !20

980:                                              ; preds = %944, %964
  br i1 %106, label %981, label %1098

981:                                              ; preds = %980
  %982 = load ptr, ptr %102, align 8
  %983 = getelementptr inbounds i8, ptr %982, i64 8
  %984 = load i64, ptr %983, align 8
  %985 = load i64, ptr %399, align 8
  %986 = add i64 %985, -1
  %987 = load ptr, ptr %400, align 8
  %988 = shl nsw i64 %984, 4
  %989 = getelementptr inbounds i8, ptr %987, i64 %988
  %990 = mul i64 %984, 88
  %991 = getelementptr inbounds i8, ptr %987, i64 %990
  %992 = getelementptr inbounds double, ptr %987, i64 %984
  %993 = load i64, ptr %401, align 8
  %994 = icmp eq i64 %993, 0
  br i1 %994, label %1098, label %995

995:                                              ; preds = %981
  %996 = load double, ptr %991, align 8
  %997 = fcmp une double %996, %450
  br i1 %997, label %1098, label %998

998:                                              ; preds = %995
  %999 = icmp sgt i64 %984, 0
  br i1 %999, label %1000, label %1055

1000:                                             ; preds = %998
  %1001 = load ptr, ptr %398, align 8
  %1002 = icmp sgt i64 %985, 1
  br label %1006

1003:                                             ; preds = %1013
  %1004 = add nuw nsw i64 %1007, 1
  %1005 = icmp eq i64 %1004, %984
  br i1 %1005, label %1055, label %1006, !llvm.loop !21

1006:                                             ; preds = %1000, %1003
  %1007 = phi i64 [ 0, %1000 ], [ %1004, %1003 ]
  %1008 = mul nsw i64 %1007, %985
  %1009 = getelementptr inbounds double, ptr %1001, i64 %1008
  %1010 = getelementptr inbounds double, ptr %1009, i64 %986
  %1011 = load double, ptr %1010, align 8
  %1012 = tail call double @llvm.fabs.f64(double %1011)
  br i1 %1002, label %1021, label %1013

1013:                                             ; preds = %1051, %1006
  %1014 = phi double [ %1012, %1006 ], [ %1052, %1051 ]
  %1015 = getelementptr inbounds double, ptr %989, i64 %1007
  %1016 = load double, ptr %1015, align 8
  %1017 = tail call double @llvm.fabs.f64(double %1016)
  %1018 = fmul double %1014, 8.000000e+00
  %1019 = fmul double %497, %1018
  %1020 = fcmp ogt double %1017, %1019
  br i1 %1020, label %1003, label %1098

1021:                                             ; preds = %1006, %1051
  %1022 = phi i64 [ %1053, %1051 ], [ 0, %1006 ]
  %1023 = phi double [ %1052, %1051 ], [ %1012, %1006 ]
  %1024 = getelementptr inbounds double, ptr %1009, i64 %1022
  %1025 = load double, ptr %1024, align 8
  %1026 = fcmp oeq double %1025, 0.000000e+00
  br i1 %1026, label %1051, label %1027

1027:                                             ; preds = %1021
  %1028 = load ptr, ptr %0, align 8
  %1029 = load i64, ptr %1028, align 8
  %1030 = icmp slt i64 %1029, 0
  br i1 %1030, label %1035, label %1031

1031:                                             ; preds = %1027
  %1032 = load ptr, ptr %112, align 8
  %1033 = load i64, ptr %90, align 8
  %1034 = getelementptr double, ptr %1032, i64 %1022
  br label %1040

1035:                                             ; preds = %1040, %1027
  %1036 = phi double [ 0.000000e+00, %1027 ], [ %1048, %1040 ]
  %1037 = tail call double @llvm.fabs.f64(double %1025)
  %1038 = fmul double %1037, %1036
  %1039 = fadd double %1023, %1038
  br label %1051

1040:                                             ; preds = %1031, %1040
  %1041 = phi i64 [ 0, %1031 ], [ %1049, %1040 ]
  %1042 = phi double [ 0.000000e+00, %1031 ], [ %1048, %1040 ]
  %1043 = mul nsw i64 %1033, %1041
  %1044 = getelementptr double, ptr %1034, i64 %1043
  %1045 = load double, ptr %1044, align 8
  %1046 = tail call double @llvm.fabs.f64(double %1045)
  %1047 = fcmp ogt double %1042, %1046
  %1048 = select i1 %1047, double %1042, double %1046
  %1049 = add nuw i64 %1041, 1
  %1050 = icmp eq i64 %1041, %1029
  br i1 %1050, label %1035, label %1040, !llvm.loop !22

1051:                                             ; preds = %1035, %1021
  %1052 = phi double [ %1023, %1021 ], [ %1039, %1035 ]
  %1053 = add nuw nsw i64 %1022, 1
  %1054 = icmp eq i64 %1053, %986
  br i1 %1054, label %1013, label %1021, !llvm.loop !23

1055:                                             ; preds = %1003, %998
  %1056 = load ptr, ptr %402, align 8
  store double %498, ptr %1056, align 8
  %1057 = load i64, ptr %403, align 8
  %1058 = icmp sgt i64 %1057, 0
  br i1 %1058, label %1059, label %1060

1059:                                             ; preds = %1055
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %1060

1060:                                             ; preds = %1055, %1059
  %1061 = load ptr, ptr %102, align 8
  %1062 = load i64, ptr %1061, align 8
  %1063 = load ptr, ptr %404, align 8
  %1064 = load ptr, ptr %77, align 8
  %1065 = load ptr, ptr %405, align 8
  %1066 = load ptr, ptr %406, align 8
  %1067 = load ptr, ptr %400, align 8
  %1068 = getelementptr inbounds double, ptr %1067, i64 %984
  %1069 = inttoptr i64 %1062 to ptr
  %1070 = tail call i32 %1069(ptr noundef %1063, ptr noundef %1064, ptr noundef %1065, ptr noundef %1066, ptr noundef %1068) #9
  %1071 = icmp slt i32 %1070, 0
  br i1 %1071, label %1098, label %1072

1072:                                             ; preds = %1060
  %1073 = icmp sgt i64 %984, 0
  br i1 %1073, label %1074, label %1079

1074:                                             ; preds = %1072
  %1075 = load ptr, ptr %407, align 8
  br label %1081

1076:                                             ; preds = %1081
  %1077 = add nuw nsw i64 %1082, 1
  %1078 = icmp eq i64 %1077, %984
  br i1 %1078, label %1079, label %1081, !llvm.loop !24

1079:                                             ; preds = %1076, %1072
  %1080 = icmp sgt i64 %984, 0
  br i1 %1080, label %1091, label %1090

1081:                                             ; preds = %1074, %1076
  %1082 = phi i64 [ 0, %1074 ], [ %1077, %1076 ]
  %1083 = getelementptr inbounds double, ptr %992, i64 %1082
  %1084 = load double, ptr %1083, align 8
  %1085 = getelementptr inbounds i64, ptr %1075, i64 %1082
  %1086 = load i64, ptr %1085, align 8
  %1087 = sitofp i64 %1086 to double
  %1088 = fmul double %1084, %1087
  %1089 = fcmp ogt double %1088, 0.000000e+00
  br i1 %1089, label %1076, label %1098

1090:                                             ; preds = %1091, %1079
  store double %498, ptr %991, align 8
  br label %1098

1091:                                             ; preds = %1079, %1091
  %1092 = phi i64 [ %1096, %1091 ], [ 0, %1079 ]
  %1093 = getelementptr inbounds double, ptr %992, i64 %1092
  %1094 = load double, ptr %1093, align 8
  %1095 = getelementptr inbounds double, ptr %989, i64 %1092
  store double %1094, ptr %1095, align 8
  %1096 = add nuw nsw i64 %1092, 1
  %1097 = icmp eq i64 %1096, %984
  br i1 %1097, label %1090, label %1091, !llvm.loop !25

1098:                                             ; preds = %1013, %1081, %1090, %1060, %995, %981, %980
  %1099 = phi i1 [ false, %980 ], [ false, %1090 ], [ true, %995 ], [ true, %981 ], [ true, %1060 ], [ true, %1081 ], [ true, %1013 ]
  br i1 %1099, label %1142, label %1100

1100:                                             ; preds = %1098
  %1101 = load i64, ptr %408, align 8
  %1102 = getelementptr inbounds double, ptr %86, i64 %1101
  %1103 = load double, ptr %1102, align 8
  %1104 = fcmp ult double %1103, %498
  br i1 %1104, label %1142, label %1105

1105:                                             ; preds = %1100
  %1106 = load ptr, ptr %73, align 8
  %1107 = getelementptr inbounds i8, ptr %1106, i64 8
  %1108 = load i64, ptr %1107, align 8
  %1109 = load i64, ptr %107, align 8
  %1110 = load ptr, ptr %85, align 8
  %1111 = load ptr, ptr %79, align 8
  %1112 = getelementptr inbounds i8, ptr %1111, i64 48
  %1113 = load i64, ptr %1112, align 8
  %1114 = icmp slt i64 %1113, %1109
  br i1 %1114, label %1115, label %1138

1115:                                             ; preds = %1105
  %1116 = icmp sgt i64 %1108, 0
  br label %1117

1117:                                             ; preds = %1115, %1128
  %1118 = phi i64 [ %1113, %1115 ], [ %1129, %1128 ]
  %1119 = getelementptr inbounds double, ptr %1110, i64 %1118
  %1120 = load double, ptr %1119, align 8
  %1121 = load ptr, ptr %75, align 8
  %1122 = load double, ptr %1121, align 8
  %1123 = fcmp ugt double %1120, %1122
  br i1 %1123, label %1138, label %1124

1124:                                             ; preds = %1117
  br i1 %1116, label %1125, label %1128

1125:                                             ; preds = %1124
  %1126 = mul nsw i64 %1118, %1108
  %1127 = getelementptr double, ptr %1, i64 %1126
  br label %1131

1128:                                             ; preds = %1131, %1124
  %1129 = add i64 %1118, 1
  %1130 = icmp eq i64 %1129, %1109
  br i1 %1130, label %1138, label %1117, !llvm.loop !8

1131:                                             ; preds = %1125, %1131
  %1132 = phi i64 [ 0, %1125 ], [ %1136, %1131 ]
  %1133 = getelementptr inbounds double, ptr %78, i64 %1132
  %1134 = load double, ptr %1133, align 8
  %1135 = getelementptr double, ptr %1127, i64 %1132
  store double %1134, ptr %1135, align 8
  %1136 = add nuw nsw i64 %1132, 1
  %1137 = icmp eq i64 %1136, %1108
  br i1 %1137, label %1128, label %1131, !llvm.loop !9

1138:                                             ; preds = %1117, %1128, %1105
  %1139 = phi i64 [ %1113, %1105 ], [ %1118, %1117 ], [ %1109, %1128 ]
  %1140 = load ptr, ptr %79, align 8
  %1141 = getelementptr inbounds i8, ptr %1140, i64 48
  store i64 %1139, ptr %1141, align 8
  br label %1501

1142:                                             ; preds = %1100, %1098
  %1143 = load ptr, ptr %0, align 8
  %1144 = load ptr, ptr %73, align 8
  %1145 = getelementptr inbounds i8, ptr %1144, i64 16
  %1146 = load i64, ptr %1145, align 8
  %1147 = load i64, ptr %1143, align 8
  %1148 = load i64, ptr %409, align 8
  %1149 = load ptr, ptr %410, align 8
  %1150 = mul nsw i64 %1148, %1147
  %1151 = getelementptr inbounds double, ptr %1149, i64 %1150
  %1152 = load ptr, ptr %411, align 8
  %1153 = add nsw i64 %1147, 1
  %1154 = getelementptr inbounds i8, ptr %1143, i64 16
  %1155 = load i64, ptr %1154, align 8
  %1156 = icmp sgt i64 %1155, 0
  br i1 %1156, label %1157, label %1211

1157:                                             ; preds = %1142
  %1158 = getelementptr inbounds i8, ptr %1143, i64 8
  br label %1164

1159:                                             ; preds = %1200
  %1160 = add nsw i64 %1167, 1
  %1161 = load i64, ptr %1154, align 8
  %1162 = add nsw i64 %1161, %1153
  %1163 = icmp slt i64 %1160, %1162
  br i1 %1163, label %1164, label %1211, !llvm.loop !26

1164:                                             ; preds = %1157, %1159
  %1165 = phi i1 [ %1156, %1157 ], [ %1163, %1159 ]
  %1166 = phi i64 [ undef, %1157 ], [ %1210, %1159 ]
  %1167 = phi i64 [ %1153, %1157 ], [ %1160, %1159 ]
  %1168 = load i64, ptr %1158, align 8
  %1169 = load ptr, ptr %412, align 8
  %1170 = load ptr, ptr %74, align 8
  %1171 = load ptr, ptr %413, align 8
  %1172 = getelementptr i64, ptr %1171, i64 %1167
  %1173 = getelementptr i64, ptr %1172, i64 %1168
  %1174 = load i64, ptr %1173, align 8
  %1175 = getelementptr i8, ptr %1173, i64 8
  %1176 = load i64, ptr %1175, align 8
  %1177 = xor i64 %1174, -1
  %1178 = add i64 %1176, %1177
  %1179 = load ptr, ptr %357, align 8
  %1180 = load ptr, ptr %410, align 8
  %1181 = load ptr, ptr %414, align 8
  %1182 = getelementptr inbounds i64, ptr %1181, i64 %1174
  %1183 = load ptr, ptr %415, align 8
  %1184 = getelementptr inbounds double, ptr %1183, i64 %1174
  tail call fastcc void @combine(ptr noundef %1169, ptr noundef %1170, ptr noundef %1179, ptr noundef %1180, ptr noundef %1182, ptr noundef %1184, i64 noundef %1178, i64 noundef 1, i64 noundef %1146) #8
  %1185 = load ptr, ptr %410, align 8
  %1186 = mul nsw i64 %1167, %1148
  %1187 = getelementptr inbounds double, ptr %1185, i64 %1186
  %1188 = load i64, ptr %356, align 8
  %1189 = add nsw i64 %1188, 1
  store i64 %1189, ptr %356, align 8
  %1190 = load ptr, ptr %416, align 8
  %1191 = getelementptr inbounds double, ptr %1190, i64 %1167
  %1192 = load double, ptr %1191, align 8
  %1193 = fmul double %497, %1192
  %1194 = fadd double %450, %1193
  %1195 = load ptr, ptr %412, align 8
  %1196 = load ptr, ptr %417, align 8
  store double %1194, ptr %1196, align 8
  %1197 = load i64, ptr %418, align 8
  %1198 = icmp sgt i64 %1197, 0
  br i1 %1198, label %1199, label %1200

1199:                                             ; preds = %1164
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %1200

1200:                                             ; preds = %1164, %1199
  %1201 = load ptr, ptr %73, align 8
  %1202 = load i64, ptr %1201, align 8
  %1203 = load ptr, ptr %417, align 8
  %1204 = load ptr, ptr %419, align 8
  %1205 = load ptr, ptr %420, align 8
  %1206 = inttoptr i64 %1202 to ptr
  %1207 = tail call i32 %1206(ptr noundef %1203, ptr noundef %1195, ptr noundef %1204, ptr noundef %1205, ptr noundef %1187) #9
  %1208 = sext i32 %1207 to i64
  %1209 = icmp eq i32 %1207, 0
  %1210 = select i1 %1209, i64 %1166, i64 %1208
  br i1 %1209, label %1159, label %1211

1211:                                             ; preds = %1159, %1200, %1142
  %1212 = phi i1 [ %1156, %1142 ], [ %1163, %1159 ], [ %1165, %1200 ]
  %1213 = phi i64 [ 0, %1142 ], [ %1208, %1200 ], [ %1208, %1159 ]
  %1214 = phi i64 [ undef, %1142 ], [ %1210, %1200 ], [ %1210, %1159 ]
  %1215 = getelementptr inbounds i8, ptr %1143, i64 16
  br i1 %1212, label %1284, label %1216

1216:                                             ; preds = %1211
  %1217 = load ptr, ptr %73, align 8
  %1218 = getelementptr inbounds i8, ptr %1217, i64 8
  %1219 = load i64, ptr %1218, align 8
  %1220 = icmp sgt i64 %1219, 0
  br i1 %1220, label %1221, label %1225

1221:                                             ; preds = %1216
  %1222 = getelementptr inbounds double, ptr %1152, i64 %1148
  %1223 = shl nsw i64 %1148, 4
  %1224 = getelementptr inbounds i8, ptr %1152, i64 %1223
  br label %1232

1225:                                             ; preds = %1232, %1216
  %1226 = getelementptr inbounds i8, ptr %1143, i64 8
  %1227 = load i64, ptr %1226, align 8
  %1228 = load i64, ptr %1215, align 8
  %1229 = getelementptr inbounds i8, ptr %1143, i64 24
  %1230 = load i64, ptr %1229, align 8
  %1231 = icmp sgt i64 %1230, 3
  br i1 %1231, label %1259, label %1284

1232:                                             ; preds = %1221, %1232
  %1233 = phi i64 [ 0, %1221 ], [ %1254, %1232 ]
  %1234 = load ptr, ptr %421, align 8
  %1235 = getelementptr inbounds double, ptr %1234, i64 %1233
  %1236 = load double, ptr %1235, align 8
  %1237 = load ptr, ptr %74, align 8
  %1238 = getelementptr inbounds double, ptr %1237, i64 %1233
  %1239 = load double, ptr %1238, align 8
  %1240 = fsub double %1236, %1239
  %1241 = load ptr, ptr %410, align 8
  %1242 = getelementptr inbounds double, ptr %1241, i64 %1233
  %1243 = load double, ptr %1242, align 8
  %1244 = fmul double %497, %1243
  %1245 = fsub double %1244, %1240
  %1246 = getelementptr inbounds double, ptr %1152, i64 %1233
  store double %1240, ptr %1246, align 8
  %1247 = getelementptr inbounds double, ptr %1222, i64 %1233
  store double %1245, ptr %1247, align 8
  %1248 = fsub double %1240, %1245
  %1249 = getelementptr inbounds double, ptr %1151, i64 %1233
  %1250 = load double, ptr %1249, align 8
  %1251 = fmul double %497, %1250
  %1252 = fsub double %1248, %1251
  %1253 = getelementptr inbounds double, ptr %1224, i64 %1233
  store double %1252, ptr %1253, align 8
  %1254 = add nuw nsw i64 %1233, 1
  %1255 = load ptr, ptr %73, align 8
  %1256 = getelementptr inbounds i8, ptr %1255, i64 8
  %1257 = load i64, ptr %1256, align 8
  %1258 = icmp slt i64 %1254, %1257
  br i1 %1258, label %1232, label %1225, !llvm.loop !27

1259:                                             ; preds = %1225, %1259
  %1260 = phi i64 [ %1281, %1259 ], [ 3, %1225 ]
  %1261 = mul nsw i64 %1260, %1148
  %1262 = getelementptr inbounds double, ptr %1152, i64 %1261
  %1263 = load ptr, ptr %422, align 8
  %1264 = load ptr, ptr %423, align 8
  %1265 = getelementptr i64, ptr %1264, i64 %1153
  %1266 = getelementptr i64, ptr %1265, i64 %1227
  %1267 = getelementptr i64, ptr %1266, i64 %1228
  %1268 = getelementptr i64, ptr %1267, i64 %1260
  %1269 = getelementptr i8, ptr %1268, i64 -24
  %1270 = load i64, ptr %1269, align 8
  %1271 = getelementptr i8, ptr %1268, i64 -16
  %1272 = load i64, ptr %1271, align 8
  %1273 = xor i64 %1270, -1
  %1274 = add i64 %1272, %1273
  %1275 = load ptr, ptr %357, align 8
  %1276 = load ptr, ptr %410, align 8
  %1277 = load ptr, ptr %424, align 8
  %1278 = getelementptr inbounds i64, ptr %1277, i64 %1270
  %1279 = load ptr, ptr %425, align 8
  %1280 = getelementptr inbounds double, ptr %1279, i64 %1270
  tail call fastcc void @combine(ptr noundef %1262, ptr noundef %1263, ptr noundef %1275, ptr noundef %1276, ptr noundef %1278, ptr noundef %1280, i64 noundef %1274, i64 noundef 1, i64 noundef %1146) #8
  %1281 = add nuw nsw i64 %1260, 1
  %1282 = load i64, ptr %1229, align 8
  %1283 = icmp slt i64 %1281, %1282
  br i1 %1283, label %1259, label %1284, !llvm.loop !28

1284:                                             ; preds = %1259, %1225, %1211
  %1285 = phi i64 [ %1214, %1211 ], [ %1213, %1225 ], [ %1213, %1259 ]
  %1286 = icmp eq i64 %1285, 0
  br i1 %1286, label %1290, label %1287

1287:                                             ; preds = %1284
  store i64 3, ptr %426, align 8
  store double %450, ptr %76, align 8
  %1288 = icmp slt i64 %1285, 0
  %1289 = select i1 %1288, i64 -4, i64 2
  br label %1624

1290:                                             ; preds = %1284
  %1291 = load ptr, ptr %75, align 8
  br i1 %1099, label %1292, label %1303

1292:                                             ; preds = %1290
  %1293 = load ptr, ptr %102, align 8
  %1294 = getelementptr inbounds i8, ptr %1293, i64 16
  %1295 = load i64, ptr %1294, align 8
  %1296 = inttoptr i64 %1295 to ptr
  %1297 = tail call i64 %1296(ptr noundef %0, double noundef %450, double noundef %497) #9
  %1298 = icmp eq i64 %1297, -6
  br i1 %1298, label %1299, label %1300

1299:                                             ; preds = %1292
  store double %450, ptr %1291, align 8
  br label %1478

1300:                                             ; preds = %1292
  %1301 = getelementptr inbounds i8, ptr %1291, i64 48
  %1302 = load double, ptr %1301, align 8
  br label %1303

1303:                                             ; preds = %1300, %1290
  %1304 = phi double [ %1302, %1300 ], [ 1.000000e+00, %1290 ]
  %1305 = phi i64 [ %1297, %1300 ], [ 0, %1290 ]
  %1306 = fcmp oeq double %1304, 1.000000e+00
  br i1 %1306, label %1307, label %1309

1307:                                             ; preds = %1303
  %1308 = load double, ptr %1291, align 8
  br label %1312

1309:                                             ; preds = %1303
  %1310 = fmul double %497, %1304
  %1311 = fadd double %450, %1310
  br label %1312

1312:                                             ; preds = %1309, %1307
  %1313 = phi double [ %1308, %1307 ], [ %1311, %1309 ]
  %1314 = icmp eq i64 %1305, -4
  %1315 = select i1 %1314, i64 -4, i64 0
  br i1 %1314, label %1373, label %1316

1316:                                             ; preds = %1312
  %1317 = fcmp olt double %1304, 1.000000e+00
  %1318 = load ptr, ptr %73, align 8
  %1319 = getelementptr inbounds i8, ptr %1318, i64 8
  %1320 = load i64, ptr %1319, align 8
  %1321 = load i64, ptr %107, align 8
  %1322 = load ptr, ptr %85, align 8
  %1323 = load ptr, ptr %79, align 8
  %1324 = getelementptr inbounds i8, ptr %1323, i64 48
  %1325 = load i64, ptr %1324, align 8
  %1326 = icmp slt i64 %1325, %1321
  br i1 %1326, label %1327, label %1369

1327:                                             ; preds = %1316, %1365
  %1328 = phi i64 [ %1366, %1365 ], [ undef, %1316 ]
  %1329 = phi i64 [ %1367, %1365 ], [ %1325, %1316 ]
  %1330 = getelementptr inbounds double, ptr %1322, i64 %1329
  %1331 = load double, ptr %1330, align 8
  %1332 = fcmp olt double %1331, %1313
  %1333 = fcmp oeq double %1331, %1313
  %1334 = and i1 %1317, %1333
  %1335 = or i1 %1332, %1334
  br i1 %1335, label %1336, label %1369

1336:                                             ; preds = %1327
  %1337 = fsub double %1331, %450
  %1338 = fdiv double %1337, %497
  %1339 = mul nsw i64 %1329, %1320
  %1340 = getelementptr inbounds double, ptr %1, i64 %1339
  %1341 = load ptr, ptr %427, align 8
  %1342 = insertelement <8 x double> poison, double %1338, i64 0
  %1343 = shufflevector <8 x double> %1342, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1343, ptr %1341, align 8
  %1344 = load ptr, ptr %74, align 8
  %1345 = load ptr, ptr %411, align 8
  %1346 = load i64, ptr %409, align 8
  %1347 = load ptr, ptr %0, align 8
  %1348 = getelementptr inbounds i8, ptr %1347, i64 24
  %1349 = load i64, ptr %1348, align 8
  %1350 = load ptr, ptr %427, align 8
  %1351 = load ptr, ptr %73, align 8
  %1352 = getelementptr inbounds i8, ptr %1351, i64 16
  %1353 = load i64, ptr %1352, align 8
  tail call fastcc void @nested(ptr noundef %1340, ptr noundef %1344, ptr noundef %1345, i64 noundef %1346, i64 noundef %1349, ptr noundef %1350, i64 noundef %1353) #8
  %1354 = load ptr, ptr %92, align 8
  %1355 = load i64, ptr %1354, align 8
  %1356 = icmp eq i64 %1355, 1
  br i1 %1356, label %1357, label %1365

1357:                                             ; preds = %1336
  %1358 = load double, ptr %1330, align 8
  %1359 = getelementptr inbounds i8, ptr %1354, i64 56
  %1360 = load i64, ptr %1359, align 8
  %1361 = inttoptr i64 %1360 to ptr
  %1362 = tail call i64 %1361(ptr noundef %0, double noundef %1358, ptr noundef %1340) #9
  %1363 = icmp eq i64 %1362, 0
  %1364 = select i1 %1363, i64 %1328, i64 %1362
  br i1 %1363, label %1365, label %1373

1365:                                             ; preds = %1357, %1336
  %1366 = phi i64 [ %1364, %1357 ], [ %1328, %1336 ]
  %1367 = add i64 %1329, 1
  %1368 = icmp eq i64 %1367, %1321
  br i1 %1368, label %1369, label %1327, !llvm.loop !29

1369:                                             ; preds = %1365, %1327, %1316
  %1370 = phi i64 [ %1325, %1316 ], [ %1321, %1365 ], [ %1329, %1327 ]
  %1371 = load ptr, ptr %79, align 8
  %1372 = getelementptr inbounds i8, ptr %1371, i64 48
  store i64 %1370, ptr %1372, align 8
  br label %1373

1373:                                             ; preds = %1357, %1369, %1312
  %1374 = phi i64 [ %1315, %1312 ], [ 0, %1369 ], [ %1364, %1357 ]
  %1375 = icmp eq i64 %1374, 0
  %1376 = icmp ne i64 %1305, 0
  %1377 = fcmp olt double %1304, 1.000000e+00
  %1378 = and i1 %1377, %1375
  %1379 = and i1 %1376, %1378
  br i1 %1379, label %1380, label %1417

1380:                                             ; preds = %1373
  %1381 = load ptr, ptr %428, align 8
  %1382 = load ptr, ptr %429, align 8
  %1383 = insertelement <8 x double> poison, double %1304, i64 0
  %1384 = shufflevector <8 x double> %1383, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1384, ptr %1382, align 8
  %1385 = load ptr, ptr %74, align 8
  %1386 = load ptr, ptr %411, align 8
  %1387 = load i64, ptr %409, align 8
  %1388 = load ptr, ptr %0, align 8
  %1389 = getelementptr inbounds i8, ptr %1388, i64 24
  %1390 = load i64, ptr %1389, align 8
  %1391 = load ptr, ptr %429, align 8
  %1392 = load ptr, ptr %73, align 8
  %1393 = getelementptr inbounds i8, ptr %1392, i64 16
  %1394 = load i64, ptr %1393, align 8
  tail call fastcc void @nested(ptr noundef %1381, ptr noundef %1385, ptr noundef %1386, i64 noundef %1387, i64 noundef %1390, ptr noundef %1391, i64 noundef %1394) #8
  %1395 = load i64, ptr %90, align 8
  %1396 = icmp sgt i64 %1395, 0
  br i1 %1396, label %1401, label %1397

1397:                                             ; preds = %1401, %1380
  %1398 = load ptr, ptr %92, align 8
  %1399 = load i64, ptr %1398, align 8
  %1400 = icmp eq i64 %1399, 1
  br i1 %1400, label %1411, label %1417

1401:                                             ; preds = %1380, %1401
  %1402 = phi i64 [ %1408, %1401 ], [ 0, %1380 ]
  %1403 = load ptr, ptr %428, align 8
  %1404 = getelementptr inbounds double, ptr %1403, i64 %1402
  %1405 = load double, ptr %1404, align 8
  %1406 = load ptr, ptr %77, align 8
  %1407 = getelementptr inbounds double, ptr %1406, i64 %1402
  store double %1405, ptr %1407, align 8
  %1408 = add nuw nsw i64 %1402, 1
  %1409 = load i64, ptr %90, align 8
  %1410 = icmp slt i64 %1408, %1409
  br i1 %1410, label %1401, label %1397, !llvm.loop !30

1411:                                             ; preds = %1397
  %1412 = load ptr, ptr %77, align 8
  %1413 = getelementptr inbounds i8, ptr %1398, i64 56
  %1414 = load i64, ptr %1413, align 8
  %1415 = inttoptr i64 %1414 to ptr
  %1416 = tail call i64 %1415(ptr noundef %0, double noundef %1313, ptr noundef %1412) #9
  br label %1417

1417:                                             ; preds = %1411, %1397, %1373
  %1418 = phi i64 [ %1416, %1411 ], [ 0, %1397 ], [ %1374, %1373 ]
  %1419 = icmp eq i64 %1418, 0
  br i1 %1419, label %1422, label %1420

1420:                                             ; preds = %1417
  store double %450, ptr %1291, align 8
  %1421 = getelementptr inbounds i8, ptr %1291, i64 8
  store double %497, ptr %1421, align 8
  br label %1478

1422:                                             ; preds = %1417
  br i1 %1306, label %1423, label %1461

1423:                                             ; preds = %1422
  %1424 = load ptr, ptr %77, align 8
  %1425 = load ptr, ptr %73, align 8
  %1426 = getelementptr inbounds i8, ptr %1425, i64 8
  %1427 = load i64, ptr %1426, align 8
  %1428 = load i64, ptr %107, align 8
  %1429 = load ptr, ptr %85, align 8
  %1430 = load ptr, ptr %79, align 8
  %1431 = getelementptr inbounds i8, ptr %1430, i64 48
  %1432 = load i64, ptr %1431, align 8
  %1433 = icmp slt i64 %1432, %1428
  br i1 %1433, label %1434, label %1457

1434:                                             ; preds = %1423
  %1435 = icmp sgt i64 %1427, 0
  br label %1436

1436:                                             ; preds = %1434, %1447
  %1437 = phi i64 [ %1432, %1434 ], [ %1448, %1447 ]
  %1438 = getelementptr inbounds double, ptr %1429, i64 %1437
  %1439 = load double, ptr %1438, align 8
  %1440 = load ptr, ptr %75, align 8
  %1441 = load double, ptr %1440, align 8
  %1442 = fcmp ugt double %1439, %1441
  br i1 %1442, label %1457, label %1443

1443:                                             ; preds = %1436
  br i1 %1435, label %1444, label %1447

1444:                                             ; preds = %1443
  %1445 = mul nsw i64 %1437, %1427
  %1446 = getelementptr double, ptr %1, i64 %1445
  br label %1450

1447:                                             ; preds = %1450, %1443
  %1448 = add i64 %1437, 1
  %1449 = icmp eq i64 %1448, %1428
  br i1 %1449, label %1457, label %1436, !llvm.loop !8

1450:                                             ; preds = %1444, %1450
  %1451 = phi i64 [ 0, %1444 ], [ %1455, %1450 ]
  %1452 = getelementptr inbounds double, ptr %1424, i64 %1451
  %1453 = load double, ptr %1452, align 8
  %1454 = getelementptr double, ptr %1446, i64 %1451
  store double %1453, ptr %1454, align 8
  %1455 = add nuw nsw i64 %1451, 1
  %1456 = icmp eq i64 %1455, %1427
  br i1 %1456, label %1447, label %1450, !llvm.loop !9

1457:                                             ; preds = %1447, %1436, %1423
  %1458 = phi i64 [ %1432, %1423 ], [ %1428, %1447 ], [ %1437, %1436 ]
  %1459 = load ptr, ptr %79, align 8
  %1460 = getelementptr inbounds i8, ptr %1459, i64 48
  store i64 %1458, ptr %1460, align 8
  br label %1461

1461:                                             ; preds = %1457, %1422
  br i1 %1376, label %1462, label %1478

1462:                                             ; preds = %1461
  %1463 = load i64, ptr %90, align 8
  %1464 = icmp sgt i64 %1463, 0
  br i1 %1464, label %1468, label %1465

1465:                                             ; preds = %1468, %1462
  store double %1313, ptr %1291, align 8
  %1466 = getelementptr inbounds i8, ptr %1291, i64 8
  store double 0.000000e+00, ptr %1466, align 8
  %1467 = load ptr, ptr %79, align 8
  store i64 0, ptr %1467, align 8
  br label %1478

1468:                                             ; preds = %1462, %1468
  %1469 = phi i64 [ %1475, %1468 ], [ 0, %1462 ]
  %1470 = load ptr, ptr %77, align 8
  %1471 = getelementptr inbounds double, ptr %1470, i64 %1469
  %1472 = load double, ptr %1471, align 8
  %1473 = load ptr, ptr %74, align 8
  %1474 = getelementptr inbounds double, ptr %1473, i64 %1469
  store double %1472, ptr %1474, align 8
  %1475 = add nuw nsw i64 %1469, 1
  %1476 = load i64, ptr %90, align 8
  %1477 = icmp slt i64 %1475, %1476
  br i1 %1477, label %1468, label %1465, !llvm.loop !31

1478:                                             ; preds = %1299, %1420, %1461, %1465
  %1479 = phi i64 [ -6, %1299 ], [ %1418, %1420 ], [ %1305, %1465 ], [ %1305, %1461 ]
  %1480 = icmp eq i64 %1479, -6
  br i1 %1480, label %1485, label %1481

1481:                                             ; preds = %1478
  %1482 = icmp ne i64 %1479, 6
  %1483 = select i1 %1482, i1 true, i1 %98
  %1484 = select i1 %1483, i1 true, i1 %106
  br i1 %1484, label %1495, label %1485

1485:                                             ; preds = %1481, %1478
  %1486 = phi i64 [ %1479, %1481 ], [ 2, %1478 ]
  %1487 = load i64, ptr %351, align 8
  %1488 = add nsw i64 %1487, -1
  store i64 %1488, ptr %351, align 8
  %1489 = load ptr, ptr %350, align 8
  %1490 = load i64, ptr %1489, align 8
  %1491 = add nsw i64 %1490, -1
  store i64 %1491, ptr %1489, align 8
  %1492 = load i64, ptr %352, align 8
  %1493 = add nsw i64 %1492, 1
  store i64 %1493, ptr %352, align 8
  store i64 %1486, ptr %439, align 8
  store double 1.000000e+00, ptr %440, align 8
  %1494 = fmul double %497, 2.500000e-01
  br label %1624, !llvm.loop !19

1495:                                             ; preds = %1481
  %1496 = icmp eq i64 %1479, 0
  br i1 %1496, label %1501, label %1497

1497:                                             ; preds = %1495
  %1498 = load ptr, ptr %350, align 8
  %1499 = load i64, ptr %1498, align 8
  %1500 = add nsw i64 %1499, 1
  store i64 %1500, ptr %1498, align 8
  br label %1624

1501:                                             ; preds = %1495, %1138
  br i1 %98, label %1605, label %1502

1502:                                             ; preds = %1501
  %1503 = load double, ptr %431, align 8
  %1504 = fcmp ogt double %875, 1.000000e-10
  %1505 = select i1 %1504, double %875, double 1.000000e-10
  %1506 = load double, ptr %432, align 8
  %1507 = load double, ptr %433, align 8
  %1508 = fneg double %1507
  %1509 = bitcast double %1505 to i64
  %1510 = add nsw i64 %1509, -4604544271217802189
  %1511 = ashr i64 %1510, 52
  %1512 = and i64 %1510, -4503599627370496
  %1513 = sub nsw i64 %1509, %1512
  %1514 = bitcast i64 %1513 to double
  %1515 = fadd double %1514, -1.000000e+00
  %1516 = fadd double %1514, 1.000000e+00
  %1517 = fdiv double %1515, %1516
  %1518 = fmul double %1517, %1517
  %1519 = tail call double @llvm.fma.f64(double %1518, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1520 = tail call double @llvm.fma.f64(double %1519, double %1518, double 0x3FE2776C50EF9BFE)
  %1521 = tail call double @llvm.fma.f64(double %1520, double %1518, double 0x3FEEC709DC3A03FD)
  %1522 = tail call double @llvm.fma.f64(double %1521, double %1518, double 0x40071547652B82FE)
  %1523 = trunc nsw i64 %1511 to i32
  %1524 = sitofp i32 %1523 to double
  %1525 = fmul double %1517, %1522
  %1526 = fadd double %1525, %1524
  %1527 = fmul double %1526, %1508
  %1528 = fcmp ogt double %1527, -1.000000e+03
  %1529 = select i1 %1528, double %1527, double -1.000000e+03
  %1530 = fcmp olt double %1529, 1.000000e+03
  %1531 = select i1 %1530, double %1529, double 1.000000e+03
  %1532 = tail call double @llvm.rint.f64(double %1531)
  %1533 = fsub double %1531, %1532
  %1534 = tail call double @llvm.fma.f64(double %1533, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1535 = tail call double @llvm.fma.f64(double %1534, double %1533, double 0x3F55D87FE78A6730)
  %1536 = tail call double @llvm.fma.f64(double %1535, double %1533, double 0x3F83B2AB6FBA4E77)
  %1537 = tail call double @llvm.fma.f64(double %1536, double %1533, double 0x3FAC6B08D704A0BF)
  %1538 = tail call double @llvm.fma.f64(double %1537, double %1533, double 0x3FCEBFBDFF82C58E)
  %1539 = tail call double @llvm.fma.f64(double %1538, double %1533, double 0x3FE62E42FEFA39EF)
  %1540 = tail call double @llvm.fma.f64(double %1539, double %1533, double 1.000000e+00)
  %1541 = bitcast double %1540 to i64
  %1542 = fptosi double %1532 to i32
  %1543 = sext i32 %1542 to i64
  %1544 = shl nsw i64 %1543, 52
  %1545 = add nsw i64 %1544, %1541
  %1546 = bitcast i64 %1545 to double
  %1547 = fmul double %1506, %1546
  %1548 = load double, ptr %434, align 8
  %1549 = fcmp une double %1548, 0.000000e+00
  br i1 %1549, label %1550, label %1590

1550:                                             ; preds = %1502
  %1551 = load i64, ptr %430, align 8
  %1552 = add nsw i64 %1551, -4604544271217802189
  %1553 = ashr i64 %1552, 52
  %1554 = and i64 %1552, -4503599627370496
  %1555 = sub nsw i64 %1551, %1554
  %1556 = bitcast i64 %1555 to double
  %1557 = fadd double %1556, -1.000000e+00
  %1558 = fadd double %1556, 1.000000e+00
  %1559 = fdiv double %1557, %1558
  %1560 = fmul double %1559, %1559
  %1561 = tail call double @llvm.fma.f64(double %1560, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1562 = tail call double @llvm.fma.f64(double %1561, double %1560, double 0x3FE2776C50EF9BFE)
  %1563 = tail call double @llvm.fma.f64(double %1562, double %1560, double 0x3FEEC709DC3A03FD)
  %1564 = tail call double @llvm.fma.f64(double %1563, double %1560, double 0x40071547652B82FE)
  %1565 = trunc nsw i64 %1553 to i32
  %1566 = sitofp i32 %1565 to double
  %1567 = fmul double %1559, %1564
  %1568 = fadd double %1567, %1566
  %1569 = fmul double %1548, %1568
  %1570 = fcmp ogt double %1569, -1.000000e+03
  %1571 = select i1 %1570, double %1569, double -1.000000e+03
  %1572 = fcmp olt double %1571, 1.000000e+03
  %1573 = select i1 %1572, double %1571, double 1.000000e+03
  %1574 = tail call double @llvm.rint.f64(double %1573)
  %1575 = fsub double %1573, %1574
  %1576 = tail call double @llvm.fma.f64(double %1575, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1577 = tail call double @llvm.fma.f64(double %1576, double %1575, double 0x3F55D87FE78A6730)
  %1578 = tail call double @llvm.fma.f64(double %1577, double %1575, double 0x3F83B2AB6FBA4E77)
  %1579 = tail call double @llvm.fma.f64(double %1578, double %1575, double 0x3FAC6B08D704A0BF)
  %1580 = tail call double @llvm.fma.f64(double %1579, double %1575, double 0x3FCEBFBDFF82C58E)
  %1581 = tail call double @llvm.fma.f64(double %1580, double %1575, double 0x3FE62E42FEFA39EF)
  %1582 = tail call double @llvm.fma.f64(double %1581, double %1575, double 1.000000e+00)
  %1583 = bitcast double %1582 to i64
  %1584 = fptosi double %1574 to i32
  %1585 = sext i32 %1584 to i64
  %1586 = shl nsw i64 %1585, 52
  %1587 = add nsw i64 %1586, %1583
  %1588 = bitcast i64 %1587 to double
  %1589 = fmul double %1547, %1588
  br label %1590

1590:                                             ; preds = %1502, %1550
  %1591 = phi double [ %1589, %1550 ], [ %1547, %1502 ]
  %1592 = load double, ptr %435, align 8
  %1593 = fcmp ogt double %1591, %1592
  %1594 = select i1 %1593, double %1591, double %1592
  %1595 = fcmp olt double %1503, %1594
  %1596 = select i1 %1595, double %1503, double %1594
  %1597 = fmul double %497, %1596
  %1598 = fcmp oeq double %498, %111
  %1599 = fcmp ogt double %451, %1597
  %1600 = select i1 %1598, i1 %1599, i1 false
  %1601 = select i1 %1600, double %451, double %1597
  %1602 = fcmp ogt double %875, 1.000000e-04
  %1603 = select i1 %1602, double %875, double 1.000000e-04
  store double %1603, ptr %430, align 8
  %1604 = load double, ptr %436, align 8
  store double %1604, ptr %431, align 8
  br label %1605

1605:                                             ; preds = %1590, %1501
  %1606 = phi double [ %1601, %1590 ], [ %451, %1501 ]
  br i1 %437, label %1611, label %1607

1607:                                             ; preds = %1611, %1605
  %1608 = load i64, ptr %438, align 8
  %1609 = load i64, ptr %107, align 8
  %1610 = icmp eq i64 %1608, %1609
  br i1 %1610, label %1623, label %1624

1611:                                             ; preds = %1605, %1611
  %1612 = phi i64 [ %1621, %1611 ], [ 0, %1605 ]
  %1613 = getelementptr inbounds double, ptr %78, i64 %1612
  %1614 = load double, ptr %1613, align 8
  %1615 = load ptr, ptr %74, align 8
  %1616 = getelementptr inbounds double, ptr %1615, i64 %1612
  store double %1614, ptr %1616, align 8
  %1617 = getelementptr inbounds double, ptr %116, i64 %1612
  %1618 = load double, ptr %1617, align 8
  %1619 = load ptr, ptr %112, align 8
  %1620 = getelementptr inbounds double, ptr %1619, i64 %1612
  store double %1618, ptr %1620, align 8
  %1621 = add nuw nsw i64 %1612, 1
  %1622 = icmp eq i64 %1621, %91
  br i1 %1622, label %1607, label %1611, !llvm.loop !32

1623:                                             ; preds = %1607
  store double %1606, ptr %118, align 8
  br label %1624

1624:                                             ; preds = %863, %943, %942, %1607, %1623, %1497, %1485, %1287, %677, %504
  %1625 = phi double [ %451, %504 ], [ %451, %677 ], [ %451, %863 ], [ %941, %943 ], [ %941, %942 ], [ %451, %1287 ], [ %1494, %1485 ], [ %451, %1497 ], [ %1606, %1623 ], [ %1606, %1607 ]
  %1626 = phi double [ %450, %504 ], [ %450, %677 ], [ %450, %863 ], [ %450, %943 ], [ %450, %942 ], [ %450, %1287 ], [ %450, %1485 ], [ %450, %1497 ], [ %498, %1623 ], [ %498, %1607 ]
  %1627 = phi i32 [ 1, %504 ], [ 1, %677 ], [ 1, %863 ], [ 3, %943 ], [ 1, %942 ], [ 1, %1287 ], [ 3, %1485 ], [ 1, %1497 ], [ 1, %1623 ], [ 0, %1607 ]
  %1628 = phi i64 [ 2, %504 ], [ -4, %677 ], [ -4, %863 ], [ %449, %943 ], [ 2, %942 ], [ %1289, %1287 ], [ %449, %1485 ], [ %1479, %1497 ], [ 0, %1623 ], [ %449, %1607 ]
  switch i32 %1627, label %1632 [
    i32 0, label %1629
    i32 3, label %1629
  ]

1629:                                             ; preds = %1624, %1624
  %1630 = load i64, ptr %81, align 8
  %1631 = icmp eq i64 %1630, 0
  br i1 %1631, label %445, label %447, !llvm.loop !19

1632:                                             ; preds = %1624, %145, %445, %464, %472, %187, %72
  %1633 = phi i64 [ -1, %72 ], [ %148, %145 ], [ -1, %445 ], [ -5, %464 ], [ 1, %472 ], [ 0, %187 ], [ %1628, %1624 ]
  ret i64 %1633
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
