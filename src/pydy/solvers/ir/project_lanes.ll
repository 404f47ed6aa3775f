; sources be3b467160f45cf8666a74c3f308bda46ec376ab16c4d1a59327d42d620ffbf4
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Held = type { ptr, i64, i64, i64, i64, i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

define i64 @project_lanes(ptr noundef readonly %0, ptr noundef readonly %1, ptr noundef %2, ptr noundef readonly %3, i64 noundef %4) #0 {
  %6 = alloca %struct.Held, align 8
  %7 = load <8 x double>, ptr %1, align 8
  tail call void @llvm.experimental.noalias.scope.decl(metadata !3)
  %8 = getelementptr inbounds i8, ptr %0, i64 1656
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %9, i64 64
  %11 = load i64, ptr %10, align 8, !noalias !3
  %12 = inttoptr i64 %11 to ptr
  store ptr %12, ptr %6, align 8, !alias.scope !3
  %13 = getelementptr inbounds i8, ptr %6, i64 8
  %14 = getelementptr inbounds i8, ptr %9, i64 16
  %15 = load i64, ptr %14, align 8, !noalias !3
  store i64 %15, ptr %13, align 8, !alias.scope !3
  %16 = getelementptr inbounds i8, ptr %6, i64 16
  %17 = getelementptr inbounds i8, ptr %9, i64 24
  %18 = load i64, ptr %17, align 8, !noalias !3
  store i64 %18, ptr %16, align 8, !alias.scope !3
  %19 = getelementptr inbounds i8, ptr %6, i64 24
  %20 = getelementptr inbounds i8, ptr %9, i64 32
  %21 = load i64, ptr %20, align 8, !noalias !3
  store i64 %21, ptr %19, align 8, !alias.scope !3
  %22 = getelementptr inbounds i8, ptr %6, i64 32
  %23 = getelementptr inbounds i8, ptr %9, i64 40
  %24 = load i64, ptr %23, align 8, !noalias !3
  store i64 %24, ptr %22, align 8, !alias.scope !3
  %25 = getelementptr inbounds i8, ptr %6, i64 40
  %26 = getelementptr inbounds i8, ptr %9, i64 48
  %27 = load i64, ptr %26, align 8, !noalias !3
  store i64 %27, ptr %25, align 8, !alias.scope !3
  %28 = getelementptr inbounds i8, ptr %6, i64 48
  %29 = getelementptr inbounds i8, ptr %9, i64 80
  %30 = load i64, ptr %29, align 8, !noalias !3
  store i64 %30, ptr %28, align 8, !alias.scope !3
  %31 = getelementptr inbounds i8, ptr %6, i64 56
  %32 = getelementptr inbounds i8, ptr %9, i64 88
  %33 = load i64, ptr %32, align 8, !noalias !3
  store i64 %33, ptr %31, align 8, !alias.scope !3
  %34 = getelementptr inbounds i8, ptr %6, i64 64
  store i64 %4, ptr %34, align 8, !alias.scope !3
  %35 = getelementptr inbounds i8, ptr %6, i64 72
  %36 = getelementptr inbounds i8, ptr %0, i64 1704
  %37 = load ptr, ptr %36, align 8, !noalias !3
  store ptr %37, ptr %35, align 8, !alias.scope !3
  %38 = getelementptr inbounds i8, ptr %6, i64 80
  store ptr null, ptr %38, align 8, !alias.scope !3
  %39 = getelementptr inbounds i8, ptr %6, i64 88
  store ptr null, ptr %39, align 8, !alias.scope !3
  %40 = getelementptr inbounds i8, ptr %6, i64 96
  store ptr null, ptr %40, align 8, !alias.scope !3
  %41 = getelementptr inbounds i8, ptr %6, i64 104
  store ptr null, ptr %41, align 8, !alias.scope !3
  %42 = getelementptr inbounds i8, ptr %6, i64 112
  store ptr null, ptr %42, align 8, !alias.scope !3
  %43 = getelementptr inbounds i8, ptr %6, i64 120
  store ptr null, ptr %43, align 8, !alias.scope !3
  %44 = add nsw i64 %18, %15
  %45 = shl nsw i64 %44, 6
  %46 = getelementptr inbounds i8, ptr %37, i64 %45
  store ptr %46, ptr %38, align 8, !alias.scope !3
  %47 = shl nsw i64 %15, 3
  %48 = mul nsw i64 %47, %21
  %49 = getelementptr inbounds double, ptr %46, i64 %48
  store ptr %49, ptr %39, align 8, !alias.scope !3
  %50 = shl nsw i64 %21, 3
  %51 = mul nsw i64 %50, %24
  %52 = getelementptr inbounds double, ptr %49, i64 %51
  store ptr %52, ptr %40, align 8, !alias.scope !3
  %53 = shl nsw i64 %18, 3
  %54 = mul nsw i64 %53, %24
  %55 = getelementptr inbounds double, ptr %52, i64 %54
  store ptr %55, ptr %41, align 8, !alias.scope !3
  %56 = shl i64 %24, 3
  %57 = mul i64 %56, %24
  %58 = mul i64 %57, %27
  %59 = getelementptr inbounds double, ptr %55, i64 %58
  store ptr %59, ptr %42, align 8, !alias.scope !3
  %60 = shl nsw i64 %15, 6
  %61 = getelementptr inbounds i8, ptr %59, i64 %60
  store ptr %61, ptr %43, align 8, !alias.scope !3
  %62 = getelementptr inbounds i8, ptr %9, i64 96
  %63 = load i64, ptr %62, align 8
  %64 = icmp eq i64 %63, 0
  %65 = select i1 %64, ptr null, ptr %3
  %66 = getelementptr inbounds i8, ptr %0, i64 144
  %67 = getelementptr inbounds i8, ptr %0, i64 168
  %68 = load ptr, ptr %67, align 8
  store <8 x double> %7, ptr %68, align 8
  %69 = getelementptr inbounds i8, ptr %0, i64 296
  %70 = load i64, ptr %69, align 8
  %71 = icmp sgt i64 %70, 0
  br i1 %71, label %72, label %73

72:                                               ; preds = %5
  tail call fastcc void @sample(ptr noundef nonnull %66) #8
  br label %73

73:                                               ; preds = %5, %72
  %74 = load ptr, ptr %6, align 8
  %75 = load ptr, ptr %74, align 8
  %76 = load i64, ptr %22, align 8
  %77 = icmp sgt i64 %76, 0
  br i1 %77, label %78, label %95

78:                                               ; preds = %73, %81
  %79 = phi i64 [ %82, %81 ], [ 0, %73 ]
  %80 = mul nuw nsw i64 %79, %76
  br label %84

81:                                               ; preds = %84
  %82 = add nuw nsw i64 %79, 1
  %83 = icmp eq i64 %82, %76
  br i1 %83, label %95, label %78, !llvm.loop !6

84:                                               ; preds = %78, %84
  %85 = phi i64 [ 0, %78 ], [ %93, %84 ]
  %86 = add nuw nsw i64 %85, %80
  %87 = icmp eq i64 %79, %85
  %88 = select i1 %87, double 1.000000e+00, double 0.000000e+00
  %89 = insertelement <8 x double> poison, double %88, i64 0
  %90 = shufflevector <8 x double> %89, <8 x double> poison, <8 x i32> zeroinitializer
  %91 = shl nsw i64 %86, 6
  %92 = getelementptr inbounds i8, ptr %75, i64 %91
  store <8 x double> %90, ptr %92, align 8
  %93 = add nuw nsw i64 %85, 1
  %94 = icmp eq i64 %93, %76
  br i1 %94, label %81, label %84, !llvm.loop !9

95:                                               ; preds = %81, %73
  %96 = load i64, ptr %34, align 8
  %97 = load ptr, ptr %6, align 8
  %98 = getelementptr inbounds i8, ptr %97, i64 240
  %99 = load ptr, ptr %98, align 8
  %100 = load i64, ptr %13, align 8
  %101 = icmp sgt i64 %100, 0
  br i1 %101, label %152, label %102

102:                                              ; preds = %152, %95
  %103 = getelementptr inbounds i8, ptr %0, i64 168
  %104 = getelementptr inbounds i8, ptr %0, i64 192
  %105 = getelementptr inbounds i8, ptr %0, i64 1680
  %106 = load ptr, ptr %35, align 8
  %107 = load i64, ptr %34, align 8
  %108 = load ptr, ptr %8, align 8
  %109 = getelementptr inbounds i8, ptr %108, i64 8
  %110 = load i64, ptr %109, align 8
  %111 = load ptr, ptr %103, align 8
  %112 = load ptr, ptr %104, align 8
  %113 = load ptr, ptr %105, align 8
  %114 = inttoptr i64 %110 to ptr
  %115 = load ptr, ptr %114, align 8
  %116 = tail call i32 %115(ptr noundef %111, ptr noundef %2, ptr noundef %112, ptr noundef %113, ptr noundef %106) #9
  %117 = icmp slt i32 %116, 0
  br i1 %117, label %349, label %118

118:                                              ; preds = %102
  %119 = icmp eq i64 %30, %100
  %120 = load i64, ptr %13, align 8
  %121 = icmp sgt i64 %120, 0
  %122 = load ptr, ptr %35, align 8
  %123 = load ptr, ptr %42, align 8
  %124 = load ptr, ptr %6, align 8
  %125 = getelementptr inbounds i8, ptr %124, i64 216
  %126 = icmp ne ptr %65, null
  %127 = load i64, ptr %19, align 8
  %128 = load ptr, ptr %38, align 8
  %129 = load i64, ptr %28, align 8
  %130 = icmp slt i64 %129, %120
  %131 = icmp sgt i64 %120, 0
  %132 = icmp sgt i64 %127, 0
  %133 = getelementptr inbounds i8, ptr %0, i64 672
  %134 = getelementptr inbounds i8, ptr %0, i64 648
  %135 = select i1 %130, double 1.000000e-05, double 0x3CE0000000000000
  %136 = insertelement <8 x double> poison, double %135, i64 0
  %137 = shufflevector <8 x double> %136, <8 x double> poison, <8 x i32> zeroinitializer
  %138 = load ptr, ptr %42, align 8
  %139 = load i64, ptr %22, align 8
  %140 = add nsw i64 %139, %127
  %141 = sitofp i64 %140 to double
  %142 = insertelement <8 x double> poison, double %141, i64 0
  %143 = shufflevector <8 x double> %142, <8 x double> poison, <8 x i32> zeroinitializer
  %144 = icmp eq i64 %27, 1
  %145 = getelementptr inbounds i8, ptr %97, i64 8
  %146 = getelementptr inbounds i8, ptr %97, i64 16
  %147 = getelementptr inbounds i8, ptr %97, i64 24
  %148 = getelementptr inbounds i8, ptr %97, i64 32
  %149 = getelementptr inbounds i8, ptr %97, i64 40
  %150 = getelementptr inbounds i8, ptr %97, i64 144
  %151 = icmp sgt i64 %120, 0
  br label %170

152:                                              ; preds = %95, %152
  %153 = phi i64 [ %156, %152 ], [ 0, %95 ]
  %154 = shl nsw i64 %153, 6
  %155 = getelementptr inbounds i8, ptr %99, i64 %154
  store <8 x double> zeroinitializer, ptr %155, align 8
  %156 = add nuw nsw i64 %153, 1
  %157 = icmp eq i64 %156, %100
  br i1 %157, label %102, label %152, !llvm.loop !10

158:                                              ; preds = %346
  %159 = add nuw nsw i32 %174, 1
  %160 = load ptr, ptr %8, align 8
  %161 = getelementptr inbounds i8, ptr %160, i64 8
  %162 = load i64, ptr %161, align 8
  %163 = load ptr, ptr %103, align 8
  %164 = load ptr, ptr %104, align 8
  %165 = load ptr, ptr %105, align 8
  %166 = inttoptr i64 %162 to ptr
  %167 = load ptr, ptr %166, align 8
  %168 = tail call i32 %167(ptr noundef %163, ptr noundef %2, ptr noundef %164, ptr noundef %165, ptr noundef %106) #9
  %169 = icmp slt i32 %168, 0
  br i1 %169, label %349, label %170, !llvm.loop !11

170:                                              ; preds = %118, %158
  %171 = phi i64 [ undef, %118 ], [ %348, %158 ]
  %172 = phi i64 [ 0, %118 ], [ %297, %158 ]
  %173 = phi <8 x double> [ <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>, %118 ], [ %347, %158 ]
  %174 = phi i32 [ 0, %118 ], [ %159, %158 ]
  %175 = phi <8 x double> [ zeroinitializer, %118 ], [ %282, %158 ]
  %176 = phi i64 [ %107, %118 ], [ %295, %158 ]
  %177 = icmp eq i32 %174, 0
  %178 = select i1 %177, i1 true, i1 %119
  br i1 %121, label %191, label %179

179:                                              ; preds = %213, %170
  %180 = phi <8 x double> [ zeroinitializer, %170 ], [ %218, %213 ]
  %181 = phi <8 x i64> [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %170 ], [ %220, %213 ]
  %182 = icmp ne <8 x i64> %181, zeroinitializer
  %183 = bitcast <8 x i1> %182 to i8
  %184 = zext i8 %183 to i64
  %185 = xor i64 %184, -1
  %186 = and i64 %176, %185
  %187 = or i64 %186, %172
  %188 = and i1 %126, %177
  %189 = select i1 %188, i1 %131, i1 false
  %190 = select i1 %188, <8 x double> zeroinitializer, <8 x double> %175
  br i1 %189, label %223, label %281

191:                                              ; preds = %170, %213
  %192 = phi i64 [ %221, %213 ], [ 0, %170 ]
  %193 = phi <8 x i64> [ %220, %213 ], [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %170 ]
  %194 = phi <8 x double> [ %218, %213 ], [ zeroinitializer, %170 ]
  %195 = shl nsw i64 %192, 6
  %196 = getelementptr inbounds i8, ptr %122, i64 %195
  %197 = load <8 x double>, ptr %196, align 8
  %198 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %197)
  %199 = getelementptr inbounds i8, ptr %123, i64 %195
  %200 = load <8 x double>, ptr %199, align 8
  %201 = getelementptr inbounds i8, ptr %99, i64 %195
  %202 = load <8 x double>, ptr %201, align 8
  %203 = fcmp ogt <8 x double> %200, %202
  %204 = select <8 x i1> %203, <8 x double> %200, <8 x double> %202
  %205 = fmul <8 x double> %204, <double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000>
  %206 = fcmp une <8 x double> %197, zeroinitializer
  br i1 %178, label %213, label %207

