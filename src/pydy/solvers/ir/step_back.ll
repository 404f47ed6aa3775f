; sources bbf0573482163939235699f6f7ecfbff44d7d95e2577ac7250daf56005cccde6
; Made by tools/solvers_ir.py with ziglang 0.14.1.

define i64 @step_back(ptr noundef readonly %0) #0 {
  %2 = getelementptr inbounds i8, ptr %0, i64 168
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds i8, ptr %3, i64 8
  %5 = load i64, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %3, i64 16
  %7 = load i64, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %0, i64 456
  %9 = getelementptr inbounds i8, ptr %0, i64 464
  %10 = load i64, ptr %9, align 8
  %11 = load ptr, ptr %2, align 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i8, ptr %11, i64 16
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %11, i64 24
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr inbounds i8, ptr %0, i64 192
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %0, i64 216
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds i8, ptr %0, i64 240
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr inbounds i8, ptr %0, i64 504
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr inbounds i8, ptr %0, i64 384
  %26 = load ptr, ptr %25, align 8
  %27 = getelementptr inbounds i8, ptr %0, i64 48
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr inbounds i8, ptr %11, i64 8
  %30 = load i64, ptr %29, align 8
  %31 = getelementptr inbounds double, ptr %28, i64 %30
  %32 = getelementptr inbounds i8, ptr %0, i64 288
  %33 = getelementptr inbounds i8, ptr %0, i64 296
  %34 = load i64, ptr %33, align 8
  %35 = getelementptr inbounds i8, ptr %0, i64 312
  %36 = getelementptr inbounds i8, ptr %0, i64 408
  %37 = getelementptr inbounds i8, ptr %0, i64 336
  %38 = getelementptr inbounds i8, ptr %0, i64 360
  %39 = getelementptr i64, ptr %18, i64 %12
  %40 = getelementptr inbounds i8, ptr %0, i64 480
  %41 = getelementptr inbounds i8, ptr %0, i64 432
  %42 = icmp sgt i64 %5, 0
  %43 = getelementptr inbounds i8, ptr %0, i64 264
  %44 = getelementptr inbounds i8, ptr %0, i64 24
  %45 = getelementptr inbounds i8, ptr %0, i64 104
  %46 = getelementptr inbounds i8, ptr %0, i64 72
  %47 = icmp sgt i64 %5, 0
  %48 = icmp sgt i64 %14, 0
  %49 = getelementptr double, ptr %24, i64 %5
  %50 = getelementptr inbounds i8, ptr %0, i64 528
  %51 = icmp sgt i64 %16, 0
  %52 = add nsw i64 %14, %5
  %53 = sub i64 %52, %16
  %54 = getelementptr double, ptr %24, i64 %53
  %55 = getelementptr inbounds i8, ptr %0, i64 552
  %56 = icmp sgt i64 %12, 0
  %57 = icmp sgt i64 %5, 0
  %58 = mul nsw i64 %12, %10
  %59 = getelementptr double, ptr %26, i64 %58
  br label %60

60:                                               ; preds = %201, %1
  %61 = phi i64 [ %34, %1 ], [ %63, %201 ]
  %62 = phi i64 [ undef, %1 ], [ %182, %201 ]
  %63 = add nsw i64 %61, -1
  %64 = icmp slt i64 %61, 1
  br i1 %64, label %202, label %65

65:                                               ; preds = %60
  %66 = load ptr, ptr %32, align 8
  %67 = getelementptr inbounds double, ptr %66, i64 %63
  %68 = load double, ptr %67, align 8
  %69 = load ptr, ptr %35, align 8
  %70 = getelementptr inbounds double, ptr %69, i64 %63
  %71 = load double, ptr %70, align 8
  %72 = load ptr, ptr %36, align 8
  %73 = insertelement <8 x double> poison, double %71, i64 0
  %74 = shufflevector <8 x double> %73, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %74, ptr %72, align 8
  %75 = mul nsw i64 %63, %10
  %76 = mul nsw i64 %63, %12
  %77 = mul nsw i64 %76, %10
  br label %78

