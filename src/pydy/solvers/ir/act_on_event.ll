; sources 367b443af8af250e1c6837de3a320e81e7c883ff4d1f0b711bb630e7f36c7328
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define range(i64 0, 2) i64 @act_on_event(ptr noundef readonly %0) #0 {
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
  br i1 %47, label %238, label %48

48:                                               ; preds = %46, %40
  %49 = phi i64 [ %41, %40 ], [ %42, %46 ]
  %50 = add nuw nsw i64 %42, 1
  %51 = icmp eq i64 %50, %16
  br i1 %51, label %52, label %40, !llvm.loop !3

52:                                               ; preds = %48, %1
  %53 = phi i64 [ -1, %1 ], [ %49, %48 ]
  %54 = icmp slt i64 %53, 0
  br i1 %54, label %238, label %55

55:                                               ; preds = %52
  %56 = getelementptr inbounds i8, ptr %0, i64 816
  %57 = load ptr, ptr %56, align 8
  %58 = getelementptr inbounds i64, ptr %57, i64 %53
  %59 = load i64, ptr %58, align 8
  %60 = and i64 %59, 4
  %61 = icmp eq i64 %60, 0
  br i1 %61, label %238, label %62

62:                                               ; preds = %55
  %63 = getelementptr inbounds i8, ptr %0, i64 1200
  %64 = load ptr, ptr %63, align 8
  %65 = getelementptr inbounds double, ptr %64, i64 %53
  %66 = load double, ptr %65, align 8
  %67 = fsub double %29, %66
  %68 = fmul double %13, 1.000000e-09
  %69 = fcmp ogt double %67, %68
  br i1 %69, label %70, label %238

70:                                               ; preds = %62
  %71 = add nsw i64 %23, 1
  %72 = add nsw i64 %71, %16
  %73 = getelementptr inbounds i8, ptr %0, i64 1008
  %74 = getelementptr inbounds i8, ptr %0, i64 1016
  %75 = load i64, ptr %74, align 8
  %76 = icmp sgt i64 %72, %75
  br i1 %76, label %238, label %77

77:                                               ; preds = %70
  %78 = mul nsw i64 %53, %19
  %79 = getelementptr inbounds double, ptr %28, i64 %78
  %80 = getelementptr inbounds i8, ptr %0, i64 168
  %81 = load ptr, ptr %80, align 8
  store double %29, ptr %81, align 8
  %82 = getelementptr inbounds i8, ptr %0, i64 248
  %83 = load i64, ptr %82, align 8
  %84 = icmp sgt i64 %83, 0
  br i1 %84, label %85, label %86

85:                                               ; preds = %77
  tail call fastcc void @sample(ptr noundef nonnull %3) #3
  br label %86

86:                                               ; preds = %77, %85
  %87 = load ptr, ptr %2, align 8
  %88 = getelementptr inbounds i8, ptr %87, i64 64
  %89 = load i64, ptr %88, align 8
  %90 = getelementptr inbounds i8, ptr %0, i64 168
  %91 = load ptr, ptr %90, align 8
  %92 = getelementptr inbounds i8, ptr %0, i64 192
  %93 = load ptr, ptr %92, align 8
  %94 = getelementptr inbounds i8, ptr %0, i64 1128
  %95 = load ptr, ptr %94, align 8
  %96 = inttoptr i64 %89 to ptr
  %97 = tail call i32 %96(ptr noundef %91, ptr noundef %25, ptr noundef %93, ptr noundef %95, ptr noundef %28) #4
  %98 = icmp eq i32 %97, 0
  br i1 %98, label %99, label %238

99:                                               ; preds = %86
  %100 = load ptr, ptr %2, align 8
  %101 = load i64, ptr %100, align 8
  %102 = load ptr, ptr %90, align 8
  %103 = load ptr, ptr %92, align 8
  %104 = getelementptr inbounds i8, ptr %0, i64 744
  %105 = load ptr, ptr %104, align 8
  %106 = inttoptr i64 %101 to ptr
  %107 = tail call i32 %106(ptr noundef %102, ptr noundef %25, ptr noundef %103, ptr noundef %105, ptr noundef %31) #4
  %108 = icmp eq i32 %107, 0
  br i1 %108, label %109, label %238

