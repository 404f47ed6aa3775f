; sources cbbf9e0dc28d65bab2f427cd49a9b97b4fb4604a128fd7c8bc7d2217f1490782
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define range(i64 0, 9) i64 @act_on_event(ptr noundef readonly %0) #0 {
  %2 = getelementptr inbounds i8, ptr %0, i64 768
  %3 = getelementptr inbounds i8, ptr %0, i64 144
  %4 = getelementptr inbounds i8, ptr %0, i64 624
  %5 = getelementptr inbounds i8, ptr %0, i64 672
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 680
  %8 = load i64, ptr %7, align 8
  %9 = getelementptr double, ptr %6, i64 %8
  %10 = getelementptr i8, ptr %9, i64 -8
  %11 = load double, ptr %10, align 8
  %12 = load double, ptr %6, align 8
  %13 = fsub double %11, %12
  %14 = load ptr, ptr %2, align 8
  %15 = getelementptr inbounds i8, ptr %14, i64 8
  %16 = load i64, ptr %15, align 8
  %17 = load ptr, ptr %3, align 8
  %18 = getelementptr inbounds i8, ptr %17, i64 8
  %19 = load i64, ptr %18, align 8
  %20 = getelementptr inbounds i8, ptr %0, i64 648
  %21 = load ptr, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %21, i64 80
  %23 = load i64, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %0, i64 360
  %25 = load ptr, ptr %24, align 8
  %26 = load ptr, ptr %4, align 8
  %27 = getelementptr inbounds i8, ptr %0, i64 1224
  %28 = load ptr, ptr %27, align 8
  %29 = load double, ptr %26, align 8
  %30 = getelementptr inbounds i8, ptr %0, i64 984
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds double, ptr %31, i64 %16
  %33 = getelementptr inbounds i8, ptr %0, i64 1200
  %34 = load ptr, ptr %33, align 8
  %35 = getelementptr inbounds double, ptr %34, i64 %16
  %36 = icmp sgt i64 %16, 0
  br i1 %36, label %37, label %52

37:                                               ; preds = %1
  %38 = getelementptr inbounds i8, ptr %0, i64 960
  %39 = load ptr, ptr %38, align 8
  br label %40

40:                                               ; preds = %37, %48
  %41 = phi i64 [ -1, %37 ], [ %49, %48 ]
  %42 = phi i64 [ 0, %37 ], [ %50, %48 ]
  %43 = getelementptr inbounds i64, ptr %39, i64 %42
  %44 = load i64, ptr %43, align 8
  %45 = icmp eq i64 %44, 0
  br i1 %45, label %48, label %46

46:                                               ; preds = %40
  %47 = icmp sgt i64 %41, -1
  br i1 %47, label %328, label %48

48:                                               ; preds = %46, %40
  %49 = phi i64 [ %41, %40 ], [ %42, %46 ]
  %50 = add nuw nsw i64 %42, 1
  %51 = icmp eq i64 %50, %16
  br i1 %51, label %52, label %40, !llvm.loop !3

52:                                               ; preds = %48, %1
  %53 = phi i64 [ -1, %1 ], [ %49, %48 ]
  %54 = icmp slt i64 %53, 0
  br i1 %54, label %328, label %55

55:                                               ; preds = %52
  %56 = getelementptr inbounds i8, ptr %0, i64 864
  %57 = load ptr, ptr %56, align 8
  %58 = getelementptr inbounds i64, ptr %57, i64 %53
  %59 = load i64, ptr %58, align 8
  %60 = and i64 %59, 4
  %61 = icmp eq i64 %60, 0
  br i1 %61, label %328, label %62

62:                                               ; preds = %55
  %63 = add nsw i64 %23, 1
  %64 = add nsw i64 %63, %16
  %65 = getelementptr inbounds i8, ptr %0, i64 1056
  %66 = getelementptr inbounds i8, ptr %0, i64 1064
  %67 = load i64, ptr %66, align 8
  %68 = icmp sgt i64 %64, %67
  br i1 %68, label %328, label %69