78:                                               ; preds = %179, %65
  %79 = phi i64 [ %12, %65 ], [ %81, %179 ]
  %80 = phi i64 [ %62, %65 ], [ %180, %179 ]
  %81 = add nsw i64 %79, -1
  %82 = icmp slt i64 %79, 1
  br i1 %82, label %181, label %83

83:                                               ; preds = %78
  %84 = getelementptr inbounds i64, ptr %18, i64 %81
  %85 = load i64, ptr %84, align 8
  %86 = getelementptr inbounds i64, ptr %18, i64 %79
  %87 = load i64, ptr %86, align 8
  %88 = sub nsw i64 %87, %85
  %89 = load ptr, ptr %8, align 8
  %90 = load ptr, ptr %37, align 8
  %91 = getelementptr inbounds double, ptr %90, i64 %75
  %92 = load ptr, ptr %36, align 8
  %93 = load ptr, ptr %38, align 8
  %94 = getelementptr inbounds double, ptr %93, i64 %77
  %95 = getelementptr inbounds i64, ptr %20, i64 %85
  %96 = getelementptr inbounds double, ptr %22, i64 %85
  %97 = icmp sgt i64 %88, 0
  %98 = add nsw i64 %88, -1
  %99 = select i1 %97, i64 %98, i64 0
  %100 = zext i1 %97 to i64
  tail call fastcc void @combine(ptr noundef %89, ptr noundef %91, ptr noundef %92, ptr noundef %94, ptr noundef %95, ptr noundef %96, i64 noundef %99, i64 noundef %100, i64 noundef %7) #4
  %101 = getelementptr i64, ptr %39, i64 %81
  %102 = load i64, ptr %101, align 8
  %103 = getelementptr i64, ptr %39, i64 %79
  %104 = load i64, ptr %103, align 8
  %105 = sub nsw i64 %104, %102
  %106 = load ptr, ptr %40, align 8
  %107 = load ptr, ptr %41, align 8
  %108 = load ptr, ptr %36, align 8
  %109 = getelementptr inbounds i64, ptr %20, i64 %102
  %110 = getelementptr inbounds double, ptr %22, i64 %102
  tail call fastcc void @combine(ptr noundef %106, ptr noundef %107, ptr noundef %108, ptr noundef %26, ptr noundef %109, ptr noundef %110, i64 noundef %105, i64 noundef 0, i64 noundef %7) #4
  br i1 %42, label %136, label %111

111:                                              ; preds = %136, %83
  %112 = load ptr, ptr %43, align 8
  %113 = getelementptr inbounds double, ptr %112, i64 %81
  %114 = load double, ptr %113, align 8
  %115 = fmul double %71, %114
  %116 = fadd double %68, %115
  %117 = load ptr, ptr %8, align 8
  %118 = load ptr, ptr %23, align 8
  %119 = load ptr, ptr %44, align 8
  store double %116, ptr %119, align 8
  %120 = load i64, ptr %45, align 8
  %121 = icmp sgt i64 %120, 0
  br i1 %121, label %122, label %123

122:                                              ; preds = %111
  tail call fastcc void @sample(ptr noundef %0) #4
  br label %123

123:                                              ; preds = %111, %122
  %124 = load ptr, ptr %0, align 8
  %125 = load i64, ptr %124, align 8
  %126 = load ptr, ptr %44, align 8
  %127 = load ptr, ptr %27, align 8
  %128 = load ptr, ptr %46, align 8
  %129 = inttoptr i64 %125 to ptr
  %130 = tail call i32 %129(ptr noundef %126, ptr noundef %117, ptr noundef %127, ptr noundef %128, ptr noundef %118) #5
  %131 = icmp eq i32 %130, 0
  br i1 %131, label %132, label %144

132:                                              ; preds = %123
  br i1 %47, label %133, label %148

133:                                              ; preds = %132
  %134 = mul nsw i64 %81, %10
  %135 = getelementptr double, ptr %26, i64 %134
  br label %149

136:                                              ; preds = %83, %136
  %137 = phi i64 [ %142, %136 ], [ 0, %83 ]
  %138 = load ptr, ptr %40, align 8
  %139 = getelementptr inbounds double, ptr %138, i64 %137
  %140 = load double, ptr %139, align 8
  %141 = getelementptr inbounds double, ptr %31, i64 %137
  store double %140, ptr %141, align 8
  %142 = add nuw nsw i64 %137, 1
  %143 = icmp eq i64 %142, %5
  br i1 %143, label %111, label %136, !llvm.loop !3

