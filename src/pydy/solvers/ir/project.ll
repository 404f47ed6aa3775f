; sources 3a4a678cb054cff83b22f14ca89d20bf4590b914cbf3972cd80a85838e4667f3
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Held = type { ptr, i64, i64, i64, i64, i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

define range(i64 0, 7) i64 @project(ptr noundef readonly %0, double noundef %1, ptr noundef %2, ptr noundef readonly %3) #0 {
  %5 = alloca %struct.Held, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 648
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 88
  %9 = load i64, ptr %8, align 8
  %10 = add nsw i64 %9, 1
  store i64 %10, ptr %8, align 8
  tail call void @llvm.experimental.noalias.scope.decl(metadata !3)
  %11 = getelementptr inbounds i8, ptr %0, i64 696
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %12, i64 64
  %14 = load i64, ptr %13, align 8, !noalias !3
  %15 = inttoptr i64 %14 to ptr
  store ptr %15, ptr %5, align 8, !alias.scope !3
  %16 = getelementptr inbounds i8, ptr %5, i64 8
  %17 = getelementptr inbounds i8, ptr %12, i64 16
  %18 = load i64, ptr %17, align 8, !noalias !3
  store i64 %18, ptr %16, align 8, !alias.scope !3
  %19 = getelementptr inbounds i8, ptr %5, i64 16
  %20 = getelementptr inbounds i8, ptr %12, i64 24
  %21 = load i64, ptr %20, align 8, !noalias !3
  store i64 %21, ptr %19, align 8, !alias.scope !3
  %22 = getelementptr inbounds i8, ptr %5, i64 24
  %23 = getelementptr inbounds i8, ptr %12, i64 32
  %24 = load i64, ptr %23, align 8, !noalias !3
  store i64 %24, ptr %22, align 8, !alias.scope !3
  %25 = getelementptr inbounds i8, ptr %5, i64 32
  %26 = getelementptr inbounds i8, ptr %12, i64 40
  %27 = load i64, ptr %26, align 8, !noalias !3
  store i64 %27, ptr %25, align 8, !alias.scope !3
  %28 = getelementptr inbounds i8, ptr %5, i64 40
  %29 = getelementptr inbounds i8, ptr %12, i64 48
  %30 = load i64, ptr %29, align 8, !noalias !3
  store i64 %30, ptr %28, align 8, !alias.scope !3
  %31 = getelementptr inbounds i8, ptr %5, i64 48
  %32 = getelementptr inbounds i8, ptr %12, i64 80
  %33 = load i64, ptr %32, align 8, !noalias !3
  store i64 %33, ptr %31, align 8, !alias.scope !3
  %34 = getelementptr inbounds i8, ptr %5, i64 56
  %35 = getelementptr inbounds i8, ptr %12, i64 88
  %36 = load i64, ptr %35, align 8, !noalias !3
  store i64 %36, ptr %34, align 8, !alias.scope !3
  %37 = getelementptr inbounds i8, ptr %5, i64 64
  store i64 1, ptr %37, align 8, !alias.scope !3
  %38 = getelementptr inbounds i8, ptr %5, i64 72
  %39 = getelementptr inbounds i8, ptr %0, i64 744
  %40 = load ptr, ptr %39, align 8, !noalias !3
  store ptr %40, ptr %38, align 8, !alias.scope !3
  %41 = getelementptr inbounds i8, ptr %5, i64 80
  store ptr null, ptr %41, align 8, !alias.scope !3
  %42 = getelementptr inbounds i8, ptr %5, i64 88
  store ptr null, ptr %42, align 8, !alias.scope !3
  %43 = getelementptr inbounds i8, ptr %5, i64 96
  store ptr null, ptr %43, align 8, !alias.scope !3
  %44 = getelementptr inbounds i8, ptr %5, i64 104
  store ptr null, ptr %44, align 8, !alias.scope !3
  %45 = getelementptr inbounds i8, ptr %5, i64 112
  store ptr null, ptr %45, align 8, !alias.scope !3
  %46 = getelementptr inbounds i8, ptr %5, i64 120
  store ptr null, ptr %46, align 8, !alias.scope !3
  %47 = getelementptr double, ptr %40, i64 %18
  %48 = getelementptr double, ptr %47, i64 %21
  store ptr %48, ptr %41, align 8, !alias.scope !3
  %49 = mul nsw i64 %24, %18
  %50 = getelementptr inbounds double, ptr %48, i64 %49
  store ptr %50, ptr %42, align 8, !alias.scope !3
  %51 = mul nsw i64 %27, %24
  %52 = getelementptr inbounds double, ptr %50, i64 %51
  store ptr %52, ptr %43, align 8, !alias.scope !3
  %53 = mul nsw i64 %27, %21
  %54 = getelementptr inbounds double, ptr %52, i64 %53
  store ptr %54, ptr %44, align 8, !alias.scope !3
  %55 = mul i64 %27, %27
  %56 = mul i64 %55, %30
  %57 = getelementptr inbounds double, ptr %54, i64 %56
  store ptr %57, ptr %45, align 8, !alias.scope !3
  %58 = getelementptr inbounds double, ptr %57, i64 %18
  store ptr %58, ptr %46, align 8, !alias.scope !3
  %59 = getelementptr inbounds i8, ptr %12, i64 96
  %60 = load i64, ptr %59, align 8
  %61 = icmp eq i64 %60, 0
  %62 = select i1 %61, ptr null, ptr %3
  %63 = getelementptr inbounds i8, ptr %0, i64 144
  %64 = getelementptr inbounds i8, ptr %0, i64 168
  %65 = load ptr, ptr %64, align 8
  store double %1, ptr %65, align 8
  %66 = load ptr, ptr %63, align 8
  %67 = getelementptr inbounds i8, ptr %66, i64 40
  %68 = load i64, ptr %67, align 8
  %69 = icmp eq i64 %68, 0
  br i1 %69, label %71, label %70

70:                                               ; preds = %4
  tail call fastcc void @settle(ptr noundef nonnull %63) #7
  br label %71

71:                                               ; preds = %70, %4
  %72 = getelementptr inbounds i8, ptr %0, i64 248
  %73 = load i64, ptr %72, align 8
  %74 = icmp sgt i64 %73, 0
  br i1 %74, label %75, label %76

75:                                               ; preds = %71
  tail call fastcc void @sample(ptr noundef nonnull %63) #7
  br label %76

76:                                               ; preds = %71, %75
  %77 = load ptr, ptr %5, align 8
  %78 = load ptr, ptr %77, align 8
  %79 = load i64, ptr %25, align 8
  %80 = icmp sgt i64 %79, 0
  br i1 %80, label %81, label %95

81:                                               ; preds = %76, %85
  %82 = phi i64 [ %86, %85 ], [ 0, %76 ]
  %83 = mul nuw nsw i64 %82, %79
  %84 = getelementptr double, ptr %78, i64 %83
  br label %88

85:                                               ; preds = %88
  %86 = add nuw nsw i64 %82, 1
  %87 = icmp eq i64 %86, %79
  br i1 %87, label %95, label %81, !llvm.loop !6

88:                                               ; preds = %81, %88
  %89 = phi i64 [ 0, %81 ], [ %93, %88 ]
  %90 = icmp eq i64 %82, %89
  %91 = select i1 %90, double 1.000000e+00, double 0.000000e+00
  %92 = getelementptr double, ptr %84, i64 %89
  store double %91, ptr %92, align 8
  %93 = add nuw nsw i64 %89, 1
  %94 = icmp eq i64 %93, %79
  br i1 %94, label %85, label %88, !llvm.loop !9

95:                                               ; preds = %85, %76
  %96 = load i64, ptr %37, align 8
  %97 = load ptr, ptr %5, align 8
  %98 = getelementptr inbounds i8, ptr %97, i64 240
  %99 = load ptr, ptr %98, align 8
  %100 = load i64, ptr %16, align 8
  %101 = icmp sgt i64 %100, 0
  br i1 %101, label %148, label %102

102:                                              ; preds = %148, %95
  %103 = getelementptr inbounds i8, ptr %0, i64 168
  %104 = getelementptr inbounds i8, ptr %0, i64 192
  %105 = getelementptr inbounds i8, ptr %0, i64 720
  %106 = load ptr, ptr %38, align 8
  %107 = load i64, ptr %37, align 8
  %108 = load ptr, ptr %11, align 8
  %109 = getelementptr inbounds i8, ptr %108, i64 8
  %110 = load i64, ptr %109, align 8
  %111 = load ptr, ptr %103, align 8
  %112 = load ptr, ptr %104, align 8
  %113 = load ptr, ptr %105, align 8
  %114 = inttoptr i64 %110 to ptr
  %115 = load ptr, ptr %114, align 8
  %116 = tail call i32 %115(ptr noundef %111, ptr noundef %2, ptr noundef %112, ptr noundef %113, ptr noundef %106) #8
  %117 = icmp slt i32 %116, 0
  br i1 %117, label %332, label %118

118:                                              ; preds = %102
  %119 = icmp eq i64 %33, %100
  %120 = load i64, ptr %16, align 8
  %121 = icmp sgt i64 %120, 0
  %122 = load ptr, ptr %38, align 8
  %123 = load ptr, ptr %45, align 8
  %124 = load ptr, ptr %5, align 8
  %125 = getelementptr inbounds i8, ptr %124, i64 216
  %126 = icmp ne ptr %62, null
  %127 = load i64, ptr %22, align 8
  %128 = load ptr, ptr %41, align 8
  %129 = load i64, ptr %31, align 8
  %130 = icmp slt i64 %129, %120
  %131 = icmp sgt i64 %120, 0
  %132 = icmp sgt i64 %127, 0
  %133 = getelementptr inbounds i8, ptr %0, i64 600
  %134 = getelementptr inbounds i8, ptr %0, i64 576
  %135 = select i1 %130, double 1.000000e-05, double 0x3CE0000000000000
  %136 = load ptr, ptr %45, align 8
  %137 = load i64, ptr %25, align 8
  %138 = add nsw i64 %137, %127
  %139 = sitofp i64 %138 to double
  %140 = icmp eq i64 %30, 1
  %141 = getelementptr inbounds i8, ptr %97, i64 8
  %142 = getelementptr inbounds i8, ptr %97, i64 16
  %143 = getelementptr inbounds i8, ptr %97, i64 24
  %144 = getelementptr inbounds i8, ptr %97, i64 32
  %145 = getelementptr inbounds i8, ptr %97, i64 40
  %146 = getelementptr inbounds i8, ptr %97, i64 144
  %147 = icmp sgt i64 %120, 0
  br label %165

148:                                              ; preds = %95, %148
  %149 = phi i64 [ %151, %148 ], [ 0, %95 ]
  %150 = getelementptr inbounds double, ptr %99, i64 %149
  store double 0.000000e+00, ptr %150, align 8
  %151 = add nuw nsw i64 %149, 1
  %152 = icmp eq i64 %151, %100
  br i1 %152, label %102, label %148, !llvm.loop !10

153:                                              ; preds = %329
  %154 = add nuw nsw i32 %169, 1
  %155 = load ptr, ptr %11, align 8
  %156 = getelementptr inbounds i8, ptr %155, i64 8
  %157 = load i64, ptr %156, align 8
  %158 = load ptr, ptr %103, align 8
  %159 = load ptr, ptr %104, align 8
  %160 = load ptr, ptr %105, align 8
  %161 = inttoptr i64 %157 to ptr
  %162 = load ptr, ptr %161, align 8
  %163 = tail call i32 %162(ptr noundef %158, ptr noundef %2, ptr noundef %159, ptr noundef %160, ptr noundef %106) #8
  %164 = icmp slt i32 %163, 0
  br i1 %164, label %332, label %165, !llvm.loop !11

165:                                              ; preds = %118, %153
  %166 = phi i64 [ undef, %118 ], [ %331, %153 ]
  %167 = phi i64 [ 0, %118 ], [ %281, %153 ]
  %168 = phi double [ 0x7FF0000000000000, %118 ], [ %330, %153 ]
  %169 = phi i32 [ 0, %118 ], [ %154, %153 ]
  %170 = phi double [ 0.000000e+00, %118 ], [ %267, %153 ]
  %171 = phi i64 [ %107, %118 ], [ %279, %153 ]
  %172 = icmp eq i32 %169, 0
  %173 = select i1 %172, i1 true, i1 %119
  br i1 %121, label %184, label %174

174:                                              ; preds = %205, %165
  %175 = phi double [ 0.000000e+00, %165 ], [ %210, %205 ]
  %176 = phi i32 [ 1, %165 ], [ %212, %205 ]
  %177 = xor i32 %176, -1
  %178 = sext i32 %177 to i64
  %179 = and i64 %171, %178
  %180 = or i64 %179, %167
  %181 = and i1 %126, %172
  %182 = and i1 %131, %181
  %183 = select i1 %181, double 0.000000e+00, double %170
  br i1 %182, label %215, label %266

184:                                              ; preds = %165, %205
  %185 = phi i64 [ %213, %205 ], [ 0, %165 ]
  %186 = phi i32 [ %212, %205 ], [ 1, %165 ]
  %187 = phi double [ %210, %205 ], [ 0.000000e+00, %165 ]
  %188 = getelementptr inbounds double, ptr %122, i64 %185
  %189 = load double, ptr %188, align 8
  %190 = tail call double @llvm.fabs.f64(double %189)
  %191 = getelementptr inbounds double, ptr %123, i64 %185
  %192 = load double, ptr %191, align 8
  %193 = getelementptr inbounds double, ptr %99, i64 %185
  %194 = load double, ptr %193, align 8
  %195 = fcmp ogt double %192, %194
  %196 = select i1 %195, double %192, double %194
  %197 = fmul double %196, 0x3CB0000000000000
  %198 = fcmp une double %189, 0.000000e+00
  br i1 %173, label %205, label %199

199:                                              ; preds = %184
  %200 = load ptr, ptr %125, align 8
  %201 = getelementptr inbounds double, ptr %200, i64 %185
  %202 = load double, ptr %201, align 8
  %203 = fcmp ogt double %202, 0.000000e+00
  %204 = and i1 %198, %203
  br label %205

205:                                              ; preds = %199, %184
  %206 = phi i1 [ %198, %184 ], [ %204, %199 ]
  %207 = fdiv double %190, %197
  %208 = fcmp ogt double %207, %187
  %209 = select i1 %206, i1 %208, i1 false
  %210 = select i1 %209, double %207, double %187
  %211 = fcmp one double %190, 0x7FF0000000000000
  %212 = select i1 %211, i32 %186, i32 0
  %213 = add nuw nsw i64 %185, 1
  %214 = icmp eq i64 %213, %120
  br i1 %214, label %174, label %184, !llvm.loop !12

215:                                              ; preds = %174, %223
  %216 = phi double [ %239, %223 ], [ 0.000000e+00, %174 ]
  %217 = phi i64 [ %240, %223 ], [ 0, %174 ]
  br i1 %132, label %218, label %223

218:                                              ; preds = %215
  %219 = mul nuw nsw i64 %217, %127
  %220 = getelementptr double, ptr %128, i64 %219
  %221 = load ptr, ptr %133, align 8
  %222 = load ptr, ptr %134, align 8
  br label %242

223:                                              ; preds = %242, %215
  %224 = phi double [ 0.000000e+00, %215 ], [ %263, %242 ]
  %225 = getelementptr inbounds double, ptr %136, i64 %217
  %226 = load double, ptr %225, align 8
  %227 = fmul double %135, %226
  %228 = fmul double %224, %139
  %229 = tail call double @llvm.sqrt.f64(double %228)
  %230 = fmul double %229, 3.000000e+00
  %231 = fadd double %227, %230
  %232 = fcmp ule double %224, 0.000000e+00
  %233 = getelementptr inbounds double, ptr %122, i64 %217
  %234 = load double, ptr %233, align 8
  %235 = tail call double @llvm.fabs.f64(double %234)
  %236 = fdiv double %235, %231
  %237 = fcmp ogt double %236, %216
  %238 = select i1 %237, double %236, double %216
  %239 = select i1 %232, double %216, double %238
  %240 = add nuw nsw i64 %217, 1
  %241 = icmp eq i64 %240, %120
  br i1 %241, label %266, label %215, !llvm.loop !13

242:                                              ; preds = %218, %242
  %243 = phi double [ 0.000000e+00, %218 ], [ %263, %242 ]
  %244 = phi i64 [ 0, %218 ], [ %264, %242 ]
  %245 = getelementptr double, ptr %220, i64 %244
  %246 = load double, ptr %245, align 8
  %247 = getelementptr inbounds double, ptr %2, i64 %244
  %248 = load double, ptr %247, align 8
  %249 = getelementptr inbounds double, ptr %62, i64 %244
  %250 = load double, ptr %249, align 8
  %251 = getelementptr inbounds double, ptr %221, i64 %244
  %252 = load double, ptr %251, align 8
  %253 = getelementptr inbounds double, ptr %222, i64 %244
  %254 = load double, ptr %253, align 8
  %255 = tail call double @llvm.fabs.f64(double %250)
  %256 = tail call double @llvm.fabs.f64(double %248)
  %257 = fcmp ogt double %255, %256
  %258 = select i1 %257, double %255, double %256
  %259 = fmul double %258, %254
  %260 = fadd double %252, %259
  %261 = fmul double %246, %260
  %262 = fmul double %261, %261
  %263 = fadd double %243, %262
  %264 = add nuw nsw i64 %244, 1
  %265 = icmp eq i64 %264, %127
  br i1 %265, label %223, label %242, !llvm.loop !14

266:                                              ; preds = %223, %174
  %267 = phi double [ %183, %174 ], [ %239, %223 ]
  %268 = fcmp ole double %175, 1.000000e+00
  %269 = fmul double %168, 5.000000e-01
  %270 = fcmp oge double %175, %269
  %271 = fcmp ole double %175, 8.000000e+00
  %272 = and i1 %270, %271
  %273 = or i1 %268, %272
  %274 = zext i1 %273 to i64
  %275 = or i64 %180, %274
  %276 = xor i64 %275, -1
  %277 = and i64 %171, %276
  %278 = icmp eq i32 %169, 9
  %279 = select i1 %278, i64 0, i64 %277
  %280 = select i1 %278, i64 %277, i64 0
  %281 = or i64 %280, %180
  store i64 %279, ptr %37, align 8
  %282 = icmp eq i64 %279, 0
  br i1 %282, label %329, label %283

283:                                              ; preds = %266
  br i1 %140, label %284, label %302

284:                                              ; preds = %283
  %285 = load i64, ptr %141, align 8
  %286 = load i64, ptr %142, align 8
  %287 = mul nsw i64 %286, %285
  %288 = icmp sgt i64 %287, 0
  br i1 %288, label %289, label %300

289:                                              ; preds = %284, %289
  %290 = phi i64 [ %295, %289 ], [ 0, %284 ]
  %291 = getelementptr inbounds double, ptr %54, i64 %290
  %292 = load double, ptr %291, align 8
  %293 = load ptr, ptr %97, align 8
  %294 = getelementptr inbounds double, ptr %293, i64 %290
  store double %292, ptr %294, align 8
  %295 = add nuw nsw i64 %290, 1
  %296 = load i64, ptr %141, align 8
  %297 = load i64, ptr %142, align 8
  %298 = mul nsw i64 %297, %296
  %299 = icmp slt i64 %295, %298
  br i1 %299, label %289, label %300, !llvm.loop !15

300:                                              ; preds = %289, %284
  %301 = load ptr, ptr %97, align 8
  tail call fastcc void @factorise(ptr noundef %301, i64 noundef %79) #7
  br label %302

302:                                              ; preds = %283, %300
  %303 = load i64, ptr %144, align 8
  %304 = load i64, ptr %145, align 8
  %305 = mul nsw i64 %304, %303
  %306 = icmp sgt i64 %305, 0
  br i1 %306, label %307, label %318

307:                                              ; preds = %302, %307
  %308 = phi i64 [ %313, %307 ], [ 0, %302 ]
  %309 = getelementptr inbounds double, ptr %50, i64 %308
  %310 = load double, ptr %309, align 8
  %311 = load ptr, ptr %143, align 8
  %312 = getelementptr inbounds double, ptr %311, i64 %308
  store double %310, ptr %312, align 8
  %313 = add nuw nsw i64 %308, 1
  %314 = load i64, ptr %144, align 8
  %315 = load i64, ptr %145, align 8
  %316 = mul nsw i64 %315, %314
  %317 = icmp slt i64 %313, %316
  br i1 %317, label %307, label %318, !llvm.loop !15

318:                                              ; preds = %307, %302
  %319 = load ptr, ptr %146, align 8
  br i1 %147, label %320, label %328

320:                                              ; preds = %318, %320
  %321 = phi i64 [ %326, %320 ], [ 0, %318 ]
  %322 = getelementptr inbounds double, ptr %106, i64 %321
  %323 = load double, ptr %322, align 8
  %324 = fneg double %323
  %325 = getelementptr inbounds double, ptr %319, i64 %321
  store double %324, ptr %325, align 8
  %326 = add nuw nsw i64 %321, 1
  %327 = icmp eq i64 %326, %120
  br i1 %327, label %328, label %320, !llvm.loop !16

328:                                              ; preds = %320, %318
  call fastcc void @move_positions(ptr noundef nonnull %5, ptr noundef %2) #7
  br label %329

329:                                              ; preds = %328, %266
  %330 = phi double [ %175, %328 ], [ %168, %266 ]
  %331 = phi i64 [ %166, %328 ], [ %281, %266 ]
  br i1 %282, label %332, label %153

332:                                              ; preds = %329, %153, %102
  %333 = phi double [ 0.000000e+00, %102 ], [ %267, %153 ], [ %267, %329 ]
  %334 = phi i64 [ %96, %102 ], [ %331, %329 ], [ %96, %153 ]
  %335 = load i64, ptr %19, align 8
  %336 = icmp eq i64 %335, 0
  %337 = icmp eq i64 %334, 1
  %338 = select i1 %336, i1 true, i1 %337
  br i1 %338, label %345, label %339

339:                                              ; preds = %332
  %340 = icmp sgt i64 %335, 0
  br i1 %340, label %341, label %349

341:                                              ; preds = %339
  %342 = load ptr, ptr %38, align 8
  %343 = load i64, ptr %16, align 8
  %344 = getelementptr double, ptr %342, i64 %343
  br label %356

345:                                              ; preds = %332
  %346 = fcmp ogt double %333, 1.000000e+00
  %347 = zext i1 %346 to i64
  %348 = or i64 %334, %347
  br label %597

349:                                              ; preds = %356, %339
  %350 = phi double [ 0.000000e+00, %339 ], [ %362, %356 ]
  %351 = load i64, ptr %25, align 8
  %352 = mul nsw i64 %351, %335
  %353 = icmp sgt i64 %352, 0
  br i1 %353, label %354, label %365

354:                                              ; preds = %349
  %355 = load ptr, ptr %43, align 8
  br label %373

356:                                              ; preds = %341, %356
  %357 = phi i64 [ 0, %341 ], [ %363, %356 ]
  %358 = phi double [ 0.000000e+00, %341 ], [ %362, %356 ]
  %359 = getelementptr double, ptr %344, i64 %357
  %360 = load double, ptr %359, align 8
  %361 = fmul double %360, 0.000000e+00
  %362 = fadd double %358, %361
  %363 = add nuw nsw i64 %357, 1
  %364 = icmp eq i64 %363, %335
  br i1 %364, label %349, label %356, !llvm.loop !17

365:                                              ; preds = %373, %349
  %366 = phi double [ %350, %349 ], [ %379, %373 ]
  %367 = fcmp une double %366, 0.000000e+00
  %368 = zext i1 %367 to i64
  %369 = or i64 %334, %368
  %370 = and i64 %369, 1
  %371 = xor i64 %370, 1
  store i64 %371, ptr %37, align 8
  %372 = icmp eq ptr %62, null
  br i1 %372, label %457, label %382

373:                                              ; preds = %354, %373
  %374 = phi i64 [ 0, %354 ], [ %380, %373 ]
  %375 = phi double [ %350, %354 ], [ %379, %373 ]
  %376 = getelementptr inbounds double, ptr %355, i64 %374
  %377 = load double, ptr %376, align 8
  %378 = fmul double %377, 0.000000e+00
  %379 = fadd double %375, %378
  %380 = add nuw nsw i64 %374, 1
  %381 = icmp eq i64 %380, %352
  br i1 %381, label %365, label %373, !llvm.loop !18

382:                                              ; preds = %365
  %383 = load i64, ptr %22, align 8
  %384 = load ptr, ptr %38, align 8
  %385 = load i64, ptr %16, align 8
  %386 = getelementptr inbounds double, ptr %384, i64 %385
  %387 = load ptr, ptr %43, align 8
  %388 = icmp sgt i64 %335, 0
  br i1 %388, label %389, label %453

389:                                              ; preds = %382
  %390 = load i64, ptr %34, align 8
  %391 = icmp slt i64 %390, %335
  %392 = icmp sgt i64 %351, 0
  %393 = getelementptr inbounds i8, ptr %0, i64 600
  %394 = getelementptr inbounds i8, ptr %0, i64 576
  %395 = select i1 %391, double 1.000000e-05, double 0x3CE0000000000000
  %396 = add nsw i64 %383, %351
  %397 = sitofp i64 %396 to double
  br label %398

398:                                              ; preds = %389, %406
  %399 = phi double [ 0.000000e+00, %389 ], [ %421, %406 ]
  %400 = phi i64 [ 0, %389 ], [ %422, %406 ]
  br i1 %392, label %401, label %406

401:                                              ; preds = %398
  %402 = mul nuw nsw i64 %400, %351
  %403 = getelementptr double, ptr %387, i64 %402
  %404 = load ptr, ptr %393, align 8
  %405 = load ptr, ptr %394, align 8
  br label %424

406:                                              ; preds = %424, %398
  %407 = phi double [ 0.000000e+00, %398 ], [ %450, %424 ]
  %408 = phi double [ 0.000000e+00, %398 ], [ %447, %424 ]
  %409 = fmul double %395, %407
  %410 = fmul double %408, %397
  %411 = tail call double @llvm.sqrt.f64(double %410)
  %412 = fmul double %411, 3.000000e+00
  %413 = fadd double %409, %412
  %414 = fcmp ule double %408, 0.000000e+00
  %415 = getelementptr inbounds double, ptr %386, i64 %400
  %416 = load double, ptr %415, align 8
  %417 = tail call double @llvm.fabs.f64(double %416)
  %418 = fdiv double %417, %413
  %419 = fcmp ogt double %418, %399
  %420 = select i1 %419, double %418, double %399
  %421 = select i1 %414, double %399, double %420
  %422 = add nuw nsw i64 %400, 1
  %423 = icmp eq i64 %422, %335
  br i1 %423, label %453, label %398, !llvm.loop !13

424:                                              ; preds = %401, %424
  %425 = phi double [ 0.000000e+00, %401 ], [ %447, %424 ]
  %426 = phi i64 [ 0, %401 ], [ %451, %424 ]
  %427 = phi double [ 0.000000e+00, %401 ], [ %450, %424 ]
  %428 = getelementptr double, ptr %403, i64 %426
  %429 = load double, ptr %428, align 8
  %430 = add nsw i64 %426, %383
  %431 = getelementptr inbounds double, ptr %2, i64 %430
  %432 = load double, ptr %431, align 8
  %433 = getelementptr inbounds double, ptr %62, i64 %430
  %434 = load double, ptr %433, align 8
  %435 = getelementptr inbounds double, ptr %404, i64 %430
  %436 = load double, ptr %435, align 8
  %437 = getelementptr inbounds double, ptr %405, i64 %430
  %438 = load double, ptr %437, align 8
  %439 = tail call double @llvm.fabs.f64(double %434)
  %440 = tail call double @llvm.fabs.f64(double %432)
  %441 = fcmp ogt double %439, %440
  %442 = select i1 %441, double %439, double %440
  %443 = fmul double %442, %438
  %444 = fadd double %436, %443
  %445 = fmul double %429, %444
  %446 = fmul double %445, %445
  %447 = fadd double %425, %446
  %448 = fmul double %429, %432
  %449 = tail call double @llvm.fabs.f64(double %448)
  %450 = fadd double %427, %449
  %451 = add nuw nsw i64 %426, 1
  %452 = icmp eq i64 %451, %351
  br i1 %452, label %406, label %424, !llvm.loop !14

453:                                              ; preds = %406, %382
  %454 = phi double [ 0.000000e+00, %382 ], [ %421, %406 ]
  %455 = fcmp ogt double %454, %333
  %456 = select i1 %455, double %454, double %333
  br label %457

457:                                              ; preds = %453, %365
  %458 = phi double [ %333, %365 ], [ %456, %453 ]
  %459 = load i64, ptr %28, align 8
  %460 = icmp eq i64 %459, 1
  br i1 %460, label %461, label %485

461:                                              ; preds = %457
  %462 = load ptr, ptr %44, align 8
  %463 = load ptr, ptr %5, align 8
  %464 = getelementptr inbounds i8, ptr %463, i64 8
  %465 = getelementptr inbounds i8, ptr %463, i64 16
  %466 = load i64, ptr %464, align 8
  %467 = load i64, ptr %465, align 8
  %468 = mul nsw i64 %467, %466
  %469 = icmp sgt i64 %468, 0
  br i1 %469, label %470, label %481

470:                                              ; preds = %461, %470
  %471 = phi i64 [ %476, %470 ], [ 0, %461 ]
  %472 = getelementptr inbounds double, ptr %462, i64 %471
  %473 = load double, ptr %472, align 8
  %474 = load ptr, ptr %463, align 8
  %475 = getelementptr inbounds double, ptr %474, i64 %471
  store double %473, ptr %475, align 8
  %476 = add nuw nsw i64 %471, 1
  %477 = load i64, ptr %464, align 8
  %478 = load i64, ptr %465, align 8
  %479 = mul nsw i64 %478, %477
  %480 = icmp slt i64 %476, %479
  br i1 %480, label %470, label %481, !llvm.loop !15

481:                                              ; preds = %470, %461
  %482 = load ptr, ptr %5, align 8
  %483 = load ptr, ptr %482, align 8
  %484 = load i64, ptr %25, align 8
  tail call fastcc void @factorise(ptr noundef %483, i64 noundef %484) #7
  br label %485

485:                                              ; preds = %457, %481
  %486 = load ptr, ptr %38, align 8
  %487 = load i64, ptr %16, align 8
  %488 = getelementptr inbounds double, ptr %486, i64 %487
  %489 = load i64, ptr %19, align 8
  %490 = load ptr, ptr %5, align 8
  %491 = getelementptr inbounds i8, ptr %490, i64 144
  %492 = load ptr, ptr %491, align 8
  %493 = icmp sgt i64 %489, 0
  br i1 %493, label %494, label %502

494:                                              ; preds = %485, %494
  %495 = phi i64 [ %500, %494 ], [ 0, %485 ]
  %496 = getelementptr inbounds double, ptr %488, i64 %495
  %497 = load double, ptr %496, align 8
  %498 = fneg double %497
  %499 = getelementptr inbounds double, ptr %492, i64 %495
  store double %498, ptr %499, align 8
  %500 = add nuw nsw i64 %495, 1
  %501 = icmp eq i64 %500, %489
  br i1 %501, label %502, label %494, !llvm.loop !16

502:                                              ; preds = %494, %485
  call fastcc void @move_speeds(ptr noundef nonnull %5, ptr noundef %2) #7
  %503 = load ptr, ptr %63, align 8
  %504 = getelementptr inbounds i8, ptr %503, i64 8
  %505 = load i64, ptr %504, align 8
  %506 = load ptr, ptr %46, align 8
  %507 = load i64, ptr %37, align 8
  %508 = trunc i64 %507 to i32
  %509 = load i64, ptr %19, align 8
  %510 = icmp sgt i64 %509, 0
  br i1 %510, label %511, label %518

511:                                              ; preds = %502
  %512 = load ptr, ptr %5, align 8
  %513 = getelementptr inbounds i8, ptr %512, i64 216
  %514 = getelementptr double, ptr %506, i64 %505
  %515 = getelementptr i8, ptr %514, i64 32
  %516 = getelementptr inbounds i8, ptr %512, i64 192
  %517 = icmp eq i32 %508, 0
  br label %558

518:                                              ; preds = %558, %502
  %519 = phi double [ 0.000000e+00, %502 ], [ %575, %558 ]
  %520 = phi double [ 1.000000e+00, %502 ], [ %579, %558 ]
  %521 = load double, ptr %506, align 8
  %522 = getelementptr inbounds i8, ptr %506, i64 16
  %523 = load double, ptr %522, align 8
  %524 = fcmp ule double %519, %521
  %525 = and i32 %508, 1
  %526 = icmp eq i32 %525, 0
  %527 = select i1 %524, i1 true, i1 %526
  %528 = select i1 %527, double %521, double %519
  store double %528, ptr %506, align 8
  %529 = getelementptr inbounds i8, ptr %506, i64 8
  %530 = load double, ptr %529, align 8
  %531 = select i1 %527, double %530, double 1.000000e+00
  %532 = fcmp uge double %519, %521
  %533 = select i1 %532, double %520, double 0.000000e+00
  %534 = fcmp olt double %533, %523
  %535 = select i1 %534, double %533, double %523
  %536 = icmp eq i32 %508, 0
  %537 = select i1 %536, double %523, double %533
  store double %537, ptr %522, align 8
  %538 = fcmp oge double %535, 5.000000e-02
  %539 = fmul double %458, %535
  %540 = fmul double %539, 5.000000e-02
  %541 = fcmp ogt double %540, 1.000000e+00
  %542 = or i1 %538, %541
  %543 = load i64, ptr %37, align 8
  %544 = fcmp ogt double %458, 1.000000e+00
  %545 = and i1 %544, %542
  %546 = and i64 %543, 1
  %547 = select i1 %545, i64 %546, i64 0
  %548 = xor i64 %547, %543
  %549 = trunc i64 %548 to i32
  %550 = fcmp olt double %533, %531
  %551 = and i32 %549, 1
  %552 = fcmp ogt double %531, 1.000000e-05
  %553 = and i1 %552, %550
  %554 = select i1 %553, i32 %551, i32 0
  %555 = icmp eq i32 %554, 0
  %556 = select i1 %555, double %531, double %533
  store double %556, ptr %529, align 8
  %557 = icmp eq i32 %554, 0
  br i1 %557, label %595, label %582

558:                                              ; preds = %511, %558
  %559 = phi double [ 1.000000e+00, %511 ], [ %579, %558 ]
  %560 = phi double [ 0.000000e+00, %511 ], [ %575, %558 ]
  %561 = phi i64 [ 0, %511 ], [ %580, %558 ]
  %562 = load ptr, ptr %513, align 8
  %563 = getelementptr inbounds double, ptr %562, i64 %561
  %564 = load double, ptr %563, align 8
  %565 = getelementptr double, ptr %515, i64 %561
  %566 = load double, ptr %565, align 8
  %567 = load ptr, ptr %516, align 8
  %568 = getelementptr inbounds double, ptr %567, i64 %561
  %569 = load double, ptr %568, align 8
  %570 = fcmp ogt double %569, %566
  %571 = select i1 %570, double %569, double %566
  %572 = select i1 %517, double %566, double %571
  store double %572, ptr %565, align 8
  %573 = fcmp ule double %564, 0.000000e+00
  %574 = fadd double %560, 1.000000e+00
  %575 = select i1 %573, double %560, double %574
  %576 = fdiv double %564, %571
  %577 = fcmp olt double %576, %559
  %578 = select i1 %577, double %576, double %559
  %579 = select i1 %573, double %559, double %578
  %580 = add nuw nsw i64 %561, 1
  %581 = icmp eq i64 %580, %509
  br i1 %581, label %518, label %558, !llvm.loop !19

582:                                              ; preds = %518
  %583 = getelementptr inbounds i8, ptr %506, i64 24
  store double %1, ptr %583, align 8
  %584 = getelementptr inbounds i8, ptr %506, i64 32
  %585 = icmp sgt i64 %505, 0
  br i1 %585, label %586, label %595

586:                                              ; preds = %582, %586
  %587 = phi i64 [ %593, %586 ], [ 0, %582 ]
  %588 = getelementptr inbounds double, ptr %2, i64 %587
  %589 = load double, ptr %588, align 8
  %590 = getelementptr inbounds double, ptr %584, i64 %587
  %591 = load double, ptr %590, align 8
  %592 = select i1 %555, double %591, double %589
  store double %592, ptr %590, align 8
  %593 = add nuw nsw i64 %587, 1
  %594 = icmp eq i64 %593, %505
  br i1 %594, label %595, label %586, !llvm.loop !20

595:                                              ; preds = %586, %582, %518
  %596 = or i64 %547, %369
  br label %597

597:                                              ; preds = %345, %595
  %598 = phi i64 [ %348, %345 ], [ %596, %595 ]
  %599 = icmp eq i64 %598, 0
  %600 = select i1 %599, i64 0, i64 6
  ret i64 %600
}