69:                                               ; preds = %62
  %70 = mul nsw i64 %53, %19
  %71 = getelementptr inbounds double, ptr %28, i64 %70
  %72 = getelementptr inbounds i8, ptr %0, i64 168
  %73 = load ptr, ptr %72, align 8
  store double %29, ptr %73, align 8
  %74 = load ptr, ptr %3, align 8
  %75 = getelementptr inbounds i8, ptr %74, i64 40
  %76 = load i64, ptr %75, align 8
  %77 = icmp eq i64 %76, 0
  br i1 %77, label %79, label %78

78:                                               ; preds = %69
  tail call fastcc void @settle(ptr noundef nonnull %3) #3
  br label %79

79:                                               ; preds = %78, %69
  %80 = getelementptr inbounds i8, ptr %0, i64 248
  %81 = load i64, ptr %80, align 8
  %82 = icmp sgt i64 %81, 0
  br i1 %82, label %83, label %84

83:                                               ; preds = %79
  tail call fastcc void @sample(ptr noundef nonnull %3) #3
  br label %84

84:                                               ; preds = %79, %83
  %85 = load ptr, ptr %2, align 8
  %86 = getelementptr inbounds i8, ptr %85, i64 64
  %87 = load i64, ptr %86, align 8
  %88 = getelementptr inbounds i8, ptr %0, i64 168
  %89 = load ptr, ptr %88, align 8
  %90 = getelementptr inbounds i8, ptr %0, i64 192
  %91 = load ptr, ptr %90, align 8
  %92 = getelementptr inbounds i8, ptr %0, i64 1176
  %93 = load ptr, ptr %92, align 8
  %94 = inttoptr i64 %87 to ptr
  %95 = load ptr, ptr %94, align 8
  %96 = tail call i32 %95(ptr noundef %89, ptr noundef %25, ptr noundef %91, ptr noundef %93, ptr noundef %28) #4
  %97 = icmp eq i32 %96, 0
  br i1 %97, label %98, label %328

98:                                               ; preds = %84
  %99 = load ptr, ptr %2, align 8
  %100 = load i64, ptr %99, align 8
  %101 = load ptr, ptr %88, align 8
  %102 = load ptr, ptr %90, align 8
  %103 = getelementptr inbounds i8, ptr %0, i64 792
  %104 = load ptr, ptr %103, align 8
  %105 = inttoptr i64 %100 to ptr
  %106 = load ptr, ptr %105, align 8
  %107 = tail call i32 %106(ptr noundef %101, ptr noundef %25, ptr noundef %102, ptr noundef %104, ptr noundef %31) #4
  %108 = icmp eq i32 %107, 0
  br i1 %108, label %109, label %328

109:                                              ; preds = %98
  %110 = load ptr, ptr %2, align 8
  %111 = load i64, ptr %110, align 8
  %112 = load ptr, ptr %88, align 8
  %113 = load ptr, ptr %90, align 8
  %114 = load ptr, ptr %103, align 8
  %115 = inttoptr i64 %111 to ptr
  %116 = load ptr, ptr %115, align 8
  %117 = tail call i32 %116(ptr noundef %112, ptr noundef %71, ptr noundef %113, ptr noundef %114, ptr noundef %32) #4
  %118 = icmp eq i32 %117, 0
  br i1 %118, label %119, label %328

119:                                              ; preds = %109
  %120 = load ptr, ptr %2, align 8
  %121 = getelementptr inbounds i8, ptr %120, i64 56
  %122 = load i64, ptr %121, align 8
  %123 = load ptr, ptr %88, align 8
  %124 = load ptr, ptr %90, align 8
  %125 = getelementptr inbounds i8, ptr %0, i64 1152
  %126 = load ptr, ptr %125, align 8
  %127 = load ptr, ptr %33, align 8
  %128 = inttoptr i64 %122 to ptr
  %129 = load ptr, ptr %128, align 8
  %130 = tail call i32 %129(ptr noundef %123, ptr noundef %71, ptr noundef %124, ptr noundef %126, ptr noundef %127) #4
  %131 = icmp eq i32 %130, 0
  br i1 %131, label %132, label %328

132:                                              ; preds = %119
  %133 = icmp sgt i64 %19, 0
  br i1 %133, label %143, label %137

134:                                              ; preds = %143
  %135 = add nuw nsw i64 %144, 1
  %136 = icmp eq i64 %135, %19
  br i1 %136, label %137, label %143, !llvm.loop !6

137:                                              ; preds = %134, %132
  %138 = icmp sgt i64 %16, 0
  br i1 %138, label %139, label %198