207:                                              ; preds = %191
  %208 = load ptr, ptr %125, align 8
  %209 = getelementptr inbounds i8, ptr %208, i64 %195
  %210 = load <8 x double>, ptr %209, align 8
  %211 = fcmp ogt <8 x double> %210, zeroinitializer
  %212 = and <8 x i1> %211, %206
  br label %213

213:                                              ; preds = %207, %191
  %214 = phi <8 x i1> [ %206, %191 ], [ %212, %207 ]
  %215 = fdiv <8 x double> %198, %205
  %216 = fcmp ogt <8 x double> %215, %194
  %217 = select <8 x i1> %214, <8 x i1> %216, <8 x i1> zeroinitializer
  %218 = select <8 x i1> %217, <8 x double> %215, <8 x double> %194
  %219 = fcmp one <8 x double> %198, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %220 = select <8 x i1> %219, <8 x i64> %193, <8 x i64> zeroinitializer
  %221 = add nuw nsw i64 %192, 1
  %222 = icmp eq i64 %221, %120
  br i1 %222, label %179, label %191, !llvm.loop !12

223:                                              ; preds = %179, %230
  %224 = phi <8 x double> [ %247, %230 ], [ zeroinitializer, %179 ]
  %225 = phi i64 [ %248, %230 ], [ 0, %179 ]
  br i1 %132, label %226, label %230

226:                                              ; preds = %223
  %227 = mul nuw nsw i64 %225, %127
  %228 = load ptr, ptr %133, align 8
  %229 = load ptr, ptr %134, align 8
  br label %250

230:                                              ; preds = %250, %223
  %231 = phi <8 x double> [ zeroinitializer, %223 ], [ %278, %250 ]
  %232 = shl nsw i64 %225, 6
  %233 = getelementptr inbounds i8, ptr %138, i64 %232
  %234 = load <8 x double>, ptr %233, align 8
  %235 = fmul <8 x double> %137, %234
  %236 = fmul <8 x double> %231, %143
  %237 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %236)
  %238 = fmul <8 x double> %237, <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>
  %239 = fadd <8 x double> %235, %238
  %240 = fcmp ogt <8 x double> %231, zeroinitializer
  %241 = getelementptr inbounds i8, ptr %122, i64 %232
  %242 = load <8 x double>, ptr %241, align 8
  %243 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %242)
  %244 = fdiv <8 x double> %243, %239
  %245 = fcmp ogt <8 x double> %244, %224
  %246 = select <8 x i1> %240, <8 x i1> %245, <8 x i1> zeroinitializer
  %247 = select <8 x i1> %246, <8 x double> %244, <8 x double> %224
  %248 = add nuw nsw i64 %225, 1
  %249 = icmp eq i64 %248, %120
  br i1 %249, label %281, label %223, !llvm.loop !13

250:                                              ; preds = %226, %250
  %251 = phi <8 x double> [ zeroinitializer, %226 ], [ %278, %250 ]
  %252 = phi i64 [ 0, %226 ], [ %279, %250 ]
  %253 = add nuw nsw i64 %252, %227
  %254 = shl nsw i64 %253, 6
  %255 = getelementptr inbounds i8, ptr %128, i64 %254
  %256 = load <8 x double>, ptr %255, align 8
  %257 = shl nsw i64 %252, 6
  %258 = getelementptr inbounds i8, ptr %2, i64 %257
  %259 = load <8 x double>, ptr %258, align 8
  %260 = getelementptr inbounds i8, ptr %65, i64 %257
  %261 = load <8 x double>, ptr %260, align 8
  %262 = getelementptr inbounds double, ptr %228, i64 %252
  %263 = load double, ptr %262, align 8
  %264 = insertelement <8 x double> poison, double %263, i64 0
  %265 = shufflevector <8 x double> %264, <8 x double> poison, <8 x i32> zeroinitializer
  %266 = getelementptr inbounds double, ptr %229, i64 %252
  %267 = load double, ptr %266, align 8
  %268 = insertelement <8 x double> poison, double %267, i64 0
  %269 = shufflevector <8 x double> %268, <8 x double> poison, <8 x i32> zeroinitializer
  %270 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %261)
  %271 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %259)
  %272 = fcmp ogt <8 x double> %270, %271
  %273 = select <8 x i1> %272, <8 x double> %270, <8 x double> %271
  %274 = fmul <8 x double> %273, %269
  %275 = fadd <8 x double> %265, %274
  %276 = fmul <8 x double> %256, %275
  %277 = fmul <8 x double> %276, %276
  %278 = fadd <8 x double> %251, %277
  %279 = add nuw nsw i64 %252, 1
  %280 = icmp eq i64 %279, %127
  br i1 %280, label %230, label %250, !llvm.loop !14

281:                                              ; preds = %230, %179
  %282 = phi <8 x double> [ %190, %179 ], [ %247, %230 ]
  %283 = fcmp ole <8 x double> %180, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %284 = fmul <8 x double> %173, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %285 = fcmp oge <8 x double> %180, %284
  %286 = fcmp ole <8 x double> %180, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  %287 = and <8 x i1> %285, %286
  %288 = or <8 x i1> %287, %283
  %289 = bitcast <8 x i1> %288 to i8
  %290 = zext i8 %289 to i64
  %291 = or i64 %187, %290
  %292 = xor i64 %291, -1
  %293 = and i64 %176, %292
  %294 = icmp eq i32 %174, 9
  %295 = select i1 %294, i64 0, i64 %293
  %296 = select i1 %294, i64 %293, i64 0
  %297 = or i64 %296, %187
  store i64 %295, ptr %34, align 8
  %298 = icmp eq i64 %295, 0
  br i1 %298, label %346, label %299

299:                                              ; preds = %281
  br i1 %144, label %300, label %318

300:                                              ; preds = %299
  %301 = load i64, ptr %145, align 8
  %302 = load i64, ptr %146, align 8
  %303 = mul nsw i64 %302, %301
  %304 = icmp sgt i64 %303, 0
  br i1 %304, label %305, label %316

305:                                              ; preds = %300, %305
  %306 = phi i64 [ %311, %305 ], [ 0, %300 ]
  %307 = getelementptr inbounds double, ptr %55, i64 %306
  %308 = load double, ptr %307, align 8
  %309 = load ptr, ptr %97, align 8
  %310 = getelementptr inbounds double, ptr %309, i64 %306
  store double %308, ptr %310, align 8
  %311 = add nuw nsw i64 %306, 1
  %312 = load i64, ptr %145, align 8
  %313 = load i64, ptr %146, align 8
  %314 = mul nsw i64 %313, %312
  %315 = icmp slt i64 %311, %314
  br i1 %315, label %305, label %316, !llvm.loop !15

316:                                              ; preds = %305, %300
  %317 = load ptr, ptr %97, align 8
  tail call fastcc void @factorise(ptr noundef %317, i64 noundef %76) #8
  br label %318

318:                                              ; preds = %299, %316
  %319 = load i64, ptr %148, align 8
  %320 = load i64, ptr %149, align 8
  %321 = mul nsw i64 %320, %319
  %322 = icmp sgt i64 %321, 0
  br i1 %322, label %323, label %334

323:                                              ; preds = %318, %323
  %324 = phi i64 [ %329, %323 ], [ 0, %318 ]
  %325 = getelementptr inbounds double, ptr %49, i64 %324
  %326 = load double, ptr %325, align 8
  %327 = load ptr, ptr %147, align 8
  %328 = getelementptr inbounds double, ptr %327, i64 %324
  store double %326, ptr %328, align 8
  %329 = add nuw nsw i64 %324, 1
  %330 = load i64, ptr %148, align 8
  %331 = load i64, ptr %149, align 8
  %332 = mul nsw i64 %331, %330
  %333 = icmp slt i64 %329, %332
  br i1 %333, label %323, label %334, !llvm.loop !15

334:                                              ; preds = %323, %318
  %335 = load ptr, ptr %150, align 8
  br i1 %151, label %336, label %345

336:                                              ; preds = %334, %336
  %337 = phi i64 [ %343, %336 ], [ 0, %334 ]
  %338 = shl nsw i64 %337, 6
  %339 = getelementptr inbounds i8, ptr %106, i64 %338
  %340 = load <8 x double>, ptr %339, align 8
  %341 = fneg <8 x double> %340
  %342 = getelementptr inbounds i8, ptr %335, i64 %338
  store <8 x double> %341, ptr %342, align 8
  %343 = add nuw nsw i64 %337, 1
  %344 = icmp eq i64 %343, %120
  br i1 %344, label %345, label %336, !llvm.loop !16

345:                                              ; preds = %336, %334
  call fastcc void @move_positions(ptr noundef nonnull %6, ptr noundef %2) #8
  br label %346

346:                                              ; preds = %345, %281
  %347 = phi <8 x double> [ %180, %345 ], [ %173, %281 ]
  %348 = phi i64 [ %171, %345 ], [ %297, %281 ]
  br i1 %298, label %349, label %158

349:                                              ; preds = %346, %158, %102
  %350 = phi <8 x double> [ zeroinitializer, %102 ], [ %282, %158 ], [ %282, %346 ]
  %351 = phi i64 [ %96, %102 ], [ %348, %346 ], [ %96, %158 ]
  %352 = load i64, ptr %16, align 8
  %353 = icmp eq i64 %352, 0
  %354 = icmp eq i64 %351, %4
  %355 = select i1 %353, i1 true, i1 %354
  br i1 %355, label %361, label %356

