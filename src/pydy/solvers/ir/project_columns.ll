; sources c177d95d9621a9e3ad7cefc22cd7bf7a8991faa354ae038e967d63aef259b874
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Held = type { ptr, i64, i64, i64, i64, i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

define i64 @project_columns(ptr noundef %0, double noundef %1, ptr noundef %2, ptr noundef %3) #0 {
  %5 = alloca %struct.Held, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 696
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %7, i64 72
  %9 = load i64, ptr %8, align 8
  %10 = inttoptr i64 %9 to ptr
  %11 = load ptr, ptr %10, align 8
  %12 = load i64, ptr %11, align 8
  %13 = inttoptr i64 %12 to ptr
  %14 = tail call i64 %13(ptr noundef %0, double noundef %1, ptr noundef %2, ptr noundef %3) #8
  %15 = icmp eq i64 %14, 0
  br i1 %15, label %16, label %190

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
  store i64 1, ptr %42, align 8, !alias.scope !3
  %43 = getelementptr inbounds i8, ptr %5, i64 72
  %44 = getelementptr inbounds i8, ptr %0, i64 744
  %45 = load ptr, ptr %44, align 8, !noalias !3
  store ptr %45, ptr %43, align 8, !alias.scope !3
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
  %51 = getelementptr inbounds i8, ptr %5, i64 120
  store ptr null, ptr %51, align 8, !alias.scope !3
  %52 = getelementptr double, ptr %45, i64 %23
  %53 = getelementptr double, ptr %52, i64 %26
  store ptr %53, ptr %46, align 8, !alias.scope !3
  %54 = mul nsw i64 %29, %23
  %55 = getelementptr inbounds double, ptr %53, i64 %54
  store ptr %55, ptr %47, align 8, !alias.scope !3
  %56 = mul nsw i64 %32, %29
  %57 = getelementptr inbounds double, ptr %55, i64 %56
  store ptr %57, ptr %48, align 8, !alias.scope !3
  %58 = mul nsw i64 %32, %26
  %59 = getelementptr inbounds double, ptr %57, i64 %58
  store ptr %59, ptr %49, align 8, !alias.scope !3
  %60 = mul i64 %32, %32
  %61 = mul i64 %60, %35
  %62 = getelementptr inbounds double, ptr %59, i64 %61
  store ptr %62, ptr %50, align 8, !alias.scope !3
  %63 = getelementptr inbounds double, ptr %62, i64 %23
  store ptr %63, ptr %51, align 8, !alias.scope !3
  %64 = load ptr, ptr %10, align 8
  %65 = getelementptr inbounds i8, ptr %64, i64 16
  %66 = load i64, ptr %65, align 8
  %67 = getelementptr inbounds i8, ptr %10, i64 48
  %68 = load ptr, ptr %67, align 8
  %69 = getelementptr inbounds i8, ptr %0, i64 144
  %70 = load ptr, ptr %69, align 8
  %71 = getelementptr inbounds i8, ptr %70, i64 8
  %72 = load i64, ptr %71, align 8
  %73 = add nsw i64 %66, 1
  %74 = sdiv i64 %72, %73
  %75 = getelementptr inbounds double, ptr %2, i64 %74
  %76 = load ptr, ptr %20, align 8
  %77 = icmp sgt i64 %32, 0
  br i1 %77, label %78, label %92

78:                                               ; preds = %16, %82
  %79 = phi i64 [ %83, %82 ], [ 0, %16 ]
  %80 = mul nuw nsw i64 %79, %32
  %81 = getelementptr double, ptr %76, i64 %80
  br label %85

82:                                               ; preds = %85
  %83 = add nuw nsw i64 %79, 1
  %84 = icmp eq i64 %83, %32
  br i1 %84, label %92, label %78, !llvm.loop !6

85:                                               ; preds = %78, %85
  %86 = phi i64 [ 0, %78 ], [ %90, %85 ]
  %87 = icmp eq i64 %79, %86
  %88 = select i1 %87, double 1.000000e+00, double 0.000000e+00
  %89 = getelementptr double, ptr %81, i64 %86
  store double %88, ptr %89, align 8
  %90 = add nuw nsw i64 %86, 1
  %91 = icmp eq i64 %90, %32
  br i1 %91, label %82, label %85, !llvm.loop !9

92:                                               ; preds = %82, %16
  %93 = icmp eq i64 %35, 1
  br i1 %93, label %94, label %114

94:                                               ; preds = %92
  %95 = getelementptr inbounds i8, ptr %20, i64 8
  %96 = getelementptr inbounds i8, ptr %20, i64 16
  %97 = load i64, ptr %95, align 8
  %98 = load i64, ptr %96, align 8
  %99 = mul nsw i64 %98, %97
  %100 = icmp sgt i64 %99, 0
  br i1 %100, label %101, label %112

101:                                              ; preds = %94, %101
  %102 = phi i64 [ %107, %101 ], [ 0, %94 ]
  %103 = getelementptr inbounds double, ptr %59, i64 %102
  %104 = load double, ptr %103, align 8
  %105 = load ptr, ptr %20, align 8
  %106 = getelementptr inbounds double, ptr %105, i64 %102
  store double %104, ptr %106, align 8
  %107 = add nuw nsw i64 %102, 1
  %108 = load i64, ptr %95, align 8
  %109 = load i64, ptr %96, align 8
  %110 = mul nsw i64 %109, %108
  %111 = icmp slt i64 %107, %110
  br i1 %111, label %101, label %112, !llvm.loop !10

112:                                              ; preds = %101, %94
  %113 = load ptr, ptr %20, align 8
  tail call fastcc void @factorise(ptr noundef %113, i64 noundef %32) #10
  br label %114

114:                                              ; preds = %92, %112
  %115 = icmp sgt i64 %23, 0
  br i1 %115, label %116, label %160

116:                                              ; preds = %114
  %117 = tail call fastcc i64 @move(ptr noundef %0, ptr noundef nonnull %10, ptr noundef %2) #10
  %118 = icmp slt i64 %117, 0
  br i1 %118, label %188, label %119

119:                                              ; preds = %116
  %120 = getelementptr inbounds i8, ptr %20, i64 24
  %121 = getelementptr inbounds i8, ptr %20, i64 32
  %122 = getelementptr inbounds i8, ptr %20, i64 40
  %123 = load i64, ptr %121, align 8
  %124 = load i64, ptr %122, align 8
  %125 = mul nsw i64 %124, %123
  %126 = icmp sgt i64 %125, 0
  br i1 %126, label %132, label %127

127:                                              ; preds = %132, %119
  %128 = icmp sgt i64 %66, 0
  br i1 %128, label %129, label %160

129:                                              ; preds = %127
  %130 = getelementptr inbounds i8, ptr %20, i64 144
  %131 = tail call i64 @llvm.smax.i64(i64 %23, i64 1)
  br label %143

132:                                              ; preds = %119, %132
  %133 = phi i64 [ %138, %132 ], [ 0, %119 ]
  %134 = getelementptr inbounds double, ptr %55, i64 %133
  %135 = load double, ptr %134, align 8
  %136 = load ptr, ptr %120, align 8
  %137 = getelementptr inbounds double, ptr %136, i64 %133
  store double %135, ptr %137, align 8
  %138 = add nuw nsw i64 %133, 1
  %139 = load i64, ptr %121, align 8
  %140 = load i64, ptr %122, align 8
  %141 = mul nsw i64 %140, %139
  %142 = icmp slt i64 %138, %141
  br i1 %142, label %132, label %127, !llvm.loop !10

143:                                              ; preds = %129, %156
  %144 = phi i64 [ 0, %129 ], [ %158, %156 ]
  %145 = getelementptr inbounds double, ptr %68, i64 %144
  %146 = load ptr, ptr %130, align 8
  br label %147

147:                                              ; preds = %143, %147
  %148 = phi i64 [ %154, %147 ], [ 0, %143 ]
  %149 = mul nuw nsw i64 %148, %66
  %150 = getelementptr inbounds double, ptr %145, i64 %149
  %151 = load double, ptr %150, align 8
  %152 = fneg double %151
  %153 = getelementptr inbounds double, ptr %146, i64 %148
  store double %152, ptr %153, align 8
  %154 = add nuw nsw i64 %148, 1
  %155 = icmp eq i64 %154, %131
  br i1 %155, label %156, label %147, !llvm.loop !11

156:                                              ; preds = %147
  %157 = getelementptr inbounds double, ptr %75, i64 %144
  call fastcc void @move_positions(ptr noundef nonnull %5, ptr noundef %157, i64 noundef %66) #10
  %158 = add nuw nsw i64 %144, 1
  %159 = icmp eq i64 %158, %66
  br i1 %159, label %160, label %143, !llvm.loop !12

160:                                              ; preds = %156, %127, %114
  %161 = icmp sgt i64 %26, 0
  br i1 %161, label %162, label %188

162:                                              ; preds = %160
  %163 = tail call fastcc i64 @move(ptr noundef %0, ptr noundef nonnull %10, ptr noundef %2) #10
  %164 = icmp slt i64 %163, 0
  br i1 %164, label %188, label %165

165:                                              ; preds = %162
  %166 = icmp sgt i64 %66, 0
  br i1 %166, label %167, label %188

167:                                              ; preds = %165
  %168 = mul nsw i64 %66, %23
  %169 = getelementptr inbounds double, ptr %68, i64 %168
  %170 = getelementptr inbounds i8, ptr %20, i64 144
  br label %171

171:                                              ; preds = %167, %184
  %172 = phi i64 [ 0, %167 ], [ %186, %184 ]
  %173 = getelementptr inbounds double, ptr %169, i64 %172
  %174 = load ptr, ptr %170, align 8
  br label %175

175:                                              ; preds = %171, %175
  %176 = phi i64 [ %182, %175 ], [ 0, %171 ]
  %177 = mul nuw nsw i64 %176, %66
  %178 = getelementptr inbounds double, ptr %173, i64 %177
  %179 = load double, ptr %178, align 8
  %180 = fneg double %179
  %181 = getelementptr inbounds double, ptr %174, i64 %176
  store double %180, ptr %181, align 8
  %182 = add nuw nsw i64 %176, 1
  %183 = icmp eq i64 %182, %26
  br i1 %183, label %184, label %175, !llvm.loop !11

184:                                              ; preds = %175
  %185 = getelementptr inbounds double, ptr %75, i64 %172
  call fastcc void @move_speeds(ptr noundef nonnull %5, ptr noundef %185, i64 noundef %66) #10
  %186 = add nuw nsw i64 %172, 1
  %187 = icmp eq i64 %186, %66
  br i1 %187, label %188, label %171, !llvm.loop !13

188:                                              ; preds = %184, %165, %160, %162, %116
  %189 = phi i64 [ 6, %116 ], [ 6, %162 ], [ 0, %160 ], [ 0, %165 ], [ 0, %184 ]
  br label %190

190:                                              ; preds = %4, %188
  %191 = phi i64 [ %189, %188 ], [ %14, %4 ]
  ret i64 %191
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
  %16 = load ptr, ptr %15, align 8
  %17 = tail call i32 %16(ptr noundef %8, ptr noundef %2, ptr noundef %10, ptr noundef %12, ptr noundef %14) #8
  %18 = sext i32 %17 to i64
  ret i64 %18
}

