; sources d179af7b4dd31a24732eb10fa582750a4ff4b88a7f601b19be9627e20bd144bd
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Held = type { ptr, i64, i64, i64, i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

define i64 @project_columns(ptr noundef %0, double noundef %1, ptr noundef %2, ptr noundef %3) #0 {
  %5 = alloca %struct.Held, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 648
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 72
  %9 = load i64, ptr %8, align 8
  %10 = inttoptr i64 %9 to ptr
  %11 = load ptr, ptr %10, align 8
  %12 = load i64, ptr %11, align 8
  %13 = inttoptr i64 %12 to ptr
  %14 = tail call i64 %13(ptr noundef %0, double noundef %1, ptr noundef %2, ptr noundef %3) #8
  %15 = icmp eq i64 %14, 0
  br i1 %15, label %16, label %189

16:                                               ; preds = %4
  tail call void @llvm.experimental.noalias.scope.decl(metadata !3)
  %17 = load ptr, ptr %6, align 8, !noalias !3
  %18 = getelementptr inbounds i8, ptr %17, i64 64
  %19 = load i64, ptr %18, align 8, !noalias !3
  %20 = inttoptr i64 %19 to ptr
  store ptr %20, ptr %5, align 8, !alias.scope !3
  %21 = getelementptr inbounds i8, ptr %5, i64 8
  %22 = getelementptr inbounds i8, ptr %17, i64 16
  %23 = load i64, ptr %22, align 8, !noalias !3
  store i64 %23, ptr %21, align 8, !alias.scope !3
  %24 = getelementptr inbounds i8, ptr %5, i64 16
  %25 = getelementptr inbounds i8, ptr %17, i64 24
  %26 = load i64, ptr %25, align 8, !noalias !3
  store i64 %26, ptr %24, align 8, !alias.scope !3
  %27 = getelementptr inbounds i8, ptr %5, i64 24
  %28 = getelementptr inbounds i8, ptr %17, i64 32
  %29 = load i64, ptr %28, align 8, !noalias !3
  store i64 %29, ptr %27, align 8, !alias.scope !3
  %30 = getelementptr inbounds i8, ptr %5, i64 32
  %31 = getelementptr inbounds i8, ptr %17, i64 40
  %32 = load i64, ptr %31, align 8, !noalias !3
  store i64 %32, ptr %30, align 8, !alias.scope !3
  %33 = getelementptr inbounds i8, ptr %5, i64 40
  %34 = getelementptr inbounds i8, ptr %17, i64 48
  %35 = load i64, ptr %34, align 8, !noalias !3
  store i64 %35, ptr %33, align 8, !alias.scope !3
  %36 = getelementptr inbounds i8, ptr %5, i64 48
  %37 = getelementptr inbounds i8, ptr %17, i64 80
  %38 = load i64, ptr %37, align 8, !noalias !3
  store i64 %38, ptr %36, align 8, !alias.scope !3
  %39 = getelementptr inbounds i8, ptr %5, i64 56
  %40 = getelementptr inbounds i8, ptr %17, i64 88
  %41 = load i64, ptr %40, align 8, !noalias !3
  store i64 %41, ptr %39, align 8, !alias.scope !3
  %42 = getelementptr inbounds i8, ptr %5, i64 64
  %43 = getelementptr inbounds i8, ptr %0, i64 696
  %44 = load ptr, ptr %43, align 8, !noalias !3
  store ptr %44, ptr %42, align 8, !alias.scope !3
  %45 = getelementptr inbounds i8, ptr %5, i64 72
  store ptr null, ptr %45, align 8, !alias.scope !3
  %46 = getelementptr inbounds i8, ptr %5, i64 80
  store ptr null, ptr %46, align 8, !alias.scope !3
  %47 = getelementptr inbounds i8, ptr %5, i64 88
  store ptr null, ptr %47, align 8, !alias.scope !3
  %48 = getelementptr inbounds i8, ptr %5, i64 96
  store ptr null, ptr %48, align 8, !alias.scope !3
  %49 = getelementptr inbounds i8, ptr %5, i64 104
  store ptr null, ptr %49, align 8, !alias.scope !3
  %50 = getelementptr inbounds i8, ptr %5, i64 112
  store ptr null, ptr %50, align 8, !alias.scope !3
  %51 = getelementptr inbounds double, ptr %44, i64 %23
  %52 = getelementptr inbounds double, ptr %51, i64 %26
  store ptr %52, ptr %45, align 8, !alias.scope !3
  %53 = mul nsw i64 %29, %23
  %54 = getelementptr inbounds double, ptr %52, i64 %53
  store ptr %54, ptr %46, align 8, !alias.scope !3
  %55 = mul nsw i64 %32, %29
  %56 = getelementptr inbounds double, ptr %54, i64 %55
  store ptr %56, ptr %47, align 8, !alias.scope !3
  %57 = mul nsw i64 %32, %26
  %58 = getelementptr inbounds double, ptr %56, i64 %57
  store ptr %58, ptr %48, align 8, !alias.scope !3
  %59 = mul i64 %32, %32
  %60 = mul i64 %59, %35
  %61 = getelementptr inbounds double, ptr %58, i64 %60
  store ptr %61, ptr %49, align 8, !alias.scope !3
  %62 = getelementptr inbounds double, ptr %61, i64 %23
  store ptr %62, ptr %50, align 8, !alias.scope !3
  %63 = load ptr, ptr %10, align 8
  %64 = getelementptr inbounds i8, ptr %63, i64 16
  %65 = load i64, ptr %64, align 8
  %66 = getelementptr inbounds i8, ptr %10, i64 48
  %67 = load ptr, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %0, i64 144
  %69 = load ptr, ptr %68, align 8
  %70 = getelementptr inbounds i8, ptr %69, i64 8
  %71 = load i64, ptr %70, align 8
  %72 = add nsw i64 %65, 1
  %73 = sdiv i64 %71, %72
  %74 = getelementptr inbounds double, ptr %2, i64 %73
  %75 = load ptr, ptr %20, align 8
  %76 = icmp sgt i64 %32, 0
  br i1 %76, label %77, label %91

77:                                               ; preds = %16, %81
  %78 = phi i64 [ %82, %81 ], [ 0, %16 ]
  %79 = mul nuw nsw i64 %78, %32
  %80 = getelementptr double, ptr %75, i64 %79
  br label %84

81:                                               ; preds = %84
  %82 = add nuw nsw i64 %78, 1
  %83 = icmp eq i64 %82, %32
  br i1 %83, label %91, label %77, !llvm.loop !6

84:                                               ; preds = %77, %84
  %85 = phi i64 [ 0, %77 ], [ %89, %84 ]
  %86 = icmp eq i64 %78, %85
  %87 = select i1 %86, double 1.000000e+00, double 0.000000e+00
  %88 = getelementptr double, ptr %80, i64 %85
  store double %87, ptr %88, align 8
  %89 = add nuw nsw i64 %85, 1
  %90 = icmp eq i64 %89, %32
  br i1 %90, label %81, label %84, !llvm.loop !9

91:                                               ; preds = %81, %16
  %92 = icmp eq i64 %35, 1
  br i1 %92, label %93, label %113

93:                                               ; preds = %91
  %94 = getelementptr inbounds i8, ptr %20, i64 8
  %95 = getelementptr inbounds i8, ptr %20, i64 16
  %96 = load i64, ptr %94, align 8
  %97 = load i64, ptr %95, align 8
  %98 = mul nsw i64 %97, %96
  %99 = icmp sgt i64 %98, 0
  br i1 %99, label %100, label %111

100:                                              ; preds = %93, %100
  %101 = phi i64 [ %106, %100 ], [ 0, %93 ]
  %102 = getelementptr inbounds double, ptr %58, i64 %101
  %103 = load double, ptr %102, align 8
  %104 = load ptr, ptr %20, align 8
  %105 = getelementptr inbounds double, ptr %104, i64 %101
  store double %103, ptr %105, align 8
  %106 = add nuw nsw i64 %101, 1
  %107 = load i64, ptr %94, align 8
  %108 = load i64, ptr %95, align 8
  %109 = mul nsw i64 %108, %107
  %110 = icmp slt i64 %106, %109
  br i1 %110, label %100, label %111, !llvm.loop !10

111:                                              ; preds = %100, %93
  %112 = load ptr, ptr %20, align 8
  tail call fastcc void @factorise(ptr noundef %112, i64 noundef %32) #10
  br label %113

113:                                              ; preds = %91, %111
  %114 = icmp sgt i64 %23, 0
  br i1 %114, label %115, label %159

115:                                              ; preds = %113
  %116 = tail call fastcc i64 @move(ptr noundef %0, ptr noundef nonnull %10, ptr noundef %2) #10
  %117 = icmp slt i64 %116, 0
  br i1 %117, label %187, label %118

118:                                              ; preds = %115
  %119 = getelementptr inbounds i8, ptr %20, i64 24
  %120 = getelementptr inbounds i8, ptr %20, i64 32
  %121 = getelementptr inbounds i8, ptr %20, i64 40
  %122 = load i64, ptr %120, align 8
  %123 = load i64, ptr %121, align 8
  %124 = mul nsw i64 %123, %122
  %125 = icmp sgt i64 %124, 0
  br i1 %125, label %131, label %126

126:                                              ; preds = %131, %118
  %127 = icmp sgt i64 %65, 0
  br i1 %127, label %128, label %159

128:                                              ; preds = %126
  %129 = getelementptr inbounds i8, ptr %20, i64 144
  %130 = tail call i64 @llvm.smax.i64(i64 %23, i64 1)
  br label %142

131:                                              ; preds = %118, %131
  %132 = phi i64 [ %137, %131 ], [ 0, %118 ]
  %133 = getelementptr inbounds double, ptr %54, i64 %132
  %134 = load double, ptr %133, align 8
  %135 = load ptr, ptr %119, align 8
  %136 = getelementptr inbounds double, ptr %135, i64 %132
  store double %134, ptr %136, align 8
  %137 = add nuw nsw i64 %132, 1
  %138 = load i64, ptr %120, align 8
  %139 = load i64, ptr %121, align 8
  %140 = mul nsw i64 %139, %138
  %141 = icmp slt i64 %137, %140
  br i1 %141, label %131, label %126, !llvm.loop !10

142:                                              ; preds = %128, %155
  %143 = phi i64 [ 0, %128 ], [ %157, %155 ]
  %144 = getelementptr inbounds double, ptr %67, i64 %143
  %145 = load ptr, ptr %129, align 8
  br label %146

146:                                              ; preds = %142, %146
  %147 = phi i64 [ %153, %146 ], [ 0, %142 ]
  %148 = mul nuw nsw i64 %147, %65
  %149 = getelementptr inbounds double, ptr %144, i64 %148
  %150 = load double, ptr %149, align 8
  %151 = fneg double %150
  %152 = getelementptr inbounds double, ptr %145, i64 %147
  store double %151, ptr %152, align 8
  %153 = add nuw nsw i64 %147, 1
  %154 = icmp eq i64 %153, %130
  br i1 %154, label %155, label %146, !llvm.loop !11

155:                                              ; preds = %146
  %156 = getelementptr inbounds double, ptr %74, i64 %143
  call fastcc void @move_positions(ptr noundef nonnull %5, ptr noundef %156, i64 noundef %65) #10
  %157 = add nuw nsw i64 %143, 1
  %158 = icmp eq i64 %157, %65
  br i1 %158, label %159, label %142, !llvm.loop !12

159:                                              ; preds = %155, %126, %113
  %160 = icmp sgt i64 %26, 0
  br i1 %160, label %161, label %187

161:                                              ; preds = %159
  %162 = tail call fastcc i64 @move(ptr noundef %0, ptr noundef nonnull %10, ptr noundef %2) #10
  %163 = icmp slt i64 %162, 0
  br i1 %163, label %187, label %164

164:                                              ; preds = %161
  %165 = icmp sgt i64 %65, 0
  br i1 %165, label %166, label %187

166:                                              ; preds = %164
  %167 = mul nsw i64 %65, %23
  %168 = getelementptr inbounds double, ptr %67, i64 %167
  %169 = getelementptr inbounds i8, ptr %20, i64 144
  br label %170

170:                                              ; preds = %166, %183
  %171 = phi i64 [ 0, %166 ], [ %185, %183 ]
  %172 = getelementptr inbounds double, ptr %168, i64 %171
  %173 = load ptr, ptr %169, align 8
  br label %174

174:                                              ; preds = %170, %174
  %175 = phi i64 [ %181, %174 ], [ 0, %170 ]
  %176 = mul nuw nsw i64 %175, %65
  %177 = getelementptr inbounds double, ptr %172, i64 %176
  %178 = load double, ptr %177, align 8
  %179 = fneg double %178
  %180 = getelementptr inbounds double, ptr %173, i64 %175
  store double %179, ptr %180, align 8
  %181 = add nuw nsw i64 %175, 1
  %182 = icmp eq i64 %181, %26
  br i1 %182, label %183, label %174, !llvm.loop !11

183:                                              ; preds = %174
  %184 = getelementptr inbounds double, ptr %74, i64 %171
  call fastcc void @move_speeds(ptr noundef nonnull %5, ptr noundef %184, i64 noundef %65) #10
  %185 = add nuw nsw i64 %171, 1
  %186 = icmp eq i64 %185, %65
  br i1 %186, label %187, label %170, !llvm.loop !13

187:                                              ; preds = %183, %164, %159, %161, %115
  %188 = phi i64 [ 6, %115 ], [ 6, %161 ], [ 0, %159 ], [ 0, %164 ], [ 0, %183 ]
  br label %189

189:                                              ; preds = %4, %187
  %190 = phi i64 [ %188, %187 ], [ %14, %4 ]
  ret i64 %190
}


