; sources a86ffd1f318c66f409d4032566c17efc5e7a958e22a2044844a3a2043386716d
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

define internal fastcc i32 @_set_inputs(ptr noalias %0, ptr %1, i64 %2, ptr %3, i64 %4, ptr %5, i64 %6, i64 %7, ptr %8, i64 %9, i64 %10, ptr %11, i64 %12, ptr %13, i64 %14, i64 %15) unnamed_addr #0 {
  %17 = call i64 @llvm.smax.i64(i64 %6, i64 0)
  br label %18

18:                                               ; preds = %22, %16
  %19 = phi i64 [ 0, %16 ], [ %29, %22 ]
  %20 = phi i64 [ %17, %16 ], [ %28, %22 ]
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %27, label %26

22:                                               ; preds = %115, %27
  %23 = phi i64 [ 0, %27 ], [ %142, %115 ]
  %24 = phi i64 [ 8, %27 ], [ %143, %115 ]
  %25 = icmp sgt i64 %24, 0
  br i1 %25, label %30, label %18

26:                                               ; preds = %18
  store ptr null, ptr %0, align 8
  ret i32 0

27:                                               ; preds = %18
  %28 = add nsw i64 %20, -1
  %29 = add i64 %19, 1
  br label %22

30:                                               ; preds = %22
  %31 = icmp slt i64 %23, 0
  %32 = select i1 %31, i64 %2, i64 0
  %33 = getelementptr double, ptr %1, i64 %23
  %34 = getelementptr double, ptr %33, i64 %32
  %35 = load double, ptr %34, align 8
  %36 = icmp slt i64 %19, 0
  %37 = select i1 %36, i64 %9, i64 0
  %38 = add i64 %19, %37
  %39 = select i1 %31, i64 %10, i64 0
  %40 = mul i64 %38, %10
  %41 = getelementptr i64, ptr %8, i64 %40
  %42 = getelementptr i64, ptr %41, i64 %23
  %43 = getelementptr i64, ptr %42, i64 %39
  %44 = load i64, ptr %43, align 8
  %45 = select i1 %36, i64 %6, i64 0
  %46 = add i64 %19, %45
  %47 = mul i64 %46, %7
  %48 = getelementptr i64, ptr %5, i64 %47
  %49 = getelementptr i8, ptr %48, i64 8
  %50 = load i64, ptr %49, align 8, !noalias !0
  %51 = getelementptr i8, ptr %48, i64 16
  %52 = load i64, ptr %51, align 8, !noalias !0
  %53 = add nsw i64 %50, %52
  %54 = icmp slt i64 %50, 0
  %55 = select i1 %54, i64 %12, i64 0
  %56 = add i64 %50, %55
  %57 = icmp slt i64 %56, 0
  br i1 %57, label %72, label %73, !prof !4

58:                                               ; preds = %87, %84
  %59 = phi i64 [ %12, %87 ], [ %85, %84 ]
  %60 = sub i64 %59, %78
  %61 = call i64 @llvm.smax.i64(i64 %60, i64 0)
  %62 = getelementptr double, ptr %11, i64 %78
  %63 = load double, ptr %62, align 8, !noalias !0
  %64 = fcmp ogt double %63, %35
  %65 = select i1 %64, double %63, double %35
  %66 = icmp slt i64 %44, 0
  %67 = select i1 %66, i64 %61, i64 0
  %68 = getelementptr double, ptr %62, i64 %44
  %69 = getelementptr double, ptr %68, i64 %67
  %70 = load double, ptr %69, align 8, !noalias !5
  %71 = fcmp ugt double %70, %65
  br i1 %71, label %98, label %88

72:                                               ; preds = %30
  br label %73

73:                                               ; preds = %72, %30
  %74 = phi i64 [ 0, %72 ], [ %56, %30 ]
  %75 = icmp slt i64 %56, %12
  br i1 %75, label %77, label %76, !prof !8

76:                                               ; preds = %73
  br label %77

77:                                               ; preds = %76, %73
  %78 = phi i64 [ %12, %76 ], [ %74, %73 ]
  %79 = icmp slt i64 %53, 0
  %80 = select i1 %79, i64 %12, i64 0
  %81 = add i64 %53, %80
  %82 = icmp slt i64 %81, 0
  br i1 %82, label %83, label %84, !prof !4

83:                                               ; preds = %77
  br label %84

