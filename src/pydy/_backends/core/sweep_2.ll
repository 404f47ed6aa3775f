; sources 2d3c8b6881492393a2bfa47a8c3d1c4a6ad9fae2bb9989d13855d0a2e3191afa
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define range(i64 0, 2) i64 @sweep_2(ptr noundef readonly %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, ptr noundef readonly %4, ptr noundef %5, ptr noundef writeonly %6, ptr noundef %7) #0 {
  %9 = alloca [5 x i64], align 16
  %10 = getelementptr inbounds i8, ptr %0, i64 88
  %11 = load i64, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 32
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %0, i64 40
  %15 = load i64, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 64
  %17 = load i64, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %0, i64 112
  %19 = load i64, ptr %18, align 8
  %20 = icmp ne i64 %19, 0
  %21 = icmp ne i64 %15, 0
  %22 = select i1 %20, i1 %21, i1 false
  %23 = getelementptr inbounds i8, ptr %0, i64 128
  %24 = getelementptr inbounds i8, ptr %0, i64 136
  %25 = load i64, ptr %24, align 8
  %26 = icmp eq i64 %25, 1
  %27 = ptrtoint ptr %7 to i64
  %28 = add i64 %27, 63
  %29 = and i64 %28, -64
  %30 = inttoptr i64 %29 to ptr
  %31 = getelementptr inbounds i8, ptr %0, i64 48
  %32 = load i64, ptr %31, align 8
  %33 = shl nsw i64 %32, 4
  %34 = getelementptr inbounds i8, ptr %30, i64 %33
  %35 = getelementptr inbounds i8, ptr %0, i64 56
  %36 = load i64, ptr %35, align 8
  %37 = shl nsw i64 %36, 4
  %38 = getelementptr inbounds i8, ptr %34, i64 %37
  %39 = getelementptr inbounds i8, ptr %38, i64 16
  %40 = getelementptr inbounds i8, ptr %0, i64 72
  %41 = load i64, ptr %40, align 8
  %42 = shl i64 %13, 4
  %43 = mul i64 %42, %41
  %44 = getelementptr inbounds i8, ptr %39, i64 %43
  %45 = shl i64 %15, 4
  %46 = mul i64 %45, %41
  %47 = getelementptr inbounds i8, ptr %44, i64 %46
  %48 = icmp slt i64 %11, 1
  br i1 %48, label %598, label %49

49:                                               ; preds = %8
  %50 = icmp sgt i64 %32, 0
  br i1 %50, label %51, label %65

51:                                               ; preds = %49, %56
  %52 = phi i64 [ %57, %56 ], [ 0, %49 ]
  %53 = getelementptr inbounds double, ptr %4, i64 %52
  %54 = shl nsw i64 %52, 4
  %55 = getelementptr inbounds i8, ptr %30, i64 %54
  br label %59

56:                                               ; preds = %59
  %57 = add nuw nsw i64 %52, 1
  %58 = icmp eq i64 %57, %32
  br i1 %58, label %65, label %51, !llvm.loop !3

59:                                               ; preds = %51, %59
  %60 = phi i64 [ 0, %51 ], [ %63, %59 ]
  %61 = load double, ptr %53, align 8
  %62 = getelementptr inbounds double, ptr %55, i64 %60
  store double %61, ptr %62, align 8
  %63 = add nuw nsw i64 %60, 1
  %64 = icmp eq i64 %60, 0
  br i1 %64, label %59, label %56, !llvm.loop !6

65:                                               ; preds = %56, %49
  %66 = getelementptr inbounds i8, ptr %0, i64 8
  %67 = load ptr, ptr %66, align 8
  tail call void %67(ptr noundef %30, ptr noundef %34) #4
  br i1 %22, label %87, label %68

68:                                               ; preds = %65
  %69 = getelementptr inbounds i8, ptr %0, i64 120
  %70 = load i64, ptr %69, align 8
  %71 = icmp sgt i64 %15, 0
  br i1 %71, label %72, label %87

72:                                               ; preds = %68, %78
  %73 = phi i64 [ %79, %78 ], [ 0, %68 ]
  %74 = mul nsw i64 %73, %70
  %75 = getelementptr inbounds double, ptr %3, i64 %74
  %76 = shl nsw i64 %73, 4
  %77 = getelementptr inbounds i8, ptr %44, i64 %76
  br label %81

78:                                               ; preds = %81
  %79 = add nuw nsw i64 %73, 1
  %80 = icmp eq i64 %79, %15
  br i1 %80, label %87, label %72, !llvm.loop !3

81:                                               ; preds = %72, %81
  %82 = phi i64 [ 0, %72 ], [ %85, %81 ]
  %83 = load double, ptr %75, align 8
  %84 = getelementptr inbounds double, ptr %77, i64 %82
  store double %83, ptr %84, align 8
  %85 = add nuw nsw i64 %82, 1
  %86 = icmp eq i64 %82, 0
  br i1 %86, label %81, label %78, !llvm.loop !6

