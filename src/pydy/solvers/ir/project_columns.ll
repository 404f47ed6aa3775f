; sources 3d957ccaa6225305d7e25a591b75ffd92f9fbbef951e3bf22a835e4be6740144
; Made by tools/solvers_ir.py with numba 0.68.1, llvmlite 0.50.0.

declare double @llvm.fabs.f64(double) #0

declare double @sqrt(double) local_unnamed_addr #1

define internal fastcc i32 @_move(ptr noalias %0, ptr %1, ptr %2, ptr %3, ptr %4, ptr %5, i64 %6) unnamed_addr #2 {
  %8 = getelementptr i8, ptr %3, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = inttoptr i64 %9 to ptr
  %11 = inttoptr i64 %6 to ptr
  %12 = call i32 %10(ptr %1, ptr %11, ptr %2, ptr %4, ptr %5)
  store i32 %12, ptr %0, align 4
  ret i32 0
}

define internal fastcc i32 @_divide_rows(ptr noalias %0, ptr %1, i64 %2, i64 %3, ptr %4, i64 %5, i64 %6) unnamed_addr {
  %8 = call i64 @llvm.smax.i64(i64 %2, i64 0)
  br label %9

9:                                                ; preds = %13, %7
  %10 = phi i64 [ 0, %7 ], [ %35, %13 ]
  %11 = phi i64 [ %8, %7 ], [ %34, %13 ]
  %12 = icmp sgt i64 %11, 0
  br i1 %12, label %33, label %32

13:                                               ; preds = %33, %22
  %14 = phi i64 [ 0, %33 ], [ %39, %22 ]
  %15 = phi i64 [ %36, %33 ], [ %38, %22 ]
  %16 = icmp sgt i64 %15, 0
  br i1 %16, label %37, label %9

17:                                               ; preds = %37, %51
  %18 = phi i64 [ 0, %37 ], [ %53, %51 ]
  %19 = phi i64 [ %50, %37 ], [ %52, %51 ]
  %20 = phi double [ %49, %37 ], [ %68, %51 ]
  %21 = icmp sgt i64 %19, 0
  br i1 %21, label %51, label %22

22:                                               ; preds = %17
  %23 = select i1 %43, i64 %5, i64 0
  %24 = add i64 %14, %23
  %25 = select i1 %43, i64 %6, i64 0
  %26 = mul i64 %24, %6
  %27 = getelementptr double, ptr %4, i64 %26
  %28 = getelementptr double, ptr %27, i64 %14
  %29 = getelementptr double, ptr %28, i64 %25
  %30 = load double, ptr %29, align 8
  %31 = fdiv double %20, %30
  store double %31, ptr %48, align 8
  br label %13

32:                                               ; preds = %9
  store ptr null, ptr %0, align 8
  ret i32 0

33:                                               ; preds = %9
  %34 = add nsw i64 %11, -1
  %35 = add i64 %10, 1
  %36 = call i64 @llvm.smax.i64(i64 %5, i64 0)
  br label %13

37:                                               ; preds = %13
  %38 = add nsw i64 %15, -1
  %39 = add i64 %14, 1
  %40 = icmp slt i64 %10, 0
  %41 = select i1 %40, i64 %2, i64 0
  %42 = add i64 %10, %41
  %43 = icmp slt i64 %14, 0
  %44 = select i1 %43, i64 %3, i64 0
  %45 = mul i64 %42, %3
  %46 = getelementptr double, ptr %1, i64 %45
  %47 = getelementptr double, ptr %46, i64 %14
  %48 = getelementptr double, ptr %47, i64 %44
  %49 = load double, ptr %48, align 8
  %50 = call i64 @llvm.smax.i64(i64 %14, i64 0)
  br label %17

51:                                               ; preds = %17
  %52 = add nsw i64 %19, -1
  %53 = add i64 %18, 1
  %54 = select i1 %43, i64 %5, i64 0
  %55 = add i64 %14, %54
  %56 = icmp slt i64 %18, 0
  %57 = select i1 %56, i64 %6, i64 0
  %58 = mul i64 %55, %6
  %59 = getelementptr double, ptr %4, i64 %58
  %60 = getelementptr double, ptr %59, i64 %18
  %61 = getelementptr double, ptr %60, i64 %57
  %62 = load double, ptr %61, align 8
  %63 = select i1 %56, i64 %3, i64 0
  %64 = getelementptr double, ptr %46, i64 %18
  %65 = getelementptr double, ptr %64, i64 %63
  %66 = load double, ptr %65, align 8
  %67 = fmul double %62, %66
  %68 = fsub double %20, %67
  br label %17
}

