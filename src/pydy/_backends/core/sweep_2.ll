; sources fab7e8697685d4b076e78d4107820b5926e413db149c582429e917795651d42f
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define void @sweep_2(ptr noundef readonly %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, ptr noundef readonly %4, ptr noundef %5, ptr noundef writeonly %6, ptr noundef %7) #0 {
  %9 = alloca [5 x i64], align 16
  %10 = getelementptr inbounds i8, ptr %0, i64 72
  %11 = load i64, ptr %10, align 8
  %12 = add nsw i64 %11, -2
  %13 = getelementptr inbounds i8, ptr %0, i64 80
  %14 = load i64, ptr %13, align 8
  %15 = icmp eq i64 %14, 0
  %16 = getelementptr inbounds i8, ptr %0, i64 88
  %17 = load i64, ptr %16, align 8
  %18 = ptrtoint ptr %7 to i64
  %19 = add i64 %18, 63
  %20 = and i64 %19, -64
  %21 = inttoptr i64 %20 to ptr
  %22 = getelementptr inbounds i8, ptr %0, i64 48
  %23 = load i64, ptr %22, align 8
  %24 = shl nsw i64 %23, 4
  %25 = getelementptr inbounds i8, ptr %21, i64 %24
  %26 = getelementptr inbounds i8, ptr %0, i64 56
  %27 = load i64, ptr %26, align 8
  %28 = shl nsw i64 %27, 4
  %29 = getelementptr inbounds i8, ptr %25, i64 %28
  %30 = getelementptr inbounds i8, ptr %29, i64 16
  %31 = getelementptr inbounds i8, ptr %0, i64 32
  %32 = load i64, ptr %31, align 8
  %33 = shl nsw i64 %32, 4
  %34 = getelementptr inbounds i8, ptr %30, i64 %33
  %35 = getelementptr inbounds i8, ptr %0, i64 40
  %36 = load i64, ptr %35, align 8
  %37 = shl nsw i64 %36, 4
  %38 = getelementptr inbounds i8, ptr %34, i64 %37
  %39 = icmp slt i64 %11, 1
  br i1 %39, label %322, label %40

40:                                               ; preds = %8
  %41 = icmp sgt i64 %23, 0
  br i1 %41, label %42, label %56

42:                                               ; preds = %40, %47
  %43 = phi i64 [ %48, %47 ], [ 0, %40 ]
  %44 = getelementptr inbounds double, ptr %4, i64 %43
  %45 = shl nsw i64 %43, 4
  %46 = getelementptr inbounds i8, ptr %21, i64 %45
  br label %50

47:                                               ; preds = %50
  %48 = add nuw nsw i64 %43, 1
  %49 = icmp eq i64 %48, %23
  br i1 %49, label %56, label %42, !llvm.loop !3

50:                                               ; preds = %42, %50
  %51 = phi i64 [ 0, %42 ], [ %54, %50 ]
  %52 = load double, ptr %44, align 8
  %53 = getelementptr inbounds double, ptr %46, i64 %51
  store double %52, ptr %53, align 8
  %54 = add nuw nsw i64 %51, 1
  %55 = icmp eq i64 %51, 0
  br i1 %55, label %50, label %47, !llvm.loop !6

56:                                               ; preds = %47, %40
  %57 = getelementptr inbounds i8, ptr %0, i64 8
  %58 = load ptr, ptr %57, align 8
  tail call void %58(ptr noundef %21, ptr noundef %25) #3
  br i1 %15, label %59, label %76

59:                                               ; preds = %56
  %60 = load i64, ptr %35, align 8
  %61 = icmp sgt i64 %60, 0
  br i1 %61, label %62, label %76

62:                                               ; preds = %59, %67
  %63 = phi i64 [ %68, %67 ], [ 0, %59 ]
  %64 = getelementptr inbounds double, ptr %3, i64 %63
  %65 = shl nsw i64 %63, 4
  %66 = getelementptr inbounds i8, ptr %34, i64 %65
  br label %70

67:                                               ; preds = %70
  %68 = add nuw nsw i64 %63, 1
  %69 = icmp eq i64 %68, %60
  br i1 %69, label %76, label %62, !llvm.loop !3

70:                                               ; preds = %62, %70
  %71 = phi i64 [ 0, %62 ], [ %74, %70 ]
  %72 = load double, ptr %64, align 8
  %73 = getelementptr inbounds double, ptr %66, i64 %71
  store double %72, ptr %73, align 8
  %74 = add nuw nsw i64 %71, 1
  %75 = icmp eq i64 %71, 0
  br i1 %75, label %70, label %67, !llvm.loop !6

