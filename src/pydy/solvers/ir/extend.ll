; sources 48857f7df7a623974a53dc3ad67baf5e5e3c2e9ac41622860f7181586fe8f5e0
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
  br i1 %12, label %13, label %593

13:                                               ; preds = %2
  %14 = getelementptr inbounds i8, ptr %1, i64 24
  %15 = getelementptr inbounds i8, ptr %1, i64 48
  %16 = getelementptr inbounds i8, ptr %1, i64 72
  %17 = getelementptr inbounds i8, ptr %0, i64 368
  %18 = getelementptr inbounds i8, ptr %0, i64 648
  %19 = getelementptr inbounds i8, ptr %0, i64 320
  %20 = getelementptr inbounds i8, ptr %0, i64 312
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

63:                                               ; preds = %13, %589
  %64 = phi i64 [ undef, %13 ], [ %588, %589 ]
  %65 = phi i64 [ -1, %13 ], [ %587, %589 ]
  %66 = phi i64 [ 0, %13 ], [ %590, %589 ]
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
  br i1 %62, label %84, label %585

84:                                               ; preds = %82, %84
  %85 = phi i64 [ %89, %84 ], [ 0, %82 ]
  %86 = getelementptr inbounds double, ptr %83, i64 %85
  %87 = load double, ptr %86, align 8
  %88 = getelementptr inbounds double, ptr %78, i64 %85
  store double %87, ptr %88, align 8
  %89 = add nuw nsw i64 %85, 1
  %90 = icmp eq i64 %89, %7
  br i1 %90, label %585, label %84, !llvm.loop !3

91:                                               ; preds = %63
  %92 = icmp eq i64 %69, %65
  br i1 %92, label %555, label %93

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
  br i1 %112, label %113, label %551

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
  br i1 %136, label %124, label %551, !llvm.loop !7

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
  %147 = load i64, ptr %19, align 8
  %148 = icmp eq i64 %147, 0
  br i1 %148, label %178, label %149

149:                                              ; preds = %146
  %150 = icmp sgt i64 %147, 0
  br i1 %150, label %151, label %166

151:                                              ; preds = %149
  %152 = load ptr, ptr %20, align 8
  br label %153

153:                                              ; preds = %151, %153
  %154 = phi i64 [ 0, %151 ], [ %164, %153 ]
  %155 = phi i64 [ %147, %151 ], [ %163, %153 ]
  %156 = add nuw nsw i64 %154, %155
  %157 = lshr i64 %156, 1
  %158 = mul i64 %157, 24
  %159 = getelementptr inbounds i8, ptr %152, i64 %158
  %160 = load double, ptr %159, align 8
  %161 = fcmp ogt double %160, %101
  %162 = add nuw nsw i64 %157, 1
  %163 = select i1 %161, i64 %157, i64 %155
  %164 = select i1 %161, i64 %154, i64 %162
  %165 = icmp slt i64 %164, %163
  br i1 %165, label %153, label %166, !llvm.loop !9

166:                                              ; preds = %153, %149
  %167 = phi i64 [ 0, %149 ], [ %164, %153 ]
  %168 = icmp slt i64 %167, %147
  br i1 %168, label %169, label %175

169:                                              ; preds = %166
  %170 = load ptr, ptr %20, align 8
  %171 = mul i64 %167, 24
  %172 = getelementptr inbounds i8, ptr %170, i64 %171
  %173 = getelementptr inbounds i8, ptr %172, i64 8
  %174 = load double, ptr %173, align 8
  br label %175

175:                                              ; preds = %169, %166
  %176 = phi double [ %174, %169 ], [ 0x7FF0000000000000, %166 ]
  %177 = load ptr, ptr %21, align 8
  store double %176, ptr %177, align 8
  br label %178

