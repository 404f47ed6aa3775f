; sources ce6ebaa638f456272a11f40a60b266bee7fb0463269ce2e44fb9321ff76524c4
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define i32 @pydy_lu_4(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, i64 noundef %4, i32 noundef %5) #0 {
  %7 = mul i64 %4, %4
  %8 = icmp eq ptr %3, null
  %9 = icmp sgt i64 %4, 0
  %10 = shl i64 %4, 5
  %11 = add i64 %10, 32
  %12 = sitofp i64 %4 to double
  %13 = fmul double %12, 0x3CB0000000000000
  %14 = icmp sgt i64 %4, 0
  %15 = getelementptr double, ptr %2, i64 %4
  %16 = shl i64 %7, 5
  br label %18

17:                                               ; preds = %252
  ret i32 %253

18:                                               ; preds = %6, %252
  %19 = phi i64 [ 0, %6 ], [ %254, %252 ]
  %20 = phi i32 [ 0, %6 ], [ %253, %252 ]
  %21 = trunc nuw nsw i64 %19 to i32
  %22 = shl nuw nsw i32 1, %21
  %23 = and i32 %22, %5
  %24 = icmp eq i32 %23, 0
  br i1 %24, label %252, label %25

25:                                               ; preds = %18
  %26 = getelementptr inbounds double, ptr %0, i64 %19
  %27 = getelementptr inbounds i64, ptr %1, i64 %19
  br i1 %8, label %101, label %28

28:                                               ; preds = %25
  %29 = getelementptr inbounds double, ptr %3, i64 %19
  br i1 %9, label %31, label %252

30:                                               ; preds = %31
  br i1 %9, label %43, label %252

31:                                               ; preds = %28, %31
  %32 = phi i64 [ %41, %31 ], [ 0, %28 ]
  %33 = shl nsw i64 %32, 2
  %34 = getelementptr inbounds i64, ptr %27, i64 %33
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds double, ptr %29, i64 %33
  %37 = load double, ptr %36, align 8
  %38 = shl nsw i64 %35, 5
  %39 = getelementptr inbounds i8, ptr %29, i64 %38
  %40 = load double, ptr %39, align 8
  store double %40, ptr %36, align 8
  store double %37, ptr %39, align 8
  %41 = add nuw nsw i64 %32, 1
  %42 = icmp eq i64 %41, %4
  br i1 %42, label %30, label %31, !llvm.loop !3

43:                                               ; preds = %30, %52
  %44 = phi i64 [ %53, %52 ], [ 0, %30 ]
  %45 = icmp eq i64 %44, 0
  br i1 %45, label %52, label %46

46:                                               ; preds = %43
  %47 = mul nuw nsw i64 %44, %4
  %48 = shl nsw i64 %44, 5
  %49 = getelementptr inbounds i8, ptr %29, i64 %48
  %50 = load double, ptr %49, align 8
  br label %55

51:                                               ; preds = %52
  br i1 %9, label %69, label %252

52:                                               ; preds = %55, %43
  %53 = add nuw nsw i64 %44, 1
  %54 = icmp eq i64 %53, %4
  br i1 %54, label %51, label %43, !llvm.loop !7

55:                                               ; preds = %55, %46
  %56 = phi double [ %50, %46 ], [ %66, %55 ]
  %57 = phi i64 [ 0, %46 ], [ %67, %55 ]
  %58 = add nuw nsw i64 %57, %47
  %59 = shl nsw i64 %58, 5
  %60 = getelementptr inbounds i8, ptr %26, i64 %59
  %61 = load double, ptr %60, align 8
  %62 = fneg double %61
  %63 = shl nsw i64 %57, 5
  %64 = getelementptr inbounds i8, ptr %29, i64 %63
  %65 = load double, ptr %64, align 8
  %66 = tail call double @llvm.fma.f64(double %62, double %65, double %56)
  store double %66, ptr %49, align 8
  %67 = add nuw nsw i64 %57, 1
  %68 = icmp eq i64 %67, %44
  br i1 %68, label %52, label %55, !llvm.loop !8

69:                                               ; preds = %51, %78
  %70 = phi i64 [ %71, %78 ], [ %4, %51 ]
  %71 = add nsw i64 %70, -1
  %72 = icmp slt i64 %70, %4
  br i1 %72, label %73, label %78

73:                                               ; preds = %69
  %74 = mul nsw i64 %71, %4
  %75 = shl nsw i64 %71, 5
  %76 = getelementptr inbounds i8, ptr %29, i64 %75
  %77 = load double, ptr %76, align 8
  br label %87

78:                                               ; preds = %87, %69
  %79 = mul i64 %71, %11
  %80 = getelementptr inbounds i8, ptr %26, i64 %79
  %81 = load double, ptr %80, align 8
  %82 = shl nsw i64 %71, 5
  %83 = getelementptr inbounds i8, ptr %29, i64 %82
  %84 = load double, ptr %83, align 8
  %85 = fdiv double %84, %81
  store double %85, ptr %83, align 8
  %86 = icmp sgt i64 %70, 1
  br i1 %86, label %69, label %252, !llvm.loop !9

87:                                               ; preds = %87, %73
  %88 = phi double [ %77, %73 ], [ %98, %87 ]
  %89 = phi i64 [ %70, %73 ], [ %99, %87 ]
  %90 = add nsw i64 %89, %74
  %91 = shl nsw i64 %90, 5
  %92 = getelementptr inbounds i8, ptr %26, i64 %91
  %93 = load double, ptr %92, align 8
  %94 = fneg double %93
  %95 = shl nsw i64 %89, 5
  %96 = getelementptr inbounds i8, ptr %29, i64 %95
  %97 = load double, ptr %96, align 8
  %98 = tail call double @llvm.fma.f64(double %94, double %97, double %88)
  store double %98, ptr %76, align 8
  %99 = add nuw nsw i64 %89, 1
  %100 = icmp eq i64 %99, %4
  br i1 %100, label %78, label %87, !llvm.loop !10

101:                                              ; preds = %25
  br i1 %14, label %102, label %153

102:                                              ; preds = %101, %106
  %103 = phi i64 [ %111, %106 ], [ 0, %101 ]
  %104 = mul nuw nsw i64 %103, %4
  br label %113

105:                                              ; preds = %106
  br i1 %14, label %125, label %153

106:                                              ; preds = %113
  %107 = fcmp ogt double %122, 0.000000e+00
  %108 = fdiv double 1.000000e+00, %122
  %109 = select i1 %107, double %108, double 1.000000e+00
  %110 = getelementptr inbounds double, ptr %2, i64 %103
  store double %109, ptr %110, align 8
  %111 = add nuw nsw i64 %103, 1
  %112 = icmp eq i64 %111, %4
  br i1 %112, label %105, label %102, !llvm.loop !11

