; sources 4e4af995d49d13a53ce6e9da50561c496c35f71a89e74f2dc1a3f26ce4c8defd
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Held = type { ptr, i64, i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

define i64 @project(ptr noundef readonly %0, double noundef %1, ptr noundef %2) #0 {
  %4 = alloca %struct.Held, align 8
  tail call void @llvm.experimental.noalias.scope.decl(metadata !3)
  %5 = getelementptr inbounds i8, ptr %0, i64 648
  %6 = load ptr, ptr %5, align 8, !noalias !3
  %7 = getelementptr inbounds i8, ptr %6, i64 64
  %8 = load i64, ptr %7, align 8, !noalias !3
  %9 = inttoptr i64 %8 to ptr
  store ptr %9, ptr %4, align 8, !alias.scope !3
  %10 = getelementptr inbounds i8, ptr %4, i64 8
  %11 = getelementptr inbounds i8, ptr %6, i64 16
  %12 = load i64, ptr %11, align 8, !noalias !3
  store i64 %12, ptr %10, align 8, !alias.scope !3
  %13 = getelementptr inbounds i8, ptr %4, i64 16
  %14 = getelementptr inbounds i8, ptr %6, i64 24
  %15 = load i64, ptr %14, align 8, !noalias !3
  store i64 %15, ptr %13, align 8, !alias.scope !3
  %16 = getelementptr inbounds i8, ptr %4, i64 24
  %17 = getelementptr inbounds i8, ptr %6, i64 32
  %18 = load i64, ptr %17, align 8, !noalias !3
  store i64 %18, ptr %16, align 8, !alias.scope !3
  %19 = getelementptr inbounds i8, ptr %4, i64 32
  %20 = getelementptr inbounds i8, ptr %6, i64 40
  %21 = load i64, ptr %20, align 8, !noalias !3
  store i64 %21, ptr %19, align 8, !alias.scope !3
  %22 = getelementptr inbounds i8, ptr %4, i64 40
  %23 = getelementptr inbounds i8, ptr %6, i64 48
  %24 = load i64, ptr %23, align 8, !noalias !3
  store i64 %24, ptr %22, align 8, !alias.scope !3
  %25 = getelementptr inbounds i8, ptr %4, i64 48
  %26 = getelementptr inbounds i8, ptr %0, i64 696
  %27 = load ptr, ptr %26, align 8, !noalias !3
  store ptr %27, ptr %25, align 8, !alias.scope !3
  %28 = getelementptr inbounds i8, ptr %4, i64 56
  store ptr null, ptr %28, align 8, !alias.scope !3
  %29 = getelementptr inbounds i8, ptr %4, i64 64
  store ptr null, ptr %29, align 8, !alias.scope !3
  %30 = getelementptr inbounds i8, ptr %4, i64 72
  store ptr null, ptr %30, align 8, !alias.scope !3
  %31 = getelementptr inbounds i8, ptr %4, i64 80
  store ptr null, ptr %31, align 8, !alias.scope !3
  %32 = getelementptr inbounds i8, ptr %4, i64 88
  store ptr null, ptr %32, align 8, !alias.scope !3
  %33 = getelementptr inbounds i8, ptr %4, i64 96
  store ptr null, ptr %33, align 8, !alias.scope !3
  %34 = getelementptr double, ptr %27, i64 %12
  %35 = getelementptr inbounds double, ptr %34, i64 %15
  store ptr %35, ptr %28, align 8, !alias.scope !3
  %36 = mul nsw i64 %18, %12
  %37 = getelementptr inbounds double, ptr %35, i64 %36
  store ptr %37, ptr %29, align 8, !alias.scope !3
  %38 = mul nsw i64 %21, %18
  %39 = getelementptr inbounds double, ptr %37, i64 %38
  store ptr %39, ptr %30, align 8, !alias.scope !3
  %40 = mul i64 %21, %15
  %41 = getelementptr inbounds double, ptr %39, i64 %40
  store ptr %41, ptr %31, align 8, !alias.scope !3
  %42 = mul i64 %21, %21
  %43 = mul i64 %42, %24
  %44 = getelementptr inbounds double, ptr %41, i64 %43
  store ptr %44, ptr %32, align 8, !alias.scope !3
  %45 = getelementptr inbounds double, ptr %44, i64 %12
  store ptr %45, ptr %33, align 8, !alias.scope !3
  %46 = getelementptr inbounds i8, ptr %0, i64 144
  %47 = getelementptr inbounds i8, ptr %0, i64 168
  %48 = load ptr, ptr %47, align 8
  store double %1, ptr %48, align 8
  %49 = getelementptr inbounds i8, ptr %0, i64 248
  %50 = load i64, ptr %49, align 8
  %51 = icmp sgt i64 %50, 0
  br i1 %51, label %52, label %53

52:                                               ; preds = %3
  tail call fastcc void @sample(ptr noundef nonnull %46) #7
  br label %53

53:                                               ; preds = %3, %52
  %54 = getelementptr inbounds i8, ptr %0, i64 600
  %55 = load ptr, ptr %54, align 8
  %56 = getelementptr inbounds i8, ptr %55, i64 88
  %57 = load i64, ptr %56, align 8
  %58 = add nsw i64 %57, 1
  store i64 %58, ptr %56, align 8
  %59 = load ptr, ptr %9, align 8
  %60 = icmp sgt i64 %21, 0
  br i1 %60, label %61, label %75

61:                                               ; preds = %53, %65
  %62 = phi i64 [ %66, %65 ], [ 0, %53 ]
  %63 = mul nuw nsw i64 %62, %21
  %64 = getelementptr double, ptr %59, i64 %63
  br label %68

65:                                               ; preds = %68
  %66 = add nuw nsw i64 %62, 1
  %67 = icmp eq i64 %66, %21
  br i1 %67, label %75, label %61, !llvm.loop !6

68:                                               ; preds = %61, %68
  %69 = phi i64 [ 0, %61 ], [ %73, %68 ]
  %70 = icmp eq i64 %62, %69
  %71 = select i1 %70, double 1.000000e+00, double 0.000000e+00
  %72 = getelementptr double, ptr %64, i64 %69
  store double %71, ptr %72, align 8
  %73 = add nuw nsw i64 %69, 1
  %74 = icmp eq i64 %73, %21
  br i1 %74, label %65, label %68, !llvm.loop !9

75:                                               ; preds = %65, %53
  %76 = getelementptr inbounds i8, ptr %9, i64 264
  %77 = load ptr, ptr %76, align 8
  %78 = icmp sgt i64 %12, 0
  br i1 %78, label %102, label %79

79:                                               ; preds = %102, %75
  %80 = getelementptr inbounds i8, ptr %0, i64 168
  %81 = getelementptr inbounds i8, ptr %0, i64 192
  %82 = getelementptr inbounds i8, ptr %0, i64 672
  %83 = load ptr, ptr %5, align 8
  %84 = getelementptr inbounds i8, ptr %83, i64 8
  %85 = load i64, ptr %84, align 8
  %86 = load ptr, ptr %80, align 8
  %87 = load ptr, ptr %81, align 8
  %88 = load ptr, ptr %82, align 8
  %89 = inttoptr i64 %85 to ptr
  %90 = tail call i32 %89(ptr noundef %86, ptr noundef %2, ptr noundef %87, ptr noundef %88, ptr noundef %27) #8
  %91 = icmp slt i32 %90, 0
  br i1 %91, label %213, label %92

92:                                               ; preds = %79
  %93 = icmp sgt i64 %12, 0
  %94 = icmp eq i64 %24, 1
  %95 = getelementptr inbounds i8, ptr %9, i64 8
  %96 = getelementptr inbounds i8, ptr %9, i64 16
  %97 = getelementptr inbounds i8, ptr %9, i64 24
  %98 = getelementptr inbounds i8, ptr %9, i64 32
  %99 = getelementptr inbounds i8, ptr %9, i64 40
  %100 = getelementptr inbounds i8, ptr %9, i64 144
  %101 = icmp sgt i64 %12, 0
  br label %118

102:                                              ; preds = %75, %102
  %103 = phi i64 [ %105, %102 ], [ 0, %75 ]
  %104 = getelementptr inbounds double, ptr %77, i64 %103
  store double 0.000000e+00, ptr %104, align 8
  %105 = add nuw nsw i64 %103, 1
  %106 = icmp eq i64 %105, %12
  br i1 %106, label %79, label %102, !llvm.loop !10

107:                                              ; preds = %209
  %108 = add nuw nsw i32 %120, 1
  %109 = load ptr, ptr %5, align 8
  %110 = getelementptr inbounds i8, ptr %109, i64 8
  %111 = load i64, ptr %110, align 8
  %112 = load ptr, ptr %80, align 8
  %113 = load ptr, ptr %81, align 8
  %114 = load ptr, ptr %82, align 8
  %115 = inttoptr i64 %111 to ptr
  %116 = tail call i32 %115(ptr noundef %112, ptr noundef %2, ptr noundef %113, ptr noundef %114, ptr noundef %27) #8
  %117 = icmp slt i32 %116, 0
  br i1 %117, label %213, label %118, !llvm.loop !11

118:                                              ; preds = %92, %107
  %119 = phi i64 [ undef, %92 ], [ %212, %107 ]
  %120 = phi i32 [ 0, %92 ], [ %108, %107 ]
  %121 = phi double [ 0x7FF0000000000000, %92 ], [ %210, %107 ]
  br i1 %93, label %126, label %150

122:                                              ; preds = %146
  %123 = add nuw nsw i64 %129, 1
  %124 = icmp slt i64 %123, %12
  %125 = icmp eq i64 %123, %12
  br i1 %125, label %150, label %126, !llvm.loop !12

126:                                              ; preds = %118, %122
  %127 = phi i1 [ %124, %122 ], [ %93, %118 ]
  %128 = phi i64 [ %149, %122 ], [ %119, %118 ]
  %129 = phi i64 [ %123, %122 ], [ 0, %118 ]
  %130 = phi double [ %147, %122 ], [ 0.000000e+00, %118 ]
  %131 = getelementptr inbounds double, ptr %27, i64 %129
  %132 = load double, ptr %131, align 8
  %133 = tail call double @llvm.fabs.f64(double %132)
  %134 = fcmp une double %132, 0.000000e+00
  br i1 %134, label %135, label %146

135:                                              ; preds = %126
  %136 = getelementptr inbounds double, ptr %44, i64 %129
  %137 = load double, ptr %136, align 8
  %138 = getelementptr inbounds double, ptr %77, i64 %129
  %139 = load double, ptr %138, align 8
  %140 = fcmp ogt double %137, %139
  %141 = select i1 %140, double %137, double %139
  %142 = fmul double %141, 0x3CB0000000000000
  %143 = fdiv double %133, %142
  %144 = fcmp ogt double %143, %130
  %145 = select i1 %144, double %143, double %130
  br label %146

146:                                              ; preds = %135, %126
  %147 = phi double [ %145, %135 ], [ %130, %126 ]
  %148 = fcmp ueq double %133, 0x7FF0000000000000
  %149 = select i1 %148, i64 6, i64 %128
  br i1 %148, label %150, label %122

150:                                              ; preds = %122, %146, %118
  %151 = phi i1 [ %93, %118 ], [ %124, %122 ], [ %127, %146 ]
  %152 = phi double [ 0.000000e+00, %118 ], [ %147, %146 ], [ %147, %122 ]
  %153 = phi i64 [ %119, %118 ], [ %149, %146 ], [ %149, %122 ]
  br i1 %151, label %209, label %154

154:                                              ; preds = %150
  %155 = fcmp ugt double %152, 1.000000e+00
  br i1 %155, label %156, label %209

156:                                              ; preds = %154
  %157 = fmul double %121, 5.000000e-01
  %158 = fcmp oge double %152, %157
  %159 = fcmp ole double %152, 8.000000e+00
  %160 = and i1 %158, %159
  br i1 %160, label %209, label %161

161:                                              ; preds = %156
  %162 = icmp eq i32 %120, 9
  br i1 %162, label %209, label %163

163:                                              ; preds = %161
  br i1 %94, label %164, label %182

164:                                              ; preds = %163
  %165 = load i64, ptr %95, align 8
  %166 = load i64, ptr %96, align 8
  %167 = mul nsw i64 %166, %165
  %168 = icmp sgt i64 %167, 0
  br i1 %168, label %169, label %180

169:                                              ; preds = %164, %169
  %170 = phi i64 [ %175, %169 ], [ 0, %164 ]
  %171 = getelementptr inbounds double, ptr %41, i64 %170
  %172 = load double, ptr %171, align 8
  %173 = load ptr, ptr %9, align 8
  %174 = getelementptr inbounds double, ptr %173, i64 %170
  store double %172, ptr %174, align 8
  %175 = add nuw nsw i64 %170, 1
  %176 = load i64, ptr %95, align 8
  %177 = load i64, ptr %96, align 8
  %178 = mul nsw i64 %177, %176
  %179 = icmp slt i64 %175, %178
  br i1 %179, label %169, label %180, !llvm.loop !13

180:                                              ; preds = %169, %164
  %181 = load ptr, ptr %9, align 8
  tail call fastcc void @factorise(ptr noundef %181, i64 noundef %21) #7
  br label %182

182:                                              ; preds = %163, %180
  %183 = load i64, ptr %98, align 8
  %184 = load i64, ptr %99, align 8
  %185 = mul nsw i64 %184, %183
  %186 = icmp sgt i64 %185, 0
  br i1 %186, label %187, label %198

187:                                              ; preds = %182, %187
  %188 = phi i64 [ %193, %187 ], [ 0, %182 ]
  %189 = getelementptr inbounds double, ptr %37, i64 %188
  %190 = load double, ptr %189, align 8
  %191 = load ptr, ptr %97, align 8
  %192 = getelementptr inbounds double, ptr %191, i64 %188
  store double %190, ptr %192, align 8
  %193 = add nuw nsw i64 %188, 1
  %194 = load i64, ptr %98, align 8
  %195 = load i64, ptr %99, align 8
  %196 = mul nsw i64 %195, %194
  %197 = icmp slt i64 %193, %196
  br i1 %197, label %187, label %198, !llvm.loop !13

198:                                              ; preds = %187, %182
  %199 = load ptr, ptr %100, align 8
  br i1 %101, label %200, label %208

200:                                              ; preds = %198, %200
  %201 = phi i64 [ %206, %200 ], [ 0, %198 ]
  %202 = getelementptr inbounds double, ptr %27, i64 %201
  %203 = load double, ptr %202, align 8
  %204 = fneg double %203
  %205 = getelementptr inbounds double, ptr %199, i64 %201
  store double %204, ptr %205, align 8
  %206 = add nuw nsw i64 %201, 1
  %207 = icmp eq i64 %206, %12
  br i1 %207, label %208, label %200, !llvm.loop !14

208:                                              ; preds = %200, %198
  call fastcc void @move_positions(ptr noundef nonnull %4, ptr noundef %2) #7
  br label %209

209:                                              ; preds = %208, %161, %156, %154, %150
  %210 = phi double [ %152, %208 ], [ %121, %150 ], [ %121, %156 ], [ %121, %154 ], [ %121, %161 ]
  %211 = phi i1 [ true, %208 ], [ false, %150 ], [ false, %156 ], [ false, %154 ], [ false, %161 ]
  %212 = phi i64 [ %153, %208 ], [ %153, %150 ], [ 0, %156 ], [ 0, %154 ], [ 6, %161 ]
  br i1 %211, label %107, label %213

213:                                              ; preds = %209, %107, %79
  %214 = phi i64 [ 6, %79 ], [ %212, %209 ], [ 6, %107 ]
  %215 = icmp ne i64 %214, 0
  %216 = icmp eq i64 %15, 0
  %217 = select i1 %215, i1 true, i1 %216
  br i1 %217, label %342, label %218

218:                                              ; preds = %213
  %219 = icmp sgt i64 %15, 0
  br i1 %219, label %223, label %220

220:                                              ; preds = %223, %218
  %221 = phi double [ 0.000000e+00, %218 ], [ %229, %223 ]
  %222 = icmp sgt i64 %40, 0
  br i1 %222, label %235, label %232

223:                                              ; preds = %218, %223
  %224 = phi i64 [ %230, %223 ], [ 0, %218 ]
  %225 = phi double [ %229, %223 ], [ 0.000000e+00, %218 ]
  %226 = getelementptr double, ptr %34, i64 %224
  %227 = load double, ptr %226, align 8
  %228 = fmul double %227, 0.000000e+00
  %229 = fadd double %225, %228
  %230 = add nuw nsw i64 %224, 1
  %231 = icmp eq i64 %230, %15
  br i1 %231, label %220, label %223, !llvm.loop !15

232:                                              ; preds = %235, %220
  %233 = phi double [ %221, %220 ], [ %241, %235 ]
  %234 = fcmp une double %233, 0.000000e+00
  br i1 %234, label %342, label %244

235:                                              ; preds = %220, %235
  %236 = phi i64 [ %242, %235 ], [ 0, %220 ]
  %237 = phi double [ %241, %235 ], [ %221, %220 ]
  %238 = getelementptr inbounds double, ptr %39, i64 %236
  %239 = load double, ptr %238, align 8
  %240 = fmul double %239, 0.000000e+00
  %241 = fadd double %237, %240
  %242 = add nuw nsw i64 %236, 1
  %243 = icmp eq i64 %242, %40
  br i1 %243, label %232, label %235, !llvm.loop !16

244:                                              ; preds = %232
  %245 = icmp eq i64 %24, 1
  br i1 %245, label %246, label %266

246:                                              ; preds = %244
  %247 = getelementptr inbounds i8, ptr %9, i64 8
  %248 = getelementptr inbounds i8, ptr %9, i64 16
  %249 = load i64, ptr %247, align 8
  %250 = load i64, ptr %248, align 8
  %251 = mul nsw i64 %250, %249
  %252 = icmp sgt i64 %251, 0
  br i1 %252, label %253, label %264

253:                                              ; preds = %246, %253
  %254 = phi i64 [ %259, %253 ], [ 0, %246 ]
  %255 = getelementptr inbounds double, ptr %41, i64 %254
  %256 = load double, ptr %255, align 8
  %257 = load ptr, ptr %9, align 8
  %258 = getelementptr inbounds double, ptr %257, i64 %254
  store double %256, ptr %258, align 8
  %259 = add nuw nsw i64 %254, 1
  %260 = load i64, ptr %247, align 8
  %261 = load i64, ptr %248, align 8
  %262 = mul nsw i64 %261, %260
  %263 = icmp slt i64 %259, %262
  br i1 %263, label %253, label %264, !llvm.loop !13

264:                                              ; preds = %253, %246
  %265 = load ptr, ptr %9, align 8
  tail call fastcc void @factorise(ptr noundef %265, i64 noundef %21) #7
  br label %266

266:                                              ; preds = %244, %264
  %267 = getelementptr inbounds i8, ptr %9, i64 144
  %268 = load ptr, ptr %267, align 8
  %269 = icmp sgt i64 %15, 0
  br i1 %269, label %270, label %278

270:                                              ; preds = %266, %270
  %271 = phi i64 [ %276, %270 ], [ 0, %266 ]
  %272 = getelementptr inbounds double, ptr %34, i64 %271
  %273 = load double, ptr %272, align 8
  %274 = fneg double %273
  %275 = getelementptr inbounds double, ptr %268, i64 %271
  store double %274, ptr %275, align 8
  %276 = add nuw nsw i64 %271, 1
  %277 = icmp eq i64 %276, %15
  br i1 %277, label %278, label %270, !llvm.loop !14

278:                                              ; preds = %270, %266
  call fastcc void @move_speeds(ptr noundef nonnull %4, ptr noundef %2) #7
  %279 = load ptr, ptr %46, align 8
  %280 = getelementptr inbounds i8, ptr %279, i64 8
  %281 = load i64, ptr %280, align 8
  %282 = getelementptr inbounds i8, ptr %9, i64 216
  %283 = load ptr, ptr %282, align 8
  %284 = getelementptr inbounds i8, ptr %9, i64 240
  %285 = load ptr, ptr %284, align 8
  %286 = getelementptr inbounds i8, ptr %45, i64 24
  %287 = getelementptr inbounds double, ptr %286, i64 %281
  %288 = icmp sgt i64 %15, 0
  br i1 %288, label %296, label %291

289:                                              ; preds = %314
  %290 = sitofp i64 %316 to double
  br label %291

291:                                              ; preds = %289, %278
  %292 = phi double [ 1.000000e+00, %278 ], [ %315, %289 ]
  %293 = phi double [ 0.000000e+00, %278 ], [ %290, %289 ]
  %294 = load double, ptr %45, align 8
  %295 = fcmp olt double %294, %293
  br i1 %295, label %319, label %321

296:                                              ; preds = %278, %314
  %297 = phi i64 [ %317, %314 ], [ 0, %278 ]
  %298 = phi i64 [ %316, %314 ], [ 0, %278 ]
  %299 = phi double [ %315, %314 ], [ 1.000000e+00, %278 ]
  %300 = getelementptr inbounds double, ptr %283, i64 %297
  %301 = load double, ptr %300, align 8
  %302 = getelementptr inbounds double, ptr %287, i64 %297
  %303 = load double, ptr %302, align 8
  %304 = fcmp ogt double %301, %303
  %305 = select i1 %304, double %301, double %303
  store double %305, ptr %302, align 8
  %306 = getelementptr inbounds double, ptr %285, i64 %297
  %307 = load double, ptr %306, align 8
  %308 = fcmp ogt double %307, 0.000000e+00
  br i1 %308, label %309, label %314

309:                                              ; preds = %296
  %310 = add nsw i64 %298, 1
  %311 = fdiv double %307, %305
  %312 = fcmp olt double %311, %299
  %313 = select i1 %312, double %311, double %299
  br label %314

314:                                              ; preds = %309, %296
  %315 = phi double [ %313, %309 ], [ %299, %296 ]
  %316 = phi i64 [ %310, %309 ], [ %298, %296 ]
  %317 = add nuw nsw i64 %297, 1
  %318 = icmp eq i64 %317, %15
  br i1 %318, label %289, label %296, !llvm.loop !17

319:                                              ; preds = %291
  store double %293, ptr %45, align 8
  %320 = getelementptr inbounds i8, ptr %45, i64 8
  store double 1.000000e+00, ptr %320, align 8
  br label %324

321:                                              ; preds = %291
  %322 = fcmp ogt double %294, %293
  br i1 %322, label %323, label %324

323:                                              ; preds = %321
  br label %324

324:                                              ; preds = %323, %321, %319
  %325 = phi double [ %292, %319 ], [ 0.000000e+00, %323 ], [ %292, %321 ]
  %326 = getelementptr inbounds i8, ptr %45, i64 8
  %327 = load double, ptr %326, align 8
  %328 = fcmp olt double %325, %327
  %329 = fcmp ogt double %327, 1.000000e-05
  %330 = and i1 %328, %329
  br i1 %330, label %331, label %342

331:                                              ; preds = %324
  store double %325, ptr %326, align 8
  %332 = getelementptr inbounds i8, ptr %45, i64 16
  store double %1, ptr %332, align 8
  %333 = getelementptr inbounds i8, ptr %45, i64 24
  %334 = icmp sgt i64 %281, 0
  br i1 %334, label %335, label %342

335:                                              ; preds = %331, %335
  %336 = phi i64 [ %340, %335 ], [ 0, %331 ]
  %337 = getelementptr inbounds double, ptr %2, i64 %336
  %338 = load double, ptr %337, align 8
  %339 = getelementptr inbounds double, ptr %333, i64 %336
  store double %338, ptr %339, align 8
  %340 = add nuw nsw i64 %336, 1
  %341 = icmp eq i64 %340, %281
  br i1 %341, label %342, label %335, !llvm.loop !18

342:                                              ; preds = %335, %331, %324, %232, %213
  %343 = phi i64 [ %214, %213 ], [ 6, %232 ], [ 0, %324 ], [ 0, %331 ], [ 0, %335 ]
  ret i64 %343
}



