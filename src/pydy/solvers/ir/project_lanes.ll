; sources 037e54ac04a487705df9c13cd2e94e684034331044bf2c927da0e221bc7fd3ac
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Held = type { ptr, i64, i64, i64, i64, i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

define i64 @project_lanes(ptr noundef readonly %0, ptr noundef readonly %1, ptr noundef %2, ptr noundef readonly %3, i64 noundef %4) #0 {
  %6 = alloca %struct.Held, align 8
  %7 = load <8 x double>, ptr %1, align 8
  tail call void @llvm.experimental.noalias.scope.decl(metadata !3)
  %8 = getelementptr inbounds i8, ptr %0, i64 1680
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
  %36 = getelementptr inbounds i8, ptr %0, i64 1728
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
  %69 = load ptr, ptr %66, align 8
  %70 = getelementptr inbounds i8, ptr %69, i64 40
  %71 = load i64, ptr %70, align 8
  %72 = icmp eq i64 %71, 0
  br i1 %72, label %74, label %73

73:                                               ; preds = %5
  tail call fastcc void @settle(ptr noundef nonnull %66) #8
  br label %74

74:                                               ; preds = %73, %5
  %75 = getelementptr inbounds i8, ptr %0, i64 296
  %76 = load i64, ptr %75, align 8
  %77 = icmp sgt i64 %76, 0
  br i1 %77, label %78, label %79

78:                                               ; preds = %74
  tail call fastcc void @sample(ptr noundef nonnull %66) #8
  br label %79

79:                                               ; preds = %74, %78
  %80 = load ptr, ptr %6, align 8
  %81 = load ptr, ptr %80, align 8
  %82 = load i64, ptr %22, align 8
  %83 = icmp sgt i64 %82, 0
  br i1 %83, label %84, label %101

84:                                               ; preds = %79, %87
  %85 = phi i64 [ %88, %87 ], [ 0, %79 ]
  %86 = mul nuw nsw i64 %85, %82
  br label %90

87:                                               ; preds = %90
  %88 = add nuw nsw i64 %85, 1
  %89 = icmp eq i64 %88, %82
  br i1 %89, label %101, label %84, !llvm.loop !6

90:                                               ; preds = %84, %90
  %91 = phi i64 [ 0, %84 ], [ %99, %90 ]
  %92 = add nuw nsw i64 %91, %86
  %93 = icmp eq i64 %85, %91
  %94 = select i1 %93, double 1.000000e+00, double 0.000000e+00
  %95 = insertelement <8 x double> poison, double %94, i64 0
  %96 = shufflevector <8 x double> %95, <8 x double> poison, <8 x i32> zeroinitializer
  %97 = shl nsw i64 %92, 6
  %98 = getelementptr inbounds i8, ptr %81, i64 %97
  store <8 x double> %96, ptr %98, align 8
  %99 = add nuw nsw i64 %91, 1
  %100 = icmp eq i64 %99, %82
  br i1 %100, label %87, label %90, !llvm.loop !9

101:                                              ; preds = %87, %79
  %102 = load i64, ptr %34, align 8
  %103 = load ptr, ptr %6, align 8
  %104 = getelementptr inbounds i8, ptr %103, i64 240
  %105 = load ptr, ptr %104, align 8
  %106 = load i64, ptr %13, align 8
  %107 = icmp sgt i64 %106, 0
  br i1 %107, label %158, label %108

108:                                              ; preds = %158, %101
  %109 = getelementptr inbounds i8, ptr %0, i64 168
  %110 = getelementptr inbounds i8, ptr %0, i64 192
  %111 = getelementptr inbounds i8, ptr %0, i64 1704
  %112 = load ptr, ptr %35, align 8
  %113 = load i64, ptr %34, align 8
  %114 = load ptr, ptr %8, align 8
  %115 = getelementptr inbounds i8, ptr %114, i64 8
  %116 = load i64, ptr %115, align 8
  %117 = load ptr, ptr %109, align 8
  %118 = load ptr, ptr %110, align 8
  %119 = load ptr, ptr %111, align 8
  %120 = inttoptr i64 %116 to ptr
  %121 = load ptr, ptr %120, align 8
  %122 = tail call i32 %121(ptr noundef %117, ptr noundef %2, ptr noundef %118, ptr noundef %119, ptr noundef %112) #9
  %123 = icmp slt i32 %122, 0
  br i1 %123, label %355, label %124

124:                                              ; preds = %108
  %125 = icmp eq i64 %30, %106
  %126 = load i64, ptr %13, align 8
  %127 = icmp sgt i64 %126, 0
  %128 = load ptr, ptr %35, align 8
  %129 = load ptr, ptr %42, align 8
  %130 = load ptr, ptr %6, align 8
  %131 = getelementptr inbounds i8, ptr %130, i64 216
  %132 = icmp ne ptr %65, null
  %133 = load i64, ptr %19, align 8
  %134 = load ptr, ptr %38, align 8
  %135 = load i64, ptr %28, align 8
  %136 = icmp slt i64 %135, %126
  %137 = icmp sgt i64 %126, 0
  %138 = icmp sgt i64 %133, 0
  %139 = getelementptr inbounds i8, ptr %0, i64 672
  %140 = getelementptr inbounds i8, ptr %0, i64 648
  %141 = select i1 %136, double 1.000000e-05, double 0x3CE0000000000000
  %142 = insertelement <8 x double> poison, double %141, i64 0
  %143 = shufflevector <8 x double> %142, <8 x double> poison, <8 x i32> zeroinitializer
  %144 = load ptr, ptr %42, align 8
  %145 = load i64, ptr %22, align 8
  %146 = add nsw i64 %145, %133
  %147 = sitofp i64 %146 to double
  %148 = insertelement <8 x double> poison, double %147, i64 0
  %149 = shufflevector <8 x double> %148, <8 x double> poison, <8 x i32> zeroinitializer
  %150 = icmp eq i64 %27, 1
  %151 = getelementptr inbounds i8, ptr %103, i64 8
  %152 = getelementptr inbounds i8, ptr %103, i64 16
  %153 = getelementptr inbounds i8, ptr %103, i64 24
  %154 = getelementptr inbounds i8, ptr %103, i64 32
  %155 = getelementptr inbounds i8, ptr %103, i64 40
  %156 = getelementptr inbounds i8, ptr %103, i64 144
  %157 = icmp sgt i64 %126, 0
  br label %176

158:                                              ; preds = %101, %158
  %159 = phi i64 [ %162, %158 ], [ 0, %101 ]
  %160 = shl nsw i64 %159, 6
  %161 = getelementptr inbounds i8, ptr %105, i64 %160
  store <8 x double> zeroinitializer, ptr %161, align 8
  %162 = add nuw nsw i64 %159, 1
  %163 = icmp eq i64 %162, %106
  br i1 %163, label %108, label %158, !llvm.loop !10

164:                                              ; preds = %352
  %165 = add nuw nsw i32 %180, 1
  %166 = load ptr, ptr %8, align 8
  %167 = getelementptr inbounds i8, ptr %166, i64 8
  %168 = load i64, ptr %167, align 8
  %169 = load ptr, ptr %109, align 8
  %170 = load ptr, ptr %110, align 8
  %171 = load ptr, ptr %111, align 8
  %172 = inttoptr i64 %168 to ptr
  %173 = load ptr, ptr %172, align 8
  %174 = tail call i32 %173(ptr noundef %169, ptr noundef %2, ptr noundef %170, ptr noundef %171, ptr noundef %112) #9
  %175 = icmp slt i32 %174, 0
  br i1 %175, label %355, label %176, !llvm.loop !11

176:                                              ; preds = %124, %164
  %177 = phi i64 [ undef, %124 ], [ %354, %164 ]
  %178 = phi i64 [ 0, %124 ], [ %303, %164 ]
  %179 = phi <8 x double> [ <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>, %124 ], [ %353, %164 ]
  %180 = phi i32 [ 0, %124 ], [ %165, %164 ]
  %181 = phi <8 x double> [ zeroinitializer, %124 ], [ %288, %164 ]
  %182 = phi i64 [ %113, %124 ], [ %301, %164 ]
  %183 = icmp eq i32 %180, 0
  %184 = select i1 %183, i1 true, i1 %125
  br i1 %127, label %197, label %185

185:                                              ; preds = %219, %176
  %186 = phi <8 x double> [ zeroinitializer, %176 ], [ %224, %219 ]
  %187 = phi <8 x i64> [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %176 ], [ %226, %219 ]
  %188 = icmp ne <8 x i64> %187, zeroinitializer
  %189 = bitcast <8 x i1> %188 to i8
  %190 = zext i8 %189 to i64
  %191 = xor i64 %190, -1
  %192 = and i64 %182, %191
  %193 = or i64 %192, %178
  %194 = and i1 %132, %183
  %195 = select i1 %194, i1 %137, i1 false
  %196 = select i1 %194, <8 x double> zeroinitializer, <8 x double> %181
  br i1 %195, label %229, label %287

197:                                              ; preds = %176, %219
  %198 = phi i64 [ %227, %219 ], [ 0, %176 ]
  %199 = phi <8 x i64> [ %226, %219 ], [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %176 ]
  %200 = phi <8 x double> [ %224, %219 ], [ zeroinitializer, %176 ]
  %201 = shl nsw i64 %198, 6
  %202 = getelementptr inbounds i8, ptr %128, i64 %201
  %203 = load <8 x double>, ptr %202, align 8
  %204 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %203)
  %205 = getelementptr inbounds i8, ptr %129, i64 %201
  %206 = load <8 x double>, ptr %205, align 8
  %207 = getelementptr inbounds i8, ptr %105, i64 %201
  %208 = load <8 x double>, ptr %207, align 8
  %209 = fcmp ogt <8 x double> %206, %208
  %210 = select <8 x i1> %209, <8 x double> %206, <8 x double> %208
  %211 = fmul <8 x double> %210, <double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000>
  %212 = fcmp une <8 x double> %203, zeroinitializer
  br i1 %184, label %219, label %213

