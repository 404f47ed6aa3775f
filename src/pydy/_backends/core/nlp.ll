; sources d4e9529335343412f25d7ad655f11d350c8b5bbdf106cf29eedbe318763d9443
; Made by tools/solvers_ir.py with ziglang 0.14.1.

%struct.Part = type { %struct.Words, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, i64, i64, i64, i64, ptr, ptr, ptr, i64, ptr }
%struct.Words = type { ptr, ptr, ptr, ptr, i64, i64, i64, i64, i64, i64, i64, i64, %struct.Distances, %struct.Distances, %struct.Distances }
%struct.Distances = type { i64, i64 }

define zeroext i1 @nlp_cost(i32 noundef %0, ptr noundef readonly %1, i1 noundef zeroext %2, ptr noundef writeonly %3, ptr noundef readonly %4) #0 {
  %6 = getelementptr inbounds i8, ptr %4, i64 16
  %7 = load i64, ptr %6, align 8
  %8 = icmp sgt i64 %7, 0
  br i1 %8, label %9, label %11

9:                                                ; preds = %5
  %10 = getelementptr inbounds i8, ptr %4, i64 56
  br label %18

11:                                               ; preds = %32, %5
  %12 = phi double [ 0.000000e+00, %5 ], [ %34, %32 ]
  %13 = getelementptr inbounds i8, ptr %4, i64 136
  %14 = load double, ptr %13, align 8
  %15 = fdiv double %12, %14
  store double %15, ptr %3, align 8
  %16 = fsub double %15, %15
  %17 = fcmp oeq double %16, 0.000000e+00
  ret i1 %17

18:                                               ; preds = %9, %32
  %19 = phi double [ 0.000000e+00, %9 ], [ %34, %32 ]
  %20 = phi i64 [ 0, %9 ], [ %35, %32 ]
  %21 = load ptr, ptr %10, align 8
  %22 = getelementptr inbounds %struct.Part, ptr %21, i64 %20
  %23 = getelementptr inbounds i8, ptr %22, i64 184
  %24 = load ptr, ptr %23, align 8
  %25 = tail call fastcc i32 @evaluated(ptr noundef %22, ptr noundef %1, ptr noundef %24) #4
  %26 = icmp eq i32 %25, 0
  br i1 %26, label %32, label %27

27:                                               ; preds = %18
  %28 = load ptr, ptr %23, align 8
  %29 = getelementptr inbounds i8, ptr %22, i64 88
  %30 = load i64, ptr %29, align 8
  %31 = tail call fastcc double @sum(ptr noundef %28, i64 noundef %30) #4
  br label %32

32:                                               ; preds = %18, %27
  %33 = phi double [ %31, %27 ], [ 0x7FF8000000000000, %18 ]
  %34 = fadd double %19, %33
  %35 = add nuw nsw i64 %20, 1
  %36 = load i64, ptr %6, align 8
  %37 = icmp slt i64 %35, %36
  br i1 %37, label %18, label %11, !llvm.loop !3
}


define internal fastcc range(i32 0, 2) i32 @evaluated(ptr noundef %0, ptr noundef readonly %1, ptr noundef %2) unnamed_addr #0 {
  %4 = getelementptr inbounds i8, ptr %0, i64 88
  %5 = load i64, ptr %4, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 272
  %7 = load i64, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %0, i64 200
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 32
  %11 = load i64, ptr %10, align 8
  %12 = mul nsw i64 %11, %5
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %14, label %21

14:                                               ; preds = %3
  %15 = getelementptr inbounds i8, ptr %0, i64 280
  %16 = getelementptr inbounds i8, ptr %0, i64 144
  %17 = getelementptr inbounds i8, ptr %0, i64 152
  %18 = getelementptr inbounds i8, ptr %0, i64 176
  %19 = icmp sgt i64 %7, 0
  %20 = icmp sgt i64 %7, 0
  br label %24

21:                                               ; preds = %63, %3
  %22 = getelementptr inbounds i8, ptr %0, i64 32
  %23 = icmp sgt i64 %5, 0
  br i1 %23, label %73, label %69

24:                                               ; preds = %14, %63
  %25 = phi i64 [ 0, %14 ], [ %65, %63 ]
  %26 = phi i64 [ 0, %14 ], [ %64, %63 ]
  %27 = load ptr, ptr %15, align 8
  %28 = getelementptr inbounds i64, ptr %27, i64 %26
  %29 = load i64, ptr %28, align 8
  %30 = load ptr, ptr %16, align 8
  %31 = getelementptr inbounds i64, ptr %30, i64 %25
  %32 = icmp slt i64 %29, 0
  %33 = tail call i64 @llvm.smax.i64(i64 %29, i64 0)
  %34 = getelementptr inbounds double, ptr %1, i64 %33
  %35 = load ptr, ptr %17, align 8
  %36 = getelementptr inbounds double, ptr %35, i64 %25
  %37 = load ptr, ptr %18, align 8
  %38 = getelementptr inbounds double, ptr %37, i64 %25
  br i1 %32, label %40, label %39

39:                                               ; preds = %24
  br i1 %19, label %53, label %63

40:                                               ; preds = %24
  br i1 %20, label %41, label %63