356:                                              ; preds = %349
  %357 = icmp sgt i64 %352, 0
  br i1 %357, label %358, label %367

358:                                              ; preds = %356
  %359 = load ptr, ptr %35, align 8
  %360 = load i64, ptr %13, align 8
  br label %374

361:                                              ; preds = %349
  %362 = fcmp ogt <8 x double> %350, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %363 = bitcast <8 x i1> %362 to i8
  %364 = zext i8 %363 to i64
  %365 = and i64 %364, %4
  %366 = or i64 %365, %351
  br label %645

367:                                              ; preds = %374, %356
  %368 = phi <8 x double> [ zeroinitializer, %356 ], [ %382, %374 ]
  %369 = load i64, ptr %22, align 8
  %370 = mul nsw i64 %369, %352
  %371 = icmp sgt i64 %370, 0
  br i1 %371, label %372, label %385

372:                                              ; preds = %367
  %373 = load ptr, ptr %40, align 8
  br label %396

374:                                              ; preds = %358, %374
  %375 = phi i64 [ 0, %358 ], [ %383, %374 ]
  %376 = phi <8 x double> [ zeroinitializer, %358 ], [ %382, %374 ]
  %377 = add nsw i64 %360, %375
  %378 = shl nsw i64 %377, 6
  %379 = getelementptr inbounds i8, ptr %359, i64 %378
  %380 = load <8 x double>, ptr %379, align 8
  %381 = fmul <8 x double> %380, zeroinitializer
  %382 = fadd <8 x double> %376, %381
  %383 = add nuw nsw i64 %375, 1
  %384 = icmp eq i64 %383, %352
  br i1 %384, label %367, label %374, !llvm.loop !17

385:                                              ; preds = %396, %367
  %386 = phi <8 x double> [ %368, %367 ], [ %403, %396 ]
  %387 = fcmp oeq <8 x double> %386, zeroinitializer
  %388 = bitcast <8 x i1> %387 to i8
  %389 = zext i8 %388 to i64
  %390 = xor i64 %389, -1
  %391 = and i64 %390, %4
  %392 = or i64 %391, %351
  %393 = xor i64 %392, -1
  %394 = and i64 %393, %4
  store i64 %394, ptr %34, align 8
  %395 = icmp eq ptr %65, null
  br i1 %395, label %493, label %406

396:                                              ; preds = %372, %396
  %397 = phi i64 [ 0, %372 ], [ %404, %396 ]
  %398 = phi <8 x double> [ %368, %372 ], [ %403, %396 ]
  %399 = shl nsw i64 %397, 6
  %400 = getelementptr inbounds i8, ptr %373, i64 %399
  %401 = load <8 x double>, ptr %400, align 8
  %402 = fmul <8 x double> %401, zeroinitializer
  %403 = fadd <8 x double> %398, %402
  %404 = add nuw nsw i64 %397, 1
  %405 = icmp eq i64 %404, %370
  br i1 %405, label %385, label %396, !llvm.loop !18

406:                                              ; preds = %385
  %407 = load i64, ptr %19, align 8
  %408 = load ptr, ptr %35, align 8
  %409 = load i64, ptr %13, align 8
  %410 = shl nsw i64 %409, 6
  %411 = getelementptr inbounds i8, ptr %408, i64 %410
  %412 = load ptr, ptr %40, align 8
  %413 = icmp sgt i64 %352, 0
  br i1 %413, label %414, label %489

414:                                              ; preds = %406
  %415 = load i64, ptr %31, align 8
  %416 = icmp slt i64 %415, %352
  %417 = icmp sgt i64 %369, 0
  %418 = getelementptr inbounds i8, ptr %0, i64 672
  %419 = getelementptr inbounds i8, ptr %0, i64 648
  %420 = select i1 %416, double 1.000000e-05, double 0x3CE0000000000000
  %421 = insertelement <8 x double> poison, double %420, i64 0
  %422 = shufflevector <8 x double> %421, <8 x double> poison, <8 x i32> zeroinitializer
  %423 = add nsw i64 %407, %369
  %424 = sitofp i64 %423 to double
  %425 = insertelement <8 x double> poison, double %424, i64 0
  %426 = shufflevector <8 x double> %425, <8 x double> poison, <8 x i32> zeroinitializer
  br label %427

427:                                              ; preds = %414, %434
  %428 = phi <8 x double> [ zeroinitializer, %414 ], [ %450, %434 ]
  %429 = phi i64 [ 0, %414 ], [ %451, %434 ]
  br i1 %417, label %430, label %434

430:                                              ; preds = %427
  %431 = mul nuw nsw i64 %429, %369
  %432 = load ptr, ptr %418, align 8
  %433 = load ptr, ptr %419, align 8
  br label %453

434:                                              ; preds = %453, %427
  %435 = phi <8 x double> [ zeroinitializer, %427 ], [ %486, %453 ]
  %436 = phi <8 x double> [ zeroinitializer, %427 ], [ %483, %453 ]
  %437 = fmul <8 x double> %422, %435
  %438 = fmul <8 x double> %426, %436
  %439 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %438)
  %440 = fmul <8 x double> %439, <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>
  %441 = fadd <8 x double> %437, %440
  %442 = fcmp ogt <8 x double> %436, zeroinitializer
  %443 = shl nsw i64 %429, 6
  %444 = getelementptr inbounds i8, ptr %411, i64 %443
  %445 = load <8 x double>, ptr %444, align 8
  %446 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %445)
  %447 = fdiv <8 x double> %446, %441
  %448 = fcmp ogt <8 x double> %447, %428
  %449 = select <8 x i1> %442, <8 x i1> %448, <8 x i1> zeroinitializer
  %450 = select <8 x i1> %449, <8 x double> %447, <8 x double> %428
  %451 = add nuw nsw i64 %429, 1
  %452 = icmp eq i64 %451, %352
  br i1 %452, label %489, label %427, !llvm.loop !13

453:                                              ; preds = %430, %453
  %454 = phi <8 x double> [ zeroinitializer, %430 ], [ %483, %453 ]
  %455 = phi i64 [ 0, %430 ], [ %487, %453 ]
  %456 = phi <8 x double> [ zeroinitializer, %430 ], [ %486, %453 ]
  %457 = add nuw nsw i64 %455, %431
  %458 = shl nsw i64 %457, 6
  %459 = getelementptr inbounds i8, ptr %412, i64 %458
  %460 = load <8 x double>, ptr %459, align 8
  %461 = add nsw i64 %455, %407
  %462 = shl nsw i64 %461, 6
  %463 = getelementptr inbounds i8, ptr %2, i64 %462
  %464 = load <8 x double>, ptr %463, align 8
  %465 = getelementptr inbounds i8, ptr %65, i64 %462
  %466 = load <8 x double>, ptr %465, align 8
  %467 = getelementptr inbounds double, ptr %432, i64 %461
  %468 = load double, ptr %467, align 8
  %469 = insertelement <8 x double> poison, double %468, i64 0
  %470 = shufflevector <8 x double> %469, <8 x double> poison, <8 x i32> zeroinitializer
  %471 = getelementptr inbounds double, ptr %433, i64 %461
  %472 = load double, ptr %471, align 8
  %473 = insertelement <8 x double> poison, double %472, i64 0
  %474 = shufflevector <8 x double> %473, <8 x double> poison, <8 x i32> zeroinitializer
  %475 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %466)
  %476 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %464)
  %477 = fcmp ogt <8 x double> %475, %476
  %478 = select <8 x i1> %477, <8 x double> %475, <8 x double> %476
  %479 = fmul <8 x double> %478, %474
  %480 = fadd <8 x double> %470, %479
  %481 = fmul <8 x double> %460, %480
  %482 = fmul <8 x double> %481, %481
  %483 = fadd <8 x double> %454, %482
  %484 = fmul <8 x double> %460, %464
  %485 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %484)
  %486 = fadd <8 x double> %456, %485
  %487 = add nuw nsw i64 %455, 1
  %488 = icmp eq i64 %487, %369
  br i1 %488, label %434, label %453, !llvm.loop !14

489:                                              ; preds = %434, %406
  %490 = phi <8 x double> [ zeroinitializer, %406 ], [ %450, %434 ]
  %491 = fcmp ogt <8 x double> %490, %350
  %492 = select <8 x i1> %491, <8 x double> %490, <8 x double> %350
  br label %493

493:                                              ; preds = %489, %385
  %494 = phi <8 x double> [ %350, %385 ], [ %492, %489 ]
  %495 = load i64, ptr %25, align 8
  %496 = icmp eq i64 %495, 1
  br i1 %496, label %497, label %521

497:                                              ; preds = %493
  %498 = load ptr, ptr %41, align 8
  %499 = load ptr, ptr %6, align 8
  %500 = getelementptr inbounds i8, ptr %499, i64 8
  %501 = getelementptr inbounds i8, ptr %499, i64 16
  %502 = load i64, ptr %500, align 8
  %503 = load i64, ptr %501, align 8
  %504 = mul nsw i64 %503, %502
  %505 = icmp sgt i64 %504, 0
  br i1 %505, label %506, label %517

506:                                              ; preds = %497, %506
  %507 = phi i64 [ %512, %506 ], [ 0, %497 ]
  %508 = getelementptr inbounds double, ptr %498, i64 %507
  %509 = load double, ptr %508, align 8
  %510 = load ptr, ptr %499, align 8
  %511 = getelementptr inbounds double, ptr %510, i64 %507
  store double %509, ptr %511, align 8
  %512 = add nuw nsw i64 %507, 1
  %513 = load i64, ptr %500, align 8
  %514 = load i64, ptr %501, align 8
  %515 = mul nsw i64 %514, %513
  %516 = icmp slt i64 %512, %515
  br i1 %516, label %506, label %517, !llvm.loop !15

517:                                              ; preds = %506, %497
  %518 = load ptr, ptr %6, align 8
  %519 = load ptr, ptr %518, align 8
  %520 = load i64, ptr %22, align 8
  tail call fastcc void @factorise(ptr noundef %519, i64 noundef %520) #8
  br label %521

521:                                              ; preds = %493, %517
  %522 = load ptr, ptr %35, align 8
  %523 = load i64, ptr %13, align 8
  %524 = shl nsw i64 %523, 6
  %525 = getelementptr inbounds i8, ptr %522, i64 %524
  %526 = load i64, ptr %16, align 8
  %527 = load ptr, ptr %6, align 8
  %528 = getelementptr inbounds i8, ptr %527, i64 144
  %529 = load ptr, ptr %528, align 8
  %530 = icmp sgt i64 %526, 0
  br i1 %530, label %531, label %540

531:                                              ; preds = %521, %531
  %532 = phi i64 [ %538, %531 ], [ 0, %521 ]
  %533 = shl nsw i64 %532, 6
  %534 = getelementptr inbounds i8, ptr %525, i64 %533
  %535 = load <8 x double>, ptr %534, align 8
  %536 = fneg <8 x double> %535
  %537 = getelementptr inbounds i8, ptr %529, i64 %533
  store <8 x double> %536, ptr %537, align 8
  %538 = add nuw nsw i64 %532, 1
  %539 = icmp eq i64 %538, %526
  br i1 %539, label %540, label %531, !llvm.loop !16

540:                                              ; preds = %531, %521
  call fastcc void @move_speeds(ptr noundef nonnull %6, ptr noundef %2) #8
  %541 = load ptr, ptr %66, align 8
  %542 = getelementptr inbounds i8, ptr %541, i64 8
  %543 = load i64, ptr %542, align 8
  %544 = load ptr, ptr %43, align 8
  %545 = load i64, ptr %34, align 8
  %546 = trunc i64 %545 to i8
  %547 = bitcast i8 %546 to <8 x i1>
  %548 = load i64, ptr %16, align 8
  %549 = icmp sgt i64 %548, 0
  br i1 %549, label %550, label %557

550:                                              ; preds = %540
  %551 = load ptr, ptr %6, align 8
  %552 = getelementptr inbounds i8, ptr %551, i64 216
  %553 = add nsw i64 %543, 4
  %554 = getelementptr inbounds i8, ptr %551, i64 192
  br label %599

