; sources c2634c5a52b8c116c03b6cfa7361d2f07ffb1836ec715406549322423576c5ef
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define void @sweep_8(ptr noundef readonly %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, ptr noundef readonly %4, ptr noundef %5, ptr noundef writeonly %6, ptr noundef %7) #0 {
  %9 = alloca [5 x i64], align 16
  %10 = getelementptr inbounds i8, ptr %0, i64 72
  %11 = load i64, ptr %10, align 8
  %12 = add nsw i64 %11, -8
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
  %24 = shl nsw i64 %23, 6
  %25 = getelementptr inbounds i8, ptr %21, i64 %24
  %26 = getelementptr inbounds i8, ptr %0, i64 56
  %27 = load i64, ptr %26, align 8
  %28 = shl nsw i64 %27, 6
  %29 = getelementptr inbounds i8, ptr %25, i64 %28
  %30 = getelementptr inbounds i8, ptr %29, i64 64
  %31 = getelementptr inbounds i8, ptr %0, i64 32
  %32 = load i64, ptr %31, align 8
  %33 = shl nsw i64 %32, 6
  %34 = getelementptr inbounds i8, ptr %30, i64 %33
  %35 = getelementptr inbounds i8, ptr %0, i64 40
  %36 = load i64, ptr %35, align 8
  %37 = shl nsw i64 %36, 6
  %38 = getelementptr inbounds i8, ptr %34, i64 %37
  %39 = icmp slt i64 %11, 1
  br i1 %39, label %557, label %40

40:                                               ; preds = %8
  %41 = icmp sgt i64 %23, 0
  br i1 %41, label %42, label %56

42:                                               ; preds = %40, %47
  %43 = phi i64 [ %48, %47 ], [ 0, %40 ]
  %44 = getelementptr inbounds double, ptr %4, i64 %43
  %45 = shl nsw i64 %43, 6
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
  %55 = icmp eq i64 %54, 8
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
  %65 = shl nsw i64 %63, 6
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
  %75 = icmp eq i64 %74, 8
  br i1 %75, label %67, label %70, !llvm.loop !6

76:                                               ; preds = %67, %59, %56
  %77 = icmp slt i64 %11, 8
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
  %123 = shl nsw i64 %116, 6
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
  %134 = icmp eq i64 %133, 8
  br i1 %134, label %82, label %101, !llvm.loop !10

135:                                              ; preds = %128
  %136 = select i1 %80, i64 %130, i64 1
  %137 = mul nsw i64 %136, %103
  %138 = mul nuw nsw i64 %129, %81
  %139 = getelementptr double, ptr %3, i64 %137
  %140 = getelementptr double, ptr %139, i64 %138
  %141 = load double, ptr %140, align 8
  %142 = shl nsw i64 %129, 6
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
  br i1 %152, label %557, label %145, !llvm.loop !12

153:                                              ; preds = %145, %165
  %154 = phi i64 [ %169, %165 ], [ %148, %145 ]
  %155 = phi i64 [ %168, %165 ], [ 0, %145 ]
  %156 = shl nsw i64 %155, 6
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
  %175 = getelementptr i8, ptr %30, i64 64
  %176 = getelementptr i8, ptr %30, i64 128
  %177 = getelementptr i8, ptr %30, i64 192
  %178 = getelementptr i8, ptr %34, i64 64
  %179 = getelementptr i8, ptr %34, i64 128
  %180 = getelementptr i8, ptr %34, i64 192
  %181 = getelementptr i8, ptr %38, i64 64
  %182 = getelementptr i8, ptr %38, i64 128
  %183 = getelementptr i8, ptr %38, i64 192
  br label %233

184:                                              ; preds = %171
  store i64 %11, ptr %9, align 16
  %185 = getelementptr inbounds i8, ptr %9, i64 8
  %186 = select i1 %15, i64 8, i64 %11
  store i64 %186, ptr %185, align 8
  %187 = getelementptr inbounds i8, ptr %9, i64 16
  store i64 %11, ptr %187, align 16
  %188 = getelementptr inbounds i8, ptr %9, i64 24
  store i64 1, ptr %188, align 8
  %189 = getelementptr inbounds i8, ptr %9, i64 32
  %190 = select i1 %15, i64 0, i64 8
  store i64 %190, ptr %189, align 16
  %191 = getelementptr i8, ptr %6, i64 -8
  %192 = ptrtoint ptr %2 to i64
  %193 = lshr i64 %192, 3
  %194 = and i64 %193, 7
  %195 = getelementptr inbounds i8, ptr %0, i64 16
  %196 = icmp ne i64 %11, 8
  %197 = sub nuw nsw i64 8, %194
  br label %199