87:                                               ; preds = %78, %68, %65
  %88 = icmp eq i64 %11, 1
  br i1 %88, label %89, label %147

89:                                               ; preds = %87
  %90 = icmp sgt i64 %13, 0
  %91 = icmp sgt i64 %15, 0
  %92 = select i1 %20, i1 %91, i1 false
  %93 = getelementptr inbounds i8, ptr %0, i64 104
  %94 = getelementptr inbounds i8, ptr %0, i64 120
  br label %104

95:                                               ; preds = %123
  %96 = load ptr, ptr %0, align 8
  %97 = tail call i32 %96(ptr noundef %38, ptr noundef nonnull %39, ptr noundef nonnull %44, ptr noundef %34, ptr noundef nonnull %47) #4
  %98 = icmp eq i32 %97, 0
  br i1 %98, label %102, label %99

99:                                               ; preds = %95
  %100 = trunc i32 %97 to i8
  %101 = and i8 %100, 1
  store i8 %101, ptr %6, align 1
  br label %102

102:                                              ; preds = %99, %95
  %103 = icmp sgt i64 %17, 0
  br i1 %103, label %137, label %598

104:                                              ; preds = %89, %123
  %105 = phi i64 [ 0, %89 ], [ %124, %123 ]
  %106 = load double, ptr %1, align 8
  %107 = getelementptr inbounds double, ptr %38, i64 %105
  store double %106, ptr %107, align 8
  br i1 %90, label %108, label %110

108:                                              ; preds = %104
  %109 = getelementptr inbounds double, ptr %39, i64 %105
  br label %113

110:                                              ; preds = %113, %104
  br i1 %92, label %111, label %123

111:                                              ; preds = %110
  %112 = getelementptr inbounds double, ptr %44, i64 %105
  br label %126

113:                                              ; preds = %108, %113
  %114 = phi i64 [ %121, %113 ], [ 0, %108 ]
  %115 = load i64, ptr %93, align 8
  %116 = mul nsw i64 %115, %114
  %117 = getelementptr double, ptr %2, i64 %116
  %118 = load double, ptr %117, align 8
  %119 = shl nsw i64 %114, 4
  %120 = getelementptr inbounds i8, ptr %109, i64 %119
  store double %118, ptr %120, align 8
  %121 = add nuw nsw i64 %114, 1
  %122 = icmp eq i64 %121, %13
  br i1 %122, label %110, label %113, !llvm.loop !7

123:                                              ; preds = %126, %110
  %124 = add nuw nsw i64 %105, 1
  %125 = icmp eq i64 %105, 0
  br i1 %125, label %104, label %95, !llvm.loop !9

126:                                              ; preds = %111, %126
  %127 = phi i64 [ %134, %126 ], [ 0, %111 ]
  %128 = load i64, ptr %94, align 8
  %129 = mul nsw i64 %128, %127
  %130 = getelementptr double, ptr %3, i64 %129
  %131 = load double, ptr %130, align 8
  %132 = shl nsw i64 %127, 4
  %133 = getelementptr inbounds i8, ptr %112, i64 %132
  store double %131, ptr %133, align 8
  %134 = add nuw nsw i64 %127, 1
  %135 = icmp slt i64 %134, %15
  %136 = select i1 %22, i1 %135, i1 false
  br i1 %136, label %126, label %123, !llvm.loop !10

137:                                              ; preds = %102, %137
  %138 = phi i64 [ %145, %137 ], [ 0, %102 ]
  %139 = shl nsw i64 %138, 4
  %140 = getelementptr inbounds i8, ptr %47, i64 %139
  %141 = load double, ptr %140, align 8
  %142 = load i64, ptr %24, align 8
  %143 = mul nsw i64 %142, %138
  %144 = getelementptr inbounds double, ptr %5, i64 %143
  store double %141, ptr %144, align 8
  %145 = add nuw nsw i64 %138, 1
  %146 = icmp eq i64 %145, %17
  br i1 %146, label %598, label %137, !llvm.loop !11

147:                                              ; preds = %87
  %148 = getelementptr inbounds i8, ptr %0, i64 96
  %149 = getelementptr inbounds i8, ptr %0, i64 104
  %150 = load i64, ptr %149, align 8
  %151 = icmp eq i64 %150, 1
  %152 = select i1 %151, i1 true, i1 %26
  %153 = xor i1 %22, true
  %154 = select i1 %152, i1 true, i1 %153
  %155 = xor i1 %152, true
  br i1 %154, label %160, label %156

156:                                              ; preds = %147
  %157 = getelementptr inbounds i8, ptr %0, i64 120
  %158 = load i64, ptr %157, align 8
  %159 = icmp ne i64 %158, 1
  br label %160

160:                                              ; preds = %147, %156
  %161 = phi i1 [ %155, %147 ], [ %159, %156 ]
  %162 = getelementptr inbounds i8, ptr %0, i64 80
  %163 = load i64, ptr %162, align 8
  %164 = icmp sgt i64 %11, %163
  br i1 %164, label %165, label %176

