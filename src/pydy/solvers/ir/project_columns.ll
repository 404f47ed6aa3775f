; sources d87e2c0ee507f43c61de2166a28c995938bc5a91f16100f5ba92ba79abcd6196
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Held = type { ptr, i64, i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

define i64 @project_columns(ptr noundef %0, double noundef %1, ptr noundef %2) #0 {
  %4 = alloca %struct.Held, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 648
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds i8, ptr %6, i64 72
  %8 = load i64, ptr %7, align 8
  %9 = inttoptr i64 %8 to ptr
  %10 = load ptr, ptr %9, align 8
  %11 = load i64, ptr %10, align 8
  %12 = inttoptr i64 %11 to ptr
  %13 = tail call i64 %12(ptr noundef %0, double noundef %1, ptr noundef %2) #8
  %14 = icmp eq i64 %13, 0
  br i1 %14, label %15, label %182

15:                                               ; preds = %3
  tail call void @llvm.experimental.noalias.scope.decl(metadata !3)
  %16 = load ptr, ptr %5, align 8, !noalias !3
  %17 = getelementptr inbounds i8, ptr %16, i64 64
  %18 = load i64, ptr %17, align 8, !noalias !3
  %19 = inttoptr i64 %18 to ptr
  store ptr %19, ptr %4, align 8, !alias.scope !3
  %20 = getelementptr inbounds i8, ptr %4, i64 8
  %21 = getelementptr inbounds i8, ptr %16, i64 16
  %22 = load i64, ptr %21, align 8, !noalias !3
  store i64 %22, ptr %20, align 8, !alias.scope !3
  %23 = getelementptr inbounds i8, ptr %4, i64 16
  %24 = getelementptr inbounds i8, ptr %16, i64 24
  %25 = load i64, ptr %24, align 8, !noalias !3
  store i64 %25, ptr %23, align 8, !alias.scope !3
  %26 = getelementptr inbounds i8, ptr %4, i64 24
  %27 = getelementptr inbounds i8, ptr %16, i64 32
  %28 = load i64, ptr %27, align 8, !noalias !3
  store i64 %28, ptr %26, align 8, !alias.scope !3
  %29 = getelementptr inbounds i8, ptr %4, i64 32
  %30 = getelementptr inbounds i8, ptr %16, i64 40
  %31 = load i64, ptr %30, align 8, !noalias !3
  store i64 %31, ptr %29, align 8, !alias.scope !3
  %32 = getelementptr inbounds i8, ptr %4, i64 40
  %33 = getelementptr inbounds i8, ptr %16, i64 48
  %34 = load i64, ptr %33, align 8, !noalias !3
  store i64 %34, ptr %32, align 8, !alias.scope !3
  %35 = getelementptr inbounds i8, ptr %4, i64 48
  %36 = getelementptr inbounds i8, ptr %0, i64 696
  %37 = load ptr, ptr %36, align 8, !noalias !3
  store ptr %37, ptr %35, align 8, !alias.scope !3
  %38 = getelementptr inbounds i8, ptr %4, i64 56
  store ptr null, ptr %38, align 8, !alias.scope !3
  %39 = getelementptr inbounds i8, ptr %4, i64 64
  store ptr null, ptr %39, align 8, !alias.scope !3
  %40 = getelementptr inbounds i8, ptr %4, i64 72
  store ptr null, ptr %40, align 8, !alias.scope !3
  %41 = getelementptr inbounds i8, ptr %4, i64 80
  store ptr null, ptr %41, align 8, !alias.scope !3
  %42 = getelementptr inbounds i8, ptr %4, i64 88
  store ptr null, ptr %42, align 8, !alias.scope !3
  %43 = getelementptr inbounds i8, ptr %4, i64 96
  store ptr null, ptr %43, align 8, !alias.scope !3
  %44 = getelementptr inbounds double, ptr %37, i64 %22
  %45 = getelementptr inbounds double, ptr %44, i64 %25
  store ptr %45, ptr %38, align 8, !alias.scope !3
  %46 = mul nsw i64 %28, %22
  %47 = getelementptr inbounds double, ptr %45, i64 %46
  store ptr %47, ptr %39, align 8, !alias.scope !3
  %48 = mul nsw i64 %31, %28
  %49 = getelementptr inbounds double, ptr %47, i64 %48
  store ptr %49, ptr %40, align 8, !alias.scope !3
  %50 = mul nsw i64 %31, %25
  %51 = getelementptr inbounds double, ptr %49, i64 %50
  store ptr %51, ptr %41, align 8, !alias.scope !3
  %52 = mul i64 %31, %31
  %53 = mul i64 %52, %34
  %54 = getelementptr inbounds double, ptr %51, i64 %53
  store ptr %54, ptr %42, align 8, !alias.scope !3
  %55 = getelementptr inbounds double, ptr %54, i64 %22
  store ptr %55, ptr %43, align 8, !alias.scope !3
  %56 = load ptr, ptr %9, align 8
  %57 = getelementptr inbounds i8, ptr %56, i64 16
  %58 = load i64, ptr %57, align 8
  %59 = getelementptr inbounds i8, ptr %9, i64 48
  %60 = load ptr, ptr %59, align 8
  %61 = getelementptr inbounds i8, ptr %0, i64 144
  %62 = load ptr, ptr %61, align 8
  %63 = getelementptr inbounds i8, ptr %62, i64 8
  %64 = load i64, ptr %63, align 8
  %65 = add nsw i64 %58, 1
  %66 = sdiv i64 %64, %65
  %67 = getelementptr inbounds double, ptr %2, i64 %66
  %68 = load ptr, ptr %19, align 8
  %69 = icmp sgt i64 %31, 0
  br i1 %69, label %70, label %84

70:                                               ; preds = %15, %74
  %71 = phi i64 [ %75, %74 ], [ 0, %15 ]
  %72 = mul nuw nsw i64 %71, %31
  %73 = getelementptr double, ptr %68, i64 %72
  br label %77

74:                                               ; preds = %77
  %75 = add nuw nsw i64 %71, 1
  %76 = icmp eq i64 %75, %31
  br i1 %76, label %84, label %70, !llvm.loop !6

77:                                               ; preds = %70, %77
  %78 = phi i64 [ 0, %70 ], [ %82, %77 ]
  %79 = icmp eq i64 %71, %78
  %80 = select i1 %79, double 1.000000e+00, double 0.000000e+00
  %81 = getelementptr double, ptr %73, i64 %78
  store double %80, ptr %81, align 8
  %82 = add nuw nsw i64 %78, 1
  %83 = icmp eq i64 %82, %31
  br i1 %83, label %74, label %77, !llvm.loop !9

84:                                               ; preds = %74, %15
  %85 = icmp eq i64 %34, 1
  br i1 %85, label %86, label %106

86:                                               ; preds = %84
  %87 = getelementptr inbounds i8, ptr %19, i64 8
  %88 = getelementptr inbounds i8, ptr %19, i64 16
  %89 = load i64, ptr %87, align 8
  %90 = load i64, ptr %88, align 8
  %91 = mul nsw i64 %90, %89
  %92 = icmp sgt i64 %91, 0
  br i1 %92, label %93, label %104

93:                                               ; preds = %86, %93
  %94 = phi i64 [ %99, %93 ], [ 0, %86 ]
  %95 = getelementptr inbounds double, ptr %51, i64 %94
  %96 = load double, ptr %95, align 8
  %97 = load ptr, ptr %19, align 8
  %98 = getelementptr inbounds double, ptr %97, i64 %94
  store double %96, ptr %98, align 8
  %99 = add nuw nsw i64 %94, 1
  %100 = load i64, ptr %87, align 8
  %101 = load i64, ptr %88, align 8
  %102 = mul nsw i64 %101, %100
  %103 = icmp slt i64 %99, %102
  br i1 %103, label %93, label %104, !llvm.loop !10

104:                                              ; preds = %93, %86
  %105 = load ptr, ptr %19, align 8
  tail call fastcc void @factorise(ptr noundef %105, i64 noundef %31) #10
  br label %106

106:                                              ; preds = %84, %104
  %107 = icmp sgt i64 %22, 0
  br i1 %107, label %108, label %152

108:                                              ; preds = %106
  %109 = tail call fastcc i64 @move(ptr noundef %0, ptr noundef nonnull %9, ptr noundef %2) #10
  %110 = icmp slt i64 %109, 0
  br i1 %110, label %180, label %111

111:                                              ; preds = %108
  %112 = getelementptr inbounds i8, ptr %19, i64 24
  %113 = getelementptr inbounds i8, ptr %19, i64 32
  %114 = getelementptr inbounds i8, ptr %19, i64 40
  %115 = load i64, ptr %113, align 8
  %116 = load i64, ptr %114, align 8
  %117 = mul nsw i64 %116, %115
  %118 = icmp sgt i64 %117, 0
  br i1 %118, label %124, label %119

119:                                              ; preds = %124, %111
  %120 = icmp sgt i64 %58, 0
  br i1 %120, label %121, label %152

121:                                              ; preds = %119
  %122 = getelementptr inbounds i8, ptr %19, i64 144
  %123 = tail call i64 @llvm.smax.i64(i64 %22, i64 1)
  br label %135

124:                                              ; preds = %111, %124
  %125 = phi i64 [ %130, %124 ], [ 0, %111 ]
  %126 = getelementptr inbounds double, ptr %47, i64 %125
  %127 = load double, ptr %126, align 8
  %128 = load ptr, ptr %112, align 8
  %129 = getelementptr inbounds double, ptr %128, i64 %125
  store double %127, ptr %129, align 8
  %130 = add nuw nsw i64 %125, 1
  %131 = load i64, ptr %113, align 8
  %132 = load i64, ptr %114, align 8
  %133 = mul nsw i64 %132, %131
  %134 = icmp slt i64 %130, %133
  br i1 %134, label %124, label %119, !llvm.loop !10

135:                                              ; preds = %121, %148
  %136 = phi i64 [ 0, %121 ], [ %150, %148 ]
  %137 = getelementptr inbounds double, ptr %60, i64 %136
  %138 = load ptr, ptr %122, align 8
  br label %139

139:                                              ; preds = %135, %139
  %140 = phi i64 [ %146, %139 ], [ 0, %135 ]
  %141 = mul nuw nsw i64 %140, %58
  %142 = getelementptr inbounds double, ptr %137, i64 %141
  %143 = load double, ptr %142, align 8
  %144 = fneg double %143
  %145 = getelementptr inbounds double, ptr %138, i64 %140
  store double %144, ptr %145, align 8
  %146 = add nuw nsw i64 %140, 1
  %147 = icmp eq i64 %146, %123
  br i1 %147, label %148, label %139, !llvm.loop !11

148:                                              ; preds = %139
  %149 = getelementptr inbounds double, ptr %67, i64 %136
  call fastcc void @move_positions(ptr noundef nonnull %4, ptr noundef %149, i64 noundef %58) #10
  %150 = add nuw nsw i64 %136, 1
  %151 = icmp eq i64 %150, %58
  br i1 %151, label %152, label %135, !llvm.loop !12

152:                                              ; preds = %148, %119, %106
  %153 = icmp sgt i64 %25, 0
  br i1 %153, label %154, label %180

154:                                              ; preds = %152
  %155 = tail call fastcc i64 @move(ptr noundef %0, ptr noundef nonnull %9, ptr noundef %2) #10
  %156 = icmp slt i64 %155, 0
  br i1 %156, label %180, label %157

157:                                              ; preds = %154
  %158 = icmp sgt i64 %58, 0
  br i1 %158, label %159, label %180

159:                                              ; preds = %157
  %160 = mul nsw i64 %58, %22
  %161 = getelementptr inbounds double, ptr %60, i64 %160
  %162 = getelementptr inbounds i8, ptr %19, i64 144
  br label %163

163:                                              ; preds = %159, %176
  %164 = phi i64 [ 0, %159 ], [ %178, %176 ]
  %165 = getelementptr inbounds double, ptr %161, i64 %164
  %166 = load ptr, ptr %162, align 8
  br label %167

167:                                              ; preds = %163, %167
  %168 = phi i64 [ %174, %167 ], [ 0, %163 ]
  %169 = mul nuw nsw i64 %168, %58
  %170 = getelementptr inbounds double, ptr %165, i64 %169
  %171 = load double, ptr %170, align 8
  %172 = fneg double %171
  %173 = getelementptr inbounds double, ptr %166, i64 %168
  store double %172, ptr %173, align 8
  %174 = add nuw nsw i64 %168, 1
  %175 = icmp eq i64 %174, %25
  br i1 %175, label %176, label %167, !llvm.loop !11

176:                                              ; preds = %167
  %177 = getelementptr inbounds double, ptr %67, i64 %164
  call fastcc void @move_speeds(ptr noundef nonnull %4, ptr noundef %177, i64 noundef %58) #10
  %178 = add nuw nsw i64 %164, 1
  %179 = icmp eq i64 %178, %58
  br i1 %179, label %180, label %163, !llvm.loop !13

180:                                              ; preds = %176, %157, %152, %154, %108
  %181 = phi i64 [ 6, %108 ], [ 6, %154 ], [ 0, %152 ], [ 0, %157 ], [ 0, %176 ]
  br label %182

182:                                              ; preds = %3, %180
  %183 = phi i64 [ %181, %180 ], [ %13, %3 ]
  ret i64 %183
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
  %5 = getelementptr inbounds i8, ptr %0, i64 56
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
  tail call fastcc void @minimum_norm(ptr noundef nonnull %28, ptr noundef nonnull %4) #10
  %35 = getelementptr inbounds i8, ptr %4, i64 120
  %36 = load ptr, ptr %35, align 8
  %37 = load i64, ptr %33, align 8
  %38 = icmp sgt i64 %37, 0
  br i1 %38, label %39, label %48

39:                                               ; preds = %25, %39
  %40 = phi i64 [ %46, %39 ], [ 0, %25 ]
  %41 = phi double [ %45, %39 ], [ 0.000000e+00, %25 ]
  %42 = getelementptr inbounds double, ptr %36, i64 %40
  %43 = load double, ptr %42, align 8
  %44 = fmul double %43, %43
  %45 = fadd double %41, %44
  %46 = add nuw nsw i64 %40, 1
  %47 = icmp eq i64 %46, %37
  br i1 %47, label %48, label %39, !llvm.loop !14

48:                                               ; preds = %39, %25
  %49 = phi double [ 0.000000e+00, %25 ], [ %45, %39 ]
  %50 = tail call double @llvm.sqrt.f64(double %49)
  %51 = load i64, ptr %30, align 8
  %52 = icmp sgt i64 %51, 0
  br i1 %52, label %53, label %56

53:                                               ; preds = %48
  %54 = getelementptr inbounds i8, ptr %4, i64 264
  %55 = getelementptr inbounds i8, ptr %4, i64 216
  br label %63

56:                                               ; preds = %74, %48
  %57 = load ptr, ptr %4, align 8
  %58 = load i64, ptr %33, align 8
  %59 = load ptr, ptr %35, align 8
  tail call fastcc void @divide_transposed(ptr noundef %57, i64 noundef %58, ptr noundef %59) #10
  %60 = getelementptr inbounds i8, ptr %0, i64 24
  %61 = load i64, ptr %60, align 8
  %62 = icmp sgt i64 %61, 0
  br i1 %62, label %78, label %85

63:                                               ; preds = %53, %74
  %64 = phi i64 [ 0, %53 ], [ %75, %74 ]
  %65 = load ptr, ptr %54, align 8
  %66 = getelementptr inbounds double, ptr %65, i64 %64
  %67 = load double, ptr %66, align 8
  %68 = fcmp oeq double %67, 0.000000e+00
  br i1 %68, label %69, label %74

69:                                               ; preds = %63
  %70 = load ptr, ptr %55, align 8
  %71 = getelementptr inbounds double, ptr %70, i64 %64
  %72 = load double, ptr %71, align 8
  %73 = fmul double %50, %72
  store double %73, ptr %66, align 8
  br label %74

74:                                               ; preds = %63, %69
  %75 = add nuw nsw i64 %64, 1
  %76 = load i64, ptr %30, align 8
  %77 = icmp slt i64 %75, %76
  br i1 %77, label %63, label %56, !llvm.loop !15

78:                                               ; preds = %56, %92
  %79 = phi i64 [ %93, %92 ], [ 0, %56 ]
  %80 = load i64, ptr %33, align 8
  %81 = icmp sgt i64 %80, 0
  br i1 %81, label %82, label %92

82:                                               ; preds = %78
  %83 = mul nsw i64 %79, %2
  %84 = getelementptr inbounds double, ptr %1, i64 %83
  br label %96

85:                                               ; preds = %92, %56
  %86 = getelementptr inbounds i8, ptr %0, i64 24
  %87 = load i64, ptr %30, align 8
  %88 = icmp sgt i64 %87, 0
  br i1 %88, label %89, label %140

89:                                               ; preds = %85
  %90 = getelementptr inbounds i8, ptr %4, i64 144
  %91 = load ptr, ptr %90, align 8
  br label %115

92:                                               ; preds = %96, %78
  %93 = add nuw nsw i64 %79, 1
  %94 = load i64, ptr %60, align 8
  %95 = icmp slt i64 %93, %94
  br i1 %95, label %78, label %85, !llvm.loop !16

96:                                               ; preds = %82, %96
  %97 = phi i64 [ %80, %82 ], [ %111, %96 ]
  %98 = phi i64 [ 0, %82 ], [ %110, %96 ]
  %99 = load ptr, ptr %26, align 8
  %100 = mul nsw i64 %97, %79
  %101 = getelementptr double, ptr %99, i64 %100
  %102 = getelementptr double, ptr %101, i64 %98
  %103 = load double, ptr %102, align 8
  %104 = load ptr, ptr %35, align 8
  %105 = getelementptr inbounds double, ptr %104, i64 %98
  %106 = load double, ptr %105, align 8
  %107 = fmul double %103, %106
  %108 = load double, ptr %84, align 8
  %109 = fadd double %108, %107
  store double %109, ptr %84, align 8
  %110 = add nuw nsw i64 %98, 1
  %111 = load i64, ptr %33, align 8
  %112 = icmp slt i64 %110, %111
  br i1 %112, label %96, label %92, !llvm.loop !17

113:                                              ; preds = %115
  %114 = fcmp ogt double %122, 0.000000e+00
  br i1 %114, label %125, label %140

115:                                              ; preds = %89, %115
  %116 = phi i64 [ 0, %89 ], [ %123, %115 ]
  %117 = phi double [ 0.000000e+00, %89 ], [ %122, %115 ]
  %118 = getelementptr inbounds double, ptr %91, i64 %116
  %119 = load double, ptr %118, align 8
  %120 = tail call double @llvm.fabs.f64(double %119)
  %121 = fcmp ogt double %120, %117
  %122 = select i1 %121, double %120, double %117
  %123 = add nuw nsw i64 %116, 1
  %124 = icmp eq i64 %123, %87
  br i1 %124, label %113, label %115, !llvm.loop !18

125:                                              ; preds = %113
  tail call fastcc void @minimum_norm(ptr noundef nonnull %7, ptr noundef nonnull %4) #10
  %126 = load i64, ptr %86, align 8
  %127 = icmp sgt i64 %126, 0
  br i1 %127, label %128, label %140

128:                                              ; preds = %125, %128
  %129 = phi i64 [ %137, %128 ], [ 0, %125 ]
  %130 = load ptr, ptr %35, align 8
  %131 = getelementptr inbounds double, ptr %130, i64 %129
  %132 = load double, ptr %131, align 8
  %133 = mul nsw i64 %129, %2
  %134 = getelementptr inbounds double, ptr %1, i64 %133
  %135 = load double, ptr %134, align 8
  %136 = fadd double %132, %135
  store double %136, ptr %134, align 8
  %137 = add nuw nsw i64 %129, 1
  %138 = load i64, ptr %86, align 8
  %139 = icmp slt i64 %137, %138
  br i1 %139, label %128, label %140, !llvm.loop !19

140:                                              ; preds = %128, %85, %125, %113
  ret void
}


