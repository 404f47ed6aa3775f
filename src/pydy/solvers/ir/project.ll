; sources d4f4c7dcd485c6f337799926af057738069fd155e01b51071b3d74cd62b022dd
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Held = type { ptr, i64, i64, i64, i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

define i64 @project(ptr noundef readonly %0, double noundef %1, ptr noundef %2, ptr noundef readonly %3) #0 {
  %5 = alloca %struct.Held, align 8
  tail call void @llvm.experimental.noalias.scope.decl(metadata !3)
  %6 = getelementptr inbounds i8, ptr %0, i64 648
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 64
  %9 = load i64, ptr %8, align 8, !noalias !3
  %10 = inttoptr i64 %9 to ptr
  store ptr %10, ptr %5, align 8, !alias.scope !3
  %11 = getelementptr inbounds i8, ptr %5, i64 8
  %12 = getelementptr inbounds i8, ptr %7, i64 16
  %13 = load i64, ptr %12, align 8, !noalias !3
  store i64 %13, ptr %11, align 8, !alias.scope !3
  %14 = getelementptr inbounds i8, ptr %5, i64 16
  %15 = getelementptr inbounds i8, ptr %7, i64 24
  %16 = load i64, ptr %15, align 8, !noalias !3
  store i64 %16, ptr %14, align 8, !alias.scope !3
  %17 = getelementptr inbounds i8, ptr %5, i64 24
  %18 = getelementptr inbounds i8, ptr %7, i64 32
  %19 = load i64, ptr %18, align 8, !noalias !3
  store i64 %19, ptr %17, align 8, !alias.scope !3
  %20 = getelementptr inbounds i8, ptr %5, i64 32
  %21 = getelementptr inbounds i8, ptr %7, i64 40
  %22 = load i64, ptr %21, align 8, !noalias !3
  store i64 %22, ptr %20, align 8, !alias.scope !3
  %23 = getelementptr inbounds i8, ptr %5, i64 40
  %24 = getelementptr inbounds i8, ptr %7, i64 48
  %25 = load i64, ptr %24, align 8, !noalias !3
  store i64 %25, ptr %23, align 8, !alias.scope !3
  %26 = getelementptr inbounds i8, ptr %5, i64 48
  %27 = getelementptr inbounds i8, ptr %7, i64 80
  %28 = load i64, ptr %27, align 8, !noalias !3
  store i64 %28, ptr %26, align 8, !alias.scope !3
  %29 = getelementptr inbounds i8, ptr %5, i64 56
  %30 = getelementptr inbounds i8, ptr %7, i64 88
  %31 = load i64, ptr %30, align 8, !noalias !3
  store i64 %31, ptr %29, align 8, !alias.scope !3
  %32 = getelementptr inbounds i8, ptr %5, i64 64
  %33 = getelementptr inbounds i8, ptr %0, i64 696
  %34 = load ptr, ptr %33, align 8, !noalias !3
  store ptr %34, ptr %32, align 8, !alias.scope !3
  %35 = getelementptr inbounds i8, ptr %5, i64 72
  store ptr null, ptr %35, align 8, !alias.scope !3
  %36 = getelementptr inbounds i8, ptr %5, i64 80
  store ptr null, ptr %36, align 8, !alias.scope !3
  %37 = getelementptr inbounds i8, ptr %5, i64 88
  store ptr null, ptr %37, align 8, !alias.scope !3
  %38 = getelementptr inbounds i8, ptr %5, i64 96
  store ptr null, ptr %38, align 8, !alias.scope !3
  %39 = getelementptr inbounds i8, ptr %5, i64 104
  store ptr null, ptr %39, align 8, !alias.scope !3
  %40 = getelementptr inbounds i8, ptr %5, i64 112
  store ptr null, ptr %40, align 8, !alias.scope !3
  %41 = getelementptr inbounds double, ptr %34, i64 %13
  %42 = getelementptr inbounds double, ptr %41, i64 %16
  store ptr %42, ptr %35, align 8, !alias.scope !3
  %43 = mul nsw i64 %19, %13
  %44 = getelementptr inbounds double, ptr %42, i64 %43
  store ptr %44, ptr %36, align 8, !alias.scope !3
  %45 = mul nsw i64 %22, %19
  %46 = getelementptr inbounds double, ptr %44, i64 %45
  store ptr %46, ptr %37, align 8, !alias.scope !3
  %47 = mul nsw i64 %22, %16
  %48 = getelementptr inbounds double, ptr %46, i64 %47
  store ptr %48, ptr %38, align 8, !alias.scope !3
  %49 = mul i64 %22, %22
  %50 = mul i64 %49, %25
  %51 = getelementptr inbounds double, ptr %48, i64 %50
  store ptr %51, ptr %39, align 8, !alias.scope !3
  %52 = getelementptr inbounds double, ptr %51, i64 %13
  store ptr %52, ptr %40, align 8, !alias.scope !3
  %53 = getelementptr inbounds i8, ptr %7, i64 96
  %54 = load i64, ptr %53, align 8
  %55 = icmp eq i64 %54, 0
  %56 = select i1 %55, ptr null, ptr %3
  %57 = getelementptr inbounds i8, ptr %0, i64 144
  %58 = getelementptr inbounds i8, ptr %0, i64 168
  %59 = load ptr, ptr %58, align 8
  store double %1, ptr %59, align 8
  %60 = getelementptr inbounds i8, ptr %0, i64 248
  %61 = load i64, ptr %60, align 8
  %62 = icmp sgt i64 %61, 0
  br i1 %62, label %63, label %64

63:                                               ; preds = %4
  tail call fastcc void @sample(ptr noundef nonnull %57) #7
  br label %64

64:                                               ; preds = %4, %63
  %65 = getelementptr inbounds i8, ptr %0, i64 600
  %66 = load ptr, ptr %65, align 8
  %67 = getelementptr inbounds i8, ptr %66, i64 88
  %68 = load i64, ptr %67, align 8
  %69 = add nsw i64 %68, 1
  store i64 %69, ptr %67, align 8
  %70 = load ptr, ptr %5, align 8
  %71 = load ptr, ptr %70, align 8
  %72 = load i64, ptr %20, align 8
  %73 = icmp sgt i64 %72, 0
  br i1 %73, label %74, label %88

74:                                               ; preds = %64, %78
  %75 = phi i64 [ %79, %78 ], [ 0, %64 ]
  %76 = mul nuw nsw i64 %75, %72
  %77 = getelementptr double, ptr %71, i64 %76
  br label %81

78:                                               ; preds = %81
  %79 = add nuw nsw i64 %75, 1
  %80 = icmp eq i64 %79, %72
  br i1 %80, label %88, label %74, !llvm.loop !6

81:                                               ; preds = %74, %81
  %82 = phi i64 [ 0, %74 ], [ %86, %81 ]
  %83 = icmp eq i64 %75, %82
  %84 = select i1 %83, double 1.000000e+00, double 0.000000e+00
  %85 = getelementptr double, ptr %77, i64 %82
  store double %84, ptr %85, align 8
  %86 = add nuw nsw i64 %82, 1
  %87 = icmp eq i64 %86, %72
  br i1 %87, label %78, label %81, !llvm.loop !9

88:                                               ; preds = %78, %64
  %89 = load ptr, ptr %5, align 8
  %90 = getelementptr inbounds i8, ptr %89, i64 264
  %91 = load ptr, ptr %90, align 8
  %92 = load i64, ptr %11, align 8
  %93 = icmp sgt i64 %92, 0
  br i1 %93, label %134, label %94

94:                                               ; preds = %134, %88
  %95 = getelementptr inbounds i8, ptr %0, i64 168
  %96 = getelementptr inbounds i8, ptr %0, i64 192
  %97 = getelementptr inbounds i8, ptr %0, i64 672
  %98 = load ptr, ptr %32, align 8
  %99 = load ptr, ptr %6, align 8
  %100 = getelementptr inbounds i8, ptr %99, i64 8
  %101 = load i64, ptr %100, align 8
  %102 = load ptr, ptr %95, align 8
  %103 = load ptr, ptr %96, align 8
  %104 = load ptr, ptr %97, align 8
  %105 = inttoptr i64 %101 to ptr
  %106 = tail call i32 %105(ptr noundef %102, ptr noundef %2, ptr noundef %103, ptr noundef %104, ptr noundef %98) #8
  %107 = icmp slt i32 %106, 0
  br i1 %107, label %315, label %108

108:                                              ; preds = %94
  %109 = load i64, ptr %11, align 8
  %110 = icmp sgt i64 %109, 0
  %111 = load ptr, ptr %32, align 8
  %112 = load i64, ptr %26, align 8
  %113 = icmp eq i64 %112, %109
  %114 = load ptr, ptr %5, align 8
  %115 = getelementptr inbounds i8, ptr %114, i64 240
  %116 = load ptr, ptr %39, align 8
  %117 = icmp eq ptr %56, null
  %118 = icmp slt i64 %28, %109
  %119 = icmp slt i64 %109, 1
  %120 = icmp sgt i64 %19, 0
  %121 = getelementptr inbounds i8, ptr %0, i64 552
  %122 = getelementptr inbounds i8, ptr %0, i64 528
  %123 = select i1 %118, double 1.000000e-05, double 0x3CE0000000000000
  %124 = add nsw i64 %72, %19
  %125 = sitofp i64 %124 to double
  %126 = icmp eq i64 %25, 1
  %127 = getelementptr inbounds i8, ptr %89, i64 8
  %128 = getelementptr inbounds i8, ptr %89, i64 16
  %129 = getelementptr inbounds i8, ptr %89, i64 24
  %130 = getelementptr inbounds i8, ptr %89, i64 32
  %131 = getelementptr inbounds i8, ptr %89, i64 40
  %132 = getelementptr inbounds i8, ptr %89, i64 144
  %133 = icmp sgt i64 %109, 0
  br label %150

134:                                              ; preds = %88, %134
  %135 = phi i64 [ %137, %134 ], [ 0, %88 ]
  %136 = getelementptr inbounds double, ptr %91, i64 %135
  store double 0.000000e+00, ptr %136, align 8
  %137 = add nuw nsw i64 %135, 1
  %138 = icmp eq i64 %137, %92
  br i1 %138, label %94, label %134, !llvm.loop !10

139:                                              ; preds = %310
  %140 = add nuw nsw i32 %153, 1
  %141 = load ptr, ptr %6, align 8
  %142 = getelementptr inbounds i8, ptr %141, i64 8
  %143 = load i64, ptr %142, align 8
  %144 = load ptr, ptr %95, align 8
  %145 = load ptr, ptr %96, align 8
  %146 = load ptr, ptr %97, align 8
  %147 = inttoptr i64 %143 to ptr
  %148 = tail call i32 %147(ptr noundef %144, ptr noundef %2, ptr noundef %145, ptr noundef %146, ptr noundef %98) #8
  %149 = icmp slt i32 %148, 0
  br i1 %149, label %315, label %150, !llvm.loop !11

150:                                              ; preds = %108, %139
  %151 = phi i64 [ undef, %108 ], [ %314, %139 ]
  %152 = phi double [ 0x7FF0000000000000, %108 ], [ %313, %139 ]
  %153 = phi i32 [ 0, %108 ], [ %140, %139 ]
  %154 = phi double [ 0.000000e+00, %108 ], [ %311, %139 ]
  br i1 %110, label %155, label %192

155:                                              ; preds = %150
  %156 = icmp eq i32 %153, 0
  %157 = select i1 %156, i1 true, i1 %113
  br label %162

158:                                              ; preds = %188
  %159 = add nuw nsw i64 %165, 1
  %160 = icmp slt i64 %159, %109
  %161 = icmp eq i64 %159, %109
  br i1 %161, label %192, label %162, !llvm.loop !12

162:                                              ; preds = %155, %158
  %163 = phi i1 [ %110, %155 ], [ %160, %158 ]
  %164 = phi i64 [ %151, %155 ], [ %191, %158 ]
  %165 = phi i64 [ 0, %155 ], [ %159, %158 ]
  %166 = phi double [ 0.000000e+00, %155 ], [ %189, %158 ]
  %167 = getelementptr inbounds double, ptr %111, i64 %165
  %168 = load double, ptr %167, align 8
  %169 = tail call double @llvm.fabs.f64(double %168)
  %170 = fcmp une double %168, 0.000000e+00
  br i1 %170, label %171, label %188

171:                                              ; preds = %162
  br i1 %157, label %177, label %172

172:                                              ; preds = %171
  %173 = load ptr, ptr %115, align 8
  %174 = getelementptr inbounds double, ptr %173, i64 %165
  %175 = load double, ptr %174, align 8
  %176 = fcmp ogt double %175, 0.000000e+00
  br i1 %176, label %177, label %188

177:                                              ; preds = %172, %171
  %178 = getelementptr inbounds double, ptr %116, i64 %165
  %179 = load double, ptr %178, align 8
  %180 = getelementptr inbounds double, ptr %91, i64 %165
  %181 = load double, ptr %180, align 8
  %182 = fcmp ogt double %179, %181
  %183 = select i1 %182, double %179, double %181
  %184 = fmul double %183, 0x3CB0000000000000
  %185 = fdiv double %169, %184
  %186 = fcmp ogt double %185, %166
  %187 = select i1 %186, double %185, double %166
  br label %188

188:                                              ; preds = %177, %172, %162
  %189 = phi double [ %187, %177 ], [ %166, %172 ], [ %166, %162 ]
  %190 = fcmp ueq double %169, 0x7FF0000000000000
  %191 = select i1 %190, i64 6, i64 %164
  br i1 %190, label %192, label %158

192:                                              ; preds = %158, %188, %150
  %193 = phi i1 [ %110, %150 ], [ %160, %158 ], [ %163, %188 ]
  %194 = phi double [ 0.000000e+00, %150 ], [ %189, %188 ], [ %189, %158 ]
  %195 = phi i64 [ %151, %150 ], [ %191, %188 ], [ %191, %158 ]
  br i1 %193, label %310, label %196

196:                                              ; preds = %192
  %197 = icmp ne i32 %153, 0
  %198 = or i1 %117, %197
  %199 = or i1 %198, %119
  %200 = select i1 %198, double %154, double 0.000000e+00
  br i1 %199, label %254, label %201

201:                                              ; preds = %196, %249
  %202 = phi ptr [ %252, %249 ], [ %42, %196 ]
  %203 = phi double [ %250, %249 ], [ 0.000000e+00, %196 ]
  %204 = phi i64 [ %251, %249 ], [ 0, %196 ]
  br i1 %120, label %205, label %208

205:                                              ; preds = %201
  %206 = load ptr, ptr %121, align 8
  %207 = load ptr, ptr %122, align 8
  br label %211

208:                                              ; preds = %211, %201
  %209 = phi double [ 0.000000e+00, %201 ], [ %232, %211 ]
  %210 = fcmp ogt double %209, 0.000000e+00
  br i1 %210, label %235, label %249

211:                                              ; preds = %205, %211
  %212 = phi i64 [ 0, %205 ], [ %233, %211 ]
  %213 = phi double [ 0.000000e+00, %205 ], [ %232, %211 ]
  %214 = getelementptr inbounds double, ptr %202, i64 %212
  %215 = load double, ptr %214, align 8
  %216 = getelementptr inbounds double, ptr %56, i64 %212
  %217 = load double, ptr %216, align 8
  %218 = getelementptr inbounds double, ptr %2, i64 %212
  %219 = load double, ptr %218, align 8
  %220 = getelementptr inbounds double, ptr %206, i64 %212
  %221 = load double, ptr %220, align 8
  %222 = getelementptr inbounds double, ptr %207, i64 %212
  %223 = load double, ptr %222, align 8
  %224 = tail call double @llvm.fabs.f64(double %217)
  %225 = tail call double @llvm.fabs.f64(double %219)
  %226 = fcmp ogt double %224, %225
  %227 = select i1 %226, double %224, double %225
  %228 = fmul double %227, %223
  %229 = fadd double %221, %228
  %230 = fmul double %215, %229
  %231 = fmul double %230, %230
  %232 = fadd double %213, %231
  %233 = add nuw nsw i64 %212, 1
  %234 = icmp eq i64 %233, %19
  br i1 %234, label %208, label %211, !llvm.loop !13

235:                                              ; preds = %208
  %236 = getelementptr inbounds double, ptr %51, i64 %204
  %237 = load double, ptr %236, align 8
  %238 = fmul double %209, %125
  %239 = tail call double @llvm.sqrt.f64(double %238)
  %240 = fmul double %239, 3.000000e+00
  %241 = fmul double %123, %237
  %242 = fadd double %240, %241
  %243 = getelementptr inbounds double, ptr %98, i64 %204
  %244 = load double, ptr %243, align 8
  %245 = tail call double @llvm.fabs.f64(double %244)
  %246 = fdiv double %245, %242
  %247 = fcmp ogt double %246, %203
  %248 = select i1 %247, double %246, double %203
  br label %249

249:                                              ; preds = %235, %208
  %250 = phi double [ %248, %235 ], [ %203, %208 ]
  %251 = add nuw nsw i64 %204, 1
  %252 = getelementptr inbounds double, ptr %202, i64 %19
  %253 = icmp eq i64 %251, %109
  br i1 %253, label %254, label %201, !llvm.loop !14

254:                                              ; preds = %249, %196
  %255 = phi double [ %200, %196 ], [ %250, %249 ]
  %256 = fcmp ugt double %194, 1.000000e+00
  br i1 %256, label %257, label %310

257:                                              ; preds = %254
  %258 = fmul double %152, 5.000000e-01
  %259 = fcmp oge double %194, %258
  %260 = fcmp ole double %194, 8.000000e+00
  %261 = and i1 %259, %260
  br i1 %261, label %310, label %262

262:                                              ; preds = %257
  %263 = icmp eq i32 %153, 9
  br i1 %263, label %310, label %264

264:                                              ; preds = %262
  br i1 %126, label %265, label %283

265:                                              ; preds = %264
  %266 = load i64, ptr %127, align 8
  %267 = load i64, ptr %128, align 8
  %268 = mul nsw i64 %267, %266
  %269 = icmp sgt i64 %268, 0
  br i1 %269, label %270, label %281

270:                                              ; preds = %265, %270
  %271 = phi i64 [ %276, %270 ], [ 0, %265 ]
  %272 = getelementptr inbounds double, ptr %48, i64 %271
  %273 = load double, ptr %272, align 8
  %274 = load ptr, ptr %89, align 8
  %275 = getelementptr inbounds double, ptr %274, i64 %271
  store double %273, ptr %275, align 8
  %276 = add nuw nsw i64 %271, 1
  %277 = load i64, ptr %127, align 8
  %278 = load i64, ptr %128, align 8
  %279 = mul nsw i64 %278, %277
  %280 = icmp slt i64 %276, %279
  br i1 %280, label %270, label %281, !llvm.loop !15

281:                                              ; preds = %270, %265
  %282 = load ptr, ptr %89, align 8
  tail call fastcc void @factorise(ptr noundef %282, i64 noundef %72) #7
  br label %283

283:                                              ; preds = %264, %281
  %284 = load i64, ptr %130, align 8
  %285 = load i64, ptr %131, align 8
  %286 = mul nsw i64 %285, %284
  %287 = icmp sgt i64 %286, 0
  br i1 %287, label %288, label %299

288:                                              ; preds = %283, %288
  %289 = phi i64 [ %294, %288 ], [ 0, %283 ]
  %290 = getelementptr inbounds double, ptr %44, i64 %289
  %291 = load double, ptr %290, align 8
  %292 = load ptr, ptr %129, align 8
  %293 = getelementptr inbounds double, ptr %292, i64 %289
  store double %291, ptr %293, align 8
  %294 = add nuw nsw i64 %289, 1
  %295 = load i64, ptr %130, align 8
  %296 = load i64, ptr %131, align 8
  %297 = mul nsw i64 %296, %295
  %298 = icmp slt i64 %294, %297
  br i1 %298, label %288, label %299, !llvm.loop !15

299:                                              ; preds = %288, %283
  %300 = load ptr, ptr %132, align 8
  br i1 %133, label %301, label %309

301:                                              ; preds = %299, %301
  %302 = phi i64 [ %307, %301 ], [ 0, %299 ]
  %303 = getelementptr inbounds double, ptr %98, i64 %302
  %304 = load double, ptr %303, align 8
  %305 = fneg double %304
  %306 = getelementptr inbounds double, ptr %300, i64 %302
  store double %305, ptr %306, align 8
  %307 = add nuw nsw i64 %302, 1
  %308 = icmp eq i64 %307, %109
  br i1 %308, label %309, label %301, !llvm.loop !16

309:                                              ; preds = %301, %299
  call fastcc void @move_positions(ptr noundef nonnull %5, ptr noundef %2) #7
  br label %310

310:                                              ; preds = %309, %262, %257, %254, %192
  %311 = phi double [ %154, %192 ], [ %255, %257 ], [ %255, %262 ], [ %255, %309 ], [ %255, %254 ]
  %312 = phi i1 [ false, %192 ], [ false, %257 ], [ false, %262 ], [ true, %309 ], [ false, %254 ]
  %313 = phi double [ %152, %192 ], [ %152, %257 ], [ %152, %262 ], [ %194, %309 ], [ %152, %254 ]
  %314 = phi i64 [ %195, %192 ], [ 0, %257 ], [ 6, %262 ], [ %195, %309 ], [ 0, %254 ]
  br i1 %312, label %139, label %315

315:                                              ; preds = %310, %139, %94
  %316 = phi double [ 0.000000e+00, %94 ], [ %311, %139 ], [ %311, %310 ]
  %317 = phi i64 [ 6, %94 ], [ %314, %310 ], [ 6, %139 ]
  %318 = icmp eq i64 %317, 0
  br i1 %318, label %319, label %328

319:                                              ; preds = %315
  %320 = load i64, ptr %14, align 8
  %321 = icmp eq i64 %320, 0
  br i1 %321, label %328, label %322

322:                                              ; preds = %319
  %323 = icmp sgt i64 %320, 0
  br i1 %323, label %324, label %331

324:                                              ; preds = %322
  %325 = load ptr, ptr %32, align 8
  %326 = load i64, ptr %11, align 8
  %327 = getelementptr double, ptr %325, i64 %326
  br label %338

328:                                              ; preds = %319, %315
  %329 = fcmp ogt double %316, 1.000000e+00
  %330 = select i1 %329, i64 6, i64 %317
  br label %562

331:                                              ; preds = %338, %322
  %332 = phi double [ 0.000000e+00, %322 ], [ %344, %338 ]
  %333 = load i64, ptr %20, align 8
  %334 = mul nsw i64 %333, %320
  %335 = icmp sgt i64 %334, 0
  br i1 %335, label %336, label %347

336:                                              ; preds = %331
  %337 = load ptr, ptr %37, align 8
  br label %350

338:                                              ; preds = %324, %338
  %339 = phi i64 [ 0, %324 ], [ %345, %338 ]
  %340 = phi double [ 0.000000e+00, %324 ], [ %344, %338 ]
  %341 = getelementptr double, ptr %327, i64 %339
  %342 = load double, ptr %341, align 8
  %343 = fmul double %342, 0.000000e+00
  %344 = fadd double %340, %343
  %345 = add nuw nsw i64 %339, 1
  %346 = icmp eq i64 %345, %320
  br i1 %346, label %331, label %338, !llvm.loop !17

347:                                              ; preds = %350, %331
  %348 = phi double [ %332, %331 ], [ %356, %350 ]
  %349 = fcmp une double %348, 0.000000e+00
  br i1 %349, label %562, label %359

350:                                              ; preds = %336, %350
  %351 = phi i64 [ 0, %336 ], [ %357, %350 ]
  %352 = phi double [ %332, %336 ], [ %356, %350 ]
  %353 = getelementptr inbounds double, ptr %337, i64 %351
  %354 = load double, ptr %353, align 8
  %355 = fmul double %354, 0.000000e+00
  %356 = fadd double %352, %355
  %357 = add nuw nsw i64 %351, 1
  %358 = icmp eq i64 %357, %334
  br i1 %358, label %347, label %350, !llvm.loop !18

359:                                              ; preds = %347
  %360 = icmp eq ptr %56, null
  br i1 %360, label %438, label %361

361:                                              ; preds = %359
  %362 = load i64, ptr %17, align 8
  %363 = load ptr, ptr %32, align 8
  %364 = load i64, ptr %11, align 8
  %365 = getelementptr inbounds double, ptr %363, i64 %364
  %366 = icmp sgt i64 %320, 0
  br i1 %366, label %367, label %434

367:                                              ; preds = %361
  %368 = load i64, ptr %29, align 8
  %369 = icmp slt i64 %368, %320
  %370 = load ptr, ptr %37, align 8
  %371 = icmp sgt i64 %333, 0
  %372 = getelementptr inbounds i8, ptr %0, i64 552
  %373 = getelementptr inbounds i8, ptr %0, i64 528
  %374 = select i1 %369, double 1.000000e-05, double 0x3CE0000000000000
  %375 = add nsw i64 %362, %333
  %376 = sitofp i64 %375 to double
  br label %377

377:                                              ; preds = %367, %429
  %378 = phi ptr [ %370, %367 ], [ %432, %429 ]
  %379 = phi double [ 0.000000e+00, %367 ], [ %430, %429 ]
  %380 = phi i64 [ 0, %367 ], [ %431, %429 ]
  br i1 %371, label %381, label %384

381:                                              ; preds = %377
  %382 = load ptr, ptr %372, align 8
  %383 = load ptr, ptr %373, align 8
  br label %388

384:                                              ; preds = %388, %377
  %385 = phi double [ 0.000000e+00, %377 ], [ %411, %388 ]
  %386 = phi double [ 0.000000e+00, %377 ], [ %414, %388 ]
  %387 = fcmp ogt double %385, 0.000000e+00
  br i1 %387, label %417, label %429

388:                                              ; preds = %381, %388
  %389 = phi i64 [ 0, %381 ], [ %415, %388 ]
  %390 = phi double [ 0.000000e+00, %381 ], [ %414, %388 ]
  %391 = phi double [ 0.000000e+00, %381 ], [ %411, %388 ]
  %392 = getelementptr inbounds double, ptr %378, i64 %389
  %393 = load double, ptr %392, align 8
  %394 = add nsw i64 %389, %362
  %395 = getelementptr inbounds double, ptr %56, i64 %394
  %396 = load double, ptr %395, align 8
  %397 = getelementptr inbounds double, ptr %2, i64 %394
  %398 = load double, ptr %397, align 8
  %399 = getelementptr inbounds double, ptr %382, i64 %394
  %400 = load double, ptr %399, align 8
  %401 = getelementptr inbounds double, ptr %383, i64 %394
  %402 = load double, ptr %401, align 8
  %403 = tail call double @llvm.fabs.f64(double %396)
  %404 = tail call double @llvm.fabs.f64(double %398)
  %405 = fcmp ogt double %403, %404
  %406 = select i1 %405, double %403, double %404
  %407 = fmul double %406, %402
  %408 = fadd double %400, %407
  %409 = fmul double %393, %408
  %410 = fmul double %409, %409
  %411 = fadd double %391, %410
  %412 = fmul double %393, %398
  %413 = tail call double @llvm.fabs.f64(double %412)
  %414 = fadd double %390, %413
  %415 = add nuw nsw i64 %389, 1
  %416 = icmp eq i64 %415, %333
  br i1 %416, label %384, label %388, !llvm.loop !13

417:                                              ; preds = %384
  %418 = fmul double %385, %376
  %419 = tail call double @llvm.sqrt.f64(double %418)
  %420 = fmul double %419, 3.000000e+00
  %421 = fmul double %374, %386
  %422 = fadd double %421, %420
  %423 = getelementptr inbounds double, ptr %365, i64 %380
  %424 = load double, ptr %423, align 8
  %425 = tail call double @llvm.fabs.f64(double %424)
  %426 = fdiv double %425, %422
  %427 = fcmp ogt double %426, %379
  %428 = select i1 %427, double %426, double %379
  br label %429

429:                                              ; preds = %417, %384
  %430 = phi double [ %428, %417 ], [ %379, %384 ]
  %431 = add nuw nsw i64 %380, 1
  %432 = getelementptr inbounds double, ptr %378, i64 %333
  %433 = icmp eq i64 %431, %320
  br i1 %433, label %434, label %377, !llvm.loop !14

434:                                              ; preds = %429, %361
  %435 = phi double [ 0.000000e+00, %361 ], [ %430, %429 ]
  %436 = fcmp ogt double %435, %316
  %437 = select i1 %436, double %435, double %316
  br label %438

438:                                              ; preds = %434, %359
  %439 = phi double [ %316, %359 ], [ %437, %434 ]
  %440 = load i64, ptr %23, align 8
  %441 = icmp eq i64 %440, 1
  br i1 %441, label %442, label %466

442:                                              ; preds = %438
  %443 = load ptr, ptr %38, align 8
  %444 = load ptr, ptr %5, align 8
  %445 = getelementptr inbounds i8, ptr %444, i64 8
  %446 = getelementptr inbounds i8, ptr %444, i64 16
  %447 = load i64, ptr %445, align 8
  %448 = load i64, ptr %446, align 8
  %449 = mul nsw i64 %448, %447
  %450 = icmp sgt i64 %449, 0
  br i1 %450, label %451, label %462

451:                                              ; preds = %442, %451
  %452 = phi i64 [ %457, %451 ], [ 0, %442 ]
  %453 = getelementptr inbounds double, ptr %443, i64 %452
  %454 = load double, ptr %453, align 8
  %455 = load ptr, ptr %444, align 8
  %456 = getelementptr inbounds double, ptr %455, i64 %452
  store double %454, ptr %456, align 8
  %457 = add nuw nsw i64 %452, 1
  %458 = load i64, ptr %445, align 8
  %459 = load i64, ptr %446, align 8
  %460 = mul nsw i64 %459, %458
  %461 = icmp slt i64 %457, %460
  br i1 %461, label %451, label %462, !llvm.loop !15

462:                                              ; preds = %451, %442
  %463 = load ptr, ptr %5, align 8
  %464 = load ptr, ptr %463, align 8
  %465 = load i64, ptr %20, align 8
  tail call fastcc void @factorise(ptr noundef %464, i64 noundef %465) #7
  br label %466

466:                                              ; preds = %438, %462
  %467 = load ptr, ptr %32, align 8
  %468 = load i64, ptr %11, align 8
  %469 = getelementptr inbounds double, ptr %467, i64 %468
  %470 = load i64, ptr %14, align 8
  %471 = load ptr, ptr %5, align 8
  %472 = getelementptr inbounds i8, ptr %471, i64 144
  %473 = load ptr, ptr %472, align 8
  %474 = icmp sgt i64 %470, 0
  br i1 %474, label %475, label %483

475:                                              ; preds = %466, %475
  %476 = phi i64 [ %481, %475 ], [ 0, %466 ]
  %477 = getelementptr inbounds double, ptr %469, i64 %476
  %478 = load double, ptr %477, align 8
  %479 = fneg double %478
  %480 = getelementptr inbounds double, ptr %473, i64 %476
  store double %479, ptr %480, align 8
  %481 = add nuw nsw i64 %476, 1
  %482 = icmp eq i64 %481, %470
  br i1 %482, label %483, label %475, !llvm.loop !16

483:                                              ; preds = %475, %466
  call fastcc void @move_speeds(ptr noundef nonnull %5, ptr noundef %2) #7
  %484 = load ptr, ptr %57, align 8
  %485 = getelementptr inbounds i8, ptr %484, i64 8
  %486 = load i64, ptr %485, align 8
  %487 = load ptr, ptr %5, align 8
  %488 = getelementptr inbounds i8, ptr %487, i64 216
  %489 = load ptr, ptr %488, align 8
  %490 = getelementptr inbounds i8, ptr %487, i64 240
  %491 = load ptr, ptr %490, align 8
  %492 = load ptr, ptr %40, align 8
  %493 = getelementptr inbounds i8, ptr %492, i64 32
  %494 = getelementptr inbounds double, ptr %493, i64 %486
  %495 = load i64, ptr %14, align 8
  %496 = icmp sgt i64 %495, 0
  br i1 %496, label %504, label %499

497:                                              ; preds = %522
  %498 = sitofp i64 %524 to double
  br label %499

499:                                              ; preds = %497, %483
  %500 = phi double [ 1.000000e+00, %483 ], [ %523, %497 ]
  %501 = phi double [ 0.000000e+00, %483 ], [ %498, %497 ]
  %502 = load double, ptr %492, align 8
  %503 = fcmp olt double %502, %501
  br i1 %503, label %527, label %529

504:                                              ; preds = %483, %522
  %505 = phi i64 [ %525, %522 ], [ 0, %483 ]
  %506 = phi i64 [ %524, %522 ], [ 0, %483 ]
  %507 = phi double [ %523, %522 ], [ 1.000000e+00, %483 ]
  %508 = getelementptr inbounds double, ptr %489, i64 %505
  %509 = load double, ptr %508, align 8
  %510 = getelementptr inbounds double, ptr %494, i64 %505
  %511 = load double, ptr %510, align 8
  %512 = fcmp ogt double %509, %511
  %513 = select i1 %512, double %509, double %511
  store double %513, ptr %510, align 8
  %514 = getelementptr inbounds double, ptr %491, i64 %505
  %515 = load double, ptr %514, align 8
  %516 = fcmp ogt double %515, 0.000000e+00
  br i1 %516, label %517, label %522

517:                                              ; preds = %504
  %518 = add nsw i64 %506, 1
  %519 = fdiv double %515, %513
  %520 = fcmp olt double %519, %507
  %521 = select i1 %520, double %519, double %507
  br label %522

522:                                              ; preds = %517, %504
  %523 = phi double [ %521, %517 ], [ %507, %504 ]
  %524 = phi i64 [ %518, %517 ], [ %506, %504 ]
  %525 = add nuw nsw i64 %505, 1
  %526 = icmp eq i64 %525, %495
  br i1 %526, label %497, label %504, !llvm.loop !19

527:                                              ; preds = %499
  store double %501, ptr %492, align 8
  %528 = getelementptr inbounds i8, ptr %492, i64 8
  store double 1.000000e+00, ptr %528, align 8
  br label %532

529:                                              ; preds = %499
  %530 = fcmp ogt double %502, %501
  br i1 %530, label %531, label %532

531:                                              ; preds = %529
  br label %532

532:                                              ; preds = %531, %529, %527
  %533 = phi double [ %500, %527 ], [ 0.000000e+00, %531 ], [ %500, %529 ]
  %534 = getelementptr inbounds i8, ptr %492, i64 16
  %535 = load double, ptr %534, align 8
  %536 = fcmp olt double %533, %535
  %537 = select i1 %536, double %533, double %535
  store double %533, ptr %534, align 8
  %538 = fcmp ogt double %439, 1.000000e+00
  br i1 %538, label %539, label %545

539:                                              ; preds = %532
  %540 = fcmp ult double %537, 5.000000e-02
  br i1 %540, label %541, label %562

541:                                              ; preds = %539
  %542 = fmul double %439, %537
  %543 = fmul double %542, 5.000000e-02
  %544 = fcmp ogt double %543, 1.000000e+00
  br i1 %544, label %562, label %545

545:                                              ; preds = %541, %532
  %546 = getelementptr inbounds i8, ptr %492, i64 8
  %547 = load double, ptr %546, align 8
  %548 = fcmp olt double %533, %547
  %549 = fcmp ogt double %547, 1.000000e-05
  %550 = and i1 %548, %549
  br i1 %550, label %551, label %562

551:                                              ; preds = %545
  store double %533, ptr %546, align 8
  %552 = getelementptr inbounds i8, ptr %492, i64 24
  store double %1, ptr %552, align 8
  %553 = getelementptr inbounds i8, ptr %492, i64 32
  %554 = icmp sgt i64 %486, 0
  br i1 %554, label %555, label %562

555:                                              ; preds = %551, %555
  %556 = phi i64 [ %560, %555 ], [ 0, %551 ]
  %557 = getelementptr inbounds double, ptr %2, i64 %556
  %558 = load double, ptr %557, align 8
  %559 = getelementptr inbounds double, ptr %553, i64 %556
  store double %558, ptr %559, align 8
  %560 = add nuw nsw i64 %556, 1
  %561 = icmp eq i64 %560, %486
  br i1 %561, label %562, label %555, !llvm.loop !20

562:                                              ; preds = %555, %551, %545, %541, %539, %347, %328
  %563 = phi i64 [ %330, %328 ], [ 6, %347 ], [ 6, %541 ], [ 6, %539 ], [ 0, %545 ], [ 0, %551 ], [ 0, %555 ]
  ret i64 %563
}