555:                                              ; preds = %599
  %556 = bitcast <8 x double> %623 to <8 x i64>
  br label %557

557:                                              ; preds = %555, %540
  %558 = phi <8 x double> [ zeroinitializer, %540 ], [ %619, %555 ]
  %559 = phi <8 x i64> [ <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, %540 ], [ %556, %555 ]
  %560 = load <8 x double>, ptr %544, align 8
  %561 = getelementptr inbounds i8, ptr %544, i64 128
  %562 = load <8 x double>, ptr %561, align 8
  %563 = fcmp ogt <8 x double> %558, %560
  %564 = select <8 x i1> %563, <8 x i1> %547, <8 x i1> zeroinitializer
  %565 = select <8 x i1> %564, <8 x double> %558, <8 x double> %560
  store <8 x double> %565, ptr %544, align 8
  %566 = getelementptr inbounds i8, ptr %544, i64 64
  %567 = load <8 x i64>, ptr %566, align 8
  %568 = select <8 x i1> %564, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> %567
  %569 = bitcast <8 x i64> %568 to <8 x double>
  %570 = fcmp olt <8 x double> %558, %560
  %571 = select <8 x i1> %570, <8 x i64> zeroinitializer, <8 x i64> %559
  %572 = bitcast <8 x i64> %571 to <8 x double>
  %573 = fcmp ogt <8 x double> %562, %572
  %574 = bitcast <8 x double> %562 to <8 x i64>
  %575 = select <8 x i1> %573, <8 x i64> %571, <8 x i64> %574
  %576 = bitcast <8 x i64> %575 to <8 x double>
  %577 = select <8 x i1> %547, <8 x i64> %571, <8 x i64> %574
  store <8 x i64> %577, ptr %561, align 8
  %578 = fcmp oge <8 x double> %576, <double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02>
  %579 = fmul <8 x double> %494, %576
  %580 = fmul <8 x double> %579, <double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02>
  %581 = fcmp ogt <8 x double> %580, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %582 = or <8 x i1> %581, %578
  %583 = load i64, ptr %34, align 8
  %584 = fcmp ogt <8 x double> %494, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %585 = and <8 x i1> %582, %584
  %586 = bitcast <8 x i1> %585 to i8
  %587 = zext i8 %586 to i64
  %588 = and i64 %583, %587
  %589 = xor i64 %588, %583
  %590 = trunc i64 %589 to i8
  %591 = bitcast i8 %590 to <8 x i1>
  %592 = fcmp olt <8 x double> %572, %569
  %593 = fcmp ogt <8 x double> %569, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %594 = select <8 x i1> %593, <8 x i1> %592, <8 x i1> zeroinitializer
  %595 = select <8 x i1> %594, <8 x i1> %591, <8 x i1> zeroinitializer
  %596 = select <8 x i1> %595, <8 x i64> %571, <8 x i64> %568
  store <8 x i64> %596, ptr %566, align 8
  %597 = bitcast <8 x i1> %595 to i8
  %598 = icmp eq i8 %597, 0
  br i1 %598, label %643, label %626

599:                                              ; preds = %550, %599
  %600 = phi <8 x double> [ <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %550 ], [ %623, %599 ]
  %601 = phi <8 x double> [ zeroinitializer, %550 ], [ %619, %599 ]
  %602 = phi i64 [ 0, %550 ], [ %624, %599 ]
  %603 = load ptr, ptr %552, align 8
  %604 = shl nsw i64 %602, 6
  %605 = getelementptr inbounds i8, ptr %603, i64 %604
  %606 = load <8 x double>, ptr %605, align 8
  %607 = add nsw i64 %553, %602
  %608 = shl nsw i64 %607, 6
  %609 = getelementptr inbounds i8, ptr %544, i64 %608
  %610 = load <8 x double>, ptr %609, align 8
  %611 = load ptr, ptr %554, align 8
  %612 = getelementptr inbounds i8, ptr %611, i64 %604
  %613 = load <8 x double>, ptr %612, align 8
  %614 = fcmp ogt <8 x double> %613, %610
  %615 = select <8 x i1> %614, <8 x double> %613, <8 x double> %610
  %616 = select <8 x i1> %547, <8 x double> %615, <8 x double> %610
  store <8 x double> %616, ptr %609, align 8
  %617 = fcmp ogt <8 x double> %606, zeroinitializer
  %618 = fadd <8 x double> %601, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %619 = select <8 x i1> %617, <8 x double> %618, <8 x double> %601
  %620 = fdiv <8 x double> %606, %615
  %621 = fcmp olt <8 x double> %620, %600
  %622 = select <8 x i1> %617, <8 x i1> %621, <8 x i1> zeroinitializer
  %623 = select <8 x i1> %622, <8 x double> %620, <8 x double> %600
  %624 = add nuw nsw i64 %602, 1
  %625 = icmp eq i64 %624, %548
  br i1 %625, label %555, label %599, !llvm.loop !19

626:                                              ; preds = %557
  %627 = getelementptr inbounds i8, ptr %544, i64 192
  %628 = load <8 x double>, ptr %627, align 8
  %629 = select <8 x i1> %595, <8 x double> %7, <8 x double> %628
  store <8 x double> %629, ptr %627, align 8
  %630 = getelementptr i8, ptr %544, i64 256
  %631 = icmp sgt i64 %543, 0
  br i1 %631, label %632, label %643

632:                                              ; preds = %626, %632
  %633 = phi i64 [ %641, %632 ], [ 0, %626 ]
  %634 = shl nsw i64 %633, 6
  %635 = getelementptr inbounds i8, ptr %2, i64 %634
  %636 = load <8 x i64>, ptr %635, align 8
  %637 = shl i64 %633, 6
  %638 = getelementptr i8, ptr %630, i64 %637
  %639 = load <8 x i64>, ptr %638, align 8
  %640 = select <8 x i1> %595, <8 x i64> %636, <8 x i64> %639
  store <8 x i64> %640, ptr %638, align 8
  %641 = add nuw nsw i64 %633, 1
  %642 = icmp eq i64 %641, %543
  br i1 %642, label %643, label %632, !llvm.loop !20

643:                                              ; preds = %632, %626, %557
  %644 = or i64 %588, %392
  br label %645

645:                                              ; preds = %361, %643
  %646 = phi i64 [ %366, %361 ], [ %644, %643 ]
  ret i64 %646
}



define internal fastcc void @move_speeds(ptr noundef readonly %0, ptr noundef %1) unnamed_addr #2 {
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %0, i64 96
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
  tail call fastcc void @divide_rows(ptr noundef %25, i64 noundef %27, ptr noundef %28, i64 noundef %30) #8
  %31 = getelementptr inbounds i8, ptr %0, i64 56
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %0, i64 64
  %34 = load i64, ptr %33, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %6, ptr noundef nonnull %3, i64 noundef %32, i64 noundef %34) #8
  %35 = load ptr, ptr %3, align 8
  %36 = load i64, ptr %29, align 8
  %37 = getelementptr inbounds i8, ptr %3, i64 120
  %38 = load ptr, ptr %37, align 8
  tail call fastcc void @divide_transposed(ptr noundef %35, i64 noundef %36, ptr noundef %38) #8
  %39 = load i64, ptr %29, align 8
  %40 = icmp sgt i64 %39, 0
  br i1 %40, label %41, label %43

41:                                               ; preds = %24
  %42 = getelementptr inbounds i8, ptr %0, i64 24
  br label %44

43:                                               ; preds = %44, %24
  ret void

44:                                               ; preds = %41, %44
  %45 = phi i64 [ 0, %41 ], [ %60, %44 ]
  %46 = load i64, ptr %42, align 8
  %47 = add nsw i64 %46, %45
  %48 = shl nsw i64 %47, 6
  %49 = getelementptr inbounds i8, ptr %1, i64 %48
  %50 = load <8 x double>, ptr %49, align 8
  %51 = load i64, ptr %33, align 8
  %52 = trunc i64 %51 to i8
  %53 = bitcast i8 %52 to <8 x i1>
  %54 = load ptr, ptr %37, align 8
  %55 = shl nsw i64 %45, 6
  %56 = getelementptr inbounds i8, ptr %54, i64 %55
  %57 = load <8 x double>, ptr %56, align 8
  %58 = fadd <8 x double> %50, %57
  %59 = select <8 x i1> %53, <8 x double> %58, <8 x double> %50
  store <8 x double> %59, ptr %49, align 8
  %60 = add nuw nsw i64 %45, 1
  %61 = load i64, ptr %29, align 8
  %62 = icmp slt i64 %60, %61
  br i1 %62, label %44, label %43, !llvm.loop !21
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #3 {
  %2 = getelementptr inbounds i8, ptr %0, i64 152
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %14

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  %7 = getelementptr inbounds i8, ptr %0, i64 160
  %8 = getelementptr inbounds i8, ptr %0, i64 168
  %9 = getelementptr inbounds i8, ptr %0, i64 24
  %10 = getelementptr inbounds i8, ptr %0, i64 264
  %11 = getelementptr inbounds i8, ptr %0, i64 192
  %12 = getelementptr inbounds i8, ptr %0, i64 216
  %13 = getelementptr inbounds i8, ptr %0, i64 48
  br label %15

14:                                               ; preds = %22, %1
  ret void

15:                                               ; preds = %5, %22
  %16 = phi i64 [ 0, %5 ], [ %23, %22 ]
  %17 = load ptr, ptr %6, align 8
  %18 = load i64, ptr %7, align 8
  %19 = mul nsw i64 %18, %16
  %20 = getelementptr inbounds i64, ptr %17, i64 %19
  %21 = shl nsw i64 %16, 6
  br label %26

22:                                               ; preds = %77
  %23 = add nuw nsw i64 %16, 1
  %24 = load i64, ptr %2, align 8
  %25 = icmp slt i64 %23, %24
  br i1 %25, label %15, label %14, !llvm.loop !22

26:                                               ; preds = %15, %77
  %27 = phi i64 [ 0, %15 ], [ %104, %77 ]
  %28 = load ptr, ptr %8, align 8
  %29 = getelementptr inbounds i8, ptr %28, i64 %21
  %30 = getelementptr inbounds i64, ptr %29, i64 %27
  %31 = load ptr, ptr %9, align 8
  %32 = getelementptr inbounds double, ptr %31, i64 %27
  %33 = load double, ptr %32, align 8
  %34 = load ptr, ptr %10, align 8
  %35 = getelementptr inbounds double, ptr %34, i64 %27
  %36 = load double, ptr %35, align 8
  %37 = fcmp olt double %33, %36
  %38 = select i1 %37, double %33, double %36
  %39 = load ptr, ptr %6, align 8
  %40 = load i64, ptr %7, align 8
  %41 = mul nsw i64 %40, %16
  %42 = getelementptr inbounds i64, ptr %39, i64 %41
  %43 = getelementptr inbounds i8, ptr %42, i64 8
  %44 = load i64, ptr %43, align 8
  %45 = load ptr, ptr %11, align 8
  %46 = getelementptr inbounds double, ptr %45, i64 %44
  %47 = load double, ptr %46, align 8
  %48 = fcmp ogt double %47, %38
  %49 = select i1 %48, double %47, double %38
  %50 = getelementptr inbounds i8, ptr %42, i64 16
  %51 = load i64, ptr %50, align 8
  %52 = load i64, ptr %30, align 8
  %53 = getelementptr inbounds double, ptr %46, i64 %52
  %54 = load double, ptr %53, align 8
  %55 = fcmp ugt double %54, %49
  br i1 %55, label %63, label %56

56:                                               ; preds = %26
  %57 = add nsw i64 %51, -1
  %58 = icmp eq i64 %57, %52
  br i1 %58, label %77, label %59

59:                                               ; preds = %56
  %60 = getelementptr i8, ptr %53, i64 8
  %61 = load double, ptr %60, align 8
  %62 = fcmp ogt double %61, %49
  br i1 %62, label %77, label %63

