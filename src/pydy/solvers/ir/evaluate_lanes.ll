; sources 70d798a07b11625f2937a57fc2a82bd480a3fc2c91727efcbe2c059b63b275cb
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

define internal fastcc i32 @_set_inputs(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, ptr %5, i64 %6, i64 %7, ptr %8, i64 %9, i64 %10, ptr %11, i64 %12, ptr %13, i64 %14, i64 %15) unnamed_addr #0 {
  %17 = call i64 @llvm.smax.i64(i64 %6, i64 0)
  br label %18

18:                                               ; preds = %22, %16
  %19 = phi i64 [ 0, %16 ], [ %29, %22 ]
  %20 = phi i64 [ %17, %16 ], [ %28, %22 ]
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %27, label %26

22:                                               ; preds = %118, %45
  %23 = phi i64 [ 0, %45 ], [ %68, %118 ]
  %24 = phi i64 [ 8, %45 ], [ %67, %118 ]
  %25 = icmp sgt i64 %24, 0
  br i1 %25, label %66, label %18

26:                                               ; preds = %18
  store ptr null, ptr %0, align 8
  ret i32 0

27:                                               ; preds = %18
  %28 = add nsw i64 %20, -1
  %29 = add i64 %19, 1
  %30 = icmp slt i64 %19, 0
  %31 = select i1 %30, i64 %6, i64 0
  %32 = add i64 %19, %31
  %33 = mul i64 %32, %7
  %34 = getelementptr i64, ptr %5, i64 %33
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr i8, ptr %34, i64 8
  %37 = load i64, ptr %36, align 8
  %38 = getelementptr i8, ptr %34, i64 16
  %39 = load i64, ptr %38, align 8
  %40 = add nsw i64 %37, %39
  %41 = icmp slt i64 %37, 0
  %42 = select i1 %41, i64 %12, i64 0
  %43 = add i64 %37, %42
  %44 = icmp slt i64 %43, 0
  br i1 %44, label %50, label %51, !prof !0

45:                                               ; preds = %65, %62
  %46 = phi i64 [ %12, %65 ], [ %63, %62 ]
  %47 = sub i64 %46, %56
  %48 = call i64 @llvm.smax.i64(i64 %47, i64 0)
  %49 = getelementptr double, ptr %11, i64 %56
  br label %22

50:                                               ; preds = %27
  br label %51

51:                                               ; preds = %50, %27
  %52 = phi i64 [ 0, %50 ], [ %43, %27 ]
  %53 = icmp slt i64 %43, %12
  br i1 %53, label %55, label %54, !prof !1

54:                                               ; preds = %51
  br label %55

55:                                               ; preds = %54, %51
  %56 = phi i64 [ %12, %54 ], [ %52, %51 ]
  %57 = icmp slt i64 %40, 0
  %58 = select i1 %57, i64 %12, i64 0
  %59 = add i64 %40, %58
  %60 = icmp slt i64 %59, 0
  br i1 %60, label %61, label %62, !prof !0

61:                                               ; preds = %55
  br label %62

62:                                               ; preds = %61, %55
  %63 = phi i64 [ 0, %61 ], [ %59, %55 ]
  %64 = icmp slt i64 %59, %12
  br i1 %64, label %45, label %65, !prof !1

65:                                               ; preds = %62
  br label %45

66:                                               ; preds = %22
  %67 = add nsw i64 %24, -1
  %68 = add i64 %23, 1
  %69 = icmp slt i64 %23, 0
  %70 = select i1 %69, i64 %2, i64 0
  %71 = getelementptr double, ptr %1, i64 %23
  %72 = getelementptr double, ptr %71, i64 %70
  %73 = load double, ptr %72, align 8
  %74 = load double, ptr %49, align 8
  %75 = fcmp ogt double %74, %73
  %76 = select i1 %75, double %74, double %73
  %77 = select i1 %30, i64 %9, i64 0
  %78 = add i64 %19, %77
  %79 = select i1 %69, i64 %10, i64 0
  %80 = mul i64 %78, %10
  %81 = getelementptr i64, ptr %8, i64 %80
  %82 = getelementptr i64, ptr %81, i64 %23
  %83 = getelementptr i64, ptr %82, i64 %79
  %84 = load i64, ptr %83, align 8
  %85 = icmp slt i64 %84, 0
  %86 = select i1 %85, i64 %48, i64 0
  %87 = getelementptr double, ptr %49, i64 %84
  %88 = getelementptr double, ptr %87, i64 %86
  %89 = load double, ptr %88, align 8, !noalias !2
  %90 = fcmp ugt double %89, %76
  br i1 %90, label %101, label %91