213:                                              ; preds = %197
  %214 = load ptr, ptr %131, align 8
  %215 = getelementptr inbounds i8, ptr %214, i64 %201
  %216 = load <8 x double>, ptr %215, align 8
  %217 = fcmp ogt <8 x double> %216, zeroinitializer
  %218 = and <8 x i1> %217, %212
  br label %219

219:                                              ; preds = %213, %197
  %220 = phi <8 x i1> [ %212, %197 ], [ %218, %213 ]
  %221 = fdiv <8 x double> %204, %211
  %222 = fcmp ogt <8 x double> %221, %200
  %223 = select <8 x i1> %220, <8 x i1> %222, <8 x i1> zeroinitializer
  %224 = select <8 x i1> %223, <8 x double> %221, <8 x double> %200
  %225 = fcmp one <8 x double> %204, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %226 = select <8 x i1> %225, <8 x i64> %199, <8 x i64> zeroinitializer
  %227 = add nuw nsw i64 %198, 1
  %228 = icmp eq i64 %227, %126
  br i1 %228, label %185, label %197, !llvm.loop !12

229:                                              ; preds = %185, %236
  %230 = phi <8 x double> [ %253, %236 ], [ zeroinitializer, %185 ]
  %231 = phi i64 [ %254, %236 ], [ 0, %185 ]
  br i1 %138, label %232, label %236

