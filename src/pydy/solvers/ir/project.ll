; sources 17b627542c831f91887b5fcdba2fff84dc114757e42bfb97ea777d667485f82e
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Held = type { ptr, i64, i64, i64, i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

define i64 @project(ptr noundef readonly %0, double noundef %1, ptr noundef %2, ptr noundef readonly %3) #0 {
  %5 = alloca %struct.Held, align 8
  tail call void @llvm.experimental.noalias.scope.decl(metadata !3)
  %6 = getelementptr inbounds i8, ptr %0, i64 648
  %7 = load ptr, ptr %6, align 8, !noalias !3
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
  %53 = getelementptr inbounds i8, ptr %0, i64 144
  %54 = getelementptr inbounds i8, ptr %0, i64 168
  %55 = load ptr, ptr %54, align 8
  store double %1, ptr %55, align 8
  %56 = getelementptr inbounds i8, ptr %0, i64 248
  %57 = load i64, ptr %56, align 8
  %58 = icmp sgt i64 %57, 0
  br i1 %58, label %59, label %60

59:                                               ; preds = %4
  tail call fastcc void @sample(ptr noundef nonnull %53) #7
  br label %60

60:                                               ; preds = %4, %59
  %61 = getelementptr inbounds i8, ptr %0, i64 600
  %62 = load ptr, ptr %61, align 8
  %63 = getelementptr inbounds i8, ptr %62, i64 88
  %64 = load i64, ptr %63, align 8
  %65 = add nsw i64 %64, 1
  store i64 %65, ptr %63, align 8
  %66 = load ptr, ptr %5, align 8
  %67 = load ptr, ptr %66, align 8
  %68 = load i64, ptr %20, align 8
  %69 = icmp sgt i64 %68, 0
  br i1 %69, label %70, label %84

70:                                               ; preds = %60, %74
  %71 = phi i64 [ %75, %74 ], [ 0, %60 ]
  %72 = mul nuw nsw i64 %71, %68
  %73 = getelementptr double, ptr %67, i64 %72
  br label %77

74:                                               ; preds = %77
  %75 = add nuw nsw i64 %71, 1
  %76 = icmp eq i64 %75, %68
  br i1 %76, label %84, label %70, !llvm.loop !6

77:                                               ; preds = %70, %77
  %78 = phi i64 [ 0, %70 ], [ %82, %77 ]
  %79 = icmp eq i64 %71, %78
  %80 = select i1 %79, double 1.000000e+00, double 0.000000e+00
  %81 = getelementptr double, ptr %73, i64 %78
  store double %80, ptr %81, align 8
  %82 = add nuw nsw i64 %78, 1
  %83 = icmp eq i64 %82, %68
  br i1 %83, label %74, label %77, !llvm.loop !9

84:                                               ; preds = %74, %60
  %85 = load ptr, ptr %5, align 8
  %86 = getelementptr inbounds i8, ptr %85, i64 264
  %87 = load ptr, ptr %86, align 8
  %88 = load i64, ptr %11, align 8
  %89 = icmp sgt i64 %88, 0
  br i1 %89, label %130, label %90

90:                                               ; preds = %130, %84
  %91 = getelementptr inbounds i8, ptr %0, i64 168
  %92 = getelementptr inbounds i8, ptr %0, i64 192
  %93 = getelementptr inbounds i8, ptr %0, i64 672
  %94 = load ptr, ptr %32, align 8
  %95 = load ptr, ptr %6, align 8
  %96 = getelementptr inbounds i8, ptr %95, i64 8
  %97 = load i64, ptr %96, align 8
  %98 = load ptr, ptr %91, align 8
  %99 = load ptr, ptr %92, align 8
  %100 = load ptr, ptr %93, align 8
  %101 = inttoptr i64 %97 to ptr
  %102 = tail call i32 %101(ptr noundef %98, ptr noundef %2, ptr noundef %99, ptr noundef %100, ptr noundef %94) #8
  %103 = icmp slt i32 %102, 0
  br i1 %103, label %311, label %104

104:                                              ; preds = %90
  %105 = load i64, ptr %11, align 8
  %106 = icmp sgt i64 %105, 0
  %107 = load ptr, ptr %32, align 8
  %108 = load i64, ptr %26, align 8
  %109 = icmp eq i64 %108, %105
  %110 = load ptr, ptr %5, align 8
  %111 = getelementptr inbounds i8, ptr %110, i64 240
  %112 = load ptr, ptr %39, align 8
  %113 = icmp eq ptr %3, null
  %114 = icmp slt i64 %28, %105
  %115 = icmp slt i64 %105, 1
  %116 = icmp sgt i64 %19, 0
  %117 = getelementptr inbounds i8, ptr %0, i64 552
  %118 = getelementptr inbounds i8, ptr %0, i64 528
  %119 = select i1 %114, double 1.000000e-05, double 0x3CE0000000000000
  %120 = add nsw i64 %68, %19
  %121 = sitofp i64 %120 to double
  %122 = icmp eq i64 %25, 1
  %123 = getelementptr inbounds i8, ptr %85, i64 8
  %124 = getelementptr inbounds i8, ptr %85, i64 16
  %125 = getelementptr inbounds i8, ptr %85, i64 24
  %126 = getelementptr inbounds i8, ptr %85, i64 32
  %127 = getelementptr inbounds i8, ptr %85, i64 40
  %128 = getelementptr inbounds i8, ptr %85, i64 144
  %129 = icmp sgt i64 %105, 0
  br label %146

130:                                              ; preds = %84, %130
  %131 = phi i64 [ %133, %130 ], [ 0, %84 ]
  %132 = getelementptr inbounds double, ptr %87, i64 %131
  store double 0.000000e+00, ptr %132, align 8
  %133 = add nuw nsw i64 %131, 1
  %134 = icmp eq i64 %133, %88
  br i1 %134, label %90, label %130, !llvm.loop !10

135:                                              ; preds = %306
  %136 = add nuw nsw i32 %149, 1
  %137 = load ptr, ptr %6, align 8
  %138 = getelementptr inbounds i8, ptr %137, i64 8
  %139 = load i64, ptr %138, align 8
  %140 = load ptr, ptr %91, align 8
  %141 = load ptr, ptr %92, align 8
  %142 = load ptr, ptr %93, align 8
  %143 = inttoptr i64 %139 to ptr
  %144 = tail call i32 %143(ptr noundef %140, ptr noundef %2, ptr noundef %141, ptr noundef %142, ptr noundef %94) #8
  %145 = icmp slt i32 %144, 0
  br i1 %145, label %311, label %146, !llvm.loop !11

146:                                              ; preds = %104, %135
  %147 = phi i64 [ undef, %104 ], [ %310, %135 ]
  %148 = phi double [ 0x7FF0000000000000, %104 ], [ %309, %135 ]
  %149 = phi i32 [ 0, %104 ], [ %136, %135 ]
  %150 = phi double [ 0.000000e+00, %104 ], [ %307, %135 ]
  br i1 %106, label %151, label %188

151:                                              ; preds = %146
  %152 = icmp eq i32 %149, 0
  %153 = select i1 %152, i1 true, i1 %109
  br label %158

154:                                              ; preds = %184
  %155 = add nuw nsw i64 %161, 1
  %156 = icmp slt i64 %155, %105
  %157 = icmp eq i64 %155, %105
  br i1 %157, label %188, label %158, !llvm.loop !12

158:                                              ; preds = %151, %154
  %159 = phi i1 [ %106, %151 ], [ %156, %154 ]
  %160 = phi i64 [ %147, %151 ], [ %187, %154 ]
  %161 = phi i64 [ 0, %151 ], [ %155, %154 ]
  %162 = phi double [ 0.000000e+00, %151 ], [ %185, %154 ]
  %163 = getelementptr inbounds double, ptr %107, i64 %161
  %164 = load double, ptr %163, align 8
  %165 = tail call double @llvm.fabs.f64(double %164)
  %166 = fcmp une double %164, 0.000000e+00
  br i1 %166, label %167, label %184

167:                                              ; preds = %158
  br i1 %153, label %173, label %168

168:                                              ; preds = %167
  %169 = load ptr, ptr %111, align 8
  %170 = getelementptr inbounds double, ptr %169, i64 %161
  %171 = load double, ptr %170, align 8
  %172 = fcmp ogt double %171, 0.000000e+00
  br i1 %172, label %173, label %184

173:                                              ; preds = %168, %167
  %174 = getelementptr inbounds double, ptr %112, i64 %161
  %175 = load double, ptr %174, align 8
  %176 = getelementptr inbounds double, ptr %87, i64 %161
  %177 = load double, ptr %176, align 8
  %178 = fcmp ogt double %175, %177
  %179 = select i1 %178, double %175, double %177
  %180 = fmul double %179, 0x3CB0000000000000
  %181 = fdiv double %165, %180
  %182 = fcmp ogt double %181, %162
  %183 = select i1 %182, double %181, double %162
  br label %184

184:                                              ; preds = %173, %168, %158
  %185 = phi double [ %183, %173 ], [ %162, %168 ], [ %162, %158 ]
  %186 = fcmp ueq double %165, 0x7FF0000000000000
  %187 = select i1 %186, i64 6, i64 %160
  br i1 %186, label %188, label %154

188:                                              ; preds = %154, %184, %146
  %189 = phi i1 [ %106, %146 ], [ %156, %154 ], [ %159, %184 ]
  %190 = phi double [ 0.000000e+00, %146 ], [ %185, %184 ], [ %185, %154 ]
  %191 = phi i64 [ %147, %146 ], [ %187, %184 ], [ %187, %154 ]
  br i1 %189, label %306, label %192

192:                                              ; preds = %188
  %193 = icmp ne i32 %149, 0
  %194 = or i1 %113, %193
  %195 = or i1 %194, %115
  %196 = select i1 %194, double %150, double 0.000000e+00
  br i1 %195, label %250, label %197

197:                                              ; preds = %192, %245
  %198 = phi ptr [ %248, %245 ], [ %42, %192 ]
  %199 = phi double [ %246, %245 ], [ 0.000000e+00, %192 ]
  %200 = phi i64 [ %247, %245 ], [ 0, %192 ]
  br i1 %116, label %201, label %204

201:                                              ; preds = %197
  %202 = load ptr, ptr %117, align 8
  %203 = load ptr, ptr %118, align 8
  br label %207

204:                                              ; preds = %207, %197
  %205 = phi double [ 0.000000e+00, %197 ], [ %228, %207 ]
  %206 = fcmp ogt double %205, 0.000000e+00
  br i1 %206, label %231, label %245

207:                                              ; preds = %201, %207
  %208 = phi i64 [ 0, %201 ], [ %229, %207 ]
  %209 = phi double [ 0.000000e+00, %201 ], [ %228, %207 ]
  %210 = getelementptr inbounds double, ptr %198, i64 %208
  %211 = load double, ptr %210, align 8
  %212 = getelementptr inbounds double, ptr %3, i64 %208
  %213 = load double, ptr %212, align 8
  %214 = getelementptr inbounds double, ptr %2, i64 %208
  %215 = load double, ptr %214, align 8
  %216 = getelementptr inbounds double, ptr %202, i64 %208
  %217 = load double, ptr %216, align 8
  %218 = getelementptr inbounds double, ptr %203, i64 %208
  %219 = load double, ptr %218, align 8
  %220 = tail call double @llvm.fabs.f64(double %213)
  %221 = tail call double @llvm.fabs.f64(double %215)
  %222 = fcmp ogt double %220, %221
  %223 = select i1 %222, double %220, double %221
  %224 = fmul double %223, %219
  %225 = fadd double %217, %224
  %226 = fmul double %211, %225
  %227 = fmul double %226, %226
  %228 = fadd double %209, %227
  %229 = add nuw nsw i64 %208, 1
  %230 = icmp eq i64 %229, %19
  br i1 %230, label %204, label %207, !llvm.loop !13

231:                                              ; preds = %204
  %232 = getelementptr inbounds double, ptr %51, i64 %200
  %233 = load double, ptr %232, align 8
  %234 = fmul double %205, %121
  %235 = tail call double @llvm.sqrt.f64(double %234)
  %236 = fmul double %235, 3.000000e+00
  %237 = fmul double %119, %233
  %238 = fadd double %236, %237
  %239 = getelementptr inbounds double, ptr %94, i64 %200
  %240 = load double, ptr %239, align 8
  %241 = tail call double @llvm.fabs.f64(double %240)
  %242 = fdiv double %241, %238
  %243 = fcmp ogt double %242, %199
  %244 = select i1 %243, double %242, double %199
  br label %245

245:                                              ; preds = %231, %204
  %246 = phi double [ %244, %231 ], [ %199, %204 ]
  %247 = add nuw nsw i64 %200, 1
  %248 = getelementptr inbounds double, ptr %198, i64 %19
  %249 = icmp eq i64 %247, %105
  br i1 %249, label %250, label %197, !llvm.loop !14

250:                                              ; preds = %245, %192
  %251 = phi double [ %196, %192 ], [ %246, %245 ]
  %252 = fcmp ugt double %190, 1.000000e+00
  br i1 %252, label %253, label %306

253:                                              ; preds = %250
  %254 = fmul double %148, 5.000000e-01
  %255 = fcmp oge double %190, %254
  %256 = fcmp ole double %190, 8.000000e+00
  %257 = and i1 %255, %256
  br i1 %257, label %306, label %258

258:                                              ; preds = %253
  %259 = icmp eq i32 %149, 9
  br i1 %259, label %306, label %260

260:                                              ; preds = %258
  br i1 %122, label %261, label %279

261:                                              ; preds = %260
  %262 = load i64, ptr %123, align 8
  %263 = load i64, ptr %124, align 8
  %264 = mul nsw i64 %263, %262
  %265 = icmp sgt i64 %264, 0
  br i1 %265, label %266, label %277

266:                                              ; preds = %261, %266
  %267 = phi i64 [ %272, %266 ], [ 0, %261 ]
  %268 = getelementptr inbounds double, ptr %48, i64 %267
  %269 = load double, ptr %268, align 8
  %270 = load ptr, ptr %85, align 8
  %271 = getelementptr inbounds double, ptr %270, i64 %267
  store double %269, ptr %271, align 8
  %272 = add nuw nsw i64 %267, 1
  %273 = load i64, ptr %123, align 8
  %274 = load i64, ptr %124, align 8
  %275 = mul nsw i64 %274, %273
  %276 = icmp slt i64 %272, %275
  br i1 %276, label %266, label %277, !llvm.loop !15

277:                                              ; preds = %266, %261
  %278 = load ptr, ptr %85, align 8
  tail call fastcc void @factorise(ptr noundef %278, i64 noundef %68) #7
  br label %279

279:                                              ; preds = %260, %277
  %280 = load i64, ptr %126, align 8
  %281 = load i64, ptr %127, align 8
  %282 = mul nsw i64 %281, %280
  %283 = icmp sgt i64 %282, 0
  br i1 %283, label %284, label %295

284:                                              ; preds = %279, %284
  %285 = phi i64 [ %290, %284 ], [ 0, %279 ]
  %286 = getelementptr inbounds double, ptr %44, i64 %285
  %287 = load double, ptr %286, align 8
  %288 = load ptr, ptr %125, align 8
  %289 = getelementptr inbounds double, ptr %288, i64 %285
  store double %287, ptr %289, align 8
  %290 = add nuw nsw i64 %285, 1
  %291 = load i64, ptr %126, align 8
  %292 = load i64, ptr %127, align 8
  %293 = mul nsw i64 %292, %291
  %294 = icmp slt i64 %290, %293
  br i1 %294, label %284, label %295, !llvm.loop !15

295:                                              ; preds = %284, %279
  %296 = load ptr, ptr %128, align 8
  br i1 %129, label %297, label %305

297:                                              ; preds = %295, %297
  %298 = phi i64 [ %303, %297 ], [ 0, %295 ]
  %299 = getelementptr inbounds double, ptr %94, i64 %298
  %300 = load double, ptr %299, align 8
  %301 = fneg double %300
  %302 = getelementptr inbounds double, ptr %296, i64 %298
  store double %301, ptr %302, align 8
  %303 = add nuw nsw i64 %298, 1
  %304 = icmp eq i64 %303, %105
  br i1 %304, label %305, label %297, !llvm.loop !16

305:                                              ; preds = %297, %295
  call fastcc void @move_positions(ptr noundef nonnull %5, ptr noundef %2) #7
  br label %306

306:                                              ; preds = %305, %258, %253, %250, %188
  %307 = phi double [ %150, %188 ], [ %251, %253 ], [ %251, %258 ], [ %251, %305 ], [ %251, %250 ]
  %308 = phi i1 [ false, %188 ], [ false, %253 ], [ false, %258 ], [ true, %305 ], [ false, %250 ]
  %309 = phi double [ %148, %188 ], [ %148, %253 ], [ %148, %258 ], [ %190, %305 ], [ %148, %250 ]
  %310 = phi i64 [ %191, %188 ], [ 0, %253 ], [ 6, %258 ], [ %191, %305 ], [ 0, %250 ]
  br i1 %308, label %135, label %311

311:                                              ; preds = %306, %135, %90
  %312 = phi double [ 0.000000e+00, %90 ], [ %307, %135 ], [ %307, %306 ]
  %313 = phi i64 [ 6, %90 ], [ %310, %306 ], [ 6, %135 ]
  %314 = icmp eq i64 %313, 0
  br i1 %314, label %315, label %324

315:                                              ; preds = %311
  %316 = load i64, ptr %14, align 8
  %317 = icmp eq i64 %316, 0
  br i1 %317, label %324, label %318

318:                                              ; preds = %315
  %319 = icmp sgt i64 %316, 0
  br i1 %319, label %320, label %327

320:                                              ; preds = %318
  %321 = load ptr, ptr %32, align 8
  %322 = load i64, ptr %11, align 8
  %323 = getelementptr double, ptr %321, i64 %322
  br label %334

324:                                              ; preds = %315, %311
  %325 = fcmp ogt double %312, 1.000000e+00
  %326 = select i1 %325, i64 6, i64 %313
  br label %558

327:                                              ; preds = %334, %318
  %328 = phi double [ 0.000000e+00, %318 ], [ %340, %334 ]
  %329 = load i64, ptr %20, align 8
  %330 = mul nsw i64 %329, %316
  %331 = icmp sgt i64 %330, 0
  br i1 %331, label %332, label %343

332:                                              ; preds = %327
  %333 = load ptr, ptr %37, align 8
  br label %346

334:                                              ; preds = %320, %334
  %335 = phi i64 [ 0, %320 ], [ %341, %334 ]
  %336 = phi double [ 0.000000e+00, %320 ], [ %340, %334 ]
  %337 = getelementptr double, ptr %323, i64 %335
  %338 = load double, ptr %337, align 8
  %339 = fmul double %338, 0.000000e+00
  %340 = fadd double %336, %339
  %341 = add nuw nsw i64 %335, 1
  %342 = icmp eq i64 %341, %316
  br i1 %342, label %327, label %334, !llvm.loop !17

343:                                              ; preds = %346, %327
  %344 = phi double [ %328, %327 ], [ %352, %346 ]
  %345 = fcmp une double %344, 0.000000e+00
  br i1 %345, label %558, label %355

346:                                              ; preds = %332, %346
  %347 = phi i64 [ 0, %332 ], [ %353, %346 ]
  %348 = phi double [ %328, %332 ], [ %352, %346 ]
  %349 = getelementptr inbounds double, ptr %333, i64 %347
  %350 = load double, ptr %349, align 8
  %351 = fmul double %350, 0.000000e+00
  %352 = fadd double %348, %351
  %353 = add nuw nsw i64 %347, 1
  %354 = icmp eq i64 %353, %330
  br i1 %354, label %343, label %346, !llvm.loop !18

355:                                              ; preds = %343
  %356 = icmp eq ptr %3, null
  br i1 %356, label %434, label %357

357:                                              ; preds = %355
  %358 = load i64, ptr %17, align 8
  %359 = load ptr, ptr %32, align 8
  %360 = load i64, ptr %11, align 8
  %361 = getelementptr inbounds double, ptr %359, i64 %360
  %362 = icmp sgt i64 %316, 0
  br i1 %362, label %363, label %430

363:                                              ; preds = %357
  %364 = load i64, ptr %29, align 8
  %365 = icmp slt i64 %364, %316
  %366 = load ptr, ptr %37, align 8
  %367 = icmp sgt i64 %329, 0
  %368 = getelementptr inbounds i8, ptr %0, i64 552
  %369 = getelementptr inbounds i8, ptr %0, i64 528
  %370 = select i1 %365, double 1.000000e-05, double 0x3CE0000000000000
  %371 = add nsw i64 %358, %329
  %372 = sitofp i64 %371 to double
  br label %373

373:                                              ; preds = %363, %425
  %374 = phi ptr [ %366, %363 ], [ %428, %425 ]
  %375 = phi double [ 0.000000e+00, %363 ], [ %426, %425 ]
  %376 = phi i64 [ 0, %363 ], [ %427, %425 ]
  br i1 %367, label %377, label %380

377:                                              ; preds = %373
  %378 = load ptr, ptr %368, align 8
  %379 = load ptr, ptr %369, align 8
  br label %384

380:                                              ; preds = %384, %373
  %381 = phi double [ 0.000000e+00, %373 ], [ %407, %384 ]
  %382 = phi double [ 0.000000e+00, %373 ], [ %410, %384 ]
  %383 = fcmp ogt double %381, 0.000000e+00
  br i1 %383, label %413, label %425

384:                                              ; preds = %377, %384
  %385 = phi i64 [ 0, %377 ], [ %411, %384 ]
  %386 = phi double [ 0.000000e+00, %377 ], [ %410, %384 ]
  %387 = phi double [ 0.000000e+00, %377 ], [ %407, %384 ]
  %388 = getelementptr inbounds double, ptr %374, i64 %385
  %389 = load double, ptr %388, align 8
  %390 = add nsw i64 %385, %358
  %391 = getelementptr inbounds double, ptr %3, i64 %390
  %392 = load double, ptr %391, align 8
  %393 = getelementptr inbounds double, ptr %2, i64 %390
  %394 = load double, ptr %393, align 8
  %395 = getelementptr inbounds double, ptr %378, i64 %390
  %396 = load double, ptr %395, align 8
  %397 = getelementptr inbounds double, ptr %379, i64 %390
  %398 = load double, ptr %397, align 8
  %399 = tail call double @llvm.fabs.f64(double %392)
  %400 = tail call double @llvm.fabs.f64(double %394)
  %401 = fcmp ogt double %399, %400
  %402 = select i1 %401, double %399, double %400
  %403 = fmul double %402, %398
  %404 = fadd double %396, %403
  %405 = fmul double %389, %404
  %406 = fmul double %405, %405
  %407 = fadd double %387, %406
  %408 = fmul double %389, %394
  %409 = tail call double @llvm.fabs.f64(double %408)
  %410 = fadd double %386, %409
  %411 = add nuw nsw i64 %385, 1
  %412 = icmp eq i64 %411, %329
  br i1 %412, label %380, label %384, !llvm.loop !13

413:                                              ; preds = %380
  %414 = fmul double %381, %372
  %415 = tail call double @llvm.sqrt.f64(double %414)
  %416 = fmul double %415, 3.000000e+00
  %417 = fmul double %370, %382
  %418 = fadd double %417, %416
  %419 = getelementptr inbounds double, ptr %361, i64 %376
  %420 = load double, ptr %419, align 8
  %421 = tail call double @llvm.fabs.f64(double %420)
  %422 = fdiv double %421, %418
  %423 = fcmp ogt double %422, %375
  %424 = select i1 %423, double %422, double %375
  br label %425

425:                                              ; preds = %413, %380
  %426 = phi double [ %424, %413 ], [ %375, %380 ]
  %427 = add nuw nsw i64 %376, 1
  %428 = getelementptr inbounds double, ptr %374, i64 %329
  %429 = icmp eq i64 %427, %316
  br i1 %429, label %430, label %373, !llvm.loop !14

430:                                              ; preds = %425, %357
  %431 = phi double [ 0.000000e+00, %357 ], [ %426, %425 ]
  %432 = fcmp ogt double %431, %312
  %433 = select i1 %432, double %431, double %312
  br label %434

434:                                              ; preds = %430, %355
  %435 = phi double [ %312, %355 ], [ %433, %430 ]
  %436 = load i64, ptr %23, align 8
  %437 = icmp eq i64 %436, 1
  br i1 %437, label %438, label %462

438:                                              ; preds = %434
  %439 = load ptr, ptr %38, align 8
  %440 = load ptr, ptr %5, align 8
  %441 = getelementptr inbounds i8, ptr %440, i64 8
  %442 = getelementptr inbounds i8, ptr %440, i64 16
  %443 = load i64, ptr %441, align 8
  %444 = load i64, ptr %442, align 8
  %445 = mul nsw i64 %444, %443
  %446 = icmp sgt i64 %445, 0
  br i1 %446, label %447, label %458

447:                                              ; preds = %438, %447
  %448 = phi i64 [ %453, %447 ], [ 0, %438 ]
  %449 = getelementptr inbounds double, ptr %439, i64 %448
  %450 = load double, ptr %449, align 8
  %451 = load ptr, ptr %440, align 8
  %452 = getelementptr inbounds double, ptr %451, i64 %448
  store double %450, ptr %452, align 8
  %453 = add nuw nsw i64 %448, 1
  %454 = load i64, ptr %441, align 8
  %455 = load i64, ptr %442, align 8
  %456 = mul nsw i64 %455, %454
  %457 = icmp slt i64 %453, %456
  br i1 %457, label %447, label %458, !llvm.loop !15

458:                                              ; preds = %447, %438
  %459 = load ptr, ptr %5, align 8
  %460 = load ptr, ptr %459, align 8
  %461 = load i64, ptr %20, align 8
  tail call fastcc void @factorise(ptr noundef %460, i64 noundef %461) #7
  br label %462

462:                                              ; preds = %434, %458
  %463 = load ptr, ptr %32, align 8
  %464 = load i64, ptr %11, align 8
  %465 = getelementptr inbounds double, ptr %463, i64 %464
  %466 = load i64, ptr %14, align 8
  %467 = load ptr, ptr %5, align 8
  %468 = getelementptr inbounds i8, ptr %467, i64 144
  %469 = load ptr, ptr %468, align 8
  %470 = icmp sgt i64 %466, 0
  br i1 %470, label %471, label %479

471:                                              ; preds = %462, %471
  %472 = phi i64 [ %477, %471 ], [ 0, %462 ]
  %473 = getelementptr inbounds double, ptr %465, i64 %472
  %474 = load double, ptr %473, align 8
  %475 = fneg double %474
  %476 = getelementptr inbounds double, ptr %469, i64 %472
  store double %475, ptr %476, align 8
  %477 = add nuw nsw i64 %472, 1
  %478 = icmp eq i64 %477, %466
  br i1 %478, label %479, label %471, !llvm.loop !16

479:                                              ; preds = %471, %462
  call fastcc void @move_speeds(ptr noundef nonnull %5, ptr noundef %2) #7
  %480 = load ptr, ptr %53, align 8
  %481 = getelementptr inbounds i8, ptr %480, i64 8
  %482 = load i64, ptr %481, align 8
  %483 = load ptr, ptr %5, align 8
  %484 = getelementptr inbounds i8, ptr %483, i64 216
  %485 = load ptr, ptr %484, align 8
  %486 = getelementptr inbounds i8, ptr %483, i64 240
  %487 = load ptr, ptr %486, align 8
  %488 = load ptr, ptr %40, align 8
  %489 = getelementptr inbounds i8, ptr %488, i64 32
  %490 = getelementptr inbounds double, ptr %489, i64 %482
  %491 = load i64, ptr %14, align 8
  %492 = icmp sgt i64 %491, 0
  br i1 %492, label %500, label %495

493:                                              ; preds = %518
  %494 = sitofp i64 %520 to double
  br label %495

495:                                              ; preds = %493, %479
  %496 = phi double [ 1.000000e+00, %479 ], [ %519, %493 ]
  %497 = phi double [ 0.000000e+00, %479 ], [ %494, %493 ]
  %498 = load double, ptr %488, align 8
  %499 = fcmp olt double %498, %497
  br i1 %499, label %523, label %525

500:                                              ; preds = %479, %518
  %501 = phi i64 [ %521, %518 ], [ 0, %479 ]
  %502 = phi i64 [ %520, %518 ], [ 0, %479 ]
  %503 = phi double [ %519, %518 ], [ 1.000000e+00, %479 ]
  %504 = getelementptr inbounds double, ptr %485, i64 %501
  %505 = load double, ptr %504, align 8
  %506 = getelementptr inbounds double, ptr %490, i64 %501
  %507 = load double, ptr %506, align 8
  %508 = fcmp ogt double %505, %507
  %509 = select i1 %508, double %505, double %507
  store double %509, ptr %506, align 8
  %510 = getelementptr inbounds double, ptr %487, i64 %501
  %511 = load double, ptr %510, align 8
  %512 = fcmp ogt double %511, 0.000000e+00
  br i1 %512, label %513, label %518

513:                                              ; preds = %500
  %514 = add nsw i64 %502, 1
  %515 = fdiv double %511, %509
  %516 = fcmp olt double %515, %503
  %517 = select i1 %516, double %515, double %503
  br label %518

518:                                              ; preds = %513, %500
  %519 = phi double [ %517, %513 ], [ %503, %500 ]
  %520 = phi i64 [ %514, %513 ], [ %502, %500 ]
  %521 = add nuw nsw i64 %501, 1
  %522 = icmp eq i64 %521, %491
  br i1 %522, label %493, label %500, !llvm.loop !19

523:                                              ; preds = %495
  store double %497, ptr %488, align 8
  %524 = getelementptr inbounds i8, ptr %488, i64 8
  store double 1.000000e+00, ptr %524, align 8
  br label %528

525:                                              ; preds = %495
  %526 = fcmp ogt double %498, %497
  br i1 %526, label %527, label %528

527:                                              ; preds = %525
  br label %528

528:                                              ; preds = %527, %525, %523
  %529 = phi double [ %496, %523 ], [ 0.000000e+00, %527 ], [ %496, %525 ]
  %530 = getelementptr inbounds i8, ptr %488, i64 16
  %531 = load double, ptr %530, align 8
  %532 = fcmp olt double %529, %531
  %533 = select i1 %532, double %529, double %531
  store double %529, ptr %530, align 8
  %534 = fcmp ogt double %435, 1.000000e+00
  br i1 %534, label %535, label %541

535:                                              ; preds = %528
  %536 = fcmp ult double %533, 5.000000e-02
  br i1 %536, label %537, label %558

537:                                              ; preds = %535
  %538 = fmul double %435, %533
  %539 = fmul double %538, 5.000000e-02
  %540 = fcmp ogt double %539, 1.000000e+00
  br i1 %540, label %558, label %541

541:                                              ; preds = %537, %528
  %542 = getelementptr inbounds i8, ptr %488, i64 8
  %543 = load double, ptr %542, align 8
  %544 = fcmp olt double %529, %543
  %545 = fcmp ogt double %543, 1.000000e-05
  %546 = and i1 %544, %545
  br i1 %546, label %547, label %558

547:                                              ; preds = %541
  store double %529, ptr %542, align 8
  %548 = getelementptr inbounds i8, ptr %488, i64 24
  store double %1, ptr %548, align 8
  %549 = getelementptr inbounds i8, ptr %488, i64 32
  %550 = icmp sgt i64 %482, 0
  br i1 %550, label %551, label %558

551:                                              ; preds = %547, %551
  %552 = phi i64 [ %556, %551 ], [ 0, %547 ]
  %553 = getelementptr inbounds double, ptr %2, i64 %552
  %554 = load double, ptr %553, align 8
  %555 = getelementptr inbounds double, ptr %549, i64 %552
  store double %554, ptr %555, align 8
  %556 = add nuw nsw i64 %552, 1
  %557 = icmp eq i64 %556, %482
  br i1 %557, label %558, label %551, !llvm.loop !20

558:                                              ; preds = %551, %547, %541, %537, %535, %343, %324
  %559 = phi i64 [ %326, %324 ], [ 6, %343 ], [ 6, %537 ], [ 6, %535 ], [ 0, %541 ], [ 0, %547 ], [ 0, %551 ]
  ret i64 %559
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