76:                                               ; preds = %67, %59, %56
  %77 = icmp eq i64 %11, 1
  br i1 %77, label %89, label %131

78:                                               ; preds = %113
  %79 = load ptr, ptr %0, align 8
  %80 = tail call i32 %79(ptr noundef %29, ptr noundef nonnull %30, ptr noundef nonnull %34, ptr noundef %25, ptr noundef nonnull %38) #3
  %81 = icmp eq i32 %80, 0
  br i1 %81, label %85, label %82

82:                                               ; preds = %78
  %83 = trunc i32 %80 to i8
  %84 = and i8 %83, 1
  store i8 %84, ptr %6, align 1
  br label %85

85:                                               ; preds = %82, %78
  %86 = getelementptr inbounds i8, ptr %0, i64 64
  %87 = load i64, ptr %86, align 8
  %88 = icmp sgt i64 %87, 0
  br i1 %88, label %122, label %322

89:                                               ; preds = %76, %113
  %90 = phi i64 [ %114, %113 ], [ 0, %76 ]
  %91 = load double, ptr %1, align 8
  %92 = getelementptr inbounds double, ptr %29, i64 %90
  store double %91, ptr %92, align 8
  %93 = load i64, ptr %31, align 8
  %94 = icmp sgt i64 %93, 0
  br i1 %94, label %95, label %97

95:                                               ; preds = %89
  %96 = getelementptr inbounds double, ptr %30, i64 %90
  br label %100

97:                                               ; preds = %100, %89
  br i1 %15, label %113, label %98

98:                                               ; preds = %97
  %99 = getelementptr inbounds double, ptr %34, i64 %90
  br label %109

100:                                              ; preds = %95, %100
  %101 = phi i64 [ %106, %100 ], [ 0, %95 ]
  %102 = getelementptr double, ptr %2, i64 %101
  %103 = load double, ptr %102, align 8
  %104 = shl nsw i64 %101, 4
  %105 = getelementptr inbounds i8, ptr %96, i64 %104
  store double %103, ptr %105, align 8
  %106 = add nuw nsw i64 %101, 1
  %107 = load i64, ptr %31, align 8
  %108 = icmp slt i64 %106, %107
  br i1 %108, label %100, label %97, !llvm.loop !7

109:                                              ; preds = %98, %116
  %110 = phi i64 [ %121, %116 ], [ 0, %98 ]
  %111 = load i64, ptr %35, align 8
  %112 = icmp slt i64 %110, %111
  br i1 %112, label %116, label %113

113:                                              ; preds = %109, %116, %97
  %114 = add nuw nsw i64 %90, 1
  %115 = icmp eq i64 %90, 0
  br i1 %115, label %89, label %78, !llvm.loop !9

116:                                              ; preds = %109
  %117 = getelementptr double, ptr %3, i64 %110
  %118 = load double, ptr %117, align 8
  %119 = shl nsw i64 %110, 4
  %120 = getelementptr inbounds i8, ptr %99, i64 %119
  store double %118, ptr %120, align 8
  %121 = add nuw nsw i64 %110, 1
  br i1 %15, label %113, label %109, !llvm.loop !10

122:                                              ; preds = %85, %122
  %123 = phi i64 [ %128, %122 ], [ 0, %85 ]
  %124 = shl nsw i64 %123, 4
  %125 = getelementptr inbounds i8, ptr %38, i64 %124
  %126 = load double, ptr %125, align 8
  %127 = getelementptr inbounds double, ptr %5, i64 %123
  store double %126, ptr %127, align 8
  %128 = add nuw nsw i64 %123, 1
  %129 = load i64, ptr %86, align 8
  %130 = icmp slt i64 %128, %129
  br i1 %130, label %122, label %322, !llvm.loop !11

131:                                              ; preds = %76
  %132 = icmp eq i64 %17, 0
  br i1 %132, label %133, label %138

133:                                              ; preds = %131
  %134 = getelementptr inbounds i8, ptr %0, i64 64
  %135 = getelementptr i8, ptr %30, i64 16
  %136 = getelementptr i8, ptr %34, i64 16
  %137 = getelementptr i8, ptr %38, i64 16
  br label %187