198:                                              ; preds = %229
  br label %557

199:                                              ; preds = %184, %229
  %200 = phi i64 [ 0, %184 ], [ %231, %229 ]
  %201 = call i64 @llvm.smin.i64(i64 %200, i64 %12)
  %202 = icmp eq i64 %200, 0
  br i1 %202, label %206, label %203

203:                                              ; preds = %199
  %204 = sub nsw i64 %11, %201
  %205 = sdiv i64 %204, 8
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
  %214 = ashr i64 %213, 29
  %215 = and i64 %214, -8
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
  %228 = icmp eq i64 %227, 8
  br i1 %228, label %229, label %221, !llvm.loop !7

229:                                              ; preds = %221, %206
  %230 = and i1 %196, %202
  %231 = select i1 %230, i64 %197, i64 %216
  %232 = icmp slt i64 %231, %11
  br i1 %232, label %199, label %198, !llvm.loop !14

233:                                              ; preds = %173, %554
  %234 = phi i64 [ 0, %173 ], [ %555, %554 ]
  %235 = tail call i64 @llvm.smin.i64(i64 %234, i64 %12)
  %236 = getelementptr inbounds double, ptr %1, i64 %235
  %237 = load <8 x double>, ptr %236, align 8
  store <8 x double> %237, ptr %29, align 64
  %238 = load i64, ptr %31, align 8
  %239 = mul nsw i64 %238, %235
  %240 = getelementptr inbounds double, ptr %2, i64 %239
  %241 = icmp sgt i64 %238, 3
  br i1 %241, label %242, label %250

242:                                              ; preds = %233
  %243 = add nsw i64 %238, -4
  %244 = shl i64 %238, 5
  %245 = mul i64 %238, 40
  %246 = mul i64 %238, 48
  %247 = mul i64 %238, 56
  %248 = shl i64 %238, 4
  %249 = mul i64 %238, 24
  br label %260

250:                                              ; preds = %260, %233
  %251 = phi i64 [ 0, %233 ], [ %307, %260 ]
  %252 = icmp slt i64 %251, %238
  br i1 %252, label %253, label %340

253:                                              ; preds = %250
  %254 = shl i64 %238, 4
  %255 = mul i64 %238, 24
  %256 = shl i64 %238, 5
  %257 = mul i64 %238, 40
  %258 = mul i64 %238, 48
  %259 = mul i64 %238, 56
  br label %310

260:                                              ; preds = %242, %260
  %261 = phi i64 [ 0, %242 ], [ %307, %260 ]
  %262 = tail call i64 @llvm.smin.i64(i64 %261, i64 %243)
  %263 = getelementptr double, ptr %240, i64 %262
  %264 = getelementptr i8, ptr %263, i64 %244
  %265 = load <4 x double>, ptr %264, align 8
  %266 = getelementptr i8, ptr %263, i64 %245
  %267 = load <4 x double>, ptr %266, align 8
  %268 = shufflevector <4 x double> %265, <4 x double> %267, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %269 = getelementptr i8, ptr %263, i64 %246
  %270 = load <4 x double>, ptr %269, align 8
  %271 = getelementptr i8, ptr %263, i64 %247
  %272 = load <4 x double>, ptr %271, align 8
  %273 = shufflevector <4 x double> %270, <4 x double> %272, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %274 = shufflevector <4 x double> %268, <4 x double> %273, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %275 = shufflevector <4 x double> %265, <4 x double> %267, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %276 = shufflevector <4 x double> %270, <4 x double> %272, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %277 = shufflevector <4 x double> %275, <4 x double> %276, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %278 = shufflevector <4 x double> %268, <4 x double> %273, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %279 = shufflevector <4 x double> %275, <4 x double> %276, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %280 = load <4 x double>, ptr %263, align 8
  %281 = getelementptr double, ptr %263, i64 %238
  %282 = load <4 x double>, ptr %281, align 8
  %283 = shufflevector <4 x double> %280, <4 x double> %282, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %284 = getelementptr i8, ptr %263, i64 %248
  %285 = load <4 x double>, ptr %284, align 8
  %286 = getelementptr i8, ptr %263, i64 %249
  %287 = load <4 x double>, ptr %286, align 8
  %288 = shufflevector <4 x double> %285, <4 x double> %287, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %289 = shufflevector <4 x double> %283, <4 x double> %288, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %290 = shufflevector <4 x double> %280, <4 x double> %282, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %291 = shufflevector <4 x double> %285, <4 x double> %287, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %292 = shufflevector <4 x double> %290, <4 x double> %291, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %293 = shufflevector <4 x double> %283, <4 x double> %288, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %294 = shufflevector <4 x double> %290, <4 x double> %291, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %295 = shufflevector <4 x double> %294, <4 x double> %279, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %296 = shl nsw i64 %262, 6
  %297 = getelementptr inbounds i8, ptr %30, i64 %296
  store <8 x double> %295, ptr %297, align 64
  %298 = shufflevector <4 x double> %293, <4 x double> %278, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %299 = shl i64 %262, 6
  %300 = getelementptr i8, ptr %175, i64 %299
  store <8 x double> %298, ptr %300, align 8
  %301 = shufflevector <4 x double> %292, <4 x double> %277, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %302 = shl i64 %262, 6
  %303 = getelementptr i8, ptr %176, i64 %302
  store <8 x double> %301, ptr %303, align 8
  %304 = shufflevector <4 x double> %289, <4 x double> %274, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %305 = shl i64 %262, 6
  %306 = getelementptr i8, ptr %177, i64 %305
  store <8 x double> %304, ptr %306, align 8
  %307 = add nsw i64 %262, 4
  %308 = icmp slt i64 %307, %238
  %309 = select i1 %241, i1 %308, i1 false
  br i1 %309, label %260, label %250, !llvm.loop !15

