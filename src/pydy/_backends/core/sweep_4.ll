; sources 6534ce7d3df6456615221344b30099460c48ea2a1ef103dcf71592ec8b302bc6
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define void @sweep_4(ptr noundef readonly %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, ptr noundef readonly %4, ptr noundef %5, ptr noundef writeonly %6, ptr noundef %7) #0 {
  %9 = alloca [5 x i64], align 16
  %10 = getelementptr inbounds i8, ptr %0, i64 72
  %11 = load i64, ptr %10, align 8
  %12 = add nsw i64 %11, -4
  %13 = getelementptr inbounds i8, ptr %0, i64 80
  %14 = load i64, ptr %13, align 8
  %15 = icmp eq i64 %14, 0
  %16 = getelementptr inbounds i8, ptr %0, i64 88
  %17 = load i64, ptr %16, align 8
  %18 = ptrtoint ptr %7 to i64
  %19 = add i64 %18, 63
  %20 = and i64 %19, -64
  %21 = inttoptr i64 %20 to ptr
  %22 = getelementptr inbounds i8, ptr %0, i64 48
  %23 = load i64, ptr %22, align 8
  %24 = shl nsw i64 %23, 5
  %25 = getelementptr inbounds i8, ptr %21, i64 %24
  %26 = getelementptr inbounds i8, ptr %0, i64 56
  %27 = load i64, ptr %26, align 8
  %28 = shl nsw i64 %27, 5
  %29 = getelementptr inbounds i8, ptr %25, i64 %28
  %30 = getelementptr inbounds i8, ptr %29, i64 32
  %31 = getelementptr inbounds i8, ptr %0, i64 32
  %32 = load i64, ptr %31, align 8
  %33 = shl nsw i64 %32, 5
  %34 = getelementptr inbounds i8, ptr %30, i64 %33
  %35 = getelementptr inbounds i8, ptr %0, i64 40
  %36 = load i64, ptr %35, align 8
  %37 = shl nsw i64 %36, 5
  %38 = getelementptr inbounds i8, ptr %34, i64 %37
  %39 = icmp slt i64 %11, 1
  br i1 %39, label %441, label %40

40:                                               ; preds = %8
  %41 = icmp sgt i64 %23, 0
  br i1 %41, label %42, label %56

42:                                               ; preds = %40, %47
  %43 = phi i64 [ %48, %47 ], [ 0, %40 ]
  %44 = getelementptr inbounds double, ptr %4, i64 %43
  %45 = shl nsw i64 %43, 5
  %46 = getelementptr inbounds i8, ptr %21, i64 %45
  br label %50

47:                                               ; preds = %50
  %48 = add nuw nsw i64 %43, 1
  %49 = icmp eq i64 %48, %23
  br i1 %49, label %56, label %42, !llvm.loop !3

50:                                               ; preds = %42, %50
  %51 = phi i64 [ 0, %42 ], [ %54, %50 ]
  %52 = load double, ptr %44, align 8
  %53 = getelementptr inbounds double, ptr %46, i64 %51
  store double %52, ptr %53, align 8
  %54 = add nuw nsw i64 %51, 1
  %55 = icmp eq i64 %54, 4
  br i1 %55, label %47, label %50, !llvm.loop !6

56:                                               ; preds = %47, %40
  %57 = getelementptr inbounds i8, ptr %0, i64 8
  %58 = load ptr, ptr %57, align 8
  tail call void %58(ptr noundef %21, ptr noundef %25) #3
  br i1 %15, label %59, label %76

59:                                               ; preds = %56
  %60 = load i64, ptr %35, align 8
  %61 = icmp sgt i64 %60, 0
  br i1 %61, label %62, label %76

62:                                               ; preds = %59, %67
  %63 = phi i64 [ %68, %67 ], [ 0, %59 ]
  %64 = getelementptr inbounds double, ptr %3, i64 %63
  %65 = shl nsw i64 %63, 5
  %66 = getelementptr inbounds i8, ptr %34, i64 %65
  br label %70

67:                                               ; preds = %70
  %68 = add nuw nsw i64 %63, 1
  %69 = icmp eq i64 %68, %60
  br i1 %69, label %76, label %62, !llvm.loop !3

