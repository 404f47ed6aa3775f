; sources 56f7cc8cc4b4c70ee0a9d4ac0c9690897be3688d186f4450b221c51297f914b7
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
  br i1 %47, label %322, label %48

48:                                               ; preds = %46, %40
  %49 = phi i64 [ %41, %40 ], [ %42, %46 ]
  %50 = add nuw nsw i64 %42, 1
  %51 = icmp eq i64 %50, %16
  br i1 %51, label %52, label %40, !llvm.loop !3

52:                                               ; preds = %48, %1
  %53 = phi i64 [ -1, %1 ], [ %49, %48 ]
  %54 = icmp slt i64 %53, 0
  br i1 %54, label %322, label %55

55:                                               ; preds = %52
  %56 = getelementptr inbounds i8, ptr %0, i64 864
  %57 = load ptr, ptr %56, align 8
  %58 = getelementptr inbounds i64, ptr %57, i64 %53
  %59 = load i64, ptr %58, align 8
  %60 = and i64 %59, 4
  %61 = icmp eq i64 %60, 0
  br i1 %61, label %322, label %62

62:                                               ; preds = %55
  %63 = add nsw i64 %23, 1
  %64 = add nsw i64 %63, %16
  %65 = getelementptr inbounds i8, ptr %0, i64 1056
  %66 = getelementptr inbounds i8, ptr %0, i64 1064
  %67 = load i64, ptr %66, align 8
  %68 = icmp sgt i64 %64, %67
  br i1 %68, label %322, label %69

69:                                               ; preds = %62
  %70 = mul nsw i64 %53, %19
  %71 = getelementptr inbounds double, ptr %28, i64 %70
  %72 = getelementptr inbounds i8, ptr %0, i64 168
  %73 = load ptr, ptr %72, align 8
  store double %29, ptr %73, align 8
  %74 = getelementptr inbounds i8, ptr %0, i64 248
  %75 = load i64, ptr %74, align 8
  %76 = icmp sgt i64 %75, 0
  br i1 %76, label %77, label %78

77:                                               ; preds = %69
  tail call fastcc void @sample(ptr noundef nonnull %3) #3
  br label %78

78:                                               ; preds = %69, %77
  %79 = load ptr, ptr %2, align 8
  %80 = getelementptr inbounds i8, ptr %79, i64 64
  %81 = load i64, ptr %80, align 8
  %82 = getelementptr inbounds i8, ptr %0, i64 168
  %83 = load ptr, ptr %82, align 8
  %84 = getelementptr inbounds i8, ptr %0, i64 192
  %85 = load ptr, ptr %84, align 8
  %86 = getelementptr inbounds i8, ptr %0, i64 1176
  %87 = load ptr, ptr %86, align 8
  %88 = inttoptr i64 %81 to ptr
  %89 = load ptr, ptr %88, align 8
  %90 = tail call i32 %89(ptr noundef %83, ptr noundef %25, ptr noundef %85, ptr noundef %87, ptr noundef %28) #4
  %91 = icmp eq i32 %90, 0
  br i1 %91, label %92, label %322

92:                                               ; preds = %78
  %93 = load ptr, ptr %2, align 8
  %94 = load i64, ptr %93, align 8
  %95 = load ptr, ptr %82, align 8
  %96 = load ptr, ptr %84, align 8
  %97 = getelementptr inbounds i8, ptr %0, i64 792
  %98 = load ptr, ptr %97, align 8
  %99 = inttoptr i64 %94 to ptr
  %100 = load ptr, ptr %99, align 8
  %101 = tail call i32 %100(ptr noundef %95, ptr noundef %25, ptr noundef %96, ptr noundef %98, ptr noundef %31) #4
  %102 = icmp eq i32 %101, 0
  br i1 %102, label %103, label %322

103:                                              ; preds = %92
  %104 = load ptr, ptr %2, align 8
  %105 = load i64, ptr %104, align 8
  %106 = load ptr, ptr %82, align 8
  %107 = load ptr, ptr %84, align 8
  %108 = load ptr, ptr %97, align 8
  %109 = inttoptr i64 %105 to ptr
  %110 = load ptr, ptr %109, align 8
  %111 = tail call i32 %110(ptr noundef %106, ptr noundef %71, ptr noundef %107, ptr noundef %108, ptr noundef %32) #4
  %112 = icmp eq i32 %111, 0
  br i1 %112, label %113, label %322

