; sources 0d7605643f2f4673e17e8466f6541de0da09cdd67aa026415344ddfb9f8654d1
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define noundef i64 @evaluate_lanes(ptr noundef readonly %0) #0 {
  %2 = getelementptr inbounds i8, ptr %0, i64 288
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %3, i64 8
  %5 = load i64, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 360
  %7 = getelementptr inbounds i8, ptr %0, i64 368
  %8 = load i64, ptr %7, align 8
  %9 = getelementptr inbounds i8, ptr %0, i64 408
  %10 = getelementptr inbounds i8, ptr %0, i64 416
  %11 = load i64, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %0, i64 336
  %13 = getelementptr inbounds i8, ptr %0, i64 344
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
  %23 = getelementptr inbounds i8, ptr %0, i64 376
  %24 = getelementptr inbounds i8, ptr %0, i64 384
  %25 = getelementptr inbounds i8, ptr %0, i64 72
  %26 = getelementptr inbounds i8, ptr %0, i64 400
  %27 = getelementptr inbounds i8, ptr %0, i64 128
  %28 = getelementptr inbounds i8, ptr %0, i64 120
  %29 = getelementptr inbounds i8, ptr %0, i64 72
  %30 = icmp sgt i64 %11, 0
  %31 = getelementptr inbounds i8, ptr %16, i64 16
  %32 = getelementptr inbounds i8, ptr %16, i64 24
  %33 = icmp sgt i64 %5, 0
  %34 = getelementptr inbounds i8, ptr %16, i64 8
  %35 = getelementptr inbounds i8, ptr %0, i64 312
  %36 = getelementptr inbounds i8, ptr %0, i64 312
  %37 = getelementptr inbounds i8, ptr %0, i64 24
  %38 = getelementptr inbounds i8, ptr %0, i64 152
  %39 = getelementptr inbounds i8, ptr %0, i64 48
  %40 = getelementptr inbounds i8, ptr %0, i64 96
  %41 = icmp slt i64 %5, 1
  %42 = icmp sgt i64 %14, 7
  %43 = getelementptr inbounds i8, ptr %0, i64 432
  br label %45

44:                                               ; preds = %119, %1
  ret i64 0

45:                                               ; preds = %21, %119
  %46 = phi i64 [ %8, %21 ], [ %122, %119 ]
  %47 = phi i64 [ 0, %21 ], [ %120, %119 ]
  %48 = tail call i64 @llvm.smin.i64(i64 %46, i64 8)
  %49 = tail call i64 @llvm.smax.i64(i64 %48, i64 1)
  %50 = sub nsw i64 %8, %47
  %51 = tail call i64 @llvm.smin.i64(i64 %50, i64 8)
  %52 = add nsw i64 %51, -1
  br label %76

53:                                               ; preds = %114
  %54 = load i64, ptr %27, align 8
  %55 = icmp sgt i64 %54, 0
  br i1 %55, label %60, label %56

56:                                               ; preds = %60, %53
  br i1 %30, label %57, label %119

57:                                               ; preds = %56
  %58 = add nsw i64 %51, -1
  %59 = icmp sgt i64 %50, 0
  br label %117

60:                                               ; preds = %53, %60
  %61 = phi i64 [ %73, %60 ], [ 0, %53 ]
  %62 = load ptr, ptr %28, align 8
  %63 = shl nuw nsw i64 %61, 1
  %64 = getelementptr inbounds i64, ptr %62, i64 %63
  %65 = load i64, ptr %64, align 8
  %66 = inttoptr i64 %65 to ptr
  %67 = load ptr, ptr %66, align 8
  %68 = load ptr, ptr %29, align 8
  %69 = or disjoint i64 %63, 1
  %70 = getelementptr inbounds i64, ptr %62, i64 %69
  %71 = load i64, ptr %70, align 8
  %72 = inttoptr i64 %71 to ptr
  tail call void %67(ptr noundef %68, ptr noundef %72) #3
  %73 = add nuw nsw i64 %61, 1
  %74 = load i64, ptr %27, align 8
  %75 = icmp slt i64 %73, %74
  br i1 %75, label %60, label %56, !llvm.loop !3

76:                                               ; preds = %45, %114
  %77 = phi i64 [ 0, %45 ], [ %115, %114 ]
  %78 = icmp sgt i64 %50, %77
  %79 = select i1 %78, i64 %77, i64 %52
  %80 = add nsw i64 %79, %47
  %81 = load ptr, ptr %22, align 8
  %82 = load ptr, ptr %6, align 8
  %83 = load i64, ptr %23, align 8
  %84 = mul nsw i64 %83, %80
  %85 = getelementptr inbounds double, ptr %82, i64 %84
  %86 = getelementptr double, ptr %81, i64 %77
  %87 = icmp sgt i64 %83, 0
  br i1 %87, label %88, label %97