232:                                              ; preds = %229
  %233 = mul nuw nsw i64 %231, %133
  %234 = load ptr, ptr %139, align 8
  %235 = load ptr, ptr %140, align 8
  br label %256

236:                                              ; preds = %256, %229
  %237 = phi <8 x double> [ zeroinitializer, %229 ], [ %284, %256 ]
  %238 = shl nsw i64 %231, 6
  %239 = getelementptr inbounds i8, ptr %144, i64 %238
  %240 = load <8 x double>, ptr %239, align 8
  %241 = fmul <8 x double> %143, %240
  %242 = fmul <8 x double> %237, %149
  %243 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %242)
  %244 = fmul <8 x double> %243, <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>
  %245 = fadd <8 x double> %241, %244
  %246 = fcmp ogt <8 x double> %237, zeroinitializer
  %247 = getelementptr inbounds i8, ptr %128, i64 %238
  %248 = load <8 x double>, ptr %247, align 8
  %249 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %248)
  %250 = fdiv <8 x double> %249, %245
  %251 = fcmp ogt <8 x double> %250, %230
  %252 = select <8 x i1> %246, <8 x i1> %251, <8 x i1> zeroinitializer
  %253 = select <8 x i1> %252, <8 x double> %250, <8 x double> %230
  %254 = add nuw nsw i64 %231, 1
  %255 = icmp eq i64 %254, %126
  br i1 %255, label %287, label %229, !llvm.loop !13

256:                                              ; preds = %232, %256
  %257 = phi <8 x double> [ zeroinitializer, %232 ], [ %284, %256 ]
  %258 = phi i64 [ 0, %232 ], [ %285, %256 ]
  %259 = add nuw nsw i64 %258, %233
  %260 = shl nsw i64 %259, 6
  %261 = getelementptr inbounds i8, ptr %134, i64 %260
  %262 = load <8 x double>, ptr %261, align 8
  %263 = shl nsw i64 %258, 6
  %264 = getelementptr inbounds i8, ptr %2, i64 %263
  %265 = load <8 x double>, ptr %264, align 8
  %266 = getelementptr inbounds i8, ptr %65, i64 %263
  %267 = load <8 x double>, ptr %266, align 8
  %268 = getelementptr inbounds double, ptr %234, i64 %258
  %269 = load double, ptr %268, align 8
  %270 = insertelement <8 x double> poison, double %269, i64 0
  %271 = shufflevector <8 x double> %270, <8 x double> poison, <8 x i32> zeroinitializer
  %272 = getelementptr inbounds double, ptr %235, i64 %258
  %273 = load double, ptr %272, align 8
  %274 = insertelement <8 x double> poison, double %273, i64 0
  %275 = shufflevector <8 x double> %274, <8 x double> poison, <8 x i32> zeroinitializer
  %276 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %267)
  %277 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %265)
  %278 = fcmp ogt <8 x double> %276, %277
  %279 = select <8 x i1> %278, <8 x double> %276, <8 x double> %277
  %280 = fmul <8 x double> %279, %275
  %281 = fadd <8 x double> %271, %280
  %282 = fmul <8 x double> %262, %281
  %283 = fmul <8 x double> %282, %282
  %284 = fadd <8 x double> %257, %283
  %285 = add nuw nsw i64 %258, 1
  %286 = icmp eq i64 %285, %133
  br i1 %286, label %236, label %256, !llvm.loop !14

287:                                              ; preds = %236, %185
  %288 = phi <8 x double> [ %196, %185 ], [ %253, %236 ]
  %289 = fcmp ole <8 x double> %186, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %290 = fmul <8 x double> %179, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %291 = fcmp oge <8 x double> %186, %290
  %292 = fcmp ole <8 x double> %186, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  %293 = and <8 x i1> %291, %292
  %294 = or <8 x i1> %293, %289
  %295 = bitcast <8 x i1> %294 to i8
  %296 = zext i8 %295 to i64
  %297 = or i64 %193, %296
  %298 = xor i64 %297, -1
  %299 = and i64 %182, %298
  %300 = icmp eq i32 %180, 9
  %301 = select i1 %300, i64 0, i64 %299
  %302 = select i1 %300, i64 %299, i64 0
  %303 = or i64 %302, %193
  store i64 %301, ptr %34, align 8
  %304 = icmp eq i64 %301, 0
  br i1 %304, label %352, label %305

305:                                              ; preds = %287
  br i1 %150, label %306, label %324

306:                                              ; preds = %305
  %307 = load i64, ptr %151, align 8
  %308 = load i64, ptr %152, align 8
  %309 = mul nsw i64 %308, %307
  %310 = icmp sgt i64 %309, 0
  br i1 %310, label %311, label %322

311:                                              ; preds = %306, %311
  %312 = phi i64 [ %317, %311 ], [ 0, %306 ]
  %313 = getelementptr inbounds double, ptr %55, i64 %312
  %314 = load double, ptr %313, align 8
  %315 = load ptr, ptr %103, align 8
  %316 = getelementptr inbounds double, ptr %315, i64 %312
  store double %314, ptr %316, align 8
  %317 = add nuw nsw i64 %312, 1
  %318 = load i64, ptr %151, align 8
  %319 = load i64, ptr %152, align 8
  %320 = mul nsw i64 %319, %318
  %321 = icmp slt i64 %317, %320
  br i1 %321, label %311, label %322, !llvm.loop !15

322:                                              ; preds = %311, %306
  %323 = load ptr, ptr %103, align 8
  tail call fastcc void @factorise(ptr noundef %323, i64 noundef %82) #8
  br label %324