define internal fastcc i32 @_minimum_norm(ptr noalias %0, ptr %1, i64 %2, i64 %3, ptr %4, i64 %5, ptr %6, i64 %7, ptr %8, i64 %9, ptr %10, i64 %11, ptr %12, i64 %13, ptr %14, i64 %15) unnamed_addr {
  %17 = call i64 @llvm.smax.i64(i64 %3, i64 0)
  br label %18

18:                                               ; preds = %16, %111
  %19 = phi i64 [ 0, %16 ], [ %113, %111 ]
  %20 = phi i64 [ %17, %16 ], [ %112, %111 ]
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %111, label %22

22:                                               ; preds = %18
  %23 = call i64 @llvm.smax.i64(i64 %2, i64 0)
  br label %24

24:                                               ; preds = %22, %47
  %25 = phi i64 [ 0, %22 ], [ %120, %47 ]
  %26 = phi i64 [ %23, %22 ], [ %119, %47 ]
  %27 = icmp sgt i64 %26, 0
  br i1 %27, label %118, label %48

28:                                               ; preds = %118, %134
  %29 = phi i64 [ 0, %118 ], [ %136, %134 ]
  %30 = phi i64 [ %17, %118 ], [ %135, %134 ]
  %31 = phi double [ 0.000000e+00, %118 ], [ %147, %134 ]
  %32 = icmp sgt i64 %30, 0
  br i1 %32, label %134, label %33

33:                                               ; preds = %28
  %34 = fcmp ogt double %31, 0.000000e+00
  br i1 %34, label %35, label %47

35:                                               ; preds = %33
  %36 = call double @sqrt(double %31)
  store double %36, ptr %130, align 8
  %37 = fdiv double 1.000000e+00, %36
  store double %37, ptr %124, align 8
  %38 = select i1 %121, i64 %7, i64 0
  %39 = getelementptr double, ptr %6, i64 %25
  %40 = getelementptr double, ptr %39, i64 %38
  %41 = load double, ptr %40, align 8
  %42 = fmul double %41, %37
  store double %42, ptr %40, align 8
  br label %43

43:                                               ; preds = %35, %148
  %44 = phi i64 [ 0, %35 ], [ %150, %148 ]
  %45 = phi i64 [ %17, %35 ], [ %149, %148 ]
  %46 = icmp sgt i64 %45, 0
  br i1 %46, label %148, label %47

47:                                               ; preds = %43, %33
  br label %24

48:                                               ; preds = %24, %84
  %49 = phi i64 [ %163, %84 ], [ %23, %24 ]
  %50 = icmp sgt i64 %49, 0
  br i1 %50, label %162, label %105

51:                                               ; preds = %162, %65
  %52 = phi i64 [ 0, %162 ], [ %166, %65 ]
  %53 = phi i64 [ %23, %162 ], [ %165, %65 ]
  %54 = phi double [ 0x3BC79CA10C924224, %162 ], [ %66, %65 ]
  %55 = phi i64 [ -1, %162 ], [ %67, %65 ]
  %56 = icmp sgt i64 %53, 0
  br i1 %56, label %164, label %68

57:                                               ; preds = %164, %173
  %58 = phi i64 [ %175, %173 ], [ 0, %164 ]
  %59 = phi i64 [ %174, %173 ], [ %17, %164 ]
  %60 = phi double [ %186, %173 ], [ 0.000000e+00, %164 ]
  %61 = icmp sgt i64 %59, 0
  br i1 %61, label %173, label %62

62:                                               ; preds = %57
  %63 = fcmp ogt double %60, %54
  br i1 %63, label %64, label %65

64:                                               ; preds = %62
  br label %65

65:                                               ; preds = %64, %62, %164
  %66 = phi double [ %60, %64 ], [ %54, %62 ], [ %54, %164 ]
  %67 = phi i64 [ %52, %64 ], [ %55, %62 ], [ %55, %164 ]
  br label %51

68:                                               ; preds = %51
  %69 = icmp slt i64 %55, 0
  br i1 %69, label %105, label %70

70:                                               ; preds = %68
  %71 = getelementptr i64, ptr %10, i64 %55
  store i64 0, ptr %71, align 8
  %72 = call double @sqrt(double %54)
  %73 = getelementptr double, ptr %12, i64 %55
  %74 = load double, ptr %73, align 8
  %75 = fmul double %72, %74
  %76 = getelementptr double, ptr %14, i64 %55
  store double %75, ptr %76, align 8
  %77 = getelementptr double, ptr %6, i64 %55
  %78 = load double, ptr %77, align 8
  %79 = fdiv double %78, %72
  store double 0.000000e+00, ptr %77, align 8
  br label %80

80:                                               ; preds = %70, %187
  %81 = phi i64 [ 0, %70 ], [ %189, %187 ]
  %82 = phi i64 [ %17, %70 ], [ %188, %187 ]
  %83 = icmp sgt i64 %82, 0
  br i1 %83, label %187, label %84

84:                                               ; preds = %80, %104
  %85 = phi i64 [ %206, %104 ], [ 0, %80 ]
  %86 = phi i64 [ %205, %104 ], [ %23, %80 ]
  %87 = icmp sgt i64 %86, 0
  br i1 %87, label %204, label %48

88:                                               ; preds = %204, %213
  %89 = phi i64 [ %215, %213 ], [ 0, %204 ]
  %90 = phi i64 [ %214, %213 ], [ %17, %204 ]
  %91 = phi double [ %231, %213 ], [ 0.000000e+00, %204 ]
  %92 = icmp sgt i64 %90, 0
  br i1 %92, label %213, label %93

93:                                               ; preds = %88
  %94 = select i1 %207, i64 %7, i64 0
  %95 = getelementptr double, ptr %6, i64 %85
  %96 = getelementptr double, ptr %95, i64 %94
  %97 = load double, ptr %96, align 8
  %98 = fmul double %91, %79
  %99 = fsub double %97, %98
  store double %99, ptr %96, align 8
  br label %100

100:                                              ; preds = %93, %232
  %101 = phi i64 [ 0, %93 ], [ %234, %232 ]
  %102 = phi i64 [ %17, %93 ], [ %233, %232 ]
  %103 = icmp sgt i64 %102, 0
  br i1 %103, label %232, label %104

104:                                              ; preds = %100, %204
  br label %84

105:                                              ; preds = %48, %68
  br label %106

106:                                              ; preds = %105, %251
  %107 = phi i64 [ 0, %105 ], [ %253, %251 ]
  %108 = phi i64 [ %23, %105 ], [ %252, %251 ]
  %109 = icmp sgt i64 %108, 0
  br i1 %109, label %251, label %110

110:                                              ; preds = %106
  store ptr null, ptr %0, align 8
  ret i32 0

111:                                              ; preds = %18
  %112 = add nsw i64 %20, -1
  %113 = add i64 %19, 1
  %114 = icmp slt i64 %19, 0
  %115 = select i1 %114, i64 %5, i64 0
  %116 = getelementptr double, ptr %4, i64 %19
  %117 = getelementptr double, ptr %116, i64 %115
  store double 0.000000e+00, ptr %117, align 8
  br label %18

118:                                              ; preds = %24
  %119 = add nsw i64 %26, -1
  %120 = add i64 %25, 1
  %121 = icmp slt i64 %25, 0
  %122 = select i1 %121, i64 %9, i64 0
  %123 = getelementptr double, ptr %8, i64 %25
  %124 = getelementptr double, ptr %123, i64 %122
  store double 1.000000e+00, ptr %124, align 8
  %125 = select i1 %121, i64 %11, i64 0
  %126 = getelementptr i64, ptr %10, i64 %25
  %127 = getelementptr i64, ptr %126, i64 %125
  store i64 1, ptr %127, align 8
  %128 = select i1 %121, i64 %13, i64 0
  %129 = getelementptr double, ptr %12, i64 %25
  %130 = getelementptr double, ptr %129, i64 %128
  store double 0.000000e+00, ptr %130, align 8
  %131 = select i1 %121, i64 %15, i64 0
  %132 = getelementptr double, ptr %14, i64 %25
  %133 = getelementptr double, ptr %132, i64 %131
  store double 0.000000e+00, ptr %133, align 8
  br label %28

134:                                              ; preds = %28
  %135 = add nsw i64 %30, -1
  %136 = add i64 %29, 1
  %137 = select i1 %121, i64 %2, i64 0
  %138 = add i64 %25, %137
  %139 = icmp slt i64 %29, 0
  %140 = select i1 %139, i64 %3, i64 0
  %141 = mul i64 %138, %3
  %142 = getelementptr double, ptr %1, i64 %141
  %143 = getelementptr double, ptr %142, i64 %29
  %144 = getelementptr double, ptr %143, i64 %140
  %145 = load double, ptr %144, align 8
  %146 = fmul double %145, %145
  %147 = fadd double %31, %146
  br label %28

148:                                              ; preds = %43
  %149 = add nsw i64 %45, -1
  %150 = add i64 %44, 1
  %151 = select i1 %121, i64 %2, i64 0
  %152 = add i64 %25, %151
  %153 = icmp slt i64 %44, 0
  %154 = select i1 %153, i64 %3, i64 0
  %155 = mul i64 %152, %3
  %156 = getelementptr double, ptr %1, i64 %155
  %157 = getelementptr double, ptr %156, i64 %44
  %158 = getelementptr double, ptr %157, i64 %154
  %159 = load double, ptr %158, align 8
  %160 = load double, ptr %124, align 8
  %161 = fmul double %159, %160
  store double %161, ptr %158, align 8
  br label %43

162:                                              ; preds = %48
  %163 = add nsw i64 %49, -1
  br label %51

164:                                              ; preds = %51
  %165 = add nsw i64 %53, -1
  %166 = add i64 %52, 1
  %167 = icmp slt i64 %52, 0
  %168 = select i1 %167, i64 %11, i64 0
  %169 = getelementptr i64, ptr %10, i64 %52
  %170 = getelementptr i64, ptr %169, i64 %168
  %171 = load i64, ptr %170, align 8
  %172 = icmp eq i64 %171, 1
  br i1 %172, label %57, label %65

173:                                              ; preds = %57
  %174 = add nsw i64 %59, -1
  %175 = add i64 %58, 1
  %176 = select i1 %167, i64 %2, i64 0
  %177 = add i64 %52, %176
  %178 = icmp slt i64 %58, 0
  %179 = select i1 %178, i64 %3, i64 0
  %180 = mul i64 %177, %3
  %181 = getelementptr double, ptr %1, i64 %180
  %182 = getelementptr double, ptr %181, i64 %58
  %183 = getelementptr double, ptr %182, i64 %179
  %184 = load double, ptr %183, align 8
  %185 = fmul double %184, %184
  %186 = fadd double %60, %185
  br label %57

187:                                              ; preds = %80
  %188 = add nsw i64 %82, -1
  %189 = add i64 %81, 1
  %190 = icmp slt i64 %81, 0
  %191 = select i1 %190, i64 %3, i64 0
  %192 = mul i64 %55, %3
  %193 = getelementptr double, ptr %1, i64 %192
  %194 = getelementptr double, ptr %193, i64 %81
  %195 = getelementptr double, ptr %194, i64 %191
  %196 = load double, ptr %195, align 8
  %197 = fdiv double %196, %72
  store double %197, ptr %195, align 8
  %198 = select i1 %190, i64 %5, i64 0
  %199 = getelementptr double, ptr %4, i64 %81
  %200 = getelementptr double, ptr %199, i64 %198
  %201 = load double, ptr %200, align 8
  %202 = fmul double %79, %197
  %203 = fadd double %201, %202
  store double %203, ptr %200, align 8
  br label %80

204:                                              ; preds = %84
  %205 = add nsw i64 %86, -1
  %206 = add i64 %85, 1
  %207 = icmp slt i64 %85, 0
  %208 = select i1 %207, i64 %11, i64 0
  %209 = getelementptr i64, ptr %10, i64 %85
  %210 = getelementptr i64, ptr %209, i64 %208
  %211 = load i64, ptr %210, align 8
  %212 = icmp eq i64 %211, 1
  br i1 %212, label %88, label %104

213:                                              ; preds = %88
  %214 = add nsw i64 %90, -1
  %215 = add i64 %89, 1
  %216 = select i1 %207, i64 %2, i64 0
  %217 = add i64 %85, %216
  %218 = icmp slt i64 %89, 0
  %219 = select i1 %218, i64 %3, i64 0
  %220 = mul i64 %217, %3
  %221 = getelementptr double, ptr %1, i64 %220
  %222 = getelementptr double, ptr %221, i64 %89
  %223 = getelementptr double, ptr %222, i64 %219
  %224 = load double, ptr %223, align 8
  %225 = mul i64 %55, %3
  %226 = getelementptr double, ptr %1, i64 %225
  %227 = getelementptr double, ptr %226, i64 %89
  %228 = getelementptr double, ptr %227, i64 %219
  %229 = load double, ptr %228, align 8
  %230 = fmul double %224, %229
  %231 = fadd double %91, %230
  br label %88

232:                                              ; preds = %100
  %233 = add nsw i64 %102, -1
  %234 = add i64 %101, 1
  %235 = select i1 %207, i64 %2, i64 0
  %236 = add i64 %85, %235
  %237 = icmp slt i64 %101, 0
  %238 = select i1 %237, i64 %3, i64 0
  %239 = mul i64 %236, %3
  %240 = getelementptr double, ptr %1, i64 %239
  %241 = getelementptr double, ptr %240, i64 %101
  %242 = getelementptr double, ptr %241, i64 %238
  %243 = load double, ptr %242, align 8
  %244 = mul i64 %55, %3
  %245 = getelementptr double, ptr %1, i64 %244
  %246 = getelementptr double, ptr %245, i64 %101
  %247 = getelementptr double, ptr %246, i64 %238
  %248 = load double, ptr %247, align 8
  %249 = fmul double %91, %248
  %250 = fsub double %243, %249
  store double %250, ptr %242, align 8
  br label %100

251:                                              ; preds = %106
  %252 = add nsw i64 %108, -1
  %253 = add i64 %107, 1
  %254 = icmp slt i64 %107, 0
  %255 = select i1 %254, i64 %7, i64 0
  %256 = getelementptr double, ptr %6, i64 %107
  %257 = getelementptr double, ptr %256, i64 %255
  %258 = load double, ptr %257, align 8
  %259 = select i1 %254, i64 %9, i64 0
  %260 = getelementptr double, ptr %8, i64 %107
  %261 = getelementptr double, ptr %260, i64 %259
  %262 = load double, ptr %261, align 8
  %263 = fdiv double %258, %262
  store double %263, ptr %257, align 8
  br label %106
}