define internal fastcc range(i64 -2147483648, 2147483648) i64 @move(ptr noundef readonly %0, ptr noundef readonly %1, ptr noundef %2) unnamed_addr #2 {
  %4 = load ptr, ptr %1, align 8
  %5 = getelementptr inbounds i8, ptr %4, i64 8
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 168
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr inbounds i8, ptr %0, i64 192
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %1, i64 24
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %1, i64 48
  %14 = load ptr, ptr %13, align 8
  %15 = inttoptr i64 %6 to ptr
  %16 = tail call i32 %15(ptr noundef %8, ptr noundef %2, ptr noundef %10, ptr noundef %12, ptr noundef %14) #8
  %17 = sext i32 %16 to i64
  ret i64 %17
}

define internal fastcc void @move_positions(ptr noundef readonly %0, ptr noundef %1, i64 noundef %2) unnamed_addr #3 {
  %4 = load ptr, ptr %0, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 72
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %4, i64 48
  %8 = getelementptr inbounds i8, ptr %4, i64 56
  %9 = getelementptr inbounds i8, ptr %4, i64 64
  %10 = load i64, ptr %8, align 8
  %11 = load i64, ptr %9, align 8
  %12 = mul nsw i64 %11, %10
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %14, label %25

14:                                               ; preds = %3, %14
  %15 = phi i64 [ %20, %14 ], [ 0, %3 ]
  %16 = getelementptr inbounds double, ptr %6, i64 %15
  %17 = load double, ptr %16, align 8
  %18 = load ptr, ptr %7, align 8
  %19 = getelementptr inbounds double, ptr %18, i64 %15
  store double %17, ptr %19, align 8
  %20 = add nuw nsw i64 %15, 1
  %21 = load i64, ptr %8, align 8
  %22 = load i64, ptr %9, align 8
  %23 = mul nsw i64 %22, %21
  %24 = icmp slt i64 %20, %23
  br i1 %24, label %14, label %25, !llvm.loop !10