113:                                              ; preds = %113, %102
  %114 = phi double [ 0.000000e+00, %102 ], [ %122, %113 ]
  %115 = phi i64 [ 0, %102 ], [ %123, %113 ]
  %116 = add nuw nsw i64 %115, %104
  %117 = shl nsw i64 %116, 5
  %118 = getelementptr inbounds i8, ptr %26, i64 %117
  %119 = load double, ptr %118, align 8
  %120 = tail call double @llvm.fabs.f64(double %119)
  %121 = fcmp ogt double %120, %114
  %122 = select i1 %121, double %120, double %114
  %123 = add nuw nsw i64 %115, 1
  %124 = icmp eq i64 %123, %4
  br i1 %124, label %106, label %113, !llvm.loop !12

125:                                              ; preds = %105, %128
  %126 = phi i64 [ %133, %128 ], [ 0, %105 ]
  br label %135

127:                                              ; preds = %128
  br i1 %14, label %156, label %153

128:                                              ; preds = %135
  %129 = fcmp ogt double %148, 0.000000e+00
  %130 = fdiv double 1.000000e+00, %148
  %131 = select i1 %129, double %130, double 1.000000e+00
  %132 = getelementptr double, ptr %15, i64 %126
  store double %131, ptr %132, align 8
  %133 = add nuw nsw i64 %126, 1
  %134 = icmp eq i64 %133, %4
  br i1 %134, label %127, label %125, !llvm.loop !13

135:                                              ; preds = %135, %125
  %136 = phi i64 [ %149, %135 ], [ 0, %125 ]
  %137 = phi double [ %148, %135 ], [ 0.000000e+00, %125 ]
  %138 = mul nuw nsw i64 %136, %4
  %139 = add nuw nsw i64 %138, %126
  %140 = shl nsw i64 %139, 5
  %141 = getelementptr inbounds i8, ptr %26, i64 %140
  %142 = load double, ptr %141, align 8
  %143 = tail call double @llvm.fabs.f64(double %142)
  %144 = getelementptr inbounds double, ptr %2, i64 %136
  %145 = load double, ptr %144, align 8
  %146 = fmul double %143, %145
  %147 = fcmp ogt double %146, %137
  %148 = select i1 %147, double %146, double %137
  %149 = add nuw nsw i64 %136, 1
  %150 = icmp eq i64 %149, %4
  br i1 %150, label %128, label %135, !llvm.loop !14

151:                                              ; preds = %229, %217
  %152 = icmp eq i64 %168, %4
  br i1 %152, label %153, label %156, !llvm.loop !15

153:                                              ; preds = %151, %101, %105, %127
  %154 = phi i32 [ 0, %127 ], [ 0, %105 ], [ 0, %101 ], [ %177, %151 ]
  %155 = icmp eq i32 %154, 0
  br i1 %155, label %248, label %245

156:                                              ; preds = %127, %151
  %157 = phi i32 [ %177, %151 ], [ 0, %127 ]
  %158 = phi i64 [ %168, %151 ], [ 0, %127 ]
  %159 = mul nuw nsw i64 %158, %4
  %160 = add nuw nsw i64 %159, %158
  %161 = shl nsw i64 %160, 5
  %162 = getelementptr inbounds i8, ptr %26, i64 %161
  %163 = load double, ptr %162, align 8
  %164 = tail call double @llvm.fabs.f64(double %163)
  %165 = getelementptr inbounds double, ptr %2, i64 %158
  %166 = load double, ptr %165, align 8
  %167 = fmul double %164, %166
  %168 = add nuw nsw i64 %158, 1
  %169 = icmp slt i64 %168, %4
  br i1 %169, label %183, label %170

170:                                              ; preds = %183, %156
  %171 = phi i64 [ %158, %156 ], [ %197, %183 ]
  %172 = phi double [ %167, %156 ], [ %198, %183 ]
  %173 = getelementptr double, ptr %165, i64 %4
  %174 = load double, ptr %173, align 8
  %175 = fmul double %172, %174
  %176 = fcmp ugt double %175, %13
  %177 = select i1 %176, i32 %157, i32 1
  %178 = shl nsw i64 %158, 5
  %179 = getelementptr inbounds i8, ptr %27, i64 %178
  store i64 %171, ptr %179, align 8
  %180 = icmp eq i64 %171, %158
  br i1 %180, label %217, label %181

181:                                              ; preds = %170
  %182 = mul nsw i64 %171, %4
  br label %205

183:                                              ; preds = %156, %183
  %184 = phi i64 [ %199, %183 ], [ %168, %156 ]
  %185 = phi double [ %198, %183 ], [ %167, %156 ]
  %186 = phi i64 [ %197, %183 ], [ %158, %156 ]
  %187 = mul nuw nsw i64 %184, %4
  %188 = add nuw nsw i64 %187, %158
  %189 = shl nsw i64 %188, 5
  %190 = getelementptr inbounds i8, ptr %26, i64 %189
  %191 = load double, ptr %190, align 8
  %192 = tail call double @llvm.fabs.f64(double %191)
  %193 = getelementptr inbounds double, ptr %2, i64 %184
  %194 = load double, ptr %193, align 8
  %195 = fmul double %192, %194
  %196 = fcmp ogt double %195, %185
  %197 = select i1 %196, i64 %184, i64 %186
  %198 = select i1 %196, double %195, double %185
  %199 = add nuw nsw i64 %184, 1
  %200 = icmp slt i64 %199, %4
  br i1 %200, label %183, label %170, !llvm.loop !16

201:                                              ; preds = %205
  %202 = load double, ptr %165, align 8
  %203 = getelementptr inbounds double, ptr %2, i64 %171
  %204 = load double, ptr %203, align 8
  store double %204, ptr %165, align 8
  store double %202, ptr %203, align 8
  br label %217

205:                                              ; preds = %205, %181
  %206 = phi i64 [ 0, %181 ], [ %215, %205 ]
  %207 = add nuw nsw i64 %206, %159
  %208 = shl nsw i64 %207, 5
  %209 = getelementptr inbounds i8, ptr %26, i64 %208
  %210 = load double, ptr %209, align 8
  %211 = add nsw i64 %206, %182
  %212 = shl nsw i64 %211, 5
  %213 = getelementptr inbounds i8, ptr %26, i64 %212
  %214 = load double, ptr %213, align 8
  store double %214, ptr %209, align 8
  store double %210, ptr %213, align 8
  %215 = add nuw nsw i64 %206, 1
  %216 = icmp eq i64 %215, %4
  br i1 %216, label %201, label %205, !llvm.loop !17

217:                                              ; preds = %201, %170
  %218 = load double, ptr %162, align 8
  %219 = fdiv double 1.000000e+00, %218
  br i1 %169, label %220, label %151

