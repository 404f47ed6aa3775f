; sources da070b31c30558d9f2a93b5662de09aa3cd0e53beaee6245ce85b098530d5a11
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Held = type { ptr, i64, i64, i64, i64, i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

define i64 @project_lanes(ptr noundef readonly %0, ptr noundef readonly %1, ptr noundef %2, ptr noundef readonly %3, i64 noundef %4) #0 {
  %6 = alloca %struct.Held, align 8
  %7 = load <8 x double>, ptr %1, align 8
  tail call void @llvm.experimental.noalias.scope.decl(metadata !3)
  %8 = getelementptr inbounds i8, ptr %0, i64 1608
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
  %36 = getelementptr inbounds i8, ptr %0, i64 1656
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
  br i1 %101, label %151, label %102

102:                                              ; preds = %151, %95
  %103 = getelementptr inbounds i8, ptr %0, i64 168
  %104 = getelementptr inbounds i8, ptr %0, i64 192
  %105 = getelementptr inbounds i8, ptr %0, i64 1632
  %106 = load ptr, ptr %35, align 8
  %107 = load i64, ptr %34, align 8
  %108 = load ptr, ptr %8, align 8
  %109 = getelementptr inbounds i8, ptr %108, i64 8
  %110 = load i64, ptr %109, align 8
  %111 = load ptr, ptr %103, align 8
  %112 = load ptr, ptr %104, align 8
  %113 = load ptr, ptr %105, align 8
  %114 = inttoptr i64 %110 to ptr
  %115 = tail call i32 %114(ptr noundef %111, ptr noundef %2, ptr noundef %112, ptr noundef %113, ptr noundef %106) #9
  %116 = icmp slt i32 %115, 0
  br i1 %116, label %347, label %117

117:                                              ; preds = %102
  %118 = icmp eq i64 %30, %100
  %119 = load i64, ptr %13, align 8
  %120 = icmp sgt i64 %119, 0
  %121 = load ptr, ptr %35, align 8
  %122 = load ptr, ptr %42, align 8
  %123 = load ptr, ptr %6, align 8
  %124 = getelementptr inbounds i8, ptr %123, i64 216
  %125 = icmp ne ptr %65, null
  %126 = load i64, ptr %19, align 8
  %127 = load ptr, ptr %38, align 8
  %128 = load i64, ptr %28, align 8
  %129 = icmp slt i64 %128, %119
  %130 = icmp sgt i64 %119, 0
  %131 = icmp sgt i64 %126, 0
  %132 = getelementptr inbounds i8, ptr %0, i64 624
  %133 = getelementptr inbounds i8, ptr %0, i64 600
  %134 = select i1 %129, double 1.000000e-05, double 0x3CE0000000000000
  %135 = insertelement <8 x double> poison, double %134, i64 0
  %136 = shufflevector <8 x double> %135, <8 x double> poison, <8 x i32> zeroinitializer
  %137 = load ptr, ptr %42, align 8
  %138 = load i64, ptr %22, align 8
  %139 = add nsw i64 %138, %126
  %140 = sitofp i64 %139 to double
  %141 = insertelement <8 x double> poison, double %140, i64 0
  %142 = shufflevector <8 x double> %141, <8 x double> poison, <8 x i32> zeroinitializer
  %143 = icmp eq i64 %27, 1
  %144 = getelementptr inbounds i8, ptr %97, i64 8
  %145 = getelementptr inbounds i8, ptr %97, i64 16
  %146 = getelementptr inbounds i8, ptr %97, i64 24
  %147 = getelementptr inbounds i8, ptr %97, i64 32
  %148 = getelementptr inbounds i8, ptr %97, i64 40
  %149 = getelementptr inbounds i8, ptr %97, i64 144
  %150 = icmp sgt i64 %119, 0
  br label %168

151:                                              ; preds = %95, %151
  %152 = phi i64 [ %155, %151 ], [ 0, %95 ]
  %153 = shl nsw i64 %152, 6
  %154 = getelementptr inbounds i8, ptr %99, i64 %153
  store <8 x double> zeroinitializer, ptr %154, align 8
  %155 = add nuw nsw i64 %152, 1
  %156 = icmp eq i64 %155, %100
  br i1 %156, label %102, label %151, !llvm.loop !10

157:                                              ; preds = %344
  %158 = add nuw nsw i32 %172, 1
  %159 = load ptr, ptr %8, align 8
  %160 = getelementptr inbounds i8, ptr %159, i64 8
  %161 = load i64, ptr %160, align 8
  %162 = load ptr, ptr %103, align 8
  %163 = load ptr, ptr %104, align 8
  %164 = load ptr, ptr %105, align 8
  %165 = inttoptr i64 %161 to ptr
  %166 = tail call i32 %165(ptr noundef %162, ptr noundef %2, ptr noundef %163, ptr noundef %164, ptr noundef %106) #9
  %167 = icmp slt i32 %166, 0
  br i1 %167, label %347, label %168, !llvm.loop !11

168:                                              ; preds = %117, %157
  %169 = phi i64 [ undef, %117 ], [ %346, %157 ]
  %170 = phi i64 [ 0, %117 ], [ %295, %157 ]
  %171 = phi <8 x double> [ <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>, %117 ], [ %345, %157 ]
  %172 = phi i32 [ 0, %117 ], [ %158, %157 ]
  %173 = phi <8 x double> [ zeroinitializer, %117 ], [ %280, %157 ]
  %174 = phi i64 [ %107, %117 ], [ %293, %157 ]
  %175 = icmp eq i32 %172, 0
  %176 = select i1 %175, i1 true, i1 %118
  br i1 %120, label %189, label %177

177:                                              ; preds = %211, %168
  %178 = phi <8 x double> [ zeroinitializer, %168 ], [ %216, %211 ]
  %179 = phi <8 x i64> [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %168 ], [ %218, %211 ]
  %180 = icmp ne <8 x i64> %179, zeroinitializer
  %181 = bitcast <8 x i1> %180 to i8
  %182 = zext i8 %181 to i64
  %183 = xor i64 %182, -1
  %184 = and i64 %174, %183
  %185 = or i64 %184, %170
  %186 = and i1 %125, %175
  %187 = select i1 %186, i1 %130, i1 false
  %188 = select i1 %186, <8 x double> zeroinitializer, <8 x double> %173
  br i1 %187, label %221, label %279

189:                                              ; preds = %168, %211
  %190 = phi i64 [ %219, %211 ], [ 0, %168 ]
  %191 = phi <8 x i64> [ %218, %211 ], [ <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>, %168 ]
  %192 = phi <8 x double> [ %216, %211 ], [ zeroinitializer, %168 ]
  %193 = shl nsw i64 %190, 6
  %194 = getelementptr inbounds i8, ptr %121, i64 %193
  %195 = load <8 x double>, ptr %194, align 8
  %196 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %195)
  %197 = getelementptr inbounds i8, ptr %122, i64 %193
  %198 = load <8 x double>, ptr %197, align 8
  %199 = getelementptr inbounds i8, ptr %99, i64 %193
  %200 = load <8 x double>, ptr %199, align 8
  %201 = fcmp ogt <8 x double> %198, %200
  %202 = select <8 x i1> %201, <8 x double> %198, <8 x double> %200
  %203 = fmul <8 x double> %202, <double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000, double 0x3CB0000000000000>
  %204 = fcmp une <8 x double> %195, zeroinitializer
  br i1 %176, label %211, label %205