84:                                               ; preds = %83, %77
  %85 = phi i64 [ 0, %83 ], [ %81, %77 ]
  %86 = icmp slt i64 %81, %12
  br i1 %86, label %58, label %87, !prof !8

87:                                               ; preds = %84
  br label %58

88:                                               ; preds = %58
  %89 = add nsw i64 %61, -1
  %90 = icmp eq i64 %44, %89
  br i1 %90, label %115, label %91

91:                                               ; preds = %88
  %92 = icmp slt i64 %44, -1
  %93 = select i1 %92, i64 %61, i64 0
  %94 = getelementptr i8, ptr %68, i64 8
  %95 = getelementptr double, ptr %94, i64 %93
  %96 = load double, ptr %95, align 8, !noalias !5
  %97 = fcmp olt double %65, %96
  br i1 %97, label %115, label %98

98:                                               ; preds = %91, %58
  %99 = icmp sgt i64 %60, 1
  br i1 %99, label %100, label %115

100:                                              ; preds = %100, %98
  %101 = phi i64 [ %111, %100 ], [ %61, %98 ]
  %102 = phi i64 [ %112, %100 ], [ 0, %98 ]
  %103 = add nsw i64 %102, %101
  %104 = ashr i64 %103, 1
  %105 = icmp slt i64 %104, 0
  %106 = select i1 %105, i64 %61, i64 0
  %107 = getelementptr double, ptr %62, i64 %104
  %108 = getelementptr double, ptr %107, i64 %106
  %109 = load double, ptr %108, align 8, !noalias !5
  %110 = fcmp ole double %109, %65
  %111 = select i1 %110, i64 %101, i64 %104
  %112 = select i1 %110, i64 %104, i64 %102
  %113 = sub nsw i64 %111, %112
  %114 = icmp sgt i64 %113, 1
  br i1 %114, label %100, label %115

115:                                              ; preds = %100, %98, %91, %88
  %116 = phi i64 [ %44, %88 ], [ %44, %91 ], [ %112, %100 ], [ 0, %98 ]
  %117 = icmp slt i64 %116, 0
  %118 = select i1 %117, i64 %61, i64 0
  %119 = getelementptr double, ptr %62, i64 %116
  %120 = getelementptr double, ptr %119, i64 %118
  %121 = load double, ptr %120, align 8, !noalias !0
  %122 = fsub double %65, %121
  %123 = add nsw i64 %50, %116
  %124 = icmp slt i64 %123, 0
  %125 = select i1 %124, i64 %14, i64 0
  %126 = add i64 %123, %125
  %127 = mul i64 %126, %15
  %128 = getelementptr double, ptr %13, i64 %127
  %129 = load double, ptr %128, align 8, !noalias !0
  %130 = getelementptr i8, ptr %128, i64 8
  %131 = load double, ptr %130, align 8, !noalias !0
  %132 = getelementptr i8, ptr %128, i64 16
  %133 = load double, ptr %132, align 8, !noalias !0
  %134 = getelementptr i8, ptr %128, i64 24
  %135 = load double, ptr %134, align 8, !noalias !0
  %136 = fmul double %122, %135
  %137 = fadd double %133, %136
  %138 = fmul double %122, %137
  %139 = fadd double %131, %138
  %140 = fmul double %122, %139
  %141 = fadd double %129, %140
  %142 = add i64 %23, 1
  %143 = add nsw i64 %24, -1
  store i64 %116, ptr %43, align 8
  %144 = load i64, ptr %48, align 8
  %145 = shl nsw i64 %144, 3
  %146 = add nsw i64 %145, %23
  %147 = icmp slt i64 %146, 0
  %148 = select i1 %147, i64 %4, i64 0
  %149 = getelementptr double, ptr %3, i64 %146
  %150 = getelementptr double, ptr %149, i64 %148
  store double %141, ptr %150, align 8
  br label %22
}