63:                                               ; preds = %59, %26
  %64 = icmp sgt i64 %51, 1
  br i1 %64, label %65, label %77

65:                                               ; preds = %63, %65
  %66 = phi i64 [ %74, %65 ], [ %51, %63 ]
  %67 = phi i64 [ %73, %65 ], [ 0, %63 ]
  %68 = add nsw i64 %66, %67
  %69 = sdiv i64 %68, 2
  %70 = getelementptr inbounds double, ptr %46, i64 %69
  %71 = load double, ptr %70, align 8
  %72 = fcmp ugt double %71, %49
  %73 = select i1 %72, i64 %67, i64 %69
  %74 = select i1 %72, i64 %69, i64 %66
  %75 = sub nsw i64 %74, %73
  %76 = icmp sgt i64 %75, 1
  br i1 %76, label %65, label %77, !llvm.loop !23

77:                                               ; preds = %65, %63, %56, %59
  %78 = phi i64 [ %52, %59 ], [ %52, %56 ], [ 0, %63 ], [ %73, %65 ]
  store i64 %78, ptr %30, align 8
  %79 = getelementptr inbounds double, ptr %46, i64 %78
  %80 = load double, ptr %79, align 8
  %81 = fsub double %49, %80
  %82 = load ptr, ptr %12, align 8
  %83 = add nsw i64 %78, %44
  %84 = shl nsw i64 %83, 5
  %85 = getelementptr inbounds i8, ptr %82, i64 %84
  %86 = load double, ptr %85, align 8
  %87 = getelementptr inbounds i8, ptr %85, i64 8
  %88 = load double, ptr %87, align 8
  %89 = getelementptr inbounds i8, ptr %85, i64 16
  %90 = load double, ptr %89, align 8
  %91 = getelementptr inbounds i8, ptr %85, i64 24
  %92 = load double, ptr %91, align 8
  %93 = fmul double %81, %92
  %94 = fadd double %90, %93
  %95 = fmul double %81, %94
  %96 = fadd double %88, %95
  %97 = fmul double %81, %96
  %98 = fadd double %86, %97
  %99 = load ptr, ptr %13, align 8
  %100 = load i64, ptr %20, align 8
  %101 = shl i64 %100, 6
  %102 = getelementptr i8, ptr %99, i64 %101
  %103 = getelementptr double, ptr %102, i64 %27
  store double %98, ptr %103, align 8
  %104 = add nuw nsw i64 %27, 1
  %105 = icmp eq i64 %104, 8
  br i1 %105, label %22, label %26, !llvm.loop !24
}

declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #4

define internal fastcc void @move_positions(ptr noundef readonly %0, ptr noundef %1) unnamed_addr #2 {
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %3, i64 120
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 80
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %3, i64 48
  %9 = getelementptr inbounds i8, ptr %3, i64 56
  %10 = getelementptr inbounds i8, ptr %3, i64 64
  %11 = load i64, ptr %9, align 8
  %12 = load i64, ptr %10, align 8
  %13 = mul nsw i64 %12, %11
  %14 = icmp sgt i64 %13, 0
  br i1 %14, label %15, label %26

15:                                               ; preds = %2, %15
  %16 = phi i64 [ %21, %15 ], [ 0, %2 ]
  %17 = getelementptr inbounds double, ptr %7, i64 %16
  %18 = load double, ptr %17, align 8
  %19 = load ptr, ptr %8, align 8
  %20 = getelementptr inbounds double, ptr %19, i64 %16
  store double %18, ptr %20, align 8
  %21 = add nuw nsw i64 %16, 1
  %22 = load i64, ptr %9, align 8
  %23 = load i64, ptr %10, align 8
  %24 = mul nsw i64 %23, %22
  %25 = icmp slt i64 %21, %24
  br i1 %25, label %15, label %26, !llvm.loop !15

26:                                               ; preds = %15, %2
  tail call fastcc void @set_rows(ptr noundef nonnull %0) #8
  %27 = getelementptr inbounds i8, ptr %3, i64 72
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr inbounds i8, ptr %0, i64 8
  %30 = load i64, ptr %29, align 8
  %31 = load ptr, ptr %3, align 8
  %32 = getelementptr inbounds i8, ptr %0, i64 32
  %33 = load i64, ptr %32, align 8
  tail call fastcc void @divide_rows(ptr noundef %28, i64 noundef %30, ptr noundef %31, i64 noundef %33) #8
  %34 = getelementptr inbounds i8, ptr %0, i64 48
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds i8, ptr %0, i64 64
  %37 = load i64, ptr %36, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %27, ptr noundef nonnull %3, i64 noundef %35, i64 noundef %37) #8
  %38 = load i64, ptr %32, align 8
  %39 = icmp sgt i64 %38, 0
  br i1 %39, label %40, label %50

40:                                               ; preds = %26, %40
  %41 = phi i64 [ %48, %40 ], [ 0, %26 ]
  %42 = phi <8 x double> [ %47, %40 ], [ zeroinitializer, %26 ]
  %43 = shl nsw i64 %41, 6
  %44 = getelementptr inbounds i8, ptr %5, i64 %43
  %45 = load <8 x double>, ptr %44, align 8
  %46 = fmul <8 x double> %45, %45
  %47 = fadd <8 x double> %42, %46
  %48 = add nuw nsw i64 %41, 1
  %49 = icmp eq i64 %48, %38
  br i1 %49, label %50, label %40, !llvm.loop !25

50:                                               ; preds = %40, %26
  %51 = phi <8 x double> [ zeroinitializer, %26 ], [ %47, %40 ]
  %52 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %51)
  %53 = load i64, ptr %29, align 8
  %54 = icmp sgt i64 %53, 0
  br i1 %54, label %55, label %58

55:                                               ; preds = %50
  %56 = getelementptr inbounds i8, ptr %3, i64 240
  %57 = getelementptr inbounds i8, ptr %3, i64 192
  br label %67

58:                                               ; preds = %67, %50
  %59 = load ptr, ptr %3, align 8
  %60 = load i64, ptr %32, align 8
  %61 = load ptr, ptr %4, align 8
  tail call fastcc void @divide_transposed(ptr noundef %59, i64 noundef %60, ptr noundef %61) #8
  %62 = getelementptr inbounds i8, ptr %0, i64 24
  %63 = load i64, ptr %62, align 8
  %64 = icmp sgt i64 %63, 0
  br i1 %64, label %65, label %82

65:                                               ; preds = %58
  %66 = getelementptr inbounds i8, ptr %3, i64 24
  br label %89

67:                                               ; preds = %55, %67
  %68 = phi i64 [ 0, %55 ], [ %79, %67 ]
  %69 = load ptr, ptr %56, align 8
  %70 = shl nsw i64 %68, 6
  %71 = getelementptr inbounds i8, ptr %69, i64 %70
  %72 = load <8 x double>, ptr %71, align 8
  %73 = fcmp oeq <8 x double> %72, zeroinitializer
  %74 = load ptr, ptr %57, align 8
  %75 = getelementptr inbounds i8, ptr %74, i64 %70
  %76 = load <8 x double>, ptr %75, align 8
  %77 = fmul <8 x double> %52, %76
  %78 = select <8 x i1> %73, <8 x double> %77, <8 x double> %72
  store <8 x double> %78, ptr %71, align 8
  %79 = add nuw nsw i64 %68, 1
  %80 = load i64, ptr %29, align 8
  %81 = icmp slt i64 %79, %80
  br i1 %81, label %67, label %58, !llvm.loop !26

82:                                               ; preds = %99, %58
  %83 = getelementptr inbounds i8, ptr %0, i64 24
  %84 = load i64, ptr %29, align 8
  %85 = icmp sgt i64 %84, 0
  br i1 %85, label %86, label %126

86:                                               ; preds = %82
  %87 = getelementptr inbounds i8, ptr %3, i64 144
  %88 = load ptr, ptr %87, align 8
  br label %131

89:                                               ; preds = %65, %99
  %90 = phi i64 [ 0, %65 ], [ %105, %99 ]
  %91 = shl nsw i64 %90, 6
  %92 = getelementptr inbounds i8, ptr %1, i64 %91
  %93 = load <8 x double>, ptr %92, align 8
  %94 = load i64, ptr %32, align 8
  %95 = icmp sgt i64 %94, 0
  br i1 %95, label %96, label %99

96:                                               ; preds = %89
  %97 = load ptr, ptr %66, align 8
  %98 = mul nuw nsw i64 %94, %90
  br label %108

99:                                               ; preds = %108, %89
  %100 = phi <8 x double> [ %93, %89 ], [ %119, %108 ]
  %101 = load i64, ptr %36, align 8
  %102 = trunc i64 %101 to i8
  %103 = bitcast i8 %102 to <8 x i1>
  %104 = select <8 x i1> %103, <8 x double> %100, <8 x double> %93
  store <8 x double> %104, ptr %92, align 8
  %105 = add nuw nsw i64 %90, 1
  %106 = load i64, ptr %62, align 8
  %107 = icmp slt i64 %105, %106
  br i1 %107, label %89, label %82, !llvm.loop !27

108:                                              ; preds = %96, %108
  %109 = phi i64 [ 0, %96 ], [ %120, %108 ]
  %110 = phi <8 x double> [ %93, %96 ], [ %119, %108 ]
  %111 = add nuw nsw i64 %98, %109
  %112 = shl nsw i64 %111, 6
  %113 = getelementptr inbounds i8, ptr %97, i64 %112
  %114 = load <8 x double>, ptr %113, align 8
  %115 = shl nsw i64 %109, 6
  %116 = getelementptr inbounds i8, ptr %5, i64 %115
  %117 = load <8 x double>, ptr %116, align 8
  %118 = fmul <8 x double> %114, %117
  %119 = fadd <8 x double> %110, %118
  %120 = add nuw nsw i64 %109, 1
  %121 = icmp eq i64 %120, %94
  br i1 %121, label %99, label %108, !llvm.loop !28

122:                                              ; preds = %131
  %123 = fcmp ogt <8 x double> %139, zeroinitializer
  %124 = bitcast <8 x i1> %123 to i8
  %125 = zext i8 %124 to i64
  br label %126

126:                                              ; preds = %122, %82
  %127 = phi i64 [ 0, %82 ], [ %125, %122 ]
  %128 = load i64, ptr %36, align 8
  %129 = and i64 %128, %127
  %130 = icmp eq i64 %129, 0
  br i1 %130, label %161, label %142

131:                                              ; preds = %86, %131
  %132 = phi i64 [ 0, %86 ], [ %140, %131 ]
  %133 = phi <8 x double> [ zeroinitializer, %86 ], [ %139, %131 ]
  %134 = shl nsw i64 %132, 6
  %135 = getelementptr inbounds i8, ptr %88, i64 %134
  %136 = load <8 x double>, ptr %135, align 8
  %137 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %136)
  %138 = fcmp ogt <8 x double> %137, %133
  %139 = select <8 x i1> %138, <8 x double> %137, <8 x double> %133
  %140 = add nuw nsw i64 %132, 1
  %141 = icmp eq i64 %140, %84
  br i1 %141, label %122, label %131, !llvm.loop !29

142:                                              ; preds = %126
  %143 = load i64, ptr %34, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %8, ptr noundef nonnull %3, i64 noundef %143, i64 noundef %129) #8
  %144 = load i64, ptr %83, align 8
  %145 = icmp sgt i64 %144, 0
  br i1 %145, label %146, label %161

146:                                              ; preds = %142
  %147 = trunc nuw i64 %129 to i8
  %148 = bitcast i8 %147 to <8 x i1>
  br label %149

149:                                              ; preds = %146, %149
  %150 = phi i64 [ 0, %146 ], [ %158, %149 ]
  %151 = shl nsw i64 %150, 6
  %152 = getelementptr inbounds i8, ptr %1, i64 %151
  %153 = load <8 x double>, ptr %152, align 8
  %154 = getelementptr inbounds i8, ptr %5, i64 %151
  %155 = load <8 x double>, ptr %154, align 8
  %156 = fadd <8 x double> %153, %155
  %157 = select <8 x i1> %148, <8 x double> %156, <8 x double> %153
  store <8 x double> %157, ptr %152, align 8
  %158 = add nuw nsw i64 %150, 1
  %159 = load i64, ptr %83, align 8
  %160 = icmp slt i64 %158, %159
  br i1 %160, label %149, label %161, !llvm.loop !30

