; sources aa04c80c0f8c52b93d5658847aa552989fc82eec3441b7d3b55ee3b1d3b67199
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define i64 @extend(ptr noundef %0, ptr noundef readonly %1) #0 {
  %3 = getelementptr inbounds i8, ptr %0, i64 144
  %4 = getelementptr inbounds i8, ptr %0, i64 360
  %5 = load ptr, ptr %3, align 8
  %6 = getelementptr inbounds i8, ptr %5, i64 8
  %7 = load i64, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %1, i64 16
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %1, i64 32
  %11 = load i64, ptr %10, align 8
  %12 = icmp sgt i64 %11, 0
  br i1 %12, label %13, label %567

13:                                               ; preds = %2
  %14 = getelementptr inbounds i8, ptr %1, i64 24
  %15 = getelementptr inbounds i8, ptr %1, i64 48
  %16 = getelementptr inbounds i8, ptr %1, i64 72
  %17 = getelementptr inbounds i8, ptr %0, i64 368
  %18 = getelementptr inbounds i8, ptr %0, i64 648
  %19 = getelementptr inbounds i8, ptr %0, i64 312
  %20 = getelementptr inbounds i8, ptr %0, i64 320
  %21 = getelementptr inbounds i8, ptr %0, i64 336
  %22 = getelementptr inbounds i8, ptr %0, i64 528
  %23 = getelementptr inbounds i8, ptr %0, i64 168
  %24 = getelementptr inbounds i8, ptr %0, i64 248
  %25 = getelementptr inbounds i8, ptr %0, i64 192
  %26 = getelementptr inbounds i8, ptr %0, i64 216
  %27 = getelementptr inbounds i8, ptr %0, i64 432
  %28 = getelementptr inbounds i8, ptr %0, i64 408
  %29 = getelementptr inbounds i8, ptr %0, i64 24
  %30 = getelementptr inbounds i8, ptr %0, i64 528
  %31 = getelementptr inbounds i8, ptr %0, i64 48
  %32 = getelementptr inbounds i8, ptr %0, i64 72
  %33 = getelementptr inbounds i8, ptr %0, i64 368
  %34 = getelementptr inbounds i8, ptr %0, i64 96
  %35 = getelementptr inbounds i8, ptr %0, i64 384
  %36 = getelementptr inbounds i8, ptr %0, i64 24
  %37 = getelementptr inbounds i8, ptr %0, i64 528
  %38 = getelementptr inbounds i8, ptr %0, i64 48
  %39 = getelementptr inbounds i8, ptr %0, i64 72
  %40 = getelementptr inbounds i8, ptr %0, i64 384
  %41 = getelementptr inbounds i8, ptr %0, i64 384
  %42 = getelementptr inbounds i8, ptr %0, i64 368
  %43 = getelementptr inbounds i8, ptr %0, i64 528
  %44 = getelementptr inbounds i8, ptr %0, i64 552
  %45 = getelementptr inbounds i8, ptr %0, i64 408
  %46 = getelementptr inbounds i8, ptr %0, i64 24
  %47 = getelementptr inbounds i8, ptr %0, i64 432
  %48 = getelementptr inbounds i8, ptr %0, i64 48
  %49 = getelementptr inbounds i8, ptr %0, i64 72
  %50 = getelementptr inbounds i8, ptr %0, i64 96
  %51 = getelementptr inbounds i8, ptr %0, i64 384
  %52 = getelementptr inbounds i8, ptr %0, i64 480
  %53 = getelementptr inbounds i8, ptr %0, i64 24
  %54 = getelementptr inbounds i8, ptr %0, i64 432
  %55 = getelementptr inbounds i8, ptr %0, i64 48
  %56 = getelementptr inbounds i8, ptr %0, i64 72
  %57 = getelementptr inbounds i8, ptr %0, i64 552
  %58 = getelementptr inbounds i8, ptr %0, i64 456
  %59 = getelementptr inbounds i8, ptr %0, i64 552
  %60 = getelementptr inbounds i8, ptr %0, i64 368
  %61 = getelementptr inbounds i8, ptr %0, i64 696
  %62 = icmp sgt i64 %7, 0
  br label %63

63:                                               ; preds = %13, %563
  %64 = phi i64 [ undef, %13 ], [ %562, %563 ]
  %65 = phi i64 [ -1, %13 ], [ %561, %563 ]
  %66 = phi i64 [ 0, %13 ], [ %564, %563 ]
  %67 = load ptr, ptr %15, align 8
  %68 = getelementptr inbounds i64, ptr %67, i64 %66
  %69 = load i64, ptr %68, align 8
  %70 = load ptr, ptr %1, align 8
  %71 = mul nsw i64 %69, %9
  %72 = getelementptr inbounds double, ptr %70, i64 %71
  %73 = load ptr, ptr %14, align 8
  %74 = getelementptr inbounds double, ptr %73, i64 %66
  %75 = load double, ptr %74, align 8
  %76 = load ptr, ptr %16, align 8
  %77 = mul nsw i64 %66, %7
  %78 = getelementptr inbounds double, ptr %76, i64 %77
  %79 = getelementptr inbounds i8, ptr %72, i64 8
  %80 = load double, ptr %79, align 8
  %81 = fcmp oeq double %80, 0.000000e+00
  br i1 %81, label %82, label %91