165:                                              ; preds = %160
  %166 = add nsw i64 %15, %13
  %167 = add nsw i64 %166, %17
  %168 = shl nsw i64 %150, 3
  %169 = sub nsw i64 0, %168
  %170 = and i64 %168, %169
  %171 = tail call i64 @llvm.smin.i64(i64 %170, i64 4096)
  %172 = tail call i64 @llvm.smax.i64(i64 %171, i64 64)
  %173 = udiv i64 4096, %172
  %174 = shl nuw nsw i64 %173, 2
  %175 = icmp sge i64 %174, %167
  br label %176

176:                                              ; preds = %165, %160
  %177 = phi i1 [ true, %160 ], [ %175, %165 ]
  %178 = getelementptr inbounds i8, ptr %0, i64 16
  %179 = load ptr, ptr %178, align 8
  %180 = icmp ne ptr %179, null
  %181 = select i1 %180, i1 %161, i1 false
  %182 = select i1 %181, i1 %177, i1 false
  br i1 %182, label %183, label %245

183:                                              ; preds = %176
  %184 = select i1 %22, ptr %3, ptr %44
  %185 = load i64, ptr %10, align 8
  %186 = add nsw i64 %185, -2
  %187 = ptrtoint ptr %2 to i64
  %188 = shl i64 %187, 60
  %189 = ashr i64 %188, 63
  %190 = load i64, ptr %18, align 8
  %191 = icmp eq i64 %190, 0
  %192 = select i1 %191, i64 0, i64 2
  store i64 %150, ptr %9, align 16
  %193 = getelementptr inbounds i8, ptr %9, i64 8
  br i1 %191, label %197, label %194

194:                                              ; preds = %183
  %195 = getelementptr inbounds i8, ptr %0, i64 120
  %196 = load i64, ptr %195, align 8
  br label %197

197:                                              ; preds = %194, %183
  %198 = phi i64 [ %196, %194 ], [ 2, %183 ]
  store i64 %198, ptr %193, align 8
  %199 = getelementptr inbounds i8, ptr %9, i64 16
  %200 = load i64, ptr %24, align 8
  store i64 %200, ptr %199, align 16
  %201 = getelementptr inbounds i8, ptr %9, i64 24
  store i64 1, ptr %201, align 8
  %202 = getelementptr inbounds i8, ptr %9, i64 32
  store i64 %192, ptr %202, align 16
  %203 = getelementptr i8, ptr %6, i64 -2
  %204 = icmp sgt i64 %185, 0
  br i1 %204, label %205, label %244

205:                                              ; preds = %197
  %206 = icmp sgt i64 %185, 2
  %207 = add nsw i64 %189, 2
  br label %208

208:                                              ; preds = %205, %240
  %209 = phi i64 [ 0, %205 ], [ %242, %240 ]
  %210 = call i64 @llvm.smin.i64(i64 %209, i64 %186)
  %211 = icmp eq i64 %209, 0
  br i1 %211, label %215, label %212

212:                                              ; preds = %208
  %213 = sub nsw i64 %185, %210
  %214 = sdiv i64 %213, 2
  store i64 %214, ptr %201, align 8
  br label %215

215:                                              ; preds = %212, %208
  %216 = load i64, ptr %18, align 8
  %217 = icmp eq i64 %216, 0
  %218 = select i1 %217, i64 0, i64 %210
  %219 = getelementptr inbounds double, ptr %184, i64 %218
  %220 = load ptr, ptr %178, align 8
  %221 = getelementptr inbounds double, ptr %1, i64 %210
  %222 = getelementptr inbounds double, ptr %2, i64 %210
  %223 = getelementptr inbounds double, ptr %5, i64 %210
  %224 = call i64 %220(ptr noundef %221, ptr noundef %222, ptr noundef %219, ptr noundef %34, ptr noundef %223, ptr noundef nonnull %9) #4
  %225 = ashr i64 %224, 31
  %226 = and i64 %225, -2
  %227 = add nsw i64 %226, %210
  %228 = shl i64 %224, 32
  %229 = ashr exact i64 %228, 32
  %230 = getelementptr i8, ptr %203, i64 %227
  %231 = icmp eq i64 %228, 0
  br i1 %231, label %240, label %232

232:                                              ; preds = %215, %232
  %233 = phi i64 [ %238, %232 ], [ 0, %215 ]
  %234 = lshr i64 %229, %233
  %235 = trunc i64 %234 to i8
  %236 = and i8 %235, 1
  %237 = getelementptr inbounds i8, ptr %230, i64 %233
  store i8 %236, ptr %237, align 1
  %238 = add nuw nsw i64 %233, 1
  %239 = icmp eq i64 %233, 0
  br i1 %239, label %232, label %240, !llvm.loop !12