178:                                              ; preds = %175, %146
  %179 = load ptr, ptr %4, align 8
  %180 = load ptr, ptr %22, align 8
  %181 = load ptr, ptr %23, align 8
  store double %101, ptr %181, align 8
  %182 = load ptr, ptr %3, align 8
  %183 = getelementptr inbounds i8, ptr %182, i64 40
  %184 = load i64, ptr %183, align 8
  %185 = icmp eq i64 %184, 0
  br i1 %185, label %187, label %186

186:                                              ; preds = %178
  tail call fastcc void @settle(ptr noundef nonnull %3) #5
  br label %187

187:                                              ; preds = %186, %178
  %188 = load i64, ptr %24, align 8
  %189 = icmp sgt i64 %188, 0
  br i1 %189, label %190, label %191

190:                                              ; preds = %187
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %191

191:                                              ; preds = %187, %190
  %192 = load ptr, ptr %3, align 8
  %193 = load i64, ptr %192, align 8
  %194 = load ptr, ptr %23, align 8
  %195 = load ptr, ptr %25, align 8
  %196 = load ptr, ptr %26, align 8
  %197 = inttoptr i64 %193 to ptr
  %198 = load ptr, ptr %197, align 8
  %199 = tail call i32 %198(ptr noundef %194, ptr noundef %179, ptr noundef %195, ptr noundef %196, ptr noundef %180) #6
  %200 = sext i32 %199 to i64
  %201 = icmp eq i32 %199, 0
  br i1 %201, label %202, label %361

202:                                              ; preds = %191
  %203 = load ptr, ptr %0, align 8
  %204 = load i64, ptr %203, align 8
  %205 = load ptr, ptr %27, align 8
  %206 = insertelement <8 x double> poison, double %80, i64 0
  %207 = shufflevector <8 x double> %206, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %207, ptr %205, align 8
  %208 = icmp sgt i64 %204, 1
  br i1 %208, label %213, label %304

209:                                              ; preds = %292
  %210 = add nuw nsw i64 %216, 1
  %211 = icmp slt i64 %210, %204
  %212 = icmp eq i64 %210, %204
  br i1 %212, label %304, label %213, !llvm.loop !10

213:                                              ; preds = %202, %209
  %214 = phi i1 [ %211, %209 ], [ %208, %202 ]
  %215 = phi i64 [ %303, %209 ], [ undef, %202 ]
  %216 = phi i64 [ %210, %209 ], [ 1, %202 ]
  %217 = load ptr, ptr %28, align 8
  %218 = load ptr, ptr %4, align 8
  %219 = load ptr, ptr %3, align 8
  %220 = getelementptr inbounds i8, ptr %219, i64 16
  %221 = load i64, ptr %220, align 8
  %222 = icmp sgt i64 %221, 1
  %223 = zext i1 %222 to i64
  %224 = load ptr, ptr %29, align 8
  %225 = getelementptr inbounds i64, ptr %224, i64 %216
  %226 = load i64, ptr %225, align 8
  %227 = getelementptr i8, ptr %225, i64 8
  %228 = load i64, ptr %227, align 8
  %229 = xor i64 %226, -1
  %230 = add i64 %228, %229
  %231 = load ptr, ptr %27, align 8
  %232 = load ptr, ptr %30, align 8
  %233 = load ptr, ptr %31, align 8
  %234 = getelementptr inbounds i64, ptr %233, i64 %226
  %235 = load ptr, ptr %32, align 8
  %236 = getelementptr inbounds double, ptr %235, i64 %226
  tail call fastcc void @combine(ptr noundef %217, ptr noundef %218, ptr noundef %231, ptr noundef %232, ptr noundef %234, ptr noundef %236, i64 noundef %230, i64 noundef %223, i64 noundef %221) #5
  %237 = icmp eq i64 %221, 1
  br i1 %237, label %238, label %269