define internal fastcc void @move_speeds(ptr noundef readonly %0, ptr noundef %1) unnamed_addr #2 {
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %0, i64 72
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
  br i1 %23, label %13, label %24, !llvm.loop !13

24:                                               ; preds = %13, %2
  %25 = load ptr, ptr %6, align 8
  %26 = getelementptr inbounds i8, ptr %0, i64 16
  %27 = load i64, ptr %26, align 8
  %28 = load ptr, ptr %3, align 8
  %29 = getelementptr inbounds i8, ptr %0, i64 32
  %30 = load i64, ptr %29, align 8
  tail call fastcc void @divide_rows(ptr noundef %25, i64 noundef %27, ptr noundef %28, i64 noundef %30) #7
  tail call fastcc void @minimum_norm(ptr noundef nonnull %6, ptr noundef nonnull %3) #7
  %31 = load ptr, ptr %3, align 8
  %32 = load i64, ptr %29, align 8
  %33 = getelementptr inbounds i8, ptr %3, i64 120
  %34 = load ptr, ptr %33, align 8
  tail call fastcc void @divide_transposed(ptr noundef %31, i64 noundef %32, ptr noundef %34) #7
  %35 = load i64, ptr %29, align 8
  %36 = icmp sgt i64 %35, 0
  br i1 %36, label %37, label %39