240:                                              ; preds = %232, %215
  %241 = select i1 %211, i1 %206, i1 false
  %242 = select i1 %241, i64 %207, i64 %227
  %243 = icmp slt i64 %242, %185
  br i1 %243, label %208, label %244, !llvm.loop !13

244:                                              ; preds = %240, %197
  br label %598

245:                                              ; preds = %176
  %246 = select i1 %151, i1 %26, i1 false
  %247 = select i1 %246, i1 %22, i1 false
  br i1 %247, label %248, label %252

248:                                              ; preds = %245
  %249 = getelementptr inbounds i8, ptr %0, i64 120
  %250 = load i64, ptr %249, align 8
  %251 = icmp eq i64 %250, 1
  br label %252

252:                                              ; preds = %245, %248
  %253 = phi i1 [ %246, %245 ], [ %251, %248 ]
  br i1 %253, label %256, label %254

254:                                              ; preds = %252
  %255 = load i64, ptr %40, align 8
  br label %256

256:                                              ; preds = %254, %252
  %257 = phi i64 [ %255, %254 ], [ 1, %252 ]
  %258 = add nsw i64 %11, -2
  %259 = icmp sgt i64 %13, 0
  %260 = shl i64 %13, 4
  %261 = icmp sgt i64 %13, 1
  %262 = add nsw i64 %13, -2
  %263 = getelementptr inbounds i8, ptr %0, i64 120
  %264 = icmp sgt i64 %15, 0
  %265 = shl i64 %15, 4
  %266 = icmp sgt i64 %15, 1
  %267 = add nsw i64 %15, -2
  %268 = shl i64 %15, 4
  %269 = shl i64 %17, 4
  %270 = icmp slt i64 %13, 257
  %271 = icmp sgt i64 %13, 0
  %272 = icmp slt i64 %17, 257
  %273 = icmp sgt i64 %17, 0
  %274 = shl i64 %13, 4
  %275 = icmp sgt i64 %17, 0
  %276 = icmp sgt i64 %17, 1
  %277 = add nsw i64 %17, -2
  %278 = icmp sgt i64 %17, 0
  %279 = getelementptr i8, ptr %47, i64 16
  br label %280

280:                                              ; preds = %256, %587
  %281 = phi i64 [ 0, %256 ], [ %589, %587 ]
  %282 = phi <2 x i64> [ zeroinitializer, %256 ], [ %440, %587 ]
  %283 = sub nsw i64 %11, %281
  %284 = sdiv i64 %283, 2
  %285 = tail call i64 @llvm.smin.i64(i64 %257, i64 %284)
  %286 = icmp eq i64 %285, 0
  %287 = select i1 %286, i64 %258, i64 %281
  %288 = tail call i64 @llvm.umax.i64(i64 %285, i64 1)
  %289 = load i64, ptr %148, align 8
  %290 = mul nsw i64 %289, %287
  %291 = getelementptr inbounds double, ptr %2, i64 %290
  %292 = load i64, ptr %149, align 8
  %293 = icmp eq i64 %292, 1
  br i1 %293, label %297, label %294

294:                                              ; preds = %280
  br i1 %259, label %295, label %362

295:                                              ; preds = %294
  %296 = icmp sgt i64 %288, 0
  br label %343

297:                                              ; preds = %280
  %298 = icmp sgt i64 %288, 0
  br i1 %298, label %299, label %362

299:                                              ; preds = %297
  %300 = shl i64 %289, 1
  br label %301

301:                                              ; preds = %299, %340
  %302 = phi i64 [ 0, %299 ], [ %341, %340 ]
  %303 = mul i64 %300, %302
  %304 = getelementptr inbounds double, ptr %291, i64 %303
  %305 = mul i64 %260, %302
  %306 = getelementptr inbounds i8, ptr %39, i64 %305
  br i1 %261, label %307, label %309

307:                                              ; preds = %301
  %308 = getelementptr i8, ptr %306, i64 16
  br label %312

309:                                              ; preds = %312, %301
  %310 = phi i64 [ 0, %301 ], [ %325, %312 ]
  %311 = icmp slt i64 %310, %13
  br i1 %311, label %328, label %340

312:                                              ; preds = %307, %312
  %313 = phi i64 [ %325, %312 ], [ 0, %307 ]
  %314 = tail call i64 @llvm.smin.i64(i64 %313, i64 %262)
  %315 = getelementptr double, ptr %304, i64 %314
  %316 = load <2 x double>, ptr %315, align 8
  %317 = getelementptr double, ptr %315, i64 %289
  %318 = load <2 x double>, ptr %317, align 8
  %319 = shufflevector <2 x double> %316, <2 x double> %318, <2 x i32> <i32 1, i32 3>
  %320 = shufflevector <2 x double> %316, <2 x double> %318, <2 x i32> <i32 0, i32 2>
  %321 = shl nsw i64 %314, 4
  %322 = getelementptr inbounds i8, ptr %306, i64 %321
  store <2 x double> %320, ptr %322, align 8
  %323 = shl i64 %314, 4
  %324 = getelementptr i8, ptr %308, i64 %323
  store <2 x double> %319, ptr %324, align 8
  %325 = add nsw i64 %314, 2
  %326 = icmp slt i64 %325, %13
  %327 = select i1 %261, i1 %326, i1 false
  br i1 %327, label %312, label %309, !llvm.loop !14