define internal fastcc i32 @_divide_transposed(ptr noalias %0, ptr %1, i64 %2, i64 %3, ptr %4, i64 %5) unnamed_addr {
  %7 = icmp ugt i64 %2, -9223372036854775808
  %8 = select i1 %7, i64 0, i64 %2
  br label %9

9:                                                ; preds = %6, %19
  %10 = phi i64 [ %2, %6 ], [ %12, %19 ]
  %11 = phi i64 [ %8, %6 ], [ %31, %19 ]
  %12 = add i64 %10, -1
  %13 = icmp sgt i64 %11, 0
  br i1 %13, label %30, label %29

14:                                               ; preds = %30, %39
  %15 = phi i64 [ %10, %30 ], [ %41, %39 ]
  %16 = phi i64 [ %38, %30 ], [ %40, %39 ]
  %17 = phi double [ %36, %30 ], [ %56, %39 ]
  %18 = icmp sgt i64 %16, 0
  br i1 %18, label %39, label %19

19:                                               ; preds = %14
  %20 = select i1 %32, i64 %2, i64 0
  %21 = add i64 %12, %20
  %22 = select i1 %32, i64 %3, i64 0
  %23 = mul i64 %21, %3
  %24 = getelementptr double, ptr %1, i64 %23
  %25 = getelementptr double, ptr %24, i64 %12
  %26 = getelementptr double, ptr %25, i64 %22
  %27 = load double, ptr %26, align 8
  %28 = fdiv double %17, %27
  store double %28, ptr %35, align 8
  br label %9

29:                                               ; preds = %9
  store ptr null, ptr %0, align 8
  ret i32 0

30:                                               ; preds = %9
  %31 = add nsw i64 %11, -1
  %32 = icmp slt i64 %12, 0
  %33 = select i1 %32, i64 %5, i64 0
  %34 = getelementptr double, ptr %4, i64 %12
  %35 = getelementptr double, ptr %34, i64 %33
  %36 = load double, ptr %35, align 8
  %37 = sub i64 %2, %10
  %38 = call i64 @llvm.smax.i64(i64 %37, i64 0)
  br label %14

39:                                               ; preds = %14
  %40 = add nsw i64 %16, -1
  %41 = add i64 %15, 1
  %42 = icmp slt i64 %15, 0
  %43 = select i1 %42, i64 %2, i64 0
  %44 = add i64 %15, %43
  %45 = select i1 %32, i64 %3, i64 0
  %46 = mul i64 %44, %3
  %47 = getelementptr double, ptr %1, i64 %46
  %48 = getelementptr double, ptr %47, i64 %12
  %49 = getelementptr double, ptr %48, i64 %45
  %50 = load double, ptr %49, align 8
  %51 = select i1 %42, i64 %5, i64 0
  %52 = getelementptr double, ptr %4, i64 %15
  %53 = getelementptr double, ptr %52, i64 %51
  %54 = load double, ptr %53, align 8
  %55 = fmul double %50, %54
  %56 = fsub double %17, %55
  br label %14
}

declare { i64, i1 } @llvm.uadd.with.overflow.i64(i64, i64) #0

define i64 @project_columns(i64 %0, double %1, i64 %2) local_unnamed_addr #3 {
  %4 = alloca i32, align 4
  %5 = alloca ptr, align 8
  %6 = alloca ptr, align 8
  %7 = alloca ptr, align 8
  %8 = alloca ptr, align 8
  %9 = alloca i32, align 4
  %10 = alloca ptr, align 8
  %11 = alloca ptr, align 8
  %12 = alloca ptr, align 8
  store i32 0, ptr %4, align 4, !noalias !0
  store ptr null, ptr %5, align 8, !noalias !0
  store ptr null, ptr %6, align 8, !noalias !0
  store ptr null, ptr %7, align 8, !noalias !0
  store ptr null, ptr %8, align 8, !noalias !0
  store i32 0, ptr %9, align 4, !noalias !0
  store ptr null, ptr %10, align 8, !noalias !0
  store ptr null, ptr %11, align 8, !noalias !0
  store ptr null, ptr %12, align 8, !noalias !0
  %13 = inttoptr i64 %0 to ptr
  %14 = getelementptr i8, ptr %13, i64 144
  %15 = load i64, ptr %14, align 8, !noalias !0
  %16 = getelementptr i8, ptr %13, i64 168
  %17 = load i64, ptr %16, align 8, !noalias !0
  %18 = inttoptr i64 %17 to ptr
  %19 = getelementptr i8, ptr %13, i64 192
  %20 = load i64, ptr %19, align 8, !noalias !0
  %21 = inttoptr i64 %20 to ptr
  %22 = getelementptr i8, ptr %13, i64 648
  %23 = load i64, ptr %22, align 8, !noalias !0
  %24 = inttoptr i64 %23 to ptr
  %25 = getelementptr i8, ptr %13, i64 696
  %26 = load i64, ptr %25, align 8, !noalias !0
  %27 = getelementptr i8, ptr %13, i64 704
  %28 = load i64, ptr %27, align 8, !noalias !0
  %29 = inttoptr i64 %26 to ptr
  %30 = getelementptr i8, ptr %24, i64 72
  %31 = load i64, ptr %30, align 8, !noalias !0
  %32 = inttoptr i64 %31 to ptr
  %33 = load i64, ptr %32, align 8, !noalias !0
  %34 = inttoptr i64 %33 to ptr
  %35 = getelementptr i8, ptr %32, i64 24
  %36 = load i64, ptr %35, align 8, !noalias !0
  %37 = inttoptr i64 %36 to ptr
  %38 = getelementptr i8, ptr %32, i64 48
  %39 = load i64, ptr %38, align 8, !noalias !0
  %40 = getelementptr i8, ptr %32, i64 56
  %41 = load i64, ptr %40, align 8, !noalias !0
  %42 = inttoptr i64 %39 to ptr
  %43 = load i64, ptr %34, align 8, !noalias !0
  %44 = inttoptr i64 %43 to ptr
  %45 = call i64 %44(i64 %0, double %1, i64 %2) #3, !noalias !0
  %46 = icmp eq i64 %45, 0
  br i1 %46, label %48, label %47

47:                                               ; preds = %3
  br label %706