144:                                              ; preds = %123
  %145 = sext i32 %130 to i64
  %146 = load ptr, ptr %2, align 8
  %147 = getelementptr inbounds i8, ptr %146, i64 32
  store i64 %63, ptr %147, align 8
  br label %179

148:                                              ; preds = %149, %132
  br i1 %48, label %160, label %156

149:                                              ; preds = %133, %149
  %150 = phi i64 [ 0, %133 ], [ %154, %149 ]
  %151 = getelementptr inbounds double, ptr %24, i64 %150
  %152 = load double, ptr %151, align 8
  %153 = getelementptr double, ptr %135, i64 %150
  store double %152, ptr %153, align 8
  %154 = add nuw nsw i64 %150, 1
  %155 = icmp eq i64 %154, %5
  br i1 %155, label %148, label %149, !llvm.loop !6

156:                                              ; preds = %160, %148
  br i1 %51, label %157, label %179

157:                                              ; preds = %156
  %158 = add nsw i64 %81, %76
  %159 = mul nsw i64 %158, %16
  br label %170

160:                                              ; preds = %148, %160
  %161 = phi i64 [ %168, %160 ], [ 0, %148 ]
  %162 = getelementptr double, ptr %49, i64 %161
  %163 = load double, ptr %162, align 8
  %164 = load ptr, ptr %50, align 8
  %165 = getelementptr inbounds double, ptr %164, i64 %161
  %166 = load double, ptr %165, align 8
  %167 = fadd double %163, %166
  store double %167, ptr %165, align 8
  %168 = add nuw nsw i64 %161, 1
  %169 = icmp eq i64 %168, %14
  br i1 %169, label %156, label %160, !llvm.loop !7

170:                                              ; preds = %157, %170
  %171 = phi i64 [ 0, %157 ], [ %177, %170 ]
  %172 = getelementptr double, ptr %54, i64 %171
  %173 = load double, ptr %172, align 8
  %174 = load ptr, ptr %55, align 8
  %175 = getelementptr double, ptr %174, i64 %159
  %176 = getelementptr double, ptr %175, i64 %171
  store double %173, ptr %176, align 8
  %177 = add nuw nsw i64 %171, 1
  %178 = icmp eq i64 %177, %16
  br i1 %178, label %179, label %170, !llvm.loop !8

179:                                              ; preds = %170, %156, %144
  %180 = phi i64 [ %145, %144 ], [ %80, %156 ], [ %80, %170 ]
  br i1 %131, label %78, label %181, !llvm.loop !9

181:                                              ; preds = %78, %179
  %182 = phi i64 [ %180, %179 ], [ %80, %78 ]
  br i1 %82, label %183, label %202

183:                                              ; preds = %181
  br i1 %56, label %184, label %201

184:                                              ; preds = %183, %189
  %185 = phi i64 [ %190, %189 ], [ 0, %183 ]
  br i1 %57, label %186, label %189

186:                                              ; preds = %184
  %187 = mul nsw i64 %185, %10
  %188 = getelementptr double, ptr %26, i64 %187
  br label %192

189:                                              ; preds = %192, %184
  %190 = add nuw nsw i64 %185, 1
  %191 = icmp eq i64 %190, %12
  br i1 %191, label %201, label %184, !llvm.loop !10

192:                                              ; preds = %186, %192
  %193 = phi i64 [ 0, %186 ], [ %199, %192 ]
  %194 = getelementptr double, ptr %188, i64 %193
  %195 = load double, ptr %194, align 8
  %196 = getelementptr double, ptr %59, i64 %193
  %197 = load double, ptr %196, align 8
  %198 = fadd double %195, %197
  store double %198, ptr %196, align 8
  %199 = add nuw nsw i64 %193, 1
  %200 = icmp eq i64 %199, %5
  br i1 %200, label %189, label %192, !llvm.loop !11