define internal fastcc void @move_positions(ptr noundef readonly %0, ptr noundef %1, i64 noundef %2) unnamed_addr #3 {
  %4 = load ptr, ptr %0, align 8
  %5 = getelementptr inbounds i8, ptr %4, i64 120
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 80
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr inbounds i8, ptr %4, i64 48
  %10 = getelementptr inbounds i8, ptr %4, i64 56
  %11 = getelementptr inbounds i8, ptr %4, i64 64
  %12 = load i64, ptr %10, align 8
  %13 = load i64, ptr %11, align 8
  %14 = mul nsw i64 %13, %12
  %15 = icmp sgt i64 %14, 0
  br i1 %15, label %16, label %27

16:                                               ; preds = %3, %16
  %17 = phi i64 [ %22, %16 ], [ 0, %3 ]
  %18 = getelementptr inbounds double, ptr %8, i64 %17
  %19 = load double, ptr %18, align 8
  %20 = load ptr, ptr %9, align 8
  %21 = getelementptr inbounds double, ptr %20, i64 %17
  store double %19, ptr %21, align 8
  %22 = add nuw nsw i64 %17, 1
  %23 = load i64, ptr %10, align 8
  %24 = load i64, ptr %11, align 8
  %25 = mul nsw i64 %24, %23
  %26 = icmp slt i64 %22, %25
  br i1 %26, label %16, label %27, !llvm.loop !10

