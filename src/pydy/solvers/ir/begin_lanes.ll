; sources d392c8dd76895548176e6df4ec438ca41b8a8b8a72ed19fdc5f7b744650ff87f
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define noundef i64 @begin_lanes(ptr noundef %0) #0 {
  %2 = alloca [8 x double], align 16
  %3 = getelementptr inbounds i8, ptr %0, i64 1056
  %4 = getelementptr inbounds i8, ptr %0, i64 1072
  %5 = load i64, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 1064
  %7 = load i64, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %0, i64 1680
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %9, i64 56
  %11 = load i64, ptr %10, align 8
  %12 = inttoptr i64 %11 to ptr
  %13 = getelementptr inbounds i8, ptr %0, i64 432
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 1728
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %0, i64 1736
  %18 = load i64, ptr %17, align 8
  %19 = getelementptr inbounds double, ptr %16, i64 %18
  %20 = getelementptr inbounds i8, ptr %0, i64 1216
  %21 = load i64, ptr %20, align 8
  %22 = mul i64 %21, -64
  %23 = getelementptr inbounds i8, ptr %19, i64 %22
  %24 = icmp sgt i64 %7, 0
  br i1 %24, label %25, label %43

25:                                               ; preds = %1
  %26 = getelementptr inbounds i8, ptr %0, i64 1032
  %27 = getelementptr inbounds i8, ptr %0, i64 1072
  %28 = getelementptr inbounds i8, ptr %0, i64 1080
  %29 = getelementptr inbounds i8, ptr %0, i64 192
  %30 = getelementptr inbounds i8, ptr %0, i64 1096
  %31 = getelementptr inbounds i8, ptr %0, i64 1104
  %32 = getelementptr inbounds i8, ptr %0, i64 216
  %33 = getelementptr inbounds i8, ptr %0, i64 1120
  %34 = getelementptr inbounds i8, ptr %0, i64 1200
  %35 = getelementptr inbounds i8, ptr %0, i64 1216
  %36 = getelementptr inbounds i8, ptr %0, i64 272
  %37 = getelementptr inbounds i8, ptr %0, i64 264
  %38 = getelementptr inbounds i8, ptr %0, i64 216
  %39 = getelementptr inbounds i8, ptr %0, i64 1200
  %40 = getelementptr inbounds i8, ptr %0, i64 1216
  %41 = getelementptr inbounds i8, ptr %0, i64 1072
  %42 = icmp slt i64 %5, 1
  br label %44

43:                                               ; preds = %152, %1
  ret i64 0

44:                                               ; preds = %25, %152
  %45 = phi i64 [ %7, %25 ], [ %155, %152 ]
  %46 = phi i64 [ 0, %25 ], [ %153, %152 ]
  %47 = call i64 @llvm.smin.i64(i64 %45, i64 8)
  %48 = call i64 @llvm.smax.i64(i64 %47, i64 1)
  %49 = sub nsw i64 %7, %46
  %50 = call i64 @llvm.smin.i64(i64 %49, i64 8)
  %51 = add nsw i64 %50, -1
  br label %76

52:                                               ; preds = %149
  %53 = load i64, ptr %36, align 8
  %54 = icmp sgt i64 %53, 0
  br i1 %54, label %55, label %71

55:                                               ; preds = %52, %55
  %56 = phi i64 [ %68, %55 ], [ 0, %52 ]
  %57 = load ptr, ptr %37, align 8
  %58 = shl nuw nsw i64 %56, 1
  %59 = getelementptr inbounds i64, ptr %57, i64 %58
  %60 = load i64, ptr %59, align 8
  %61 = inttoptr i64 %60 to ptr
  %62 = load ptr, ptr %61, align 8
  %63 = load ptr, ptr %38, align 8
  %64 = or disjoint i64 %58, 1
  %65 = getelementptr inbounds i64, ptr %57, i64 %64
  %66 = load i64, ptr %65, align 8
  %67 = inttoptr i64 %66 to ptr
  call void %62(ptr noundef %63, ptr noundef %67) #4
  %68 = add nuw nsw i64 %56, 1
  %69 = load i64, ptr %36, align 8
  %70 = icmp slt i64 %68, %69
  br i1 %70, label %55, label %71, !llvm.loop !3

71:                                               ; preds = %55, %52
  %72 = shl nsw i64 -1, %50
  %73 = xor i64 %72, -1
  %74 = call i64 %12(ptr noundef %0, ptr noundef nonnull %2, ptr noundef %14, ptr noundef null, i64 noundef %73) #4
  %75 = icmp sgt i64 %49, 0
  br i1 %75, label %156, label %152

