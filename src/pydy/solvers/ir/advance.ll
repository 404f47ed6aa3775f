; sources 25da0c1e77ba01d61a4d0543a2eb45c76405b05c3cdff58201d0ca4a24106eed
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
  %22 = getelementptr inbounds i8, ptr %0, i64 1008
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
  %40 = getelementptr inbounds i8, ptr %0, i64 1032
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
  %68 = getelementptr inbounds i8, ptr %0, i64 888
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
  br i1 %83, label %1506, label %84

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
  br label %1506

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
  br i1 %191, label %1506, label %192

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
  br i1 %348, label %435, label %349

349:                                              ; preds = %345
  %350 = getelementptr inbounds i8, ptr %0, i64 1056
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
  %396 = getelementptr inbounds i8, ptr %0, i64 1080
  %397 = getelementptr inbounds i8, ptr %0, i64 1096
  %398 = getelementptr inbounds i8, ptr %80, i64 48
  %399 = getelementptr inbounds i8, ptr %0, i64 320
  %400 = getelementptr inbounds i8, ptr %0, i64 480
  %401 = getelementptr inbounds i8, ptr %0, i64 504
  %402 = getelementptr inbounds i8, ptr %0, i64 360
  %403 = getelementptr inbounds i8, ptr %0, i64 24
  %404 = getelementptr inbounds i8, ptr %0, i64 48
  %405 = getelementptr inbounds i8, ptr %0, i64 72
  %406 = getelementptr inbounds i8, ptr %0, i64 96
  %407 = getelementptr inbounds i8, ptr %0, i64 168
  %408 = getelementptr inbounds i8, ptr %0, i64 248
  %409 = getelementptr inbounds i8, ptr %0, i64 192
  %410 = getelementptr inbounds i8, ptr %0, i64 216
  %411 = getelementptr inbounds i8, ptr %0, i64 336
  %412 = getelementptr inbounds i8, ptr %0, i64 432
  %413 = getelementptr inbounds i8, ptr %0, i64 24
  %414 = getelementptr inbounds i8, ptr %0, i64 48
  %415 = getelementptr inbounds i8, ptr %0, i64 72
  %416 = getelementptr inbounds i8, ptr %80, i64 72
  %417 = getelementptr inbounds i8, ptr %0, i64 408
  %418 = getelementptr inbounds i8, ptr %0, i64 360
  %419 = getelementptr inbounds i8, ptr %0, i64 408
  %420 = getelementptr inbounds i8, ptr %76, i64 24
  %421 = getelementptr inbounds i8, ptr %76, i64 40
  %422 = getelementptr inbounds i8, ptr %88, i64 24
  %423 = getelementptr inbounds i8, ptr %88, i64 8
  %424 = getelementptr inbounds i8, ptr %88, i64 16
  %425 = getelementptr inbounds i8, ptr %88, i64 32
  %426 = getelementptr inbounds i8, ptr %88, i64 40
  %427 = icmp sgt i64 %91, 0
  %428 = getelementptr inbounds i8, ptr %80, i64 48
  %429 = getelementptr inbounds i8, ptr %80, i64 72
  %430 = getelementptr inbounds i8, ptr %76, i64 40
  %431 = getelementptr inbounds i8, ptr %80, i64 72
  %432 = getelementptr inbounds i8, ptr %88, i64 24
  %433 = getelementptr inbounds i8, ptr %88, i64 32
  %434 = getelementptr inbounds i8, ptr %76, i64 40
  br label %437

435:                                              ; preds = %1503, %345
  %436 = phi double [ %346, %345 ], [ %1499, %1503 ]
  store double %436, ptr %118, align 8
  br label %1506

437:                                              ; preds = %349, %1503
  %438 = phi i64 [ %347, %349 ], [ %1504, %1503 ]
  %439 = phi i64 [ undef, %349 ], [ %1502, %1503 ]
  %440 = phi double [ %117, %349 ], [ %1500, %1503 ]
  %441 = phi double [ %346, %349 ], [ %1499, %1503 ]
  %442 = load ptr, ptr %350, align 8
  %443 = getelementptr inbounds i8, ptr %442, i64 8
  %444 = load i64, ptr %443, align 8
  %445 = icmp sgt i64 %444, 0
  br i1 %445, label %446, label %451

446:                                              ; preds = %437
  %447 = load i64, ptr %442, align 8
  %448 = add nsw i64 %447, 3
  %449 = icmp slt i64 %444, %448
  %450 = zext i1 %449 to i32
  br label %451

451:                                              ; preds = %437, %446
  %452 = phi i32 [ 0, %437 ], [ %450, %446 ]
  %453 = icmp eq i32 %452, 0
  br i1 %453, label %455, label %454

454:                                              ; preds = %451
  store double %441, ptr %118, align 8
  br label %1506

455:                                              ; preds = %451
  %456 = add nsw i64 %438, -1
  store i64 %456, ptr %81, align 8
  %457 = load i64, ptr %351, align 8
  %458 = load i64, ptr %352, align 8
  %459 = add nsw i64 %458, %457
  %460 = load i64, ptr %353, align 8
  %461 = icmp slt i64 %459, %460
  br i1 %461, label %463, label %462

462:                                              ; preds = %455
  store double %441, ptr %118, align 8
  br label %1506

463:                                              ; preds = %455
  br i1 %98, label %464, label %468

464:                                              ; preds = %463
  %465 = load i64, ptr %354, align 8
  %466 = getelementptr inbounds double, ptr %86, i64 %465
  %467 = load double, ptr %466, align 8
  br label %468

468:                                              ; preds = %463, %464
  %469 = phi double [ %467, %464 ], [ %111, %463 ]
  br i1 %98, label %474, label %470

470:                                              ; preds = %468
  %471 = load double, ptr %355, align 8
  %472 = fcmp olt double %441, %471
  %473 = select i1 %472, double %441, double %471
  br label %480

474:                                              ; preds = %468
  %475 = fsub double %469, %440
  %476 = fdiv double %475, %441
  %477 = fmul double %476, 0x3FEFFFFFFFFFDCD1
  %478 = tail call double @llvm.ceil.f64(double %477)
  %479 = fdiv double %475, %478
  br label %480

480:                                              ; preds = %474, %470
  %481 = phi double [ %473, %470 ], [ %479, %474 ]
  %482 = fadd double %440, %481
  %483 = fmul double %481, 1.000000e-03
  %484 = fsub double %469, %483
  %485 = fcmp ule double %482, %484
  %486 = fsub double %469, %440
  %487 = select i1 %485, double %481, double %486
  %488 = select i1 %485, double %482, double %469
  %489 = fmul double %487, 6.250000e-02
  %490 = fadd double %440, %489
  %491 = fcmp ule double %490, %440
  %492 = fcmp une double %488, %469
  %493 = and i1 %492, %491
  br i1 %493, label %494, label %495

494:                                              ; preds = %480
  store double %487, ptr %118, align 8
  br label %1498

495:                                              ; preds = %480
  %496 = load ptr, ptr %0, align 8
  %497 = load i64, ptr %496, align 8
  %498 = load ptr, ptr %357, align 8
  %499 = insertelement <8 x double> poison, double %487, i64 0
  %500 = shufflevector <8 x double> %499, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %500, ptr %498, align 8
  %501 = icmp sgt i64 %497, 1
  br i1 %501, label %506, label %590

502:                                              ; preds = %579
  %503 = add nuw nsw i64 %509, 1
  %504 = icmp slt i64 %503, %497
  %505 = icmp eq i64 %503, %497
  br i1 %505, label %590, label %506, !llvm.loop !12

506:                                              ; preds = %495, %502
  %507 = phi i1 [ %504, %502 ], [ %501, %495 ]
  %508 = phi i64 [ %589, %502 ], [ undef, %495 ]
  %509 = phi i64 [ %503, %502 ], [ 1, %495 ]
  %510 = load ptr, ptr %358, align 8
  %511 = load ptr, ptr %74, align 8
  %512 = load ptr, ptr %73, align 8
  %513 = getelementptr inbounds i8, ptr %512, i64 16
  %514 = load i64, ptr %513, align 8
  %515 = icmp sgt i64 %514, 1
  %516 = zext i1 %515 to i64
  %517 = load ptr, ptr %359, align 8
  %518 = getelementptr inbounds i64, ptr %517, i64 %509
  %519 = load i64, ptr %518, align 8
  %520 = getelementptr i8, ptr %518, i64 8
  %521 = load i64, ptr %520, align 8
  %522 = xor i64 %519, -1
  %523 = add i64 %521, %522
  %524 = load ptr, ptr %357, align 8
  %525 = load ptr, ptr %360, align 8
  %526 = load ptr, ptr %361, align 8
  %527 = getelementptr inbounds i64, ptr %526, i64 %519
  %528 = load ptr, ptr %362, align 8
  %529 = getelementptr inbounds double, ptr %528, i64 %519
  tail call fastcc void @combine(ptr noundef %510, ptr noundef %511, ptr noundef %524, ptr noundef %525, ptr noundef %527, ptr noundef %529, i64 noundef %523, i64 noundef %516, i64 noundef %514) #8
  %530 = icmp eq i64 %514, 1
  br i1 %530, label %531, label %562