25:                                               ; preds = %14, %3
  %26 = getelementptr inbounds i8, ptr %4, i64 24
  %27 = load ptr, ptr %7, align 8
  %28 = getelementptr inbounds i8, ptr %4, i64 72
  tail call fastcc void @set_rows(ptr noundef nonnull %26, ptr noundef %27, ptr noundef nonnull %28) #10
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds i8, ptr %0, i64 8
  %31 = load i64, ptr %30, align 8
  %32 = load ptr, ptr %4, align 8
  %33 = getelementptr inbounds i8, ptr %0, i64 32
  %34 = load i64, ptr %33, align 8
  tail call fastcc void @divide_rows(ptr noundef %29, i64 noundef %31, ptr noundef %32, i64 noundef %34) #10
  %35 = getelementptr inbounds i8, ptr %0, i64 48
  %36 = load i64, ptr %35, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %28, ptr noundef nonnull %4, i64 noundef %36) #10
  %37 = getelementptr inbounds i8, ptr %4, i64 120
  %38 = load ptr, ptr %37, align 8
  %39 = load i64, ptr %33, align 8
  %40 = icmp sgt i64 %39, 0
  br i1 %40, label %41, label %50

41:                                               ; preds = %25, %41
  %42 = phi i64 [ %48, %41 ], [ 0, %25 ]
  %43 = phi double [ %47, %41 ], [ 0.000000e+00, %25 ]
  %44 = getelementptr inbounds double, ptr %38, i64 %42
  %45 = load double, ptr %44, align 8
  %46 = fmul double %45, %45
  %47 = fadd double %43, %46
  %48 = add nuw nsw i64 %42, 1
  %49 = icmp eq i64 %48, %39
  br i1 %49, label %50, label %41, !llvm.loop !14

50:                                               ; preds = %41, %25
  %51 = phi double [ 0.000000e+00, %25 ], [ %47, %41 ]
  %52 = tail call double @llvm.sqrt.f64(double %51)
  %53 = load i64, ptr %30, align 8
  %54 = icmp sgt i64 %53, 0
  br i1 %54, label %55, label %58

55:                                               ; preds = %50
  %56 = getelementptr inbounds i8, ptr %4, i64 264
  %57 = getelementptr inbounds i8, ptr %4, i64 216
  br label %65

58:                                               ; preds = %76, %50
  %59 = load ptr, ptr %4, align 8
  %60 = load i64, ptr %33, align 8
  %61 = load ptr, ptr %37, align 8
  tail call fastcc void @divide_transposed(ptr noundef %59, i64 noundef %60, ptr noundef %61) #10
  %62 = getelementptr inbounds i8, ptr %0, i64 24
  %63 = load i64, ptr %62, align 8
  %64 = icmp sgt i64 %63, 0
  br i1 %64, label %80, label %87

65:                                               ; preds = %55, %76
  %66 = phi i64 [ 0, %55 ], [ %77, %76 ]
  %67 = load ptr, ptr %56, align 8
  %68 = getelementptr inbounds double, ptr %67, i64 %66
  %69 = load double, ptr %68, align 8
  %70 = fcmp oeq double %69, 0.000000e+00
  br i1 %70, label %71, label %76

71:                                               ; preds = %65
  %72 = load ptr, ptr %57, align 8
  %73 = getelementptr inbounds double, ptr %72, i64 %66
  %74 = load double, ptr %73, align 8
  %75 = fmul double %52, %74
  store double %75, ptr %68, align 8
  br label %76

76:                                               ; preds = %65, %71
  %77 = add nuw nsw i64 %66, 1
  %78 = load i64, ptr %30, align 8
  %79 = icmp slt i64 %77, %78
  br i1 %79, label %65, label %58, !llvm.loop !15

80:                                               ; preds = %58, %94
  %81 = phi i64 [ %95, %94 ], [ 0, %58 ]
  %82 = load i64, ptr %33, align 8
  %83 = icmp sgt i64 %82, 0
  br i1 %83, label %84, label %94