238:                                              ; preds = %213
  %239 = load ptr, ptr %29, align 8
  %240 = getelementptr i64, ptr %239, i64 %216
  %241 = getelementptr i8, ptr %240, i64 8
  %242 = load i64, ptr %241, align 8
  %243 = add nsw i64 %242, -1
  %244 = load ptr, ptr %32, align 8
  %245 = getelementptr inbounds double, ptr %244, i64 %243
  %246 = load double, ptr %245, align 8
  %247 = fmul double %80, %246
  %248 = load ptr, ptr %30, align 8
  %249 = load ptr, ptr %31, align 8
  %250 = getelementptr inbounds i64, ptr %249, i64 %243
  %251 = load i64, ptr %250, align 8
  %252 = getelementptr inbounds double, ptr %248, i64 %251
  %253 = load ptr, ptr %3, align 8
  %254 = getelementptr inbounds i8, ptr %253, i64 8
  %255 = load i64, ptr %254, align 8
  %256 = icmp sgt i64 %255, 0
  br i1 %256, label %257, label %269

257:                                              ; preds = %238, %257
  %258 = phi i64 [ %264, %257 ], [ 0, %238 ]
  %259 = getelementptr inbounds double, ptr %252, i64 %258
  %260 = load double, ptr %259, align 8
  %261 = getelementptr inbounds double, ptr %217, i64 %258
  %262 = load double, ptr %261, align 8
  %263 = tail call double @llvm.fma.f64(double %247, double %260, double %262)
  store double %263, ptr %261, align 8
  %264 = add nuw nsw i64 %258, 1
  %265 = load ptr, ptr %3, align 8
  %266 = getelementptr inbounds i8, ptr %265, i64 8
  %267 = load i64, ptr %266, align 8
  %268 = icmp slt i64 %264, %267
  br i1 %268, label %257, label %269, !llvm.loop !11

269:                                              ; preds = %257, %238, %213
  %270 = load ptr, ptr %30, align 8
  %271 = load i64, ptr %33, align 8
  %272 = mul nsw i64 %271, %216
  %273 = getelementptr inbounds double, ptr %270, i64 %272
  %274 = load i64, ptr %103, align 8
  %275 = add nsw i64 %274, 1
  store i64 %275, ptr %103, align 8
  %276 = load ptr, ptr %34, align 8
  %277 = getelementptr inbounds double, ptr %276, i64 %216
  %278 = load double, ptr %277, align 8
  %279 = fmul double %80, %278
  %280 = fadd double %101, %279
  %281 = load ptr, ptr %28, align 8
  %282 = load ptr, ptr %23, align 8
  store double %280, ptr %282, align 8
  %283 = load ptr, ptr %3, align 8
  %284 = getelementptr inbounds i8, ptr %283, i64 40
  %285 = load i64, ptr %284, align 8
  %286 = icmp eq i64 %285, 0
  br i1 %286, label %288, label %287

287:                                              ; preds = %269
  tail call fastcc void @settle(ptr noundef nonnull %3) #5
  br label %288

288:                                              ; preds = %287, %269
  %289 = load i64, ptr %24, align 8
  %290 = icmp sgt i64 %289, 0
  br i1 %290, label %291, label %292

291:                                              ; preds = %288
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %292

292:                                              ; preds = %288, %291
  %293 = load ptr, ptr %3, align 8
  %294 = load i64, ptr %293, align 8
  %295 = load ptr, ptr %23, align 8
  %296 = load ptr, ptr %25, align 8
  %297 = load ptr, ptr %26, align 8
  %298 = inttoptr i64 %294 to ptr
  %299 = load ptr, ptr %298, align 8
  %300 = tail call i32 %299(ptr noundef %295, ptr noundef %281, ptr noundef %296, ptr noundef %297, ptr noundef %273) #6
  %301 = sext i32 %300 to i64
  %302 = icmp eq i32 %300, 0
  %303 = select i1 %302, i64 %215, i64 %301
  br i1 %302, label %209, label %304