82:                                               ; preds = %63
  %83 = getelementptr inbounds i8, ptr %72, i64 16
  br i1 %62, label %84, label %559

84:                                               ; preds = %82, %84
  %85 = phi i64 [ %89, %84 ], [ 0, %82 ]
  %86 = getelementptr inbounds double, ptr %83, i64 %85
  %87 = load double, ptr %86, align 8
  %88 = getelementptr inbounds double, ptr %78, i64 %85
  store double %87, ptr %88, align 8
  %89 = add nuw nsw i64 %85, 1
  %90 = icmp eq i64 %89, %7
  br i1 %90, label %559, label %84, !llvm.loop !3

91:                                               ; preds = %63
  %92 = icmp eq i64 %69, %65
  br i1 %92, label %529, label %93

93:                                               ; preds = %91
  %94 = getelementptr inbounds double, ptr %72, i64 %9
  %95 = load ptr, ptr %3, align 8
  %96 = getelementptr inbounds i8, ptr %95, i64 8
  %97 = load i64, ptr %96, align 8
  %98 = load i64, ptr %17, align 8
  %99 = load ptr, ptr %0, align 8
  %100 = load i64, ptr %99, align 8
  %101 = load double, ptr %72, align 8
  %102 = load ptr, ptr %18, align 8
  %103 = getelementptr inbounds i8, ptr %102, i64 24
  %104 = getelementptr inbounds i8, ptr %72, i64 16
  %105 = icmp sgt i64 %97, 0
  br i1 %105, label %116, label %106

106:                                              ; preds = %116, %93
  %107 = icmp eq i64 %100, 0
  br i1 %107, label %108, label %146

108:                                              ; preds = %106
  %109 = load ptr, ptr %0, align 8
  %110 = getelementptr inbounds i8, ptr %109, i64 24
  %111 = load i64, ptr %110, align 8
  %112 = icmp sgt i64 %111, 0
  br i1 %112, label %113, label %525

113:                                              ; preds = %108
  %114 = getelementptr i8, ptr %72, i64 16
  %115 = icmp sgt i64 %97, 0
  br label %124

116:                                              ; preds = %93, %116
  %117 = phi i64 [ %122, %116 ], [ 0, %93 ]
  %118 = getelementptr inbounds double, ptr %104, i64 %117
  %119 = load double, ptr %118, align 8
  %120 = load ptr, ptr %4, align 8
  %121 = getelementptr inbounds double, ptr %120, i64 %117
  store double %119, ptr %121, align 8
  %122 = add nuw nsw i64 %117, 1
  %123 = icmp eq i64 %122, %97
  br i1 %123, label %106, label %116, !llvm.loop !6

124:                                              ; preds = %113, %131
  %125 = phi i64 [ 0, %113 ], [ %132, %131 ]
  br i1 %115, label %126, label %131

126:                                              ; preds = %124
  %127 = add nuw nsw i64 %125, 1
  %128 = mul nuw nsw i64 %127, %97
  %129 = getelementptr double, ptr %114, i64 %128
  %130 = mul nsw i64 %125, %98
  br label %137

131:                                              ; preds = %137, %124
  %132 = add nuw nsw i64 %125, 1
  %133 = load ptr, ptr %0, align 8
  %134 = getelementptr inbounds i8, ptr %133, i64 24
  %135 = load i64, ptr %134, align 8
  %136 = icmp slt i64 %132, %135
  br i1 %136, label %124, label %525, !llvm.loop !7

137:                                              ; preds = %126, %137
  %138 = phi i64 [ 0, %126 ], [ %144, %137 ]
  %139 = getelementptr double, ptr %129, i64 %138
  %140 = load double, ptr %139, align 8
  %141 = load ptr, ptr %57, align 8
  %142 = getelementptr double, ptr %141, i64 %130
  %143 = getelementptr double, ptr %142, i64 %138
  store double %140, ptr %143, align 8
  %144 = add nuw nsw i64 %138, 1
  %145 = icmp eq i64 %144, %97
  br i1 %145, label %131, label %137, !llvm.loop !8

146:                                              ; preds = %106
  %147 = load ptr, ptr %19, align 8
  %148 = load i64, ptr %20, align 8
  %149 = icmp eq i64 %148, 0
  br i1 %149, label %176, label %150