201:                                              ; preds = %189, %183
  br i1 %82, label %60, label %202, !llvm.loop !12

202:                                              ; preds = %181, %60, %201
  %203 = phi i64 [ %182, %201 ], [ 0, %60 ], [ %182, %181 ]
  ret i64 %203
}

define internal fastcc void @combine(ptr noundef writeonly %0, ptr noundef readonly %1, ptr noundef readonly %2, ptr noundef readonly %3, ptr noundef readonly %4, ptr noundef readonly %5, i64 noundef %6, i64 noundef %7, i64 noundef %8) unnamed_addr #1 {
  %10 = load <8 x double>, ptr %2, align 8
  %11 = shl nsw i64 %8, 3
  %12 = icmp slt i64 %8, 4
  br i1 %12, label %16, label %13

13:                                               ; preds = %9
  %14 = icmp sgt i64 %6, 0
  %15 = add nsw i64 %7, %6
  br label %22

16:                                               ; preds = %99, %9
  %17 = phi i64 [ 0, %9 ], [ %23, %99 ]
  %18 = icmp slt i64 %17, %11
  br i1 %18, label %19, label %153

19:                                               ; preds = %16
  %20 = icmp sgt i64 %6, 0
  %21 = add nsw i64 %7, %6
  br label %109

22:                                               ; preds = %13, %99
  %23 = phi i64 [ 32, %13 ], [ %107, %99 ]
  %24 = phi i64 [ 0, %13 ], [ %23, %99 ]
  %25 = getelementptr inbounds double, ptr %1, i64 %24
  %26 = getelementptr inbounds double, ptr %0, i64 %24
  %27 = getelementptr inbounds double, ptr %3, i64 %24
  br i1 %14, label %28, label %54

28:                                               ; preds = %22, %28
  %29 = phi <8 x double> [ %48, %28 ], [ zeroinitializer, %22 ]
  %30 = phi <8 x double> [ %45, %28 ], [ zeroinitializer, %22 ]
  %31 = phi <8 x double> [ %42, %28 ], [ zeroinitializer, %22 ]
  %32 = phi <8 x double> [ %51, %28 ], [ zeroinitializer, %22 ]
  %33 = phi i64 [ %52, %28 ], [ 0, %22 ]
  %34 = getelementptr inbounds i64, ptr %4, i64 %33
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds double, ptr %27, i64 %35
  %37 = getelementptr inbounds double, ptr %5, i64 %33
  %38 = load double, ptr %37, align 8
  %39 = insertelement <8 x double> poison, double %38, i64 0
  %40 = shufflevector <8 x double> %39, <8 x double> poison, <8 x i32> zeroinitializer
  %41 = load <8 x double>, ptr %36, align 8
  %42 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %40, <8 x double> %41, <8 x double> %31)
  %43 = getelementptr inbounds i8, ptr %36, i64 64
  %44 = load <8 x double>, ptr %43, align 8
  %45 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %40, <8 x double> %44, <8 x double> %30)
  %46 = getelementptr inbounds i8, ptr %36, i64 128
  %47 = load <8 x double>, ptr %46, align 8
  %48 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %40, <8 x double> %47, <8 x double> %29)
  %49 = getelementptr inbounds i8, ptr %36, i64 192
  %50 = load <8 x double>, ptr %49, align 8
  %51 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %40, <8 x double> %50, <8 x double> %32)
  %52 = add nuw nsw i64 %33, 1
  %53 = icmp eq i64 %52, %6
  br i1 %53, label %54, label %28, !llvm.loop !13

54:                                               ; preds = %28, %22
  %55 = phi <8 x double> [ zeroinitializer, %22 ], [ %48, %28 ]
  %56 = phi <8 x double> [ zeroinitializer, %22 ], [ %45, %28 ]
  %57 = phi <8 x double> [ zeroinitializer, %22 ], [ %42, %28 ]
  %58 = phi <8 x double> [ zeroinitializer, %22 ], [ %51, %28 ]
  %59 = phi i64 [ 0, %22 ], [ %6, %28 ]
  %60 = load <8 x double>, ptr %25, align 8
  %61 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %57, <8 x double> %60)
  %62 = getelementptr inbounds i8, ptr %25, i64 64
  %63 = load <8 x double>, ptr %62, align 8
  %64 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %56, <8 x double> %63)
  %65 = getelementptr inbounds i8, ptr %25, i64 128
  %66 = load <8 x double>, ptr %65, align 8
  %67 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %55, <8 x double> %66)
  %68 = getelementptr inbounds i8, ptr %25, i64 192
  %69 = load <8 x double>, ptr %68, align 8
  %70 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %58, <8 x double> %69)
  %71 = icmp slt i64 %59, %15
  br i1 %71, label %72, label %99