define internal fastcc void @move_speeds(ptr noundef readonly %0, ptr noundef %1, i64 noundef %2) unnamed_addr #3 {
  %4 = load ptr, ptr %0, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 72
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
  tail call fastcc void @minimum_norm(ptr noundef nonnull %7, ptr noundef nonnull %4) #10
  %32 = load ptr, ptr %4, align 8
  %33 = load i64, ptr %30, align 8
  %34 = getelementptr inbounds i8, ptr %4, i64 120
  %35 = load ptr, ptr %34, align 8
  tail call fastcc void @divide_transposed(ptr noundef %32, i64 noundef %33, ptr noundef %35) #10
  %36 = load i64, ptr %30, align 8
  %37 = icmp sgt i64 %36, 0
  br i1 %37, label %38, label %40

38:                                               ; preds = %25
  %39 = getelementptr inbounds i8, ptr %0, i64 24
  br label %41

40:                                               ; preds = %41, %25
  ret void

41:                                               ; preds = %38, %41
  %42 = phi i64 [ 0, %38 ], [ %52, %41 ]
  %43 = load ptr, ptr %34, align 8
  %44 = getelementptr inbounds double, ptr %43, i64 %42
  %45 = load double, ptr %44, align 8
  %46 = load i64, ptr %39, align 8
  %47 = add nsw i64 %46, %42
  %48 = mul nsw i64 %47, %2
  %49 = getelementptr inbounds double, ptr %1, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = fadd double %45, %50
  store double %51, ptr %49, align 8
  %52 = add nuw nsw i64 %42, 1
  %53 = load i64, ptr %30, align 8
  %54 = icmp slt i64 %52, %53
  br i1 %54, label %41, label %40, !llvm.loop !20
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