91:                                               ; preds = %66
  %92 = add nsw i64 %48, -1
  %93 = icmp eq i64 %84, %92
  br i1 %93, label %118, label %94

94:                                               ; preds = %91
  %95 = icmp slt i64 %84, -1
  %96 = select i1 %95, i64 %48, i64 0
  %97 = getelementptr i8, ptr %87, i64 8
  %98 = getelementptr double, ptr %97, i64 %96
  %99 = load double, ptr %98, align 8, !noalias !2
  %100 = fcmp olt double %76, %99
  br i1 %100, label %118, label %101

101:                                              ; preds = %94, %66
  %102 = icmp sgt i64 %47, 1
  br i1 %102, label %103, label %118

103:                                              ; preds = %103, %101
  %104 = phi i64 [ %114, %103 ], [ %48, %101 ]
  %105 = phi i64 [ %115, %103 ], [ 0, %101 ]
  %106 = add nsw i64 %105, %104
  %107 = ashr i64 %106, 1
  %108 = icmp slt i64 %107, 0
  %109 = select i1 %108, i64 %48, i64 0
  %110 = getelementptr double, ptr %49, i64 %107
  %111 = getelementptr double, ptr %110, i64 %109
  %112 = load double, ptr %111, align 8, !noalias !2
  %113 = fcmp ole double %112, %76
  %114 = select i1 %113, i64 %104, i64 %107
  %115 = select i1 %113, i64 %107, i64 %105
  %116 = sub nsw i64 %114, %115
  %117 = icmp sgt i64 %116, 1
  br i1 %117, label %103, label %118

118:                                              ; preds = %103, %101, %94, %91
  %119 = phi i64 [ %84, %91 ], [ %84, %94 ], [ %115, %103 ], [ 0, %101 ]
  store i64 %119, ptr %83, align 8
  %120 = icmp slt i64 %119, 0
  %121 = select i1 %120, i64 %48, i64 0
  %122 = getelementptr double, ptr %49, i64 %119
  %123 = getelementptr double, ptr %122, i64 %121
  %124 = load double, ptr %123, align 8
  %125 = fsub double %76, %124
  %126 = add nsw i64 %37, %119
  %127 = icmp slt i64 %126, 0
  %128 = select i1 %127, i64 %14, i64 0
  %129 = add i64 %126, %128
  %130 = mul i64 %129, %15
  %131 = getelementptr double, ptr %13, i64 %130
  %132 = load double, ptr %131, align 8
  %133 = getelementptr i8, ptr %131, i64 8
  %134 = load double, ptr %133, align 8
  %135 = getelementptr i8, ptr %131, i64 16
  %136 = load double, ptr %135, align 8
  %137 = getelementptr i8, ptr %131, i64 24
  %138 = load double, ptr %137, align 8
  %139 = fmul double %125, %138
  %140 = fadd double %136, %139
  %141 = fmul double %125, %140
  %142 = fadd double %134, %141
  %143 = fmul double %125, %142
  %144 = fadd double %132, %143
  %145 = shl nsw i64 %35, 3
  %146 = add nsw i64 %145, %23
  %147 = icmp slt i64 %146, 0
  %148 = select i1 %147, i64 %4, i64 0
  %149 = getelementptr double, ptr %3, i64 %146
  %150 = getelementptr double, ptr %149, i64 %148
  store double %144, ptr %150, align 8
  br label %22
}