220:                                              ; preds = %217, %229
  %221 = phi i64 [ %230, %229 ], [ %168, %217 ]
  %222 = mul nuw nsw i64 %221, %4
  %223 = add nuw nsw i64 %222, %158
  %224 = shl nsw i64 %223, 5
  %225 = getelementptr inbounds i8, ptr %26, i64 %224
  %226 = load double, ptr %225, align 8
  %227 = fmul double %219, %226
  store double %227, ptr %225, align 8
  %228 = fneg double %227
  br label %232

229:                                              ; preds = %232
  %230 = add nuw nsw i64 %221, 1
  %231 = icmp slt i64 %230, %4
  br i1 %231, label %220, label %151, !llvm.loop !18

232:                                              ; preds = %232, %220
  %233 = phi i64 [ %168, %220 ], [ %243, %232 ]
  %234 = add nuw nsw i64 %233, %159
  %235 = shl nsw i64 %234, 5
  %236 = getelementptr inbounds i8, ptr %26, i64 %235
  %237 = load double, ptr %236, align 8
  %238 = add nuw nsw i64 %233, %222
  %239 = shl nsw i64 %238, 5
  %240 = getelementptr inbounds i8, ptr %26, i64 %239
  %241 = load double, ptr %240, align 8
  %242 = tail call double @llvm.fma.f64(double %228, double %237, double %241)
  store double %242, ptr %240, align 8
  %243 = add nuw nsw i64 %233, 1
  %244 = icmp slt i64 %243, %4
  br i1 %244, label %232, label %229, !llvm.loop !19

245:                                              ; preds = %153
  %246 = getelementptr i8, ptr %26, i64 %16
  %247 = getelementptr i8, ptr %246, i64 -32
  store double 0x7FF8000000000000, ptr %247, align 8
  br label %248

248:                                              ; preds = %153, %245
  %249 = trunc nuw nsw i64 %19 to i32
  %250 = shl nuw nsw i32 %154, %249
  %251 = or i32 %250, %20
  br label %252

252:                                              ; preds = %78, %51, %30, %28, %18, %248
  %253 = phi i32 [ %251, %248 ], [ %20, %18 ], [ %20, %28 ], [ %20, %30 ], [ %20, %51 ], [ %20, %78 ]
  %254 = add nuw nsw i64 %19, 1
  %255 = icmp eq i64 %254, 4
  br i1 %255, label %17, label %18, !llvm.loop !20
}

define i32 @pydy_constrained_4(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, i64 noundef %4, i64 noundef %5, i32 noundef %6) #0 {
  %8 = icmp sgt i64 %4, 0
  %9 = icmp sgt i64 %5, 0
  %10 = icmp eq i64 %5, 0
  %11 = shl i64 %5, 5
  %12 = add i64 %11, 32
  %13 = sitofp i64 %5 to double
  %14 = fmul double %13, 0x3CB0000000000000
  %15 = shl i64 %5, 5
  %16 = add i64 %15, 32
  %17 = getelementptr double, ptr %2, i64 %5
  br label %19

18:                                               ; preds = %394
  ret i32 %395

19:                                               ; preds = %7, %394
  %20 = phi i64 [ 0, %7 ], [ %396, %394 ]
  %21 = phi i32 [ 0, %7 ], [ %395, %394 ]
  %22 = trunc nuw nsw i64 %20 to i32
  %23 = shl nuw nsw i32 1, %22
  %24 = and i32 %23, %6
  %25 = icmp eq i32 %24, 0
  br i1 %25, label %394, label %26

26:                                               ; preds = %19
  %27 = getelementptr inbounds double, ptr %0, i64 %20
  %28 = getelementptr inbounds i64, ptr %1, i64 %20
  %29 = getelementptr inbounds double, ptr %3, i64 %20
  br i1 %8, label %32, label %30

30:                                               ; preds = %32, %26
  %31 = phi double [ 0.000000e+00, %26 ], [ %39, %32 ]
  br i1 %9, label %45, label %42

32:                                               ; preds = %26, %32
  %33 = phi double [ %39, %32 ], [ 0.000000e+00, %26 ]
  %34 = phi i64 [ %40, %32 ], [ 0, %26 ]
  %35 = shl nsw i64 %34, 5
  %36 = getelementptr inbounds i8, ptr %29, i64 %35
  %37 = load double, ptr %36, align 8
  %38 = fmul double %37, 0.000000e+00
  %39 = fadd double %33, %38
  %40 = add nuw nsw i64 %34, 1
  %41 = icmp eq i64 %40, %4
  br i1 %41, label %30, label %32, !llvm.loop !21

42:                                               ; preds = %51, %30
  %43 = phi double [ 0.000000e+00, %30 ], [ %62, %51 ]
  %44 = getelementptr i8, ptr %27, i64 -32
  br i1 %10, label %85, label %65

45:                                               ; preds = %30, %51
  %46 = phi double [ %62, %51 ], [ 0.000000e+00, %30 ]
  %47 = phi i64 [ %52, %51 ], [ 0, %30 ]
  %48 = shl nsw i64 %47, 5
  %49 = getelementptr inbounds i8, ptr %28, i64 %48
  store i64 -1, ptr %49, align 8
  %50 = mul nuw nsw i64 %47, %5
  br label %54

51:                                               ; preds = %54
  %52 = add nuw nsw i64 %47, 1
  %53 = icmp eq i64 %52, %5
  br i1 %53, label %42, label %45, !llvm.loop !22

54:                                               ; preds = %54, %45
  %55 = phi double [ %46, %45 ], [ %62, %54 ]
  %56 = phi i64 [ 0, %45 ], [ %63, %54 ]
  %57 = add nuw nsw i64 %56, %50
  %58 = shl nsw i64 %57, 5
  %59 = getelementptr inbounds i8, ptr %27, i64 %58
  %60 = load double, ptr %59, align 8
  %61 = fmul double %60, 0.000000e+00
  %62 = fadd double %55, %61
  %63 = add nuw nsw i64 %56, 1
  %64 = icmp eq i64 %63, %5
  br i1 %64, label %51, label %54, !llvm.loop !23

65:                                               ; preds = %42, %82
  %66 = phi i64 [ %83, %82 ], [ %5, %42 ]
  %67 = phi i64 [ %81, %82 ], [ 0, %42 ]
  %68 = add i64 %66, 576460752303423487
  %69 = mul i64 %68, %5
  %70 = add i64 %69, %66
  %71 = shl i64 %70, 5
  %72 = getelementptr i8, ptr %44, i64 %71
  %73 = load double, ptr %72, align 8
  %74 = fcmp oeq double %73, 0xC770000000000000
  %75 = fcmp oeq double %73, 0xC780000000000000
  %76 = or i1 %74, %75
  br i1 %76, label %77, label %80

77:                                               ; preds = %65
  %78 = zext i1 %74 to i64
  %79 = add nsw i64 %67, %78
  store double 0.000000e+00, ptr %72, align 8
  br label %80

80:                                               ; preds = %77, %65
  %81 = phi i64 [ %79, %77 ], [ %67, %65 ]
  br i1 %76, label %82, label %85

