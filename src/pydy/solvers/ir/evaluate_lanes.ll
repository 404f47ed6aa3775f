; sources 4f05aba301fe0da5d26b1308cc22bc39f928c164473a811cab2d15ccc518bf73
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define noundef i64 @evaluate_lanes(ptr noundef readonly %0) #0 {
  %2 = getelementptr inbounds i8, ptr %0, i64 216
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %3, i64 8
  %5 = load i64, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 288
  %7 = getelementptr inbounds i8, ptr %0, i64 296
  %8 = load i64, ptr %7, align 8
  %9 = getelementptr inbounds i8, ptr %0, i64 336
  %10 = getelementptr inbounds i8, ptr %0, i64 344
  %11 = load i64, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 264
  %13 = getelementptr inbounds i8, ptr %0, i64 272
  %14 = load i64, ptr %13, align 8
  %15 = sdiv i64 %14, 8
  %16 = load ptr, ptr %2, align 8
  %17 = load ptr, ptr %12, align 8
  %18 = load i64, ptr %16, align 8
  %19 = inttoptr i64 %18 to ptr
  %20 = icmp sgt i64 %8, 0
  br i1 %20, label %21, label %42

21:                                               ; preds = %1
  %22 = getelementptr inbounds i8, ptr %0, i64 48
  %23 = getelementptr inbounds i8, ptr %0, i64 304
  %24 = getelementptr inbounds i8, ptr %0, i64 312
  %25 = getelementptr inbounds i8, ptr %0, i64 72
  %26 = getelementptr inbounds i8, ptr %0, i64 328
  %27 = getelementptr inbounds i8, ptr %0, i64 72
  %28 = getelementptr inbounds i8, ptr %0, i64 96
  %29 = icmp sgt i64 %11, 0
  %30 = getelementptr inbounds i8, ptr %16, i64 16
  %31 = getelementptr inbounds i8, ptr %16, i64 24
  %32 = icmp sgt i64 %5, 0
  %33 = getelementptr inbounds i8, ptr %16, i64 8
  %34 = getelementptr inbounds i8, ptr %0, i64 240
  %35 = getelementptr inbounds i8, ptr %0, i64 240
  %36 = getelementptr inbounds i8, ptr %0, i64 24
  %37 = getelementptr inbounds i8, ptr %0, i64 128
  %38 = getelementptr inbounds i8, ptr %0, i64 48
  %39 = icmp slt i64 %5, 1
  %40 = icmp sgt i64 %14, 7
  %41 = getelementptr inbounds i8, ptr %0, i64 360
  br label %43

42:                                               ; preds = %104, %1
  ret i64 0

43:                                               ; preds = %21, %104
  %44 = phi i64 [ %8, %21 ], [ %107, %104 ]
  %45 = phi i64 [ 0, %21 ], [ %105, %104 ]
  %46 = tail call i64 @llvm.smin.i64(i64 %44, i64 8)
  %47 = tail call i64 @llvm.smax.i64(i64 %46, i64 1)
  %48 = sub nsw i64 %8, %45
  %49 = tail call i64 @llvm.smin.i64(i64 %48, i64 8)
  %50 = add nsw i64 %49, -1
  br label %61

51:                                               ; preds = %99
  %52 = load ptr, ptr %0, align 8
  %53 = getelementptr inbounds i8, ptr %52, i64 40
  %54 = load i64, ptr %53, align 8
  %55 = inttoptr i64 %54 to ptr
  %56 = load ptr, ptr %27, align 8
  %57 = load ptr, ptr %28, align 8
  tail call void %55(ptr noundef %56, ptr noundef %57) #3
  br i1 %29, label %58, label %104

58:                                               ; preds = %51
  %59 = add nsw i64 %49, -1
  %60 = icmp sgt i64 %48, 0
  br label %102

61:                                               ; preds = %43, %99
  %62 = phi i64 [ 0, %43 ], [ %100, %99 ]
  %63 = icmp sgt i64 %48, %62
  %64 = select i1 %63, i64 %62, i64 %50
  %65 = add nsw i64 %64, %45
  %66 = load ptr, ptr %22, align 8
  %67 = load ptr, ptr %6, align 8
  %68 = load i64, ptr %23, align 8
  %69 = mul nsw i64 %68, %65
  %70 = getelementptr inbounds double, ptr %67, i64 %69
  %71 = getelementptr double, ptr %66, i64 %62
  %72 = icmp sgt i64 %68, 0
  br i1 %72, label %73, label %82