72:                                               ; preds = %54, %72
  %73 = phi <8 x double> [ %93, %72 ], [ %67, %54 ]
  %74 = phi <8 x double> [ %90, %72 ], [ %64, %54 ]
  %75 = phi <8 x double> [ %87, %72 ], [ %61, %54 ]
  %76 = phi <8 x double> [ %96, %72 ], [ %70, %54 ]
  %77 = phi i64 [ %97, %72 ], [ %59, %54 ]
  %78 = getelementptr inbounds i64, ptr %4, i64 %77
  %79 = load i64, ptr %78, align 8
  %80 = getelementptr inbounds double, ptr %27, i64 %79
  %81 = getelementptr inbounds double, ptr %5, i64 %77
  %82 = load double, ptr %81, align 8
  %83 = insertelement <8 x double> poison, double %82, i64 0
  %84 = shufflevector <8 x double> %83, <8 x double> poison, <8 x i32> zeroinitializer
  %85 = fmul <8 x double> %10, %84
  %86 = load <8 x double>, ptr %80, align 8
  %87 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %85, <8 x double> %86, <8 x double> %75)
  %88 = getelementptr inbounds i8, ptr %80, i64 64
  %89 = load <8 x double>, ptr %88, align 8
  %90 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %85, <8 x double> %89, <8 x double> %74)
  %91 = getelementptr inbounds i8, ptr %80, i64 128
  %92 = load <8 x double>, ptr %91, align 8
  %93 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %85, <8 x double> %92, <8 x double> %73)
  %94 = getelementptr inbounds i8, ptr %80, i64 192
  %95 = load <8 x double>, ptr %94, align 8
  %96 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %85, <8 x double> %95, <8 x double> %76)
  %97 = add nuw nsw i64 %77, 1
  %98 = icmp slt i64 %97, %15
  br i1 %98, label %72, label %99, !llvm.loop !14

99:                                               ; preds = %72, %54
  %100 = phi <8 x double> [ %67, %54 ], [ %93, %72 ]
  %101 = phi <8 x double> [ %64, %54 ], [ %90, %72 ]
  %102 = phi <8 x double> [ %61, %54 ], [ %87, %72 ]
  %103 = phi <8 x double> [ %70, %54 ], [ %96, %72 ]
  store <8 x double> %102, ptr %26, align 8
  %104 = getelementptr inbounds i8, ptr %26, i64 64
  store <8 x double> %101, ptr %104, align 8
  %105 = getelementptr inbounds i8, ptr %26, i64 128
  store <8 x double> %100, ptr %105, align 8
  %106 = getelementptr inbounds i8, ptr %26, i64 192
  store <8 x double> %103, ptr %106, align 8
  %107 = add nuw nsw i64 %23, 32
  %108 = icmp sgt i64 %107, %11
  br i1 %108, label %16, label %22, !llvm.loop !15

109:                                              ; preds = %19, %149
  %110 = phi i64 [ %17, %19 ], [ %151, %149 ]
  %111 = getelementptr inbounds double, ptr %0, i64 %110
  %112 = getelementptr inbounds double, ptr %1, i64 %110
  %113 = getelementptr inbounds double, ptr %3, i64 %110
  br i1 %20, label %120, label %114

114:                                              ; preds = %120, %109
  %115 = phi <8 x double> [ zeroinitializer, %109 ], [ %131, %120 ]
  %116 = phi i64 [ 0, %109 ], [ %6, %120 ]
  %117 = load <8 x double>, ptr %112, align 8
  %118 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %10, <8 x double> %115, <8 x double> %117)
  %119 = icmp slt i64 %116, %21
  br i1 %119, label %134, label %149