84:                                               ; preds = %80
  %85 = mul nsw i64 %81, %2
  %86 = getelementptr inbounds double, ptr %1, i64 %85
  br label %98

87:                                               ; preds = %94, %58
  %88 = getelementptr inbounds i8, ptr %0, i64 24
  %89 = load i64, ptr %30, align 8
  %90 = icmp sgt i64 %89, 0
  br i1 %90, label %91, label %143

91:                                               ; preds = %87
  %92 = getelementptr inbounds i8, ptr %4, i64 144
  %93 = load ptr, ptr %92, align 8
  br label %117

94:                                               ; preds = %98, %80
  %95 = add nuw nsw i64 %81, 1
  %96 = load i64, ptr %62, align 8
  %97 = icmp slt i64 %95, %96
  br i1 %97, label %80, label %87, !llvm.loop !16

98:                                               ; preds = %84, %98
  %99 = phi i64 [ %82, %84 ], [ %113, %98 ]
  %100 = phi i64 [ 0, %84 ], [ %112, %98 ]
  %101 = load ptr, ptr %26, align 8
  %102 = mul nsw i64 %99, %81
  %103 = getelementptr double, ptr %101, i64 %102
  %104 = getelementptr double, ptr %103, i64 %100
  %105 = load double, ptr %104, align 8
  %106 = load ptr, ptr %37, align 8
  %107 = getelementptr inbounds double, ptr %106, i64 %100
  %108 = load double, ptr %107, align 8
  %109 = fmul double %105, %108
  %110 = load double, ptr %86, align 8
  %111 = fadd double %110, %109
  store double %111, ptr %86, align 8
  %112 = add nuw nsw i64 %100, 1
  %113 = load i64, ptr %33, align 8
  %114 = icmp slt i64 %112, %113
  br i1 %114, label %98, label %94, !llvm.loop !17

115:                                              ; preds = %117
  %116 = fcmp ogt double %124, 0.000000e+00
  br i1 %116, label %127, label %143

117:                                              ; preds = %91, %117
  %118 = phi i64 [ 0, %91 ], [ %125, %117 ]
  %119 = phi double [ 0.000000e+00, %91 ], [ %124, %117 ]
  %120 = getelementptr inbounds double, ptr %93, i64 %118
  %121 = load double, ptr %120, align 8
  %122 = tail call double @llvm.fabs.f64(double %121)
  %123 = fcmp ogt double %122, %119
  %124 = select i1 %123, double %122, double %119
  %125 = add nuw nsw i64 %118, 1
  %126 = icmp eq i64 %125, %89
  br i1 %126, label %115, label %117, !llvm.loop !18

127:                                              ; preds = %115
  %128 = load i64, ptr %35, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %7, ptr noundef nonnull %4, i64 noundef %128) #10
  %129 = load i64, ptr %88, align 8
  %130 = icmp sgt i64 %129, 0
  br i1 %130, label %131, label %143

131:                                              ; preds = %127, %131
  %132 = phi i64 [ %140, %131 ], [ 0, %127 ]
  %133 = load ptr, ptr %37, align 8
  %134 = getelementptr inbounds double, ptr %133, i64 %132
  %135 = load double, ptr %134, align 8
  %136 = mul nsw i64 %132, %2
  %137 = getelementptr inbounds double, ptr %1, i64 %136
  %138 = load double, ptr %137, align 8
  %139 = fadd double %135, %138
  store double %139, ptr %137, align 8
  %140 = add nuw nsw i64 %132, 1
  %141 = load i64, ptr %88, align 8
  %142 = icmp slt i64 %140, %141
  br i1 %142, label %131, label %143, !llvm.loop !19

143:                                              ; preds = %131, %87, %127, %115
  ret void
}


define internal fastcc void @move_speeds(ptr noundef readonly %0, ptr noundef %1, i64 noundef %2) unnamed_addr #3 {
  %4 = load ptr, ptr %0, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 88
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %4, i64 96
  %8 = getelementptr inbounds i8, ptr %4, i64 104
  %9 = getelementptr inbounds i8, ptr %4, i64 112
  %10 = load i64, ptr %8, align 8
  %11 = load i64, ptr %9, align 8
  %12 = mul nsw i64 %11, %10
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %14, label %25

14:                                               ; preds = %3, %14
  %15 = phi i64 [ %20, %14 ], [ 0, %3 ]
  %16 = getelementptr inbounds double, ptr %6, i64 %15
  %17 = load double, ptr %16, align 8
  %18 = load ptr, ptr %7, align 8
  %19 = getelementptr inbounds double, ptr %18, i64 %15
  store double %17, ptr %19, align 8
  %20 = add nuw nsw i64 %15, 1
  %21 = load i64, ptr %8, align 8
  %22 = load i64, ptr %9, align 8
  %23 = mul nsw i64 %22, %21
  %24 = icmp slt i64 %20, %23
  br i1 %24, label %14, label %25, !llvm.loop !10

25:                                               ; preds = %14, %3
  %26 = load ptr, ptr %7, align 8
  %27 = getelementptr inbounds i8, ptr %0, i64 16
  %28 = load i64, ptr %27, align 8
  %29 = load ptr, ptr %4, align 8
  %30 = getelementptr inbounds i8, ptr %0, i64 32
  %31 = load i64, ptr %30, align 8
  tail call fastcc void @divide_rows(ptr noundef %26, i64 noundef %28, ptr noundef %29, i64 noundef %31) #10
  %32 = getelementptr inbounds i8, ptr %0, i64 56
  %33 = load i64, ptr %32, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %7, ptr noundef nonnull %4, i64 noundef %33) #10
  %34 = load ptr, ptr %4, align 8
  %35 = load i64, ptr %30, align 8
  %36 = getelementptr inbounds i8, ptr %4, i64 120
  %37 = load ptr, ptr %36, align 8
  tail call fastcc void @divide_transposed(ptr noundef %34, i64 noundef %35, ptr noundef %37) #10
  %38 = load i64, ptr %30, align 8
  %39 = icmp sgt i64 %38, 0
  br i1 %39, label %40, label %42

40:                                               ; preds = %25
  %41 = getelementptr inbounds i8, ptr %0, i64 24
  br label %43

42:                                               ; preds = %43, %25
  ret void