161:                                              ; preds = %149, %142, %126
  ret void
}

define internal fastcc void @set_rows(ptr noundef readonly %0) unnamed_addr #2 {
  %2 = getelementptr inbounds i8, ptr %0, i64 8
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %16

5:                                                ; preds = %1
  %6 = load ptr, ptr %0, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 32
  %8 = getelementptr inbounds i8, ptr %0, i64 24
  %9 = getelementptr inbounds i8, ptr %6, i64 48
  %10 = getelementptr inbounds i8, ptr %6, i64 24
  %11 = getelementptr inbounds i8, ptr %6, i64 72
  br label %12

12:                                               ; preds = %5, %26
  %13 = phi i64 [ 0, %5 ], [ %27, %26 ]
  %14 = load i64, ptr %7, align 8
  %15 = icmp sgt i64 %14, 0
  br i1 %15, label %17, label %26

16:                                               ; preds = %26, %1
  ret void

17:                                               ; preds = %12, %30
  %18 = phi i64 [ %48, %30 ], [ %14, %12 ]
  %19 = phi i64 [ %47, %30 ], [ 0, %12 ]
  %20 = load i64, ptr %8, align 8
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %22, label %30

22:                                               ; preds = %17
  %23 = load ptr, ptr %9, align 8
  %24 = mul nuw nsw i64 %20, %13
  %25 = load ptr, ptr %10, align 8
  br label %50

26:                                               ; preds = %30, %12
  %27 = add nuw nsw i64 %13, 1
  %28 = load i64, ptr %2, align 8
  %29 = icmp slt i64 %27, %28
  br i1 %29, label %12, label %16, !llvm.loop !31

30:                                               ; preds = %50, %17
  %31 = phi <8 x double> [ zeroinitializer, %17 ], [ %64, %50 ]
  %32 = phi <8 x double> [ zeroinitializer, %17 ], [ %66, %50 ]
  %33 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %31)
  %34 = sitofp i64 %20 to double
  %35 = fmul double %34, 4.000000e+00
  %36 = fmul double %35, 0x3CB0000000000000
  %37 = insertelement <8 x double> poison, double %36, i64 0
  %38 = shufflevector <8 x double> %37, <8 x double> poison, <8 x i32> zeroinitializer
  %39 = fmul <8 x double> %32, %38
  %40 = fcmp ole <8 x double> %33, %39
  %41 = load ptr, ptr %11, align 8
  %42 = mul nsw i64 %18, %13
  %43 = add nsw i64 %42, %19
  %44 = select <8 x i1> %40, <8 x double> zeroinitializer, <8 x double> %31
  %45 = shl nsw i64 %43, 6
  %46 = getelementptr inbounds i8, ptr %41, i64 %45
  store <8 x double> %44, ptr %46, align 8
  %47 = add nuw nsw i64 %19, 1
  %48 = load i64, ptr %7, align 8
  %49 = icmp slt i64 %47, %48
  br i1 %49, label %17, label %26, !llvm.loop !32

50:                                               ; preds = %22, %50
  %51 = phi i64 [ 0, %22 ], [ %67, %50 ]
  %52 = phi <8 x double> [ zeroinitializer, %22 ], [ %66, %50 ]
  %53 = phi <8 x double> [ zeroinitializer, %22 ], [ %64, %50 ]
  %54 = add nuw nsw i64 %24, %51
  %55 = shl nsw i64 %54, 6
  %56 = getelementptr inbounds i8, ptr %23, i64 %55
  %57 = load <8 x double>, ptr %56, align 8
  %58 = mul nsw i64 %51, %18
  %59 = add nsw i64 %58, %19
  %60 = shl nsw i64 %59, 6
  %61 = getelementptr inbounds i8, ptr %25, i64 %60
  %62 = load <8 x double>, ptr %61, align 8
  %63 = fmul <8 x double> %57, %62
  %64 = fadd <8 x double> %53, %63
  %65 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %63)
  %66 = fadd <8 x double> %52, %65
  %67 = add nuw nsw i64 %51, 1
  %68 = icmp eq i64 %67, %20
  br i1 %68, label %30, label %50, !llvm.loop !33
}

define internal fastcc void @divide_rows(ptr noundef %0, i64 noundef %1, ptr noundef readonly %2, i64 noundef %3) unnamed_addr #5 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %6, label %14

6:                                                ; preds = %4
  %7 = icmp sgt i64 %3, 0
  %8 = shl i64 %3, 6
  %9 = add i64 %8, 64
  br label %10

10:                                               ; preds = %6, %15
  %11 = phi i64 [ 0, %6 ], [ %16, %15 ]
  br i1 %7, label %12, label %15

12:                                               ; preds = %10
  %13 = mul nuw nsw i64 %11, %3
  br label %18

14:                                               ; preds = %15, %4
  ret void

15:                                               ; preds = %27, %10
  %16 = add nuw nsw i64 %11, 1
  %17 = icmp eq i64 %16, %1
  br i1 %17, label %14, label %10, !llvm.loop !34

18:                                               ; preds = %12, %27
  %19 = phi i64 [ 0, %12 ], [ %33, %27 ]
  %20 = add nuw nsw i64 %19, %13
  %21 = shl nsw i64 %20, 6
  %22 = getelementptr inbounds i8, ptr %0, i64 %21
  %23 = load <8 x double>, ptr %22, align 8
  %24 = icmp eq i64 %19, 0
  br i1 %24, label %27, label %25

25:                                               ; preds = %18
  %26 = mul nuw nsw i64 %19, %3
  br label %35

27:                                               ; preds = %35, %18
  %28 = phi <8 x double> [ %23, %18 ], [ %47, %35 ]
  %29 = mul i64 %9, %19
  %30 = getelementptr inbounds i8, ptr %2, i64 %29
  %31 = load <8 x double>, ptr %30, align 8
  %32 = fdiv <8 x double> %28, %31
  store <8 x double> %32, ptr %22, align 8
  %33 = add nuw nsw i64 %19, 1
  %34 = icmp eq i64 %33, %3
  br i1 %34, label %15, label %18, !llvm.loop !35

35:                                               ; preds = %25, %35
  %36 = phi i64 [ 0, %25 ], [ %48, %35 ]
  %37 = phi <8 x double> [ %23, %25 ], [ %47, %35 ]
  %38 = add nuw nsw i64 %36, %26
  %39 = shl nsw i64 %38, 6
  %40 = getelementptr inbounds i8, ptr %2, i64 %39
  %41 = load <8 x double>, ptr %40, align 8
  %42 = add nuw nsw i64 %36, %13
  %43 = shl nsw i64 %42, 6
  %44 = getelementptr inbounds i8, ptr %0, i64 %43
  %45 = load <8 x double>, ptr %44, align 8
  %46 = fmul <8 x double> %41, %45
  %47 = fsub <8 x double> %37, %46
  %48 = add nuw nsw i64 %36, 1
  %49 = icmp eq i64 %48, %19
  br i1 %49, label %27, label %35, !llvm.loop !36
}

define internal fastcc void @minimum_norm(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, i64 noundef %3) unnamed_addr #2 {
  %5 = getelementptr inbounds i8, ptr %0, i64 8
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 16
  %8 = load i64, ptr %7, align 8
  %9 = sdiv i64 %8, 8
  %10 = load ptr, ptr %0, align 8
  %11 = getelementptr inbounds i8, ptr %1, i64 120
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %1, i64 144
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %1, i64 168
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %1, i64 192
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %1, i64 216
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds i8, ptr %1, i64 264
  %22 = load ptr, ptr %21, align 8
  %23 = trunc i64 %3 to i8
  %24 = bitcast i8 %23 to <8 x i1>
  %25 = sext <8 x i1> %24 to <8 x i64>
  %26 = icmp sgt i64 %8, 7
  br i1 %26, label %33, label %27

27:                                               ; preds = %33, %4
  %28 = icmp sgt i64 %6, 0
  br i1 %28, label %29, label %39

29:                                               ; preds = %27
  %30 = shl i64 %9, 6
  %31 = icmp sgt i64 %8, 7
  %32 = icmp sgt i64 %8, 7
  br label %52

33:                                               ; preds = %4, %33
  %34 = phi i64 [ %37, %33 ], [ 0, %4 ]
  %35 = shl nsw i64 %34, 6
  %36 = getelementptr inbounds i8, ptr %12, i64 %35
  store <8 x double> zeroinitializer, ptr %36, align 8
  %37 = add nuw nsw i64 %34, 1
  %38 = icmp eq i64 %37, %9
  br i1 %38, label %27, label %33, !llvm.loop !37

39:                                               ; preds = %82, %27
  %40 = icmp sgt i64 %2, 0
  br i1 %40, label %41, label %272

41:                                               ; preds = %39
  %42 = icmp sgt i64 %6, 0
  %43 = shl i64 %9, 6
  %44 = icmp sgt i64 %8, 7
  %45 = icmp sgt i64 %6, 0
  %46 = icmp sgt i64 %8, 7
  %47 = icmp sgt i64 %8, 7
  %48 = icmp sgt i64 %6, 0
  %49 = shl i64 %9, 6
  %50 = icmp sgt i64 %8, 7
  %51 = icmp sgt i64 %8, 7
  br label %93

52:                                               ; preds = %29, %82
  %53 = phi i64 [ 0, %29 ], [ %83, %82 ]
  %54 = mul i64 %30, %53
  %55 = getelementptr inbounds i8, ptr %10, i64 %54
  br i1 %31, label %56, label %66

56:                                               ; preds = %52, %56
  %57 = phi i64 [ %64, %56 ], [ 0, %52 ]
  %58 = phi <8 x double> [ %63, %56 ], [ zeroinitializer, %52 ]
  %59 = shl nsw i64 %57, 6
  %60 = getelementptr inbounds i8, ptr %55, i64 %59
  %61 = load <8 x double>, ptr %60, align 8
  %62 = fmul <8 x double> %61, %61
  %63 = fadd <8 x double> %58, %62
  %64 = add nuw nsw i64 %57, 1
  %65 = icmp eq i64 %64, %9
  br i1 %65, label %66, label %56, !llvm.loop !25

66:                                               ; preds = %56, %52
  %67 = phi <8 x double> [ zeroinitializer, %52 ], [ %63, %56 ]
  %68 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %67)
  %69 = fcmp ogt <8 x double> %67, zeroinitializer
  %70 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %68
  %71 = select <8 x i1> %69, <8 x double> %70, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %72 = select <8 x i1> %69, <8 x double> %68, <8 x double> zeroinitializer
  %73 = shl nsw i64 %53, 6
  %74 = getelementptr inbounds i8, ptr %18, i64 %73
  store <8 x double> %72, ptr %74, align 8
  %75 = getelementptr inbounds i8, ptr %20, i64 %73
  %76 = load <8 x double>, ptr %75, align 8
  %77 = select <8 x i1> %24, <8 x double> zeroinitializer, <8 x double> %76
  store <8 x double> %77, ptr %75, align 8
  %78 = getelementptr inbounds i8, ptr %16, i64 %73
  store <8 x double> %71, ptr %78, align 8
  %79 = getelementptr inbounds i8, ptr %14, i64 %73
  %80 = load <8 x double>, ptr %79, align 8
  %81 = fmul <8 x double> %71, %80
  store <8 x double> %81, ptr %79, align 8
  br i1 %32, label %85, label %82

82:                                               ; preds = %85, %66
  %83 = add nuw nsw i64 %53, 1
  %84 = icmp eq i64 %83, %6
  br i1 %84, label %39, label %52, !llvm.loop !38