27:                                               ; preds = %16, %3
  tail call fastcc void @set_rows(ptr noundef nonnull %0) #10
  %28 = getelementptr inbounds i8, ptr %4, i64 72
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds i8, ptr %0, i64 8
  %31 = load i64, ptr %30, align 8
  %32 = load ptr, ptr %4, align 8
  %33 = getelementptr inbounds i8, ptr %0, i64 32
  %34 = load i64, ptr %33, align 8
  tail call fastcc void @divide_rows(ptr noundef %29, i64 noundef %31, ptr noundef %32, i64 noundef %34) #10
  %35 = getelementptr inbounds i8, ptr %0, i64 48
  %36 = load i64, ptr %35, align 8
  %37 = getelementptr inbounds i8, ptr %0, i64 64
  %38 = load i64, ptr %37, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %28, ptr noundef nonnull %4, i64 noundef %36, i64 noundef %38) #10
  %39 = load i64, ptr %33, align 8
  %40 = icmp sgt i64 %39, 0
  br i1 %40, label %41, label %50

41:                                               ; preds = %27, %41
  %42 = phi i64 [ %48, %41 ], [ 0, %27 ]
  %43 = phi double [ %47, %41 ], [ 0.000000e+00, %27 ]
  %44 = getelementptr inbounds double, ptr %6, i64 %42
  %45 = load double, ptr %44, align 8
  %46 = fmul double %45, %45
  %47 = fadd double %43, %46
  %48 = add nuw nsw i64 %42, 1
  %49 = icmp eq i64 %48, %39
  br i1 %49, label %50, label %41, !llvm.loop !14

50:                                               ; preds = %41, %27
  %51 = phi double [ 0.000000e+00, %27 ], [ %47, %41 ]
  %52 = tail call double @llvm.sqrt.f64(double %51)
  %53 = load i64, ptr %30, align 8
  %54 = icmp sgt i64 %53, 0
  br i1 %54, label %55, label %58

55:                                               ; preds = %50
  %56 = getelementptr inbounds i8, ptr %4, i64 240
  %57 = getelementptr inbounds i8, ptr %4, i64 192
  br label %67

58:                                               ; preds = %67, %50
  %59 = load ptr, ptr %4, align 8
  %60 = load i64, ptr %33, align 8
  %61 = load ptr, ptr %5, align 8
  tail call fastcc void @divide_transposed(ptr noundef %59, i64 noundef %60, ptr noundef %61) #10
  %62 = getelementptr inbounds i8, ptr %0, i64 24
  %63 = load i64, ptr %62, align 8
  %64 = icmp sgt i64 %63, 0
  br i1 %64, label %65, label %81

65:                                               ; preds = %58
  %66 = getelementptr inbounds i8, ptr %4, i64 24
  br label %88

67:                                               ; preds = %55, %67
  %68 = phi i64 [ 0, %55 ], [ %78, %67 ]
  %69 = load ptr, ptr %56, align 8
  %70 = getelementptr inbounds double, ptr %69, i64 %68
  %71 = load double, ptr %70, align 8
  %72 = fcmp une double %71, 0.000000e+00
  %73 = load ptr, ptr %57, align 8
  %74 = getelementptr inbounds double, ptr %73, i64 %68
  %75 = load double, ptr %74, align 8
  %76 = fmul double %52, %75
  %77 = select i1 %72, double %71, double %76
  store double %77, ptr %70, align 8
  %78 = add nuw nsw i64 %68, 1
  %79 = load i64, ptr %30, align 8
  %80 = icmp slt i64 %78, %79
  br i1 %80, label %67, label %58, !llvm.loop !15

81:                                               ; preds = %99, %58
  %82 = getelementptr inbounds i8, ptr %0, i64 24
  %83 = load i64, ptr %30, align 8
  %84 = icmp sgt i64 %83, 0
  br i1 %84, label %85, label %121

85:                                               ; preds = %81
  %86 = getelementptr inbounds i8, ptr %4, i64 144
  %87 = load ptr, ptr %86, align 8
  br label %127

88:                                               ; preds = %65, %99
  %89 = phi i64 [ 0, %65 ], [ %105, %99 ]
  %90 = mul nsw i64 %89, %2
  %91 = getelementptr inbounds double, ptr %1, i64 %90
  %92 = load double, ptr %91, align 8
  %93 = load i64, ptr %33, align 8
  %94 = icmp sgt i64 %93, 0
  br i1 %94, label %95, label %99

95:                                               ; preds = %88
  %96 = load ptr, ptr %66, align 8
  %97 = mul nuw nsw i64 %93, %89
  %98 = getelementptr double, ptr %96, i64 %97
  br label %108

99:                                               ; preds = %108, %88
  %100 = phi double [ %92, %88 ], [ %116, %108 ]
  %101 = load i64, ptr %37, align 8
  %102 = and i64 %101, 4294967295
  %103 = icmp eq i64 %102, 0
  %104 = select i1 %103, double %92, double %100
  store double %104, ptr %91, align 8
  %105 = add nuw nsw i64 %89, 1
  %106 = load i64, ptr %62, align 8
  %107 = icmp slt i64 %105, %106
  br i1 %107, label %88, label %81, !llvm.loop !16

108:                                              ; preds = %95, %108
  %109 = phi i64 [ 0, %95 ], [ %117, %108 ]
  %110 = phi double [ %92, %95 ], [ %116, %108 ]
  %111 = getelementptr double, ptr %98, i64 %109
  %112 = load double, ptr %111, align 8
  %113 = getelementptr inbounds double, ptr %6, i64 %109
  %114 = load double, ptr %113, align 8
  %115 = fmul double %112, %114
  %116 = fadd double %110, %115
  %117 = add nuw nsw i64 %109, 1
  %118 = icmp eq i64 %117, %93
  br i1 %118, label %99, label %108, !llvm.loop !17