43:                                               ; preds = %40, %43
  %44 = phi i64 [ 0, %40 ], [ %54, %43 ]
  %45 = load ptr, ptr %36, align 8
  %46 = getelementptr inbounds double, ptr %45, i64 %44
  %47 = load double, ptr %46, align 8
  %48 = load i64, ptr %41, align 8
  %49 = add nsw i64 %48, %44
  %50 = mul nsw i64 %49, %2
  %51 = getelementptr inbounds double, ptr %1, i64 %50
  %52 = load double, ptr %51, align 8
  %53 = fadd double %47, %52
  store double %53, ptr %51, align 8
  %54 = add nuw nsw i64 %44, 1
  %55 = load i64, ptr %30, align 8
  %56 = icmp slt i64 %54, %55
  br i1 %56, label %43, label %42, !llvm.loop !20
}

define internal fastcc void @factorise(ptr noundef %0, i64 noundef %1) unnamed_addr #4 {
  %3 = icmp sgt i64 %1, 0
  br i1 %3, label %4, label %75

4:                                                ; preds = %2
  %5 = sitofp i64 %1 to double
  %6 = fmul double %5, 4.000000e+00
  %7 = fmul double %6, 0x3CB0000000000000
  br label %8

8:                                                ; preds = %71, %4
  %9 = phi i64 [ 0, %4 ], [ %72, %71 ]
  %10 = mul nuw nsw i64 %9, %1
  %11 = getelementptr double, ptr %0, i64 %10
  %12 = getelementptr double, ptr %11, i64 %9
  %13 = load double, ptr %12, align 8
  %14 = icmp eq i64 %9, 0
  br i1 %14, label %15, label %19

15:                                               ; preds = %19, %8
  %16 = phi double [ %13, %8 ], [ %25, %19 ]
  %17 = fmul double %7, %13
  %18 = fcmp ule double %16, %17
  br i1 %18, label %28, label %42

19:                                               ; preds = %8, %19
  %20 = phi i64 [ %26, %19 ], [ 0, %8 ]
  %21 = phi double [ %25, %19 ], [ %13, %8 ]
  %22 = getelementptr double, ptr %11, i64 %20
  %23 = load double, ptr %22, align 8
  %24 = fmul double %23, %23
  %25 = fsub double %21, %24
  %26 = add nuw nsw i64 %20, 1
  %27 = icmp eq i64 %26, %9
  br i1 %27, label %15, label %19, !llvm.loop !21

28:                                               ; preds = %15, %32
  %29 = phi i64 [ %33, %32 ], [ 0, %15 ]
  %30 = mul nuw nsw i64 %29, %1
  %31 = getelementptr double, ptr %0, i64 %30
  br label %35

32:                                               ; preds = %35
  %33 = add nuw nsw i64 %29, 1
  %34 = icmp eq i64 %33, %1
  br i1 %34, label %71, label %28, !llvm.loop !6

35:                                               ; preds = %28, %35
  %36 = phi i64 [ 0, %28 ], [ %40, %35 ]
  %37 = icmp eq i64 %29, %36
  %38 = select i1 %37, double 1.000000e+00, double 0.000000e+00
  %39 = getelementptr double, ptr %31, i64 %36
  store double %38, ptr %39, align 8
  %40 = add nuw nsw i64 %36, 1
  %41 = icmp eq i64 %40, %1
  br i1 %41, label %32, label %35, !llvm.loop !9

42:                                               ; preds = %15
  %43 = tail call double @llvm.sqrt.f64(double %16)
  store double %43, ptr %12, align 8
  %44 = add nuw nsw i64 %9, 1
  %45 = icmp slt i64 %44, %1
  br i1 %45, label %46, label %71

46:                                               ; preds = %42
  %47 = icmp eq i64 %9, 0
  br label %48

48:                                               ; preds = %46, %54
  %49 = phi i64 [ %44, %46 ], [ %58, %54 ]
  %50 = mul nuw nsw i64 %49, %1
  %51 = getelementptr double, ptr %0, i64 %50
  %52 = getelementptr double, ptr %51, i64 %9
  %53 = load double, ptr %52, align 8
  br i1 %47, label %54, label %60

54:                                               ; preds = %60, %48
  %55 = phi double [ %53, %48 ], [ %68, %60 ]
  %56 = load double, ptr %12, align 8
  %57 = fdiv double %55, %56
  store double %57, ptr %52, align 8
  %58 = add nuw nsw i64 %49, 1
  %59 = icmp slt i64 %58, %1
  br i1 %59, label %48, label %71, !llvm.loop !22

60:                                               ; preds = %48, %60
  %61 = phi i64 [ %69, %60 ], [ 0, %48 ]
  %62 = phi double [ %68, %60 ], [ %53, %48 ]
  %63 = getelementptr double, ptr %51, i64 %61
  %64 = load double, ptr %63, align 8
  %65 = getelementptr double, ptr %11, i64 %61
  %66 = load double, ptr %65, align 8
  %67 = fmul double %64, %66
  %68 = fsub double %62, %67
  %69 = add nuw nsw i64 %61, 1
  %70 = icmp eq i64 %69, %9
  br i1 %70, label %54, label %60, !llvm.loop !23

71:                                               ; preds = %54, %32, %42
  %72 = add nuw nsw i64 %9, 1
  %73 = icmp eq i64 %72, %1
  %74 = select i1 %18, i1 true, i1 %73
  br i1 %74, label %75, label %8, !llvm.loop !24

75:                                               ; preds = %71, %2
  ret void
}

declare double @llvm.sqrt.f64(double) #5

define internal fastcc void @set_rows(ptr noundef readonly %0, ptr noundef readonly %1, ptr noundef readonly %2) unnamed_addr #3 {
  %4 = getelementptr inbounds i8, ptr %0, i64 8
  %5 = load i64, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 16
  %7 = load i64, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %2, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = icmp sgt i64 %9, 0
  br i1 %10, label %11, label %23

11:                                               ; preds = %3
  %12 = icmp sgt i64 %7, 0
  %13 = icmp sgt i64 %5, 0
  %14 = sitofp i64 %5 to double
  %15 = fmul double %14, 4.000000e+00
  %16 = fmul double %15, 0x3CB0000000000000
  br label %17

17:                                               ; preds = %11, %29
  %18 = phi i64 [ 0, %11 ], [ %30, %29 ]
  br i1 %12, label %19, label %29

19:                                               ; preds = %17
  %20 = mul nsw i64 %18, %5
  %21 = getelementptr double, ptr %1, i64 %20
  %22 = mul nuw nsw i64 %18, %7
  br label %24

23:                                               ; preds = %29, %3
  ret void

24:                                               ; preds = %19, %33
  %25 = phi i64 [ 0, %19 ], [ %43, %33 ]
  br i1 %13, label %26, label %33

26:                                               ; preds = %24
  %27 = load ptr, ptr %0, align 8
  %28 = getelementptr double, ptr %27, i64 %25
  br label %45