531:                                              ; preds = %506
  %532 = load ptr, ptr %359, align 8
  %533 = getelementptr i64, ptr %532, i64 %509
  %534 = getelementptr i8, ptr %533, i64 8
  %535 = load i64, ptr %534, align 8
  %536 = add nsw i64 %535, -1
  %537 = load ptr, ptr %362, align 8
  %538 = getelementptr inbounds double, ptr %537, i64 %536
  %539 = load double, ptr %538, align 8
  %540 = fmul double %487, %539
  %541 = load ptr, ptr %360, align 8
  %542 = load ptr, ptr %361, align 8
  %543 = getelementptr inbounds i64, ptr %542, i64 %536
  %544 = load i64, ptr %543, align 8
  %545 = getelementptr inbounds double, ptr %541, i64 %544
  %546 = load ptr, ptr %73, align 8
  %547 = getelementptr inbounds i8, ptr %546, i64 8
  %548 = load i64, ptr %547, align 8
  %549 = icmp sgt i64 %548, 0
  br i1 %549, label %550, label %562

550:                                              ; preds = %531, %550
  %551 = phi i64 [ %557, %550 ], [ 0, %531 ]
  %552 = getelementptr inbounds double, ptr %545, i64 %551
  %553 = load double, ptr %552, align 8
  %554 = getelementptr inbounds double, ptr %510, i64 %551
  %555 = load double, ptr %554, align 8
  %556 = tail call double @llvm.fma.f64(double %540, double %553, double %555)
  store double %556, ptr %554, align 8
  %557 = add nuw nsw i64 %551, 1
  %558 = load ptr, ptr %73, align 8
  %559 = getelementptr inbounds i8, ptr %558, i64 8
  %560 = load i64, ptr %559, align 8
  %561 = icmp slt i64 %557, %560
  br i1 %561, label %550, label %562, !llvm.loop !13

562:                                              ; preds = %550, %531, %506
  %563 = load ptr, ptr %360, align 8
  %564 = load i64, ptr %363, align 8
  %565 = mul nsw i64 %564, %509
  %566 = getelementptr inbounds double, ptr %563, i64 %565
  %567 = load i64, ptr %356, align 8
  %568 = add nsw i64 %567, 1
  store i64 %568, ptr %356, align 8
  %569 = load ptr, ptr %364, align 8
  %570 = getelementptr inbounds double, ptr %569, i64 %509
  %571 = load double, ptr %570, align 8
  %572 = fmul double %487, %571
  %573 = fadd double %440, %572
  %574 = load ptr, ptr %358, align 8
  %575 = load ptr, ptr %365, align 8
  store double %573, ptr %575, align 8
  %576 = load i64, ptr %366, align 8
  %577 = icmp sgt i64 %576, 0
  br i1 %577, label %578, label %579

578:                                              ; preds = %562
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %579

579:                                              ; preds = %562, %578
  %580 = load ptr, ptr %73, align 8
  %581 = load i64, ptr %580, align 8
  %582 = load ptr, ptr %365, align 8
  %583 = load ptr, ptr %367, align 8
  %584 = load ptr, ptr %368, align 8
  %585 = inttoptr i64 %581 to ptr
  %586 = tail call i32 %585(ptr noundef %582, ptr noundef %574, ptr noundef %583, ptr noundef %584, ptr noundef %566) #9
  %587 = sext i32 %586 to i64
  %588 = icmp eq i32 %586, 0
  %589 = select i1 %588, i64 %508, i64 %587
  br i1 %588, label %502, label %590

590:                                              ; preds = %502, %579, %495
  %591 = phi i1 [ %501, %495 ], [ %504, %502 ], [ %507, %579 ]
  %592 = phi i64 [ 0, %495 ], [ %587, %579 ], [ %587, %502 ]
  %593 = phi i64 [ undef, %495 ], [ %589, %579 ], [ %589, %502 ]
  br i1 %591, label %647, label %594

594:                                              ; preds = %590
  %595 = load ptr, ptr %369, align 8
  %596 = load ptr, ptr %74, align 8
  %597 = load ptr, ptr %73, align 8
  %598 = getelementptr inbounds i8, ptr %597, i64 16
  %599 = load i64, ptr %598, align 8
  %600 = icmp sgt i64 %599, 1
  %601 = zext i1 %600 to i64
  %602 = load ptr, ptr %370, align 8
  %603 = getelementptr inbounds i64, ptr %602, i64 %497
  %604 = load i64, ptr %603, align 8
  %605 = getelementptr i8, ptr %603, i64 8
  %606 = load i64, ptr %605, align 8
  %607 = xor i64 %604, -1
  %608 = add i64 %606, %607
  %609 = load ptr, ptr %357, align 8
  %610 = load ptr, ptr %371, align 8
  %611 = load ptr, ptr %372, align 8
  %612 = getelementptr inbounds i64, ptr %611, i64 %604
  %613 = load ptr, ptr %373, align 8
  %614 = getelementptr inbounds double, ptr %613, i64 %604
  tail call fastcc void @combine(ptr noundef %595, ptr noundef %596, ptr noundef %609, ptr noundef %610, ptr noundef %612, ptr noundef %614, i64 noundef %608, i64 noundef %601, i64 noundef %599) #8
  %615 = icmp eq i64 %599, 1
  br i1 %615, label %616, label %647

616:                                              ; preds = %594
  %617 = load ptr, ptr %370, align 8
  %618 = getelementptr i64, ptr %617, i64 %497
  %619 = getelementptr i8, ptr %618, i64 8
  %620 = load i64, ptr %619, align 8
  %621 = add nsw i64 %620, -1
  %622 = load ptr, ptr %373, align 8
  %623 = getelementptr inbounds double, ptr %622, i64 %621
  %624 = load double, ptr %623, align 8
  %625 = fmul double %487, %624
  %626 = load ptr, ptr %371, align 8
  %627 = load ptr, ptr %372, align 8
  %628 = getelementptr inbounds i64, ptr %627, i64 %621
  %629 = load i64, ptr %628, align 8
  %630 = getelementptr inbounds double, ptr %626, i64 %629
  %631 = load ptr, ptr %73, align 8
  %632 = getelementptr inbounds i8, ptr %631, i64 8
  %633 = load i64, ptr %632, align 8
  %634 = icmp sgt i64 %633, 0
  br i1 %634, label %635, label %647

635:                                              ; preds = %616, %635
  %636 = phi i64 [ %642, %635 ], [ 0, %616 ]
  %637 = getelementptr inbounds double, ptr %630, i64 %636
  %638 = load double, ptr %637, align 8
  %639 = getelementptr inbounds double, ptr %595, i64 %636
  %640 = load double, ptr %639, align 8
  %641 = tail call double @llvm.fma.f64(double %625, double %638, double %640)
  store double %641, ptr %639, align 8
  %642 = add nuw nsw i64 %636, 1
  %643 = load ptr, ptr %73, align 8
  %644 = getelementptr inbounds i8, ptr %643, i64 8
  %645 = load i64, ptr %644, align 8
  %646 = icmp slt i64 %642, %645
  br i1 %646, label %635, label %647, !llvm.loop !13

647:                                              ; preds = %635, %616, %594, %590
  %648 = phi i64 [ %593, %590 ], [ %592, %594 ], [ %592, %616 ], [ %592, %635 ]
  %649 = icmp eq i64 %648, 0
  %650 = select i1 %649, i1 %101, i1 false
  br i1 %650, label %651, label %667

651:                                              ; preds = %647
  %652 = load i64, ptr %356, align 8
  %653 = add nsw i64 %652, 1
  store i64 %653, ptr %356, align 8
  %654 = load ptr, ptr %374, align 8
  store double %488, ptr %654, align 8
  %655 = load i64, ptr %375, align 8
  %656 = icmp sgt i64 %655, 0
  br i1 %656, label %657, label %658

657:                                              ; preds = %651
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %658

658:                                              ; preds = %651, %657
  %659 = load ptr, ptr %73, align 8
  %660 = load i64, ptr %659, align 8
  %661 = load ptr, ptr %374, align 8
  %662 = load ptr, ptr %376, align 8
  %663 = load ptr, ptr %377, align 8
  %664 = inttoptr i64 %660 to ptr
  %665 = tail call i32 %664(ptr noundef %661, ptr noundef %78, ptr noundef %662, ptr noundef %663, ptr noundef %116) #9
  %666 = sext i32 %665 to i64
  br label %667

667:                                              ; preds = %658, %647
  %668 = phi i64 [ %666, %658 ], [ %648, %647 ]
  %669 = icmp slt i64 %668, 0
  br i1 %669, label %1498, label %670

670:                                              ; preds = %667
  %671 = icmp eq i64 %668, 0
  br i1 %671, label %672, label %863

672:                                              ; preds = %670
  br i1 %98, label %673, label %674

673:                                              ; preds = %672
  br i1 %389, label %823, label %832

674:                                              ; preds = %672
  %675 = load ptr, ptr %73, align 8
  %676 = load ptr, ptr %0, align 8
  %677 = getelementptr inbounds i8, ptr %675, i64 24
  %678 = load i64, ptr %677, align 8
  %679 = getelementptr inbounds i8, ptr %676, i64 8
  %680 = load i64, ptr %679, align 8
  %681 = load ptr, ptr %378, align 8
  %682 = load i64, ptr %379, align 8
  %683 = getelementptr inbounds double, ptr %681, i64 %682
  %684 = icmp sgt i64 %680, 0
  br i1 %684, label %685, label %687

685:                                              ; preds = %674
  %686 = getelementptr inbounds i8, ptr %675, i64 32
  br label %695

687:                                              ; preds = %695, %674
  %688 = icmp sgt i64 %678, 0
  br i1 %688, label %689, label %721