328:                                              ; preds = %309, %328
  %329 = phi i64 [ %338, %328 ], [ %310, %309 ]
  %330 = getelementptr double, ptr %304, i64 %329
  %331 = load double, ptr %330, align 8
  %332 = insertelement <2 x double> poison, double %331, i64 0
  %333 = getelementptr double, ptr %330, i64 %289
  %334 = load double, ptr %333, align 8
  %335 = insertelement <2 x double> %332, double %334, i64 1
  %336 = shl nsw i64 %329, 4
  %337 = getelementptr inbounds i8, ptr %306, i64 %336
  store <2 x double> %335, ptr %337, align 8
  %338 = add nsw i64 %329, 1
  %339 = icmp eq i64 %338, %13
  br i1 %339, label %340, label %328, !llvm.loop !15

340:                                              ; preds = %328, %309
  %341 = add nuw nsw i64 %302, 1
  %342 = icmp eq i64 %341, %288
  br i1 %342, label %362, label %301, !llvm.loop !16

343:                                              ; preds = %295, %348
  %344 = phi i64 [ 0, %295 ], [ %349, %348 ]
  br i1 %296, label %345, label %348

345:                                              ; preds = %343
  %346 = mul nsw i64 %344, %292
  %347 = getelementptr inbounds double, ptr %291, i64 %346
  br label %351

348:                                              ; preds = %351, %343
  %349 = add nuw nsw i64 %344, 1
  %350 = icmp eq i64 %349, %13
  br i1 %350, label %362, label %343, !llvm.loop !17

351:                                              ; preds = %345, %351
  %352 = phi i64 [ 0, %345 ], [ %360, %351 ]
  %353 = shl nsw i64 %352, 4
  %354 = getelementptr inbounds i8, ptr %347, i64 %353
  %355 = load <2 x double>, ptr %354, align 8
  %356 = mul nuw nsw i64 %352, %13
  %357 = add nuw nsw i64 %356, %344
  %358 = shl nsw i64 %357, 4
  %359 = getelementptr inbounds i8, ptr %39, i64 %358
  store <2 x double> %355, ptr %359, align 16
  %360 = add nuw nsw i64 %352, 1
  %361 = icmp eq i64 %360, %288
  br i1 %361, label %348, label %351, !llvm.loop !18

362:                                              ; preds = %348, %340, %294, %297
  br i1 %22, label %363, label %437

363:                                              ; preds = %362
  %364 = load i64, ptr %18, align 8
  %365 = mul nsw i64 %364, %287
  %366 = getelementptr inbounds double, ptr %3, i64 %365
  %367 = load i64, ptr %263, align 8
  %368 = icmp eq i64 %367, 1
  br i1 %368, label %372, label %369

369:                                              ; preds = %363
  br i1 %264, label %370, label %437

370:                                              ; preds = %369
  %371 = icmp sgt i64 %288, 0
  br label %418

372:                                              ; preds = %363
  %373 = icmp sgt i64 %288, 0
  br i1 %373, label %374, label %437

374:                                              ; preds = %372
  %375 = shl i64 %364, 1
  br label %376

376:                                              ; preds = %374, %415
  %377 = phi i64 [ 0, %374 ], [ %416, %415 ]
  %378 = mul i64 %375, %377
  %379 = getelementptr inbounds double, ptr %366, i64 %378
  %380 = mul i64 %265, %377
  %381 = getelementptr inbounds i8, ptr %44, i64 %380
  br i1 %266, label %382, label %384

382:                                              ; preds = %376
  %383 = getelementptr i8, ptr %381, i64 16
  br label %387

384:                                              ; preds = %387, %376
  %385 = phi i64 [ 0, %376 ], [ %400, %387 ]
  %386 = icmp slt i64 %385, %15
  br i1 %386, label %403, label %415

387:                                              ; preds = %382, %387
  %388 = phi i64 [ %400, %387 ], [ 0, %382 ]
  %389 = tail call i64 @llvm.smin.i64(i64 %388, i64 %267)
  %390 = getelementptr double, ptr %379, i64 %389
  %391 = load <2 x double>, ptr %390, align 8
  %392 = getelementptr double, ptr %390, i64 %364
  %393 = load <2 x double>, ptr %392, align 8
  %394 = shufflevector <2 x double> %391, <2 x double> %393, <2 x i32> <i32 1, i32 3>
  %395 = shufflevector <2 x double> %391, <2 x double> %393, <2 x i32> <i32 0, i32 2>
  %396 = shl nsw i64 %389, 4
  %397 = getelementptr inbounds i8, ptr %381, i64 %396
  store <2 x double> %395, ptr %397, align 8
  %398 = shl i64 %389, 4
  %399 = getelementptr i8, ptr %383, i64 %398
  store <2 x double> %394, ptr %399, align 8
  %400 = add nsw i64 %389, 2
  %401 = icmp slt i64 %400, %15
  %402 = select i1 %266, i1 %401, i1 false
  br i1 %402, label %387, label %384, !llvm.loop !14