29:                                               ; preds = %33, %17
  %30 = add nuw nsw i64 %18, 1
  %31 = load i64, ptr %8, align 8
  %32 = icmp slt i64 %30, %31
  br i1 %32, label %17, label %23, !llvm.loop !25

33:                                               ; preds = %45, %24
  %34 = phi double [ 0.000000e+00, %24 ], [ %55, %45 ]
  %35 = phi double [ 0.000000e+00, %24 ], [ %57, %45 ]
  %36 = tail call double @llvm.fabs.f64(double %34)
  %37 = fmul double %16, %35
  %38 = fcmp ole double %36, %37
  %39 = select i1 %38, double 0.000000e+00, double %34
  %40 = load ptr, ptr %2, align 8
  %41 = getelementptr double, ptr %40, i64 %22
  %42 = getelementptr double, ptr %41, i64 %25
  store double %39, ptr %42, align 8
  %43 = add nuw nsw i64 %25, 1
  %44 = icmp eq i64 %43, %7
  br i1 %44, label %29, label %24, !llvm.loop !26

45:                                               ; preds = %26, %45
  %46 = phi i64 [ 0, %26 ], [ %58, %45 ]
  %47 = phi double [ 0.000000e+00, %26 ], [ %57, %45 ]
  %48 = phi double [ 0.000000e+00, %26 ], [ %55, %45 ]
  %49 = getelementptr double, ptr %21, i64 %46
  %50 = load double, ptr %49, align 8
  %51 = mul nuw nsw i64 %46, %7
  %52 = getelementptr double, ptr %28, i64 %51
  %53 = load double, ptr %52, align 8
  %54 = fmul double %50, %53
  %55 = fadd double %48, %54
  %56 = tail call double @llvm.fabs.f64(double %54)
  %57 = fadd double %47, %56
  %58 = add nuw nsw i64 %46, 1
  %59 = icmp eq i64 %58, %5
  br i1 %59, label %33, label %45, !llvm.loop !27
}

define internal fastcc void @divide_rows(ptr noundef %0, i64 noundef %1, ptr noundef readonly %2, i64 noundef %3) unnamed_addr #4 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %6, label %14

6:                                                ; preds = %4
  %7 = icmp sgt i64 %3, 0
  %8 = add i64 %3, 1
  br label %9

9:                                                ; preds = %6, %15
  %10 = phi i64 [ 0, %6 ], [ %16, %15 ]
  br i1 %7, label %11, label %15

11:                                               ; preds = %9
  %12 = mul nuw nsw i64 %10, %3
  %13 = getelementptr double, ptr %0, i64 %12
  br label %18

14:                                               ; preds = %15, %4
  ret void

15:                                               ; preds = %26, %9
  %16 = add nuw nsw i64 %10, 1
  %17 = icmp eq i64 %16, %1
  br i1 %17, label %14, label %9, !llvm.loop !28

18:                                               ; preds = %11, %26
  %19 = phi i64 [ 0, %11 ], [ %32, %26 ]
  %20 = getelementptr double, ptr %13, i64 %19
  %21 = load double, ptr %20, align 8
  %22 = icmp eq i64 %19, 0
  br i1 %22, label %26, label %23

23:                                               ; preds = %18
  %24 = mul nuw nsw i64 %19, %3
  %25 = getelementptr double, ptr %2, i64 %24
  br label %34

26:                                               ; preds = %34, %18
  %27 = phi double [ %21, %18 ], [ %42, %34 ]
  %28 = mul i64 %19, %8
  %29 = getelementptr inbounds double, ptr %2, i64 %28
  %30 = load double, ptr %29, align 8
  %31 = fdiv double %27, %30
  store double %31, ptr %20, align 8
  %32 = add nuw nsw i64 %19, 1
  %33 = icmp eq i64 %32, %3
  br i1 %33, label %15, label %18, !llvm.loop !29

34:                                               ; preds = %23, %34
  %35 = phi i64 [ 0, %23 ], [ %43, %34 ]
  %36 = phi double [ %21, %23 ], [ %42, %34 ]
  %37 = getelementptr double, ptr %25, i64 %35
  %38 = load double, ptr %37, align 8
  %39 = getelementptr double, ptr %13, i64 %35
  %40 = load double, ptr %39, align 8
  %41 = fmul double %38, %40
  %42 = fsub double %36, %41
  %43 = add nuw nsw i64 %35, 1
  %44 = icmp eq i64 %43, %19
  br i1 %44, label %26, label %34, !llvm.loop !30
}

define internal fastcc void @minimum_norm(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2) unnamed_addr #3 {
  %4 = getelementptr inbounds i8, ptr %0, i64 8
  %5 = load i64, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 16
  %7 = load i64, ptr %6, align 8
  %8 = load ptr, ptr %0, align 8
  %9 = getelementptr inbounds i8, ptr %1, i64 120
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %1, i64 144
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %1, i64 168
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %1, i64 216
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %1, i64 240
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %1, i64 192
  %20 = load ptr, ptr %19, align 8
  %21 = icmp sgt i64 %7, 0
  br i1 %21, label %27, label %22

22:                                               ; preds = %27, %3
  %23 = icmp sgt i64 %5, 0
  br i1 %23, label %24, label %32

24:                                               ; preds = %22
  %25 = icmp sgt i64 %7, 0
  %26 = icmp sgt i64 %7, 0
  br label %41

27:                                               ; preds = %3, %27
  %28 = phi i64 [ %30, %27 ], [ 0, %3 ]
  %29 = getelementptr inbounds double, ptr %10, i64 %28
  store double 0.000000e+00, ptr %29, align 8
  %30 = add nuw nsw i64 %28, 1
  %31 = icmp eq i64 %30, %7
  br i1 %31, label %22, label %27, !llvm.loop !31

32:                                               ; preds = %75, %22
  %33 = icmp sgt i64 %2, 0
  br i1 %33, label %34, label %183

34:                                               ; preds = %32
  %35 = icmp sgt i64 %5, 0
  %36 = icmp sgt i64 %7, 0
  %37 = icmp sgt i64 %7, 0
  %38 = icmp sgt i64 %5, 0
  %39 = icmp sgt i64 %7, 0
  %40 = icmp sgt i64 %7, 0
  br label %78

41:                                               ; preds = %24, %75
  %42 = phi i64 [ 0, %24 ], [ %76, %75 ]
  %43 = mul nsw i64 %42, %7
  %44 = getelementptr inbounds double, ptr %8, i64 %43
  br i1 %25, label %45, label %54