define i64 @evaluate_lanes(i64 %0) local_unnamed_addr #1 {
  %2 = alloca ptr, align 8
  %3 = alloca ptr, align 8
  %4 = inttoptr i64 %0 to ptr
  %5 = load i64, ptr %4, align 8, !noalias !5
  %6 = inttoptr i64 %5 to ptr
  %7 = getelementptr i8, ptr %4, i64 24
  %8 = load i64, ptr %7, align 8, !noalias !5
  %9 = getelementptr i8, ptr %4, i64 32
  %10 = load i64, ptr %9, align 8, !noalias !5
  %11 = inttoptr i64 %8 to ptr
  %12 = getelementptr i8, ptr %4, i64 48
  %13 = load i64, ptr %12, align 8, !noalias !5
  %14 = getelementptr i8, ptr %4, i64 56
  %15 = load i64, ptr %14, align 8, !noalias !5
  %16 = inttoptr i64 %13 to ptr
  %17 = getelementptr i8, ptr %4, i64 72
  %18 = load i64, ptr %17, align 8, !noalias !5
  %19 = inttoptr i64 %18 to ptr
  %20 = getelementptr i8, ptr %4, i64 96
  %21 = load i64, ptr %20, align 8, !noalias !5
  %22 = inttoptr i64 %21 to ptr
  %23 = getelementptr i8, ptr %4, i64 120
  %24 = load i64, ptr %23, align 8, !noalias !5
  %25 = getelementptr i8, ptr %4, i64 128
  %26 = load i64, ptr %25, align 8, !noalias !5
  %27 = getelementptr i8, ptr %4, i64 136
  %28 = load i64, ptr %27, align 8, !noalias !5
  %29 = inttoptr i64 %24 to ptr
  %30 = getelementptr i8, ptr %4, i64 144
  %31 = load i64, ptr %30, align 8, !noalias !5
  %32 = getelementptr i8, ptr %4, i64 152
  %33 = load i64, ptr %32, align 8, !noalias !5
  %34 = getelementptr i8, ptr %4, i64 160
  %35 = load i64, ptr %34, align 8, !noalias !5
  %36 = inttoptr i64 %31 to ptr
  %37 = getelementptr i8, ptr %4, i64 168
  %38 = load i64, ptr %37, align 8, !noalias !5
  %39 = getelementptr i8, ptr %4, i64 176
  %40 = load i64, ptr %39, align 8, !noalias !5
  %41 = inttoptr i64 %38 to ptr
  %42 = getelementptr i8, ptr %4, i64 192
  %43 = load i64, ptr %42, align 8, !noalias !5
  %44 = getelementptr i8, ptr %4, i64 200
  %45 = load i64, ptr %44, align 8, !noalias !5
  %46 = getelementptr i8, ptr %4, i64 208
  %47 = load i64, ptr %46, align 8, !noalias !5
  %48 = inttoptr i64 %43 to ptr
  %49 = getelementptr i8, ptr %4, i64 216
  %50 = load i64, ptr %49, align 8, !noalias !5
  %51 = inttoptr i64 %50 to ptr
  %52 = getelementptr i8, ptr %4, i64 240
  %53 = load i64, ptr %52, align 8, !noalias !5
  %54 = getelementptr i8, ptr %4, i64 248
  %55 = load i64, ptr %54, align 8, !noalias !5
  %56 = inttoptr i64 %53 to ptr
  %57 = getelementptr i8, ptr %4, i64 264
  %58 = load i64, ptr %57, align 8, !noalias !5
  %59 = getelementptr i8, ptr %4, i64 272
  %60 = load i64, ptr %59, align 8, !noalias !5
  %61 = inttoptr i64 %58 to ptr
  %62 = getelementptr i8, ptr %4, i64 288
  %63 = load i64, ptr %62, align 8, !noalias !5
  %64 = getelementptr i8, ptr %4, i64 296
  %65 = load i64, ptr %64, align 8, !noalias !5
  %66 = getelementptr i8, ptr %4, i64 304
  %67 = load i64, ptr %66, align 8, !noalias !5
  %68 = inttoptr i64 %63 to ptr
  %69 = getelementptr i8, ptr %4, i64 312
  %70 = load i64, ptr %69, align 8, !noalias !5
  %71 = getelementptr i8, ptr %4, i64 320
  %72 = load i64, ptr %71, align 8, !noalias !5
  %73 = getelementptr i8, ptr %4, i64 328
  %74 = load i64, ptr %73, align 8, !noalias !5
  %75 = inttoptr i64 %70 to ptr
  %76 = getelementptr i8, ptr %4, i64 336
  %77 = load i64, ptr %76, align 8, !noalias !5
  %78 = getelementptr i8, ptr %4, i64 344
  %79 = load i64, ptr %78, align 8, !noalias !5
  %80 = inttoptr i64 %77 to ptr
  %81 = getelementptr i8, ptr %4, i64 360
  %82 = load i64, ptr %81, align 8, !noalias !5
  %83 = getelementptr i8, ptr %4, i64 368
  %84 = load i64, ptr %83, align 8, !noalias !5
  %85 = inttoptr i64 %82 to ptr
  %86 = getelementptr i8, ptr %6, i64 16
  %87 = load i64, ptr %86, align 8, !noalias !5
  %88 = ashr i64 %60, 3
  %89 = add nuw i64 %65, 7
  %90 = lshr i64 %89, 3
  %91 = icmp sgt i64 %65, 0
  %92 = select i1 %91, i64 %90, i64 0
  br label %93