150:                                              ; preds = %146
  %151 = icmp sgt i64 %148, 0
  br i1 %151, label %152, label %165

152:                                              ; preds = %150, %152
  %153 = phi i64 [ %163, %152 ], [ %148, %150 ]
  %154 = phi i64 [ %162, %152 ], [ 0, %150 ]
  %155 = add nuw nsw i64 %153, %154
  %156 = lshr i64 %155, 1
  %157 = and i64 %155, -2
  %158 = getelementptr inbounds double, ptr %147, i64 %157
  %159 = load double, ptr %158, align 8
  %160 = fcmp ogt double %159, %101
  %161 = add nuw nsw i64 %156, 1
  %162 = select i1 %160, i64 %154, i64 %161
  %163 = select i1 %160, i64 %156, i64 %153
  %164 = icmp slt i64 %162, %163
  br i1 %164, label %152, label %165, !llvm.loop !9

165:                                              ; preds = %152, %150
  %166 = phi i64 [ 0, %150 ], [ %162, %152 ]
  %167 = icmp slt i64 %166, %148
  br i1 %167, label %168, label %173

168:                                              ; preds = %165
  %169 = shl nuw nsw i64 %166, 1
  %170 = or disjoint i64 %169, 1
  %171 = getelementptr inbounds double, ptr %147, i64 %170
  %172 = load double, ptr %171, align 8
  br label %173

173:                                              ; preds = %168, %165
  %174 = phi double [ %172, %168 ], [ 0x7FF0000000000000, %165 ]
  %175 = load ptr, ptr %21, align 8
  store double %174, ptr %175, align 8
  br label %176

176:                                              ; preds = %173, %146
  %177 = load ptr, ptr %4, align 8
  %178 = load ptr, ptr %22, align 8
  %179 = load ptr, ptr %23, align 8
  store double %101, ptr %179, align 8
  %180 = load i64, ptr %24, align 8
  %181 = icmp sgt i64 %180, 0
  br i1 %181, label %182, label %183

182:                                              ; preds = %176
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %183

183:                                              ; preds = %176, %182
  %184 = load ptr, ptr %3, align 8
  %185 = load i64, ptr %184, align 8
  %186 = load ptr, ptr %23, align 8
  %187 = load ptr, ptr %25, align 8
  %188 = load ptr, ptr %26, align 8
  %189 = inttoptr i64 %185 to ptr
  %190 = load ptr, ptr %189, align 8
  %191 = tail call i32 %190(ptr noundef %186, ptr noundef %177, ptr noundef %187, ptr noundef %188, ptr noundef %178) #6
  %192 = sext i32 %191 to i64
  %193 = icmp eq i32 %191, 0
  br i1 %193, label %194, label %347

194:                                              ; preds = %183
  %195 = load ptr, ptr %0, align 8
  %196 = load i64, ptr %195, align 8
  %197 = load ptr, ptr %27, align 8
  %198 = insertelement <8 x double> poison, double %80, i64 0
  %199 = shufflevector <8 x double> %198, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %199, ptr %197, align 8
  %200 = icmp sgt i64 %196, 1
  br i1 %200, label %205, label %290

201:                                              ; preds = %278
  %202 = add nuw nsw i64 %208, 1
  %203 = icmp slt i64 %202, %196
  %204 = icmp eq i64 %202, %196
  br i1 %204, label %290, label %205, !llvm.loop !10

205:                                              ; preds = %194, %201
  %206 = phi i1 [ %203, %201 ], [ %200, %194 ]
  %207 = phi i64 [ %289, %201 ], [ undef, %194 ]
  %208 = phi i64 [ %202, %201 ], [ 1, %194 ]
  %209 = load ptr, ptr %28, align 8
  %210 = load ptr, ptr %4, align 8
  %211 = load ptr, ptr %3, align 8
  %212 = getelementptr inbounds i8, ptr %211, i64 16
  %213 = load i64, ptr %212, align 8
  %214 = icmp sgt i64 %213, 1
  %215 = zext i1 %214 to i64
  %216 = load ptr, ptr %29, align 8
  %217 = getelementptr inbounds i64, ptr %216, i64 %208
  %218 = load i64, ptr %217, align 8
  %219 = getelementptr i8, ptr %217, i64 8
  %220 = load i64, ptr %219, align 8
  %221 = xor i64 %218, -1
  %222 = add i64 %220, %221
  %223 = load ptr, ptr %27, align 8
  %224 = load ptr, ptr %30, align 8
  %225 = load ptr, ptr %31, align 8
  %226 = getelementptr inbounds i64, ptr %225, i64 %218
  %227 = load ptr, ptr %32, align 8
  %228 = getelementptr inbounds double, ptr %227, i64 %218
  tail call fastcc void @combine(ptr noundef %209, ptr noundef %210, ptr noundef %223, ptr noundef %224, ptr noundef %226, ptr noundef %228, i64 noundef %222, i64 noundef %215, i64 noundef %213) #5
  %229 = icmp eq i64 %213, 1
  br i1 %229, label %230, label %261

