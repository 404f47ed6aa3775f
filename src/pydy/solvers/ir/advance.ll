; sources 903552da59d5513971a3651d30e68bf0a6b355d8f21b1363fb00b6350360a4f1
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define i64 @advance(ptr noundef %0, ptr noundef %1, i64 noundef %2) #0 {
  %4 = alloca [1 x double], align 8
  %5 = alloca [1 x double], align 8
  %6 = alloca [1 x double], align 8
  %7 = icmp eq i64 %2, 1
  br i1 %7, label %8, label %61

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
  %22 = getelementptr inbounds i8, ptr %0, i64 1032
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
  br i1 %37, label %38, label %61

38:                                               ; preds = %34
  %39 = getelementptr inbounds i8, ptr %0, i64 600
  %40 = getelementptr inbounds i8, ptr %0, i64 1056
  br label %51

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

51:                                               ; preds = %38, %51
  %52 = phi i64 [ 0, %38 ], [ %58, %51 ]
  %53 = load ptr, ptr %40, align 8
  %54 = getelementptr inbounds i64, ptr %53, i64 %52
  %55 = load i64, ptr %54, align 8
  %56 = load ptr, ptr %39, align 8
  %57 = getelementptr inbounds i64, ptr %56, i64 %52
  store i64 %55, ptr %57, align 8
  %58 = add nuw nsw i64 %52, 1
  %59 = load i64, ptr %35, align 8
  %60 = icmp slt i64 %58, %59
  br i1 %60, label %51, label %61, !llvm.loop !7

61:                                               ; preds = %51, %34, %3
  %62 = getelementptr inbounds i8, ptr %0, i64 144
  %63 = getelementptr inbounds i8, ptr %0, i64 312
  %64 = getelementptr inbounds i8, ptr %0, i64 576
  %65 = load ptr, ptr %64, align 8
  %66 = getelementptr inbounds i8, ptr %0, i64 336
  %67 = load ptr, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %0, i64 600
  %69 = load ptr, ptr %68, align 8
  %70 = getelementptr inbounds i8, ptr %69, i64 56
  %71 = load i64, ptr %70, align 8
  %72 = icmp eq i64 %71, 0
  br i1 %72, label %1495, label %73

73:                                               ; preds = %61
  %74 = getelementptr inbounds i8, ptr %0, i64 624
  %75 = load ptr, ptr %74, align 8
  %76 = getelementptr inbounds i8, ptr %0, i64 120
  %77 = load ptr, ptr %76, align 8
  %78 = load ptr, ptr %0, align 8
  %79 = getelementptr inbounds i8, ptr %0, i64 320
  %80 = load i64, ptr %79, align 8
  %81 = getelementptr inbounds i8, ptr %0, i64 648
  %82 = load ptr, ptr %81, align 8
  %83 = load i64, ptr %82, align 8
  %84 = icmp ne i64 %83, 1
  %85 = getelementptr inbounds i8, ptr %78, i64 8
  %86 = load i64, ptr %85, align 8
  %87 = icmp slt i64 %86, 1
  %88 = getelementptr inbounds i8, ptr %78, i64 32
  %89 = load i64, ptr %88, align 8
  %90 = icmp eq i64 %89, 1
  %91 = getelementptr inbounds i8, ptr %0, i64 720
  %92 = load ptr, ptr %91, align 8
  %93 = getelementptr inbounds i8, ptr %92, i64 8
  %94 = load i64, ptr %93, align 8
  %95 = icmp sgt i64 %94, 0
  %96 = getelementptr inbounds i8, ptr %0, i64 632
  %97 = load i64, ptr %96, align 8
  %98 = getelementptr double, ptr %75, i64 %97
  %99 = getelementptr i8, ptr %98, i64 -8
  %100 = load double, ptr %99, align 8
  %101 = getelementptr inbounds i8, ptr %0, i64 480
  %102 = load ptr, ptr %101, align 8
  %103 = load i64, ptr %78, align 8
  %104 = mul nsw i64 %103, %80
  %105 = getelementptr inbounds double, ptr %102, i64 %104
  %106 = load double, ptr %65, align 8
  %107 = getelementptr inbounds i8, ptr %65, i64 8
  %108 = load double, ptr %107, align 8
  %109 = load i64, ptr %69, align 8
  %110 = icmp eq i64 %109, 0
  br i1 %110, label %111, label %334

111:                                              ; preds = %73
  %112 = getelementptr inbounds i8, ptr %69, i64 24
  %113 = load i64, ptr %112, align 8
  %114 = add nsw i64 %113, 1
  store i64 %114, ptr %112, align 8
  %115 = load ptr, ptr %63, align 8
  %116 = load ptr, ptr %101, align 8
  %117 = getelementptr inbounds i8, ptr %0, i64 168
  %118 = load ptr, ptr %117, align 8
  store double %106, ptr %118, align 8
  %119 = getelementptr inbounds i8, ptr %0, i64 248
  %120 = load i64, ptr %119, align 8
  %121 = icmp sgt i64 %120, 0
  br i1 %121, label %122, label %123

122:                                              ; preds = %111
  tail call fastcc void @sample(ptr noundef nonnull %62) #8
  br label %123

123:                                              ; preds = %111, %122
  %124 = load ptr, ptr %62, align 8
  %125 = load i64, ptr %124, align 8
  %126 = load ptr, ptr %117, align 8
  %127 = getelementptr inbounds i8, ptr %0, i64 192
  %128 = load ptr, ptr %127, align 8
  %129 = getelementptr inbounds i8, ptr %0, i64 216
  %130 = load ptr, ptr %129, align 8
  %131 = inttoptr i64 %125 to ptr
  %132 = tail call i32 %131(ptr noundef %126, ptr noundef %115, ptr noundef %128, ptr noundef %130, ptr noundef %116) #9
  %133 = icmp eq i32 %132, 0
  br i1 %133, label %138, label %134

134:                                              ; preds = %123
  %135 = getelementptr inbounds i8, ptr %69, i64 72
  store i64 3, ptr %135, align 8
  %136 = icmp slt i32 %132, 0
  %137 = select i1 %136, i64 -4, i64 2
  br label %1495

138:                                              ; preds = %123
  store i64 1, ptr %69, align 8
  %139 = getelementptr inbounds i8, ptr %65, i64 24
  store double 1.000000e-04, ptr %139, align 8
  %140 = getelementptr inbounds i8, ptr %77, i64 40
  %141 = load double, ptr %140, align 8
  %142 = getelementptr inbounds i8, ptr %65, i64 40
  store double %141, ptr %142, align 8
  %143 = load ptr, ptr %63, align 8
  %144 = load ptr, ptr %62, align 8
  %145 = getelementptr inbounds i8, ptr %144, i64 8
  %146 = load i64, ptr %145, align 8
  %147 = load i64, ptr %96, align 8
  %148 = load ptr, ptr %74, align 8
  %149 = load ptr, ptr %68, align 8
  %150 = getelementptr inbounds i8, ptr %149, i64 48
  %151 = load i64, ptr %150, align 8
  %152 = icmp slt i64 %151, %147
  br i1 %152, label %153, label %176

153:                                              ; preds = %138
  %154 = icmp sgt i64 %146, 0
  br label %155

155:                                              ; preds = %153, %166
  %156 = phi i64 [ %151, %153 ], [ %167, %166 ]
  %157 = getelementptr inbounds double, ptr %148, i64 %156
  %158 = load double, ptr %157, align 8
  %159 = load ptr, ptr %64, align 8
  %160 = load double, ptr %159, align 8
  %161 = fcmp ugt double %158, %160
  br i1 %161, label %176, label %162

162:                                              ; preds = %155
  br i1 %154, label %163, label %166

163:                                              ; preds = %162
  %164 = mul nsw i64 %156, %146
  %165 = getelementptr double, ptr %1, i64 %164
  br label %169

166:                                              ; preds = %169, %162
  %167 = add i64 %156, 1
  %168 = icmp eq i64 %167, %147
  br i1 %168, label %176, label %155, !llvm.loop !8

169:                                              ; preds = %163, %169
  %170 = phi i64 [ 0, %163 ], [ %174, %169 ]
  %171 = getelementptr inbounds double, ptr %143, i64 %170
  %172 = load double, ptr %171, align 8
  %173 = getelementptr double, ptr %165, i64 %170
  store double %172, ptr %173, align 8
  %174 = add nuw nsw i64 %170, 1
  %175 = icmp eq i64 %174, %146
  br i1 %175, label %166, label %169, !llvm.loop !9

176:                                              ; preds = %155, %166, %138
  %177 = phi i64 [ %151, %138 ], [ %156, %155 ], [ %147, %166 ]
  %178 = load ptr, ptr %68, align 8
  %179 = getelementptr inbounds i8, ptr %178, i64 48
  store i64 %177, ptr %179, align 8
  %180 = icmp eq i64 %177, %147
  br i1 %180, label %1495, label %181

181:                                              ; preds = %176
  %182 = fcmp oeq double %108, 0.000000e+00
  br i1 %182, label %183, label %334

183:                                              ; preds = %181
  %184 = load ptr, ptr %62, align 8
  %185 = getelementptr inbounds i8, ptr %184, i64 24
  %186 = load i64, ptr %185, align 8
  %187 = load ptr, ptr %64, align 8
  %188 = getelementptr inbounds i8, ptr %187, i64 16
  %189 = load double, ptr %188, align 8
  %190 = load ptr, ptr %63, align 8
  call fastcc void @norm_to(ptr noundef nonnull %4, ptr noundef %190, ptr noundef %190, ptr noundef nonnull %63, i64 noundef %186) #8
  %191 = load double, ptr %4, align 8
  %192 = getelementptr inbounds i8, ptr %0, i64 480
  %193 = load ptr, ptr %192, align 8
  call fastcc void @norm_to(ptr noundef nonnull %5, ptr noundef %193, ptr noundef %190, ptr noundef nonnull %63, i64 noundef %186) #8
  %194 = load double, ptr %5, align 8
  %195 = fcmp uge double %191, 1.000000e-05
  %196 = fcmp uge double %194, 1.000000e-05
  %197 = and i1 %195, %196
  %198 = fmul double %191, 1.000000e-02
  %199 = fdiv double %198, %194
  %200 = select i1 %197, double %199, double 0x3EB0C6F7A0B5ED8D
  %201 = fcmp olt double %189, %200
  %202 = select i1 %201, double %189, double %200
  %203 = load ptr, ptr %62, align 8
  %204 = getelementptr inbounds i8, ptr %203, i64 8
  %205 = load i64, ptr %204, align 8
  %206 = icmp sgt i64 %205, 0
  br i1 %206, label %207, label %209

207:                                              ; preds = %183
  %208 = getelementptr inbounds i8, ptr %0, i64 360
  br label %233

209:                                              ; preds = %233, %183
  %210 = load ptr, ptr %68, align 8
  %211 = getelementptr inbounds i8, ptr %210, i64 24
  %212 = load i64, ptr %211, align 8
  %213 = add nsw i64 %212, 1
  store i64 %213, ptr %211, align 8
  %214 = fadd double %106, %202
  %215 = getelementptr inbounds i8, ptr %0, i64 360
  %216 = load ptr, ptr %215, align 8
  %217 = load ptr, ptr %101, align 8
  %218 = load i64, ptr %79, align 8
  %219 = getelementptr inbounds double, ptr %217, i64 %218
  %220 = load ptr, ptr %117, align 8
  store double %214, ptr %220, align 8
  %221 = load i64, ptr %119, align 8
  %222 = icmp sgt i64 %221, 0
  br i1 %222, label %223, label %224

223:                                              ; preds = %209
  tail call fastcc void @sample(ptr noundef nonnull %62) #8
  br label %224

224:                                              ; preds = %209, %223
  %225 = load ptr, ptr %62, align 8
  %226 = load i64, ptr %225, align 8
  %227 = load ptr, ptr %117, align 8
  %228 = load ptr, ptr %127, align 8
  %229 = load ptr, ptr %129, align 8
  %230 = inttoptr i64 %226 to ptr
  %231 = tail call i32 %230(ptr noundef %227, ptr noundef %216, ptr noundef %228, ptr noundef %229, ptr noundef %219) #9
  %232 = icmp eq i32 %231, 0
  br i1 %232, label %252, label %250

