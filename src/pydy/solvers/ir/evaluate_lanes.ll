; sources 2cdadf43e411ed42e130b602e263b93a388fe137e66c47c79143ed07ac165b63
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define noundef i64 @evaluate_lanes(ptr noundef readonly %0) #0 {
  %2 = getelementptr inbounds i8, ptr %0, i64 240
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %3, i64 8
  %5 = load i64, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 312
  %7 = getelementptr inbounds i8, ptr %0, i64 320
  %8 = load i64, ptr %7, align 8
  %9 = getelementptr inbounds i8, ptr %0, i64 360
  %10 = getelementptr inbounds i8, ptr %0, i64 368
  %11 = load i64, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 288
  %13 = getelementptr inbounds i8, ptr %0, i64 296
  %14 = load i64, ptr %13, align 8
  %15 = sdiv i64 %14, 8
  %16 = load ptr, ptr %2, align 8
  %17 = load ptr, ptr %12, align 8
  %18 = load i64, ptr %16, align 8
  %19 = inttoptr i64 %18 to ptr
  %20 = icmp sgt i64 %8, 0
  br i1 %20, label %21, label %44

21:                                               ; preds = %1
  %22 = getelementptr inbounds i8, ptr %0, i64 48
  %23 = getelementptr inbounds i8, ptr %0, i64 328
  %24 = getelementptr inbounds i8, ptr %0, i64 336
  %25 = getelementptr inbounds i8, ptr %0, i64 72
  %26 = getelementptr inbounds i8, ptr %0, i64 352
  %27 = getelementptr inbounds i8, ptr %0, i64 128
  %28 = getelementptr inbounds i8, ptr %0, i64 120
  %29 = getelementptr inbounds i8, ptr %0, i64 72
  %30 = icmp sgt i64 %11, 0
  %31 = getelementptr inbounds i8, ptr %16, i64 16
  %32 = getelementptr inbounds i8, ptr %16, i64 24
  %33 = icmp sgt i64 %5, 0
  %34 = getelementptr inbounds i8, ptr %16, i64 8
  %35 = getelementptr inbounds i8, ptr %0, i64 264
  %36 = getelementptr inbounds i8, ptr %0, i64 264
  %37 = getelementptr inbounds i8, ptr %0, i64 24
  %38 = getelementptr inbounds i8, ptr %0, i64 152
  %39 = getelementptr inbounds i8, ptr %0, i64 48
  %40 = getelementptr inbounds i8, ptr %0, i64 96
  %41 = icmp slt i64 %5, 1
  %42 = icmp sgt i64 %14, 7
  %43 = getelementptr inbounds i8, ptr %0, i64 384
  br label %45

44:                                               ; preds = %118, %1
  ret i64 0

45:                                               ; preds = %21, %118
  %46 = phi i64 [ %8, %21 ], [ %121, %118 ]
  %47 = phi i64 [ 0, %21 ], [ %119, %118 ]
  %48 = tail call i64 @llvm.smin.i64(i64 %46, i64 8)
  %49 = tail call i64 @llvm.smax.i64(i64 %48, i64 1)
  %50 = sub nsw i64 %8, %47
  %51 = tail call i64 @llvm.smin.i64(i64 %50, i64 8)
  %52 = add nsw i64 %51, -1
  br label %75

53:                                               ; preds = %113
  %54 = load i64, ptr %27, align 8
  %55 = icmp sgt i64 %54, 0
  br i1 %55, label %60, label %56

56:                                               ; preds = %60, %53
  br i1 %30, label %57, label %118

57:                                               ; preds = %56
  %58 = add nsw i64 %51, -1
  %59 = icmp sgt i64 %50, 0
  br label %116

60:                                               ; preds = %53, %60
  %61 = phi i64 [ %72, %60 ], [ 0, %53 ]
  %62 = load ptr, ptr %28, align 8
  %63 = shl nuw nsw i64 %61, 1
  %64 = getelementptr inbounds i64, ptr %62, i64 %63
  %65 = load i64, ptr %64, align 8
  %66 = inttoptr i64 %65 to ptr
  %67 = load ptr, ptr %29, align 8
  %68 = or disjoint i64 %63, 1
  %69 = getelementptr inbounds i64, ptr %62, i64 %68
  %70 = load i64, ptr %69, align 8
  %71 = inttoptr i64 %70 to ptr
  tail call void %66(ptr noundef %67, ptr noundef %71) #3
  %72 = add nuw nsw i64 %61, 1
  %73 = load i64, ptr %27, align 8
  %74 = icmp slt i64 %72, %73
  br i1 %74, label %60, label %56, !llvm.loop !3