119:                                              ; preds = %127
  %120 = fcmp ule double %134, 0.000000e+00
  br label %121

121:                                              ; preds = %119, %81
  %122 = phi i1 [ true, %81 ], [ %120, %119 ]
  %123 = load i64, ptr %37, align 8
  %124 = and i64 %123, 1
  %125 = icmp eq i64 %124, 0
  %126 = select i1 %122, i1 true, i1 %125
  br i1 %126, label %152, label %137

127:                                              ; preds = %85, %127
  %128 = phi i64 [ 0, %85 ], [ %135, %127 ]
  %129 = phi double [ 0.000000e+00, %85 ], [ %134, %127 ]
  %130 = getelementptr inbounds double, ptr %87, i64 %128
  %131 = load double, ptr %130, align 8
  %132 = tail call double @llvm.fabs.f64(double %131)
  %133 = fcmp ogt double %132, %129
  %134 = select i1 %133, double %132, double %129
  %135 = add nuw nsw i64 %128, 1
  %136 = icmp eq i64 %135, %83
  br i1 %136, label %119, label %127, !llvm.loop !18

137:                                              ; preds = %121
  %138 = load i64, ptr %35, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %9, ptr noundef nonnull %4, i64 noundef %138, i64 noundef 1) #10
  %139 = load i64, ptr %82, align 8
  %140 = icmp sgt i64 %139, 0
  br i1 %140, label %141, label %152

141:                                              ; preds = %137, %141
  %142 = phi i64 [ %149, %141 ], [ 0, %137 ]
  %143 = mul nsw i64 %142, %2
  %144 = getelementptr inbounds double, ptr %1, i64 %143
  %145 = load double, ptr %144, align 8
  %146 = getelementptr inbounds double, ptr %6, i64 %142
  %147 = load double, ptr %146, align 8
  %148 = fadd double %145, %147
  store double %148, ptr %144, align 8
  %149 = add nuw nsw i64 %142, 1
  %150 = load i64, ptr %82, align 8
  %151 = icmp slt i64 %149, %150
  br i1 %151, label %141, label %152, !llvm.loop !19

152:                                              ; preds = %141, %137, %121
  ret void
}


define internal fastcc void @move_speeds(ptr noundef readonly %0, ptr noundef %1, i64 noundef %2) unnamed_addr #3 {
  %4 = load ptr, ptr %0, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 96
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
  %34 = getelementptr inbounds i8, ptr %0, i64 64
  %35 = load i64, ptr %34, align 8
  tail call fastcc void @minimum_norm(ptr noundef nonnull %7, ptr noundef nonnull %4, i64 noundef %33, i64 noundef %35) #10
  %36 = load ptr, ptr %4, align 8
  %37 = load i64, ptr %30, align 8
  %38 = getelementptr inbounds i8, ptr %4, i64 120
  %39 = load ptr, ptr %38, align 8
  tail call fastcc void @divide_transposed(ptr noundef %36, i64 noundef %37, ptr noundef %39) #10
  %40 = load i64, ptr %30, align 8
  %41 = icmp sgt i64 %40, 0
  br i1 %41, label %42, label %44

42:                                               ; preds = %25
  %43 = getelementptr inbounds i8, ptr %0, i64 24
  br label %45

44:                                               ; preds = %45, %25
  ret void

45:                                               ; preds = %42, %45
  %46 = phi i64 [ 0, %42 ], [ %60, %45 ]
  %47 = load i64, ptr %43, align 8
  %48 = add nsw i64 %47, %46
  %49 = mul nsw i64 %48, %2
  %50 = getelementptr inbounds double, ptr %1, i64 %49
  %51 = load double, ptr %50, align 8
  %52 = load i64, ptr %34, align 8
  %53 = load ptr, ptr %38, align 8
  %54 = getelementptr inbounds double, ptr %53, i64 %46
  %55 = load double, ptr %54, align 8
  %56 = fadd double %51, %55
  %57 = and i64 %52, 4294967295
  %58 = icmp eq i64 %57, 0
  %59 = select i1 %58, double %51, double %56
  store double %59, ptr %50, align 8
  %60 = add nuw nsw i64 %46, 1
  %61 = load i64, ptr %30, align 8
  %62 = icmp slt i64 %60, %61
  br i1 %62, label %45, label %44, !llvm.loop !20
}

define internal fastcc void @factorise(ptr noundef %0, i64 noundef %1) unnamed_addr #4 {
  %3 = icmp sgt i64 %1, 0
  br i1 %3, label %4, label %13

4:                                                ; preds = %2
  %5 = sitofp i64 %1 to double
  %6 = fmul double %5, 4.000000e+00
  %7 = fmul double %6, 0x3CB0000000000000
  br label %17

8:                                                ; preds = %53, %26
  %9 = icmp slt i64 %31, %1
  %10 = select i1 %9, i1 %29, i1 false
  br i1 %10, label %17, label %11, !llvm.loop !21

11:                                               ; preds = %8
  %12 = xor i1 %29, true
  br label %13

13:                                               ; preds = %11, %2
  %14 = phi i1 [ false, %2 ], [ %12, %11 ]
  %15 = icmp sgt i64 %1, 0
  %16 = and i1 %14, %15
  br i1 %16, label %69, label %83

17:                                               ; preds = %4, %8
  %18 = phi i64 [ 0, %4 ], [ %31, %8 ]
  %19 = mul nuw nsw i64 %18, %1
  %20 = getelementptr double, ptr %0, i64 %19
  %21 = getelementptr double, ptr %20, i64 %18
  %22 = load double, ptr %21, align 8
  %23 = icmp eq i64 %18, 0
  br i1 %23, label %26, label %24

24:                                               ; preds = %17
  %25 = getelementptr double, ptr %0, i64 %19
  br label %37