304:                                              ; preds = %209, %292, %202
  %305 = phi i1 [ %208, %202 ], [ %211, %209 ], [ %214, %292 ]
  %306 = phi i64 [ 0, %202 ], [ %301, %292 ], [ %301, %209 ]
  %307 = phi i64 [ undef, %202 ], [ %303, %292 ], [ %303, %209 ]
  br i1 %305, label %361, label %308

308:                                              ; preds = %304
  %309 = load ptr, ptr %35, align 8
  %310 = load ptr, ptr %4, align 8
  %311 = load ptr, ptr %3, align 8
  %312 = getelementptr inbounds i8, ptr %311, i64 16
  %313 = load i64, ptr %312, align 8
  %314 = icmp sgt i64 %313, 1
  %315 = zext i1 %314 to i64
  %316 = load ptr, ptr %36, align 8
  %317 = getelementptr inbounds i64, ptr %316, i64 %204
  %318 = load i64, ptr %317, align 8
  %319 = getelementptr i8, ptr %317, i64 8
  %320 = load i64, ptr %319, align 8
  %321 = xor i64 %318, -1
  %322 = add i64 %320, %321
  %323 = load ptr, ptr %27, align 8
  %324 = load ptr, ptr %37, align 8
  %325 = load ptr, ptr %38, align 8
  %326 = getelementptr inbounds i64, ptr %325, i64 %318
  %327 = load ptr, ptr %39, align 8
  %328 = getelementptr inbounds double, ptr %327, i64 %318
  tail call fastcc void @combine(ptr noundef %309, ptr noundef %310, ptr noundef %323, ptr noundef %324, ptr noundef %326, ptr noundef %328, i64 noundef %322, i64 noundef %315, i64 noundef %313) #5
  %329 = icmp eq i64 %313, 1
  br i1 %329, label %330, label %361

330:                                              ; preds = %308
  %331 = load ptr, ptr %36, align 8
  %332 = getelementptr i64, ptr %331, i64 %204
  %333 = getelementptr i8, ptr %332, i64 8
  %334 = load i64, ptr %333, align 8
  %335 = add nsw i64 %334, -1
  %336 = load ptr, ptr %39, align 8
  %337 = getelementptr inbounds double, ptr %336, i64 %335
  %338 = load double, ptr %337, align 8
  %339 = fmul double %80, %338
  %340 = load ptr, ptr %37, align 8
  %341 = load ptr, ptr %38, align 8
  %342 = getelementptr inbounds i64, ptr %341, i64 %335
  %343 = load i64, ptr %342, align 8
  %344 = getelementptr inbounds double, ptr %340, i64 %343
  %345 = load ptr, ptr %3, align 8
  %346 = getelementptr inbounds i8, ptr %345, i64 8
  %347 = load i64, ptr %346, align 8
  %348 = icmp sgt i64 %347, 0
  br i1 %348, label %349, label %361

349:                                              ; preds = %330, %349
  %350 = phi i64 [ %356, %349 ], [ 0, %330 ]
  %351 = getelementptr inbounds double, ptr %344, i64 %350
  %352 = load double, ptr %351, align 8
  %353 = getelementptr inbounds double, ptr %309, i64 %350
  %354 = load double, ptr %353, align 8
  %355 = tail call double @llvm.fma.f64(double %339, double %352, double %354)
  store double %355, ptr %353, align 8
  %356 = add nuw nsw i64 %350, 1
  %357 = load ptr, ptr %3, align 8
  %358 = getelementptr inbounds i8, ptr %357, i64 8
  %359 = load i64, ptr %358, align 8
  %360 = icmp slt i64 %356, %359
  br i1 %360, label %349, label %361, !llvm.loop !11

361:                                              ; preds = %349, %330, %304, %308, %191
  %362 = phi i64 [ %200, %191 ], [ %307, %304 ], [ %306, %308 ], [ %306, %330 ], [ %306, %349 ]
  %363 = icmp eq i64 %362, 0
  br i1 %363, label %364, label %551