define internal fastcc void @minimum_norm(ptr noundef readonly %0, ptr noundef readonly %1) unnamed_addr #3 {
  %3 = getelementptr inbounds i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = load ptr, ptr %0, align 8
  %8 = getelementptr inbounds i8, ptr %1, i64 120
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %1, i64 144
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i8, ptr %1, i64 168
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %1, i64 216
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds i8, ptr %1, i64 240
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %1, i64 192
  %19 = load ptr, ptr %18, align 8
  %20 = icmp sgt i64 %6, 0
  br i1 %20, label %26, label %21

21:                                               ; preds = %26, %2
  %22 = icmp sgt i64 %4, 0
  br i1 %22, label %23, label %31

23:                                               ; preds = %21
  %24 = icmp sgt i64 %6, 0
  %25 = icmp sgt i64 %6, 0
  br label %38

26:                                               ; preds = %2, %26
  %27 = phi i64 [ %29, %26 ], [ 0, %2 ]
  %28 = getelementptr inbounds double, ptr %9, i64 %27
  store double 0.000000e+00, ptr %28, align 8
  %29 = add nuw nsw i64 %27, 1
  %30 = icmp eq i64 %29, %6
  br i1 %30, label %21, label %26, !llvm.loop !31

31:                                               ; preds = %72, %21
  %32 = icmp sgt i64 %4, 0
  br i1 %32, label %33, label %173