48:                                               ; preds = %3
  %49 = inttoptr i64 %15 to ptr
  %50 = getelementptr i8, ptr %24, i64 64
  %51 = load i64, ptr %50, align 8, !noalias !0
  %52 = inttoptr i64 %51 to ptr
  %53 = load i64, ptr %52, align 8, !noalias !0
  %54 = getelementptr i8, ptr %52, i64 8
  %55 = load i64, ptr %54, align 8, !noalias !0
  %56 = getelementptr i8, ptr %52, i64 16
  %57 = load i64, ptr %56, align 8, !noalias !0
  %58 = inttoptr i64 %53 to ptr
  %59 = getelementptr i8, ptr %52, i64 24
  %60 = load i64, ptr %59, align 8, !noalias !0
  %61 = getelementptr i8, ptr %52, i64 32
  %62 = load i64, ptr %61, align 8, !noalias !0
  %63 = getelementptr i8, ptr %52, i64 40
  %64 = load i64, ptr %63, align 8, !noalias !0
  %65 = inttoptr i64 %60 to ptr
  %66 = getelementptr i8, ptr %52, i64 48
  %67 = load i64, ptr %66, align 8, !noalias !0
  %68 = getelementptr i8, ptr %52, i64 56
  %69 = load i64, ptr %68, align 8, !noalias !0
  %70 = getelementptr i8, ptr %52, i64 64
  %71 = load i64, ptr %70, align 8, !noalias !0
  %72 = inttoptr i64 %67 to ptr
  %73 = getelementptr i8, ptr %52, i64 72
  %74 = load i64, ptr %73, align 8, !noalias !0
  %75 = getelementptr i8, ptr %52, i64 80
  %76 = load i64, ptr %75, align 8, !noalias !0
  %77 = getelementptr i8, ptr %52, i64 88
  %78 = load i64, ptr %77, align 8, !noalias !0
  %79 = inttoptr i64 %74 to ptr
  %80 = getelementptr i8, ptr %52, i64 96
  %81 = load i64, ptr %80, align 8, !noalias !0
  %82 = getelementptr i8, ptr %52, i64 104
  %83 = load i64, ptr %82, align 8, !noalias !0
  %84 = getelementptr i8, ptr %52, i64 112
  %85 = load i64, ptr %84, align 8, !noalias !0
  %86 = inttoptr i64 %81 to ptr
  %87 = getelementptr i8, ptr %52, i64 120
  %88 = load i64, ptr %87, align 8, !noalias !0
  %89 = getelementptr i8, ptr %52, i64 128
  %90 = load i64, ptr %89, align 8, !noalias !0
  %91 = inttoptr i64 %88 to ptr
  %92 = getelementptr i8, ptr %52, i64 144
  %93 = load i64, ptr %92, align 8, !noalias !0
  %94 = getelementptr i8, ptr %52, i64 152
  %95 = load i64, ptr %94, align 8, !noalias !0
  %96 = inttoptr i64 %93 to ptr
  %97 = getelementptr i8, ptr %52, i64 168
  %98 = load i64, ptr %97, align 8, !noalias !0
  %99 = getelementptr i8, ptr %52, i64 176
  %100 = load i64, ptr %99, align 8, !noalias !0
  %101 = inttoptr i64 %98 to ptr
  %102 = getelementptr i8, ptr %52, i64 192
  %103 = load i64, ptr %102, align 8, !noalias !0
  %104 = getelementptr i8, ptr %52, i64 200
  %105 = load i64, ptr %104, align 8, !noalias !0
  %106 = inttoptr i64 %103 to ptr
  %107 = getelementptr i8, ptr %52, i64 216
  %108 = load i64, ptr %107, align 8, !noalias !0
  %109 = getelementptr i8, ptr %52, i64 224
  %110 = load i64, ptr %109, align 8, !noalias !0
  %111 = inttoptr i64 %108 to ptr
  %112 = getelementptr i8, ptr %52, i64 240
  %113 = load i64, ptr %112, align 8, !noalias !0
  %114 = getelementptr i8, ptr %52, i64 248
  %115 = load i64, ptr %114, align 8, !noalias !0
  %116 = inttoptr i64 %113 to ptr
  %117 = getelementptr i8, ptr %24, i64 16
  %118 = load i64, ptr %117, align 8, !noalias !0
  %119 = getelementptr i8, ptr %24, i64 24
  %120 = load i64, ptr %119, align 8, !noalias !0
  %121 = getelementptr i8, ptr %24, i64 32
  %122 = load i64, ptr %121, align 8, !noalias !0
  %123 = getelementptr i8, ptr %24, i64 40
  %124 = load i64, ptr %123, align 8, !noalias !0
  %125 = getelementptr i8, ptr %34, i64 16
  %126 = load i64, ptr %125, align 8, !noalias !0
  %127 = getelementptr i8, ptr %49, i64 8
  %128 = load i64, ptr %127, align 8, !noalias !0
  %129 = call { i64, i1 } @llvm.uadd.with.overflow.i64(i64 %126, i64 1)
  %130 = extractvalue { i64, i1 } %129, 0
  %131 = extractvalue { i64, i1 } %129, 1
  br i1 %131, label %263, label %259, !prof !4

132:                                              ; preds = %136, %263
  %133 = phi i64 [ 0, %263 ], [ %301, %136 ]
  %134 = phi i64 [ %276, %263 ], [ %300, %136 ]
  %135 = icmp sgt i64 %134, 0
  br i1 %135, label %299, label %140

136:                                              ; preds = %299, %302
  %137 = phi i64 [ 0, %299 ], [ %304, %302 ]
  %138 = phi i64 [ %276, %299 ], [ %303, %302 ]
  %139 = icmp sgt i64 %138, 0
  br i1 %139, label %302, label %132

140:                                              ; preds = %132
  %141 = getelementptr i8, ptr %24, i64 48
  %142 = load i64, ptr %141, align 8, !noalias !0
  %143 = icmp eq i64 %142, 1
  br i1 %143, label %144, label %178

144:                                              ; preds = %140
  %145 = call i64 @llvm.smax.i64(i64 %55, i64 0)
  br label %146

146:                                              ; preds = %150, %144
  %147 = phi i64 [ 0, %144 ], [ %156, %150 ]
  %148 = phi i64 [ %145, %144 ], [ %155, %150 ]
  %149 = icmp sgt i64 %148, 0
  br i1 %149, label %154, label %316

150:                                              ; preds = %158, %154
  %151 = phi i64 [ 0, %154 ], [ %160, %158 ]
  %152 = phi i64 [ %157, %154 ], [ %159, %158 ]
  %153 = icmp sgt i64 %152, 0
  br i1 %153, label %158, label %146

154:                                              ; preds = %146
  %155 = add nsw i64 %148, -1
  %156 = add i64 %147, 1
  %157 = call i64 @llvm.smax.i64(i64 %57, i64 0)
  br label %150

158:                                              ; preds = %150
  %159 = add nsw i64 %152, -1
  %160 = add i64 %151, 1
  %161 = mul nsw i64 %147, %57
  %162 = add nsw i64 %275, %161
  %163 = add nsw i64 %162, %151
  %164 = icmp slt i64 %163, 0
  %165 = select i1 %164, i64 %28, i64 0
  %166 = getelementptr double, ptr %29, i64 %163
  %167 = getelementptr double, ptr %166, i64 %165
  %168 = load double, ptr %167, align 8, !noalias !5
  %169 = icmp slt i64 %147, 0
  %170 = select i1 %169, i64 %55, i64 0
  %171 = add i64 %147, %170
  %172 = icmp slt i64 %151, 0
  %173 = select i1 %172, i64 %57, i64 0
  %174 = mul i64 %171, %57
  %175 = getelementptr double, ptr %58, i64 %174
  %176 = getelementptr double, ptr %175, i64 %151
  %177 = getelementptr double, ptr %176, i64 %173
  store double %168, ptr %177, align 8, !noalias !5
  br label %150

178:                                              ; preds = %333, %318, %140
  %179 = icmp sgt i64 %118, 0
  br i1 %179, label %180, label %243

180:                                              ; preds = %178
  store i32 0, ptr %4, align 4, !noalias !0
  %181 = call fastcc i32 @_move(ptr nonnull %4, ptr %18, ptr %21, ptr nonnull %34, ptr %37, ptr %42, i64 %2) #3
  switch i32 %181, label %424 [
    i32 -2, label %421
    i32 0, label %421
  ], !prof !8

182:                                              ; preds = %421
  br label %706

183:                                              ; preds = %421
  %184 = call i64 @llvm.smax.i64(i64 %62, i64 0)
  br label %185