70:                                               ; preds = %62, %70
  %71 = phi i64 [ 0, %62 ], [ %74, %70 ]
  %72 = load double, ptr %64, align 8
  %73 = getelementptr inbounds double, ptr %66, i64 %71
  store double %72, ptr %73, align 8
  %74 = add nuw nsw i64 %71, 1
  %75 = icmp eq i64 %74, 4
  br i1 %75, label %67, label %70, !llvm.loop !6

76:                                               ; preds = %67, %59, %56
  %77 = icmp slt i64 %11, 4
  br i1 %77, label %78, label %171

78:                                               ; preds = %76
  %79 = add nsw i64 %11, -1
  %80 = icmp eq i64 %17, 0
  %81 = select i1 %80, i64 1, i64 %11
  br label %101

82:                                               ; preds = %132
  %83 = load ptr, ptr %0, align 8
  %84 = tail call i32 %83(ptr noundef %29, ptr noundef nonnull %30, ptr noundef nonnull %34, ptr noundef %25, ptr noundef nonnull %38) #3
  %85 = sext i32 %84 to i64
  %86 = icmp eq i32 %84, 0
  br i1 %86, label %97, label %87

87:                                               ; preds = %82
  %88 = tail call i64 @llvm.smax.i64(i64 %11, i64 1)
  br label %89

89:                                               ; preds = %87, %89
  %90 = phi i64 [ %95, %89 ], [ 0, %87 ]
  %91 = lshr i64 %85, %90
  %92 = trunc i64 %91 to i8
  %93 = and i8 %92, 1
  %94 = getelementptr inbounds i8, ptr %6, i64 %90
  store i8 %93, ptr %94, align 1
  %95 = add nuw nsw i64 %90, 1
  %96 = icmp eq i64 %95, %88
  br i1 %96, label %97, label %89, !llvm.loop !7

97:                                               ; preds = %89, %82
  %98 = getelementptr inbounds i8, ptr %0, i64 64
  %99 = icmp eq i64 %17, 0
  %100 = tail call i64 @llvm.smax.i64(i64 %11, i64 1)
  br label %145

101:                                              ; preds = %78, %132
  %102 = phi i64 [ 0, %78 ], [ %133, %132 ]
  %103 = tail call i64 @llvm.smin.i64(i64 %102, i64 %79)
  %104 = getelementptr inbounds double, ptr %1, i64 %103
  %105 = load double, ptr %104, align 8
  %106 = getelementptr inbounds double, ptr %29, i64 %102
  store double %105, ptr %106, align 8
  %107 = load i64, ptr %31, align 8
  %108 = icmp sgt i64 %107, 0
  br i1 %108, label %109, label %111

109:                                              ; preds = %101
  %110 = getelementptr inbounds double, ptr %30, i64 %102
  br label %114

111:                                              ; preds = %114, %101
  br i1 %15, label %132, label %112

112:                                              ; preds = %111
  %113 = getelementptr inbounds double, ptr %34, i64 %102
  br label %128

114:                                              ; preds = %109, %114
  %115 = phi i64 [ %126, %114 ], [ %107, %109 ]
  %116 = phi i64 [ %125, %114 ], [ 0, %109 ]
  %117 = select i1 %80, i64 %115, i64 1
  %118 = mul nsw i64 %117, %103
  %119 = mul nuw nsw i64 %116, %81
  %120 = getelementptr double, ptr %2, i64 %118
  %121 = getelementptr double, ptr %120, i64 %119
  %122 = load double, ptr %121, align 8
  %123 = shl nsw i64 %116, 5
  %124 = getelementptr inbounds i8, ptr %110, i64 %123
  store double %122, ptr %124, align 8
  %125 = add nuw nsw i64 %116, 1
  %126 = load i64, ptr %31, align 8
  %127 = icmp slt i64 %125, %126
  br i1 %127, label %114, label %111, !llvm.loop !8

128:                                              ; preds = %112, %135
  %129 = phi i64 [ %144, %135 ], [ 0, %112 ]
  %130 = load i64, ptr %35, align 8
  %131 = icmp slt i64 %129, %130
  br i1 %131, label %135, label %132

132:                                              ; preds = %128, %135, %111
  %133 = add nuw nsw i64 %102, 1
  %134 = icmp eq i64 %133, 4
  br i1 %134, label %82, label %101, !llvm.loop !10