75:                                               ; preds = %45, %113
  %76 = phi i64 [ 0, %45 ], [ %114, %113 ]
  %77 = icmp sgt i64 %50, %76
  %78 = select i1 %77, i64 %76, i64 %52
  %79 = add nsw i64 %78, %47
  %80 = load ptr, ptr %22, align 8
  %81 = load ptr, ptr %6, align 8
  %82 = load i64, ptr %23, align 8
  %83 = mul nsw i64 %82, %79
  %84 = getelementptr inbounds double, ptr %81, i64 %83
  %85 = getelementptr double, ptr %80, i64 %76
  %86 = icmp sgt i64 %82, 0
  br i1 %86, label %87, label %96

87:                                               ; preds = %75, %87
  %88 = phi i64 [ %93, %87 ], [ 0, %75 ]
  %89 = getelementptr inbounds double, ptr %84, i64 %88
  %90 = load double, ptr %89, align 8
  %91 = shl i64 %88, 6
  %92 = getelementptr i8, ptr %85, i64 %91
  store double %90, ptr %92, align 8
  %93 = add nuw nsw i64 %88, 1
  %94 = load i64, ptr %23, align 8
  %95 = icmp slt i64 %93, %94
  br i1 %95, label %87, label %96, !llvm.loop !6

96:                                               ; preds = %87, %75
  %97 = load ptr, ptr %25, align 8
  %98 = load ptr, ptr %24, align 8
  %99 = load i64, ptr %26, align 8
  %100 = mul nsw i64 %99, %79
  %101 = getelementptr inbounds double, ptr %98, i64 %100
  %102 = getelementptr double, ptr %97, i64 %76
  %103 = icmp sgt i64 %99, 0
  br i1 %103, label %104, label %113

104:                                              ; preds = %96, %104
  %105 = phi i64 [ %110, %104 ], [ 0, %96 ]
  %106 = getelementptr inbounds double, ptr %101, i64 %105
  %107 = load double, ptr %106, align 8
  %108 = shl i64 %105, 6
  %109 = getelementptr i8, ptr %102, i64 %108
  store double %107, ptr %109, align 8
  %110 = add nuw nsw i64 %105, 1
  %111 = load i64, ptr %26, align 8
  %112 = icmp slt i64 %110, %111
  br i1 %112, label %104, label %113, !llvm.loop !6

113:                                              ; preds = %104, %96
  %114 = add nuw nsw i64 %76, 1
  %115 = icmp eq i64 %114, 8
  br i1 %115, label %53, label %75, !llvm.loop !8

116:                                              ; preds = %57, %169
  %117 = phi i64 [ 0, %57 ], [ %170, %169 ]
  br label %143

118:                                              ; preds = %169, %56
  %119 = add nuw nsw i64 %47, 8
  %120 = icmp slt i64 %119, %8
  %121 = add i64 %46, -8
  br i1 %120, label %45, label %44, !llvm.loop !9

122:                                              ; preds = %154
  %123 = load ptr, ptr %9, align 8
  %124 = getelementptr inbounds double, ptr %123, i64 %117
  %125 = load double, ptr %124, align 8
  %126 = insertelement <8 x double> poison, double %125, i64 0
  %127 = shufflevector <8 x double> %126, <8 x double> poison, <8 x i32> zeroinitializer
  %128 = load ptr, ptr %36, align 8
  %129 = load ptr, ptr %12, align 8
  %130 = load ptr, ptr %37, align 8
  store <8 x double> %127, ptr %130, align 8
  %131 = load i64, ptr %38, align 8
  %132 = icmp sgt i64 %131, 0
  br i1 %132, label %133, label %134

133:                                              ; preds = %122
  tail call fastcc void @sample(ptr noundef %0) #4
  br label %134

134:                                              ; preds = %122, %133
  %135 = load ptr, ptr %0, align 8
  %136 = load i64, ptr %135, align 8
  %137 = load ptr, ptr %37, align 8
  %138 = load ptr, ptr %39, align 8
  %139 = load ptr, ptr %40, align 8
  %140 = inttoptr i64 %136 to ptr
  %141 = tail call i32 %140(ptr noundef %137, ptr noundef %128, ptr noundef %138, ptr noundef %139, ptr noundef %129) #3
  %142 = sext i32 %141 to i64
  br i1 %59, label %172, label %169

143:                                              ; preds = %116, %154
  %144 = phi i64 [ 0, %116 ], [ %155, %154 ]
  %145 = icmp sgt i64 %50, %144
  %146 = select i1 %145, i64 %144, i64 %58
  %147 = add nsw i64 %146, %47
  %148 = load i64, ptr %31, align 8
  %149 = mul nsw i64 %148, %147
  %150 = getelementptr inbounds double, ptr %19, i64 %149
  %151 = load i64, ptr %32, align 8
  %152 = mul nsw i64 %151, %117
  %153 = getelementptr inbounds double, ptr %150, i64 %152
  br i1 %33, label %157, label %154