109:                                              ; preds = %99
  %110 = load ptr, ptr %2, align 8
  %111 = load i64, ptr %110, align 8
  %112 = load ptr, ptr %90, align 8
  %113 = load ptr, ptr %92, align 8
  %114 = load ptr, ptr %104, align 8
  %115 = inttoptr i64 %111 to ptr
  %116 = tail call i32 %115(ptr noundef %112, ptr noundef %79, ptr noundef %113, ptr noundef %114, ptr noundef %32) #4
  %117 = icmp eq i32 %116, 0
  br i1 %117, label %118, label %238

118:                                              ; preds = %109
  %119 = load ptr, ptr %2, align 8
  %120 = getelementptr inbounds i8, ptr %119, i64 56
  %121 = load i64, ptr %120, align 8
  %122 = load ptr, ptr %90, align 8
  %123 = load ptr, ptr %92, align 8
  %124 = getelementptr inbounds i8, ptr %0, i64 1104
  %125 = load ptr, ptr %124, align 8
  %126 = load ptr, ptr %33, align 8
  %127 = inttoptr i64 %121 to ptr
  %128 = tail call i32 %127(ptr noundef %122, ptr noundef %79, ptr noundef %123, ptr noundef %125, ptr noundef %126) #4
  %129 = icmp eq i32 %128, 0
  br i1 %129, label %130, label %238

130:                                              ; preds = %118
  %131 = icmp sgt i64 %19, 0
  br i1 %131, label %139, label %135

132:                                              ; preds = %139
  %133 = add nuw nsw i64 %140, 1
  %134 = icmp eq i64 %133, %19
  br i1 %134, label %135, label %139, !llvm.loop !6

135:                                              ; preds = %132, %130
  %136 = icmp sgt i64 %16, 0
  br i1 %136, label %137, label %160

137:                                              ; preds = %135
  %138 = getelementptr inbounds i8, ptr %0, i64 888
  br label %145

139:                                              ; preds = %130, %132
  %140 = phi i64 [ %133, %132 ], [ 0, %130 ]
  %141 = getelementptr inbounds double, ptr %79, i64 %140
  %142 = load double, ptr %141, align 8
  %143 = tail call double @llvm.fabs.f64(double %142)
  %144 = fcmp ueq double %143, 0x7FF0000000000000
  br i1 %144, label %238, label %132

145:                                              ; preds = %137, %157
  %146 = phi i64 [ 0, %137 ], [ %158, %157 ]
  %147 = icmp eq i64 %146, %53
  br i1 %147, label %157, label %148

148:                                              ; preds = %145
  %149 = load ptr, ptr %138, align 8
  %150 = getelementptr inbounds i64, ptr %149, i64 %146
  %151 = load i64, ptr %150, align 8
  %152 = icmp eq i64 %151, 0
  br i1 %152, label %157, label %153

153:                                              ; preds = %148
  %154 = getelementptr inbounds double, ptr %32, i64 %146
  %155 = load double, ptr %154, align 8
  %156 = fcmp uno double %155, 0.000000e+00
  br i1 %156, label %238, label %157

157:                                              ; preds = %145, %148, %153
  %158 = add nuw nsw i64 %146, 1
  %159 = icmp eq i64 %158, %16
  br i1 %159, label %160, label %145, !llvm.loop !7

160:                                              ; preds = %157, %135
  %161 = getelementptr inbounds double, ptr %32, i64 %53
  %162 = load double, ptr %161, align 8
  %163 = getelementptr inbounds double, ptr %31, i64 %53
  %164 = load double, ptr %163, align 8
  %165 = fcmp une double %162, %164
  br i1 %165, label %166, label %172

166:                                              ; preds = %160
  %167 = getelementptr inbounds double, ptr %35, i64 %53
  %168 = load double, ptr %167, align 8
  %169 = fmul double %168, 0x3CE0000000000000
  %170 = tail call double @llvm.fabs.f64(double %162)
  %171 = fcmp ule double %170, %169
  br label %172

172:                                              ; preds = %166, %160
  %173 = phi i1 [ true, %160 ], [ %171, %166 ]
  %174 = icmp sgt i64 %16, 0
  br i1 %174, label %175, label %177

175:                                              ; preds = %172
  %176 = getelementptr inbounds i8, ptr %0, i64 888
  br label %190