76:                                               ; preds = %44, %149
  %77 = phi i64 [ 0, %44 ], [ %150, %149 ]
  %78 = icmp sgt i64 %49, %77
  %79 = select i1 %78, i64 %77, i64 %51
  %80 = add nsw i64 %79, %46
  %81 = load ptr, ptr %26, align 8
  %82 = load double, ptr %81, align 8
  %83 = getelementptr inbounds [8 x double], ptr %2, i64 0, i64 %77
  store double %82, ptr %83, align 8
  %84 = load ptr, ptr %3, align 8
  %85 = load i64, ptr %27, align 8
  %86 = mul nsw i64 %85, %80
  %87 = getelementptr inbounds double, ptr %84, i64 %86
  %88 = getelementptr double, ptr %14, i64 %77
  %89 = icmp sgt i64 %85, 0
  br i1 %89, label %90, label %99

90:                                               ; preds = %76, %90
  %91 = phi i64 [ %96, %90 ], [ 0, %76 ]
  %92 = getelementptr inbounds double, ptr %87, i64 %91
  %93 = load double, ptr %92, align 8
  %94 = shl i64 %91, 6
  %95 = getelementptr i8, ptr %88, i64 %94
  store double %93, ptr %95, align 8
  %96 = add nuw nsw i64 %91, 1
  %97 = load i64, ptr %27, align 8
  %98 = icmp slt i64 %96, %97
  br i1 %98, label %90, label %99, !llvm.loop !6

99:                                               ; preds = %90, %76
  %100 = load ptr, ptr %29, align 8
  %101 = load ptr, ptr %28, align 8
  %102 = load i64, ptr %30, align 8
  %103 = mul nsw i64 %102, %80
  %104 = getelementptr inbounds double, ptr %101, i64 %103
  %105 = getelementptr double, ptr %100, i64 %77
  %106 = icmp sgt i64 %102, 0
  br i1 %106, label %107, label %116

107:                                              ; preds = %99, %107
  %108 = phi i64 [ %113, %107 ], [ 0, %99 ]
  %109 = getelementptr inbounds double, ptr %104, i64 %108
  %110 = load double, ptr %109, align 8
  %111 = shl i64 %108, 6
  %112 = getelementptr i8, ptr %105, i64 %111
  store double %110, ptr %112, align 8
  %113 = add nuw nsw i64 %108, 1
  %114 = load i64, ptr %30, align 8
  %115 = icmp slt i64 %113, %114
  br i1 %115, label %107, label %116, !llvm.loop !6

116:                                              ; preds = %107, %99
  %117 = load ptr, ptr %32, align 8
  %118 = load ptr, ptr %31, align 8
  %119 = load i64, ptr %33, align 8
  %120 = mul nsw i64 %119, %80
  %121 = getelementptr inbounds double, ptr %118, i64 %120
  %122 = getelementptr double, ptr %117, i64 %77
  %123 = icmp sgt i64 %119, 0
  br i1 %123, label %124, label %133

124:                                              ; preds = %116, %124
  %125 = phi i64 [ %130, %124 ], [ 0, %116 ]
  %126 = getelementptr inbounds double, ptr %121, i64 %125
  %127 = load double, ptr %126, align 8
  %128 = shl i64 %125, 6
  %129 = getelementptr i8, ptr %122, i64 %128
  store double %127, ptr %129, align 8
  %130 = add nuw nsw i64 %125, 1
  %131 = load i64, ptr %33, align 8
  %132 = icmp slt i64 %130, %131
  br i1 %132, label %124, label %133, !llvm.loop !6

133:                                              ; preds = %124, %116
  %134 = load ptr, ptr %34, align 8
  %135 = load i64, ptr %35, align 8
  %136 = mul nsw i64 %135, %80
  %137 = getelementptr inbounds double, ptr %134, i64 %136
  %138 = getelementptr double, ptr %23, i64 %77
  %139 = icmp sgt i64 %135, 0
  br i1 %139, label %140, label %149

140:                                              ; preds = %133, %140
  %141 = phi i64 [ %146, %140 ], [ 0, %133 ]
  %142 = getelementptr inbounds double, ptr %137, i64 %141
  %143 = load double, ptr %142, align 8
  %144 = shl i64 %141, 6
  %145 = getelementptr i8, ptr %138, i64 %144
  store double %143, ptr %145, align 8
  %146 = add nuw nsw i64 %141, 1
  %147 = load i64, ptr %35, align 8
  %148 = icmp slt i64 %146, %147
  br i1 %148, label %140, label %149, !llvm.loop !6