define internal fastcc void @move_speeds(ptr noundef readonly %0, ptr noundef %1) unnamed_addr #2 {
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %0, i64 88
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
  tail call fastcc void @minimum_norm(ptr noundef nonnull %6, ptr noundef nonnull %3, i64 noundef %32) #7
  %33 = load ptr, ptr %3, align 8
  %34 = load i64, ptr %29, align 8
  %35 = getelementptr inbounds i8, ptr %3, i64 120
  %36 = load ptr, ptr %35, align 8
  tail call fastcc void @divide_transposed(ptr noundef %33, i64 noundef %34, ptr noundef %36) #7
  %37 = load i64, ptr %29, align 8
  %38 = icmp sgt i64 %37, 0
  br i1 %38, label %39, label %41

39:                                               ; preds = %24
  %40 = getelementptr inbounds i8, ptr %0, i64 24
  br label %42

41:                                               ; preds = %42, %24
  ret void

42:                                               ; preds = %39, %42
  %43 = phi i64 [ 0, %39 ], [ %52, %42 ]
  %44 = load ptr, ptr %35, align 8
  %45 = getelementptr inbounds double, ptr %44, i64 %43
  %46 = load double, ptr %45, align 8
  %47 = load i64, ptr %40, align 8
  %48 = getelementptr double, ptr %1, i64 %47
  %49 = getelementptr double, ptr %48, i64 %43
  %50 = load double, ptr %49, align 8
  %51 = fadd double %46, %50
  store double %51, ptr %49, align 8
  %52 = add nuw nsw i64 %43, 1
  %53 = load i64, ptr %29, align 8
  %54 = icmp slt i64 %52, %53
  br i1 %54, label %42, label %41, !llvm.loop !21
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
  br i1 %55, label %44, label %56, !llvm.loop !22

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
  br i1 %83, label %13, label %12, !llvm.loop !23
}