230:                                              ; preds = %205
  %231 = load ptr, ptr %29, align 8
  %232 = getelementptr i64, ptr %231, i64 %208
  %233 = getelementptr i8, ptr %232, i64 8
  %234 = load i64, ptr %233, align 8
  %235 = add nsw i64 %234, -1
  %236 = load ptr, ptr %32, align 8
  %237 = getelementptr inbounds double, ptr %236, i64 %235
  %238 = load double, ptr %237, align 8
  %239 = fmul double %80, %238
  %240 = load ptr, ptr %30, align 8
  %241 = load ptr, ptr %31, align 8
  %242 = getelementptr inbounds i64, ptr %241, i64 %235
  %243 = load i64, ptr %242, align 8
  %244 = getelementptr inbounds double, ptr %240, i64 %243
  %245 = load ptr, ptr %3, align 8
  %246 = getelementptr inbounds i8, ptr %245, i64 8
  %247 = load i64, ptr %246, align 8
  %248 = icmp sgt i64 %247, 0
  br i1 %248, label %249, label %261

249:                                              ; preds = %230, %249
  %250 = phi i64 [ %256, %249 ], [ 0, %230 ]
  %251 = getelementptr inbounds double, ptr %244, i64 %250
  %252 = load double, ptr %251, align 8
  %253 = getelementptr inbounds double, ptr %209, i64 %250
  %254 = load double, ptr %253, align 8
  %255 = tail call double @llvm.fma.f64(double %239, double %252, double %254)
  store double %255, ptr %253, align 8
  %256 = add nuw nsw i64 %250, 1
  %257 = load ptr, ptr %3, align 8
  %258 = getelementptr inbounds i8, ptr %257, i64 8
  %259 = load i64, ptr %258, align 8
  %260 = icmp slt i64 %256, %259
  br i1 %260, label %249, label %261, !llvm.loop !11

261:                                              ; preds = %249, %230, %205
  %262 = load ptr, ptr %30, align 8
  %263 = load i64, ptr %33, align 8
  %264 = mul nsw i64 %263, %208
  %265 = getelementptr inbounds double, ptr %262, i64 %264
  %266 = load i64, ptr %103, align 8
  %267 = add nsw i64 %266, 1
  store i64 %267, ptr %103, align 8
  %268 = load ptr, ptr %34, align 8
  %269 = getelementptr inbounds double, ptr %268, i64 %208
  %270 = load double, ptr %269, align 8
  %271 = fmul double %80, %270
  %272 = fadd double %101, %271
  %273 = load ptr, ptr %28, align 8
  %274 = load ptr, ptr %23, align 8
  store double %272, ptr %274, align 8
  %275 = load i64, ptr %24, align 8
  %276 = icmp sgt i64 %275, 0
  br i1 %276, label %277, label %278

277:                                              ; preds = %261
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %278

278:                                              ; preds = %261, %277
  %279 = load ptr, ptr %3, align 8
  %280 = load i64, ptr %279, align 8
  %281 = load ptr, ptr %23, align 8
  %282 = load ptr, ptr %25, align 8
  %283 = load ptr, ptr %26, align 8
  %284 = inttoptr i64 %280 to ptr
  %285 = load ptr, ptr %284, align 8
  %286 = tail call i32 %285(ptr noundef %281, ptr noundef %273, ptr noundef %282, ptr noundef %283, ptr noundef %265) #6
  %287 = sext i32 %286 to i64
  %288 = icmp eq i32 %286, 0
  %289 = select i1 %288, i64 %207, i64 %287
  br i1 %288, label %201, label %290

290:                                              ; preds = %201, %278, %194
  %291 = phi i1 [ %200, %194 ], [ %203, %201 ], [ %206, %278 ]
  %292 = phi i64 [ 0, %194 ], [ %287, %278 ], [ %287, %201 ]
  %293 = phi i64 [ undef, %194 ], [ %289, %278 ], [ %289, %201 ]
  br i1 %291, label %347, label %294

