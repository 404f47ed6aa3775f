; sources d4c2d43956383e5b2a464a64d1359e6c9c51b321e5bacf0b6658df7581bb629e
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define range(i64 0, 9) i64 @act_on_event(ptr noundef readonly %0) #0 {
  %2 = getelementptr inbounds i8, ptr %0, i64 720
  %3 = getelementptr inbounds i8, ptr %0, i64 144
  %4 = getelementptr inbounds i8, ptr %0, i64 576
  %5 = getelementptr inbounds i8, ptr %0, i64 624
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 632
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
  %20 = getelementptr inbounds i8, ptr %0, i64 600
  %21 = load ptr, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %21, i64 80
  %23 = load i64, ptr %22, align 8
  %24 = getelementptr inbounds i8, ptr %0, i64 312
  %25 = load ptr, ptr %24, align 8
  %26 = load ptr, ptr %4, align 8
  %27 = getelementptr inbounds i8, ptr %0, i64 1176
  %28 = load ptr, ptr %27, align 8
  %29 = load double, ptr %26, align 8
  %30 = getelementptr inbounds i8, ptr %0, i64 936
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds double, ptr %31, i64 %16
  %33 = getelementptr inbounds i8, ptr %0, i64 1152
  %34 = load ptr, ptr %33, align 8
  %35 = getelementptr inbounds double, ptr %34, i64 %16
  %36 = icmp sgt i64 %16, 0
  br i1 %36, label %37, label %52

37:                                               ; preds = %1
  %38 = getelementptr inbounds i8, ptr %0, i64 912
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
  br i1 %47, label %257, label %48

48:                                               ; preds = %46, %40
  %49 = phi i64 [ %41, %40 ], [ %42, %46 ]
  %50 = add nuw nsw i64 %42, 1
  %51 = icmp eq i64 %50, %16
  br i1 %51, label %52, label %40, !llvm.loop !3

52:                                               ; preds = %48, %1
  %53 = phi i64 [ -1, %1 ], [ %49, %48 ]
  %54 = icmp slt i64 %53, 0
  br i1 %54, label %257, label %55

55:                                               ; preds = %52
  %56 = getelementptr inbounds i8, ptr %0, i64 816
  %57 = load ptr, ptr %56, align 8
  %58 = getelementptr inbounds i64, ptr %57, i64 %53
  %59 = load i64, ptr %58, align 8
  %60 = and i64 %59, 4
  %61 = icmp eq i64 %60, 0
  br i1 %61, label %257, label %62

62:                                               ; preds = %55
  %63 = add nsw i64 %23, 1
  %64 = add nsw i64 %63, %16
  %65 = getelementptr inbounds i8, ptr %0, i64 1008
  %66 = getelementptr inbounds i8, ptr %0, i64 1016
  %67 = load i64, ptr %66, align 8
  %68 = icmp sgt i64 %64, %67
  br i1 %68, label %257, label %69

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
  %86 = getelementptr inbounds i8, ptr %0, i64 1128
  %87 = load ptr, ptr %86, align 8
  %88 = inttoptr i64 %81 to ptr
  %89 = tail call i32 %88(ptr noundef %83, ptr noundef %25, ptr noundef %85, ptr noundef %87, ptr noundef %28) #4
  %90 = icmp eq i32 %89, 0
  br i1 %90, label %91, label %257

91:                                               ; preds = %78
  %92 = load ptr, ptr %2, align 8
  %93 = load i64, ptr %92, align 8
  %94 = load ptr, ptr %82, align 8
  %95 = load ptr, ptr %84, align 8
  %96 = getelementptr inbounds i8, ptr %0, i64 744
  %97 = load ptr, ptr %96, align 8
  %98 = inttoptr i64 %93 to ptr
  %99 = tail call i32 %98(ptr noundef %94, ptr noundef %25, ptr noundef %95, ptr noundef %97, ptr noundef %31) #4
  %100 = icmp eq i32 %99, 0
  br i1 %100, label %101, label %257

101:                                              ; preds = %91
  %102 = load ptr, ptr %2, align 8
  %103 = load i64, ptr %102, align 8
  %104 = load ptr, ptr %82, align 8
  %105 = load ptr, ptr %84, align 8
  %106 = load ptr, ptr %96, align 8
  %107 = inttoptr i64 %103 to ptr
  %108 = tail call i32 %107(ptr noundef %104, ptr noundef %71, ptr noundef %105, ptr noundef %106, ptr noundef %32) #4
  %109 = icmp eq i32 %108, 0
  br i1 %109, label %110, label %257