declare double @llvm.fabs.f64(double) #3

define internal fastcc void @move_positions(ptr noundef readonly %0, ptr noundef %1) unnamed_addr #2 {
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %0, i64 72
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
  br i1 %23, label %13, label %24, !llvm.loop !15

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
  %34 = getelementptr inbounds i8, ptr %0, i64 48
  %35 = load i64, ptr %34, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %27, ptr noundef nonnull %3, i64 noundef %35) #7
  %36 = getelementptr inbounds i8, ptr %3, i64 120
  %37 = load ptr, ptr %36, align 8
  %38 = load i64, ptr %32, align 8
  %39 = icmp sgt i64 %38, 0
  br i1 %39, label %40, label %49

40:                                               ; preds = %24, %40
  %41 = phi i64 [ %47, %40 ], [ 0, %24 ]
  %42 = phi double [ %46, %40 ], [ 0.000000e+00, %24 ]
  %43 = getelementptr inbounds double, ptr %37, i64 %41
  %44 = load double, ptr %43, align 8
  %45 = fmul double %44, %44
  %46 = fadd double %42, %45
  %47 = add nuw nsw i64 %41, 1
  %48 = icmp eq i64 %47, %38
  br i1 %48, label %49, label %40, !llvm.loop !24

49:                                               ; preds = %40, %24
  %50 = phi double [ 0.000000e+00, %24 ], [ %46, %40 ]
  %51 = tail call double @llvm.sqrt.f64(double %50)
  %52 = load i64, ptr %29, align 8
  %53 = icmp sgt i64 %52, 0
  br i1 %53, label %54, label %57