294:                                              ; preds = %290
  %295 = load ptr, ptr %35, align 8
  %296 = load ptr, ptr %4, align 8
  %297 = load ptr, ptr %3, align 8
  %298 = getelementptr inbounds i8, ptr %297, i64 16
  %299 = load i64, ptr %298, align 8
  %300 = icmp sgt i64 %299, 1
  %301 = zext i1 %300 to i64
  %302 = load ptr, ptr %36, align 8
  %303 = getelementptr inbounds i64, ptr %302, i64 %196
  %304 = load i64, ptr %303, align 8
  %305 = getelementptr i8, ptr %303, i64 8
  %306 = load i64, ptr %305, align 8
  %307 = xor i64 %304, -1
  %308 = add i64 %306, %307
  %309 = load ptr, ptr %27, align 8
  %310 = load ptr, ptr %37, align 8
  %311 = load ptr, ptr %38, align 8
  %312 = getelementptr inbounds i64, ptr %311, i64 %304
  %313 = load ptr, ptr %39, align 8
  %314 = getelementptr inbounds double, ptr %313, i64 %304
  tail call fastcc void @combine(ptr noundef %295, ptr noundef %296, ptr noundef %309, ptr noundef %310, ptr noundef %312, ptr noundef %314, i64 noundef %308, i64 noundef %301, i64 noundef %299) #5
  %315 = icmp eq i64 %299, 1
  br i1 %315, label %316, label %347

316:                                              ; preds = %294
  %317 = load ptr, ptr %36, align 8
  %318 = getelementptr i64, ptr %317, i64 %196
  %319 = getelementptr i8, ptr %318, i64 8
  %320 = load i64, ptr %319, align 8
  %321 = add nsw i64 %320, -1
  %322 = load ptr, ptr %39, align 8
  %323 = getelementptr inbounds double, ptr %322, i64 %321
  %324 = load double, ptr %323, align 8
  %325 = fmul double %80, %324
  %326 = load ptr, ptr %37, align 8
  %327 = load ptr, ptr %38, align 8
  %328 = getelementptr inbounds i64, ptr %327, i64 %321
  %329 = load i64, ptr %328, align 8
  %330 = getelementptr inbounds double, ptr %326, i64 %329
  %331 = load ptr, ptr %3, align 8
  %332 = getelementptr inbounds i8, ptr %331, i64 8
  %333 = load i64, ptr %332, align 8
  %334 = icmp sgt i64 %333, 0
  br i1 %334, label %335, label %347

335:                                              ; preds = %316, %335
  %336 = phi i64 [ %342, %335 ], [ 0, %316 ]
  %337 = getelementptr inbounds double, ptr %330, i64 %336
  %338 = load double, ptr %337, align 8
  %339 = getelementptr inbounds double, ptr %295, i64 %336
  %340 = load double, ptr %339, align 8
  %341 = tail call double @llvm.fma.f64(double %325, double %338, double %340)
  store double %341, ptr %339, align 8
  %342 = add nuw nsw i64 %336, 1
  %343 = load ptr, ptr %3, align 8
  %344 = getelementptr inbounds i8, ptr %343, i64 8
  %345 = load i64, ptr %344, align 8
  %346 = icmp slt i64 %342, %345
  br i1 %346, label %335, label %347, !llvm.loop !11

347:                                              ; preds = %335, %316, %290, %294, %183
  %348 = phi i64 [ %192, %183 ], [ %293, %290 ], [ %292, %294 ], [ %292, %316 ], [ %292, %335 ]
  %349 = icmp eq i64 %348, 0
  br i1 %349, label %350, label %525

350:                                              ; preds = %347
  %351 = getelementptr inbounds i8, ptr %94, i64 16
  %352 = icmp sgt i64 %97, 0
  br i1 %352, label %374, label %353

353:                                              ; preds = %374, %350
  %354 = load double, ptr %94, align 8
  %355 = load ptr, ptr %41, align 8
  %356 = load ptr, ptr %22, align 8
  %357 = mul nsw i64 %100, %98
  %358 = getelementptr inbounds double, ptr %356, i64 %357
  %359 = load ptr, ptr %23, align 8
  store double %354, ptr %359, align 8
  %360 = load i64, ptr %24, align 8
  %361 = icmp sgt i64 %360, 0
  br i1 %361, label %362, label %363

362:                                              ; preds = %353
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %363

363:                                              ; preds = %353, %362
  %364 = load ptr, ptr %3, align 8
  %365 = load i64, ptr %364, align 8
  %366 = load ptr, ptr %23, align 8
  %367 = load ptr, ptr %25, align 8
  %368 = load ptr, ptr %26, align 8
  %369 = inttoptr i64 %365 to ptr
  %370 = load ptr, ptr %369, align 8
  %371 = tail call i32 %370(ptr noundef %366, ptr noundef %355, ptr noundef %367, ptr noundef %368, ptr noundef %358) #6
  %372 = sext i32 %371 to i64
  %373 = icmp eq i32 %371, 0
  br i1 %373, label %382, label %525

374:                                              ; preds = %350, %374
  %375 = phi i64 [ %380, %374 ], [ 0, %350 ]
  %376 = getelementptr inbounds double, ptr %351, i64 %375
  %377 = load double, ptr %376, align 8
  %378 = load ptr, ptr %40, align 8
  %379 = getelementptr inbounds double, ptr %378, i64 %375
  store double %377, ptr %379, align 8
  %380 = add nuw nsw i64 %375, 1
  %381 = icmp eq i64 %380, %97
  br i1 %381, label %353, label %374, !llvm.loop !12