403:                                              ; preds = %384, %403
  %404 = phi i64 [ %413, %403 ], [ %385, %384 ]
  %405 = getelementptr double, ptr %379, i64 %404
  %406 = load double, ptr %405, align 8
  %407 = insertelement <2 x double> poison, double %406, i64 0
  %408 = getelementptr double, ptr %405, i64 %364
  %409 = load double, ptr %408, align 8
  %410 = insertelement <2 x double> %407, double %409, i64 1
  %411 = shl nsw i64 %404, 4
  %412 = getelementptr inbounds i8, ptr %381, i64 %411
  store <2 x double> %410, ptr %412, align 8
  %413 = add nsw i64 %404, 1
  %414 = icmp eq i64 %413, %15
  br i1 %414, label %415, label %403, !llvm.loop !15

415:                                              ; preds = %403, %384
  %416 = add nuw nsw i64 %377, 1
  %417 = icmp eq i64 %416, %288
  br i1 %417, label %437, label %376, !llvm.loop !16

418:                                              ; preds = %370, %423
  %419 = phi i64 [ 0, %370 ], [ %424, %423 ]
  br i1 %371, label %420, label %423

420:                                              ; preds = %418
  %421 = mul nsw i64 %419, %367
  %422 = getelementptr inbounds double, ptr %366, i64 %421
  br label %426

423:                                              ; preds = %426, %418
  %424 = add nuw nsw i64 %419, 1
  %425 = icmp eq i64 %424, %15
  br i1 %425, label %437, label %418, !llvm.loop !17

426:                                              ; preds = %420, %426
  %427 = phi i64 [ 0, %420 ], [ %435, %426 ]
  %428 = shl nsw i64 %427, 4
  %429 = getelementptr inbounds i8, ptr %422, i64 %428
  %430 = load <2 x double>, ptr %429, align 8
  %431 = mul nuw nsw i64 %427, %15
  %432 = add nuw nsw i64 %431, %419
  %433 = shl nsw i64 %432, 4
  %434 = getelementptr inbounds i8, ptr %44, i64 %433
  store <2 x double> %430, ptr %434, align 8
  %435 = add nuw nsw i64 %427, 1
  %436 = icmp eq i64 %435, %288
  br i1 %436, label %423, label %426, !llvm.loop !18

437:                                              ; preds = %423, %415, %369, %372, %362
  %438 = icmp sgt i64 %288, 0
  br i1 %438, label %441, label %439

439:                                              ; preds = %560, %437
  %440 = phi <2 x i64> [ %282, %437 ], [ %525, %560 ]
  br i1 %26, label %587, label %563

441:                                              ; preds = %437, %560
  %442 = phi i64 [ %561, %560 ], [ 0, %437 ]
  %443 = phi <2 x i64> [ %525, %560 ], [ %282, %437 ]
  %444 = shl nuw nsw i64 %442, 1
  %445 = add nsw i64 %444, %287
  %446 = mul i64 %268, %442
  %447 = select i1 %20, i64 %446, i64 0
  %448 = getelementptr inbounds i8, ptr %44, i64 %447
  %449 = mul i64 %269, %442
  %450 = select i1 %26, i64 0, i64 %449
  %451 = getelementptr inbounds i8, ptr %47, i64 %450
  %452 = add nsw i64 %445, 4
  %453 = icmp sle i64 %452, %11
  %454 = select i1 %26, i1 %453, i1 false
  br i1 %454, label %455, label %495

455:                                              ; preds = %441
  %456 = add nsw i64 %445, 2
  %457 = load i64, ptr %149, align 8
  %458 = icmp eq i64 %457, 1
  %459 = select i1 %458, i1 %270, i1 false
  br i1 %459, label %460, label %477

460:                                              ; preds = %455, %468
  %461 = phi i64 [ %469, %468 ], [ 0, %455 ]
  br i1 %271, label %462, label %468

462:                                              ; preds = %460
  %463 = load i64, ptr %148, align 8
  %464 = mul nsw i64 %463, %456
  %465 = getelementptr inbounds double, ptr %2, i64 %464
  %466 = mul nuw nsw i64 %463, %461
  %467 = getelementptr inbounds double, ptr %465, i64 %466
  br label %472

468:                                              ; preds = %472, %460
  %469 = add nuw nsw i64 %461, 1
  %470 = icmp eq i64 %461, 0
  %471 = select i1 %270, i1 %470, i1 false
  br i1 %471, label %460, label %477, !llvm.loop !19