54:                                               ; preds = %49
  %55 = getelementptr inbounds i8, ptr %3, i64 264
  %56 = getelementptr inbounds i8, ptr %3, i64 216
  br label %64

57:                                               ; preds = %75, %49
  %58 = load ptr, ptr %3, align 8
  %59 = load i64, ptr %32, align 8
  %60 = load ptr, ptr %36, align 8
  tail call fastcc void @divide_transposed(ptr noundef %58, i64 noundef %59, ptr noundef %60) #7
  %61 = getelementptr inbounds i8, ptr %0, i64 24
  %62 = load i64, ptr %61, align 8
  %63 = icmp sgt i64 %62, 0
  br i1 %63, label %79, label %85

64:                                               ; preds = %54, %75
  %65 = phi i64 [ 0, %54 ], [ %76, %75 ]
  %66 = load ptr, ptr %55, align 8
  %67 = getelementptr inbounds double, ptr %66, i64 %65
  %68 = load double, ptr %67, align 8
  %69 = fcmp oeq double %68, 0.000000e+00
  br i1 %69, label %70, label %75

70:                                               ; preds = %64
  %71 = load ptr, ptr %56, align 8
  %72 = getelementptr inbounds double, ptr %71, i64 %65
  %73 = load double, ptr %72, align 8
  %74 = fmul double %51, %73
  store double %74, ptr %67, align 8
  br label %75