324:                                              ; preds = %305, %322
  %325 = load i64, ptr %154, align 8
  %326 = load i64, ptr %155, align 8
  %327 = mul nsw i64 %326, %325
  %328 = icmp sgt i64 %327, 0
  br i1 %328, label %329, label %340

329:                                              ; preds = %324, %329
  %330 = phi i64 [ %335, %329 ], [ 0, %324 ]
  %331 = getelementptr inbounds double, ptr %49, i64 %330
  %332 = load double, ptr %331, align 8
  %333 = load ptr, ptr %153, align 8
  %334 = getelementptr inbounds double, ptr %333, i64 %330
  store double %332, ptr %334, align 8
  %335 = add nuw nsw i64 %330, 1
  %336 = load i64, ptr %154, align 8
  %337 = load i64, ptr %155, align 8
  %338 = mul nsw i64 %337, %336
  %339 = icmp slt i64 %335, %338
  br i1 %339, label %329, label %340, !llvm.loop !15

340:                                              ; preds = %329, %324
  %341 = load ptr, ptr %156, align 8
  br i1 %157, label %342, label %351

342:                                              ; preds = %340, %342
  %343 = phi i64 [ %349, %342 ], [ 0, %340 ]
  %344 = shl nsw i64 %343, 6
  %345 = getelementptr inbounds i8, ptr %112, i64 %344
  %346 = load <8 x double>, ptr %345, align 8
  %347 = fneg <8 x double> %346
  %348 = getelementptr inbounds i8, ptr %341, i64 %344
  store <8 x double> %347, ptr %348, align 8
  %349 = add nuw nsw i64 %343, 1
  %350 = icmp eq i64 %349, %126
  br i1 %350, label %351, label %342, !llvm.loop !16

351:                                              ; preds = %342, %340
  call fastcc void @move_positions(ptr noundef nonnull %6, ptr noundef %2) #8
  br label %352

352:                                              ; preds = %351, %287
  %353 = phi <8 x double> [ %186, %351 ], [ %179, %287 ]
  %354 = phi i64 [ %177, %351 ], [ %303, %287 ]
  br i1 %304, label %355, label %164

355:                                              ; preds = %352, %164, %108
  %356 = phi <8 x double> [ zeroinitializer, %108 ], [ %288, %164 ], [ %288, %352 ]
  %357 = phi i64 [ %102, %108 ], [ %354, %352 ], [ %102, %164 ]
  %358 = load i64, ptr %16, align 8
  %359 = icmp eq i64 %358, 0
  %360 = icmp eq i64 %357, %4
  %361 = select i1 %359, i1 true, i1 %360
  br i1 %361, label %367, label %362

362:                                              ; preds = %355
  %363 = icmp sgt i64 %358, 0
  br i1 %363, label %364, label %373

364:                                              ; preds = %362
  %365 = load ptr, ptr %35, align 8
  %366 = load i64, ptr %13, align 8
  br label %380

367:                                              ; preds = %355
  %368 = fcmp ogt <8 x double> %356, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %369 = bitcast <8 x i1> %368 to i8
  %370 = zext i8 %369 to i64
  %371 = and i64 %370, %4
  %372 = or i64 %371, %357
  br label %651

373:                                              ; preds = %380, %362
  %374 = phi <8 x double> [ zeroinitializer, %362 ], [ %388, %380 ]
  %375 = load i64, ptr %22, align 8
  %376 = mul nsw i64 %375, %358
  %377 = icmp sgt i64 %376, 0
  br i1 %377, label %378, label %391

378:                                              ; preds = %373
  %379 = load ptr, ptr %40, align 8
  br label %402

380:                                              ; preds = %364, %380
  %381 = phi i64 [ 0, %364 ], [ %389, %380 ]
  %382 = phi <8 x double> [ zeroinitializer, %364 ], [ %388, %380 ]
  %383 = add nsw i64 %366, %381
  %384 = shl nsw i64 %383, 6
  %385 = getelementptr inbounds i8, ptr %365, i64 %384
  %386 = load <8 x double>, ptr %385, align 8
  %387 = fmul <8 x double> %386, zeroinitializer
  %388 = fadd <8 x double> %382, %387
  %389 = add nuw nsw i64 %381, 1
  %390 = icmp eq i64 %389, %358
  br i1 %390, label %373, label %380, !llvm.loop !17

391:                                              ; preds = %402, %373
  %392 = phi <8 x double> [ %374, %373 ], [ %409, %402 ]
  %393 = fcmp oeq <8 x double> %392, zeroinitializer
  %394 = bitcast <8 x i1> %393 to i8
  %395 = zext i8 %394 to i64
  %396 = xor i64 %395, -1
  %397 = and i64 %396, %4
  %398 = or i64 %397, %357
  %399 = xor i64 %398, -1
  %400 = and i64 %399, %4
  store i64 %400, ptr %34, align 8
  %401 = icmp eq ptr %65, null
  br i1 %401, label %499, label %412

402:                                              ; preds = %378, %402
  %403 = phi i64 [ 0, %378 ], [ %410, %402 ]
  %404 = phi <8 x double> [ %374, %378 ], [ %409, %402 ]
  %405 = shl nsw i64 %403, 6
  %406 = getelementptr inbounds i8, ptr %379, i64 %405
  %407 = load <8 x double>, ptr %406, align 8
  %408 = fmul <8 x double> %407, zeroinitializer
  %409 = fadd <8 x double> %404, %408
  %410 = add nuw nsw i64 %403, 1
  %411 = icmp eq i64 %410, %376
  br i1 %411, label %391, label %402, !llvm.loop !18