135:                                              ; preds = %128
  %136 = select i1 %80, i64 %130, i64 1
  %137 = mul nsw i64 %136, %103
  %138 = mul nuw nsw i64 %129, %81
  %139 = getelementptr double, ptr %3, i64 %137
  %140 = getelementptr double, ptr %139, i64 %138
  %141 = load double, ptr %140, align 8
  %142 = shl nsw i64 %129, 5
  %143 = getelementptr inbounds i8, ptr %113, i64 %142
  store double %141, ptr %143, align 8
  %144 = add nuw nsw i64 %129, 1
  br i1 %15, label %132, label %128, !llvm.loop !11

145:                                              ; preds = %97, %150
  %146 = phi i64 [ 0, %97 ], [ %151, %150 ]
  %147 = getelementptr inbounds double, ptr %38, i64 %146
  %148 = load i64, ptr %98, align 8
  %149 = icmp sgt i64 %148, 0
  br i1 %149, label %153, label %150

150:                                              ; preds = %165, %145
  %151 = add nuw nsw i64 %146, 1
  %152 = icmp eq i64 %151, %100
  br i1 %152, label %441, label %145, !llvm.loop !12

153:                                              ; preds = %145, %165
  %154 = phi i64 [ %169, %165 ], [ %148, %145 ]
  %155 = phi i64 [ %168, %165 ], [ 0, %145 ]
  %156 = shl nsw i64 %155, 5
  %157 = getelementptr inbounds i8, ptr %147, i64 %156
  %158 = load double, ptr %157, align 8
  br i1 %99, label %162, label %159

159:                                              ; preds = %153
  %160 = mul nuw nsw i64 %155, %11
  %161 = add nuw nsw i64 %160, %146
  br label %165

162:                                              ; preds = %153
  %163 = mul nsw i64 %154, %146
  %164 = add nsw i64 %163, %155
  br label %165

165:                                              ; preds = %162, %159
  %166 = phi i64 [ %161, %159 ], [ %164, %162 ]
  %167 = getelementptr inbounds double, ptr %5, i64 %166
  store double %158, ptr %167, align 8
  %168 = add nuw nsw i64 %155, 1
  %169 = load i64, ptr %98, align 8
  %170 = icmp slt i64 %168, %169
  br i1 %170, label %153, label %150, !llvm.loop !13

171:                                              ; preds = %76
  %172 = icmp eq i64 %17, 0
  br i1 %172, label %173, label %184

173:                                              ; preds = %171
  %174 = getelementptr inbounds i8, ptr %0, i64 64
  %175 = getelementptr i8, ptr %30, i64 32
  %176 = getelementptr i8, ptr %30, i64 64
  %177 = getelementptr i8, ptr %30, i64 96
  %178 = getelementptr i8, ptr %34, i64 32
  %179 = getelementptr i8, ptr %34, i64 64
  %180 = getelementptr i8, ptr %34, i64 96
  %181 = getelementptr i8, ptr %38, i64 32
  %182 = getelementptr i8, ptr %38, i64 64
  %183 = getelementptr i8, ptr %38, i64 96
  br label %233

184:                                              ; preds = %171
  store i64 %11, ptr %9, align 16
  %185 = getelementptr inbounds i8, ptr %9, i64 8
  %186 = select i1 %15, i64 4, i64 %11
  store i64 %186, ptr %185, align 8
  %187 = getelementptr inbounds i8, ptr %9, i64 16
  store i64 %11, ptr %187, align 16
  %188 = getelementptr inbounds i8, ptr %9, i64 24
  store i64 1, ptr %188, align 8
  %189 = getelementptr inbounds i8, ptr %9, i64 32
  %190 = select i1 %15, i64 0, i64 4
  store i64 %190, ptr %189, align 16
  %191 = getelementptr i8, ptr %6, i64 -4
  %192 = ptrtoint ptr %2 to i64
  %193 = lshr i64 %192, 3
  %194 = and i64 %193, 3
  %195 = getelementptr inbounds i8, ptr %0, i64 16
  %196 = icmp ne i64 %11, 4
  %197 = sub nuw nsw i64 4, %194
  br label %199

