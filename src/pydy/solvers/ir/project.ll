; sources e4100f3604c2e0c357805a29a53177c027d42c61a6f0da079276377a198afce4
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
  br i1 %60, label %61, label %65

61:                                               ; preds = %53, %88
  %62 = phi i64 [ %89, %88 ], [ 0, %53 ]
  %63 = mul nuw nsw i64 %62, %21
  %64 = getelementptr double, ptr %59, i64 %63
  br label %91

65:                                               ; preds = %88, %53
  %66 = getelementptr inbounds i8, ptr %0, i64 168
  %67 = getelementptr inbounds i8, ptr %0, i64 192
  %68 = getelementptr inbounds i8, ptr %0, i64 672
  %69 = load ptr, ptr %5, align 8
  %70 = getelementptr inbounds i8, ptr %69, i64 8
  %71 = load i64, ptr %70, align 8
  %72 = load ptr, ptr %66, align 8
  %73 = load ptr, ptr %67, align 8
  %74 = load ptr, ptr %68, align 8
  %75 = inttoptr i64 %71 to ptr
  %76 = tail call i32 %75(ptr noundef %72, ptr noundef %2, ptr noundef %73, ptr noundef %74, ptr noundef %27) #8
  %77 = icmp slt i32 %76, 0
  br i1 %77, label %199, label %78

78:                                               ; preds = %65
  %79 = icmp sgt i64 %12, 0
  %80 = icmp eq i64 %24, 1
  %81 = getelementptr inbounds i8, ptr %9, i64 8
  %82 = getelementptr inbounds i8, ptr %9, i64 16
  %83 = getelementptr inbounds i8, ptr %9, i64 24
  %84 = getelementptr inbounds i8, ptr %9, i64 32
  %85 = getelementptr inbounds i8, ptr %9, i64 40
  %86 = getelementptr inbounds i8, ptr %9, i64 144
  %87 = icmp sgt i64 %12, 0
  br label %109

88:                                               ; preds = %91
  %89 = add nuw nsw i64 %62, 1
  %90 = icmp eq i64 %89, %21
  br i1 %90, label %65, label %61, !llvm.loop !6

91:                                               ; preds = %61, %91
  %92 = phi i64 [ 0, %61 ], [ %96, %91 ]
  %93 = icmp eq i64 %62, %92
  %94 = select i1 %93, double 1.000000e+00, double 0.000000e+00
  %95 = getelementptr double, ptr %64, i64 %92
  store double %94, ptr %95, align 8
  %96 = add nuw nsw i64 %92, 1
  %97 = icmp eq i64 %96, %21
  br i1 %97, label %88, label %91, !llvm.loop !9

98:                                               ; preds = %195
  %99 = add nuw nsw i32 %110, 1
  %100 = load ptr, ptr %5, align 8
  %101 = getelementptr inbounds i8, ptr %100, i64 8
  %102 = load i64, ptr %101, align 8
  %103 = load ptr, ptr %66, align 8
  %104 = load ptr, ptr %67, align 8
  %105 = load ptr, ptr %68, align 8
  %106 = inttoptr i64 %102 to ptr
  %107 = tail call i32 %106(ptr noundef %103, ptr noundef %2, ptr noundef %104, ptr noundef %105, ptr noundef %27) #8
  %108 = icmp slt i32 %107, 0
  br i1 %108, label %199, label %109, !llvm.loop !10

109:                                              ; preds = %78, %98
  %110 = phi i32 [ 0, %78 ], [ %99, %98 ]
  %111 = phi double [ 0x7FF0000000000000, %78 ], [ %197, %98 ]
  %112 = phi i64 [ undef, %78 ], [ %196, %98 ]
  br i1 %79, label %117, label %136

113:                                              ; preds = %132
  %114 = add nuw nsw i64 %119, 1
  %115 = icmp slt i64 %114, %12
  %116 = icmp eq i64 %114, %12
  br i1 %116, label %136, label %117, !llvm.loop !11

117:                                              ; preds = %109, %113
  %118 = phi i1 [ %115, %113 ], [ %79, %109 ]
  %119 = phi i64 [ %114, %113 ], [ 0, %109 ]
  %120 = phi double [ %133, %113 ], [ 0.000000e+00, %109 ]
  %121 = getelementptr inbounds double, ptr %27, i64 %119
  %122 = load double, ptr %121, align 8
  %123 = fcmp une double %122, 0.000000e+00
  br i1 %123, label %124, label %132