139:                                              ; preds = %137
  %140 = getelementptr inbounds i8, ptr %0, i64 936
  %141 = getelementptr inbounds i8, ptr %0, i64 840
  %142 = getelementptr inbounds i8, ptr %0, i64 816
  br label %149

143:                                              ; preds = %132, %134
  %144 = phi i64 [ %135, %134 ], [ 0, %132 ]
  %145 = getelementptr inbounds double, ptr %71, i64 %144
  %146 = load double, ptr %145, align 8
  %147 = tail call double @llvm.fabs.f64(double %146)
  %148 = fcmp ueq double %147, 0x7FF0000000000000
  br i1 %148, label %328, label %134

149:                                              ; preds = %139, %195
  %150 = phi i64 [ 0, %139 ], [ %196, %195 ]
  %151 = icmp eq i64 %150, %53
  br i1 %151, label %195, label %152

152:                                              ; preds = %149
  %153 = load ptr, ptr %140, align 8
  %154 = getelementptr inbounds i64, ptr %153, i64 %150
  %155 = load i64, ptr %154, align 8
  %156 = icmp eq i64 %155, 0
  br i1 %156, label %161, label %157

157:                                              ; preds = %152
  %158 = getelementptr inbounds double, ptr %32, i64 %150
  %159 = load double, ptr %158, align 8
  %160 = fcmp uno double %159, 0.000000e+00
  br i1 %160, label %328, label %161

161:                                              ; preds = %157, %152
  %162 = load ptr, ptr %141, align 8
  %163 = getelementptr inbounds i64, ptr %162, i64 %150
  %164 = load i64, ptr %163, align 8
  %165 = icmp eq i64 %164, 1
  br i1 %165, label %166, label %195

166:                                              ; preds = %161
  %167 = getelementptr inbounds double, ptr %32, i64 %150
  %168 = load double, ptr %167, align 8
  %169 = getelementptr inbounds double, ptr %31, i64 %150
  %170 = load double, ptr %169, align 8
  %171 = fcmp oeq double %168, %170
  br i1 %171, label %172, label %195

172:                                              ; preds = %166
  %173 = getelementptr inbounds double, ptr %34, i64 %150
  %174 = load double, ptr %173, align 8
  %175 = load ptr, ptr %142, align 8
  %176 = getelementptr inbounds i64, ptr %175, i64 %150
  %177 = load i64, ptr %176, align 8
  %178 = sitofp i64 %177 to double
  %179 = fmul double %174, %178
  %180 = fcmp oge double %179, 0.000000e+00
  %181 = fcmp une double %174, 0.000000e+00
  %182 = and i1 %181, %180
  br i1 %182, label %183, label %195

183:                                              ; preds = %172
  %184 = fcmp oeq double %168, 0.000000e+00
  br i1 %184, label %192, label %185

185:                                              ; preds = %183
  %186 = getelementptr inbounds double, ptr %35, i64 %150
  %187 = load double, ptr %186, align 8
  %188 = tail call double @llvm.fabs.f64(double %168)
  %189 = fmul double %187, 0x3CE0000000000000
  %190 = fcmp ole double %188, %189
  %191 = zext i1 %190 to i32
  br label %192

192:                                              ; preds = %183, %185
  %193 = phi i32 [ 1, %183 ], [ %191, %185 ]
  %194 = icmp eq i32 %193, 0
  br i1 %194, label %195, label %328

195:                                              ; preds = %161, %166, %172, %192, %149
  %196 = add nuw nsw i64 %150, 1
  %197 = icmp eq i64 %196, %16
  br i1 %197, label %198, label %149, !llvm.loop !7

198:                                              ; preds = %195, %137
  %199 = getelementptr inbounds double, ptr %32, i64 %53
  %200 = load double, ptr %199, align 8
  %201 = getelementptr inbounds double, ptr %31, i64 %53
  %202 = load double, ptr %201, align 8
  %203 = fcmp oeq double %200, %202
  %204 = fcmp oeq double %200, 0.000000e+00
  %205 = or i1 %204, %203
  br i1 %205, label %212, label %206