198:                                              ; preds = %229
  br label %441

199:                                              ; preds = %184, %229
  %200 = phi i64 [ 0, %184 ], [ %231, %229 ]
  %201 = call i64 @llvm.smin.i64(i64 %200, i64 %12)
  %202 = icmp eq i64 %200, 0
  br i1 %202, label %206, label %203

203:                                              ; preds = %199
  %204 = sub nsw i64 %11, %201
  %205 = sdiv i64 %204, 4
  store i64 %205, ptr %188, align 8
  br label %206

206:                                              ; preds = %203, %199
  %207 = getelementptr inbounds double, ptr %3, i64 %201
  %208 = select i1 %15, ptr %34, ptr %207
  %209 = load ptr, ptr %195, align 8
  %210 = getelementptr inbounds double, ptr %1, i64 %201
  %211 = getelementptr inbounds double, ptr %2, i64 %201
  %212 = getelementptr inbounds double, ptr %5, i64 %201
  %213 = call i64 %209(ptr noundef %210, ptr noundef %211, ptr noundef %208, ptr noundef %25, ptr noundef %212, ptr noundef nonnull %9) #3
  %214 = ashr i64 %213, 30
  %215 = and i64 %214, -4
  %216 = add nsw i64 %215, %201
  %217 = shl i64 %213, 32
  %218 = ashr exact i64 %217, 32
  %219 = getelementptr i8, ptr %191, i64 %216
  %220 = icmp eq i64 %217, 0
  br i1 %220, label %229, label %221

221:                                              ; preds = %206, %221
  %222 = phi i64 [ %227, %221 ], [ 0, %206 ]
  %223 = lshr i64 %218, %222
  %224 = trunc i64 %223 to i8
  %225 = and i8 %224, 1
  %226 = getelementptr inbounds i8, ptr %219, i64 %222
  store i8 %225, ptr %226, align 1
  %227 = add nuw nsw i64 %222, 1
  %228 = icmp eq i64 %227, 4
  br i1 %228, label %229, label %221, !llvm.loop !7

229:                                              ; preds = %221, %206
  %230 = and i1 %196, %202
  %231 = select i1 %230, i64 %197, i64 %216
  %232 = icmp slt i64 %231, %11
  br i1 %232, label %199, label %198, !llvm.loop !14

233:                                              ; preds = %173, %438
  %234 = phi i64 [ 0, %173 ], [ %439, %438 ]
  %235 = tail call i64 @llvm.smin.i64(i64 %234, i64 %12)
  %236 = getelementptr inbounds double, ptr %1, i64 %235
  %237 = load <4 x double>, ptr %236, align 8
  store <4 x double> %237, ptr %29, align 32
  %238 = load i64, ptr %31, align 8
  %239 = mul nsw i64 %238, %235
  %240 = getelementptr inbounds double, ptr %2, i64 %239
  %241 = icmp sgt i64 %238, 3
  br i1 %241, label %242, label %246

242:                                              ; preds = %233
  %243 = add nsw i64 %238, -4
  %244 = shl i64 %238, 4
  %245 = mul i64 %238, 24
  br label %252

246:                                              ; preds = %252, %233
  %247 = phi i64 [ 0, %233 ], [ %279, %252 ]
  %248 = icmp slt i64 %247, %238
  br i1 %248, label %249, label %300

249:                                              ; preds = %246
  %250 = shl i64 %238, 4
  %251 = mul i64 %238, 24
  br label %282