124:                                              ; preds = %117
  %125 = tail call double @llvm.fabs.f64(double %122)
  %126 = getelementptr inbounds double, ptr %44, i64 %119
  %127 = load double, ptr %126, align 8
  %128 = fmul double %127, 0x3CB0000000000000
  %129 = fdiv double %125, %128
  %130 = fcmp ogt double %129, %120
  %131 = select i1 %130, double %129, double %120
  br label %132

132:                                              ; preds = %124, %117
  %133 = phi double [ %131, %124 ], [ %120, %117 ]
  %134 = tail call double @llvm.fabs.f64(double %122)
  %135 = fcmp ueq double %134, 0x7FF0000000000000
  br i1 %135, label %136, label %113

136:                                              ; preds = %113, %132, %109
  %137 = phi i1 [ %79, %109 ], [ %115, %113 ], [ %118, %132 ]
  %138 = phi i64 [ %112, %109 ], [ %112, %113 ], [ 6, %132 ]
  %139 = phi double [ 0.000000e+00, %109 ], [ %133, %132 ], [ %133, %113 ]
  br i1 %137, label %195, label %140

140:                                              ; preds = %136
  %141 = fcmp ugt double %139, 1.000000e+00
  br i1 %141, label %142, label %195

142:                                              ; preds = %140
  %143 = fmul double %111, 5.000000e-01
  %144 = fcmp oge double %139, %143
  %145 = fcmp ole double %139, 8.000000e+00
  %146 = and i1 %144, %145
  br i1 %146, label %195, label %147

147:                                              ; preds = %142
  %148 = icmp eq i32 %110, 9
  br i1 %148, label %195, label %149

149:                                              ; preds = %147
  br i1 %80, label %150, label %168

150:                                              ; preds = %149
  %151 = load i64, ptr %81, align 8
  %152 = load i64, ptr %82, align 8
  %153 = mul nsw i64 %152, %151
  %154 = icmp sgt i64 %153, 0
  br i1 %154, label %155, label %166

155:                                              ; preds = %150, %155
  %156 = phi i64 [ %161, %155 ], [ 0, %150 ]
  %157 = getelementptr inbounds double, ptr %41, i64 %156
  %158 = load double, ptr %157, align 8
  %159 = load ptr, ptr %9, align 8
  %160 = getelementptr inbounds double, ptr %159, i64 %156
  store double %158, ptr %160, align 8
  %161 = add nuw nsw i64 %156, 1
  %162 = load i64, ptr %81, align 8
  %163 = load i64, ptr %82, align 8
  %164 = mul nsw i64 %163, %162
  %165 = icmp slt i64 %161, %164
  br i1 %165, label %155, label %166, !llvm.loop !12

166:                                              ; preds = %155, %150
  %167 = load ptr, ptr %9, align 8
  tail call fastcc void @factorise(ptr noundef %167, i64 noundef %21) #7
  br label %168

168:                                              ; preds = %149, %166
  %169 = load i64, ptr %84, align 8
  %170 = load i64, ptr %85, align 8
  %171 = mul nsw i64 %170, %169
  %172 = icmp sgt i64 %171, 0
  br i1 %172, label %173, label %184

173:                                              ; preds = %168, %173
  %174 = phi i64 [ %179, %173 ], [ 0, %168 ]
  %175 = getelementptr inbounds double, ptr %37, i64 %174
  %176 = load double, ptr %175, align 8
  %177 = load ptr, ptr %83, align 8
  %178 = getelementptr inbounds double, ptr %177, i64 %174
  store double %176, ptr %178, align 8
  %179 = add nuw nsw i64 %174, 1
  %180 = load i64, ptr %84, align 8
  %181 = load i64, ptr %85, align 8
  %182 = mul nsw i64 %181, %180
  %183 = icmp slt i64 %179, %182
  br i1 %183, label %173, label %184, !llvm.loop !12

184:                                              ; preds = %173, %168
  %185 = load ptr, ptr %86, align 8
  br i1 %87, label %186, label %194