define internal fastcc void @move_speeds(ptr noundef readonly %0, ptr noundef %1) unnamed_addr #2 {
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %0, i64 96
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %3, i64 96
  %7 = getelementptr inbounds i8, ptr %3, i64 104
  %8 = getelementptr inbounds i8, ptr %3, i64 112
  %9 = load i64, ptr %7, align 8
  %10 = load i64, ptr %8, align 8
  %11 = mul nsw i64 %10, %9
  %12 = icmp sgt i64 %11, 0
  br i1 %12, label %13, label %24

13:                                               ; preds = %2, %13
  %14 = phi i64 [ %19, %13 ], [ 0, %2 ]
  %15 = getelementptr inbounds double, ptr %5, i64 %14
  %16 = load double, ptr %15, align 8
  %17 = load ptr, ptr %6, align 8
  %18 = getelementptr inbounds double, ptr %17, i64 %14
  store double %16, ptr %18, align 8
  %19 = add nuw nsw i64 %14, 1
  %20 = load i64, ptr %7, align 8
  %21 = load i64, ptr %8, align 8
  %22 = mul nsw i64 %21, %20
  %23 = icmp slt i64 %19, %22
  br i1 %23, label %13, label %24, !llvm.loop !15

24:                                               ; preds = %13, %2
  %25 = load ptr, ptr %6, align 8
  %26 = getelementptr inbounds i8, ptr %0, i64 16
  %27 = load i64, ptr %26, align 8
  %28 = load ptr, ptr %3, align 8
  %29 = getelementptr inbounds i8, ptr %0, i64 32
  %30 = load i64, ptr %29, align 8
  tail call fastcc void @divide_rows(ptr noundef %25, i64 noundef %27, ptr noundef %28, i64 noundef %30) #7
  %31 = getelementptr inbounds i8, ptr %0, i64 56
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %0, i64 64
  %34 = load i64, ptr %33, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %6, ptr noundef nonnull %3, i64 noundef %32, i64 noundef %34) #7
  %35 = load ptr, ptr %3, align 8
  %36 = load i64, ptr %29, align 8
  %37 = getelementptr inbounds i8, ptr %3, i64 120
  %38 = load ptr, ptr %37, align 8
  tail call fastcc void @divide_transposed(ptr noundef %35, i64 noundef %36, ptr noundef %38) #7
  %39 = load i64, ptr %29, align 8
  %40 = icmp sgt i64 %39, 0
  br i1 %40, label %41, label %43