110:                                              ; preds = %101
  %111 = load ptr, ptr %2, align 8
  %112 = getelementptr inbounds i8, ptr %111, i64 56
  %113 = load i64, ptr %112, align 8
  %114 = load ptr, ptr %82, align 8
  %115 = load ptr, ptr %84, align 8
  %116 = getelementptr inbounds i8, ptr %0, i64 1104
  %117 = load ptr, ptr %116, align 8
  %118 = load ptr, ptr %33, align 8
  %119 = inttoptr i64 %113 to ptr
  %120 = tail call i32 %119(ptr noundef %114, ptr noundef %71, ptr noundef %115, ptr noundef %117, ptr noundef %118) #4
  %121 = icmp eq i32 %120, 0
  br i1 %121, label %122, label %257

122:                                              ; preds = %110
  %123 = icmp sgt i64 %19, 0
  br i1 %123, label %131, label %127

124:                                              ; preds = %131
  %125 = add nuw nsw i64 %132, 1
  %126 = icmp eq i64 %125, %19
  br i1 %126, label %127, label %131, !llvm.loop !6

127:                                              ; preds = %124, %122
  %128 = icmp sgt i64 %16, 0
  br i1 %128, label %129, label %152

129:                                              ; preds = %127
  %130 = getelementptr inbounds i8, ptr %0, i64 888
  br label %137

131:                                              ; preds = %122, %124
  %132 = phi i64 [ %125, %124 ], [ 0, %122 ]
  %133 = getelementptr inbounds double, ptr %71, i64 %132
  %134 = load double, ptr %133, align 8
  %135 = tail call double @llvm.fabs.f64(double %134)
  %136 = fcmp ueq double %135, 0x7FF0000000000000
  br i1 %136, label %257, label %124

137:                                              ; preds = %129, %149
  %138 = phi i64 [ 0, %129 ], [ %150, %149 ]
  %139 = icmp eq i64 %138, %53
  br i1 %139, label %149, label %140

140:                                              ; preds = %137
  %141 = load ptr, ptr %130, align 8
  %142 = getelementptr inbounds i64, ptr %141, i64 %138
  %143 = load i64, ptr %142, align 8
  %144 = icmp eq i64 %143, 0
  br i1 %144, label %149, label %145

145:                                              ; preds = %140
  %146 = getelementptr inbounds double, ptr %32, i64 %138
  %147 = load double, ptr %146, align 8
  %148 = fcmp uno double %147, 0.000000e+00
  br i1 %148, label %257, label %149

149:                                              ; preds = %137, %140, %145
  %150 = add nuw nsw i64 %138, 1
  %151 = icmp eq i64 %150, %16
  br i1 %151, label %152, label %137, !llvm.loop !7

152:                                              ; preds = %149, %127
  %153 = getelementptr inbounds double, ptr %32, i64 %53
  %154 = load double, ptr %153, align 8
  %155 = getelementptr inbounds double, ptr %31, i64 %53
  %156 = load double, ptr %155, align 8
  %157 = fcmp une double %154, %156
  br i1 %157, label %158, label %164

158:                                              ; preds = %152
  %159 = getelementptr inbounds double, ptr %35, i64 %53
  %160 = load double, ptr %159, align 8
  %161 = fmul double %160, 0x3CE0000000000000
  %162 = tail call double @llvm.fabs.f64(double %154)
  %163 = fcmp ule double %162, %161
  br label %164

164:                                              ; preds = %158, %152
  %165 = phi i1 [ true, %152 ], [ %163, %158 ]
  %166 = icmp sgt i64 %16, 0
  br i1 %166, label %167, label %169

167:                                              ; preds = %164
  %168 = getelementptr inbounds i8, ptr %0, i64 888
  br label %180

169:                                              ; preds = %180, %164
  %170 = load ptr, ptr %65, align 8
  %171 = getelementptr inbounds double, ptr %170, i64 %23
  store double %29, ptr %171, align 8
  %172 = getelementptr inbounds i8, ptr %0, i64 1032
  %173 = load ptr, ptr %172, align 8
  %174 = getelementptr inbounds i64, ptr %173, i64 %23
  store i64 %53, ptr %174, align 8
  %175 = icmp sgt i64 %19, 0
  br i1 %175, label %176, label %202

176:                                              ; preds = %169
  %177 = getelementptr inbounds i8, ptr %0, i64 1056
  %178 = mul nsw i64 %23, %19
  %179 = getelementptr inbounds i8, ptr %0, i64 1080
  br label %209