120:                                              ; preds = %109, %120
  %121 = phi <8 x double> [ %131, %120 ], [ zeroinitializer, %109 ]
  %122 = phi i64 [ %132, %120 ], [ 0, %109 ]
  %123 = getelementptr inbounds double, ptr %5, i64 %122
  %124 = load double, ptr %123, align 8
  %125 = insertelement <8 x double> poison, double %124, i64 0
  %126 = shufflevector <8 x double> %125, <8 x double> poison, <8 x i32> zeroinitializer
  %127 = getelementptr inbounds i64, ptr %4, i64 %122
  %128 = load i64, ptr %127, align 8
  %129 = getelementptr inbounds double, ptr %113, i64 %128
  %130 = load <8 x double>, ptr %129, align 8
  %131 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %126, <8 x double> %130, <8 x double> %121)
  %132 = add nuw nsw i64 %122, 1
  %133 = icmp eq i64 %132, %6
  br i1 %133, label %114, label %120, !llvm.loop !13

134:                                              ; preds = %114, %134
  %135 = phi <8 x double> [ %146, %134 ], [ %118, %114 ]
  %136 = phi i64 [ %147, %134 ], [ %116, %114 ]
  %137 = getelementptr inbounds double, ptr %5, i64 %136
  %138 = load double, ptr %137, align 8
  %139 = insertelement <8 x double> poison, double %138, i64 0
  %140 = shufflevector <8 x double> %139, <8 x double> poison, <8 x i32> zeroinitializer
  %141 = fmul <8 x double> %10, %140
  %142 = getelementptr inbounds i64, ptr %4, i64 %136
  %143 = load i64, ptr %142, align 8
  %144 = getelementptr inbounds double, ptr %113, i64 %143
  %145 = load <8 x double>, ptr %144, align 8
  %146 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %141, <8 x double> %145, <8 x double> %135)
  %147 = add nuw nsw i64 %136, 1
  %148 = icmp slt i64 %147, %21
  br i1 %148, label %134, label %149, !llvm.loop !14

149:                                              ; preds = %134, %114
  %150 = phi <8 x double> [ %118, %114 ], [ %146, %134 ]
  store <8 x double> %150, ptr %111, align 8
  %151 = add nuw nsw i64 %110, 8
  %152 = icmp slt i64 %151, %11
  br i1 %152, label %109, label %153, !llvm.loop !16

153:                                              ; preds = %149, %16
  ret void
}

declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

define internal fastcc void @sample(ptr noundef readonly %0) unnamed_addr #3 {
  %2 = getelementptr inbounds i8, ptr %0, i64 104
  %3 = load i64, ptr %2, align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %12

5:                                                ; preds = %1
  %6 = getelementptr inbounds i8, ptr %0, i64 96
  %7 = getelementptr inbounds i8, ptr %0, i64 112
  %8 = getelementptr inbounds i8, ptr %0, i64 24
  %9 = getelementptr inbounds i8, ptr %0, i64 120
  %10 = getelementptr inbounds i8, ptr %0, i64 144
  %11 = getelementptr inbounds i8, ptr %0, i64 48
  br label %13

12:                                               ; preds = %56, %1
  ret void

13:                                               ; preds = %5, %56
  %14 = phi i64 [ 0, %5 ], [ %81, %56 ]
  %15 = load ptr, ptr %6, align 8
  %16 = load i64, ptr %7, align 8
  %17 = mul nsw i64 %16, %14
  %18 = getelementptr inbounds i64, ptr %15, i64 %17
  %19 = getelementptr inbounds i8, ptr %18, i64 24
  %20 = load ptr, ptr %8, align 8
  %21 = load double, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %18, i64 8
  %23 = load i64, ptr %22, align 8
  %24 = load ptr, ptr %9, align 8
  %25 = getelementptr inbounds double, ptr %24, i64 %23
  %26 = load double, ptr %25, align 8
  %27 = fcmp ogt double %26, %21
  %28 = select i1 %27, double %26, double %21
  %29 = getelementptr inbounds i8, ptr %18, i64 16
  %30 = load i64, ptr %29, align 8
  %31 = load i64, ptr %19, align 8
  %32 = getelementptr inbounds double, ptr %25, i64 %31
  %33 = load double, ptr %32, align 8
  %34 = fcmp ugt double %33, %28
  br i1 %34, label %42, label %35