252:                                              ; preds = %242, %252
  %253 = phi i64 [ 0, %242 ], [ %279, %252 ]
  %254 = tail call i64 @llvm.smin.i64(i64 %253, i64 %243)
  %255 = getelementptr double, ptr %240, i64 %254
  %256 = load <4 x double>, ptr %255, align 8
  %257 = getelementptr double, ptr %255, i64 %238
  %258 = load <4 x double>, ptr %257, align 8
  %259 = shufflevector <4 x double> %256, <4 x double> %258, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %260 = getelementptr i8, ptr %255, i64 %244
  %261 = load <4 x double>, ptr %260, align 8
  %262 = getelementptr i8, ptr %255, i64 %245
  %263 = load <4 x double>, ptr %262, align 8
  %264 = shufflevector <4 x double> %261, <4 x double> %263, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %265 = shufflevector <4 x double> %259, <4 x double> %264, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %266 = shufflevector <4 x double> %256, <4 x double> %258, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %267 = shufflevector <4 x double> %261, <4 x double> %263, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %268 = shufflevector <4 x double> %266, <4 x double> %267, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %269 = shufflevector <4 x double> %259, <4 x double> %264, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %270 = shufflevector <4 x double> %266, <4 x double> %267, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %271 = shl nsw i64 %254, 5
  %272 = getelementptr inbounds i8, ptr %30, i64 %271
  store <4 x double> %270, ptr %272, align 32
  %273 = shl i64 %254, 5
  %274 = getelementptr i8, ptr %175, i64 %273
  store <4 x double> %269, ptr %274, align 8
  %275 = shl i64 %254, 5
  %276 = getelementptr i8, ptr %176, i64 %275
  store <4 x double> %268, ptr %276, align 8
  %277 = shl i64 %254, 5
  %278 = getelementptr i8, ptr %177, i64 %277
  store <4 x double> %265, ptr %278, align 8
  %279 = add nsw i64 %254, 4
  %280 = icmp slt i64 %279, %238
  %281 = select i1 %241, i1 %280, i1 false
  br i1 %281, label %252, label %246, !llvm.loop !15

282:                                              ; preds = %249, %282
  %283 = phi i64 [ %298, %282 ], [ %247, %249 ]
  %284 = getelementptr double, ptr %240, i64 %283
  %285 = load double, ptr %284, align 8
  %286 = insertelement <4 x double> poison, double %285, i64 0
  %287 = getelementptr double, ptr %284, i64 %238
  %288 = load double, ptr %287, align 8
  %289 = insertelement <4 x double> %286, double %288, i64 1
  %290 = getelementptr i8, ptr %284, i64 %250
  %291 = load double, ptr %290, align 8
  %292 = insertelement <4 x double> %289, double %291, i64 2
  %293 = getelementptr i8, ptr %284, i64 %251
  %294 = load double, ptr %293, align 8
  %295 = insertelement <4 x double> %292, double %294, i64 3
  %296 = shl nsw i64 %283, 5
  %297 = getelementptr inbounds i8, ptr %30, i64 %296
  store <4 x double> %295, ptr %297, align 32
  %298 = add nsw i64 %283, 1
  %299 = icmp eq i64 %298, %238
  br i1 %299, label %300, label %282, !llvm.loop !16

300:                                              ; preds = %282, %246
  br i1 %15, label %364, label %301

301:                                              ; preds = %300
  %302 = load i64, ptr %35, align 8
  %303 = mul nsw i64 %302, %235
  %304 = getelementptr inbounds double, ptr %3, i64 %303
  %305 = icmp sgt i64 %302, 3
  br i1 %305, label %306, label %310

306:                                              ; preds = %301
  %307 = add nsw i64 %302, -4
  %308 = shl i64 %302, 4
  %309 = mul i64 %302, 24
  br label %316

310:                                              ; preds = %316, %301
  %311 = phi i64 [ 0, %301 ], [ %343, %316 ]
  %312 = icmp slt i64 %311, %302
  br i1 %312, label %313, label %364

313:                                              ; preds = %310
  %314 = shl i64 %302, 4
  %315 = mul i64 %302, 24
  br label %346