113:                                              ; preds = %103
  %114 = load ptr, ptr %2, align 8
  %115 = getelementptr inbounds i8, ptr %114, i64 56
  %116 = load i64, ptr %115, align 8
  %117 = load ptr, ptr %82, align 8
  %118 = load ptr, ptr %84, align 8
  %119 = getelementptr inbounds i8, ptr %0, i64 1152
  %120 = load ptr, ptr %119, align 8
  %121 = load ptr, ptr %33, align 8
  %122 = inttoptr i64 %116 to ptr
  %123 = load ptr, ptr %122, align 8
  %124 = tail call i32 %123(ptr noundef %117, ptr noundef %71, ptr noundef %118, ptr noundef %120, ptr noundef %121) #4
  %125 = icmp eq i32 %124, 0
  br i1 %125, label %126, label %322

126:                                              ; preds = %113
  %127 = icmp sgt i64 %19, 0
  br i1 %127, label %137, label %131

128:                                              ; preds = %137
  %129 = add nuw nsw i64 %138, 1
  %130 = icmp eq i64 %129, %19
  br i1 %130, label %131, label %137, !llvm.loop !6

131:                                              ; preds = %128, %126
  %132 = icmp sgt i64 %16, 0
  br i1 %132, label %133, label %192

133:                                              ; preds = %131
  %134 = getelementptr inbounds i8, ptr %0, i64 936
  %135 = getelementptr inbounds i8, ptr %0, i64 840
  %136 = getelementptr inbounds i8, ptr %0, i64 816
  br label %143

137:                                              ; preds = %126, %128
  %138 = phi i64 [ %129, %128 ], [ 0, %126 ]
  %139 = getelementptr inbounds double, ptr %71, i64 %138
  %140 = load double, ptr %139, align 8
  %141 = tail call double @llvm.fabs.f64(double %140)
  %142 = fcmp ueq double %141, 0x7FF0000000000000
  br i1 %142, label %322, label %128

143:                                              ; preds = %133, %189
  %144 = phi i64 [ 0, %133 ], [ %190, %189 ]
  %145 = icmp eq i64 %144, %53
  br i1 %145, label %189, label %146

146:                                              ; preds = %143
  %147 = load ptr, ptr %134, align 8
  %148 = getelementptr inbounds i64, ptr %147, i64 %144
  %149 = load i64, ptr %148, align 8
  %150 = icmp eq i64 %149, 0
  br i1 %150, label %155, label %151

151:                                              ; preds = %146
  %152 = getelementptr inbounds double, ptr %32, i64 %144
  %153 = load double, ptr %152, align 8
  %154 = fcmp uno double %153, 0.000000e+00
  br i1 %154, label %322, label %155

155:                                              ; preds = %151, %146
  %156 = load ptr, ptr %135, align 8
  %157 = getelementptr inbounds i64, ptr %156, i64 %144
  %158 = load i64, ptr %157, align 8
  %159 = icmp eq i64 %158, 1
  br i1 %159, label %160, label %189

160:                                              ; preds = %155
  %161 = getelementptr inbounds double, ptr %32, i64 %144
  %162 = load double, ptr %161, align 8
  %163 = getelementptr inbounds double, ptr %31, i64 %144
  %164 = load double, ptr %163, align 8
  %165 = fcmp oeq double %162, %164
  br i1 %165, label %166, label %189

166:                                              ; preds = %160
  %167 = getelementptr inbounds double, ptr %34, i64 %144
  %168 = load double, ptr %167, align 8
  %169 = load ptr, ptr %136, align 8
  %170 = getelementptr inbounds i64, ptr %169, i64 %144
  %171 = load i64, ptr %170, align 8
  %172 = sitofp i64 %171 to double
  %173 = fmul double %168, %172
  %174 = fcmp oge double %173, 0.000000e+00
  %175 = fcmp une double %168, 0.000000e+00
  %176 = and i1 %175, %174
  br i1 %176, label %177, label %189

177:                                              ; preds = %166
  %178 = fcmp oeq double %162, 0.000000e+00
  br i1 %178, label %186, label %179

179:                                              ; preds = %177
  %180 = getelementptr inbounds double, ptr %35, i64 %144
  %181 = load double, ptr %180, align 8
  %182 = tail call double @llvm.fabs.f64(double %162)
  %183 = fmul double %181, 0x3CE0000000000000
  %184 = fcmp ole double %182, %183
  %185 = zext i1 %184 to i32
  br label %186

186:                                              ; preds = %177, %179
  %187 = phi i32 [ 1, %177 ], [ %185, %179 ]
  %188 = icmp eq i32 %187, 0
  br i1 %188, label %189, label %322