412:                                              ; preds = %391
  %413 = load i64, ptr %19, align 8
  %414 = load ptr, ptr %35, align 8
  %415 = load i64, ptr %13, align 8
  %416 = shl nsw i64 %415, 6
  %417 = getelementptr inbounds i8, ptr %414, i64 %416
  %418 = load ptr, ptr %40, align 8
  %419 = icmp sgt i64 %358, 0
  br i1 %419, label %420, label %495

420:                                              ; preds = %412
  %421 = load i64, ptr %31, align 8
  %422 = icmp slt i64 %421, %358
  %423 = icmp sgt i64 %375, 0
  %424 = getelementptr inbounds i8, ptr %0, i64 672
  %425 = getelementptr inbounds i8, ptr %0, i64 648
  %426 = select i1 %422, double 1.000000e-05, double 0x3CE0000000000000
  %427 = insertelement <8 x double> poison, double %426, i64 0
  %428 = shufflevector <8 x double> %427, <8 x double> poison, <8 x i32> zeroinitializer
  %429 = add nsw i64 %413, %375
  %430 = sitofp i64 %429 to double
  %431 = insertelement <8 x double> poison, double %430, i64 0
  %432 = shufflevector <8 x double> %431, <8 x double> poison, <8 x i32> zeroinitializer
  br label %433

433:                                              ; preds = %420, %440
  %434 = phi <8 x double> [ zeroinitializer, %420 ], [ %456, %440 ]
  %435 = phi i64 [ 0, %420 ], [ %457, %440 ]
  br i1 %423, label %436, label %440

436:                                              ; preds = %433
  %437 = mul nuw nsw i64 %435, %375
  %438 = load ptr, ptr %424, align 8
  %439 = load ptr, ptr %425, align 8
  br label %459

440:                                              ; preds = %459, %433
  %441 = phi <8 x double> [ zeroinitializer, %433 ], [ %492, %459 ]
  %442 = phi <8 x double> [ zeroinitializer, %433 ], [ %489, %459 ]
  %443 = fmul <8 x double> %428, %441
  %444 = fmul <8 x double> %432, %442
  %445 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %444)
  %446 = fmul <8 x double> %445, <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>
  %447 = fadd <8 x double> %443, %446
  %448 = fcmp ogt <8 x double> %442, zeroinitializer
  %449 = shl nsw i64 %435, 6
  %450 = getelementptr inbounds i8, ptr %417, i64 %449
  %451 = load <8 x double>, ptr %450, align 8
  %452 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %451)
  %453 = fdiv <8 x double> %452, %447
  %454 = fcmp ogt <8 x double> %453, %434
  %455 = select <8 x i1> %448, <8 x i1> %454, <8 x i1> zeroinitializer
  %456 = select <8 x i1> %455, <8 x double> %453, <8 x double> %434
  %457 = add nuw nsw i64 %435, 1
  %458 = icmp eq i64 %457, %358
  br i1 %458, label %495, label %433, !llvm.loop !13

459:                                              ; preds = %436, %459
  %460 = phi <8 x double> [ zeroinitializer, %436 ], [ %489, %459 ]
  %461 = phi i64 [ 0, %436 ], [ %493, %459 ]
  %462 = phi <8 x double> [ zeroinitializer, %436 ], [ %492, %459 ]
  %463 = add nuw nsw i64 %461, %437
  %464 = shl nsw i64 %463, 6
  %465 = getelementptr inbounds i8, ptr %418, i64 %464
  %466 = load <8 x double>, ptr %465, align 8
  %467 = add nsw i64 %461, %413
  %468 = shl nsw i64 %467, 6
  %469 = getelementptr inbounds i8, ptr %2, i64 %468
  %470 = load <8 x double>, ptr %469, align 8
  %471 = getelementptr inbounds i8, ptr %65, i64 %468
  %472 = load <8 x double>, ptr %471, align 8
  %473 = getelementptr inbounds double, ptr %438, i64 %467
  %474 = load double, ptr %473, align 8
  %475 = insertelement <8 x double> poison, double %474, i64 0
  %476 = shufflevector <8 x double> %475, <8 x double> poison, <8 x i32> zeroinitializer
  %477 = getelementptr inbounds double, ptr %439, i64 %467
  %478 = load double, ptr %477, align 8
  %479 = insertelement <8 x double> poison, double %478, i64 0
  %480 = shufflevector <8 x double> %479, <8 x double> poison, <8 x i32> zeroinitializer
  %481 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %472)
  %482 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %470)
  %483 = fcmp ogt <8 x double> %481, %482
  %484 = select <8 x i1> %483, <8 x double> %481, <8 x double> %482
  %485 = fmul <8 x double> %484, %480
  %486 = fadd <8 x double> %476, %485
  %487 = fmul <8 x double> %466, %486
  %488 = fmul <8 x double> %487, %487
  %489 = fadd <8 x double> %460, %488
  %490 = fmul <8 x double> %466, %470
  %491 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %490)
  %492 = fadd <8 x double> %462, %491
  %493 = add nuw nsw i64 %461, 1
  %494 = icmp eq i64 %493, %375
  br i1 %494, label %440, label %459, !llvm.loop !14

495:                                              ; preds = %440, %412
  %496 = phi <8 x double> [ zeroinitializer, %412 ], [ %456, %440 ]
  %497 = fcmp ogt <8 x double> %496, %356
  %498 = select <8 x i1> %497, <8 x double> %496, <8 x double> %356
  br label %499

499:                                              ; preds = %495, %391
  %500 = phi <8 x double> [ %356, %391 ], [ %498, %495 ]
  %501 = load i64, ptr %25, align 8
  %502 = icmp eq i64 %501, 1
  br i1 %502, label %503, label %527