75:                                               ; preds = %64, %70
  %76 = add nuw nsw i64 %65, 1
  %77 = load i64, ptr %29, align 8
  %78 = icmp slt i64 %76, %77
  br i1 %78, label %64, label %57, !llvm.loop !25

79:                                               ; preds = %57, %92
  %80 = phi i64 [ %93, %92 ], [ 0, %57 ]
  %81 = load i64, ptr %32, align 8
  %82 = icmp sgt i64 %81, 0
  br i1 %82, label %83, label %92

83:                                               ; preds = %79
  %84 = getelementptr inbounds double, ptr %1, i64 %80
  br label %96

85:                                               ; preds = %92, %57
  %86 = getelementptr inbounds i8, ptr %0, i64 24
  %87 = load i64, ptr %29, align 8
  %88 = icmp sgt i64 %87, 0
  br i1 %88, label %89, label %140

89:                                               ; preds = %85
  %90 = getelementptr inbounds i8, ptr %3, i64 144
  %91 = load ptr, ptr %90, align 8
  br label %115

92:                                               ; preds = %96, %79
  %93 = add nuw nsw i64 %80, 1
  %94 = load i64, ptr %61, align 8
  %95 = icmp slt i64 %93, %94
  br i1 %95, label %79, label %85, !llvm.loop !26

