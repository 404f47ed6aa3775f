; sources 7f13ad689253e0d1fe6d7402cb3695b3566b930bd8af117befc90c83c26ceacc
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Held = type { ptr, i64, i64, i64, i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

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
  %26 = getelementptr inbounds i8, ptr %6, i64 80
  %27 = load i64, ptr %26, align 8, !noalias !3
  store i64 %27, ptr %25, align 8, !alias.scope !3
  %28 = getelementptr inbounds i8, ptr %4, i64 56
  %29 = getelementptr inbounds i8, ptr %6, i64 88
  %30 = load i64, ptr %29, align 8, !noalias !3
  store i64 %30, ptr %28, align 8, !alias.scope !3
  %31 = getelementptr inbounds i8, ptr %4, i64 64
  %32 = getelementptr inbounds i8, ptr %0, i64 696
  %33 = load ptr, ptr %32, align 8, !noalias !3
  store ptr %33, ptr %31, align 8, !alias.scope !3
  %34 = getelementptr inbounds i8, ptr %4, i64 72
  store ptr null, ptr %34, align 8, !alias.scope !3
  %35 = getelementptr inbounds i8, ptr %4, i64 80
  store ptr null, ptr %35, align 8, !alias.scope !3
  %36 = getelementptr inbounds i8, ptr %4, i64 88
  store ptr null, ptr %36, align 8, !alias.scope !3
  %37 = getelementptr inbounds i8, ptr %4, i64 96
  store ptr null, ptr %37, align 8, !alias.scope !3
  %38 = getelementptr inbounds i8, ptr %4, i64 104
  store ptr null, ptr %38, align 8, !alias.scope !3
  %39 = getelementptr inbounds i8, ptr %4, i64 112
  store ptr null, ptr %39, align 8, !alias.scope !3
  %40 = getelementptr double, ptr %33, i64 %12
  %41 = getelementptr inbounds double, ptr %40, i64 %15
  store ptr %41, ptr %34, align 8, !alias.scope !3
  %42 = mul nsw i64 %18, %12
  %43 = getelementptr inbounds double, ptr %41, i64 %42
  store ptr %43, ptr %35, align 8, !alias.scope !3
  %44 = mul nsw i64 %21, %18
  %45 = getelementptr inbounds double, ptr %43, i64 %44
  store ptr %45, ptr %36, align 8, !alias.scope !3
  %46 = mul i64 %21, %15
  %47 = getelementptr inbounds double, ptr %45, i64 %46
  store ptr %47, ptr %37, align 8, !alias.scope !3
  %48 = mul i64 %21, %21
  %49 = mul i64 %48, %24
  %50 = getelementptr inbounds double, ptr %47, i64 %49
  store ptr %50, ptr %38, align 8, !alias.scope !3
  %51 = getelementptr inbounds double, ptr %50, i64 %12
  store ptr %51, ptr %39, align 8, !alias.scope !3
  %52 = getelementptr inbounds i8, ptr %0, i64 144
  %53 = getelementptr inbounds i8, ptr %0, i64 168
  %54 = load ptr, ptr %53, align 8
  store double %1, ptr %54, align 8
  %55 = getelementptr inbounds i8, ptr %0, i64 248
  %56 = load i64, ptr %55, align 8
  %57 = icmp sgt i64 %56, 0
  br i1 %57, label %58, label %59

58:                                               ; preds = %3
  tail call fastcc void @sample(ptr noundef nonnull %52) #7
  br label %59

59:                                               ; preds = %3, %58
  %60 = getelementptr inbounds i8, ptr %0, i64 600
  %61 = load ptr, ptr %60, align 8
  %62 = getelementptr inbounds i8, ptr %61, i64 88
  %63 = load i64, ptr %62, align 8
  %64 = add nsw i64 %63, 1
  store i64 %64, ptr %62, align 8
  %65 = load ptr, ptr %9, align 8
  %66 = icmp sgt i64 %21, 0
  br i1 %66, label %67, label %81

67:                                               ; preds = %59, %71
  %68 = phi i64 [ %72, %71 ], [ 0, %59 ]
  %69 = mul nuw nsw i64 %68, %21
  %70 = getelementptr double, ptr %65, i64 %69
  br label %74

71:                                               ; preds = %74
  %72 = add nuw nsw i64 %68, 1
  %73 = icmp eq i64 %72, %21
  br i1 %73, label %81, label %67, !llvm.loop !6

74:                                               ; preds = %67, %74
  %75 = phi i64 [ 0, %67 ], [ %79, %74 ]
  %76 = icmp eq i64 %68, %75
  %77 = select i1 %76, double 1.000000e+00, double 0.000000e+00
  %78 = getelementptr double, ptr %70, i64 %75
  store double %77, ptr %78, align 8
  %79 = add nuw nsw i64 %75, 1
  %80 = icmp eq i64 %79, %21
  br i1 %80, label %71, label %74, !llvm.loop !9

81:                                               ; preds = %71, %59
  %82 = getelementptr inbounds i8, ptr %9, i64 264
  %83 = load ptr, ptr %82, align 8
  %84 = icmp sgt i64 %12, 0
  br i1 %84, label %110, label %85

85:                                               ; preds = %110, %81
  %86 = getelementptr inbounds i8, ptr %0, i64 168
  %87 = getelementptr inbounds i8, ptr %0, i64 192
  %88 = getelementptr inbounds i8, ptr %0, i64 672
  %89 = load ptr, ptr %5, align 8
  %90 = getelementptr inbounds i8, ptr %89, i64 8
  %91 = load i64, ptr %90, align 8
  %92 = load ptr, ptr %86, align 8
  %93 = load ptr, ptr %87, align 8
  %94 = load ptr, ptr %88, align 8
  %95 = inttoptr i64 %91 to ptr
  %96 = tail call i32 %95(ptr noundef %92, ptr noundef %2, ptr noundef %93, ptr noundef %94, ptr noundef %33) #8
  %97 = icmp slt i32 %96, 0
  br i1 %97, label %230, label %98

98:                                               ; preds = %85
  %99 = icmp sgt i64 %12, 0
  %100 = icmp eq i64 %27, %12
  %101 = getelementptr inbounds i8, ptr %9, i64 240
  %102 = icmp eq i64 %24, 1
  %103 = getelementptr inbounds i8, ptr %9, i64 8
  %104 = getelementptr inbounds i8, ptr %9, i64 16
  %105 = getelementptr inbounds i8, ptr %9, i64 24
  %106 = getelementptr inbounds i8, ptr %9, i64 32
  %107 = getelementptr inbounds i8, ptr %9, i64 40
  %108 = getelementptr inbounds i8, ptr %9, i64 144
  %109 = icmp sgt i64 %12, 0
  br label %126

110:                                              ; preds = %81, %110
  %111 = phi i64 [ %113, %110 ], [ 0, %81 ]
  %112 = getelementptr inbounds double, ptr %83, i64 %111
  store double 0.000000e+00, ptr %112, align 8
  %113 = add nuw nsw i64 %111, 1
  %114 = icmp eq i64 %113, %12
  br i1 %114, label %85, label %110, !llvm.loop !10

115:                                              ; preds = %226
  %116 = add nuw nsw i32 %129, 1
  %117 = load ptr, ptr %5, align 8
  %118 = getelementptr inbounds i8, ptr %117, i64 8
  %119 = load i64, ptr %118, align 8
  %120 = load ptr, ptr %86, align 8
  %121 = load ptr, ptr %87, align 8
  %122 = load ptr, ptr %88, align 8
  %123 = inttoptr i64 %119 to ptr
  %124 = tail call i32 %123(ptr noundef %120, ptr noundef %2, ptr noundef %121, ptr noundef %122, ptr noundef %33) #8
  %125 = icmp slt i32 %124, 0
  br i1 %125, label %230, label %126, !llvm.loop !11

126:                                              ; preds = %98, %115
  %127 = phi i64 [ undef, %98 ], [ %229, %115 ]
  %128 = phi double [ 0x7FF0000000000000, %98 ], [ %228, %115 ]
  %129 = phi i32 [ 0, %98 ], [ %116, %115 ]
  br i1 %99, label %130, label %167

130:                                              ; preds = %126
  %131 = icmp eq i32 %129, 0
  %132 = select i1 %131, i1 true, i1 %100
  br label %137

133:                                              ; preds = %163
  %134 = add nuw nsw i64 %140, 1
  %135 = icmp slt i64 %134, %12
  %136 = icmp eq i64 %134, %12
  br i1 %136, label %167, label %137, !llvm.loop !12

137:                                              ; preds = %130, %133
  %138 = phi i1 [ %99, %130 ], [ %135, %133 ]
  %139 = phi i64 [ %127, %130 ], [ %166, %133 ]
  %140 = phi i64 [ 0, %130 ], [ %134, %133 ]
  %141 = phi double [ 0.000000e+00, %130 ], [ %164, %133 ]
  %142 = getelementptr inbounds double, ptr %33, i64 %140
  %143 = load double, ptr %142, align 8
  %144 = tail call double @llvm.fabs.f64(double %143)
  %145 = fcmp une double %143, 0.000000e+00
  br i1 %145, label %146, label %163

146:                                              ; preds = %137
  br i1 %132, label %152, label %147

147:                                              ; preds = %146
  %148 = load ptr, ptr %101, align 8
  %149 = getelementptr inbounds double, ptr %148, i64 %140
  %150 = load double, ptr %149, align 8
  %151 = fcmp ogt double %150, 0.000000e+00
  br i1 %151, label %152, label %163

152:                                              ; preds = %147, %146
  %153 = getelementptr inbounds double, ptr %50, i64 %140
  %154 = load double, ptr %153, align 8
  %155 = getelementptr inbounds double, ptr %83, i64 %140
  %156 = load double, ptr %155, align 8
  %157 = fcmp ogt double %154, %156
  %158 = select i1 %157, double %154, double %156
  %159 = fmul double %158, 0x3CB0000000000000
  %160 = fdiv double %144, %159
  %161 = fcmp ogt double %160, %141
  %162 = select i1 %161, double %160, double %141
  br label %163

163:                                              ; preds = %152, %147, %137
  %164 = phi double [ %162, %152 ], [ %141, %147 ], [ %141, %137 ]
  %165 = fcmp ueq double %144, 0x7FF0000000000000
  %166 = select i1 %165, i64 6, i64 %139
  br i1 %165, label %167, label %133

167:                                              ; preds = %133, %163, %126
  %168 = phi i1 [ %99, %126 ], [ %135, %133 ], [ %138, %163 ]
  %169 = phi double [ 0.000000e+00, %126 ], [ %164, %163 ], [ %164, %133 ]
  %170 = phi i64 [ %127, %126 ], [ %166, %163 ], [ %166, %133 ]
  br i1 %168, label %226, label %171

171:                                              ; preds = %167
  %172 = fcmp ugt double %169, 1.000000e+00
  br i1 %172, label %173, label %226

173:                                              ; preds = %171
  %174 = fmul double %128, 5.000000e-01
  %175 = fcmp oge double %169, %174
  %176 = fcmp ole double %169, 8.000000e+00
  %177 = and i1 %175, %176
  br i1 %177, label %226, label %178

178:                                              ; preds = %173
  %179 = icmp eq i32 %129, 9
  br i1 %179, label %226, label %180

180:                                              ; preds = %178
  br i1 %102, label %181, label %199

181:                                              ; preds = %180
  %182 = load i64, ptr %103, align 8
  %183 = load i64, ptr %104, align 8
  %184 = mul nsw i64 %183, %182
  %185 = icmp sgt i64 %184, 0
  br i1 %185, label %186, label %197

186:                                              ; preds = %181, %186
  %187 = phi i64 [ %192, %186 ], [ 0, %181 ]
  %188 = getelementptr inbounds double, ptr %47, i64 %187
  %189 = load double, ptr %188, align 8
  %190 = load ptr, ptr %9, align 8
  %191 = getelementptr inbounds double, ptr %190, i64 %187
  store double %189, ptr %191, align 8
  %192 = add nuw nsw i64 %187, 1
  %193 = load i64, ptr %103, align 8
  %194 = load i64, ptr %104, align 8
  %195 = mul nsw i64 %194, %193
  %196 = icmp slt i64 %192, %195
  br i1 %196, label %186, label %197, !llvm.loop !13

197:                                              ; preds = %186, %181
  %198 = load ptr, ptr %9, align 8
  tail call fastcc void @factorise(ptr noundef %198, i64 noundef %21) #7
  br label %199

199:                                              ; preds = %180, %197
  %200 = load i64, ptr %106, align 8
  %201 = load i64, ptr %107, align 8
  %202 = mul nsw i64 %201, %200
  %203 = icmp sgt i64 %202, 0
  br i1 %203, label %204, label %215

204:                                              ; preds = %199, %204
  %205 = phi i64 [ %210, %204 ], [ 0, %199 ]
  %206 = getelementptr inbounds double, ptr %43, i64 %205
  %207 = load double, ptr %206, align 8
  %208 = load ptr, ptr %105, align 8
  %209 = getelementptr inbounds double, ptr %208, i64 %205
  store double %207, ptr %209, align 8
  %210 = add nuw nsw i64 %205, 1
  %211 = load i64, ptr %106, align 8
  %212 = load i64, ptr %107, align 8
  %213 = mul nsw i64 %212, %211
  %214 = icmp slt i64 %210, %213
  br i1 %214, label %204, label %215, !llvm.loop !13

215:                                              ; preds = %204, %199
  %216 = load ptr, ptr %108, align 8
  br i1 %109, label %217, label %225

217:                                              ; preds = %215, %217
  %218 = phi i64 [ %223, %217 ], [ 0, %215 ]
  %219 = getelementptr inbounds double, ptr %33, i64 %218
  %220 = load double, ptr %219, align 8
  %221 = fneg double %220
  %222 = getelementptr inbounds double, ptr %216, i64 %218
  store double %221, ptr %222, align 8
  %223 = add nuw nsw i64 %218, 1
  %224 = icmp eq i64 %223, %12
  br i1 %224, label %225, label %217, !llvm.loop !14

225:                                              ; preds = %217, %215
  call fastcc void @move_positions(ptr noundef nonnull %4, ptr noundef %2) #7
  br label %226

226:                                              ; preds = %225, %178, %173, %171, %167
  %227 = phi i1 [ true, %225 ], [ false, %167 ], [ false, %173 ], [ false, %171 ], [ false, %178 ]
  %228 = phi double [ %169, %225 ], [ %128, %167 ], [ %128, %173 ], [ %128, %171 ], [ %128, %178 ]
  %229 = phi i64 [ %170, %225 ], [ %170, %167 ], [ 0, %173 ], [ 0, %171 ], [ 6, %178 ]
  br i1 %227, label %115, label %230

230:                                              ; preds = %226, %115, %85
  %231 = phi i64 [ 6, %85 ], [ %229, %226 ], [ 6, %115 ]
  %232 = icmp ne i64 %231, 0
  %233 = icmp eq i64 %15, 0
  %234 = select i1 %232, i1 true, i1 %233
  br i1 %234, label %359, label %235

235:                                              ; preds = %230
  %236 = icmp sgt i64 %15, 0
  br i1 %236, label %240, label %237

237:                                              ; preds = %240, %235
  %238 = phi double [ 0.000000e+00, %235 ], [ %246, %240 ]
  %239 = icmp sgt i64 %46, 0
  br i1 %239, label %252, label %249

240:                                              ; preds = %235, %240
  %241 = phi i64 [ %247, %240 ], [ 0, %235 ]
  %242 = phi double [ %246, %240 ], [ 0.000000e+00, %235 ]
  %243 = getelementptr double, ptr %40, i64 %241
  %244 = load double, ptr %243, align 8
  %245 = fmul double %244, 0.000000e+00
  %246 = fadd double %242, %245
  %247 = add nuw nsw i64 %241, 1
  %248 = icmp eq i64 %247, %15
  br i1 %248, label %237, label %240, !llvm.loop !15

249:                                              ; preds = %252, %237
  %250 = phi double [ %238, %237 ], [ %258, %252 ]
  %251 = fcmp une double %250, 0.000000e+00
  br i1 %251, label %359, label %261

252:                                              ; preds = %237, %252
  %253 = phi i64 [ %259, %252 ], [ 0, %237 ]
  %254 = phi double [ %258, %252 ], [ %238, %237 ]
  %255 = getelementptr inbounds double, ptr %45, i64 %253
  %256 = load double, ptr %255, align 8
  %257 = fmul double %256, 0.000000e+00
  %258 = fadd double %254, %257
  %259 = add nuw nsw i64 %253, 1
  %260 = icmp eq i64 %259, %46
  br i1 %260, label %249, label %252, !llvm.loop !16

261:                                              ; preds = %249
  %262 = icmp eq i64 %24, 1
  br i1 %262, label %263, label %283

263:                                              ; preds = %261
  %264 = getelementptr inbounds i8, ptr %9, i64 8
  %265 = getelementptr inbounds i8, ptr %9, i64 16
  %266 = load i64, ptr %264, align 8
  %267 = load i64, ptr %265, align 8
  %268 = mul nsw i64 %267, %266
  %269 = icmp sgt i64 %268, 0
  br i1 %269, label %270, label %281

270:                                              ; preds = %263, %270
  %271 = phi i64 [ %276, %270 ], [ 0, %263 ]
  %272 = getelementptr inbounds double, ptr %47, i64 %271
  %273 = load double, ptr %272, align 8
  %274 = load ptr, ptr %9, align 8
  %275 = getelementptr inbounds double, ptr %274, i64 %271
  store double %273, ptr %275, align 8
  %276 = add nuw nsw i64 %271, 1
  %277 = load i64, ptr %264, align 8
  %278 = load i64, ptr %265, align 8
  %279 = mul nsw i64 %278, %277
  %280 = icmp slt i64 %276, %279
  br i1 %280, label %270, label %281, !llvm.loop !13

281:                                              ; preds = %270, %263
  %282 = load ptr, ptr %9, align 8
  tail call fastcc void @factorise(ptr noundef %282, i64 noundef %21) #7
  br label %283

283:                                              ; preds = %261, %281
  %284 = getelementptr inbounds i8, ptr %9, i64 144
  %285 = load ptr, ptr %284, align 8
  %286 = icmp sgt i64 %15, 0
  br i1 %286, label %287, label %295

287:                                              ; preds = %283, %287
  %288 = phi i64 [ %293, %287 ], [ 0, %283 ]
  %289 = getelementptr inbounds double, ptr %40, i64 %288
  %290 = load double, ptr %289, align 8
  %291 = fneg double %290
  %292 = getelementptr inbounds double, ptr %285, i64 %288
  store double %291, ptr %292, align 8
  %293 = add nuw nsw i64 %288, 1
  %294 = icmp eq i64 %293, %15
  br i1 %294, label %295, label %287, !llvm.loop !14

295:                                              ; preds = %287, %283
  call fastcc void @move_speeds(ptr noundef nonnull %4, ptr noundef %2) #7
  %296 = load ptr, ptr %52, align 8
  %297 = getelementptr inbounds i8, ptr %296, i64 8
  %298 = load i64, ptr %297, align 8
  %299 = getelementptr inbounds i8, ptr %9, i64 216
  %300 = load ptr, ptr %299, align 8
  %301 = getelementptr inbounds i8, ptr %9, i64 240
  %302 = load ptr, ptr %301, align 8
  %303 = getelementptr inbounds i8, ptr %51, i64 24
  %304 = getelementptr inbounds double, ptr %303, i64 %298
  %305 = icmp sgt i64 %15, 0
  br i1 %305, label %313, label %308

306:                                              ; preds = %331
  %307 = sitofp i64 %333 to double
  br label %308

308:                                              ; preds = %306, %295
  %309 = phi double [ 1.000000e+00, %295 ], [ %332, %306 ]
  %310 = phi double [ 0.000000e+00, %295 ], [ %307, %306 ]
  %311 = load double, ptr %51, align 8
  %312 = fcmp olt double %311, %310
  br i1 %312, label %336, label %338

313:                                              ; preds = %295, %331
  %314 = phi i64 [ %334, %331 ], [ 0, %295 ]
  %315 = phi i64 [ %333, %331 ], [ 0, %295 ]
  %316 = phi double [ %332, %331 ], [ 1.000000e+00, %295 ]
  %317 = getelementptr inbounds double, ptr %300, i64 %314
  %318 = load double, ptr %317, align 8
  %319 = getelementptr inbounds double, ptr %304, i64 %314
  %320 = load double, ptr %319, align 8
  %321 = fcmp ogt double %318, %320
  %322 = select i1 %321, double %318, double %320
  store double %322, ptr %319, align 8
  %323 = getelementptr inbounds double, ptr %302, i64 %314
  %324 = load double, ptr %323, align 8
  %325 = fcmp ogt double %324, 0.000000e+00
  br i1 %325, label %326, label %331

326:                                              ; preds = %313
  %327 = add nsw i64 %315, 1
  %328 = fdiv double %324, %322
  %329 = fcmp olt double %328, %316
  %330 = select i1 %329, double %328, double %316
  br label %331

331:                                              ; preds = %326, %313
  %332 = phi double [ %330, %326 ], [ %316, %313 ]
  %333 = phi i64 [ %327, %326 ], [ %315, %313 ]
  %334 = add nuw nsw i64 %314, 1
  %335 = icmp eq i64 %334, %15
  br i1 %335, label %306, label %313, !llvm.loop !17

336:                                              ; preds = %308
  store double %310, ptr %51, align 8
  %337 = getelementptr inbounds i8, ptr %51, i64 8
  store double 1.000000e+00, ptr %337, align 8
  br label %341

338:                                              ; preds = %308
  %339 = fcmp ogt double %311, %310
  br i1 %339, label %340, label %341

340:                                              ; preds = %338
  br label %341

341:                                              ; preds = %340, %338, %336
  %342 = phi double [ %309, %336 ], [ 0.000000e+00, %340 ], [ %309, %338 ]
  %343 = getelementptr inbounds i8, ptr %51, i64 8
  %344 = load double, ptr %343, align 8
  %345 = fcmp olt double %342, %344
  %346 = fcmp ogt double %344, 1.000000e-05
  %347 = and i1 %345, %346
  br i1 %347, label %348, label %359

348:                                              ; preds = %341
  store double %342, ptr %343, align 8
  %349 = getelementptr inbounds i8, ptr %51, i64 16
  store double %1, ptr %349, align 8
  %350 = getelementptr inbounds i8, ptr %51, i64 24
  %351 = icmp sgt i64 %298, 0
  br i1 %351, label %352, label %359

352:                                              ; preds = %348, %352
  %353 = phi i64 [ %357, %352 ], [ 0, %348 ]
  %354 = getelementptr inbounds double, ptr %2, i64 %353
  %355 = load double, ptr %354, align 8
  %356 = getelementptr inbounds double, ptr %350, i64 %353
  store double %355, ptr %356, align 8
  %357 = add nuw nsw i64 %353, 1
  %358 = icmp eq i64 %357, %298
  br i1 %358, label %359, label %352, !llvm.loop !18

359:                                              ; preds = %352, %348, %341, %249, %230
  %360 = phi i64 [ %231, %230 ], [ 6, %249 ], [ 0, %341 ], [ 0, %348 ], [ 0, %352 ]
  ret i64 %360
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
  br i1 %23, label %13, label %24, !llvm.loop !13

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
  br i1 %54, label %42, label %41, !llvm.loop !19
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
  br i1 %48, label %49, label %40, !llvm.loop !22

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
  br i1 %78, label %64, label %57, !llvm.loop !23

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
  br i1 %95, label %79, label %85, !llvm.loop !24

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
  br i1 %112, label %96, label %92, !llvm.loop !25

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
  br i1 %124, label %113, label %115, !llvm.loop !26

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
  br i1 %139, label %129, label %140, !llvm.loop !27

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
  br i1 %31, label %22, label %27, !llvm.loop !34

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
  br i1 %53, label %54, label %45, !llvm.loop !22

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
  br i1 %74, label %75, label %67, !llvm.loop !35

75:                                               ; preds = %67, %61, %54
  %76 = add nuw nsw i64 %42, 1
  %77 = icmp eq i64 %76, %5
  br i1 %77, label %32, label %41, !llvm.loop !36

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
  br i1 %102, label %103, label %94, !llvm.loop !22

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
  br i1 %112, label %113, label %80, !llvm.loop !37

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
  br i1 %140, label %129, label %130, !llvm.loop !38

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
  br i1 %159, label %160, label %149, !llvm.loop !22

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
  br i1 %175, label %176, label %166, !llvm.loop !39

176:                                              ; preds = %166, %160, %141
  %177 = add nuw nsw i64 %142, 1
  %178 = icmp eq i64 %177, %5
  br i1 %178, label %179, label %141, !llvm.loop !40

179:                                              ; preds = %176, %129
  br i1 %116, label %180, label %183

180:                                              ; preds = %179
  %181 = add nuw nsw i64 %79, 1
  %182 = icmp eq i64 %181, %2
  br i1 %182, label %183, label %78, !llvm.loop !41

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
  br i1 %203, label %190, label %191, !llvm.loop !42
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