205:                                              ; preds = %189
  %206 = load ptr, ptr %124, align 8
  %207 = getelementptr inbounds i8, ptr %206, i64 %193
  %208 = load <8 x double>, ptr %207, align 8
  %209 = fcmp ogt <8 x double> %208, zeroinitializer
  %210 = and <8 x i1> %209, %204
  br label %211

211:                                              ; preds = %205, %189
  %212 = phi <8 x i1> [ %204, %189 ], [ %210, %205 ]
  %213 = fdiv <8 x double> %196, %203
  %214 = fcmp ogt <8 x double> %213, %192
  %215 = select <8 x i1> %212, <8 x i1> %214, <8 x i1> zeroinitializer
  %216 = select <8 x i1> %215, <8 x double> %213, <8 x double> %192
  %217 = fcmp one <8 x double> %196, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %218 = select <8 x i1> %217, <8 x i64> %191, <8 x i64> zeroinitializer
  %219 = add nuw nsw i64 %190, 1
  %220 = icmp eq i64 %219, %119
  br i1 %220, label %177, label %189, !llvm.loop !12

221:                                              ; preds = %177, %228
  %222 = phi <8 x double> [ %245, %228 ], [ zeroinitializer, %177 ]
  %223 = phi i64 [ %246, %228 ], [ 0, %177 ]
  br i1 %131, label %224, label %228

224:                                              ; preds = %221
  %225 = mul nuw nsw i64 %223, %126
  %226 = load ptr, ptr %132, align 8
  %227 = load ptr, ptr %133, align 8
  br label %248

228:                                              ; preds = %248, %221
  %229 = phi <8 x double> [ zeroinitializer, %221 ], [ %276, %248 ]
  %230 = shl nsw i64 %223, 6
  %231 = getelementptr inbounds i8, ptr %137, i64 %230
  %232 = load <8 x double>, ptr %231, align 8
  %233 = fmul <8 x double> %136, %232
  %234 = fmul <8 x double> %229, %142
  %235 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %234)
  %236 = fmul <8 x double> %235, <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>
  %237 = fadd <8 x double> %233, %236
  %238 = fcmp ogt <8 x double> %229, zeroinitializer
  %239 = getelementptr inbounds i8, ptr %121, i64 %230
  %240 = load <8 x double>, ptr %239, align 8
  %241 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %240)
  %242 = fdiv <8 x double> %241, %237
  %243 = fcmp ogt <8 x double> %242, %222
  %244 = select <8 x i1> %238, <8 x i1> %243, <8 x i1> zeroinitializer
  %245 = select <8 x i1> %244, <8 x double> %242, <8 x double> %222
  %246 = add nuw nsw i64 %223, 1
  %247 = icmp eq i64 %246, %119
  br i1 %247, label %279, label %221, !llvm.loop !13