define i64 @evaluate_lanes(i64 %0) local_unnamed_addr #1 {
  %2 = alloca ptr, align 8
  %3 = alloca ptr, align 8
  %4 = inttoptr i64 %0 to ptr
  %5 = load i64, ptr %4, align 8, !noalias !9
  %6 = inttoptr i64 %5 to ptr
  %7 = getelementptr i8, ptr %4, i64 24
  %8 = load i64, ptr %7, align 8, !noalias !9
  %9 = getelementptr i8, ptr %4, i64 32
  %10 = load i64, ptr %9, align 8, !noalias !9
  %11 = inttoptr i64 %8 to ptr
  %12 = getelementptr i8, ptr %4, i64 48
  %13 = load i64, ptr %12, align 8, !noalias !9
  %14 = getelementptr i8, ptr %4, i64 56
  %15 = load i64, ptr %14, align 8, !noalias !9
  %16 = inttoptr i64 %13 to ptr
  %17 = getelementptr i8, ptr %4, i64 72
  %18 = load i64, ptr %17, align 8, !noalias !9
  %19 = inttoptr i64 %18 to ptr
  %20 = getelementptr i8, ptr %4, i64 96
  %21 = load i64, ptr %20, align 8, !noalias !9
  %22 = inttoptr i64 %21 to ptr
  %23 = getelementptr i8, ptr %4, i64 120
  %24 = load i64, ptr %23, align 8, !noalias !9
  %25 = getelementptr i8, ptr %4, i64 128
  %26 = load i64, ptr %25, align 8, !noalias !9
  %27 = getelementptr i8, ptr %4, i64 136
  %28 = load i64, ptr %27, align 8, !noalias !9
  %29 = inttoptr i64 %24 to ptr
  %30 = getelementptr i8, ptr %4, i64 144
  %31 = load i64, ptr %30, align 8, !noalias !9
  %32 = getelementptr i8, ptr %4, i64 152
  %33 = load i64, ptr %32, align 8, !noalias !9
  %34 = getelementptr i8, ptr %4, i64 160
  %35 = load i64, ptr %34, align 8, !noalias !9
  %36 = inttoptr i64 %31 to ptr
  %37 = getelementptr i8, ptr %4, i64 168
  %38 = load i64, ptr %37, align 8, !noalias !9
  %39 = getelementptr i8, ptr %4, i64 176
  %40 = load i64, ptr %39, align 8, !noalias !9
  %41 = inttoptr i64 %38 to ptr
  %42 = getelementptr i8, ptr %4, i64 192
  %43 = load i64, ptr %42, align 8, !noalias !9
  %44 = getelementptr i8, ptr %4, i64 200
  %45 = load i64, ptr %44, align 8, !noalias !9
  %46 = getelementptr i8, ptr %4, i64 208
  %47 = load i64, ptr %46, align 8, !noalias !9
  %48 = inttoptr i64 %43 to ptr
  %49 = getelementptr i8, ptr %4, i64 216
  %50 = load i64, ptr %49, align 8, !noalias !9
  %51 = inttoptr i64 %50 to ptr
  %52 = getelementptr i8, ptr %4, i64 240
  %53 = load i64, ptr %52, align 8, !noalias !9
  %54 = getelementptr i8, ptr %4, i64 248
  %55 = load i64, ptr %54, align 8, !noalias !9
  %56 = inttoptr i64 %53 to ptr
  %57 = getelementptr i8, ptr %4, i64 264
  %58 = load i64, ptr %57, align 8, !noalias !9
  %59 = getelementptr i8, ptr %4, i64 272
  %60 = load i64, ptr %59, align 8, !noalias !9
  %61 = inttoptr i64 %58 to ptr
  %62 = getelementptr i8, ptr %4, i64 288
  %63 = load i64, ptr %62, align 8, !noalias !9
  %64 = getelementptr i8, ptr %4, i64 296
  %65 = load i64, ptr %64, align 8, !noalias !9
  %66 = getelementptr i8, ptr %4, i64 304
  %67 = load i64, ptr %66, align 8, !noalias !9
  %68 = inttoptr i64 %63 to ptr
  %69 = getelementptr i8, ptr %4, i64 312
  %70 = load i64, ptr %69, align 8, !noalias !9
  %71 = getelementptr i8, ptr %4, i64 320
  %72 = load i64, ptr %71, align 8, !noalias !9
  %73 = getelementptr i8, ptr %4, i64 328
  %74 = load i64, ptr %73, align 8, !noalias !9
  %75 = inttoptr i64 %70 to ptr
  %76 = getelementptr i8, ptr %4, i64 336
  %77 = load i64, ptr %76, align 8, !noalias !9
  %78 = getelementptr i8, ptr %4, i64 344
  %79 = load i64, ptr %78, align 8, !noalias !9
  %80 = inttoptr i64 %77 to ptr
  %81 = getelementptr i8, ptr %4, i64 360
  %82 = load i64, ptr %81, align 8, !noalias !9
  %83 = getelementptr i8, ptr %4, i64 368
  %84 = load i64, ptr %83, align 8, !noalias !9
  %85 = inttoptr i64 %82 to ptr
  %86 = getelementptr i8, ptr %6, i64 8
  %87 = load i64, ptr %86, align 8, !noalias !9
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
  %107 = getelementptr i8, ptr %6, i64 40
  %108 = load i64, ptr %107, align 8, !noalias !9
  %109 = inttoptr i64 %108 to ptr
  call void %109(ptr %19, ptr %22) #1, !noalias !9
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
  %128 = load double, ptr %127, align 8, !noalias !9
  %129 = insertelement <8 x double> poison, double %128, i64 0
  %130 = shufflevector <8 x double> %129, <8 x double> poison, <8 x i32> zeroinitializer
  store ptr null, ptr %2, align 8, !noalias !13
  store ptr null, ptr %3, align 8, !noalias !13
  store <8 x double> %130, ptr %11, align 8, !noalias !13
  %131 = icmp sgt i64 %26, 0
  br i1 %131, label %132, label %134