96:                                               ; preds = %83, %96
  %97 = phi i64 [ %81, %83 ], [ %111, %96 ]
  %98 = phi i64 [ 0, %83 ], [ %110, %96 ]
  %99 = load ptr, ptr %25, align 8
  %100 = mul nsw i64 %97, %80
  %101 = getelementptr double, ptr %99, i64 %100
  %102 = getelementptr double, ptr %101, i64 %98
  %103 = load double, ptr %102, align 8
  %104 = load ptr, ptr %36, align 8
  %105 = getelementptr inbounds double, ptr %104, i64 %98
  %106 = load double, ptr %105, align 8
  %107 = fmul double %103, %106
  %108 = load double, ptr %84, align 8
  %109 = fadd double %108, %107
  store double %109, ptr %84, align 8
  %110 = add nuw nsw i64 %98, 1
  %111 = load i64, ptr %32, align 8
  %112 = icmp slt i64 %110, %111
  br i1 %112, label %96, label %92, !llvm.loop !27

113:                                              ; preds = %115
  %114 = fcmp ogt double %122, 0.000000e+00
  br i1 %114, label %125, label %140

115:                                              ; preds = %89, %115
  %116 = phi i64 [ 0, %89 ], [ %123, %115 ]
  %117 = phi double [ 0.000000e+00, %89 ], [ %122, %115 ]
  %118 = getelementptr inbounds double, ptr %91, i64 %116
  %119 = load double, ptr %118, align 8
  %120 = tail call double @llvm.fabs.f64(double %119)
  %121 = fcmp ogt double %120, %117
  %122 = select i1 %121, double %120, double %117
  %123 = add nuw nsw i64 %116, 1
  %124 = icmp eq i64 %123, %87
  br i1 %124, label %113, label %115, !llvm.loop !28