93:                                               ; preds = %111, %1
  %94 = phi i64 [ 0, %1 ], [ %98, %111 ]
  %95 = phi i64 [ %92, %1 ], [ %100, %111 ]
  %96 = icmp sgt i64 %95, 0
  %97 = add i64 %94, 8
  %98 = select i1 %96, i64 %97, i64 %94
  %99 = sext i1 %96 to i64
  %100 = add nsw i64 %95, %99
  %101 = select i1 %96, i64 %94, i64 0
  br i1 %96, label %102, label %162

102:                                              ; preds = %93, %195
  %103 = phi i64 [ %165, %195 ], [ 0, %93 ]
  %104 = phi i64 [ %164, %195 ], [ 8, %93 ]
  %105 = icmp sgt i64 %104, 0
  br i1 %105, label %163, label %106

106:                                              ; preds = %102
  %107 = getelementptr i8, ptr %6, i64 8
  %108 = load i64, ptr %107, align 8, !noalias !5
  %109 = inttoptr i64 %108 to ptr
  call void %109(ptr %19, ptr %22) #1, !noalias !5
  %110 = call i64 @llvm.smax.i64(i64 %79, i64 0)
  br label %111

111:                                              ; preds = %142, %106
  %112 = phi i64 [ 0, %106 ], [ %217, %142 ]
  %113 = phi i64 [ %110, %106 ], [ %216, %142 ]
  %114 = icmp sgt i64 %113, 0
  br i1 %114, label %215, label %93

115:                                              ; preds = %119, %215
  %116 = phi i64 [ 0, %215 ], [ %220, %119 ]
  %117 = phi i64 [ 8, %215 ], [ %219, %119 ]
  %118 = icmp sgt i64 %117, 0
  br i1 %118, label %218, label %123

119:                                              ; preds = %218, %235
  %120 = phi i64 [ 0, %218 ], [ %237, %235 ]
  %121 = phi i64 [ %234, %218 ], [ %236, %235 ]
  %122 = icmp sgt i64 %121, 0
  br i1 %122, label %235, label %115

123:                                              ; preds = %115
  %124 = icmp slt i64 %112, 0
  %125 = select i1 %124, i64 %79, i64 0
  %126 = getelementptr double, ptr %80, i64 %112
  %127 = getelementptr double, ptr %126, i64 %125
  %128 = load double, ptr %127, align 8, !noalias !5
  %129 = insertelement <8 x double> poison, double %128, i64 0
  %130 = shufflevector <8 x double> %129, <8 x double> poison, <8 x i32> zeroinitializer
  store ptr null, ptr %2, align 8, !noalias !9
  store ptr null, ptr %3, align 8, !noalias !9
  store <8 x double> %130, ptr %11, align 8, !noalias !9
  %131 = icmp sgt i64 %26, 0
  br i1 %131, label %132, label %134

132:                                              ; preds = %123
  store ptr null, ptr %2, align 8, !noalias !9
  %133 = call fastcc i32 @_set_inputs(ptr nonnull %2, ptr nonnull %11, i64 %10, ptr %16, i64 %15, ptr %29, i64 %26, i64 %28, ptr %36, i64 %33, i64 %35, ptr %41, i64 %40, ptr %48, i64 %45, i64 %47) #1
  switch i32 %133, label %250 [
    i32 -2, label %134
    i32 0, label %134
  ], !prof !13

134:                                              ; preds = %132, %132, %123
  %135 = load i64, ptr %6, align 8, !noalias !9
  %136 = inttoptr i64 %135 to ptr
  %137 = call i32 %136(ptr nonnull %11, ptr %56, ptr %16, ptr %22, ptr %61) #1, !noalias !9
  %138 = sext i32 %137 to i64
  %139 = sub nsw i64 %65, %101
  %140 = call i64 @llvm.smax.i64(i64 %139, i64 0)
  %141 = call i64 @llvm.smin.i64(i64 %140, i64 8)
  br label %142

142:                                              ; preds = %158, %134
  %143 = phi i64 [ 0, %134 ], [ %253, %158 ]
  %144 = phi i64 [ %141, %134 ], [ %252, %158 ]
  %145 = icmp sgt i64 %144, 0
  br i1 %145, label %251, label %111