364:                                              ; preds = %361
  %365 = getelementptr inbounds i8, ptr %94, i64 16
  %366 = icmp sgt i64 %97, 0
  br i1 %366, label %394, label %367

367:                                              ; preds = %394, %364
  %368 = load double, ptr %94, align 8
  %369 = load ptr, ptr %41, align 8
  %370 = load ptr, ptr %22, align 8
  %371 = mul nsw i64 %100, %98
  %372 = getelementptr inbounds double, ptr %370, i64 %371
  %373 = load ptr, ptr %23, align 8
  store double %368, ptr %373, align 8
  %374 = load ptr, ptr %3, align 8
  %375 = getelementptr inbounds i8, ptr %374, i64 40
  %376 = load i64, ptr %375, align 8
  %377 = icmp eq i64 %376, 0
  br i1 %377, label %379, label %378

378:                                              ; preds = %367
  tail call fastcc void @settle(ptr noundef nonnull %3) #5
  br label %379

379:                                              ; preds = %378, %367
  %380 = load i64, ptr %24, align 8
  %381 = icmp sgt i64 %380, 0
  br i1 %381, label %382, label %383

382:                                              ; preds = %379
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %383

383:                                              ; preds = %379, %382
  %384 = load ptr, ptr %3, align 8
  %385 = load i64, ptr %384, align 8
  %386 = load ptr, ptr %23, align 8
  %387 = load ptr, ptr %25, align 8
  %388 = load ptr, ptr %26, align 8
  %389 = inttoptr i64 %385 to ptr
  %390 = load ptr, ptr %389, align 8
  %391 = tail call i32 %390(ptr noundef %386, ptr noundef %369, ptr noundef %387, ptr noundef %388, ptr noundef %372) #6
  %392 = sext i32 %391 to i64
  %393 = icmp eq i32 %391, 0
  br i1 %393, label %402, label %551

394:                                              ; preds = %364, %394
  %395 = phi i64 [ %400, %394 ], [ 0, %364 ]
  %396 = getelementptr inbounds double, ptr %365, i64 %395
  %397 = load double, ptr %396, align 8
  %398 = load ptr, ptr %40, align 8
  %399 = getelementptr inbounds double, ptr %398, i64 %395
  store double %397, ptr %399, align 8
  %400 = add nuw nsw i64 %395, 1
  %401 = icmp eq i64 %400, %97
  br i1 %401, label %367, label %394, !llvm.loop !12

402:                                              ; preds = %383
  %403 = load ptr, ptr %0, align 8
  %404 = load ptr, ptr %3, align 8
  %405 = getelementptr inbounds i8, ptr %404, i64 16
  %406 = load i64, ptr %405, align 8
  %407 = load i64, ptr %403, align 8
  %408 = load i64, ptr %42, align 8
  %409 = load ptr, ptr %43, align 8
  %410 = mul nsw i64 %408, %407
  %411 = getelementptr inbounds double, ptr %409, i64 %410
  %412 = load ptr, ptr %44, align 8
  %413 = add nsw i64 %407, 1
  %414 = getelementptr inbounds i8, ptr %403, i64 16
  %415 = load i64, ptr %414, align 8
  %416 = icmp sgt i64 %415, 0
  br i1 %416, label %417, label %478

417:                                              ; preds = %402
  %418 = getelementptr inbounds i8, ptr %403, i64 8
  br label %424

419:                                              ; preds = %466
  %420 = add nsw i64 %427, 1
  %421 = load i64, ptr %414, align 8
  %422 = add nsw i64 %421, %413
  %423 = icmp slt i64 %420, %422
  br i1 %423, label %424, label %478, !llvm.loop !13