33:                                               ; preds = %31
  %34 = icmp sgt i64 %6, 0
  %35 = icmp sgt i64 %6, 0
  %36 = icmp sgt i64 %6, 0
  %37 = icmp sgt i64 %6, 0
  br label %75

38:                                               ; preds = %23, %72
  %39 = phi i64 [ 0, %23 ], [ %73, %72 ]
  %40 = mul nsw i64 %39, %6
  %41 = getelementptr inbounds double, ptr %7, i64 %40
  br i1 %24, label %42, label %51

42:                                               ; preds = %38, %42
  %43 = phi i64 [ %49, %42 ], [ 0, %38 ]
  %44 = phi double [ %48, %42 ], [ 0.000000e+00, %38 ]
  %45 = getelementptr inbounds double, ptr %41, i64 %43
  %46 = load double, ptr %45, align 8
  %47 = fmul double %46, %46
  %48 = fadd double %44, %47
  %49 = add nuw nsw i64 %43, 1
  %50 = icmp eq i64 %49, %6
  br i1 %50, label %51, label %42, !llvm.loop !14

51:                                               ; preds = %42, %38
  %52 = phi double [ 0.000000e+00, %38 ], [ %48, %42 ]
  %53 = getelementptr inbounds double, ptr %13, i64 %39
  store double 1.000000e+00, ptr %53, align 8
  %54 = getelementptr inbounds i64, ptr %19, i64 %39
  store i64 1, ptr %54, align 8
  %55 = getelementptr inbounds double, ptr %15, i64 %39
  store double 0.000000e+00, ptr %55, align 8
  %56 = getelementptr inbounds double, ptr %17, i64 %39
  store double 0.000000e+00, ptr %56, align 8
  %57 = fcmp ogt double %52, 0.000000e+00
  br i1 %57, label %58, label %72