82:                                               ; preds = %80
  %83 = add nsw i64 %66, -1
  %84 = icmp eq i64 %83, 0
  br i1 %84, label %85, label %65, !llvm.loop !24

85:                                               ; preds = %82, %80, %42
  %86 = phi i64 [ %5, %42 ], [ 0, %82 ], [ %66, %80 ]
  %87 = phi i64 [ 0, %42 ], [ %81, %80 ], [ %81, %82 ]
  %88 = icmp sgt i64 %86, 0
  br i1 %88, label %89, label %336

89:                                               ; preds = %85
  %90 = icmp slt i64 %86, %5
  br label %94

91:                                               ; preds = %123
  br i1 %88, label %92, label %336

92:                                               ; preds = %91
  %93 = icmp slt i64 %86, %5
  br label %128

94:                                               ; preds = %123, %89
  %95 = phi i64 [ 0, %89 ], [ %126, %123 ]
  %96 = mul i64 %95, %12
  %97 = getelementptr inbounds i8, ptr %27, i64 %96
  %98 = load double, ptr %97, align 8
  br i1 %90, label %102, label %99

99:                                               ; preds = %102, %94
  %100 = phi double [ 0.000000e+00, %94 ], [ %112, %102 ]
  %101 = fcmp ogt double %98, 0.000000e+00
  br i1 %101, label %115, label %118

102:                                              ; preds = %94, %102
  %103 = phi i64 [ %113, %102 ], [ %86, %94 ]
  %104 = phi double [ %112, %102 ], [ 0.000000e+00, %94 ]
  %105 = mul nsw i64 %103, %5
  %106 = add nsw i64 %105, %95
  %107 = shl nsw i64 %106, 5
  %108 = getelementptr inbounds i8, ptr %27, i64 %107
  %109 = load double, ptr %108, align 8
  %110 = tail call double @llvm.fabs.f64(double %109)
  %111 = fcmp ogt double %110, %104
  %112 = select i1 %111, double %110, double %104
  %113 = add nuw nsw i64 %103, 1
  %114 = icmp eq i64 %113, %5
  br i1 %114, label %99, label %102, !llvm.loop !25

115:                                              ; preds = %99
  %116 = tail call double @llvm.sqrt.f64(double %98)
  %117 = fdiv double 1.000000e+00, %116
  br label %123

118:                                              ; preds = %99
  %119 = fcmp ogt double %100, 0.000000e+00
  %120 = fmul double %100, 0x3CB0000000000000
  %121 = fdiv double 1.000000e+00, %120
  %122 = select i1 %119, double %121, double 0x4330000000000000
  br label %123

123:                                              ; preds = %118, %115
  %124 = phi double [ %117, %115 ], [ %122, %118 ]
  %125 = getelementptr inbounds double, ptr %2, i64 %95
  store double %124, ptr %125, align 8
  %126 = add nuw nsw i64 %95, 1
  %127 = icmp eq i64 %126, %86
  br i1 %127, label %91, label %94, !llvm.loop !26

128:                                              ; preds = %330, %92
  %129 = phi i64 [ %87, %92 ], [ %217, %330 ]
  %130 = phi i32 [ 0, %92 ], [ %332, %330 ]
  %131 = phi i64 [ 0, %92 ], [ %333, %330 ]
  %132 = phi double [ %43, %92 ], [ %331, %330 ]
  %133 = icmp ne i64 %129, 0
  %134 = and i1 %93, %133
  br i1 %134, label %135, label %145

135:                                              ; preds = %128, %158
  %136 = phi i64 [ %162, %158 ], [ %86, %128 ]
  %137 = phi i64 [ %161, %158 ], [ -1, %128 ]
  %138 = phi i64 [ %160, %158 ], [ -1, %128 ]
  %139 = phi double [ %159, %158 ], [ %13, %128 ]
  %140 = shl nsw i64 %136, 5
  %141 = getelementptr inbounds i8, ptr %28, i64 %140
  %142 = load i64, ptr %141, align 8
  %143 = icmp slt i64 %142, 0
  %144 = mul nsw i64 %136, %5
  br i1 %143, label %149, label %158

145:                                              ; preds = %158, %128
  %146 = phi i64 [ -1, %128 ], [ %160, %158 ]
  %147 = phi i64 [ -1, %128 ], [ %161, %158 ]
  %148 = icmp slt i64 %146, 0
  br i1 %148, label %184, label %212

149:                                              ; preds = %135, %178
  %150 = phi i64 [ %182, %178 ], [ 0, %135 ]
  %151 = phi i64 [ %181, %178 ], [ %137, %135 ]
  %152 = phi i64 [ %180, %178 ], [ %138, %135 ]
  %153 = phi double [ %179, %178 ], [ %139, %135 ]
  %154 = shl nsw i64 %150, 5
  %155 = getelementptr inbounds i8, ptr %28, i64 %154
  %156 = load i64, ptr %155, align 8
  %157 = icmp sgt i64 %156, -1
  br i1 %157, label %178, label %165

158:                                              ; preds = %178, %135
  %159 = phi double [ %139, %135 ], [ %179, %178 ]
  %160 = phi i64 [ %138, %135 ], [ %180, %178 ]
  %161 = phi i64 [ %137, %135 ], [ %181, %178 ]
  %162 = add nuw nsw i64 %136, 1
  %163 = icmp slt i64 %162, %5
  %164 = select i1 %133, i1 %163, i1 false
  br i1 %164, label %135, label %145, !llvm.loop !27

165:                                              ; preds = %149
  %166 = add nsw i64 %150, %144
  %167 = shl nsw i64 %166, 5
  %168 = getelementptr inbounds i8, ptr %27, i64 %167
  %169 = load double, ptr %168, align 8
  %170 = tail call double @llvm.fabs.f64(double %169)
  %171 = getelementptr inbounds double, ptr %2, i64 %150
  %172 = load double, ptr %171, align 8
  %173 = fmul double %170, %172
  %174 = fcmp ogt double %173, %153
  %175 = select i1 %174, double %173, double %153
  %176 = select i1 %174, i64 %136, i64 %152
  %177 = select i1 %174, i64 %150, i64 %151
  br label %178

178:                                              ; preds = %165, %149
  %179 = phi double [ %153, %149 ], [ %175, %165 ]
  %180 = phi i64 [ %152, %149 ], [ %176, %165 ]
  %181 = phi i64 [ %151, %149 ], [ %177, %165 ]
  %182 = add nuw nsw i64 %150, 1
  %183 = icmp eq i64 %182, %86
  br i1 %183, label %158, label %149, !llvm.loop !28