154:                                              ; preds = %157, %143
  %155 = add nuw nsw i64 %144, 1
  %156 = icmp eq i64 %155, 8
  br i1 %156, label %122, label %143, !llvm.loop !10

157:                                              ; preds = %143, %157
  %158 = phi i64 [ %167, %157 ], [ 0, %143 ]
  %159 = load i64, ptr %34, align 8
  %160 = mul nsw i64 %159, %158
  %161 = getelementptr inbounds double, ptr %153, i64 %160
  %162 = load double, ptr %161, align 8
  %163 = load ptr, ptr %35, align 8
  %164 = shl nsw i64 %158, 6
  %165 = getelementptr inbounds i8, ptr %163, i64 %164
  %166 = getelementptr inbounds double, ptr %165, i64 %144
  store double %162, ptr %166, align 8
  %167 = add nuw nsw i64 %158, 1
  %168 = icmp eq i64 %167, %5
  br i1 %168, label %154, label %157, !llvm.loop !11

169:                                              ; preds = %188, %134
  %170 = add nuw nsw i64 %117, 1
  %171 = icmp eq i64 %170, %11
  br i1 %171, label %118, label %116, !llvm.loop !12

172:                                              ; preds = %134, %188
  %173 = phi i64 [ %189, %188 ], [ 0, %134 ]
  %174 = shl nuw i64 1, %173
  %175 = and i64 %174, %142
  %176 = icmp ne i64 %175, 0
  %177 = select i1 %176, i1 true, i1 %41
  br i1 %177, label %183, label %178

178:                                              ; preds = %172
  %179 = load ptr, ptr %36, align 8
  %180 = getelementptr inbounds double, ptr %179, i64 %173
  %181 = load double, ptr %180, align 8
  %182 = fcmp uno double %181, 0.000000e+00
  br label %183

183:                                              ; preds = %172, %178
  %184 = phi i1 [ %176, %172 ], [ %182, %178 ]
  %185 = getelementptr inbounds double, ptr %17, i64 %173
  br i1 %42, label %186, label %188

186:                                              ; preds = %183
  %187 = add nuw nsw i64 %173, %47
  br label %191

188:                                              ; preds = %197, %183
  %189 = add nuw nsw i64 %173, 1
  %190 = icmp eq i64 %189, %49
  br i1 %190, label %169, label %172, !llvm.loop !13

191:                                              ; preds = %186, %197
  %192 = phi i64 [ 0, %186 ], [ %205, %197 ]
  br i1 %184, label %197, label %193

193:                                              ; preds = %191
  %194 = shl nsw i64 %192, 6
  %195 = getelementptr inbounds i8, ptr %185, i64 %194
  %196 = load double, ptr %195, align 8
  br label %197

197:                                              ; preds = %191, %193
  %198 = phi double [ %196, %193 ], [ 0x7FF8000000000000, %191 ]
  %199 = load ptr, ptr %43, align 8
  %200 = mul nuw nsw i64 %192, %8
  %201 = add nuw i64 %187, %200
  %202 = mul nsw i64 %201, %11
  %203 = getelementptr double, ptr %199, i64 %202
  %204 = getelementptr double, ptr %203, i64 %117
  store double %198, ptr %204, align 8
  %205 = add nuw nsw i64 %192, 1
  %206 = icmp eq i64 %205, %15
  br i1 %206, label %188, label %191, !llvm.loop !14
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #1 {
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
  br i1 %24, label %14, label %13, !llvm.loop !15

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
  br i1 %70, label %59, label %71, !llvm.loop !16

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
  br i1 %99, label %21, label %25, !llvm.loop !17
}

declare i64 @llvm.smin.i64(i64, i64) #2

declare i64 @llvm.smax.i64(i64, i64) #2

attributes #0 = { nounwind }
attributes #1 = { noinline nounwind }
attributes #2 = { nounwind willreturn memory(none) }
attributes #3 = { nounwind }
attributes #4 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = distinct !{!3, !4, !5}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
!6 = distinct !{!6, !4, !5, !7}
!7 = !{!"llvm.loop.vectorize.width", i32 1}
!8 = distinct !{!8, !4, !5}
!9 = distinct !{!9, !4, !5}
!10 = distinct !{!10, !4, !5}
!11 = distinct !{!11, !4, !5, !7}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5}
!14 = distinct !{!14, !4, !5, !7}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5}
!17 = distinct !{!17, !4, !5}