58:                                               ; preds = %51
  %59 = tail call double @llvm.sqrt.f64(double %52)
  store double %59, ptr %55, align 8
  %60 = fdiv double 1.000000e+00, %59
  store double %60, ptr %53, align 8
  %61 = getelementptr inbounds double, ptr %11, i64 %39
  %62 = load double, ptr %61, align 8
  %63 = fmul double %60, %62
  store double %63, ptr %61, align 8
  br i1 %25, label %64, label %72

64:                                               ; preds = %58, %64
  %65 = phi i64 [ %70, %64 ], [ 0, %58 ]
  %66 = load double, ptr %53, align 8
  %67 = getelementptr inbounds double, ptr %41, i64 %65
  %68 = load double, ptr %67, align 8
  %69 = fmul double %66, %68
  store double %69, ptr %67, align 8
  %70 = add nuw nsw i64 %65, 1
  %71 = icmp eq i64 %70, %6
  br i1 %71, label %72, label %64, !llvm.loop !32

72:                                               ; preds = %64, %58, %51
  %73 = add nuw nsw i64 %39, 1
  %74 = icmp eq i64 %73, %4
  br i1 %74, label %31, label %38, !llvm.loop !33

75:                                               ; preds = %33, %170
  %76 = phi i64 [ 0, %33 ], [ %171, %170 ]
  br label %79