316:                                              ; preds = %306, %316
  %317 = phi i64 [ 0, %306 ], [ %343, %316 ]
  %318 = tail call i64 @llvm.smin.i64(i64 %317, i64 %307)
  %319 = getelementptr double, ptr %304, i64 %318
  %320 = load <4 x double>, ptr %319, align 8
  %321 = getelementptr double, ptr %319, i64 %302
  %322 = load <4 x double>, ptr %321, align 8
  %323 = shufflevector <4 x double> %320, <4 x double> %322, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %324 = getelementptr i8, ptr %319, i64 %308
  %325 = load <4 x double>, ptr %324, align 8
  %326 = getelementptr i8, ptr %319, i64 %309
  %327 = load <4 x double>, ptr %326, align 8
  %328 = shufflevector <4 x double> %325, <4 x double> %327, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %329 = shufflevector <4 x double> %323, <4 x double> %328, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %330 = shufflevector <4 x double> %320, <4 x double> %322, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %331 = shufflevector <4 x double> %325, <4 x double> %327, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %332 = shufflevector <4 x double> %330, <4 x double> %331, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %333 = shufflevector <4 x double> %323, <4 x double> %328, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %334 = shufflevector <4 x double> %330, <4 x double> %331, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %335 = shl nsw i64 %318, 5
  %336 = getelementptr inbounds i8, ptr %34, i64 %335
  store <4 x double> %334, ptr %336, align 8
  %337 = shl i64 %318, 5
  %338 = getelementptr i8, ptr %178, i64 %337
  store <4 x double> %333, ptr %338, align 8
  %339 = shl i64 %318, 5
  %340 = getelementptr i8, ptr %179, i64 %339
  store <4 x double> %332, ptr %340, align 8
  %341 = shl i64 %318, 5
  %342 = getelementptr i8, ptr %180, i64 %341
  store <4 x double> %329, ptr %342, align 8
  %343 = add nsw i64 %318, 4
  %344 = icmp slt i64 %343, %302
  %345 = select i1 %305, i1 %344, i1 false
  br i1 %345, label %316, label %310, !llvm.loop !15

346:                                              ; preds = %313, %346
  %347 = phi i64 [ %362, %346 ], [ %311, %313 ]
  %348 = getelementptr double, ptr %304, i64 %347
  %349 = load double, ptr %348, align 8
  %350 = insertelement <4 x double> poison, double %349, i64 0
  %351 = getelementptr double, ptr %348, i64 %302
  %352 = load double, ptr %351, align 8
  %353 = insertelement <4 x double> %350, double %352, i64 1
  %354 = getelementptr i8, ptr %348, i64 %314
  %355 = load double, ptr %354, align 8
  %356 = insertelement <4 x double> %353, double %355, i64 2
  %357 = getelementptr i8, ptr %348, i64 %315
  %358 = load double, ptr %357, align 8
  %359 = insertelement <4 x double> %356, double %358, i64 3
  %360 = shl nsw i64 %347, 5
  %361 = getelementptr inbounds i8, ptr %34, i64 %360
  store <4 x double> %359, ptr %361, align 8
  %362 = add nsw i64 %347, 1
  %363 = icmp eq i64 %362, %302
  br i1 %363, label %364, label %346, !llvm.loop !16

364:                                              ; preds = %346, %310, %300
  %365 = load ptr, ptr %0, align 8
  %366 = tail call i32 %365(ptr noundef nonnull %29, ptr noundef nonnull %30, ptr noundef nonnull %34, ptr noundef %25, ptr noundef nonnull %38) #3
  %367 = sext i32 %366 to i64
  %368 = getelementptr inbounds i8, ptr %6, i64 %235
  %369 = icmp eq i32 %366, 0
  br i1 %369, label %378, label %370

370:                                              ; preds = %364, %370
  %371 = phi i64 [ %376, %370 ], [ 0, %364 ]
  %372 = lshr i64 %367, %371
  %373 = trunc i64 %372 to i8
  %374 = and i8 %373, 1
  %375 = getelementptr inbounds i8, ptr %368, i64 %371
  store i8 %374, ptr %375, align 1
  %376 = add nuw nsw i64 %371, 1
  %377 = icmp eq i64 %376, 4
  br i1 %377, label %378, label %370, !llvm.loop !7

378:                                              ; preds = %370, %364
  %379 = load i64, ptr %174, align 8
  %380 = mul nsw i64 %379, %235
  %381 = getelementptr inbounds double, ptr %5, i64 %380
  %382 = icmp sgt i64 %379, 3
  br i1 %382, label %383, label %387

383:                                              ; preds = %378
  %384 = add nsw i64 %379, -4
  %385 = shl i64 %379, 4
  %386 = mul i64 %379, 24
  br label %393

387:                                              ; preds = %393, %378
  %388 = phi i64 [ 0, %378 ], [ %420, %393 ]
  %389 = icmp slt i64 %388, %379
  br i1 %389, label %390, label %438

390:                                              ; preds = %387
  %391 = shl i64 %379, 4
  %392 = mul i64 %379, 24
  br label %423