689:                                              ; preds = %687
  %690 = load ptr, ptr %74, align 8
  %691 = load ptr, ptr %385, align 8
  %692 = load ptr, ptr %386, align 8
  %693 = load ptr, ptr %387, align 8
  %694 = load ptr, ptr %378, align 8
  br label %779

695:                                              ; preds = %685, %695
  %696 = phi i64 [ 0, %685 ], [ %719, %695 ]
  %697 = load i64, ptr %676, align 8
  %698 = load i64, ptr %686, align 8
  %699 = load ptr, ptr %378, align 8
  %700 = load i64, ptr %379, align 8
  %701 = mul nsw i64 %700, %696
  %702 = getelementptr inbounds double, ptr %699, i64 %701
  %703 = load ptr, ptr %380, align 8
  %704 = load ptr, ptr %381, align 8
  %705 = getelementptr i64, ptr %704, i64 %697
  %706 = getelementptr i8, ptr %705, i64 8
  %707 = getelementptr i64, ptr %706, i64 %696
  %708 = load i64, ptr %707, align 8
  %709 = getelementptr i8, ptr %707, i64 8
  %710 = load i64, ptr %709, align 8
  %711 = xor i64 %708, -1
  %712 = add i64 %710, %711
  %713 = load ptr, ptr %357, align 8
  %714 = load ptr, ptr %382, align 8
  %715 = load ptr, ptr %383, align 8
  %716 = getelementptr inbounds i64, ptr %715, i64 %708
  %717 = load ptr, ptr %384, align 8
  %718 = getelementptr inbounds double, ptr %717, i64 %708
  tail call fastcc void @combine(ptr noundef %702, ptr noundef %703, ptr noundef %713, ptr noundef %714, ptr noundef %716, ptr noundef %718, i64 noundef %712, i64 noundef 1, i64 noundef %698) #8
  %719 = add nuw nsw i64 %696, 1
  %720 = icmp eq i64 %719, %680
  br i1 %720, label %687, label %695, !llvm.loop !14

721:                                              ; preds = %779, %687
  %722 = phi double [ 0.000000e+00, %687 ], [ %807, %779 ]
  %723 = phi double [ 0.000000e+00, %687 ], [ %805, %779 ]
  %724 = load ptr, ptr %388, align 8
  %725 = getelementptr inbounds i8, ptr %675, i64 8
  %726 = load i64, ptr %725, align 8
  %727 = add nsw i64 %726, -3
  %728 = getelementptr i8, ptr %724, i64 8
  %729 = getelementptr i8, ptr %724, i64 16
  %730 = getelementptr i8, ptr %724, i64 24
  %731 = icmp slt i64 %678, %727
  br i1 %731, label %739, label %732

732:                                              ; preds = %739, %721
  %733 = phi double [ 0.000000e+00, %721 ], [ %748, %739 ]
  %734 = phi double [ 0.000000e+00, %721 ], [ %752, %739 ]
  %735 = phi double [ 0.000000e+00, %721 ], [ %756, %739 ]
  %736 = phi double [ 0.000000e+00, %721 ], [ %760, %739 ]
  %737 = phi i64 [ %678, %721 ], [ %761, %739 ]
  %738 = icmp slt i64 %737, %726
  br i1 %738, label %763, label %772

739:                                              ; preds = %721, %739
  %740 = phi i64 [ %761, %739 ], [ %678, %721 ]
  %741 = phi double [ %760, %739 ], [ 0.000000e+00, %721 ]
  %742 = phi double [ %756, %739 ], [ 0.000000e+00, %721 ]
  %743 = phi double [ %752, %739 ], [ 0.000000e+00, %721 ]
  %744 = phi double [ %748, %739 ], [ 0.000000e+00, %721 ]
  %745 = getelementptr inbounds double, ptr %724, i64 %740
  %746 = load double, ptr %745, align 8
  %747 = fmul double %746, 0.000000e+00
  %748 = fadd double %744, %747
  %749 = getelementptr double, ptr %728, i64 %740
  %750 = load double, ptr %749, align 8
  %751 = fmul double %750, 0.000000e+00
  %752 = fadd double %743, %751
  %753 = getelementptr double, ptr %729, i64 %740
  %754 = load double, ptr %753, align 8
  %755 = fmul double %754, 0.000000e+00
  %756 = fadd double %742, %755
  %757 = getelementptr double, ptr %730, i64 %740
  %758 = load double, ptr %757, align 8
  %759 = fmul double %758, 0.000000e+00
  %760 = fadd double %741, %759
  %761 = add nsw i64 %740, 4
  %762 = icmp slt i64 %761, %727
  br i1 %762, label %739, label %732, !llvm.loop !15

763:                                              ; preds = %732, %763
  %764 = phi i64 [ %770, %763 ], [ %737, %732 ]
  %765 = phi double [ %769, %763 ], [ %733, %732 ]
  %766 = getelementptr inbounds double, ptr %724, i64 %764
  %767 = load double, ptr %766, align 8
  %768 = fmul double %767, 0.000000e+00
  %769 = fadd double %765, %768
  %770 = add nsw i64 %764, 1
  %771 = icmp eq i64 %770, %726
  br i1 %771, label %772, label %763, !llvm.loop !16

772:                                              ; preds = %763, %732
  %773 = phi double [ %733, %732 ], [ %769, %763 ]
  %774 = fadd double %734, %773
  %775 = fadd double %735, %736
  %776 = fadd double %775, %774
  %777 = fadd double %723, %776
  %778 = icmp eq i64 %680, 2
  br i1 %778, label %810, label %819

779:                                              ; preds = %689, %779
  %780 = phi double [ 0.000000e+00, %689 ], [ %805, %779 ]
  %781 = phi double [ 0.000000e+00, %689 ], [ %807, %779 ]
  %782 = phi i64 [ 0, %689 ], [ %808, %779 ]
  %783 = getelementptr inbounds double, ptr %690, i64 %782
  %784 = load double, ptr %783, align 8
  %785 = getelementptr inbounds double, ptr %691, i64 %782
  %786 = load double, ptr %785, align 8
  %787 = getelementptr inbounds double, ptr %692, i64 %782
  %788 = load double, ptr %787, align 8
  %789 = getelementptr inbounds double, ptr %693, i64 %782
  %790 = load double, ptr %789, align 8
  %791 = tail call double @llvm.fabs.f64(double %784)
  %792 = tail call double @llvm.fabs.f64(double %786)
  %793 = fcmp ogt double %791, %792
  %794 = select i1 %793, double %791, double %792
  %795 = fmul double %794, %790
  %796 = fadd double %788, %795
  %797 = fdiv double 1.000000e+00, %796
  %798 = getelementptr inbounds double, ptr %694, i64 %782
  %799 = load double, ptr %798, align 8
  %800 = fmul double %799, %797
  %801 = getelementptr inbounds double, ptr %683, i64 %782
  %802 = load double, ptr %801, align 8
  %803 = fmul double %802, %797
  %804 = fmul double %800, %800
  %805 = fadd double %780, %804
  %806 = fmul double %803, %803
  %807 = fadd double %781, %806
  %808 = add nuw nsw i64 %782, 1
  %809 = icmp eq i64 %808, %678
  br i1 %809, label %721, label %779, !llvm.loop !17

810:                                              ; preds = %772
  %811 = fmul double %722, 1.000000e-02
  %812 = fadd double %811, %777
  %813 = sitofp i64 %678 to double
  %814 = fmul double %812, %813
  %815 = tail call double @llvm.sqrt.f64(double %814)
  %816 = fdiv double %777, %815
  %817 = fcmp une double %777, 0.000000e+00
  %818 = select i1 %817, double %816, double 0.000000e+00
  br label %832

819:                                              ; preds = %772
  %820 = sitofp i64 %678 to double
  %821 = fdiv double %777, %820
  %822 = tail call double @llvm.sqrt.f64(double %821)
  br label %832

823:                                              ; preds = %673, %823
  %824 = phi i64 [ %830, %823 ], [ 0, %673 ]
  %825 = phi double [ %829, %823 ], [ 0.000000e+00, %673 ]
  %826 = getelementptr inbounds double, ptr %78, i64 %824
  %827 = load double, ptr %826, align 8
  %828 = fmul double %827, 0.000000e+00
  %829 = fadd double %825, %828
  %830 = add nuw nsw i64 %824, 1
  %831 = icmp eq i64 %830, %91
  br i1 %831, label %832, label %823, !llvm.loop !18

832:                                              ; preds = %823, %673, %819, %810
  %833 = phi double [ %818, %810 ], [ %822, %819 ], [ 0.000000e+00, %673 ], [ %829, %823 ]
  %834 = fcmp uge double %833, 1.000000e+00
  %835 = select i1 %834, i1 true, i1 %390
  br i1 %835, label %863, label %836

836:                                              ; preds = %832
  br i1 %95, label %844, label %837

837:                                              ; preds = %836
  %838 = load ptr, ptr %92, align 8
  %839 = getelementptr inbounds i8, ptr %838, i64 56
  %840 = load i64, ptr %839, align 8
  %841 = inttoptr i64 %840 to ptr
  %842 = tail call i64 %841(ptr noundef %0, double noundef %488, ptr noundef %78) #9
  %843 = icmp ne i64 %842, 0
  br label %844

844:                                              ; preds = %837, %836
  %845 = phi i1 [ false, %836 ], [ %843, %837 ]
  br i1 %845, label %863, label %846

846:                                              ; preds = %844
  %847 = load i64, ptr %356, align 8
  %848 = add nsw i64 %847, 1
  store i64 %848, ptr %356, align 8
  %849 = load ptr, ptr %391, align 8
  store double %488, ptr %849, align 8
  %850 = load i64, ptr %392, align 8
  %851 = icmp sgt i64 %850, 0
  br i1 %851, label %852, label %853