189:                                              ; preds = %155, %160, %166, %186, %143
  %190 = add nuw nsw i64 %144, 1
  %191 = icmp eq i64 %190, %16
  br i1 %191, label %192, label %143, !llvm.loop !7

192:                                              ; preds = %189, %131
  %193 = getelementptr inbounds double, ptr %32, i64 %53
  %194 = load double, ptr %193, align 8
  %195 = getelementptr inbounds double, ptr %31, i64 %53
  %196 = load double, ptr %195, align 8
  %197 = fcmp oeq double %194, %196
  %198 = fcmp oeq double %194, 0.000000e+00
  %199 = or i1 %198, %197
  br i1 %199, label %206, label %200

200:                                              ; preds = %192
  %201 = getelementptr inbounds double, ptr %35, i64 %53
  %202 = load double, ptr %201, align 8
  %203 = tail call double @llvm.fabs.f64(double %194)
  %204 = fmul double %202, 0x3CE0000000000000
  %205 = fcmp ugt double %203, %204
  br label %206

206:                                              ; preds = %200, %192
  %207 = phi i1 [ false, %192 ], [ %205, %200 ]
  br i1 %207, label %230, label %208

208:                                              ; preds = %206
  %209 = getelementptr inbounds i8, ptr %0, i64 816
  %210 = load ptr, ptr %209, align 8
  %211 = getelementptr inbounds i64, ptr %210, i64 %53
  %212 = load i64, ptr %211, align 8
  %213 = icmp eq i64 %212, 0
  br i1 %213, label %230, label %214

214:                                              ; preds = %208
  %215 = load ptr, ptr %56, align 8
  %216 = getelementptr inbounds i64, ptr %215, i64 %53
  %217 = load i64, ptr %216, align 8
  %218 = and i64 %217, 16
  %219 = icmp eq i64 %218, 0
  br i1 %219, label %230, label %220

220:                                              ; preds = %214
  %221 = getelementptr inbounds double, ptr %34, i64 %53
  %222 = load double, ptr %221, align 8
  %223 = getelementptr inbounds i8, ptr %0, i64 936
  %224 = load ptr, ptr %223, align 8
  %225 = getelementptr inbounds i64, ptr %224, i64 %53
  %226 = load i64, ptr %225, align 8
  %227 = sitofp i64 %226 to double
  %228 = fmul double %222, %227
  %229 = fcmp ogt double %228, 0.000000e+00
  br i1 %229, label %230, label %322

230:                                              ; preds = %220, %214, %208, %206
  %231 = icmp sgt i64 %16, 0
  br i1 %231, label %232, label %234

232:                                              ; preds = %230
  %233 = getelementptr inbounds i8, ptr %0, i64 936
  br label %245

234:                                              ; preds = %245, %230
  %235 = load ptr, ptr %65, align 8
  %236 = getelementptr inbounds double, ptr %235, i64 %23
  store double %29, ptr %236, align 8
  %237 = getelementptr inbounds i8, ptr %0, i64 1080
  %238 = load ptr, ptr %237, align 8
  %239 = getelementptr inbounds i64, ptr %238, i64 %23
  store i64 %53, ptr %239, align 8
  %240 = icmp sgt i64 %19, 0
  br i1 %240, label %241, label %267

241:                                              ; preds = %234
  %242 = getelementptr inbounds i8, ptr %0, i64 1104
  %243 = mul nsw i64 %23, %19
  %244 = getelementptr inbounds i8, ptr %0, i64 1128
  br label %274

245:                                              ; preds = %232, %245
  %246 = phi i64 [ 0, %232 ], [ %265, %245 ]
  %247 = getelementptr inbounds double, ptr %32, i64 %246
  %248 = load double, ptr %247, align 8
  %249 = fcmp une double %248, 0.000000e+00
  %250 = icmp ne i64 %246, %53
  %251 = or i1 %207, %250
  %252 = and i1 %249, %251
  %253 = getelementptr inbounds double, ptr %34, i64 %246
  %254 = select i1 %252, ptr %247, ptr %253
  %255 = load double, ptr %254, align 8
  %256 = tail call double @llvm.fabs.f64(double %255)
  %257 = fcmp ueq double %256, 0x7FF0000000000000
  %258 = fcmp ogt double %255, 0.000000e+00
  %259 = fcmp olt double %255, 0.000000e+00
  %260 = sext i1 %259 to i64
  %261 = select i1 %258, i64 1, i64 %260
  %262 = select i1 %257, i64 0, i64 %261
  %263 = load ptr, ptr %233, align 8
  %264 = getelementptr inbounds i64, ptr %263, i64 %246
  store i64 %262, ptr %264, align 8
  %265 = add nuw nsw i64 %246, 1
  %266 = icmp eq i64 %265, %16
  br i1 %266, label %234, label %245, !llvm.loop !8