41:                                               ; preds = %40, %41
  %42 = phi i64 [ %51, %41 ], [ 0, %40 ]
  %43 = getelementptr inbounds i64, ptr %31, i64 %42
  %44 = load i64, ptr %43, align 8
  %45 = getelementptr inbounds double, ptr %34, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = getelementptr inbounds double, ptr %36, i64 %42
  %48 = load double, ptr %47, align 8
  %49 = fmul double %46, %48
  %50 = getelementptr inbounds double, ptr %38, i64 %42
  store double %49, ptr %50, align 8
  %51 = add nuw nsw i64 %42, 1
  %52 = icmp eq i64 %51, %7
  br i1 %52, label %63, label %41, !llvm.loop !6

53:                                               ; preds = %39, %53
  %54 = phi i64 [ %61, %53 ], [ 0, %39 ]
  %55 = getelementptr inbounds double, ptr %34, i64 %54
  %56 = load double, ptr %55, align 8
  %57 = getelementptr inbounds double, ptr %36, i64 %54
  %58 = load double, ptr %57, align 8
  %59 = fmul double %56, %58
  %60 = getelementptr inbounds double, ptr %38, i64 %54
  store double %59, ptr %60, align 8
  %61 = add nuw nsw i64 %54, 1
  %62 = icmp eq i64 %61, %7
  br i1 %62, label %63, label %53, !llvm.loop !8

63:                                               ; preds = %53, %41, %39, %40
  %64 = add nuw nsw i64 %26, 1
  %65 = mul nsw i64 %64, %7
  %66 = load i64, ptr %10, align 8
  %67 = mul nsw i64 %66, %5
  %68 = icmp slt i64 %65, %67
  br i1 %68, label %24, label %21, !llvm.loop !9

69:                                               ; preds = %73, %21
  %70 = getelementptr inbounds i8, ptr %0, i64 232
  %71 = load i64, ptr %70, align 8
  %72 = icmp eq i64 %71, 0
  br i1 %72, label %168, label %78

73:                                               ; preds = %21, %73
  %74 = phi i64 [ %76, %73 ], [ 0, %21 ]
  %75 = getelementptr inbounds i8, ptr %9, i64 %74
  store i8 0, ptr %75, align 1
  %76 = add nuw nsw i64 %74, 1
  %77 = icmp eq i64 %76, %5
  br i1 %77, label %69, label %73, !llvm.loop !10

78:                                               ; preds = %69
  %79 = load i64, ptr %4, align 8
  %80 = getelementptr inbounds i8, ptr %0, i64 168
  %81 = load ptr, ptr %80, align 8
  %82 = getelementptr inbounds i8, ptr %0, i64 48
  %83 = load i64, ptr %82, align 8
  %84 = getelementptr double, ptr %81, i64 %83
  %85 = getelementptr i8, ptr %84, i64 -8
  %86 = load double, ptr %85, align 8
  %87 = getelementptr inbounds i8, ptr %0, i64 176
  %88 = load ptr, ptr %87, align 8
  %89 = load i64, ptr %22, align 8
  %90 = add nsw i64 %89, -1
  %91 = mul nsw i64 %90, %79
  %92 = getelementptr inbounds double, ptr %88, i64 %91
  %93 = getelementptr inbounds i8, ptr %0, i64 160
  %94 = load ptr, ptr %93, align 8
  %95 = icmp sgt i64 %71, 0
  br i1 %95, label %96, label %168

96:                                               ; preds = %78
  %97 = getelementptr inbounds i8, ptr %0, i64 248
  %98 = getelementptr inbounds i8, ptr %0, i64 256
  %99 = getelementptr inbounds i8, ptr %0, i64 264
  %100 = getelementptr inbounds i8, ptr %0, i64 240
  %101 = icmp sgt i64 %79, 0
  br label %102

102:                                              ; preds = %126, %96
  %103 = phi i64 [ 0, %96 ], [ %127, %126 ]
  %104 = load ptr, ptr %97, align 8
  %105 = shl nsw i64 %103, 2
  %106 = or disjoint i64 %105, 1
  %107 = getelementptr inbounds i64, ptr %104, i64 %106
  %108 = load i64, ptr %107, align 8
  %109 = load ptr, ptr %98, align 8
  %110 = getelementptr inbounds double, ptr %109, i64 %108
  %111 = load ptr, ptr %99, align 8
  %112 = shl nsw i64 %108, 5
  %113 = getelementptr inbounds i8, ptr %111, i64 %112
  %114 = load ptr, ptr %93, align 8
  %115 = load i64, ptr %100, align 8
  %116 = mul nuw nsw i64 %103, 5
  %117 = add nsw i64 %115, %116
  %118 = mul nsw i64 %117, %79
  %119 = getelementptr inbounds double, ptr %114, i64 %118
  br i1 %101, label %120, label %126

120:                                              ; preds = %102
  %121 = or disjoint i64 %105, 2
  %122 = getelementptr inbounds i64, ptr %104, i64 %121
  %123 = load i64, ptr %122, align 8
  %124 = add nsw i64 %123, -1
  %125 = icmp sgt i64 %123, 2
  br label %130

126:                                              ; preds = %157, %102
  %127 = add nuw nsw i64 %103, 1
  %128 = load i64, ptr %70, align 8
  %129 = icmp slt i64 %127, %128
  br i1 %129, label %102, label %168, !llvm.loop !11

130:                                              ; preds = %157, %120
  %131 = phi i64 [ 0, %120 ], [ %158, %157 ]
  %132 = getelementptr inbounds double, ptr %92, i64 %131
  %133 = load double, ptr %132, align 8
  %134 = getelementptr inbounds double, ptr %94, i64 %131
  %135 = load double, ptr %134, align 8
  %136 = fmul double %133, %135
  %137 = fadd double %86, %136
  br i1 %125, label %138, label %150