248:                                              ; preds = %224, %248
  %249 = phi <8 x double> [ zeroinitializer, %224 ], [ %276, %248 ]
  %250 = phi i64 [ 0, %224 ], [ %277, %248 ]
  %251 = add nuw nsw i64 %250, %225
  %252 = shl nsw i64 %251, 6
  %253 = getelementptr inbounds i8, ptr %127, i64 %252
  %254 = load <8 x double>, ptr %253, align 8
  %255 = shl nsw i64 %250, 6
  %256 = getelementptr inbounds i8, ptr %2, i64 %255
  %257 = load <8 x double>, ptr %256, align 8
  %258 = getelementptr inbounds i8, ptr %65, i64 %255
  %259 = load <8 x double>, ptr %258, align 8
  %260 = getelementptr inbounds double, ptr %226, i64 %250
  %261 = load double, ptr %260, align 8
  %262 = insertelement <8 x double> poison, double %261, i64 0
  %263 = shufflevector <8 x double> %262, <8 x double> poison, <8 x i32> zeroinitializer
  %264 = getelementptr inbounds double, ptr %227, i64 %250
  %265 = load double, ptr %264, align 8
  %266 = insertelement <8 x double> poison, double %265, i64 0
  %267 = shufflevector <8 x double> %266, <8 x double> poison, <8 x i32> zeroinitializer
  %268 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %259)
  %269 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %257)
  %270 = fcmp ogt <8 x double> %268, %269
  %271 = select <8 x i1> %270, <8 x double> %268, <8 x double> %269
  %272 = fmul <8 x double> %271, %267
  %273 = fadd <8 x double> %263, %272
  %274 = fmul <8 x double> %254, %273
  %275 = fmul <8 x double> %274, %274
  %276 = fadd <8 x double> %249, %275
  %277 = add nuw nsw i64 %250, 1
  %278 = icmp eq i64 %277, %126
  br i1 %278, label %228, label %248, !llvm.loop !14

279:                                              ; preds = %228, %177
  %280 = phi <8 x double> [ %188, %177 ], [ %245, %228 ]
  %281 = fcmp ole <8 x double> %178, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %282 = fmul <8 x double> %171, <double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01, double 5.000000e-01>
  %283 = fcmp oge <8 x double> %178, %282
  %284 = fcmp ole <8 x double> %178, <double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00, double 8.000000e+00>
  %285 = and <8 x i1> %283, %284
  %286 = or <8 x i1> %285, %281
  %287 = bitcast <8 x i1> %286 to i8
  %288 = zext i8 %287 to i64
  %289 = or i64 %185, %288
  %290 = xor i64 %289, -1
  %291 = and i64 %174, %290
  %292 = icmp eq i32 %172, 9
  %293 = select i1 %292, i64 0, i64 %291
  %294 = select i1 %292, i64 %291, i64 0
  %295 = or i64 %294, %185
  store i64 %293, ptr %34, align 8
  %296 = icmp eq i64 %293, 0
  br i1 %296, label %344, label %297

297:                                              ; preds = %279
  br i1 %143, label %298, label %316

298:                                              ; preds = %297
  %299 = load i64, ptr %144, align 8
  %300 = load i64, ptr %145, align 8
  %301 = mul nsw i64 %300, %299
  %302 = icmp sgt i64 %301, 0
  br i1 %302, label %303, label %314

303:                                              ; preds = %298, %303
  %304 = phi i64 [ %309, %303 ], [ 0, %298 ]
  %305 = getelementptr inbounds double, ptr %55, i64 %304
  %306 = load double, ptr %305, align 8
  %307 = load ptr, ptr %97, align 8
  %308 = getelementptr inbounds double, ptr %307, i64 %304
  store double %306, ptr %308, align 8
  %309 = add nuw nsw i64 %304, 1
  %310 = load i64, ptr %144, align 8
  %311 = load i64, ptr %145, align 8
  %312 = mul nsw i64 %311, %310
  %313 = icmp slt i64 %309, %312
  br i1 %313, label %303, label %314, !llvm.loop !15

314:                                              ; preds = %303, %298
  %315 = load ptr, ptr %97, align 8
  tail call fastcc void @factorise(ptr noundef %315, i64 noundef %76) #8
  br label %316

316:                                              ; preds = %297, %314
  %317 = load i64, ptr %147, align 8
  %318 = load i64, ptr %148, align 8
  %319 = mul nsw i64 %318, %317
  %320 = icmp sgt i64 %319, 0
  br i1 %320, label %321, label %332

321:                                              ; preds = %316, %321
  %322 = phi i64 [ %327, %321 ], [ 0, %316 ]
  %323 = getelementptr inbounds double, ptr %49, i64 %322
  %324 = load double, ptr %323, align 8
  %325 = load ptr, ptr %146, align 8
  %326 = getelementptr inbounds double, ptr %325, i64 %322
  store double %324, ptr %326, align 8
  %327 = add nuw nsw i64 %322, 1
  %328 = load i64, ptr %147, align 8
  %329 = load i64, ptr %148, align 8
  %330 = mul nsw i64 %329, %328
  %331 = icmp slt i64 %327, %330
  br i1 %331, label %321, label %332, !llvm.loop !15

332:                                              ; preds = %321, %316
  %333 = load ptr, ptr %149, align 8
  br i1 %150, label %334, label %343