233:                                              ; preds = %207, %233
  %234 = phi i64 [ 0, %207 ], [ %245, %233 ]
  %235 = load ptr, ptr %63, align 8
  %236 = getelementptr inbounds double, ptr %235, i64 %234
  %237 = load double, ptr %236, align 8
  %238 = load ptr, ptr %101, align 8
  %239 = getelementptr inbounds double, ptr %238, i64 %234
  %240 = load double, ptr %239, align 8
  %241 = fmul double %202, %240
  %242 = fadd double %237, %241
  %243 = load ptr, ptr %208, align 8
  %244 = getelementptr inbounds double, ptr %243, i64 %234
  store double %242, ptr %244, align 8
  %245 = add nuw nsw i64 %234, 1
  %246 = load ptr, ptr %62, align 8
  %247 = getelementptr inbounds i8, ptr %246, i64 8
  %248 = load i64, ptr %247, align 8
  %249 = icmp slt i64 %245, %248
  br i1 %249, label %233, label %209, !llvm.loop !10

250:                                              ; preds = %224
  %251 = fmul double %202, 1.000000e-03
  br label %329

252:                                              ; preds = %224
  %253 = load ptr, ptr %76, align 8
  %254 = load double, ptr %253, align 8
  %255 = load ptr, ptr %192, align 8
  %256 = getelementptr inbounds i8, ptr %0, i64 320
  %257 = load i64, ptr %256, align 8
  %258 = getelementptr inbounds double, ptr %255, i64 %257
  %259 = icmp sgt i64 %186, 0
  br i1 %259, label %260, label %269

260:                                              ; preds = %252, %260
  %261 = phi i64 [ %267, %260 ], [ 0, %252 ]
  %262 = getelementptr inbounds double, ptr %258, i64 %261
  %263 = load double, ptr %262, align 8
  %264 = getelementptr inbounds double, ptr %255, i64 %261
  %265 = load double, ptr %264, align 8
  %266 = fsub double %263, %265
  store double %266, ptr %262, align 8
  %267 = add nuw nsw i64 %261, 1
  %268 = icmp eq i64 %267, %186
  br i1 %268, label %269, label %260, !llvm.loop !11