77:                                               ; preds = %103
  %78 = icmp sgt i64 %104, -1
  br i1 %78, label %108, label %173

79:                                               ; preds = %75, %103
  %80 = phi i64 [ %106, %103 ], [ 0, %75 ]
  %81 = phi double [ %105, %103 ], [ 0x3BC79CA10C924224, %75 ]
  %82 = phi i64 [ %104, %103 ], [ -1, %75 ]
  %83 = getelementptr inbounds i64, ptr %19, i64 %80
  %84 = load i64, ptr %83, align 8
  %85 = icmp eq i64 %84, 1
  br i1 %85, label %86, label %103

86:                                               ; preds = %79
  %87 = mul nsw i64 %80, %6
  %88 = getelementptr inbounds double, ptr %7, i64 %87
  br i1 %34, label %89, label %98

89:                                               ; preds = %86, %89
  %90 = phi i64 [ %96, %89 ], [ 0, %86 ]
  %91 = phi double [ %95, %89 ], [ 0.000000e+00, %86 ]
  %92 = getelementptr inbounds double, ptr %88, i64 %90
  %93 = load double, ptr %92, align 8
  %94 = fmul double %93, %93
  %95 = fadd double %91, %94
  %96 = add nuw nsw i64 %90, 1
  %97 = icmp eq i64 %96, %6
  br i1 %97, label %98, label %89, !llvm.loop !14