310:                                              ; preds = %253, %310
  %311 = phi i64 [ %338, %310 ], [ %251, %253 ]
  %312 = getelementptr double, ptr %240, i64 %311
  %313 = load double, ptr %312, align 8
  %314 = insertelement <8 x double> poison, double %313, i64 0
  %315 = getelementptr double, ptr %312, i64 %238
  %316 = load double, ptr %315, align 8
  %317 = insertelement <8 x double> %314, double %316, i64 1
  %318 = getelementptr i8, ptr %312, i64 %254
  %319 = load double, ptr %318, align 8
  %320 = insertelement <8 x double> %317, double %319, i64 2
  %321 = getelementptr i8, ptr %312, i64 %255
  %322 = load double, ptr %321, align 8
  %323 = insertelement <8 x double> %320, double %322, i64 3
  %324 = getelementptr i8, ptr %312, i64 %256
  %325 = load double, ptr %324, align 8
  %326 = insertelement <8 x double> %323, double %325, i64 4
  %327 = getelementptr i8, ptr %312, i64 %257
  %328 = load double, ptr %327, align 8
  %329 = insertelement <8 x double> %326, double %328, i64 5
  %330 = getelementptr i8, ptr %312, i64 %258
  %331 = load double, ptr %330, align 8
  %332 = insertelement <8 x double> %329, double %331, i64 6
  %333 = getelementptr i8, ptr %312, i64 %259
  %334 = load double, ptr %333, align 8
  %335 = insertelement <8 x double> %332, double %334, i64 7
  %336 = shl nsw i64 %311, 6
  %337 = getelementptr inbounds i8, ptr %30, i64 %336
  store <8 x double> %335, ptr %337, align 64
  %338 = add nsw i64 %311, 1
  %339 = icmp eq i64 %338, %238
  br i1 %339, label %340, label %310, !llvm.loop !16

340:                                              ; preds = %310, %250
  br i1 %15, label %444, label %341

341:                                              ; preds = %340
  %342 = load i64, ptr %35, align 8
  %343 = mul nsw i64 %342, %235
  %344 = getelementptr inbounds double, ptr %3, i64 %343
  %345 = icmp sgt i64 %342, 3
  br i1 %345, label %346, label %354

346:                                              ; preds = %341
  %347 = add nsw i64 %342, -4
  %348 = shl i64 %342, 5
  %349 = mul i64 %342, 40
  %350 = mul i64 %342, 48
  %351 = mul i64 %342, 56
  %352 = shl i64 %342, 4
  %353 = mul i64 %342, 24
  br label %364

354:                                              ; preds = %364, %341
  %355 = phi i64 [ 0, %341 ], [ %411, %364 ]
  %356 = icmp slt i64 %355, %342
  br i1 %356, label %357, label %444

357:                                              ; preds = %354
  %358 = shl i64 %342, 4
  %359 = mul i64 %342, 24
  %360 = shl i64 %342, 5
  %361 = mul i64 %342, 40
  %362 = mul i64 %342, 48
  %363 = mul i64 %342, 56
  br label %414