186:                                              ; preds = %184, %186
  %187 = phi i64 [ %192, %186 ], [ 0, %184 ]
  %188 = getelementptr inbounds double, ptr %27, i64 %187
  %189 = load double, ptr %188, align 8
  %190 = fneg double %189
  %191 = getelementptr inbounds double, ptr %185, i64 %187
  store double %190, ptr %191, align 8
  %192 = add nuw nsw i64 %187, 1
  %193 = icmp eq i64 %192, %12
  br i1 %193, label %194, label %186, !llvm.loop !13

194:                                              ; preds = %186, %184
  call fastcc void @move_positions(ptr noundef nonnull %4, ptr noundef %2) #7
  br label %195

195:                                              ; preds = %194, %147, %142, %140, %136
  %196 = phi i64 [ %138, %194 ], [ %138, %136 ], [ 0, %142 ], [ 0, %140 ], [ 6, %147 ]
  %197 = phi double [ %139, %194 ], [ %111, %136 ], [ %111, %142 ], [ %111, %140 ], [ %111, %147 ]
  %198 = phi i1 [ true, %194 ], [ false, %136 ], [ false, %142 ], [ false, %140 ], [ false, %147 ]
  br i1 %198, label %98, label %199

199:                                              ; preds = %195, %98, %65
  %200 = phi i64 [ 6, %65 ], [ %196, %195 ], [ 6, %98 ]
  %201 = icmp ne i64 %200, 0
  %202 = icmp eq i64 %15, 0
  %203 = select i1 %201, i1 true, i1 %202
  br i1 %203, label %328, label %204

204:                                              ; preds = %199
  %205 = icmp sgt i64 %15, 0
  br i1 %205, label %209, label %206

206:                                              ; preds = %209, %204
  %207 = phi double [ 0.000000e+00, %204 ], [ %215, %209 ]
  %208 = icmp sgt i64 %40, 0
  br i1 %208, label %221, label %218

209:                                              ; preds = %204, %209
  %210 = phi i64 [ %216, %209 ], [ 0, %204 ]
  %211 = phi double [ %215, %209 ], [ 0.000000e+00, %204 ]
  %212 = getelementptr double, ptr %34, i64 %210
  %213 = load double, ptr %212, align 8
  %214 = fmul double %213, 0.000000e+00
  %215 = fadd double %211, %214
  %216 = add nuw nsw i64 %210, 1
  %217 = icmp eq i64 %216, %15
  br i1 %217, label %206, label %209, !llvm.loop !14

218:                                              ; preds = %221, %206
  %219 = phi double [ %207, %206 ], [ %227, %221 ]
  %220 = fcmp une double %219, 0.000000e+00
  br i1 %220, label %328, label %230

221:                                              ; preds = %206, %221
  %222 = phi i64 [ %228, %221 ], [ 0, %206 ]
  %223 = phi double [ %227, %221 ], [ %207, %206 ]
  %224 = getelementptr inbounds double, ptr %39, i64 %222
  %225 = load double, ptr %224, align 8
  %226 = fmul double %225, 0.000000e+00
  %227 = fadd double %223, %226
  %228 = add nuw nsw i64 %222, 1
  %229 = icmp eq i64 %228, %40
  br i1 %229, label %218, label %221, !llvm.loop !15

230:                                              ; preds = %218
  %231 = icmp eq i64 %24, 1
  br i1 %231, label %232, label %252

232:                                              ; preds = %230
  %233 = getelementptr inbounds i8, ptr %9, i64 8
  %234 = getelementptr inbounds i8, ptr %9, i64 16
  %235 = load i64, ptr %233, align 8
  %236 = load i64, ptr %234, align 8
  %237 = mul nsw i64 %236, %235
  %238 = icmp sgt i64 %237, 0
  br i1 %238, label %239, label %250

239:                                              ; preds = %232, %239
  %240 = phi i64 [ %245, %239 ], [ 0, %232 ]
  %241 = getelementptr inbounds double, ptr %41, i64 %240
  %242 = load double, ptr %241, align 8
  %243 = load ptr, ptr %9, align 8
  %244 = getelementptr inbounds double, ptr %243, i64 %240
  store double %242, ptr %244, align 8
  %245 = add nuw nsw i64 %240, 1
  %246 = load i64, ptr %233, align 8
  %247 = load i64, ptr %234, align 8
  %248 = mul nsw i64 %247, %246
  %249 = icmp slt i64 %245, %248
  br i1 %249, label %239, label %250, !llvm.loop !12