185:                                              ; preds = %189, %183
  %186 = phi i64 [ 0, %183 ], [ %195, %189 ]
  %187 = phi i64 [ %184, %183 ], [ %194, %189 ]
  %188 = icmp sgt i64 %187, 0
  br i1 %188, label %193, label %425

189:                                              ; preds = %197, %193
  %190 = phi i64 [ 0, %193 ], [ %199, %197 ]
  %191 = phi i64 [ %196, %193 ], [ %198, %197 ]
  %192 = icmp sgt i64 %191, 0
  br i1 %192, label %197, label %185

193:                                              ; preds = %185
  %194 = add nsw i64 %187, -1
  %195 = add i64 %186, 1
  %196 = call i64 @llvm.smax.i64(i64 %64, i64 0)
  br label %189

197:                                              ; preds = %189
  %198 = add nsw i64 %191, -1
  %199 = add i64 %190, 1
  %200 = mul nsw i64 %186, %64
  %201 = add nsw i64 %271, %200
  %202 = add nsw i64 %201, %190
  %203 = icmp slt i64 %202, 0
  %204 = select i1 %203, i64 %28, i64 0
  %205 = getelementptr double, ptr %29, i64 %202
  %206 = getelementptr double, ptr %205, i64 %204
  %207 = load double, ptr %206, align 8, !noalias !9
  %208 = icmp slt i64 %186, 0
  %209 = select i1 %208, i64 %62, i64 0
  %210 = add i64 %186, %209
  %211 = icmp slt i64 %190, 0
  %212 = select i1 %211, i64 %64, i64 0
  %213 = mul i64 %210, %64
  %214 = getelementptr double, ptr %65, i64 %213
  %215 = getelementptr double, ptr %214, i64 %190
  %216 = getelementptr double, ptr %215, i64 %212
  store double %207, ptr %216, align 8, !noalias !9
  br label %189

217:                                              ; preds = %425, %242
  %218 = phi i64 [ 0, %425 ], [ %429, %242 ]
  %219 = phi i64 [ %426, %425 ], [ %428, %242 ]
  %220 = icmp sgt i64 %219, 0
  br i1 %220, label %427, label %243

221:                                              ; preds = %225, %557
  %222 = phi i64 [ 0, %557 ], [ %562, %225 ]
  %223 = phi i64 [ %558, %557 ], [ %561, %225 ]
  %224 = icmp sgt i64 %223, 0
  br i1 %224, label %560, label %229

225:                                              ; preds = %560, %563
  %226 = phi i64 [ 0, %560 ], [ %565, %563 ]
  %227 = phi i64 [ %276, %560 ], [ %564, %563 ]
  %228 = icmp sgt i64 %227, 0
  br i1 %228, label %563, label %221

229:                                              ; preds = %221, %589
  %230 = phi i64 [ %598, %589 ], [ 0, %221 ]
  %231 = phi i64 [ %599, %589 ], [ %118, %221 ]
  %232 = phi double [ %597, %589 ], [ 0.000000e+00, %221 ]
  %233 = icmp sgt i64 %231, 0
  br i1 %233, label %589, label %234

234:                                              ; preds = %229
  %235 = fcmp ogt double %232, 0.000000e+00
  br i1 %235, label %236, label %242

236:                                              ; preds = %234
  store ptr null, ptr %8, align 8, !noalias !0
  %237 = call fastcc i32 @_minimum_norm(ptr nonnull %8, ptr %72, i64 %69, i64 %71, ptr %91, i64 %90, ptr %96, i64 %95, ptr %101, i64 %100, ptr %106, i64 %105, ptr %111, i64 %110, ptr %116, i64 %115) #3
  switch i32 %237, label %601 [
    i32 -2, label %600
    i32 0, label %600
  ], !prof !8

238:                                              ; preds = %600, %602
  %239 = phi i64 [ 0, %600 ], [ %604, %602 ]
  %240 = phi i64 [ %558, %600 ], [ %603, %602 ]
  %241 = icmp sgt i64 %240, 0
  br i1 %241, label %602, label %242

242:                                              ; preds = %238, %234
  br label %217

243:                                              ; preds = %217, %178
  %244 = icmp sgt i64 %120, 0
  br i1 %244, label %245, label %258

245:                                              ; preds = %243
  store i32 0, ptr %9, align 4, !noalias !0
  %246 = call fastcc i32 @_move(ptr nonnull %9, ptr %18, ptr %21, ptr nonnull %34, ptr %37, ptr %42, i64 %2) #3
  switch i32 %246, label %621 [
    i32 -2, label %618
    i32 0, label %618
  ], !prof !8

247:                                              ; preds = %618
  br label %706

248:                                              ; preds = %618
  %249 = call i64 @llvm.smax.i64(i64 %126, i64 0)
  br label %250

250:                                              ; preds = %254, %248
  %251 = phi i64 [ 0, %248 ], [ %624, %254 ]
  %252 = phi i64 [ %249, %248 ], [ %623, %254 ]
  %253 = icmp sgt i64 %252, 0
  br i1 %253, label %622, label %258

254:                                              ; preds = %687, %689
  %255 = phi i64 [ 0, %687 ], [ %691, %689 ]
  %256 = phi i64 [ %276, %687 ], [ %690, %689 ]
  %257 = icmp sgt i64 %256, 0
  br i1 %257, label %689, label %250

258:                                              ; preds = %250, %243
  br label %706

259:                                              ; preds = %48
  %260 = icmp ne i64 %128, -9223372036854775808
  %261 = icmp ne i64 %130, -1
  %262 = or i1 %260, %261
  br i1 %262, label %277, label %263, !prof !12

263:                                              ; preds = %290, %259, %48
  %264 = phi i64 [ %130, %48 ], [ %298, %290 ], [ 0, %259 ]
  %265 = shl nsw i64 %264, 3
  %266 = add nsw i64 %2, %265
  %267 = mul nsw i64 %264, %126
  %268 = inttoptr i64 %266 to ptr
  %269 = add nsw i64 %118, %120
  %270 = mul nsw i64 %118, %122
  %271 = add nsw i64 %269, %270
  %272 = mul nsw i64 %122, %124
  %273 = add nsw i64 %271, %272
  %274 = mul nsw i64 %120, %124
  %275 = add nsw i64 %273, %274
  %276 = call i64 @llvm.smax.i64(i64 %124, i64 0)
  br label %132

277:                                              ; preds = %259
  %278 = or i64 %128, %130
  %279 = icmp ult i64 %278, 4294967296
  br i1 %279, label %280, label %287

280:                                              ; preds = %277
  %281 = trunc nuw i64 %130 to i32
  %282 = trunc nuw i64 %128 to i32
  %283 = udiv i32 %282, %281
  %284 = urem i32 %282, %281
  %285 = zext i32 %283 to i64
  %286 = zext i32 %284 to i64
  br label %290

287:                                              ; preds = %277
  %288 = sdiv i64 %128, %130
  %289 = srem i64 %128, %130
  br label %290

290:                                              ; preds = %287, %280
  %291 = phi i64 [ %285, %280 ], [ %288, %287 ]
  %292 = phi i64 [ %286, %280 ], [ %289, %287 ]
  %293 = xor i64 %130, %292
  %294 = icmp slt i64 %293, 0
  %295 = icmp ne i64 %292, 0
  %296 = and i1 %295, %294
  %297 = sext i1 %296 to i64
  %298 = add i64 %291, %297
  br label %263

299:                                              ; preds = %132
  %300 = add nsw i64 %134, -1
  %301 = add i64 %133, 1
  br label %136

302:                                              ; preds = %136
  %303 = add nsw i64 %138, -1
  %304 = add i64 %137, 1
  %305 = icmp eq i64 %133, %137
  %306 = select i1 %305, double 1.000000e+00, double 0.000000e+00
  %307 = icmp slt i64 %133, 0
  %308 = select i1 %307, i64 %55, i64 0
  %309 = add i64 %133, %308
  %310 = icmp slt i64 %137, 0
  %311 = select i1 %310, i64 %57, i64 0
  %312 = mul i64 %309, %57
  %313 = getelementptr double, ptr %58, i64 %312
  %314 = getelementptr double, ptr %313, i64 %137
  %315 = getelementptr double, ptr %314, i64 %311
  store double %306, ptr %315, align 8, !noalias !0
  br label %136

316:                                              ; preds = %146
  %317 = call i64 @llvm.smax.i64(i64 %55, i64 0)
  br label %318