364:                                              ; preds = %346, %364
  %365 = phi i64 [ 0, %346 ], [ %411, %364 ]
  %366 = tail call i64 @llvm.smin.i64(i64 %365, i64 %347)
  %367 = getelementptr double, ptr %344, i64 %366
  %368 = getelementptr i8, ptr %367, i64 %348
  %369 = load <4 x double>, ptr %368, align 8
  %370 = getelementptr i8, ptr %367, i64 %349
  %371 = load <4 x double>, ptr %370, align 8
  %372 = shufflevector <4 x double> %369, <4 x double> %371, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %373 = getelementptr i8, ptr %367, i64 %350
  %374 = load <4 x double>, ptr %373, align 8
  %375 = getelementptr i8, ptr %367, i64 %351
  %376 = load <4 x double>, ptr %375, align 8
  %377 = shufflevector <4 x double> %374, <4 x double> %376, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %378 = shufflevector <4 x double> %372, <4 x double> %377, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %379 = shufflevector <4 x double> %369, <4 x double> %371, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %380 = shufflevector <4 x double> %374, <4 x double> %376, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %381 = shufflevector <4 x double> %379, <4 x double> %380, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %382 = shufflevector <4 x double> %372, <4 x double> %377, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %383 = shufflevector <4 x double> %379, <4 x double> %380, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %384 = load <4 x double>, ptr %367, align 8
  %385 = getelementptr double, ptr %367, i64 %342
  %386 = load <4 x double>, ptr %385, align 8
  %387 = shufflevector <4 x double> %384, <4 x double> %386, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %388 = getelementptr i8, ptr %367, i64 %352
  %389 = load <4 x double>, ptr %388, align 8
  %390 = getelementptr i8, ptr %367, i64 %353
  %391 = load <4 x double>, ptr %390, align 8
  %392 = shufflevector <4 x double> %389, <4 x double> %391, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %393 = shufflevector <4 x double> %387, <4 x double> %392, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %394 = shufflevector <4 x double> %384, <4 x double> %386, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %395 = shufflevector <4 x double> %389, <4 x double> %391, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %396 = shufflevector <4 x double> %394, <4 x double> %395, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %397 = shufflevector <4 x double> %387, <4 x double> %392, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %398 = shufflevector <4 x double> %394, <4 x double> %395, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %399 = shufflevector <4 x double> %398, <4 x double> %383, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %400 = shl nsw i64 %366, 6
  %401 = getelementptr inbounds i8, ptr %34, i64 %400
  store <8 x double> %399, ptr %401, align 8
  %402 = shufflevector <4 x double> %397, <4 x double> %382, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %403 = shl i64 %366, 6
  %404 = getelementptr i8, ptr %178, i64 %403
  store <8 x double> %402, ptr %404, align 8
  %405 = shufflevector <4 x double> %396, <4 x double> %381, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %406 = shl i64 %366, 6
  %407 = getelementptr i8, ptr %179, i64 %406
  store <8 x double> %405, ptr %407, align 8
  %408 = shufflevector <4 x double> %393, <4 x double> %378, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7>
  %409 = shl i64 %366, 6
  %410 = getelementptr i8, ptr %180, i64 %409
  store <8 x double> %408, ptr %410, align 8
  %411 = add nsw i64 %366, 4
  %412 = icmp slt i64 %411, %342
  %413 = select i1 %345, i1 %412, i1 false
  br i1 %413, label %364, label %354, !llvm.loop !15

414:                                              ; preds = %357, %414
  %415 = phi i64 [ %442, %414 ], [ %355, %357 ]
  %416 = getelementptr double, ptr %344, i64 %415
  %417 = load double, ptr %416, align 8
  %418 = insertelement <8 x double> poison, double %417, i64 0
  %419 = getelementptr double, ptr %416, i64 %342
  %420 = load double, ptr %419, align 8
  %421 = insertelement <8 x double> %418, double %420, i64 1
  %422 = getelementptr i8, ptr %416, i64 %358
  %423 = load double, ptr %422, align 8
  %424 = insertelement <8 x double> %421, double %423, i64 2
  %425 = getelementptr i8, ptr %416, i64 %359
  %426 = load double, ptr %425, align 8
  %427 = insertelement <8 x double> %424, double %426, i64 3
  %428 = getelementptr i8, ptr %416, i64 %360
  %429 = load double, ptr %428, align 8
  %430 = insertelement <8 x double> %427, double %429, i64 4
  %431 = getelementptr i8, ptr %416, i64 %361
  %432 = load double, ptr %431, align 8
  %433 = insertelement <8 x double> %430, double %432, i64 5
  %434 = getelementptr i8, ptr %416, i64 %362
  %435 = load double, ptr %434, align 8
  %436 = insertelement <8 x double> %433, double %435, i64 6
  %437 = getelementptr i8, ptr %416, i64 %363
  %438 = load double, ptr %437, align 8
  %439 = insertelement <8 x double> %436, double %438, i64 7
  %440 = shl nsw i64 %415, 6
  %441 = getelementptr inbounds i8, ptr %34, i64 %440
  store <8 x double> %439, ptr %441, align 8
  %442 = add nsw i64 %415, 1
  %443 = icmp eq i64 %442, %342
  br i1 %443, label %444, label %414, !llvm.loop !16