267:                                              ; preds = %274, %234
  %268 = load ptr, ptr %20, align 8
  %269 = getelementptr inbounds i8, ptr %268, i64 80
  store i64 %63, ptr %269, align 8
  %270 = load ptr, ptr %0, align 8
  %271 = getelementptr inbounds i8, ptr %270, i64 8
  %272 = load i64, ptr %271, align 8
  %273 = icmp eq i64 %272, 0
  br i1 %273, label %287, label %293

274:                                              ; preds = %241, %274
  %275 = phi i64 [ 0, %241 ], [ %285, %274 ]
  %276 = getelementptr inbounds double, ptr %25, i64 %275
  %277 = load double, ptr %276, align 8
  %278 = load ptr, ptr %242, align 8
  %279 = add nsw i64 %275, %243
  %280 = getelementptr inbounds double, ptr %278, i64 %279
  store double %277, ptr %280, align 8
  %281 = getelementptr inbounds double, ptr %71, i64 %275
  %282 = load double, ptr %281, align 8
  store double %282, ptr %276, align 8
  %283 = load ptr, ptr %244, align 8
  %284 = getelementptr inbounds double, ptr %283, i64 %279
  store double %282, ptr %284, align 8
  %285 = add nuw nsw i64 %275, 1
  %286 = icmp eq i64 %285, %19
  br i1 %286, label %267, label %274, !llvm.loop !9

287:                                              ; preds = %267
  %288 = getelementptr inbounds i8, ptr %0, i64 1272
  %289 = load ptr, ptr %288, align 8
  %290 = getelementptr inbounds i8, ptr %289, i64 8
  %291 = load double, ptr %290, align 8
  %292 = getelementptr inbounds i8, ptr %26, i64 8
  store double %291, ptr %292, align 8
  br label %293

293:                                              ; preds = %287, %267
  %294 = getelementptr inbounds i8, ptr %0, i64 1248
  %295 = load ptr, ptr %294, align 8
  %296 = mul i64 %53, 800
  %297 = getelementptr inbounds i8, ptr %295, i64 %296
  %298 = load double, ptr %297, align 8
  %299 = fsub double %29, %298
  %300 = tail call double @llvm.fabs.f64(double %29)
  %301 = fcmp ogt double %300, %13
  %302 = select i1 %301, double %300, double %13
  %303 = fmul double %302, 0x3CF0000000000000
  %304 = fcmp ugt double %299, %303
  br i1 %304, label %305, label %312

305:                                              ; preds = %293
  %306 = getelementptr inbounds i8, ptr %297, i64 784
  %307 = load double, ptr %306, align 8
  %308 = fsub double %29, %307
  %309 = fmul double %13, 1.000000e-09
  %310 = fcmp olt double %308, %309
  %311 = select i1 %310, i64 8, i64 1
  br label %312

312:                                              ; preds = %305, %293
  %313 = phi i64 [ 8, %293 ], [ %311, %305 ]
  br label %315

314:                                              ; preds = %315
  store double %29, ptr %297, align 8
  br label %322

315:                                              ; preds = %312, %315
  %316 = phi i64 [ 99, %312 ], [ %320, %315 ]
  %317 = getelementptr double, ptr %297, i64 %316
  %318 = getelementptr i8, ptr %317, i64 -8
  %319 = load double, ptr %318, align 8
  store double %319, ptr %317, align 8
  %320 = add nsw i64 %316, -1
  %321 = icmp ugt i64 %316, 1
  br i1 %321, label %315, label %314, !llvm.loop !10

322:                                              ; preds = %46, %137, %151, %186, %113, %103, %92, %78, %220, %314, %52, %55, %62
  %323 = phi i64 [ 0, %62 ], [ 0, %55 ], [ 0, %52 ], [ 0, %113 ], [ 0, %103 ], [ 0, %92 ], [ 0, %78 ], [ %313, %314 ], [ 0, %220 ], [ 0, %186 ], [ 0, %151 ], [ 0, %137 ], [ 0, %46 ]
  ret i64 %323
}

declare double @llvm.fabs.f64(double) #1

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
  br i1 %60, label %49, label %61, !llvm.loop !11

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
  br i1 %88, label %14, label %13, !llvm.loop !12
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