250:                                              ; preds = %239, %232
  %251 = load ptr, ptr %9, align 8
  tail call fastcc void @factorise(ptr noundef %251, i64 noundef %21) #7
  br label %252

252:                                              ; preds = %230, %250
  %253 = getelementptr inbounds i8, ptr %9, i64 144
  %254 = load ptr, ptr %253, align 8
  %255 = icmp sgt i64 %15, 0
  br i1 %255, label %256, label %264

256:                                              ; preds = %252, %256
  %257 = phi i64 [ %262, %256 ], [ 0, %252 ]
  %258 = getelementptr inbounds double, ptr %34, i64 %257
  %259 = load double, ptr %258, align 8
  %260 = fneg double %259
  %261 = getelementptr inbounds double, ptr %254, i64 %257
  store double %260, ptr %261, align 8
  %262 = add nuw nsw i64 %257, 1
  %263 = icmp eq i64 %262, %15
  br i1 %263, label %264, label %256, !llvm.loop !13

264:                                              ; preds = %256, %252
  call fastcc void @move_speeds(ptr noundef nonnull %4, ptr noundef %2) #7
  %265 = load ptr, ptr %46, align 8
  %266 = getelementptr inbounds i8, ptr %265, i64 8
  %267 = load i64, ptr %266, align 8
  %268 = getelementptr inbounds i8, ptr %9, i64 216
  %269 = load ptr, ptr %268, align 8
  %270 = getelementptr inbounds i8, ptr %9, i64 240
  %271 = load ptr, ptr %270, align 8
  %272 = getelementptr inbounds i8, ptr %45, i64 24
  %273 = getelementptr inbounds double, ptr %272, i64 %267
  %274 = icmp sgt i64 %15, 0
  br i1 %274, label %282, label %277

275:                                              ; preds = %300
  %276 = sitofp i64 %302 to double
  br label %277

277:                                              ; preds = %275, %264
  %278 = phi double [ 1.000000e+00, %264 ], [ %301, %275 ]
  %279 = phi double [ 0.000000e+00, %264 ], [ %276, %275 ]
  %280 = load double, ptr %45, align 8
  %281 = fcmp olt double %280, %279
  br i1 %281, label %305, label %307

282:                                              ; preds = %264, %300
  %283 = phi i64 [ %303, %300 ], [ 0, %264 ]
  %284 = phi i64 [ %302, %300 ], [ 0, %264 ]
  %285 = phi double [ %301, %300 ], [ 1.000000e+00, %264 ]
  %286 = getelementptr inbounds double, ptr %269, i64 %283
  %287 = load double, ptr %286, align 8
  %288 = getelementptr inbounds double, ptr %273, i64 %283
  %289 = load double, ptr %288, align 8
  %290 = fcmp ogt double %287, %289
  %291 = select i1 %290, double %287, double %289
  store double %291, ptr %288, align 8
  %292 = getelementptr inbounds double, ptr %271, i64 %283
  %293 = load double, ptr %292, align 8
  %294 = fcmp ogt double %293, 0.000000e+00
  br i1 %294, label %295, label %300

295:                                              ; preds = %282
  %296 = add nsw i64 %284, 1
  %297 = fdiv double %293, %291
  %298 = fcmp olt double %297, %285
  %299 = select i1 %298, double %297, double %285
  br label %300

300:                                              ; preds = %295, %282
  %301 = phi double [ %299, %295 ], [ %285, %282 ]
  %302 = phi i64 [ %296, %295 ], [ %284, %282 ]
  %303 = add nuw nsw i64 %283, 1
  %304 = icmp eq i64 %303, %15
  br i1 %304, label %275, label %282, !llvm.loop !16

305:                                              ; preds = %277
  store double %279, ptr %45, align 8
  %306 = getelementptr inbounds i8, ptr %45, i64 8
  store double 1.000000e+00, ptr %306, align 8
  br label %310

307:                                              ; preds = %277
  %308 = fcmp ogt double %280, %279
  br i1 %308, label %309, label %310

309:                                              ; preds = %307
  br label %310