444:                                              ; preds = %414, %354, %340
  %445 = load ptr, ptr %0, align 8
  %446 = tail call i32 %445(ptr noundef nonnull %29, ptr noundef nonnull %30, ptr noundef nonnull %34, ptr noundef %25, ptr noundef nonnull %38) #3
  %447 = sext i32 %446 to i64
  %448 = getelementptr inbounds i8, ptr %6, i64 %235
  %449 = icmp eq i32 %446, 0
  br i1 %449, label %458, label %450

450:                                              ; preds = %444, %450
  %451 = phi i64 [ %456, %450 ], [ 0, %444 ]
  %452 = lshr i64 %447, %451
  %453 = trunc i64 %452 to i8
  %454 = and i8 %453, 1
  %455 = getelementptr inbounds i8, ptr %448, i64 %451
  store i8 %454, ptr %455, align 1
  %456 = add nuw nsw i64 %451, 1
  %457 = icmp eq i64 %456, 8
  br i1 %457, label %458, label %450, !llvm.loop !7

458:                                              ; preds = %450, %444
  %459 = load i64, ptr %174, align 8
  %460 = mul nsw i64 %459, %235
  %461 = getelementptr inbounds double, ptr %5, i64 %460
  %462 = icmp sgt i64 %459, 3
  br i1 %462, label %463, label %471

463:                                              ; preds = %458
  %464 = add nsw i64 %459, -4
  %465 = shl i64 %459, 4
  %466 = mul i64 %459, 24
  %467 = shl i64 %459, 5
  %468 = mul i64 %459, 40
  %469 = mul i64 %459, 48
  %470 = mul i64 %459, 56
  br label %481

471:                                              ; preds = %481, %458
  %472 = phi i64 [ 0, %458 ], [ %528, %481 ]
  %473 = icmp slt i64 %472, %459
  br i1 %473, label %474, label %554

474:                                              ; preds = %471
  %475 = shl i64 %459, 4
  %476 = mul i64 %459, 24
  %477 = shl i64 %459, 5
  %478 = mul i64 %459, 40
  %479 = mul i64 %459, 48
  %480 = mul i64 %459, 56
  br label %531