88:                                               ; preds = %76, %88
  %89 = phi i64 [ %94, %88 ], [ 0, %76 ]
  %90 = getelementptr inbounds double, ptr %85, i64 %89
  %91 = load double, ptr %90, align 8
  %92 = shl i64 %89, 6
  %93 = getelementptr i8, ptr %86, i64 %92
  store double %91, ptr %93, align 8
  %94 = add nuw nsw i64 %89, 1
  %95 = load i64, ptr %23, align 8
  %96 = icmp slt i64 %94, %95
  br i1 %96, label %88, label %97, !llvm.loop !6

97:                                               ; preds = %88, %76
  %98 = load ptr, ptr %25, align 8
  %99 = load ptr, ptr %24, align 8
  %100 = load i64, ptr %26, align 8
  %101 = mul nsw i64 %100, %80
  %102 = getelementptr inbounds double, ptr %99, i64 %101
  %103 = getelementptr double, ptr %98, i64 %77
  %104 = icmp sgt i64 %100, 0
  br i1 %104, label %105, label %114

105:                                              ; preds = %97, %105
  %106 = phi i64 [ %111, %105 ], [ 0, %97 ]
  %107 = getelementptr inbounds double, ptr %102, i64 %106
  %108 = load double, ptr %107, align 8
  %109 = shl i64 %106, 6
  %110 = getelementptr i8, ptr %103, i64 %109
  store double %108, ptr %110, align 8
  %111 = add nuw nsw i64 %106, 1
  %112 = load i64, ptr %26, align 8
  %113 = icmp slt i64 %111, %112
  br i1 %113, label %105, label %114, !llvm.loop !6

114:                                              ; preds = %105, %97
  %115 = add nuw nsw i64 %77, 1
  %116 = icmp eq i64 %115, 8
  br i1 %116, label %53, label %76, !llvm.loop !8

117:                                              ; preds = %57, %177
  %118 = phi i64 [ 0, %57 ], [ %178, %177 ]
  br label %151

119:                                              ; preds = %177, %56
  %120 = add nuw nsw i64 %47, 8
  %121 = icmp slt i64 %120, %8
  %122 = add i64 %46, -8
  br i1 %121, label %45, label %44, !llvm.loop !9

123:                                              ; preds = %162
  %124 = load ptr, ptr %9, align 8
  %125 = getelementptr inbounds double, ptr %124, i64 %118
  %126 = load double, ptr %125, align 8
  %127 = insertelement <8 x double> poison, double %126, i64 0
  %128 = shufflevector <8 x double> %127, <8 x double> poison, <8 x i32> zeroinitializer
  %129 = load ptr, ptr %36, align 8
  %130 = load ptr, ptr %12, align 8
  %131 = load ptr, ptr %37, align 8
  store <8 x double> %128, ptr %131, align 8
  %132 = load ptr, ptr %0, align 8
  %133 = getelementptr inbounds i8, ptr %132, i64 40
  %134 = load i64, ptr %133, align 8
  %135 = icmp eq i64 %134, 0
  br i1 %135, label %137, label %136

136:                                              ; preds = %123
  tail call fastcc void @settle(ptr noundef nonnull %0) #4
  br label %137

137:                                              ; preds = %136, %123
  %138 = load i64, ptr %38, align 8
  %139 = icmp sgt i64 %138, 0
  br i1 %139, label %140, label %141

140:                                              ; preds = %137
  tail call fastcc void @sample(ptr noundef nonnull %0) #4
  br label %141

141:                                              ; preds = %137, %140
  %142 = load ptr, ptr %0, align 8
  %143 = load i64, ptr %142, align 8
  %144 = load ptr, ptr %37, align 8
  %145 = load ptr, ptr %39, align 8
  %146 = load ptr, ptr %40, align 8
  %147 = inttoptr i64 %143 to ptr
  %148 = load ptr, ptr %147, align 8
  %149 = tail call i32 %148(ptr noundef %144, ptr noundef %129, ptr noundef %145, ptr noundef %146, ptr noundef %130) #3
  %150 = sext i32 %149 to i64
  br i1 %59, label %180, label %177