138:                                              ; preds = %130, %138
  %139 = phi i64 [ %147, %138 ], [ %124, %130 ]
  %140 = phi i64 [ %146, %138 ], [ 0, %130 ]
  %141 = add nsw i64 %140, %139
  %142 = sdiv i64 %141, 2
  %143 = getelementptr inbounds double, ptr %110, i64 %142
  %144 = load double, ptr %143, align 8
  %145 = fcmp ugt double %144, %137
  %146 = select i1 %145, i64 %140, i64 %142
  %147 = select i1 %145, i64 %142, i64 %139
  %148 = sub nsw i64 %147, %146
  %149 = icmp sgt i64 %148, 1
  br i1 %149, label %138, label %150, !llvm.loop !12

150:                                              ; preds = %138, %130
  %151 = phi i64 [ 0, %130 ], [ %146, %138 ]
  %152 = getelementptr inbounds double, ptr %110, i64 %151
  %153 = load double, ptr %152, align 8
  %154 = getelementptr inbounds double, ptr %119, i64 %131
  store double %153, ptr %154, align 8
  %155 = shl i64 %151, 5
  %156 = getelementptr i8, ptr %113, i64 %155
  br label %160

157:                                              ; preds = %160
  %158 = add nuw nsw i64 %131, 1
  %159 = icmp eq i64 %158, %79
  br i1 %159, label %126, label %130, !llvm.loop !13

160:                                              ; preds = %160, %150
  %161 = phi i64 [ 0, %150 ], [ %164, %160 ]
  %162 = getelementptr double, ptr %156, i64 %161
  %163 = load double, ptr %162, align 8
  %164 = add nuw nsw i64 %161, 1
  %165 = mul nuw nsw i64 %164, %79
  %166 = getelementptr double, ptr %154, i64 %165
  store double %163, ptr %166, align 8
  %167 = icmp eq i64 %164, 4
  br i1 %167, label %157, label %160, !llvm.loop !14

168:                                              ; preds = %126, %78, %69
  %169 = getelementptr inbounds i8, ptr %0, i64 24
  %170 = load ptr, ptr %169, align 8
  %171 = getelementptr inbounds i8, ptr %0, i64 176
  %172 = load ptr, ptr %171, align 8
  %173 = getelementptr inbounds i8, ptr %0, i64 160
  %174 = load ptr, ptr %173, align 8
  %175 = getelementptr inbounds i8, ptr %0, i64 168
  %176 = load ptr, ptr %175, align 8
  %177 = load ptr, ptr %8, align 8
  %178 = getelementptr inbounds i8, ptr %0, i64 192
  %179 = load ptr, ptr %178, align 8
  %180 = tail call i64 %170(ptr noundef %0, ptr noundef %172, ptr noundef %172, ptr noundef %174, ptr noundef %176, ptr noundef %2, ptr noundef %177, ptr noundef %179) #5
  %181 = icmp sgt i64 %5, 0
  br i1 %181, label %187, label %185

182:                                              ; preds = %187
  %183 = icmp eq i32 %193, 0
  %184 = zext i1 %183 to i32
  br label %185

185:                                              ; preds = %182, %168
  %186 = phi i32 [ 1, %168 ], [ %184, %182 ]
  ret i32 %186

187:                                              ; preds = %168, %187
  %188 = phi i64 [ %194, %187 ], [ 0, %168 ]
  %189 = phi i32 [ %193, %187 ], [ 0, %168 ]
  %190 = getelementptr inbounds i8, ptr %9, i64 %188
  %191 = load i8, ptr %190, align 1
  %192 = zext i8 %191 to i32
  %193 = or i32 %189, %192
  %194 = add nuw nsw i64 %188, 1
  %195 = icmp eq i64 %194, %5
  br i1 %195, label %182, label %187, !llvm.loop !15
}

define internal fastcc double @sum(ptr noundef %0, i64 noundef %1) unnamed_addr #2 {
  %3 = alloca [8 x double], align 16
  %4 = icmp sgt i64 %1, 128
  br i1 %4, label %7, label %15

5:                                                ; preds = %81, %17, %19, %7
  %6 = phi double [ %14, %7 ], [ %82, %81 ], [ 0.000000e+00, %17 ], [ %24, %19 ]
  ret double %6

7:                                                ; preds = %2
  %8 = lshr i64 %1, 1
  %9 = and i64 %8, 4611686018427387896
  %10 = tail call fastcc double @sum(ptr noundef %0, i64 noundef %9) #4
  %11 = getelementptr inbounds double, ptr %0, i64 %9
  %12 = sub nsw i64 %1, %9
  %13 = tail call fastcc double @sum(ptr noundef %11, i64 noundef %12) #4
  %14 = fadd double %10, %13
  br label %5

15:                                               ; preds = %2
  %16 = icmp slt i64 %1, 8
  br i1 %16, label %17, label %27

17:                                               ; preds = %15
  %18 = icmp sgt i64 %1, 0
  br i1 %18, label %19, label %5

19:                                               ; preds = %17, %19
  %20 = phi i64 [ %25, %19 ], [ 0, %17 ]
  %21 = phi double [ %24, %19 ], [ 0.000000e+00, %17 ]
  %22 = getelementptr inbounds double, ptr %0, i64 %20
  %23 = load double, ptr %22, align 8
  %24 = fadd double %21, %23
  %25 = add nuw nsw i64 %20, 1
  %26 = icmp eq i64 %25, %1
  br i1 %26, label %5, label %19, !llvm.loop !16