41:                                               ; preds = %24
  %42 = getelementptr inbounds i8, ptr %0, i64 24
  br label %44

43:                                               ; preds = %44, %24
  ret void

44:                                               ; preds = %41, %44
  %45 = phi i64 [ 0, %41 ], [ %58, %44 ]
  %46 = load i64, ptr %42, align 8
  %47 = getelementptr double, ptr %1, i64 %46
  %48 = getelementptr double, ptr %47, i64 %45
  %49 = load double, ptr %48, align 8
  %50 = load i64, ptr %33, align 8
  %51 = load ptr, ptr %37, align 8
  %52 = getelementptr inbounds double, ptr %51, i64 %45
  %53 = load double, ptr %52, align 8
  %54 = fadd double %49, %53
  %55 = and i64 %50, 4294967295
  %56 = icmp eq i64 %55, 0
  %57 = select i1 %56, double %49, double %54
  store double %57, ptr %48, align 8
  %58 = add nuw nsw i64 %45, 1
  %59 = load i64, ptr %29, align 8
  %60 = icmp slt i64 %58, %59
  br i1 %60, label %44, label %43, !llvm.loop !21
}

define internal fastcc void @settle(ptr noundef readonly %0) unnamed_addr #2 {
  %2 = getelementptr inbounds i8, ptr %0, i64 192
  %3 = load ptr, ptr %2, align 8
  %4 = load double, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 24
  %6 = load ptr, ptr %5, align 8
  %7 = load double, ptr %6, align 8
  %8 = fcmp olt double %7, %4
  %9 = select i1 %8, double %7, double %4
  %10 = getelementptr inbounds i8, ptr %0, i64 168
  %11 = getelementptr inbounds i8, ptr %0, i64 176
  %12 = load i64, ptr %11, align 8
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %14, label %29