125:                                              ; preds = %113
  %126 = load i64, ptr %34, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %6, ptr noundef nonnull %3, i64 noundef %126) #7
  %127 = load i64, ptr %86, align 8
  %128 = icmp sgt i64 %127, 0
  br i1 %128, label %129, label %140

129:                                              ; preds = %125, %129
  %130 = phi i64 [ %137, %129 ], [ 0, %125 ]
  %131 = load ptr, ptr %36, align 8
  %132 = getelementptr inbounds double, ptr %131, i64 %130
  %133 = load double, ptr %132, align 8
  %134 = getelementptr inbounds double, ptr %1, i64 %130
  %135 = load double, ptr %134, align 8
  %136 = fadd double %133, %135
  store double %136, ptr %134, align 8
  %137 = add nuw nsw i64 %130, 1
  %138 = load i64, ptr %86, align 8
  %139 = icmp slt i64 %137, %138
  br i1 %139, label %129, label %140, !llvm.loop !29

140:                                              ; preds = %129, %85, %125, %113
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
  br i1 %32, label %17, label %23, !llvm.loop !30

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
  br i1 %44, label %29, label %24, !llvm.loop !31

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
  br i1 %59, label %33, label %45, !llvm.loop !32
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
  br i1 %17, label %14, label %9, !llvm.loop !33

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
  br i1 %33, label %15, label %18, !llvm.loop !34

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
  br i1 %44, label %26, label %34, !llvm.loop !35
}

define internal fastcc void @minimum_norm(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2) unnamed_addr #2 {
  %4 = getelementptr inbounds i8, ptr %0, i64 8
  %5 = load i64, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 16
  %7 = load i64, ptr %6, align 8
  %8 = load ptr, ptr %0, align 8
  %9 = getelementptr inbounds i8, ptr %1, i64 120
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %1, i64 144
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %1, i64 168
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %1, i64 216
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %1, i64 240
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %1, i64 192
  %20 = load ptr, ptr %19, align 8
  %21 = icmp sgt i64 %7, 0
  br i1 %21, label %27, label %22

22:                                               ; preds = %27, %3
  %23 = icmp sgt i64 %5, 0
  br i1 %23, label %24, label %32

24:                                               ; preds = %22
  %25 = icmp sgt i64 %7, 0
  %26 = icmp sgt i64 %7, 0
  br label %41

27:                                               ; preds = %3, %27
  %28 = phi i64 [ %30, %27 ], [ 0, %3 ]
  %29 = getelementptr inbounds double, ptr %10, i64 %28
  store double 0.000000e+00, ptr %29, align 8
  %30 = add nuw nsw i64 %28, 1
  %31 = icmp eq i64 %30, %7
  br i1 %31, label %22, label %27, !llvm.loop !36

32:                                               ; preds = %75, %22
  %33 = icmp sgt i64 %2, 0
  br i1 %33, label %34, label %183

34:                                               ; preds = %32
  %35 = icmp sgt i64 %5, 0
  %36 = icmp sgt i64 %7, 0
  %37 = icmp sgt i64 %7, 0
  %38 = icmp sgt i64 %5, 0
  %39 = icmp sgt i64 %7, 0
  %40 = icmp sgt i64 %7, 0
  br label %78

41:                                               ; preds = %24, %75
  %42 = phi i64 [ 0, %24 ], [ %76, %75 ]
  %43 = mul nsw i64 %42, %7
  %44 = getelementptr inbounds double, ptr %8, i64 %43
  br i1 %25, label %45, label %54

45:                                               ; preds = %41, %45
  %46 = phi i64 [ %52, %45 ], [ 0, %41 ]
  %47 = phi double [ %51, %45 ], [ 0.000000e+00, %41 ]
  %48 = getelementptr inbounds double, ptr %44, i64 %46
  %49 = load double, ptr %48, align 8
  %50 = fmul double %49, %49
  %51 = fadd double %47, %50
  %52 = add nuw nsw i64 %46, 1
  %53 = icmp eq i64 %52, %7
  br i1 %53, label %54, label %45, !llvm.loop !24

54:                                               ; preds = %45, %41
  %55 = phi double [ 0.000000e+00, %41 ], [ %51, %45 ]
  %56 = getelementptr inbounds double, ptr %14, i64 %42
  store double 1.000000e+00, ptr %56, align 8
  %57 = getelementptr inbounds i64, ptr %20, i64 %42
  store i64 1, ptr %57, align 8
  %58 = getelementptr inbounds double, ptr %16, i64 %42
  store double 0.000000e+00, ptr %58, align 8
  %59 = getelementptr inbounds double, ptr %18, i64 %42
  store double 0.000000e+00, ptr %59, align 8
  %60 = fcmp ogt double %55, 0.000000e+00
  br i1 %60, label %61, label %75

61:                                               ; preds = %54
  %62 = tail call double @llvm.sqrt.f64(double %55)
  store double %62, ptr %58, align 8
  %63 = fdiv double 1.000000e+00, %62
  store double %63, ptr %56, align 8
  %64 = getelementptr inbounds double, ptr %12, i64 %42
  %65 = load double, ptr %64, align 8
  %66 = fmul double %63, %65
  store double %66, ptr %64, align 8
  br i1 %26, label %67, label %75

67:                                               ; preds = %61, %67
  %68 = phi i64 [ %73, %67 ], [ 0, %61 ]
  %69 = load double, ptr %56, align 8
  %70 = getelementptr inbounds double, ptr %44, i64 %68
  %71 = load double, ptr %70, align 8
  %72 = fmul double %69, %71
  store double %72, ptr %70, align 8
  %73 = add nuw nsw i64 %68, 1
  %74 = icmp eq i64 %73, %7
  br i1 %74, label %75, label %67, !llvm.loop !37

75:                                               ; preds = %67, %61, %54
  %76 = add nuw nsw i64 %42, 1
  %77 = icmp eq i64 %76, %5
  br i1 %77, label %32, label %41, !llvm.loop !38

78:                                               ; preds = %34, %180
  %79 = phi i64 [ 0, %34 ], [ %181, %180 ]
  br i1 %35, label %80, label %113

80:                                               ; preds = %78, %108
  %81 = phi i64 [ %111, %108 ], [ 0, %78 ]
  %82 = phi double [ %110, %108 ], [ 0x3BC79CA10C924224, %78 ]
  %83 = phi i64 [ %109, %108 ], [ -1, %78 ]
  %84 = icmp eq i64 %81, %2
  %85 = fcmp ogt double %82, 1.000000e-04
  %86 = select i1 %84, i1 %85, i1 false
  br i1 %86, label %113, label %87

87:                                               ; preds = %80
  %88 = getelementptr inbounds i64, ptr %20, i64 %81
  %89 = load i64, ptr %88, align 8
  %90 = icmp eq i64 %89, 1
  br i1 %90, label %91, label %108

91:                                               ; preds = %87
  %92 = mul nsw i64 %81, %7
  %93 = getelementptr inbounds double, ptr %8, i64 %92
  br i1 %36, label %94, label %103

94:                                               ; preds = %91, %94
  %95 = phi i64 [ %101, %94 ], [ 0, %91 ]
  %96 = phi double [ %100, %94 ], [ 0.000000e+00, %91 ]
  %97 = getelementptr inbounds double, ptr %93, i64 %95
  %98 = load double, ptr %97, align 8
  %99 = fmul double %98, %98
  %100 = fadd double %96, %99
  %101 = add nuw nsw i64 %95, 1
  %102 = icmp eq i64 %101, %7
  br i1 %102, label %103, label %94, !llvm.loop !24