45:                                               ; preds = %41, %45
  %46 = phi i64 [ %52, %45 ], [ 0, %41 ]
  %47 = phi double [ %51, %45 ], [ 0.000000e+00, %41 ]
  %48 = getelementptr inbounds double, ptr %44, i64 %46
  %49 = load double, ptr %48, align 8
  %50 = fmul double %49, %49
  %51 = fadd double %47, %50
  %52 = add nuw nsw i64 %46, 1
  %53 = icmp eq i64 %52, %7
  br i1 %53, label %54, label %45, !llvm.loop !14

54:                                               ; preds = %45, %41
  %55 = phi double [ 0.000000e+00, %41 ], [ %51, %45 ]
  %56 = getelementptr inbounds double, ptr %14, i64 %42
  store double 1.000000e+00, ptr %56, align 8
  %57 = getelementptr inbounds i64, ptr %20, i64 %42
  store i64 1, ptr %57, align 8
  %58 = getelementptr inbounds double, ptr %16, i64 %42
  store double 0.000000e+00, ptr %58, align 8
  %59 = getelementptr inbounds double, ptr %18, i64 %42
  store double 0.000000e+00, ptr %59, align 8
  %60 = fcmp ogt double %55, 0.000000e+00
  br i1 %60, label %61, label %75

61:                                               ; preds = %54
  %62 = tail call double @llvm.sqrt.f64(double %55)
  store double %62, ptr %58, align 8
  %63 = fdiv double 1.000000e+00, %62
  store double %63, ptr %56, align 8
  %64 = getelementptr inbounds double, ptr %12, i64 %42
  %65 = load double, ptr %64, align 8
  %66 = fmul double %63, %65
  store double %66, ptr %64, align 8
  br i1 %26, label %67, label %75

67:                                               ; preds = %61, %67
  %68 = phi i64 [ %73, %67 ], [ 0, %61 ]
  %69 = load double, ptr %56, align 8
  %70 = getelementptr inbounds double, ptr %44, i64 %68
  %71 = load double, ptr %70, align 8
  %72 = fmul double %69, %71
  store double %72, ptr %70, align 8
  %73 = add nuw nsw i64 %68, 1
  %74 = icmp eq i64 %73, %7
  br i1 %74, label %75, label %67, !llvm.loop !32

75:                                               ; preds = %67, %61, %54
  %76 = add nuw nsw i64 %42, 1
  %77 = icmp eq i64 %76, %5
  br i1 %77, label %32, label %41, !llvm.loop !33

78:                                               ; preds = %34, %180
  %79 = phi i64 [ 0, %34 ], [ %181, %180 ]
  br i1 %35, label %80, label %113

80:                                               ; preds = %78, %108
  %81 = phi i64 [ %111, %108 ], [ 0, %78 ]
  %82 = phi double [ %110, %108 ], [ 0x3BC79CA10C924224, %78 ]
  %83 = phi i64 [ %109, %108 ], [ -1, %78 ]
  %84 = icmp eq i64 %81, %2
  %85 = fcmp ogt double %82, 1.000000e-04
  %86 = select i1 %84, i1 %85, i1 false
  br i1 %86, label %113, label %87

87:                                               ; preds = %80
  %88 = getelementptr inbounds i64, ptr %20, i64 %81
  %89 = load i64, ptr %88, align 8
  %90 = icmp eq i64 %89, 1
  br i1 %90, label %91, label %108

91:                                               ; preds = %87
  %92 = mul nsw i64 %81, %7
  %93 = getelementptr inbounds double, ptr %8, i64 %92
  br i1 %36, label %94, label %103

94:                                               ; preds = %91, %94
  %95 = phi i64 [ %101, %94 ], [ 0, %91 ]
  %96 = phi double [ %100, %94 ], [ 0.000000e+00, %91 ]
  %97 = getelementptr inbounds double, ptr %93, i64 %95
  %98 = load double, ptr %97, align 8
  %99 = fmul double %98, %98
  %100 = fadd double %96, %99
  %101 = add nuw nsw i64 %95, 1
  %102 = icmp eq i64 %101, %7
  br i1 %102, label %103, label %94, !llvm.loop !14

103:                                              ; preds = %94, %91
  %104 = phi double [ 0.000000e+00, %91 ], [ %100, %94 ]
  %105 = fcmp ogt double %104, %82
  %106 = select i1 %105, i64 %81, i64 %83
  %107 = select i1 %105, double %104, double %82
  br label %108

108:                                              ; preds = %87, %103
  %109 = phi i64 [ %106, %103 ], [ %83, %87 ]
  %110 = phi double [ %107, %103 ], [ %82, %87 ]
  %111 = add nuw nsw i64 %81, 1
  %112 = icmp eq i64 %111, %5
  br i1 %112, label %113, label %80, !llvm.loop !34

113:                                              ; preds = %108, %80, %78
  %114 = phi i64 [ -1, %78 ], [ %109, %108 ], [ %83, %80 ]
  %115 = phi double [ 0x3BC79CA10C924224, %78 ], [ %110, %108 ], [ %82, %80 ]
  %116 = icmp sgt i64 %114, -1
  br i1 %116, label %117, label %183

117:                                              ; preds = %113
  %118 = tail call double @llvm.sqrt.f64(double %115)
  %119 = getelementptr inbounds double, ptr %12, i64 %114
  %120 = load double, ptr %119, align 8
  %121 = fdiv double %120, %118
  %122 = mul nsw i64 %114, %7
  %123 = getelementptr inbounds double, ptr %8, i64 %122
  %124 = getelementptr inbounds i64, ptr %20, i64 %114
  store i64 0, ptr %124, align 8
  store double 0.000000e+00, ptr %119, align 8
  %125 = getelementptr inbounds double, ptr %16, i64 %114
  %126 = load double, ptr %125, align 8
  %127 = fmul double %118, %126
  %128 = getelementptr inbounds double, ptr %18, i64 %114
  store double %127, ptr %128, align 8
  br i1 %37, label %130, label %129

129:                                              ; preds = %130, %117
  br i1 %38, label %141, label %179

130:                                              ; preds = %117, %130
  %131 = phi i64 [ %139, %130 ], [ 0, %117 ]
  %132 = getelementptr inbounds double, ptr %123, i64 %131
  %133 = load double, ptr %132, align 8
  %134 = fdiv double %133, %118
  store double %134, ptr %132, align 8
  %135 = fmul double %121, %134
  %136 = getelementptr inbounds double, ptr %10, i64 %131
  %137 = load double, ptr %136, align 8
  %138 = fadd double %137, %135
  store double %138, ptr %136, align 8
  %139 = add nuw nsw i64 %131, 1
  %140 = icmp eq i64 %139, %7
  br i1 %140, label %129, label %130, !llvm.loop !35