98:                                               ; preds = %89, %86
  %99 = phi double [ 0.000000e+00, %86 ], [ %95, %89 ]
  %100 = fcmp ogt double %99, %81
  %101 = select i1 %100, i64 %80, i64 %82
  %102 = select i1 %100, double %99, double %81
  br label %103

103:                                              ; preds = %79, %98
  %104 = phi i64 [ %101, %98 ], [ %82, %79 ]
  %105 = phi double [ %102, %98 ], [ %81, %79 ]
  %106 = add nuw nsw i64 %80, 1
  %107 = icmp eq i64 %106, %4
  br i1 %107, label %77, label %79, !llvm.loop !34

108:                                              ; preds = %77
  %109 = tail call double @llvm.sqrt.f64(double %105)
  %110 = getelementptr inbounds double, ptr %11, i64 %104
  %111 = load double, ptr %110, align 8
  %112 = fdiv double %111, %109
  %113 = mul nsw i64 %104, %6
  %114 = getelementptr inbounds double, ptr %7, i64 %113
  %115 = getelementptr inbounds i64, ptr %19, i64 %104
  store i64 0, ptr %115, align 8
  store double 0.000000e+00, ptr %110, align 8
  %116 = getelementptr inbounds double, ptr %15, i64 %104
  %117 = load double, ptr %116, align 8
  %118 = fmul double %109, %117
  %119 = getelementptr inbounds double, ptr %17, i64 %104
  store double %118, ptr %119, align 8
  br i1 %35, label %120, label %131