334:                                              ; preds = %332, %334
  %335 = phi i64 [ %341, %334 ], [ 0, %332 ]
  %336 = shl nsw i64 %335, 6
  %337 = getelementptr inbounds i8, ptr %106, i64 %336
  %338 = load <8 x double>, ptr %337, align 8
  %339 = fneg <8 x double> %338
  %340 = getelementptr inbounds i8, ptr %333, i64 %336
  store <8 x double> %339, ptr %340, align 8
  %341 = add nuw nsw i64 %335, 1
  %342 = icmp eq i64 %341, %119
  br i1 %342, label %343, label %334, !llvm.loop !16

343:                                              ; preds = %334, %332
  call fastcc void @move_positions(ptr noundef nonnull %6, ptr noundef %2) #8
  br label %344

344:                                              ; preds = %343, %279
  %345 = phi <8 x double> [ %178, %343 ], [ %171, %279 ]
  %346 = phi i64 [ %169, %343 ], [ %295, %279 ]
  br i1 %296, label %347, label %157

347:                                              ; preds = %344, %157, %102
  %348 = phi <8 x double> [ zeroinitializer, %102 ], [ %280, %157 ], [ %280, %344 ]
  %349 = phi i64 [ %96, %102 ], [ %346, %344 ], [ %96, %157 ]
  %350 = load i64, ptr %16, align 8
  %351 = icmp eq i64 %350, 0
  %352 = icmp eq i64 %349, %4
  %353 = select i1 %351, i1 true, i1 %352
  br i1 %353, label %359, label %354

354:                                              ; preds = %347
  %355 = icmp sgt i64 %350, 0
  br i1 %355, label %356, label %365

356:                                              ; preds = %354
  %357 = load ptr, ptr %35, align 8
  %358 = load i64, ptr %13, align 8
  br label %372

359:                                              ; preds = %347
  %360 = fcmp ogt <8 x double> %348, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %361 = bitcast <8 x i1> %360 to i8
  %362 = zext i8 %361 to i64
  %363 = and i64 %362, %4
  %364 = or i64 %363, %349
  br label %643

365:                                              ; preds = %372, %354
  %366 = phi <8 x double> [ zeroinitializer, %354 ], [ %380, %372 ]
  %367 = load i64, ptr %22, align 8
  %368 = mul nsw i64 %367, %350
  %369 = icmp sgt i64 %368, 0
  br i1 %369, label %370, label %383

370:                                              ; preds = %365
  %371 = load ptr, ptr %40, align 8
  br label %394

372:                                              ; preds = %356, %372
  %373 = phi i64 [ 0, %356 ], [ %381, %372 ]
  %374 = phi <8 x double> [ zeroinitializer, %356 ], [ %380, %372 ]
  %375 = add nsw i64 %358, %373
  %376 = shl nsw i64 %375, 6
  %377 = getelementptr inbounds i8, ptr %357, i64 %376
  %378 = load <8 x double>, ptr %377, align 8
  %379 = fmul <8 x double> %378, zeroinitializer
  %380 = fadd <8 x double> %374, %379
  %381 = add nuw nsw i64 %373, 1
  %382 = icmp eq i64 %381, %350
  br i1 %382, label %365, label %372, !llvm.loop !17

383:                                              ; preds = %394, %365
  %384 = phi <8 x double> [ %366, %365 ], [ %401, %394 ]
  %385 = fcmp oeq <8 x double> %384, zeroinitializer
  %386 = bitcast <8 x i1> %385 to i8
  %387 = zext i8 %386 to i64
  %388 = xor i64 %387, -1
  %389 = and i64 %388, %4
  %390 = or i64 %389, %349
  %391 = xor i64 %390, -1
  %392 = and i64 %391, %4
  store i64 %392, ptr %34, align 8
  %393 = icmp eq ptr %65, null
  br i1 %393, label %491, label %404

394:                                              ; preds = %370, %394
  %395 = phi i64 [ 0, %370 ], [ %402, %394 ]
  %396 = phi <8 x double> [ %366, %370 ], [ %401, %394 ]
  %397 = shl nsw i64 %395, 6
  %398 = getelementptr inbounds i8, ptr %371, i64 %397
  %399 = load <8 x double>, ptr %398, align 8
  %400 = fmul <8 x double> %399, zeroinitializer
  %401 = fadd <8 x double> %396, %400
  %402 = add nuw nsw i64 %395, 1
  %403 = icmp eq i64 %402, %368
  br i1 %403, label %383, label %394, !llvm.loop !18

404:                                              ; preds = %383
  %405 = load i64, ptr %19, align 8
  %406 = load ptr, ptr %35, align 8
  %407 = load i64, ptr %13, align 8
  %408 = shl nsw i64 %407, 6
  %409 = getelementptr inbounds i8, ptr %406, i64 %408
  %410 = load ptr, ptr %40, align 8
  %411 = icmp sgt i64 %350, 0
  br i1 %411, label %412, label %487