27:                                               ; preds = %15
  br label %31

28:                                               ; preds = %31
  %29 = and i64 %1, 9223372036854775800
  %30 = icmp ugt i64 %29, 8
  br i1 %30, label %38, label %48

31:                                               ; preds = %27, %31
  %32 = phi i64 [ 0, %27 ], [ %36, %31 ]
  %33 = getelementptr inbounds double, ptr %0, i64 %32
  %34 = load double, ptr %33, align 8
  %35 = getelementptr inbounds [8 x double], ptr %3, i64 0, i64 %32
  store double %34, ptr %35, align 8
  %36 = add nuw nsw i64 %32, 1
  %37 = icmp eq i64 %36, 8
  br i1 %37, label %28, label %31, !llvm.loop !17

38:                                               ; preds = %28, %38
  %39 = phi i64 [ %46, %38 ], [ 8, %28 ]
  %40 = getelementptr inbounds double, ptr %0, i64 %39
  %41 = load double, ptr %40, align 8
  %42 = and i64 %39, 7
  %43 = getelementptr inbounds [8 x double], ptr %3, i64 0, i64 %42
  %44 = load double, ptr %43, align 8
  %45 = fadd double %41, %44
  store double %45, ptr %43, align 8
  %46 = add nuw nsw i64 %39, 1
  %47 = icmp eq i64 %46, %29
  br i1 %47, label %48, label %38, !llvm.loop !18

48:                                               ; preds = %38, %28
  %49 = phi i64 [ 8, %28 ], [ %46, %38 ]
  %50 = load double, ptr %3, align 16
  %51 = getelementptr inbounds i8, ptr %3, i64 8
  %52 = load double, ptr %51, align 8
  %53 = fadd double %50, %52
  %54 = getelementptr inbounds i8, ptr %3, i64 16
  %55 = load double, ptr %54, align 16
  %56 = getelementptr inbounds i8, ptr %3, i64 24
  %57 = load double, ptr %56, align 8
  %58 = fadd double %55, %57
  %59 = fadd double %53, %58
  %60 = getelementptr inbounds i8, ptr %3, i64 32
  %61 = load double, ptr %60, align 16
  %62 = getelementptr inbounds i8, ptr %3, i64 40
  %63 = load double, ptr %62, align 8
  %64 = fadd double %61, %63
  %65 = getelementptr inbounds i8, ptr %3, i64 48
  %66 = load double, ptr %65, align 16
  %67 = getelementptr inbounds i8, ptr %3, i64 56
  %68 = load double, ptr %67, align 8
  %69 = fadd double %66, %68
  %70 = fadd double %64, %69
  %71 = fadd double %59, %70
  %72 = icmp slt i64 %49, %1
  br i1 %72, label %73, label %81

73:                                               ; preds = %48, %73
  %74 = phi double [ %78, %73 ], [ %71, %48 ]
  %75 = phi i64 [ %79, %73 ], [ %49, %48 ]
  %76 = getelementptr inbounds double, ptr %0, i64 %75
  %77 = load double, ptr %76, align 8
  %78 = fadd double %74, %77
  %79 = add nuw nsw i64 %75, 1
  %80 = icmp eq i64 %79, %1
  br i1 %80, label %81, label %73, !llvm.loop !19

81:                                               ; preds = %73, %48
  %82 = phi double [ %71, %48 ], [ %78, %73 ]
  br label %5
}


define zeroext i1 @nlp_rows(i32 noundef %0, ptr noundef readonly %1, i1 noundef zeroext %2, i32 noundef %3, ptr noundef %4, ptr noundef readonly %5) #0 {
  %7 = getelementptr inbounds i8, ptr %5, i64 24
  %8 = load i64, ptr %7, align 8
  %9 = icmp sgt i64 %8, 0
  br i1 %9, label %10, label %29

10:                                               ; preds = %6
  %11 = getelementptr inbounds i8, ptr %5, i64 64
  br label %12

12:                                               ; preds = %12, %10
  %13 = phi i32 [ 1, %10 ], [ %19, %12 ]
  %14 = phi i64 [ 0, %10 ], [ %26, %12 ]
  %15 = phi ptr [ %4, %10 ], [ %25, %12 ]
  %16 = load ptr, ptr %11, align 8
  %17 = getelementptr inbounds %struct.Part, ptr %16, i64 %14
  %18 = tail call fastcc i32 @evaluated(ptr noundef %17, ptr noundef readonly %1, ptr noundef %15) #4
  %19 = and i32 %18, %13
  %20 = getelementptr inbounds i8, ptr %17, i64 64
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr inbounds i8, ptr %17, i64 88
  %23 = load i64, ptr %22, align 8
  %24 = mul nsw i64 %23, %21
  %25 = getelementptr inbounds double, ptr %15, i64 %24
  %26 = add nuw nsw i64 %14, 1
  %27 = load i64, ptr %7, align 8
  %28 = icmp slt i64 %26, %27
  br i1 %28, label %12, label %29, !llvm.loop !20

29:                                               ; preds = %12, %6
  %30 = phi i32 [ 1, %6 ], [ %19, %12 ]
  %31 = getelementptr inbounds i8, ptr %5, i64 96
  %32 = load ptr, ptr %31, align 8
  %33 = icmp sgt i32 %3, 0
  br i1 %33, label %34, label %36