103:                                              ; preds = %94, %91
  %104 = phi double [ 0.000000e+00, %91 ], [ %100, %94 ]
  %105 = fcmp ogt double %104, %82
  %106 = select i1 %105, i64 %81, i64 %83
  %107 = select i1 %105, double %104, double %82
  br label %108

108:                                              ; preds = %87, %103
  %109 = phi i64 [ %106, %103 ], [ %83, %87 ]
  %110 = phi double [ %107, %103 ], [ %82, %87 ]
  %111 = add nuw nsw i64 %81, 1
  %112 = icmp eq i64 %111, %5
  br i1 %112, label %113, label %80, !llvm.loop !39

113:                                              ; preds = %108, %80, %78
  %114 = phi i64 [ -1, %78 ], [ %109, %108 ], [ %83, %80 ]
  %115 = phi double [ 0x3BC79CA10C924224, %78 ], [ %110, %108 ], [ %82, %80 ]
  %116 = icmp sgt i64 %114, -1
  br i1 %116, label %117, label %183

117:                                              ; preds = %113
  %118 = tail call double @llvm.sqrt.f64(double %115)
  %119 = getelementptr inbounds double, ptr %12, i64 %114
  %120 = load double, ptr %119, align 8
  %121 = fdiv double %120, %118
  %122 = mul nsw i64 %114, %7
  %123 = getelementptr inbounds double, ptr %8, i64 %122
  %124 = getelementptr inbounds i64, ptr %20, i64 %114
  store i64 0, ptr %124, align 8
  store double 0.000000e+00, ptr %119, align 8
  %125 = getelementptr inbounds double, ptr %16, i64 %114
  %126 = load double, ptr %125, align 8
  %127 = fmul double %118, %126
  %128 = getelementptr inbounds double, ptr %18, i64 %114
  store double %127, ptr %128, align 8
  br i1 %37, label %130, label %129

129:                                              ; preds = %130, %117
  br i1 %38, label %141, label %179

130:                                              ; preds = %117, %130
  %131 = phi i64 [ %139, %130 ], [ 0, %117 ]
  %132 = getelementptr inbounds double, ptr %123, i64 %131
  %133 = load double, ptr %132, align 8
  %134 = fdiv double %133, %118
  store double %134, ptr %132, align 8
  %135 = fmul double %121, %134
  %136 = getelementptr inbounds double, ptr %10, i64 %131
  %137 = load double, ptr %136, align 8
  %138 = fadd double %137, %135
  store double %138, ptr %136, align 8
  %139 = add nuw nsw i64 %131, 1
  %140 = icmp eq i64 %139, %7
  br i1 %140, label %129, label %130, !llvm.loop !40

141:                                              ; preds = %129, %176
  %142 = phi i64 [ %177, %176 ], [ 0, %129 ]
  %143 = getelementptr inbounds i64, ptr %20, i64 %142
  %144 = load i64, ptr %143, align 8
  %145 = icmp eq i64 %144, 1
  br i1 %145, label %146, label %176

146:                                              ; preds = %141
  %147 = mul nsw i64 %142, %7
  %148 = getelementptr double, ptr %8, i64 %147
  br i1 %39, label %149, label %160

149:                                              ; preds = %146, %149
  %150 = phi i64 [ %158, %149 ], [ 0, %146 ]
  %151 = phi double [ %157, %149 ], [ 0.000000e+00, %146 ]
  %152 = getelementptr inbounds double, ptr %148, i64 %150
  %153 = load double, ptr %152, align 8
  %154 = getelementptr inbounds double, ptr %123, i64 %150
  %155 = load double, ptr %154, align 8
  %156 = fmul double %153, %155
  %157 = fadd double %151, %156
  %158 = add nuw nsw i64 %150, 1
  %159 = icmp eq i64 %158, %7
  br i1 %159, label %160, label %149, !llvm.loop !24

160:                                              ; preds = %149, %146
  %161 = phi double [ 0.000000e+00, %146 ], [ %157, %149 ]
  %162 = fmul double %121, %161
  %163 = getelementptr inbounds double, ptr %12, i64 %142
  %164 = load double, ptr %163, align 8
  %165 = fsub double %164, %162
  store double %165, ptr %163, align 8
  br i1 %40, label %166, label %176

166:                                              ; preds = %160, %166
  %167 = phi i64 [ %174, %166 ], [ 0, %160 ]
  %168 = getelementptr inbounds double, ptr %123, i64 %167
  %169 = load double, ptr %168, align 8
  %170 = fmul double %161, %169
  %171 = getelementptr double, ptr %148, i64 %167
  %172 = load double, ptr %171, align 8
  %173 = fsub double %172, %170
  store double %173, ptr %171, align 8
  %174 = add nuw nsw i64 %167, 1
  %175 = icmp eq i64 %174, %7
  br i1 %175, label %176, label %166, !llvm.loop !41

176:                                              ; preds = %166, %160, %141
  %177 = add nuw nsw i64 %142, 1
  %178 = icmp eq i64 %177, %5
  br i1 %178, label %179, label %141, !llvm.loop !42

179:                                              ; preds = %176, %129
  br i1 %116, label %180, label %183

180:                                              ; preds = %179
  %181 = add nuw nsw i64 %79, 1
  %182 = icmp eq i64 %181, %2
  br i1 %182, label %183, label %78, !llvm.loop !43

183:                                              ; preds = %180, %179, %113, %32
  %184 = phi i64 [ 0, %32 ], [ %2, %180 ], [ %79, %179 ], [ %79, %113 ]
  %185 = icmp sgt i64 %5, 0
  br i1 %185, label %186, label %190

186:                                              ; preds = %183
  %187 = icmp eq i64 %184, %2
  %188 = icmp sgt i64 %5, %2
  %189 = select i1 %187, i1 %188, i1 false
  br label %191

190:                                              ; preds = %199, %183
  ret void

191:                                              ; preds = %186, %199
  %192 = phi i64 [ 0, %186 ], [ %202, %199 ]
  br i1 %189, label %199, label %193

193:                                              ; preds = %191
  %194 = getelementptr inbounds double, ptr %12, i64 %192
  %195 = load double, ptr %194, align 8
  %196 = getelementptr inbounds double, ptr %14, i64 %192
  %197 = load double, ptr %196, align 8
  %198 = fdiv double %195, %197
  br label %199

199:                                              ; preds = %191, %193
  %200 = phi double [ %198, %193 ], [ 0.000000e+00, %191 ]
  %201 = getelementptr inbounds double, ptr %12, i64 %192
  store double %200, ptr %201, align 8
  %202 = add nuw nsw i64 %192, 1
  %203 = icmp eq i64 %202, %5
  br i1 %203, label %190, label %191, !llvm.loop !44
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
  br i1 %21, label %8, label %7, !llvm.loop !45

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
  br i1 %33, label %15, label %22, !llvm.loop !46
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
  br i1 %27, label %15, label %19, !llvm.loop !47

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
  br i1 %59, label %48, label %71, !llvm.loop !48

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
  br i1 %70, label %54, label %60, !llvm.loop !49

71:                                               ; preds = %54, %32, %42
  %72 = add nuw nsw i64 %9, 1
  %73 = icmp eq i64 %72, %1
  %74 = select i1 %18, i1 true, i1 %73
  br i1 %74, label %75, label %8, !llvm.loop !50

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
!49 = distinct !{!49, !7, !8}
!50 = distinct !{!50, !7, !8}