318:                                              ; preds = %345, %316
  %319 = phi i64 [ 0, %316 ], [ %359, %345 ]
  %320 = phi i64 [ %317, %316 ], [ %358, %345 ]
  %321 = icmp sgt i64 %320, 0
  br i1 %321, label %357, label %178

322:                                              ; preds = %370, %357
  %323 = phi i64 [ 0, %357 ], [ %372, %370 ]
  %324 = phi i64 [ %369, %357 ], [ %371, %370 ]
  %325 = phi double [ %368, %357 ], [ %379, %370 ]
  %326 = icmp sgt i64 %324, 0
  br i1 %326, label %370, label %327

327:                                              ; preds = %322
  %328 = sitofp i64 %55 to double
  %329 = fmul double %328, 4.000000e+00
  %330 = fmul double %329, 0x3CB0000000000000
  %331 = fmul double %330, %368
  %332 = fcmp ogt double %325, %331
  br i1 %332, label %341, label %333

333:                                              ; preds = %327, %337
  %334 = phi i64 [ %382, %337 ], [ 0, %327 ]
  %335 = phi i64 [ %381, %337 ], [ %317, %327 ]
  %336 = icmp sgt i64 %335, 0
  br i1 %336, label %380, label %178

337:                                              ; preds = %383, %380
  %338 = phi i64 [ 0, %380 ], [ %385, %383 ]
  %339 = phi i64 [ %317, %380 ], [ %384, %383 ]
  %340 = icmp sgt i64 %339, 0
  br i1 %340, label %383, label %333

341:                                              ; preds = %327
  %342 = call double @sqrt(double %325), !noalias !13
  store double %342, ptr %367, align 8, !noalias !13
  %343 = sub i64 %55, %359
  %344 = call i64 @llvm.smax.i64(i64 %343, i64 0)
  br label %345

345:                                              ; preds = %354, %341
  %346 = phi i64 [ %359, %341 ], [ %399, %354 ]
  %347 = phi i64 [ %344, %341 ], [ %398, %354 ]
  %348 = icmp sgt i64 %347, 0
  br i1 %348, label %397, label %318

349:                                              ; preds = %408, %397
  %350 = phi i64 [ 0, %397 ], [ %410, %408 ]
  %351 = phi i64 [ %369, %397 ], [ %409, %408 ]
  %352 = phi double [ %407, %397 ], [ %420, %408 ]
  %353 = icmp sgt i64 %351, 0
  br i1 %353, label %408, label %354

354:                                              ; preds = %349
  %355 = load double, ptr %367, align 8, !noalias !13
  %356 = fdiv double %352, %355
  store double %356, ptr %406, align 8, !noalias !13
  br label %345

357:                                              ; preds = %318
  %358 = add nsw i64 %320, -1
  %359 = add i64 %319, 1
  %360 = icmp slt i64 %319, 0
  %361 = select i1 %360, i64 %55, i64 0
  %362 = add i64 %319, %361
  %363 = select i1 %360, i64 %57, i64 0
  %364 = mul i64 %362, %57
  %365 = getelementptr double, ptr %58, i64 %364
  %366 = getelementptr double, ptr %365, i64 %319
  %367 = getelementptr double, ptr %366, i64 %363
  %368 = load double, ptr %367, align 8, !noalias !13
  %369 = call i64 @llvm.smax.i64(i64 %319, i64 0)
  br label %322

370:                                              ; preds = %322
  %371 = add nsw i64 %324, -1
  %372 = add i64 %323, 1
  %373 = icmp slt i64 %323, 0
  %374 = select i1 %373, i64 %57, i64 0
  %375 = getelementptr double, ptr %365, i64 %323
  %376 = getelementptr double, ptr %375, i64 %374
  %377 = load double, ptr %376, align 8, !noalias !13
  %378 = fmul double %377, %377
  %379 = fsub double %325, %378
  br label %322

380:                                              ; preds = %333
  %381 = add nsw i64 %335, -1
  %382 = add i64 %334, 1
  br label %337

383:                                              ; preds = %337
  %384 = add nsw i64 %339, -1
  %385 = add i64 %338, 1
  %386 = icmp eq i64 %334, %338
  %387 = select i1 %386, double 1.000000e+00, double 0.000000e+00
  %388 = icmp slt i64 %334, 0
  %389 = select i1 %388, i64 %55, i64 0
  %390 = add i64 %334, %389
  %391 = icmp slt i64 %338, 0
  %392 = select i1 %391, i64 %57, i64 0
  %393 = mul i64 %390, %57
  %394 = getelementptr double, ptr %58, i64 %393
  %395 = getelementptr double, ptr %394, i64 %338
  %396 = getelementptr double, ptr %395, i64 %392
  store double %387, ptr %396, align 8, !noalias !13
  br label %337

397:                                              ; preds = %345
  %398 = add nsw i64 %347, -1
  %399 = add i64 %346, 1
  %400 = icmp slt i64 %346, 0
  %401 = select i1 %400, i64 %55, i64 0
  %402 = add i64 %346, %401
  %403 = mul i64 %402, %57
  %404 = getelementptr double, ptr %58, i64 %403
  %405 = getelementptr double, ptr %404, i64 %319
  %406 = getelementptr double, ptr %405, i64 %363
  %407 = load double, ptr %406, align 8, !noalias !13
  br label %349

408:                                              ; preds = %349
  %409 = add nsw i64 %351, -1
  %410 = add i64 %350, 1
  %411 = icmp slt i64 %350, 0
  %412 = select i1 %411, i64 %57, i64 0
  %413 = getelementptr double, ptr %404, i64 %350
  %414 = getelementptr double, ptr %413, i64 %412
  %415 = load double, ptr %414, align 8, !noalias !13
  %416 = getelementptr double, ptr %365, i64 %350
  %417 = getelementptr double, ptr %416, i64 %412
  %418 = load double, ptr %417, align 8, !noalias !13
  %419 = fmul double %415, %418
  %420 = fsub double %352, %419
  br label %349

421:                                              ; preds = %180, %180
  %422 = load i32, ptr %4, align 4, !noalias !0
  %423 = icmp slt i32 %422, 0
  br i1 %423, label %182, label %183

424:                                              ; preds = %180
  br label %706

425:                                              ; preds = %185
  %426 = call i64 @llvm.smax.i64(i64 %126, i64 0)
  br label %217

427:                                              ; preds = %217
  %428 = add nsw i64 %219, -1
  %429 = add i64 %218, 1
  %430 = call i64 @llvm.smax.i64(i64 %69, i64 0)
  br label %431

431:                                              ; preds = %435, %427
  %432 = phi i64 [ 0, %427 ], [ %441, %435 ]
  %433 = phi i64 [ %430, %427 ], [ %440, %435 ]
  %434 = icmp sgt i64 %433, 0
  br i1 %434, label %439, label %463

435:                                              ; preds = %443, %439
  %436 = phi i64 [ 0, %439 ], [ %445, %443 ]
  %437 = phi i64 [ %442, %439 ], [ %444, %443 ]
  %438 = icmp sgt i64 %437, 0
  br i1 %438, label %443, label %431

439:                                              ; preds = %431
  %440 = add nsw i64 %433, -1
  %441 = add i64 %432, 1
  %442 = call i64 @llvm.smax.i64(i64 %71, i64 0)
  br label %435

443:                                              ; preds = %435
  %444 = add nsw i64 %437, -1
  %445 = add i64 %436, 1
  %446 = mul nsw i64 %432, %71
  %447 = add nsw i64 %269, %446
  %448 = add nsw i64 %447, %436
  %449 = icmp slt i64 %448, 0
  %450 = select i1 %449, i64 %28, i64 0
  %451 = getelementptr double, ptr %29, i64 %448
  %452 = getelementptr double, ptr %451, i64 %450
  %453 = load double, ptr %452, align 8, !noalias !16
  %454 = icmp slt i64 %432, 0
  %455 = select i1 %454, i64 %69, i64 0
  %456 = add i64 %432, %455
  %457 = icmp slt i64 %436, 0
  %458 = select i1 %457, i64 %71, i64 0
  %459 = mul i64 %456, %71
  %460 = getelementptr double, ptr %72, i64 %459
  %461 = getelementptr double, ptr %460, i64 %436
  %462 = getelementptr double, ptr %461, i64 %458
  store double %453, ptr %462, align 8, !noalias !16
  br label %435

463:                                              ; preds = %431
  %464 = call i64 @llvm.smax.i64(i64 %76, i64 0)
  br label %465

465:                                              ; preds = %469, %463
  %466 = phi i64 [ 0, %463 ], [ %490, %469 ]
  %467 = phi i64 [ %464, %463 ], [ %489, %469 ]
  %468 = icmp sgt i64 %467, 0
  br i1 %468, label %488, label %529