424:                                              ; preds = %417, %419
  %425 = phi i1 [ %416, %417 ], [ %423, %419 ]
  %426 = phi i64 [ undef, %417 ], [ %477, %419 ]
  %427 = phi i64 [ %413, %417 ], [ %420, %419 ]
  %428 = load i64, ptr %418, align 8
  %429 = load ptr, ptr %45, align 8
  %430 = load ptr, ptr %4, align 8
  %431 = load ptr, ptr %46, align 8
  %432 = getelementptr i64, ptr %431, i64 %427
  %433 = getelementptr i64, ptr %432, i64 %428
  %434 = load i64, ptr %433, align 8
  %435 = getelementptr i8, ptr %433, i64 8
  %436 = load i64, ptr %435, align 8
  %437 = xor i64 %434, -1
  %438 = add i64 %436, %437
  %439 = load ptr, ptr %47, align 8
  %440 = load ptr, ptr %43, align 8
  %441 = load ptr, ptr %48, align 8
  %442 = getelementptr inbounds i64, ptr %441, i64 %434
  %443 = load ptr, ptr %49, align 8
  %444 = getelementptr inbounds double, ptr %443, i64 %434
  tail call fastcc void @combine(ptr noundef %429, ptr noundef %430, ptr noundef %439, ptr noundef %440, ptr noundef %442, ptr noundef %444, i64 noundef %438, i64 noundef 1, i64 noundef %406) #5
  %445 = load ptr, ptr %43, align 8
  %446 = mul nsw i64 %427, %408
  %447 = getelementptr inbounds double, ptr %445, i64 %446
  %448 = load i64, ptr %103, align 8
  %449 = add nsw i64 %448, 1
  store i64 %449, ptr %103, align 8
  %450 = load ptr, ptr %50, align 8
  %451 = getelementptr inbounds double, ptr %450, i64 %427
  %452 = load double, ptr %451, align 8
  %453 = fmul double %80, %452
  %454 = fadd double %101, %453
  %455 = load ptr, ptr %45, align 8
  %456 = load ptr, ptr %23, align 8
  store double %454, ptr %456, align 8
  %457 = load ptr, ptr %3, align 8
  %458 = getelementptr inbounds i8, ptr %457, i64 40
  %459 = load i64, ptr %458, align 8
  %460 = icmp eq i64 %459, 0
  br i1 %460, label %462, label %461

461:                                              ; preds = %424
  tail call fastcc void @settle(ptr noundef nonnull %3) #5
  br label %462

462:                                              ; preds = %461, %424
  %463 = load i64, ptr %24, align 8
  %464 = icmp sgt i64 %463, 0
  br i1 %464, label %465, label %466

465:                                              ; preds = %462
  tail call fastcc void @sample(ptr noundef nonnull %3) #5
  br label %466

466:                                              ; preds = %462, %465
  %467 = load ptr, ptr %3, align 8
  %468 = load i64, ptr %467, align 8
  %469 = load ptr, ptr %23, align 8
  %470 = load ptr, ptr %25, align 8
  %471 = load ptr, ptr %26, align 8
  %472 = inttoptr i64 %468 to ptr
  %473 = load ptr, ptr %472, align 8
  %474 = tail call i32 %473(ptr noundef %469, ptr noundef %455, ptr noundef %470, ptr noundef %471, ptr noundef %447) #6
  %475 = sext i32 %474 to i64
  %476 = icmp eq i32 %474, 0
  %477 = select i1 %476, i64 %426, i64 %475
  br i1 %476, label %419, label %478

478:                                              ; preds = %419, %466, %402
  %479 = phi i1 [ %416, %402 ], [ %423, %419 ], [ %425, %466 ]
  %480 = phi i64 [ 0, %402 ], [ %475, %466 ], [ %475, %419 ]
  %481 = phi i64 [ undef, %402 ], [ %477, %466 ], [ %477, %419 ]
  %482 = getelementptr inbounds i8, ptr %403, i64 16
  br i1 %479, label %551, label %483