14:                                               ; preds = %1
  %15 = load ptr, ptr %10, align 8
  br label %16

16:                                               ; preds = %14, %16
  %17 = phi i64 [ 0, %14 ], [ %27, %16 ]
  %18 = phi i64 [ %12, %14 ], [ %26, %16 ]
  %19 = add nuw nsw i64 %17, %18
  %20 = lshr i64 %19, 1
  %21 = mul i64 %20, 24
  %22 = getelementptr inbounds i8, ptr %15, i64 %21
  %23 = load double, ptr %22, align 8
  %24 = fcmp ogt double %23, %9
  %25 = add nuw nsw i64 %20, 1
  %26 = select i1 %24, i64 %20, i64 %18
  %27 = select i1 %24, i64 %17, i64 %25
  %28 = icmp slt i64 %27, %26
  br i1 %28, label %16, label %29, !llvm.loop !22

29:                                               ; preds = %16, %1
  %30 = phi i64 [ 0, %1 ], [ %27, %16 ]
  %31 = load ptr, ptr %10, align 8
  %32 = mul i64 %30, 24
  %33 = getelementptr inbounds i8, ptr %31, i64 %32
  %34 = icmp eq i64 %30, 0
  br i1 %34, label %39, label %35

35:                                               ; preds = %29
  %36 = getelementptr inbounds i8, ptr %33, i64 -8
  %37 = load double, ptr %36, align 8
  %38 = fcmp olt double %9, %37
  br i1 %38, label %46, label %39

39:                                               ; preds = %35, %29
  %40 = icmp slt i64 %30, %12
  br i1 %40, label %41, label %45

41:                                               ; preds = %39
  %42 = getelementptr inbounds i8, ptr %33, i64 8
  %43 = load double, ptr %42, align 8
  %44 = fcmp ogt double %9, %43
  br i1 %44, label %46, label %45

45:                                               ; preds = %41, %39
  br label %46

46:                                               ; preds = %45, %41, %35
  %47 = phi double [ %37, %35 ], [ %9, %45 ], [ %43, %41 ]
  store double %47, ptr %6, align 8
  ret void
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #2 {
  %2 = getelementptr inbounds i8, ptr %0, i64 104
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %13

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 96
  %7 = getelementptr inbounds i8, ptr %0, i64 112
  %8 = getelementptr inbounds i8, ptr %0, i64 24
  %9 = getelementptr inbounds i8, ptr %0, i64 192
  %10 = getelementptr inbounds i8, ptr %0, i64 120
  %11 = getelementptr inbounds i8, ptr %0, i64 144
  %12 = getelementptr inbounds i8, ptr %0, i64 48
  br label %14