382:                                              ; preds = %363
  %383 = load ptr, ptr %0, align 8
  %384 = load ptr, ptr %3, align 8
  %385 = getelementptr inbounds i8, ptr %384, i64 16
  %386 = load i64, ptr %385, align 8
  %387 = load i64, ptr %383, align 8
  %388 = load i64, ptr %42, align 8
  %389 = load ptr, ptr %43, align 8
  %390 = mul nsw i64 %388, %387
  %391 = getelementptr inbounds double, ptr %389, i64 %390
  %392 = load ptr, ptr %44, align 8
  %393 = add nsw i64 %387, 1
  %394 = getelementptr inbounds i8, ptr %383, i64 16
  %395 = load i64, ptr %394, align 8
  %396 = icmp sgt i64 %395, 0
  br i1 %396, label %397, label %452

397:                                              ; preds = %382
  %398 = getelementptr inbounds i8, ptr %383, i64 8
  br label %404

399:                                              ; preds = %440
  %400 = add nsw i64 %407, 1
  %401 = load i64, ptr %394, align 8
  %402 = add nsw i64 %401, %393
  %403 = icmp slt i64 %400, %402
  br i1 %403, label %404, label %452, !llvm.loop !13

404:                                              ; preds = %397, %399
  %405 = phi i1 [ %396, %397 ], [ %403, %399 ]
  %406 = phi i64 [ undef, %397 ], [ %451, %399 ]
  %407 = phi i64 [ %393, %397 ], [ %400, %399 ]
  %408 = load i64, ptr %398, align 8
  %409 = load ptr, ptr %45, align 8
  %410 = load ptr, ptr %4, align 8
  %411 = load ptr, ptr %46, align 8
  %412 = getelementptr i64, ptr %411, i64 %407
  %413 = getelementptr i64, ptr %412, i64 %408
  %414 = load i64, ptr %413, align 8
  %415 = getelementptr i8, ptr %413, i64 8
  %416 = load i64, ptr %415, align 8
  %417 = xor i64 %414, -1
  %418 = add i64 %416, %417
  %419 = load ptr, ptr %47, align 8
  %420 = load ptr, ptr %43, align 8
  %421 = load ptr, ptr %48, align 8
  %422 = getelementptr inbounds i64, ptr %421, i64 %414
  %423 = load ptr, ptr %49, align 8
  %424 = getelementptr inbounds double, ptr %423, i64 %414
  tail call fastcc void @combine(ptr noundef %409, ptr noundef %410, ptr noundef %419, ptr noundef %420, ptr noundef %422, ptr noundef %424, i64 noundef %418, i64 noundef 1, i64 noundef %386) #5
  %425 = load ptr, ptr %43, align 8
  %426 = mul nsw i64 %407, %388
  %427 = getelementptr inbounds double, ptr %425, i64 %426
  %428 = load i64, ptr %103, align 8
  %429 = add nsw i64 %428, 1
  store i64 %429, ptr %103, align 8
  %430 = load ptr, ptr %50, align 8
  %431 = getelementptr inbounds double, ptr %430, i64 %407
  %432 = load double, ptr %431, align 8
  %433 = fmul double %80, %432
  %434 = fadd double %101, %433
  %435 = load ptr, ptr %45, align 8
  %436 = load ptr, ptr %23, align 8
  store double %434, ptr %436, align 8
  %437 = load i64, ptr %24, align 8
  %438 = icmp sgt i64 %437, 0
  br i1 %438, label %439, label %440

439:                                              ; preds = %404
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %440

440:                                              ; preds = %404, %439
  %441 = load ptr, ptr %3, align 8
  %442 = load i64, ptr %441, align 8
  %443 = load ptr, ptr %23, align 8
  %444 = load ptr, ptr %25, align 8
  %445 = load ptr, ptr %26, align 8
  %446 = inttoptr i64 %442 to ptr
  %447 = load ptr, ptr %446, align 8
  %448 = tail call i32 %447(ptr noundef %443, ptr noundef %435, ptr noundef %444, ptr noundef %445, ptr noundef %427) #6
  %449 = sext i32 %448 to i64
  %450 = icmp eq i32 %448, 0
  %451 = select i1 %450, i64 %406, i64 %449
  br i1 %450, label %399, label %452

452:                                              ; preds = %399, %440, %382
  %453 = phi i1 [ %396, %382 ], [ %403, %399 ], [ %405, %440 ]
  %454 = phi i64 [ 0, %382 ], [ %449, %440 ], [ %449, %399 ]
  %455 = phi i64 [ undef, %382 ], [ %451, %440 ], [ %451, %399 ]
  %456 = getelementptr inbounds i8, ptr %383, i64 16
  br i1 %453, label %525, label %457