37:                                               ; preds = %24
  %38 = getelementptr inbounds i8, ptr %0, i64 24
  br label %40

39:                                               ; preds = %40, %24
  ret void

40:                                               ; preds = %37, %40
  %41 = phi i64 [ 0, %37 ], [ %50, %40 ]
  %42 = load ptr, ptr %33, align 8
  %43 = getelementptr inbounds double, ptr %42, i64 %41
  %44 = load double, ptr %43, align 8
  %45 = load i64, ptr %38, align 8
  %46 = getelementptr double, ptr %1, i64 %45
  %47 = getelementptr double, ptr %46, i64 %41
  %48 = load double, ptr %47, align 8
  %49 = fadd double %44, %48
  store double %49, ptr %47, align 8
  %50 = add nuw nsw i64 %41, 1
  %51 = load i64, ptr %29, align 8
  %52 = icmp slt i64 %50, %51
  br i1 %52, label %40, label %39, !llvm.loop !19
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
  br i1 %55, label %44, label %56, !llvm.loop !20

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
  br i1 %83, label %13, label %12, !llvm.loop !21
}

declare double @llvm.fabs.f64(double) #3

define internal fastcc void @move_positions(ptr noundef readonly %0, ptr noundef %1) unnamed_addr #2 {
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %0, i64 56
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %3, i64 48
  %7 = getelementptr inbounds i8, ptr %3, i64 56
  %8 = getelementptr inbounds i8, ptr %3, i64 64
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
  br i1 %23, label %13, label %24, !llvm.loop !13