34:                                               ; preds = %29
  %35 = zext nneg i32 %3 to i64
  br label %41

36:                                               ; preds = %41, %29
  %37 = icmp sgt i32 %3, 0
  br i1 %37, label %38, label %50

38:                                               ; preds = %36
  %39 = zext nneg i32 %3 to i64
  %40 = and i32 %30, 1
  br label %53

41:                                               ; preds = %34, %41
  %42 = phi i64 [ 0, %34 ], [ %48, %41 ]
  %43 = getelementptr inbounds double, ptr %32, i64 %42
  %44 = load double, ptr %43, align 8
  %45 = getelementptr inbounds double, ptr %4, i64 %42
  %46 = load double, ptr %45, align 8
  %47 = fdiv double %46, %44
  store double %47, ptr %45, align 8
  %48 = add nuw nsw i64 %42, 1
  %49 = icmp eq i64 %48, %35
  br i1 %49, label %36, label %41, !llvm.loop !21

50:                                               ; preds = %53, %36
  %51 = phi i32 [ %30, %36 ], [ %60, %53 ]
  %52 = icmp ne i32 %51, 0
  ret i1 %52

53:                                               ; preds = %38, %53
  %54 = phi i64 [ 0, %38 ], [ %61, %53 ]
  %55 = phi i32 [ %40, %38 ], [ %60, %53 ]
  %56 = getelementptr inbounds double, ptr %4, i64 %54
  %57 = load double, ptr %56, align 8
  %58 = fsub double %57, %57
  %59 = fcmp oeq double %58, 0.000000e+00
  %60 = select i1 %59, i32 %55, i32 0
  %61 = add nuw nsw i64 %54, 1
  %62 = icmp eq i64 %61, %39
  br i1 %62, label %50, label %53, !llvm.loop !22
}

define zeroext i1 @nlp_gradient(i32 noundef %0, ptr noundef readonly %1, i1 noundef zeroext %2, ptr noundef %3, ptr noundef readonly %4) #0 {
  %6 = getelementptr inbounds i8, ptr %4, i64 128
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i8, ptr %4, i64 104
  %9 = load ptr, ptr %8, align 8
  %10 = icmp sgt i32 %0, 0
  br i1 %10, label %11, label %13

11:                                               ; preds = %5
  %12 = zext nneg i32 %0 to i64
  br label %23

13:                                               ; preds = %23, %5
  %14 = getelementptr inbounds i8, ptr %4, i64 32
  %15 = load i64, ptr %14, align 8
  %16 = icmp sgt i64 %15, 0
  br i1 %16, label %17, label %30

17:                                               ; preds = %13
  %18 = getelementptr inbounds i8, ptr %4, i64 72
  %19 = icmp sgt i32 %0, 0
  %20 = icmp sgt i32 %0, 0
  %21 = zext nneg i32 %0 to i64
  %22 = zext nneg i32 %0 to i64
  br label %35

23:                                               ; preds = %11, %23
  %24 = phi i64 [ 0, %11 ], [ %26, %23 ]
  %25 = getelementptr inbounds double, ptr %3, i64 %24
  store double 0.000000e+00, ptr %25, align 8
  %26 = add nuw nsw i64 %24, 1
  %27 = icmp eq i64 %26, %12
  br i1 %27, label %13, label %23, !llvm.loop !23

28:                                               ; preds = %71
  %29 = icmp ne i32 %50, 0
  br label %30

30:                                               ; preds = %28, %13
  %31 = phi i1 [ true, %13 ], [ %29, %28 ]
  %32 = icmp sgt i32 %0, 0
  br i1 %32, label %33, label %84

33:                                               ; preds = %30
  %34 = zext nneg i32 %0 to i64
  br label %85

35:                                               ; preds = %17, %71
  %36 = phi i32 [ 1, %17 ], [ %50, %71 ]
  %37 = phi i64 [ 0, %17 ], [ %72, %71 ]
  %38 = load ptr, ptr %18, align 8
  %39 = getelementptr inbounds %struct.Part, ptr %38, i64 %37
  %40 = getelementptr inbounds i8, ptr %39, i64 64
  %41 = load i64, ptr %40, align 8
  %42 = getelementptr inbounds i8, ptr %39, i64 88
  %43 = load i64, ptr %42, align 8
  %44 = mul i64 %43, %41
  %45 = getelementptr inbounds i8, ptr %39, i64 208
  %46 = load ptr, ptr %45, align 8
  %47 = getelementptr inbounds i8, ptr %39, i64 184
  %48 = load ptr, ptr %47, align 8
  %49 = tail call fastcc i32 @evaluated(ptr noundef %39, ptr noundef %1, ptr noundef %48) #4
  %50 = and i32 %49, %36
  %51 = load ptr, ptr %47, align 8
  br i1 %19, label %54, label %52

52:                                               ; preds = %54, %35
  %53 = icmp sgt i64 %44, 0
  br i1 %53, label %60, label %59

54:                                               ; preds = %35, %54
  %55 = phi i64 [ %57, %54 ], [ 0, %35 ]
  %56 = getelementptr inbounds double, ptr %7, i64 %55
  store double 0.000000e+00, ptr %56, align 8
  %57 = add nuw nsw i64 %55, 1
  %58 = icmp eq i64 %57, %21
  br i1 %58, label %52, label %54, !llvm.loop !24

59:                                               ; preds = %60, %52
  br i1 %20, label %75, label %71