146:                                              ; preds = %251
  %147 = icmp sgt i64 %87, 0
  br i1 %147, label %148, label %155

148:                                              ; preds = %146
  %149 = icmp slt i64 %143, 0
  %150 = select i1 %149, i64 %55, i64 0
  %151 = getelementptr double, ptr %56, i64 %143
  %152 = getelementptr double, ptr %151, i64 %150
  %153 = load double, ptr %152, align 8, !noalias !5
  %154 = fcmp uno double %153, 0.000000e+00
  br label %155

155:                                              ; preds = %148, %146, %251
  %156 = phi i1 [ true, %251 ], [ %154, %148 ], [ false, %146 ]
  %157 = call i64 @llvm.smax.i64(i64 %88, i64 0)
  br label %158

158:                                              ; preds = %155, %257
  %159 = phi i64 [ 0, %155 ], [ %259, %257 ]
  %160 = phi i64 [ %157, %155 ], [ %258, %257 ]
  %161 = icmp sgt i64 %160, 0
  br i1 %161, label %257, label %142

162:                                              ; preds = %93
  br label %277

163:                                              ; preds = %102
  %164 = add nsw i64 %104, -1
  %165 = add i64 %103, 1
  %166 = add nsw i64 %101, %103
  %167 = add nsw i64 %65, -1
  %168 = call i64 @llvm.smin.i64(i64 %167, i64 %166)
  %169 = shl i64 %103, 3
  %170 = add i64 %13, %169
  %171 = call i64 @llvm.smax.i64(i64 %67, i64 0)
  br label %172

172:                                              ; preds = %163, %176
  %173 = phi i64 [ 0, %163 ], [ %178, %176 ]
  %174 = phi i64 [ %171, %163 ], [ %177, %176 ]
  %175 = icmp sgt i64 %174, 0
  br i1 %175, label %176, label %192

176:                                              ; preds = %172
  %177 = add nsw i64 %174, -1
  %178 = add i64 %173, 1
  %179 = shl nsw i64 %173, 6
  %180 = add nsw i64 %170, %179
  %181 = icmp slt i64 %168, 0
  %182 = select i1 %181, i64 %65, i64 0
  %183 = add i64 %168, %182
  %184 = icmp slt i64 %173, 0
  %185 = select i1 %184, i64 %67, i64 0
  %186 = mul i64 %183, %67
  %187 = getelementptr double, ptr %68, i64 %186
  %188 = getelementptr double, ptr %187, i64 %173
  %189 = getelementptr double, ptr %188, i64 %185
  %190 = load i64, ptr %189, align 8, !noalias !14
  %191 = inttoptr i64 %180 to ptr
  store atomic i64 %190, ptr %191 unordered, align 8, !noalias !14
  br label %172

192:                                              ; preds = %172
  %193 = add i64 %18, %169
  %194 = call i64 @llvm.smax.i64(i64 %74, i64 0)
  br label %195

195:                                              ; preds = %192, %199
  %196 = phi i64 [ 0, %192 ], [ %201, %199 ]
  %197 = phi i64 [ %194, %192 ], [ %200, %199 ]
  %198 = icmp sgt i64 %197, 0
  br i1 %198, label %199, label %102

199:                                              ; preds = %195
  %200 = add nsw i64 %197, -1
  %201 = add i64 %196, 1
  %202 = shl nsw i64 %196, 6
  %203 = add nsw i64 %193, %202
  %204 = icmp slt i64 %168, 0
  %205 = select i1 %204, i64 %72, i64 0
  %206 = add i64 %168, %205
  %207 = icmp slt i64 %196, 0
  %208 = select i1 %207, i64 %74, i64 0
  %209 = mul i64 %206, %74
  %210 = getelementptr double, ptr %75, i64 %209
  %211 = getelementptr double, ptr %210, i64 %196
  %212 = getelementptr double, ptr %211, i64 %208
  %213 = load i64, ptr %212, align 8, !noalias !18
  %214 = inttoptr i64 %203 to ptr
  store atomic i64 %213, ptr %214 unordered, align 8, !noalias !18
  br label %195

215:                                              ; preds = %111
  %216 = add nsw i64 %113, -1
  %217 = add i64 %112, 1
  br label %115