13:                                               ; preds = %61, %1
  ret void

14:                                               ; preds = %5, %61
  %15 = phi i64 [ 0, %5 ], [ %86, %61 ]
  %16 = load ptr, ptr %6, align 8
  %17 = load i64, ptr %7, align 8
  %18 = mul nsw i64 %17, %15
  %19 = getelementptr inbounds i64, ptr %16, i64 %18
  %20 = getelementptr inbounds i8, ptr %19, i64 24
  %21 = load ptr, ptr %8, align 8
  %22 = load double, ptr %21, align 8
  %23 = load ptr, ptr %9, align 8
  %24 = load double, ptr %23, align 8
  %25 = fcmp olt double %22, %24
  %26 = select i1 %25, double %22, double %24
  %27 = getelementptr inbounds i8, ptr %19, i64 8
  %28 = load i64, ptr %27, align 8
  %29 = load ptr, ptr %10, align 8
  %30 = getelementptr inbounds double, ptr %29, i64 %28
  %31 = load double, ptr %30, align 8
  %32 = fcmp ogt double %31, %26
  %33 = select i1 %32, double %31, double %26
  %34 = getelementptr inbounds i8, ptr %19, i64 16
  %35 = load i64, ptr %34, align 8
  %36 = load i64, ptr %20, align 8
  %37 = getelementptr inbounds double, ptr %30, i64 %36
  %38 = load double, ptr %37, align 8
  %39 = fcmp ugt double %38, %33
  br i1 %39, label %47, label %40

40:                                               ; preds = %14
  %41 = add nsw i64 %35, -1
  %42 = icmp eq i64 %41, %36
  br i1 %42, label %61, label %43

43:                                               ; preds = %40
  %44 = getelementptr i8, ptr %37, i64 8
  %45 = load double, ptr %44, align 8
  %46 = fcmp ogt double %45, %33
  br i1 %46, label %61, label %47

47:                                               ; preds = %43, %14
  %48 = icmp sgt i64 %35, 1
  br i1 %48, label %49, label %61

49:                                               ; preds = %47, %49
  %50 = phi i64 [ %58, %49 ], [ %35, %47 ]
  %51 = phi i64 [ %57, %49 ], [ 0, %47 ]
  %52 = add nsw i64 %50, %51
  %53 = sdiv i64 %52, 2
  %54 = getelementptr inbounds double, ptr %30, i64 %53
  %55 = load double, ptr %54, align 8
  %56 = fcmp ugt double %55, %33
  %57 = select i1 %56, i64 %51, i64 %53
  %58 = select i1 %56, i64 %53, i64 %50
  %59 = sub nsw i64 %58, %57
  %60 = icmp sgt i64 %59, 1
  br i1 %60, label %49, label %61, !llvm.loop !23

61:                                               ; preds = %49, %47, %40, %43
  %62 = phi i64 [ %36, %43 ], [ %36, %40 ], [ 0, %47 ], [ %57, %49 ]
  store i64 %62, ptr %20, align 8
  %63 = getelementptr inbounds double, ptr %30, i64 %62
  %64 = load double, ptr %63, align 8
  %65 = fsub double %33, %64
  %66 = load ptr, ptr %11, align 8
  %67 = add nsw i64 %62, %28
  %68 = shl nsw i64 %67, 5
  %69 = getelementptr inbounds i8, ptr %66, i64 %68
  %70 = load double, ptr %69, align 8
  %71 = getelementptr inbounds i8, ptr %69, i64 8
  %72 = load double, ptr %71, align 8
  %73 = getelementptr inbounds i8, ptr %69, i64 16
  %74 = load double, ptr %73, align 8
  %75 = getelementptr inbounds i8, ptr %69, i64 24
  %76 = load double, ptr %75, align 8
  %77 = fmul double %65, %76
  %78 = fadd double %74, %77
  %79 = fmul double %65, %78
  %80 = fadd double %72, %79
  %81 = fmul double %65, %80
  %82 = fadd double %70, %81
  %83 = load ptr, ptr %12, align 8
  %84 = load i64, ptr %19, align 8
  %85 = getelementptr inbounds double, ptr %83, i64 %84
  store double %82, ptr %85, align 8
  %86 = add nuw nsw i64 %15, 1
  %87 = load i64, ptr %2, align 8
  %88 = icmp slt i64 %86, %87
  br i1 %88, label %14, label %13, !llvm.loop !24
}

declare double @llvm.fabs.f64(double) #3

define internal fastcc void @move_positions(ptr noundef readonly %0, ptr noundef %1) unnamed_addr #2 {
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %3, i64 120
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 80
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %3, i64 48
  %9 = getelementptr inbounds i8, ptr %3, i64 56
  %10 = getelementptr inbounds i8, ptr %3, i64 64
  %11 = load i64, ptr %9, align 8
  %12 = load i64, ptr %10, align 8
  %13 = mul nsw i64 %12, %11
  %14 = icmp sgt i64 %13, 0
  br i1 %14, label %15, label %26

15:                                               ; preds = %2, %15
  %16 = phi i64 [ %21, %15 ], [ 0, %2 ]
  %17 = getelementptr inbounds double, ptr %7, i64 %16
  %18 = load double, ptr %17, align 8
  %19 = load ptr, ptr %8, align 8
  %20 = getelementptr inbounds double, ptr %19, i64 %16
  store double %18, ptr %20, align 8
  %21 = add nuw nsw i64 %16, 1
  %22 = load i64, ptr %9, align 8
  %23 = load i64, ptr %10, align 8
  %24 = mul nsw i64 %23, %22
  %25 = icmp slt i64 %21, %24
  br i1 %25, label %15, label %26, !llvm.loop !15

26:                                               ; preds = %15, %2
  tail call fastcc void @set_rows(ptr noundef nonnull %0) #7
  %27 = getelementptr inbounds i8, ptr %3, i64 72
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr inbounds i8, ptr %0, i64 8
  %30 = load i64, ptr %29, align 8
  %31 = load ptr, ptr %3, align 8
  %32 = getelementptr inbounds i8, ptr %0, i64 32
  %33 = load i64, ptr %32, align 8
  tail call fastcc void @divide_rows(ptr noundef %28, i64 noundef %30, ptr noundef %31, i64 noundef %33) #7
  %34 = getelementptr inbounds i8, ptr %0, i64 48
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds i8, ptr %0, i64 64
  %37 = load i64, ptr %36, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %27, ptr noundef nonnull %3, i64 noundef %35, i64 noundef %37) #7
  %38 = load i64, ptr %32, align 8
  %39 = icmp sgt i64 %38, 0
  br i1 %39, label %40, label %49

40:                                               ; preds = %26, %40
  %41 = phi i64 [ %47, %40 ], [ 0, %26 ]
  %42 = phi double [ %46, %40 ], [ 0.000000e+00, %26 ]
  %43 = getelementptr inbounds double, ptr %5, i64 %41
  %44 = load double, ptr %43, align 8
  %45 = fmul double %44, %44
  %46 = fadd double %42, %45
  %47 = add nuw nsw i64 %41, 1
  %48 = icmp eq i64 %47, %38
  br i1 %48, label %49, label %40, !llvm.loop !25

49:                                               ; preds = %40, %26
  %50 = phi double [ 0.000000e+00, %26 ], [ %46, %40 ]
  %51 = tail call double @llvm.sqrt.f64(double %50)
  %52 = load i64, ptr %29, align 8
  %53 = icmp sgt i64 %52, 0
  br i1 %53, label %54, label %57

54:                                               ; preds = %49
  %55 = getelementptr inbounds i8, ptr %3, i64 240
  %56 = getelementptr inbounds i8, ptr %3, i64 192
  br label %66

57:                                               ; preds = %66, %49
  %58 = load ptr, ptr %3, align 8
  %59 = load i64, ptr %32, align 8
  %60 = load ptr, ptr %4, align 8
  tail call fastcc void @divide_transposed(ptr noundef %58, i64 noundef %59, ptr noundef %60) #7
  %61 = getelementptr inbounds i8, ptr %0, i64 24
  %62 = load i64, ptr %61, align 8
  %63 = icmp sgt i64 %62, 0
  br i1 %63, label %64, label %80

64:                                               ; preds = %57
  %65 = getelementptr inbounds i8, ptr %3, i64 24
  br label %87

66:                                               ; preds = %54, %66
  %67 = phi i64 [ 0, %54 ], [ %77, %66 ]
  %68 = load ptr, ptr %55, align 8
  %69 = getelementptr inbounds double, ptr %68, i64 %67
  %70 = load double, ptr %69, align 8
  %71 = fcmp une double %70, 0.000000e+00
  %72 = load ptr, ptr %56, align 8
  %73 = getelementptr inbounds double, ptr %72, i64 %67
  %74 = load double, ptr %73, align 8
  %75 = fmul double %51, %74
  %76 = select i1 %71, double %70, double %75
  store double %76, ptr %69, align 8
  %77 = add nuw nsw i64 %67, 1
  %78 = load i64, ptr %29, align 8
  %79 = icmp slt i64 %77, %78
  br i1 %79, label %66, label %57, !llvm.loop !26

80:                                               ; preds = %97, %57
  %81 = getelementptr inbounds i8, ptr %0, i64 24
  %82 = load i64, ptr %29, align 8
  %83 = icmp sgt i64 %82, 0
  br i1 %83, label %84, label %119

84:                                               ; preds = %80
  %85 = getelementptr inbounds i8, ptr %3, i64 144
  %86 = load ptr, ptr %85, align 8
  br label %125

87:                                               ; preds = %64, %97
  %88 = phi i64 [ 0, %64 ], [ %103, %97 ]
  %89 = getelementptr inbounds double, ptr %1, i64 %88
  %90 = load double, ptr %89, align 8
  %91 = load i64, ptr %32, align 8
  %92 = icmp sgt i64 %91, 0
  br i1 %92, label %93, label %97

93:                                               ; preds = %87
  %94 = load ptr, ptr %65, align 8
  %95 = mul nuw nsw i64 %91, %88
  %96 = getelementptr double, ptr %94, i64 %95
  br label %106

97:                                               ; preds = %106, %87
  %98 = phi double [ %90, %87 ], [ %114, %106 ]
  %99 = load i64, ptr %36, align 8
  %100 = and i64 %99, 4294967295
  %101 = icmp eq i64 %100, 0
  %102 = select i1 %101, double %90, double %98
  store double %102, ptr %89, align 8
  %103 = add nuw nsw i64 %88, 1
  %104 = load i64, ptr %61, align 8
  %105 = icmp slt i64 %103, %104
  br i1 %105, label %87, label %80, !llvm.loop !27