481:                                              ; preds = %463, %481
  %482 = phi i64 [ 0, %463 ], [ %528, %481 ]
  %483 = tail call i64 @llvm.smin.i64(i64 %482, i64 %464)
  %484 = getelementptr double, ptr %461, i64 %483
  %485 = shl nsw i64 %483, 6
  %486 = getelementptr inbounds i8, ptr %38, i64 %485
  %487 = load <8 x double>, ptr %486, align 8
  %488 = shufflevector <8 x double> %487, <8 x double> poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %489 = shl i64 %483, 6
  %490 = getelementptr i8, ptr %181, i64 %489
  %491 = load <8 x double>, ptr %490, align 8
  %492 = shufflevector <8 x double> %491, <8 x double> poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %493 = shufflevector <4 x double> %488, <4 x double> %492, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %494 = shl i64 %483, 6
  %495 = getelementptr i8, ptr %182, i64 %494
  %496 = load <8 x double>, ptr %495, align 8
  %497 = shufflevector <8 x double> %496, <8 x double> poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %498 = shl i64 %483, 6
  %499 = getelementptr i8, ptr %183, i64 %498
  %500 = load <8 x double>, ptr %499, align 8
  %501 = shufflevector <8 x double> %500, <8 x double> poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %502 = shufflevector <4 x double> %497, <4 x double> %501, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %503 = shufflevector <4 x double> %493, <4 x double> %502, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %504 = shufflevector <4 x double> %488, <4 x double> %492, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %505 = shufflevector <4 x double> %497, <4 x double> %501, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %506 = shufflevector <4 x double> %504, <4 x double> %505, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %507 = shufflevector <4 x double> %493, <4 x double> %502, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %508 = shufflevector <4 x double> %504, <4 x double> %505, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %509 = shufflevector <8 x double> %487, <8 x double> poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %510 = shufflevector <8 x double> %491, <8 x double> poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %511 = shufflevector <4 x double> %509, <4 x double> %510, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %512 = shufflevector <8 x double> %496, <8 x double> poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %513 = shufflevector <8 x double> %500, <8 x double> poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %514 = shufflevector <4 x double> %512, <4 x double> %513, <4 x i32> <i32 1, i32 5, i32 3, i32 7>
  %515 = shufflevector <4 x double> %511, <4 x double> %514, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %516 = shufflevector <4 x double> %509, <4 x double> %510, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %517 = shufflevector <4 x double> %512, <4 x double> %513, <4 x i32> <i32 0, i32 4, i32 2, i32 6>
  %518 = shufflevector <4 x double> %516, <4 x double> %517, <4 x i32> <i32 2, i32 3, i32 6, i32 7>
  %519 = shufflevector <4 x double> %511, <4 x double> %514, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  %520 = shufflevector <4 x double> %516, <4 x double> %517, <4 x i32> <i32 0, i32 1, i32 4, i32 5>
  store <4 x double> %520, ptr %484, align 8
  %521 = getelementptr double, ptr %484, i64 %459
  store <4 x double> %519, ptr %521, align 8
  %522 = getelementptr i8, ptr %484, i64 %465
  store <4 x double> %518, ptr %522, align 8
  %523 = getelementptr i8, ptr %484, i64 %466
  store <4 x double> %515, ptr %523, align 8
  %524 = getelementptr i8, ptr %484, i64 %467
  store <4 x double> %508, ptr %524, align 8
  %525 = getelementptr i8, ptr %484, i64 %468
  store <4 x double> %507, ptr %525, align 8
  %526 = getelementptr i8, ptr %484, i64 %469
  store <4 x double> %506, ptr %526, align 8
  %527 = getelementptr i8, ptr %484, i64 %470
  store <4 x double> %503, ptr %527, align 8
  %528 = add nsw i64 %483, 4
  %529 = icmp slt i64 %528, %459
  %530 = select i1 %462, i1 %529, i1 false
  br i1 %530, label %481, label %471, !llvm.loop !17

531:                                              ; preds = %474, %531
  %532 = phi i64 [ %552, %531 ], [ %472, %474 ]
  %533 = getelementptr double, ptr %461, i64 %532
  %534 = shl nsw i64 %532, 6
  %535 = getelementptr inbounds i8, ptr %38, i64 %534
  %536 = load <8 x double>, ptr %535, align 8
  %537 = extractelement <8 x double> %536, i64 0
  store double %537, ptr %533, align 8
  %538 = extractelement <8 x double> %536, i64 1
  %539 = getelementptr double, ptr %533, i64 %459
  store double %538, ptr %539, align 8
  %540 = extractelement <8 x double> %536, i64 2
  %541 = getelementptr i8, ptr %533, i64 %475
  store double %540, ptr %541, align 8
  %542 = extractelement <8 x double> %536, i64 3
  %543 = getelementptr i8, ptr %533, i64 %476
  store double %542, ptr %543, align 8
  %544 = extractelement <8 x double> %536, i64 4
  %545 = getelementptr i8, ptr %533, i64 %477
  store double %544, ptr %545, align 8
  %546 = extractelement <8 x double> %536, i64 5
  %547 = getelementptr i8, ptr %533, i64 %478
  store double %546, ptr %547, align 8
  %548 = extractelement <8 x double> %536, i64 6
  %549 = getelementptr i8, ptr %533, i64 %479
  store double %548, ptr %549, align 8
  %550 = extractelement <8 x double> %536, i64 7
  %551 = getelementptr i8, ptr %533, i64 %480
  store double %550, ptr %551, align 8
  %552 = add nsw i64 %532, 1
  %553 = icmp eq i64 %552, %459
  br i1 %553, label %554, label %531, !llvm.loop !18

554:                                              ; preds = %531, %471
  %555 = add nuw nsw i64 %234, 8
  %556 = icmp slt i64 %555, %11
  br i1 %556, label %233, label %557, !llvm.loop !19

557:                                              ; preds = %554, %150, %198, %8
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