73:                                               ; preds = %61, %73
  %74 = phi i64 [ %79, %73 ], [ 0, %61 ]
  %75 = getelementptr inbounds double, ptr %70, i64 %74
  %76 = load double, ptr %75, align 8
  %77 = shl i64 %74, 6
  %78 = getelementptr i8, ptr %71, i64 %77
  store double %76, ptr %78, align 8
  %79 = add nuw nsw i64 %74, 1
  %80 = load i64, ptr %23, align 8
  %81 = icmp slt i64 %79, %80
  br i1 %81, label %73, label %82, !llvm.loop !3

82:                                               ; preds = %73, %61
  %83 = load ptr, ptr %25, align 8
  %84 = load ptr, ptr %24, align 8
  %85 = load i64, ptr %26, align 8
  %86 = mul nsw i64 %85, %65
  %87 = getelementptr inbounds double, ptr %84, i64 %86
  %88 = getelementptr double, ptr %83, i64 %62
  %89 = icmp sgt i64 %85, 0
  br i1 %89, label %90, label %99

90:                                               ; preds = %82, %90
  %91 = phi i64 [ %96, %90 ], [ 0, %82 ]
  %92 = getelementptr inbounds double, ptr %87, i64 %91
  %93 = load double, ptr %92, align 8
  %94 = shl i64 %91, 6
  %95 = getelementptr i8, ptr %88, i64 %94
  store double %93, ptr %95, align 8
  %96 = add nuw nsw i64 %91, 1
  %97 = load i64, ptr %26, align 8
  %98 = icmp slt i64 %96, %97
  br i1 %98, label %90, label %99, !llvm.loop !3

99:                                               ; preds = %90, %82
  %100 = add nuw nsw i64 %62, 1
  %101 = icmp eq i64 %100, 8
  br i1 %101, label %51, label %61, !llvm.loop !7

102:                                              ; preds = %58, %155
  %103 = phi i64 [ 0, %58 ], [ %156, %155 ]
  br label %129

104:                                              ; preds = %155, %51
  %105 = add nuw nsw i64 %45, 8
  %106 = icmp slt i64 %105, %8
  %107 = add i64 %44, -8
  br i1 %106, label %43, label %42, !llvm.loop !8

108:                                              ; preds = %140
  %109 = load ptr, ptr %9, align 8
  %110 = getelementptr inbounds double, ptr %109, i64 %103
  %111 = load double, ptr %110, align 8
  %112 = insertelement <8 x double> poison, double %111, i64 0
  %113 = shufflevector <8 x double> %112, <8 x double> poison, <8 x i32> zeroinitializer
  %114 = load ptr, ptr %35, align 8
  %115 = load ptr, ptr %12, align 8
  %116 = load ptr, ptr %36, align 8
  store <8 x double> %113, ptr %116, align 8
  %117 = load i64, ptr %37, align 8
  %118 = icmp sgt i64 %117, 0
  br i1 %118, label %119, label %120

119:                                              ; preds = %108
  tail call fastcc void @sample(ptr noundef nonnull %0) #4
  br label %120

120:                                              ; preds = %108, %119
  %121 = load ptr, ptr %0, align 8
  %122 = load i64, ptr %121, align 8
  %123 = load ptr, ptr %36, align 8
  %124 = load ptr, ptr %38, align 8
  %125 = load ptr, ptr %28, align 8
  %126 = inttoptr i64 %122 to ptr
  %127 = tail call i32 %126(ptr noundef %123, ptr noundef %114, ptr noundef %124, ptr noundef %125, ptr noundef %115) #3
  %128 = sext i32 %127 to i64
  br i1 %60, label %158, label %155

129:                                              ; preds = %102, %140
  %130 = phi i64 [ 0, %102 ], [ %141, %140 ]
  %131 = icmp sgt i64 %48, %130
  %132 = select i1 %131, i64 %130, i64 %59
  %133 = add nsw i64 %132, %45
  %134 = load i64, ptr %30, align 8
  %135 = mul nsw i64 %134, %133
  %136 = getelementptr inbounds double, ptr %19, i64 %135
  %137 = load i64, ptr %31, align 8
  %138 = mul nsw i64 %137, %103
  %139 = getelementptr inbounds double, ptr %136, i64 %138
  br i1 %32, label %143, label %140