218:                                              ; preds = %115
  %219 = add nsw i64 %117, -1
  %220 = add i64 %116, 1
  %221 = add nsw i64 %101, %116
  %222 = add nsw i64 %65, -1
  %223 = call i64 @llvm.smin.i64(i64 %222, i64 %221)
  %224 = load i64, ptr %51, align 8, !noalias !5
  %225 = getelementptr i8, ptr %51, i64 16
  %226 = load i64, ptr %225, align 8, !noalias !5
  %227 = mul nsw i64 %223, %226
  %228 = getelementptr i8, ptr %51, i64 24
  %229 = load i64, ptr %228, align 8, !noalias !5
  %230 = mul nsw i64 %112, %229
  %231 = add nsw i64 %227, %230
  %232 = shl nsw i64 %231, 3
  %233 = add nsw i64 %224, %232
  %234 = call i64 @llvm.smax.i64(i64 %87, i64 0)
  br label %119

235:                                              ; preds = %119
  %236 = add nsw i64 %121, -1
  %237 = add i64 %120, 1
  %238 = shl nsw i64 %120, 3
  %239 = getelementptr i8, ptr %51, i64 8
  %240 = load i64, ptr %239, align 8, !noalias !5
  %241 = mul nsw i64 %238, %240
  %242 = add nsw i64 %233, %241
  %243 = inttoptr i64 %242 to ptr
  %244 = load double, ptr %243, align 8, !noalias !5
  %245 = add nsw i64 %238, %116
  %246 = icmp slt i64 %245, 0
  %247 = select i1 %246, i64 %55, i64 0
  %248 = getelementptr double, ptr %56, i64 %245
  %249 = getelementptr double, ptr %248, i64 %247
  store double %244, ptr %249, align 8, !noalias !5
  br label %119

250:                                              ; preds = %132
  br label %277

251:                                              ; preds = %142
  %252 = add nsw i64 %144, -1
  %253 = add i64 %143, 1
  %254 = shl nuw i64 1, %143
  %255 = and i64 %254, %138
  %256 = icmp eq i64 %255, 0
  br i1 %256, label %146, label %155

257:                                              ; preds = %158
  %258 = add nsw i64 %160, -1
  %259 = add i64 %159, 1
  %260 = shl nsw i64 %159, 3
  %261 = add nsw i64 %260, %143
  %262 = icmp slt i64 %261, 0
  %263 = select i1 %262, i64 %60, i64 0
  %264 = getelementptr double, ptr %61, i64 %261
  %265 = getelementptr double, ptr %264, i64 %263
  %266 = load double, ptr %265, align 8, !noalias !5
  %267 = select i1 %156, double 0x7FF8000000000000, double %266
  %268 = mul nsw i64 %159, %65
  %269 = add nsw i64 %268, %101
  %270 = add nsw i64 %269, %143
  %271 = mul nsw i64 %270, %79
  %272 = add nsw i64 %271, %112
  %273 = icmp slt i64 %272, 0
  %274 = select i1 %273, i64 %84, i64 0
  %275 = getelementptr double, ptr %85, i64 %272
  %276 = getelementptr double, ptr %275, i64 %274
  store double %267, ptr %276, align 8, !noalias !5
  br label %158

277:                                              ; preds = %250, %162
  ret i64 0
}



declare i64 @llvm.smin.i64(i64, i64) #3

declare i64 @llvm.smax.i64(i64, i64) #3

attributes #0 = { noinline }
attributes #1 = { nounwind }
attributes #2 = { nounwind willreturn }
attributes #3 = { nounwind willreturn memory(none) }

!0 = !{!"branch_weights", i32 1, i32 99}
!1 = !{!"branch_weights", i32 99, i32 1}
!2 = !{!3}
!3 = distinct !{!3, !4}
!4 = distinct !{!4}
!5 = !{!6, !8}
!6 = distinct !{!6, !7}
!7 = distinct !{!7}
!8 = distinct !{!8, !7}
!9 = !{!10, !12, !6, !8}
!10 = distinct !{!10, !11}
!11 = distinct !{!11}
!12 = distinct !{!12, !11}
!13 = !{!"branch_weights", i32 1, i32 49, i32 49}
!14 = !{!15, !17, !6, !8}
!15 = distinct !{!15, !16}
!16 = distinct !{!16}
!17 = distinct !{!17, !16}
!18 = !{!19, !21, !6, !8}
!19 = distinct !{!19, !20}
!20 = distinct !{!20}
!21 = distinct !{!21, !20}