60:                                               ; preds = %52, %60
  %61 = phi i64 [ %69, %60 ], [ 0, %52 ]
  %62 = getelementptr inbounds double, ptr %51, i64 %61
  %63 = load double, ptr %62, align 8
  %64 = getelementptr inbounds i64, ptr %46, i64 %61
  %65 = load i64, ptr %64, align 8
  %66 = getelementptr inbounds double, ptr %7, i64 %65
  %67 = load double, ptr %66, align 8
  %68 = fadd double %63, %67
  store double %68, ptr %66, align 8
  %69 = add nuw nsw i64 %61, 1
  %70 = icmp eq i64 %69, %44
  br i1 %70, label %59, label %60, !llvm.loop !25

71:                                               ; preds = %75, %59
  %72 = add nuw nsw i64 %37, 1
  %73 = load i64, ptr %14, align 8
  %74 = icmp slt i64 %72, %73
  br i1 %74, label %35, label %28, !llvm.loop !26

75:                                               ; preds = %59, %75
  %76 = phi i64 [ %82, %75 ], [ 0, %59 ]
  %77 = getelementptr inbounds double, ptr %7, i64 %76
  %78 = load double, ptr %77, align 8
  %79 = getelementptr inbounds double, ptr %3, i64 %76
  %80 = load double, ptr %79, align 8
  %81 = fadd double %78, %80
  store double %81, ptr %79, align 8
  %82 = add nuw nsw i64 %76, 1
  %83 = icmp eq i64 %82, %22
  br i1 %83, label %71, label %75, !llvm.loop !27

84:                                               ; preds = %85, %30
  ret i1 %31

85:                                               ; preds = %33, %85
  %86 = phi i64 [ 0, %33 ], [ %92, %85 ]
  %87 = getelementptr inbounds double, ptr %9, i64 %86
  %88 = load double, ptr %87, align 8
  %89 = getelementptr inbounds double, ptr %3, i64 %86
  %90 = load double, ptr %89, align 8
  %91 = fmul double %88, %90
  store double %91, ptr %89, align 8
  %92 = add nuw nsw i64 %86, 1
  %93 = icmp eq i64 %92, %34
  br i1 %93, label %84, label %85, !llvm.loop !28
}

define zeroext i1 @nlp_jacobian(i32 noundef %0, ptr noundef readonly %1, i1 noundef zeroext %2, i32 noundef %3, i32 noundef %4, ptr noundef writeonly %5, ptr noundef writeonly %6, ptr noundef %7, ptr noundef readonly %8) #0 {
  %10 = icmp eq ptr %7, null
  br i1 %10, label %11, label %31

11:                                               ; preds = %9
  %12 = getelementptr inbounds i8, ptr %8, i64 176
  %13 = load i64, ptr %12, align 8
  %14 = icmp sgt i64 %13, 0
  br i1 %14, label %15, label %72

15:                                               ; preds = %11
  %16 = getelementptr inbounds i8, ptr %8, i64 144
  %17 = getelementptr inbounds i8, ptr %8, i64 152
  br label %18

18:                                               ; preds = %18, %15
  %19 = phi i64 [ 0, %15 ], [ %28, %18 ]
  %20 = load ptr, ptr %16, align 8
  %21 = getelementptr inbounds i32, ptr %20, i64 %19
  %22 = load i32, ptr %21, align 4
  %23 = getelementptr inbounds i32, ptr %5, i64 %19
  store i32 %22, ptr %23, align 4
  %24 = load ptr, ptr %17, align 8
  %25 = getelementptr inbounds i32, ptr %24, i64 %19
  %26 = load i32, ptr %25, align 4
  %27 = getelementptr inbounds i32, ptr %6, i64 %19
  store i32 %26, ptr %27, align 4
  %28 = add nuw nsw i64 %19, 1
  %29 = load i64, ptr %12, align 8
  %30 = icmp slt i64 %28, %29
  br i1 %30, label %18, label %72, !llvm.loop !29

31:                                               ; preds = %9
  %32 = getelementptr inbounds i8, ptr %8, i64 40
  %33 = load i64, ptr %32, align 8
  %34 = icmp sgt i64 %33, 0
  br i1 %34, label %35, label %56

35:                                               ; preds = %31
  %36 = getelementptr inbounds i8, ptr %8, i64 80
  br label %37

37:                                               ; preds = %37, %35
  %38 = phi i32 [ 1, %35 ], [ %44, %37 ]
  %39 = phi i64 [ 0, %35 ], [ %51, %37 ]
  %40 = phi ptr [ %7, %35 ], [ %50, %37 ]
  %41 = load ptr, ptr %36, align 8
  %42 = getelementptr inbounds %struct.Part, ptr %41, i64 %39
  %43 = tail call fastcc i32 @evaluated(ptr noundef %42, ptr noundef readonly %1, ptr noundef %40) #4
  %44 = and i32 %43, %38
  %45 = getelementptr inbounds i8, ptr %42, i64 64
  %46 = load i64, ptr %45, align 8
  %47 = getelementptr inbounds i8, ptr %42, i64 88
  %48 = load i64, ptr %47, align 8
  %49 = mul nsw i64 %48, %46
  %50 = getelementptr inbounds double, ptr %40, i64 %49
  %51 = add nuw nsw i64 %39, 1
  %52 = load i64, ptr %32, align 8
  %53 = icmp slt i64 %51, %52
  br i1 %53, label %37, label %54, !llvm.loop !20

54:                                               ; preds = %37
  %55 = icmp ne i32 %44, 0
  br label %56