24:                                               ; preds = %13, %2
  %25 = getelementptr inbounds i8, ptr %3, i64 24
  %26 = load ptr, ptr %6, align 8
  %27 = getelementptr inbounds i8, ptr %3, i64 72
  tail call fastcc void @set_rows(ptr noundef nonnull %25, ptr noundef %26, ptr noundef nonnull %27) #7
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr inbounds i8, ptr %0, i64 8
  %30 = load i64, ptr %29, align 8
  %31 = load ptr, ptr %3, align 8
  %32 = getelementptr inbounds i8, ptr %0, i64 32
  %33 = load i64, ptr %32, align 8
  tail call fastcc void @divide_rows(ptr noundef %28, i64 noundef %30, ptr noundef %31, i64 noundef %33) #7
  tail call fastcc void @minimum_norm(ptr noundef nonnull %27, ptr noundef nonnull %3) #7
  %34 = getelementptr inbounds i8, ptr %3, i64 120
  %35 = load ptr, ptr %34, align 8
  %36 = load i64, ptr %32, align 8
  %37 = icmp sgt i64 %36, 0
  br i1 %37, label %38, label %47

38:                                               ; preds = %24, %38
  %39 = phi i64 [ %45, %38 ], [ 0, %24 ]
  %40 = phi double [ %44, %38 ], [ 0.000000e+00, %24 ]
  %41 = getelementptr inbounds double, ptr %35, i64 %39
  %42 = load double, ptr %41, align 8
  %43 = fmul double %42, %42
  %44 = fadd double %40, %43
  %45 = add nuw nsw i64 %39, 1
  %46 = icmp eq i64 %45, %36
  br i1 %46, label %47, label %38, !llvm.loop !22