184:                                              ; preds = %145, %206
  %185 = phi i64 [ %210, %206 ], [ 0, %145 ]
  %186 = phi i64 [ %209, %206 ], [ %147, %145 ]
  %187 = phi i64 [ %208, %206 ], [ %146, %145 ]
  %188 = phi double [ %207, %206 ], [ %14, %145 ]
  %189 = shl nsw i64 %185, 5
  %190 = getelementptr inbounds i8, ptr %28, i64 %189
  %191 = load i64, ptr %190, align 8
  %192 = icmp sgt i64 %191, -1
  br i1 %192, label %206, label %193

193:                                              ; preds = %184
  %194 = mul i64 %185, %16
  %195 = getelementptr inbounds i8, ptr %27, i64 %194
  %196 = load double, ptr %195, align 8
  %197 = tail call double @llvm.fabs.f64(double %196)
  %198 = getelementptr inbounds double, ptr %2, i64 %185
  %199 = load double, ptr %198, align 8
  %200 = fmul double %197, %199
  %201 = fmul double %199, %200
  %202 = fcmp ogt double %201, %188
  %203 = select i1 %202, double %201, double %188
  %204 = select i1 %202, i64 %185, i64 %187
  %205 = select i1 %202, i64 %185, i64 %186
  br label %206

206:                                              ; preds = %193, %184
  %207 = phi double [ %188, %184 ], [ %203, %193 ]
  %208 = phi i64 [ %187, %184 ], [ %204, %193 ]
  %209 = phi i64 [ %186, %184 ], [ %205, %193 ]
  %210 = add nuw nsw i64 %185, 1
  %211 = icmp eq i64 %210, %86
  br i1 %211, label %214, label %184, !llvm.loop !29

212:                                              ; preds = %145
  %213 = add nsw i64 %129, -1
  br label %214

214:                                              ; preds = %206, %212
  %215 = phi i64 [ %146, %212 ], [ %208, %206 ]
  %216 = phi i64 [ %147, %212 ], [ %209, %206 ]
  %217 = phi i64 [ %213, %212 ], [ 0, %206 ]
  %218 = icmp slt i64 %215, 0
  br i1 %218, label %219, label %223

219:                                              ; preds = %214
  %220 = fadd double %31, %132
  %221 = fcmp oeq double %220, 0.000000e+00
  %222 = zext i1 %221 to i32
  br label %330

223:                                              ; preds = %214
  %224 = mul nsw i64 %215, %5
  %225 = add nsw i64 %224, %216
  %226 = shl nsw i64 %225, 5
  %227 = getelementptr inbounds i8, ptr %27, i64 %226
  %228 = load double, ptr %227, align 8
  %229 = fdiv double 1.000000e+00, %228
  br i1 %9, label %230, label %273

230:                                              ; preds = %223, %270
  %231 = phi i64 [ %271, %270 ], [ 0, %223 ]
  %232 = mul nuw nsw i64 %231, %5
  %233 = add nsw i64 %232, %216
  %234 = shl nsw i64 %233, 5
  %235 = getelementptr inbounds i8, ptr %27, i64 %234
  %236 = load double, ptr %235, align 8
  %237 = fmul double %229, %236
  %238 = icmp eq i64 %231, %215
  %239 = fcmp oeq double %237, 0.000000e+00
  %240 = select i1 %238, i1 true, i1 %239
  br i1 %240, label %270, label %241

241:                                              ; preds = %230
  %242 = fneg double %237
  br label %244

243:                                              ; preds = %244
  br i1 %8, label %257, label %270

244:                                              ; preds = %244, %241
  %245 = phi i64 [ 0, %241 ], [ %255, %244 ]
  %246 = add nuw nsw i64 %245, %224
  %247 = shl nsw i64 %246, 5
  %248 = getelementptr inbounds i8, ptr %27, i64 %247
  %249 = load double, ptr %248, align 8
  %250 = add nuw nsw i64 %245, %232
  %251 = shl nsw i64 %250, 5
  %252 = getelementptr inbounds i8, ptr %27, i64 %251
  %253 = load double, ptr %252, align 8
  %254 = tail call double @llvm.fma.f64(double %242, double %249, double %253)
  store double %254, ptr %252, align 8
  %255 = add nuw nsw i64 %245, 1
  %256 = icmp eq i64 %255, %5
  br i1 %256, label %243, label %244, !llvm.loop !30

257:                                              ; preds = %243, %257
  %258 = phi i64 [ %268, %257 ], [ 0, %243 ]
  %259 = add nuw nsw i64 %258, %215
  %260 = shl nsw i64 %259, 5
  %261 = getelementptr inbounds i8, ptr %29, i64 %260
  %262 = load double, ptr %261, align 8
  %263 = add nuw nsw i64 %258, %231
  %264 = shl nsw i64 %263, 5
  %265 = getelementptr inbounds i8, ptr %29, i64 %264
  %266 = load double, ptr %265, align 8
  %267 = tail call double @llvm.fma.f64(double %242, double %262, double %266)
  store double %267, ptr %265, align 8
  %268 = add nuw nsw i64 %258, %5
  %269 = icmp slt i64 %268, %4
  br i1 %269, label %257, label %270, !llvm.loop !31

270:                                              ; preds = %257, %243, %230
  %271 = add nuw nsw i64 %231, 1
  %272 = icmp eq i64 %271, %5
  br i1 %272, label %273, label %230, !llvm.loop !32

273:                                              ; preds = %270, %223
  %274 = shl nsw i64 %215, 5
  %275 = getelementptr inbounds i8, ptr %28, i64 %274
  store i64 %216, ptr %275, align 8
  %276 = icmp eq i64 %215, %216
  br i1 %276, label %330, label %277

277:                                              ; preds = %273
  %278 = mul nsw i64 %216, %5
  %279 = add nsw i64 %278, %215
  %280 = shl nsw i64 %279, 5
  %281 = getelementptr inbounds i8, ptr %27, i64 %280
  %282 = load double, ptr %281, align 8
  %283 = fdiv double 1.000000e+00, %282
  br i1 %9, label %284, label %327

284:                                              ; preds = %277, %324
  %285 = phi i64 [ %325, %324 ], [ 0, %277 ]
  %286 = mul nuw nsw i64 %285, %5
  %287 = add nuw nsw i64 %286, %215
  %288 = shl nsw i64 %287, 5
  %289 = getelementptr inbounds i8, ptr %27, i64 %288
  %290 = load double, ptr %289, align 8
  %291 = fmul double %283, %290
  %292 = icmp eq i64 %285, %216
  %293 = fcmp oeq double %291, 0.000000e+00
  %294 = select i1 %292, i1 true, i1 %293
  br i1 %294, label %324, label %295

295:                                              ; preds = %284
  %296 = fneg double %291
  br label %298

297:                                              ; preds = %298
  br i1 %8, label %311, label %324