503:                                              ; preds = %499
  %504 = load ptr, ptr %41, align 8
  %505 = load ptr, ptr %6, align 8
  %506 = getelementptr inbounds i8, ptr %505, i64 8
  %507 = getelementptr inbounds i8, ptr %505, i64 16
  %508 = load i64, ptr %506, align 8
  %509 = load i64, ptr %507, align 8
  %510 = mul nsw i64 %509, %508
  %511 = icmp sgt i64 %510, 0
  br i1 %511, label %512, label %523

512:                                              ; preds = %503, %512
  %513 = phi i64 [ %518, %512 ], [ 0, %503 ]
  %514 = getelementptr inbounds double, ptr %504, i64 %513
  %515 = load double, ptr %514, align 8
  %516 = load ptr, ptr %505, align 8
  %517 = getelementptr inbounds double, ptr %516, i64 %513
  store double %515, ptr %517, align 8
  %518 = add nuw nsw i64 %513, 1
  %519 = load i64, ptr %506, align 8
  %520 = load i64, ptr %507, align 8
  %521 = mul nsw i64 %520, %519
  %522 = icmp slt i64 %518, %521
  br i1 %522, label %512, label %523, !llvm.loop !15

523:                                              ; preds = %512, %503
  %524 = load ptr, ptr %6, align 8
  %525 = load ptr, ptr %524, align 8
  %526 = load i64, ptr %22, align 8
  tail call fastcc void @factorise(ptr noundef %525, i64 noundef %526) #8
  br label %527

527:                                              ; preds = %499, %523
  %528 = load ptr, ptr %35, align 8
  %529 = load i64, ptr %13, align 8
  %530 = shl nsw i64 %529, 6
  %531 = getelementptr inbounds i8, ptr %528, i64 %530
  %532 = load i64, ptr %16, align 8
  %533 = load ptr, ptr %6, align 8
  %534 = getelementptr inbounds i8, ptr %533, i64 144
  %535 = load ptr, ptr %534, align 8
  %536 = icmp sgt i64 %532, 0
  br i1 %536, label %537, label %546

537:                                              ; preds = %527, %537
  %538 = phi i64 [ %544, %537 ], [ 0, %527 ]
  %539 = shl nsw i64 %538, 6
  %540 = getelementptr inbounds i8, ptr %531, i64 %539
  %541 = load <8 x double>, ptr %540, align 8
  %542 = fneg <8 x double> %541
  %543 = getelementptr inbounds i8, ptr %535, i64 %539
  store <8 x double> %542, ptr %543, align 8
  %544 = add nuw nsw i64 %538, 1
  %545 = icmp eq i64 %544, %532
  br i1 %545, label %546, label %537, !llvm.loop !16

546:                                              ; preds = %537, %527
  call fastcc void @move_speeds(ptr noundef nonnull %6, ptr noundef %2) #8
  %547 = load ptr, ptr %66, align 8
  %548 = getelementptr inbounds i8, ptr %547, i64 8
  %549 = load i64, ptr %548, align 8
  %550 = load ptr, ptr %43, align 8
  %551 = load i64, ptr %34, align 8
  %552 = trunc i64 %551 to i8
  %553 = bitcast i8 %552 to <8 x i1>
  %554 = load i64, ptr %16, align 8
  %555 = icmp sgt i64 %554, 0
  br i1 %555, label %556, label %563

556:                                              ; preds = %546
  %557 = load ptr, ptr %6, align 8
  %558 = getelementptr inbounds i8, ptr %557, i64 216
  %559 = add nsw i64 %549, 4
  %560 = getelementptr inbounds i8, ptr %557, i64 192
  br label %605

561:                                              ; preds = %605
  %562 = bitcast <8 x double> %629 to <8 x i64>
  br label %563

563:                                              ; preds = %561, %546
  %564 = phi <8 x double> [ zeroinitializer, %546 ], [ %625, %561 ]
  %565 = phi <8 x i64> [ <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, %546 ], [ %562, %561 ]
  %566 = load <8 x double>, ptr %550, align 8
  %567 = getelementptr inbounds i8, ptr %550, i64 128
  %568 = load <8 x double>, ptr %567, align 8
  %569 = fcmp ogt <8 x double> %564, %566
  %570 = select <8 x i1> %569, <8 x i1> %553, <8 x i1> zeroinitializer
  %571 = select <8 x i1> %570, <8 x double> %564, <8 x double> %566
  store <8 x double> %571, ptr %550, align 8
  %572 = getelementptr inbounds i8, ptr %550, i64 64
  %573 = load <8 x i64>, ptr %572, align 8
  %574 = select <8 x i1> %570, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> %573
  %575 = bitcast <8 x i64> %574 to <8 x double>
  %576 = fcmp olt <8 x double> %564, %566
  %577 = select <8 x i1> %576, <8 x i64> zeroinitializer, <8 x i64> %565
  %578 = bitcast <8 x i64> %577 to <8 x double>
  %579 = fcmp ogt <8 x double> %568, %578
  %580 = bitcast <8 x double> %568 to <8 x i64>
  %581 = select <8 x i1> %579, <8 x i64> %577, <8 x i64> %580
  %582 = bitcast <8 x i64> %581 to <8 x double>
  %583 = select <8 x i1> %553, <8 x i64> %577, <8 x i64> %580
  store <8 x i64> %583, ptr %567, align 8
  %584 = fcmp oge <8 x double> %582, <double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02>
  %585 = fmul <8 x double> %500, %582
  %586 = fmul <8 x double> %585, <double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02>
  %587 = fcmp ogt <8 x double> %586, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %588 = or <8 x i1> %587, %584
  %589 = load i64, ptr %34, align 8
  %590 = fcmp ogt <8 x double> %500, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %591 = and <8 x i1> %588, %590
  %592 = bitcast <8 x i1> %591 to i8
  %593 = zext i8 %592 to i64
  %594 = and i64 %589, %593
  %595 = xor i64 %594, %589
  %596 = trunc i64 %595 to i8
  %597 = bitcast i8 %596 to <8 x i1>
  %598 = fcmp olt <8 x double> %578, %575
  %599 = fcmp ogt <8 x double> %575, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %600 = select <8 x i1> %599, <8 x i1> %598, <8 x i1> zeroinitializer
  %601 = select <8 x i1> %600, <8 x i1> %597, <8 x i1> zeroinitializer
  %602 = select <8 x i1> %601, <8 x i64> %577, <8 x i64> %574
  store <8 x i64> %602, ptr %572, align 8
  %603 = bitcast <8 x i1> %601 to i8
  %604 = icmp eq i8 %603, 0
  br i1 %604, label %649, label %632