47:                                               ; preds = %38, %24
  %48 = phi double [ 0.000000e+00, %24 ], [ %44, %38 ]
  %49 = tail call double @llvm.sqrt.f64(double %48)
  %50 = load i64, ptr %29, align 8
  %51 = icmp sgt i64 %50, 0
  br i1 %51, label %52, label %55

52:                                               ; preds = %47
  %53 = getelementptr inbounds i8, ptr %3, i64 264
  %54 = getelementptr inbounds i8, ptr %3, i64 216
  br label %62

55:                                               ; preds = %73, %47
  %56 = load ptr, ptr %3, align 8
  %57 = load i64, ptr %32, align 8
  %58 = load ptr, ptr %34, align 8
  tail call fastcc void @divide_transposed(ptr noundef %56, i64 noundef %57, ptr noundef %58) #7
  %59 = getelementptr inbounds i8, ptr %0, i64 24
  %60 = load i64, ptr %59, align 8
  %61 = icmp sgt i64 %60, 0
  br i1 %61, label %77, label %83

62:                                               ; preds = %52, %73
  %63 = phi i64 [ 0, %52 ], [ %74, %73 ]
  %64 = load ptr, ptr %53, align 8
  %65 = getelementptr inbounds double, ptr %64, i64 %63
  %66 = load double, ptr %65, align 8
  %67 = fcmp oeq double %66, 0.000000e+00
  br i1 %67, label %68, label %73

68:                                               ; preds = %62
  %69 = load ptr, ptr %54, align 8
  %70 = getelementptr inbounds double, ptr %69, i64 %63
  %71 = load double, ptr %70, align 8
  %72 = fmul double %49, %71
  store double %72, ptr %65, align 8
  br label %73

73:                                               ; preds = %62, %68
  %74 = add nuw nsw i64 %63, 1
  %75 = load i64, ptr %29, align 8
  %76 = icmp slt i64 %74, %75
  br i1 %76, label %62, label %55, !llvm.loop !23

77:                                               ; preds = %55, %90
  %78 = phi i64 [ %91, %90 ], [ 0, %55 ]
  %79 = load i64, ptr %32, align 8
  %80 = icmp sgt i64 %79, 0
  br i1 %80, label %81, label %90

81:                                               ; preds = %77
  %82 = getelementptr inbounds double, ptr %1, i64 %78
  br label %94

83:                                               ; preds = %90, %55
  %84 = getelementptr inbounds i8, ptr %0, i64 24
  %85 = load i64, ptr %29, align 8
  %86 = icmp sgt i64 %85, 0
  br i1 %86, label %87, label %137

87:                                               ; preds = %83
  %88 = getelementptr inbounds i8, ptr %3, i64 144
  %89 = load ptr, ptr %88, align 8
  br label %113

90:                                               ; preds = %94, %77
  %91 = add nuw nsw i64 %78, 1
  %92 = load i64, ptr %59, align 8
  %93 = icmp slt i64 %91, %92
  br i1 %93, label %77, label %83, !llvm.loop !24

94:                                               ; preds = %81, %94
  %95 = phi i64 [ %79, %81 ], [ %109, %94 ]
  %96 = phi i64 [ 0, %81 ], [ %108, %94 ]
  %97 = load ptr, ptr %25, align 8
  %98 = mul nsw i64 %95, %78
  %99 = getelementptr double, ptr %97, i64 %98
  %100 = getelementptr double, ptr %99, i64 %96
  %101 = load double, ptr %100, align 8
  %102 = load ptr, ptr %34, align 8
  %103 = getelementptr inbounds double, ptr %102, i64 %96
  %104 = load double, ptr %103, align 8
  %105 = fmul double %101, %104
  %106 = load double, ptr %82, align 8
  %107 = fadd double %106, %105
  store double %107, ptr %82, align 8
  %108 = add nuw nsw i64 %96, 1
  %109 = load i64, ptr %32, align 8
  %110 = icmp slt i64 %108, %109
  br i1 %110, label %94, label %90, !llvm.loop !25

111:                                              ; preds = %113
  %112 = fcmp ogt double %120, 0.000000e+00
  br i1 %112, label %123, label %137

113:                                              ; preds = %87, %113
  %114 = phi i64 [ 0, %87 ], [ %121, %113 ]
  %115 = phi double [ 0.000000e+00, %87 ], [ %120, %113 ]
  %116 = getelementptr inbounds double, ptr %89, i64 %114
  %117 = load double, ptr %116, align 8
  %118 = tail call double @llvm.fabs.f64(double %117)
  %119 = fcmp ogt double %118, %115
  %120 = select i1 %119, double %118, double %115
  %121 = add nuw nsw i64 %114, 1
  %122 = icmp eq i64 %121, %85
  br i1 %122, label %111, label %113, !llvm.loop !26

123:                                              ; preds = %111
  tail call fastcc void @minimum_norm(ptr noundef nonnull %6, ptr noundef nonnull %3) #7
  %124 = load i64, ptr %84, align 8
  %125 = icmp sgt i64 %124, 0
  br i1 %125, label %126, label %137

126:                                              ; preds = %123, %126
  %127 = phi i64 [ %134, %126 ], [ 0, %123 ]
  %128 = load ptr, ptr %34, align 8
  %129 = getelementptr inbounds double, ptr %128, i64 %127
  %130 = load double, ptr %129, align 8
  %131 = getelementptr inbounds double, ptr %1, i64 %127
  %132 = load double, ptr %131, align 8
  %133 = fadd double %130, %132
  store double %133, ptr %131, align 8
  %134 = add nuw nsw i64 %127, 1
  %135 = load i64, ptr %84, align 8
  %136 = icmp slt i64 %134, %135
  br i1 %136, label %126, label %137, !llvm.loop !27

137:                                              ; preds = %126, %83, %123, %111
  ret void
}

define internal fastcc void @set_rows(ptr noundef readonly %0, ptr noundef readonly %1, ptr noundef readonly %2) unnamed_addr #2 {
  %4 = getelementptr inbounds i8, ptr %0, i64 8
  %5 = load i64, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 16
  %7 = load i64, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %2, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = icmp sgt i64 %9, 0
  br i1 %10, label %11, label %23

11:                                               ; preds = %3
  %12 = icmp sgt i64 %7, 0
  %13 = icmp sgt i64 %5, 0
  %14 = sitofp i64 %5 to double
  %15 = fmul double %14, 4.000000e+00
  %16 = fmul double %15, 0x3CB0000000000000
  br label %17

17:                                               ; preds = %11, %29
  %18 = phi i64 [ 0, %11 ], [ %30, %29 ]
  br i1 %12, label %19, label %29