132:                                              ; preds = %123
  store ptr null, ptr %2, align 8, !noalias !13
  %133 = call fastcc i32 @_set_inputs(ptr nonnull %2, ptr nonnull %11, i64 %10, ptr %16, i64 %15, ptr %29, i64 %26, i64 %28, ptr %36, i64 %33, i64 %35, ptr %41, i64 %40, ptr %48, i64 %45, i64 %47) #1
  switch i32 %133, label %250 [
    i32 -2, label %134
    i32 0, label %134
  ], !prof !17

134:                                              ; preds = %132, %132, %123
  %135 = load i64, ptr %6, align 8, !noalias !13
  %136 = inttoptr i64 %135 to ptr
  %137 = call i32 %136(ptr nonnull %11, ptr %56, ptr %16, ptr %22, ptr %61) #1, !noalias !13
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
  %153 = load double, ptr %152, align 8, !noalias !9
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
  %190 = load i64, ptr %189, align 8, !noalias !18
  %191 = inttoptr i64 %180 to ptr
  store atomic i64 %190, ptr %191 unordered, align 8, !noalias !18
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
  %213 = load i64, ptr %212, align 8, !noalias !22
  %214 = inttoptr i64 %203 to ptr
  store atomic i64 %213, ptr %214 unordered, align 8, !noalias !22
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
  %224 = load i64, ptr %51, align 8, !noalias !9
  %225 = getelementptr i8, ptr %51, i64 16
  %226 = load i64, ptr %225, align 8, !noalias !9
  %227 = mul nsw i64 %223, %226
  %228 = getelementptr i8, ptr %51, i64 24
  %229 = load i64, ptr %228, align 8, !noalias !9
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
  %240 = load i64, ptr %239, align 8, !noalias !9
  %241 = mul nsw i64 %238, %240
  %242 = add nsw i64 %233, %241
  %243 = inttoptr i64 %242 to ptr
  %244 = load double, ptr %243, align 8, !noalias !9
  %245 = add nsw i64 %238, %116
  %246 = icmp slt i64 %245, 0
  %247 = select i1 %246, i64 %55, i64 0
  %248 = getelementptr double, ptr %56, i64 %245
  %249 = getelementptr double, ptr %248, i64 %247
  store double %244, ptr %249, align 8, !noalias !9
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
  %266 = load double, ptr %265, align 8, !noalias !9
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
  store double %267, ptr %276, align 8, !noalias !9
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

!0 = !{!1, !3}
!1 = distinct !{!1, !2}
!2 = distinct !{!2}
!3 = distinct !{!3, !2}
!4 = !{!"branch_weights", i32 1, i32 99}
!5 = !{!6, !1, !3}
!6 = distinct !{!6, !7}
!7 = distinct !{!7}
!8 = !{!"branch_weights", i32 99, i32 1}
!9 = !{!10, !12}
!10 = distinct !{!10, !11}
!11 = distinct !{!11}
!12 = distinct !{!12, !11}
!13 = !{!14, !16, !10, !12}
!14 = distinct !{!14, !15}
!15 = distinct !{!15}
!16 = distinct !{!16, !15}
!17 = !{!"branch_weights", i32 1, i32 49, i32 49}
!18 = !{!19, !21, !10, !12}
!19 = distinct !{!19, !20}
!20 = distinct !{!20}
!21 = distinct !{!21, !20}
!22 = !{!23, !25, !10, !12}
!23 = distinct !{!23, !24}
!24 = distinct !{!24}
!25 = distinct !{!25, !24}