605:                                              ; preds = %556, %605
  %606 = phi <8 x double> [ <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %556 ], [ %629, %605 ]
  %607 = phi <8 x double> [ zeroinitializer, %556 ], [ %625, %605 ]
  %608 = phi i64 [ 0, %556 ], [ %630, %605 ]
  %609 = load ptr, ptr %558, align 8
  %610 = shl nsw i64 %608, 6
  %611 = getelementptr inbounds i8, ptr %609, i64 %610
  %612 = load <8 x double>, ptr %611, align 8
  %613 = add nsw i64 %559, %608
  %614 = shl nsw i64 %613, 6
  %615 = getelementptr inbounds i8, ptr %550, i64 %614
  %616 = load <8 x double>, ptr %615, align 8
  %617 = load ptr, ptr %560, align 8
  %618 = getelementptr inbounds i8, ptr %617, i64 %610
  %619 = load <8 x double>, ptr %618, align 8
  %620 = fcmp ogt <8 x double> %619, %616
  %621 = select <8 x i1> %620, <8 x double> %619, <8 x double> %616
  %622 = select <8 x i1> %553, <8 x double> %621, <8 x double> %616
  store <8 x double> %622, ptr %615, align 8
  %623 = fcmp ogt <8 x double> %612, zeroinitializer
  %624 = fadd <8 x double> %607, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %625 = select <8 x i1> %623, <8 x double> %624, <8 x double> %607
  %626 = fdiv <8 x double> %612, %621
  %627 = fcmp olt <8 x double> %626, %606
  %628 = select <8 x i1> %623, <8 x i1> %627, <8 x i1> zeroinitializer
  %629 = select <8 x i1> %628, <8 x double> %626, <8 x double> %606
  %630 = add nuw nsw i64 %608, 1
  %631 = icmp eq i64 %630, %554
  br i1 %631, label %561, label %605, !llvm.loop !19

632:                                              ; preds = %563
  %633 = getelementptr inbounds i8, ptr %550, i64 192
  %634 = load <8 x double>, ptr %633, align 8
  %635 = select <8 x i1> %601, <8 x double> %7, <8 x double> %634
  store <8 x double> %635, ptr %633, align 8
  %636 = getelementptr i8, ptr %550, i64 256
  %637 = icmp sgt i64 %549, 0
  br i1 %637, label %638, label %649

638:                                              ; preds = %632, %638
  %639 = phi i64 [ %647, %638 ], [ 0, %632 ]
  %640 = shl nsw i64 %639, 6
  %641 = getelementptr inbounds i8, ptr %2, i64 %640
  %642 = load <8 x i64>, ptr %641, align 8
  %643 = shl i64 %639, 6
  %644 = getelementptr i8, ptr %636, i64 %643
  %645 = load <8 x i64>, ptr %644, align 8
  %646 = select <8 x i1> %601, <8 x i64> %642, <8 x i64> %645
  store <8 x i64> %646, ptr %644, align 8
  %647 = add nuw nsw i64 %639, 1
  %648 = icmp eq i64 %647, %549
  br i1 %648, label %649, label %638, !llvm.loop !20

649:                                              ; preds = %638, %632, %563
  %650 = or i64 %594, %398
  br label %651

651:                                              ; preds = %367, %649
  %652 = phi i64 [ %372, %367 ], [ %650, %649 ]
  ret i64 %652
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

define internal fastcc void @settle(ptr noundef readonly %0) unnamed_addr #3 {
  %2 = getelementptr inbounds i8, ptr %0, i64 264
  %3 = getelementptr inbounds i8, ptr %0, i64 24
  %4 = getelementptr inbounds i8, ptr %0, i64 240
  %5 = getelementptr inbounds i8, ptr %0, i64 248
  br label %7

6:                                                ; preds = %51
  ret void

7:                                                ; preds = %1, %51
  %8 = phi i64 [ 0, %1 ], [ %53, %51 ]
  %9 = load ptr, ptr %2, align 8
  %10 = getelementptr inbounds double, ptr %9, i64 %8
  %11 = load double, ptr %10, align 8
  %12 = load ptr, ptr %3, align 8
  %13 = getelementptr inbounds double, ptr %12, i64 %8
  %14 = load double, ptr %13, align 8
  %15 = fcmp olt double %14, %11
  %16 = select i1 %15, double %14, double %11
  %17 = load i64, ptr %5, align 8
  %18 = icmp sgt i64 %17, 0
  br i1 %18, label %19, label %34

19:                                               ; preds = %7
  %20 = load ptr, ptr %4, align 8
  br label %21