151:                                              ; preds = %117, %162
  %152 = phi i64 [ 0, %117 ], [ %163, %162 ]
  %153 = icmp sgt i64 %50, %152
  %154 = select i1 %153, i64 %152, i64 %58
  %155 = add nsw i64 %154, %47
  %156 = load i64, ptr %31, align 8
  %157 = mul nsw i64 %156, %155
  %158 = getelementptr inbounds double, ptr %19, i64 %157
  %159 = load i64, ptr %32, align 8
  %160 = mul nsw i64 %159, %118
  %161 = getelementptr inbounds double, ptr %158, i64 %160
  br i1 %33, label %165, label %162

162:                                              ; preds = %165, %151
  %163 = add nuw nsw i64 %152, 1
  %164 = icmp eq i64 %163, 8
  br i1 %164, label %123, label %151, !llvm.loop !10

165:                                              ; preds = %151, %165
  %166 = phi i64 [ %175, %165 ], [ 0, %151 ]
  %167 = load i64, ptr %34, align 8
  %168 = mul nsw i64 %167, %166
  %169 = getelementptr inbounds double, ptr %161, i64 %168
  %170 = load double, ptr %169, align 8
  %171 = load ptr, ptr %35, align 8
  %172 = shl nsw i64 %166, 6
  %173 = getelementptr inbounds i8, ptr %171, i64 %172
  %174 = getelementptr inbounds double, ptr %173, i64 %152
  store double %170, ptr %174, align 8
  %175 = add nuw nsw i64 %166, 1
  %176 = icmp eq i64 %175, %5
  br i1 %176, label %162, label %165, !llvm.loop !11

177:                                              ; preds = %196, %141
  %178 = add nuw nsw i64 %118, 1
  %179 = icmp eq i64 %178, %11
  br i1 %179, label %119, label %117, !llvm.loop !12

180:                                              ; preds = %141, %196
  %181 = phi i64 [ %197, %196 ], [ 0, %141 ]
  %182 = shl nuw i64 1, %181
  %183 = and i64 %182, %150
  %184 = icmp ne i64 %183, 0
  %185 = select i1 %184, i1 true, i1 %41
  br i1 %185, label %191, label %186

186:                                              ; preds = %180
  %187 = load ptr, ptr %36, align 8
  %188 = getelementptr inbounds double, ptr %187, i64 %181
  %189 = load double, ptr %188, align 8
  %190 = fcmp uno double %189, 0.000000e+00
  br label %191

191:                                              ; preds = %180, %186
  %192 = phi i1 [ %184, %180 ], [ %190, %186 ]
  %193 = getelementptr inbounds double, ptr %17, i64 %181
  br i1 %42, label %194, label %196

194:                                              ; preds = %191
  %195 = add nuw nsw i64 %181, %47
  br label %199

196:                                              ; preds = %205, %191
  %197 = add nuw nsw i64 %181, 1
  %198 = icmp eq i64 %197, %49
  br i1 %198, label %177, label %180, !llvm.loop !13

199:                                              ; preds = %194, %205
  %200 = phi i64 [ 0, %194 ], [ %213, %205 ]
  br i1 %192, label %205, label %201

201:                                              ; preds = %199
  %202 = shl nsw i64 %200, 6
  %203 = getelementptr inbounds i8, ptr %193, i64 %202
  %204 = load double, ptr %203, align 8
  br label %205

205:                                              ; preds = %199, %201
  %206 = phi double [ %204, %201 ], [ 0x7FF8000000000000, %199 ]
  %207 = load ptr, ptr %43, align 8
  %208 = mul nuw nsw i64 %200, %8
  %209 = add nuw i64 %195, %208
  %210 = mul nsw i64 %209, %11
  %211 = getelementptr double, ptr %207, i64 %210
  %212 = getelementptr double, ptr %211, i64 %118
  store double %206, ptr %212, align 8
  %213 = add nuw nsw i64 %200, 1
  %214 = icmp eq i64 %213, %15
  br i1 %214, label %196, label %199, !llvm.loop !14
}

define internal fastcc void @settle(ptr noundef readonly %0) unnamed_addr #1 {
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
  br i1 %33, label %21, label %34, !llvm.loop !15

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
  br i1 %54, label %6, label %7, !llvm.loop !16
}

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #1 {
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
  br i1 %25, label %15, label %14, !llvm.loop !17

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
  br i1 %76, label %65, label %77, !llvm.loop !18

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
  br i1 %105, label %22, label %26, !llvm.loop !19
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
!18 = distinct !{!18, !4, !5}
!19 = distinct !{!19, !4, !5}