26:                                               ; preds = %37, %17
  %27 = phi double [ %22, %17 ], [ %43, %37 ]
  %28 = fmul double %7, %22
  %29 = fcmp ogt double %27, %28
  %30 = tail call double @llvm.sqrt.f64(double %27)
  store double %30, ptr %21, align 8
  %31 = add nuw nsw i64 %18, 1
  %32 = getelementptr double, ptr %0, i64 %18
  %33 = icmp slt i64 %31, %1
  br i1 %33, label %34, label %8

34:                                               ; preds = %26
  %35 = icmp eq i64 %18, 0
  %36 = getelementptr double, ptr %0, i64 %19
  br label %46

37:                                               ; preds = %24, %37
  %38 = phi i64 [ 0, %24 ], [ %44, %37 ]
  %39 = phi double [ %22, %24 ], [ %43, %37 ]
  %40 = getelementptr double, ptr %25, i64 %38
  %41 = load double, ptr %40, align 8
  %42 = fmul double %41, %41
  %43 = fsub double %39, %42
  %44 = add nuw nsw i64 %38, 1
  %45 = icmp eq i64 %44, %18
  br i1 %45, label %26, label %37, !llvm.loop !22

46:                                               ; preds = %34, %53
  %47 = phi i64 [ %31, %34 ], [ %56, %53 ]
  %48 = mul nuw nsw i64 %47, %1
  %49 = getelementptr double, ptr %32, i64 %48
  %50 = load double, ptr %49, align 8
  br i1 %35, label %53, label %51

51:                                               ; preds = %46
  %52 = getelementptr double, ptr %0, i64 %48
  br label %58

53:                                               ; preds = %58, %46
  %54 = phi double [ %50, %46 ], [ %66, %58 ]
  %55 = fdiv double %54, %30
  store double %55, ptr %49, align 8
  %56 = add nuw nsw i64 %47, 1
  %57 = icmp slt i64 %56, %1
  br i1 %57, label %46, label %8, !llvm.loop !23

58:                                               ; preds = %51, %58
  %59 = phi i64 [ 0, %51 ], [ %67, %58 ]
  %60 = phi double [ %50, %51 ], [ %66, %58 ]
  %61 = getelementptr double, ptr %52, i64 %59
  %62 = load double, ptr %61, align 8
  %63 = getelementptr double, ptr %36, i64 %59
  %64 = load double, ptr %63, align 8
  %65 = fmul double %62, %64
  %66 = fsub double %60, %65
  %67 = add nuw nsw i64 %59, 1
  %68 = icmp eq i64 %67, %18
  br i1 %68, label %53, label %58, !llvm.loop !24

69:                                               ; preds = %13, %73
  %70 = phi i64 [ %74, %73 ], [ 0, %13 ]
  %71 = mul nuw nsw i64 %70, %1
  %72 = getelementptr double, ptr %0, i64 %71
  br label %76

73:                                               ; preds = %76
  %74 = add nuw nsw i64 %70, 1
  %75 = icmp eq i64 %74, %1
  br i1 %75, label %83, label %69, !llvm.loop !6

76:                                               ; preds = %69, %76
  %77 = phi i64 [ 0, %69 ], [ %81, %76 ]
  %78 = icmp eq i64 %70, %77
  %79 = select i1 %78, double 1.000000e+00, double 0.000000e+00
  %80 = getelementptr double, ptr %72, i64 %77
  store double %79, ptr %80, align 8
  %81 = add nuw nsw i64 %77, 1
  %82 = icmp eq i64 %81, %1
  br i1 %82, label %73, label %76, !llvm.loop !9

83:                                               ; preds = %73, %13
  ret void
}

declare double @llvm.sqrt.f64(double) #5

define internal fastcc void @set_rows(ptr noundef readonly %0) unnamed_addr #3 {
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

12:                                               ; preds = %5, %28
  %13 = phi i64 [ 0, %5 ], [ %29, %28 ]
  %14 = load i64, ptr %7, align 8
  %15 = icmp sgt i64 %14, 0
  br i1 %15, label %17, label %28

16:                                               ; preds = %28, %1
  ret void

17:                                               ; preds = %12, %32
  %18 = phi i64 [ %47, %32 ], [ %14, %12 ]
  %19 = phi i64 [ %46, %32 ], [ 0, %12 ]
  %20 = load i64, ptr %8, align 8
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %22, label %32

22:                                               ; preds = %17
  %23 = load ptr, ptr %9, align 8
  %24 = mul nuw nsw i64 %20, %13
  %25 = getelementptr double, ptr %23, i64 %24
  %26 = load ptr, ptr %10, align 8
  %27 = getelementptr double, ptr %26, i64 %19
  br label %49

28:                                               ; preds = %32, %12
  %29 = add nuw nsw i64 %13, 1
  %30 = load i64, ptr %2, align 8
  %31 = icmp slt i64 %29, %30
  br i1 %31, label %12, label %16, !llvm.loop !25

32:                                               ; preds = %49, %17
  %33 = phi double [ 0.000000e+00, %17 ], [ %59, %49 ]
  %34 = phi double [ 0.000000e+00, %17 ], [ %61, %49 ]
  %35 = tail call double @llvm.fabs.f64(double %33)
  %36 = sitofp i64 %20 to double
  %37 = fmul double %36, 4.000000e+00
  %38 = fmul double %37, 0x3CB0000000000000
  %39 = fmul double %34, %38
  %40 = fcmp ugt double %35, %39
  %41 = load ptr, ptr %11, align 8
  %42 = mul nsw i64 %18, %13
  %43 = select i1 %40, double %33, double 0.000000e+00
  %44 = getelementptr double, ptr %41, i64 %42
  %45 = getelementptr double, ptr %44, i64 %19
  store double %43, ptr %45, align 8
  %46 = add nuw nsw i64 %19, 1
  %47 = load i64, ptr %7, align 8
  %48 = icmp slt i64 %46, %47
  br i1 %48, label %17, label %28, !llvm.loop !26