35:                                               ; preds = %13
  %36 = add nsw i64 %30, -1
  %37 = icmp eq i64 %36, %31
  br i1 %37, label %56, label %38

38:                                               ; preds = %35
  %39 = getelementptr i8, ptr %32, i64 8
  %40 = load double, ptr %39, align 8
  %41 = fcmp ogt double %40, %28
  br i1 %41, label %56, label %42

42:                                               ; preds = %38, %13
  %43 = icmp sgt i64 %30, 1
  br i1 %43, label %44, label %56

44:                                               ; preds = %42, %44
  %45 = phi i64 [ %53, %44 ], [ %30, %42 ]
  %46 = phi i64 [ %52, %44 ], [ 0, %42 ]
  %47 = add nsw i64 %45, %46
  %48 = sdiv i64 %47, 2
  %49 = getelementptr inbounds double, ptr %25, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = fcmp ugt double %50, %28
  %52 = select i1 %51, i64 %46, i64 %48
  %53 = select i1 %51, i64 %48, i64 %45
  %54 = sub nsw i64 %53, %52
  %55 = icmp sgt i64 %54, 1
  br i1 %55, label %44, label %56, !llvm.loop !17

56:                                               ; preds = %44, %42, %35, %38
  %57 = phi i64 [ %31, %38 ], [ %31, %35 ], [ 0, %42 ], [ %52, %44 ]
  store i64 %57, ptr %19, align 8
  %58 = getelementptr inbounds double, ptr %25, i64 %57
  %59 = load double, ptr %58, align 8
  %60 = fsub double %28, %59
  %61 = load ptr, ptr %10, align 8
  %62 = add nsw i64 %57, %23
  %63 = shl nsw i64 %62, 5
  %64 = getelementptr inbounds i8, ptr %61, i64 %63
  %65 = load double, ptr %64, align 8
  %66 = getelementptr inbounds i8, ptr %64, i64 8
  %67 = load double, ptr %66, align 8
  %68 = getelementptr inbounds i8, ptr %64, i64 16
  %69 = load double, ptr %68, align 8
  %70 = getelementptr inbounds i8, ptr %64, i64 24
  %71 = load double, ptr %70, align 8
  %72 = fmul double %60, %71
  %73 = fadd double %69, %72
  %74 = fmul double %60, %73
  %75 = fadd double %67, %74
  %76 = fmul double %60, %75
  %77 = fadd double %65, %76
  %78 = load ptr, ptr %11, align 8
  %79 = load i64, ptr %18, align 8
  %80 = getelementptr inbounds double, ptr %78, i64 %79
  store double %77, ptr %80, align 8
  %81 = add nuw nsw i64 %14, 1
  %82 = load i64, ptr %2, align 8
  %83 = icmp slt i64 %81, %82
  br i1 %83, label %13, label %12, !llvm.loop !18
}

attributes #0 = { nounwind }
attributes #1 = { noinline nounwind }
attributes #2 = { nounwind willreturn memory(none) }
attributes #3 = { noinline nounwind }
attributes #4 = { nounwind }
attributes #5 = { nounwind }


!0 = !{i32 1, !"wchar_size", i32 4}
!1 = !{i32 8, !"PIC Level", i32 2}
!2 = !{i32 7, !"PIE Level", i32 2}
!3 = distinct !{!3, !4, !5}
!4 = !{!"llvm.loop.mustprogress"}
!5 = !{!"llvm.loop.unroll.disable"}
!6 = distinct !{!6, !4, !5}
!7 = distinct !{!7, !4, !5}
!8 = distinct !{!8, !4, !5}
!9 = distinct !{!9, !4, !5}
!10 = distinct !{!10, !4, !5}
!11 = distinct !{!11, !4, !5}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5}
!14 = distinct !{!14, !4, !5}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5}
!17 = distinct !{!17, !4, !5}
!18 = distinct !{!18, !4, !5}