106:                                              ; preds = %93, %106
  %107 = phi i64 [ 0, %93 ], [ %115, %106 ]
  %108 = phi double [ %90, %93 ], [ %114, %106 ]
  %109 = getelementptr double, ptr %96, i64 %107
  %110 = load double, ptr %109, align 8
  %111 = getelementptr inbounds double, ptr %5, i64 %107
  %112 = load double, ptr %111, align 8
  %113 = fmul double %110, %112
  %114 = fadd double %108, %113
  %115 = add nuw nsw i64 %107, 1
  %116 = icmp eq i64 %115, %91
  br i1 %116, label %97, label %106, !llvm.loop !28

117:                                              ; preds = %125
  %118 = fcmp ule double %132, 0.000000e+00
  br label %119

119:                                              ; preds = %117, %80
  %120 = phi i1 [ true, %80 ], [ %118, %117 ]
  %121 = load i64, ptr %36, align 8
  %122 = and i64 %121, 1
  %123 = icmp eq i64 %122, 0
  %124 = select i1 %120, i1 true, i1 %123
  br i1 %124, label %149, label %135

125:                                              ; preds = %84, %125
  %126 = phi i64 [ 0, %84 ], [ %133, %125 ]
  %127 = phi double [ 0.000000e+00, %84 ], [ %132, %125 ]
  %128 = getelementptr inbounds double, ptr %86, i64 %126
  %129 = load double, ptr %128, align 8
  %130 = tail call double @llvm.fabs.f64(double %129)
  %131 = fcmp ogt double %130, %127
  %132 = select i1 %131, double %130, double %127
  %133 = add nuw nsw i64 %126, 1
  %134 = icmp eq i64 %133, %82
  br i1 %134, label %117, label %125, !llvm.loop !29

135:                                              ; preds = %119
  %136 = load i64, ptr %34, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %8, ptr noundef nonnull %3, i64 noundef %136, i64 noundef %122) #7
  %137 = load i64, ptr %81, align 8
  %138 = icmp sgt i64 %137, 0
  br i1 %138, label %139, label %149

139:                                              ; preds = %135, %139
  %140 = phi i64 [ %146, %139 ], [ 0, %135 ]
  %141 = getelementptr inbounds double, ptr %1, i64 %140
  %142 = load double, ptr %141, align 8
  %143 = getelementptr inbounds double, ptr %5, i64 %140
  %144 = load double, ptr %143, align 8
  %145 = fadd double %142, %144
  store double %145, ptr %141, align 8
  %146 = add nuw nsw i64 %140, 1
  %147 = load i64, ptr %81, align 8
  %148 = icmp slt i64 %146, %147
  br i1 %148, label %139, label %149, !llvm.loop !30

149:                                              ; preds = %139, %135, %119
  ret void
}

define internal fastcc void @set_rows(ptr noundef readonly %0) unnamed_addr #2 {
  %2 = getelementptr inbounds i8, ptr %0, i64 8
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %16

5:                                                ; preds = %1
  %6 = load ptr, ptr %0, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 32
  %8 = getelementptr inbounds i8, ptr %0, i64 24
  %9 = getelementptr inbounds i8, ptr %6, i64 48
  %10 = getelementptr inbounds i8, ptr %6, i64 24
  %11 = getelementptr inbounds i8, ptr %6, i64 72
  br label %12

12:                                               ; preds = %5, %28
  %13 = phi i64 [ 0, %5 ], [ %29, %28 ]
  %14 = load i64, ptr %7, align 8
  %15 = icmp sgt i64 %14, 0
  br i1 %15, label %17, label %28

16:                                               ; preds = %28, %1
  ret void

17:                                               ; preds = %12, %32
  %18 = phi i64 [ %47, %32 ], [ %14, %12 ]
  %19 = phi i64 [ %46, %32 ], [ 0, %12 ]
  %20 = load i64, ptr %8, align 8
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %22, label %32

22:                                               ; preds = %17
  %23 = load ptr, ptr %9, align 8
  %24 = mul nuw nsw i64 %20, %13
  %25 = getelementptr double, ptr %23, i64 %24
  %26 = load ptr, ptr %10, align 8
  %27 = getelementptr double, ptr %26, i64 %19
  br label %49

28:                                               ; preds = %32, %12
  %29 = add nuw nsw i64 %13, 1
  %30 = load i64, ptr %2, align 8
  %31 = icmp slt i64 %29, %30
  br i1 %31, label %12, label %16, !llvm.loop !31

32:                                               ; preds = %49, %17
  %33 = phi double [ 0.000000e+00, %17 ], [ %59, %49 ]
  %34 = phi double [ 0.000000e+00, %17 ], [ %61, %49 ]
  %35 = tail call double @llvm.fabs.f64(double %33)
  %36 = sitofp i64 %20 to double
  %37 = fmul double %36, 4.000000e+00
  %38 = fmul double %37, 0x3CB0000000000000
  %39 = fmul double %34, %38
  %40 = fcmp ugt double %35, %39
  %41 = load ptr, ptr %11, align 8
  %42 = mul nsw i64 %18, %13
  %43 = select i1 %40, double %33, double 0.000000e+00
  %44 = getelementptr double, ptr %41, i64 %42
  %45 = getelementptr double, ptr %44, i64 %19
  store double %43, ptr %45, align 8
  %46 = add nuw nsw i64 %19, 1
  %47 = load i64, ptr %7, align 8
  %48 = icmp slt i64 %46, %47
  br i1 %48, label %17, label %28, !llvm.loop !32

49:                                               ; preds = %22, %49
  %50 = phi i64 [ 0, %22 ], [ %62, %49 ]
  %51 = phi double [ 0.000000e+00, %22 ], [ %61, %49 ]
  %52 = phi double [ 0.000000e+00, %22 ], [ %59, %49 ]
  %53 = getelementptr double, ptr %25, i64 %50
  %54 = load double, ptr %53, align 8
  %55 = mul nsw i64 %50, %18
  %56 = getelementptr double, ptr %27, i64 %55
  %57 = load double, ptr %56, align 8
  %58 = fmul double %54, %57
  %59 = fadd double %52, %58
  %60 = tail call double @llvm.fabs.f64(double %58)
  %61 = fadd double %51, %60
  %62 = add nuw nsw i64 %50, 1
  %63 = icmp eq i64 %62, %20
  br i1 %63, label %32, label %49, !llvm.loop !33
}

define internal fastcc void @divide_rows(ptr noundef %0, i64 noundef %1, ptr noundef readonly %2, i64 noundef %3) unnamed_addr #4 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %6, label %15

6:                                                ; preds = %4
  %7 = icmp sgt i64 %3, 0
  %8 = add i64 %3, 1
  br label %9

9:                                                ; preds = %6, %16
  %10 = phi i64 [ 0, %6 ], [ %17, %16 ]
  br i1 %7, label %11, label %16

11:                                               ; preds = %9
  %12 = mul nuw nsw i64 %10, %3
  %13 = getelementptr double, ptr %0, i64 %12
  %14 = getelementptr double, ptr %0, i64 %12
  br label %19

15:                                               ; preds = %16, %4
  ret void

16:                                               ; preds = %27, %9
  %17 = add nuw nsw i64 %10, 1
  %18 = icmp eq i64 %17, %1
  br i1 %18, label %15, label %9, !llvm.loop !34

19:                                               ; preds = %11, %27
  %20 = phi i64 [ 0, %11 ], [ %33, %27 ]
  %21 = getelementptr double, ptr %13, i64 %20
  %22 = load double, ptr %21, align 8
  %23 = icmp eq i64 %20, 0
  br i1 %23, label %27, label %24

24:                                               ; preds = %19
  %25 = mul nuw nsw i64 %20, %3
  %26 = getelementptr double, ptr %2, i64 %25
  br label %35

27:                                               ; preds = %35, %19
  %28 = phi double [ %22, %19 ], [ %43, %35 ]
  %29 = mul i64 %20, %8
  %30 = getelementptr inbounds double, ptr %2, i64 %29
  %31 = load double, ptr %30, align 8
  %32 = fdiv double %28, %31
  store double %32, ptr %21, align 8
  %33 = add nuw nsw i64 %20, 1
  %34 = icmp eq i64 %33, %3
  br i1 %34, label %16, label %19, !llvm.loop !35

35:                                               ; preds = %24, %35
  %36 = phi i64 [ 0, %24 ], [ %44, %35 ]
  %37 = phi double [ %22, %24 ], [ %43, %35 ]
  %38 = getelementptr double, ptr %26, i64 %36
  %39 = load double, ptr %38, align 8
  %40 = getelementptr double, ptr %14, i64 %36
  %41 = load double, ptr %40, align 8
  %42 = fmul double %39, %41
  %43 = fsub double %37, %42
  %44 = add nuw nsw i64 %36, 1
  %45 = icmp eq i64 %44, %20
  br i1 %45, label %27, label %35, !llvm.loop !36
}

define internal fastcc void @minimum_norm(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, i64 noundef %3) unnamed_addr #2 {
  %5 = getelementptr inbounds i8, ptr %0, i64 8
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 16
  %8 = load i64, ptr %7, align 8
  %9 = load ptr, ptr %0, align 8
  %10 = getelementptr inbounds i8, ptr %1, i64 120
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %1, i64 144
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %1, i64 168
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %1, i64 192
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %1, i64 216
  %19 = load ptr, ptr %18, align 8
  %20 = getelementptr inbounds i8, ptr %1, i64 264
  %21 = load ptr, ptr %20, align 8
  %22 = trunc i64 %3 to i32
  %23 = icmp sgt i64 %8, 0
  br i1 %23, label %30, label %24

24:                                               ; preds = %30, %4
  %25 = icmp sgt i64 %6, 0
  br i1 %25, label %26, label %35

26:                                               ; preds = %24
  %27 = icmp sgt i64 %8, 0
  %28 = icmp eq i32 %22, 0
  %29 = icmp sgt i64 %8, 0
  br label %46

30:                                               ; preds = %4, %30
  %31 = phi i64 [ %33, %30 ], [ 0, %4 ]
  %32 = getelementptr inbounds double, ptr %11, i64 %31
  store double 0.000000e+00, ptr %32, align 8
  %33 = add nuw nsw i64 %31, 1
  %34 = icmp eq i64 %33, %8
  br i1 %34, label %24, label %30, !llvm.loop !37

35:                                               ; preds = %74, %24
  %36 = icmp sgt i64 %2, 0
  br i1 %36, label %37, label %220

37:                                               ; preds = %35
  %38 = icmp sgt i64 %6, 0
  %39 = icmp sgt i64 %8, 0
  %40 = icmp sgt i64 %6, 0
  %41 = icmp sgt i64 %8, 0
  %42 = icmp sgt i64 %8, 0
  %43 = icmp sgt i64 %6, 0
  %44 = icmp sgt i64 %8, 0
  %45 = icmp sgt i64 %8, 0
  br label %84

46:                                               ; preds = %26, %74
  %47 = phi i64 [ 0, %26 ], [ %75, %74 ]
  %48 = mul nsw i64 %47, %8
  %49 = getelementptr inbounds double, ptr %9, i64 %48
  br i1 %27, label %50, label %59