177:                                              ; preds = %190, %172
  %178 = load ptr, ptr %73, align 8
  %179 = getelementptr inbounds double, ptr %178, i64 %23
  store double %29, ptr %179, align 8
  %180 = load ptr, ptr %63, align 8
  %181 = getelementptr inbounds double, ptr %180, i64 %53
  store double %29, ptr %181, align 8
  %182 = getelementptr inbounds i8, ptr %0, i64 1032
  %183 = load ptr, ptr %182, align 8
  %184 = getelementptr inbounds i64, ptr %183, i64 %23
  store i64 %53, ptr %184, align 8
  %185 = icmp sgt i64 %19, 0
  br i1 %185, label %186, label %212

186:                                              ; preds = %177
  %187 = getelementptr inbounds i8, ptr %0, i64 1056
  %188 = mul nsw i64 %23, %19
  %189 = getelementptr inbounds i8, ptr %0, i64 1080
  br label %219

190:                                              ; preds = %175, %190
  %191 = phi i64 [ 0, %175 ], [ %210, %190 ]
  %192 = getelementptr inbounds double, ptr %32, i64 %191
  %193 = load double, ptr %192, align 8
  %194 = fcmp oeq double %193, 0.000000e+00
  %195 = icmp eq i64 %191, %53
  %196 = select i1 %195, i1 %173, i1 false
  %197 = select i1 %194, i1 true, i1 %196
  %198 = getelementptr inbounds double, ptr %34, i64 %191
  %199 = select i1 %197, ptr %198, ptr %192
  %200 = load double, ptr %199, align 8
  %201 = tail call double @llvm.fabs.f64(double %200)
  %202 = fcmp ueq double %201, 0x7FF0000000000000
  %203 = fcmp ogt double %200, 0.000000e+00
  %204 = fcmp olt double %200, 0.000000e+00
  %205 = sext i1 %204 to i64
  %206 = select i1 %203, i64 1, i64 %205
  %207 = select i1 %202, i64 0, i64 %206
  %208 = load ptr, ptr %176, align 8
  %209 = getelementptr inbounds i64, ptr %208, i64 %191
  store i64 %207, ptr %209, align 8
  %210 = add nuw nsw i64 %191, 1
  %211 = icmp eq i64 %210, %16
  br i1 %211, label %177, label %190, !llvm.loop !8

212:                                              ; preds = %219, %177
  %213 = load ptr, ptr %20, align 8
  %214 = getelementptr inbounds i8, ptr %213, i64 80
  store i64 %71, ptr %214, align 8
  %215 = load ptr, ptr %0, align 8
  %216 = getelementptr inbounds i8, ptr %215, i64 8
  %217 = load i64, ptr %216, align 8
  %218 = icmp eq i64 %217, 0
  br i1 %218, label %232, label %238

219:                                              ; preds = %186, %219
  %220 = phi i64 [ 0, %186 ], [ %230, %219 ]
  %221 = getelementptr inbounds double, ptr %25, i64 %220
  %222 = load double, ptr %221, align 8
  %223 = load ptr, ptr %187, align 8
  %224 = add nsw i64 %220, %188
  %225 = getelementptr inbounds double, ptr %223, i64 %224
  store double %222, ptr %225, align 8
  %226 = getelementptr inbounds double, ptr %79, i64 %220
  %227 = load double, ptr %226, align 8
  store double %227, ptr %221, align 8
  %228 = load ptr, ptr %189, align 8
  %229 = getelementptr inbounds double, ptr %228, i64 %224
  store double %227, ptr %229, align 8
  %230 = add nuw nsw i64 %220, 1
  %231 = icmp eq i64 %230, %19
  br i1 %231, label %212, label %219, !llvm.loop !9

232:                                              ; preds = %212
  %233 = getelementptr inbounds i8, ptr %0, i64 1224
  %234 = load ptr, ptr %233, align 8
  %235 = getelementptr inbounds i8, ptr %234, i64 8
  %236 = load double, ptr %235, align 8
  %237 = getelementptr inbounds i8, ptr %26, i64 8
  store double %236, ptr %237, align 8
  br label %238

238:                                              ; preds = %46, %139, %153, %118, %109, %99, %86, %232, %212, %52, %55, %62, %70
  %239 = phi i64 [ 0, %70 ], [ 0, %62 ], [ 0, %55 ], [ 0, %52 ], [ 0, %118 ], [ 0, %109 ], [ 0, %99 ], [ 0, %86 ], [ 1, %232 ], [ 1, %212 ], [ 0, %153 ], [ 0, %139 ], [ 0, %46 ]
  ret i64 %239
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
  br i1 %55, label %44, label %56, !llvm.loop !10

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
  br i1 %83, label %13, label %12, !llvm.loop !11
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