56:                                               ; preds = %54, %31
  %57 = phi i1 [ true, %31 ], [ %55, %54 ]
  %58 = getelementptr inbounds i8, ptr %8, i64 112
  %59 = load ptr, ptr %58, align 8
  %60 = icmp sgt i32 %4, 0
  br i1 %60, label %61, label %72

61:                                               ; preds = %56
  %62 = zext nneg i32 %4 to i64
  br label %63

63:                                               ; preds = %61, %63
  %64 = phi i64 [ 0, %61 ], [ %70, %63 ]
  %65 = getelementptr inbounds double, ptr %59, i64 %64
  %66 = load double, ptr %65, align 8
  %67 = getelementptr inbounds double, ptr %7, i64 %64
  %68 = load double, ptr %67, align 8
  %69 = fmul double %66, %68
  store double %69, ptr %67, align 8
  %70 = add nuw nsw i64 %64, 1
  %71 = icmp eq i64 %70, %62
  br i1 %71, label %72, label %63, !llvm.loop !30

72:                                               ; preds = %63, %18, %56, %11
  %73 = phi i1 [ true, %11 ], [ %57, %56 ], [ true, %18 ], [ %57, %63 ]
  ret i1 %73
}

define zeroext i1 @nlp_hessian(i32 noundef %0, ptr noundef readonly %1, i1 noundef zeroext %2, double noundef %3, i32 noundef %4, ptr noundef readonly %5, i1 noundef zeroext %6, i32 noundef %7, ptr noundef writeonly %8, ptr noundef writeonly %9, ptr noundef %10, ptr noundef readonly %11) #0 {
  %13 = icmp eq ptr %10, null
  br i1 %13, label %22, label %14

14:                                               ; preds = %12
  %15 = getelementptr inbounds i8, ptr %11, i64 48
  %16 = load i64, ptr %15, align 8
  %17 = icmp sgt i64 %16, 0
  br i1 %17, label %18, label %42

18:                                               ; preds = %14
  %19 = getelementptr inbounds i8, ptr %11, i64 88
  %20 = getelementptr inbounds i8, ptr %11, i64 96
  %21 = getelementptr inbounds i8, ptr %11, i64 136
  br label %74

22:                                               ; preds = %12
  %23 = getelementptr inbounds i8, ptr %11, i64 184
  %24 = load i64, ptr %23, align 8
  %25 = icmp sgt i64 %24, 0
  br i1 %25, label %26, label %133

26:                                               ; preds = %22
  %27 = getelementptr inbounds i8, ptr %11, i64 160
  %28 = getelementptr inbounds i8, ptr %11, i64 168
  br label %29

29:                                               ; preds = %29, %26
  %30 = phi i64 [ 0, %26 ], [ %39, %29 ]
  %31 = load ptr, ptr %27, align 8
  %32 = getelementptr inbounds i32, ptr %31, i64 %30
  %33 = load i32, ptr %32, align 4
  %34 = getelementptr inbounds i32, ptr %8, i64 %30
  store i32 %33, ptr %34, align 4
  %35 = load ptr, ptr %28, align 8
  %36 = getelementptr inbounds i32, ptr %35, i64 %30
  %37 = load i32, ptr %36, align 4
  %38 = getelementptr inbounds i32, ptr %9, i64 %30
  store i32 %37, ptr %38, align 4
  %39 = add nuw nsw i64 %30, 1
  %40 = load i64, ptr %23, align 8
  %41 = icmp slt i64 %39, %40
  br i1 %41, label %29, label %133, !llvm.loop !29

42:                                               ; preds = %114, %14
  %43 = getelementptr inbounds i8, ptr %11, i64 48
  %44 = load i64, ptr %43, align 8
  %45 = icmp sgt i64 %44, 0
  br i1 %45, label %46, label %67

46:                                               ; preds = %42
  %47 = getelementptr inbounds i8, ptr %11, i64 88
  br label %48

48:                                               ; preds = %48, %46
  %49 = phi i32 [ 1, %46 ], [ %55, %48 ]
  %50 = phi i64 [ 0, %46 ], [ %62, %48 ]
  %51 = phi ptr [ %10, %46 ], [ %61, %48 ]
  %52 = load ptr, ptr %47, align 8
  %53 = getelementptr inbounds %struct.Part, ptr %52, i64 %50
  %54 = tail call fastcc i32 @evaluated(ptr noundef %53, ptr noundef readonly %1, ptr noundef %51) #4
  %55 = and i32 %54, %49
  %56 = getelementptr inbounds i8, ptr %53, i64 64
  %57 = load i64, ptr %56, align 8
  %58 = getelementptr inbounds i8, ptr %53, i64 88
  %59 = load i64, ptr %58, align 8
  %60 = mul nsw i64 %59, %57
  %61 = getelementptr inbounds double, ptr %51, i64 %60
  %62 = add nuw nsw i64 %50, 1
  %63 = load i64, ptr %43, align 8
  %64 = icmp slt i64 %62, %63
  br i1 %64, label %48, label %65, !llvm.loop !20

65:                                               ; preds = %48
  %66 = icmp ne i32 %55, 0
  br label %67

67:                                               ; preds = %65, %42
  %68 = phi i1 [ true, %42 ], [ %66, %65 ]
  %69 = getelementptr inbounds i8, ptr %11, i64 120
  %70 = load ptr, ptr %69, align 8
  %71 = icmp sgt i32 %7, 0
  br i1 %71, label %72, label %133