138:                                              ; preds = %131
  store i64 %11, ptr %9, align 16
  %139 = getelementptr inbounds i8, ptr %9, i64 8
  %140 = select i1 %15, i64 2, i64 %11
  store i64 %140, ptr %139, align 8
  %141 = getelementptr inbounds i8, ptr %9, i64 16
  store i64 %11, ptr %141, align 16
  %142 = getelementptr inbounds i8, ptr %9, i64 24
  store i64 1, ptr %142, align 8
  %143 = getelementptr inbounds i8, ptr %9, i64 32
  %144 = select i1 %15, i64 0, i64 2
  store i64 %144, ptr %143, align 16
  %145 = getelementptr i8, ptr %6, i64 -2
  %146 = ptrtoint ptr %2 to i64
  %147 = shl i64 %146, 60
  %148 = ashr i64 %147, 63
  %149 = getelementptr inbounds i8, ptr %0, i64 16
  %150 = icmp sgt i64 %11, 2
  %151 = add nsw i64 %148, 2
  br label %153

152:                                              ; preds = %183
  br label %322

153:                                              ; preds = %138, %183
  %154 = phi i64 [ 0, %138 ], [ %185, %183 ]
  %155 = call i64 @llvm.smin.i64(i64 %154, i64 %12)
  %156 = icmp eq i64 %154, 0
  br i1 %156, label %160, label %157

157:                                              ; preds = %153
  %158 = sub nsw i64 %11, %155
  %159 = sdiv i64 %158, 2
  store i64 %159, ptr %142, align 8
  br label %160

160:                                              ; preds = %157, %153
  %161 = getelementptr inbounds double, ptr %3, i64 %155
  %162 = select i1 %15, ptr %34, ptr %161
  %163 = load ptr, ptr %149, align 8
  %164 = getelementptr inbounds double, ptr %1, i64 %155
  %165 = getelementptr inbounds double, ptr %2, i64 %155
  %166 = getelementptr inbounds double, ptr %5, i64 %155
  %167 = call i64 %163(ptr noundef %164, ptr noundef %165, ptr noundef %162, ptr noundef %25, ptr noundef %166, ptr noundef nonnull %9) #3
  %168 = ashr i64 %167, 31
  %169 = and i64 %168, -2
  %170 = add nsw i64 %169, %155
  %171 = shl i64 %167, 32
  %172 = ashr exact i64 %171, 32
  %173 = getelementptr i8, ptr %145, i64 %170
  %174 = icmp eq i64 %171, 0
  br i1 %174, label %183, label %175

175:                                              ; preds = %160, %175
  %176 = phi i64 [ %181, %175 ], [ 0, %160 ]
  %177 = lshr i64 %172, %176
  %178 = trunc i64 %177 to i8
  %179 = and i8 %178, 1
  %180 = getelementptr inbounds i8, ptr %173, i64 %176
  store i8 %179, ptr %180, align 1
  %181 = add nuw nsw i64 %176, 1
  %182 = icmp eq i64 %176, 0
  br i1 %182, label %175, label %183, !llvm.loop !12

183:                                              ; preds = %175, %160
  %184 = and i1 %150, %156
  %185 = select i1 %184, i64 %151, i64 %170
  %186 = icmp slt i64 %185, %11
  br i1 %186, label %153, label %152, !llvm.loop !13

187:                                              ; preds = %133, %319
  %188 = phi i64 [ 0, %133 ], [ %320, %319 ]
  %189 = tail call i64 @llvm.smin.i64(i64 %188, i64 %12)
  %190 = getelementptr inbounds double, ptr %1, i64 %189
  %191 = load <2 x double>, ptr %190, align 8
  store <2 x double> %191, ptr %29, align 16
  %192 = load i64, ptr %31, align 8
  %193 = mul nsw i64 %192, %189
  %194 = getelementptr inbounds double, ptr %2, i64 %193
  %195 = icmp sgt i64 %192, 1
  br i1 %195, label %196, label %198

196:                                              ; preds = %187
  %197 = add nsw i64 %192, -2
  br label %201

198:                                              ; preds = %201, %187
  %199 = phi i64 [ 0, %187 ], [ %214, %201 ]
  %200 = icmp slt i64 %199, %192
  br i1 %200, label %217, label %229