21:                                               ; preds = %19, %21
  %22 = phi i64 [ 0, %19 ], [ %32, %21 ]
  %23 = phi i64 [ %17, %19 ], [ %31, %21 ]
  %24 = add nuw nsw i64 %22, %23
  %25 = lshr i64 %24, 1
  %26 = mul i64 %25, 24
  %27 = getelementptr inbounds i8, ptr %20, i64 %26
  %28 = load double, ptr %27, align 8
  %29 = fcmp ogt double %28, %16
  %30 = add nuw nsw i64 %25, 1
  %31 = select i1 %29, i64 %25, i64 %23
  %32 = select i1 %29, i64 %22, i64 %30
  %33 = icmp slt i64 %32, %31
  br i1 %33, label %21, label %34, !llvm.loop !22

34:                                               ; preds = %21, %7
  %35 = phi i64 [ 0, %7 ], [ %32, %21 ]
  %36 = load ptr, ptr %4, align 8
  %37 = mul i64 %35, 24
  %38 = getelementptr inbounds i8, ptr %36, i64 %37
  %39 = icmp eq i64 %35, 0
  br i1 %39, label %44, label %40

40:                                               ; preds = %34
  %41 = getelementptr inbounds i8, ptr %38, i64 -8
  %42 = load double, ptr %41, align 8
  %43 = fcmp olt double %16, %42
  br i1 %43, label %51, label %44

44:                                               ; preds = %40, %34
  %45 = icmp slt i64 %35, %17
  br i1 %45, label %46, label %50

46:                                               ; preds = %44
  %47 = getelementptr inbounds i8, ptr %38, i64 8
  %48 = load double, ptr %47, align 8
  %49 = fcmp ogt double %16, %48
  br i1 %49, label %51, label %50

50:                                               ; preds = %46, %44
  br label %51

51:                                               ; preds = %50, %46, %40
  %52 = phi double [ %42, %40 ], [ %16, %50 ], [ %48, %46 ]
  store double %52, ptr %13, align 8
  %53 = add nuw nsw i64 %8, 1
  %54 = icmp eq i64 %53, 8
  br i1 %54, label %6, label %7, !llvm.loop !23
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
  br i1 %25, label %15, label %14, !llvm.loop !24

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
  br i1 %76, label %65, label %77, !llvm.loop !25

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
  br i1 %105, label %22, label %26, !llvm.loop !26
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
  br i1 %49, label %50, label %40, !llvm.loop !27

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
  br i1 %81, label %67, label %58, !llvm.loop !28

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
  br i1 %107, label %89, label %82, !llvm.loop !29

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
  br i1 %121, label %99, label %108, !llvm.loop !30

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
  br i1 %141, label %122, label %131, !llvm.loop !31

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
  br i1 %160, label %149, label %161, !llvm.loop !32

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
  br i1 %29, label %12, label %16, !llvm.loop !33

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
  br i1 %49, label %17, label %26, !llvm.loop !34

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
  br i1 %68, label %30, label %50, !llvm.loop !35
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
  br i1 %17, label %14, label %10, !llvm.loop !36

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
  br i1 %34, label %15, label %18, !llvm.loop !37

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
  br i1 %49, label %27, label %35, !llvm.loop !38
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
  br i1 %38, label %27, label %33, !llvm.loop !39

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
  br i1 %65, label %66, label %56, !llvm.loop !27

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
  br i1 %84, label %39, label %52, !llvm.loop !40

85:                                               ; preds = %66, %85
  %86 = phi i64 [ %91, %85 ], [ 0, %66 ]
  %87 = shl nsw i64 %86, 6
  %88 = getelementptr inbounds i8, ptr %55, i64 %87
  %89 = load <8 x double>, ptr %88, align 8
  %90 = fmul <8 x double> %71, %89
  store <8 x double> %90, ptr %88, align 8
  %91 = add nuw nsw i64 %86, 1
  %92 = icmp eq i64 %91, %9
  br i1 %92, label %82, label %85, !llvm.loop !41

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
  br i1 %136, label %137, label %127, !llvm.loop !27

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
  br i1 %151, label %97, label %105, !llvm.loop !42

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
  br i1 %201, label %202, label %188, !llvm.loop !43

202:                                              ; preds = %188, %170, %159
  %203 = phi <8 x double> [ %161, %159 ], [ %176, %170 ], [ %176, %188 ]
  %204 = add nuw nsw i64 %160, 1
  %205 = icmp eq i64 %204, %6
  br i1 %205, label %157, label %159, !llvm.loop !44

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
  br i1 %218, label %206, label %207, !llvm.loop !45

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
  br i1 %243, label %244, label %232, !llvm.loop !27

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
  br i1 %263, label %264, label %252, !llvm.loop !46

264:                                              ; preds = %252, %244, %219
  %265 = add nuw nsw i64 %220, 1
  %266 = icmp eq i64 %265, %6
  br i1 %266, label %267, label %219, !llvm.loop !47

267:                                              ; preds = %264, %206, %97
  %268 = phi <8 x double> [ %95, %97 ], [ %155, %206 ], [ %155, %264 ]
  %269 = add nuw nsw i64 %96, 1
  %270 = icmp eq i64 %269, %2
  %271 = select i1 %104, i1 true, i1 %270
  br i1 %271, label %272, label %93, !llvm.loop !48

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
  br i1 %292, label %281, label %282, !llvm.loop !49
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
  br i1 %22, label %9, label %8, !llvm.loop !50

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
  br i1 %37, label %16, label %23, !llvm.loop !51
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
  br i1 %13, label %23, label %14, !llvm.loop !52

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
  br i1 %54, label %32, label %44, !llvm.loop !53

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
  br i1 %66, label %55, label %10, !llvm.loop !54

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
  br i1 %81, label %62, label %67, !llvm.loop !55

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
!54 = distinct !{!54, !7, !8}
!55 = distinct !{!55, !7, !8}