19:                                               ; preds = %17
  %20 = mul nsw i64 %18, %5
  %21 = getelementptr double, ptr %1, i64 %20
  %22 = mul nuw nsw i64 %18, %7
  br label %24

23:                                               ; preds = %29, %3
  ret void

24:                                               ; preds = %19, %33
  %25 = phi i64 [ 0, %19 ], [ %43, %33 ]
  br i1 %13, label %26, label %33

26:                                               ; preds = %24
  %27 = load ptr, ptr %0, align 8
  %28 = getelementptr double, ptr %27, i64 %25
  br label %45

29:                                               ; preds = %33, %17
  %30 = add nuw nsw i64 %18, 1
  %31 = load i64, ptr %8, align 8
  %32 = icmp slt i64 %30, %31
  br i1 %32, label %17, label %23, !llvm.loop !28

33:                                               ; preds = %45, %24
  %34 = phi double [ 0.000000e+00, %24 ], [ %55, %45 ]
  %35 = phi double [ 0.000000e+00, %24 ], [ %57, %45 ]
  %36 = tail call double @llvm.fabs.f64(double %34)
  %37 = fmul double %16, %35
  %38 = fcmp ole double %36, %37
  %39 = select i1 %38, double 0.000000e+00, double %34
  %40 = load ptr, ptr %2, align 8
  %41 = getelementptr double, ptr %40, i64 %22
  %42 = getelementptr double, ptr %41, i64 %25
  store double %39, ptr %42, align 8
  %43 = add nuw nsw i64 %25, 1
  %44 = icmp eq i64 %43, %7
  br i1 %44, label %29, label %24, !llvm.loop !29

45:                                               ; preds = %26, %45
  %46 = phi i64 [ 0, %26 ], [ %58, %45 ]
  %47 = phi double [ 0.000000e+00, %26 ], [ %57, %45 ]
  %48 = phi double [ 0.000000e+00, %26 ], [ %55, %45 ]
  %49 = getelementptr double, ptr %21, i64 %46
  %50 = load double, ptr %49, align 8
  %51 = mul nuw nsw i64 %46, %7
  %52 = getelementptr double, ptr %28, i64 %51
  %53 = load double, ptr %52, align 8
  %54 = fmul double %50, %53
  %55 = fadd double %48, %54
  %56 = tail call double @llvm.fabs.f64(double %54)
  %57 = fadd double %47, %56
  %58 = add nuw nsw i64 %46, 1
  %59 = icmp eq i64 %58, %5
  br i1 %59, label %33, label %45, !llvm.loop !30
}

define internal fastcc void @divide_rows(ptr noundef %0, i64 noundef %1, ptr noundef readonly %2, i64 noundef %3) unnamed_addr #4 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %6, label %14

6:                                                ; preds = %4
  %7 = icmp sgt i64 %3, 0
  %8 = add i64 %3, 1
  br label %9

9:                                                ; preds = %6, %15
  %10 = phi i64 [ 0, %6 ], [ %16, %15 ]
  br i1 %7, label %11, label %15

11:                                               ; preds = %9
  %12 = mul nuw nsw i64 %10, %3
  %13 = getelementptr double, ptr %0, i64 %12
  br label %18

14:                                               ; preds = %15, %4
  ret void

15:                                               ; preds = %26, %9
  %16 = add nuw nsw i64 %10, 1
  %17 = icmp eq i64 %16, %1
  br i1 %17, label %14, label %9, !llvm.loop !31

18:                                               ; preds = %11, %26
  %19 = phi i64 [ 0, %11 ], [ %32, %26 ]
  %20 = getelementptr double, ptr %13, i64 %19
  %21 = load double, ptr %20, align 8
  %22 = icmp eq i64 %19, 0
  br i1 %22, label %26, label %23

23:                                               ; preds = %18
  %24 = mul nuw nsw i64 %19, %3
  %25 = getelementptr double, ptr %2, i64 %24
  br label %34

26:                                               ; preds = %34, %18
  %27 = phi double [ %21, %18 ], [ %42, %34 ]
  %28 = mul i64 %19, %8
  %29 = getelementptr inbounds double, ptr %2, i64 %28
  %30 = load double, ptr %29, align 8
  %31 = fdiv double %27, %30
  store double %31, ptr %20, align 8
  %32 = add nuw nsw i64 %19, 1
  %33 = icmp eq i64 %32, %3
  br i1 %33, label %15, label %18, !llvm.loop !32

34:                                               ; preds = %23, %34
  %35 = phi i64 [ 0, %23 ], [ %43, %34 ]
  %36 = phi double [ %21, %23 ], [ %42, %34 ]
  %37 = getelementptr double, ptr %25, i64 %35
  %38 = load double, ptr %37, align 8
  %39 = getelementptr double, ptr %13, i64 %35
  %40 = load double, ptr %39, align 8
  %41 = fmul double %38, %40
  %42 = fsub double %36, %41
  %43 = add nuw nsw i64 %35, 1
  %44 = icmp eq i64 %43, %19
  br i1 %44, label %26, label %34, !llvm.loop !33
}

define internal fastcc void @minimum_norm(ptr noundef readonly %0, ptr noundef readonly %1) unnamed_addr #2 {
  %3 = getelementptr inbounds i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = load ptr, ptr %0, align 8
  %8 = getelementptr inbounds i8, ptr %1, i64 120
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %1, i64 144
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %1, i64 168
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %1, i64 216
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %1, i64 240
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %1, i64 192
  %19 = load ptr, ptr %18, align 8
  %20 = icmp sgt i64 %6, 0
  br i1 %20, label %26, label %21

21:                                               ; preds = %26, %2
  %22 = icmp sgt i64 %4, 0
  br i1 %22, label %23, label %31

23:                                               ; preds = %21
  %24 = icmp sgt i64 %6, 0
  %25 = icmp sgt i64 %6, 0
  br label %38

26:                                               ; preds = %2, %26
  %27 = phi i64 [ %29, %26 ], [ 0, %2 ]
  %28 = getelementptr inbounds double, ptr %9, i64 %27
  store double 0.000000e+00, ptr %28, align 8
  %29 = add nuw nsw i64 %27, 1
  %30 = icmp eq i64 %29, %6
  br i1 %30, label %21, label %26, !llvm.loop !34

31:                                               ; preds = %72, %21
  %32 = icmp sgt i64 %4, 0
  br i1 %32, label %33, label %173

33:                                               ; preds = %31
  %34 = icmp sgt i64 %6, 0
  %35 = icmp sgt i64 %6, 0
  %36 = icmp sgt i64 %6, 0
  %37 = icmp sgt i64 %6, 0
  br label %75

38:                                               ; preds = %23, %72
  %39 = phi i64 [ 0, %23 ], [ %73, %72 ]
  %40 = mul nsw i64 %39, %6
  %41 = getelementptr inbounds double, ptr %7, i64 %40
  br i1 %24, label %42, label %51