85:                                               ; preds = %66, %85
  %86 = phi i64 [ %91, %85 ], [ 0, %66 ]
  %87 = shl nsw i64 %86, 6
  %88 = getelementptr inbounds i8, ptr %55, i64 %87
  %89 = load <8 x double>, ptr %88, align 8
  %90 = fmul <8 x double> %71, %89
  store <8 x double> %90, ptr %88, align 8
  %91 = add nuw nsw i64 %86, 1
  %92 = icmp eq i64 %91, %9
  br i1 %92, label %82, label %85, !llvm.loop !39

93:                                               ; preds = %267, %41
  %94 = phi <8 x i64> [ %25, %41 ], [ %101, %267 ]
  %95 = phi <8 x double> [ zeroinitializer, %41 ], [ %268, %267 ]
  %96 = phi i64 [ 0, %41 ], [ %269, %267 ]
  br i1 %42, label %105, label %97

97:                                               ; preds = %147, %93
  %98 = phi <8 x double> [ <double 0x3BC79CA10C924224, double 0x3BC79CA10C924224, double 0x3BC79CA10C924224, double 0x3BC79CA10C924224, double 0x3BC79CA10C924224, double 0x3BC79CA10C924224, double 0x3BC79CA10C924224, double 0x3BC79CA10C924224>, %93 ], [ %148, %147 ]
  %99 = phi <8 x double> [ <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>, %93 ], [ %149, %147 ]
  %100 = fcmp oge <8 x double> %99, zeroinitializer
  %101 = select <8 x i1> %100, <8 x i64> %94, <8 x i64> zeroinitializer
  %102 = icmp ne <8 x i64> %101, zeroinitializer
  %103 = bitcast <8 x i1> %102 to i8
  %104 = icmp eq i8 %103, 0
  br i1 %104, label %267, label %152

105:                                              ; preds = %93, %147
  %106 = phi <8 x double> [ %149, %147 ], [ <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>, %93 ]
  %107 = phi <8 x double> [ %148, %147 ], [ <double 0x3BC79CA10C924224, double 0x3BC79CA10C924224, double 0x3BC79CA10C924224, double 0x3BC79CA10C924224, double 0x3BC79CA10C924224, double 0x3BC79CA10C924224, double 0x3BC79CA10C924224, double 0x3BC79CA10C924224>, %93 ]
  %108 = phi i64 [ %150, %147 ], [ 0, %93 ]
  %109 = phi <8 x i64> [ %115, %147 ], [ %94, %93 ]
  %110 = icmp eq i64 %108, %2
  br i1 %110, label %111, label %114

111:                                              ; preds = %105
  %112 = fcmp ole <8 x double> %107, <double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04, double 1.000000e-04>
  %113 = select <8 x i1> %112, <8 x i64> %109, <8 x i64> zeroinitializer
  br label %114

114:                                              ; preds = %111, %105
  %115 = phi <8 x i64> [ %113, %111 ], [ %109, %105 ]
  %116 = shl nsw i64 %108, 6
  %117 = getelementptr inbounds i8, ptr %20, i64 %116
  %118 = load <8 x double>, ptr %117, align 8
  %119 = fcmp oeq <8 x double> %118, zeroinitializer
  %120 = select <8 x i1> %119, <8 x i64> %115, <8 x i64> zeroinitializer
  %121 = icmp ne <8 x i64> %120, zeroinitializer
  %122 = bitcast <8 x i1> %121 to i8
  %123 = icmp eq i8 %122, 0
  br i1 %123, label %147, label %124

124:                                              ; preds = %114
  %125 = mul i64 %43, %108
  %126 = getelementptr inbounds i8, ptr %10, i64 %125
  br i1 %44, label %127, label %137

127:                                              ; preds = %124, %127
  %128 = phi i64 [ %135, %127 ], [ 0, %124 ]
  %129 = phi <8 x double> [ %134, %127 ], [ zeroinitializer, %124 ]
  %130 = shl nsw i64 %128, 6
  %131 = getelementptr inbounds i8, ptr %126, i64 %130
  %132 = load <8 x double>, ptr %131, align 8
  %133 = fmul <8 x double> %132, %132
  %134 = fadd <8 x double> %129, %133
  %135 = add nuw nsw i64 %128, 1
  %136 = icmp eq i64 %135, %9
  br i1 %136, label %137, label %127, !llvm.loop !25

137:                                              ; preds = %127, %124
  %138 = phi <8 x double> [ zeroinitializer, %124 ], [ %134, %127 ]
  %139 = fcmp ogt <8 x double> %138, %107
  %140 = uitofp nneg i64 %108 to double
  %141 = insertelement <8 x double> poison, double %140, i64 0
  %142 = icmp slt <8 x i64> %120, zeroinitializer
  %143 = and <8 x i1> %139, %142
  %144 = shufflevector <8 x double> %141, <8 x double> poison, <8 x i32> zeroinitializer
  %145 = select <8 x i1> %143, <8 x double> %144, <8 x double> %106
  %146 = select <8 x i1> %143, <8 x double> %138, <8 x double> %107
  br label %147

147:                                              ; preds = %137, %114
  %148 = phi <8 x double> [ %107, %114 ], [ %146, %137 ]
  %149 = phi <8 x double> [ %106, %114 ], [ %145, %137 ]
  %150 = add nuw nsw i64 %108, 1
  %151 = icmp eq i64 %150, %6
  br i1 %151, label %97, label %105, !llvm.loop !40

152:                                              ; preds = %97
  %153 = fadd <8 x double> %95, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %154 = icmp slt <8 x i64> %101, zeroinitializer
  %155 = select <8 x i1> %154, <8 x double> %153, <8 x double> %95
  %156 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %98)
  br i1 %45, label %159, label %157

157:                                              ; preds = %202, %152
  %158 = phi <8 x double> [ zeroinitializer, %152 ], [ %203, %202 ]
  br i1 %47, label %207, label %206

159:                                              ; preds = %152, %202
  %160 = phi i64 [ %204, %202 ], [ 0, %152 ]
  %161 = phi <8 x double> [ %203, %202 ], [ zeroinitializer, %152 ]
  %162 = uitofp nneg i64 %160 to double
  %163 = insertelement <8 x double> poison, double %162, i64 0
  %164 = shufflevector <8 x double> %163, <8 x double> poison, <8 x i32> zeroinitializer
  %165 = fcmp oeq <8 x double> %99, %164
  %166 = select <8 x i1> %165, <8 x i64> %101, <8 x i64> zeroinitializer
  %167 = icmp ne <8 x i64> %166, zeroinitializer
  %168 = bitcast <8 x i1> %167 to i8
  %169 = icmp eq i8 %168, 0
  br i1 %169, label %202, label %170

170:                                              ; preds = %159
  %171 = shl nsw i64 %160, 6
  %172 = getelementptr inbounds i8, ptr %14, i64 %171
  %173 = load <8 x double>, ptr %172, align 8
  %174 = fdiv <8 x double> %173, %156
  %175 = icmp slt <8 x i64> %166, zeroinitializer
  %176 = select <8 x i1> %175, <8 x double> %174, <8 x double> %161
  %177 = bitcast <8 x double> %173 to <8 x i64>
  %178 = select <8 x i1> %175, <8 x i64> zeroinitializer, <8 x i64> %177
  store <8 x i64> %178, ptr %172, align 8
  %179 = getelementptr inbounds i8, ptr %18, i64 %171
  %180 = load <8 x double>, ptr %179, align 8
  %181 = fmul <8 x double> %156, %180
  %182 = getelementptr inbounds i8, ptr %20, i64 %171
  %183 = load <8 x i64>, ptr %182, align 8
  %184 = bitcast <8 x double> %181 to <8 x i64>
  %185 = select <8 x i1> %175, <8 x i64> %184, <8 x i64> %183
  store <8 x i64> %185, ptr %182, align 8
  br i1 %46, label %186, label %202

186:                                              ; preds = %170
  %187 = mul nuw nsw i64 %160, %9
  br label %188

188:                                              ; preds = %186, %188
  %189 = phi i64 [ 0, %186 ], [ %200, %188 ]
  %190 = add nuw nsw i64 %189, %187
  %191 = shl nsw i64 %190, 6
  %192 = getelementptr inbounds i8, ptr %10, i64 %191
  %193 = load <8 x double>, ptr %192, align 8
  %194 = fdiv <8 x double> %193, %156
  %195 = shl nsw i64 %189, 6
  %196 = getelementptr inbounds i8, ptr %22, i64 %195
  %197 = load <8 x i64>, ptr %196, align 8
  %198 = bitcast <8 x double> %194 to <8 x i64>
  %199 = select <8 x i1> %175, <8 x i64> %198, <8 x i64> %197
  store <8 x i64> %199, ptr %196, align 8
  %200 = add nuw nsw i64 %189, 1
  %201 = icmp eq i64 %200, %9
  br i1 %201, label %202, label %188, !llvm.loop !41

202:                                              ; preds = %188, %170, %159
  %203 = phi <8 x double> [ %161, %159 ], [ %176, %170 ], [ %176, %188 ]
  %204 = add nuw nsw i64 %160, 1
  %205 = icmp eq i64 %204, %6
  br i1 %205, label %157, label %159, !llvm.loop !42

206:                                              ; preds = %207, %157
  br i1 %48, label %219, label %267

207:                                              ; preds = %157, %207
  %208 = phi i64 [ %217, %207 ], [ 0, %157 ]
  %209 = shl nsw i64 %208, 6
  %210 = getelementptr inbounds i8, ptr %12, i64 %209
  %211 = load <8 x double>, ptr %210, align 8
  %212 = getelementptr inbounds i8, ptr %22, i64 %209
  %213 = load <8 x double>, ptr %212, align 8
  %214 = fmul <8 x double> %158, %213
  %215 = fadd <8 x double> %211, %214
  %216 = select <8 x i1> %154, <8 x double> %215, <8 x double> %211
  store <8 x double> %216, ptr %210, align 8
  %217 = add nuw nsw i64 %208, 1
  %218 = icmp eq i64 %217, %9
  br i1 %218, label %206, label %207, !llvm.loop !43

219:                                              ; preds = %206, %264
  %220 = phi i64 [ %265, %264 ], [ 0, %206 ]
  %221 = mul i64 %49, %220
  %222 = getelementptr inbounds i8, ptr %10, i64 %221
  %223 = shl nsw i64 %220, 6
  %224 = getelementptr inbounds i8, ptr %20, i64 %223
  %225 = load <8 x double>, ptr %224, align 8
  %226 = fcmp oeq <8 x double> %225, zeroinitializer
  %227 = select <8 x i1> %226, <8 x i64> %101, <8 x i64> zeroinitializer
  %228 = icmp ne <8 x i64> %227, zeroinitializer
  %229 = bitcast <8 x i1> %228 to i8
  %230 = icmp eq i8 %229, 0
  br i1 %230, label %264, label %231

231:                                              ; preds = %219
  br i1 %50, label %232, label %244

232:                                              ; preds = %231, %232
  %233 = phi i64 [ %242, %232 ], [ 0, %231 ]
  %234 = phi <8 x double> [ %241, %232 ], [ zeroinitializer, %231 ]
  %235 = shl nsw i64 %233, 6
  %236 = getelementptr inbounds i8, ptr %222, i64 %235
  %237 = load <8 x double>, ptr %236, align 8
  %238 = getelementptr inbounds i8, ptr %22, i64 %235
  %239 = load <8 x double>, ptr %238, align 8
  %240 = fmul <8 x double> %237, %239
  %241 = fadd <8 x double> %234, %240
  %242 = add nuw nsw i64 %233, 1
  %243 = icmp eq i64 %242, %9
  br i1 %243, label %244, label %232, !llvm.loop !25

244:                                              ; preds = %232, %231
  %245 = phi <8 x double> [ zeroinitializer, %231 ], [ %241, %232 ]
  %246 = getelementptr inbounds i8, ptr %14, i64 %223
  %247 = load <8 x double>, ptr %246, align 8
  %248 = fmul <8 x double> %158, %245
  %249 = fsub <8 x double> %247, %248
  %250 = icmp slt <8 x i64> %227, zeroinitializer
  %251 = select <8 x i1> %250, <8 x double> %249, <8 x double> %247
  store <8 x double> %251, ptr %246, align 8
  br i1 %51, label %252, label %264