298:                                              ; preds = %298, %295
  %299 = phi i64 [ 0, %295 ], [ %309, %298 ]
  %300 = add nsw i64 %299, %278
  %301 = shl nsw i64 %300, 5
  %302 = getelementptr inbounds i8, ptr %27, i64 %301
  %303 = load double, ptr %302, align 8
  %304 = add nuw nsw i64 %299, %286
  %305 = shl nsw i64 %304, 5
  %306 = getelementptr inbounds i8, ptr %27, i64 %305
  %307 = load double, ptr %306, align 8
  %308 = tail call double @llvm.fma.f64(double %296, double %303, double %307)
  store double %308, ptr %306, align 8
  %309 = add nuw nsw i64 %299, 1
  %310 = icmp eq i64 %309, %5
  br i1 %310, label %297, label %298, !llvm.loop !30

311:                                              ; preds = %297, %311
  %312 = phi i64 [ %322, %311 ], [ 0, %297 ]
  %313 = add nsw i64 %312, %216
  %314 = shl nsw i64 %313, 5
  %315 = getelementptr inbounds i8, ptr %29, i64 %314
  %316 = load double, ptr %315, align 8
  %317 = add nuw nsw i64 %312, %285
  %318 = shl nsw i64 %317, 5
  %319 = getelementptr inbounds i8, ptr %29, i64 %318
  %320 = load double, ptr %319, align 8
  %321 = tail call double @llvm.fma.f64(double %296, double %316, double %320)
  store double %321, ptr %319, align 8
  %322 = add nuw nsw i64 %312, %5
  %323 = icmp slt i64 %322, %4
  br i1 %323, label %311, label %324, !llvm.loop !31

324:                                              ; preds = %311, %297, %284
  %325 = add nuw nsw i64 %285, 1
  %326 = icmp eq i64 %325, %5
  br i1 %326, label %327, label %284, !llvm.loop !32

327:                                              ; preds = %324, %277
  %328 = shl nsw i64 %216, 5
  %329 = getelementptr inbounds i8, ptr %28, i64 %328
  store i64 %215, ptr %329, align 8
  br label %330

330:                                              ; preds = %327, %273, %219
  %331 = phi double [ 0x7FF8000000000000, %219 ], [ %132, %327 ], [ %132, %273 ]
  %332 = phi i32 [ %222, %219 ], [ %130, %327 ], [ %130, %273 ]
  %333 = add nuw nsw i64 %131, 1
  %334 = icmp eq i64 %333, %86
  %335 = select i1 %218, i1 true, i1 %334
  br i1 %335, label %336, label %128, !llvm.loop !33

336:                                              ; preds = %330, %85, %91
  %337 = phi double [ %43, %91 ], [ %43, %85 ], [ %331, %330 ]
  %338 = phi i32 [ 0, %91 ], [ 0, %85 ], [ %332, %330 ]
  br i1 %8, label %339, label %390

339:                                              ; preds = %336, %377
  %340 = phi i64 [ %378, %377 ], [ 0, %336 ]
  br i1 %9, label %343, label %341

341:                                              ; preds = %343, %339
  %342 = phi double [ %337, %339 ], [ %351, %343 ]
  br i1 %9, label %356, label %377

343:                                              ; preds = %339, %343
  %344 = phi i64 [ %353, %343 ], [ 0, %339 ]
  %345 = phi double [ %351, %343 ], [ %337, %339 ]
  %346 = add nsw i64 %344, %340
  %347 = shl nsw i64 %346, 5
  %348 = getelementptr inbounds i8, ptr %29, i64 %347
  %349 = load double, ptr %348, align 8
  %350 = fmul double %349, 0.000000e+00
  %351 = fadd double %345, %350
  %352 = getelementptr double, ptr %17, i64 %344
  store double 0.000000e+00, ptr %352, align 8
  %353 = add nuw nsw i64 %344, 1
  %354 = icmp eq i64 %353, %5
  br i1 %354, label %341, label %343, !llvm.loop !34

355:                                              ; preds = %374
  br i1 %9, label %380, label %377

356:                                              ; preds = %341, %374
  %357 = phi i64 [ %375, %374 ], [ 0, %341 ]
  %358 = shl nsw i64 %357, 5
  %359 = getelementptr inbounds i8, ptr %28, i64 %358
  %360 = load i64, ptr %359, align 8
  %361 = icmp sgt i64 %360, -1
  br i1 %361, label %362, label %374

362:                                              ; preds = %356
  %363 = add nsw i64 %357, %340
  %364 = shl nsw i64 %363, 5
  %365 = getelementptr inbounds i8, ptr %29, i64 %364
  %366 = load double, ptr %365, align 8
  %367 = mul nuw nsw i64 %357, %5
  %368 = add nuw nsw i64 %360, %367
  %369 = shl nsw i64 %368, 5
  %370 = getelementptr inbounds i8, ptr %27, i64 %369
  %371 = load double, ptr %370, align 8
  %372 = fdiv double %366, %371
  %373 = getelementptr double, ptr %17, i64 %360
  store double %372, ptr %373, align 8
  br label %374

374:                                              ; preds = %362, %356
  %375 = add nuw nsw i64 %357, 1
  %376 = icmp eq i64 %375, %5
  br i1 %376, label %355, label %356, !llvm.loop !35

377:                                              ; preds = %380, %341, %355
  %378 = add nsw i64 %340, %5
  %379 = icmp slt i64 %378, %4
  br i1 %379, label %339, label %390, !llvm.loop !36

380:                                              ; preds = %355, %380
  %381 = phi i64 [ %388, %380 ], [ 0, %355 ]
  %382 = getelementptr double, ptr %17, i64 %381
  %383 = load double, ptr %382, align 8
  %384 = fadd double %342, %383
  %385 = add nsw i64 %381, %340
  %386 = shl nsw i64 %385, 5
  %387 = getelementptr inbounds i8, ptr %29, i64 %386
  store double %384, ptr %387, align 8
  %388 = add nuw nsw i64 %381, 1
  %389 = icmp eq i64 %388, %5
  br i1 %389, label %377, label %380, !llvm.loop !37

390:                                              ; preds = %377, %336
  %391 = trunc nuw nsw i64 %20 to i32
  %392 = shl nuw nsw i32 %338, %391
  %393 = or i32 %392, %21
  br label %394

394:                                              ; preds = %19, %390
  %395 = phi i32 [ %393, %390 ], [ %21, %19 ]
  %396 = add nuw nsw i64 %20, 1
  %397 = icmp eq i64 %396, 4
  br i1 %397, label %18, label %19, !llvm.loop !38
}

define range(i32 0, 16) i32 @pydy_ldl_factor_4(ptr noundef %0, ptr noundef %1, i64 noundef %2) #0 {
  %4 = sitofp i64 %2 to double
  %5 = fmul double %4, 0x3CB0000000000000
  %6 = insertelement <4 x double> poison, double %5, i64 0
  %7 = shufflevector <4 x double> %6, <4 x double> poison, <4 x i32> zeroinitializer
  %8 = icmp sgt i64 %2, 0
  br i1 %8, label %9, label %11