50:                                               ; preds = %46, %50
  %51 = phi i64 [ %57, %50 ], [ 0, %46 ]
  %52 = phi double [ %56, %50 ], [ 0.000000e+00, %46 ]
  %53 = getelementptr inbounds double, ptr %49, i64 %51
  %54 = load double, ptr %53, align 8
  %55 = fmul double %54, %54
  %56 = fadd double %52, %55
  %57 = add nuw nsw i64 %51, 1
  %58 = icmp eq i64 %57, %8
  br i1 %58, label %59, label %50, !llvm.loop !25

59:                                               ; preds = %50, %46
  %60 = phi double [ 0.000000e+00, %46 ], [ %56, %50 ]
  %61 = tail call double @llvm.sqrt.f64(double %60)
  %62 = fcmp ule double %60, 0.000000e+00
  %63 = fdiv double 1.000000e+00, %61
  %64 = select i1 %62, double 1.000000e+00, double %63
  %65 = select i1 %62, double 0.000000e+00, double %61
  %66 = getelementptr inbounds double, ptr %17, i64 %47
  store double %65, ptr %66, align 8
  %67 = getelementptr inbounds double, ptr %19, i64 %47
  %68 = load double, ptr %67, align 8
  %69 = select i1 %28, double %68, double 0.000000e+00
  store double %69, ptr %67, align 8
  %70 = getelementptr inbounds double, ptr %15, i64 %47
  store double %64, ptr %70, align 8
  %71 = getelementptr inbounds double, ptr %13, i64 %47
  %72 = load double, ptr %71, align 8
  %73 = fmul double %64, %72
  store double %73, ptr %71, align 8
  br i1 %29, label %77, label %74

74:                                               ; preds = %77, %59
  %75 = add nuw nsw i64 %47, 1
  %76 = icmp eq i64 %75, %6
  br i1 %76, label %35, label %46, !llvm.loop !38

77:                                               ; preds = %59, %77
  %78 = phi i64 [ %82, %77 ], [ 0, %59 ]
  %79 = getelementptr inbounds double, ptr %49, i64 %78
  %80 = load double, ptr %79, align 8
  %81 = fmul double %64, %80
  store double %81, ptr %79, align 8
  %82 = add nuw nsw i64 %78, 1
  %83 = icmp eq i64 %82, %8
  br i1 %83, label %74, label %77, !llvm.loop !39

84:                                               ; preds = %215, %37
  %85 = phi i32 [ %22, %37 ], [ %93, %215 ]
  %86 = phi double [ 0.000000e+00, %37 ], [ %216, %215 ]
  %87 = phi i64 [ 0, %37 ], [ %217, %215 ]
  br i1 %38, label %95, label %88

88:                                               ; preds = %128, %84
  %89 = phi double [ 0x3BC79CA10C924224, %84 ], [ %129, %128 ]
  %90 = phi double [ -1.000000e+00, %84 ], [ %130, %128 ]
  %91 = fcmp oge double %90, 0.000000e+00
  %92 = and i32 %85, 1
  %93 = select i1 %91, i32 %92, i32 0
  %94 = icmp eq i32 %93, 0
  br i1 %94, label %215, label %133

95:                                               ; preds = %84, %128
  %96 = phi double [ %130, %128 ], [ -1.000000e+00, %84 ]
  %97 = phi double [ %129, %128 ], [ 0x3BC79CA10C924224, %84 ]
  %98 = phi i64 [ %131, %128 ], [ 0, %84 ]
  %99 = phi i32 [ %103, %128 ], [ %85, %84 ]
  %100 = icmp eq i64 %98, %2
  %101 = fcmp ole double %97, 1.000000e-04
  %102 = select i1 %101, i32 %99, i32 0
  %103 = select i1 %100, i32 %102, i32 %99
  %104 = getelementptr inbounds double, ptr %19, i64 %98
  %105 = load double, ptr %104, align 8
  %106 = fcmp une double %105, 0.000000e+00
  %107 = and i32 %103, 1
  %108 = icmp eq i32 %107, 0
  %109 = select i1 %106, i1 true, i1 %108
  br i1 %109, label %128, label %110

110:                                              ; preds = %95
  %111 = mul nsw i64 %98, %8
  %112 = getelementptr inbounds double, ptr %9, i64 %111
  br i1 %39, label %113, label %122

113:                                              ; preds = %110, %113
  %114 = phi i64 [ %120, %113 ], [ 0, %110 ]
  %115 = phi double [ %119, %113 ], [ 0.000000e+00, %110 ]
  %116 = getelementptr inbounds double, ptr %112, i64 %114
  %117 = load double, ptr %116, align 8
  %118 = fmul double %117, %117
  %119 = fadd double %115, %118
  %120 = add nuw nsw i64 %114, 1
  %121 = icmp eq i64 %120, %8
  br i1 %121, label %122, label %113, !llvm.loop !25

122:                                              ; preds = %113, %110
  %123 = phi double [ 0.000000e+00, %110 ], [ %119, %113 ]
  %124 = fcmp ule double %123, %97
  %125 = uitofp nneg i64 %98 to double
  %126 = select i1 %124, double %96, double %125
  %127 = select i1 %124, double %97, double %123
  br label %128

128:                                              ; preds = %122, %95
  %129 = phi double [ %127, %122 ], [ %97, %95 ]
  %130 = phi double [ %126, %122 ], [ %96, %95 ]
  %131 = add nuw nsw i64 %98, 1
  %132 = icmp eq i64 %131, %6
  br i1 %132, label %88, label %95, !llvm.loop !40

133:                                              ; preds = %88
  %134 = fadd double %86, 1.000000e+00
  %135 = tail call double @llvm.sqrt.f64(double %89)
  br i1 %40, label %138, label %136

136:                                              ; preds = %162, %133
  %137 = phi double [ 0.000000e+00, %133 ], [ %163, %162 ]
  br i1 %42, label %167, label %166

138:                                              ; preds = %133, %162
  %139 = phi i64 [ %164, %162 ], [ 0, %133 ]
  %140 = phi double [ %163, %162 ], [ 0.000000e+00, %133 ]
  %141 = uitofp nneg i64 %139 to double
  %142 = fcmp une double %90, %141
  br i1 %142, label %162, label %143

143:                                              ; preds = %138
  %144 = getelementptr inbounds double, ptr %13, i64 %139
  %145 = load double, ptr %144, align 8
  %146 = fdiv double %145, %135
  store double 0.000000e+00, ptr %144, align 8
  %147 = getelementptr inbounds double, ptr %17, i64 %139
  %148 = load double, ptr %147, align 8
  %149 = fmul double %135, %148
  %150 = getelementptr inbounds double, ptr %19, i64 %139
  store double %149, ptr %150, align 8
  br i1 %41, label %151, label %162

151:                                              ; preds = %143
  %152 = mul nuw nsw i64 %139, %8
  %153 = getelementptr double, ptr %9, i64 %152
  br label %154

154:                                              ; preds = %151, %154
  %155 = phi i64 [ 0, %151 ], [ %160, %154 ]
  %156 = getelementptr double, ptr %153, i64 %155
  %157 = load double, ptr %156, align 8
  %158 = fdiv double %157, %135
  %159 = getelementptr inbounds double, ptr %21, i64 %155
  store double %158, ptr %159, align 8
  %160 = add nuw nsw i64 %155, 1
  %161 = icmp eq i64 %160, %8
  br i1 %161, label %162, label %154, !llvm.loop !41

162:                                              ; preds = %154, %143, %138
  %163 = phi double [ %140, %138 ], [ %146, %143 ], [ %146, %154 ]
  %164 = add nuw nsw i64 %139, 1
  %165 = icmp eq i64 %164, %6
  br i1 %165, label %136, label %138, !llvm.loop !42

166:                                              ; preds = %167, %136
  br i1 %43, label %177, label %215

167:                                              ; preds = %136, %167
  %168 = phi i64 [ %175, %167 ], [ 0, %136 ]
  %169 = getelementptr inbounds double, ptr %11, i64 %168
  %170 = load double, ptr %169, align 8
  %171 = getelementptr inbounds double, ptr %21, i64 %168
  %172 = load double, ptr %171, align 8
  %173 = fmul double %137, %172
  %174 = fadd double %170, %173
  store double %174, ptr %169, align 8
  %175 = add nuw nsw i64 %168, 1
  %176 = icmp eq i64 %175, %8
  br i1 %176, label %166, label %167, !llvm.loop !43

177:                                              ; preds = %166, %212
  %178 = phi i64 [ %213, %212 ], [ 0, %166 ]
  %179 = mul nsw i64 %178, %8
  %180 = getelementptr inbounds double, ptr %9, i64 %179
  %181 = getelementptr inbounds double, ptr %19, i64 %178
  %182 = load double, ptr %181, align 8
  %183 = fcmp une double %182, 0.000000e+00
  br i1 %183, label %212, label %184

184:                                              ; preds = %177
  br i1 %44, label %185, label %196

185:                                              ; preds = %184, %185
  %186 = phi i64 [ %194, %185 ], [ 0, %184 ]
  %187 = phi double [ %193, %185 ], [ 0.000000e+00, %184 ]
  %188 = getelementptr inbounds double, ptr %180, i64 %186
  %189 = load double, ptr %188, align 8
  %190 = getelementptr inbounds double, ptr %21, i64 %186
  %191 = load double, ptr %190, align 8
  %192 = fmul double %189, %191
  %193 = fadd double %187, %192
  %194 = add nuw nsw i64 %186, 1
  %195 = icmp eq i64 %194, %8
  br i1 %195, label %196, label %185, !llvm.loop !25

196:                                              ; preds = %185, %184
  %197 = phi double [ 0.000000e+00, %184 ], [ %193, %185 ]
  %198 = getelementptr inbounds double, ptr %13, i64 %178
  %199 = load double, ptr %198, align 8
  %200 = fmul double %137, %197
  %201 = fsub double %199, %200
  store double %201, ptr %198, align 8
  br i1 %45, label %202, label %212

202:                                              ; preds = %196, %202
  %203 = phi i64 [ %210, %202 ], [ 0, %196 ]
  %204 = getelementptr inbounds double, ptr %180, i64 %203
  %205 = load double, ptr %204, align 8
  %206 = getelementptr inbounds double, ptr %21, i64 %203
  %207 = load double, ptr %206, align 8
  %208 = fmul double %197, %207
  %209 = fsub double %205, %208
  store double %209, ptr %204, align 8
  %210 = add nuw nsw i64 %203, 1
  %211 = icmp eq i64 %210, %8
  br i1 %211, label %212, label %202, !llvm.loop !44

212:                                              ; preds = %202, %196, %177
  %213 = add nuw nsw i64 %178, 1
  %214 = icmp eq i64 %213, %6
  br i1 %214, label %215, label %177, !llvm.loop !45