393:                                              ; preds = %383, %393
  %394 = phi i64 [ 0, %383 ], [ %420, %393 ]
  %395 = tail call i64 @llvm.smin.i64(i64 %394, i64 %384)
  %396 = getelementptr double, ptr %381, i64 %395
  %397 = shl nsw i64 %395, 5
  %398 = getelementptr inbounds i8, ptr %38, i64 %397
  %399 = load <4 x double>, ptr %398, align 8
  %400 = shl i64 %395, 5
  %401 = getelementptr i8, ptr %181, i64 %400
  %402 = load <4 x double>, ptr %401, align 8
  %403 = shufflevector <4 x double> %399, <4 x double> %402, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %404 = shl i64 %395, 5
  %405 = getelementptr i8, ptr %182, i64 %404
  %406 = load <4 x double>, ptr %405, align 8
  %407 = shl i64 %395, 5
  %408 = getelementptr i8, ptr %183, i64 %407
  %409 = load <4 x double>, ptr %408, align 8
  %410 = shufflevector <4 x double> %406, <4 x double> %409, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %411 = shufflevector <4 x double> %403, <4 x double> %410, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %412 = shufflevector <4 x double> %399, <4 x double> %402, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %413 = shufflevector <4 x double> %406, <4 x double> %409, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %414 = shufflevector <4 x double> %412, <4 x double> %413, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %415 = shufflevector <4 x double> %403, <4 x double> %410, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %416 = shufflevector <4 x double> %412, <4 x double> %413, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  store <4 x double> %416, ptr %396, align 8
  %417 = getelementptr double, ptr %396, i64 %379
  store <4 x double> %415, ptr %417, align 8
  %418 = getelementptr i8, ptr %396, i64 %385
  store <4 x double> %414, ptr %418, align 8
  %419 = getelementptr i8, ptr %396, i64 %386
  store <4 x double> %411, ptr %419, align 8
  %420 = add nsw i64 %395, 4
  %421 = icmp slt i64 %420, %379
  %422 = select i1 %382, i1 %421, i1 false
  br i1 %422, label %393, label %387, !llvm.loop !17

423:                                              ; preds = %390, %423
  %424 = phi i64 [ %436, %423 ], [ %388, %390 ]
  %425 = getelementptr double, ptr %381, i64 %424
  %426 = shl nsw i64 %424, 5
  %427 = getelementptr inbounds i8, ptr %38, i64 %426
  %428 = load <4 x double>, ptr %427, align 8
  %429 = extractelement <4 x double> %428, i64 0
  store double %429, ptr %425, align 8
  %430 = extractelement <4 x double> %428, i64 1
  %431 = getelementptr double, ptr %425, i64 %379
  store double %430, ptr %431, align 8
  %432 = extractelement <4 x double> %428, i64 2
  %433 = getelementptr i8, ptr %425, i64 %391
  store double %432, ptr %433, align 8
  %434 = extractelement <4 x double> %428, i64 3
  %435 = getelementptr i8, ptr %425, i64 %392
  store double %434, ptr %435, align 8
  %436 = add nsw i64 %424, 1
  %437 = icmp eq i64 %436, %379
  br i1 %437, label %438, label %423, !llvm.loop !18

438:                                              ; preds = %423, %387
  %439 = add nuw nsw i64 %234, 4
  %440 = icmp slt i64 %439, %11
  br i1 %440, label %233, label %441, !llvm.loop !19

441:                                              ; preds = %438, %150, %198, %8
  ret void
}



declare i64 @llvm.smin.i64(i64, i64) #2

declare i64 @llvm.smax.i64(i64, i64) #2

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { nounwind willreturn memory(none) }
attributes #3 = { nounwind }
attributes #4 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = distinct !{!3, !4, !5}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
!6 = distinct !{!6, !4, !5}
!7 = distinct !{!7, !4, !5}
!8 = distinct !{!8, !4, !5, !9}
!9 = !{!"llvm.loop.vectorize.width", i32 1}
!10 = distinct !{!10, !4, !5}
!11 = distinct !{!11, !4, !5, !9}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5, !9}
!14 = distinct !{!14, !4, !5}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5}
!17 = distinct !{!17, !4, !5}
!18 = distinct !{!18, !4, !5}
!19 = distinct !{!19, !4, !5}