472:                                              ; preds = %462, %472
  %473 = phi i64 [ 0, %462 ], [ %475, %472 ]
  %474 = getelementptr inbounds double, ptr %467, i64 %473
  tail call void @llvm.prefetch.p0(ptr %474, i32 0, i32 3, i32 1)
  %475 = add nuw nsw i64 %473, 8
  %476 = icmp slt i64 %475, %13
  br i1 %476, label %472, label %468, !llvm.loop !20

477:                                              ; preds = %468, %455
  br i1 %272, label %478, label %495

478:                                              ; preds = %477, %486
  %479 = phi i64 [ %487, %486 ], [ 0, %477 ]
  br i1 %273, label %480, label %486

480:                                              ; preds = %478
  %481 = load i64, ptr %23, align 8
  %482 = mul nsw i64 %481, %456
  %483 = getelementptr inbounds double, ptr %5, i64 %482
  %484 = mul nuw nsw i64 %481, %479
  %485 = getelementptr inbounds double, ptr %483, i64 %484
  br label %490

486:                                              ; preds = %490, %478
  %487 = add nuw nsw i64 %479, 1
  %488 = icmp eq i64 %479, 0
  %489 = select i1 %272, i1 %488, i1 false
  br i1 %489, label %478, label %495, !llvm.loop !21

490:                                              ; preds = %480, %490
  %491 = phi i64 [ 0, %480 ], [ %493, %490 ]
  %492 = getelementptr inbounds double, ptr %485, i64 %491
  tail call void @llvm.prefetch.p0(ptr %492, i32 1, i32 3, i32 1)
  %493 = add nuw nsw i64 %491, 8
  %494 = icmp slt i64 %493, %17
  br i1 %494, label %490, label %486, !llvm.loop !22

495:                                              ; preds = %486, %477, %441
  %496 = load ptr, ptr %0, align 8
  %497 = getelementptr inbounds double, ptr %1, i64 %445
  %498 = mul i64 %274, %442
  %499 = getelementptr inbounds i8, ptr %39, i64 %498
  %500 = tail call i32 %496(ptr noundef %497, ptr noundef nonnull %499, ptr noundef nonnull %448, ptr noundef %34, ptr noundef nonnull %451) #4
  %501 = sext i32 %500 to i64
  %502 = getelementptr inbounds i8, ptr %6, i64 %445
  %503 = icmp eq i32 %500, 0
  br i1 %503, label %512, label %504

504:                                              ; preds = %495, %504
  %505 = phi i64 [ %510, %504 ], [ 0, %495 ]
  %506 = lshr i64 %501, %505
  %507 = trunc i64 %506 to i8
  %508 = and i8 %507, 1
  %509 = getelementptr inbounds i8, ptr %502, i64 %505
  store i8 %508, ptr %509, align 1
  %510 = add nuw nsw i64 %505, 1
  %511 = icmp eq i64 %505, 0
  br i1 %511, label %504, label %512, !llvm.loop !12

512:                                              ; preds = %504, %495
  br i1 %275, label %513, label %524

513:                                              ; preds = %512, %513
  %514 = phi <2 x i64> [ %521, %513 ], [ %443, %512 ]
  %515 = phi i64 [ %522, %513 ], [ 0, %512 ]
  %516 = shl nsw i64 %515, 4
  %517 = getelementptr inbounds i8, ptr %451, i64 %516
  %518 = load <2 x double>, ptr %517, align 8
  %519 = fsub <2 x double> %518, %518
  %520 = bitcast <2 x double> %519 to <2 x i64>
  %521 = or <2 x i64> %514, %520
  %522 = add nuw nsw i64 %515, 1
  %523 = icmp eq i64 %522, %17
  br i1 %523, label %524, label %513, !llvm.loop !23

524:                                              ; preds = %513, %512
  %525 = phi <2 x i64> [ %443, %512 ], [ %521, %513 ]
  br i1 %26, label %526, label %560

526:                                              ; preds = %524
  %527 = load i64, ptr %23, align 8
  %528 = mul nsw i64 %527, %445
  %529 = getelementptr inbounds double, ptr %5, i64 %528
  br i1 %276, label %533, label %530

530:                                              ; preds = %533, %526
  %531 = phi i64 [ 0, %526 ], [ %546, %533 ]
  %532 = icmp slt i64 %531, %17
  br i1 %532, label %549, label %560

533:                                              ; preds = %526, %533
  %534 = phi i64 [ %546, %533 ], [ 0, %526 ]
  %535 = tail call i64 @llvm.smin.i64(i64 %534, i64 %277)
  %536 = getelementptr double, ptr %529, i64 %535
  %537 = shl nsw i64 %535, 4
  %538 = getelementptr inbounds i8, ptr %47, i64 %537
  %539 = load <2 x double>, ptr %538, align 8
  %540 = shl i64 %535, 4
  %541 = getelementptr i8, ptr %279, i64 %540
  %542 = load <2 x double>, ptr %541, align 8
  %543 = shufflevector <2 x double> %539, <2 x double> %542, <2 x i32> <i32 1, i32 3>
  %544 = shufflevector <2 x double> %539, <2 x double> %542, <2 x i32> <i32 0, i32 2>
  store <2 x double> %544, ptr %536, align 8
  %545 = getelementptr double, ptr %536, i64 %527
  store <2 x double> %543, ptr %545, align 8
  %546 = add nsw i64 %535, 2
  %547 = icmp slt i64 %546, %17
  %548 = select i1 %276, i1 %547, i1 false
  br i1 %548, label %533, label %530, !llvm.loop !24