206:                                              ; preds = %198
  %207 = getelementptr inbounds double, ptr %35, i64 %53
  %208 = load double, ptr %207, align 8
  %209 = tail call double @llvm.fabs.f64(double %200)
  %210 = fmul double %208, 0x3CE0000000000000
  %211 = fcmp ugt double %209, %210
  br label %212

212:                                              ; preds = %206, %198
  %213 = phi i1 [ false, %198 ], [ %211, %206 ]
  br i1 %213, label %236, label %214

214:                                              ; preds = %212
  %215 = getelementptr inbounds i8, ptr %0, i64 816
  %216 = load ptr, ptr %215, align 8
  %217 = getelementptr inbounds i64, ptr %216, i64 %53
  %218 = load i64, ptr %217, align 8
  %219 = icmp eq i64 %218, 0
  br i1 %219, label %236, label %220

220:                                              ; preds = %214
  %221 = load ptr, ptr %56, align 8
  %222 = getelementptr inbounds i64, ptr %221, i64 %53
  %223 = load i64, ptr %222, align 8
  %224 = and i64 %223, 16
  %225 = icmp eq i64 %224, 0
  br i1 %225, label %236, label %226

226:                                              ; preds = %220
  %227 = getelementptr inbounds double, ptr %34, i64 %53
  %228 = load double, ptr %227, align 8
  %229 = getelementptr inbounds i8, ptr %0, i64 936
  %230 = load ptr, ptr %229, align 8
  %231 = getelementptr inbounds i64, ptr %230, i64 %53
  %232 = load i64, ptr %231, align 8
  %233 = sitofp i64 %232 to double
  %234 = fmul double %228, %233
  %235 = fcmp ogt double %234, 0.000000e+00
  br i1 %235, label %236, label %328

236:                                              ; preds = %226, %220, %214, %212
  %237 = icmp sgt i64 %16, 0
  br i1 %237, label %238, label %240

238:                                              ; preds = %236
  %239 = getelementptr inbounds i8, ptr %0, i64 936
  br label %251

240:                                              ; preds = %251, %236
  %241 = load ptr, ptr %65, align 8
  %242 = getelementptr inbounds double, ptr %241, i64 %23
  store double %29, ptr %242, align 8
  %243 = getelementptr inbounds i8, ptr %0, i64 1080
  %244 = load ptr, ptr %243, align 8
  %245 = getelementptr inbounds i64, ptr %244, i64 %23
  store i64 %53, ptr %245, align 8
  %246 = icmp sgt i64 %19, 0
  br i1 %246, label %247, label %273

247:                                              ; preds = %240
  %248 = getelementptr inbounds i8, ptr %0, i64 1104
  %249 = mul nsw i64 %23, %19
  %250 = getelementptr inbounds i8, ptr %0, i64 1128
  br label %280

251:                                              ; preds = %238, %251
  %252 = phi i64 [ 0, %238 ], [ %271, %251 ]
  %253 = getelementptr inbounds double, ptr %32, i64 %252
  %254 = load double, ptr %253, align 8
  %255 = fcmp une double %254, 0.000000e+00
  %256 = icmp ne i64 %252, %53
  %257 = or i1 %213, %256
  %258 = and i1 %255, %257
  %259 = getelementptr inbounds double, ptr %34, i64 %252
  %260 = select i1 %258, ptr %253, ptr %259
  %261 = load double, ptr %260, align 8
  %262 = tail call double @llvm.fabs.f64(double %261)
  %263 = fcmp ueq double %262, 0x7FF0000000000000
  %264 = fcmp ogt double %261, 0.000000e+00
  %265 = fcmp olt double %261, 0.000000e+00
  %266 = sext i1 %265 to i64
  %267 = select i1 %264, i64 1, i64 %266
  %268 = select i1 %263, i64 0, i64 %267
  %269 = load ptr, ptr %239, align 8
  %270 = getelementptr inbounds i64, ptr %269, i64 %252
  store i64 %268, ptr %270, align 8
  %271 = add nuw nsw i64 %252, 1
  %272 = icmp eq i64 %271, %16
  br i1 %272, label %240, label %251, !llvm.loop !8

273:                                              ; preds = %280, %240
  %274 = load ptr, ptr %20, align 8
  %275 = getelementptr inbounds i8, ptr %274, i64 80
  store i64 %63, ptr %275, align 8
  %276 = load ptr, ptr %0, align 8
  %277 = getelementptr inbounds i8, ptr %276, i64 8
  %278 = load i64, ptr %277, align 8
  %279 = icmp eq i64 %278, 0
  br i1 %279, label %293, label %299