852:                                              ; preds = %846
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %853

853:                                              ; preds = %846, %852
  %854 = load ptr, ptr %73, align 8
  %855 = load i64, ptr %854, align 8
  %856 = load ptr, ptr %391, align 8
  %857 = load ptr, ptr %393, align 8
  %858 = load ptr, ptr %394, align 8
  %859 = inttoptr i64 %855 to ptr
  %860 = tail call i32 %859(ptr noundef %856, ptr noundef %78, ptr noundef %857, ptr noundef %858, ptr noundef %116) #9
  %861 = sext i32 %860 to i64
  %862 = icmp slt i32 %860, 0
  br i1 %862, label %1498, label %863

863:                                              ; preds = %832, %853, %844, %670
  %864 = phi i64 [ 0, %844 ], [ %861, %853 ], [ 0, %832 ], [ %668, %670 ]
  %865 = phi double [ %833, %844 ], [ %833, %853 ], [ %833, %832 ], [ 0.000000e+00, %670 ]
  %866 = phi i1 [ %845, %844 ], [ %845, %853 ], [ false, %832 ], [ false, %670 ]
  %867 = icmp ne i64 %864, 0
  %868 = fcmp uge double %865, 1.000000e+00
  %869 = or i1 %867, %868
  %870 = or i1 %866, %869
  br i1 %870, label %871, label %934

871:                                              ; preds = %863
  %872 = load i64, ptr %352, align 8
  %873 = add nsw i64 %872, 1
  store i64 %873, ptr %352, align 8
  %874 = or i1 %867, %866
  br i1 %874, label %878, label %875

875:                                              ; preds = %871
  %876 = tail call double @llvm.fabs.f64(double %865)
  %877 = fcmp one double %876, 0x7FF0000000000000
  br label %878