180:                                              ; preds = %167, %180
  %181 = phi i64 [ 0, %167 ], [ %200, %180 ]
  %182 = getelementptr inbounds double, ptr %32, i64 %181
  %183 = load double, ptr %182, align 8
  %184 = fcmp oeq double %183, 0.000000e+00
  %185 = icmp eq i64 %181, %53
  %186 = select i1 %185, i1 %165, i1 false
  %187 = select i1 %184, i1 true, i1 %186
  %188 = getelementptr inbounds double, ptr %34, i64 %181
  %189 = select i1 %187, ptr %188, ptr %182
  %190 = load double, ptr %189, align 8
  %191 = tail call double @llvm.fabs.f64(double %190)
  %192 = fcmp ueq double %191, 0x7FF0000000000000
  %193 = fcmp ogt double %190, 0.000000e+00
  %194 = fcmp olt double %190, 0.000000e+00
  %195 = sext i1 %194 to i64
  %196 = select i1 %193, i64 1, i64 %195
  %197 = select i1 %192, i64 0, i64 %196
  %198 = load ptr, ptr %168, align 8
  %199 = getelementptr inbounds i64, ptr %198, i64 %181
  store i64 %197, ptr %199, align 8
  %200 = add nuw nsw i64 %181, 1
  %201 = icmp eq i64 %200, %16
  br i1 %201, label %169, label %180, !llvm.loop !8

202:                                              ; preds = %209, %169
  %203 = load ptr, ptr %20, align 8
  %204 = getelementptr inbounds i8, ptr %203, i64 80
  store i64 %63, ptr %204, align 8
  %205 = load ptr, ptr %0, align 8
  %206 = getelementptr inbounds i8, ptr %205, i64 8
  %207 = load i64, ptr %206, align 8
  %208 = icmp eq i64 %207, 0
  br i1 %208, label %222, label %228

209:                                              ; preds = %176, %209
  %210 = phi i64 [ 0, %176 ], [ %220, %209 ]
  %211 = getelementptr inbounds double, ptr %25, i64 %210
  %212 = load double, ptr %211, align 8
  %213 = load ptr, ptr %177, align 8
  %214 = add nsw i64 %210, %178
  %215 = getelementptr inbounds double, ptr %213, i64 %214
  store double %212, ptr %215, align 8
  %216 = getelementptr inbounds double, ptr %71, i64 %210
  %217 = load double, ptr %216, align 8
  store double %217, ptr %211, align 8
  %218 = load ptr, ptr %179, align 8
  %219 = getelementptr inbounds double, ptr %218, i64 %214
  store double %217, ptr %219, align 8
  %220 = add nuw nsw i64 %210, 1
  %221 = icmp eq i64 %220, %19
  br i1 %221, label %202, label %209, !llvm.loop !9

222:                                              ; preds = %202
  %223 = getelementptr inbounds i8, ptr %0, i64 1224
  %224 = load ptr, ptr %223, align 8
  %225 = getelementptr inbounds i8, ptr %224, i64 8
  %226 = load double, ptr %225, align 8
  %227 = getelementptr inbounds i8, ptr %26, i64 8
  store double %226, ptr %227, align 8
  br label %228

228:                                              ; preds = %222, %202
  %229 = getelementptr inbounds i8, ptr %0, i64 1200
  %230 = load ptr, ptr %229, align 8
  %231 = mul i64 %53, 800
  %232 = getelementptr inbounds i8, ptr %230, i64 %231
  %233 = load double, ptr %232, align 8
  %234 = fsub double %29, %233
  %235 = tail call double @llvm.fabs.f64(double %29)
  %236 = fcmp ogt double %235, %13
  %237 = select i1 %236, double %235, double %13
  %238 = fmul double %237, 0x3CF0000000000000
  %239 = fcmp ugt double %234, %238
  br i1 %239, label %240, label %247

240:                                              ; preds = %228
  %241 = getelementptr inbounds i8, ptr %232, i64 784
  %242 = load double, ptr %241, align 8
  %243 = fsub double %29, %242
  %244 = fmul double %13, 1.000000e-09
  %245 = fcmp olt double %243, %244
  %246 = select i1 %245, i64 8, i64 1
  br label %247

247:                                              ; preds = %240, %228
  %248 = phi i64 [ 8, %228 ], [ %246, %240 ]
  br label %250

249:                                              ; preds = %250
  store double %29, ptr %232, align 8
  br label %257

250:                                              ; preds = %247, %250
  %251 = phi i64 [ 99, %247 ], [ %255, %250 ]
  %252 = getelementptr double, ptr %232, i64 %251
  %253 = getelementptr i8, ptr %252, i64 -8
  %254 = load double, ptr %253, align 8
  store double %254, ptr %252, align 8
  %255 = add nsw i64 %251, -1
  %256 = icmp ugt i64 %251, 1
  br i1 %256, label %250, label %249, !llvm.loop !10

257:                                              ; preds = %46, %131, %145, %249, %110, %101, %91, %78, %52, %55, %62
  %258 = phi i64 [ 0, %62 ], [ 0, %55 ], [ 0, %52 ], [ %248, %249 ], [ 0, %110 ], [ 0, %101 ], [ 0, %91 ], [ 0, %78 ], [ 0, %145 ], [ 0, %131 ], [ 0, %46 ]
  ret i64 %258
}

declare double @llvm.fabs.f64(double) #1

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
  br i1 %55, label %44, label %56, !llvm.loop !11

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
  br i1 %83, label %13, label %12, !llvm.loop !12
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