549:                                              ; preds = %530, %549
  %550 = phi i64 [ %558, %549 ], [ %531, %530 ]
  %551 = getelementptr double, ptr %529, i64 %550
  %552 = shl nsw i64 %550, 4
  %553 = getelementptr inbounds i8, ptr %47, i64 %552
  %554 = load <2 x double>, ptr %553, align 8
  %555 = extractelement <2 x double> %554, i64 0
  store double %555, ptr %551, align 8
  %556 = extractelement <2 x double> %554, i64 1
  %557 = getelementptr double, ptr %551, i64 %527
  store double %556, ptr %557, align 8
  %558 = add nsw i64 %550, 1
  %559 = icmp eq i64 %558, %17
  br i1 %559, label %560, label %549, !llvm.loop !25

560:                                              ; preds = %549, %530, %524
  %561 = add nuw nsw i64 %442, 1
  %562 = icmp eq i64 %561, %288
  br i1 %562, label %439, label %441, !llvm.loop !26

563:                                              ; preds = %439
  %564 = load i64, ptr %24, align 8
  %565 = getelementptr inbounds double, ptr %5, i64 %287
  br i1 %278, label %566, label %587

566:                                              ; preds = %563
  %567 = icmp sgt i64 %288, 0
  br label %568

568:                                              ; preds = %566, %573
  %569 = phi i64 [ 0, %566 ], [ %574, %573 ]
  br i1 %567, label %570, label %573

570:                                              ; preds = %568
  %571 = mul nsw i64 %569, %564
  %572 = getelementptr inbounds double, ptr %565, i64 %571
  br label %576

573:                                              ; preds = %576, %568
  %574 = add nuw nsw i64 %569, 1
  %575 = icmp eq i64 %574, %17
  br i1 %575, label %587, label %568, !llvm.loop !27

576:                                              ; preds = %570, %576
  %577 = phi i64 [ 0, %570 ], [ %585, %576 ]
  %578 = mul nuw nsw i64 %577, %17
  %579 = add nuw nsw i64 %578, %569
  %580 = shl nsw i64 %579, 4
  %581 = getelementptr inbounds i8, ptr %47, i64 %580
  %582 = load <2 x double>, ptr %581, align 8
  %583 = shl nsw i64 %577, 4
  %584 = getelementptr inbounds i8, ptr %572, i64 %583
  store <2 x double> %582, ptr %584, align 8
  %585 = add nuw nsw i64 %577, 1
  %586 = icmp eq i64 %585, %288
  br i1 %586, label %573, label %576, !llvm.loop !28

587:                                              ; preds = %573, %563, %439
  %588 = shl nsw i64 %288, 1
  %589 = add nsw i64 %287, %588
  %590 = icmp slt i64 %589, %11
  br i1 %590, label %280, label %591, !llvm.loop !29

591:                                              ; preds = %587
  %592 = extractelement <2 x i64> %440, i64 0
  %593 = icmp eq i64 %592, 0
  %594 = extractelement <2 x i64> %440, i64 1
  %595 = icmp eq i64 %594, 0
  %596 = select i1 %595, i1 %593, i1 false
  %597 = zext i1 %596 to i64
  br label %598

598:                                              ; preds = %137, %102, %244, %591, %8
  %599 = phi i64 [ 1, %8 ], [ 0, %244 ], [ %597, %591 ], [ 0, %102 ], [ 0, %137 ]
  ret i64 %599
}



declare void @llvm.prefetch.p0(ptr readonly, i32 immarg, i32 immarg, i32 immarg) #2

declare i64 @llvm.smin.i64(i64, i64) #3

declare i64 @llvm.smax.i64(i64, i64) #3

declare i64 @llvm.umax.i64(i64, i64) #3

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { nounwind willreturn }
attributes #3 = { nounwind willreturn memory(none) }
attributes #4 = { nounwind }
attributes #5 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = distinct !{!3, !4, !5}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
!6 = distinct !{!6, !4, !5}
!7 = distinct !{!7, !4, !5, !8}
!8 = !{!"llvm.loop.vectorize.width", i32 1}
!9 = distinct !{!9, !4, !5}
!10 = distinct !{!10, !4, !5, !8}
!11 = distinct !{!11, !4, !5, !8}
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
!25 = distinct !{!25, !4, !5}
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5}
!29 = distinct !{!29, !4, !5}