49:                                               ; preds = %22, %49
  %50 = phi i64 [ 0, %22 ], [ %62, %49 ]
  %51 = phi double [ 0.000000e+00, %22 ], [ %61, %49 ]
  %52 = phi double [ 0.000000e+00, %22 ], [ %59, %49 ]
  %53 = getelementptr double, ptr %25, i64 %50
  %54 = load double, ptr %53, align 8
  %55 = mul nsw i64 %50, %18
  %56 = getelementptr double, ptr %27, i64 %55
  %57 = load double, ptr %56, align 8
  %58 = fmul double %54, %57
  %59 = fadd double %52, %58
  %60 = tail call double @llvm.fabs.f64(double %58)
  %61 = fadd double %51, %60
  %62 = add nuw nsw i64 %50, 1
  %63 = icmp eq i64 %62, %20
  br i1 %63, label %32, label %49, !llvm.loop !27
}

define internal fastcc void @divide_rows(ptr noundef %0, i64 noundef %1, ptr noundef readonly %2, i64 noundef %3) unnamed_addr #4 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %6, label %15

6:                                                ; preds = %4
  %7 = icmp sgt i64 %3, 0
  %8 = add i64 %3, 1
  br label %9

9:                                                ; preds = %6, %16
  %10 = phi i64 [ 0, %6 ], [ %17, %16 ]
  br i1 %7, label %11, label %16

11:                                               ; preds = %9
  %12 = mul nuw nsw i64 %10, %3
  %13 = getelementptr double, ptr %0, i64 %12
  %14 = getelementptr double, ptr %0, i64 %12
  br label %19

15:                                               ; preds = %16, %4
  ret void

16:                                               ; preds = %27, %9
  %17 = add nuw nsw i64 %10, 1
  %18 = icmp eq i64 %17, %1
  br i1 %18, label %15, label %9, !llvm.loop !28

19:                                               ; preds = %11, %27
  %20 = phi i64 [ 0, %11 ], [ %33, %27 ]
  %21 = getelementptr double, ptr %13, i64 %20
  %22 = load double, ptr %21, align 8
  %23 = icmp eq i64 %20, 0
  br i1 %23, label %27, label %24

24:                                               ; preds = %19
  %25 = mul nuw nsw i64 %20, %3
  %26 = getelementptr double, ptr %2, i64 %25
  br label %35

27:                                               ; preds = %35, %19
  %28 = phi double [ %22, %19 ], [ %43, %35 ]
  %29 = mul i64 %20, %8
  %30 = getelementptr inbounds double, ptr %2, i64 %29
  %31 = load double, ptr %30, align 8
  %32 = fdiv double %28, %31
  store double %32, ptr %21, align 8
  %33 = add nuw nsw i64 %20, 1
  %34 = icmp eq i64 %33, %3
  br i1 %34, label %16, label %19, !llvm.loop !29

35:                                               ; preds = %24, %35
  %36 = phi i64 [ 0, %24 ], [ %44, %35 ]
  %37 = phi double [ %22, %24 ], [ %43, %35 ]
  %38 = getelementptr double, ptr %26, i64 %36
  %39 = load double, ptr %38, align 8
  %40 = getelementptr double, ptr %14, i64 %36
  %41 = load double, ptr %40, align 8
  %42 = fmul double %39, %41
  %43 = fsub double %37, %42
  %44 = add nuw nsw i64 %36, 1
  %45 = icmp eq i64 %44, %20
  br i1 %45, label %27, label %35, !llvm.loop !30
}

define internal fastcc void @minimum_norm(ptr noundef readonly %0, ptr noundef readonly %1, i64 noundef %2, i64 noundef %3) unnamed_addr #3 {
  %5 = getelementptr inbounds i8, ptr %0, i64 8
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %0, i64 16
  %8 = load i64, ptr %7, align 8
  %9 = load ptr, ptr %0, align 8
  %10 = getelementptr inbounds i8, ptr %1, i64 120
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %1, i64 144
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %1, i64 168
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %1, i64 192
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %1, i64 216
  %19 = load ptr, ptr %18, align 8
  %20 = getelementptr inbounds i8, ptr %1, i64 264
  %21 = load ptr, ptr %20, align 8
  %22 = trunc i64 %3 to i32
  %23 = icmp sgt i64 %8, 0
  br i1 %23, label %30, label %24

24:                                               ; preds = %30, %4
  %25 = icmp sgt i64 %6, 0
  br i1 %25, label %26, label %35

26:                                               ; preds = %24
  %27 = icmp sgt i64 %8, 0
  %28 = icmp eq i32 %22, 0
  %29 = icmp sgt i64 %8, 0
  br label %46

30:                                               ; preds = %4, %30
  %31 = phi i64 [ %33, %30 ], [ 0, %4 ]
  %32 = getelementptr inbounds double, ptr %11, i64 %31
  store double 0.000000e+00, ptr %32, align 8
  %33 = add nuw nsw i64 %31, 1
  %34 = icmp eq i64 %33, %8
  br i1 %34, label %24, label %30, !llvm.loop !31

35:                                               ; preds = %74, %24
  %36 = icmp sgt i64 %2, 0
  br i1 %36, label %37, label %220

37:                                               ; preds = %35
  %38 = icmp sgt i64 %6, 0
  %39 = icmp sgt i64 %8, 0
  %40 = icmp sgt i64 %6, 0
  %41 = icmp sgt i64 %8, 0
  %42 = icmp sgt i64 %8, 0
  %43 = icmp sgt i64 %6, 0
  %44 = icmp sgt i64 %8, 0
  %45 = icmp sgt i64 %8, 0
  br label %84

46:                                               ; preds = %26, %74
  %47 = phi i64 [ 0, %26 ], [ %75, %74 ]
  %48 = mul nsw i64 %47, %8
  %49 = getelementptr inbounds double, ptr %9, i64 %48
  br i1 %27, label %50, label %59

50:                                               ; preds = %46, %50
  %51 = phi i64 [ %57, %50 ], [ 0, %46 ]
  %52 = phi double [ %56, %50 ], [ 0.000000e+00, %46 ]
  %53 = getelementptr inbounds double, ptr %49, i64 %51
  %54 = load double, ptr %53, align 8
  %55 = fmul double %54, %54
  %56 = fadd double %52, %55
  %57 = add nuw nsw i64 %51, 1
  %58 = icmp eq i64 %57, %8
  br i1 %58, label %59, label %50, !llvm.loop !14