140:                                              ; preds = %143, %129
  %141 = add nuw nsw i64 %130, 1
  %142 = icmp eq i64 %141, 8
  br i1 %142, label %108, label %129, !llvm.loop !9

143:                                              ; preds = %129, %143
  %144 = phi i64 [ %153, %143 ], [ 0, %129 ]
  %145 = load i64, ptr %33, align 8
  %146 = mul nsw i64 %145, %144
  %147 = getelementptr inbounds double, ptr %139, i64 %146
  %148 = load double, ptr %147, align 8
  %149 = load ptr, ptr %34, align 8
  %150 = shl nsw i64 %144, 6
  %151 = getelementptr inbounds i8, ptr %149, i64 %150
  %152 = getelementptr inbounds double, ptr %151, i64 %130
  store double %148, ptr %152, align 8
  %153 = add nuw nsw i64 %144, 1
  %154 = icmp eq i64 %153, %5
  br i1 %154, label %140, label %143, !llvm.loop !10

155:                                              ; preds = %174, %120
  %156 = add nuw nsw i64 %103, 1
  %157 = icmp eq i64 %156, %11
  br i1 %157, label %104, label %102, !llvm.loop !11

158:                                              ; preds = %120, %174
  %159 = phi i64 [ %175, %174 ], [ 0, %120 ]
  %160 = shl nuw i64 1, %159
  %161 = and i64 %160, %128
  %162 = icmp ne i64 %161, 0
  %163 = select i1 %162, i1 true, i1 %39
  br i1 %163, label %169, label %164

164:                                              ; preds = %158
  %165 = load ptr, ptr %35, align 8
  %166 = getelementptr inbounds double, ptr %165, i64 %159
  %167 = load double, ptr %166, align 8
  %168 = fcmp uno double %167, 0.000000e+00
  br label %169

169:                                              ; preds = %158, %164
  %170 = phi i1 [ %162, %158 ], [ %168, %164 ]
  %171 = getelementptr inbounds double, ptr %17, i64 %159
  br i1 %40, label %172, label %174

172:                                              ; preds = %169
  %173 = add nuw nsw i64 %159, %45
  br label %177

174:                                              ; preds = %183, %169
  %175 = add nuw nsw i64 %159, 1
  %176 = icmp eq i64 %175, %47
  br i1 %176, label %155, label %158, !llvm.loop !12

177:                                              ; preds = %172, %183
  %178 = phi i64 [ 0, %172 ], [ %191, %183 ]
  br i1 %170, label %183, label %179

179:                                              ; preds = %177
  %180 = shl nsw i64 %178, 6
  %181 = getelementptr inbounds i8, ptr %171, i64 %180
  %182 = load double, ptr %181, align 8
  br label %183

183:                                              ; preds = %177, %179
  %184 = phi double [ %182, %179 ], [ 0x7FF8000000000000, %177 ]
  %185 = load ptr, ptr %41, align 8
  %186 = mul nuw nsw i64 %178, %8
  %187 = add nuw i64 %173, %186
  %188 = mul nsw i64 %187, %11
  %189 = getelementptr double, ptr %185, i64 %188
  %190 = getelementptr double, ptr %189, i64 %103
  store double %184, ptr %190, align 8
  %191 = add nuw nsw i64 %178, 1
  %192 = icmp eq i64 %191, %15
  br i1 %192, label %174, label %177, !llvm.loop !13
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #1 {
  %2 = getelementptr inbounds i8, ptr %0, i64 128
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %13

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 120
  %7 = getelementptr inbounds i8, ptr %0, i64 136
  %8 = getelementptr inbounds i8, ptr %0, i64 144
  %9 = getelementptr inbounds i8, ptr %0, i64 24
  %10 = getelementptr inbounds i8, ptr %0, i64 168
  %11 = getelementptr inbounds i8, ptr %0, i64 192
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
  br i1 %24, label %14, label %13, !llvm.loop !14

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
  br i1 %70, label %59, label %71, !llvm.loop !15

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
  br i1 %99, label %21, label %25, !llvm.loop !16
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
!3 = distinct !{!3, !4, !5, !6}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
!6 = !{!"llvm.loop.vectorize.width", i32 1}
!7 = distinct !{!7, !4, !5}
!8 = distinct !{!8, !4, !5}
!9 = distinct !{!9, !4, !5}
!10 = distinct !{!10, !4, !5, !6}
!11 = distinct !{!11, !4, !5}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5, !6}
!14 = distinct !{!14, !4, !5}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5}