149:                                              ; preds = %140, %133
  %150 = add nuw nsw i64 %77, 1
  %151 = icmp eq i64 %150, 8
  br i1 %151, label %52, label %76, !llvm.loop !8

152:                                              ; preds = %197, %71
  %153 = add nuw nsw i64 %46, 8
  %154 = icmp slt i64 %153, %7
  %155 = add i64 %45, -8
  br i1 %154, label %44, label %43, !llvm.loop !9

156:                                              ; preds = %71, %197
  %157 = phi i64 [ %198, %197 ], [ 0, %71 ]
  %158 = add nuw nsw i64 %157, %46
  %159 = load ptr, ptr %39, align 8
  %160 = load i64, ptr %40, align 8
  %161 = mul nsw i64 %160, %158
  %162 = getelementptr inbounds double, ptr %159, i64 %161
  %163 = getelementptr double, ptr %23, i64 %157
  %164 = icmp sgt i64 %160, 0
  br i1 %164, label %165, label %174

165:                                              ; preds = %156, %165
  %166 = phi i64 [ %171, %165 ], [ 0, %156 ]
  %167 = shl i64 %166, 6
  %168 = getelementptr i8, ptr %163, i64 %167
  %169 = load double, ptr %168, align 8
  %170 = getelementptr inbounds double, ptr %162, i64 %166
  store double %169, ptr %170, align 8
  %171 = add nuw nsw i64 %166, 1
  %172 = load i64, ptr %40, align 8
  %173 = icmp slt i64 %171, %172
  br i1 %173, label %165, label %174, !llvm.loop !10

174:                                              ; preds = %165, %156
  %175 = load ptr, ptr %3, align 8
  %176 = load i64, ptr %41, align 8
  %177 = mul nsw i64 %176, %158
  %178 = getelementptr inbounds double, ptr %175, i64 %177
  %179 = getelementptr double, ptr %14, i64 %157
  %180 = icmp sgt i64 %176, 0
  br i1 %180, label %188, label %181

181:                                              ; preds = %188, %174
  %182 = shl nuw i64 1, %157
  %183 = and i64 %182, %74
  %184 = icmp eq i64 %183, 0
  %185 = select i1 %42, i1 true, i1 %184
  br i1 %185, label %197, label %186

186:                                              ; preds = %181
  %187 = mul nuw nsw i64 %158, %5
  br label %200

188:                                              ; preds = %174, %188
  %189 = phi i64 [ %194, %188 ], [ 0, %174 ]
  %190 = shl i64 %189, 6
  %191 = getelementptr i8, ptr %179, i64 %190
  %192 = load double, ptr %191, align 8
  %193 = getelementptr inbounds double, ptr %178, i64 %189
  store double %192, ptr %193, align 8
  %194 = add nuw nsw i64 %189, 1
  %195 = load i64, ptr %41, align 8
  %196 = icmp slt i64 %194, %195
  br i1 %196, label %188, label %181, !llvm.loop !10

197:                                              ; preds = %200, %181
  %198 = add nuw nsw i64 %157, 1
  %199 = icmp eq i64 %198, %48
  br i1 %199, label %152, label %156, !llvm.loop !11

200:                                              ; preds = %186, %200
  %201 = phi i64 [ 0, %186 ], [ %205, %200 ]
  %202 = load ptr, ptr %3, align 8
  %203 = getelementptr double, ptr %202, i64 %187
  %204 = getelementptr double, ptr %203, i64 %201
  store double 0x7FF8000000000000, ptr %204, align 8
  %205 = add nuw nsw i64 %201, 1
  %206 = icmp sge i64 %205, %5
  %207 = select i1 %206, i1 true, i1 %184
  br i1 %207, label %197, label %200, !llvm.loop !12
}



declare i64 @llvm.smin.i64(i64, i64) #2

declare i64 @llvm.smax.i64(i64, i64) #2

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
!6 = distinct !{!6, !4, !5, !7}
!7 = !{!"llvm.loop.vectorize.width", i32 1}
!8 = distinct !{!8, !4, !5}
!9 = distinct !{!9, !4, !5}
!10 = distinct !{!10, !4, !5, !7}
!11 = distinct !{!11, !4, !5}
!12 = distinct !{!12, !4, !5}