483:                                              ; preds = %478
  %484 = load ptr, ptr %3, align 8
  %485 = getelementptr inbounds i8, ptr %484, i64 8
  %486 = load i64, ptr %485, align 8
  %487 = icmp sgt i64 %486, 0
  br i1 %487, label %488, label %492

488:                                              ; preds = %483
  %489 = getelementptr inbounds double, ptr %412, i64 %408
  %490 = shl nsw i64 %408, 4
  %491 = getelementptr inbounds i8, ptr %412, i64 %490
  br label %499

492:                                              ; preds = %499, %483
  %493 = getelementptr inbounds i8, ptr %403, i64 8
  %494 = load i64, ptr %493, align 8
  %495 = load i64, ptr %482, align 8
  %496 = getelementptr inbounds i8, ptr %403, i64 24
  %497 = load i64, ptr %496, align 8
  %498 = icmp sgt i64 %497, 3
  br i1 %498, label %526, label %551

499:                                              ; preds = %488, %499
  %500 = phi i64 [ 0, %488 ], [ %521, %499 ]
  %501 = load ptr, ptr %51, align 8
  %502 = getelementptr inbounds double, ptr %501, i64 %500
  %503 = load double, ptr %502, align 8
  %504 = load ptr, ptr %4, align 8
  %505 = getelementptr inbounds double, ptr %504, i64 %500
  %506 = load double, ptr %505, align 8
  %507 = fsub double %503, %506
  %508 = load ptr, ptr %43, align 8
  %509 = getelementptr inbounds double, ptr %508, i64 %500
  %510 = load double, ptr %509, align 8
  %511 = fmul double %80, %510
  %512 = fsub double %511, %507
  %513 = getelementptr inbounds double, ptr %412, i64 %500
  store double %507, ptr %513, align 8
  %514 = getelementptr inbounds double, ptr %489, i64 %500
  store double %512, ptr %514, align 8
  %515 = fsub double %507, %512
  %516 = getelementptr inbounds double, ptr %411, i64 %500
  %517 = load double, ptr %516, align 8
  %518 = fmul double %80, %517
  %519 = fsub double %515, %518
  %520 = getelementptr inbounds double, ptr %491, i64 %500
  store double %519, ptr %520, align 8
  %521 = add nuw nsw i64 %500, 1
  %522 = load ptr, ptr %3, align 8
  %523 = getelementptr inbounds i8, ptr %522, i64 8
  %524 = load i64, ptr %523, align 8
  %525 = icmp slt i64 %521, %524
  br i1 %525, label %499, label %492, !llvm.loop !14

526:                                              ; preds = %492, %526
  %527 = phi i64 [ %548, %526 ], [ 3, %492 ]
  %528 = mul nsw i64 %527, %408
  %529 = getelementptr inbounds double, ptr %412, i64 %528
  %530 = load ptr, ptr %52, align 8
  %531 = load ptr, ptr %53, align 8
  %532 = getelementptr i64, ptr %531, i64 %413
  %533 = getelementptr i64, ptr %532, i64 %494
  %534 = getelementptr i64, ptr %533, i64 %495
  %535 = getelementptr i64, ptr %534, i64 %527
  %536 = getelementptr i8, ptr %535, i64 -24
  %537 = load i64, ptr %536, align 8
  %538 = getelementptr i8, ptr %535, i64 -16
  %539 = load i64, ptr %538, align 8
  %540 = xor i64 %537, -1
  %541 = add i64 %539, %540
  %542 = load ptr, ptr %54, align 8
  %543 = load ptr, ptr %43, align 8
  %544 = load ptr, ptr %55, align 8
  %545 = getelementptr inbounds i64, ptr %544, i64 %537
  %546 = load ptr, ptr %56, align 8
  %547 = getelementptr inbounds double, ptr %546, i64 %537
  tail call fastcc void @combine(ptr noundef %529, ptr noundef %530, ptr noundef %542, ptr noundef %543, ptr noundef %545, ptr noundef %547, i64 noundef %541, i64 noundef 1, i64 noundef %406) #5
  %548 = add nuw nsw i64 %527, 1
  %549 = load i64, ptr %496, align 8
  %550 = icmp slt i64 %548, %549
  br i1 %550, label %526, label %551, !llvm.loop !15