59:                                               ; preds = %50, %46
  %60 = phi double [ 0.000000e+00, %46 ], [ %56, %50 ]
  %61 = tail call double @llvm.sqrt.f64(double %60)
  %62 = fcmp ule double %60, 0.000000e+00
  %63 = fdiv double 1.000000e+00, %61
  %64 = select i1 %62, double 1.000000e+00, double %63
  %65 = select i1 %62, double 0.000000e+00, double %61
  %66 = getelementptr inbounds double, ptr %17, i64 %47
  store double %65, ptr %66, align 8
  %67 = getelementptr inbounds double, ptr %19, i64 %47
  %68 = load double, ptr %67, align 8
  %69 = select i1 %28, double %68, double 0.000000e+00
  store double %69, ptr %67, align 8
  %70 = getelementptr inbounds double, ptr %15, i64 %47
  store double %64, ptr %70, align 8
  %71 = getelementptr inbounds double, ptr %13, i64 %47
  %72 = load double, ptr %71, align 8
  %73 = fmul double %64, %72
  store double %73, ptr %71, align 8
  br i1 %29, label %77, label %74

74:                                               ; preds = %77, %59
  %75 = add nuw nsw i64 %47, 1
  %76 = icmp eq i64 %75, %6
  br i1 %76, label %35, label %46, !llvm.loop !32

77:                                               ; preds = %59, %77
  %78 = phi i64 [ %82, %77 ], [ 0, %59 ]
  %79 = getelementptr inbounds double, ptr %49, i64 %78
  %80 = load double, ptr %79, align 8
  %81 = fmul double %64, %80
  store double %81, ptr %79, align 8
  %82 = add nuw nsw i64 %78, 1
  %83 = icmp eq i64 %82, %8
  br i1 %83, label %74, label %77, !llvm.loop !33

84:                                               ; preds = %215, %37
  %85 = phi i32 [ %22, %37 ], [ %93, %215 ]
  %86 = phi double [ 0.000000e+00, %37 ], [ %216, %215 ]
  %87 = phi i64 [ 0, %37 ], [ %217, %215 ]
  br i1 %38, label %95, label %88

88:                                               ; preds = %128, %84
  %89 = phi double [ 0x3BC79CA10C924224, %84 ], [ %129, %128 ]
  %90 = phi double [ -1.000000e+00, %84 ], [ %130, %128 ]
  %91 = fcmp oge double %90, 0.000000e+00
  %92 = and i32 %85, 1
  %93 = select i1 %91, i32 %92, i32 0
  %94 = icmp eq i32 %93, 0
  br i1 %94, label %215, label %133

95:                                               ; preds = %84, %128
  %96 = phi double [ %130, %128 ], [ -1.000000e+00, %84 ]
  %97 = phi double [ %129, %128 ], [ 0x3BC79CA10C924224, %84 ]
  %98 = phi i64 [ %131, %128 ], [ 0, %84 ]
  %99 = phi i32 [ %103, %128 ], [ %85, %84 ]
  %100 = icmp eq i64 %98, %2
  %101 = fcmp ole double %97, 1.000000e-04
  %102 = select i1 %101, i32 %99, i32 0
  %103 = select i1 %100, i32 %102, i32 %99
  %104 = getelementptr inbounds double, ptr %19, i64 %98
  %105 = load double, ptr %104, align 8
  %106 = fcmp une double %105, 0.000000e+00
  %107 = and i32 %103, 1
  %108 = icmp eq i32 %107, 0
  %109 = select i1 %106, i1 true, i1 %108
  br i1 %109, label %128, label %110

110:                                              ; preds = %95
  %111 = mul nsw i64 %98, %8
  %112 = getelementptr inbounds double, ptr %9, i64 %111
  br i1 %39, label %113, label %122

113:                                              ; preds = %110, %113
  %114 = phi i64 [ %120, %113 ], [ 0, %110 ]
  %115 = phi double [ %119, %113 ], [ 0.000000e+00, %110 ]
  %116 = getelementptr inbounds double, ptr %112, i64 %114
  %117 = load double, ptr %116, align 8
  %118 = fmul double %117, %117
  %119 = fadd double %115, %118
  %120 = add nuw nsw i64 %114, 1
  %121 = icmp eq i64 %120, %8
  br i1 %121, label %122, label %113, !llvm.loop !14

122:                                              ; preds = %113, %110
  %123 = phi double [ 0.000000e+00, %110 ], [ %119, %113 ]
  %124 = fcmp ule double %123, %97
  %125 = uitofp nneg i64 %98 to double
  %126 = select i1 %124, double %96, double %125
  %127 = select i1 %124, double %97, double %123
  br label %128

128:                                              ; preds = %122, %95
  %129 = phi double [ %127, %122 ], [ %97, %95 ]
  %130 = phi double [ %126, %122 ], [ %96, %95 ]
  %131 = add nuw nsw i64 %98, 1
  %132 = icmp eq i64 %131, %6
  br i1 %132, label %88, label %95, !llvm.loop !34

133:                                              ; preds = %88
  %134 = fadd double %86, 1.000000e+00
  %135 = tail call double @llvm.sqrt.f64(double %89)
  br i1 %40, label %138, label %136

136:                                              ; preds = %162, %133
  %137 = phi double [ 0.000000e+00, %133 ], [ %163, %162 ]
  br i1 %42, label %167, label %166

138:                                              ; preds = %133, %162
  %139 = phi i64 [ %164, %162 ], [ 0, %133 ]
  %140 = phi double [ %163, %162 ], [ 0.000000e+00, %133 ]
  %141 = uitofp nneg i64 %139 to double
  %142 = fcmp une double %90, %141
  br i1 %142, label %162, label %143

143:                                              ; preds = %138
  %144 = getelementptr inbounds double, ptr %13, i64 %139
  %145 = load double, ptr %144, align 8
  %146 = fdiv double %145, %135
  store double 0.000000e+00, ptr %144, align 8
  %147 = getelementptr inbounds double, ptr %17, i64 %139
  %148 = load double, ptr %147, align 8
  %149 = fmul double %135, %148
  %150 = getelementptr inbounds double, ptr %19, i64 %139
  store double %149, ptr %150, align 8
  br i1 %41, label %151, label %162