310:                                              ; preds = %309, %307, %305
  %311 = phi double [ %278, %305 ], [ 0.000000e+00, %309 ], [ %278, %307 ]
  %312 = getelementptr inbounds i8, ptr %45, i64 8
  %313 = load double, ptr %312, align 8
  %314 = fcmp olt double %311, %313
  %315 = fcmp ogt double %313, 1.000000e-05
  %316 = and i1 %314, %315
  br i1 %316, label %317, label %328

317:                                              ; preds = %310
  store double %311, ptr %312, align 8
  %318 = getelementptr inbounds i8, ptr %45, i64 16
  store double %1, ptr %318, align 8
  %319 = getelementptr inbounds i8, ptr %45, i64 24
  %320 = icmp sgt i64 %267, 0
  br i1 %320, label %321, label %328

321:                                              ; preds = %317, %321
  %322 = phi i64 [ %326, %321 ], [ 0, %317 ]
  %323 = getelementptr inbounds double, ptr %2, i64 %322
  %324 = load double, ptr %323, align 8
  %325 = getelementptr inbounds double, ptr %319, i64 %322
  store double %324, ptr %325, align 8
  %326 = add nuw nsw i64 %322, 1
  %327 = icmp eq i64 %326, %267
  br i1 %327, label %328, label %321, !llvm.loop !17

328:                                              ; preds = %321, %317, %310, %218, %199
  %329 = phi i64 [ %200, %199 ], [ 6, %218 ], [ 0, %310 ], [ 0, %317 ], [ 0, %321 ]
  ret i64 %329
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
  br i1 %23, label %13, label %24, !llvm.loop !12

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
  br i1 %52, label %40, label %39, !llvm.loop !18
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
  br i1 %55, label %44, label %56, !llvm.loop !19

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
  br i1 %83, label %13, label %12, !llvm.loop !20
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
  br i1 %23, label %13, label %24, !llvm.loop !12

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
  %34 = load ptr, ptr %3, align 8
  %35 = load i64, ptr %32, align 8
  %36 = getelementptr inbounds i8, ptr %3, i64 120
  %37 = load ptr, ptr %36, align 8
  tail call fastcc void @divide_transposed(ptr noundef %34, i64 noundef %35, ptr noundef %37) #7
  %38 = getelementptr inbounds i8, ptr %0, i64 24
  %39 = load i64, ptr %38, align 8
  %40 = icmp sgt i64 %39, 0
  br i1 %40, label %41, label %47

41:                                               ; preds = %24, %54
  %42 = phi i64 [ %55, %54 ], [ 0, %24 ]
  %43 = load i64, ptr %32, align 8
  %44 = icmp sgt i64 %43, 0
  br i1 %44, label %45, label %54

45:                                               ; preds = %41
  %46 = getelementptr inbounds double, ptr %1, i64 %42
  br label %58

47:                                               ; preds = %54, %24
  %48 = getelementptr inbounds i8, ptr %0, i64 24
  %49 = load i64, ptr %29, align 8
  %50 = icmp sgt i64 %49, 0
  br i1 %50, label %51, label %101

51:                                               ; preds = %47
  %52 = getelementptr inbounds i8, ptr %3, i64 144
  %53 = load ptr, ptr %52, align 8
  br label %77

54:                                               ; preds = %58, %41
  %55 = add nuw nsw i64 %42, 1
  %56 = load i64, ptr %38, align 8
  %57 = icmp slt i64 %55, %56
  br i1 %57, label %41, label %47, !llvm.loop !21

58:                                               ; preds = %45, %58
  %59 = phi i64 [ %43, %45 ], [ %73, %58 ]
  %60 = phi i64 [ 0, %45 ], [ %72, %58 ]
  %61 = load ptr, ptr %25, align 8
  %62 = mul nsw i64 %59, %42
  %63 = getelementptr double, ptr %61, i64 %62
  %64 = getelementptr double, ptr %63, i64 %60
  %65 = load double, ptr %64, align 8
  %66 = load ptr, ptr %36, align 8
  %67 = getelementptr inbounds double, ptr %66, i64 %60
  %68 = load double, ptr %67, align 8
  %69 = fmul double %65, %68
  %70 = load double, ptr %46, align 8
  %71 = fadd double %70, %69
  store double %71, ptr %46, align 8
  %72 = add nuw nsw i64 %60, 1
  %73 = load i64, ptr %32, align 8
  %74 = icmp slt i64 %72, %73
  br i1 %74, label %58, label %54, !llvm.loop !22