412:                                              ; preds = %404
  %413 = load i64, ptr %31, align 8
  %414 = icmp slt i64 %413, %350
  %415 = icmp sgt i64 %367, 0
  %416 = getelementptr inbounds i8, ptr %0, i64 624
  %417 = getelementptr inbounds i8, ptr %0, i64 600
  %418 = select i1 %414, double 1.000000e-05, double 0x3CE0000000000000
  %419 = insertelement <8 x double> poison, double %418, i64 0
  %420 = shufflevector <8 x double> %419, <8 x double> poison, <8 x i32> zeroinitializer
  %421 = add nsw i64 %405, %367
  %422 = sitofp i64 %421 to double
  %423 = insertelement <8 x double> poison, double %422, i64 0
  %424 = shufflevector <8 x double> %423, <8 x double> poison, <8 x i32> zeroinitializer
  br label %425

425:                                              ; preds = %412, %432
  %426 = phi <8 x double> [ zeroinitializer, %412 ], [ %448, %432 ]
  %427 = phi i64 [ 0, %412 ], [ %449, %432 ]
  br i1 %415, label %428, label %432

428:                                              ; preds = %425
  %429 = mul nuw nsw i64 %427, %367
  %430 = load ptr, ptr %416, align 8
  %431 = load ptr, ptr %417, align 8
  br label %451

432:                                              ; preds = %451, %425
  %433 = phi <8 x double> [ zeroinitializer, %425 ], [ %484, %451 ]
  %434 = phi <8 x double> [ zeroinitializer, %425 ], [ %481, %451 ]
  %435 = fmul <8 x double> %420, %433
  %436 = fmul <8 x double> %424, %434
  %437 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %436)
  %438 = fmul <8 x double> %437, <double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00, double 3.000000e+00>
  %439 = fadd <8 x double> %435, %438
  %440 = fcmp ogt <8 x double> %434, zeroinitializer
  %441 = shl nsw i64 %427, 6
  %442 = getelementptr inbounds i8, ptr %409, i64 %441
  %443 = load <8 x double>, ptr %442, align 8
  %444 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %443)
  %445 = fdiv <8 x double> %444, %439
  %446 = fcmp ogt <8 x double> %445, %426
  %447 = select <8 x i1> %440, <8 x i1> %446, <8 x i1> zeroinitializer
  %448 = select <8 x i1> %447, <8 x double> %445, <8 x double> %426
  %449 = add nuw nsw i64 %427, 1
  %450 = icmp eq i64 %449, %350
  br i1 %450, label %487, label %425, !llvm.loop !13

451:                                              ; preds = %428, %451
  %452 = phi <8 x double> [ zeroinitializer, %428 ], [ %481, %451 ]
  %453 = phi i64 [ 0, %428 ], [ %485, %451 ]
  %454 = phi <8 x double> [ zeroinitializer, %428 ], [ %484, %451 ]
  %455 = add nuw nsw i64 %453, %429
  %456 = shl nsw i64 %455, 6
  %457 = getelementptr inbounds i8, ptr %410, i64 %456
  %458 = load <8 x double>, ptr %457, align 8
  %459 = add nsw i64 %453, %405
  %460 = shl nsw i64 %459, 6
  %461 = getelementptr inbounds i8, ptr %2, i64 %460
  %462 = load <8 x double>, ptr %461, align 8
  %463 = getelementptr inbounds i8, ptr %65, i64 %460
  %464 = load <8 x double>, ptr %463, align 8
  %465 = getelementptr inbounds double, ptr %430, i64 %459
  %466 = load double, ptr %465, align 8
  %467 = insertelement <8 x double> poison, double %466, i64 0
  %468 = shufflevector <8 x double> %467, <8 x double> poison, <8 x i32> zeroinitializer
  %469 = getelementptr inbounds double, ptr %431, i64 %459
  %470 = load double, ptr %469, align 8
  %471 = insertelement <8 x double> poison, double %470, i64 0
  %472 = shufflevector <8 x double> %471, <8 x double> poison, <8 x i32> zeroinitializer
  %473 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %464)
  %474 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %462)
  %475 = fcmp ogt <8 x double> %473, %474
  %476 = select <8 x i1> %475, <8 x double> %473, <8 x double> %474
  %477 = fmul <8 x double> %476, %472
  %478 = fadd <8 x double> %468, %477
  %479 = fmul <8 x double> %458, %478
  %480 = fmul <8 x double> %479, %479
  %481 = fadd <8 x double> %452, %480
  %482 = fmul <8 x double> %458, %462
  %483 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %482)
  %484 = fadd <8 x double> %454, %483
  %485 = add nuw nsw i64 %453, 1
  %486 = icmp eq i64 %485, %367
  br i1 %486, label %432, label %451, !llvm.loop !14

487:                                              ; preds = %432, %404
  %488 = phi <8 x double> [ zeroinitializer, %404 ], [ %448, %432 ]
  %489 = fcmp ogt <8 x double> %488, %348
  %490 = select <8 x i1> %489, <8 x double> %488, <8 x double> %348
  br label %491

491:                                              ; preds = %487, %383
  %492 = phi <8 x double> [ %348, %383 ], [ %490, %487 ]
  %493 = load i64, ptr %25, align 8
  %494 = icmp eq i64 %493, 1
  br i1 %494, label %495, label %519