215:                                              ; preds = %212, %166, %88
  %216 = phi double [ %86, %88 ], [ %134, %166 ], [ %134, %212 ]
  %217 = add nuw nsw i64 %87, 1
  %218 = icmp eq i64 %217, %2
  %219 = select i1 %94, i1 true, i1 %218
  br i1 %219, label %220, label %84, !llvm.loop !46

220:                                              ; preds = %215, %35
  %221 = phi double [ 0.000000e+00, %35 ], [ %216, %215 ]
  %222 = icmp sgt i64 %6, %2
  %223 = select i1 %222, i64 %2, i64 -1
  %224 = sitofp i64 %223 to double
  %225 = fcmp une double %221, %224
  %226 = icmp sgt i64 %6, 0
  br i1 %226, label %228, label %227

227:                                              ; preds = %228, %220
  ret void

228:                                              ; preds = %220, %228
  %229 = phi i64 [ %236, %228 ], [ 0, %220 ]
  %230 = getelementptr inbounds double, ptr %13, i64 %229
  %231 = load double, ptr %230, align 8
  %232 = getelementptr inbounds double, ptr %15, i64 %229
  %233 = load double, ptr %232, align 8
  %234 = fdiv double %231, %233
  %235 = select i1 %225, double %234, double 0.000000e+00
  store double %235, ptr %230, align 8
  %236 = add nuw nsw i64 %229, 1
  %237 = icmp eq i64 %236, %6
  br i1 %237, label %227, label %228, !llvm.loop !47
}

declare double @llvm.sqrt.f64(double) #3

define internal fastcc void @divide_transposed(ptr noundef readonly %0, i64 noundef %1, ptr noundef %2) unnamed_addr #4 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %5, label %7

5:                                                ; preds = %3
  %6 = add nuw i64 %1, 1
  br label %8

7:                                                ; preds = %15, %3
  ret void

8:                                                ; preds = %5, %15
  %9 = phi i64 [ %1, %5 ], [ %10, %15 ]
  %10 = add nsw i64 %9, -1
  %11 = getelementptr inbounds double, ptr %2, i64 %10
  %12 = load double, ptr %11, align 8
  %13 = getelementptr double, ptr %0, i64 %10
  %14 = icmp slt i64 %9, %1
  br i1 %14, label %22, label %15

15:                                               ; preds = %22, %8
  %16 = phi double [ %12, %8 ], [ %31, %22 ]
  %17 = mul i64 %10, %6
  %18 = getelementptr inbounds double, ptr %0, i64 %17
  %19 = load double, ptr %18, align 8
  %20 = fdiv double %16, %19
  store double %20, ptr %11, align 8
  %21 = icmp sgt i64 %9, 1
  br i1 %21, label %8, label %7, !llvm.loop !48

22:                                               ; preds = %8, %22
  %23 = phi i64 [ %32, %22 ], [ %9, %8 ]
  %24 = phi double [ %31, %22 ], [ %12, %8 ]
  %25 = mul nsw i64 %23, %1
  %26 = getelementptr double, ptr %13, i64 %25
  %27 = load double, ptr %26, align 8
  %28 = getelementptr inbounds double, ptr %2, i64 %23
  %29 = load double, ptr %28, align 8
  %30 = fmul double %27, %29
  %31 = fsub double %24, %30
  %32 = add nuw nsw i64 %23, 1
  %33 = icmp eq i64 %32, %1
  br i1 %33, label %15, label %22, !llvm.loop !49
}

define internal fastcc void @factorise(ptr noundef %0, i64 noundef %1) unnamed_addr #4 {
  %3 = icmp sgt i64 %1, 0
  br i1 %3, label %4, label %13

4:                                                ; preds = %2
  %5 = sitofp i64 %1 to double
  %6 = fmul double %5, 4.000000e+00
  %7 = fmul double %6, 0x3CB0000000000000
  br label %17

8:                                                ; preds = %53, %26
  %9 = icmp slt i64 %31, %1
  %10 = select i1 %9, i1 %29, i1 false
  br i1 %10, label %17, label %11, !llvm.loop !50

11:                                               ; preds = %8
  %12 = xor i1 %29, true
  br label %13

13:                                               ; preds = %11, %2
  %14 = phi i1 [ false, %2 ], [ %12, %11 ]
  %15 = icmp sgt i64 %1, 0
  %16 = and i1 %14, %15
  br i1 %16, label %69, label %83

17:                                               ; preds = %4, %8
  %18 = phi i64 [ 0, %4 ], [ %31, %8 ]
  %19 = mul nuw nsw i64 %18, %1
  %20 = getelementptr double, ptr %0, i64 %19
  %21 = getelementptr double, ptr %20, i64 %18
  %22 = load double, ptr %21, align 8
  %23 = icmp eq i64 %18, 0
  br i1 %23, label %26, label %24

24:                                               ; preds = %17
  %25 = getelementptr double, ptr %0, i64 %19
  br label %37

26:                                               ; preds = %37, %17
  %27 = phi double [ %22, %17 ], [ %43, %37 ]
  %28 = fmul double %7, %22
  %29 = fcmp ogt double %27, %28
  %30 = tail call double @llvm.sqrt.f64(double %27)
  store double %30, ptr %21, align 8
  %31 = add nuw nsw i64 %18, 1
  %32 = getelementptr double, ptr %0, i64 %18
  %33 = icmp slt i64 %31, %1
  br i1 %33, label %34, label %8

34:                                               ; preds = %26
  %35 = icmp eq i64 %18, 0
  %36 = getelementptr double, ptr %0, i64 %19
  br label %46

37:                                               ; preds = %24, %37
  %38 = phi i64 [ 0, %24 ], [ %44, %37 ]
  %39 = phi double [ %22, %24 ], [ %43, %37 ]
  %40 = getelementptr double, ptr %25, i64 %38
  %41 = load double, ptr %40, align 8
  %42 = fmul double %41, %41
  %43 = fsub double %39, %42
  %44 = add nuw nsw i64 %38, 1
  %45 = icmp eq i64 %44, %18
  br i1 %45, label %26, label %37, !llvm.loop !51

46:                                               ; preds = %34, %53
  %47 = phi i64 [ %31, %34 ], [ %56, %53 ]
  %48 = mul nuw nsw i64 %47, %1
  %49 = getelementptr double, ptr %32, i64 %48
  %50 = load double, ptr %49, align 8
  br i1 %35, label %53, label %51

51:                                               ; preds = %46
  %52 = getelementptr double, ptr %0, i64 %48
  br label %58

53:                                               ; preds = %58, %46
  %54 = phi double [ %50, %46 ], [ %66, %58 ]
  %55 = fdiv double %54, %30
  store double %55, ptr %49, align 8
  %56 = add nuw nsw i64 %47, 1
  %57 = icmp slt i64 %56, %1
  br i1 %57, label %46, label %8, !llvm.loop !52

58:                                               ; preds = %51, %58
  %59 = phi i64 [ 0, %51 ], [ %67, %58 ]
  %60 = phi double [ %50, %51 ], [ %66, %58 ]
  %61 = getelementptr double, ptr %52, i64 %59
  %62 = load double, ptr %61, align 8
  %63 = getelementptr double, ptr %36, i64 %59
  %64 = load double, ptr %63, align 8
  %65 = fmul double %62, %64
  %66 = fsub double %60, %65
  %67 = add nuw nsw i64 %59, 1
  %68 = icmp eq i64 %67, %18
  br i1 %68, label %53, label %58, !llvm.loop !53

69:                                               ; preds = %13, %73
  %70 = phi i64 [ %74, %73 ], [ 0, %13 ]
  %71 = mul nuw nsw i64 %70, %1
  %72 = getelementptr double, ptr %0, i64 %71
  br label %76

73:                                               ; preds = %76
  %74 = add nuw nsw i64 %70, 1
  %75 = icmp eq i64 %74, %1
  br i1 %75, label %83, label %69, !llvm.loop !6

76:                                               ; preds = %69, %76
  %77 = phi i64 [ 0, %69 ], [ %81, %76 ]
  %78 = icmp eq i64 %70, %77
  %79 = select i1 %78, double 1.000000e+00, double 0.000000e+00
  %80 = getelementptr double, ptr %72, i64 %77
  store double %79, ptr %80, align 8
  %81 = add nuw nsw i64 %77, 1
  %82 = icmp eq i64 %81, %1
  br i1 %82, label %73, label %76, !llvm.loop !9

83:                                               ; preds = %73, %13
  ret void
}

declare void @llvm.experimental.noalias.scope.decl(metadata) #5

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { nounwind willreturn memory(none) }
attributes #4 = { noinline nounwind }
attributes #5 = { nounwind willreturn }
attributes #6 = { nounwind }
attributes #7 = { nounwind }
attributes #8 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = !{!4}
!4 = distinct !{!4, !5, !"held_by: argument 0"}
!5 = distinct !{!5, !"held_by"}
!6 = distinct !{!6, !7, !8}
!7 = !{!"llvm.loop.mustprogress"}
!8 = !{!"llvm.loop.unroll.disable"}
!9 = distinct !{!9, !7, !8}
!10 = distinct !{!10, !7, !8}
!11 = distinct !{!11, !8}
!12 = distinct !{!12, !7, !8}
!13 = distinct !{!13, !7, !8}
!14 = distinct !{!14, !7, !8}
!15 = distinct !{!15, !7, !8}
!16 = distinct !{!16, !7, !8}
!17 = distinct !{!17, !7, !8}
!18 = distinct !{!18, !7, !8}
!19 = distinct !{!19, !7, !8}
!20 = distinct !{!20, !7, !8}
!21 = distinct !{!21, !7, !8}
!22 = distinct !{!22, !7, !8}
!23 = distinct !{!23, !7, !8}
!24 = distinct !{!24, !7, !8}
!25 = distinct !{!25, !7, !8}
!26 = distinct !{!26, !7, !8}
!27 = distinct !{!27, !7, !8}
!28 = distinct !{!28, !7, !8}
!29 = distinct !{!29, !7, !8}
!30 = distinct !{!30, !7, !8}
!31 = distinct !{!31, !7, !8}
!32 = distinct !{!32, !7, !8}
!33 = distinct !{!33, !7, !8}
!34 = distinct !{!34, !7, !8}
!35 = distinct !{!35, !7, !8}
!36 = distinct !{!36, !7, !8}
!37 = distinct !{!37, !7, !8}
!38 = distinct !{!38, !7, !8}
!39 = distinct !{!39, !7, !8}
!40 = distinct !{!40, !7, !8}
!41 = distinct !{!41, !7, !8}
!42 = distinct !{!42, !7, !8}
!43 = distinct !{!43, !7, !8}
!44 = distinct !{!44, !7, !8}
!45 = distinct !{!45, !7, !8}
!46 = distinct !{!46, !7, !8}
!47 = distinct !{!47, !7, !8}
!48 = distinct !{!48, !7, !8}
!49 = distinct !{!49, !7, !8}
!50 = distinct !{!50, !7, !8}
!51 = distinct !{!51, !7, !8}
!52 = distinct !{!52, !7, !8}
!53 = distinct !{!53, !7, !8}