72:                                               ; preds = %67
  %73 = zext nneg i32 %7 to i64
  br label %124

74:                                               ; preds = %18, %114
  %75 = phi i64 [ 0, %18 ], [ %115, %114 ]
  %76 = phi i64 [ 0, %18 ], [ %116, %114 ]
  %77 = load ptr, ptr %19, align 8
  %78 = getelementptr inbounds %struct.Part, ptr %77, i64 %76
  %79 = getelementptr inbounds i8, ptr %78, i64 88
  %80 = load i64, ptr %79, align 8
  %81 = getelementptr inbounds i8, ptr %78, i64 216
  %82 = load i64, ptr %81, align 8
  %83 = mul nsw i64 %82, %80
  %84 = getelementptr inbounds i8, ptr %78, i64 224
  %85 = load i64, ptr %84, align 8
  %86 = add i64 %85, %82
  %87 = mul i64 %86, %80
  %88 = getelementptr inbounds i8, ptr %78, i64 160
  %89 = load ptr, ptr %88, align 8
  %90 = getelementptr inbounds i8, ptr %78, i64 40
  %91 = load i64, ptr %90, align 8
  %92 = mul nsw i64 %91, %80
  %93 = getelementptr inbounds double, ptr %89, i64 %92
  %94 = sub i64 0, %87
  %95 = getelementptr inbounds double, ptr %93, i64 %94
  %96 = getelementptr inbounds double, ptr %5, i64 %75
  %97 = load ptr, ptr %20, align 8
  %98 = getelementptr inbounds double, ptr %97, i64 %75
  %99 = load double, ptr %21, align 8
  %100 = fdiv double %3, %99
  %101 = icmp sgt i64 %83, 0
  br i1 %101, label %104, label %102

102:                                              ; preds = %104, %74
  %103 = icmp slt i64 %83, %87
  br i1 %103, label %119, label %114

104:                                              ; preds = %74, %104
  %105 = phi i64 [ %112, %104 ], [ 0, %74 ]
  %106 = getelementptr inbounds double, ptr %96, i64 %105
  %107 = load double, ptr %106, align 8
  %108 = getelementptr inbounds double, ptr %98, i64 %105
  %109 = load double, ptr %108, align 8
  %110 = fdiv double %107, %109
  %111 = getelementptr inbounds double, ptr %95, i64 %105
  store double %110, ptr %111, align 8
  %112 = add nuw nsw i64 %105, 1
  %113 = icmp eq i64 %112, %83
  br i1 %113, label %102, label %104, !llvm.loop !31

114:                                              ; preds = %119, %102
  %115 = add nsw i64 %83, %75
  %116 = add nuw nsw i64 %76, 1
  %117 = load i64, ptr %15, align 8
  %118 = icmp slt i64 %116, %117
  br i1 %118, label %74, label %42, !llvm.loop !32

119:                                              ; preds = %102, %119
  %120 = phi i64 [ %122, %119 ], [ %83, %102 ]
  %121 = getelementptr inbounds double, ptr %95, i64 %120
  store double %100, ptr %121, align 8
  %122 = add nsw i64 %120, 1
  %123 = icmp eq i64 %122, %87
  br i1 %123, label %114, label %119, !llvm.loop !33

124:                                              ; preds = %72, %124
  %125 = phi i64 [ 0, %72 ], [ %131, %124 ]
  %126 = getelementptr inbounds double, ptr %70, i64 %125
  %127 = load double, ptr %126, align 8
  %128 = getelementptr inbounds double, ptr %10, i64 %125
  %129 = load double, ptr %128, align 8
  %130 = fmul double %127, %129
  store double %130, ptr %128, align 8
  %131 = add nuw nsw i64 %125, 1
  %132 = icmp eq i64 %131, %73
  br i1 %132, label %133, label %124, !llvm.loop !34

133:                                              ; preds = %124, %29, %67, %22
  %134 = phi i1 [ true, %22 ], [ %68, %67 ], [ true, %29 ], [ %68, %124 ]
  ret i1 %134
}

declare i64 @llvm.smax.i64(i64, i64) #3

attributes #0 = { nounwind }
attributes #1 = { nounwind willreturn }
attributes #2 = { nounwind }
attributes #3 = { nounwind willreturn memory(none) }
attributes #4 = { nounwind }
attributes #5 = { nounwind }
attributes #6 = { nounwind }


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
!11 = distinct !{!11, !4, !5}
!12 = distinct !{!12, !4, !5}
!13 = distinct !{!13, !4, !5}
!14 = distinct !{!14, !4, !5}
!15 = distinct !{!15, !4, !5}
!16 = distinct !{!16, !4, !5}
!17 = distinct !{!17, !4, !5}
!18 = distinct !{!18, !4, !5}
!19 = distinct !{!19, !4, !5}
!20 = distinct !{!20, !4, !5}
!21 = distinct !{!21, !4, !5}
!22 = distinct !{!22, !4, !5}
!23 = distinct !{!23, !4, !5}
!24 = distinct !{!24, !4, !5}
!25 = distinct !{!25, !4, !5}
!26 = distinct !{!26, !4, !5}
!27 = distinct !{!27, !4, !5}
!28 = distinct !{!28, !4, !5}
!29 = distinct !{!29, !4, !5, !7}
!30 = distinct !{!30, !4, !5}
!31 = distinct !{!31, !4, !5}
!32 = distinct !{!32, !4, !5}
!33 = distinct !{!33, !4, !5}
!34 = distinct !{!34, !4, !5}