495:                                              ; preds = %491
  %496 = load ptr, ptr %41, align 8
  %497 = load ptr, ptr %6, align 8
  %498 = getelementptr inbounds i8, ptr %497, i64 8
  %499 = getelementptr inbounds i8, ptr %497, i64 16
  %500 = load i64, ptr %498, align 8
  %501 = load i64, ptr %499, align 8
  %502 = mul nsw i64 %501, %500
  %503 = icmp sgt i64 %502, 0
  br i1 %503, label %504, label %515

504:                                              ; preds = %495, %504
  %505 = phi i64 [ %510, %504 ], [ 0, %495 ]
  %506 = getelementptr inbounds double, ptr %496, i64 %505
  %507 = load double, ptr %506, align 8
  %508 = load ptr, ptr %497, align 8
  %509 = getelementptr inbounds double, ptr %508, i64 %505
  store double %507, ptr %509, align 8
  %510 = add nuw nsw i64 %505, 1
  %511 = load i64, ptr %498, align 8
  %512 = load i64, ptr %499, align 8
  %513 = mul nsw i64 %512, %511
  %514 = icmp slt i64 %510, %513
  br i1 %514, label %504, label %515, !llvm.loop !15

515:                                              ; preds = %504, %495
  %516 = load ptr, ptr %6, align 8
  %517 = load ptr, ptr %516, align 8
  %518 = load i64, ptr %22, align 8
  tail call fastcc void @factorise(ptr noundef %517, i64 noundef %518) #8
  br label %519

519:                                              ; preds = %491, %515
  %520 = load ptr, ptr %35, align 8
  %521 = load i64, ptr %13, align 8
  %522 = shl nsw i64 %521, 6
  %523 = getelementptr inbounds i8, ptr %520, i64 %522
  %524 = load i64, ptr %16, align 8
  %525 = load ptr, ptr %6, align 8
  %526 = getelementptr inbounds i8, ptr %525, i64 144
  %527 = load ptr, ptr %526, align 8
  %528 = icmp sgt i64 %524, 0
  br i1 %528, label %529, label %538

529:                                              ; preds = %519, %529
  %530 = phi i64 [ %536, %529 ], [ 0, %519 ]
  %531 = shl nsw i64 %530, 6
  %532 = getelementptr inbounds i8, ptr %523, i64 %531
  %533 = load <8 x double>, ptr %532, align 8
  %534 = fneg <8 x double> %533
  %535 = getelementptr inbounds i8, ptr %527, i64 %531
  store <8 x double> %534, ptr %535, align 8
  %536 = add nuw nsw i64 %530, 1
  %537 = icmp eq i64 %536, %524
  br i1 %537, label %538, label %529, !llvm.loop !16

538:                                              ; preds = %529, %519
  call fastcc void @move_speeds(ptr noundef nonnull %6, ptr noundef %2) #8
  %539 = load ptr, ptr %66, align 8
  %540 = getelementptr inbounds i8, ptr %539, i64 8
  %541 = load i64, ptr %540, align 8
  %542 = load ptr, ptr %43, align 8
  %543 = load i64, ptr %34, align 8
  %544 = trunc i64 %543 to i8
  %545 = bitcast i8 %544 to <8 x i1>
  %546 = load i64, ptr %16, align 8
  %547 = icmp sgt i64 %546, 0
  br i1 %547, label %548, label %555

548:                                              ; preds = %538
  %549 = load ptr, ptr %6, align 8
  %550 = getelementptr inbounds i8, ptr %549, i64 216
  %551 = add nsw i64 %541, 4
  %552 = getelementptr inbounds i8, ptr %549, i64 192
  br label %597

553:                                              ; preds = %597
  %554 = bitcast <8 x double> %621 to <8 x i64>
  br label %555

555:                                              ; preds = %553, %538
  %556 = phi <8 x double> [ zeroinitializer, %538 ], [ %617, %553 ]
  %557 = phi <8 x i64> [ <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, %538 ], [ %554, %553 ]
  %558 = load <8 x double>, ptr %542, align 8
  %559 = getelementptr inbounds i8, ptr %542, i64 128
  %560 = load <8 x double>, ptr %559, align 8
  %561 = fcmp ogt <8 x double> %556, %558
  %562 = select <8 x i1> %561, <8 x i1> %545, <8 x i1> zeroinitializer
  %563 = select <8 x i1> %562, <8 x double> %556, <8 x double> %558
  store <8 x double> %563, ptr %542, align 8
  %564 = getelementptr inbounds i8, ptr %542, i64 64
  %565 = load <8 x i64>, ptr %564, align 8
  %566 = select <8 x i1> %562, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>, <8 x i64> %565
  %567 = bitcast <8 x i64> %566 to <8 x double>
  %568 = fcmp olt <8 x double> %556, %558
  %569 = select <8 x i1> %568, <8 x i64> zeroinitializer, <8 x i64> %557
  %570 = bitcast <8 x i64> %569 to <8 x double>
  %571 = fcmp ogt <8 x double> %560, %570
  %572 = bitcast <8 x double> %560 to <8 x i64>
  %573 = select <8 x i1> %571, <8 x i64> %569, <8 x i64> %572
  %574 = bitcast <8 x i64> %573 to <8 x double>
  %575 = select <8 x i1> %545, <8 x i64> %569, <8 x i64> %572
  store <8 x i64> %575, ptr %559, align 8
  %576 = fcmp oge <8 x double> %574, <double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02>
  %577 = fmul <8 x double> %492, %574
  %578 = fmul <8 x double> %577, <double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02, double 5.000000e-02>
  %579 = fcmp ogt <8 x double> %578, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %580 = or <8 x i1> %579, %576
  %581 = load i64, ptr %34, align 8
  %582 = fcmp ogt <8 x double> %492, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %583 = and <8 x i1> %580, %582
  %584 = bitcast <8 x i1> %583 to i8
  %585 = zext i8 %584 to i64
  %586 = and i64 %581, %585
  %587 = xor i64 %586, %581
  %588 = trunc i64 %587 to i8
  %589 = bitcast i8 %588 to <8 x i1>
  %590 = fcmp olt <8 x double> %570, %567
  %591 = fcmp ogt <8 x double> %567, <double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05, double 1.000000e-05>
  %592 = select <8 x i1> %591, <8 x i1> %590, <8 x i1> zeroinitializer
  %593 = select <8 x i1> %592, <8 x i1> %589, <8 x i1> zeroinitializer
  %594 = select <8 x i1> %593, <8 x i64> %569, <8 x i64> %566
  store <8 x i64> %594, ptr %564, align 8
  %595 = bitcast <8 x i1> %593 to i8
  %596 = icmp eq i8 %595, 0
  br i1 %596, label %641, label %624