141:                                              ; preds = %129, %176
  %142 = phi i64 [ %177, %176 ], [ 0, %129 ]
  %143 = getelementptr inbounds i64, ptr %20, i64 %142
  %144 = load i64, ptr %143, align 8
  %145 = icmp eq i64 %144, 1
  br i1 %145, label %146, label %176

146:                                              ; preds = %141
  %147 = mul nsw i64 %142, %7
  %148 = getelementptr double, ptr %8, i64 %147
  br i1 %39, label %149, label %160

149:                                              ; preds = %146, %149
  %150 = phi i64 [ %158, %149 ], [ 0, %146 ]
  %151 = phi double [ %157, %149 ], [ 0.000000e+00, %146 ]
  %152 = getelementptr inbounds double, ptr %148, i64 %150
  %153 = load double, ptr %152, align 8
  %154 = getelementptr inbounds double, ptr %123, i64 %150
  %155 = load double, ptr %154, align 8
  %156 = fmul double %153, %155
  %157 = fadd double %151, %156
  %158 = add nuw nsw i64 %150, 1
  %159 = icmp eq i64 %158, %7
  br i1 %159, label %160, label %149, !llvm.loop !14

160:                                              ; preds = %149, %146
  %161 = phi double [ 0.000000e+00, %146 ], [ %157, %149 ]
  %162 = fmul double %121, %161
  %163 = getelementptr inbounds double, ptr %12, i64 %142
  %164 = load double, ptr %163, align 8
  %165 = fsub double %164, %162
  store double %165, ptr %163, align 8
  br i1 %40, label %166, label %176

166:                                              ; preds = %160, %166
  %167 = phi i64 [ %174, %166 ], [ 0, %160 ]
  %168 = getelementptr inbounds double, ptr %123, i64 %167
  %169 = load double, ptr %168, align 8
  %170 = fmul double %161, %169
  %171 = getelementptr double, ptr %148, i64 %167
  %172 = load double, ptr %171, align 8
  %173 = fsub double %172, %170
  store double %173, ptr %171, align 8
  %174 = add nuw nsw i64 %167, 1
  %175 = icmp eq i64 %174, %7
  br i1 %175, label %176, label %166, !llvm.loop !36

176:                                              ; preds = %166, %160, %141
  %177 = add nuw nsw i64 %142, 1
  %178 = icmp eq i64 %177, %5
  br i1 %178, label %179, label %141, !llvm.loop !37

179:                                              ; preds = %176, %129
  br i1 %116, label %180, label %183

180:                                              ; preds = %179
  %181 = add nuw nsw i64 %79, 1
  %182 = icmp eq i64 %181, %2
  br i1 %182, label %183, label %78, !llvm.loop !38

183:                                              ; preds = %180, %179, %113, %32
  %184 = phi i64 [ 0, %32 ], [ %2, %180 ], [ %79, %179 ], [ %79, %113 ]
  %185 = icmp sgt i64 %5, 0
  br i1 %185, label %186, label %190

186:                                              ; preds = %183
  %187 = icmp eq i64 %184, %2
  %188 = icmp sgt i64 %5, %2
  %189 = select i1 %187, i1 %188, i1 false
  br label %191

190:                                              ; preds = %199, %183
  ret void

191:                                              ; preds = %186, %199
  %192 = phi i64 [ 0, %186 ], [ %202, %199 ]
  br i1 %189, label %199, label %193

193:                                              ; preds = %191
  %194 = getelementptr inbounds double, ptr %12, i64 %192
  %195 = load double, ptr %194, align 8
  %196 = getelementptr inbounds double, ptr %14, i64 %192
  %197 = load double, ptr %196, align 8
  %198 = fdiv double %195, %197
  br label %199

199:                                              ; preds = %191, %193
  %200 = phi double [ %198, %193 ], [ 0.000000e+00, %191 ]
  %201 = getelementptr inbounds double, ptr %12, i64 %192
  store double %200, ptr %201, align 8
  %202 = add nuw nsw i64 %192, 1
  %203 = icmp eq i64 %202, %5
  br i1 %203, label %190, label %191, !llvm.loop !39
}

define internal fastcc void @divide_transposed(ptr noundef readonly %0, i64 noundef %1, ptr noundef %2) unnamed_addr #4 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %5, label %7

5:                                                ; preds = %3
  %6 = add nuw i64 %1, 1
  br label %8

7:                                                ; preds = %15, %3
  ret void

8:                                                ; preds = %5, %15
  %9 = phi i64 [ %1, %5 ], [ %10, %15 ]
  %10 = add nsw i64 %9, -1
  %11 = getelementptr inbounds double, ptr %2, i64 %10
  %12 = load double, ptr %11, align 8
  %13 = getelementptr double, ptr %0, i64 %10
  %14 = icmp slt i64 %9, %1
  br i1 %14, label %22, label %15

15:                                               ; preds = %22, %8
  %16 = phi double [ %12, %8 ], [ %31, %22 ]
  %17 = mul i64 %10, %6
  %18 = getelementptr inbounds double, ptr %0, i64 %17
  %19 = load double, ptr %18, align 8
  %20 = fdiv double %16, %19
  store double %20, ptr %11, align 8
  %21 = icmp sgt i64 %9, 1
  br i1 %21, label %8, label %7, !llvm.loop !40

22:                                               ; preds = %8, %22
  %23 = phi i64 [ %32, %22 ], [ %9, %8 ]
  %24 = phi double [ %31, %22 ], [ %12, %8 ]
  %25 = mul nsw i64 %23, %1
  %26 = getelementptr double, ptr %13, i64 %25
  %27 = load double, ptr %26, align 8
  %28 = getelementptr inbounds double, ptr %2, i64 %23
  %29 = load double, ptr %28, align 8
  %30 = fmul double %27, %29
  %31 = fsub double %24, %30
  %32 = add nuw nsw i64 %23, 1
  %33 = icmp eq i64 %32, %1
  br i1 %33, label %15, label %22, !llvm.loop !41
}

declare double @llvm.fabs.f64(double) #5

declare void @llvm.experimental.noalias.scope.decl(metadata) #6

declare i64 @llvm.smax.i64(i64, i64) #7

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { noinline nounwind }
attributes #3 = { noinline nounwind }
attributes #4 = { noinline nounwind }
attributes #5 = { nounwind willreturn memory(none) }
attributes #6 = { nounwind willreturn }
attributes #7 = { nounwind willreturn memory(none) }
attributes #8 = { nounwind }
attributes #9 = { nounwind }
attributes #10 = { nounwind }


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
!11 = distinct !{!11, !7, !8}
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