280:                                              ; preds = %247, %280
  %281 = phi i64 [ 0, %247 ], [ %291, %280 ]
  %282 = getelementptr inbounds double, ptr %25, i64 %281
  %283 = load double, ptr %282, align 8
  %284 = load ptr, ptr %248, align 8
  %285 = add nsw i64 %281, %249
  %286 = getelementptr inbounds double, ptr %284, i64 %285
  store double %283, ptr %286, align 8
  %287 = getelementptr inbounds double, ptr %71, i64 %281
  %288 = load double, ptr %287, align 8
  store double %288, ptr %282, align 8
  %289 = load ptr, ptr %250, align 8
  %290 = getelementptr inbounds double, ptr %289, i64 %285
  store double %288, ptr %290, align 8
  %291 = add nuw nsw i64 %281, 1
  %292 = icmp eq i64 %291, %19
  br i1 %292, label %273, label %280, !llvm.loop !9

293:                                              ; preds = %273
  %294 = getelementptr inbounds i8, ptr %0, i64 1272
  %295 = load ptr, ptr %294, align 8
  %296 = getelementptr inbounds i8, ptr %295, i64 8
  %297 = load double, ptr %296, align 8
  %298 = getelementptr inbounds i8, ptr %26, i64 8
  store double %297, ptr %298, align 8
  br label %299

299:                                              ; preds = %293, %273
  %300 = getelementptr inbounds i8, ptr %0, i64 1248
  %301 = load ptr, ptr %300, align 8
  %302 = mul i64 %53, 800
  %303 = getelementptr inbounds i8, ptr %301, i64 %302
  %304 = load double, ptr %303, align 8
  %305 = fsub double %29, %304
  %306 = tail call double @llvm.fabs.f64(double %29)
  %307 = fcmp ogt double %306, %13
  %308 = select i1 %307, double %306, double %13
  %309 = fmul double %308, 0x3CF0000000000000
  %310 = fcmp ugt double %305, %309
  br i1 %310, label %311, label %318

311:                                              ; preds = %299
  %312 = getelementptr inbounds i8, ptr %303, i64 784
  %313 = load double, ptr %312, align 8
  %314 = fsub double %29, %313
  %315 = fmul double %13, 1.000000e-09
  %316 = fcmp olt double %314, %315
  %317 = select i1 %316, i64 8, i64 1
  br label %318

318:                                              ; preds = %311, %299
  %319 = phi i64 [ 8, %299 ], [ %317, %311 ]
  br label %321

320:                                              ; preds = %321
  store double %29, ptr %303, align 8
  br label %328

321:                                              ; preds = %318, %321
  %322 = phi i64 [ 99, %318 ], [ %326, %321 ]
  %323 = getelementptr double, ptr %303, i64 %322
  %324 = getelementptr i8, ptr %323, i64 -8
  %325 = load double, ptr %324, align 8
  store double %325, ptr %323, align 8
  %326 = add nsw i64 %322, -1
  %327 = icmp ugt i64 %322, 1
  br i1 %327, label %321, label %320, !llvm.loop !10

328:                                              ; preds = %46, %143, %157, %192, %119, %109, %98, %84, %226, %320, %52, %55, %62
  %329 = phi i64 [ 0, %62 ], [ 0, %55 ], [ 0, %52 ], [ 0, %119 ], [ 0, %109 ], [ 0, %98 ], [ 0, %84 ], [ %319, %320 ], [ 0, %226 ], [ 0, %192 ], [ 0, %157 ], [ 0, %143 ], [ 0, %46 ]
  ret i64 %329
}

declare double @llvm.fabs.f64(double) #1

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
  br i1 %28, label %16, label %29, !llvm.loop !11

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
  br i1 %60, label %49, label %61, !llvm.loop !12

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
  br i1 %88, label %14, label %13, !llvm.loop !13
}

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn memory(none) }
attributes #2 = { noinline nounwind }
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
!8 = distinct !{!8, !4, !5}
!9 = distinct !{!9, !4, !5}
!10 = distinct !{!10, !4, !5}
!11 = distinct !{!11, !4, !5}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5}