597:                                              ; preds = %548, %597
  %598 = phi <8 x double> [ <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %548 ], [ %621, %597 ]
  %599 = phi <8 x double> [ zeroinitializer, %548 ], [ %617, %597 ]
  %600 = phi i64 [ 0, %548 ], [ %622, %597 ]
  %601 = load ptr, ptr %550, align 8
  %602 = shl nsw i64 %600, 6
  %603 = getelementptr inbounds i8, ptr %601, i64 %602
  %604 = load <8 x double>, ptr %603, align 8
  %605 = add nsw i64 %551, %600
  %606 = shl nsw i64 %605, 6
  %607 = getelementptr inbounds i8, ptr %542, i64 %606
  %608 = load <8 x double>, ptr %607, align 8
  %609 = load ptr, ptr %552, align 8
  %610 = getelementptr inbounds i8, ptr %609, i64 %602
  %611 = load <8 x double>, ptr %610, align 8
  %612 = fcmp ogt <8 x double> %611, %608
  %613 = select <8 x i1> %612, <8 x double> %611, <8 x double> %608
  %614 = select <8 x i1> %545, <8 x double> %613, <8 x double> %608
  store <8 x double> %614, ptr %607, align 8
  %615 = fcmp ogt <8 x double> %604, zeroinitializer
  %616 = fadd <8 x double> %599, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %617 = select <8 x i1> %615, <8 x double> %616, <8 x double> %599
  %618 = fdiv <8 x double> %604, %613
  %619 = fcmp olt <8 x double> %618, %598
  %620 = select <8 x i1> %615, <8 x i1> %619, <8 x i1> zeroinitializer
  %621 = select <8 x i1> %620, <8 x double> %618, <8 x double> %598
  %622 = add nuw nsw i64 %600, 1
  %623 = icmp eq i64 %622, %546
  br i1 %623, label %553, label %597, !llvm.loop !19

624:                                              ; preds = %555
  %625 = getelementptr inbounds i8, ptr %542, i64 192
  %626 = load <8 x double>, ptr %625, align 8
  %627 = select <8 x i1> %593, <8 x double> %7, <8 x double> %626
  store <8 x double> %627, ptr %625, align 8
  %628 = getelementptr i8, ptr %542, i64 256
  %629 = icmp sgt i64 %541, 0
  br i1 %629, label %630, label %641

630:                                              ; preds = %624, %630
  %631 = phi i64 [ %639, %630 ], [ 0, %624 ]
  %632 = shl nsw i64 %631, 6
  %633 = getelementptr inbounds i8, ptr %2, i64 %632
  %634 = load <8 x i64>, ptr %633, align 8
  %635 = shl i64 %631, 6
  %636 = getelementptr i8, ptr %628, i64 %635
  %637 = load <8 x i64>, ptr %636, align 8
  %638 = select <8 x i1> %593, <8 x i64> %634, <8 x i64> %637
  store <8 x i64> %638, ptr %636, align 8
  %639 = add nuw nsw i64 %631, 1
  %640 = icmp eq i64 %639, %541
  br i1 %640, label %641, label %630, !llvm.loop !20

641:                                              ; preds = %630, %624, %555
  %642 = or i64 %586, %390
  br label %643

643:                                              ; preds = %359, %641
  %644 = phi i64 [ %364, %359 ], [ %642, %641 ]
  ret i64 %644
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
  br i1 %4, label %5, label %13

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  %7 = getelementptr inbounds i8, ptr %0, i64 160
  %8 = getelementptr inbounds i8, ptr %0, i64 168
  %9 = getelementptr inbounds i8, ptr %0, i64 24
  %10 = getelementptr inbounds i8, ptr %0, i64 192
  %11 = getelementptr inbounds i8, ptr %0, i64 216
  %12 = getelementptr inbounds i8, ptr %0, i64 48
  br label %14