151:                                              ; preds = %143
  %152 = mul nuw nsw i64 %139, %8
  %153 = getelementptr double, ptr %9, i64 %152
  br label %154

154:                                              ; preds = %151, %154
  %155 = phi i64 [ 0, %151 ], [ %160, %154 ]
  %156 = getelementptr double, ptr %153, i64 %155
  %157 = load double, ptr %156, align 8
  %158 = fdiv double %157, %135
  %159 = getelementptr inbounds double, ptr %21, i64 %155
  store double %158, ptr %159, align 8
  %160 = add nuw nsw i64 %155, 1
  %161 = icmp eq i64 %160, %8
  br i1 %161, label %162, label %154, !llvm.loop !35

162:                                              ; preds = %154, %143, %138
  %163 = phi double [ %140, %138 ], [ %146, %143 ], [ %146, %154 ]
  %164 = add nuw nsw i64 %139, 1
  %165 = icmp eq i64 %164, %6
  br i1 %165, label %136, label %138, !llvm.loop !36

166:                                              ; preds = %167, %136
  br i1 %43, label %177, label %215

167:                                              ; preds = %136, %167
  %168 = phi i64 [ %175, %167 ], [ 0, %136 ]
  %169 = getelementptr inbounds double, ptr %11, i64 %168
  %170 = load double, ptr %169, align 8
  %171 = getelementptr inbounds double, ptr %21, i64 %168
  %172 = load double, ptr %171, align 8
  %173 = fmul double %137, %172
  %174 = fadd double %170, %173
  store double %174, ptr %169, align 8
  %175 = add nuw nsw i64 %168, 1
  %176 = icmp eq i64 %175, %8
  br i1 %176, label %166, label %167, !llvm.loop !37

177:                                              ; preds = %166, %212
  %178 = phi i64 [ %213, %212 ], [ 0, %166 ]
  %179 = mul nsw i64 %178, %8
  %180 = getelementptr inbounds double, ptr %9, i64 %179
  %181 = getelementptr inbounds double, ptr %19, i64 %178
  %182 = load double, ptr %181, align 8
  %183 = fcmp une double %182, 0.000000e+00
  br i1 %183, label %212, label %184

184:                                              ; preds = %177
  br i1 %44, label %185, label %196

185:                                              ; preds = %184, %185
  %186 = phi i64 [ %194, %185 ], [ 0, %184 ]
  %187 = phi double [ %193, %185 ], [ 0.000000e+00, %184 ]
  %188 = getelementptr inbounds double, ptr %180, i64 %186
  %189 = load double, ptr %188, align 8
  %190 = getelementptr inbounds double, ptr %21, i64 %186
  %191 = load double, ptr %190, align 8
  %192 = fmul double %189, %191
  %193 = fadd double %187, %192
  %194 = add nuw nsw i64 %186, 1
  %195 = icmp eq i64 %194, %8
  br i1 %195, label %196, label %185, !llvm.loop !14

196:                                              ; preds = %185, %184
  %197 = phi double [ 0.000000e+00, %184 ], [ %193, %185 ]
  %198 = getelementptr inbounds double, ptr %13, i64 %178
  %199 = load double, ptr %198, align 8
  %200 = fmul double %137, %197
  %201 = fsub double %199, %200
  store double %201, ptr %198, align 8
  br i1 %45, label %202, label %212

202:                                              ; preds = %196, %202
  %203 = phi i64 [ %210, %202 ], [ 0, %196 ]
  %204 = getelementptr inbounds double, ptr %180, i64 %203
  %205 = load double, ptr %204, align 8
  %206 = getelementptr inbounds double, ptr %21, i64 %203
  %207 = load double, ptr %206, align 8
  %208 = fmul double %197, %207
  %209 = fsub double %205, %208
  store double %209, ptr %204, align 8
  %210 = add nuw nsw i64 %203, 1
  %211 = icmp eq i64 %210, %8
  br i1 %211, label %212, label %202, !llvm.loop !38

212:                                              ; preds = %202, %196, %177
  %213 = add nuw nsw i64 %178, 1
  %214 = icmp eq i64 %213, %6
  br i1 %214, label %215, label %177, !llvm.loop !39

215:                                              ; preds = %212, %166, %88
  %216 = phi double [ %86, %88 ], [ %134, %166 ], [ %134, %212 ]
  %217 = add nuw nsw i64 %87, 1
  %218 = icmp eq i64 %217, %2
  %219 = select i1 %94, i1 true, i1 %218
  br i1 %219, label %220, label %84, !llvm.loop !40

220:                                              ; preds = %215, %35
  %221 = phi double [ 0.000000e+00, %35 ], [ %216, %215 ]
  %222 = icmp sgt i64 %6, %2
  %223 = select i1 %222, i64 %2, i64 -1
  %224 = sitofp i64 %223 to double
  %225 = fcmp une double %221, %224
  %226 = icmp sgt i64 %6, 0
  br i1 %226, label %228, label %227

227:                                              ; preds = %228, %220
  ret void

228:                                              ; preds = %220, %228
  %229 = phi i64 [ %236, %228 ], [ 0, %220 ]
  %230 = getelementptr inbounds double, ptr %13, i64 %229
  %231 = load double, ptr %230, align 8
  %232 = getelementptr inbounds double, ptr %15, i64 %229
  %233 = load double, ptr %232, align 8
  %234 = fdiv double %231, %233
  %235 = select i1 %225, double %234, double 0.000000e+00
  store double %235, ptr %230, align 8
  %236 = add nuw nsw i64 %229, 1
  %237 = icmp eq i64 %236, %6
  br i1 %237, label %227, label %228, !llvm.loop !41
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
  br i1 %21, label %8, label %7, !llvm.loop !42

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
  br i1 %33, label %15, label %22, !llvm.loop !43
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
!42 = distinct !{!42, !7, !8}
!43 = distinct !{!43, !7, !8}