878:                                              ; preds = %875, %871
  %879 = phi i1 [ false, %871 ], [ %877, %875 ]
  %880 = select i1 %879, i64 2, i64 4
  %881 = select i1 %866, i64 6, i64 %880
  %882 = select i1 %867, i64 3, i64 %881
  store i64 %882, ptr %431, align 8
  %883 = fcmp ogt double %865, 1.000000e-10
  %884 = select i1 %883, double %865, double 1.000000e-10
  %885 = load double, ptr %432, align 8
  %886 = load double, ptr %88, align 8
  %887 = fneg double %886
  %888 = bitcast double %884 to i64
  %889 = add nsw i64 %888, -4604544271217802189
  %890 = ashr i64 %889, 52
  %891 = and i64 %889, -4503599627370496
  %892 = sub nsw i64 %888, %891
  %893 = bitcast i64 %892 to double
  %894 = fadd double %893, -1.000000e+00
  %895 = fadd double %893, 1.000000e+00
  %896 = fdiv double %894, %895
  %897 = fmul double %896, %896
  %898 = tail call double @llvm.fma.f64(double %897, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %899 = tail call double @llvm.fma.f64(double %898, double %897, double 0x3FE2776C50EF9BFE)
  %900 = tail call double @llvm.fma.f64(double %899, double %897, double 0x3FEEC709DC3A03FD)
  %901 = tail call double @llvm.fma.f64(double %900, double %897, double 0x40071547652B82FE)
  %902 = trunc nsw i64 %890 to i32
  %903 = sitofp i32 %902 to double
  %904 = fmul double %896, %901
  %905 = fadd double %904, %903
  %906 = fmul double %905, %887
  %907 = fcmp ogt double %906, -1.000000e+03
  %908 = select i1 %907, double %906, double -1.000000e+03
  %909 = fcmp olt double %908, 1.000000e+03
  %910 = select i1 %909, double %908, double 1.000000e+03
  %911 = tail call double @llvm.rint.f64(double %910)
  %912 = fsub double %910, %911
  %913 = tail call double @llvm.fma.f64(double %912, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %914 = tail call double @llvm.fma.f64(double %913, double %912, double 0x3F55D87FE78A6730)
  %915 = tail call double @llvm.fma.f64(double %914, double %912, double 0x3F83B2AB6FBA4E77)
  %916 = tail call double @llvm.fma.f64(double %915, double %912, double 0x3FAC6B08D704A0BF)
  %917 = tail call double @llvm.fma.f64(double %916, double %912, double 0x3FCEBFBDFF82C58E)
  %918 = tail call double @llvm.fma.f64(double %917, double %912, double 0x3FE62E42FEFA39EF)
  %919 = tail call double @llvm.fma.f64(double %918, double %912, double 1.000000e+00)
  %920 = bitcast double %919 to i64
  %921 = fptosi double %911 to i32
  %922 = sext i32 %921 to i64
  %923 = shl nsw i64 %922, 52
  %924 = add nsw i64 %923, %920
  %925 = bitcast i64 %924 to double
  %926 = fmul double %885, %925
  %927 = load double, ptr %433, align 8
  %928 = fcmp ogt double %926, %927
  %929 = select i1 %928, double %926, double %927
  %930 = select i1 %879, double %929, double 2.500000e-01
  %931 = fmul double %487, %930
  br i1 %98, label %932, label %933

932:                                              ; preds = %878
  store double %487, ptr %118, align 8
  br label %1498

933:                                              ; preds = %878
  store double 1.000000e+00, ptr %434, align 8
  br label %1498, !llvm.loop !19

934:                                              ; preds = %863
  %935 = load i64, ptr %351, align 8
  %936 = add nsw i64 %935, 1
  store i64 %936, ptr %351, align 8
  store double %488, ptr %76, align 8
  store double %487, ptr %395, align 8
  %937 = load ptr, ptr %350, align 8
  %938 = getelementptr inbounds i8, ptr %937, i64 8
  %939 = load i64, ptr %938, align 8
  %940 = icmp eq i64 %939, 0
  br i1 %940, label %970, label %941

941:                                              ; preds = %934
  %942 = load i64, ptr %937, align 8
  %943 = load ptr, ptr %73, align 8
  %944 = getelementptr inbounds i8, ptr %943, i64 8
  %945 = load i64, ptr %944, align 8
  %946 = load ptr, ptr %396, align 8
  %947 = load i64, ptr %397, align 8
  %948 = mul nsw i64 %947, %942
  %949 = getelementptr inbounds double, ptr %946, i64 %948
  %950 = getelementptr inbounds double, ptr %949, i64 %947
  store double %440, ptr %949, align 8
  %951 = getelementptr inbounds i8, ptr %949, i64 8
  store double %487, ptr %951, align 8
  store double %488, ptr %950, align 8
  %952 = getelementptr inbounds i8, ptr %950, i64 8
  store double 0.000000e+00, ptr %952, align 8
  %953 = icmp sgt i64 %945, 0
  br i1 %953, label %957, label %954

954:                                              ; preds = %957, %941
  %955 = add nsw i64 %942, 1
  %956 = load ptr, ptr %350, align 8
  store i64 %955, ptr %956, align 8
  br label %970

957:                                              ; preds = %941, %957
  %958 = phi i64 [ %968, %957 ], [ 0, %941 ]
  %959 = load ptr, ptr %74, align 8
  %960 = getelementptr inbounds double, ptr %959, i64 %958
  %961 = load double, ptr %960, align 8
  %962 = add nuw nsw i64 %958, 2
  %963 = getelementptr inbounds double, ptr %949, i64 %962
  store double %961, ptr %963, align 8
  %964 = load ptr, ptr %77, align 8
  %965 = getelementptr inbounds double, ptr %964, i64 %958
  %966 = load double, ptr %965, align 8
  %967 = getelementptr inbounds double, ptr %950, i64 %962
  store double %966, ptr %967, align 8
  %968 = add nuw nsw i64 %958, 1
  %969 = icmp eq i64 %968, %945
  br i1 %969, label %954, label %957, !llvm.loop !20

970:                                              ; preds = %934, %954
  br i1 %106, label %1013, label %971

971:                                              ; preds = %970
  %972 = load i64, ptr %398, align 8
  %973 = getelementptr inbounds double, ptr %86, i64 %972
  %974 = load double, ptr %973, align 8
  %975 = fcmp ult double %974, %488
  br i1 %975, label %1013, label %976

976:                                              ; preds = %971
  %977 = load ptr, ptr %73, align 8
  %978 = getelementptr inbounds i8, ptr %977, i64 8
  %979 = load i64, ptr %978, align 8
  %980 = load i64, ptr %107, align 8
  %981 = load ptr, ptr %85, align 8
  %982 = load ptr, ptr %79, align 8
  %983 = getelementptr inbounds i8, ptr %982, i64 48
  %984 = load i64, ptr %983, align 8
  %985 = icmp slt i64 %984, %980
  br i1 %985, label %986, label %1009

986:                                              ; preds = %976
  %987 = icmp sgt i64 %979, 0
  br label %988

988:                                              ; preds = %986, %999
  %989 = phi i64 [ %984, %986 ], [ %1000, %999 ]
  %990 = getelementptr inbounds double, ptr %981, i64 %989
  %991 = load double, ptr %990, align 8
  %992 = load ptr, ptr %75, align 8
  %993 = load double, ptr %992, align 8
  %994 = fcmp ugt double %991, %993
  br i1 %994, label %1009, label %995

995:                                              ; preds = %988
  br i1 %987, label %996, label %999

996:                                              ; preds = %995
  %997 = mul nsw i64 %989, %979
  %998 = getelementptr double, ptr %1, i64 %997
  br label %1002

999:                                              ; preds = %1002, %995
  %1000 = add i64 %989, 1
  %1001 = icmp eq i64 %1000, %980
  br i1 %1001, label %1009, label %988, !llvm.loop !8

1002:                                             ; preds = %996, %1002
  %1003 = phi i64 [ 0, %996 ], [ %1007, %1002 ]
  %1004 = getelementptr inbounds double, ptr %78, i64 %1003
  %1005 = load double, ptr %1004, align 8
  %1006 = getelementptr double, ptr %998, i64 %1003
  store double %1005, ptr %1006, align 8
  %1007 = add nuw nsw i64 %1003, 1
  %1008 = icmp eq i64 %1007, %979
  br i1 %1008, label %999, label %1002, !llvm.loop !9

1009:                                             ; preds = %988, %999, %976
  %1010 = phi i64 [ %984, %976 ], [ %989, %988 ], [ %980, %999 ]
  %1011 = load ptr, ptr %79, align 8
  %1012 = getelementptr inbounds i8, ptr %1011, i64 48
  store i64 %1010, ptr %1012, align 8
  br label %1375

1013:                                             ; preds = %971, %970
  %1014 = load ptr, ptr %0, align 8
  %1015 = load ptr, ptr %73, align 8
  %1016 = getelementptr inbounds i8, ptr %1015, i64 16
  %1017 = load i64, ptr %1016, align 8
  %1018 = load i64, ptr %1014, align 8
  %1019 = load i64, ptr %399, align 8
  %1020 = load ptr, ptr %400, align 8
  %1021 = mul nsw i64 %1019, %1018
  %1022 = getelementptr inbounds double, ptr %1020, i64 %1021
  %1023 = load ptr, ptr %401, align 8
  %1024 = add nsw i64 %1018, 1
  %1025 = getelementptr inbounds i8, ptr %1014, i64 16
  %1026 = load i64, ptr %1025, align 8
  %1027 = icmp sgt i64 %1026, 0
  br i1 %1027, label %1028, label %1082

1028:                                             ; preds = %1013
  %1029 = getelementptr inbounds i8, ptr %1014, i64 8
  br label %1035

1030:                                             ; preds = %1071
  %1031 = add nsw i64 %1038, 1
  %1032 = load i64, ptr %1025, align 8
  %1033 = add nsw i64 %1032, %1024
  %1034 = icmp slt i64 %1031, %1033
  br i1 %1034, label %1035, label %1082, !llvm.loop !21

1035:                                             ; preds = %1028, %1030
  %1036 = phi i1 [ %1027, %1028 ], [ %1034, %1030 ]
  %1037 = phi i64 [ undef, %1028 ], [ %1081, %1030 ]
  %1038 = phi i64 [ %1024, %1028 ], [ %1031, %1030 ]
  %1039 = load i64, ptr %1029, align 8
  %1040 = load ptr, ptr %402, align 8
  %1041 = load ptr, ptr %74, align 8
  %1042 = load ptr, ptr %403, align 8
  %1043 = getelementptr i64, ptr %1042, i64 %1038
  %1044 = getelementptr i64, ptr %1043, i64 %1039
  %1045 = load i64, ptr %1044, align 8
  %1046 = getelementptr i8, ptr %1044, i64 8
  %1047 = load i64, ptr %1046, align 8
  %1048 = xor i64 %1045, -1
  %1049 = add i64 %1047, %1048
  %1050 = load ptr, ptr %357, align 8
  %1051 = load ptr, ptr %400, align 8
  %1052 = load ptr, ptr %404, align 8
  %1053 = getelementptr inbounds i64, ptr %1052, i64 %1045
  %1054 = load ptr, ptr %405, align 8
  %1055 = getelementptr inbounds double, ptr %1054, i64 %1045
  tail call fastcc void @combine(ptr noundef %1040, ptr noundef %1041, ptr noundef %1050, ptr noundef %1051, ptr noundef %1053, ptr noundef %1055, i64 noundef %1049, i64 noundef 1, i64 noundef %1017) #8
  %1056 = load ptr, ptr %400, align 8
  %1057 = mul nsw i64 %1038, %1019
  %1058 = getelementptr inbounds double, ptr %1056, i64 %1057
  %1059 = load i64, ptr %356, align 8
  %1060 = add nsw i64 %1059, 1
  store i64 %1060, ptr %356, align 8
  %1061 = load ptr, ptr %406, align 8
  %1062 = getelementptr inbounds double, ptr %1061, i64 %1038
  %1063 = load double, ptr %1062, align 8
  %1064 = fmul double %487, %1063
  %1065 = fadd double %440, %1064
  %1066 = load ptr, ptr %402, align 8
  %1067 = load ptr, ptr %407, align 8
  store double %1065, ptr %1067, align 8
  %1068 = load i64, ptr %408, align 8
  %1069 = icmp sgt i64 %1068, 0
  br i1 %1069, label %1070, label %1071

1070:                                             ; preds = %1035
  tail call fastcc void @sample(ptr noundef nonnull %73) #8
  br label %1071

1071:                                             ; preds = %1035, %1070
  %1072 = load ptr, ptr %73, align 8
  %1073 = load i64, ptr %1072, align 8
  %1074 = load ptr, ptr %407, align 8
  %1075 = load ptr, ptr %409, align 8
  %1076 = load ptr, ptr %410, align 8
  %1077 = inttoptr i64 %1073 to ptr
  %1078 = tail call i32 %1077(ptr noundef %1074, ptr noundef %1066, ptr noundef %1075, ptr noundef %1076, ptr noundef %1058) #9
  %1079 = sext i32 %1078 to i64
  %1080 = icmp eq i32 %1078, 0
  %1081 = select i1 %1080, i64 %1037, i64 %1079
  br i1 %1080, label %1030, label %1082

1082:                                             ; preds = %1030, %1071, %1013
  %1083 = phi i1 [ %1027, %1013 ], [ %1034, %1030 ], [ %1036, %1071 ]
  %1084 = phi i64 [ 0, %1013 ], [ %1079, %1071 ], [ %1079, %1030 ]
  %1085 = phi i64 [ undef, %1013 ], [ %1081, %1071 ], [ %1081, %1030 ]
  %1086 = getelementptr inbounds i8, ptr %1014, i64 16
  br i1 %1083, label %1155, label %1087

1087:                                             ; preds = %1082
  %1088 = load ptr, ptr %73, align 8
  %1089 = getelementptr inbounds i8, ptr %1088, i64 8
  %1090 = load i64, ptr %1089, align 8
  %1091 = icmp sgt i64 %1090, 0
  br i1 %1091, label %1092, label %1096

1092:                                             ; preds = %1087
  %1093 = getelementptr inbounds double, ptr %1023, i64 %1019
  %1094 = shl nsw i64 %1019, 4
  %1095 = getelementptr inbounds i8, ptr %1023, i64 %1094
  br label %1103

1096:                                             ; preds = %1103, %1087
  %1097 = getelementptr inbounds i8, ptr %1014, i64 8
  %1098 = load i64, ptr %1097, align 8
  %1099 = load i64, ptr %1086, align 8
  %1100 = getelementptr inbounds i8, ptr %1014, i64 24
  %1101 = load i64, ptr %1100, align 8
  %1102 = icmp sgt i64 %1101, 3
  br i1 %1102, label %1130, label %1155

1103:                                             ; preds = %1092, %1103
  %1104 = phi i64 [ 0, %1092 ], [ %1125, %1103 ]
  %1105 = load ptr, ptr %411, align 8
  %1106 = getelementptr inbounds double, ptr %1105, i64 %1104
  %1107 = load double, ptr %1106, align 8
  %1108 = load ptr, ptr %74, align 8
  %1109 = getelementptr inbounds double, ptr %1108, i64 %1104
  %1110 = load double, ptr %1109, align 8
  %1111 = fsub double %1107, %1110
  %1112 = load ptr, ptr %400, align 8
  %1113 = getelementptr inbounds double, ptr %1112, i64 %1104
  %1114 = load double, ptr %1113, align 8
  %1115 = fmul double %487, %1114
  %1116 = fsub double %1115, %1111
  %1117 = getelementptr inbounds double, ptr %1023, i64 %1104
  store double %1111, ptr %1117, align 8
  %1118 = getelementptr inbounds double, ptr %1093, i64 %1104
  store double %1116, ptr %1118, align 8
  %1119 = fsub double %1111, %1116
  %1120 = getelementptr inbounds double, ptr %1022, i64 %1104
  %1121 = load double, ptr %1120, align 8
  %1122 = fmul double %487, %1121
  %1123 = fsub double %1119, %1122
  %1124 = getelementptr inbounds double, ptr %1095, i64 %1104
  store double %1123, ptr %1124, align 8
  %1125 = add nuw nsw i64 %1104, 1
  %1126 = load ptr, ptr %73, align 8
  %1127 = getelementptr inbounds i8, ptr %1126, i64 8
  %1128 = load i64, ptr %1127, align 8
  %1129 = icmp slt i64 %1125, %1128
  br i1 %1129, label %1103, label %1096, !llvm.loop !22

1130:                                             ; preds = %1096, %1130
  %1131 = phi i64 [ %1152, %1130 ], [ 3, %1096 ]
  %1132 = mul nsw i64 %1131, %1019
  %1133 = getelementptr inbounds double, ptr %1023, i64 %1132
  %1134 = load ptr, ptr %412, align 8
  %1135 = load ptr, ptr %413, align 8
  %1136 = getelementptr i64, ptr %1135, i64 %1024
  %1137 = getelementptr i64, ptr %1136, i64 %1098
  %1138 = getelementptr i64, ptr %1137, i64 %1099
  %1139 = getelementptr i64, ptr %1138, i64 %1131
  %1140 = getelementptr i8, ptr %1139, i64 -24
  %1141 = load i64, ptr %1140, align 8
  %1142 = getelementptr i8, ptr %1139, i64 -16
  %1143 = load i64, ptr %1142, align 8
  %1144 = xor i64 %1141, -1
  %1145 = add i64 %1143, %1144
  %1146 = load ptr, ptr %357, align 8
  %1147 = load ptr, ptr %400, align 8
  %1148 = load ptr, ptr %414, align 8
  %1149 = getelementptr inbounds i64, ptr %1148, i64 %1141
  %1150 = load ptr, ptr %415, align 8
  %1151 = getelementptr inbounds double, ptr %1150, i64 %1141
  tail call fastcc void @combine(ptr noundef %1133, ptr noundef %1134, ptr noundef %1146, ptr noundef %1147, ptr noundef %1149, ptr noundef %1151, i64 noundef %1145, i64 noundef 1, i64 noundef %1017) #8
  %1152 = add nuw nsw i64 %1131, 1
  %1153 = load i64, ptr %1100, align 8
  %1154 = icmp slt i64 %1152, %1153
  br i1 %1154, label %1130, label %1155, !llvm.loop !23

1155:                                             ; preds = %1130, %1096, %1082
  %1156 = phi i64 [ %1085, %1082 ], [ %1084, %1096 ], [ %1084, %1130 ]
  %1157 = icmp eq i64 %1156, 0
  br i1 %1157, label %1161, label %1158

1158:                                             ; preds = %1155
  store i64 3, ptr %416, align 8
  store double %440, ptr %76, align 8
  %1159 = icmp slt i64 %1156, 0
  %1160 = select i1 %1159, i64 -4, i64 2
  br label %1498

1161:                                             ; preds = %1155
  %1162 = load ptr, ptr %75, align 8
  %1163 = load ptr, ptr %102, align 8
  %1164 = getelementptr inbounds i8, ptr %1163, i64 8
  %1165 = load i64, ptr %1164, align 8
  %1166 = icmp sgt i64 %1165, 0
  br i1 %1166, label %1167, label %1177

1167:                                             ; preds = %1161
  %1168 = getelementptr inbounds i8, ptr %1163, i64 16
  %1169 = load i64, ptr %1168, align 8
  %1170 = inttoptr i64 %1169 to ptr
  %1171 = tail call i64 %1170(ptr noundef %0, double noundef %440, double noundef %487) #9
  %1172 = icmp eq i64 %1171, -6
  br i1 %1172, label %1173, label %1174

1173:                                             ; preds = %1167
  store double %440, ptr %1162, align 8
  br label %1352

1174:                                             ; preds = %1167
  %1175 = getelementptr inbounds i8, ptr %1162, i64 48
  %1176 = load double, ptr %1175, align 8
  br label %1177

1177:                                             ; preds = %1174, %1161
  %1178 = phi double [ %1176, %1174 ], [ 1.000000e+00, %1161 ]
  %1179 = phi i64 [ %1171, %1174 ], [ 0, %1161 ]
  %1180 = fcmp oeq double %1178, 1.000000e+00
  br i1 %1180, label %1181, label %1183

1181:                                             ; preds = %1177
  %1182 = load double, ptr %1162, align 8
  br label %1186

1183:                                             ; preds = %1177
  %1184 = fmul double %487, %1178
  %1185 = fadd double %440, %1184
  br label %1186

1186:                                             ; preds = %1183, %1181
  %1187 = phi double [ %1182, %1181 ], [ %1185, %1183 ]
  %1188 = icmp eq i64 %1179, -4
  %1189 = select i1 %1188, i64 -4, i64 0
  br i1 %1188, label %1247, label %1190

1190:                                             ; preds = %1186
  %1191 = fcmp olt double %1178, 1.000000e+00
  %1192 = load ptr, ptr %73, align 8
  %1193 = getelementptr inbounds i8, ptr %1192, i64 8
  %1194 = load i64, ptr %1193, align 8
  %1195 = load i64, ptr %107, align 8
  %1196 = load ptr, ptr %85, align 8
  %1197 = load ptr, ptr %79, align 8
  %1198 = getelementptr inbounds i8, ptr %1197, i64 48
  %1199 = load i64, ptr %1198, align 8
  %1200 = icmp slt i64 %1199, %1195
  br i1 %1200, label %1201, label %1243

1201:                                             ; preds = %1190, %1239
  %1202 = phi i64 [ %1240, %1239 ], [ undef, %1190 ]
  %1203 = phi i64 [ %1241, %1239 ], [ %1199, %1190 ]
  %1204 = getelementptr inbounds double, ptr %1196, i64 %1203
  %1205 = load double, ptr %1204, align 8
  %1206 = fcmp olt double %1205, %1187
  %1207 = fcmp oeq double %1205, %1187
  %1208 = and i1 %1191, %1207
  %1209 = or i1 %1206, %1208
  br i1 %1209, label %1210, label %1243

1210:                                             ; preds = %1201
  %1211 = fsub double %1205, %440
  %1212 = fdiv double %1211, %487
  %1213 = mul nsw i64 %1203, %1194
  %1214 = getelementptr inbounds double, ptr %1, i64 %1213
  %1215 = load ptr, ptr %417, align 8
  %1216 = insertelement <8 x double> poison, double %1212, i64 0
  %1217 = shufflevector <8 x double> %1216, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1217, ptr %1215, align 8
  %1218 = load ptr, ptr %74, align 8
  %1219 = load ptr, ptr %401, align 8
  %1220 = load i64, ptr %399, align 8
  %1221 = load ptr, ptr %0, align 8
  %1222 = getelementptr inbounds i8, ptr %1221, i64 24
  %1223 = load i64, ptr %1222, align 8
  %1224 = load ptr, ptr %417, align 8
  %1225 = load ptr, ptr %73, align 8
  %1226 = getelementptr inbounds i8, ptr %1225, i64 16
  %1227 = load i64, ptr %1226, align 8
  tail call fastcc void @nested(ptr noundef %1214, ptr noundef %1218, ptr noundef %1219, i64 noundef %1220, i64 noundef %1223, ptr noundef %1224, i64 noundef %1227) #8
  %1228 = load ptr, ptr %92, align 8
  %1229 = load i64, ptr %1228, align 8
  %1230 = icmp eq i64 %1229, 1
  br i1 %1230, label %1231, label %1239

1231:                                             ; preds = %1210
  %1232 = load double, ptr %1204, align 8
  %1233 = getelementptr inbounds i8, ptr %1228, i64 56
  %1234 = load i64, ptr %1233, align 8
  %1235 = inttoptr i64 %1234 to ptr
  %1236 = tail call i64 %1235(ptr noundef %0, double noundef %1232, ptr noundef %1214) #9
  %1237 = icmp eq i64 %1236, 0
  %1238 = select i1 %1237, i64 %1202, i64 %1236
  br i1 %1237, label %1239, label %1247

1239:                                             ; preds = %1231, %1210
  %1240 = phi i64 [ %1238, %1231 ], [ %1202, %1210 ]
  %1241 = add i64 %1203, 1
  %1242 = icmp eq i64 %1241, %1195
  br i1 %1242, label %1243, label %1201, !llvm.loop !24

1243:                                             ; preds = %1239, %1201, %1190
  %1244 = phi i64 [ %1199, %1190 ], [ %1195, %1239 ], [ %1203, %1201 ]
  %1245 = load ptr, ptr %79, align 8
  %1246 = getelementptr inbounds i8, ptr %1245, i64 48
  store i64 %1244, ptr %1246, align 8
  br label %1247

1247:                                             ; preds = %1231, %1243, %1186
  %1248 = phi i64 [ %1189, %1186 ], [ 0, %1243 ], [ %1238, %1231 ]
  %1249 = icmp eq i64 %1248, 0
  %1250 = icmp ne i64 %1179, 0
  %1251 = fcmp olt double %1178, 1.000000e+00
  %1252 = and i1 %1251, %1249
  %1253 = and i1 %1250, %1252
  br i1 %1253, label %1254, label %1291

1254:                                             ; preds = %1247
  %1255 = load ptr, ptr %418, align 8
  %1256 = load ptr, ptr %419, align 8
  %1257 = insertelement <8 x double> poison, double %1178, i64 0
  %1258 = shufflevector <8 x double> %1257, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1258, ptr %1256, align 8
  %1259 = load ptr, ptr %74, align 8
  %1260 = load ptr, ptr %401, align 8
  %1261 = load i64, ptr %399, align 8
  %1262 = load ptr, ptr %0, align 8
  %1263 = getelementptr inbounds i8, ptr %1262, i64 24
  %1264 = load i64, ptr %1263, align 8
  %1265 = load ptr, ptr %419, align 8
  %1266 = load ptr, ptr %73, align 8
  %1267 = getelementptr inbounds i8, ptr %1266, i64 16
  %1268 = load i64, ptr %1267, align 8
  tail call fastcc void @nested(ptr noundef %1255, ptr noundef %1259, ptr noundef %1260, i64 noundef %1261, i64 noundef %1264, ptr noundef %1265, i64 noundef %1268) #8
  %1269 = load i64, ptr %90, align 8
  %1270 = icmp sgt i64 %1269, 0
  br i1 %1270, label %1275, label %1271

1271:                                             ; preds = %1275, %1254
  %1272 = load ptr, ptr %92, align 8
  %1273 = load i64, ptr %1272, align 8
  %1274 = icmp eq i64 %1273, 1
  br i1 %1274, label %1285, label %1291

1275:                                             ; preds = %1254, %1275
  %1276 = phi i64 [ %1282, %1275 ], [ 0, %1254 ]
  %1277 = load ptr, ptr %418, align 8
  %1278 = getelementptr inbounds double, ptr %1277, i64 %1276
  %1279 = load double, ptr %1278, align 8
  %1280 = load ptr, ptr %77, align 8
  %1281 = getelementptr inbounds double, ptr %1280, i64 %1276
  store double %1279, ptr %1281, align 8
  %1282 = add nuw nsw i64 %1276, 1
  %1283 = load i64, ptr %90, align 8
  %1284 = icmp slt i64 %1282, %1283
  br i1 %1284, label %1275, label %1271, !llvm.loop !25

1285:                                             ; preds = %1271
  %1286 = load ptr, ptr %77, align 8
  %1287 = getelementptr inbounds i8, ptr %1272, i64 56
  %1288 = load i64, ptr %1287, align 8
  %1289 = inttoptr i64 %1288 to ptr
  %1290 = tail call i64 %1289(ptr noundef %0, double noundef %1187, ptr noundef %1286) #9
  br label %1291

1291:                                             ; preds = %1285, %1271, %1247
  %1292 = phi i64 [ %1290, %1285 ], [ 0, %1271 ], [ %1248, %1247 ]
  %1293 = icmp eq i64 %1292, 0
  br i1 %1293, label %1296, label %1294

1294:                                             ; preds = %1291
  store double %440, ptr %1162, align 8
  %1295 = getelementptr inbounds i8, ptr %1162, i64 8
  store double %487, ptr %1295, align 8
  br label %1352

1296:                                             ; preds = %1291
  br i1 %1180, label %1297, label %1335

1297:                                             ; preds = %1296
  %1298 = load ptr, ptr %77, align 8
  %1299 = load ptr, ptr %73, align 8
  %1300 = getelementptr inbounds i8, ptr %1299, i64 8
  %1301 = load i64, ptr %1300, align 8
  %1302 = load i64, ptr %107, align 8
  %1303 = load ptr, ptr %85, align 8
  %1304 = load ptr, ptr %79, align 8
  %1305 = getelementptr inbounds i8, ptr %1304, i64 48
  %1306 = load i64, ptr %1305, align 8
  %1307 = icmp slt i64 %1306, %1302
  br i1 %1307, label %1308, label %1331

1308:                                             ; preds = %1297
  %1309 = icmp sgt i64 %1301, 0
  br label %1310

1310:                                             ; preds = %1308, %1321
  %1311 = phi i64 [ %1306, %1308 ], [ %1322, %1321 ]
  %1312 = getelementptr inbounds double, ptr %1303, i64 %1311
  %1313 = load double, ptr %1312, align 8
  %1314 = load ptr, ptr %75, align 8
  %1315 = load double, ptr %1314, align 8
  %1316 = fcmp ugt double %1313, %1315
  br i1 %1316, label %1331, label %1317

1317:                                             ; preds = %1310
  br i1 %1309, label %1318, label %1321

1318:                                             ; preds = %1317
  %1319 = mul nsw i64 %1311, %1301
  %1320 = getelementptr double, ptr %1, i64 %1319
  br label %1324

1321:                                             ; preds = %1324, %1317
  %1322 = add i64 %1311, 1
  %1323 = icmp eq i64 %1322, %1302
  br i1 %1323, label %1331, label %1310, !llvm.loop !8

1324:                                             ; preds = %1318, %1324
  %1325 = phi i64 [ 0, %1318 ], [ %1329, %1324 ]
  %1326 = getelementptr inbounds double, ptr %1298, i64 %1325
  %1327 = load double, ptr %1326, align 8
  %1328 = getelementptr double, ptr %1320, i64 %1325
  store double %1327, ptr %1328, align 8
  %1329 = add nuw nsw i64 %1325, 1
  %1330 = icmp eq i64 %1329, %1301
  br i1 %1330, label %1321, label %1324, !llvm.loop !9

1331:                                             ; preds = %1321, %1310, %1297
  %1332 = phi i64 [ %1306, %1297 ], [ %1302, %1321 ], [ %1311, %1310 ]
  %1333 = load ptr, ptr %79, align 8
  %1334 = getelementptr inbounds i8, ptr %1333, i64 48
  store i64 %1332, ptr %1334, align 8
  br label %1335

1335:                                             ; preds = %1331, %1296
  br i1 %1250, label %1336, label %1352

1336:                                             ; preds = %1335
  %1337 = load i64, ptr %90, align 8
  %1338 = icmp sgt i64 %1337, 0
  br i1 %1338, label %1342, label %1339

1339:                                             ; preds = %1342, %1336
  store double %1187, ptr %1162, align 8
  %1340 = getelementptr inbounds i8, ptr %1162, i64 8
  store double 0.000000e+00, ptr %1340, align 8
  %1341 = load ptr, ptr %79, align 8
  store i64 0, ptr %1341, align 8
  br label %1352

1342:                                             ; preds = %1336, %1342
  %1343 = phi i64 [ %1349, %1342 ], [ 0, %1336 ]
  %1344 = load ptr, ptr %77, align 8
  %1345 = getelementptr inbounds double, ptr %1344, i64 %1343
  %1346 = load double, ptr %1345, align 8
  %1347 = load ptr, ptr %74, align 8
  %1348 = getelementptr inbounds double, ptr %1347, i64 %1343
  store double %1346, ptr %1348, align 8
  %1349 = add nuw nsw i64 %1343, 1
  %1350 = load i64, ptr %90, align 8
  %1351 = icmp slt i64 %1349, %1350
  br i1 %1351, label %1342, label %1339, !llvm.loop !26

1352:                                             ; preds = %1173, %1294, %1335, %1339
  %1353 = phi i64 [ -6, %1173 ], [ %1292, %1294 ], [ %1179, %1339 ], [ %1179, %1335 ]
  %1354 = icmp eq i64 %1353, -6
  br i1 %1354, label %1359, label %1355

1355:                                             ; preds = %1352
  %1356 = icmp ne i64 %1353, 6
  %1357 = select i1 %1356, i1 true, i1 %98
  %1358 = select i1 %1357, i1 true, i1 %106
  br i1 %1358, label %1369, label %1359

1359:                                             ; preds = %1355, %1352
  %1360 = phi i64 [ %1353, %1355 ], [ 2, %1352 ]
  %1361 = load i64, ptr %351, align 8
  %1362 = add nsw i64 %1361, -1
  store i64 %1362, ptr %351, align 8
  %1363 = load ptr, ptr %350, align 8
  %1364 = load i64, ptr %1363, align 8
  %1365 = add nsw i64 %1364, -1
  store i64 %1365, ptr %1363, align 8
  %1366 = load i64, ptr %352, align 8
  %1367 = add nsw i64 %1366, 1
  store i64 %1367, ptr %352, align 8
  store i64 %1360, ptr %429, align 8
  store double 1.000000e+00, ptr %430, align 8
  %1368 = fmul double %487, 2.500000e-01
  br label %1498, !llvm.loop !19

1369:                                             ; preds = %1355
  %1370 = icmp eq i64 %1353, 0
  br i1 %1370, label %1375, label %1371

1371:                                             ; preds = %1369
  %1372 = load ptr, ptr %350, align 8
  %1373 = load i64, ptr %1372, align 8
  %1374 = add nsw i64 %1373, 1
  store i64 %1374, ptr %1372, align 8
  br label %1498

1375:                                             ; preds = %1369, %1009
  br i1 %98, label %1479, label %1376

1376:                                             ; preds = %1375
  %1377 = load double, ptr %421, align 8
  %1378 = fcmp ogt double %865, 1.000000e-10
  %1379 = select i1 %1378, double %865, double 1.000000e-10
  %1380 = load double, ptr %422, align 8
  %1381 = load double, ptr %423, align 8
  %1382 = fneg double %1381
  %1383 = bitcast double %1379 to i64
  %1384 = add nsw i64 %1383, -4604544271217802189
  %1385 = ashr i64 %1384, 52
  %1386 = and i64 %1384, -4503599627370496
  %1387 = sub nsw i64 %1383, %1386
  %1388 = bitcast i64 %1387 to double
  %1389 = fadd double %1388, -1.000000e+00
  %1390 = fadd double %1388, 1.000000e+00
  %1391 = fdiv double %1389, %1390
  %1392 = fmul double %1391, %1391
  %1393 = tail call double @llvm.fma.f64(double %1392, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1394 = tail call double @llvm.fma.f64(double %1393, double %1392, double 0x3FE2776C50EF9BFE)
  %1395 = tail call double @llvm.fma.f64(double %1394, double %1392, double 0x3FEEC709DC3A03FD)
  %1396 = tail call double @llvm.fma.f64(double %1395, double %1392, double 0x40071547652B82FE)
  %1397 = trunc nsw i64 %1385 to i32
  %1398 = sitofp i32 %1397 to double
  %1399 = fmul double %1391, %1396
  %1400 = fadd double %1399, %1398
  %1401 = fmul double %1400, %1382
  %1402 = fcmp ogt double %1401, -1.000000e+03
  %1403 = select i1 %1402, double %1401, double -1.000000e+03
  %1404 = fcmp olt double %1403, 1.000000e+03
  %1405 = select i1 %1404, double %1403, double 1.000000e+03
  %1406 = tail call double @llvm.rint.f64(double %1405)
  %1407 = fsub double %1405, %1406
  %1408 = tail call double @llvm.fma.f64(double %1407, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1409 = tail call double @llvm.fma.f64(double %1408, double %1407, double 0x3F55D87FE78A6730)
  %1410 = tail call double @llvm.fma.f64(double %1409, double %1407, double 0x3F83B2AB6FBA4E77)
  %1411 = tail call double @llvm.fma.f64(double %1410, double %1407, double 0x3FAC6B08D704A0BF)
  %1412 = tail call double @llvm.fma.f64(double %1411, double %1407, double 0x3FCEBFBDFF82C58E)
  %1413 = tail call double @llvm.fma.f64(double %1412, double %1407, double 0x3FE62E42FEFA39EF)
  %1414 = tail call double @llvm.fma.f64(double %1413, double %1407, double 1.000000e+00)
  %1415 = bitcast double %1414 to i64
  %1416 = fptosi double %1406 to i32
  %1417 = sext i32 %1416 to i64
  %1418 = shl nsw i64 %1417, 52
  %1419 = add nsw i64 %1418, %1415
  %1420 = bitcast i64 %1419 to double
  %1421 = fmul double %1380, %1420
  %1422 = load double, ptr %424, align 8
  %1423 = fcmp une double %1422, 0.000000e+00
  br i1 %1423, label %1424, label %1464

1424:                                             ; preds = %1376
  %1425 = load i64, ptr %420, align 8
  %1426 = add nsw i64 %1425, -4604544271217802189
  %1427 = ashr i64 %1426, 52
  %1428 = and i64 %1426, -4503599627370496
  %1429 = sub nsw i64 %1425, %1428
  %1430 = bitcast i64 %1429 to double
  %1431 = fadd double %1430, -1.000000e+00
  %1432 = fadd double %1430, 1.000000e+00
  %1433 = fdiv double %1431, %1432
  %1434 = fmul double %1433, %1433
  %1435 = tail call double @llvm.fma.f64(double %1434, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1436 = tail call double @llvm.fma.f64(double %1435, double %1434, double 0x3FE2776C50EF9BFE)
  %1437 = tail call double @llvm.fma.f64(double %1436, double %1434, double 0x3FEEC709DC3A03FD)
  %1438 = tail call double @llvm.fma.f64(double %1437, double %1434, double 0x40071547652B82FE)
  %1439 = trunc nsw i64 %1427 to i32
  %1440 = sitofp i32 %1439 to double
  %1441 = fmul double %1433, %1438
  %1442 = fadd double %1441, %1440
  %1443 = fmul double %1422, %1442
  %1444 = fcmp ogt double %1443, -1.000000e+03
  %1445 = select i1 %1444, double %1443, double -1.000000e+03
  %1446 = fcmp olt double %1445, 1.000000e+03
  %1447 = select i1 %1446, double %1445, double 1.000000e+03
  %1448 = tail call double @llvm.rint.f64(double %1447)
  %1449 = fsub double %1447, %1448
  %1450 = tail call double @llvm.fma.f64(double %1449, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1451 = tail call double @llvm.fma.f64(double %1450, double %1449, double 0x3F55D87FE78A6730)
  %1452 = tail call double @llvm.fma.f64(double %1451, double %1449, double 0x3F83B2AB6FBA4E77)
  %1453 = tail call double @llvm.fma.f64(double %1452, double %1449, double 0x3FAC6B08D704A0BF)
  %1454 = tail call double @llvm.fma.f64(double %1453, double %1449, double 0x3FCEBFBDFF82C58E)
  %1455 = tail call double @llvm.fma.f64(double %1454, double %1449, double 0x3FE62E42FEFA39EF)
  %1456 = tail call double @llvm.fma.f64(double %1455, double %1449, double 1.000000e+00)
  %1457 = bitcast double %1456 to i64
  %1458 = fptosi double %1448 to i32
  %1459 = sext i32 %1458 to i64
  %1460 = shl nsw i64 %1459, 52
  %1461 = add nsw i64 %1460, %1457
  %1462 = bitcast i64 %1461 to double
  %1463 = fmul double %1421, %1462
  br label %1464

1464:                                             ; preds = %1376, %1424
  %1465 = phi double [ %1463, %1424 ], [ %1421, %1376 ]
  %1466 = load double, ptr %425, align 8
  %1467 = fcmp ogt double %1465, %1466
  %1468 = select i1 %1467, double %1465, double %1466
  %1469 = fcmp olt double %1377, %1468
  %1470 = select i1 %1469, double %1377, double %1468
  %1471 = fmul double %487, %1470
  %1472 = fcmp oeq double %488, %111
  %1473 = fcmp ogt double %441, %1471
  %1474 = select i1 %1472, i1 %1473, i1 false
  %1475 = select i1 %1474, double %441, double %1471
  %1476 = fcmp ogt double %865, 1.000000e-04
  %1477 = select i1 %1476, double %865, double 1.000000e-04
  store double %1477, ptr %420, align 8
  %1478 = load double, ptr %426, align 8
  store double %1478, ptr %421, align 8
  br label %1479

1479:                                             ; preds = %1464, %1375
  %1480 = phi double [ %1475, %1464 ], [ %441, %1375 ]
  br i1 %427, label %1485, label %1481

1481:                                             ; preds = %1485, %1479
  %1482 = load i64, ptr %428, align 8
  %1483 = load i64, ptr %107, align 8
  %1484 = icmp eq i64 %1482, %1483
  br i1 %1484, label %1497, label %1498

1485:                                             ; preds = %1479, %1485
  %1486 = phi i64 [ %1495, %1485 ], [ 0, %1479 ]
  %1487 = getelementptr inbounds double, ptr %78, i64 %1486
  %1488 = load double, ptr %1487, align 8
  %1489 = load ptr, ptr %74, align 8
  %1490 = getelementptr inbounds double, ptr %1489, i64 %1486
  store double %1488, ptr %1490, align 8
  %1491 = getelementptr inbounds double, ptr %116, i64 %1486
  %1492 = load double, ptr %1491, align 8
  %1493 = load ptr, ptr %112, align 8
  %1494 = getelementptr inbounds double, ptr %1493, i64 %1486
  store double %1492, ptr %1494, align 8
  %1495 = add nuw nsw i64 %1486, 1
  %1496 = icmp eq i64 %1495, %91
  br i1 %1496, label %1481, label %1485, !llvm.loop !27

1497:                                             ; preds = %1481
  store double %1480, ptr %118, align 8
  br label %1498

1498:                                             ; preds = %1158, %1359, %1371, %1497, %853, %933, %932, %1481, %667, %494
  %1499 = phi double [ %441, %494 ], [ %441, %667 ], [ %441, %1158 ], [ %1368, %1359 ], [ %441, %1371 ], [ %1480, %1497 ], [ %441, %853 ], [ %931, %933 ], [ %931, %932 ], [ %1480, %1481 ]
  %1500 = phi double [ %440, %494 ], [ %440, %667 ], [ %440, %1158 ], [ %440, %1359 ], [ %440, %1371 ], [ %488, %1497 ], [ %440, %853 ], [ %440, %933 ], [ %440, %932 ], [ %488, %1481 ]
  %1501 = phi i32 [ 1, %494 ], [ 1, %667 ], [ 1, %1158 ], [ 3, %1359 ], [ 1, %1371 ], [ 1, %1497 ], [ 1, %853 ], [ 3, %933 ], [ 1, %932 ], [ 0, %1481 ]
  %1502 = phi i64 [ 2, %494 ], [ -4, %667 ], [ %1160, %1158 ], [ %439, %1359 ], [ %1353, %1371 ], [ 0, %1497 ], [ -4, %853 ], [ %439, %933 ], [ 2, %932 ], [ %439, %1481 ]
  switch i32 %1501, label %1506 [
    i32 0, label %1503
    i32 3, label %1503
  ]

1503:                                             ; preds = %1498, %1498
  %1504 = load i64, ptr %81, align 8
  %1505 = icmp eq i64 %1504, 0
  br i1 %1505, label %435, label %437, !llvm.loop !19

1506:                                             ; preds = %1498, %145, %435, %454, %462, %187, %72
  %1507 = phi i64 [ -1, %72 ], [ %148, %145 ], [ -1, %435 ], [ -5, %454 ], [ 1, %462 ], [ 0, %187 ], [ %1502, %1498 ]
  ret i64 %1507
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
  br i1 %55, label %44, label %56, !llvm.loop !28

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
  br i1 %83, label %13, label %12, !llvm.loop !29
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
  br i1 %41, label %13, label %18, !llvm.loop !30
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
  br i1 %53, label %54, label %28, !llvm.loop !31

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
  br i1 %98, label %72, label %99, !llvm.loop !32

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
  br i1 %108, label %16, label %22, !llvm.loop !33

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
  br i1 %133, label %114, label %120, !llvm.loop !31

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
  br i1 %148, label %134, label %149, !llvm.loop !32

149:                                              ; preds = %134, %114
  %150 = phi <8 x double> [ %118, %114 ], [ %146, %134 ]
  store <8 x double> %150, ptr %111, align 8
  %151 = add nuw nsw i64 %110, 8
  %152 = icmp slt i64 %151, %11
  br i1 %152, label %109, label %153, !llvm.loop !34

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
  br i1 %31, label %20, label %19, !llvm.loop !35

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
  br i1 %43, label %32, label %24, !llvm.loop !36
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