201:                                              ; preds = %196, %201
  %202 = phi i64 [ 0, %196 ], [ %214, %201 ]
  %203 = tail call i64 @llvm.smin.i64(i64 %202, i64 %197)
  %204 = getelementptr double, ptr %194, i64 %203
  %205 = load <2 x double>, ptr %204, align 8
  %206 = getelementptr double, ptr %204, i64 %192
  %207 = load <2 x double>, ptr %206, align 8
  %208 = shufflevector <2 x double> %205, <2 x double> %207, <2 x i32> <i32 1, i32 3>
  %209 = shufflevector <2 x double> %205, <2 x double> %207, <2 x i32> <i32 0, i32 2>
  %210 = shl nsw i64 %203, 4
  %211 = getelementptr inbounds i8, ptr %30, i64 %210
  store <2 x double> %209, ptr %211, align 16
  %212 = shl i64 %203, 4
  %213 = getelementptr i8, ptr %135, i64 %212
  store <2 x double> %208, ptr %213, align 8
  %214 = add nsw i64 %203, 2
  %215 = icmp slt i64 %214, %192
  %216 = select i1 %195, i1 %215, i1 false
  br i1 %216, label %201, label %198, !llvm.loop !14

217:                                              ; preds = %198, %217
  %218 = phi i64 [ %227, %217 ], [ %199, %198 ]
  %219 = getelementptr double, ptr %194, i64 %218
  %220 = load double, ptr %219, align 8
  %221 = insertelement <2 x double> poison, double %220, i64 0
  %222 = getelementptr double, ptr %219, i64 %192
  %223 = load double, ptr %222, align 8
  %224 = insertelement <2 x double> %221, double %223, i64 1
  %225 = shl nsw i64 %218, 4
  %226 = getelementptr inbounds i8, ptr %30, i64 %225
  store <2 x double> %224, ptr %226, align 16
  %227 = add nsw i64 %218, 1
  %228 = icmp eq i64 %227, %192
  br i1 %228, label %229, label %217, !llvm.loop !15

229:                                              ; preds = %217, %198
  br i1 %15, label %268, label %230

230:                                              ; preds = %229
  %231 = load i64, ptr %35, align 8
  %232 = mul nsw i64 %231, %189
  %233 = getelementptr inbounds double, ptr %3, i64 %232
  %234 = icmp sgt i64 %231, 1
  br i1 %234, label %235, label %237

235:                                              ; preds = %230
  %236 = add nsw i64 %231, -2
  br label %240

237:                                              ; preds = %240, %230
  %238 = phi i64 [ 0, %230 ], [ %253, %240 ]
  %239 = icmp slt i64 %238, %231
  br i1 %239, label %256, label %268

240:                                              ; preds = %235, %240
  %241 = phi i64 [ 0, %235 ], [ %253, %240 ]
  %242 = tail call i64 @llvm.smin.i64(i64 %241, i64 %236)
  %243 = getelementptr double, ptr %233, i64 %242
  %244 = load <2 x double>, ptr %243, align 8
  %245 = getelementptr double, ptr %243, i64 %231
  %246 = load <2 x double>, ptr %245, align 8
  %247 = shufflevector <2 x double> %244, <2 x double> %246, <2 x i32> <i32 1, i32 3>
  %248 = shufflevector <2 x double> %244, <2 x double> %246, <2 x i32> <i32 0, i32 2>
  %249 = shl nsw i64 %242, 4
  %250 = getelementptr inbounds i8, ptr %34, i64 %249
  store <2 x double> %248, ptr %250, align 8
  %251 = shl i64 %242, 4
  %252 = getelementptr i8, ptr %136, i64 %251
  store <2 x double> %247, ptr %252, align 8
  %253 = add nsw i64 %242, 2
  %254 = icmp slt i64 %253, %231
  %255 = select i1 %234, i1 %254, i1 false
  br i1 %255, label %240, label %237, !llvm.loop !14

256:                                              ; preds = %237, %256
  %257 = phi i64 [ %266, %256 ], [ %238, %237 ]
  %258 = getelementptr double, ptr %233, i64 %257
  %259 = load double, ptr %258, align 8
  %260 = insertelement <2 x double> poison, double %259, i64 0
  %261 = getelementptr double, ptr %258, i64 %231
  %262 = load double, ptr %261, align 8
  %263 = insertelement <2 x double> %260, double %262, i64 1
  %264 = shl nsw i64 %257, 4
  %265 = getelementptr inbounds i8, ptr %34, i64 %264
  store <2 x double> %263, ptr %265, align 8
  %266 = add nsw i64 %257, 1
  %267 = icmp eq i64 %266, %231
  br i1 %267, label %268, label %256, !llvm.loop !15