13:                                               ; preds = %21, %1
  ret void

14:                                               ; preds = %5, %21
  %15 = phi i64 [ 0, %5 ], [ %22, %21 ]
  %16 = load ptr, ptr %6, align 8
  %17 = load i64, ptr %7, align 8
  %18 = mul nsw i64 %17, %15
  %19 = getelementptr inbounds i64, ptr %16, i64 %18
  %20 = shl nsw i64 %15, 6
  br label %25

21:                                               ; preds = %71
  %22 = add nuw nsw i64 %15, 1
  %23 = load i64, ptr %2, align 8
  %24 = icmp slt i64 %22, %23
  br i1 %24, label %14, label %13, !llvm.loop !22

25:                                               ; preds = %14, %71
  %26 = phi i64 [ 0, %14 ], [ %98, %71 ]
  %27 = load ptr, ptr %8, align 8
  %28 = getelementptr inbounds i8, ptr %27, i64 %20
  %29 = getelementptr inbounds i64, ptr %28, i64 %26
  %30 = load ptr, ptr %9, align 8
  %31 = getelementptr inbounds double, ptr %30, i64 %26
  %32 = load double, ptr %31, align 8
  %33 = load ptr, ptr %6, align 8
  %34 = load i64, ptr %7, align 8
  %35 = mul nsw i64 %34, %15
  %36 = getelementptr inbounds i64, ptr %33, i64 %35
  %37 = getelementptr inbounds i8, ptr %36, i64 8
  %38 = load i64, ptr %37, align 8
  %39 = load ptr, ptr %10, align 8
  %40 = getelementptr inbounds double, ptr %39, i64 %38
  %41 = load double, ptr %40, align 8
  %42 = fcmp ogt double %41, %32
  %43 = select i1 %42, double %41, double %32
  %44 = getelementptr inbounds i8, ptr %36, i64 16
  %45 = load i64, ptr %44, align 8
  %46 = load i64, ptr %29, align 8
  %47 = getelementptr inbounds double, ptr %40, i64 %46
  %48 = load double, ptr %47, align 8
  %49 = fcmp ugt double %48, %43
  br i1 %49, label %57, label %50

50:                                               ; preds = %25
  %51 = add nsw i64 %45, -1
  %52 = icmp eq i64 %51, %46
  br i1 %52, label %71, label %53

53:                                               ; preds = %50
  %54 = getelementptr i8, ptr %47, i64 8
  %55 = load double, ptr %54, align 8
  %56 = fcmp ogt double %55, %43
  br i1 %56, label %71, label %57

57:                                               ; preds = %53, %25
  %58 = icmp sgt i64 %45, 1
  br i1 %58, label %59, label %71

59:                                               ; preds = %57, %59
  %60 = phi i64 [ %68, %59 ], [ %45, %57 ]
  %61 = phi i64 [ %67, %59 ], [ 0, %57 ]
  %62 = add nsw i64 %60, %61
  %63 = sdiv i64 %62, 2
  %64 = getelementptr inbounds double, ptr %40, i64 %63
  %65 = load double, ptr %64, align 8
  %66 = fcmp ugt double %65, %43
  %67 = select i1 %66, i64 %61, i64 %63
  %68 = select i1 %66, i64 %63, i64 %60
  %69 = sub nsw i64 %68, %67
  %70 = icmp sgt i64 %69, 1
  br i1 %70, label %59, label %71, !llvm.loop !23

71:                                               ; preds = %59, %57, %50, %53
  %72 = phi i64 [ %46, %53 ], [ %46, %50 ], [ 0, %57 ], [ %67, %59 ]
  store i64 %72, ptr %29, align 8
  %73 = getelementptr inbounds double, ptr %40, i64 %72
  %74 = load double, ptr %73, align 8
  %75 = fsub double %43, %74
  %76 = load ptr, ptr %11, align 8
  %77 = add nsw i64 %72, %38
  %78 = shl nsw i64 %77, 5
  %79 = getelementptr inbounds i8, ptr %76, i64 %78
  %80 = load double, ptr %79, align 8
  %81 = getelementptr inbounds i8, ptr %79, i64 8
  %82 = load double, ptr %81, align 8
  %83 = getelementptr inbounds i8, ptr %79, i64 16
  %84 = load double, ptr %83, align 8
  %85 = getelementptr inbounds i8, ptr %79, i64 24
  %86 = load double, ptr %85, align 8
  %87 = fmul double %75, %86
  %88 = fadd double %84, %87
  %89 = fmul double %75, %88
  %90 = fadd double %82, %89
  %91 = fmul double %75, %90
  %92 = fadd double %80, %91
  %93 = load ptr, ptr %12, align 8
  %94 = load i64, ptr %19, align 8
  %95 = shl i64 %94, 6
  %96 = getelementptr i8, ptr %93, i64 %95
  %97 = getelementptr double, ptr %96, i64 %26
  store double %92, ptr %97, align 8
  %98 = add nuw nsw i64 %26, 1
  %99 = icmp eq i64 %98, 8
  br i1 %99, label %21, label %25, !llvm.loop !24
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
