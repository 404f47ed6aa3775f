; sources a831be2bb14a9b189ddb7584ab42aa77c9ed1cdeb3651ad0f1b88e2e85e87a48
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
  br i1 %47, label %261, label %48

48:                                               ; preds = %46, %40
  %49 = phi i64 [ %41, %40 ], [ %42, %46 ]
  %50 = add nuw nsw i64 %42, 1
  %51 = icmp eq i64 %50, %16
  br i1 %51, label %52, label %40, !llvm.loop !3

52:                                               ; preds = %48, %1
  %53 = phi i64 [ -1, %1 ], [ %49, %48 ]
  %54 = icmp slt i64 %53, 0
  br i1 %54, label %261, label %55

55:                                               ; preds = %52
  %56 = getelementptr inbounds i8, ptr %0, i64 864
  %57 = load ptr, ptr %56, align 8
  %58 = getelementptr inbounds i64, ptr %57, i64 %53
  %59 = load i64, ptr %58, align 8
  %60 = and i64 %59, 4
  %61 = icmp eq i64 %60, 0
  br i1 %61, label %261, label %62

62:                                               ; preds = %55
  %63 = add nsw i64 %23, 1
  %64 = add nsw i64 %63, %16
  %65 = getelementptr inbounds i8, ptr %0, i64 1056
  %66 = getelementptr inbounds i8, ptr %0, i64 1064
  %67 = load i64, ptr %66, align 8
  %68 = icmp sgt i64 %64, %67
  br i1 %68, label %261, label %69

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
  br i1 %91, label %92, label %261

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
  br i1 %102, label %103, label %261

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
  br i1 %112, label %113, label %261

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
  br i1 %125, label %126, label %261

126:                                              ; preds = %113
  %127 = icmp sgt i64 %19, 0
  br i1 %127, label %135, label %131

128:                                              ; preds = %135
  %129 = add nuw nsw i64 %136, 1
  %130 = icmp eq i64 %129, %19
  br i1 %130, label %131, label %135, !llvm.loop !6

131:                                              ; preds = %128, %126
  %132 = icmp sgt i64 %16, 0
  br i1 %132, label %133, label %156

133:                                              ; preds = %131
  %134 = getelementptr inbounds i8, ptr %0, i64 936
  br label %141

135:                                              ; preds = %126, %128
  %136 = phi i64 [ %129, %128 ], [ 0, %126 ]
  %137 = getelementptr inbounds double, ptr %71, i64 %136
  %138 = load double, ptr %137, align 8
  %139 = tail call double @llvm.fabs.f64(double %138)
  %140 = fcmp ueq double %139, 0x7FF0000000000000
  br i1 %140, label %261, label %128

141:                                              ; preds = %133, %153
  %142 = phi i64 [ 0, %133 ], [ %154, %153 ]
  %143 = icmp eq i64 %142, %53
  br i1 %143, label %153, label %144

144:                                              ; preds = %141
  %145 = load ptr, ptr %134, align 8
  %146 = getelementptr inbounds i64, ptr %145, i64 %142
  %147 = load i64, ptr %146, align 8
  %148 = icmp eq i64 %147, 0
  br i1 %148, label %153, label %149

149:                                              ; preds = %144
  %150 = getelementptr inbounds double, ptr %32, i64 %142
  %151 = load double, ptr %150, align 8
  %152 = fcmp uno double %151, 0.000000e+00
  br i1 %152, label %261, label %153

153:                                              ; preds = %141, %144, %149
  %154 = add nuw nsw i64 %142, 1
  %155 = icmp eq i64 %154, %16
  br i1 %155, label %156, label %141, !llvm.loop !7

156:                                              ; preds = %153, %131
  %157 = getelementptr inbounds double, ptr %32, i64 %53
  %158 = load double, ptr %157, align 8
  %159 = getelementptr inbounds double, ptr %31, i64 %53
  %160 = load double, ptr %159, align 8
  %161 = fcmp une double %158, %160
  br i1 %161, label %162, label %168

162:                                              ; preds = %156
  %163 = getelementptr inbounds double, ptr %35, i64 %53
  %164 = load double, ptr %163, align 8
  %165 = fmul double %164, 0x3CE0000000000000
  %166 = tail call double @llvm.fabs.f64(double %158)
  %167 = fcmp ule double %166, %165
  br label %168

168:                                              ; preds = %162, %156
  %169 = phi i1 [ true, %156 ], [ %167, %162 ]
  %170 = icmp sgt i64 %16, 0
  br i1 %170, label %171, label %173

171:                                              ; preds = %168
  %172 = getelementptr inbounds i8, ptr %0, i64 936
  br label %184

173:                                              ; preds = %184, %168
  %174 = load ptr, ptr %65, align 8
  %175 = getelementptr inbounds double, ptr %174, i64 %23
  store double %29, ptr %175, align 8
  %176 = getelementptr inbounds i8, ptr %0, i64 1080
  %177 = load ptr, ptr %176, align 8
  %178 = getelementptr inbounds i64, ptr %177, i64 %23
  store i64 %53, ptr %178, align 8
  %179 = icmp sgt i64 %19, 0
  br i1 %179, label %180, label %206

180:                                              ; preds = %173
  %181 = getelementptr inbounds i8, ptr %0, i64 1104
  %182 = mul nsw i64 %23, %19
  %183 = getelementptr inbounds i8, ptr %0, i64 1128
  br label %213