75:                                               ; preds = %77
  %76 = fcmp ogt double %84, 0.000000e+00
  br i1 %76, label %87, label %101

77:                                               ; preds = %51, %77
  %78 = phi i64 [ 0, %51 ], [ %85, %77 ]
  %79 = phi double [ 0.000000e+00, %51 ], [ %84, %77 ]
  %80 = getelementptr inbounds double, ptr %53, i64 %78
  %81 = load double, ptr %80, align 8
  %82 = tail call double @llvm.fabs.f64(double %81)
  %83 = fcmp ogt double %82, %79
  %84 = select i1 %83, double %82, double %79
  %85 = add nuw nsw i64 %78, 1
  %86 = icmp eq i64 %85, %49
  br i1 %86, label %75, label %77, !llvm.loop !23

87:                                               ; preds = %75
  tail call fastcc void @minimum_norm(ptr noundef nonnull %6, ptr noundef nonnull %3) #7
  %88 = load i64, ptr %48, align 8
  %89 = icmp sgt i64 %88, 0
  br i1 %89, label %90, label %101

90:                                               ; preds = %87, %90
  %91 = phi i64 [ %98, %90 ], [ 0, %87 ]
  %92 = load ptr, ptr %36, align 8
  %93 = getelementptr inbounds double, ptr %92, i64 %91
  %94 = load double, ptr %93, align 8
  %95 = getelementptr inbounds double, ptr %1, i64 %91
  %96 = load double, ptr %95, align 8
  %97 = fadd double %94, %96
  store double %97, ptr %95, align 8
  %98 = add nuw nsw i64 %91, 1
  %99 = load i64, ptr %48, align 8
  %100 = icmp slt i64 %98, %99
  br i1 %100, label %90, label %101, !llvm.loop !24

101:                                              ; preds = %90, %47, %87, %75
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
  br i1 %32, label %17, label %23, !llvm.loop !25

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
  br i1 %44, label %29, label %24, !llvm.loop !26

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
  br i1 %59, label %33, label %45, !llvm.loop !27
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
  br i1 %17, label %14, label %9, !llvm.loop !28

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
  br i1 %33, label %15, label %18, !llvm.loop !29

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
  br i1 %44, label %26, label %34, !llvm.loop !30
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
  br i1 %30, label %21, label %26, !llvm.loop !31

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
  br i1 %50, label %51, label %42, !llvm.loop !32

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
  br i1 %71, label %72, label %64, !llvm.loop !33

72:                                               ; preds = %64, %58, %51
  %73 = add nuw nsw i64 %39, 1
  %74 = icmp eq i64 %73, %4
  br i1 %74, label %31, label %38, !llvm.loop !34

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
  br i1 %97, label %98, label %89, !llvm.loop !32

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
  br i1 %107, label %77, label %79, !llvm.loop !35

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
  br i1 %130, label %131, label %120, !llvm.loop !36

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
  br i1 %150, label %151, label %140, !llvm.loop !32

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
  br i1 %166, label %167, label %157, !llvm.loop !37

167:                                              ; preds = %157, %151, %132
  %168 = add nuw nsw i64 %133, 1
  %169 = icmp eq i64 %168, %4
  br i1 %169, label %170, label %132, !llvm.loop !38

170:                                              ; preds = %167
  %171 = add nuw nsw i64 %76, 1
  %172 = icmp eq i64 %171, %4
  br i1 %172, label %173, label %75, !llvm.loop !39

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
  br i1 %184, label %175, label %176, !llvm.loop !40
}

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
  br i1 %21, label %8, label %7, !llvm.loop !41

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
  br i1 %33, label %15, label %22, !llvm.loop !42
}

declare double @llvm.sqrt.f64(double) #3

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
  br i1 %27, label %15, label %19, !llvm.loop !43

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
  br i1 %59, label %48, label %71, !llvm.loop !44

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
  br i1 %70, label %54, label %60, !llvm.loop !45

71:                                               ; preds = %54, %32, %42
  %72 = add nuw nsw i64 %9, 1
  %73 = icmp eq i64 %72, %1
  %74 = select i1 %18, i1 true, i1 %73
  br i1 %74, label %75, label %8, !llvm.loop !46

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
!10 = distinct !{!10, !8}
!11 = distinct !{!11, !7, !8}
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