469:                                              ; preds = %488, %487
  %470 = phi i64 [ 0, %488 ], [ %494, %487 ]
  %471 = phi i64 [ %491, %488 ], [ %493, %487 ]
  %472 = icmp sgt i64 %471, 0
  br i1 %472, label %492, label %465

473:                                              ; preds = %504, %492
  %474 = phi i64 [ 0, %492 ], [ %506, %504 ]
  %475 = phi i64 [ %184, %492 ], [ %505, %504 ]
  %476 = phi double [ 0.000000e+00, %492 ], [ %528, %504 ]
  %477 = icmp sgt i64 %475, 0
  br i1 %477, label %504, label %478

478:                                              ; preds = %473
  %479 = load double, ptr %503, align 8, !noalias !19
  %480 = call double @llvm.fabs.f64(double %479)
  %481 = sitofp i64 %62 to double
  %482 = fmul double %481, 4.000000e+00
  %483 = fmul double %482, 0x3CB0000000000000
  %484 = fmul double %483, %476
  %485 = fcmp ugt double %480, %484
  br i1 %485, label %487, label %486

486:                                              ; preds = %478
  store double 0.000000e+00, ptr %503, align 8, !noalias !19
  br label %487

487:                                              ; preds = %486, %478
  br label %469

488:                                              ; preds = %465
  %489 = add nsw i64 %467, -1
  %490 = add i64 %466, 1
  %491 = call i64 @llvm.smax.i64(i64 %64, i64 0)
  br label %469

492:                                              ; preds = %469
  %493 = add nsw i64 %471, -1
  %494 = add i64 %470, 1
  %495 = icmp slt i64 %466, 0
  %496 = select i1 %495, i64 %76, i64 0
  %497 = add i64 %466, %496
  %498 = icmp slt i64 %470, 0
  %499 = select i1 %498, i64 %78, i64 0
  %500 = mul i64 %497, %78
  %501 = getelementptr double, ptr %79, i64 %500
  %502 = getelementptr double, ptr %501, i64 %470
  %503 = getelementptr double, ptr %502, i64 %499
  store double 0.000000e+00, ptr %503, align 8, !noalias !19
  br label %473

504:                                              ; preds = %473
  %505 = add nsw i64 %475, -1
  %506 = add i64 %474, 1
  %507 = select i1 %495, i64 %69, i64 0
  %508 = add i64 %466, %507
  %509 = icmp slt i64 %474, 0
  %510 = select i1 %509, i64 %71, i64 0
  %511 = mul i64 %508, %71
  %512 = getelementptr double, ptr %72, i64 %511
  %513 = getelementptr double, ptr %512, i64 %474
  %514 = getelementptr double, ptr %513, i64 %510
  %515 = load double, ptr %514, align 8, !noalias !19
  %516 = select i1 %509, i64 %62, i64 0
  %517 = add i64 %474, %516
  %518 = select i1 %498, i64 %64, i64 0
  %519 = mul i64 %517, %64
  %520 = getelementptr double, ptr %65, i64 %519
  %521 = getelementptr double, ptr %520, i64 %470
  %522 = getelementptr double, ptr %521, i64 %518
  %523 = load double, ptr %522, align 8, !noalias !19
  %524 = fmul double %515, %523
  %525 = load double, ptr %503, align 8, !noalias !19
  %526 = fadd double %525, %524
  store double %526, ptr %503, align 8, !noalias !19
  %527 = call double @llvm.fabs.f64(double %524)
  %528 = fadd double %476, %527
  br label %473

529:                                              ; preds = %465
  store ptr null, ptr %5, align 8, !noalias !0
  %530 = call fastcc i32 @_divide_rows(ptr nonnull %5, ptr %79, i64 %76, i64 %78, ptr %58, i64 %55, i64 %57) #3
  switch i32 %530, label %551 [
    i32 -2, label %531
    i32 0, label %531
  ], !prof !8

531:                                              ; preds = %529, %529
  br label %532

532:                                              ; preds = %536, %531
  %533 = phi i64 [ 0, %531 ], [ %538, %536 ]
  %534 = phi i64 [ %118, %531 ], [ %537, %536 ]
  %535 = icmp sgt i64 %534, 0
  br i1 %535, label %536, label %552

536:                                              ; preds = %532
  %537 = add nsw i64 %534, -1
  %538 = add i64 %533, 1
  %539 = mul nsw i64 %533, %126
  %540 = add nsw i64 %539, %218
  %541 = icmp slt i64 %540, 0
  %542 = select i1 %541, i64 %41, i64 0
  %543 = getelementptr double, ptr %42, i64 %540
  %544 = getelementptr double, ptr %543, i64 %542
  %545 = load double, ptr %544, align 8, !noalias !22
  %546 = fneg double %545
  %547 = icmp slt i64 %533, 0
  %548 = select i1 %547, i64 %95, i64 0
  %549 = getelementptr double, ptr %96, i64 %533
  %550 = getelementptr double, ptr %549, i64 %548
  store double %546, ptr %550, align 8, !noalias !22
  br label %532

551:                                              ; preds = %529
  br label %706

552:                                              ; preds = %532
  store ptr null, ptr %6, align 8, !noalias !0
  %553 = call fastcc i32 @_minimum_norm(ptr nonnull %6, ptr %79, i64 %76, i64 %78, ptr %91, i64 %90, ptr %96, i64 %95, ptr %101, i64 %100, ptr %106, i64 %105, ptr %111, i64 %110, ptr %116, i64 %115) #3
  switch i32 %553, label %556 [
    i32 -2, label %554
    i32 0, label %554
  ], !prof !8

554:                                              ; preds = %552, %552
  store ptr null, ptr %7, align 8, !noalias !0
  %555 = call fastcc i32 @_divide_transposed(ptr nonnull %7, ptr %58, i64 %55, i64 %57, ptr %91, i64 %90) #3
  switch i32 %555, label %559 [
    i32 -2, label %557
    i32 0, label %557
  ], !prof !8

556:                                              ; preds = %552
  br label %706

557:                                              ; preds = %554, %554
  %558 = call i64 @llvm.smax.i64(i64 %122, i64 0)
  br label %221

559:                                              ; preds = %554
  br label %706

560:                                              ; preds = %221
  %561 = add nsw i64 %223, -1
  %562 = add i64 %222, 1
  br label %225

563:                                              ; preds = %225
  %564 = add nsw i64 %227, -1
  %565 = add i64 %226, 1
  %566 = mul nsw i64 %222, %126
  %567 = add nsw i64 %566, %218
  %568 = icmp slt i64 %567, 0
  %569 = select i1 %568, i64 %267, i64 0
  %570 = getelementptr double, ptr %268, i64 %567
  %571 = getelementptr double, ptr %570, i64 %569
  %572 = load double, ptr %571, align 8, !noalias !0
  %573 = icmp slt i64 %222, 0
  %574 = select i1 %573, i64 %62, i64 0
  %575 = add i64 %222, %574
  %576 = icmp slt i64 %226, 0
  %577 = select i1 %576, i64 %64, i64 0
  %578 = mul i64 %575, %64
  %579 = getelementptr double, ptr %65, i64 %578
  %580 = getelementptr double, ptr %579, i64 %226
  %581 = getelementptr double, ptr %580, i64 %577
  %582 = load double, ptr %581, align 8, !noalias !0
  %583 = select i1 %576, i64 %90, i64 0
  %584 = getelementptr double, ptr %91, i64 %226
  %585 = getelementptr double, ptr %584, i64 %583
  %586 = load double, ptr %585, align 8, !noalias !0
  %587 = fmul double %582, %586
  %588 = fadd double %572, %587
  store double %588, ptr %571, align 8, !noalias !0
  br label %225

589:                                              ; preds = %229
  %590 = icmp slt i64 %230, 0
  %591 = select i1 %590, i64 %95, i64 0
  %592 = getelementptr double, ptr %96, i64 %230
  %593 = getelementptr double, ptr %592, i64 %591
  %594 = load double, ptr %593, align 8, !noalias !0
  %595 = call double @llvm.fabs.f64(double %594)
  %596 = fcmp ogt double %595, %232
  %597 = select i1 %596, double %595, double %232
  %598 = add i64 %230, 1
  %599 = add nsw i64 %231, -1
  br label %229

600:                                              ; preds = %236, %236
  br label %238

601:                                              ; preds = %236
  br label %706