252:                                              ; preds = %244, %252
  %253 = phi i64 [ %262, %252 ], [ 0, %244 ]
  %254 = shl nsw i64 %253, 6
  %255 = getelementptr inbounds i8, ptr %222, i64 %254
  %256 = load <8 x double>, ptr %255, align 8
  %257 = getelementptr inbounds i8, ptr %22, i64 %254
  %258 = load <8 x double>, ptr %257, align 8
  %259 = fmul <8 x double> %245, %258
  %260 = fsub <8 x double> %256, %259
  %261 = select <8 x i1> %250, <8 x double> %260, <8 x double> %256
  store <8 x double> %261, ptr %255, align 8
  %262 = add nuw nsw i64 %253, 1
  %263 = icmp eq i64 %262, %9
  br i1 %263, label %264, label %252, !llvm.loop !44

264:                                              ; preds = %252, %244, %219
  %265 = add nuw nsw i64 %220, 1
  %266 = icmp eq i64 %265, %6
  br i1 %266, label %267, label %219, !llvm.loop !45

267:                                              ; preds = %264, %206, %97
  %268 = phi <8 x double> [ %95, %97 ], [ %155, %206 ], [ %155, %264 ]
  %269 = add nuw nsw i64 %96, 1
  %270 = icmp eq i64 %269, %2
  %271 = select i1 %104, i1 true, i1 %270
  br i1 %271, label %272, label %93, !llvm.loop !46

272:                                              ; preds = %267, %39
  %273 = phi <8 x double> [ zeroinitializer, %39 ], [ %268, %267 ]
  %274 = icmp sgt i64 %6, %2
  %275 = select i1 %274, i64 %2, i64 -1
  %276 = sitofp i64 %275 to double
  %277 = insertelement <8 x double> poison, double %276, i64 0
  %278 = shufflevector <8 x double> %277, <8 x double> poison, <8 x i32> zeroinitializer
  %279 = fcmp oeq <8 x double> %273, %278
  %280 = icmp sgt i64 %6, 0
  br i1 %280, label %282, label %281

281:                                              ; preds = %282, %272
  ret void

282:                                              ; preds = %272, %282
  %283 = phi i64 [ %291, %282 ], [ 0, %272 ]
  %284 = shl nsw i64 %283, 6
  %285 = getelementptr inbounds i8, ptr %14, i64 %284
  %286 = load <8 x double>, ptr %285, align 8
  %287 = getelementptr inbounds i8, ptr %16, i64 %284
  %288 = load <8 x double>, ptr %287, align 8
  %289 = fdiv <8 x double> %286, %288
  %290 = select <8 x i1> %279, <8 x double> zeroinitializer, <8 x double> %289
  store <8 x double> %290, ptr %285, align 8
  %291 = add nuw nsw i64 %283, 1
  %292 = icmp eq i64 %291, %6
  br i1 %292, label %281, label %282, !llvm.loop !47
}

declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #4

define internal fastcc void @divide_transposed(ptr noundef readonly %0, i64 noundef %1, ptr noundef %2) unnamed_addr #5 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %5, label %8

5:                                                ; preds = %3
  %6 = shl i64 %1, 6
  %7 = add i64 %6, 64
  br label %9

8:                                                ; preds = %16, %3
  ret void

9:                                                ; preds = %5, %16
  %10 = phi i64 [ %1, %5 ], [ %11, %16 ]
  %11 = add nsw i64 %10, -1
  %12 = shl nsw i64 %11, 6
  %13 = getelementptr inbounds i8, ptr %2, i64 %12
  %14 = load <8 x double>, ptr %13, align 8
  %15 = icmp slt i64 %10, %1
  br i1 %15, label %23, label %16

16:                                               ; preds = %23, %9
  %17 = phi <8 x double> [ %14, %9 ], [ %35, %23 ]
  %18 = mul i64 %7, %11
  %19 = getelementptr inbounds i8, ptr %0, i64 %18
  %20 = load <8 x double>, ptr %19, align 8
  %21 = fdiv <8 x double> %17, %20
  store <8 x double> %21, ptr %13, align 8
  %22 = icmp sgt i64 %10, 1
  br i1 %22, label %9, label %8, !llvm.loop !48

23:                                               ; preds = %9, %23
  %24 = phi i64 [ %36, %23 ], [ %10, %9 ]
  %25 = phi <8 x double> [ %35, %23 ], [ %14, %9 ]
  %26 = mul nsw i64 %24, %1
  %27 = add nuw nsw i64 %26, %11
  %28 = shl nsw i64 %27, 6
  %29 = getelementptr inbounds i8, ptr %0, i64 %28
  %30 = load <8 x double>, ptr %29, align 8
  %31 = shl nsw i64 %24, 6
  %32 = getelementptr inbounds i8, ptr %2, i64 %31
  %33 = load <8 x double>, ptr %32, align 8
  %34 = fmul <8 x double> %30, %33
  %35 = fsub <8 x double> %25, %34
  %36 = add nuw nsw i64 %24, 1
  %37 = icmp eq i64 %36, %1
  br i1 %37, label %16, label %23, !llvm.loop !49
}

define internal fastcc void @factorise(ptr noundef %0, i64 noundef %1) unnamed_addr #5 {
  %3 = icmp sgt i64 %1, 0
  br i1 %3, label %4, label %14

4:                                                ; preds = %2
  %5 = sitofp i64 %1 to double
  %6 = fmul double %5, 4.000000e+00
  %7 = fmul double %6, 0x3CB0000000000000
  %8 = insertelement <8 x double> poison, double %7, i64 0
  %9 = shufflevector <8 x double> %8, <8 x double> poison, <8 x i32> zeroinitializer
  br label %23

10:                                               ; preds = %62, %32
  %11 = icmp slt i64 %40, %1
  %12 = icmp ne i64 %38, 0
  %13 = select i1 %11, i1 %12, i1 false
  br i1 %13, label %23, label %14, !llvm.loop !50

14:                                               ; preds = %10, %2
  %15 = phi i64 [ 255, %2 ], [ %38, %10 ]
  %16 = icmp ne i64 %15, 255
  %17 = icmp sgt i64 %1, 0
  %18 = and i1 %16, %17
  br i1 %18, label %19, label %102

19:                                               ; preds = %14
  %20 = trunc nuw i64 %15 to i8
  %21 = xor i8 %20, -1
  %22 = bitcast i8 %21 to <8 x i1>
  br label %82

23:                                               ; preds = %4, %10
  %24 = phi i64 [ 0, %4 ], [ %40, %10 ]
  %25 = phi i64 [ 255, %4 ], [ %38, %10 ]
  %26 = mul nuw nsw i64 %24, %1
  %27 = add nuw nsw i64 %26, %24
  %28 = shl nsw i64 %27, 6
  %29 = getelementptr inbounds i8, ptr %0, i64 %28
  %30 = load <8 x double>, ptr %29, align 8
  %31 = icmp eq i64 %24, 0
  br i1 %31, label %32, label %44

32:                                               ; preds = %44, %23
  %33 = phi <8 x double> [ %30, %23 ], [ %52, %44 ]
  %34 = fmul <8 x double> %9, %30
  %35 = fcmp ogt <8 x double> %33, %34
  %36 = bitcast <8 x i1> %35 to i8
  %37 = zext i8 %36 to i64
  %38 = and i64 %25, %37
  %39 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %33)
  store <8 x double> %39, ptr %29, align 8
  %40 = add nuw nsw i64 %24, 1
  %41 = icmp slt i64 %40, %1
  br i1 %41, label %42, label %10

42:                                               ; preds = %32
  %43 = icmp eq i64 %24, 0
  br label %55

44:                                               ; preds = %23, %44
  %45 = phi i64 [ %53, %44 ], [ 0, %23 ]
  %46 = phi <8 x double> [ %52, %44 ], [ %30, %23 ]
  %47 = add nuw nsw i64 %45, %26
  %48 = shl nsw i64 %47, 6
  %49 = getelementptr inbounds i8, ptr %0, i64 %48
  %50 = load <8 x double>, ptr %49, align 8
  %51 = fmul <8 x double> %50, %50
  %52 = fsub <8 x double> %46, %51
  %53 = add nuw nsw i64 %45, 1
  %54 = icmp eq i64 %53, %24
  br i1 %54, label %32, label %44, !llvm.loop !51

55:                                               ; preds = %42, %62
  %56 = phi i64 [ %40, %42 ], [ %65, %62 ]
  %57 = mul nuw nsw i64 %56, %1
  %58 = add nuw nsw i64 %57, %24
  %59 = shl nsw i64 %58, 6
  %60 = getelementptr inbounds i8, ptr %0, i64 %59
  %61 = load <8 x double>, ptr %60, align 8
  br i1 %43, label %62, label %67

62:                                               ; preds = %67, %55
  %63 = phi <8 x double> [ %61, %55 ], [ %79, %67 ]
  %64 = fdiv <8 x double> %63, %39
  store <8 x double> %64, ptr %60, align 8
  %65 = add nuw nsw i64 %56, 1
  %66 = icmp slt i64 %65, %1
  br i1 %66, label %55, label %10, !llvm.loop !52

67:                                               ; preds = %55, %67
  %68 = phi i64 [ %80, %67 ], [ 0, %55 ]
  %69 = phi <8 x double> [ %79, %67 ], [ %61, %55 ]
  %70 = add nuw nsw i64 %68, %57
  %71 = shl nsw i64 %70, 6
  %72 = getelementptr inbounds i8, ptr %0, i64 %71
  %73 = load <8 x double>, ptr %72, align 8
  %74 = add nuw nsw i64 %68, %26
  %75 = shl nsw i64 %74, 6
  %76 = getelementptr inbounds i8, ptr %0, i64 %75
  %77 = load <8 x double>, ptr %76, align 8
  %78 = fmul <8 x double> %73, %77
  %79 = fsub <8 x double> %69, %78
  %80 = add nuw nsw i64 %68, 1
  %81 = icmp eq i64 %80, %24
  br i1 %81, label %62, label %67, !llvm.loop !53

82:                                               ; preds = %19, %85
  %83 = phi i64 [ 0, %19 ], [ %86, %85 ]
  %84 = mul nuw nsw i64 %83, %1
  br label %88

85:                                               ; preds = %88
  %86 = add nuw nsw i64 %83, 1
  %87 = icmp eq i64 %86, %1
  br i1 %87, label %102, label %82, !llvm.loop !6

88:                                               ; preds = %82, %88
  %89 = phi i64 [ 0, %82 ], [ %100, %88 ]
  %90 = add nuw nsw i64 %89, %84
  %91 = icmp eq i64 %83, %89
  %92 = select i1 %91, double 1.000000e+00, double 0.000000e+00
  %93 = insertelement <8 x double> poison, double %92, i64 0
  %94 = shl nsw i64 %90, 6
  %95 = getelementptr inbounds i8, ptr %0, i64 %94
  %96 = load <8 x i64>, ptr %95, align 8
  %97 = bitcast <8 x double> %93 to <8 x i64>
  %98 = shufflevector <8 x i64> %97, <8 x i64> poison, <8 x i32> zeroinitializer
  %99 = select <8 x i1> %22, <8 x i64> %98, <8 x i64> %96
  store <8 x i64> %99, ptr %95, align 8
  %100 = add nuw nsw i64 %89, 1
  %101 = icmp eq i64 %100, %1
  br i1 %101, label %85, label %88, !llvm.loop !9

102:                                              ; preds = %85, %14
  ret void
}

declare void @llvm.experimental.noalias.scope.decl(metadata) #6

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind willreturn memory(none) }
attributes #5 = { noinline nounwind }
attributes #6 = { nounwind willreturn }
attributes #7 = { nounwind }
attributes #8 = { nounwind }
attributes #9 = { nounwind }


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
!51 = distinct !{!51, !7, !8}
!52 = distinct !{!52, !7, !8}
!53 = distinct !{!53, !7, !8}