9:                                                ; preds = %3
  %10 = add nuw i64 %2, 1
  br label %13

11:                                               ; preds = %13, %3
  %12 = icmp sgt i64 %2, 0
  br i1 %12, label %32, label %26

13:                                               ; preds = %9, %13
  %14 = phi i64 [ 0, %9 ], [ %20, %13 ]
  %15 = mul i64 %14, %10
  %16 = getelementptr inbounds <4 x double>, ptr %0, i64 %15
  %17 = load <4 x double>, ptr %16, align 8
  %18 = fmul <4 x double> %7, %17
  %19 = getelementptr inbounds <4 x double>, ptr %1, i64 %14
  store <4 x double> %18, ptr %19, align 8
  %20 = add nuw nsw i64 %14, 1
  %21 = icmp eq i64 %20, %2
  br i1 %21, label %11, label %13, !llvm.loop !39

22:                                               ; preds = %55, %32
  %23 = icmp eq i64 %44, %2
  br i1 %23, label %24, label %32, !llvm.loop !40

24:                                               ; preds = %22
  %25 = icmp ne <4 x i64> %42, zeroinitializer
  br label %26

26:                                               ; preds = %24, %11
  %27 = phi <4 x i1> [ zeroinitializer, %11 ], [ %25, %24 ]
  %28 = shufflevector <4 x i1> %27, <4 x i1> poison, <8 x i32> <i32 0, i32 1, i32 2, i32 3, i32 poison, i32 poison, i32 poison, i32 poison>
  %29 = bitcast <8 x i1> %28 to i8
  %30 = and i8 %29, 15
  %31 = zext nneg i8 %30 to i32
  ret i32 %31

32:                                               ; preds = %11, %22
  %33 = phi <4 x i64> [ %42, %22 ], [ zeroinitializer, %11 ]
  %34 = phi i64 [ %44, %22 ], [ 0, %11 ]
  %35 = mul nuw nsw i64 %34, %2
  %36 = getelementptr <4 x double>, ptr %0, i64 %35
  %37 = getelementptr <4 x double>, ptr %36, i64 %34
  %38 = load <4 x double>, ptr %37, align 8
  %39 = getelementptr inbounds <4 x double>, ptr %1, i64 %34
  %40 = load <4 x double>, ptr %39, align 8
  %41 = fcmp ule <4 x double> %38, %40
  %42 = select <4 x i1> %41, <4 x i64> <i64 -1, i64 -1, i64 -1, i64 -1>, <4 x i64> %33
  %43 = fdiv <4 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %38
  store <4 x double> %43, ptr %39, align 8
  %44 = add nuw nsw i64 %34, 1
  %45 = icmp slt i64 %44, %2
  br i1 %45, label %46, label %22

46:                                               ; preds = %32, %55
  %47 = phi i64 [ %56, %55 ], [ %44, %32 ]
  %48 = getelementptr inbounds <4 x double>, ptr %36, i64 %47
  %49 = load <4 x double>, ptr %48, align 8
  %50 = load <4 x double>, ptr %39, align 8
  %51 = fneg <4 x double> %49
  %52 = fmul <4 x double> %50, %51
  %53 = mul nuw nsw i64 %47, %2
  %54 = getelementptr <4 x double>, ptr %0, i64 %53
  br label %58

55:                                               ; preds = %58
  %56 = add nuw nsw i64 %47, 1
  %57 = icmp slt i64 %56, %2
  br i1 %57, label %46, label %22, !llvm.loop !41

58:                                               ; preds = %46, %58
  %59 = phi i64 [ %47, %46 ], [ %65, %58 ]
  %60 = getelementptr inbounds <4 x double>, ptr %36, i64 %59
  %61 = load <4 x double>, ptr %60, align 8
  %62 = getelementptr <4 x double>, ptr %54, i64 %59
  %63 = load <4 x double>, ptr %62, align 8
  %64 = tail call <4 x double> @llvm.fma.v4f64(<4 x double> %52, <4 x double> %61, <4 x double> %63)
  store <4 x double> %64, ptr %62, align 8
  %65 = add nuw nsw i64 %59, 1
  %66 = icmp slt i64 %65, %2
  br i1 %66, label %58, label %55, !llvm.loop !42
}

declare <4 x double> @llvm.fma.v4f64(<4 x double>, <4 x double>, <4 x double>) #1

define void @pydy_ldl_solve_4(ptr noundef readonly %0, ptr noundef readonly %1, ptr noundef %2, i64 noundef %3) #0 {
  %5 = icmp sgt i64 %3, 0
  br i1 %5, label %8, label %6

6:                                                ; preds = %20, %4
  %7 = icmp sgt i64 %3, 0
  br i1 %7, label %32, label %39

8:                                                ; preds = %4, %20
  %9 = phi i64 [ %15, %20 ], [ 0, %4 ]
  %10 = getelementptr inbounds <4 x double>, ptr %2, i64 %9
  %11 = load <4 x double>, ptr %10, align 8
  %12 = getelementptr inbounds <4 x double>, ptr %1, i64 %9
  %13 = load <4 x double>, ptr %12, align 8
  %14 = fmul <4 x double> %11, %13
  %15 = add nuw nsw i64 %9, 1
  %16 = icmp slt i64 %15, %3
  br i1 %16, label %17, label %20

17:                                               ; preds = %8
  %18 = mul nuw nsw i64 %9, %3
  %19 = getelementptr <4 x double>, ptr %0, i64 %18
  br label %22

20:                                               ; preds = %22, %8
  store <4 x double> %14, ptr %10, align 8
  %21 = icmp eq i64 %15, %3
  br i1 %21, label %6, label %8, !llvm.loop !43

22:                                               ; preds = %17, %22
  %23 = phi i64 [ %15, %17 ], [ %30, %22 ]
  %24 = getelementptr <4 x double>, ptr %19, i64 %23
  %25 = load <4 x double>, ptr %24, align 8
  %26 = fneg <4 x double> %25
  %27 = getelementptr inbounds <4 x double>, ptr %2, i64 %23
  %28 = load <4 x double>, ptr %27, align 8
  %29 = tail call <4 x double> @llvm.fma.v4f64(<4 x double> %26, <4 x double> %14, <4 x double> %28)
  store <4 x double> %29, ptr %27, align 8
  %30 = add nuw nsw i64 %23, 1
  %31 = icmp slt i64 %30, %3
  br i1 %31, label %22, label %20, !llvm.loop !44

32:                                               ; preds = %6, %40
  %33 = phi i64 [ %34, %40 ], [ %3, %6 ]
  %34 = add nsw i64 %33, -1
  %35 = icmp slt i64 %33, %3
  br i1 %35, label %36, label %40

36:                                               ; preds = %32
  %37 = mul nsw i64 %34, %3
  %38 = getelementptr <4 x double>, ptr %0, i64 %37
  br label %49