120:                                              ; preds = %108, %120
  %121 = phi i64 [ %129, %120 ], [ 0, %108 ]
  %122 = getelementptr inbounds double, ptr %114, i64 %121
  %123 = load double, ptr %122, align 8
  %124 = fdiv double %123, %109
  store double %124, ptr %122, align 8
  %125 = fmul double %112, %124
  %126 = getelementptr inbounds double, ptr %9, i64 %121
  %127 = load double, ptr %126, align 8
  %128 = fadd double %127, %125
  store double %128, ptr %126, align 8
  %129 = add nuw nsw i64 %121, 1
  %130 = icmp eq i64 %129, %6
  br i1 %130, label %131, label %120, !llvm.loop !35

131:                                              ; preds = %120, %108
  br label %132

132:                                              ; preds = %131, %167
  %133 = phi i64 [ %168, %167 ], [ 0, %131 ]
  %134 = getelementptr inbounds i64, ptr %19, i64 %133
  %135 = load i64, ptr %134, align 8
  %136 = icmp eq i64 %135, 1
  br i1 %136, label %137, label %167

137:                                              ; preds = %132
  %138 = mul nsw i64 %133, %6
  %139 = getelementptr double, ptr %7, i64 %138
  br i1 %36, label %140, label %151

140:                                              ; preds = %137, %140
  %141 = phi i64 [ %149, %140 ], [ 0, %137 ]
  %142 = phi double [ %148, %140 ], [ 0.000000e+00, %137 ]
  %143 = getelementptr inbounds double, ptr %139, i64 %141
  %144 = load double, ptr %143, align 8
  %145 = getelementptr inbounds double, ptr %114, i64 %141
  %146 = load double, ptr %145, align 8
  %147 = fmul double %144, %146
  %148 = fadd double %142, %147
  %149 = add nuw nsw i64 %141, 1
  %150 = icmp eq i64 %149, %6
  br i1 %150, label %151, label %140, !llvm.loop !14

151:                                              ; preds = %140, %137
  %152 = phi double [ 0.000000e+00, %137 ], [ %148, %140 ]
  %153 = fmul double %112, %152
  %154 = getelementptr inbounds double, ptr %11, i64 %133
  %155 = load double, ptr %154, align 8
  %156 = fsub double %155, %153
  store double %156, ptr %154, align 8
  br i1 %37, label %157, label %167

157:                                              ; preds = %151, %157
  %158 = phi i64 [ %165, %157 ], [ 0, %151 ]
  %159 = getelementptr inbounds double, ptr %114, i64 %158
  %160 = load double, ptr %159, align 8
  %161 = fmul double %152, %160
  %162 = getelementptr double, ptr %139, i64 %158
  %163 = load double, ptr %162, align 8
  %164 = fsub double %163, %161
  store double %164, ptr %162, align 8
  %165 = add nuw nsw i64 %158, 1
  %166 = icmp eq i64 %165, %6
  br i1 %166, label %167, label %157, !llvm.loop !36

167:                                              ; preds = %157, %151, %132
  %168 = add nuw nsw i64 %133, 1
  %169 = icmp eq i64 %168, %4
  br i1 %169, label %170, label %132, !llvm.loop !37

170:                                              ; preds = %167
  %171 = add nuw nsw i64 %76, 1
  %172 = icmp eq i64 %171, %4
  br i1 %172, label %173, label %75, !llvm.loop !38

173:                                              ; preds = %170, %77, %31
  %174 = icmp sgt i64 %4, 0
  br i1 %174, label %176, label %175

175:                                              ; preds = %176, %173
  ret void

176:                                              ; preds = %173, %176
  %177 = phi i64 [ %183, %176 ], [ 0, %173 ]
  %178 = getelementptr inbounds double, ptr %13, i64 %177
  %179 = load double, ptr %178, align 8
  %180 = getelementptr inbounds double, ptr %11, i64 %177
  %181 = load double, ptr %180, align 8
  %182 = fdiv double %181, %179
  store double %182, ptr %180, align 8
  %183 = add nuw nsw i64 %177, 1
  %184 = icmp eq i64 %183, %4
  br i1 %184, label %175, label %176, !llvm.loop !39
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