268:                                              ; preds = %256, %237, %229
  %269 = load ptr, ptr %0, align 8
  %270 = tail call i32 %269(ptr noundef nonnull %29, ptr noundef nonnull %30, ptr noundef nonnull %34, ptr noundef %25, ptr noundef nonnull %38) #3
  %271 = sext i32 %270 to i64
  %272 = getelementptr inbounds i8, ptr %6, i64 %189
  %273 = icmp eq i32 %270, 0
  br i1 %273, label %282, label %274

274:                                              ; preds = %268, %274
  %275 = phi i64 [ %280, %274 ], [ 0, %268 ]
  %276 = lshr i64 %271, %275
  %277 = trunc i64 %276 to i8
  %278 = and i8 %277, 1
  %279 = getelementptr inbounds i8, ptr %272, i64 %275
  store i8 %278, ptr %279, align 1
  %280 = add nuw nsw i64 %275, 1
  %281 = icmp eq i64 %275, 0
  br i1 %281, label %274, label %282, !llvm.loop !12

282:                                              ; preds = %274, %268
  %283 = load i64, ptr %134, align 8
  %284 = mul nsw i64 %283, %189
  %285 = getelementptr inbounds double, ptr %5, i64 %284
  %286 = icmp sgt i64 %283, 1
  br i1 %286, label %287, label %289

287:                                              ; preds = %282
  %288 = add nsw i64 %283, -2
  br label %292

289:                                              ; preds = %292, %282
  %290 = phi i64 [ 0, %282 ], [ %305, %292 ]
  %291 = icmp slt i64 %290, %283
  br i1 %291, label %308, label %319

292:                                              ; preds = %287, %292
  %293 = phi i64 [ 0, %287 ], [ %305, %292 ]
  %294 = tail call i64 @llvm.smin.i64(i64 %293, i64 %288)
  %295 = getelementptr double, ptr %285, i64 %294
  %296 = shl nsw i64 %294, 4
  %297 = getelementptr inbounds i8, ptr %38, i64 %296
  %298 = load <2 x double>, ptr %297, align 8
  %299 = shl i64 %294, 4
  %300 = getelementptr i8, ptr %137, i64 %299
  %301 = load <2 x double>, ptr %300, align 8
  %302 = shufflevector <2 x double> %298, <2 x double> %301, <2 x i32> <i32 1, i32 3>
  %303 = shufflevector <2 x double> %298, <2 x double> %301, <2 x i32> <i32 0, i32 2>
  store <2 x double> %303, ptr %295, align 8
  %304 = getelementptr double, ptr %295, i64 %283
  store <2 x double> %302, ptr %304, align 8
  %305 = add nsw i64 %294, 2
  %306 = icmp slt i64 %305, %283
  %307 = select i1 %286, i1 %306, i1 false
  br i1 %307, label %292, label %289, !llvm.loop !16

308:                                              ; preds = %289, %308
  %309 = phi i64 [ %317, %308 ], [ %290, %289 ]
  %310 = getelementptr double, ptr %285, i64 %309
  %311 = shl nsw i64 %309, 4
  %312 = getelementptr inbounds i8, ptr %38, i64 %311
  %313 = load <2 x double>, ptr %312, align 8
  %314 = extractelement <2 x double> %313, i64 0
  store double %314, ptr %310, align 8
  %315 = extractelement <2 x double> %313, i64 1
  %316 = getelementptr double, ptr %310, i64 %283
  store double %315, ptr %316, align 8
  %317 = add nsw i64 %309, 1
  %318 = icmp eq i64 %317, %283
  br i1 %318, label %319, label %308, !llvm.loop !17

319:                                              ; preds = %308, %289
  %320 = add nuw nsw i64 %188, 2
  %321 = icmp slt i64 %320, %11
  br i1 %321, label %187, label %322, !llvm.loop !18

322:                                              ; preds = %319, %122, %85, %152, %8
  ret void
}



declare i64 @llvm.smin.i64(i64, i64) #2

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { nounwind willreturn memory(none) }
attributes #3 = { nounwind }
attributes #4 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = distinct !{!3, !4, !5}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
!6 = distinct !{!6, !4, !5}
!7 = distinct !{!7, !4, !5, !8}
!8 = !{!"llvm.loop.vectorize.width", i32 1}
!9 = distinct !{!9, !4, !5}
!10 = distinct !{!10, !4, !5, !8}
!11 = distinct !{!11, !4, !5, !8}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5}
!14 = distinct !{!14, !4, !5}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5}
!17 = distinct !{!17, !4, !5}
!18 = distinct !{!18, !4, !5}