269:                                              ; preds = %260, %252
  %270 = load ptr, ptr %63, align 8
  call fastcc void @norm_to(ptr noundef nonnull %6, ptr noundef %258, ptr noundef %270, ptr noundef nonnull %63, i64 noundef %186) #8
  %271 = load double, ptr %6, align 8
  %272 = fdiv double %271, %202
  %273 = fcmp ogt double %194, %272
  %274 = select i1 %273, double %194, double %272
  %275 = fcmp ule double %274, 1.000000e-15
  %276 = fdiv double 1.000000e-02, %274
  %277 = select i1 %275, double 1.000000e+13, double %276
  %278 = bitcast double %277 to i64
  %279 = add nsw i64 %278, -4604544271217802189
  %280 = ashr i64 %279, 52
  %281 = and i64 %279, -4503599627370496
  %282 = sub nsw i64 %278, %281
  %283 = bitcast i64 %282 to double
  %284 = fadd double %283, -1.000000e+00
  %285 = fadd double %283, 1.000000e+00
  %286 = fdiv double %284, %285
  %287 = fmul double %286, %286
  %288 = tail call double @llvm.fma.f64(double %287, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %289 = tail call double @llvm.fma.f64(double %288, double %287, double 0x3FE2776C50EF9BFE)
  %290 = tail call double @llvm.fma.f64(double %289, double %287, double 0x3FEEC709DC3A03FD)
  %291 = tail call double @llvm.fma.f64(double %290, double %287, double 0x40071547652B82FE)
  %292 = trunc nsw i64 %280 to i32
  %293 = sitofp i32 %292 to double
  %294 = fmul double %286, %291
  %295 = fadd double %294, %293
  %296 = fmul double %254, %295
  %297 = fcmp ogt double %296, -1.000000e+03
  %298 = select i1 %297, double %296, double -1.000000e+03
  %299 = fcmp olt double %298, 1.000000e+03
  %300 = select i1 %299, double %298, double 1.000000e+03
  %301 = tail call double @llvm.rint.f64(double %300)
  %302 = fsub double %300, %301
  %303 = tail call double @llvm.fma.f64(double %302, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %304 = tail call double @llvm.fma.f64(double %303, double %302, double 0x3F55D87FE78A6730)
  %305 = tail call double @llvm.fma.f64(double %304, double %302, double 0x3F83B2AB6FBA4E77)
  %306 = tail call double @llvm.fma.f64(double %305, double %302, double 0x3FAC6B08D704A0BF)
  %307 = tail call double @llvm.fma.f64(double %306, double %302, double 0x3FCEBFBDFF82C58E)
  %308 = tail call double @llvm.fma.f64(double %307, double %302, double 0x3FE62E42FEFA39EF)
  %309 = tail call double @llvm.fma.f64(double %308, double %302, double 1.000000e+00)
  %310 = bitcast double %309 to i64
  %311 = fptosi double %301 to i32
  %312 = sext i32 %311 to i64
  %313 = shl nsw i64 %312, 52
  %314 = add nsw i64 %313, %310
  %315 = bitcast i64 %314 to double
  %316 = fmul double %202, 1.000000e-03
  %317 = fcmp olt double %316, 0x3EB0C6F7A0B5ED8D
  %318 = select i1 %317, double 0x3EB0C6F7A0B5ED8D, double %316
  %319 = fmul double %202, 1.000000e+02
  %320 = select i1 %275, double %318, double %315
  %321 = fcmp olt double %319, %320
  %322 = select i1 %321, double %319, double %320
  %323 = tail call double @llvm.fabs.f64(double %106)
  %324 = fmul double %323, 0x3D30000000000000
  %325 = fcmp ogt double %324, %322
  %326 = select i1 %325, double %324, double %322
  %327 = fcmp olt double %189, %326
  %328 = select i1 %327, double %189, double %326
  br label %329

329:                                              ; preds = %250, %269
  %330 = phi double [ %251, %250 ], [ %328, %269 ]
  %331 = tail call i1 @llvm.is.fpclass.f64(double %330, i32 639)
  br i1 %331, label %332, label %334

332:                                              ; preds = %329
  %333 = getelementptr inbounds i8, ptr %69, i64 72
  store i64 4, ptr %333, align 8
  br label %334

334:                                              ; preds = %181, %332, %329, %73
  %335 = phi double [ %330, %329 ], [ %330, %332 ], [ %108, %181 ], [ %108, %73 ]
  %336 = load i64, ptr %70, align 8
  %337 = icmp eq i64 %336, 0
  br i1 %337, label %424, label %338

338:                                              ; preds = %334
  %339 = getelementptr inbounds i8, ptr %0, i64 1080
  %340 = getelementptr inbounds i8, ptr %69, i64 8
  %341 = getelementptr inbounds i8, ptr %69, i64 16
  %342 = getelementptr inbounds i8, ptr %69, i64 64
  %343 = getelementptr inbounds i8, ptr %69, i64 48
  %344 = getelementptr inbounds i8, ptr %65, i64 16
  %345 = getelementptr inbounds i8, ptr %69, i64 24
  %346 = getelementptr inbounds i8, ptr %0, i64 384
  %347 = getelementptr inbounds i8, ptr %0, i64 360
  %348 = getelementptr inbounds i8, ptr %0, i64 24
  %349 = getelementptr inbounds i8, ptr %0, i64 480
  %350 = getelementptr inbounds i8, ptr %0, i64 48
  %351 = getelementptr inbounds i8, ptr %0, i64 72
  %352 = getelementptr inbounds i8, ptr %0, i64 320
  %353 = getelementptr inbounds i8, ptr %0, i64 96
  %354 = getelementptr inbounds i8, ptr %0, i64 168
  %355 = getelementptr inbounds i8, ptr %0, i64 248
  %356 = getelementptr inbounds i8, ptr %0, i64 192
  %357 = getelementptr inbounds i8, ptr %0, i64 216
  %358 = getelementptr inbounds i8, ptr %0, i64 336
  %359 = getelementptr inbounds i8, ptr %0, i64 24
  %360 = getelementptr inbounds i8, ptr %0, i64 480
  %361 = getelementptr inbounds i8, ptr %0, i64 48
  %362 = getelementptr inbounds i8, ptr %0, i64 72
  %363 = getelementptr inbounds i8, ptr %0, i64 168
  %364 = getelementptr inbounds i8, ptr %0, i64 248
  %365 = getelementptr inbounds i8, ptr %0, i64 192
  %366 = getelementptr inbounds i8, ptr %0, i64 216
  %367 = getelementptr inbounds i8, ptr %0, i64 456
  %368 = getelementptr inbounds i8, ptr %0, i64 320
  %369 = getelementptr inbounds i8, ptr %0, i64 432
  %370 = getelementptr inbounds i8, ptr %0, i64 24
  %371 = getelementptr inbounds i8, ptr %0, i64 480
  %372 = getelementptr inbounds i8, ptr %0, i64 48
  %373 = getelementptr inbounds i8, ptr %0, i64 72
  %374 = getelementptr inbounds i8, ptr %0, i64 336
  %375 = getelementptr inbounds i8, ptr %0, i64 552
  %376 = getelementptr inbounds i8, ptr %0, i64 528
  %377 = getelementptr inbounds i8, ptr %0, i64 336
  %378 = icmp sgt i64 %80, 0
  %379 = select i1 %84, i1 %90, i1 false
  %380 = getelementptr inbounds i8, ptr %0, i64 168
  %381 = getelementptr inbounds i8, ptr %0, i64 248
  %382 = getelementptr inbounds i8, ptr %0, i64 192
  %383 = getelementptr inbounds i8, ptr %0, i64 216
  %384 = getelementptr inbounds i8, ptr %65, i64 32
  %385 = getelementptr inbounds i8, ptr %0, i64 1104
  %386 = getelementptr inbounds i8, ptr %0, i64 1120
  %387 = getelementptr inbounds i8, ptr %69, i64 48
  %388 = getelementptr inbounds i8, ptr %0, i64 320
  %389 = getelementptr inbounds i8, ptr %0, i64 480
  %390 = getelementptr inbounds i8, ptr %0, i64 504
  %391 = getelementptr inbounds i8, ptr %0, i64 360
  %392 = getelementptr inbounds i8, ptr %0, i64 24
  %393 = getelementptr inbounds i8, ptr %0, i64 48
  %394 = getelementptr inbounds i8, ptr %0, i64 72
  %395 = getelementptr inbounds i8, ptr %0, i64 96
  %396 = getelementptr inbounds i8, ptr %0, i64 168
  %397 = getelementptr inbounds i8, ptr %0, i64 248
  %398 = getelementptr inbounds i8, ptr %0, i64 192
  %399 = getelementptr inbounds i8, ptr %0, i64 216
  %400 = getelementptr inbounds i8, ptr %0, i64 336
  %401 = getelementptr inbounds i8, ptr %0, i64 432
  %402 = getelementptr inbounds i8, ptr %0, i64 24
  %403 = getelementptr inbounds i8, ptr %0, i64 48
  %404 = getelementptr inbounds i8, ptr %0, i64 72
  %405 = getelementptr inbounds i8, ptr %69, i64 72
  %406 = getelementptr inbounds i8, ptr %0, i64 408
  %407 = getelementptr inbounds i8, ptr %0, i64 360
  %408 = getelementptr inbounds i8, ptr %0, i64 408
  %409 = getelementptr inbounds i8, ptr %65, i64 24
  %410 = getelementptr inbounds i8, ptr %65, i64 40
  %411 = getelementptr inbounds i8, ptr %77, i64 24
  %412 = getelementptr inbounds i8, ptr %77, i64 8
  %413 = getelementptr inbounds i8, ptr %77, i64 16
  %414 = getelementptr inbounds i8, ptr %77, i64 32
  %415 = getelementptr inbounds i8, ptr %77, i64 40
  %416 = icmp sgt i64 %80, 0
  %417 = getelementptr inbounds i8, ptr %69, i64 48
  %418 = getelementptr inbounds i8, ptr %69, i64 72
  %419 = getelementptr inbounds i8, ptr %65, i64 40
  %420 = getelementptr inbounds i8, ptr %69, i64 72
  %421 = getelementptr inbounds i8, ptr %77, i64 24
  %422 = getelementptr inbounds i8, ptr %77, i64 32
  %423 = getelementptr inbounds i8, ptr %65, i64 40
  br label %426

424:                                              ; preds = %1492, %334
  %425 = phi double [ %335, %334 ], [ %1488, %1492 ]
  store double %425, ptr %107, align 8
  br label %1495

426:                                              ; preds = %338, %1492
  %427 = phi i64 [ %336, %338 ], [ %1493, %1492 ]
  %428 = phi i64 [ undef, %338 ], [ %1491, %1492 ]
  %429 = phi double [ %106, %338 ], [ %1489, %1492 ]
  %430 = phi double [ %335, %338 ], [ %1488, %1492 ]
  %431 = load ptr, ptr %339, align 8
  %432 = getelementptr inbounds i8, ptr %431, i64 8
  %433 = load i64, ptr %432, align 8
  %434 = icmp sgt i64 %433, 0
  br i1 %434, label %435, label %440

435:                                              ; preds = %426
  %436 = load i64, ptr %431, align 8
  %437 = add nsw i64 %436, 3
  %438 = icmp slt i64 %433, %437
  %439 = zext i1 %438 to i32
  br label %440

440:                                              ; preds = %426, %435
  %441 = phi i32 [ 0, %426 ], [ %439, %435 ]
  %442 = icmp eq i32 %441, 0
  br i1 %442, label %444, label %443

443:                                              ; preds = %440
  store double %430, ptr %107, align 8
  br label %1495

444:                                              ; preds = %440
  %445 = add nsw i64 %427, -1
  store i64 %445, ptr %70, align 8
  %446 = load i64, ptr %340, align 8
  %447 = load i64, ptr %341, align 8
  %448 = add nsw i64 %447, %446
  %449 = load i64, ptr %342, align 8
  %450 = icmp slt i64 %448, %449
  br i1 %450, label %452, label %451

451:                                              ; preds = %444
  store double %430, ptr %107, align 8
  br label %1495

452:                                              ; preds = %444
  br i1 %87, label %453, label %457

453:                                              ; preds = %452
  %454 = load i64, ptr %343, align 8
  %455 = getelementptr inbounds double, ptr %75, i64 %454
  %456 = load double, ptr %455, align 8
  br label %457

457:                                              ; preds = %452, %453
  %458 = phi double [ %456, %453 ], [ %100, %452 ]
  br i1 %87, label %463, label %459

459:                                              ; preds = %457
  %460 = load double, ptr %344, align 8
  %461 = fcmp olt double %430, %460
  %462 = select i1 %461, double %430, double %460
  br label %469

463:                                              ; preds = %457
  %464 = fsub double %458, %429
  %465 = fdiv double %464, %430
  %466 = fmul double %465, 0x3FEFFFFFFFFFDCD1
  %467 = tail call double @llvm.ceil.f64(double %466)
  %468 = fdiv double %464, %467
  br label %469

469:                                              ; preds = %463, %459
  %470 = phi double [ %462, %459 ], [ %468, %463 ]
  %471 = fadd double %429, %470
  %472 = fmul double %470, 1.000000e-03
  %473 = fsub double %458, %472
  %474 = fcmp ule double %471, %473
  %475 = fsub double %458, %429
  %476 = select i1 %474, double %470, double %475
  %477 = select i1 %474, double %471, double %458
  %478 = fmul double %476, 6.250000e-02
  %479 = fadd double %429, %478
  %480 = fcmp ule double %479, %429
  %481 = fcmp une double %477, %458
  %482 = and i1 %481, %480
  br i1 %482, label %483, label %484

483:                                              ; preds = %469
  store double %476, ptr %107, align 8
  br label %1487

484:                                              ; preds = %469
  %485 = load ptr, ptr %0, align 8
  %486 = load i64, ptr %485, align 8
  %487 = load ptr, ptr %346, align 8
  %488 = insertelement <8 x double> poison, double %476, i64 0
  %489 = shufflevector <8 x double> %488, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %489, ptr %487, align 8
  %490 = icmp sgt i64 %486, 1
  br i1 %490, label %495, label %579

491:                                              ; preds = %568
  %492 = add nuw nsw i64 %498, 1
  %493 = icmp slt i64 %492, %486
  %494 = icmp eq i64 %492, %486
  br i1 %494, label %579, label %495, !llvm.loop !12

495:                                              ; preds = %484, %491
  %496 = phi i1 [ %493, %491 ], [ %490, %484 ]
  %497 = phi i64 [ %578, %491 ], [ undef, %484 ]
  %498 = phi i64 [ %492, %491 ], [ 1, %484 ]
  %499 = load ptr, ptr %347, align 8
  %500 = load ptr, ptr %63, align 8
  %501 = load ptr, ptr %62, align 8
  %502 = getelementptr inbounds i8, ptr %501, i64 16
  %503 = load i64, ptr %502, align 8
  %504 = icmp sgt i64 %503, 1
  %505 = zext i1 %504 to i64
  %506 = load ptr, ptr %348, align 8
  %507 = getelementptr inbounds i64, ptr %506, i64 %498
  %508 = load i64, ptr %507, align 8
  %509 = getelementptr i8, ptr %507, i64 8
  %510 = load i64, ptr %509, align 8
  %511 = xor i64 %508, -1
  %512 = add i64 %510, %511
  %513 = load ptr, ptr %346, align 8
  %514 = load ptr, ptr %349, align 8
  %515 = load ptr, ptr %350, align 8
  %516 = getelementptr inbounds i64, ptr %515, i64 %508
  %517 = load ptr, ptr %351, align 8
  %518 = getelementptr inbounds double, ptr %517, i64 %508
  tail call fastcc void @combine(ptr noundef %499, ptr noundef %500, ptr noundef %513, ptr noundef %514, ptr noundef %516, ptr noundef %518, i64 noundef %512, i64 noundef %505, i64 noundef %503) #8
  %519 = icmp eq i64 %503, 1
  br i1 %519, label %520, label %551

520:                                              ; preds = %495
  %521 = load ptr, ptr %348, align 8
  %522 = getelementptr i64, ptr %521, i64 %498
  %523 = getelementptr i8, ptr %522, i64 8
  %524 = load i64, ptr %523, align 8
  %525 = add nsw i64 %524, -1
  %526 = load ptr, ptr %351, align 8
  %527 = getelementptr inbounds double, ptr %526, i64 %525
  %528 = load double, ptr %527, align 8
  %529 = fmul double %476, %528
  %530 = load ptr, ptr %349, align 8
  %531 = load ptr, ptr %350, align 8
  %532 = getelementptr inbounds i64, ptr %531, i64 %525
  %533 = load i64, ptr %532, align 8
  %534 = getelementptr inbounds double, ptr %530, i64 %533
  %535 = load ptr, ptr %62, align 8
  %536 = getelementptr inbounds i8, ptr %535, i64 8
  %537 = load i64, ptr %536, align 8
  %538 = icmp sgt i64 %537, 0
  br i1 %538, label %539, label %551

539:                                              ; preds = %520, %539
  %540 = phi i64 [ %546, %539 ], [ 0, %520 ]
  %541 = getelementptr inbounds double, ptr %534, i64 %540
  %542 = load double, ptr %541, align 8
  %543 = getelementptr inbounds double, ptr %499, i64 %540
  %544 = load double, ptr %543, align 8
  %545 = tail call double @llvm.fma.f64(double %529, double %542, double %544)
  store double %545, ptr %543, align 8
  %546 = add nuw nsw i64 %540, 1
  %547 = load ptr, ptr %62, align 8
  %548 = getelementptr inbounds i8, ptr %547, i64 8
  %549 = load i64, ptr %548, align 8
  %550 = icmp slt i64 %546, %549
  br i1 %550, label %539, label %551, !llvm.loop !13

551:                                              ; preds = %539, %520, %495
  %552 = load ptr, ptr %349, align 8
  %553 = load i64, ptr %352, align 8
  %554 = mul nsw i64 %553, %498
  %555 = getelementptr inbounds double, ptr %552, i64 %554
  %556 = load i64, ptr %345, align 8
  %557 = add nsw i64 %556, 1
  store i64 %557, ptr %345, align 8
  %558 = load ptr, ptr %353, align 8
  %559 = getelementptr inbounds double, ptr %558, i64 %498
  %560 = load double, ptr %559, align 8
  %561 = fmul double %476, %560
  %562 = fadd double %429, %561
  %563 = load ptr, ptr %347, align 8
  %564 = load ptr, ptr %354, align 8
  store double %562, ptr %564, align 8
  %565 = load i64, ptr %355, align 8
  %566 = icmp sgt i64 %565, 0
  br i1 %566, label %567, label %568

567:                                              ; preds = %551
  tail call fastcc void @sample(ptr noundef nonnull %62) #8
  br label %568

568:                                              ; preds = %551, %567
  %569 = load ptr, ptr %62, align 8
  %570 = load i64, ptr %569, align 8
  %571 = load ptr, ptr %354, align 8
  %572 = load ptr, ptr %356, align 8
  %573 = load ptr, ptr %357, align 8
  %574 = inttoptr i64 %570 to ptr
  %575 = tail call i32 %574(ptr noundef %571, ptr noundef %563, ptr noundef %572, ptr noundef %573, ptr noundef %555) #9
  %576 = sext i32 %575 to i64
  %577 = icmp eq i32 %575, 0
  %578 = select i1 %577, i64 %497, i64 %576
  br i1 %577, label %491, label %579

579:                                              ; preds = %491, %568, %484
  %580 = phi i1 [ %490, %484 ], [ %493, %491 ], [ %496, %568 ]
  %581 = phi i64 [ 0, %484 ], [ %576, %568 ], [ %576, %491 ]
  %582 = phi i64 [ undef, %484 ], [ %578, %568 ], [ %578, %491 ]
  br i1 %580, label %636, label %583

583:                                              ; preds = %579
  %584 = load ptr, ptr %358, align 8
  %585 = load ptr, ptr %63, align 8
  %586 = load ptr, ptr %62, align 8
  %587 = getelementptr inbounds i8, ptr %586, i64 16
  %588 = load i64, ptr %587, align 8
  %589 = icmp sgt i64 %588, 1
  %590 = zext i1 %589 to i64
  %591 = load ptr, ptr %359, align 8
  %592 = getelementptr inbounds i64, ptr %591, i64 %486
  %593 = load i64, ptr %592, align 8
  %594 = getelementptr i8, ptr %592, i64 8
  %595 = load i64, ptr %594, align 8
  %596 = xor i64 %593, -1
  %597 = add i64 %595, %596
  %598 = load ptr, ptr %346, align 8
  %599 = load ptr, ptr %360, align 8
  %600 = load ptr, ptr %361, align 8
  %601 = getelementptr inbounds i64, ptr %600, i64 %593
  %602 = load ptr, ptr %362, align 8
  %603 = getelementptr inbounds double, ptr %602, i64 %593
  tail call fastcc void @combine(ptr noundef %584, ptr noundef %585, ptr noundef %598, ptr noundef %599, ptr noundef %601, ptr noundef %603, i64 noundef %597, i64 noundef %590, i64 noundef %588) #8
  %604 = icmp eq i64 %588, 1
  br i1 %604, label %605, label %636

605:                                              ; preds = %583
  %606 = load ptr, ptr %359, align 8
  %607 = getelementptr i64, ptr %606, i64 %486
  %608 = getelementptr i8, ptr %607, i64 8
  %609 = load i64, ptr %608, align 8
  %610 = add nsw i64 %609, -1
  %611 = load ptr, ptr %362, align 8
  %612 = getelementptr inbounds double, ptr %611, i64 %610
  %613 = load double, ptr %612, align 8
  %614 = fmul double %476, %613
  %615 = load ptr, ptr %360, align 8
  %616 = load ptr, ptr %361, align 8
  %617 = getelementptr inbounds i64, ptr %616, i64 %610
  %618 = load i64, ptr %617, align 8
  %619 = getelementptr inbounds double, ptr %615, i64 %618
  %620 = load ptr, ptr %62, align 8
  %621 = getelementptr inbounds i8, ptr %620, i64 8
  %622 = load i64, ptr %621, align 8
  %623 = icmp sgt i64 %622, 0
  br i1 %623, label %624, label %636

624:                                              ; preds = %605, %624
  %625 = phi i64 [ %631, %624 ], [ 0, %605 ]
  %626 = getelementptr inbounds double, ptr %619, i64 %625
  %627 = load double, ptr %626, align 8
  %628 = getelementptr inbounds double, ptr %584, i64 %625
  %629 = load double, ptr %628, align 8
  %630 = tail call double @llvm.fma.f64(double %614, double %627, double %629)
  store double %630, ptr %628, align 8
  %631 = add nuw nsw i64 %625, 1
  %632 = load ptr, ptr %62, align 8
  %633 = getelementptr inbounds i8, ptr %632, i64 8
  %634 = load i64, ptr %633, align 8
  %635 = icmp slt i64 %631, %634
  br i1 %635, label %624, label %636, !llvm.loop !13

636:                                              ; preds = %624, %605, %583, %579
  %637 = phi i64 [ %582, %579 ], [ %581, %583 ], [ %581, %605 ], [ %581, %624 ]
  %638 = icmp eq i64 %637, 0
  %639 = select i1 %638, i1 %90, i1 false
  br i1 %639, label %640, label %656

640:                                              ; preds = %636
  %641 = load i64, ptr %345, align 8
  %642 = add nsw i64 %641, 1
  store i64 %642, ptr %345, align 8
  %643 = load ptr, ptr %363, align 8
  store double %477, ptr %643, align 8
  %644 = load i64, ptr %364, align 8
  %645 = icmp sgt i64 %644, 0
  br i1 %645, label %646, label %647

646:                                              ; preds = %640
  tail call fastcc void @sample(ptr noundef nonnull %62) #8
  br label %647

647:                                              ; preds = %640, %646
  %648 = load ptr, ptr %62, align 8
  %649 = load i64, ptr %648, align 8
  %650 = load ptr, ptr %363, align 8
  %651 = load ptr, ptr %365, align 8
  %652 = load ptr, ptr %366, align 8
  %653 = inttoptr i64 %649 to ptr
  %654 = tail call i32 %653(ptr noundef %650, ptr noundef %67, ptr noundef %651, ptr noundef %652, ptr noundef %105) #9
  %655 = sext i32 %654 to i64
  br label %656

656:                                              ; preds = %647, %636
  %657 = phi i64 [ %655, %647 ], [ %637, %636 ]
  %658 = icmp slt i64 %657, 0
  br i1 %658, label %1487, label %659

659:                                              ; preds = %656
  %660 = icmp eq i64 %657, 0
  br i1 %660, label %661, label %852

661:                                              ; preds = %659
  br i1 %87, label %662, label %663

662:                                              ; preds = %661
  br i1 %378, label %812, label %821

663:                                              ; preds = %661
  %664 = load ptr, ptr %62, align 8
  %665 = load ptr, ptr %0, align 8
  %666 = getelementptr inbounds i8, ptr %664, i64 24
  %667 = load i64, ptr %666, align 8
  %668 = getelementptr inbounds i8, ptr %665, i64 8
  %669 = load i64, ptr %668, align 8
  %670 = load ptr, ptr %367, align 8
  %671 = load i64, ptr %368, align 8
  %672 = getelementptr inbounds double, ptr %670, i64 %671
  %673 = icmp sgt i64 %669, 0
  br i1 %673, label %674, label %676

674:                                              ; preds = %663
  %675 = getelementptr inbounds i8, ptr %664, i64 32
  br label %684

676:                                              ; preds = %684, %663
  %677 = icmp sgt i64 %667, 0
  br i1 %677, label %678, label %710

678:                                              ; preds = %676
  %679 = load ptr, ptr %63, align 8
  %680 = load ptr, ptr %374, align 8
  %681 = load ptr, ptr %375, align 8
  %682 = load ptr, ptr %376, align 8
  %683 = load ptr, ptr %367, align 8
  br label %768

684:                                              ; preds = %674, %684
  %685 = phi i64 [ 0, %674 ], [ %708, %684 ]
  %686 = load i64, ptr %665, align 8
  %687 = load i64, ptr %675, align 8
  %688 = load ptr, ptr %367, align 8
  %689 = load i64, ptr %368, align 8
  %690 = mul nsw i64 %689, %685
  %691 = getelementptr inbounds double, ptr %688, i64 %690
  %692 = load ptr, ptr %369, align 8
  %693 = load ptr, ptr %370, align 8
  %694 = getelementptr i64, ptr %693, i64 %686
  %695 = getelementptr i8, ptr %694, i64 8
  %696 = getelementptr i64, ptr %695, i64 %685
  %697 = load i64, ptr %696, align 8
  %698 = getelementptr i8, ptr %696, i64 8
  %699 = load i64, ptr %698, align 8
  %700 = xor i64 %697, -1
  %701 = add i64 %699, %700
  %702 = load ptr, ptr %346, align 8
  %703 = load ptr, ptr %371, align 8
  %704 = load ptr, ptr %372, align 8
  %705 = getelementptr inbounds i64, ptr %704, i64 %697
  %706 = load ptr, ptr %373, align 8
  %707 = getelementptr inbounds double, ptr %706, i64 %697
  tail call fastcc void @combine(ptr noundef %691, ptr noundef %692, ptr noundef %702, ptr noundef %703, ptr noundef %705, ptr noundef %707, i64 noundef %701, i64 noundef 1, i64 noundef %687) #8
  %708 = add nuw nsw i64 %685, 1
  %709 = icmp eq i64 %708, %669
  br i1 %709, label %676, label %684, !llvm.loop !14

710:                                              ; preds = %768, %676
  %711 = phi double [ 0.000000e+00, %676 ], [ %796, %768 ]
  %712 = phi double [ 0.000000e+00, %676 ], [ %794, %768 ]
  %713 = load ptr, ptr %377, align 8
  %714 = getelementptr inbounds i8, ptr %664, i64 8
  %715 = load i64, ptr %714, align 8
  %716 = add nsw i64 %715, -3
  %717 = getelementptr i8, ptr %713, i64 8
  %718 = getelementptr i8, ptr %713, i64 16
  %719 = getelementptr i8, ptr %713, i64 24
  %720 = icmp slt i64 %667, %716
  br i1 %720, label %728, label %721

721:                                              ; preds = %728, %710
  %722 = phi double [ 0.000000e+00, %710 ], [ %737, %728 ]
  %723 = phi double [ 0.000000e+00, %710 ], [ %741, %728 ]
  %724 = phi double [ 0.000000e+00, %710 ], [ %745, %728 ]
  %725 = phi double [ 0.000000e+00, %710 ], [ %749, %728 ]
  %726 = phi i64 [ %667, %710 ], [ %750, %728 ]
  %727 = icmp slt i64 %726, %715
  br i1 %727, label %752, label %761

728:                                              ; preds = %710, %728
  %729 = phi i64 [ %750, %728 ], [ %667, %710 ]
  %730 = phi double [ %749, %728 ], [ 0.000000e+00, %710 ]
  %731 = phi double [ %745, %728 ], [ 0.000000e+00, %710 ]
  %732 = phi double [ %741, %728 ], [ 0.000000e+00, %710 ]
  %733 = phi double [ %737, %728 ], [ 0.000000e+00, %710 ]
  %734 = getelementptr inbounds double, ptr %713, i64 %729
  %735 = load double, ptr %734, align 8
  %736 = fmul double %735, 0.000000e+00
  %737 = fadd double %733, %736
  %738 = getelementptr double, ptr %717, i64 %729
  %739 = load double, ptr %738, align 8
  %740 = fmul double %739, 0.000000e+00
  %741 = fadd double %732, %740
  %742 = getelementptr double, ptr %718, i64 %729
  %743 = load double, ptr %742, align 8
  %744 = fmul double %743, 0.000000e+00
  %745 = fadd double %731, %744
  %746 = getelementptr double, ptr %719, i64 %729
  %747 = load double, ptr %746, align 8
  %748 = fmul double %747, 0.000000e+00
  %749 = fadd double %730, %748
  %750 = add nsw i64 %729, 4
  %751 = icmp slt i64 %750, %716
  br i1 %751, label %728, label %721, !llvm.loop !15

752:                                              ; preds = %721, %752
  %753 = phi i64 [ %759, %752 ], [ %726, %721 ]
  %754 = phi double [ %758, %752 ], [ %722, %721 ]
  %755 = getelementptr inbounds double, ptr %713, i64 %753
  %756 = load double, ptr %755, align 8
  %757 = fmul double %756, 0.000000e+00
  %758 = fadd double %754, %757
  %759 = add nsw i64 %753, 1
  %760 = icmp eq i64 %759, %715
  br i1 %760, label %761, label %752, !llvm.loop !16

761:                                              ; preds = %752, %721
  %762 = phi double [ %722, %721 ], [ %758, %752 ]
  %763 = fadd double %723, %762
  %764 = fadd double %724, %725
  %765 = fadd double %764, %763
  %766 = fadd double %712, %765
  %767 = icmp eq i64 %669, 2
  br i1 %767, label %799, label %808

768:                                              ; preds = %678, %768
  %769 = phi double [ 0.000000e+00, %678 ], [ %794, %768 ]
  %770 = phi double [ 0.000000e+00, %678 ], [ %796, %768 ]
  %771 = phi i64 [ 0, %678 ], [ %797, %768 ]
  %772 = getelementptr inbounds double, ptr %679, i64 %771
  %773 = load double, ptr %772, align 8
  %774 = getelementptr inbounds double, ptr %680, i64 %771
  %775 = load double, ptr %774, align 8
  %776 = getelementptr inbounds double, ptr %681, i64 %771
  %777 = load double, ptr %776, align 8
  %778 = getelementptr inbounds double, ptr %682, i64 %771
  %779 = load double, ptr %778, align 8
  %780 = tail call double @llvm.fabs.f64(double %773)
  %781 = tail call double @llvm.fabs.f64(double %775)
  %782 = fcmp ogt double %780, %781
  %783 = select i1 %782, double %780, double %781
  %784 = fmul double %783, %779
  %785 = fadd double %777, %784
  %786 = fdiv double 1.000000e+00, %785
  %787 = getelementptr inbounds double, ptr %683, i64 %771
  %788 = load double, ptr %787, align 8
  %789 = fmul double %788, %786
  %790 = getelementptr inbounds double, ptr %672, i64 %771
  %791 = load double, ptr %790, align 8
  %792 = fmul double %791, %786
  %793 = fmul double %789, %789
  %794 = fadd double %769, %793
  %795 = fmul double %792, %792
  %796 = fadd double %770, %795
  %797 = add nuw nsw i64 %771, 1
  %798 = icmp eq i64 %797, %667
  br i1 %798, label %710, label %768, !llvm.loop !17

799:                                              ; preds = %761
  %800 = fmul double %711, 1.000000e-02
  %801 = fadd double %800, %766
  %802 = sitofp i64 %667 to double
  %803 = fmul double %801, %802
  %804 = tail call double @llvm.sqrt.f64(double %803)
  %805 = fdiv double %766, %804
  %806 = fcmp une double %766, 0.000000e+00
  %807 = select i1 %806, double %805, double 0.000000e+00
  br label %821

808:                                              ; preds = %761
  %809 = sitofp i64 %667 to double
  %810 = fdiv double %766, %809
  %811 = tail call double @llvm.sqrt.f64(double %810)
  br label %821

812:                                              ; preds = %662, %812
  %813 = phi i64 [ %819, %812 ], [ 0, %662 ]
  %814 = phi double [ %818, %812 ], [ 0.000000e+00, %662 ]
  %815 = getelementptr inbounds double, ptr %67, i64 %813
  %816 = load double, ptr %815, align 8
  %817 = fmul double %816, 0.000000e+00
  %818 = fadd double %814, %817
  %819 = add nuw nsw i64 %813, 1
  %820 = icmp eq i64 %819, %80
  br i1 %820, label %821, label %812, !llvm.loop !18

821:                                              ; preds = %812, %662, %808, %799
  %822 = phi double [ %807, %799 ], [ %811, %808 ], [ 0.000000e+00, %662 ], [ %818, %812 ]
  %823 = fcmp uge double %822, 1.000000e+00
  %824 = select i1 %823, i1 true, i1 %379
  br i1 %824, label %852, label %825

825:                                              ; preds = %821
  br i1 %84, label %833, label %826

826:                                              ; preds = %825
  %827 = load ptr, ptr %81, align 8
  %828 = getelementptr inbounds i8, ptr %827, i64 56
  %829 = load i64, ptr %828, align 8
  %830 = inttoptr i64 %829 to ptr
  %831 = tail call i64 %830(ptr noundef %0, double noundef %477, ptr noundef %67) #9
  %832 = icmp ne i64 %831, 0
  br label %833

833:                                              ; preds = %826, %825
  %834 = phi i1 [ false, %825 ], [ %832, %826 ]
  br i1 %834, label %852, label %835

835:                                              ; preds = %833
  %836 = load i64, ptr %345, align 8
  %837 = add nsw i64 %836, 1
  store i64 %837, ptr %345, align 8
  %838 = load ptr, ptr %380, align 8
  store double %477, ptr %838, align 8
  %839 = load i64, ptr %381, align 8
  %840 = icmp sgt i64 %839, 0
  br i1 %840, label %841, label %842

841:                                              ; preds = %835
  tail call fastcc void @sample(ptr noundef nonnull %62) #8
  br label %842

842:                                              ; preds = %835, %841
  %843 = load ptr, ptr %62, align 8
  %844 = load i64, ptr %843, align 8
  %845 = load ptr, ptr %380, align 8
  %846 = load ptr, ptr %382, align 8
  %847 = load ptr, ptr %383, align 8
  %848 = inttoptr i64 %844 to ptr
  %849 = tail call i32 %848(ptr noundef %845, ptr noundef %67, ptr noundef %846, ptr noundef %847, ptr noundef %105) #9
  %850 = sext i32 %849 to i64
  %851 = icmp slt i32 %849, 0
  br i1 %851, label %1487, label %852

852:                                              ; preds = %821, %842, %833, %659
  %853 = phi i64 [ 0, %833 ], [ %850, %842 ], [ 0, %821 ], [ %657, %659 ]
  %854 = phi double [ %822, %833 ], [ %822, %842 ], [ %822, %821 ], [ 0.000000e+00, %659 ]
  %855 = phi i1 [ %834, %833 ], [ %834, %842 ], [ false, %821 ], [ false, %659 ]
  %856 = icmp ne i64 %853, 0
  %857 = fcmp uge double %854, 1.000000e+00
  %858 = or i1 %856, %857
  %859 = or i1 %855, %858
  br i1 %859, label %860, label %923

860:                                              ; preds = %852
  %861 = load i64, ptr %341, align 8
  %862 = add nsw i64 %861, 1
  store i64 %862, ptr %341, align 8
  %863 = or i1 %856, %855
  br i1 %863, label %867, label %864

864:                                              ; preds = %860
  %865 = tail call double @llvm.fabs.f64(double %854)
  %866 = fcmp one double %865, 0x7FF0000000000000
  br label %867

867:                                              ; preds = %864, %860
  %868 = phi i1 [ false, %860 ], [ %866, %864 ]
  %869 = select i1 %868, i64 2, i64 4
  %870 = select i1 %855, i64 6, i64 %869
  %871 = select i1 %856, i64 3, i64 %870
  store i64 %871, ptr %420, align 8
  %872 = fcmp ogt double %854, 1.000000e-10
  %873 = select i1 %872, double %854, double 1.000000e-10
  %874 = load double, ptr %421, align 8
  %875 = load double, ptr %77, align 8
  %876 = fneg double %875
  %877 = bitcast double %873 to i64
  %878 = add nsw i64 %877, -4604544271217802189
  %879 = ashr i64 %878, 52
  %880 = and i64 %878, -4503599627370496
  %881 = sub nsw i64 %877, %880
  %882 = bitcast i64 %881 to double
  %883 = fadd double %882, -1.000000e+00
  %884 = fadd double %882, 1.000000e+00
  %885 = fdiv double %883, %884
  %886 = fmul double %885, %885
  %887 = tail call double @llvm.fma.f64(double %886, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %888 = tail call double @llvm.fma.f64(double %887, double %886, double 0x3FE2776C50EF9BFE)
  %889 = tail call double @llvm.fma.f64(double %888, double %886, double 0x3FEEC709DC3A03FD)
  %890 = tail call double @llvm.fma.f64(double %889, double %886, double 0x40071547652B82FE)
  %891 = trunc nsw i64 %879 to i32
  %892 = sitofp i32 %891 to double
  %893 = fmul double %885, %890
  %894 = fadd double %893, %892
  %895 = fmul double %894, %876
  %896 = fcmp ogt double %895, -1.000000e+03
  %897 = select i1 %896, double %895, double -1.000000e+03
  %898 = fcmp olt double %897, 1.000000e+03
  %899 = select i1 %898, double %897, double 1.000000e+03
  %900 = tail call double @llvm.rint.f64(double %899)
  %901 = fsub double %899, %900
  %902 = tail call double @llvm.fma.f64(double %901, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %903 = tail call double @llvm.fma.f64(double %902, double %901, double 0x3F55D87FE78A6730)
  %904 = tail call double @llvm.fma.f64(double %903, double %901, double 0x3F83B2AB6FBA4E77)
  %905 = tail call double @llvm.fma.f64(double %904, double %901, double 0x3FAC6B08D704A0BF)
  %906 = tail call double @llvm.fma.f64(double %905, double %901, double 0x3FCEBFBDFF82C58E)
  %907 = tail call double @llvm.fma.f64(double %906, double %901, double 0x3FE62E42FEFA39EF)
  %908 = tail call double @llvm.fma.f64(double %907, double %901, double 1.000000e+00)
  %909 = bitcast double %908 to i64
  %910 = fptosi double %900 to i32
  %911 = sext i32 %910 to i64
  %912 = shl nsw i64 %911, 52
  %913 = add nsw i64 %912, %909
  %914 = bitcast i64 %913 to double
  %915 = fmul double %874, %914
  %916 = load double, ptr %422, align 8
  %917 = fcmp ogt double %915, %916
  %918 = select i1 %917, double %915, double %916
  %919 = select i1 %868, double %918, double 2.500000e-01
  %920 = fmul double %476, %919
  br i1 %87, label %921, label %922

921:                                              ; preds = %867
  store double %476, ptr %107, align 8
  br label %1487

922:                                              ; preds = %867
  store double 1.000000e+00, ptr %423, align 8
  br label %1487, !llvm.loop !19

923:                                              ; preds = %852
  %924 = load i64, ptr %340, align 8
  %925 = add nsw i64 %924, 1
  store i64 %925, ptr %340, align 8
  store double %477, ptr %65, align 8
  store double %476, ptr %384, align 8
  %926 = load ptr, ptr %339, align 8
  %927 = getelementptr inbounds i8, ptr %926, i64 8
  %928 = load i64, ptr %927, align 8
  %929 = icmp eq i64 %928, 0
  br i1 %929, label %959, label %930

930:                                              ; preds = %923
  %931 = load i64, ptr %926, align 8
  %932 = load ptr, ptr %62, align 8
  %933 = getelementptr inbounds i8, ptr %932, i64 8
  %934 = load i64, ptr %933, align 8
  %935 = load ptr, ptr %385, align 8
  %936 = load i64, ptr %386, align 8
  %937 = mul nsw i64 %936, %931
  %938 = getelementptr inbounds double, ptr %935, i64 %937
  %939 = getelementptr inbounds double, ptr %938, i64 %936
  store double %429, ptr %938, align 8
  %940 = getelementptr inbounds i8, ptr %938, i64 8
  store double %476, ptr %940, align 8
  store double %477, ptr %939, align 8
  %941 = getelementptr inbounds i8, ptr %939, i64 8
  store double 0.000000e+00, ptr %941, align 8
  %942 = icmp sgt i64 %934, 0
  br i1 %942, label %946, label %943

943:                                              ; preds = %946, %930
  %944 = add nsw i64 %931, 1
  %945 = load ptr, ptr %339, align 8
  store i64 %944, ptr %945, align 8
  br label %959

946:                                              ; preds = %930, %946
  %947 = phi i64 [ %957, %946 ], [ 0, %930 ]
  %948 = load ptr, ptr %63, align 8
  %949 = getelementptr inbounds double, ptr %948, i64 %947
  %950 = load double, ptr %949, align 8
  %951 = add nuw nsw i64 %947, 2
  %952 = getelementptr inbounds double, ptr %938, i64 %951
  store double %950, ptr %952, align 8
  %953 = load ptr, ptr %66, align 8
  %954 = getelementptr inbounds double, ptr %953, i64 %947
  %955 = load double, ptr %954, align 8
  %956 = getelementptr inbounds double, ptr %939, i64 %951
  store double %955, ptr %956, align 8
  %957 = add nuw nsw i64 %947, 1
  %958 = icmp eq i64 %957, %934
  br i1 %958, label %943, label %946, !llvm.loop !20

959:                                              ; preds = %923, %943
  br i1 %95, label %1002, label %960

960:                                              ; preds = %959
  %961 = load i64, ptr %387, align 8
  %962 = getelementptr inbounds double, ptr %75, i64 %961
  %963 = load double, ptr %962, align 8
  %964 = fcmp ult double %963, %477
  br i1 %964, label %1002, label %965

965:                                              ; preds = %960
  %966 = load ptr, ptr %62, align 8
  %967 = getelementptr inbounds i8, ptr %966, i64 8
  %968 = load i64, ptr %967, align 8
  %969 = load i64, ptr %96, align 8
  %970 = load ptr, ptr %74, align 8
  %971 = load ptr, ptr %68, align 8
  %972 = getelementptr inbounds i8, ptr %971, i64 48
  %973 = load i64, ptr %972, align 8
  %974 = icmp slt i64 %973, %969
  br i1 %974, label %975, label %998

975:                                              ; preds = %965
  %976 = icmp sgt i64 %968, 0
  br label %977

977:                                              ; preds = %975, %988
  %978 = phi i64 [ %973, %975 ], [ %989, %988 ]
  %979 = getelementptr inbounds double, ptr %970, i64 %978
  %980 = load double, ptr %979, align 8
  %981 = load ptr, ptr %64, align 8
  %982 = load double, ptr %981, align 8
  %983 = fcmp ugt double %980, %982
  br i1 %983, label %998, label %984

984:                                              ; preds = %977
  br i1 %976, label %985, label %988

985:                                              ; preds = %984
  %986 = mul nsw i64 %978, %968
  %987 = getelementptr double, ptr %1, i64 %986
  br label %991

988:                                              ; preds = %991, %984
  %989 = add i64 %978, 1
  %990 = icmp eq i64 %989, %969
  br i1 %990, label %998, label %977, !llvm.loop !8

991:                                              ; preds = %985, %991
  %992 = phi i64 [ 0, %985 ], [ %996, %991 ]
  %993 = getelementptr inbounds double, ptr %67, i64 %992
  %994 = load double, ptr %993, align 8
  %995 = getelementptr double, ptr %987, i64 %992
  store double %994, ptr %995, align 8
  %996 = add nuw nsw i64 %992, 1
  %997 = icmp eq i64 %996, %968
  br i1 %997, label %988, label %991, !llvm.loop !9

998:                                              ; preds = %977, %988, %965
  %999 = phi i64 [ %973, %965 ], [ %978, %977 ], [ %969, %988 ]
  %1000 = load ptr, ptr %68, align 8
  %1001 = getelementptr inbounds i8, ptr %1000, i64 48
  store i64 %999, ptr %1001, align 8
  br label %1364

1002:                                             ; preds = %960, %959
  %1003 = load ptr, ptr %0, align 8
  %1004 = load ptr, ptr %62, align 8
  %1005 = getelementptr inbounds i8, ptr %1004, i64 16
  %1006 = load i64, ptr %1005, align 8
  %1007 = load i64, ptr %1003, align 8
  %1008 = load i64, ptr %388, align 8
  %1009 = load ptr, ptr %389, align 8
  %1010 = mul nsw i64 %1008, %1007
  %1011 = getelementptr inbounds double, ptr %1009, i64 %1010
  %1012 = load ptr, ptr %390, align 8
  %1013 = add nsw i64 %1007, 1
  %1014 = getelementptr inbounds i8, ptr %1003, i64 16
  %1015 = load i64, ptr %1014, align 8
  %1016 = icmp sgt i64 %1015, 0
  br i1 %1016, label %1017, label %1071

1017:                                             ; preds = %1002
  %1018 = getelementptr inbounds i8, ptr %1003, i64 8
  br label %1024

1019:                                             ; preds = %1060
  %1020 = add nsw i64 %1027, 1
  %1021 = load i64, ptr %1014, align 8
  %1022 = add nsw i64 %1021, %1013
  %1023 = icmp slt i64 %1020, %1022
  br i1 %1023, label %1024, label %1071, !llvm.loop !21

1024:                                             ; preds = %1017, %1019
  %1025 = phi i1 [ %1016, %1017 ], [ %1023, %1019 ]
  %1026 = phi i64 [ undef, %1017 ], [ %1070, %1019 ]
  %1027 = phi i64 [ %1013, %1017 ], [ %1020, %1019 ]
  %1028 = load i64, ptr %1018, align 8
  %1029 = load ptr, ptr %391, align 8
  %1030 = load ptr, ptr %63, align 8
  %1031 = load ptr, ptr %392, align 8
  %1032 = getelementptr i64, ptr %1031, i64 %1027
  %1033 = getelementptr i64, ptr %1032, i64 %1028
  %1034 = load i64, ptr %1033, align 8
  %1035 = getelementptr i8, ptr %1033, i64 8
  %1036 = load i64, ptr %1035, align 8
  %1037 = xor i64 %1034, -1
  %1038 = add i64 %1036, %1037
  %1039 = load ptr, ptr %346, align 8
  %1040 = load ptr, ptr %389, align 8
  %1041 = load ptr, ptr %393, align 8
  %1042 = getelementptr inbounds i64, ptr %1041, i64 %1034
  %1043 = load ptr, ptr %394, align 8
  %1044 = getelementptr inbounds double, ptr %1043, i64 %1034
  tail call fastcc void @combine(ptr noundef %1029, ptr noundef %1030, ptr noundef %1039, ptr noundef %1040, ptr noundef %1042, ptr noundef %1044, i64 noundef %1038, i64 noundef 1, i64 noundef %1006) #8
  %1045 = load ptr, ptr %389, align 8
  %1046 = mul nsw i64 %1027, %1008
  %1047 = getelementptr inbounds double, ptr %1045, i64 %1046
  %1048 = load i64, ptr %345, align 8
  %1049 = add nsw i64 %1048, 1
  store i64 %1049, ptr %345, align 8
  %1050 = load ptr, ptr %395, align 8
  %1051 = getelementptr inbounds double, ptr %1050, i64 %1027
  %1052 = load double, ptr %1051, align 8
  %1053 = fmul double %476, %1052
  %1054 = fadd double %429, %1053
  %1055 = load ptr, ptr %391, align 8
  %1056 = load ptr, ptr %396, align 8
  store double %1054, ptr %1056, align 8
  %1057 = load i64, ptr %397, align 8
  %1058 = icmp sgt i64 %1057, 0
  br i1 %1058, label %1059, label %1060

1059:                                             ; preds = %1024
  tail call fastcc void @sample(ptr noundef nonnull %62) #8
  br label %1060

1060:                                             ; preds = %1024, %1059
  %1061 = load ptr, ptr %62, align 8
  %1062 = load i64, ptr %1061, align 8
  %1063 = load ptr, ptr %396, align 8
  %1064 = load ptr, ptr %398, align 8
  %1065 = load ptr, ptr %399, align 8
  %1066 = inttoptr i64 %1062 to ptr
  %1067 = tail call i32 %1066(ptr noundef %1063, ptr noundef %1055, ptr noundef %1064, ptr noundef %1065, ptr noundef %1047) #9
  %1068 = sext i32 %1067 to i64
  %1069 = icmp eq i32 %1067, 0
  %1070 = select i1 %1069, i64 %1026, i64 %1068
  br i1 %1069, label %1019, label %1071

1071:                                             ; preds = %1019, %1060, %1002
  %1072 = phi i1 [ %1016, %1002 ], [ %1023, %1019 ], [ %1025, %1060 ]
  %1073 = phi i64 [ 0, %1002 ], [ %1068, %1060 ], [ %1068, %1019 ]
  %1074 = phi i64 [ undef, %1002 ], [ %1070, %1060 ], [ %1070, %1019 ]
  %1075 = getelementptr inbounds i8, ptr %1003, i64 16
  br i1 %1072, label %1144, label %1076

1076:                                             ; preds = %1071
  %1077 = load ptr, ptr %62, align 8
  %1078 = getelementptr inbounds i8, ptr %1077, i64 8
  %1079 = load i64, ptr %1078, align 8
  %1080 = icmp sgt i64 %1079, 0
  br i1 %1080, label %1081, label %1085

1081:                                             ; preds = %1076
  %1082 = getelementptr inbounds double, ptr %1012, i64 %1008
  %1083 = shl nsw i64 %1008, 4
  %1084 = getelementptr inbounds i8, ptr %1012, i64 %1083
  br label %1092

1085:                                             ; preds = %1092, %1076
  %1086 = getelementptr inbounds i8, ptr %1003, i64 8
  %1087 = load i64, ptr %1086, align 8
  %1088 = load i64, ptr %1075, align 8
  %1089 = getelementptr inbounds i8, ptr %1003, i64 24
  %1090 = load i64, ptr %1089, align 8
  %1091 = icmp sgt i64 %1090, 3
  br i1 %1091, label %1119, label %1144

1092:                                             ; preds = %1081, %1092
  %1093 = phi i64 [ 0, %1081 ], [ %1114, %1092 ]
  %1094 = load ptr, ptr %400, align 8
  %1095 = getelementptr inbounds double, ptr %1094, i64 %1093
  %1096 = load double, ptr %1095, align 8
  %1097 = load ptr, ptr %63, align 8
  %1098 = getelementptr inbounds double, ptr %1097, i64 %1093
  %1099 = load double, ptr %1098, align 8
  %1100 = fsub double %1096, %1099
  %1101 = load ptr, ptr %389, align 8
  %1102 = getelementptr inbounds double, ptr %1101, i64 %1093
  %1103 = load double, ptr %1102, align 8
  %1104 = fmul double %476, %1103
  %1105 = fsub double %1104, %1100
  %1106 = getelementptr inbounds double, ptr %1012, i64 %1093
  store double %1100, ptr %1106, align 8
  %1107 = getelementptr inbounds double, ptr %1082, i64 %1093
  store double %1105, ptr %1107, align 8
  %1108 = fsub double %1100, %1105
  %1109 = getelementptr inbounds double, ptr %1011, i64 %1093
  %1110 = load double, ptr %1109, align 8
  %1111 = fmul double %476, %1110
  %1112 = fsub double %1108, %1111
  %1113 = getelementptr inbounds double, ptr %1084, i64 %1093
  store double %1112, ptr %1113, align 8
  %1114 = add nuw nsw i64 %1093, 1
  %1115 = load ptr, ptr %62, align 8
  %1116 = getelementptr inbounds i8, ptr %1115, i64 8
  %1117 = load i64, ptr %1116, align 8
  %1118 = icmp slt i64 %1114, %1117
  br i1 %1118, label %1092, label %1085, !llvm.loop !22

1119:                                             ; preds = %1085, %1119
  %1120 = phi i64 [ %1141, %1119 ], [ 3, %1085 ]
  %1121 = mul nsw i64 %1120, %1008
  %1122 = getelementptr inbounds double, ptr %1012, i64 %1121
  %1123 = load ptr, ptr %401, align 8
  %1124 = load ptr, ptr %402, align 8
  %1125 = getelementptr i64, ptr %1124, i64 %1013
  %1126 = getelementptr i64, ptr %1125, i64 %1087
  %1127 = getelementptr i64, ptr %1126, i64 %1088
  %1128 = getelementptr i64, ptr %1127, i64 %1120
  %1129 = getelementptr i8, ptr %1128, i64 -24
  %1130 = load i64, ptr %1129, align 8
  %1131 = getelementptr i8, ptr %1128, i64 -16
  %1132 = load i64, ptr %1131, align 8
  %1133 = xor i64 %1130, -1
  %1134 = add i64 %1132, %1133
  %1135 = load ptr, ptr %346, align 8
  %1136 = load ptr, ptr %389, align 8
  %1137 = load ptr, ptr %403, align 8
  %1138 = getelementptr inbounds i64, ptr %1137, i64 %1130
  %1139 = load ptr, ptr %404, align 8
  %1140 = getelementptr inbounds double, ptr %1139, i64 %1130
  tail call fastcc void @combine(ptr noundef %1122, ptr noundef %1123, ptr noundef %1135, ptr noundef %1136, ptr noundef %1138, ptr noundef %1140, i64 noundef %1134, i64 noundef 1, i64 noundef %1006) #8
  %1141 = add nuw nsw i64 %1120, 1
  %1142 = load i64, ptr %1089, align 8
  %1143 = icmp slt i64 %1141, %1142
  br i1 %1143, label %1119, label %1144, !llvm.loop !23

1144:                                             ; preds = %1119, %1085, %1071
  %1145 = phi i64 [ %1074, %1071 ], [ %1073, %1085 ], [ %1073, %1119 ]
  %1146 = icmp eq i64 %1145, 0
  br i1 %1146, label %1150, label %1147

1147:                                             ; preds = %1144
  store i64 3, ptr %405, align 8
  store double %429, ptr %65, align 8
  %1148 = icmp slt i64 %1145, 0
  %1149 = select i1 %1148, i64 -4, i64 2
  br label %1487

1150:                                             ; preds = %1144
  %1151 = load ptr, ptr %64, align 8
  %1152 = load ptr, ptr %91, align 8
  %1153 = getelementptr inbounds i8, ptr %1152, i64 8
  %1154 = load i64, ptr %1153, align 8
  %1155 = icmp sgt i64 %1154, 0
  br i1 %1155, label %1156, label %1166

1156:                                             ; preds = %1150
  %1157 = getelementptr inbounds i8, ptr %1152, i64 16
  %1158 = load i64, ptr %1157, align 8
  %1159 = inttoptr i64 %1158 to ptr
  %1160 = tail call i64 %1159(ptr noundef %0, double noundef %429, double noundef %476) #9
  %1161 = icmp eq i64 %1160, -6
  br i1 %1161, label %1162, label %1163

1162:                                             ; preds = %1156
  store double %429, ptr %1151, align 8
  br label %1341

1163:                                             ; preds = %1156
  %1164 = getelementptr inbounds i8, ptr %1151, i64 48
  %1165 = load double, ptr %1164, align 8
  br label %1166

1166:                                             ; preds = %1163, %1150
  %1167 = phi double [ %1165, %1163 ], [ 1.000000e+00, %1150 ]
  %1168 = phi i64 [ %1160, %1163 ], [ 0, %1150 ]
  %1169 = fcmp oeq double %1167, 1.000000e+00
  br i1 %1169, label %1170, label %1172

1170:                                             ; preds = %1166
  %1171 = load double, ptr %1151, align 8
  br label %1175

1172:                                             ; preds = %1166
  %1173 = fmul double %476, %1167
  %1174 = fadd double %429, %1173
  br label %1175

1175:                                             ; preds = %1172, %1170
  %1176 = phi double [ %1171, %1170 ], [ %1174, %1172 ]
  %1177 = icmp eq i64 %1168, -4
  %1178 = select i1 %1177, i64 -4, i64 0
  br i1 %1177, label %1236, label %1179

1179:                                             ; preds = %1175
  %1180 = fcmp olt double %1167, 1.000000e+00
  %1181 = load ptr, ptr %62, align 8
  %1182 = getelementptr inbounds i8, ptr %1181, i64 8
  %1183 = load i64, ptr %1182, align 8
  %1184 = load i64, ptr %96, align 8
  %1185 = load ptr, ptr %74, align 8
  %1186 = load ptr, ptr %68, align 8
  %1187 = getelementptr inbounds i8, ptr %1186, i64 48
  %1188 = load i64, ptr %1187, align 8
  %1189 = icmp slt i64 %1188, %1184
  br i1 %1189, label %1190, label %1232

1190:                                             ; preds = %1179, %1228
  %1191 = phi i64 [ %1229, %1228 ], [ undef, %1179 ]
  %1192 = phi i64 [ %1230, %1228 ], [ %1188, %1179 ]
  %1193 = getelementptr inbounds double, ptr %1185, i64 %1192
  %1194 = load double, ptr %1193, align 8
  %1195 = fcmp olt double %1194, %1176
  %1196 = fcmp oeq double %1194, %1176
  %1197 = and i1 %1180, %1196
  %1198 = or i1 %1195, %1197
  br i1 %1198, label %1199, label %1232

1199:                                             ; preds = %1190
  %1200 = fsub double %1194, %429
  %1201 = fdiv double %1200, %476
  %1202 = mul nsw i64 %1192, %1183
  %1203 = getelementptr inbounds double, ptr %1, i64 %1202
  %1204 = load ptr, ptr %406, align 8
  %1205 = insertelement <8 x double> poison, double %1201, i64 0
  %1206 = shufflevector <8 x double> %1205, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1206, ptr %1204, align 8
  %1207 = load ptr, ptr %63, align 8
  %1208 = load ptr, ptr %390, align 8
  %1209 = load i64, ptr %388, align 8
  %1210 = load ptr, ptr %0, align 8
  %1211 = getelementptr inbounds i8, ptr %1210, i64 24
  %1212 = load i64, ptr %1211, align 8
  %1213 = load ptr, ptr %406, align 8
  %1214 = load ptr, ptr %62, align 8
  %1215 = getelementptr inbounds i8, ptr %1214, i64 16
  %1216 = load i64, ptr %1215, align 8
  tail call fastcc void @nested(ptr noundef %1203, ptr noundef %1207, ptr noundef %1208, i64 noundef %1209, i64 noundef %1212, ptr noundef %1213, i64 noundef %1216) #8
  %1217 = load ptr, ptr %81, align 8
  %1218 = load i64, ptr %1217, align 8
  %1219 = icmp eq i64 %1218, 1
  br i1 %1219, label %1220, label %1228

1220:                                             ; preds = %1199
  %1221 = load double, ptr %1193, align 8
  %1222 = getelementptr inbounds i8, ptr %1217, i64 56
  %1223 = load i64, ptr %1222, align 8
  %1224 = inttoptr i64 %1223 to ptr
  %1225 = tail call i64 %1224(ptr noundef %0, double noundef %1221, ptr noundef %1203) #9
  %1226 = icmp eq i64 %1225, 0
  %1227 = select i1 %1226, i64 %1191, i64 %1225
  br i1 %1226, label %1228, label %1236

1228:                                             ; preds = %1220, %1199
  %1229 = phi i64 [ %1227, %1220 ], [ %1191, %1199 ]
  %1230 = add i64 %1192, 1
  %1231 = icmp eq i64 %1230, %1184
  br i1 %1231, label %1232, label %1190, !llvm.loop !24

1232:                                             ; preds = %1228, %1190, %1179
  %1233 = phi i64 [ %1188, %1179 ], [ %1184, %1228 ], [ %1192, %1190 ]
  %1234 = load ptr, ptr %68, align 8
  %1235 = getelementptr inbounds i8, ptr %1234, i64 48
  store i64 %1233, ptr %1235, align 8
  br label %1236

1236:                                             ; preds = %1220, %1232, %1175
  %1237 = phi i64 [ %1178, %1175 ], [ 0, %1232 ], [ %1227, %1220 ]
  %1238 = icmp eq i64 %1237, 0
  %1239 = icmp ne i64 %1168, 0
  %1240 = fcmp olt double %1167, 1.000000e+00
  %1241 = and i1 %1240, %1238
  %1242 = and i1 %1239, %1241
  br i1 %1242, label %1243, label %1280

1243:                                             ; preds = %1236
  %1244 = load ptr, ptr %407, align 8
  %1245 = load ptr, ptr %408, align 8
  %1246 = insertelement <8 x double> poison, double %1167, i64 0
  %1247 = shufflevector <8 x double> %1246, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %1247, ptr %1245, align 8
  %1248 = load ptr, ptr %63, align 8
  %1249 = load ptr, ptr %390, align 8
  %1250 = load i64, ptr %388, align 8
  %1251 = load ptr, ptr %0, align 8
  %1252 = getelementptr inbounds i8, ptr %1251, i64 24
  %1253 = load i64, ptr %1252, align 8
  %1254 = load ptr, ptr %408, align 8
  %1255 = load ptr, ptr %62, align 8
  %1256 = getelementptr inbounds i8, ptr %1255, i64 16
  %1257 = load i64, ptr %1256, align 8
  tail call fastcc void @nested(ptr noundef %1244, ptr noundef %1248, ptr noundef %1249, i64 noundef %1250, i64 noundef %1253, ptr noundef %1254, i64 noundef %1257) #8
  %1258 = load i64, ptr %79, align 8
  %1259 = icmp sgt i64 %1258, 0
  br i1 %1259, label %1264, label %1260

1260:                                             ; preds = %1264, %1243
  %1261 = load ptr, ptr %81, align 8
  %1262 = load i64, ptr %1261, align 8
  %1263 = icmp eq i64 %1262, 1
  br i1 %1263, label %1274, label %1280

1264:                                             ; preds = %1243, %1264
  %1265 = phi i64 [ %1271, %1264 ], [ 0, %1243 ]
  %1266 = load ptr, ptr %407, align 8
  %1267 = getelementptr inbounds double, ptr %1266, i64 %1265
  %1268 = load double, ptr %1267, align 8
  %1269 = load ptr, ptr %66, align 8
  %1270 = getelementptr inbounds double, ptr %1269, i64 %1265
  store double %1268, ptr %1270, align 8
  %1271 = add nuw nsw i64 %1265, 1
  %1272 = load i64, ptr %79, align 8
  %1273 = icmp slt i64 %1271, %1272
  br i1 %1273, label %1264, label %1260, !llvm.loop !25

1274:                                             ; preds = %1260
  %1275 = load ptr, ptr %66, align 8
  %1276 = getelementptr inbounds i8, ptr %1261, i64 56
  %1277 = load i64, ptr %1276, align 8
  %1278 = inttoptr i64 %1277 to ptr
  %1279 = tail call i64 %1278(ptr noundef %0, double noundef %1176, ptr noundef %1275) #9
  br label %1280

1280:                                             ; preds = %1274, %1260, %1236
  %1281 = phi i64 [ %1279, %1274 ], [ 0, %1260 ], [ %1237, %1236 ]
  %1282 = icmp eq i64 %1281, 0
  br i1 %1282, label %1285, label %1283

1283:                                             ; preds = %1280
  store double %429, ptr %1151, align 8
  %1284 = getelementptr inbounds i8, ptr %1151, i64 8
  store double %476, ptr %1284, align 8
  br label %1341

1285:                                             ; preds = %1280
  br i1 %1169, label %1286, label %1324

1286:                                             ; preds = %1285
  %1287 = load ptr, ptr %66, align 8
  %1288 = load ptr, ptr %62, align 8
  %1289 = getelementptr inbounds i8, ptr %1288, i64 8
  %1290 = load i64, ptr %1289, align 8
  %1291 = load i64, ptr %96, align 8
  %1292 = load ptr, ptr %74, align 8
  %1293 = load ptr, ptr %68, align 8
  %1294 = getelementptr inbounds i8, ptr %1293, i64 48
  %1295 = load i64, ptr %1294, align 8
  %1296 = icmp slt i64 %1295, %1291
  br i1 %1296, label %1297, label %1320

1297:                                             ; preds = %1286
  %1298 = icmp sgt i64 %1290, 0
  br label %1299

1299:                                             ; preds = %1297, %1310
  %1300 = phi i64 [ %1295, %1297 ], [ %1311, %1310 ]
  %1301 = getelementptr inbounds double, ptr %1292, i64 %1300
  %1302 = load double, ptr %1301, align 8
  %1303 = load ptr, ptr %64, align 8
  %1304 = load double, ptr %1303, align 8
  %1305 = fcmp ugt double %1302, %1304
  br i1 %1305, label %1320, label %1306

1306:                                             ; preds = %1299
  br i1 %1298, label %1307, label %1310

1307:                                             ; preds = %1306
  %1308 = mul nsw i64 %1300, %1290
  %1309 = getelementptr double, ptr %1, i64 %1308
  br label %1313

1310:                                             ; preds = %1313, %1306
  %1311 = add i64 %1300, 1
  %1312 = icmp eq i64 %1311, %1291
  br i1 %1312, label %1320, label %1299, !llvm.loop !8

1313:                                             ; preds = %1307, %1313
  %1314 = phi i64 [ 0, %1307 ], [ %1318, %1313 ]
  %1315 = getelementptr inbounds double, ptr %1287, i64 %1314
  %1316 = load double, ptr %1315, align 8
  %1317 = getelementptr double, ptr %1309, i64 %1314
  store double %1316, ptr %1317, align 8
  %1318 = add nuw nsw i64 %1314, 1
  %1319 = icmp eq i64 %1318, %1290
  br i1 %1319, label %1310, label %1313, !llvm.loop !9

1320:                                             ; preds = %1310, %1299, %1286
  %1321 = phi i64 [ %1295, %1286 ], [ %1291, %1310 ], [ %1300, %1299 ]
  %1322 = load ptr, ptr %68, align 8
  %1323 = getelementptr inbounds i8, ptr %1322, i64 48
  store i64 %1321, ptr %1323, align 8
  br label %1324

1324:                                             ; preds = %1320, %1285
  br i1 %1239, label %1325, label %1341

1325:                                             ; preds = %1324
  %1326 = load i64, ptr %79, align 8
  %1327 = icmp sgt i64 %1326, 0
  br i1 %1327, label %1331, label %1328

1328:                                             ; preds = %1331, %1325
  store double %1176, ptr %1151, align 8
  %1329 = getelementptr inbounds i8, ptr %1151, i64 8
  store double 0.000000e+00, ptr %1329, align 8
  %1330 = load ptr, ptr %68, align 8
  store i64 0, ptr %1330, align 8
  br label %1341

1331:                                             ; preds = %1325, %1331
  %1332 = phi i64 [ %1338, %1331 ], [ 0, %1325 ]
  %1333 = load ptr, ptr %66, align 8
  %1334 = getelementptr inbounds double, ptr %1333, i64 %1332
  %1335 = load double, ptr %1334, align 8
  %1336 = load ptr, ptr %63, align 8
  %1337 = getelementptr inbounds double, ptr %1336, i64 %1332
  store double %1335, ptr %1337, align 8
  %1338 = add nuw nsw i64 %1332, 1
  %1339 = load i64, ptr %79, align 8
  %1340 = icmp slt i64 %1338, %1339
  br i1 %1340, label %1331, label %1328, !llvm.loop !26

1341:                                             ; preds = %1162, %1283, %1324, %1328
  %1342 = phi i64 [ -6, %1162 ], [ %1281, %1283 ], [ %1168, %1328 ], [ %1168, %1324 ]
  %1343 = icmp eq i64 %1342, -6
  br i1 %1343, label %1348, label %1344

1344:                                             ; preds = %1341
  %1345 = icmp ne i64 %1342, 6
  %1346 = select i1 %1345, i1 true, i1 %87
  %1347 = select i1 %1346, i1 true, i1 %95
  br i1 %1347, label %1358, label %1348

1348:                                             ; preds = %1344, %1341
  %1349 = phi i64 [ %1342, %1344 ], [ 2, %1341 ]
  %1350 = load i64, ptr %340, align 8
  %1351 = add nsw i64 %1350, -1
  store i64 %1351, ptr %340, align 8
  %1352 = load ptr, ptr %339, align 8
  %1353 = load i64, ptr %1352, align 8
  %1354 = add nsw i64 %1353, -1
  store i64 %1354, ptr %1352, align 8
  %1355 = load i64, ptr %341, align 8
  %1356 = add nsw i64 %1355, 1
  store i64 %1356, ptr %341, align 8
  store i64 %1349, ptr %418, align 8
  store double 1.000000e+00, ptr %419, align 8
  %1357 = fmul double %476, 2.500000e-01
  br label %1487, !llvm.loop !19

1358:                                             ; preds = %1344
  %1359 = icmp eq i64 %1342, 0
  br i1 %1359, label %1364, label %1360

1360:                                             ; preds = %1358
  %1361 = load ptr, ptr %339, align 8
  %1362 = load i64, ptr %1361, align 8
  %1363 = add nsw i64 %1362, 1
  store i64 %1363, ptr %1361, align 8
  br label %1487

1364:                                             ; preds = %1358, %998
  br i1 %87, label %1468, label %1365

1365:                                             ; preds = %1364
  %1366 = load double, ptr %410, align 8
  %1367 = fcmp ogt double %854, 1.000000e-10
  %1368 = select i1 %1367, double %854, double 1.000000e-10
  %1369 = load double, ptr %411, align 8
  %1370 = load double, ptr %412, align 8
  %1371 = fneg double %1370
  %1372 = bitcast double %1368 to i64
  %1373 = add nsw i64 %1372, -4604544271217802189
  %1374 = ashr i64 %1373, 52
  %1375 = and i64 %1373, -4503599627370496
  %1376 = sub nsw i64 %1372, %1375
  %1377 = bitcast i64 %1376 to double
  %1378 = fadd double %1377, -1.000000e+00
  %1379 = fadd double %1377, 1.000000e+00
  %1380 = fdiv double %1378, %1379
  %1381 = fmul double %1380, %1380
  %1382 = tail call double @llvm.fma.f64(double %1381, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1383 = tail call double @llvm.fma.f64(double %1382, double %1381, double 0x3FE2776C50EF9BFE)
  %1384 = tail call double @llvm.fma.f64(double %1383, double %1381, double 0x3FEEC709DC3A03FD)
  %1385 = tail call double @llvm.fma.f64(double %1384, double %1381, double 0x40071547652B82FE)
  %1386 = trunc nsw i64 %1374 to i32
  %1387 = sitofp i32 %1386 to double
  %1388 = fmul double %1380, %1385
  %1389 = fadd double %1388, %1387
  %1390 = fmul double %1389, %1371
  %1391 = fcmp ogt double %1390, -1.000000e+03
  %1392 = select i1 %1391, double %1390, double -1.000000e+03
  %1393 = fcmp olt double %1392, 1.000000e+03
  %1394 = select i1 %1393, double %1392, double 1.000000e+03
  %1395 = tail call double @llvm.rint.f64(double %1394)
  %1396 = fsub double %1394, %1395
  %1397 = tail call double @llvm.fma.f64(double %1396, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1398 = tail call double @llvm.fma.f64(double %1397, double %1396, double 0x3F55D87FE78A6730)
  %1399 = tail call double @llvm.fma.f64(double %1398, double %1396, double 0x3F83B2AB6FBA4E77)
  %1400 = tail call double @llvm.fma.f64(double %1399, double %1396, double 0x3FAC6B08D704A0BF)
  %1401 = tail call double @llvm.fma.f64(double %1400, double %1396, double 0x3FCEBFBDFF82C58E)
  %1402 = tail call double @llvm.fma.f64(double %1401, double %1396, double 0x3FE62E42FEFA39EF)
  %1403 = tail call double @llvm.fma.f64(double %1402, double %1396, double 1.000000e+00)
  %1404 = bitcast double %1403 to i64
  %1405 = fptosi double %1395 to i32
  %1406 = sext i32 %1405 to i64
  %1407 = shl nsw i64 %1406, 52
  %1408 = add nsw i64 %1407, %1404
  %1409 = bitcast i64 %1408 to double
  %1410 = fmul double %1369, %1409
  %1411 = load double, ptr %413, align 8
  %1412 = fcmp une double %1411, 0.000000e+00
  br i1 %1412, label %1413, label %1453

1413:                                             ; preds = %1365
  %1414 = load i64, ptr %409, align 8
  %1415 = add nsw i64 %1414, -4604544271217802189
  %1416 = ashr i64 %1415, 52
  %1417 = and i64 %1415, -4503599627370496
  %1418 = sub nsw i64 %1414, %1417
  %1419 = bitcast i64 %1418 to double
  %1420 = fadd double %1419, -1.000000e+00
  %1421 = fadd double %1419, 1.000000e+00
  %1422 = fdiv double %1420, %1421
  %1423 = fmul double %1422, %1422
  %1424 = tail call double @llvm.fma.f64(double %1423, double 0x3FD484B13D7C02A9, double 0x3FDA61762A7ADED9)
  %1425 = tail call double @llvm.fma.f64(double %1424, double %1423, double 0x3FE2776C50EF9BFE)
  %1426 = tail call double @llvm.fma.f64(double %1425, double %1423, double 0x3FEEC709DC3A03FD)
  %1427 = tail call double @llvm.fma.f64(double %1426, double %1423, double 0x40071547652B82FE)
  %1428 = trunc nsw i64 %1416 to i32
  %1429 = sitofp i32 %1428 to double
  %1430 = fmul double %1422, %1427
  %1431 = fadd double %1430, %1429
  %1432 = fmul double %1411, %1431
  %1433 = fcmp ogt double %1432, -1.000000e+03
  %1434 = select i1 %1433, double %1432, double -1.000000e+03
  %1435 = fcmp olt double %1434, 1.000000e+03
  %1436 = select i1 %1435, double %1434, double 1.000000e+03
  %1437 = tail call double @llvm.rint.f64(double %1436)
  %1438 = fsub double %1436, %1437
  %1439 = tail call double @llvm.fma.f64(double %1438, double 0x3EEFFCBFC588B0C5, double 0x3F2430912F86C786)
  %1440 = tail call double @llvm.fma.f64(double %1439, double %1438, double 0x3F55D87FE78A6730)
  %1441 = tail call double @llvm.fma.f64(double %1440, double %1438, double 0x3F83B2AB6FBA4E77)
  %1442 = tail call double @llvm.fma.f64(double %1441, double %1438, double 0x3FAC6B08D704A0BF)
  %1443 = tail call double @llvm.fma.f64(double %1442, double %1438, double 0x3FCEBFBDFF82C58E)
  %1444 = tail call double @llvm.fma.f64(double %1443, double %1438, double 0x3FE62E42FEFA39EF)
  %1445 = tail call double @llvm.fma.f64(double %1444, double %1438, double 1.000000e+00)
  %1446 = bitcast double %1445 to i64
  %1447 = fptosi double %1437 to i32
  %1448 = sext i32 %1447 to i64
  %1449 = shl nsw i64 %1448, 52
  %1450 = add nsw i64 %1449, %1446
  %1451 = bitcast i64 %1450 to double
  %1452 = fmul double %1410, %1451
  br label %1453

1453:                                             ; preds = %1365, %1413
  %1454 = phi double [ %1452, %1413 ], [ %1410, %1365 ]
  %1455 = load double, ptr %414, align 8
  %1456 = fcmp ogt double %1454, %1455
  %1457 = select i1 %1456, double %1454, double %1455
  %1458 = fcmp olt double %1366, %1457
  %1459 = select i1 %1458, double %1366, double %1457
  %1460 = fmul double %476, %1459
  %1461 = fcmp oeq double %477, %100
  %1462 = fcmp ogt double %430, %1460
  %1463 = select i1 %1461, i1 %1462, i1 false
  %1464 = select i1 %1463, double %430, double %1460
  %1465 = fcmp ogt double %854, 1.000000e-04
  %1466 = select i1 %1465, double %854, double 1.000000e-04
  store double %1466, ptr %409, align 8
  %1467 = load double, ptr %415, align 8
  store double %1467, ptr %410, align 8
  br label %1468

1468:                                             ; preds = %1453, %1364
  %1469 = phi double [ %1464, %1453 ], [ %430, %1364 ]
  br i1 %416, label %1474, label %1470

1470:                                             ; preds = %1474, %1468
  %1471 = load i64, ptr %417, align 8
  %1472 = load i64, ptr %96, align 8
  %1473 = icmp eq i64 %1471, %1472
  br i1 %1473, label %1486, label %1487

1474:                                             ; preds = %1468, %1474
  %1475 = phi i64 [ %1484, %1474 ], [ 0, %1468 ]
  %1476 = getelementptr inbounds double, ptr %67, i64 %1475
  %1477 = load double, ptr %1476, align 8
  %1478 = load ptr, ptr %63, align 8
  %1479 = getelementptr inbounds double, ptr %1478, i64 %1475
  store double %1477, ptr %1479, align 8
  %1480 = getelementptr inbounds double, ptr %105, i64 %1475
  %1481 = load double, ptr %1480, align 8
  %1482 = load ptr, ptr %101, align 8
  %1483 = getelementptr inbounds double, ptr %1482, i64 %1475
  store double %1481, ptr %1483, align 8
  %1484 = add nuw nsw i64 %1475, 1
  %1485 = icmp eq i64 %1484, %80
  br i1 %1485, label %1470, label %1474, !llvm.loop !27

1486:                                             ; preds = %1470
  store double %1469, ptr %107, align 8
  br label %1487

1487:                                             ; preds = %1147, %1348, %1360, %1486, %842, %922, %921, %1470, %656, %483
  %1488 = phi double [ %430, %483 ], [ %430, %656 ], [ %430, %1147 ], [ %1357, %1348 ], [ %430, %1360 ], [ %1469, %1486 ], [ %430, %842 ], [ %920, %922 ], [ %920, %921 ], [ %1469, %1470 ]
  %1489 = phi double [ %429, %483 ], [ %429, %656 ], [ %429, %1147 ], [ %429, %1348 ], [ %429, %1360 ], [ %477, %1486 ], [ %429, %842 ], [ %429, %922 ], [ %429, %921 ], [ %477, %1470 ]
  %1490 = phi i32 [ 1, %483 ], [ 1, %656 ], [ 1, %1147 ], [ 3, %1348 ], [ 1, %1360 ], [ 1, %1486 ], [ 1, %842 ], [ 3, %922 ], [ 1, %921 ], [ 0, %1470 ]
  %1491 = phi i64 [ 2, %483 ], [ -4, %656 ], [ %1149, %1147 ], [ %428, %1348 ], [ %1342, %1360 ], [ 0, %1486 ], [ -4, %842 ], [ %428, %922 ], [ 2, %921 ], [ %428, %1470 ]
  switch i32 %1490, label %1495 [
    i32 0, label %1492
    i32 3, label %1492
  ]

1492:                                             ; preds = %1487, %1487
  %1493 = load i64, ptr %70, align 8
  %1494 = icmp eq i64 %1493, 0
  br i1 %1494, label %424, label %426, !llvm.loop !19

1495:                                             ; preds = %1487, %134, %424, %443, %451, %176, %61
  %1496 = phi i64 [ -1, %61 ], [ %137, %134 ], [ -1, %424 ], [ -5, %443 ], [ 1, %451 ], [ 0, %176 ], [ %1491, %1487 ]
  ret i64 %1496
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