457:                                              ; preds = %452
  %458 = load ptr, ptr %3, align 8
  %459 = getelementptr inbounds i8, ptr %458, i64 8
  %460 = load i64, ptr %459, align 8
  %461 = icmp sgt i64 %460, 0
  br i1 %461, label %462, label %466

462:                                              ; preds = %457
  %463 = getelementptr inbounds double, ptr %392, i64 %388
  %464 = shl nsw i64 %388, 4
  %465 = getelementptr inbounds i8, ptr %392, i64 %464
  br label %473

466:                                              ; preds = %473, %457
  %467 = getelementptr inbounds i8, ptr %383, i64 8
  %468 = load i64, ptr %467, align 8
  %469 = load i64, ptr %456, align 8
  %470 = getelementptr inbounds i8, ptr %383, i64 24
  %471 = load i64, ptr %470, align 8
  %472 = icmp sgt i64 %471, 3
  br i1 %472, label %500, label %525

473:                                              ; preds = %462, %473
  %474 = phi i64 [ 0, %462 ], [ %495, %473 ]
  %475 = load ptr, ptr %51, align 8
  %476 = getelementptr inbounds double, ptr %475, i64 %474
  %477 = load double, ptr %476, align 8
  %478 = load ptr, ptr %4, align 8
  %479 = getelementptr inbounds double, ptr %478, i64 %474
  %480 = load double, ptr %479, align 8
  %481 = fsub double %477, %480
  %482 = load ptr, ptr %43, align 8
  %483 = getelementptr inbounds double, ptr %482, i64 %474
  %484 = load double, ptr %483, align 8
  %485 = fmul double %80, %484
  %486 = fsub double %485, %481
  %487 = getelementptr inbounds double, ptr %392, i64 %474
  store double %481, ptr %487, align 8
  %488 = getelementptr inbounds double, ptr %463, i64 %474
  store double %486, ptr %488, align 8
  %489 = fsub double %481, %486
  %490 = getelementptr inbounds double, ptr %391, i64 %474
  %491 = load double, ptr %490, align 8
  %492 = fmul double %80, %491
  %493 = fsub double %489, %492
  %494 = getelementptr inbounds double, ptr %465, i64 %474
  store double %493, ptr %494, align 8
  %495 = add nuw nsw i64 %474, 1
  %496 = load ptr, ptr %3, align 8
  %497 = getelementptr inbounds i8, ptr %496, i64 8
  %498 = load i64, ptr %497, align 8
  %499 = icmp slt i64 %495, %498
  br i1 %499, label %473, label %466, !llvm.loop !14

500:                                              ; preds = %466, %500
  %501 = phi i64 [ %522, %500 ], [ 3, %466 ]
  %502 = mul nsw i64 %501, %388
  %503 = getelementptr inbounds double, ptr %392, i64 %502
  %504 = load ptr, ptr %52, align 8
  %505 = load ptr, ptr %53, align 8
  %506 = getelementptr i64, ptr %505, i64 %393
  %507 = getelementptr i64, ptr %506, i64 %468
  %508 = getelementptr i64, ptr %507, i64 %469
  %509 = getelementptr i64, ptr %508, i64 %501
  %510 = getelementptr i8, ptr %509, i64 -24
  %511 = load i64, ptr %510, align 8
  %512 = getelementptr i8, ptr %509, i64 -16
  %513 = load i64, ptr %512, align 8
  %514 = xor i64 %511, -1
  %515 = add i64 %513, %514
  %516 = load ptr, ptr %54, align 8
  %517 = load ptr, ptr %43, align 8
  %518 = load ptr, ptr %55, align 8
  %519 = getelementptr inbounds i64, ptr %518, i64 %511
  %520 = load ptr, ptr %56, align 8
  %521 = getelementptr inbounds double, ptr %520, i64 %511
  tail call fastcc void @combine(ptr noundef %503, ptr noundef %504, ptr noundef %516, ptr noundef %517, ptr noundef %519, ptr noundef %521, i64 noundef %515, i64 noundef 1, i64 noundef %386) #5
  %522 = add nuw nsw i64 %501, 1
  %523 = load i64, ptr %470, align 8
  %524 = icmp slt i64 %522, %523
  br i1 %524, label %500, label %525, !llvm.loop !15

525:                                              ; preds = %500, %131, %466, %108, %452, %347, %363
  %526 = phi i64 [ %348, %347 ], [ %372, %363 ], [ %455, %452 ], [ 0, %108 ], [ %454, %466 ], [ 0, %131 ], [ %454, %500 ]
  %527 = icmp eq i64 %526, 0
  %528 = select i1 %527, i64 %64, i64 %526
  br i1 %527, label %529, label %559