551:                                              ; preds = %526, %131, %492, %108, %478, %361, %383
  %552 = phi i64 [ %362, %361 ], [ %392, %383 ], [ %481, %478 ], [ 0, %108 ], [ %480, %492 ], [ 0, %131 ], [ %480, %526 ]
  %553 = icmp eq i64 %552, 0
  %554 = select i1 %553, i64 %64, i64 %552
  br i1 %553, label %555, label %585

555:                                              ; preds = %551, %91
  %556 = phi i64 [ %69, %551 ], [ %65, %91 ]
  %557 = phi i64 [ %554, %551 ], [ %64, %91 ]
  %558 = load double, ptr %72, align 8
  %559 = fsub double %75, %558
  %560 = load double, ptr %79, align 8
  %561 = fdiv double %559, %560
  %562 = load ptr, ptr %58, align 8
  %563 = insertelement <8 x double> poison, double %561, i64 0
  %564 = shufflevector <8 x double> %563, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %564, ptr %562, align 8
  %565 = load ptr, ptr %4, align 8
  %566 = load ptr, ptr %59, align 8
  %567 = load i64, ptr %60, align 8
  %568 = load ptr, ptr %0, align 8
  %569 = getelementptr inbounds i8, ptr %568, i64 24
  %570 = load i64, ptr %569, align 8
  %571 = load ptr, ptr %58, align 8
  %572 = load ptr, ptr %3, align 8
  %573 = getelementptr inbounds i8, ptr %572, i64 16
  %574 = load i64, ptr %573, align 8
  tail call fastcc void @nested(ptr noundef %78, ptr noundef %565, ptr noundef %566, i64 noundef %567, i64 noundef %570, ptr noundef %571, i64 noundef %574) #5
  %575 = load ptr, ptr %61, align 8
  %576 = load i64, ptr %575, align 8
  %577 = icmp eq i64 %576, 1
  %578 = fcmp ogt double %561, 0.000000e+00
  %579 = and i1 %578, %577
  br i1 %579, label %580, label %585

580:                                              ; preds = %555
  %581 = getelementptr inbounds i8, ptr %575, i64 56
  %582 = load i64, ptr %581, align 8
  %583 = inttoptr i64 %582 to ptr
  %584 = tail call i64 %583(ptr noundef %0, double noundef %75, ptr noundef %78, ptr noundef null) #6
  br label %585

585:                                              ; preds = %84, %82, %555, %580, %551
  %586 = phi i32 [ 1, %551 ], [ 0, %580 ], [ 0, %555 ], [ 4, %82 ], [ 4, %84 ]
  %587 = phi i64 [ %69, %551 ], [ %556, %580 ], [ %556, %555 ], [ %65, %82 ], [ %65, %84 ]
  %588 = phi i64 [ %554, %551 ], [ %557, %580 ], [ %557, %555 ], [ %64, %82 ], [ %64, %84 ]
  switch i32 %586, label %593 [
    i32 0, label %589
    i32 4, label %589
  ]

589:                                              ; preds = %585, %585
  %590 = add nuw nsw i64 %66, 1
  %591 = load i64, ptr %10, align 8
  %592 = icmp slt i64 %590, %591
  br i1 %592, label %63, label %593, !llvm.loop !16

593:                                              ; preds = %585, %589, %2
  %594 = phi i64 [ 0, %2 ], [ %588, %585 ], [ 0, %589 ]
  ret i64 %594
}

define internal fastcc void @settle(ptr noundef readonly %0) unnamed_addr #1 {
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
  br i1 %28, label %16, label %29, !llvm.loop !9

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