184:                                              ; preds = %171, %184
  %185 = phi i64 [ 0, %171 ], [ %204, %184 ]
  %186 = getelementptr inbounds double, ptr %32, i64 %185
  %187 = load double, ptr %186, align 8
  %188 = fcmp oeq double %187, 0.000000e+00
  %189 = icmp eq i64 %185, %53
  %190 = select i1 %189, i1 %169, i1 false
  %191 = select i1 %188, i1 true, i1 %190
  %192 = getelementptr inbounds double, ptr %34, i64 %185
  %193 = select i1 %191, ptr %192, ptr %186
  %194 = load double, ptr %193, align 8
  %195 = tail call double @llvm.fabs.f64(double %194)
  %196 = fcmp ueq double %195, 0x7FF0000000000000
  %197 = fcmp ogt double %194, 0.000000e+00
  %198 = fcmp olt double %194, 0.000000e+00
  %199 = sext i1 %198 to i64
  %200 = select i1 %197, i64 1, i64 %199
  %201 = select i1 %196, i64 0, i64 %200
  %202 = load ptr, ptr %172, align 8
  %203 = getelementptr inbounds i64, ptr %202, i64 %185
  store i64 %201, ptr %203, align 8
  %204 = add nuw nsw i64 %185, 1
  %205 = icmp eq i64 %204, %16
  br i1 %205, label %173, label %184, !llvm.loop !8

206:                                              ; preds = %213, %173
  %207 = load ptr, ptr %20, align 8
  %208 = getelementptr inbounds i8, ptr %207, i64 80
  store i64 %63, ptr %208, align 8
  %209 = load ptr, ptr %0, align 8
  %210 = getelementptr inbounds i8, ptr %209, i64 8
  %211 = load i64, ptr %210, align 8
  %212 = icmp eq i64 %211, 0
  br i1 %212, label %226, label %232

213:                                              ; preds = %180, %213
  %214 = phi i64 [ 0, %180 ], [ %224, %213 ]
  %215 = getelementptr inbounds double, ptr %25, i64 %214
  %216 = load double, ptr %215, align 8
  %217 = load ptr, ptr %181, align 8
  %218 = add nsw i64 %214, %182
  %219 = getelementptr inbounds double, ptr %217, i64 %218
  store double %216, ptr %219, align 8
  %220 = getelementptr inbounds double, ptr %71, i64 %214
  %221 = load double, ptr %220, align 8
  store double %221, ptr %215, align 8
  %222 = load ptr, ptr %183, align 8
  %223 = getelementptr inbounds double, ptr %222, i64 %218
  store double %221, ptr %223, align 8
  %224 = add nuw nsw i64 %214, 1
  %225 = icmp eq i64 %224, %19
  br i1 %225, label %206, label %213, !llvm.loop !9

226:                                              ; preds = %206
  %227 = getelementptr inbounds i8, ptr %0, i64 1272
  %228 = load ptr, ptr %227, align 8
  %229 = getelementptr inbounds i8, ptr %228, i64 8
  %230 = load double, ptr %229, align 8
  %231 = getelementptr inbounds i8, ptr %26, i64 8
  store double %230, ptr %231, align 8
  br label %232

232:                                              ; preds = %226, %206
  %233 = getelementptr inbounds i8, ptr %0, i64 1248
  %234 = load ptr, ptr %233, align 8
  %235 = mul i64 %53, 800
  %236 = getelementptr inbounds i8, ptr %234, i64 %235
  %237 = load double, ptr %236, align 8
  %238 = fsub double %29, %237
  %239 = tail call double @llvm.fabs.f64(double %29)
  %240 = fcmp ogt double %239, %13
  %241 = select i1 %240, double %239, double %13
  %242 = fmul double %241, 0x3CF0000000000000
  %243 = fcmp ugt double %238, %242
  br i1 %243, label %244, label %251

244:                                              ; preds = %232
  %245 = getelementptr inbounds i8, ptr %236, i64 784
  %246 = load double, ptr %245, align 8
  %247 = fsub double %29, %246
  %248 = fmul double %13, 1.000000e-09
  %249 = fcmp olt double %247, %248
  %250 = select i1 %249, i64 8, i64 1
  br label %251

251:                                              ; preds = %244, %232
  %252 = phi i64 [ 8, %232 ], [ %250, %244 ]
  br label %254

253:                                              ; preds = %254
  store double %29, ptr %236, align 8
  br label %261

254:                                              ; preds = %251, %254
  %255 = phi i64 [ 99, %251 ], [ %259, %254 ]
  %256 = getelementptr double, ptr %236, i64 %255
  %257 = getelementptr i8, ptr %256, i64 -8
  %258 = load double, ptr %257, align 8
  store double %258, ptr %256, align 8
  %259 = add nsw i64 %255, -1
  %260 = icmp ugt i64 %255, 1
  br i1 %260, label %254, label %253, !llvm.loop !10

261:                                              ; preds = %46, %135, %149, %253, %113, %103, %92, %78, %52, %55, %62
  %262 = phi i64 [ 0, %62 ], [ 0, %55 ], [ 0, %52 ], [ %252, %253 ], [ 0, %113 ], [ 0, %103 ], [ 0, %92 ], [ 0, %78 ], [ 0, %149 ], [ 0, %135 ], [ 0, %46 ]
  ret i64 %262
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