42:                                               ; preds = %38, %42
  %43 = phi i64 [ %49, %42 ], [ 0, %38 ]
  %44 = phi double [ %48, %42 ], [ 0.000000e+00, %38 ]
  %45 = getelementptr inbounds double, ptr %41, i64 %43
  %46 = load double, ptr %45, align 8
  %47 = fmul double %46, %46
  %48 = fadd double %44, %47
  %49 = add nuw nsw i64 %43, 1
  %50 = icmp eq i64 %49, %6
  br i1 %50, label %51, label %42, !llvm.loop !22

51:                                               ; preds = %42, %38
  %52 = phi double [ 0.000000e+00, %38 ], [ %48, %42 ]
  %53 = getelementptr inbounds double, ptr %13, i64 %39
  store double 1.000000e+00, ptr %53, align 8
  %54 = getelementptr inbounds i64, ptr %19, i64 %39
  store i64 1, ptr %54, align 8
  %55 = getelementptr inbounds double, ptr %15, i64 %39
  store double 0.000000e+00, ptr %55, align 8
  %56 = getelementptr inbounds double, ptr %17, i64 %39
  store double 0.000000e+00, ptr %56, align 8
  %57 = fcmp ogt double %52, 0.000000e+00
  br i1 %57, label %58, label %72

58:                                               ; preds = %51
  %59 = tail call double @llvm.sqrt.f64(double %52)
  store double %59, ptr %55, align 8
  %60 = fdiv double 1.000000e+00, %59
  store double %60, ptr %53, align 8
  %61 = getelementptr inbounds double, ptr %11, i64 %39
  %62 = load double, ptr %61, align 8
  %63 = fmul double %60, %62
  store double %63, ptr %61, align 8
  br i1 %25, label %64, label %72

64:                                               ; preds = %58, %64
  %65 = phi i64 [ %70, %64 ], [ 0, %58 ]
  %66 = load double, ptr %53, align 8
  %67 = getelementptr inbounds double, ptr %41, i64 %65
  %68 = load double, ptr %67, align 8
  %69 = fmul double %66, %68
  store double %69, ptr %67, align 8
  %70 = add nuw nsw i64 %65, 1
  %71 = icmp eq i64 %70, %6
  br i1 %71, label %72, label %64, !llvm.loop !35

72:                                               ; preds = %64, %58, %51
  %73 = add nuw nsw i64 %39, 1
  %74 = icmp eq i64 %73, %4
  br i1 %74, label %31, label %38, !llvm.loop !36

75:                                               ; preds = %33, %170
  %76 = phi i64 [ 0, %33 ], [ %171, %170 ]
  br label %79

77:                                               ; preds = %103
  %78 = icmp sgt i64 %104, -1
  br i1 %78, label %108, label %173

79:                                               ; preds = %75, %103
  %80 = phi i64 [ %106, %103 ], [ 0, %75 ]
  %81 = phi double [ %105, %103 ], [ 0x3BC79CA10C924224, %75 ]
  %82 = phi i64 [ %104, %103 ], [ -1, %75 ]
  %83 = getelementptr inbounds i64, ptr %19, i64 %80
  %84 = load i64, ptr %83, align 8
  %85 = icmp eq i64 %84, 1
  br i1 %85, label %86, label %103

86:                                               ; preds = %79
  %87 = mul nsw i64 %80, %6
  %88 = getelementptr inbounds double, ptr %7, i64 %87
  br i1 %34, label %89, label %98

89:                                               ; preds = %86, %89
  %90 = phi i64 [ %96, %89 ], [ 0, %86 ]
  %91 = phi double [ %95, %89 ], [ 0.000000e+00, %86 ]
  %92 = getelementptr inbounds double, ptr %88, i64 %90
  %93 = load double, ptr %92, align 8
  %94 = fmul double %93, %93
  %95 = fadd double %91, %94
  %96 = add nuw nsw i64 %90, 1
  %97 = icmp eq i64 %96, %6
  br i1 %97, label %98, label %89, !llvm.loop !22

98:                                               ; preds = %89, %86
  %99 = phi double [ 0.000000e+00, %86 ], [ %95, %89 ]
  %100 = fcmp ogt double %99, %81
  %101 = select i1 %100, i64 %80, i64 %82
  %102 = select i1 %100, double %99, double %81
  br label %103

103:                                              ; preds = %79, %98
  %104 = phi i64 [ %101, %98 ], [ %82, %79 ]
  %105 = phi double [ %102, %98 ], [ %81, %79 ]
  %106 = add nuw nsw i64 %80, 1
  %107 = icmp eq i64 %106, %4
  br i1 %107, label %77, label %79, !llvm.loop !37

108:                                              ; preds = %77
  %109 = tail call double @llvm.sqrt.f64(double %105)
  %110 = getelementptr inbounds double, ptr %11, i64 %104
  %111 = load double, ptr %110, align 8
  %112 = fdiv double %111, %109
  %113 = mul nsw i64 %104, %6
  %114 = getelementptr inbounds double, ptr %7, i64 %113
  %115 = getelementptr inbounds i64, ptr %19, i64 %104
  store i64 0, ptr %115, align 8
  store double 0.000000e+00, ptr %110, align 8
  %116 = getelementptr inbounds double, ptr %15, i64 %104
  %117 = load double, ptr %116, align 8
  %118 = fmul double %109, %117
  %119 = getelementptr inbounds double, ptr %17, i64 %104
  store double %118, ptr %119, align 8
  br i1 %35, label %120, label %131

120:                                              ; preds = %108, %120
  %121 = phi i64 [ %129, %120 ], [ 0, %108 ]
  %122 = getelementptr inbounds double, ptr %114, i64 %121
  %123 = load double, ptr %122, align 8
  %124 = fdiv double %123, %109
  store double %124, ptr %122, align 8
  %125 = fmul double %112, %124
  %126 = getelementptr inbounds double, ptr %9, i64 %121
  %127 = load double, ptr %126, align 8
  %128 = fadd double %127, %125
  store double %128, ptr %126, align 8
  %129 = add nuw nsw i64 %121, 1
  %130 = icmp eq i64 %129, %6
  br i1 %130, label %131, label %120, !llvm.loop !38

131:                                              ; preds = %120, %108
  br label %132

132:                                              ; preds = %131, %167
  %133 = phi i64 [ %168, %167 ], [ 0, %131 ]
  %134 = getelementptr inbounds i64, ptr %19, i64 %133
  %135 = load i64, ptr %134, align 8
  %136 = icmp eq i64 %135, 1
  br i1 %136, label %137, label %167

137:                                              ; preds = %132
  %138 = mul nsw i64 %133, %6
  %139 = getelementptr double, ptr %7, i64 %138
  br i1 %36, label %140, label %151

140:                                              ; preds = %137, %140
  %141 = phi i64 [ %149, %140 ], [ 0, %137 ]
  %142 = phi double [ %148, %140 ], [ 0.000000e+00, %137 ]
  %143 = getelementptr inbounds double, ptr %139, i64 %141
  %144 = load double, ptr %143, align 8
  %145 = getelementptr inbounds double, ptr %114, i64 %141
  %146 = load double, ptr %145, align 8
  %147 = fmul double %144, %146
  %148 = fadd double %142, %147
  %149 = add nuw nsw i64 %141, 1
  %150 = icmp eq i64 %149, %6
  br i1 %150, label %151, label %140, !llvm.loop !22