39:                                               ; preds = %40, %6
  ret void

40:                                               ; preds = %49, %32
  %41 = phi <4 x double> [ zeroinitializer, %32 ], [ %57, %49 ]
  %42 = getelementptr inbounds <4 x double>, ptr %1, i64 %34
  %43 = load <4 x double>, ptr %42, align 8
  %44 = fmul <4 x double> %41, %43
  %45 = getelementptr inbounds <4 x double>, ptr %2, i64 %34
  %46 = load <4 x double>, ptr %45, align 8
  %47 = fadd <4 x double> %46, %44
  store <4 x double> %47, ptr %45, align 8
  %48 = icmp sgt i64 %33, 1
  br i1 %48, label %32, label %39, !llvm.loop !45

49:                                               ; preds = %36, %49
  %50 = phi i64 [ %33, %36 ], [ %58, %49 ]
  %51 = phi <4 x double> [ zeroinitializer, %36 ], [ %57, %49 ]
  %52 = getelementptr <4 x double>, ptr %38, i64 %50
  %53 = load <4 x double>, ptr %52, align 8
  %54 = fneg <4 x double> %53
  %55 = getelementptr inbounds <4 x double>, ptr %2, i64 %50
  %56 = load <4 x double>, ptr %55, align 8
  %57 = tail call <4 x double> @llvm.fma.v4f64(<4 x double> %54, <4 x double> %56, <4 x double> %51)
  %58 = add nuw nsw i64 %50, 1
  %59 = icmp eq i64 %58, %3
  br i1 %59, label %40, label %49, !llvm.loop !46
}

define i32 @pydy_guard_4(ptr noundef readonly %0, ptr noundef %1, i64 noundef %2, ptr noundef %3, i64 noundef %4, i32 noundef %5) #2 {
  %7 = icmp sgt i64 %4, 0
  br i1 %7, label %8, label %15

8:                                                ; preds = %6, %23
  %9 = phi i64 [ %25, %23 ], [ 1, %6 ]
  %10 = phi ptr [ %30, %23 ], [ %0, %6 ]
  %11 = phi i64 [ %24, %23 ], [ 0, %6 ]
  %12 = getelementptr <4 x double>, ptr %3, i64 %11
  %13 = mul nuw nsw i64 %11, %4
  %14 = getelementptr <4 x double>, ptr %3, i64 %13
  br label %27

15:                                               ; preds = %23, %6
  %16 = mul nsw i64 %4, %4
  %17 = getelementptr inbounds <4 x double>, ptr %3, i64 %16
  %18 = getelementptr inbounds <4 x double>, ptr %17, i64 %4
  %19 = tail call i32 @pydy_lu_4(ptr noundef %3, ptr noundef %17, ptr noundef %18, ptr noundef null, i64 noundef %4, i32 noundef %5) #3
  %20 = icmp sgt i64 %2, 0
  br i1 %20, label %21, label %37

21:                                               ; preds = %15
  %22 = shl i64 %4, 5
  br label %38

23:                                               ; preds = %27
  %24 = add nuw nsw i64 %11, 1
  %25 = add nuw i64 %9, 1
  %26 = icmp eq i64 %24, %4
  br i1 %26, label %15, label %8, !llvm.loop !47

27:                                               ; preds = %8, %27
  %28 = phi ptr [ %10, %8 ], [ %30, %27 ]
  %29 = phi i64 [ 0, %8 ], [ %35, %27 ]
  %30 = getelementptr inbounds i8, ptr %28, i64 32
  %31 = load <4 x double>, ptr %28, align 8
  %32 = mul nuw nsw i64 %29, %4
  %33 = getelementptr <4 x double>, ptr %12, i64 %32
  store <4 x double> %31, ptr %33, align 8
  %34 = getelementptr <4 x double>, ptr %14, i64 %29
  store <4 x double> %31, ptr %34, align 8
  %35 = add nuw nsw i64 %29, 1
  %36 = icmp eq i64 %35, %9
  br i1 %36, label %23, label %27, !llvm.loop !48

37:                                               ; preds = %38, %15
  ret i32 %19

38:                                               ; preds = %21, %38
  %39 = phi i64 [ 0, %21 ], [ %43, %38 ]
  %40 = mul i64 %22, %39
  %41 = getelementptr inbounds i8, ptr %1, i64 %40
  %42 = tail call i32 @pydy_lu_4(ptr noundef %3, ptr noundef %17, ptr noundef %18, ptr noundef %41, i64 noundef %4, i32 noundef %5) #3
  %43 = add nuw nsw i64 %39, 1
  %44 = icmp eq i64 %43, %2
  br i1 %44, label %37, label %38, !llvm.loop !49
}

declare double @llvm.fma.f64(double, double, double) #1

declare double @llvm.fabs.f64(double) #1

declare double @llvm.sqrt.f64(double) #1

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn memory(none) }
attributes #2 = { nounwind }
attributes #3 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = distinct !{!3, !4, !5, !6}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
!6 = !{!"llvm.loop.vectorize.width", i32 1}
!7 = distinct !{!7, !4, !5}
!8 = distinct !{!8, !4, !5, !6}
!9 = distinct !{!9, !4, !5}
!10 = distinct !{!10, !4, !5, !6}
!11 = distinct !{!11, !4, !5}
!12 = distinct !{!12, !4, !5, !6}
!13 = distinct !{!13, !4, !5}
!14 = distinct !{!14, !4, !5, !6}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5, !6}
!17 = distinct !{!17, !4, !5, !6}
!18 = distinct !{!18, !4, !5}
!19 = distinct !{!19, !4, !5, !6}
!20 = distinct !{!20, !4, !5}
!21 = distinct !{!21, !4, !5, !6}
!22 = distinct !{!22, !4, !5}
!23 = distinct !{!23, !4, !5, !6}
!24 = distinct !{!24, !4, !5, !6}
!25 = distinct !{!25, !4, !5, !6}
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5, !6}
!29 = distinct !{!29, !4, !5, !6}
!30 = distinct !{!30, !4, !5, !6}
!31 = distinct !{!31, !4, !5, !6}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5, !6}
!35 = distinct !{!35, !4, !5, !6}
!36 = distinct !{!36, !4, !5}
!37 = distinct !{!37, !4, !5, !6}
!38 = distinct !{!38, !4, !5}
!39 = distinct !{!39, !4, !5}
!40 = distinct !{!40, !4, !5}
!41 = distinct !{!41, !4, !5}
!42 = distinct !{!42, !4, !5}
!43 = distinct !{!43, !4, !5}
!44 = distinct !{!44, !4, !5}
!45 = distinct !{!45, !4, !5}
!46 = distinct !{!46, !4, !5}
!47 = distinct !{!47, !4, !5}
!48 = distinct !{!48, !4, !5}
!49 = distinct !{!49, !4, !5}