602:                                              ; preds = %238
  %603 = add nsw i64 %240, -1
  %604 = add i64 %239, 1
  %605 = mul nsw i64 %239, %126
  %606 = add nsw i64 %605, %218
  %607 = icmp slt i64 %606, 0
  %608 = select i1 %607, i64 %267, i64 0
  %609 = getelementptr double, ptr %268, i64 %606
  %610 = getelementptr double, ptr %609, i64 %608
  %611 = load double, ptr %610, align 8, !noalias !0
  %612 = icmp slt i64 %239, 0
  %613 = select i1 %612, i64 %90, i64 0
  %614 = getelementptr double, ptr %91, i64 %239
  %615 = getelementptr double, ptr %614, i64 %613
  %616 = load double, ptr %615, align 8, !noalias !0
  %617 = fadd double %611, %616
  store double %617, ptr %610, align 8, !noalias !0
  br label %238

618:                                              ; preds = %245, %245
  %619 = load i32, ptr %9, align 4, !noalias !0
  %620 = icmp slt i32 %619, 0
  br i1 %620, label %247, label %248

621:                                              ; preds = %245
  br label %706

622:                                              ; preds = %250
  %623 = add nsw i64 %252, -1
  %624 = add i64 %251, 1
  %625 = call i64 @llvm.smax.i64(i64 %83, i64 0)
  br label %626

626:                                              ; preds = %630, %622
  %627 = phi i64 [ 0, %622 ], [ %636, %630 ]
  %628 = phi i64 [ %625, %622 ], [ %635, %630 ]
  %629 = icmp sgt i64 %628, 0
  br i1 %629, label %634, label %658

630:                                              ; preds = %638, %634
  %631 = phi i64 [ 0, %634 ], [ %640, %638 ]
  %632 = phi i64 [ %637, %634 ], [ %639, %638 ]
  %633 = icmp sgt i64 %632, 0
  br i1 %633, label %638, label %626

634:                                              ; preds = %626
  %635 = add nsw i64 %628, -1
  %636 = add i64 %627, 1
  %637 = call i64 @llvm.smax.i64(i64 %85, i64 0)
  br label %630

638:                                              ; preds = %630
  %639 = add nsw i64 %632, -1
  %640 = add i64 %631, 1
  %641 = mul nsw i64 %627, %85
  %642 = add nsw i64 %273, %641
  %643 = add nsw i64 %642, %631
  %644 = icmp slt i64 %643, 0
  %645 = select i1 %644, i64 %28, i64 0
  %646 = getelementptr double, ptr %29, i64 %643
  %647 = getelementptr double, ptr %646, i64 %645
  %648 = load double, ptr %647, align 8, !noalias !25
  %649 = icmp slt i64 %627, 0
  %650 = select i1 %649, i64 %83, i64 0
  %651 = add i64 %627, %650
  %652 = icmp slt i64 %631, 0
  %653 = select i1 %652, i64 %85, i64 0
  %654 = mul i64 %651, %85
  %655 = getelementptr double, ptr %86, i64 %654
  %656 = getelementptr double, ptr %655, i64 %631
  %657 = getelementptr double, ptr %656, i64 %653
  store double %648, ptr %657, align 8, !noalias !25
  br label %630

658:                                              ; preds = %626
  store ptr null, ptr %10, align 8, !noalias !0
  %659 = call fastcc i32 @_divide_rows(ptr nonnull %10, ptr %86, i64 %83, i64 %85, ptr %58, i64 %55, i64 %57) #3
  switch i32 %659, label %681 [
    i32 -2, label %660
    i32 0, label %660
  ], !prof !8

660:                                              ; preds = %658, %658
  br label %661

661:                                              ; preds = %665, %660
  %662 = phi i64 [ 0, %660 ], [ %667, %665 ]
  %663 = phi i64 [ %120, %660 ], [ %666, %665 ]
  %664 = icmp sgt i64 %663, 0
  br i1 %664, label %665, label %682

665:                                              ; preds = %661
  %666 = add nsw i64 %663, -1
  %667 = add i64 %662, 1
  %668 = add i64 %118, %662
  %669 = mul i64 %668, %126
  %670 = add nsw i64 %669, %251
  %671 = icmp slt i64 %670, 0
  %672 = select i1 %671, i64 %41, i64 0
  %673 = getelementptr double, ptr %42, i64 %670
  %674 = getelementptr double, ptr %673, i64 %672
  %675 = load double, ptr %674, align 8, !noalias !28
  %676 = fneg double %675
  %677 = icmp slt i64 %662, 0
  %678 = select i1 %677, i64 %95, i64 0
  %679 = getelementptr double, ptr %96, i64 %662
  %680 = getelementptr double, ptr %679, i64 %678
  store double %676, ptr %680, align 8, !noalias !28
  br label %661

681:                                              ; preds = %658
  br label %706

682:                                              ; preds = %661
  store ptr null, ptr %11, align 8, !noalias !0
  %683 = call fastcc i32 @_minimum_norm(ptr nonnull %11, ptr %86, i64 %83, i64 %85, ptr %91, i64 %90, ptr %96, i64 %95, ptr %101, i64 %100, ptr %106, i64 %105, ptr %111, i64 %110, ptr %116, i64 %115) #3
  switch i32 %683, label %686 [
    i32 -2, label %684
    i32 0, label %684
  ], !prof !8

684:                                              ; preds = %682, %682
  store ptr null, ptr %12, align 8, !noalias !0
  %685 = call fastcc i32 @_divide_transposed(ptr nonnull %12, ptr %58, i64 %55, i64 %57, ptr %91, i64 %90) #3
  switch i32 %685, label %688 [
    i32 -2, label %687
    i32 0, label %687
  ], !prof !8

686:                                              ; preds = %682
  br label %706

687:                                              ; preds = %684, %684
  br label %254

688:                                              ; preds = %684
  br label %706

689:                                              ; preds = %254
  %690 = add nsw i64 %256, -1
  %691 = add i64 %255, 1
  %692 = add nsw i64 %122, %255
  %693 = mul nsw i64 %692, %126
  %694 = add nsw i64 %693, %251
  %695 = icmp slt i64 %694, 0
  %696 = select i1 %695, i64 %267, i64 0
  %697 = getelementptr double, ptr %268, i64 %694
  %698 = getelementptr double, ptr %697, i64 %696
  %699 = load double, ptr %698, align 8, !noalias !0
  %700 = icmp slt i64 %255, 0
  %701 = select i1 %700, i64 %90, i64 0
  %702 = getelementptr double, ptr %91, i64 %255
  %703 = getelementptr double, ptr %702, i64 %701
  %704 = load double, ptr %703, align 8, !noalias !0
  %705 = fadd double %699, %704
  store double %705, ptr %698, align 8, !noalias !0
  br label %254

706:                                              ; preds = %688, %686, %681, %621, %601, %559, %556, %551, %424, %258, %247, %182, %47
  %707 = phi i64 [ %45, %47 ], [ 0, %258 ], [ 6, %247 ], [ 0, %621 ], [ 0, %559 ], [ 0, %424 ], [ 6, %182 ], [ 0, %601 ], [ 0, %688 ], [ 0, %686 ], [ 0, %681 ], [ 0, %551 ], [ 0, %556 ]
  ret i64 %707
}



declare i64 @llvm.smax.i64(i64, i64) #0

attributes #0 = { nounwind willreturn memory(none) }
attributes #1 = { nounwind memory(read) }
attributes #2 = { noinline }
attributes #3 = { nounwind }
attributes #4 = { nounwind willreturn }

!0 = !{!1, !3}
!1 = distinct !{!1, !2}
!2 = distinct !{!2}
!3 = distinct !{!3, !2}
!4 = !{!"branch_weights", i32 1, i32 99}
!5 = !{!6}
!6 = distinct !{!6, !7}
!7 = distinct !{!7}
!8 = !{!"branch_weights", i32 1, i32 49, i32 49}
!9 = !{!10}
!10 = distinct !{!10, !11}
!11 = distinct !{!11}
!12 = !{!"branch_weights", i32 99, i32 1}
!13 = !{!14}
!14 = distinct !{!14, !15}
!15 = distinct !{!15}
!16 = !{!17}
!17 = distinct !{!17, !18}
!18 = distinct !{!18}
!19 = !{!20}
!20 = distinct !{!20, !21}
!21 = distinct !{!21}
!22 = !{!23}
!23 = distinct !{!23, !24}
!24 = distinct !{!24}
!25 = !{!26}
!26 = distinct !{!26, !27}
!27 = distinct !{!27}
!28 = !{!29}
!29 = distinct !{!29, !30}
!30 = distinct !{!30}