151:                                              ; preds = %140, %137
  %152 = phi double [ 0.000000e+00, %137 ], [ %148, %140 ]
  %153 = fmul double %112, %152
  %154 = getelementptr inbounds double, ptr %11, i64 %133
  %155 = load double, ptr %154, align 8
  %156 = fsub double %155, %153
  store double %156, ptr %154, align 8
  br i1 %37, label %157, label %167

157:                                              ; preds = %151, %157
  %158 = phi i64 [ %165, %157 ], [ 0, %151 ]
  %159 = getelementptr inbounds double, ptr %114, i64 %158
  %160 = load double, ptr %159, align 8
  %161 = fmul double %152, %160
  %162 = getelementptr double, ptr %139, i64 %158
  %163 = load double, ptr %162, align 8
  %164 = fsub double %163, %161
  store double %164, ptr %162, align 8
  %165 = add nuw nsw i64 %158, 1
  %166 = icmp eq i64 %165, %6
  br i1 %166, label %167, label %157, !llvm.loop !39

167:                                              ; preds = %157, %151, %132
  %168 = add nuw nsw i64 %133, 1
  %169 = icmp eq i64 %168, %4
  br i1 %169, label %170, label %132, !llvm.loop !40

170:                                              ; preds = %167
  %171 = add nuw nsw i64 %76, 1
  %172 = icmp eq i64 %171, %4
  br i1 %172, label %173, label %75, !llvm.loop !41

173:                                              ; preds = %170, %77, %31
  %174 = icmp sgt i64 %4, 0
  br i1 %174, label %176, label %175

175:                                              ; preds = %176, %173
  ret void

176:                                              ; preds = %173, %176
  %177 = phi i64 [ %183, %176 ], [ 0, %173 ]
  %178 = getelementptr inbounds double, ptr %13, i64 %177
  %179 = load double, ptr %178, align 8
  %180 = getelementptr inbounds double, ptr %11, i64 %177
  %181 = load double, ptr %180, align 8
  %182 = fdiv double %181, %179
  store double %182, ptr %180, align 8
  %183 = add nuw nsw i64 %177, 1
  %184 = icmp eq i64 %183, %4
  br i1 %184, label %175, label %176, !llvm.loop !42
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
  br i1 %21, label %8, label %7, !llvm.loop !43

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
  br i1 %33, label %15, label %22, !llvm.loop !44
}

define internal fastcc void @factorise(ptr noundef %0, i64 noundef %1) unnamed_addr #4 {
  %3 = icmp sgt i64 %1, 0
  br i1 %3, label %4, label %75

4:                                                ; preds = %2
  %5 = sitofp i64 %1 to double
  %6 = fmul double %5, 4.000000e+00
  %7 = fmul double %6, 0x3CB0000000000000
  br label %8

8:                                                ; preds = %71, %4
  %9 = phi i64 [ 0, %4 ], [ %72, %71 ]
  %10 = mul nuw nsw i64 %9, %1
  %11 = getelementptr double, ptr %0, i64 %10
  %12 = getelementptr double, ptr %11, i64 %9
  %13 = load double, ptr %12, align 8
  %14 = icmp eq i64 %9, 0
  br i1 %14, label %15, label %19

15:                                               ; preds = %19, %8
  %16 = phi double [ %13, %8 ], [ %25, %19 ]
  %17 = fmul double %7, %13
  %18 = fcmp ule double %16, %17
  br i1 %18, label %28, label %42

19:                                               ; preds = %8, %19
  %20 = phi i64 [ %26, %19 ], [ 0, %8 ]
  %21 = phi double [ %25, %19 ], [ %13, %8 ]
  %22 = getelementptr double, ptr %11, i64 %20
  %23 = load double, ptr %22, align 8
  %24 = fmul double %23, %23
  %25 = fsub double %21, %24
  %26 = add nuw nsw i64 %20, 1
  %27 = icmp eq i64 %26, %9
  br i1 %27, label %15, label %19, !llvm.loop !45

28:                                               ; preds = %15, %32
  %29 = phi i64 [ %33, %32 ], [ 0, %15 ]
  %30 = mul nuw nsw i64 %29, %1
  %31 = getelementptr double, ptr %0, i64 %30
  br label %35

32:                                               ; preds = %35
  %33 = add nuw nsw i64 %29, 1
  %34 = icmp eq i64 %33, %1
  br i1 %34, label %71, label %28, !llvm.loop !6

35:                                               ; preds = %28, %35
  %36 = phi i64 [ 0, %28 ], [ %40, %35 ]
  %37 = icmp eq i64 %29, %36
  %38 = select i1 %37, double 1.000000e+00, double 0.000000e+00
  %39 = getelementptr double, ptr %31, i64 %36
  store double %38, ptr %39, align 8
  %40 = add nuw nsw i64 %36, 1
  %41 = icmp eq i64 %40, %1
  br i1 %41, label %32, label %35, !llvm.loop !9

42:                                               ; preds = %15
  %43 = tail call double @llvm.sqrt.f64(double %16)
  store double %43, ptr %12, align 8
  %44 = add nuw nsw i64 %9, 1
  %45 = icmp slt i64 %44, %1
  br i1 %45, label %46, label %71

46:                                               ; preds = %42
  %47 = icmp eq i64 %9, 0
  br label %48

48:                                               ; preds = %46, %54
  %49 = phi i64 [ %44, %46 ], [ %58, %54 ]
  %50 = mul nuw nsw i64 %49, %1
  %51 = getelementptr double, ptr %0, i64 %50
  %52 = getelementptr double, ptr %51, i64 %9
  %53 = load double, ptr %52, align 8
  br i1 %47, label %54, label %60

54:                                               ; preds = %60, %48
  %55 = phi double [ %53, %48 ], [ %68, %60 ]
  %56 = load double, ptr %12, align 8
  %57 = fdiv double %55, %56
  store double %57, ptr %52, align 8
  %58 = add nuw nsw i64 %49, 1
  %59 = icmp slt i64 %58, %1
  br i1 %59, label %48, label %71, !llvm.loop !46

60:                                               ; preds = %48, %60
  %61 = phi i64 [ %69, %60 ], [ 0, %48 ]
  %62 = phi double [ %68, %60 ], [ %53, %48 ]
  %63 = getelementptr double, ptr %51, i64 %61
  %64 = load double, ptr %63, align 8
  %65 = getelementptr double, ptr %11, i64 %61
  %66 = load double, ptr %65, align 8
  %67 = fmul double %64, %66
  %68 = fsub double %62, %67
  %69 = add nuw nsw i64 %61, 1
  %70 = icmp eq i64 %69, %9
  br i1 %70, label %54, label %60, !llvm.loop !47

71:                                               ; preds = %54, %32, %42
  %72 = add nuw nsw i64 %9, 1
  %73 = icmp eq i64 %72, %1
  %74 = select i1 %18, i1 true, i1 %73
  br i1 %74, label %75, label %8, !llvm.loop !48

75:                                               ; preds = %71, %2
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