529:                                              ; preds = %525, %91
  %530 = phi i64 [ %69, %525 ], [ %65, %91 ]
  %531 = phi i64 [ %528, %525 ], [ %64, %91 ]
  %532 = load double, ptr %72, align 8
  %533 = fsub double %75, %532
  %534 = load double, ptr %79, align 8
  %535 = fdiv double %533, %534
  %536 = load ptr, ptr %58, align 8
  %537 = insertelement <8 x double> poison, double %535, i64 0
  %538 = shufflevector <8 x double> %537, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %538, ptr %536, align 8
  %539 = load ptr, ptr %4, align 8
  %540 = load ptr, ptr %59, align 8
  %541 = load i64, ptr %60, align 8
  %542 = load ptr, ptr %0, align 8
  %543 = getelementptr inbounds i8, ptr %542, i64 24
  %544 = load i64, ptr %543, align 8
  %545 = load ptr, ptr %58, align 8
  %546 = load ptr, ptr %3, align 8
  %547 = getelementptr inbounds i8, ptr %546, i64 16
  %548 = load i64, ptr %547, align 8
  tail call fastcc void @nested(ptr noundef %78, ptr noundef %539, ptr noundef %540, i64 noundef %541, i64 noundef %544, ptr noundef %545, i64 noundef %548) #5
  %549 = load ptr, ptr %61, align 8
  %550 = load i64, ptr %549, align 8
  %551 = icmp eq i64 %550, 1
  %552 = fcmp ogt double %535, 0.000000e+00
  %553 = and i1 %552, %551
  br i1 %553, label %554, label %559

554:                                              ; preds = %529
  %555 = getelementptr inbounds i8, ptr %549, i64 56
  %556 = load i64, ptr %555, align 8
  %557 = inttoptr i64 %556 to ptr
  %558 = tail call i64 %557(ptr noundef %0, double noundef %75, ptr noundef %78, ptr noundef null) #6
  br label %559

559:                                              ; preds = %84, %82, %529, %554, %525
  %560 = phi i32 [ 1, %525 ], [ 0, %554 ], [ 0, %529 ], [ 4, %82 ], [ 4, %84 ]
  %561 = phi i64 [ %69, %525 ], [ %530, %554 ], [ %530, %529 ], [ %65, %82 ], [ %65, %84 ]
  %562 = phi i64 [ %528, %525 ], [ %531, %554 ], [ %531, %529 ], [ %64, %82 ], [ %64, %84 ]
  switch i32 %560, label %567 [
    i32 0, label %563
    i32 4, label %563
  ]

563:                                              ; preds = %559, %559
  %564 = add nuw nsw i64 %66, 1
  %565 = load i64, ptr %10, align 8
  %566 = icmp slt i64 %564, %565
  br i1 %566, label %63, label %567, !llvm.loop !16

567:                                              ; preds = %559, %563, %2
  %568 = phi i64 [ 0, %2 ], [ %562, %559 ], [ 0, %563 ]
  ret i64 %568
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #1 {
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
  br i1 %60, label %49, label %61, !llvm.loop !17

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
  br i1 %88, label %14, label %13, !llvm.loop !18
}

declare double @llvm.fma.f64(double, double, double) #2

define internal fastcc void @combine(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, ptr noundef readonly %4, ptr noundef readonly %5, i64 noundef %6, i64 noundef %7, i64 noundef %8) unnamed_addr #3 {
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
  br i1 %53, label %54, label %28, !llvm.loop !19

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
  br i1 %98, label %72, label %99, !llvm.loop !20

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
  br i1 %108, label %16, label %22, !llvm.loop !21

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
  br i1 %133, label %114, label %120, !llvm.loop !19

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
  br i1 %148, label %134, label %149, !llvm.loop !20

149:                                              ; preds = %134, %114
  %150 = phi <8 x double> [ %118, %114 ], [ %146, %134 ]
  store <8 x double> %150, ptr %111, align 8
  %151 = add nuw nsw i64 %110, 8
  %152 = icmp slt i64 %151, %11
  br i1 %152, label %109, label %153, !llvm.loop !22

153:                                              ; preds = %149, %16
  ret void
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

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
  br i1 %31, label %20, label %19, !llvm.loop !23

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
  br i1 %43, label %32, label %24, !llvm.loop !24
}

attributes #0 = { nounwind }
attributes #1 = { noinline nounwind }
attributes #2 = { nounwind willreturn memory(none) }
attributes #3 = { noinline nounwind }
attributes #4 = { noinline nounwind }
attributes #5 = { nounwind }
attributes #6 = { nounwind }


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
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !4, !5}
!21 = distinct !{!21, !4, !5}
!22 = distinct !{!22, !4, !5}
!23 = distinct !{!23, !4, !5}
!24 = distinct !{!24, !4, !5}
